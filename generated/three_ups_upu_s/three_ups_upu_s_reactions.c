/*
 * three_ups_upu_s: reactions.
 *   joint_reactions
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 minus_S_arm_y, upper_offset_x, signed_U_0_lever_mz_by_S_fz, t1, S_arm_x, t2,
      signed_limb1_U2_part_mn_by_P, minus_limb5_S_balance_wy_by_P, limb5_S_balance_wx_by_P, t3,
      signed_upper_rate_fz, signed_S_multiplier_fz, upper_rate_fx, minus_upper_rate_fy,
      minus_S_multiplier_fy, t4, t5, t6, t7, t8, lower_rate_fy_2, t9, minus_lower_rate_fx_2,
      minus_lower_sent_fx, signed_lower_rate_fz_2, upper_rate_mx, signed_lower_rate_my_2,
      signed_upper_rate_my_2, signed_lower_rotation_zx, signed_lower_rotation_yx, minus_upper_rate_mz_2,
      S_multiplier_fx, signed_S_reaction_fy, S_reaction_my, S_reaction_mx, signed_S_reaction_mz, t10, t11,
      checked;
} LIMBS(joint_reactions);

STAGE(joint_reactions, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, const double *restrict sine, const double *restrict cosine,
    LIMBS(joint_reactions) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = sign1 * param_R,
      sign2 = OF4(1.0, -1.0, -1.0, 1.0), each_gravity_z = sign2 * gravity_z,
      each_gravity_z_limb_lower_mx = sign2 * gravity_z_limb_lower_mx, each_gravity_z_2 = -sign2 * gravity_z,
      each_limb_lower_m_gravity_z = sign2 * limb_lower_m_gravity_z, each_k15 = sign1 * k15, each_k16 = sign1 * k16;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2), t46 = sign1 * lower_cos,
      signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: geometry; velocities, eq. (6) */
    OWN(signed_lower_rotation_yx) = signed_U_0_sin * t46;
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    OWN(signed_lower_rotation_zx) = U_0_cos * t46;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), signed_lower_omega_y = U_v_0 * t46,
      signed_lower_sin = IN_EACH4(SINES, sine, 1, 2), signed_lower_omega_x = U_v_0 * signed_lower_sin;
    /* each limb: accelerations; geometry; momentum rate, eq. (35) */
    const LIMB4 lower_U_still_xy = signed_lower_omega_x * signed_lower_omega_y, U_v_1 = IN_EACH4(READ, v, 1, 3),
      signed_lower_alpha_still_y = U_v_1 * signed_lower_omega_x, U_a_1 = IN_EACH4(READ, a, 1, 3),
      lower_U_yx = U_a_1 + lower_U_still_xy;
    OWN(upper_offset_x) = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    const LIMB4 t24 = OWN(upper_offset_x) * lower_U_yx, lower_rate_fy = limb_lower_mx * lower_U_yx,
      signed_U_0_acc_y = each_gravity_z_2 * U_0_cos, lower_acc_y = signed_lower_sin * signed_U_0_acc_y,
      t25 = t24 + lower_acc_y, minus_lower_acc_x = t46 * signed_U_0_acc_y, P_v = IN_EACH4(READ, v, 2, 3),
      upper_acc_y = P_v * (2.0 * U_v_1) + t25, minus_upper_rate_mz = limb_lower_mx * upper_acc_y;
    OWN(minus_upper_rate_fy) = lower_rate_fy - limb_lower_m * upper_acc_y;
    const LIMB4 t27 = minus_upper_rate_mz + OWN(upper_offset_x) * OWN(minus_upper_rate_fy),
      t28 = k9 * lower_U_still_xy;
    OWN(minus_upper_rate_mz_2) = minus_upper_rate_mz - (k19 * U_a_1 + k20 * lower_U_still_xy);
    const LIMB4 U_a_0 = IN_EACH4(READ, a, 0, 3), signed_lower_alpha_y = signed_lower_alpha_still_y - U_a_0 * t46,
      signed_lower_U_zx = signed_lower_alpha_still_y + signed_lower_alpha_y,
      t5 = OWN(upper_offset_x) * signed_lower_U_zx;
    /* each limb: momentum rate, eq. (35); accelerations; balance, eqs. (40)-(47) */
    const LIMB4 signed_lower_rate_fz = limb_lower_mx * signed_lower_U_zx,
      signed_upper_acc_z = P_v * (2.0 * signed_lower_omega_y) - (t5 + each_gravity_z * signed_U_0_sin),
      signed_upper_rate_my = limb_lower_mx * signed_upper_acc_z;
    OWN(signed_upper_rate_fz) = limb_lower_m * signed_upper_acc_z + signed_lower_rate_fz;
    const LIMB4 t8 = signed_upper_rate_my - OWN(upper_offset_x) * OWN(signed_upper_rate_fz),
      t10 = k9 * signed_lower_alpha_y, t42 = k17 * signed_lower_alpha_y + k18 * signed_lower_alpha_still_y;
    OWN(signed_upper_rate_my_2) = signed_upper_rate_my + t42;
    const LIMB4 t11 = k10 * signed_lower_alpha_still_y + t10,
      signed_upper_moment_y = each_gravity_z_limb_lower_mx * signed_U_0_sin;
    OWN(signed_lower_rate_my_2) = signed_upper_moment_y + t42;
    const LIMB4 t12 = t46 * (t8 + (signed_upper_moment_y + t11)),
      signed_lower_alpha_still_x = U_v_1 * signed_lower_omega_y, t19 = signed_lower_omega_y * signed_lower_omega_y,
      t38 = each_k15 * (signed_lower_alpha_still_x + U_a_0 * signed_lower_sin);
    OWN(upper_rate_mx) = t38 - each_k16 * signed_lower_alpha_still_x;
    const LIMB4 minus_lower_joint_force_my = t12 - signed_lower_sin * (k11 * signed_lower_alpha_still_x);
    OWN(signed_lower_rate_fz_2) = signed_lower_rate_fz + each_limb_lower_m_gravity_z * signed_U_0_sin;
    const LIMB4 minus_lower_U_still_xx = t19 + U_v_1 * U_v_1,
      minus_lower_rate_fx = limb_lower_mx * minus_lower_U_still_xx,
      minus_upper_acc_still_x_2 = OWN(upper_offset_x) * minus_lower_U_still_xx + minus_lower_acc_x;
    OWN(minus_lower_rate_fx_2) = minus_lower_rate_fx + limb_lower_m * minus_lower_acc_x;
    OWN(upper_rate_fx) = minus_lower_rate_fx + limb_lower_m * (IN_EACH4(READ, a, 2, 3) - minus_upper_acc_still_x_2);
    OWN(lower_rate_fy_2) = lower_rate_fy + limb_lower_m * lower_acc_y;
    const LIMB4 minus_upper_moment_z = limb_lower_mx * lower_acc_y,
      U_0_moment_z = k4 * U_a_0 - minus_lower_joint_force_my;
    OWN(signed_U_0_lever_mz_by_S_fz) = t46 * OWN(upper_offset_x);
    LIMB4 checked = OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(t1) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    /* each limb: balance, eqs. (40)-(47); rates that follow; reciprocal wrenches, eq. (10) */
    OWN(signed_S_multiplier_fz) = OWN(t1) * U_0_moment_z;
    OWN(t2) = t46 * OWN(t1);
    OWN(minus_S_arm_y) = each_param_R * lower_cos;
    const LIMB4 t21 = OWN(minus_S_arm_y) * OWN(upper_rate_fx),
      t13 = OWN(minus_S_arm_y) * OWN(signed_S_multiplier_fz), t36 = signed_lower_sin * t13, t14 = t46 * t13;
    OWN(S_arm_x) = OWN(upper_offset_x) - param_R * signed_lower_sin;
    const LIMB4 t15 = OWN(S_arm_x) * OWN(signed_S_multiplier_fz);
    OWN(t6) = t36 + t46 * t15;
    const LIMB4 t17 = t14 - signed_lower_sin * t15, t34 = signed_U_0_sin * t17, t18 = U_0_cos * t17;
    OWN(minus_S_multiplier_fy) = (t27 - (minus_upper_moment_z + (t28 + k10 * U_a_1))) * OWN(t2);
    const LIMB4 t32 = t21 - OWN(S_arm_x) * OWN(minus_S_multiplier_fy);
    OWN(t5) = t34 - U_0_cos * t32;
    OWN(t4) = t18 + signed_U_0_sin * t32;
    OWN(checked) = checked;
}

STAGE(joint_reactions, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, const EACH4 platform_joint_force_mx_by_limb1_U2_mn,
    const EACH4 platform_joint_force_mx_by_U2_mn, LIMBS(joint_reactions) *own)
{
    (void)limb, (void)stride;
    /* each limb: balance, eqs. (40)-(47); drives */
    OWN(signed_limb1_U2_part_mn_by_P) = IN_EACH4(SINES, sine, 0, 2) * OWN(minus_S_arm_y) * given;
    const LIMB4 t1 = GIVEN(platform_joint_force_mx_by_limb1_U2_mn) * OWN(signed_limb1_U2_part_mn_by_P);
    OWN(limb5_S_balance_wx_by_P) = GIVEN(platform_joint_force_mx_by_U2_mn) * OWN(signed_limb1_U2_part_mn_by_P);
    OWN(t8) = OWN(limb5_S_balance_wx_by_P) * OWN(limb5_S_balance_wx_by_P);
    OWN(minus_limb5_S_balance_wy_by_P) = IN_EACH4(SINES, cosine, 0, 2) * OWN(minus_S_arm_y) + t1;
    OWN(t3) = OWN(minus_limb5_S_balance_wy_by_P) * OWN(limb5_S_balance_wx_by_P);
    OWN(t7) = OWN(minus_limb5_S_balance_wy_by_P) * OWN(minus_limb5_S_balance_wy_by_P);
}

STAGE(joint_reactions, 2)(size_t limb, size_t stride, double *restrict u, const EACH4 given,
    const EACH4 given_2, LIMBS(joint_reactions) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0);
    /* each limb: drives; balance, eqs. (40)-(47) */
    const LIMB4 t1 = OWN(minus_limb5_S_balance_wy_by_P) * GIVEN(given),
      signed_P_drive = t1 + OWN(limb5_S_balance_wx_by_P) * GIVEN(given_2);
    WRITE4(u, 0, 1, 2, 3, -sign1 * signed_P_drive);
    OWN(t9) = OWN(signed_limb1_U2_part_mn_by_P) * signed_P_drive;
    const LIMB4 t3 = sign1 * signed_P_drive;
    OWN(minus_lower_sent_fx) = OWN(minus_lower_rate_fx_2) + t3;
    OWN(S_multiplier_fx) = OWN(upper_rate_fx) + t3;
}

STAGE(joint_reactions, 3)(size_t limb, size_t stride, double *restrict reactions, const double *restrict sine,
    const double *restrict cosine, const EACH4 minus_S_multiplier_fy, const EACH4 signed_S_multiplier_fz,
    const EACH4 upper_rate_mx, const EACH4 upper_rate_mx_2, const EACH4 minus_upper_rate_mz_2,
    LIMBS(joint_reactions) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), factor_2 = OF4(-1.0, -2.0, 2.0, 2.0),
      sign2 = OF4(1.0, -1.0, 1.0, 1.0), each_param_R = -sign2 * param_R, sign3 = OF4(1.0, -1.0, -1.0, 1.0),
      sign4 = OF4(1.0, -1.0, 1.0, -1.0), sign5 = OF4(1.0, 1.0, 1.0, -1.0);
    const LIMB4 t66 = sign1 * IN_EACH4(SINES, cosine, 1, 2), signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: balance, eqs. (40)-(47) */
    const LIMB4 t63 = t66 * OWN(S_multiplier_fx) + signed_lower_sin * GIVEN(minus_S_multiplier_fy),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), t65 = U_0_cos * t63,
      t64 = signed_U_0_sin * t63;
    /* each limb: reactions, eq. (32); balance, eqs. (40)-(47); geometry */
    const LIMB4 t51 = signed_U_0_sin * GIVEN(signed_S_multiplier_fz);
    OWN(t11) = t65 - t51;
    const LIMB4 t47 = U_0_cos * GIVEN(signed_S_multiplier_fz);
    OWN(t10) = t64 + t47;
    const LIMB4 signed_lower_rotation_yy = signed_U_0_sin * signed_lower_sin,
      t49 = signed_lower_rotation_yy * GIVEN(minus_S_multiplier_fy),
      signed_S_reaction_fx = t47 + (OWN(signed_lower_rotation_yx) * OWN(S_multiplier_fx) + t49);
    WRITE4(reactions, 13, 30, 49, 66, sign1 * signed_S_reaction_fx);
    const LIMB4 signed_upper_position_x = signed_lower_sin * OWN(upper_offset_x) + (-param_R),
      t60 = signed_upper_position_x * signed_S_reaction_fx;
    OWN(signed_S_reaction_fy) = signed_lower_sin * OWN(S_multiplier_fx) - t66 * GIVEN(minus_S_multiplier_fy);
    WRITE4(reactions, 12, 31, 48, 67, -sign1 * OWN(signed_S_reaction_fy));
    const LIMB4 signed_upper_position_y = OWN(upper_offset_x) * OWN(signed_lower_rotation_yx);
    OWN(signed_S_reaction_mz) = signed_upper_position_y * OWN(signed_S_reaction_fy) - t60;
    const LIMB4 signed_lower_rotation_zy = U_0_cos * signed_lower_sin,
      t53 = signed_lower_rotation_zy * GIVEN(minus_S_multiplier_fy),
      signed_S_reaction_fz = OWN(signed_lower_rotation_zx) * OWN(S_multiplier_fx) + t53 - t51;
    WRITE4(reactions, 14, 32, 50, 68, -sign3 * signed_S_reaction_fz);
    const LIMB4 t57 = signed_upper_position_x * signed_S_reaction_fz,
      t56 = signed_upper_position_y * signed_S_reaction_fz,
      signed_upper_position_z = OWN(upper_offset_x) * OWN(signed_lower_rotation_zx);
    OWN(S_reaction_mx) = t57 - signed_upper_position_z * OWN(signed_S_reaction_fy);
    OWN(S_reaction_my) = t56 - signed_upper_position_z * signed_S_reaction_fx;
    const LIMB4 upper_sent_fy = GIVEN(minus_S_multiplier_fy) - OWN(minus_upper_rate_fy),
      t20 = signed_lower_rotation_yy * upper_sent_fy, t33 = signed_lower_rotation_yy * OWN(signed_upper_rate_my_2),
      signed_upper_sent_fz = OWN(signed_upper_rate_fz) - GIVEN(signed_S_multiplier_fz),
      signed_P_reaction_fy = t20 - U_0_cos * signed_upper_sent_fz;
    WRITE4(reactions, 7, 24, 43, 60, sign1 * signed_P_reaction_fy);
    const LIMB4 t38 = signed_upper_position_x * signed_P_reaction_fy,
      t23 = signed_upper_position_z * signed_P_reaction_fy, signed_P_reaction_fx = t66 * upper_sent_fy;
    WRITE4(reactions, 6, 25, 42, 61, sign1 * signed_P_reaction_fx);
    const LIMB4 t29 = signed_upper_position_z * signed_P_reaction_fx,
      t39 = signed_upper_position_y * signed_P_reaction_fx + t38,
      t41 = signed_lower_rotation_zy * OWN(signed_upper_rate_my_2), t22 = signed_lower_rotation_zy * upper_sent_fy,
      lower_sent_fy = OWN(lower_rate_fy_2) + upper_sent_fy, t68 = sign1 * GIVEN(upper_rate_mx_2),
      signed_P_reaction_mz = t39 - (signed_U_0_sin * GIVEN(minus_upper_rate_mz_2) - (t41 +
          OWN(signed_lower_rotation_zx) * t68));
    WRITE4(reactions, 11, 29, 47, 65, sign4 * signed_P_reaction_mz);
    LIMB4 checked = OWN(checked) + signed_P_reaction_mz;
    const LIMB4 signed_P_reaction_fz = signed_U_0_sin * signed_upper_sent_fz + t22;
    WRITE4(reactions, 8, 26, 44, 62, -sign3 * signed_P_reaction_fz);
    const LIMB4 t31 = t29 + signed_upper_position_x * signed_P_reaction_fz,
      t25 = t23 - signed_upper_position_y * signed_P_reaction_fz, t27 = signed_lower_sin * t68,
      P_reaction_my = t31 - (U_0_cos * GIVEN(minus_upper_rate_mz_2) + (t33 + OWN(signed_lower_rotation_yx) * t68));
    WRITE4(reactions, 10, 27, 46, 63, P_reaction_my);
    checked = checked + P_reaction_my;
    const LIMB4 P_reaction_mx = t27 - t66 * OWN(signed_upper_rate_my_2) - t25;
    WRITE4(reactions, 9, 28, 45, 64, P_reaction_mx);
    checked = checked + P_reaction_mx;
    /* each limb: balance, eqs. (40)-(47); reactions, eq. (32) */
    const LIMB4 signed_lower_sent_my = OWN(upper_offset_x) * signed_upper_sent_fz - OWN(signed_upper_rate_my_2) -
        OWN(signed_lower_rate_my_2),
      signed_lower_sent_fz = OWN(signed_lower_rate_fz_2) - signed_upper_sent_fz,
      t15 = signed_lower_sin * signed_lower_sent_my, t12 = t66 * signed_lower_sent_my,
      signed_lower_sent_mx = factor_2 * GIVEN(upper_rate_mx),
      minus_lower_joint_sent_mx = t66 * signed_lower_sent_mx + t15,
      lower_joint_sent_my = t12 - signed_lower_sin * signed_lower_sent_mx;
    WRITE4(reactions, 3, 22, 39, 58, lower_joint_sent_my);
    checked = checked + lower_joint_sent_my;
    const LIMB4 t67 = sign2 * (U_0_cos * minus_lower_joint_sent_mx),
      t16 = signed_U_0_sin * minus_lower_joint_sent_mx, t1 = t66 * lower_sent_fy,
      signed_lower_joint_sent_fx = t66 * OWN(minus_lower_sent_fx) + signed_lower_sin * lower_sent_fy,
      t7 = U_0_cos * signed_lower_joint_sent_fx,
      signed_U_0_joint_sent_fx = signed_U_0_sin * signed_lower_joint_sent_fx + U_0_cos * signed_lower_sent_fz;
    WRITE4(reactions, 1, 18, 37, 54, sign1 * signed_U_0_joint_sent_fx);
    const LIMB4 signed_U_reaction_mz = each_param_R * signed_U_0_joint_sent_fx - t67;
    WRITE4(reactions, 5, 23, 41, 59, sign5 * signed_U_reaction_mz);
    checked = checked + signed_U_reaction_mz;
    const LIMB4 signed_U_0_joint_sent_fy = t7 - signed_U_0_sin * signed_lower_sent_fz;
    WRITE4(reactions, 2, 20, 38, 56, -sign3 * signed_U_0_joint_sent_fy);
    const LIMB4 U_reaction_my = (-param_R) * signed_U_0_joint_sent_fy + t16;
    WRITE4(reactions, 4, 21, 40, 57, U_reaction_my);
    checked = checked + U_reaction_my;
    const LIMB4 signed_lower_joint_sent_fy = t1 - signed_lower_sin * OWN(minus_lower_sent_fx);
    WRITE4(reactions, 0, 19, 36, 55, sign1 * signed_lower_joint_sent_fy);
    checked = checked + signed_lower_joint_sent_fy;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_joint_reactions)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u, double *restrict reactions, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    LIMBS(joint_reactions) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t54 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t54,
      platform_turn_xx = 1.0 - t6 * t9, t13 = limb5_S_q_qz * t9, t14 = limb5_S_q_qy * t13,
      t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t29 = limb5_S_q_qy * t9, platform_turn_zy = t14 + t16,
      platform_turn_yz = t14 - t16;
    /* limb1: geometry; reciprocal wrenches, eq. (10); balance, eqs. (40)-(47) */
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      limb1_lower_sin = SINES(sine, 1),
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    FIRST_LIMB(0, joint_reactions, 0, stride, q, v, a, sine, cosine, &limbs);
    const REAL minus_limb1_U_factor_0_by_3 = limb1_U_0_lever_mz_by_limb1_U2_mn * limbs.t1[0],
      t19 = limb1_U2_constraint_mn_couple_x - limbs.minus_S_arm_y[0] * minus_limb1_U_factor_0_by_3,
      limb1_lower_cos = SINES(cosine, 1), t20 = limb1_lower_cos * t19, t39 = limb1_lower_sin * t19,
      t21 = limbs.S_arm_x[0] * minus_limb1_U_factor_0_by_3, t23 = t20 + limb1_lower_sin * t21,
      platform_joint_force_mx_by_limb1_U2_mn = t39 - limb1_lower_cos * t21, t36 = limb1_U_0_cos * t23,
      t24 = limb1_U_0_sin * t23,
      t28 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy);
    /* platform: geometry; balance, eqs. (40)-(47); drives */
    const REAL t30 = limb5_S_q_qx * t29, t44 = limb5_S_q_qw * t29, t31 = limb5_S_q_qw * t13,
      t43 = limb5_S_q_qx * t13, platform_turn_xy = t30 - t31, platform_turn_yx = t30 + t31,
      limb1_U2_constraint_mn_couple_z = t28 - limb1_lower_sin * platform_turn_xy,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t2[0],
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      platform_joint_force_mz_by_limb1_U2_mn = t36 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    REAL checked0 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t38 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      t35 = t24 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const EACH4 platform_joint_force_mx_by_limb1_U2_mn_2 = {t35, platform_joint_force_mx_by_limb1_U2_mn, t35,
        platform_joint_force_mx_by_limb1_U2_mn},
      platform_joint_force_mx_by_U2_mn = {platform_joint_force_mx_by_limb1_U2_mn, t35,
          platform_joint_force_mx_by_limb1_U2_mn, t35};
    NEXT_LIMB(1, joint_reactions, 0, stride, q, v, a, sine, cosine, &limbs);
    FIRST_LIMB(1, joint_reactions, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2,
        platform_joint_force_mx_by_U2_mn, &limbs);
    NEXT_LIMB(0, joint_reactions, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2,
        platform_joint_force_mx_by_U2_mn, &limbs);
    const REAL t41 = limbs.t3[1] + limbs.t3[0];
    NEXT_LIMB(2, joint_reactions, 0, stride, q, v, a, sine, cosine, &limbs);
    NEXT_LIMB(2, joint_reactions, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2,
        platform_joint_force_mx_by_U2_mn, &limbs);
    const REAL t42 = limbs.t3[2] + t41;
    NEXT_LIMB(3, joint_reactions, 0, stride, q, v, a, sine, cosine, &limbs);
    NEXT_LIMB(3, joint_reactions, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2,
        platform_joint_force_mx_by_U2_mn, &limbs);
    const REAL minus_drives_share_0_1 = limbs.t3[3] + t42, t85 = minus_drives_share_0_1 * minus_drives_share_0_1,
      drives_share_1_1 = limbs.t8[3] + (limbs.t7[2] + (limbs.t8[1] + limbs.t7[0])),
      drives_share_0_0 = limbs.t7[3] + (limbs.t8[2] + (limbs.t7[1] + limbs.t8[0])),
      minus_determinant = t85 - drives_share_1_1 * drives_share_0_0;
    REAL checked1 = minus_determinant;
    const REAL t89 = 1.0 / minus_determinant, limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14),
      minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      platform_U_still_yz = limb5_S_v_wy * limb5_S_v_wz, limb5_S_a_wx = READ(a, 12),
      minus_platform_rate_fy = platform_mz * (limb5_S_a_wx - platform_U_still_yz),
      minus_platform_rate_mx = minus_platform_moment_x - (k13 * platform_U_still_yz + k14 * limb5_S_a_wx),
      platform_turn_zx = t43 - t44, platform_turn_xz = t43 + t44, limb5_S_v_wx = READ(v, 12),
      t48 = platform_turn_zx * minus_platform_rate_mx, platform_moment_y = gravity_z_platform_mz * platform_turn_zx,
      platform_U_still_xz = limb5_S_v_wx * limb5_S_v_wz, limb5_S_a_wy = READ(a, 13),
      platform_rate_fx = platform_mz * (limb5_S_a_wy + platform_U_still_xz),
      platform_rate_my = platform_moment_y - (k13 * platform_U_still_xz - k14 * limb5_S_a_wy);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35); drives */
    const REAL t53 = t48 - platform_turn_zy * platform_rate_my, platform_rate_mz = platform_Izz * READ(a, 14),
      minus_platform_joint_force_mz = limbs.t4[3] - (limbs.t4[2] - (limbs.t4[1] + (t53 - platform_turn_zz *
          platform_rate_mz - limbs.t4[0]))),
      limb1_U2_part_mn = t38 * minus_platform_joint_force_mz,
      t61 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn, t74 = t35 * limb1_U2_part_mn,
      t65 = platform_turn_xx * minus_platform_rate_mx - platform_turn_xy * platform_rate_my,
      t77 = platform_turn_yx * minus_platform_rate_mx - platform_turn_yy * platform_rate_my,
      minus_platform_joint_force_mx = limbs.t5[3] + (t65 - platform_turn_xz * platform_rate_mz - limbs.t6[0] +
          limbs.t5[1] - limbs.t6[2]),
      limb5_S_balance_wx = t61 - minus_platform_joint_force_mx,
      minus_platform_joint_force_my = limbs.t5[2] - (limbs.t6[1] - (t77 - platform_turn_yz * platform_rate_mz +
          limbs.t5[0])) - limbs.t6[3],
      minus_limb5_S_balance_wy = t74 + minus_platform_joint_force_my,
      t93 = minus_drives_share_0_1 * minus_limb5_S_balance_wy - drives_share_1_1 * limb5_S_balance_wx,
      t90 = (minus_drives_share_0_1 * limb5_S_balance_wx - drives_share_0_0 * minus_limb5_S_balance_wy) * t89,
      t94 = t89 * t93;
    const EACH4 given = {t90, t94, t90, t94}, given_2 = {t94, t90, t94, t90};
    FIRST_LIMB(0, joint_reactions, 2, stride, u, given, given_2, &limbs);
    NEXT_LIMB(1, joint_reactions, 2, stride, u, given, given_2, &limbs);
    NEXT_LIMB(2, joint_reactions, 2, stride, u, given, given_2, &limbs);
    NEXT_LIMB(3, joint_reactions, 2, stride, u, given, given_2, &limbs);
    const REAL minus_limb1_U2_multiplier_mn = limbs.t9[3] + (limbs.t9[2] + (limbs.t9[1] - (limb1_U2_part_mn -
        limbs.t9[0]))),
      limb1_U2_joint_reaction_mx = limb1_U2_constraint_mn_couple_x * minus_limb1_U2_multiplier_mn,
      limb1_U2_joint_reaction_mz = limb1_U2_constraint_mn_couple_z * minus_limb1_U2_multiplier_mn,
      limb1_upper_sent_mx = limbs.upper_rate_mx[0] + limb1_U2_joint_reaction_mx;
    const EACH4 upper_rate_mx = {limbs.upper_rate_mx[0] + limb1_upper_sent_mx, limbs.upper_rate_mx[1],
        limbs.upper_rate_mx[2], limbs.upper_rate_mx[3]},
      upper_rate_mx_2 = {limb1_upper_sent_mx, limbs.upper_rate_mx[1], limbs.upper_rate_mx[2],
          limbs.upper_rate_mx[3]};
    const REAL t98 = limb1_U2_part_mn - (limbs.t9[0] + (limbs.t9[1] + (limbs.t9[3] + limbs.t9[2]))), /* limb1 */
      t100 = minus_limb1_U_factor_0_by_3 * t98; /* limb1 */
    const EACH4 minus_S_multiplier_fy = {limbs.minus_S_multiplier_fy[0] + limb1_U_factor_1_by_3 * t98,
        limbs.minus_S_multiplier_fy[1], limbs.minus_S_multiplier_fy[2], limbs.minus_S_multiplier_fy[3]},
      signed_S_multiplier_fz = {limbs.signed_S_multiplier_fz[0] - t100, limbs.signed_S_multiplier_fz[1],
          limbs.signed_S_multiplier_fz[2], limbs.signed_S_multiplier_fz[3]},
      minus_upper_rate_mz_2 = {limbs.minus_upper_rate_mz_2[0] - limb1_U2_joint_reaction_mz,
          limbs.minus_upper_rate_mz_2[1], limbs.minus_upper_rate_mz_2[2], limbs.minus_upper_rate_mz_2[3]};
    FIRST_LIMB(2, joint_reactions, 3, stride, reactions, sine, cosine, minus_S_multiplier_fy,
        signed_S_multiplier_fz, upper_rate_mx, upper_rate_mx_2, minus_upper_rate_mz_2, &limbs);
    WRITE(reactions, 51, limbs.S_reaction_my[2]);
    REAL checked2 = limbs.S_reaction_my[2];
    WRITE(reactions, 52, limbs.S_reaction_mx[2]);
    REAL checked3 = limbs.S_reaction_mx[2];
    checked0 = checked0 + limbs.signed_S_reaction_mz[2];
    checked1 = checked1 + ALONE(limbs.checked[2]);
    NEXT_LIMB(1, joint_reactions, 3, stride, reactions, sine, cosine, minus_S_multiplier_fy, signed_S_multiplier_fz,
        upper_rate_mx, upper_rate_mx_2, minus_upper_rate_mz_2, &limbs);
    WRITE(reactions, 34, limbs.S_reaction_my[1]);
    checked2 = checked2 + limbs.S_reaction_my[1];
    WRITE(reactions, 33, limbs.S_reaction_mx[1]);
    checked3 = checked3 + limbs.S_reaction_mx[1];
    WRITE(reactions, 35, limbs.signed_S_reaction_mz[1]);
    checked0 = checked0 + limbs.signed_S_reaction_mz[1];
    checked1 = checked1 + ALONE(limbs.checked[1]);
    NEXT_LIMB(3, joint_reactions, 3, stride, reactions, sine, cosine, minus_S_multiplier_fy, signed_S_multiplier_fz,
        upper_rate_mx, upper_rate_mx_2, minus_upper_rate_mz_2, &limbs);
    WRITE(reactions, 70, limbs.S_reaction_my[3]);
    checked2 = checked2 + limbs.S_reaction_my[3];
    WRITE(reactions, 69, limbs.S_reaction_mx[3]);
    checked3 = checked3 + limbs.S_reaction_mx[3];
    WRITE(reactions, 71, limbs.signed_S_reaction_mz[3]);
    checked0 = checked0 + limbs.signed_S_reaction_mz[3];
    checked1 = checked1 + ALONE(limbs.checked[3]);
    NEXT_LIMB(0, joint_reactions, 3, stride, reactions, sine, cosine, minus_S_multiplier_fy, signed_S_multiplier_fz,
        upper_rate_mx, upper_rate_mx_2, minus_upper_rate_mz_2, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[0]);
    WRITE(reactions, 53, -limbs.signed_S_reaction_mz[2]);
    const REAL platform_rate_fx_2 = platform_rate_fx + platform_m_gravity_z * platform_turn_zx,
      t132 = platform_turn_zx * platform_rate_fx_2, t124 = platform_turn_yx * platform_rate_fx_2,
      t112 = platform_turn_xx * platform_rate_fx_2,
      minus_platform_rate_fy_2 = minus_platform_rate_fy - platform_m_gravity_z * platform_turn_zy,
      t134 = t132 - platform_turn_zy * minus_platform_rate_fy_2,
      t126 = t124 - platform_turn_yy * minus_platform_rate_fy_2,
      t115 = t112 - platform_turn_xy * minus_platform_rate_fy_2, t118 = platform_m_gravity_z * platform_turn_zz,
      minus_platform_rate_fz_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t118,
      t139 = t134 - platform_turn_zz * minus_platform_rate_fz_2 + limbs.t11[0] - limbs.t11[1] - limbs.t11[2];
    RESULT(checked3, reactions, 74, t139 + limbs.t11[3]);
    const REAL t120 = t115 - platform_turn_xz * minus_platform_rate_fz_2,
      t130 = limbs.signed_S_reaction_fy[1] + (t126 - platform_turn_yz * minus_platform_rate_fz_2 - limbs.t10[0]);
    RESULT(checked0, reactions, 73, limbs.t10[2] + t130 - limbs.signed_S_reaction_fy[3]);
    RESULT(checked1, reactions, 72, limbs.t10[3] - (limbs.signed_S_reaction_fy[2] + (limbs.t10[1] - (t120 +
        limbs.signed_S_reaction_fy[0]))));
    const REAL t108 = limb1_U_0_sin * limb1_U2_joint_reaction_mz, /* limb1 */
      t105 = limb1_U_0_cos * limb1_U2_joint_reaction_mz; /* limb1 */
    RESULT(checked2, reactions, 17, t108 + limbs.signed_lower_rotation_zx[0] * limb1_U2_joint_reaction_mx -
        limbs.signed_S_reaction_mz[0]);
    RESULT(checked3, reactions, 16, t105 - limbs.signed_lower_rotation_yx[0] * limb1_U2_joint_reaction_mx +
        limbs.S_reaction_mx[0]);
    RESULT(checked0, reactions, 15, limb1_lower_sin * limb1_U2_joint_reaction_mx + limbs.S_reaction_my[0]);
    WRITE(reactions, 75, CONSTANT(0.0));
    WRITE(reactions, 76, CONSTANT(0.0));
    WRITE(reactions, 77, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.signed_U_0_lever_mz_by_S_fz, 6.233100000000001e-10, 6.3211e-10, 6.4044e-10, 6.284e-10) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR
            /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10),
            /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_VECTORS)

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
#define THREE_UPS_UPU_S_VECTORS
#define THREE_UPS_UPU_S_LANES 4
#include "three_ups_upu_s_support.h" /* for all limbs at once */
#include "three_ups_upu_s_reactions.c"
#undef THREE_UPS_UPU_S_VECTORS
#undef THREE_UPS_UPU_S_LANES
#include "three_ups_upu_s_support.h" /* for one limb again */
#endif


#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_joint_reactions_limb_by_limb(const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u, double *restrict reactions)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_joint_reactions_body(1, q, v, a, u, reactions, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(u, 4);
        three_ups_upu_s_set_nan(reactions, 78);
    }
    return outcome;
}

int three_ups_upu_s_joint_reactions(const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u, double *restrict reactions)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    if (isfinite(three_ups_upu_s_joint_reactions_packed_lane(1, q, v, a, u, reactions, sine, cosine, NULL))) {
        return 0;
    }
#endif
    return three_ups_upu_s_joint_reactions_limb_by_limb(q, v, a, u, reactions);
}
#endif /* THREE_UPS_UPU_S_VECTORS */
