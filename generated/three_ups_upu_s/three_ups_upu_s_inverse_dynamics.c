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
      t38 = sign1 * lower_cos, U_a_0 = IN_EACH4(READ, a, 0, 3),
      signed_lower_alpha_y = signed_lower_alpha_still_y - U_a_0 * t38,
      signed_lower_U_zx = signed_lower_alpha_still_y + signed_lower_alpha_y,
      t11 = k9 * signed_lower_alpha_still_y + k8 * signed_lower_alpha_y,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      signed_lower_rate_fz = limb_lower_mx * signed_lower_U_zx,
      t6 = upper_offset_x * signed_lower_U_zx + each_gravity_z * signed_U_0_sin, signed_lower_omega_y = U_v_0 * t38,
      lower_U_still_xy = signed_lower_omega_x * signed_lower_omega_y, P_v = IN_EACH4(READ, v, 2, 3),
      signed_upper_acc_z = P_v * (2.0 * signed_lower_omega_y) - t6,
      t7 = upper_offset_x * (limb_lower_m * signed_upper_acc_z + signed_lower_rate_fz),
      signed_lower_moment_y = limb_lower_mx * signed_upper_acc_z - t7 + (each_gravity_z_limb_lower_mx * signed_U_0_sin + t11),
      lower_joint_force_my = signed_lower_sin * (k10 * (U_v_1 * signed_lower_omega_y)) - t38 * signed_lower_moment_y,
      t19 = signed_lower_omega_y * signed_lower_omega_y, U_0_moment_z = lower_joint_force_my + k3 * U_a_0;
    OWN(signed_U_0_lever_mz_by_S_fz) = t38 * upper_offset_x;
    LIMB4 checked = OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(t1) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    /* each limb: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); accelerations */
    const LIMB4 signed_S_multiplier_fz = OWN(t1) * U_0_moment_z;
    OWN(t2) = t38 * OWN(t1);
    OWN(minus_S_arm_y) = each_param_R * lower_cos;
    const LIMB4 t13 = OWN(minus_S_arm_y) * signed_S_multiplier_fz, t36 = signed_lower_sin * t13, t14 = t38 * t13;
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    const LIMB4 t15 = OWN(S_arm_x) * signed_S_multiplier_fz;
    OWN(t6) = t36 + t38 * t15;
    const LIMB4 t17 = t14 - signed_lower_sin * t15, U_0_cos = IN_EACH4(SINES, cosine, 0, 2),
      U_a_1 = IN_EACH4(READ, a, 1, 3), t34 = signed_U_0_sin * t17, t18 = U_0_cos * t17,
      lower_U_yx = U_a_1 + lower_U_still_xy, t28 = k8 * lower_U_still_xy, t24 = upper_offset_x * lower_U_yx,
      lower_rate_fy = limb_lower_mx * lower_U_yx, signed_U_0_acc_y = each_gravity_z * U_0_cos,
      lower_acc_x = t38 * signed_U_0_acc_y, minus_lower_acc_y = signed_lower_sin * signed_U_0_acc_y,
      upper_moment_z = limb_lower_mx * minus_lower_acc_y,
      upper_acc_y = P_v * (2.0 * U_v_1) + (t24 - minus_lower_acc_y),
      t27 = limb_lower_mx * upper_acc_y - upper_offset_x * (limb_lower_m * upper_acc_y - lower_rate_fy),
      t31 = OWN(S_arm_x) * ((t27 + (upper_moment_z - (t28 + k9 * U_a_1))) * OWN(t2)),
      minus_lower_U_still_xx = t19 + U_v_1 * U_v_1,
      lower_force_x = limb_lower_m * (IN_EACH4(READ, a, 2, 3) - (upper_offset_x * minus_lower_U_still_xx - lower_acc_x)),
      t32 = OWN(minus_S_arm_y) * (limb_lower_mx * minus_lower_U_still_xx + lower_force_x) - t31;
    OWN(t5) = t34 - U_0_cos * t32;
    OWN(t4) = t18 + signed_U_0_sin * t32;
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
    OWN(t8) = OWN(limb5_S_balance_wx_by_P) * OWN(limb5_S_balance_wx_by_P);
    OWN(minus_limb5_S_balance_wy_by_P) = IN_EACH4(SINES, cosine, 0, 2) * OWN(minus_S_arm_y) + t1;
    OWN(t3) = OWN(minus_limb5_S_balance_wy_by_P) * OWN(limb5_S_balance_wx_by_P);
    OWN(t7) = OWN(minus_limb5_S_balance_wy_by_P) * OWN(minus_limb5_S_balance_wy_by_P);
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
      t54 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t54,
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
    const REAL t30 = limb5_S_q_qx * t29, t44 = limb5_S_q_qw * t29, t31 = limb5_S_q_qw * t13, t43 = limb5_S_q_qx * t13,
      platform_turn_xy = t30 - t31, platform_turn_yx = t30 + t31,
      limb1_U2_constraint_mn_couple_z = t28 - limb1_lower_sin * platform_turn_xy,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * (limb1_U2_constraint_mn_couple_z * limbs.t2[0]),
      platform_joint_force_mz_by_limb1_U2_mn = t36 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    REAL checked0 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t38 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      t35 = t24 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const EACH4 platform_joint_force_mx_by_limb1_U2_mn_2 = {t35, platform_joint_force_mx_by_limb1_U2_mn, t35, platform_joint_force_mx_by_limb1_U2_mn},
      platform_joint_force_mx_by_U2_mn = {platform_joint_force_mx_by_limb1_U2_mn, t35, platform_joint_force_mx_by_limb1_U2_mn, t35};
    NEXT_LIMB(1, inverse_dynamics, 0, stride, q, v, a, sine, cosine, &limbs);
    FIRST_LIMB(1, inverse_dynamics, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, &limbs);
    NEXT_LIMB(0, inverse_dynamics, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, &limbs);
    const REAL t41 = limbs.t3[1] + limbs.t3[0];
    NEXT_LIMB(2, inverse_dynamics, 0, stride, q, v, a, sine, cosine, &limbs);
    NEXT_LIMB(2, inverse_dynamics, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, &limbs);
    const REAL t42 = limbs.t3[2] + t41;
    NEXT_LIMB(3, inverse_dynamics, 0, stride, q, v, a, sine, cosine, &limbs);
    NEXT_LIMB(3, inverse_dynamics, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, &limbs);
    const REAL minus_drives_share_0_1 = limbs.t3[3] + t42, t85 = minus_drives_share_0_1 * minus_drives_share_0_1,
      drives_share_1_1 = limbs.t8[3] + (limbs.t7[2] + (limbs.t8[1] + limbs.t7[0])),
      drives_share_0_0 = limbs.t7[3] + (limbs.t8[2] + (limbs.t7[1] + limbs.t8[0])),
      minus_determinant = t85 - drives_share_1_1 * drives_share_0_0;
    REAL checked1 = minus_determinant;
    const REAL t89 = 1.0 / minus_determinant, limb5_S_v_wz = READ(v, 14);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35); drives */
    const REAL minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      minus_platform_rate_mx = minus_platform_moment_x - (k12 * (READ(v, 13) * limb5_S_v_wz) + k13 * READ(a, 12)),
      t63 = platform_turn_xx * minus_platform_rate_mx, t75 = platform_turn_yx * minus_platform_rate_mx,
      platform_turn_zx = t43 - t44, platform_turn_xz = t43 + t44, t48 = platform_turn_zx * minus_platform_rate_mx,
      platform_moment_y = gravity_z_platform_mz * platform_turn_zx,
      platform_rate_my = platform_moment_y - (k12 * (READ(v, 12) * limb5_S_v_wz) - k13 * READ(a, 13)),
      t53 = t48 - platform_turn_zy * platform_rate_my, t65 = t63 - platform_turn_xy * platform_rate_my,
      t77 = t75 - platform_turn_yy * platform_rate_my, platform_rate_mz = platform_Izz * READ(a, 14),
      minus_platform_joint_force_mz = limbs.t4[3] - (limbs.t4[2] - (limbs.t4[1] + (t53 - platform_turn_zz * platform_rate_mz - limbs.t4[0]))),
      limb1_U2_part_mn = t38 * minus_platform_joint_force_mz,
      t61 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn, t74 = t35 * limb1_U2_part_mn,
      t79 = t77 - platform_turn_yz * platform_rate_mz,
      minus_platform_joint_force_mx = limbs.t5[3] + (t65 - platform_turn_xz * platform_rate_mz - limbs.t6[0] + limbs.t5[1] - limbs.t6[2]),
      limb5_S_balance_wx = t61 - minus_platform_joint_force_mx,
      minus_limb5_S_balance_wy = t74 + (limbs.t5[2] - (limbs.t6[1] - (t79 + limbs.t5[0])) - limbs.t6[3]),
      t93 = minus_drives_share_0_1 * minus_limb5_S_balance_wy - drives_share_1_1 * limb5_S_balance_wx,
      t90 = (minus_drives_share_0_1 * limb5_S_balance_wx - drives_share_0_0 * minus_limb5_S_balance_wy) * t89,
      t94 = t89 * t93;
    const EACH4 given = {t90, t94, t90, t94}, given_2 = {t94, t90, t94, t90};
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
        SMALL4(limbs.signed_U_0_lever_mz_by_S_fz, 6.233100000000001e-10, 6.3211e-10, 6.4044e-10, 6.284e-10) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10), /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 signed_S_arm_y, upper_offset_x, minus_U_0_lever_mz_by_S_fz, t1, S_arm_x, t2,
      signed_limb5_S_balance_wy_by_P, signed_limb5_S_balance_wx_by_P, t3, t4, t5, signed_upper_position_x,
      signed_U_joint_rate_1, t6, t7, t8, t9, signed_lower_omega_y, signed_lower_omega_x,
      signed_lower_alpha_still_x, U_joint_acc_still_0, signed_upper_moment_y, signed_lower_alpha_still_y,
      t10, signed_U_0_acc_x, t11, t12, minus_lower_U_still_xx, minus_lower_rate_fx, minus_U_0_acc_y,
      minus_upper_acc_still_x, t13, signed_P_joint_acc_still, signed_lower_acc_y, signed_upper_moment_z,
      signed_lower_U_still_xy, t14, t15, t16, t17, t18, t19, checked;
} LIMBS(inverse_dynamics_independent);

STAGE(inverse_dynamics_independent, 0)(size_t limb, size_t stride, const double *restrict q,
    const double *restrict sine, const double *restrict cosine, LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: reciprocal wrenches, eq. (10); geometry; rates that follow */
    OWN(signed_S_arm_y) = param_R * lower_cos;
    OWN(upper_offset_x) = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(S_arm_x) = OWN(upper_offset_x) - param_R * signed_lower_sin;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * OWN(upper_offset_x);
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = sign1 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    OWN(signed_upper_position_x) = signed_lower_sin * OWN(upper_offset_x) + (-param_R);
    OWN(checked) = checked;
}

STAGE(inverse_dynamics_independent, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, const EACH4 platform_joint_force_mx_by_limb1_U2_mn,
    const EACH4 platform_joint_force_mx_by_U2_mn, REAL limb5_S_joint_rate_wz,
    const EACH4 signed_limb5_S_joint_rate_wy, const EACH4 given_2, REAL given_3, const EACH4 given_4,
    const EACH4 signed_limb5_S_joint_rate_wx, LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, 1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0),
      each_gravity_z = -sign2 * gravity_z;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: balance, eqs. (40)-(47); drives; velocities, eq. (6) */
    const LIMB4 signed_limb1_U2_part_mn_by_P = signed_U_0_sin * OWN(signed_S_arm_y) * given,
      t1 = GIVEN(platform_joint_force_mx_by_limb1_U2_mn) * signed_limb1_U2_part_mn_by_P;
    OWN(signed_limb5_S_balance_wx_by_P) = GIVEN(platform_joint_force_mx_by_U2_mn) * signed_limb1_U2_part_mn_by_P;
    OWN(t4) = OWN(signed_limb5_S_balance_wx_by_P) * OWN(signed_limb5_S_balance_wx_by_P);
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    OWN(signed_limb5_S_balance_wy_by_P) = U_0_cos * OWN(signed_S_arm_y) + t1;
    OWN(t3) = OWN(signed_limb5_S_balance_wy_by_P) * OWN(signed_limb5_S_balance_wx_by_P);
    OWN(t5) = OWN(signed_limb5_S_balance_wy_by_P) * OWN(signed_limb5_S_balance_wy_by_P);
    const LIMB4 t4 = signed_U_0_sin * limb5_S_joint_rate_wz + U_0_cos * GIVEN(signed_limb5_S_joint_rate_wy);
    OWN(signed_U_joint_rate_1) = OWN(t2) * (OWN(S_arm_x) * t4);
    const LIMB4 t43 = sign1 * (OWN(signed_S_arm_y) * t4), signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: accelerations; velocities, eq. (6) */
    const LIMB4 t6 = signed_lower_sin * OWN(signed_U_joint_rate_1), lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t39 = param_R * t6, t8 = sign1 * (lower_cos * t43) - sign1 * (OWN(upper_offset_x) * t6),
      t20 = OWN(signed_upper_position_x) * (U_0_cos * limb5_S_joint_rate_wz - signed_U_0_sin * GIVEN(signed_limb5_S_joint_rate_wy)),
      signed_U_joint_rate_0 = GIVEN(signed_limb5_S_joint_rate_wx) + sign2 * (OWN(t1) * t20);
    OWN(signed_lower_omega_x) = signed_lower_sin * signed_U_joint_rate_0;
    const LIMB4 t22 = t8 * signed_U_joint_rate_0, t9 = t8 * GIVEN(given_2);
    OWN(t7) = signed_U_0_sin * given_3 + sign2 * (U_0_cos * GIVEN(given_4));
    const LIMB4 t40 = OWN(t7) * t39, t27 = t22 - OWN(signed_upper_position_x) * (signed_U_joint_rate_0 * OWN(t7)),
      t11 = lower_cos * OWN(signed_U_joint_rate_1), t31 = OWN(t7) * (t43 + (-param_R) * t11),
      t13 = signed_lower_sin * t43 + OWN(upper_offset_x) * t11;
    OWN(t6) = sign2 * (U_0_cos * given_3) - signed_U_0_sin * GIVEN(given_4);
    OWN(t8) = t9 - sign2 * (t13 * OWN(t6) - t27);
    const LIMB4 t33 = OWN(t6) * signed_U_joint_rate_0;
    OWN(signed_lower_omega_y) = lower_cos * signed_U_joint_rate_0;
    OWN(signed_lower_alpha_still_x) = OWN(signed_U_joint_rate_1) * OWN(signed_lower_omega_y);
    const LIMB4 t34 = OWN(S_arm_x) * t33;
    OWN(t13) = t40 + OWN(signed_S_arm_y) * t33;
    OWN(t9) = t31 - (sign1 * (t43 * OWN(signed_U_joint_rate_1)) + t34);
    OWN(t11) = t43 * (2.0 * OWN(signed_lower_omega_y));
    const LIMB4 t38 = OWN(signed_lower_omega_y) * OWN(signed_lower_omega_y);
    OWN(minus_lower_U_still_xx) = OWN(signed_U_joint_rate_1) * OWN(signed_U_joint_rate_1) + t38;
    const LIMB4 minus_upper_acc_still_x = OWN(upper_offset_x) * OWN(minus_lower_U_still_xx);
    OWN(t16) = t43 * (2.0 * OWN(signed_U_joint_rate_1));
    OWN(minus_U_0_acc_y) = each_gravity_z * U_0_cos;
    OWN(minus_upper_acc_still_x) = lower_cos * OWN(minus_U_0_acc_y) + minus_upper_acc_still_x;
}

STAGE(inverse_dynamics_independent, 2)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL limb5_S_joint_acc_still_wz, LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: balance, eqs. (40)-(47) */
    OWN(signed_upper_moment_y) = gravity_z_limb_lower_mx * signed_U_0_sin;
    /* each limb: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    OWN(signed_U_0_acc_x) = gravity_z * signed_U_0_sin;
    OWN(minus_lower_rate_fx) = limb_lower_mx * OWN(minus_lower_U_still_xx);
    const LIMB4 t3 = OWN(t8) - OWN(signed_upper_position_x) * (IN_EACH4(SINES, cosine, 0, 2) * limb5_S_joint_acc_still_wz);
    OWN(U_joint_acc_still_0) = OWN(t1) * t3;
    OWN(signed_lower_alpha_still_y) = OWN(signed_U_joint_rate_1) * OWN(signed_lower_omega_x);
    OWN(t10) = k9 * OWN(signed_lower_alpha_still_y);
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(t12) = signed_lower_sin * (k10 * OWN(signed_lower_alpha_still_x));
    const LIMB4 t4 = signed_U_0_sin * limb5_S_joint_acc_still_wz;
    OWN(signed_P_joint_acc_still) = OWN(signed_S_arm_y) * t4 - OWN(t13);
    OWN(t15) = OWN(t9) + OWN(S_arm_x) * t4;
    OWN(signed_lower_acc_y) = signed_lower_sin * OWN(minus_U_0_acc_y);
    OWN(signed_upper_moment_z) = limb_lower_mx * OWN(signed_lower_acc_y);
    OWN(signed_lower_U_still_xy) = OWN(signed_lower_omega_y) * OWN(signed_lower_omega_x);
    OWN(t14) = k8 * OWN(signed_lower_U_still_xy);
}

STAGE(inverse_dynamics_independent, 3)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, const EACH4 limb5_S_joint_acc_wy,
    const EACH4 limb5_S_joint_acc_wx, LIMBS(inverse_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), each_k3 = -sign1 * k3, sign2 = OF4(1.0, 1.0, -1.0, -1.0),
      sign3 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 t40 = sign1 * GIVEN(limb5_S_joint_acc_wy), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: accelerations; momentum rate, eq. (35) */
    const LIMB4 t21 = U_0_cos * t40,
      t6 = GIVEN(limb5_S_joint_acc_wx) - OWN(t1) * (OWN(signed_upper_position_x) * (U_0_cos * given - signed_U_0_sin * t40)),
      U_joint_acc_0 = t6 + OWN(U_joint_acc_still_0), lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      signed_lower_alpha_y = OWN(signed_lower_alpha_still_y) + sign1 * (lower_cos * U_joint_acc_0),
      signed_U_0_rate_mz = each_k3 * U_joint_acc_0,
      signed_lower_U_zx = OWN(signed_lower_alpha_still_y) + signed_lower_alpha_y,
      signed_lower_rate_my = OWN(signed_upper_moment_y) - (OWN(t10) + k8 * signed_lower_alpha_y),
      signed_upper_acc_z = OWN(signed_U_0_acc_x) - OWN(upper_offset_x) * signed_lower_U_zx + OWN(t11);
    /* each limb: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const LIMB4 t11 = OWN(upper_offset_x) * (limb_lower_mx * signed_lower_U_zx + limb_lower_m * signed_upper_acc_z),
      signed_U_0_moment_z = signed_U_0_rate_mz + (lower_cos * (signed_lower_rate_my + (t11 - limb_lower_mx * signed_upper_acc_z)) + OWN(t12)),
      signed_S_multiplier_fz = OWN(t1) * signed_U_0_moment_z, t14 = OWN(S_arm_x) * signed_S_multiplier_fz,
      t16 = OWN(signed_S_arm_y) * signed_S_multiplier_fz, signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      t15 = signed_lower_sin * t14;
    OWN(t19) = lower_cos * t14 + signed_lower_sin * t16;
    const LIMB4 t42 = sign2 * (t15 - lower_cos * t16), t36 = signed_U_0_sin * t42, t19 = U_0_cos * t42,
      t22 = signed_U_0_sin * given + t21, signed_U_joint_acc_1 = OWN(t2) * (OWN(S_arm_x) * t22 + OWN(t15)),
      minus_upper_acc_x = OWN(minus_upper_acc_still_x) - sign3 * (OWN(signed_S_arm_y) * t22 + OWN(signed_P_joint_acc_still)),
      t24 = OWN(signed_S_arm_y) * (OWN(minus_lower_rate_fx) - limb_lower_m * minus_upper_acc_x),
      signed_lower_U_yx = OWN(signed_lower_U_still_xy) + signed_U_joint_acc_1,
      signed_lower_rate_mz = OWN(signed_upper_moment_z) + (OWN(t14) + k9 * signed_U_joint_acc_1),
      signed_upper_acc_y = OWN(t16) + (OWN(signed_lower_acc_y) + OWN(upper_offset_x) * signed_lower_U_yx),
      t31 = OWN(upper_offset_x) * (limb_lower_mx * signed_lower_U_yx - limb_lower_m * signed_upper_acc_y),
      t33 = OWN(S_arm_x) * (OWN(t2) * (signed_lower_rate_mz - (t31 + limb_lower_mx * signed_upper_acc_y))),
      t34 = t24 + sign3 * t33;
    OWN(t18) = t36 - U_0_cos * t34;
    OWN(t17) = t19 + signed_U_0_sin * t34;
}

STAGE(inverse_dynamics_independent, 4)(size_t limb, size_t stride, double *restrict u, const EACH4 given,
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
      t81 = t2 + t4, t9 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t9 * t10, t51 = k2 - 0.5 * t7,
      platform_turn_xx = 1.0 - t6 * t9, platform_turn_zz = 1.0 - t9 * t81, t13 = limb5_S_q_qz * t9,
      t14 = limb5_S_q_qy * t13, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t29 = limb5_S_q_qy * t9,
      platform_turn_zy = t14 + t16, platform_turn_yz = t14 - t16, limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_sin = SINES(sine, 0),
      t27 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t28 = limb1_lower_cos * t27, /* limb1 */
      t114 = limb1_lower_sin * t27, /* limb1 */
      t30 = limb5_S_q_qx * t29, t80 = limb5_S_q_qw * t29, t31 = limb5_S_q_qw * t13, t79 = limb5_S_q_qx * t13,
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
      t92 = platform_turn_xy * platform_omega_y, platform_turn_zx = t79 - t80, platform_turn_xz = t79 + t80,
      t94 = platform_turn_zx * limb5_S_joint_rate_wz,
      platform_omega_x = t94 + (platform_turn_yx * limb5_S_joint_rate_wy - platform_turn_xx * minus_limb5_S_joint_rate_wx),
      t99 = t92 + platform_turn_xx * platform_omega_x, t83 = platform_turn_zz * limb5_S_joint_rate_wz,
      platform_omega_z = t83 + (platform_turn_yz * limb5_S_joint_rate_wy - platform_turn_xz * minus_limb5_S_joint_rate_wx),
      t100 = platform_turn_xz * platform_omega_z + t99,
      t104 = platform_turn_yy * platform_omega_y + platform_turn_yx * platform_omega_x,
      t105 = platform_turn_yz * platform_omega_z + t104;
    const EACH4 given_2 = {t100, t105, t100, t105}, given_4 = {t105, t100, t105, t100};
    const REAL t210 = k12 * (platform_omega_z * platform_omega_y),
      t109 = platform_turn_zy * platform_omega_y + platform_turn_zx * platform_omega_x,
      platform_U_still_xz = platform_omega_z * platform_omega_x, t110 = platform_turn_zz * platform_omega_z + t109,
      t202 = k12 * platform_U_still_xz;
    const EACH4 signed_limb5_S_joint_rate_wy = {limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx},
      signed_limb5_S_joint_rate_wx = {minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy};
    const REAL t19 = limb1_U2_constraint_mn_couple_x - limbs.signed_S_arm_y[0] * minus_limb1_U_factor_0_by_3, /* limb1 */
      t20 = limb1_lower_cos * t19, /* limb1 */
      t39 = limb1_lower_sin * t19, /* limb1 */
      t21 = limbs.S_arm_x[0] * minus_limb1_U_factor_0_by_3, /* limb1 */
      t23 = t20 + limb1_lower_sin * t21, /* limb1 */
      platform_joint_force_mx_by_limb1_U2_mn = t39 - limb1_lower_cos * t21,
      platform_joint_force_mz_by_limb1_U2_mn = limb1_U_0_cos * t23 + t37;
    REAL checked2 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t38 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn, t35 = limb1_U_0_sin * t23 - t34;
    const EACH4 platform_joint_force_mx_by_limb1_U2_mn_2 = {t35, platform_joint_force_mx_by_limb1_U2_mn, t35, platform_joint_force_mx_by_limb1_U2_mn},
      platform_joint_force_mx_by_U2_mn = {platform_joint_force_mx_by_limb1_U2_mn, t35, platform_joint_force_mx_by_limb1_U2_mn, t35};
    FIRST_LIMB(0, inverse_dynamics_independent, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, given_2, t110, given_4, signed_limb5_S_joint_rate_wx, &limbs);
    const REAL t112 = limb1_U_factor_1_by_3 * limbs.t9[0], t111 = minus_limb1_U_factor_0_by_3 * limbs.t8[0];
    /* limb1: loop closure */
    const REAL t120 = limb1_lower_cos * t100 - limb1_lower_sin * limbs.t6[0] + limbs.signed_lower_omega_y[0],
      t137 = limbs.signed_U_joint_rate_1[0] * t120, t113 = limbs.signed_U_joint_rate_1[0] - limbs.t7[0],
      t141 = limb1_U2_constraint_mn_couple_x * (t137 - t113 * limbs.signed_lower_omega_y[0] + limbs.signed_lower_alpha_still_x[0]),
      t121 = limb1_U2_constraint_mn_couple_x * t120,
      t127 = limb1_lower_sin * t100 + limb1_lower_cos * limbs.t6[0] + limbs.signed_lower_omega_x[0],
      t136 = limb1_U2_constraint_mn_couple_z * (limbs.signed_lower_omega_y[0] * t127 - t120 * limbs.signed_lower_omega_x[0]),
      t142 = t136 - t141, t128 = limb1_U2_constraint_mn_couple_z * t120,
      limb1_U2_opening_mn = t114 + limb1_lower_cos * platform_turn_xy,
      t123 = t113 * (limb1_U2_opening_mn * t113 + t121);
    /* limb5_S: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL t143 = t112 - (t123 + t127 * (t128 + limb1_U2_opening_mn * t127) - t142),
      limb5_S_joint_acc_still_wz = t57 * (t111 + t143), t146 = 0.5 * (t54 * limb5_S_joint_acc_still_wz),
      t152 = 0.5 * (t52 * t100 - t66 * t110 - t64 * t105), t153 = t110 * t152,
      t159 = 0.5 * (t66 * t105 - t54 * t100 - t64 * t110), t180 = t64 * t100, t161 = t153 - t105 * t159,
      t176 = t100 * t159, t177 = t54 * t110, t175 = 0.5 * (t66 * limb5_S_joint_acc_still_wz),
      t167 = 0.5 * (t52 * t110 + (t54 * t105 + t66 * t100)),
      t172 = t146 + (READ(y_ddot, 0) - 0.5 * (t161 - t100 * t167)), t173 = t53 * t172, t195 = t69 * t172,
      t185 = t105 * t167, t184 = t176 - t110 * (0.5 * (t177 - t52 * t105 - t180)),
      t189 = t175 - (READ(y_ddot, 1) - 0.5 * (t184 - t185)), t196 = t62 * t189 + t195,
      limb5_S_joint_acc_wy = t71 * (t173 - t65 * t189), limb5_S_joint_acc_wx = t71 * t196,
      t193 = t57 * (t59 * limb5_S_joint_acc_wy), limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz + t193,
      t203 = platform_turn_zy * limb5_S_joint_acc_wz,
      t207 = k13 * (t203 + (platform_turn_yy * limb5_S_joint_acc_wy + platform_turn_xy * limb5_S_joint_acc_wx)),
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (t202 - t207),
      t235 = platform_turn_yy * platform_rate_my, t225 = platform_turn_xy * platform_rate_my,
      t209 = platform_turn_zy * platform_rate_my, minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      t211 = platform_turn_zx * limb5_S_joint_acc_wz, t197 = platform_turn_zz * limb5_S_joint_acc_wz,
      t215 = k13 * (t211 + (platform_turn_yx * limb5_S_joint_acc_wy + platform_turn_xx * limb5_S_joint_acc_wx)),
      minus_platform_rate_mx = minus_platform_moment_x - (t210 + t215);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t218 = t209 - platform_turn_zx * minus_platform_rate_mx,
      t237 = t235 - platform_turn_yx * minus_platform_rate_mx,
      t227 = t225 - platform_turn_xx * minus_platform_rate_mx,
      platform_rate_mz = platform_Izz * (t197 + (platform_turn_yz * limb5_S_joint_acc_wy + platform_turn_xz * limb5_S_joint_acc_wx)),
      t219 = platform_turn_zz * platform_rate_mz + t218, t238 = platform_turn_yz * platform_rate_mz + t237,
      t228 = platform_turn_xz * platform_rate_mz + t227;
    const EACH4 limb5_S_joint_acc_wy_2 = {limb5_S_joint_acc_wy, limb5_S_joint_acc_wx, limb5_S_joint_acc_wy, limb5_S_joint_acc_wx},
      limb5_S_joint_acc_wx_2 = {limb5_S_joint_acc_wx, limb5_S_joint_acc_wy, limb5_S_joint_acc_wx, limb5_S_joint_acc_wy};
    FIRST_LIMB(0, inverse_dynamics_independent, 2, stride, sine, cosine, limb5_S_joint_acc_still_wz, &limbs);
    FIRST_LIMB(0, inverse_dynamics_independent, 3, stride, sine, cosine, t193, limb5_S_joint_acc_wy_2, limb5_S_joint_acc_wx_2, &limbs);
    const REAL t220 = t219 + limbs.t17[0], t239 = t238 - limbs.t18[0], t229 = t228 - limbs.t19[0];
    NEXT_LIMB(1, inverse_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(1, inverse_dynamics_independent, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, given_2, t110, given_4, signed_limb5_S_joint_rate_wx, &limbs);
    NEXT_LIMB(1, inverse_dynamics_independent, 2, stride, sine, cosine, limb5_S_joint_acc_still_wz, &limbs);
    NEXT_LIMB(1, inverse_dynamics_independent, 3, stride, sine, cosine, t193, limb5_S_joint_acc_wy_2, limb5_S_joint_acc_wx_2, &limbs);
    const REAL t221 = t220 - limbs.t17[1], t240 = t239 - limbs.t19[1], t230 = t229 - limbs.t18[1];
    NEXT_LIMB(2, inverse_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(2, inverse_dynamics_independent, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, given_2, t110, given_4, signed_limb5_S_joint_rate_wx, &limbs);
    NEXT_LIMB(2, inverse_dynamics_independent, 2, stride, sine, cosine, limb5_S_joint_acc_still_wz, &limbs);
    NEXT_LIMB(2, inverse_dynamics_independent, 3, stride, sine, cosine, t193, limb5_S_joint_acc_wy_2, limb5_S_joint_acc_wx_2, &limbs);
    const REAL t222 = t221 - limbs.t17[2], t241 = limbs.t18[2] + t240, t231 = limbs.t19[2] + t230;
    NEXT_LIMB(3, inverse_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(3, inverse_dynamics_independent, 1, stride, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn_2, platform_joint_force_mx_by_U2_mn, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, given_2, t110, given_4, signed_limb5_S_joint_rate_wx, &limbs);
    NEXT_LIMB(3, inverse_dynamics_independent, 2, stride, sine, cosine, limb5_S_joint_acc_still_wz, &limbs);
    NEXT_LIMB(3, inverse_dynamics_independent, 3, stride, sine, cosine, t193, limb5_S_joint_acc_wy_2, limb5_S_joint_acc_wx_2, &limbs);
    const REAL minus_limb1_U2_part_mn = t38 * (limbs.t17[3] + t222),
      t223 = platform_joint_force_mx_by_limb1_U2_mn * minus_limb1_U2_part_mn,
      limb5_S_balance_wy = t35 * minus_limb1_U2_part_mn + (limbs.t19[3] + t241),
      limb5_S_balance_wx = limbs.t18[3] + t231 - t223;
    /* mechanism: drives; pivots */
    const REAL minus_drives_share_0_1 = limbs.t3[3] + (limbs.t3[2] + (limbs.t3[1] + limbs.t3[0])),
      t245 = minus_drives_share_0_1 * limb5_S_balance_wy,
      drives_share_1_1 = limbs.t4[3] + (limbs.t5[2] + (limbs.t4[1] + limbs.t5[0])),
      t247 = t245 + drives_share_1_1 * limb5_S_balance_wx, t232 = minus_drives_share_0_1 * limb5_S_balance_wx,
      t43 = minus_drives_share_0_1 * minus_drives_share_0_1,
      drives_share_0_0 = limbs.t5[3] + (limbs.t4[2] + (limbs.t5[1] + limbs.t4[0])),
      minus_determinant = t43 - drives_share_1_1 * drives_share_0_0;
    REAL checked3 = minus_determinant;
    const REAL t243 = t232 + drives_share_0_0 * limb5_S_balance_wy, t49 = 1.0 / minus_determinant, t248 = t49 * t247,
      t244 = t49 * t243, t249 = -t248;
    const EACH4 given = {t244, t249, t244, t249}, given_2_2 = {t249, t244, t249, t244};
    FIRST_LIMB(0, inverse_dynamics_independent, 4, stride, u, given, given_2_2, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[0]);
    NEXT_LIMB(1, inverse_dynamics_independent, 4, stride, u, given, given_2_2, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, inverse_dynamics_independent, 4, stride, u, given, given_2_2, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, inverse_dynamics_independent, 4, stride, u, given, given_2_2, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10), /* where equations that are solved at once lose rank, as drives do at a singularity */
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
    /* each limb: velocities, eq. (6); accelerations; balance, eqs. (40)-(47) */
    OWN(t1) = 1.0 / IN_EACH4(READ, weights, 0, 1);
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      signed_lower_omega_x = U_v_0 * signed_lower_sin, U_v_1 = IN_EACH4(READ, v, 1, 3),
      signed_lower_alpha_still_y = U_v_1 * signed_lower_omega_x, lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t38 = sign1 * lower_cos, U_a_0 = IN_EACH4(READ, a, 0, 3),
      signed_lower_alpha_y = signed_lower_alpha_still_y - U_a_0 * t38,
      signed_lower_U_zx = signed_lower_alpha_still_y + signed_lower_alpha_y,
      t11 = k9 * signed_lower_alpha_still_y + k8 * signed_lower_alpha_y,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      signed_lower_rate_fz = limb_lower_mx * signed_lower_U_zx,
      t6 = upper_offset_x * signed_lower_U_zx + each_gravity_z * signed_U_0_sin, signed_lower_omega_y = U_v_0 * t38,
      lower_U_still_xy = signed_lower_omega_x * signed_lower_omega_y, P_v = IN_EACH4(READ, v, 2, 3),
      signed_upper_acc_z = P_v * (2.0 * signed_lower_omega_y) - t6,
      t7 = upper_offset_x * (limb_lower_m * signed_upper_acc_z + signed_lower_rate_fz),
      signed_lower_moment_y = limb_lower_mx * signed_upper_acc_z - t7 + (each_gravity_z_limb_lower_mx * signed_U_0_sin + t11),
      lower_joint_force_my = signed_lower_sin * (k10 * (U_v_1 * signed_lower_omega_y)) - t38 * signed_lower_moment_y,
      t19 = signed_lower_omega_y * signed_lower_omega_y, U_0_moment_z = lower_joint_force_my + k3 * U_a_0;
    OWN(signed_U_0_lever_mz_by_S_fz) = t38 * upper_offset_x;
    LIMB4 checked = OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(t2) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    /* each limb: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); accelerations */
    const LIMB4 signed_S_multiplier_fz = OWN(t2) * U_0_moment_z;
    OWN(t3) = t38 * OWN(t2);
    OWN(signed_S_arm_y) = param_R * lower_cos;
    const LIMB4 t13 = OWN(signed_S_arm_y) * signed_S_multiplier_fz, t36 = signed_lower_sin * t13, t14 = t38 * t13;
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    const LIMB4 t39 = sign1 * OWN(S_arm_x), t15 = t39 * signed_S_multiplier_fz;
    OWN(t8) = t36 + t38 * t15;
    const LIMB4 t17 = t14 - signed_lower_sin * t15, U_0_cos = IN_EACH4(SINES, cosine, 0, 2),
      U_a_1 = IN_EACH4(READ, a, 1, 3), t34 = signed_U_0_sin * t17, t18 = U_0_cos * t17,
      lower_U_yx = U_a_1 + lower_U_still_xy, t28 = k8 * lower_U_still_xy, t24 = upper_offset_x * lower_U_yx,
      lower_rate_fy = limb_lower_mx * lower_U_yx, signed_U_0_acc_y = each_gravity_z * U_0_cos,
      lower_acc_x = t38 * signed_U_0_acc_y, minus_lower_acc_y = signed_lower_sin * signed_U_0_acc_y,
      upper_moment_z = limb_lower_mx * minus_lower_acc_y,
      upper_acc_y = P_v * (2.0 * U_v_1) + (t24 - minus_lower_acc_y),
      t27 = limb_lower_mx * upper_acc_y - upper_offset_x * (limb_lower_m * upper_acc_y - lower_rate_fy),
      t31 = t39 * ((t27 + (upper_moment_z - (t28 + k9 * U_a_1))) * OWN(t3)),
      minus_lower_U_still_xx = t19 + U_v_1 * U_v_1,
      lower_force_x = limb_lower_m * (IN_EACH4(READ, a, 2, 3) - (upper_offset_x * minus_lower_U_still_xx - lower_acc_x)),
      t32 = OWN(signed_S_arm_y) * (limb_lower_mx * minus_lower_U_still_xx + lower_force_x) - t31;
    OWN(t7) = t34 - U_0_cos * t32;
    OWN(t6) = t18 + signed_U_0_sin * t32;
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
      t65 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t65,
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
    const REAL t30 = limb5_S_q_qx * t29, t55 = limb5_S_q_qw * t29, t31 = limb5_S_q_qw * t13, t54 = limb5_S_q_qx * t13,
      platform_turn_xy = t30 - t31, platform_turn_yx = t30 + t31,
      limb1_U2_constraint_mn_couple_z = t28 - limb1_lower_sin * platform_turn_xy,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * (limb1_U2_constraint_mn_couple_z * limbs.t3[0]),
      platform_joint_force_mz_by_limb1_U2_mn = t36 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    REAL checked1 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t38 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      t35 = t24 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    NEXT_LIMB(1, inverse_dynamics_preload, 0, stride, q, v, a, weights, sine, cosine, &limbs);
    REAL checked2 = ALONE(limbs.checked[1]);
    FIRST_LIMB(1, inverse_dynamics_preload, 1, stride, preload, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn, t35, &limbs);
    /* drives: drives; pivots; accelerations */
    const REAL t46 = limbs.t1[1] * limbs.signed_limb5_S_balance_wx_by_P[1],
      t47 = t46 * limbs.signed_limb5_S_balance_wy_by_P[1];
    NEXT_LIMB(0, inverse_dynamics_preload, 1, stride, preload, sine, cosine, t38, t35, platform_joint_force_mx_by_limb1_U2_mn, &limbs);
    const REAL t41 = limbs.t1[0] * limbs.signed_limb5_S_balance_wy_by_P[0],
      t49 = t47 + t41 * limbs.signed_limb5_S_balance_wx_by_P[0];
    NEXT_LIMB(2, inverse_dynamics_preload, 0, stride, q, v, a, weights, sine, cosine, &limbs);
    REAL checked3 = ALONE(limbs.checked[2]);
    NEXT_LIMB(2, inverse_dynamics_preload, 1, stride, preload, sine, cosine, t38, t35, platform_joint_force_mx_by_limb1_U2_mn, &limbs);
    const REAL t44 = limbs.t1[2] * limbs.signed_limb5_S_balance_wy_by_P[2],
      t50 = t44 * limbs.signed_limb5_S_balance_wx_by_P[2] + t49;
    NEXT_LIMB(3, inverse_dynamics_preload, 0, stride, q, v, a, weights, sine, cosine, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[3]);
    NEXT_LIMB(3, inverse_dynamics_preload, 1, stride, preload, sine, cosine, t38, platform_joint_force_mx_by_limb1_U2_mn, t35, &limbs);
    const REAL t42 = limbs.t1[3] * limbs.signed_limb5_S_balance_wx_by_P[3],
      minus_drives_share_1_0 = t42 * limbs.signed_limb5_S_balance_wy_by_P[3] + t50,
      t109 = minus_drives_share_1_0 * minus_drives_share_1_0,
      t114 = limbs.signed_limb5_S_balance_wx_by_P[1] * t46 + limbs.signed_limb5_S_balance_wy_by_P[0] * t41,
      t115 = limbs.signed_limb5_S_balance_wy_by_P[2] * t44 + t114,
      drives_share_1_1 = limbs.signed_limb5_S_balance_wx_by_P[3] * t42 + t115,
      t88 = limbs.t1[1] * limbs.signed_limb5_S_balance_wy_by_P[1],
      t89 = limbs.signed_limb5_S_balance_wy_by_P[1] * t88,
      t90 = limbs.t1[0] * limbs.signed_limb5_S_balance_wx_by_P[0],
      t92 = t89 + limbs.signed_limb5_S_balance_wx_by_P[0] * t90,
      t86 = limbs.t1[2] * limbs.signed_limb5_S_balance_wx_by_P[2],
      t93 = limbs.signed_limb5_S_balance_wx_by_P[2] * t86 + t92,
      t84 = limbs.t1[3] * limbs.signed_limb5_S_balance_wy_by_P[3],
      drives_share_0_0 = limbs.signed_limb5_S_balance_wy_by_P[3] * t84 + t93,
      minus_determinant = t109 - drives_share_1_1 * drives_share_0_0;
    checked1 = checked1 + minus_determinant;
    const REAL t117 = 1.0 / minus_determinant, limb5_S_v_wz = READ(v, 14),
      t53 = limbs.t4[3] - (limbs.t5[2] + (limbs.t4[1] - limbs.t5[0])),
      t96 = limbs.t5[3] - (limbs.t4[2] + (limbs.t5[1] - limbs.t4[0]));
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35); drives */
    const REAL minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      minus_platform_rate_mx = minus_platform_moment_x - (k12 * (READ(v, 13) * limb5_S_v_wz) + k13 * READ(a, 12)),
      t74 = platform_turn_xx * minus_platform_rate_mx, t98 = platform_turn_yx * minus_platform_rate_mx,
      platform_turn_zx = t54 - t55, platform_turn_xz = t54 + t55, t59 = platform_turn_zx * minus_platform_rate_mx,
      platform_moment_y = gravity_z_platform_mz * platform_turn_zx,
      platform_rate_my = platform_moment_y - (k12 * (READ(v, 12) * limb5_S_v_wz) - k13 * READ(a, 13)),
      t64 = t59 - platform_turn_zy * platform_rate_my, t76 = t74 - platform_turn_xy * platform_rate_my,
      t100 = t98 - platform_turn_yy * platform_rate_my, platform_rate_mz = platform_Izz * READ(a, 14),
      minus_platform_joint_force_mz = limbs.t6[2] + (limbs.t6[1] + (t64 - platform_turn_zz * platform_rate_mz - limbs.t6[0])) - limbs.t6[3],
      limb1_U2_part_mn = t38 * minus_platform_joint_force_mz,
      t72 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn, t97 = t35 * limb1_U2_part_mn,
      t105 = limbs.t7[2] + (limbs.t8[1] - (t100 - platform_turn_yz * platform_rate_mz + limbs.t7[0])),
      minus_platform_joint_force_mx = limbs.t8[2] + (t76 - platform_turn_xz * platform_rate_mz - limbs.t8[0] + limbs.t7[1]) - limbs.t7[3],
      t82 = t53 + (t72 - minus_platform_joint_force_mx), t106 = t96 + (t97 + (limbs.t8[3] - t105)),
      t122 = minus_drives_share_1_0 * t106 - drives_share_1_1 * t82,
      t118 = (minus_drives_share_1_0 * t82 - drives_share_0_0 * t106) * t117, t123 = t117 * t122,
      limb1_P_preload = READ(preload, 0);
    RESULT(checked2, u, 0, limb1_P_preload - (t41 * t118 + t90 * t123));
    const REAL limb2_P_preload = READ(preload, 1);
    RESULT(checked3, u, 1, limb2_P_preload + (t46 * t118 + t88 * t123));
    const REAL limb3_P_preload = READ(preload, 2), t132 = t42 * t118; /* limb4 */
    RESULT(checked0, u, 2, limb3_P_preload + (t44 * t118 + t86 * t123));
    const REAL limb4_P_preload = READ(preload, 3);
    RESULT(checked1, u, 3, limb4_P_preload - (t132 + t84 * t123));
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
        SMALL4(limbs.signed_U_0_lever_mz_by_S_fz, 6.233100000000001e-10, 6.3211e-10, 6.4044e-10, 6.284e-10) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10) OR /* where equations that are solved at once lose rank, as drives do at a singularity */
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
      signed_lower_cos, t4, t5, signed_U_0_sin, t6, t7, signed_lower_U_yx, t8, minus_lower_U_xx, t9, t10,
      signed_lower_alpha_x, t11, U_0_alpha_z, signed_lower_U_zx_2, t12, t13, t14, t15, t16, t17, t18,
      signed_limb5_S_balance_wy_by_P, minus_limb5_S_balance_wx_by_P, t19, t20, t21, t22;
} LIMBS(inverse_dynamics_platform);

STAGE(inverse_dynamics_platform, 0)(size_t limb, size_t stride, REAL given, REAL given_2, REAL given_3,
    REAL given_4, REAL given_5, REAL given_6, REAL platform_twist_wz, REAL platform_twist_wx,
    REAL platform_twist_wy, REAL given_7, REAL given_8, REAL given_9, REAL given_10, REAL given_11,
    REAL given_12, LIMBS(inverse_dynamics_platform) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0),
      each_param_R = -sign2 * param_R, sign3 = OF4(1.0, -1.0, 1.0, -1.0);
    /* each limb: geometry; reciprocal wrenches, eq. (10); loop closure */
    OWN(signed_lower_limb_target_x) = given_5 - sign1 * given_6;
    const LIMB4 t1 = OWN(signed_lower_limb_target_x) * OWN(signed_lower_limb_target_x);
    OWN(signed_lower_limb_target_y) = given - sign1 * given_2;
    const LIMB4 t3 = t1 + OWN(signed_lower_limb_target_y) * OWN(signed_lower_limb_target_y);
    OWN(signed_upper_position_x) = given_3 - sign1 * given_4;
    const LIMB4 signed_lower_limb_target_z = OWN(signed_upper_position_x) + each_param_R;
    OWN(lower_limb_length) = SQRT4(t3 + signed_lower_limb_target_z * signed_lower_limb_target_z);
    OWN(signed_U_0_lever_mz_by_S_fz) = SQRT4(t3);
    OWN(t1) = 1.0 / OWN(lower_limb_length);
    OWN(signed_lower_sin) = signed_lower_limb_target_z * OWN(t1);
    OWN(t2) = OWN(signed_lower_limb_target_y) * OWN(signed_lower_sin);
    OWN(t16) = OWN(signed_lower_limb_target_x) * OWN(signed_lower_sin);
    OWN(signed_lower_cos) = OWN(signed_U_0_lever_mz_by_S_fz) * OWN(t1);
    OWN(t3) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(signed_U_0_cos) = OWN(signed_lower_limb_target_y) * OWN(t3);
    const LIMB4 signed_base_lever_fx_by_S_fx = OWN(signed_U_0_cos) * OWN(signed_lower_cos);
    /* each limb: loop closure; velocities, eq. (6); accelerations */
    OWN(t4) = OWN(signed_upper_position_x) * signed_base_lever_fx_by_S_fx;
    OWN(t5) = OWN(signed_lower_limb_target_x) * signed_base_lever_fx_by_S_fx;
    OWN(signed_U_0_sin) = OWN(signed_lower_limb_target_x) * OWN(t3);
    const LIMB4 signed_base_lever_fz_by_S_fx = OWN(signed_U_0_sin) * OWN(signed_lower_cos);
    OWN(t6) = OWN(signed_lower_limb_target_y) * signed_base_lever_fz_by_S_fx;
    OWN(t15) = OWN(signed_upper_position_x) * signed_base_lever_fz_by_S_fx;
    const LIMB4 t11 = OWN(signed_upper_position_x) * platform_twist_wy,
      t6 = OWN(signed_upper_position_x) * platform_twist_wz,
      t12 = t11 - OWN(signed_lower_limb_target_x) * platform_twist_wx,
      t17 = OWN(signed_lower_limb_target_x) * platform_twist_wz, t13 = t12 * OWN(signed_U_0_cos),
      t24 = t12 * OWN(signed_U_0_sin), t8 = t6 - OWN(signed_lower_limb_target_y) * platform_twist_wx,
      t18 = t17 - OWN(signed_lower_limb_target_y) * platform_twist_wy, t14 = t13 - t8 * OWN(signed_U_0_sin),
      minus_U_0_omega_z = OWN(t3) * (t8 * OWN(signed_U_0_cos) + t24), t15 = OWN(signed_lower_cos) * t14,
      signed_lower_omega_z = OWN(t1) * (OWN(signed_lower_sin) * t14 - t18 * OWN(signed_lower_cos)),
      S_opening_rate_fx = t15 + t18 * OWN(signed_lower_sin);
    OWN(t7) = S_opening_rate_fx * (2.0 * signed_lower_omega_z);
    const LIMB4 signed_lower_omega_x = OWN(signed_lower_sin) * minus_U_0_omega_z,
      signed_lower_omega_y = OWN(signed_lower_cos) * minus_U_0_omega_z;
    OWN(signed_lower_alpha_x) = signed_lower_omega_z * signed_lower_omega_y;
    const LIMB4 signed_lower_U_xy = signed_lower_omega_x * signed_lower_omega_y,
      signed_lower_alpha_y = signed_lower_omega_z * signed_lower_omega_x,
      t38 = signed_lower_omega_z * signed_lower_omega_z,
      signed_upper_acc_y = OWN(t7) - OWN(lower_limb_length) * signed_lower_U_xy, t26 = given_7 + sign1 * given_8,
      t27 = OWN(signed_U_0_sin) * t26, t43 = OWN(signed_U_0_cos) * t26, t28 = given_9 + sign1 * given_10,
      t30 = t27 + OWN(signed_U_0_cos) * t28, t55 = sign3 * (t43 - OWN(signed_U_0_sin) * t28),
      t31 = OWN(signed_lower_sin) * t30, t39 = OWN(signed_lower_cos) * t30, t32 = given_11 + sign1 * given_12;
    OWN(t9) = t39 + OWN(signed_lower_sin) * t32;
    const LIMB4 signed_lower_alpha_z = OWN(t1) * (signed_upper_acc_y + sign3 * (t31 - OWN(signed_lower_cos) * t32));
    OWN(signed_lower_U_yx) = signed_lower_U_xy + signed_lower_alpha_z;
    OWN(t8) = k9 * signed_lower_alpha_z + k8 * signed_lower_U_xy;
    OWN(minus_lower_U_xx) = signed_lower_omega_y * signed_lower_omega_y + t38;
    OWN(t11) = S_opening_rate_fx * (2.0 * signed_lower_omega_y);
    OWN(U_0_alpha_z) = OWN(t3) * (OWN(lower_limb_length) * ((-2.0) * signed_lower_alpha_y) - OWN(t11) + t55);
    const LIMB4 signed_lower_alpha_y_2 = signed_lower_alpha_y + OWN(signed_lower_cos) * OWN(U_0_alpha_z);
    OWN(signed_lower_U_zx_2) = signed_lower_alpha_y + signed_lower_alpha_y_2;
    OWN(t12) = (-k8) * signed_lower_alpha_y_2 + (-k9) * signed_lower_alpha_y;
}

STAGE(inverse_dynamics_platform, 1)(size_t limb, size_t stride, REAL signed_U_0_cos, REAL signed_U_0_sin,
    LIMBS(inverse_dynamics_platform) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, -1.0), each_gravity_z = -sign1 * gravity_z,
      sign2 = OF4(1.0, -1.0, 1.0, -1.0), sign3 = OF4(1.0, 1.0, -1.0, 1.0), each_gravity_z_2 = sign3 * gravity_z,
      each_gravity_z_limb_lower_mx = sign3 * gravity_z_limb_lower_mx;
    /* each limb: accelerations; momentum rate, eq. (35) */
    const LIMB4 signed_U_0_acc_y = each_gravity_z * signed_U_0_cos,
      signed_lower_acc_y = OWN(signed_lower_sin) * signed_U_0_acc_y,
      lower_acc_x = OWN(signed_lower_cos) * signed_U_0_acc_y,
      signed_upper_acc_y = OWN(t7) + (signed_lower_acc_y - OWN(lower_limb_length) * OWN(signed_lower_U_yx)),
      signed_lower_rate_mz = OWN(t8) - limb_lower_mx * signed_lower_acc_y,
      signed_upper_rate_mz = limb_lower_mx * signed_upper_acc_y;
    /* each limb: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const LIMB4 t3 = OWN(lower_limb_length) * (limb_lower_m * signed_upper_acc_y + limb_lower_mx * OWN(signed_lower_U_yx)),
      signed_S_multiplier_fy = OWN(t1) * (t3 - signed_upper_rate_mz - signed_lower_rate_mz),
      t6 = OWN(signed_lower_cos) * signed_S_multiplier_fy, t17 = OWN(signed_lower_sin) * signed_S_multiplier_fy,
      minus_upper_acc_x = OWN(lower_limb_length) * OWN(minus_lower_U_xx),
      lower_force_x = limb_lower_m * (minus_upper_acc_x - sign2 * OWN(t9) - (minus_upper_acc_x - lower_acc_x)),
      upper_rate_fx = lower_force_x + limb_lower_mx * OWN(minus_lower_U_xx);
    OWN(t10) = t6 - OWN(signed_lower_sin) * upper_rate_fx;
    const LIMB4 t19 = t17 + OWN(signed_lower_cos) * upper_rate_fx,
      signed_upper_acc_z_2 = OWN(t11) - (each_gravity_z_2 * signed_U_0_sin - OWN(lower_limb_length) * OWN(signed_lower_U_zx_2)),
      signed_upper_rate_my = (-limb_lower_mx) * signed_upper_acc_z_2,
      t12 = OWN(lower_limb_length) * ((-limb_lower_m) * signed_upper_acc_z_2 - (-limb_lower_mx) * OWN(signed_lower_U_zx_2)),
      t15 = OWN(signed_lower_cos) * (signed_upper_rate_my - t12 - (OWN(t12) + each_gravity_z_limb_lower_mx * signed_U_0_sin)),
      signed_S_multiplier_fz = OWN(t3) * (k3 * OWN(U_0_alpha_z) - (OWN(signed_lower_sin) * (k10 * OWN(signed_lower_alpha_x)) - t15)),
      t21 = OWN(signed_U_0_cos) * signed_S_multiplier_fz;
    OWN(t13) = OWN(signed_U_0_sin) * signed_S_multiplier_fz + OWN(signed_U_0_cos) * t19;
    const LIMB4 t23 = OWN(signed_lower_limb_target_x) * OWN(t13);
    OWN(t17) = t21 - OWN(signed_U_0_sin) * t19;
    OWN(t22) = t23 + OWN(signed_lower_limb_target_y) * OWN(t17);
}

STAGE(inverse_dynamics_platform, 2)(size_t limb, size_t stride, REAL U_0_force_z_by_U2_mn, REAL given,
    REAL given_2, LIMBS(inverse_dynamics_platform) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0);
    const LIMB4 t5 = sign1 * (OWN(signed_upper_position_x) * given);
    /* each limb: balance, eqs. (40)-(47) */
    OWN(t14) = OWN(signed_lower_limb_target_y) * U_0_force_z_by_U2_mn - t5;
    const LIMB4 t6 = sign2 * (OWN(signed_lower_limb_target_x) * U_0_force_z_by_U2_mn);
    OWN(t18) = OWN(signed_upper_position_x) * given_2 - t6;
}

STAGE(inverse_dynamics_platform, 3)(size_t limb, size_t stride, REAL given, REAL given_2, REAL given_3,
    REAL given_4, REAL given_5, REAL given_6, REAL given_7, REAL given_8, REAL given_9,
    LIMBS(inverse_dynamics_platform) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0),
      sign3 = OF4(1.0, 1.0, 1.0, -1.0);
    /* each limb: balance, eqs. (40)-(47); drives */
    const LIMB4 signed_limb1_U2_part_mn_by_P = (sign2 * given_3 + given_4) * given_5,
      t1 = given_6 * signed_limb1_U2_part_mn_by_P;
    OWN(minus_limb5_S_balance_wx_by_P) = given_7 - sign3 * given_8 + sign1 * (given_9 * signed_limb1_U2_part_mn_by_P);
    OWN(t19) = OWN(minus_limb5_S_balance_wx_by_P) * OWN(minus_limb5_S_balance_wx_by_P);
    OWN(signed_limb5_S_balance_wy_by_P) = given + sign1 * given_2 - t1;
    OWN(t21) = OWN(minus_limb5_S_balance_wx_by_P) * OWN(signed_limb5_S_balance_wy_by_P);
    OWN(t20) = OWN(signed_limb5_S_balance_wy_by_P) * OWN(signed_limb5_S_balance_wy_by_P);
}

BODY(three_ups_upu_s_inverse_dynamics_platform)(size_t stride, const double *restrict pose,
    const double *restrict rate, const double *restrict acceleration, double *restrict u,
    double *restrict total)
{
    LIMBS(inverse_dynamics_platform) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_pose_qw = READ(pose, 0), limb5_S_pose_qx = READ(pose, 1),
      t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx, limb5_S_pose_qy = READ(pose, 2),
      t3 = t1 + t2, t4 = limb5_S_pose_qy * limb5_S_pose_qy, limb5_S_pose_qz = READ(pose, 3),
      t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7, t15 = t2 + t4,
      platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t15, platform_turn_xx = 1.0 - t6 * t9,
      t12 = limb5_S_pose_qy * t9, t19 = limb5_S_pose_qx * t12, t13 = limb5_S_pose_qw * t12,
      t10 = limb5_S_pose_qz * t9, t26 = limb5_S_pose_qw * (limb5_S_pose_qx * t9), t20 = limb5_S_pose_qw * t10,
      platform_turn_yx = t19 + t20, platform_turn_xy = t19 - t20;
    /* platform: accelerations; loop closure; momentum rate, eq. (35) */
    const REAL limb5_S_rate_wy = READ(rate, 1), t54 = limb5_S_rate_wy * limb5_S_rate_wy,
      limb5_S_rate_wz = READ(rate, 2), t55 = limb5_S_rate_wz * limb5_S_rate_wz, minus_platform_U_still_xx = t54 + t55,
      limb5_S_rate_wx = READ(rate, 0), t56 = platform_turn_yx * minus_platform_U_still_xx,
      platform_U_still_xy = limb5_S_rate_wx * limb5_S_rate_wy, limb5_S_acc_wz = READ(acceleration, 2),
      platform_U_yx = limb5_S_acc_wz + platform_U_still_xy,
      minus_platform_U_xy = limb5_S_acc_wz - platform_U_still_xy, t58 = t56 - platform_turn_yy * platform_U_yx,
      t24 = limb5_S_pose_qy * t10, t11 = limb5_S_pose_qx * t10, platform_turn_yz = t24 - t26,
      platform_turn_zy = t24 + t26, platform_U_still_xz = limb5_S_rate_wx * limb5_S_rate_wz,
      limb5_S_acc_wy = READ(acceleration, 1), minus_platform_U_zx = limb5_S_acc_wy - platform_U_still_xz,
      t61 = 0.5 * (t58 + platform_turn_yz * minus_platform_U_zx),
      platform_U_xz = limb5_S_acc_wy + platform_U_still_xz, t136 = k12 * platform_U_still_xz,
      t62 = platform_turn_yx * platform_U_xz, platform_U_still_yz = limb5_S_rate_wy * limb5_S_rate_wz,
      limb5_S_acc_wx = READ(acceleration, 0), minus_platform_U_yz = limb5_S_acc_wx - platform_U_still_yz,
      t64 = t62 - platform_turn_yy * minus_platform_U_yz, t65 = limb5_S_rate_wx * limb5_S_rate_wx,
      minus_platform_U_still_zz = t65 + t54, minus_platform_U_still_yy = t65 + t55;
    /* platform: loop closure; geometry; velocities, eq. (6) */
    const REAL t68 = param_H * (t64 - platform_turn_yz * minus_platform_U_still_zz), platform_turn_zx = t11 - t13,
      platform_turn_xz = t11 + t13,
      t83 = platform_turn_zx * minus_platform_U_still_xx - platform_turn_zy * platform_U_yx,
      t101 = platform_turn_xx * minus_platform_U_still_xx - platform_turn_xy * platform_U_yx,
      t86 = 0.5 * (t83 + platform_turn_zz * minus_platform_U_zx),
      t104 = 0.5 * (t101 + platform_turn_xz * minus_platform_U_zx),
      t71 = platform_turn_zx * platform_U_xz - platform_turn_zy * minus_platform_U_yz,
      t89 = platform_turn_xx * platform_U_xz - platform_turn_xy * minus_platform_U_yz,
      t74 = param_H * (t71 - platform_turn_zz * minus_platform_U_still_zz),
      t92 = param_H * (t89 - platform_turn_xz * minus_platform_U_still_zz),
      t45 = limb5_S_rate_wx * platform_turn_zx + limb5_S_rate_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_rate_wz * platform_turn_zz + t45,
      t48 = limb5_S_rate_wx * platform_turn_xx + limb5_S_rate_wy * platform_turn_xy,
      platform_twist_wx = t48 + limb5_S_rate_wz * platform_turn_xz,
      t52 = limb5_S_rate_wy * platform_turn_yy + limb5_S_rate_wx * platform_turn_yx,
      platform_twist_wy = t52 + limb5_S_rate_wz * platform_turn_yz, t14 = 0.5 * platform_turn_zx,
      t18 = param_H * platform_turn_xz, t31 = 0.5 * platform_turn_yx, t27 = param_H * platform_turn_yz,
      t17 = param_H * platform_turn_zz, t23 = 0.5 * platform_turn_xx;
    FIRST_LIMB(0, inverse_dynamics_platform, 0, stride, t14, t17, t23, t18, t31, t27, platform_twist_wz, platform_twist_wx, platform_twist_wy, t61, t68, t86, t74, t104, t92, &limbs);
    NEXT_LIMB(2, inverse_dynamics_platform, 0, stride, t14, t17, t23, t18, t31, t27, platform_twist_wz, platform_twist_wx, platform_twist_wy, t61, t68, t86, t74, t104, t92, &limbs);
    /* limb1: reciprocal wrenches, eq. (10); loop closure; balance, eqs. (40)-(47) */
    const REAL t35 = platform_turn_yy * limbs.signed_U_0_sin[0] + platform_turn_zy * limbs.signed_U_0_cos[0],
      t186 = limbs.signed_lower_sin[0] * t35,
      limb1_U2_constraint_mn_couple_z = limbs.signed_lower_cos[0] * t35 + platform_turn_xy * limbs.signed_lower_sin[0],
      minus_limb1_U2_part_fy_by_limb1_U2_mn = limbs.t1[0] * limb1_U2_constraint_mn_couple_z,
      limb1_U_0_force_y_by_limb1_U2_mn = limbs.signed_lower_sin[0] * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      limb1_U_0_force_z_by_limb1_U2_mn = limbs.signed_lower_cos[0] * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      minus_limb1_U_0_joint_force_fy_by_limb1_U2_mn = limbs.signed_U_0_cos[0] * limb1_U_0_force_y_by_limb1_U2_mn,
      minus_limb1_U_0_joint_force_fx_by_limb1_U2_mn = limbs.signed_U_0_sin[0] * limb1_U_0_force_y_by_limb1_U2_mn,
      minus_limb1_U2_constraint_mn_couple_x = platform_turn_yy * limbs.signed_U_0_cos[0] - platform_turn_zy * limbs.signed_U_0_sin[0],
      limb1_U_0_lever_mz_by_limb1_U2_mn = limbs.signed_lower_sin[0] * minus_limb1_U2_constraint_mn_couple_x,
      minus_limb1_U_0_lever_my_by_limb1_U2_mn = limbs.signed_lower_cos[0] * minus_limb1_U2_constraint_mn_couple_x,
      limb1_U2_part_fz_by_limb1_U2_mn = limbs.t3[0] * limb1_U_0_lever_mz_by_limb1_U2_mn;
    /* platform: balance, eqs. (40)-(47); loop closure; drives */
    const REAL t112 = minus_limb1_U_0_joint_force_fy_by_limb1_U2_mn + limbs.signed_U_0_sin[0] * limb1_U2_part_fz_by_limb1_U2_mn,
      t117 = limbs.signed_U_0_cos[0] * limb1_U2_part_fz_by_limb1_U2_mn - minus_limb1_U_0_joint_force_fx_by_limb1_U2_mn;
    FIRST_LIMB(0, inverse_dynamics_platform, 2, stride, limb1_U_0_force_z_by_limb1_U2_mn, -t112, t117, &limbs);
    const REAL t122 = limbs.signed_lower_limb_target_x[0] * t112 + limbs.signed_lower_limb_target_y[0] * t117 - limb1_U_0_lever_mz_by_limb1_U2_mn,
      t114 = limbs.signed_U_0_sin[0] * limb1_U2_constraint_mn_couple_z, /* limb1 */
      t38 = limbs.signed_U_0_cos[0] * limb1_U2_constraint_mn_couple_z, /* limb1 */
      platform_joint_force_mz_by_limb1_U2_mn = t114 + limbs.signed_U_0_cos[0] * minus_limb1_U_0_lever_my_by_limb1_U2_mn + limbs.t18[0];
    REAL checked0 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t118 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      t113 = t38 - limbs.signed_U_0_sin[0] * minus_limb1_U_0_lever_my_by_limb1_U2_mn - limbs.t14[0];
    FIRST_LIMB(0, inverse_dynamics_platform, 3, stride, -limbs.t2[0], limbs.t4[0], limbs.t15[0], -limbs.t16[0], t118, t113, limbs.t5[0], limbs.t6[0], t122, &limbs);
    const REAL t77 = platform_turn_zx * minus_platform_U_xy + platform_turn_zy * minus_platform_U_still_yy,
      platform_U_zy = limb5_S_acc_wx + platform_U_still_yz, t132 = k12 * platform_U_still_yz,
      t80 = 0.5 * (t77 - platform_turn_zz * platform_U_zy),
      t95 = platform_turn_xx * minus_platform_U_xy + platform_turn_xy * minus_platform_U_still_yy,
      t107 = platform_turn_yx * minus_platform_U_xy + platform_turn_yy * minus_platform_U_still_yy,
      t98 = 0.5 * (t95 - platform_turn_xz * platform_U_zy), t110 = 0.5 * (t107 - platform_turn_yz * platform_U_zy),
      t21 = 0.5 * platform_turn_xy, t32 = 0.5 * platform_turn_zy, t30 = 0.5 * platform_turn_yy;
    NEXT_LIMB(1, inverse_dynamics_platform, 0, stride, t18, t21, t27, t30, t17, t32, platform_twist_wx, platform_twist_wy, platform_twist_wz, t74, t80, t92, t98, t68, t110, &limbs);
    NEXT_LIMB(3, inverse_dynamics_platform, 0, stride, t18, t21, t27, t30, t17, t32, platform_twist_wx, platform_twist_wy, platform_twist_wz, t74, t80, t92, t98, t68, t110, &limbs);
    NEXT_LIMB(1, inverse_dynamics_platform, 3, stride, limbs.t5[1], limbs.t6[1], limbs.t2[1], limbs.t4[1], t118, t113, limbs.t15[1], limbs.t16[1], t122, &limbs);
    const REAL t123 = limbs.t19[0] + limbs.t19[1];
    NEXT_LIMB(2, inverse_dynamics_platform, 3, stride, -limbs.t2[2], limbs.t4[2], limbs.t15[2], -limbs.t16[2], t118, t113, limbs.t5[2], limbs.t6[2], t122, &limbs);
    const REAL t124 = t123 + limbs.t19[2];
    NEXT_LIMB(3, inverse_dynamics_platform, 3, stride, limbs.t5[3], limbs.t6[3], -limbs.t2[3], limbs.t4[3], t118, t113, limbs.t15[3], -limbs.t16[3], t122, &limbs);
    const REAL drives_share_0_0 = t124 + limbs.t19[3],
      drives_share_1_1 = limbs.t20[0] + limbs.t20[1] + limbs.t20[2] + limbs.t20[3],
      t127 = drives_share_0_0 * drives_share_1_1,
      minus_drives_share_0_1 = limbs.t21[0] - limbs.t21[1] + limbs.t21[2] - limbs.t21[3],
      value_determinant = t127 - minus_drives_share_0_1 * minus_drives_share_0_1;
    REAL checked1 = value_determinant;
    const REAL t131 = 1.0 / value_determinant;
    FIRST_LIMB(0, inverse_dynamics_platform, 1, stride, limbs.signed_U_0_cos[0], limbs.signed_U_0_sin[0], &limbs);
    const REAL t154 = limbs.signed_upper_position_x[0] * limbs.t17[0], /* limb1 */
      t156 = t154 - limbs.signed_lower_limb_target_x[0] * limbs.t10[0], /* limb1 */
      minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - (t132 + k13 * limb5_S_acc_wx),
      t135 = platform_turn_yx * minus_platform_rate_mx, t162 = platform_turn_xx * minus_platform_rate_mx,
      t149 = platform_turn_zx * minus_platform_rate_mx,
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (t136 - k13 * limb5_S_acc_wy),
      t151 = t149 - platform_turn_zy * platform_rate_my, t140 = t135 - platform_turn_yy * platform_rate_my,
      t164 = t162 - platform_turn_xy * platform_rate_my,
      limb1_U2_opening_mn = platform_turn_xy * limbs.signed_lower_cos[0] - t186,
      t188 = limb1_U2_opening_mn * limb1_U2_opening_mn, platform_rate_mz = platform_Izz * limb5_S_acc_wz,
      t157 = t151 - platform_turn_zz * platform_rate_mz + t156, t142 = t140 - platform_turn_yz * platform_rate_mz,
      t167 = t164 - platform_turn_xz * platform_rate_mz - limbs.t22[0];
    NEXT_LIMB(1, inverse_dynamics_platform, 1, stride, limbs.signed_U_0_sin[1], limbs.signed_U_0_cos[1], &limbs);
    NEXT_LIMB(1, inverse_dynamics_platform, 2, stride, -limbs.t10[1], limbs.t13[1], limbs.t17[1], &limbs);
    const REAL t158 = t157 - limbs.t14[1], t168 = t167 + limbs.t18[1];
    NEXT_LIMB(2, inverse_dynamics_platform, 1, stride, limbs.signed_U_0_cos[2], limbs.signed_U_0_sin[2], &limbs);
    NEXT_LIMB(2, inverse_dynamics_platform, 2, stride, limbs.t10[2], limbs.t13[2], limbs.t17[2], &limbs);
    const REAL t169 = t168 - limbs.t22[2], t159 = t158 + limbs.t18[2];
    NEXT_LIMB(3, inverse_dynamics_platform, 1, stride, limbs.signed_U_0_sin[3], limbs.signed_U_0_cos[3], &limbs);
    NEXT_LIMB(3, inverse_dynamics_platform, 2, stride, limbs.t10[3], limbs.t13[3], limbs.t17[3], &limbs);
    const REAL limb1_U2_part_mn = (t159 + limbs.t14[3]) * t118, t160 = t113 * limb1_U2_part_mn,
      minus_limb5_S_balance_wx = t169 + limbs.t18[3] + t122 * limb1_U2_part_mn,
      t175 = minus_limb5_S_balance_wx * drives_share_1_1, t171 = minus_limb5_S_balance_wx * minus_drives_share_0_1,
      t143 = limbs.signed_lower_limb_target_y[0] * limbs.t10[0], /* limb1 */
      t148 = t142 + (t143 + limbs.signed_upper_position_x[0] * limbs.t13[0]) - limbs.t22[1] + limbs.t14[2],
      minus_limb5_S_balance_wy = t148 - limbs.t22[3] + t160,
      t177 = t175 + minus_limb5_S_balance_wy * minus_drives_share_0_1,
      t173 = t131 * (minus_limb5_S_balance_wy * drives_share_0_0 + t171), t178 = t131 * t177,
      limb1_P_drive = limbs.signed_limb5_S_balance_wy_by_P[0] * t173 - limbs.minus_limb5_S_balance_wx_by_P[0] * t178;
    WRITE(u, 0, limb1_P_drive);
    REAL checked2 = limb1_P_drive;
    const REAL limb3_P_drive = limbs.signed_limb5_S_balance_wy_by_P[2] * t173 - limbs.minus_limb5_S_balance_wx_by_P[2] * t178;
    WRITE(u, 2, limb3_P_drive);
    REAL checked3 = limb3_P_drive;
    const REAL minus_limb2_P_drive = limbs.minus_limb5_S_balance_wx_by_P[1] * t178 + limbs.signed_limb5_S_balance_wy_by_P[1] * t173;
    checked0 = checked0 + minus_limb2_P_drive;
    WRITE(u, 1, -minus_limb2_P_drive);
    const REAL minus_limb4_P_drive = limbs.minus_limb5_S_balance_wx_by_P[3] * t178 + limbs.signed_limb5_S_balance_wy_by_P[3] * t173;
    checked1 = checked1 + minus_limb4_P_drive;
    WRITE(u, 3, -minus_limb4_P_drive);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    /* else status 6: not on the mechanism */
    NOT_ABOVE(t188, 1.0e-12, 6);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.lower_limb_length, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR /* where the points of limb_lower coincide */
        SMALL4(limbs.signed_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(value_determinant, 2.393867125597279e-10), /* where equations that are solved at once lose rank, as drives do at a singularity */
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
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_inverse_dynamics_platform_packed_lane(const double *restrict pose,
    const double *restrict rate, const double *restrict acceleration, double *restrict u)
{
    typedef three_ups_upu_s_vector4 lanes4;
    const double limb5_S_pose_qw = pose[0], limb5_S_pose_qx = pose[1], limb5_S_pose_qy = pose[2],
      limb5_S_pose_qz = pose[3], limb5_S_rate_wx = rate[0], limb5_S_rate_wy = rate[1], limb5_S_rate_wz =
        rate[2],
      limb5_S_acc_wx = acceleration[0], limb5_S_acc_wy = acceleration[1], limb5_S_acc_wz = acceleration[2];
    /* platform: geometry; velocities, eq. (6) */
    const double t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx, t3 = t1 + t2,
      t4 = limb5_S_pose_qy * limb5_S_pose_qy, t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 +
        t6,
      t9 = 4.0 - 2.0 * t7, t37 = t2 + t5, platform_turn_zz = 1.0 - t9 * (t2 + t4), platform_turn_xx = 1.0 - t6
        * t9,
      platform_turn_yy = 1.0 - t9 * t37, t12 = limb5_S_pose_qy * t9, t21 = limb5_S_pose_qx * t12,
      t13 = limb5_S_pose_qw * t12, t10 = limb5_S_pose_qz * t9, t26 = limb5_S_pose_qw * (limb5_S_pose_qx * t9),
      t22 = limb5_S_pose_qw * t10, platform_turn_yx = t21 + t22, platform_turn_xy = t21 - t22,
      t23 = 0.5 * platform_turn_yx, t24 = limb5_S_pose_qy * t10, t11 = limb5_S_pose_qx * t10,
      platform_turn_yz = t24 - t26, platform_turn_zy = t24 + t26, t27 = param_H * platform_turn_yz,
      t74 = 0.5 * platform_turn_zy, t17 = param_H * platform_turn_zz;
    const lanes4 signed_limb_lower_limb_target_x = (lanes4){t23, t17, t23, t17} - (lanes4){1.0, 1.0, -1.0,
        -1.0} * (lanes4){t27, t74, t27, t74},
      lanes_5 = signed_limb_lower_limb_target_x * signed_limb_lower_limb_target_x;
    const double platform_turn_zx = t11 - t13, platform_turn_xz = t11 + t13, t14 = 0.5 * platform_turn_zx,
      t20 = param_H * platform_turn_xz, t76 = 0.5 * platform_turn_xy;
    const lanes4 signed_limb_lower_limb_target_y = (lanes4){t14, t20, t14, t20} - (lanes4){1.0, 1.0, -1.0,
        -1.0} * (lanes4){t17, t76, t17, t76},
      lanes_11 = lanes_5 + signed_limb_lower_limb_target_y * signed_limb_lower_limb_target_y,
      each_limb1_U_0_lever_mz_by_limb1_U2_fz = three_ups_upu_s_vector4_sqrt(lanes_11),
      lanes_12 = 1.0 / each_limb1_U_0_lever_mz_by_limb1_U2_fz,
      signed_limb_U_0_sin = signed_limb_lower_limb_target_x * lanes_12;
    const double t155 = limb5_S_rate_wx * platform_turn_zx + limb5_S_rate_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_rate_wz * platform_turn_zz + t155,
      t159 = limb5_S_rate_wx * platform_turn_xx + limb5_S_rate_wy * platform_turn_xy,
      platform_twist_wx = t159 + limb5_S_rate_wz * platform_turn_xz, t19 = 0.5 * platform_turn_xx,
      t73 = 0.5 * platform_turn_yy;
    /* limbs together: geometry */
    const lanes4 each_limb1_upper_position_x = (lanes4){t19, t27, t19, t27} - (lanes4){1.0, 1.0, -1.0, -1.0} *
        (lanes4){t20, t73, t20, t73},
      each_platform_twist_wz = {platform_twist_wz, platform_twist_wx, platform_twist_wz, platform_twist_wx};
    /* limbs together: loop closure; geometry; accelerations */
    const lanes4 lanes_17 = each_limb1_upper_position_x * each_platform_twist_wz;
    const double t167 = limb5_S_rate_wy * platform_turn_yy + limb5_S_rate_wx * platform_turn_yx, /* platform */
      platform_twist_wy = t167 + limb5_S_rate_wz * platform_turn_yz;
    const lanes4 each_platform_twist_wx = {platform_twist_wx, platform_twist_wy, platform_twist_wx,
        platform_twist_wy},
      lanes_19 = lanes_17 - signed_limb_lower_limb_target_y * each_platform_twist_wx,
      lanes_20 = lanes_19 * signed_limb_U_0_sin, signed_limb_U_0_cos = signed_limb_lower_limb_target_y *
        lanes_12,
      lanes_21 = lanes_19 * signed_limb_U_0_cos, lanes_22 = signed_limb_lower_limb_target_x *
        each_platform_twist_wx,
      lanes_23 = signed_limb_lower_limb_target_x * each_platform_twist_wz,
      each_platform_twist_wy = {platform_twist_wy, platform_twist_wz, platform_twist_wy, platform_twist_wz},
      lanes_25 = each_limb1_upper_position_x * each_platform_twist_wy - lanes_22,
      lanes_27 = lanes_23 - signed_limb_lower_limb_target_y * each_platform_twist_wy,
      lanes_29 = lanes_25 * signed_limb_U_0_cos - lanes_20,
      minus_limb_U_0_omega_z = lanes_12 * (lanes_21 + lanes_25 * signed_limb_U_0_sin),
      signed_limb_lower_limb_target_z = each_limb1_upper_position_x + (lanes4){-param_R, param_R, -param_R,
        -param_R},
      limb_lower_limb_length = three_ups_upu_s_vector4_sqrt(lanes_11 + signed_limb_lower_limb_target_z *
        signed_limb_lower_limb_target_z),
      lanes_34 = 1.0 / limb_lower_limb_length, signed_limb_lower_sin = signed_limb_lower_limb_target_z *
        lanes_34,
      signed_limb_lower_cos = each_limb1_U_0_lever_mz_by_limb1_U2_fz * lanes_34,
      lanes_36 = signed_limb_lower_cos * lanes_29,
      signed_limb_lower_omega_z = lanes_34 * (signed_limb_lower_sin * lanes_29 - lanes_27 *
        signed_limb_lower_cos),
      each_limb1_U2_opening_rate_fx = lanes_36 + lanes_27 * signed_limb_lower_sin,
      signed_limb_lower_omega_x = signed_limb_lower_sin * minus_limb_U_0_omega_z,
      signed_limb_lower_omega_y = signed_limb_lower_cos * minus_limb_U_0_omega_z,
      signed_limb_lower_alpha_y = signed_limb_lower_omega_z * signed_limb_lower_omega_x,
      signed_limb_lower_U_xy = signed_limb_lower_omega_x * signed_limb_lower_omega_y,
      lanes_39 = limb_lower_limb_length * ((-2.0) * signed_limb_lower_alpha_y),
      lanes_41 = each_limb1_U2_opening_rate_fx * (2.0 * signed_limb_lower_omega_y),
      signed_limb_upper_acc_z = lanes_39 - lanes_41;
    /* platform: accelerations; loop closure; momentum rate, eq. (35) */
    const double t185 = limb5_S_rate_wy * limb5_S_rate_wy, t186 = limb5_S_rate_wz * limb5_S_rate_wz,
      minus_platform_U_still_xx = t185 + t186, t187 = platform_turn_yx * minus_platform_U_still_xx,
      platform_U_still_xy = limb5_S_rate_wx * limb5_S_rate_wy, platform_U_yx = limb5_S_acc_wz +
        platform_U_still_xy,
      minus_platform_U_xy = limb5_S_acc_wz - platform_U_still_xy, t189 = t187 - platform_turn_yy *
        platform_U_yx,
      platform_U_still_xz = limb5_S_rate_wx * limb5_S_rate_wz,
      minus_platform_U_zx = limb5_S_acc_wy - platform_U_still_xz,
      t192 = 0.5 * (t189 + platform_turn_yz * minus_platform_U_zx),
      platform_U_xz = limb5_S_acc_wy + platform_U_still_xz, t145 = k12 * platform_U_still_xz,
      t193 = platform_turn_yx * platform_U_xz, platform_U_still_yz = limb5_S_rate_wy * limb5_S_rate_wz,
      minus_platform_U_yz = limb5_S_acc_wx - platform_U_still_yz,
      t195 = t193 - platform_turn_yy * minus_platform_U_yz, t196 = limb5_S_rate_wx * limb5_S_rate_wx,
      minus_platform_U_still_zz = t196 + t185, minus_platform_U_still_yy = t196 + t186,
      t199 = param_H * (t195 - platform_turn_yz * minus_platform_U_still_zz),
      t210 = platform_turn_zx * platform_U_xz - platform_turn_zy * minus_platform_U_yz,
      t226 = platform_turn_xx * platform_U_xz - platform_turn_xy * minus_platform_U_yz,
      t213 = param_H * (t210 - platform_turn_zz * minus_platform_U_still_zz),
      t229 = param_H * (t226 - platform_turn_xz * minus_platform_U_still_zz),
      t300 = platform_turn_zx * minus_platform_U_xy + platform_turn_zy * minus_platform_U_still_yy,
      platform_U_zy = limb5_S_acc_wx + platform_U_still_yz, t141 = k12 * platform_U_still_yz;
    /* platform: loop closure */
    const double t303 = 0.5 * (t300 - platform_turn_zz * platform_U_zy);
    const lanes4 lanes_42 = {t192, t213, t192, t213},
      lanes_46 = lanes_42 + (lanes4){1.0, 1.0, -1.0, -1.0} * (lanes4){t199, t303, t199, t303},
      lanes_47 = signed_limb_U_0_cos * lanes_46, lanes_48 = signed_limb_U_0_sin * lanes_46;
    const double t204 = platform_turn_zx * minus_platform_U_still_xx - platform_turn_zy * platform_U_yx,
      t220 = platform_turn_xx * minus_platform_U_still_xx - platform_turn_xy * platform_U_yx,
      t207 = 0.5 * (t204 + platform_turn_zz * minus_platform_U_zx),
      t223 = 0.5 * (t220 + platform_turn_xz * minus_platform_U_zx),
      t308 = platform_turn_xx * minus_platform_U_xy + platform_turn_xy * minus_platform_U_still_yy,
      t334 = platform_turn_yx * minus_platform_U_xy + platform_turn_yy * minus_platform_U_still_yy,
      t311 = 0.5 * (t308 - platform_turn_xz * platform_U_zy);
    const lanes4 lanes_49 = {t207, t229, t207, t229};
    /* limbs together: loop closure; accelerations; balance, eqs. (40)-(47) */
    const lanes4 lanes_53 = lanes_49 + (lanes4){1.0, 1.0, -1.0, -1.0} * (lanes4){t213, t311, t213, t311};
    const double t337 = 0.5 * (t334 - platform_turn_yz * platform_U_zy); /* platform */
    const lanes4 lanes_54 = {t223, t199, t223, t199},
      lanes_58 = lanes_54 + (lanes4){1.0, 1.0, -1.0, -1.0} * (lanes4){t229, t337, t229, t337},
      each_limb1_U2_opening_bias_fz = signed_limb_upper_acc_z + (lanes4){1.0, -1.0, 1.0, -1.0} * (lanes_47 -
        signed_limb_U_0_sin * lanes_53),
      limb_U_0_alpha_z = lanes_12 * each_limb1_U2_opening_bias_fz,
      lanes_64 = lanes_48 + signed_limb_U_0_cos * lanes_53,
      signed_limb_lower_alpha_y_2 = signed_limb_lower_alpha_y + signed_limb_lower_cos * limb_U_0_alpha_z,
      limb_U_0_rate_mz = k3 * limb_U_0_alpha_z,
      signed_limb_lower_U_zx_2 = signed_limb_lower_alpha_y + signed_limb_lower_alpha_y_2,
      lanes_67 = (-k8) * signed_limb_lower_alpha_y_2 + (-k9) * signed_limb_lower_alpha_y,
      lanes_68 = limb_lower_limb_length * signed_limb_lower_U_zx_2,
      signed_limb_lower_rate_fz = (-limb_lower_mx) * signed_limb_lower_U_zx_2,
      lanes_69 = {gravity_z, gravity_z, -gravity_z, gravity_z};
    const double limb1_U_0_sin = signed_limb_U_0_sin[0];
    const lanes4 each_limb1_U_0_sin = {limb1_U_0_sin, signed_limb_U_0_cos[1], signed_limb_U_0_sin[2],
        signed_limb_U_0_cos[3]},
      signed_limb_upper_acc_z_2 = lanes_41 - (lanes_69 * each_limb1_U_0_sin - lanes_68),
      lanes_71 = limb_lower_limb_length * ((-limb_lower_m) * signed_limb_upper_acc_z_2 -
        signed_limb_lower_rate_fz),
      lanes_72 = (-limb_lower_mx) * signed_limb_upper_acc_z_2 - lanes_71,
      lanes_73 = {gravity_z_limb_lower_mx, gravity_z_limb_lower_mx, -gravity_z_limb_lower_mx,
        gravity_z_limb_lower_mx},
      lanes_75 = signed_limb_lower_cos * (lanes_72 - (lanes_67 + lanes_73 * each_limb1_U_0_sin)),
      minus_limb_lower_joint_force_my = signed_limb_lower_sin * (k10 * (signed_limb_lower_omega_z *
        signed_limb_lower_omega_y)) - lanes_75,
      each_limb1_U2_part_fz = lanes_12 * (limb_U_0_rate_mz - minus_limb_lower_joint_force_my),
      lanes_77 = signed_limb_lower_omega_y * signed_limb_lower_omega_y,
      lanes_78 = signed_limb_U_0_cos * each_limb1_U2_part_fz, lanes_79 = signed_limb_U_0_sin *
        each_limb1_U2_part_fz,
      lanes_81 = each_limb1_U2_opening_rate_fx * (2.0 * signed_limb_lower_omega_z),
      minus_limb_lower_U_xx = lanes_77 + signed_limb_lower_omega_z * signed_limb_lower_omega_z,
      signed_limb_upper_acc_y = lanes_81 - limb_lower_limb_length * signed_limb_lower_U_xy,
      lanes_85 = signed_limb_lower_cos * lanes_64,
      lanes_87 = signed_limb_lower_sin * lanes_64 - signed_limb_lower_cos * lanes_58,
      signed_limb_lower_alpha_z = lanes_34 * (signed_limb_upper_acc_y + (lanes4){1.0, -1.0, 1.0, -1.0} *
        lanes_87),
      lanes_91 = lanes_85 + signed_limb_lower_sin * lanes_58,
      signed_limb_lower_U_yx = signed_limb_lower_U_xy + signed_limb_lower_alpha_z,
      lanes_94 = k9 * signed_limb_lower_alpha_z + k8 * signed_limb_lower_U_xy,
      lanes_95 = limb_lower_limb_length * signed_limb_lower_U_yx,
      signed_limb_lower_rate_fy = limb_lower_mx * signed_limb_lower_U_yx,
      lanes_96 = {-gravity_z, gravity_z, gravity_z, gravity_z};
    const double minus_limb1_U_0_cos = signed_limb_U_0_cos[0];
    const lanes4 each_limb1_U_0_cos = {minus_limb1_U_0_cos, signed_limb_U_0_sin[1], signed_limb_U_0_cos[2],
        signed_limb_U_0_sin[3]},
      signed_limb_U_0_acc_y = lanes_96 * each_limb1_U_0_cos,
      signed_limb_lower_acc_y = signed_limb_lower_sin * signed_limb_U_0_acc_y,
      signed_limb_upper_acc_y_2 = lanes_81 + (signed_limb_lower_acc_y - lanes_95),
      signed_limb_lower_rate_mz = lanes_94 - limb_lower_mx * signed_limb_lower_acc_y,
      limb_lower_acc_x = signed_limb_lower_cos * signed_limb_U_0_acc_y;
    /* limbs together: balance, eqs. (40)-(47); accelerations; loop closure */
    const lanes4 lanes_99 = limb_lower_limb_length * (limb_lower_m * signed_limb_upper_acc_y_2 +
        signed_limb_lower_rate_fy),
      each_limb1_U2_part_fy = lanes_34 * (lanes_99 - limb_lower_mx * signed_limb_upper_acc_y_2 -
        signed_limb_lower_rate_mz),
      minus_limb_upper_acc_x = limb_lower_limb_length * minus_limb_lower_U_xx,
      each_limb1_U2_opening_bias_fx = minus_limb_upper_acc_x - (lanes4){1.0, -1.0, 1.0, -1.0} * lanes_91,
      limb_lower_force_x = limb_lower_m * (each_limb1_U2_opening_bias_fx - (minus_limb_upper_acc_x -
        limb_lower_acc_x)),
      limb_upper_rate_fx = limb_lower_force_x + limb_lower_mx * minus_limb_lower_U_xx,
      lanes_105 = signed_limb_lower_cos * each_limb1_U2_part_fy,
      lanes_107 = signed_limb_lower_sin * each_limb1_U2_part_fy + signed_limb_lower_cos * limb_upper_rate_fx,
      lanes_109 = lanes_105 - signed_limb_lower_sin * limb_upper_rate_fx,
      lanes_111 = lanes_78 - signed_limb_U_0_sin * lanes_107, lanes_113 = lanes_79 + signed_limb_U_0_cos *
        lanes_107;
    /* limb1: reciprocal wrenches, eq. (10); geometry; balance, eqs. (40)-(47) */
    const double t41 = platform_turn_yy * limb1_U_0_sin + platform_turn_zy * minus_limb1_U_0_cos,
      limb1_lower_cos = signed_limb_lower_cos[0], t42 = limb1_lower_cos * t41,
      limb1_lower_sin = -signed_limb_lower_sin[0], t582 = limb1_lower_sin * t41,
      limb1_U2_constraint_mn_couple_z = t42 - platform_turn_xy * limb1_lower_sin,
      minus_limb1_U2_part_fy_by_limb1_U2_mn = lanes_34[0] * limb1_U2_constraint_mn_couple_z,
      minus_limb1_U_0_force_y_by_limb1_U2_mn = limb1_lower_sin * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      limb1_U_0_force_z_by_limb1_U2_mn = limb1_lower_cos * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      limb1_U_0_joint_force_fx_by_limb1_U2_mn = limb1_U_0_sin * minus_limb1_U_0_force_y_by_limb1_U2_mn,
      limb1_U_0_joint_force_fy_by_limb1_U2_mn = minus_limb1_U_0_cos * minus_limb1_U_0_force_y_by_limb1_U2_mn,
      minus_limb1_U2_constraint_mn_couple_x = platform_turn_yy * minus_limb1_U_0_cos - platform_turn_zy *
        limb1_U_0_sin,
      minus_limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * minus_limb1_U2_constraint_mn_couple_x,
      minus_limb1_U2_part_fz_by_limb1_U2_mn = lanes_12[0] * minus_limb1_U_0_lever_mz_by_limb1_U2_mn,
      minus_limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * minus_limb1_U2_constraint_mn_couple_x,
      t59 = limb1_U_0_joint_force_fx_by_limb1_U2_mn - minus_limb1_U_0_cos * minus_limb1_U2_part_fz_by_limb1_U2_mn, /* platform */
      t50 = limb1_U_0_joint_force_fy_by_limb1_U2_mn + limb1_U_0_sin * minus_limb1_U2_part_fz_by_limb1_U2_mn; /* platform */
    const lanes4 lanes_115 = each_limb1_upper_position_x * (lanes4){t59, lanes_111[1], lanes_111[2],
        lanes_111[3]};
    const double minus_limb1_lower_limb_target_y = signed_limb_lower_limb_target_y[0],
      t68 = minus_limb1_lower_limb_target_y * t59; /* platform */
    const lanes4 each_limb1_U_0_force_z_by_limb1_U2_mn = {limb1_U_0_force_z_by_limb1_U2_mn, -lanes_109[1],
        lanes_109[2], lanes_109[3]},
      lanes_116 = signed_limb_lower_limb_target_x * each_limb1_U_0_force_z_by_limb1_U2_mn,
      lanes_119 = lanes_115 - (lanes4){1.0, -1.0, 1.0, 1.0} * lanes_116,
      lanes_120 = signed_limb_lower_limb_target_y * each_limb1_U_0_force_z_by_limb1_U2_mn;
    const double t56 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z,
      t44 = minus_limb1_U_0_cos * limb1_U2_constraint_mn_couple_z,
      platform_joint_force_mz_by_limb1_U2_mn = t56 + minus_limb1_U_0_cos *
        minus_limb1_U_0_lever_my_by_limb1_U2_mn + lanes_119[0],
      t63 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn; /* platform */
    /* limbs together: reciprocal wrenches, eq. (10); loop closure; balance, eqs. (40)-(47) */
    const lanes4 each_base_lever_fz_by_limb1_U2_fx = signed_limb_U_0_cos * signed_limb_lower_cos;
    const double minus_base_lever_my_by_limb1_U2_mn = t44 - limb1_U_0_sin *
        minus_limb1_U_0_lever_my_by_limb1_U2_mn;
    const lanes4 each_base_lever_fy_by_limb1_U2_fx = signed_limb_U_0_sin * signed_limb_lower_cos;
    const double limb1_U2_opening_mn = t582 + platform_turn_xy * limb1_lower_cos,
      t584 = limb1_U2_opening_mn * limb1_U2_opening_mn;
    const lanes4 lanes_121 = each_limb1_upper_position_x * each_base_lever_fy_by_limb1_U2_fx,
      lanes_122 = signed_limb_lower_limb_target_y * each_base_lever_fy_by_limb1_U2_fx,
      each_limb1_U2_closure_fx_by_limb5_S_wz = lanes_121 - signed_limb_lower_limb_target_x *
        signed_limb_lower_sin,
      lanes_124 = signed_limb_lower_limb_target_y * signed_limb_lower_sin,
      each_limb1_U2_closure_fx_by_limb5_S_wy = each_limb1_upper_position_x * each_base_lever_fz_by_limb1_U2_fx
        - lanes_124,
      each_limb1_U2_closure_fx_by_limb5_S_wx = lanes_122 - signed_limb_lower_limb_target_x *
        each_base_lever_fz_by_limb1_U2_fx;
    const double minus_limb1_U2_closure_fx_by_limb5_S_wz = each_limb1_U2_closure_fx_by_limb5_S_wz[0],
      minus_limb2_S_closure_fx_by_limb5_S_wz = -each_limb1_U2_closure_fx_by_limb5_S_wy[1];
    const lanes4 each_limb1_U2_closure_fx_by_limb5_S_wz_2 = {minus_limb1_U2_closure_fx_by_limb5_S_wz,
        minus_limb2_S_closure_fx_by_limb5_S_wz, each_limb1_U2_closure_fx_by_limb5_S_wz[2],
        each_limb1_U2_closure_fx_by_limb5_S_wy[3]},
      each_limb1_U2_part_mn_by_limb1_P = each_limb1_U2_closure_fx_by_limb5_S_wz_2 * t63,
      lanes_128 = each_limb1_upper_position_x * (lanes4){t50, lanes_113[1], lanes_113[2], lanes_113[3]},
      lanes_131 = lanes_120 - (lanes4){1.0, 1.0, -1.0, -1.0} * lanes_128;
    const double t53 = minus_base_lever_my_by_limb1_U2_mn - lanes_131[0], /* platform */
      minus_limb1_lower_limb_target_x = signed_limb_lower_limb_target_x[0],
      t70 = minus_limb1_U_0_lever_mz_by_limb1_U2_mn - (minus_limb1_lower_limb_target_x * t50 - t68); /* platform */
    const lanes4 lanes_135 = (lanes4){1.0, 1.0, 1.0, -1.0} * ((lanes4){t70, t53, t70, t53} *
        each_limb1_U2_part_mn_by_limb1_P),
      each_limb5_S_balance_wx_by_limb1_P = each_limb1_U2_closure_fx_by_limb5_S_wx - lanes_135,
      lanes_137 = (lanes4){t53, t70, t53, t70} * each_limb1_U2_part_mn_by_limb1_P;
    const double limb1_U2_closure_fx_by_limb5_S_wy = each_limb1_U2_closure_fx_by_limb5_S_wy[0],
      minus_limb2_S_closure_fx_by_limb5_S_wx = each_limb1_U2_closure_fx_by_limb5_S_wz[1];
    const lanes4 each_limb1_U2_closure_fx_by_limb5_S_wy_2 = {limb1_U2_closure_fx_by_limb5_S_wy,
        minus_limb2_S_closure_fx_by_limb5_S_wx, each_limb1_U2_closure_fx_by_limb5_S_wy[2],
        each_limb1_U2_closure_fx_by_limb5_S_wz[3]},
      each_limb5_S_balance_wy_by_limb1_P = lanes_137 - (lanes4){1.0, -1.0, 1.0, 1.0} *
        each_limb1_U2_closure_fx_by_limb5_S_wy_2,
      lanes_140 = each_limb5_S_balance_wx_by_limb1_P * each_limb5_S_balance_wx_by_limb1_P,
      lanes_142 = (lanes4){1.0, 1.0, 1.0, -1.0} * each_limb5_S_balance_wy_by_limb1_P,
      lanes_143 = lanes_142 * lanes_142;
    /* drives: drives; pivots; momentum rate, eq. (35) */
    const double t103 = lanes_140[0] + lanes_143[1] + lanes_140[2], drives_share_0_0 = t103 + lanes_143[3],
      t127 = lanes_143[0] + lanes_140[1] + lanes_143[2], drives_share_1_1 = t127 + lanes_140[3],
      t132 = drives_share_0_0 * drives_share_1_1;
    const lanes4 lanes_144 = each_limb5_S_balance_wx_by_limb1_P * lanes_142;
    const double t137 = lanes_144[0] - (-lanes_144[1]) + lanes_144[2],
      minus_drives_share_0_1 = t137 - (-lanes_144[3]),
      value_determinant = t132 - minus_drives_share_0_1 * minus_drives_share_0_1, t140 = 1.0 /
        value_determinant,
      minus_limb1_upper_position_x = each_limb1_upper_position_x[0],
      t520 = minus_limb1_upper_position_x * lanes_111[0], /* limb1 */
      t273 = minus_limb1_upper_position_x * lanes_113[0]; /* limb1 */
    const lanes4 lanes_145 = signed_limb_lower_limb_target_x * lanes_113;
    const double t249 = lanes_109[0], /* limb1 */
      t522 = t520 - minus_limb1_lower_limb_target_x * t249, /* limb1 */
      t274 = minus_limb1_lower_limb_target_y * t249 + t273; /* limb1 */
    const lanes4 lanes_147 = lanes_145 + signed_limb_lower_limb_target_y * lanes_111;
    const double minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - (t141 + k13 *
        limb5_S_acc_wx);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35); drives */
    const double t144 = platform_turn_yx * minus_platform_rate_mx, t546 = platform_turn_xx *
        minus_platform_rate_mx,
      t512 = platform_turn_zx * minus_platform_rate_mx,
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (t145 - k13 * limb5_S_acc_wy),
      t514 = t512 - platform_turn_zy * platform_rate_my, t149 = t144 - platform_turn_yy * platform_rate_my,
      t548 = t546 - platform_turn_xy * platform_rate_my, platform_rate_mz = platform_Izz * limb5_S_acc_wz,
      t530 = t514 - platform_turn_zz * platform_rate_mz + t522 - lanes_131[1],
      limb1_U2_part_mn = (t530 + lanes_119[2] + lanes_131[3]) * t63, t544 = t53 * limb1_U2_part_mn,
      t566 = t70 * limb1_U2_part_mn, t550 = t548 - platform_turn_xz * platform_rate_mz,
      t366 = t149 - platform_turn_yz * platform_rate_mz + t274 - lanes_147[1],
      minus_limb5_S_balance_wy = t366 + lanes_131[2] - lanes_147[3] + t544,
      t545 = minus_limb5_S_balance_wy * drives_share_0_0, t562 = t550 - lanes_147[0] + lanes_119[1] -
        lanes_147[2],
      minus_limb5_S_balance_wx = t562 + lanes_119[3] + t566,
      t573 = minus_limb5_S_balance_wx * drives_share_1_1 + minus_limb5_S_balance_wy * minus_drives_share_0_1,
      t569 = t140 * (t545 + minus_limb5_S_balance_wx * minus_drives_share_0_1), t574 = t140 * t573;
    const lanes4 lanes_149 = lanes_142 * (lanes4){t569, t574, t569, t574},
      limb_P_drive = each_limb5_S_balance_wx_by_limb1_P * (lanes4){t574, t569, t574, t569} - lanes_149;
    u[0] = limb_P_drive[0];
    u[1] = -(-limb_P_drive[1]);
    u[2] = limb_P_drive[2];
    u[3] = -(-limb_P_drive[3]);
    const lanes4 every = (lanes4)((three_ups_upu_s_vector4_mask)(limb_P_drive) | ((limb_lower_limb_length <=
        (lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10}) & (limb_lower_limb_length >=
        -(lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10})) |
        ((each_limb1_U_0_lever_mz_by_limb1_U2_fz <= (lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10,
        6.62327e-10}) & (each_limb1_U_0_lever_mz_by_limb1_U2_fz >= -(lanes4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10})));
    return fabs(platform_joint_force_mz_by_limb1_U2_mn) <= 4.0171000000000005e-10 || fabs(value_determinant)
        <= 2.393867125597279e-10 || !(t7 >= 0.999999 && t7 <= 1.000001) || !(t584 <= 1.0e-12) ? (double)NAN :
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
