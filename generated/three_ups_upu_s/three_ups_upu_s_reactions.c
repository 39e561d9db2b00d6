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
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1),
      limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin, limb1_U_v_1 = READ(v, 1),
      minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x, limb1_U_a_0 = READ(a, 0),
      limb1_lower_cos = SINES(cosine, 1),
      minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_U_a_0 * limb1_lower_cos,
      limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2), t184 = limb1_upper_offset_x * limb1_lower_U_zx,
      limb1_lower_rate_fz = limb_lower_mx * limb1_lower_U_zx, limb1_U_0_sin = SINES(sine, 0),
      t185 = t184 + gravity_z * limb1_U_0_sin, limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos,
      limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y, limb1_P_v = READ(v, 2),
      minus_limb1_upper_acc_z = limb1_P_v * (2.0 * limb1_lower_omega_y) - t185,
      minus_limb1_upper_rate_fz = limb_lower_m * minus_limb1_upper_acc_z + limb1_lower_rate_fz,
      minus_limb1_upper_rate_my = limb_lower_mx * minus_limb1_upper_acc_z,
      t187 = minus_limb1_upper_rate_my - limb1_upper_offset_x * minus_limb1_upper_rate_fz,
      t190 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y,
      t327 = k16 * minus_limb1_lower_alpha_y + k17 * minus_limb1_lower_alpha_still_y,
      minus_limb1_upper_rate_my_2 = minus_limb1_upper_rate_my + t327,
      limb1_upper_moment_y = gravity_z_limb_lower_mx * limb1_U_0_sin,
      minus_limb1_lower_rate_my_2 = limb1_upper_moment_y + t327,
      t191 = limb1_lower_cos * (t187 + (limb1_upper_moment_y + t190)),
      limb1_lower_alpha_still_x = limb1_U_v_1 * limb1_lower_omega_y, t198 = limb1_lower_omega_y * limb1_lower_omega_y,
      limb1_U_0_moment_z = limb1_lower_sin * (k10 * limb1_lower_alpha_still_x) - t191 + k3 * limb1_U_a_0,
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t19 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    /* limb1: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); geometry */
    const REAL minus_limb1_U2_part_fz = t19 * limb1_U_0_moment_z, minus_limb1_U2_arm_y = param_R * limb1_lower_cos,
      t192 = minus_limb1_U2_arm_y * minus_limb1_U2_part_fz, t193 = limb1_lower_cos * t192,
      t230 = limb1_lower_sin * t192, limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      t194 = limb1_U2_arm_x * minus_limb1_U2_part_fz, t196 = t193 - limb1_lower_sin * t194,
      limb1_U_0_cos = SINES(cosine, 0);
    /* limb1: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb1_U_a_1 = READ(a, 1), t232 = t230 + limb1_lower_cos * t194, t197 = limb1_U_0_cos * t196,
      t261 = limb1_U_0_sin * t196, limb1_lower_U_yx = limb1_U_a_1 + limb1_lower_U_still_xy,
      t203 = limb1_upper_offset_x * limb1_lower_U_yx, limb1_lower_rate_fy = limb_lower_mx * limb1_lower_U_yx,
      limb1_U_0_acc_y = gravity_z * limb1_U_0_cos, minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y,
      t204 = t203 - minus_limb1_lower_acc_y, limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y,
      limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) + t204,
      limb1_upper_rate_fy = limb_lower_m * limb1_upper_acc_y - limb1_lower_rate_fy,
      minus_limb1_upper_rate_mz = limb_lower_mx * limb1_upper_acc_y,
      t206 = minus_limb1_upper_rate_mz - limb1_upper_offset_x * limb1_upper_rate_fy,
      t351 = k19 * limb1_lower_U_still_xy,
      minus_limb1_lower_moment_z = t206 + (limb_lower_mx * minus_limb1_lower_acc_y - (k8 * limb1_lower_U_still_xy + k9 * limb1_U_a_1)),
      limb1_lower_rate_fy_2 = limb1_lower_rate_fy - limb_lower_m * minus_limb1_lower_acc_y,
      t36 = limb1_lower_cos * t19, minus_limb1_U2_part_fy = minus_limb1_lower_moment_z * t36,
      t210 = limb1_U2_arm_x * minus_limb1_U2_part_fy, minus_limb1_lower_U_still_xx = t198 + limb1_U_v_1 * limb1_U_v_1,
      limb1_lower_force_x = limb_lower_m * (READ(a, 2) - (limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x)),
      minus_limb1_lower_rate_fx = limb_lower_mx * minus_limb1_lower_U_still_xx,
      limb1_upper_rate_fx = minus_limb1_lower_rate_fx + limb1_lower_force_x,
      minus_limb1_lower_rate_fx_2 = minus_limb1_lower_rate_fx - limb_lower_m * limb1_lower_acc_x,
      t211 = minus_limb1_U2_arm_y * limb1_upper_rate_fx - t210;
    /* limb5_S: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13),
      t213 = t197 + limb1_U_0_sin * t211, /* limb1 */
      t263 = t261 - limb1_U_0_cos * t211, /* limb1 */
      t2 = limb5_S_q_qw * limb5_S_q_qw, t3 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t4 = t2 + t3,
      t5 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6,
      t8 = t4 + t7, t10 = 4.0 - 2.0 * t8, t11 = t3 + t6, platform_turn_zz = 1.0 - t10 * (t3 + t5),
      platform_turn_yy = 1.0 - t10 * t11, platform_turn_xx = 1.0 - t7 * t10, t14 = limb5_S_q_qz * t10,
      t15 = limb5_S_q_qy * t14, t17 = limb5_S_q_qw * (limb5_S_q_qx * t10), t32 = limb5_S_q_qy * t10,
      platform_turn_zy = t15 + t17, platform_turn_yz = t15 - t17, limb5_S_v_wy = READ(v, 13),
      limb5_S_v_wz = READ(v, 14), minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      platform_U_still_yz = limb5_S_v_wy * limb5_S_v_wz, limb5_S_a_wx = READ(a, 12),
      minus_platform_rate_fy = platform_mz * (limb5_S_a_wx - platform_U_still_yz),
      minus_platform_rate_mx = minus_platform_moment_x - (k12 * platform_U_still_yz + k13 * limb5_S_a_wx),
      t166 = limb5_S_q_qx * t14, t34 = limb5_S_q_qw * t14, t167 = limb5_S_q_qw * t32, t33 = limb5_S_q_qx * t32,
      platform_turn_zx = t166 - t167, platform_turn_xz = t166 + t167, limb5_S_v_wx = READ(v, 12),
      t171 = platform_turn_zx * minus_platform_rate_mx, platform_moment_y = gravity_z_platform_mz * platform_turn_zx,
      platform_U_still_xz = limb5_S_v_wx * limb5_S_v_wz, limb5_S_a_wy = READ(a, 13),
      platform_rate_fx = platform_mz * (limb5_S_a_wy + platform_U_still_xz),
      platform_rate_my = platform_moment_y - (k12 * platform_U_still_xz - k13 * limb5_S_a_wy),
      t176 = t171 - platform_turn_zy * platform_rate_my, platform_rate_mz = platform_Izz * READ(a, 14);
    /* limb2: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3),
      t214 = t176 - platform_turn_zz * platform_rate_mz - t213, /* platform */
      limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin, limb2_U_v_1 = READ(v, 4),
      minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x, limb2_U_a_0 = READ(a, 3),
      limb2_lower_cos = SINES(cosine, 3),
      minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y - limb2_U_a_0 * limb2_lower_cos,
      limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5), t134 = limb2_upper_offset_x * limb2_lower_U_zx,
      limb2_lower_rate_fz = limb_lower_mx * limb2_lower_U_zx, minus_limb2_U_0_cos = SINES(sine, 2),
      t135 = t134 - gravity_z * minus_limb2_U_0_cos, limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos,
      limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y, limb2_P_v = READ(v, 5),
      minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) - t135,
      minus_limb2_upper_rate_fz = limb_lower_m * minus_limb2_upper_acc_z + limb2_lower_rate_fz,
      minus_limb2_upper_rate_my = limb_lower_mx * minus_limb2_upper_acc_z,
      t137 = minus_limb2_upper_rate_my - limb2_upper_offset_x * minus_limb2_upper_rate_fz,
      t140 = k9 * minus_limb2_lower_alpha_still_y + k8 * minus_limb2_lower_alpha_y,
      t405 = k16 * minus_limb2_lower_alpha_y + k17 * minus_limb2_lower_alpha_still_y,
      minus_limb2_upper_rate_my_2 = minus_limb2_upper_rate_my + t405,
      minus_limb2_upper_moment_y = gravity_z_limb_lower_mx * minus_limb2_U_0_cos,
      limb2_lower_rate_my_2 = minus_limb2_upper_moment_y - t405,
      t141 = limb2_lower_cos * (t137 - (minus_limb2_upper_moment_y - t140)),
      limb2_lower_alpha_still_x = limb2_U_v_1 * limb2_lower_omega_y, t149 = limb2_lower_omega_y * limb2_lower_omega_y;
    /* limb2: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); geometry */
    const REAL limb2_U_0_moment_z = limb2_lower_sin * (k10 * limb2_lower_alpha_still_x) - t141 + k3 * limb2_U_a_0,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t130 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      minus_limb2_S_multiplier_fz = t130 * limb2_U_0_moment_z, t161 = limb2_lower_cos * t130,
      minus_limb2_upper_sent_fz = minus_limb2_upper_rate_fz - minus_limb2_S_multiplier_fz,
      minus_limb2_S_arm_y = param_R * limb2_lower_cos, t142 = minus_limb2_S_arm_y * minus_limb2_S_multiplier_fz,
      t143 = limb2_lower_cos * t142, t253 = limb2_lower_sin * t142,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin,
      t145 = limb2_S_arm_x * minus_limb2_S_multiplier_fz, t147 = t143 - limb2_lower_sin * t145,
      limb2_U_0_sin = SINES(cosine, 2);
    /* limb2: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb2_U_a_1 = READ(a, 4), t255 = t253 + limb2_lower_cos * t145, t148 = limb2_U_0_sin * t147,
      t234 = minus_limb2_U_0_cos * t147, limb2_lower_U_yx = limb2_U_a_1 + limb2_lower_U_still_xy,
      t154 = limb2_upper_offset_x * limb2_lower_U_yx, limb2_lower_rate_fy = limb_lower_mx * limb2_lower_U_yx,
      minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin, limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y,
      t155 = t154 + limb2_lower_acc_y, minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y,
      limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + t155,
      limb2_upper_rate_fy = limb_lower_m * limb2_upper_acc_y - limb2_lower_rate_fy,
      minus_limb2_upper_rate_mz = limb_lower_mx * limb2_upper_acc_y,
      t157 = minus_limb2_upper_rate_mz - limb2_upper_offset_x * limb2_upper_rate_fy,
      t426 = k19 * limb2_lower_U_still_xy,
      minus_limb2_lower_moment_z = t157 - (limb_lower_mx * limb2_lower_acc_y + (k8 * limb2_lower_U_still_xy + k9 * limb2_U_a_1)),
      minus_limb2_S_multiplier_fy = minus_limb2_lower_moment_z * t161,
      t162 = limb2_S_arm_x * minus_limb2_S_multiplier_fy,
      limb2_upper_sent_fy = limb2_upper_rate_fy + minus_limb2_S_multiplier_fy,
      limb2_lower_sent_fy = limb2_lower_rate_fy + limb_lower_m * limb2_lower_acc_y + limb2_upper_sent_fy,
      minus_limb2_lower_U_still_xx = t149 + limb2_U_v_1 * limb2_U_v_1,
      limb2_lower_force_x = limb_lower_m * (READ(a, 5) - (limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x)),
      minus_limb2_lower_rate_fx = limb_lower_mx * minus_limb2_lower_U_still_xx,
      limb2_upper_rate_fx = minus_limb2_lower_rate_fx + limb2_lower_force_x,
      minus_limb2_lower_rate_fx_2 = minus_limb2_lower_rate_fx + limb_lower_m * minus_limb2_lower_acc_x,
      t163 = minus_limb2_S_arm_y * limb2_upper_rate_fx - t162;
    /* limb3: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb3_U_v_0 = READ(v, 6), minus_limb3_lower_sin = SINES(sine, 5),
      t215 = t148 + minus_limb2_U_0_cos * t163 + t214, /* platform */
      t236 = t234 - limb2_U_0_sin * t163, /* limb2 */
      minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin, limb3_U_v_1 = READ(v, 7),
      limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x, limb3_U_a_0 = READ(a, 6),
      limb3_lower_cos = SINES(cosine, 5),
      limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_U_a_0 * limb3_lower_cos,
      minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), t98 = limb3_upper_offset_x * minus_limb3_lower_U_zx,
      minus_limb3_lower_rate_fz = limb_lower_mx * minus_limb3_lower_U_zx, limb3_U_0_sin = SINES(sine, 4),
      t99 = t98 - gravity_z * limb3_U_0_sin, limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos,
      minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y, limb3_P_v = READ(v, 8),
      minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) + t99,
      minus_limb3_upper_rate_fz = limb_lower_m * minus_limb3_upper_acc_z - minus_limb3_lower_rate_fz,
      minus_limb3_upper_rate_my = limb_lower_mx * minus_limb3_upper_acc_z,
      t101 = minus_limb3_upper_rate_my - limb3_upper_offset_x * minus_limb3_upper_rate_fz,
      t104 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y,
      t473 = k16 * limb3_lower_alpha_y + k17 * limb3_lower_alpha_still_y,
      minus_limb3_upper_rate_my_2 = minus_limb3_upper_rate_my - t473,
      limb3_upper_moment_y = gravity_z_limb_lower_mx * limb3_U_0_sin,
      minus_limb3_lower_rate_my_2 = limb3_upper_moment_y - t473,
      t105 = limb3_lower_cos * (t101 + (limb3_upper_moment_y - t104)),
      limb3_lower_alpha_still_x = limb3_U_v_1 * limb3_lower_omega_y, t113 = limb3_lower_omega_y * limb3_lower_omega_y;
    /* limb3: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); geometry */
    const REAL minus_limb3_U_0_moment_z = minus_limb3_lower_sin * (k10 * limb3_lower_alpha_still_x) + t105 - k3 * limb3_U_a_0,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t94 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      limb3_S_multiplier_fz = t94 * minus_limb3_U_0_moment_z, t125 = limb3_lower_cos * t94,
      minus_limb3_upper_sent_fz = minus_limb3_upper_rate_fz + limb3_S_multiplier_fz,
      limb3_S_arm_y = param_R * limb3_lower_cos, t106 = limb3_S_arm_y * limb3_S_multiplier_fz,
      t107 = limb3_lower_cos * t106, t221 = minus_limb3_lower_sin * t106,
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin,
      t109 = limb3_S_arm_x * limb3_S_multiplier_fz, t111 = t107 - minus_limb3_lower_sin * t109,
      limb3_U_0_cos = SINES(cosine, 4);
    /* limb3: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb3_U_a_1 = READ(a, 7), t223 = t221 + limb3_lower_cos * t109, t112 = limb3_U_0_cos * t111,
      t250 = limb3_U_0_sin * t111, limb3_lower_U_yx = limb3_U_a_1 - minus_limb3_lower_U_still_xy,
      t118 = limb3_upper_offset_x * limb3_lower_U_yx, limb3_lower_rate_fy = limb_lower_mx * limb3_lower_U_yx,
      limb3_U_0_acc_y = gravity_z * limb3_U_0_cos, limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y,
      t119 = t118 + limb3_lower_acc_y, limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y,
      limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + t119,
      limb3_upper_rate_fy = limb_lower_m * limb3_upper_acc_y - limb3_lower_rate_fy,
      minus_limb3_upper_rate_mz = limb_lower_mx * limb3_upper_acc_y,
      t121 = minus_limb3_upper_rate_mz - limb3_upper_offset_x * limb3_upper_rate_fy,
      t500 = k19 * minus_limb3_lower_U_still_xy,
      minus_limb3_lower_moment_z = t121 - (limb_lower_mx * limb3_lower_acc_y - (k8 * minus_limb3_lower_U_still_xy - k9 * limb3_U_a_1)),
      minus_limb3_S_multiplier_fy = minus_limb3_lower_moment_z * t125,
      t126 = limb3_S_arm_x * minus_limb3_S_multiplier_fy,
      limb3_upper_sent_fy = limb3_upper_rate_fy + minus_limb3_S_multiplier_fy,
      limb3_lower_sent_fy = limb3_lower_rate_fy + limb_lower_m * limb3_lower_acc_y + limb3_upper_sent_fy,
      minus_limb3_lower_U_still_xx = t113 + limb3_U_v_1 * limb3_U_v_1,
      limb3_lower_force_x = limb_lower_m * (READ(a, 8) - (limb3_upper_offset_x * minus_limb3_lower_U_still_xx - limb3_lower_acc_x)),
      minus_limb3_lower_rate_fx = limb_lower_mx * minus_limb3_lower_U_still_xx,
      limb3_upper_rate_fx = minus_limb3_lower_rate_fx + limb3_lower_force_x,
      minus_limb3_lower_rate_fx_2 = minus_limb3_lower_rate_fx - limb_lower_m * limb3_lower_acc_x,
      t127 = limb3_S_arm_y * limb3_upper_rate_fx + t126;
    /* limb4: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb4_U_v_0 = READ(v, 9), minus_limb4_lower_sin = SINES(sine, 7),
      t216 = t112 - limb3_U_0_sin * t127 - t215, /* platform */
      t252 = t250 + limb3_U_0_cos * t127, /* limb3 */
      minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin, limb4_U_v_1 = READ(v, 10),
      limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x, limb4_U_a_0 = READ(a, 9),
      limb4_lower_cos = SINES(cosine, 7),
      limb4_lower_alpha_y = limb4_lower_alpha_still_y + limb4_U_a_0 * limb4_lower_cos,
      minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y,
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11), t62 = limb4_upper_offset_x * minus_limb4_lower_U_zx,
      minus_limb4_lower_rate_fz = limb_lower_mx * minus_limb4_lower_U_zx, minus_limb4_U_0_cos = SINES(sine, 6),
      t63 = t62 + gravity_z * minus_limb4_U_0_cos, limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos,
      minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y, limb4_P_v = READ(v, 11),
      minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + t63,
      minus_limb4_upper_rate_fz = limb_lower_m * minus_limb4_upper_acc_z - minus_limb4_lower_rate_fz,
      minus_limb4_upper_rate_my = limb_lower_mx * minus_limb4_upper_acc_z,
      t65 = minus_limb4_upper_rate_my - limb4_upper_offset_x * minus_limb4_upper_rate_fz,
      t68 = k9 * limb4_lower_alpha_still_y + k8 * limb4_lower_alpha_y,
      t542 = k16 * limb4_lower_alpha_y + k17 * limb4_lower_alpha_still_y,
      minus_limb4_upper_rate_my_2 = minus_limb4_upper_rate_my - t542,
      minus_limb4_upper_moment_y = gravity_z_limb_lower_mx * minus_limb4_U_0_cos,
      limb4_lower_rate_my_2 = minus_limb4_upper_moment_y + t542,
      t69 = limb4_lower_cos * (t65 - (minus_limb4_upper_moment_y + t68)),
      limb4_lower_alpha_still_x = limb4_U_v_1 * limb4_lower_omega_y, t77 = limb4_lower_omega_y * limb4_lower_omega_y;
    /* limb4: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); geometry */
    const REAL minus_limb4_U_0_moment_z = minus_limb4_lower_sin * (k10 * limb4_lower_alpha_still_x) + t69 - k3 * limb4_U_a_0,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked3 = minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t58 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_S_multiplier_fz = t58 * minus_limb4_U_0_moment_z, t89 = limb4_lower_cos * t58,
      minus_limb4_upper_sent_fz = minus_limb4_upper_rate_fz + limb4_S_multiplier_fz,
      limb4_S_arm_y = param_R * limb4_lower_cos, t70 = limb4_S_arm_y * limb4_S_multiplier_fz,
      t71 = limb4_lower_cos * t70, t247 = minus_limb4_lower_sin * t70,
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      t73 = limb4_S_arm_x * limb4_S_multiplier_fz, t75 = t71 - minus_limb4_lower_sin * t73,
      limb4_U_0_sin = SINES(cosine, 6);
    /* limb4: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb4_U_a_1 = READ(a, 10), t249 = t247 + limb4_lower_cos * t73, t76 = limb4_U_0_sin * t75,
      t218 = minus_limb4_U_0_cos * t75, limb4_lower_U_yx = limb4_U_a_1 - minus_limb4_lower_U_still_xy,
      t82 = limb4_upper_offset_x * limb4_lower_U_yx, limb4_lower_rate_fy = limb_lower_mx * limb4_lower_U_yx,
      minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y, t83 = t82 - minus_limb4_lower_acc_y,
      minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y,
      limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) + t83,
      limb4_upper_rate_fy = limb_lower_m * limb4_upper_acc_y - limb4_lower_rate_fy,
      minus_limb4_upper_rate_mz = limb_lower_mx * limb4_upper_acc_y,
      t85 = minus_limb4_upper_rate_mz - limb4_upper_offset_x * limb4_upper_rate_fy,
      t562 = k19 * minus_limb4_lower_U_still_xy,
      minus_limb4_lower_rate_mz = limb_lower_mx * minus_limb4_lower_acc_y + (k8 * minus_limb4_lower_U_still_xy - k9 * limb4_U_a_1),
      minus_limb4_S_multiplier_fy = (t85 + minus_limb4_lower_rate_mz) * t89,
      t90 = limb4_S_arm_x * minus_limb4_S_multiplier_fy,
      limb4_upper_sent_fy = limb4_upper_rate_fy + minus_limb4_S_multiplier_fy,
      limb4_lower_sent_fy = limb4_lower_rate_fy - limb_lower_m * minus_limb4_lower_acc_y + limb4_upper_sent_fy,
      minus_limb4_lower_U_still_xx = t77 + limb4_U_v_1 * limb4_U_v_1,
      limb4_upper_acc_x = READ(a, 11) - (limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_lower_acc_x),
      limb4_lower_force_x = limb_lower_m * limb4_upper_acc_x,
      minus_limb4_lower_rate_fx = limb_lower_mx * minus_limb4_lower_U_still_xx,
      limb4_upper_rate_fx = minus_limb4_lower_rate_fx + limb4_lower_force_x,
      minus_limb4_lower_rate_fx_2 = minus_limb4_lower_rate_fx + limb_lower_m * minus_limb4_lower_acc_x,
      t91 = limb4_S_arm_y * limb4_upper_rate_fx + t90,
      minus_platform_joint_force_mz = t76 - minus_limb4_U_0_cos * t91 - t216, t220 = t218 + limb4_U_0_sin * t91;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; balance, eqs. (40)-(47) */
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t19,
      t21 = limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3,
      t22 = limb1_lower_cos * t21, t45 = limb1_lower_sin * t21, t24 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3,
      t26 = t22 + limb1_lower_sin * t24, platform_joint_force_mx_by_limb1_U2_mn = t45 - limb1_lower_cos * t24,
      t40 = limb1_U_0_cos * t26, t27 = limb1_U_0_sin * t26,
      t31 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy);
    /* platform: geometry */
    const REAL platform_turn_xy = t33 - t34, platform_turn_yx = t33 + t34,
      limb1_U2_constraint_mn_couple_z = t31 - limb1_lower_sin * platform_turn_xy,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t36,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    /* limb5_S: balance, eqs. (40)-(47); drives */
    const REAL platform_joint_force_mz_by_limb1_U2_mn = t40 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    checked0 = checked0 + platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t42 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      limb1_U2_part_mn = t42 * minus_platform_joint_force_mz,
      t39 = t27 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      t217 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn,
      t227 = platform_turn_xx * minus_platform_rate_mx - platform_turn_xy * platform_rate_my,
      t258 = platform_turn_yx * minus_platform_rate_mx - platform_turn_yy * platform_rate_my,
      minus_platform_joint_force_mx = t220 + (t223 + (t227 - platform_turn_xz * platform_rate_mz - t232 + t236)),
      limb5_S_balance_wx = t217 - minus_platform_joint_force_mx,
      minus_platform_joint_force_my = t249 + (t252 - (t255 - (t258 - platform_turn_yz * platform_rate_mz + t263))),
      minus_limb1_U2_part_mn_by_limb2_P = minus_limb2_U_0_cos * minus_limb2_S_arm_y * t42,
      minus_platform_joint_force_mx_by_limb2_P = limb2_U_0_sin * minus_limb2_S_arm_y,
      minus_limb5_S_balance_wx_by_limb2_P = minus_platform_joint_force_mx_by_limb2_P + platform_joint_force_mx_by_limb1_U2_mn * minus_limb1_U2_part_mn_by_limb2_P,
      limb5_S_balance_wy_by_limb2_P = t39 * minus_limb1_U2_part_mn_by_limb2_P,
      t54 = minus_limb5_S_balance_wx_by_limb2_P * limb5_S_balance_wy_by_limb2_P,
      limb1_U2_part_mn_by_limb1_P = limb1_U_0_sin * minus_limb1_U2_arm_y * t42,
      minus_limb5_S_balance_wy_by_limb1_P = limb1_U_0_cos * minus_limb1_U2_arm_y + t39 * limb1_U2_part_mn_by_limb1_P,
      limb5_S_balance_wx_by_limb1_P = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn_by_limb1_P,
      t56 = t54 + minus_limb5_S_balance_wy_by_limb1_P * limb5_S_balance_wx_by_limb1_P,
      minus_limb1_U2_part_mn_by_limb3_P = limb3_U_0_sin * limb3_S_arm_y * t42,
      limb5_S_balance_wy_by_limb3_P = limb3_U_0_cos * limb3_S_arm_y + t39 * minus_limb1_U2_part_mn_by_limb3_P,
      minus_limb5_S_balance_wx_by_limb3_P = platform_joint_force_mx_by_limb1_U2_mn * minus_limb1_U2_part_mn_by_limb3_P,
      t57 = limb5_S_balance_wy_by_limb3_P * minus_limb5_S_balance_wx_by_limb3_P + t56,
      limb1_U2_part_mn_by_limb4_P = minus_limb4_U_0_cos * limb4_S_arm_y * t42,
      t47 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn_by_limb4_P,
      limb5_S_balance_wx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y + t47,
      minus_limb5_S_balance_wy_by_limb4_P = limb1_U2_part_mn_by_limb4_P * t39,
      minus_limb5_S_balance_wy = t39 * limb1_U2_part_mn + minus_platform_joint_force_my;
    /* limb5_S: drives; pivots */
    const REAL minus_drives_share_0_1 = limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P + t57,
      t239 = minus_drives_share_0_1 * limb5_S_balance_wx, /* limb1 */
      t242 = minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wx_by_limb2_P,
      t244 = t242 + limb5_S_balance_wx_by_limb1_P * limb5_S_balance_wx_by_limb1_P,
      t245 = minus_limb5_S_balance_wx_by_limb3_P * minus_limb5_S_balance_wx_by_limb3_P + t244,
      drives_share_0_0 = limb5_S_balance_wx_by_limb4_P * limb5_S_balance_wx_by_limb4_P + t245,
      t268 = t239 - drives_share_0_0 * minus_limb5_S_balance_wy, /* limb1 */
      t280 = minus_drives_share_0_1 * minus_limb5_S_balance_wy, /* limb1 */
      t269 = minus_drives_share_0_1 * minus_drives_share_0_1,
      t273 = minus_limb5_S_balance_wy_by_limb1_P * minus_limb5_S_balance_wy_by_limb1_P,
      t274 = limb5_S_balance_wy_by_limb2_P * limb5_S_balance_wy_by_limb2_P + t273,
      t275 = limb5_S_balance_wy_by_limb3_P * limb5_S_balance_wy_by_limb3_P + t274,
      drives_share_1_1 = minus_limb5_S_balance_wy_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P + t275,
      minus_determinant = t269 - drives_share_1_1 * drives_share_0_0;
    checked1 = checked1 + minus_determinant;
    const REAL t282 = t280 - drives_share_1_1 * limb5_S_balance_wx, /* limb1 */
      t277 = 1.0 / minus_determinant, t278 = t268 * t277, /* limb1 */
      t283 = t277 * t282, /* limb1 */
      minus_limb1_P_drive = minus_limb5_S_balance_wy_by_limb1_P * t278 + limb5_S_balance_wx_by_limb1_P * t283,
      limb2_P_drive = limb5_S_balance_wy_by_limb2_P * t278 + minus_limb5_S_balance_wx_by_limb2_P * t283;
    WRITE(u, 1, limb2_P_drive);
    const REAL t289 = minus_limb5_S_balance_wy_by_limb4_P * t278, /* limb4 */
      limb3_P_drive = limb5_S_balance_wy_by_limb3_P * t278 + minus_limb5_S_balance_wx_by_limb3_P * t283;
    WRITE(u, 2, limb3_P_drive);
    const REAL minus_limb4_P_drive = t289 + limb5_S_balance_wx_by_limb4_P * t283,
      limb1_U2_multiplier_fx = limb1_upper_rate_fx + minus_limb1_P_drive,
      limb2_S_multiplier_fx = limb2_upper_rate_fx - limb2_P_drive,
      limb3_S_multiplier_fx = limb3_upper_rate_fx - limb3_P_drive,
      limb4_S_multiplier_fx = limb4_upper_rate_fx + minus_limb4_P_drive,
      minus_limb4_lower_sent_fx = minus_limb4_lower_rate_fx_2 + minus_limb4_P_drive,
      minus_limb3_lower_sent_fx = minus_limb3_lower_rate_fx_2 - limb3_P_drive,
      minus_limb2_lower_sent_fx = minus_limb2_lower_rate_fx_2 - limb2_P_drive;
    /* limb1: balance, eqs. (40)-(47); drives; reactions, eq. (32) */
    const REAL minus_limb1_lower_sent_fx = minus_limb1_lower_rate_fx_2 + minus_limb1_P_drive;
    RESULT(checked2, u, 3, -minus_limb4_P_drive);
    RESULT(checked3, u, 0, -minus_limb1_P_drive);
    const REAL t294 = minus_limb1_P_drive * (limb1_U_factor_1_by_3 * limb1_U2_part_mn_by_limb1_P),
      t296 = t294 - (minus_limb1_U2_part_fy + limb1_U_factor_1_by_3 * limb1_U2_part_mn),
      t297 = limb2_P_drive * (limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn_by_limb2_P) + t296,
      t298 = limb3_P_drive * (limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn_by_limb3_P) + t297,
      limb1_U2_multiplier_fy = minus_limb4_P_drive * (limb1_U_factor_1_by_3 * limb1_U2_part_mn_by_limb4_P) + t298,
      limb1_upper_sent_fy = limb1_upper_rate_fy - limb1_U2_multiplier_fy,
      limb1_lower_sent_fy = limb1_lower_rate_fy_2 + limb1_upper_sent_fy,
      t631 = limb1_lower_sin * limb1_U2_multiplier_fy - limb1_lower_cos * limb1_U2_multiplier_fx,
      t646 = limb1_U_0_cos * t631, t632 = limb1_U_0_sin * t631,
      t307 = minus_limb1_P_drive * (minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn_by_limb1_P),
      t321 = limb1_U2_part_mn - limb1_U2_part_mn_by_limb1_P * minus_limb1_P_drive,
      t309 = t307 + (minus_limb1_U2_part_fz - minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn),
      t310 = limb2_P_drive * (minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn_by_limb2_P) + t309,
      t322 = minus_limb1_U2_part_mn_by_limb2_P * limb2_P_drive - t321,
      t311 = limb3_P_drive * (minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn_by_limb3_P) + t310,
      t323 = minus_limb1_U2_part_mn_by_limb3_P * limb3_P_drive + t322,
      minus_limb1_U2_multiplier_fz = minus_limb4_P_drive * (minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn_by_limb4_P) + t311,
      minus_limb1_U2_multiplier_mn = limb1_U2_part_mn_by_limb4_P * minus_limb4_P_drive + t323,
      limb1_U2_joint_reaction_mz = limb1_U2_constraint_mn_couple_z * minus_limb1_U2_multiplier_mn,
      limb1_U2_joint_reaction_mx = limb1_U2_constraint_mn_couple_x * minus_limb1_U2_multiplier_mn,
      minus_limb1_upper_sent_fz = minus_limb1_upper_rate_fz - minus_limb1_U2_multiplier_fz,
      t372 = limb1_U_0_sin * minus_limb1_U2_multiplier_fz, t647 = t646 + t372,
      t368 = limb1_U_0_cos * minus_limb1_U2_multiplier_fz, t633 = t632 - t368;
    /* platform: momentum rate, eq. (35) */
    const REAL platform_rate_fx_2 = platform_rate_fx + platform_m_gravity_z * platform_turn_zx;
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t641 = platform_turn_zx * platform_rate_fx_2, t624 = platform_turn_yx * platform_rate_fx_2,
      t607 = platform_turn_xx * platform_rate_fx_2,
      minus_platform_rate_fy_2 = minus_platform_rate_fy - platform_m_gravity_z * platform_turn_zy,
      t643 = t641 - platform_turn_zy * minus_platform_rate_fy_2,
      t626 = t624 - platform_turn_yy * minus_platform_rate_fy_2,
      t610 = t607 - platform_turn_xy * minus_platform_rate_fy_2, t613 = platform_m_gravity_z * platform_turn_zz,
      minus_platform_rate_fz_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t613,
      t648 = t643 - platform_turn_zz * minus_platform_rate_fz_2 - t647,
      t634 = t626 - platform_turn_yz * minus_platform_rate_fz_2 + t633,
      t615 = t610 - platform_turn_xz * minus_platform_rate_fz_2,
      t603 = limb2_lower_cos * limb2_S_multiplier_fx + limb2_lower_sin * minus_limb2_S_multiplier_fy, /* limb2 */
      t639 = limb2_U_0_sin * t603, /* limb2 */
      t604 = minus_limb2_U_0_cos * t603, /* limb2 */
      t450 = minus_limb2_U_0_cos * minus_limb2_S_multiplier_fz, /* limb2 */
      t649 = t450 - t639 + t648, t444 = limb2_U_0_sin * minus_limb2_S_multiplier_fz, /* limb2 */
      t605 = t444 + t604, /* limb2 */
      t621 = limb3_lower_cos * limb3_S_multiplier_fx - minus_limb3_lower_sin * minus_limb3_S_multiplier_fy, /* limb3 */
      t637 = limb3_U_0_cos * t621, /* limb3 */
      t622 = limb3_U_0_sin * t621, /* limb3 */
      t518 = limb3_U_0_sin * limb3_S_multiplier_fz, /* limb3 */
      t650 = t518 + t637 + t649, t514 = limb3_U_0_cos * limb3_S_multiplier_fz, /* limb3 */
      t623 = t514 - t622; /* limb3 */
    /* limb4: balance, eqs. (40)-(47); reactions, eq. (32); geometry */
    const REAL t598 = limb4_lower_cos * limb4_S_multiplier_fx - minus_limb4_lower_sin * minus_limb4_S_multiplier_fy,
      t651 = limb4_U_0_sin * t598, t599 = minus_limb4_U_0_cos * t598,
      t586 = minus_limb4_U_0_cos * limb4_S_multiplier_fz;
    RESULT(checked0, reactions, 74, t650 - (t586 + t651));
    const REAL t580 = limb4_U_0_sin * limb4_S_multiplier_fz, t600 = t580 - t599,
      minus_limb2_S_reaction_fy = limb2_lower_sin * limb2_S_multiplier_fx - limb2_lower_cos * minus_limb2_S_multiplier_fy,
      t636 = t623 + (minus_limb2_S_reaction_fy + t634); /* platform */
    RESULT(checked1, reactions, 31, -minus_limb2_S_reaction_fy);
    const REAL limb4_S_reaction_fy = minus_limb4_lower_sin * limb4_S_multiplier_fx + limb4_lower_cos * minus_limb4_S_multiplier_fy;
    WRITE(reactions, 67, limb4_S_reaction_fy);
    RESULT(checked2, reactions, 73, t636 - limb4_S_reaction_fy);
    const REAL minus_limb1_U2_reaction_fx = limb1_lower_cos * limb1_U2_multiplier_fy + limb1_lower_sin * limb1_U2_multiplier_fx,
      t617 = t605 - (t615 + minus_limb1_U2_reaction_fx); /* platform */
    RESULT(checked3, reactions, 12, -minus_limb1_U2_reaction_fx);
    const REAL limb3_S_reaction_fx = minus_limb3_lower_sin * limb3_S_multiplier_fx + limb3_lower_cos * minus_limb3_S_multiplier_fy;
    WRITE(reactions, 48, limb3_S_reaction_fx);
    RESULT(checked0, reactions, 72, t600 - (limb3_S_reaction_fx + t617));
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos,
      t582 = minus_limb4_lower_rotation_xx * limb4_S_multiplier_fx,
      minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin;
    /* limb4: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    const REAL minus_limb4_S_reaction_fx = t580 + (minus_limb4_lower_rotation_xy * minus_limb4_S_multiplier_fy - t582);
    RESULT(checked1, reactions, 66, -minus_limb4_S_reaction_fx);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      t594 = limb4_upper_position_y * minus_limb4_S_reaction_fx,
      minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx;
    RESULT(checked2, reactions, 71, t594 - minus_limb4_upper_position_x * limb4_S_reaction_fy);
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos,
      t588 = minus_limb4_lower_rotation_zx * limb4_S_multiplier_fx,
      minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin,
      limb4_S_reaction_fz = t586 - (minus_limb4_lower_rotation_zy * minus_limb4_S_multiplier_fy - t588);
    WRITE(reactions, 68, limb4_S_reaction_fz);
    const REAL t592 = minus_limb4_upper_position_x * limb4_S_reaction_fz,
      t591 = limb4_upper_position_y * limb4_S_reaction_fz,
      minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx;
    RESULT(checked3, reactions, 70, t592 + minus_limb4_upper_position_z * minus_limb4_S_reaction_fx);
    RESULT(checked0, reactions, 69, minus_limb4_upper_position_z * limb4_S_reaction_fy + t591);
    const REAL minus_limb4_lower_sent_my = minus_limb4_upper_rate_my_2 - limb4_upper_offset_x * minus_limb4_upper_sent_fz - limb4_lower_rate_my_2,
      minus_limb4_P_reaction_fx = limb4_U_0_sin * minus_limb4_upper_sent_fz + minus_limb4_lower_rotation_xy * limb4_upper_sent_fy,
      t559 = minus_limb4_lower_rotation_xy * minus_limb4_upper_rate_my_2;
    RESULT(checked1, reactions, 60, -minus_limb4_P_reaction_fx);
    const REAL t572 = limb4_upper_position_y * minus_limb4_P_reaction_fx,
      t567 = minus_limb4_upper_position_z * minus_limb4_P_reaction_fx,
      limb4_P_reaction_fy = limb4_lower_cos * limb4_upper_sent_fy;
    WRITE(reactions, 61, limb4_P_reaction_fy);
    const REAL t554 = minus_limb4_lower_rotation_zy * limb4_upper_sent_fy,
      t576 = minus_limb4_lower_rotation_zy * minus_limb4_upper_rate_my_2,
      t570 = limb4_lower_cos * minus_limb4_upper_rate_my_2, t555 = minus_limb4_upper_position_z * limb4_P_reaction_fy,
      t574 = t572 - minus_limb4_upper_position_x * limb4_P_reaction_fy,
      t537 = k14 * (limb4_lower_alpha_still_x - limb4_U_a_0 * minus_limb4_lower_sin),
      limb4_upper_rate_mx = t537 - k15 * limb4_lower_alpha_still_x,
      t577 = minus_limb4_lower_rotation_zx * limb4_upper_rate_mx - t576,
      t560 = minus_limb4_lower_rotation_xx * limb4_upper_rate_mx - t559,
      minus_limb4_upper_rate_mz_2 = minus_limb4_upper_rate_mz - (k18 * limb4_U_a_1 - t562);
    RESULT(checked2, reactions, 65, t574 - (t577 - minus_limb4_U_0_cos * minus_limb4_upper_rate_mz_2));
    const REAL t565 = t560 + limb4_U_0_sin * minus_limb4_upper_rate_mz_2,
      limb4_P_reaction_fz = minus_limb4_U_0_cos * minus_limb4_upper_sent_fz - t554;
    WRITE(reactions, 62, limb4_P_reaction_fz);
    const REAL t568 = minus_limb4_upper_position_x * limb4_P_reaction_fz + t567;
    RESULT(checked3, reactions, 63, t555 + limb4_upper_position_y * limb4_P_reaction_fz - t565);
    RESULT(checked0, reactions, 64, t568 - (minus_limb4_lower_sin * limb4_upper_rate_mx + t570));
    /* limb4: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL limb4_lower_sent_mx = 2.0 * limb4_upper_rate_mx,
      t533 = minus_limb4_lower_sin * minus_limb4_lower_sent_fx,
      limb4_lower_joint_sent_fx = minus_limb4_lower_sin * limb4_lower_sent_fy - limb4_lower_cos * minus_limb4_lower_sent_fx;
    RESULT(checked1, reactions, 55, limb4_lower_cos * limb4_lower_sent_fy + t533);
    const REAL t531 = minus_limb4_U_0_cos * limb4_lower_joint_sent_fx,
      t535 = limb4_U_0_sin * limb4_lower_joint_sent_fx,
      minus_limb4_lower_sent_fz = minus_limb4_upper_sent_fz + (minus_limb4_lower_rate_fz + limb_lower_m_gravity_z * minus_limb4_U_0_cos),
      minus_limb4_U_0_joint_sent_fy = limb4_U_0_sin * minus_limb4_lower_sent_fz + t531,
      limb4_U_0_joint_sent_fx = minus_limb4_U_0_cos * minus_limb4_lower_sent_fz - t535;
    WRITE(reactions, 56, limb4_U_0_joint_sent_fx);
    const REAL t536 = param_R * limb4_U_0_joint_sent_fx;
    RESULT(checked2, reactions, 54, -minus_limb4_U_0_joint_sent_fy);
    const REAL t549 = param_R * minus_limb4_U_0_joint_sent_fy, t548 = limb4_lower_cos * minus_limb4_lower_sent_my,
      limb4_lower_joint_sent_mx = limb4_lower_cos * limb4_lower_sent_mx - minus_limb4_lower_sin * minus_limb4_lower_sent_my;
    RESULT(checked3, reactions, 58, -(minus_limb4_lower_sin * limb4_lower_sent_mx + t548));
    RESULT(checked0, reactions, 59, t549 - limb4_U_0_sin * limb4_lower_joint_sent_mx);
    RESULT(checked1, reactions, 57, t536 - minus_limb4_U_0_cos * limb4_lower_joint_sent_mx);
    /* limb3: geometry; reactions, eq. (32) */
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos,
      t516 = minus_limb3_lower_rotation_yx * limb3_S_multiplier_fx,
      minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin;
    /* limb3: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    const REAL minus_limb3_S_reaction_fy = t514 + (minus_limb3_lower_rotation_yy * minus_limb3_S_multiplier_fy - t516);
    RESULT(checked2, reactions, 49, -minus_limb3_S_reaction_fy);
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x,
      t527 = limb3_upper_position_x * minus_limb3_S_reaction_fy,
      minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx;
    RESULT(checked3, reactions, 53, minus_limb3_upper_position_y * limb3_S_reaction_fx - t527);
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos,
      t520 = limb3_lower_rotation_zx * limb3_S_multiplier_fx,
      limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin,
      minus_limb3_S_reaction_fz = t518 - (limb3_lower_rotation_zy * minus_limb3_S_multiplier_fy - t520);
    RESULT(checked0, reactions, 50, -minus_limb3_S_reaction_fz);
    const REAL t524 = limb3_upper_position_x * minus_limb3_S_reaction_fz,
      t523 = minus_limb3_upper_position_y * minus_limb3_S_reaction_fz,
      limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx;
    RESULT(checked1, reactions, 52, t524 + limb3_upper_position_z * limb3_S_reaction_fx);
    RESULT(checked2, reactions, 51, limb3_upper_position_z * minus_limb3_S_reaction_fy + t523);
    const REAL minus_limb3_lower_sent_my = minus_limb3_upper_rate_my_2 - limb3_upper_offset_x * minus_limb3_upper_sent_fz + minus_limb3_lower_rate_my_2,
      minus_limb3_P_reaction_fy = limb3_U_0_cos * minus_limb3_upper_sent_fz + minus_limb3_lower_rotation_yy * limb3_upper_sent_fy,
      t497 = minus_limb3_lower_rotation_yy * minus_limb3_upper_rate_my_2;
    RESULT(checked3, reactions, 43, -minus_limb3_P_reaction_fy);
    const REAL t510 = limb3_upper_position_x * minus_limb3_P_reaction_fy,
      t487 = limb3_upper_position_z * minus_limb3_P_reaction_fy,
      limb3_P_reaction_fx = limb3_lower_cos * limb3_upper_sent_fy;
    WRITE(reactions, 42, limb3_P_reaction_fx);
    const REAL t486 = limb3_lower_rotation_zy * limb3_upper_sent_fy,
      t505 = limb3_lower_rotation_zy * minus_limb3_upper_rate_my_2,
      t494 = limb3_upper_position_z * limb3_P_reaction_fx,
      t511 = minus_limb3_upper_position_y * limb3_P_reaction_fx - t510,
      t491 = limb3_lower_cos * minus_limb3_upper_rate_my_2,
      t468 = k14 * (limb3_lower_alpha_still_x - limb3_U_a_0 * minus_limb3_lower_sin),
      limb3_upper_rate_mx = t468 - k15 * limb3_lower_alpha_still_x,
      t506 = limb3_lower_rotation_zx * limb3_upper_rate_mx - t505,
      t498 = minus_limb3_lower_rotation_yx * limb3_upper_rate_mx - t497,
      minus_limb3_upper_rate_mz_2 = minus_limb3_upper_rate_mz - (k18 * limb3_U_a_1 - t500);
    RESULT(checked0, reactions, 47, t506 - limb3_U_0_sin * minus_limb3_upper_rate_mz_2 + t511);
    const REAL t503 = t498 + limb3_U_0_cos * minus_limb3_upper_rate_mz_2,
      minus_limb3_P_reaction_fz = limb3_U_0_sin * minus_limb3_upper_sent_fz - t486;
    RESULT(checked1, reactions, 46, limb3_upper_position_x * minus_limb3_P_reaction_fz + t494 - t503);
    const REAL t489 = t487 + minus_limb3_upper_position_y * minus_limb3_P_reaction_fz;
    RESULT(checked2, reactions, 44, -minus_limb3_P_reaction_fz);
    RESULT(checked3, reactions, 45, t489 - (minus_limb3_lower_sin * limb3_upper_rate_mx + t491));
    /* limb3: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL limb3_lower_sent_mx = 2.0 * limb3_upper_rate_mx,
      t461 = minus_limb3_lower_sin * minus_limb3_lower_sent_fx,
      limb3_lower_joint_sent_fx = minus_limb3_lower_sin * limb3_lower_sent_fy - limb3_lower_cos * minus_limb3_lower_sent_fx;
    RESULT(checked0, reactions, 36, limb3_lower_cos * limb3_lower_sent_fy + t461);
    const REAL t465 = limb3_U_0_sin * limb3_lower_joint_sent_fx, t467 = limb3_U_0_cos * limb3_lower_joint_sent_fx,
      minus_limb3_lower_sent_fz = minus_limb3_upper_sent_fz + (minus_limb3_lower_rate_fz - limb_lower_m_gravity_z * limb3_U_0_sin),
      minus_limb3_U_0_joint_sent_fx = limb3_U_0_cos * minus_limb3_lower_sent_fz + t465,
      minus_limb3_U_0_joint_sent_fy = limb3_U_0_sin * minus_limb3_lower_sent_fz - t467;
    RESULT(checked1, reactions, 38, -minus_limb3_U_0_joint_sent_fy);
    const REAL t477 = param_R * minus_limb3_U_0_joint_sent_fy;
    RESULT(checked2, reactions, 37, -minus_limb3_U_0_joint_sent_fx);
    const REAL t482 = param_R * minus_limb3_U_0_joint_sent_fx, t476 = limb3_lower_cos * minus_limb3_lower_sent_my,
      limb3_lower_joint_sent_mx = limb3_lower_cos * limb3_lower_sent_mx - minus_limb3_lower_sin * minus_limb3_lower_sent_my;
    RESULT(checked3, reactions, 39, -(minus_limb3_lower_sin * limb3_lower_sent_mx + t476));
    RESULT(checked0, reactions, 41, limb3_U_0_cos * limb3_lower_joint_sent_mx - t482);
    RESULT(checked1, reactions, 40, t477 - limb3_U_0_sin * limb3_lower_joint_sent_mx);
    /* limb2: geometry; reactions, eq. (32) */
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos,
      t446 = minus_limb2_lower_rotation_xx * limb2_S_multiplier_fx,
      limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin;
    /* limb2: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    const REAL limb2_S_reaction_fx = t444 + (limb2_lower_rotation_xy * minus_limb2_S_multiplier_fy + t446);
    WRITE(reactions, 30, limb2_S_reaction_fx);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      t458 = minus_limb2_upper_position_y * limb2_S_reaction_fx,
      minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx;
    RESULT(checked2, reactions, 35, t458 + minus_limb2_upper_position_x * minus_limb2_S_reaction_fy);
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos,
      t452 = minus_limb2_lower_rotation_zx * limb2_S_multiplier_fx,
      limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin,
      minus_limb2_S_reaction_fz = t450 - (limb2_lower_rotation_zy * minus_limb2_S_multiplier_fy + t452);
    RESULT(checked3, reactions, 32, -minus_limb2_S_reaction_fz);
    const REAL t456 = minus_limb2_upper_position_x * minus_limb2_S_reaction_fz,
      t454 = minus_limb2_upper_position_y * minus_limb2_S_reaction_fz,
      minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx;
    RESULT(checked0, reactions, 34, -(t456 + minus_limb2_upper_position_z * limb2_S_reaction_fx));
    RESULT(checked1, reactions, 33, t454 - minus_limb2_upper_position_z * minus_limb2_S_reaction_fy);
    const REAL minus_limb2_lower_sent_my = minus_limb2_upper_rate_my_2 - limb2_upper_offset_x * minus_limb2_upper_sent_fz - limb2_lower_rate_my_2,
      minus_limb2_P_reaction_fx = limb2_U_0_sin * minus_limb2_upper_sent_fz - limb2_lower_rotation_xy * limb2_upper_sent_fy,
      t423 = limb2_lower_rotation_xy * minus_limb2_upper_rate_my_2;
    RESULT(checked2, reactions, 24, -minus_limb2_P_reaction_fx);
    const REAL t441 = minus_limb2_upper_position_y * minus_limb2_P_reaction_fx,
      t434 = minus_limb2_upper_position_z * minus_limb2_P_reaction_fx,
      limb2_P_reaction_fy = limb2_lower_cos * limb2_upper_sent_fy;
    WRITE(reactions, 25, limb2_P_reaction_fy);
    const REAL t418 = limb2_lower_rotation_zy * limb2_upper_sent_fy,
      t437 = limb2_lower_rotation_zy * minus_limb2_upper_rate_my_2,
      t431 = limb2_lower_cos * minus_limb2_upper_rate_my_2, t419 = minus_limb2_upper_position_z * limb2_P_reaction_fy,
      t443 = t441 + minus_limb2_upper_position_x * limb2_P_reaction_fy,
      t400 = k14 * (limb2_lower_alpha_still_x + limb2_U_a_0 * limb2_lower_sin),
      limb2_upper_rate_mx = t400 - k15 * limb2_lower_alpha_still_x,
      t438 = minus_limb2_lower_rotation_zx * limb2_upper_rate_mx + t437,
      t424 = minus_limb2_lower_rotation_xx * limb2_upper_rate_mx + t423,
      minus_limb2_upper_rate_mz_2 = minus_limb2_upper_rate_mz - (k18 * limb2_U_a_1 + t426);
    RESULT(checked3, reactions, 29, -(t438 - minus_limb2_U_0_cos * minus_limb2_upper_rate_mz_2 + t443));
    const REAL t429 = t424 + limb2_U_0_sin * minus_limb2_upper_rate_mz_2,
      limb2_P_reaction_fz = minus_limb2_U_0_cos * minus_limb2_upper_sent_fz + t418;
    WRITE(reactions, 26, limb2_P_reaction_fz);
    const REAL t435 = minus_limb2_upper_position_x * limb2_P_reaction_fz + t434;
    RESULT(checked0, reactions, 27, t419 - minus_limb2_upper_position_y * limb2_P_reaction_fz - t429);
    RESULT(checked1, reactions, 28, limb2_lower_sin * limb2_upper_rate_mx - t431 + t435);
    /* limb2: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL limb2_lower_sent_mx = 2.0 * limb2_upper_rate_mx, t397 = limb2_lower_sin * minus_limb2_lower_sent_fx,
      minus_limb2_lower_joint_sent_fx = limb2_lower_sin * limb2_lower_sent_fy + limb2_lower_cos * minus_limb2_lower_sent_fx;
    RESULT(checked2, reactions, 19, limb2_lower_cos * limb2_lower_sent_fy - t397);
    const REAL t395 = minus_limb2_U_0_cos * minus_limb2_lower_joint_sent_fx,
      t399 = limb2_U_0_sin * minus_limb2_lower_joint_sent_fx,
      minus_limb2_lower_sent_fz = minus_limb2_upper_sent_fz - (limb2_lower_rate_fz - limb_lower_m_gravity_z * minus_limb2_U_0_cos),
      minus_limb2_U_0_joint_sent_fy = limb2_U_0_sin * minus_limb2_lower_sent_fz - t395,
      limb2_U_0_joint_sent_fx = minus_limb2_U_0_cos * minus_limb2_lower_sent_fz + t399;
    WRITE(reactions, 20, limb2_U_0_joint_sent_fx);
    const REAL t410 = param_R * limb2_U_0_joint_sent_fx;
    RESULT(checked3, reactions, 18, -minus_limb2_U_0_joint_sent_fy);
    const REAL t414 = param_R * minus_limb2_U_0_joint_sent_fy, t412 = limb2_lower_cos * minus_limb2_lower_sent_my,
      limb2_lower_joint_sent_mx = limb2_lower_cos * limb2_lower_sent_mx + limb2_lower_sin * minus_limb2_lower_sent_my;
    RESULT(checked0, reactions, 22, limb2_lower_sin * limb2_lower_sent_mx - t412);
    RESULT(checked1, reactions, 23, -(limb2_U_0_sin * limb2_lower_joint_sent_mx + t414));
    RESULT(checked2, reactions, 21, -(minus_limb2_U_0_cos * limb2_lower_joint_sent_mx + t410));
    /* limb1: geometry */
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    /* limb1: reactions, eq. (32); geometry; balance, eqs. (40)-(47) */
    const REAL t369 = limb1_lower_rotation_yy * limb1_U2_multiplier_fy,
      minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos,
      limb1_U2_reaction_fy = t368 - (t369 - minus_limb1_lower_rotation_yx * limb1_U2_multiplier_fx);
    WRITE(reactions, 13, limb1_U2_reaction_fy);
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t390 = minus_limb1_upper_position_x * limb1_U2_reaction_fy,
      minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx,
      t391 = minus_limb1_upper_position_y * minus_limb1_U2_reaction_fx + t390,
      t386 = limb1_U_0_sin * limb1_U2_joint_reaction_mz, limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos,
      t374 = limb1_lower_rotation_zx * limb1_U2_multiplier_fx;
    RESULT(checked3, reactions, 17, t386 + limb1_lower_rotation_zx * limb1_U2_joint_reaction_mx - t391);
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin,
      limb1_U2_reaction_fz = t372 + (minus_limb1_lower_rotation_zy * limb1_U2_multiplier_fy - t374);
    WRITE(reactions, 14, limb1_U2_reaction_fz);
    const REAL t380 = minus_limb1_upper_position_x * limb1_U2_reaction_fz,
      t378 = minus_limb1_upper_position_y * limb1_U2_reaction_fz,
      limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx,
      t382 = t380 - limb1_upper_position_z * minus_limb1_U2_reaction_fx,
      t379 = limb1_upper_position_z * limb1_U2_reaction_fy + t378,
      minus_limb1_lower_sent_my = minus_limb1_lower_rate_my_2 + (minus_limb1_upper_rate_my_2 - limb1_upper_offset_x * minus_limb1_upper_sent_fz),
      t383 = limb1_U_0_cos * limb1_U2_joint_reaction_mz;
    RESULT(checked0, reactions, 16, t382 + (t383 - minus_limb1_lower_rotation_yx * limb1_U2_joint_reaction_mx));
    RESULT(checked1, reactions, 15, limb1_lower_sin * limb1_U2_joint_reaction_mx - t379);
    const REAL minus_limb1_P_reaction_fy = limb1_U_0_cos * minus_limb1_upper_sent_fz - limb1_lower_rotation_yy * limb1_upper_sent_fy,
      t354 = limb1_lower_rotation_yy * minus_limb1_upper_rate_my_2;
    RESULT(checked2, reactions, 7, -minus_limb1_P_reaction_fy);
    const REAL t359 = minus_limb1_upper_position_x * minus_limb1_P_reaction_fy,
      t341 = limb1_upper_position_z * minus_limb1_P_reaction_fy,
      limb1_P_reaction_fx = limb1_lower_cos * limb1_upper_sent_fy;
    WRITE(reactions, 6, limb1_P_reaction_fx);
    const REAL t340 = minus_limb1_lower_rotation_zy * limb1_upper_sent_fy,
      t362 = minus_limb1_lower_rotation_zy * minus_limb1_upper_rate_my_2,
      t348 = limb1_upper_position_z * limb1_P_reaction_fx,
      t360 = minus_limb1_upper_position_y * limb1_P_reaction_fx + t359,
      t344 = limb1_lower_cos * minus_limb1_upper_rate_my_2,
      t315 = k14 * (limb1_lower_alpha_still_x + limb1_U_a_0 * limb1_lower_sin),
      limb1_upper_rate_mx = t315 - k15 * limb1_lower_alpha_still_x,
      limb1_upper_sent_mx = limb1_upper_rate_mx + limb1_U2_joint_reaction_mx,
      t364 = t362 + limb1_lower_rotation_zx * limb1_upper_sent_mx,
      t356 = t354 + minus_limb1_lower_rotation_yx * limb1_upper_sent_mx,
      limb1_lower_sent_mx = limb1_upper_rate_mx + limb1_upper_sent_mx,
      t346 = t344 - limb1_lower_sin * limb1_upper_sent_mx,
      minus_limb1_upper_sent_mz = minus_limb1_upper_rate_mz - (k18 * limb1_U_a_1 + t351) - limb1_U2_joint_reaction_mz;
    RESULT(checked3, reactions, 11, t360 - (limb1_U_0_sin * minus_limb1_upper_sent_mz - t364));
    const REAL t357 = limb1_U_0_cos * minus_limb1_upper_sent_mz + t356,
      minus_limb1_P_reaction_fz = limb1_U_0_sin * minus_limb1_upper_sent_fz + t340;
    RESULT(checked0, reactions, 10, -(minus_limb1_upper_position_x * minus_limb1_P_reaction_fz - t348 + t357));
    RESULT(checked1, reactions, 9, t341 + minus_limb1_upper_position_y * minus_limb1_P_reaction_fz - t346);
    RESULT(checked2, reactions, 8, -minus_limb1_P_reaction_fz);
    /* limb1: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t330 = limb1_lower_cos * minus_limb1_lower_sent_my,
      limb1_lower_joint_sent_mx = limb1_lower_sin * minus_limb1_lower_sent_my + limb1_lower_cos * limb1_lower_sent_mx;
    RESULT(checked3, reactions, 3, limb1_lower_sin * limb1_lower_sent_mx - t330);
    const REAL t335 = limb1_U_0_cos * limb1_lower_joint_sent_mx, t334 = limb1_U_0_sin * limb1_lower_joint_sent_mx,
      t299 = limb1_lower_cos * limb1_lower_sent_fy,
      minus_limb1_lower_joint_sent_fx = limb1_lower_sin * limb1_lower_sent_fy + limb1_lower_cos * minus_limb1_lower_sent_fx;
    RESULT(checked0, reactions, 0, t299 - limb1_lower_sin * minus_limb1_lower_sent_fx);
    const REAL t303 = limb1_U_0_sin * minus_limb1_lower_joint_sent_fx,
      t313 = limb1_U_0_cos * minus_limb1_lower_joint_sent_fx,
      limb1_lower_sent_fz = limb1_lower_rate_fz + limb_lower_m_gravity_z * limb1_U_0_sin - minus_limb1_upper_sent_fz,
      limb1_U_0_joint_sent_fx = t303 + limb1_U_0_cos * limb1_lower_sent_fz;
    WRITE(reactions, 1, limb1_U_0_joint_sent_fx);
    RESULT(checked1, reactions, 5, t335 - param_R * limb1_U_0_joint_sent_fx);
    const REAL minus_limb1_U_0_joint_sent_fy = t313 - limb1_U_0_sin * limb1_lower_sent_fz;
    RESULT(checked2, reactions, 2, -minus_limb1_U_0_joint_sent_fy);
    RESULT(checked3, reactions, 4, -(param_R * minus_limb1_U_0_joint_sent_fy + t334));
    WRITE(reactions, 75, CONSTANT(0.0));
    WRITE(reactions, 76, CONSTANT(0.0));
    WRITE(reactions, 77, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.3211e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.4044e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.284e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.233100000000001e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10), /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

#if !defined(THREE_UPS_UPU_S_VECTORS)

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_joint_reactions_packed_lane(const double *restrict q,
    const double *restrict v, const double *restrict a, double *restrict u, double *restrict reactions,
    const double *restrict sine, const double *restrict cosine)
{
    typedef three_ups_upu_s_vector4 lanes4;
    reactions[75] = 0.0;
    reactions[76] = 0.0;
    reactions[77] = 0.0;
    const double limb5_S_q_qw = q[12], limb5_S_q_qx = q[13], limb5_S_q_qy = q[14], limb5_S_q_qz = q[15],
      limb5_S_v_wx = v[12], limb5_S_v_wy = v[13], limb5_S_v_wz = v[14], limb5_S_a_wx = a[12], limb5_S_a_wy =
        a[13],
      limb1_U_0_sin = sine[0], limb1_U_0_cos = cosine[0], limb1_lower_sin = sine[1], limb1_lower_cos =
        cosine[1];
    const lanes4 limb_U_v_0 = {v[0], v[3], v[6], v[9]},
      signed_limb_lower_sin = {limb1_lower_sin, sine[3], sine[5], sine[7]};
    /* limbs together: velocities, eq. (6) */
    const lanes4 signed_limb_lower_omega_x = limb_U_v_0 * signed_limb_lower_sin,
      limb_U_v_1 = {v[1], v[4], v[7], v[10]};
    /* limbs together: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const lanes4 signed_limb_lower_alpha_still_y = limb_U_v_1 * signed_limb_lower_omega_x,
      limb_U_a_0 = {a[0], a[3], a[6], a[9]}, limb_lower_cos = {limb1_lower_cos, cosine[3], cosine[5],
        cosine[7]},
      lanes_2 = (lanes4){1.0, 1.0, -1.0, -1.0} * limb_lower_cos,
      signed_limb_lower_alpha_y = signed_limb_lower_alpha_still_y - limb_U_a_0 * lanes_2,
      signed_limb_lower_U_zx = signed_limb_lower_alpha_still_y + signed_limb_lower_alpha_y,
      limb_upper_offset_x = (lanes4){q[2], q[5], q[8], q[11]} + limb_upper_phase,
      lanes_3 = limb_upper_offset_x * signed_limb_lower_U_zx,
      signed_limb_lower_rate_fz = limb_lower_mx * signed_limb_lower_U_zx,
      lanes_4 = {gravity_z, -gravity_z, -gravity_z, gravity_z},
      each_limb1_U_0_sin = {limb1_U_0_sin, sine[2], sine[4], sine[6]},
      lanes_5 = lanes_3 + lanes_4 * each_limb1_U_0_sin, signed_limb_lower_omega_y = limb_U_v_0 * lanes_2,
      limb_lower_U_still_xy = signed_limb_lower_omega_x * signed_limb_lower_omega_y,
      lanes_6 = 2.0 * signed_limb_lower_omega_y, limb_P_v = {v[2], v[5], v[8], v[11]},
      signed_limb_upper_acc_z = limb_P_v * lanes_6 - lanes_5,
      signed_limb_upper_rate_fz = limb_lower_m * signed_limb_upper_acc_z + signed_limb_lower_rate_fz,
      signed_limb_upper_rate_my = limb_lower_mx * signed_limb_upper_acc_z,
      lanes_9 = signed_limb_upper_rate_my - limb_upper_offset_x * signed_limb_upper_rate_fz,
      lanes_13 = k9 * signed_limb_lower_alpha_still_y + k8 * signed_limb_lower_alpha_y,
      lanes_15 = k16 * signed_limb_lower_alpha_y + k17 * signed_limb_lower_alpha_still_y,
      signed_limb_upper_rate_my_2 = signed_limb_upper_rate_my + lanes_15,
      lanes_16 = {gravity_z_limb_lower_mx, -gravity_z_limb_lower_mx, -gravity_z_limb_lower_mx,
        gravity_z_limb_lower_mx},
      signed_limb_upper_moment_y = lanes_16 * each_limb1_U_0_sin,
      signed_limb_lower_rate_my_2 = signed_limb_upper_moment_y + lanes_15,
      lanes_17 = lanes_2 * (lanes_9 + (signed_limb_upper_moment_y + lanes_13)),
      signed_limb_lower_alpha_still_x = limb_U_v_1 * signed_limb_lower_omega_y,
      lanes_18 = signed_limb_lower_omega_y * signed_limb_lower_omega_y;
    /* limbs together: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const lanes4 limb_U_0_moment_z = k3 * limb_U_a_0 - (lanes_17 - signed_limb_lower_sin * (k10 *
        signed_limb_lower_alpha_still_x)),
      each_limb1_U_0_lever_mz_by_limb1_U2_fz = lanes_2 * limb_upper_offset_x,
      lanes_20 = 1.0 / each_limb1_U_0_lever_mz_by_limb1_U2_fz, each_limb1_U2_part_fz = lanes_20 *
        limb_U_0_moment_z,
      each_limb1_U2_arm_y = (lanes4){param_R, param_R, -param_R, -param_R} * limb_lower_cos,
      lanes_22 = each_limb1_U2_arm_y * each_limb1_U2_part_fz, lanes_23 = lanes_2 * lanes_22,
      lanes_24 = signed_limb_lower_sin * lanes_22,
      each_limb1_U2_arm_x = limb_upper_offset_x - param_R * signed_limb_lower_sin,
      lanes_26 = each_limb1_U2_arm_x * each_limb1_U2_part_fz, lanes_28 = lanes_23 - signed_limb_lower_sin *
        lanes_26,
      lanes_30 = lanes_24 + lanes_2 * lanes_26, each_limb1_U_0_cos = {limb1_U_0_cos, cosine[2], cosine[4],
        cosine[6]},
      lanes_31 = each_limb1_U_0_cos * lanes_28, lanes_32 = each_limb1_U_0_sin * lanes_28,
      limb_U_a_1 = {a[1], a[4], a[7], a[10]}, limb_lower_U_yx = limb_U_a_1 + limb_lower_U_still_xy,
      lanes_33 = limb_upper_offset_x * limb_lower_U_yx, limb_lower_rate_fy = limb_lower_mx * limb_lower_U_yx,
      signed_limb_U_0_acc_y = (lanes4){-gravity_z, gravity_z, gravity_z, -gravity_z} * each_limb1_U_0_cos,
      limb_lower_acc_y = signed_limb_lower_sin * signed_limb_U_0_acc_y, lanes_35 = lanes_33 +
        limb_lower_acc_y,
      minus_limb_lower_acc_x = lanes_2 * signed_limb_U_0_acc_y,
      limb_upper_acc_y = limb_P_v * (2.0 * limb_U_v_1) + lanes_35,
      minus_limb_upper_rate_fy = limb_lower_rate_fy - limb_lower_m * limb_upper_acc_y,
      minus_limb_upper_rate_mz = limb_lower_mx * limb_upper_acc_y,
      lanes_39 = minus_limb_upper_rate_mz + limb_upper_offset_x * minus_limb_upper_rate_fy,
      lanes_41 = k19 * limb_lower_U_still_xy,
      minus_limb_lower_moment_z = lanes_39 - (limb_lower_mx * limb_lower_acc_y + (k8 * limb_lower_U_still_xy +
        k9 * limb_U_a_1)),
      limb_lower_rate_fy_2 = limb_lower_rate_fy + limb_lower_m * limb_lower_acc_y, lanes_44 = lanes_2 *
        lanes_20,
      each_limb1_U2_part_fy = minus_limb_lower_moment_z * lanes_44,
      lanes_45 = each_limb1_U2_arm_x * each_limb1_U2_part_fy,
      minus_limb_lower_U_still_xx = lanes_18 + limb_U_v_1 * limb_U_v_1,
      minus_limb_upper_acc_still_x_2 = limb_upper_offset_x * minus_limb_lower_U_still_xx +
        minus_limb_lower_acc_x,
      limb_lower_force_x = limb_lower_m * ((lanes4){a[2], a[5], a[8], a[11]} -
        minus_limb_upper_acc_still_x_2),
      minus_limb_lower_rate_fx = limb_lower_mx * minus_limb_lower_U_still_xx,
      limb_upper_rate_fx = minus_limb_lower_rate_fx + limb_lower_force_x,
      limb_lower_rate_fx_2 = (-limb_lower_m) * minus_limb_lower_acc_x - minus_limb_lower_rate_fx,
      lanes_48 = each_limb1_U2_arm_y * limb_upper_rate_fx - lanes_45,
      lanes_50 = lanes_31 + each_limb1_U_0_sin * lanes_48, lanes_52 = lanes_32 - each_limb1_U_0_cos *
        lanes_48;
    /* platform: geometry; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const double t2 = limb5_S_q_qw * limb5_S_q_qw, t3 = limb5_S_q_qx * limb5_S_q_qx, t4 = t2 + t3,
      t5 = limb5_S_q_qy * limb5_S_q_qy, t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7,
      t10 = 4.0 - 2.0 * t8, t11 = t3 + t6, platform_turn_zz = 1.0 - t10 * (t3 + t5),
      platform_turn_yy = 1.0 - t10 * t11, platform_turn_xx = 1.0 - t7 * t10, t14 = limb5_S_q_qz * t10,
      t15 = limb5_S_q_qy * t14, t17 = limb5_S_q_qw * (limb5_S_q_qx * t10), t32 = limb5_S_q_qy * t10,
      platform_turn_zy = t15 + t17, platform_turn_yz = t15 - t17,
      minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      platform_U_still_yz = limb5_S_v_wy * limb5_S_v_wz,
      minus_platform_rate_fy = platform_mz * (limb5_S_a_wx - platform_U_still_yz),
      minus_platform_rate_mx = minus_platform_moment_x - (k12 * platform_U_still_yz + k13 * limb5_S_a_wx),
      t166 = limb5_S_q_qx * t14, t34 = limb5_S_q_qw * t14, t167 = limb5_S_q_qw * t32, t33 = limb5_S_q_qx *
        t32,
      platform_turn_zx = t166 - t167, platform_turn_xz = t166 + t167,
      t171 = platform_turn_zx * minus_platform_rate_mx, platform_moment_y = gravity_z_platform_mz *
        platform_turn_zx,
      platform_U_still_xz = limb5_S_v_wx * limb5_S_v_wz,
      platform_rate_fx = platform_mz * (limb5_S_a_wy + platform_U_still_xz),
      platform_rate_my = platform_moment_y - (k12 * platform_U_still_xz - k13 * limb5_S_a_wy),
      t176 = t171 - platform_turn_zy * platform_rate_my, platform_rate_mz = platform_Izz * a[14],
      t215 = lanes_50[1] + (t176 - platform_turn_zz * platform_rate_mz - lanes_50[0]),
      minus_platform_joint_force_mz = lanes_50[3] - (lanes_50[2] - t215);
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; balance, eqs. (40)-(47) */
    const double limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin *
        platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * lanes_20[0],
      t21 = limb1_U2_constraint_mn_couple_x - each_limb1_U2_arm_y[0] * minus_limb1_U_factor_0_by_3,
      t22 = limb1_lower_cos * t21, t45 = limb1_lower_sin * t21, limb1_U2_arm_x = each_limb1_U2_arm_x[0],
      t24 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3, t26 = t22 + limb1_lower_sin * t24,
      platform_joint_force_mx_by_limb1_U2_mn = t45 - limb1_lower_cos * t24, t40 = limb1_U_0_cos * t26,
      t27 = limb1_U_0_sin * t26,
      t31 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy);
    /* platform: geometry */
    const double platform_turn_xy = t33 - t34, platform_turn_yx = t33 + t34,
      limb1_U2_constraint_mn_couple_z = t31 - limb1_lower_sin * platform_turn_xy,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * lanes_44[0],
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    /* platform: balance, eqs. (40)-(47); drives; pivots */
    const double platform_joint_force_mz_by_limb1_U2_mn = t40 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3,
      t42 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn, limb1_U2_part_mn = t42 *
        minus_platform_joint_force_mz,
      t39 = t27 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      t217 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn,
      t227 = platform_turn_xx * minus_platform_rate_mx - platform_turn_xy * platform_rate_my,
      t258 = platform_turn_yx * minus_platform_rate_mx - platform_turn_yy * platform_rate_my,
      t237 = t227 - platform_turn_xz * platform_rate_mz - lanes_30[0] + lanes_52[1],
      limb5_S_balance_wx = t217 - (lanes_52[3] + (-lanes_30[2] + t237)),
      t265 = lanes_30[1] - (t258 - platform_turn_yz * platform_rate_mz + lanes_52[0]),
      minus_platform_joint_force_my = -lanes_30[3] + (lanes_52[2] - t265);
    const lanes4 each_limb1_U2_part_mn_by_limb1_P = each_limb1_U_0_sin * each_limb1_U2_arm_y * t42,
      each_platform_joint_force_my_by_limb1_P = each_limb1_U_0_cos * each_limb1_U2_arm_y,
      lanes_53 = {t39, platform_joint_force_mx_by_limb1_U2_mn, t39, platform_joint_force_mx_by_limb1_U2_mn},
      each_limb5_S_balance_wy_by_limb1_P = each_platform_joint_force_my_by_limb1_P + lanes_53 *
        each_limb1_U2_part_mn_by_limb1_P,
      lanes_55 = {platform_joint_force_mx_by_limb1_U2_mn, t39, platform_joint_force_mx_by_limb1_U2_mn, t39},
      each_limb5_S_balance_wx_by_limb1_P = lanes_55 * each_limb1_U2_part_mn_by_limb1_P;
    const double minus_limb5_S_balance_wy = t39 * limb1_U2_part_mn + minus_platform_joint_force_my;
    const lanes4 lanes_56 = each_limb5_S_balance_wy_by_limb1_P * each_limb5_S_balance_wx_by_limb1_P;
    const double t57 = lanes_56[2] + (lanes_56[1] + lanes_56[0]), minus_drives_share_0_1 = lanes_56[3] + t57,
      t239 = minus_drives_share_0_1 * limb5_S_balance_wx; /* limb1 */
    const lanes4 lanes_57 = each_limb5_S_balance_wy_by_limb1_P * each_limb5_S_balance_wy_by_limb1_P,
      lanes_58 = each_limb5_S_balance_wx_by_limb1_P * each_limb5_S_balance_wx_by_limb1_P;
    const double t245 = lanes_58[2] + (lanes_57[1] + lanes_58[0]), drives_share_0_0 = lanes_57[3] + t245,
      t268 = t239 - drives_share_0_0 * minus_limb5_S_balance_wy, /* limb1 */
      t280 = minus_drives_share_0_1 * minus_limb5_S_balance_wy, /* limb1 */
      t269 = minus_drives_share_0_1 * minus_drives_share_0_1, t275 = lanes_57[2] + (lanes_58[1] +
        lanes_57[0]),
      drives_share_1_1 = lanes_58[3] + t275, minus_determinant = t269 - drives_share_1_1 * drives_share_0_0,
      t282 = t280 - drives_share_1_1 * limb5_S_balance_wx, /* limb1 */
      t277 = 1.0 / minus_determinant, t278 = t268 * t277, /* limb1 */
      t283 = t277 * t282; /* limb1 */
    const lanes4 lanes_60 = each_limb5_S_balance_wy_by_limb1_P * (lanes4){t278, t283, t278, t283},
      signed_limb_P_drive = lanes_60 + each_limb5_S_balance_wx_by_limb1_P * (lanes4){t283, t278, t283, t278};
    const double minus_limb1_P_drive = signed_limb_P_drive[0];
    u[0] = -minus_limb1_P_drive;
    u[1] = signed_limb_P_drive[1];
    u[2] = -signed_limb_P_drive[2];
    const double minus_limb4_P_drive = -signed_limb_P_drive[3];
    u[3] = -minus_limb4_P_drive;
    const lanes4 lanes_64 = (lanes4){1.0, -1.0, 1.0, -1.0} * signed_limb_P_drive;
    /* limbs together: balance, eqs. (40)-(47); reactions, eq. (32) */
    const lanes4 each_limb1_U2_multiplier_fx = limb_upper_rate_fx + lanes_64,
      limb_lower_sent_fx = limb_lower_rate_fx_2 - lanes_64,
      lanes_65 = signed_limb_P_drive * (limb1_U_factor_1_by_3 * each_limb1_U2_part_mn_by_limb1_P);
    const double t296 = lanes_65[0] - (each_limb1_U2_part_fy[0] + limb1_U_factor_1_by_3 * limb1_U2_part_mn), /* limb1 */
      limb1_U2_multiplier_fy = lanes_65[3] + (lanes_65[2] + (lanes_65[1] + t296));
    const lanes4 each_limb1_U2_multiplier_fy = {limb1_U2_multiplier_fy, each_limb1_U2_part_fy[1],
        each_limb1_U2_part_fy[2], each_limb1_U2_part_fy[3]},
      lanes_67 = (lanes4){1.0, -1.0, -1.0, -1.0} * each_limb1_U2_multiplier_fy,
      minus_limb_upper_sent_fy = minus_limb_upper_rate_fy + lanes_67,
      limb_lower_sent_fy = limb_lower_rate_fy_2 - minus_limb_upper_sent_fy,
      lanes_70 = signed_limb_lower_sin * lanes_67 - lanes_2 * each_limb1_U2_multiplier_fx,
      lanes_71 = each_limb1_U_0_cos * lanes_70, lanes_72 = each_limb1_U_0_sin * lanes_70,
      lanes_73 = signed_limb_P_drive * (minus_limb1_U_factor_0_by_3 * each_limb1_U2_part_mn_by_limb1_P),
      lanes_74 = each_limb1_U2_part_mn_by_limb1_P * signed_limb_P_drive;
    const double t309 = lanes_73[0] + (each_limb1_U2_part_fz[0] - minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn), /* limb1 */
      minus_limb1_U2_multiplier_fz = lanes_73[3] + (lanes_73[2] + (lanes_73[1] + t309)),
      t323 = lanes_74[2] + (lanes_74[1] - (limb1_U2_part_mn - lanes_74[0])), /* limb1 */
      minus_limb1_U2_multiplier_mn = lanes_74[3] + t323,
      limb1_U2_joint_reaction_mz = limb1_U2_constraint_mn_couple_z * minus_limb1_U2_multiplier_mn,
      limb1_U2_joint_reaction_mx = limb1_U2_constraint_mn_couple_x * minus_limb1_U2_multiplier_mn;
    const lanes4 each_limb1_U2_multiplier_fz = {minus_limb1_U2_multiplier_fz, each_limb1_U2_part_fz[1],
        each_limb1_U2_part_fz[2], each_limb1_U2_part_fz[3]},
      signed_limb_upper_sent_fz = signed_limb_upper_rate_fz - each_limb1_U2_multiplier_fz,
      lanes_75 = each_limb1_U_0_sin * each_limb1_U2_multiplier_fz,
      lanes_76 = each_limb1_U_0_cos * each_limb1_U2_multiplier_fz, lanes_77 = lanes_71 + lanes_75,
      lanes_78 = lanes_72 - lanes_76;
    /* platform: momentum rate, eq. (35) */
    const double platform_rate_fx_2 = platform_rate_fx + platform_m_gravity_z * platform_turn_zx;
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const double t641 = platform_turn_zx * platform_rate_fx_2, t624 = platform_turn_yx * platform_rate_fx_2,
      t607 = platform_turn_xx * platform_rate_fx_2,
      minus_platform_rate_fy_2 = minus_platform_rate_fy - platform_m_gravity_z * platform_turn_zy,
      t643 = t641 - platform_turn_zy * minus_platform_rate_fy_2,
      t626 = t624 - platform_turn_yy * minus_platform_rate_fy_2,
      t610 = t607 - platform_turn_xy * minus_platform_rate_fy_2, t613 = platform_m_gravity_z *
        platform_turn_zz,
      minus_platform_rate_fz_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) -
        t613,
      t649 = lanes_77[1] + (t643 - platform_turn_zz * minus_platform_rate_fz_2 - lanes_77[0]),
      platform_joint_sent_fz = lanes_77[2] + t649 - lanes_77[3];
    reactions[74] = platform_joint_sent_fz;
    const double t615 = t610 - platform_turn_xz * minus_platform_rate_fz_2,
      t634 = t626 - platform_turn_yz * minus_platform_rate_fz_2 + lanes_78[0];
    const lanes4 each_limb1_U2_reaction_fx = lanes_2 * lanes_67 + signed_limb_lower_sin *
        each_limb1_U2_multiplier_fx;
    const double minus_limb1_U2_reaction_fx = each_limb1_U2_reaction_fx[0];
    reactions[12] = -minus_limb1_U2_reaction_fx;
    const double minus_limb2_S_reaction_fy = each_limb1_U2_reaction_fx[1];
    reactions[31] = -minus_limb2_S_reaction_fy;
    const double limb3_S_reaction_fx = each_limb1_U2_reaction_fx[2];
    reactions[48] = limb3_S_reaction_fx;
    const double limb4_S_reaction_fy = each_limb1_U2_reaction_fx[3];
    reactions[67] = limb4_S_reaction_fy;
    const double platform_joint_sent_fy = -lanes_78[2] + (minus_limb2_S_reaction_fy + t634) -
        limb4_S_reaction_fy;
    reactions[73] = platform_joint_sent_fy;
    const double platform_joint_sent_fx = -lanes_78[3] - (limb3_S_reaction_fx + (-lanes_78[1] - (t615 +
        minus_limb1_U2_reaction_fx)));
    reactions[72] = platform_joint_sent_fx;
    const lanes4 each_limb1_lower_rotation_yy = each_limb1_U_0_sin * signed_limb_lower_sin,
      lanes_81 = each_limb1_lower_rotation_yy * lanes_67, each_limb1_lower_rotation_yx = each_limb1_U_0_sin *
        lanes_2,
      each_limb1_U2_reaction_fy = lanes_76 - (lanes_81 - each_limb1_lower_rotation_yx *
        each_limb1_U2_multiplier_fx);
    reactions[13] = each_limb1_U2_reaction_fy[0];
    reactions[30] = each_limb1_U2_reaction_fy[1];
    const double minus_limb3_S_reaction_fy = each_limb1_U2_reaction_fy[2];
    reactions[49] = -minus_limb3_S_reaction_fy;
    const double minus_limb4_S_reaction_fx = each_limb1_U2_reaction_fy[3];
    reactions[66] = -minus_limb4_S_reaction_fx;
    const lanes4 each_limb1_upper_position_x = signed_limb_lower_sin * limb_upper_offset_x + (-param_R),
      lanes_84 = each_limb1_upper_position_x * each_limb1_U2_reaction_fy,
      each_limb1_upper_position_y = limb_upper_offset_x * each_limb1_lower_rotation_yx,
      each_limb2_S_reaction_mz = each_limb1_upper_position_y * each_limb1_U2_reaction_fx - lanes_84;
    const double limb2_S_reaction_mz = each_limb2_S_reaction_mz[1];
    reactions[35] = limb2_S_reaction_mz;
    const double limb3_S_reaction_mz = -each_limb2_S_reaction_mz[2];
    reactions[53] = limb3_S_reaction_mz;
    const double limb4_S_reaction_mz = each_limb2_S_reaction_mz[3];
    reactions[71] = limb4_S_reaction_mz;
    const double t386 = limb1_U_0_sin * limb1_U2_joint_reaction_mz; /* limb1 */
    const lanes4 signed_limb_lower_rotation_zx = each_limb1_U_0_cos * lanes_2,
      lanes_86 = signed_limb_lower_rotation_zx * each_limb1_U2_multiplier_fx;
    const double t388 = t386 + signed_limb_lower_rotation_zx[0] * limb1_U2_joint_reaction_mx, /* limb1 */
      limb1_U2_reaction_mz = t388 - each_limb2_S_reaction_mz[0];
    reactions[17] = limb1_U2_reaction_mz;
    const lanes4 signed_limb_lower_rotation_zy = each_limb1_U_0_cos * signed_limb_lower_sin,
      each_limb1_U2_reaction_fz = lanes_86 - signed_limb_lower_rotation_zy * lanes_67 - lanes_75;
    reactions[14] = -each_limb1_U2_reaction_fz[0];
    const double minus_limb2_S_reaction_fz = -each_limb1_U2_reaction_fz[1];
    reactions[32] = -minus_limb2_S_reaction_fz;
    const double minus_limb3_S_reaction_fz = -each_limb1_U2_reaction_fz[2];
    reactions[50] = -minus_limb3_S_reaction_fz;
    reactions[68] = -each_limb1_U2_reaction_fz[3];
    const lanes4 lanes_89 = each_limb1_upper_position_x * each_limb1_U2_reaction_fz,
      lanes_90 = each_limb1_upper_position_y * each_limb1_U2_reaction_fz,
      signed_limb_upper_position_z = limb_upper_offset_x * signed_limb_lower_rotation_zx,
      each_limb2_S_reaction_mx = lanes_89 - signed_limb_upper_position_z * each_limb1_U2_reaction_fx;
    const double limb2_S_reaction_mx = each_limb2_S_reaction_mx[1];
    reactions[33] = limb2_S_reaction_mx;
    const double limb3_S_reaction_my = each_limb2_S_reaction_mx[2];
    reactions[52] = limb3_S_reaction_my;
    const double limb4_S_reaction_mx = each_limb2_S_reaction_mx[3];
    reactions[69] = limb4_S_reaction_mx;
    const lanes4 each_limb2_S_reaction_my = lanes_90 - signed_limb_upper_position_z *
        each_limb1_U2_reaction_fy;
    const double minus_limb2_S_reaction_my = -each_limb2_S_reaction_my[1];
    reactions[34] = -minus_limb2_S_reaction_my;
    const double limb3_S_reaction_mx = each_limb2_S_reaction_my[2];
    reactions[51] = limb3_S_reaction_mx;
    const double limb4_S_reaction_my = each_limb2_S_reaction_my[3];
    reactions[70] = limb4_S_reaction_my;
    const lanes4 signed_limb_lower_sent_my = limb_upper_offset_x * signed_limb_upper_sent_fz -
        signed_limb_upper_rate_my_2 - signed_limb_lower_rate_my_2;
    const double t383 = limb1_U_0_cos * limb1_U2_joint_reaction_mz, /* limb1 */
      t385 = t383 - each_limb1_lower_rotation_yx[0] * limb1_U2_joint_reaction_mx, /* limb1 */
      limb1_U2_reaction_my = each_limb2_S_reaction_mx[0] + t385;
    reactions[16] = limb1_U2_reaction_my;
    const double limb1_U2_reaction_mx = limb1_lower_sin * limb1_U2_joint_reaction_mx -
        (-each_limb2_S_reaction_my[0]);
    reactions[15] = limb1_U2_reaction_mx;
    const lanes4 lanes_95 = each_limb1_U_0_cos * signed_limb_upper_sent_fz,
      each_limb1_P_reaction_fy = lanes_95 + each_limb1_lower_rotation_yy * minus_limb_upper_sent_fy;
    reactions[7] = -each_limb1_P_reaction_fy[0];
    reactions[24] = -each_limb1_P_reaction_fy[1];
    reactions[43] = -(-each_limb1_P_reaction_fy[2]);
    reactions[60] = -(-each_limb1_P_reaction_fy[3]);
    /* limbs together: reactions, eq. (32); momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const lanes4 lanes_97 = each_limb1_lower_rotation_yy * signed_limb_upper_rate_my_2,
      lanes_98 = each_limb1_upper_position_x * each_limb1_P_reaction_fy,
      lanes_99 = signed_limb_upper_position_z * each_limb1_P_reaction_fy,
      each_limb1_P_reaction_fx = lanes_2 * minus_limb_upper_sent_fy;
    reactions[6] = -each_limb1_P_reaction_fx[0];
    reactions[25] = -each_limb1_P_reaction_fx[1];
    reactions[42] = each_limb1_P_reaction_fx[2];
    reactions[61] = each_limb1_P_reaction_fx[3];
    const lanes4 lanes_100 = signed_limb_lower_rotation_zy * minus_limb_upper_sent_fy,
      lanes_101 = signed_limb_lower_rotation_zy * signed_limb_upper_rate_my_2,
      lanes_102 = signed_limb_upper_position_z * each_limb1_P_reaction_fx,
      lanes_104 = each_limb1_upper_position_y * each_limb1_P_reaction_fx + lanes_98,
      lanes_105 = lanes_2 * signed_limb_upper_rate_my_2,
      signed_limb_lower_alpha_x = signed_limb_lower_alpha_still_x + limb_U_a_0 * signed_limb_lower_sin,
      lanes_107 = (lanes4){k14, k14, -k14, -k14} * signed_limb_lower_alpha_x,
      limb_upper_rate_mx = lanes_107 - (lanes4){k15, k15, -k15, -k15} * signed_limb_lower_alpha_still_x;
    const double limb1_upper_rate_mx = limb_upper_rate_mx[0],
      limb1_upper_sent_mx = limb1_upper_rate_mx + limb1_U2_joint_reaction_mx,
      limb2_upper_rate_mx = limb_upper_rate_mx[1], limb3_upper_rate_mx = limb_upper_rate_mx[2],
      limb4_upper_rate_mx = limb_upper_rate_mx[3];
    const lanes4 each_limb1_upper_sent_mx = {limb1_upper_sent_mx, limb2_upper_rate_mx, limb3_upper_rate_mx,
        limb4_upper_rate_mx},
      lanes_111 = (lanes4){1.0, 1.0, -1.0, -1.0} * each_limb1_upper_sent_mx,
      lanes_113 = lanes_101 + signed_limb_lower_rotation_zx * lanes_111,
      lanes_115 = lanes_97 + each_limb1_lower_rotation_yx * lanes_111,
      minus_limb_upper_rate_mz_2 = minus_limb_upper_rate_mz - (k18 * limb_U_a_1 + lanes_41);
    const double minus_limb1_upper_sent_mz = minus_limb_upper_rate_mz_2[0] - limb1_U2_joint_reaction_mz;
    const lanes4 each_limb1_upper_sent_mz = {minus_limb1_upper_sent_mz, minus_limb_upper_rate_mz_2[1],
        minus_limb_upper_rate_mz_2[2], minus_limb_upper_rate_mz_2[3]},
      signed_limb_P_reaction_mz = lanes_104 + (each_limb1_U_0_sin * each_limb1_upper_sent_mz - lanes_113);
    reactions[11] = -signed_limb_P_reaction_mz[0];
    reactions[29] = -(-signed_limb_P_reaction_mz[1]);
    reactions[47] = -signed_limb_P_reaction_mz[2];
    reactions[65] = signed_limb_P_reaction_mz[3];
    const lanes4 lanes_121 = each_limb1_U_0_cos * each_limb1_upper_sent_mz + lanes_115,
      signed_limb_P_reaction_fz = each_limb1_U_0_sin * signed_limb_upper_sent_fz - lanes_100;
    const double minus_limb1_P_reaction_fz = signed_limb_P_reaction_fz[0];
    reactions[8] = -minus_limb1_P_reaction_fz;
    reactions[26] = signed_limb_P_reaction_fz[1];
    const double minus_limb3_P_reaction_fz = -signed_limb_P_reaction_fz[2];
    reactions[44] = -minus_limb3_P_reaction_fz;
    reactions[62] = -signed_limb_P_reaction_fz[3];
    const lanes4 each_limb1_P_reaction_my = each_limb1_upper_position_x * signed_limb_P_reaction_fz -
        lanes_102 - lanes_121;
    reactions[10] = -(-each_limb1_P_reaction_my[0]);
    reactions[27] = each_limb1_P_reaction_my[1];
    reactions[46] = each_limb1_P_reaction_my[2];
    reactions[63] = each_limb1_P_reaction_my[3];
    const lanes4 lanes_126 = lanes_99 + each_limb1_upper_position_y * signed_limb_P_reaction_fz,
      each_limb1_P_reaction_mx = lanes_126 + (signed_limb_lower_sin * lanes_111 - lanes_105);
    reactions[9] = each_limb1_P_reaction_mx[0];
    reactions[28] = each_limb1_P_reaction_mx[1];
    reactions[45] = each_limb1_P_reaction_mx[2];
    reactions[64] = each_limb1_P_reaction_mx[3];
    const lanes4 lanes_129 = {-1.0, -2.0, 2.0, 2.0},
      each_limb1_lower_sent_mx = {limb1_upper_rate_mx + limb1_upper_sent_mx, limb2_upper_rate_mx,
        limb3_upper_rate_mx, limb4_upper_rate_mx},
      signed_limb_lower_sent_mx = lanes_129 * each_limb1_lower_sent_mx,
      lanes_131 = lanes_2 * signed_limb_lower_sent_my,
      minus_limb_lower_joint_sent_mx = signed_limb_lower_sin * signed_limb_lower_sent_my + lanes_2 *
        signed_limb_lower_sent_mx,
      limb_lower_joint_sent_my = lanes_131 - signed_limb_lower_sin * signed_limb_lower_sent_mx;
    reactions[3] = limb_lower_joint_sent_my[0];
    reactions[22] = limb_lower_joint_sent_my[1];
    reactions[39] = -(-limb_lower_joint_sent_my[2]);
    reactions[58] = -(-limb_lower_joint_sent_my[3]);
    const lanes4 lanes_134 = each_limb1_U_0_cos * minus_limb_lower_joint_sent_mx,
      lanes_135 = each_limb1_U_0_sin * minus_limb_lower_joint_sent_mx, lanes_137 = lanes_2 *
        limb_lower_sent_fy,
      signed_limb_lower_joint_sent_fx = lanes_2 * limb_lower_sent_fx - signed_limb_lower_sin *
        limb_lower_sent_fy,
      signed_limb_lower_joint_sent_fy = lanes_137 + signed_limb_lower_sin * limb_lower_sent_fx;
    reactions[0] = signed_limb_lower_joint_sent_fy[0];
    reactions[19] = signed_limb_lower_joint_sent_fy[1];
    reactions[36] = -signed_limb_lower_joint_sent_fy[2];
    reactions[55] = -signed_limb_lower_joint_sent_fy[3];
    const lanes4 lanes_140 = each_limb1_U_0_sin * signed_limb_lower_joint_sent_fx,
      lanes_141 = each_limb1_U_0_cos * signed_limb_lower_joint_sent_fx,
      lanes_142 = {limb_lower_m_gravity_z, -limb_lower_m_gravity_z, -limb_lower_m_gravity_z,
        limb_lower_m_gravity_z},
      signed_limb_lower_sent_fz = signed_limb_lower_rate_fz + lanes_142 * each_limb1_U_0_sin -
        signed_limb_upper_sent_fz,
      each_limb1_U_0_joint_sent_fx = lanes_140 - each_limb1_U_0_cos * signed_limb_lower_sent_fz;
    reactions[1] = -each_limb1_U_0_joint_sent_fx[0];
    const double minus_limb2_U_0_joint_sent_fy = each_limb1_U_0_joint_sent_fx[1];
    reactions[18] = -minus_limb2_U_0_joint_sent_fy;
    const double minus_limb3_U_0_joint_sent_fx = -each_limb1_U_0_joint_sent_fx[2];
    reactions[37] = -minus_limb3_U_0_joint_sent_fx;
    const double minus_limb4_U_0_joint_sent_fy = -each_limb1_U_0_joint_sent_fx[3];
    reactions[54] = -minus_limb4_U_0_joint_sent_fy;
    const lanes4 signed_limb_U_reaction_mz = lanes_134 - param_R * each_limb1_U_0_joint_sent_fx;
    reactions[5] = -signed_limb_U_reaction_mz[0];
    reactions[23] = -(-signed_limb_U_reaction_mz[1]);
    reactions[41] = -signed_limb_U_reaction_mz[2];
    reactions[59] = signed_limb_U_reaction_mz[3];
    const lanes4 each_limb1_U_0_joint_sent_fy = lanes_141 + each_limb1_U_0_sin * signed_limb_lower_sent_fz;
    const double minus_limb1_U_0_joint_sent_fy = -each_limb1_U_0_joint_sent_fy[0];
    reactions[2] = -minus_limb1_U_0_joint_sent_fy;
    reactions[20] = -each_limb1_U_0_joint_sent_fy[1];
    const double minus_limb3_U_0_joint_sent_fy = each_limb1_U_0_joint_sent_fy[2];
    reactions[38] = -minus_limb3_U_0_joint_sent_fy;
    reactions[56] = each_limb1_U_0_joint_sent_fy[3];
    const lanes4 each_limb1_U_reaction_my = param_R * each_limb1_U_0_joint_sent_fy + lanes_135;
    reactions[4] = -(-each_limb1_U_reaction_my[0]);
    reactions[21] = -(-each_limb1_U_reaction_my[1]);
    reactions[40] = each_limb1_U_reaction_my[2];
    reactions[57] = each_limb1_U_reaction_my[3];
    const lanes4 every = (lanes4)((three_ups_upu_s_vector4_mask)((((each_limb1_U_0_lever_mz_by_limb1_U2_fz +
        signed_limb_lower_joint_sent_fy) + (limb_lower_joint_sent_my + each_limb1_U_reaction_my)) +
        ((signed_limb_U_reaction_mz + each_limb1_P_reaction_fy) + (each_limb1_P_reaction_mx +
        each_limb1_P_reaction_my))) + signed_limb_P_reaction_mz) | ((each_limb1_U_0_lever_mz_by_limb1_U2_fz <=
        (lanes4){6.233100000000001e-10, 6.3211e-10, 6.4044e-10, 6.284e-10}) &
        (each_limb1_U_0_lever_mz_by_limb1_U2_fz >= -(lanes4){6.233100000000001e-10, 6.3211e-10, 6.4044e-10,
        6.284e-10})));
    return fabs(platform_joint_force_mz_by_limb1_U2_mn) <= 4.0171000000000005e-10 || fabs(minus_determinant)
        <= 2.393867125597279e-10 || !(t8 >= 0.999999 && t8 <= 1.000001) ? (double)NAN :
        (((((platform_joint_force_mz_by_limb1_U2_mn + minus_determinant) + (minus_limb1_P_drive +
        minus_limb4_P_drive)) + ((minus_limb1_U_0_joint_sent_fy + minus_limb1_P_reaction_fz) +
        (minus_limb1_U2_reaction_fx + limb1_U2_reaction_mx))) + (((limb1_U2_reaction_my +
        limb1_U2_reaction_mz) + (minus_limb2_U_0_joint_sent_fy + minus_limb2_S_reaction_fy)) +
        ((minus_limb2_S_reaction_fz + limb2_S_reaction_mx) + (minus_limb2_S_reaction_my +
        limb2_S_reaction_mz)))) + ((((minus_limb3_U_0_joint_sent_fx + minus_limb3_U_0_joint_sent_fy) +
        (minus_limb3_P_reaction_fz + minus_limb3_S_reaction_fy)) + ((minus_limb3_S_reaction_fz +
        limb3_S_reaction_mx) + (limb3_S_reaction_my + limb3_S_reaction_mz))) +
        (((minus_limb4_U_0_joint_sent_fy + minus_limb4_S_reaction_fx) + (limb4_S_reaction_mx +
        limb4_S_reaction_my)) + ((limb4_S_reaction_mz + platform_joint_sent_fx) + (platform_joint_sent_fy +
        platform_joint_sent_fz))))) + ((every[0] + every[1]) + (every[2] + every[3]));
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
