/*
 * three_ups_upu_s: inverse_dynamics.
 *   inverse_dynamics; inverse_dynamics_independent; inverse_dynamics_preload;
 *   inverse_dynamics_platform
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 minus_S_arm_y, signed_U_0_lever_mz_by_S_fz, t1, S_arm_x, t2, minus_limb5_S_balance_wy_by_P,
      limb5_S_balance_wx_by_P, t3, t4, t5, t6, t7, t8, checked;
} LIMBS(inverse_dynamics);

STAGE(inverse_dynamics, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, const double *restrict sine, const double *restrict cosine,
    LIMBS(inverse_dynamics) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = sign1 * param_R,
      sign2 = OF4(1.0, -1.0, -1.0, 1.0), each_gravity_z = sign2 * gravity_z,
      each_gravity_z_limb_lower_mx = sign2 * gravity_z_limb_lower_mx;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: velocities, eq. (6); accelerations; balance, eqs. (40)-(47) */
    const LIMB4 signed_lower_omega_x = U_v_0 * signed_lower_sin, U_v_1 = IN_EACH4(READ, v, 1, 3),
      signed_lower_alpha_still_y = U_v_1 * signed_lower_omega_x, lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t40 = sign1 * lower_cos, U_a_0 = IN_EACH4(READ, a, 0, 3),
      signed_lower_alpha_y = signed_lower_alpha_still_y - U_a_0 * t40,
      signed_lower_U_zx = signed_lower_alpha_still_y + signed_lower_alpha_y,
      t11 = k10 * signed_lower_alpha_still_y + k9 * signed_lower_alpha_y,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      signed_lower_rate_fz = limb_lower_mx * signed_lower_U_zx,
      t6 = upper_offset_x * signed_lower_U_zx + each_gravity_z * signed_U_0_sin, signed_lower_omega_y = U_v_0 * t40,
      lower_U_still_xy = signed_lower_omega_x * signed_lower_omega_y, P_v = IN_EACH4(READ, v, 2, 3),
      signed_upper_acc_z = P_v * (2.0 * signed_lower_omega_y) - t6,
      t7 = upper_offset_x * (limb_lower_m * signed_upper_acc_z + signed_lower_rate_fz),
      signed_lower_moment_y = limb_lower_mx * signed_upper_acc_z - t7 + (each_gravity_z_limb_lower_mx *
          signed_U_0_sin + t11),
      lower_joint_force_my = signed_lower_sin * (k11 * (U_v_1 * signed_lower_omega_y)) - t40 *
          signed_lower_moment_y,
      t19 = signed_lower_omega_y * signed_lower_omega_y, U_0_moment_z = lower_joint_force_my + k4 * U_a_0;
    OWN(signed_U_0_lever_mz_by_S_fz) = t40 * upper_offset_x;
    LIMB4 checked = OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(t1) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    /* each limb: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); accelerations */
    const LIMB4 signed_S_multiplier_fz = OWN(t1) * U_0_moment_z;
    OWN(t2) = t40 * OWN(t1);
    OWN(minus_S_arm_y) = each_param_R * lower_cos;
    const LIMB4 t13 = OWN(minus_S_arm_y) * signed_S_multiplier_fz, t38 = signed_lower_sin * t13, t14 = t40 * t13;
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    const LIMB4 t15 = OWN(S_arm_x) * signed_S_multiplier_fz;
    OWN(t8) = t38 + t40 * t15;
    const LIMB4 t17 = t14 - signed_lower_sin * t15, U_0_cos = IN_EACH4(SINES, cosine, 0, 2),
      U_a_1 = IN_EACH4(READ, a, 1, 3), t36 = signed_U_0_sin * t17, t18 = U_0_cos * t17,
      lower_U_yx = U_a_1 + lower_U_still_xy, t22 = k9 * lower_U_still_xy, t27 = upper_offset_x * lower_U_yx,
      lower_rate_fy = limb_lower_mx * lower_U_yx, signed_U_0_acc_y = each_gravity_z * U_0_cos,
      lower_acc_x = t40 * signed_U_0_acc_y, minus_lower_acc_y = signed_lower_sin * signed_U_0_acc_y,
      upper_acc_y = P_v * (2.0 * U_v_1) + (t27 - minus_lower_acc_y),
      t29 = upper_offset_x * (limb_lower_m * upper_acc_y - lower_rate_fy),
      lower_moment_z = t22 + k10 * U_a_1 + (t29 - limb_lower_mx * (minus_lower_acc_y + upper_acc_y)),
      t33 = OWN(S_arm_x) * (OWN(t2) * lower_moment_z), minus_lower_U_still_xx = t19 + U_v_1 * U_v_1,
      lower_force_x = limb_lower_m * (IN_EACH4(READ, a, 2, 3) - (upper_offset_x * minus_lower_U_still_xx -
          lower_acc_x)),
      t34 = OWN(minus_S_arm_y) * (limb_lower_mx * minus_lower_U_still_xx + lower_force_x) + t33;
    OWN(t7) = t36 - U_0_cos * t34;
    OWN(t6) = t18 + signed_U_0_sin * t34;
    OWN(checked) = checked;
}

STAGE(inverse_dynamics, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, const EACH4 platform_joint_force_mx_by_limb1_U2_mn,
    const EACH4 platform_joint_force_mx_by_U2_mn, LIMBS(inverse_dynamics) *own)
{
    (void)limb, (void)stride;
    /* each limb: balance, eqs. (40)-(47); drives */
    const LIMB4 signed_limb1_U2_part_mn_by_P = IN_EACH4(SINES, sine, 0, 2) * OWN(minus_S_arm_y) * given,
      t1 = GIVEN(platform_joint_force_mx_by_limb1_U2_mn) * signed_limb1_U2_part_mn_by_P;
    OWN(limb5_S_balance_wx_by_P) = GIVEN(platform_joint_force_mx_by_U2_mn) * signed_limb1_U2_part_mn_by_P;
    OWN(t4) = OWN(limb5_S_balance_wx_by_P) * OWN(limb5_S_balance_wx_by_P);
    OWN(minus_limb5_S_balance_wy_by_P) = IN_EACH4(SINES, cosine, 0, 2) * OWN(minus_S_arm_y) + t1;
    OWN(t3) = OWN(minus_limb5_S_balance_wy_by_P) * OWN(limb5_S_balance_wx_by_P);
    OWN(t5) = OWN(minus_limb5_S_balance_wy_by_P) * OWN(minus_limb5_S_balance_wy_by_P);
}

STAGE(inverse_dynamics, 2)(size_t limb, size_t stride, double *restrict u, const EACH4 given,
    const EACH4 given_2, LIMBS(inverse_dynamics) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0);
    /* each limb: drives */
    const LIMB4 t1 = OWN(minus_limb5_S_balance_wy_by_P) * GIVEN(given),
      signed_P_drive = t1 + OWN(limb5_S_balance_wx_by_P) * GIVEN(given_2);
    WRITE4(u, 0, 1, 2, 3, -sign1 * signed_P_drive);
    LIMB4 checked = OWN(checked) + signed_P_drive;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_inverse_dynamics)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    LIMBS(inverse_dynamics) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t61 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t61,
      platform_turn_xx = 1.0 - t6 * t9, t13 = limb5_S_q_qz * t9, t14 = limb5_S_q_qy * t13,
      t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t29 = limb5_S_q_qy * t9, platform_turn_zy = t14 + t16;
    /* limb1: geometry; reciprocal wrenches, eq. (10); balance, eqs. (40)-(47) */
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0), platform_turn_yz = t14 - t16,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      limb1_lower_sin = SINES(sine, 1),
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    FIRST_LIMB(0, inverse_dynamics, 0, stride, q, v, a, sine, cosine, &limbs);
    const REAL minus_limb1_U_factor_0_by_3 = limb1_U_0_lever_mz_by_limb1_U2_mn * limbs.t1[0],
      t19 = limb1_U2_constraint_mn_couple_x - limbs.minus_S_arm_y[0] * minus_limb1_U_factor_0_by_3,
      t21 = limbs.S_arm_x[0] * minus_limb1_U_factor_0_by_3, limb1_lower_cos = SINES(cosine, 1),
      t39 = limb1_lower_sin * t19, t23 = limb1_lower_cos * t19 + limb1_lower_sin * t21,
      platform_joint_force_mx_by_limb1_U2_mn = t39 - limb1_lower_cos * t21, t36 = limb1_U_0_cos * t23,
      t24 = limb1_U_0_sin * t23,
      t28 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy);
    /* limb5_S: geometry; balance, eqs. (40)-(47); drives */
    const REAL t30 = limb5_S_q_qx * t29, t51 = limb5_S_q_qw * t29, t31 = limb5_S_q_qw * t13,
      t50 = limb5_S_q_qx * t13, platform_turn_xy = t30 - t31, platform_turn_yx = t30 + t31,
      limb1_U2_constraint_mn_couple_z = t28 - limb1_lower_sin * platform_turn_xy,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] *
          (limb1_U2_constraint_mn_couple_z * limbs.t2[0]),
      platform_joint_force_mz_by_limb1_U2_mn = t36 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    REAL checked0 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t38 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      t35 = t24 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const EACH4 platform_joint_force_mx_by_limb1_U2_mn_2 = {t35, platform_joint_force_mx_by_limb1_U2_mn, t35,
        platform_joint_force_mx_by_limb1_U2_mn},
      platform_joint_force_mx_by_U2_mn = {platform_joint_force_mx_by_limb1_U2_mn, t35,
          platform_joint_force_mx_by_limb1_U2_mn, t35};
    NEXT_LIMB(1, inverse_dynamics, 0, stride, q, v, a, sine, cosine, &limbs);
    FIRST_LIMB(1, inverse_dynamics, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2,
        platform_joint_force_mx_by_U2_mn, &limbs);
    NEXT_LIMB(0, inverse_dynamics, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2,
        platform_joint_force_mx_by_U2_mn, &limbs);
    const REAL t41 = limbs.t3[1] + limbs.t3[0];
    NEXT_LIMB(2, inverse_dynamics, 0, stride, q, v, a, sine, cosine, &limbs);
    NEXT_LIMB(2, inverse_dynamics, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2,
        platform_joint_force_mx_by_U2_mn, &limbs);
    const REAL t42 = limbs.t3[2] + t41;
    NEXT_LIMB(3, inverse_dynamics, 0, stride, q, v, a, sine, cosine, &limbs);
    NEXT_LIMB(3, inverse_dynamics, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2,
        platform_joint_force_mx_by_U2_mn, &limbs);
    const REAL minus_drives_share_0_1 = limbs.t3[3] + t42, t43 = minus_drives_share_0_1 * minus_drives_share_0_1,
      drives_share_1_1 = limbs.t4[3] + (limbs.t5[2] + (limbs.t4[1] + limbs.t5[0])),
      drives_share_0_0 = limbs.t5[3] + (limbs.t4[2] + (limbs.t5[1] + limbs.t4[0])),
      minus_determinant = t43 - drives_share_1_1 * drives_share_0_0;
    REAL checked1 = minus_determinant;
    const REAL t49 = 1.0 / minus_determinant, limb5_S_v_wz = READ(v, 14);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35); drives */
    const REAL minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      minus_platform_rate_mx = minus_platform_moment_x - (k13 * (READ(v, 13) * limb5_S_v_wz) + k14 * READ(a, 12)),
      t70 = platform_turn_xx * minus_platform_rate_mx, t81 = platform_turn_yx * minus_platform_rate_mx,
      platform_turn_zx = t50 - t51, platform_turn_xz = t50 + t51, t55 = platform_turn_zx * minus_platform_rate_mx,
      platform_moment_y = gravity_z_platform_mz * platform_turn_zx,
      platform_rate_my = platform_moment_y - (k13 * (READ(v, 12) * limb5_S_v_wz) - k14 * READ(a, 13)),
      t60 = t55 - platform_turn_zy * platform_rate_my, t72 = t70 - platform_turn_xy * platform_rate_my,
      t83 = t81 - platform_turn_yy * platform_rate_my, platform_rate_mz = platform_Izz * READ(a, 14),
      minus_platform_joint_force_mz = limbs.t6[3] - (limbs.t6[2] - (limbs.t6[1] + (t60 - platform_turn_zz *
          platform_rate_mz - limbs.t6[0]))),
      limb1_U2_part_mn = t38 * minus_platform_joint_force_mz,
      t68 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn, t80 = t35 * limb1_U2_part_mn,
      t85 = t83 - platform_turn_yz * platform_rate_mz,
      t78 = limbs.t7[3] + (t72 - platform_turn_xz * platform_rate_mz - limbs.t8[0] + limbs.t7[1] - limbs.t8[2]),
      limb5_S_balance_wx = t68 - t78,
      minus_limb5_S_balance_wy = t80 + (limbs.t7[2] - (limbs.t8[1] - (t85 + limbs.t7[0])) - limbs.t8[3]),
      t95 = minus_drives_share_0_1 * minus_limb5_S_balance_wy - drives_share_1_1 * limb5_S_balance_wx,
      t92 = t49 * (minus_drives_share_0_1 * limb5_S_balance_wx - drives_share_0_0 * minus_limb5_S_balance_wy),
      t96 = t49 * t95;
    const EACH4 given = {t92, t96, t92, t96}, given_2 = {t96, t92, t96, t92};
    FIRST_LIMB(0, inverse_dynamics, 2, stride, u, given, given_2, &limbs);
    REAL checked2 = ALONE(limbs.checked[0]);
    NEXT_LIMB(1, inverse_dynamics, 2, stride, u, given, given_2, &limbs);
    REAL checked3 = ALONE(limbs.checked[1]);
    NEXT_LIMB(2, inverse_dynamics, 2, stride, u, given, given_2, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, inverse_dynamics, 2, stride, u, given, given_2, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
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

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 signed_S_arm_y, upper_offset_x, minus_U_0_lever_mz_by_S_fz, t1, S_arm_x, t2,
      signed_limb5_S_balance_wy_by_P, signed_limb5_S_balance_wx_by_P, t3, t4, t5, signed_upper_position_x,
      t6, signed_P_joint_rate, signed_U_joint_rate_1, t7, t8, t9, t10, t11, signed_lower_omega_y,
      minus_lower_omega_x, minus_lower_alpha_still_x, t12, t13, t14, t15, t16, t17, signed_upper_moment_y,
      signed_lower_alpha_still_y, t18, t19, signed_U_0_acc_x, minus_lower_U_still_xx, minus_U_0_acc_y,
      minus_upper_acc_still_x, t20, t21, upper_rate_fx, signed_lower_U_still_xy, t22, signed_lower_acc_y,
      t23, t24, t25, t26, checked;
} LIMBS(inverse_dynamics_independent);

STAGE(inverse_dynamics_independent, 0)(size_t limb, size_t stride, const double *restrict q,
    const double *restrict sine, const double *restrict cosine, LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, 1.0), each_param_R = -sign1 * param_R;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: reciprocal wrenches, eq. (10); geometry; rates that follow */
    OWN(signed_S_arm_y) = param_R * lower_cos;
    OWN(upper_offset_x) = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(S_arm_x) = OWN(upper_offset_x) - param_R * signed_lower_sin;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * OWN(upper_offset_x);
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = 1.0 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    OWN(signed_upper_position_x) = sign1 * signed_lower_sin * OWN(upper_offset_x) + each_param_R;
    OWN(checked) = checked;
}

STAGE(inverse_dynamics_independent, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, const EACH4 platform_joint_force_mx_by_limb1_U2_mn,
    const EACH4 platform_joint_force_mx_by_U2_mn, REAL given_2, const EACH4 given_3,
    REAL limb5_S_joint_rate_wz, const EACH4 signed_limb5_S_joint_rate_wy,
    LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      each_param_R = sign2 * param_R;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: velocities, eq. (6) */
    const LIMB4 t6 = signed_U_0_sin * limb5_S_joint_rate_wz + U_0_cos * GIVEN(signed_limb5_S_joint_rate_wy);
    OWN(signed_U_joint_rate_1) = OWN(t2) * (OWN(S_arm_x) * t6);
    OWN(signed_P_joint_rate) = OWN(signed_S_arm_y) * t6;
    const LIMB4 t22 = sign2 * OWN(signed_P_joint_rate);
    /* each limb: accelerations; balance, eqs. (40)-(47); drives */
    OWN(t8) = t22 * OWN(signed_U_joint_rate_1);
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2), t7 = lower_cos * OWN(signed_U_joint_rate_1),
      t19 = OWN(upper_offset_x) * t7, t9 = t22 - each_param_R * t7, t23 = sign2 * IN_EACH4(SINES, sine, 1, 2);
    OWN(t12) = t23 * OWN(signed_U_joint_rate_1);
    const LIMB4 t20 = t23 * t22 + t19;
    OWN(t13) = lower_cos * t22 - OWN(upper_offset_x) * OWN(t12);
    const LIMB4 t21 = sign1 * given_2, t2 = signed_U_0_sin * t21;
    OWN(t9) = U_0_cos * t21 - signed_U_0_sin * GIVEN(given_3);
    OWN(t15) = t20 * OWN(t9);
    const LIMB4 t15 = OWN(signed_upper_position_x) * (U_0_cos * limb5_S_joint_rate_wz - signed_U_0_sin *
        GIVEN(signed_limb5_S_joint_rate_wy));
    OWN(t10) = OWN(t1) * t15;
    OWN(t6) = t2 + U_0_cos * GIVEN(given_3);
    OWN(t7) = OWN(t6) * t9;
    const LIMB4 signed_limb1_U2_part_mn_by_P = signed_U_0_sin * OWN(signed_S_arm_y) * given,
      t1 = GIVEN(platform_joint_force_mx_by_limb1_U2_mn) * signed_limb1_U2_part_mn_by_P;
    OWN(signed_limb5_S_balance_wx_by_P) = GIVEN(platform_joint_force_mx_by_U2_mn) * signed_limb1_U2_part_mn_by_P;
    OWN(t4) = OWN(signed_limb5_S_balance_wx_by_P) * OWN(signed_limb5_S_balance_wx_by_P);
    OWN(signed_limb5_S_balance_wy_by_P) = U_0_cos * OWN(signed_S_arm_y) + t1;
    OWN(t3) = OWN(signed_limb5_S_balance_wy_by_P) * OWN(signed_limb5_S_balance_wx_by_P);
    OWN(t5) = OWN(signed_limb5_S_balance_wy_by_P) * OWN(signed_limb5_S_balance_wy_by_P);
}

STAGE(inverse_dynamics_independent, 2)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, const EACH4 signed_U_joint_rate_0, const EACH4 given,
    LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, 1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0),
      each_gravity_z = -sign2 * gravity_z;
    /* each limb: accelerations; velocities, eq. (6) */
    OWN(t11) = OWN(t9) * GIVEN(signed_U_joint_rate_0);
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    OWN(signed_lower_omega_y) = lower_cos * GIVEN(signed_U_joint_rate_0);
    OWN(minus_lower_alpha_still_x) = OWN(signed_U_joint_rate_1) * OWN(signed_lower_omega_y);
    const LIMB4 t3 = OWN(signed_lower_omega_y) * OWN(signed_lower_omega_y);
    OWN(minus_lower_U_still_xx) = OWN(signed_U_joint_rate_1) * OWN(signed_U_joint_rate_1) + t3;
    const LIMB4 minus_upper_acc_still_x = OWN(upper_offset_x) * OWN(minus_lower_U_still_xx);
    OWN(minus_U_0_acc_y) = each_gravity_z * IN_EACH4(SINES, cosine, 0, 2);
    OWN(minus_upper_acc_still_x) = lower_cos * OWN(minus_U_0_acc_y) + minus_upper_acc_still_x;
    OWN(t14) = OWN(t13) * (GIVEN(given) + sign2 * GIVEN(signed_U_joint_rate_0));
    OWN(minus_lower_omega_x) = sign1 * IN_EACH4(SINES, sine, 1, 2) * GIVEN(signed_U_joint_rate_0);
}

STAGE(inverse_dynamics_independent, 3)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, const EACH4 signed_limb5_S_joint_acc_wy,
    REAL limb5_S_joint_acc_still_wz, LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = sign1 * param_R,
      sign2 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    OWN(t16) = U_0_cos * given - signed_U_0_sin * GIVEN(signed_limb5_S_joint_acc_wy);
    OWN(t20) = signed_U_0_sin * given + U_0_cos * GIVEN(signed_limb5_S_joint_acc_wy);
    OWN(t21) = signed_U_0_sin * limb5_S_joint_acc_still_wz;
    const LIMB4 t11 = sign2 * (OWN(signed_S_arm_y) * (OWN(t11) - (OWN(t20) + OWN(t21)))),
      minus_lower_force_x = limb_lower_m * (OWN(minus_upper_acc_still_x) + (OWN(t6) * (each_param_R * OWN(t12)) +
          t11));
    OWN(upper_rate_fx) = limb_lower_mx * OWN(minus_lower_U_still_xx) - minus_lower_force_x;
}

STAGE(inverse_dynamics_independent, 4)(size_t limb, size_t stride, const double *restrict sine,
    LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: balance, eqs. (40)-(47); accelerations */
    OWN(signed_upper_moment_y) = gravity_z_limb_lower_mx * signed_U_0_sin;
    OWN(signed_U_0_acc_x) = gravity_z * signed_U_0_sin;
    const LIMB4 t3 = sign1 * IN_EACH4(SINES, sine, 1, 2);
    OWN(signed_lower_acc_y) = t3 * OWN(minus_U_0_acc_y);
    OWN(t17) = t3 * (k11 * OWN(minus_lower_alpha_still_x));
    OWN(signed_lower_alpha_still_y) = OWN(signed_U_joint_rate_1) * OWN(minus_lower_omega_x);
    OWN(t18) = k10 * OWN(signed_lower_alpha_still_y);
    const LIMB4 t4 = sign1 * OWN(signed_P_joint_rate);
    OWN(t19) = t4 * (2.0 * OWN(signed_lower_omega_y));
    OWN(t22) = t4 * (2.0 * OWN(signed_U_joint_rate_1));
    OWN(signed_lower_U_still_xy) = OWN(signed_lower_omega_y) * OWN(minus_lower_omega_x);
    OWN(t23) = k9 * OWN(signed_lower_U_still_xy);
}

STAGE(inverse_dynamics_independent, 5)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, const EACH4 given, const EACH4 signed_limb5_S_joint_acc_wx,
    const EACH4 given_2, LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_k4 = -sign1 * k4, sign2 = OF4(1.0, -1.0, -1.0, 1.0);
    /* each limb: accelerations; momentum rate, eq. (35) */
    const LIMB4 signed_U_joint_acc_0 = GIVEN(signed_limb5_S_joint_acc_wx) - OWN(t1) * (sign1 * GIVEN(given)),
      lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      signed_lower_alpha_y = lower_cos * signed_U_joint_acc_0 - OWN(signed_lower_alpha_still_y),
      signed_U_0_rate_mz = each_k4 * signed_U_joint_acc_0,
      signed_lower_U_zx = OWN(signed_lower_alpha_still_y) - signed_lower_alpha_y;
    /* each limb: balance, eqs. (40)-(47); accelerations */
    const LIMB4 t4 = OWN(signed_upper_moment_y) - (OWN(t18) - k9 * signed_lower_alpha_y),
      signed_upper_acc_z = OWN(t19) + (OWN(signed_U_0_acc_x) - OWN(upper_offset_x) * signed_lower_U_zx),
      t7 = OWN(upper_offset_x) * (limb_lower_mx * signed_lower_U_zx + limb_lower_m * signed_upper_acc_z),
      t34 = sign1 * (OWN(t17) + lower_cos * (t4 + (t7 - limb_lower_mx * signed_upper_acc_z))),
      signed_S_multiplier_fz = OWN(t1) * (signed_U_0_rate_mz - t34),
      t36 = sign2 * (OWN(signed_S_arm_y) * signed_S_multiplier_fz), t11 = OWN(S_arm_x) * signed_S_multiplier_fz,
      t14 = lower_cos * t36, t35 = sign2 * IN_EACH4(SINES, sine, 1, 2), t32 = t35 * t36, t15 = t35 * t11 - t14;
    OWN(t26) = lower_cos * t11 + t32;
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      t16 = U_0_cos * t15, t29 = signed_U_0_sin * t15, signed_U_joint_acc_1 = OWN(t2) * GIVEN(given_2),
      signed_lower_U_yx = OWN(signed_lower_U_still_xy) + signed_U_joint_acc_1,
      t24 = OWN(t23) + k10 * signed_U_joint_acc_1,
      signed_upper_acc_y = OWN(t22) + (OWN(signed_lower_acc_y) + OWN(upper_offset_x) * signed_lower_U_yx),
      t20 = OWN(upper_offset_x) * (limb_lower_mx * signed_lower_U_yx - limb_lower_m * signed_upper_acc_y),
      t26 = OWN(S_arm_x) * (OWN(t2) * (t20 - (limb_lower_mx * (OWN(signed_lower_acc_y) - signed_upper_acc_y) +
          t24))),
      t27 = OWN(signed_S_arm_y) * OWN(upper_rate_fx) - sign2 * t26;
    OWN(t24) = t16 - signed_U_0_sin * t27;
    OWN(t25) = t29 + U_0_cos * t27;
}

STAGE(inverse_dynamics_independent, 6)(size_t limb, size_t stride, double *restrict u, const EACH4 given,
    const EACH4 given_2, LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, 1.0);
    /* each limb: drives */
    const LIMB4 t1 = OWN(signed_limb5_S_balance_wy_by_P) * GIVEN(given),
      signed_P_drive = t1 + OWN(signed_limb5_S_balance_wx_by_P) * GIVEN(given_2);
    WRITE4(u, 0, 1, 2, 3, -sign1 * signed_P_drive);
    LIMB4 checked = OWN(checked) + signed_P_drive;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_inverse_dynamics_independent)(size_t stride, const double *restrict q,
    const double *restrict y_dot, const double *restrict y_ddot, double *restrict u,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(inverse_dynamics_independent) limbs;
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t10 = t2 + t5,
      t72 = t2 + t4, t9 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t9 * t10, t51 = k2 - 0.5 * t7,
      platform_turn_xx = 1.0 - t6 * t9, platform_turn_zz = 1.0 - t9 * t72, t13 = limb5_S_q_qz * t9,
      t14 = limb5_S_q_qy * t13, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t29 = limb5_S_q_qy * t9,
      platform_turn_zy = t14 + t16, platform_turn_yz = t14 - t16, limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_sin = SINES(sine, 0),
      t27 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t28 = limb1_lower_cos * t27, /* limb1 */
      t139 = limb1_lower_sin * t27, /* limb1 */
      t30 = limb5_S_q_qx * t29, t81 = limb5_S_q_qw * t29, t31 = limb5_S_q_qw * t13, t80 = limb5_S_q_qx * t13,
      platform_turn_xy = t30 - t31, platform_turn_yx = t30 + t31;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; balance, eqs. (40)-(47) */
    const REAL limb1_U2_constraint_mn_couple_z = t28 - limb1_lower_sin * platform_turn_xy;
    FIRST_LIMB(0, inverse_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t2[0],
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      t37 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t34 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      t55 = limbs.signed_upper_position_x[0] * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x + t55;
    /* limb5_S: pivots; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t37;
    REAL checked0 = minus_limb5_S_pivot_wz;
    const REAL t57 = 1.0 / minus_limb5_S_pivot_wz,
      t59 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t34, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t57 * t59;
    /* platform: velocities, eq. (6); accelerations; balance, eqs. (40)-(47) */
    const REAL t54 = limb5_S_q_qy * t51, t60 = t54 * limb5_S_null_space_wz_by_limb5_S_wy, t52 = limb5_S_q_qz * t51,
      t62 = 0.5 * (t52 - t60), t53 = 0.5 * t52, t63 = t53 * t62, t66 = limb5_S_q_qx * t51,
      t67 = t66 * limb5_S_null_space_wz_by_limb5_S_wy, t64 = limb5_S_q_qw * t51, t69 = 0.5 * (t64 + t67),
      t65 = 0.5 * t64, a_pivot = t63 + t65 * t69;
    REAL checked1 = a_pivot;
    const REAL t71 = 1.0 / a_pivot, limb5_S_y_dot_qy = READ(y_dot, 1), limb5_S_y_dot_qx = READ(y_dot, 0),
      limb5_S_joint_rate_wy = (t65 * limb5_S_y_dot_qy + t53 * limb5_S_y_dot_qx) * t71,
      limb5_S_joint_rate_wz = t57 * (t59 * limb5_S_joint_rate_wy), t88 = platform_turn_zy * limb5_S_joint_rate_wz,
      t89 = platform_turn_yy * limb5_S_joint_rate_wy,
      minus_limb5_S_joint_rate_wx = t71 * (limb5_S_y_dot_qy * t62 - limb5_S_y_dot_qx * t69),
      platform_omega_y = t88 + (t89 - platform_turn_xy * minus_limb5_S_joint_rate_wx),
      t110 = platform_turn_yy * platform_omega_y, platform_turn_zx = t80 - t81, platform_turn_xz = t80 + t81,
      t93 = platform_turn_zx * limb5_S_joint_rate_wz,
      platform_omega_x = t93 + (platform_turn_yx * limb5_S_joint_rate_wy - platform_turn_xx *
          minus_limb5_S_joint_rate_wx),
      t112 = t110 + platform_turn_yx * platform_omega_x, t78 = platform_turn_zz * limb5_S_joint_rate_wz,
      platform_omega_z = t78 + (platform_turn_yz * limb5_S_joint_rate_wy - platform_turn_xz *
          minus_limb5_S_joint_rate_wx),
      t113 = platform_turn_yz * platform_omega_z + t112,
      t104 = platform_turn_xy * platform_omega_y + platform_turn_xx * platform_omega_x,
      t105 = platform_turn_xz * platform_omega_z + t104;
    const EACH4 given_3 = {t113, t105, t113, t105};
    const REAL t266 = k13 * (platform_omega_z * platform_omega_y),
      t99 = platform_turn_zy * platform_omega_y + platform_turn_zx * platform_omega_x,
      platform_U_still_xz = platform_omega_z * platform_omega_x, t100 = platform_turn_zz * platform_omega_z + t99,
      t258 = k13 * platform_U_still_xz;
    const EACH4 signed_limb5_S_joint_rate_wy = {limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx,
        limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx};
    const REAL t19 = limb1_U2_constraint_mn_couple_x - limbs.signed_S_arm_y[0] * minus_limb1_U_factor_0_by_3,
        /* limb1 */
      t20 = limb1_lower_cos * t19, /* limb1 */
      t39 = limb1_lower_sin * t19, /* limb1 */
      t21 = limbs.S_arm_x[0] * minus_limb1_U_factor_0_by_3, /* limb1 */
      t23 = t20 + limb1_lower_sin * t21, /* limb1 */
      platform_joint_force_mx_by_limb1_U2_mn = t39 - limb1_lower_cos * t21,
      platform_joint_force_mz_by_limb1_U2_mn = limb1_U_0_cos * t23 + t37;
    REAL checked2 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t38 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn, t35 = limb1_U_0_sin * t23 - t34;
    const EACH4 platform_joint_force_mx_by_limb1_U2_mn_2 = {t35, platform_joint_force_mx_by_limb1_U2_mn, t35,
        platform_joint_force_mx_by_limb1_U2_mn},
      platform_joint_force_mx_by_U2_mn = {platform_joint_force_mx_by_limb1_U2_mn, t35,
          platform_joint_force_mx_by_limb1_U2_mn, t35};
    FIRST_LIMB(0, inverse_dynamics_independent, 1, stride, sine, cosine, t38,
        platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, t100, given_3,
        limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, &limbs);
    const REAL minus_limb1_U_joint_rate_0 = minus_limb5_S_joint_rate_wx + limbs.t10[0];
    NEXT_LIMB(1, inverse_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(1, inverse_dynamics_independent, 1, stride, sine, cosine, t38,
        platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, t100, given_3,
        limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, &limbs);
    const REAL limb2_U_joint_rate_0 = limb5_S_joint_rate_wy - limbs.t10[1];
    NEXT_LIMB(2, inverse_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(2, inverse_dynamics_independent, 1, stride, sine, cosine, t38,
        platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, t100, given_3,
        limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, &limbs);
    const REAL minus_limb3_U_joint_rate_0 = minus_limb5_S_joint_rate_wx + limbs.t10[2];
    NEXT_LIMB(3, inverse_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(3, inverse_dynamics_independent, 1, stride, sine, cosine, t38,
        platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, t100, given_3,
        limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, &limbs);
    const REAL limb4_U_joint_rate_0 = limb5_S_joint_rate_wy - limbs.t10[3];
    const EACH4 signed_U_joint_rate_0 = {minus_limb1_U_joint_rate_0, limb2_U_joint_rate_0,
        minus_limb3_U_joint_rate_0, limb4_U_joint_rate_0};
    const REAL t171 = limbs.t15[0] + limbs.signed_upper_position_x[0] * (minus_limb1_U_joint_rate_0 * limbs.t6[0]),
      t216 = limb2_U_joint_rate_0 * limbs.t6[1], /* limb2 */
      t224 = minus_limb3_U_joint_rate_0 * limbs.t6[2], /* limb3 */
      t203 = limb4_U_joint_rate_0 * limbs.t6[3]; /* limb4 */
    const EACH4 given = {t105, t113, t105, t113};
    FIRST_LIMB(0, inverse_dynamics_independent, 2, stride, sine, cosine, signed_U_joint_rate_0, given, &limbs);
    const REAL t172 = limbs.t14[0] - t171, t173 = minus_limb1_U_factor_0_by_3 * t172;
    /* limb1: loop closure */
    const REAL t145 = limb1_lower_cos * t105 - limb1_lower_sin * limbs.t9[0] + limbs.signed_lower_omega_y[0],
      t162 = limbs.signed_U_joint_rate_1[0] * t145, t138 = limbs.signed_U_joint_rate_1[0] - limbs.t6[0],
      t166 = limb1_U2_constraint_mn_couple_x * (t162 - t138 * limbs.signed_lower_omega_y[0] +
          limbs.minus_lower_alpha_still_x[0]),
      t146 = limb1_U2_constraint_mn_couple_x * t145,
      t152 = limb1_lower_sin * t105 + limb1_lower_cos * limbs.t9[0] + limbs.minus_lower_omega_x[0],
      t161 = limb1_U2_constraint_mn_couple_z * (limbs.signed_lower_omega_y[0] * t152 - t145 *
          limbs.minus_lower_omega_x[0]),
      t167 = t161 - t166, t153 = limb1_U2_constraint_mn_couple_z * t145,
      limb1_U2_opening_mn = t139 + limb1_lower_cos * platform_turn_xy,
      t148 = t138 * (limb1_U2_opening_mn * t138 + t146),
      minus_limb1_U2_opening_bias_mn = t148 + t152 * (t153 + limb1_U2_opening_mn * t152) - t167;
    /* limb5_S: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL t136 = limbs.t7[0] - (limbs.t8[0] + limbs.S_arm_x[0] * limbs.t11[0]),
      limb5_S_joint_acc_still_wz = t57 * (limb1_U_factor_1_by_3 * t136 - minus_limb1_U2_opening_bias_mn + t173),
      t175 = t54 * limb5_S_joint_acc_still_wz, t116 = 0.5 * (t52 * t105 - t66 * t100 - t64 * t113),
      t117 = t100 * t116, t123 = 0.5 * (t66 * t113 - t54 * t105 - t64 * t100), t184 = t64 * t105,
      t125 = t117 - t113 * t123, t180 = t105 * t123, t181 = t54 * t100, t191 = t66 * limb5_S_joint_acc_still_wz,
      t131 = 0.5 * (t52 * t100 + (t54 * t113 + t66 * t105)),
      t178 = READ(y_ddot, 0) - 0.5 * (t125 - t105 * t131 - t175), t179 = t53 * t178, t200 = t69 * t178,
      t189 = t113 * t131, t188 = t180 - t100 * (0.5 * (t181 - t52 * t113 - t184)),
      t194 = READ(y_ddot, 1) - 0.5 * (t188 - t189 + t191), t201 = t62 * t194 - t200,
      limb5_S_joint_acc_wy = t71 * (t179 + t65 * t194), minus_limb5_S_joint_acc_wx = t71 * t201,
      t198 = t57 * (t59 * limb5_S_joint_acc_wy), limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz + t198,
      t259 = platform_turn_zy * limb5_S_joint_acc_wz,
      platform_alpha_y = t259 + (platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy *
          minus_limb5_S_joint_acc_wx),
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (t258 - k14 * platform_alpha_y),
      t281 = platform_turn_xy * platform_rate_my, t292 = platform_turn_yy * platform_rate_my,
      t265 = platform_turn_zy * platform_rate_my, minus_platform_moment_x = gravity_z_platform_mz *
          platform_turn_zy,
      t267 = platform_turn_zx * limb5_S_joint_acc_wz, t253 = platform_turn_zz * limb5_S_joint_acc_wz,
      platform_alpha_x = t267 + (platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx *
          minus_limb5_S_joint_acc_wx),
      minus_platform_rate_mx = minus_platform_moment_x - (t266 + k14 * platform_alpha_x),
      t274 = t265 - platform_turn_zx * minus_platform_rate_mx,
      t283 = t281 - platform_turn_xx * minus_platform_rate_mx,
      t294 = t292 - platform_turn_yx * minus_platform_rate_mx,
      platform_alpha_z = t253 + (platform_turn_yz * limb5_S_joint_acc_wy - platform_turn_xz *
          minus_limb5_S_joint_acc_wx),
      platform_rate_mz = platform_Izz * platform_alpha_z, t275 = platform_turn_zz * platform_rate_mz + t274,
      t284 = platform_turn_xz * platform_rate_mz + t283, t295 = platform_turn_yz * platform_rate_mz + t294;
    const EACH4 signed_limb5_S_joint_acc_wy = {limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx,
        limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx},
      signed_limb5_S_joint_acc_wx = {minus_limb5_S_joint_acc_wx, limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx,
          limb5_S_joint_acc_wy};
    NEXT_LIMB(1, inverse_dynamics_independent, 2, stride, sine, cosine, signed_U_joint_rate_0, given, &limbs);
    FIRST_LIMB(1, inverse_dynamics_independent, 3, stride, sine, cosine, t198, signed_limb5_S_joint_acc_wy,
        limb5_S_joint_acc_still_wz, &limbs);
    const REAL t245 = limbs.S_arm_x[1] * (limbs.t21[1] - limbs.t11[1]) - (limbs.t7[1] + limbs.t8[1]), /* limb2 */
      t246 = limbs.S_arm_x[1] * limbs.t20[1] + t245; /* limb2 */
    NEXT_LIMB(2, inverse_dynamics_independent, 2, stride, sine, cosine, signed_U_joint_rate_0, given, &limbs);
    NEXT_LIMB(3, inverse_dynamics_independent, 2, stride, sine, cosine, signed_U_joint_rate_0, given, &limbs);
    NEXT_LIMB(2, inverse_dynamics_independent, 3, stride, sine, cosine, t198, signed_limb5_S_joint_acc_wy,
        limb5_S_joint_acc_still_wz, &limbs);
    const REAL t251 = limbs.S_arm_x[2] * (limbs.t11[2] - limbs.t21[2]) + (limbs.t8[2] - limbs.t7[2]), /* limb3 */
      t252 = limbs.S_arm_x[2] * limbs.t20[2] - t251; /* limb3 */
    NEXT_LIMB(3, inverse_dynamics_independent, 3, stride, sine, cosine, t198, signed_limb5_S_joint_acc_wy,
        limb5_S_joint_acc_still_wz, &limbs);
    NEXT_LIMB(0, inverse_dynamics_independent, 3, stride, sine, cosine, t198, signed_limb5_S_joint_acc_wy,
        limb5_S_joint_acc_still_wz, &limbs);
    FIRST_LIMB(0, inverse_dynamics_independent, 4, stride, sine, &limbs);
    const REAL t235 = limbs.S_arm_x[3] * (limbs.t21[3] - limbs.t11[3]) - (limbs.t7[3] + limbs.t8[3]), /* limb4 */
      t236 = limbs.S_arm_x[3] * limbs.t20[3] + t235; /* limb4 */
    const EACH4 given_2_2 = {limbs.S_arm_x[0] * limbs.t20[0] + (t136 + limbs.S_arm_x[0] * limbs.t21[0]), t246, t252,
        t236};
    const REAL t210 = limbs.signed_upper_position_x[0] * limbs.t16[0], /* limb1 */
      limb2_U_0_sin = SINES(cosine, 2),
      t214 = t172 - limbs.signed_upper_position_x[0] * (limb1_U_0_cos * limb5_S_joint_acc_still_wz) - t210,
          /* limb1 */
      t215 = limbs.signed_upper_position_x[1] * limbs.t16[1], /* limb2 */
      t219 = limbs.signed_upper_position_x[1] * (t216 + limb2_U_0_sin * limb5_S_joint_acc_still_wz), /* limb2 */
      t222 = t215 + (t219 - (limbs.t15[1] + limbs.t14[1])); /* limb2 */
    NEXT_LIMB(1, inverse_dynamics_independent, 4, stride, sine, &limbs);
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb4_U_0_sin = SINES(cosine, 6),
      t223 = limbs.signed_upper_position_x[2] * limbs.t16[2], /* limb3 */
      t227 = limbs.signed_upper_position_x[2] * (t224 + limb3_U_0_cos * limb5_S_joint_acc_still_wz), /* limb3 */
      t206 = limbs.signed_upper_position_x[3] * (t203 + limb4_U_0_sin * limb5_S_joint_acc_still_wz), /* limb4 */
      t230 = t223 + (t227 + (limbs.t15[2] - limbs.t14[2])); /* limb3 */
    NEXT_LIMB(2, inverse_dynamics_independent, 4, stride, sine, &limbs);
    const EACH4 given_2 = {t214, t222, t230, limbs.t15[3] + limbs.t14[3] - t206 - limbs.signed_upper_position_x[3] *
        limbs.t16[3]};
    FIRST_LIMB(0, inverse_dynamics_independent, 5, stride, sine, cosine, given_2, signed_limb5_S_joint_acc_wx,
        given_2_2, &limbs);
    NEXT_LIMB(1, inverse_dynamics_independent, 5, stride, sine, cosine, given_2, signed_limb5_S_joint_acc_wx,
        given_2_2, &limbs);
    NEXT_LIMB(2, inverse_dynamics_independent, 5, stride, sine, cosine, given_2, signed_limb5_S_joint_acc_wx,
        given_2_2, &limbs);
    const REAL t278 = limbs.t24[2] + (limbs.t24[1] + (t275 - limbs.t24[0]));
    NEXT_LIMB(3, inverse_dynamics_independent, 4, stride, sine, &limbs);
    NEXT_LIMB(3, inverse_dynamics_independent, 5, stride, sine, cosine, given_2, signed_limb5_S_joint_acc_wx,
        given_2_2, &limbs);
    const REAL limb1_U2_part_mn = t38 * (limbs.t24[3] - t278),
      t279 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn, t290 = t35 * limb1_U2_part_mn,
      t298 = limbs.t25[0] + t295 - limbs.t26[1] - limbs.t25[2],
      limb5_S_balance_wx = t279 - (limbs.t25[3] + (limbs.t26[2] - (limbs.t25[1] + (limbs.t26[0] + t284)))),
      minus_limb5_S_balance_wy = t290 - (limbs.t26[3] + t298);
    /* mechanism: drives; pivots */
    const REAL minus_drives_share_0_1 = limbs.t3[3] + (limbs.t3[2] + (limbs.t3[1] + limbs.t3[0])),
      t289 = minus_drives_share_0_1 * limb5_S_balance_wx,
      drives_share_0_0 = limbs.t5[3] + (limbs.t4[2] + (limbs.t5[1] + limbs.t4[0])),
      t301 = t289 - drives_share_0_0 * minus_limb5_S_balance_wy,
      t303 = minus_drives_share_0_1 * minus_limb5_S_balance_wy,
      t43 = minus_drives_share_0_1 * minus_drives_share_0_1,
      drives_share_1_1 = limbs.t4[3] + (limbs.t5[2] + (limbs.t4[1] + limbs.t5[0])),
      minus_determinant = t43 - drives_share_1_1 * drives_share_0_0;
    REAL checked3 = minus_determinant;
    const REAL t305 = t303 - drives_share_1_1 * limb5_S_balance_wx, t49 = 1.0 / minus_determinant, t302 = t49 *
        t301,
      t306 = t49 * t305;
    const EACH4 given_4 = {t302, t306, t302, t306}, given_2_3 = {t306, t302, t306, t302};
    FIRST_LIMB(0, inverse_dynamics_independent, 6, stride, u, given_4, given_2_3, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[0]);
    NEXT_LIMB(1, inverse_dynamics_independent, 6, stride, u, given_4, given_2_3, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, inverse_dynamics_independent, 6, stride, u, given_4, given_2_3, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, inverse_dynamics_independent, 6, stride, u, given_4, given_2_3, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR
            /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10),
            /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 t1, signed_S_arm_y, signed_U_0_lever_mz_by_S_fz, t2, S_arm_x, t3, signed_limb5_S_balance_wy_by_P,
      signed_limb5_S_balance_wx_by_P, t4, t5, t6, t7, t8, checked;
} LIMBS(inverse_dynamics_preload);

STAGE(inverse_dynamics_preload, 0)(size_t limb, size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict a, const double *restrict weights,
    const double *restrict sine, const double *restrict cosine, LIMBS(inverse_dynamics_preload) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      each_gravity_z = sign2 * gravity_z, each_gravity_z_limb_lower_mx = sign2 * gravity_z_limb_lower_mx;
    /* each limb: drives; accelerations; balance, eqs. (40)-(47) */
    OWN(t1) = 1.0 / IN_EACH4(READ, weights, 0, 1);
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      signed_lower_omega_x = U_v_0 * signed_lower_sin, U_v_1 = IN_EACH4(READ, v, 1, 3),
      signed_lower_alpha_still_y = U_v_1 * signed_lower_omega_x, lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t40 = sign1 * lower_cos, U_a_0 = IN_EACH4(READ, a, 0, 3),
      signed_lower_alpha_y = signed_lower_alpha_still_y - U_a_0 * t40,
      signed_lower_U_zx = signed_lower_alpha_still_y + signed_lower_alpha_y,
      t11 = k10 * signed_lower_alpha_still_y + k9 * signed_lower_alpha_y,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      signed_lower_rate_fz = limb_lower_mx * signed_lower_U_zx,
      t6 = upper_offset_x * signed_lower_U_zx + each_gravity_z * signed_U_0_sin, signed_lower_omega_y = U_v_0 * t40,
      lower_U_still_xy = signed_lower_omega_x * signed_lower_omega_y, P_v = IN_EACH4(READ, v, 2, 3),
      signed_upper_acc_z = P_v * (2.0 * signed_lower_omega_y) - t6,
      t7 = upper_offset_x * (limb_lower_m * signed_upper_acc_z + signed_lower_rate_fz),
      signed_lower_moment_y = limb_lower_mx * signed_upper_acc_z - t7 + (each_gravity_z_limb_lower_mx *
          signed_U_0_sin + t11),
      lower_joint_force_my = signed_lower_sin * (k11 * (U_v_1 * signed_lower_omega_y)) - t40 *
          signed_lower_moment_y,
      t19 = signed_lower_omega_y * signed_lower_omega_y, U_0_moment_z = lower_joint_force_my + k4 * U_a_0;
    OWN(signed_U_0_lever_mz_by_S_fz) = t40 * upper_offset_x;
    LIMB4 checked = OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(t2) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    const LIMB4 signed_S_multiplier_fz = OWN(t2) * U_0_moment_z;
    OWN(t3) = t40 * OWN(t2);
    OWN(signed_S_arm_y) = param_R * lower_cos;
    const LIMB4 t13 = OWN(signed_S_arm_y) * signed_S_multiplier_fz, t38 = signed_lower_sin * t13, t14 = t40 * t13;
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    const LIMB4 t41 = sign1 * OWN(S_arm_x), t15 = t41 * signed_S_multiplier_fz;
    OWN(t8) = t38 + t40 * t15;
    const LIMB4 t17 = t14 - signed_lower_sin * t15, U_0_cos = IN_EACH4(SINES, cosine, 0, 2),
      U_a_1 = IN_EACH4(READ, a, 1, 3), t36 = signed_U_0_sin * t17, t18 = U_0_cos * t17,
      lower_U_yx = U_a_1 + lower_U_still_xy, t22 = k9 * lower_U_still_xy, t27 = upper_offset_x * lower_U_yx,
      lower_rate_fy = limb_lower_mx * lower_U_yx, signed_U_0_acc_y = each_gravity_z * U_0_cos,
      lower_acc_x = t40 * signed_U_0_acc_y, minus_lower_acc_y = signed_lower_sin * signed_U_0_acc_y,
      upper_acc_y = P_v * (2.0 * U_v_1) + (t27 - minus_lower_acc_y),
      t29 = upper_offset_x * (limb_lower_m * upper_acc_y - lower_rate_fy),
      lower_moment_z = t22 + k10 * U_a_1 + (t29 - limb_lower_mx * (minus_lower_acc_y + upper_acc_y)),
      t33 = t41 * (OWN(t3) * lower_moment_z), minus_lower_U_still_xx = t19 + U_v_1 * U_v_1,
      lower_force_x = limb_lower_m * (IN_EACH4(READ, a, 2, 3) - (upper_offset_x * minus_lower_U_still_xx -
          lower_acc_x)),
      t34 = OWN(signed_S_arm_y) * (limb_lower_mx * minus_lower_U_still_xx + lower_force_x) + t33;
    OWN(t7) = t36 - U_0_cos * t34;
    OWN(t6) = t18 + signed_U_0_sin * t34;
    OWN(checked) = checked;
}

STAGE(inverse_dynamics_preload, 1)(size_t limb, size_t stride, const double *restrict preload,
    const double *restrict sine, const double *restrict cosine, REAL given,
    REAL platform_joint_force_mx_by_limb1_U2_mn, REAL platform_joint_force_mx_by_U2_mn,
    LIMBS(inverse_dynamics_preload) *own)
{
    (void)limb, (void)stride;
    /* each limb: balance, eqs. (40)-(47); drives */
    const LIMB4 signed_limb1_U2_part_mn_by_P = IN_EACH4(SINES, sine, 0, 2) * OWN(signed_S_arm_y) * given;
    OWN(signed_limb5_S_balance_wx_by_P) = platform_joint_force_mx_by_U2_mn * signed_limb1_U2_part_mn_by_P;
    const LIMB4 P_preload = IN_EACH4(READ, preload, 0, 1);
    OWN(t5) = P_preload * OWN(signed_limb5_S_balance_wx_by_P);
    const LIMB4 t1 = platform_joint_force_mx_by_limb1_U2_mn * signed_limb1_U2_part_mn_by_P;
    OWN(signed_limb5_S_balance_wy_by_P) = IN_EACH4(SINES, cosine, 0, 2) * OWN(signed_S_arm_y) + t1;
    OWN(t4) = P_preload * OWN(signed_limb5_S_balance_wy_by_P);
}

BODY(three_ups_upu_s_inverse_dynamics_preload)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict a, const double *restrict weights,
    const double *restrict preload, double *restrict u, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    LIMBS(inverse_dynamics_preload) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t84 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t84,
      platform_turn_xx = 1.0 - t6 * t9, t13 = limb5_S_q_qz * t9, t14 = limb5_S_q_qy * t13,
      t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t29 = limb5_S_q_qy * t9, platform_turn_zy = t14 + t16;
    /* limb1: geometry; reciprocal wrenches, eq. (10); balance, eqs. (40)-(47) */
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0), platform_turn_yz = t14 - t16,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      limb1_lower_sin = SINES(sine, 1),
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    FIRST_LIMB(0, inverse_dynamics_preload, 0, stride, q, v, a, weights, sine, cosine, &limbs);
    REAL checked0 = ALONE(limbs.checked[0]);
    const REAL minus_limb1_U_factor_0_by_3 = limb1_U_0_lever_mz_by_limb1_U2_mn * limbs.t2[0],
      t19 = limb1_U2_constraint_mn_couple_x - limbs.signed_S_arm_y[0] * minus_limb1_U_factor_0_by_3,
      t21 = limbs.S_arm_x[0] * minus_limb1_U_factor_0_by_3, limb1_lower_cos = SINES(cosine, 1),
      t39 = limb1_lower_sin * t19, t23 = limb1_lower_cos * t19 + limb1_lower_sin * t21,
      platform_joint_force_mx_by_limb1_U2_mn = t39 - limb1_lower_cos * t21, t36 = limb1_U_0_cos * t23,
      t24 = limb1_U_0_sin * t23,
      t28 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy);
    /* platform: geometry; balance, eqs. (40)-(47) */
    const REAL t30 = limb5_S_q_qx * t29, t74 = limb5_S_q_qw * t29, t31 = limb5_S_q_qw * t13,
      t73 = limb5_S_q_qx * t13, platform_turn_xy = t30 - t31, platform_turn_yx = t30 + t31,
      limb1_U2_constraint_mn_couple_z = t28 - limb1_lower_sin * platform_turn_xy,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] *
          (limb1_U2_constraint_mn_couple_z * limbs.t3[0]),
      platform_joint_force_mz_by_limb1_U2_mn = t36 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    REAL checked1 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t38 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      t35 = t24 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    NEXT_LIMB(1, inverse_dynamics_preload, 0, stride, q, v, a, weights, sine, cosine, &limbs);
    REAL checked2 = ALONE(limbs.checked[1]);
    FIRST_LIMB(1, inverse_dynamics_preload, 1, stride, preload, sine, cosine, t38,
        platform_joint_force_mx_by_limb1_U2_mn, t35, &limbs);
    /* drives: drives; pivots; balance, eqs. (40)-(47) */
    const REAL t46 = limbs.t1[1] * limbs.signed_limb5_S_balance_wx_by_P[1],
      t47 = t46 * limbs.signed_limb5_S_balance_wy_by_P[1];
    NEXT_LIMB(0, inverse_dynamics_preload, 1, stride, preload, sine, cosine, t38, t35,
        platform_joint_force_mx_by_limb1_U2_mn, &limbs);
    const REAL t41 = limbs.t1[0] * limbs.signed_limb5_S_balance_wy_by_P[0],
      t49 = t47 + t41 * limbs.signed_limb5_S_balance_wx_by_P[0];
    NEXT_LIMB(2, inverse_dynamics_preload, 0, stride, q, v, a, weights, sine, cosine, &limbs);
    REAL checked3 = ALONE(limbs.checked[2]);
    NEXT_LIMB(2, inverse_dynamics_preload, 1, stride, preload, sine, cosine, t38, t35,
        platform_joint_force_mx_by_limb1_U2_mn, &limbs);
    const REAL t44 = limbs.t1[2] * limbs.signed_limb5_S_balance_wy_by_P[2],
      t50 = t44 * limbs.signed_limb5_S_balance_wx_by_P[2] + t49;
    NEXT_LIMB(3, inverse_dynamics_preload, 0, stride, q, v, a, weights, sine, cosine, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[3]);
    NEXT_LIMB(3, inverse_dynamics_preload, 1, stride, preload, sine, cosine, t38,
        platform_joint_force_mx_by_limb1_U2_mn, t35, &limbs);
    const REAL t42 = limbs.t1[3] * limbs.signed_limb5_S_balance_wx_by_P[3],
      minus_drives_share_1_0 = t42 * limbs.signed_limb5_S_balance_wy_by_P[3] + t50,
      t51 = minus_drives_share_1_0 * minus_drives_share_1_0,
      t56 = limbs.signed_limb5_S_balance_wx_by_P[1] * t46 + limbs.signed_limb5_S_balance_wy_by_P[0] * t41,
      t57 = limbs.signed_limb5_S_balance_wy_by_P[2] * t44 + t56,
      drives_share_1_1 = limbs.signed_limb5_S_balance_wx_by_P[3] * t42 + t57,
      t62 = limbs.t1[1] * limbs.signed_limb5_S_balance_wy_by_P[1],
      t63 = limbs.signed_limb5_S_balance_wy_by_P[1] * t62,
      t64 = limbs.t1[0] * limbs.signed_limb5_S_balance_wx_by_P[0],
      t66 = t63 + limbs.signed_limb5_S_balance_wx_by_P[0] * t64,
      t60 = limbs.t1[2] * limbs.signed_limb5_S_balance_wx_by_P[2],
      t67 = limbs.signed_limb5_S_balance_wx_by_P[2] * t60 + t66,
      t58 = limbs.t1[3] * limbs.signed_limb5_S_balance_wy_by_P[3],
      drives_share_0_0 = limbs.signed_limb5_S_balance_wy_by_P[3] * t58 + t67,
      minus_determinant = t51 - drives_share_1_1 * drives_share_0_0;
    checked1 = checked1 + minus_determinant;
    const REAL t69 = 1.0 / minus_determinant, limb5_S_v_wz = READ(v, 14),
      t72 = limbs.t4[3] - (limbs.t5[2] + (limbs.t4[1] - limbs.t5[0])),
      t107 = limbs.t5[3] - (limbs.t4[2] + (limbs.t5[1] - limbs.t4[0])),
      minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      minus_platform_rate_mx = minus_platform_moment_x - (k13 * (READ(v, 13) * limb5_S_v_wz) + k14 * READ(a, 12)),
      t93 = platform_turn_xx * minus_platform_rate_mx, t109 = platform_turn_yx * minus_platform_rate_mx,
      platform_turn_zx = t73 - t74, platform_turn_xz = t73 + t74, t78 = platform_turn_zx * minus_platform_rate_mx,
      platform_moment_y = gravity_z_platform_mz * platform_turn_zx,
      platform_rate_my = platform_moment_y - (k13 * (READ(v, 12) * limb5_S_v_wz) - k14 * READ(a, 13)),
      t83 = t78 - platform_turn_zy * platform_rate_my, t95 = t93 - platform_turn_xy * platform_rate_my,
      t111 = t109 - platform_turn_yy * platform_rate_my, platform_rate_mz = platform_Izz * READ(a, 14),
      minus_platform_joint_force_mz = limbs.t6[2] + (limbs.t6[1] + (t83 - platform_turn_zz * platform_rate_mz -
          limbs.t6[0])) - limbs.t6[3],
      limb1_U2_part_mn = t38 * minus_platform_joint_force_mz,
      t91 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn, t108 = t35 * limb1_U2_part_mn,
      t116 = limbs.t7[2] + (limbs.t8[1] - (t111 - platform_turn_yz * platform_rate_mz + limbs.t7[0])),
      t101 = limbs.t8[2] + (t95 - platform_turn_xz * platform_rate_mz - limbs.t8[0] + limbs.t7[1]) - limbs.t7[3],
      t103 = t72 + (t91 - t101), t119 = t107 + (t108 + (limbs.t8[3] - t116)),
      t126 = minus_drives_share_1_0 * t119 - drives_share_1_1 * t103,
      t122 = t69 * (minus_drives_share_1_0 * t103 - drives_share_0_0 * t119), t127 = t69 * t126,
      limb1_P_preload = READ(preload, 0);
    RESULT(checked2, u, 0, limb1_P_preload - (t41 * t122 + t64 * t127));
    const REAL limb2_P_preload = READ(preload, 1);
    RESULT(checked3, u, 1, limb2_P_preload + (t46 * t122 + t62 * t127));
    const REAL limb3_P_preload = READ(preload, 2), t136 = t42 * t122; /* limb4 */
    RESULT(checked0, u, 2, limb3_P_preload + (t44 * t122 + t60 * t127));
    const REAL limb4_P_preload = READ(preload, 3);
    RESULT(checked1, u, 3, limb4_P_preload - (t136 + t58 * t127));
    const REAL limb1_P_weights = READ(weights, 0);
    checked2 = checked2 + limb1_P_weights;
    const REAL limb2_P_weights = READ(weights, 1);
    checked3 = checked3 + limb2_P_weights;
    const REAL limb3_P_weights = READ(weights, 2);
    checked0 = checked0 + limb3_P_weights;
    const REAL limb4_P_weights = READ(weights, 3);
    checked1 = checked1 + limb4_P_weights;
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.signed_U_0_lever_mz_by_S_fz, 6.233100000000001e-10, 6.3211e-10, 6.4044e-10, 6.284e-10) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR
            /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10) OR
            /* where equations that are solved at once lose rank, as drives do at a singularity */
        SMALL(limb1_P_weights, 0.0) OR /* where weights limb1_P vanishes */
        SMALL(limb2_P_weights, 0.0) OR /* where weights limb2_P vanishes */
        SMALL(limb3_P_weights, 0.0) OR /* where weights limb3_P vanishes */
        SMALL(limb4_P_weights, 0.0), /* where weights limb4_P vanishes */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 signed_lower_limb_target_y, signed_upper_position_x, signed_lower_limb_target_x,
      lower_limb_length, t1, signed_lower_sin, t2, signed_U_0_lever_mz_by_S_fz, t3, signed_U_0_cos,
      signed_lower_cos, t4, signed_U_0_sin, t5, t6, signed_limb5_S_balance_wy_by_P,
      minus_limb5_S_balance_wx_by_P, signed_lower_alpha_x, t7, U_0_alpha_z, signed_lower_U_zx_2, t8, t9,
      t10, t11, t12, signed_lower_U_yx, minus_lower_U_xx, t13, t14, t15, t16, t17;
} LIMBS(inverse_dynamics_platform);

STAGE(inverse_dynamics_platform, 0)(size_t limb, size_t stride, REAL given, REAL given_2, REAL given_3,
    REAL given_4, REAL given_5, REAL given_6, LIMBS(inverse_dynamics_platform) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0),
      each_param_R = -sign2 * param_R;
    /* each limb: geometry; loop closure; reciprocal wrenches, eq. (10) */
    OWN(signed_lower_limb_target_x) = given_5 - sign1 * given_6;
    const LIMB4 t1 = OWN(signed_lower_limb_target_x) * OWN(signed_lower_limb_target_x);
    OWN(signed_lower_limb_target_y) = given - sign1 * given_2;
    const LIMB4 t3 = t1 + OWN(signed_lower_limb_target_y) * OWN(signed_lower_limb_target_y);
    OWN(signed_upper_position_x) = given_3 - sign1 * given_4;
    const LIMB4 signed_lower_limb_target_z = OWN(signed_upper_position_x) + each_param_R;
    OWN(lower_limb_length) = SQRT4(t3 + signed_lower_limb_target_z * signed_lower_limb_target_z);
    OWN(t1) = 1.0 / OWN(lower_limb_length);
    OWN(signed_lower_sin) = signed_lower_limb_target_z * OWN(t1);
    OWN(t2) = OWN(signed_lower_limb_target_y) * OWN(signed_lower_sin);
    OWN(t6) = OWN(signed_lower_limb_target_x) * OWN(signed_lower_sin);
    OWN(signed_U_0_lever_mz_by_S_fz) = SQRT4(t3);
    OWN(signed_lower_cos) = OWN(signed_U_0_lever_mz_by_S_fz) * OWN(t1);
    OWN(t3) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(signed_U_0_cos) = OWN(signed_lower_limb_target_y) * OWN(t3);
    OWN(signed_U_0_sin) = OWN(signed_lower_limb_target_x) * OWN(t3);
    OWN(t4) = OWN(signed_upper_position_x) * (OWN(signed_U_0_cos) * OWN(signed_lower_cos));
    OWN(t5) = OWN(signed_upper_position_x) * (OWN(signed_U_0_sin) * OWN(signed_lower_cos));
}

STAGE(inverse_dynamics_platform, 1)(size_t limb, size_t stride, REAL platform_twist_wz,
    REAL platform_twist_wx, REAL platform_twist_wy, REAL given, REAL given_2, REAL given_3, REAL given_4,
    REAL given_5, REAL given_6, LIMBS(inverse_dynamics_platform) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0);
    /* each limb: loop closure; velocities, eq. (6) */
    const LIMB4 t1 = OWN(signed_upper_position_x) * platform_twist_wz,
      t3 = t1 - OWN(signed_lower_limb_target_y) * platform_twist_wx, t4 = t3 * OWN(signed_U_0_sin),
      t15 = t3 * OWN(signed_U_0_cos), t5 = OWN(signed_lower_limb_target_x) * platform_twist_wx,
      t7 = t5 - OWN(signed_upper_position_x) * platform_twist_wy, t9 = t4 + t7 * OWN(signed_U_0_cos),
      U_0_omega_z = OWN(t3) * (t7 * OWN(signed_U_0_sin) - t15), t10 = OWN(signed_lower_sin) * t9,
      t17 = OWN(signed_lower_cos) * t9, t11 = OWN(signed_lower_limb_target_y) * platform_twist_wy,
      t13 = t11 - OWN(signed_lower_limb_target_x) * platform_twist_wz,
      signed_lower_omega_z = OWN(t1) * (t13 * OWN(signed_lower_cos) - t10),
      minus_S_opening_rate_fx = t17 + t13 * OWN(signed_lower_sin);
    /* each limb: accelerations; velocities, eq. (6); loop closure */
    const LIMB4 t38 = signed_lower_omega_z * signed_lower_omega_z,
      signed_lower_omega_y = OWN(signed_lower_cos) * U_0_omega_z,
      signed_lower_omega_x = OWN(signed_lower_sin) * U_0_omega_z;
    OWN(signed_lower_alpha_x) = signed_lower_omega_z * signed_lower_omega_y;
    OWN(minus_lower_U_xx) = signed_lower_omega_y * signed_lower_omega_y + t38;
    OWN(t9) = minus_S_opening_rate_fx * (2.0 * signed_lower_omega_z);
    const LIMB4 signed_lower_alpha_y = signed_lower_omega_z * signed_lower_omega_x,
      signed_lower_U_xy = signed_lower_omega_x * signed_lower_omega_y;
    OWN(t7) = minus_S_opening_rate_fx * ((-2.0) * signed_lower_omega_y);
    const LIMB4 signed_upper_acc_y = OWN(lower_limb_length) * signed_lower_U_xy + OWN(t9),
      t21 = given + sign1 * given_2, t30 = OWN(signed_U_0_sin) * t21, t22 = OWN(signed_U_0_cos) * t21,
      t23 = given_3 + sign1 * given_4;
    OWN(t10) = t30 + OWN(signed_U_0_cos) * t23;
    const LIMB4 t32 = OWN(signed_lower_sin) * OWN(t10), t41 = sign2 * (t22 - OWN(signed_U_0_sin) * t23);
    OWN(t11) = given_5 + sign1 * given_6;
    const LIMB4 signed_lower_alpha_z = OWN(t1) * (signed_upper_acc_y - sign2 * (t32 - OWN(signed_lower_cos) *
        OWN(t11)));
    OWN(signed_lower_U_yx) = signed_lower_U_xy - signed_lower_alpha_z;
    OWN(t12) = k10 * signed_lower_alpha_z - k9 * signed_lower_U_xy;
    OWN(U_0_alpha_z) = OWN(t3) * (OWN(lower_limb_length) * (2.0 * signed_lower_alpha_y) + OWN(t7) + t41);
    const LIMB4 signed_lower_alpha_y_2 = signed_lower_alpha_y - OWN(signed_lower_cos) * OWN(U_0_alpha_z);
    OWN(signed_lower_U_zx_2) = signed_lower_alpha_y + signed_lower_alpha_y_2;
    OWN(t8) = k9 * signed_lower_alpha_y_2 + k10 * signed_lower_alpha_y;
}

STAGE(inverse_dynamics_platform, 2)(size_t limb, size_t stride, REAL given, REAL given_2, REAL given_3,
    REAL given_4, REAL given_5, REAL signed_U_0_sin, REAL signed_U_0_cos,
    LIMBS(inverse_dynamics_platform) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, 1.0), sign2 = OF4(1.0, 1.0, -1.0, 1.0),
      each_gravity_z = sign2 * gravity_z, each_gravity_z_limb_lower_mx = sign2 * gravity_z_limb_lower_mx,
      sign3 = OF4(1.0, -1.0, -1.0, -1.0), each_gravity_z_2 = -sign3 * gravity_z, sign4 = OF4(1.0, -1.0, 1.0, -1.0),
      each_limb_lower_m = -sign4 * limb_lower_m;
    /* each limb: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const LIMB4 signed_limb1_U2_part_mn_by_P = (given + sign1 * given_2) * given_3;
    OWN(signed_limb5_S_balance_wy_by_P) = given_4 * signed_limb1_U2_part_mn_by_P;
    OWN(minus_limb5_S_balance_wx_by_P) = given_5 * signed_limb1_U2_part_mn_by_P;
    const LIMB4 signed_U_0_acc_y = each_gravity_z_2 * signed_U_0_cos,
      signed_lower_acc_y = OWN(signed_lower_sin) * signed_U_0_acc_y,
      t18 = OWN(signed_lower_cos) * (OWN(t10) - sign4 * signed_U_0_acc_y),
      signed_upper_acc_y = OWN(t9) - (signed_lower_acc_y - OWN(lower_limb_length) * OWN(signed_lower_U_yx)),
      t13 = limb_lower_mx * (signed_lower_acc_y + signed_upper_acc_y),
      t11 = OWN(lower_limb_length) * (limb_lower_m * signed_upper_acc_y - limb_lower_mx * OWN(signed_lower_U_yx)),
      signed_S_multiplier_fy = OWN(t1) * (OWN(t12) - (t11 - t13)),
      t22 = OWN(signed_lower_cos) * signed_S_multiplier_fy, t15 = OWN(signed_lower_sin) * signed_S_multiplier_fy,
      lower_force_x = each_limb_lower_m * (OWN(signed_lower_sin) * OWN(t11) + t18),
      upper_rate_fx = limb_lower_mx * OWN(minus_lower_U_xx) + lower_force_x,
      t24 = t22 - OWN(signed_lower_sin) * upper_rate_fx;
    OWN(t14) = OWN(signed_lower_limb_target_x) * t24;
    OWN(t15) = OWN(signed_lower_limb_target_y) * t24;
    const LIMB4 t20 = t15 + OWN(signed_lower_cos) * upper_rate_fx,
      signed_upper_acc_z_2 = OWN(t7) + (each_gravity_z * signed_U_0_sin + OWN(lower_limb_length) *
          OWN(signed_lower_U_zx_2)),
      signed_upper_rate_my = limb_lower_mx * signed_upper_acc_z_2,
      t4 = OWN(lower_limb_length) * (limb_lower_m * signed_upper_acc_z_2 - limb_lower_mx *
          OWN(signed_lower_U_zx_2)),
      t7 = OWN(signed_lower_cos) * (signed_upper_rate_my - t4 - (OWN(t8) + each_gravity_z_limb_lower_mx *
          signed_U_0_sin)),
      signed_S_multiplier_fz = OWN(t3) * (OWN(signed_lower_sin) * (k11 * OWN(signed_lower_alpha_x)) + t7 + k4 *
          OWN(U_0_alpha_z)),
      t8 = OWN(signed_U_0_cos) * signed_S_multiplier_fz;
    OWN(t16) = OWN(signed_U_0_sin) * signed_S_multiplier_fz + OWN(signed_U_0_cos) * t20;
    const LIMB4 t27 = OWN(signed_lower_limb_target_x) * OWN(t16);
    OWN(t13) = t8 - OWN(signed_U_0_sin) * t20;
    OWN(t17) = t27 + OWN(signed_lower_limb_target_y) * OWN(t13);
}

BODY(three_ups_upu_s_inverse_dynamics_platform)(size_t stride, const double *restrict pose,
    const double *restrict rate, const double *restrict acceleration, double *restrict u,
    double *restrict total)
{
    LIMBS(inverse_dynamics_platform) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_pose_qw = READ(pose, 0), limb5_S_pose_qx = READ(pose, 1),
      t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx,
      limb5_S_pose_qy = READ(pose, 2), t3 = t1 + t2, t4 = limb5_S_pose_qy * limb5_S_pose_qy,
      limb5_S_pose_qz = READ(pose, 3), t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6,
      t9 = 4.0 - 2.0 * t7, t28 = t2 + t5, platform_turn_zz = 1.0 - t9 * (t2 + t4), platform_turn_xx = 1.0 - t6 * t9,
      platform_turn_yy = 1.0 - t9 * t28, t10 = limb5_S_pose_qz * t9, t11 = limb5_S_pose_qx * t10,
      t12 = limb5_S_pose_qy * t9, t26 = limb5_S_pose_qw * (limb5_S_pose_qx * t9), t13 = limb5_S_pose_qw * t12,
      t19 = limb5_S_pose_qx * t12, platform_turn_zx = t11 - t13, platform_turn_xz = t11 + t13,
      t14 = 0.5 * platform_turn_zx, t18 = param_H * platform_turn_xz, t20 = limb5_S_pose_qw * t10,
      t24 = limb5_S_pose_qy * t10, platform_turn_yx = t19 + t20, platform_turn_xy = t19 - t20,
      t31 = 0.5 * platform_turn_yx, platform_turn_yz = t24 - t26, platform_turn_zy = t24 + t26,
      t27 = param_H * platform_turn_yz, t17 = param_H * platform_turn_zz, t23 = 0.5 * platform_turn_xx;
    FIRST_LIMB(0, inverse_dynamics_platform, 0, stride, t14, t17, t23, t18, t31, t27, &limbs);
    NEXT_LIMB(2, inverse_dynamics_platform, 0, stride, t14, t17, t23, t18, t31, t27, &limbs);
    /* limb1: reciprocal wrenches, eq. (10); loop closure; balance, eqs. (40)-(47) */
    const REAL t35 = platform_turn_yy * limbs.signed_U_0_sin[0] + platform_turn_zy * limbs.signed_U_0_cos[0],
      t216 = limbs.signed_lower_sin[0] * t35,
      limb1_U2_constraint_mn_couple_z = limbs.signed_lower_cos[0] * t35 + platform_turn_xy *
          limbs.signed_lower_sin[0],
      minus_limb1_U2_part_fy_by_limb1_U2_mn = limbs.t1[0] * limb1_U2_constraint_mn_couple_z,
      limb1_U_0_force_y_by_limb1_U2_mn = limbs.signed_lower_sin[0] * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      limb1_U_0_force_z_by_limb1_U2_mn = limbs.signed_lower_cos[0] * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      minus_limb1_U_0_joint_force_fx_by_limb1_U2_mn = limbs.signed_U_0_sin[0] * limb1_U_0_force_y_by_limb1_U2_mn,
      minus_limb1_U_0_joint_force_fy_by_limb1_U2_mn = limbs.signed_U_0_cos[0] * limb1_U_0_force_y_by_limb1_U2_mn,
      minus_limb1_U2_constraint_mn_couple_x = platform_turn_yy * limbs.signed_U_0_cos[0] - platform_turn_zy *
          limbs.signed_U_0_sin[0],
      limb1_U_0_lever_mz_by_limb1_U2_mn = limbs.signed_lower_sin[0] * minus_limb1_U2_constraint_mn_couple_x,
      minus_limb1_U_0_lever_my_by_limb1_U2_mn = limbs.signed_lower_cos[0] * minus_limb1_U2_constraint_mn_couple_x,
      limb1_U2_part_fz_by_limb1_U2_mn = limbs.t3[0] * limb1_U_0_lever_mz_by_limb1_U2_mn;
    /* platform: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10) */
    const REAL t51 = limbs.signed_U_0_cos[0] * limb1_U2_part_fz_by_limb1_U2_mn -
        minus_limb1_U_0_joint_force_fx_by_limb1_U2_mn,
      t44 = minus_limb1_U_0_joint_force_fy_by_limb1_U2_mn + limbs.signed_U_0_sin[0] *
          limb1_U2_part_fz_by_limb1_U2_mn,
      t52 = limbs.signed_upper_position_x[0] * t51, t57 = limbs.signed_lower_limb_target_y[0] * t51,
      t54 = t52 - limbs.signed_lower_limb_target_x[0] * limb1_U_0_force_z_by_limb1_U2_mn,
      t42 = limbs.signed_lower_limb_target_y[0] * limb1_U_0_force_z_by_limb1_U2_mn, /* limb1 */
      t48 = limbs.signed_U_0_sin[0] * limb1_U2_constraint_mn_couple_z, /* limb1 */
      t38 = limbs.signed_U_0_cos[0] * limb1_U2_constraint_mn_couple_z, /* limb1 */
      platform_joint_force_mz_by_limb1_U2_mn = t48 + limbs.signed_U_0_cos[0] *
          minus_limb1_U_0_lever_my_by_limb1_U2_mn + t54;
    REAL checked0 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t55 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      minus_base_lever_my_by_limb1_U2_mn = t38 - limbs.signed_U_0_sin[0] * minus_limb1_U_0_lever_my_by_limb1_U2_mn,
      t47 = minus_base_lever_my_by_limb1_U2_mn - (t42 + limbs.signed_upper_position_x[0] * t44),
      t59 = limbs.signed_lower_limb_target_x[0] * t44 + t57 - limb1_U_0_lever_mz_by_limb1_U2_mn;
    /* platform: accelerations; loop closure; momentum rate, eq. (35) */
    const REAL limb5_S_rate_wy = READ(rate, 1), t104 = limb5_S_rate_wy * limb5_S_rate_wy,
      limb5_S_rate_wz = READ(rate, 2), t105 = limb5_S_rate_wz * limb5_S_rate_wz,
      minus_platform_U_still_xx = t104 + t105, limb5_S_rate_wx = READ(rate, 0),
      t106 = platform_turn_yx * minus_platform_U_still_xx, platform_U_still_xy = limb5_S_rate_wx * limb5_S_rate_wy,
      limb5_S_acc_wz = READ(acceleration, 2), platform_U_yx = limb5_S_acc_wz + platform_U_still_xy,
      minus_platform_U_xy = limb5_S_acc_wz - platform_U_still_xy, t108 = t106 - platform_turn_yy * platform_U_yx,
      platform_U_still_xz = limb5_S_rate_wx * limb5_S_rate_wz, limb5_S_acc_wy = READ(acceleration, 1),
      minus_platform_U_zx = limb5_S_acc_wy - platform_U_still_xz,
      t111 = 0.5 * (t108 + platform_turn_yz * minus_platform_U_zx),
      platform_U_xz = limb5_S_acc_wy + platform_U_still_xz, t85 = k13 * platform_U_still_xz,
      t112 = platform_turn_yx * platform_U_xz, platform_U_still_yz = limb5_S_rate_wy * limb5_S_rate_wz,
      limb5_S_acc_wx = READ(acceleration, 0), minus_platform_U_yz = limb5_S_acc_wx - platform_U_still_yz;
    /* platform: loop closure; velocities, eq. (6); balance, eqs. (40)-(47) */
    const REAL t114 = t112 - platform_turn_yy * minus_platform_U_yz, t115 = limb5_S_rate_wx * limb5_S_rate_wx,
      minus_platform_U_still_zz = t115 + t104, minus_platform_U_still_yy = t115 + t105,
      t118 = param_H * (t114 - platform_turn_yz * minus_platform_U_still_zz),
      t133 = platform_turn_zx * minus_platform_U_still_xx - platform_turn_zy * platform_U_yx,
      t151 = platform_turn_xx * minus_platform_U_still_xx - platform_turn_xy * platform_U_yx,
      t136 = 0.5 * (t133 + platform_turn_zz * minus_platform_U_zx),
      t154 = 0.5 * (t151 + platform_turn_xz * minus_platform_U_zx),
      t121 = platform_turn_zx * platform_U_xz - platform_turn_zy * minus_platform_U_yz,
      t139 = platform_turn_xx * platform_U_xz - platform_turn_xy * minus_platform_U_yz,
      t124 = param_H * (t121 - platform_turn_zz * minus_platform_U_still_zz),
      t142 = param_H * (t139 - platform_turn_xz * minus_platform_U_still_zz),
      t95 = limb5_S_rate_wx * platform_turn_zx + limb5_S_rate_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_rate_wz * platform_turn_zz + t95,
      t98 = limb5_S_rate_wx * platform_turn_xx + limb5_S_rate_wy * platform_turn_xy,
      platform_twist_wx = t98 + limb5_S_rate_wz * platform_turn_xz,
      t102 = limb5_S_rate_wy * platform_turn_yy + limb5_S_rate_wx * platform_turn_yx,
      platform_twist_wy = t102 + limb5_S_rate_wz * platform_turn_yz;
    FIRST_LIMB(0, inverse_dynamics_platform, 1, stride, platform_twist_wz, platform_twist_wx, platform_twist_wy,
        t111, t118, t136, t124, t154, t142, &limbs);
    NEXT_LIMB(2, inverse_dynamics_platform, 1, stride, platform_twist_wz, platform_twist_wx, platform_twist_wy,
        t111, t118, t136, t124, t154, t142, &limbs);
    FIRST_LIMB(0, inverse_dynamics_platform, 2, stride, limbs.t5[0], -limbs.t6[0], t55, t47, t59,
        limbs.signed_U_0_sin[0], limbs.signed_U_0_cos[0], &limbs);
    const REAL t162 = limbs.signed_upper_position_x[0] * limbs.t13[0] - limbs.t14[0], /* limb1 */
      minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy, t81 = k13 * platform_U_still_yz,
      platform_U_zy = limb5_S_acc_wx + platform_U_still_yz,
      minus_platform_rate_mx = minus_platform_moment_x - (t81 + k14 * limb5_S_acc_wx),
      t84 = platform_turn_zx * minus_platform_rate_mx, t125 = platform_turn_zx * minus_platform_U_xy,
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (t85 - k14 * limb5_S_acc_wy),
      t89 = t84 - platform_turn_zy * platform_rate_my, platform_rate_mz = platform_Izz * limb5_S_acc_wz,
      t163 = t89 - platform_turn_zz * platform_rate_mz + t162,
      t130 = 0.5 * (t125 + platform_turn_zy * minus_platform_U_still_yy - platform_turn_zz * platform_U_zy),
      t32 = 0.5 * platform_turn_zy,
      t145 = platform_turn_xx * minus_platform_U_xy + platform_turn_xy * minus_platform_U_still_yy,
      t157 = platform_turn_yx * minus_platform_U_xy + platform_turn_yy * minus_platform_U_still_yy,
      t173 = platform_turn_yx * minus_platform_rate_mx, t188 = platform_turn_xx * minus_platform_rate_mx,
      t148 = 0.5 * (t145 - platform_turn_xz * platform_U_zy), t160 = 0.5 * (t157 - platform_turn_yz *
          platform_U_zy);
    /* limb5_S: balance, eqs. (40)-(47); geometry */
    const REAL t176 = platform_turn_yz * platform_rate_mz, t191 = platform_turn_xz * platform_rate_mz,
      t21 = 0.5 * platform_turn_xy, t30 = 0.5 * platform_turn_yy,
      t177 = t173 - platform_turn_yy * platform_rate_my - t176,
      t193 = t188 - platform_turn_xy * platform_rate_my - t191 - limbs.t17[0],
      limb1_U2_opening_mn = platform_turn_xy * limbs.signed_lower_cos[0] - t216,
      t218 = limb1_U2_opening_mn * limb1_U2_opening_mn;
    NEXT_LIMB(1, inverse_dynamics_platform, 0, stride, t18, t21, t27, t30, t17, t32, &limbs);
    NEXT_LIMB(3, inverse_dynamics_platform, 0, stride, t18, t21, t27, t30, t17, t32, &limbs);
    NEXT_LIMB(1, inverse_dynamics_platform, 1, stride, platform_twist_wx, platform_twist_wy, platform_twist_wz,
        t124, t130, t142, t148, t118, t160, &limbs);
    NEXT_LIMB(3, inverse_dynamics_platform, 1, stride, platform_twist_wx, platform_twist_wy, platform_twist_wz,
        t124, t130, t142, t148, t118, t160, &limbs);
    NEXT_LIMB(1, inverse_dynamics_platform, 2, stride, limbs.t2[1], limbs.t4[1], t55, t47, t59,
        limbs.signed_U_0_cos[1], limbs.signed_U_0_sin[1], &limbs);
    const REAL t166 = t163 + (limbs.t15[1] + limbs.signed_upper_position_x[1] * limbs.t16[1]);
    NEXT_LIMB(2, inverse_dynamics_platform, 2, stride, limbs.t5[2], -limbs.t6[2], t55, t47, t59,
        limbs.signed_U_0_sin[2], limbs.signed_U_0_cos[2], &limbs);
    const REAL t169 = t166 + (limbs.signed_upper_position_x[2] * limbs.t13[2] - limbs.t14[2]);
    NEXT_LIMB(3, inverse_dynamics_platform, 2, stride, -limbs.t2[3], limbs.t4[3], t55, t47, t59,
        limbs.signed_U_0_cos[3], limbs.signed_U_0_sin[3], &limbs);
    const REAL limb1_U2_part_mn = t55 * (t169 + (limbs.t15[3] + limbs.signed_upper_position_x[3] * limbs.t16[3])),
      t172 = t47 * limb1_U2_part_mn, t187 = t59 * limb1_U2_part_mn,
      t181 = t177 + (limbs.t15[0] + limbs.signed_upper_position_x[0] * limbs.t16[0]) - limbs.t17[1],
      limb5_S_balance_wy_by_limb1_P = limbs.t4[0] - limbs.t2[0] - limbs.signed_limb5_S_balance_wy_by_P[0],
      minus_limb5_S_balance_wy = t172 + (t181 + (limbs.t15[2] + limbs.signed_upper_position_x[2] * limbs.t16[2]) -
          limbs.t17[3]),
      limb5_S_balance_wy_by_limb3_P = limbs.t4[2] - limbs.t2[2] - limbs.signed_limb5_S_balance_wy_by_P[2],
      minus_limb5_S_balance_wx_by_limb2_P = limbs.t5[1] - limbs.t6[1] + limbs.minus_limb5_S_balance_wx_by_P[1],
      t197 = t193 + (limbs.signed_upper_position_x[1] * limbs.t13[1] - limbs.t14[1]) - limbs.t17[2];
    /* limb5_S: drives; balance, eqs. (40)-(47); pivots */
    const REAL t62 = minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wx_by_limb2_P,
      t64 = t62 + limbs.minus_limb5_S_balance_wx_by_P[0] * limbs.minus_limb5_S_balance_wx_by_P[0],
      t65 = limbs.minus_limb5_S_balance_wx_by_P[2] * limbs.minus_limb5_S_balance_wx_by_P[2] + t64,
      minus_limb5_S_balance_wx_by_limb4_P = limbs.t5[3] - limbs.t6[3] - limbs.minus_limb5_S_balance_wx_by_P[3],
      minus_limb5_S_balance_wx = t187 + (t197 + (limbs.signed_upper_position_x[3] * limbs.t13[3] - limbs.t14[3])),
      drives_share_0_0 = minus_limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wx_by_limb4_P + t65,
      t186 = minus_limb5_S_balance_wy * drives_share_0_0,
      t75 = limbs.minus_limb5_S_balance_wx_by_P[0] * limb5_S_balance_wy_by_limb1_P,
      t77 = t75 - limbs.signed_limb5_S_balance_wy_by_P[1] * minus_limb5_S_balance_wx_by_limb2_P,
      t78 = limbs.minus_limb5_S_balance_wx_by_P[2] * limb5_S_balance_wy_by_limb3_P + t77,
      minus_drives_share_0_1 = limbs.signed_limb5_S_balance_wy_by_P[3] * minus_limb5_S_balance_wx_by_limb4_P + t78,
      t206 = minus_limb5_S_balance_wy * minus_drives_share_0_1,
      t202 = t186 + minus_limb5_S_balance_wx * minus_drives_share_0_1,
      t79 = minus_drives_share_0_1 * minus_drives_share_0_1,
      t68 = limb5_S_balance_wy_by_limb1_P * limb5_S_balance_wy_by_limb1_P,
      t70 = t68 + limbs.signed_limb5_S_balance_wy_by_P[1] * limbs.signed_limb5_S_balance_wy_by_P[1],
      t71 = limb5_S_balance_wy_by_limb3_P * limb5_S_balance_wy_by_limb3_P + t70,
      drives_share_1_1 = limbs.signed_limb5_S_balance_wy_by_P[3] * limbs.signed_limb5_S_balance_wy_by_P[3] + t71,
      value_determinant = drives_share_0_0 * drives_share_1_1 - t79;
    REAL checked1 = value_determinant;
    const REAL t207 = minus_limb5_S_balance_wx * drives_share_1_1 + t206, t80 = 1.0 / value_determinant,
      t203 = t80 * t202, t208 = t80 * t207,
      limb1_P_drive = limb5_S_balance_wy_by_limb1_P * t203 - limbs.minus_limb5_S_balance_wx_by_P[0] * t208;
    WRITE(u, 0, limb1_P_drive);
    REAL checked2 = limb1_P_drive;
    const REAL limb3_P_drive = limb5_S_balance_wy_by_limb3_P * t203 - limbs.minus_limb5_S_balance_wx_by_P[2] * t208;
    WRITE(u, 2, limb3_P_drive);
    REAL checked3 = limb3_P_drive;
    const REAL t211 = limbs.signed_limb5_S_balance_wy_by_P[1] * t203; /* limb2 */
    RESULT(checked0, u, 3, limbs.signed_limb5_S_balance_wy_by_P[3] * t203 - minus_limb5_S_balance_wx_by_limb4_P *
        t208);
    const REAL minus_limb2_P_drive = minus_limb5_S_balance_wx_by_limb2_P * t208 + t211;
    checked1 = checked1 + minus_limb2_P_drive;
    WRITE(u, 1, -minus_limb2_P_drive);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    /* else status 6: not on the mechanism */
    NOT_ABOVE(t218, 1.0e-12, 6);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.lower_limb_length, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR
            /* where the points of limb_lower coincide */
        SMALL4(limbs.signed_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR
            /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(value_determinant, 2.393867125597279e-10),
            /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}
#endif

#if !defined(THREE_UPS_UPU_S_VECTORS)

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
#define THREE_UPS_UPU_S_VECTORS
#define THREE_UPS_UPU_S_LANES 4
#include "three_ups_upu_s_support.h" /* for all limbs at once */
#include "three_ups_upu_s_inverse_dynamics.c"
#undef THREE_UPS_UPU_S_VECTORS
#undef THREE_UPS_UPU_S_LANES
#include "three_ups_upu_s_support.h" /* for one limb again */
#endif


#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_inverse_dynamics_limb_by_limb(const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_inverse_dynamics_body(1, q, v, a, u, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(u, 4);
    }
    return outcome;
}

int three_ups_upu_s_inverse_dynamics(const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    if (isfinite(three_ups_upu_s_inverse_dynamics_packed_lane(1, q, v, a, u, sine, cosine, NULL))) {
        return 0;
    }
#endif
    return three_ups_upu_s_inverse_dynamics_limb_by_limb(q, v, a, u);
}


#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_inverse_dynamics_independent_limb_by_limb(const double *restrict q,
    const double *restrict y_dot, const double *restrict y_ddot, double *restrict u)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_inverse_dynamics_independent_body(1, q, y_dot, y_ddot, u, sine,
        cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(u, 4);
    }
    return outcome;
}

int three_ups_upu_s_inverse_dynamics_independent(const double *restrict q, const double *restrict y_dot,
    const double *restrict y_ddot, double *restrict u)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    if (isfinite(three_ups_upu_s_inverse_dynamics_independent_packed_lane(1, q, y_dot, y_ddot, u, sine,
        cosine, NULL))) {
        return 0;
    }
#endif
    return three_ups_upu_s_inverse_dynamics_independent_limb_by_limb(q, y_dot, y_ddot, u);
}

int three_ups_upu_s_inverse_dynamics_preload(const double *restrict q, const double *restrict v,
    const double *restrict a, const double *restrict weights, const double *restrict preload,
    double *restrict u)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_inverse_dynamics_preload_body(1, q, v, a, weights, preload, u, sine,
        cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(u, 4);
    }
    return outcome;
}

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_inverse_dynamics_platform_packed_lane(const double
    *restrict pose,
    const double *restrict rate, const double *restrict acceleration, double *restrict u)
{
    typedef three_ups_upu_s_vector4 lanes4;
    const double limb5_S_pose_qw = pose[0], limb5_S_pose_qx = pose[1], limb5_S_pose_qy = pose[2],
      limb5_S_pose_qz = pose[3], limb5_S_rate_wx = rate[0], limb5_S_rate_wy = rate[1], limb5_S_rate_wz = rate[2],
      limb5_S_acc_wx = acceleration[0], limb5_S_acc_wy = acceleration[1], limb5_S_acc_wz = acceleration[2];
    /* platform: geometry; velocities, eq. (6) */
    const double t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx, t3 = t1 + t2,
      t4 = limb5_S_pose_qy * limb5_S_pose_qy, t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6,
      t9 = 4.0 - 2.0 * t7, t37 = t2 + t5, platform_turn_zz = 1.0 - t9 * (t2 + t4), platform_turn_xx = 1.0 - t6 * t9,
      platform_turn_yy = 1.0 - t9 * t37, t12 = limb5_S_pose_qy * t9, t21 = limb5_S_pose_qx * t12,
      t13 = limb5_S_pose_qw * t12, t10 = limb5_S_pose_qz * t9, t26 = limb5_S_pose_qw * (limb5_S_pose_qx * t9),
      t22 = limb5_S_pose_qw * t10, platform_turn_yx = t21 + t22, platform_turn_xy = t21 - t22,
      t23 = 0.5 * platform_turn_yx, t24 = limb5_S_pose_qy * t10, t11 = limb5_S_pose_qx * t10,
      platform_turn_yz = t24 - t26, platform_turn_zy = t24 + t26, t27 = param_H * platform_turn_yz,
      t66 = 0.5 * platform_turn_zy, t17 = param_H * platform_turn_zz;
    const lanes4 signed_limb_lower_limb_target_x = (lanes4){t23, t17, t23, t17} - (lanes4){1.0, 1.0, -1.0, -1.0} *
        (lanes4){t27, t66, t27, t66},
      lanes_5 = signed_limb_lower_limb_target_x * signed_limb_lower_limb_target_x;
    const double platform_turn_zx = t11 - t13, platform_turn_xz = t11 + t13, t14 = 0.5 * platform_turn_zx,
      t20 = param_H * platform_turn_xz, t68 = 0.5 * platform_turn_xy;
    const lanes4 signed_limb_lower_limb_target_y = (lanes4){t14, t20, t14, t20} - (lanes4){1.0, 1.0, -1.0, -1.0} *
        (lanes4){t17, t68, t17, t68},
      lanes_11 = lanes_5 + signed_limb_lower_limb_target_y * signed_limb_lower_limb_target_y,
      each_limb1_U_0_lever_mz_by_limb1_U2_fz = three_ups_upu_s_vector4_sqrt(lanes_11),
      lanes_12 = 1.0 / each_limb1_U_0_lever_mz_by_limb1_U2_fz,
      signed_limb_U_0_sin = signed_limb_lower_limb_target_x * lanes_12;
    const double t143 = limb5_S_rate_wx * platform_turn_zx + limb5_S_rate_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_rate_wz * platform_turn_zz + t143,
      t147 = limb5_S_rate_wx * platform_turn_xx + limb5_S_rate_wy * platform_turn_xy,
      platform_twist_wx = t147 + limb5_S_rate_wz * platform_turn_xz, t19 = 0.5 * platform_turn_xx,
      t65 = 0.5 * platform_turn_yy;
    /* limbs together: geometry */
    const lanes4 each_limb1_upper_position_x = (lanes4){t19, t27, t19, t27} - (lanes4){1.0, 1.0, -1.0, -1.0} *
        (lanes4){t20, t65, t20, t65},
      each_platform_twist_wz = {platform_twist_wz, platform_twist_wx, platform_twist_wz, platform_twist_wx};
    /* limbs together: loop closure; geometry; accelerations */
    const lanes4 lanes_17 = each_limb1_upper_position_x * each_platform_twist_wz;
    const double t155 = limb5_S_rate_wy * platform_turn_yy + limb5_S_rate_wx * platform_turn_yx, /* platform */
      platform_twist_wy = t155 + limb5_S_rate_wz * platform_turn_yz;
    const lanes4 each_platform_twist_wx = {platform_twist_wx, platform_twist_wy, platform_twist_wx,
        platform_twist_wy},
      lanes_19 = lanes_17 - signed_limb_lower_limb_target_y * each_platform_twist_wx,
      lanes_20 = lanes_19 * signed_limb_U_0_sin, signed_limb_U_0_cos = signed_limb_lower_limb_target_y * lanes_12,
      lanes_21 = lanes_19 * signed_limb_U_0_cos, lanes_22 = signed_limb_lower_limb_target_x *
          each_platform_twist_wx,
      lanes_23 = signed_limb_lower_limb_target_x * each_platform_twist_wz,
      each_platform_twist_wy = {platform_twist_wy, platform_twist_wz, platform_twist_wy, platform_twist_wz},
      lanes_25 = lanes_22 - each_limb1_upper_position_x * each_platform_twist_wy,
      lanes_27 = signed_limb_lower_limb_target_y * each_platform_twist_wy - lanes_23,
      lanes_29 = lanes_20 + lanes_25 * signed_limb_U_0_cos,
      limb_U_0_omega_z = lanes_12 * (lanes_25 * signed_limb_U_0_sin - lanes_21),
      signed_limb_lower_limb_target_z = each_limb1_upper_position_x + (lanes4){-param_R, param_R, -param_R,
          -param_R},
      limb_lower_limb_length = three_ups_upu_s_vector4_sqrt(lanes_11 + signed_limb_lower_limb_target_z *
          signed_limb_lower_limb_target_z),
      lanes_34 = 1.0 / limb_lower_limb_length, signed_limb_lower_sin = signed_limb_lower_limb_target_z * lanes_34,
      signed_limb_lower_cos = each_limb1_U_0_lever_mz_by_limb1_U2_fz * lanes_34,
      lanes_36 = signed_limb_lower_cos * lanes_29,
      signed_limb_lower_omega_z = lanes_34 * (lanes_27 * signed_limb_lower_cos - signed_limb_lower_sin * lanes_29),
      each_limb1_U2_opening_rate_fx = lanes_36 + lanes_27 * signed_limb_lower_sin,
      signed_limb_lower_omega_x = signed_limb_lower_sin * limb_U_0_omega_z,
      signed_limb_lower_omega_y = signed_limb_lower_cos * limb_U_0_omega_z,
      signed_limb_lower_alpha_y = signed_limb_lower_omega_z * signed_limb_lower_omega_x,
      signed_limb_lower_U_xy = signed_limb_lower_omega_x * signed_limb_lower_omega_y,
      lanes_39 = limb_lower_limb_length * (2.0 * signed_limb_lower_alpha_y),
      lanes_41 = each_limb1_U2_opening_rate_fx * ((-2.0) * signed_limb_lower_omega_y),
      signed_limb_upper_acc_z = lanes_39 + lanes_41;
    /* platform: accelerations; loop closure; momentum rate, eq. (35) */
    const double t174 = limb5_S_rate_wy * limb5_S_rate_wy, t175 = limb5_S_rate_wz * limb5_S_rate_wz,
      minus_platform_U_still_xx = t174 + t175, t176 = platform_turn_yx * minus_platform_U_still_xx,
      platform_U_still_xy = limb5_S_rate_wx * limb5_S_rate_wy, platform_U_yx = limb5_S_acc_wz + platform_U_still_xy,
      minus_platform_U_xy = limb5_S_acc_wz - platform_U_still_xy, t178 = t176 - platform_turn_yy * platform_U_yx,
      platform_U_still_xz = limb5_S_rate_wx * limb5_S_rate_wz,
      minus_platform_U_zx = limb5_S_acc_wy - platform_U_still_xz,
      t181 = 0.5 * (t178 + platform_turn_yz * minus_platform_U_zx),
      platform_U_xz = limb5_S_acc_wy + platform_U_still_xz, t133 = k13 * platform_U_still_xz,
      t182 = platform_turn_yx * platform_U_xz, platform_U_still_yz = limb5_S_rate_wy * limb5_S_rate_wz,
      minus_platform_U_yz = limb5_S_acc_wx - platform_U_still_yz,
      t184 = t182 - platform_turn_yy * minus_platform_U_yz, t185 = limb5_S_rate_wx * limb5_S_rate_wx,
      minus_platform_U_still_zz = t185 + t174, minus_platform_U_still_yy = t185 + t175,
      t188 = param_H * (t184 - platform_turn_yz * minus_platform_U_still_zz),
      t199 = platform_turn_zx * platform_U_xz - platform_turn_zy * minus_platform_U_yz,
      t231 = platform_turn_xx * platform_U_xz - platform_turn_xy * minus_platform_U_yz,
      t202 = param_H * (t199 - platform_turn_zz * minus_platform_U_still_zz),
      t234 = param_H * (t231 - platform_turn_xz * minus_platform_U_still_zz),
      t287 = platform_turn_zx * minus_platform_U_xy + platform_turn_zy * minus_platform_U_still_yy,
      platform_U_zy = limb5_S_acc_wx + platform_U_still_yz, t129 = k13 * platform_U_still_yz;
    /* platform: loop closure */
    const double t290 = 0.5 * (t287 - platform_turn_zz * platform_U_zy);
    const lanes4 lanes_42 = {t181, t202, t181, t202},
      lanes_46 = lanes_42 + (lanes4){1.0, 1.0, -1.0, -1.0} * (lanes4){t188, t290, t188, t290},
      lanes_47 = signed_limb_U_0_cos * lanes_46, lanes_48 = signed_limb_U_0_sin * lanes_46;
    const double t193 = platform_turn_zx * minus_platform_U_still_xx - platform_turn_zy * platform_U_yx,
      t225 = platform_turn_xx * minus_platform_U_still_xx - platform_turn_xy * platform_U_yx,
      t196 = 0.5 * (t193 + platform_turn_zz * minus_platform_U_zx),
      t228 = 0.5 * (t225 + platform_turn_xz * minus_platform_U_zx),
      t295 = platform_turn_xx * minus_platform_U_xy + platform_turn_xy * minus_platform_U_still_yy,
      t305 = platform_turn_yx * minus_platform_U_xy + platform_turn_yy * minus_platform_U_still_yy,
      t298 = 0.5 * (t295 - platform_turn_xz * platform_U_zy);
    const lanes4 lanes_49 = {t196, t234, t196, t234};
    /* limbs together: loop closure; accelerations; balance, eqs. (40)-(47) */
    const lanes4 lanes_53 = lanes_49 + (lanes4){1.0, 1.0, -1.0, -1.0} * (lanes4){t202, t298, t202, t298};
    const double t308 = 0.5 * (t305 - platform_turn_yz * platform_U_zy); /* platform */
    const lanes4 lanes_54 = {t228, t188, t228, t188},
      lanes_58 = lanes_54 + (lanes4){1.0, 1.0, -1.0, -1.0} * (lanes4){t234, t308, t234, t308},
      each_limb1_U2_opening_bias_fz = signed_limb_upper_acc_z + (lanes4){1.0, -1.0, 1.0, -1.0} * (lanes_47 -
          signed_limb_U_0_sin * lanes_53),
      limb_U_0_alpha_z = lanes_12 * each_limb1_U2_opening_bias_fz,
      lanes_64 = lanes_48 + signed_limb_U_0_cos * lanes_53,
      signed_limb_lower_alpha_y_2 = signed_limb_lower_alpha_y - signed_limb_lower_cos * limb_U_0_alpha_z,
      limb_U_0_rate_mz = k4 * limb_U_0_alpha_z,
      signed_limb_lower_U_zx_2 = signed_limb_lower_alpha_y + signed_limb_lower_alpha_y_2,
      lanes_67 = k9 * signed_limb_lower_alpha_y_2 + k10 * signed_limb_lower_alpha_y,
      lanes_68 = limb_lower_limb_length * signed_limb_lower_U_zx_2,
      signed_limb_lower_rate_fz = limb_lower_mx * signed_limb_lower_U_zx_2,
      lanes_69 = {gravity_z, gravity_z, -gravity_z, gravity_z};
    const double limb1_U_0_sin = signed_limb_U_0_sin[0];
    const lanes4 each_limb1_U_0_sin = {limb1_U_0_sin, signed_limb_U_0_cos[1], signed_limb_U_0_sin[2],
        signed_limb_U_0_cos[3]},
      signed_limb_upper_acc_z_2 = lanes_41 + (lanes_69 * each_limb1_U_0_sin + lanes_68),
      lanes_71 = limb_lower_limb_length * (limb_lower_m * signed_limb_upper_acc_z_2 - signed_limb_lower_rate_fz),
      lanes_72 = limb_lower_mx * signed_limb_upper_acc_z_2 - lanes_71,
      lanes_73 = {gravity_z_limb_lower_mx, gravity_z_limb_lower_mx, -gravity_z_limb_lower_mx,
          gravity_z_limb_lower_mx},
      lanes_75 = signed_limb_lower_cos * (lanes_72 - (lanes_67 + lanes_73 * each_limb1_U_0_sin)),
      limb_lower_joint_force_my = signed_limb_lower_sin * (k11 * (signed_limb_lower_omega_z *
          signed_limb_lower_omega_y)) + lanes_75,
      each_limb1_U2_part_fz = lanes_12 * (limb_lower_joint_force_my + limb_U_0_rate_mz),
      lanes_77 = signed_limb_lower_omega_y * signed_limb_lower_omega_y,
      lanes_78 = signed_limb_U_0_cos * each_limb1_U2_part_fz, lanes_79 = signed_limb_U_0_sin *
          each_limb1_U2_part_fz,
      lanes_81 = each_limb1_U2_opening_rate_fx * (2.0 * signed_limb_lower_omega_z),
      minus_limb_lower_rate_fx = limb_lower_mx * (lanes_77 + signed_limb_lower_omega_z * signed_limb_lower_omega_z);
    /* limbs together: accelerations; loop closure; balance, eqs. (40)-(47) */
    const lanes4 signed_limb_upper_acc_y = limb_lower_limb_length * signed_limb_lower_U_xy + lanes_81,
      lanes_86 = signed_limb_lower_sin * lanes_64 - signed_limb_lower_cos * lanes_58,
      signed_limb_lower_alpha_z = lanes_34 * (signed_limb_upper_acc_y - (lanes4){1.0, -1.0, 1.0, -1.0} * lanes_86),
      lanes_89 = signed_limb_lower_sin * lanes_58,
      signed_limb_lower_U_yx = signed_limb_lower_U_xy - signed_limb_lower_alpha_z,
      lanes_92 = k10 * signed_limb_lower_alpha_z - k9 * signed_limb_lower_U_xy,
      lanes_93 = limb_lower_limb_length * signed_limb_lower_U_yx,
      signed_limb_lower_rate_fy = limb_lower_mx * signed_limb_lower_U_yx,
      lanes_94 = {-gravity_z, gravity_z, gravity_z, gravity_z};
    const double minus_limb1_U_0_cos = signed_limb_U_0_cos[0];
    const lanes4 each_limb1_U_0_cos = {minus_limb1_U_0_cos, signed_limb_U_0_sin[1], signed_limb_U_0_cos[2],
        signed_limb_U_0_sin[3]},
      signed_limb_U_0_acc_y = lanes_94 * each_limb1_U_0_cos,
      lanes_97 = lanes_64 - (lanes4){1.0, -1.0, 1.0, -1.0} * signed_limb_U_0_acc_y,
      signed_limb_lower_acc_y = signed_limb_lower_sin * signed_limb_U_0_acc_y,
      signed_limb_upper_acc_y_2 = lanes_81 - (signed_limb_lower_acc_y - lanes_93);
    /* limbs together: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const lanes4 lanes_100 = limb_lower_limb_length * (limb_lower_m * signed_limb_upper_acc_y_2 -
        signed_limb_lower_rate_fy),
      signed_limb_lower_moment_z = lanes_92 - (lanes_100 - limb_lower_mx * (signed_limb_lower_acc_y +
          signed_limb_upper_acc_y_2)),
      each_limb1_U2_part_fy = lanes_34 * signed_limb_lower_moment_z,
      signed_limb_upper_acc_x = lanes_89 + signed_limb_lower_cos * lanes_97,
      limb_upper_rate_fx = minus_limb_lower_rate_fx + (lanes4){-limb_lower_m, limb_lower_m, -limb_lower_m,
          limb_lower_m} * signed_limb_upper_acc_x,
      lanes_106 = signed_limb_lower_cos * each_limb1_U2_part_fy,
      lanes_108 = signed_limb_lower_sin * each_limb1_U2_part_fy + signed_limb_lower_cos * limb_upper_rate_fx,
      lanes_110 = lanes_106 - signed_limb_lower_sin * limb_upper_rate_fx,
      lanes_112 = lanes_78 - signed_limb_U_0_sin * lanes_108, lanes_114 = lanes_79 + signed_limb_U_0_cos *
          lanes_108,
      lanes_115 = each_limb1_upper_position_x * lanes_112, lanes_116 = signed_limb_lower_limb_target_x * lanes_110,
      lanes_117 = lanes_115 - lanes_116, lanes_118 = signed_limb_lower_limb_target_y * lanes_110;
    /* platform: momentum rate, eq. (35) */
    const double minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - (t129 + k14 * limb5_S_acc_wx);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const double t501 = platform_turn_yx * minus_platform_rate_mx, t536 = platform_turn_xx * minus_platform_rate_mx,
      t132 = platform_turn_zx * minus_platform_rate_mx,
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (t133 - k14 * limb5_S_acc_wy),
      t137 = t132 - platform_turn_zy * platform_rate_my, platform_rate_mz = platform_Izz * limb5_S_acc_wz,
      t263 = t137 - platform_turn_zz * platform_rate_mz + lanes_117[0], t504 = platform_turn_yz * platform_rate_mz,
      t539 = platform_turn_xz * platform_rate_mz;
    const lanes4 lanes_120 = lanes_118 + each_limb1_upper_position_x * lanes_114;
    const double t354 = t263 + lanes_120[1], limb3_upper_position_x = each_limb1_upper_position_x[2],
      t427 = t354 + (limb3_upper_position_x * lanes_112[2] + (-lanes_116[2])),
      minus_platform_joint_force_mz = t427 - (-lanes_120[3]);
    const lanes4 lanes_121 = signed_limb_lower_limb_target_y * lanes_112;
    /* limb1: reciprocal wrenches, eq. (10); geometry; balance, eqs. (40)-(47) */
    const double t41 = platform_turn_yy * limb1_U_0_sin + platform_turn_zy * minus_limb1_U_0_cos,
      t46 = platform_turn_zy * limb1_U_0_sin, limb1_lower_cos = signed_limb_lower_cos[0],
      t42 = limb1_lower_cos * t41, limb1_lower_sin = -signed_limb_lower_sin[0], t572 = limb1_lower_sin * t41,
      limb1_U2_constraint_mn_couple_z = t42 - platform_turn_xy * limb1_lower_sin,
      minus_limb1_U2_part_fy_by_limb1_U2_mn = lanes_34[0] * limb1_U2_constraint_mn_couple_z,
      minus_limb1_U_0_force_y_by_limb1_U2_mn = limb1_lower_sin * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      limb1_U_0_force_z_by_limb1_U2_mn = limb1_lower_cos * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      limb1_U_0_joint_force_fx_by_limb1_U2_mn = limb1_U_0_sin * minus_limb1_U_0_force_y_by_limb1_U2_mn,
      limb1_U_0_joint_force_fy_by_limb1_U2_mn = minus_limb1_U_0_cos * minus_limb1_U_0_force_y_by_limb1_U2_mn,
      minus_limb1_U2_constraint_mn_couple_x = platform_turn_yy * minus_limb1_U_0_cos - t46,
      t512 = t501 - platform_turn_yy * platform_rate_my - t504 - (-lanes_120[0]), /* limb5_S */
      t540 = t536 - platform_turn_xy * platform_rate_my - t539, /* platform */
      limb1_U2_opening_mn = t572 + platform_turn_xy * limb1_lower_cos,
      t574 = limb1_U2_opening_mn * limb1_U2_opening_mn,
      minus_limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * minus_limb1_U2_constraint_mn_couple_x,
      minus_limb1_U2_part_fz_by_limb1_U2_mn = lanes_12[0] * minus_limb1_U_0_lever_mz_by_limb1_U2_mn,
      minus_limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * minus_limb1_U2_constraint_mn_couple_x,
      t59 = limb1_U_0_joint_force_fx_by_limb1_U2_mn - minus_limb1_U_0_cos * minus_limb1_U2_part_fz_by_limb1_U2_mn,
          /* platform */
      t50 = limb1_U_0_joint_force_fy_by_limb1_U2_mn + limb1_U_0_sin * minus_limb1_U2_part_fz_by_limb1_U2_mn,
          /* platform */
      minus_limb1_upper_position_x = each_limb1_upper_position_x[0],
      t60 = minus_limb1_upper_position_x * t59, /* platform */
      minus_limb1_lower_limb_target_y = signed_limb_lower_limb_target_y[0],
      t78 = minus_limb1_lower_limb_target_y * t59, /* platform */
      minus_limb1_lower_limb_target_x = signed_limb_lower_limb_target_x[0],
      t62 = t60 - minus_limb1_lower_limb_target_x * limb1_U_0_force_z_by_limb1_U2_mn, /* platform */
      t48 = minus_limb1_lower_limb_target_y * limb1_U_0_force_z_by_limb1_U2_mn;
    const lanes4 lanes_122 = signed_limb_lower_limb_target_y * signed_limb_lower_sin,
      lanes_123 = signed_limb_lower_limb_target_x * signed_limb_lower_sin;
    const double t56 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z,
      t44 = minus_limb1_U_0_cos * limb1_U2_constraint_mn_couple_z,
      platform_joint_force_mz_by_limb1_U2_mn = t56 + minus_limb1_U_0_cos * minus_limb1_U_0_lever_my_by_limb1_U2_mn +
          t62,
      t63 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn, /* platform */
      limb1_U2_part_mn = t63 * minus_platform_joint_force_mz,
      minus_base_lever_my_by_limb1_U2_mn = t44 - limb1_U_0_sin * minus_limb1_U_0_lever_my_by_limb1_U2_mn;
    const lanes4 each_base_lever_fy_by_limb1_U2_fx = signed_limb_U_0_sin * signed_limb_lower_cos,
      each_limb1_U2_closure_fx_by_limb5_S_wy = each_limb1_upper_position_x * (signed_limb_U_0_cos *
          signed_limb_lower_cos) - lanes_122,
      each_limb1_U2_closure_fx_by_limb5_S_wz = each_limb1_upper_position_x * each_base_lever_fy_by_limb1_U2_fx -
          lanes_123;
    const double t53 = minus_base_lever_my_by_limb1_U2_mn - (t48 - minus_limb1_upper_position_x * t50),
        /* platform */
      t525 = -lanes_118[2] - limb3_upper_position_x * lanes_114[2]; /* limb3 */
    const lanes4 lanes_127 = signed_limb_lower_limb_target_x * lanes_114 + lanes_121;
    const double t80 = minus_limb1_U_0_lever_mz_by_limb1_U2_mn - (minus_limb1_lower_limb_target_x * t50 - t78),
        /* platform */
      t533 = t512 - lanes_127[1] - t525 - lanes_127[3], /* limb5_S */
      t552 = t540 - lanes_127[0] + lanes_117[1] - lanes_127[2], /* limb5_S */
      t556 = t552 + lanes_117[3], /* limb5_S */
      minus_limb5_S_balance_wy = t53 * limb1_U2_part_mn + t533,
      minus_limb5_S_balance_wx = t80 * limb1_U2_part_mn + t556;
    const lanes4 each_limb1_U2_part_mn_by_limb2_P = each_limb1_U2_closure_fx_by_limb5_S_wy * t63,
      each_limb1_U2_part_mn_by_limb1_P = each_limb1_U2_closure_fx_by_limb5_S_wz * t63,
      each_limb5_S_balance_wx_by_limb2_P = each_limb1_U2_closure_fx_by_limb5_S_wz - t80 *
          each_limb1_U2_part_mn_by_limb2_P,
      each_limb5_S_balance_wx_by_limb1_P = t80 * each_limb1_U2_part_mn_by_limb1_P,
      each_limb5_S_balance_wy_by_limb1_P = each_limb1_U2_closure_fx_by_limb5_S_wy - t53 *
          each_limb1_U2_part_mn_by_limb1_P,
      each_limb5_S_balance_wy_by_limb2_P = t53 * each_limb1_U2_part_mn_by_limb2_P;
    /* limb5_S: balance, eqs. (40)-(47); drives */
    const double minus_limb5_S_balance_wx_by_limb2_P = each_limb5_S_balance_wx_by_limb2_P[1],
      t107 = minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wx_by_limb2_P,
      minus_limb5_S_balance_wx_by_limb1_P = each_limb5_S_balance_wx_by_limb1_P[0],
      t109 = t107 + minus_limb5_S_balance_wx_by_limb1_P * minus_limb5_S_balance_wx_by_limb1_P,
      minus_limb5_S_balance_wx_by_limb3_P = each_limb5_S_balance_wx_by_limb1_P[2],
      t110 = minus_limb5_S_balance_wx_by_limb3_P * minus_limb5_S_balance_wx_by_limb3_P + t109,
      minus_limb5_S_balance_wx_by_limb4_P = each_limb5_S_balance_wx_by_limb2_P[3];
    /* limb5_S: drives; balance, eqs. (40)-(47); pivots */
    const double drives_share_0_0 = minus_limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wx_by_limb4_P +
        t110,
      t534 = minus_limb5_S_balance_wy * drives_share_0_0,
      limb5_S_balance_wy_by_limb1_P = each_limb5_S_balance_wy_by_limb1_P[0],
      t123 = minus_limb5_S_balance_wx_by_limb1_P * limb5_S_balance_wy_by_limb1_P,
      minus_limb5_S_balance_wy_by_limb2_P = -each_limb5_S_balance_wy_by_limb2_P[1],
      t125 = t123 - minus_limb5_S_balance_wy_by_limb2_P * minus_limb5_S_balance_wx_by_limb2_P,
      limb5_S_balance_wy_by_limb3_P = each_limb5_S_balance_wy_by_limb1_P[2],
      t126 = minus_limb5_S_balance_wx_by_limb3_P * limb5_S_balance_wy_by_limb3_P + t125,
      limb5_S_balance_wy_by_limb4_P = each_limb5_S_balance_wy_by_limb2_P[3],
      minus_drives_share_0_1 = limb5_S_balance_wy_by_limb4_P * minus_limb5_S_balance_wx_by_limb4_P + t126,
      t562 = minus_limb5_S_balance_wy * minus_drives_share_0_1,
      t558 = t534 + minus_limb5_S_balance_wx * minus_drives_share_0_1,
      t127 = minus_drives_share_0_1 * minus_drives_share_0_1,
      t116 = limb5_S_balance_wy_by_limb1_P * limb5_S_balance_wy_by_limb1_P,
      t118 = t116 + minus_limb5_S_balance_wy_by_limb2_P * minus_limb5_S_balance_wy_by_limb2_P,
      t119 = limb5_S_balance_wy_by_limb3_P * limb5_S_balance_wy_by_limb3_P + t118,
      drives_share_1_1 = limb5_S_balance_wy_by_limb4_P * limb5_S_balance_wy_by_limb4_P + t119,
      value_determinant = drives_share_0_0 * drives_share_1_1 - t127,
      t563 = minus_limb5_S_balance_wx * drives_share_1_1 + t562, t128 = 1.0 / value_determinant, t559 = t128 * t558;
    const lanes4 each_limb5_S_balance_wy_by_limb1_P_2 = {limb5_S_balance_wy_by_limb1_P,
        minus_limb5_S_balance_wy_by_limb2_P, limb5_S_balance_wy_by_limb3_P, limb5_S_balance_wy_by_limb4_P},
      lanes_132 = (lanes4){1.0, -1.0, 1.0, 1.0} * each_limb5_S_balance_wy_by_limb1_P_2 * t559;
    const double t564 = t128 * t563;
    const lanes4 each_limb5_S_balance_wx_by_limb1_P_2 = {minus_limb5_S_balance_wx_by_limb1_P,
        minus_limb5_S_balance_wx_by_limb2_P, minus_limb5_S_balance_wx_by_limb3_P,
        minus_limb5_S_balance_wx_by_limb4_P},
      limb_P_drive = lanes_132 - each_limb5_S_balance_wx_by_limb1_P_2 * t564;
    u[0] = limb_P_drive[0];
    u[1] = -(-limb_P_drive[1]);
    u[2] = limb_P_drive[2];
    u[3] = limb_P_drive[3];
    const lanes4 every = (lanes4)((three_ups_upu_s_vector4_mask)(limb_P_drive) | ((limb_lower_limb_length <=
        (lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10}) & (limb_lower_limb_length >=
        -(lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10})) | ((each_limb1_U_0_lever_mz_by_limb1_U2_fz
        <= (lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10}) & (each_limb1_U_0_lever_mz_by_limb1_U2_fz
        >= -(lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10})));
    return fabs(platform_joint_force_mz_by_limb1_U2_mn) <= 4.0171000000000005e-10 || fabs(value_determinant) <=
        2.393867125597279e-10 || !(t7 >= 0.999999 && t7 <= 1.000001) || !(t574 <= 1.0e-12) ? (double)NAN :
        ((platform_joint_force_mz_by_limb1_U2_mn + value_determinant) + (every[0] + every[1])) + (every[2] +
        every[3]);
}
#endif

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_inverse_dynamics_platform_limb_by_limb(const double *restrict pose,
    const double *restrict rate, const double *restrict acceleration, double *restrict u)
{
    const int outcome = three_ups_upu_s_inverse_dynamics_platform_body(1, pose, rate, acceleration, u, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(u, 4);
    }
    return outcome;
}

int three_ups_upu_s_inverse_dynamics_platform(const double *restrict pose, const double *restrict rate,
    const double *restrict acceleration, double *restrict u)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    if (isfinite(three_ups_upu_s_inverse_dynamics_platform_packed_lane(pose, rate, acceleration, u))) {
        return 0;
    }
#endif
    return three_ups_upu_s_inverse_dynamics_platform_limb_by_limb(pose, rate, acceleration, u);
}
#endif /* THREE_UPS_UPU_S_VECTORS */
