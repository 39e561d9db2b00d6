/*
 * three_ups_upu_s: forward_dynamics.
 *   forward_dynamics; forward_dynamics_independent; forward_dynamics_reactions
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 upper_position_x, minus_U_0_lever_mz_by_S_fz, t1, signed_U_follows_0_by_S_1,
      U_mass_matrix_0_by_U_0, t2, signed_S_arm_y, S_arm_x, t3, signed_U_follows_1_by_S_0,
      U_mass_matrix_1_by_U_1, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, signed_U_handed_force_0,
      t16, t17, t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, checked;
} LIMBS(forward_dynamics);

STAGE(forward_dynamics, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict u, const double *restrict sine, const double *restrict cosine,
    LIMBS(forward_dynamics) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = -sign1 * param_R,
      sign2 = OF4(1.0, -1.0, 1.0, -1.0), each_param_R_2 = sign1 * param_R, each_gravity_z = sign2 * gravity_z;
    /* each limb: geometry; inertia; free motion */
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      lower_composite_first_x = limb_lower_m * upper_offset_x, t1 = lower_composite_first_x + (-k7),
      t27 = lower_composite_first_x + t1, t2 = upper_offset_x * t1, t3 = t2 + k8;
    OWN(U_mass_matrix_1_by_U_1) = t2 + k9;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2), t4 = lower_cos * t3;
    OWN(U_mass_matrix_0_by_U_0) = lower_cos * t4 + k3;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2), t44 = sign1 * signed_lower_sin,
      t24 = t44 * t4 + lower_cos * (t44 * t3);
    OWN(upper_position_x) = t44 * upper_offset_x + each_param_R;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * upper_offset_x;
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = sign2 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(signed_U_follows_0_by_S_1) = OWN(upper_position_x) * OWN(t1);
    /* each limb: free motion; rates that follow; accelerations */
    const LIMB4 t6 = OWN(signed_U_follows_0_by_S_1) * OWN(U_mass_matrix_0_by_U_0),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    OWN(t2) = U_0_cos * t6;
    const LIMB4 t7 = OWN(signed_U_follows_0_by_S_1) * t6, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    OWN(t26) = signed_U_0_sin * t6;
    OWN(t3) = lower_cos * OWN(t1);
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    OWN(signed_U_follows_1_by_S_0) = OWN(S_arm_x) * OWN(t3);
    const LIMB4 t12 = OWN(signed_U_follows_1_by_S_0) * (OWN(U_mass_matrix_1_by_U_1) * OWN(signed_U_follows_1_by_S_0));
    OWN(signed_S_arm_y) = param_R * lower_cos;
    const LIMB4 t13 = OWN(signed_S_arm_y) * (k20 * lower_cos) + t12, t15 = U_0_cos * (t7 - t13);
    OWN(t4) = signed_U_0_sin * t15;
    const LIMB4 t43 = U_0_cos * t15;
    OWN(t23) = t13 + t43;
    OWN(t27) = t7 - t43;
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3), t16 = U_v_1 * t44;
    OWN(t18) = param_R * t16;
    const LIMB4 P_v = IN_EACH4(READ, v, 2, 3);
    OWN(t6) = P_v * lower_cos - upper_offset_x * t16;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3);
    OWN(t7) = U_v_0 * OWN(t6);
    const LIMB4 upper_twist_vx = P_v * t44, t19 = U_v_1 * lower_cos;
    OWN(t9) = upper_twist_vx + upper_offset_x * t19;
    OWN(t12) = each_param_R_2 * t19 - P_v;
    const LIMB4 t26 = t24 * (U_v_0 * U_v_1), t39 = 0.5 * t24, t29 = lower_cos * (lower_cos * t27),
      t45 = sign2 * (t26 - t29 * (U_v_0 * P_v)), t33 = 0.5 * t29;
    OWN(t14) = lower_cos * (upper_offset_x * (limb_lower_m_gravity_z * signed_U_0_sin)) + t45;
    const LIMB4 minus_U_0_U_still_xx = U_v_0 * U_v_0, t40 = minus_U_0_U_still_xx * t39,
      t38 = minus_U_0_U_still_xx * t33 + U_v_1 * U_v_1 * (0.5 * t27), U_0_acc_y = each_gravity_z * U_0_cos,
      minus_lower_acc_y = t44 * U_0_acc_y;
    OWN(t17) = limb_lower_m * (lower_cos * U_0_acc_y) - IN_EACH4(READ, u, 0, 1) - t38;
    const LIMB4 minus_lower_moment_z = upper_offset_x * (limb_lower_m * minus_lower_acc_y);
    OWN(t11) = U_v_1 * P_v;
    OWN(t20) = t40 + OWN(t11) * t27 - minus_lower_moment_z;
    OWN(checked) = checked;
}

STAGE(forward_dynamics, 1)(size_t limb, size_t stride, const double *restrict v, const double *restrict sine,
    const double *restrict cosine, const EACH4 platform_twist_wy, REAL platform_twist_wz,
    const EACH4 platform_twist_wx, LIMBS(forward_dynamics) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, 1.0, -1.0, -1.0),
      each_limb_lower_m = sign2 * limb_lower_m, sign3 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 t22 = sign1 * platform_twist_wz, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: accelerations */
    const LIMB4 t7 = U_0_cos * t22;
    OWN(t5) = U_0_cos * GIVEN(platform_twist_wy) + signed_U_0_sin * t22;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), t5 = OWN(t7) - OWN(upper_position_x) * (U_v_0 * OWN(t5));
    OWN(t8) = signed_U_0_sin * GIVEN(platform_twist_wy) - t7;
    const LIMB4 t9 = t5 - OWN(t8) * OWN(t9), t11 = U_v_0 * OWN(t8);
    OWN(t10) = t9 - GIVEN(platform_twist_wx) * OWN(t6);
    /* each limb: free motion; accelerations */
    OWN(t15) = OWN(t1) * OWN(t10);
    OWN(signed_U_handed_force_0) = OWN(t14) + OWN(U_mass_matrix_0_by_U_0) * OWN(t15);
    const LIMB4 S_handed_force_1 = OWN(signed_U_follows_0_by_S_1) * OWN(signed_U_handed_force_0);
    OWN(t16) = signed_U_0_sin * S_handed_force_1;
    OWN(t24) = U_0_cos * S_handed_force_1;
    const LIMB4 t16 = OWN(signed_S_arm_y) * t11;
    OWN(t13) = OWN(S_arm_x) * t11 + OWN(t11) + OWN(t5) * OWN(t12);
    OWN(t21) = OWN(t13) * OWN(t3);
    const LIMB4 t21 = OWN(signed_U_follows_1_by_S_0) * (OWN(t20) - sign1 * (OWN(U_mass_matrix_1_by_U_1) * OWN(t21))),
      t24 = sign3 * t21;
    OWN(t19) = t16 + OWN(t5) * OWN(t18);
    const LIMB4 signed_S_handed_force_0 = OWN(signed_S_arm_y) * (each_limb_lower_m * OWN(t19) - OWN(t17)) - t24;
    OWN(t22) = U_0_cos * signed_S_handed_force_0;
    OWN(t25) = signed_U_0_sin * signed_S_handed_force_0;
}

STAGE(forward_dynamics, 2)(size_t limb, size_t stride, double *restrict a, const double *restrict sine,
    const double *restrict cosine, REAL minus_limb5_S_joint_acc_wz, const EACH4 signed_limb5_S_joint_acc_wy,
    const EACH4 signed_limb5_S_joint_acc_wx, LIMBS(forward_dynamics) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, 1.0, -1.0, -1.0);
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: accelerations */
    const LIMB4 t4 = OWN(signed_U_follows_0_by_S_1) * (U_0_cos * minus_limb5_S_joint_acc_wz - signed_U_0_sin * GIVEN(signed_limb5_S_joint_acc_wy)),
      U_joint_acc_0 = sign1 * GIVEN(signed_limb5_S_joint_acc_wx) + (t4 - sign1 * OWN(t15));
    WRITE4(a, 0, 3, 6, 9, U_joint_acc_0);
    LIMB4 checked = OWN(checked) + U_joint_acc_0;
    const LIMB4 t13 = sign1 * (signed_U_0_sin * minus_limb5_S_joint_acc_wz + U_0_cos * GIVEN(signed_limb5_S_joint_acc_wy)),
      signed_U_joint_acc_1 = OWN(t21) + OWN(signed_U_follows_1_by_S_0) * t13;
    WRITE4(a, 1, 4, 7, 10, -sign1 * signed_U_joint_acc_1);
    checked = checked + signed_U_joint_acc_1;
    const LIMB4 signed_P_joint_acc = OWN(t19) + OWN(signed_S_arm_y) * t13;
    WRITE4(a, 2, 5, 8, 11, -sign2 * signed_P_joint_acc);
    checked = checked + signed_P_joint_acc;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_forward_dynamics)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    LIMBS(forward_dynamics) limbs;
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t14 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_xx = 1.0 - t6 * t9,
      platform_turn_zz = 1.0 - t9 * t14, t12 = limb5_S_q_qy * t9, t34 = limb5_S_q_qx * t12, t13 = limb5_S_q_qw * t12,
      t10 = limb5_S_q_qz * t9, t26 = limb5_S_q_qw * (limb5_S_q_qx * t9), t35 = limb5_S_q_qw * t10,
      platform_turn_yx = t34 + t35, platform_turn_xy = t34 - t35, limb5_S_v_wx = READ(v, 12),
      limb5_S_v_wy = READ(v, 13), t42 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      t24 = limb5_S_q_qy * t10, t11 = limb5_S_q_qx * t10, platform_turn_yz = t24 - t26, platform_turn_zy = t24 + t26,
      limb5_S_v_wz = READ(v, 14), platform_twist_wy = t42 + limb5_S_v_wz * platform_turn_yz,
      t47 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy, platform_turn_xz = t11 + t13,
      platform_turn_zx = t11 - t13, platform_twist_wx = t47 + limb5_S_v_wz * platform_turn_xz;
    const EACH4 platform_twist_wy_2 = {platform_twist_wy, platform_twist_wx, platform_twist_wy, platform_twist_wx},
      platform_twist_wx_2 = {platform_twist_wx, platform_twist_wy, platform_twist_wx, platform_twist_wy};
    const REAL t52 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t52;
    FIRST_LIMB(0, forward_dynamics, 0, stride, q, v, u, sine, cosine, &limbs);
    FIRST_LIMB(0, forward_dynamics, 1, stride, v, sine, cosine, platform_twist_wy_2, platform_twist_wz, platform_twist_wx_2, &limbs);
    /* limb1: geometry; accelerations; loop closure */
    const REAL limb1_lower_sin = SINES(sine, 1), limb1_lower_cos = SINES(cosine, 1), limb1_U_v_0 = READ(v, 0),
      t58 = limb1_lower_sin * limbs.t8[0] + limb1_lower_cos * platform_twist_wx,
      t66 = limb1_lower_sin * platform_twist_wx, limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos,
      t59 = limb1_lower_omega_y - t58, limb1_U_v_1 = READ(v, 1), t60 = limb1_U_v_1 * t59,
      t54 = limb1_U_v_1 - limbs.t5[0], limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0);
    /* limb1: loop closure; reciprocal wrenches, eq. (10); rates that follow */
    const REAL t62 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t54 - t60),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t63 = limb1_U2_constraint_mn_couple_x * t62, limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin,
      t64 = limb1_lower_omega_x * t59, t68 = limb1_lower_omega_x + (limb1_lower_cos * limbs.t8[0] - t66),
      t70 = t64 - limb1_lower_omega_y * t68,
      t32 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t73 = limb1_lower_sin * t32,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t32 - limb1_lower_sin * platform_turn_xy,
      t72 = t63 - limb1_U2_constraint_mn_couple_z * t70,
      limb1_U2_opening_mn = t73 + limb1_lower_cos * platform_turn_xy,
      t78 = t68 * (limb1_U2_opening_mn * t68 + limb1_U2_constraint_mn_couple_z * t59),
      limb1_U2_opening_bias_mn = t72 - (t78 - t54 * (limb1_U2_constraint_mn_couple_x * t59 - limb1_U2_opening_mn * t54)),
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t3[0],
      t85 = limb1_U2_opening_bias_mn - limbs.t13[0] * limb1_U_factor_1_by_3, /* limb5_S */
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x;
    /* limb5_S: accelerations; pivots; rates that follow */
    const REAL t86 = minus_limb1_U_factor_0_by_3 * limbs.t10[0] - t85,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn + limbs.upper_position_x[0] * minus_limb1_U_factor_0_by_3,
      t100 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3, /* limb1 */
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    REAL checked0 = minus_limb5_S_pivot_wz;
    const REAL t39 = 1.0 / minus_limb5_S_pivot_wz, minus_limb5_S_joint_acc_still_wz = t39 * t86,
      limb5_S_null_space_wz_by_limb5_S_wy = t39 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t100);
    /* limb5_S: free motion; momentum rate, eq. (35); accelerations */
    const REAL t16 = k12 * platform_turn_zz, t103 = k13 + platform_turn_zz * t16, t17 = platform_turn_xz * t16;
    NEXT_LIMB(2, forward_dynamics, 0, stride, q, v, u, sine, cosine, &limbs);
    const REAL t104 = t103 + limbs.t23[2], t18 = t17 - limbs.t2[2];
    NEXT_LIMB(1, forward_dynamics, 0, stride, q, v, u, sine, cosine, &limbs);
    const REAL t105 = limbs.t23[1] + t104, t19 = t18 + limbs.t4[1];
    NEXT_LIMB(3, forward_dynamics, 0, stride, q, v, u, sine, cosine, &limbs);
    const REAL limb5_S_handed_inertia_wz = limbs.t23[0] + (limbs.t23[3] + t105),
      limb5_S_handed_inertia_wz_by_limb5_S_wx = limbs.t4[3] + t19 - limbs.t2[0],
      t107 = limb5_S_handed_inertia_wz * minus_limb5_S_joint_acc_still_wz,
      t149 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz;
    NEXT_LIMB(2, forward_dynamics, 1, stride, v, sine, cosine, platform_twist_wy_2, platform_twist_wz, platform_twist_wx_2, &limbs);
    const REAL platform_rate_mx = k12 * (limb5_S_v_wy * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zy,
      t108 = platform_turn_zx * platform_rate_mx,
      minus_platform_rate_my = k12 * (limb5_S_v_wx * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zx,
      t111 = t108 - platform_turn_zy * minus_platform_rate_my + limbs.t25[2];
    NEXT_LIMB(1, forward_dynamics, 1, stride, v, sine, cosine, platform_twist_wy_2, platform_twist_wz, platform_twist_wx_2, &limbs);
    NEXT_LIMB(3, forward_dynamics, 1, stride, v, sine, cosine, platform_twist_wy_2, platform_twist_wz, platform_twist_wx_2, &limbs);
    const REAL t117 = limbs.t24[3] + (limbs.t24[1] - (limbs.t24[2] - (limbs.t25[0] + (limbs.t25[3] - (limbs.t25[1] + t111))))),
      t119 = limb5_S_null_space_wz_by_limb5_S_wy * (t107 + (t117 - limbs.t24[0])), t120 = k12 * platform_turn_yz,
      t125 = limbs.t4[0] + (limbs.t2[3] + (limbs.t2[1] - (platform_turn_zz * t120 - limbs.t4[2]))),
      t126 = t125 * minus_limb5_S_joint_acc_still_wz,
      t152 = limb5_S_null_space_wz_by_limb5_S_wy * (t125 + (t125 - t149)), t89 = platform_turn_xx * platform_rate_mx,
      t130 = platform_turn_yx * platform_rate_mx - platform_turn_yy * minus_platform_rate_my + limbs.t22[2],
      t134 = limbs.signed_U_handed_force_0[3] + (limbs.signed_U_handed_force_0[1] - (limbs.t16[2] - (t130 - limbs.t22[0]))),
      limb5_S_reduced_force_wy = t119 - (t126 + (t134 - limbs.t16[0])),
      t95 = limbs.signed_U_handed_force_0[2] - (limbs.t22[3] + (t89 - platform_turn_xy * minus_platform_rate_my - limbs.t22[1])),
      t98 = limbs.signed_U_handed_force_0[0] + (limbs.t16[3] + (limbs.t16[1] + t95)),
      t147 = limbs.U_mass_matrix_0_by_U_0[3] + (limbs.U_mass_matrix_0_by_U_0[1] + (k13 + platform_turn_yz * t120 + limbs.t27[2])),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = limbs.t27[0] + t147 - t152;
    REAL checked1 = limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t153 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t141 = platform_turn_xz * t120 + limbs.t26[2] - limbs.t26[1] - limbs.t26[3] + limbs.t26[0],
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t141 + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz_by_limb5_S_wx,
      limb5_S_reduced_force_wx = limb5_S_handed_inertia_wz_by_limb5_S_wx * minus_limb5_S_joint_acc_still_wz + t98;
    /* platform: accelerations; pivots; free motion */
    const REAL t154 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t153,
      t163 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t154, t165 = limb5_S_reduced_force_wy * t153,
      t156 = limb5_S_reduced_force_wx - limb5_S_reduced_force_wy * t154,
      t161 = limbs.U_mass_matrix_0_by_U_0[2] + (k13 + platform_turn_xz * (k12 * platform_turn_xz)) + limbs.t27[1],
      pivot_1 = limbs.U_mass_matrix_0_by_U_0[0] + (limbs.t27[3] + t161) - t163;
    REAL checked2 = pivot_1;
    const REAL limb5_S_joint_acc_wx = t156 / pivot_1, minus_limb5_S_joint_acc_wy = t154 * limb5_S_joint_acc_wx - t165,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy * minus_limb5_S_joint_acc_wy,
      t167 = platform_turn_zx * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_x = t167 + (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx * limb5_S_joint_acc_wx);
    REAL checked3 = minus_platform_alpha_x;
    WRITE(a, 12, -minus_platform_alpha_x);
    const REAL t171 = platform_turn_zy * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_y = t171 + (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy * limb5_S_joint_acc_wx);
    checked0 = checked0 + minus_platform_alpha_y;
    WRITE(a, 13, -minus_platform_alpha_y);
    const REAL t175 = platform_turn_zz * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_z = t175 + (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz * limb5_S_joint_acc_wx);
    checked1 = checked1 + minus_platform_alpha_z;
    WRITE(a, 14, -minus_platform_alpha_z);
    const EACH4 signed_limb5_S_joint_acc_wy = {minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx},
      signed_limb5_S_joint_acc_wx = {limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_wy};
    FIRST_LIMB(0, forward_dynamics, 2, stride, a, sine, cosine, minus_limb5_S_joint_acc_wz, signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[0]);
    NEXT_LIMB(1, forward_dynamics, 2, stride, a, sine, cosine, minus_limb5_S_joint_acc_wz, signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, forward_dynamics, 2, stride, a, sine, cosine, minus_limb5_S_joint_acc_wz, signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, forward_dynamics, 2, stride, a, sine, cosine, minus_limb5_S_joint_acc_wz, signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-06, 6.62327e-06, 6.62327e-06, 6.62327e-06) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-05) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 0.0007562600000000001) OR /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 0.0007551200000000001), /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 upper_offset_x, signed_upper_position_x, minus_U_0_lever_mz_by_S_fz, t1, S_arm_x, t2,
      signed_S_arm_y, signed_U_joint_rate_1, t3, signed_U_joint_rate_0, t4, t5, t6,
      signed_U_follows_0_by_S_1, U_mass_matrix_0_by_U_0, t7, t8, U_follows_1_by_S_0, U_mass_matrix_1_by_U_1,
      t9, t10, t11, signed_U_0_moment_z, t12, t13, t14, signed_U_handed_force_0, t15, signed_lower_moment_z,
      t16, P_generalised_force, t17, t18, t19, t20, t21, checked;
} LIMBS(forward_dynamics_independent);

STAGE(forward_dynamics_independent, 0)(size_t limb, size_t stride, const double *restrict q,
    const double *restrict sine, const double *restrict cosine, LIMBS(forward_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: reciprocal wrenches, eq. (10); inertia; rates that follow */
    OWN(signed_S_arm_y) = param_R * lower_cos;
    OWN(upper_offset_x) = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    const LIMB4 lower_composite_first_x = limb_lower_m * OWN(upper_offset_x), t2 = lower_composite_first_x + (-k7);
    OWN(t12) = lower_composite_first_x + t2;
    const LIMB4 t3 = OWN(upper_offset_x) * t2;
    OWN(U_mass_matrix_1_by_U_1) = t3 + k9;
    const LIMB4 t4 = t3 + k8, t5 = lower_cos * t4, signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(t14) = signed_lower_sin * t5 + lower_cos * (signed_lower_sin * t4);
    OWN(U_mass_matrix_0_by_U_0) = lower_cos * t5 + k3;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * OWN(upper_offset_x);
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = 1.0 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    OWN(S_arm_x) = OWN(upper_offset_x) - param_R * signed_lower_sin;
    OWN(U_follows_1_by_S_0) = OWN(S_arm_x) * OWN(t2);
    OWN(signed_upper_position_x) = signed_lower_sin * OWN(upper_offset_x) + (-param_R);
    OWN(signed_U_follows_0_by_S_1) = OWN(signed_upper_position_x) * OWN(t1);
    OWN(checked) = checked;
}

STAGE(forward_dynamics_independent, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, LIMBS(forward_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    /* each limb: free motion */
    const LIMB4 t4 = OWN(signed_S_arm_y) * (k20 * IN_EACH4(SINES, cosine, 1, 2)),
      t7 = t4 + OWN(U_follows_1_by_S_0) * (OWN(U_mass_matrix_1_by_U_1) * OWN(U_follows_1_by_S_0)),
      t1 = OWN(signed_U_follows_0_by_S_1) * OWN(U_mass_matrix_0_by_U_0), U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    OWN(t8) = U_0_cos * t1;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    OWN(t7) = signed_U_0_sin * t1;
    const LIMB4 t2 = OWN(signed_U_follows_0_by_S_1) * t1, t9 = U_0_cos * (t2 - t7);
    OWN(t9) = signed_U_0_sin * t9;
    const LIMB4 t10 = U_0_cos * t9;
    OWN(t11) = t7 + t10;
    OWN(t10) = t2 - t10;
}

STAGE(forward_dynamics_independent, 2)(size_t limb, size_t stride, const double *restrict u,
    const double *restrict sine, const double *restrict cosine, LIMBS(forward_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, 1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0),
      each_gravity_z = sign2 * gravity_z;
    /* each limb: free motion; balance, eqs. (40)-(47); accelerations */
    OWN(t16) = (-0.5) * OWN(t14);
    OWN(t17) = 0.5 * OWN(t12);
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    OWN(signed_U_0_moment_z) = lower_cos * (sign1 * (OWN(upper_offset_x) * (limb_lower_m_gravity_z * IN_EACH4(SINES, sine, 0, 2))));
    const LIMB4 U_0_acc_y = each_gravity_z * IN_EACH4(SINES, cosine, 0, 2);
    OWN(signed_lower_moment_z) = OWN(upper_offset_x) * (limb_lower_m * (IN_EACH4(SINES, sine, 1, 2) * U_0_acc_y));
    OWN(P_generalised_force) = limb_lower_m * (lower_cos * U_0_acc_y) - IN_EACH4(READ, u, 0, 1);
    OWN(t13) = lower_cos * (lower_cos * OWN(t12));
    OWN(t18) = 0.5 * OWN(t13);
}

STAGE(forward_dynamics_independent, 3)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL limb5_S_joint_rate_wz, const EACH4 signed_limb5_S_joint_rate_wy,
    const EACH4 given, REAL given_2, const EACH4 given_3, const EACH4 signed_limb5_S_joint_rate_wx,
    LIMBS(forward_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, 1.0, -1.0, -1.0);
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: velocities, eq. (6) */
    const LIMB4 t3 = signed_U_0_sin * limb5_S_joint_rate_wz + U_0_cos * GIVEN(signed_limb5_S_joint_rate_wy);
    OWN(signed_U_joint_rate_1) = OWN(t2) * (OWN(S_arm_x) * t3);
    const LIMB4 signed_P_joint_rate = OWN(signed_S_arm_y) * t3, signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: accelerations; free motion; velocities, eq. (6) */
    const LIMB4 t5 = signed_lower_sin * OWN(signed_U_joint_rate_1), lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t50 = param_R * t5, t7 = lower_cos * signed_P_joint_rate - OWN(upper_offset_x) * t5,
      t19 = OWN(signed_upper_position_x) * (U_0_cos * limb5_S_joint_rate_wz - signed_U_0_sin * GIVEN(signed_limb5_S_joint_rate_wy));
    OWN(signed_U_joint_rate_0) = GIVEN(signed_limb5_S_joint_rate_wx) + sign3 * (OWN(t1) * t19);
    const LIMB4 t21 = t7 * OWN(signed_U_joint_rate_0), t65 = sign1 * (t7 * GIVEN(given)), t61 = sign1 * given_2,
      t13 = U_0_cos * t61;
    OWN(t4) = signed_U_0_sin * t61 + U_0_cos * GIVEN(given_3);
    const LIMB4 t64 = sign1 * OWN(t4), t51 = t64 * t50,
      t26 = t21 - OWN(signed_upper_position_x) * (OWN(signed_U_joint_rate_0) * t64),
      t10 = lower_cos * OWN(signed_U_joint_rate_1), t30 = t64 * (signed_P_joint_rate - param_R * t10),
      t12 = signed_lower_sin * signed_P_joint_rate + OWN(upper_offset_x) * t10;
    OWN(t3) = t13 - signed_U_0_sin * GIVEN(given_3);
    const LIMB4 t62 = sign2 * OWN(t3);
    OWN(t5) = t65 + (t26 - t12 * t62);
    /* each limb: free motion; accelerations */
    const LIMB4 t36 = OWN(U_mass_matrix_0_by_U_0) * (OWN(t1) * OWN(t5)), t32 = t62 * OWN(signed_U_joint_rate_0),
      t38 = OWN(t13) * (signed_P_joint_rate * OWN(signed_U_joint_rate_0)),
      t31 = signed_P_joint_rate * OWN(signed_U_joint_rate_1),
      t42 = OWN(signed_U_0_moment_z) + (t38 - OWN(t14) * (OWN(signed_U_joint_rate_1) * OWN(signed_U_joint_rate_0)));
    OWN(signed_U_handed_force_0) = t36 - t42;
    const LIMB4 minus_S_handed_force_1 = OWN(signed_U_follows_0_by_S_1) * OWN(signed_U_handed_force_0);
    OWN(t15) = signed_U_0_sin * minus_S_handed_force_1;
    OWN(t20) = U_0_cos * minus_S_handed_force_1;
    const LIMB4 minus_U_0_U_still_xx = OWN(signed_U_joint_rate_0) * OWN(signed_U_joint_rate_0),
      t56 = OWN(t17) * (OWN(signed_U_joint_rate_1) * OWN(signed_U_joint_rate_1));
    OWN(t6) = t30 - (t31 + OWN(S_arm_x) * t32);
    const LIMB4 t44 = OWN(U_mass_matrix_1_by_U_1) * (OWN(t2) * OWN(t6)),
      t54 = limb_lower_m * (t51 + OWN(signed_S_arm_y) * t32),
      t49 = OWN(U_follows_1_by_S_0) * (OWN(signed_lower_moment_z) - (OWN(t12) * t31 - OWN(t16) * minus_U_0_U_still_xx) - t44),
      t60 = OWN(signed_S_arm_y) * (OWN(P_generalised_force) - (t56 + OWN(t18) * minus_U_0_U_still_xx) - t54),
      signed_S_handed_force_0 = t49 - t60;
    OWN(t19) = U_0_cos * signed_S_handed_force_0;
    OWN(t21) = signed_U_0_sin * signed_S_handed_force_0;
}

BODY(three_ups_upu_s_forward_dynamics_independent)(size_t stride, const double *restrict q,
    const double *restrict y_dot, const double *restrict u, double *restrict y_ddot,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(forward_dynamics_independent) limbs;
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t10 = t2 + t5,
      t81 = t2 + t4, t9 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t9 * t10, t35 = k2 - 0.5 * t7,
      platform_turn_xx = 1.0 - t6 * t9, platform_turn_zz = 1.0 - t9 * t81, t13 = limb5_S_q_qz * t9,
      t14 = limb5_S_q_qy * t13, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t24 = limb5_S_q_qy * t9,
      platform_turn_zy = t14 + t16, platform_turn_yz = t14 - t16, limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_sin = SINES(sine, 0),
      t22 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t23 = limb1_lower_cos * t22, /* limb1 */
      t116 = limb1_lower_sin * t22, /* limb1 */
      t25 = limb5_S_q_qx * t24, t84 = limb5_S_q_qw * t24, t26 = limb5_S_q_qw * t13, t83 = limb5_S_q_qx * t13,
      platform_turn_xy = t25 - t26, platform_turn_yx = t25 + t26;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; pivots */
    const REAL limb1_U2_constraint_mn_couple_z = t23 - limb1_lower_sin * platform_turn_xy;
    FIRST_LIMB(0, forward_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    REAL checked0 = ALONE(limbs.checked[0]);
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t2[0],
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      t29 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t32 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      t18 = limbs.signed_upper_position_x[0] * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x + t18;
    /* limb5_S: pivots; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t29;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL t30 = 1.0 / minus_limb5_S_pivot_wz,
      t33 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t32, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t30 * t33;
    /* limb5_S: velocities, eq. (6); accelerations; geometry */
    const REAL t43 = limb5_S_q_qy * t35, t44 = t43 * limb5_S_null_space_wz_by_limb5_S_wy, t39 = limb5_S_q_qz * t35,
      t46 = 0.5 * (t39 - t44), t40 = 0.5 * t39, limb5_S_y_dot_qx = READ(y_dot, 0), limb5_S_y_dot_qy = READ(y_dot, 1),
      t47 = t40 * t46, t41 = t40 * limb5_S_y_dot_qx, t55 = limb5_S_y_dot_qy * t46, t48 = limb5_S_q_qx * t35,
      t36 = limb5_S_q_qw * t35, t51 = 0.5 * (t36 + t48 * limb5_S_null_space_wz_by_limb5_S_wy), t37 = 0.5 * t36,
      a_pivot = t47 + t37 * t51;
    REAL checked2 = a_pivot;
    const REAL t53 = 1.0 / a_pivot, limb5_S_joint_rate_wy = (t37 * limb5_S_y_dot_qy + t41) * t53,
      limb5_S_joint_rate_wz = t30 * (t33 * limb5_S_joint_rate_wy),
      minus_limb5_S_joint_rate_wx = t53 * (t55 - limb5_S_y_dot_qx * t51),
      t90 = platform_turn_zy * limb5_S_joint_rate_wz,
      platform_omega_y = t90 + (platform_turn_yy * limb5_S_joint_rate_wy - platform_turn_xy * minus_limb5_S_joint_rate_wx),
      t94 = platform_turn_xy * platform_omega_y, platform_turn_zx = t83 - t84, platform_turn_xz = t83 + t84,
      t96 = platform_turn_zx * limb5_S_joint_rate_wz,
      platform_omega_x = t96 + (platform_turn_yx * limb5_S_joint_rate_wy - platform_turn_xx * minus_limb5_S_joint_rate_wx);
    /* platform: accelerations; velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t101 = t94 + platform_turn_xx * platform_omega_x, t85 = platform_turn_zz * limb5_S_joint_rate_wz,
      platform_omega_z = t85 + (platform_turn_yz * limb5_S_joint_rate_wy - platform_turn_xz * minus_limb5_S_joint_rate_wx),
      t102 = platform_turn_xz * platform_omega_z + t101,
      t106 = platform_turn_yy * platform_omega_y + platform_turn_yx * platform_omega_x,
      t107 = platform_turn_yz * platform_omega_z + t106;
    const EACH4 given = {t102, t107, t102, t107}, given_3 = {t107, t102, t107, t102};
    const REAL t184 = k12 * (platform_omega_z * platform_omega_y),
      t111 = platform_turn_zy * platform_omega_y + platform_turn_zx * platform_omega_x,
      platform_U_still_xz = platform_omega_z * platform_omega_x, t112 = platform_turn_zz * platform_omega_z + t111,
      t182 = k12 * platform_U_still_xz;
    const EACH4 signed_limb5_S_joint_rate_wy = {limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx},
      signed_limb5_S_joint_rate_wx = {minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy};
    FIRST_LIMB(0, forward_dynamics_independent, 2, stride, u, sine, cosine, &limbs);
    FIRST_LIMB(0, forward_dynamics_independent, 3, stride, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, given, t112, given_3, signed_limb5_S_joint_rate_wx, &limbs);
    const REAL t114 = limb1_U_factor_1_by_3 * limbs.t6[0], t113 = minus_limb1_U_factor_0_by_3 * limbs.t5[0];
    /* limb1: loop closure; velocities, eq. (6) */
    const REAL t121 = limb1_lower_cos * t102 - limb1_lower_sin * limbs.t3[0], t126 = limb1_lower_sin * t102,
      minus_limb1_lower_omega_y = limb1_lower_cos * limbs.signed_U_joint_rate_0[0],
      t122 = t121 + minus_limb1_lower_omega_y, t139 = limbs.signed_U_joint_rate_1[0] * t122,
      t115 = limbs.signed_U_joint_rate_1[0] - limbs.t4[0], t141 = t139 - t115 * minus_limb1_lower_omega_y,
      t143 = limb1_U2_constraint_mn_couple_x * (t141 + limbs.signed_U_joint_rate_1[0] * minus_limb1_lower_omega_y),
      t123 = limb1_U2_constraint_mn_couple_x * t122, t128 = t126 + limb1_lower_cos * limbs.t3[0],
      minus_limb1_lower_omega_x = limb1_lower_sin * limbs.signed_U_joint_rate_0[0],
      t129 = t128 + minus_limb1_lower_omega_x,
      t138 = limb1_U2_constraint_mn_couple_z * (minus_limb1_lower_omega_y * t129 - t122 * minus_limb1_lower_omega_x),
      t144 = t138 - t143, t130 = limb1_U2_constraint_mn_couple_z * t122,
      limb1_U2_opening_mn = t116 + limb1_lower_cos * platform_turn_xy,
      t125 = t115 * (limb1_U2_opening_mn * t115 + t123);
    /* limb5_S: accelerations */
    const REAL t145 = t114 - (t125 + t129 * (t130 + limb1_U2_opening_mn * t129) - t144),
      limb5_S_joint_acc_still_wz = t30 * (t113 + t145);
    /* limb5_S: free motion; accelerations; pivots */
    const REAL t153 = k12 * platform_turn_zz, t171 = k13 + platform_turn_zz * t153, t154 = platform_turn_xz * t153;
    NEXT_LIMB(2, forward_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    REAL checked3 = ALONE(limbs.checked[2]);
    FIRST_LIMB(2, forward_dynamics_independent, 1, stride, sine, cosine, &limbs);
    const REAL t172 = t171 + limbs.t11[2], t155 = t154 + limbs.t8[2];
    NEXT_LIMB(1, forward_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[1]);
    NEXT_LIMB(1, forward_dynamics_independent, 1, stride, sine, cosine, &limbs);
    const REAL t173 = limbs.t11[1] + t172, t156 = t155 + limbs.t9[1];
    NEXT_LIMB(3, forward_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
    NEXT_LIMB(3, forward_dynamics_independent, 1, stride, sine, cosine, &limbs);
    const REAL t174 = limbs.t11[3] + t173, t157 = limbs.t9[3] + t156;
    NEXT_LIMB(0, forward_dynamics_independent, 1, stride, sine, cosine, &limbs);
    const REAL limb5_S_handed_inertia_wz = limbs.t11[0] + t174,
      limb5_S_handed_inertia_wz_by_limb5_S_wx = t157 - limbs.t8[0],
      t193 = limb5_S_handed_inertia_wz * limb5_S_joint_acc_still_wz,
      t175 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz;
    NEXT_LIMB(2, forward_dynamics_independent, 2, stride, u, sine, cosine, &limbs);
    NEXT_LIMB(2, forward_dynamics_independent, 3, stride, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, given, t112, given_3, signed_limb5_S_joint_rate_wx, &limbs);
    const REAL platform_rate_my = gravity_z_platform_mz * platform_turn_zx - t182,
      t194 = platform_turn_zy * platform_rate_my,
      minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - t184,
      t197 = limbs.t21[2] + (t194 - platform_turn_zx * minus_platform_rate_mx);
    NEXT_LIMB(1, forward_dynamics_independent, 2, stride, u, sine, cosine, &limbs);
    NEXT_LIMB(1, forward_dynamics_independent, 3, stride, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, given, t112, given_3, signed_limb5_S_joint_rate_wx, &limbs);
    const REAL t198 = limbs.t21[1] + t197;
    NEXT_LIMB(3, forward_dynamics_independent, 2, stride, u, sine, cosine, &limbs);
    NEXT_LIMB(3, forward_dynamics_independent, 3, stride, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, given, t112, given_3, signed_limb5_S_joint_rate_wx, &limbs);
    const REAL t204 = limbs.t20[3] + (limbs.t20[1] - (limbs.t20[2] + (limbs.t21[0] + (limbs.t21[3] - t198)))) - limbs.t20[0],
      t205 = limb5_S_null_space_wz_by_limb5_S_wy * (t193 + t204), t147 = k12 * platform_turn_yz,
      t169 = limbs.t9[0] - (limbs.t8[1] + (platform_turn_zz * t147 - limbs.t9[2]) - limbs.t8[3]),
      t206 = t169 * limb5_S_joint_acc_still_wz, t178 = limb5_S_null_space_wz_by_limb5_S_wy * (t169 + (t169 - t175)),
      t183 = platform_turn_xy * platform_rate_my,
      t210 = limbs.t19[2] + (platform_turn_yy * platform_rate_my - platform_turn_yx * minus_platform_rate_mx),
      t214 = limbs.signed_U_handed_force_0[1] + (limbs.t15[2] + (t210 - limbs.t19[0])) - limbs.signed_U_handed_force_0[3],
      minus_limb5_S_reduced_force_wy = t205 - (t206 - (limbs.t15[0] + t214)),
      t189 = limbs.signed_U_handed_force_0[2] - (limbs.t19[3] - (limbs.t19[1] - (t183 - platform_turn_xx * minus_platform_rate_mx))),
      t192 = limbs.signed_U_handed_force_0[0] + (limbs.t15[3] + (limbs.t15[1] - t189)),
      t163 = limbs.U_mass_matrix_0_by_U_0[3] + (limbs.U_mass_matrix_0_by_U_0[1] + (k13 + platform_turn_yz * t147 + limbs.t10[2])),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = limbs.t10[0] + t163 - t178;
    checked2 = checked2 + limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t179 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t152 = platform_turn_xz * t147 - limbs.t7[2] + limbs.t7[1] - limbs.t7[3] + limbs.t7[0],
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t152 + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz_by_limb5_S_wx,
      minus_limb5_S_reduced_force_wx = limb5_S_handed_inertia_wz_by_limb5_S_wx * limb5_S_joint_acc_still_wz + t192,
      t180 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t179, t225 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t180,
      t227 = minus_limb5_S_reduced_force_wy * t179,
      t218 = minus_limb5_S_reduced_force_wx - minus_limb5_S_reduced_force_wy * t180,
      t223 = limbs.U_mass_matrix_0_by_U_0[2] + (k13 + platform_turn_xz * (k12 * platform_turn_xz)) + limbs.t10[1],
      pivot_1 = limbs.U_mass_matrix_0_by_U_0[0] + (limbs.t10[3] + t223) - t225;
    checked3 = checked3 + pivot_1;
    const REAL minus_limb5_S_joint_acc_wx = t218 / pivot_1,
      limb5_S_joint_acc_wy = t180 * minus_limb5_S_joint_acc_wx - t227,
      limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_joint_acc_wy;
    /* limb5_S: results */
    const REAL t235 = platform_turn_zy * limb5_S_joint_acc_wz,
      t239 = t235 + (platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx),
      t258 = platform_turn_xy * t239, t240 = platform_turn_zy * t239, t251 = platform_turn_yy * t239,
      t241 = platform_turn_zx * limb5_S_joint_acc_wz, t229 = platform_turn_zz * limb5_S_joint_acc_wz,
      t230 = platform_turn_yz * limb5_S_joint_acc_wy,
      t245 = t241 + (platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx),
      t260 = t258 + platform_turn_xx * t245, t233 = t229 + (t230 - platform_turn_xz * minus_limb5_S_joint_acc_wx),
      t261 = platform_turn_xz * t233 + t260, t253 = t251 + platform_turn_yx * t245,
      t248 = platform_turn_zz * t233 + (t240 + platform_turn_zx * t245), t254 = platform_turn_yz * t233 + t253,
      t281 = t39 * t261 - t48 * t248 - t36 * t254, t263 = t43 * t248 - t39 * t254 - t36 * t261,
      t271 = t43 * limb5_S_joint_rate_wz - t39 * limb5_S_joint_rate_wy + t36 * minus_limb5_S_joint_rate_wx,
      t273 = limb5_S_joint_rate_wz * (0.5 * t271), t61 = t36 * limb5_S_joint_rate_wy,
      t69 = t48 * limb5_S_joint_rate_wy + t43 * minus_limb5_S_joint_rate_wx - t36 * limb5_S_joint_rate_wz,
      t70 = 0.5 * t69, t274 = minus_limb5_S_joint_rate_wx * t70 + t273, t71 = limb5_S_joint_rate_wy * t70,
      t58 = t39 * minus_limb5_S_joint_rate_wx,
      t77 = t39 * limb5_S_joint_rate_wz + (t43 * limb5_S_joint_rate_wy - t48 * minus_limb5_S_joint_rate_wx),
      t78 = 0.5 * t77, t79 = minus_limb5_S_joint_rate_wx * t78,
      t283 = 0.5 * (t274 + limb5_S_joint_rate_wy * t78 + t281);
    checked0 = checked0 + t283;
    WRITE(y_ddot, 1, -t283);
    const REAL t72 = limb5_S_joint_rate_wz * (0.5 * (t58 + t48 * limb5_S_joint_rate_wz + t61)) + t71,
      t265 = 0.5 * (t72 - t79 + t263);
    checked1 = checked1 + t265;
    WRITE(y_ddot, 0, -t265);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 7.562600000000002e-08) OR /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 7.551200000000001e-08), /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 upper_offset_x, upper_position_x, minus_U_0_lever_mz_by_S_fz, t1, U_follows_0_by_S_1,
      U_mass_matrix_0_by_U_0, t2, S_arm_y, S_arm_x, t3, minus_U_follows_1_by_S_0, t4, t5, t6, t7,
      lower_omega_y, lower_alpha_still_x, lower_omega_x, t8, minus_upper_force_z, t9, U_handed_force_0, t10,
      minus_upper_force_x, t11, lower_acc_y, upper_force_y, t12, t13, t14, t15, t16, t17, t18,
      minus_lower_U_still_xx, minus_lower_rate_fx, minus_upper_rate_fy, t19, S_multiplier_fy,
      upper_moment_y, minus_upper_rate_fz, S_multiplier_fz, minus_upper_acc_still_x_2, minus_upper_rate_fx,
      t20, lower_rate_fy, t21, lower_rate_fz_2, t22, minus_upper_rate_my_2, minus_upper_rate_mx, t23,
      signed_lower_rotation_zx, minus_lower_rotation_yx, minus_upper_rate_mz_2, S_reaction_fy,
      S_reaction_my, S_reaction_mx, signed_S_reaction_mz, t24, t25, checked;
} LIMBS(forward_dynamics_reactions);

STAGE(forward_dynamics_reactions, 0)(size_t limb, size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, const double *restrict sine,
    const double *restrict cosine, REAL platform_twist_wy, REAL platform_twist_wz, REAL platform_twist_wx,
    LIMBS(forward_dynamics_reactions) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = -sign1 * param_R, each_k20 = -sign1 * k20,
      sign2 = OF4(1.0, -1.0, 1.0, -1.0), each_param_R_2 = sign1 * param_R,
      each_limb_lower_m_gravity_z = -sign2 * limb_lower_m_gravity_z, each_gravity_z = -sign2 * gravity_z;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: geometry; accelerations; inertia */
    OWN(minus_lower_rotation_yx) = signed_U_0_sin * lower_cos;
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    OWN(signed_lower_rotation_zx) = U_0_cos * lower_cos;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3);
    OWN(lower_omega_y) = U_v_0 * lower_cos;
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3);
    OWN(lower_alpha_still_x) = U_v_1 * OWN(lower_omega_y);
    const LIMB4 t74 = OWN(lower_omega_y) * OWN(lower_omega_y), t56 = U_v_1 * U_v_1;
    OWN(minus_lower_U_still_xx) = t74 + t56;
    OWN(upper_offset_x) = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    const LIMB4 minus_upper_acc_still_x = OWN(upper_offset_x) * OWN(minus_lower_U_still_xx),
      minus_U_0_acc_y = each_gravity_z * U_0_cos, minus_lower_acc_x = lower_cos * minus_U_0_acc_y;
    OWN(minus_upper_acc_still_x_2) = minus_upper_acc_still_x + minus_lower_acc_x;
    OWN(minus_upper_force_x) = limb_lower_m * minus_lower_acc_x;
    const LIMB4 minus_P_generalised_force = OWN(minus_upper_force_x) + IN_EACH4(READ, u, 0, 1),
      lower_composite_first_x = limb_lower_m * OWN(upper_offset_x), t1 = lower_composite_first_x + (-k7),
      t46 = lower_composite_first_x + t1, t2 = OWN(upper_offset_x) * t1, t3 = t2 + k8,
      U_mass_matrix_1_by_U_1 = t2 + k9, t4 = lower_cos * t3;
    OWN(U_mass_matrix_0_by_U_0) = lower_cos * t4 + k3;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2), t75 = sign1 * signed_lower_sin,
      t43 = t75 * t4 + lower_cos * (t75 * t3);
    OWN(lower_acc_y) = t75 * minus_U_0_acc_y;
    OWN(upper_force_y) = limb_lower_m * OWN(lower_acc_y);
    const LIMB4 lower_moment_z = OWN(upper_offset_x) * OWN(upper_force_y);
    OWN(lower_omega_x) = U_v_0 * t75;
    OWN(upper_position_x) = t75 * OWN(upper_offset_x) + each_param_R;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * OWN(upper_offset_x);
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = (-1.0) / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(U_follows_0_by_S_1) = OWN(upper_position_x) * OWN(t1);
    /* each limb: free motion; rates that follow; reciprocal wrenches, eq. (10) */
    const LIMB4 t6 = OWN(U_follows_0_by_S_1) * OWN(U_mass_matrix_0_by_U_0);
    OWN(t17) = signed_U_0_sin * t6;
    OWN(t2) = U_0_cos * t6;
    const LIMB4 t7 = OWN(U_follows_0_by_S_1) * t6;
    OWN(t3) = lower_cos * OWN(t1);
    OWN(S_arm_x) = OWN(upper_offset_x) - param_R * signed_lower_sin;
    OWN(minus_U_follows_1_by_S_0) = OWN(S_arm_x) * OWN(t3);
    const LIMB4 t12 = OWN(minus_U_follows_1_by_S_0) * (U_mass_matrix_1_by_U_1 * OWN(minus_U_follows_1_by_S_0));
    OWN(S_arm_y) = each_param_R * lower_cos;
    const LIMB4 t13 = OWN(S_arm_y) * (each_k20 * lower_cos) + t12, t15 = U_0_cos * (t7 - t13);
    OWN(t4) = signed_U_0_sin * t15;
    const LIMB4 t73 = U_0_cos * t15;
    OWN(t18) = t7 - t73;
    OWN(t14) = t13 + t73;
    const LIMB4 t66 = 0.5 * t43;
    /* each limb: accelerations; free motion */
    const LIMB4 minus_U_0_U_still_xx = U_v_0 * U_v_0, P_v = IN_EACH4(READ, v, 2, 3), t67 = minus_U_0_U_still_xx * t66,
      t36 = U_v_1 * P_v, t70 = lower_moment_z + (t67 + t36 * t46), t76 = sign2 * platform_twist_wz,
      t17 = signed_U_0_sin * t76;
    OWN(t6) = signed_U_0_sin * platform_twist_wy - U_0_cos * t76;
    const LIMB4 t34 = U_v_0 * OWN(t6), t37 = OWN(S_arm_x) * t34 + t36, t61 = OWN(S_arm_y) * t34;
    OWN(t5) = U_0_cos * platform_twist_wy + t17;
    const LIMB4 t28 = U_v_1 * lower_cos;
    OWN(t8) = t37 + OWN(t5) * (each_param_R_2 * t28 - P_v);
    /* each limb: free motion; accelerations; balance, eqs. (40)-(47) */
    OWN(t12) = OWN(t8) * OWN(t3);
    const LIMB4 t72 = OWN(minus_U_follows_1_by_S_0) * (t70 + U_mass_matrix_1_by_U_1 * OWN(t12)),
      t29 = OWN(upper_offset_x) * t28, t48 = lower_cos * (lower_cos * t46),
      t60 = minus_P_generalised_force + (minus_U_0_U_still_xx * (0.5 * t48) + t56 * (0.5 * t46)), t20 = U_v_1 * t75,
      t31 = OWN(t6) * (P_v * t75 + t29);
    OWN(t11) = OWN(t5) * (each_param_R_2 * t20) - t61;
    const LIMB4 S_handed_force_0 = OWN(S_arm_y) * (t60 + limb_lower_m * OWN(t11)) - t72;
    OWN(t16) = signed_U_0_sin * S_handed_force_0;
    OWN(t13) = U_0_cos * S_handed_force_0;
    const LIMB4 t21 = OWN(upper_offset_x) * t20, t19 = OWN(upper_position_x) * (U_v_0 * OWN(t5)),
      t51 = t43 * (U_v_0 * U_v_1) - t48 * (U_v_0 * P_v);
    OWN(minus_upper_force_z) = each_limb_lower_m_gravity_z * signed_U_0_sin;
    const LIMB4 t52 = lower_cos * (OWN(upper_offset_x) * OWN(minus_upper_force_z)) - t51, t23 = P_v * lower_cos - t21;
    OWN(t7) = U_v_0 * t23 - t19 - t31 - platform_twist_wx * t23;
    OWN(t9) = OWN(t1) * OWN(t7);
    OWN(U_handed_force_0) = t52 + OWN(U_mass_matrix_0_by_U_0) * OWN(t9);
    const LIMB4 S_handed_force_1 = OWN(U_follows_0_by_S_1) * OWN(U_handed_force_0);
    OWN(t15) = U_0_cos * S_handed_force_1;
    OWN(t10) = signed_U_0_sin * S_handed_force_1;
    OWN(checked) = checked;
}

STAGE(forward_dynamics_reactions, 1)(size_t limb, size_t stride, const double *restrict v,
    const double *restrict u, double *restrict a, const double *restrict sine, const double *restrict cosine,
    REAL minus_limb5_S_joint_acc_wz, REAL signed_limb5_S_joint_acc_wy, REAL signed_limb5_S_joint_acc_wx,
    REAL given, REAL limb1_U_factor_1_by_3, REAL minus_limb1_U_factor_0_by_3,
    LIMBS(forward_dynamics_reactions) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), each_k3 = sign1 * k3, sign2 = OF4(1.0, 1.0, -1.0, -1.0),
      each_gravity_z_limb_lower_mx = sign1 * gravity_z_limb_lower_mx, each_gravity_z = -sign1 * gravity_z;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: balance, eqs. (40)-(47) */
    const LIMB4 signed_limb1_U2_part_mn_by_P = signed_U_0_sin * OWN(S_arm_y) * given, P_u = IN_EACH4(READ, u, 0, 1);
    OWN(t23) = P_u * signed_limb1_U2_part_mn_by_P;
    OWN(t19) = P_u * (limb1_U_factor_1_by_3 * signed_limb1_U2_part_mn_by_P);
    OWN(t21) = P_u * (minus_limb1_U_factor_0_by_3 * signed_limb1_U2_part_mn_by_P);
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const LIMB4 t4 = OWN(U_follows_0_by_S_1) * (U_0_cos * minus_limb5_S_joint_acc_wz - signed_U_0_sin * signed_limb5_S_joint_acc_wy),
      signed_U_joint_acc_0 = signed_limb5_S_joint_acc_wx - (t4 - sign1 * OWN(t9));
    WRITE4(a, 0, 3, 6, 9, sign1 * signed_U_joint_acc_0);
    const LIMB4 t51 = sign1 * signed_U_joint_acc_0, lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      U_v_1 = IN_EACH4(READ, v, 1, 3), U_0_rate_mz = each_k3 * signed_U_joint_acc_0, lower_U_xz = lower_cos * t51,
      minus_lower_alpha_still_y = U_v_1 * OWN(lower_omega_x),
      minus_lower_alpha_y = minus_lower_alpha_still_y - lower_U_xz,
      lower_U_zx = minus_lower_alpha_still_y + minus_lower_alpha_y, t26 = OWN(upper_offset_x) * lower_U_zx,
      lower_rate_fz = limb_lower_mx * lower_U_zx;
    OWN(lower_rate_fz_2) = lower_rate_fz - OWN(minus_upper_force_z);
    const LIMB4 P_v = IN_EACH4(READ, v, 2, 3),
      minus_upper_acc_z = P_v * (2.0 * OWN(lower_omega_y)) + (each_gravity_z * signed_U_0_sin - t26);
    OWN(minus_upper_rate_fz) = lower_rate_fz + limb_lower_m * minus_upper_acc_z;
    const LIMB4 t28 = OWN(upper_offset_x) * OWN(minus_upper_rate_fz),
      minus_upper_rate_my = limb_lower_mx * minus_upper_acc_z, t29 = t28 - minus_upper_rate_my,
      t23 = k9 * minus_lower_alpha_still_y + k8 * minus_lower_alpha_y;
    OWN(t22) = k17 * minus_lower_alpha_still_y + k16 * minus_lower_alpha_y;
    OWN(minus_upper_rate_my_2) = minus_upper_rate_my + OWN(t22);
    OWN(upper_moment_y) = each_gravity_z_limb_lower_mx * signed_U_0_sin;
    const LIMB4 t30 = lower_cos * (OWN(upper_moment_y) + t23 - t29), t50 = sign2 * IN_EACH4(SINES, sine, 1, 2),
      t44 = k14 * (OWN(lower_alpha_still_x) + t50 * t51);
    OWN(S_multiplier_fz) = OWN(t1) * (U_0_rate_mz + (t50 * (k10 * OWN(lower_alpha_still_x)) - t30));
    const LIMB4 t35 = t50 * (OWN(S_arm_x) * OWN(S_multiplier_fz)) + lower_cos * (OWN(S_arm_y) * OWN(S_multiplier_fz)),
      t36 = U_0_cos * t35,
      t49 = sign1 * (signed_U_0_sin * minus_limb5_S_joint_acc_wz + U_0_cos * signed_limb5_S_joint_acc_wy),
      U_joint_acc_1 = OWN(t12) + OWN(minus_U_follows_1_by_S_0) * t49;
    WRITE4(a, 1, 4, 7, 10, U_joint_acc_1);
    const LIMB4 P_joint_acc = OWN(S_arm_y) * t49 - OWN(t11);
    WRITE4(a, 2, 5, 8, 11, P_joint_acc);
    const LIMB4 minus_lower_force_x = limb_lower_m * (OWN(minus_upper_acc_still_x_2) - P_joint_acc),
      lower_U_still_xy = OWN(lower_omega_x) * OWN(lower_omega_y), lower_U_yx = lower_U_still_xy + U_joint_acc_1,
      t14 = OWN(lower_acc_y) + OWN(upper_offset_x) * lower_U_yx, lower_rate_fy = limb_lower_mx * lower_U_yx;
    OWN(lower_rate_fy) = OWN(upper_force_y) + lower_rate_fy;
    const LIMB4 upper_acc_y = P_v * (2.0 * U_v_1) + t14;
    OWN(minus_upper_rate_fy) = lower_rate_fy - limb_lower_m * upper_acc_y;
    const LIMB4 t18 = OWN(upper_offset_x) * OWN(minus_upper_rate_fy),
      minus_upper_rate_mz = limb_lower_mx * upper_acc_y, t19 = t18 + minus_upper_rate_mz,
      t17 = k8 * lower_U_still_xy - (-k9) * U_joint_acc_1;
    OWN(minus_upper_rate_mz_2) = minus_upper_rate_mz + ((-k18) * U_joint_acc_1 - k19 * lower_U_still_xy);
    OWN(S_multiplier_fy) = OWN(t3) * (t19 - (limb_lower_mx * OWN(lower_acc_y) + t17));
    const LIMB4 t38 = OWN(S_arm_x) * OWN(S_multiplier_fy);
    OWN(minus_lower_rate_fx) = limb_lower_mx * OWN(minus_lower_U_still_xx);
    OWN(minus_upper_rate_fx) = minus_lower_force_x - OWN(minus_lower_rate_fx);
    OWN(t20) = t36 + signed_U_0_sin * (OWN(S_arm_y) * OWN(minus_upper_rate_fx) + t38);
    OWN(minus_upper_rate_mx) = k15 * OWN(lower_alpha_still_x) - t44;
}

STAGE(forward_dynamics_reactions, 2)(size_t limb, size_t stride, const double *restrict u,
    double *restrict reactions, const double *restrict sine, const double *restrict cosine,
    REAL signed_S_multiplier_fy, REAL signed_S_multiplier_fz, REAL minus_lower_sent_mx,
    REAL minus_upper_rate_mx, REAL minus_upper_rate_mz_2, LIMBS(forward_dynamics_reactions) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, 1.0, -1.0, 1.0), each_param_R = sign1 * param_R, each_param_R_2 = -sign1 * param_R,
      sign4 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 t66 = sign1 * IN_EACH4(SINES, sine, 1, 2), t67 = sign2 * signed_S_multiplier_fy,
      P_u = IN_EACH4(READ, u, 0, 1);
    /* each limb: balance, eqs. (40)-(47) */
    const LIMB4 t62 = t66 * t67, minus_S_multiplier_fx = P_u + OWN(minus_upper_rate_fx),
      lower_cos = IN_EACH4(SINES, cosine, 1, 2), t63 = t62 - lower_cos * minus_S_multiplier_fx,
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), t65 = U_0_cos * t63,
      t64 = signed_U_0_sin * t63, t68 = sign3 * signed_S_multiplier_fz;
    /* each limb: reactions, eq. (32); balance, eqs. (40)-(47); geometry */
    const LIMB4 t51 = signed_U_0_sin * t68;
    OWN(t25) = t65 + t51;
    const LIMB4 t47 = U_0_cos * t68;
    OWN(t24) = t64 - t47;
    const LIMB4 minus_upper_sent_fz = OWN(minus_upper_rate_fz) + t68, lower_rotation_yy = signed_U_0_sin * t66,
      S_reaction_fx = lower_rotation_yy * t67 - OWN(minus_lower_rotation_yx) * minus_S_multiplier_fx - t47;
    WRITE4(reactions, 13, 30, 49, 66, S_reaction_fx);
    const LIMB4 t60 = OWN(upper_position_x) * S_reaction_fx;
    OWN(S_reaction_fy) = lower_cos * t67 + t66 * minus_S_multiplier_fx;
    WRITE4(reactions, 12, 31, 48, 67, OWN(S_reaction_fy));
    const LIMB4 t53 = OWN(signed_lower_rotation_zx) * minus_S_multiplier_fx,
      minus_upper_position_y = OWN(upper_offset_x) * OWN(minus_lower_rotation_yx);
    OWN(signed_S_reaction_mz) = minus_upper_position_y * OWN(S_reaction_fy) + t60;
    const LIMB4 signed_lower_rotation_zy = U_0_cos * t66,
      signed_S_reaction_fz = t51 + (signed_lower_rotation_zy * t67 - t53);
    WRITE4(reactions, 14, 32, 50, 68, -sign4 * signed_S_reaction_fz);
    const LIMB4 upper_sent_fy = t67 - OWN(minus_upper_rate_fy), t57 = OWN(upper_position_x) * signed_S_reaction_fz,
      t56 = minus_upper_position_y * signed_S_reaction_fz,
      signed_upper_position_z = OWN(upper_offset_x) * OWN(signed_lower_rotation_zx);
    OWN(S_reaction_mx) = t57 + signed_upper_position_z * OWN(S_reaction_fy);
    OWN(S_reaction_my) = t56 - signed_upper_position_z * S_reaction_fx;
    const LIMB4 t33 = lower_rotation_yy * OWN(minus_upper_rate_my_2),
      P_reaction_fy = lower_rotation_yy * upper_sent_fy - U_0_cos * minus_upper_sent_fz;
    WRITE4(reactions, 7, 24, 43, 60, P_reaction_fy);
    const LIMB4 t38 = OWN(upper_position_x) * P_reaction_fy, t23 = signed_upper_position_z * P_reaction_fy,
      P_reaction_fx = lower_cos * upper_sent_fy;
    WRITE4(reactions, 6, 25, 42, 61, P_reaction_fx);
    const LIMB4 t30 = signed_upper_position_z * P_reaction_fx, t39 = minus_upper_position_y * P_reaction_fx + t38,
      t41 = signed_lower_rotation_zy * OWN(minus_upper_rate_my_2), t22 = signed_lower_rotation_zy * upper_sent_fy,
      lower_sent_fy = upper_sent_fy + OWN(lower_rate_fy),
      t43 = t41 - OWN(signed_lower_rotation_zx) * minus_upper_rate_mx,
      signed_P_reaction_mz = t39 - (signed_U_0_sin * minus_upper_rate_mz_2 - t43);
    WRITE4(reactions, 11, 29, 47, 65, sign4 * signed_P_reaction_mz);
    LIMB4 checked = OWN(checked) + signed_P_reaction_mz;
    const LIMB4 signed_P_reaction_fz = signed_U_0_sin * minus_upper_sent_fz + t22;
    WRITE4(reactions, 8, 26, 44, 62, -sign4 * signed_P_reaction_fz);
    const LIMB4 t25 = minus_upper_position_y * signed_P_reaction_fz - t23,
      t31 = OWN(upper_position_x) * signed_P_reaction_fz + t30,
      P_reaction_my = t31 + (OWN(minus_lower_rotation_yx) * minus_upper_rate_mx - t33 - U_0_cos * minus_upper_rate_mz_2);
    WRITE4(reactions, 10, 27, 46, 63, P_reaction_my);
    checked = checked + P_reaction_my;
    const LIMB4 P_reaction_mx = t25 - (lower_cos * OWN(minus_upper_rate_my_2) + t66 * minus_upper_rate_mx);
    WRITE4(reactions, 9, 28, 45, 64, P_reaction_mx);
    checked = checked + P_reaction_mx;
    /* each limb: balance, eqs. (40)-(47); reactions, eq. (32) */
    const LIMB4 t10 = OWN(upper_offset_x) * minus_upper_sent_fz - OWN(minus_upper_rate_my_2),
      lower_sent_fz = OWN(lower_rate_fz_2) - minus_upper_sent_fz,
      lower_sent_my = t10 - (OWN(upper_moment_y) + OWN(t22)), t11 = lower_cos * lower_sent_my,
      minus_lower_joint_sent_mx = t66 * lower_sent_my + lower_cos * minus_lower_sent_mx,
      t17 = U_0_cos * minus_lower_joint_sent_mx, t16 = signed_U_0_sin * minus_lower_joint_sent_mx,
      t4 = t66 * lower_sent_fy, t2 = lower_cos * lower_sent_fy,
      minus_lower_sent_fx = OWN(minus_lower_rate_fx) + OWN(minus_upper_force_x) - P_u,
      minus_lower_joint_sent_fx = lower_cos * minus_lower_sent_fx + t4,
      lower_joint_sent_fy = t2 - t66 * minus_lower_sent_fx;
    WRITE4(reactions, 0, 19, 36, 55, lower_joint_sent_fy);
    checked = checked + lower_joint_sent_fy;
    const LIMB4 lower_joint_sent_my = t11 - t66 * minus_lower_sent_mx;
    WRITE4(reactions, 3, 22, 39, 58, lower_joint_sent_my);
    checked = checked + lower_joint_sent_my;
    const LIMB4 t7 = U_0_cos * minus_lower_joint_sent_fx,
      U_0_joint_sent_fx = signed_U_0_sin * minus_lower_joint_sent_fx + U_0_cos * lower_sent_fz;
    WRITE4(reactions, 1, 18, 37, 54, U_0_joint_sent_fx);
    const LIMB4 signed_U_reaction_mz = t17 - each_param_R_2 * U_0_joint_sent_fx;
    WRITE4(reactions, 5, 23, 41, 59, -sign4 * signed_U_reaction_mz);
    checked = checked + signed_U_reaction_mz;
    const LIMB4 signed_U_0_joint_sent_fy = t7 - signed_U_0_sin * lower_sent_fz;
    WRITE4(reactions, 2, 20, 38, 56, -sign4 * signed_U_0_joint_sent_fy);
    const LIMB4 U_reaction_my = t16 - each_param_R * signed_U_0_joint_sent_fy;
    WRITE4(reactions, 4, 21, 40, 57, U_reaction_my);
    checked = checked + U_reaction_my;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_forward_dynamics_reactions)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, double *restrict a, double *restrict reactions,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(forward_dynamics_reactions) limbs;
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t14 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t14,
      platform_turn_xx = 1.0 - t6 * t9, t12 = limb5_S_q_qy * t9, t34 = limb5_S_q_qx * t12, t13 = limb5_S_q_qw * t12,
      t10 = limb5_S_q_qz * t9, t26 = limb5_S_q_qw * (limb5_S_q_qx * t9), t35 = limb5_S_q_qw * t10,
      platform_turn_yx = t34 + t35, platform_turn_xy = t34 - t35, limb5_S_v_wx = READ(v, 12),
      limb5_S_v_wy = READ(v, 13), t42 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      t24 = limb5_S_q_qy * t10, t11 = limb5_S_q_qx * t10, platform_turn_yz = t24 - t26, platform_turn_zy = t24 + t26,
      limb5_S_v_wz = READ(v, 14), platform_twist_wy = t42 + limb5_S_v_wz * platform_turn_yz,
      platform_turn_zx = t11 - t13, platform_turn_xz = t11 + t13,
      t52 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t52,
      t47 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      platform_twist_wx = t47 + limb5_S_v_wz * platform_turn_xz;
    FIRST_LIMB(0, forward_dynamics_reactions, 0, stride, q, v, u, sine, cosine, platform_twist_wy, platform_twist_wz, platform_twist_wx, &limbs);
    /* limb1: geometry */
    const REAL limb1_lower_sin = SINES(sine, 1), limb1_lower_cos = SINES(cosine, 1);
    /* limb1: loop closure; reciprocal wrenches, eq. (10); rates that follow */
    const REAL t59 = limbs.lower_omega_y[0] - (limb1_lower_sin * limbs.t6[0] + limb1_lower_cos * platform_twist_wx),
      limb1_U_v_1 = READ(v, 1), t60 = limb1_U_v_1 * t59, t54 = limb1_U_v_1 - limbs.t5[0],
      limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0),
      t62 = limbs.lower_alpha_still_x[0] - (limbs.lower_omega_y[0] * t54 - t60),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t63 = limb1_U2_constraint_mn_couple_x * t62, t64 = limbs.lower_omega_x[0] * t59,
      t68 = limbs.lower_omega_x[0] + (limb1_lower_cos * limbs.t6[0] - limb1_lower_sin * platform_twist_wx),
      t70 = t64 - limbs.lower_omega_y[0] * t68,
      t32 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t73 = limb1_lower_sin * t32,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t32 - limb1_lower_sin * platform_turn_xy,
      t72 = t63 - limb1_U2_constraint_mn_couple_z * t70,
      limb1_U2_opening_mn = t73 + limb1_lower_cos * platform_turn_xy,
      t78 = t68 * (limb1_U2_opening_mn * t68 + limb1_U2_constraint_mn_couple_z * t59),
      limb1_U2_opening_bias_mn = t72 - (t78 - t54 * (limb1_U2_constraint_mn_couple_x * t59 - limb1_U2_opening_mn * t54)),
      minus_limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t3[0],
      t85 = limb1_U2_opening_bias_mn + limbs.t8[0] * minus_limb1_U_factor_1_by_3, /* limb5_S */
      limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      t86 = limb1_U_factor_0_by_3 * limbs.t7[0] + t85, /* limb5_S */
      t28 = limbs.upper_position_x[0] * limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t28,
      t29 = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3, t99 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z + limbs.S_arm_x[0] * minus_limb1_U_factor_1_by_3,
      t38 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    /* limb5_S: pivots; accelerations; rates that follow */
    const REAL minus_limb5_S_pivot_wz = t29 + t38;
    REAL checked0 = minus_limb5_S_pivot_wz;
    const REAL t39 = 1.0 / minus_limb5_S_pivot_wz, limb5_S_joint_acc_still_wz = t39 * t86,
      limb5_S_null_space_wz_by_limb5_S_wy = t39 * (t99 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3);
    NEXT_LIMB(2, forward_dynamics_reactions, 0, stride, q, v, u, sine, cosine, platform_twist_wy, platform_twist_wz, platform_twist_wx, &limbs);
    /* limb5_S: free motion; accelerations; momentum rate, eq. (35) */
    const REAL t16 = k12 * platform_turn_zz, t104 = k13 + platform_turn_zz * t16 + limbs.t14[2],
      t18 = platform_turn_xz * t16 + limbs.t2[2];
    NEXT_LIMB(1, forward_dynamics_reactions, 0, stride, q, v, u, sine, cosine, platform_twist_wx, platform_twist_wz, platform_twist_wy, &limbs);
    NEXT_LIMB(3, forward_dynamics_reactions, 0, stride, q, v, u, sine, cosine, platform_twist_wx, platform_twist_wz, platform_twist_wy, &limbs);
    const REAL limb5_S_handed_inertia_wz = limbs.t14[0] + (limbs.t14[3] + (limbs.t14[1] + t104)),
      limb5_S_handed_inertia_wz_by_limb5_S_wx = limbs.t2[0] + (limbs.t4[3] + (t18 + limbs.t4[1])),
      t107 = limb5_S_handed_inertia_wz * limb5_S_joint_acc_still_wz,
      t149 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz,
      minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      platform_U_still_yz = limb5_S_v_wy * limb5_S_v_wz, t88 = k12 * platform_U_still_yz,
      platform_rate_mx = t88 - minus_platform_moment_x, t108 = platform_turn_zx * platform_rate_mx,
      platform_moment_y = gravity_z_platform_mz * platform_turn_zx, platform_U_still_xz = limb5_S_v_wx * limb5_S_v_wz,
      t90 = k12 * platform_U_still_xz, minus_platform_rate_my = t90 - platform_moment_y,
      t113 = limbs.t16[3] - (t108 - platform_turn_zy * minus_platform_rate_my + limbs.t16[2] - limbs.t16[1]),
      minus_limb5_S_handed_force_wz = limbs.t15[3] + (limbs.t15[1] - (limbs.t15[2] + (limbs.t16[0] - t113))) - limbs.t15[0] - t107,
      t119 = limb5_S_null_space_wz_by_limb5_S_wy * minus_limb5_S_handed_force_wz, t120 = k12 * platform_turn_yz,
      t125 = limbs.t4[0] + (limbs.t2[3] + (limbs.t2[1] - (platform_turn_zz * t120 - limbs.t4[2]))),
      t126 = t125 * limb5_S_joint_acc_still_wz, t152 = limb5_S_null_space_wz_by_limb5_S_wy * (t125 + (t125 - t149)),
      t89 = platform_turn_xx * platform_rate_mx,
      t130 = platform_turn_yx * platform_rate_mx - platform_turn_yy * minus_platform_rate_my + limbs.t13[2],
      t134 = limbs.U_handed_force_0[3] + (limbs.U_handed_force_0[1] - (limbs.t10[2] - (limbs.t13[0] + t130))),
      limb5_S_reduced_force_wy = t119 - (t134 - limbs.t10[0] - t126),
      t95 = limbs.U_handed_force_0[2] + (limbs.t13[3] + (t89 - platform_turn_xy * minus_platform_rate_my + limbs.t13[1])),
      t98 = limbs.t10[3] + (limbs.t10[1] - t95) - limbs.U_handed_force_0[0],
      t147 = limbs.U_mass_matrix_0_by_U_0[3] + (limbs.U_mass_matrix_0_by_U_0[1] + (k13 + platform_turn_yz * t120 + limbs.t18[2])),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = limbs.t18[0] + t147 - t152;
    REAL checked1 = limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t153 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t141 = platform_turn_xz * t120 - limbs.t17[2] - limbs.t17[1] - limbs.t17[3] - limbs.t17[0],
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t141 + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz_by_limb5_S_wx,
      limb5_S_reduced_force_wx = t98 - limb5_S_handed_inertia_wz_by_limb5_S_wx * limb5_S_joint_acc_still_wz;
    /* platform: accelerations; pivots; balance, eqs. (40)-(47) */
    const REAL t154 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t153,
      t163 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t154, t165 = limb5_S_reduced_force_wy * t153,
      t156 = limb5_S_reduced_force_wx - limb5_S_reduced_force_wy * t154,
      t161 = limbs.U_mass_matrix_0_by_U_0[2] + (k13 + platform_turn_xz * (k12 * platform_turn_xz)) + limbs.t18[1],
      pivot_1 = limbs.U_mass_matrix_0_by_U_0[0] + (limbs.t18[3] + t161) - t163;
    REAL checked2 = pivot_1;
    const REAL limb5_S_joint_acc_wx = t156 / pivot_1, minus_limb5_S_joint_acc_wy = t154 * limb5_S_joint_acc_wx - t165,
      minus_limb5_S_joint_acc_wz = limb5_S_null_space_wz_by_limb5_S_wy * minus_limb5_S_joint_acc_wy - limb5_S_joint_acc_still_wz,
      t171 = platform_turn_zy * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_y = t171 + (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy * limb5_S_joint_acc_wx),
      platform_rate_fx = platform_mz * (platform_U_still_xz - minus_platform_alpha_y);
    WRITE(a, 13, -minus_platform_alpha_y);
    const REAL t190 = platform_turn_zy * (platform_moment_y - (t90 + k13 * minus_platform_alpha_y)),
      t167 = platform_turn_zx * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_x = t167 + (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx * limb5_S_joint_acc_wx),
      platform_rate_fy = platform_mz * (platform_U_still_yz + minus_platform_alpha_x);
    WRITE(a, 12, -minus_platform_alpha_x);
    const REAL t194 = t190 - platform_turn_zx * (minus_platform_moment_x - (t88 - k13 * minus_platform_alpha_x)),
      t175 = platform_turn_zz * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_z = t175 + (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz * limb5_S_joint_acc_wx);
    WRITE(a, 14, -minus_platform_alpha_z);
    const REAL t195 = platform_turn_zz * (platform_Izz * minus_platform_alpha_z) - t194,
      t181 = limb1_lower_cos * (limb1_U2_constraint_mn_couple_x - limbs.S_arm_y[0] * limb1_U_factor_0_by_3), /* limb1 */
      platform_joint_force_mz_by_limb1_U2_mn = limb1_U_0_cos * (t181 - limb1_lower_sin * (limbs.S_arm_x[0] * limb1_U_factor_0_by_3)) + t38;
    REAL checked3 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t186 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      limb1_U_factor_1_by_3 = -minus_limb1_U_factor_1_by_3, minus_limb1_U_factor_0_by_3 = -limb1_U_factor_0_by_3;
    FIRST_LIMB(0, forward_dynamics_reactions, 1, stride, v, u, a, sine, cosine, minus_limb5_S_joint_acc_wz, minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx, t186, limb1_U_factor_1_by_3, minus_limb1_U_factor_0_by_3, &limbs);
    const REAL t196 = t195 - limbs.t20[0];
    NEXT_LIMB(1, forward_dynamics_reactions, 1, stride, v, u, a, sine, cosine, minus_limb5_S_joint_acc_wz, limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_wy, t186, limb1_U_factor_1_by_3, minus_limb1_U_factor_0_by_3, &limbs);
    const REAL t197 = limbs.t20[1] + t196;
    NEXT_LIMB(2, forward_dynamics_reactions, 1, stride, v, u, a, sine, cosine, minus_limb5_S_joint_acc_wz, minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx, t186, limb1_U_factor_1_by_3, minus_limb1_U_factor_0_by_3, &limbs);
    NEXT_LIMB(3, forward_dynamics_reactions, 1, stride, v, u, a, sine, cosine, minus_limb5_S_joint_acc_wz, limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_wy, t186, limb1_U_factor_1_by_3, minus_limb1_U_factor_0_by_3, &limbs);
    /* limb1: balance, eqs. (40)-(47) */
    const REAL minus_limb1_U2_part_mn = t186 * (limbs.t20[2] - t197 - limbs.t20[3]),
      t200 = minus_limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn - limbs.S_multiplier_fy[0] - limbs.t19[0],
      minus_limb1_U2_multiplier_fy = limbs.t19[3] - (limbs.t19[2] - (limbs.t19[1] + t200)),
      t203 = limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn,
      limb1_U2_multiplier_mn = limbs.t23[3] - (limbs.t23[2] + (limbs.t23[0] + minus_limb1_U2_part_mn - limbs.t23[1]));
    /* limb1: reactions, eq. (32); balance, eqs. (40)-(47) */
    const REAL minus_limb1_U2_joint_reaction_mx = limb1_U2_constraint_mn_couple_x * limb1_U2_multiplier_mn,
      minus_limb1_U2_joint_reaction_mz = limb1_U2_constraint_mn_couple_z * limb1_U2_multiplier_mn,
      limb1_U2_multiplier_fz = limbs.t21[3] - (limbs.t21[2] - (limbs.t21[1] + (limbs.S_multiplier_fz[0] + t203 - limbs.t21[0]))),
      minus_limb1_upper_sent_mx = minus_limb1_U2_joint_reaction_mx + limbs.minus_upper_rate_mx[0],
      minus_limb1_lower_sent_mx = limbs.minus_upper_rate_mx[0] + minus_limb1_upper_sent_mx;
    FIRST_LIMB(0, forward_dynamics_reactions, 2, stride, u, reactions, sine, cosine, minus_limb1_U2_multiplier_fy, limb1_U2_multiplier_fz, minus_limb1_lower_sent_mx, minus_limb1_upper_sent_mx, minus_limb1_U2_joint_reaction_mz + limbs.minus_upper_rate_mz_2[0], &limbs);
    checked0 = checked0 + ALONE(limbs.checked[0]);
    RESULT(checked1, reactions, 15, limbs.S_reaction_my[0] - limb1_lower_sin * minus_limb1_U2_joint_reaction_mx);
    const REAL t214 = limb1_U_0_sin * minus_limb1_U2_joint_reaction_mz,
      t211 = limb1_U_0_cos * minus_limb1_U2_joint_reaction_mz;
    RESULT(checked2, reactions, 17, limbs.signed_S_reaction_mz[0] - (t214 + limbs.signed_lower_rotation_zx[0] * minus_limb1_U2_joint_reaction_mx));
    const REAL minus_limb1_U2_reaction_my = t211 - limbs.minus_lower_rotation_yx[0] * minus_limb1_U2_joint_reaction_mx - limbs.S_reaction_mx[0];
    checked3 = checked3 + minus_limb1_U2_reaction_my;
    WRITE(reactions, 16, -minus_limb1_U2_reaction_my);
    /* platform: momentum rate, eq. (35) */
    const REAL platform_rate_fy_2 = platform_m_gravity_z * platform_turn_zy + platform_rate_fy;
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t239 = platform_turn_zy * platform_rate_fy_2, t222 = platform_turn_xy * platform_rate_fy_2,
      t231 = platform_turn_yy * platform_rate_fy_2,
      platform_rate_fx_2 = platform_m_gravity_z * platform_turn_zx + platform_rate_fx,
      t241 = t239 + platform_turn_zx * platform_rate_fx_2, t225 = t222 + platform_turn_xx * platform_rate_fx_2,
      t233 = t231 + platform_turn_yx * platform_rate_fx_2, t219 = platform_m_gravity_z * platform_turn_zz,
      minus_platform_rate_fz_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t219,
      t243 = limbs.t25[0] - (platform_turn_zz * minus_platform_rate_fz_2 - t241),
      t227 = limbs.S_reaction_fy[0] + (platform_turn_xz * minus_platform_rate_fz_2 - t225),
      t235 = limbs.t24[0] + (platform_turn_yz * minus_platform_rate_fz_2 - t233);
    NEXT_LIMB(1, forward_dynamics_reactions, 2, stride, u, reactions, sine, cosine, limbs.S_multiplier_fy[1], limbs.S_multiplier_fz[1], 2.0 * limbs.minus_upper_rate_mx[1], limbs.minus_upper_rate_mx[1], limbs.minus_upper_rate_mz_2[1], &limbs);
    WRITE(reactions, 34, limbs.S_reaction_my[1]);
    checked0 = checked0 + limbs.S_reaction_my[1];
    WRITE(reactions, 33, limbs.S_reaction_mx[1]);
    checked1 = checked1 + limbs.S_reaction_mx[1];
    checked2 = checked2 + limbs.signed_S_reaction_mz[1];
    checked3 = checked3 + ALONE(limbs.checked[1]);
    const REAL t244 = t243 - limbs.t25[1], t228 = limbs.t24[1] + t227, t236 = limbs.S_reaction_fy[1] + t235;
    WRITE(reactions, 35, -limbs.signed_S_reaction_mz[1]);
    NEXT_LIMB(2, forward_dynamics_reactions, 2, stride, u, reactions, sine, cosine, limbs.S_multiplier_fy[2], -limbs.S_multiplier_fz[2], 2.0 * limbs.minus_upper_rate_mx[2], limbs.minus_upper_rate_mx[2], limbs.minus_upper_rate_mz_2[2], &limbs);
    WRITE(reactions, 51, limbs.S_reaction_my[2]);
    checked0 = checked0 + limbs.S_reaction_my[2];
    WRITE(reactions, 52, limbs.S_reaction_mx[2]);
    checked1 = checked1 + limbs.S_reaction_mx[2];
    WRITE(reactions, 53, limbs.signed_S_reaction_mz[2]);
    checked2 = checked2 + limbs.signed_S_reaction_mz[2];
    checked3 = checked3 + ALONE(limbs.checked[2]);
    const REAL t245 = limbs.t25[2] + t244, t229 = limbs.S_reaction_fy[2] + t228, t237 = limbs.t24[2] + t236;
    NEXT_LIMB(3, forward_dynamics_reactions, 2, stride, u, reactions, sine, cosine, -limbs.S_multiplier_fy[3], limbs.S_multiplier_fz[3], 2.0 * limbs.minus_upper_rate_mx[3], limbs.minus_upper_rate_mx[3], limbs.minus_upper_rate_mz_2[3], &limbs);
    WRITE(reactions, 70, limbs.S_reaction_my[3]);
    checked0 = checked0 + limbs.S_reaction_my[3];
    WRITE(reactions, 69, limbs.S_reaction_mx[3]);
    checked1 = checked1 + limbs.S_reaction_mx[3];
    checked2 = checked2 + limbs.signed_S_reaction_mz[3];
    checked3 = checked3 + ALONE(limbs.checked[3]);
    RESULT(checked0, reactions, 74, t245 - limbs.t25[3]);
    const REAL minus_platform_joint_sent_fx = limbs.t24[3] + t229;
    checked1 = checked1 + minus_platform_joint_sent_fx;
    WRITE(reactions, 72, -minus_platform_joint_sent_fx);
    const REAL minus_platform_joint_sent_fy = limbs.S_reaction_fy[3] + t237;
    checked2 = checked2 + minus_platform_joint_sent_fy;
    WRITE(reactions, 73, -minus_platform_joint_sent_fy);
    WRITE(reactions, 71, -limbs.signed_S_reaction_mz[3]);
    WRITE(reactions, 75, CONSTANT(0.0));
    WRITE(reactions, 76, CONSTANT(0.0));
    WRITE(reactions, 77, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-06, 6.62327e-06, 6.62327e-06, 6.62327e-06) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-05) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 0.0007562600000000001) OR /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 0.0007551200000000001) OR /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.017100000000001e-06), /* where limb1_U2.mn cannot balance platform.moment_z */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_VECTORS)

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
#define THREE_UPS_UPU_S_VECTORS
#define THREE_UPS_UPU_S_LANES 4
#include "three_ups_upu_s_support.h" /* for all limbs at once */
#include "three_ups_upu_s_forward_dynamics.c"
#undef THREE_UPS_UPU_S_VECTORS
#undef THREE_UPS_UPU_S_LANES
#include "three_ups_upu_s_support.h" /* for one limb again */
#endif

typedef struct {
    EACH4 signed_lower_omega_y, signed_lower_omega_x, signed_lower_alpha_still_x, t1, t2, t3, t4, t5, t6,
      t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, checked;
} LIMBS(forward_dynamics_dense);

STAGE(forward_dynamics_dense, 0)(size_t limb, size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, double *restrict inertia_, double *restrict load_,
    double *restrict closure_, double *restrict curvature_, const double *restrict sine,
    const double *restrict cosine, REAL platform_turn_yx, REAL platform_turn_zx, REAL platform_turn_xx,
    REAL platform_turn_yy, REAL platform_turn_zy, REAL platform_turn_xy, REAL platform_turn_yz,
    REAL platform_turn_zz, REAL platform_turn_xz, REAL platform_twist_wy, REAL platform_twist_wz,
    REAL platform_twist_wx, LIMBS(forward_dynamics_dense) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      each_gravity_z = sign2 * gravity_z, each_gravity_z_limb_lower_mx = sign2 * gravity_z_limb_lower_mx,
      each_gravity_z_2 = -sign2 * gravity_z, sign3 = OF4(1.0, -1.0, 1.0, -1.0);
    /* each limb: geometry */
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    WRITE4(closure_, 14, 57, 99, 141, upper_offset_x);
    /* each limb: inertia; velocities, eq. (6) */
    const LIMB4 t2 = upper_offset_x * (limb_lower_m * upper_offset_x + (-k7)), U_mass_matrix_1_by_U_1 = t2 + k9;
    WRITE4(inertia_, 16, 64, 112, 160, U_mass_matrix_1_by_U_1);
    LIMB4 checked = U_mass_matrix_1_by_U_1;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2), t3 = t2 + k8, t58 = sign1 * lower_cos,
      U_mass_matrix_0_by_U_0 = t58 * (t58 * t3) + k3;
    WRITE4(inertia_, 0, 48, 96, 144, U_mass_matrix_0_by_U_0);
    checked = checked + U_mass_matrix_0_by_U_0;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(signed_lower_omega_x) = U_v_0 * signed_lower_sin;
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3);
    /* each limb: accelerations; balance, eqs. (40)-(47); free motion */
    const LIMB4 signed_lower_alpha_still_y = U_v_1 * OWN(signed_lower_omega_x),
      t8 = upper_offset_x * (2.0 * signed_lower_alpha_still_y), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      t9 = t8 + each_gravity_z * signed_U_0_sin;
    OWN(signed_lower_omega_y) = U_v_0 * t58;
    const LIMB4 lower_U_still_xy = OWN(signed_lower_omega_x) * OWN(signed_lower_omega_y),
      P_v = IN_EACH4(READ, v, 2, 3), t7 = P_v * (2.0 * OWN(signed_lower_omega_y)), signed_upper_acc_still_z = t7 - t9,
      signed_upper_acc_still_z_2 = t8 - t7, signed_upper_rate_my = limb_lower_mx * signed_upper_acc_still_z,
      t11 = upper_offset_x * (k7 * signed_lower_alpha_still_y + limb_lower_m * signed_upper_acc_still_z) - signed_upper_rate_my,
      t13 = t58 * (each_gravity_z_limb_lower_mx * signed_U_0_sin + k11 * signed_lower_alpha_still_y - t11);
    OWN(signed_lower_alpha_still_x) = U_v_1 * OWN(signed_lower_omega_y);
    const LIMB4 minus_U_0_moment_z = t13 - signed_lower_sin * (k10 * OWN(signed_lower_alpha_still_x));
    WRITE4(load_, 0, 3, 6, 9, minus_U_0_moment_z);
    checked = checked + minus_U_0_moment_z;
    const LIMB4 t22 = OWN(signed_lower_omega_y) * OWN(signed_lower_omega_y), t17 = upper_offset_x * lower_U_still_xy,
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_acc_y = each_gravity_z_2 * U_0_cos,
      lower_acc_y = signed_lower_sin * signed_U_0_acc_y, minus_lower_acc_x = t58 * signed_U_0_acc_y,
      t18 = t17 + lower_acc_y, minus_upper_moment_z = limb_lower_mx * lower_acc_y, t16 = P_v * (2.0 * U_v_1),
      upper_acc_still_y = t16 + t18, upper_acc_still_y_2 = t17 + t16,
      minus_upper_rate_mz = limb_lower_mx * upper_acc_still_y,
      t20 = minus_upper_rate_mz + upper_offset_x * (limb_lower_mx * lower_U_still_xy - limb_lower_m * upper_acc_still_y),
      minus_lower_moment_z = t20 - (k8 * lower_U_still_xy + minus_upper_moment_z);
    WRITE4(load_, 1, 4, 7, 10, minus_lower_moment_z);
    checked = checked + minus_lower_moment_z;
    const LIMB4 minus_lower_U_still_xx = t22 + U_v_1 * U_v_1,
      minus_upper_acc_still_x = upper_offset_x * minus_lower_U_still_xx,
      minus_lower_force_x = limb_lower_m * (minus_upper_acc_still_x + minus_lower_acc_x),
      minus_P_generalised_force = IN_EACH4(READ, u, 0, 1) + (minus_lower_force_x - limb_lower_mx * minus_lower_U_still_xx);
    WRITE4(load_, 2, 5, 8, 11, minus_P_generalised_force);
    checked = checked + minus_P_generalised_force;
    const LIMB4 base_lever_mx_by_S_fx = param_R * (U_0_cos * t58);
    /* each limb: loop closure; reciprocal wrenches, eq. (10); geometry */
    OWN(t1) = platform_turn_yx * base_lever_mx_by_S_fx;
    OWN(t7) = platform_turn_yy * base_lever_mx_by_S_fx;
    OWN(t13) = platform_turn_yz * base_lever_mx_by_S_fx;
    const LIMB4 signed_base_lever_mz_by_S_fx = param_R * (signed_U_0_sin * t58);
    OWN(t2) = platform_turn_zx * signed_base_lever_mz_by_S_fx;
    OWN(t8) = platform_turn_zy * signed_base_lever_mz_by_S_fx;
    OWN(t14) = platform_turn_zz * signed_base_lever_mz_by_S_fx;
    const LIMB4 base_lever_mx_by_S_fy = U_0_cos * upper_offset_x - param_R * (U_0_cos * signed_lower_sin);
    OWN(t3) = platform_turn_yx * base_lever_mx_by_S_fy;
    OWN(t9) = platform_turn_yy * base_lever_mx_by_S_fy;
    OWN(t15) = platform_turn_yz * base_lever_mx_by_S_fy;
    const LIMB4 signed_base_lever_mz_by_S_fy = signed_U_0_sin * upper_offset_x - param_R * (signed_U_0_sin * signed_lower_sin);
    OWN(t4) = platform_turn_zx * signed_base_lever_mz_by_S_fy;
    OWN(t10) = platform_turn_zy * signed_base_lever_mz_by_S_fy;
    OWN(t16) = platform_turn_zz * signed_base_lever_mz_by_S_fy;
    const LIMB4 signed_upper_position_x = signed_lower_sin * upper_offset_x + (-param_R),
      signed_base_lever_mx_by_S_fz = signed_U_0_sin * signed_upper_position_x,
      signed_base_lever_mz_by_S_fz = U_0_cos * signed_upper_position_x;
    OWN(t6) = platform_turn_zx * signed_base_lever_mz_by_S_fz;
    OWN(t12) = platform_turn_zy * signed_base_lever_mz_by_S_fz;
    OWN(t18) = platform_turn_zz * signed_base_lever_mz_by_S_fz;
    const LIMB4 t29 = platform_turn_yx * signed_base_lever_mx_by_S_fz,
      signed_U_0_lever_mz_by_S_fz = t58 * upper_offset_x;
    WRITE4(closure_, 2, 45, 87, 129, -sign1 * signed_U_0_lever_mz_by_S_fz);
    OWN(t5) = platform_turn_xx * signed_U_0_lever_mz_by_S_fz + t29;
    const LIMB4 t31 = platform_turn_yy * signed_base_lever_mx_by_S_fz,
      t33 = platform_turn_yz * signed_base_lever_mx_by_S_fz;
    OWN(t11) = platform_turn_xy * signed_U_0_lever_mz_by_S_fz + t31;
    OWN(t17) = platform_turn_xz * signed_U_0_lever_mz_by_S_fz + t33;
    const LIMB4 t59 = sign3 * platform_twist_wz, t47 = signed_U_0_sin * t59,
      t36 = signed_U_0_sin * platform_twist_wy - U_0_cos * t59, t39 = t58 * t36;
    OWN(t19) = signed_lower_sin * t36 + t58 * platform_twist_wx;
    const LIMB4 t60 = sign1 * OWN(t19), S_arm_x = upper_offset_x - param_R * signed_lower_sin, t43 = S_arm_x * t60;
    OWN(t20) = t39 - signed_lower_sin * platform_twist_wx;
    const LIMB4 signed_S_arm_y = param_R * lower_cos, t44 = signed_S_arm_y * OWN(t20) - t43, t45 = t60 * t44,
      t53 = OWN(t20) * t44;
    OWN(t21) = U_0_cos * platform_twist_wy + t47;
    const LIMB4 t48 = S_arm_x * OWN(t21), t51 = signed_S_arm_y * OWN(t21), t56 = t60 * t51,
      t54 = OWN(t21) * t51 + t53, S_opening_bias_fx = OWN(t21) * t48 - t45 - minus_upper_acc_still_x;
    WRITE4(curvature_, 0, 4, 7, 10, S_opening_bias_fx);
    checked = checked + S_opening_bias_fx;
    const LIMB4 signed_S_opening_bias_fz = signed_upper_acc_still_z_2 + (OWN(t20) * t48 + t56);
    WRITE4(curvature_, 2, 6, 9, 12, sign1 * signed_S_opening_bias_fz);
    checked = checked + signed_S_opening_bias_fz;
    const LIMB4 S_opening_bias_fy = upper_acc_still_y_2 - sign1 * t54;
    WRITE4(curvature_, 1, 5, 8, 11, S_opening_bias_fy);
    checked = checked + S_opening_bias_fy;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_forward_dynamics_dense)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, double *restrict inertia_, double *restrict load_,
    double *restrict closure_, double *restrict curvature_, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    LIMBS(forward_dynamics_dense) limbs;
    /* limb5_S: geometry; momentum rate, eq. (35); velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t50 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t50,
      platform_turn_xx = 1.0 - t6 * t9, t10 = limb5_S_q_qz * t9, t11 = limb5_S_q_qy * t10,
      t13 = limb5_S_q_qw * (limb5_S_q_qx * t9), t17 = limb5_S_q_qy * t9, platform_turn_zy = t11 + t13,
      platform_turn_yz = t11 - t13, limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14),
      minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - k12 * (limb5_S_v_wy * limb5_S_v_wz);
    WRITE(load_, 12, minus_platform_rate_mx);
    REAL checked0 = minus_platform_rate_mx;
    const REAL t16 = limb5_S_q_qx * t10, t28 = limb5_S_q_qw * t10, t18 = limb5_S_q_qw * t17, t27 = limb5_S_q_qx * t17,
      platform_turn_zx = t16 - t18, platform_turn_xz = t16 + t18, limb5_S_v_wx = READ(v, 12),
      minus_platform_rate_my = k12 * (limb5_S_v_wx * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zx;
    WRITE(load_, 13, minus_platform_rate_my);
    REAL checked1 = minus_platform_rate_my;
    const REAL platform_turn_yx = t27 + t28, platform_turn_xy = t27 - t28,
      t62 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      platform_twist_wy = t62 + limb5_S_v_wz * platform_turn_yz,
      t71 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t71,
      t66 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      platform_twist_wx = t66 + limb5_S_v_wz * platform_turn_xz;
    FIRST_LIMB(0, forward_dynamics_dense, 0, stride, q, v, u, inertia_, load_, closure_, curvature_, sine, cosine, platform_turn_yx, platform_turn_zx, platform_turn_xx, platform_turn_yy, platform_turn_zy, platform_turn_xy, platform_turn_yz, platform_turn_zz, platform_turn_xz, platform_twist_wy, platform_twist_wz, platform_twist_wx, &limbs);
    REAL checked2 = ALONE(limbs.checked[0]);
    /* mechanism: loop closure */
    const REAL closure_158 = limbs.t5[0] - limbs.t6[0];
    WRITE(closure_, 158, closure_158);
    REAL checked3 = closure_158;
    RESULT(checked0, closure_, 171, limbs.t11[0] - limbs.t12[0]);
    RESULT(checked1, closure_, 184, limbs.t17[0] - limbs.t18[0]);
    NEXT_LIMB(1, forward_dynamics_dense, 0, stride, q, v, u, inertia_, load_, closure_, curvature_, sine, cosine, platform_turn_xx, platform_turn_zx, platform_turn_yx, platform_turn_xy, platform_turn_zy, platform_turn_yy, platform_turn_xz, platform_turn_zz, platform_turn_yz, platform_twist_wx, platform_twist_wz, platform_twist_wy, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[1]);
    RESULT(checked3, closure_, 160, limbs.t2[1] - limbs.t1[1]);
    RESULT(checked0, closure_, 161, limbs.t4[1] - limbs.t3[1]);
    RESULT(checked1, closure_, 162, limbs.t5[1] + limbs.t6[1]);
    RESULT(checked2, closure_, 173, limbs.t8[1] - limbs.t7[1]);
    RESULT(checked3, closure_, 174, limbs.t10[1] - limbs.t9[1]);
    RESULT(checked0, closure_, 175, limbs.t11[1] + limbs.t12[1]);
    RESULT(checked1, closure_, 186, limbs.t14[1] - limbs.t13[1]);
    RESULT(checked2, closure_, 187, limbs.t16[1] - limbs.t15[1]);
    RESULT(checked3, closure_, 188, limbs.t17[1] + limbs.t18[1]);
    NEXT_LIMB(2, forward_dynamics_dense, 0, stride, q, v, u, inertia_, load_, closure_, curvature_, sine, cosine, platform_turn_yx, platform_turn_zx, platform_turn_xx, platform_turn_yy, platform_turn_zy, platform_turn_xy, platform_turn_yz, platform_turn_zz, platform_turn_xz, platform_twist_wy, platform_twist_wz, platform_twist_wx, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, forward_dynamics_dense, 0, stride, q, v, u, inertia_, load_, closure_, curvature_, sine, cosine, platform_turn_xx, platform_turn_zx, platform_turn_yx, platform_turn_xy, platform_turn_zy, platform_turn_yy, platform_turn_xz, platform_turn_zz, platform_turn_yz, platform_twist_wx, platform_twist_wz, platform_twist_wy, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
    RESULT(checked2, closure_, 165, limbs.t6[2] - limbs.t5[2]);
    RESULT(checked3, closure_, 166, limbs.t2[3] - limbs.t1[3]);
    RESULT(checked0, closure_, 167, limbs.t4[3] - limbs.t3[3]);
    RESULT(checked1, closure_, 178, limbs.t12[2] - limbs.t11[2]);
    RESULT(checked2, closure_, 179, limbs.t8[3] - limbs.t7[3]);
    RESULT(checked3, closure_, 180, limbs.t10[3] - limbs.t9[3]);
    RESULT(checked0, closure_, 191, limbs.t18[2] - limbs.t17[2]);
    RESULT(checked1, closure_, 192, limbs.t14[3] - limbs.t13[3]);
    RESULT(checked2, closure_, 193, limbs.t16[3] - limbs.t15[3]);
    /* limb1: accelerations */
    const REAL limb1_U_v_1 = READ(v, 1);
    /* limb1: loop closure; geometry; reciprocal wrenches, eq. (10) */
    const REAL t72 = limb1_U_v_1 - limbs.t21[0], t73 = limbs.signed_lower_omega_y[0] * t72,
      t74 = limbs.signed_lower_omega_y[0] - limbs.t19[0], limb1_U_0_sin = SINES(sine, 0),
      limb1_U_0_cos = SINES(cosine, 0), t77 = limbs.signed_lower_alpha_still_x[0] - (t73 - limb1_U_v_1 * t74),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t78 = limb1_U2_constraint_mn_couple_x * t77, t79 = limbs.signed_lower_omega_x[0] * t74,
      t80 = limbs.signed_lower_omega_x[0] + limbs.t20[0], t82 = t79 - limbs.signed_lower_omega_y[0] * t80,
      t25 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, limb1_lower_cos = SINES(cosine, 1),
      limb1_lower_sin = SINES(sine, 1), t85 = limb1_lower_sin * t25,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t25 - limb1_lower_sin * platform_turn_xy;
    WRITE(closure_, 16, limb1_U2_constraint_mn_couple_z);
    const REAL t84 = t78 - limb1_U2_constraint_mn_couple_z * t82,
      limb1_U2_opening_mn = t85 + limb1_lower_cos * platform_turn_xy,
      t90 = t80 * (limb1_U2_opening_mn * t80 + limb1_U2_constraint_mn_couple_z * t74);
    RESULT(checked3, curvature_, 3, t84 - (t90 - t72 * (limb1_U2_constraint_mn_couple_x * t74 - limb1_U2_opening_mn * t72)));
    const REAL t31 = limbs.t1[0] + limbs.t2[0]; /* mechanism */
    checked0 = checked0 + t31; /* mechanism */
    WRITE(closure_, 156, -t31);
    const REAL t32 = limbs.t3[0] + limbs.t4[0]; /* mechanism */
    checked1 = checked1 + t32; /* mechanism */
    WRITE(closure_, 157, -t32);
    const REAL t34 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z,
      t37 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    WRITE(closure_, 3, limb1_U_0_lever_mz_by_limb1_U2_mn);
    /* mechanism: loop closure; reciprocal wrenches, eq. (10) */
    const REAL t33 = platform_turn_xx * limb1_U_0_lever_mz_by_limb1_U2_mn,
      t44 = platform_turn_xy * limb1_U_0_lever_mz_by_limb1_U2_mn,
      t54 = platform_turn_xz * limb1_U_0_lever_mz_by_limb1_U2_mn,
      base_lever_my_by_limb1_U2_mn = t34 - limb1_U_0_sin * limb1_U_0_lever_my_by_limb1_U2_mn,
      t36 = t33 + platform_turn_yx * base_lever_my_by_limb1_U2_mn,
      base_lever_mz_by_limb1_U2_mn = t37 + limb1_U_0_cos * limb1_U_0_lever_my_by_limb1_U2_mn,
      t40 = t36 + platform_turn_zx * base_lever_mz_by_limb1_U2_mn;
    checked2 = checked2 + t40;
    WRITE(closure_, 159, -t40);
    const REAL t46 = t44 + platform_turn_yy * base_lever_my_by_limb1_U2_mn,
      t56 = t54 + platform_turn_yz * base_lever_my_by_limb1_U2_mn,
      t48 = t46 + platform_turn_zy * base_lever_mz_by_limb1_U2_mn;
    checked3 = checked3 + t48;
    WRITE(closure_, 172, -t48);
    const REAL t58 = t56 + platform_turn_zz * base_lever_mz_by_limb1_U2_mn;
    checked0 = checked0 + t58;
    WRITE(closure_, 185, -t58);
    const REAL minus_closure_163 = limbs.t1[2] + limbs.t2[2];
    checked1 = checked1 + minus_closure_163;
    WRITE(closure_, 163, -minus_closure_163);
    const REAL t41 = limbs.t3[2] + limbs.t4[2];
    checked2 = checked2 + t41;
    WRITE(closure_, 164, -t41);
    const REAL minus_closure_168 = limbs.t5[3] + limbs.t6[3];
    checked3 = checked3 + minus_closure_168;
    WRITE(closure_, 168, -minus_closure_168);
    const REAL t42 = limbs.t7[0] + limbs.t8[0];
    checked0 = checked0 + t42;
    WRITE(closure_, 169, -t42);
    const REAL t43 = limbs.t9[0] + limbs.t10[0];
    checked1 = checked1 + t43;
    WRITE(closure_, 170, -t43);
    const REAL minus_closure_176 = limbs.t7[2] + limbs.t8[2];
    checked2 = checked2 + minus_closure_176;
    WRITE(closure_, 176, -minus_closure_176);
    const REAL t49 = limbs.t9[2] + limbs.t10[2];
    checked3 = checked3 + t49;
    WRITE(closure_, 177, -t49);
    const REAL minus_closure_181 = limbs.t11[3] + limbs.t12[3];
    checked0 = checked0 + minus_closure_181;
    WRITE(closure_, 181, -minus_closure_181);
    const REAL minus_closure_194 = limbs.t17[3] + limbs.t18[3];
    checked1 = checked1 + minus_closure_194;
    WRITE(closure_, 194, -minus_closure_194);
    const REAL t52 = limbs.t13[0] + limbs.t14[0];
    checked2 = checked2 + t52;
    WRITE(closure_, 182, -t52);
    const REAL t53 = limbs.t15[0] + limbs.t16[0];
    checked3 = checked3 + t53;
    WRITE(closure_, 183, -t53);
    const REAL minus_closure_189 = limbs.t13[2] + limbs.t14[2];
    checked0 = checked0 + minus_closure_189;
    WRITE(closure_, 189, -minus_closure_189);
    const REAL t59 = limbs.t15[2] + limbs.t16[2];
    checked1 = checked1 + t59;
    WRITE(closure_, 190, -t59);
    WRITE(inertia_, 32, CONSTANT(limb_lower_m));
    WRITE(inertia_, 80, CONSTANT(limb_lower_m));
    WRITE(inertia_, 128, CONSTANT(limb_lower_m));
    WRITE(inertia_, 176, CONSTANT(limb_lower_m));
    WRITE(inertia_, 192, CONSTANT(k13));
    WRITE(inertia_, 208, CONSTANT(k13));
    WRITE(inertia_, 224, CONSTANT(platform_Izz));
    WRITE(load_, 14, CONSTANT(0.0));
    WRITE(closure_, 0, CONSTANT(0.0));
    WRITE(closure_, 1, CONSTANT(0.0));
    WRITE(closure_, 15, CONSTANT(0.0));
    WRITE(closure_, 26, CONSTANT(1.0));
    WRITE(closure_, 69, CONSTANT(1.0));
    WRITE(closure_, 111, CONSTANT(1.0));
    WRITE(closure_, 153, CONSTANT(1.0));
    WRITE(closure_, 154, CONSTANT(0.0));
    WRITE(closure_, 155, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}

static int three_ups_upu_s_forward_dynamics_dense(const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict inertia_, double *restrict load_, double *restrict closure_,
    double *restrict curvature_)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    three_ups_upu_s_zero(inertia_ + 1, 15);
    three_ups_upu_s_zero(inertia_ + 17, 15);
    three_ups_upu_s_zero(inertia_ + 33, 15);
    three_ups_upu_s_zero(inertia_ + 49, 15);
    three_ups_upu_s_zero(inertia_ + 65, 15);
    three_ups_upu_s_zero(inertia_ + 81, 15);
    three_ups_upu_s_zero(inertia_ + 97, 15);
    three_ups_upu_s_zero(inertia_ + 113, 15);
    three_ups_upu_s_zero(inertia_ + 129, 15);
    three_ups_upu_s_zero(inertia_ + 145, 15);
    three_ups_upu_s_zero(inertia_ + 161, 15);
    three_ups_upu_s_zero(inertia_ + 177, 15);
    three_ups_upu_s_zero(inertia_ + 193, 15);
    three_ups_upu_s_zero(inertia_ + 209, 15);
    three_ups_upu_s_zero(closure_ + 4, 10);
    three_ups_upu_s_zero(closure_ + 17, 9);
    three_ups_upu_s_zero(closure_ + 27, 18);
    three_ups_upu_s_zero(closure_ + 46, 11);
    three_ups_upu_s_zero(closure_ + 58, 11);
    three_ups_upu_s_zero(closure_ + 70, 17);
    three_ups_upu_s_zero(closure_ + 88, 11);
    three_ups_upu_s_zero(closure_ + 100, 11);
    three_ups_upu_s_zero(closure_ + 112, 17);
    three_ups_upu_s_zero(closure_ + 130, 11);
    three_ups_upu_s_zero(closure_ + 142, 11);
    const int outcome = three_ups_upu_s_forward_dynamics_dense_body(1, q, v, u, inertia_, load_, closure_,
        curvature_, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(inertia_, 225);
        three_ups_upu_s_set_nan(load_, 15);
        three_ups_upu_s_set_nan(closure_, 195);
        three_ups_upu_s_set_nan(curvature_, 13);
    }
    return outcome;
}

static int three_ups_upu_s_forward_dynamics_rank_revealing(const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a)
{
    static const double rate_scale[15] = {1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0, 1.0};
    static const double row_scale[13] = {1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.0, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322};
    double inertia[225], load[15], closure[195], curvature[13];
    double turn[225], work[270], multipliers[13];
    const int failed = three_ups_upu_s_forward_dynamics_dense(q, v, u, inertia, load, closure, curvature);
    for (int j = 0; j < 15; ++j) {
        load[j] *= rate_scale[j];
        for (int i = 0; i < 15; ++i) {
            inertia[i + j * 15] *= rate_scale[i] * rate_scale[j];
        }
        for (int i = 0; i < 13; ++i) {
            closure[i + j * 13] *= row_scale[i] * rate_scale[j];
        }
    }
    for (int i = 0; i < 13; ++i) {
        curvature[i] *= row_scale[i];
    }
    const int rank = three_ups_upu_s_constrained(15, 13, inertia, load, closure, curvature, turn, work, a, multipliers);
    double total = three_ups_upu_s_dot(15, a, a);
    for (int j = 0; j < 15; ++j) {
        a[j] *= rate_scale[j];
    }
    if (failed != 0 || rank < 0 || !isfinite(total)) {
        three_ups_upu_s_set_nan(a, 15);
        return failed == 0 && isfinite(total) ? 1 : 2;
    }
    return rank == 13 ? -1 : -2;
}


#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_forward_dynamics_limb_by_limb(const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_forward_dynamics_body(1, q, v, u, a, sine, cosine, NULL);
    if (outcome == 1) {
        return three_ups_upu_s_forward_dynamics_rank_revealing(q, v, u, a);
    }
    if (outcome != 0) {
        three_ups_upu_s_set_nan(a, 15);
    }
    return outcome;
}

int three_ups_upu_s_forward_dynamics(const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    if (isfinite(three_ups_upu_s_forward_dynamics_packed_lane(1, q, v, u, a, sine, cosine, NULL))) {
        return 0;
    }
#endif
    return three_ups_upu_s_forward_dynamics_limb_by_limb(q, v, u, a);
}


#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_forward_dynamics_independent_limb_by_limb(const double *restrict q,
    const double *restrict y_dot, const double *restrict u, double *restrict y_ddot)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_forward_dynamics_independent_body(1, q, y_dot, u, y_ddot, sine,
        cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(y_ddot, 2);
    }
    return outcome;
}

int three_ups_upu_s_forward_dynamics_independent(const double *restrict q, const double *restrict y_dot,
    const double *restrict u, double *restrict y_ddot)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    if (isfinite(three_ups_upu_s_forward_dynamics_independent_packed_lane(1, q, y_dot, u, y_ddot, sine,
        cosine, NULL))) {
        return 0;
    }
#endif
    return three_ups_upu_s_forward_dynamics_independent_limb_by_limb(q, y_dot, u, y_ddot);
}


typedef struct {
    EACH4 upper_sent_fy, U_0_joint_sent_fx, signed_U_0_joint_sent_fy, upper_rate_mx, t1, t2,
      minus_lower_rotation_yx, t3, U2_constraint_mn_couple_x, signed_lower_rotation_zx,
      signed_upper_position_z, minus_U2_joint_reaction_mx, minus_upper_rate_my_2, minus_lower_sent_my,
      lower_joint_sent_my, lower_joint_sent_mx, minus_upper_position_y, t4, upper_position_x, t5, t6, t7,
      minus_upper_rate_mz_2, t8, t9, t10, U2_constraint_mn_couple_z, t11, minus_U2_joint_reaction_mz,
      minus_upper_sent_mz, t12, t13, t14, t15, S_reactions_fz, t16, S_reactions_my, signed_S_reactions_mz,
      t17, t18, t19, checked;
} LIMBS(forward_dynamics_reactions_wrenches);

STAGE(forward_dynamics_reactions_wrenches, 0)(size_t limb, size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict a, const double *restrict multipliers_,
    double *restrict reactions, double *restrict sized_, const double *restrict sine,
    const double *restrict cosine, REAL platform_turn_yy, REAL platform_turn_zy,
    LIMBS(forward_dynamics_reactions_wrenches) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0),
      each_gravity_z = sign2 * gravity_z, each_limb_lower_m_gravity_z = -sign2 * limb_lower_m_gravity_z,
      each_gravity_z_limb_lower_mx = -sign2 * gravity_z_limb_lower_mx, each_param_R = -sign1 * param_R,
      sign3 = OF4(1.0, -1.0, -1.0, -1.0), each_limb_upper_phase = -sign1 * limb_upper_phase;
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: reciprocal wrenches, eq. (10); velocities, eq. (6) */
    OWN(t1) = U_0_cos * platform_turn_yy;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    OWN(t2) = signed_U_0_sin * platform_turn_zy;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2), t63 = sign1 * signed_lower_sin,
      U_v_0 = IN_EACH4(READ, v, 0, 3), lower_omega_x = U_v_0 * t63, lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      lower_omega_y = U_v_0 * lower_cos;
    /* each limb: accelerations; momentum rate, eq. (35); geometry */
    const LIMB4 lower_U_still_xy = lower_omega_x * lower_omega_y, U_v_1 = IN_EACH4(READ, v, 1, 3),
      minus_lower_alpha_still_y = U_v_1 * lower_omega_x, U_a_1 = IN_EACH4(READ, a, 1, 3),
      lower_U_yx = U_a_1 + lower_U_still_xy, t37 = k19 * lower_U_still_xy,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase, t3 = upper_offset_x * lower_U_yx,
      lower_rate_fy = limb_lower_mx * lower_U_yx, U_0_acc_y = each_gravity_z * U_0_cos,
      minus_lower_acc_y = t63 * U_0_acc_y, t4 = t3 - minus_lower_acc_y,
      minus_lower_rate_fy_2 = limb_lower_m * minus_lower_acc_y - lower_rate_fy, lower_acc_x = lower_cos * U_0_acc_y,
      P_v = IN_EACH4(READ, v, 2, 3), upper_acc_y = P_v * (2.0 * U_v_1) + t4,
      multipliers_1 = OF4(READ(multipliers_, 1), READ(multipliers_, 5), READ(multipliers_, 8), READ(multipliers_, 11));
    /* each limb: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    OWN(upper_sent_fy) = limb_lower_m * upper_acc_y - lower_rate_fy - multipliers_1;
    WRITE4(sized_, 7, 25, 43, 61, OWN(upper_sent_fy));
    const LIMB4 minus_lower_sent_fy = minus_lower_rate_fy_2 - OWN(upper_sent_fy),
      minus_upper_rate_mz = limb_lower_mx * upper_acc_y, t5 = lower_cos * minus_lower_sent_fy,
      t15 = t63 * minus_lower_sent_fy, minus_lower_U_still_xx = lower_omega_y * lower_omega_y + U_v_1 * U_v_1,
      lower_force_x = limb_lower_m * (IN_EACH4(READ, a, 2, 3) - (upper_offset_x * minus_lower_U_still_xx - lower_acc_x)),
      minus_lower_rate_fx = limb_lower_mx * minus_lower_U_still_xx,
      multipliers_0 = OF4(READ(multipliers_, 0), READ(multipliers_, 4), READ(multipliers_, 7), READ(multipliers_, 10)),
      upper_sent_fx = minus_lower_rate_fx + lower_force_x - multipliers_0,
      lower_sent_fx = limb_lower_m * lower_acc_x - minus_lower_rate_fx + upper_sent_fx,
      lower_joint_sent_fy = t63 * lower_sent_fx - t5;
    WRITE4(reactions, 0, 19, 36, 55, lower_joint_sent_fy);
    WRITE4(sized_, 1, 19, 37, 55, lower_joint_sent_fy);
    LIMB4 checked = lower_joint_sent_fy;
    const LIMB4 lower_joint_sent_fx = lower_cos * lower_sent_fx + t15;
    WRITE4(sized_, 0, 18, 36, 54, lower_joint_sent_fx);
    const LIMB4 U_a_0 = IN_EACH4(READ, a, 0, 3), t16 = signed_U_0_sin * lower_joint_sent_fx,
      t18 = U_0_cos * lower_joint_sent_fx, minus_lower_alpha_y = minus_lower_alpha_still_y - U_a_0 * lower_cos,
      lower_U_zx = minus_lower_alpha_still_y + minus_lower_alpha_y,
      t25 = k16 * minus_lower_alpha_y + k17 * minus_lower_alpha_still_y, t11 = upper_offset_x * lower_U_zx,
      lower_rate_fz = limb_lower_mx * lower_U_zx,
      upper_acc_z = t11 + each_gravity_z * signed_U_0_sin - P_v * (2.0 * lower_omega_y),
      lower_alpha_still_x = U_v_1 * lower_omega_y,
      upper_sent_fz = limb_lower_m * upper_acc_z - lower_rate_fz - OF4(READ(multipliers_, 2), READ(multipliers_, 6), READ(multipliers_, 9), READ(multipliers_, 12));
    WRITE4(sized_, 8, 26, 44, 62, upper_sent_fz);
    OWN(minus_upper_rate_my_2) = (-limb_lower_mx) * upper_acc_z + t25;
    const LIMB4 lower_sent_fz = lower_rate_fz - each_limb_lower_m_gravity_z * signed_U_0_sin + upper_sent_fz;
    WRITE4(sized_, 2, 20, 38, 56, lower_sent_fz);
    OWN(U_0_joint_sent_fx) = U_0_cos * lower_sent_fz - t16;
    WRITE4(reactions, 1, 18, 37, 54, OWN(U_0_joint_sent_fx));
    OWN(signed_U_0_joint_sent_fy) = signed_U_0_sin * lower_sent_fz + t18;
    WRITE4(reactions, 2, 20, 38, 56, sign2 * OWN(signed_U_0_joint_sent_fy));
    OWN(upper_rate_mx) = k14 * (lower_alpha_still_x + U_a_0 * t63) - k15 * lower_alpha_still_x;
    const LIMB4 lower_rotation_yy = signed_U_0_sin * t63;
    OWN(t6) = lower_rotation_yy * OWN(minus_upper_rate_my_2);
    const LIMB4 t22 = lower_rotation_yy * multipliers_1;
    OWN(minus_lower_rotation_yx) = signed_U_0_sin * lower_cos;
    OWN(t3) = OWN(minus_lower_rotation_yx) * multipliers_0 - t22;
    const LIMB4 t27 = OWN(minus_upper_rate_my_2) + upper_offset_x * upper_sent_fz;
    OWN(minus_lower_sent_my) = t27 - (each_gravity_z_limb_lower_mx * signed_U_0_sin - t25);
    const LIMB4 P_reactions_fy = lower_rotation_yy * OWN(upper_sent_fy) + U_0_cos * upper_sent_fz;
    WRITE4(reactions, 7, 24, 43, 60, P_reactions_fy);
    OWN(signed_lower_rotation_zx) = U_0_cos * lower_cos;
    OWN(signed_upper_position_z) = upper_offset_x * OWN(signed_lower_rotation_zx);
    /* each limb: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    const LIMB4 t33 = OWN(signed_upper_position_z) * P_reactions_fy, t31 = signed_U_0_sin * upper_sent_fz,
      signed_lower_rotation_zy = U_0_cos * t63;
    OWN(t12) = signed_lower_rotation_zy * OWN(minus_upper_rate_my_2);
    const LIMB4 signed_P_reactions_fz = signed_lower_rotation_zy * OWN(upper_sent_fy) - t31;
    WRITE4(reactions, 8, 26, 44, 62, -sign2 * signed_P_reactions_fz);
    OWN(minus_upper_position_y) = upper_offset_x * OWN(minus_lower_rotation_yx);
    OWN(upper_position_x) = t63 * upper_offset_x + each_param_R;
    const LIMB4 t48 = OWN(upper_position_x) * P_reactions_fy, t35 = OWN(upper_position_x) * signed_P_reactions_fz;
    OWN(t4) = t33 - OWN(minus_upper_position_y) * signed_P_reactions_fz;
    const LIMB4 P_reactions_fx = lower_cos * OWN(upper_sent_fy);
    WRITE4(reactions, 6, 25, 42, 61, P_reactions_fx);
    OWN(t5) = OWN(signed_upper_position_z) * P_reactions_fx + t35;
    OWN(t14) = t48 + OWN(minus_upper_position_y) * P_reactions_fx;
    OWN(minus_upper_rate_mz_2) = minus_upper_rate_mz - (k18 * U_a_1 + t37);
    const LIMB4 t64 = sign3 * OF4(READ(multipliers_, 0), READ(multipliers_, 5), READ(multipliers_, 8), READ(multipliers_, 11));
    OWN(t8) = t63 * t64 + lower_cos * IN_EACH4(READ, multipliers_, 1, 3);
    OWN(t15) = OWN(signed_lower_rotation_zx) * multipliers_0 - signed_lower_rotation_zy * multipliers_1;
    /* each limb: results */
    const LIMB4 t43 = limb_upper_phase * OWN(minus_lower_rotation_yx), t53 = lower_rotation_yy * t43,
      t44 = OWN(minus_lower_rotation_yx) * t43, t58 = U_0_cos * t43, t41 = each_limb_upper_phase * signed_lower_sin,
      t45 = t63 * t41 - t44, t54 = lower_cos * t41 + t53, t46 = limb_upper_phase * OWN(signed_lower_rotation_zx),
      t57 = upper_sent_fz * (t54 + signed_lower_rotation_zy * t46);
    OWN(t11) = OWN(signed_lower_rotation_zx) * t46 - t45;
    OWN(t19) = OWN(minus_upper_rate_my_2) + upper_sent_fz * OWN(t11);
    OWN(t17) = t57 - OWN(upper_sent_fy) * (t58 - signed_U_0_sin * t46);
    OWN(checked) = checked;
}

STAGE(forward_dynamics_reactions_wrenches, 1)(size_t limb, size_t stride, double *restrict reactions,
    const double *restrict sine, const double *restrict cosine, REAL given, REAL signed_upper_position_z,
    REAL platform_turn_yy, REAL platform_turn_zy, REAL given_2,
    LIMBS(forward_dynamics_reactions_wrenches) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0);
    /* each limb: reciprocal wrenches, eq. (10); reactions, eq. (32) */
    OWN(t9) = IN_EACH4(SINES, sine, 0, 2) * platform_turn_yy;
    OWN(t10) = IN_EACH4(SINES, cosine, 0, 2) * platform_turn_zy;
    OWN(U2_constraint_mn_couple_x) = OWN(t1) + sign1 * given;
    OWN(minus_U2_joint_reaction_mx) = OWN(U2_constraint_mn_couple_x) * signed_upper_position_z;
    OWN(S_reactions_fz) = given_2 + OWN(t15);
    WRITE4(reactions, 14, 32, 50, 68, -sign2 * OWN(S_reactions_fz));
    OWN(t16) = OWN(minus_upper_position_y) * OWN(S_reactions_fz);
}

STAGE(forward_dynamics_reactions_wrenches, 2)(size_t limb, size_t stride, double *restrict reactions,
    const double *restrict sine, const double *restrict cosine, REAL lower_sent_mx, REAL upper_rate_mx,
    REAL multipliers_5, REAL platform_turn_xy, LIMBS(forward_dynamics_reactions_wrenches) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = sign1 * param_R,
      sign2 = OF4(1.0, -1.0, -1.0, -1.0), sign3 = OF4(1.0, -1.0, 1.0, -1.0);
    /* each limb: results */
    OWN(t18) = upper_rate_mx - OWN(t17);
    /* each limb: reactions, eq. (32); reciprocal wrenches, eq. (10); balance, eqs. (40)-(47) */
    OWN(t13) = OWN(t12) + OWN(signed_lower_rotation_zx) * upper_rate_mx;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2), t13 = lower_cos * (sign2 * multipliers_5),
      t16 = sign1 * IN_EACH4(SINES, sine, 1, 2);
    OWN(U2_constraint_mn_couple_z) = t13 - t16 * platform_turn_xy;
    OWN(t7) = OWN(t6) + OWN(minus_lower_rotation_yx) * upper_rate_mx;
    const LIMB4 P_reactions_my = t16 * upper_rate_mx - lower_cos * OWN(minus_upper_rate_my_2) - OWN(t4);
    WRITE4(reactions, 9, 28, 45, 64, P_reactions_my);
    LIMB4 checked = OWN(checked) + P_reactions_my;
    const LIMB4 t1 = t16 * lower_sent_mx;
    OWN(lower_joint_sent_mx) = lower_cos * lower_sent_mx + t16 * OWN(minus_lower_sent_my);
    const LIMB4 t7 = IN_EACH4(SINES, cosine, 0, 2) * OWN(lower_joint_sent_mx),
      t6 = IN_EACH4(SINES, sine, 0, 2) * OWN(lower_joint_sent_mx),
      signed_U_reactions_mz = t7 - each_param_R * OWN(U_0_joint_sent_fx);
    WRITE4(reactions, 5, 23, 41, 59, sign3 * signed_U_reactions_mz);
    checked = checked + signed_U_reactions_mz;
    const LIMB4 U_reactions_my = each_param_R * OWN(signed_U_0_joint_sent_fy) - t6;
    WRITE4(reactions, 4, 21, 40, 57, U_reactions_my);
    checked = checked + U_reactions_my;
    OWN(lower_joint_sent_my) = t1 - lower_cos * OWN(minus_lower_sent_my);
    WRITE4(reactions, 3, 22, 39, 58, OWN(lower_joint_sent_my));
    OWN(checked) = checked;
}

STAGE(forward_dynamics_reactions_wrenches, 3)(size_t limb, size_t stride, REAL upper_sent_fy,
    REAL multipliers_3, REAL S_reactions_fx, REAL given, LIMBS(forward_dynamics_reactions_wrenches) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, -1.0), sign2 = OF4(1.0, 1.0, -1.0, -1.0);
    /* each limb: reactions, eq. (32); balance, eqs. (40)-(47) */
    OWN(minus_U2_joint_reaction_mz) = upper_sent_fy * multipliers_3;
    OWN(minus_upper_sent_mz) = OWN(minus_upper_rate_mz_2) + sign1 * OWN(minus_U2_joint_reaction_mz);
    const LIMB4 t5 = sign2 * (OWN(signed_upper_position_z) * S_reactions_fx);
    OWN(S_reactions_my) = OWN(upper_position_x) * OWN(S_reactions_fz) - t5;
    OWN(signed_S_reactions_mz) = OWN(minus_upper_position_y) * S_reactions_fx - given;
}

STAGE(forward_dynamics_reactions_wrenches, 4)(size_t limb, size_t stride, double *restrict reactions,
    const double *restrict sine, const double *restrict cosine, REAL minus_upper_rate_mz_2,
    LIMBS(forward_dynamics_reactions_wrenches) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0);
    /* each limb: reactions, eq. (32) */
    const LIMB4 P_reactions_my = OWN(t5) - (OWN(t7) + IN_EACH4(SINES, cosine, 0, 2) * minus_upper_rate_mz_2);
    WRITE4(reactions, 10, 27, 46, 63, P_reactions_my);
    LIMB4 checked = OWN(checked) + P_reactions_my;
    const LIMB4 P_reactions_mz = OWN(t13) - IN_EACH4(SINES, sine, 0, 2) * minus_upper_rate_mz_2 + OWN(t14);
    WRITE4(reactions, 11, 29, 47, 65, sign1 * P_reactions_mz);
    checked = checked + P_reactions_mz;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_forward_dynamics_reactions_wrenches)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, const double *restrict a,
    const double *restrict multipliers_, double *restrict reactions, double *restrict sized_,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(forward_dynamics_reactions_wrenches) limbs;
    REAL checked0 = READ(u, 0);
    REAL checked1 = READ(u, 1);
    REAL checked2 = READ(u, 2);
    REAL checked3 = READ(u, 3);
    checked0 = checked0 + (READ(a, 14));
    /* mechanism: balance, eqs. (40)-(47) */
    const REAL multipliers_0 = READ(multipliers_, 0);
    WRITE(sized_, 12, -multipliers_0);
    const REAL multipliers_1 = READ(multipliers_, 1);
    WRITE(sized_, 13, -multipliers_1);
    const REAL multipliers_2 = READ(multipliers_, 2);
    WRITE(sized_, 14, -multipliers_2);
    const REAL multipliers_4 = READ(multipliers_, 4);
    WRITE(sized_, 30, -multipliers_4);
    const REAL multipliers_5 = READ(multipliers_, 5);
    WRITE(sized_, 31, -multipliers_5);
    const REAL multipliers_6 = READ(multipliers_, 6);
    WRITE(sized_, 32, -multipliers_6);
    const REAL multipliers_7 = READ(multipliers_, 7);
    WRITE(sized_, 48, -multipliers_7);
    const REAL multipliers_8 = READ(multipliers_, 8);
    WRITE(sized_, 49, -multipliers_8);
    const REAL multipliers_9 = READ(multipliers_, 9);
    WRITE(sized_, 50, -multipliers_9);
    const REAL multipliers_10 = READ(multipliers_, 10);
    WRITE(sized_, 66, -multipliers_10);
    const REAL multipliers_11 = READ(multipliers_, 11);
    WRITE(sized_, 67, -multipliers_11);
    const REAL multipliers_12 = READ(multipliers_, 12);
    WRITE(sized_, 68, -multipliers_12);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t46 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_xx = 1.0 - t6 * t9,
      platform_turn_zz = 1.0 - t9 * t46, t12 = limb5_S_q_qz * t9, t13 = limb5_S_q_qy * t12,
      t15 = limb5_S_q_qw * (limb5_S_q_qx * t9), t17 = limb5_S_q_qy * t9, platform_turn_zy = t13 + t15,
      platform_turn_yz = t13 - t15;
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 0, stride, q, v, a, multipliers_, reactions, sized_, sine, cosine, platform_turn_yy, platform_turn_zy, &limbs);
    WRITE(reactions, 12, -limbs.t8[0]);
    /* limb1: geometry; reactions, eq. (32); balance, eqs. (40)-(47) */
    const REAL limb1_U_0_cos = SINES(cosine, 0), t20 = limb1_U_0_cos * multipliers_2, t21 = t20 - limbs.t3[0];
    WRITE(reactions, 13, -t21);
    const REAL limb1_U_0_sin = SINES(sine, 0), t23 = limbs.signed_upper_position_z[0] * t21,
      t98 = -(limbs.upper_position_x[0] * t21), t22 = limb1_U_0_sin * multipliers_2,
      multipliers_3 = READ(multipliers_, 3);
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 1, stride, reactions, sine, cosine, limbs.t2[0], multipliers_3, platform_turn_yy, platform_turn_zy, t22, &limbs);
    const REAL limb1_lower_sin = SINES(sine, 1);
    RESULT(checked1, reactions, 15, limbs.t16[0] + t23 - limb1_lower_sin * limbs.minus_U2_joint_reaction_mx[0]);
    const REAL limb1_upper_sent_mx = limbs.upper_rate_mx[0] - limbs.minus_U2_joint_reaction_mx[0],
      limb1_lower_sent_mx = limbs.upper_rate_mx[0] + limb1_upper_sent_mx, t16 = limbs.t9[0] - limbs.t10[0];
    /* limb5_S: geometry; results; accelerations */
    const REAL t18 = limb5_S_q_qx * t17, t38 = limb5_S_q_qw * t17, t19 = limb5_S_q_qw * t12, t37 = limb5_S_q_qx * t12,
      platform_turn_xy = t18 - t19;
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 2, stride, reactions, sine, cosine, limb1_lower_sent_mx, limb1_upper_sent_mx, t16, platform_turn_xy, &limbs);
    const REAL platform_turn_yx = t18 + t19;
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 3, stride, limbs.U2_constraint_mn_couple_z[0], multipliers_3, limbs.t8[0], t98, &limbs);
    RESULT(checked2, sized_, 3, per_length * limbs.lower_joint_sent_mx[0]);
    RESULT(checked3, sized_, 4, per_length * limbs.lower_joint_sent_my[0]);
    RESULT(checked0, sized_, 9, per_length * limbs.t18[0]);
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 4, stride, reactions, sine, cosine, limbs.minus_upper_sent_mz[0], &limbs);
    checked1 = checked1 + ALONE(limbs.checked[0]);
    const REAL t27 = limb1_U_0_cos * limbs.minus_U2_joint_reaction_mz[0]; /* limb1 */
    RESULT(checked2, reactions, 16, limbs.minus_lower_rotation_yx[0] * limbs.minus_U2_joint_reaction_mx[0] - t27 + limbs.S_reactions_my[0]);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 0, stride, q, v, a, multipliers_, reactions, sized_, sine, cosine, multipliers_6, multipliers_6, &limbs);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 1, stride, reactions, sine, cosine, limbs.t3[1], limbs.signed_upper_position_z[1], limbs.t8[1], limbs.t8[1], limbs.t2[1], &limbs);
    RESULT(checked3, reactions, 34, limbs.minus_U2_joint_reaction_mx[1] + limbs.t16[1]);
    WRITE(reactions, 30, -limbs.U2_constraint_mn_couple_x[1]);
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 0, stride, q, v, a, multipliers_, reactions, sized_, sine, cosine, multipliers_9, multipliers_9, &limbs);
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 1, stride, reactions, sine, cosine, limbs.t3[2], limbs.signed_upper_position_z[2], limbs.t8[2], limbs.t8[2], limbs.t2[2], &limbs);
    RESULT(checked0, reactions, 51, limbs.t16[2] + limbs.minus_U2_joint_reaction_mx[2]);
    WRITE(reactions, 49, -limbs.U2_constraint_mn_couple_x[2]);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 0, stride, q, v, a, multipliers_, reactions, sized_, sine, cosine, multipliers_12, multipliers_12, &limbs);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 1, stride, reactions, sine, cosine, limbs.t3[3], limbs.signed_upper_position_z[3], limbs.t8[3], limbs.t8[3], limbs.t2[3], &limbs);
    RESULT(checked1, reactions, 70, limbs.minus_U2_joint_reaction_mx[3] + limbs.t16[3]);
    WRITE(reactions, 66, -limbs.U2_constraint_mn_couple_x[3]);
    const REAL platform_turn_zx = t37 - t38, limb5_S_v_wx = READ(v, 12), limb5_S_v_wz = READ(v, 14),
      platform_turn_xz = t37 + t38, t39 = platform_m_gravity_z * platform_turn_zx,
      platform_rate_fx_2 = platform_mz * (READ(a, 13) + limb5_S_v_wx * limb5_S_v_wz) + t39,
      limb5_S_v_wy = READ(v, 13);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35); results */
    const REAL t40 = platform_turn_xx * platform_rate_fx_2, t56 = platform_turn_yx * platform_rate_fx_2,
      t70 = platform_turn_zx * platform_rate_fx_2, t41 = platform_m_gravity_z * platform_turn_zy,
      minus_platform_rate_fy_2 = platform_mz * (READ(a, 12) - limb5_S_v_wy * limb5_S_v_wz) - t41,
      t43 = t40 - platform_turn_xy * minus_platform_rate_fy_2,
      t58 = t56 - platform_turn_yy * minus_platform_rate_fy_2,
      t72 = t70 - platform_turn_zy * minus_platform_rate_fy_2, t48 = platform_m_gravity_z * platform_turn_zz,
      minus_platform_rate_fz_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t48,
      t60 = t58 - platform_turn_yz * minus_platform_rate_fz_2,
      t74 = t72 - platform_turn_zz * minus_platform_rate_fz_2,
      t53 = t43 - platform_turn_xz * minus_platform_rate_fz_2 + limbs.t8[0] + (limbs.t1[1] - limbs.t9[1]);
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 2, stride, reactions, sine, cosine, 2.0 * limbs.upper_rate_mx[2], limbs.upper_rate_mx[2], multipliers_8, multipliers_7, &limbs);
    WRITE(reactions, 48, limbs.U2_constraint_mn_couple_z[2]);
    const REAL t54 = t53 - limbs.U2_constraint_mn_couple_z[2];
    RESULT(checked2, sized_, 39, per_length * limbs.lower_joint_sent_mx[2]);
    RESULT(checked3, sized_, 40, per_length * limbs.lower_joint_sent_my[2]); /* limb3 */
    RESULT(checked0, sized_, 45, per_length * limbs.t18[2]);
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 4, stride, reactions, sine, cosine, limbs.minus_upper_rate_mz_2[2], &limbs);
    checked1 = checked1 + ALONE(limbs.checked[2]);
    const REAL platform_joint_sent_fx = t54 + (limbs.t1[3] - limbs.t9[3]);
    WRITE(reactions, 72, platform_joint_sent_fx);
    WRITE(sized_, 72, platform_joint_sent_fx);
    checked2 = checked2 + platform_joint_sent_fx;
    const REAL limb1_lower_cos = SINES(cosine, 1),
      t63 = limb1_lower_cos * multipliers_0 - limb1_lower_sin * multipliers_1,
      t66 = t60 + (t20 - limb1_U_0_sin * t63), t77 = t74 + (t22 + limb1_U_0_cos * t63);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 2, stride, reactions, sine, cosine, 2.0 * limbs.upper_rate_mx[1], limbs.upper_rate_mx[1], multipliers_5, multipliers_4, &limbs);
    WRITE(reactions, 31, limbs.U2_constraint_mn_couple_z[1]);
    const REAL t67 = t66 - limbs.U2_constraint_mn_couple_z[1];
    RESULT(checked3, sized_, 21, per_length * limbs.lower_joint_sent_mx[1]);
    RESULT(checked0, sized_, 22, per_length * limbs.lower_joint_sent_my[1]);
    RESULT(checked1, sized_, 27, per_length * limbs.t18[1]);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 4, stride, reactions, sine, cosine, limbs.minus_upper_rate_mz_2[1], &limbs);
    checked2 = checked2 + ALONE(limbs.checked[1]);
    const REAL t97 = -limbs.U2_constraint_mn_couple_z[1], t69 = t67 + (limbs.t1[2] - limbs.t9[2]);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 2, stride, reactions, sine, cosine, 2.0 * limbs.upper_rate_mx[3], limbs.upper_rate_mx[3], multipliers_11, multipliers_10, &limbs);
    WRITE(reactions, 67, limbs.U2_constraint_mn_couple_z[3]);
    const REAL platform_joint_sent_fy = t69 - limbs.U2_constraint_mn_couple_z[3];
    WRITE(reactions, 73, platform_joint_sent_fy);
    WRITE(sized_, 73, platform_joint_sent_fy);
    checked3 = checked3 + platform_joint_sent_fy;
    RESULT(checked0, sized_, 57, per_length * limbs.lower_joint_sent_mx[3]);
    RESULT(checked1, sized_, 58, per_length * limbs.lower_joint_sent_my[3]); /* limb4 */
    RESULT(checked2, sized_, 63, per_length * limbs.t18[3]);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 4, stride, reactions, sine, cosine, limbs.minus_upper_rate_mz_2[3], &limbs);
    checked3 = checked3 + ALONE(limbs.checked[3]);
    const REAL platform_joint_sent_fz = t77 - (limbs.t2[1] + limbs.t10[1]) + (limbs.t2[2] + limbs.t10[2]) - (limbs.t2[3] + limbs.t10[3]);
    WRITE(reactions, 74, platform_joint_sent_fz);
    WRITE(sized_, 74, platform_joint_sent_fz);
    checked0 = checked0 + platform_joint_sent_fz;
    /* limb1: reactions, eq. (32) */
    const REAL t34 = limb1_U_0_sin * limbs.minus_U2_joint_reaction_mz[0],
      minus_limb1_U2_reactions_mz = limbs.signed_S_reactions_mz[0] + (limbs.signed_lower_rotation_zx[0] * limbs.minus_U2_joint_reaction_mx[0] + t34);
    checked1 = checked1 + minus_limb1_U2_reactions_mz;
    WRITE(reactions, 17, -minus_limb1_U2_reactions_mz);
    /* limb1: results */
    const REAL t87 = per_length * limbs.minus_U2_joint_reaction_mx[0];
    checked2 = checked2 + t87;
    WRITE(sized_, 15, -t87);
    const REAL t83 = per_length * limbs.t19[0];
    checked3 = checked3 + t83;
    WRITE(sized_, 10, -t83);
    const REAL t86 = per_length * (limbs.minus_upper_sent_mz[0] - limbs.upper_sent_fy[0] * limbs.t11[0]);
    checked0 = checked0 + t86;
    WRITE(sized_, 11, -t86);
    const REAL t88 = per_length * limbs.minus_U2_joint_reaction_mz[0];
    checked1 = checked1 + t88;
    WRITE(sized_, 17, -t88);
    /* limb2: results; reactions, eq. (32) */
    const REAL t89 = per_length * limbs.t19[1];
    checked2 = checked2 + t89;
    WRITE(sized_, 28, -t89);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 3, stride, limbs.upper_sent_fy[1], limbs.t11[1], t97, -(limbs.upper_position_x[1] * limbs.U2_constraint_mn_couple_x[1]), &limbs);
    WRITE(reactions, 33, limbs.S_reactions_my[1]);
    checked3 = checked3 + limbs.S_reactions_my[1];
    WRITE(reactions, 35, limbs.signed_S_reactions_mz[1]);
    checked0 = checked0 + limbs.signed_S_reactions_mz[1];
    const REAL t90 = per_length * limbs.minus_upper_sent_mz[1];
    checked1 = checked1 + t90;
    WRITE(sized_, 29, -t90);
    /* limb3: results; reactions, eq. (32) */
    const REAL t92 = per_length * limbs.t19[2];
    checked2 = checked2 + t92;
    WRITE(sized_, 46, -t92);
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 3, stride, limbs.upper_sent_fy[2], limbs.t11[2], limbs.U2_constraint_mn_couple_z[2], limbs.upper_position_x[2] * limbs.U2_constraint_mn_couple_x[2], &limbs);
    WRITE(reactions, 52, limbs.S_reactions_my[2]);
    checked3 = checked3 + limbs.S_reactions_my[2];
    WRITE(reactions, 53, limbs.signed_S_reactions_mz[2]);
    checked0 = checked0 + limbs.signed_S_reactions_mz[2];
    const REAL t93 = per_length * limbs.minus_upper_sent_mz[2];
    checked1 = checked1 + t93;
    WRITE(sized_, 47, -t93);
    const REAL t95 = per_length * limbs.t19[3]; /* limb4 */
    checked2 = checked2 + t95; /* limb4 */
    WRITE(sized_, 64, -t95);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 3, stride, limbs.upper_sent_fy[3], limbs.t11[3], limbs.U2_constraint_mn_couple_z[3], limbs.upper_position_x[3] * limbs.U2_constraint_mn_couple_x[3], &limbs);
    WRITE(reactions, 69, limbs.S_reactions_my[3]);
    checked3 = checked3 + limbs.S_reactions_my[3];
    checked0 = checked0 + limbs.signed_S_reactions_mz[3];
    WRITE(reactions, 71, -limbs.signed_S_reactions_mz[3]);
    const REAL t96 = per_length * limbs.minus_upper_sent_mz[3]; /* limb4 */
    checked1 = checked1 + t96; /* limb4 */
    WRITE(sized_, 65, -t96);
    WRITE(reactions, 75, CONSTANT(0.0));
    WRITE(reactions, 76, CONSTANT(0.0));
    WRITE(reactions, 77, CONSTANT(0.0));
    WRITE(sized_, 5, CONSTANT(0.0));
    WRITE(sized_, 6, CONSTANT(0.0));
    WRITE(sized_, 16, CONSTANT(0.0));
    WRITE(sized_, 23, CONSTANT(0.0));
    WRITE(sized_, 24, CONSTANT(0.0));
    WRITE(sized_, 33, CONSTANT(0.0));
    WRITE(sized_, 34, CONSTANT(0.0));
    WRITE(sized_, 35, CONSTANT(0.0));
    WRITE(sized_, 41, CONSTANT(0.0));
    WRITE(sized_, 42, CONSTANT(0.0));
    WRITE(sized_, 51, CONSTANT(0.0));
    WRITE(sized_, 52, CONSTANT(0.0));
    WRITE(sized_, 53, CONSTANT(0.0));
    WRITE(sized_, 59, CONSTANT(0.0));
    WRITE(sized_, 60, CONSTANT(0.0));
    WRITE(sized_, 69, CONSTANT(0.0));
    WRITE(sized_, 70, CONSTANT(0.0));
    WRITE(sized_, 71, CONSTANT(0.0));
    WRITE(sized_, 75, CONSTANT(0.0));
    WRITE(sized_, 76, CONSTANT(0.0));
    WRITE(sized_, 77, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}

static int three_ups_upu_s_forward_dynamics_reactions_wrenches(const double *restrict q,
    const double *restrict v, const double *restrict u, const double *restrict a,
    const double *restrict multipliers_, double *restrict reactions, double *restrict sized_)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_forward_dynamics_reactions_wrenches_body(1, q, v, u, a, multipliers_,
        reactions, sized_, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(reactions, 78);
        three_ups_upu_s_set_nan(sized_, 78);
    }
    return outcome;
}

static int three_ups_upu_s_forward_dynamics_reactions_rank_revealing(const double *restrict q,
    const double *restrict v, const double *restrict u, double *restrict a, double *restrict reactions)
{
    static const double rate_scale[15] = {1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0, 1.0};
    static const double row_scale[13] = {1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.0, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322};
    double inertia[225], load[15], closure[195], curvature[13];
    double turn[225], work[270], multipliers[13];
    const int failed = three_ups_upu_s_forward_dynamics_dense(q, v, u, inertia, load, closure, curvature);
    for (int j = 0; j < 15; ++j) {
        load[j] *= rate_scale[j];
        for (int i = 0; i < 15; ++i) {
            inertia[i + j * 15] *= rate_scale[i] * rate_scale[j];
        }
        for (int i = 0; i < 13; ++i) {
            closure[i + j * 13] *= row_scale[i] * rate_scale[j];
        }
    }
    for (int i = 0; i < 13; ++i) {
        curvature[i] *= row_scale[i];
    }
    const int rank = three_ups_upu_s_constrained(15, 13, inertia, load, closure, curvature, turn, work, a, multipliers);
    double total = three_ups_upu_s_dot(15, a, a);
    for (int j = 0; j < 15; ++j) {
        a[j] *= rate_scale[j];
    }
    double sized[78], shifted[78], loads[169] = {0.0}, columns[1014] = {0.0};
    double mix[169] = {0.0}, amount[13] = {0.0};
    for (int i = 0; i < 13; ++i) {
        multipliers[i] *= row_scale[i];
    }
    (void)three_ups_upu_s_forward_dynamics_reactions_wrenches(q, v, u, a, multipliers, reactions, sized);
    const int internal = 13 - (rank > 0 ? rank : 0);
    for (int k = 0; k < internal && rank >= 0; ++k) {
        double moved[13];
        three_ups_upu_s_internal_load(15, 13, closure, k, loads);
        for (int i = 0; i < 13; ++i) {
            moved[i] = multipliers[i] + row_scale[i] * loads[i + k * 13];
        }
        (void)three_ups_upu_s_forward_dynamics_reactions_wrenches(q, v, u, a, moved, shifted, columns + k * 78);
        for (int i = 0; i < 78; ++i) {
            columns[i + k * 78] -= sized[i];
        }
    }
    three_ups_upu_s_orthogonalise(78, internal, columns, mix);
    double largest = 0.0;
    for (int k = 0; k < internal; ++k) {
        const double part = three_ups_upu_s_dot(78, columns + k * 78, columns + k * 78);
        largest = part > largest ? part : largest;
        amount[k] = 0.0;
    }
    for (int k = 0; k < internal; ++k) {
        const double part = three_ups_upu_s_dot(78, columns + k * 78, columns + k * 78);
        if (part > 1.0e-18 * largest) {
            const double factor = -three_ups_upu_s_dot(78, columns + k * 78, sized) / part;
            for (int i = 0; i < internal; ++i) {
                amount[i] += factor * mix[i + k * internal];
            }
        }
    }
    for (int k = 0; k < internal; ++k) {
        for (int i = 0; i < 13; ++i) {
            multipliers[i] += amount[k] * row_scale[i] * loads[i + k * 13];
        }
    }
    (void)three_ups_upu_s_forward_dynamics_reactions_wrenches(q, v, u, a, multipliers, reactions, sized);
    total += three_ups_upu_s_dot(78, reactions, reactions);
    if (failed != 0 || rank < 0 || !isfinite(total)) {
        three_ups_upu_s_set_nan(a, 15);
        three_ups_upu_s_set_nan(reactions, 78);
        return failed == 0 && isfinite(total) ? 1 : 2;
    }
    return rank == 13 ? -1 : -2;
}

int three_ups_upu_s_forward_dynamics_reactions(const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a, double *restrict reactions)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_forward_dynamics_reactions_body(1, q, v, u, a, reactions, sine,
        cosine, NULL);
    if (outcome == 1) {
        return three_ups_upu_s_forward_dynamics_reactions_rank_revealing(q, v, u, a, reactions);
    }
    if (outcome != 0) {
        three_ups_upu_s_set_nan(a, 15);
        three_ups_upu_s_set_nan(reactions, 78);
    }
    return outcome;
}
#endif /* THREE_UPS_UPU_S_VECTORS */
