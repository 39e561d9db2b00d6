/*
 * three_ups_upu_s: inverse_dynamics.
 *   inverse_dynamics; inverse_dynamics_independent; inverse_dynamics_preload;
 *   inverse_dynamics_platform
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

BODY(three_ups_upu_s_inverse_dynamics)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    /* limb1: geometry; accelerations; balance, eqs. (40)-(47) */
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    const REAL limb1_U_v_1 = READ(v, 1);
    const REAL minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x;
    const REAL limb1_U_a_0 = READ(a, 0), limb1_lower_cos = SINES(cosine, 1);
    const REAL minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_U_a_0 * limb1_lower_cos;
    const REAL limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y;
    const REAL t195 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    const REAL limb1_lower_rate_force_z = limb_lower_mx * limb1_lower_U_zx;
    const REAL t190 = limb1_upper_offset_x * limb1_lower_U_zx + gravity_z * limb1_U_0_sin;
    const REAL limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    const REAL limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y;
    const REAL limb1_P_v = READ(v, 2);
    const REAL minus_limb1_upper_acc_z = limb1_P_v * (2.0 * limb1_lower_omega_y) - t190;
    const REAL t191 = limb1_upper_offset_x * (limb_lower_m * minus_limb1_upper_acc_z + limb1_lower_rate_force_z);
    const REAL minus_limb1_lower_force_moment_y = limb_lower_mx * minus_limb1_upper_acc_z - t191 + (gravity_z_limb_lower_mx * limb1_U_0_sin + t195);
    const REAL t196 = limb1_lower_cos * minus_limb1_lower_force_moment_y;
    const REAL t203 = limb1_lower_omega_y * limb1_lower_omega_y;
    const REAL limb1_U_0_force_moment_z = limb1_lower_sin * (k10 * (limb1_U_v_1 * limb1_lower_omega_y)) - t196 + k3 * limb1_U_a_0;
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = limb1_U_0_pivot;
    const REAL t20 = 1.0 / limb1_U_0_pivot;
    /* limb1: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); accelerations */
    const REAL minus_limb1_U2_part_fz = t20 * limb1_U_0_force_moment_z;
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL t197 = minus_limb1_U2_arm_y * minus_limb1_U2_part_fz;
    const REAL t198 = limb1_lower_cos * t197;
    const REAL t235 = limb1_lower_sin * t197;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL t199 = limb1_U2_arm_x * minus_limb1_U2_part_fz;
    const REAL t201 = t198 - limb1_lower_sin * t199;
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_a_1 = READ(a, 1);
    const REAL t237 = t235 + limb1_lower_cos * t199;
    const REAL t202 = limb1_U_0_cos * t201;
    const REAL t266 = limb1_U_0_sin * t201;
    const REAL limb1_lower_U_yx = limb1_U_a_1 + limb1_lower_U_still_xy;
    const REAL t212 = k8 * limb1_lower_U_still_xy;
    const REAL t208 = limb1_upper_offset_x * limb1_lower_U_yx;
    const REAL limb1_lower_rate_force_y = limb_lower_mx * limb1_lower_U_yx;
    const REAL limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    const REAL minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y;
    const REAL limb1_upper_force_moment_z = limb_lower_mx * minus_limb1_lower_acc_y;
    const REAL limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y;
    const REAL limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) + (t208 - minus_limb1_lower_acc_y);
    const REAL t210 = limb1_upper_offset_x * (limb_lower_m * limb1_upper_acc_y - limb1_lower_rate_force_y);
    const REAL t211 = limb_lower_mx * limb1_upper_acc_y - t210;
    const REAL minus_limb1_lower_force_moment_z = t211 + (limb1_upper_force_moment_z - (t212 + k9 * limb1_U_a_1));
    const REAL t37 = limb1_lower_cos * t20;
    const REAL t215 = limb1_U2_arm_x * (minus_limb1_lower_force_moment_z * t37);
    const REAL minus_limb1_lower_U_still_xx = t203 + limb1_U_v_1 * limb1_U_v_1;
    const REAL limb1_lower_force_x = limb_lower_m * (READ(a, 2) - (limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x));
    const REAL t216 = minus_limb1_U2_arm_y * (limb_lower_mx * minus_limb1_lower_U_still_xx + limb1_lower_force_x) - t215;
    /* limb5_S: geometry; balance, eqs. (40)-(47); momentum rate, eq. (35) */
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
    const REAL platform_turn_zz = 1.0 - t11 * (t4 + t6);
    const REAL platform_turn_yy = 1.0 - t11 * (t4 + t7);
    const REAL platform_turn_xx = 1.0 - t8 * t11;
    const REAL t15 = limb5_S_q_qz * t11;
    const REAL t16 = limb5_S_q_qy * t15;
    const REAL t18 = limb5_S_q_qw * (limb5_S_q_qx * t11);
    const REAL t33 = limb5_S_q_qy * t11;
    const REAL platform_turn_zy = t16 + t18;
    const REAL limb5_S_v_wz = READ(v, 14);
    const REAL platform_turn_yz = t16 - t18;
    const REAL minus_platform_force_moment_x = gravity_z_platform_mz * platform_turn_zy;
    const REAL minus_platform_rate_moment_x = minus_platform_force_moment_x - (k12 * (READ(v, 13) * limb5_S_v_wz) + k13 * READ(a, 12));
    const REAL t230 = platform_turn_xx * minus_platform_rate_moment_x;
    const REAL t171 = limb5_S_q_qx * t15;
    const REAL t35 = limb5_S_q_qw * t15;
    const REAL t172 = limb5_S_q_qw * t33;
    const REAL t34 = limb5_S_q_qx * t33;
    const REAL platform_turn_zx = t171 - t172;
    const REAL platform_turn_xz = t171 + t172;
    const REAL t176 = platform_turn_zx * minus_platform_rate_moment_x;
    const REAL platform_force_moment_y = gravity_z_platform_mz * platform_turn_zx;
    const REAL platform_rate_moment_y = platform_force_moment_y - (k12 * (READ(v, 12) * limb5_S_v_wz) - k13 * READ(a, 13));
    const REAL t181 = t176 - platform_turn_zy * platform_rate_moment_y;
    const REAL platform_rate_moment_z = platform_Izz * READ(a, 14);
    /* limb2: velocities, eq. (6); geometry; accelerations */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3);
    const REAL t219 = t181 - platform_turn_zz * platform_rate_moment_z - t218; /* platform */
    const REAL t233 = platform_turn_xz * platform_rate_moment_z; /* platform */
    const REAL t264 = platform_turn_yz * platform_rate_moment_z; /* platform */
    const REAL limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin;
    const REAL limb2_U_v_1 = READ(v, 4);
    const REAL minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x;
    const REAL limb2_U_a_0 = READ(a, 3), limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y - limb2_U_a_0 * limb2_lower_cos;
    const REAL limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y;
    const REAL t145 = k9 * minus_limb2_lower_alpha_still_y + k8 * minus_limb2_lower_alpha_y;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL limb2_lower_rate_force_z = limb_lower_mx * limb2_lower_U_zx;
    const REAL t140 = limb2_upper_offset_x * limb2_lower_U_zx - gravity_z * minus_limb2_U_0_cos;
    const REAL limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos;
    const REAL limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y;
    const REAL limb2_P_v = READ(v, 5);
    const REAL minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) - t140;
    /* limb2: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t141 = limb2_upper_offset_x * (limb_lower_m * minus_limb2_upper_acc_z + limb2_lower_rate_force_z);
    const REAL t142 = limb_lower_mx * minus_limb2_upper_acc_z - t141;
    const REAL t146 = limb2_lower_cos * (t142 - (gravity_z_limb_lower_mx * minus_limb2_U_0_cos - t145));
    const REAL t154 = limb2_lower_omega_y * limb2_lower_omega_y;
    const REAL limb2_U_0_force_moment_z = limb2_lower_sin * (k10 * (limb2_U_v_1 * limb2_lower_omega_y)) - t146 + k3 * limb2_U_a_0;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = limb2_U_0_pivot;
    const REAL t135 = 1.0 / limb2_U_0_pivot;
    const REAL minus_limb2_S_multiplier_fz = t135 * limb2_U_0_force_moment_z;
    const REAL t166 = limb2_lower_cos * t135;
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL t147 = minus_limb2_S_arm_y * minus_limb2_S_multiplier_fz;
    const REAL t148 = limb2_lower_cos * t147;
    const REAL t258 = limb2_lower_sin * t147;
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t150 = limb2_S_arm_x * minus_limb2_S_multiplier_fz;
    const REAL t152 = t148 - limb2_lower_sin * t150;
    const REAL limb2_U_0_sin = SINES(cosine, 2), limb2_U_a_1 = READ(a, 4);
    const REAL t260 = t258 + limb2_lower_cos * t150;
    const REAL t153 = limb2_U_0_sin * t152;
    const REAL t239 = minus_limb2_U_0_cos * t152;
    const REAL limb2_lower_U_yx = limb2_U_a_1 + limb2_lower_U_still_xy;
    const REAL t163 = k8 * limb2_lower_U_still_xy;
    const REAL t159 = limb2_upper_offset_x * limb2_lower_U_yx;
    const REAL limb2_lower_rate_force_y = limb_lower_mx * limb2_lower_U_yx;
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y;
    const REAL minus_limb2_upper_force_moment_z = limb_lower_mx * limb2_lower_acc_y;
    const REAL minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y;
    const REAL limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + (t159 + limb2_lower_acc_y);
    const REAL t161 = limb2_upper_offset_x * (limb_lower_m * limb2_upper_acc_y - limb2_lower_rate_force_y);
    const REAL t162 = limb_lower_mx * limb2_upper_acc_y - t161;
    const REAL t167 = limb2_S_arm_x * ((t162 - (minus_limb2_upper_force_moment_z + (t163 + k9 * limb2_U_a_1))) * t166);
    const REAL minus_limb2_lower_U_still_xx = t154 + limb2_U_v_1 * limb2_U_v_1;
    const REAL limb2_lower_force_x = limb_lower_m * (READ(a, 5) - (limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x));
    const REAL t168 = minus_limb2_S_arm_y * (limb_lower_mx * minus_limb2_lower_U_still_xx + limb2_lower_force_x) - t167;
    /* limb3: velocities, eq. (6); geometry; accelerations */
    const REAL limb3_U_v_0 = READ(v, 6), minus_limb3_lower_sin = SINES(sine, 5);
    const REAL t220 = t153 + minus_limb2_U_0_cos * t168 + t219; /* platform */
    const REAL t241 = t239 - limb2_U_0_sin * t168; /* limb2 */
    const REAL minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin;
    const REAL limb3_U_v_1 = READ(v, 7);
    const REAL limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x;
    const REAL limb3_U_a_0 = READ(a, 6), limb3_lower_cos = SINES(cosine, 5);
    const REAL limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_U_a_0 * limb3_lower_cos;
    const REAL minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y;
    const REAL t109 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL minus_limb3_lower_rate_force_z = limb_lower_mx * minus_limb3_lower_U_zx;
    const REAL t104 = limb3_upper_offset_x * minus_limb3_lower_U_zx - gravity_z * limb3_U_0_sin;
    const REAL limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos;
    const REAL minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y;
    const REAL limb3_P_v = READ(v, 8);
    const REAL minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) + t104;
    /* limb3: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t105 = limb3_upper_offset_x * (limb_lower_m * minus_limb3_upper_acc_z - minus_limb3_lower_rate_force_z);
    const REAL minus_limb3_lower_force_moment_y = limb_lower_mx * minus_limb3_upper_acc_z - t105 + (gravity_z_limb_lower_mx * limb3_U_0_sin - t109);
    const REAL t110 = limb3_lower_cos * minus_limb3_lower_force_moment_y;
    const REAL t118 = limb3_lower_omega_y * limb3_lower_omega_y;
    const REAL minus_limb3_U_0_force_moment_z = minus_limb3_lower_sin * (k10 * (limb3_U_v_1 * limb3_lower_omega_y)) + t110 - k3 * limb3_U_a_0;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = limb3_U_0_pivot;
    const REAL t99 = 1.0 / limb3_U_0_pivot;
    const REAL limb3_S_multiplier_fz = t99 * minus_limb3_U_0_force_moment_z;
    const REAL t130 = limb3_lower_cos * t99;
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL t111 = limb3_S_arm_y * limb3_S_multiplier_fz;
    const REAL t112 = limb3_lower_cos * t111;
    const REAL t226 = minus_limb3_lower_sin * t111;
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t114 = limb3_S_arm_x * limb3_S_multiplier_fz;
    const REAL t116 = t112 - minus_limb3_lower_sin * t114;
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_a_1 = READ(a, 7);
    const REAL t228 = t226 + limb3_lower_cos * t114;
    const REAL t117 = limb3_U_0_cos * t116;
    const REAL t255 = limb3_U_0_sin * t116;
    const REAL limb3_lower_U_yx = limb3_U_a_1 - minus_limb3_lower_U_still_xy;
    const REAL t127 = k8 * minus_limb3_lower_U_still_xy;
    const REAL t123 = limb3_upper_offset_x * limb3_lower_U_yx;
    const REAL limb3_lower_rate_force_y = limb_lower_mx * limb3_lower_U_yx;
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y;
    const REAL minus_limb3_upper_force_moment_z = limb_lower_mx * limb3_lower_acc_y;
    const REAL limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y;
    const REAL limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + (t123 + limb3_lower_acc_y);
    const REAL t125 = limb3_upper_offset_x * (limb_lower_m * limb3_upper_acc_y - limb3_lower_rate_force_y);
    const REAL t126 = limb_lower_mx * limb3_upper_acc_y - t125;
    const REAL t131 = limb3_S_arm_x * ((t126 - (minus_limb3_upper_force_moment_z - (t127 - k9 * limb3_U_a_1))) * t130);
    const REAL minus_limb3_lower_U_still_xx = t118 + limb3_U_v_1 * limb3_U_v_1;
    const REAL limb3_lower_force_x = limb_lower_m * (READ(a, 8) - (limb3_upper_offset_x * minus_limb3_lower_U_still_xx - limb3_lower_acc_x));
    const REAL t132 = limb3_S_arm_y * (limb_lower_mx * minus_limb3_lower_U_still_xx + limb3_lower_force_x) + t131;
    /* limb4: velocities, eq. (6); geometry; accelerations */
    const REAL limb4_U_v_0 = READ(v, 9), minus_limb4_lower_sin = SINES(sine, 7);
    const REAL t221 = t117 - limb3_U_0_sin * t132 - t220; /* platform */
    const REAL t257 = t255 + limb3_U_0_cos * t132; /* limb3 */
    const REAL minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin;
    const REAL limb4_U_v_1 = READ(v, 10);
    const REAL limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x;
    const REAL limb4_U_a_0 = READ(a, 9), limb4_lower_cos = SINES(cosine, 7);
    const REAL limb4_lower_alpha_y = limb4_lower_alpha_still_y + limb4_U_a_0 * limb4_lower_cos;
    const REAL minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y;
    const REAL t73 = k9 * limb4_lower_alpha_still_y + k8 * limb4_lower_alpha_y;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL minus_limb4_lower_rate_force_z = limb_lower_mx * minus_limb4_lower_U_zx;
    const REAL t68 = limb4_upper_offset_x * minus_limb4_lower_U_zx + gravity_z * minus_limb4_U_0_cos;
    const REAL limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos;
    const REAL minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y;
    const REAL limb4_P_v = READ(v, 11);
    const REAL minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + t68;
    /* limb4: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t69 = limb4_upper_offset_x * (limb_lower_m * minus_limb4_upper_acc_z - minus_limb4_lower_rate_force_z);
    const REAL t70 = limb_lower_mx * minus_limb4_upper_acc_z - t69;
    const REAL t74 = limb4_lower_cos * (t70 - (gravity_z_limb_lower_mx * minus_limb4_U_0_cos + t73));
    const REAL t82 = limb4_lower_omega_y * limb4_lower_omega_y;
    const REAL minus_limb4_U_0_force_moment_z = minus_limb4_lower_sin * (k10 * (limb4_U_v_1 * limb4_lower_omega_y)) + t74 - k3 * limb4_U_a_0;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked3 = limb4_U_0_pivot;
    const REAL t63 = 1.0 / limb4_U_0_pivot;
    const REAL limb4_S_multiplier_fz = t63 * minus_limb4_U_0_force_moment_z;
    const REAL t94 = limb4_lower_cos * t63;
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL t75 = limb4_S_arm_y * limb4_S_multiplier_fz;
    const REAL t76 = limb4_lower_cos * t75;
    const REAL t252 = minus_limb4_lower_sin * t75;
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t78 = limb4_S_arm_x * limb4_S_multiplier_fz;
    const REAL t80 = t76 - minus_limb4_lower_sin * t78;
    const REAL limb4_U_0_sin = SINES(cosine, 6), limb4_U_a_1 = READ(a, 10);
    const REAL t254 = t252 + limb4_lower_cos * t78;
    const REAL t81 = limb4_U_0_sin * t80;
    const REAL t223 = minus_limb4_U_0_cos * t80;
    const REAL limb4_lower_U_yx = limb4_U_a_1 - minus_limb4_lower_U_still_xy;
    const REAL t91 = k8 * minus_limb4_lower_U_still_xy;
    const REAL t87 = limb4_upper_offset_x * limb4_lower_U_yx;
    const REAL limb4_lower_rate_force_y = limb_lower_mx * limb4_lower_U_yx;
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y;
    const REAL limb4_upper_force_moment_z = limb_lower_mx * minus_limb4_lower_acc_y;
    const REAL minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y;
    const REAL limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) + (t87 - minus_limb4_lower_acc_y);
    const REAL t89 = limb4_upper_offset_x * (limb_lower_m * limb4_upper_acc_y - limb4_lower_rate_force_y);
    const REAL minus_limb4_lower_force_moment_z = limb_lower_mx * limb4_upper_acc_y - t89 + (limb4_upper_force_moment_z + (t91 - k9 * limb4_U_a_1));
    const REAL t95 = limb4_S_arm_x * (minus_limb4_lower_force_moment_z * t94);
    const REAL minus_limb4_lower_U_still_xx = t82 + limb4_U_v_1 * limb4_U_v_1;
    const REAL limb4_upper_acc_x = READ(a, 11) - (limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_lower_acc_x);
    const REAL t84 = limb4_S_arm_y * (limb_lower_mx * minus_limb4_lower_U_still_xx + limb_lower_m * limb4_upper_acc_x);
    const REAL t96 = t84 + t95;
    const REAL minus_platform_joint_force_moment_z = t81 - minus_limb4_U_0_cos * t96 - t221;
    const REAL t225 = t223 + limb4_U_0_sin * t96;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; balance, eqs. (40)-(47) */
    const REAL t30 = limb1_U_0_cos * platform_turn_zy;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t20;
    const REAL t22 = limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3;
    const REAL t25 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3;
    const REAL t47 = limb1_lower_sin * t22;
    const REAL t27 = limb1_lower_cos * t22 + limb1_lower_sin * t25;
    const REAL t49 = t47 - limb1_lower_cos * t25; /* platform */
    const REAL t42 = limb1_U_0_cos * t27;
    const REAL t28 = limb1_U_0_sin * t27;
    const REAL t32 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - t30);
    /* limb5_S: balance, eqs. (40)-(47); geometry; drives */
    const REAL t262 = platform_turn_yy * platform_rate_moment_y;
    const REAL platform_turn_xy = t34 - t35;
    const REAL t270 = t260 - ((t34 + t35) * minus_platform_rate_moment_x - t262 - t264 + t268);
    const REAL minus_platform_joint_force_moment_y = t254 + (t257 - t270);
    const REAL t243 = t228 + (t230 - platform_turn_xy * platform_rate_moment_y - t233 - t237 + t241);
    const REAL minus_platform_joint_force_moment_x = t225 + t243;
    const REAL limb1_U2_constraint_mn_couple_z = t32 - limb1_lower_sin * platform_turn_xy;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * (limb1_U2_constraint_mn_couple_z * t37);
    const REAL platform_pivot = t42 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    checked0 = checked0 + platform_pivot;
    const REAL t44 = 1.0 / platform_pivot;
    const REAL limb1_U2_part_mn = t44 * minus_platform_joint_force_moment_z;
    const REAL t40 = t28 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL limb5_S_balance_wx = t49 * limb1_U2_part_mn - minus_platform_joint_force_moment_x;
    const REAL minus_limb5_S_balance_wy = t40 * limb1_U2_part_mn + minus_platform_joint_force_moment_y;
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
    const REAL t51 = t49 * limb1_U2_part_mn_by_limb4_P;
    const REAL minus_limb5_S_balance_wy_by_limb4_P = limb1_U2_part_mn_by_limb4_P * t40;
    const REAL limb5_S_balance_wx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y + t51;
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
    RESULT(checked2, u, 0, -(minus_limb5_S_balance_wy_by_limb1_P * t283 + limb5_S_balance_wx_by_limb1_P * t288));
    RESULT(checked3, u, 1, limb5_S_balance_wy_by_limb2_P * t283 + minus_limb5_S_balance_wx_by_limb2_P * t288);
    const REAL t294 = minus_limb5_S_balance_wy_by_limb4_P * t283; /* limb4 */
    RESULT(checked0, u, 2, limb5_S_balance_wy_by_limb3_P * t283 + minus_limb5_S_balance_wx_by_limb3_P * t288);
    RESULT(checked1, u, 3, -(t294 + limb5_S_balance_wx_by_limb4_P * t288));
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

BODY(three_ups_upu_s_inverse_dynamics_independent)(size_t stride, const double *restrict q,
    const double *restrict y_dot, const double *restrict y_ddot, double *restrict u,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry; rates that follow */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t3 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t4 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t5 = t3 + t4;
    const REAL t6 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t7 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t8 = t6 + t7;
    const REAL t9 = t5 + t8;
    const REAL t12 = t4 + t7;
    const REAL t115 = t4 + t6;
    const REAL t11 = 4.0 - 2.0 * t9;
    const REAL platform_turn_yy = 1.0 - t11 * t12;
    const REAL t81 = k2 - 0.5 * t9;
    const REAL platform_turn_xx = 1.0 - t8 * t11;
    const REAL platform_turn_zz = 1.0 - t11 * t115;
    const REAL t15 = limb5_S_q_qz * t11;
    const REAL t16 = limb5_S_q_qy * t15;
    const REAL t18 = limb5_S_q_qw * (limb5_S_q_qx * t11);
    const REAL t33 = limb5_S_q_qy * t11;
    const REAL platform_turn_zy = t16 + t18;
    const REAL platform_turn_yz = t16 - t18;
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0);
    const REAL t31 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy; /* limb1 */
    const REAL limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1);
    const REAL t32 = limb1_lower_cos * t31; /* limb1 */
    const REAL t179 = limb1_lower_sin * t31; /* limb1 */
    const REAL t34 = limb5_S_q_qx * t33;
    const REAL t114 = limb5_S_q_qw * t33;
    const REAL t35 = limb5_S_q_qw * t15;
    const REAL t113 = limb5_S_q_qx * t15;
    const REAL platform_turn_xy = t34 - t35;
    const REAL platform_turn_yx = t34 + t35;
    /* limb1: reciprocal wrenches, eq. (10); geometry; rates that follow */
    const REAL limb1_U2_constraint_mn_couple_z = t32 - limb1_lower_sin * platform_turn_xy;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = limb1_U_0_pivot;
    const REAL t20 = 1.0 / limb1_U_0_pivot;
    const REAL t37 = limb1_lower_cos * t20;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t37;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL t43 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    const REAL t39 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t20;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t84 = minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3;
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t84;
    /* limb5_S: pivots */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t43;
    REAL checked1 = minus_limb5_S_pivot_wz;
    /* limb5_S: rates that follow */
    const REAL t86 = 1.0 / minus_limb5_S_pivot_wz;
    const REAL t88 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t39; /* limb1 */
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t86 * t88;
    const REAL t83 = limb5_S_q_qx * t81;
    const REAL t89 = t83 * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL t82 = limb5_S_q_qw * t81;
    const REAL a_pivot = 0.5 * (t82 + t89);
    REAL checked2 = a_pivot;
    const REAL t91 = 1.0 / a_pivot;
    const REAL t95 = limb5_S_q_qy * t81;
    const REAL t96 = t95 * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL t92 = limb5_S_q_qz * t81;
    const REAL t99 = t91 * (0.5 * (t92 - t96));
    const REAL t93 = 0.5 * t92;
    const REAL a_pivot_2 = 0.5 * t82 + t93 * t99;
    REAL checked3 = a_pivot_2;
    const REAL limb5_S_null_space_wx_by_limb5_S_qx = 1.0 / a_pivot_2;
    /* platform: velocities, eq. (6); accelerations; geometry */
    const REAL limb5_S_y_dot_qy = READ(y_dot, 1);
    const REAL limb5_S_joint_rate_wx = limb5_S_null_space_wx_by_limb5_S_qx * (READ(y_dot, 0) - limb5_S_y_dot_qy * t99);
    const REAL limb5_S_joint_rate_wy = t91 * (limb5_S_y_dot_qy + t93 * limb5_S_joint_rate_wx);
    const REAL limb5_S_joint_rate_wz = t86 * (t88 * limb5_S_joint_rate_wy);
    const REAL t122 = platform_turn_zy * limb5_S_joint_rate_wz;
    const REAL platform_omega_y = t122 + (platform_turn_yy * limb5_S_joint_rate_wy + platform_turn_xy * limb5_S_joint_rate_wx);
    const REAL t141 = platform_turn_zy * platform_omega_y;
    const REAL platform_turn_zx = t113 - t114;
    const REAL platform_turn_xz = t113 + t114;
    const REAL t128 = platform_turn_zx * limb5_S_joint_rate_wz;
    const REAL platform_omega_x = t128 + (platform_turn_yx * limb5_S_joint_rate_wy + platform_turn_xx * limb5_S_joint_rate_wx);
    /* platform: accelerations; velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t143 = t141 + platform_turn_zx * platform_omega_x;
    const REAL t117 = platform_turn_zz * limb5_S_joint_rate_wz;
    const REAL platform_omega_z = t117 + (platform_turn_yz * limb5_S_joint_rate_wy + platform_turn_xz * limb5_S_joint_rate_wx);
    const REAL t144 = platform_turn_zz * platform_omega_z + t143;
    const REAL t145 = limb1_U_0_cos * t144;
    const REAL t149 = platform_turn_yy * platform_omega_y + platform_turn_yx * platform_omega_x;
    const REAL t150 = platform_turn_yz * platform_omega_z + t149;
    const REAL t152 = t145 - limb1_U_0_sin * t150;
    const REAL t183 = limb1_lower_sin * t152; /* limb1 */
    const REAL t564 = k12 * (platform_omega_z * platform_omega_y);
    const REAL t133 = platform_turn_xy * platform_omega_y + platform_turn_xx * platform_omega_x;
    const REAL platform_U_still_xz = platform_omega_z * platform_omega_x;
    const REAL t134 = platform_turn_xz * platform_omega_z + t133;
    const REAL t556 = k12 * platform_U_still_xz;
    /* limb1: loop closure; velocities, eq. (6); accelerations */
    const REAL t184 = limb1_lower_cos * t134 - t183;
    const REAL t157 = minus_limb1_upper_position_x * (limb1_U_0_cos * limb5_S_joint_rate_wz - limb1_U_0_sin * limb5_S_joint_rate_wy);
    const REAL limb1_U_joint_rate_0 = limb5_S_joint_rate_wx + t20 * t157;
    const REAL limb1_lower_omega_y = limb1_lower_cos * limb1_U_joint_rate_0;
    const REAL t185 = t184 - limb1_lower_omega_y;
    const REAL t108 = limb1_U_0_sin * limb5_S_joint_rate_wz + limb1_U_0_cos * limb5_S_joint_rate_wy;
    const REAL limb1_U_joint_rate_1 = t37 * (limb1_U2_arm_x * t108);
    const REAL t202 = limb1_U_joint_rate_1 * t185;
    const REAL t162 = limb1_U_0_sin * t144 + limb1_U_0_cos * t150; /* limb5_S */
    const REAL t178 = limb1_U_joint_rate_1 - t162;
    const REAL t204 = t202 + t178 * limb1_lower_omega_y;
    const REAL limb1_lower_alpha_still_x = limb1_U_joint_rate_1 * limb1_lower_omega_y;
    const REAL t206 = limb1_U2_constraint_mn_couple_x * (t204 - limb1_lower_alpha_still_x);
    const REAL t593 = limb1_lower_sin * (k10 * limb1_lower_alpha_still_x);
    const REAL t191 = limb1_lower_sin * t134 + limb1_lower_cos * t152;
    const REAL limb1_lower_omega_x = limb1_lower_sin * limb1_U_joint_rate_0;
    const REAL t192 = t191 - limb1_lower_omega_x;
    const REAL t207 = limb1_U2_constraint_mn_couple_z * (limb1_lower_omega_y * t192 - t185 * limb1_lower_omega_x) + t206;
    const REAL t193 = limb1_U2_constraint_mn_couple_z * t185;
    const REAL t186 = limb1_U2_constraint_mn_couple_x * t185;
    const REAL limb1_U2_opening_mn = t179 + limb1_lower_cos * platform_turn_xy;
    const REAL t188 = t178 * (limb1_U2_opening_mn * t178 + t186);
    const REAL minus_limb1_U2_opening_bias_mn = t188 + t192 * (t193 + limb1_U2_opening_mn * t192) + t207;
    const REAL t173 = limb1_U_joint_rate_0 * t152; /* limb5_S */
    const REAL t174 = limb1_U2_arm_x * t173; /* limb5_S */
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL limb1_P_joint_rate = minus_limb1_U2_arm_y * t108;
    const REAL t610 = minus_limb1_U2_arm_y * t173;
    const REAL t175 = limb1_P_joint_rate * limb1_U_joint_rate_1 - t174; /* limb5_S */
    const REAL t137 = limb1_lower_cos * limb1_U_joint_rate_1;
    /* limb5_S: accelerations */
    const REAL t176 = t162 * (limb1_P_joint_rate - param_R * t137) - t175;
    const REAL t208 = limb1_U_factor_1_by_3 * t176 - minus_limb1_U2_opening_bias_mn;
    const REAL t138 = limb1_upper_offset_x * t137; /* limb1 */
    const REAL t164 = minus_limb1_upper_position_x * (limb1_U_joint_rate_0 * t162);
    const REAL t110 = limb1_lower_sin * limb1_U_joint_rate_1; /* limb1 */
    const REAL t611 = t162 * (param_R * t110) - t610; /* limb1 */
    const REAL t112 = limb1_lower_cos * limb1_P_joint_rate - limb1_upper_offset_x * t110; /* limb1 */
    const REAL t135 = t112 * t134;
    const REAL t166 = (limb1_lower_sin * limb1_P_joint_rate + t138) * t152 + (limb1_U_joint_rate_0 * t112 + t164);
    const REAL t167 = t135 - t166;
    const REAL limb5_S_joint_acc_still_wz = t86 * (minus_limb1_U_factor_0_by_3 * t167 + t208);
    const REAL t211 = 0.5 * (t83 * limb5_S_joint_acc_still_wz);
    const REAL t217 = 0.5 * (t83 * t150 - t95 * t134 - t82 * t144);
    const REAL t218 = t134 * t217;
    const REAL t248 = t150 * t217;
    const REAL t224 = 0.5 * (t95 * t144 - t92 * t150 - t82 * t134);
    const REAL t226 = t218 - t144 * t224;
    const REAL t244 = t82 * t150;
    const REAL t240 = 0.5 * (t95 * limb5_S_joint_acc_still_wz);
    const REAL t242 = t83 * t144;
    const REAL t232 = 0.5 * (t92 * t144 + (t95 * t150 + t83 * t134));
    const REAL t249 = t144 * (0.5 * (t92 * t134 - t242 - t244)) - t248;
    const REAL t237 = t211 - (READ(y_ddot, 1) - 0.5 * (t226 - t150 * t232));
    const REAL t238 = t99 * t237;
    const REAL t255 = t238 + (t240 + (READ(y_ddot, 0) - 0.5 * (t249 - t134 * t232)));
    const REAL limb5_S_joint_acc_wx = limb5_S_null_space_wx_by_limb5_S_qx * t255;
    const REAL minus_limb5_S_joint_acc_wy = t91 * (t237 - t93 * limb5_S_joint_acc_wx);
    const REAL t260 = t86 * (t88 * minus_limb5_S_joint_acc_wy); /* limb4 */
    /* limb1: accelerations; momentum rate, eq. (35) */
    const REAL t577 = minus_limb1_upper_position_x * (limb1_U_0_cos * t260 - limb1_U_0_sin * minus_limb5_S_joint_acc_wy);
    const REAL t579 = limb5_S_joint_acc_wx - t20 * t577;
    const REAL limb1_U_joint_acc_0 = t579 + t20 * (t167 + minus_limb1_upper_position_x * (limb1_U_0_cos * limb5_S_joint_acc_still_wz));
    const REAL limb1_lower_U_xz = limb1_lower_cos * limb1_U_joint_acc_0;
    const REAL limb1_U_0_rate_moment_z = k3 * limb1_U_joint_acc_0;
    const REAL minus_limb1_lower_alpha_still_y = limb1_U_joint_rate_1 * limb1_lower_omega_x;
    const REAL minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_lower_U_xz;
    const REAL limb1_lower_U_still_xy = limb1_lower_omega_y * limb1_lower_omega_x;
    const REAL limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y;
    const REAL t585 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y;
    const REAL limb1_lower_rate_force_z = limb_lower_mx * limb1_lower_U_zx;
    const REAL t587 = gravity_z * limb1_U_0_sin + limb1_upper_offset_x * limb1_lower_U_zx;
    const REAL limb1_upper_acc_z = t587 - limb1_P_joint_rate * (2.0 * limb1_lower_omega_y);
    const REAL t601 = limb1_lower_omega_y * limb1_lower_omega_y;
    /* limb1: balance, eqs. (40)-(47) */
    const REAL t590 = limb1_upper_offset_x * (limb1_lower_rate_force_z - limb_lower_m * limb1_upper_acc_z);
    const REAL t592 = limb1_lower_cos * (gravity_z_limb_lower_mx * limb1_U_0_sin + t585 - (t590 + limb_lower_mx * limb1_upper_acc_z));
    const REAL minus_limb1_U2_part_fz = t20 * (limb1_U_0_rate_moment_z - (t592 - t593));
    const REAL t594 = limb1_U2_arm_x * minus_limb1_U2_part_fz;
    const REAL t596 = minus_limb1_U2_arm_y * minus_limb1_U2_part_fz;
    const REAL t640 = limb1_lower_cos * t594;
    const REAL t598 = limb1_lower_sin * t594 - limb1_lower_cos * t596;
    const REAL t642 = t640 + limb1_lower_sin * t596;
    const REAL t599 = limb1_U_0_cos * t598;
    const REAL t670 = limb1_U_0_sin * t598;
    /* limb1: accelerations; momentum rate, eq. (35) */
    const REAL t604 = limb1_U_0_sin * t260 + limb1_U_0_cos * minus_limb5_S_joint_acc_wy;
    const REAL t614 = limb1_U2_arm_x * t604;
    const REAL t605 = minus_limb1_U2_arm_y * t604;
    const REAL t606 = limb1_U_0_sin * limb5_S_joint_acc_still_wz;
    const REAL minus_limb1_U_joint_acc_1 = t37 * (t614 - (t176 + limb1_U2_arm_x * t606));
    const REAL minus_limb1_P_joint_acc = t605 - (minus_limb1_U2_arm_y * t606 - t611);
    const REAL limb1_lower_U_yx = limb1_lower_U_still_xy - minus_limb1_U_joint_acc_1;
    const REAL t619 = k8 * limb1_lower_U_still_xy - k9 * minus_limb1_U_joint_acc_1;
    const REAL t622 = limb1_upper_offset_x * limb1_lower_U_yx;
    const REAL limb1_lower_rate_force_y = limb_lower_mx * limb1_lower_U_yx;
    const REAL limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    const REAL minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y;
    const REAL minus_limb1_lower_rate_moment_z = limb_lower_mx * minus_limb1_lower_acc_y - t619;
    const REAL limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y;
    const REAL limb1_upper_acc_y = limb1_P_joint_rate * (2.0 * limb1_U_joint_rate_1) - (minus_limb1_lower_acc_y - t622);
    const REAL minus_limb1_lower_U_still_xx = limb1_U_joint_rate_1 * limb1_U_joint_rate_1 + t601;
    /* limb1: balance, eqs. (40)-(47); accelerations */
    const REAL t624 = limb1_upper_offset_x * (limb1_lower_rate_force_y - limb_lower_m * limb1_upper_acc_y);
    const REAL t626 = limb1_U2_arm_x * (t37 * (minus_limb1_lower_rate_moment_z + (t624 + limb_lower_mx * limb1_upper_acc_y)));
    const REAL limb1_upper_acc_x = limb1_lower_acc_x - limb1_upper_offset_x * minus_limb1_lower_U_still_xx - minus_limb1_P_joint_acc;
    const REAL t612 = minus_limb1_U2_arm_y * (limb_lower_mx * minus_limb1_lower_U_still_xx + limb_lower_m * limb1_upper_acc_x);
    const REAL t627 = t612 - t626;
    const REAL t25 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3;
    const REAL t22 = limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3;
    const REAL t629 = t599 - limb1_U_0_sin * t627;
    const REAL t672 = t670 + limb1_U_0_cos * t627;
    /* platform: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz - t260;
    const REAL t557 = platform_turn_zy * limb5_S_joint_acc_wz;
    const REAL platform_alpha_y = t557 - (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy * limb5_S_joint_acc_wx);
    const REAL platform_rate_moment_y = gravity_z_platform_mz * platform_turn_zx - (t556 - k13 * platform_alpha_y);
    const REAL t644 = platform_turn_xy * platform_rate_moment_y;
    const REAL t666 = platform_turn_yy * platform_rate_moment_y;
    const REAL t563 = platform_turn_zy * platform_rate_moment_y;
    const REAL minus_platform_force_moment_x = gravity_z_platform_mz * platform_turn_zy;
    const REAL t565 = platform_turn_zx * limb5_S_joint_acc_wz;
    const REAL t551 = platform_turn_zz * limb5_S_joint_acc_wz;
    const REAL platform_alpha_x = t565 - (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx * limb5_S_joint_acc_wx);
    const REAL minus_platform_rate_moment_x = minus_platform_force_moment_x - (t564 + k13 * platform_alpha_x);
    const REAL t572 = t563 - platform_turn_zx * minus_platform_rate_moment_x;
    const REAL t646 = t644 - platform_turn_xx * minus_platform_rate_moment_x;
    const REAL t668 = t666 - platform_turn_yx * minus_platform_rate_moment_x;
    const REAL platform_alpha_z = t551 - (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz * limb5_S_joint_acc_wx);
    const REAL platform_rate_moment_z = platform_Izz * platform_alpha_z;
    /* limb2: geometry; accelerations; velocities, eq. (6) */
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL t630 = platform_turn_zz * platform_rate_moment_z + t572 - t629; /* platform */
    const REAL t648 = t642 + (platform_turn_xz * platform_rate_moment_z + t646); /* platform */
    const REAL t673 = platform_turn_yz * platform_rate_moment_z + t668 + t672; /* platform */
    const REAL t458 = limb2_U_0_sin * t260 - minus_limb2_U_0_cos * limb5_S_joint_acc_wx;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL t459 = minus_limb2_upper_position_y * t458;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    checked0 = checked0 + limb2_U_0_pivot;
    const REAL t455 = 1.0 / limb2_U_0_pivot;
    const REAL t461 = minus_limb5_S_joint_acc_wy - t455 * t459;
    const REAL t463 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_joint_acc_still_wz);
    const REAL t489 = limb2_U_0_sin * t134 - minus_limb2_U_0_cos * t144;
    const REAL t484 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_joint_rate_wz + minus_limb2_U_0_cos * limb5_S_joint_rate_wx);
    const REAL limb2_U_joint_rate_0 = limb5_S_joint_rate_wy - t455 * t484;
    const REAL t491 = minus_limb2_upper_position_y * (limb2_U_joint_rate_0 * t489);
    const REAL t466 = minus_limb2_U_0_cos * limb5_S_joint_rate_wz - limb2_U_0_sin * limb5_S_joint_rate_wx;
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL minus_limb2_upper_vel_y = limb2_S_arm_x * t466;
    const REAL t468 = limb2_lower_cos * t455;
    const REAL minus_limb2_U_joint_rate_1 = minus_limb2_upper_vel_y * t468;
    /* limb2: accelerations; velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t469 = limb2_lower_sin * minus_limb2_U_joint_rate_1;
    const REAL t470 = limb2_upper_offset_x * t469;
    const REAL t522 = t489 * (param_R * t469);
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL minus_limb2_P_joint_rate = minus_limb2_S_arm_y * t466;
    const REAL t471 = limb2_lower_cos * minus_limb2_P_joint_rate - t470;
    const REAL t492 = limb2_U_joint_rate_0 * t471 - t491;
    const REAL t472 = t150 * t471;
    const REAL t474 = limb2_lower_cos * minus_limb2_U_joint_rate_1;
    const REAL t532 = t489 * (minus_limb2_P_joint_rate - param_R * t474);
    const REAL t476 = limb2_lower_sin * minus_limb2_P_joint_rate + limb2_upper_offset_x * t474;
    const REAL t479 = minus_limb2_U_0_cos * t134 + limb2_U_0_sin * t144;
    const REAL minus_limb2_U_joint_acc_0 = t461 + t455 * (t463 + (t472 + (t476 * t479 - t492)));
    const REAL t523 = limb2_U_joint_rate_0 * t479;
    const REAL minus_limb2_lower_U_xz = limb2_lower_cos * minus_limb2_U_joint_acc_0;
    const REAL minus_limb2_U_0_rate_moment_z = k3 * minus_limb2_U_joint_acc_0;
    const REAL limb2_lower_omega_x = limb2_lower_sin * limb2_U_joint_rate_0;
    const REAL limb2_lower_omega_y = limb2_lower_cos * limb2_U_joint_rate_0;
    const REAL limb2_lower_alpha_still_y = minus_limb2_U_joint_rate_1 * limb2_lower_omega_x;
    const REAL limb2_lower_alpha_y = limb2_lower_alpha_still_y - minus_limb2_lower_U_xz;
    const REAL limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y;
    const REAL minus_limb2_lower_U_zx = limb2_lower_alpha_still_y + limb2_lower_alpha_y;
    const REAL t498 = k9 * limb2_lower_alpha_still_y + k8 * limb2_lower_alpha_y;
    const REAL minus_limb2_lower_rate_force_z = limb_lower_mx * minus_limb2_lower_U_zx;
    const REAL t500 = gravity_z * minus_limb2_U_0_cos + limb2_upper_offset_x * minus_limb2_lower_U_zx;
    const REAL minus_limb2_upper_acc_z = t500 - minus_limb2_P_joint_rate * (2.0 * limb2_lower_omega_y);
    /* limb2: balance, eqs. (40)-(47); accelerations */
    const REAL t503 = limb2_upper_offset_x * (minus_limb2_lower_rate_force_z - limb_lower_m * minus_limb2_upper_acc_z);
    const REAL t504 = t503 + limb_lower_mx * minus_limb2_upper_acc_z;
    const REAL t505 = limb2_lower_cos * (gravity_z_limb_lower_mx * minus_limb2_U_0_cos + t498 - t504);
    const REAL minus_limb2_U_0_force_moment_z = minus_limb2_U_0_rate_moment_z - (t505 - limb2_lower_sin * (k10 * (minus_limb2_U_joint_rate_1 * limb2_lower_omega_y)));
    const REAL limb2_S_multiplier_fz = t455 * minus_limb2_U_0_force_moment_z;
    const REAL t514 = limb2_lower_omega_y * limb2_lower_omega_y;
    const REAL t507 = limb2_S_arm_x * limb2_S_multiplier_fz;
    const REAL t509 = minus_limb2_S_arm_y * limb2_S_multiplier_fz;
    const REAL t662 = limb2_lower_cos * t507;
    const REAL t511 = limb2_lower_sin * t507 - limb2_lower_cos * t509;
    const REAL t674 = t662 + limb2_lower_sin * t509 - t673; /* platform */
    const REAL t512 = limb2_U_0_sin * t511;
    const REAL t649 = minus_limb2_U_0_cos * t511;
    /* limb2: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL t517 = minus_limb2_U_0_cos * t260 + limb2_U_0_sin * limb5_S_joint_acc_wx;
    const REAL t528 = limb2_S_arm_x * t517;
    const REAL t518 = minus_limb2_S_arm_y * t517;
    const REAL t519 = minus_limb2_U_0_cos * limb5_S_joint_acc_still_wz;
    const REAL t529 = limb2_S_arm_x * t519;
    const REAL limb2_P_joint_acc = t518 - (minus_limb2_S_arm_y * t519 - (t522 - minus_limb2_S_arm_y * t523));
    const REAL t537 = t529 + (t532 + (minus_limb2_P_joint_rate * minus_limb2_U_joint_rate_1 + limb2_S_arm_x * t523));
    const REAL limb2_U_joint_acc_1 = t468 * (t528 - t537);
    const REAL limb2_lower_U_yx = limb2_lower_U_still_xy + limb2_U_joint_acc_1;
    const REAL t540 = k8 * limb2_lower_U_still_xy + k9 * limb2_U_joint_acc_1;
    const REAL t543 = limb2_upper_offset_x * limb2_lower_U_yx;
    const REAL limb2_lower_rate_force_y = limb_lower_mx * limb2_lower_U_yx;
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y;
    const REAL limb2_lower_rate_moment_z = limb_lower_mx * limb2_lower_acc_y + t540;
    const REAL minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y;
    const REAL limb2_upper_acc_y = minus_limb2_P_joint_rate * (2.0 * minus_limb2_U_joint_rate_1) + (limb2_lower_acc_y + t543);
    const REAL minus_limb2_lower_U_still_xx = minus_limb2_U_joint_rate_1 * minus_limb2_U_joint_rate_1 + t514;
    const REAL t545 = limb2_upper_offset_x * (limb2_lower_rate_force_y - limb_lower_m * limb2_upper_acc_y);
    const REAL t547 = limb2_S_arm_x * (t468 * (limb2_lower_rate_moment_z - (t545 + limb_lower_mx * limb2_upper_acc_y)));
    const REAL minus_limb2_upper_acc_x = minus_limb2_lower_acc_x + limb2_upper_offset_x * minus_limb2_lower_U_still_xx - limb2_P_joint_acc;
    const REAL t526 = minus_limb2_S_arm_y * (limb_lower_mx * minus_limb2_lower_U_still_xx - limb_lower_m * minus_limb2_upper_acc_x);
    const REAL t548 = t526 + t547;
    /* limb3: geometry; accelerations; velocities, eq. (6) */
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_0_sin = SINES(sine, 4);
    const REAL t631 = t512 + minus_limb2_U_0_cos * t548 - t630; /* platform */
    const REAL t652 = t648 - (t649 - limb2_U_0_sin * t548); /* platform */
    const REAL t361 = limb3_U_0_cos * t260 - limb3_U_0_sin * minus_limb5_S_joint_acc_wy;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL t362 = limb3_upper_position_x * t361;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    checked1 = checked1 + limb3_U_0_pivot;
    const REAL t357 = 1.0 / limb3_U_0_pivot;
    const REAL t364 = limb5_S_joint_acc_wx + t357 * t362;
    const REAL t366 = limb3_upper_position_x * (limb3_U_0_cos * limb5_S_joint_acc_still_wz);
    const REAL t392 = limb3_U_0_sin * t144 + limb3_U_0_cos * t150;
    const REAL t387 = limb3_upper_position_x * (limb3_U_0_cos * limb5_S_joint_rate_wz - limb3_U_0_sin * limb5_S_joint_rate_wy);
    const REAL limb3_U_joint_rate_0 = limb5_S_joint_rate_wx - t357 * t387;
    const REAL t394 = limb3_upper_position_x * (limb3_U_joint_rate_0 * t392);
    const REAL t369 = limb3_U_0_sin * limb5_S_joint_rate_wz + limb3_U_0_cos * limb5_S_joint_rate_wy;
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL limb3_upper_vel_y = limb3_S_arm_x * t369;
    const REAL t371 = limb3_lower_cos * t357;
    const REAL limb3_U_joint_rate_1 = limb3_upper_vel_y * t371;
    /* limb3: accelerations; velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t372 = minus_limb3_lower_sin * limb3_U_joint_rate_1;
    const REAL t373 = limb3_upper_offset_x * t372;
    const REAL t425 = t392 * (param_R * t372);
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL minus_limb3_P_joint_rate = limb3_S_arm_y * t369;
    const REAL t374 = limb3_lower_cos * minus_limb3_P_joint_rate - t373;
    const REAL t395 = limb3_U_joint_rate_0 * t374 + t394;
    const REAL t375 = t134 * t374;
    const REAL t377 = limb3_lower_cos * limb3_U_joint_rate_1;
    const REAL t435 = t392 * (minus_limb3_P_joint_rate - param_R * t377);
    const REAL t379 = minus_limb3_lower_sin * minus_limb3_P_joint_rate + limb3_upper_offset_x * t377;
    const REAL t382 = limb3_U_0_cos * t144 - limb3_U_0_sin * t150;
    const REAL limb3_U_joint_acc_0 = t364 - t357 * (t366 + (t375 + (t379 * t382 - t395)));
    const REAL t426 = limb3_U_joint_rate_0 * t382;
    const REAL limb3_lower_U_xz = limb3_lower_cos * limb3_U_joint_acc_0;
    const REAL limb3_U_0_rate_moment_z = k3 * limb3_U_joint_acc_0;
    const REAL minus_limb3_lower_omega_x = minus_limb3_lower_sin * limb3_U_joint_rate_0;
    const REAL limb3_lower_omega_y = limb3_lower_cos * limb3_U_joint_rate_0;
    const REAL limb3_lower_alpha_still_y = limb3_U_joint_rate_1 * minus_limb3_lower_omega_x;
    const REAL limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_lower_U_xz;
    const REAL minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y;
    const REAL minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y;
    const REAL t401 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y;
    const REAL minus_limb3_lower_rate_force_z = limb_lower_mx * minus_limb3_lower_U_zx;
    const REAL t403 = gravity_z * limb3_U_0_sin - limb3_upper_offset_x * minus_limb3_lower_U_zx;
    const REAL limb3_upper_acc_z = t403 + minus_limb3_P_joint_rate * (2.0 * limb3_lower_omega_y);
    /* limb3: balance, eqs. (40)-(47); accelerations */
    const REAL t406 = limb3_upper_offset_x * (minus_limb3_lower_rate_force_z + limb_lower_m * limb3_upper_acc_z);
    const REAL t408 = limb3_lower_cos * (gravity_z_limb_lower_mx * limb3_U_0_sin - t401 + (t406 - limb_lower_mx * limb3_upper_acc_z));
    const REAL limb3_U_0_force_moment_z = limb3_U_0_rate_moment_z - (t408 + minus_limb3_lower_sin * (k10 * (limb3_U_joint_rate_1 * limb3_lower_omega_y)));
    const REAL minus_limb3_S_multiplier_fz = t357 * limb3_U_0_force_moment_z;
    const REAL t417 = limb3_lower_omega_y * limb3_lower_omega_y;
    const REAL t410 = limb3_S_arm_x * minus_limb3_S_multiplier_fz;
    const REAL t412 = limb3_S_arm_y * minus_limb3_S_multiplier_fz;
    const REAL t637 = limb3_lower_cos * t410;
    const REAL t414 = minus_limb3_lower_sin * t410 - limb3_lower_cos * t412;
    const REAL t653 = t637 + minus_limb3_lower_sin * t412 + t652; /* platform */
    const REAL t415 = limb3_U_0_cos * t414;
    const REAL t659 = limb3_U_0_sin * t414;
    /* limb3: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL t420 = limb3_U_0_sin * t260 + limb3_U_0_cos * minus_limb5_S_joint_acc_wy;
    const REAL t431 = limb3_S_arm_x * t420;
    const REAL t421 = limb3_S_arm_y * t420;
    const REAL t422 = limb3_U_0_sin * limb5_S_joint_acc_still_wz;
    const REAL t432 = limb3_S_arm_x * t422;
    const REAL limb3_P_joint_acc = t421 - (limb3_S_arm_y * t422 + (t425 + limb3_S_arm_y * t426));
    const REAL t441 = t431 - (t432 - (t435 - (minus_limb3_P_joint_rate * limb3_U_joint_rate_1 + limb3_S_arm_x * t426)));
    const REAL minus_limb3_U_joint_acc_1 = t371 * t441;
    const REAL minus_limb3_lower_U_yx = minus_limb3_lower_U_still_xy + minus_limb3_U_joint_acc_1;
    const REAL t443 = k8 * minus_limb3_lower_U_still_xy + k9 * minus_limb3_U_joint_acc_1;
    const REAL t446 = limb3_upper_offset_x * minus_limb3_lower_U_yx;
    const REAL minus_limb3_lower_rate_force_y = limb_lower_mx * minus_limb3_lower_U_yx;
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y;
    const REAL limb3_lower_rate_moment_z = limb_lower_mx * limb3_lower_acc_y - t443;
    const REAL limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y;
    const REAL minus_limb3_upper_acc_y = minus_limb3_P_joint_rate * (2.0 * limb3_U_joint_rate_1) - (limb3_lower_acc_y - t446);
    const REAL minus_limb3_lower_U_still_xx = limb3_U_joint_rate_1 * limb3_U_joint_rate_1 + t417;
    const REAL t448 = limb3_upper_offset_x * (minus_limb3_lower_rate_force_y - limb_lower_m * minus_limb3_upper_acc_y);
    const REAL t450 = limb3_S_arm_x * (t371 * (limb3_lower_rate_moment_z + (t448 + limb_lower_mx * minus_limb3_upper_acc_y)));
    const REAL limb3_lower_force_x = limb_lower_m * (limb3_lower_acc_x - limb3_upper_offset_x * minus_limb3_lower_U_still_xx + limb3_P_joint_acc);
    const REAL t451 = limb3_S_arm_y * (limb_lower_mx * minus_limb3_lower_U_still_xx + limb3_lower_force_x) - t450;
    /* limb4: geometry; accelerations */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL t632 = t415 - limb3_U_0_sin * t451 - t631; /* platform */
    const REAL t675 = t659 + limb3_U_0_cos * t451 + t674; /* platform */
    const REAL t263 = limb4_U_0_sin * t260 - minus_limb4_U_0_cos * limb5_S_joint_acc_wx;
    const REAL t322 = minus_limb4_U_0_cos * t260 + limb4_U_0_sin * limb5_S_joint_acc_wx;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL limb4_lower_cos = SINES(cosine, 7);
    /* limb4: accelerations; reciprocal wrenches, eq. (10); velocities, eq. (6) */
    const REAL t264 = limb4_upper_position_y * t263;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    checked2 = checked2 + limb4_U_0_pivot;
    const REAL t79 = 1.0 / limb4_U_0_pivot;
    const REAL t266 = minus_limb5_S_joint_acc_wy + t79 * t264;
    const REAL t268 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_joint_acc_still_wz);
    const REAL t324 = minus_limb4_U_0_cos * limb5_S_joint_acc_still_wz;
    const REAL t282 = minus_limb4_U_0_cos * t134;
    const REAL t294 = limb4_U_0_sin * t134 - minus_limb4_U_0_cos * t144;
    const REAL t284 = t282 + limb4_U_0_sin * t144;
    const REAL t269 = minus_limb4_U_0_cos * limb5_S_joint_rate_wz;
    const REAL t289 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_joint_rate_wz + minus_limb4_U_0_cos * limb5_S_joint_rate_wx);
    const REAL limb4_U_joint_rate_0 = limb5_S_joint_rate_wy + t79 * t289;
    const REAL t271 = t269 - limb4_U_0_sin * limb5_S_joint_rate_wx;
    const REAL t296 = limb4_upper_position_y * (limb4_U_joint_rate_0 * t294);
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL minus_limb4_upper_vel_y = limb4_S_arm_x * t271;
    const REAL t273 = limb4_lower_cos * t79;
    const REAL minus_limb4_U_joint_rate_1 = minus_limb4_upper_vel_y * t273;
    const REAL t274 = minus_limb4_lower_sin * minus_limb4_U_joint_rate_1;
    const REAL t275 = limb4_upper_offset_x * t274;
    const REAL t327 = t294 * (param_R * t274);
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL limb4_P_joint_rate = limb4_S_arm_y * t271;
    const REAL t276 = limb4_lower_cos * limb4_P_joint_rate - t275;
    const REAL t277 = t150 * t276;
    const REAL t297 = limb4_U_joint_rate_0 * t276 - t296;
    const REAL t279 = limb4_lower_cos * minus_limb4_U_joint_rate_1;
    const REAL t337 = t294 * (limb4_P_joint_rate - param_R * t279);
    const REAL t299 = t277 - ((minus_limb4_lower_sin * limb4_P_joint_rate + limb4_upper_offset_x * t279) * t284 + t297);
    const REAL minus_limb4_U_joint_acc_0 = t266 - t79 * (t268 + t299);
    const REAL t328 = limb4_U_joint_rate_0 * t284;
    const REAL minus_limb4_lower_U_xz = limb4_lower_cos * minus_limb4_U_joint_acc_0;
    const REAL minus_limb4_U_0_rate_moment_z = k3 * minus_limb4_U_joint_acc_0;
    const REAL minus_limb4_lower_omega_x = minus_limb4_lower_sin * limb4_U_joint_rate_0;
    const REAL limb4_lower_omega_y = limb4_lower_cos * limb4_U_joint_rate_0;
    const REAL minus_limb4_lower_alpha_still_y = minus_limb4_U_joint_rate_1 * minus_limb4_lower_omega_x;
    const REAL minus_limb4_lower_alpha_y = minus_limb4_lower_alpha_still_y + minus_limb4_lower_U_xz;
    const REAL minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y;
    const REAL limb4_lower_U_zx = minus_limb4_lower_alpha_still_y + minus_limb4_lower_alpha_y;
    const REAL t303 = k9 * minus_limb4_lower_alpha_still_y + k8 * minus_limb4_lower_alpha_y;
    const REAL limb4_lower_rate_force_z = limb_lower_mx * limb4_lower_U_zx;
    const REAL t305 = gravity_z * minus_limb4_U_0_cos - limb4_upper_offset_x * limb4_lower_U_zx;
    const REAL minus_limb4_upper_acc_z = t305 + limb4_P_joint_rate * (2.0 * limb4_lower_omega_y);
    /* limb4: balance, eqs. (40)-(47); accelerations */
    const REAL t308 = limb4_upper_offset_x * (limb4_lower_rate_force_z + limb_lower_m * minus_limb4_upper_acc_z);
    const REAL t309 = t308 - limb_lower_mx * minus_limb4_upper_acc_z;
    const REAL t310 = limb4_lower_cos * (gravity_z_limb_lower_mx * minus_limb4_U_0_cos - t303 + t309);
    const REAL minus_limb4_U_0_force_moment_z = minus_limb4_U_0_rate_moment_z - (t310 + minus_limb4_lower_sin * (k10 * (minus_limb4_U_joint_rate_1 * limb4_lower_omega_y)));
    const REAL limb4_S_multiplier_fz = t79 * minus_limb4_U_0_force_moment_z;
    const REAL t319 = limb4_lower_omega_y * limb4_lower_omega_y;
    const REAL t312 = limb4_S_arm_x * limb4_S_multiplier_fz;
    const REAL t314 = limb4_S_arm_y * limb4_S_multiplier_fz;
    const REAL t656 = limb4_lower_cos * t312;
    const REAL t316 = minus_limb4_lower_sin * t312 - limb4_lower_cos * t314;
    const REAL minus_platform_joint_force_moment_y = t656 + minus_limb4_lower_sin * t314 + t675;
    const REAL t317 = limb4_U_0_sin * t316;
    const REAL t634 = minus_limb4_U_0_cos * t316;
    /* limb4: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL t333 = limb4_S_arm_x * t322;
    const REAL t334 = limb4_S_arm_x * t324;
    const REAL minus_limb4_P_joint_acc = limb4_S_arm_y * t322 - (limb4_S_arm_y * t324 + (t327 + limb4_S_arm_y * t328));
    const REAL t343 = t333 - (t334 - (t337 + (limb4_P_joint_rate * minus_limb4_U_joint_rate_1 - limb4_S_arm_x * t328)));
    const REAL limb4_U_joint_acc_1 = t273 * t343;
    const REAL minus_limb4_lower_U_yx = minus_limb4_lower_U_still_xy - limb4_U_joint_acc_1;
    const REAL t345 = k8 * minus_limb4_lower_U_still_xy - k9 * limb4_U_joint_acc_1;
    const REAL t348 = limb4_upper_offset_x * minus_limb4_lower_U_yx;
    const REAL minus_limb4_lower_rate_force_y = limb_lower_mx * minus_limb4_lower_U_yx;
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y;
    const REAL minus_limb4_lower_rate_moment_z = limb_lower_mx * minus_limb4_lower_acc_y + t345;
    const REAL minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y;
    const REAL minus_limb4_upper_acc_y = limb4_P_joint_rate * (2.0 * minus_limb4_U_joint_rate_1) + (minus_limb4_lower_acc_y + t348);
    const REAL minus_limb4_lower_U_still_xx = minus_limb4_U_joint_rate_1 * minus_limb4_U_joint_rate_1 + t319;
    const REAL t350 = limb4_upper_offset_x * (minus_limb4_lower_rate_force_y - limb_lower_m * minus_limb4_upper_acc_y);
    const REAL t352 = limb4_S_arm_x * (t273 * (minus_limb4_lower_rate_moment_z - (t350 + limb_lower_mx * minus_limb4_upper_acc_y)));
    const REAL minus_limb4_upper_acc_x = minus_limb4_lower_acc_x + limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_P_joint_acc;
    const REAL t331 = limb4_S_arm_y * (limb_lower_mx * minus_limb4_lower_U_still_xx - limb_lower_m * minus_limb4_upper_acc_x);
    const REAL t353 = t331 + t352;
    /* limb5_S: balance, eqs. (40)-(47); drives */
    const REAL platform_joint_force_moment_z = t317 + minus_limb4_U_0_cos * t353 + t632;
    const REAL platform_joint_force_moment_x = t634 - limb4_U_0_sin * t353 + t653;
    const REAL t47 = limb1_lower_sin * t22; /* limb1 */
    const REAL t27 = limb1_lower_cos * t22 + limb1_lower_sin * t25; /* limb1 */
    const REAL t49 = t47 - limb1_lower_cos * t25;
    const REAL platform_pivot = limb1_U_0_cos * t27 + t43;
    checked3 = checked3 + platform_pivot;
    const REAL t44 = 1.0 / platform_pivot;
    const REAL minus_limb1_U2_part_mn = t44 * platform_joint_force_moment_z;
    const REAL t40 = limb1_U_0_sin * t27 - t39;
    const REAL minus_limb5_S_balance_wx = t49 * minus_limb1_U2_part_mn - platform_joint_force_moment_x;
    const REAL limb5_S_balance_wy = t40 * minus_limb1_U2_part_mn - minus_platform_joint_force_moment_y;
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
    const REAL t51 = t49 * limb1_U2_part_mn_by_limb4_P;
    const REAL minus_limb5_S_balance_wy_by_limb4_P = limb1_U2_part_mn_by_limb4_P * t40;
    const REAL limb5_S_balance_wx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y + t51;
    /* limb5_S: drives; pivots */
    const REAL minus_drives_share_0_1 = limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P + t62;
    const REAL t654 = minus_drives_share_0_1 * minus_limb5_S_balance_wx; /* limb1 */
    const REAL t72 = minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wx_by_limb2_P;
    const REAL t74 = t72 + limb5_S_balance_wx_by_limb1_P * limb5_S_balance_wx_by_limb1_P;
    const REAL t75 = minus_limb5_S_balance_wx_by_limb3_P * minus_limb5_S_balance_wx_by_limb3_P + t74;
    const REAL drives_share_0_0 = limb5_S_balance_wx_by_limb4_P * limb5_S_balance_wx_by_limb4_P + t75;
    const REAL t677 = t654 - drives_share_0_0 * limb5_S_balance_wy; /* limb1 */
    const REAL t680 = minus_drives_share_0_1 * limb5_S_balance_wy; /* limb1 */
    const REAL t63 = minus_drives_share_0_1 * minus_drives_share_0_1;
    const REAL t67 = minus_limb5_S_balance_wy_by_limb1_P * minus_limb5_S_balance_wy_by_limb1_P;
    const REAL t68 = limb5_S_balance_wy_by_limb2_P * limb5_S_balance_wy_by_limb2_P + t67;
    const REAL t69 = limb5_S_balance_wy_by_limb3_P * limb5_S_balance_wy_by_limb3_P + t68;
    const REAL drives_share_1_1 = minus_limb5_S_balance_wy_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P + t69;
    const REAL minus_determinant = t63 - drives_share_1_1 * drives_share_0_0;
    checked0 = checked0 + minus_determinant;
    const REAL t682 = t680 - drives_share_1_1 * minus_limb5_S_balance_wx; /* limb1 */
    const REAL t77 = 1.0 / minus_determinant;
    const REAL t678 = t77 * t677; /* limb1 */
    const REAL t683 = t77 * t682; /* limb1 */
    RESULT(checked1, u, 0, minus_limb5_S_balance_wy_by_limb1_P * t678 + limb5_S_balance_wx_by_limb1_P * t683);
    RESULT(checked2, u, 1, -(limb5_S_balance_wy_by_limb2_P * t678 + minus_limb5_S_balance_wx_by_limb2_P * t683));
    const REAL t689 = minus_limb5_S_balance_wy_by_limb4_P * t678; /* limb4 */
    RESULT(checked3, u, 2, -(limb5_S_balance_wy_by_limb3_P * t678 + minus_limb5_S_balance_wx_by_limb3_P * t683));
    RESULT(checked0, u, 3, t689 + limb5_S_balance_wx_by_limb4_P * t683);
    NOT_BELOW(t9, 0.999999, 5);
    NOT_ABOVE(t9, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(a_pivot_2, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(platform_pivot, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10), /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_inverse_dynamics_preload)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict a, const double *restrict weights,
    const double *restrict preload, double *restrict u, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    /* limb1: geometry; accelerations; balance, eqs. (40)-(47) */
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    const REAL limb1_U_v_1 = READ(v, 1);
    const REAL minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x;
    const REAL limb1_U_a_0 = READ(a, 0), limb1_lower_cos = SINES(cosine, 1);
    const REAL minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_U_a_0 * limb1_lower_cos;
    const REAL limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y;
    const REAL t203 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    const REAL limb1_lower_rate_force_z = limb_lower_mx * limb1_lower_U_zx;
    const REAL t198 = limb1_upper_offset_x * limb1_lower_U_zx + gravity_z * limb1_U_0_sin;
    const REAL limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    const REAL limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y;
    const REAL limb1_P_v = READ(v, 2);
    const REAL minus_limb1_upper_acc_z = limb1_P_v * (2.0 * limb1_lower_omega_y) - t198;
    const REAL t199 = limb1_upper_offset_x * (limb_lower_m * minus_limb1_upper_acc_z + limb1_lower_rate_force_z);
    const REAL minus_limb1_lower_force_moment_y = limb_lower_mx * minus_limb1_upper_acc_z - t199 + (gravity_z_limb_lower_mx * limb1_U_0_sin + t203);
    const REAL t204 = limb1_lower_cos * minus_limb1_lower_force_moment_y;
    const REAL t211 = limb1_lower_omega_y * limb1_lower_omega_y;
    const REAL limb1_U_0_force_moment_z = limb1_lower_sin * (k10 * (limb1_U_v_1 * limb1_lower_omega_y)) - t204 + k3 * limb1_U_a_0;
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = limb1_U_0_pivot;
    const REAL t21 = 1.0 / limb1_U_0_pivot;
    /* limb1: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); accelerations */
    const REAL minus_limb1_U2_part_fz = t21 * limb1_U_0_force_moment_z;
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL t205 = minus_limb1_U2_arm_y * minus_limb1_U2_part_fz;
    const REAL t206 = limb1_lower_cos * t205;
    const REAL t243 = limb1_lower_sin * t205;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL t207 = limb1_U2_arm_x * minus_limb1_U2_part_fz;
    const REAL t209 = t206 - limb1_lower_sin * t207;
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_a_1 = READ(a, 1);
    const REAL t245 = t243 + limb1_lower_cos * t207;
    const REAL t210 = limb1_U_0_cos * t209;
    const REAL t286 = limb1_U_0_sin * t209;
    const REAL limb1_lower_U_yx = limb1_U_a_1 + limb1_lower_U_still_xy;
    const REAL t220 = k8 * limb1_lower_U_still_xy;
    const REAL t216 = limb1_upper_offset_x * limb1_lower_U_yx;
    const REAL limb1_lower_rate_force_y = limb_lower_mx * limb1_lower_U_yx;
    const REAL limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    const REAL minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y;
    const REAL limb1_upper_force_moment_z = limb_lower_mx * minus_limb1_lower_acc_y;
    const REAL limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y;
    const REAL limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) + (t216 - minus_limb1_lower_acc_y);
    const REAL t218 = limb1_upper_offset_x * (limb_lower_m * limb1_upper_acc_y - limb1_lower_rate_force_y);
    const REAL t219 = limb_lower_mx * limb1_upper_acc_y - t218;
    const REAL minus_limb1_lower_force_moment_z = t219 + (limb1_upper_force_moment_z - (t220 + k9 * limb1_U_a_1));
    const REAL t38 = limb1_lower_cos * t21;
    const REAL t223 = limb1_U2_arm_x * (minus_limb1_lower_force_moment_z * t38);
    const REAL minus_limb1_lower_U_still_xx = t211 + limb1_U_v_1 * limb1_U_v_1;
    const REAL limb1_lower_force_x = limb_lower_m * (READ(a, 2) - (limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x));
    const REAL t224 = minus_limb1_U2_arm_y * (limb_lower_mx * minus_limb1_lower_U_still_xx + limb1_lower_force_x) - t223;
    /* limb5_S: geometry; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t226 = t210 + limb1_U_0_sin * t224; /* limb1 */
    const REAL t288 = t286 - limb1_U_0_cos * t224; /* limb1 */
    const REAL t4 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t5 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t6 = t4 + t5;
    const REAL t7 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t8 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t9 = t7 + t8;
    const REAL t10 = t6 + t9;
    const REAL t12 = 4.0 - 2.0 * t10;
    const REAL platform_turn_zz = 1.0 - t12 * (t5 + t7);
    const REAL platform_turn_yy = 1.0 - t12 * (t5 + t8);
    const REAL platform_turn_xx = 1.0 - t9 * t12;
    const REAL t16 = limb5_S_q_qz * t12;
    const REAL t17 = limb5_S_q_qy * t16;
    const REAL t19 = limb5_S_q_qw * (limb5_S_q_qx * t12);
    const REAL t34 = limb5_S_q_qy * t12;
    const REAL platform_turn_zy = t17 + t19;
    const REAL limb5_S_v_wz = READ(v, 14);
    const REAL platform_turn_yz = t17 - t19;
    const REAL minus_platform_force_moment_x = gravity_z_platform_mz * platform_turn_zy;
    const REAL minus_platform_rate_moment_x = minus_platform_force_moment_x - (k12 * (READ(v, 13) * limb5_S_v_wz) + k13 * READ(a, 12));
    const REAL t238 = platform_turn_xx * minus_platform_rate_moment_x;
    const REAL t179 = limb5_S_q_qx * t16;
    const REAL t36 = limb5_S_q_qw * t16;
    const REAL t180 = limb5_S_q_qw * t34;
    const REAL t35 = limb5_S_q_qx * t34;
    const REAL platform_turn_zx = t179 - t180;
    const REAL platform_turn_xz = t179 + t180;
    const REAL t184 = platform_turn_zx * minus_platform_rate_moment_x;
    const REAL platform_force_moment_y = gravity_z_platform_mz * platform_turn_zx;
    const REAL platform_rate_moment_y = platform_force_moment_y - (k12 * (READ(v, 12) * limb5_S_v_wz) - k13 * READ(a, 13));
    const REAL t189 = t184 - platform_turn_zy * platform_rate_moment_y;
    const REAL platform_rate_moment_z = platform_Izz * READ(a, 14);
    /* limb2: velocities, eq. (6); geometry; accelerations */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3);
    const REAL t227 = t189 - platform_turn_zz * platform_rate_moment_z - t226; /* platform */
    const REAL t241 = platform_turn_xz * platform_rate_moment_z; /* platform */
    const REAL t284 = platform_turn_yz * platform_rate_moment_z; /* platform */
    const REAL limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin;
    const REAL limb2_U_v_1 = READ(v, 4);
    const REAL minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x;
    const REAL limb2_U_a_0 = READ(a, 3), limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y - limb2_U_a_0 * limb2_lower_cos;
    const REAL limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y;
    const REAL t153 = k9 * minus_limb2_lower_alpha_still_y + k8 * minus_limb2_lower_alpha_y;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL limb2_lower_rate_force_z = limb_lower_mx * limb2_lower_U_zx;
    const REAL t148 = limb2_upper_offset_x * limb2_lower_U_zx - gravity_z * minus_limb2_U_0_cos;
    const REAL limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos;
    const REAL limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y;
    const REAL limb2_P_v = READ(v, 5);
    const REAL minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) - t148;
    /* limb2: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t149 = limb2_upper_offset_x * (limb_lower_m * minus_limb2_upper_acc_z + limb2_lower_rate_force_z);
    const REAL t150 = limb_lower_mx * minus_limb2_upper_acc_z - t149;
    const REAL t154 = limb2_lower_cos * (t150 - (gravity_z_limb_lower_mx * minus_limb2_U_0_cos - t153));
    const REAL t162 = limb2_lower_omega_y * limb2_lower_omega_y;
    const REAL limb2_U_0_force_moment_z = limb2_lower_sin * (k10 * (limb2_U_v_1 * limb2_lower_omega_y)) - t154 + k3 * limb2_U_a_0;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = limb2_U_0_pivot;
    const REAL t143 = 1.0 / limb2_U_0_pivot;
    const REAL minus_limb2_S_multiplier_fz = t143 * limb2_U_0_force_moment_z;
    const REAL t174 = limb2_lower_cos * t143;
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL t155 = minus_limb2_S_arm_y * minus_limb2_S_multiplier_fz;
    const REAL t156 = limb2_lower_cos * t155;
    const REAL t278 = limb2_lower_sin * t155;
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t158 = limb2_S_arm_x * minus_limb2_S_multiplier_fz;
    const REAL t160 = t156 - limb2_lower_sin * t158;
    const REAL limb2_U_0_sin = SINES(cosine, 2), limb2_U_a_1 = READ(a, 4);
    const REAL t280 = t278 + limb2_lower_cos * t158;
    const REAL t161 = limb2_U_0_sin * t160;
    const REAL t247 = minus_limb2_U_0_cos * t160;
    const REAL limb2_lower_U_yx = limb2_U_a_1 + limb2_lower_U_still_xy;
    const REAL t171 = k8 * limb2_lower_U_still_xy;
    const REAL t167 = limb2_upper_offset_x * limb2_lower_U_yx;
    const REAL limb2_lower_rate_force_y = limb_lower_mx * limb2_lower_U_yx;
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y;
    const REAL minus_limb2_upper_force_moment_z = limb_lower_mx * limb2_lower_acc_y;
    const REAL minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y;
    const REAL limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + (t167 + limb2_lower_acc_y);
    const REAL t169 = limb2_upper_offset_x * (limb_lower_m * limb2_upper_acc_y - limb2_lower_rate_force_y);
    const REAL t170 = limb_lower_mx * limb2_upper_acc_y - t169;
    const REAL t175 = limb2_S_arm_x * ((t170 - (minus_limb2_upper_force_moment_z + (t171 + k9 * limb2_U_a_1))) * t174);
    const REAL minus_limb2_lower_U_still_xx = t162 + limb2_U_v_1 * limb2_U_v_1;
    const REAL limb2_lower_force_x = limb_lower_m * (READ(a, 5) - (limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x));
    const REAL t176 = minus_limb2_S_arm_y * (limb_lower_mx * minus_limb2_lower_U_still_xx + limb2_lower_force_x) - t175;
    /* limb3: velocities, eq. (6); geometry; accelerations */
    const REAL limb3_U_v_0 = READ(v, 6), minus_limb3_lower_sin = SINES(sine, 5);
    const REAL t228 = t161 + minus_limb2_U_0_cos * t176 + t227; /* platform */
    const REAL t249 = t247 - limb2_U_0_sin * t176; /* limb2 */
    const REAL minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin;
    const REAL limb3_U_v_1 = READ(v, 7);
    const REAL limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x;
    const REAL limb3_U_a_0 = READ(a, 6), limb3_lower_cos = SINES(cosine, 5);
    const REAL limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_U_a_0 * limb3_lower_cos;
    const REAL minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y;
    const REAL t117 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL minus_limb3_lower_rate_force_z = limb_lower_mx * minus_limb3_lower_U_zx;
    const REAL t112 = limb3_upper_offset_x * minus_limb3_lower_U_zx - gravity_z * limb3_U_0_sin;
    const REAL limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos;
    const REAL minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y;
    const REAL limb3_P_v = READ(v, 8);
    const REAL minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) + t112;
    /* limb3: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t113 = limb3_upper_offset_x * (limb_lower_m * minus_limb3_upper_acc_z - minus_limb3_lower_rate_force_z);
    const REAL minus_limb3_lower_force_moment_y = limb_lower_mx * minus_limb3_upper_acc_z - t113 + (gravity_z_limb_lower_mx * limb3_U_0_sin - t117);
    const REAL t118 = limb3_lower_cos * minus_limb3_lower_force_moment_y;
    const REAL t126 = limb3_lower_omega_y * limb3_lower_omega_y;
    const REAL minus_limb3_U_0_force_moment_z = minus_limb3_lower_sin * (k10 * (limb3_U_v_1 * limb3_lower_omega_y)) + t118 - k3 * limb3_U_a_0;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = limb3_U_0_pivot;
    const REAL t107 = 1.0 / limb3_U_0_pivot;
    const REAL limb3_S_multiplier_fz = t107 * minus_limb3_U_0_force_moment_z;
    const REAL t138 = limb3_lower_cos * t107;
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL t119 = limb3_S_arm_y * limb3_S_multiplier_fz;
    const REAL t120 = limb3_lower_cos * t119;
    const REAL t234 = minus_limb3_lower_sin * t119;
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t122 = limb3_S_arm_x * limb3_S_multiplier_fz;
    const REAL t124 = t120 - minus_limb3_lower_sin * t122;
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_a_1 = READ(a, 7);
    const REAL t236 = t234 + limb3_lower_cos * t122;
    const REAL t125 = limb3_U_0_cos * t124;
    const REAL t275 = limb3_U_0_sin * t124;
    const REAL limb3_lower_U_yx = limb3_U_a_1 - minus_limb3_lower_U_still_xy;
    const REAL t135 = k8 * minus_limb3_lower_U_still_xy;
    const REAL t131 = limb3_upper_offset_x * limb3_lower_U_yx;
    const REAL limb3_lower_rate_force_y = limb_lower_mx * limb3_lower_U_yx;
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y;
    const REAL minus_limb3_upper_force_moment_z = limb_lower_mx * limb3_lower_acc_y;
    const REAL limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y;
    const REAL limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + (t131 + limb3_lower_acc_y);
    const REAL t133 = limb3_upper_offset_x * (limb_lower_m * limb3_upper_acc_y - limb3_lower_rate_force_y);
    const REAL t134 = limb_lower_mx * limb3_upper_acc_y - t133;
    const REAL t139 = limb3_S_arm_x * ((t134 - (minus_limb3_upper_force_moment_z - (t135 - k9 * limb3_U_a_1))) * t138);
    const REAL minus_limb3_lower_U_still_xx = t126 + limb3_U_v_1 * limb3_U_v_1;
    const REAL limb3_lower_force_x = limb_lower_m * (READ(a, 8) - (limb3_upper_offset_x * minus_limb3_lower_U_still_xx - limb3_lower_acc_x));
    const REAL t140 = limb3_S_arm_y * (limb_lower_mx * minus_limb3_lower_U_still_xx + limb3_lower_force_x) + t139;
    /* limb4: velocities, eq. (6); geometry; accelerations */
    const REAL limb4_U_v_0 = READ(v, 9), minus_limb4_lower_sin = SINES(sine, 7);
    const REAL t229 = t125 - limb3_U_0_sin * t140 - t228; /* platform */
    const REAL t277 = t275 + limb3_U_0_cos * t140; /* limb3 */
    const REAL minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin;
    const REAL limb4_U_v_1 = READ(v, 10);
    const REAL limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x;
    const REAL limb4_U_a_0 = READ(a, 9), limb4_lower_cos = SINES(cosine, 7);
    const REAL limb4_lower_alpha_y = limb4_lower_alpha_still_y + limb4_U_a_0 * limb4_lower_cos;
    const REAL minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y;
    const REAL t81 = k9 * limb4_lower_alpha_still_y + k8 * limb4_lower_alpha_y;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL minus_limb4_lower_rate_force_z = limb_lower_mx * minus_limb4_lower_U_zx;
    const REAL t76 = limb4_upper_offset_x * minus_limb4_lower_U_zx + gravity_z * minus_limb4_U_0_cos;
    const REAL limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos;
    const REAL minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y;
    const REAL limb4_P_v = READ(v, 11);
    const REAL minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + t76;
    /* limb4: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t77 = limb4_upper_offset_x * (limb_lower_m * minus_limb4_upper_acc_z - minus_limb4_lower_rate_force_z);
    const REAL t78 = limb_lower_mx * minus_limb4_upper_acc_z - t77;
    const REAL t82 = limb4_lower_cos * (t78 - (gravity_z_limb_lower_mx * minus_limb4_U_0_cos + t81));
    const REAL t90 = limb4_lower_omega_y * limb4_lower_omega_y;
    const REAL minus_limb4_U_0_force_moment_z = minus_limb4_lower_sin * (k10 * (limb4_U_v_1 * limb4_lower_omega_y)) + t82 - k3 * limb4_U_a_0;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked3 = limb4_U_0_pivot;
    const REAL t71 = 1.0 / limb4_U_0_pivot;
    const REAL limb4_S_multiplier_fz = t71 * minus_limb4_U_0_force_moment_z;
    const REAL t102 = limb4_lower_cos * t71;
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL t83 = limb4_S_arm_y * limb4_S_multiplier_fz;
    const REAL t84 = limb4_lower_cos * t83;
    const REAL t272 = minus_limb4_lower_sin * t83;
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t86 = limb4_S_arm_x * limb4_S_multiplier_fz;
    const REAL t88 = t84 - minus_limb4_lower_sin * t86;
    const REAL limb4_U_0_sin = SINES(cosine, 6), limb4_U_a_1 = READ(a, 10);
    const REAL t274 = t272 + limb4_lower_cos * t86;
    const REAL t89 = limb4_U_0_sin * t88;
    const REAL t231 = minus_limb4_U_0_cos * t88;
    const REAL limb4_lower_U_yx = limb4_U_a_1 - minus_limb4_lower_U_still_xy;
    const REAL t99 = k8 * minus_limb4_lower_U_still_xy;
    const REAL t95 = limb4_upper_offset_x * limb4_lower_U_yx;
    const REAL limb4_lower_rate_force_y = limb_lower_mx * limb4_lower_U_yx;
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y;
    const REAL limb4_upper_force_moment_z = limb_lower_mx * minus_limb4_lower_acc_y;
    const REAL minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y;
    const REAL limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) + (t95 - minus_limb4_lower_acc_y);
    const REAL t97 = limb4_upper_offset_x * (limb_lower_m * limb4_upper_acc_y - limb4_lower_rate_force_y);
    const REAL minus_limb4_lower_force_moment_z = limb_lower_mx * limb4_upper_acc_y - t97 + (limb4_upper_force_moment_z + (t99 - k9 * limb4_U_a_1));
    const REAL t103 = limb4_S_arm_x * (minus_limb4_lower_force_moment_z * t102);
    const REAL minus_limb4_lower_U_still_xx = t90 + limb4_U_v_1 * limb4_U_v_1;
    const REAL limb4_upper_acc_x = READ(a, 11) - (limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_lower_acc_x);
    const REAL t92 = limb4_S_arm_y * (limb_lower_mx * minus_limb4_lower_U_still_xx + limb_lower_m * limb4_upper_acc_x);
    const REAL t104 = t92 + t103;
    const REAL minus_platform_joint_force_moment_z = t89 - minus_limb4_U_0_cos * t104 - t229;
    const REAL t233 = t231 + limb4_U_0_sin * t104;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; balance, eqs. (40)-(47) */
    const REAL t31 = limb1_U_0_cos * platform_turn_zy;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t21;
    const REAL t23 = limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3;
    const REAL t26 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3;
    const REAL t49 = limb1_lower_sin * t23;
    const REAL t28 = limb1_lower_cos * t23 + limb1_lower_sin * t26;
    const REAL t51 = t49 - limb1_lower_cos * t26; /* platform */
    const REAL t43 = limb1_U_0_cos * t28;
    const REAL t29 = limb1_U_0_sin * t28;
    const REAL t33 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - t31);
    /* platform: balance, eqs. (40)-(47); geometry; drives */
    const REAL t282 = platform_turn_yy * platform_rate_moment_y;
    const REAL platform_turn_xy = t35 - t36;
    const REAL t290 = t280 - ((t35 + t36) * minus_platform_rate_moment_x - t282 - t284 + t288);
    const REAL minus_platform_joint_force_moment_y = t274 + (t277 - t290);
    const REAL t251 = t236 + (t238 - platform_turn_xy * platform_rate_moment_y - t241 - t245 + t249);
    const REAL minus_platform_joint_force_moment_x = t233 + t251;
    const REAL limb1_U2_constraint_mn_couple_z = t33 - limb1_lower_sin * platform_turn_xy;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * (limb1_U2_constraint_mn_couple_z * t38);
    const REAL platform_pivot = t43 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    checked0 = checked0 + platform_pivot;
    const REAL t45 = 1.0 / platform_pivot;
    const REAL limb1_U2_part_mn = t45 * minus_platform_joint_force_moment_z;
    const REAL t41 = t29 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL limb5_S_balance_wx = t51 * limb1_U2_part_mn - minus_platform_joint_force_moment_x;
    const REAL minus_limb5_S_balance_wy = t41 * limb1_U2_part_mn + minus_platform_joint_force_moment_y;
    const REAL minus_limb1_U2_part_mn_by_limb2_P = minus_limb2_U_0_cos * minus_limb2_S_arm_y * t45;
    const REAL minus_limb5_S_balance_wx_by_limb2_P = limb2_U_0_sin * minus_limb2_S_arm_y + t51 * minus_limb1_U2_part_mn_by_limb2_P;
    const REAL limb5_S_balance_wy_by_limb2_P = t41 * minus_limb1_U2_part_mn_by_limb2_P;
    const REAL limb2_P_preload = READ(preload, 1);
    const REAL t254 = limb2_P_preload * minus_limb5_S_balance_wx_by_limb2_P; /* limb1 */
    const REAL limb1_U2_part_mn_by_limb1_P = limb1_U_0_sin * minus_limb1_U2_arm_y * t45;
    const REAL t3 = limb1_U_0_cos * minus_limb1_U2_arm_y;
    const REAL limb5_S_balance_wx_by_limb1_P = t51 * limb1_U2_part_mn_by_limb1_P;
    const REAL minus_limb5_S_balance_wy_by_limb1_P = t3 + t41 * limb1_U2_part_mn_by_limb1_P;
    const REAL limb1_P_preload = READ(preload, 0);
    const REAL t256 = t254 - limb1_P_preload * limb5_S_balance_wx_by_limb1_P; /* limb1 */
    const REAL minus_limb1_U2_part_mn_by_limb3_P = limb3_U_0_sin * limb3_S_arm_y * t45;
    const REAL platform_joint_force_moment_y_by_limb3_P = limb3_U_0_cos * limb3_S_arm_y;
    const REAL minus_limb5_S_balance_wx_by_limb3_P = t51 * minus_limb1_U2_part_mn_by_limb3_P;
    const REAL limb5_S_balance_wy_by_limb3_P = platform_joint_force_moment_y_by_limb3_P + t41 * minus_limb1_U2_part_mn_by_limb3_P;
    const REAL limb3_P_preload = READ(preload, 2);
    const REAL t257 = limb3_P_preload * minus_limb5_S_balance_wx_by_limb3_P + t256; /* limb1 */
    const REAL limb1_U2_part_mn_by_limb4_P = minus_limb4_U_0_cos * limb4_S_arm_y * t45;
    const REAL t53 = t51 * limb1_U2_part_mn_by_limb4_P;
    const REAL minus_limb5_S_balance_wy_by_limb4_P = limb1_U2_part_mn_by_limb4_P * t41;
    const REAL limb5_S_balance_wx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y + t53;
    const REAL limb4_P_preload = READ(preload, 3);
    const REAL t259 = limb5_S_balance_wx + (limb4_P_preload * limb5_S_balance_wx_by_limb4_P - t257); /* limb1 */
    const REAL limb1_P_weights = READ(weights, 0);
    checked1 = checked1 + limb1_P_weights;
    const REAL t1 = 1.0 / limb1_P_weights; /* limb1 */
    const REAL t47 = t1 * minus_limb5_S_balance_wy_by_limb1_P;
    const REAL t267 = t1 * limb5_S_balance_wx_by_limb1_P;
    const REAL limb2_P_weights = READ(weights, 1);
    checked2 = checked2 + limb2_P_weights;
    /* drives: drives; pivots */
    const REAL t68 = limb5_S_balance_wx_by_limb1_P * t47;
    const REAL t268 = limb5_S_balance_wx_by_limb1_P * t267;
    const REAL t65 = 1.0 / limb2_P_weights; /* limb2 */
    const REAL t66 = t65 * limb5_S_balance_wy_by_limb2_P;
    const REAL t265 = t65 * minus_limb5_S_balance_wx_by_limb2_P;
    const REAL limb3_P_weights = READ(weights, 2);
    checked3 = checked3 + limb3_P_weights;
    const REAL t69 = minus_limb5_S_balance_wx_by_limb2_P * t66 + t68;
    const REAL t269 = minus_limb5_S_balance_wx_by_limb2_P * t265 + t268;
    const REAL t58 = 1.0 / limb3_P_weights; /* limb3 */
    const REAL t60 = t58 * limb5_S_balance_wy_by_limb3_P;
    const REAL t263 = t58 * minus_limb5_S_balance_wx_by_limb3_P;
    const REAL limb4_P_weights = READ(weights, 3);
    checked0 = checked0 + limb4_P_weights;
    const REAL t70 = minus_limb5_S_balance_wx_by_limb3_P * t60 + t69;
    const REAL t270 = minus_limb5_S_balance_wx_by_limb3_P * t263 + t269;
    const REAL t54 = 1.0 / limb4_P_weights; /* limb4 */
    const REAL t55 = t54 * minus_limb5_S_balance_wy_by_limb4_P;
    const REAL t261 = t54 * limb5_S_balance_wx_by_limb4_P;
    const REAL minus_drives_share_1_0 = limb5_S_balance_wx_by_limb4_P * t55 + t70;
    const REAL drives_share_0_0 = limb5_S_balance_wx_by_limb4_P * t261 + t270;
    const REAL t260 = minus_drives_share_1_0 * t259; /* limb1 */
    const REAL t295 = limb1_P_preload * minus_limb5_S_balance_wy_by_limb1_P; /* limb1 */
    const REAL t296 = limb2_P_preload * limb5_S_balance_wy_by_limb2_P - t295; /* limb1 */
    const REAL t307 = limb5_S_balance_wy_by_limb2_P * t66 + minus_limb5_S_balance_wy_by_limb1_P * t47;
    const REAL t297 = limb3_P_preload * limb5_S_balance_wy_by_limb3_P + t296; /* limb1 */
    const REAL t308 = limb5_S_balance_wy_by_limb3_P * t60 + t307;
    const REAL t299 = minus_limb5_S_balance_wy + (limb4_P_preload * minus_limb5_S_balance_wy_by_limb4_P - t297); /* limb1 */
    const REAL drives_share_1_1 = minus_limb5_S_balance_wy_by_limb4_P * t55 + t308;
    const REAL t301 = t260 - drives_share_0_0 * t299; /* limb1 */
    const REAL t315 = minus_drives_share_1_0 * t299 - drives_share_1_1 * t259; /* limb1 */
    const REAL minus_determinant = minus_drives_share_1_0 * minus_drives_share_1_0 - drives_share_1_1 * drives_share_0_0;
    checked1 = checked1 + minus_determinant;
    const REAL t310 = 1.0 / minus_determinant;
    const REAL t311 = t301 * t310; /* limb1 */
    const REAL t316 = t310 * t315; /* limb1 */
    RESULT(checked2, u, 0, limb1_P_preload - (t47 * t311 + t267 * t316));
    RESULT(checked3, u, 1, limb2_P_preload + (t66 * t311 + t265 * t316));
    const REAL t325 = t55 * t311; /* limb4 */
    RESULT(checked0, u, 2, limb3_P_preload + (t60 * t311 + t263 * t316));
    RESULT(checked1, u, 3, limb4_P_preload - (t325 + t261 * t316));
    NOT_BELOW(t10, 0.999999, 5);
    NOT_ABOVE(t10, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb2_U_0_pivot, 6.3211e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb3_U_0_pivot, 6.4044e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.284e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.233100000000001e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(platform_pivot, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10) OR /* where equations that are solved at once lose rank, as drives do at a singularity */
        SMALL(limb1_P_weights, 0.0) OR /* where weights limb1_P vanishes */
        SMALL(limb2_P_weights, 0.0) OR /* where weights limb2_P vanishes */
        SMALL(limb3_P_weights, 0.0) OR /* where weights limb3_P vanishes */
        SMALL(limb4_P_weights, 0.0), /* where weights limb4_P vanishes */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_inverse_dynamics_platform)(size_t stride, const double *restrict pose,
    const double *restrict rate, const double *restrict acceleration, double *restrict u,
    double *restrict total)
{
    /* limb5_S: geometry; accelerations; velocities, eq. (6) */
    const REAL limb5_S_pose_qw = READ(pose, 0), limb5_S_pose_qx = READ(pose, 1);
    const REAL t1 = limb5_S_pose_qw * limb5_S_pose_qw;
    const REAL t2 = limb5_S_pose_qx * limb5_S_pose_qx;
    const REAL limb5_S_pose_qy = READ(pose, 2);
    const REAL t3 = t1 + t2;
    const REAL t4 = limb5_S_pose_qy * limb5_S_pose_qy;
    const REAL limb5_S_pose_qz = READ(pose, 3);
    const REAL t5 = limb5_S_pose_qz * limb5_S_pose_qz;
    const REAL t6 = t4 + t5;
    const REAL t7 = t3 + t6;
    const REAL t9 = 4.0 - 2.0 * t7;
    const REAL t37 = t2 + t5;
    const REAL platform_turn_zz = 1.0 - t9 * (t2 + t4);
    const REAL platform_turn_xx = 1.0 - t6 * t9;
    const REAL platform_turn_yy = 1.0 - t9 * t37;
    const REAL t12 = limb5_S_pose_qy * t9;
    const REAL t21 = limb5_S_pose_qx * t12;
    const REAL t13 = limb5_S_pose_qw * t12;
    const REAL t10 = limb5_S_pose_qz * t9;
    const REAL t26 = limb5_S_pose_qw * (limb5_S_pose_qx * t9);
    const REAL t22 = limb5_S_pose_qw * t10;
    const REAL platform_turn_yx = t21 + t22;
    const REAL platform_turn_xy = t21 - t22;
    const REAL t23 = 0.5 * platform_turn_yx;
    const REAL t24 = limb5_S_pose_qy * t10;
    const REAL t11 = limb5_S_pose_qx * t10;
    const REAL platform_turn_yz = t24 - t26;
    const REAL platform_turn_zy = t24 + t26;
    const REAL t27 = param_H * platform_turn_yz;
    const REAL minus_limb1_lower_limb_target_x = t23 - t27;
    const REAL limb3_lower_limb_target_x = t23 + t27;
    const REAL t28 = minus_limb1_lower_limb_target_x * minus_limb1_lower_limb_target_x; /* limb1 */
    const REAL platform_turn_zx = t11 - t13;
    const REAL platform_turn_xz = t11 + t13;
    const REAL t14 = 0.5 * platform_turn_zx;
    const REAL t17 = param_H * platform_turn_zz;
    const REAL minus_limb1_lower_limb_target_y = t14 - t17;
    const REAL limb3_lower_limb_target_y = t14 + t17;
    const REAL t30 = t28 + minus_limb1_lower_limb_target_y * minus_limb1_lower_limb_target_y; /* limb1 */
    const REAL limb1_U_0_pivot = SQRT(t30);
    const REAL t35 = 1.0 / limb1_U_0_pivot; /* limb1 */
    const REAL limb1_U_0_sin = minus_limb1_lower_limb_target_x * t35;
    const REAL limb5_S_rate_wx = READ(rate, 0), limb5_S_rate_wy = READ(rate, 1), limb5_S_rate_wz = READ(rate, 2);
    const REAL t159 = limb5_S_rate_wx * platform_turn_zx + limb5_S_rate_wy * platform_turn_zy;
    const REAL platform_twist_angular_z = limb5_S_rate_wz * platform_turn_zz + t159;
    const REAL t20 = param_H * platform_turn_xz;
    const REAL t19 = 0.5 * platform_turn_xx;
    const REAL minus_limb1_upper_position_x = t19 - t20;
    const REAL limb3_upper_position_x = t19 + t20;
    /* limb1: loop closure; geometry; accelerations */
    const REAL t160 = minus_limb1_upper_position_x * platform_twist_angular_z;
    const REAL t163 = limb5_S_rate_wx * platform_turn_xx + limb5_S_rate_wy * platform_turn_xy; /* platform */
    const REAL platform_twist_angular_x = t163 + limb5_S_rate_wz * platform_turn_xz;
    const REAL t166 = t160 - minus_limb1_lower_limb_target_y * platform_twist_angular_x;
    const REAL t167 = t166 * limb1_U_0_sin;
    const REAL minus_limb1_U_0_cos = minus_limb1_lower_limb_target_y * t35;
    const REAL t186 = t166 * minus_limb1_U_0_cos;
    const REAL t168 = minus_limb1_lower_limb_target_x * platform_twist_angular_x;
    const REAL t171 = limb5_S_rate_wy * platform_turn_yy + limb5_S_rate_wx * platform_turn_yx; /* platform */
    const REAL platform_twist_angular_y = t171 + limb5_S_rate_wz * platform_turn_yz;
    const REAL t174 = t168 - minus_limb1_upper_position_x * platform_twist_angular_y;
    const REAL t176 = t167 + t174 * minus_limb1_U_0_cos;
    const REAL minus_limb1_U_0_omega_z = t35 * (t186 - t174 * limb1_U_0_sin);
    const REAL limb1_lower_limb_target_z = param_R - minus_limb1_upper_position_x;
    const REAL limb1_lower_limb_length = SQRT(t30 + limb1_lower_limb_target_z * limb1_lower_limb_target_z);
    const REAL t33 = 1.0 / limb1_lower_limb_length;
    const REAL limb1_lower_sin = limb1_lower_limb_target_z * t33;
    const REAL limb1_lower_cos = limb1_U_0_pivot * t33;
    const REAL t182 = limb1_lower_sin * t176;
    const REAL t177 = limb1_lower_cos * t176;
    const REAL t178 = minus_limb1_lower_limb_target_y * platform_twist_angular_y;
    const REAL t180 = t178 - minus_limb1_lower_limb_target_x * platform_twist_angular_z;
    const REAL minus_limb1_lower_omega_z = t33 * (t182 + t180 * limb1_lower_cos);
    const REAL minus_limb1_U2_opening_rate_fx = t177 - t180 * limb1_lower_sin;
    const REAL minus_limb1_lower_omega_x = limb1_lower_sin * minus_limb1_U_0_omega_z;
    const REAL minus_limb1_lower_omega_y = limb1_lower_cos * minus_limb1_U_0_omega_z;
    const REAL minus_limb1_lower_alpha_y = minus_limb1_lower_omega_z * minus_limb1_lower_omega_x;
    const REAL limb1_lower_U_xy = minus_limb1_lower_omega_x * minus_limb1_lower_omega_y;
    const REAL t258 = limb1_lower_limb_length * (2.0 * minus_limb1_lower_alpha_y);
    const REAL t257 = minus_limb1_U2_opening_rate_fx * (2.0 * minus_limb1_lower_omega_y);
    const REAL limb1_upper_acc_z = t258 + t257;
    /* platform: accelerations; loop closure; momentum rate, eq. (35) */
    const REAL t189 = limb5_S_rate_wy * limb5_S_rate_wy;
    const REAL t190 = limb5_S_rate_wz * limb5_S_rate_wz;
    const REAL minus_platform_U_still_xx = t189 + t190;
    const REAL t191 = platform_turn_yx * minus_platform_U_still_xx;
    const REAL platform_U_still_xy = limb5_S_rate_wx * limb5_S_rate_wy;
    const REAL limb5_S_acc_wz = READ(acceleration, 2);
    const REAL platform_U_yx = limb5_S_acc_wz + platform_U_still_xy;
    const REAL minus_platform_U_xy = limb5_S_acc_wz - platform_U_still_xy;
    const REAL t193 = t191 - platform_turn_yy * platform_U_yx;
    const REAL platform_U_still_xz = limb5_S_rate_wx * limb5_S_rate_wz;
    const REAL limb5_S_acc_wy = READ(acceleration, 1);
    const REAL minus_platform_U_zx = limb5_S_acc_wy - platform_U_still_xz;
    const REAL t196 = 0.5 * (t193 + platform_turn_yz * minus_platform_U_zx);
    const REAL platform_U_xz = limb5_S_acc_wy + platform_U_still_xz;
    const REAL t149 = k12 * platform_U_still_xz;
    const REAL t197 = platform_turn_yx * platform_U_xz;
    const REAL platform_U_still_yz = limb5_S_rate_wy * limb5_S_rate_wz;
    const REAL limb5_S_acc_wx = READ(acceleration, 0);
    const REAL minus_platform_U_yz = limb5_S_acc_wx - platform_U_still_yz;
    const REAL t199 = t197 - platform_turn_yy * minus_platform_U_yz;
    const REAL t200 = limb5_S_rate_wx * limb5_S_rate_wx;
    const REAL minus_platform_U_still_zz = t200 + t189;
    const REAL minus_platform_U_still_yy = t200 + t190;
    /* platform: loop closure */
    const REAL t203 = param_H * (t199 - platform_turn_yz * minus_platform_U_still_zz);
    const REAL t204 = t196 + t203;
    const REAL t392 = t196 - t203;
    const REAL t259 = minus_limb1_U_0_cos * t204; /* limb1 */
    const REAL t205 = limb1_U_0_sin * t204; /* limb1 */
    const REAL t208 = platform_turn_zx * minus_platform_U_still_xx - platform_turn_zy * platform_U_yx;
    const REAL t224 = platform_turn_xx * minus_platform_U_still_xx - platform_turn_xy * platform_U_yx;
    const REAL t211 = 0.5 * (t208 + platform_turn_zz * minus_platform_U_zx);
    const REAL t227 = 0.5 * (t224 + platform_turn_xz * minus_platform_U_zx);
    const REAL t214 = platform_turn_zx * platform_U_xz - platform_turn_zy * minus_platform_U_yz;
    const REAL t230 = platform_turn_xx * platform_U_xz - platform_turn_xy * minus_platform_U_yz;
    const REAL t217 = param_H * (t214 - platform_turn_zz * minus_platform_U_still_zz);
    const REAL t233 = param_H * (t230 - platform_turn_xz * minus_platform_U_still_zz);
    const REAL t218 = t211 + t217;
    const REAL t394 = t211 - t217;
    /* limb1: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb1_U_0_alpha_z = t35 * (limb1_upper_acc_z + (t259 - limb1_U_0_sin * t218));
    const REAL t220 = t205 + minus_limb1_U_0_cos * t218;
    const REAL minus_limb1_lower_alpha_y_2 = minus_limb1_lower_alpha_y - limb1_lower_cos * limb1_U_0_alpha_z;
    const REAL limb1_U_0_rate_moment_z = k3 * limb1_U_0_alpha_z;
    const REAL limb1_lower_U_zx_2 = minus_limb1_lower_alpha_y + minus_limb1_lower_alpha_y_2;
    const REAL t268 = k8 * minus_limb1_lower_alpha_y_2 + k9 * minus_limb1_lower_alpha_y;
    const REAL limb1_lower_rate_force_z = limb_lower_mx * limb1_lower_U_zx_2;
    const REAL limb1_upper_acc_z_2 = t257 + (gravity_z * limb1_U_0_sin + limb1_lower_limb_length * limb1_lower_U_zx_2);
    const REAL t264 = limb1_lower_limb_length * (limb_lower_m * limb1_upper_acc_z_2 - limb1_lower_rate_force_z);
    const REAL limb1_lower_force_moment_y = limb_lower_mx * limb1_upper_acc_z_2 - t264 - (t268 + gravity_z_limb_lower_mx * limb1_U_0_sin);
    const REAL t270 = limb1_lower_cos * limb1_lower_force_moment_y;
    const REAL limb1_U_0_force_moment_z = limb1_lower_sin * (k10 * (minus_limb1_lower_omega_z * minus_limb1_lower_omega_y)) + t270 + limb1_U_0_rate_moment_z;
    const REAL minus_limb1_U2_part_fz = t35 * limb1_U_0_force_moment_z;
    const REAL t246 = minus_limb1_lower_omega_y * minus_limb1_lower_omega_y;
    const REAL t521 = minus_limb1_U_0_cos * minus_limb1_U2_part_fz;
    const REAL t271 = limb1_U_0_sin * minus_limb1_U2_part_fz;
    const REAL t185 = minus_limb1_U2_opening_rate_fx * (2.0 * minus_limb1_lower_omega_z);
    const REAL minus_limb1_lower_U_xx = t246 + minus_limb1_lower_omega_z * minus_limb1_lower_omega_z;
    const REAL limb1_upper_acc_y = limb1_lower_limb_length * limb1_lower_U_xy - t185;
    const REAL t221 = limb1_lower_sin * t220;
    const REAL t248 = limb1_lower_cos * t220;
    const REAL t234 = t227 + t233; /* platform */
    const REAL t398 = t227 - t233; /* platform */
    const REAL minus_limb1_lower_alpha_z = t33 * (limb1_upper_acc_y - (t221 + limb1_lower_cos * t234));
    const REAL t250 = t248 - limb1_lower_sin * t234;
    const REAL limb1_lower_U_yx = limb1_lower_U_xy - minus_limb1_lower_alpha_z;
    const REAL t243 = k9 * minus_limb1_lower_alpha_z - k8 * limb1_lower_U_xy;
    const REAL t237 = limb1_lower_limb_length * limb1_lower_U_yx;
    const REAL limb1_lower_rate_force_y = limb_lower_mx * limb1_lower_U_yx;
    const REAL minus_limb1_U_0_acc_y = gravity_z * minus_limb1_U_0_cos;
    const REAL limb1_lower_acc_y = limb1_lower_sin * minus_limb1_U_0_acc_y;
    const REAL minus_limb1_upper_acc_y = t185 - (limb1_lower_acc_y + t237);
    const REAL minus_limb1_lower_rate_moment_z = t243 - limb_lower_mx * limb1_lower_acc_y;
    const REAL minus_limb1_lower_acc_x = limb1_lower_cos * minus_limb1_U_0_acc_y;
    /* limb1: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL t239 = limb1_lower_limb_length * (limb_lower_m * minus_limb1_upper_acc_y + limb1_lower_rate_force_y);
    const REAL limb1_U2_part_fy = t33 * (limb_lower_mx * minus_limb1_upper_acc_y - t239 - minus_limb1_lower_rate_moment_z);
    const REAL minus_limb1_upper_acc_x = limb1_lower_limb_length * minus_limb1_lower_U_xx;
    const REAL limb1_lower_force_x = limb_lower_m * (minus_limb1_upper_acc_x - t250 - (minus_limb1_upper_acc_x + minus_limb1_lower_acc_x));
    const REAL limb1_upper_rate_force_x = limb1_lower_force_x + limb_lower_mx * minus_limb1_lower_U_xx;
    const REAL t245 = limb1_lower_cos * limb1_U2_part_fy;
    const REAL t274 = limb1_lower_sin * limb1_U2_part_fy - limb1_lower_cos * limb1_upper_rate_force_x;
    const REAL t253 = t245 + limb1_lower_sin * limb1_upper_rate_force_x;
    const REAL t523 = t521 + limb1_U_0_sin * t274;
    const REAL t276 = t271 - minus_limb1_U_0_cos * t274;
    const REAL t556 = minus_limb1_lower_limb_target_y * t523;
    const REAL t526 = minus_limb1_upper_position_x * t523 - minus_limb1_lower_limb_target_x * t253;
    const REAL t254 = minus_limb1_lower_limb_target_y * t253;
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35); loop closure */
    const REAL minus_platform_force_moment_x = gravity_z_platform_mz * platform_turn_zy;
    const REAL t145 = k12 * platform_U_still_yz;
    const REAL platform_U_zy = limb5_S_acc_wx + platform_U_still_yz;
    const REAL minus_platform_rate_moment_x = minus_platform_force_moment_x - (t145 + k13 * limb5_S_acc_wx);
    const REAL t516 = platform_turn_zx * minus_platform_rate_moment_x;
    const REAL t302 = platform_turn_zx * minus_platform_U_xy;
    const REAL platform_rate_moment_y = gravity_z_platform_mz * platform_turn_zx - (t149 - k13 * limb5_S_acc_wy);
    const REAL t518 = t516 - platform_turn_zy * platform_rate_moment_y;
    const REAL platform_rate_moment_z = platform_Izz * limb5_S_acc_wz;
    const REAL t527 = t518 - platform_turn_zz * platform_rate_moment_z + t526;
    const REAL t305 = platform_turn_zz * platform_U_zy;
    const REAL t78 = 0.5 * platform_turn_zy;
    /* limb2: geometry; loop closure; accelerations */
    const REAL limb2_lower_limb_target_x = t17 - t78;
    const REAL limb4_lower_limb_target_x = t17 + t78;
    const REAL t79 = limb2_lower_limb_target_x * limb2_lower_limb_target_x;
    const REAL t80 = 0.5 * platform_turn_xy; /* platform */
    const REAL limb2_lower_limb_target_y = t20 - t80;
    const REAL limb4_lower_limb_target_y = t20 + t80;
    const REAL t82 = t79 + limb2_lower_limb_target_y * limb2_lower_limb_target_y;
    const REAL limb2_U_0_lever_moment_z_by_limb2_S_fz = SQRT(t82);
    const REAL t83 = 1.0 / limb2_U_0_lever_moment_z_by_limb2_S_fz;
    const REAL limb2_U_0_sin = limb2_lower_limb_target_x * t83;
    const REAL t77 = 0.5 * platform_turn_yy; /* platform */
    const REAL limb2_upper_position_y = t27 - t77;
    const REAL limb4_upper_position_y = t27 + t77;
    const REAL t280 = limb2_upper_position_y * platform_twist_angular_x;
    const REAL t282 = t280 - limb2_lower_limb_target_y * platform_twist_angular_y;
    const REAL t283 = t282 * limb2_U_0_sin;
    const REAL minus_limb2_U_0_cos = limb2_lower_limb_target_y * t83;
    const REAL t294 = t282 * minus_limb2_U_0_cos;
    const REAL t284 = limb2_lower_limb_target_x * platform_twist_angular_y;
    const REAL t286 = t284 - limb2_upper_position_y * platform_twist_angular_z;
    const REAL t288 = t283 + t286 * minus_limb2_U_0_cos;
    const REAL minus_limb2_U_0_omega_z = t83 * (t294 - t286 * limb2_U_0_sin);
    const REAL limb2_lower_limb_target_z = param_R + limb2_upper_position_y;
    const REAL limb2_lower_limb_length = SQRT(t82 + limb2_lower_limb_target_z * limb2_lower_limb_target_z);
    const REAL t86 = 1.0 / limb2_lower_limb_length;
    const REAL limb2_lower_sin = limb2_lower_limb_target_z * t86;
    const REAL minus_limb2_lower_cos = limb2_U_0_lever_moment_z_by_limb2_S_fz * t86;
    const REAL t289 = limb2_lower_sin * t288;
    const REAL t297 = minus_limb2_lower_cos * t288;
    const REAL t290 = limb2_lower_limb_target_y * platform_twist_angular_z;
    const REAL t292 = t290 - limb2_lower_limb_target_x * platform_twist_angular_x;
    const REAL limb2_lower_omega_z = t86 * (t289 - t292 * minus_limb2_lower_cos);
    const REAL minus_limb2_S_opening_rate_fx = t297 + t292 * limb2_lower_sin;
    const REAL minus_limb2_lower_omega_x = limb2_lower_sin * minus_limb2_U_0_omega_z;
    const REAL limb2_lower_omega_y = minus_limb2_lower_cos * minus_limb2_U_0_omega_z;
    const REAL limb2_lower_alpha_y = limb2_lower_omega_z * minus_limb2_lower_omega_x;
    const REAL minus_limb2_lower_U_xy = minus_limb2_lower_omega_x * limb2_lower_omega_y;
    const REAL t301 = limb2_lower_limb_length * (2.0 * limb2_lower_alpha_y);
    const REAL t300 = minus_limb2_S_opening_rate_fx * (2.0 * limb2_lower_omega_y);
    const REAL minus_limb2_upper_acc_z = t301 + t300;
    /* platform: loop closure; balance, eqs. (40)-(47) */
    const REAL t307 = 0.5 * (t302 + platform_turn_zy * minus_platform_U_still_yy - t305);
    const REAL t308 = t217 + t307;
    const REAL t466 = t217 - t307;
    const REAL t309 = minus_limb2_U_0_cos * t308; /* limb2 */
    const REAL t332 = limb2_U_0_sin * t308; /* limb2 */
    const REAL t312 = platform_turn_xx * minus_platform_U_xy + platform_turn_xy * minus_platform_U_still_yy;
    const REAL t338 = platform_turn_yx * minus_platform_U_xy + platform_turn_yy * minus_platform_U_still_yy;
    const REAL t148 = platform_turn_yx * minus_platform_rate_moment_x;
    const REAL t550 = platform_turn_xx * minus_platform_rate_moment_x;
    const REAL t315 = 0.5 * (t312 - platform_turn_xz * platform_U_zy);
    const REAL t341 = 0.5 * (t338 - platform_turn_yz * platform_U_zy);
    const REAL t154 = platform_turn_yz * platform_rate_moment_z;
    const REAL t553 = platform_turn_xz * platform_rate_moment_z;
    const REAL t316 = t233 + t315;
    const REAL t468 = t233 - t315;
    /* limb2: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb2_U_0_alpha_z = t83 * (minus_limb2_upper_acc_z - (t309 - limb2_U_0_sin * t316));
    const REAL t334 = t332 + minus_limb2_U_0_cos * t316;
    const REAL limb2_lower_alpha_y_2 = limb2_lower_alpha_y - minus_limb2_lower_cos * limb2_U_0_alpha_z;
    const REAL limb2_U_0_rate_moment_z = k3 * limb2_U_0_alpha_z;
    const REAL minus_limb2_lower_U_zx_2 = limb2_lower_alpha_y + limb2_lower_alpha_y_2;
    const REAL t325 = k8 * limb2_lower_alpha_y_2 + k9 * limb2_lower_alpha_y;
    const REAL minus_limb2_lower_rate_force_z = limb_lower_mx * minus_limb2_lower_U_zx_2;
    const REAL minus_limb2_upper_acc_z_2 = t300 + (gravity_z * minus_limb2_U_0_cos + limb2_lower_limb_length * minus_limb2_lower_U_zx_2);
    const REAL t321 = limb2_lower_limb_length * (limb_lower_m * minus_limb2_upper_acc_z_2 - minus_limb2_lower_rate_force_z);
    const REAL t322 = limb_lower_mx * minus_limb2_upper_acc_z_2 - t321;
    const REAL t327 = minus_limb2_lower_cos * (t322 - (t325 + gravity_z_limb_lower_mx * minus_limb2_U_0_cos));
    const REAL limb2_U_0_force_moment_z = limb2_lower_sin * (k10 * (limb2_lower_omega_z * limb2_lower_omega_y)) + t327 + limb2_U_0_rate_moment_z;
    const REAL limb2_S_multiplier_fz = t83 * limb2_U_0_force_moment_z;
    const REAL t354 = limb2_lower_omega_y * limb2_lower_omega_y;
    const REAL t328 = limb2_U_0_sin * limb2_S_multiplier_fz;
    const REAL t365 = minus_limb2_U_0_cos * limb2_S_multiplier_fz;
    const REAL t330 = minus_limb2_S_opening_rate_fx * (2.0 * limb2_lower_omega_z);
    const REAL minus_limb2_lower_U_xx = t354 + limb2_lower_omega_z * limb2_lower_omega_z;
    const REAL minus_limb2_upper_acc_y = limb2_lower_limb_length * minus_limb2_lower_U_xy - t330;
    const REAL t335 = limb2_lower_sin * t334;
    const REAL t356 = minus_limb2_lower_cos * t334;
    const REAL t342 = t203 + t341; /* platform */
    const REAL t488 = t203 - t341; /* platform */
    const REAL limb2_lower_alpha_z = t86 * (minus_limb2_upper_acc_y + (t335 - minus_limb2_lower_cos * t342));
    const REAL t358 = t356 + limb2_lower_sin * t342;
    const REAL minus_limb2_lower_U_yx = minus_limb2_lower_U_xy - limb2_lower_alpha_z;
    const REAL t351 = k9 * limb2_lower_alpha_z - k8 * minus_limb2_lower_U_xy;
    const REAL t345 = limb2_lower_limb_length * minus_limb2_lower_U_yx;
    const REAL minus_limb2_lower_rate_force_y = limb_lower_mx * minus_limb2_lower_U_yx;
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y;
    const REAL limb2_upper_acc_y = t330 + (limb2_lower_acc_y - t345);
    const REAL limb2_lower_rate_moment_z = t351 + limb_lower_mx * limb2_lower_acc_y;
    const REAL limb2_lower_acc_x = minus_limb2_lower_cos * minus_limb2_U_0_acc_y;
    /* limb2: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL t347 = limb2_lower_limb_length * (limb_lower_m * limb2_upper_acc_y + minus_limb2_lower_rate_force_y);
    const REAL minus_limb2_S_multiplier_fy = t86 * (limb_lower_mx * limb2_upper_acc_y - t347 - limb2_lower_rate_moment_z);
    const REAL minus_limb2_upper_acc_x = limb2_lower_limb_length * minus_limb2_lower_U_xx;
    const REAL limb2_lower_force_x = limb_lower_m * (minus_limb2_upper_acc_x + t358 - (minus_limb2_upper_acc_x - limb2_lower_acc_x));
    const REAL limb2_upper_rate_force_x = limb2_lower_force_x + limb_lower_mx * minus_limb2_lower_U_xx;
    const REAL t353 = limb2_lower_sin * minus_limb2_S_multiplier_fy;
    const REAL t528 = minus_limb2_lower_cos * minus_limb2_S_multiplier_fy;
    const REAL t361 = t353 - minus_limb2_lower_cos * limb2_upper_rate_force_x;
    const REAL t530 = t528 + limb2_lower_sin * limb2_upper_rate_force_x;
    const REAL t363 = t328 - minus_limb2_U_0_cos * t361;
    const REAL t367 = t365 + limb2_U_0_sin * t361;
    const REAL base_lever_force_x_by_limb2_S_fx = minus_limb2_U_0_cos * minus_limb2_lower_cos;
    const REAL base_lever_force_z_by_limb2_S_fx = limb2_U_0_sin * minus_limb2_lower_cos;
    const REAL t364 = limb2_lower_limb_target_x * t363;
    const REAL t534 = t527 - (limb2_lower_limb_target_y * t530 - limb2_upper_position_y * t363); /* platform */
    const REAL t560 = limb2_lower_limb_target_x * t530;
    /* limb3: geometry; loop closure; accelerations */
    const REAL t94 = limb3_lower_limb_target_x * limb3_lower_limb_target_x;
    const REAL t96 = t94 + limb3_lower_limb_target_y * limb3_lower_limb_target_y;
    const REAL limb3_U_0_pivot = SQRT(t96);
    const REAL t97 = 1.0 / limb3_U_0_pivot;
    const REAL minus_limb3_U_0_sin = limb3_lower_limb_target_x * t97;
    const REAL t371 = limb3_upper_position_x * platform_twist_angular_z;
    const REAL t373 = t371 - limb3_lower_limb_target_y * platform_twist_angular_x;
    const REAL t374 = t373 * minus_limb3_U_0_sin;
    const REAL limb3_U_0_cos = limb3_lower_limb_target_y * t97;
    const REAL t389 = t373 * limb3_U_0_cos;
    const REAL t375 = limb3_lower_limb_target_x * platform_twist_angular_x;
    const REAL t377 = t375 - limb3_upper_position_x * platform_twist_angular_y;
    const REAL t379 = t374 + t377 * limb3_U_0_cos;
    const REAL minus_limb3_U_0_omega_z = t97 * (t389 - t377 * minus_limb3_U_0_sin);
    const REAL minus_limb3_lower_limb_target_z = param_R - limb3_upper_position_x;
    const REAL limb3_lower_limb_length = SQRT(t96 + minus_limb3_lower_limb_target_z * minus_limb3_lower_limb_target_z);
    const REAL t100 = 1.0 / limb3_lower_limb_length;
    const REAL minus_limb3_lower_sin = minus_limb3_lower_limb_target_z * t100;
    const REAL limb3_lower_cos = limb3_U_0_pivot * t100;
    const REAL t385 = minus_limb3_lower_sin * t379;
    const REAL t380 = limb3_lower_cos * t379;
    const REAL t381 = limb3_lower_limb_target_y * platform_twist_angular_y;
    const REAL t383 = t381 - limb3_lower_limb_target_x * platform_twist_angular_z;
    const REAL limb3_lower_omega_z = t100 * (t385 + t383 * limb3_lower_cos);
    const REAL minus_limb3_S_opening_rate_fx = t380 - t383 * minus_limb3_lower_sin;
    const REAL limb3_lower_omega_x = minus_limb3_lower_sin * minus_limb3_U_0_omega_z;
    const REAL minus_limb3_lower_omega_y = limb3_lower_cos * minus_limb3_U_0_omega_z;
    const REAL minus_limb3_lower_alpha_y = limb3_lower_omega_z * limb3_lower_omega_x;
    const REAL minus_limb3_lower_U_xy = limb3_lower_omega_x * minus_limb3_lower_omega_y;
    const REAL t422 = limb3_lower_limb_length * (2.0 * minus_limb3_lower_alpha_y);
    const REAL t421 = minus_limb3_S_opening_rate_fx * (2.0 * minus_limb3_lower_omega_y);
    const REAL t393 = minus_limb3_U_0_sin * t392;
    const REAL limb3_U_0_alpha_z = t97 * (t422 + t421 + (limb3_U_0_cos * t392 - minus_limb3_U_0_sin * t394));
    const REAL t396 = t393 + limb3_U_0_cos * t394;
    const REAL minus_limb3_lower_alpha_y_2 = minus_limb3_lower_alpha_y - limb3_lower_cos * limb3_U_0_alpha_z;
    const REAL limb3_U_0_rate_moment_z = k3 * limb3_U_0_alpha_z;
    const REAL limb3_lower_U_zx_2 = minus_limb3_lower_alpha_y + minus_limb3_lower_alpha_y_2;
    const REAL t432 = k8 * minus_limb3_lower_alpha_y_2 + k9 * minus_limb3_lower_alpha_y;
    const REAL limb3_lower_rate_force_z = limb_lower_mx * limb3_lower_U_zx_2;
    const REAL limb3_upper_acc_z_2 = t421 - (gravity_z * minus_limb3_U_0_sin - limb3_lower_limb_length * limb3_lower_U_zx_2);
    const REAL t428 = limb3_lower_limb_length * (limb_lower_m * limb3_upper_acc_z_2 - limb3_lower_rate_force_z);
    const REAL t429 = limb_lower_mx * limb3_upper_acc_z_2 - t428;
    const REAL t434 = limb3_lower_cos * (t429 - (t432 - gravity_z_limb_lower_mx * minus_limb3_U_0_sin));
    const REAL limb3_U_0_force_moment_z = minus_limb3_lower_sin * (k10 * (limb3_lower_omega_z * minus_limb3_lower_omega_y)) + t434 + limb3_U_0_rate_moment_z;
    const REAL minus_limb3_S_multiplier_fz = t97 * limb3_U_0_force_moment_z;
    const REAL t410 = minus_limb3_lower_omega_y * minus_limb3_lower_omega_y;
    const REAL t535 = limb3_U_0_cos * minus_limb3_S_multiplier_fz;
    const REAL t435 = minus_limb3_U_0_sin * minus_limb3_S_multiplier_fz;
    /* limb3: accelerations; loop closure; momentum rate, eq. (35) */
    const REAL t388 = minus_limb3_S_opening_rate_fx * (2.0 * limb3_lower_omega_z);
    const REAL minus_limb3_lower_U_xx = t410 + limb3_lower_omega_z * limb3_lower_omega_z;
    const REAL minus_limb3_upper_acc_y = limb3_lower_limb_length * minus_limb3_lower_U_xy - t388;
    const REAL t412 = limb3_lower_cos * t396;
    const REAL limb3_lower_alpha_z = t100 * (minus_limb3_upper_acc_y - (minus_limb3_lower_sin * t396 + limb3_lower_cos * t398));
    const REAL t414 = t412 - minus_limb3_lower_sin * t398;
    const REAL minus_limb3_lower_U_yx = minus_limb3_lower_U_xy - limb3_lower_alpha_z;
    const REAL t407 = k9 * limb3_lower_alpha_z - k8 * minus_limb3_lower_U_xy;
    const REAL t401 = limb3_lower_limb_length * minus_limb3_lower_U_yx;
    const REAL minus_limb3_lower_rate_force_y = limb_lower_mx * minus_limb3_lower_U_yx;
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y;
    const REAL limb3_upper_acc_y = t388 + (limb3_lower_acc_y - t401);
    const REAL limb3_lower_rate_moment_z = t407 + limb_lower_mx * limb3_lower_acc_y;
    const REAL limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y;
    /* limb3: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL t403 = limb3_lower_limb_length * (limb_lower_m * limb3_upper_acc_y + minus_limb3_lower_rate_force_y);
    const REAL minus_limb3_S_multiplier_fy = t100 * (limb_lower_mx * limb3_upper_acc_y - t403 - limb3_lower_rate_moment_z);
    const REAL minus_limb3_upper_acc_x = limb3_lower_limb_length * minus_limb3_lower_U_xx;
    const REAL limb3_lower_force_x = limb_lower_m * (minus_limb3_upper_acc_x - t414 - (minus_limb3_upper_acc_x - limb3_lower_acc_x));
    const REAL limb3_upper_rate_force_x = limb3_lower_force_x + limb_lower_mx * minus_limb3_lower_U_xx;
    const REAL t436 = minus_limb3_lower_sin * minus_limb3_S_multiplier_fy;
    const REAL t409 = limb3_lower_cos * minus_limb3_S_multiplier_fy;
    const REAL t438 = t436 - limb3_lower_cos * limb3_upper_rate_force_x;
    const REAL t417 = t409 + minus_limb3_lower_sin * limb3_upper_rate_force_x;
    const REAL t537 = t535 + minus_limb3_U_0_sin * t438;
    const REAL t440 = t435 - limb3_U_0_cos * t438;
    const REAL base_lever_force_y_by_limb3_S_fx = minus_limb3_U_0_sin * limb3_lower_cos;
    const REAL base_lever_force_z_by_limb3_S_fx = limb3_U_0_cos * limb3_lower_cos;
    const REAL t564 = limb3_lower_limb_target_y * t537;
    const REAL t541 = t534 + (limb3_upper_position_x * t537 - limb3_lower_limb_target_x * t417); /* platform */
    const REAL t418 = limb3_lower_limb_target_y * t417;
    /* limb4: reciprocal wrenches, eq. (10); geometry */
    const REAL t108 = limb4_lower_limb_target_x * limb4_lower_limb_target_x;
    const REAL t110 = t108 + limb4_lower_limb_target_y * limb4_lower_limb_target_y;
    const REAL limb4_U_0_lever_moment_z_by_limb4_S_fz = SQRT(t110);
    const REAL t111 = 1.0 / limb4_U_0_lever_moment_z_by_limb4_S_fz;
    const REAL limb4_U_0_sin = limb4_lower_limb_target_x * t111;
    /* limb4: loop closure; accelerations; balance, eqs. (40)-(47) */
    const REAL t444 = limb4_upper_position_y * platform_twist_angular_x;
    const REAL t455 = limb4_lower_limb_target_x * platform_twist_angular_x;
    const REAL t446 = t444 - limb4_lower_limb_target_y * platform_twist_angular_y;
    const REAL t448 = limb4_lower_limb_target_x * platform_twist_angular_y;
    const REAL t447 = t446 * limb4_U_0_sin;
    const REAL minus_limb4_U_0_cos = limb4_lower_limb_target_y * t111;
    const REAL t458 = t446 * minus_limb4_U_0_cos;
    const REAL t450 = t448 - limb4_upper_position_y * platform_twist_angular_z;
    const REAL t456 = limb4_lower_limb_target_y * platform_twist_angular_z - t455;
    const REAL t452 = t447 + t450 * minus_limb4_U_0_cos;
    const REAL minus_limb4_U_0_omega_z = t111 * (t458 - t450 * limb4_U_0_sin);
    const REAL minus_limb4_lower_limb_target_z = param_R - limb4_upper_position_y;
    const REAL limb4_lower_limb_length = SQRT(t110 + minus_limb4_lower_limb_target_z * minus_limb4_lower_limb_target_z);
    const REAL t114 = 1.0 / limb4_lower_limb_length;
    const REAL minus_limb4_lower_sin = minus_limb4_lower_limb_target_z * t114;
    const REAL minus_limb4_lower_cos = limb4_U_0_lever_moment_z_by_limb4_S_fz * t114;
    const REAL t461 = minus_limb4_lower_cos * t452;
    const REAL minus_limb4_lower_omega_z = t114 * (minus_limb4_lower_sin * t452 + t456 * minus_limb4_lower_cos);
    const REAL minus_limb4_S_opening_rate_fx = t461 - t456 * minus_limb4_lower_sin;
    const REAL limb4_lower_omega_x = minus_limb4_lower_sin * minus_limb4_U_0_omega_z;
    const REAL limb4_lower_omega_y = minus_limb4_lower_cos * minus_limb4_U_0_omega_z;
    const REAL limb4_lower_alpha_y = minus_limb4_lower_omega_z * limb4_lower_omega_x;
    const REAL limb4_lower_U_xy = limb4_lower_omega_x * limb4_lower_omega_y;
    const REAL t465 = limb4_lower_limb_length * (2.0 * limb4_lower_alpha_y);
    const REAL t464 = minus_limb4_S_opening_rate_fx * (2.0 * limb4_lower_omega_y);
    const REAL t484 = limb4_U_0_sin * t466;
    const REAL limb4_U_0_alpha_z = t111 * (t465 + t464 - (minus_limb4_U_0_cos * t466 - limb4_U_0_sin * t468));
    const REAL t486 = t484 + minus_limb4_U_0_cos * t468;
    const REAL limb4_lower_alpha_y_2 = limb4_lower_alpha_y - minus_limb4_lower_cos * limb4_U_0_alpha_z;
    const REAL limb4_U_0_rate_moment_z = k3 * limb4_U_0_alpha_z;
    const REAL minus_limb4_lower_U_zx_2 = limb4_lower_alpha_y + limb4_lower_alpha_y_2;
    const REAL t477 = k8 * limb4_lower_alpha_y_2 + k9 * limb4_lower_alpha_y;
    const REAL minus_limb4_lower_rate_force_z = limb_lower_mx * minus_limb4_lower_U_zx_2;
    const REAL minus_limb4_upper_acc_z_2 = t464 + (gravity_z * minus_limb4_U_0_cos + limb4_lower_limb_length * minus_limb4_lower_U_zx_2);
    const REAL t473 = limb4_lower_limb_length * (limb_lower_m * minus_limb4_upper_acc_z_2 - minus_limb4_lower_rate_force_z);
    const REAL t474 = limb_lower_mx * minus_limb4_upper_acc_z_2 - t473;
    const REAL t479 = minus_limb4_lower_cos * (t474 - (t477 + gravity_z_limb_lower_mx * minus_limb4_U_0_cos));
    const REAL limb4_U_0_force_moment_z = minus_limb4_lower_sin * (k10 * (minus_limb4_lower_omega_z * limb4_lower_omega_y)) + t479 + limb4_U_0_rate_moment_z;
    const REAL limb4_S_multiplier_fz = t111 * limb4_U_0_force_moment_z;
    const REAL t500 = limb4_lower_omega_y * limb4_lower_omega_y;
    const REAL t480 = limb4_U_0_sin * limb4_S_multiplier_fz;
    const REAL t511 = minus_limb4_U_0_cos * limb4_S_multiplier_fz;
    /* limb4: accelerations; loop closure; momentum rate, eq. (35) */
    const REAL t482 = minus_limb4_S_opening_rate_fx * (2.0 * minus_limb4_lower_omega_z);
    const REAL minus_limb4_lower_U_xx = t500 + minus_limb4_lower_omega_z * minus_limb4_lower_omega_z;
    const REAL limb4_upper_acc_y = limb4_lower_limb_length * limb4_lower_U_xy - t482;
    const REAL t502 = minus_limb4_lower_cos * t486;
    const REAL minus_limb4_lower_alpha_z = t114 * (limb4_upper_acc_y + (minus_limb4_lower_sin * t486 + minus_limb4_lower_cos * t488));
    const REAL t504 = t502 - minus_limb4_lower_sin * t488;
    const REAL limb4_lower_U_yx = limb4_lower_U_xy - minus_limb4_lower_alpha_z;
    const REAL t497 = k9 * minus_limb4_lower_alpha_z - k8 * limb4_lower_U_xy;
    const REAL t491 = limb4_lower_limb_length * limb4_lower_U_yx;
    const REAL limb4_lower_rate_force_y = limb_lower_mx * limb4_lower_U_yx;
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y;
    const REAL minus_limb4_upper_acc_y = t482 + (minus_limb4_lower_acc_y - t491);
    const REAL minus_limb4_lower_rate_moment_z = t497 + limb_lower_mx * minus_limb4_lower_acc_y;
    const REAL limb4_lower_acc_x = minus_limb4_lower_cos * minus_limb4_U_0_acc_y;
    /* limb4: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL t493 = limb4_lower_limb_length * (limb_lower_m * minus_limb4_upper_acc_y + limb4_lower_rate_force_y);
    const REAL limb4_S_multiplier_fy = t114 * (limb_lower_mx * minus_limb4_upper_acc_y - t493 - minus_limb4_lower_rate_moment_z);
    const REAL minus_limb4_upper_acc_x = limb4_lower_limb_length * minus_limb4_lower_U_xx;
    const REAL limb4_lower_force_x = limb_lower_m * (minus_limb4_upper_acc_x + t504 - (minus_limb4_upper_acc_x - limb4_lower_acc_x));
    const REAL limb4_upper_rate_force_x = limb4_lower_force_x + limb_lower_mx * minus_limb4_lower_U_xx;
    const REAL t499 = minus_limb4_lower_sin * limb4_S_multiplier_fy;
    const REAL t542 = minus_limb4_lower_cos * limb4_S_multiplier_fy;
    const REAL t507 = t499 - minus_limb4_lower_cos * limb4_upper_rate_force_x;
    const REAL t544 = t542 + minus_limb4_lower_sin * limb4_upper_rate_force_x;
    const REAL t509 = t480 - minus_limb4_U_0_cos * t507;
    const REAL t513 = t511 + limb4_U_0_sin * t507;
    const REAL base_lever_force_x_by_limb4_S_fx = minus_limb4_U_0_cos * minus_limb4_lower_cos;
    const REAL base_lever_force_z_by_limb4_S_fx = limb4_U_0_sin * minus_limb4_lower_cos;
    const REAL t510 = limb4_lower_limb_target_x * t509;
    const REAL minus_platform_joint_force_moment_z = t541 + (limb4_lower_limb_target_y * t544 + limb4_upper_position_y * t509);
    const REAL t568 = limb4_lower_limb_target_x * t544;
    /* limb1: reciprocal wrenches, eq. (10); loop closure; balance, eqs. (40)-(47) */
    const REAL t41 = platform_turn_yy * limb1_U_0_sin + platform_turn_zy * minus_limb1_U_0_cos;
    const REAL t46 = platform_turn_zy * limb1_U_0_sin;
    const REAL t586 = limb1_lower_sin * t41;
    const REAL limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t41 - platform_turn_xy * limb1_lower_sin;
    const REAL minus_limb1_U2_part_fy_by_limb1_U2_mn = t33 * limb1_U2_constraint_mn_couple_z;
    const REAL minus_limb1_U_0_force_y_by_limb1_U2_mn = limb1_lower_sin * minus_limb1_U2_part_fy_by_limb1_U2_mn;
    const REAL limb1_U_0_force_z_by_limb1_U2_mn = limb1_lower_cos * minus_limb1_U2_part_fy_by_limb1_U2_mn;
    const REAL t61 = limb1_U_0_sin * minus_limb1_U_0_force_y_by_limb1_U2_mn;
    const REAL t50 = minus_limb1_U_0_cos * minus_limb1_U_0_force_y_by_limb1_U2_mn;
    const REAL minus_limb1_U2_constraint_mn_couple_x = platform_turn_yy * minus_limb1_U_0_cos - t46;
    const REAL t155 = t148 - platform_turn_yy * platform_rate_moment_y - t154; /* platform */
    const REAL t554 = t550 - platform_turn_xy * platform_rate_moment_y - t553; /* platform */
    const REAL limb1_U2_opening_mn = t586 + platform_turn_xy * limb1_lower_cos;
    const REAL t588 = limb1_U2_opening_mn * limb1_U2_opening_mn;
    const REAL t51 = limb1_lower_sin * minus_limb1_U2_constraint_mn_couple_x;
    const REAL minus_limb1_U2_part_fz_by_limb1_U2_mn = t35 * t51;
    const REAL t47 = limb1_lower_cos * minus_limb1_U2_constraint_mn_couple_x;
    /* limb5_S: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); drives */
    const REAL t63 = t61 - minus_limb1_U_0_cos * minus_limb1_U2_part_fz_by_limb1_U2_mn;
    const REAL t53 = t50 + limb1_U_0_sin * minus_limb1_U2_part_fz_by_limb1_U2_mn;
    const REAL t64 = minus_limb1_upper_position_x * t63;
    const REAL t72 = minus_limb1_lower_limb_target_y * t63;
    const REAL t66 = t64 - minus_limb1_lower_limb_target_x * limb1_U_0_force_z_by_limb1_U2_mn;
    const REAL t49 = minus_limb1_lower_limb_target_y * limb1_U_0_force_z_by_limb1_U2_mn; /* limb1 */
    const REAL t44 = minus_limb1_U_0_cos * limb1_U2_constraint_mn_couple_z; /* limb1 */
    const REAL platform_pivot = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z + minus_limb1_U_0_cos * t47 + t66;
    REAL checked0 = platform_pivot;
    const REAL t67 = 1.0 / platform_pivot;
    const REAL limb1_U2_part_mn = minus_platform_joint_force_moment_z * t67;
    const REAL minus_base_lever_moment_y_by_limb1_U2_mn = t44 - limb1_U_0_sin * t47;
    const REAL minus_base_lever_force_y_by_limb1_U2_fx = limb1_U_0_sin * limb1_lower_cos;
    const REAL minus_base_lever_force_z_by_limb1_U2_fx = minus_limb1_U_0_cos * limb1_lower_cos;
    const REAL t56 = minus_base_lever_moment_y_by_limb1_U2_mn - (t49 - minus_limb1_upper_position_x * t53);
    const REAL t74 = t51 - (minus_limb1_lower_limb_target_x * t53 - t72);
    const REAL t548 = t56 * limb1_U2_part_mn;
    const REAL t570 = t74 * limb1_U2_part_mn;
    const REAL t370 = t155 + (t254 + minus_limb1_upper_position_x * t276) - (t364 + limb2_lower_limb_target_y * t367);
    const REAL t562 = t554 - (minus_limb1_lower_limb_target_x * t276 + t556) + (limb2_upper_position_y * t367 + t560);
    const REAL t566 = t562 - (limb3_lower_limb_target_x * t440 + t564);
    const REAL minus_platform_joint_force_moment_y = t370 + (t418 + limb3_upper_position_x * t440) - (t510 + limb4_lower_limb_target_y * t513);
    const REAL minus_limb5_S_balance_wy = minus_platform_joint_force_moment_y + t548;
    const REAL minus_limb5_S_balance_wx = t566 + (limb4_upper_position_y * t513 - t568) + t570;
    const REAL t57 = minus_limb1_upper_position_x * minus_base_lever_force_y_by_limb1_U2_fx; /* limb1 */
    const REAL t70 = minus_limb1_lower_limb_target_y * minus_base_lever_force_y_by_limb1_U2_fx; /* limb1 */
    const REAL t36 = minus_limb1_upper_position_x * minus_base_lever_force_z_by_limb1_U2_fx; /* limb1 */
    const REAL minus_limb1_U2_closure_fx_by_limb5_S_wx = minus_limb1_lower_limb_target_x * minus_base_lever_force_z_by_limb1_U2_fx - t70;
    const REAL limb1_U2_closure_fx_by_limb5_S_wy = minus_limb1_lower_limb_target_y * limb1_lower_sin + t36;
    const REAL limb1_U2_part_mn_by_limb1_P = (t57 + minus_limb1_lower_limb_target_x * limb1_lower_sin) * t67;
    const REAL minus_limb5_S_balance_wx_by_limb1_P = minus_limb1_U2_closure_fx_by_limb5_S_wx + t74 * limb1_U2_part_mn_by_limb1_P;
    const REAL limb5_S_balance_wy_by_limb1_P = limb1_U2_closure_fx_by_limb5_S_wy - t56 * limb1_U2_part_mn_by_limb1_P;
    const REAL t76 = minus_limb5_S_balance_wx_by_limb1_P * minus_limb5_S_balance_wx_by_limb1_P;
    const REAL t90 = limb2_upper_position_y * base_lever_force_x_by_limb2_S_fx; /* limb2 */
    const REAL t87 = limb2_upper_position_y * base_lever_force_z_by_limb2_S_fx; /* limb2 */
    const REAL t122 = limb2_lower_limb_target_x * base_lever_force_x_by_limb2_S_fx; /* limb2 */
    const REAL minus_limb2_S_closure_fx_by_limb5_S_wx = t87 - limb2_lower_limb_target_x * limb2_lower_sin;
    const REAL minus_limb2_S_closure_fx_by_limb5_S_wy = t122 - limb2_lower_limb_target_y * base_lever_force_z_by_limb2_S_fx;
    const REAL limb1_U2_part_mn_by_limb2_P = (limb2_lower_limb_target_y * limb2_lower_sin - t90) * t67;
    const REAL minus_limb5_S_balance_wx_by_limb2_P = minus_limb2_S_closure_fx_by_limb5_S_wx + t74 * limb1_U2_part_mn_by_limb2_P;
    const REAL minus_limb5_S_balance_wy_by_limb2_P = minus_limb2_S_closure_fx_by_limb5_S_wy + t56 * limb1_U2_part_mn_by_limb2_P;
    const REAL t93 = t76 + minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wx_by_limb2_P;
    const REAL t103 = limb3_upper_position_x * base_lever_force_y_by_limb3_S_fx; /* limb3 */
    const REAL t102 = limb3_lower_limb_target_y * base_lever_force_y_by_limb3_S_fx; /* limb3 */
    const REAL t128 = limb3_upper_position_x * base_lever_force_z_by_limb3_S_fx; /* limb3 */
    const REAL minus_limb3_S_closure_fx_by_limb5_S_wx = limb3_lower_limb_target_x * base_lever_force_z_by_limb3_S_fx - t102;
    const REAL limb3_S_closure_fx_by_limb5_S_wy = limb3_lower_limb_target_y * minus_limb3_lower_sin + t128;
    const REAL limb1_U2_part_mn_by_limb3_P = (t103 + limb3_lower_limb_target_x * minus_limb3_lower_sin) * t67;
    const REAL minus_limb5_S_balance_wx_by_limb3_P = minus_limb3_S_closure_fx_by_limb5_S_wx + t74 * limb1_U2_part_mn_by_limb3_P;
    const REAL limb5_S_balance_wy_by_limb3_P = limb3_S_closure_fx_by_limb5_S_wy - t56 * limb1_U2_part_mn_by_limb3_P;
    const REAL t107 = t93 + minus_limb5_S_balance_wx_by_limb3_P * minus_limb5_S_balance_wx_by_limb3_P;
    const REAL t118 = limb4_upper_position_y * base_lever_force_x_by_limb4_S_fx; /* limb4 */
    const REAL t115 = limb4_upper_position_y * base_lever_force_z_by_limb4_S_fx; /* limb4 */
    const REAL t132 = limb4_lower_limb_target_x * base_lever_force_x_by_limb4_S_fx; /* limb4 */
    const REAL minus_limb4_S_closure_fx_by_limb5_S_wx = t115 + limb4_lower_limb_target_x * minus_limb4_lower_sin;
    const REAL minus_limb1_U2_part_mn_by_limb4_P = (limb4_lower_limb_target_y * minus_limb4_lower_sin + t118) * t67;
    const REAL minus_limb4_S_closure_fx_by_limb5_S_wy = t132 - limb4_lower_limb_target_y * base_lever_force_z_by_limb4_S_fx;
    const REAL minus_limb5_S_balance_wx_by_limb4_P = minus_limb4_S_closure_fx_by_limb5_S_wx - t74 * minus_limb1_U2_part_mn_by_limb4_P;
    const REAL minus_limb5_S_balance_wy_by_limb4_P = minus_limb4_S_closure_fx_by_limb5_S_wy - t56 * minus_limb1_U2_part_mn_by_limb4_P;
    /* limb5_S: drives; pivots */
    const REAL drives_share_0_0 = t107 + minus_limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wx_by_limb4_P;
    const REAL t549 = minus_limb5_S_balance_wy * drives_share_0_0; /* limb1 */
    const REAL t137 = minus_limb5_S_balance_wx_by_limb1_P * limb5_S_balance_wy_by_limb1_P;
    const REAL t139 = t137 - minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wy_by_limb2_P;
    const REAL t141 = t139 + minus_limb5_S_balance_wx_by_limb3_P * limb5_S_balance_wy_by_limb3_P;
    const REAL minus_drives_share_0_1 = t141 - minus_limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P;
    const REAL t576 = minus_limb5_S_balance_wy * minus_drives_share_0_1; /* limb1 */
    const REAL t572 = t549 + minus_limb5_S_balance_wx * minus_drives_share_0_1; /* limb1 */
    const REAL t143 = minus_drives_share_0_1 * minus_drives_share_0_1;
    const REAL t121 = limb5_S_balance_wy_by_limb1_P * limb5_S_balance_wy_by_limb1_P;
    const REAL t126 = t121 + minus_limb5_S_balance_wy_by_limb2_P * minus_limb5_S_balance_wy_by_limb2_P;
    const REAL t131 = t126 + limb5_S_balance_wy_by_limb3_P * limb5_S_balance_wy_by_limb3_P;
    const REAL drives_share_1_1 = t131 + minus_limb5_S_balance_wy_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P;
    const REAL value_determinant = drives_share_0_0 * drives_share_1_1 - t143;
    REAL checked1 = value_determinant;
    const REAL t577 = minus_limb5_S_balance_wx * drives_share_1_1 + t576; /* limb1 */
    const REAL t144 = 1.0 / value_determinant;
    const REAL t573 = t144 * t572; /* limb1 */
    const REAL t578 = t144 * t577; /* limb1 */
    const REAL limb1_P_drive = limb5_S_balance_wy_by_limb1_P * t573 - minus_limb5_S_balance_wx_by_limb1_P * t578;
    WRITE(u, 0, limb1_P_drive);
    REAL checked2 = limb1_P_drive;
    const REAL limb2_P_drive = -(minus_limb5_S_balance_wx_by_limb2_P * t578 + minus_limb5_S_balance_wy_by_limb2_P * t573);
    WRITE(u, 1, limb2_P_drive);
    REAL checked3 = limb2_P_drive;
    const REAL t585 = minus_limb5_S_balance_wy_by_limb4_P * t573; /* limb4 */
    RESULT(checked0, u, 2, limb5_S_balance_wy_by_limb3_P * t573 - minus_limb5_S_balance_wx_by_limb3_P * t578);
    RESULT(checked1, u, 3, -(minus_limb5_S_balance_wx_by_limb4_P * t578 + t585));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    NOT_ABOVE(t588, 1.0e-12, 6);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_lower_limb_length, 6.62327e-10) OR /* where the points of limb3_lower coincide */
        SMALL(limb2_lower_limb_length, 6.62327e-10) OR /* where the points of limb2_lower coincide */
        SMALL(limb4_lower_limb_length, 6.62327e-10) OR /* where the points of limb4_lower coincide */
        SMALL(limb1_lower_limb_length, 6.62327e-10) OR /* where the points of limb1_lower coincide */
        SMALL(limb3_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_lever_moment_z_by_limb2_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_lever_moment_z_by_limb4_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(platform_pivot, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(value_determinant, 2.393867125597279e-10), /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

#if !defined(THREE_UPS_UPU_S_VECTORS)

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_inverse_dynamics_packed_lane(const double *restrict q,
    const double *restrict v, const double *restrict a, double *restrict u, const double *restrict sine,
    const double *restrict cosine)
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
    const three_ups_upu_s_vector4 xpack37 = (three_ups_upu_s_vector4){2.2727, 2.2727, 2.2727, 2.2727} *
        xpack23;
    const three_ups_upu_s_vector4 xpack36 = (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439, 2.3439} *
        xpack21;
    const three_ups_upu_s_vector4 xpack38 = xpack36 + xpack37;
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
    const three_ups_upu_s_vector4 xpack32 = xpack31 - xpack30;
    const three_ups_upu_s_vector4 xpack33 = xpack2 * xpack32;
    const three_ups_upu_s_vector4 xpack29 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack28;
    const three_ups_upu_s_vector4 xpack34 = xpack29 + xpack33;
    const three_ups_upu_s_vector4 xpack35 = (three_ups_upu_s_vector4){2.08953, 2.08953, 2.08953, 2.08953} *
        xgathered6;
    const three_ups_upu_s_vector4 xpack39 = xpack38 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack35;
    const three_ups_upu_s_vector4 xpack40 = xpack39 - xpack34;
    const three_ups_upu_s_vector4 xpack41 = xgathered4 * xpack40;
    const three_ups_upu_s_vector4 xpack15 = xgathered2 * xpack14;
    const three_ups_upu_s_vector4 xpack16 = (three_ups_upu_s_vector4){0.0712, 0.0712, 0.0712, 0.0712} *
        xpack15;
    const three_ups_upu_s_vector4 xpack17 = xgathered1 * xpack16;
    const three_ups_upu_s_vector4 xpack42 = xpack17 - xpack41;
    const three_ups_upu_s_vector4 xpack52 = xpack14 * xpack14;
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
    const three_ups_upu_s_vector4 xpack79 = (three_ups_upu_s_vector4){2.2727, 2.2727, 2.2727, 2.2727} *
        xpack66;
    const three_ups_upu_s_vector4 xpack68 = xpack2 * xpack67;
    const three_ups_upu_s_vector4 xpack74 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack67;
    const three_ups_upu_s_vector4 xpack57 = (three_ups_upu_s_vector4){9.81, 9.81, 9.81, 9.81} * xgathered8;
    const three_ups_upu_s_vector4 xpack69 = xgathered1 * xpack57;
    const three_ups_upu_s_vector4 xpack70 = xpack68 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, (-1.0)} *
        xpack69;
    const three_ups_upu_s_vector4 xpack78 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack69;
    const three_ups_upu_s_vector4 xpack58 = xgathered4 * xpack57;
    const three_ups_upu_s_vector4 xpack64 = (three_ups_upu_s_vector4){2.0, 2.0, 2.0, 2.0} * xgathered2;
    const three_ups_upu_s_vector4 xpack65 = xgathered7 * xpack64;
    const three_ups_upu_s_vector4 xpack71 = xpack65 + xpack70;
    const three_ups_upu_s_vector4 xpack73 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack71;
    const three_ups_upu_s_vector4 xpack75 = xpack73 - xpack74;
    const three_ups_upu_s_vector4 xpack76 = xpack2 * xpack75;
    const three_ups_upu_s_vector4 xpack72 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack71;
    const three_ups_upu_s_vector4 xpack77 = xpack72 - xpack76;
    const three_ups_upu_s_vector4 xpack80 = (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439, 2.3439} *
        xgathered9;
    const three_ups_upu_s_vector4 xpack81 = xpack79 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack80;
    const three_ups_upu_s_vector4 xpack82 = xpack81 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack78;
    const three_ups_upu_s_vector4 xpack83 = xpack82 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack77;
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
    const double x407 = 69.4749 * x43;
    const double x408 = x406 + x407;
    const double x409 = x404 - x408;
    const double x514 = x513 * x409;
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
    const double x518 = x517 * x422;
    const double x554 = x553 * x422;
    const double x70 = x51 * x69;
    const double x88 = x46 * x69;
    const double x64 = x46 * x63;
    const double x71 = x64 + x70;
    const double x73 = x72 * x71;
    const double x76 = xpack4[0];
    const double x77 = x73 * x76;
    const double x49 = xpack0[0];
    const double x78 = x49 * x77;
    const double x79 = x71 - x78;
    const double x82 = xpack6[0];
    const double x83 = x82 * x77;
    const double x80 = x48 * x79;
    const double x116 = x72 * x79;
    const double x84 = x72 * x83;
    const double x85 = x80 + x84;
    const double x117 = x48 * x83;
    const double x118 = x116 - x117;
    const double x104 = x46 * x85;
    const double x86 = x51 * x85;
    const double x87 = x51 * x63;
    const double x89 = x87 - x88;
    const double x90 = x48 * x89;
    const double x551 = x63 * x416;
    const double x94 = x92 - x93;
    const double x549 = x92 + x93;
    const double x550 = x549 * x409;
    const double x552 = x550 - x551;
    const double x555 = x552 - x554;
    const double x515 = x94 * x416;
    const double x516 = x514 - x515;
    const double x519 = x516 - x518;
    const double x95 = x72 * x94;
    const double x96 = x90 - x95;
    const double x97 = xpack7[0];
    const double x98 = x96 * x97;
    const double x99 = x82 * x98;
    const double x100 = x96 - x99;
    const double x522 = xpack94[0];
    const double x523 = x519 - x522;
    const double x526 = -xpack91[1];
    const double x527 = x523 + x526;
    const double x511 = -xpack94[2];
    const double x528 = x511 + x527;
    const double x508 = xpack91[3];
    const double x529 = x508 + x528;
    const double x558 = -xpack91[0];
    const double x559 = x555 + x558;
    const double x548 = xpack94[1];
    const double x560 = x548 - x559;
    const double x545 = xpack91[2];
    const double x561 = x545 - x560;
    const double x542 = -xpack94[3];
    const double x562 = x542 + x561;
    const double x105 = x51 * x100;
    const double x106 = x104 + x105;
    const double x107 = 1.0 / x106;
    const double x504 = x107 * x503;
    const double x101 = x46 * x100;
    const double x102 = x86 - x101;
    const double x505 = x118 * x504;
    const double x530 = x505 - x529;
    const double x539 = x102 * x504;
    const double x563 = x539 + x562;
    const three_ups_upu_s_vector4 xpack8 = xgathered6 * xpack0;
    const three_ups_upu_s_vector4 xgathered11 = {x107, x107, x107, x107};
    const three_ups_upu_s_vector4 xpack9 = xpack8 * xgathered11;
    const three_ups_upu_s_vector4 xpack1 = xgathered8 * xpack0;
    const three_ups_upu_s_vector4 xgathered12 = {x102, x118, x102, x118};
    const three_ups_upu_s_vector4 xpack10 = xgathered12 * xpack9;
    const three_ups_upu_s_vector4 xgathered13 = {x118, x102, x118, x102};
    const three_ups_upu_s_vector4 xpack12 = xgathered13 * xpack9;
    const three_ups_upu_s_vector4 xpack11 = xpack1 + xpack10;
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
    const three_ups_upu_s_vector4 every = (three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)(xpack3 +
        xpack99) | ((xpack3 <= (three_ups_upu_s_vector4){6.233100000000001e-10, 6.3211e-10, 6.4044e-10,
        6.284e-10}) & (xpack3 >= -(three_ups_upu_s_vector4){6.233100000000001e-10, 6.3211e-10, 6.4044e-10,
        6.284e-10})));
    return fabs(x106) <= 4.0171000000000005e-10 || fabs(x575) <= 2.393867125597279e-10 || !(x58 >= 0.999999 &&
        x58 <= 1.000001) ? (double)NAN : ((x106 + x575) + (every[0] + every[1])) + (every[2] + every[3]);
}
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
    if (isfinite(three_ups_upu_s_inverse_dynamics_packed_lane(q, v, a, u, sine, cosine))) {
        return 0;
    }
#endif
    return three_ups_upu_s_inverse_dynamics_limb_by_limb(q, v, a, u);
}

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_inverse_dynamics_independent_packed_lane(const double *restrict q,
    const double *restrict y_dot, const double *restrict y_ddot, double *restrict u,
    const double *restrict sine, const double *restrict cosine)
{
    const double x2 = q[2], x5 = q[5], x8 = q[8], x11 = q[11], x12 = q[12], x13 = q[13], x14 = q[14], x15 =
        q[15];
    const double x16 = y_dot[0], x17 = y_dot[1], x18 = y_ddot[0], x19 = y_ddot[1], x25 = sine[0], x20 =
        cosine[0];
    const double x46 = sine[1], x22 = cosine[1], x117 = sine[2], x112 = cosine[2], x668 = sine[3], x114 =
        cosine[3];
    const double x105 = sine[4], x100 = cosine[4], x514 = sine[5], x102 = cosine[5], x93 = sine[6], x85 =
        cosine[6];
    const double x147 = sine[7], x87 = cosine[7];
    const double x26 = x12 * x12;
    const double x27 = x13 * x13;
    const double x28 = x26 + x27;
    const double x29 = x14 * x14;
    const double x30 = x15 * x15;
    const double x31 = x29 + x30;
    const double x32 = x28 + x31;
    const double x35 = x27 + x30;
    const double x204 = x27 + x29;
    const double x33 = 2.0 * x32;
    const double x34 = 4.0 - x33;
    const double x36 = x34 * x35;
    const double x37 = 1.0 - x36;
    const double x153 = 0.5 * x32;
    const double x154 = 1.5 - x153;
    const double x220 = x31 * x34;
    const double x221 = 1.0 - x220;
    const double x205 = x34 * x204;
    const double x206 = 1.0 - x205;
    const double x39 = x15 * x34;
    const double x40 = x14 * x39;
    const double x41 = x13 * x34;
    const double x42 = x12 * x41;
    const double x65 = x14 * x34;
    const double x43 = x40 + x42;
    const double x208 = x40 - x42;
    const double x62 = x20 * x43;
    const double x61 = x25 * x37;
    const double x63 = x61 - x62;
    const double x64 = x22 * x63;
    const double x277 = x46 * x63;
    const double x66 = x13 * x65;
    const double x202 = x12 * x65;
    const double x67 = x12 * x39;
    const double x201 = x13 * x39;
    const double x68 = x66 - x67;
    const double x224 = x66 + x67;
    const double x69 = x46 * x68;
    const double x70 = x64 - x69;
    const three_ups_upu_s_vector4 xgathered0 = {x2, x5, x8, x11};
    const three_ups_upu_s_vector4 xpack2 = xgathered0 + (three_ups_upu_s_vector4){0.3, 0.3, 0.3, 0.3};
    const three_ups_upu_s_vector4 xgathered1 = {x22, x114, x102, x87};
    const three_ups_upu_s_vector4 xpack3 = xgathered1 * xpack2;
    const three_ups_upu_s_vector4 xpack4 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack3;
    const three_ups_upu_s_vector4 xpack7 = xgathered1 * xpack4;
    const double x71 = xpack7[0];
    const double x72 = x70 * x71;
    const three_ups_upu_s_vector4 xgathered2 = {x46, x668, x514, x147};
    const three_ups_upu_s_vector4 xpack5 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered2;
    const three_ups_upu_s_vector4 xpack6 = xpack2 - xpack5;
    const double x56 = xpack6[0];
    const double x73 = x56 * x72;
    const double x74 = x70 - x73;
    const double x79 = x25 * x74;
    const double x75 = x20 * x74;
    const double x44 = x25 * x43;
    const double x38 = x20 * x37;
    const double x45 = x38 + x44;
    const double x47 = x46 * x45;
    const double x50 = xpack4[0];
    const double x51 = x47 * x50;
    const three_ups_upu_s_vector4 xpack16 = xgathered2 * xpack2;
    const three_ups_upu_s_vector4 xpack17 = xpack16 - (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8};
    const double x159 = -xpack17[0];
    const double x160 = x159 * x51;
    const double x157 = x22 * x45;
    const double x161 = x157 - x160;
    const double x162 = x20 * x161;
    const double x163 = x162 + x79;
    const double x164 = 1.0 / x163;
    const double x165 = x25 * x161;
    const double x166 = x165 - x75;
    const double x167 = x164 * x166;
    const double x156 = x13 * x154;
    const double x168 = x156 * x167;
    const double x155 = x12 * x154;
    const double x169 = x155 + x168;
    const double x170 = 0.5 * x169;
    const double x171 = 1.0 / x170;
    const double x175 = x14 * x154;
    const double x176 = x175 * x167;
    const double x172 = x15 * x154;
    const double x177 = x172 - x176;
    const double x178 = 0.5 * x177;
    const double x179 = x171 * x178;
    const double x173 = 0.5 * x172;
    const double x180 = x173 * x179;
    const double x174 = 0.5 * x155;
    const double x181 = x174 + x180;
    const double x182 = 1.0 / x181;
    const double x183 = x17 * x179;
    const double x184 = x16 - x183;
    const double x185 = x182 * x184;
    const double x186 = x173 * x185;
    const double x187 = x17 + x186;
    const double x188 = x171 * x187;
    const double x189 = x166 * x188;
    const double x190 = x164 * x189;
    const double x214 = x43 * x190;
    const double x215 = x37 * x188;
    const double x216 = x68 * x185;
    const double x217 = x215 + x216;
    const double x218 = x214 + x217;
    const double x238 = x43 * x218;
    const double x222 = x201 - x202;
    const double x203 = x201 + x202;
    const double x223 = x222 * x190;
    const double x225 = x224 * x188;
    const double x226 = x221 * x185;
    const double x227 = x225 + x226;
    const double x228 = x223 + x227;
    const double x239 = x222 * x228;
    const double x240 = x238 + x239;
    const double x207 = x206 * x190;
    const double x209 = x208 * x188;
    const double x210 = x203 * x185;
    const double x211 = x209 + x210;
    const double x212 = x207 + x211;
    const double x237 = x206 * x212;
    const double x241 = x237 + x240;
    const three_ups_upu_s_vector4 xgathered3 = {x20, x112, x100, x85};
    const three_ups_upu_s_vector4 xgathered4 = {x241, x241, x241, x241};
    const three_ups_upu_s_vector4 xpack33 = xgathered3 * xgathered4;
    const double x244 = x37 * x218;
    const double x245 = x224 * x228;
    const double x246 = x244 + x245;
    const double x243 = x208 * x212;
    const double x247 = x243 + x246;
    const double x219 = x68 * x218;
    const double x843 = x212 * x218;
    const double x844 = 22.6251 * x843;
    const double x229 = x221 * x228;
    const double x230 = x219 + x229;
    const double x831 = x212 * x228;
    const double x213 = x203 * x212;
    const double x231 = x213 + x230;
    const double x832 = 22.6251 * x831;
    const three_ups_upu_s_vector4 xgathered5 = {x25, x117, x105, x93};
    const three_ups_upu_s_vector4 xgathered6 = {x247, x231, x247, x231};
    const three_ups_upu_s_vector4 xpack34 = xgathered5 * xgathered6;
    const three_ups_upu_s_vector4 xpack35 = xpack34 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack33;
    const double x249 = -xpack35[0];
    const double x282 = x46 * x249;
    const double x281 = x22 * x231;
    const double x283 = x281 - x282;
    const three_ups_upu_s_vector4 xgathered7 = {x190, x190, x190, x190};
    const three_ups_upu_s_vector4 xpack37 = xgathered3 * xgathered7;
    const three_ups_upu_s_vector4 xpack18 = xgathered5 * xgathered7;
    const three_ups_upu_s_vector4 xgathered8 = {x188, x185, x188, x185};
    const three_ups_upu_s_vector4 xpack38 = xgathered5 * xgathered8;
    const three_ups_upu_s_vector4 xpack39 = xpack38 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack37;
    const three_ups_upu_s_vector4 xpack40 = xpack17 * xpack39;
    const three_ups_upu_s_vector4 xpack41 = xpack4 * xpack40;
    const three_ups_upu_s_vector4 xgathered9 = {x185, x188, x185, x188};
    const three_ups_upu_s_vector4 xpack42 = xpack41 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xgathered9;
    const three_ups_upu_s_vector4 xpack19 = xgathered3 * xgathered8;
    const three_ups_upu_s_vector4 xpack20 = xpack18 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack19;
    const three_ups_upu_s_vector4 xpack60 = xgathered1 * xpack42;
    const double x284 = xpack60[0];
    const double x285 = x283 - x284;
    const three_ups_upu_s_vector4 xpack23 = xpack6 * xpack20;
    const three_ups_upu_s_vector4 xpack24 = xpack7 * xpack23;
    const double x197 = xpack24[0];
    const double x303 = x197 * x285;
    const three_ups_upu_s_vector4 xpack44 = xgathered5 * xgathered4;
    const three_ups_upu_s_vector4 xpack45 = xgathered3 * xgathered6;
    const three_ups_upu_s_vector4 xpack46 = xpack44 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack45;
    const double x260 = xpack46[0];
    const double x276 = x197 - x260;
    const double x304 = x276 * x284;
    const double x305 = x303 + x304;
    const three_ups_upu_s_vector4 xpack62 = xpack24 * xpack60;
    const double x306 = xpack62[0];
    const double x307 = x305 - x306;
    const double x308 = x45 * x307;
    const three_ups_upu_s_vector4 xpack98 = (three_ups_upu_s_vector4){0.0712, 0.0712, 0.0712, 0.0712} *
        xpack62;
    const three_ups_upu_s_vector4 xpack99 = xgathered2 * xpack98;
    const double x290 = x22 * x249;
    const double x289 = x46 * x231;
    const double x291 = x289 + x290;
    const three_ups_upu_s_vector4 xpack61 = xgathered2 * xpack42;
    const double x292 = xpack61[0];
    const double x293 = x291 - x292;
    const double x299 = x284 * x293;
    const double x300 = x285 * x292;
    const double x301 = x299 - x300;
    const double x302 = x70 * x301;
    const double x309 = x302 + x308;
    const double x294 = x70 * x285;
    const double x286 = x45 * x285;
    const double x278 = x22 * x68;
    const double x279 = x277 + x278;
    const double x280 = x279 * x276;
    const double x287 = x280 + x286;
    const double x288 = x276 * x287;
    const double x295 = x279 * x293;
    const double x296 = x294 + x295;
    const double x297 = x293 * x296;
    const double x298 = x288 + x297;
    const double x310 = x298 + x309;
    const three_ups_upu_s_vector4 xpack56 = xpack42 * xpack35;
    const three_ups_upu_s_vector4 xpack57 = xpack6 * xpack56;
    const three_ups_upu_s_vector4 xpack0 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered1;
    const three_ups_upu_s_vector4 xpack21 = xpack0 * xpack20;
    const three_ups_upu_s_vector4 xpack125 = xpack0 * xpack56;
    const three_ups_upu_s_vector4 xpack55 = xpack21 * xpack24;
    const three_ups_upu_s_vector4 xpack58 = xpack57 + xpack55;
    const three_ups_upu_s_vector4 xpack30 = xgathered1 * xpack24;
    const three_ups_upu_s_vector4 xpack52 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack30;
    const three_ups_upu_s_vector4 xpack53 = xpack21 - xpack52;
    const three_ups_upu_s_vector4 xpack54 = xpack46 * xpack53;
    const three_ups_upu_s_vector4 xpack59 = xpack54 - xpack58;
    const double x274 = xpack59[0];
    const double x275 = x72 * x274;
    const double x311 = x275 - x310;
    const three_ups_upu_s_vector4 xpack31 = xpack2 * xpack30;
    const three_ups_upu_s_vector4 xpack47 = xpack42 * xpack46;
    const three_ups_upu_s_vector4 xpack48 = xpack17 * xpack47;
    const three_ups_upu_s_vector4 xpack25 = xgathered2 * xpack24;
    const three_ups_upu_s_vector4 xpack26 = xpack2 * xpack25;
    const three_ups_upu_s_vector4 xpack123 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack25;
    const three_ups_upu_s_vector4 xpack124 = xpack46 * xpack123;
    const three_ups_upu_s_vector4 xpack126 = xpack125 + xpack124;
    const three_ups_upu_s_vector4 xpack22 = xgathered1 * xpack21;
    const three_ups_upu_s_vector4 xpack27 = xpack22 - xpack26;
    const three_ups_upu_s_vector4 xpack43 = xpack42 * xpack27;
    const three_ups_upu_s_vector4 xpack49 = xpack43 - xpack48;
    const three_ups_upu_s_vector4 xgathered10 = {x231, x247, x231, x247};
    const three_ups_upu_s_vector4 xpack28 = xpack27 * xgathered10;
    const three_ups_upu_s_vector4 xpack29 = xgathered2 * xpack21;
    const three_ups_upu_s_vector4 xpack32 = xpack29 + xpack31;
    const three_ups_upu_s_vector4 xpack36 = xpack32 * xpack35;
    const three_ups_upu_s_vector4 xpack50 = xpack49 - xpack36;
    const three_ups_upu_s_vector4 xpack51 = xpack50 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack28;
    const double x265 = -xpack51[0];
    const double x266 = x51 * x265;
    const double x312 = x266 + x311;
    const double x313 = x164 * x312;
    const double x314 = x156 * x313;
    const double x315 = 0.5 * x314;
    const double x316 = x156 * x247;
    const double x317 = x175 * x231;
    const double x318 = x316 - x317;
    const double x319 = x155 * x241;
    const double x320 = x318 - x319;
    const double x321 = 0.5 * x320;
    const double x322 = x231 * x321;
    const double x352 = x247 * x321;
    const double x323 = x175 * x241;
    const double x324 = x172 * x247;
    const double x325 = x323 - x324;
    const double x326 = x155 * x231;
    const double x327 = x325 - x326;
    const double x328 = 0.5 * x327;
    const double x329 = x241 * x328;
    const double x330 = x322 - x329;
    const double x348 = x155 * x247;
    const double x332 = x175 * x247;
    const double x343 = x175 * x313;
    const double x344 = 0.5 * x343;
    const double x333 = x156 * x231;
    const double x334 = x332 + x333;
    const double x346 = x156 * x241;
    const double x331 = x172 * x241;
    const double x335 = x331 + x334;
    const double x336 = 0.5 * x335;
    const double x337 = x247 * x336;
    const double x338 = x330 - x337;
    const double x339 = 0.5 * x338;
    const double x340 = x19 - x339;
    const double x341 = x315 - x340;
    const double x342 = x179 * x341;
    const double x345 = x172 * x231;
    const double x347 = x345 - x346;
    const double x349 = x347 - x348;
    const double x354 = x231 * x336;
    const double x350 = 0.5 * x349;
    const double x351 = x241 * x350;
    const double x353 = x351 - x352;
    const double x355 = x353 - x354;
    const double x356 = 0.5 * x355;
    const double x357 = x18 - x356;
    const double x358 = x344 + x357;
    const double x359 = x342 + x358;
    const double x360 = x182 * x359;
    const double x361 = x173 * x360;
    const double x362 = x341 - x361;
    const double x363 = x171 * x362;
    const double x366 = x166 * x363;
    const double x367 = x164 * x366;
    const three_ups_upu_s_vector4 xgathered11 = {x367, x367, x367, x367};
    const three_ups_upu_s_vector4 xpack63 = xgathered3 * xgathered11;
    const three_ups_upu_s_vector4 xgathered12 = {x363, x360, x363, x360};
    const three_ups_upu_s_vector4 xpack64 = xgathered5 * xgathered12;
    const three_ups_upu_s_vector4 xpack65 = xpack63 - xpack64;
    const three_ups_upu_s_vector4 xpack66 = xpack17 * xpack65;
    const three_ups_upu_s_vector4 xpack67 = xpack4 * xpack66;
    const three_ups_upu_s_vector4 xgathered13 = {x360, x363, x360, x363};
    const three_ups_upu_s_vector4 xpack68 = xgathered13 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)}
        * xpack67;
    const three_ups_upu_s_vector4 xgathered14 = {x313, x313, x313, x313};
    const three_ups_upu_s_vector4 xpack69 = xgathered3 * xgathered14;
    const three_ups_upu_s_vector4 xpack70 = xpack17 * xpack69;
    const three_ups_upu_s_vector4 xpack71 = xpack51 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack70;
    const three_ups_upu_s_vector4 xpack72 = xpack4 * xpack71;
    const three_ups_upu_s_vector4 xpack73 = xpack72 - xpack68;
    const three_ups_upu_s_vector4 xpack78 = xgathered1 * xpack73;
    const three_ups_upu_s_vector4 xpack74 = (three_ups_upu_s_vector4){0.1112, 0.1112, 0.1112, 0.1112} *
        xpack73;
    const three_ups_upu_s_vector4 xpack76 = xpack24 * xpack61;
    const three_ups_upu_s_vector4 xpack79 = xpack78 + xpack76;
    const three_ups_upu_s_vector4 xpack135 = xpack60 * xpack61;
    const three_ups_upu_s_vector4 xpack83 = xpack76 + xpack79;
    const three_ups_upu_s_vector4 xpack80 = (three_ups_upu_s_vector4){2.2727, 2.2727, 2.2727, 2.2727} *
        xpack79;
    const three_ups_upu_s_vector4 xpack77 = (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439, 2.3439} *
        xpack76;
    const three_ups_upu_s_vector4 xpack81 = xpack77 + xpack80;
    const three_ups_upu_s_vector4 xpack86 = xpack2 * xpack83;
    const three_ups_upu_s_vector4 xpack84 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack83;
    const three_ups_upu_s_vector4 xpack85 = (three_ups_upu_s_vector4){9.81, 9.81, 9.81, 9.81} * xgathered5;
    const three_ups_upu_s_vector4 xpack87 = xpack86 + xpack85;
    const three_ups_upu_s_vector4 xpack88 = (three_ups_upu_s_vector4){2.0, 2.0, 2.0, 2.0} * xpack60;
    const three_ups_upu_s_vector4 xpack89 = xpack21 * xpack88;
    const three_ups_upu_s_vector4 xpack90 = xpack89 - xpack87;
    const three_ups_upu_s_vector4 xpack110 = xpack60 * xpack60;
    const three_ups_upu_s_vector4 xpack91 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack90;
    const three_ups_upu_s_vector4 xpack92 = xpack91 + xpack84;
    const three_ups_upu_s_vector4 xpack93 = xpack2 * xpack92;
    const three_ups_upu_s_vector4 xpack94 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack90;
    const three_ups_upu_s_vector4 xpack95 = xpack94 - xpack93;
    const three_ups_upu_s_vector4 xpack75 = (three_ups_upu_s_vector4){2.08953, 2.08953, 2.08953, 2.08953} *
        xgathered5;
    const three_ups_upu_s_vector4 xpack82 = xpack81 + xpack75;
    const three_ups_upu_s_vector4 xpack96 = xpack95 + xpack82;
    const three_ups_upu_s_vector4 xpack97 = xgathered1 * xpack96;
    const three_ups_upu_s_vector4 xpack100 = xpack99 - xpack97;
    const three_ups_upu_s_vector4 xpack101 = xpack74 - xpack100;
    const three_ups_upu_s_vector4 xpack102 = xpack4 * xpack101;
    const three_ups_upu_s_vector4 xpack103 = xpack6 * xpack102;
    const three_ups_upu_s_vector4 xpack105 = xpack0 * xpack102;
    const three_ups_upu_s_vector4 xpack104 = xgathered2 * xpack103;
    const three_ups_upu_s_vector4 xpack166 = xgathered1 * xpack103;
    const three_ups_upu_s_vector4 xpack106 = xgathered1 * xpack105;
    const three_ups_upu_s_vector4 xpack107 = xpack104 - xpack106;
    const three_ups_upu_s_vector4 xpack167 = xgathered2 * xpack105;
    const three_ups_upu_s_vector4 xpack168 = xpack166 + xpack167;
    const three_ups_upu_s_vector4 xpack108 = xgathered3 * xpack107;
    const three_ups_upu_s_vector4 xpack163 = xgathered5 * xpack107;
    const three_ups_upu_s_vector4 xpack117 = xgathered5 * xgathered11;
    const double x822 = x313 - x367;
    const three_ups_upu_s_vector4 xpack121 = xgathered5 * xgathered14;
    const three_ups_upu_s_vector4 xpack118 = xgathered3 * xgathered12;
    const three_ups_upu_s_vector4 xpack119 = xpack117 + xpack118;
    const three_ups_upu_s_vector4 xpack137 = xpack6 * xpack119;
    const three_ups_upu_s_vector4 xpack120 = xpack0 * xpack119;
    const three_ups_upu_s_vector4 xpack138 = xpack6 * xpack121;
    const three_ups_upu_s_vector4 xpack139 = xpack59 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack138;
    const three_ups_upu_s_vector4 xpack140 = xpack139 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, (-1.0)} *
        xpack137;
    const three_ups_upu_s_vector4 xpack141 = xpack7 * xpack140;
    const three_ups_upu_s_vector4 xpack122 = xpack0 * xpack121;
    const three_ups_upu_s_vector4 xpack127 = xpack122 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, (-1.0)} *
        xpack126;
    const three_ups_upu_s_vector4 xpack128 = xpack120 - xpack127;
    const three_ups_upu_s_vector4 xpack145 = xpack141 + xpack135;
    const three_ups_upu_s_vector4 xpack142 = (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439, 2.3439} *
        xpack141;
    const three_ups_upu_s_vector4 xpack136 = (three_ups_upu_s_vector4){2.2727, 2.2727, 2.2727, 2.2727} *
        xpack135;
    const three_ups_upu_s_vector4 xpack143 = xpack136 + xpack142;
    const three_ups_upu_s_vector4 xpack149 = xpack2 * xpack145;
    const three_ups_upu_s_vector4 xpack146 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack145;
    const three_ups_upu_s_vector4 xpack113 = (three_ups_upu_s_vector4){9.81, 9.81, 9.81, 9.81} * xgathered3;
    const three_ups_upu_s_vector4 xpack133 = xgathered2 * xpack113;
    const three_ups_upu_s_vector4 xpack150 = xpack149 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack133;
    const three_ups_upu_s_vector4 xpack134 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack133;
    const three_ups_upu_s_vector4 xpack144 = xpack143 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack134;
    const three_ups_upu_s_vector4 xpack114 = xgathered1 * xpack113;
    const three_ups_upu_s_vector4 xpack147 = (three_ups_upu_s_vector4){2.0, 2.0, 2.0, 2.0} * xpack24;
    const three_ups_upu_s_vector4 xpack148 = xpack21 * xpack147;
    const three_ups_upu_s_vector4 xpack151 = xpack150 + xpack148;
    const three_ups_upu_s_vector4 xpack109 = xpack24 * xpack24;
    const three_ups_upu_s_vector4 xpack111 = xpack109 + xpack110;
    const three_ups_upu_s_vector4 xpack152 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack151;
    const three_ups_upu_s_vector4 xpack153 = xpack146 - xpack152;
    const three_ups_upu_s_vector4 xpack154 = xpack2 * xpack153;
    const three_ups_upu_s_vector4 xpack155 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack151;
    const three_ups_upu_s_vector4 xpack156 = xpack154 + xpack155;
    const three_ups_upu_s_vector4 xpack157 = xpack144 - xpack156;
    const three_ups_upu_s_vector4 xpack158 = xpack7 * xpack157;
    const three_ups_upu_s_vector4 xpack159 = xpack6 * xpack158;
    const three_ups_upu_s_vector4 xpack115 = xpack2 * xpack111;
    const three_ups_upu_s_vector4 xpack116 = xpack115 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack114;
    const three_ups_upu_s_vector4 xpack129 = xpack116 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack128;
    const three_ups_upu_s_vector4 xpack130 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack129;
    const three_ups_upu_s_vector4 xpack112 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack111;
    const three_ups_upu_s_vector4 xpack131 = xpack130 - xpack112;
    const three_ups_upu_s_vector4 xpack132 = xpack0 * xpack131;
    const three_ups_upu_s_vector4 xpack160 = xpack159 - xpack132;
    const double x57 = x56 * x51;
    const double x23 = xpack0[0];
    const double x52 = x23 * x51;
    const double x53 = x45 - x52;
    const three_ups_upu_s_vector4 xpack161 = xgathered5 * xpack160;
    const three_ups_upu_s_vector4 xpack162 = xpack108 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack161;
    const three_ups_upu_s_vector4 xpack164 = xgathered3 * xpack160;
    const three_ups_upu_s_vector4 xpack165 = xpack163 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack164;
    const double x833 = x43 * x822;
    const double x834 = x37 * x363;
    const double x835 = x68 * x360;
    const double x836 = x834 - x835;
    const double x837 = x833 - x836;
    const double x838 = 69.4749 * x837;
    const double x839 = x832 - x838;
    const double x830 = 14.62961126155784 * x222;
    const double x840 = x830 - x839;
    const double x972 = x68 * x840;
    const double x996 = x37 * x840;
    const double x841 = x43 * x840;
    const double x842 = 14.62961126155784 * x43;
    const double x845 = x222 * x822;
    const double x823 = x206 * x822;
    const double x846 = x224 * x363;
    const double x824 = x208 * x363;
    const double x847 = x221 * x360;
    const double x848 = x846 - x847;
    const double x849 = x845 - x848;
    const double x850 = 69.4749 * x849;
    const double x851 = x844 + x850;
    const double x852 = x842 - x851;
    const double x853 = x222 * x852;
    const double x854 = x841 - x853;
    const double x825 = x203 * x360;
    const double x826 = x824 - x825;
    const double x827 = x823 - x826;
    const double x828 = 92.1 * x827;
    const double x829 = x206 * x828;
    const double x855 = x829 + x854;
    const double x955 = -xpack162[0];
    const double x956 = x855 - x955;
    const double x821 = -xpack162[1];
    const double x957 = x821 - x956;
    const double x667 = -xpack162[2];
    const double x958 = x667 - x957;
    const double x513 = -xpack162[3];
    const double x959 = x513 + x958;
    const double x973 = x221 * x852;
    const double x974 = x972 - x973;
    const double x997 = x224 * x852;
    const double x998 = x996 - x997;
    const double x971 = x203 * x828;
    const double x975 = x971 + x974;
    const double x995 = x208 * x828;
    const double x999 = x995 + x998;
    const double x970 = -xpack168[0];
    const double x976 = x970 + x975;
    const double x979 = -xpack165[1];
    const double x980 = x976 - x979;
    const double x967 = -xpack168[2];
    const double x981 = x967 + x980;
    const double x964 = -xpack165[3];
    const double x982 = x964 + x981;
    const double x1002 = -xpack165[0];
    const double x1003 = x999 + x1002;
    const double x994 = -xpack168[1];
    const double x1004 = x994 - x1003;
    const double x991 = -xpack165[2];
    const double x1005 = x991 + x1004;
    const double x988 = -xpack168[3];
    const double x1006 = x988 + x1005;
    const double x54 = x22 * x53;
    const double x90 = x46 * x53;
    const double x58 = x46 * x57;
    const double x59 = x54 + x58;
    const double x91 = x22 * x57;
    const double x92 = x90 - x91;
    const double x78 = x20 * x59;
    const double x80 = x78 + x79;
    const double x81 = 1.0 / x80;
    const double x960 = x81 * x959;
    const double x60 = x25 * x59;
    const double x76 = x60 - x75;
    const double x961 = x92 * x960;
    const double x983 = x961 - x982;
    const double x985 = x76 * x960;
    const double x1007 = x985 - x1006;
    const three_ups_upu_s_vector4 xpack8 = xgathered5 * xpack0;
    const three_ups_upu_s_vector4 xgathered15 = {x81, x81, x81, x81};
    const three_ups_upu_s_vector4 xpack9 = xpack8 * xgathered15;
    const three_ups_upu_s_vector4 xpack1 = xgathered3 * xpack0;
    const three_ups_upu_s_vector4 xgathered16 = {x76, x92, x76, x92};
    const three_ups_upu_s_vector4 xpack10 = xgathered16 * xpack9;
    const three_ups_upu_s_vector4 xgathered17 = {x92, x76, x92, x76};
    const three_ups_upu_s_vector4 xpack12 = xgathered17 * xpack9;
    const three_ups_upu_s_vector4 xpack11 = xpack1 + xpack10;
    const three_ups_upu_s_vector4 xpack13 = xpack11 * xpack12;
    const double x123 = xpack13[1], x125 = xpack13[0];
    const double x126 = x123 + x125;
    const double x111 = xpack13[2];
    const double x127 = x111 + x126;
    const double x99 = xpack13[3];
    const double x128 = x99 + x127;
    const double x984 = x128 * x983;
    const three_ups_upu_s_vector4 xpack15 = xpack11 * xpack11;
    const three_ups_upu_s_vector4 xpack14 = xpack12 * xpack12;
    const double x139 = xpack15[1], x140 = xpack14[0];
    const double x141 = x139 + x140;
    const double x138 = xpack14[2];
    const double x142 = x138 + x141;
    const double x137 = xpack15[3];
    const double x143 = x137 + x142;
    const double x1008 = x143 * x1007;
    const double x1009 = x984 - x1008;
    const double x1012 = x128 * x1007;
    const double x129 = x128 * x128;
    const double x132 = xpack14[1], x133 = xpack15[0];
    const double x134 = x132 + x133;
    const double x131 = xpack15[2];
    const double x135 = x131 + x134;
    const double x130 = xpack14[3];
    const double x136 = x130 + x135;
    const double x144 = x136 * x143;
    const double x145 = x129 - x144;
    const double x1013 = x136 * x983;
    const double x1014 = x1012 - x1013;
    const double x146 = 1.0 / x145;
    const double x1010 = x146 * x1009;
    const double x1015 = x146 * x1014;
    const three_ups_upu_s_vector4 xgathered18 = {x1010, x1015, x1010, x1015};
    const three_ups_upu_s_vector4 xpack169 = xpack11 * xgathered18;
    const three_ups_upu_s_vector4 xgathered19 = {x1015, x1010, x1015, x1010};
    const three_ups_upu_s_vector4 xpack170 = xpack12 * xgathered19;
    const three_ups_upu_s_vector4 xpack171 = xpack169 + xpack170;
    const double x1017 = xpack171[0];
    u[0] = x1017;
    const double x1020 = xpack171[1];
    const double x1021 = -x1020;
    u[1] = x1021;
    const double x1024 = xpack171[2];
    const double x1025 = -x1024;
    u[2] = x1025;
    const double x1028 = xpack171[3];
    u[3] = x1028;
    const three_ups_upu_s_vector4 every = (three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)(xpack3 +
        xpack171) | ((xpack3 <= (three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10})
        & (xpack3 >= -(three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10})));
    return fabs(x163) <= 1.0e-09 || fabs(x170) <= 1.0e-09 || fabs(x181) <= 1.0e-09 || fabs(x80) <=
        4.0171000000000005e-10 || fabs(x145) <= 2.393867125597279e-10 || !(x32 >= 0.999999 && x32 <= 1.000001)
        ? (double)NAN : (((x80 + x145) + (x163 + x170)) + ((x181 + every[0]) + (every[1] + every[2]))) +
        every[3];
}
#endif

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
    if (isfinite(three_ups_upu_s_inverse_dynamics_independent_packed_lane(q, y_dot, y_ddot, u, sine, cosine)))
        {
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
    const double x0 = pose[0], x1 = pose[1], x2 = pose[2], x3 = pose[3], x4 = rate[0], x5 = rate[1], x6 =
        rate[2];
    const double x7 = acceleration[0], x8 = acceleration[1], x9 = acceleration[2];
    const double x10 = x0 * x0;
    const double x11 = x1 * x1;
    const double x12 = x10 + x11;
    const double x13 = x2 * x2;
    const double x14 = x3 * x3;
    const double x15 = x13 + x14;
    const double x16 = x12 + x15;
    const double x17 = 2.0 * x16;
    const double x18 = 4.0 - x17;
    const double x25 = x11 + x13;
    const double x63 = x11 + x14;
    const double x26 = x18 * x25;
    const double x27 = 1.0 - x26;
    const double x30 = x15 * x18;
    const double x31 = 1.0 - x30;
    const double x64 = x18 * x63;
    const double x65 = 1.0 - x64;
    const double x21 = x2 * x18;
    const double x37 = x1 * x21;
    const double x22 = x0 * x21;
    const double x19 = x3 * x18;
    const double x42 = x1 * x18;
    const double x43 = x0 * x42;
    const double x38 = x0 * x19;
    const double x39 = x37 + x38;
    const double x72 = x37 - x38;
    const double x40 = 0.5 * x39;
    const double x41 = x2 * x19;
    const double x20 = x1 * x19;
    const double x44 = x41 - x43;
    const double x68 = x41 + x43;
    const double x45 = 0.5196152422706631 * x44;
    const double x124 = 0.5 * x68;
    const double x28 = 0.5196152422706631 * x27;
    const three_ups_upu_s_vector4 xgathered0 = {x40, x28, x40, x28};
    const three_ups_upu_s_vector4 xgathered1 = {x45, x124, x45, x124};
    const three_ups_upu_s_vector4 xpack3 = xgathered0 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xgathered1;
    const three_ups_upu_s_vector4 xpack4 = xpack3 * xpack3;
    const double x23 = x20 - x22;
    const double x33 = x20 + x22;
    const double x24 = 0.5 * x23;
    const double x34 = 0.5196152422706631 * x33;
    const double x127 = 0.5 * x72;
    const three_ups_upu_s_vector4 xgathered2 = {x24, x34, x24, x34};
    const three_ups_upu_s_vector4 xgathered3 = {x28, x127, x28, x127};
    const three_ups_upu_s_vector4 xpack0 = xgathered2 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xgathered3;
    const three_ups_upu_s_vector4 xpack5 = xpack0 * xpack0;
    const three_ups_upu_s_vector4 xpack6 = xpack4 + xpack5;
    const three_ups_upu_s_vector4 xpack13 = three_ups_upu_s_vector4_sqrt(xpack6);
    const three_ups_upu_s_vector4 xpack14 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack13;
    const three_ups_upu_s_vector4 xpack20 = xpack3 * xpack14;
    const double x267 = x4 * x23;
    const double x268 = x5 * x68;
    const double x269 = x267 + x268;
    const double x266 = x6 * x27;
    const double x270 = x266 + x269;
    const double x273 = x5 * x72;
    const double x272 = x4 * x31;
    const double x274 = x272 + x273;
    const double x275 = x6 * x33;
    const double x276 = x274 + x275;
    const double x32 = 0.5 * x31;
    const double x122 = 0.5 * x65;
    const three_ups_upu_s_vector4 xgathered4 = {x32, x45, x32, x45};
    const three_ups_upu_s_vector4 xgathered5 = {x34, x122, x34, x122};
    const three_ups_upu_s_vector4 xpack1 = xgathered4 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xgathered5;
    const three_ups_upu_s_vector4 xgathered6 = {x270, x276, x270, x276};
    const three_ups_upu_s_vector4 xpack42 = xpack1 * xgathered6;
    const double x282 = x4 * x39;
    const double x281 = x5 * x65;
    const double x283 = x281 + x282;
    const double x284 = x6 * x44;
    const double x285 = x283 + x284;
    const three_ups_upu_s_vector4 xgathered7 = {x276, x285, x276, x285};
    const three_ups_upu_s_vector4 xpack43 = xpack0 * xgathered7;
    const three_ups_upu_s_vector4 xpack44 = xpack42 - xpack43;
    const three_ups_upu_s_vector4 xpack45 = xpack44 * xpack20;
    const three_ups_upu_s_vector4 xpack15 = xpack0 * xpack14;
    const three_ups_upu_s_vector4 xpack65 = xpack44 * xpack15;
    const three_ups_upu_s_vector4 xpack46 = xpack3 * xgathered7;
    const three_ups_upu_s_vector4 xpack53 = xpack3 * xgathered6;
    const three_ups_upu_s_vector4 xgathered8 = {x285, x270, x285, x270};
    const three_ups_upu_s_vector4 xpack47 = xpack1 * xgathered8;
    const three_ups_upu_s_vector4 xpack48 = xpack46 - xpack47;
    const three_ups_upu_s_vector4 xpack52 = xpack0 * xgathered8;
    const three_ups_upu_s_vector4 xpack54 = xpack52 - xpack53;
    const three_ups_upu_s_vector4 xpack49 = xpack48 * xpack15;
    const three_ups_upu_s_vector4 xpack50 = xpack45 + xpack49;
    const three_ups_upu_s_vector4 xpack66 = xpack48 * xpack20;
    const three_ups_upu_s_vector4 xpack67 = xpack65 - xpack66;
    const three_ups_upu_s_vector4 xpack68 = xpack14 * xpack67;
    const three_ups_upu_s_vector4 xpack2 = xpack1 + (three_ups_upu_s_vector4){(-0.8), 0.8, (-0.8), (-0.8)};
    const three_ups_upu_s_vector4 xpack7 = xpack2 * xpack2;
    const three_ups_upu_s_vector4 xpack8 = xpack6 + xpack7;
    const three_ups_upu_s_vector4 xpack9 = three_ups_upu_s_vector4_sqrt(xpack8);
    const three_ups_upu_s_vector4 xpack10 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack9;
    const three_ups_upu_s_vector4 xpack11 = xpack2 * xpack10;
    const three_ups_upu_s_vector4 xpack16 = xpack13 * xpack10;
    const three_ups_upu_s_vector4 xpack57 = xpack11 * xpack50;
    const three_ups_upu_s_vector4 xpack51 = xpack16 * xpack50;
    const three_ups_upu_s_vector4 xpack58 = xpack54 * xpack16;
    const three_ups_upu_s_vector4 xpack59 = xpack57 - xpack58;
    const three_ups_upu_s_vector4 xpack60 = xpack10 * xpack59;
    const three_ups_upu_s_vector4 xpack55 = xpack54 * xpack11;
    const three_ups_upu_s_vector4 xpack56 = xpack51 + xpack55;
    const three_ups_upu_s_vector4 xpack69 = xpack11 * xpack68;
    const three_ups_upu_s_vector4 xpack70 = xpack16 * xpack68;
    const three_ups_upu_s_vector4 xpack125 = xpack60 * xpack69;
    const three_ups_upu_s_vector4 xpack71 = xpack69 * xpack70;
    const three_ups_upu_s_vector4 xpack126 = (three_ups_upu_s_vector4){2.0, 2.0, 2.0, 2.0} * xpack125;
    const three_ups_upu_s_vector4 xpack127 = xpack9 * xpack126;
    const three_ups_upu_s_vector4 xpack122 = (three_ups_upu_s_vector4){2.0, 2.0, 2.0, 2.0} * xpack70;
    const three_ups_upu_s_vector4 xpack123 = xpack56 * xpack122;
    const three_ups_upu_s_vector4 xpack128 = xpack127 + xpack123;
    const double x313 = x5 * x5;
    const double x314 = x6 * x6;
    const double x315 = x313 + x314;
    const double x316 = x39 * x315;
    const double x317 = x4 * x5;
    const double x318 = x9 + x317;
    const double x487 = x9 - x317;
    const double x319 = x65 * x318;
    const double x320 = x316 - x319;
    const double x256 = x4 * x6;
    const double x321 = x8 - x256;
    const double x322 = x44 * x321;
    const double x323 = x320 + x322;
    const double x324 = 0.5 * x323;
    const double x325 = x8 + x256;
    const double x257 = 22.6251 * x256;
    const double x326 = x39 * x325;
    const double x249 = x5 * x6;
    const double x327 = x7 - x249;
    const double x328 = x65 * x327;
    const double x329 = x326 - x328;
    const double x330 = x4 * x4;
    const double x331 = x330 + x313;
    const double x489 = x330 + x314;
    const double x332 = x44 * x331;
    const double x333 = x329 - x332;
    const double x334 = 0.5196152422706631 * x333;
    const double x343 = x23 * x325;
    const double x359 = x31 * x325;
    const double x344 = x68 * x327;
    const double x345 = x343 - x344;
    const double x360 = x72 * x327;
    const double x361 = x359 - x360;
    const double x346 = x27 * x331;
    const double x347 = x345 - x346;
    const double x348 = 0.5196152422706631 * x347;
    const double x362 = x33 * x331;
    const double x363 = x361 - x362;
    const double x364 = 0.5196152422706631 * x363;
    const double x488 = x23 * x487;
    const double x490 = x68 * x489;
    const double x491 = x488 + x490;
    const double x492 = x7 + x249;
    const double x250 = 22.6251 * x249;
    const double x493 = x27 * x492;
    const double x494 = x491 - x493;
    const double x495 = 0.5 * x494;
    const three_ups_upu_s_vector4 xgathered9 = {x324, x348, x324, x348};
    const three_ups_upu_s_vector4 xgathered10 = {x334, x495, x334, x495};
    const three_ups_upu_s_vector4 xpack74 = xgathered9 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xgathered10;
    const three_ups_upu_s_vector4 xpack129 = xpack15 * xpack74;
    const three_ups_upu_s_vector4 xpack75 = xpack20 * xpack74;
    const double x337 = x23 * x315;
    const double x353 = x31 * x315;
    const double x338 = x68 * x318;
    const double x339 = x337 - x338;
    const double x354 = x72 * x318;
    const double x355 = x353 - x354;
    const double x340 = x27 * x321;
    const double x341 = x339 + x340;
    const double x342 = 0.5 * x341;
    const double x356 = x33 * x321;
    const double x357 = x355 + x356;
    const double x358 = 0.5 * x357;
    const double x499 = x72 * x489;
    const double x545 = x65 * x489;
    const double x498 = x31 * x487;
    const double x500 = x498 + x499;
    const double x544 = x39 * x487;
    const double x546 = x544 + x545;
    const double x501 = x33 * x492;
    const double x502 = x500 - x501;
    const double x503 = 0.5 * x502;
    const three_ups_upu_s_vector4 xgathered11 = {x342, x364, x342, x364};
    const three_ups_upu_s_vector4 xgathered12 = {x348, x503, x348, x503};
    const three_ups_upu_s_vector4 xpack76 = xgathered11 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)}
        * xgathered12;
    const double x547 = x44 * x492;
    const double x548 = x546 - x547;
    const double x549 = 0.5 * x548;
    const three_ups_upu_s_vector4 xgathered13 = {x358, x334, x358, x334};
    const three_ups_upu_s_vector4 xgathered14 = {x364, x549, x364, x549};
    const three_ups_upu_s_vector4 xpack80 = xgathered13 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)}
        * xgathered14;
    const three_ups_upu_s_vector4 xpack130 = xpack20 * xpack76;
    const three_ups_upu_s_vector4 xpack131 = xpack129 - xpack130;
    const three_ups_upu_s_vector4 xpack132 = xpack128 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack131;
    const three_ups_upu_s_vector4 xpack133 = xpack14 * xpack132;
    const three_ups_upu_s_vector4 xpack77 = xpack15 * xpack76;
    const three_ups_upu_s_vector4 xpack78 = xpack75 + xpack77;
    const three_ups_upu_s_vector4 xpack134 = xpack16 * xpack133;
    const three_ups_upu_s_vector4 xpack135 = xpack125 - xpack134;
    const three_ups_upu_s_vector4 xpack154 = (three_ups_upu_s_vector4){0.1112, 0.1112, 0.1112, 0.1112} *
        xpack133;
    const three_ups_upu_s_vector4 xpack136 = xpack125 + xpack135;
    const three_ups_upu_s_vector4 xpack146 = (three_ups_upu_s_vector4){2.2727, 2.2727, 2.2727, 2.2727} *
        xpack135;
    const three_ups_upu_s_vector4 xpack147 = (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439, 2.3439} *
        xpack125;
    const three_ups_upu_s_vector4 xpack148 = xpack146 + xpack147;
    const three_ups_upu_s_vector4 xpack137 = xpack9 * xpack136;
    const three_ups_upu_s_vector4 xpack142 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack136;
    const double x66 = xpack20[0], x146 = xpack15[1], x172 = xpack20[2], x206 = xpack15[3];
    const three_ups_upu_s_vector4 xgathered15 = {x66, x146, x172, x206};
    const three_ups_upu_s_vector4 xpack124 = (three_ups_upu_s_vector4){9.81, 9.81, 9.81, 9.81} * xgathered15;
    const three_ups_upu_s_vector4 xpack138 = xpack137 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), 1.0} *
        xpack124;
    const three_ups_upu_s_vector4 xpack139 = xpack138 + xpack123;
    const three_ups_upu_s_vector4 xpack141 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack139;
    const three_ups_upu_s_vector4 xpack143 = xpack141 - xpack142;
    const three_ups_upu_s_vector4 xpack144 = xpack9 * xpack143;
    const three_ups_upu_s_vector4 xpack140 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack139;
    const three_ups_upu_s_vector4 xpack145 = xpack140 - xpack144;
    const three_ups_upu_s_vector4 xpack149 = (three_ups_upu_s_vector4){2.08953, 2.08953, 2.08953, 2.08953} *
        xgathered15;
    const three_ups_upu_s_vector4 xpack150 = xpack148 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), 1.0} *
        xpack149;
    const three_ups_upu_s_vector4 xpack151 = xpack145 - xpack150;
    const three_ups_upu_s_vector4 xpack152 = xpack16 * xpack151;
    const three_ups_upu_s_vector4 xpack119 = xpack60 * xpack70;
    const three_ups_upu_s_vector4 xpack120 = (three_ups_upu_s_vector4){0.0712, 0.0712, 0.0712, 0.0712} *
        xpack119;
    const three_ups_upu_s_vector4 xpack121 = xpack11 * xpack120;
    const three_ups_upu_s_vector4 xpack153 = xpack121 + xpack152;
    const three_ups_upu_s_vector4 xpack155 = xpack153 + xpack154;
    const three_ups_upu_s_vector4 xpack156 = xpack14 * xpack155;
    const three_ups_upu_s_vector4 xpack103 = xpack70 * xpack70;
    const three_ups_upu_s_vector4 xpack164 = xpack15 * xpack156;
    const three_ups_upu_s_vector4 xpack157 = xpack20 * xpack156;
    const three_ups_upu_s_vector4 xpack61 = (three_ups_upu_s_vector4){2.0, 2.0, 2.0, 2.0} * xpack60;
    const three_ups_upu_s_vector4 xpack62 = xpack56 * xpack61;
    const three_ups_upu_s_vector4 xpack104 = xpack60 * xpack60;
    const three_ups_upu_s_vector4 xpack105 = xpack103 + xpack104;
    const three_ups_upu_s_vector4 xpack72 = xpack9 * xpack71;
    const three_ups_upu_s_vector4 xpack73 = xpack72 - xpack62;
    const three_ups_upu_s_vector4 xpack79 = xpack11 * xpack78;
    const three_ups_upu_s_vector4 xpack107 = xpack16 * xpack78;
    const three_ups_upu_s_vector4 xpack81 = xpack16 * xpack80;
    const three_ups_upu_s_vector4 xpack82 = xpack79 - xpack81;
    const three_ups_upu_s_vector4 xpack83 = xpack73 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack82;
    const three_ups_upu_s_vector4 xpack84 = xpack10 * xpack83;
    const three_ups_upu_s_vector4 xpack108 = xpack11 * xpack80;
    const three_ups_upu_s_vector4 xpack109 = xpack107 + xpack108;
    const three_ups_upu_s_vector4 xpack85 = xpack71 - xpack84;
    const three_ups_upu_s_vector4 xpack95 = (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439, 2.3439} *
        xpack84;
    const three_ups_upu_s_vector4 xpack96 = (three_ups_upu_s_vector4){2.2727, 2.2727, 2.2727, 2.2727} *
        xpack71;
    const three_ups_upu_s_vector4 xpack97 = xpack95 - xpack96;
    const three_ups_upu_s_vector4 xpack86 = xpack9 * xpack85;
    const three_ups_upu_s_vector4 xpack91 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack85;
    const double x58 = xpack15[0], x133 = xpack20[1], x162 = xpack15[2], x193 = xpack20[3];
    const three_ups_upu_s_vector4 xgathered16 = {x58, x133, x162, x193};
    const three_ups_upu_s_vector4 xpack63 = (three_ups_upu_s_vector4){9.81, 9.81, 9.81, 9.81} * xgathered16;
    const three_ups_upu_s_vector4 xpack64 = xpack11 * xpack63;
    const three_ups_upu_s_vector4 xpack87 = xpack86 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), (-1.0)} *
        xpack64;
    const three_ups_upu_s_vector4 xpack88 = xpack87 - xpack62;
    const three_ups_upu_s_vector4 xpack98 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack64;
    const three_ups_upu_s_vector4 xpack99 = xpack97 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, 1.0} *
        xpack98;
    const three_ups_upu_s_vector4 xpack111 = xpack16 * xpack63;
    const three_ups_upu_s_vector4 xpack90 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack88;
    const three_ups_upu_s_vector4 xpack92 = xpack90 - xpack91;
    const three_ups_upu_s_vector4 xpack93 = xpack9 * xpack92;
    const three_ups_upu_s_vector4 xpack89 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack88;
    const three_ups_upu_s_vector4 xpack94 = xpack89 - xpack93;
    const three_ups_upu_s_vector4 xpack100 = xpack94 + xpack99;
    const three_ups_upu_s_vector4 xpack101 = xpack10 * xpack100;
    const three_ups_upu_s_vector4 xpack106 = xpack9 * xpack105;
    const three_ups_upu_s_vector4 xpack110 = xpack106 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack109;
    const three_ups_upu_s_vector4 xpack112 = xpack106 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), (-1.0)}
        * xpack111;
    const three_ups_upu_s_vector4 xpack113 = xpack110 - xpack112;
    const three_ups_upu_s_vector4 xpack114 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack113;
    const three_ups_upu_s_vector4 xpack115 = (three_ups_upu_s_vector4){0.213, 0.213, 0.213, 0.213} * xpack105;
    const three_ups_upu_s_vector4 xpack116 = xpack114 + xpack115;
    const three_ups_upu_s_vector4 xpack158 = xpack11 * xpack101;
    const three_ups_upu_s_vector4 xpack102 = xpack16 * xpack101;
    const three_ups_upu_s_vector4 xpack159 = xpack16 * xpack116;
    const three_ups_upu_s_vector4 xpack160 = xpack158 + xpack159;
    const three_ups_upu_s_vector4 xpack117 = xpack11 * xpack116;
    const three_ups_upu_s_vector4 xpack118 = xpack102 - xpack117;
    const three_ups_upu_s_vector4 xpack165 = xpack20 * xpack160;
    const three_ups_upu_s_vector4 xpack166 = xpack164 - xpack165;
    const three_ups_upu_s_vector4 xpack161 = xpack15 * xpack160;
    const three_ups_upu_s_vector4 xpack162 = xpack157 + xpack161;
    const double x67 = x65 * x66;
    const double x69 = x68 * x58;
    const double x70 = x67 + x69;
    const double x59 = xpack16[0];
    const double x71 = x59 * x70;
    const double x54 = -xpack11[0];
    const double x929 = x54 * x70;
    const double x73 = x72 * x54;
    const double x74 = x71 - x73;
    const double x53 = xpack10[0];
    const double x82 = x53 * x74;
    const double x85 = x54 * x82;
    const double x83 = x59 * x82;
    const double x101 = x66 * x85;
    const double x86 = x58 * x85;
    const double x76 = x65 * x58;
    const double x77 = x68 * x66;
    const double x78 = x76 - x77;
    const double x87 = x54 * x78;
    const double x57 = xpack14[0];
    const double x88 = x57 * x87;
    const double x79 = x59 * x78;
    const double x102 = x58 * x88;
    const double x103 = x101 - x102;
    const double x89 = x66 * x88;
    const double x90 = x86 + x89;
    const double x594 = xpack166[1], x869 = xpack166[2], x844 = xpack166[3];
    const three_ups_upu_s_vector4 xgathered17 = {x103, x594, x869, x844};
    const three_ups_upu_s_vector4 xpack28 = xpack1 * xgathered17;
    const double x29 = xpack0[0];
    const double x116 = x29 * x103;
    const double x862 = -xpack118[1], x674 = xpack118[2], x876 = xpack118[3];
    const three_ups_upu_s_vector4 xgathered18 = {x83, x862, x674, x876};
    const three_ups_upu_s_vector4 xpack29 = xpack3 * xgathered18;
    const three_ups_upu_s_vector4 xpack30 = xpack28 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), (-1.0)} *
        xpack29;
    const three_ups_upu_s_vector4 xpack21 = xpack0 * xgathered18;
    const double x98 = x66 * x74;
    const double x75 = x58 * x74;
    const double x99 = x58 * x79;
    const double x100 = x98 + x99;
    const double x106 = xpack30[0];
    const double x107 = x100 + x106;
    const double x108 = 1.0 / x107;
    const three_ups_upu_s_vector4 xpack17 = xpack15 * xpack16;
    const double x80 = x66 * x79;
    const double x81 = x75 - x80;
    const three_ups_upu_s_vector4 xpack24 = xpack20 * xpack16;
    const double x930 = x72 * x59;
    const double x931 = x929 + x930;
    const double x932 = x931 * x931;
    const three_ups_upu_s_vector4 xpack25 = xpack1 * xpack24;
    const three_ups_upu_s_vector4 xpack35 = xpack0 * xpack24;
    const three_ups_upu_s_vector4 xpack26 = xpack3 * xpack11;
    const three_ups_upu_s_vector4 xpack27 = xpack25 - xpack26;
    const three_ups_upu_s_vector4 xpack12 = xpack0 * xpack11;
    const three_ups_upu_s_vector4 xpack18 = xpack1 * xpack17;
    const three_ups_upu_s_vector4 xpack19 = xpack12 - xpack18;
    const three_ups_upu_s_vector4 xpack34 = xpack3 * xpack17;
    const three_ups_upu_s_vector4 xpack36 = xpack34 - xpack35;
    const double x97 = xpack27[0], x149 = xpack19[1], x179 = xpack27[2], x209 = -xpack19[3];
    const three_ups_upu_s_vector4 xgathered19 = {x97, x149, x179, x209};
    const three_ups_upu_s_vector4 xgathered20 = {x108, x108, x108, x108};
    const three_ups_upu_s_vector4 xpack31 = xgathered19 * xgathered20;
    const double x590 = xpack162[1], x719 = xpack162[2], x840 = xpack162[3];
    const three_ups_upu_s_vector4 xgathered21 = {x90, x590, x719, x840};
    const three_ups_upu_s_vector4 xpack22 = xpack1 * xgathered21;
    const three_ups_upu_s_vector4 xpack23 = xpack21 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack22;
    const double x92 = xpack23[0];
    const double x93 = x81 - x92;
    const double x46 = xpack3[0];
    const double x115 = x46 * x90;
    const double x117 = x115 - x116;
    const double x118 = x87 - x117;
    const three_ups_upu_s_vector4 xgathered22 = {x118, x93, x118, x93};
    const three_ups_upu_s_vector4 xpack37 = xgathered22 * xpack31;
    const three_ups_upu_s_vector4 xpack38 = xpack37 + (three_ups_upu_s_vector4){1.0, 1.0, 1.0, (-1.0)} *
        xpack36;
    const three_ups_upu_s_vector4 xgathered23 = {x93, x118, x93, x118};
    const three_ups_upu_s_vector4 xpack32 = xgathered23 * xpack31;
    const double x62 = -xpack19[0], x144 = xpack27[1], x225 = -xpack19[2], x204 = xpack27[3];
    const three_ups_upu_s_vector4 xgathered24 = {x62, x144, x225, x204};
    const three_ups_upu_s_vector4 xpack33 = xpack32 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), (-1.0)} *
        xgathered24;
    const three_ups_upu_s_vector4 xpack39 = xpack38 * xpack38;
    const three_ups_upu_s_vector4 xpack40 = xpack33 * xpack33;
    const double x121 = xpack39[0], x153 = xpack40[1];
    const double x154 = x121 + x153;
    const double x183 = xpack39[2];
    const double x184 = x154 + x183;
    const double x213 = xpack40[3];
    const double x214 = x184 + x213;
    const double x215 = xpack40[0], x221 = xpack39[1];
    const double x222 = x215 + x221;
    const double x228 = xpack40[2];
    const double x229 = x222 + x228;
    const double x235 = xpack39[3];
    const double x236 = x229 + x235;
    const double x237 = x214 * x236;
    const three_ups_upu_s_vector4 xpack41 = xpack38 * xpack33;
    const double x238 = -xpack41[0], x239 = xpack41[1];
    const double x240 = x238 - x239;
    const double x241 = -xpack41[2];
    const double x242 = x240 + x241;
    const double x243 = xpack41[3];
    const double x244 = x242 - x243;
    const double x245 = x244 * x244;
    const double x246 = x237 - x245;
    const double x247 = 1.0 / x246;
    const double x35 = xpack1[0], x855 = xpack166[0];
    const double x856 = x35 * x855;
    const double x448 = xpack162[0];
    const double x449 = x35 * x448;
    const three_ups_upu_s_vector4 xpack163 = xpack3 * xpack162;
    const double x403 = xpack118[0];
    const double x857 = x46 * x403;
    const double x858 = x856 - x857;
    const double x404 = x29 * x403;
    const double x450 = x404 + x449;
    const three_ups_upu_s_vector4 xpack167 = xpack0 * xpack166;
    const three_ups_upu_s_vector4 xpack168 = xpack163 + xpack167;
    const double x248 = 14.62961126155784 * x68;
    const double x251 = 69.4749 * x7;
    const double x252 = x250 + x251;
    const double x253 = x248 - x252;
    const double x254 = x39 * x253;
    const double x885 = x31 * x253;
    const double x848 = x23 * x253;
    const double x255 = 14.62961126155784 * x23;
    const double x258 = 69.4749 * x8;
    const double x259 = x257 - x258;
    const double x260 = x255 - x259;
    const double x849 = x68 * x260;
    const double x850 = x848 - x849;
    const double x261 = x65 * x260;
    const double x262 = x254 - x261;
    const double x886 = x72 * x260;
    const double x887 = x885 - x886;
    const double x263 = 92.1 * x9;
    const double x851 = x27 * x263;
    const double x852 = x850 - x851;
    const double x859 = x852 + x858;
    const double x865 = xpack23[1];
    const double x866 = x859 - x865;
    const double x872 = xpack30[2];
    const double x873 = x866 + x872;
    const double x879 = xpack23[3];
    const double x880 = x873 + x879;
    const double x881 = x880 * x108;
    const double x882 = x93 * x881;
    const double x906 = x118 * x881;
    const double x264 = x44 * x263;
    const double x265 = x262 - x264;
    const double x451 = x265 + x450;
    const double x888 = x33 * x263;
    const double x889 = x887 - x888;
    const double x596 = xpack168[1];
    const double x597 = x451 - x596;
    const double x721 = xpack23[2];
    const double x722 = x597 + x721;
    const double x846 = xpack168[3];
    const double x847 = x722 - x846;
    const double x883 = x847 + x882;
    const double x884 = x883 * x214;
    const double x892 = xpack168[0];
    const double x893 = x889 - x892;
    const double x896 = xpack30[1];
    const double x897 = x893 + x896;
    const double x900 = xpack168[2];
    const double x901 = x897 - x900;
    const double x904 = xpack30[3];
    const double x905 = x901 + x904;
    const double x907 = x905 + x906;
    const double x912 = x907 * x236;
    const double x908 = x907 * x244;
    const double x909 = x884 + x908;
    const double x913 = x883 * x244;
    const double x914 = x912 + x913;
    const double x910 = x247 * x909;
    const double x915 = x247 * x914;
    const three_ups_upu_s_vector4 xgathered25 = {x910, x915, x910, x915};
    const three_ups_upu_s_vector4 xpack169 = xpack33 * xgathered25;
    const three_ups_upu_s_vector4 xgathered26 = {x915, x910, x915, x910};
    const three_ups_upu_s_vector4 xpack170 = xpack38 * xgathered26;
    const three_ups_upu_s_vector4 xpack171 = xpack170 + xpack169;
    const double x917 = -xpack171[0];
    u[0] = x917;
    const double x920 = xpack171[1];
    const double x921 = -x920;
    u[1] = x921;
    const double x924 = -xpack171[2];
    u[2] = x924;
    const double x927 = -xpack171[3];
    const double x928 = -x927;
    u[3] = x928;
    const three_ups_upu_s_vector4 every = (three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)(xpack171) |
        ((xpack9 <= (three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10}) & (xpack9
        >= -(three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10})) | ((xpack13 <=
        (three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10}) & (xpack13 >=
        -(three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10})));
    return fabs(x107) <= 4.0171000000000005e-10 || fabs(x246) <= 2.393867125597279e-10 || !(x16 >= 0.999999 &&
        x16 <= 1.000001) || !(x932 <= 1.0e-12) ? (double)NAN : ((x107 + x246) + (every[0] + every[1])) +
        (every[2] + every[3]);
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
