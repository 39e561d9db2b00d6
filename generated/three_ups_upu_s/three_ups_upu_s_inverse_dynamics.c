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
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1),
      limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin, limb1_U_v_1 = READ(v, 1),
      minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x, limb1_U_a_0 = READ(a, 0),
      limb1_lower_cos = SINES(cosine, 1),
      minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_U_a_0 * limb1_lower_cos,
      limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y,
      t190 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_rate_fz = limb_lower_mx * limb1_lower_U_zx,
      t185 = limb1_upper_offset_x * limb1_lower_U_zx + gravity_z * limb1_U_0_sin,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos,
      limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y, limb1_P_v = READ(v, 2),
      minus_limb1_upper_acc_z = limb1_P_v * (2.0 * limb1_lower_omega_y) - t185,
      t186 = limb1_upper_offset_x * (limb_lower_m * minus_limb1_upper_acc_z + limb1_lower_rate_fz),
      minus_limb1_lower_moment_y = limb_lower_mx * minus_limb1_upper_acc_z - t186 + (gravity_z_limb_lower_mx * limb1_U_0_sin + t190),
      t191 = limb1_lower_cos * minus_limb1_lower_moment_y, t198 = limb1_lower_omega_y * limb1_lower_omega_y,
      limb1_U_0_moment_z = limb1_lower_sin * (k10 * (limb1_U_v_1 * limb1_lower_omega_y)) - t191 + k3 * limb1_U_a_0,
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t19 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    /* limb1: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); accelerations */
    const REAL minus_limb1_U2_part_fz = t19 * limb1_U_0_moment_z, minus_limb1_U2_arm_y = param_R * limb1_lower_cos,
      t192 = minus_limb1_U2_arm_y * minus_limb1_U2_part_fz, t193 = limb1_lower_cos * t192,
      t230 = limb1_lower_sin * t192, limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      t194 = limb1_U2_arm_x * minus_limb1_U2_part_fz, t196 = t193 - limb1_lower_sin * t194,
      limb1_U_0_cos = SINES(cosine, 0), limb1_U_a_1 = READ(a, 1), t232 = t230 + limb1_lower_cos * t194,
      t197 = limb1_U_0_cos * t196, t261 = limb1_U_0_sin * t196,
      limb1_lower_U_yx = limb1_U_a_1 + limb1_lower_U_still_xy, t207 = k8 * limb1_lower_U_still_xy,
      t203 = limb1_upper_offset_x * limb1_lower_U_yx, limb1_lower_rate_fy = limb_lower_mx * limb1_lower_U_yx,
      limb1_U_0_acc_y = gravity_z * limb1_U_0_cos, minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y,
      limb1_upper_moment_z = limb_lower_mx * minus_limb1_lower_acc_y,
      limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y,
      limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) + (t203 - minus_limb1_lower_acc_y),
      t205 = limb1_upper_offset_x * (limb_lower_m * limb1_upper_acc_y - limb1_lower_rate_fy),
      minus_limb1_lower_moment_z = limb_lower_mx * limb1_upper_acc_y - t205 + (limb1_upper_moment_z - (t207 + k9 * limb1_U_a_1)),
      t36 = limb1_lower_cos * t19, t210 = limb1_U2_arm_x * (minus_limb1_lower_moment_z * t36),
      minus_limb1_lower_U_still_xx = t198 + limb1_U_v_1 * limb1_U_v_1,
      limb1_lower_force_x = limb_lower_m * (READ(a, 2) - (limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x)),
      t211 = minus_limb1_U2_arm_y * (limb_lower_mx * minus_limb1_lower_U_still_xx + limb1_lower_force_x) - t210;
    /* limb5_S: geometry; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13),
      t213 = t197 + limb1_U_0_sin * t211, /* limb1 */
      t263 = t261 - limb1_U_0_cos * t211, /* limb1 */
      t2 = limb5_S_q_qw * limb5_S_q_qw, t3 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t4 = t2 + t3,
      t5 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6,
      t8 = t4 + t7, t10 = 4.0 - 2.0 * t8, platform_turn_zz = 1.0 - t10 * (t3 + t5),
      platform_turn_yy = 1.0 - t10 * (t3 + t6), platform_turn_xx = 1.0 - t7 * t10, t14 = limb5_S_q_qz * t10,
      t15 = limb5_S_q_qy * t14, t17 = limb5_S_q_qw * (limb5_S_q_qx * t10), t32 = limb5_S_q_qy * t10,
      platform_turn_zy = t15 + t17, limb5_S_v_wz = READ(v, 14), platform_turn_yz = t15 - t17,
      minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      minus_platform_rate_mx = minus_platform_moment_x - (k12 * (READ(v, 13) * limb5_S_v_wz) + k13 * READ(a, 12)),
      t225 = platform_turn_xx * minus_platform_rate_mx, t166 = limb5_S_q_qx * t14, t34 = limb5_S_q_qw * t14,
      t167 = limb5_S_q_qw * t32, t33 = limb5_S_q_qx * t32, platform_turn_zx = t166 - t167,
      platform_turn_xz = t166 + t167, t171 = platform_turn_zx * minus_platform_rate_mx,
      platform_moment_y = gravity_z_platform_mz * platform_turn_zx,
      platform_rate_my = platform_moment_y - (k12 * (READ(v, 12) * limb5_S_v_wz) - k13 * READ(a, 13)),
      t176 = t171 - platform_turn_zy * platform_rate_my, platform_rate_mz = platform_Izz * READ(a, 14);
    /* limb2: velocities, eq. (6); geometry; accelerations */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3),
      t214 = t176 - platform_turn_zz * platform_rate_mz - t213, /* platform */
      t228 = platform_turn_xz * platform_rate_mz, /* platform */
      t259 = platform_turn_yz * platform_rate_mz, /* platform */
      limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin, limb2_U_v_1 = READ(v, 4),
      minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x, limb2_U_a_0 = READ(a, 3),
      limb2_lower_cos = SINES(cosine, 3),
      minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y - limb2_U_a_0 * limb2_lower_cos,
      limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y,
      t140 = k9 * minus_limb2_lower_alpha_still_y + k8 * minus_limb2_lower_alpha_y,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5), minus_limb2_U_0_cos = SINES(sine, 2),
      limb2_lower_rate_fz = limb_lower_mx * limb2_lower_U_zx,
      t135 = limb2_upper_offset_x * limb2_lower_U_zx - gravity_z * minus_limb2_U_0_cos,
      limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos,
      limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y, limb2_P_v = READ(v, 5),
      minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) - t135;
    /* limb2: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t136 = limb2_upper_offset_x * (limb_lower_m * minus_limb2_upper_acc_z + limb2_lower_rate_fz),
      t137 = limb_lower_mx * minus_limb2_upper_acc_z - t136,
      t141 = limb2_lower_cos * (t137 - (gravity_z_limb_lower_mx * minus_limb2_U_0_cos - t140)),
      t149 = limb2_lower_omega_y * limb2_lower_omega_y,
      limb2_U_0_moment_z = limb2_lower_sin * (k10 * (limb2_U_v_1 * limb2_lower_omega_y)) - t141 + k3 * limb2_U_a_0,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t130 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      minus_limb2_S_multiplier_fz = t130 * limb2_U_0_moment_z, t161 = limb2_lower_cos * t130,
      minus_limb2_S_arm_y = param_R * limb2_lower_cos, t142 = minus_limb2_S_arm_y * minus_limb2_S_multiplier_fz,
      t143 = limb2_lower_cos * t142, t253 = limb2_lower_sin * t142,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin,
      t145 = limb2_S_arm_x * minus_limb2_S_multiplier_fz, t147 = t143 - limb2_lower_sin * t145,
      limb2_U_0_sin = SINES(cosine, 2), limb2_U_a_1 = READ(a, 4), t255 = t253 + limb2_lower_cos * t145,
      t148 = limb2_U_0_sin * t147, t234 = minus_limb2_U_0_cos * t147,
      limb2_lower_U_yx = limb2_U_a_1 + limb2_lower_U_still_xy, t158 = k8 * limb2_lower_U_still_xy,
      t154 = limb2_upper_offset_x * limb2_lower_U_yx, limb2_lower_rate_fy = limb_lower_mx * limb2_lower_U_yx,
      minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin, limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y,
      minus_limb2_upper_moment_z = limb_lower_mx * limb2_lower_acc_y,
      minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y,
      limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + (t154 + limb2_lower_acc_y),
      t156 = limb2_upper_offset_x * (limb_lower_m * limb2_upper_acc_y - limb2_lower_rate_fy),
      t157 = limb_lower_mx * limb2_upper_acc_y - t156,
      t162 = limb2_S_arm_x * ((t157 - (minus_limb2_upper_moment_z + (t158 + k9 * limb2_U_a_1))) * t161),
      minus_limb2_lower_U_still_xx = t149 + limb2_U_v_1 * limb2_U_v_1,
      limb2_lower_force_x = limb_lower_m * (READ(a, 5) - (limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x)),
      t163 = minus_limb2_S_arm_y * (limb_lower_mx * minus_limb2_lower_U_still_xx + limb2_lower_force_x) - t162;
    /* limb3: velocities, eq. (6); geometry; accelerations */
    const REAL limb3_U_v_0 = READ(v, 6), minus_limb3_lower_sin = SINES(sine, 5),
      t215 = t148 + minus_limb2_U_0_cos * t163 + t214, /* platform */
      t236 = t234 - limb2_U_0_sin * t163, /* limb2 */
      minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin, limb3_U_v_1 = READ(v, 7),
      limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x, limb3_U_a_0 = READ(a, 6),
      limb3_lower_cos = SINES(cosine, 5),
      limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_U_a_0 * limb3_lower_cos,
      minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y,
      t104 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), limb3_U_0_sin = SINES(sine, 4),
      minus_limb3_lower_rate_fz = limb_lower_mx * minus_limb3_lower_U_zx,
      t99 = limb3_upper_offset_x * minus_limb3_lower_U_zx - gravity_z * limb3_U_0_sin,
      limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos,
      minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y, limb3_P_v = READ(v, 8),
      minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) + t99;
    /* limb3: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t100 = limb3_upper_offset_x * (limb_lower_m * minus_limb3_upper_acc_z - minus_limb3_lower_rate_fz),
      minus_limb3_lower_moment_y = limb_lower_mx * minus_limb3_upper_acc_z - t100 + (gravity_z_limb_lower_mx * limb3_U_0_sin - t104),
      t105 = limb3_lower_cos * minus_limb3_lower_moment_y, t113 = limb3_lower_omega_y * limb3_lower_omega_y,
      minus_limb3_U_0_moment_z = minus_limb3_lower_sin * (k10 * (limb3_U_v_1 * limb3_lower_omega_y)) + t105 - k3 * limb3_U_a_0,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t94 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      limb3_S_multiplier_fz = t94 * minus_limb3_U_0_moment_z, t125 = limb3_lower_cos * t94,
      limb3_S_arm_y = param_R * limb3_lower_cos, t106 = limb3_S_arm_y * limb3_S_multiplier_fz,
      t107 = limb3_lower_cos * t106, t221 = minus_limb3_lower_sin * t106,
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin,
      t109 = limb3_S_arm_x * limb3_S_multiplier_fz, t111 = t107 - minus_limb3_lower_sin * t109,
      limb3_U_0_cos = SINES(cosine, 4), limb3_U_a_1 = READ(a, 7), t223 = t221 + limb3_lower_cos * t109,
      t112 = limb3_U_0_cos * t111, t250 = limb3_U_0_sin * t111,
      limb3_lower_U_yx = limb3_U_a_1 - minus_limb3_lower_U_still_xy, t122 = k8 * minus_limb3_lower_U_still_xy,
      t118 = limb3_upper_offset_x * limb3_lower_U_yx, limb3_lower_rate_fy = limb_lower_mx * limb3_lower_U_yx,
      limb3_U_0_acc_y = gravity_z * limb3_U_0_cos, limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y,
      minus_limb3_upper_moment_z = limb_lower_mx * limb3_lower_acc_y,
      limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y,
      limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + (t118 + limb3_lower_acc_y),
      t120 = limb3_upper_offset_x * (limb_lower_m * limb3_upper_acc_y - limb3_lower_rate_fy),
      t121 = limb_lower_mx * limb3_upper_acc_y - t120,
      t126 = limb3_S_arm_x * ((t121 - (minus_limb3_upper_moment_z - (t122 - k9 * limb3_U_a_1))) * t125),
      minus_limb3_lower_U_still_xx = t113 + limb3_U_v_1 * limb3_U_v_1,
      limb3_lower_force_x = limb_lower_m * (READ(a, 8) - (limb3_upper_offset_x * minus_limb3_lower_U_still_xx - limb3_lower_acc_x)),
      t127 = limb3_S_arm_y * (limb_lower_mx * minus_limb3_lower_U_still_xx + limb3_lower_force_x) + t126;
    /* limb4: velocities, eq. (6); geometry; accelerations */
    const REAL limb4_U_v_0 = READ(v, 9), minus_limb4_lower_sin = SINES(sine, 7),
      t216 = t112 - limb3_U_0_sin * t127 - t215, /* platform */
      t252 = t250 + limb3_U_0_cos * t127, /* limb3 */
      minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin, limb4_U_v_1 = READ(v, 10),
      limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x, limb4_U_a_0 = READ(a, 9),
      limb4_lower_cos = SINES(cosine, 7),
      limb4_lower_alpha_y = limb4_lower_alpha_still_y + limb4_U_a_0 * limb4_lower_cos,
      minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y,
      t68 = k9 * limb4_lower_alpha_still_y + k8 * limb4_lower_alpha_y,
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11), minus_limb4_U_0_cos = SINES(sine, 6),
      minus_limb4_lower_rate_fz = limb_lower_mx * minus_limb4_lower_U_zx,
      t63 = limb4_upper_offset_x * minus_limb4_lower_U_zx + gravity_z * minus_limb4_U_0_cos,
      limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos,
      minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y, limb4_P_v = READ(v, 11),
      minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + t63;
    /* limb4: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t64 = limb4_upper_offset_x * (limb_lower_m * minus_limb4_upper_acc_z - minus_limb4_lower_rate_fz),
      t65 = limb_lower_mx * minus_limb4_upper_acc_z - t64,
      t69 = limb4_lower_cos * (t65 - (gravity_z_limb_lower_mx * minus_limb4_U_0_cos + t68)),
      t77 = limb4_lower_omega_y * limb4_lower_omega_y,
      minus_limb4_U_0_moment_z = minus_limb4_lower_sin * (k10 * (limb4_U_v_1 * limb4_lower_omega_y)) + t69 - k3 * limb4_U_a_0,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked3 = minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t58 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_S_multiplier_fz = t58 * minus_limb4_U_0_moment_z, t89 = limb4_lower_cos * t58,
      limb4_S_arm_y = param_R * limb4_lower_cos, t70 = limb4_S_arm_y * limb4_S_multiplier_fz,
      t71 = limb4_lower_cos * t70, t247 = minus_limb4_lower_sin * t70,
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      t73 = limb4_S_arm_x * limb4_S_multiplier_fz, t75 = t71 - minus_limb4_lower_sin * t73,
      limb4_U_0_sin = SINES(cosine, 6), limb4_U_a_1 = READ(a, 10), t249 = t247 + limb4_lower_cos * t73,
      t76 = limb4_U_0_sin * t75, t218 = minus_limb4_U_0_cos * t75,
      limb4_lower_U_yx = limb4_U_a_1 - minus_limb4_lower_U_still_xy, t86 = k8 * minus_limb4_lower_U_still_xy,
      t82 = limb4_upper_offset_x * limb4_lower_U_yx, limb4_lower_rate_fy = limb_lower_mx * limb4_lower_U_yx,
      minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y,
      limb4_upper_moment_z = limb_lower_mx * minus_limb4_lower_acc_y,
      minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y,
      limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) + (t82 - minus_limb4_lower_acc_y),
      t84 = limb4_upper_offset_x * (limb_lower_m * limb4_upper_acc_y - limb4_lower_rate_fy),
      minus_limb4_lower_moment_z = limb_lower_mx * limb4_upper_acc_y - t84 + (limb4_upper_moment_z + (t86 - k9 * limb4_U_a_1)),
      t90 = limb4_S_arm_x * (minus_limb4_lower_moment_z * t89),
      minus_limb4_lower_U_still_xx = t77 + limb4_U_v_1 * limb4_U_v_1,
      limb4_upper_acc_x = READ(a, 11) - (limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_lower_acc_x),
      t79 = limb4_S_arm_y * (limb_lower_mx * minus_limb4_lower_U_still_xx + limb_lower_m * limb4_upper_acc_x),
      t91 = t79 + t90, minus_platform_joint_force_mz = t76 - minus_limb4_U_0_cos * t91 - t216,
      t220 = t218 + limb4_U_0_sin * t91;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; balance, eqs. (40)-(47) */
    const REAL t29 = limb1_U_0_cos * platform_turn_zy,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t19,
      t21 = limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3,
      t24 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3, t45 = limb1_lower_sin * t21,
      t26 = limb1_lower_cos * t21 + limb1_lower_sin * t24,
      platform_joint_force_mx_by_limb1_U2_mn = t45 - limb1_lower_cos * t24, t40 = limb1_U_0_cos * t26,
      t27 = limb1_U_0_sin * t26, t31 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - t29);
    /* limb5_S: balance, eqs. (40)-(47); geometry; drives */
    const REAL t257 = platform_turn_yy * platform_rate_my, platform_turn_xy = t33 - t34,
      t265 = t255 - ((t33 + t34) * minus_platform_rate_mx - t257 - t259 + t263),
      minus_platform_joint_force_my = t249 + (t252 - t265),
      t238 = t223 + (t225 - platform_turn_xy * platform_rate_my - t228 - t232 + t236),
      minus_platform_joint_force_mx = t220 + t238,
      limb1_U2_constraint_mn_couple_z = t31 - limb1_lower_sin * platform_turn_xy,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * (limb1_U2_constraint_mn_couple_z * t36),
      platform_joint_force_mz_by_limb1_U2_mn = t40 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    checked0 = checked0 + platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t42 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      limb1_U2_part_mn = t42 * minus_platform_joint_force_mz,
      t39 = t27 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb5_S_balance_wx = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn - minus_platform_joint_force_mx,
      minus_limb5_S_balance_wy = t39 * limb1_U2_part_mn + minus_platform_joint_force_my,
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
      minus_limb5_S_balance_wy_by_limb4_P = limb1_U2_part_mn_by_limb4_P * t39,
      limb5_S_balance_wx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y + t47;
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
      t283 = t277 * t282; /* limb1 */
    RESULT(checked2, u, 0, -(minus_limb5_S_balance_wy_by_limb1_P * t278 + limb5_S_balance_wx_by_limb1_P * t283));
    RESULT(checked3, u, 1, limb5_S_balance_wy_by_limb2_P * t278 + minus_limb5_S_balance_wx_by_limb2_P * t283);
    const REAL t289 = minus_limb5_S_balance_wy_by_limb4_P * t278; /* limb4 */
    RESULT(checked0, u, 2, limb5_S_balance_wy_by_limb3_P * t278 + minus_limb5_S_balance_wx_by_limb3_P * t283);
    RESULT(checked1, u, 3, -(t289 + limb5_S_balance_wx_by_limb4_P * t283));
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

BODY(three_ups_upu_s_inverse_dynamics_independent)(size_t stride, const double *restrict q,
    const double *restrict y_dot, const double *restrict y_ddot, double *restrict u,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry; rates that follow */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t2 = limb5_S_q_qw * limb5_S_q_qw,
      t3 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t4 = t2 + t3, t5 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7, t11 = t3 + t6,
      t110 = t3 + t5, t10 = 4.0 - 2.0 * t8, platform_turn_yy = 1.0 - t10 * t11, t76 = k2 - 0.5 * t8,
      platform_turn_xx = 1.0 - t7 * t10, platform_turn_zz = 1.0 - t10 * t110, t14 = limb5_S_q_qz * t10,
      t15 = limb5_S_q_qy * t14, t17 = limb5_S_q_qw * (limb5_S_q_qx * t10), t32 = limb5_S_q_qy * t10,
      platform_turn_zy = t15 + t17, platform_turn_yz = t15 - t17, limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_sin = SINES(sine, 0),
      t30 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t31 = limb1_lower_cos * t30, /* limb1 */
      t174 = limb1_lower_sin * t30, /* limb1 */
      t33 = limb5_S_q_qx * t32, t109 = limb5_S_q_qw * t32, t34 = limb5_S_q_qw * t14, t108 = limb5_S_q_qx * t14,
      platform_turn_xy = t33 - t34, platform_turn_yx = t33 + t34;
    /* limb1: reciprocal wrenches, eq. (10); geometry; rates that follow */
    const REAL limb1_U2_constraint_mn_couple_z = t31 - limb1_lower_sin * platform_turn_xy,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t19 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t36 = limb1_lower_cos * t19,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t36,
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      t41 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t38 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t19,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t79 = minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t79;
    /* limb5_S: pivots */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t41;
    REAL checked1 = minus_limb5_S_pivot_wz;
    /* limb5_S: rates that follow */
    const REAL t81 = 1.0 / minus_limb5_S_pivot_wz,
      t83 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t38, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t81 * t83, t78 = limb5_S_q_qx * t76,
      t84 = t78 * limb5_S_null_space_wz_by_limb5_S_wy, t77 = limb5_S_q_qw * t76, a_pivot = 0.5 * (t77 + t84);
    REAL checked2 = a_pivot;
    const REAL t86 = 1.0 / a_pivot, t90 = limb5_S_q_qy * t76, t91 = t90 * limb5_S_null_space_wz_by_limb5_S_wy,
      t87 = limb5_S_q_qz * t76, t94 = t86 * (0.5 * (t87 - t91)), t88 = 0.5 * t87, a_pivot_2 = 0.5 * t77 + t88 * t94;
    REAL checked3 = a_pivot_2;
    const REAL limb5_S_null_space_wx_by_limb5_S_qx = 1.0 / a_pivot_2;
    /* platform: velocities, eq. (6); accelerations; geometry */
    const REAL limb5_S_y_dot_qy = READ(y_dot, 1),
      limb5_S_joint_rate_wx = limb5_S_null_space_wx_by_limb5_S_qx * (READ(y_dot, 0) - limb5_S_y_dot_qy * t94),
      limb5_S_joint_rate_wy = t86 * (limb5_S_y_dot_qy + t88 * limb5_S_joint_rate_wx),
      limb5_S_joint_rate_wz = t81 * (t83 * limb5_S_joint_rate_wy), t117 = platform_turn_zy * limb5_S_joint_rate_wz,
      platform_omega_y = t117 + (platform_turn_yy * limb5_S_joint_rate_wy + platform_turn_xy * limb5_S_joint_rate_wx),
      t136 = platform_turn_zy * platform_omega_y, platform_turn_zx = t108 - t109, platform_turn_xz = t108 + t109,
      t123 = platform_turn_zx * limb5_S_joint_rate_wz,
      platform_omega_x = t123 + (platform_turn_yx * limb5_S_joint_rate_wy + platform_turn_xx * limb5_S_joint_rate_wx);
    /* platform: accelerations; velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t138 = t136 + platform_turn_zx * platform_omega_x, t112 = platform_turn_zz * limb5_S_joint_rate_wz,
      platform_omega_z = t112 + (platform_turn_yz * limb5_S_joint_rate_wy + platform_turn_xz * limb5_S_joint_rate_wx),
      t139 = platform_turn_zz * platform_omega_z + t138, t140 = limb1_U_0_cos * t139,
      t144 = platform_turn_yy * platform_omega_y + platform_turn_yx * platform_omega_x,
      t145 = platform_turn_yz * platform_omega_z + t144, t147 = t140 - limb1_U_0_sin * t145,
      t178 = limb1_lower_sin * t147, /* limb1 */
      t557 = k12 * (platform_omega_z * platform_omega_y),
      t128 = platform_turn_xy * platform_omega_y + platform_turn_xx * platform_omega_x,
      platform_U_still_xz = platform_omega_z * platform_omega_x, t129 = platform_turn_xz * platform_omega_z + t128,
      t549 = k12 * platform_U_still_xz;
    /* limb1: loop closure; velocities, eq. (6); accelerations */
    const REAL t179 = limb1_lower_cos * t129 - t178,
      t152 = minus_limb1_upper_position_x * (limb1_U_0_cos * limb5_S_joint_rate_wz - limb1_U_0_sin * limb5_S_joint_rate_wy),
      limb1_U_joint_rate_0 = limb5_S_joint_rate_wx + t19 * t152,
      limb1_lower_omega_y = limb1_lower_cos * limb1_U_joint_rate_0, t180 = t179 - limb1_lower_omega_y,
      t103 = limb1_U_0_sin * limb5_S_joint_rate_wz + limb1_U_0_cos * limb5_S_joint_rate_wy,
      limb1_U_joint_rate_1 = t36 * (limb1_U2_arm_x * t103), t197 = limb1_U_joint_rate_1 * t180,
      t157 = limb1_U_0_sin * t139 + limb1_U_0_cos * t145, /* limb5_S */
      t173 = limb1_U_joint_rate_1 - t157, t199 = t197 + t173 * limb1_lower_omega_y,
      limb1_lower_alpha_still_x = limb1_U_joint_rate_1 * limb1_lower_omega_y,
      t201 = limb1_U2_constraint_mn_couple_x * (t199 - limb1_lower_alpha_still_x),
      t586 = limb1_lower_sin * (k10 * limb1_lower_alpha_still_x),
      t186 = limb1_lower_sin * t129 + limb1_lower_cos * t147,
      limb1_lower_omega_x = limb1_lower_sin * limb1_U_joint_rate_0, t187 = t186 - limb1_lower_omega_x,
      t202 = limb1_U2_constraint_mn_couple_z * (limb1_lower_omega_y * t187 - t180 * limb1_lower_omega_x) + t201,
      t188 = limb1_U2_constraint_mn_couple_z * t180, t181 = limb1_U2_constraint_mn_couple_x * t180,
      limb1_U2_opening_mn = t174 + limb1_lower_cos * platform_turn_xy,
      t183 = t173 * (limb1_U2_opening_mn * t173 + t181),
      minus_limb1_U2_opening_bias_mn = t183 + t187 * (t188 + limb1_U2_opening_mn * t187) + t202,
      t168 = t147 * limb1_U_joint_rate_0, /* limb5_S */
      t169 = limb1_U2_arm_x * t168, /* limb5_S */
      minus_limb1_U2_arm_y = param_R * limb1_lower_cos, limb1_P_joint_rate = minus_limb1_U2_arm_y * t103,
      t603 = minus_limb1_U2_arm_y * t168, t170 = limb1_P_joint_rate * limb1_U_joint_rate_1 - t169, /* limb5_S */
      t132 = limb1_lower_cos * limb1_U_joint_rate_1;
    /* limb5_S: accelerations */
    const REAL t171 = t157 * (limb1_P_joint_rate - param_R * t132) - t170,
      t203 = limb1_U_factor_1_by_3 * t171 - minus_limb1_U2_opening_bias_mn,
      t133 = limb1_upper_offset_x * t132, /* limb1 */
      t159 = minus_limb1_upper_position_x * (limb1_U_joint_rate_0 * t157),
      t105 = limb1_lower_sin * limb1_U_joint_rate_1, /* limb1 */
      t604 = t157 * (param_R * t105) - t603, /* limb1 */
      t107 = limb1_lower_cos * limb1_P_joint_rate - limb1_upper_offset_x * t105, /* limb1 */
      t130 = t107 * t129,
      t161 = (limb1_lower_sin * limb1_P_joint_rate + t133) * t147 + (t107 * limb1_U_joint_rate_0 + t159),
      t162 = t130 - t161, limb5_S_joint_acc_still_wz = t81 * (minus_limb1_U_factor_0_by_3 * t162 + t203),
      t206 = 0.5 * (t78 * limb5_S_joint_acc_still_wz), t212 = 0.5 * (t78 * t145 - t90 * t129 - t77 * t139),
      t213 = t129 * t212, t243 = t145 * t212, t219 = 0.5 * (t90 * t139 - t87 * t145 - t77 * t129),
      t221 = t213 - t139 * t219, t239 = t77 * t145, t235 = 0.5 * (t90 * limb5_S_joint_acc_still_wz),
      t237 = t78 * t139, t227 = 0.5 * (t87 * t139 + (t90 * t145 + t78 * t129)),
      t244 = t139 * (0.5 * (t87 * t129 - t237 - t239)) - t243,
      t232 = t206 - (READ(y_ddot, 1) - 0.5 * (t221 - t145 * t227)), t233 = t94 * t232,
      t250 = t233 + (t235 + (READ(y_ddot, 0) - 0.5 * (t244 - t129 * t227))),
      limb5_S_joint_acc_wx = limb5_S_null_space_wx_by_limb5_S_qx * t250,
      minus_limb5_S_joint_acc_wy = t86 * (t232 - t88 * limb5_S_joint_acc_wx),
      t254 = t81 * (t83 * minus_limb5_S_joint_acc_wy); /* limb4 */
    /* limb1: accelerations; momentum rate, eq. (35) */
    const REAL t570 = minus_limb1_upper_position_x * (limb1_U_0_cos * t254 - limb1_U_0_sin * minus_limb5_S_joint_acc_wy),
      t572 = limb5_S_joint_acc_wx - t19 * t570,
      limb1_U_joint_acc_0 = t572 + t19 * (t162 + minus_limb1_upper_position_x * (limb1_U_0_cos * limb5_S_joint_acc_still_wz)),
      limb1_lower_U_xz = limb1_lower_cos * limb1_U_joint_acc_0, limb1_U_0_rate_mz = k3 * limb1_U_joint_acc_0,
      minus_limb1_lower_alpha_still_y = limb1_U_joint_rate_1 * limb1_lower_omega_x,
      minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_lower_U_xz,
      limb1_lower_U_still_xy = limb1_lower_omega_y * limb1_lower_omega_x,
      limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y,
      t578 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y,
      limb1_lower_rate_fz = limb_lower_mx * limb1_lower_U_zx,
      t580 = gravity_z * limb1_U_0_sin + limb1_upper_offset_x * limb1_lower_U_zx,
      limb1_upper_acc_z = t580 - limb1_P_joint_rate * (2.0 * limb1_lower_omega_y),
      t594 = limb1_lower_omega_y * limb1_lower_omega_y;
    /* limb1: balance, eqs. (40)-(47) */
    const REAL t583 = limb1_upper_offset_x * (limb1_lower_rate_fz - limb_lower_m * limb1_upper_acc_z),
      t585 = limb1_lower_cos * (gravity_z_limb_lower_mx * limb1_U_0_sin + t578 - (t583 + limb_lower_mx * limb1_upper_acc_z)),
      minus_limb1_U2_part_fz = t19 * (limb1_U_0_rate_mz - (t585 - t586)),
      t587 = limb1_U2_arm_x * minus_limb1_U2_part_fz, t589 = minus_limb1_U2_arm_y * minus_limb1_U2_part_fz,
      t633 = limb1_lower_cos * t587, t591 = limb1_lower_sin * t587 - limb1_lower_cos * t589,
      t635 = t633 + limb1_lower_sin * t589, t592 = limb1_U_0_cos * t591, t663 = limb1_U_0_sin * t591;
    /* limb1: accelerations; momentum rate, eq. (35) */
    const REAL t597 = limb1_U_0_sin * t254 + limb1_U_0_cos * minus_limb5_S_joint_acc_wy, t607 = limb1_U2_arm_x * t597,
      t598 = minus_limb1_U2_arm_y * t597, t599 = limb1_U_0_sin * limb5_S_joint_acc_still_wz,
      minus_limb1_U_joint_acc_1 = t36 * (t607 - (t171 + limb1_U2_arm_x * t599)),
      minus_limb1_P_joint_acc = t598 - (minus_limb1_U2_arm_y * t599 - t604),
      limb1_lower_U_yx = limb1_lower_U_still_xy - minus_limb1_U_joint_acc_1,
      t612 = k8 * limb1_lower_U_still_xy - k9 * minus_limb1_U_joint_acc_1,
      t615 = limb1_upper_offset_x * limb1_lower_U_yx, limb1_lower_rate_fy = limb_lower_mx * limb1_lower_U_yx,
      limb1_U_0_acc_y = gravity_z * limb1_U_0_cos, minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y,
      minus_limb1_lower_rate_mz = limb_lower_mx * minus_limb1_lower_acc_y - t612,
      limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y,
      limb1_upper_acc_y = limb1_P_joint_rate * (2.0 * limb1_U_joint_rate_1) - (minus_limb1_lower_acc_y - t615),
      minus_limb1_lower_U_still_xx = limb1_U_joint_rate_1 * limb1_U_joint_rate_1 + t594;
    /* limb1: balance, eqs. (40)-(47); accelerations */
    const REAL t617 = limb1_upper_offset_x * (limb1_lower_rate_fy - limb_lower_m * limb1_upper_acc_y),
      t619 = limb1_U2_arm_x * (t36 * (minus_limb1_lower_rate_mz + (t617 + limb_lower_mx * limb1_upper_acc_y))),
      limb1_upper_acc_x = limb1_lower_acc_x - limb1_upper_offset_x * minus_limb1_lower_U_still_xx - minus_limb1_P_joint_acc,
      t605 = minus_limb1_U2_arm_y * (limb_lower_mx * minus_limb1_lower_U_still_xx + limb_lower_m * limb1_upper_acc_x),
      t620 = t605 - t619, t24 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3,
      t21 = limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3,
      t622 = t592 - limb1_U_0_sin * t620, t665 = t663 + limb1_U_0_cos * t620;
    /* platform: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz - t254,
      t550 = platform_turn_zy * limb5_S_joint_acc_wz,
      platform_alpha_y = t550 - (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy * limb5_S_joint_acc_wx),
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (t549 - k13 * platform_alpha_y),
      t637 = platform_turn_xy * platform_rate_my, t659 = platform_turn_yy * platform_rate_my,
      t556 = platform_turn_zy * platform_rate_my, minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      t558 = platform_turn_zx * limb5_S_joint_acc_wz, t544 = platform_turn_zz * limb5_S_joint_acc_wz,
      platform_alpha_x = t558 - (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx * limb5_S_joint_acc_wx),
      minus_platform_rate_mx = minus_platform_moment_x - (t557 + k13 * platform_alpha_x),
      t565 = t556 - platform_turn_zx * minus_platform_rate_mx,
      t639 = t637 - platform_turn_xx * minus_platform_rate_mx,
      t661 = t659 - platform_turn_yx * minus_platform_rate_mx,
      platform_alpha_z = t544 - (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz * limb5_S_joint_acc_wx),
      platform_rate_mz = platform_Izz * platform_alpha_z;
    /* limb2: geometry; accelerations; velocities, eq. (6) */
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2),
      t623 = platform_turn_zz * platform_rate_mz + t565 - t622, /* platform */
      t641 = t635 + (platform_turn_xz * platform_rate_mz + t639), /* platform */
      t666 = platform_turn_yz * platform_rate_mz + t661 + t665, /* platform */
      t451 = limb2_U_0_sin * t254 - minus_limb2_U_0_cos * limb5_S_joint_acc_wx,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5), limb2_lower_sin = SINES(sine, 3),
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      limb2_lower_cos = SINES(cosine, 3), t452 = minus_limb2_upper_position_y * t451,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    checked0 = checked0 + minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t448 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz, t454 = minus_limb5_S_joint_acc_wy - t448 * t452,
      t456 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_joint_acc_still_wz),
      t482 = limb2_U_0_sin * t129 - minus_limb2_U_0_cos * t139,
      t477 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_joint_rate_wz + minus_limb2_U_0_cos * limb5_S_joint_rate_wx),
      limb2_U_joint_rate_0 = limb5_S_joint_rate_wy - t448 * t477,
      t484 = minus_limb2_upper_position_y * (limb2_U_joint_rate_0 * t482),
      t459 = minus_limb2_U_0_cos * limb5_S_joint_rate_wz - limb2_U_0_sin * limb5_S_joint_rate_wx,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin,
      minus_limb2_upper_vel_y = limb2_S_arm_x * t459, t461 = limb2_lower_cos * t448,
      minus_limb2_U_joint_rate_1 = minus_limb2_upper_vel_y * t461;
    /* limb2: accelerations; velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t462 = limb2_lower_sin * minus_limb2_U_joint_rate_1, t463 = limb2_upper_offset_x * t462,
      t515 = t482 * (param_R * t462), minus_limb2_S_arm_y = param_R * limb2_lower_cos,
      minus_limb2_P_joint_rate = minus_limb2_S_arm_y * t459, t464 = limb2_lower_cos * minus_limb2_P_joint_rate - t463,
      t485 = t464 * limb2_U_joint_rate_0 - t484, t465 = t145 * t464,
      t467 = limb2_lower_cos * minus_limb2_U_joint_rate_1, t525 = t482 * (minus_limb2_P_joint_rate - param_R * t467),
      t469 = limb2_lower_sin * minus_limb2_P_joint_rate + limb2_upper_offset_x * t467,
      t472 = minus_limb2_U_0_cos * t129 + limb2_U_0_sin * t139,
      minus_limb2_U_joint_acc_0 = t454 + t448 * (t456 + (t465 + (t469 * t472 - t485))),
      t516 = t472 * limb2_U_joint_rate_0, minus_limb2_lower_U_xz = limb2_lower_cos * minus_limb2_U_joint_acc_0,
      minus_limb2_U_0_rate_mz = k3 * minus_limb2_U_joint_acc_0,
      limb2_lower_omega_x = limb2_lower_sin * limb2_U_joint_rate_0,
      limb2_lower_omega_y = limb2_lower_cos * limb2_U_joint_rate_0,
      limb2_lower_alpha_still_y = minus_limb2_U_joint_rate_1 * limb2_lower_omega_x,
      limb2_lower_alpha_y = limb2_lower_alpha_still_y - minus_limb2_lower_U_xz,
      limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y,
      minus_limb2_lower_U_zx = limb2_lower_alpha_still_y + limb2_lower_alpha_y,
      t491 = k9 * limb2_lower_alpha_still_y + k8 * limb2_lower_alpha_y,
      minus_limb2_lower_rate_fz = limb_lower_mx * minus_limb2_lower_U_zx,
      t493 = gravity_z * minus_limb2_U_0_cos + limb2_upper_offset_x * minus_limb2_lower_U_zx,
      minus_limb2_upper_acc_z = t493 - minus_limb2_P_joint_rate * (2.0 * limb2_lower_omega_y);
    /* limb2: balance, eqs. (40)-(47); accelerations */
    const REAL t496 = limb2_upper_offset_x * (minus_limb2_lower_rate_fz - limb_lower_m * minus_limb2_upper_acc_z),
      t497 = t496 + limb_lower_mx * minus_limb2_upper_acc_z,
      t498 = limb2_lower_cos * (gravity_z_limb_lower_mx * minus_limb2_U_0_cos + t491 - t497),
      minus_limb2_U_0_moment_z = minus_limb2_U_0_rate_mz - (t498 - limb2_lower_sin * (k10 * (minus_limb2_U_joint_rate_1 * limb2_lower_omega_y))),
      limb2_S_multiplier_fz = t448 * minus_limb2_U_0_moment_z, t507 = limb2_lower_omega_y * limb2_lower_omega_y,
      t500 = limb2_S_arm_x * limb2_S_multiplier_fz, t502 = minus_limb2_S_arm_y * limb2_S_multiplier_fz,
      t655 = limb2_lower_cos * t500, t504 = limb2_lower_sin * t500 - limb2_lower_cos * t502,
      t667 = t655 + limb2_lower_sin * t502 - t666, /* platform */
      t505 = limb2_U_0_sin * t504, t642 = minus_limb2_U_0_cos * t504;
    /* limb2: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL t510 = minus_limb2_U_0_cos * t254 + limb2_U_0_sin * limb5_S_joint_acc_wx, t521 = limb2_S_arm_x * t510,
      t511 = minus_limb2_S_arm_y * t510, t512 = minus_limb2_U_0_cos * limb5_S_joint_acc_still_wz,
      t522 = limb2_S_arm_x * t512,
      limb2_P_joint_acc = t511 - (minus_limb2_S_arm_y * t512 - (t515 - minus_limb2_S_arm_y * t516)),
      t530 = t522 + (t525 + (minus_limb2_P_joint_rate * minus_limb2_U_joint_rate_1 + limb2_S_arm_x * t516)),
      limb2_U_joint_acc_1 = t461 * (t521 - t530), limb2_lower_U_yx = limb2_lower_U_still_xy + limb2_U_joint_acc_1,
      t533 = k8 * limb2_lower_U_still_xy + k9 * limb2_U_joint_acc_1, t536 = limb2_upper_offset_x * limb2_lower_U_yx,
      limb2_lower_rate_fy = limb_lower_mx * limb2_lower_U_yx, minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin,
      limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y,
      limb2_lower_rate_mz = limb_lower_mx * limb2_lower_acc_y + t533,
      minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y,
      limb2_upper_acc_y = minus_limb2_P_joint_rate * (2.0 * minus_limb2_U_joint_rate_1) + (limb2_lower_acc_y + t536),
      minus_limb2_lower_U_still_xx = minus_limb2_U_joint_rate_1 * minus_limb2_U_joint_rate_1 + t507,
      t538 = limb2_upper_offset_x * (limb2_lower_rate_fy - limb_lower_m * limb2_upper_acc_y),
      t540 = limb2_S_arm_x * (t461 * (limb2_lower_rate_mz - (t538 + limb_lower_mx * limb2_upper_acc_y))),
      minus_limb2_upper_acc_x = minus_limb2_lower_acc_x + limb2_upper_offset_x * minus_limb2_lower_U_still_xx - limb2_P_joint_acc,
      t519 = minus_limb2_S_arm_y * (limb_lower_mx * minus_limb2_lower_U_still_xx - limb_lower_m * minus_limb2_upper_acc_x),
      t541 = t519 + t540;
    /* limb3: geometry; accelerations; velocities, eq. (6) */
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_0_sin = SINES(sine, 4),
      t624 = t505 + minus_limb2_U_0_cos * t541 - t623, /* platform */
      t645 = t641 - (t642 - limb2_U_0_sin * t541), /* platform */
      t354 = limb3_U_0_cos * t254 - limb3_U_0_sin * minus_limb5_S_joint_acc_wy,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x,
      limb3_lower_cos = SINES(cosine, 5), t355 = limb3_upper_position_x * t354,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    checked1 = checked1 + minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t351 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz, t357 = limb5_S_joint_acc_wx + t351 * t355,
      t359 = limb3_upper_position_x * (limb3_U_0_cos * limb5_S_joint_acc_still_wz),
      t385 = limb3_U_0_sin * t139 + limb3_U_0_cos * t145,
      t380 = limb3_upper_position_x * (limb3_U_0_cos * limb5_S_joint_rate_wz - limb3_U_0_sin * limb5_S_joint_rate_wy),
      limb3_U_joint_rate_0 = limb5_S_joint_rate_wx - t351 * t380,
      t387 = limb3_upper_position_x * (limb3_U_joint_rate_0 * t385),
      t362 = limb3_U_0_sin * limb5_S_joint_rate_wz + limb3_U_0_cos * limb5_S_joint_rate_wy,
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin,
      limb3_upper_vel_y = limb3_S_arm_x * t362, t364 = limb3_lower_cos * t351,
      limb3_U_joint_rate_1 = limb3_upper_vel_y * t364;
    /* limb3: accelerations; velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t365 = minus_limb3_lower_sin * limb3_U_joint_rate_1, t366 = limb3_upper_offset_x * t365,
      t418 = t385 * (param_R * t365), limb3_S_arm_y = param_R * limb3_lower_cos,
      minus_limb3_P_joint_rate = limb3_S_arm_y * t362, t367 = limb3_lower_cos * minus_limb3_P_joint_rate - t366,
      t388 = t367 * limb3_U_joint_rate_0 + t387, t368 = t129 * t367, t370 = limb3_lower_cos * limb3_U_joint_rate_1,
      t428 = t385 * (minus_limb3_P_joint_rate - param_R * t370),
      t372 = minus_limb3_lower_sin * minus_limb3_P_joint_rate + limb3_upper_offset_x * t370,
      t375 = limb3_U_0_cos * t139 - limb3_U_0_sin * t145,
      limb3_U_joint_acc_0 = t357 - t351 * (t359 + (t368 + (t372 * t375 - t388))), t419 = t375 * limb3_U_joint_rate_0,
      limb3_lower_U_xz = limb3_lower_cos * limb3_U_joint_acc_0, limb3_U_0_rate_mz = k3 * limb3_U_joint_acc_0,
      minus_limb3_lower_omega_x = minus_limb3_lower_sin * limb3_U_joint_rate_0,
      limb3_lower_omega_y = limb3_lower_cos * limb3_U_joint_rate_0,
      limb3_lower_alpha_still_y = limb3_U_joint_rate_1 * minus_limb3_lower_omega_x,
      limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_lower_U_xz,
      minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y,
      minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y,
      t394 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y,
      minus_limb3_lower_rate_fz = limb_lower_mx * minus_limb3_lower_U_zx,
      t396 = gravity_z * limb3_U_0_sin - limb3_upper_offset_x * minus_limb3_lower_U_zx,
      limb3_upper_acc_z = t396 + minus_limb3_P_joint_rate * (2.0 * limb3_lower_omega_y);
    /* limb3: balance, eqs. (40)-(47); accelerations */
    const REAL t399 = limb3_upper_offset_x * (minus_limb3_lower_rate_fz + limb_lower_m * limb3_upper_acc_z),
      t401 = limb3_lower_cos * (gravity_z_limb_lower_mx * limb3_U_0_sin - t394 + (t399 - limb_lower_mx * limb3_upper_acc_z)),
      limb3_U_0_moment_z = limb3_U_0_rate_mz - (t401 + minus_limb3_lower_sin * (k10 * (limb3_U_joint_rate_1 * limb3_lower_omega_y))),
      minus_limb3_S_multiplier_fz = t351 * limb3_U_0_moment_z, t410 = limb3_lower_omega_y * limb3_lower_omega_y,
      t403 = limb3_S_arm_x * minus_limb3_S_multiplier_fz, t405 = limb3_S_arm_y * minus_limb3_S_multiplier_fz,
      t630 = limb3_lower_cos * t403, t407 = minus_limb3_lower_sin * t403 - limb3_lower_cos * t405,
      t646 = t630 + minus_limb3_lower_sin * t405 + t645, /* platform */
      t408 = limb3_U_0_cos * t407, t652 = limb3_U_0_sin * t407;
    /* limb3: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL t413 = limb3_U_0_sin * t254 + limb3_U_0_cos * minus_limb5_S_joint_acc_wy, t424 = limb3_S_arm_x * t413,
      t414 = limb3_S_arm_y * t413, t415 = limb3_U_0_sin * limb5_S_joint_acc_still_wz, t425 = limb3_S_arm_x * t415,
      limb3_P_joint_acc = t414 - (limb3_S_arm_y * t415 + (t418 + limb3_S_arm_y * t419)),
      t434 = t424 - (t425 - (t428 - (minus_limb3_P_joint_rate * limb3_U_joint_rate_1 + limb3_S_arm_x * t419))),
      minus_limb3_U_joint_acc_1 = t364 * t434,
      minus_limb3_lower_U_yx = minus_limb3_lower_U_still_xy + minus_limb3_U_joint_acc_1,
      t436 = k8 * minus_limb3_lower_U_still_xy + k9 * minus_limb3_U_joint_acc_1,
      t439 = limb3_upper_offset_x * minus_limb3_lower_U_yx,
      minus_limb3_lower_rate_fy = limb_lower_mx * minus_limb3_lower_U_yx, limb3_U_0_acc_y = gravity_z * limb3_U_0_cos,
      limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y,
      limb3_lower_rate_mz = limb_lower_mx * limb3_lower_acc_y - t436,
      limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y,
      minus_limb3_upper_acc_y = minus_limb3_P_joint_rate * (2.0 * limb3_U_joint_rate_1) - (limb3_lower_acc_y - t439),
      minus_limb3_lower_U_still_xx = limb3_U_joint_rate_1 * limb3_U_joint_rate_1 + t410,
      t441 = limb3_upper_offset_x * (minus_limb3_lower_rate_fy - limb_lower_m * minus_limb3_upper_acc_y),
      t443 = limb3_S_arm_x * (t364 * (limb3_lower_rate_mz + (t441 + limb_lower_mx * minus_limb3_upper_acc_y))),
      limb3_lower_force_x = limb_lower_m * (limb3_lower_acc_x - limb3_upper_offset_x * minus_limb3_lower_U_still_xx + limb3_P_joint_acc),
      t444 = limb3_S_arm_y * (limb_lower_mx * minus_limb3_lower_U_still_xx + limb3_lower_force_x) - t443;
    /* limb4: geometry; accelerations */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6),
      t625 = t408 - limb3_U_0_sin * t444 - t624, /* platform */
      t668 = t652 + limb3_U_0_cos * t444 + t667, /* platform */
      t257 = limb4_U_0_sin * t254 - minus_limb4_U_0_cos * limb5_S_joint_acc_wx,
      t316 = minus_limb4_U_0_cos * t254 + limb4_U_0_sin * limb5_S_joint_acc_wx,
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11), minus_limb4_lower_sin = SINES(sine, 7),
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      limb4_lower_cos = SINES(cosine, 7);
    /* limb4: accelerations; reciprocal wrenches, eq. (10); velocities, eq. (6) */
    const REAL t258 = limb4_upper_position_y * t257,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    checked2 = checked2 + minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t74 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz, t260 = minus_limb5_S_joint_acc_wy + t74 * t258,
      t262 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_joint_acc_still_wz),
      t318 = minus_limb4_U_0_cos * limb5_S_joint_acc_still_wz, t276 = minus_limb4_U_0_cos * t129,
      t288 = limb4_U_0_sin * t129 - minus_limb4_U_0_cos * t139, t278 = t276 + limb4_U_0_sin * t139,
      t263 = minus_limb4_U_0_cos * limb5_S_joint_rate_wz,
      t283 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_joint_rate_wz + minus_limb4_U_0_cos * limb5_S_joint_rate_wx),
      limb4_U_joint_rate_0 = limb5_S_joint_rate_wy + t74 * t283, t265 = t263 - limb4_U_0_sin * limb5_S_joint_rate_wx,
      t290 = limb4_upper_position_y * (limb4_U_joint_rate_0 * t288),
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      minus_limb4_upper_vel_y = limb4_S_arm_x * t265, t267 = limb4_lower_cos * t74,
      minus_limb4_U_joint_rate_1 = minus_limb4_upper_vel_y * t267,
      t268 = minus_limb4_lower_sin * minus_limb4_U_joint_rate_1, t269 = limb4_upper_offset_x * t268,
      t321 = t288 * (param_R * t268), limb4_S_arm_y = param_R * limb4_lower_cos,
      limb4_P_joint_rate = limb4_S_arm_y * t265, t270 = limb4_lower_cos * limb4_P_joint_rate - t269,
      t271 = t145 * t270, t291 = t270 * limb4_U_joint_rate_0 - t290,
      t273 = limb4_lower_cos * minus_limb4_U_joint_rate_1, t331 = t288 * (limb4_P_joint_rate - param_R * t273),
      t293 = t271 - ((minus_limb4_lower_sin * limb4_P_joint_rate + limb4_upper_offset_x * t273) * t278 + t291),
      minus_limb4_U_joint_acc_0 = t260 - t74 * (t262 + t293), t322 = t278 * limb4_U_joint_rate_0,
      minus_limb4_lower_U_xz = limb4_lower_cos * minus_limb4_U_joint_acc_0,
      minus_limb4_U_0_rate_mz = k3 * minus_limb4_U_joint_acc_0,
      minus_limb4_lower_omega_x = minus_limb4_lower_sin * limb4_U_joint_rate_0,
      limb4_lower_omega_y = limb4_lower_cos * limb4_U_joint_rate_0,
      minus_limb4_lower_alpha_still_y = minus_limb4_U_joint_rate_1 * minus_limb4_lower_omega_x,
      minus_limb4_lower_alpha_y = minus_limb4_lower_alpha_still_y + minus_limb4_lower_U_xz,
      minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y,
      limb4_lower_U_zx = minus_limb4_lower_alpha_still_y + minus_limb4_lower_alpha_y,
      t297 = k9 * minus_limb4_lower_alpha_still_y + k8 * minus_limb4_lower_alpha_y,
      limb4_lower_rate_fz = limb_lower_mx * limb4_lower_U_zx,
      t299 = gravity_z * minus_limb4_U_0_cos - limb4_upper_offset_x * limb4_lower_U_zx,
      minus_limb4_upper_acc_z = t299 + limb4_P_joint_rate * (2.0 * limb4_lower_omega_y);
    /* limb4: balance, eqs. (40)-(47); accelerations */
    const REAL t302 = limb4_upper_offset_x * (limb4_lower_rate_fz + limb_lower_m * minus_limb4_upper_acc_z),
      t303 = t302 - limb_lower_mx * minus_limb4_upper_acc_z,
      t304 = limb4_lower_cos * (gravity_z_limb_lower_mx * minus_limb4_U_0_cos - t297 + t303),
      minus_limb4_U_0_moment_z = minus_limb4_U_0_rate_mz - (t304 + minus_limb4_lower_sin * (k10 * (minus_limb4_U_joint_rate_1 * limb4_lower_omega_y))),
      limb4_S_multiplier_fz = t74 * minus_limb4_U_0_moment_z, t313 = limb4_lower_omega_y * limb4_lower_omega_y,
      t306 = limb4_S_arm_x * limb4_S_multiplier_fz, t308 = limb4_S_arm_y * limb4_S_multiplier_fz,
      t649 = limb4_lower_cos * t306, t310 = minus_limb4_lower_sin * t306 - limb4_lower_cos * t308,
      minus_platform_joint_force_my = t649 + minus_limb4_lower_sin * t308 + t668, t311 = limb4_U_0_sin * t310,
      t627 = minus_limb4_U_0_cos * t310;
    /* limb4: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL t327 = limb4_S_arm_x * t316, t328 = limb4_S_arm_x * t318,
      minus_limb4_P_joint_acc = limb4_S_arm_y * t316 - (limb4_S_arm_y * t318 + (t321 + limb4_S_arm_y * t322)),
      t337 = t327 - (t328 - (t331 + (limb4_P_joint_rate * minus_limb4_U_joint_rate_1 - limb4_S_arm_x * t322))),
      limb4_U_joint_acc_1 = t267 * t337, minus_limb4_lower_U_yx = minus_limb4_lower_U_still_xy - limb4_U_joint_acc_1,
      t339 = k8 * minus_limb4_lower_U_still_xy - k9 * limb4_U_joint_acc_1,
      t342 = limb4_upper_offset_x * minus_limb4_lower_U_yx,
      minus_limb4_lower_rate_fy = limb_lower_mx * minus_limb4_lower_U_yx,
      minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y,
      minus_limb4_lower_rate_mz = limb_lower_mx * minus_limb4_lower_acc_y + t339,
      minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y,
      minus_limb4_upper_acc_y = limb4_P_joint_rate * (2.0 * minus_limb4_U_joint_rate_1) + (minus_limb4_lower_acc_y + t342),
      minus_limb4_lower_U_still_xx = minus_limb4_U_joint_rate_1 * minus_limb4_U_joint_rate_1 + t313,
      t344 = limb4_upper_offset_x * (minus_limb4_lower_rate_fy - limb_lower_m * minus_limb4_upper_acc_y),
      t346 = limb4_S_arm_x * (t267 * (minus_limb4_lower_rate_mz - (t344 + limb_lower_mx * minus_limb4_upper_acc_y))),
      minus_limb4_upper_acc_x = minus_limb4_lower_acc_x + limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_P_joint_acc,
      t325 = limb4_S_arm_y * (limb_lower_mx * minus_limb4_lower_U_still_xx - limb_lower_m * minus_limb4_upper_acc_x),
      t347 = t325 + t346;
    /* limb5_S: balance, eqs. (40)-(47); drives */
    const REAL platform_joint_force_mz = t311 + minus_limb4_U_0_cos * t347 + t625,
      platform_joint_force_mx = t627 - limb4_U_0_sin * t347 + t646, t45 = limb1_lower_sin * t21, /* limb1 */
      t26 = limb1_lower_cos * t21 + limb1_lower_sin * t24, /* limb1 */
      platform_joint_force_mx_by_limb1_U2_mn = t45 - limb1_lower_cos * t24,
      platform_joint_force_mz_by_limb1_U2_mn = limb1_U_0_cos * t26 + t41;
    checked3 = checked3 + platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t42 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      minus_limb1_U2_part_mn = t42 * platform_joint_force_mz, t39 = limb1_U_0_sin * t26 - t38,
      minus_limb5_S_balance_wx = platform_joint_force_mx_by_limb1_U2_mn * minus_limb1_U2_part_mn - platform_joint_force_mx,
      limb5_S_balance_wy = t39 * minus_limb1_U2_part_mn - minus_platform_joint_force_my,
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
      minus_limb5_S_balance_wy_by_limb4_P = limb1_U2_part_mn_by_limb4_P * t39,
      limb5_S_balance_wx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y + t47;
    /* limb5_S: drives; pivots */
    const REAL minus_drives_share_0_1 = limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P + t57,
      t647 = minus_drives_share_0_1 * minus_limb5_S_balance_wx, /* limb1 */
      t67 = minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wx_by_limb2_P,
      t69 = t67 + limb5_S_balance_wx_by_limb1_P * limb5_S_balance_wx_by_limb1_P,
      t70 = minus_limb5_S_balance_wx_by_limb3_P * minus_limb5_S_balance_wx_by_limb3_P + t69,
      drives_share_0_0 = limb5_S_balance_wx_by_limb4_P * limb5_S_balance_wx_by_limb4_P + t70,
      t670 = t647 - drives_share_0_0 * limb5_S_balance_wy, /* limb1 */
      t673 = minus_drives_share_0_1 * limb5_S_balance_wy, /* limb1 */
      t58 = minus_drives_share_0_1 * minus_drives_share_0_1,
      t62 = minus_limb5_S_balance_wy_by_limb1_P * minus_limb5_S_balance_wy_by_limb1_P,
      t63 = limb5_S_balance_wy_by_limb2_P * limb5_S_balance_wy_by_limb2_P + t62,
      t64 = limb5_S_balance_wy_by_limb3_P * limb5_S_balance_wy_by_limb3_P + t63,
      drives_share_1_1 = minus_limb5_S_balance_wy_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P + t64,
      minus_determinant = t58 - drives_share_1_1 * drives_share_0_0;
    checked0 = checked0 + minus_determinant;
    const REAL t675 = t673 - drives_share_1_1 * minus_limb5_S_balance_wx, /* limb1 */
      t72 = 1.0 / minus_determinant, t671 = t72 * t670, /* limb1 */
      t676 = t72 * t675; /* limb1 */
    RESULT(checked1, u, 0, minus_limb5_S_balance_wy_by_limb1_P * t671 + limb5_S_balance_wx_by_limb1_P * t676);
    RESULT(checked2, u, 1, -(limb5_S_balance_wy_by_limb2_P * t671 + minus_limb5_S_balance_wx_by_limb2_P * t676));
    const REAL t682 = minus_limb5_S_balance_wy_by_limb4_P * t671; /* limb4 */
    RESULT(checked3, u, 2, -(limb5_S_balance_wy_by_limb3_P * t671 + minus_limb5_S_balance_wx_by_limb3_P * t676));
    RESULT(checked0, u, 3, t682 + limb5_S_balance_wx_by_limb4_P * t676);
    /* else status 5: no rotation */
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(a_pivot_2, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(minus_determinant, 2.393867125597279e-10), /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_inverse_dynamics_preload)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict a, const double *restrict weights,
    const double *restrict preload, double *restrict u, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    /* limb1: geometry; accelerations; balance, eqs. (40)-(47) */
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1),
      limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin, limb1_U_v_1 = READ(v, 1),
      minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x, limb1_U_a_0 = READ(a, 0),
      limb1_lower_cos = SINES(cosine, 1),
      minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_U_a_0 * limb1_lower_cos,
      limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y,
      t205 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_rate_fz = limb_lower_mx * limb1_lower_U_zx,
      t200 = limb1_upper_offset_x * limb1_lower_U_zx + gravity_z * limb1_U_0_sin,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos,
      limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y, limb1_P_v = READ(v, 2),
      minus_limb1_upper_acc_z = limb1_P_v * (2.0 * limb1_lower_omega_y) - t200,
      t201 = limb1_upper_offset_x * (limb_lower_m * minus_limb1_upper_acc_z + limb1_lower_rate_fz),
      minus_limb1_lower_moment_y = limb_lower_mx * minus_limb1_upper_acc_z - t201 + (gravity_z_limb_lower_mx * limb1_U_0_sin + t205),
      t206 = limb1_lower_cos * minus_limb1_lower_moment_y, t213 = limb1_lower_omega_y * limb1_lower_omega_y,
      limb1_U_0_moment_z = limb1_lower_sin * (k10 * (limb1_U_v_1 * limb1_lower_omega_y)) - t206 + k3 * limb1_U_a_0,
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t20 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    /* limb1: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); accelerations */
    const REAL minus_limb1_U2_part_fz = t20 * limb1_U_0_moment_z, minus_limb1_U2_arm_y = param_R * limb1_lower_cos,
      t207 = minus_limb1_U2_arm_y * minus_limb1_U2_part_fz, t208 = limb1_lower_cos * t207,
      t245 = limb1_lower_sin * t207, limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      t209 = limb1_U2_arm_x * minus_limb1_U2_part_fz, t211 = t208 - limb1_lower_sin * t209,
      limb1_U_0_cos = SINES(cosine, 0), limb1_U_a_1 = READ(a, 1), t247 = t245 + limb1_lower_cos * t209,
      t212 = limb1_U_0_cos * t211, t288 = limb1_U_0_sin * t211,
      limb1_lower_U_yx = limb1_U_a_1 + limb1_lower_U_still_xy, t222 = k8 * limb1_lower_U_still_xy,
      t218 = limb1_upper_offset_x * limb1_lower_U_yx, limb1_lower_rate_fy = limb_lower_mx * limb1_lower_U_yx,
      limb1_U_0_acc_y = gravity_z * limb1_U_0_cos, minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y,
      limb1_upper_moment_z = limb_lower_mx * minus_limb1_lower_acc_y,
      limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y,
      limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) + (t218 - minus_limb1_lower_acc_y),
      t220 = limb1_upper_offset_x * (limb_lower_m * limb1_upper_acc_y - limb1_lower_rate_fy),
      minus_limb1_lower_moment_z = limb_lower_mx * limb1_upper_acc_y - t220 + (limb1_upper_moment_z - (t222 + k9 * limb1_U_a_1)),
      t37 = limb1_lower_cos * t20, t225 = limb1_U2_arm_x * (minus_limb1_lower_moment_z * t37),
      minus_limb1_lower_U_still_xx = t213 + limb1_U_v_1 * limb1_U_v_1,
      limb1_lower_force_x = limb_lower_m * (READ(a, 2) - (limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x)),
      t226 = minus_limb1_U2_arm_y * (limb_lower_mx * minus_limb1_lower_U_still_xx + limb1_lower_force_x) - t225;
    /* limb5_S: geometry; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13),
      t228 = t212 + limb1_U_0_sin * t226, /* limb1 */
      t290 = t288 - limb1_U_0_cos * t226, /* limb1 */
      t3 = limb5_S_q_qw * limb5_S_q_qw, t4 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t5 = t3 + t4,
      t6 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t7 = limb5_S_q_qz * limb5_S_q_qz, t8 = t6 + t7,
      t9 = t5 + t8, t11 = 4.0 - 2.0 * t9, platform_turn_zz = 1.0 - t11 * (t4 + t6),
      platform_turn_yy = 1.0 - t11 * (t4 + t7), platform_turn_xx = 1.0 - t8 * t11, t15 = limb5_S_q_qz * t11,
      t16 = limb5_S_q_qy * t15, t18 = limb5_S_q_qw * (limb5_S_q_qx * t11), t33 = limb5_S_q_qy * t11,
      platform_turn_zy = t16 + t18, limb5_S_v_wz = READ(v, 14), platform_turn_yz = t16 - t18,
      minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      minus_platform_rate_mx = minus_platform_moment_x - (k12 * (READ(v, 13) * limb5_S_v_wz) + k13 * READ(a, 12)),
      t240 = platform_turn_xx * minus_platform_rate_mx, t181 = limb5_S_q_qx * t15, t35 = limb5_S_q_qw * t15,
      t182 = limb5_S_q_qw * t33, t34 = limb5_S_q_qx * t33, platform_turn_zx = t181 - t182,
      platform_turn_xz = t181 + t182, t186 = platform_turn_zx * minus_platform_rate_mx,
      platform_moment_y = gravity_z_platform_mz * platform_turn_zx,
      platform_rate_my = platform_moment_y - (k12 * (READ(v, 12) * limb5_S_v_wz) - k13 * READ(a, 13)),
      t191 = t186 - platform_turn_zy * platform_rate_my, platform_rate_mz = platform_Izz * READ(a, 14);
    /* limb2: velocities, eq. (6); geometry; accelerations */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3),
      t229 = t191 - platform_turn_zz * platform_rate_mz - t228, /* platform */
      t243 = platform_turn_xz * platform_rate_mz, /* platform */
      t286 = platform_turn_yz * platform_rate_mz, /* platform */
      limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin, limb2_U_v_1 = READ(v, 4),
      minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x, limb2_U_a_0 = READ(a, 3),
      limb2_lower_cos = SINES(cosine, 3),
      minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y - limb2_U_a_0 * limb2_lower_cos,
      limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y,
      t155 = k9 * minus_limb2_lower_alpha_still_y + k8 * minus_limb2_lower_alpha_y,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5), minus_limb2_U_0_cos = SINES(sine, 2),
      limb2_lower_rate_fz = limb_lower_mx * limb2_lower_U_zx,
      t150 = limb2_upper_offset_x * limb2_lower_U_zx - gravity_z * minus_limb2_U_0_cos,
      limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos,
      limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y, limb2_P_v = READ(v, 5),
      minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) - t150;
    /* limb2: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t151 = limb2_upper_offset_x * (limb_lower_m * minus_limb2_upper_acc_z + limb2_lower_rate_fz),
      t152 = limb_lower_mx * minus_limb2_upper_acc_z - t151,
      t156 = limb2_lower_cos * (t152 - (gravity_z_limb_lower_mx * minus_limb2_U_0_cos - t155)),
      t164 = limb2_lower_omega_y * limb2_lower_omega_y,
      limb2_U_0_moment_z = limb2_lower_sin * (k10 * (limb2_U_v_1 * limb2_lower_omega_y)) - t156 + k3 * limb2_U_a_0,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t145 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      minus_limb2_S_multiplier_fz = t145 * limb2_U_0_moment_z, t176 = limb2_lower_cos * t145,
      minus_limb2_S_arm_y = param_R * limb2_lower_cos, t157 = minus_limb2_S_arm_y * minus_limb2_S_multiplier_fz,
      t158 = limb2_lower_cos * t157, t280 = limb2_lower_sin * t157,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin,
      t160 = limb2_S_arm_x * minus_limb2_S_multiplier_fz, t162 = t158 - limb2_lower_sin * t160,
      limb2_U_0_sin = SINES(cosine, 2), limb2_U_a_1 = READ(a, 4), t282 = t280 + limb2_lower_cos * t160,
      t163 = limb2_U_0_sin * t162, t249 = minus_limb2_U_0_cos * t162,
      limb2_lower_U_yx = limb2_U_a_1 + limb2_lower_U_still_xy, t173 = k8 * limb2_lower_U_still_xy,
      t169 = limb2_upper_offset_x * limb2_lower_U_yx, limb2_lower_rate_fy = limb_lower_mx * limb2_lower_U_yx,
      minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin, limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y,
      minus_limb2_upper_moment_z = limb_lower_mx * limb2_lower_acc_y,
      minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y,
      limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + (t169 + limb2_lower_acc_y),
      t171 = limb2_upper_offset_x * (limb_lower_m * limb2_upper_acc_y - limb2_lower_rate_fy),
      t172 = limb_lower_mx * limb2_upper_acc_y - t171,
      t177 = limb2_S_arm_x * ((t172 - (minus_limb2_upper_moment_z + (t173 + k9 * limb2_U_a_1))) * t176),
      minus_limb2_lower_U_still_xx = t164 + limb2_U_v_1 * limb2_U_v_1,
      limb2_lower_force_x = limb_lower_m * (READ(a, 5) - (limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x)),
      t178 = minus_limb2_S_arm_y * (limb_lower_mx * minus_limb2_lower_U_still_xx + limb2_lower_force_x) - t177;
    /* limb3: velocities, eq. (6); geometry; accelerations */
    const REAL limb3_U_v_0 = READ(v, 6), minus_limb3_lower_sin = SINES(sine, 5),
      t230 = t163 + minus_limb2_U_0_cos * t178 + t229, /* platform */
      t251 = t249 - limb2_U_0_sin * t178, /* limb2 */
      minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin, limb3_U_v_1 = READ(v, 7),
      limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x, limb3_U_a_0 = READ(a, 6),
      limb3_lower_cos = SINES(cosine, 5),
      limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_U_a_0 * limb3_lower_cos,
      minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y,
      t119 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), limb3_U_0_sin = SINES(sine, 4),
      minus_limb3_lower_rate_fz = limb_lower_mx * minus_limb3_lower_U_zx,
      t114 = limb3_upper_offset_x * minus_limb3_lower_U_zx - gravity_z * limb3_U_0_sin,
      limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos,
      minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y, limb3_P_v = READ(v, 8),
      minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) + t114;
    /* limb3: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t115 = limb3_upper_offset_x * (limb_lower_m * minus_limb3_upper_acc_z - minus_limb3_lower_rate_fz),
      minus_limb3_lower_moment_y = limb_lower_mx * minus_limb3_upper_acc_z - t115 + (gravity_z_limb_lower_mx * limb3_U_0_sin - t119),
      t120 = limb3_lower_cos * minus_limb3_lower_moment_y, t128 = limb3_lower_omega_y * limb3_lower_omega_y,
      minus_limb3_U_0_moment_z = minus_limb3_lower_sin * (k10 * (limb3_U_v_1 * limb3_lower_omega_y)) + t120 - k3 * limb3_U_a_0,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t109 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      limb3_S_multiplier_fz = t109 * minus_limb3_U_0_moment_z, t140 = limb3_lower_cos * t109,
      limb3_S_arm_y = param_R * limb3_lower_cos, t121 = limb3_S_arm_y * limb3_S_multiplier_fz,
      t122 = limb3_lower_cos * t121, t236 = minus_limb3_lower_sin * t121,
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin,
      t124 = limb3_S_arm_x * limb3_S_multiplier_fz, t126 = t122 - minus_limb3_lower_sin * t124,
      limb3_U_0_cos = SINES(cosine, 4), limb3_U_a_1 = READ(a, 7), t238 = t236 + limb3_lower_cos * t124,
      t127 = limb3_U_0_cos * t126, t277 = limb3_U_0_sin * t126,
      limb3_lower_U_yx = limb3_U_a_1 - minus_limb3_lower_U_still_xy, t137 = k8 * minus_limb3_lower_U_still_xy,
      t133 = limb3_upper_offset_x * limb3_lower_U_yx, limb3_lower_rate_fy = limb_lower_mx * limb3_lower_U_yx,
      limb3_U_0_acc_y = gravity_z * limb3_U_0_cos, limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y,
      minus_limb3_upper_moment_z = limb_lower_mx * limb3_lower_acc_y,
      limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y,
      limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + (t133 + limb3_lower_acc_y),
      t135 = limb3_upper_offset_x * (limb_lower_m * limb3_upper_acc_y - limb3_lower_rate_fy),
      t136 = limb_lower_mx * limb3_upper_acc_y - t135,
      t141 = limb3_S_arm_x * ((t136 - (minus_limb3_upper_moment_z - (t137 - k9 * limb3_U_a_1))) * t140),
      minus_limb3_lower_U_still_xx = t128 + limb3_U_v_1 * limb3_U_v_1,
      limb3_lower_force_x = limb_lower_m * (READ(a, 8) - (limb3_upper_offset_x * minus_limb3_lower_U_still_xx - limb3_lower_acc_x)),
      t142 = limb3_S_arm_y * (limb_lower_mx * minus_limb3_lower_U_still_xx + limb3_lower_force_x) + t141;
    /* limb4: velocities, eq. (6); geometry; accelerations */
    const REAL limb4_U_v_0 = READ(v, 9), minus_limb4_lower_sin = SINES(sine, 7),
      t231 = t127 - limb3_U_0_sin * t142 - t230, /* platform */
      t279 = t277 + limb3_U_0_cos * t142, /* limb3 */
      minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin, limb4_U_v_1 = READ(v, 10),
      limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x, limb4_U_a_0 = READ(a, 9),
      limb4_lower_cos = SINES(cosine, 7),
      limb4_lower_alpha_y = limb4_lower_alpha_still_y + limb4_U_a_0 * limb4_lower_cos,
      minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y,
      t83 = k9 * limb4_lower_alpha_still_y + k8 * limb4_lower_alpha_y,
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11), minus_limb4_U_0_cos = SINES(sine, 6),
      minus_limb4_lower_rate_fz = limb_lower_mx * minus_limb4_lower_U_zx,
      t78 = limb4_upper_offset_x * minus_limb4_lower_U_zx + gravity_z * minus_limb4_U_0_cos,
      limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos,
      minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y, limb4_P_v = READ(v, 11),
      minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + t78;
    /* limb4: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const REAL t79 = limb4_upper_offset_x * (limb_lower_m * minus_limb4_upper_acc_z - minus_limb4_lower_rate_fz),
      t80 = limb_lower_mx * minus_limb4_upper_acc_z - t79,
      t84 = limb4_lower_cos * (t80 - (gravity_z_limb_lower_mx * minus_limb4_U_0_cos + t83)),
      t92 = limb4_lower_omega_y * limb4_lower_omega_y,
      minus_limb4_U_0_moment_z = minus_limb4_lower_sin * (k10 * (limb4_U_v_1 * limb4_lower_omega_y)) + t84 - k3 * limb4_U_a_0,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked3 = minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t73 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_S_multiplier_fz = t73 * minus_limb4_U_0_moment_z, t104 = limb4_lower_cos * t73,
      limb4_S_arm_y = param_R * limb4_lower_cos, t85 = limb4_S_arm_y * limb4_S_multiplier_fz,
      t86 = limb4_lower_cos * t85, t274 = minus_limb4_lower_sin * t85,
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      t88 = limb4_S_arm_x * limb4_S_multiplier_fz, t90 = t86 - minus_limb4_lower_sin * t88,
      limb4_U_0_sin = SINES(cosine, 6), limb4_U_a_1 = READ(a, 10), t276 = t274 + limb4_lower_cos * t88,
      t91 = limb4_U_0_sin * t90, t233 = minus_limb4_U_0_cos * t90,
      limb4_lower_U_yx = limb4_U_a_1 - minus_limb4_lower_U_still_xy, t101 = k8 * minus_limb4_lower_U_still_xy,
      t97 = limb4_upper_offset_x * limb4_lower_U_yx, limb4_lower_rate_fy = limb_lower_mx * limb4_lower_U_yx,
      minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y,
      limb4_upper_moment_z = limb_lower_mx * minus_limb4_lower_acc_y,
      minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y,
      limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) + (t97 - minus_limb4_lower_acc_y),
      t99 = limb4_upper_offset_x * (limb_lower_m * limb4_upper_acc_y - limb4_lower_rate_fy),
      minus_limb4_lower_moment_z = limb_lower_mx * limb4_upper_acc_y - t99 + (limb4_upper_moment_z + (t101 - k9 * limb4_U_a_1)),
      t105 = limb4_S_arm_x * (minus_limb4_lower_moment_z * t104),
      minus_limb4_lower_U_still_xx = t92 + limb4_U_v_1 * limb4_U_v_1,
      limb4_upper_acc_x = READ(a, 11) - (limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_lower_acc_x),
      t94 = limb4_S_arm_y * (limb_lower_mx * minus_limb4_lower_U_still_xx + limb_lower_m * limb4_upper_acc_x),
      t106 = t94 + t105, minus_platform_joint_force_mz = t91 - minus_limb4_U_0_cos * t106 - t231,
      t235 = t233 + limb4_U_0_sin * t106;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; balance, eqs. (40)-(47) */
    const REAL t30 = limb1_U_0_cos * platform_turn_zy,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t20,
      t22 = limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3,
      t25 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3, t49 = limb1_lower_sin * t22,
      t27 = limb1_lower_cos * t22 + limb1_lower_sin * t25,
      platform_joint_force_mx_by_limb1_U2_mn = t49 - limb1_lower_cos * t25, t41 = limb1_U_0_cos * t27,
      t28 = limb1_U_0_sin * t27, t32 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - t30);
    /* platform: balance, eqs. (40)-(47); geometry; drives */
    const REAL t284 = platform_turn_yy * platform_rate_my, platform_turn_xy = t34 - t35,
      t292 = t282 - ((t34 + t35) * minus_platform_rate_mx - t284 - t286 + t290),
      minus_platform_joint_force_my = t276 + (t279 - t292),
      t253 = t238 + (t240 - platform_turn_xy * platform_rate_my - t243 - t247 + t251),
      minus_platform_joint_force_mx = t235 + t253,
      limb1_U2_constraint_mn_couple_z = t32 - limb1_lower_sin * platform_turn_xy,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * (limb1_U2_constraint_mn_couple_z * t37),
      platform_joint_force_mz_by_limb1_U2_mn = t41 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    checked0 = checked0 + platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t43 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      limb1_U2_part_mn = t43 * minus_platform_joint_force_mz,
      t40 = t28 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb5_S_balance_wx = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn - minus_platform_joint_force_mx,
      minus_limb5_S_balance_wy = t40 * limb1_U2_part_mn + minus_platform_joint_force_my,
      minus_limb1_U2_part_mn_by_limb2_P = minus_limb2_U_0_cos * minus_limb2_S_arm_y * t43,
      minus_platform_joint_force_mx_by_limb2_P = limb2_U_0_sin * minus_limb2_S_arm_y,
      minus_limb5_S_balance_wx_by_limb2_P = minus_platform_joint_force_mx_by_limb2_P + platform_joint_force_mx_by_limb1_U2_mn * minus_limb1_U2_part_mn_by_limb2_P,
      limb5_S_balance_wy_by_limb2_P = t40 * minus_limb1_U2_part_mn_by_limb2_P, limb2_P_preload = READ(preload, 1),
      t68 = limb2_P_preload * minus_limb5_S_balance_wx_by_limb2_P, /* limb1 */
      limb1_U2_part_mn_by_limb1_P = limb1_U_0_sin * minus_limb1_U2_arm_y * t43,
      minus_platform_joint_force_my_by_limb1_P = limb1_U_0_cos * minus_limb1_U2_arm_y,
      limb5_S_balance_wx_by_limb1_P = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn_by_limb1_P,
      minus_limb5_S_balance_wy_by_limb1_P = minus_platform_joint_force_my_by_limb1_P + t40 * limb1_U2_part_mn_by_limb1_P,
      limb1_P_preload = READ(preload, 0), t70 = t68 - limb1_P_preload * limb5_S_balance_wx_by_limb1_P, /* limb1 */
      minus_limb1_U2_part_mn_by_limb3_P = limb3_U_0_sin * limb3_S_arm_y * t43,
      platform_joint_force_my_by_limb3_P = limb3_U_0_cos * limb3_S_arm_y,
      minus_limb5_S_balance_wx_by_limb3_P = platform_joint_force_mx_by_limb1_U2_mn * minus_limb1_U2_part_mn_by_limb3_P,
      limb5_S_balance_wy_by_limb3_P = platform_joint_force_my_by_limb3_P + t40 * minus_limb1_U2_part_mn_by_limb3_P,
      limb3_P_preload = READ(preload, 2),
      t71 = limb3_P_preload * minus_limb5_S_balance_wx_by_limb3_P + t70, /* limb1 */
      limb1_U2_part_mn_by_limb4_P = minus_limb4_U_0_cos * limb4_S_arm_y * t43,
      t51 = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn_by_limb4_P,
      minus_limb5_S_balance_wy_by_limb4_P = limb1_U2_part_mn_by_limb4_P * t40,
      limb5_S_balance_wx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y + t51, limb4_P_preload = READ(preload, 3),
      t254 = limb4_P_preload * limb5_S_balance_wx_by_limb4_P - t71 + limb5_S_balance_wx, /* limb1 */
      limb1_P_weights = READ(weights, 0);
    checked1 = checked1 + limb1_P_weights;
    const REAL t1 = 1.0 / limb1_P_weights, /* limb1 */
      t45 = t1 * minus_limb5_S_balance_wy_by_limb1_P, t262 = t1 * limb5_S_balance_wx_by_limb1_P,
      limb2_P_weights = READ(weights, 1);
    checked2 = checked2 + limb2_P_weights;
    /* drives: drives; pivots */
    const REAL t63 = t45 * limb5_S_balance_wx_by_limb1_P, t263 = limb5_S_balance_wx_by_limb1_P * t262,
      t58 = 1.0 / limb2_P_weights, /* limb2 */
      t60 = t58 * limb5_S_balance_wy_by_limb2_P, t260 = t58 * minus_limb5_S_balance_wx_by_limb2_P,
      limb3_P_weights = READ(weights, 2);
    checked3 = checked3 + limb3_P_weights;
    const REAL t64 = t60 * minus_limb5_S_balance_wx_by_limb2_P + t63,
      t264 = minus_limb5_S_balance_wx_by_limb2_P * t260 + t263, t53 = 1.0 / limb3_P_weights, /* limb3 */
      t56 = t53 * limb5_S_balance_wy_by_limb3_P, t258 = t53 * minus_limb5_S_balance_wx_by_limb3_P,
      limb4_P_weights = READ(weights, 3);
    checked0 = checked0 + limb4_P_weights;
    const REAL t65 = t56 * minus_limb5_S_balance_wx_by_limb3_P + t64,
      t265 = minus_limb5_S_balance_wx_by_limb3_P * t258 + t264, t46 = 1.0 / limb4_P_weights, /* limb4 */
      t48 = t46 * minus_limb5_S_balance_wy_by_limb4_P, t256 = t46 * limb5_S_balance_wx_by_limb4_P,
      minus_drives_share_1_0 = t48 * limb5_S_balance_wx_by_limb4_P + t65,
      drives_share_0_0 = limb5_S_balance_wx_by_limb4_P * t256 + t265,
      t255 = minus_drives_share_1_0 * t254, /* limb1 */
      t269 = limb1_P_preload * minus_limb5_S_balance_wy_by_limb1_P, /* limb1 */
      t270 = limb2_P_preload * limb5_S_balance_wy_by_limb2_P - t269, /* limb1 */
      t302 = limb5_S_balance_wy_by_limb2_P * t60 + minus_limb5_S_balance_wy_by_limb1_P * t45,
      t271 = limb3_P_preload * limb5_S_balance_wy_by_limb3_P + t270, /* limb1 */
      t303 = limb5_S_balance_wy_by_limb3_P * t56 + t302,
      t294 = limb4_P_preload * minus_limb5_S_balance_wy_by_limb4_P - t271 + minus_limb5_S_balance_wy, /* limb1 */
      drives_share_1_1 = minus_limb5_S_balance_wy_by_limb4_P * t48 + t303,
      t296 = t255 - drives_share_0_0 * t294, /* limb1 */
      t310 = minus_drives_share_1_0 * t294 - drives_share_1_1 * t254, /* limb1 */
      minus_determinant = minus_drives_share_1_0 * minus_drives_share_1_0 - drives_share_1_1 * drives_share_0_0;
    checked1 = checked1 + minus_determinant;
    const REAL t305 = 1.0 / minus_determinant, t306 = t296 * t305, /* limb1 */
      t311 = t305 * t310; /* limb1 */
    RESULT(checked2, u, 0, limb1_P_preload - (t45 * t306 + t262 * t311));
    RESULT(checked3, u, 1, limb2_P_preload + (t60 * t306 + t260 * t311));
    const REAL t320 = t48 * t306; /* limb4 */
    RESULT(checked0, u, 2, limb3_P_preload + (t56 * t306 + t258 * t311));
    RESULT(checked1, u, 3, limb4_P_preload - (t320 + t256 * t311));
    /* else status 5: no rotation */
    NOT_BELOW(t9, 0.999999, 5);
    NOT_ABOVE(t9, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.3211e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.4044e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.284e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.233100000000001e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
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
    const REAL limb5_S_pose_qw = READ(pose, 0), limb5_S_pose_qx = READ(pose, 1),
      t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx, limb5_S_pose_qy = READ(pose, 2),
      t3 = t1 + t2, t4 = limb5_S_pose_qy * limb5_S_pose_qy, limb5_S_pose_qz = READ(pose, 3),
      t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7, t37 = t2 + t5,
      platform_turn_zz = 1.0 - t9 * (t2 + t4), platform_turn_xx = 1.0 - t6 * t9, platform_turn_yy = 1.0 - t9 * t37,
      t12 = limb5_S_pose_qy * t9, t21 = limb5_S_pose_qx * t12, t13 = limb5_S_pose_qw * t12,
      t10 = limb5_S_pose_qz * t9, t26 = limb5_S_pose_qw * (limb5_S_pose_qx * t9), t22 = limb5_S_pose_qw * t10,
      platform_turn_yx = t21 + t22, platform_turn_xy = t21 - t22, t23 = 0.5 * platform_turn_yx,
      t24 = limb5_S_pose_qy * t10, t11 = limb5_S_pose_qx * t10, platform_turn_yz = t24 - t26,
      platform_turn_zy = t24 + t26, t27 = param_H * platform_turn_yz, minus_limb1_lower_limb_target_x = t23 - t27,
      limb3_lower_limb_target_x = t23 + t27,
      t28 = minus_limb1_lower_limb_target_x * minus_limb1_lower_limb_target_x, /* limb1 */
      platform_turn_zx = t11 - t13, platform_turn_xz = t11 + t13, t14 = 0.5 * platform_turn_zx,
      t17 = param_H * platform_turn_zz, minus_limb1_lower_limb_target_y = t14 - t17,
      limb3_lower_limb_target_y = t14 + t17,
      t30 = t28 + minus_limb1_lower_limb_target_y * minus_limb1_lower_limb_target_y, /* limb1 */
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = SQRT(t30),
      t35 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, /* limb1 */
      limb1_U_0_sin = minus_limb1_lower_limb_target_x * t35, limb5_S_rate_wx = READ(rate, 0),
      limb5_S_rate_wy = READ(rate, 1), limb5_S_rate_wz = READ(rate, 2),
      t155 = limb5_S_rate_wx * platform_turn_zx + limb5_S_rate_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_rate_wz * platform_turn_zz + t155, t20 = param_H * platform_turn_xz,
      t19 = 0.5 * platform_turn_xx, minus_limb1_upper_position_x = t19 - t20, limb3_upper_position_x = t19 + t20;
    /* limb1: loop closure; geometry; accelerations */
    const REAL t156 = minus_limb1_upper_position_x * platform_twist_wz,
      t159 = limb5_S_rate_wx * platform_turn_xx + limb5_S_rate_wy * platform_turn_xy, /* platform */
      platform_twist_wx = t159 + limb5_S_rate_wz * platform_turn_xz,
      t162 = t156 - minus_limb1_lower_limb_target_y * platform_twist_wx, t163 = t162 * limb1_U_0_sin,
      minus_limb1_U_0_cos = minus_limb1_lower_limb_target_y * t35, t182 = t162 * minus_limb1_U_0_cos,
      t164 = minus_limb1_lower_limb_target_x * platform_twist_wx,
      t167 = limb5_S_rate_wy * platform_turn_yy + limb5_S_rate_wx * platform_turn_yx, /* platform */
      platform_twist_wy = t167 + limb5_S_rate_wz * platform_turn_yz,
      t170 = t164 - minus_limb1_upper_position_x * platform_twist_wy, t172 = t163 + t170 * minus_limb1_U_0_cos,
      minus_limb1_U_0_omega_z = t35 * (t182 - t170 * limb1_U_0_sin),
      limb1_lower_limb_target_z = param_R - minus_limb1_upper_position_x,
      limb1_lower_limb_length = SQRT(t30 + limb1_lower_limb_target_z * limb1_lower_limb_target_z),
      t33 = 1.0 / limb1_lower_limb_length, limb1_lower_sin = limb1_lower_limb_target_z * t33,
      limb1_lower_cos = minus_limb1_U_0_lever_mz_by_limb1_U2_fz * t33, t178 = limb1_lower_sin * t172,
      t173 = limb1_lower_cos * t172, t174 = minus_limb1_lower_limb_target_y * platform_twist_wy,
      t176 = t174 - minus_limb1_lower_limb_target_x * platform_twist_wz,
      minus_limb1_lower_omega_z = t33 * (t178 + t176 * limb1_lower_cos),
      minus_limb1_U2_opening_rate_fx = t173 - t176 * limb1_lower_sin,
      minus_limb1_lower_omega_x = limb1_lower_sin * minus_limb1_U_0_omega_z,
      minus_limb1_lower_omega_y = limb1_lower_cos * minus_limb1_U_0_omega_z,
      minus_limb1_lower_alpha_y = minus_limb1_lower_omega_z * minus_limb1_lower_omega_x,
      limb1_lower_U_xy = minus_limb1_lower_omega_x * minus_limb1_lower_omega_y,
      t254 = limb1_lower_limb_length * (2.0 * minus_limb1_lower_alpha_y),
      t253 = minus_limb1_U2_opening_rate_fx * (2.0 * minus_limb1_lower_omega_y), limb1_upper_acc_z = t254 + t253;
    /* platform: accelerations; loop closure; momentum rate, eq. (35) */
    const REAL t185 = limb5_S_rate_wy * limb5_S_rate_wy, t186 = limb5_S_rate_wz * limb5_S_rate_wz,
      minus_platform_U_still_xx = t185 + t186, t187 = platform_turn_yx * minus_platform_U_still_xx,
      platform_U_still_xy = limb5_S_rate_wx * limb5_S_rate_wy, limb5_S_acc_wz = READ(acceleration, 2),
      platform_U_yx = limb5_S_acc_wz + platform_U_still_xy,
      minus_platform_U_xy = limb5_S_acc_wz - platform_U_still_xy, t189 = t187 - platform_turn_yy * platform_U_yx,
      platform_U_still_xz = limb5_S_rate_wx * limb5_S_rate_wz, limb5_S_acc_wy = READ(acceleration, 1),
      minus_platform_U_zx = limb5_S_acc_wy - platform_U_still_xz,
      t192 = 0.5 * (t189 + platform_turn_yz * minus_platform_U_zx),
      platform_U_xz = limb5_S_acc_wy + platform_U_still_xz, t145 = k12 * platform_U_still_xz,
      t193 = platform_turn_yx * platform_U_xz, platform_U_still_yz = limb5_S_rate_wy * limb5_S_rate_wz,
      limb5_S_acc_wx = READ(acceleration, 0), minus_platform_U_yz = limb5_S_acc_wx - platform_U_still_yz,
      t195 = t193 - platform_turn_yy * minus_platform_U_yz, t196 = limb5_S_rate_wx * limb5_S_rate_wx,
      minus_platform_U_still_zz = t196 + t185, minus_platform_U_still_yy = t196 + t186;
    /* platform: loop closure */
    const REAL t199 = param_H * (t195 - platform_turn_yz * minus_platform_U_still_zz), t200 = t192 + t199,
      t388 = t192 - t199, t255 = minus_limb1_U_0_cos * t200, /* limb1 */
      t201 = limb1_U_0_sin * t200, /* limb1 */
      t204 = platform_turn_zx * minus_platform_U_still_xx - platform_turn_zy * platform_U_yx,
      t220 = platform_turn_xx * minus_platform_U_still_xx - platform_turn_xy * platform_U_yx,
      t207 = 0.5 * (t204 + platform_turn_zz * minus_platform_U_zx),
      t223 = 0.5 * (t220 + platform_turn_xz * minus_platform_U_zx),
      t210 = platform_turn_zx * platform_U_xz - platform_turn_zy * minus_platform_U_yz,
      t226 = platform_turn_xx * platform_U_xz - platform_turn_xy * minus_platform_U_yz,
      t213 = param_H * (t210 - platform_turn_zz * minus_platform_U_still_zz),
      t229 = param_H * (t226 - platform_turn_xz * minus_platform_U_still_zz), t214 = t207 + t213, t390 = t207 - t213;
    /* limb1: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb1_U_0_alpha_z = t35 * (limb1_upper_acc_z + (t255 - limb1_U_0_sin * t214)),
      t216 = t201 + minus_limb1_U_0_cos * t214,
      minus_limb1_lower_alpha_y_2 = minus_limb1_lower_alpha_y - limb1_lower_cos * limb1_U_0_alpha_z,
      limb1_U_0_rate_mz = k3 * limb1_U_0_alpha_z,
      limb1_lower_U_zx_2 = minus_limb1_lower_alpha_y + minus_limb1_lower_alpha_y_2,
      t264 = k8 * minus_limb1_lower_alpha_y_2 + k9 * minus_limb1_lower_alpha_y,
      limb1_lower_rate_fz = limb_lower_mx * limb1_lower_U_zx_2,
      limb1_upper_acc_z_2 = t253 + (gravity_z * limb1_U_0_sin + limb1_lower_limb_length * limb1_lower_U_zx_2),
      t260 = limb1_lower_limb_length * (limb_lower_m * limb1_upper_acc_z_2 - limb1_lower_rate_fz),
      limb1_lower_moment_y = limb_lower_mx * limb1_upper_acc_z_2 - t260 - (t264 + gravity_z_limb_lower_mx * limb1_U_0_sin),
      t266 = limb1_lower_cos * limb1_lower_moment_y,
      limb1_U_0_moment_z = limb1_lower_sin * (k10 * (minus_limb1_lower_omega_z * minus_limb1_lower_omega_y)) + t266 + limb1_U_0_rate_mz,
      minus_limb1_U2_part_fz = t35 * limb1_U_0_moment_z, t242 = minus_limb1_lower_omega_y * minus_limb1_lower_omega_y,
      t517 = minus_limb1_U_0_cos * minus_limb1_U2_part_fz, t267 = limb1_U_0_sin * minus_limb1_U2_part_fz,
      t181 = minus_limb1_U2_opening_rate_fx * (2.0 * minus_limb1_lower_omega_z),
      minus_limb1_lower_U_xx = t242 + minus_limb1_lower_omega_z * minus_limb1_lower_omega_z,
      limb1_upper_acc_y = limb1_lower_limb_length * limb1_lower_U_xy - t181, t217 = limb1_lower_sin * t216,
      t244 = limb1_lower_cos * t216, t230 = t223 + t229, /* platform */
      t394 = t223 - t229, /* platform */
      minus_limb1_lower_alpha_z = t33 * (limb1_upper_acc_y - (t217 + limb1_lower_cos * t230)),
      t246 = t244 - limb1_lower_sin * t230, limb1_lower_U_yx = limb1_lower_U_xy - minus_limb1_lower_alpha_z,
      t239 = k9 * minus_limb1_lower_alpha_z - k8 * limb1_lower_U_xy,
      t233 = limb1_lower_limb_length * limb1_lower_U_yx, limb1_lower_rate_fy = limb_lower_mx * limb1_lower_U_yx,
      minus_limb1_U_0_acc_y = gravity_z * minus_limb1_U_0_cos,
      limb1_lower_acc_y = limb1_lower_sin * minus_limb1_U_0_acc_y,
      minus_limb1_upper_acc_y = t181 - (limb1_lower_acc_y + t233),
      minus_limb1_lower_rate_mz = t239 - limb_lower_mx * limb1_lower_acc_y,
      minus_limb1_lower_acc_x = limb1_lower_cos * minus_limb1_U_0_acc_y;
    /* limb1: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL t235 = limb1_lower_limb_length * (limb_lower_m * minus_limb1_upper_acc_y + limb1_lower_rate_fy),
      limb1_U2_part_fy = t33 * (limb_lower_mx * minus_limb1_upper_acc_y - t235 - minus_limb1_lower_rate_mz),
      minus_limb1_upper_acc_x = limb1_lower_limb_length * minus_limb1_lower_U_xx,
      limb1_lower_force_x = limb_lower_m * (minus_limb1_upper_acc_x - t246 - (minus_limb1_upper_acc_x + minus_limb1_lower_acc_x)),
      limb1_upper_rate_fx = limb1_lower_force_x + limb_lower_mx * minus_limb1_lower_U_xx,
      t241 = limb1_lower_cos * limb1_U2_part_fy,
      t270 = limb1_lower_sin * limb1_U2_part_fy - limb1_lower_cos * limb1_upper_rate_fx,
      t249 = t241 + limb1_lower_sin * limb1_upper_rate_fx, t519 = t517 + limb1_U_0_sin * t270,
      t272 = t267 - minus_limb1_U_0_cos * t270, t552 = minus_limb1_lower_limb_target_y * t519,
      t522 = minus_limb1_upper_position_x * t519 - minus_limb1_lower_limb_target_x * t249,
      t250 = minus_limb1_lower_limb_target_y * t249;
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35); loop closure */
    const REAL minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy, t141 = k12 * platform_U_still_yz,
      platform_U_zy = limb5_S_acc_wx + platform_U_still_yz,
      minus_platform_rate_mx = minus_platform_moment_x - (t141 + k13 * limb5_S_acc_wx),
      t512 = platform_turn_zx * minus_platform_rate_mx, t298 = platform_turn_zx * minus_platform_U_xy,
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (t145 - k13 * limb5_S_acc_wy),
      t514 = t512 - platform_turn_zy * platform_rate_my, platform_rate_mz = platform_Izz * limb5_S_acc_wz,
      t523 = t514 - platform_turn_zz * platform_rate_mz + t522, t301 = platform_turn_zz * platform_U_zy,
      t74 = 0.5 * platform_turn_zy;
    /* limb2: geometry; loop closure; accelerations */
    const REAL limb2_lower_limb_target_x = t17 - t74, limb4_lower_limb_target_x = t17 + t74,
      t75 = limb2_lower_limb_target_x * limb2_lower_limb_target_x, t76 = 0.5 * platform_turn_xy, /* platform */
      limb2_lower_limb_target_y = t20 - t76, limb4_lower_limb_target_y = t20 + t76,
      t78 = t75 + limb2_lower_limb_target_y * limb2_lower_limb_target_y, limb2_U_0_lever_mz_by_limb2_S_fz = SQRT(t78),
      t79 = 1.0 / limb2_U_0_lever_mz_by_limb2_S_fz, limb2_U_0_sin = limb2_lower_limb_target_x * t79,
      t73 = 0.5 * platform_turn_yy, /* platform */
      limb2_upper_position_y = t27 - t73, limb4_upper_position_y = t27 + t73,
      t278 = limb2_upper_position_y * platform_twist_wx - limb2_lower_limb_target_y * platform_twist_wy,
      t279 = t278 * limb2_U_0_sin, minus_limb2_U_0_cos = limb2_lower_limb_target_y * t79,
      t290 = t278 * minus_limb2_U_0_cos,
      t282 = limb2_lower_limb_target_x * platform_twist_wy - limb2_upper_position_y * platform_twist_wz,
      t284 = t279 + t282 * minus_limb2_U_0_cos, minus_limb2_U_0_omega_z = t79 * (t290 - t282 * limb2_U_0_sin),
      limb2_lower_limb_target_z = param_R + limb2_upper_position_y,
      limb2_lower_limb_length = SQRT(t78 + limb2_lower_limb_target_z * limb2_lower_limb_target_z),
      t82 = 1.0 / limb2_lower_limb_length, limb2_lower_sin = limb2_lower_limb_target_z * t82,
      minus_limb2_lower_cos = limb2_U_0_lever_mz_by_limb2_S_fz * t82, t285 = limb2_lower_sin * t284,
      t293 = minus_limb2_lower_cos * t284,
      t288 = limb2_lower_limb_target_y * platform_twist_wz - limb2_lower_limb_target_x * platform_twist_wx,
      limb2_lower_omega_z = t82 * (t285 - t288 * minus_limb2_lower_cos),
      minus_limb2_S_opening_rate_fx = t293 + t288 * limb2_lower_sin,
      minus_limb2_lower_omega_x = limb2_lower_sin * minus_limb2_U_0_omega_z,
      limb2_lower_omega_y = minus_limb2_lower_cos * minus_limb2_U_0_omega_z,
      limb2_lower_alpha_y = limb2_lower_omega_z * minus_limb2_lower_omega_x,
      minus_limb2_lower_U_xy = minus_limb2_lower_omega_x * limb2_lower_omega_y,
      t297 = limb2_lower_limb_length * (2.0 * limb2_lower_alpha_y),
      t296 = minus_limb2_S_opening_rate_fx * (2.0 * limb2_lower_omega_y), minus_limb2_upper_acc_z = t297 + t296;
    /* platform: loop closure; balance, eqs. (40)-(47) */
    const REAL t303 = 0.5 * (t298 + platform_turn_zy * minus_platform_U_still_yy - t301), t304 = t213 + t303,
      t462 = t213 - t303, t305 = minus_limb2_U_0_cos * t304, /* limb2 */
      t328 = limb2_U_0_sin * t304, /* limb2 */
      t308 = platform_turn_xx * minus_platform_U_xy + platform_turn_xy * minus_platform_U_still_yy,
      t334 = platform_turn_yx * minus_platform_U_xy + platform_turn_yy * minus_platform_U_still_yy,
      t144 = platform_turn_yx * minus_platform_rate_mx, t546 = platform_turn_xx * minus_platform_rate_mx,
      t311 = 0.5 * (t308 - platform_turn_xz * platform_U_zy), t337 = 0.5 * (t334 - platform_turn_yz * platform_U_zy),
      t150 = platform_turn_yz * platform_rate_mz, t549 = platform_turn_xz * platform_rate_mz, t312 = t229 + t311,
      t464 = t229 - t311;
    /* limb2: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb2_U_0_alpha_z = t79 * (minus_limb2_upper_acc_z - (t305 - limb2_U_0_sin * t312)),
      t330 = t328 + minus_limb2_U_0_cos * t312,
      limb2_lower_alpha_y_2 = limb2_lower_alpha_y - minus_limb2_lower_cos * limb2_U_0_alpha_z,
      limb2_U_0_rate_mz = k3 * limb2_U_0_alpha_z,
      minus_limb2_lower_U_zx_2 = limb2_lower_alpha_y + limb2_lower_alpha_y_2,
      t321 = k8 * limb2_lower_alpha_y_2 + k9 * limb2_lower_alpha_y,
      minus_limb2_lower_rate_fz = limb_lower_mx * minus_limb2_lower_U_zx_2,
      minus_limb2_upper_acc_z_2 = t296 + (gravity_z * minus_limb2_U_0_cos + limb2_lower_limb_length * minus_limb2_lower_U_zx_2),
      t317 = limb2_lower_limb_length * (limb_lower_m * minus_limb2_upper_acc_z_2 - minus_limb2_lower_rate_fz),
      t318 = limb_lower_mx * minus_limb2_upper_acc_z_2 - t317,
      t323 = minus_limb2_lower_cos * (t318 - (t321 + gravity_z_limb_lower_mx * minus_limb2_U_0_cos)),
      limb2_U_0_moment_z = limb2_lower_sin * (k10 * (limb2_lower_omega_z * limb2_lower_omega_y)) + t323 + limb2_U_0_rate_mz,
      limb2_S_multiplier_fz = t79 * limb2_U_0_moment_z, t350 = limb2_lower_omega_y * limb2_lower_omega_y,
      t324 = limb2_U_0_sin * limb2_S_multiplier_fz, t361 = minus_limb2_U_0_cos * limb2_S_multiplier_fz,
      t326 = minus_limb2_S_opening_rate_fx * (2.0 * limb2_lower_omega_z),
      minus_limb2_lower_U_xx = t350 + limb2_lower_omega_z * limb2_lower_omega_z,
      minus_limb2_upper_acc_y = limb2_lower_limb_length * minus_limb2_lower_U_xy - t326,
      t331 = limb2_lower_sin * t330, t352 = minus_limb2_lower_cos * t330, t338 = t199 + t337, /* platform */
      t484 = t199 - t337, /* platform */
      limb2_lower_alpha_z = t82 * (minus_limb2_upper_acc_y + (t331 - minus_limb2_lower_cos * t338)),
      t354 = t352 + limb2_lower_sin * t338, minus_limb2_lower_U_yx = minus_limb2_lower_U_xy - limb2_lower_alpha_z,
      t347 = k9 * limb2_lower_alpha_z - k8 * minus_limb2_lower_U_xy,
      t341 = limb2_lower_limb_length * minus_limb2_lower_U_yx,
      minus_limb2_lower_rate_fy = limb_lower_mx * minus_limb2_lower_U_yx,
      minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin, limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y,
      limb2_upper_acc_y = t326 + (limb2_lower_acc_y - t341),
      limb2_lower_rate_mz = t347 + limb_lower_mx * limb2_lower_acc_y,
      limb2_lower_acc_x = minus_limb2_lower_cos * minus_limb2_U_0_acc_y;
    /* limb2: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL t343 = limb2_lower_limb_length * (limb_lower_m * limb2_upper_acc_y + minus_limb2_lower_rate_fy),
      minus_limb2_S_multiplier_fy = t82 * (limb_lower_mx * limb2_upper_acc_y - t343 - limb2_lower_rate_mz),
      minus_limb2_upper_acc_x = limb2_lower_limb_length * minus_limb2_lower_U_xx,
      limb2_lower_force_x = limb_lower_m * (minus_limb2_upper_acc_x + t354 - (minus_limb2_upper_acc_x - limb2_lower_acc_x)),
      limb2_upper_rate_fx = limb2_lower_force_x + limb_lower_mx * minus_limb2_lower_U_xx,
      t524 = minus_limb2_lower_cos * minus_limb2_S_multiplier_fy,
      t357 = limb2_lower_sin * minus_limb2_S_multiplier_fy - minus_limb2_lower_cos * limb2_upper_rate_fx,
      t526 = t524 + limb2_lower_sin * limb2_upper_rate_fx, t359 = t324 - minus_limb2_U_0_cos * t357,
      t363 = t361 + limb2_U_0_sin * t357, base_lever_fx_by_limb2_S_fx = minus_limb2_U_0_cos * minus_limb2_lower_cos,
      base_lever_fz_by_limb2_S_fx = limb2_U_0_sin * minus_limb2_lower_cos, t360 = limb2_lower_limb_target_x * t359,
      t530 = t523 - (limb2_lower_limb_target_y * t526 - limb2_upper_position_y * t359), /* platform */
      t556 = limb2_lower_limb_target_x * t526;
    /* limb3: geometry; loop closure; accelerations */
    const REAL t90 = limb3_lower_limb_target_x * limb3_lower_limb_target_x,
      t92 = t90 + limb3_lower_limb_target_y * limb3_lower_limb_target_y,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = SQRT(t92), t93 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      minus_limb3_U_0_sin = limb3_lower_limb_target_x * t93,
      t369 = limb3_upper_position_x * platform_twist_wz - limb3_lower_limb_target_y * platform_twist_wx,
      t370 = t369 * minus_limb3_U_0_sin, limb3_U_0_cos = limb3_lower_limb_target_y * t93, t385 = t369 * limb3_U_0_cos,
      t373 = limb3_lower_limb_target_x * platform_twist_wx - limb3_upper_position_x * platform_twist_wy,
      t375 = t370 + t373 * limb3_U_0_cos, minus_limb3_U_0_omega_z = t93 * (t385 - t373 * minus_limb3_U_0_sin),
      minus_limb3_lower_limb_target_z = param_R - limb3_upper_position_x,
      limb3_lower_limb_length = SQRT(t92 + minus_limb3_lower_limb_target_z * minus_limb3_lower_limb_target_z),
      t96 = 1.0 / limb3_lower_limb_length, minus_limb3_lower_sin = minus_limb3_lower_limb_target_z * t96,
      limb3_lower_cos = minus_limb3_U_0_lever_mz_by_limb3_S_fz * t96, t381 = minus_limb3_lower_sin * t375,
      t376 = limb3_lower_cos * t375,
      t379 = limb3_lower_limb_target_y * platform_twist_wy - limb3_lower_limb_target_x * platform_twist_wz,
      limb3_lower_omega_z = t96 * (t381 + t379 * limb3_lower_cos),
      minus_limb3_S_opening_rate_fx = t376 - t379 * minus_limb3_lower_sin,
      limb3_lower_omega_x = minus_limb3_lower_sin * minus_limb3_U_0_omega_z,
      minus_limb3_lower_omega_y = limb3_lower_cos * minus_limb3_U_0_omega_z,
      minus_limb3_lower_alpha_y = limb3_lower_omega_z * limb3_lower_omega_x,
      minus_limb3_lower_U_xy = limb3_lower_omega_x * minus_limb3_lower_omega_y,
      t418 = limb3_lower_limb_length * (2.0 * minus_limb3_lower_alpha_y),
      t417 = minus_limb3_S_opening_rate_fx * (2.0 * minus_limb3_lower_omega_y), t389 = minus_limb3_U_0_sin * t388,
      limb3_U_0_alpha_z = t93 * (t418 + t417 + (limb3_U_0_cos * t388 - minus_limb3_U_0_sin * t390)),
      t392 = t389 + limb3_U_0_cos * t390,
      minus_limb3_lower_alpha_y_2 = minus_limb3_lower_alpha_y - limb3_lower_cos * limb3_U_0_alpha_z,
      limb3_U_0_rate_mz = k3 * limb3_U_0_alpha_z,
      limb3_lower_U_zx_2 = minus_limb3_lower_alpha_y + minus_limb3_lower_alpha_y_2,
      t428 = k8 * minus_limb3_lower_alpha_y_2 + k9 * minus_limb3_lower_alpha_y,
      limb3_lower_rate_fz = limb_lower_mx * limb3_lower_U_zx_2,
      limb3_upper_acc_z_2 = t417 - (gravity_z * minus_limb3_U_0_sin - limb3_lower_limb_length * limb3_lower_U_zx_2),
      t424 = limb3_lower_limb_length * (limb_lower_m * limb3_upper_acc_z_2 - limb3_lower_rate_fz),
      t425 = limb_lower_mx * limb3_upper_acc_z_2 - t424,
      t430 = limb3_lower_cos * (t425 - (t428 - gravity_z_limb_lower_mx * minus_limb3_U_0_sin)),
      limb3_U_0_moment_z = minus_limb3_lower_sin * (k10 * (limb3_lower_omega_z * minus_limb3_lower_omega_y)) + t430 + limb3_U_0_rate_mz,
      minus_limb3_S_multiplier_fz = t93 * limb3_U_0_moment_z,
      t406 = minus_limb3_lower_omega_y * minus_limb3_lower_omega_y,
      t531 = limb3_U_0_cos * minus_limb3_S_multiplier_fz, t431 = minus_limb3_U_0_sin * minus_limb3_S_multiplier_fz;
    /* limb3: accelerations; loop closure; momentum rate, eq. (35) */
    const REAL t384 = minus_limb3_S_opening_rate_fx * (2.0 * limb3_lower_omega_z),
      minus_limb3_lower_U_xx = t406 + limb3_lower_omega_z * limb3_lower_omega_z,
      minus_limb3_upper_acc_y = limb3_lower_limb_length * minus_limb3_lower_U_xy - t384,
      t408 = limb3_lower_cos * t392,
      limb3_lower_alpha_z = t96 * (minus_limb3_upper_acc_y - (minus_limb3_lower_sin * t392 + limb3_lower_cos * t394)),
      t410 = t408 - minus_limb3_lower_sin * t394,
      minus_limb3_lower_U_yx = minus_limb3_lower_U_xy - limb3_lower_alpha_z,
      t403 = k9 * limb3_lower_alpha_z - k8 * minus_limb3_lower_U_xy,
      t397 = limb3_lower_limb_length * minus_limb3_lower_U_yx,
      minus_limb3_lower_rate_fy = limb_lower_mx * minus_limb3_lower_U_yx, limb3_U_0_acc_y = gravity_z * limb3_U_0_cos,
      limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y,
      limb3_upper_acc_y = t384 + (limb3_lower_acc_y - t397),
      limb3_lower_rate_mz = t403 + limb_lower_mx * limb3_lower_acc_y,
      limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y;
    /* limb3: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL t399 = limb3_lower_limb_length * (limb_lower_m * limb3_upper_acc_y + minus_limb3_lower_rate_fy),
      minus_limb3_S_multiplier_fy = t96 * (limb_lower_mx * limb3_upper_acc_y - t399 - limb3_lower_rate_mz),
      minus_limb3_upper_acc_x = limb3_lower_limb_length * minus_limb3_lower_U_xx,
      limb3_lower_force_x = limb_lower_m * (minus_limb3_upper_acc_x - t410 - (minus_limb3_upper_acc_x - limb3_lower_acc_x)),
      limb3_upper_rate_fx = limb3_lower_force_x + limb_lower_mx * minus_limb3_lower_U_xx,
      t405 = limb3_lower_cos * minus_limb3_S_multiplier_fy,
      t434 = minus_limb3_lower_sin * minus_limb3_S_multiplier_fy - limb3_lower_cos * limb3_upper_rate_fx,
      t413 = t405 + minus_limb3_lower_sin * limb3_upper_rate_fx, t533 = t531 + minus_limb3_U_0_sin * t434,
      t436 = t431 - limb3_U_0_cos * t434, base_lever_fy_by_limb3_S_fx = minus_limb3_U_0_sin * limb3_lower_cos,
      base_lever_fz_by_limb3_S_fx = limb3_U_0_cos * limb3_lower_cos, t560 = limb3_lower_limb_target_y * t533,
      t537 = t530 + (limb3_upper_position_x * t533 - limb3_lower_limb_target_x * t413), /* platform */
      t414 = limb3_lower_limb_target_y * t413;
    /* limb4: reciprocal wrenches, eq. (10); geometry */
    const REAL t104 = limb4_lower_limb_target_x * limb4_lower_limb_target_x,
      t106 = t104 + limb4_lower_limb_target_y * limb4_lower_limb_target_y,
      limb4_U_0_lever_mz_by_limb4_S_fz = SQRT(t106), t107 = 1.0 / limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_U_0_sin = limb4_lower_limb_target_x * t107;
    /* limb4: loop closure; accelerations; balance, eqs. (40)-(47) */
    const REAL t451 = limb4_lower_limb_target_x * platform_twist_wx,
      t442 = limb4_upper_position_y * platform_twist_wx - limb4_lower_limb_target_y * platform_twist_wy,
      t444 = limb4_lower_limb_target_x * platform_twist_wy, t443 = t442 * limb4_U_0_sin,
      minus_limb4_U_0_cos = limb4_lower_limb_target_y * t107, t454 = t442 * minus_limb4_U_0_cos,
      t446 = t444 - limb4_upper_position_y * platform_twist_wz,
      t452 = limb4_lower_limb_target_y * platform_twist_wz - t451, t448 = t443 + t446 * minus_limb4_U_0_cos,
      minus_limb4_U_0_omega_z = t107 * (t454 - t446 * limb4_U_0_sin),
      minus_limb4_lower_limb_target_z = param_R - limb4_upper_position_y,
      limb4_lower_limb_length = SQRT(t106 + minus_limb4_lower_limb_target_z * minus_limb4_lower_limb_target_z),
      t110 = 1.0 / limb4_lower_limb_length, minus_limb4_lower_sin = minus_limb4_lower_limb_target_z * t110,
      minus_limb4_lower_cos = limb4_U_0_lever_mz_by_limb4_S_fz * t110, t457 = minus_limb4_lower_cos * t448,
      minus_limb4_lower_omega_z = t110 * (minus_limb4_lower_sin * t448 + t452 * minus_limb4_lower_cos),
      minus_limb4_S_opening_rate_fx = t457 - t452 * minus_limb4_lower_sin,
      limb4_lower_omega_x = minus_limb4_lower_sin * minus_limb4_U_0_omega_z,
      limb4_lower_omega_y = minus_limb4_lower_cos * minus_limb4_U_0_omega_z,
      limb4_lower_alpha_y = minus_limb4_lower_omega_z * limb4_lower_omega_x,
      limb4_lower_U_xy = limb4_lower_omega_x * limb4_lower_omega_y,
      t461 = limb4_lower_limb_length * (2.0 * limb4_lower_alpha_y),
      t460 = minus_limb4_S_opening_rate_fx * (2.0 * limb4_lower_omega_y), t480 = limb4_U_0_sin * t462,
      limb4_U_0_alpha_z = t107 * (t461 + t460 - (minus_limb4_U_0_cos * t462 - limb4_U_0_sin * t464)),
      t482 = t480 + minus_limb4_U_0_cos * t464,
      limb4_lower_alpha_y_2 = limb4_lower_alpha_y - minus_limb4_lower_cos * limb4_U_0_alpha_z,
      limb4_U_0_rate_mz = k3 * limb4_U_0_alpha_z,
      minus_limb4_lower_U_zx_2 = limb4_lower_alpha_y + limb4_lower_alpha_y_2,
      t473 = k8 * limb4_lower_alpha_y_2 + k9 * limb4_lower_alpha_y,
      minus_limb4_lower_rate_fz = limb_lower_mx * minus_limb4_lower_U_zx_2,
      minus_limb4_upper_acc_z_2 = t460 + (gravity_z * minus_limb4_U_0_cos + limb4_lower_limb_length * minus_limb4_lower_U_zx_2),
      t469 = limb4_lower_limb_length * (limb_lower_m * minus_limb4_upper_acc_z_2 - minus_limb4_lower_rate_fz),
      t470 = limb_lower_mx * minus_limb4_upper_acc_z_2 - t469,
      t475 = minus_limb4_lower_cos * (t470 - (t473 + gravity_z_limb_lower_mx * minus_limb4_U_0_cos)),
      limb4_U_0_moment_z = minus_limb4_lower_sin * (k10 * (minus_limb4_lower_omega_z * limb4_lower_omega_y)) + t475 + limb4_U_0_rate_mz,
      limb4_S_multiplier_fz = t107 * limb4_U_0_moment_z, t496 = limb4_lower_omega_y * limb4_lower_omega_y,
      t476 = limb4_U_0_sin * limb4_S_multiplier_fz, t507 = minus_limb4_U_0_cos * limb4_S_multiplier_fz;
    /* limb4: accelerations; loop closure; momentum rate, eq. (35) */
    const REAL t478 = minus_limb4_S_opening_rate_fx * (2.0 * minus_limb4_lower_omega_z),
      minus_limb4_lower_U_xx = t496 + minus_limb4_lower_omega_z * minus_limb4_lower_omega_z,
      limb4_upper_acc_y = limb4_lower_limb_length * limb4_lower_U_xy - t478, t498 = minus_limb4_lower_cos * t482,
      minus_limb4_lower_alpha_z = t110 * (limb4_upper_acc_y + (minus_limb4_lower_sin * t482 + minus_limb4_lower_cos * t484)),
      t500 = t498 - minus_limb4_lower_sin * t484, limb4_lower_U_yx = limb4_lower_U_xy - minus_limb4_lower_alpha_z,
      t493 = k9 * minus_limb4_lower_alpha_z - k8 * limb4_lower_U_xy,
      t487 = limb4_lower_limb_length * limb4_lower_U_yx, limb4_lower_rate_fy = limb_lower_mx * limb4_lower_U_yx,
      minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y,
      minus_limb4_upper_acc_y = t478 + (minus_limb4_lower_acc_y - t487),
      minus_limb4_lower_rate_mz = t493 + limb_lower_mx * minus_limb4_lower_acc_y,
      limb4_lower_acc_x = minus_limb4_lower_cos * minus_limb4_U_0_acc_y;
    /* limb4: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL t489 = limb4_lower_limb_length * (limb_lower_m * minus_limb4_upper_acc_y + limb4_lower_rate_fy),
      limb4_S_multiplier_fy = t110 * (limb_lower_mx * minus_limb4_upper_acc_y - t489 - minus_limb4_lower_rate_mz),
      minus_limb4_upper_acc_x = limb4_lower_limb_length * minus_limb4_lower_U_xx,
      limb4_lower_force_x = limb_lower_m * (minus_limb4_upper_acc_x + t500 - (minus_limb4_upper_acc_x - limb4_lower_acc_x)),
      limb4_upper_rate_fx = limb4_lower_force_x + limb_lower_mx * minus_limb4_lower_U_xx,
      t538 = minus_limb4_lower_cos * limb4_S_multiplier_fy,
      t503 = minus_limb4_lower_sin * limb4_S_multiplier_fy - minus_limb4_lower_cos * limb4_upper_rate_fx,
      t540 = t538 + minus_limb4_lower_sin * limb4_upper_rate_fx, t505 = t476 - minus_limb4_U_0_cos * t503,
      t509 = t507 + limb4_U_0_sin * t503, base_lever_fx_by_limb4_S_fx = minus_limb4_U_0_cos * minus_limb4_lower_cos,
      base_lever_fz_by_limb4_S_fx = limb4_U_0_sin * minus_limb4_lower_cos, t506 = limb4_lower_limb_target_x * t505,
      minus_platform_joint_force_mz = t537 + (limb4_lower_limb_target_y * t540 + limb4_upper_position_y * t505),
      t564 = limb4_lower_limb_target_x * t540;
    /* limb1: reciprocal wrenches, eq. (10); loop closure; balance, eqs. (40)-(47) */
    const REAL t41 = platform_turn_yy * limb1_U_0_sin + platform_turn_zy * minus_limb1_U_0_cos,
      t46 = platform_turn_zy * limb1_U_0_sin, t582 = limb1_lower_sin * t41,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t41 - platform_turn_xy * limb1_lower_sin,
      minus_limb1_U2_part_fy_by_limb1_U2_mn = t33 * limb1_U2_constraint_mn_couple_z,
      minus_limb1_U_0_force_y_by_limb1_U2_mn = limb1_lower_sin * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      limb1_U_0_force_z_by_limb1_U2_mn = limb1_lower_cos * minus_limb1_U2_part_fy_by_limb1_U2_mn,
      limb1_U_0_joint_force_fx_by_limb1_U2_mn = limb1_U_0_sin * minus_limb1_U_0_force_y_by_limb1_U2_mn,
      limb1_U_0_joint_force_fy_by_limb1_U2_mn = minus_limb1_U_0_cos * minus_limb1_U_0_force_y_by_limb1_U2_mn,
      minus_limb1_U2_constraint_mn_couple_x = platform_turn_yy * minus_limb1_U_0_cos - t46,
      t151 = t144 - platform_turn_yy * platform_rate_my - t150, /* platform */
      t550 = t546 - platform_turn_xy * platform_rate_my - t549, /* platform */
      limb1_U2_opening_mn = t582 + platform_turn_xy * limb1_lower_cos,
      t584 = limb1_U2_opening_mn * limb1_U2_opening_mn,
      minus_limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * minus_limb1_U2_constraint_mn_couple_x,
      minus_limb1_U2_part_fz_by_limb1_U2_mn = t35 * minus_limb1_U_0_lever_mz_by_limb1_U2_mn,
      minus_limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * minus_limb1_U2_constraint_mn_couple_x;
    /* limb5_S: balance, eqs. (40)-(47); reciprocal wrenches, eq. (10); drives */
    const REAL t59 = limb1_U_0_joint_force_fx_by_limb1_U2_mn - minus_limb1_U_0_cos * minus_limb1_U2_part_fz_by_limb1_U2_mn,
      t50 = limb1_U_0_joint_force_fy_by_limb1_U2_mn + limb1_U_0_sin * minus_limb1_U2_part_fz_by_limb1_U2_mn,
      t60 = minus_limb1_upper_position_x * t59, t68 = minus_limb1_lower_limb_target_y * t59,
      t62 = t60 - minus_limb1_lower_limb_target_x * limb1_U_0_force_z_by_limb1_U2_mn,
      t48 = minus_limb1_lower_limb_target_y * limb1_U_0_force_z_by_limb1_U2_mn, /* limb1 */
      t56 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z, /* limb1 */
      t44 = minus_limb1_U_0_cos * limb1_U2_constraint_mn_couple_z, /* limb1 */
      platform_joint_force_mz_by_limb1_U2_mn = t56 + minus_limb1_U_0_cos * minus_limb1_U_0_lever_my_by_limb1_U2_mn + t62;
    REAL checked0 = platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t63 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn,
      limb1_U2_part_mn = minus_platform_joint_force_mz * t63,
      minus_base_lever_my_by_limb1_U2_mn = t44 - limb1_U_0_sin * minus_limb1_U_0_lever_my_by_limb1_U2_mn,
      minus_base_lever_fy_by_limb1_U2_fx = limb1_U_0_sin * limb1_lower_cos,
      minus_base_lever_fz_by_limb1_U2_fx = minus_limb1_U_0_cos * limb1_lower_cos,
      t53 = minus_base_lever_my_by_limb1_U2_mn - (t48 - minus_limb1_upper_position_x * t50),
      t70 = minus_limb1_U_0_lever_mz_by_limb1_U2_mn - (minus_limb1_lower_limb_target_x * t50 - t68),
      t544 = t53 * limb1_U2_part_mn, t566 = t70 * limb1_U2_part_mn,
      t366 = t151 + (t250 + minus_limb1_upper_position_x * t272) - (t360 + limb2_lower_limb_target_y * t363),
      t558 = t550 - (minus_limb1_lower_limb_target_x * t272 + t552) + (limb2_upper_position_y * t363 + t556),
      t562 = t558 - (limb3_lower_limb_target_x * t436 + t560),
      minus_platform_joint_force_my = t366 + (t414 + limb3_upper_position_x * t436) - (t506 + limb4_lower_limb_target_y * t509),
      minus_limb5_S_balance_wy = minus_platform_joint_force_my + t544,
      minus_limb5_S_balance_wx = t562 + (limb4_upper_position_y * t509 - t564) + t566,
      t54 = minus_limb1_upper_position_x * minus_base_lever_fy_by_limb1_U2_fx, /* limb1 */
      t66 = minus_limb1_lower_limb_target_y * minus_base_lever_fy_by_limb1_U2_fx, /* limb1 */
      t36 = minus_limb1_upper_position_x * minus_base_lever_fz_by_limb1_U2_fx, /* limb1 */
      minus_limb1_U2_closure_fx_by_limb5_S_wx = minus_limb1_lower_limb_target_x * minus_base_lever_fz_by_limb1_U2_fx - t66,
      limb1_U2_closure_fx_by_limb5_S_wy = minus_limb1_lower_limb_target_y * limb1_lower_sin + t36,
      limb1_U2_part_mn_by_limb1_P = (t54 + minus_limb1_lower_limb_target_x * limb1_lower_sin) * t63,
      minus_limb5_S_balance_wx_by_limb1_P = minus_limb1_U2_closure_fx_by_limb5_S_wx + t70 * limb1_U2_part_mn_by_limb1_P,
      limb5_S_balance_wy_by_limb1_P = limb1_U2_closure_fx_by_limb5_S_wy - t53 * limb1_U2_part_mn_by_limb1_P,
      t72 = minus_limb5_S_balance_wx_by_limb1_P * minus_limb5_S_balance_wx_by_limb1_P,
      t86 = limb2_upper_position_y * base_lever_fx_by_limb2_S_fx, /* limb2 */
      t83 = limb2_upper_position_y * base_lever_fz_by_limb2_S_fx, /* limb2 */
      t118 = limb2_lower_limb_target_x * base_lever_fx_by_limb2_S_fx, /* limb2 */
      minus_limb2_S_closure_fx_by_limb5_S_wx = t83 - limb2_lower_limb_target_x * limb2_lower_sin,
      minus_limb2_S_closure_fx_by_limb5_S_wy = t118 - limb2_lower_limb_target_y * base_lever_fz_by_limb2_S_fx,
      limb1_U2_part_mn_by_limb2_P = (limb2_lower_limb_target_y * limb2_lower_sin - t86) * t63,
      minus_limb5_S_balance_wx_by_limb2_P = minus_limb2_S_closure_fx_by_limb5_S_wx + t70 * limb1_U2_part_mn_by_limb2_P,
      minus_limb5_S_balance_wy_by_limb2_P = minus_limb2_S_closure_fx_by_limb5_S_wy + t53 * limb1_U2_part_mn_by_limb2_P,
      t89 = t72 + minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wx_by_limb2_P,
      t99 = limb3_upper_position_x * base_lever_fy_by_limb3_S_fx, /* limb3 */
      t98 = limb3_lower_limb_target_y * base_lever_fy_by_limb3_S_fx, /* limb3 */
      t124 = limb3_upper_position_x * base_lever_fz_by_limb3_S_fx, /* limb3 */
      minus_limb3_S_closure_fx_by_limb5_S_wx = limb3_lower_limb_target_x * base_lever_fz_by_limb3_S_fx - t98,
      limb3_S_closure_fx_by_limb5_S_wy = limb3_lower_limb_target_y * minus_limb3_lower_sin + t124,
      limb1_U2_part_mn_by_limb3_P = (t99 + limb3_lower_limb_target_x * minus_limb3_lower_sin) * t63,
      minus_limb5_S_balance_wx_by_limb3_P = minus_limb3_S_closure_fx_by_limb5_S_wx + t70 * limb1_U2_part_mn_by_limb3_P,
      limb5_S_balance_wy_by_limb3_P = limb3_S_closure_fx_by_limb5_S_wy - t53 * limb1_U2_part_mn_by_limb3_P,
      t103 = t89 + minus_limb5_S_balance_wx_by_limb3_P * minus_limb5_S_balance_wx_by_limb3_P,
      t114 = limb4_upper_position_y * base_lever_fx_by_limb4_S_fx, /* limb4 */
      t111 = limb4_upper_position_y * base_lever_fz_by_limb4_S_fx, /* limb4 */
      t128 = limb4_lower_limb_target_x * base_lever_fx_by_limb4_S_fx, /* limb4 */
      minus_limb4_S_closure_fx_by_limb5_S_wx = t111 + limb4_lower_limb_target_x * minus_limb4_lower_sin,
      minus_limb1_U2_part_mn_by_limb4_P = (limb4_lower_limb_target_y * minus_limb4_lower_sin + t114) * t63,
      minus_limb4_S_closure_fx_by_limb5_S_wy = t128 - limb4_lower_limb_target_y * base_lever_fz_by_limb4_S_fx,
      minus_limb5_S_balance_wx_by_limb4_P = minus_limb4_S_closure_fx_by_limb5_S_wx - t70 * minus_limb1_U2_part_mn_by_limb4_P,
      minus_limb5_S_balance_wy_by_limb4_P = minus_limb4_S_closure_fx_by_limb5_S_wy - t53 * minus_limb1_U2_part_mn_by_limb4_P;
    /* limb5_S: drives; pivots */
    const REAL drives_share_0_0 = t103 + minus_limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wx_by_limb4_P,
      t545 = minus_limb5_S_balance_wy * drives_share_0_0, /* limb1 */
      t133 = minus_limb5_S_balance_wx_by_limb1_P * limb5_S_balance_wy_by_limb1_P,
      t135 = t133 - minus_limb5_S_balance_wx_by_limb2_P * minus_limb5_S_balance_wy_by_limb2_P,
      t137 = t135 + minus_limb5_S_balance_wx_by_limb3_P * limb5_S_balance_wy_by_limb3_P,
      minus_drives_share_0_1 = t137 - minus_limb5_S_balance_wx_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P,
      t572 = minus_limb5_S_balance_wy * minus_drives_share_0_1, /* limb1 */
      t568 = t545 + minus_limb5_S_balance_wx * minus_drives_share_0_1, /* limb1 */
      t139 = minus_drives_share_0_1 * minus_drives_share_0_1,
      t117 = limb5_S_balance_wy_by_limb1_P * limb5_S_balance_wy_by_limb1_P,
      t122 = t117 + minus_limb5_S_balance_wy_by_limb2_P * minus_limb5_S_balance_wy_by_limb2_P,
      t127 = t122 + limb5_S_balance_wy_by_limb3_P * limb5_S_balance_wy_by_limb3_P,
      drives_share_1_1 = t127 + minus_limb5_S_balance_wy_by_limb4_P * minus_limb5_S_balance_wy_by_limb4_P,
      value_determinant = drives_share_0_0 * drives_share_1_1 - t139;
    REAL checked1 = value_determinant;
    const REAL t573 = minus_limb5_S_balance_wx * drives_share_1_1 + t572, /* limb1 */
      t140 = 1.0 / value_determinant, t569 = t140 * t568, /* limb1 */
      t574 = t140 * t573, /* limb1 */
      limb1_P_drive = limb5_S_balance_wy_by_limb1_P * t569 - minus_limb5_S_balance_wx_by_limb1_P * t574;
    WRITE(u, 0, limb1_P_drive);
    REAL checked2 = limb1_P_drive;
    const REAL limb2_P_drive = -(minus_limb5_S_balance_wx_by_limb2_P * t574 + minus_limb5_S_balance_wy_by_limb2_P * t569);
    WRITE(u, 1, limb2_P_drive);
    REAL checked3 = limb2_P_drive;
    const REAL t581 = minus_limb5_S_balance_wy_by_limb4_P * t569; /* limb4 */
    RESULT(checked0, u, 2, limb5_S_balance_wy_by_limb3_P * t569 - minus_limb5_S_balance_wx_by_limb3_P * t574);
    RESULT(checked1, u, 3, -(minus_limb5_S_balance_wx_by_limb4_P * t574 + t581));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    /* else status 6: not on the mechanism */
    NOT_ABOVE(t584, 1.0e-12, 6);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_lower_limb_length, 6.62327e-10) OR /* where the points of limb3_lower coincide */
        SMALL(limb2_lower_limb_length, 6.62327e-10) OR /* where the points of limb2_lower coincide */
        SMALL(limb4_lower_limb_length, 6.62327e-10) OR /* where the points of limb4_lower coincide */
        SMALL(limb1_lower_limb_length, 6.62327e-10) OR /* where the points of limb1_lower coincide */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.0171000000000005e-10) OR /* where limb1_U2.mn cannot balance platform.moment_z */
        SMALL(value_determinant, 2.393867125597279e-10), /* where equations that are solved at once lose rank, as drives do at a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

#if !defined(THREE_UPS_UPU_S_VECTORS)

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_inverse_dynamics_packed_lane(const double *restrict q,
    const double *restrict v, const double *restrict a, double *restrict u, const double *restrict sine,
    const double *restrict cosine)
{
    typedef three_ups_upu_s_vector4 lanes4;
    const double limb5_S_q_qw = q[12], limb5_S_q_qx = q[13], limb5_S_q_qy = q[14], limb5_S_q_qz = q[15],
      limb5_S_v_wz = v[14], limb1_U_0_sin = sine[0], limb1_U_0_cos = cosine[0], limb1_lower_sin = sine[1],
      limb1_lower_cos = cosine[1];
    const lanes4 limb_U_v_0 = {v[0], v[3], v[6], v[9]},
      signed_limb_lower_sin = {limb1_lower_sin, sine[3], sine[5], sine[7]};
    /* limbs together: velocities, eq. (6) */
    const lanes4 signed_limb_lower_omega_x = limb_U_v_0 * signed_limb_lower_sin,
      limb_U_v_1 = {v[1], v[4], v[7], v[10]};
    /* limbs together: accelerations; momentum rate, eq. (35); geometry */
    const lanes4 signed_limb_lower_alpha_still_y = limb_U_v_1 * signed_limb_lower_omega_x,
      limb_U_a_0 = {a[0], a[3], a[6], a[9]}, limb_lower_cos = {limb1_lower_cos, cosine[3], cosine[5],
        cosine[7]},
      lanes_2 = (lanes4){1.0, 1.0, -1.0, -1.0} * limb_lower_cos,
      signed_limb_lower_alpha_y = signed_limb_lower_alpha_still_y - limb_U_a_0 * lanes_2,
      signed_limb_lower_U_zx = signed_limb_lower_alpha_still_y + signed_limb_lower_alpha_y,
      lanes_5 = k9 * signed_limb_lower_alpha_still_y + k8 * signed_limb_lower_alpha_y,
      limb_upper_offset_x = (lanes4){q[2], q[5], q[8], q[11]} + limb_upper_phase,
      lanes_6 = limb_upper_offset_x * signed_limb_lower_U_zx,
      signed_limb_lower_rate_fz = limb_lower_mx * signed_limb_lower_U_zx,
      lanes_7 = {gravity_z, -gravity_z, -gravity_z, gravity_z},
      each_limb1_U_0_sin = {limb1_U_0_sin, sine[2], sine[4], sine[6]},
      lanes_8 = lanes_6 + lanes_7 * each_limb1_U_0_sin, signed_limb_lower_omega_y = limb_U_v_0 * lanes_2,
      limb_lower_U_still_xy = signed_limb_lower_omega_x * signed_limb_lower_omega_y,
      lanes_9 = 2.0 * signed_limb_lower_omega_y, limb_P_v = {v[2], v[5], v[8], v[11]},
      signed_limb_upper_acc_z = limb_P_v * lanes_9 - lanes_8;
    /* limbs together: balance, eqs. (40)-(47); accelerations; reciprocal wrenches, eq. (10) */
    const lanes4 lanes_11 = limb_upper_offset_x * (limb_lower_m * signed_limb_upper_acc_z +
        signed_limb_lower_rate_fz),
      lanes_12 = limb_lower_mx * signed_limb_upper_acc_z - lanes_11,
      lanes_13 = {gravity_z_limb_lower_mx, -gravity_z_limb_lower_mx, -gravity_z_limb_lower_mx,
        gravity_z_limb_lower_mx},
      lanes_14 = lanes_2 * (lanes_12 + (lanes_13 * each_limb1_U_0_sin + lanes_5)),
      limb_lower_joint_force_my = signed_limb_lower_sin * (k10 * (limb_U_v_1 * signed_limb_lower_omega_y)) -
        lanes_14,
      lanes_16 = signed_limb_lower_omega_y * signed_limb_lower_omega_y,
      limb_U_0_moment_z = limb_lower_joint_force_my + k3 * limb_U_a_0,
      each_limb1_U_0_lever_mz_by_limb1_U2_fz = lanes_2 * limb_upper_offset_x,
      lanes_17 = 1.0 / each_limb1_U_0_lever_mz_by_limb1_U2_fz, each_limb1_U2_part_fz = lanes_17 *
        limb_U_0_moment_z,
      each_limb1_U2_arm_y = (lanes4){param_R, param_R, -param_R, -param_R} * limb_lower_cos,
      lanes_19 = each_limb1_U2_arm_y * each_limb1_U2_part_fz, lanes_20 = lanes_2 * lanes_19,
      lanes_21 = signed_limb_lower_sin * lanes_19,
      each_limb1_U2_arm_x = limb_upper_offset_x - param_R * signed_limb_lower_sin,
      lanes_23 = each_limb1_U2_arm_x * each_limb1_U2_part_fz, lanes_25 = lanes_20 - signed_limb_lower_sin *
        lanes_23,
      lanes_27 = lanes_21 + lanes_2 * lanes_23, each_limb1_U_0_cos = {limb1_U_0_cos, cosine[2], cosine[4],
        cosine[6]},
      lanes_28 = each_limb1_U_0_cos * lanes_25, lanes_29 = each_limb1_U_0_sin * lanes_25,
      limb_U_a_1 = {a[1], a[4], a[7], a[10]}, limb_lower_U_yx = limb_U_a_1 + limb_lower_U_still_xy,
      lanes_30 = k8 * limb_lower_U_still_xy, lanes_31 = limb_upper_offset_x * limb_lower_U_yx,
      limb_lower_rate_fy = limb_lower_mx * limb_lower_U_yx,
      signed_limb_U_0_acc_y = (lanes4){gravity_z, -gravity_z, -gravity_z, gravity_z} * each_limb1_U_0_cos,
      minus_limb_lower_acc_y = signed_limb_lower_sin * signed_limb_U_0_acc_y,
      limb_upper_moment_z = limb_lower_mx * minus_limb_lower_acc_y,
      limb_lower_acc_x = lanes_2 * signed_limb_U_0_acc_y,
      limb_upper_acc_y = limb_P_v * (2.0 * limb_U_v_1) + (lanes_31 - minus_limb_lower_acc_y),
      lanes_36 = limb_upper_offset_x * (limb_lower_m * limb_upper_acc_y - limb_lower_rate_fy),
      lanes_37 = limb_lower_mx * limb_upper_acc_y - lanes_36,
      minus_limb_lower_moment_z = lanes_37 + (limb_upper_moment_z - (lanes_30 + k9 * limb_U_a_1)),
      lanes_40 = lanes_2 * lanes_17, lanes_41 = each_limb1_U2_arm_x * (minus_limb_lower_moment_z * lanes_40),
      minus_limb_lower_U_still_xx = lanes_16 + limb_U_v_1 * limb_U_v_1,
      minus_limb_upper_acc_still_x_2 = limb_upper_offset_x * minus_limb_lower_U_still_xx - limb_lower_acc_x,
      limb_lower_force_x = limb_lower_m * ((lanes4){a[2], a[5], a[8], a[11]} -
        minus_limb_upper_acc_still_x_2),
      lanes_44 = each_limb1_U2_arm_y * (limb_lower_mx * minus_limb_lower_U_still_xx + limb_lower_force_x) -
        lanes_41,
      lanes_46 = lanes_28 + each_limb1_U_0_sin * lanes_44, lanes_48 = lanes_29 - each_limb1_U_0_cos *
        lanes_44;
    /* platform: geometry; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const double t2 = limb5_S_q_qw * limb5_S_q_qw, t3 = limb5_S_q_qx * limb5_S_q_qx, t4 = t2 + t3,
      t5 = limb5_S_q_qy * limb5_S_q_qy, t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7,
      t10 = 4.0 - 2.0 * t8, platform_turn_zz = 1.0 - t10 * (t3 + t5), platform_turn_yy = 1.0 - t10 * (t3 +
        t6),
      platform_turn_xx = 1.0 - t7 * t10, t14 = limb5_S_q_qz * t10, t15 = limb5_S_q_qy * t14,
      t17 = limb5_S_q_qw * (limb5_S_q_qx * t10), t32 = limb5_S_q_qy * t10, platform_turn_zy = t15 + t17,
      platform_turn_yz = t15 - t17,
      minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - (k12 * (v[13] * limb5_S_v_wz) + k13
        * a[12]),
      t225 = platform_turn_xx * minus_platform_rate_mx, t166 = limb5_S_q_qx * t14, t34 = limb5_S_q_qw * t14,
      t167 = limb5_S_q_qw * t32, t33 = limb5_S_q_qx * t32, platform_turn_zx = t166 - t167,
      platform_turn_xz = t166 + t167, t171 = platform_turn_zx * minus_platform_rate_mx,
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (k12 * (v[12] * limb5_S_v_wz) - k13 *
        a[13]),
      t176 = t171 - platform_turn_zy * platform_rate_my, platform_rate_mz = platform_Izz * a[14],
      t215 = lanes_46[1] + (t176 - platform_turn_zz * platform_rate_mz - lanes_46[0]),
      minus_platform_joint_force_mz = lanes_46[3] - (lanes_46[2] - t215), t228 = platform_turn_xz *
        platform_rate_mz,
      t259 = platform_turn_yz * platform_rate_mz;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; balance, eqs. (40)-(47) */
    const double t29 = limb1_U_0_cos * platform_turn_zy,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * lanes_17[0],
      t21 = limb1_U2_constraint_mn_couple_x - each_limb1_U2_arm_y[0] * minus_limb1_U_factor_0_by_3,
      limb1_U2_arm_x = each_limb1_U2_arm_x[0], t24 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3,
      t45 = limb1_lower_sin * t21, t26 = limb1_lower_cos * t21 + limb1_lower_sin * t24,
      platform_joint_force_mx_by_limb1_U2_mn = t45 - limb1_lower_cos * t24, t40 = limb1_U_0_cos * t26,
      t27 = limb1_U_0_sin * t26, t31 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - t29);
    /* platform: balance, eqs. (40)-(47); geometry */
    const double t257 = platform_turn_yy * platform_rate_my, platform_turn_xy = t33 - t34,
      t260 = (t33 + t34) * minus_platform_rate_mx - t257 - t259,
      t229 = t225 - platform_turn_xy * platform_rate_my - t228,
      limb1_U2_constraint_mn_couple_z = t31 - limb1_lower_sin * platform_turn_xy,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x *
        (limb1_U2_constraint_mn_couple_z * lanes_40[0]),
      t238 = -lanes_27[2] + (t229 - lanes_27[0] + lanes_48[1]), minus_platform_joint_force_mx = lanes_48[3] +
        t238,
      t266 = lanes_48[2] - (lanes_27[1] - (t260 + lanes_48[0])), minus_platform_joint_force_my = -lanes_27[3]
        + t266,
      platform_joint_force_mz_by_limb1_U2_mn = t40 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3,
      t42 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn, limb1_U2_part_mn = t42 *
        minus_platform_joint_force_mz,
      t39 = t27 - limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb5_S_balance_wx = platform_joint_force_mx_by_limb1_U2_mn * limb1_U2_part_mn -
        minus_platform_joint_force_mx,
      minus_limb5_S_balance_wy = t39 * limb1_U2_part_mn + minus_platform_joint_force_my;
    /* limbs together: balance, eqs. (40)-(47); drives */
    const lanes4 each_limb1_U2_part_mn_by_limb1_P = each_limb1_U_0_sin * each_limb1_U2_arm_y * t42,
      each_platform_joint_force_my_by_limb1_P = each_limb1_U_0_cos * each_limb1_U2_arm_y,
      lanes_49 = {t39, platform_joint_force_mx_by_limb1_U2_mn, t39, platform_joint_force_mx_by_limb1_U2_mn},
      lanes_50 = lanes_49 * each_limb1_U2_part_mn_by_limb1_P,
      lanes_51 = {platform_joint_force_mx_by_limb1_U2_mn, t39, platform_joint_force_mx_by_limb1_U2_mn, t39},
      each_limb5_S_balance_wx_by_limb1_P = lanes_51 * each_limb1_U2_part_mn_by_limb1_P,
      each_limb5_S_balance_wy_by_limb1_P = each_platform_joint_force_my_by_limb1_P + lanes_50,
      lanes_52 = each_limb5_S_balance_wy_by_limb1_P * each_limb5_S_balance_wx_by_limb1_P;
    const double t57 = lanes_52[2] + (lanes_52[1] + lanes_52[0]), /* limb5_S */
      minus_drives_share_0_1 = lanes_52[3] + t57, t239 = minus_drives_share_0_1 * limb5_S_balance_wx; /* limb1 */
    const lanes4 lanes_53 = each_limb5_S_balance_wy_by_limb1_P * each_limb5_S_balance_wy_by_limb1_P,
      lanes_54 = each_limb5_S_balance_wx_by_limb1_P * each_limb5_S_balance_wx_by_limb1_P;
    const double t245 = lanes_54[2] + (lanes_53[1] + lanes_54[0]), /* limb5_S */
      drives_share_0_0 = lanes_53[3] + t245, t268 = t239 - drives_share_0_0 * minus_limb5_S_balance_wy, /* limb1 */
      t280 = minus_drives_share_0_1 * minus_limb5_S_balance_wy, /* limb1 */
      t269 = minus_drives_share_0_1 * minus_drives_share_0_1, /* drives */
      t275 = lanes_53[2] + (lanes_54[1] + lanes_53[0]), /* limb5_S */
      drives_share_1_1 = lanes_54[3] + t275, minus_determinant = t269 - drives_share_1_1 * drives_share_0_0,
      t282 = t280 - drives_share_1_1 * limb5_S_balance_wx, /* limb1 */
      t277 = 1.0 / minus_determinant, /* mechanism */
      t278 = t268 * t277, /* limb1 */
      t283 = t277 * t282; /* limb1 */
    const lanes4 lanes_56 = each_limb5_S_balance_wy_by_limb1_P * (lanes4){t278, t283, t278, t283},
      signed_limb_P_drive = lanes_56 + each_limb5_S_balance_wx_by_limb1_P * (lanes4){t283, t278, t283, t278};
    u[0] = -signed_limb_P_drive[0];
    u[1] = signed_limb_P_drive[1];
    u[2] = -signed_limb_P_drive[2];
    u[3] = -(-signed_limb_P_drive[3]);
    const lanes4 every = (lanes4)((three_ups_upu_s_vector4_mask)(each_limb1_U_0_lever_mz_by_limb1_U2_fz +
        signed_limb_P_drive) | ((each_limb1_U_0_lever_mz_by_limb1_U2_fz <= (lanes4){6.233100000000001e-10,
        6.3211e-10, 6.4044e-10, 6.284e-10}) & (each_limb1_U_0_lever_mz_by_limb1_U2_fz >=
        -(lanes4){6.233100000000001e-10, 6.3211e-10, 6.4044e-10, 6.284e-10})));
    return fabs(platform_joint_force_mz_by_limb1_U2_mn) <= 4.0171000000000005e-10 || fabs(minus_determinant)
        <= 2.393867125597279e-10 || !(t8 >= 0.999999 && t8 <= 1.000001) ? (double)NAN :
        ((platform_joint_force_mz_by_limb1_U2_mn + minus_determinant) + (every[0] + every[1])) + (every[2] +
        every[3]);
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
    typedef three_ups_upu_s_vector4 lanes4;
    const double limb5_S_q_qw = q[12], limb5_S_q_qx = q[13], limb5_S_q_qy = q[14], limb5_S_q_qz = q[15],
      limb5_S_y_dot_qy = y_dot[1], limb1_U_0_sin = sine[0], limb1_U_0_cos = cosine[0], limb1_lower_sin =
        sine[1],
      limb1_lower_cos = cosine[1];
    /* limb5_S: geometry; rates that follow */
    const double t2 = limb5_S_q_qw * limb5_S_q_qw, t3 = limb5_S_q_qx * limb5_S_q_qx, t4 = t2 + t3,
      t5 = limb5_S_q_qy * limb5_S_q_qy, t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7, t11 = t3
        + t6,
      t110 = t3 + t5, t10 = 4.0 - 2.0 * t8, platform_turn_yy = 1.0 - t10 * t11, t76 = k2 - 0.5 * t8,
      platform_turn_xx = 1.0 - t7 * t10, platform_turn_zz = 1.0 - t10 * t110, t14 = limb5_S_q_qz * t10,
      t15 = limb5_S_q_qy * t14, t17 = limb5_S_q_qw * (limb5_S_q_qx * t10), t32 = limb5_S_q_qy * t10,
      platform_turn_zy = t15 + t17, platform_turn_yz = t15 - t17,
      t30 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      t31 = limb1_lower_cos * t30, /* limb1 */
      t174 = limb1_lower_sin * t30, /* limb1 */
      t33 = limb5_S_q_qx * t32, t109 = limb5_S_q_qw * t32, t34 = limb5_S_q_qw * t14, t108 = limb5_S_q_qx *
        t14,
      platform_turn_xy = t33 - t34, platform_turn_yx = t33 + t34,
      limb1_U2_constraint_mn_couple_z = t31 - limb1_lower_sin * platform_turn_xy;
    const lanes4 limb_upper_offset_x = (lanes4){q[2], q[5], q[8], q[11]} + limb_upper_phase,
      limb_lower_cos = {limb1_lower_cos, cosine[3], cosine[5], cosine[7]},
      each_limb1_U_0_lever_mz_by_limb1_U2_fz = limb_lower_cos * limb_upper_offset_x,
      lanes_2 = (lanes4){1.0, 1.0, -1.0, -1.0} / each_limb1_U_0_lever_mz_by_limb1_U2_fz,
      lanes_3 = limb_lower_cos * lanes_2;
    /* limb1: rates that follow; reciprocal wrenches, eq. (10); balance, eqs. (40)-(47) */
    const double limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * lanes_3[0];
    const lanes4 signed_limb_lower_sin = {limb1_lower_sin, sine[3], sine[5], sine[7]},
      each_limb1_U2_arm_x = limb_upper_offset_x - param_R * signed_limb_lower_sin;
    const double limb1_U2_arm_x = each_limb1_U2_arm_x[0],
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      t41 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t38 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * lanes_2[0];
    const lanes4 each_limb1_upper_position_x = signed_limb_lower_sin * limb_upper_offset_x + (-param_R);
    const double t79 = (-each_limb1_upper_position_x[0]) * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t79;
    /* limb5_S: pivots */
    const double minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t41;
    /* limb5_S: rates that follow */
    const double t81 = 1.0 / minus_limb5_S_pivot_wz,
      t83 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t38, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t81 * t83, t78 = limb5_S_q_qx * t76,
      t84 = t78 * limb5_S_null_space_wz_by_limb5_S_wy, t77 = limb5_S_q_qw * t76, a_pivot = 0.5 * (t77 + t84),
      t86 = 1.0 / a_pivot, t90 = limb5_S_q_qy * t76, t91 = t90 * limb5_S_null_space_wz_by_limb5_S_wy,
      t87 = limb5_S_q_qz * t76, t94 = t86 * (0.5 * (t87 - t91)), t88 = 0.5 * t87, a_pivot_2 = 0.5 * t77 + t88
        * t94,
      limb5_S_null_space_wx_by_limb5_S_qx = 1.0 / a_pivot_2;
    /* platform: velocities, eq. (6); accelerations; geometry */
    const double limb5_S_joint_rate_wx = limb5_S_null_space_wx_by_limb5_S_qx * (y_dot[0] - limb5_S_y_dot_qy *
        t94),
      limb5_S_joint_rate_wy = t86 * (limb5_S_y_dot_qy + t88 * limb5_S_joint_rate_wx),
      limb5_S_joint_rate_wz = t81 * (t83 * limb5_S_joint_rate_wy), t117 = platform_turn_zy *
        limb5_S_joint_rate_wz,
      platform_omega_y = t117 + (platform_turn_yy * limb5_S_joint_rate_wy + platform_turn_xy *
        limb5_S_joint_rate_wx),
      t136 = platform_turn_zy * platform_omega_y, platform_turn_zx = t108 - t109, platform_turn_xz = t108 +
        t109,
      t123 = platform_turn_zx * limb5_S_joint_rate_wz,
      platform_omega_x = t123 + (platform_turn_yx * limb5_S_joint_rate_wy + platform_turn_xx *
        limb5_S_joint_rate_wx),
      t138 = t136 + platform_turn_zx * platform_omega_x, t112 = platform_turn_zz * limb5_S_joint_rate_wz,
      platform_omega_z = t112 + (platform_turn_yz * limb5_S_joint_rate_wy + platform_turn_xz *
        limb5_S_joint_rate_wx),
      t139 = platform_turn_zz * platform_omega_z + t138;
    const lanes4 each_limb1_U_0_cos = {limb1_U_0_cos, cosine[2], cosine[4], cosine[6]},
      lanes_6 = (lanes4){1.0, -1.0, 1.0, -1.0} * t139, lanes_7 = each_limb1_U_0_cos * lanes_6;
    const double t144 = platform_turn_yy * platform_omega_y + platform_turn_yx * platform_omega_x,
      t145 = platform_turn_yz * platform_omega_z + t144, t557 = k12 * (platform_omega_z * platform_omega_y),
      t128 = platform_turn_xy * platform_omega_y + platform_turn_xx * platform_omega_x,
      platform_U_still_xz = platform_omega_z * platform_omega_x, t129 = platform_turn_xz * platform_omega_z +
        t128,
      t549 = k12 * platform_U_still_xz;
    const lanes4 each_limb1_U_0_sin = {limb1_U_0_sin, sine[2], sine[4], sine[6]}, lanes_8 = {t145, t129, t145,
        t129},
      lanes_11 = (lanes4){1.0, -1.0, 1.0, -1.0} * lanes_7;
    /* limbs together: accelerations; velocities, eq. (6) */
    const lanes4 lanes_14 = lanes_11 - (lanes4){1.0, -1.0, 1.0, -1.0} * (each_limb1_U_0_sin * lanes_8);
    const double t147 = lanes_14[0], /* limb5_S */
      t179 = limb1_lower_cos * t129 - limb1_lower_sin * t147; /* limb1 */
    const lanes4 lanes_15 = each_limb1_U_0_cos * limb5_S_joint_rate_wz,
      lanes_16 = each_limb1_U_0_sin * limb5_S_joint_rate_wz,
      each_limb5_S_joint_rate_wy = {limb5_S_joint_rate_wy, limb5_S_joint_rate_wx, limb5_S_joint_rate_wy,
        limb5_S_joint_rate_wx},
      lanes_18 = (lanes4){1.0, -1.0, 1.0, -1.0} * each_limb5_S_joint_rate_wy,
      lanes_22 = lanes_2 * (each_limb1_upper_position_x * (lanes_15 - each_limb1_U_0_sin * lanes_18)),
      each_limb5_S_joint_rate_wx = {limb5_S_joint_rate_wx, limb5_S_joint_rate_wy, limb5_S_joint_rate_wx,
        limb5_S_joint_rate_wy},
      limb_U_joint_rate_0 = each_limb5_S_joint_rate_wx - (lanes4){1.0, -1.0, 1.0, -1.0} * lanes_22,
      lanes_26 = lanes_16 + each_limb1_U_0_cos * lanes_18, limb_lower_omega_y = limb_lower_cos *
        limb_U_joint_rate_0;
    /* limb1: velocities, eq. (6); loop closure */
    const double limb1_lower_omega_y = limb_lower_omega_y[0], t180 = t179 - limb1_lower_omega_y;
    const lanes4 signed_limb_U_joint_rate_1 = lanes_3 * (each_limb1_U2_arm_x * lanes_26);
    const double limb1_U_joint_rate_1 = signed_limb_U_joint_rate_1[0], t197 = limb1_U_joint_rate_1 * t180;
    const lanes4 lanes_29 = each_limb1_U_0_sin * lanes_6 + each_limb1_U_0_cos * lanes_8;
    /* limb1: loop closure; velocities, eq. (6) */
    const double t173 = limb1_U_joint_rate_1 - lanes_29[0], t199 = t197 + t173 * limb1_lower_omega_y;
    const lanes4 lanes_31 = (lanes4){1.0, -1.0, 1.0, -1.0} * limb_lower_omega_y,
      signed_limb_lower_alpha_still_x = signed_limb_U_joint_rate_1 * lanes_31;
    const double t201 = limb1_U2_constraint_mn_couple_x * (t199 - signed_limb_lower_alpha_still_x[0]);
    const lanes4 lanes_33 = signed_limb_lower_sin * ((lanes4){k10, -k10, k10, -k10} *
        signed_limb_lower_alpha_still_x);
    const double t186 = limb1_lower_sin * t129 + limb1_lower_cos * t147;
    const lanes4 signed_limb_lower_omega_x = signed_limb_lower_sin * limb_U_joint_rate_0;
    const double limb1_lower_omega_x = signed_limb_lower_omega_x[0], t187 = t186 - limb1_lower_omega_x,
      t202 = limb1_U2_constraint_mn_couple_z * (limb1_lower_omega_y * t187 - t180 * limb1_lower_omega_x) +
        t201,
      t188 = limb1_U2_constraint_mn_couple_z * t180, t181 = limb1_U2_constraint_mn_couple_x * t180,
      limb1_U2_opening_mn = t174 + limb1_lower_cos * platform_turn_xy,
      t183 = t173 * (limb1_U2_opening_mn * t173 + t181),
      minus_limb1_U2_opening_bias_mn = t183 + t187 * (t188 + limb1_U2_opening_mn * t187) + t202;
    /* limbs together: accelerations; reciprocal wrenches, eq. (10) */
    const lanes4 lanes_34 = lanes_14 * limb_U_joint_rate_0, lanes_35 = each_limb1_U2_arm_x * lanes_34,
      each_limb1_U2_arm_y = param_R * limb_lower_cos, lanes_36 = each_limb1_U2_arm_y * lanes_34,
      lanes_38 = (lanes4){1.0, 1.0, -1.0, -1.0} * (each_limb1_U2_arm_y * lanes_26),
      lanes_42 = lanes_35 - (lanes4){1.0, -1.0, -1.0, 1.0} * (lanes_38 * signed_limb_U_joint_rate_1),
      lanes_43 = limb_lower_cos * signed_limb_U_joint_rate_1,
      lanes_47 = lanes_29 * (lanes_38 - param_R * lanes_43) + lanes_42;
    const double t203 = limb1_U_factor_1_by_3 * lanes_47[0] - minus_limb1_U2_opening_bias_mn; /* limb5_S */
    const lanes4 lanes_48 = limb_upper_offset_x * lanes_43,
      lanes_50 = each_limb1_upper_position_x * (limb_U_joint_rate_0 * lanes_29),
      lanes_51 = signed_limb_lower_sin * signed_limb_U_joint_rate_1,
      lanes_55 = lanes_29 * (param_R * lanes_51) - lanes_36,
      lanes_58 = (lanes4){1.0, 1.0, -1.0, -1.0} * (limb_lower_cos * lanes_38),
      lanes_61 = lanes_58 - (lanes4){1.0, 1.0, -1.0, -1.0} * (limb_upper_offset_x * lanes_51),
      lanes_65 = lanes_61 * limb_U_joint_rate_0 - (lanes4){1.0, -1.0, 1.0, -1.0} * lanes_50,
      lanes_67 = lanes_61 * (lanes4){t129, t145, t129, t145},
      lanes_73 = (lanes4){1.0, -1.0, 1.0, -1.0} * (signed_limb_lower_sin * lanes_38 + lanes_48) * lanes_14 +
        lanes_65,
      lanes_74 = lanes_67 - lanes_73;
    /* limb5_S: accelerations */
    const double limb5_S_joint_acc_still_wz = t81 * (minus_limb1_U_factor_0_by_3 * lanes_74[0] + t203),
      t206 = 0.5 * (t78 * limb5_S_joint_acc_still_wz), t212 = 0.5 * (t78 * t145 - t90 * t129 - t77 * t139),
      t213 = t129 * t212, t243 = t145 * t212, t219 = 0.5 * (t90 * t139 - t87 * t145 - t77 * t129),
      t221 = t213 - t139 * t219, t239 = t77 * t145, t235 = 0.5 * (t90 * limb5_S_joint_acc_still_wz),
      t237 = t78 * t139, t227 = 0.5 * (t87 * t139 + (t90 * t145 + t78 * t129)),
      t232 = t206 - (y_ddot[1] - 0.5 * (t221 - t145 * t227)), t233 = t94 * t232, t245 = t129 * t227,
      t244 = t139 * (0.5 * (t87 * t129 - t237 - t239)) - t243,
      limb5_S_joint_acc_wx = limb5_S_null_space_wx_by_limb5_S_qx * (t233 + (t235 + (y_ddot[0] - 0.5 * (t244 -
        t245)))),
      minus_limb5_S_joint_acc_wy = t86 * (t232 - t88 * limb5_S_joint_acc_wx),
      t254 = t81 * (t83 * minus_limb5_S_joint_acc_wy); /* limb4 */
    /* limbs together: accelerations; momentum rate, eq. (35) */
    const lanes4 lanes_75 = each_limb1_U_0_cos * t254,
      each_limb5_S_joint_acc_wy = {minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx,
        minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx},
      lanes_79 = lanes_2 * (each_limb1_upper_position_x * (lanes_75 - each_limb1_U_0_sin *
        each_limb5_S_joint_acc_wy)),
      each_limb5_S_joint_acc_wx = {limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx,
        minus_limb5_S_joint_acc_wy},
      lanes_80 = each_limb5_S_joint_acc_wx + lanes_79,
      signed_limb_U_joint_acc_still_0 = lanes_2 * (lanes_74 - each_limb1_upper_position_x *
        (each_limb1_U_0_cos * limb5_S_joint_acc_still_wz)),
      signed_limb_U_joint_acc_0 = lanes_80 + signed_limb_U_joint_acc_still_0,
      signed_limb_lower_U_xz = limb_lower_cos * signed_limb_U_joint_acc_0,
      signed_limb_U_0_rate_mz = k3 * signed_limb_U_joint_acc_0,
      signed_limb_lower_alpha_still_y = signed_limb_U_joint_rate_1 * signed_limb_lower_omega_x,
      signed_limb_lower_alpha_y = signed_limb_lower_alpha_still_y - signed_limb_lower_U_xz,
      signed_limb_lower_U_still_xy = lanes_31 * signed_limb_lower_omega_x,
      signed_limb_lower_U_zx = signed_limb_lower_alpha_still_y + signed_limb_lower_alpha_y,
      lanes_86 = k9 * signed_limb_lower_alpha_still_y + k8 * signed_limb_lower_alpha_y,
      signed_limb_lower_rate_fz = limb_lower_mx * signed_limb_lower_U_zx,
      lanes_88 = gravity_z * each_limb1_U_0_sin + limb_upper_offset_x * signed_limb_lower_U_zx,
      signed_limb_upper_acc_z = lanes_88 - lanes_38 * (2.0 * limb_lower_omega_y), lanes_91 = lanes_31 *
        lanes_31;
    /* limbs together: balance, eqs. (40)-(47) */
    const lanes4 lanes_92 = limb_upper_offset_x * (signed_limb_lower_rate_fz - limb_lower_m *
        signed_limb_upper_acc_z),
      lanes_93 = lanes_92 + limb_lower_mx * signed_limb_upper_acc_z,
      signed_limb_lower_joint_force_my = lanes_33 - limb_lower_cos * (gravity_z_limb_lower_mx *
        each_limb1_U_0_sin + lanes_86 - lanes_93),
      each_limb1_U2_part_fz = lanes_2 * (signed_limb_U_0_rate_mz + signed_limb_lower_joint_force_my),
      lanes_95 = each_limb1_U2_arm_x * each_limb1_U2_part_fz, lanes_96 = each_limb1_U2_arm_y *
        each_limb1_U2_part_fz,
      lanes_100 = signed_limb_lower_sin * lanes_95 - limb_lower_cos * lanes_96,
      lanes_102 = limb_lower_cos * lanes_95 + signed_limb_lower_sin * lanes_96,
      lanes_104 = (lanes4){1.0, -1.0, -1.0, 1.0} * lanes_100, lanes_105 = each_limb1_U_0_cos * lanes_104,
      lanes_106 = each_limb1_U_0_sin * lanes_104;
    /* limbs together: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const lanes4 lanes_107 = each_limb1_U_0_sin * t254;
    const double limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz - t254;
    const lanes4 lanes_108 = each_limb1_U_0_sin * limb5_S_joint_acc_still_wz,
      lanes_110 = lanes_107 + each_limb1_U_0_cos * each_limb5_S_joint_acc_wy,
      lanes_112 = each_limb1_U2_arm_y * lanes_110,
      signed_limb_U_joint_acc_1 = lanes_3 * (each_limb1_U2_arm_x * lanes_110 - (lanes_47 + each_limb1_U2_arm_x
        * lanes_108)),
      signed_limb_P_joint_acc = lanes_112 - (each_limb1_U2_arm_y * lanes_108 - lanes_55),
      signed_limb_lower_U_yx = signed_limb_lower_U_still_xy - signed_limb_U_joint_acc_1,
      lanes_119 = k8 * signed_limb_lower_U_still_xy - k9 * signed_limb_U_joint_acc_1,
      lanes_120 = limb_upper_offset_x * signed_limb_lower_U_yx,
      signed_limb_lower_rate_fy = (lanes4){limb_lower_mx, -limb_lower_mx, limb_lower_mx, -limb_lower_mx} *
        signed_limb_lower_U_yx,
      minus_limb_U_0_acc_y = (lanes4){-gravity_z, gravity_z, -gravity_z, gravity_z} * each_limb1_U_0_cos,
      signed_limb_lower_acc_y = signed_limb_lower_sin * minus_limb_U_0_acc_y,
      lanes_125 = signed_limb_lower_acc_y + (lanes4){1.0, -1.0, 1.0, -1.0} * lanes_120,
      signed_limb_upper_moment_z = (lanes4){-limb_lower_mx, limb_lower_mx, -limb_lower_mx, limb_lower_mx} *
        signed_limb_lower_acc_y,
      signed_limb_lower_rate_mz = signed_limb_upper_moment_z - lanes_119,
      minus_limb_lower_acc_x = limb_lower_cos * minus_limb_U_0_acc_y,
      signed_limb_upper_acc_y = lanes_38 * (2.0 * signed_limb_U_joint_rate_1) + lanes_125,
      minus_limb_lower_U_still_xx = signed_limb_U_joint_rate_1 * signed_limb_U_joint_rate_1 + lanes_91;
    /* limbs together: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    const lanes4 lanes_130 = limb_upper_offset_x * (signed_limb_lower_rate_fy - limb_lower_m *
        signed_limb_upper_acc_y),
      signed_limb_upper_rate_mz = (lanes4){limb_lower_mx, -limb_lower_mx, limb_lower_mx, -limb_lower_mx} *
        signed_limb_upper_acc_y,
      signed_limb_lower_moment_z = signed_limb_lower_rate_mz + ((lanes4){1.0, -1.0, 1.0, -1.0} * lanes_130 +
        signed_limb_upper_rate_mz),
      lanes_135 = each_limb1_U2_arm_x * (lanes_3 * signed_limb_lower_moment_z),
      each_limb1_upper_acc_still_x = minus_limb_lower_acc_x + limb_upper_offset_x *
        minus_limb_lower_U_still_xx,
      minus_limb_lower_force_x = limb_lower_m * (each_limb1_upper_acc_still_x + (lanes4){1.0, -1.0, -1.0, 1.0}
        * signed_limb_P_joint_acc),
      lanes_138 = each_limb1_U2_arm_y * (limb_lower_mx * minus_limb_lower_U_still_xx -
        minus_limb_lower_force_x),
      lanes_141 = lanes_138 - (lanes4){1.0, -1.0, -1.0, 1.0} * lanes_135;
    const double t24 = limb1_U2_arm_x * minus_limb1_U_factor_0_by_3, /* limb1 */
      t21 = limb1_U2_constraint_mn_couple_x - each_limb1_U2_arm_y[0] * minus_limb1_U_factor_0_by_3; /* limb1 */
    const lanes4 lanes_143 = lanes_105 - each_limb1_U_0_sin * lanes_141,
      lanes_145 = lanes_106 + each_limb1_U_0_cos * lanes_141;
    /* platform: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const double t550 = platform_turn_zy * limb5_S_joint_acc_wz,
      platform_alpha_y = t550 - (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy *
        limb5_S_joint_acc_wx),
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - (t549 - k13 * platform_alpha_y),
      t637 = platform_turn_xy * platform_rate_my, t659 = platform_turn_yy * platform_rate_my,
      t556 = platform_turn_zy * platform_rate_my, minus_platform_moment_x = gravity_z_platform_mz *
        platform_turn_zy,
      t558 = platform_turn_zx * limb5_S_joint_acc_wz, t544 = platform_turn_zz * limb5_S_joint_acc_wz,
      t545 = platform_turn_yz * minus_limb5_S_joint_acc_wy,
      platform_alpha_x = t558 - (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx *
        limb5_S_joint_acc_wx),
      minus_platform_rate_mx = minus_platform_moment_x - (t557 + k13 * platform_alpha_x);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const double t565 = t556 - platform_turn_zx * minus_platform_rate_mx,
      platform_rate_mz = platform_Izz * (t544 - (t545 - platform_turn_xz * limb5_S_joint_acc_wx)),
      t624 = -lanes_143[1] - (platform_turn_zz * platform_rate_mz + t565 - lanes_143[0]),
      platform_joint_force_mz = -lanes_143[3] + (lanes_143[2] - t624),
      t640 = platform_turn_xz * platform_rate_mz + (t637 - platform_turn_xx * minus_platform_rate_mx),
      t662 = platform_turn_yz * platform_rate_mz + (t659 - platform_turn_yx * minus_platform_rate_mx),
      t646 = -lanes_102[2] + (lanes_102[0] + t640 - (-lanes_145[1])), platform_joint_force_mx = -lanes_145[3]
        + t646,
      t668 = lanes_145[2] + (lanes_102[1] - (t662 + lanes_145[0])),
      minus_platform_joint_force_my = -lanes_102[3] + t668, t45 = limb1_lower_sin * t21, /* limb1 */
      t26 = limb1_lower_cos * t21 + limb1_lower_sin * t24, /* limb1 */
      platform_joint_force_mx_by_limb1_U2_mn = t45 - limb1_lower_cos * t24,
      platform_joint_force_mz_by_limb1_U2_mn = limb1_U_0_cos * t26 + t41,
      t42 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn, minus_limb1_U2_part_mn = t42 *
        platform_joint_force_mz,
      t39 = limb1_U_0_sin * t26 - t38,
      minus_limb5_S_balance_wx = platform_joint_force_mx_by_limb1_U2_mn * minus_limb1_U2_part_mn -
        platform_joint_force_mx,
      limb5_S_balance_wy = t39 * minus_limb1_U2_part_mn - minus_platform_joint_force_my;
    /* limbs together: balance, eqs. (40)-(47); drives */
    const lanes4 each_limb1_U2_part_mn_by_limb1_P = each_limb1_U_0_sin * each_limb1_U2_arm_y * t42,
      each_platform_joint_force_my_by_limb1_P = each_limb1_U_0_cos * each_limb1_U2_arm_y,
      lanes_146 = {t39, platform_joint_force_mx_by_limb1_U2_mn, t39, platform_joint_force_mx_by_limb1_U2_mn},
      lanes_147 = lanes_146 * each_limb1_U2_part_mn_by_limb1_P,
      lanes_148 = {platform_joint_force_mx_by_limb1_U2_mn, t39, platform_joint_force_mx_by_limb1_U2_mn, t39},
      each_limb5_S_balance_wx_by_limb1_P = lanes_148 * each_limb1_U2_part_mn_by_limb1_P,
      each_limb5_S_balance_wy_by_limb1_P = each_platform_joint_force_my_by_limb1_P + lanes_147,
      lanes_149 = each_limb5_S_balance_wy_by_limb1_P * each_limb5_S_balance_wx_by_limb1_P;
    const double t57 = lanes_149[2] + (lanes_149[1] + lanes_149[0]), /* limb5_S */
      minus_drives_share_0_1 = lanes_149[3] + t57,
      t647 = minus_drives_share_0_1 * minus_limb5_S_balance_wx; /* limb1 */
    const lanes4 lanes_150 = each_limb5_S_balance_wy_by_limb1_P * each_limb5_S_balance_wy_by_limb1_P,
      lanes_151 = each_limb5_S_balance_wx_by_limb1_P * each_limb5_S_balance_wx_by_limb1_P;
    const double t70 = lanes_151[2] + (lanes_150[1] + lanes_151[0]), /* limb5_S */
      drives_share_0_0 = lanes_150[3] + t70, t670 = t647 - drives_share_0_0 * limb5_S_balance_wy, /* limb1 */
      t673 = minus_drives_share_0_1 * limb5_S_balance_wy, /* limb1 */
      t58 = minus_drives_share_0_1 * minus_drives_share_0_1, /* drives */
      t64 = lanes_150[2] + (lanes_151[1] + lanes_150[0]), /* limb5_S */
      drives_share_1_1 = lanes_151[3] + t64, minus_determinant = t58 - drives_share_1_1 * drives_share_0_0,
      t675 = t673 - drives_share_1_1 * minus_limb5_S_balance_wx, /* limb1 */
      t72 = 1.0 / minus_determinant, /* mechanism */
      t671 = t72 * t670, /* limb1 */
      t676 = t72 * t675; /* limb1 */
    const lanes4 lanes_153 = each_limb5_S_balance_wy_by_limb1_P * (lanes4){t671, t676, t671, t676},
      signed_limb_P_drive = lanes_153 + each_limb5_S_balance_wx_by_limb1_P * (lanes4){t676, t671, t676, t671};
    u[0] = signed_limb_P_drive[0];
    u[1] = -signed_limb_P_drive[1];
    u[2] = -signed_limb_P_drive[2];
    u[3] = signed_limb_P_drive[3];
    const lanes4 every = (lanes4)((three_ups_upu_s_vector4_mask)(each_limb1_U_0_lever_mz_by_limb1_U2_fz +
        signed_limb_P_drive) | ((each_limb1_U_0_lever_mz_by_limb1_U2_fz <= (lanes4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10}) & (each_limb1_U_0_lever_mz_by_limb1_U2_fz >= -(lanes4){6.62327e-10,
        6.62327e-10, 6.62327e-10, 6.62327e-10})));
    return fabs(minus_limb5_S_pivot_wz) <= 1.0e-09 || fabs(a_pivot) <= 1.0e-09 || fabs(a_pivot_2) <= 1.0e-09
        || fabs(platform_joint_force_mz_by_limb1_U2_mn) <= 4.0171000000000005e-10 || fabs(minus_determinant)
        <= 2.393867125597279e-10 || !(t8 >= 0.999999 && t8 <= 1.000001) ? (double)NAN :
        (((platform_joint_force_mz_by_limb1_U2_mn + minus_determinant) + (minus_limb5_S_pivot_wz + a_pivot)) +
        ((a_pivot_2 + every[0]) + (every[1] + every[2]))) + every[3];
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
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
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
      t545 = minus_limb5_S_balance_wy * drives_share_0_0, /* limb1 */
      t562 = t550 - lanes_147[0] + lanes_119[1] - lanes_147[2], minus_limb5_S_balance_wx = t562 + lanes_119[3]
        + t566,
      t573 = minus_limb5_S_balance_wx * drives_share_1_1 + minus_limb5_S_balance_wy * minus_drives_share_0_1, /* limb1 */
      t569 = t140 * (t545 + minus_limb5_S_balance_wx * minus_drives_share_0_1), /* limb1 */
      t574 = t140 * t573; /* limb1 */
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
