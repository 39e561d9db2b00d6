/*
 * three_ups_upu_s: forward_dynamics.
 *   forward_dynamics; forward_dynamics_independent; forward_dynamics_reactions
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

BODY(three_ups_upu_s_forward_dynamics)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t29 = limb5_S_q_qw * limb5_S_q_qw,
      t30 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t31 = t29 + t30,
      t32 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t33 = limb5_S_q_qz * limb5_S_q_qz,
      t34 = t32 + t33, t35 = t31 + t34, t37 = 4.0 - 2.0 * t35, t42 = t30 + t32,
      platform_turn_yy = 1.0 - t37 * (t30 + t33), platform_turn_zz = 1.0 - t37 * t42,
      platform_turn_xx = 1.0 - t34 * t37, t40 = limb5_S_q_qy * t37, t90 = limb5_S_q_qx * t40,
      t41 = limb5_S_q_qw * t40, t38 = limb5_S_q_qz * t37, t82 = limb5_S_q_qw * (limb5_S_q_qx * t37),
      t91 = limb5_S_q_qw * t38, platform_turn_yx = t90 + t91, platform_turn_xy = t90 - t91,
      limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13),
      t100 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, t80 = limb5_S_q_qy * t38,
      t39 = limb5_S_q_qx * t38, platform_turn_yz = t80 - t82, platform_turn_zy = t80 + t82,
      limb5_S_v_wz = READ(v, 14), platform_twist_wy = t100 + limb5_S_v_wz * platform_turn_yz;
    /* limb3: geometry; free motion */
    const REAL limb3_U_0_sin = SINES(sine, 4), t284 = limb3_U_0_sin * platform_twist_wy, platform_turn_zx = t39 - t41,
      platform_turn_xz = t39 + t41,
      t106 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy, /* platform */
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t106, limb3_U_0_cos = SINES(cosine, 4);
    /* limb3: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t286 = t284 - limb3_U_0_cos * platform_twist_wz, limb3_U_v_0 = READ(v, 6), t440 = limb3_U_v_0 * t286,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin, limb3_U_v_1 = READ(v, 7),
      limb3_P_v = READ(v, 8), t453 = limb3_S_arm_x * t440, t449 = limb3_U_v_1 * limb3_P_v, t454 = t453 + t449,
      t275 = limb3_U_0_cos * platform_twist_wy + limb3_U_0_sin * platform_twist_wz,
      limb3_lower_cos = SINES(cosine, 5), t287 = limb3_U_v_1 * limb3_lower_cos,
      t458 = t454 - t275 * (limb3_P_v + param_R * t287), t288 = limb3_upper_offset_x * t287,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked0 = minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t47 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz, t389 = limb3_lower_cos * t47, t459 = t458 * t389,
      limb3_U_follows_1_by_limb3_S_0 = limb3_S_arm_x * t389,
      limb3_lower_composite_first_x = limb_lower_m * limb3_upper_offset_x, t48 = k7 - limb3_lower_composite_first_x,
      t266 = limb3_lower_composite_first_x - t48, t49 = limb3_upper_offset_x * t48, t450 = t449 * t266,
      limb3_U_mass_matrix_1_by_limb3_U_1 = k9 - t49, t50 = t49 - k8, t460 = limb3_U_mass_matrix_1_by_limb3_U_1 * t459,
      t391 = limb3_U_follows_1_by_limb3_S_0 * (limb3_U_mass_matrix_1_by_limb3_U_1 * limb3_U_follows_1_by_limb3_S_0),
      t51 = limb3_lower_cos * t50,
      t263 = minus_limb3_lower_sin * t51 + limb3_lower_cos * (minus_limb3_lower_sin * t50),
      limb3_U_mass_matrix_0_by_limb3_U_0 = k3 - limb3_lower_cos * t51, t447 = 0.5 * t263,
      minus_limb3_U_0_U_still_xx = limb3_U_v_0 * limb3_U_v_0, t451 = minus_limb3_U_0_U_still_xx * t447 + t450,
      limb3_U_0_acc_y = gravity_z * limb3_U_0_cos,
      limb3_U_handed_force_1 = limb3_upper_offset_x * (limb_lower_m * (minus_limb3_lower_sin * limb3_U_0_acc_y)) + t451 - t460,
      t461 = limb3_U_follows_1_by_limb3_S_0 * limb3_U_handed_force_1,
      limb3_P_generalised_force = limb_lower_m * (limb3_lower_cos * limb3_U_0_acc_y) - READ(u, 2),
      limb3_S_arm_y = param_R * limb3_lower_cos, t441 = limb3_S_arm_y * t440,
      t278 = limb3_U_v_1 * minus_limb3_lower_sin, t444 = t441 - t275 * (param_R * t278), t276 = limb3_U_v_0 * t275,
      t279 = limb3_upper_offset_x * t278, t445 = limb_lower_m * t444,
      t268 = limb3_lower_cos * (limb3_lower_cos * t266),
      t438 = minus_limb3_U_0_U_still_xx * (0.5 * t268) + limb3_U_v_1 * limb3_U_v_1 * (0.5 * t266),
      minus_limb3_S_handed_force_0 = limb3_S_arm_y * (limb3_P_generalised_force - t438 + t445) - t461,
      t462 = limb3_U_0_sin * minus_limb3_S_handed_force_0, t489 = limb3_U_0_cos * minus_limb3_S_handed_force_0,
      platform_rate_mx = k12 * (limb5_S_v_wy * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zy,
      t430 = platform_turn_zx * platform_rate_mx, /* platform */
      minus_platform_rate_my = k12 * (limb5_S_v_wx * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zx;
    /* limb2: geometry; free motion */
    const REAL limb2_U_0_sin = SINES(cosine, 2),
      t463 = t430 - platform_turn_zy * minus_platform_rate_my - t462, /* limb5_S */
      t248 = limb2_U_0_sin * platform_twist_wz,
      t128 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy, /* platform */
      platform_twist_wx = t128 + limb5_S_v_wz * platform_turn_xz, minus_limb2_U_0_cos = SINES(sine, 2);
    /* limb2: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t250 = t248 + minus_limb2_U_0_cos * platform_twist_wx, limb2_U_v_0 = READ(v, 3),
      t338 = limb2_U_v_0 * t250, limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      limb2_lower_sin = SINES(sine, 3), limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin,
      limb2_U_v_1 = READ(v, 4), limb2_P_v = READ(v, 5), t351 = limb2_S_arm_x * t338, t347 = limb2_U_v_1 * limb2_P_v,
      t352 = t351 + t347, t239 = minus_limb2_U_0_cos * platform_twist_wz - limb2_U_0_sin * platform_twist_wx,
      limb2_lower_cos = SINES(cosine, 3), t251 = limb2_U_v_1 * limb2_lower_cos,
      t356 = t352 + t239 * (limb2_P_v - param_R * t251), t252 = limb2_upper_offset_x * t251,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t57 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz, t68 = limb2_lower_cos * t57, t357 = t356 * t68,
      limb2_U_follows_1_by_limb2_S_0 = limb2_S_arm_x * t68,
      limb2_lower_composite_first_x = limb_lower_m * limb2_upper_offset_x, t58 = k7 - limb2_lower_composite_first_x,
      t230 = limb2_lower_composite_first_x - t58, t59 = limb2_upper_offset_x * t58, t348 = t347 * t230,
      limb2_U_mass_matrix_1_by_limb2_U_1 = k9 - t59, t60 = t59 - k8, t358 = limb2_U_mass_matrix_1_by_limb2_U_1 * t357,
      t70 = limb2_U_follows_1_by_limb2_S_0 * (limb2_U_mass_matrix_1_by_limb2_U_1 * limb2_U_follows_1_by_limb2_S_0),
      t61 = limb2_lower_cos * t60, t227 = limb2_lower_sin * t61 + limb2_lower_cos * (limb2_lower_sin * t60),
      limb2_U_mass_matrix_0_by_limb2_U_0 = k3 - limb2_lower_cos * t61, t345 = 0.5 * t227,
      minus_limb2_U_0_U_still_xx = limb2_U_v_0 * limb2_U_v_0, t349 = minus_limb2_U_0_U_still_xx * t345 - t348,
      minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin,
      limb2_U_handed_force_1 = limb2_upper_offset_x * (limb_lower_m * (limb2_lower_sin * minus_limb2_U_0_acc_y)) - t349 - t358,
      t359 = limb2_U_follows_1_by_limb2_S_0 * limb2_U_handed_force_1,
      minus_limb2_P_generalised_force = limb_lower_m * (limb2_lower_cos * minus_limb2_U_0_acc_y) + READ(u, 1),
      minus_limb2_S_arm_y = param_R * limb2_lower_cos, t339 = minus_limb2_S_arm_y * t338,
      t242 = limb2_U_v_1 * limb2_lower_sin, t342 = t339 - t239 * (param_R * t242), t240 = limb2_U_v_0 * t239,
      t243 = limb2_upper_offset_x * t242, t343 = limb_lower_m * t342,
      t232 = limb2_lower_cos * (limb2_lower_cos * t230),
      t336 = minus_limb2_U_0_U_still_xx * (0.5 * t232) + limb2_U_v_1 * limb2_U_v_1 * (0.5 * t230),
      minus_limb2_S_handed_force_0 = minus_limb2_S_arm_y * (minus_limb2_P_generalised_force + t336 + t343) - t359;
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6),
      t464 = minus_limb2_U_0_cos * minus_limb2_S_handed_force_0 + t463, /* limb5_S */
      t360 = limb2_U_0_sin * minus_limb2_S_handed_force_0; /* limb2 */
    /* limb4: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t214 = limb4_U_0_sin * platform_twist_wz + minus_limb4_U_0_cos * platform_twist_wx,
      limb4_U_v_0 = READ(v, 9), t303 = limb4_U_v_0 * t214, limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      minus_limb4_lower_sin = SINES(sine, 7), limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      limb4_U_v_1 = READ(v, 10), limb4_P_v = READ(v, 11), t316 = limb4_S_arm_x * t303, t312 = limb4_U_v_1 * limb4_P_v,
      t317 = t316 + t312, t203 = minus_limb4_U_0_cos * platform_twist_wz - limb4_U_0_sin * platform_twist_wx,
      limb4_lower_cos = SINES(cosine, 7), t215 = limb4_U_v_1 * limb4_lower_cos,
      t321 = t317 + t203 * (limb4_P_v + param_R * t215), t216 = limb4_upper_offset_x * t215,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked2 = minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t11 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz, t22 = limb4_lower_cos * t11, t322 = t321 * t22,
      limb4_U_follows_1_by_limb4_S_0 = limb4_S_arm_x * t22,
      limb4_lower_composite_first_x = limb_lower_m * limb4_upper_offset_x, t12 = k7 - limb4_lower_composite_first_x,
      t194 = limb4_lower_composite_first_x - t12, t13 = limb4_upper_offset_x * t12, t313 = t312 * t194,
      limb4_U_mass_matrix_1_by_limb4_U_1 = k9 - t13, t14 = t13 - k8, t323 = limb4_U_mass_matrix_1_by_limb4_U_1 * t322,
      t24 = limb4_U_follows_1_by_limb4_S_0 * (limb4_U_mass_matrix_1_by_limb4_U_1 * limb4_U_follows_1_by_limb4_S_0),
      t15 = limb4_lower_cos * t14,
      t191 = minus_limb4_lower_sin * t15 + limb4_lower_cos * (minus_limb4_lower_sin * t14),
      limb4_U_mass_matrix_0_by_limb4_U_0 = k3 - limb4_lower_cos * t15, t310 = 0.5 * t191,
      minus_limb4_U_0_U_still_xx = limb4_U_v_0 * limb4_U_v_0, t314 = minus_limb4_U_0_U_still_xx * t310 + t313,
      minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      t315 = limb4_upper_offset_x * (limb_lower_m * (minus_limb4_lower_sin * minus_limb4_U_0_acc_y)) - t314,
      t324 = limb4_U_follows_1_by_limb4_S_0 * (t315 + t323),
      minus_limb4_P_generalised_force = limb_lower_m * (limb4_lower_cos * minus_limb4_U_0_acc_y) + READ(u, 3),
      limb4_S_arm_y = param_R * limb4_lower_cos, t304 = limb4_S_arm_y * t303,
      t206 = limb4_U_v_1 * minus_limb4_lower_sin, t307 = t304 + t203 * (param_R * t206), t204 = limb4_U_v_0 * t203,
      t207 = limb4_upper_offset_x * t206, t308 = limb_lower_m * t307,
      t196 = limb4_lower_cos * (limb4_lower_cos * t194),
      t301 = minus_limb4_U_0_U_still_xx * (0.5 * t196) + limb4_U_v_1 * limb4_U_v_1 * (0.5 * t194),
      limb4_S_handed_force_0 = limb4_S_arm_y * (minus_limb4_P_generalised_force + t301 - t308) - t324,
      limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0),
      t465 = minus_limb4_U_0_cos * limb4_S_handed_force_0 - t464, /* limb5_S */
      t325 = limb4_U_0_sin * limb4_S_handed_force_0,
      t119 = limb1_U_0_sin * platform_twist_wy - limb1_U_0_cos * platform_twist_wz, /* limb5_S */
      limb1_U_v_0 = READ(v, 0), t107 = limb1_U_0_sin * platform_twist_wz, /* limb5_S */
      t163 = limb1_U_v_0 * t119; /* limb5_S */
    /* limb1: accelerations; free motion; inertia */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2), limb1_lower_sin = SINES(sine, 1),
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin, limb1_U_v_1 = READ(v, 1),
      limb1_P_v = READ(v, 2), t164 = limb1_U2_arm_x * t163, /* limb5_S */
      t165 = limb1_U_v_1 * limb1_P_v, t166 = t164 + t165, /* limb5_S */
      t108 = limb1_U_0_cos * platform_twist_wy + t107, /* limb5_S */
      limb1_lower_cos = SINES(cosine, 1), t120 = limb1_U_v_1 * limb1_lower_cos,
      t170 = t166 - t108 * (limb1_P_v - param_R * t120), /* limb5_S */
      t121 = limb1_upper_offset_x * t120,
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked3 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t2 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t94 = limb1_lower_cos * t2, t424 = t170 * t94,
      limb1_lower_composite_first_x = limb_lower_m * limb1_upper_offset_x, t3 = k7 - limb1_lower_composite_first_x,
      t180 = limb1_lower_composite_first_x - t3, t4 = limb1_upper_offset_x * t3, t421 = t165 * t180,
      limb1_U_mass_matrix_1_by_limb1_U_1 = k9 - t4, t5 = t4 - k8, t425 = limb1_U_mass_matrix_1_by_limb1_U_1 * t424,
      t6 = limb1_lower_cos * t5, t177 = limb1_lower_sin * t6 + limb1_lower_cos * (limb1_lower_sin * t5),
      limb1_U_mass_matrix_0_by_limb1_U_0 = k3 - limb1_lower_cos * t6, t419 = 0.5 * t177,
      minus_limb1_U_0_U_still_xx = limb1_U_v_0 * limb1_U_v_0, t422 = minus_limb1_U_0_U_still_xx * t419 - t421,
      limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    /* limb1: free motion; rates that follow; accelerations */
    const REAL minus_limb1_U_handed_force_1 = limb1_upper_offset_x * (limb_lower_m * (limb1_lower_sin * limb1_U_0_acc_y)) + t422 + t425,
      limb1_P_generalised_force = limb_lower_m * (limb1_lower_cos * limb1_U_0_acc_y) - READ(u, 0),
      limb1_U_follows_1_by_limb1_U2_0 = limb1_U2_arm_x * t94,
      t426 = limb1_U_follows_1_by_limb1_U2_0 * minus_limb1_U_handed_force_1,
      t373 = limb1_U_follows_1_by_limb1_U2_0 * (limb1_U_mass_matrix_1_by_limb1_U_1 * limb1_U_follows_1_by_limb1_U2_0),
      minus_limb1_U2_arm_y = param_R * limb1_lower_cos, t413 = minus_limb1_U2_arm_y * t163,
      t111 = limb1_U_v_1 * limb1_lower_sin, t416 = t413 + t108 * (param_R * t111), t112 = limb1_upper_offset_x * t111,
      t417 = limb_lower_m * t416, t182 = limb1_lower_cos * (limb1_lower_cos * t180),
      t411 = minus_limb1_U_0_U_still_xx * (0.5 * t182) + limb1_U_v_1 * limb1_U_v_1 * (0.5 * t180),
      limb1_U2_handed_force_0 = minus_limb1_U2_arm_y * (limb1_P_generalised_force - t411 - t417) - t426,
      t466 = limb1_U_0_sin * limb1_U2_handed_force_0 - t465, /* limb5_S */
      t485 = limb1_U_0_cos * limb1_U2_handed_force_0;
    /* limb3: geometry */
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    /* limb3: free motion; rates that follow */
    const REAL t277 = limb3_upper_position_x * t276,
      minus_limb3_U_follows_0_by_limb3_S_1 = limb3_upper_position_x * t47, t281 = t279 + limb3_P_v * limb3_lower_cos,
      t292 = platform_twist_wx * t281,
      t291 = t277 - limb3_U_v_0 * t281 - t286 * (limb3_P_v * minus_limb3_lower_sin - t288),
      t294 = t47 * (t291 + t292), t295 = limb3_U_mass_matrix_0_by_limb3_U_0 * t294,
      t271 = t263 * (limb3_U_v_0 * limb3_U_v_1) - t268 * (limb3_U_v_0 * limb3_P_v),
      minus_limb3_U_handed_force_0 = limb3_lower_cos * (limb3_upper_offset_x * (limb_lower_m_gravity_z * limb3_U_0_sin)) + t271 - t295,
      limb3_S_handed_force_1 = minus_limb3_U_follows_0_by_limb3_S_1 * minus_limb3_U_handed_force_0,
      t467 = limb3_U_0_cos * limb3_S_handed_force_1 + t466, /* limb5_S */
      t484 = limb3_U_0_sin * limb3_S_handed_force_1;
    /* limb2: geometry */
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    /* limb2: free motion; rates that follow */
    const REAL t241 = minus_limb2_upper_position_y * t240,
      limb2_U_follows_0_by_limb2_S_1 = minus_limb2_upper_position_y * t57, t245 = t243 - limb2_P_v * limb2_lower_cos,
      t256 = platform_twist_wy * t245, t255 = t241 + limb2_U_v_0 * t245 + t250 * (limb2_P_v * limb2_lower_sin + t252),
      t258 = t57 * (t255 - t256), t259 = limb2_U_mass_matrix_0_by_limb2_U_0 * t258,
      t235 = t227 * (limb2_U_v_0 * limb2_U_v_1) + t232 * (limb2_U_v_0 * limb2_P_v),
      t236 = limb2_lower_cos * (limb2_upper_offset_x * (limb_lower_m_gravity_z * minus_limb2_U_0_cos)) + t235,
      limb2_U_handed_force_0 = t236 + t259,
      limb2_S_handed_force_1 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_handed_force_0,
      t468 = limb2_U_0_sin * limb2_S_handed_force_1 - t467, /* limb5_S */
      t260 = minus_limb2_U_0_cos * limb2_S_handed_force_1;
    /* limb4: geometry */
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    /* limb4: free motion; rates that follow */
    const REAL t205 = limb4_upper_position_y * t204,
      minus_limb4_U_follows_0_by_limb4_S_1 = limb4_upper_position_y * t11, t209 = t207 + limb4_P_v * limb4_lower_cos,
      t220 = platform_twist_wy * t209,
      t219 = t205 + limb4_U_v_0 * t209 + t214 * (limb4_P_v * minus_limb4_lower_sin - t216),
      t222 = t11 * (t219 - t220), t223 = limb4_U_mass_matrix_0_by_limb4_U_0 * t222,
      t199 = t191 * (limb4_U_v_0 * limb4_U_v_1) - t196 * (limb4_U_v_0 * limb4_P_v),
      t200 = limb4_lower_cos * (limb4_upper_offset_x * (limb_lower_m_gravity_z * minus_limb4_U_0_cos)) - t199,
      limb4_U_handed_force_0 = t200 - t223,
      minus_limb4_S_handed_force_1 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_handed_force_0,
      t469 = limb4_U_0_sin * minus_limb4_S_handed_force_1 - t468, /* limb5_S */
      t224 = minus_limb4_U_0_cos * minus_limb4_S_handed_force_1, t109 = limb1_U_v_0 * t108; /* limb5_S */
    /* limb1: loop closure; free motion; rates that follow */
    const REAL t133 = limb1_U_v_1 - t108,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t110 = minus_limb1_upper_position_x * t109, /* limb5_S */
      t114 = t112 - limb1_P_v * limb1_lower_cos, t130 = platform_twist_wx * t114, /* limb5_S */
      t124 = t110 - limb1_U_v_0 * t114 - t119 * (limb1_P_v * limb1_lower_sin + t121), /* limb5_S */
      t131 = t124 + t130, /* limb5_S */
      t187 = t2 * t131, t188 = limb1_U_mass_matrix_0_by_limb1_U_0 * t187,
      t185 = t177 * (limb1_U_v_0 * limb1_U_v_1) + t182 * (limb1_U_v_0 * limb1_P_v),
      minus_limb1_U_handed_force_0 = limb1_lower_cos * (limb1_upper_offset_x * (limb_lower_m_gravity_z * limb1_U_0_sin)) - t185 + t188,
      limb1_U_follows_0_by_limb1_U2_1 = minus_limb1_upper_position_x * t2,
      minus_limb1_U2_handed_force_1 = limb1_U_follows_0_by_limb1_U2_1 * minus_limb1_U_handed_force_0,
      t470 = limb1_U_0_cos * minus_limb1_U2_handed_force_1 - t469, /* limb5_S */
      t483 = limb1_U_0_sin * minus_limb1_U2_handed_force_1,
      t137 = limb1_lower_sin * t119 + limb1_lower_cos * platform_twist_wx,
      t146 = limb1_lower_cos * t119 - limb1_lower_sin * platform_twist_wx,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, t138 = limb1_lower_omega_y - t137,
      t141 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t133 - limb1_U_v_1 * t138),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t142 = limb1_U2_constraint_mn_couple_x * t141, limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin,
      t147 = limb1_lower_omega_x + t146, t149 = limb1_lower_omega_x * t138 - limb1_lower_omega_y * t147,
      t88 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t152 = limb1_lower_sin * t88,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t88 - limb1_lower_sin * platform_turn_xy,
      t151 = t142 - limb1_U2_constraint_mn_couple_z * t149,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t94,
      t171 = t170 * limb1_U_factor_1_by_3, /* limb5_S */
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      t155 = limb1_U2_constraint_mn_couple_z * t138, t158 = limb1_U2_constraint_mn_couple_x * t138,
      limb1_U2_opening_mn = t152 + limb1_lower_cos * platform_turn_xy,
      t157 = t147 * (limb1_U2_opening_mn * t147 + t155),
      t172 = t151 - (t157 - t133 * (t158 - limb1_U2_opening_mn * t133)) - t171, /* limb5_S */
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t2,
      t173 = minus_limb1_U_factor_0_by_3 * t131 - t172, /* limb5_S */
      t84 = minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t84,
      t368 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    checked0 = checked0 + minus_limb5_S_pivot_wz;
    const REAL t97 = 1.0 / minus_limb5_S_pivot_wz, /* limb5_S */
      minus_limb5_S_joint_acc_still_wz = t97 * t173,
      limb5_S_null_space_wz_by_limb5_S_wy = t97 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t368);
    /* limb3: free motion */
    const REAL t53 = minus_limb3_U_follows_0_by_limb3_S_1 * limb3_U_mass_matrix_0_by_limb3_U_0,
      t393 = minus_limb3_U_follows_0_by_limb3_S_1 * t53, t392 = limb3_S_arm_y * (k20 * limb3_lower_cos) + t391,
      t395 = limb3_U_0_cos * (t393 - t392), t396 = limb3_U_0_cos * t395, t397 = t392 + t396, t510 = t393 - t396,
      t477 = limb3_U_0_sin * t395, t44 = k12 * platform_turn_zz, /* platform */
      t398 = k13 + platform_turn_zz * t44 + t397, /* limb5_S */
      t45 = platform_turn_xz * t44, /* platform */
      t63 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_mass_matrix_0_by_limb2_U_0, /* limb2 */
      t64 = limb2_U_follows_0_by_limb2_S_1 * t63, /* limb2 */
      t71 = minus_limb2_S_arm_y * (k20 * limb2_lower_cos) + t70, /* limb2 */
      t73 = limb2_U_0_sin * (t64 - t71), /* limb2 */
      t382 = limb2_U_0_sin * t73, /* limb2 */
      t399 = t71 + t382 + t398, /* limb5_S */
      t528 = t64 - t382, /* limb2 */
      t74 = minus_limb2_U_0_cos * t73, /* limb2 */
      t17 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_mass_matrix_0_by_limb4_U_0, /* limb4 */
      t18 = minus_limb4_U_follows_0_by_limb4_S_1 * t17, /* limb4 */
      t25 = limb4_S_arm_y * (k20 * limb4_lower_cos) + t24, /* limb4 */
      t27 = limb4_U_0_sin * (t18 - t25), /* limb4 */
      t380 = limb4_U_0_sin * t27, /* limb4 */
      t400 = t25 + t380 + t399, /* limb5_S */
      t523 = t18 - t380, /* limb4 */
      t28 = minus_limb4_U_0_cos * t27, /* limb4 */
      t8 = limb1_U_follows_0_by_limb1_U2_1 * limb1_U_mass_matrix_0_by_limb1_U_0, /* limb1 */
      t375 = limb1_U_follows_0_by_limb1_U2_1 * t8, /* limb1 */
      t374 = minus_limb1_U2_arm_y * (k20 * limb1_lower_cos) + t373, /* limb1 */
      t377 = limb1_U_0_cos * (t375 - t374), /* limb1 */
      t378 = limb1_U_0_cos * t377; /* limb1 */
    /* limb5_S: free motion; accelerations */
    const REAL limb5_S_handed_inertia_wz = t374 + t378 + t400, t507 = t375 - t378, /* limb1 */
      t472 = limb1_U_0_sin * t377, /* limb1 */
      t471 = limb5_S_null_space_wz_by_limb5_S_wy * (limb5_S_handed_inertia_wz * minus_limb5_S_joint_acc_still_wz + t470),
      t515 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz,
      t327 = platform_turn_xx * platform_rate_mx,
      t491 = t485 + (platform_turn_yx * platform_rate_mx - platform_turn_yy * minus_platform_rate_my - t489),
      t495 = t483 + (limb4_U_handed_force_0 + (limb2_U_handed_force_0 - (t484 - t491))),
      t363 = minus_limb3_U_handed_force_0 - (t325 + (t327 - platform_turn_xy * minus_platform_rate_my - t360)),
      t366 = minus_limb1_U_handed_force_0 - (t224 - (t260 + t363)), t475 = k12 * platform_turn_yz,
      t500 = minus_limb2_U_0_cos * t63, /* limb2 */
      t480 = limb4_U_0_sin * t17 - (limb2_U_0_sin * t63 - (platform_turn_zz * t475 - t477)), t481 = t472 - t480,
      t517 = t481 + (t481 - t515), limb5_S_reduced_force_wy = t471 - (t481 * minus_limb5_S_joint_acc_still_wz + t495),
      t518 = limb5_S_null_space_wz_by_limb5_S_wy * t517, t502 = minus_limb4_U_0_cos * t17, /* limb4 */
      t513 = limb4_U_mass_matrix_0_by_limb4_U_0 + (limb2_U_mass_matrix_0_by_limb2_U_0 + (k13 + platform_turn_yz * t475 + t510)),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = t507 + t513 - t518;
    checked1 = checked1 + limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t519 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t503 = platform_turn_xz * t475 + limb3_U_0_sin * t53 - t500 + t502,
      limb5_S_handed_inertia_wz_by_limb5_S_wx = limb1_U_0_cos * t8 + (t28 + (t45 - limb3_U_0_cos * t53 + t74)),
      t505 = t503 - limb1_U_0_sin * t8,
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t505 + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz_by_limb5_S_wx,
      limb5_S_reduced_force_wx = limb5_S_handed_inertia_wz_by_limb5_S_wx * minus_limb5_S_joint_acc_still_wz + t366;
    /* platform: accelerations; pivots; free motion */
    const REAL t520 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t519,
      t531 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t520, t533 = limb5_S_reduced_force_wy * t519,
      t522 = limb5_S_reduced_force_wx - limb5_S_reduced_force_wy * t520,
      t529 = limb3_U_mass_matrix_0_by_limb3_U_0 + (k13 + platform_turn_xz * (k12 * platform_turn_xz)) + t528,
      pivot_1 = limb1_U_mass_matrix_0_by_limb1_U_0 + (t523 + t529) - t531;
    checked2 = checked2 + pivot_1;
    const REAL limb5_S_joint_acc_wx = t522 / pivot_1, minus_limb5_S_joint_acc_wy = t520 * limb5_S_joint_acc_wx - t533,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy * minus_limb5_S_joint_acc_wy,
      t583 = platform_turn_zz * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_z = t583 + (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz * limb5_S_joint_acc_wx);
    RESULT(checked3, a, 14, -minus_platform_alpha_z);
    const REAL t579 = platform_turn_zy * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_y = t579 + (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy * limb5_S_joint_acc_wx);
    RESULT(checked0, a, 13, -minus_platform_alpha_y);
    const REAL t575 = platform_turn_zx * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_x = t575 + (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx * limb5_S_joint_acc_wx);
    RESULT(checked1, a, 12, -minus_platform_alpha_x);
    const REAL t572 = minus_limb4_U_0_cos * minus_limb5_S_joint_acc_wz + limb4_U_0_sin * limb5_S_joint_acc_wx; /* limb4 */
    RESULT(checked2, a, 11, t307 - limb4_S_arm_y * t572);
    RESULT(checked3, a, 10, limb4_U_follows_1_by_limb4_S_0 * t572 - t322);
    const REAL t568 = minus_limb4_U_follows_0_by_limb4_S_1 * (limb4_U_0_sin * minus_limb5_S_joint_acc_wz - minus_limb4_U_0_cos * limb5_S_joint_acc_wx); /* limb4 */
    RESULT(checked0, a, 9, -(minus_limb5_S_joint_acc_wy + (t222 + t568)));
    const REAL t562 = limb3_U_0_sin * minus_limb5_S_joint_acc_wz + limb3_U_0_cos * minus_limb5_S_joint_acc_wy; /* limb3 */
    RESULT(checked1, a, 8, t444 + limb3_S_arm_y * t562);
    RESULT(checked2, a, 7, -(t459 + limb3_U_follows_1_by_limb3_S_0 * t562));
    const REAL t558 = minus_limb3_U_follows_0_by_limb3_S_1 * (limb3_U_0_cos * minus_limb5_S_joint_acc_wz - limb3_U_0_sin * minus_limb5_S_joint_acc_wy); /* limb3 */
    RESULT(checked3, a, 6, limb5_S_joint_acc_wx + (t294 + t558));
    const REAL t552 = minus_limb2_U_0_cos * minus_limb5_S_joint_acc_wz + limb2_U_0_sin * limb5_S_joint_acc_wx; /* limb2 */
    RESULT(checked0, a, 5, minus_limb2_S_arm_y * t552 - t342);
    RESULT(checked1, a, 4, limb2_U_follows_1_by_limb2_S_0 * t552 - t357);
    const REAL t548 = limb2_U_follows_0_by_limb2_S_1 * (limb2_U_0_sin * minus_limb5_S_joint_acc_wz - minus_limb2_U_0_cos * limb5_S_joint_acc_wx); /* limb2 */
    RESULT(checked2, a, 3, t258 + t548 - minus_limb5_S_joint_acc_wy);
    const REAL t535 = limb1_U_0_cos * minus_limb5_S_joint_acc_wz, /* limb1 */
      t542 = limb1_U_0_sin * minus_limb5_S_joint_acc_wz + limb1_U_0_cos * minus_limb5_S_joint_acc_wy; /* limb1 */
    RESULT(checked3, a, 2, -(t416 + minus_limb1_U2_arm_y * t542));
    RESULT(checked0, a, 1, -(t424 + limb1_U_follows_1_by_limb1_U2_0 * t542));
    RESULT(checked1, a, 0, limb5_S_joint_acc_wx - (t187 + limb1_U_follows_0_by_limb1_U2_1 * (t535 - limb1_U_0_sin * minus_limb5_S_joint_acc_wy)));
    /* else status 5: no rotation */
    NOT_BELOW(t35, 0.999999, 5);
    NOT_ABOVE(t35, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-06) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-06) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-06) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-06) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-05) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 0.0007562600000000001) OR /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 0.0007551200000000001), /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_forward_dynamics_independent)(size_t stride, const double *restrict q,
    const double *restrict y_dot, const double *restrict u, double *restrict y_ddot,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t2 = limb5_S_q_qw * limb5_S_q_qw,
      t3 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t4 = t2 + t3, t5 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7, t11 = t3 + t6,
      t82 = t3 + t5, t10 = 4.0 - 2.0 * t8, platform_turn_yy = 1.0 - t10 * t11, t39 = k2 - 0.5 * t8,
      platform_turn_xx = 1.0 - t7 * t10, platform_turn_zz = 1.0 - t10 * t82, t14 = limb5_S_q_qz * t10,
      t15 = limb5_S_q_qy * t14, t17 = limb5_S_q_qw * (limb5_S_q_qx * t10), t26 = limb5_S_q_qy * t10,
      platform_turn_zy = t15 + t17, platform_turn_yz = t15 - t17, limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_sin = SINES(sine, 0),
      t24 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t25 = limb1_lower_cos * t24, /* limb1 */
      t155 = limb1_lower_sin * t24, /* limb1 */
      t27 = limb5_S_q_qx * t26, t92 = limb5_S_q_qw * t26, t28 = limb5_S_q_qw * t14, t91 = limb5_S_q_qx * t14,
      platform_turn_xy = t27 - t28, platform_turn_yx = t27 + t28;
    /* limb1: reciprocal wrenches, eq. (10); geometry */
    const REAL limb1_U2_constraint_mn_couple_z = t25 - limb1_lower_sin * platform_turn_xy,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    /* limb1: rates that follow; reciprocal wrenches, eq. (10); pivots */
    const REAL t19 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t31 = limb1_lower_cos * t19,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t31,
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      t33 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t36 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t19,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t20 = minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t20;
    /* limb5_S: pivots; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t33;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL t34 = 1.0 / minus_limb5_S_pivot_wz,
      t37 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t36, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t34 * t37;
    /* limb5_S: velocities, eq. (6); accelerations; geometry */
    const REAL t41 = limb5_S_q_qx * t39, t42 = t41 * limb5_S_null_space_wz_by_limb5_S_wy, t40 = limb5_S_q_qw * t39,
      a_pivot = 0.5 * (t40 + t42);
    REAL checked2 = a_pivot;
    const REAL t44 = 1.0 / a_pivot, t47 = limb5_S_q_qy * t39, t45 = limb5_S_q_qz * t39,
      t51 = t44 * (0.5 * (t45 - t47 * limb5_S_null_space_wz_by_limb5_S_wy)), limb5_S_y_dot_qy = READ(y_dot, 1),
      t53 = READ(y_dot, 0) - limb5_S_y_dot_qy * t51, t46 = 0.5 * t45, a_pivot_2 = 0.5 * t40 + t46 * t51;
    REAL checked3 = a_pivot_2;
    const REAL limb5_S_joint_rate_wx = t53 / a_pivot_2,
      limb5_S_joint_rate_wy = t44 * (limb5_S_y_dot_qy + t46 * limb5_S_joint_rate_wx),
      limb5_S_joint_rate_wz = t34 * (t37 * limb5_S_joint_rate_wy), t98 = platform_turn_zy * limb5_S_joint_rate_wz,
      platform_omega_y = t98 + (platform_turn_yy * limb5_S_joint_rate_wy + platform_turn_xy * limb5_S_joint_rate_wx),
      t117 = platform_turn_zy * platform_omega_y, platform_turn_zx = t91 - t92, platform_turn_xz = t91 + t92,
      t104 = platform_turn_zx * limb5_S_joint_rate_wz,
      platform_omega_x = t104 + (platform_turn_yx * limb5_S_joint_rate_wy + platform_turn_xx * limb5_S_joint_rate_wx),
      t119 = t117 + platform_turn_zx * platform_omega_x, t93 = platform_turn_zz * limb5_S_joint_rate_wz,
      platform_omega_z = t93 + (platform_turn_yz * limb5_S_joint_rate_wy + platform_turn_xz * limb5_S_joint_rate_wx),
      t120 = platform_turn_zz * platform_omega_z + t119;
    /* limb3: geometry; free motion; velocities, eq. (6) */
    const REAL limb3_U_0_cos = SINES(cosine, 4), t427 = limb3_U_0_cos * t120,
      t125 = platform_turn_yy * platform_omega_y + platform_turn_yx * platform_omega_x, /* platform */
      t126 = platform_turn_yz * platform_omega_z + t125, /* platform */
      limb3_U_0_sin = SINES(sine, 4), t429 = t427 - limb3_U_0_sin * t126,
      t433 = limb3_U_0_cos * limb5_S_joint_rate_wz - limb3_U_0_sin * limb5_S_joint_rate_wy,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x,
      limb3_lower_cos = SINES(cosine, 5), t434 = limb3_upper_position_x * t433,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    checked0 = checked0 + minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t189 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      limb3_U_joint_rate_0 = limb5_S_joint_rate_wx - t189 * t434, t563 = t429 * limb3_U_joint_rate_0,
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin, t564 = limb3_S_arm_x * t563,
      t417 = limb3_U_0_sin * limb5_S_joint_rate_wz + limb3_U_0_cos * limb5_S_joint_rate_wy,
      limb3_upper_vel_y = limb3_S_arm_x * t417, t272 = limb3_lower_cos * t189,
      limb3_U_joint_rate_1 = t272 * limb3_upper_vel_y, limb3_U_follows_1_by_limb3_S_0 = limb3_S_arm_x * t272,
      limb3_S_arm_y = param_R * limb3_lower_cos, minus_limb3_P_joint_rate = limb3_S_arm_y * t417;
    /* limb3: free motion; inertia; accelerations */
    const REAL t577 = limb3_S_arm_y * t563, t562 = minus_limb3_P_joint_rate * limb3_U_joint_rate_1,
      t565 = t562 + t564, t439 = limb3_U_0_sin * t120 + limb3_U_0_cos * t126,
      t424 = limb3_lower_cos * limb3_U_joint_rate_1,
      t567 = t272 * (t439 * (minus_limb3_P_joint_rate - param_R * t424) - t565), t425 = limb3_upper_offset_x * t424,
      limb3_lower_composite_first_x = limb_lower_m * limb3_upper_offset_x, t190 = k7 - limb3_lower_composite_first_x,
      t447 = limb3_lower_composite_first_x - t190, t191 = limb3_upper_offset_x * t190, t569 = t447 * t562,
      limb3_U_mass_matrix_1_by_limb3_U_1 = k9 - t191, t568 = limb3_U_mass_matrix_1_by_limb3_U_1 * t567,
      t192 = t191 - k8,
      t274 = limb3_U_follows_1_by_limb3_S_0 * (limb3_U_mass_matrix_1_by_limb3_U_1 * limb3_U_follows_1_by_limb3_S_0),
      minus_limb3_U_0_U_still_xx = limb3_U_joint_rate_0 * limb3_U_joint_rate_0, t193 = limb3_lower_cos * t192,
      t454 = minus_limb3_lower_sin * t193 + limb3_lower_cos * (minus_limb3_lower_sin * t192),
      limb3_U_mass_matrix_0_by_limb3_U_0 = k3 - limb3_lower_cos * t193,
      t572 = t569 - 0.5 * t454 * minus_limb3_U_0_U_still_xx, limb3_U_0_acc_y = gravity_z * limb3_U_0_cos,
      minus_limb3_U_handed_force_1 = t568 - (limb3_upper_offset_x * (limb_lower_m * (minus_limb3_lower_sin * limb3_U_0_acc_y)) - t572),
      t574 = limb3_U_follows_1_by_limb3_S_0 * minus_limb3_U_handed_force_1,
      limb3_P_generalised_force = limb_lower_m * (limb3_lower_cos * limb3_U_0_acc_y) - READ(u, 2),
      t419 = minus_limb3_lower_sin * limb3_U_joint_rate_1, t579 = limb_lower_m * (t439 * (param_R * t419) + t577),
      t441 = limb3_upper_position_x * (limb3_U_joint_rate_0 * t439), t420 = limb3_upper_offset_x * t419,
      minus_limb3_U_follows_0_by_limb3_S_1 = limb3_upper_position_x * t189,
      t449 = limb3_lower_cos * (limb3_lower_cos * t447), t584 = 0.5 * t449 * minus_limb3_U_0_U_still_xx,
      t586 = limb3_P_generalised_force - (0.5 * t447 * (limb3_U_joint_rate_1 * limb3_U_joint_rate_1) + t584),
      minus_limb3_S_handed_force_0 = t574 - limb3_S_arm_y * (t579 - t586),
      t456 = t454 * (limb3_U_joint_rate_1 * limb3_U_joint_rate_0),
      t588 = limb3_U_0_sin * minus_limb3_S_handed_force_0, t605 = limb3_U_0_cos * minus_limb3_S_handed_force_0,
      t108 = platform_turn_xx * platform_omega_x, /* platform */
      platform_rate_my = gravity_z_platform_mz * platform_turn_zx - k12 * (platform_omega_z * platform_omega_x),
      t589 = platform_turn_zy * platform_rate_my, /* platform */
      t521 = k12 * (platform_omega_z * platform_omega_y), /* platform */
      t110 = platform_turn_xz * platform_omega_z + (platform_turn_xy * platform_omega_y + t108), /* platform */
      minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - t521;
    /* limb2: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2),
      t592 = t588 - (t589 - platform_turn_zx * minus_platform_rate_mx), /* limb5_S */
      t384 = minus_limb2_U_0_cos * t110 + limb2_U_0_sin * t120,
      t388 = limb2_U_0_sin * limb5_S_joint_rate_wz + minus_limb2_U_0_cos * limb5_S_joint_rate_wx,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5), limb2_lower_sin = SINES(sine, 3),
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      limb2_lower_cos = SINES(cosine, 3), t389 = minus_limb2_upper_position_y * t388,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    checked1 = checked1 + minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t199 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      limb2_U_joint_rate_0 = limb5_S_joint_rate_wy - t199 * t389, t493 = t384 * limb2_U_joint_rate_0,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin, t494 = limb2_S_arm_x * t493,
      t372 = minus_limb2_U_0_cos * limb5_S_joint_rate_wz - limb2_U_0_sin * limb5_S_joint_rate_wx,
      minus_limb2_upper_vel_y = limb2_S_arm_x * t372, t246 = limb2_lower_cos * t199,
      minus_limb2_U_joint_rate_1 = t246 * minus_limb2_upper_vel_y,
      limb2_U_follows_1_by_limb2_S_0 = limb2_S_arm_x * t246, minus_limb2_S_arm_y = param_R * limb2_lower_cos,
      minus_limb2_P_joint_rate = minus_limb2_S_arm_y * t372;
    /* limb2: free motion; inertia; accelerations */
    const REAL t507 = minus_limb2_S_arm_y * t493, t492 = minus_limb2_P_joint_rate * minus_limb2_U_joint_rate_1,
      t495 = t492 + t494, t394 = limb2_U_0_sin * t110 - minus_limb2_U_0_cos * t120,
      t379 = limb2_lower_cos * minus_limb2_U_joint_rate_1,
      t497 = t246 * (t394 * (minus_limb2_P_joint_rate - param_R * t379) + t495), t380 = limb2_upper_offset_x * t379,
      limb2_lower_composite_first_x = limb_lower_m * limb2_upper_offset_x, t200 = k7 - limb2_lower_composite_first_x,
      t402 = limb2_lower_composite_first_x - t200, t201 = limb2_upper_offset_x * t200, t499 = t402 * t492,
      limb2_U_mass_matrix_1_by_limb2_U_1 = k9 - t201, t498 = limb2_U_mass_matrix_1_by_limb2_U_1 * t497,
      t202 = t201 - k8,
      t248 = limb2_U_follows_1_by_limb2_S_0 * (limb2_U_mass_matrix_1_by_limb2_U_1 * limb2_U_follows_1_by_limb2_S_0),
      minus_limb2_U_0_U_still_xx = limb2_U_joint_rate_0 * limb2_U_joint_rate_0, t203 = limb2_lower_cos * t202,
      t409 = limb2_lower_sin * t203 + limb2_lower_cos * (limb2_lower_sin * t202),
      limb2_U_mass_matrix_0_by_limb2_U_0 = k3 - limb2_lower_cos * t203,
      t502 = t499 - 0.5 * t409 * minus_limb2_U_0_U_still_xx, minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin,
      minus_limb2_U_handed_force_1 = t498 - (limb2_upper_offset_x * (limb_lower_m * (limb2_lower_sin * minus_limb2_U_0_acc_y)) + t502),
      t504 = limb2_U_follows_1_by_limb2_S_0 * minus_limb2_U_handed_force_1,
      minus_limb2_P_generalised_force = limb_lower_m * (limb2_lower_cos * minus_limb2_U_0_acc_y) + READ(u, 1),
      t374 = limb2_lower_sin * minus_limb2_U_joint_rate_1, t509 = limb_lower_m * (t394 * (param_R * t374) - t507),
      t396 = minus_limb2_upper_position_y * (limb2_U_joint_rate_0 * t394), t375 = limb2_upper_offset_x * t374,
      limb2_U_follows_0_by_limb2_S_1 = minus_limb2_upper_position_y * t199,
      t404 = limb2_lower_cos * (limb2_lower_cos * t402), t514 = 0.5 * t404 * minus_limb2_U_0_U_still_xx,
      t516 = minus_limb2_P_generalised_force + (0.5 * t402 * (minus_limb2_U_joint_rate_1 * minus_limb2_U_joint_rate_1) + t514),
      minus_limb2_S_handed_force_0 = t504 - minus_limb2_S_arm_y * (t509 - t516);
    /* limb4: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6),
      t411 = t409 * (minus_limb2_U_joint_rate_1 * limb2_U_joint_rate_0), /* limb2 */
      t593 = minus_limb2_U_0_cos * minus_limb2_S_handed_force_0 - t592, /* limb5_S */
      t518 = limb2_U_0_sin * minus_limb2_S_handed_force_0, /* limb2 */
      t339 = minus_limb4_U_0_cos * t110 + limb4_U_0_sin * t120,
      t343 = limb4_U_0_sin * limb5_S_joint_rate_wz + minus_limb4_U_0_cos * limb5_S_joint_rate_wx,
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11), minus_limb4_lower_sin = SINES(sine, 7),
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      limb4_lower_cos = SINES(cosine, 7), t344 = limb4_upper_position_y * t343,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    checked2 = checked2 + minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t209 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_U_joint_rate_0 = limb5_S_joint_rate_wy + t209 * t344, t463 = t339 * limb4_U_joint_rate_0,
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin, t464 = limb4_S_arm_x * t463,
      t327 = minus_limb4_U_0_cos * limb5_S_joint_rate_wz - limb4_U_0_sin * limb5_S_joint_rate_wx,
      minus_limb4_upper_vel_y = limb4_S_arm_x * t327, t231 = limb4_lower_cos * t209,
      minus_limb4_U_joint_rate_1 = t231 * minus_limb4_upper_vel_y,
      limb4_U_follows_1_by_limb4_S_0 = limb4_S_arm_x * t231, limb4_S_arm_y = param_R * limb4_lower_cos,
      limb4_P_joint_rate = limb4_S_arm_y * t327;
    /* limb4: free motion; inertia; accelerations */
    const REAL t477 = limb4_S_arm_y * t463, t462 = limb4_P_joint_rate * minus_limb4_U_joint_rate_1,
      t465 = t462 - t464, t349 = limb4_U_0_sin * t110 - minus_limb4_U_0_cos * t120,
      t334 = limb4_lower_cos * minus_limb4_U_joint_rate_1,
      t467 = t231 * (t349 * (limb4_P_joint_rate - param_R * t334) + t465), t335 = limb4_upper_offset_x * t334,
      limb4_lower_composite_first_x = limb_lower_m * limb4_upper_offset_x, t210 = k7 - limb4_lower_composite_first_x,
      t357 = limb4_lower_composite_first_x - t210, t211 = limb4_upper_offset_x * t210, t469 = t357 * t462,
      limb4_U_mass_matrix_1_by_limb4_U_1 = k9 - t211, t468 = limb4_U_mass_matrix_1_by_limb4_U_1 * t467,
      t212 = t211 - k8,
      t233 = limb4_U_follows_1_by_limb4_S_0 * (limb4_U_mass_matrix_1_by_limb4_U_1 * limb4_U_follows_1_by_limb4_S_0),
      minus_limb4_U_0_U_still_xx = limb4_U_joint_rate_0 * limb4_U_joint_rate_0, t213 = limb4_lower_cos * t212,
      t364 = minus_limb4_lower_sin * t213 + limb4_lower_cos * (minus_limb4_lower_sin * t212),
      limb4_U_mass_matrix_0_by_limb4_U_0 = k3 - limb4_lower_cos * t213,
      t472 = t469 - 0.5 * t364 * minus_limb4_U_0_U_still_xx, minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      t473 = limb4_upper_offset_x * (limb_lower_m * (minus_limb4_lower_sin * minus_limb4_U_0_acc_y)) + t472,
      t474 = limb4_U_follows_1_by_limb4_S_0 * (t468 - t473),
      minus_limb4_P_generalised_force = limb_lower_m * (limb4_lower_cos * minus_limb4_U_0_acc_y) + READ(u, 3),
      t329 = minus_limb4_lower_sin * minus_limb4_U_joint_rate_1,
      t479 = limb_lower_m * (t349 * (param_R * t329) + t477),
      t351 = limb4_upper_position_y * (limb4_U_joint_rate_0 * t349), t330 = limb4_upper_offset_x * t329,
      minus_limb4_U_follows_0_by_limb4_S_1 = limb4_upper_position_y * t209,
      t359 = limb4_lower_cos * (limb4_lower_cos * t357), t484 = 0.5 * t359 * minus_limb4_U_0_U_still_xx,
      t486 = minus_limb4_P_generalised_force + (0.5 * t357 * (minus_limb4_U_joint_rate_1 * minus_limb4_U_joint_rate_1) + t484),
      limb4_S_handed_force_0 = t474 - limb4_S_arm_y * (t479 - t486),
      t366 = t364 * (minus_limb4_U_joint_rate_1 * limb4_U_joint_rate_0),
      t594 = minus_limb4_U_0_cos * limb4_S_handed_force_0 - t593, /* limb5_S */
      t488 = limb4_U_0_sin * limb4_S_handed_force_0, t136 = limb1_U_0_sin * t120, /* limb5_S */
      t128 = limb1_U_0_cos * t120 - limb1_U_0_sin * t126; /* limb5_S */
    /* limb1: velocities, eq. (6); free motion; inertia */
    const REAL t133 = minus_limb1_upper_position_x * (limb1_U_0_cos * limb5_S_joint_rate_wz - limb1_U_0_sin * limb5_S_joint_rate_wy),
      limb1_U_joint_rate_0 = limb5_S_joint_rate_wx + t19 * t133, t149 = t128 * limb1_U_joint_rate_0, /* limb5_S */
      t150 = limb1_U2_arm_x * t149, /* limb5_S */
      t86 = limb1_U_0_sin * limb5_S_joint_rate_wz + limb1_U_0_cos * limb5_S_joint_rate_wy,
      limb1_U_joint_rate_1 = t31 * (limb1_U2_arm_x * t86), limb1_U_follows_1_by_limb1_U2_0 = limb1_U2_arm_x * t31,
      minus_limb1_U2_arm_y = param_R * limb1_lower_cos, limb1_P_joint_rate = minus_limb1_U2_arm_y * t86,
      t545 = minus_limb1_U2_arm_y * t149, t148 = limb1_P_joint_rate * limb1_U_joint_rate_1,
      t151 = t148 - t150, /* limb5_S */
      t138 = t136 + limb1_U_0_cos * t126, /* limb5_S */
      t113 = limb1_lower_cos * limb1_U_joint_rate_1,
      t152 = t138 * (limb1_P_joint_rate - param_R * t113) - t151, /* limb5_S */
      t535 = t31 * t152, t153 = limb1_U_factor_1_by_3 * t152, /* limb5_S */
      t114 = limb1_upper_offset_x * t113, limb1_lower_composite_first_x = limb_lower_m * limb1_upper_offset_x,
      t218 = k7 - limb1_lower_composite_first_x, t313 = limb1_lower_composite_first_x - t218,
      t219 = limb1_upper_offset_x * t218, t537 = t313 * t148, limb1_U_mass_matrix_1_by_limb1_U_1 = k9 - t219,
      t536 = limb1_U_mass_matrix_1_by_limb1_U_1 * t535, t220 = t219 - k8,
      t260 = limb1_U_follows_1_by_limb1_U2_0 * (limb1_U_mass_matrix_1_by_limb1_U_1 * limb1_U_follows_1_by_limb1_U2_0),
      minus_limb1_U_0_U_still_xx = limb1_U_joint_rate_0 * limb1_U_joint_rate_0, t221 = limb1_lower_cos * t220;
    /* limb1: free motion; inertia; accelerations */
    const REAL t320 = limb1_lower_sin * t221 + limb1_lower_cos * (limb1_lower_sin * t220),
      limb1_U_mass_matrix_0_by_limb1_U_0 = k3 - limb1_lower_cos * t221,
      t540 = t537 - 0.5 * t320 * minus_limb1_U_0_U_still_xx, limb1_U_0_acc_y = gravity_z * limb1_U_0_cos,
      t542 = limb1_U_follows_1_by_limb1_U2_0 * (t536 - (limb1_upper_offset_x * (limb_lower_m * (limb1_lower_sin * limb1_U_0_acc_y)) - t540)),
      limb1_P_generalised_force = limb_lower_m * (limb1_lower_cos * limb1_U_0_acc_y) - READ(u, 0),
      t88 = limb1_lower_sin * limb1_U_joint_rate_1, t547 = limb_lower_m * (t138 * (param_R * t88) - t545),
      t89 = limb1_upper_offset_x * t88, t315 = limb1_lower_cos * (limb1_lower_cos * t313),
      t552 = 0.5 * t315 * minus_limb1_U_0_U_still_xx,
      t554 = limb1_P_generalised_force - (0.5 * t313 * (limb1_U_joint_rate_1 * limb1_U_joint_rate_1) + t552),
      limb1_U2_handed_force_0 = t542 - minus_limb1_U2_arm_y * (t547 - t554),
      t595 = limb1_U_0_sin * limb1_U2_handed_force_0 - t594, /* limb5_S */
      t604 = limb1_U_0_cos * limb1_U2_handed_force_0;
    /* limb3: free motion */
    const REAL t421 = limb3_lower_cos * minus_limb3_P_joint_rate - t420, t442 = t421 * limb3_U_joint_rate_0 + t441,
      t457 = t449 * (minus_limb3_P_joint_rate * limb3_U_joint_rate_0) + t456,
      t444 = t110 * t421 + ((minus_limb3_lower_sin * minus_limb3_P_joint_rate + t425) * t429 - t442),
      t446 = limb3_U_mass_matrix_0_by_limb3_U_0 * (t189 * t444),
      minus_limb3_U_handed_force_0 = t446 + (limb3_lower_cos * (limb3_upper_offset_x * (limb_lower_m_gravity_z * limb3_U_0_sin)) + t457),
      limb3_S_handed_force_1 = minus_limb3_U_follows_0_by_limb3_S_1 * minus_limb3_U_handed_force_0,
      t596 = limb3_U_0_cos * limb3_S_handed_force_1 + t595, /* limb5_S */
      t603 = limb3_U_0_sin * limb3_S_handed_force_1;
    /* limb2: free motion */
    const REAL t376 = limb2_lower_cos * minus_limb2_P_joint_rate - t375, t377 = t126 * t376,
      t412 = t404 * (minus_limb2_P_joint_rate * limb2_U_joint_rate_0) + t411,
      t398 = (limb2_lower_sin * minus_limb2_P_joint_rate + t380) * t384 - (t376 * limb2_U_joint_rate_0 - t396),
      t401 = limb2_U_mass_matrix_0_by_limb2_U_0 * (t199 * (t377 + t398)),
      t413 = limb2_lower_cos * (limb2_upper_offset_x * (limb_lower_m_gravity_z * minus_limb2_U_0_cos)) - t412,
      minus_limb2_U_handed_force_0 = t401 - t413,
      minus_limb2_S_handed_force_1 = limb2_U_follows_0_by_limb2_S_1 * minus_limb2_U_handed_force_0,
      t597 = limb2_U_0_sin * minus_limb2_S_handed_force_1 + t596, /* limb5_S */
      t414 = minus_limb2_U_0_cos * minus_limb2_S_handed_force_1;
    /* limb4: free motion */
    const REAL t331 = limb4_lower_cos * limb4_P_joint_rate - t330, t332 = t126 * t331,
      t367 = t359 * (limb4_P_joint_rate * limb4_U_joint_rate_0) + t366,
      t353 = (minus_limb4_lower_sin * limb4_P_joint_rate + t335) * t339 + (t331 * limb4_U_joint_rate_0 - t351),
      t356 = limb4_U_mass_matrix_0_by_limb4_U_0 * (t209 * (t332 - t353)),
      t368 = limb4_lower_cos * (limb4_upper_offset_x * (limb_lower_m_gravity_z * minus_limb4_U_0_cos)) + t367,
      limb4_U_handed_force_0 = t356 + t368,
      minus_limb4_S_handed_force_1 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_handed_force_0,
      t598 = limb4_U_0_sin * minus_limb4_S_handed_force_1 + t597, /* limb5_S */
      t369 = minus_limb4_U_0_cos * minus_limb4_S_handed_force_1,
      t140 = minus_limb1_upper_position_x * (limb1_U_joint_rate_0 * t138); /* limb5_S */
    /* limb1: rates that follow; loop closure; free motion */
    const REAL limb1_U_follows_0_by_limb1_U2_1 = minus_limb1_upper_position_x * t19,
      t154 = limb1_U_joint_rate_1 - t138, t90 = limb1_lower_cos * limb1_P_joint_rate - t89,
      t111 = t90 * t110, /* limb5_S */
      t142 = (limb1_lower_sin * limb1_P_joint_rate + t114) * t128 + (t90 * limb1_U_joint_rate_0 + t140), /* limb5_S */
      t143 = t111 - t142, /* limb5_S */
      t144 = minus_limb1_U_factor_0_by_3 * t143, /* limb5_S */
      t312 = limb1_U_mass_matrix_0_by_limb1_U_0 * (t19 * t143),
      t317 = t315 * (limb1_P_joint_rate * limb1_U_joint_rate_0),
      t323 = t317 + t320 * (limb1_U_joint_rate_1 * limb1_U_joint_rate_0),
      limb1_U_handed_force_0 = t312 - (limb1_lower_cos * (limb1_upper_offset_x * (limb_lower_m_gravity_z * limb1_U_0_sin)) - t323),
      limb1_U2_handed_force_1 = limb1_U_follows_0_by_limb1_U2_1 * limb1_U_handed_force_0,
      t599 = limb1_U_0_cos * limb1_U2_handed_force_1 + t598, /* limb5_S */
      t602 = limb1_U_0_sin * limb1_U2_handed_force_1;
    /* limb1: loop closure; velocities, eq. (6); accelerations */
    const REAL t160 = limb1_lower_cos * t110 - limb1_lower_sin * t128,
      t167 = limb1_lower_sin * t110 + limb1_lower_cos * t128,
      limb1_lower_omega_y = limb1_lower_cos * limb1_U_joint_rate_0, t161 = t160 - limb1_lower_omega_y,
      limb1_lower_omega_x = limb1_lower_sin * limb1_U_joint_rate_0, t168 = t167 - limb1_lower_omega_x,
      t175 = t161 * limb1_lower_omega_x, limb1_lower_alpha_still_x = limb1_U_joint_rate_1 * limb1_lower_omega_y,
      t182 = limb1_U2_constraint_mn_couple_x * (limb1_U_joint_rate_1 * t161 + t154 * limb1_lower_omega_y - limb1_lower_alpha_still_x),
      t183 = limb1_U2_constraint_mn_couple_z * (limb1_lower_omega_y * t168 - t175) + t182,
      t162 = limb1_U2_constraint_mn_couple_x * t161, t169 = limb1_U2_constraint_mn_couple_z * t161,
      limb1_U2_opening_mn = t155 + limb1_lower_cos * platform_turn_xy,
      t164 = t154 * (limb1_U2_opening_mn * t154 + t162),
      t184 = t153 - (t164 + t168 * (t169 + limb1_U2_opening_mn * t168) + t183), /* limb5_S */
      limb5_S_joint_acc_still_wz = t34 * (t144 + t184);
    /* limb3: free motion */
    const REAL t195 = minus_limb3_U_follows_0_by_limb3_S_1 * limb3_U_mass_matrix_0_by_limb3_U_0,
      t268 = minus_limb3_U_follows_0_by_limb3_S_1 * t195, t275 = limb3_S_arm_y * (k20 * limb3_lower_cos) + t274,
      t277 = limb3_U_0_cos * (t268 - t275), t278 = limb3_U_0_cos * t277, t300 = t275 + t278, t279 = t268 - t278,
      t288 = limb3_U_0_sin * t277, t238 = k12 * platform_turn_zz, /* platform */
      t301 = k13 + platform_turn_zz * t238 + t300, /* limb5_S */
      t239 = platform_turn_xz * t238, /* platform */
      t205 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_mass_matrix_0_by_limb2_U_0, /* limb2 */
      t242 = limb2_U_follows_0_by_limb2_S_1 * t205, /* limb2 */
      t249 = minus_limb2_S_arm_y * (k20 * limb2_lower_cos) + t248, /* limb2 */
      t251 = limb2_U_0_sin * (t242 - t249), /* limb2 */
      t296 = limb2_U_0_sin * t251, /* limb2 */
      t302 = t249 + t296 + t301, /* limb5_S */
      t623 = t242 - t296, /* limb2 */
      t252 = minus_limb2_U_0_cos * t251, /* limb2 */
      t215 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_mass_matrix_0_by_limb4_U_0, /* limb4 */
      t227 = minus_limb4_U_follows_0_by_limb4_S_1 * t215, /* limb4 */
      t234 = limb4_S_arm_y * (k20 * limb4_lower_cos) + t233, /* limb4 */
      t236 = limb4_U_0_sin * (t227 - t234), /* limb4 */
      t294 = limb4_U_0_sin * t236, /* limb4 */
      t303 = t234 + t294 + t302, /* limb5_S */
      t618 = t227 - t294, /* limb4 */
      t237 = minus_limb4_U_0_cos * t236, /* limb4 */
      t223 = limb1_U_follows_0_by_limb1_U2_1 * limb1_U_mass_matrix_0_by_limb1_U_0, /* limb1 */
      t256 = limb1_U_follows_0_by_limb1_U2_1 * t223, /* limb1 */
      t261 = minus_limb1_U2_arm_y * (k20 * limb1_lower_cos) + t260, /* limb1 */
      t263 = limb1_U_0_cos * (t256 - t261), /* limb1 */
      t264 = limb1_U_0_cos * t263; /* limb1 */
    /* limb5_S: free motion; accelerations; pivots */
    const REAL limb5_S_handed_inertia_wz = t261 + t264 + t303, t265 = t256 - t264, /* limb1 */
      t284 = limb1_U_0_sin * t263, /* limb1 */
      t600 = limb5_S_null_space_wz_by_limb5_S_wy * (limb5_S_handed_inertia_wz * limb5_S_joint_acc_still_wz + t599),
      t304 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz,
      t520 = platform_turn_xy * platform_rate_my,
      t610 = t604 - (t605 - (platform_turn_yy * platform_rate_my - platform_turn_yx * minus_platform_rate_mx)),
      t614 = t602 - (limb4_U_handed_force_0 - (minus_limb2_U_handed_force_0 + (t603 - t610))),
      t526 = minus_limb3_U_handed_force_0 - (t488 - (t518 - (t520 - platform_turn_xx * minus_platform_rate_mx))),
      t529 = limb1_U_handed_force_0 + (t369 + (t414 - t526)), t186 = k12 * platform_turn_yz,
      t206 = minus_limb2_U_0_cos * t205, /* limb2 */
      t291 = limb4_U_0_sin * t215 - (limb2_U_0_sin * t205 - (platform_turn_zz * t186 - t288)), t292 = t284 - t291,
      t306 = t292 + (t292 - t304), minus_limb5_S_reduced_force_wy = t600 - (t292 * limb5_S_joint_acc_still_wz + t614),
      t307 = limb5_S_null_space_wz_by_limb5_S_wy * t306, t216 = minus_limb4_U_0_cos * t215, /* limb4 */
      t282 = limb4_U_mass_matrix_0_by_limb4_U_0 + (limb2_U_mass_matrix_0_by_limb2_U_0 + (k13 + platform_turn_yz * t186 + t279)),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = t265 + t282 - t307;
    checked3 = checked3 + limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t308 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t217 = platform_turn_xz * t186 + limb3_U_0_sin * t195 - t206 + t216,
      limb5_S_handed_inertia_wz_by_limb5_S_wx = limb1_U_0_cos * t223 + (t237 + (t239 - limb3_U_0_cos * t195 + t252)),
      t225 = t217 - limb1_U_0_sin * t223,
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t225 + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz_by_limb5_S_wx,
      minus_limb5_S_reduced_force_wx = limb5_S_handed_inertia_wz_by_limb5_S_wx * limb5_S_joint_acc_still_wz + t529,
      t309 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t308, t626 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t309,
      t628 = minus_limb5_S_reduced_force_wy * t308,
      t617 = minus_limb5_S_reduced_force_wx - minus_limb5_S_reduced_force_wy * t309,
      t624 = limb3_U_mass_matrix_0_by_limb3_U_0 + (k13 + platform_turn_xz * (k12 * platform_turn_xz)) + t623,
      pivot_1 = limb1_U_mass_matrix_0_by_limb1_U_0 + (t618 + t624) - t626;
    checked0 = checked0 + pivot_1;
    const REAL minus_limb5_S_joint_acc_wx = t617 / pivot_1,
      limb5_S_joint_acc_wy = t309 * minus_limb5_S_joint_acc_wx - t628,
      limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_joint_acc_wy;
    /* limb5_S: results */
    const REAL t636 = platform_turn_zy * limb5_S_joint_acc_wz,
      t640 = t636 + (platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx),
      t659 = platform_turn_xy * t640, t641 = platform_turn_zy * t640, t652 = platform_turn_yy * t640,
      t642 = platform_turn_zx * limb5_S_joint_acc_wz, t630 = platform_turn_zz * limb5_S_joint_acc_wz,
      t631 = platform_turn_yz * limb5_S_joint_acc_wy,
      t646 = t642 + (platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx),
      t661 = t659 + platform_turn_xx * t646, t634 = t630 + (t631 - platform_turn_xz * minus_limb5_S_joint_acc_wx),
      t662 = platform_turn_xz * t634 + t661, t654 = t652 + platform_turn_yx * t646,
      t649 = platform_turn_zz * t634 + (t641 + platform_turn_zx * t646), t655 = platform_turn_yz * t634 + t654,
      t681 = t45 * t662 - t41 * t649 - t40 * t655, t664 = t47 * t649 - t45 * t655 - t40 * t662,
      t672 = 0.5 * (t47 * limb5_S_joint_rate_wz - t45 * limb5_S_joint_rate_wy - t40 * limb5_S_joint_rate_wx),
      t673 = limb5_S_joint_rate_wz * t672, t62 = t40 * limb5_S_joint_rate_wy,
      t71 = 0.5 * (t41 * limb5_S_joint_rate_wy - t47 * limb5_S_joint_rate_wx - t40 * limb5_S_joint_rate_wz),
      t674 = limb5_S_joint_rate_wx * t71 - t673, t72 = limb5_S_joint_rate_wy * t71, t59 = t45 * limb5_S_joint_rate_wx,
      t79 = 0.5 * (t45 * limb5_S_joint_rate_wz + (t47 * limb5_S_joint_rate_wy + t41 * limb5_S_joint_rate_wx));
    RESULT(checked1, y_ddot, 1, 0.5 * (t674 - limb5_S_joint_rate_wy * t79 - t681));
    const REAL t80 = limb5_S_joint_rate_wx * t79,
      t73 = limb5_S_joint_rate_wz * (0.5 * (t59 - t41 * limb5_S_joint_rate_wz - t62)) - t72;
    RESULT(checked2, y_ddot, 0, 0.5 * (t73 - t80 - t664));
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
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 7.562600000000002e-08) OR /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 7.551200000000001e-08), /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_forward_dynamics_reactions)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, double *restrict a, double *restrict reactions,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t29 = limb5_S_q_qw * limb5_S_q_qw,
      t30 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t31 = t29 + t30,
      t32 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t33 = limb5_S_q_qz * limb5_S_q_qz,
      t34 = t32 + t33, t35 = t31 + t34, t37 = 4.0 - 2.0 * t35, t42 = t30 + t32,
      platform_turn_yy = 1.0 - t37 * (t30 + t33), platform_turn_zz = 1.0 - t37 * t42,
      platform_turn_xx = 1.0 - t34 * t37, t40 = limb5_S_q_qy * t37, t90 = limb5_S_q_qx * t40,
      t41 = limb5_S_q_qw * t40, t38 = limb5_S_q_qz * t37, t82 = limb5_S_q_qw * (limb5_S_q_qx * t37),
      t91 = limb5_S_q_qw * t38, platform_turn_yx = t90 + t91, platform_turn_xy = t90 - t91,
      limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13),
      t100 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, t80 = limb5_S_q_qy * t38,
      t39 = limb5_S_q_qx * t38, platform_turn_yz = t80 - t82, platform_turn_zy = t80 + t82,
      limb5_S_v_wz = READ(v, 14), platform_twist_wy = t100 + limb5_S_v_wz * platform_turn_yz;
    /* limb3: geometry; free motion */
    const REAL limb3_U_0_sin = SINES(sine, 4), t284 = limb3_U_0_sin * platform_twist_wy, platform_turn_zx = t39 - t41,
      platform_turn_xz = t39 + t41,
      t106 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy, /* platform */
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t106, limb3_U_0_cos = SINES(cosine, 4);
    /* limb3: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t286 = t284 - limb3_U_0_cos * platform_twist_wz, limb3_U_v_0 = READ(v, 6), t440 = limb3_U_v_0 * t286,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin, limb3_U_v_1 = READ(v, 7),
      limb3_P_v = READ(v, 8), t453 = limb3_S_arm_x * t440, t449 = limb3_U_v_1 * limb3_P_v, t454 = t453 + t449,
      t275 = limb3_U_0_cos * platform_twist_wy + limb3_U_0_sin * platform_twist_wz,
      limb3_lower_cos = SINES(cosine, 5), t287 = limb3_U_v_1 * limb3_lower_cos,
      t458 = t454 - t275 * (limb3_P_v + param_R * t287), t288 = limb3_upper_offset_x * t287,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked0 = minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t47 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz, t389 = limb3_lower_cos * t47, t459 = t458 * t389,
      limb3_lower_composite_first_x = limb_lower_m * limb3_upper_offset_x, t48 = k7 - limb3_lower_composite_first_x,
      t266 = limb3_lower_composite_first_x - t48, t49 = limb3_upper_offset_x * t48, t450 = t449 * t266,
      limb3_U_mass_matrix_1_by_limb3_U_1 = k9 - t49, t50 = t49 - k8, t460 = limb3_U_mass_matrix_1_by_limb3_U_1 * t459,
      t51 = limb3_lower_cos * t50,
      t263 = minus_limb3_lower_sin * t51 + limb3_lower_cos * (minus_limb3_lower_sin * t50),
      limb3_U_mass_matrix_0_by_limb3_U_0 = k3 - limb3_lower_cos * t51, t447 = 0.5 * t263,
      minus_limb3_U_0_U_still_xx = limb3_U_v_0 * limb3_U_v_0, t451 = minus_limb3_U_0_U_still_xx * t447 + t450,
      limb3_U_0_acc_y = gravity_z * limb3_U_0_cos, limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y,
      limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y, limb3_upper_force_y = limb_lower_m * limb3_lower_acc_y,
      limb3_U_handed_force_1 = limb3_upper_offset_x * limb3_upper_force_y + t451 - t460,
      limb3_U_follows_1_by_limb3_S_0 = limb3_S_arm_x * t389,
      t461 = limb3_U_follows_1_by_limb3_S_0 * limb3_U_handed_force_1,
      t391 = limb3_U_follows_1_by_limb3_S_0 * (limb3_U_mass_matrix_1_by_limb3_U_1 * limb3_U_follows_1_by_limb3_S_0),
      limb3_S_arm_y = param_R * limb3_lower_cos, t441 = limb3_S_arm_y * t440,
      t278 = limb3_U_v_1 * minus_limb3_lower_sin, t444 = t441 - t275 * (param_R * t278), t276 = limb3_U_v_0 * t275,
      t279 = limb3_upper_offset_x * t278, t445 = limb_lower_m * t444,
      t268 = limb3_lower_cos * (limb3_lower_cos * t266), t436 = 0.5 * t266,
      t434 = minus_limb3_U_0_U_still_xx * (0.5 * t268), t435 = limb3_U_v_1 * limb3_U_v_1, t438 = t434 + t435 * t436,
      limb3_upper_force_x = limb_lower_m * limb3_lower_acc_x, limb3_P_u = READ(u, 2),
      minus_limb3_S_handed_force_0 = limb3_S_arm_y * (limb3_upper_force_x - limb3_P_u - t438 + t445) - t461,
      t462 = limb3_U_0_sin * minus_limb3_S_handed_force_0, t489 = limb3_U_0_cos * minus_limb3_S_handed_force_0;
    /* platform: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL minus_platform_moment_x = gravity_z_platform_mz * platform_turn_zy,
      platform_U_still_yz = limb5_S_v_wy * limb5_S_v_wz, t326 = k12 * platform_U_still_yz,
      platform_rate_mx = t326 - minus_platform_moment_x, t430 = platform_turn_zx * platform_rate_mx,
      platform_moment_y = gravity_z_platform_mz * platform_turn_zx, platform_U_still_xz = limb5_S_v_wx * limb5_S_v_wz,
      t328 = k12 * platform_U_still_xz, minus_platform_rate_my = t328 - platform_moment_y;
    /* limb2: geometry; free motion */
    const REAL limb2_U_0_sin = SINES(cosine, 2),
      t463 = t430 - platform_turn_zy * minus_platform_rate_my - t462, /* limb5_S */
      t248 = limb2_U_0_sin * platform_twist_wz,
      t128 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy, /* platform */
      platform_twist_wx = t128 + limb5_S_v_wz * platform_turn_xz, minus_limb2_U_0_cos = SINES(sine, 2);
    /* limb2: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t250 = t248 + minus_limb2_U_0_cos * platform_twist_wx, limb2_U_v_0 = READ(v, 3),
      t338 = limb2_U_v_0 * t250, limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      limb2_lower_sin = SINES(sine, 3), limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin,
      limb2_U_v_1 = READ(v, 4), limb2_P_v = READ(v, 5), t351 = limb2_S_arm_x * t338, t347 = limb2_U_v_1 * limb2_P_v,
      t352 = t351 + t347, t239 = minus_limb2_U_0_cos * platform_twist_wz - limb2_U_0_sin * platform_twist_wx,
      limb2_lower_cos = SINES(cosine, 3), t251 = limb2_U_v_1 * limb2_lower_cos,
      t356 = t352 + t239 * (limb2_P_v - param_R * t251), t252 = limb2_upper_offset_x * t251,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t57 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz, t68 = limb2_lower_cos * t57, t357 = t356 * t68,
      limb2_lower_composite_first_x = limb_lower_m * limb2_upper_offset_x, t58 = k7 - limb2_lower_composite_first_x,
      t230 = limb2_lower_composite_first_x - t58, t59 = limb2_upper_offset_x * t58, t348 = t347 * t230,
      limb2_U_mass_matrix_1_by_limb2_U_1 = k9 - t59, t60 = t59 - k8, t358 = limb2_U_mass_matrix_1_by_limb2_U_1 * t357,
      t61 = limb2_lower_cos * t60, t227 = limb2_lower_sin * t61 + limb2_lower_cos * (limb2_lower_sin * t60),
      limb2_U_mass_matrix_0_by_limb2_U_0 = k3 - limb2_lower_cos * t61, t345 = 0.5 * t227,
      minus_limb2_U_0_U_still_xx = limb2_U_v_0 * limb2_U_v_0, t349 = minus_limb2_U_0_U_still_xx * t345 - t348,
      minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin, limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y,
      minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y,
      limb2_upper_force_y = limb_lower_m * limb2_lower_acc_y,
      limb2_U_handed_force_1 = limb2_upper_offset_x * limb2_upper_force_y - t349 - t358,
      limb2_U_follows_1_by_limb2_S_0 = limb2_S_arm_x * t68,
      t359 = limb2_U_follows_1_by_limb2_S_0 * limb2_U_handed_force_1,
      t70 = limb2_U_follows_1_by_limb2_S_0 * (limb2_U_mass_matrix_1_by_limb2_U_1 * limb2_U_follows_1_by_limb2_S_0),
      minus_limb2_S_arm_y = param_R * limb2_lower_cos, t339 = minus_limb2_S_arm_y * t338,
      t242 = limb2_U_v_1 * limb2_lower_sin, t342 = t339 - t239 * (param_R * t242), t240 = limb2_U_v_0 * t239,
      t243 = limb2_upper_offset_x * t242, t343 = limb_lower_m * t342,
      t232 = limb2_lower_cos * (limb2_lower_cos * t230), t334 = 0.5 * t230,
      t332 = minus_limb2_U_0_U_still_xx * (0.5 * t232), t333 = limb2_U_v_1 * limb2_U_v_1, t336 = t332 + t333 * t334,
      minus_limb2_upper_force_x = limb_lower_m * minus_limb2_lower_acc_x, limb2_P_u = READ(u, 1),
      minus_limb2_S_handed_force_0 = minus_limb2_S_arm_y * (minus_limb2_upper_force_x + limb2_P_u + t336 + t343) - t359;
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6),
      t464 = minus_limb2_U_0_cos * minus_limb2_S_handed_force_0 + t463, /* limb5_S */
      t360 = limb2_U_0_sin * minus_limb2_S_handed_force_0; /* limb2 */
    /* limb4: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t214 = limb4_U_0_sin * platform_twist_wz + minus_limb4_U_0_cos * platform_twist_wx,
      limb4_U_v_0 = READ(v, 9), t303 = limb4_U_v_0 * t214, limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      minus_limb4_lower_sin = SINES(sine, 7), limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      limb4_U_v_1 = READ(v, 10), limb4_P_v = READ(v, 11), t316 = limb4_S_arm_x * t303, t312 = limb4_U_v_1 * limb4_P_v,
      t317 = t316 + t312, t203 = minus_limb4_U_0_cos * platform_twist_wz - limb4_U_0_sin * platform_twist_wx,
      limb4_lower_cos = SINES(cosine, 7), t215 = limb4_U_v_1 * limb4_lower_cos,
      t321 = t317 + t203 * (limb4_P_v + param_R * t215), t216 = limb4_upper_offset_x * t215,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked2 = minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t11 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz, t22 = limb4_lower_cos * t11, t322 = t321 * t22,
      limb4_lower_composite_first_x = limb_lower_m * limb4_upper_offset_x, t12 = k7 - limb4_lower_composite_first_x,
      t194 = limb4_lower_composite_first_x - t12, t13 = limb4_upper_offset_x * t12, t313 = t312 * t194,
      limb4_U_mass_matrix_1_by_limb4_U_1 = k9 - t13, t14 = t13 - k8, t323 = limb4_U_mass_matrix_1_by_limb4_U_1 * t322,
      t15 = limb4_lower_cos * t14,
      t191 = minus_limb4_lower_sin * t15 + limb4_lower_cos * (minus_limb4_lower_sin * t14),
      limb4_U_mass_matrix_0_by_limb4_U_0 = k3 - limb4_lower_cos * t15, t310 = 0.5 * t191,
      minus_limb4_U_0_U_still_xx = limb4_U_v_0 * limb4_U_v_0, t314 = minus_limb4_U_0_U_still_xx * t310 + t313,
      minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y,
      minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y,
      minus_limb4_upper_force_y = limb_lower_m * minus_limb4_lower_acc_y,
      minus_limb4_U_handed_force_1 = limb4_upper_offset_x * minus_limb4_upper_force_y - t314 + t323,
      limb4_U_follows_1_by_limb4_S_0 = limb4_S_arm_x * t22,
      t324 = limb4_U_follows_1_by_limb4_S_0 * minus_limb4_U_handed_force_1,
      t24 = limb4_U_follows_1_by_limb4_S_0 * (limb4_U_mass_matrix_1_by_limb4_U_1 * limb4_U_follows_1_by_limb4_S_0),
      limb4_S_arm_y = param_R * limb4_lower_cos, t304 = limb4_S_arm_y * t303,
      t206 = limb4_U_v_1 * minus_limb4_lower_sin, t307 = t304 + t203 * (param_R * t206), t204 = limb4_U_v_0 * t203,
      t207 = limb4_upper_offset_x * t206, t308 = limb_lower_m * t307,
      t196 = limb4_lower_cos * (limb4_lower_cos * t194), t299 = 0.5 * t194,
      t297 = minus_limb4_U_0_U_still_xx * (0.5 * t196), t298 = limb4_U_v_1 * limb4_U_v_1, t301 = t297 + t298 * t299,
      minus_limb4_upper_force_x = limb_lower_m * minus_limb4_lower_acc_x, limb4_P_u = READ(u, 3),
      limb4_S_handed_force_0 = limb4_S_arm_y * (minus_limb4_upper_force_x + limb4_P_u + t301 - t308) - t324,
      limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0),
      t465 = minus_limb4_U_0_cos * limb4_S_handed_force_0 - t464, /* limb5_S */
      t325 = limb4_U_0_sin * limb4_S_handed_force_0,
      t119 = limb1_U_0_sin * platform_twist_wy - limb1_U_0_cos * platform_twist_wz, /* limb5_S */
      limb1_U_v_0 = READ(v, 0), t107 = limb1_U_0_sin * platform_twist_wz, /* limb5_S */
      t163 = limb1_U_v_0 * t119; /* limb5_S */
    /* limb1: accelerations; free motion; inertia */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2), limb1_lower_sin = SINES(sine, 1),
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin, limb1_U_v_1 = READ(v, 1),
      limb1_P_v = READ(v, 2), t164 = limb1_U2_arm_x * t163, /* limb5_S */
      t165 = limb1_U_v_1 * limb1_P_v, t166 = t164 + t165, /* limb5_S */
      t108 = limb1_U_0_cos * platform_twist_wy + t107, /* limb5_S */
      limb1_lower_cos = SINES(cosine, 1), t120 = limb1_U_v_1 * limb1_lower_cos,
      t170 = t166 - t108 * (limb1_P_v - param_R * t120), /* limb5_S */
      t121 = limb1_upper_offset_x * t120,
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked3 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t2 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t94 = limb1_lower_cos * t2, t424 = t170 * t94,
      limb1_lower_composite_first_x = limb_lower_m * limb1_upper_offset_x, t3 = k7 - limb1_lower_composite_first_x,
      t180 = limb1_lower_composite_first_x - t3, t4 = limb1_upper_offset_x * t3, t421 = t165 * t180,
      limb1_U_mass_matrix_1_by_limb1_U_1 = k9 - t4, t5 = t4 - k8, t425 = limb1_U_mass_matrix_1_by_limb1_U_1 * t424,
      t6 = limb1_lower_cos * t5, t177 = limb1_lower_sin * t6 + limb1_lower_cos * (limb1_lower_sin * t5),
      limb1_U_mass_matrix_0_by_limb1_U_0 = k3 - limb1_lower_cos * t6, t419 = 0.5 * t177,
      minus_limb1_U_0_U_still_xx = limb1_U_v_0 * limb1_U_v_0, t422 = minus_limb1_U_0_U_still_xx * t419 - t421,
      limb1_U_0_acc_y = gravity_z * limb1_U_0_cos, minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y,
      limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y,
      minus_limb1_upper_force_y = limb_lower_m * minus_limb1_lower_acc_y;
    /* limb1: free motion; rates that follow; accelerations */
    const REAL minus_limb1_U_handed_force_1 = limb1_upper_offset_x * minus_limb1_upper_force_y + t422 + t425,
      limb1_U_follows_1_by_limb1_U2_0 = limb1_U2_arm_x * t94,
      t426 = limb1_U_follows_1_by_limb1_U2_0 * minus_limb1_U_handed_force_1,
      t373 = limb1_U_follows_1_by_limb1_U2_0 * (limb1_U_mass_matrix_1_by_limb1_U_1 * limb1_U_follows_1_by_limb1_U2_0),
      minus_limb1_U2_arm_y = param_R * limb1_lower_cos, t413 = minus_limb1_U2_arm_y * t163,
      t111 = limb1_U_v_1 * limb1_lower_sin, t416 = t413 + t108 * (param_R * t111), t112 = limb1_upper_offset_x * t111,
      t417 = limb_lower_m * t416, t182 = limb1_lower_cos * (limb1_lower_cos * t180), t409 = 0.5 * t180,
      t407 = minus_limb1_U_0_U_still_xx * (0.5 * t182), t408 = limb1_U_v_1 * limb1_U_v_1, t411 = t407 + t408 * t409,
      limb1_upper_force_x = limb_lower_m * limb1_lower_acc_x, limb1_P_u = READ(u, 0),
      limb1_U2_handed_force_0 = minus_limb1_U2_arm_y * (limb1_upper_force_x - limb1_P_u - t411 - t417) - t426,
      t466 = limb1_U_0_sin * limb1_U2_handed_force_0 - t465, /* limb5_S */
      t485 = limb1_U_0_cos * limb1_U2_handed_force_0;
    /* limb3: geometry */
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    /* limb3: free motion; balance, eqs. (40)-(47); rates that follow */
    const REAL t277 = limb3_upper_position_x * t276, t281 = t279 + limb3_P_v * limb3_lower_cos,
      t292 = platform_twist_wx * t281,
      t291 = t277 - limb3_U_v_0 * t281 - t286 * (limb3_P_v * minus_limb3_lower_sin - t288),
      t294 = t47 * (t291 + t292), t295 = limb3_U_mass_matrix_0_by_limb3_U_0 * t294,
      t271 = t263 * (limb3_U_v_0 * limb3_U_v_1) - t268 * (limb3_U_v_0 * limb3_P_v),
      limb3_upper_force_z = limb_lower_m_gravity_z * limb3_U_0_sin,
      minus_limb3_U_handed_force_0 = limb3_lower_cos * (limb3_upper_offset_x * limb3_upper_force_z) + t271 - t295,
      minus_limb3_U_follows_0_by_limb3_S_1 = limb3_upper_position_x * t47,
      limb3_S_handed_force_1 = minus_limb3_U_follows_0_by_limb3_S_1 * minus_limb3_U_handed_force_0,
      t467 = limb3_U_0_cos * limb3_S_handed_force_1 + t466, /* limb5_S */
      t484 = limb3_U_0_sin * limb3_S_handed_force_1;
    /* limb2: geometry */
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    /* limb2: free motion; balance, eqs. (40)-(47); rates that follow */
    const REAL t241 = minus_limb2_upper_position_y * t240, t245 = t243 - limb2_P_v * limb2_lower_cos,
      t256 = platform_twist_wy * t245, t255 = t241 + limb2_U_v_0 * t245 + t250 * (limb2_P_v * limb2_lower_sin + t252),
      t258 = t57 * (t255 - t256), t259 = limb2_U_mass_matrix_0_by_limb2_U_0 * t258,
      t235 = t227 * (limb2_U_v_0 * limb2_U_v_1) + t232 * (limb2_U_v_0 * limb2_P_v),
      minus_limb2_upper_force_z = limb_lower_m_gravity_z * minus_limb2_U_0_cos,
      limb2_U_handed_force_0 = limb2_lower_cos * (limb2_upper_offset_x * minus_limb2_upper_force_z) + t235 + t259,
      limb2_U_follows_0_by_limb2_S_1 = minus_limb2_upper_position_y * t57,
      limb2_S_handed_force_1 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_handed_force_0,
      t468 = limb2_U_0_sin * limb2_S_handed_force_1 - t467, /* limb5_S */
      t260 = minus_limb2_U_0_cos * limb2_S_handed_force_1;
    /* limb4: geometry */
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    /* limb4: free motion; balance, eqs. (40)-(47); rates that follow */
    const REAL t205 = limb4_upper_position_y * t204, t209 = t207 + limb4_P_v * limb4_lower_cos,
      t220 = platform_twist_wy * t209,
      t219 = t205 + limb4_U_v_0 * t209 + t214 * (limb4_P_v * minus_limb4_lower_sin - t216),
      t222 = t11 * (t219 - t220), t223 = limb4_U_mass_matrix_0_by_limb4_U_0 * t222,
      t199 = t191 * (limb4_U_v_0 * limb4_U_v_1) - t196 * (limb4_U_v_0 * limb4_P_v),
      minus_limb4_upper_force_z = limb_lower_m_gravity_z * minus_limb4_U_0_cos,
      limb4_U_handed_force_0 = limb4_lower_cos * (limb4_upper_offset_x * minus_limb4_upper_force_z) - t199 - t223,
      minus_limb4_U_follows_0_by_limb4_S_1 = limb4_upper_position_y * t11,
      minus_limb4_S_handed_force_1 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_handed_force_0,
      t469 = limb4_U_0_sin * minus_limb4_S_handed_force_1 - t468, /* limb5_S */
      t224 = minus_limb4_U_0_cos * minus_limb4_S_handed_force_1, t109 = limb1_U_v_0 * t108; /* limb5_S */
    /* limb1: loop closure; free motion; rates that follow */
    const REAL t133 = limb1_U_v_1 - t108,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t110 = minus_limb1_upper_position_x * t109, /* limb5_S */
      t114 = t112 - limb1_P_v * limb1_lower_cos, t130 = platform_twist_wx * t114, /* limb5_S */
      t124 = t110 - limb1_U_v_0 * t114 - t119 * (limb1_P_v * limb1_lower_sin + t121), /* limb5_S */
      t131 = t124 + t130, /* limb5_S */
      t187 = t2 * t131, t188 = limb1_U_mass_matrix_0_by_limb1_U_0 * t187,
      t185 = t177 * (limb1_U_v_0 * limb1_U_v_1) + t182 * (limb1_U_v_0 * limb1_P_v),
      limb1_upper_force_z = limb_lower_m_gravity_z * limb1_U_0_sin,
      minus_limb1_U_handed_force_0 = limb1_lower_cos * (limb1_upper_offset_x * limb1_upper_force_z) - t185 + t188,
      limb1_U_follows_0_by_limb1_U2_1 = minus_limb1_upper_position_x * t2,
      minus_limb1_U2_handed_force_1 = limb1_U_follows_0_by_limb1_U2_1 * minus_limb1_U_handed_force_0,
      t470 = limb1_U_0_cos * minus_limb1_U2_handed_force_1 - t469, /* limb5_S */
      t483 = limb1_U_0_sin * minus_limb1_U2_handed_force_1,
      t137 = limb1_lower_sin * t119 + limb1_lower_cos * platform_twist_wx,
      t146 = limb1_lower_cos * t119 - limb1_lower_sin * platform_twist_wx,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, t138 = limb1_lower_omega_y - t137,
      t140 = limb1_lower_omega_y * t133 - limb1_U_v_1 * t138,
      limb1_lower_alpha_still_x = limb1_U_v_1 * limb1_lower_omega_y, t141 = limb1_lower_alpha_still_x - t140,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t142 = limb1_U2_constraint_mn_couple_x * t141, limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin,
      t147 = limb1_lower_omega_x + t146, t149 = limb1_lower_omega_x * t138 - limb1_lower_omega_y * t147,
      t88 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t152 = limb1_lower_sin * t88,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t88 - limb1_lower_sin * platform_turn_xy,
      t151 = t142 - limb1_U2_constraint_mn_couple_z * t149,
      limb1_U2_opening_mn = t152 + limb1_lower_cos * platform_turn_xy,
      t157 = t147 * (limb1_U2_opening_mn * t147 + limb1_U2_constraint_mn_couple_z * t138),
      limb1_U2_opening_bias_mn = t151 - (t157 - t133 * (limb1_U2_constraint_mn_couple_x * t138 - limb1_U2_opening_mn * t133)),
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t94,
      t172 = limb1_U2_opening_bias_mn - t170 * limb1_U_factor_1_by_3, /* limb5_S */
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t2,
      t173 = minus_limb1_U_factor_0_by_3 * t131 - t172, /* limb5_S */
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      t96 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t368 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      t84 = minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t84,
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t96;
    checked0 = checked0 + minus_limb5_S_pivot_wz;
    const REAL t97 = 1.0 / minus_limb5_S_pivot_wz, /* limb5_S */
      minus_limb5_S_joint_acc_still_wz = t97 * t173,
      limb5_S_null_space_wz_by_limb5_S_wy = t97 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t368);
    /* limb3: free motion */
    const REAL t53 = minus_limb3_U_follows_0_by_limb3_S_1 * limb3_U_mass_matrix_0_by_limb3_U_0,
      t393 = minus_limb3_U_follows_0_by_limb3_S_1 * t53, t392 = limb3_S_arm_y * (k20 * limb3_lower_cos) + t391,
      t395 = limb3_U_0_cos * (t393 - t392), t396 = limb3_U_0_cos * t395, t397 = t392 + t396, t510 = t393 - t396,
      t477 = limb3_U_0_sin * t395, t44 = k12 * platform_turn_zz, /* platform */
      t398 = k13 + platform_turn_zz * t44 + t397, /* limb5_S */
      t45 = platform_turn_xz * t44, /* platform */
      t63 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_mass_matrix_0_by_limb2_U_0, /* limb2 */
      t64 = limb2_U_follows_0_by_limb2_S_1 * t63, /* limb2 */
      t71 = minus_limb2_S_arm_y * (k20 * limb2_lower_cos) + t70, /* limb2 */
      t73 = limb2_U_0_sin * (t64 - t71), /* limb2 */
      t382 = limb2_U_0_sin * t73, /* limb2 */
      t399 = t71 + t382 + t398, /* limb5_S */
      t528 = t64 - t382, /* limb2 */
      t74 = minus_limb2_U_0_cos * t73, /* limb2 */
      t17 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_mass_matrix_0_by_limb4_U_0, /* limb4 */
      t18 = minus_limb4_U_follows_0_by_limb4_S_1 * t17, /* limb4 */
      t25 = limb4_S_arm_y * (k20 * limb4_lower_cos) + t24, /* limb4 */
      t27 = limb4_U_0_sin * (t18 - t25), /* limb4 */
      t380 = limb4_U_0_sin * t27, /* limb4 */
      t400 = t25 + t380 + t399, /* limb5_S */
      t523 = t18 - t380, /* limb4 */
      t28 = minus_limb4_U_0_cos * t27, /* limb4 */
      t8 = limb1_U_follows_0_by_limb1_U2_1 * limb1_U_mass_matrix_0_by_limb1_U_0, /* limb1 */
      t375 = limb1_U_follows_0_by_limb1_U2_1 * t8, /* limb1 */
      t374 = minus_limb1_U2_arm_y * (k20 * limb1_lower_cos) + t373, /* limb1 */
      t377 = limb1_U_0_cos * (t375 - t374), /* limb1 */
      t378 = limb1_U_0_cos * t377; /* limb1 */
    /* limb5_S: free motion; accelerations; pivots */
    const REAL limb5_S_handed_inertia_wz = t374 + t378 + t400, t507 = t375 - t378, /* limb1 */
      t472 = limb1_U_0_sin * t377, /* limb1 */
      t471 = limb5_S_null_space_wz_by_limb5_S_wy * (limb5_S_handed_inertia_wz * minus_limb5_S_joint_acc_still_wz + t470),
      t515 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz,
      t327 = platform_turn_xx * platform_rate_mx,
      t491 = t485 + (platform_turn_yx * platform_rate_mx - platform_turn_yy * minus_platform_rate_my - t489),
      t495 = t483 + (limb4_U_handed_force_0 + (limb2_U_handed_force_0 - (t484 - t491))),
      t363 = minus_limb3_U_handed_force_0 - (t325 + (t327 - platform_turn_xy * minus_platform_rate_my - t360)),
      t366 = minus_limb1_U_handed_force_0 - (t224 - (t260 + t363)), t475 = k12 * platform_turn_yz,
      t500 = minus_limb2_U_0_cos * t63, /* limb2 */
      t480 = limb4_U_0_sin * t17 - (limb2_U_0_sin * t63 - (platform_turn_zz * t475 - t477)), t481 = t472 - t480,
      t517 = t481 + (t481 - t515), limb5_S_reduced_force_wy = t471 - (t481 * minus_limb5_S_joint_acc_still_wz + t495),
      t518 = limb5_S_null_space_wz_by_limb5_S_wy * t517, t502 = minus_limb4_U_0_cos * t17, /* limb4 */
      t513 = limb4_U_mass_matrix_0_by_limb4_U_0 + (limb2_U_mass_matrix_0_by_limb2_U_0 + (k13 + platform_turn_yz * t475 + t510)),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = t507 + t513 - t518;
    checked1 = checked1 + limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t519 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t503 = platform_turn_xz * t475 + limb3_U_0_sin * t53 - t500 + t502,
      limb5_S_handed_inertia_wz_by_limb5_S_wx = limb1_U_0_cos * t8 + (t28 + (t45 - limb3_U_0_cos * t53 + t74)),
      t505 = t503 - limb1_U_0_sin * t8,
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t505 + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz_by_limb5_S_wx,
      limb5_S_reduced_force_wx = limb5_S_handed_inertia_wz_by_limb5_S_wx * minus_limb5_S_joint_acc_still_wz + t366,
      t520 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t519, t531 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t520,
      t533 = limb5_S_reduced_force_wy * t519, t522 = limb5_S_reduced_force_wx - limb5_S_reduced_force_wy * t520,
      t529 = limb3_U_mass_matrix_0_by_limb3_U_0 + (k13 + platform_turn_xz * (k12 * platform_turn_xz)) + t528,
      pivot_1 = limb1_U_mass_matrix_0_by_limb1_U_0 + (t523 + t529) - t531;
    checked2 = checked2 + pivot_1;
    const REAL limb5_S_joint_acc_wx = t522 / pivot_1, minus_limb5_S_joint_acc_wy = t520 * limb5_S_joint_acc_wx - t533,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy * minus_limb5_S_joint_acc_wy,
      t542 = limb1_U_0_sin * minus_limb5_S_joint_acc_wz + limb1_U_0_cos * minus_limb5_S_joint_acc_wy, /* limb1 */
      minus_limb1_U_joint_acc_1 = t424 + limb1_U_follows_1_by_limb1_U2_0 * t542;
    RESULT(checked3, a, 1, -minus_limb1_U_joint_acc_1);
    const REAL minus_limb1_P_joint_acc = t416 + minus_limb1_U2_arm_y * t542;
    RESULT(checked0, a, 2, -minus_limb1_P_joint_acc);
    /* limb2: accelerations */
    const REAL t548 = limb2_U_follows_0_by_limb2_S_1 * (limb2_U_0_sin * minus_limb5_S_joint_acc_wz - minus_limb2_U_0_cos * limb5_S_joint_acc_wx),
      minus_limb2_U_joint_acc_0 = minus_limb5_S_joint_acc_wy - (t258 + t548);
    RESULT(checked1, a, 3, -minus_limb2_U_joint_acc_0);
    const REAL t552 = minus_limb2_U_0_cos * minus_limb5_S_joint_acc_wz + limb2_U_0_sin * limb5_S_joint_acc_wx,
      minus_limb2_U_joint_acc_1 = t357 - limb2_U_follows_1_by_limb2_S_0 * t552;
    RESULT(checked2, a, 4, -minus_limb2_U_joint_acc_1);
    const REAL minus_limb2_P_joint_acc = t342 - minus_limb2_S_arm_y * t552;
    RESULT(checked3, a, 5, -minus_limb2_P_joint_acc);
    const REAL t562 = limb3_U_0_sin * minus_limb5_S_joint_acc_wz + limb3_U_0_cos * minus_limb5_S_joint_acc_wy, /* limb3 */
      minus_limb3_U_joint_acc_1 = t459 + limb3_U_follows_1_by_limb3_S_0 * t562;
    RESULT(checked0, a, 7, -minus_limb3_U_joint_acc_1);
    const REAL limb3_P_joint_acc = t444 + limb3_S_arm_y * t562;
    WRITE(a, 8, limb3_P_joint_acc);
    /* limb4: accelerations */
    const REAL t568 = minus_limb4_U_follows_0_by_limb4_S_1 * (limb4_U_0_sin * minus_limb5_S_joint_acc_wz - minus_limb4_U_0_cos * limb5_S_joint_acc_wx),
      minus_limb4_U_joint_acc_0 = minus_limb5_S_joint_acc_wy + (t222 + t568);
    RESULT(checked1, a, 9, -minus_limb4_U_joint_acc_0);
    const REAL t572 = minus_limb4_U_0_cos * minus_limb5_S_joint_acc_wz + limb4_U_0_sin * limb5_S_joint_acc_wx,
      minus_limb4_U_joint_acc_1 = t322 - limb4_U_follows_1_by_limb4_S_0 * t572;
    RESULT(checked2, a, 10, -minus_limb4_U_joint_acc_1);
    const REAL limb4_P_joint_acc = t307 - limb4_S_arm_y * t572;
    WRITE(a, 11, limb4_P_joint_acc);
    /* platform: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t575 = platform_turn_zx * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_x = t575 + (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx * limb5_S_joint_acc_wx);
    RESULT(checked3, a, 12, -minus_platform_alpha_x);
    const REAL t734 = platform_turn_zx * (minus_platform_moment_x - (t326 - k13 * minus_platform_alpha_x)),
      platform_rate_fy = platform_mz * (platform_U_still_yz + minus_platform_alpha_x),
      t579 = platform_turn_zy * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_y = t579 + (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy * limb5_S_joint_acc_wx);
    RESULT(checked0, a, 13, -minus_platform_alpha_y);
    const REAL t735 = platform_turn_zy * (platform_moment_y - (t328 + k13 * minus_platform_alpha_y)) - t734,
      platform_rate_fx = platform_mz * (platform_U_still_xz - minus_platform_alpha_y),
      t583 = platform_turn_zz * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_z = t583 + (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz * limb5_S_joint_acc_wx);
    RESULT(checked1, a, 14, -minus_platform_alpha_z);
    const REAL t736 = platform_turn_zz * (platform_Izz * minus_platform_alpha_z) - t735,
      t555 = limb3_U_0_cos * minus_limb5_S_joint_acc_wz; /* limb3 */
    /* limb1: accelerations */
    const REAL t538 = limb1_U_follows_0_by_limb1_U2_1 * (limb1_U_0_cos * minus_limb5_S_joint_acc_wz - limb1_U_0_sin * minus_limb5_S_joint_acc_wy),
      limb1_U_joint_acc_0 = limb5_S_joint_acc_wx - (t187 + t538);
    WRITE(a, 0, limb1_U_joint_acc_0);
    const REAL t559 = t294 + minus_limb3_U_follows_0_by_limb3_S_1 * (t555 - limb3_U_0_sin * minus_limb5_S_joint_acc_wy), /* limb3 */
      limb3_U_joint_acc_0 = limb5_S_joint_acc_wx + t559;
    WRITE(a, 6, limb3_U_joint_acc_0);
    const REAL limb1_lower_U_xz = limb1_lower_cos * limb1_U_joint_acc_0,
      minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x,
      minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_lower_U_xz,
      limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y,
      limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y,
      t712 = limb1_upper_offset_x * limb1_lower_U_zx;
    /* limb1: momentum rate, eq. (35); accelerations; balance, eqs. (40)-(47) */
    const REAL limb1_lower_rate_fz = limb_lower_mx * limb1_lower_U_zx,
      limb1_lower_rate_fz_2 = limb1_upper_force_z + limb1_lower_rate_fz,
      minus_limb1_upper_acc_z = limb1_P_v * (2.0 * limb1_lower_omega_y) - (gravity_z * limb1_U_0_sin + t712),
      minus_limb1_lower_U_still_xx = limb1_lower_omega_y * limb1_lower_omega_y + t408,
      minus_limb1_upper_rate_fz = limb1_lower_rate_fz + limb_lower_m * minus_limb1_upper_acc_z,
      minus_limb1_upper_rate_my = limb_lower_mx * minus_limb1_upper_acc_z,
      t715 = limb1_upper_offset_x * minus_limb1_upper_rate_fz - minus_limb1_upper_rate_my,
      t709 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y,
      t761 = k17 * minus_limb1_lower_alpha_still_y + k16 * minus_limb1_lower_alpha_y,
      minus_limb1_upper_rate_my_2 = minus_limb1_upper_rate_my + t761,
      limb1_upper_moment_y = gravity_z_limb_lower_mx * limb1_U_0_sin,
      minus_limb1_lower_rate_my_2 = limb1_upper_moment_y + t761,
      t716 = limb1_lower_cos * (limb1_upper_moment_y + t709 - t715),
      minus_limb1_U2_part_fz = t2 * (k3 * limb1_U_joint_acc_0 + (limb1_lower_sin * (k10 * limb1_lower_alpha_still_x) - t716)),
      t766 = k14 * (limb1_lower_alpha_still_x + limb1_lower_sin * limb1_U_joint_acc_0),
      minus_limb1_upper_rate_mx = k15 * limb1_lower_alpha_still_x - t766,
      t718 = limb1_lower_sin * (limb1_U2_arm_x * minus_limb1_U2_part_fz),
      t722 = limb1_U_0_cos * (t718 - limb1_lower_cos * (minus_limb1_U2_arm_y * minus_limb1_U2_part_fz)),
      limb1_lower_U_yx = limb1_lower_U_still_xy - minus_limb1_U_joint_acc_1,
      t592 = minus_limb1_lower_acc_y - limb1_upper_offset_x * limb1_lower_U_yx,
      limb1_lower_rate_fy = limb_lower_mx * limb1_lower_U_yx,
      limb1_upper_moment_z = limb_lower_mx * minus_limb1_lower_acc_y,
      minus_limb1_lower_rate_fy = minus_limb1_upper_force_y - limb1_lower_rate_fy,
      limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) - t592,
      minus_limb1_upper_rate_fy = limb1_lower_rate_fy - limb_lower_m * limb1_upper_acc_y,
      minus_limb1_upper_rate_mz = limb_lower_mx * limb1_upper_acc_y,
      t609 = limb1_upper_offset_x * minus_limb1_upper_rate_fy + minus_limb1_upper_rate_mz,
      t795 = k18 * minus_limb1_U_joint_acc_1,
      minus_limb1_U2_part_fy = t94 * (limb1_upper_moment_z - (k8 * limb1_lower_U_still_xy - k9 * minus_limb1_U_joint_acc_1) + t609),
      minus_limb1_upper_rate_mz_2 = minus_limb1_upper_rate_mz - (k19 * limb1_lower_U_still_xy - t795),
      t724 = limb1_U2_arm_x * minus_limb1_U2_part_fy,
      t597 = limb1_lower_sin * (limb1_U2_arm_x * minus_limb1_U_factor_0_by_3),
      minus_limb1_upper_acc_x = limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x + minus_limb1_P_joint_acc,
      minus_limb1_lower_force_x = limb_lower_m * minus_limb1_upper_acc_x,
      minus_limb1_lower_rate_fx = limb_lower_mx * minus_limb1_lower_U_still_xx,
      limb1_upper_rate_fx = minus_limb1_lower_rate_fx - minus_limb1_lower_force_x,
      minus_limb1_lower_sent_fx = minus_limb1_lower_rate_fx - limb1_upper_force_x - limb1_P_u,
      t737 = t722 - limb1_U_0_sin * (minus_limb1_U2_arm_y * limb1_upper_rate_fx - t724) + t736, /* platform */
      minus_limb1_U2_multiplier_fx = limb1_P_u - limb1_upper_rate_fx;
    /* limb2: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL minus_limb2_lower_U_xz = limb2_lower_cos * minus_limb2_U_joint_acc_0,
      limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin,
      minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x,
      minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y + minus_limb2_lower_U_xz,
      limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y,
      t680 = limb2_upper_offset_x * limb2_lower_U_zx, limb2_lower_rate_fz = limb_lower_mx * limb2_lower_U_zx,
      minus_limb2_lower_rate_fz = minus_limb2_upper_force_z - limb2_lower_rate_fz,
      t681 = gravity_z * minus_limb2_U_0_cos - t680, limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos,
      limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y,
      minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) + t681,
      minus_limb2_upper_rate_fz = limb2_lower_rate_fz + limb_lower_m * minus_limb2_upper_acc_z,
      minus_limb2_upper_rate_my = limb_lower_mx * minus_limb2_upper_acc_z,
      t683 = limb2_upper_offset_x * minus_limb2_upper_rate_fz - minus_limb2_upper_rate_my,
      t677 = k9 * minus_limb2_lower_alpha_still_y + k8 * minus_limb2_lower_alpha_y,
      t846 = k17 * minus_limb2_lower_alpha_still_y + k16 * minus_limb2_lower_alpha_y,
      minus_limb2_upper_rate_my_2 = minus_limb2_upper_rate_my + t846,
      minus_limb2_upper_moment_y = gravity_z_limb_lower_mx * minus_limb2_U_0_cos,
      limb2_lower_rate_my_2 = minus_limb2_upper_moment_y - t846,
      t684 = limb2_lower_cos * (minus_limb2_upper_moment_y - t677 + t683),
      limb2_lower_alpha_still_x = limb2_U_v_1 * limb2_lower_omega_y,
      minus_limb2_lower_U_still_xx = limb2_lower_omega_y * limb2_lower_omega_y + t333,
      minus_limb2_U_0_moment_z = k3 * minus_limb2_U_joint_acc_0 - (limb2_lower_sin * (k10 * limb2_lower_alpha_still_x) + t684),
      limb2_S_multiplier_fz = t57 * minus_limb2_U_0_moment_z,
      minus_limb2_upper_sent_fz = minus_limb2_upper_rate_fz + limb2_S_multiplier_fz,
      t851 = k14 * (limb2_lower_alpha_still_x - limb2_lower_sin * minus_limb2_U_joint_acc_0),
      minus_limb2_upper_rate_mx = k15 * limb2_lower_alpha_still_x - t851,
      minus_limb2_lower_sent_fz = minus_limb2_upper_sent_fz + minus_limb2_lower_rate_fz,
      t686 = limb2_lower_sin * (limb2_S_arm_x * limb2_S_multiplier_fz),
      t690 = limb2_U_0_sin * (t686 - limb2_lower_cos * (minus_limb2_S_arm_y * limb2_S_multiplier_fz)),
      limb2_lower_U_yx = limb2_lower_U_still_xy - minus_limb2_U_joint_acc_1,
      t699 = limb2_lower_acc_y + limb2_upper_offset_x * limb2_lower_U_yx,
      limb2_lower_rate_fy = limb_lower_mx * limb2_lower_U_yx,
      minus_limb2_upper_moment_z = limb_lower_mx * limb2_lower_acc_y,
      limb2_lower_rate_fy_2 = limb2_upper_force_y + limb2_lower_rate_fy,
      limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + t699,
      minus_limb2_upper_rate_fy = limb2_lower_rate_fy - limb_lower_m * limb2_upper_acc_y,
      minus_limb2_upper_rate_mz = limb_lower_mx * limb2_upper_acc_y,
      t701 = limb2_upper_offset_x * minus_limb2_upper_rate_fy + minus_limb2_upper_rate_mz,
      t867 = k18 * minus_limb2_U_joint_acc_1,
      limb2_lower_moment_z_2 = minus_limb2_upper_moment_z + (k8 * limb2_lower_U_still_xy - k9 * minus_limb2_U_joint_acc_1) - t701,
      limb2_S_multiplier_fy = t68 * limb2_lower_moment_z_2, t702 = limb2_S_arm_x * limb2_S_multiplier_fy,
      minus_limb2_upper_sent_fy = minus_limb2_upper_rate_fy + limb2_S_multiplier_fy,
      minus_limb2_lower_sent_fy = minus_limb2_upper_sent_fy - limb2_lower_rate_fy_2,
      minus_limb2_upper_rate_mz_2 = minus_limb2_upper_rate_mz - (k19 * limb2_lower_U_still_xy - t867),
      minus_limb2_upper_acc_x = limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x + minus_limb2_P_joint_acc,
      minus_limb2_lower_force_x = limb_lower_m * minus_limb2_upper_acc_x,
      minus_limb2_lower_rate_fx = limb_lower_mx * minus_limb2_lower_U_still_xx,
      limb2_upper_rate_fx = minus_limb2_lower_rate_fx - minus_limb2_lower_force_x,
      minus_limb2_lower_sent_fx = minus_limb2_lower_rate_fx + minus_limb2_upper_force_x - limb2_P_u,
      t738 = t690 + minus_limb2_U_0_cos * (minus_limb2_S_arm_y * limb2_upper_rate_fx + t702) + t737, /* platform */
      platform_joint_force_mz_by_limb2_P = minus_limb2_U_0_cos * minus_limb2_S_arm_y,
      minus_limb2_S_multiplier_fx = limb2_P_u - limb2_upper_rate_fx;
    /* limb3: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb3_lower_U_xz = limb3_lower_cos * limb3_U_joint_acc_0,
      minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin,
      limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x,
      limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_lower_U_xz,
      minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y,
      t648 = limb3_upper_offset_x * minus_limb3_lower_U_zx,
      minus_limb3_lower_rate_fz = limb_lower_mx * minus_limb3_lower_U_zx,
      limb3_lower_rate_fz = limb3_upper_force_z - minus_limb3_lower_rate_fz, t649 = gravity_z * limb3_U_0_sin - t648,
      limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos,
      minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y,
      minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) - t649,
      limb3_upper_rate_fz = minus_limb3_lower_rate_fz - limb_lower_m * minus_limb3_upper_acc_z,
      minus_limb3_upper_rate_my = limb_lower_mx * minus_limb3_upper_acc_z,
      t651 = limb3_upper_offset_x * limb3_upper_rate_fz + minus_limb3_upper_rate_my,
      t645 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y,
      t917 = k17 * limb3_lower_alpha_still_y + k16 * limb3_lower_alpha_y,
      minus_limb3_upper_rate_my_2 = minus_limb3_upper_rate_my - t917,
      limb3_upper_moment_y = gravity_z_limb_lower_mx * limb3_U_0_sin,
      minus_limb3_lower_rate_my_2 = limb3_upper_moment_y - t917,
      t652 = limb3_lower_cos * (limb3_upper_moment_y - t645 + t651),
      limb3_lower_alpha_still_x = limb3_U_v_1 * limb3_lower_omega_y,
      minus_limb3_lower_U_still_xx = limb3_lower_omega_y * limb3_lower_omega_y + t435,
      limb3_U_0_moment_z = k3 * limb3_U_joint_acc_0 - (minus_limb3_lower_sin * (k10 * limb3_lower_alpha_still_x) + t652),
      minus_limb3_S_multiplier_fz = t47 * limb3_U_0_moment_z,
      limb3_upper_sent_fz = limb3_upper_rate_fz + minus_limb3_S_multiplier_fz,
      limb3_lower_sent_fz = limb3_upper_sent_fz + limb3_lower_rate_fz,
      t913 = k14 * (limb3_lower_alpha_still_x - minus_limb3_lower_sin * limb3_U_joint_acc_0),
      minus_limb3_upper_rate_mx = k15 * limb3_lower_alpha_still_x - t913,
      t654 = minus_limb3_lower_sin * (limb3_S_arm_x * minus_limb3_S_multiplier_fz),
      t658 = limb3_U_0_cos * (t654 - limb3_lower_cos * (limb3_S_arm_y * minus_limb3_S_multiplier_fz)),
      minus_limb3_lower_U_yx = minus_limb3_lower_U_still_xy + minus_limb3_U_joint_acc_1,
      t667 = limb3_lower_acc_y - limb3_upper_offset_x * minus_limb3_lower_U_yx,
      minus_limb3_lower_rate_fy = limb_lower_mx * minus_limb3_lower_U_yx,
      minus_limb3_upper_moment_z = limb_lower_mx * limb3_lower_acc_y,
      limb3_lower_rate_fy = limb3_upper_force_y - minus_limb3_lower_rate_fy,
      limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + t667,
      limb3_upper_rate_fy = minus_limb3_lower_rate_fy + limb_lower_m * limb3_upper_acc_y,
      minus_limb3_upper_rate_mz = limb_lower_mx * limb3_upper_acc_y,
      t669 = limb3_upper_offset_x * limb3_upper_rate_fy - minus_limb3_upper_rate_mz,
      t941 = k18 * minus_limb3_U_joint_acc_1,
      limb3_lower_rate_mz = minus_limb3_upper_moment_z - (k8 * minus_limb3_lower_U_still_xy + k9 * minus_limb3_U_joint_acc_1),
      limb3_S_multiplier_fy = t389 * (limb3_lower_rate_mz + t669), t670 = limb3_S_arm_x * limb3_S_multiplier_fy,
      limb3_upper_sent_fy = limb3_upper_rate_fy - limb3_S_multiplier_fy,
      limb3_lower_sent_fy = limb3_upper_sent_fy + limb3_lower_rate_fy,
      minus_limb3_upper_rate_mz_2 = minus_limb3_upper_rate_mz + (k19 * minus_limb3_lower_U_still_xy + t941),
      minus_limb3_lower_force_x = limb_lower_m * (limb3_upper_offset_x * minus_limb3_lower_U_still_xx - limb3_lower_acc_x - limb3_P_joint_acc),
      minus_limb3_lower_rate_fx = limb_lower_mx * minus_limb3_lower_U_still_xx,
      limb3_upper_rate_fx = minus_limb3_lower_rate_fx - minus_limb3_lower_force_x,
      minus_limb3_lower_sent_fx = minus_limb3_lower_rate_fx - limb3_upper_force_x - limb3_P_u,
      t739 = t658 - limb3_U_0_sin * (limb3_S_arm_y * limb3_upper_rate_fx - t670) - t738, /* platform */
      platform_joint_force_mz_by_limb3_P = limb3_U_0_sin * limb3_S_arm_y,
      minus_limb3_S_multiplier_fx = limb3_P_u - limb3_upper_rate_fx;
    /* limb4: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL minus_limb4_lower_U_xz = limb4_lower_cos * minus_limb4_U_joint_acc_0,
      minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin,
      limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x,
      limb4_lower_alpha_y = limb4_lower_alpha_still_y - minus_limb4_lower_U_xz,
      minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y,
      t616 = limb4_upper_offset_x * minus_limb4_lower_U_zx,
      minus_limb4_lower_rate_fz = limb_lower_mx * minus_limb4_lower_U_zx,
      minus_limb4_lower_rate_fz_2 = minus_limb4_upper_force_z + minus_limb4_lower_rate_fz,
      t617 = gravity_z * minus_limb4_U_0_cos + t616, limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos,
      minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y,
      minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + t617,
      limb4_upper_rate_fz = minus_limb4_lower_rate_fz - limb_lower_m * minus_limb4_upper_acc_z,
      minus_limb4_upper_rate_my = limb_lower_mx * minus_limb4_upper_acc_z,
      t619 = limb4_upper_offset_x * limb4_upper_rate_fz + minus_limb4_upper_rate_my,
      t613 = k9 * limb4_lower_alpha_still_y + k8 * limb4_lower_alpha_y,
      t983 = k17 * limb4_lower_alpha_still_y + k16 * limb4_lower_alpha_y,
      minus_limb4_upper_rate_my_2 = minus_limb4_upper_rate_my - t983,
      minus_limb4_upper_moment_y = gravity_z_limb_lower_mx * minus_limb4_U_0_cos,
      limb4_lower_rate_my_2 = minus_limb4_upper_moment_y + t983,
      t620 = limb4_lower_cos * (minus_limb4_upper_moment_y + t613 - t619),
      limb4_lower_alpha_still_x = limb4_U_v_1 * limb4_lower_omega_y,
      minus_limb4_lower_U_still_xx = limb4_lower_omega_y * limb4_lower_omega_y + t298,
      minus_limb4_lower_joint_force_my = minus_limb4_lower_sin * (k10 * limb4_lower_alpha_still_x) - t620,
      limb4_S_multiplier_fz = t11 * (k3 * minus_limb4_U_joint_acc_0 + minus_limb4_lower_joint_force_my),
      limb4_upper_sent_fz = limb4_upper_rate_fz - limb4_S_multiplier_fz,
      t988 = k14 * (limb4_lower_alpha_still_x + minus_limb4_lower_sin * minus_limb4_U_joint_acc_0),
      minus_limb4_upper_rate_mx = k15 * limb4_lower_alpha_still_x - t988,
      limb4_lower_sent_fz = limb4_upper_sent_fz - minus_limb4_lower_rate_fz_2,
      t622 = minus_limb4_lower_sin * (limb4_S_arm_x * limb4_S_multiplier_fz),
      t626 = limb4_U_0_sin * (t622 - limb4_lower_cos * (limb4_S_arm_y * limb4_S_multiplier_fz)),
      minus_limb4_lower_U_yx = minus_limb4_lower_U_still_xy + minus_limb4_U_joint_acc_1,
      t635 = minus_limb4_lower_acc_y + limb4_upper_offset_x * minus_limb4_lower_U_yx,
      minus_limb4_lower_rate_fy = limb_lower_mx * minus_limb4_lower_U_yx,
      limb4_upper_moment_z = limb_lower_mx * minus_limb4_lower_acc_y,
      minus_limb4_lower_rate_fy_2 = minus_limb4_upper_force_y + minus_limb4_lower_rate_fy,
      limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) - t635,
      limb4_upper_rate_fy = minus_limb4_lower_rate_fy + limb_lower_m * limb4_upper_acc_y,
      minus_limb4_upper_rate_mz = limb_lower_mx * limb4_upper_acc_y,
      t637 = limb4_upper_offset_x * limb4_upper_rate_fy - minus_limb4_upper_rate_mz,
      t1003 = k18 * minus_limb4_U_joint_acc_1,
      minus_limb4_lower_moment_z_2 = limb4_upper_moment_z + (k8 * minus_limb4_lower_U_still_xy + k9 * minus_limb4_U_joint_acc_1) - t637,
      minus_limb4_S_multiplier_fy = t22 * minus_limb4_lower_moment_z_2,
      t638 = limb4_S_arm_x * minus_limb4_S_multiplier_fy,
      limb4_upper_sent_fy = limb4_upper_rate_fy + minus_limb4_S_multiplier_fy,
      limb4_lower_sent_fy = limb4_upper_sent_fy - minus_limb4_lower_rate_fy_2,
      minus_limb4_upper_rate_mz_2 = minus_limb4_upper_rate_mz + (k19 * minus_limb4_lower_U_still_xy + t1003),
      minus_limb4_upper_acc_x = limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_lower_acc_x - limb4_P_joint_acc,
      minus_limb4_lower_force_x = limb_lower_m * minus_limb4_upper_acc_x,
      minus_limb4_lower_rate_fx = limb_lower_mx * minus_limb4_lower_U_still_xx,
      limb4_upper_rate_fx = minus_limb4_lower_rate_fx - minus_limb4_lower_force_x,
      minus_limb4_lower_sent_fx = minus_limb4_lower_rate_fx + minus_limb4_upper_force_x - limb4_P_u,
      platform_joint_force_mz = t626 + minus_limb4_U_0_cos * (limb4_S_arm_y * limb4_upper_rate_fx + t638) + t739,
      minus_platform_joint_force_mz_by_limb4_P = minus_limb4_U_0_cos * limb4_S_arm_y,
      minus_limb4_S_multiplier_fx = limb4_P_u - limb4_upper_rate_fx;
    /* limb1: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t595 = limb1_lower_cos * (limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3),
      platform_joint_force_mz_by_limb1_U2_mn = limb1_U_0_cos * (t595 + t597) + t96;
    checked2 = checked2 + platform_joint_force_mz_by_limb1_U2_mn;
    const REAL t600 = 1.0 / platform_joint_force_mz_by_limb1_U2_mn, /* platform */
      minus_limb1_U2_part_mn = t600 * platform_joint_force_mz,
      limb1_U2_part_mn_by_limb1_P = limb1_U_0_sin * minus_limb1_U2_arm_y * t600,
      minus_limb1_U2_part_mn_by_limb2_P = platform_joint_force_mz_by_limb2_P * t600,
      minus_limb1_U2_part_mn_by_limb3_P = platform_joint_force_mz_by_limb3_P * t600,
      limb1_U2_part_mn_by_limb4_P = minus_platform_joint_force_mz_by_limb4_P * t600,
      minus_limb1_U2_part_fy_2 = minus_limb1_U2_part_fy - limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn,
      t741 = limb1_P_u * (limb1_U_factor_1_by_3 * limb1_U2_part_mn_by_limb1_P) + minus_limb1_U2_part_fy_2,
      t742 = limb2_P_u * (limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn_by_limb2_P) - t741,
      t743 = limb3_P_u * (limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn_by_limb3_P) + t742,
      minus_limb1_U2_multiplier_fy = limb4_P_u * (limb1_U_factor_1_by_3 * limb1_U2_part_mn_by_limb4_P) - t743,
      minus_limb1_upper_sent_fy = minus_limb1_upper_rate_fy - minus_limb1_U2_multiplier_fy,
      minus_limb1_lower_sent_fy = minus_limb1_upper_sent_fy + minus_limb1_lower_rate_fy,
      t746 = limb1_lower_sin * minus_limb1_lower_sent_fy;
    RESULT(checked3, reactions, 0, -(limb1_lower_sin * minus_limb1_lower_sent_fx + limb1_lower_cos * minus_limb1_lower_sent_fy));
    const REAL minus_limb1_lower_joint_sent_fx = limb1_lower_cos * minus_limb1_lower_sent_fx - t746,
      t757 = limb1_U_0_cos * minus_limb1_lower_joint_sent_fx, t747 = limb1_U_0_sin * minus_limb1_lower_joint_sent_fx,
      minus_limb1_U2_part_fz_2 = minus_limb1_U2_part_fz + minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn,
      t753 = limb1_P_u * (minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn_by_limb1_P) - minus_limb1_U2_part_fz_2,
      t771 = limb1_P_u * limb1_U2_part_mn_by_limb1_P - minus_limb1_U2_part_mn,
      t754 = limb2_P_u * (minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn_by_limb2_P) - t753,
      t772 = limb2_P_u * minus_limb1_U2_part_mn_by_limb2_P - t771,
      t755 = limb3_P_u * (minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn_by_limb3_P) + t754,
      limb1_U2_multiplier_fz = limb4_P_u * (minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn_by_limb4_P) - t755,
      minus_limb1_upper_sent_fz = minus_limb1_upper_rate_fz + limb1_U2_multiplier_fz,
      minus_limb1_lower_sent_fz = minus_limb1_upper_sent_fz - limb1_lower_rate_fz_2,
      limb1_U2_multiplier_mn = limb4_P_u * limb1_U2_part_mn_by_limb4_P - (limb3_P_u * minus_limb1_U2_part_mn_by_limb3_P + t772),
      minus_limb1_U2_joint_reaction_mx = limb1_U2_constraint_mn_couple_x * limb1_U2_multiplier_mn,
      minus_limb1_U2_joint_reaction_mz = limb1_U2_constraint_mn_couple_z * limb1_U2_multiplier_mn,
      minus_limb1_upper_sent_mz = minus_limb1_U2_joint_reaction_mz + minus_limb1_upper_rate_mz_2,
      minus_limb1_U_0_joint_sent_fy = t757 + limb1_U_0_sin * minus_limb1_lower_sent_fz;
    RESULT(checked0, reactions, 2, -minus_limb1_U_0_joint_sent_fy);
    const REAL t775 = param_R * minus_limb1_U_0_joint_sent_fy,
      limb1_U_0_joint_sent_fx = t747 - limb1_U_0_cos * minus_limb1_lower_sent_fz;
    WRITE(reactions, 1, limb1_U_0_joint_sent_fx);
    const REAL t780 = param_R * limb1_U_0_joint_sent_fx,
      minus_limb1_lower_sent_my = minus_limb1_lower_rate_my_2 + (minus_limb1_upper_rate_my_2 - limb1_upper_offset_x * minus_limb1_upper_sent_fz),
      t764 = limb1_lower_cos * minus_limb1_lower_sent_my, t776 = limb1_lower_sin * minus_limb1_lower_sent_my,
      minus_limb1_upper_sent_mx = minus_limb1_U2_joint_reaction_mx + minus_limb1_upper_rate_mx,
      minus_limb1_lower_sent_mx = minus_limb1_upper_rate_mx + minus_limb1_upper_sent_mx;
    RESULT(checked1, reactions, 3, -(t764 + limb1_lower_sin * minus_limb1_lower_sent_mx));
    const REAL limb1_lower_joint_sent_mx = t776 - limb1_lower_cos * minus_limb1_lower_sent_mx;
    /* limb1: reactions, eq. (32); geometry; balance, eqs. (40)-(47) */
    RESULT(checked2, reactions, 4, -(t775 + limb1_U_0_sin * limb1_lower_joint_sent_mx));
    RESULT(checked3, reactions, 5, limb1_U_0_cos * limb1_lower_joint_sent_mx - t780);
    const REAL minus_limb1_P_reaction_fx = limb1_lower_cos * minus_limb1_upper_sent_fy;
    RESULT(checked0, reactions, 6, -minus_limb1_P_reaction_fx);
    const REAL t781 = limb1_U_0_cos * minus_limb1_upper_sent_fz, t783 = limb1_U_0_sin * minus_limb1_upper_sent_fz,
      limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin,
      minus_limb1_P_reaction_fy = t781 + limb1_lower_rotation_yy * minus_limb1_upper_sent_fy;
    RESULT(checked1, reactions, 7, -minus_limb1_P_reaction_fy);
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin,
      minus_limb1_P_reaction_fz = t783 - minus_limb1_lower_rotation_zy * minus_limb1_upper_sent_fy;
    RESULT(checked2, reactions, 8, -minus_limb1_P_reaction_fz);
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos,
      limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx,
      t785 = limb1_upper_position_z * minus_limb1_P_reaction_fy,
      t803 = minus_limb1_upper_position_x * minus_limb1_P_reaction_fy,
      minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos,
      minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx,
      t787 = t785 + minus_limb1_upper_position_y * minus_limb1_P_reaction_fz,
      t791 = minus_limb1_upper_position_x * minus_limb1_P_reaction_fz;
    RESULT(checked3, reactions, 9, t787 - (limb1_lower_cos * minus_limb1_upper_rate_my_2 + limb1_lower_sin * minus_limb1_upper_sent_mx));
    const REAL t793 = t791 + limb1_upper_position_z * minus_limb1_P_reaction_fx,
      t804 = minus_limb1_upper_position_y * minus_limb1_P_reaction_fx - t803,
      t799 = minus_limb1_lower_rotation_yx * minus_limb1_upper_sent_mx,
      t807 = limb1_lower_rotation_zx * minus_limb1_upper_sent_mx,
      t800 = limb1_lower_rotation_yy * minus_limb1_upper_rate_my_2 - t799,
      t808 = minus_limb1_lower_rotation_zy * minus_limb1_upper_rate_my_2 - t807,
      t813 = limb1_lower_rotation_yy * minus_limb1_U2_multiplier_fy,
      t817 = minus_limb1_lower_rotation_zy * minus_limb1_U2_multiplier_fy;
    RESULT(checked0, reactions, 10, -(t793 + (limb1_U_0_cos * minus_limb1_upper_sent_mz + t800)));
    RESULT(checked1, reactions, 11, -(t804 + (limb1_U_0_sin * minus_limb1_upper_sent_mz - t808)));
    const REAL t815 = t813 - minus_limb1_lower_rotation_yx * minus_limb1_U2_multiplier_fx,
      t828 = minus_limb1_lower_rotation_yx * minus_limb1_U2_joint_reaction_mx,
      t812 = limb1_U_0_cos * limb1_U2_multiplier_fz, minus_limb1_U2_reaction_fy = t812 - t815;
    RESULT(checked2, reactions, 13, -minus_limb1_U2_reaction_fy);
    const REAL t816 = limb1_U_0_sin * limb1_U2_multiplier_fz,
      minus_limb1_U2_reaction_fz = t816 + (t817 - limb1_lower_rotation_zx * minus_limb1_U2_multiplier_fx);
    RESULT(checked3, reactions, 14, -minus_limb1_U2_reaction_fz);
    const REAL t834 = limb1_lower_rotation_zx * minus_limb1_U2_joint_reaction_mx,
      t823 = limb1_lower_sin * minus_limb1_U2_joint_reaction_mx,
      t820 = limb1_upper_position_z * minus_limb1_U2_reaction_fy,
      t831 = minus_limb1_upper_position_x * minus_limb1_U2_reaction_fy,
      t824 = minus_limb1_upper_position_x * minus_limb1_U2_reaction_fz;
    RESULT(checked0, reactions, 15, t820 + minus_limb1_upper_position_y * minus_limb1_U2_reaction_fz - t823);
    const REAL t1068 = limb1_lower_sin * minus_limb1_U2_multiplier_fy,
      limb1_U2_reaction_fx = limb1_lower_cos * minus_limb1_U2_multiplier_fy + limb1_lower_sin * minus_limb1_U2_multiplier_fx;
    WRITE(reactions, 12, limb1_U2_reaction_fx);
    const REAL t826 = t824 - limb1_upper_position_z * limb1_U2_reaction_fx,
      t832 = minus_limb1_upper_position_y * limb1_U2_reaction_fx + t831,
      t1070 = t1068 - limb1_lower_cos * minus_limb1_U2_multiplier_fx;
    RESULT(checked1, reactions, 16, -(t826 + (limb1_U_0_cos * minus_limb1_U2_joint_reaction_mz - t828)));
    RESULT(checked2, reactions, 17, t832 - (limb1_U_0_sin * minus_limb1_U2_joint_reaction_mz + t834));
    /* limb2: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t837 = limb2_lower_sin * minus_limb2_lower_sent_fy;
    RESULT(checked3, reactions, 19, -(limb2_lower_sin * minus_limb2_lower_sent_fx + limb2_lower_cos * minus_limb2_lower_sent_fy));
    const REAL minus_limb2_lower_joint_sent_fx = limb2_lower_cos * minus_limb2_lower_sent_fx - t837,
      limb2_lower_sent_my = limb2_lower_rate_my_2 - (minus_limb2_upper_rate_my_2 - limb2_upper_offset_x * minus_limb2_upper_sent_fz),
      t849 = limb2_lower_sin * limb2_lower_sent_my, t855 = limb2_lower_cos * limb2_lower_sent_my,
      minus_limb2_lower_sent_mx = 2.0 * minus_limb2_upper_rate_mx,
      minus_limb2_lower_joint_sent_mx = t849 + limb2_lower_cos * minus_limb2_lower_sent_mx;
    RESULT(checked0, reactions, 22, t855 - limb2_lower_sin * minus_limb2_lower_sent_mx);
    const REAL t853 = minus_limb2_U_0_cos * minus_limb2_lower_joint_sent_mx,
      t858 = limb2_U_0_sin * minus_limb2_lower_joint_sent_mx, t843 = minus_limb2_U_0_cos * minus_limb2_lower_sent_fz,
      t839 = limb2_U_0_sin * minus_limb2_lower_sent_fz,
      limb2_U_0_joint_sent_fx = limb2_U_0_sin * minus_limb2_lower_joint_sent_fx + t843;
    WRITE(reactions, 20, limb2_U_0_joint_sent_fx);
    /* limb2: reactions, eq. (32); balance, eqs. (40)-(47); geometry */
    RESULT(checked1, reactions, 21, t853 - param_R * limb2_U_0_joint_sent_fx);
    const REAL limb2_U_0_joint_sent_fy = minus_limb2_U_0_cos * minus_limb2_lower_joint_sent_fx - t839;
    WRITE(reactions, 18, limb2_U_0_joint_sent_fy);
    RESULT(checked2, reactions, 23, param_R * limb2_U_0_joint_sent_fy + t858);
    const REAL t859 = limb2_U_0_sin * minus_limb2_upper_sent_fz,
      t861 = minus_limb2_U_0_cos * minus_limb2_upper_sent_fz,
      limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin,
      minus_limb2_P_reaction_fx = t859 + limb2_lower_rotation_xy * minus_limb2_upper_sent_fy;
    RESULT(checked3, reactions, 24, -minus_limb2_P_reaction_fx);
    const REAL minus_limb2_P_reaction_fy = limb2_lower_cos * minus_limb2_upper_sent_fy;
    RESULT(checked0, reactions, 25, -minus_limb2_P_reaction_fy);
    const REAL limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin,
      limb2_P_reaction_fz = t861 - limb2_lower_rotation_zy * minus_limb2_upper_sent_fy;
    WRITE(reactions, 26, limb2_P_reaction_fz);
    const REAL t864 = minus_limb2_upper_position_y * limb2_P_reaction_fz,
      minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos,
      minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx,
      t865 = minus_limb2_upper_position_z * minus_limb2_P_reaction_fy + t864,
      t870 = limb2_lower_rotation_xy * minus_limb2_upper_rate_my_2,
      t889 = limb2_lower_rotation_xy * limb2_S_multiplier_fy,
      minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos,
      minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx,
      t874 = minus_limb2_upper_position_x * limb2_P_reaction_fz,
      t886 = minus_limb2_upper_position_x * minus_limb2_P_reaction_fy,
      t872 = t870 - minus_limb2_lower_rotation_xx * minus_limb2_upper_rate_mx,
      t891 = t889 + minus_limb2_lower_rotation_xx * minus_limb2_S_multiplier_fx;
    RESULT(checked1, reactions, 27, -(t865 + (limb2_U_0_sin * minus_limb2_upper_rate_mz_2 + t872)));
    const REAL t880 = minus_limb2_U_0_cos * minus_limb2_upper_rate_mz_2,
      t876 = t874 + minus_limb2_upper_position_z * minus_limb2_P_reaction_fx,
      t887 = minus_limb2_upper_position_y * minus_limb2_P_reaction_fx - t886,
      t881 = limb2_lower_rotation_zy * minus_limb2_upper_rate_my_2,
      t895 = limb2_lower_rotation_zy * limb2_S_multiplier_fy;
    RESULT(checked2, reactions, 28, t876 - (limb2_lower_cos * minus_limb2_upper_rate_my_2 + limb2_lower_sin * minus_limb2_upper_rate_mx));
    RESULT(checked3, reactions, 29, t880 - (t881 - minus_limb2_lower_rotation_zx * minus_limb2_upper_rate_mx) - t887);
    const REAL t897 = t895 + minus_limb2_lower_rotation_zx * minus_limb2_S_multiplier_fx,
      t888 = limb2_U_0_sin * limb2_S_multiplier_fz, minus_limb2_S_reaction_fx = t888 + t891;
    RESULT(checked0, reactions, 30, -minus_limb2_S_reaction_fx);
    const REAL t894 = minus_limb2_U_0_cos * limb2_S_multiplier_fz, limb2_S_reaction_fz = t894 - t897;
    WRITE(reactions, 32, limb2_S_reaction_fz);
    const REAL t899 = minus_limb2_upper_position_y * limb2_S_reaction_fz,
      t900 = minus_limb2_upper_position_x * limb2_S_reaction_fz,
      t902 = minus_limb2_upper_position_y * minus_limb2_S_reaction_fx;
    RESULT(checked1, reactions, 34, t900 + minus_limb2_upper_position_z * minus_limb2_S_reaction_fx);
    const REAL t1046 = limb2_lower_sin * limb2_S_multiplier_fy,
      limb2_S_reaction_fy = limb2_lower_sin * minus_limb2_S_multiplier_fx - limb2_lower_cos * limb2_S_multiplier_fy;
    WRITE(reactions, 31, limb2_S_reaction_fy);
    RESULT(checked2, reactions, 33, minus_limb2_upper_position_z * limb2_S_reaction_fy - t899);
    RESULT(checked3, reactions, 35, -(t902 + minus_limb2_upper_position_x * limb2_S_reaction_fy));
    const REAL t1047 = limb2_lower_cos * minus_limb2_S_multiplier_fx + t1046;
    /* limb3: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t907 = minus_limb3_lower_sin * limb3_lower_sent_fy;
    RESULT(checked0, reactions, 36, minus_limb3_lower_sin * minus_limb3_lower_sent_fx + limb3_lower_cos * limb3_lower_sent_fy);
    const REAL minus_limb3_lower_joint_sent_fx = limb3_lower_cos * minus_limb3_lower_sent_fx - t907,
      t909 = limb3_U_0_cos * limb3_lower_sent_fz,
      minus_limb3_U_0_joint_sent_fy = limb3_U_0_cos * minus_limb3_lower_joint_sent_fx - limb3_U_0_sin * limb3_lower_sent_fz;
    RESULT(checked1, reactions, 38, -minus_limb3_U_0_joint_sent_fy);
    const REAL t921 = param_R * minus_limb3_U_0_joint_sent_fy,
      limb3_U_0_joint_sent_fx = limb3_U_0_sin * minus_limb3_lower_joint_sent_fx + t909;
    WRITE(reactions, 37, limb3_U_0_joint_sent_fx);
    const REAL t925 = param_R * limb3_U_0_joint_sent_fx,
      minus_limb3_lower_sent_my = minus_limb3_lower_rate_my_2 + (minus_limb3_upper_rate_my_2 + limb3_upper_offset_x * limb3_upper_sent_fz),
      t920 = limb3_lower_cos * minus_limb3_lower_sent_my, t922 = minus_limb3_lower_sin * minus_limb3_lower_sent_my,
      minus_limb3_lower_sent_mx = 2.0 * minus_limb3_upper_rate_mx;
    RESULT(checked2, reactions, 39, minus_limb3_lower_sin * minus_limb3_lower_sent_mx - t920);
    const REAL minus_limb3_lower_joint_sent_mx = t922 + limb3_lower_cos * minus_limb3_lower_sent_mx;
    /* limb3: reactions, eq. (32); geometry; balance, eqs. (40)-(47) */
    RESULT(checked3, reactions, 40, t921 + limb3_U_0_sin * minus_limb3_lower_joint_sent_mx);
    RESULT(checked0, reactions, 41, t925 - limb3_U_0_cos * minus_limb3_lower_joint_sent_mx);
    const REAL t927 = limb3_U_0_cos * limb3_upper_sent_fz, t929 = limb3_U_0_sin * limb3_upper_sent_fz,
      minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin,
      limb3_P_reaction_fy = t927 - minus_limb3_lower_rotation_yy * limb3_upper_sent_fy;
    WRITE(reactions, 43, limb3_P_reaction_fy);
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos,
      limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx,
      t931 = limb3_upper_position_z * limb3_P_reaction_fy, t949 = limb3_upper_position_x * limb3_P_reaction_fy,
      limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin,
      limb3_P_reaction_fz = t929 + limb3_lower_rotation_zy * limb3_upper_sent_fy;
    WRITE(reactions, 44, limb3_P_reaction_fz);
    const REAL limb3_P_reaction_fx = limb3_lower_cos * limb3_upper_sent_fy;
    WRITE(reactions, 42, limb3_P_reaction_fx);
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos,
      minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx,
      t933 = t931 + minus_limb3_upper_position_y * limb3_P_reaction_fz,
      t937 = limb3_upper_position_x * limb3_P_reaction_fz, t934 = limb3_lower_cos * minus_limb3_upper_rate_my_2;
    RESULT(checked1, reactions, 45, -(t933 + (t934 - minus_limb3_lower_sin * minus_limb3_upper_rate_mx)));
    const REAL t939 = t937 - limb3_upper_position_z * limb3_P_reaction_fx,
      t950 = minus_limb3_upper_position_y * limb3_P_reaction_fx + t949,
      t944 = minus_limb3_lower_rotation_yy * minus_limb3_upper_rate_my_2,
      t952 = limb3_lower_rotation_zy * minus_limb3_upper_rate_my_2,
      t959 = minus_limb3_lower_rotation_yy * limb3_S_multiplier_fy,
      t963 = limb3_lower_rotation_zy * limb3_S_multiplier_fy,
      t946 = t944 + minus_limb3_lower_rotation_yx * minus_limb3_upper_rate_mx,
      t954 = t952 + limb3_lower_rotation_zx * minus_limb3_upper_rate_mx,
      t961 = t959 - minus_limb3_lower_rotation_yx * minus_limb3_S_multiplier_fx,
      t965 = t963 - limb3_lower_rotation_zx * minus_limb3_S_multiplier_fx;
    RESULT(checked2, reactions, 46, -(t939 + (limb3_U_0_cos * minus_limb3_upper_rate_mz_2 - t946)));
    RESULT(checked3, reactions, 47, t950 - (limb3_U_0_sin * minus_limb3_upper_rate_mz_2 + t954));
    const REAL t1064 = minus_limb3_lower_sin * limb3_S_multiplier_fy,
      minus_limb3_S_reaction_fx = minus_limb3_lower_sin * minus_limb3_S_multiplier_fx + limb3_lower_cos * limb3_S_multiplier_fy;
    RESULT(checked0, reactions, 48, -minus_limb3_S_reaction_fx);
    const REAL t1065 = limb3_lower_cos * minus_limb3_S_multiplier_fx - t1064,
      t958 = limb3_U_0_cos * minus_limb3_S_multiplier_fz, limb3_S_reaction_fy = t958 + t961;
    WRITE(reactions, 49, limb3_S_reaction_fy);
    const REAL t962 = limb3_U_0_sin * minus_limb3_S_multiplier_fz, limb3_S_reaction_fz = t962 - t965;
    WRITE(reactions, 50, limb3_S_reaction_fz);
    const REAL t966 = limb3_upper_position_z * limb3_S_reaction_fy,
      t969 = limb3_upper_position_z * minus_limb3_S_reaction_fx, t970 = limb3_upper_position_x * limb3_S_reaction_fy;
    RESULT(checked1, reactions, 52, -(limb3_upper_position_x * limb3_S_reaction_fz + t969));
    RESULT(checked2, reactions, 51, -(t966 + minus_limb3_upper_position_y * limb3_S_reaction_fz));
    RESULT(checked3, reactions, 53, t970 - minus_limb3_upper_position_y * minus_limb3_S_reaction_fx);
    /* limb4: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t973 = minus_limb4_lower_sin * limb4_lower_sent_fy;
    RESULT(checked0, reactions, 55, minus_limb4_lower_sin * minus_limb4_lower_sent_fx + limb4_lower_cos * limb4_lower_sent_fy);
    const REAL minus_limb4_lower_joint_sent_fx = limb4_lower_cos * minus_limb4_lower_sent_fx - t973,
      limb4_lower_sent_my = limb4_lower_rate_my_2 - (minus_limb4_upper_rate_my_2 + limb4_upper_offset_x * limb4_upper_sent_fz),
      t986 = minus_limb4_lower_sin * limb4_lower_sent_my, t991 = limb4_lower_cos * limb4_lower_sent_my,
      minus_limb4_lower_sent_mx = 2.0 * minus_limb4_upper_rate_mx,
      limb4_lower_joint_sent_mx = t986 - limb4_lower_cos * minus_limb4_lower_sent_mx;
    RESULT(checked1, reactions, 58, t991 + minus_limb4_lower_sin * minus_limb4_lower_sent_mx);
    const REAL t990 = minus_limb4_U_0_cos * limb4_lower_joint_sent_mx,
      t994 = limb4_U_0_sin * limb4_lower_joint_sent_mx, t975 = limb4_U_0_sin * limb4_lower_sent_fz,
      limb4_U_0_joint_sent_fx = limb4_U_0_sin * minus_limb4_lower_joint_sent_fx - minus_limb4_U_0_cos * limb4_lower_sent_fz;
    WRITE(reactions, 56, limb4_U_0_joint_sent_fx);
    /* limb4: reactions, eq. (32); balance, eqs. (40)-(47); geometry */
    RESULT(checked2, reactions, 57, param_R * limb4_U_0_joint_sent_fx - t990);
    const REAL limb4_U_0_joint_sent_fy = minus_limb4_U_0_cos * minus_limb4_lower_joint_sent_fx + t975;
    WRITE(reactions, 54, limb4_U_0_joint_sent_fy);
    RESULT(checked3, reactions, 59, -(param_R * limb4_U_0_joint_sent_fy + t994));
    const REAL t997 = minus_limb4_U_0_cos * limb4_upper_sent_fz, t995 = limb4_U_0_sin * limb4_upper_sent_fz,
      minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin,
      minus_limb4_P_reaction_fz = t997 + minus_limb4_lower_rotation_zy * limb4_upper_sent_fy;
    RESULT(checked0, reactions, 62, -minus_limb4_P_reaction_fz);
    const REAL t1000 = limb4_upper_position_y * minus_limb4_P_reaction_fz,
      limb4_P_reaction_fy = limb4_lower_cos * limb4_upper_sent_fy;
    WRITE(reactions, 61, limb4_P_reaction_fy);
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos,
      minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx,
      t1001 = minus_limb4_upper_position_z * limb4_P_reaction_fy - t1000,
      minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin,
      limb4_P_reaction_fx = t995 - minus_limb4_lower_rotation_xy * limb4_upper_sent_fy;
    WRITE(reactions, 60, limb4_P_reaction_fx);
    const REAL t1006 = minus_limb4_lower_rotation_xy * minus_limb4_upper_rate_my_2,
      t1025 = minus_limb4_lower_rotation_xy * minus_limb4_S_multiplier_fy,
      minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos,
      minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx,
      t1010 = minus_limb4_upper_position_x * minus_limb4_P_reaction_fz,
      t1022 = minus_limb4_upper_position_x * limb4_P_reaction_fy,
      t1008 = t1006 + minus_limb4_lower_rotation_xx * minus_limb4_upper_rate_mx,
      t1027 = t1025 + minus_limb4_lower_rotation_xx * minus_limb4_S_multiplier_fx;
    RESULT(checked1, reactions, 63, t1001 - (limb4_U_0_sin * minus_limb4_upper_rate_mz_2 - t1008));
    const REAL t1016 = minus_limb4_U_0_cos * minus_limb4_upper_rate_mz_2,
      t1012 = t1010 + minus_limb4_upper_position_z * limb4_P_reaction_fx,
      t1023 = limb4_upper_position_y * limb4_P_reaction_fx + t1022,
      t1013 = limb4_lower_cos * minus_limb4_upper_rate_my_2,
      t1017 = minus_limb4_lower_rotation_zy * minus_limb4_upper_rate_my_2,
      t1031 = minus_limb4_lower_rotation_zy * minus_limb4_S_multiplier_fy;
    RESULT(checked2, reactions, 64, -(t1012 + (t1013 - minus_limb4_lower_sin * minus_limb4_upper_rate_mx)));
    RESULT(checked3, reactions, 65, t1016 + (t1017 + minus_limb4_lower_rotation_zx * minus_limb4_upper_rate_mx) - t1023);
    const REAL t1033 = t1031 + minus_limb4_lower_rotation_zx * minus_limb4_S_multiplier_fx,
      t1024 = limb4_U_0_sin * limb4_S_multiplier_fz, minus_limb4_S_reaction_fx = t1024 + t1027;
    RESULT(checked0, reactions, 66, -minus_limb4_S_reaction_fx);
    const REAL t1030 = minus_limb4_U_0_cos * limb4_S_multiplier_fz, limb4_S_reaction_fz = t1030 - t1033;
    WRITE(reactions, 68, limb4_S_reaction_fz);
    const REAL t1029 = limb4_lower_cos * minus_limb4_S_multiplier_fy,
      t1041 = minus_limb4_lower_sin * minus_limb4_S_multiplier_fy,
      minus_limb4_S_reaction_fy = minus_limb4_lower_sin * minus_limb4_S_multiplier_fx - t1029;
    RESULT(checked1, reactions, 67, -minus_limb4_S_reaction_fy);
    const REAL t1042 = limb4_lower_cos * minus_limb4_S_multiplier_fx + t1041,
      t1034 = limb4_upper_position_y * limb4_S_reaction_fz,
      t1036 = minus_limb4_upper_position_x * limb4_S_reaction_fz,
      t1038 = limb4_upper_position_y * minus_limb4_S_reaction_fx;
    RESULT(checked2, reactions, 70, t1036 + minus_limb4_upper_position_z * minus_limb4_S_reaction_fx);
    RESULT(checked3, reactions, 69, t1034 - minus_limb4_upper_position_z * minus_limb4_S_reaction_fy);
    RESULT(checked0, reactions, 71, t1038 + minus_limb4_upper_position_x * minus_limb4_S_reaction_fy);
    /* platform: momentum rate, eq. (35) */
    const REAL platform_rate_fy_2 = platform_m_gravity_z * platform_turn_zy + platform_rate_fy;
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t1055 = platform_turn_xy * platform_rate_fy_2, t1074 = platform_turn_yy * platform_rate_fy_2,
      t1090 = platform_turn_zy * platform_rate_fy_2,
      platform_rate_fx_2 = platform_m_gravity_z * platform_turn_zx + platform_rate_fx,
      t1058 = t1055 + platform_turn_xx * platform_rate_fx_2, t1076 = t1074 + platform_turn_yx * platform_rate_fx_2,
      t1092 = t1090 + platform_turn_zx * platform_rate_fx_2, t1052 = platform_m_gravity_z * platform_turn_zz,
      minus_platform_rate_fz_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t1052,
      t1060 = limb1_U2_reaction_fx + (platform_turn_xz * minus_platform_rate_fz_2 - t1058),
      t1077 = platform_turn_yz * minus_platform_rate_fz_2 - t1076,
      t1093 = platform_turn_zz * minus_platform_rate_fz_2 - t1092,
      t1062 = minus_limb3_S_reaction_fx + (minus_limb2_U_0_cos * t1047 + t888 - t1060),
      t1086 = limb2_U_0_sin * t1047 - t894; /* limb2 */
    RESULT(checked1, reactions, 72, minus_limb4_U_0_cos * t1042 + t1024 + t1062);
    const REAL t1082 = limb4_U_0_sin * t1042 - t1030, /* limb4 */
      t1079 = limb2_S_reaction_fy + (limb1_U_0_sin * t1070 - t812 + t1077),
      t1095 = t1086 + (limb1_U_0_cos * t1070 + t816 - t1093);
    RESULT(checked2, reactions, 73, minus_limb4_S_reaction_fy + (limb3_U_0_sin * t1065 - t958 - t1079));
    RESULT(checked3, reactions, 74, t1082 - (limb3_U_0_cos * t1065 + t962 - t1095));
    WRITE(reactions, 75, CONSTANT(0.0));
    WRITE(reactions, 76, CONSTANT(0.0));
    WRITE(reactions, 77, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t35, 0.999999, 5);
    NOT_ABOVE(t35, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-06) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-06) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-06) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-06) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-05) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 0.0007562600000000001) OR /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 0.0007551200000000001) OR /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(platform_joint_force_mz_by_limb1_U2_mn, 4.017100000000001e-06), /* where limb1_U2.mn cannot balance platform.moment_z */
        (checked0 + checked1) + (checked2 + checked3));
}

#if !defined(THREE_UPS_UPU_S_VECTORS)

BODY(three_ups_upu_s_forward_dynamics_dense)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, double *restrict inertia_, double *restrict load_,
    double *restrict closure_, double *restrict curvature_, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    /* limb1: geometry; inertia */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    WRITE(closure_, 14, limb1_upper_offset_x);
    const REAL t3 = limb1_upper_offset_x * (k7 - limb_lower_m * limb1_upper_offset_x),
      limb1_U_mass_matrix_1_by_limb1_U_1 = k9 - t3;
    WRITE(inertia_, 16, limb1_U_mass_matrix_1_by_limb1_U_1);
    REAL checked0 = limb1_U_mass_matrix_1_by_limb1_U_1;
    const REAL limb1_lower_cos = SINES(cosine, 1),
      limb1_U_mass_matrix_0_by_limb1_U_0 = k3 - limb1_lower_cos * (limb1_lower_cos * (t3 - k8));
    WRITE(inertia_, 0, limb1_U_mass_matrix_0_by_limb1_U_0);
    REAL checked1 = limb1_U_mass_matrix_0_by_limb1_U_0;
    /* limb2: geometry; inertia */
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    WRITE(closure_, 57, limb2_upper_offset_x);
    const REAL t9 = limb2_upper_offset_x * (k7 - limb_lower_m * limb2_upper_offset_x),
      limb2_U_mass_matrix_1_by_limb2_U_1 = k9 - t9;
    WRITE(inertia_, 64, limb2_U_mass_matrix_1_by_limb2_U_1);
    REAL checked2 = limb2_U_mass_matrix_1_by_limb2_U_1;
    const REAL limb2_lower_cos = SINES(cosine, 3),
      limb2_U_mass_matrix_0_by_limb2_U_0 = k3 - limb2_lower_cos * (limb2_lower_cos * (t9 - k8));
    WRITE(inertia_, 48, limb2_U_mass_matrix_0_by_limb2_U_0);
    REAL checked3 = limb2_U_mass_matrix_0_by_limb2_U_0;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    WRITE(closure_, 99, limb3_upper_offset_x);
    const REAL t15 = limb3_upper_offset_x * (k7 - limb_lower_m * limb3_upper_offset_x); /* limb3 */
    RESULT(checked0, inertia_, 112, k9 - t15);
    const REAL limb3_lower_cos = SINES(cosine, 5);
    RESULT(checked1, inertia_, 96, k3 - limb3_lower_cos * (limb3_lower_cos * (t15 - k8)));
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    WRITE(closure_, 141, limb4_upper_offset_x);
    const REAL t21 = limb4_upper_offset_x * (k7 - limb_lower_m * limb4_upper_offset_x); /* limb4 */
    RESULT(checked2, inertia_, 160, k9 - t21);
    const REAL limb4_lower_cos = SINES(cosine, 7);
    RESULT(checked3, inertia_, 144, k3 - limb4_lower_cos * (limb4_lower_cos * (t21 - k8)));
    /* limb1: velocities, eq. (6); geometry */
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1),
      limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    /* limb1: accelerations; geometry; balance, eqs. (40)-(47) */
    const REAL limb1_U_v_1 = READ(v, 1), minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x,
      t27 = limb1_upper_offset_x * (2.0 * minus_limb1_lower_alpha_still_y), limb1_U_0_sin = SINES(sine, 0),
      t28 = t27 + gravity_z * limb1_U_0_sin, limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos,
      limb1_P_v = READ(v, 2), t26 = limb1_P_v * (2.0 * limb1_lower_omega_y),
      minus_limb1_upper_acc_still_z = t26 - t28, limb1_upper_acc_still_z = t27 - t26,
      minus_limb1_upper_rate_my = limb_lower_mx * minus_limb1_upper_acc_still_z,
      t29 = limb1_upper_offset_x * (k7 * minus_limb1_lower_alpha_still_y + limb_lower_m * minus_limb1_upper_acc_still_z),
      t30 = minus_limb1_upper_rate_my - t29,
      t32 = limb1_lower_cos * (t30 + (gravity_z_limb_lower_mx * limb1_U_0_sin + k11 * minus_limb1_lower_alpha_still_y)),
      limb1_lower_alpha_still_x = limb1_U_v_1 * limb1_lower_omega_y;
    RESULT(checked0, load_, 0, t32 - limb1_lower_sin * (k10 * limb1_lower_alpha_still_x));
    const REAL limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y,
      t36 = limb1_upper_offset_x * limb1_lower_U_still_xy, limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_acc_y = gravity_z * limb1_U_0_cos, minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y,
      limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y, t37 = t36 - minus_limb1_lower_acc_y,
      limb1_upper_moment_z = limb_lower_mx * minus_limb1_lower_acc_y, t35 = limb1_P_v * (2.0 * limb1_U_v_1),
      limb1_upper_acc_still_y = t35 + t37, limb1_upper_acc_still_y_2 = t36 + t35,
      minus_limb1_upper_rate_mz = limb_lower_mx * limb1_upper_acc_still_y,
      t38 = limb1_upper_offset_x * (limb_lower_mx * limb1_lower_U_still_xy - limb_lower_m * limb1_upper_acc_still_y);
    RESULT(checked1, load_, 1, minus_limb1_upper_rate_mz + t38 - (k8 * limb1_lower_U_still_xy - limb1_upper_moment_z));
    const REAL minus_limb1_lower_U_still_xx = limb1_lower_omega_y * limb1_lower_omega_y + limb1_U_v_1 * limb1_U_v_1,
      minus_limb1_upper_acc_still_x = limb1_upper_offset_x * minus_limb1_lower_U_still_xx,
      minus_limb1_lower_force_x = limb_lower_m * (minus_limb1_upper_acc_still_x - limb1_lower_acc_x);
    RESULT(checked2, load_, 2, READ(u, 0) - (limb_lower_mx * minus_limb1_lower_U_still_xx - minus_limb1_lower_force_x));
    /* limb2: velocities, eq. (6); geometry */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3),
      limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin;
    /* limb2: accelerations; geometry; balance, eqs. (40)-(47) */
    const REAL limb2_U_v_1 = READ(v, 4), minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x,
      t45 = limb2_upper_offset_x * (2.0 * minus_limb2_lower_alpha_still_y), minus_limb2_U_0_cos = SINES(sine, 2),
      t46 = t45 - gravity_z * minus_limb2_U_0_cos, limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos,
      limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y, limb2_P_v = READ(v, 5),
      t44 = limb2_P_v * (2.0 * limb2_lower_omega_y), minus_limb2_upper_acc_still_z = t44 - t46,
      limb2_upper_acc_still_z = t45 - t44, minus_limb2_upper_rate_my = limb_lower_mx * minus_limb2_upper_acc_still_z,
      t47 = limb2_upper_offset_x * (k7 * minus_limb2_lower_alpha_still_y + limb_lower_m * minus_limb2_upper_acc_still_z),
      t48 = minus_limb2_upper_rate_my - t47,
      minus_limb2_lower_moment_y = t48 - (gravity_z_limb_lower_mx * minus_limb2_U_0_cos - k11 * minus_limb2_lower_alpha_still_y),
      t50 = limb2_lower_cos * minus_limb2_lower_moment_y;
    RESULT(checked3, load_, 3, t50 - limb2_lower_sin * (k10 * (limb2_U_v_1 * limb2_lower_omega_y)));
    const REAL t59 = limb2_lower_omega_y * limb2_lower_omega_y, t54 = limb2_upper_offset_x * limb2_lower_U_still_xy,
      limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin,
      limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y,
      minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y, t55 = t54 + limb2_lower_acc_y,
      minus_limb2_upper_moment_z = limb_lower_mx * limb2_lower_acc_y, t53 = limb2_P_v * (2.0 * limb2_U_v_1),
      limb2_upper_acc_still_y = t53 + t55, limb2_upper_acc_still_y_2 = t54 + t53,
      minus_limb2_upper_rate_mz = limb_lower_mx * limb2_upper_acc_still_y,
      t56 = limb2_upper_offset_x * (limb_lower_mx * limb2_lower_U_still_xy - limb_lower_m * limb2_upper_acc_still_y);
    RESULT(checked0, load_, 4, minus_limb2_upper_rate_mz + t56 - (k8 * limb2_lower_U_still_xy + minus_limb2_upper_moment_z));
    const REAL minus_limb2_lower_U_still_xx = t59 + limb2_U_v_1 * limb2_U_v_1,
      minus_limb2_upper_acc_still_x = limb2_upper_offset_x * minus_limb2_lower_U_still_xx,
      minus_limb2_lower_force_x = limb_lower_m * (minus_limb2_upper_acc_still_x + minus_limb2_lower_acc_x);
    RESULT(checked1, load_, 5, READ(u, 1) - (limb_lower_mx * minus_limb2_lower_U_still_xx - minus_limb2_lower_force_x));
    /* limb3: velocities, eq. (6); geometry */
    const REAL limb3_U_v_0 = READ(v, 6), minus_limb3_lower_sin = SINES(sine, 5),
      minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin;
    /* limb3: accelerations; geometry; balance, eqs. (40)-(47) */
    const REAL limb3_U_v_1 = READ(v, 7), limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x,
      t64 = limb3_upper_offset_x * (2.0 * limb3_lower_alpha_still_y), limb3_U_0_sin = SINES(sine, 4),
      t65 = t64 - gravity_z * limb3_U_0_sin, limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos,
      minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y, limb3_P_v = READ(v, 8),
      t63 = limb3_P_v * (2.0 * limb3_lower_omega_y), minus_limb3_upper_acc_still_z = t63 + t65,
      minus_limb3_upper_acc_still_z_2 = t64 + t63,
      minus_limb3_upper_rate_my = limb_lower_mx * minus_limb3_upper_acc_still_z,
      t66 = limb3_upper_offset_x * (k7 * limb3_lower_alpha_still_y - limb_lower_m * minus_limb3_upper_acc_still_z),
      t67 = minus_limb3_upper_rate_my + t66,
      t69 = limb3_lower_cos * (t67 + (gravity_z_limb_lower_mx * limb3_U_0_sin - k11 * limb3_lower_alpha_still_y));
    RESULT(checked2, load_, 6, minus_limb3_lower_sin * (k10 * (limb3_U_v_1 * limb3_lower_omega_y)) + t69);
    const REAL t77 = limb3_lower_omega_y * limb3_lower_omega_y,
      t73 = limb3_upper_offset_x * minus_limb3_lower_U_still_xy, limb3_U_0_cos = SINES(cosine, 4),
      limb3_U_0_acc_y = gravity_z * limb3_U_0_cos, limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y,
      limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y, t74 = t73 - limb3_lower_acc_y,
      minus_limb3_upper_moment_z = limb_lower_mx * limb3_lower_acc_y, t72 = limb3_P_v * (2.0 * limb3_U_v_1),
      limb3_upper_acc_still_y = t72 - t74, minus_limb3_upper_acc_still_y = t73 - t72,
      minus_limb3_upper_rate_mz = limb_lower_mx * limb3_upper_acc_still_y,
      t75 = limb3_upper_offset_x * (limb_lower_mx * minus_limb3_lower_U_still_xy + limb_lower_m * limb3_upper_acc_still_y),
      t76 = minus_limb3_upper_rate_mz - t75;
    RESULT(checked3, load_, 7, k8 * minus_limb3_lower_U_still_xy - minus_limb3_upper_moment_z + t76);
    const REAL minus_limb3_lower_U_still_xx = t77 + limb3_U_v_1 * limb3_U_v_1,
      minus_limb3_upper_acc_still_x = limb3_upper_offset_x * minus_limb3_lower_U_still_xx,
      minus_limb3_lower_force_x = limb_lower_m * (minus_limb3_upper_acc_still_x - limb3_lower_acc_x);
    RESULT(checked0, load_, 8, READ(u, 2) - (limb_lower_mx * minus_limb3_lower_U_still_xx - minus_limb3_lower_force_x));
    /* limb4: velocities, eq. (6); geometry */
    const REAL limb4_U_v_0 = READ(v, 9), minus_limb4_lower_sin = SINES(sine, 7),
      minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin;
    /* limb4: accelerations; geometry; balance, eqs. (40)-(47) */
    const REAL limb4_U_v_1 = READ(v, 10), limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x,
      t82 = limb4_upper_offset_x * (2.0 * limb4_lower_alpha_still_y), minus_limb4_U_0_cos = SINES(sine, 6),
      t83 = t82 + gravity_z * minus_limb4_U_0_cos, limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos,
      minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y, limb4_P_v = READ(v, 11),
      t81 = limb4_P_v * (2.0 * limb4_lower_omega_y), minus_limb4_upper_acc_still_z = t81 + t83,
      minus_limb4_upper_acc_still_z_2 = t82 + t81,
      minus_limb4_upper_rate_my = limb_lower_mx * minus_limb4_upper_acc_still_z,
      t84 = limb4_upper_offset_x * (k7 * limb4_lower_alpha_still_y - limb_lower_m * minus_limb4_upper_acc_still_z),
      t85 = minus_limb4_upper_rate_my + t84,
      t87 = limb4_lower_cos * (t85 - (gravity_z_limb_lower_mx * minus_limb4_U_0_cos + k11 * limb4_lower_alpha_still_y));
    RESULT(checked1, load_, 9, minus_limb4_lower_sin * (k10 * (limb4_U_v_1 * limb4_lower_omega_y)) + t87);
    const REAL t95 = limb4_lower_omega_y * limb4_lower_omega_y,
      t91 = limb4_upper_offset_x * minus_limb4_lower_U_still_xy, limb4_U_0_sin = SINES(cosine, 6),
      minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y,
      minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y, t92 = t91 + minus_limb4_lower_acc_y,
      limb4_upper_moment_z = limb_lower_mx * minus_limb4_lower_acc_y, t90 = limb4_P_v * (2.0 * limb4_U_v_1),
      limb4_upper_acc_still_y = t90 - t92, minus_limb4_upper_acc_still_y = t91 - t90,
      minus_limb4_upper_rate_mz = limb_lower_mx * limb4_upper_acc_still_y,
      t93 = limb4_upper_offset_x * (limb_lower_mx * minus_limb4_lower_U_still_xy + limb_lower_m * limb4_upper_acc_still_y);
    RESULT(checked2, load_, 10, k8 * minus_limb4_lower_U_still_xy + limb4_upper_moment_z + (minus_limb4_upper_rate_mz - t93));
    const REAL minus_limb4_lower_U_still_xx = t95 + limb4_U_v_1 * limb4_U_v_1,
      minus_limb4_upper_acc_still_x = limb4_upper_offset_x * minus_limb4_lower_U_still_xx,
      minus_limb4_lower_force_x = limb_lower_m * (minus_limb4_upper_acc_still_x + minus_limb4_lower_acc_x);
    RESULT(checked3, load_, 11, READ(u, 3) - (limb_lower_mx * minus_limb4_lower_U_still_xx - minus_limb4_lower_force_x));
    /* limb5_S: geometry; reciprocal wrenches, eq. (10); loop closure */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t97 = limb5_S_q_qw * limb5_S_q_qw,
      t98 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t99 = t97 + t98,
      t100 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t101 = limb5_S_q_qz * limb5_S_q_qz,
      t102 = t100 + t101, t103 = t99 + t102, t105 = 4.0 - 2.0 * t103, platform_turn_xx = 1.0 - t102 * t105,
      t227 = t98 + t100, platform_turn_yy = 1.0 - t105 * (t98 + t101), platform_turn_zz = 1.0 - t105 * t227,
      t106 = limb5_S_q_qz * t105, t107 = limb5_S_q_qy * t106, t109 = limb5_S_q_qw * (limb5_S_q_qx * t105),
      t113 = limb5_S_q_qy * t105, platform_turn_zy = t107 + t109, platform_turn_yz = t107 - t109,
      limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14);
    RESULT(checked0, load_, 12, gravity_z_platform_mz * platform_turn_zy - k12 * (limb5_S_v_wy * limb5_S_v_wz));
    const REAL t112 = limb5_S_q_qx * t106, t124 = limb5_S_q_qw * t106, t114 = limb5_S_q_qw * t113,
      t123 = limb5_S_q_qx * t113, platform_turn_zx = t112 - t114, platform_turn_xz = t112 + t114,
      limb5_S_v_wx = READ(v, 12);
    RESULT(checked1, load_, 13, k12 * (limb5_S_v_wx * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zx);
    const REAL minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    RESULT(checked2, closure_, 2, -minus_limb1_U_0_lever_mz_by_limb1_U2_fz);
    const REAL minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    RESULT(checked3, closure_, 45, -minus_limb2_U_0_lever_mz_by_limb2_S_fz);
    const REAL minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    RESULT(checked0, closure_, 87, -minus_limb3_U_0_lever_mz_by_limb3_S_fz);
    const REAL minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    RESULT(checked1, closure_, 129, -minus_limb4_U_0_lever_mz_by_limb4_S_fz);
    const REAL platform_turn_yx = t123 + t124, platform_turn_xy = t123 - t124,
      base_lever_my_by_limb1_U2_fx = param_R * (limb1_U_0_cos * limb1_lower_cos),
      t126 = platform_turn_yx * base_lever_my_by_limb1_U2_fx,
      base_lever_mz_by_limb1_U2_fx = param_R * (limb1_U_0_sin * limb1_lower_cos);
    RESULT(checked2, closure_, 156, -(t126 + platform_turn_zx * base_lever_mz_by_limb1_U2_fx));
    const REAL base_lever_my_by_limb1_U2_fy = limb1_U_0_cos * limb1_upper_offset_x - param_R * (limb1_U_0_cos * limb1_lower_sin),
      t131 = platform_turn_yx * base_lever_my_by_limb1_U2_fy,
      base_lever_mz_by_limb1_U2_fy = limb1_U_0_sin * limb1_upper_offset_x - param_R * (limb1_U_0_sin * limb1_lower_sin);
    RESULT(checked3, closure_, 157, -(t131 + platform_turn_zx * base_lever_mz_by_limb1_U2_fy));
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      base_lever_my_by_limb1_U2_fz = limb1_U_0_sin * minus_limb1_upper_position_x,
      minus_base_lever_mz_by_limb1_U2_fz = limb1_U_0_cos * minus_limb1_upper_position_x,
      t138 = platform_turn_yx * base_lever_my_by_limb1_U2_fz,
      t139 = platform_turn_xx * minus_limb1_U_0_lever_mz_by_limb1_U2_fz - t138;
    RESULT(checked0, closure_, 158, t139 + platform_turn_zx * minus_base_lever_mz_by_limb1_U2_fz);
    /* limb1: reciprocal wrenches, eq. (10); loop closure */
    const REAL t121 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy,
      t320 = limb1_lower_sin * t121,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t121 - limb1_lower_sin * platform_turn_xy;
    WRITE(closure_, 16, limb1_U2_constraint_mn_couple_z);
    const REAL t142 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x;
    /* mechanism: reciprocal wrenches, eq. (10); loop closure; velocities, eq. (6) */
    const REAL base_lever_my_by_limb1_U2_mn = t142 - limb1_U_0_sin * limb1_U_0_lever_my_by_limb1_U2_mn,
      t146 = limb1_U_0_cos * limb1_U_0_lever_my_by_limb1_U2_mn, /* limb1 */
      t143 = platform_turn_yx * base_lever_my_by_limb1_U2_mn,
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    WRITE(closure_, 3, limb1_U_0_lever_mz_by_limb1_U2_mn);
    const REAL t144 = platform_turn_xx * limb1_U_0_lever_mz_by_limb1_U2_mn + t143,
      base_lever_mz_by_limb1_U2_mn = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z + t146;
    RESULT(checked1, closure_, 159, -(t144 + platform_turn_zx * base_lever_mz_by_limb1_U2_mn));
    const REAL minus_base_lever_mz_by_limb2_S_fx = param_R * (minus_limb2_U_0_cos * limb2_lower_cos),
      t149 = platform_turn_zx * minus_base_lever_mz_by_limb2_S_fx,
      base_lever_mx_by_limb2_S_fx = param_R * (limb2_U_0_sin * limb2_lower_cos);
    RESULT(checked2, closure_, 160, t149 - platform_turn_xx * base_lever_mx_by_limb2_S_fx);
    const REAL minus_base_lever_mz_by_limb2_S_fy = minus_limb2_U_0_cos * limb2_upper_offset_x - param_R * (minus_limb2_U_0_cos * limb2_lower_sin),
      t153 = platform_turn_zx * minus_base_lever_mz_by_limb2_S_fy,
      base_lever_mx_by_limb2_S_fy = limb2_U_0_sin * limb2_upper_offset_x - param_R * (limb2_U_0_sin * limb2_lower_sin);
    RESULT(checked3, closure_, 161, t153 - platform_turn_xx * base_lever_mx_by_limb2_S_fy);
    const REAL t157 = platform_turn_yx * minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      base_lever_mx_by_limb2_S_fz = minus_limb2_U_0_cos * minus_limb2_upper_position_y,
      base_lever_mz_by_limb2_S_fz = limb2_U_0_sin * minus_limb2_upper_position_y,
      t159 = t157 - platform_turn_xx * base_lever_mx_by_limb2_S_fz;
    RESULT(checked0, closure_, 162, t159 - platform_turn_zx * base_lever_mz_by_limb2_S_fz);
    const REAL minus_base_lever_my_by_limb3_S_fx = param_R * (limb3_U_0_cos * limb3_lower_cos),
      t161 = platform_turn_yx * minus_base_lever_my_by_limb3_S_fx,
      minus_base_lever_mz_by_limb3_S_fx = param_R * (limb3_U_0_sin * limb3_lower_cos);
    RESULT(checked1, closure_, 163, t161 + platform_turn_zx * minus_base_lever_mz_by_limb3_S_fx);
    const REAL base_lever_my_by_limb3_S_fy = limb3_U_0_cos * limb3_upper_offset_x - param_R * (limb3_U_0_cos * minus_limb3_lower_sin),
      t165 = platform_turn_yx * base_lever_my_by_limb3_S_fy,
      base_lever_mz_by_limb3_S_fy = limb3_U_0_sin * limb3_upper_offset_x - param_R * (limb3_U_0_sin * minus_limb3_lower_sin);
    RESULT(checked2, closure_, 164, -(t165 + platform_turn_zx * base_lever_mz_by_limb3_S_fy));
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x,
      minus_base_lever_my_by_limb3_S_fz = limb3_U_0_sin * limb3_upper_position_x,
      base_lever_mz_by_limb3_S_fz = limb3_U_0_cos * limb3_upper_position_x,
      t171 = platform_turn_yx * minus_base_lever_my_by_limb3_S_fz,
      t172 = platform_turn_xx * minus_limb3_U_0_lever_mz_by_limb3_S_fz + t171;
    RESULT(checked3, closure_, 165, t172 - platform_turn_zx * base_lever_mz_by_limb3_S_fz);
    const REAL base_lever_mz_by_limb4_S_fx = param_R * (minus_limb4_U_0_cos * limb4_lower_cos),
      t175 = platform_turn_zx * base_lever_mz_by_limb4_S_fx,
      minus_base_lever_mx_by_limb4_S_fx = param_R * (limb4_U_0_sin * limb4_lower_cos);
    RESULT(checked0, closure_, 166, platform_turn_xx * minus_base_lever_mx_by_limb4_S_fx - t175);
    const REAL t176 = minus_limb4_U_0_cos * limb4_upper_offset_x, /* limb4 */
      minus_base_lever_mz_by_limb4_S_fy = t176 - param_R * (minus_limb4_U_0_cos * minus_limb4_lower_sin),
      t178 = platform_turn_zx * minus_base_lever_mz_by_limb4_S_fy,
      base_lever_mx_by_limb4_S_fy = limb4_U_0_sin * limb4_upper_offset_x - param_R * (limb4_U_0_sin * minus_limb4_lower_sin);
    RESULT(checked1, closure_, 167, t178 - platform_turn_xx * base_lever_mx_by_limb4_S_fy);
    const REAL t182 = platform_turn_yx * minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      t269 = limb5_S_v_wx * platform_turn_yx,
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      minus_base_lever_mx_by_limb4_S_fz = minus_limb4_U_0_cos * limb4_upper_position_y,
      minus_base_lever_mz_by_limb4_S_fz = limb4_U_0_sin * limb4_upper_position_y;
    /* mechanism: loop closure; velocities, eq. (6) */
    const REAL t184 = t182 + platform_turn_xx * minus_base_lever_mx_by_limb4_S_fz,
      t280 = limb5_S_v_wx * platform_turn_xx;
    RESULT(checked2, closure_, 168, t184 + platform_turn_zx * minus_base_lever_mz_by_limb4_S_fz);
    const REAL t274 = limb5_S_v_wx * platform_turn_zx, t187 = platform_turn_zy * base_lever_mz_by_limb1_U2_fx,
      t229 = platform_turn_zz * base_lever_mz_by_limb1_U2_fx;
    RESULT(checked3, closure_, 169, -(platform_turn_yy * base_lever_my_by_limb1_U2_fx + t187));
    RESULT(checked0, closure_, 182, -(platform_turn_yz * base_lever_my_by_limb1_U2_fx + t229));
    const REAL t190 = platform_turn_zy * base_lever_mz_by_limb1_U2_fy,
      t232 = platform_turn_zz * base_lever_mz_by_limb1_U2_fy;
    RESULT(checked1, closure_, 170, -(platform_turn_yy * base_lever_my_by_limb1_U2_fy + t190));
    RESULT(checked2, closure_, 183, -(platform_turn_yz * base_lever_my_by_limb1_U2_fy + t232));
    const REAL t192 = platform_turn_xy * minus_limb1_U_0_lever_mz_by_limb1_U2_fz,
      t234 = platform_turn_xz * minus_limb1_U_0_lever_mz_by_limb1_U2_fz,
      t194 = t192 - platform_turn_yy * base_lever_my_by_limb1_U2_fz,
      t236 = t234 - platform_turn_yz * base_lever_my_by_limb1_U2_fz;
    RESULT(checked3, closure_, 171, t194 + platform_turn_zy * minus_base_lever_mz_by_limb1_U2_fz);
    RESULT(checked0, closure_, 184, t236 + platform_turn_zz * minus_base_lever_mz_by_limb1_U2_fz);
    const REAL t197 = platform_turn_yy * base_lever_my_by_limb1_U2_mn,
      t239 = platform_turn_yz * base_lever_my_by_limb1_U2_mn,
      t198 = platform_turn_xy * limb1_U_0_lever_mz_by_limb1_U2_mn + t197,
      t240 = platform_turn_xz * limb1_U_0_lever_mz_by_limb1_U2_mn + t239;
    RESULT(checked1, closure_, 172, -(t198 + platform_turn_zy * base_lever_mz_by_limb1_U2_mn));
    RESULT(checked2, closure_, 185, -(t240 + platform_turn_zz * base_lever_mz_by_limb1_U2_mn));
    const REAL t201 = platform_turn_zy * minus_base_lever_mz_by_limb2_S_fx,
      t243 = platform_turn_zz * minus_base_lever_mz_by_limb2_S_fx;
    RESULT(checked3, closure_, 173, t201 - platform_turn_xy * base_lever_mx_by_limb2_S_fx);
    RESULT(checked0, closure_, 186, t243 - platform_turn_xz * base_lever_mx_by_limb2_S_fx);
    const REAL t203 = platform_turn_zy * minus_base_lever_mz_by_limb2_S_fy,
      t245 = platform_turn_zz * minus_base_lever_mz_by_limb2_S_fy;
    RESULT(checked1, closure_, 174, t203 - platform_turn_xy * base_lever_mx_by_limb2_S_fy);
    RESULT(checked2, closure_, 187, t245 - platform_turn_xz * base_lever_mx_by_limb2_S_fy);
    const REAL t206 = platform_turn_xy * base_lever_mx_by_limb2_S_fz,
      t248 = platform_turn_xz * base_lever_mx_by_limb2_S_fz,
      t207 = platform_turn_yy * minus_limb2_U_0_lever_mz_by_limb2_S_fz - t206,
      t249 = platform_turn_yz * minus_limb2_U_0_lever_mz_by_limb2_S_fz - t248;
    RESULT(checked3, closure_, 175, t207 - platform_turn_zy * base_lever_mz_by_limb2_S_fz);
    RESULT(checked0, closure_, 188, t249 - platform_turn_zz * base_lever_mz_by_limb2_S_fz);
    const REAL t210 = platform_turn_zy * minus_base_lever_mz_by_limb3_S_fx,
      t252 = platform_turn_zz * minus_base_lever_mz_by_limb3_S_fx;
    RESULT(checked1, closure_, 176, platform_turn_yy * minus_base_lever_my_by_limb3_S_fx + t210);
    RESULT(checked2, closure_, 189, platform_turn_yz * minus_base_lever_my_by_limb3_S_fx + t252);
    const REAL t254 = platform_turn_zz * base_lever_mz_by_limb3_S_fy,
      t213 = platform_turn_yy * base_lever_my_by_limb3_S_fy + platform_turn_zy * base_lever_mz_by_limb3_S_fy;
    RESULT(checked3, closure_, 177, -t213);
    RESULT(checked0, closure_, 190, -(platform_turn_yz * base_lever_my_by_limb3_S_fy + t254));
    const REAL t214 = platform_turn_xy * minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      t256 = platform_turn_xz * minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      t216 = t214 + platform_turn_yy * minus_base_lever_my_by_limb3_S_fz,
      t258 = t256 + platform_turn_yz * minus_base_lever_my_by_limb3_S_fz;
    RESULT(checked1, closure_, 178, t216 - platform_turn_zy * base_lever_mz_by_limb3_S_fz);
    RESULT(checked2, closure_, 191, t258 - platform_turn_zz * base_lever_mz_by_limb3_S_fz);
    const REAL t218 = platform_turn_xy * minus_base_lever_mx_by_limb4_S_fx,
      t260 = platform_turn_xz * minus_base_lever_mx_by_limb4_S_fx;
    RESULT(checked3, closure_, 179, t218 - platform_turn_zy * base_lever_mz_by_limb4_S_fx);
    RESULT(checked0, closure_, 192, t260 - platform_turn_zz * base_lever_mz_by_limb4_S_fx);
    const REAL t220 = platform_turn_zy * minus_base_lever_mz_by_limb4_S_fy,
      t262 = platform_turn_zz * minus_base_lever_mz_by_limb4_S_fy;
    RESULT(checked1, closure_, 180, t220 - platform_turn_xy * base_lever_mx_by_limb4_S_fy);
    RESULT(checked2, closure_, 193, t262 - platform_turn_xz * base_lever_mx_by_limb4_S_fy);
    const REAL t223 = platform_turn_xy * minus_base_lever_mx_by_limb4_S_fz,
      t265 = platform_turn_xz * minus_base_lever_mx_by_limb4_S_fz, t283 = limb5_S_v_wz * platform_turn_xz,
      t224 = platform_turn_yy * minus_limb4_U_0_lever_mz_by_limb4_S_fz + t223,
      t266 = platform_turn_yz * minus_limb4_U_0_lever_mz_by_limb4_S_fz + t265,
      platform_twist_wy = limb5_S_v_wy * platform_turn_yy + t269 + limb5_S_v_wz * platform_turn_yz;
    RESULT(checked3, closure_, 181, t224 + platform_turn_zy * minus_base_lever_mz_by_limb4_S_fz);
    RESULT(checked0, closure_, 194, t266 + platform_turn_zz * minus_base_lever_mz_by_limb4_S_fz);
    const REAL platform_twist_wz = limb5_S_v_wz * platform_turn_zz + (t274 + limb5_S_v_wy * platform_turn_zy);
    /* limb1: loop closure; reciprocal wrenches, eq. (10) */
    const REAL t278 = limb1_U_0_sin * platform_twist_wy - limb1_U_0_cos * platform_twist_wz,
      t286 = limb1_lower_cos * t278, t279 = limb1_lower_sin * t278,
      platform_twist_wx = t280 + limb5_S_v_wy * platform_turn_xy + t283,
      limb1_U2_opening_mn = t320 + limb1_lower_cos * platform_turn_xy,
      t288 = t286 - limb1_lower_sin * platform_twist_wx, minus_limb1_U2_arm_y = param_R * limb1_lower_cos,
      t289 = minus_limb1_U2_arm_y * t288, t285 = t279 + limb1_lower_cos * platform_twist_wx,
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin, t292 = t289 - limb1_U2_arm_x * t285,
      t293 = t285 * t292, t302 = t288 * t292,
      t296 = limb1_U_0_cos * platform_twist_wy + limb1_U_0_sin * platform_twist_wz, t297 = limb1_U2_arm_x * t296,
      t300 = minus_limb1_U2_arm_y * t296;
    RESULT(checked1, curvature_, 0, -(minus_limb1_upper_acc_still_x + (t293 - t296 * t297)));
    const REAL t304 = t288 * t297, t315 = limb1_lower_omega_x + t288;
    RESULT(checked2, curvature_, 1, limb1_upper_acc_still_y_2 - (t296 * t300 + t302));
    RESULT(checked3, curvature_, 2, limb1_upper_acc_still_z + (t304 + t285 * t300));
    const REAL t309 = limb1_lower_omega_y - t285, t307 = limb1_U_v_1 - t296,
      t313 = limb1_U2_constraint_mn_couple_x * (limb1_lower_alpha_still_x - (limb1_lower_omega_y * t307 - limb1_U_v_1 * t309)),
      t319 = t313 - limb1_U2_constraint_mn_couple_z * (limb1_lower_omega_x * t309 - limb1_lower_omega_y * t315),
      t325 = t315 * (limb1_U2_opening_mn * t315 + limb1_U2_constraint_mn_couple_z * t309);
    RESULT(checked0, curvature_, 3, t319 - (t325 - t307 * (limb1_U2_constraint_mn_couple_x * t309 - limb1_U2_opening_mn * t307)));
    /* limb2: loop closure; reciprocal wrenches, eq. (10) */
    const REAL t333 = limb2_U_0_sin * platform_twist_wz + minus_limb2_U_0_cos * platform_twist_wx,
      t334 = limb2_lower_sin * t333, t339 = limb2_lower_cos * t333 - limb2_lower_sin * platform_twist_wy,
      minus_limb2_S_arm_y = param_R * limb2_lower_cos, t340 = minus_limb2_S_arm_y * t339,
      t336 = t334 + limb2_lower_cos * platform_twist_wy,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin, t343 = t340 - limb2_S_arm_x * t336,
      t344 = t336 * t343, t353 = t339 * t343,
      t347 = minus_limb2_U_0_cos * platform_twist_wz - limb2_U_0_sin * platform_twist_wx, t348 = limb2_S_arm_x * t347,
      t351 = minus_limb2_S_arm_y * t347, t355 = t339 * t348;
    RESULT(checked1, curvature_, 4, -(minus_limb2_upper_acc_still_x + (t344 - t347 * t348)));
    RESULT(checked2, curvature_, 5, limb2_upper_acc_still_y_2 - (t347 * t351 + t353));
    RESULT(checked3, curvature_, 6, limb2_upper_acc_still_z - (t355 + t336 * t351));
    /* limb3: loop closure; reciprocal wrenches, eq. (10) */
    const REAL t360 = limb3_U_0_sin * platform_twist_wy - limb3_U_0_cos * platform_twist_wz,
      t361 = minus_limb3_lower_sin * t360, t366 = limb3_lower_cos * t360 + minus_limb3_lower_sin * platform_twist_wx,
      limb3_S_arm_y = param_R * limb3_lower_cos, t367 = limb3_S_arm_y * t366,
      t363 = t361 - limb3_lower_cos * platform_twist_wx,
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin, t370 = t367 - limb3_S_arm_x * t363,
      t371 = t363 * t370, t380 = t366 * t370,
      t374 = limb3_U_0_cos * platform_twist_wy + limb3_U_0_sin * platform_twist_wz, t375 = limb3_S_arm_x * t374,
      t378 = limb3_S_arm_y * t374, t382 = t366 * t375;
    RESULT(checked0, curvature_, 7, -(minus_limb3_upper_acc_still_x + (t371 - t374 * t375)));
    RESULT(checked1, curvature_, 8, t374 * t378 + t380 - minus_limb3_upper_acc_still_y);
    RESULT(checked2, curvature_, 9, t382 + t363 * t378 - minus_limb3_upper_acc_still_z_2);
    /* limb4: loop closure; reciprocal wrenches, eq. (10) */
    const REAL t399 = minus_limb4_U_0_cos * platform_twist_wz,
      t387 = limb4_U_0_sin * platform_twist_wz + minus_limb4_U_0_cos * platform_twist_wx,
      t401 = t399 - limb4_U_0_sin * platform_twist_wx, t388 = minus_limb4_lower_sin * t387,
      t393 = limb4_lower_cos * t387 + minus_limb4_lower_sin * platform_twist_wy,
      t390 = t388 - limb4_lower_cos * platform_twist_wy, limb4_S_arm_y = param_R * limb4_lower_cos,
      t394 = limb4_S_arm_y * t393, t405 = limb4_S_arm_y * t401,
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin, t397 = t394 - limb4_S_arm_x * t390,
      t402 = limb4_S_arm_x * t401, t407 = t393 * t397, t409 = t393 * t402;
    RESULT(checked3, curvature_, 10, -(minus_limb4_upper_acc_still_x + (t390 * t397 - t401 * t402)));
    RESULT(checked0, curvature_, 11, t401 * t405 + t407 - minus_limb4_upper_acc_still_y);
    RESULT(checked1, curvature_, 12, -(minus_limb4_upper_acc_still_z_2 + (t409 + t390 * t405)));
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
    NOT_BELOW(t103, 0.999999, 5);
    NOT_ABOVE(t103, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
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
    (void)three_ups_upu_s_forward_dynamics_dense(q, v, u, inertia, load, closure, curvature);
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
    if (rank < 0 || !isfinite(total)) {
        three_ups_upu_s_set_nan(a, 15);
        return isfinite(total) ? 1 : 2;
    }
    return rank == 13 ? -1 : -2;
}

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_forward_dynamics_packed_lane(const double *restrict q,
    const double *restrict v, const double *restrict u, double *restrict a, const double *restrict sine,
    const double *restrict cosine)
{
    typedef three_ups_upu_s_vector4 lanes4;
    const double limb5_S_q_qw = q[12], limb5_S_q_qx = q[13], limb5_S_q_qy = q[14], limb5_S_q_qz = q[15],
      limb1_U_v_0 = v[0], limb1_U_v_1 = v[1], limb5_S_v_wx = v[12], limb5_S_v_wy = v[13], limb5_S_v_wz =
        v[14],
      limb1_U_0_sin = sine[0], limb1_U_0_cos = cosine[0], limb1_lower_sin = sine[1], limb1_lower_cos =
        cosine[1];
    /* limb5_S: geometry; velocities, eq. (6) */
    const double t29 = limb5_S_q_qw * limb5_S_q_qw, t30 = limb5_S_q_qx * limb5_S_q_qx, t31 = t29 + t30,
      t32 = limb5_S_q_qy * limb5_S_q_qy, t33 = limb5_S_q_qz * limb5_S_q_qz, t34 = t32 + t33, t35 = t31 + t34,
      t37 = 4.0 - 2.0 * t35, t42 = t30 + t32, platform_turn_yy = 1.0 - t37 * (t30 + t33),
      platform_turn_xx = 1.0 - t34 * t37, platform_turn_zz = 1.0 - t37 * t42, t40 = limb5_S_q_qy * t37,
      t90 = limb5_S_q_qx * t40, t41 = limb5_S_q_qw * t40, t38 = limb5_S_q_qz * t37,
      t82 = limb5_S_q_qw * (limb5_S_q_qx * t37), t91 = limb5_S_q_qw * t38, platform_turn_yx = t90 + t91,
      platform_turn_xy = t90 - t91, t100 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      t80 = limb5_S_q_qy * t38, t39 = limb5_S_q_qx * t38, platform_turn_yz = t80 - t82, platform_turn_zy = t80
        + t82,
      platform_twist_wy = t100 + limb5_S_v_wz * platform_turn_yz,
      t128 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy, platform_turn_xz = t39 + t41,
      platform_turn_zx = t39 - t41, platform_twist_wx = t128 + limb5_S_v_wz * platform_turn_xz;
    const lanes4 each_limb1_U_0_sin = {limb1_U_0_sin, sine[2], sine[4], sine[6]},
      each_platform_twist_wy = {platform_twist_wy, platform_twist_wx, platform_twist_wy, platform_twist_wx};
    /* limbs together: accelerations; free motion; inertia */
    const lanes4 lanes_1 = each_limb1_U_0_sin * each_platform_twist_wy;
    const double t106 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy, /* platform */
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t106;
    const lanes4 each_limb1_U_0_cos = {limb1_U_0_cos, cosine[2], cosine[4], cosine[6]},
      lanes_3 = (lanes4){1.0, -1.0, 1.0, -1.0} * platform_twist_wz, lanes_5 = lanes_1 - each_limb1_U_0_cos *
        lanes_3,
      lanes_6 = each_limb1_U_0_sin * lanes_3, limb_U_v_0 = {limb1_U_v_0, v[3], v[6], v[9]},
      lanes_7 = limb_U_v_0 * lanes_5, limb_upper_offset_x = (lanes4){q[2], q[5], q[8], q[11]} +
        limb_upper_phase,
      signed_limb_lower_sin = {limb1_lower_sin, sine[3], sine[5], sine[7]},
      each_limb1_U2_arm_x = limb_upper_offset_x - param_R * signed_limb_lower_sin,
      lanes_9 = each_limb1_U2_arm_x * lanes_7, limb_U_v_1 = {limb1_U_v_1, v[4], v[7], v[10]},
      limb_P_v = {v[2], v[5], v[8], v[11]}, lanes_10 = limb_U_v_1 * limb_P_v, lanes_11 = lanes_9 + lanes_10,
      lanes_13 = each_limb1_U_0_cos * each_platform_twist_wy + lanes_6,
      limb_lower_cos = {limb1_lower_cos, cosine[3], cosine[5], cosine[7]}, lanes_14 = limb_U_v_1 *
        limb_lower_cos,
      lanes_19 = lanes_11 + lanes_13 * ((lanes4){param_R, param_R, -param_R, -param_R} * lanes_14 - limb_P_v),
      lanes_20 = limb_upper_offset_x * lanes_14,
      each_limb1_U_0_lever_mz_by_limb1_U2_fz = limb_lower_cos * limb_upper_offset_x,
      lanes_22 = (lanes4){1.0, -1.0, 1.0, -1.0} / each_limb1_U_0_lever_mz_by_limb1_U2_fz,
      lanes_23 = limb_lower_cos * lanes_22, lanes_24 = lanes_19 * lanes_23,
      limb_lower_composite_first_x = limb_lower_m * limb_upper_offset_x,
      lanes_25 = limb_lower_composite_first_x + (-k7), lanes_26 = limb_lower_composite_first_x + lanes_25,
      lanes_27 = limb_upper_offset_x * lanes_25, lanes_28 = lanes_10 * lanes_26,
      each_limb1_U_mass_matrix_1_by_limb1_U_1 = lanes_27 + k9, lanes_29 = lanes_27 + k8,
      lanes_30 = each_limb1_U_mass_matrix_1_by_limb1_U_1 * lanes_24, lanes_31 = limb_lower_cos * lanes_29,
      lanes_33 = (lanes4){1.0, 1.0, -1.0, -1.0} * signed_limb_lower_sin;
    /* limbs together: free motion; accelerations; rates that follow */
    const lanes4 lanes_36 = lanes_33 * lanes_31 + limb_lower_cos * (lanes_33 * lanes_29),
      each_limb1_U_mass_matrix_0_by_limb1_U_0 = limb_lower_cos * lanes_31 + k3, lanes_38 = 0.5 * lanes_36,
      minus_limb_U_0_U_still_xx = limb_U_v_0 * limb_U_v_0, lanes_40 = minus_limb_U_0_U_still_xx * lanes_38 +
        lanes_28,
      limb_U_0_acc_y = (lanes4){gravity_z, -gravity_z, gravity_z, -gravity_z} * each_limb1_U_0_cos,
      lanes_42 = lanes_40 - limb_upper_offset_x * (limb_lower_m * (lanes_33 * limb_U_0_acc_y)),
      limb_U_handed_force_1 = lanes_42 - (lanes4){1.0, -1.0, 1.0, -1.0} * lanes_30,
      limb_P_generalised_force = limb_lower_m * (limb_lower_cos * limb_U_0_acc_y) - (lanes4){u[0], u[1], u[2],
        u[3]},
      each_limb1_U_follows_1_by_limb1_U2_0 = each_limb1_U2_arm_x * lanes_23,
      lanes_45 = each_limb1_U_follows_1_by_limb1_U2_0 * limb_U_handed_force_1,
      lanes_47 = each_limb1_U_follows_1_by_limb1_U2_0 * (each_limb1_U_mass_matrix_1_by_limb1_U_1 *
        each_limb1_U_follows_1_by_limb1_U2_0),
      each_limb1_U2_arm_y = param_R * limb_lower_cos, lanes_48 = each_limb1_U2_arm_y * lanes_7,
      lanes_49 = limb_U_v_1 * lanes_33, lanes_52 = lanes_48 + lanes_13 * (param_R * lanes_49),
      lanes_53 = limb_upper_offset_x * lanes_49,
      lanes_55 = (lanes4){limb_lower_m, limb_lower_m, -limb_lower_m, -limb_lower_m} * lanes_52,
      lanes_57 = limb_lower_cos * (limb_lower_cos * lanes_26),
      lanes_63 = minus_limb_U_0_U_still_xx * (0.5 * lanes_57) + limb_U_v_1 * limb_U_v_1 * (0.5 * lanes_26),
      lanes_65 = each_limb1_U2_arm_y * (lanes_55 - (limb_P_generalised_force - lanes_63)),
      each_limb1_U2_handed_force_0 = lanes_65 - (lanes4){1.0, -1.0, -1.0, 1.0} * lanes_45,
      lanes_68 = each_limb1_U_0_sin * each_limb1_U2_handed_force_0,
      lanes_69 = each_limb1_U_0_cos * each_limb1_U2_handed_force_0;
    const double platform_rate_mx = k12 * (limb5_S_v_wy * limb5_S_v_wz) - gravity_z_platform_mz *
        platform_turn_zy,
      t430 = platform_turn_zx * platform_rate_mx, /* platform */
      minus_platform_rate_my = k12 * (limb5_S_v_wx * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zx,
      t464 = lanes_68[1] + (t430 - platform_turn_zy * minus_platform_rate_my - (-lanes_68[2])), /* limb5_S */
      t466 = -lanes_68[0] - (lanes_68[3] - t464); /* limb5_S */
    const lanes4 lanes_70 = limb_U_v_0 * lanes_13;
    const double t133 = limb1_U_v_1 - lanes_13[0]; /* limb1 */
    const lanes4 each_limb1_upper_position_x = lanes_33 * limb_upper_offset_x + (lanes4){-param_R, -param_R,
        param_R, param_R},
      lanes_72 = each_limb1_upper_position_x * lanes_70, lanes_74 = limb_P_v * limb_lower_cos - lanes_53,
      lanes_75 = (lanes4){platform_twist_wx, platform_twist_wy, platform_twist_wx, platform_twist_wy} *
        lanes_74,
      lanes_80 = limb_U_v_0 * lanes_74 - lanes_72 - lanes_5 * (limb_P_v * lanes_33 + lanes_20),
      lanes_81 = lanes_80 - lanes_75, lanes_82 = lanes_22 * lanes_81,
      lanes_83 = each_limb1_U_mass_matrix_0_by_limb1_U_0 * lanes_82,
      lanes_88 = lanes_36 * (limb_U_v_0 * limb_U_v_1) - lanes_57 * (limb_U_v_0 * limb_P_v),
      signed_limb_U_0_moment_z = limb_lower_cos * (limb_upper_offset_x * (limb_lower_m_gravity_z *
        each_limb1_U_0_sin)),
      signed_limb_U_handed_force_0 = signed_limb_U_0_moment_z + (lanes4){1.0, -1.0, 1.0, -1.0} * lanes_88 +
        lanes_83,
      each_limb1_U_follows_0_by_limb1_U2_1 = each_limb1_upper_position_x * lanes_22,
      each_limb1_U2_handed_force_1 = each_limb1_U_follows_0_by_limb1_U2_1 * signed_limb_U_handed_force_0,
      lanes_92 = each_limb1_U_0_cos * each_limb1_U2_handed_force_1;
    const double t469 = -lanes_92[3] - (lanes_92[1] - (lanes_92[2] + t466)), /* limb5_S */
      t470 = -lanes_92[0] - t469; /* limb5_S */
    const lanes4 lanes_93 = each_limb1_U_0_sin * each_limb1_U2_handed_force_1;
    const double t119 = lanes_5[0]; /* limb5_S */
    /* limb1: loop closure; reciprocal wrenches, eq. (10); rates that follow */
    const double t137 = limb1_lower_sin * t119 + limb1_lower_cos * platform_twist_wx,
      t146 = limb1_lower_cos * t119 - limb1_lower_sin * platform_twist_wx,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, t138 = limb1_lower_omega_y - t137,
      t141 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t133 - limb1_U_v_1 * t138),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t142 = limb1_U2_constraint_mn_couple_x * t141, limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin,
      t147 = limb1_lower_omega_x + t146, t149 = limb1_lower_omega_x * t138 - limb1_lower_omega_y * t147,
      t88 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t152 = limb1_lower_sin * t88,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t88 - limb1_lower_sin * platform_turn_xy,
      t151 = t142 - limb1_U2_constraint_mn_couple_z * t149,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * lanes_23[0],
      t171 = lanes_19[0] * limb1_U_factor_1_by_3, /* limb5_S */
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - each_limb1_U2_arm_x[0] *
        limb1_U_factor_1_by_3,
      t155 = limb1_U2_constraint_mn_couple_z * t138, t158 = limb1_U2_constraint_mn_couple_x * t138,
      limb1_U2_opening_mn = t152 + limb1_lower_cos * platform_turn_xy,
      t157 = t147 * (limb1_U2_opening_mn * t147 + t155),
      t172 = t151 - (t157 - t133 * (t158 - limb1_U2_opening_mn * t133)) - t171, /* limb5_S */
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * lanes_22[0],
      t173 = minus_limb1_U_factor_0_by_3 * lanes_81[0] - t172, /* limb5_S */
      t84 = (-each_limb1_upper_position_x[0]) * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t84,
      t368 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin *
        minus_limb1_U2_factor_0_by_3,
      t97 = 1.0 / minus_limb5_S_pivot_wz, /* limb5_S */
      minus_limb5_S_joint_acc_still_wz = t97 * t173,
      limb5_S_null_space_wz_by_limb5_S_wy = t97 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t368);
    /* limbs together: free motion */
    const lanes4 lanes_94 = each_limb1_U_follows_0_by_limb1_U2_1 * each_limb1_U_mass_matrix_0_by_limb1_U_0,
      lanes_95 = each_limb1_U_follows_0_by_limb1_U2_1 * lanes_94,
      lanes_98 = each_limb1_U2_arm_y * (k20 * limb_lower_cos) + lanes_47,
      lanes_100 = each_limb1_U_0_cos * (lanes_95 - lanes_98), lanes_101 = each_limb1_U_0_cos * lanes_100,
      lanes_102 = lanes_98 + lanes_101, lanes_103 = lanes_95 - lanes_101, lanes_104 = each_limb1_U_0_sin *
        lanes_100;
    /* limb5_S: free motion; accelerations */
    const double t44 = k12 * platform_turn_zz, t399 = lanes_102[1] + (k13 + platform_turn_zz * t44 +
        lanes_102[2]),
      limb5_S_handed_inertia_wz = lanes_102[0] + (lanes_102[3] + t399), t45 = platform_turn_xz * t44,
      t471 = limb5_S_null_space_wz_by_limb5_S_wy * (limb5_S_handed_inertia_wz *
        minus_limb5_S_joint_acc_still_wz + t470),
      t515 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz,
      t327 = platform_turn_xx * platform_rate_mx,
      t490 = platform_turn_yx * platform_rate_mx - platform_turn_yy * minus_platform_rate_my - (-lanes_69[2]),
      t493 = signed_limb_U_handed_force_0[1] - (lanes_93[2] - (-lanes_69[0] + t490)),
      t495 = -lanes_93[0] + (signed_limb_U_handed_force_0[3] + t493),
      t362 = lanes_69[3] + (t327 - platform_turn_xy * minus_platform_rate_my - lanes_69[1]),
      t365 = -lanes_93[3] - (lanes_93[1] + (signed_limb_U_handed_force_0[2] - t362)),
      t366 = signed_limb_U_handed_force_0[0] - t365, t475 = k12 * platform_turn_yz,
      t478 = platform_turn_zz * t475 - lanes_104[2];
    const lanes4 lanes_105 = each_limb1_U_0_cos * lanes_94;
    const double t481 = lanes_104[0] - (-lanes_105[3] - (lanes_105[1] - t478)), t517 = t481 + (t481 - t515),
      limb5_S_reduced_force_wy = t471 - (t481 * minus_limb5_S_joint_acc_still_wz + t495),
      t518 = limb5_S_null_space_wz_by_limb5_S_wy * t517, t76 = lanes_104[3] + (t45 - lanes_105[2] +
        lanes_104[1]),
      limb5_S_handed_inertia_wz_by_limb5_S_wx = -lanes_105[0] + t76;
    const lanes4 lanes_106 = each_limb1_U_0_sin * lanes_94;
    const double t512 = each_limb1_U_mass_matrix_0_by_limb1_U_0[1] + (k13 + platform_turn_yz * t475 +
        lanes_103[2]),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = lanes_103[0] + (each_limb1_U_mass_matrix_0_by_limb1_U_0[3] +
        t512) - t518,
      t519 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t501 = platform_turn_xz * t475 + lanes_106[2] - lanes_106[1], t505 = t501 + (-lanes_106[3]) -
        (-lanes_106[0]),
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t505 + limb5_S_null_space_wz_by_limb5_S_wy *
        limb5_S_handed_inertia_wz_by_limb5_S_wx,
      limb5_S_reduced_force_wx = limb5_S_handed_inertia_wz_by_limb5_S_wx * minus_limb5_S_joint_acc_still_wz +
        t366;
    /* limb5_S: accelerations; pivots; free motion */
    const double t520 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t519,
      t531 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t520, t533 = limb5_S_reduced_force_wy * t519,
      t522 = limb5_S_reduced_force_wx - limb5_S_reduced_force_wy * t520,
      t527 = each_limb1_U_mass_matrix_0_by_limb1_U_0[2] + (k13 + platform_turn_xz * (k12 * platform_turn_xz)),
      limb5_S_reduced_inertia_wx_by_limb5_S_wx = each_limb1_U_mass_matrix_0_by_limb1_U_0[0] + (lanes_103[3] +
        (t527 + lanes_103[1])),
      pivot_1 = limb5_S_reduced_inertia_wx_by_limb5_S_wx - t531, limb5_S_joint_acc_wx = t522 / pivot_1,
      minus_limb5_S_joint_acc_wy = t520 * limb5_S_joint_acc_wx - t533,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy *
        minus_limb5_S_joint_acc_wy,
      t575 = platform_turn_zx * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_x = t575 + (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx *
        limb5_S_joint_acc_wx);
    a[12] = -minus_platform_alpha_x;
    const double t579 = platform_turn_zy * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_y = t579 + (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy *
        limb5_S_joint_acc_wx);
    a[13] = -minus_platform_alpha_y;
    const double t583 = platform_turn_zz * minus_limb5_S_joint_acc_wz,
      minus_platform_alpha_z = t583 + (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz *
        limb5_S_joint_acc_wx);
    a[14] = -minus_platform_alpha_z;
    const lanes4 lanes_107 = each_limb1_U_0_cos * minus_limb5_S_joint_acc_wz,
      lanes_108 = each_limb1_U_0_sin * minus_limb5_S_joint_acc_wz,
      each_limb5_S_joint_acc_wy = {minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx,
        minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx},
      lanes_111 = each_limb1_U_follows_0_by_limb1_U2_1 * (lanes_107 - each_limb1_U_0_sin *
        each_limb5_S_joint_acc_wy),
      lanes_114 = lanes_111 - (lanes4){1.0, -1.0, 1.0, -1.0} * lanes_82,
      each_limb5_S_joint_acc_wx = {limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_wy, limb5_S_joint_acc_wx,
        minus_limb5_S_joint_acc_wy},
      limb_U_joint_acc_0 = (lanes4){1.0, -1.0, 1.0, -1.0} * each_limb5_S_joint_acc_wx + lanes_114;
    a[0] = limb_U_joint_acc_0[0];
    a[3] = limb_U_joint_acc_0[1];
    a[6] = limb_U_joint_acc_0[2];
    a[9] = -(-limb_U_joint_acc_0[3]);
    const lanes4 lanes_120 = (lanes4){1.0, -1.0, 1.0, -1.0} * (lanes_108 + each_limb1_U_0_cos *
        each_limb5_S_joint_acc_wy),
      signed_limb_U_joint_acc_1 = lanes_24 + each_limb1_U_follows_1_by_limb1_U2_0 * lanes_120;
    a[1] = -signed_limb_U_joint_acc_1[0];
    a[4] = signed_limb_U_joint_acc_1[1];
    a[7] = -signed_limb_U_joint_acc_1[2];
    a[10] = signed_limb_U_joint_acc_1[3];
    const lanes4 signed_limb_P_joint_acc = lanes_52 + each_limb1_U2_arm_y * lanes_120;
    a[2] = -signed_limb_P_joint_acc[0];
    a[5] = -signed_limb_P_joint_acc[1];
    a[8] = signed_limb_P_joint_acc[2];
    a[11] = signed_limb_P_joint_acc[3];
    const lanes4 every = (lanes4)((three_ups_upu_s_vector4_mask)((each_limb1_U_0_lever_mz_by_limb1_U2_fz +
        limb_U_joint_acc_0) + (signed_limb_U_joint_acc_1 + signed_limb_P_joint_acc)) |
        ((each_limb1_U_0_lever_mz_by_limb1_U2_fz <= (lanes4){6.62327e-06, 6.62327e-06, 6.62327e-06,
        6.62327e-06}) & (each_limb1_U_0_lever_mz_by_limb1_U2_fz >= -(lanes4){6.62327e-06, 6.62327e-06,
        6.62327e-06, 6.62327e-06})));
    return fabs(minus_limb5_S_pivot_wz) <= 1.0e-05 || fabs(limb5_S_reduced_inertia_wy_by_limb5_S_wy) <=
        0.0007562600000000001 || fabs(pivot_1) <= 0.0007551200000000001 || !(t35 >= 0.999999 && t35 <=
        1.000001) ? (double)NAN : (((minus_limb5_S_pivot_wz + limb5_S_reduced_inertia_wy_by_limb5_S_wy) +
        (pivot_1 + minus_platform_alpha_x)) + ((minus_platform_alpha_y + minus_platform_alpha_z) + (every[0] +
        every[1]))) + (every[2] + every[3]);
}
#endif

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
    if (isfinite(three_ups_upu_s_forward_dynamics_packed_lane(q, v, u, a, sine, cosine))) {
        return 0;
    }
#endif
    return three_ups_upu_s_forward_dynamics_limb_by_limb(q, v, u, a);
}

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_forward_dynamics_independent_packed_lane(const double *restrict q,
    const double *restrict y_dot, const double *restrict u, double *restrict y_ddot,
    const double *restrict sine, const double *restrict cosine)
{
    typedef three_ups_upu_s_vector4 lanes4;
    const double limb5_S_q_qw = q[12], limb5_S_q_qx = q[13], limb5_S_q_qy = q[14], limb5_S_q_qz = q[15],
      limb5_S_y_dot_qy = y_dot[1], limb1_U_0_sin = sine[0], limb1_U_0_cos = cosine[0], limb1_lower_sin =
        sine[1],
      limb1_lower_cos = cosine[1];
    /* limb5_S: geometry; velocities, eq. (6) */
    const double t2 = limb5_S_q_qw * limb5_S_q_qw, t3 = limb5_S_q_qx * limb5_S_q_qx, t4 = t2 + t3,
      t5 = limb5_S_q_qy * limb5_S_q_qy, t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7, t11 = t3
        + t6,
      t82 = t3 + t5, t10 = 4.0 - 2.0 * t8, platform_turn_yy = 1.0 - t10 * t11, t39 = k2 - 0.5 * t8,
      platform_turn_xx = 1.0 - t7 * t10, platform_turn_zz = 1.0 - t10 * t82, t14 = limb5_S_q_qz * t10,
      t15 = limb5_S_q_qy * t14, t17 = limb5_S_q_qw * (limb5_S_q_qx * t10), t26 = limb5_S_q_qy * t10,
      platform_turn_zy = t15 + t17, platform_turn_yz = t15 - t17,
      t24 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      t25 = limb1_lower_cos * t24, /* limb1 */
      t155 = limb1_lower_sin * t24, /* limb1 */
      t27 = limb5_S_q_qx * t26, t92 = limb5_S_q_qw * t26, t28 = limb5_S_q_qw * t14, t91 = limb5_S_q_qx * t14,
      platform_turn_xy = t27 - t28, platform_turn_yx = t27 + t28,
      limb1_U2_constraint_mn_couple_z = t25 - limb1_lower_sin * platform_turn_xy;
    const lanes4 limb_upper_offset_x = (lanes4){q[2], q[5], q[8], q[11]} + limb_upper_phase,
      limb_lower_cos = {limb1_lower_cos, cosine[3], cosine[5], cosine[7]},
      each_limb1_U_0_lever_mz_by_limb1_U2_fz = limb_lower_cos * limb_upper_offset_x,
      lanes_1 = 1.0 / each_limb1_U_0_lever_mz_by_limb1_U2_fz, lanes_2 = limb_lower_cos * lanes_1;
    /* limb1: rates that follow; pivots; reciprocal wrenches, eq. (10) */
    const double limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * lanes_2[0];
    const lanes4 signed_limb_lower_sin = {limb1_lower_sin, sine[3], sine[5], sine[7]},
      each_limb1_U2_arm_x = limb_upper_offset_x - param_R * signed_limb_lower_sin;
    const double minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - each_limb1_U2_arm_x[0] *
        limb1_U_factor_1_by_3,
      t33 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t36 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * lanes_1[0];
    const lanes4 each_limb1_upper_position_x = signed_limb_lower_sin * limb_upper_offset_x + (-param_R);
    const double t20 = (-each_limb1_upper_position_x[0]) * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t20;
    /* limb5_S: pivots; rates that follow */
    const double minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t33,
      t34 = 1.0 / minus_limb5_S_pivot_wz, t37 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t36, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t34 * t37;
    /* platform: velocities, eq. (6); accelerations; geometry */
    const double t41 = limb5_S_q_qx * t39, t42 = t41 * limb5_S_null_space_wz_by_limb5_S_wy, t40 = limb5_S_q_qw
        * t39,
      a_pivot = 0.5 * (t40 + t42), t44 = 1.0 / a_pivot, t47 = limb5_S_q_qy * t39, t45 = limb5_S_q_qz * t39,
      t51 = t44 * (0.5 * (t45 - t47 * limb5_S_null_space_wz_by_limb5_S_wy)), t53 = y_dot[0] - limb5_S_y_dot_qy
        * t51,
      t46 = 0.5 * t45, a_pivot_2 = 0.5 * t40 + t46 * t51, limb5_S_joint_rate_wx = t53 / a_pivot_2,
      limb5_S_joint_rate_wy = t44 * (limb5_S_y_dot_qy + t46 * limb5_S_joint_rate_wx),
      limb5_S_joint_rate_wz = t34 * (t37 * limb5_S_joint_rate_wy), t98 = platform_turn_zy *
        limb5_S_joint_rate_wz,
      platform_omega_y = t98 + (platform_turn_yy * limb5_S_joint_rate_wy + platform_turn_xy *
        limb5_S_joint_rate_wx),
      t117 = platform_turn_zy * platform_omega_y, platform_turn_zx = t91 - t92, platform_turn_xz = t91 + t92,
      t104 = platform_turn_zx * limb5_S_joint_rate_wz,
      platform_omega_x = t104 + (platform_turn_yx * limb5_S_joint_rate_wy + platform_turn_xx *
        limb5_S_joint_rate_wx),
      t119 = t117 + platform_turn_zx * platform_omega_x, t93 = platform_turn_zz * limb5_S_joint_rate_wz,
      platform_omega_z = t93 + (platform_turn_yz * limb5_S_joint_rate_wy + platform_turn_xz *
        limb5_S_joint_rate_wx),
      t120 = platform_turn_zz * platform_omega_z + t119;
    const lanes4 each_limb1_U_0_cos = {limb1_U_0_cos, cosine[2], cosine[4], cosine[6]},
      lanes_4 = each_limb1_U_0_cos * t120, each_limb1_U_0_sin = {limb1_U_0_sin, sine[2], sine[4], sine[6]},
      lanes_6 = (lanes4){1.0, -1.0, 1.0, -1.0} * each_limb1_U_0_sin, lanes_7 = lanes_6 * t120;
    const double t125 = platform_turn_yy * platform_omega_y + platform_turn_yx * platform_omega_x,
      t126 = platform_turn_yz * platform_omega_z + t125, t521 = k12 * (platform_omega_z * platform_omega_y),
      t109 = platform_turn_xy * platform_omega_y + platform_turn_xx * platform_omega_x,
      platform_U_still_xz = platform_omega_z * platform_omega_x, t110 = platform_turn_xz * platform_omega_z +
        t109,
      t519 = k12 * platform_U_still_xz;
    const lanes4 lanes_8 = {t126, t110, t126, t110};
    /* limbs together: accelerations; velocities, eq. (6); free motion */
    const lanes4 lanes_10 = lanes_4 - lanes_6 * lanes_8, lanes_11 = each_limb1_U_0_cos *
        limb5_S_joint_rate_wz,
      each_limb5_S_joint_rate_wy = {limb5_S_joint_rate_wy, limb5_S_joint_rate_wx, limb5_S_joint_rate_wy,
        limb5_S_joint_rate_wx},
      lanes_15 = lanes_1 * (each_limb1_upper_position_x * (lanes_6 * each_limb5_S_joint_rate_wy - lanes_11)),
      each_limb5_S_joint_rate_wx = {limb5_S_joint_rate_wx, limb5_S_joint_rate_wy, limb5_S_joint_rate_wx,
        limb5_S_joint_rate_wy},
      signed_limb_U_joint_rate_0 = (lanes4){1.0, -1.0, -1.0, 1.0} * each_limb5_S_joint_rate_wx + lanes_15,
      lanes_18 = lanes_10 * signed_limb_U_joint_rate_0, lanes_19 = each_limb1_U2_arm_x * lanes_18,
      lanes_22 = lanes_6 * limb5_S_joint_rate_wz + each_limb1_U_0_cos * each_limb5_S_joint_rate_wy,
      limb_U_joint_rate_1 = lanes_2 * (each_limb1_U2_arm_x * lanes_22),
      each_limb1_U_follows_1_by_limb1_U2_0 = each_limb1_U2_arm_x * lanes_2,
      each_limb1_U2_arm_y = param_R * limb_lower_cos, signed_limb_P_joint_rate = each_limb1_U2_arm_y *
        lanes_22,
      lanes_23 = each_limb1_U2_arm_y * lanes_18, lanes_24 = signed_limb_P_joint_rate * limb_U_joint_rate_1,
      lanes_25 = lanes_19 - lanes_24, lanes_27 = lanes_7 + each_limb1_U_0_cos * lanes_8,
      lanes_28 = limb_lower_cos * limb_U_joint_rate_1,
      lanes_32 = lanes_25 - lanes_27 * (param_R * lanes_28 - signed_limb_P_joint_rate), lanes_33 = lanes_2 *
        lanes_32;
    const double t153 = limb1_U_factor_1_by_3 * lanes_32[0]; /* limb5_S */
    const lanes4 lanes_34 = limb_upper_offset_x * lanes_28,
      limb_lower_composite_first_x = limb_lower_m * limb_upper_offset_x,
      lanes_35 = limb_lower_composite_first_x + (-k7), lanes_36 = limb_lower_composite_first_x + lanes_35,
      lanes_37 = limb_upper_offset_x * lanes_35, lanes_38 = lanes_36 * lanes_24,
      each_limb1_U_mass_matrix_1_by_limb1_U_1 = lanes_37 + k9,
      lanes_39 = each_limb1_U_mass_matrix_1_by_limb1_U_1 * lanes_33, lanes_40 = lanes_37 + k8,
      lanes_42 = each_limb1_U_follows_1_by_limb1_U2_0 * (each_limb1_U_mass_matrix_1_by_limb1_U_1 *
        each_limb1_U_follows_1_by_limb1_U2_0),
      minus_limb_U_0_U_still_xx = signed_limb_U_joint_rate_0 * signed_limb_U_joint_rate_0,
      lanes_43 = limb_lower_cos * lanes_40;
    /* limbs together: free motion; inertia; accelerations */
    const lanes4 lanes_46 = signed_limb_lower_sin * lanes_43 + limb_lower_cos * (signed_limb_lower_sin *
        lanes_40),
      each_limb1_U_mass_matrix_0_by_limb1_U_0 = limb_lower_cos * lanes_43 + k3,
      lanes_50 = lanes_38 - (-0.5) * lanes_46 * minus_limb_U_0_U_still_xx,
      limb_U_0_acc_y = (lanes4){gravity_z, -gravity_z, gravity_z, -gravity_z} * each_limb1_U_0_cos,
      signed_limb_U_handed_force_1 = lanes_39 - (limb_upper_offset_x * (limb_lower_m * (signed_limb_lower_sin
        * limb_U_0_acc_y)) - lanes_50),
      lanes_53 = each_limb1_U_follows_1_by_limb1_U2_0 * signed_limb_U_handed_force_1,
      limb_P_generalised_force = limb_lower_m * (limb_lower_cos * limb_U_0_acc_y) - (lanes4){u[0], u[1], u[2],
        u[3]},
      lanes_54 = signed_limb_lower_sin * limb_U_joint_rate_1,
      lanes_58 = limb_lower_m * (lanes_27 * (param_R * lanes_54) - lanes_23),
      lanes_59 = limb_upper_offset_x * lanes_54, lanes_61 = limb_lower_cos * (limb_lower_cos * lanes_36),
      lanes_64 = 0.5 * lanes_61 * minus_limb_U_0_U_still_xx,
      lanes_68 = limb_P_generalised_force - (0.5 * lanes_36 * (limb_U_joint_rate_1 * limb_U_joint_rate_1) +
        lanes_64),
      each_limb1_U2_handed_force_0 = lanes_53 - each_limb1_U2_arm_y * (lanes_58 - lanes_68),
      lanes_70 = lanes_6 * each_limb1_U2_handed_force_0, lanes_71 = each_limb1_U_0_cos *
        each_limb1_U2_handed_force_0;
    const double platform_rate_my = gravity_z_platform_mz * platform_turn_zx - t519,
      t589 = platform_turn_zy * platform_rate_my, /* platform */
      minus_platform_rate_mx = gravity_z_platform_mz * platform_turn_zy - t521,
      t593 = lanes_70[1] - (lanes_70[2] - (t589 - platform_turn_zx * minus_platform_rate_mx)), /* limb5_S */
      t595 = lanes_70[0] - (lanes_70[3] - t593); /* limb5_S */
    const lanes4 lanes_73 = each_limb1_upper_position_x * (signed_limb_U_joint_rate_0 * lanes_27),
      each_limb1_U_follows_0_by_limb1_U2_1 = each_limb1_upper_position_x * lanes_1;
    const double limb1_U_joint_rate_1 = limb_U_joint_rate_1[0],
      t154 = limb1_U_joint_rate_1 - lanes_27[0]; /* limb1 */
    const lanes4 lanes_75 = lanes_59 - limb_lower_cos * signed_limb_P_joint_rate,
      lanes_77 = lanes_75 * (lanes4){t110, t126, t110, t126},
      lanes_79 = lanes_75 * signed_limb_U_joint_rate_0 + lanes_73,
      lanes_83 = lanes_79 - (signed_limb_lower_sin * signed_limb_P_joint_rate + lanes_34) * lanes_10,
      lanes_86 = lanes_83 - (lanes4){1.0, -1.0, -1.0, 1.0} * lanes_77;
    const double t144 = minus_limb1_U_factor_0_by_3 * lanes_86[0]; /* limb5_S */
    const lanes4 lanes_88 = each_limb1_U_mass_matrix_0_by_limb1_U_0 * (lanes_1 * lanes_86),
      lanes_90 = lanes_61 * (signed_limb_P_joint_rate * signed_limb_U_joint_rate_0),
      lanes_93 = lanes_90 - lanes_46 * (limb_U_joint_rate_1 * signed_limb_U_joint_rate_0),
      lanes_94 = limb_lower_cos * (limb_upper_offset_x * (limb_lower_m_gravity_z * each_limb1_U_0_sin)) -
        lanes_93,
      signed_limb_U_handed_force_0 = lanes_88 - lanes_94,
      each_limb1_U2_handed_force_1 = each_limb1_U_follows_0_by_limb1_U2_1 * signed_limb_U_handed_force_0,
      lanes_95 = each_limb1_U_0_cos * each_limb1_U2_handed_force_1;
    const double t598 = lanes_95[3] + (-lanes_95[1] + (lanes_95[2] + t595)), /* limb5_S */
      t599 = -lanes_95[0] + t598; /* limb5_S */
    const lanes4 lanes_96 = lanes_6 * each_limb1_U2_handed_force_1;
    const double t128 = lanes_10[0]; /* limb5_S */
    /* limb1: loop closure; velocities, eq. (6); accelerations */
    const double t160 = limb1_lower_cos * t110 - limb1_lower_sin * t128,
      t167 = limb1_lower_sin * t110 + limb1_lower_cos * t128, limb1_U_joint_rate_0 =
        signed_limb_U_joint_rate_0[0],
      limb1_lower_omega_y = limb1_lower_cos * limb1_U_joint_rate_0, t161 = t160 - limb1_lower_omega_y,
      limb1_lower_omega_x = limb1_lower_sin * limb1_U_joint_rate_0, t168 = t167 - limb1_lower_omega_x,
      t175 = t161 * limb1_lower_omega_x, limb1_lower_alpha_still_x = limb1_U_joint_rate_1 *
        limb1_lower_omega_y,
      t182 = limb1_U2_constraint_mn_couple_x * (limb1_U_joint_rate_1 * t161 + t154 * limb1_lower_omega_y -
        limb1_lower_alpha_still_x),
      t183 = limb1_U2_constraint_mn_couple_z * (limb1_lower_omega_y * t168 - t175) + t182,
      t162 = limb1_U2_constraint_mn_couple_x * t161, t169 = limb1_U2_constraint_mn_couple_z * t161,
      limb1_U2_opening_mn = t155 + limb1_lower_cos * platform_turn_xy,
      t164 = t154 * (limb1_U2_opening_mn * t154 + t162),
      t184 = t153 - (t164 + t168 * (t169 + limb1_U2_opening_mn * t168) + t183), /* limb5_S */
      limb5_S_joint_acc_still_wz = t34 * (t144 + t184);
    /* limbs together: free motion */
    const lanes4 lanes_97 = each_limb1_U_follows_0_by_limb1_U2_1 * each_limb1_U_mass_matrix_0_by_limb1_U_0,
      lanes_98 = each_limb1_U_follows_0_by_limb1_U2_1 * lanes_97,
      lanes_101 = each_limb1_U2_arm_y * (k20 * limb_lower_cos) + lanes_42,
      lanes_103 = each_limb1_U_0_cos * (lanes_98 - lanes_101), lanes_104 = each_limb1_U_0_cos * lanes_103,
      lanes_105 = lanes_101 + lanes_104, lanes_106 = lanes_98 - lanes_104, lanes_107 = lanes_6 * lanes_103;
    /* limb5_S: free motion; accelerations; pivots */
    const double t238 = k12 * platform_turn_zz, t302 = lanes_105[1] + (k13 + platform_turn_zz * t238 +
        lanes_105[2]),
      limb5_S_handed_inertia_wz = lanes_105[0] + (lanes_105[3] + t302), t239 = platform_turn_xz * t238,
      t600 = limb5_S_null_space_wz_by_limb5_S_wy * (limb5_S_handed_inertia_wz * limb5_S_joint_acc_still_wz +
        t599),
      t304 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz,
      t520 = platform_turn_xy * platform_rate_my,
      t609 = lanes_71[2] - (platform_turn_yy * platform_rate_my - platform_turn_yx * minus_platform_rate_mx),
      t612 = signed_limb_U_handed_force_0[1] + (lanes_96[2] - (lanes_71[0] - t609)),
      t614 = -lanes_96[0] - (-signed_limb_U_handed_force_0[3] - t612),
      t525 = -lanes_71[3] - (-lanes_71[1] - (t520 - platform_turn_xx * minus_platform_rate_mx)),
      t528 = -lanes_96[3] + (lanes_96[1] - (-signed_limb_U_handed_force_0[2] - t525)),
      t529 = signed_limb_U_handed_force_0[0] + t528, t186 = k12 * platform_turn_yz,
      t289 = platform_turn_zz * t186 - lanes_107[2];
    const lanes4 lanes_108 = each_limb1_U_0_cos * lanes_97;
    const double t292 = lanes_107[0] - (-lanes_108[3] - (-lanes_108[1] - t289)), t306 = t292 + (t292 - t304),
      minus_limb5_S_reduced_force_wy = t600 - (t292 * limb5_S_joint_acc_still_wz + t614),
      t307 = limb5_S_null_space_wz_by_limb5_S_wy * t306,
      t254 = -lanes_107[3] + (t239 - (-lanes_108[2]) + (-lanes_107[1])),
      limb5_S_handed_inertia_wz_by_limb5_S_wx = -lanes_108[0] + t254;
    const lanes4 lanes_109 = lanes_6 * lanes_97;
    const double t281 = each_limb1_U_mass_matrix_0_by_limb1_U_0[1] + (k13 + platform_turn_yz * t186 +
        lanes_106[2]),
      limb5_S_reduced_inertia_wy_by_limb5_S_wy = lanes_106[0] + (each_limb1_U_mass_matrix_0_by_limb1_U_0[3] +
        t281) - t307,
      t308 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy,
      t207 = platform_turn_xz * t186 + (-lanes_109[2]) - lanes_109[1], t225 = t207 + lanes_109[3] -
        (-lanes_109[0]),
      limb5_S_reduced_inertia_wx_by_limb5_S_wy = t225 + limb5_S_null_space_wz_by_limb5_S_wy *
        limb5_S_handed_inertia_wz_by_limb5_S_wx,
      minus_limb5_S_reduced_force_wx = limb5_S_handed_inertia_wz_by_limb5_S_wx * limb5_S_joint_acc_still_wz +
        t529,
      t309 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t308, t626 = limb5_S_reduced_inertia_wx_by_limb5_S_wy
        * t309,
      t628 = minus_limb5_S_reduced_force_wy * t308,
      t617 = minus_limb5_S_reduced_force_wx - minus_limb5_S_reduced_force_wy * t309,
      t622 = each_limb1_U_mass_matrix_0_by_limb1_U_0[2] + (k13 + platform_turn_xz * (k12 * platform_turn_xz)),
      limb5_S_reduced_inertia_wx_by_limb5_S_wx = each_limb1_U_mass_matrix_0_by_limb1_U_0[0] + (lanes_106[3] +
        (t622 + lanes_106[1])),
      pivot_1 = limb5_S_reduced_inertia_wx_by_limb5_S_wx - t626, minus_limb5_S_joint_acc_wx = t617 / pivot_1,
      limb5_S_joint_acc_wy = t309 * minus_limb5_S_joint_acc_wx - t628,
      limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy *
        limb5_S_joint_acc_wy;
    /* limb5_S: results */
    const double t636 = platform_turn_zy * limb5_S_joint_acc_wz,
      t640 = t636 + (platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx),
      t659 = platform_turn_xy * t640, t641 = platform_turn_zy * t640, t652 = platform_turn_yy * t640,
      t642 = platform_turn_zx * limb5_S_joint_acc_wz, t630 = platform_turn_zz * limb5_S_joint_acc_wz,
      t631 = platform_turn_yz * limb5_S_joint_acc_wy,
      t646 = t642 + (platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx),
      t661 = t659 + platform_turn_xx * t646, t634 = t630 + (t631 - platform_turn_xz *
        minus_limb5_S_joint_acc_wx),
      t662 = platform_turn_xz * t634 + t661, t654 = t652 + platform_turn_yx * t646,
      t649 = platform_turn_zz * t634 + (t641 + platform_turn_zx * t646), t655 = platform_turn_yz * t634 +
        t654,
      t681 = t45 * t662 - t41 * t649 - t40 * t655, t664 = t47 * t649 - t45 * t655 - t40 * t662,
      t672 = 0.5 * (t47 * limb5_S_joint_rate_wz - t45 * limb5_S_joint_rate_wy - t40 * limb5_S_joint_rate_wx),
      t673 = limb5_S_joint_rate_wz * t672, t62 = t40 * limb5_S_joint_rate_wy,
      t71 = 0.5 * (t41 * limb5_S_joint_rate_wy - t47 * limb5_S_joint_rate_wx - t40 * limb5_S_joint_rate_wz),
      t674 = limb5_S_joint_rate_wx * t71 - t673, t72 = limb5_S_joint_rate_wy * t71, t59 = t45 *
        limb5_S_joint_rate_wx,
      t79 = 0.5 * (t45 * limb5_S_joint_rate_wz + (t47 * limb5_S_joint_rate_wy + t41 * limb5_S_joint_rate_wx)),
      limb5_S_y_ddot_qy = 0.5 * (t674 - limb5_S_joint_rate_wy * t79 - t681);
    y_ddot[1] = limb5_S_y_ddot_qy;
    const double t80 = limb5_S_joint_rate_wx * t79,
      t73 = limb5_S_joint_rate_wz * (0.5 * (t59 - t41 * limb5_S_joint_rate_wz - t62)) - t72,
      limb5_S_y_ddot_qx = 0.5 * (t73 - t80 - t664);
    y_ddot[0] = limb5_S_y_ddot_qx;
    const lanes4 every = (lanes4)((three_ups_upu_s_vector4_mask)(each_limb1_U_0_lever_mz_by_limb1_U2_fz) |
        ((each_limb1_U_0_lever_mz_by_limb1_U2_fz <= (lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10,
        6.62327e-10}) & (each_limb1_U_0_lever_mz_by_limb1_U2_fz >= -(lanes4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10})));
    return fabs(minus_limb5_S_pivot_wz) <= 1.0e-09 || fabs(a_pivot) <= 1.0e-09 || fabs(a_pivot_2) <= 1.0e-09
        || fabs(limb5_S_reduced_inertia_wy_by_limb5_S_wy) <= 7.562600000000002e-08 || fabs(pivot_1) <=
        7.551200000000001e-08 || !(t8 >= 0.999999 && t8 <= 1.000001) ? (double)NAN : (((minus_limb5_S_pivot_wz
        + a_pivot) + (a_pivot_2 + limb5_S_reduced_inertia_wy_by_limb5_S_wy)) + ((pivot_1 + limb5_S_y_ddot_qx)
        + (limb5_S_y_ddot_qy + every[0]))) + ((every[1] + every[2]) + every[3]);
}
#endif

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
    if (isfinite(three_ups_upu_s_forward_dynamics_independent_packed_lane(q, y_dot, u, y_ddot, sine, cosine)))
        {
        return 0;
    }
#endif
    return three_ups_upu_s_forward_dynamics_independent_limb_by_limb(q, y_dot, u, y_ddot);
}


BODY(three_ups_upu_s_forward_dynamics_reactions_wrenches)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, const double *restrict a,
    const double *restrict multipliers_, double *restrict reactions, double *restrict sized_,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    REAL checked0 = READ(u, 0);
    REAL checked1 = READ(u, 1);
    REAL checked2 = READ(u, 2);
    REAL checked3 = READ(u, 3);
    checked0 = checked0 + (READ(a, 14));
    /* mechanism: balance, eqs. (40)-(47) */
    const REAL multipliers_0 = READ(multipliers_, 0);
    RESULT(checked1, sized_, 12, -multipliers_0);
    const REAL multipliers_1 = READ(multipliers_, 1);
    RESULT(checked2, sized_, 13, -multipliers_1);
    const REAL multipliers_2 = READ(multipliers_, 2);
    RESULT(checked3, sized_, 14, -multipliers_2);
    const REAL multipliers_4 = READ(multipliers_, 4);
    RESULT(checked0, sized_, 30, -multipliers_4);
    const REAL multipliers_5 = READ(multipliers_, 5);
    RESULT(checked1, sized_, 31, -multipliers_5);
    const REAL multipliers_6 = READ(multipliers_, 6);
    RESULT(checked2, sized_, 32, -multipliers_6);
    const REAL multipliers_7 = READ(multipliers_, 7);
    RESULT(checked3, sized_, 48, -multipliers_7);
    const REAL multipliers_8 = READ(multipliers_, 8);
    RESULT(checked0, sized_, 49, -multipliers_8);
    const REAL multipliers_9 = READ(multipliers_, 9);
    RESULT(checked1, sized_, 50, -multipliers_9);
    const REAL multipliers_10 = READ(multipliers_, 10);
    RESULT(checked2, sized_, 66, -multipliers_10);
    const REAL multipliers_11 = READ(multipliers_, 11);
    RESULT(checked3, sized_, 67, -multipliers_11);
    const REAL multipliers_12 = READ(multipliers_, 12);
    RESULT(checked0, sized_, 68, -multipliers_12);
    /* limb1: velocities, eq. (6); geometry */
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1),
      limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin, limb1_lower_cos = SINES(cosine, 1),
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    /* limb1: accelerations; momentum rate, eq. (35); geometry */
    const REAL limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y, limb1_U_v_1 = READ(v, 1),
      minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x, limb1_U_a_1 = READ(a, 1),
      limb1_lower_U_yx = limb1_U_a_1 + limb1_lower_U_still_xy, t70 = k19 * limb1_lower_U_still_xy,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2), t4 = limb1_upper_offset_x * limb1_lower_U_yx,
      limb1_lower_rate_fy = limb_lower_mx * limb1_lower_U_yx, limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_acc_y = gravity_z * limb1_U_0_cos, minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y,
      t5 = t4 - minus_limb1_lower_acc_y,
      limb1_lower_rate_fy_2 = limb1_lower_rate_fy - limb_lower_m * minus_limb1_lower_acc_y,
      limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y, limb1_P_v = READ(v, 2),
      limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) + t5;
    /* limb1: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    const REAL limb1_upper_sent_fy = limb_lower_m * limb1_upper_acc_y - limb1_lower_rate_fy - multipliers_1;
    WRITE(sized_, 7, limb1_upper_sent_fy);
    const REAL limb1_lower_sent_fy = limb1_lower_rate_fy_2 + limb1_upper_sent_fy,
      minus_limb1_upper_rate_mz = limb_lower_mx * limb1_upper_acc_y, t6 = limb1_lower_cos * limb1_lower_sent_fy,
      t16 = limb1_lower_sin * limb1_lower_sent_fy,
      minus_limb1_lower_U_still_xx = limb1_lower_omega_y * limb1_lower_omega_y + limb1_U_v_1 * limb1_U_v_1,
      limb1_lower_force_x = limb_lower_m * (READ(a, 2) - (limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x)),
      minus_limb1_lower_rate_fx = limb_lower_mx * minus_limb1_lower_U_still_xx,
      limb1_upper_sent_fx = minus_limb1_lower_rate_fx + limb1_lower_force_x - multipliers_0,
      minus_limb1_lower_sent_fx = minus_limb1_lower_rate_fx - limb_lower_m * limb1_lower_acc_x - limb1_upper_sent_fx,
      limb1_lower_joint_sent_fy = t6 - limb1_lower_sin * minus_limb1_lower_sent_fx;
    WRITE(reactions, 0, limb1_lower_joint_sent_fy);
    WRITE(sized_, 1, limb1_lower_joint_sent_fy);
    checked1 = checked1 + limb1_lower_joint_sent_fy;
    const REAL minus_limb1_lower_joint_sent_fx = limb1_lower_cos * minus_limb1_lower_sent_fx + t16;
    RESULT(checked2, sized_, 0, -minus_limb1_lower_joint_sent_fx);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t22 = limb5_S_q_qw * limb5_S_q_qw,
      t23 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t24 = t22 + t23,
      t25 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t26 = limb5_S_q_qz * limb5_S_q_qz,
      t27 = t25 + t26, t28 = t24 + t27, t30 = 4.0 - 2.0 * t28, t380 = t23 + t25,
      platform_turn_yy = 1.0 - t30 * (t23 + t26), platform_turn_xx = 1.0 - t27 * t30,
      platform_turn_zz = 1.0 - t30 * t380, t34 = limb5_S_q_qz * t30, t35 = limb5_S_q_qy * t34,
      t37 = limb5_S_q_qw * (limb5_S_q_qx * t30), t76 = limb5_S_q_qy * t30, platform_turn_zy = t35 + t37;
    /* limb1: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb1_U_0_sin = SINES(sine, 0), multipliers_3 = READ(multipliers_, 3), platform_turn_yz = t35 - t37,
      minus_limb1_U2_joint_reaction_mx = (limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy) * multipliers_3,
      limb1_lower_alpha_still_x = limb1_U_v_1 * limb1_lower_omega_y, limb1_U_a_0 = READ(a, 0),
      t11 = limb1_P_v * (2.0 * limb1_lower_omega_y),
      t20 = k14 * (limb1_lower_alpha_still_x + limb1_U_a_0 * limb1_lower_sin),
      limb1_upper_rate_mx = t20 - k15 * limb1_lower_alpha_still_x,
      limb1_upper_sent_mx = limb1_upper_rate_mx - minus_limb1_U2_joint_reaction_mx,
      limb1_lower_sent_mx = limb1_upper_rate_mx + limb1_upper_sent_mx;
    RESULT(checked3, sized_, 9, per_length * limb1_upper_sent_mx);
    const REAL t47 = limb1_lower_cos * limb1_lower_sent_mx, t39 = limb1_lower_sin * limb1_lower_sent_mx,
      minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_U_a_0 * limb1_lower_cos,
      limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y,
      t42 = k16 * minus_limb1_lower_alpha_y + k17 * minus_limb1_lower_alpha_still_y,
      t12 = limb1_upper_offset_x * limb1_lower_U_zx, limb1_lower_rate_fz = limb_lower_mx * limb1_lower_U_zx,
      minus_limb1_upper_acc_z = t11 - (t12 + gravity_z * limb1_U_0_sin),
      minus_limb1_upper_sent_fz = limb_lower_m * minus_limb1_upper_acc_z + limb1_lower_rate_fz + multipliers_2,
      minus_limb1_upper_rate_my_2 = limb_lower_mx * minus_limb1_upper_acc_z + t42;
    /* limb1: balance, eqs. (40)-(47); reactions, eq. (32) */
    RESULT(checked0, sized_, 8, -minus_limb1_upper_sent_fz);
    const REAL t44 = minus_limb1_upper_rate_my_2 - limb1_upper_offset_x * minus_limb1_upper_sent_fz,
      minus_limb1_lower_sent_my = gravity_z_limb_lower_mx * limb1_U_0_sin + t42 + t44,
      limb1_lower_joint_sent_mx = t47 + limb1_lower_sin * minus_limb1_lower_sent_my;
    RESULT(checked1, sized_, 3, per_length * limb1_lower_joint_sent_mx);
    const REAL limb1_lower_joint_sent_my = t39 - limb1_lower_cos * minus_limb1_lower_sent_my;
    WRITE(reactions, 3, limb1_lower_joint_sent_my);
    RESULT(checked2, sized_, 4, per_length * limb1_lower_joint_sent_my);
    const REAL t49 = limb1_U_0_sin * limb1_lower_joint_sent_mx, t50 = limb1_U_0_cos * limb1_lower_joint_sent_mx,
      t19 = limb1_U_0_cos * minus_limb1_lower_joint_sent_fx, t17 = limb1_U_0_sin * minus_limb1_lower_joint_sent_fx,
      limb1_lower_sent_fz = limb1_lower_rate_fz + limb_lower_m_gravity_z * limb1_U_0_sin - minus_limb1_upper_sent_fz;
    WRITE(sized_, 2, limb1_lower_sent_fz);
    const REAL limb1_U_0_joint_sent_fy = limb1_U_0_sin * limb1_lower_sent_fz - t19;
    WRITE(reactions, 2, limb1_U_0_joint_sent_fy);
    RESULT(checked3, reactions, 4, param_R * limb1_U_0_joint_sent_fy - t49);
    const REAL limb1_U_0_joint_sent_fx = limb1_U_0_cos * limb1_lower_sent_fz + t17;
    WRITE(reactions, 1, limb1_U_0_joint_sent_fx);
    /* limb1: reactions, eq. (32); geometry; reciprocal wrenches, eq. (10) */
    RESULT(checked0, reactions, 5, t50 - param_R * limb1_U_0_joint_sent_fx);
    const REAL t55 = limb1_U_0_sin * minus_limb1_upper_sent_fz, t53 = limb1_U_0_cos * minus_limb1_upper_sent_fz,
      minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin,
      t56 = minus_limb1_lower_rotation_zy * limb1_upper_sent_fy + t55;
    RESULT(checked1, reactions, 8, -t56);
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos,
      minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx,
      t57 = minus_limb1_upper_position_y * t56, limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin,
      limb1_P_reactions_fy = limb1_lower_rotation_yy * limb1_upper_sent_fy - t53;
    WRITE(reactions, 7, limb1_P_reactions_fy);
    const REAL limb1_P_reactions_fx = limb1_lower_cos * limb1_upper_sent_fy;
    WRITE(reactions, 6, limb1_P_reactions_fx);
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos,
      limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t64 = minus_limb1_upper_position_x * t56, t59 = t57 - limb1_upper_position_z * limb1_P_reactions_fy,
      t87 = minus_limb1_upper_position_x * limb1_P_reactions_fy;
    RESULT(checked2, reactions, 9, t59 - (limb1_lower_cos * minus_limb1_upper_rate_my_2 - limb1_lower_sin * limb1_upper_sent_mx));
    const REAL t75 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy),
      t77 = limb5_S_q_qx * t76, /* limb5_S */
      t372 = limb5_S_q_qw * t76, /* limb5_S */
      t78 = limb5_S_q_qw * t34, /* limb5_S */
      t371 = limb5_S_q_qx * t34, /* limb5_S */
      platform_turn_xy = t77 - t78, platform_turn_yx = t77 + t78,
      minus_limb1_U2_joint_reaction_mz = (t75 - limb1_lower_sin * platform_turn_xy) * multipliers_3,
      minus_limb1_upper_sent_mz = minus_limb1_upper_rate_mz - (k18 * limb1_U_a_1 + t70) + minus_limb1_U2_joint_reaction_mz,
      t80 = limb1_U_0_cos * minus_limb1_upper_sent_mz, t67 = minus_limb1_lower_rotation_yx * limb1_upper_sent_mx,
      t83 = limb1_lower_rotation_zx * limb1_upper_sent_mx,
      t81 = limb1_lower_rotation_yy * minus_limb1_upper_rate_my_2 + t67 + t80,
      t95 = limb1_lower_rotation_yy * multipliers_1;
    RESULT(checked3, reactions, 10, limb1_upper_position_z * limb1_P_reactions_fx - t64 - t81);
    const REAL t89 = t87 - minus_limb1_upper_position_y * limb1_P_reactions_fx,
      t85 = limb1_U_0_sin * minus_limb1_upper_sent_mz;
    RESULT(checked0, sized_, 11, -(per_length * minus_limb1_upper_sent_mz));
    RESULT(checked1, reactions, 11, minus_limb1_lower_rotation_zy * minus_limb1_upper_rate_my_2 + t83 - t85 - t89);
    const REAL t100 = minus_limb1_lower_rotation_zy * multipliers_1;
    RESULT(checked2, sized_, 10, -(per_length * minus_limb1_upper_rate_my_2));
    const REAL t92 = limb1_lower_sin * multipliers_0 + limb1_lower_cos * multipliers_1;
    RESULT(checked3, reactions, 12, -t92);
    const REAL t96 = minus_limb1_lower_rotation_yx * multipliers_0 - t95,
      t107 = minus_limb1_lower_rotation_yx * minus_limb1_U2_joint_reaction_mx, t93 = limb1_U_0_cos * multipliers_2,
      t97 = t93 - t96;
    RESULT(checked0, reactions, 13, -t97);
    const REAL t101 = limb1_lower_rotation_zx * multipliers_0 - t100,
      t116 = limb1_lower_rotation_zx * minus_limb1_U2_joint_reaction_mx, t98 = limb1_U_0_sin * multipliers_2,
      t102 = t98 + t101;
    RESULT(checked1, reactions, 14, -t102);
    const REAL t106 = limb1_lower_sin * minus_limb1_U2_joint_reaction_mx;
    RESULT(checked2, sized_, 15, -(per_length * minus_limb1_U2_joint_reaction_mx));
    const REAL t111 = minus_limb1_upper_position_x * t102, t113 = minus_limb1_upper_position_x * t97;
    RESULT(checked3, reactions, 15, minus_limb1_upper_position_y * t102 + limb1_upper_position_z * t97 - t106);
    const REAL t115 = t113 - minus_limb1_upper_position_y * t92;
    RESULT(checked0, reactions, 16, t107 - limb1_U_0_cos * minus_limb1_U2_joint_reaction_mz - (limb1_upper_position_z * t92 + t111));
    RESULT(checked1, reactions, 17, t115 - (t116 + limb1_U_0_sin * minus_limb1_U2_joint_reaction_mz));
    RESULT(checked2, sized_, 17, -(per_length * minus_limb1_U2_joint_reaction_mz));
    /* limb2: velocities, eq. (6); geometry */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3),
      limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin, limb2_lower_cos = SINES(cosine, 3),
      limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos;
    /* limb2: accelerations; momentum rate, eq. (35); geometry */
    const REAL limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y, limb2_U_v_1 = READ(v, 4),
      minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x, limb2_U_a_1 = READ(a, 4),
      limb2_lower_U_yx = limb2_U_a_1 + limb2_lower_U_still_xy, t161 = k19 * limb2_lower_U_still_xy,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5), t130 = limb2_upper_offset_x * limb2_lower_U_yx,
      limb2_lower_rate_fy = limb_lower_mx * limb2_lower_U_yx, limb2_U_0_sin = SINES(cosine, 2),
      minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin, limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y,
      t131 = t130 + limb2_lower_acc_y, limb2_lower_rate_fy_2 = limb2_lower_rate_fy + limb_lower_m * limb2_lower_acc_y,
      minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y, limb2_P_v = READ(v, 5),
      limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + t131;
    /* limb2: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    const REAL limb2_upper_sent_fy = limb_lower_m * limb2_upper_acc_y - limb2_lower_rate_fy - multipliers_5;
    WRITE(sized_, 25, limb2_upper_sent_fy);
    const REAL limb2_lower_sent_fy = limb2_lower_rate_fy_2 + limb2_upper_sent_fy,
      minus_limb2_upper_rate_mz = limb_lower_mx * limb2_upper_acc_y, t134 = limb2_lower_cos * limb2_lower_sent_fy,
      t132 = limb2_lower_sin * limb2_lower_sent_fy,
      minus_limb2_lower_U_still_xx = limb2_lower_omega_y * limb2_lower_omega_y + limb2_U_v_1 * limb2_U_v_1,
      limb2_lower_force_x = limb_lower_m * (READ(a, 5) - (limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x)),
      minus_limb2_lower_rate_fx = limb_lower_mx * minus_limb2_lower_U_still_xx,
      limb2_upper_sent_fx = minus_limb2_lower_rate_fx + limb2_lower_force_x - multipliers_4,
      minus_limb2_lower_sent_fx = minus_limb2_lower_rate_fx + limb_lower_m * minus_limb2_lower_acc_x - limb2_upper_sent_fx,
      limb2_lower_joint_sent_fy = t134 - limb2_lower_sin * minus_limb2_lower_sent_fx;
    WRITE(reactions, 19, limb2_lower_joint_sent_fy);
    WRITE(sized_, 19, limb2_lower_joint_sent_fy);
    checked3 = checked3 + limb2_lower_joint_sent_fy;
    const REAL minus_limb2_lower_joint_sent_fx = limb2_lower_cos * minus_limb2_lower_sent_fx + t132;
    RESULT(checked0, sized_, 18, -minus_limb2_lower_joint_sent_fx);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_a_0 = READ(a, 3),
      t137 = limb2_U_0_sin * minus_limb2_lower_joint_sent_fx,
      t133 = minus_limb2_U_0_cos * minus_limb2_lower_joint_sent_fx,
      minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y - limb2_U_a_0 * limb2_lower_cos,
      limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y,
      t144 = k16 * minus_limb2_lower_alpha_y + k17 * minus_limb2_lower_alpha_still_y,
      t122 = limb2_upper_offset_x * limb2_lower_U_zx, limb2_lower_rate_fz = limb_lower_mx * limb2_lower_U_zx,
      minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) - (t122 - gravity_z * minus_limb2_U_0_cos),
      limb2_lower_alpha_still_x = limb2_U_v_1 * limb2_lower_omega_y,
      minus_limb2_upper_sent_fz = limb_lower_m * minus_limb2_upper_acc_z + limb2_lower_rate_fz + multipliers_6,
      minus_limb2_upper_rate_my_2 = limb_lower_mx * minus_limb2_upper_acc_z + t144;
    RESULT(checked1, sized_, 26, -minus_limb2_upper_sent_fz);
    const REAL limb2_lower_sent_fz = limb2_lower_rate_fz - limb_lower_m_gravity_z * minus_limb2_U_0_cos - minus_limb2_upper_sent_fz;
    WRITE(sized_, 20, limb2_lower_sent_fz);
    const REAL minus_limb2_U_0_joint_sent_fx = minus_limb2_U_0_cos * limb2_lower_sent_fz - t137;
    RESULT(checked2, reactions, 20, -minus_limb2_U_0_joint_sent_fx);
    const REAL t138 = param_R * minus_limb2_U_0_joint_sent_fx,
      limb2_U_0_joint_sent_fy = limb2_U_0_sin * limb2_lower_sent_fz + t133;
    WRITE(reactions, 18, limb2_U_0_joint_sent_fy);
    const REAL t151 = param_R * limb2_U_0_joint_sent_fy,
      t146 = minus_limb2_upper_rate_my_2 - limb2_upper_offset_x * minus_limb2_upper_sent_fz,
      limb2_lower_sent_my = gravity_z_limb_lower_mx * minus_limb2_U_0_cos - t144 - t146,
      t147 = limb2_lower_sin * limb2_lower_sent_my, t150 = limb2_lower_cos * limb2_lower_sent_my,
      t139 = k14 * (limb2_lower_alpha_still_x + limb2_U_a_0 * limb2_lower_sin),
      limb2_upper_rate_mx = t139 - k15 * limb2_lower_alpha_still_x;
    RESULT(checked3, sized_, 27, per_length * limb2_upper_rate_mx);
    const REAL limb2_lower_sent_mx = 2.0 * limb2_upper_rate_mx,
      limb2_lower_joint_sent_mx = limb2_lower_cos * limb2_lower_sent_mx - t147;
    RESULT(checked0, sized_, 21, per_length * limb2_lower_joint_sent_mx);
    const REAL limb2_lower_joint_sent_my = limb2_lower_sin * limb2_lower_sent_mx + t150;
    WRITE(reactions, 22, limb2_lower_joint_sent_my);
    RESULT(checked1, sized_, 22, per_length * limb2_lower_joint_sent_my);
    /* limb2: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    RESULT(checked2, reactions, 21, t138 - minus_limb2_U_0_cos * limb2_lower_joint_sent_mx);
    RESULT(checked3, reactions, 23, t151 - limb2_U_0_sin * limb2_lower_joint_sent_mx);
    const REAL t156 = minus_limb2_U_0_cos * minus_limb2_upper_sent_fz,
      t154 = limb2_U_0_sin * minus_limb2_upper_sent_fz, limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin,
      limb2_P_reactions_fz = limb2_lower_rotation_zy * limb2_upper_sent_fy + t156;
    WRITE(reactions, 26, limb2_P_reactions_fz);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      t165 = minus_limb2_upper_position_y * limb2_P_reactions_fz,
      limb2_P_reactions_fy = limb2_lower_cos * limb2_upper_sent_fy;
    WRITE(reactions, 25, limb2_P_reactions_fy);
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos,
      minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx,
      t167 = t165 - minus_limb2_upper_position_z * limb2_P_reactions_fy,
      limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin,
      limb2_P_reactions_fx = limb2_lower_rotation_xy * limb2_upper_sent_fy - t154;
    WRITE(reactions, 24, limb2_P_reactions_fx);
    const REAL t158 = limb2_lower_rotation_xy * minus_limb2_upper_rate_my_2,
      t186 = limb2_lower_rotation_xy * multipliers_5,
      minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos,
      minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx,
      t173 = minus_limb2_upper_position_x * limb2_P_reactions_fz,
      t180 = minus_limb2_upper_position_x * limb2_P_reactions_fy,
      t159 = minus_limb2_lower_rotation_xx * limb2_upper_rate_mx + t158,
      t187 = minus_limb2_lower_rotation_xx * multipliers_4 - t186,
      minus_limb2_upper_rate_mz_2 = minus_limb2_upper_rate_mz - (k18 * limb2_U_a_1 + t161);
    RESULT(checked0, reactions, 27, -(t159 + limb2_U_0_sin * minus_limb2_upper_rate_mz_2 + t167));
    const REAL t174 = minus_limb2_upper_position_z * limb2_P_reactions_fx - t173,
      t182 = t180 - minus_limb2_upper_position_y * limb2_P_reactions_fx;
    RESULT(checked1, reactions, 28, limb2_lower_sin * limb2_upper_rate_mx - limb2_lower_cos * minus_limb2_upper_rate_my_2 - t174);
    const REAL t175 = minus_limb2_lower_rotation_zx * limb2_upper_rate_mx,
      t177 = t175 + limb2_lower_rotation_zy * minus_limb2_upper_rate_my_2,
      t195 = minus_limb2_lower_rotation_zx * multipliers_4 - limb2_lower_rotation_zy * multipliers_5;
    RESULT(checked2, sized_, 28, -(per_length * minus_limb2_upper_rate_my_2));
    RESULT(checked3, reactions, 29, -(t177 - minus_limb2_U_0_cos * minus_limb2_upper_rate_mz_2 + t182));
    RESULT(checked0, sized_, 29, -(per_length * minus_limb2_upper_rate_mz_2));
    const REAL t184 = limb2_U_0_sin * multipliers_6, t188 = t184 - t187;
    RESULT(checked1, reactions, 30, -t188);
    const REAL t191 = limb2_lower_sin * multipliers_4 + limb2_lower_cos * multipliers_5;
    RESULT(checked2, reactions, 31, -t191);
    const REAL t192 = minus_limb2_U_0_cos * multipliers_6, limb2_S_reactions_fz = t192 + t195;
    WRITE(reactions, 32, limb2_S_reactions_fz);
    const REAL t196 = minus_limb2_upper_position_y * limb2_S_reactions_fz, t202 = minus_limb2_upper_position_y * t188;
    RESULT(checked3, reactions, 34, minus_limb2_upper_position_z * t188 + minus_limb2_upper_position_x * limb2_S_reactions_fz);
    RESULT(checked0, reactions, 33, -(t196 + minus_limb2_upper_position_z * t191));
    RESULT(checked1, reactions, 35, minus_limb2_upper_position_x * t191 - t202);
    /* limb3: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb3_U_v_0 = READ(v, 6), limb3_lower_cos = SINES(cosine, 5),
      limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos, limb3_U_v_1 = READ(v, 7),
      minus_limb3_lower_U_still_xx = limb3_lower_omega_y * limb3_lower_omega_y + limb3_U_v_1 * limb3_U_v_1,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      minus_limb3_upper_acc_still_x = limb3_upper_offset_x * minus_limb3_lower_U_still_xx,
      minus_limb3_lower_rate_fx = limb_lower_mx * minus_limb3_lower_U_still_xx, limb3_U_0_cos = SINES(cosine, 4),
      limb3_U_0_acc_y = gravity_z * limb3_U_0_cos, limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y,
      limb3_upper_rate_fx = minus_limb3_lower_rate_fx + limb_lower_m * (READ(a, 8) - (minus_limb3_upper_acc_still_x - limb3_lower_acc_x)),
      limb3_upper_sent_fx = limb3_upper_rate_fx - multipliers_7,
      minus_limb3_lower_sent_fx = minus_limb3_lower_rate_fx - limb_lower_m * limb3_lower_acc_x - limb3_upper_sent_fx,
      minus_limb3_lower_sin = SINES(sine, 5), limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y,
      t206 = minus_limb3_lower_sin * minus_limb3_lower_sent_fx, t217 = limb3_lower_cos * minus_limb3_lower_sent_fx,
      minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin,
      minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y,
      limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x, limb3_U_a_1 = READ(a, 7),
      limb3_lower_U_yx = limb3_U_a_1 - minus_limb3_lower_U_still_xy, t256 = k19 * minus_limb3_lower_U_still_xy,
      t210 = limb3_upper_offset_x * limb3_lower_U_yx + limb3_lower_acc_y,
      limb3_lower_rate_fy = limb_lower_mx * limb3_lower_U_yx, limb3_P_v = READ(v, 8),
      limb3_lower_rate_fy_2 = limb3_lower_rate_fy + limb_lower_m * limb3_lower_acc_y,
      limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + t210;
    /* limb3: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    const REAL limb3_upper_sent_fy = limb_lower_m * limb3_upper_acc_y - limb3_lower_rate_fy - multipliers_8;
    WRITE(sized_, 43, limb3_upper_sent_fy);
    const REAL limb3_lower_sent_fy = limb3_lower_rate_fy_2 + limb3_upper_sent_fy,
      minus_limb3_upper_rate_mz = limb_lower_mx * limb3_upper_acc_y,
      limb3_lower_joint_sent_fy = t206 + limb3_lower_cos * limb3_lower_sent_fy;
    WRITE(reactions, 36, limb3_lower_joint_sent_fy);
    WRITE(sized_, 37, limb3_lower_joint_sent_fy);
    checked2 = checked2 + limb3_lower_joint_sent_fy;
    const REAL minus_limb3_lower_joint_sent_fx = t217 - minus_limb3_lower_sin * limb3_lower_sent_fy;
    RESULT(checked3, sized_, 36, -minus_limb3_lower_joint_sent_fx);
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_a_0 = READ(a, 6),
      t219 = limb3_U_0_sin * minus_limb3_lower_joint_sent_fx, t221 = limb3_U_0_cos * minus_limb3_lower_joint_sent_fx,
      limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_U_a_0 * limb3_lower_cos,
      minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y,
      t227 = k16 * limb3_lower_alpha_y + k17 * limb3_lower_alpha_still_y,
      t214 = limb3_upper_offset_x * minus_limb3_lower_U_zx,
      minus_limb3_lower_rate_fz = limb_lower_mx * minus_limb3_lower_U_zx,
      minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) + (t214 - gravity_z * limb3_U_0_sin),
      limb3_lower_alpha_still_x = limb3_U_v_1 * limb3_lower_omega_y,
      minus_limb3_upper_sent_fz = limb_lower_m * minus_limb3_upper_acc_z - minus_limb3_lower_rate_fz + multipliers_9,
      minus_limb3_upper_rate_my_2 = limb_lower_mx * minus_limb3_upper_acc_z - t227;
    RESULT(checked0, sized_, 44, -minus_limb3_upper_sent_fz);
    const REAL minus_limb3_lower_sent_fz = minus_limb3_lower_rate_fz - limb_lower_m_gravity_z * limb3_U_0_sin + minus_limb3_upper_sent_fz;
    RESULT(checked1, sized_, 38, -minus_limb3_lower_sent_fz);
    const REAL minus_limb3_U_0_joint_sent_fx = limb3_U_0_cos * minus_limb3_lower_sent_fz - t219;
    RESULT(checked2, reactions, 37, -minus_limb3_U_0_joint_sent_fx);
    const REAL minus_limb3_U_0_joint_sent_fy = limb3_U_0_sin * minus_limb3_lower_sent_fz + t221;
    RESULT(checked3, reactions, 38, -minus_limb3_U_0_joint_sent_fy);
    const REAL t231 = param_R * minus_limb3_U_0_joint_sent_fy, t236 = param_R * minus_limb3_U_0_joint_sent_fx,
      t229 = minus_limb3_upper_rate_my_2 - limb3_upper_offset_x * minus_limb3_upper_sent_fz,
      minus_limb3_lower_sent_my = gravity_z_limb_lower_mx * limb3_U_0_sin - t227 + t229,
      t230 = limb3_lower_cos * minus_limb3_lower_sent_my, t233 = minus_limb3_lower_sin * minus_limb3_lower_sent_my,
      t222 = k14 * (limb3_lower_alpha_still_x - limb3_U_a_0 * minus_limb3_lower_sin),
      limb3_upper_rate_mx = t222 - k15 * limb3_lower_alpha_still_x;
    RESULT(checked0, sized_, 45, per_length * limb3_upper_rate_mx);
    const REAL limb3_lower_sent_mx = 2.0 * limb3_upper_rate_mx,
      minus_limb3_lower_joint_sent_my = minus_limb3_lower_sin * limb3_lower_sent_mx + t230;
    RESULT(checked1, reactions, 39, -minus_limb3_lower_joint_sent_my);
    const REAL limb3_lower_joint_sent_mx = limb3_lower_cos * limb3_lower_sent_mx - t233;
    RESULT(checked2, sized_, 39, per_length * limb3_lower_joint_sent_mx);
    RESULT(checked3, sized_, 40, -(per_length * minus_limb3_lower_joint_sent_my));
    /* limb3: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    RESULT(checked0, reactions, 40, t231 - limb3_U_0_sin * limb3_lower_joint_sent_mx);
    RESULT(checked1, reactions, 41, limb3_U_0_cos * limb3_lower_joint_sent_mx - t236);
    const REAL t238 = limb3_U_0_cos * minus_limb3_upper_sent_fz, t241 = limb3_U_0_sin * minus_limb3_upper_sent_fz,
      minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin,
      t239 = minus_limb3_lower_rotation_yy * limb3_upper_sent_fy + t238;
    RESULT(checked2, reactions, 43, -t239);
    const REAL limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin,
      limb3_P_reactions_fz = limb3_lower_rotation_zy * limb3_upper_sent_fy - t241;
    WRITE(reactions, 44, limb3_P_reactions_fz);
    const REAL limb3_P_reactions_fx = limb3_lower_cos * limb3_upper_sent_fy;
    WRITE(reactions, 42, limb3_P_reactions_fx);
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos,
      minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx,
      t245 = minus_limb3_upper_position_y * limb3_P_reactions_fz,
      limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos,
      limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx,
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x,
      t250 = limb3_upper_position_x * limb3_P_reactions_fz, t247 = t245 - limb3_upper_position_z * t239,
      t265 = limb3_upper_position_x * t239,
      t248 = minus_limb3_lower_sin * limb3_upper_rate_mx + limb3_lower_cos * minus_limb3_upper_rate_my_2 + t247;
    RESULT(checked3, reactions, 45, -t248);
    const REAL t251 = limb3_upper_position_z * limb3_P_reactions_fx - t250,
      t267 = t265 - minus_limb3_upper_position_y * limb3_P_reactions_fx,
      t253 = minus_limb3_lower_rotation_yy * minus_limb3_upper_rate_my_2,
      t254 = minus_limb3_lower_rotation_yx * limb3_upper_rate_mx - t253,
      t260 = limb3_lower_rotation_zx * limb3_upper_rate_mx,
      t273 = minus_limb3_lower_rotation_yx * multipliers_7 + minus_limb3_lower_rotation_yy * multipliers_8,
      t276 = limb3_lower_rotation_zx * multipliers_7,
      minus_limb3_upper_rate_mz_2 = minus_limb3_upper_rate_mz - (k18 * limb3_U_a_1 - t256);
    RESULT(checked0, reactions, 46, t251 - (t254 + limb3_U_0_cos * minus_limb3_upper_rate_mz_2));
    const REAL t262 = t260 - limb3_lower_rotation_zy * minus_limb3_upper_rate_my_2,
      t278 = t276 + limb3_lower_rotation_zy * multipliers_8;
    RESULT(checked1, sized_, 46, -(per_length * minus_limb3_upper_rate_my_2));
    RESULT(checked2, reactions, 47, t262 - limb3_U_0_sin * minus_limb3_upper_rate_mz_2 - t267);
    RESULT(checked3, sized_, 47, -(per_length * minus_limb3_upper_rate_mz_2));
    const REAL t270 = limb3_U_0_cos * multipliers_9, t274 = t270 - t273;
    RESULT(checked0, reactions, 49, -t274);
    const REAL t275 = limb3_U_0_sin * multipliers_9, t279 = t275 + t278;
    RESULT(checked1, reactions, 50, -t279);
    const REAL t283 = limb3_upper_position_x * t279, t285 = limb3_upper_position_x * t274;
    RESULT(checked2, reactions, 51, minus_limb3_upper_position_y * t279 + limb3_upper_position_z * t274);
    const REAL limb3_S_reactions_fx = minus_limb3_lower_sin * multipliers_7 - limb3_lower_cos * multipliers_8;
    WRITE(reactions, 48, limb3_S_reactions_fx);
    RESULT(checked3, reactions, 52, limb3_upper_position_z * limb3_S_reactions_fx + t283);
    RESULT(checked0, reactions, 53, minus_limb3_upper_position_y * limb3_S_reactions_fx - t285);
    /* limb4: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb4_U_v_0 = READ(v, 9), limb4_lower_cos = SINES(cosine, 7),
      limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos, limb4_U_v_1 = READ(v, 10),
      minus_limb4_lower_U_still_xx = limb4_lower_omega_y * limb4_lower_omega_y + limb4_U_v_1 * limb4_U_v_1,
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      minus_limb4_upper_acc_still_x = limb4_upper_offset_x * minus_limb4_lower_U_still_xx,
      minus_limb4_lower_rate_fx = limb_lower_mx * minus_limb4_lower_U_still_xx, limb4_U_0_sin = SINES(cosine, 6),
      minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin,
      minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y,
      limb4_upper_rate_fx = minus_limb4_lower_rate_fx + limb_lower_m * (READ(a, 11) - (minus_limb4_upper_acc_still_x + minus_limb4_lower_acc_x)),
      limb4_upper_sent_fx = limb4_upper_rate_fx - multipliers_10,
      minus_limb4_lower_sent_fx = minus_limb4_lower_rate_fx + limb_lower_m * minus_limb4_lower_acc_x - limb4_upper_sent_fx,
      minus_limb4_lower_sin = SINES(sine, 7), minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y,
      t294 = limb4_lower_cos * minus_limb4_lower_sent_fx, t301 = minus_limb4_lower_sin * minus_limb4_lower_sent_fx,
      minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin,
      minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y,
      limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x, limb4_U_a_1 = READ(a, 10),
      limb4_lower_U_yx = limb4_U_a_1 - minus_limb4_lower_U_still_xy, t330 = k19 * minus_limb4_lower_U_still_xy,
      t298 = limb4_upper_offset_x * limb4_lower_U_yx - minus_limb4_lower_acc_y,
      limb4_lower_rate_fy = limb_lower_mx * limb4_lower_U_yx, limb4_P_v = READ(v, 11),
      limb4_lower_rate_fy_2 = limb4_lower_rate_fy - limb_lower_m * minus_limb4_lower_acc_y,
      limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) + t298;
    /* limb4: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    const REAL limb4_upper_sent_fy = limb_lower_m * limb4_upper_acc_y - limb4_lower_rate_fy - multipliers_11;
    WRITE(sized_, 61, limb4_upper_sent_fy);
    const REAL limb4_lower_sent_fy = limb4_lower_rate_fy_2 + limb4_upper_sent_fy,
      minus_limb4_upper_rate_mz = limb_lower_mx * limb4_upper_acc_y,
      minus_limb4_lower_joint_sent_fx = t294 - minus_limb4_lower_sin * limb4_lower_sent_fy,
      limb4_lower_joint_sent_fy = t301 + limb4_lower_cos * limb4_lower_sent_fy;
    WRITE(reactions, 55, limb4_lower_joint_sent_fy);
    WRITE(sized_, 55, limb4_lower_joint_sent_fy);
    checked1 = checked1 + limb4_lower_joint_sent_fy;
    RESULT(checked2, sized_, 54, -minus_limb4_lower_joint_sent_fx);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_a_0 = READ(a, 9),
      t300 = minus_limb4_U_0_cos * minus_limb4_lower_joint_sent_fx,
      t304 = limb4_U_0_sin * minus_limb4_lower_joint_sent_fx,
      limb4_lower_alpha_y = limb4_lower_alpha_still_y + limb4_U_a_0 * limb4_lower_cos,
      minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y,
      t311 = k16 * limb4_lower_alpha_y + k17 * limb4_lower_alpha_still_y,
      t289 = limb4_upper_offset_x * minus_limb4_lower_U_zx,
      minus_limb4_lower_rate_fz = limb_lower_mx * minus_limb4_lower_U_zx,
      minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + (t289 + gravity_z * minus_limb4_U_0_cos),
      limb4_lower_alpha_still_x = limb4_U_v_1 * limb4_lower_omega_y,
      minus_limb4_upper_sent_fz = limb_lower_m * minus_limb4_upper_acc_z - minus_limb4_lower_rate_fz + multipliers_12,
      minus_limb4_upper_rate_my_2 = limb_lower_mx * minus_limb4_upper_acc_z - t311;
    RESULT(checked3, sized_, 62, -minus_limb4_upper_sent_fz);
    const REAL minus_limb4_lower_sent_fz = minus_limb4_lower_rate_fz + limb_lower_m_gravity_z * minus_limb4_U_0_cos + minus_limb4_upper_sent_fz;
    RESULT(checked0, sized_, 56, -minus_limb4_lower_sent_fz);
    const REAL minus_limb4_U_0_joint_sent_fy = limb4_U_0_sin * minus_limb4_lower_sent_fz - t300;
    RESULT(checked1, reactions, 54, -minus_limb4_U_0_joint_sent_fy);
    const REAL limb4_U_0_joint_sent_fx = minus_limb4_U_0_cos * minus_limb4_lower_sent_fz + t304;
    WRITE(reactions, 56, limb4_U_0_joint_sent_fx);
    const REAL t305 = param_R * limb4_U_0_joint_sent_fx, t318 = param_R * minus_limb4_U_0_joint_sent_fy,
      t313 = minus_limb4_upper_rate_my_2 - limb4_upper_offset_x * minus_limb4_upper_sent_fz,
      limb4_lower_sent_my = gravity_z_limb_lower_mx * minus_limb4_U_0_cos + t311 - t313,
      t314 = minus_limb4_lower_sin * limb4_lower_sent_my, t317 = limb4_lower_cos * limb4_lower_sent_my,
      t306 = k14 * (limb4_lower_alpha_still_x - limb4_U_a_0 * minus_limb4_lower_sin),
      limb4_upper_rate_mx = t306 - k15 * limb4_lower_alpha_still_x;
    RESULT(checked2, sized_, 63, per_length * limb4_upper_rate_mx);
    const REAL limb4_lower_sent_mx = 2.0 * limb4_upper_rate_mx,
      limb4_lower_joint_sent_mx = limb4_lower_cos * limb4_lower_sent_mx + t314,
      minus_limb4_lower_joint_sent_my = minus_limb4_lower_sin * limb4_lower_sent_mx - t317;
    RESULT(checked3, reactions, 58, -minus_limb4_lower_joint_sent_my);
    RESULT(checked0, sized_, 57, per_length * limb4_lower_joint_sent_mx);
    RESULT(checked1, sized_, 58, -(per_length * minus_limb4_lower_joint_sent_my));
    /* limb4: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    RESULT(checked2, reactions, 57, t305 - minus_limb4_U_0_cos * limb4_lower_joint_sent_mx);
    RESULT(checked3, reactions, 59, t318 - limb4_U_0_sin * limb4_lower_joint_sent_mx);
    const REAL t321 = limb4_U_0_sin * minus_limb4_upper_sent_fz,
      t324 = minus_limb4_U_0_cos * minus_limb4_upper_sent_fz,
      minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin,
      t322 = minus_limb4_lower_rotation_xy * limb4_upper_sent_fy + t321;
    RESULT(checked0, reactions, 60, -t322);
    const REAL minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin,
      t325 = minus_limb4_lower_rotation_zy * limb4_upper_sent_fy - t324;
    RESULT(checked1, reactions, 62, -t325);
    const REAL limb4_P_reactions_fy = limb4_lower_cos * limb4_upper_sent_fy;
    WRITE(reactions, 61, limb4_P_reactions_fy);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      t334 = limb4_upper_position_y * t325, minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos,
      minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx,
      t336 = t334 - minus_limb4_upper_position_z * limb4_P_reactions_fy,
      t327 = minus_limb4_lower_rotation_xy * minus_limb4_upper_rate_my_2,
      t355 = minus_limb4_lower_rotation_xy * multipliers_11,
      minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos,
      minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx,
      t339 = minus_limb4_upper_position_x * t325, t349 = minus_limb4_upper_position_x * limb4_P_reactions_fy,
      t328 = minus_limb4_lower_rotation_xx * limb4_upper_rate_mx - t327,
      t356 = minus_limb4_lower_rotation_xx * multipliers_10 + t355,
      minus_limb4_upper_rate_mz_2 = minus_limb4_upper_rate_mz - (k18 * limb4_U_a_1 - t330);
    RESULT(checked2, reactions, 63, -(t328 + limb4_U_0_sin * minus_limb4_upper_rate_mz_2 + t336));
    const REAL t340 = minus_limb4_upper_position_z * t322 - t339, t351 = t349 - limb4_upper_position_y * t322;
    RESULT(checked3, reactions, 64, t340 - (minus_limb4_lower_sin * limb4_upper_rate_mx + limb4_lower_cos * minus_limb4_upper_rate_my_2));
    const REAL t344 = minus_limb4_lower_rotation_zx * limb4_upper_rate_mx,
      t346 = t344 - minus_limb4_lower_rotation_zy * minus_limb4_upper_rate_my_2,
      t363 = minus_limb4_lower_rotation_zx * multipliers_10 + minus_limb4_lower_rotation_zy * multipliers_11;
    RESULT(checked0, sized_, 64, -(per_length * minus_limb4_upper_rate_my_2));
    RESULT(checked1, reactions, 65, -(t346 - minus_limb4_U_0_cos * minus_limb4_upper_rate_mz_2 + t351));
    RESULT(checked2, sized_, 65, -(per_length * minus_limb4_upper_rate_mz_2));
    const REAL t353 = limb4_U_0_sin * multipliers_12, t357 = t353 - t356;
    RESULT(checked3, reactions, 66, -t357);
    const REAL t360 = minus_limb4_U_0_cos * multipliers_12, limb4_S_reactions_fz = t360 + t363;
    WRITE(reactions, 68, limb4_S_reactions_fz);
    const REAL t364 = limb4_upper_position_y * limb4_S_reactions_fz, t368 = limb4_upper_position_y * t357;
    RESULT(checked0, reactions, 70, minus_limb4_upper_position_z * t357 + minus_limb4_upper_position_x * limb4_S_reactions_fz);
    const REAL limb4_S_reactions_fy = minus_limb4_lower_sin * multipliers_10 - limb4_lower_cos * multipliers_11;
    WRITE(reactions, 67, limb4_S_reactions_fy);
    RESULT(checked1, reactions, 69, t364 + minus_limb4_upper_position_z * limb4_S_reactions_fy);
    RESULT(checked2, reactions, 71, t368 - minus_limb4_upper_position_x * limb4_S_reactions_fy);
    /* platform: geometry; accelerations; momentum rate, eq. (35) */
    const REAL platform_turn_zx = t371 - t372, limb5_S_v_wx = READ(v, 12), limb5_S_v_wz = READ(v, 14),
      platform_turn_xz = t371 + t372, t373 = platform_m_gravity_z * platform_turn_zx,
      platform_rate_fx_2 = platform_mz * (READ(a, 13) + limb5_S_v_wx * limb5_S_v_wz) + t373,
      limb5_S_v_wy = READ(v, 13);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t374 = platform_turn_xx * platform_rate_fx_2, t398 = platform_turn_yx * platform_rate_fx_2,
      t416 = platform_turn_zx * platform_rate_fx_2, t375 = platform_m_gravity_z * platform_turn_zy,
      minus_platform_rate_fy_2 = platform_mz * (READ(a, 12) - limb5_S_v_wy * limb5_S_v_wz) - t375,
      t377 = t374 - platform_turn_xy * minus_platform_rate_fy_2,
      t400 = t398 - platform_turn_yy * minus_platform_rate_fy_2,
      t418 = t416 - platform_turn_zy * minus_platform_rate_fy_2, t382 = platform_m_gravity_z * platform_turn_zz,
      minus_platform_rate_fz_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t382,
      t385 = t377 - platform_turn_xz * minus_platform_rate_fz_2 + t92,
      t402 = t400 - platform_turn_yz * minus_platform_rate_fz_2,
      t420 = t418 - platform_turn_zz * minus_platform_rate_fz_2,
      t388 = limb2_lower_cos * multipliers_4 - limb2_lower_sin * multipliers_5,
      t392 = t385 + (t184 - minus_limb2_U_0_cos * t388) - limb3_S_reactions_fx, t425 = t192 + limb2_U_0_sin * t388,
      t395 = limb4_lower_cos * multipliers_10 + minus_limb4_lower_sin * multipliers_11,
      platform_joint_sent_fx = t392 + (t353 - minus_limb4_U_0_cos * t395);
    WRITE(reactions, 72, platform_joint_sent_fx);
    WRITE(sized_, 72, platform_joint_sent_fx);
    checked3 = checked3 + platform_joint_sent_fx;
    const REAL t431 = t360 + limb4_U_0_sin * t395,
      t405 = limb1_lower_cos * multipliers_0 - limb1_lower_sin * multipliers_1,
      t409 = t402 + (t93 - limb1_U_0_sin * t405) + t191, t426 = t420 + (t98 + limb1_U_0_cos * t405) - t425,
      t412 = limb3_lower_cos * multipliers_7 + minus_limb3_lower_sin * multipliers_8,
      platform_joint_sent_fy = t409 + (t270 - limb3_U_0_sin * t412) - limb4_S_reactions_fy;
    WRITE(reactions, 73, platform_joint_sent_fy);
    WRITE(sized_, 73, platform_joint_sent_fy);
    checked0 = checked0 + platform_joint_sent_fy;
    const REAL platform_joint_sent_fz = t426 + (t275 + limb3_U_0_cos * t412) - t431;
    WRITE(reactions, 74, platform_joint_sent_fz);
    WRITE(sized_, 74, platform_joint_sent_fz);
    checked1 = checked1 + platform_joint_sent_fz;
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
    NOT_BELOW(t28, 0.999999, 5);
    NOT_ABOVE(t28, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
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
    (void)three_ups_upu_s_forward_dynamics_dense(q, v, u, inertia, load, closure, curvature);
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
    if (rank < 0 || !isfinite(total)) {
        three_ups_upu_s_set_nan(a, 15);
        three_ups_upu_s_set_nan(reactions, 78);
        return isfinite(total) ? 1 : 2;
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
