/*
 * three_ups_upu_s: reactions.
 *   joint_reactions
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

BODY(three_ups_upu_s_joint_reactions)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u, double *restrict reactions, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    /* limb1: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    const REAL limb1_U_v_1 = READ(v, 1);
    const REAL minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x;
    const REAL limb1_U_a_0 = READ(a, 0), limb1_lower_cos = SINES(cosine, 1);
    const REAL minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_U_a_0 * limb1_lower_cos;
    const REAL limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL t189 = limb1_upper_offset_x * limb1_lower_U_zx;
    const REAL limb1_lower_rate_force_z = limb_lower_mx * limb1_lower_U_zx;
    const REAL limb1_U_0_sin = SINES(sine, 0);
    const REAL t190 = t189 + gravity_z * limb1_U_0_sin;
    const REAL limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    const REAL limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y;
    const REAL limb1_P_v = READ(v, 2);
    const REAL minus_limb1_upper_acc_z = limb1_P_v * (2.0 * limb1_lower_omega_y) - t190;
    const REAL minus_limb1_upper_rate_force_z = limb_lower_m * minus_limb1_upper_acc_z + limb1_lower_rate_force_z;
    const REAL minus_limb1_upper_rate_moment_y = limb_lower_mx * minus_limb1_upper_acc_z;
    const REAL t192 = minus_limb1_upper_rate_moment_y - limb1_upper_offset_x * minus_limb1_upper_rate_force_z;
    const REAL t195 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y;
    const REAL t332 = k16 * minus_limb1_lower_alpha_y + k17 * minus_limb1_lower_alpha_still_y;
    const REAL minus_limb1_upper_rate_moment_y_2 = minus_limb1_upper_rate_moment_y + t332;
    const REAL limb1_upper_force_moment_y = gravity_z_limb_lower_mx * limb1_U_0_sin;
    const REAL minus_limb1_lower_rate_moment_y_2 = limb1_upper_force_moment_y + t332;
    const REAL t196 = limb1_lower_cos * (t192 + (limb1_upper_force_moment_y + t195));
    const REAL limb1_lower_alpha_still_x = limb1_U_v_1 * limb1_lower_omega_y;
    const REAL t203 = limb1_lower_omega_y * limb1_lower_omega_y;
    const REAL limb1_U_0_force_moment_z = limb1_lower_sin * (k10 * limb1_lower_alpha_still_x) - t196 + k3 * limb1_U_a_0;
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = limb1_U_0_pivot;
    const REAL t20 = 1.0 / limb1_U_0_pivot;
    /* limb1: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); geometry */
    const REAL minus_limb1_U2_part_fz = t20 * limb1_U_0_force_moment_z;
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL t197 = minus_limb1_U2_arm_y * minus_limb1_U2_part_fz;
    const REAL t198 = limb1_lower_cos * t197;
    const REAL t235 = limb1_lower_sin * t197;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL t199 = limb1_U2_arm_x * minus_limb1_U2_part_fz;
    const REAL t201 = t198 - limb1_lower_sin * t199;
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    /* limb1: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb1_U_a_1 = READ(a, 1);
    const REAL t237 = t235 + limb1_lower_cos * t199;
    const REAL t202 = limb1_U_0_cos * t201;
    const REAL t266 = limb1_U_0_sin * t201;
    const REAL limb1_lower_U_yx = limb1_U_a_1 + limb1_lower_U_still_xy;
    const REAL t208 = limb1_upper_offset_x * limb1_lower_U_yx;
    const REAL limb1_lower_rate_force_y = limb_lower_mx * limb1_lower_U_yx;
    const REAL limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    const REAL minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y;
    const REAL t209 = t208 - minus_limb1_lower_acc_y;
    const REAL limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y;
    const REAL limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) + t209;
    const REAL limb1_upper_rate_force_y = limb_lower_m * limb1_upper_acc_y - limb1_lower_rate_force_y;
    const REAL minus_limb1_upper_rate_moment_z = limb_lower_mx * limb1_upper_acc_y;
    const REAL t211 = minus_limb1_upper_rate_moment_z - limb1_upper_offset_x * limb1_upper_rate_force_y;
    const REAL t356 = k19 * limb1_lower_U_still_xy;
    const REAL minus_limb1_lower_force_moment_z = t211 + (limb_lower_mx * minus_limb1_lower_acc_y - (k8 * limb1_lower_U_still_xy + k9 * limb1_U_a_1));
    const REAL limb1_lower_rate_force_y_2 = limb1_lower_rate_force_y - limb_lower_m * minus_limb1_lower_acc_y;
    const REAL t37 = limb1_lower_cos * t20;
    const REAL minus_limb1_U2_part_fy = minus_limb1_lower_force_moment_z * t37;
    const REAL t215 = limb1_U2_arm_x * minus_limb1_U2_part_fy;
    const REAL minus_limb1_lower_U_still_xx = t203 + limb1_U_v_1 * limb1_U_v_1;
    const REAL limb1_lower_force_x = limb_lower_m * (READ(a, 2) - (limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x));
    const REAL minus_limb1_lower_rate_force_x = limb_lower_mx * minus_limb1_lower_U_still_xx;
    const REAL limb1_upper_rate_force_x = minus_limb1_lower_rate_force_x + limb1_lower_force_x;
    const REAL minus_limb1_lower_rate_force_x_2 = minus_limb1_lower_rate_force_x - limb_lower_m * limb1_lower_acc_x;
    const REAL t216 = minus_limb1_U2_arm_y * limb1_upper_rate_force_x - t215;
    /* limb5_S: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t218 = t202 + limb1_U_0_sin * t216; /* limb1 */
    const REAL t268 = t266 - limb1_U_0_cos * t216; /* limb1 */
    const REAL t3 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t4 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t5 = t3 + t4;
    const REAL t6 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t7 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t8 = t6 + t7;
    const REAL t9 = t5 + t8;
    const REAL t11 = 4.0 - 2.0 * t9;
    const REAL t12 = t4 + t7;
    const REAL platform_turn_zz = 1.0 - t11 * (t4 + t6);
    const REAL platform_turn_yy = 1.0 - t11 * t12;
    const REAL platform_turn_xx = 1.0 - t8 * t11;
    const REAL t15 = limb5_S_q_qz * t11;
    const REAL t16 = limb5_S_q_qy * t15;
    const REAL t18 = limb5_S_q_qw * (limb5_S_q_qx * t11);
    const REAL t33 = limb5_S_q_qy * t11;
    const REAL platform_turn_zy = t16 + t18;
    const REAL platform_turn_yz = t16 - t18;
    const REAL limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14);
    const REAL minus_platform_force_moment_x = gravity_z_platform_mz * platform_turn_zy;
    const REAL platform_U_still_yz = limb5_S_v_wy * limb5_S_v_wz;
    const REAL limb5_S_a_wx = READ(a, 12);
    const REAL minus_platform_rate_force_y = platform_mz * (limb5_S_a_wx - platform_U_still_yz);
    const REAL minus_platform_rate_moment_x = minus_platform_force_moment_x - (k12 * platform_U_still_yz + k13 * limb5_S_a_wx);
    const REAL t171 = limb5_S_q_qx * t15;
    const REAL t35 = limb5_S_q_qw * t15;
    const REAL t172 = limb5_S_q_qw * t33;
    const REAL t34 = limb5_S_q_qx * t33;
    const REAL platform_turn_zx = t171 - t172;
    const REAL platform_turn_xz = t171 + t172;
    const REAL limb5_S_v_wx = READ(v, 12);
    const REAL t176 = platform_turn_zx * minus_platform_rate_moment_x;
    const REAL platform_force_moment_y = gravity_z_platform_mz * platform_turn_zx;
    const REAL platform_U_still_xz = limb5_S_v_wx * limb5_S_v_wz;
    const REAL limb5_S_a_wy = READ(a, 13);
    const REAL platform_rate_force_x = platform_mz * (limb5_S_a_wy + platform_U_still_xz);
    const REAL platform_rate_moment_y = platform_force_moment_y - (k12 * platform_U_still_xz - k13 * limb5_S_a_wy);
    const REAL t181 = t176 - platform_turn_zy * platform_rate_moment_y;
    const REAL platform_rate_moment_z = platform_Izz * READ(a, 14);
    /* limb2: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3);
    const REAL t219 = t181 - platform_turn_zz * platform_rate_moment_z - t218; /* platform */
    const REAL limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin;
    const REAL limb2_U_v_1 = READ(v, 4);
    const REAL minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x;
    const REAL limb2_U_a_0 = READ(a, 3), limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y - limb2_U_a_0 * limb2_lower_cos;
    const REAL limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL t139 = limb2_upper_offset_x * limb2_lower_U_zx;
    const REAL limb2_lower_rate_force_z = limb_lower_mx * limb2_lower_U_zx;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL t140 = t139 - gravity_z * minus_limb2_U_0_cos;
    const REAL limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos;
    const REAL limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y;
    const REAL limb2_P_v = READ(v, 5);
    const REAL minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) - t140;
    const REAL minus_limb2_upper_rate_force_z = limb_lower_m * minus_limb2_upper_acc_z + limb2_lower_rate_force_z;
    const REAL minus_limb2_upper_rate_moment_y = limb_lower_mx * minus_limb2_upper_acc_z;
    const REAL t142 = minus_limb2_upper_rate_moment_y - limb2_upper_offset_x * minus_limb2_upper_rate_force_z;
    const REAL t145 = k9 * minus_limb2_lower_alpha_still_y + k8 * minus_limb2_lower_alpha_y;
    const REAL t410 = k16 * minus_limb2_lower_alpha_y + k17 * minus_limb2_lower_alpha_still_y;
    const REAL minus_limb2_upper_rate_moment_y_2 = minus_limb2_upper_rate_moment_y + t410;
    const REAL minus_limb2_upper_force_moment_y = gravity_z_limb_lower_mx * minus_limb2_U_0_cos;
    const REAL limb2_lower_rate_moment_y_2 = minus_limb2_upper_force_moment_y - t410;
    const REAL t146 = limb2_lower_cos * (t142 - (minus_limb2_upper_force_moment_y - t145));
    const REAL limb2_lower_alpha_still_x = limb2_U_v_1 * limb2_lower_omega_y;
    const REAL t154 = limb2_lower_omega_y * limb2_lower_omega_y;
    /* limb2: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); geometry */
    const REAL limb2_U_0_force_moment_z = limb2_lower_sin * (k10 * limb2_lower_alpha_still_x) - t146 + k3 * limb2_U_a_0;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = limb2_U_0_pivot;
    const REAL t135 = 1.0 / limb2_U_0_pivot;
    const REAL minus_limb2_S_multiplier_fz = t135 * limb2_U_0_force_moment_z;
    const REAL t166 = limb2_lower_cos * t135;
    const REAL minus_limb2_upper_sent_force_z = minus_limb2_upper_rate_force_z - minus_limb2_S_multiplier_fz;
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL t147 = minus_limb2_S_arm_y * minus_limb2_S_multiplier_fz;
    const REAL t148 = limb2_lower_cos * t147;
    const REAL t258 = limb2_lower_sin * t147;
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t150 = limb2_S_arm_x * minus_limb2_S_multiplier_fz;
    const REAL t152 = t148 - limb2_lower_sin * t150;
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    /* limb2: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb2_U_a_1 = READ(a, 4);
    const REAL t260 = t258 + limb2_lower_cos * t150;
    const REAL t153 = limb2_U_0_sin * t152;
    const REAL t239 = minus_limb2_U_0_cos * t152;
    const REAL limb2_lower_U_yx = limb2_U_a_1 + limb2_lower_U_still_xy;
    const REAL t159 = limb2_upper_offset_x * limb2_lower_U_yx;
    const REAL limb2_lower_rate_force_y = limb_lower_mx * limb2_lower_U_yx;
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y;
    const REAL t160 = t159 + limb2_lower_acc_y;
    const REAL minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y;
    const REAL limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + t160;
    const REAL limb2_upper_rate_force_y = limb_lower_m * limb2_upper_acc_y - limb2_lower_rate_force_y;
    const REAL minus_limb2_upper_rate_moment_z = limb_lower_mx * limb2_upper_acc_y;
    const REAL t162 = minus_limb2_upper_rate_moment_z - limb2_upper_offset_x * limb2_upper_rate_force_y;
    const REAL t431 = k19 * limb2_lower_U_still_xy;
    const REAL minus_limb2_lower_force_moment_z = t162 - (limb_lower_mx * limb2_lower_acc_y + (k8 * limb2_lower_U_still_xy + k9 * limb2_U_a_1));
    const REAL minus_limb2_S_multiplier_fy = minus_limb2_lower_force_moment_z * t166;
    const REAL t167 = limb2_S_arm_x * minus_limb2_S_multiplier_fy;
    const REAL limb2_upper_sent_force_y = limb2_upper_rate_force_y + minus_limb2_S_multiplier_fy;
    const REAL limb2_lower_sent_force_y = limb2_lower_rate_force_y + limb_lower_m * limb2_lower_acc_y + limb2_upper_sent_force_y;
    const REAL minus_limb2_lower_U_still_xx = t154 + limb2_U_v_1 * limb2_U_v_1;
    const REAL limb2_lower_force_x = limb_lower_m * (READ(a, 5) - (limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x));
    const REAL minus_limb2_lower_rate_force_x = limb_lower_mx * minus_limb2_lower_U_still_xx;
    const REAL limb2_upper_rate_force_x = minus_limb2_lower_rate_force_x + limb2_lower_force_x;
    const REAL minus_limb2_lower_rate_force_x_2 = minus_limb2_lower_rate_force_x + limb_lower_m * minus_limb2_lower_acc_x;
    const REAL t168 = minus_limb2_S_arm_y * limb2_upper_rate_force_x - t167;
    /* limb3: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb3_U_v_0 = READ(v, 6), minus_limb3_lower_sin = SINES(sine, 5);
    const REAL t220 = t153 + minus_limb2_U_0_cos * t168 + t219; /* platform */
    const REAL t241 = t239 - limb2_U_0_sin * t168; /* limb2 */
    const REAL minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin;
    const REAL limb3_U_v_1 = READ(v, 7);
    const REAL limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x;
    const REAL limb3_U_a_0 = READ(a, 6), limb3_lower_cos = SINES(cosine, 5);
    const REAL limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_U_a_0 * limb3_lower_cos;
    const REAL minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL t103 = limb3_upper_offset_x * minus_limb3_lower_U_zx;
    const REAL minus_limb3_lower_rate_force_z = limb_lower_mx * minus_limb3_lower_U_zx;
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL t104 = t103 - gravity_z * limb3_U_0_sin;
    const REAL limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos;
    const REAL minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y;
    const REAL limb3_P_v = READ(v, 8);
    const REAL minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) + t104;
    const REAL minus_limb3_upper_rate_force_z = limb_lower_m * minus_limb3_upper_acc_z - minus_limb3_lower_rate_force_z;
    const REAL minus_limb3_upper_rate_moment_y = limb_lower_mx * minus_limb3_upper_acc_z;
    const REAL t106 = minus_limb3_upper_rate_moment_y - limb3_upper_offset_x * minus_limb3_upper_rate_force_z;
    const REAL t109 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y;
    const REAL t478 = k16 * limb3_lower_alpha_y + k17 * limb3_lower_alpha_still_y;
    const REAL minus_limb3_upper_rate_moment_y_2 = minus_limb3_upper_rate_moment_y - t478;
    const REAL limb3_upper_force_moment_y = gravity_z_limb_lower_mx * limb3_U_0_sin;
    const REAL minus_limb3_lower_rate_moment_y_2 = limb3_upper_force_moment_y - t478;
    const REAL t110 = limb3_lower_cos * (t106 + (limb3_upper_force_moment_y - t109));
    const REAL limb3_lower_alpha_still_x = limb3_U_v_1 * limb3_lower_omega_y;
    const REAL t118 = limb3_lower_omega_y * limb3_lower_omega_y;
    /* limb3: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); geometry */
    const REAL minus_limb3_U_0_force_moment_z = minus_limb3_lower_sin * (k10 * limb3_lower_alpha_still_x) + t110 - k3 * limb3_U_a_0;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = limb3_U_0_pivot;
    const REAL t99 = 1.0 / limb3_U_0_pivot;
    const REAL limb3_S_multiplier_fz = t99 * minus_limb3_U_0_force_moment_z;
    const REAL t130 = limb3_lower_cos * t99;
    const REAL minus_limb3_upper_sent_force_z = minus_limb3_upper_rate_force_z + limb3_S_multiplier_fz;
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL t111 = limb3_S_arm_y * limb3_S_multiplier_fz;
    const REAL t112 = limb3_lower_cos * t111;
    const REAL t226 = minus_limb3_lower_sin * t111;
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t114 = limb3_S_arm_x * limb3_S_multiplier_fz;
    const REAL t116 = t112 - minus_limb3_lower_sin * t114;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    /* limb3: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb3_U_a_1 = READ(a, 7);
    const REAL t228 = t226 + limb3_lower_cos * t114;
    const REAL t117 = limb3_U_0_cos * t116;
    const REAL t255 = limb3_U_0_sin * t116;
    const REAL limb3_lower_U_yx = limb3_U_a_1 - minus_limb3_lower_U_still_xy;
    const REAL t123 = limb3_upper_offset_x * limb3_lower_U_yx;
    const REAL limb3_lower_rate_force_y = limb_lower_mx * limb3_lower_U_yx;
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y;
    const REAL t124 = t123 + limb3_lower_acc_y;
    const REAL limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y;
    const REAL limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + t124;
    const REAL limb3_upper_rate_force_y = limb_lower_m * limb3_upper_acc_y - limb3_lower_rate_force_y;
    const REAL minus_limb3_upper_rate_moment_z = limb_lower_mx * limb3_upper_acc_y;
    const REAL t126 = minus_limb3_upper_rate_moment_z - limb3_upper_offset_x * limb3_upper_rate_force_y;
    const REAL t506 = k19 * minus_limb3_lower_U_still_xy;
    const REAL minus_limb3_lower_force_moment_z = t126 - (limb_lower_mx * limb3_lower_acc_y - (k8 * minus_limb3_lower_U_still_xy - k9 * limb3_U_a_1));
    const REAL minus_limb3_S_multiplier_fy = minus_limb3_lower_force_moment_z * t130;
    const REAL t131 = limb3_S_arm_x * minus_limb3_S_multiplier_fy;
    const REAL limb3_upper_sent_force_y = limb3_upper_rate_force_y + minus_limb3_S_multiplier_fy;
    const REAL limb3_lower_sent_force_y = limb3_lower_rate_force_y + limb_lower_m * limb3_lower_acc_y + limb3_upper_sent_force_y;
    const REAL minus_limb3_lower_U_still_xx = t118 + limb3_U_v_1 * limb3_U_v_1;
    const REAL limb3_lower_force_x = limb_lower_m * (READ(a, 8) - (limb3_upper_offset_x * minus_limb3_lower_U_still_xx - limb3_lower_acc_x));
    const REAL minus_limb3_lower_rate_force_x = limb_lower_mx * minus_limb3_lower_U_still_xx;
    const REAL limb3_upper_rate_force_x = minus_limb3_lower_rate_force_x + limb3_lower_force_x;
    const REAL minus_limb3_lower_rate_force_x_2 = minus_limb3_lower_rate_force_x - limb_lower_m * limb3_lower_acc_x;
    const REAL t132 = limb3_S_arm_y * limb3_upper_rate_force_x + t131;
    /* limb4: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb4_U_v_0 = READ(v, 9), minus_limb4_lower_sin = SINES(sine, 7);
    const REAL t221 = t117 - limb3_U_0_sin * t132 - t220; /* platform */
    const REAL t257 = t255 + limb3_U_0_cos * t132; /* limb3 */
    const REAL minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin;
    const REAL limb4_U_v_1 = READ(v, 10);
    const REAL limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x;
    const REAL limb4_U_a_0 = READ(a, 9), limb4_lower_cos = SINES(cosine, 7);
    const REAL limb4_lower_alpha_y = limb4_lower_alpha_still_y + limb4_U_a_0 * limb4_lower_cos;
    const REAL minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL t67 = limb4_upper_offset_x * minus_limb4_lower_U_zx;
    const REAL minus_limb4_lower_rate_force_z = limb_lower_mx * minus_limb4_lower_U_zx;
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL t68 = t67 + gravity_z * minus_limb4_U_0_cos;
    const REAL limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos;
    const REAL minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y;
    const REAL limb4_P_v = READ(v, 11);
    const REAL minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + t68;
    const REAL minus_limb4_upper_rate_force_z = limb_lower_m * minus_limb4_upper_acc_z - minus_limb4_lower_rate_force_z;
    const REAL minus_limb4_upper_rate_moment_y = limb_lower_mx * minus_limb4_upper_acc_z;
    const REAL t70 = minus_limb4_upper_rate_moment_y - limb4_upper_offset_x * minus_limb4_upper_rate_force_z;
    const REAL t73 = k9 * limb4_lower_alpha_still_y + k8 * limb4_lower_alpha_y;
    const REAL t548 = k16 * limb4_lower_alpha_y + k17 * limb4_lower_alpha_still_y;
    const REAL minus_limb4_upper_rate_moment_y_2 = minus_limb4_upper_rate_moment_y - t548;
    const REAL minus_limb4_upper_force_moment_y = gravity_z_limb_lower_mx * minus_limb4_U_0_cos;
    const REAL limb4_lower_rate_moment_y_2 = minus_limb4_upper_force_moment_y + t548;
    const REAL t74 = limb4_lower_cos * (t70 - (minus_limb4_upper_force_moment_y + t73));
    const REAL limb4_lower_alpha_still_x = limb4_U_v_1 * limb4_lower_omega_y;
    const REAL t82 = limb4_lower_omega_y * limb4_lower_omega_y;
    /* limb4: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); geometry */
    const REAL minus_limb4_U_0_force_moment_z = minus_limb4_lower_sin * (k10 * limb4_lower_alpha_still_x) + t74 - k3 * limb4_U_a_0;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked3 = limb4_U_0_pivot;
    const REAL t63 = 1.0 / limb4_U_0_pivot;
    const REAL limb4_S_multiplier_fz = t63 * minus_limb4_U_0_force_moment_z;
    const REAL t94 = limb4_lower_cos * t63;
    const REAL minus_limb4_upper_sent_force_z = minus_limb4_upper_rate_force_z + limb4_S_multiplier_fz;
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL t75 = limb4_S_arm_y * limb4_S_multiplier_fz;
    const REAL t76 = limb4_lower_cos * t75;
    const REAL t252 = minus_limb4_lower_sin * t75;
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t78 = limb4_S_arm_x * limb4_S_multiplier_fz;
    const REAL t80 = t76 - minus_limb4_lower_sin * t78;
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    /* limb4: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb4_U_a_1 = READ(a, 10);
    const REAL t254 = t252 + limb4_lower_cos * t78;
    const REAL t81 = limb4_U_0_sin * t80;
    const REAL t223 = minus_limb4_U_0_cos * t80;
    const REAL limb4_lower_U_yx = limb4_U_a_1 - minus_limb4_lower_U_still_xy;
    const REAL t87 = limb4_upper_offset_x * limb4_lower_U_yx;
    const REAL limb4_lower_rate_force_y = limb_lower_mx * limb4_lower_U_yx;
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y;
    const REAL t88 = t87 - minus_limb4_lower_acc_y;
    const REAL minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y;
    const REAL limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) + t88;
    const REAL limb4_upper_rate_force_y = limb_lower_m * limb4_upper_acc_y - limb4_lower_rate_force_y;
    const REAL minus_limb4_upper_rate_moment_z = limb_lower_mx * limb4_upper_acc_y;
    const REAL t90 = minus_limb4_upper_rate_moment_z - limb4_upper_offset_x * limb4_upper_rate_force_y;
    const REAL t569 = k19 * minus_limb4_lower_U_still_xy;
    const REAL minus_limb4_lower_rate_moment_z = limb_lower_mx * minus_limb4_lower_acc_y + (k8 * minus_limb4_lower_U_still_xy - k9 * limb4_U_a_1);
    const REAL minus_limb4_S_multiplier_fy = (t90 + minus_limb4_lower_rate_moment_z) * t94;
    const REAL t95 = limb4_S_arm_x * minus_limb4_S_multiplier_fy;
    const REAL limb4_upper_sent_force_y = limb4_upper_rate_force_y + minus_limb4_S_multiplier_fy;
    const REAL limb4_lower_sent_force_y = limb4_lower_rate_force_y - limb_lower_m * minus_limb4_lower_acc_y + limb4_upper_sent_force_y;
    const REAL minus_limb4_lower_U_still_xx = t82 + limb4_U_v_1 * limb4_U_v_1;
    const REAL limb4_upper_acc_x = READ(a, 11) - (limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_lower_acc_x);
    const REAL limb4_lower_force_x = limb_lower_m * limb4_upper_acc_x;
    const REAL minus_limb4_lower_rate_force_x = limb_lower_mx * minus_limb4_lower_U_still_xx;
    const REAL limb4_upper_rate_force_x = minus_limb4_lower_rate_force_x + limb4_lower_force_x;
    const REAL minus_limb4_lower_rate_force_x_2 = minus_limb4_lower_rate_force_x + limb_lower_m * minus_limb4_lower_acc_x;
    const REAL t96 = limb4_S_arm_y * limb4_upper_rate_force_x + t95;
    const REAL minus_platform_joint_force_moment_z = t81 - minus_limb4_U_0_cos * t96 - t221;
    const REAL t225 = t223 + limb4_U_0_sin * t96;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; balance, eqs. (40)-(47) */
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t20;
    const REAL t22 = limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3;
    const REAL t23 = limb1_lower_cos * t22;
    const REAL t47 = limb1_lower_sin * t22;
    const REAL t25 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3;
    const REAL t27 = t23 + limb1_lower_sin * t25;
    const REAL t49 = t47 - limb1_lower_cos * t25; /* platform */
    const REAL t42 = limb1_U_0_cos * t27;
    const REAL t28 = limb1_U_0_sin * t27;
    const REAL t32 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy);
    /* platform: geometry */
    const REAL platform_turn_xy = t34 - t35;
    const REAL platform_turn_yx = t34 + t35;
    const REAL limb1_U2_constraint_mn_couple_z = t32 - limb1_lower_sin * platform_turn_xy;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t37;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    /* limb5_S: balance, eqs. (40)-(47); drives */
    const REAL platform_pivot = t42 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    checked0 = checked0 + platform_pivot;
    const REAL t44 = 1.0 / platform_pivot;
    const REAL limb1_U2_part_mn = t44 * minus_platform_joint_force_moment_z;
    const REAL t40 = t28 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL t222 = t49 * limb1_U2_part_mn;
    const REAL t232 = platform_turn_xx * minus_platform_rate_moment_x - platform_turn_xy * platform_rate_moment_y;
    const REAL t263 = platform_turn_yx * minus_platform_rate_moment_x - platform_turn_yy * platform_rate_moment_y;
    const REAL minus_platform_joint_force_moment_x = t225 + (t228 + (t232 - platform_turn_xz * platform_rate_moment_z - t237 + t241));
    const REAL limb5_S_balance_wx = t222 - minus_platform_joint_force_moment_x;
    const REAL minus_platform_joint_force_moment_y = t254 + (t257 - (t260 - (t263 - platform_turn_yz * platform_rate_moment_z + t268)));
    const REAL minus_limb1_U2_part_mn_by_limb2_P = minus_limb2_U_0_cos * minus_limb2_S_arm_y * t44;
    const REAL minus_limb5_S_balance_wx_by_limb2_P = limb2_U_0_sin * minus_limb2_S_arm_y + t49 * minus_limb1_U2_part_mn_by_limb2_P;
    const REAL limb5_S_balance_wy_by_limb2_P = t40 * minus_limb1_U2_part_mn_by_limb2_P;
    const REAL t59 = minus_limb5_S_balance_wx_by_limb2_P * limb5_S_balance_wy_by_limb2_P;
    const REAL limb1_U2_part_mn_by_limb1_P = limb1_U_0_sin * minus_limb1_U2_arm_y * t44;
    const REAL minus_limb5_S_balance_wy_by_limb1_P = limb1_U_0_cos * minus_limb1_U2_arm_y + t40 * limb1_U2_part_mn_by_limb1_P;
    const REAL limb5_S_balance_wx_by_limb1_P = t49 * limb1_U2_part_mn_by_limb1_P;
    const REAL t61 = t59 + minus_limb5_S_balance_wy_by_limb1_P * limb5_S_balance_wx_by_limb1_P;
    const REAL minus_limb1_U2_part_mn_by_limb3_P = limb3_U_0_sin * limb3_S_arm_y * t44;
    const REAL limb5_S_balance_wy_by_limb3_P = limb3_U_0_cos * limb3_S_arm_y + t40 * minus_limb1_U2_part_mn_by_limb3_P;
    const REAL minus_limb5_S_balance_wx_by_limb3_P = t49 * minus_limb1_U2_part_mn_by_limb3_P;
    const REAL t62 = limb5_S_balance_wy_by_limb3_P * minus_limb5_S_balance_wx_by_limb3_P + t61;
    const REAL limb1_U2_part_mn_by_limb4_P = minus_limb4_U_0_cos * limb4_S_arm_y * t44;
    const REAL limb5_S_balance_wx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y + t49 * limb1_U2_part_mn_by_limb4_P;
    const REAL minus_limb5_S_balance_wy_by_limb4_P = limb1_U2_part_mn_by_limb4_P * t40;
    const REAL minus_limb5_S_balance_wy = t40 * limb1_U2_part_mn + minus_platform_joint_force_moment_y;
    /* limb5_S: drives; pivots */
    const REAL minus_drives_share_0_1 = limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P + t62;
    const REAL t244 = minus_drives_share_0_1 * limb5_S_balance_wx; /* limb1 */
    const REAL t247 = minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wx_by_limb2_P;
    const REAL t249 = t247 + limb5_S_balance_wx_by_limb1_P * limb5_S_balance_wx_by_limb1_P;
    const REAL t250 = minus_limb5_S_balance_wx_by_limb3_P * minus_limb5_S_balance_wx_by_limb3_P + t249;
    const REAL drives_share_0_0 = limb5_S_balance_wx_by_limb4_P * limb5_S_balance_wx_by_limb4_P + t250;
    const REAL t273 = t244 - drives_share_0_0 * minus_limb5_S_balance_wy; /* limb1 */
    const REAL t285 = minus_drives_share_0_1 * minus_limb5_S_balance_wy; /* limb1 */
    const REAL t274 = minus_drives_share_0_1 * minus_drives_share_0_1;
    const REAL t278 = minus_limb5_S_balance_wy_by_limb1_P * minus_limb5_S_balance_wy_by_limb1_P;
    const REAL t279 = limb5_S_balance_wy_by_limb2_P * limb5_S_balance_wy_by_limb2_P + t278;
    const REAL t280 = limb5_S_balance_wy_by_limb3_P * limb5_S_balance_wy_by_limb3_P + t279;
    const REAL drives_share_1_1 = minus_limb5_S_balance_wy_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P + t280;
    const REAL minus_determinant = t274 - drives_share_1_1 * drives_share_0_0;
    checked1 = checked1 + minus_determinant;
    const REAL t287 = t285 - drives_share_1_1 * limb5_S_balance_wx; /* limb1 */
    const REAL t282 = 1.0 / minus_determinant;
    const REAL t283 = t273 * t282; /* limb1 */
    const REAL t288 = t282 * t287; /* limb1 */
    const REAL minus_limb1_P_drive = minus_limb5_S_balance_wy_by_limb1_P * t283 + limb5_S_balance_wx_by_limb1_P * t288;
    const REAL limb2_P_drive = limb5_S_balance_wy_by_limb2_P * t283 + minus_limb5_S_balance_wx_by_limb2_P * t288;
    WRITE(u, 1, limb2_P_drive);
    const REAL t294 = minus_limb5_S_balance_wy_by_limb4_P * t283; /* limb4 */
    const REAL limb3_P_drive = limb5_S_balance_wy_by_limb3_P * t283 + minus_limb5_S_balance_wx_by_limb3_P * t288;
    WRITE(u, 2, limb3_P_drive);
    const REAL minus_limb4_P_drive = t294 + limb5_S_balance_wx_by_limb4_P * t288;
    const REAL limb1_U2_multiplier_fx = limb1_upper_rate_force_x + minus_limb1_P_drive;
    const REAL limb2_S_multiplier_fx = limb2_upper_rate_force_x - limb2_P_drive;
    const REAL limb3_S_multiplier_fx = limb3_upper_rate_force_x - limb3_P_drive;
    const REAL limb4_S_multiplier_fx = limb4_upper_rate_force_x + minus_limb4_P_drive;
    const REAL minus_limb4_lower_sent_force_x = minus_limb4_lower_rate_force_x_2 + minus_limb4_P_drive;
    const REAL minus_limb3_lower_sent_force_x = minus_limb3_lower_rate_force_x_2 - limb3_P_drive;
    const REAL minus_limb2_lower_sent_force_x = minus_limb2_lower_rate_force_x_2 - limb2_P_drive;
    /* limb1: balance, eqs. (40)-(47); drives; reactions, eq. (32) */
    const REAL minus_limb1_lower_sent_force_x = minus_limb1_lower_rate_force_x_2 + minus_limb1_P_drive;
    RESULT(checked2, u, 3, -minus_limb4_P_drive);
    RESULT(checked3, u, 0, -minus_limb1_P_drive);
    const REAL t299 = minus_limb1_P_drive * (limb1_U_factor_1_by_3 * limb1_U2_part_mn_by_limb1_P);
    const REAL t301 = t299 - (minus_limb1_U2_part_fy + limb1_U_factor_1_by_3 * limb1_U2_part_mn);
    const REAL t302 = limb2_P_drive * (limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn_by_limb2_P) + t301;
    const REAL t303 = limb3_P_drive * (limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn_by_limb3_P) + t302;
    const REAL limb1_U2_multiplier_fy = minus_limb4_P_drive * (limb1_U_factor_1_by_3 * limb1_U2_part_mn_by_limb4_P) + t303;
    const REAL limb1_upper_sent_force_y = limb1_upper_rate_force_y - limb1_U2_multiplier_fy;
    const REAL limb1_lower_sent_force_y = limb1_lower_rate_force_y_2 + limb1_upper_sent_force_y;
    const REAL t638 = limb1_lower_sin * limb1_U2_multiplier_fy - limb1_lower_cos * limb1_U2_multiplier_fx;
    const REAL t653 = limb1_U_0_cos * t638;
    const REAL t639 = limb1_U_0_sin * t638;
    const REAL t312 = minus_limb1_P_drive * (minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn_by_limb1_P);
    const REAL t326 = limb1_U2_part_mn - limb1_U2_part_mn_by_limb1_P * minus_limb1_P_drive;
    const REAL t314 = t312 + (minus_limb1_U2_part_fz - minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn);
    const REAL t315 = limb2_P_drive * (minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn_by_limb2_P) + t314;
    const REAL t327 = minus_limb1_U2_part_mn_by_limb2_P * limb2_P_drive - t326;
    const REAL t316 = limb3_P_drive * (minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn_by_limb3_P) + t315;
    const REAL t328 = minus_limb1_U2_part_mn_by_limb3_P * limb3_P_drive + t327;
    const REAL minus_limb1_U2_multiplier_fz = minus_limb4_P_drive * (minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn_by_limb4_P) + t316;
    const REAL minus_limb1_U2_multiplier_mn = limb1_U2_part_mn_by_limb4_P * minus_limb4_P_drive + t328;
    const REAL limb1_U2_joint_reaction_moment_z = limb1_U2_constraint_mn_couple_z * minus_limb1_U2_multiplier_mn;
    const REAL limb1_U2_joint_reaction_moment_x = limb1_U2_constraint_mn_couple_x * minus_limb1_U2_multiplier_mn;
    const REAL minus_limb1_upper_sent_force_z = minus_limb1_upper_rate_force_z - minus_limb1_U2_multiplier_fz;
    const REAL t377 = limb1_U_0_sin * minus_limb1_U2_multiplier_fz;
    const REAL t654 = t653 + t377;
    const REAL t373 = limb1_U_0_cos * minus_limb1_U2_multiplier_fz;
    const REAL t640 = t639 - t373;
    /* platform: momentum rate, eq. (35) */
    const REAL platform_rate_force_x_2 = platform_rate_force_x + platform_m_gravity_z * platform_turn_zx;
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t648 = platform_turn_zx * platform_rate_force_x_2;
    const REAL t631 = platform_turn_yx * platform_rate_force_x_2;
    const REAL t614 = platform_turn_xx * platform_rate_force_x_2;
    const REAL minus_platform_rate_force_y_2 = minus_platform_rate_force_y - platform_m_gravity_z * platform_turn_zy;
    const REAL t650 = t648 - platform_turn_zy * minus_platform_rate_force_y_2;
    const REAL t633 = t631 - platform_turn_yy * minus_platform_rate_force_y_2;
    const REAL t617 = t614 - platform_turn_xy * minus_platform_rate_force_y_2;
    const REAL t620 = platform_m_gravity_z * platform_turn_zz;
    const REAL minus_platform_rate_force_z_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t620;
    const REAL t655 = t650 - platform_turn_zz * minus_platform_rate_force_z_2 - t654;
    const REAL t641 = t633 - platform_turn_yz * minus_platform_rate_force_z_2 + t640;
    const REAL t622 = t617 - platform_turn_xz * minus_platform_rate_force_z_2;
    const REAL t610 = limb2_lower_cos * limb2_S_multiplier_fx + limb2_lower_sin * minus_limb2_S_multiplier_fy; /* limb2 */
    const REAL t646 = limb2_U_0_sin * t610; /* limb2 */
    const REAL t611 = minus_limb2_U_0_cos * t610; /* limb2 */
    const REAL t455 = minus_limb2_U_0_cos * minus_limb2_S_multiplier_fz; /* limb2 */
    const REAL t656 = t455 - t646 + t655;
    const REAL t449 = limb2_U_0_sin * minus_limb2_S_multiplier_fz; /* limb2 */
    const REAL t612 = t449 + t611; /* limb2 */
    const REAL t628 = limb3_lower_cos * limb3_S_multiplier_fx - minus_limb3_lower_sin * minus_limb3_S_multiplier_fy; /* limb3 */
    const REAL t644 = limb3_U_0_cos * t628; /* limb3 */
    const REAL t629 = limb3_U_0_sin * t628; /* limb3 */
    const REAL t524 = limb3_U_0_sin * limb3_S_multiplier_fz; /* limb3 */
    const REAL t657 = t524 + t644 + t656;
    const REAL t520 = limb3_U_0_cos * limb3_S_multiplier_fz; /* limb3 */
    const REAL t630 = t520 - t629; /* limb3 */
    /* limb4: balance, eqs. (40)-(47); reactions, eq. (32); geometry */
    const REAL t605 = limb4_lower_cos * limb4_S_multiplier_fx - minus_limb4_lower_sin * minus_limb4_S_multiplier_fy;
    const REAL t658 = limb4_U_0_sin * t605;
    const REAL t606 = minus_limb4_U_0_cos * t605;
    const REAL t593 = minus_limb4_U_0_cos * limb4_S_multiplier_fz;
    RESULT(checked0, reactions, 74, t657 - (t593 + t658));
    const REAL t587 = limb4_U_0_sin * limb4_S_multiplier_fz;
    const REAL t607 = t587 - t606;
    const REAL minus_limb2_S_reaction_force_y = limb2_lower_sin * limb2_S_multiplier_fx - limb2_lower_cos * minus_limb2_S_multiplier_fy;
    const REAL t643 = t630 + (minus_limb2_S_reaction_force_y + t641); /* platform */
    RESULT(checked1, reactions, 31, -minus_limb2_S_reaction_force_y);
    const REAL limb4_S_reaction_force_y = minus_limb4_lower_sin * limb4_S_multiplier_fx + limb4_lower_cos * minus_limb4_S_multiplier_fy;
    WRITE(reactions, 67, limb4_S_reaction_force_y);
    RESULT(checked2, reactions, 73, t643 - limb4_S_reaction_force_y);
    const REAL minus_limb1_U2_reaction_force_x = limb1_lower_cos * limb1_U2_multiplier_fy + limb1_lower_sin * limb1_U2_multiplier_fx;
    const REAL t624 = t612 - (t622 + minus_limb1_U2_reaction_force_x); /* platform */
    RESULT(checked3, reactions, 12, -minus_limb1_U2_reaction_force_x);
    const REAL limb3_S_reaction_force_x = minus_limb3_lower_sin * limb3_S_multiplier_fx + limb3_lower_cos * minus_limb3_S_multiplier_fy;
    WRITE(reactions, 48, limb3_S_reaction_force_x);
    RESULT(checked0, reactions, 72, t607 - (limb3_S_reaction_force_x + t624));
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    const REAL t589 = minus_limb4_lower_rotation_xx * limb4_S_multiplier_fx;
    const REAL minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin;
    /* limb4: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    const REAL minus_limb4_S_reaction_force_x = t587 + (minus_limb4_lower_rotation_xy * minus_limb4_S_multiplier_fy - t589);
    RESULT(checked1, reactions, 66, -minus_limb4_S_reaction_force_x);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL t601 = limb4_upper_position_y * minus_limb4_S_reaction_force_x;
    const REAL minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx;
    RESULT(checked2, reactions, 71, t601 - minus_limb4_upper_position_x * limb4_S_reaction_force_y);
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL t595 = minus_limb4_lower_rotation_zx * limb4_S_multiplier_fx;
    const REAL minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin;
    const REAL limb4_S_reaction_force_z = t593 - (minus_limb4_lower_rotation_zy * minus_limb4_S_multiplier_fy - t595);
    WRITE(reactions, 68, limb4_S_reaction_force_z);
    const REAL t599 = minus_limb4_upper_position_x * limb4_S_reaction_force_z;
    const REAL t598 = limb4_upper_position_y * limb4_S_reaction_force_z;
    const REAL minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx;
    RESULT(checked3, reactions, 70, t599 + minus_limb4_upper_position_z * minus_limb4_S_reaction_force_x);
    RESULT(checked0, reactions, 69, minus_limb4_upper_position_z * limb4_S_reaction_force_y + t598);
    const REAL minus_limb4_lower_sent_moment_y = minus_limb4_upper_rate_moment_y_2 - limb4_upper_offset_x * minus_limb4_upper_sent_force_z - limb4_lower_rate_moment_y_2;
    const REAL t557 = limb4_U_0_sin * minus_limb4_upper_sent_force_z;
    const REAL minus_limb4_P_reaction_force_x = t557 + minus_limb4_lower_rotation_xy * limb4_upper_sent_force_y;
    const REAL t566 = minus_limb4_lower_rotation_xy * minus_limb4_upper_rate_moment_y_2;
    RESULT(checked1, reactions, 60, -minus_limb4_P_reaction_force_x);
    const REAL t579 = limb4_upper_position_y * minus_limb4_P_reaction_force_x;
    const REAL t574 = minus_limb4_upper_position_z * minus_limb4_P_reaction_force_x;
    const REAL limb4_P_reaction_force_y = limb4_lower_cos * limb4_upper_sent_force_y;
    WRITE(reactions, 61, limb4_P_reaction_force_y);
    const REAL t560 = minus_limb4_lower_rotation_zy * limb4_upper_sent_force_y;
    const REAL t583 = minus_limb4_lower_rotation_zy * minus_limb4_upper_rate_moment_y_2;
    const REAL t577 = limb4_lower_cos * minus_limb4_upper_rate_moment_y_2;
    const REAL t561 = minus_limb4_upper_position_z * limb4_P_reaction_force_y;
    const REAL t581 = t579 - minus_limb4_upper_position_x * limb4_P_reaction_force_y;
    const REAL t543 = k14 * (limb4_lower_alpha_still_x - limb4_U_a_0 * minus_limb4_lower_sin);
    const REAL limb4_upper_rate_moment_x = t543 - k15 * limb4_lower_alpha_still_x;
    const REAL t584 = minus_limb4_lower_rotation_zx * limb4_upper_rate_moment_x - t583;
    const REAL t567 = minus_limb4_lower_rotation_xx * limb4_upper_rate_moment_x - t566;
    const REAL minus_limb4_upper_rate_moment_z_2 = minus_limb4_upper_rate_moment_z - (k18 * limb4_U_a_1 - t569);
    RESULT(checked2, reactions, 65, t581 - (t584 - minus_limb4_U_0_cos * minus_limb4_upper_rate_moment_z_2));
    const REAL t572 = t567 + limb4_U_0_sin * minus_limb4_upper_rate_moment_z_2;
    const REAL limb4_P_reaction_force_z = minus_limb4_U_0_cos * minus_limb4_upper_sent_force_z - t560;
    WRITE(reactions, 62, limb4_P_reaction_force_z);
    const REAL t575 = minus_limb4_upper_position_x * limb4_P_reaction_force_z + t574;
    RESULT(checked3, reactions, 63, t561 + limb4_upper_position_y * limb4_P_reaction_force_z - t572);
    RESULT(checked0, reactions, 64, t575 - (minus_limb4_lower_sin * limb4_upper_rate_moment_x + t577));
    /* limb4: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL limb4_lower_sent_moment_x = 2.0 * limb4_upper_rate_moment_x;
    const REAL t536 = limb4_lower_cos * minus_limb4_lower_sent_force_x;
    const REAL t539 = minus_limb4_lower_sin * minus_limb4_lower_sent_force_x;
    const REAL limb4_lower_joint_sent_force_x = minus_limb4_lower_sin * limb4_lower_sent_force_y - t536;
    RESULT(checked1, reactions, 55, limb4_lower_cos * limb4_lower_sent_force_y + t539);
    const REAL t537 = minus_limb4_U_0_cos * limb4_lower_joint_sent_force_x;
    const REAL t541 = limb4_U_0_sin * limb4_lower_joint_sent_force_x;
    const REAL minus_limb4_lower_sent_force_z = minus_limb4_upper_sent_force_z + (minus_limb4_lower_rate_force_z + limb_lower_m_gravity_z * minus_limb4_U_0_cos);
    const REAL minus_limb4_U_0_joint_sent_force_y = limb4_U_0_sin * minus_limb4_lower_sent_force_z + t537;
    const REAL limb4_U_0_joint_sent_force_x = minus_limb4_U_0_cos * minus_limb4_lower_sent_force_z - t541;
    WRITE(reactions, 56, limb4_U_0_joint_sent_force_x);
    const REAL t542 = param_R * limb4_U_0_joint_sent_force_x;
    RESULT(checked2, reactions, 54, -minus_limb4_U_0_joint_sent_force_y);
    const REAL t555 = param_R * minus_limb4_U_0_joint_sent_force_y;
    const REAL t551 = minus_limb4_lower_sin * minus_limb4_lower_sent_moment_y;
    const REAL t554 = limb4_lower_cos * minus_limb4_lower_sent_moment_y;
    const REAL limb4_lower_joint_sent_moment_x = limb4_lower_cos * limb4_lower_sent_moment_x - t551;
    RESULT(checked3, reactions, 58, -(minus_limb4_lower_sin * limb4_lower_sent_moment_x + t554));
    RESULT(checked0, reactions, 59, t555 - limb4_U_0_sin * limb4_lower_joint_sent_moment_x);
    RESULT(checked1, reactions, 57, t542 - minus_limb4_U_0_cos * limb4_lower_joint_sent_moment_x);
    /* limb3: geometry; reactions, eq. (32) */
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    const REAL t522 = minus_limb3_lower_rotation_yx * limb3_S_multiplier_fx;
    const REAL minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin;
    /* limb3: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    const REAL minus_limb3_S_reaction_force_y = t520 + (minus_limb3_lower_rotation_yy * minus_limb3_S_multiplier_fy - t522);
    RESULT(checked2, reactions, 49, -minus_limb3_S_reaction_force_y);
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL t533 = limb3_upper_position_x * minus_limb3_S_reaction_force_y;
    const REAL minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx;
    RESULT(checked3, reactions, 53, minus_limb3_upper_position_y * limb3_S_reaction_force_x - t533);
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    const REAL t526 = limb3_lower_rotation_zx * limb3_S_multiplier_fx;
    const REAL limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin;
    const REAL minus_limb3_S_reaction_force_z = t524 - (limb3_lower_rotation_zy * minus_limb3_S_multiplier_fy - t526);
    RESULT(checked0, reactions, 50, -minus_limb3_S_reaction_force_z);
    const REAL t530 = limb3_upper_position_x * minus_limb3_S_reaction_force_z;
    const REAL t529 = minus_limb3_upper_position_y * minus_limb3_S_reaction_force_z;
    const REAL limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx;
    RESULT(checked1, reactions, 52, t530 + limb3_upper_position_z * limb3_S_reaction_force_x);
    RESULT(checked2, reactions, 51, limb3_upper_position_z * minus_limb3_S_reaction_force_y + t529);
    const REAL minus_limb3_lower_sent_moment_y = minus_limb3_upper_rate_moment_y_2 - limb3_upper_offset_x * minus_limb3_upper_sent_force_z + minus_limb3_lower_rate_moment_y_2;
    const REAL t488 = limb3_U_0_cos * minus_limb3_upper_sent_force_z;
    const REAL minus_limb3_P_reaction_force_y = t488 + minus_limb3_lower_rotation_yy * limb3_upper_sent_force_y;
    const REAL t503 = minus_limb3_lower_rotation_yy * minus_limb3_upper_rate_moment_y_2;
    RESULT(checked3, reactions, 43, -minus_limb3_P_reaction_force_y);
    const REAL t516 = limb3_upper_position_x * minus_limb3_P_reaction_force_y;
    const REAL t492 = limb3_upper_position_z * minus_limb3_P_reaction_force_y;
    const REAL limb3_P_reaction_force_x = limb3_lower_cos * limb3_upper_sent_force_y;
    WRITE(reactions, 42, limb3_P_reaction_force_x);
    const REAL t491 = limb3_lower_rotation_zy * limb3_upper_sent_force_y;
    const REAL t511 = limb3_lower_rotation_zy * minus_limb3_upper_rate_moment_y_2;
    const REAL t500 = limb3_upper_position_z * limb3_P_reaction_force_x;
    const REAL t517 = minus_limb3_upper_position_y * limb3_P_reaction_force_x - t516;
    const REAL t496 = limb3_lower_cos * minus_limb3_upper_rate_moment_y_2;
    const REAL t473 = k14 * (limb3_lower_alpha_still_x - limb3_U_a_0 * minus_limb3_lower_sin);
    const REAL limb3_upper_rate_moment_x = t473 - k15 * limb3_lower_alpha_still_x;
    const REAL t512 = limb3_lower_rotation_zx * limb3_upper_rate_moment_x - t511;
    const REAL t504 = minus_limb3_lower_rotation_yx * limb3_upper_rate_moment_x - t503;
    const REAL minus_limb3_upper_rate_moment_z_2 = minus_limb3_upper_rate_moment_z - (k18 * limb3_U_a_1 - t506);
    RESULT(checked0, reactions, 47, t512 - limb3_U_0_sin * minus_limb3_upper_rate_moment_z_2 + t517);
    const REAL t509 = t504 + limb3_U_0_cos * minus_limb3_upper_rate_moment_z_2;
    const REAL minus_limb3_P_reaction_force_z = limb3_U_0_sin * minus_limb3_upper_sent_force_z - t491;
    RESULT(checked1, reactions, 46, limb3_upper_position_x * minus_limb3_P_reaction_force_z + t500 - t509);
    const REAL t494 = t492 + minus_limb3_upper_position_y * minus_limb3_P_reaction_force_z;
    RESULT(checked2, reactions, 44, -minus_limb3_P_reaction_force_z);
    RESULT(checked3, reactions, 45, t494 - (minus_limb3_lower_sin * limb3_upper_rate_moment_x + t496));
    /* limb3: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL limb3_lower_sent_moment_x = 2.0 * limb3_upper_rate_moment_x;
    const REAL t469 = limb3_lower_cos * minus_limb3_lower_sent_force_x;
    const REAL t466 = minus_limb3_lower_sin * minus_limb3_lower_sent_force_x;
    const REAL limb3_lower_joint_sent_force_x = minus_limb3_lower_sin * limb3_lower_sent_force_y - t469;
    RESULT(checked0, reactions, 36, limb3_lower_cos * limb3_lower_sent_force_y + t466);
    const REAL t470 = limb3_U_0_sin * limb3_lower_joint_sent_force_x;
    const REAL t472 = limb3_U_0_cos * limb3_lower_joint_sent_force_x;
    const REAL minus_limb3_lower_sent_force_z = minus_limb3_upper_sent_force_z + (minus_limb3_lower_rate_force_z - limb_lower_m_gravity_z * limb3_U_0_sin);
    const REAL minus_limb3_U_0_joint_sent_force_x = limb3_U_0_cos * minus_limb3_lower_sent_force_z + t470;
    const REAL minus_limb3_U_0_joint_sent_force_y = limb3_U_0_sin * minus_limb3_lower_sent_force_z - t472;
    RESULT(checked1, reactions, 38, -minus_limb3_U_0_joint_sent_force_y);
    const REAL t482 = param_R * minus_limb3_U_0_joint_sent_force_y;
    RESULT(checked2, reactions, 37, -minus_limb3_U_0_joint_sent_force_x);
    const REAL t487 = param_R * minus_limb3_U_0_joint_sent_force_x;
    const REAL t484 = minus_limb3_lower_sin * minus_limb3_lower_sent_moment_y;
    const REAL t481 = limb3_lower_cos * minus_limb3_lower_sent_moment_y;
    const REAL limb3_lower_joint_sent_moment_x = limb3_lower_cos * limb3_lower_sent_moment_x - t484;
    RESULT(checked3, reactions, 39, -(minus_limb3_lower_sin * limb3_lower_sent_moment_x + t481));
    RESULT(checked0, reactions, 41, limb3_U_0_cos * limb3_lower_joint_sent_moment_x - t487);
    RESULT(checked1, reactions, 40, t482 - limb3_U_0_sin * limb3_lower_joint_sent_moment_x);
    /* limb2: geometry; reactions, eq. (32) */
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    const REAL t451 = minus_limb2_lower_rotation_xx * limb2_S_multiplier_fx;
    const REAL limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin;
    /* limb2: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    const REAL limb2_S_reaction_force_x = t449 + (limb2_lower_rotation_xy * minus_limb2_S_multiplier_fy + t451);
    WRITE(reactions, 30, limb2_S_reaction_force_x);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL t463 = minus_limb2_upper_position_y * limb2_S_reaction_force_x;
    const REAL minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx;
    RESULT(checked2, reactions, 35, t463 + minus_limb2_upper_position_x * minus_limb2_S_reaction_force_y);
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL t457 = minus_limb2_lower_rotation_zx * limb2_S_multiplier_fx;
    const REAL limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin;
    const REAL minus_limb2_S_reaction_force_z = t455 - (limb2_lower_rotation_zy * minus_limb2_S_multiplier_fy + t457);
    RESULT(checked3, reactions, 32, -minus_limb2_S_reaction_force_z);
    const REAL t461 = minus_limb2_upper_position_x * minus_limb2_S_reaction_force_z;
    const REAL t459 = minus_limb2_upper_position_y * minus_limb2_S_reaction_force_z;
    const REAL minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx;
    RESULT(checked0, reactions, 34, -(t461 + minus_limb2_upper_position_z * limb2_S_reaction_force_x));
    RESULT(checked1, reactions, 33, t459 - minus_limb2_upper_position_z * minus_limb2_S_reaction_force_y);
    const REAL minus_limb2_lower_sent_moment_y = minus_limb2_upper_rate_moment_y_2 - limb2_upper_offset_x * minus_limb2_upper_sent_force_z - limb2_lower_rate_moment_y_2;
    const REAL t420 = limb2_U_0_sin * minus_limb2_upper_sent_force_z;
    const REAL minus_limb2_P_reaction_force_x = t420 - limb2_lower_rotation_xy * limb2_upper_sent_force_y;
    const REAL t428 = limb2_lower_rotation_xy * minus_limb2_upper_rate_moment_y_2;
    RESULT(checked2, reactions, 24, -minus_limb2_P_reaction_force_x);
    const REAL t446 = minus_limb2_upper_position_y * minus_limb2_P_reaction_force_x;
    const REAL t439 = minus_limb2_upper_position_z * minus_limb2_P_reaction_force_x;
    const REAL limb2_P_reaction_force_y = limb2_lower_cos * limb2_upper_sent_force_y;
    WRITE(reactions, 25, limb2_P_reaction_force_y);
    const REAL t423 = limb2_lower_rotation_zy * limb2_upper_sent_force_y;
    const REAL t442 = limb2_lower_rotation_zy * minus_limb2_upper_rate_moment_y_2;
    const REAL t436 = limb2_lower_cos * minus_limb2_upper_rate_moment_y_2;
    const REAL t424 = minus_limb2_upper_position_z * limb2_P_reaction_force_y;
    const REAL t448 = t446 + minus_limb2_upper_position_x * limb2_P_reaction_force_y;
    const REAL t405 = k14 * (limb2_lower_alpha_still_x + limb2_U_a_0 * limb2_lower_sin);
    const REAL limb2_upper_rate_moment_x = t405 - k15 * limb2_lower_alpha_still_x;
    const REAL t443 = minus_limb2_lower_rotation_zx * limb2_upper_rate_moment_x + t442;
    const REAL t429 = minus_limb2_lower_rotation_xx * limb2_upper_rate_moment_x + t428;
    const REAL minus_limb2_upper_rate_moment_z_2 = minus_limb2_upper_rate_moment_z - (k18 * limb2_U_a_1 + t431);
    RESULT(checked3, reactions, 29, -(t443 - minus_limb2_U_0_cos * minus_limb2_upper_rate_moment_z_2 + t448));
    const REAL t434 = t429 + limb2_U_0_sin * minus_limb2_upper_rate_moment_z_2;
    const REAL limb2_P_reaction_force_z = minus_limb2_U_0_cos * minus_limb2_upper_sent_force_z + t423;
    WRITE(reactions, 26, limb2_P_reaction_force_z);
    const REAL t440 = minus_limb2_upper_position_x * limb2_P_reaction_force_z + t439;
    RESULT(checked0, reactions, 27, t424 - minus_limb2_upper_position_y * limb2_P_reaction_force_z - t434);
    RESULT(checked1, reactions, 28, limb2_lower_sin * limb2_upper_rate_moment_x - t436 + t440);
    /* limb2: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL limb2_lower_sent_moment_x = 2.0 * limb2_upper_rate_moment_x;
    const REAL t402 = limb2_lower_sin * minus_limb2_lower_sent_force_x;
    const REAL minus_limb2_lower_joint_sent_force_x = limb2_lower_sin * limb2_lower_sent_force_y + limb2_lower_cos * minus_limb2_lower_sent_force_x;
    RESULT(checked2, reactions, 19, limb2_lower_cos * limb2_lower_sent_force_y - t402);
    const REAL t400 = minus_limb2_U_0_cos * minus_limb2_lower_joint_sent_force_x;
    const REAL t404 = limb2_U_0_sin * minus_limb2_lower_joint_sent_force_x;
    const REAL minus_limb2_lower_sent_force_z = minus_limb2_upper_sent_force_z - (limb2_lower_rate_force_z - limb_lower_m_gravity_z * minus_limb2_U_0_cos);
    const REAL minus_limb2_U_0_joint_sent_force_y = limb2_U_0_sin * minus_limb2_lower_sent_force_z - t400;
    const REAL limb2_U_0_joint_sent_force_x = minus_limb2_U_0_cos * minus_limb2_lower_sent_force_z + t404;
    WRITE(reactions, 20, limb2_U_0_joint_sent_force_x);
    const REAL t415 = param_R * limb2_U_0_joint_sent_force_x;
    RESULT(checked3, reactions, 18, -minus_limb2_U_0_joint_sent_force_y);
    const REAL t419 = param_R * minus_limb2_U_0_joint_sent_force_y;
    const REAL t417 = limb2_lower_cos * minus_limb2_lower_sent_moment_y;
    const REAL limb2_lower_joint_sent_moment_x = limb2_lower_cos * limb2_lower_sent_moment_x + limb2_lower_sin * minus_limb2_lower_sent_moment_y;
    RESULT(checked0, reactions, 22, limb2_lower_sin * limb2_lower_sent_moment_x - t417);
    RESULT(checked1, reactions, 23, -(limb2_U_0_sin * limb2_lower_joint_sent_moment_x + t419));
    RESULT(checked2, reactions, 21, -(minus_limb2_U_0_cos * limb2_lower_joint_sent_moment_x + t415));
    /* limb1: geometry */
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    /* limb1: reactions, eq. (32); geometry; balance, eqs. (40)-(47) */
    const REAL t374 = limb1_lower_rotation_yy * limb1_U2_multiplier_fy;
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    const REAL limb1_U2_reaction_force_y = t373 - (t374 - minus_limb1_lower_rotation_yx * limb1_U2_multiplier_fx);
    WRITE(reactions, 13, limb1_U2_reaction_force_y);
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t395 = minus_limb1_upper_position_x * limb1_U2_reaction_force_y;
    const REAL minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx;
    const REAL t396 = minus_limb1_upper_position_y * minus_limb1_U2_reaction_force_x + t395;
    const REAL t391 = limb1_U_0_sin * limb1_U2_joint_reaction_moment_z;
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    const REAL t379 = limb1_lower_rotation_zx * limb1_U2_multiplier_fx;
    RESULT(checked3, reactions, 17, t391 + limb1_lower_rotation_zx * limb1_U2_joint_reaction_moment_x - t396);
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin;
    const REAL limb1_U2_reaction_force_z = t377 + (minus_limb1_lower_rotation_zy * limb1_U2_multiplier_fy - t379);
    WRITE(reactions, 14, limb1_U2_reaction_force_z);
    const REAL t385 = minus_limb1_upper_position_x * limb1_U2_reaction_force_z;
    const REAL t383 = minus_limb1_upper_position_y * limb1_U2_reaction_force_z;
    const REAL limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx;
    const REAL t387 = t385 - limb1_upper_position_z * minus_limb1_U2_reaction_force_x;
    const REAL t384 = limb1_upper_position_z * limb1_U2_reaction_force_y + t383;
    const REAL minus_limb1_lower_sent_moment_y = minus_limb1_lower_rate_moment_y_2 + (minus_limb1_upper_rate_moment_y_2 - limb1_upper_offset_x * minus_limb1_upper_sent_force_z);
    const REAL t388 = limb1_U_0_cos * limb1_U2_joint_reaction_moment_z;
    RESULT(checked0, reactions, 16, t387 + (t388 - minus_limb1_lower_rotation_yx * limb1_U2_joint_reaction_moment_x));
    RESULT(checked1, reactions, 15, limb1_lower_sin * limb1_U2_joint_reaction_moment_x - t384);
    const REAL t342 = limb1_U_0_cos * minus_limb1_upper_sent_force_z;
    const REAL minus_limb1_P_reaction_force_y = t342 - limb1_lower_rotation_yy * limb1_upper_sent_force_y;
    const REAL t359 = limb1_lower_rotation_yy * minus_limb1_upper_rate_moment_y_2;
    RESULT(checked2, reactions, 7, -minus_limb1_P_reaction_force_y);
    const REAL t364 = minus_limb1_upper_position_x * minus_limb1_P_reaction_force_y;
    const REAL t346 = limb1_upper_position_z * minus_limb1_P_reaction_force_y;
    const REAL limb1_P_reaction_force_x = limb1_lower_cos * limb1_upper_sent_force_y;
    WRITE(reactions, 6, limb1_P_reaction_force_x);
    const REAL t345 = minus_limb1_lower_rotation_zy * limb1_upper_sent_force_y;
    const REAL t367 = minus_limb1_lower_rotation_zy * minus_limb1_upper_rate_moment_y_2;
    const REAL t353 = limb1_upper_position_z * limb1_P_reaction_force_x;
    const REAL t365 = minus_limb1_upper_position_y * limb1_P_reaction_force_x + t364;
    const REAL t349 = limb1_lower_cos * minus_limb1_upper_rate_moment_y_2;
    const REAL t320 = k14 * (limb1_lower_alpha_still_x + limb1_U_a_0 * limb1_lower_sin);
    const REAL limb1_upper_rate_moment_x = t320 - k15 * limb1_lower_alpha_still_x;
    const REAL limb1_upper_sent_moment_x = limb1_upper_rate_moment_x + limb1_U2_joint_reaction_moment_x;
    const REAL t369 = t367 + limb1_lower_rotation_zx * limb1_upper_sent_moment_x;
    const REAL t361 = t359 + minus_limb1_lower_rotation_yx * limb1_upper_sent_moment_x;
    const REAL limb1_lower_sent_moment_x = limb1_upper_rate_moment_x + limb1_upper_sent_moment_x;
    const REAL t351 = t349 - limb1_lower_sin * limb1_upper_sent_moment_x;
    const REAL minus_limb1_upper_sent_moment_z = minus_limb1_upper_rate_moment_z - (k18 * limb1_U_a_1 + t356) - limb1_U2_joint_reaction_moment_z;
    RESULT(checked3, reactions, 11, t365 - (limb1_U_0_sin * minus_limb1_upper_sent_moment_z - t369));
    const REAL t362 = limb1_U_0_cos * minus_limb1_upper_sent_moment_z + t361;
    const REAL minus_limb1_P_reaction_force_z = limb1_U_0_sin * minus_limb1_upper_sent_force_z + t345;
    RESULT(checked0, reactions, 10, -(minus_limb1_upper_position_x * minus_limb1_P_reaction_force_z - t353 + t362));
    RESULT(checked1, reactions, 9, t346 + minus_limb1_upper_position_y * minus_limb1_P_reaction_force_z - t351);
    RESULT(checked2, reactions, 8, -minus_limb1_P_reaction_force_z);
    /* limb1: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t335 = limb1_lower_cos * minus_limb1_lower_sent_moment_y;
    const REAL limb1_lower_joint_sent_moment_x = limb1_lower_sin * minus_limb1_lower_sent_moment_y + limb1_lower_cos * limb1_lower_sent_moment_x;
    RESULT(checked3, reactions, 3, limb1_lower_sin * limb1_lower_sent_moment_x - t335);
    const REAL t340 = limb1_U_0_cos * limb1_lower_joint_sent_moment_x;
    const REAL t339 = limb1_U_0_sin * limb1_lower_joint_sent_moment_x;
    const REAL t304 = limb1_lower_cos * limb1_lower_sent_force_y;
    const REAL minus_limb1_lower_joint_sent_force_x = limb1_lower_sin * limb1_lower_sent_force_y + limb1_lower_cos * minus_limb1_lower_sent_force_x;
    RESULT(checked0, reactions, 0, t304 - limb1_lower_sin * minus_limb1_lower_sent_force_x);
    const REAL t308 = limb1_U_0_sin * minus_limb1_lower_joint_sent_force_x;
    const REAL t318 = limb1_U_0_cos * minus_limb1_lower_joint_sent_force_x;
    const REAL limb1_lower_sent_force_z = limb1_lower_rate_force_z + limb_lower_m_gravity_z * limb1_U_0_sin - minus_limb1_upper_sent_force_z;
    const REAL limb1_U_0_joint_sent_force_x = t308 + limb1_U_0_cos * limb1_lower_sent_force_z;
    WRITE(reactions, 1, limb1_U_0_joint_sent_force_x);
    RESULT(checked1, reactions, 5, t340 - param_R * limb1_U_0_joint_sent_force_x);
    const REAL minus_limb1_U_0_joint_sent_force_y = t318 - limb1_U_0_sin * limb1_lower_sent_force_z;
    RESULT(checked2, reactions, 2, -minus_limb1_U_0_joint_sent_force_y);
    RESULT(checked3, reactions, 4, -(param_R * minus_limb1_U_0_joint_sent_force_y + t339));
    WRITE(reactions, 75, CONSTANT(0.0));
    WRITE(reactions, 76, CONSTANT(0.0));
    WRITE(reactions, 77, CONSTANT(0.0));
    NOT_BELOW(t9, 0.999999, 5);
    NOT_ABOVE(t9, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb2_U_0_pivot, 6.3211e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb3_U_0_pivot, 6.4044e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.284e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.233100000000001e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(platform_pivot, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10), /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

#if !defined(THREE_UPS_UPU_S_VECTORS)

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_joint_reactions_packed_lane(const double *restrict q,
    const double *restrict v, const double *restrict a, double *restrict u, double *restrict reactions,
    const double *restrict sine, const double *restrict cosine)
{
    const double x2 = q[2], x5 = q[5], x8 = q[8], x11 = q[11], x12 = q[12], x13 = q[13], x14 = q[14], x15 =
        q[15];
    const double x16 = v[0], x17 = v[1], x18 = v[2], x19 = v[3], x20 = v[4], x21 = v[5], x22 = v[6], x23 =
        v[7];
    const double x24 = v[8], x25 = v[9], x26 = v[10], x27 = v[11], x28 = v[12], x29 = v[13], x30 = v[14];
    const double x31 = a[0], x32 = a[1], x33 = a[2], x34 = a[3], x35 = a[4], x36 = a[5], x37 = a[6], x38 =
        a[7];
    const double x39 = a[8], x40 = a[9], x41 = a[10], x42 = a[11], x43 = a[12], x44 = a[13], x45 = a[14];
    const double x51 = sine[0], x46 = cosine[0], x72 = sine[1], x48 = cosine[1], x143 = sine[2], x138 =
        cosine[2];
    const double x322 = sine[3], x140 = cosine[3], x131 = sine[4], x126 = cosine[4], x240 = sine[5];
    const double x128 = cosine[5], x119 = sine[6], x111 = cosine[6], x158 = sine[7], x113 = cosine[7];
    reactions[75] = 0.0;
    reactions[76] = 0.0;
    reactions[77] = 0.0;
    const three_ups_upu_s_vector4 xgathered0 = {x16, x19, x22, x25};
    const three_ups_upu_s_vector4 xgathered1 = {x72, x322, x240, x158};
    const three_ups_upu_s_vector4 xpack20 = xgathered0 * xgathered1;
    const three_ups_upu_s_vector4 xgathered2 = {x17, x20, x23, x26};
    const three_ups_upu_s_vector4 xpack21 = xgathered2 * xpack20;
    const three_ups_upu_s_vector4 xgathered3 = {x31, x34, x37, x40};
    const three_ups_upu_s_vector4 xgathered4 = {x48, x140, x128, x113};
    const three_ups_upu_s_vector4 xpack22 = xgathered3 * xgathered4;
    const three_ups_upu_s_vector4 xpack23 = xpack21 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack22;
    const three_ups_upu_s_vector4 xpack24 = xpack21 + xpack23;
    const three_ups_upu_s_vector4 xgathered5 = {x2, x5, x8, x11};
    const three_ups_upu_s_vector4 xpack2 = xgathered5 + (three_ups_upu_s_vector4){0.3, 0.3, 0.3, 0.3};
    const three_ups_upu_s_vector4 xpack25 = xpack2 * xpack24;
    const three_ups_upu_s_vector4 xpack31 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack24;
    const three_ups_upu_s_vector4 xgathered6 = {x51, x143, x131, x119};
    const three_ups_upu_s_vector4 xpack26 = (three_ups_upu_s_vector4){9.81, 9.81, 9.81, 9.81} * xgathered6;
    const three_ups_upu_s_vector4 xpack27 = xpack25 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack26;
    const three_ups_upu_s_vector4 xpack14 = xgathered0 * xgathered4;
    const three_ups_upu_s_vector4 xpack66 = xpack20 * xpack14;
    const three_ups_upu_s_vector4 xpack18 = (three_ups_upu_s_vector4){2.0, 2.0, 2.0, 2.0} * xpack14;
    const three_ups_upu_s_vector4 xgathered7 = {x18, x21, x24, x27};
    const three_ups_upu_s_vector4 xpack19 = xgathered7 * xpack18;
    const three_ups_upu_s_vector4 xpack28 = xpack27 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack19;
    const three_ups_upu_s_vector4 xpack30 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack28;
    const three_ups_upu_s_vector4 xpack32 = xpack30 - xpack31;
    const three_ups_upu_s_vector4 xpack29 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack28;
    const three_ups_upu_s_vector4 xpack33 = xpack2 * xpack32;
    const three_ups_upu_s_vector4 xpack34 = xpack33 - xpack29;
    const three_ups_upu_s_vector4 xpack37 = (three_ups_upu_s_vector4){2.2727, 2.2727, 2.2727, 2.2727} *
        xpack23;
    const three_ups_upu_s_vector4 xpack134 = (three_ups_upu_s_vector4){1.19195, 1.19195, 1.19195, 1.19195} *
        xpack23;
    const three_ups_upu_s_vector4 xpack36 = (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439, 2.3439} *
        xpack21;
    const three_ups_upu_s_vector4 xpack38 = xpack36 + xpack37;
    const three_ups_upu_s_vector4 xpack135 = (three_ups_upu_s_vector4){1.11635, 1.11635, 1.11635, 1.11635} *
        xpack21;
    const three_ups_upu_s_vector4 xpack136 = xpack134 + xpack135;
    const three_ups_upu_s_vector4 xpack138 = xpack29 - xpack136;
    const three_ups_upu_s_vector4 xpack35 = (three_ups_upu_s_vector4){2.08953, 2.08953, 2.08953, 2.08953} *
        xgathered6;
    const three_ups_upu_s_vector4 xpack39 = xpack38 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack35;
    const three_ups_upu_s_vector4 xpack40 = xpack39 + xpack34;
    const three_ups_upu_s_vector4 xpack137 = xpack136 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack35;
    const three_ups_upu_s_vector4 xpack41 = xgathered4 * xpack40;
    const three_ups_upu_s_vector4 xpack15 = xgathered2 * xpack14;
    const three_ups_upu_s_vector4 xpack52 = xpack14 * xpack14;
    const three_ups_upu_s_vector4 xpack16 = (three_ups_upu_s_vector4){0.0712, 0.0712, 0.0712, 0.0712} *
        xpack15;
    const three_ups_upu_s_vector4 xpack17 = xgathered1 * xpack16;
    const three_ups_upu_s_vector4 xpack42 = xpack17 - xpack41;
    const three_ups_upu_s_vector4 xpack43 = (three_ups_upu_s_vector4){0.1112, 0.1112, 0.1112, 0.1112} *
        xgathered3;
    const three_ups_upu_s_vector4 xpack44 = xpack43 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack42;
    const three_ups_upu_s_vector4 xpack3 = xgathered4 * xpack2;
    const three_ups_upu_s_vector4 xpack4 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack3;
    const three_ups_upu_s_vector4 xpack45 = xpack4 * xpack44;
    const three_ups_upu_s_vector4 xpack0 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered4;
    const three_ups_upu_s_vector4 xpack46 = xpack0 * xpack45;
    const three_ups_upu_s_vector4 xpack47 = xgathered4 * xpack46;
    const three_ups_upu_s_vector4 xpack92 = xgathered1 * xpack46;
    const three_ups_upu_s_vector4 xpack5 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered1;
    const three_ups_upu_s_vector4 xpack6 = xpack2 - xpack5;
    const three_ups_upu_s_vector4 xpack48 = xpack6 * xpack45;
    const three_ups_upu_s_vector4 xpack49 = xgathered1 * xpack48;
    const three_ups_upu_s_vector4 xpack50 = xpack47 - xpack49;
    const three_ups_upu_s_vector4 xpack93 = xgathered4 * xpack48;
    const three_ups_upu_s_vector4 xpack94 = xpack92 + xpack93;
    const three_ups_upu_s_vector4 xgathered8 = {x46, x138, x126, x111};
    const three_ups_upu_s_vector4 xpack51 = xgathered8 * xpack50;
    const three_ups_upu_s_vector4 xpack89 = xgathered6 * xpack50;
    const three_ups_upu_s_vector4 xgathered9 = {x32, x35, x38, x41};
    const three_ups_upu_s_vector4 xpack67 = xgathered9 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack66;
    const three_ups_upu_s_vector4 xpack68 = xpack2 * xpack67;
    const three_ups_upu_s_vector4 xpack74 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack67;
    const three_ups_upu_s_vector4 xpack57 = (three_ups_upu_s_vector4){9.81, 9.81, 9.81, 9.81} * xgathered8;
    const three_ups_upu_s_vector4 xpack69 = xgathered1 * xpack57;
    const three_ups_upu_s_vector4 xpack70 = xpack68 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, (-1.0)} *
        xpack69;
    const three_ups_upu_s_vector4 xpack58 = xgathered4 * xpack57;
    const three_ups_upu_s_vector4 xpack64 = (three_ups_upu_s_vector4){2.0, 2.0, 2.0, 2.0} * xgathered2;
    const three_ups_upu_s_vector4 xpack65 = xgathered7 * xpack64;
    const three_ups_upu_s_vector4 xpack71 = xpack65 + xpack70;
    const three_ups_upu_s_vector4 xpack73 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack71;
    const three_ups_upu_s_vector4 xpack75 = xpack73 - xpack74;
    const three_ups_upu_s_vector4 xpack72 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack71;
    const three_ups_upu_s_vector4 xpack76 = xpack2 * xpack75;
    const three_ups_upu_s_vector4 xpack77 = xpack72 - xpack76;
    const three_ups_upu_s_vector4 xpack79 = (three_ups_upu_s_vector4){2.2727, 2.2727, 2.2727, 2.2727} *
        xpack66;
    const three_ups_upu_s_vector4 xpack179 = (three_ups_upu_s_vector4){1.13635, 1.13635, 1.13635, 1.13635} *
        xpack66;
    const three_ups_upu_s_vector4 xpack80 = (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439, 2.3439} *
        xgathered9;
    const three_ups_upu_s_vector4 xpack81 = xpack79 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack80;
    const three_ups_upu_s_vector4 xpack78 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack69;
    const three_ups_upu_s_vector4 xpack82 = xpack81 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack78;
    const three_ups_upu_s_vector4 xpack83 = xpack82 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack77;
    const three_ups_upu_s_vector4 xpack100 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack69;
    const three_ups_upu_s_vector4 xpack101 = xpack74 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, (-1.0)} *
        xpack100;
    const three_ups_upu_s_vector4 xpack7 = xgathered4 * xpack4;
    const three_ups_upu_s_vector4 xpack84 = xpack83 * xpack7;
    const three_ups_upu_s_vector4 xpack85 = xpack6 * xpack84;
    const three_ups_upu_s_vector4 xpack53 = xgathered2 * xgathered2;
    const three_ups_upu_s_vector4 xpack54 = xpack52 + xpack53;
    const three_ups_upu_s_vector4 xpack56 = xpack2 * xpack54;
    const three_ups_upu_s_vector4 xpack59 = xpack56 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack58;
    const three_ups_upu_s_vector4 xgathered10 = {x33, x36, x39, x42};
    const three_ups_upu_s_vector4 xpack60 = xgathered10 - xpack59;
    const three_ups_upu_s_vector4 xpack61 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack60;
    const three_ups_upu_s_vector4 xpack55 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack54;
    const three_ups_upu_s_vector4 xpack62 = xpack55 + xpack61;
    const three_ups_upu_s_vector4 xpack107 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack58;
    const three_ups_upu_s_vector4 xpack108 = xpack55 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack107;
    const three_ups_upu_s_vector4 xpack63 = xpack0 * xpack62;
    const three_ups_upu_s_vector4 xpack86 = xpack85 + xpack63;
    const three_ups_upu_s_vector4 xpack87 = xgathered6 * xpack86;
    const three_ups_upu_s_vector4 xpack88 = xpack87 + xpack51;
    const three_ups_upu_s_vector4 xpack90 = xgathered8 * xpack86;
    const three_ups_upu_s_vector4 xpack91 = xpack90 - xpack89;
    const double x52 = x12 * x12;
    const double x53 = x13 * x13;
    const double x54 = x52 + x53;
    const double x55 = x14 * x14;
    const double x56 = x15 * x15;
    const double x57 = x55 + x56;
    const double x58 = x54 + x57;
    const double x59 = 2.0 * x58;
    const double x60 = 4.0 - x59;
    const double x419 = x53 + x55;
    const double x61 = x53 + x56;
    const double x420 = x60 * x419;
    const double x421 = 1.0 - x420;
    const double x62 = x60 * x61;
    const double x63 = 1.0 - x62;
    const double x512 = x57 * x60;
    const double x513 = 1.0 - x512;
    const double x65 = x15 * x60;
    const double x66 = x14 * x65;
    const double x67 = x13 * x60;
    const double x68 = x12 * x67;
    const double x91 = x14 * x60;
    const double x69 = x66 + x68;
    const double x553 = x66 - x68;
    const double x404 = 14.62961126155784 * x69;
    const double x405 = x29 * x30;
    const double x406 = 22.6251 * x405;
    const double x1150 = x43 - x405;
    const double x1151 = 1.4912957453168034 * x1150;
    const double x407 = 69.4749 * x43;
    const double x408 = x406 + x407;
    const double x409 = x404 - x408;
    const double x401 = x13 * x65;
    const double x93 = x12 * x65;
    const double x402 = x12 * x91;
    const double x92 = x13 * x91;
    const double x403 = x401 - x402;
    const double x517 = x401 + x402;
    const double x410 = x403 * x409;
    const double x411 = 14.62961126155784 * x403;
    const double x412 = x28 * x30;
    const double x413 = 22.6251 * x412;
    const double x1145 = x44 + x412;
    const double x1146 = 1.4912957453168034 * x1145;
    const double x414 = 69.4749 * x44;
    const double x415 = x413 - x414;
    const double x416 = x411 - x415;
    const double x417 = x69 * x416;
    const double x418 = x410 - x417;
    const double x422 = 92.1 * x45;
    const double x423 = x421 * x422;
    const double x424 = x418 - x423;
    const double x499 = xpack88[0];
    const double x500 = x424 - x499;
    const double x400 = xpack88[1];
    const double x501 = x400 + x500;
    const double x318 = -xpack88[2];
    const double x502 = x318 - x501;
    const double x236 = -xpack88[3];
    const double x503 = x236 - x502;
    const double x70 = x51 * x69;
    const double x64 = x46 * x63;
    const double x71 = x64 + x70;
    const double x73 = x72 * x71;
    const double x76 = xpack4[0];
    const double x77 = x73 * x76;
    const double x49 = xpack0[0];
    const double x78 = x49 * x77;
    const double x79 = x71 - x78;
    const double x80 = x48 * x79;
    const double x116 = x72 * x79;
    const double x82 = xpack6[0];
    const double x83 = x82 * x77;
    const double x84 = x72 * x83;
    const double x85 = x80 + x84;
    const double x117 = x48 * x83;
    const double x118 = x116 - x117;
    const double x104 = x46 * x85;
    const double x86 = x51 * x85;
    const double x88 = x46 * x69;
    const double x87 = x51 * x63;
    const double x89 = x87 - x88;
    const double x90 = x48 * x89;
    const double x94 = x92 - x93;
    const double x549 = x92 + x93;
    const double x95 = x72 * x94;
    const double x96 = x90 - x95;
    const double x97 = xpack7[0];
    const double x98 = x96 * x97;
    const double x99 = x82 * x98;
    const double x100 = x96 - x99;
    const double x105 = x51 * x100;
    const double x106 = x104 + x105;
    const double x107 = 1.0 / x106;
    const double x504 = x107 * x503;
    const double x101 = x46 * x100;
    const double x102 = x86 - x101;
    const double x505 = x118 * x504;
    const double x514 = x513 * x409;
    const double x550 = x549 * x409;
    const double x515 = x94 * x416;
    const double x516 = x514 - x515;
    const double x551 = x63 * x416;
    const double x552 = x550 - x551;
    const double x518 = x517 * x422;
    const double x519 = x516 - x518;
    const double x522 = xpack94[0];
    const double x523 = x519 - x522;
    const double x526 = -xpack91[1];
    const double x527 = x523 + x526;
    const double x511 = -xpack94[2];
    const double x528 = x511 + x527;
    const double x508 = xpack91[3];
    const double x529 = x508 + x528;
    const double x530 = x505 - x529;
    const double x554 = x553 * x422;
    const double x555 = x552 - x554;
    const double x558 = -xpack91[0];
    const double x559 = x555 + x558;
    const double x548 = xpack94[1];
    const double x560 = x548 - x559;
    const double x545 = xpack91[2];
    const double x561 = x545 - x560;
    const double x542 = -xpack94[3];
    const double x562 = x542 + x561;
    const three_ups_upu_s_vector4 xpack8 = xgathered6 * xpack0;
    const three_ups_upu_s_vector4 xgathered11 = {x107, x107, x107, x107};
    const three_ups_upu_s_vector4 xpack9 = xpack8 * xgathered11;
    const three_ups_upu_s_vector4 xpack1 = xgathered8 * xpack0;
    const three_ups_upu_s_vector4 xgathered12 = {x102, x118, x102, x118};
    const three_ups_upu_s_vector4 xpack10 = xgathered12 * xpack9;
    const three_ups_upu_s_vector4 xpack11 = xpack1 + xpack10;
    const three_ups_upu_s_vector4 xgathered13 = {x118, x102, x118, x102};
    const three_ups_upu_s_vector4 xpack12 = xgathered13 * xpack9;
    const double x539 = x102 * x504;
    const double x563 = x539 + x562;
    const three_ups_upu_s_vector4 xpack13 = xpack11 * xpack12;
    const double x149 = xpack13[1], x151 = xpack13[0];
    const double x152 = x149 + x151;
    const double x137 = xpack13[2];
    const double x153 = x137 + x152;
    const double x125 = xpack13[3];
    const double x154 = x125 + x153;
    const double x531 = x154 * x530;
    const three_ups_upu_s_vector4 xpack95 = xpack11 * xpack11;
    const three_ups_upu_s_vector4 xpack96 = xpack12 * xpack12;
    const double x534 = xpack95[1], x535 = xpack96[0];
    const double x536 = x534 + x535;
    const double x533 = xpack96[2];
    const double x537 = x533 + x536;
    const double x532 = xpack95[3];
    const double x538 = x532 + x537;
    const double x564 = x538 * x563;
    const double x565 = x531 - x564;
    const double x579 = x154 * x563;
    const double x566 = x154 * x154;
    const double x569 = xpack96[1], x570 = xpack95[0];
    const double x571 = x569 + x570;
    const double x568 = xpack95[2];
    const double x572 = x568 + x571;
    const double x567 = xpack96[3];
    const double x573 = x567 + x572;
    const double x574 = x573 * x538;
    const double x575 = x566 - x574;
    const double x580 = x573 * x530;
    const double x581 = x579 - x580;
    const double x576 = 1.0 / x575;
    const double x577 = x565 * x576;
    const double x582 = x576 * x581;
    const three_ups_upu_s_vector4 xgathered14 = {x577, x582, x577, x582};
    const three_ups_upu_s_vector4 xpack97 = xpack11 * xgathered14;
    const three_ups_upu_s_vector4 xgathered15 = {x582, x577, x582, x577};
    const three_ups_upu_s_vector4 xpack98 = xpack12 * xgathered15;
    const three_ups_upu_s_vector4 xpack99 = xpack97 + xpack98;
    const double x584 = xpack99[0];
    const double x585 = -x584;
    u[0] = x585;
    const double x588 = xpack99[1];
    u[1] = x588;
    const double x591 = xpack99[2];
    u[2] = x591;
    const double x594 = xpack99[3];
    const double x595 = -x594;
    u[3] = x595;
    const three_ups_upu_s_vector4 xpack198 = xpack62 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack99;
    const three_ups_upu_s_vector4 xpack109 = xpack108 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack99;
    const three_ups_upu_s_vector4 xgathered16 = {x98, x98, x98, x98};
    const three_ups_upu_s_vector4 xpack102 = xgathered16 * xpack9;
    const three_ups_upu_s_vector4 xpack103 = xpack99 * xpack102;
    const double x606 = x98 * x504;
    const double x495 = -xpack84[0];
    const double x607 = x495 + x606;
    const double x605 = xpack103[0];
    const double x608 = x605 - x607;
    const double x603 = xpack103[1];
    const double x609 = x603 + x608;
    const double x601 = xpack103[2];
    const double x610 = x601 + x609;
    const double x599 = xpack103[3];
    const double x611 = x599 + x610;
    const double x396 = -xpack84[1], x314 = xpack84[2], x232 = xpack84[3];
    const three_ups_upu_s_vector4 xgathered17 = {x611, x396, x314, x232};
    const three_ups_upu_s_vector4 xpack104 = xpack75 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, 1.0} *
        xgathered17;
    const three_ups_upu_s_vector4 xpack105 = xpack101 + xpack104;
    const three_ups_upu_s_vector4 xpack222 = xgathered1 * xgathered17;
    const three_ups_upu_s_vector4 xpack221 = xgathered4 * xpack198;
    const three_ups_upu_s_vector4 xpack223 = xpack222 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), (-1.0)}
        * xpack221;
    const three_ups_upu_s_vector4 xpack226 = xgathered8 * xpack223;
    const three_ups_upu_s_vector4 xpack224 = xgathered6 * xpack223;
    const three_ups_upu_s_vector4 xgathered18 = {x77, x77, x77, x77};
    const three_ups_upu_s_vector4 xpack118 = xgathered18 * xpack9;
    const three_ups_upu_s_vector4 xpack119 = xpack99 * xpack118;
    const three_ups_upu_s_vector4 xpack132 = xpack9 * xpack99;
    const double x634 = x77 * x504;
    const double x456 = xpack45[0];
    const double x635 = x456 - x634;
    const double x633 = xpack119[0];
    const double x636 = x633 + x635;
    const double x631 = xpack119[1];
    const double x637 = x631 + x636;
    const double x629 = xpack119[2];
    const double x638 = x629 + x637;
    const double x627 = xpack119[3];
    const double x639 = x627 + x638;
    const double x656 = xpack132[0];
    const double x657 = x504 - x656;
    const double x655 = xpack132[1];
    const double x658 = x655 - x657;
    const double x654 = xpack132[2];
    const double x659 = x654 + x658;
    const double x653 = xpack132[3];
    const double x660 = x653 + x659;
    const double x716 = x96 * x660;
    const double x661 = x71 * x660;
    const double x354 = xpack45[1], x272 = -xpack45[2], x190 = -xpack45[3];
    const three_ups_upu_s_vector4 xgathered19 = {x639, x354, x272, x190};
    const three_ups_upu_s_vector4 xpack120 = xgathered19 + xpack32;
    const three_ups_upu_s_vector4 xpack206 = xgathered6 * xgathered19;
    const three_ups_upu_s_vector4 xpack201 = xgathered8 * xgathered19;
    const three_ups_upu_s_vector4 xpack227 = xpack226 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), (-1.0)}
        * xpack206;
    const three_ups_upu_s_vector4 xpack225 = xpack224 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, 1.0} *
        xpack201;
    const double x1147 = 28.1547 * x403;
    const double x1148 = x1146 + x1147;
    const double x1191 = x403 * x1148;
    const double x1173 = x549 * x1148;
    const double x1149 = x513 * x1148;
    const double x1152 = 28.1547 * x69;
    const double x1153 = x1151 - x1152;
    const double x1192 = x69 * x1153;
    const double x1193 = x1191 - x1192;
    const double x1174 = x63 * x1153;
    const double x1175 = x1173 - x1174;
    const double x1154 = x94 * x1153;
    const double x1155 = x1149 - x1154;
    const double x1160 = 28.1547 * x421;
    const double x1156 = x28 * x28;
    const double x1157 = x29 * x29;
    const double x1158 = x1156 + x1157;
    const double x1159 = 1.4912957453168034 * x1158;
    const double x1161 = x1159 - x1160;
    const double x1194 = x421 * x1161;
    const double x1195 = x1193 - x1194;
    const double x1197 = xpack227[0];
    const double x1198 = x1195 - x1197;
    const double x1190 = -xpack227[1];
    const double x1199 = x1190 + x1198;
    const double x1188 = -xpack227[2];
    const double x1200 = x1188 + x1199;
    const double x1202 = -xpack227[3];
    const double x1203 = x1200 - x1202;
    reactions[74] = x1203;
    const double x1176 = x553 * x1161;
    const double x1177 = x1175 - x1176;
    const double x1162 = x517 * x1161;
    const double x1163 = x1155 - x1162;
    const double x1182 = xpack225[0];
    const double x1183 = x1177 + x1182;
    const three_ups_upu_s_vector4 xpack197 = xgathered4 * xgathered17;
    const three_ups_upu_s_vector4 xpack199 = xgathered1 * xpack198;
    const three_ups_upu_s_vector4 xpack200 = xpack199 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, 1.0} *
        xpack197;
    const double x737 = xpack200[0];
    const double x738 = -x737;
    reactions[12] = x738;
    const double x874 = xpack200[1];
    const double x875 = -x874;
    reactions[31] = x875;
    const double x993 = xpack200[2];
    reactions[48] = x993;
    const double x1120 = xpack200[3];
    reactions[67] = x1120;
    const double x1184 = x874 + x1183;
    const double x1172 = xpack225[2];
    const double x1185 = x1172 + x1184;
    const double x1186 = x1185 - x1120;
    reactions[73] = x1186;
    const double x1164 = x1163 + x737;
    const double x1144 = xpack225[1];
    const double x1165 = x1144 - x1164;
    const double x1166 = x993 + x1165;
    const double x1139 = xpack225[3];
    const double x1167 = x1139 - x1166;
    reactions[72] = x1167;
    const three_ups_upu_s_vector4 xpack155 = xgathered6 * xgathered1;
    const three_ups_upu_s_vector4 xpack202 = xpack155 * xgathered17;
    const three_ups_upu_s_vector4 xpack165 = xgathered6 * xgathered4;
    const three_ups_upu_s_vector4 xpack203 = xpack165 * xpack198;
    const three_ups_upu_s_vector4 xpack204 = xpack203 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), (-1.0)}
        * xpack202;
    const three_ups_upu_s_vector4 xpack205 = xpack204 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack201;
    const double x743 = xpack205[0];
    reactions[13] = x743;
    const double x871 = xpack205[1];
    reactions[30] = x871;
    const double x998 = -xpack205[2];
    const double x999 = -x998;
    reactions[49] = x999;
    const double x1116 = -xpack205[3];
    const double x1117 = -x1116;
    reactions[66] = x1117;
    const three_ups_upu_s_vector4 xpack173 = xgathered1 * xpack2;
    const three_ups_upu_s_vector4 xpack174 = xpack173 - (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8};
    const three_ups_upu_s_vector4 xpack218 = xpack174 * xpack205;
    const three_ups_upu_s_vector4 xpack166 = xpack2 * xpack165;
    const three_ups_upu_s_vector4 xpack217 = xpack166 * xpack200;
    const three_ups_upu_s_vector4 xpack219 = xpack218 - xpack217;
    const double x891 = -xpack219[1];
    reactions[35] = x891;
    const double x1014 = -xpack219[2];
    reactions[53] = x1014;
    const double x1134 = xpack219[3];
    reactions[71] = x1134;
    const double x761 = x51 * x716;
    const three_ups_upu_s_vector4 xpack162 = xgathered8 * xgathered4;
    const three_ups_upu_s_vector4 xpack208 = xpack162 * xpack198;
    const double x696 = xpack162[0];
    const double x762 = x696 * x661;
    const double x763 = x761 + x762;
    const double x766 = -xpack219[0];
    const double x767 = x763 - x766;
    reactions[17] = x767;
    const three_ups_upu_s_vector4 xpack159 = xgathered8 * xgathered1;
    const three_ups_upu_s_vector4 xpack207 = xpack159 * xgathered17;
    const three_ups_upu_s_vector4 xpack209 = xpack208 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), (-1.0)}
        * xpack207;
    const three_ups_upu_s_vector4 xpack210 = xpack209 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack206;
    const double x748 = -xpack210[0];
    reactions[14] = x748;
    const double x880 = -xpack210[1];
    const double x881 = -x880;
    reactions[32] = x881;
    const double x1004 = xpack210[2];
    const double x1005 = -x1004;
    reactions[50] = x1005;
    const double x1125 = xpack210[3];
    reactions[68] = x1125;
    const three_ups_upu_s_vector4 xpack214 = xpack174 * xpack210;
    const three_ups_upu_s_vector4 xpack212 = xpack166 * xpack210;
    const three_ups_upu_s_vector4 xpack163 = xpack2 * xpack162;
    const three_ups_upu_s_vector4 xpack215 = xpack163 * xpack200;
    const three_ups_upu_s_vector4 xpack216 = xpack215 - xpack214;
    const double x884 = -xpack216[1];
    reactions[33] = x884;
    const double x1011 = xpack216[2];
    reactions[52] = x1011;
    const double x1128 = xpack216[3];
    reactions[69] = x1128;
    const three_ups_upu_s_vector4 xpack211 = xpack163 * xpack205;
    const three_ups_upu_s_vector4 xpack213 = xpack211 - xpack212;
    const double x887 = xpack213[1];
    const double x888 = -x887;
    reactions[34] = x888;
    const double x1008 = -xpack213[2];
    reactions[51] = x1008;
    const double x1131 = -xpack213[3];
    reactions[70] = x1131;
    const three_ups_upu_s_vector4 xpack139 = xpack2 * xpack120;
    const three_ups_upu_s_vector4 xpack140 = xpack138 - xpack139;
    const three_ups_upu_s_vector4 xpack141 = xpack140 - xpack137;
    const double x757 = x46 * x716;
    const double x699 = xpack165[0];
    const double x758 = x699 * x661;
    const double x759 = x757 - x758;
    const double x756 = -xpack216[0];
    const double x760 = x756 + x759;
    reactions[16] = x760;
    const double x749 = x72 * x661;
    const double x752 = xpack213[0];
    const double x753 = x749 - x752;
    reactions[15] = x753;
    const three_ups_upu_s_vector4 xpack154 = xgathered8 * xpack120;
    const three_ups_upu_s_vector4 xpack156 = xpack155 * xpack104;
    const three_ups_upu_s_vector4 xpack157 = xpack156 + xpack154;
    const double x689 = -xpack157[0];
    const double x690 = -x689;
    reactions[7] = x690;
    const double x823 = -xpack157[1];
    const double x824 = -x823;
    reactions[24] = x824;
    const double x948 = xpack157[2];
    const double x949 = -x948;
    reactions[43] = x949;
    const double x1069 = xpack157[3];
    const double x1070 = -x1069;
    reactions[60] = x1070;
    const three_ups_upu_s_vector4 xpack183 = xpack155 * xpack138;
    const three_ups_upu_s_vector4 xpack189 = xpack174 * xpack157;
    const three_ups_upu_s_vector4 xpack164 = xpack163 * xpack157;
    const three_ups_upu_s_vector4 xpack153 = xgathered4 * xpack104;
    const double x685 = xpack153[0];
    reactions[6] = x685;
    const double x825 = xpack153[1];
    reactions[25] = x825;
    const double x944 = xpack153[2];
    reactions[42] = x944;
    const double x1071 = xpack153[3];
    reactions[61] = x1071;
    const three_ups_upu_s_vector4 xpack160 = xpack159 * xpack104;
    const three_ups_upu_s_vector4 xpack192 = xpack159 * xpack138;
    const three_ups_upu_s_vector4 xpack176 = xpack163 * xpack153;
    const three_ups_upu_s_vector4 xpack188 = xpack166 * xpack153;
    const three_ups_upu_s_vector4 xpack190 = xpack189 + xpack188;
    const three_ups_upu_s_vector4 xpack169 = xgathered4 * xpack138;
    const three_ups_upu_s_vector4 xpack127 = xgathered3 * xgathered1;
    const three_ups_upu_s_vector4 xpack128 = xpack15 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack127;
    const three_ups_upu_s_vector4 xpack129 = (three_ups_upu_s_vector4){0.0556, 0.0556, 0.0556, 0.0556} *
        xpack128;
    const three_ups_upu_s_vector4 xpack130 = (three_ups_upu_s_vector4){0.02, 0.02, 0.02, 0.02} * xpack15;
    const three_ups_upu_s_vector4 xpack131 = xpack129 - xpack130;
    const double x652 = xpack131[0];
    const double x662 = x652 + x661;
    const double x796 = xpack131[1], x921 = xpack131[2], x1044 = xpack131[3];
    const three_ups_upu_s_vector4 xgathered20 = {x662, x796, x921, x1044};
    const three_ups_upu_s_vector4 xpack193 = xpack162 * xgathered20;
    const three_ups_upu_s_vector4 xpack194 = xpack193 - xpack192;
    const three_ups_upu_s_vector4 xpack184 = xpack165 * xgathered20;
    const three_ups_upu_s_vector4 xpack185 = xpack184 - xpack183;
    const three_ups_upu_s_vector4 xpack178 = (three_ups_upu_s_vector4){1.17195, 1.17195, 1.17195, 1.17195} *
        xgathered9;
    const three_ups_upu_s_vector4 xpack180 = xpack178 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack179;
    const three_ups_upu_s_vector4 xpack181 = xpack72 - xpack180;
    const double x715 = xpack181[0];
    const double x717 = x715 - x716;
    const double x844 = xpack181[1], x977 = xpack181[2], x1090 = xpack181[3];
    const three_ups_upu_s_vector4 xgathered21 = {x717, x844, x977, x1090};
    const three_ups_upu_s_vector4 xpack191 = xgathered6 * xgathered21;
    const three_ups_upu_s_vector4 xpack195 = xpack194 - xpack191;
    const three_ups_upu_s_vector4 xpack196 = xpack190 + xpack195;
    const double x733 = xpack196[0];
    reactions[11] = x733;
    const double x864 = xpack196[1];
    const double x865 = -x864;
    reactions[29] = x865;
    const double x989 = xpack196[2];
    reactions[47] = x989;
    const double x1110 = -xpack196[3];
    reactions[65] = x1110;
    const three_ups_upu_s_vector4 xpack182 = xgathered8 * xgathered21;
    const three_ups_upu_s_vector4 xpack186 = xpack185 + xpack182;
    const three_ups_upu_s_vector4 xpack158 = xgathered6 * xpack120;
    const three_ups_upu_s_vector4 xpack161 = xpack160 - xpack158;
    const double x694 = xpack161[0];
    const double x695 = -x694;
    reactions[8] = x695;
    const double x829 = xpack161[1];
    reactions[26] = x829;
    const double x953 = -xpack161[2];
    const double x954 = -x953;
    reactions[44] = x954;
    const double x1075 = -xpack161[3];
    reactions[62] = x1075;
    const three_ups_upu_s_vector4 xpack175 = xpack174 * xpack161;
    const three_ups_upu_s_vector4 xpack177 = xpack176 + xpack175;
    const three_ups_upu_s_vector4 xpack187 = xpack186 - xpack177;
    const double x723 = xpack187[0];
    const double x724 = -x723;
    reactions[10] = x724;
    const double x847 = -xpack187[1];
    reactions[27] = x847;
    const double x980 = -xpack187[2];
    reactions[46] = x980;
    const double x1093 = -xpack187[3];
    reactions[63] = x1093;
    const three_ups_upu_s_vector4 xpack167 = xpack166 * xpack161;
    const three_ups_upu_s_vector4 xpack168 = xpack164 - xpack167;
    const three_ups_upu_s_vector4 xpack170 = xgathered1 * xgathered20;
    const three_ups_upu_s_vector4 xpack171 = xpack170 + xpack169;
    const three_ups_upu_s_vector4 xpack172 = xpack168 - xpack171;
    const double x706 = -xpack172[0];
    reactions[9] = x706;
    const double x855 = -xpack172[1];
    reactions[28] = x855;
    const double x965 = xpack172[2];
    reactions[45] = x965;
    const double x1101 = xpack172[3];
    reactions[64] = x1101;
    const double x663 = x652 + x662;
    const three_ups_upu_s_vector4 xgathered22 = {x663, x796, x921, x1044};
    const three_ups_upu_s_vector4 xpack220 = (three_ups_upu_s_vector4){1.0, 2.0, 2.0, 2.0} * xgathered22;
    const three_ups_upu_s_vector4 xpack145 = xgathered1 * xpack141;
    const three_ups_upu_s_vector4 xpack142 = xgathered4 * xpack141;
    const three_ups_upu_s_vector4 xpack146 = xgathered4 * xpack220;
    const three_ups_upu_s_vector4 xpack147 = xpack146 - xpack145;
    const three_ups_upu_s_vector4 xpack133 = xgathered1 * xpack220;
    const three_ups_upu_s_vector4 xpack143 = xpack142 + xpack133;
    const double x674 = xpack143[0];
    reactions[3] = x674;
    const double x815 = xpack143[1];
    reactions[22] = x815;
    const double x933 = xpack143[2];
    const double x934 = -x933;
    reactions[39] = x934;
    const double x1061 = xpack143[3];
    const double x1062 = -x1061;
    reactions[58] = x1062;
    const three_ups_upu_s_vector4 xpack150 = xgathered8 * xpack147;
    const three_ups_upu_s_vector4 xpack148 = xgathered6 * xpack147;
    const three_ups_upu_s_vector4 xpack112 = xgathered1 * xpack105;
    const three_ups_upu_s_vector4 xpack106 = xgathered4 * xpack105;
    const three_ups_upu_s_vector4 xpack113 = xgathered4 * xpack109;
    const three_ups_upu_s_vector4 xpack114 = xpack112 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack113;
    const three_ups_upu_s_vector4 xpack110 = xgathered1 * xpack109;
    const three_ups_upu_s_vector4 xpack111 = xpack106 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack110;
    const double x619 = xpack111[0];
    reactions[0] = x619;
    const double x788 = xpack111[1];
    reactions[19] = x788;
    const double x901 = xpack111[2];
    reactions[36] = x901;
    const double x1035 = xpack111[3];
    reactions[55] = x1035;
    const three_ups_upu_s_vector4 xpack115 = xgathered6 * xpack114;
    const three_ups_upu_s_vector4 xpack124 = xgathered8 * xpack114;
    const three_ups_upu_s_vector4 xpack116 = (three_ups_upu_s_vector4){13.9302, 13.9302, 13.9302, 13.9302} *
        xgathered6;
    const three_ups_upu_s_vector4 xpack117 = xpack31 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack116;
    const three_ups_upu_s_vector4 xpack121 = xpack120 + xpack117;
    const three_ups_upu_s_vector4 xpack122 = xgathered8 * xpack121;
    const three_ups_upu_s_vector4 xpack123 = xpack115 + xpack122;
    const double x643 = xpack123[0];
    reactions[1] = x643;
    const double x784 = -xpack123[1];
    const double x785 = -x784;
    reactions[18] = x785;
    const double x911 = xpack123[2];
    const double x912 = -x911;
    reactions[37] = x912;
    const double x1031 = xpack123[3];
    const double x1032 = -x1031;
    reactions[54] = x1032;
    const three_ups_upu_s_vector4 xpack151 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack123;
    const three_ups_upu_s_vector4 xpack152 = xpack151 - xpack150;
    const double x684 = -xpack152[0];
    reactions[5] = x684;
    const double x818 = -xpack152[1];
    const double x819 = -x818;
    reactions[23] = x819;
    const double x943 = -xpack152[2];
    reactions[41] = x943;
    const double x1065 = xpack152[3];
    reactions[59] = x1065;
    const three_ups_upu_s_vector4 xpack125 = xgathered6 * xpack121;
    const three_ups_upu_s_vector4 xpack126 = xpack124 - xpack125;
    const double x646 = xpack126[0];
    const double x647 = -x646;
    reactions[2] = x647;
    const double x791 = xpack126[1];
    reactions[20] = x791;
    const double x915 = -xpack126[2];
    const double x916 = -x915;
    reactions[38] = x916;
    const double x1038 = -xpack126[3];
    reactions[56] = x1038;
    const three_ups_upu_s_vector4 xpack144 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack126;
    const three_ups_upu_s_vector4 xpack149 = xpack148 + xpack144;
    const double x680 = xpack149[0];
    const double x681 = -x680;
    reactions[4] = x681;
    const double x811 = xpack149[1];
    const double x812 = -x811;
    reactions[21] = x812;
    const double x940 = -xpack149[2];
    reactions[40] = x940;
    const double x1058 = -xpack149[3];
    reactions[57] = x1058;
    const three_ups_upu_s_vector4 every = (three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)((((xpack3 +
        xpack111) + (xpack143 + xpack149)) + ((xpack152 + xpack157) + (xpack172 + xpack187))) + xpack196) |
        ((xpack3 <= (three_ups_upu_s_vector4){6.233100000000001e-10, 6.3211e-10, 6.4044e-10, 6.284e-10}) &
        (xpack3 >= -(three_ups_upu_s_vector4){6.233100000000001e-10, 6.3211e-10, 6.4044e-10, 6.284e-10})));
    return fabs(x106) <= 4.0171000000000005e-10 || fabs(x575) <= 2.393867125597279e-10 || !(x58 >= 0.999999 &&
        x58 <= 1.000001) ? (double)NAN : (((((x106 + x575) + (x584 + x594)) + ((x646 + x694) + (x737 + x753)))
        + (((x760 + x767) + (x784 + x874)) + ((x880 + x884) + (x887 + x891)))) + ((((x911 + x915) + (x953 +
        x998)) + ((x1004 + x1008) + (x1011 + x1014))) + (((x1031 + x1116) + (x1128 + x1131)) + ((x1134 +
        x1167) + (x1186 + x1203))))) + ((every[0] + every[1]) + (every[2] + every[3]));
}
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
    if (isfinite(three_ups_upu_s_joint_reactions_packed_lane(q, v, a, u, reactions, sine, cosine))) {
        return 0;
    }
#endif
    return three_ups_upu_s_joint_reactions_limb_by_limb(q, v, a, u, reactions);
}
#endif /* THREE_UPS_UPU_S_VECTORS */
