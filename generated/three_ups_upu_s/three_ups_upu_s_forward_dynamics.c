/*
 * three_ups_upu_s: forward_dynamics.
 *   forward_dynamics; forward_dynamics_independent; forward_dynamics_reactions
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 upper_position_x, minus_U_0_lever_mz_by_S_fz, t1, signed_U_follows_0_by_S_1,
      U_mass_matrix_0_by_U_0, t2, S_arm_x, t3, t4, S_arm_y, U_follows_1_by_S_0, U_mass_matrix_1_by_U_1, t5,
      t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, signed_U_handed_force_0, t18, t19, t20, t21,
      minus_lower_acc_x, t22, t23, t24, t25, t26, checked;
} LIMBS(forward_dynamics);

STAGE(forward_dynamics, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict sine, const double *restrict cosine, LIMBS(forward_dynamics) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = -sign1 * param_R,
      sign2 = OF4(1.0, -1.0, 1.0, -1.0), each_k21 = -sign1 * k21, each_param_R_2 = sign1 * param_R,
      each_gravity_z = -sign2 * gravity_z;
    /* each limb: geometry; inertia; reciprocal wrenches, eq. (10) */
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      lower_composite_first_x = limb_lower_m * upper_offset_x, t1 = lower_composite_first_x + (-k8),
      t25 = lower_composite_first_x + t1, t2 = upper_offset_x * t1, lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t4 = lower_cos * (t2 + k9);
    OWN(U_mass_matrix_1_by_U_1) = t2 + k10;
    OWN(U_mass_matrix_0_by_U_0) = lower_cos * t4 + k4;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2), t38 = sign1 * signed_lower_sin,
      U_0_composite_second_yz = t38 * t4;
    OWN(upper_position_x) = t38 * upper_offset_x + each_param_R;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * upper_offset_x;
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = sign2 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(signed_U_follows_0_by_S_1) = OWN(upper_position_x) * OWN(t1);
    /* each limb: free motion; rates that follow; accelerations */
    const LIMB4 t6 = OWN(signed_U_follows_0_by_S_1) * OWN(U_mass_matrix_0_by_U_0),
      signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    OWN(t2) = signed_U_0_sin * t6;
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    OWN(t4) = U_0_cos * t6;
    const LIMB4 t8 = OWN(signed_U_follows_0_by_S_1) * t6;
    OWN(t3) = lower_cos * OWN(t1);
    const LIMB4 t39 = sign2 * OWN(t3);
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    OWN(U_follows_1_by_S_0) = OWN(S_arm_x) * t39;
    const LIMB4 t12 = OWN(U_follows_1_by_S_0) * (OWN(U_mass_matrix_1_by_U_1) * OWN(U_follows_1_by_S_0));
    OWN(S_arm_y) = each_param_R * lower_cos;
    const LIMB4 t13 = OWN(S_arm_y) * (each_k21 * lower_cos) + t12, t15 = U_0_cos * (t8 - t13);
    OWN(t5) = signed_U_0_sin * t15;
    const LIMB4 t16 = U_0_cos * t15;
    OWN(t6) = t8 - t16;
    OWN(t7) = t13 + t16;
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3), t17 = U_v_1 * t38;
    OWN(t20) = each_param_R_2 * t17;
    const LIMB4 P_v = IN_EACH4(READ, v, 2, 3);
    OWN(t8) = upper_offset_x * t17 - P_v * lower_cos;
    const LIMB4 upper_twist_vx = P_v * t38, t20 = U_v_1 * lower_cos;
    OWN(t10) = upper_twist_vx + upper_offset_x * t20;
    OWN(t14) = each_param_R_2 * t20 - P_v;
    const LIMB4 t24 = U_v_1 * (2.0 * U_0_composite_second_yz), t27 = lower_cos * (lower_cos * t25),
      U_v_0 = IN_EACH4(READ, v, 0, 3), t40 = sign2 * (U_v_0 * (t24 - P_v * t27));
    OWN(t17) = lower_cos * (upper_offset_x * (limb_lower_m_gravity_z * signed_U_0_sin)) + t40;
    const LIMB4 minus_U_0_U_still_xx = U_v_0 * U_v_0, t36 = minus_U_0_U_still_xx * U_0_composite_second_yz;
    OWN(t19) = 0.5 * (minus_U_0_U_still_xx * t27 + U_v_1 * (U_v_1 * t25));
    const LIMB4 minus_U_0_acc_y = each_gravity_z * U_0_cos;
    OWN(minus_lower_acc_x) = lower_cos * minus_U_0_acc_y;
    const LIMB4 lower_moment_z = upper_offset_x * (limb_lower_m * (t38 * minus_U_0_acc_y));
    OWN(t13) = U_v_1 * P_v;
    OWN(t23) = lower_moment_z + (OWN(t13) * t25 + t36);
    OWN(checked) = checked;
}

STAGE(forward_dynamics, 1)(size_t limb, size_t stride, const double *restrict v, const double *restrict u,
    const double *restrict sine, const double *restrict cosine, const EACH4 platform_twist_wx,
    const EACH4 platform_twist_wy, REAL platform_twist_wz, LIMBS(forward_dynamics) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 t24 = sign1 * platform_twist_wz, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: accelerations */
    const LIMB4 t3 = U_0_cos * t24;
    OWN(t11) = U_0_cos * GIVEN(platform_twist_wy) + signed_U_0_sin * t24;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), t9 = U_v_0 * (OWN(t8) + OWN(upper_position_x) * OWN(t11));
    OWN(t9) = signed_U_0_sin * GIVEN(platform_twist_wy) - t3;
    const LIMB4 t10 = OWN(t9) * OWN(t10) + t9, t11 = U_v_0 * OWN(t9);
    OWN(t12) = GIVEN(platform_twist_wx) * OWN(t8) - t10;
    /* each limb: free motion; accelerations */
    OWN(t16) = OWN(t1) * OWN(t12);
    OWN(signed_U_handed_force_0) = OWN(U_mass_matrix_0_by_U_0) * OWN(t16) + OWN(t17);
    const LIMB4 S_handed_force_1 = OWN(signed_U_follows_0_by_S_1) * OWN(signed_U_handed_force_0);
    OWN(t18) = U_0_cos * S_handed_force_1;
    OWN(t25) = signed_U_0_sin * S_handed_force_1;
    const LIMB4 t13 = OWN(S_arm_x) * t11 + OWN(t13);
    OWN(t21) = OWN(S_arm_y) * t11 - OWN(t11) * OWN(t20);
    const LIMB4 t21 = OWN(S_arm_y) * (OWN(t19) + (IN_EACH4(READ, u, 0, 1) - limb_lower_m * (OWN(t21) -
        OWN(minus_lower_acc_x))));
    OWN(t15) = t13 + OWN(t11) * OWN(t14);
    OWN(t22) = OWN(t15) * (sign1 * OWN(t3));
    const LIMB4 S_handed_force_0 = t21 + OWN(U_follows_1_by_S_0) * (OWN(t23) - OWN(U_mass_matrix_1_by_U_1) *
        OWN(t22));
    OWN(t24) = signed_U_0_sin * S_handed_force_0;
    OWN(t26) = U_0_cos * S_handed_force_0;
}

STAGE(forward_dynamics, 2)(size_t limb, size_t stride, double *restrict a, const double *restrict sine,
    const double *restrict cosine, REAL minus_limb5_S_joint_acc_wz, const EACH4 signed_limb5_S_joint_acc_wy,
    const EACH4 signed_limb5_S_joint_acc_wx, LIMBS(forward_dynamics) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: accelerations */
    const LIMB4 t4 = OWN(signed_U_follows_0_by_S_1) * (U_0_cos * minus_limb5_S_joint_acc_wz + signed_U_0_sin *
        GIVEN(signed_limb5_S_joint_acc_wy)),
      U_joint_acc_0 = t4 - sign1 * OWN(t16) - sign1 * GIVEN(signed_limb5_S_joint_acc_wx);
    WRITE4(a, 0, 3, 6, 9, U_joint_acc_0);
    LIMB4 checked = OWN(checked) + U_joint_acc_0;
    const LIMB4 t13 = sign1 * (U_0_cos * GIVEN(signed_limb5_S_joint_acc_wy) - signed_U_0_sin *
        minus_limb5_S_joint_acc_wz),
      U_joint_acc_1 = OWN(U_follows_1_by_S_0) * t13 - OWN(t22);
    WRITE4(a, 1, 4, 7, 10, U_joint_acc_1);
    checked = checked + U_joint_acc_1;
    const LIMB4 P_joint_acc = OWN(t21) - OWN(S_arm_y) * t13;
    WRITE4(a, 2, 5, 8, 11, P_joint_acc);
    checked = checked + P_joint_acc;
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
      platform_turn_xx = 1.0 - t6 * t9, t42 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5),
      platform_turn_zz = 1.0 - t9 * t42, t12 = limb5_S_q_qy * t9, t33 = limb5_S_q_qx * t12, t13 = limb5_S_q_qw *
          t12,
      t10 = limb5_S_q_qz * t9, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t34 = limb5_S_q_qw * t10,
      platform_turn_xy = t33 - t34, platform_turn_yx = t33 + t34, limb5_S_v_wy = READ(v, 13),
      limb5_S_v_wx = READ(v, 12), t75 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      t11 = limb5_S_q_qx * t10, t14 = limb5_S_q_qy * t10, platform_turn_xz = t11 + t13, platform_turn_zx = t11 -
          t13,
      limb5_S_v_wz = READ(v, 14), platform_twist_wx = t75 + limb5_S_v_wz * platform_turn_xz,
      t79 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, platform_turn_yz = t14 - t16,
      platform_turn_zy = t14 + t16, platform_twist_wy = t79 + limb5_S_v_wz * platform_turn_yz;
    const EACH4 platform_twist_wx_2 = {platform_twist_wx, platform_twist_wy, platform_twist_wx, platform_twist_wy},
      platform_twist_wy_2 = {platform_twist_wy, platform_twist_wx, platform_twist_wy, platform_twist_wx};
    const REAL t84 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t84;
    FIRST_LIMB(0, forward_dynamics, 0, stride, q, v, sine, cosine, &limbs);
    FIRST_LIMB(0, forward_dynamics, 1, stride, v, u, sine, cosine, platform_twist_wx_2, platform_twist_wy_2,
        platform_twist_wz, &limbs);
    /* limb1: geometry; accelerations; reciprocal wrenches, eq. (10) */
    const REAL limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1), limb1_U_v_0 = READ(v, 0),
      t89 = limb1_lower_cos * limbs.t9[0] - limb1_lower_sin * platform_twist_wx, /* limb5_S */
      t95 = limb1_lower_cos * platform_twist_wx, /* limb5_S */
      limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin, t90 = limb1_lower_omega_x + t89, /* limb5_S */
      limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      t31 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t32 = limb1_lower_cos * t31,
      limb1_U2_opening_mn = limb1_lower_sin * t31 + limb1_lower_cos * platform_turn_xy;
    /* limb5_S: accelerations; pivots; rates that follow */
    const REAL t93 = limb1_U2_opening_mn * t90, t96 = limb1_lower_sin * limbs.t9[0] + t95,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, t97 = limb1_lower_omega_y - t96,
      t107 = limb1_lower_omega_x * t97, limb1_U2_constraint_mn_couple_z = t32 - limb1_lower_sin * platform_turn_xy,
      t100 = t90 * (t93 + limb1_U2_constraint_mn_couple_z * t97),
      t110 = limb1_U2_constraint_mn_couple_z * (t107 - limb1_lower_omega_y * t90),
      t112 = limb1_lower_omega_y * limbs.t11[0],
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      limb1_U_v_1 = READ(v, 1), t102 = limb1_U2_constraint_mn_couple_x * t97,
      t115 = t110 - limb1_U2_constraint_mn_couple_x * (limb1_U_v_1 * t97 + t112), t101 = limb1_U_v_1 - limbs.t11[0],
      t116 = t100 - t101 * (t102 - limb1_U2_opening_mn * t101) + t115,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t3[0],
      t117 = limbs.t15[0] * limb1_U_factor_1_by_3 + t116,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      t118 = minus_limb1_U_factor_0_by_3 * limbs.t12[0] + t117,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn + limbs.upper_position_x[0] *
          minus_limb1_U_factor_0_by_3,
      t40 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3, /* limb1 */
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin *
          minus_limb1_U2_factor_0_by_3;
    REAL checked0 = minus_limb5_S_pivot_wz;
    const REAL t38 = 1.0 / minus_limb5_S_pivot_wz, minus_limb5_S_joint_acc_still_wz = t38 * t118,
      limb5_S_null_space_wz_by_limb5_S_wy = t38 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t40);
    /* limb5_S: free motion; momentum rate, eq. (35); accelerations */
    const REAL t44 = k13 * platform_turn_zz, t62 = k14 + platform_turn_zz * t44, t45 = platform_turn_xz * t44;
    NEXT_LIMB(2, forward_dynamics, 0, stride, q, v, sine, cosine, &limbs);
    const REAL t63 = t62 + limbs.t7[2], t46 = t45 - limbs.t4[2];
    NEXT_LIMB(1, forward_dynamics, 0, stride, q, v, sine, cosine, &limbs);
    const REAL t64 = limbs.t7[1] + t63, t47 = t46 + limbs.t5[1];
    NEXT_LIMB(3, forward_dynamics, 0, stride, q, v, sine, cosine, &limbs);
    const REAL limb5_S_handed_inertia_wz = limbs.t7[0] + (limbs.t7[3] + t64),
      limb5_S_handed_inertia_wz_by_limb5_S_wx = limbs.t5[3] + t47 - limbs.t4[0],
      t119 = limb5_S_handed_inertia_wz * minus_limb5_S_joint_acc_still_wz,
      t66 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz;
    NEXT_LIMB(2, forward_dynamics, 1, stride, v, u, sine, cosine, platform_twist_wx_2, platform_twist_wy_2,
        platform_twist_wz, &limbs);
    const REAL platform_rate_mx = k13 * (limb5_S_v_wy * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zy,
      t121 = platform_turn_zx * platform_rate_mx,
      minus_platform_rate_my = k13 * (limb5_S_v_wx * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zx,
      t125 = t121 - platform_turn_zy * minus_platform_rate_my + limbs.t24[2];
    NEXT_LIMB(1, forward_dynamics, 1, stride, v, u, sine, cosine, platform_twist_wx_2, platform_twist_wy_2,
        platform_twist_wz, &limbs);
    NEXT_LIMB(3, forward_dynamics, 1, stride, v, u, sine, cosine, platform_twist_wx_2, platform_twist_wy_2,
        platform_twist_wz, &limbs);
    const REAL t131 = limbs.t18[3] + (limbs.t18[1] + (limbs.t24[3] - (t125 - limbs.t24[1]) - limbs.t24[0] -
        limbs.t18[2])),
      t133 = limb5_S_null_space_wz_by_limb5_S_wy * (t119 + (t131 - limbs.t18[0])), t17 = k13 * platform_turn_yz,
      t60 = limbs.t5[0] + (limbs.t4[3] + (limbs.t4[1] - (platform_turn_zz * t17 - limbs.t5[2]))),
      t134 = t60 * minus_limb5_S_joint_acc_still_wz, t69 = limb5_S_null_space_wz_by_limb5_S_wy * (t60 + (t60 -
          t66)),
      t147 = platform_turn_xx * platform_rate_mx,
      t138 = platform_turn_yx * platform_rate_mx - platform_turn_yy * minus_platform_rate_my + limbs.t26[2],
      t142 = limbs.signed_U_handed_force_0[3] + (limbs.signed_U_handed_force_0[1] + (limbs.t26[0] + t138 -
          limbs.t25[2])),
      limb5_S_reduced_force_wy = t133 - (t134 + (t142 - limbs.t25[0])),
      t152 = limbs.t26[3] + (t147 - platform_turn_xy * minus_platform_rate_my + limbs.t26[1]) -
          limbs.signed_U_handed_force_0[2],
      t155 = limbs.signed_U_handed_force_0[0] - (t152 - limbs.t25[1] - limbs.t25[3]),
      t54 = limbs.U_mass_matrix_0_by_U_0[3] + (limbs.U_mass_matrix_0_by_U_0[1] + (k14 + platform_turn_yz * t17 +
          limbs.t6[2])),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = limbs.t6[0] + t54 - t69;
    REAL checked1 = limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t70 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t22 = platform_turn_xz * t17 + limbs.t2[2] - limbs.t2[1] - limbs.t2[3] + limbs.t2[0],
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t22 + limb5_S_null_space_wz_by_limb5_S_wy *
          limb5_S_handed_inertia_wz_by_limb5_S_wx;
    /* limb5_S: accelerations; pivots; free motion */
    const REAL t156 = limb5_S_handed_inertia_wz_by_limb5_S_wx * minus_limb5_S_joint_acc_still_wz + t155,
      t71 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t70, t164 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t71,
      t166 = t70 * limb5_S_reduced_force_wy, t157 = t71 * limb5_S_reduced_force_wy - t156,
      t162 = limbs.U_mass_matrix_0_by_U_0[2] + (k14 + platform_turn_xz * (k13 * platform_turn_xz)) + limbs.t6[1],
      pivot_1 = limbs.U_mass_matrix_0_by_U_0[0] + (limbs.t6[3] + t162) - t164;
    REAL checked2 = pivot_1;
    const REAL minus_limb5_S_joint_acc_wx = t157 / pivot_1,
      limb5_S_joint_acc_wy = t71 * minus_limb5_S_joint_acc_wx + t166,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz - limb5_S_null_space_wz_by_limb5_S_wy *
          limb5_S_joint_acc_wy,
      t171 = platform_turn_zx * minus_limb5_S_joint_acc_wz,
      platform_alpha_x = platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx -
          t171;
    WRITE(a, 12, platform_alpha_x);
    REAL checked3 = platform_alpha_x;
    const REAL t175 = platform_turn_zy * minus_limb5_S_joint_acc_wz;
    RESULT(checked0, a, 13, platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx
        - t175);
    const REAL t179 = platform_turn_zz * minus_limb5_S_joint_acc_wz;
    RESULT(checked1, a, 14, platform_turn_yz * limb5_S_joint_acc_wy - platform_turn_xz * minus_limb5_S_joint_acc_wx
        - t179);
    const EACH4 signed_limb5_S_joint_acc_wy = {limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx,
        limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx},
      signed_limb5_S_joint_acc_wx = {minus_limb5_S_joint_acc_wx, limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx,
          limb5_S_joint_acc_wy};
    FIRST_LIMB(0, forward_dynamics, 2, stride, a, sine, cosine, minus_limb5_S_joint_acc_wz,
        signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[0]);
    NEXT_LIMB(1, forward_dynamics, 2, stride, a, sine, cosine, minus_limb5_S_joint_acc_wz,
        signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, forward_dynamics, 2, stride, a, sine, cosine, minus_limb5_S_joint_acc_wz,
        signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, forward_dynamics, 2, stride, a, sine, cosine, minus_limb5_S_joint_acc_wz,
        signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-06, 6.62327e-06, 6.62327e-06, 6.62327e-06) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-05) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 0.0007562600000000001) OR
            /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 0.0007551200000000001),
            /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 upper_offset_x, signed_upper_position_x, minus_U_0_lever_mz_by_S_fz, t1, S_arm_x, t2,
      signed_S_arm_y, signed_U_joint_rate_1, signed_U_joint_rate_0, t3, t4, t5, t6,
      minus_U_follows_0_by_S_1, t7, U_mass_matrix_0_by_U_0, t8, t9, U_follows_1_by_S_0,
      U_mass_matrix_1_by_U_1, t10, t11, t12, signed_U_0_moment_z, t13, t14, signed_U_0_composite_second_yz,
      t15, signed_U_handed_force_0, t16, signed_lower_moment_z, signed_lower_acc_x, t17, t18, t19, checked;
} LIMBS(forward_dynamics_independent);

STAGE(forward_dynamics_independent, 0)(size_t limb, size_t stride, const double *restrict q,
    const double *restrict sine, const double *restrict cosine, LIMBS(forward_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0);
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: reciprocal wrenches, eq. (10); inertia; rates that follow */
    OWN(signed_S_arm_y) = param_R * lower_cos;
    OWN(upper_offset_x) = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    const LIMB4 lower_composite_first_x = limb_lower_m * OWN(upper_offset_x), t2 = lower_composite_first_x + (-k8);
    OWN(t13) = lower_composite_first_x + t2;
    const LIMB4 t3 = OWN(upper_offset_x) * t2;
    OWN(U_mass_matrix_1_by_U_1) = t3 + k10;
    OWN(t7) = lower_cos * (t3 + k9);
    OWN(U_mass_matrix_0_by_U_0) = lower_cos * OWN(t7) + k4;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * OWN(upper_offset_x);
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = 1.0 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(S_arm_x) = OWN(upper_offset_x) - param_R * signed_lower_sin;
    OWN(U_follows_1_by_S_0) = OWN(S_arm_x) * OWN(t2);
    OWN(signed_upper_position_x) = signed_lower_sin * OWN(upper_offset_x) + (-param_R);
    OWN(minus_U_follows_0_by_S_1) = sign1 * OWN(signed_upper_position_x) * OWN(t1);
    OWN(checked) = checked;
}

STAGE(forward_dynamics_independent, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, LIMBS(forward_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    /* each limb: free motion */
    const LIMB4 t4 = OWN(signed_S_arm_y) * (k21 * IN_EACH4(SINES, cosine, 1, 2)),
      t7 = t4 + OWN(U_follows_1_by_S_0) * (OWN(U_mass_matrix_1_by_U_1) * OWN(U_follows_1_by_S_0)),
      t1 = OWN(minus_U_follows_0_by_S_1) * OWN(U_mass_matrix_0_by_U_0), U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    OWN(t9) = U_0_cos * t1;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    OWN(t8) = signed_U_0_sin * t1;
    const LIMB4 t2 = OWN(minus_U_follows_0_by_S_1) * t1, t9 = U_0_cos * (t2 - t7);
    OWN(t10) = signed_U_0_sin * t9;
    const LIMB4 t10 = U_0_cos * t9;
    OWN(t12) = t7 + t10;
    OWN(t11) = t2 - t10;
}

STAGE(forward_dynamics_independent, 2)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, LIMBS(forward_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_gravity_z = sign1 * gravity_z,
      sign2 = OF4(1.0, -1.0, -1.0, 1.0), each_limb_lower_m = sign2 * limb_lower_m;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: balance, eqs. (40)-(47); free motion; accelerations */
    OWN(signed_U_0_moment_z) = lower_cos * (OWN(upper_offset_x) * (limb_lower_m_gravity_z *
        IN_EACH4(SINES, sine, 0, 2)));
    OWN(t14) = lower_cos * (lower_cos * OWN(t13));
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(signed_U_0_composite_second_yz) = signed_lower_sin * OWN(t7);
    OWN(t15) = (-2.0) * OWN(signed_U_0_composite_second_yz);
    const LIMB4 signed_U_0_acc_y = each_gravity_z * IN_EACH4(SINES, cosine, 0, 2);
    OWN(signed_lower_acc_x) = lower_cos * signed_U_0_acc_y;
    OWN(signed_lower_moment_z) = OWN(upper_offset_x) * (each_limb_lower_m * (signed_lower_sin * signed_U_0_acc_y));
}

STAGE(forward_dynamics_independent, 3)(size_t limb, size_t stride, const double *restrict u,
    const double *restrict sine, const double *restrict cosine, REAL limb5_S_joint_rate_wz,
    const EACH4 signed_limb5_S_joint_rate_wy, const EACH4 signed_limb5_S_joint_rate_wx, const EACH4 given,
    REAL given_2, const EACH4 given_3, LIMBS(forward_dynamics_independent) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0),
      sign3 = OF4(1.0, -1.0, -1.0, 1.0), each_param_R = -sign1 * param_R, each_limb_lower_m = sign3 * limb_lower_m;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: velocities, eq. (6) */
    const LIMB4 t3 = signed_U_0_sin * limb5_S_joint_rate_wz + U_0_cos * GIVEN(signed_limb5_S_joint_rate_wy);
    OWN(signed_U_joint_rate_1) = OWN(t2) * (OWN(S_arm_x) * t3);
    const LIMB4 signed_P_joint_rate = OWN(signed_S_arm_y) * t3, signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: accelerations; free motion; velocities, eq. (6) */
    const LIMB4 t5 = signed_lower_sin * OWN(signed_U_joint_rate_1), lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t48 = each_param_R * t5, t7 = OWN(upper_offset_x) * t5 - lower_cos * signed_P_joint_rate,
      t10 = U_0_cos * limb5_S_joint_rate_wz - signed_U_0_sin * GIVEN(signed_limb5_S_joint_rate_wy),
      t61 = sign1 * OWN(signed_upper_position_x);
    OWN(signed_U_joint_rate_0) = GIVEN(signed_limb5_S_joint_rate_wx) + OWN(t1) * (t61 * t10);
    const LIMB4 t64 = sign1 * (t7 * (GIVEN(given) + sign2 * OWN(signed_U_joint_rate_0))),
      t16 = lower_cos * OWN(signed_U_joint_rate_1), t28 = signed_P_joint_rate - param_R * t16,
      t18 = signed_lower_sin * signed_P_joint_rate + OWN(upper_offset_x) * t16, t63 = sign2 * given_2,
      t22 = signed_U_0_sin * t63;
    OWN(t3) = U_0_cos * t63 - signed_U_0_sin * GIVEN(given_3);
    const LIMB4 t21 = t18 * OWN(t3), t31 = OWN(t3) * OWN(signed_U_joint_rate_0);
    OWN(t4) = t22 + U_0_cos * GIVEN(given_3);
    const LIMB4 t66 = sign2 * (OWN(t4) * t28);
    /* each limb: free motion; accelerations */
    const LIMB4 t49 = OWN(t4) * t48;
    OWN(t5) = t64 + (t21 + t61 * (OWN(signed_U_joint_rate_0) * OWN(t4)));
    const LIMB4 t35 = OWN(U_mass_matrix_0_by_U_0) * (OWN(t1) * OWN(t5)),
      t39 = OWN(signed_U_joint_rate_0) * (OWN(t14) * signed_P_joint_rate + OWN(signed_U_joint_rate_1) * OWN(t15));
    OWN(signed_U_handed_force_0) = t35 + (OWN(signed_U_0_moment_z) + sign3 * t39);
    const LIMB4 signed_S_handed_force_1 = OWN(minus_U_follows_0_by_S_1) * OWN(signed_U_handed_force_0);
    OWN(t16) = U_0_cos * signed_S_handed_force_1;
    OWN(t18) = signed_U_0_sin * signed_S_handed_force_1;
    const LIMB4 t30 = signed_P_joint_rate * OWN(signed_U_joint_rate_1),
      minus_U_0_U_still_xx = OWN(signed_U_joint_rate_0) * OWN(signed_U_joint_rate_0),
      t55 = OWN(t13) * (OWN(signed_U_joint_rate_1) * OWN(signed_U_joint_rate_1));
    OWN(t6) = t30 + sign3 * (OWN(S_arm_x) * t31) - t66;
    const LIMB4 t42 = OWN(U_mass_matrix_1_by_U_1) * (OWN(t2) * OWN(t6)),
      t53 = each_limb_lower_m * (OWN(signed_lower_acc_x) + (t49 - OWN(signed_S_arm_y) * t31)),
      t46 = OWN(signed_lower_moment_z) - (OWN(t13) * t30 + OWN(signed_U_0_composite_second_yz) *
          minus_U_0_U_still_xx),
      t47 = OWN(U_follows_1_by_S_0) * (t42 + t46),
      t60 = OWN(signed_S_arm_y) * (t53 - (IN_EACH4(READ, u, 0, 1) + 0.5 * (t55 + OWN(t14) * minus_U_0_U_still_xx))),
      signed_S_handed_force_0 = t47 - t60;
    OWN(t17) = signed_U_0_sin * signed_S_handed_force_0;
    OWN(t19) = U_0_cos * signed_S_handed_force_0;
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
      t83 = t2 + t4, t9 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t9 * t10, t35 = k2 - 0.5 * t7,
      platform_turn_xx = 1.0 - t6 * t9, platform_turn_zz = 1.0 - t9 * t83, t13 = limb5_S_q_qz * t9,
      t14 = limb5_S_q_qy * t13, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t24 = limb5_S_q_qy * t9,
      platform_turn_zy = t14 + t16, platform_turn_yz = t14 - t16, limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_sin = SINES(sine, 0),
      t22 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t23 = limb1_lower_cos * t22, /* limb1 */
      t116 = limb1_lower_sin * t22, /* limb1 */
      t25 = limb5_S_q_qx * t24, t82 = limb5_S_q_qw * t24, t26 = limb5_S_q_qw * t13, t81 = limb5_S_q_qx * t13,
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
      t46 = 0.5 * (t39 - t44), t40 = 0.5 * t39, limb5_S_y_dot_qx = READ(y_dot, 0), limb5_S_y_dot_qy =
          READ(y_dot, 1),
      t47 = t40 * t46, t41 = t40 * limb5_S_y_dot_qx, t55 = limb5_S_y_dot_qy * t46, t48 = limb5_S_q_qx * t35,
      t36 = limb5_S_q_qw * t35, t51 = 0.5 * (t36 + t48 * limb5_S_null_space_wz_by_limb5_S_wy), t37 = 0.5 * t36,
      a_pivot = t47 + t37 * t51;
    REAL checked2 = a_pivot;
    const REAL t53 = 1.0 / a_pivot, limb5_S_joint_rate_wy = (t37 * limb5_S_y_dot_qy + t41) * t53,
      limb5_S_joint_rate_wz = t30 * (t33 * limb5_S_joint_rate_wy),
      minus_limb5_S_joint_rate_wx = t53 * (t55 - limb5_S_y_dot_qx * t51),
      t90 = platform_turn_zy * limb5_S_joint_rate_wz,
      platform_omega_y = t90 + (platform_turn_yy * limb5_S_joint_rate_wy - platform_turn_xy *
          minus_limb5_S_joint_rate_wx),
      t94 = platform_turn_xy * platform_omega_y, platform_turn_zx = t81 - t82, platform_turn_xz = t81 + t82,
      t96 = platform_turn_zx * limb5_S_joint_rate_wz,
      platform_omega_x = t96 + (platform_turn_yx * limb5_S_joint_rate_wy - platform_turn_xx *
          minus_limb5_S_joint_rate_wx);
    /* limb5_S: accelerations; velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t101 = t94 + platform_turn_xx * platform_omega_x, t85 = platform_turn_zz * limb5_S_joint_rate_wz,
      platform_omega_z = t85 + (platform_turn_yz * limb5_S_joint_rate_wy - platform_turn_xz *
          minus_limb5_S_joint_rate_wx),
      t102 = platform_turn_xz * platform_omega_z + t101,
      t106 = platform_turn_yy * platform_omega_y + platform_turn_yx * platform_omega_x,
      t107 = platform_turn_yz * platform_omega_z + t106;
    const EACH4 given = {t102, t107, t102, t107}, given_3 = {t107, t102, t107, t102};
    const REAL t185 = k13 * (platform_omega_z * platform_omega_y),
      t111 = platform_turn_zy * platform_omega_y + platform_turn_zx * platform_omega_x,
      platform_U_still_xz = platform_omega_z * platform_omega_x, t112 = platform_turn_zz * platform_omega_z + t111,
      t183 = k13 * platform_U_still_xz;
    const EACH4 signed_limb5_S_joint_rate_wy = {limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx,
        limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx},
      signed_limb5_S_joint_rate_wx = {minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy,
          minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy};
    FIRST_LIMB(0, forward_dynamics_independent, 2, stride, sine, cosine, &limbs);
    FIRST_LIMB(0, forward_dynamics_independent, 3, stride, u, sine, cosine, limb5_S_joint_rate_wz,
        signed_limb5_S_joint_rate_wy, signed_limb5_S_joint_rate_wx, given, t112, given_3, &limbs);
    const REAL t114 = limb1_U_factor_1_by_3 * limbs.t6[0], t113 = minus_limb1_U_factor_0_by_3 * limbs.t5[0],
      t121 = limb1_lower_cos * t102 - limb1_lower_sin * limbs.t3[0], t126 = limb1_lower_sin * t102,
      minus_limb1_lower_omega_y = limb1_lower_cos * limbs.signed_U_joint_rate_0[0],
      t122 = t121 + minus_limb1_lower_omega_y,
      t141 = limbs.signed_U_joint_rate_1[0] * (minus_limb1_lower_omega_y + t122),
      t115 = limbs.signed_U_joint_rate_1[0] - limbs.t4[0],
      t143 = limb1_U2_constraint_mn_couple_x * (t115 * minus_limb1_lower_omega_y - t141),
      t123 = limb1_U2_constraint_mn_couple_x * t122, t128 = t126 + limb1_lower_cos * limbs.t3[0],
      minus_limb1_lower_omega_x = limb1_lower_sin * limbs.signed_U_joint_rate_0[0],
      t129 = t128 + minus_limb1_lower_omega_x,
      t138 = limb1_U2_constraint_mn_couple_z * (minus_limb1_lower_omega_y * t129 - t122 *
          minus_limb1_lower_omega_x),
      t144 = t138 + t143, t130 = limb1_U2_constraint_mn_couple_z * t122,
      limb1_U2_opening_mn = t116 + limb1_lower_cos * platform_turn_xy,
      t125 = t115 * (limb1_U2_opening_mn * t115 + t123),
      t146 = t114 + (t125 + t129 * (t130 + limb1_U2_opening_mn * t129) - t144),
      minus_limb5_S_joint_acc_still_wz = t30 * (t113 + t146);
    /* limb5_S: free motion; accelerations; pivots */
    const REAL t154 = k13 * platform_turn_zz, t172 = k14 + platform_turn_zz * t154, t155 = platform_turn_xz * t154;
    NEXT_LIMB(2, forward_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    REAL checked3 = ALONE(limbs.checked[2]);
    FIRST_LIMB(2, forward_dynamics_independent, 1, stride, sine, cosine, &limbs);
    const REAL t173 = t172 + limbs.t12[2], t156 = t155 - limbs.t9[2];
    NEXT_LIMB(1, forward_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[1]);
    NEXT_LIMB(1, forward_dynamics_independent, 1, stride, sine, cosine, &limbs);
    const REAL t174 = limbs.t12[1] + t173, t157 = t156 + limbs.t10[1];
    NEXT_LIMB(3, forward_dynamics_independent, 0, stride, q, sine, cosine, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
    NEXT_LIMB(3, forward_dynamics_independent, 1, stride, sine, cosine, &limbs);
    const REAL t175 = limbs.t12[3] + t174, t158 = limbs.t10[3] + t157;
    NEXT_LIMB(0, forward_dynamics_independent, 1, stride, sine, cosine, &limbs);
    const REAL limb5_S_handed_inertia_wz = limbs.t12[0] + t175,
      limb5_S_handed_inertia_wz_by_limb5_S_wx = t158 - limbs.t9[0],
      t182 = limb5_S_handed_inertia_wz * minus_limb5_S_joint_acc_still_wz,
      t176 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz,
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - t183, t184 = platform_turn_zy *
          platform_rate_my,
      minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - t185,
      t187 = t184 - platform_turn_zx * minus_platform_rate_mx;
    NEXT_LIMB(2, forward_dynamics_independent, 2, stride, sine, cosine, &limbs);
    NEXT_LIMB(2, forward_dynamics_independent, 3, stride, u, sine, cosine, limb5_S_joint_rate_wz,
        signed_limb5_S_joint_rate_wy, signed_limb5_S_joint_rate_wx, given, t112, given_3, &limbs);
    const REAL t188 = t187 + limbs.t17[2];
    NEXT_LIMB(1, forward_dynamics_independent, 2, stride, sine, cosine, &limbs);
    NEXT_LIMB(1, forward_dynamics_independent, 3, stride, u, sine, cosine, limb5_S_joint_rate_wz,
        signed_limb5_S_joint_rate_wy, signed_limb5_S_joint_rate_wx, given, t112, given_3, &limbs);
    const REAL t189 = limbs.t17[1] + t188;
    NEXT_LIMB(3, forward_dynamics_independent, 2, stride, sine, cosine, &limbs);
    NEXT_LIMB(3, forward_dynamics_independent, 3, stride, u, sine, cosine, limb5_S_joint_rate_wz,
        signed_limb5_S_joint_rate_wy, signed_limb5_S_joint_rate_wx, given, t112, given_3, &limbs);
    const REAL t195 = limbs.t16[0] + (limbs.t16[3] + (limbs.t16[1] + (limbs.t16[2] - (limbs.t17[0] + (limbs.t17[3] -
        t189))))),
      t196 = limb5_S_null_space_wz_by_limb5_S_wy * (t195 - t182), t148 = k13 * platform_turn_yz,
      t170 = limbs.t10[0] - (limbs.t9[3] + (limbs.t9[1] + (platform_turn_zz * t148 - limbs.t10[2]))),
      t197 = t170 * minus_limb5_S_joint_acc_still_wz,
      t179 = limb5_S_null_space_wz_by_limb5_S_wy * (t170 + (t170 - t176)),
      t210 = platform_turn_xy * platform_rate_my,
      t201 = platform_turn_yy * platform_rate_my - platform_turn_yx * minus_platform_rate_mx + limbs.t19[2],
      t205 = limbs.signed_U_handed_force_0[3] - (limbs.t18[2] - (t201 - limbs.t19[0]) -
          limbs.signed_U_handed_force_0[1]),
      minus_limb5_S_reduced_force_wy = t196 - (limbs.t18[0] - t205 - t197),
      t215 = limbs.signed_U_handed_force_0[2] - (limbs.t19[3] + (t210 - platform_turn_xx * minus_platform_rate_mx -
          limbs.t19[1])),
      t218 = limbs.t18[3] + (limbs.t18[1] - t215) - limbs.signed_U_handed_force_0[0],
      t164 = limbs.U_mass_matrix_0_by_U_0[3] + (limbs.U_mass_matrix_0_by_U_0[1] + (k14 + platform_turn_yz * t148 +
          limbs.t11[2])),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = limbs.t11[0] + t164 - t179;
    checked2 = checked2 + limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t180 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t153 = platform_turn_xz * t148 + limbs.t8[2] + limbs.t8[1] + limbs.t8[3] + limbs.t8[0],
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t153 + limb5_S_null_space_wz_by_limb5_S_wy *
          limb5_S_handed_inertia_wz_by_limb5_S_wx,
      t219 = t218 - limb5_S_handed_inertia_wz_by_limb5_S_wx * minus_limb5_S_joint_acc_still_wz,
      t181 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t180, t227 = limb5_S_reduced_inertia_wx_by_limb5_S_wy *
          t181,
      t229 = t180 * minus_limb5_S_reduced_force_wy, t220 = t181 * minus_limb5_S_reduced_force_wy - t219,
      t225 = limbs.U_mass_matrix_0_by_U_0[2] + (k14 + platform_turn_xz * (k13 * platform_turn_xz)) + limbs.t11[1],
      pivot_1 = limbs.U_mass_matrix_0_by_U_0[0] + (limbs.t11[3] + t225) - t227;
    checked3 = checked3 + pivot_1;
    const REAL limb5_S_joint_acc_wx = t220 / pivot_1,
      minus_limb5_S_joint_acc_wy = t181 * limb5_S_joint_acc_wx + t229,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy *
          minus_limb5_S_joint_acc_wy;
    /* limb5_S: results */
    const REAL t237 = platform_turn_zy * minus_limb5_S_joint_acc_wz,
      t241 = t237 + (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy * limb5_S_joint_acc_wx),
      t253 = platform_turn_zy * t241, t242 = platform_turn_xy * t241, t259 = platform_turn_yy * t241,
      t243 = platform_turn_zx * minus_limb5_S_joint_acc_wz, t231 = platform_turn_zz * minus_limb5_S_joint_acc_wz,
      t232 = platform_turn_yz * minus_limb5_S_joint_acc_wy,
      t247 = t243 + (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx * limb5_S_joint_acc_wx),
      t255 = t253 + platform_turn_zx * t247, t235 = t231 + (t232 - platform_turn_xz * limb5_S_joint_acc_wx),
      t256 = platform_turn_zz * t235 + t255, t261 = t259 + platform_turn_yx * t247,
      t250 = platform_turn_xz * t235 + (t242 + platform_turn_xx * t247), t262 = platform_turn_yz * t235 + t261,
      t282 = t36 * t262 + (t48 * t256 - t39 * t250), t265 = t36 * t250 + (t39 * t262 - t43 * t256),
      t272 = t43 * limb5_S_joint_rate_wz - t39 * limb5_S_joint_rate_wy + t36 * minus_limb5_S_joint_rate_wx,
      t274 = limb5_S_joint_rate_wz * (0.5 * t272), t61 = t36 * limb5_S_joint_rate_wy,
      t69 = t48 * limb5_S_joint_rate_wy + t43 * minus_limb5_S_joint_rate_wx - t36 * limb5_S_joint_rate_wz,
      t70 = 0.5 * t69, t275 = minus_limb5_S_joint_rate_wx * t70 + t274, t71 = limb5_S_joint_rate_wy * t70,
      t58 = t39 * minus_limb5_S_joint_rate_wx,
      t77 = t39 * limb5_S_joint_rate_wz + (t43 * limb5_S_joint_rate_wy - t48 * minus_limb5_S_joint_rate_wx),
      t78 = 0.5 * t77, t79 = minus_limb5_S_joint_rate_wx * t78,
      minus_limb5_S_y_ddot_qy = 0.5 * (t275 + limb5_S_joint_rate_wy * t78 + t282);
    checked0 = checked0 + minus_limb5_S_y_ddot_qy;
    WRITE(y_ddot, 1, -minus_limb5_S_y_ddot_qy);
    const REAL t72 = limb5_S_joint_rate_wz * (0.5 * (t58 + t48 * limb5_S_joint_rate_wz + t61)) + t71,
      minus_limb5_S_y_ddot_qx = 0.5 * (t72 - t79 + t265);
    checked1 = checked1 + minus_limb5_S_y_ddot_qx;
    WRITE(y_ddot, 0, -minus_limb5_S_y_ddot_qx);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 7.562600000000002e-08) OR
            /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 7.551200000000001e-08),
            /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 upper_offset_x, upper_position_x, minus_U_0_lever_mz_by_S_fz, t1, U_follows_0_by_S_1,
      U_mass_matrix_0_by_U_0, t2, S_arm_x, t3, t4, S_arm_y, minus_U_follows_1_by_S_0, t5, t6, t7,
      lower_omega_y, lower_alpha_still_x, t8, t9, lower_omega_x, t10, t11, t12, minus_upper_force_z,
      U_handed_force_0, t13, t14, minus_upper_force_x, t15, lower_acc_y, upper_force_y, t16, t17, t18,
      minus_lower_U_still_xx, minus_lower_rate_fx, upper_rate_fy, S_multiplier_fy, upper_moment_y,
      minus_upper_rate_fz, S_multiplier_fz, t19, minus_upper_acc_still_x_2, minus_upper_rate_fx, t20, t21,
      t22, t23, t24, minus_upper_rate_my_2, minus_upper_rate_mx, signed_lower_rotation_zx,
      minus_lower_rotation_yx, minus_upper_rate_mz_2, signed_S_reaction_fy, signed_S_reaction_my,
      signed_S_reaction_mx, S_reaction_mz, t25, t26, checked;
} LIMBS(forward_dynamics_reactions);

STAGE(forward_dynamics_reactions, 0)(size_t limb, size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, const double *restrict sine,
    const double *restrict cosine, REAL platform_twist_wy, REAL platform_twist_wz, REAL platform_twist_wx,
    LIMBS(forward_dynamics_reactions) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = -sign1 * param_R, each_k21 = sign1 * k21,
      sign2 = OF4(1.0, -1.0, 1.0, -1.0), each_param_R_2 = sign1 * param_R,
      each_limb_lower_m_gravity_z = -sign2 * limb_lower_m_gravity_z, sign3 = OF4(1.0, -1.0, -1.0, 1.0),
      each_limb_lower_m = -sign3 * limb_lower_m, each_gravity_z = -sign2 * gravity_z;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: accelerations; free motion; inertia */
    OWN(minus_lower_rotation_yx) = signed_U_0_sin * lower_cos;
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    OWN(signed_lower_rotation_zx) = U_0_cos * lower_cos;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3);
    OWN(lower_omega_y) = U_v_0 * lower_cos;
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3);
    OWN(lower_alpha_still_x) = U_v_1 * OWN(lower_omega_y);
    const LIMB4 t68 = OWN(lower_omega_y) * OWN(lower_omega_y), t56 = U_v_1 * U_v_1;
    OWN(minus_lower_U_still_xx) = t68 + t56;
    OWN(upper_offset_x) = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    const LIMB4 minus_upper_acc_still_x = OWN(upper_offset_x) * OWN(minus_lower_U_still_xx),
      minus_U_0_acc_y = each_gravity_z * U_0_cos, minus_lower_acc_x = lower_cos * minus_U_0_acc_y;
    OWN(minus_upper_acc_still_x_2) = minus_upper_acc_still_x + minus_lower_acc_x;
    OWN(minus_upper_force_x) = limb_lower_m * minus_lower_acc_x;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      minus_P_generalised_force = OWN(minus_upper_force_x) + IN_EACH4(READ, u, 0, 1);
    OWN(S_arm_x) = OWN(upper_offset_x) - param_R * signed_lower_sin;
    const LIMB4 t71 = sign1 * signed_lower_sin;
    OWN(lower_acc_y) = t71 * minus_U_0_acc_y;
    OWN(upper_force_y) = limb_lower_m * OWN(lower_acc_y);
    const LIMB4 lower_moment_z = OWN(upper_offset_x) * OWN(upper_force_y);
    OWN(lower_omega_x) = U_v_0 * t71;
    const LIMB4 t69 = t71 * OWN(S_arm_x);
    OWN(S_arm_y) = each_param_R * lower_cos;
    OWN(t19) = t69 + lower_cos * OWN(S_arm_y);
    const LIMB4 lower_composite_first_x = limb_lower_m * OWN(upper_offset_x), t1 = lower_composite_first_x + (-k8),
      t44 = lower_composite_first_x + t1, t57 = t56 * t44, t2 = OWN(upper_offset_x) * t1,
      t46 = lower_cos * (lower_cos * t44), minus_U_0_U_still_xx = U_v_0 * U_v_0, P_v = IN_EACH4(READ, v, 2, 3),
      t60 = minus_P_generalised_force + 0.5 * (minus_U_0_U_still_xx * t46 + t57), t47 = P_v * t46,
      t72 = sign2 * platform_twist_wz, t18 = signed_U_0_sin * t72;
    OWN(t9) = signed_U_0_sin * platform_twist_wy - U_0_cos * t72;
    const LIMB4 t21 = U_v_0 * OWN(t9), t51 = OWN(S_arm_y) * t21, t22 = OWN(S_arm_x) * t21;
    OWN(t8) = U_0_cos * platform_twist_wy + t18;
    const LIMB4 t29 = U_v_1 * t71;
    OWN(t14) = t51 - OWN(t8) * (each_param_R_2 * t29);
    const LIMB4 t61 = OWN(S_arm_y) * (sign3 * (each_limb_lower_m * OWN(t14)) + t60), t30 = OWN(upper_offset_x) *
        t29,
      t4 = lower_cos * (t2 + k9), U_mass_matrix_1_by_U_1 = t2 + k10, U_0_composite_second_yz = t71 * t4,
      t64 = minus_U_0_U_still_xx * U_0_composite_second_yz,
      t49 = U_v_0 * (U_v_1 * (2.0 * U_0_composite_second_yz) - t47);
    OWN(U_mass_matrix_0_by_U_0) = lower_cos * t4 + k4;
    const LIMB4 t23 = U_v_1 * P_v, t66 = lower_moment_z + (t23 * t44 + t64), t24 = t22 + t23,
      t25 = U_v_1 * lower_cos;
    OWN(t10) = t24 + OWN(t8) * (each_param_R_2 * t25 - P_v);
    const LIMB4 t34 = OWN(upper_offset_x) * t25;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * OWN(upper_offset_x);
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = (-1.0) / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t3) = lower_cos * OWN(t1);
    OWN(t15) = OWN(t10) * OWN(t3);
    OWN(minus_U_follows_1_by_S_0) = OWN(S_arm_x) * OWN(t3);
    const LIMB4 S_handed_force_0 = t61 - OWN(minus_U_follows_1_by_S_0) * (U_mass_matrix_1_by_U_1 * OWN(t15) + t66);
    OWN(t18) = U_0_cos * S_handed_force_0;
    OWN(t16) = signed_U_0_sin * S_handed_force_0;
    const LIMB4 t12 = OWN(minus_U_follows_1_by_S_0) * (U_mass_matrix_1_by_U_1 * OWN(minus_U_follows_1_by_S_0));
    OWN(minus_upper_force_z) = each_limb_lower_m_gravity_z * signed_U_0_sin;
    const LIMB4 t50 = lower_cos * (OWN(upper_offset_x) * OWN(minus_upper_force_z)) - t49;
    OWN(upper_position_x) = t71 * OWN(upper_offset_x) + each_param_R;
    const LIMB4 t37 = OWN(upper_position_x) * OWN(t8), t36 = OWN(t9) * (P_v * t71 + t34);
    OWN(U_follows_0_by_S_1) = OWN(upper_position_x) * OWN(t1);
    const LIMB4 t32 = t30 - P_v * lower_cos;
    OWN(t11) = platform_twist_wx * t32 - (t36 + U_v_0 * (t32 + t37));
    /* each limb: free motion */
    OWN(t12) = OWN(t1) * OWN(t11);
    OWN(U_handed_force_0) = OWN(U_mass_matrix_0_by_U_0) * OWN(t12) + t50;
    const LIMB4 S_handed_force_1 = OWN(U_follows_0_by_S_1) * OWN(U_handed_force_0);
    OWN(t17) = signed_U_0_sin * S_handed_force_1;
    OWN(t13) = U_0_cos * S_handed_force_1;
    const LIMB4 t6 = OWN(U_follows_0_by_S_1) * OWN(U_mass_matrix_0_by_U_0), t8 = OWN(U_follows_0_by_S_1) * t6;
    OWN(t4) = U_0_cos * t6;
    OWN(t2) = signed_U_0_sin * t6;
    const LIMB4 t13 = OWN(S_arm_y) * (each_k21 * lower_cos) - t12, t15 = U_0_cos * (t8 + t13);
    OWN(t5) = signed_U_0_sin * t15;
    const LIMB4 t16 = U_0_cos * t15;
    OWN(t7) = t13 - t16;
    OWN(t6) = t8 - t16;
    OWN(checked) = checked;
}

STAGE(forward_dynamics_reactions, 1)(size_t limb, size_t stride, const double *restrict v,
    const double *restrict u, double *restrict a, const double *restrict sine, const double *restrict cosine,
    REAL limb5_S_joint_acc_wz, REAL signed_limb5_S_joint_acc_wy, REAL signed_limb5_S_joint_acc_wx, REAL given,
    LIMBS(forward_dynamics_reactions) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), each_k4 = sign1 * k4, sign2 = OF4(1.0, 1.0, -1.0, -1.0),
      each_gravity_z_limb_lower_mx = sign1 * gravity_z_limb_lower_mx, each_gravity_z = -sign1 * gravity_z;
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const LIMB4 t4 = OWN(U_follows_0_by_S_1) * (U_0_cos * limb5_S_joint_acc_wz + signed_U_0_sin *
        signed_limb5_S_joint_acc_wy),
      signed_U_joint_acc_0 = signed_limb5_S_joint_acc_wx + (sign1 * OWN(t12) + t4);
    WRITE4(a, 0, 3, 6, 9, sign1 * signed_U_joint_acc_0);
    const LIMB4 t50 = sign1 * signed_U_joint_acc_0, lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      U_v_1 = IN_EACH4(READ, v, 1, 3), U_0_rate_mz = each_k4 * signed_U_joint_acc_0, lower_U_xz = lower_cos * t50,
      minus_lower_alpha_still_y = U_v_1 * OWN(lower_omega_x), lower_alpha_y = lower_U_xz -
          minus_lower_alpha_still_y,
      minus_lower_U_zx = lower_alpha_y - minus_lower_alpha_still_y, t28 = OWN(upper_offset_x) * minus_lower_U_zx,
      minus_lower_rate_fz = limb_lower_mx * minus_lower_U_zx;
    OWN(t23) = OWN(minus_upper_force_z) + minus_lower_rate_fz;
    const LIMB4 P_v = IN_EACH4(READ, v, 2, 3),
      minus_upper_acc_z = P_v * (2.0 * OWN(lower_omega_y)) + (each_gravity_z * signed_U_0_sin + t28);
    OWN(minus_upper_rate_fz) = limb_lower_m * minus_upper_acc_z - minus_lower_rate_fz;
    /* each limb: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const LIMB4 t30 = OWN(upper_offset_x) * OWN(minus_upper_rate_fz),
      minus_upper_rate_my = limb_lower_mx * minus_upper_acc_z, t31 = t30 - minus_upper_rate_my,
      t24 = k10 * minus_lower_alpha_still_y - k9 * lower_alpha_y;
    OWN(t24) = k18 * minus_lower_alpha_still_y - k17 * lower_alpha_y;
    OWN(minus_upper_rate_my_2) = minus_upper_rate_my + OWN(t24);
    OWN(upper_moment_y) = each_gravity_z_limb_lower_mx * signed_U_0_sin;
    const LIMB4 t32 = lower_cos * (OWN(upper_moment_y) + t24 - t31), t49 = sign2 * IN_EACH4(SINES, sine, 1, 2),
      t43 = k15 * (OWN(lower_alpha_still_x) + t49 * t50);
    OWN(S_multiplier_fz) = OWN(t1) * (U_0_rate_mz + (t49 * (k11 * OWN(lower_alpha_still_x)) - t32));
    const LIMB4 t35 = U_0_cos * (OWN(S_multiplier_fz) * OWN(t19)),
      t48 = sign1 * (U_0_cos * signed_limb5_S_joint_acc_wy - signed_U_0_sin * limb5_S_joint_acc_wz);
    /* each limb: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const LIMB4 U_joint_acc_1 = OWN(t15) + OWN(minus_U_follows_1_by_S_0) * t48;
    WRITE4(a, 1, 4, 7, 10, U_joint_acc_1);
    const LIMB4 P_joint_acc = OWN(t14) + OWN(S_arm_y) * t48;
    WRITE4(a, 2, 5, 8, 11, P_joint_acc);
    const LIMB4 minus_lower_force_x = (-limb_lower_m) * (P_joint_acc - OWN(minus_upper_acc_still_x_2)),
      lower_U_still_xy = OWN(lower_omega_x) * OWN(lower_omega_y), lower_U_yx = lower_U_still_xy + U_joint_acc_1,
      t14 = OWN(lower_acc_y) + OWN(upper_offset_x) * lower_U_yx, lower_rate_fy = limb_lower_mx * lower_U_yx;
    OWN(t22) = OWN(upper_force_y) + lower_rate_fy;
    const LIMB4 upper_acc_y = P_v * (2.0 * U_v_1) + t14;
    OWN(upper_rate_fy) = limb_lower_m * upper_acc_y - lower_rate_fy;
    /* each limb: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const LIMB4 t19 = OWN(upper_offset_x) * OWN(upper_rate_fy), minus_upper_rate_mz = limb_lower_mx * upper_acc_y,
      t20 = minus_upper_rate_mz - t19, t17 = k9 * lower_U_still_xy - (-k10) * U_joint_acc_1;
    OWN(minus_upper_rate_mz_2) = minus_upper_rate_mz + ((-k19) * U_joint_acc_1 - k20 * lower_U_still_xy);
    OWN(S_multiplier_fy) = OWN(t3) * (t20 - (limb_lower_mx * OWN(lower_acc_y) + t17));
    const LIMB4 t37 = OWN(S_arm_x) * OWN(S_multiplier_fy);
    OWN(minus_lower_rate_fx) = limb_lower_mx * OWN(minus_lower_U_still_xx);
    OWN(minus_upper_rate_fx) = minus_lower_force_x - OWN(minus_lower_rate_fx);
    OWN(t20) = t35 + signed_U_0_sin * (OWN(S_arm_y) * OWN(minus_upper_rate_fx) + t37);
    OWN(t21) = IN_EACH4(READ, u, 0, 1) * (signed_U_0_sin * OWN(S_arm_y) * given);
    OWN(minus_upper_rate_mx) = k16 * OWN(lower_alpha_still_x) - t43;
}

STAGE(forward_dynamics_reactions, 2)(size_t limb, size_t stride, const double *restrict u,
    double *restrict reactions, const double *restrict sine, const double *restrict cosine,
    REAL signed_S_multiplier_fy, REAL signed_S_multiplier_fz, REAL minus_lower_sent_mx,
    REAL minus_upper_rate_mx, REAL minus_upper_rate_mz_2, LIMBS(forward_dynamics_reactions) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, -1.0, 1.0, -1.0), each_param_R = sign1 * param_R, each_param_R_2 = -sign1 * param_R;
    const LIMB4 P_u = IN_EACH4(READ, u, 0, 1), t71 = sign3 * (P_u + OWN(minus_upper_rate_fx)),
      lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: balance, eqs. (40)-(47) */
    const LIMB4 t62 = lower_cos * t71, t67 = sign1 * IN_EACH4(SINES, sine, 1, 2),
      t70 = sign1 * signed_S_multiplier_fy, t64 = t67 * t70 - t62, U_0_cos = IN_EACH4(SINES, cosine, 0, 2),
      signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), t66 = U_0_cos * t64, t65 = signed_U_0_sin * t64;
    /* each limb: reactions, eq. (32); balance, eqs. (40)-(47); geometry */
    const LIMB4 t52 = signed_U_0_sin * signed_S_multiplier_fz;
    OWN(t26) = t66 - t52;
    const LIMB4 t48 = U_0_cos * signed_S_multiplier_fz;
    OWN(t25) = t65 + t48;
    const LIMB4 lower_rotation_yy = signed_U_0_sin * t67,
      signed_S_reaction_fx = t48 + (lower_rotation_yy * t70 - OWN(minus_lower_rotation_yx) * t71);
    WRITE4(reactions, 13, 30, 49, 66, sign3 * signed_S_reaction_fx);
    const LIMB4 t61 = OWN(upper_position_x) * signed_S_reaction_fx, t54 = OWN(signed_lower_rotation_zx) * t71;
    OWN(signed_S_reaction_fy) = lower_cos * t70 + t67 * t71;
    WRITE4(reactions, 12, 31, 48, 67, sign3 * OWN(signed_S_reaction_fy));
    const LIMB4 minus_upper_position_y = OWN(upper_offset_x) * OWN(minus_lower_rotation_yx);
    OWN(S_reaction_mz) = minus_upper_position_y * OWN(signed_S_reaction_fy) + t61;
    const LIMB4 signed_lower_rotation_zy = U_0_cos * t67,
      S_reaction_fz = t52 + (t54 - signed_lower_rotation_zy * t70);
    WRITE4(reactions, 14, 32, 50, 68, S_reaction_fz);
    const LIMB4 t58 = OWN(upper_position_x) * S_reaction_fz, t57 = minus_upper_position_y * S_reaction_fz,
      signed_upper_position_z = OWN(upper_offset_x) * OWN(signed_lower_rotation_zx);
    OWN(signed_S_reaction_mx) = t58 - signed_upper_position_z * OWN(signed_S_reaction_fy);
    OWN(signed_S_reaction_my) = signed_upper_position_z * signed_S_reaction_fx + t57;
    const LIMB4 upper_sent_fy = OWN(upper_rate_fy) + sign2 * signed_S_multiplier_fy,
      t21 = lower_rotation_yy * upper_sent_fy, t31 = lower_rotation_yy * OWN(minus_upper_rate_my_2),
      minus_upper_sent_fz = OWN(minus_upper_rate_fz) - sign3 * signed_S_multiplier_fz,
      P_reaction_fy = t21 - U_0_cos * minus_upper_sent_fz;
    WRITE4(reactions, 7, 24, 43, 60, P_reaction_fy);
    const LIMB4 t38 = OWN(upper_position_x) * P_reaction_fy, t24 = signed_upper_position_z * P_reaction_fy,
      P_reaction_fx = lower_cos * upper_sent_fy;
    WRITE4(reactions, 6, 25, 42, 61, P_reaction_fx);
    const LIMB4 t36 = signed_upper_position_z * P_reaction_fx, t40 = t38 + minus_upper_position_y * P_reaction_fx,
      t42 = signed_lower_rotation_zy * OWN(minus_upper_rate_my_2), t23 = signed_lower_rotation_zy * upper_sent_fy,
      lower_sent_fy = upper_sent_fy + OWN(t22), t44 = t42 - OWN(signed_lower_rotation_zx) * minus_upper_rate_mx,
      signed_P_reaction_mz = t40 - (signed_U_0_sin * minus_upper_rate_mz_2 - t44);
    WRITE4(reactions, 11, 29, 47, 65, sign3 * signed_P_reaction_mz);
    LIMB4 checked = OWN(checked) + signed_P_reaction_mz;
    const LIMB4 signed_P_reaction_fz = signed_U_0_sin * minus_upper_sent_fz + t23;
    WRITE4(reactions, 8, 26, 44, 62, -sign3 * signed_P_reaction_fz);
    const LIMB4 t26 = minus_upper_position_y * signed_P_reaction_fz - t24,
      t37 = OWN(upper_position_x) * signed_P_reaction_fz + t36,
      P_reaction_my = t37 - (U_0_cos * minus_upper_rate_mz_2 - (OWN(minus_lower_rotation_yx) * minus_upper_rate_mx -
          t31));
    WRITE4(reactions, 10, 27, 46, 63, P_reaction_my);
    checked = checked + P_reaction_my;
    const LIMB4 P_reaction_mx = t26 - (lower_cos * OWN(minus_upper_rate_my_2) + t67 * minus_upper_rate_mx);
    WRITE4(reactions, 9, 28, 45, 64, P_reaction_mx);
    checked = checked + P_reaction_mx;
    /* each limb: balance, eqs. (40)-(47); reactions, eq. (32) */
    const LIMB4 t4 = t67 * lower_sent_fy, t2 = lower_cos * lower_sent_fy,
      lower_sent_fx = P_u - (OWN(minus_lower_rate_fx) + OWN(minus_upper_force_x)),
      minus_lower_joint_sent_fx = t4 - lower_cos * lower_sent_fx, lower_joint_sent_fy = t67 * lower_sent_fx + t2;
    WRITE4(reactions, 0, 19, 36, 55, lower_joint_sent_fy);
    checked = checked + lower_joint_sent_fy;
    const LIMB4 t5 = signed_U_0_sin * minus_lower_joint_sent_fx, t7 = U_0_cos * minus_lower_joint_sent_fx,
      minus_lower_sent_fz = minus_upper_sent_fz + OWN(t23),
      t11 = OWN(upper_offset_x) * minus_upper_sent_fz - OWN(minus_upper_rate_my_2),
      U_0_joint_sent_fx = t5 - U_0_cos * minus_lower_sent_fz;
    WRITE4(reactions, 1, 18, 37, 54, U_0_joint_sent_fx);
    const LIMB4 t19 = each_param_R_2 * U_0_joint_sent_fx,
      signed_U_0_joint_sent_fy = t7 + signed_U_0_sin * minus_lower_sent_fz;
    WRITE4(reactions, 2, 20, 38, 56, -sign3 * signed_U_0_joint_sent_fy);
    const LIMB4 t14 = each_param_R * signed_U_0_joint_sent_fy,
      lower_sent_my = t11 - (OWN(upper_moment_y) + OWN(t24)), t15 = t67 * lower_sent_my,
      lower_joint_sent_my = lower_cos * lower_sent_my - t67 * minus_lower_sent_mx;
    WRITE4(reactions, 3, 22, 39, 58, lower_joint_sent_my);
    checked = checked + lower_joint_sent_my;
    const LIMB4 minus_lower_joint_sent_mx = t15 + lower_cos * minus_lower_sent_mx,
      signed_U_reaction_mz = t19 - U_0_cos * minus_lower_joint_sent_mx;
    WRITE4(reactions, 5, 23, 41, 59, sign3 * signed_U_reaction_mz);
    checked = checked + signed_U_reaction_mz;
    const LIMB4 U_reaction_my = signed_U_0_sin * minus_lower_joint_sent_mx - t14;
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
      t42 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t42,
      platform_turn_xx = 1.0 - t6 * t9, t12 = limb5_S_q_qy * t9, t33 = limb5_S_q_qx * t12, t13 = limb5_S_q_qw * t12,
      t10 = limb5_S_q_qz * t9, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t34 = limb5_S_q_qw * t10,
      platform_turn_yx = t33 + t34, platform_turn_xy = t33 - t34, limb5_S_v_wx = READ(v, 12),
      limb5_S_v_wy = READ(v, 13), t74 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      t14 = limb5_S_q_qy * t10, t11 = limb5_S_q_qx * t10, platform_turn_yz = t14 - t16, platform_turn_zy = t14 +
          t16,
      limb5_S_v_wz = READ(v, 14), platform_twist_wy = t74 + limb5_S_v_wz * platform_turn_yz,
      platform_turn_zx = t11 - t13, platform_turn_xz = t11 + t13,
      t84 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t84,
      t79 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      platform_twist_wx = t79 + limb5_S_v_wz * platform_turn_xz;
    FIRST_LIMB(0, forward_dynamics_reactions, 0, stride, q, v, u, sine, cosine, platform_twist_wy,
        platform_twist_wz, platform_twist_wx, &limbs);
    /* limb1: geometry */
    const REAL limb1_lower_sin = SINES(sine, 1), limb1_lower_cos = SINES(cosine, 1);
    /* limb1: loop closure; reciprocal wrenches, eq. (10); rates that follow */
    const REAL t90 = limbs.lower_omega_y[0] - (limb1_lower_sin * limbs.t9[0] + limb1_lower_cos * platform_twist_wx),
      limb1_U_v_1 = READ(v, 1), t91 = limb1_U_v_1 * t90, t85 = limb1_U_v_1 - limbs.t8[0],
      limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0),
      t93 = limbs.lower_alpha_still_x[0] - (limbs.lower_omega_y[0] * t85 - t91),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t94 = limb1_U2_constraint_mn_couple_x * t93, t95 = limbs.lower_omega_x[0] * t90,
      t99 = limbs.lower_omega_x[0] + (limb1_lower_cos * limbs.t9[0] - limb1_lower_sin * platform_twist_wx),
      t101 = t95 - limbs.lower_omega_y[0] * t99,
      t31 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t104 = limb1_lower_sin * t31,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t31 - limb1_lower_sin * platform_turn_xy,
      t103 = t94 - limb1_U2_constraint_mn_couple_z * t101,
      limb1_U2_opening_mn = t104 + limb1_lower_cos * platform_turn_xy,
      t109 = t99 * (limb1_U2_opening_mn * t99 + limb1_U2_constraint_mn_couple_z * t90),
      limb1_U2_opening_bias_mn = t103 - (t109 - t85 * (limb1_U2_constraint_mn_couple_x * t90 - limb1_U2_opening_mn *
          t85)),
      minus_limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t3[0],
      t116 = limb1_U2_opening_bias_mn + limbs.t10[0] * minus_limb1_U_factor_1_by_3,
      limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      t118 = t116 + limb1_U_factor_0_by_3 * limbs.t11[0], /* limb5_S */
      t27 = limbs.upper_position_x[0] * limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t27,
      t28 = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3, t39 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z + limbs.S_arm_x[0] *
          minus_limb1_U_factor_1_by_3,
      t37 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    /* limb5_S: pivots; rates that follow; accelerations */
    const REAL minus_limb5_S_pivot_wz = t28 + t37;
    REAL checked0 = minus_limb5_S_pivot_wz;
    const REAL t38 = 1.0 / minus_limb5_S_pivot_wz, limb5_S_joint_acc_still_wz = t38 * t118,
      limb5_S_null_space_wz_by_limb5_S_wy = t38 * (t39 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3);
    NEXT_LIMB(2, forward_dynamics_reactions, 0, stride, q, v, u, sine, cosine, platform_twist_wy, platform_twist_wz,
        platform_twist_wx, &limbs);
    /* limb5_S: free motion; accelerations; momentum rate, eq. (35) */
    const REAL t44 = k13 * platform_turn_zz, t63 = k14 + platform_turn_zz * t44 - limbs.t7[2],
      t46 = platform_turn_xz * t44 + limbs.t4[2];
    NEXT_LIMB(1, forward_dynamics_reactions, 0, stride, q, v, u, sine, cosine, platform_twist_wx, platform_twist_wz,
        platform_twist_wy, &limbs);
    NEXT_LIMB(3, forward_dynamics_reactions, 0, stride, q, v, u, sine, cosine, platform_twist_wx, platform_twist_wz,
        platform_twist_wy, &limbs);
    const REAL limb5_S_handed_inertia_wz = t63 - limbs.t7[1] - limbs.t7[3] - limbs.t7[0],
      limb5_S_handed_inertia_wz_by_limb5_S_wx = limbs.t4[0] + (limbs.t5[3] + (t46 + limbs.t5[1])),
      t119 = limb5_S_handed_inertia_wz * limb5_S_joint_acc_still_wz,
      t66 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz,
      minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      platform_U_still_yz = limb5_S_v_wy * limb5_S_v_wz, t120 = k13 * platform_U_still_yz,
      platform_rate_mx = t120 - minus_platform_moment_x, t121 = platform_turn_zx * platform_rate_mx,
      platform_moment_y = gravity_z_platform_mz * platform_turn_zx,
      platform_U_still_xz = limb5_S_v_wx * limb5_S_v_wz, t122 = k13 * platform_U_still_xz,
      minus_platform_rate_my = t122 - platform_moment_y,
      t127 = t121 - platform_turn_zy * minus_platform_rate_my + limbs.t16[2] - limbs.t16[1] - limbs.t16[3],
      limb5_S_handed_force_wz = t119 + (limbs.t13[0] + (limbs.t13[2] + (limbs.t16[0] + t127) - limbs.t13[1] -
          limbs.t13[3])),
      t133 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_force_wz, t17 = k13 * platform_turn_yz,
      t60 = limbs.t5[0] + (limbs.t4[3] + (limbs.t4[1] - (platform_turn_zz * t17 - limbs.t5[2]))),
      t134 = t60 * limb5_S_joint_acc_still_wz, t69 = limb5_S_null_space_wz_by_limb5_S_wy * (t60 + (t60 - t66)),
      t147 = platform_turn_xx * platform_rate_mx,
      t138 = platform_turn_yx * platform_rate_mx - platform_turn_yy * minus_platform_rate_my + limbs.t18[2],
      t142 = limbs.U_handed_force_0[3] + (limbs.U_handed_force_0[1] + (limbs.t18[0] + t138 - limbs.t17[2])),
      minus_limb5_S_reduced_force_wy = t133 - (t134 - (t142 - limbs.t17[0])),
      t152 = limbs.U_handed_force_0[2] + (limbs.t18[3] + (t147 - platform_turn_xy * minus_platform_rate_my +
          limbs.t18[1])),
      t155 = limbs.U_handed_force_0[0] + (t152 - limbs.t17[1] - limbs.t17[3]),
      t54 = limbs.U_mass_matrix_0_by_U_0[3] + (limbs.U_mass_matrix_0_by_U_0[1] + (k14 + platform_turn_yz * t17 +
          limbs.t6[2])),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = limbs.t6[0] + t54 - t69;
    REAL checked1 = limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t70 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t22 = platform_turn_xz * t17 - limbs.t2[2] - limbs.t2[1] - limbs.t2[3] - limbs.t2[0],
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t22 + limb5_S_null_space_wz_by_limb5_S_wy *
          limb5_S_handed_inertia_wz_by_limb5_S_wx;
    /* platform: accelerations; pivots; balance, eqs. (40)-(47) */
    const REAL t156 = limb5_S_handed_inertia_wz_by_limb5_S_wx * limb5_S_joint_acc_still_wz + t155,
      t71 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t70, t164 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t71,
      t166 = t70 * minus_limb5_S_reduced_force_wy, t157 = t71 * minus_limb5_S_reduced_force_wy - t156,
      t162 = limbs.U_mass_matrix_0_by_U_0[2] + (k14 + platform_turn_xz * (k13 * platform_turn_xz)) + limbs.t6[1],
      pivot_1 = limbs.U_mass_matrix_0_by_U_0[0] + (limbs.t6[3] + t162) - t164;
    REAL checked2 = pivot_1;
    const REAL limb5_S_joint_acc_wx = t157 / pivot_1, minus_limb5_S_joint_acc_wy = t71 * limb5_S_joint_acc_wx +
        t166,
      limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz - limb5_S_null_space_wz_by_limb5_S_wy *
          minus_limb5_S_joint_acc_wy,
      t172 = platform_turn_zy * limb5_S_joint_acc_wz,
      platform_alpha_y = t172 - (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy *
          limb5_S_joint_acc_wx);
    WRITE(a, 13, platform_alpha_y);
    const REAL t191 = platform_turn_zy * (platform_moment_y - (t122 - k14 * platform_alpha_y)),
      platform_rate_fx = platform_mz * (platform_U_still_xz + platform_alpha_y),
      t168 = platform_turn_zx * limb5_S_joint_acc_wz,
      platform_alpha_x = t168 - (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx *
          limb5_S_joint_acc_wx);
    WRITE(a, 12, platform_alpha_x);
    const REAL t195 = t191 - platform_turn_zx * (minus_platform_moment_x - (t120 + k14 * platform_alpha_x)),
      platform_rate_fy = platform_mz * (platform_U_still_yz - platform_alpha_x),
      t176 = platform_turn_zz * limb5_S_joint_acc_wz,
      platform_alpha_z = t176 - (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz *
          limb5_S_joint_acc_wx);
    WRITE(a, 14, platform_alpha_z);
    const REAL t196 = platform_turn_zz * (platform_Izz * platform_alpha_z) + t195,
      t182 = limb1_lower_cos * (limb1_U2_constraint_mn_couple_x - limbs.S_arm_y[0] * limb1_U_factor_0_by_3),
          /* limb1 */
      platform_joint_force_mz_by_limb1_U2_mn = limb1_U_0_cos * (t182 - limb1_lower_sin * (limbs.S_arm_x[0] *
          limb1_U_factor_0_by_3)) + t37;
    REAL checked3 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t187 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn;
    FIRST_LIMB(0, forward_dynamics_reactions, 1, stride, v, u, a, sine, cosine, limb5_S_joint_acc_wz,
        minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx, t187, &limbs);
    const REAL t197 = limbs.t20[0] + t196;
    NEXT_LIMB(1, forward_dynamics_reactions, 1, stride, v, u, a, sine, cosine, limb5_S_joint_acc_wz,
        limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_wy, t187, &limbs);
    const REAL t198 = limbs.t20[1] - t197;
    NEXT_LIMB(2, forward_dynamics_reactions, 1, stride, v, u, a, sine, cosine, limb5_S_joint_acc_wz,
        minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx, t187, &limbs);
    NEXT_LIMB(3, forward_dynamics_reactions, 1, stride, v, u, a, sine, cosine, limb5_S_joint_acc_wz,
        limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_wy, t187, &limbs);
    /* limb1: balance, eqs. (40)-(47) */
    const REAL minus_limb1_U2_part_mn = t187 * (limbs.t20[2] - t198 - limbs.t20[3]),
      limb1_U2_multiplier_mn = limbs.t21[3] - (limbs.t21[2] + (limbs.t21[0] + minus_limb1_U2_part_mn -
          limbs.t21[1]));
    /* limb1: reactions, eq. (32); balance, eqs. (40)-(47) */
    const REAL minus_limb1_U2_joint_reaction_mx = limb1_U2_constraint_mn_couple_x * limb1_U2_multiplier_mn,
      minus_limb1_U2_joint_reaction_mz = limb1_U2_constraint_mn_couple_z * limb1_U2_multiplier_mn,
      minus_limb1_upper_sent_mx = minus_limb1_U2_joint_reaction_mx + limbs.minus_upper_rate_mx[0],
      minus_limb1_lower_sent_mx = limbs.minus_upper_rate_mx[0] + minus_limb1_upper_sent_mx,
      minus_limb1_upper_sent_mz = minus_limb1_U2_joint_reaction_mz + limbs.minus_upper_rate_mz_2[0],
      t203 = minus_limb1_U2_part_mn - (limbs.t21[1] + (limbs.t21[3] - limbs.t21[2]) - limbs.t21[0]),
      minus_limb1_U2_multiplier_fz = -(limbs.S_multiplier_fz[0] + limb1_U_factor_0_by_3 * t203);
    FIRST_LIMB(0, forward_dynamics_reactions, 2, stride, u, reactions, sine, cosine, minus_limb1_U_factor_1_by_3 *
        t203 - limbs.S_multiplier_fy[0], minus_limb1_U2_multiplier_fz, minus_limb1_lower_sent_mx,
        minus_limb1_upper_sent_mx, minus_limb1_upper_sent_mz, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[0]);
    const REAL t213 = limb1_U_0_sin * minus_limb1_U2_joint_reaction_mz,
      t210 = limb1_U_0_cos * minus_limb1_U2_joint_reaction_mz;
    RESULT(checked1, reactions, 17, limbs.S_reaction_mz[0] - (t213 + limbs.signed_lower_rotation_zx[0] *
        minus_limb1_U2_joint_reaction_mx));
    const REAL t212 = t210 - limbs.minus_lower_rotation_yx[0] * minus_limb1_U2_joint_reaction_mx,
      minus_limb1_U2_reaction_mx = limb1_lower_sin * minus_limb1_U2_joint_reaction_mx +
          limbs.signed_S_reaction_my[0];
    checked2 = checked2 + minus_limb1_U2_reaction_mx;
    WRITE(reactions, 15, -minus_limb1_U2_reaction_mx);
    const REAL minus_limb1_U2_reaction_my = limbs.signed_S_reaction_mx[0] + t212;
    checked3 = checked3 + minus_limb1_U2_reaction_my;
    WRITE(reactions, 16, -minus_limb1_U2_reaction_my);
    /* platform: momentum rate, eq. (35) */
    const REAL platform_rate_fy_2 = platform_m_gravity_z * platform_turn_zy + platform_rate_fy;
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t221 = platform_turn_xy * platform_rate_fy_2, t230 = platform_turn_yy * platform_rate_fy_2,
      t238 = platform_turn_zy * platform_rate_fy_2,
      platform_rate_fx_2 = platform_m_gravity_z * platform_turn_zx + platform_rate_fx,
      t224 = t221 + platform_turn_xx * platform_rate_fx_2, t232 = t230 + platform_turn_yx * platform_rate_fx_2,
      t240 = t238 + platform_turn_zx * platform_rate_fx_2, t218 = platform_m_gravity_z * platform_turn_zz,
      minus_platform_rate_fz_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t218,
      t226 = limbs.signed_S_reaction_fy[0] + (platform_turn_xz * minus_platform_rate_fz_2 - t224),
      t234 = limbs.t25[0] + (platform_turn_yz * minus_platform_rate_fz_2 - t232),
      t242 = limbs.t26[0] - (platform_turn_zz * minus_platform_rate_fz_2 - t240);
    NEXT_LIMB(1, forward_dynamics_reactions, 2, stride, u, reactions, sine, cosine, limbs.S_multiplier_fy[1],
        limbs.S_multiplier_fz[1], 2.0 * limbs.minus_upper_rate_mx[1], limbs.minus_upper_rate_mx[1],
        limbs.minus_upper_rate_mz_2[1], &limbs);
    WRITE(reactions, 34, limbs.signed_S_reaction_my[1]);
    checked0 = checked0 + limbs.signed_S_reaction_my[1];
    WRITE(reactions, 33, limbs.signed_S_reaction_mx[1]);
    checked1 = checked1 + limbs.signed_S_reaction_mx[1];
    WRITE(reactions, 35, limbs.S_reaction_mz[1]);
    checked2 = checked2 + limbs.S_reaction_mz[1];
    checked3 = checked3 + ALONE(limbs.checked[1]);
    const REAL t227 = limbs.t25[1] - t226, t235 = t234 - limbs.signed_S_reaction_fy[1], t243 = limbs.t26[1] + t242;
    NEXT_LIMB(2, forward_dynamics_reactions, 2, stride, u, reactions, sine, cosine, limbs.S_multiplier_fy[2],
        -limbs.S_multiplier_fz[2], 2.0 * limbs.minus_upper_rate_mx[2], limbs.minus_upper_rate_mx[2],
        limbs.minus_upper_rate_mz_2[2], &limbs);
    checked0 = checked0 + limbs.signed_S_reaction_my[2];
    checked1 = checked1 + limbs.signed_S_reaction_mx[2];
    WRITE(reactions, 53, limbs.S_reaction_mz[2]);
    checked2 = checked2 + limbs.S_reaction_mz[2];
    checked3 = checked3 + ALONE(limbs.checked[2]);
    const REAL t228 = t227 - limbs.signed_S_reaction_fy[2], t236 = limbs.t25[2] + t235, t244 = limbs.t26[2] + t243;
    WRITE(reactions, 51, -limbs.signed_S_reaction_my[2]);
    WRITE(reactions, 52, -limbs.signed_S_reaction_mx[2]);
    NEXT_LIMB(3, forward_dynamics_reactions, 2, stride, u, reactions, sine, cosine, -limbs.S_multiplier_fy[3],
        limbs.S_multiplier_fz[3], 2.0 * limbs.minus_upper_rate_mx[3], limbs.minus_upper_rate_mx[3],
        limbs.minus_upper_rate_mz_2[3], &limbs);
    WRITE(reactions, 70, limbs.signed_S_reaction_my[3]);
    checked0 = checked0 + limbs.signed_S_reaction_my[3];
    WRITE(reactions, 69, limbs.signed_S_reaction_mx[3]);
    checked1 = checked1 + limbs.signed_S_reaction_mx[3];
    WRITE(reactions, 71, limbs.S_reaction_mz[3]);
    checked2 = checked2 + limbs.S_reaction_mz[3];
    checked3 = checked3 + ALONE(limbs.checked[3]);
    RESULT(checked0, reactions, 72, limbs.t25[3] + t228);
    RESULT(checked1, reactions, 73, limbs.signed_S_reaction_fy[3] - t236);
    RESULT(checked2, reactions, 74, limbs.t26[3] + t244);
    WRITE(reactions, 75, CONSTANT(0.0));
    WRITE(reactions, 76, CONSTANT(0.0));
    WRITE(reactions, 77, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-06, 6.62327e-06, 6.62327e-06, 6.62327e-06) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-05) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 0.0007562600000000001) OR
            /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 0.0007551200000000001) OR
            /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.017100000000001e-06),
            /* where limb1_U2.mn cannot balance platform.moment_z */
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
    const LIMB4 t2 = upper_offset_x * (limb_lower_m * upper_offset_x + (-k8)), U_mass_matrix_1_by_U_1 = t2 + k10;
    WRITE4(inertia_, 16, 64, 112, 160, U_mass_matrix_1_by_U_1);
    LIMB4 checked = U_mass_matrix_1_by_U_1;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2), t3 = t2 + k9, t57 = sign1 * lower_cos,
      U_mass_matrix_0_by_U_0 = t57 * (t57 * t3) + k4;
    WRITE4(inertia_, 0, 48, 96, 144, U_mass_matrix_0_by_U_0);
    checked = checked + U_mass_matrix_0_by_U_0;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(signed_lower_omega_x) = U_v_0 * signed_lower_sin;
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3);
    /* each limb: accelerations; balance, eqs. (40)-(47); free motion */
    const LIMB4 signed_lower_alpha_still_y = U_v_1 * OWN(signed_lower_omega_x),
      t8 = upper_offset_x * (2.0 * signed_lower_alpha_still_y), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      t9 = t8 + each_gravity_z * signed_U_0_sin;
    OWN(signed_lower_omega_y) = U_v_0 * t57;
    const LIMB4 lower_U_still_xy = OWN(signed_lower_omega_x) * OWN(signed_lower_omega_y),
      P_v = IN_EACH4(READ, v, 2, 3), t7 = P_v * (2.0 * OWN(signed_lower_omega_y)),
      signed_upper_acc_still_z = t7 - t9, signed_upper_acc_still_z_2 = t8 - t7,
      signed_upper_rate_my = limb_lower_mx * signed_upper_acc_still_z,
      t11 = upper_offset_x * (k8 * signed_lower_alpha_still_y + limb_lower_m * signed_upper_acc_still_z) -
          signed_upper_rate_my,
      t14 = t57 * (each_gravity_z_limb_lower_mx * signed_U_0_sin + k12 * signed_lower_alpha_still_y - t11);
    OWN(signed_lower_alpha_still_x) = U_v_1 * OWN(signed_lower_omega_y);
    const LIMB4 minus_U_0_moment_z = t14 - signed_lower_sin * (k11 * OWN(signed_lower_alpha_still_x));
    WRITE4(load_, 0, 3, 6, 9, minus_U_0_moment_z);
    checked = checked + minus_U_0_moment_z;
    const LIMB4 t25 = OWN(signed_lower_omega_y) * OWN(signed_lower_omega_y), t18 = upper_offset_x *
        lower_U_still_xy,
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_acc_y = each_gravity_z_2 * U_0_cos,
      lower_acc_y = signed_lower_sin * signed_U_0_acc_y, minus_lower_acc_x = t57 * signed_U_0_acc_y,
      t19 = t18 + lower_acc_y, t17 = P_v * (2.0 * U_v_1), upper_acc_still_y = t17 + t19,
      upper_acc_still_y_2 = t18 + t17,
      t24 = limb_lower_mx * (upper_acc_still_y - lower_acc_y) - k9 * lower_U_still_xy,
      minus_lower_moment_z = t24 - upper_offset_x * (limb_lower_m * upper_acc_still_y - limb_lower_mx *
          lower_U_still_xy);
    WRITE4(load_, 1, 4, 7, 10, minus_lower_moment_z);
    checked = checked + minus_lower_moment_z;
    const LIMB4 minus_lower_U_still_xx = t25 + U_v_1 * U_v_1,
      minus_upper_acc_still_x = upper_offset_x * minus_lower_U_still_xx,
      minus_lower_force_x = limb_lower_m * (minus_upper_acc_still_x + minus_lower_acc_x),
      minus_P_generalised_force = IN_EACH4(READ, u, 0, 1) + (minus_lower_force_x - limb_lower_mx *
          minus_lower_U_still_xx);
    WRITE4(load_, 2, 5, 8, 11, minus_P_generalised_force);
    checked = checked + minus_P_generalised_force;
    const LIMB4 base_lever_mx_by_S_fx = param_R * (U_0_cos * t57);
    /* each limb: loop closure; reciprocal wrenches, eq. (10); geometry */
    OWN(t1) = platform_turn_yx * base_lever_mx_by_S_fx;
    OWN(t7) = platform_turn_yy * base_lever_mx_by_S_fx;
    OWN(t13) = platform_turn_yz * base_lever_mx_by_S_fx;
    const LIMB4 signed_base_lever_mz_by_S_fx = param_R * (signed_U_0_sin * t57);
    OWN(t2) = platform_turn_zx * signed_base_lever_mz_by_S_fx;
    OWN(t8) = platform_turn_zy * signed_base_lever_mz_by_S_fx;
    OWN(t14) = platform_turn_zz * signed_base_lever_mz_by_S_fx;
    const LIMB4 S_arm_x = upper_offset_x - param_R * signed_lower_sin, base_lever_mx_by_S_fy = U_0_cos * S_arm_x;
    OWN(t3) = platform_turn_yx * base_lever_mx_by_S_fy;
    OWN(t9) = platform_turn_yy * base_lever_mx_by_S_fy;
    OWN(t15) = platform_turn_yz * base_lever_mx_by_S_fy;
    const LIMB4 signed_base_lever_mz_by_S_fy = signed_U_0_sin * S_arm_x;
    OWN(t4) = platform_turn_zx * signed_base_lever_mz_by_S_fy;
    OWN(t10) = platform_turn_zy * signed_base_lever_mz_by_S_fy;
    OWN(t16) = platform_turn_zz * signed_base_lever_mz_by_S_fy;
    const LIMB4 signed_upper_position_x = signed_lower_sin * upper_offset_x + (-param_R),
      signed_U_0_lever_mz_by_S_fz = t57 * upper_offset_x;
    WRITE4(closure_, 2, 45, 87, 129, -sign1 * signed_U_0_lever_mz_by_S_fz);
    const LIMB4 signed_base_lever_mz_by_S_fz = U_0_cos * signed_upper_position_x;
    OWN(t5) = platform_turn_zx * signed_base_lever_mz_by_S_fz;
    const LIMB4 signed_base_lever_mx_by_S_fz = signed_U_0_sin * signed_upper_position_x;
    OWN(t11) = platform_turn_zy * signed_base_lever_mz_by_S_fz;
    OWN(t17) = platform_turn_zz * signed_base_lever_mz_by_S_fz;
    const LIMB4 t29 = platform_turn_yx * signed_base_lever_mx_by_S_fz;
    OWN(t6) = platform_turn_xx * signed_U_0_lever_mz_by_S_fz + t29;
    const LIMB4 t31 = platform_turn_yy * signed_base_lever_mx_by_S_fz,
      t33 = platform_turn_yz * signed_base_lever_mx_by_S_fz;
    OWN(t12) = platform_turn_xy * signed_U_0_lever_mz_by_S_fz + t31;
    OWN(t18) = platform_turn_xz * signed_U_0_lever_mz_by_S_fz + t33;
    const LIMB4 t58 = sign3 * platform_twist_wz, t35 = signed_U_0_sin * t58,
      t40 = signed_U_0_sin * platform_twist_wy - U_0_cos * t58, t43 = t57 * t40;
    OWN(t20) = signed_lower_sin * t40 + t57 * platform_twist_wx;
    const LIMB4 t59 = sign1 * OWN(t20), t46 = S_arm_x * t59;
    OWN(t21) = t43 - signed_lower_sin * platform_twist_wx;
    const LIMB4 signed_S_arm_y = param_R * lower_cos, t47 = t46 - signed_S_arm_y * OWN(t21), t48 = t59 * t47,
      t52 = OWN(t21) * t47;
    OWN(t19) = U_0_cos * platform_twist_wy + t35;
    const LIMB4 t36 = S_arm_x * OWN(t19), t50 = signed_S_arm_y * OWN(t19), t55 = t59 * t50,
      t53 = OWN(t19) * t50 - t52, S_opening_bias_fx = OWN(t19) * t36 + t48 - minus_upper_acc_still_x;
    WRITE4(curvature_, 0, 4, 7, 10, S_opening_bias_fx);
    checked = checked + S_opening_bias_fx;
    const LIMB4 signed_S_opening_bias_fz = signed_upper_acc_still_z_2 + (OWN(t21) * t36 + t55);
    WRITE4(curvature_, 2, 6, 9, 12, sign1 * signed_S_opening_bias_fz);
    checked = checked + signed_S_opening_bias_fz;
    const LIMB4 S_opening_bias_fy = upper_acc_still_y_2 - sign1 * t53;
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
      minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - k13 * (limb5_S_v_wy * limb5_S_v_wz);
    WRITE(load_, 12, minus_platform_rate_mx);
    REAL checked0 = minus_platform_rate_mx;
    const REAL t16 = limb5_S_q_qx * t10, t28 = limb5_S_q_qw * t10, t18 = limb5_S_q_qw * t17,
      t27 = limb5_S_q_qx * t17, platform_turn_zx = t16 - t18, platform_turn_xz = t16 + t18,
      limb5_S_v_wx = READ(v, 12),
      minus_platform_rate_my = k13 * (limb5_S_v_wx * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zx;
    WRITE(load_, 13, minus_platform_rate_my);
    REAL checked1 = minus_platform_rate_my;
    const REAL platform_turn_yx = t27 + t28, platform_turn_xy = t27 - t28,
      t62 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      platform_twist_wy = t62 + limb5_S_v_wz * platform_turn_yz,
      t71 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t71,
      t66 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      platform_twist_wx = t66 + limb5_S_v_wz * platform_turn_xz;
    FIRST_LIMB(0, forward_dynamics_dense, 0, stride, q, v, u, inertia_, load_, closure_, curvature_, sine, cosine,
        platform_turn_yx, platform_turn_zx, platform_turn_xx, platform_turn_yy, platform_turn_zy, platform_turn_xy,
        platform_turn_yz, platform_turn_zz, platform_turn_xz, platform_twist_wy, platform_twist_wz,
        platform_twist_wx, &limbs);
    REAL checked2 = ALONE(limbs.checked[0]);
    /* mechanism: loop closure */
    const REAL closure_158 = limbs.t6[0] - limbs.t5[0];
    WRITE(closure_, 158, closure_158);
    REAL checked3 = closure_158;
    RESULT(checked0, closure_, 171, limbs.t12[0] - limbs.t11[0]);
    RESULT(checked1, closure_, 184, limbs.t18[0] - limbs.t17[0]);
    NEXT_LIMB(1, forward_dynamics_dense, 0, stride, q, v, u, inertia_, load_, closure_, curvature_, sine, cosine,
        platform_turn_xx, platform_turn_zx, platform_turn_yx, platform_turn_xy, platform_turn_zy, platform_turn_yy,
        platform_turn_xz, platform_turn_zz, platform_turn_yz, platform_twist_wx, platform_twist_wz,
        platform_twist_wy, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[1]);
    RESULT(checked3, closure_, 160, limbs.t2[1] - limbs.t1[1]);
    RESULT(checked0, closure_, 161, limbs.t4[1] - limbs.t3[1]);
    RESULT(checked1, closure_, 162, limbs.t6[1] + limbs.t5[1]);
    RESULT(checked2, closure_, 173, limbs.t8[1] - limbs.t7[1]);
    RESULT(checked3, closure_, 174, limbs.t10[1] - limbs.t9[1]);
    RESULT(checked0, closure_, 175, limbs.t12[1] + limbs.t11[1]);
    RESULT(checked1, closure_, 186, limbs.t14[1] - limbs.t13[1]);
    RESULT(checked2, closure_, 187, limbs.t16[1] - limbs.t15[1]);
    RESULT(checked3, closure_, 188, limbs.t18[1] + limbs.t17[1]);
    NEXT_LIMB(2, forward_dynamics_dense, 0, stride, q, v, u, inertia_, load_, closure_, curvature_, sine, cosine,
        platform_turn_yx, platform_turn_zx, platform_turn_xx, platform_turn_yy, platform_turn_zy, platform_turn_xy,
        platform_turn_yz, platform_turn_zz, platform_turn_xz, platform_twist_wy, platform_twist_wz,
        platform_twist_wx, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, forward_dynamics_dense, 0, stride, q, v, u, inertia_, load_, closure_, curvature_, sine, cosine,
        platform_turn_xx, platform_turn_zx, platform_turn_yx, platform_turn_xy, platform_turn_zy, platform_turn_yy,
        platform_turn_xz, platform_turn_zz, platform_turn_yz, platform_twist_wx, platform_twist_wz,
        platform_twist_wy, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
    RESULT(checked2, closure_, 165, limbs.t5[2] - limbs.t6[2]);
    RESULT(checked3, closure_, 166, limbs.t2[3] - limbs.t1[3]);
    RESULT(checked0, closure_, 167, limbs.t4[3] - limbs.t3[3]);
    RESULT(checked1, closure_, 178, limbs.t11[2] - limbs.t12[2]);
    RESULT(checked2, closure_, 179, limbs.t8[3] - limbs.t7[3]);
    RESULT(checked3, closure_, 180, limbs.t10[3] - limbs.t9[3]);
    RESULT(checked0, closure_, 191, limbs.t17[2] - limbs.t18[2]);
    RESULT(checked1, closure_, 192, limbs.t14[3] - limbs.t13[3]);
    RESULT(checked2, closure_, 193, limbs.t16[3] - limbs.t15[3]);
    /* limb1: accelerations */
    const REAL limb1_U_v_1 = READ(v, 1);
    /* limb1: loop closure; geometry; reciprocal wrenches, eq. (10) */
    const REAL t72 = limb1_U_v_1 - limbs.t19[0], t73 = limbs.signed_lower_omega_y[0] * t72,
      t74 = limbs.signed_lower_omega_y[0] - limbs.t20[0], limb1_U_0_sin = SINES(sine, 0),
      limb1_U_0_cos = SINES(cosine, 0), t77 = limbs.signed_lower_alpha_still_x[0] - (t73 - limb1_U_v_1 * t74),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t78 = limb1_U2_constraint_mn_couple_x * t77, t79 = limbs.signed_lower_omega_x[0] * t74,
      t80 = limbs.signed_lower_omega_x[0] + limbs.t21[0], t82 = t79 - limbs.signed_lower_omega_y[0] * t80,
      t25 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, limb1_lower_cos = SINES(cosine, 1),
      limb1_lower_sin = SINES(sine, 1), t85 = limb1_lower_sin * t25,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t25 - limb1_lower_sin * platform_turn_xy;
    WRITE(closure_, 16, limb1_U2_constraint_mn_couple_z);
    const REAL t84 = t78 - limb1_U2_constraint_mn_couple_z * t82,
      limb1_U2_opening_mn = t85 + limb1_lower_cos * platform_turn_xy,
      t90 = t80 * (limb1_U2_opening_mn * t80 + limb1_U2_constraint_mn_couple_z * t74);
    RESULT(checked3, curvature_, 3, t84 - (t90 - t72 * (limb1_U2_constraint_mn_couple_x * t74 - limb1_U2_opening_mn
        * t72)));
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
    WRITE(inertia_, 192, CONSTANT(k14));
    WRITE(inertia_, 208, CONSTANT(k14));
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
    static const double rate_scale[15] = {1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0,
        0.662327, 1.0, 1.0, 1.0};
    static const double row_scale[13] = {1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.0,
        1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322,
        1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322};
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
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2), t60 = sign1 * signed_lower_sin,
      U_v_0 = IN_EACH4(READ, v, 0, 3), lower_omega_x = U_v_0 * t60, lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      lower_omega_y = U_v_0 * lower_cos;
    /* each limb: accelerations; momentum rate, eq. (35); geometry */
    const LIMB4 lower_U_still_xy = lower_omega_x * lower_omega_y, U_v_1 = IN_EACH4(READ, v, 1, 3),
      minus_lower_alpha_still_y = U_v_1 * lower_omega_x, U_a_1 = IN_EACH4(READ, a, 1, 3),
      lower_U_yx = U_a_1 + lower_U_still_xy, t39 = k20 * lower_U_still_xy,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase, t3 = upper_offset_x * lower_U_yx,
      lower_rate_fy = limb_lower_mx * lower_U_yx, U_0_acc_y = each_gravity_z * U_0_cos,
      minus_lower_acc_y = t60 * U_0_acc_y, t4 = t3 - minus_lower_acc_y,
      lower_rate_fy_2 = lower_rate_fy - limb_lower_m * minus_lower_acc_y, lower_acc_x = lower_cos * U_0_acc_y,
      P_v = IN_EACH4(READ, v, 2, 3), upper_acc_y = P_v * (2.0 * U_v_1) + t4,
      multipliers_1 = OF4(READ(multipliers_, 1), READ(multipliers_, 5), READ(multipliers_, 8),
          READ(multipliers_, 11));
    /* each limb: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    OWN(upper_sent_fy) = limb_lower_m * upper_acc_y - lower_rate_fy - multipliers_1;
    WRITE4(sized_, 7, 25, 43, 61, OWN(upper_sent_fy));
    const LIMB4 lower_sent_fy = lower_rate_fy_2 + OWN(upper_sent_fy),
      minus_upper_rate_mz = limb_lower_mx * upper_acc_y, t5 = lower_cos * lower_sent_fy, t16 = t60 * lower_sent_fy,
      upper_acc_x = IN_EACH4(READ, a, 2, 3) + (lower_acc_x - upper_offset_x * (lower_omega_y * lower_omega_y + U_v_1
          * U_v_1)),
      multipliers_0 = OF4(READ(multipliers_, 0), READ(multipliers_, 4), READ(multipliers_, 7),
          READ(multipliers_, 10)),
      lower_sent_fx = limb_lower_m * (lower_acc_x + upper_acc_x) - multipliers_0,
      lower_joint_sent_fy = t5 + t60 * lower_sent_fx;
    WRITE4(reactions, 0, 19, 36, 55, lower_joint_sent_fy);
    WRITE4(sized_, 1, 19, 37, 55, lower_joint_sent_fy);
    LIMB4 checked = lower_joint_sent_fy;
    const LIMB4 lower_joint_sent_fx = lower_cos * lower_sent_fx - t16;
    WRITE4(sized_, 0, 18, 36, 54, lower_joint_sent_fx);
    const LIMB4 U_a_0 = IN_EACH4(READ, a, 0, 3), t18 = signed_U_0_sin * lower_joint_sent_fx,
      t20 = U_0_cos * lower_joint_sent_fx, minus_lower_alpha_y = minus_lower_alpha_still_y - U_a_0 * lower_cos,
      lower_U_zx = minus_lower_alpha_still_y + minus_lower_alpha_y,
      t27 = k17 * minus_lower_alpha_y + k18 * minus_lower_alpha_still_y, t13 = upper_offset_x * lower_U_zx,
      lower_rate_fz = limb_lower_mx * lower_U_zx,
      upper_acc_z = t13 + each_gravity_z * signed_U_0_sin - P_v * (2.0 * lower_omega_y),
      lower_alpha_still_x = U_v_1 * lower_omega_y,
      upper_sent_fz = limb_lower_m * upper_acc_z - lower_rate_fz - OF4(READ(multipliers_, 2), READ(multipliers_, 6),
          READ(multipliers_, 9), READ(multipliers_, 12));
    WRITE4(sized_, 8, 26, 44, 62, upper_sent_fz);
    OWN(minus_upper_rate_my_2) = (-limb_lower_mx) * upper_acc_z + t27;
    const LIMB4 lower_sent_fz = lower_rate_fz - each_limb_lower_m_gravity_z * signed_U_0_sin + upper_sent_fz;
    WRITE4(sized_, 2, 20, 38, 56, lower_sent_fz);
    OWN(U_0_joint_sent_fx) = U_0_cos * lower_sent_fz - t18;
    WRITE4(reactions, 1, 18, 37, 54, OWN(U_0_joint_sent_fx));
    OWN(signed_U_0_joint_sent_fy) = signed_U_0_sin * lower_sent_fz + t20;
    WRITE4(reactions, 2, 20, 38, 56, sign2 * OWN(signed_U_0_joint_sent_fy));
    OWN(upper_rate_mx) = k15 * (lower_alpha_still_x + U_a_0 * t60) - k16 * lower_alpha_still_x;
    const LIMB4 lower_rotation_yy = signed_U_0_sin * t60;
    OWN(t6) = lower_rotation_yy * OWN(minus_upper_rate_my_2);
    const LIMB4 t24 = lower_rotation_yy * multipliers_1;
    OWN(minus_lower_rotation_yx) = signed_U_0_sin * lower_cos;
    OWN(t3) = OWN(minus_lower_rotation_yx) * multipliers_0 - t24;
    const LIMB4 t29 = OWN(minus_upper_rate_my_2) + upper_offset_x * upper_sent_fz;
    OWN(minus_lower_sent_my) = t29 - (each_gravity_z_limb_lower_mx * signed_U_0_sin - t27);
    /* each limb: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    const LIMB4 P_reactions_fy = lower_rotation_yy * OWN(upper_sent_fy) + U_0_cos * upper_sent_fz;
    WRITE4(reactions, 7, 24, 43, 60, P_reactions_fy);
    OWN(signed_lower_rotation_zx) = U_0_cos * lower_cos;
    OWN(signed_upper_position_z) = upper_offset_x * OWN(signed_lower_rotation_zx);
    const LIMB4 t35 = OWN(signed_upper_position_z) * P_reactions_fy, t33 = signed_U_0_sin * upper_sent_fz,
      signed_lower_rotation_zy = U_0_cos * t60;
    OWN(t12) = signed_lower_rotation_zy * OWN(minus_upper_rate_my_2);
    const LIMB4 signed_P_reactions_fz = signed_lower_rotation_zy * OWN(upper_sent_fy) - t33;
    WRITE4(reactions, 8, 26, 44, 62, -sign2 * signed_P_reactions_fz);
    const LIMB4 P_reactions_fx = lower_cos * OWN(upper_sent_fy);
    WRITE4(reactions, 6, 25, 42, 61, P_reactions_fx);
    const LIMB4 t36 = OWN(signed_upper_position_z) * P_reactions_fx;
    OWN(minus_upper_position_y) = upper_offset_x * OWN(minus_lower_rotation_yx);
    OWN(upper_position_x) = t60 * upper_offset_x + each_param_R;
    const LIMB4 t50 = OWN(upper_position_x) * P_reactions_fy;
    OWN(t5) = t36 + OWN(upper_position_x) * signed_P_reactions_fz;
    OWN(t4) = t35 - OWN(minus_upper_position_y) * signed_P_reactions_fz;
    OWN(t14) = t50 + OWN(minus_upper_position_y) * P_reactions_fx;
    OWN(minus_upper_rate_mz_2) = minus_upper_rate_mz - (k19 * U_a_1 + t39);
    const LIMB4 t61 = sign3 * OF4(READ(multipliers_, 0), READ(multipliers_, 5), READ(multipliers_, 8),
        READ(multipliers_, 11));
    OWN(t8) = t60 * t61 + lower_cos * IN_EACH4(READ, multipliers_, 1, 3);
    OWN(t15) = OWN(signed_lower_rotation_zx) * multipliers_0 - signed_lower_rotation_zy * multipliers_1;
    /* each limb: results */
    const LIMB4 t45 = limb_upper_phase * OWN(minus_lower_rotation_yx), t55 = lower_rotation_yy * t45,
      t46 = OWN(minus_lower_rotation_yx) * t45, t43 = each_limb_upper_phase * signed_lower_sin,
      t47 = t60 * t43 - t46, t56 = lower_cos * t43 + t55, t48 = limb_upper_phase * OWN(signed_lower_rotation_zx);
    OWN(t17) = upper_sent_fz * (t56 + signed_lower_rotation_zy * t48);
    OWN(t11) = OWN(signed_lower_rotation_zx) * t48 - t47;
    OWN(t19) = OWN(minus_upper_rate_my_2) + upper_sent_fz * OWN(t11);
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
    const LIMB4 P_reactions_mx = t16 * upper_rate_mx - lower_cos * OWN(minus_upper_rate_my_2) - OWN(t4);
    WRITE4(reactions, 9, 28, 45, 64, P_reactions_mx);
    LIMB4 checked = OWN(checked) + P_reactions_mx;
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
    const LIMB4 signed_P_reactions_mz = OWN(t13) - IN_EACH4(SINES, sine, 0, 2) * minus_upper_rate_mz_2 + OWN(t14);
    WRITE4(reactions, 11, 29, 47, 65, sign1 * signed_P_reactions_mz);
    checked = checked + signed_P_reactions_mz;
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
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 0, stride, q, v, a, multipliers_, reactions, sized_, sine,
        cosine, platform_turn_yy, platform_turn_zy, &limbs);
    WRITE(reactions, 12, -limbs.t8[0]);
    /* limb1: geometry; reactions, eq. (32); balance, eqs. (40)-(47) */
    const REAL limb1_U_0_cos = SINES(cosine, 0), t20 = limb1_U_0_cos * multipliers_2, t21 = t20 - limbs.t3[0];
    WRITE(reactions, 13, -t21);
    const REAL limb1_U_0_sin = SINES(sine, 0), t23 = limbs.signed_upper_position_z[0] * t21,
      t86 = -(limbs.upper_position_x[0] * t21), t22 = limb1_U_0_sin * multipliers_2,
      multipliers_3 = READ(multipliers_, 3);
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 1, stride, reactions, sine, cosine, limbs.t2[0],
        multipliers_3, platform_turn_yy, platform_turn_zy, t22, &limbs);
    const REAL limb1_lower_sin = SINES(sine, 1);
    RESULT(checked1, reactions, 15, limbs.t16[0] + t23 - limb1_lower_sin * limbs.minus_U2_joint_reaction_mx[0]);
    const REAL limb1_upper_sent_mx = limbs.upper_rate_mx[0] - limbs.minus_U2_joint_reaction_mx[0],
      limb1_lower_sent_mx = limbs.upper_rate_mx[0] + limb1_upper_sent_mx, t16 = limbs.t9[0] - limbs.t10[0];
    /* limb5_S: geometry; results; accelerations */
    const REAL t18 = limb5_S_q_qx * t17, t38 = limb5_S_q_qw * t17, t19 = limb5_S_q_qw * t12,
      t37 = limb5_S_q_qx * t12, platform_turn_xy = t18 - t19;
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 2, stride, reactions, sine, cosine, limb1_lower_sent_mx,
        limb1_upper_sent_mx, t16, platform_turn_xy, &limbs);
    const REAL platform_turn_yx = t18 + t19;
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 3, stride, limbs.U2_constraint_mn_couple_z[0], multipliers_3,
        limbs.t8[0], t86, &limbs);
    RESULT(checked2, sized_, 3, per_length * limbs.lower_joint_sent_mx[0]);
    RESULT(checked3, sized_, 4, per_length * limbs.lower_joint_sent_my[0]);
    RESULT(checked0, sized_, 9, per_length * limbs.t18[0]);
    FIRST_LIMB(0, forward_dynamics_reactions_wrenches, 4, stride, reactions, sine, cosine,
        limbs.minus_upper_sent_mz[0], &limbs);
    checked1 = checked1 + ALONE(limbs.checked[0]);
    const REAL t27 = limb1_U_0_cos * limbs.minus_U2_joint_reaction_mz[0]; /* limb1 */
    RESULT(checked2, reactions, 16, limbs.minus_lower_rotation_yx[0] * limbs.minus_U2_joint_reaction_mx[0] - t27 +
        limbs.S_reactions_my[0]);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 0, stride, q, v, a, multipliers_, reactions, sized_, sine,
        cosine, multipliers_6, multipliers_6, &limbs);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 1, stride, reactions, sine, cosine, limbs.t3[1],
        limbs.signed_upper_position_z[1], limbs.t8[1], limbs.t8[1], limbs.t2[1], &limbs);
    RESULT(checked3, reactions, 34, limbs.minus_U2_joint_reaction_mx[1] + limbs.t16[1]);
    WRITE(reactions, 30, -limbs.U2_constraint_mn_couple_x[1]);
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 0, stride, q, v, a, multipliers_, reactions, sized_, sine,
        cosine, multipliers_9, multipliers_9, &limbs);
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 1, stride, reactions, sine, cosine, limbs.t3[2],
        limbs.signed_upper_position_z[2], limbs.t8[2], limbs.t8[2], limbs.t2[2], &limbs);
    RESULT(checked0, reactions, 51, limbs.t16[2] + limbs.minus_U2_joint_reaction_mx[2]);
    WRITE(reactions, 49, -limbs.U2_constraint_mn_couple_x[2]);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 0, stride, q, v, a, multipliers_, reactions, sized_, sine,
        cosine, multipliers_12, multipliers_12, &limbs);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 1, stride, reactions, sine, cosine, limbs.t3[3],
        limbs.signed_upper_position_z[3], limbs.t8[3], limbs.t8[3], limbs.t2[3], &limbs);
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
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 2, stride, reactions, sine, cosine, 2.0 *
        limbs.upper_rate_mx[2], limbs.upper_rate_mx[2], multipliers_8, multipliers_7, &limbs);
    WRITE(reactions, 48, limbs.U2_constraint_mn_couple_z[2]);
    const REAL t54 = t53 - limbs.U2_constraint_mn_couple_z[2];
    RESULT(checked2, sized_, 39, per_length * limbs.lower_joint_sent_mx[2]);
    RESULT(checked3, sized_, 40, per_length * limbs.lower_joint_sent_my[2]);
    RESULT(checked0, sized_, 45, per_length * limbs.t18[2]);
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 4, stride, reactions, sine, cosine,
        limbs.minus_upper_rate_mz_2[2], &limbs);
    checked1 = checked1 + ALONE(limbs.checked[2]);
    const REAL platform_joint_sent_fx = t54 + (limbs.t1[3] - limbs.t9[3]);
    WRITE(reactions, 72, platform_joint_sent_fx);
    WRITE(sized_, 72, platform_joint_sent_fx);
    checked2 = checked2 + platform_joint_sent_fx;
    const REAL limb1_lower_cos = SINES(cosine, 1),
      t63 = limb1_lower_cos * multipliers_0 - limb1_lower_sin * multipliers_1,
      t66 = t60 + (t20 - limb1_U_0_sin * t63), t77 = t74 + (t22 + limb1_U_0_cos * t63);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 2, stride, reactions, sine, cosine, 2.0 *
        limbs.upper_rate_mx[1], limbs.upper_rate_mx[1], multipliers_5, multipliers_4, &limbs);
    WRITE(reactions, 31, limbs.U2_constraint_mn_couple_z[1]);
    const REAL t67 = t66 - limbs.U2_constraint_mn_couple_z[1];
    RESULT(checked3, sized_, 21, per_length * limbs.lower_joint_sent_mx[1]);
    RESULT(checked0, sized_, 22, per_length * limbs.lower_joint_sent_my[1]);
    RESULT(checked1, sized_, 27, per_length * limbs.t18[1]);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 4, stride, reactions, sine, cosine,
        limbs.minus_upper_rate_mz_2[1], &limbs);
    checked2 = checked2 + ALONE(limbs.checked[1]);
    const REAL t85 = -limbs.U2_constraint_mn_couple_z[1], t69 = t67 + (limbs.t1[2] - limbs.t9[2]);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 2, stride, reactions, sine, cosine, 2.0 *
        limbs.upper_rate_mx[3], limbs.upper_rate_mx[3], multipliers_11, multipliers_10, &limbs);
    WRITE(reactions, 67, limbs.U2_constraint_mn_couple_z[3]);
    const REAL platform_joint_sent_fy = t69 - limbs.U2_constraint_mn_couple_z[3];
    WRITE(reactions, 73, platform_joint_sent_fy);
    WRITE(sized_, 73, platform_joint_sent_fy);
    checked3 = checked3 + platform_joint_sent_fy;
    RESULT(checked0, sized_, 57, per_length * limbs.lower_joint_sent_mx[3]);
    RESULT(checked1, sized_, 58, per_length * limbs.lower_joint_sent_my[3]);
    RESULT(checked2, sized_, 63, per_length * limbs.t18[3]);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 4, stride, reactions, sine, cosine,
        limbs.minus_upper_rate_mz_2[3], &limbs);
    checked3 = checked3 + ALONE(limbs.checked[3]);
    const REAL platform_joint_sent_fz = t77 - (limbs.t2[1] + limbs.t10[1]) + (limbs.t2[2] + limbs.t10[2]) -
        (limbs.t2[3] + limbs.t10[3]);
    WRITE(reactions, 74, platform_joint_sent_fz);
    WRITE(sized_, 74, platform_joint_sent_fz);
    checked0 = checked0 + platform_joint_sent_fz;
    const REAL t34 = limb1_U_0_sin * limbs.minus_U2_joint_reaction_mz[0], /* limb1 */
      minus_limb1_U2_reactions_mz = limbs.signed_S_reactions_mz[0] + (limbs.signed_lower_rotation_zx[0] *
          limbs.minus_U2_joint_reaction_mx[0] + t34);
    checked1 = checked1 + minus_limb1_U2_reactions_mz;
    WRITE(reactions, 17, -minus_limb1_U2_reactions_mz);
    /* mechanism: results */
    const REAL minus_sized_15 = per_length * limbs.minus_U2_joint_reaction_mx[0];
    checked2 = checked2 + minus_sized_15;
    WRITE(sized_, 15, -minus_sized_15);
    const REAL minus_sized_10 = per_length * limbs.t19[0];
    checked3 = checked3 + minus_sized_10;
    WRITE(sized_, 10, -minus_sized_10);
    const REAL minus_sized_11 = per_length * (limbs.minus_upper_sent_mz[0] - limbs.upper_sent_fy[0] * limbs.t11[0]);
    checked0 = checked0 + minus_sized_11;
    WRITE(sized_, 11, -minus_sized_11);
    const REAL minus_sized_17 = per_length * limbs.minus_U2_joint_reaction_mz[0];
    checked1 = checked1 + minus_sized_17;
    WRITE(sized_, 17, -minus_sized_17);
    const REAL minus_sized_28 = per_length * limbs.t19[1];
    checked2 = checked2 + minus_sized_28;
    WRITE(sized_, 28, -minus_sized_28);
    NEXT_LIMB(1, forward_dynamics_reactions_wrenches, 3, stride, limbs.upper_sent_fy[1], limbs.t11[1], t85,
        -(limbs.upper_position_x[1] * limbs.U2_constraint_mn_couple_x[1]), &limbs);
    WRITE(reactions, 33, limbs.S_reactions_my[1]);
    checked3 = checked3 + limbs.S_reactions_my[1];
    WRITE(reactions, 35, limbs.signed_S_reactions_mz[1]);
    checked0 = checked0 + limbs.signed_S_reactions_mz[1];
    const REAL minus_sized_29 = per_length * limbs.minus_upper_sent_mz[1];
    checked1 = checked1 + minus_sized_29;
    WRITE(sized_, 29, -minus_sized_29);
    const REAL minus_sized_46 = per_length * limbs.t19[2];
    checked2 = checked2 + minus_sized_46;
    WRITE(sized_, 46, -minus_sized_46);
    NEXT_LIMB(2, forward_dynamics_reactions_wrenches, 3, stride, limbs.upper_sent_fy[2], limbs.t11[2],
        limbs.U2_constraint_mn_couple_z[2], limbs.upper_position_x[2] * limbs.U2_constraint_mn_couple_x[2], &limbs);
    WRITE(reactions, 52, limbs.S_reactions_my[2]);
    checked3 = checked3 + limbs.S_reactions_my[2];
    WRITE(reactions, 53, limbs.signed_S_reactions_mz[2]);
    checked0 = checked0 + limbs.signed_S_reactions_mz[2];
    const REAL minus_sized_47 = per_length * limbs.minus_upper_sent_mz[2];
    checked1 = checked1 + minus_sized_47;
    WRITE(sized_, 47, -minus_sized_47);
    const REAL minus_sized_64 = per_length * limbs.t19[3];
    checked2 = checked2 + minus_sized_64;
    WRITE(sized_, 64, -minus_sized_64);
    NEXT_LIMB(3, forward_dynamics_reactions_wrenches, 3, stride, limbs.upper_sent_fy[3], limbs.t11[3],
        limbs.U2_constraint_mn_couple_z[3], limbs.upper_position_x[3] * limbs.U2_constraint_mn_couple_x[3], &limbs);
    WRITE(reactions, 69, limbs.S_reactions_my[3]);
    checked3 = checked3 + limbs.S_reactions_my[3];
    checked0 = checked0 + limbs.signed_S_reactions_mz[3];
    WRITE(reactions, 71, -limbs.signed_S_reactions_mz[3]);
    const REAL minus_sized_65 = per_length * limbs.minus_upper_sent_mz[3];
    checked1 = checked1 + minus_sized_65;
    WRITE(sized_, 65, -minus_sized_65);
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
    static const double rate_scale[15] = {1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0, 0.662327, 1.0, 1.0,
        0.662327, 1.0, 1.0, 1.0};
    static const double row_scale[13] = {1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.0,
        1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322,
        1.5098282268426322, 1.5098282268426322, 1.5098282268426322, 1.5098282268426322};
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
