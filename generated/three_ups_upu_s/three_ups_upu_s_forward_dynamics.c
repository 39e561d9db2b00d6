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
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t2 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t3 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t4 = t2 + t3;
    const REAL t5 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t6 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t7 = t5 + t6;
    const REAL t8 = t4 + t7;
    const REAL t10 = 4.0 - 2.0 * t8;
    const REAL t40 = t3 + t5;
    const REAL platform_turn_yy = 1.0 - t10 * (t3 + t6);
    const REAL platform_turn_zz = 1.0 - t10 * t40;
    const REAL platform_turn_xx = 1.0 - t7 * t10;
    const REAL t26 = limb5_S_q_qy * t10;
    const REAL t27 = limb5_S_q_qx * t26;
    const REAL t44 = limb5_S_q_qw * t26;
    const REAL t14 = limb5_S_q_qz * t10;
    const REAL t17 = limb5_S_q_qw * (limb5_S_q_qx * t10);
    const REAL t28 = limb5_S_q_qw * t14;
    const REAL platform_turn_yx = t27 + t28;
    const REAL platform_turn_xy = t27 - t28;
    const REAL limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13);
    const REAL t37 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx;
    const REAL t15 = limb5_S_q_qy * t14;
    const REAL t43 = limb5_S_q_qx * t14;
    const REAL platform_turn_yz = t15 - t17;
    const REAL platform_turn_zy = t15 + t17;
    const REAL limb5_S_v_wz = READ(v, 14);
    const REAL platform_twist_angular_y = t37 + limb5_S_v_wz * platform_turn_yz;
    /* limb3: geometry; free motion */
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL t286 = limb3_U_0_sin * platform_twist_angular_y;
    const REAL platform_turn_zx = t43 - t44;
    const REAL platform_turn_xz = t43 + t44;
    const REAL t47 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy; /* platform */
    const REAL platform_twist_angular_z = limb5_S_v_wz * platform_turn_zz + t47;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    /* limb3: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t288 = t286 - limb3_U_0_cos * platform_twist_angular_z;
    const REAL limb3_U_v_0 = READ(v, 6);
    const REAL t442 = limb3_U_v_0 * t288;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL limb3_U_v_1 = READ(v, 7), limb3_P_v = READ(v, 8);
    const REAL t455 = limb3_S_arm_x * t442;
    const REAL t451 = limb3_U_v_1 * limb3_P_v;
    const REAL t456 = t455 + t451;
    const REAL t277 = limb3_U_0_cos * platform_twist_angular_y + limb3_U_0_sin * platform_twist_angular_z;
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL t289 = limb3_U_v_1 * limb3_lower_cos;
    const REAL t460 = t456 - t277 * (limb3_P_v + param_R * t289);
    const REAL t290 = limb3_upper_offset_x * t289;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked0 = limb3_U_0_pivot;
    const REAL t146 = 1.0 / limb3_U_0_pivot;
    const REAL t391 = limb3_lower_cos * t146;
    const REAL t461 = t460 * t391;
    const REAL limb3_U_follows_1_by_limb3_S_0 = limb3_S_arm_x * t391;
    const REAL limb3_lower_composite_first_x = limb_lower_m * limb3_upper_offset_x;
    const REAL t147 = k7 - limb3_lower_composite_first_x;
    const REAL t268 = limb3_lower_composite_first_x - t147;
    const REAL t148 = limb3_upper_offset_x * t147;
    const REAL t452 = t451 * t268;
    const REAL limb3_U_mass_matrix_1_by_limb3_U_1 = k9 - t148;
    const REAL t149 = t148 - k8;
    const REAL t462 = limb3_U_mass_matrix_1_by_limb3_U_1 * t461;
    const REAL t393 = limb3_U_follows_1_by_limb3_S_0 * (limb3_U_mass_matrix_1_by_limb3_U_1 * limb3_U_follows_1_by_limb3_S_0);
    const REAL t150 = limb3_lower_cos * t149;
    const REAL t265 = minus_limb3_lower_sin * t150 + limb3_lower_cos * (minus_limb3_lower_sin * t149);
    const REAL limb3_U_mass_matrix_0_by_limb3_U_0 = k3 - limb3_lower_cos * t150;
    const REAL t449 = 0.5 * t265;
    const REAL minus_limb3_U_0_U_still_xx = limb3_U_v_0 * limb3_U_v_0;
    const REAL t453 = minus_limb3_U_0_U_still_xx * t449 + t452;
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL limb3_U_handed_force_1 = limb3_upper_offset_x * (limb_lower_m * (minus_limb3_lower_sin * limb3_U_0_acc_y)) + t453 - t462;
    const REAL t463 = limb3_U_follows_1_by_limb3_S_0 * limb3_U_handed_force_1;
    const REAL limb3_P_generalised_force = limb_lower_m * (limb3_lower_cos * limb3_U_0_acc_y) - READ(u, 2);
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL t443 = limb3_S_arm_y * t442;
    const REAL t280 = limb3_U_v_1 * minus_limb3_lower_sin;
    const REAL t446 = t443 - t277 * (param_R * t280);
    const REAL t278 = limb3_U_v_0 * t277;
    const REAL t281 = limb3_upper_offset_x * t280;
    const REAL t447 = limb_lower_m * t446;
    const REAL t270 = limb3_lower_cos * (limb3_lower_cos * t268);
    const REAL t440 = minus_limb3_U_0_U_still_xx * (0.5 * t270) + limb3_U_v_1 * limb3_U_v_1 * (0.5 * t268);
    const REAL minus_limb3_S_handed_force_0 = limb3_S_arm_y * (limb3_P_generalised_force - t440 + t447) - t463;
    const REAL t464 = limb3_U_0_sin * minus_limb3_S_handed_force_0;
    const REAL t491 = limb3_U_0_cos * minus_limb3_S_handed_force_0;
    const REAL platform_rate_moment_x = k12 * (limb5_S_v_wy * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zy;
    const REAL t432 = platform_turn_zx * platform_rate_moment_x; /* platform */
    const REAL minus_platform_rate_moment_y = k12 * (limb5_S_v_wx * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zx;
    /* limb2: geometry; free motion */
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL t465 = t432 - platform_turn_zy * minus_platform_rate_moment_y - t464; /* limb5_S */
    const REAL t250 = limb2_U_0_sin * platform_twist_angular_z;
    const REAL t69 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy; /* platform */
    const REAL platform_twist_angular_x = t69 + limb5_S_v_wz * platform_turn_xz;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    /* limb2: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t252 = t250 + minus_limb2_U_0_cos * platform_twist_angular_x;
    const REAL limb2_U_v_0 = READ(v, 3);
    const REAL t340 = limb2_U_v_0 * t252;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL limb2_U_v_1 = READ(v, 4), limb2_P_v = READ(v, 5);
    const REAL t353 = limb2_S_arm_x * t340;
    const REAL t349 = limb2_U_v_1 * limb2_P_v;
    const REAL t354 = t353 + t349;
    const REAL t241 = minus_limb2_U_0_cos * platform_twist_angular_z - limb2_U_0_sin * platform_twist_angular_x;
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL t253 = limb2_U_v_1 * limb2_lower_cos;
    const REAL t358 = t354 + t241 * (limb2_P_v - param_R * t253);
    const REAL t254 = limb2_upper_offset_x * t253;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = limb2_U_0_pivot;
    const REAL t156 = 1.0 / limb2_U_0_pivot;
    const REAL t167 = limb2_lower_cos * t156;
    const REAL t359 = t358 * t167;
    const REAL limb2_U_follows_1_by_limb2_S_0 = limb2_S_arm_x * t167;
    const REAL limb2_lower_composite_first_x = limb_lower_m * limb2_upper_offset_x;
    const REAL t157 = k7 - limb2_lower_composite_first_x;
    const REAL t232 = limb2_lower_composite_first_x - t157;
    const REAL t158 = limb2_upper_offset_x * t157;
    const REAL t350 = t349 * t232;
    const REAL limb2_U_mass_matrix_1_by_limb2_U_1 = k9 - t158;
    const REAL t159 = t158 - k8;
    const REAL t360 = limb2_U_mass_matrix_1_by_limb2_U_1 * t359;
    const REAL t169 = limb2_U_follows_1_by_limb2_S_0 * (limb2_U_mass_matrix_1_by_limb2_U_1 * limb2_U_follows_1_by_limb2_S_0);
    const REAL t160 = limb2_lower_cos * t159;
    const REAL t229 = limb2_lower_sin * t160 + limb2_lower_cos * (limb2_lower_sin * t159);
    const REAL limb2_U_mass_matrix_0_by_limb2_U_0 = k3 - limb2_lower_cos * t160;
    const REAL t347 = 0.5 * t229;
    const REAL minus_limb2_U_0_U_still_xx = limb2_U_v_0 * limb2_U_v_0;
    const REAL t351 = minus_limb2_U_0_U_still_xx * t347 - t350;
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL limb2_U_handed_force_1 = limb2_upper_offset_x * (limb_lower_m * (limb2_lower_sin * minus_limb2_U_0_acc_y)) - t351 - t360;
    const REAL t361 = limb2_U_follows_1_by_limb2_S_0 * limb2_U_handed_force_1;
    const REAL minus_limb2_P_generalised_force = limb_lower_m * (limb2_lower_cos * minus_limb2_U_0_acc_y) + READ(u, 1);
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL t341 = minus_limb2_S_arm_y * t340;
    const REAL t244 = limb2_U_v_1 * limb2_lower_sin;
    const REAL t344 = t341 - t241 * (param_R * t244);
    const REAL t242 = limb2_U_v_0 * t241;
    const REAL t245 = limb2_upper_offset_x * t244;
    const REAL t345 = limb_lower_m * t344;
    const REAL t234 = limb2_lower_cos * (limb2_lower_cos * t232);
    const REAL t338 = minus_limb2_U_0_U_still_xx * (0.5 * t234) + limb2_U_v_1 * limb2_U_v_1 * (0.5 * t232);
    const REAL minus_limb2_S_handed_force_0 = minus_limb2_S_arm_y * (minus_limb2_P_generalised_force + t338 + t345) - t361;
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL t466 = minus_limb2_U_0_cos * minus_limb2_S_handed_force_0 + t465; /* limb5_S */
    const REAL t362 = limb2_U_0_sin * minus_limb2_S_handed_force_0; /* limb2 */
    /* limb4: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t216 = limb4_U_0_sin * platform_twist_angular_z + minus_limb4_U_0_cos * platform_twist_angular_x;
    const REAL limb4_U_v_0 = READ(v, 9);
    const REAL t305 = limb4_U_v_0 * t216;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL limb4_U_v_1 = READ(v, 10), limb4_P_v = READ(v, 11);
    const REAL t318 = limb4_S_arm_x * t305;
    const REAL t314 = limb4_U_v_1 * limb4_P_v;
    const REAL t319 = t318 + t314;
    const REAL t205 = minus_limb4_U_0_cos * platform_twist_angular_z - limb4_U_0_sin * platform_twist_angular_x;
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL t217 = limb4_U_v_1 * limb4_lower_cos;
    const REAL t323 = t319 + t205 * (limb4_P_v + param_R * t217);
    const REAL t218 = limb4_upper_offset_x * t217;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked2 = limb4_U_0_pivot;
    const REAL t124 = 1.0 / limb4_U_0_pivot;
    const REAL t135 = limb4_lower_cos * t124;
    const REAL t324 = t323 * t135;
    const REAL limb4_U_follows_1_by_limb4_S_0 = limb4_S_arm_x * t135;
    const REAL limb4_lower_composite_first_x = limb_lower_m * limb4_upper_offset_x;
    const REAL t125 = k7 - limb4_lower_composite_first_x;
    const REAL t196 = limb4_lower_composite_first_x - t125;
    const REAL t126 = limb4_upper_offset_x * t125;
    const REAL t315 = t314 * t196;
    const REAL limb4_U_mass_matrix_1_by_limb4_U_1 = k9 - t126;
    const REAL t127 = t126 - k8;
    const REAL t325 = limb4_U_mass_matrix_1_by_limb4_U_1 * t324;
    const REAL t137 = limb4_U_follows_1_by_limb4_S_0 * (limb4_U_mass_matrix_1_by_limb4_U_1 * limb4_U_follows_1_by_limb4_S_0);
    const REAL t128 = limb4_lower_cos * t127;
    const REAL t193 = minus_limb4_lower_sin * t128 + limb4_lower_cos * (minus_limb4_lower_sin * t127);
    const REAL limb4_U_mass_matrix_0_by_limb4_U_0 = k3 - limb4_lower_cos * t128;
    const REAL t312 = 0.5 * t193;
    const REAL minus_limb4_U_0_U_still_xx = limb4_U_v_0 * limb4_U_v_0;
    const REAL t316 = minus_limb4_U_0_U_still_xx * t312 + t315;
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL t317 = limb4_upper_offset_x * (limb_lower_m * (minus_limb4_lower_sin * minus_limb4_U_0_acc_y)) - t316;
    const REAL t326 = limb4_U_follows_1_by_limb4_S_0 * (t317 + t325);
    const REAL minus_limb4_P_generalised_force = limb_lower_m * (limb4_lower_cos * minus_limb4_U_0_acc_y) + READ(u, 3);
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL t306 = limb4_S_arm_y * t305;
    const REAL t208 = limb4_U_v_1 * minus_limb4_lower_sin;
    const REAL t309 = t306 + t205 * (param_R * t208);
    const REAL t206 = limb4_U_v_0 * t205;
    const REAL t209 = limb4_upper_offset_x * t208;
    const REAL t310 = limb_lower_m * t309;
    const REAL t198 = limb4_lower_cos * (limb4_lower_cos * t196);
    const REAL t303 = minus_limb4_U_0_U_still_xx * (0.5 * t198) + limb4_U_v_1 * limb4_U_v_1 * (0.5 * t196);
    const REAL limb4_S_handed_force_0 = limb4_S_arm_y * (minus_limb4_P_generalised_force + t303 - t310) - t326;
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0);
    const REAL t467 = minus_limb4_U_0_cos * limb4_S_handed_force_0 - t466; /* limb5_S */
    const REAL t327 = limb4_U_0_sin * limb4_S_handed_force_0;
    const REAL t60 = limb1_U_0_sin * platform_twist_angular_y - limb1_U_0_cos * platform_twist_angular_z; /* limb5_S */
    const REAL limb1_U_v_0 = READ(v, 0);
    const REAL t48 = limb1_U_0_sin * platform_twist_angular_z; /* limb5_S */
    const REAL t104 = limb1_U_v_0 * t60; /* limb5_S */
    /* limb1: accelerations; free motion; inertia */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL limb1_U_v_1 = READ(v, 1), limb1_P_v = READ(v, 2);
    const REAL t105 = limb1_U2_arm_x * t104; /* limb5_S */
    const REAL t106 = limb1_U_v_1 * limb1_P_v;
    const REAL t107 = t105 + t106; /* limb5_S */
    const REAL t49 = limb1_U_0_cos * platform_twist_angular_y + t48; /* limb5_S */
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL t61 = limb1_U_v_1 * limb1_lower_cos;
    const REAL t111 = t107 - t49 * (limb1_P_v - param_R * t61); /* limb5_S */
    const REAL t62 = limb1_upper_offset_x * t61;
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked3 = limb1_U_0_pivot;
    const REAL t19 = 1.0 / limb1_U_0_pivot;
    const REAL t31 = limb1_lower_cos * t19;
    const REAL t426 = t111 * t31;
    const REAL limb1_lower_composite_first_x = limb_lower_m * limb1_upper_offset_x;
    const REAL t115 = k7 - limb1_lower_composite_first_x;
    const REAL t182 = limb1_lower_composite_first_x - t115;
    const REAL t116 = limb1_upper_offset_x * t115;
    const REAL t423 = t106 * t182;
    const REAL limb1_U_mass_matrix_1_by_limb1_U_1 = k9 - t116;
    const REAL t117 = t116 - k8;
    const REAL t427 = limb1_U_mass_matrix_1_by_limb1_U_1 * t426;
    const REAL t118 = limb1_lower_cos * t117;
    const REAL t179 = limb1_lower_sin * t118 + limb1_lower_cos * (limb1_lower_sin * t117);
    const REAL limb1_U_mass_matrix_0_by_limb1_U_0 = k3 - limb1_lower_cos * t118;
    const REAL t421 = 0.5 * t179;
    const REAL minus_limb1_U_0_U_still_xx = limb1_U_v_0 * limb1_U_v_0;
    const REAL t424 = minus_limb1_U_0_U_still_xx * t421 - t423;
    const REAL limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    /* limb1: free motion; rates that follow; accelerations */
    const REAL minus_limb1_U_handed_force_1 = limb1_upper_offset_x * (limb_lower_m * (limb1_lower_sin * limb1_U_0_acc_y)) + t424 + t427;
    const REAL limb1_P_generalised_force = limb_lower_m * (limb1_lower_cos * limb1_U_0_acc_y) - READ(u, 0);
    const REAL limb1_U_follows_1_by_limb1_U2_0 = limb1_U2_arm_x * t31;
    const REAL t428 = limb1_U_follows_1_by_limb1_U2_0 * minus_limb1_U_handed_force_1;
    const REAL t375 = limb1_U_follows_1_by_limb1_U2_0 * (limb1_U_mass_matrix_1_by_limb1_U_1 * limb1_U_follows_1_by_limb1_U2_0);
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL t415 = minus_limb1_U2_arm_y * t104;
    const REAL t52 = limb1_U_v_1 * limb1_lower_sin;
    const REAL t418 = t415 + t49 * (param_R * t52);
    const REAL t53 = limb1_upper_offset_x * t52;
    const REAL t419 = limb_lower_m * t418;
    const REAL t184 = limb1_lower_cos * (limb1_lower_cos * t182);
    const REAL t413 = minus_limb1_U_0_U_still_xx * (0.5 * t184) + limb1_U_v_1 * limb1_U_v_1 * (0.5 * t182);
    const REAL limb1_U2_handed_force_0 = minus_limb1_U2_arm_y * (limb1_P_generalised_force - t413 - t419) - t428;
    const REAL t468 = limb1_U_0_sin * limb1_U2_handed_force_0 - t467; /* limb5_S */
    const REAL t487 = limb1_U_0_cos * limb1_U2_handed_force_0;
    /* limb3: geometry */
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    /* limb3: free motion; rates that follow */
    const REAL t279 = limb3_upper_position_x * t278;
    const REAL minus_limb3_U_follows_0_by_limb3_S_1 = limb3_upper_position_x * t146;
    const REAL t283 = t281 + limb3_P_v * limb3_lower_cos;
    const REAL t294 = platform_twist_angular_x * t283;
    const REAL t293 = t279 - limb3_U_v_0 * t283 - t288 * (limb3_P_v * minus_limb3_lower_sin - t290);
    const REAL t296 = t146 * (t293 + t294);
    const REAL t297 = limb3_U_mass_matrix_0_by_limb3_U_0 * t296;
    const REAL t273 = t265 * (limb3_U_v_0 * limb3_U_v_1) - t270 * (limb3_U_v_0 * limb3_P_v);
    const REAL minus_limb3_U_handed_force_0 = limb3_lower_cos * (limb3_upper_offset_x * (limb_lower_m_gravity_z * limb3_U_0_sin)) + t273 - t297;
    const REAL limb3_S_handed_force_1 = minus_limb3_U_follows_0_by_limb3_S_1 * minus_limb3_U_handed_force_0;
    const REAL t469 = limb3_U_0_cos * limb3_S_handed_force_1 + t468; /* limb5_S */
    const REAL t486 = limb3_U_0_sin * limb3_S_handed_force_1;
    /* limb2: geometry */
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    /* limb2: free motion; rates that follow */
    const REAL t243 = minus_limb2_upper_position_y * t242;
    const REAL limb2_U_follows_0_by_limb2_S_1 = minus_limb2_upper_position_y * t156;
    const REAL t247 = t245 - limb2_P_v * limb2_lower_cos;
    const REAL t258 = platform_twist_angular_y * t247;
    const REAL t257 = t243 + limb2_U_v_0 * t247 + t252 * (limb2_P_v * limb2_lower_sin + t254);
    const REAL t260 = t156 * (t257 - t258);
    const REAL t261 = limb2_U_mass_matrix_0_by_limb2_U_0 * t260;
    const REAL t237 = t229 * (limb2_U_v_0 * limb2_U_v_1) + t234 * (limb2_U_v_0 * limb2_P_v);
    const REAL t238 = limb2_lower_cos * (limb2_upper_offset_x * (limb_lower_m_gravity_z * minus_limb2_U_0_cos)) + t237;
    const REAL limb2_U_handed_force_0 = t238 + t261;
    const REAL limb2_S_handed_force_1 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_handed_force_0;
    const REAL t470 = limb2_U_0_sin * limb2_S_handed_force_1 - t469; /* limb5_S */
    const REAL t262 = minus_limb2_U_0_cos * limb2_S_handed_force_1;
    /* limb4: geometry */
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    /* limb4: free motion; rates that follow */
    const REAL t207 = limb4_upper_position_y * t206;
    const REAL minus_limb4_U_follows_0_by_limb4_S_1 = limb4_upper_position_y * t124;
    const REAL t211 = t209 + limb4_P_v * limb4_lower_cos;
    const REAL t222 = platform_twist_angular_y * t211;
    const REAL t221 = t207 + limb4_U_v_0 * t211 + t216 * (limb4_P_v * minus_limb4_lower_sin - t218);
    const REAL t224 = t124 * (t221 - t222);
    const REAL t225 = limb4_U_mass_matrix_0_by_limb4_U_0 * t224;
    const REAL t201 = t193 * (limb4_U_v_0 * limb4_U_v_1) - t198 * (limb4_U_v_0 * limb4_P_v);
    const REAL t202 = limb4_lower_cos * (limb4_upper_offset_x * (limb_lower_m_gravity_z * minus_limb4_U_0_cos)) - t201;
    const REAL limb4_U_handed_force_0 = t202 - t225;
    const REAL minus_limb4_S_handed_force_1 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_handed_force_0;
    const REAL t471 = limb4_U_0_sin * minus_limb4_S_handed_force_1 - t470; /* limb5_S */
    const REAL t226 = minus_limb4_U_0_cos * minus_limb4_S_handed_force_1;
    const REAL t50 = limb1_U_v_0 * t49; /* limb5_S */
    /* limb1: loop closure; free motion; rates that follow */
    const REAL t74 = limb1_U_v_1 - t49;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t51 = minus_limb1_upper_position_x * t50; /* limb5_S */
    const REAL t55 = t53 - limb1_P_v * limb1_lower_cos;
    const REAL t71 = platform_twist_angular_x * t55; /* limb5_S */
    const REAL t65 = t51 - limb1_U_v_0 * t55 - t60 * (limb1_P_v * limb1_lower_sin + t62); /* limb5_S */
    const REAL t72 = t65 + t71; /* limb5_S */
    const REAL t189 = t19 * t72;
    const REAL t190 = limb1_U_mass_matrix_0_by_limb1_U_0 * t189;
    const REAL t187 = t179 * (limb1_U_v_0 * limb1_U_v_1) + t184 * (limb1_U_v_0 * limb1_P_v);
    const REAL minus_limb1_U_handed_force_0 = limb1_lower_cos * (limb1_upper_offset_x * (limb_lower_m_gravity_z * limb1_U_0_sin)) - t187 + t190;
    const REAL limb1_U_follows_0_by_limb1_U2_1 = minus_limb1_upper_position_x * t19;
    const REAL minus_limb1_U2_handed_force_1 = limb1_U_follows_0_by_limb1_U2_1 * minus_limb1_U_handed_force_0;
    const REAL t472 = limb1_U_0_cos * minus_limb1_U2_handed_force_1 - t471; /* limb5_S */
    const REAL t485 = limb1_U_0_sin * minus_limb1_U2_handed_force_1;
    const REAL t78 = limb1_lower_sin * t60 + limb1_lower_cos * platform_twist_angular_x;
    const REAL t87 = limb1_lower_cos * t60 - limb1_lower_sin * platform_twist_angular_x;
    const REAL limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    const REAL t79 = limb1_lower_omega_y - t78;
    const REAL t82 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t74 - limb1_U_v_1 * t79);
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL t83 = limb1_U2_constraint_mn_couple_x * t82;
    const REAL limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    const REAL t88 = limb1_lower_omega_x + t87;
    const REAL t90 = limb1_lower_omega_x * t79 - limb1_lower_omega_y * t88;
    const REAL t24 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy;
    const REAL t93 = limb1_lower_sin * t24;
    const REAL limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t24 - limb1_lower_sin * platform_turn_xy;
    const REAL t92 = t83 - limb1_U2_constraint_mn_couple_z * t90;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t31;
    const REAL t112 = t111 * limb1_U_factor_1_by_3; /* limb5_S */
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL t96 = limb1_U2_constraint_mn_couple_z * t79;
    const REAL t99 = limb1_U2_constraint_mn_couple_x * t79;
    const REAL limb1_U2_opening_mn = t93 + limb1_lower_cos * platform_turn_xy;
    const REAL t98 = t88 * (limb1_U2_opening_mn * t88 + t96);
    const REAL t113 = t92 - (t98 - t74 * (t99 - limb1_U2_opening_mn * t74)) - t112; /* limb5_S */
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t19;
    const REAL t114 = minus_limb1_U_factor_0_by_3 * t72 - t113; /* limb5_S */
    const REAL t20 = minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3;
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t20;
    const REAL t370 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    checked0 = checked0 + minus_limb5_S_pivot_wz;
    const REAL t34 = 1.0 / minus_limb5_S_pivot_wz; /* limb5_S */
    const REAL minus_limb5_S_joint_acc_still_wz = t34 * t114;
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t34 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t370);
    /* limb3: free motion */
    const REAL t152 = minus_limb3_U_follows_0_by_limb3_S_1 * limb3_U_mass_matrix_0_by_limb3_U_0;
    const REAL t395 = minus_limb3_U_follows_0_by_limb3_S_1 * t152;
    const REAL t394 = limb3_S_arm_y * (k20 * limb3_lower_cos) + t393;
    const REAL t397 = limb3_U_0_cos * (t395 - t394);
    const REAL t398 = limb3_U_0_cos * t397;
    const REAL t399 = t394 + t398;
    const REAL t512 = t395 - t398;
    const REAL t479 = limb3_U_0_sin * t397;
    const REAL t142 = k12 * platform_turn_zz; /* platform */
    const REAL t400 = k13 + platform_turn_zz * t142 + t399; /* limb5_S */
    const REAL t143 = platform_turn_xz * t142; /* platform */
    const REAL t162 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_mass_matrix_0_by_limb2_U_0; /* limb2 */
    const REAL t163 = limb2_U_follows_0_by_limb2_S_1 * t162; /* limb2 */
    const REAL t170 = minus_limb2_S_arm_y * (k20 * limb2_lower_cos) + t169; /* limb2 */
    const REAL t172 = limb2_U_0_sin * (t163 - t170); /* limb2 */
    const REAL t384 = limb2_U_0_sin * t172; /* limb2 */
    const REAL t401 = t170 + t384 + t400; /* limb5_S */
    const REAL t530 = t163 - t384; /* limb2 */
    const REAL t173 = minus_limb2_U_0_cos * t172; /* limb2 */
    const REAL t130 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_mass_matrix_0_by_limb4_U_0; /* limb4 */
    const REAL t131 = minus_limb4_U_follows_0_by_limb4_S_1 * t130; /* limb4 */
    const REAL t138 = limb4_S_arm_y * (k20 * limb4_lower_cos) + t137; /* limb4 */
    const REAL t140 = limb4_U_0_sin * (t131 - t138); /* limb4 */
    const REAL t382 = limb4_U_0_sin * t140; /* limb4 */
    const REAL t402 = t138 + t382 + t401; /* limb5_S */
    const REAL t525 = t131 - t382; /* limb4 */
    const REAL t141 = minus_limb4_U_0_cos * t140; /* limb4 */
    const REAL t120 = limb1_U_follows_0_by_limb1_U2_1 * limb1_U_mass_matrix_0_by_limb1_U_0; /* limb1 */
    const REAL t377 = limb1_U_follows_0_by_limb1_U2_1 * t120; /* limb1 */
    const REAL t376 = minus_limb1_U2_arm_y * (k20 * limb1_lower_cos) + t375; /* limb1 */
    const REAL t379 = limb1_U_0_cos * (t377 - t376); /* limb1 */
    const REAL t380 = limb1_U_0_cos * t379; /* limb1 */
    /* limb5_S: free motion; accelerations */
    const REAL limb5_S_handed_inertia_wz = t376 + t380 + t402;
    const REAL t509 = t377 - t380; /* limb1 */
    const REAL t474 = limb1_U_0_sin * t379; /* limb1 */
    const REAL t473 = limb5_S_null_space_wz_by_limb5_S_wy * (minus_limb5_S_joint_acc_still_wz * limb5_S_handed_inertia_wz + t472);
    const REAL t517 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz;
    const REAL t329 = platform_turn_xx * platform_rate_moment_x;
    const REAL t492 = platform_turn_yx * platform_rate_moment_x - platform_turn_yy * minus_platform_rate_moment_y - t491;
    const REAL t497 = t485 + (limb4_U_handed_force_0 + (limb2_U_handed_force_0 - (t486 - (t487 + t492))));
    const REAL t365 = minus_limb3_U_handed_force_0 - (t327 + (t329 - platform_turn_xy * minus_platform_rate_moment_y - t362));
    const REAL t368 = minus_limb1_U_handed_force_0 - (t226 - (t262 + t365));
    const REAL t477 = k12 * platform_turn_yz;
    const REAL t502 = minus_limb2_U_0_cos * t162; /* limb2 */
    const REAL t482 = limb4_U_0_sin * t130 - (limb2_U_0_sin * t162 - (platform_turn_zz * t477 - t479));
    const REAL t483 = t474 - t482;
    const REAL t519 = t483 + (t483 - t517);
    const REAL limb5_S_reduced_force_wy = t473 - (minus_limb5_S_joint_acc_still_wz * t483 + t497);
    const REAL t520 = limb5_S_null_space_wz_by_limb5_S_wy * t519;
    const REAL t504 = minus_limb4_U_0_cos * t130; /* limb4 */
    const REAL t515 = limb4_U_mass_matrix_0_by_limb4_U_0 + (limb2_U_mass_matrix_0_by_limb2_U_0 + (k13 + platform_turn_yz * t477 + t512));
    const REAL limb5_S_reduced_inertia_wy_by_limb5_S_wy = t509 + t515 - t520;
    checked1 = checked1 + limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t521 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t505 = platform_turn_xz * t477 + limb3_U_0_sin * t152 - t502 + t504;
    const REAL limb5_S_handed_inertia_wz_by_limb5_S_wx = limb1_U_0_cos * t120 + (t141 + (t143 - limb3_U_0_cos * t152 + t173));
    const REAL t507 = t505 - limb1_U_0_sin * t120;
    const REAL limb5_S_reduced_inertia_wx_by_limb5_S_wy = t507 + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz_by_limb5_S_wx;
    const REAL limb5_S_reduced_force_wx = minus_limb5_S_joint_acc_still_wz * limb5_S_handed_inertia_wz_by_limb5_S_wx + t368;
    /* platform: accelerations; pivots; free motion */
    const REAL t522 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t521;
    const REAL t533 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t522;
    const REAL t535 = limb5_S_reduced_force_wy * t521;
    const REAL t524 = limb5_S_reduced_force_wx - limb5_S_reduced_force_wy * t522;
    const REAL t531 = limb3_U_mass_matrix_0_by_limb3_U_0 + (k13 + platform_turn_xz * (k12 * platform_turn_xz)) + t530;
    const REAL pivot_1 = limb1_U_mass_matrix_0_by_limb1_U_0 + (t525 + t531) - t533;
    checked2 = checked2 + pivot_1;
    const REAL limb5_S_joint_acc_wx = t524 / pivot_1;
    const REAL minus_limb5_S_joint_acc_wy = t522 * limb5_S_joint_acc_wx - t535;
    const REAL minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy * minus_limb5_S_joint_acc_wy;
    const REAL t585 = platform_turn_zz * minus_limb5_S_joint_acc_wz;
    const REAL minus_platform_alpha_z = t585 + (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz * limb5_S_joint_acc_wx);
    RESULT(checked3, a, 14, -minus_platform_alpha_z);
    const REAL t581 = platform_turn_zy * minus_limb5_S_joint_acc_wz;
    const REAL minus_platform_alpha_y = t581 + (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy * limb5_S_joint_acc_wx);
    RESULT(checked0, a, 13, -minus_platform_alpha_y);
    const REAL t577 = platform_turn_zx * minus_limb5_S_joint_acc_wz;
    const REAL minus_platform_alpha_x = t577 + (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx * limb5_S_joint_acc_wx);
    RESULT(checked1, a, 12, -minus_platform_alpha_x);
    const REAL t574 = minus_limb4_U_0_cos * minus_limb5_S_joint_acc_wz + limb4_U_0_sin * limb5_S_joint_acc_wx; /* limb4 */
    RESULT(checked2, a, 11, t309 - limb4_S_arm_y * t574);
    RESULT(checked3, a, 10, limb4_U_follows_1_by_limb4_S_0 * t574 - t324);
    const REAL t570 = minus_limb4_U_follows_0_by_limb4_S_1 * (limb4_U_0_sin * minus_limb5_S_joint_acc_wz - minus_limb4_U_0_cos * limb5_S_joint_acc_wx); /* limb4 */
    RESULT(checked0, a, 9, -(minus_limb5_S_joint_acc_wy + (t224 + t570)));
    const REAL t564 = limb3_U_0_sin * minus_limb5_S_joint_acc_wz + limb3_U_0_cos * minus_limb5_S_joint_acc_wy; /* limb3 */
    RESULT(checked1, a, 8, t446 + limb3_S_arm_y * t564);
    RESULT(checked2, a, 7, -(t461 + limb3_U_follows_1_by_limb3_S_0 * t564));
    const REAL t560 = minus_limb3_U_follows_0_by_limb3_S_1 * (limb3_U_0_cos * minus_limb5_S_joint_acc_wz - limb3_U_0_sin * minus_limb5_S_joint_acc_wy); /* limb3 */
    RESULT(checked3, a, 6, limb5_S_joint_acc_wx + (t296 + t560));
    const REAL t554 = minus_limb2_U_0_cos * minus_limb5_S_joint_acc_wz + limb2_U_0_sin * limb5_S_joint_acc_wx; /* limb2 */
    RESULT(checked0, a, 5, minus_limb2_S_arm_y * t554 - t344);
    RESULT(checked1, a, 4, limb2_U_follows_1_by_limb2_S_0 * t554 - t359);
    const REAL t550 = limb2_U_follows_0_by_limb2_S_1 * (limb2_U_0_sin * minus_limb5_S_joint_acc_wz - minus_limb2_U_0_cos * limb5_S_joint_acc_wx); /* limb2 */
    RESULT(checked2, a, 3, t260 + t550 - minus_limb5_S_joint_acc_wy);
    const REAL t537 = limb1_U_0_cos * minus_limb5_S_joint_acc_wz; /* limb1 */
    const REAL t544 = limb1_U_0_sin * minus_limb5_S_joint_acc_wz + limb1_U_0_cos * minus_limb5_S_joint_acc_wy; /* limb1 */
    RESULT(checked3, a, 2, -(t418 + minus_limb1_U2_arm_y * t544));
    RESULT(checked0, a, 1, -(t426 + limb1_U_follows_1_by_limb1_U2_0 * t544));
    RESULT(checked1, a, 0, limb5_S_joint_acc_wx - (t189 + limb1_U_follows_0_by_limb1_U2_1 * (t537 - limb1_U_0_sin * minus_limb5_S_joint_acc_wy)));
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-06) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-06) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-06) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-06) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
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
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t2 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t3 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t4 = t2 + t3;
    const REAL t5 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t6 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t7 = t5 + t6;
    const REAL t8 = t4 + t7;
    const REAL t11 = t3 + t6;
    const REAL t82 = t3 + t5;
    const REAL t10 = 4.0 - 2.0 * t8;
    const REAL platform_turn_yy = 1.0 - t10 * t11;
    const REAL t39 = k2 - 0.5 * t8;
    const REAL platform_turn_xx = 1.0 - t7 * t10;
    const REAL platform_turn_zz = 1.0 - t10 * t82;
    const REAL t14 = limb5_S_q_qz * t10;
    const REAL t15 = limb5_S_q_qy * t14;
    const REAL t17 = limb5_S_q_qw * (limb5_S_q_qx * t10);
    const REAL t26 = limb5_S_q_qy * t10;
    const REAL platform_turn_zy = t15 + t17;
    const REAL platform_turn_yz = t15 - t17;
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0);
    const REAL t24 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy; /* limb1 */
    const REAL limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1);
    const REAL t25 = limb1_lower_cos * t24; /* limb1 */
    const REAL t155 = limb1_lower_sin * t24; /* limb1 */
    const REAL t27 = limb5_S_q_qx * t26;
    const REAL t92 = limb5_S_q_qw * t26;
    const REAL t28 = limb5_S_q_qw * t14;
    const REAL t91 = limb5_S_q_qx * t14;
    const REAL platform_turn_xy = t27 - t28;
    const REAL platform_turn_yx = t27 + t28;
    /* limb1: reciprocal wrenches, eq. (10); geometry */
    const REAL limb1_U2_constraint_mn_couple_z = t25 - limb1_lower_sin * platform_turn_xy;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = limb1_U_0_pivot;
    /* limb1: rates that follow; reciprocal wrenches, eq. (10); pivots */
    const REAL t19 = 1.0 / limb1_U_0_pivot;
    const REAL t31 = limb1_lower_cos * t19;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t31;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL t33 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    const REAL t36 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t19;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t20 = minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3;
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t20;
    /* limb5_S: pivots; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t33;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL t34 = 1.0 / minus_limb5_S_pivot_wz;
    const REAL t37 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t36; /* limb1 */
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t34 * t37;
    /* limb5_S: velocities, eq. (6); accelerations; geometry */
    const REAL t41 = limb5_S_q_qx * t39;
    const REAL t42 = t41 * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL t40 = limb5_S_q_qw * t39;
    const REAL a_pivot = 0.5 * (t40 + t42);
    REAL checked2 = a_pivot;
    const REAL t44 = 1.0 / a_pivot;
    const REAL t47 = limb5_S_q_qy * t39;
    const REAL t45 = limb5_S_q_qz * t39;
    const REAL t51 = t44 * (0.5 * (t45 - t47 * limb5_S_null_space_wz_by_limb5_S_wy));
    const REAL limb5_S_y_dot_qy = READ(y_dot, 1);
    const REAL t53 = READ(y_dot, 0) - limb5_S_y_dot_qy * t51;
    const REAL t46 = 0.5 * t45;
    const REAL a_pivot_2 = 0.5 * t40 + t46 * t51;
    REAL checked3 = a_pivot_2;
    const REAL limb5_S_joint_rate_wx = t53 / a_pivot_2;
    const REAL limb5_S_joint_rate_wy = t44 * (limb5_S_y_dot_qy + t46 * limb5_S_joint_rate_wx);
    const REAL limb5_S_joint_rate_wz = t34 * (t37 * limb5_S_joint_rate_wy);
    const REAL t98 = platform_turn_zy * limb5_S_joint_rate_wz;
    const REAL platform_omega_y = t98 + (platform_turn_yy * limb5_S_joint_rate_wy + platform_turn_xy * limb5_S_joint_rate_wx);
    const REAL t117 = platform_turn_zy * platform_omega_y;
    const REAL platform_turn_zx = t91 - t92;
    const REAL platform_turn_xz = t91 + t92;
    const REAL t104 = platform_turn_zx * limb5_S_joint_rate_wz;
    const REAL platform_omega_x = t104 + (platform_turn_yx * limb5_S_joint_rate_wy + platform_turn_xx * limb5_S_joint_rate_wx);
    const REAL t119 = t117 + platform_turn_zx * platform_omega_x;
    const REAL t93 = platform_turn_zz * limb5_S_joint_rate_wz;
    const REAL platform_omega_z = t93 + (platform_turn_yz * limb5_S_joint_rate_wy + platform_turn_xz * limb5_S_joint_rate_wx);
    const REAL t120 = platform_turn_zz * platform_omega_z + t119;
    /* limb3: geometry; free motion; velocities, eq. (6) */
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    const REAL t429 = limb3_U_0_cos * t120;
    const REAL t125 = platform_turn_yy * platform_omega_y + platform_turn_yx * platform_omega_x; /* platform */
    const REAL t126 = platform_turn_yz * platform_omega_z + t125; /* platform */
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL t431 = t429 - limb3_U_0_sin * t126;
    const REAL t435 = limb3_U_0_cos * limb5_S_joint_rate_wz - limb3_U_0_sin * limb5_S_joint_rate_wy;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL t436 = limb3_upper_position_x * t435;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    checked0 = checked0 + limb3_U_0_pivot;
    const REAL t190 = 1.0 / limb3_U_0_pivot;
    const REAL limb3_U_joint_rate_0 = limb5_S_joint_rate_wx - t190 * t436;
    const REAL t565 = limb3_U_joint_rate_0 * t431;
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t566 = limb3_S_arm_x * t565;
    const REAL t419 = limb3_U_0_sin * limb5_S_joint_rate_wz + limb3_U_0_cos * limb5_S_joint_rate_wy;
    const REAL limb3_upper_vel_y = limb3_S_arm_x * t419;
    const REAL t274 = limb3_lower_cos * t190;
    const REAL limb3_U_joint_rate_1 = limb3_upper_vel_y * t274;
    const REAL limb3_U_follows_1_by_limb3_S_0 = limb3_S_arm_x * t274;
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL minus_limb3_P_joint_rate = limb3_S_arm_y * t419;
    /* limb3: free motion; inertia; accelerations */
    const REAL t579 = limb3_S_arm_y * t565;
    const REAL t564 = minus_limb3_P_joint_rate * limb3_U_joint_rate_1;
    const REAL t567 = t564 + t566;
    const REAL t441 = limb3_U_0_sin * t120 + limb3_U_0_cos * t126;
    const REAL t426 = limb3_lower_cos * limb3_U_joint_rate_1;
    const REAL t569 = t274 * (t441 * (minus_limb3_P_joint_rate - param_R * t426) - t567);
    const REAL t427 = limb3_upper_offset_x * t426;
    const REAL limb3_lower_composite_first_x = limb_lower_m * limb3_upper_offset_x;
    const REAL t191 = k7 - limb3_lower_composite_first_x;
    const REAL t449 = limb3_lower_composite_first_x - t191;
    const REAL t192 = limb3_upper_offset_x * t191;
    const REAL t571 = t449 * t564;
    const REAL limb3_U_mass_matrix_1_by_limb3_U_1 = k9 - t192;
    const REAL t570 = limb3_U_mass_matrix_1_by_limb3_U_1 * t569;
    const REAL t193 = t192 - k8;
    const REAL t276 = limb3_U_follows_1_by_limb3_S_0 * (limb3_U_mass_matrix_1_by_limb3_U_1 * limb3_U_follows_1_by_limb3_S_0);
    const REAL minus_limb3_U_0_U_still_xx = limb3_U_joint_rate_0 * limb3_U_joint_rate_0;
    const REAL t194 = limb3_lower_cos * t193;
    const REAL t456 = minus_limb3_lower_sin * t194 + limb3_lower_cos * (minus_limb3_lower_sin * t193);
    const REAL limb3_U_mass_matrix_0_by_limb3_U_0 = k3 - limb3_lower_cos * t194;
    const REAL t574 = t571 - 0.5 * t456 * minus_limb3_U_0_U_still_xx;
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL minus_limb3_U_handed_force_1 = t570 - (limb3_upper_offset_x * (limb_lower_m * (minus_limb3_lower_sin * limb3_U_0_acc_y)) - t574);
    const REAL t576 = limb3_U_follows_1_by_limb3_S_0 * minus_limb3_U_handed_force_1;
    const REAL limb3_P_generalised_force = limb_lower_m * (limb3_lower_cos * limb3_U_0_acc_y) - READ(u, 2);
    const REAL t421 = minus_limb3_lower_sin * limb3_U_joint_rate_1;
    const REAL t581 = limb_lower_m * (t441 * (param_R * t421) + t579);
    const REAL t443 = limb3_upper_position_x * (limb3_U_joint_rate_0 * t441);
    const REAL t422 = limb3_upper_offset_x * t421;
    const REAL minus_limb3_U_follows_0_by_limb3_S_1 = limb3_upper_position_x * t190;
    const REAL t451 = limb3_lower_cos * (limb3_lower_cos * t449);
    const REAL t586 = 0.5 * t451 * minus_limb3_U_0_U_still_xx;
    const REAL t588 = limb3_P_generalised_force - (0.5 * t449 * (limb3_U_joint_rate_1 * limb3_U_joint_rate_1) + t586);
    const REAL minus_limb3_S_handed_force_0 = t576 - limb3_S_arm_y * (t581 - t588);
    const REAL t458 = t456 * (limb3_U_joint_rate_1 * limb3_U_joint_rate_0);
    const REAL t590 = limb3_U_0_sin * minus_limb3_S_handed_force_0;
    const REAL t607 = limb3_U_0_cos * minus_limb3_S_handed_force_0;
    const REAL t108 = platform_turn_xx * platform_omega_x; /* platform */
    const REAL platform_rate_moment_y = gravity_z_platform_mz * platform_turn_zx - k12 * (platform_omega_z * platform_omega_x);
    const REAL t591 = platform_turn_zy * platform_rate_moment_y; /* platform */
    const REAL t523 = k12 * (platform_omega_z * platform_omega_y); /* platform */
    const REAL t110 = platform_turn_xz * platform_omega_z + (platform_turn_xy * platform_omega_y + t108); /* platform */
    const REAL minus_platform_rate_moment_x = gravity_z_platform_mz * platform_turn_zy - t523;
    /* limb2: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2);
    const REAL t594 = t590 - (t591 - platform_turn_zx * minus_platform_rate_moment_x); /* limb5_S */
    const REAL t386 = minus_limb2_U_0_cos * t110 + limb2_U_0_sin * t120;
    const REAL t390 = limb2_U_0_sin * limb5_S_joint_rate_wz + minus_limb2_U_0_cos * limb5_S_joint_rate_wx;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL t391 = minus_limb2_upper_position_y * t390;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    checked1 = checked1 + limb2_U_0_pivot;
    const REAL t200 = 1.0 / limb2_U_0_pivot;
    const REAL limb2_U_joint_rate_0 = limb5_S_joint_rate_wy - t200 * t391;
    const REAL t495 = limb2_U_joint_rate_0 * t386;
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t496 = limb2_S_arm_x * t495;
    const REAL t374 = minus_limb2_U_0_cos * limb5_S_joint_rate_wz - limb2_U_0_sin * limb5_S_joint_rate_wx;
    const REAL minus_limb2_upper_vel_y = limb2_S_arm_x * t374;
    const REAL t248 = limb2_lower_cos * t200;
    const REAL minus_limb2_U_joint_rate_1 = minus_limb2_upper_vel_y * t248;
    const REAL limb2_U_follows_1_by_limb2_S_0 = limb2_S_arm_x * t248;
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL minus_limb2_P_joint_rate = minus_limb2_S_arm_y * t374;
    /* limb2: free motion; inertia; accelerations */
    const REAL t509 = minus_limb2_S_arm_y * t495;
    const REAL t494 = minus_limb2_P_joint_rate * minus_limb2_U_joint_rate_1;
    const REAL t497 = t494 + t496;
    const REAL t396 = limb2_U_0_sin * t110 - minus_limb2_U_0_cos * t120;
    const REAL t381 = limb2_lower_cos * minus_limb2_U_joint_rate_1;
    const REAL t499 = t248 * (t396 * (minus_limb2_P_joint_rate - param_R * t381) + t497);
    const REAL t382 = limb2_upper_offset_x * t381;
    const REAL limb2_lower_composite_first_x = limb_lower_m * limb2_upper_offset_x;
    const REAL t201 = k7 - limb2_lower_composite_first_x;
    const REAL t404 = limb2_lower_composite_first_x - t201;
    const REAL t202 = limb2_upper_offset_x * t201;
    const REAL t501 = t404 * t494;
    const REAL limb2_U_mass_matrix_1_by_limb2_U_1 = k9 - t202;
    const REAL t500 = limb2_U_mass_matrix_1_by_limb2_U_1 * t499;
    const REAL t203 = t202 - k8;
    const REAL t250 = limb2_U_follows_1_by_limb2_S_0 * (limb2_U_mass_matrix_1_by_limb2_U_1 * limb2_U_follows_1_by_limb2_S_0);
    const REAL minus_limb2_U_0_U_still_xx = limb2_U_joint_rate_0 * limb2_U_joint_rate_0;
    const REAL t204 = limb2_lower_cos * t203;
    const REAL t411 = limb2_lower_sin * t204 + limb2_lower_cos * (limb2_lower_sin * t203);
    const REAL limb2_U_mass_matrix_0_by_limb2_U_0 = k3 - limb2_lower_cos * t204;
    const REAL t504 = t501 - 0.5 * t411 * minus_limb2_U_0_U_still_xx;
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL minus_limb2_U_handed_force_1 = t500 - (limb2_upper_offset_x * (limb_lower_m * (limb2_lower_sin * minus_limb2_U_0_acc_y)) + t504);
    const REAL t506 = limb2_U_follows_1_by_limb2_S_0 * minus_limb2_U_handed_force_1;
    const REAL minus_limb2_P_generalised_force = limb_lower_m * (limb2_lower_cos * minus_limb2_U_0_acc_y) + READ(u, 1);
    const REAL t376 = limb2_lower_sin * minus_limb2_U_joint_rate_1;
    const REAL t511 = limb_lower_m * (t396 * (param_R * t376) - t509);
    const REAL t398 = minus_limb2_upper_position_y * (limb2_U_joint_rate_0 * t396);
    const REAL t377 = limb2_upper_offset_x * t376;
    const REAL limb2_U_follows_0_by_limb2_S_1 = minus_limb2_upper_position_y * t200;
    const REAL t406 = limb2_lower_cos * (limb2_lower_cos * t404);
    const REAL t516 = 0.5 * t406 * minus_limb2_U_0_U_still_xx;
    const REAL t518 = minus_limb2_P_generalised_force + (0.5 * t404 * (minus_limb2_U_joint_rate_1 * minus_limb2_U_joint_rate_1) + t516);
    const REAL minus_limb2_S_handed_force_0 = t506 - minus_limb2_S_arm_y * (t511 - t518);
    /* limb4: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6);
    const REAL t413 = t411 * (minus_limb2_U_joint_rate_1 * limb2_U_joint_rate_0); /* limb2 */
    const REAL t595 = minus_limb2_U_0_cos * minus_limb2_S_handed_force_0 - t594; /* limb5_S */
    const REAL t520 = limb2_U_0_sin * minus_limb2_S_handed_force_0; /* limb2 */
    const REAL t341 = minus_limb4_U_0_cos * t110 + limb4_U_0_sin * t120;
    const REAL t345 = limb4_U_0_sin * limb5_S_joint_rate_wz + minus_limb4_U_0_cos * limb5_S_joint_rate_wx;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL t346 = limb4_upper_position_y * t345;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    checked2 = checked2 + limb4_U_0_pivot;
    const REAL t211 = 1.0 / limb4_U_0_pivot;
    const REAL limb4_U_joint_rate_0 = limb5_S_joint_rate_wy + t211 * t346;
    const REAL t465 = limb4_U_joint_rate_0 * t341;
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t466 = limb4_S_arm_x * t465;
    const REAL t329 = minus_limb4_U_0_cos * limb5_S_joint_rate_wz - limb4_U_0_sin * limb5_S_joint_rate_wx;
    const REAL minus_limb4_upper_vel_y = limb4_S_arm_x * t329;
    const REAL t233 = limb4_lower_cos * t211;
    const REAL minus_limb4_U_joint_rate_1 = minus_limb4_upper_vel_y * t233;
    const REAL limb4_U_follows_1_by_limb4_S_0 = limb4_S_arm_x * t233;
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL limb4_P_joint_rate = limb4_S_arm_y * t329;
    /* limb4: free motion; inertia; accelerations */
    const REAL t479 = limb4_S_arm_y * t465;
    const REAL t464 = limb4_P_joint_rate * minus_limb4_U_joint_rate_1;
    const REAL t467 = t464 - t466;
    const REAL t351 = limb4_U_0_sin * t110 - minus_limb4_U_0_cos * t120;
    const REAL t336 = limb4_lower_cos * minus_limb4_U_joint_rate_1;
    const REAL t469 = t233 * (t351 * (limb4_P_joint_rate - param_R * t336) + t467);
    const REAL t337 = limb4_upper_offset_x * t336;
    const REAL limb4_lower_composite_first_x = limb_lower_m * limb4_upper_offset_x;
    const REAL t212 = k7 - limb4_lower_composite_first_x;
    const REAL t359 = limb4_lower_composite_first_x - t212;
    const REAL t213 = limb4_upper_offset_x * t212;
    const REAL t471 = t359 * t464;
    const REAL limb4_U_mass_matrix_1_by_limb4_U_1 = k9 - t213;
    const REAL t470 = limb4_U_mass_matrix_1_by_limb4_U_1 * t469;
    const REAL t214 = t213 - k8;
    const REAL t235 = limb4_U_follows_1_by_limb4_S_0 * (limb4_U_mass_matrix_1_by_limb4_U_1 * limb4_U_follows_1_by_limb4_S_0);
    const REAL minus_limb4_U_0_U_still_xx = limb4_U_joint_rate_0 * limb4_U_joint_rate_0;
    const REAL t215 = limb4_lower_cos * t214;
    const REAL t366 = minus_limb4_lower_sin * t215 + limb4_lower_cos * (minus_limb4_lower_sin * t214);
    const REAL limb4_U_mass_matrix_0_by_limb4_U_0 = k3 - limb4_lower_cos * t215;
    const REAL t474 = t471 - 0.5 * t366 * minus_limb4_U_0_U_still_xx;
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL t475 = limb4_upper_offset_x * (limb_lower_m * (minus_limb4_lower_sin * minus_limb4_U_0_acc_y)) + t474;
    const REAL t476 = limb4_U_follows_1_by_limb4_S_0 * (t470 - t475);
    const REAL minus_limb4_P_generalised_force = limb_lower_m * (limb4_lower_cos * minus_limb4_U_0_acc_y) + READ(u, 3);
    const REAL t331 = minus_limb4_lower_sin * minus_limb4_U_joint_rate_1;
    const REAL t481 = limb_lower_m * (t351 * (param_R * t331) + t479);
    const REAL t353 = limb4_upper_position_y * (limb4_U_joint_rate_0 * t351);
    const REAL t332 = limb4_upper_offset_x * t331;
    const REAL minus_limb4_U_follows_0_by_limb4_S_1 = limb4_upper_position_y * t211;
    const REAL t361 = limb4_lower_cos * (limb4_lower_cos * t359);
    const REAL t486 = 0.5 * t361 * minus_limb4_U_0_U_still_xx;
    const REAL t488 = minus_limb4_P_generalised_force + (0.5 * t359 * (minus_limb4_U_joint_rate_1 * minus_limb4_U_joint_rate_1) + t486);
    const REAL limb4_S_handed_force_0 = t476 - limb4_S_arm_y * (t481 - t488);
    const REAL t368 = t366 * (minus_limb4_U_joint_rate_1 * limb4_U_joint_rate_0);
    const REAL t596 = minus_limb4_U_0_cos * limb4_S_handed_force_0 - t595; /* limb5_S */
    const REAL t490 = limb4_U_0_sin * limb4_S_handed_force_0;
    const REAL t136 = limb1_U_0_sin * t120; /* limb5_S */
    const REAL t128 = limb1_U_0_cos * t120 - limb1_U_0_sin * t126; /* limb5_S */
    /* limb1: velocities, eq. (6); free motion; inertia */
    const REAL t133 = minus_limb1_upper_position_x * (limb1_U_0_cos * limb5_S_joint_rate_wz - limb1_U_0_sin * limb5_S_joint_rate_wy);
    const REAL limb1_U_joint_rate_0 = limb5_S_joint_rate_wx + t19 * t133;
    const REAL t149 = limb1_U_joint_rate_0 * t128; /* limb5_S */
    const REAL t150 = limb1_U2_arm_x * t149; /* limb5_S */
    const REAL t86 = limb1_U_0_sin * limb5_S_joint_rate_wz + limb1_U_0_cos * limb5_S_joint_rate_wy;
    const REAL limb1_U_joint_rate_1 = t31 * (limb1_U2_arm_x * t86);
    const REAL limb1_U_follows_1_by_limb1_U2_0 = limb1_U2_arm_x * t31;
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL limb1_P_joint_rate = minus_limb1_U2_arm_y * t86;
    const REAL t547 = minus_limb1_U2_arm_y * t149;
    const REAL t148 = limb1_P_joint_rate * limb1_U_joint_rate_1;
    const REAL t151 = t148 - t150; /* limb5_S */
    const REAL t138 = t136 + limb1_U_0_cos * t126; /* limb5_S */
    const REAL t113 = limb1_lower_cos * limb1_U_joint_rate_1;
    const REAL t152 = t138 * (limb1_P_joint_rate - param_R * t113) - t151; /* limb5_S */
    const REAL t537 = t31 * t152;
    const REAL t153 = limb1_U_factor_1_by_3 * t152; /* limb5_S */
    const REAL t114 = limb1_upper_offset_x * t113;
    const REAL limb1_lower_composite_first_x = limb_lower_m * limb1_upper_offset_x;
    const REAL t220 = k7 - limb1_lower_composite_first_x;
    const REAL t315 = limb1_lower_composite_first_x - t220;
    const REAL t221 = limb1_upper_offset_x * t220;
    const REAL t539 = t315 * t148;
    const REAL limb1_U_mass_matrix_1_by_limb1_U_1 = k9 - t221;
    const REAL t538 = limb1_U_mass_matrix_1_by_limb1_U_1 * t537;
    const REAL t222 = t221 - k8;
    const REAL t262 = limb1_U_follows_1_by_limb1_U2_0 * (limb1_U_mass_matrix_1_by_limb1_U_1 * limb1_U_follows_1_by_limb1_U2_0);
    const REAL minus_limb1_U_0_U_still_xx = limb1_U_joint_rate_0 * limb1_U_joint_rate_0;
    const REAL t223 = limb1_lower_cos * t222;
    /* limb1: free motion; inertia; accelerations */
    const REAL t322 = limb1_lower_sin * t223 + limb1_lower_cos * (limb1_lower_sin * t222);
    const REAL limb1_U_mass_matrix_0_by_limb1_U_0 = k3 - limb1_lower_cos * t223;
    const REAL t542 = t539 - 0.5 * t322 * minus_limb1_U_0_U_still_xx;
    const REAL limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    const REAL t544 = limb1_U_follows_1_by_limb1_U2_0 * (t538 - (limb1_upper_offset_x * (limb_lower_m * (limb1_lower_sin * limb1_U_0_acc_y)) - t542));
    const REAL limb1_P_generalised_force = limb_lower_m * (limb1_lower_cos * limb1_U_0_acc_y) - READ(u, 0);
    const REAL t88 = limb1_lower_sin * limb1_U_joint_rate_1;
    const REAL t549 = limb_lower_m * (t138 * (param_R * t88) - t547);
    const REAL t89 = limb1_upper_offset_x * t88;
    const REAL t317 = limb1_lower_cos * (limb1_lower_cos * t315);
    const REAL t554 = 0.5 * t317 * minus_limb1_U_0_U_still_xx;
    const REAL t556 = limb1_P_generalised_force - (0.5 * t315 * (limb1_U_joint_rate_1 * limb1_U_joint_rate_1) + t554);
    const REAL limb1_U2_handed_force_0 = t544 - minus_limb1_U2_arm_y * (t549 - t556);
    const REAL t597 = limb1_U_0_sin * limb1_U2_handed_force_0 - t596; /* limb5_S */
    const REAL t606 = limb1_U_0_cos * limb1_U2_handed_force_0;
    /* limb3: free motion */
    const REAL t423 = limb3_lower_cos * minus_limb3_P_joint_rate - t422;
    const REAL t444 = limb3_U_joint_rate_0 * t423 + t443;
    const REAL t459 = t451 * (minus_limb3_P_joint_rate * limb3_U_joint_rate_0) + t458;
    const REAL t446 = t110 * t423 + ((minus_limb3_lower_sin * minus_limb3_P_joint_rate + t427) * t431 - t444);
    const REAL t448 = limb3_U_mass_matrix_0_by_limb3_U_0 * (t190 * t446);
    const REAL minus_limb3_U_handed_force_0 = t448 + (limb3_lower_cos * (limb3_upper_offset_x * (limb_lower_m_gravity_z * limb3_U_0_sin)) + t459);
    const REAL limb3_S_handed_force_1 = minus_limb3_U_follows_0_by_limb3_S_1 * minus_limb3_U_handed_force_0;
    const REAL t598 = limb3_U_0_cos * limb3_S_handed_force_1 + t597; /* limb5_S */
    const REAL t605 = limb3_U_0_sin * limb3_S_handed_force_1;
    /* limb2: free motion */
    const REAL t378 = limb2_lower_cos * minus_limb2_P_joint_rate - t377;
    const REAL t379 = t126 * t378;
    const REAL t414 = t406 * (minus_limb2_P_joint_rate * limb2_U_joint_rate_0) + t413;
    const REAL t400 = (limb2_lower_sin * minus_limb2_P_joint_rate + t382) * t386 - (limb2_U_joint_rate_0 * t378 - t398);
    const REAL t403 = limb2_U_mass_matrix_0_by_limb2_U_0 * (t200 * (t379 + t400));
    const REAL t415 = limb2_lower_cos * (limb2_upper_offset_x * (limb_lower_m_gravity_z * minus_limb2_U_0_cos)) - t414;
    const REAL minus_limb2_U_handed_force_0 = t403 - t415;
    const REAL minus_limb2_S_handed_force_1 = limb2_U_follows_0_by_limb2_S_1 * minus_limb2_U_handed_force_0;
    const REAL t599 = limb2_U_0_sin * minus_limb2_S_handed_force_1 + t598; /* limb5_S */
    const REAL t416 = minus_limb2_U_0_cos * minus_limb2_S_handed_force_1;
    /* limb4: free motion */
    const REAL t333 = limb4_lower_cos * limb4_P_joint_rate - t332;
    const REAL t334 = t126 * t333;
    const REAL t369 = t361 * (limb4_P_joint_rate * limb4_U_joint_rate_0) + t368;
    const REAL t355 = (minus_limb4_lower_sin * limb4_P_joint_rate + t337) * t341 + (limb4_U_joint_rate_0 * t333 - t353);
    const REAL t358 = limb4_U_mass_matrix_0_by_limb4_U_0 * (t211 * (t334 - t355));
    const REAL t370 = limb4_lower_cos * (limb4_upper_offset_x * (limb_lower_m_gravity_z * minus_limb4_U_0_cos)) + t369;
    const REAL limb4_U_handed_force_0 = t358 + t370;
    const REAL minus_limb4_S_handed_force_1 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_handed_force_0;
    const REAL t600 = limb4_U_0_sin * minus_limb4_S_handed_force_1 + t599; /* limb5_S */
    const REAL t371 = minus_limb4_U_0_cos * minus_limb4_S_handed_force_1;
    const REAL t140 = minus_limb1_upper_position_x * (limb1_U_joint_rate_0 * t138); /* limb5_S */
    /* limb1: rates that follow; loop closure; free motion */
    const REAL limb1_U_follows_0_by_limb1_U2_1 = minus_limb1_upper_position_x * t19;
    const REAL t154 = limb1_U_joint_rate_1 - t138;
    const REAL t90 = limb1_lower_cos * limb1_P_joint_rate - t89;
    const REAL t111 = t90 * t110; /* limb5_S */
    const REAL t142 = (limb1_lower_sin * limb1_P_joint_rate + t114) * t128 + (limb1_U_joint_rate_0 * t90 + t140); /* limb5_S */
    const REAL t143 = t111 - t142; /* limb5_S */
    const REAL t144 = minus_limb1_U_factor_0_by_3 * t143; /* limb5_S */
    const REAL t314 = limb1_U_mass_matrix_0_by_limb1_U_0 * (t19 * t143);
    const REAL t319 = t317 * (limb1_P_joint_rate * limb1_U_joint_rate_0);
    const REAL t325 = t319 + t322 * (limb1_U_joint_rate_1 * limb1_U_joint_rate_0);
    const REAL limb1_U_handed_force_0 = t314 - (limb1_lower_cos * (limb1_upper_offset_x * (limb_lower_m_gravity_z * limb1_U_0_sin)) - t325);
    const REAL limb1_U2_handed_force_1 = limb1_U_follows_0_by_limb1_U2_1 * limb1_U_handed_force_0;
    const REAL t601 = limb1_U_0_cos * limb1_U2_handed_force_1 + t600; /* limb5_S */
    const REAL t604 = limb1_U_0_sin * limb1_U2_handed_force_1;
    /* limb1: loop closure; velocities, eq. (6); accelerations */
    const REAL t160 = limb1_lower_cos * t110 - limb1_lower_sin * t128;
    const REAL t167 = limb1_lower_sin * t110 + limb1_lower_cos * t128;
    const REAL limb1_lower_omega_y = limb1_lower_cos * limb1_U_joint_rate_0;
    const REAL t161 = t160 - limb1_lower_omega_y;
    const REAL limb1_lower_omega_x = limb1_lower_sin * limb1_U_joint_rate_0;
    const REAL t168 = t167 - limb1_lower_omega_x;
    const REAL t175 = t161 * limb1_lower_omega_x;
    const REAL limb1_lower_alpha_still_x = limb1_U_joint_rate_1 * limb1_lower_omega_y;
    const REAL t182 = limb1_U2_constraint_mn_couple_x * (limb1_U_joint_rate_1 * t161 + t154 * limb1_lower_omega_y - limb1_lower_alpha_still_x);
    const REAL t183 = limb1_U2_constraint_mn_couple_z * (limb1_lower_omega_y * t168 - t175) + t182;
    const REAL t162 = limb1_U2_constraint_mn_couple_x * t161;
    const REAL t169 = limb1_U2_constraint_mn_couple_z * t161;
    const REAL limb1_U2_opening_mn = t155 + limb1_lower_cos * platform_turn_xy;
    const REAL t164 = t154 * (limb1_U2_opening_mn * t154 + t162);
    const REAL t184 = t153 - (t164 + t168 * (t169 + limb1_U2_opening_mn * t168) + t183); /* limb5_S */
    const REAL limb5_S_joint_acc_still_wz = t34 * (t144 + t184);
    /* limb3: free motion */
    const REAL t196 = minus_limb3_U_follows_0_by_limb3_S_1 * limb3_U_mass_matrix_0_by_limb3_U_0;
    const REAL t270 = minus_limb3_U_follows_0_by_limb3_S_1 * t196;
    const REAL t277 = limb3_S_arm_y * (k20 * limb3_lower_cos) + t276;
    const REAL t279 = limb3_U_0_cos * (t270 - t277);
    const REAL t280 = limb3_U_0_cos * t279;
    const REAL t302 = t277 + t280;
    const REAL t281 = t270 - t280;
    const REAL t290 = limb3_U_0_sin * t279;
    const REAL t240 = k12 * platform_turn_zz; /* platform */
    const REAL t303 = k13 + platform_turn_zz * t240 + t302; /* limb5_S */
    const REAL t241 = platform_turn_xz * t240; /* platform */
    const REAL t206 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_mass_matrix_0_by_limb2_U_0; /* limb2 */
    const REAL t244 = limb2_U_follows_0_by_limb2_S_1 * t206; /* limb2 */
    const REAL t251 = minus_limb2_S_arm_y * (k20 * limb2_lower_cos) + t250; /* limb2 */
    const REAL t253 = limb2_U_0_sin * (t244 - t251); /* limb2 */
    const REAL t298 = limb2_U_0_sin * t253; /* limb2 */
    const REAL t304 = t251 + t298 + t303; /* limb5_S */
    const REAL t625 = t244 - t298; /* limb2 */
    const REAL t254 = minus_limb2_U_0_cos * t253; /* limb2 */
    const REAL t217 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_mass_matrix_0_by_limb4_U_0; /* limb4 */
    const REAL t229 = minus_limb4_U_follows_0_by_limb4_S_1 * t217; /* limb4 */
    const REAL t236 = limb4_S_arm_y * (k20 * limb4_lower_cos) + t235; /* limb4 */
    const REAL t238 = limb4_U_0_sin * (t229 - t236); /* limb4 */
    const REAL t296 = limb4_U_0_sin * t238; /* limb4 */
    const REAL t305 = t236 + t296 + t304; /* limb5_S */
    const REAL t620 = t229 - t296; /* limb4 */
    const REAL t239 = minus_limb4_U_0_cos * t238; /* limb4 */
    const REAL t225 = limb1_U_follows_0_by_limb1_U2_1 * limb1_U_mass_matrix_0_by_limb1_U_0; /* limb1 */
    const REAL t258 = limb1_U_follows_0_by_limb1_U2_1 * t225; /* limb1 */
    const REAL t263 = minus_limb1_U2_arm_y * (k20 * limb1_lower_cos) + t262; /* limb1 */
    const REAL t265 = limb1_U_0_cos * (t258 - t263); /* limb1 */
    const REAL t266 = limb1_U_0_cos * t265; /* limb1 */
    /* limb5_S: free motion; accelerations; pivots */
    const REAL limb5_S_handed_inertia_wz = t263 + t266 + t305;
    const REAL t267 = t258 - t266; /* limb1 */
    const REAL t286 = limb1_U_0_sin * t265; /* limb1 */
    const REAL t602 = limb5_S_null_space_wz_by_limb5_S_wy * (limb5_S_joint_acc_still_wz * limb5_S_handed_inertia_wz + t601);
    const REAL t306 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz;
    const REAL t522 = platform_turn_xy * platform_rate_moment_y;
    const REAL t611 = t607 - (platform_turn_yy * platform_rate_moment_y - platform_turn_yx * minus_platform_rate_moment_x);
    const REAL t616 = t604 - (limb4_U_handed_force_0 - (minus_limb2_U_handed_force_0 + (t605 - (t606 - t611))));
    const REAL t528 = minus_limb3_U_handed_force_0 - (t490 - (t520 - (t522 - platform_turn_xx * minus_platform_rate_moment_x)));
    const REAL t531 = limb1_U_handed_force_0 + (t371 + (t416 - t528));
    const REAL t186 = k12 * platform_turn_yz;
    const REAL t207 = minus_limb2_U_0_cos * t206; /* limb2 */
    const REAL t293 = limb4_U_0_sin * t217 - (limb2_U_0_sin * t206 - (platform_turn_zz * t186 - t290));
    const REAL t294 = t286 - t293;
    const REAL t308 = t294 + (t294 - t306);
    const REAL minus_limb5_S_reduced_force_wy = t602 - (limb5_S_joint_acc_still_wz * t294 + t616);
    const REAL t309 = limb5_S_null_space_wz_by_limb5_S_wy * t308;
    const REAL t218 = minus_limb4_U_0_cos * t217; /* limb4 */
    const REAL t284 = limb4_U_mass_matrix_0_by_limb4_U_0 + (limb2_U_mass_matrix_0_by_limb2_U_0 + (k13 + platform_turn_yz * t186 + t281));
    const REAL limb5_S_reduced_inertia_wy_by_limb5_S_wy = t267 + t284 - t309;
    checked3 = checked3 + limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t310 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t219 = platform_turn_xz * t186 + limb3_U_0_sin * t196 - t207 + t218;
    const REAL limb5_S_handed_inertia_wz_by_limb5_S_wx = limb1_U_0_cos * t225 + (t239 + (t241 - limb3_U_0_cos * t196 + t254));
    const REAL t227 = t219 - limb1_U_0_sin * t225;
    const REAL limb5_S_reduced_inertia_wx_by_limb5_S_wy = t227 + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz_by_limb5_S_wx;
    const REAL minus_limb5_S_reduced_force_wx = limb5_S_joint_acc_still_wz * limb5_S_handed_inertia_wz_by_limb5_S_wx + t531;
    const REAL t311 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t310;
    const REAL t628 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t311;
    const REAL t630 = t310 * minus_limb5_S_reduced_force_wy;
    const REAL t619 = minus_limb5_S_reduced_force_wx - t311 * minus_limb5_S_reduced_force_wy;
    const REAL t626 = limb3_U_mass_matrix_0_by_limb3_U_0 + (k13 + platform_turn_xz * (k12 * platform_turn_xz)) + t625;
    const REAL pivot_1 = limb1_U_mass_matrix_0_by_limb1_U_0 + (t620 + t626) - t628;
    checked0 = checked0 + pivot_1;
    const REAL minus_limb5_S_joint_acc_wx = t619 / pivot_1;
    const REAL limb5_S_joint_acc_wy = t311 * minus_limb5_S_joint_acc_wx - t630;
    const REAL limb5_S_joint_acc_wz = limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_joint_acc_wy;
    /* limb5_S: results */
    const REAL t638 = platform_turn_zy * limb5_S_joint_acc_wz;
    const REAL t642 = t638 + (platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx);
    const REAL t661 = platform_turn_xy * t642;
    const REAL t643 = platform_turn_zy * t642;
    const REAL t654 = platform_turn_yy * t642;
    const REAL t644 = platform_turn_zx * limb5_S_joint_acc_wz;
    const REAL t632 = platform_turn_zz * limb5_S_joint_acc_wz;
    const REAL t633 = platform_turn_yz * limb5_S_joint_acc_wy;
    const REAL t648 = t644 + (platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx);
    const REAL t663 = t661 + platform_turn_xx * t648;
    const REAL t636 = t632 + (t633 - platform_turn_xz * minus_limb5_S_joint_acc_wx);
    const REAL t664 = platform_turn_xz * t636 + t663;
    const REAL t656 = t654 + platform_turn_yx * t648;
    const REAL t651 = platform_turn_zz * t636 + (t643 + platform_turn_zx * t648);
    const REAL t657 = platform_turn_yz * t636 + t656;
    const REAL t683 = t45 * t664 - t41 * t651 - t40 * t657;
    const REAL t666 = t47 * t651 - t45 * t657 - t40 * t664;
    const REAL t674 = 0.5 * (t47 * limb5_S_joint_rate_wz - t45 * limb5_S_joint_rate_wy - t40 * limb5_S_joint_rate_wx);
    const REAL t675 = limb5_S_joint_rate_wz * t674;
    const REAL t62 = t40 * limb5_S_joint_rate_wy;
    const REAL t71 = 0.5 * (t41 * limb5_S_joint_rate_wy - t47 * limb5_S_joint_rate_wx - t40 * limb5_S_joint_rate_wz);
    const REAL t676 = limb5_S_joint_rate_wx * t71 - t675;
    const REAL t72 = limb5_S_joint_rate_wy * t71;
    const REAL t59 = t45 * limb5_S_joint_rate_wx;
    const REAL t79 = 0.5 * (t45 * limb5_S_joint_rate_wz + (t47 * limb5_S_joint_rate_wy + t41 * limb5_S_joint_rate_wx));
    RESULT(checked1, y_ddot, 1, 0.5 * (t676 - limb5_S_joint_rate_wy * t79 - t683));
    const REAL t80 = limb5_S_joint_rate_wx * t79;
    const REAL t73 = limb5_S_joint_rate_wz * (0.5 * (t59 - t41 * limb5_S_joint_rate_wz - t62)) - t72;
    RESULT(checked2, y_ddot, 0, 0.5 * (t73 - t80 - t666));
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
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
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t2 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t3 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t4 = t2 + t3;
    const REAL t5 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t6 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t7 = t5 + t6;
    const REAL t8 = t4 + t7;
    const REAL t10 = 4.0 - 2.0 * t8;
    const REAL t40 = t3 + t5;
    const REAL platform_turn_yy = 1.0 - t10 * (t3 + t6);
    const REAL platform_turn_zz = 1.0 - t10 * t40;
    const REAL platform_turn_xx = 1.0 - t7 * t10;
    const REAL t26 = limb5_S_q_qy * t10;
    const REAL t27 = limb5_S_q_qx * t26;
    const REAL t44 = limb5_S_q_qw * t26;
    const REAL t14 = limb5_S_q_qz * t10;
    const REAL t17 = limb5_S_q_qw * (limb5_S_q_qx * t10);
    const REAL t28 = limb5_S_q_qw * t14;
    const REAL platform_turn_yx = t27 + t28;
    const REAL platform_turn_xy = t27 - t28;
    const REAL limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13);
    const REAL t37 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx;
    const REAL t15 = limb5_S_q_qy * t14;
    const REAL t43 = limb5_S_q_qx * t14;
    const REAL platform_turn_yz = t15 - t17;
    const REAL platform_turn_zy = t15 + t17;
    const REAL limb5_S_v_wz = READ(v, 14);
    const REAL platform_twist_angular_y = t37 + limb5_S_v_wz * platform_turn_yz;
    /* limb3: geometry; free motion */
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL t286 = limb3_U_0_sin * platform_twist_angular_y;
    const REAL platform_turn_zx = t43 - t44;
    const REAL platform_turn_xz = t43 + t44;
    const REAL t47 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy; /* platform */
    const REAL platform_twist_angular_z = limb5_S_v_wz * platform_turn_zz + t47;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    /* limb3: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t288 = t286 - limb3_U_0_cos * platform_twist_angular_z;
    const REAL limb3_U_v_0 = READ(v, 6);
    const REAL t442 = limb3_U_v_0 * t288;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL limb3_U_v_1 = READ(v, 7), limb3_P_v = READ(v, 8);
    const REAL t455 = limb3_S_arm_x * t442;
    const REAL t451 = limb3_U_v_1 * limb3_P_v;
    const REAL t456 = t455 + t451;
    const REAL t277 = limb3_U_0_cos * platform_twist_angular_y + limb3_U_0_sin * platform_twist_angular_z;
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL t289 = limb3_U_v_1 * limb3_lower_cos;
    const REAL t460 = t456 - t277 * (limb3_P_v + param_R * t289);
    const REAL t290 = limb3_upper_offset_x * t289;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked0 = limb3_U_0_pivot;
    const REAL t146 = 1.0 / limb3_U_0_pivot;
    const REAL t391 = limb3_lower_cos * t146;
    const REAL t461 = t460 * t391;
    const REAL limb3_lower_composite_first_x = limb_lower_m * limb3_upper_offset_x;
    const REAL t147 = k7 - limb3_lower_composite_first_x;
    const REAL t268 = limb3_lower_composite_first_x - t147;
    const REAL t148 = limb3_upper_offset_x * t147;
    const REAL t452 = t451 * t268;
    const REAL limb3_U_mass_matrix_1_by_limb3_U_1 = k9 - t148;
    const REAL t149 = t148 - k8;
    const REAL t462 = limb3_U_mass_matrix_1_by_limb3_U_1 * t461;
    const REAL t150 = limb3_lower_cos * t149;
    const REAL t265 = minus_limb3_lower_sin * t150 + limb3_lower_cos * (minus_limb3_lower_sin * t149);
    const REAL limb3_U_mass_matrix_0_by_limb3_U_0 = k3 - limb3_lower_cos * t150;
    const REAL t449 = 0.5 * t265;
    const REAL minus_limb3_U_0_U_still_xx = limb3_U_v_0 * limb3_U_v_0;
    const REAL t453 = minus_limb3_U_0_U_still_xx * t449 + t452;
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y;
    const REAL limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y;
    const REAL limb3_upper_force_y = limb_lower_m * limb3_lower_acc_y;
    const REAL limb3_U_handed_force_1 = limb3_upper_offset_x * limb3_upper_force_y + t453 - t462;
    const REAL limb3_U_follows_1_by_limb3_S_0 = limb3_S_arm_x * t391;
    const REAL t463 = limb3_U_follows_1_by_limb3_S_0 * limb3_U_handed_force_1;
    const REAL t393 = limb3_U_follows_1_by_limb3_S_0 * (limb3_U_mass_matrix_1_by_limb3_U_1 * limb3_U_follows_1_by_limb3_S_0);
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL t443 = limb3_S_arm_y * t442;
    const REAL t280 = limb3_U_v_1 * minus_limb3_lower_sin;
    const REAL t446 = t443 - t277 * (param_R * t280);
    const REAL t278 = limb3_U_v_0 * t277;
    const REAL t281 = limb3_upper_offset_x * t280;
    const REAL t447 = limb_lower_m * t446;
    const REAL t270 = limb3_lower_cos * (limb3_lower_cos * t268);
    const REAL t438 = 0.5 * t268;
    const REAL t436 = minus_limb3_U_0_U_still_xx * (0.5 * t270);
    const REAL t437 = limb3_U_v_1 * limb3_U_v_1;
    const REAL t440 = t436 + t437 * t438;
    const REAL limb3_upper_force_x = limb_lower_m * limb3_lower_acc_x;
    const REAL limb3_P_u = READ(u, 2);
    const REAL minus_limb3_S_handed_force_0 = limb3_S_arm_y * (limb3_upper_force_x - limb3_P_u - t440 + t447) - t463;
    const REAL t464 = limb3_U_0_sin * minus_limb3_S_handed_force_0;
    const REAL t491 = limb3_U_0_cos * minus_limb3_S_handed_force_0;
    /* platform: balance, eqs. (40)-(47); accelerations; momentum rate, eq. (35) */
    const REAL minus_platform_force_moment_x = gravity_z_platform_mz * platform_turn_zy;
    const REAL platform_U_still_yz = limb5_S_v_wy * limb5_S_v_wz;
    const REAL t328 = k12 * platform_U_still_yz;
    const REAL platform_rate_moment_x = t328 - minus_platform_force_moment_x;
    const REAL t432 = platform_turn_zx * platform_rate_moment_x;
    const REAL platform_force_moment_y = gravity_z_platform_mz * platform_turn_zx;
    const REAL platform_U_still_xz = limb5_S_v_wx * limb5_S_v_wz;
    const REAL t330 = k12 * platform_U_still_xz;
    const REAL minus_platform_rate_moment_y = t330 - platform_force_moment_y;
    /* limb2: geometry; free motion */
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL t465 = t432 - platform_turn_zy * minus_platform_rate_moment_y - t464; /* limb5_S */
    const REAL t250 = limb2_U_0_sin * platform_twist_angular_z;
    const REAL t69 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy; /* platform */
    const REAL platform_twist_angular_x = t69 + limb5_S_v_wz * platform_turn_xz;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    /* limb2: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t252 = t250 + minus_limb2_U_0_cos * platform_twist_angular_x;
    const REAL limb2_U_v_0 = READ(v, 3);
    const REAL t340 = limb2_U_v_0 * t252;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL limb2_U_v_1 = READ(v, 4), limb2_P_v = READ(v, 5);
    const REAL t353 = limb2_S_arm_x * t340;
    const REAL t349 = limb2_U_v_1 * limb2_P_v;
    const REAL t354 = t353 + t349;
    const REAL t241 = minus_limb2_U_0_cos * platform_twist_angular_z - limb2_U_0_sin * platform_twist_angular_x;
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL t253 = limb2_U_v_1 * limb2_lower_cos;
    const REAL t358 = t354 + t241 * (limb2_P_v - param_R * t253);
    const REAL t254 = limb2_upper_offset_x * t253;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    REAL checked1 = limb2_U_0_pivot;
    const REAL t156 = 1.0 / limb2_U_0_pivot;
    const REAL t167 = limb2_lower_cos * t156;
    const REAL t359 = t358 * t167;
    const REAL limb2_lower_composite_first_x = limb_lower_m * limb2_upper_offset_x;
    const REAL t157 = k7 - limb2_lower_composite_first_x;
    const REAL t232 = limb2_lower_composite_first_x - t157;
    const REAL t158 = limb2_upper_offset_x * t157;
    const REAL t350 = t349 * t232;
    const REAL limb2_U_mass_matrix_1_by_limb2_U_1 = k9 - t158;
    const REAL t159 = t158 - k8;
    const REAL t360 = limb2_U_mass_matrix_1_by_limb2_U_1 * t359;
    const REAL t160 = limb2_lower_cos * t159;
    const REAL t229 = limb2_lower_sin * t160 + limb2_lower_cos * (limb2_lower_sin * t159);
    const REAL limb2_U_mass_matrix_0_by_limb2_U_0 = k3 - limb2_lower_cos * t160;
    const REAL t347 = 0.5 * t229;
    const REAL minus_limb2_U_0_U_still_xx = limb2_U_v_0 * limb2_U_v_0;
    const REAL t351 = minus_limb2_U_0_U_still_xx * t347 - t350;
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y;
    const REAL minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y;
    const REAL limb2_upper_force_y = limb_lower_m * limb2_lower_acc_y;
    const REAL limb2_U_handed_force_1 = limb2_upper_offset_x * limb2_upper_force_y - t351 - t360;
    const REAL limb2_U_follows_1_by_limb2_S_0 = limb2_S_arm_x * t167;
    const REAL t361 = limb2_U_follows_1_by_limb2_S_0 * limb2_U_handed_force_1;
    const REAL t169 = limb2_U_follows_1_by_limb2_S_0 * (limb2_U_mass_matrix_1_by_limb2_U_1 * limb2_U_follows_1_by_limb2_S_0);
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL t341 = minus_limb2_S_arm_y * t340;
    const REAL t244 = limb2_U_v_1 * limb2_lower_sin;
    const REAL t344 = t341 - t241 * (param_R * t244);
    const REAL t242 = limb2_U_v_0 * t241;
    const REAL t245 = limb2_upper_offset_x * t244;
    const REAL t345 = limb_lower_m * t344;
    const REAL t234 = limb2_lower_cos * (limb2_lower_cos * t232);
    const REAL t336 = 0.5 * t232;
    const REAL t334 = minus_limb2_U_0_U_still_xx * (0.5 * t234);
    const REAL t335 = limb2_U_v_1 * limb2_U_v_1;
    const REAL t338 = t334 + t335 * t336;
    const REAL minus_limb2_upper_force_x = limb_lower_m * minus_limb2_lower_acc_x;
    const REAL limb2_P_u = READ(u, 1);
    const REAL minus_limb2_S_handed_force_0 = minus_limb2_S_arm_y * (minus_limb2_upper_force_x + limb2_P_u + t338 + t345) - t361;
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL t466 = minus_limb2_U_0_cos * minus_limb2_S_handed_force_0 + t465; /* limb5_S */
    const REAL t362 = limb2_U_0_sin * minus_limb2_S_handed_force_0; /* limb2 */
    /* limb4: free motion; reciprocal wrenches, eq. (10); inertia */
    const REAL t216 = limb4_U_0_sin * platform_twist_angular_z + minus_limb4_U_0_cos * platform_twist_angular_x;
    const REAL limb4_U_v_0 = READ(v, 9);
    const REAL t305 = limb4_U_v_0 * t216;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL limb4_U_v_1 = READ(v, 10), limb4_P_v = READ(v, 11);
    const REAL t318 = limb4_S_arm_x * t305;
    const REAL t314 = limb4_U_v_1 * limb4_P_v;
    const REAL t319 = t318 + t314;
    const REAL t205 = minus_limb4_U_0_cos * platform_twist_angular_z - limb4_U_0_sin * platform_twist_angular_x;
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL t217 = limb4_U_v_1 * limb4_lower_cos;
    const REAL t323 = t319 + t205 * (limb4_P_v + param_R * t217);
    const REAL t218 = limb4_upper_offset_x * t217;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    REAL checked2 = limb4_U_0_pivot;
    const REAL t124 = 1.0 / limb4_U_0_pivot;
    const REAL t135 = limb4_lower_cos * t124;
    const REAL t324 = t323 * t135;
    const REAL limb4_lower_composite_first_x = limb_lower_m * limb4_upper_offset_x;
    const REAL t125 = k7 - limb4_lower_composite_first_x;
    const REAL t196 = limb4_lower_composite_first_x - t125;
    const REAL t126 = limb4_upper_offset_x * t125;
    const REAL t315 = t314 * t196;
    const REAL limb4_U_mass_matrix_1_by_limb4_U_1 = k9 - t126;
    const REAL t127 = t126 - k8;
    const REAL t325 = limb4_U_mass_matrix_1_by_limb4_U_1 * t324;
    const REAL t128 = limb4_lower_cos * t127;
    const REAL t193 = minus_limb4_lower_sin * t128 + limb4_lower_cos * (minus_limb4_lower_sin * t127);
    const REAL limb4_U_mass_matrix_0_by_limb4_U_0 = k3 - limb4_lower_cos * t128;
    const REAL t312 = 0.5 * t193;
    const REAL minus_limb4_U_0_U_still_xx = limb4_U_v_0 * limb4_U_v_0;
    const REAL t316 = minus_limb4_U_0_U_still_xx * t312 + t315;
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y;
    const REAL minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y;
    const REAL minus_limb4_upper_force_y = limb_lower_m * minus_limb4_lower_acc_y;
    const REAL minus_limb4_U_handed_force_1 = limb4_upper_offset_x * minus_limb4_upper_force_y - t316 + t325;
    const REAL limb4_U_follows_1_by_limb4_S_0 = limb4_S_arm_x * t135;
    const REAL t326 = limb4_U_follows_1_by_limb4_S_0 * minus_limb4_U_handed_force_1;
    const REAL t137 = limb4_U_follows_1_by_limb4_S_0 * (limb4_U_mass_matrix_1_by_limb4_U_1 * limb4_U_follows_1_by_limb4_S_0);
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL t306 = limb4_S_arm_y * t305;
    const REAL t208 = limb4_U_v_1 * minus_limb4_lower_sin;
    const REAL t309 = t306 + t205 * (param_R * t208);
    const REAL t206 = limb4_U_v_0 * t205;
    const REAL t209 = limb4_upper_offset_x * t208;
    const REAL t310 = limb_lower_m * t309;
    const REAL t198 = limb4_lower_cos * (limb4_lower_cos * t196);
    const REAL t301 = 0.5 * t196;
    const REAL t299 = minus_limb4_U_0_U_still_xx * (0.5 * t198);
    const REAL t300 = limb4_U_v_1 * limb4_U_v_1;
    const REAL t303 = t299 + t300 * t301;
    const REAL minus_limb4_upper_force_x = limb_lower_m * minus_limb4_lower_acc_x;
    const REAL limb4_P_u = READ(u, 3);
    const REAL limb4_S_handed_force_0 = limb4_S_arm_y * (minus_limb4_upper_force_x + limb4_P_u + t303 - t310) - t326;
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0);
    const REAL t467 = minus_limb4_U_0_cos * limb4_S_handed_force_0 - t466; /* limb5_S */
    const REAL t327 = limb4_U_0_sin * limb4_S_handed_force_0;
    const REAL t60 = limb1_U_0_sin * platform_twist_angular_y - limb1_U_0_cos * platform_twist_angular_z; /* limb5_S */
    const REAL limb1_U_v_0 = READ(v, 0);
    const REAL t48 = limb1_U_0_sin * platform_twist_angular_z; /* limb5_S */
    const REAL t104 = limb1_U_v_0 * t60; /* limb5_S */
    /* limb1: accelerations; free motion; inertia */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL limb1_U_v_1 = READ(v, 1), limb1_P_v = READ(v, 2);
    const REAL t105 = limb1_U2_arm_x * t104; /* limb5_S */
    const REAL t106 = limb1_U_v_1 * limb1_P_v;
    const REAL t107 = t105 + t106; /* limb5_S */
    const REAL t49 = limb1_U_0_cos * platform_twist_angular_y + t48; /* limb5_S */
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL t61 = limb1_U_v_1 * limb1_lower_cos;
    const REAL t111 = t107 - t49 * (limb1_P_v - param_R * t61); /* limb5_S */
    const REAL t62 = limb1_upper_offset_x * t61;
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked3 = limb1_U_0_pivot;
    const REAL t19 = 1.0 / limb1_U_0_pivot;
    const REAL t31 = limb1_lower_cos * t19;
    const REAL t426 = t111 * t31;
    const REAL limb1_lower_composite_first_x = limb_lower_m * limb1_upper_offset_x;
    const REAL t115 = k7 - limb1_lower_composite_first_x;
    const REAL t182 = limb1_lower_composite_first_x - t115;
    const REAL t116 = limb1_upper_offset_x * t115;
    const REAL t423 = t106 * t182;
    const REAL limb1_U_mass_matrix_1_by_limb1_U_1 = k9 - t116;
    const REAL t117 = t116 - k8;
    const REAL t427 = limb1_U_mass_matrix_1_by_limb1_U_1 * t426;
    const REAL t118 = limb1_lower_cos * t117;
    const REAL t179 = limb1_lower_sin * t118 + limb1_lower_cos * (limb1_lower_sin * t117);
    const REAL limb1_U_mass_matrix_0_by_limb1_U_0 = k3 - limb1_lower_cos * t118;
    const REAL t421 = 0.5 * t179;
    const REAL minus_limb1_U_0_U_still_xx = limb1_U_v_0 * limb1_U_v_0;
    const REAL t424 = minus_limb1_U_0_U_still_xx * t421 - t423;
    const REAL limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    const REAL minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y;
    const REAL limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y;
    const REAL minus_limb1_upper_force_y = limb_lower_m * minus_limb1_lower_acc_y;
    /* limb1: free motion; rates that follow; accelerations */
    const REAL minus_limb1_U_handed_force_1 = limb1_upper_offset_x * minus_limb1_upper_force_y + t424 + t427;
    const REAL limb1_U_follows_1_by_limb1_U2_0 = limb1_U2_arm_x * t31;
    const REAL t428 = limb1_U_follows_1_by_limb1_U2_0 * minus_limb1_U_handed_force_1;
    const REAL t375 = limb1_U_follows_1_by_limb1_U2_0 * (limb1_U_mass_matrix_1_by_limb1_U_1 * limb1_U_follows_1_by_limb1_U2_0);
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL t415 = minus_limb1_U2_arm_y * t104;
    const REAL t52 = limb1_U_v_1 * limb1_lower_sin;
    const REAL t418 = t415 + t49 * (param_R * t52);
    const REAL t53 = limb1_upper_offset_x * t52;
    const REAL t419 = limb_lower_m * t418;
    const REAL t184 = limb1_lower_cos * (limb1_lower_cos * t182);
    const REAL t411 = 0.5 * t182;
    const REAL t409 = minus_limb1_U_0_U_still_xx * (0.5 * t184);
    const REAL t410 = limb1_U_v_1 * limb1_U_v_1;
    const REAL t413 = t409 + t410 * t411;
    const REAL limb1_upper_force_x = limb_lower_m * limb1_lower_acc_x;
    const REAL limb1_P_u = READ(u, 0);
    const REAL limb1_U2_handed_force_0 = minus_limb1_U2_arm_y * (limb1_upper_force_x - limb1_P_u - t413 - t419) - t428;
    const REAL t468 = limb1_U_0_sin * limb1_U2_handed_force_0 - t467; /* limb5_S */
    const REAL t487 = limb1_U_0_cos * limb1_U2_handed_force_0;
    /* limb3: geometry */
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    /* limb3: free motion; balance, eqs. (40)-(47); rates that follow */
    const REAL t279 = limb3_upper_position_x * t278;
    const REAL t283 = t281 + limb3_P_v * limb3_lower_cos;
    const REAL t294 = platform_twist_angular_x * t283;
    const REAL t293 = t279 - limb3_U_v_0 * t283 - t288 * (limb3_P_v * minus_limb3_lower_sin - t290);
    const REAL t296 = t146 * (t293 + t294);
    const REAL t297 = limb3_U_mass_matrix_0_by_limb3_U_0 * t296;
    const REAL t273 = t265 * (limb3_U_v_0 * limb3_U_v_1) - t270 * (limb3_U_v_0 * limb3_P_v);
    const REAL limb3_upper_force_z = limb_lower_m_gravity_z * limb3_U_0_sin;
    const REAL minus_limb3_U_handed_force_0 = limb3_lower_cos * (limb3_upper_offset_x * limb3_upper_force_z) + t273 - t297;
    const REAL minus_limb3_U_follows_0_by_limb3_S_1 = limb3_upper_position_x * t146;
    const REAL limb3_S_handed_force_1 = minus_limb3_U_follows_0_by_limb3_S_1 * minus_limb3_U_handed_force_0;
    const REAL t469 = limb3_U_0_cos * limb3_S_handed_force_1 + t468; /* limb5_S */
    const REAL t486 = limb3_U_0_sin * limb3_S_handed_force_1;
    /* limb2: geometry */
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    /* limb2: free motion; balance, eqs. (40)-(47); rates that follow */
    const REAL t243 = minus_limb2_upper_position_y * t242;
    const REAL t247 = t245 - limb2_P_v * limb2_lower_cos;
    const REAL t258 = platform_twist_angular_y * t247;
    const REAL t257 = t243 + limb2_U_v_0 * t247 + t252 * (limb2_P_v * limb2_lower_sin + t254);
    const REAL t260 = t156 * (t257 - t258);
    const REAL t261 = limb2_U_mass_matrix_0_by_limb2_U_0 * t260;
    const REAL t237 = t229 * (limb2_U_v_0 * limb2_U_v_1) + t234 * (limb2_U_v_0 * limb2_P_v);
    const REAL minus_limb2_upper_force_z = limb_lower_m_gravity_z * minus_limb2_U_0_cos;
    const REAL limb2_U_handed_force_0 = limb2_lower_cos * (limb2_upper_offset_x * minus_limb2_upper_force_z) + t237 + t261;
    const REAL limb2_U_follows_0_by_limb2_S_1 = minus_limb2_upper_position_y * t156;
    const REAL limb2_S_handed_force_1 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_handed_force_0;
    const REAL t470 = limb2_U_0_sin * limb2_S_handed_force_1 - t469; /* limb5_S */
    const REAL t262 = minus_limb2_U_0_cos * limb2_S_handed_force_1;
    /* limb4: geometry */
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    /* limb4: free motion; balance, eqs. (40)-(47); rates that follow */
    const REAL t207 = limb4_upper_position_y * t206;
    const REAL t211 = t209 + limb4_P_v * limb4_lower_cos;
    const REAL t222 = platform_twist_angular_y * t211;
    const REAL t221 = t207 + limb4_U_v_0 * t211 + t216 * (limb4_P_v * minus_limb4_lower_sin - t218);
    const REAL t224 = t124 * (t221 - t222);
    const REAL t225 = limb4_U_mass_matrix_0_by_limb4_U_0 * t224;
    const REAL t201 = t193 * (limb4_U_v_0 * limb4_U_v_1) - t198 * (limb4_U_v_0 * limb4_P_v);
    const REAL minus_limb4_upper_force_z = limb_lower_m_gravity_z * minus_limb4_U_0_cos;
    const REAL limb4_U_handed_force_0 = limb4_lower_cos * (limb4_upper_offset_x * minus_limb4_upper_force_z) - t201 - t225;
    const REAL minus_limb4_U_follows_0_by_limb4_S_1 = limb4_upper_position_y * t124;
    const REAL minus_limb4_S_handed_force_1 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_handed_force_0;
    const REAL t471 = limb4_U_0_sin * minus_limb4_S_handed_force_1 - t470; /* limb5_S */
    const REAL t226 = minus_limb4_U_0_cos * minus_limb4_S_handed_force_1;
    const REAL t50 = limb1_U_v_0 * t49; /* limb5_S */
    /* limb1: loop closure; free motion; rates that follow */
    const REAL t74 = limb1_U_v_1 - t49;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t51 = minus_limb1_upper_position_x * t50; /* limb5_S */
    const REAL t55 = t53 - limb1_P_v * limb1_lower_cos;
    const REAL t71 = platform_twist_angular_x * t55; /* limb5_S */
    const REAL t65 = t51 - limb1_U_v_0 * t55 - t60 * (limb1_P_v * limb1_lower_sin + t62); /* limb5_S */
    const REAL t72 = t65 + t71; /* limb5_S */
    const REAL t189 = t19 * t72;
    const REAL t190 = limb1_U_mass_matrix_0_by_limb1_U_0 * t189;
    const REAL t187 = t179 * (limb1_U_v_0 * limb1_U_v_1) + t184 * (limb1_U_v_0 * limb1_P_v);
    const REAL limb1_upper_force_z = limb_lower_m_gravity_z * limb1_U_0_sin;
    const REAL minus_limb1_U_handed_force_0 = limb1_lower_cos * (limb1_upper_offset_x * limb1_upper_force_z) - t187 + t190;
    const REAL limb1_U_follows_0_by_limb1_U2_1 = minus_limb1_upper_position_x * t19;
    const REAL minus_limb1_U2_handed_force_1 = limb1_U_follows_0_by_limb1_U2_1 * minus_limb1_U_handed_force_0;
    const REAL t472 = limb1_U_0_cos * minus_limb1_U2_handed_force_1 - t471; /* limb5_S */
    const REAL t485 = limb1_U_0_sin * minus_limb1_U2_handed_force_1;
    const REAL t78 = limb1_lower_sin * t60 + limb1_lower_cos * platform_twist_angular_x;
    const REAL t87 = limb1_lower_cos * t60 - limb1_lower_sin * platform_twist_angular_x;
    const REAL limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    const REAL t79 = limb1_lower_omega_y - t78;
    const REAL t81 = limb1_lower_omega_y * t74 - limb1_U_v_1 * t79;
    const REAL limb1_lower_alpha_still_x = limb1_U_v_1 * limb1_lower_omega_y;
    const REAL t82 = limb1_lower_alpha_still_x - t81;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL t83 = limb1_U2_constraint_mn_couple_x * t82;
    const REAL limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    const REAL t88 = limb1_lower_omega_x + t87;
    const REAL t90 = limb1_lower_omega_x * t79 - limb1_lower_omega_y * t88;
    const REAL t24 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy;
    const REAL t93 = limb1_lower_sin * t24;
    const REAL limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t24 - limb1_lower_sin * platform_turn_xy;
    const REAL t92 = t83 - limb1_U2_constraint_mn_couple_z * t90;
    const REAL limb1_U2_opening_mn = t93 + limb1_lower_cos * platform_turn_xy;
    const REAL t98 = t88 * (limb1_U2_opening_mn * t88 + limb1_U2_constraint_mn_couple_z * t79);
    const REAL limb1_U2_opening_bias_mn = t92 - (t98 - t74 * (limb1_U2_constraint_mn_couple_x * t79 - limb1_U2_opening_mn * t74));
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t31;
    const REAL t113 = limb1_U2_opening_bias_mn - t111 * limb1_U_factor_1_by_3; /* limb5_S */
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t19;
    const REAL t114 = minus_limb1_U_factor_0_by_3 * t72 - t113; /* limb5_S */
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL t33 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    const REAL t370 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL t20 = minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3;
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t20;
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t33;
    checked0 = checked0 + minus_limb5_S_pivot_wz;
    const REAL t34 = 1.0 / minus_limb5_S_pivot_wz; /* limb5_S */
    const REAL minus_limb5_S_joint_acc_still_wz = t34 * t114;
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t34 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t370);
    /* limb3: free motion */
    const REAL t152 = minus_limb3_U_follows_0_by_limb3_S_1 * limb3_U_mass_matrix_0_by_limb3_U_0;
    const REAL t395 = minus_limb3_U_follows_0_by_limb3_S_1 * t152;
    const REAL t394 = limb3_S_arm_y * (k20 * limb3_lower_cos) + t393;
    const REAL t397 = limb3_U_0_cos * (t395 - t394);
    const REAL t398 = limb3_U_0_cos * t397;
    const REAL t399 = t394 + t398;
    const REAL t512 = t395 - t398;
    const REAL t479 = limb3_U_0_sin * t397;
    const REAL t142 = k12 * platform_turn_zz; /* platform */
    const REAL t400 = k13 + platform_turn_zz * t142 + t399; /* limb5_S */
    const REAL t143 = platform_turn_xz * t142; /* platform */
    const REAL t162 = limb2_U_follows_0_by_limb2_S_1 * limb2_U_mass_matrix_0_by_limb2_U_0; /* limb2 */
    const REAL t163 = limb2_U_follows_0_by_limb2_S_1 * t162; /* limb2 */
    const REAL t170 = minus_limb2_S_arm_y * (k20 * limb2_lower_cos) + t169; /* limb2 */
    const REAL t172 = limb2_U_0_sin * (t163 - t170); /* limb2 */
    const REAL t384 = limb2_U_0_sin * t172; /* limb2 */
    const REAL t401 = t170 + t384 + t400; /* limb5_S */
    const REAL t530 = t163 - t384; /* limb2 */
    const REAL t173 = minus_limb2_U_0_cos * t172; /* limb2 */
    const REAL t130 = minus_limb4_U_follows_0_by_limb4_S_1 * limb4_U_mass_matrix_0_by_limb4_U_0; /* limb4 */
    const REAL t131 = minus_limb4_U_follows_0_by_limb4_S_1 * t130; /* limb4 */
    const REAL t138 = limb4_S_arm_y * (k20 * limb4_lower_cos) + t137; /* limb4 */
    const REAL t140 = limb4_U_0_sin * (t131 - t138); /* limb4 */
    const REAL t382 = limb4_U_0_sin * t140; /* limb4 */
    const REAL t402 = t138 + t382 + t401; /* limb5_S */
    const REAL t525 = t131 - t382; /* limb4 */
    const REAL t141 = minus_limb4_U_0_cos * t140; /* limb4 */
    const REAL t120 = limb1_U_follows_0_by_limb1_U2_1 * limb1_U_mass_matrix_0_by_limb1_U_0; /* limb1 */
    const REAL t377 = limb1_U_follows_0_by_limb1_U2_1 * t120; /* limb1 */
    const REAL t376 = minus_limb1_U2_arm_y * (k20 * limb1_lower_cos) + t375; /* limb1 */
    const REAL t379 = limb1_U_0_cos * (t377 - t376); /* limb1 */
    const REAL t380 = limb1_U_0_cos * t379; /* limb1 */
    /* limb5_S: free motion; accelerations; pivots */
    const REAL limb5_S_handed_inertia_wz = t376 + t380 + t402;
    const REAL t509 = t377 - t380; /* limb1 */
    const REAL t474 = limb1_U_0_sin * t379; /* limb1 */
    const REAL t473 = limb5_S_null_space_wz_by_limb5_S_wy * (minus_limb5_S_joint_acc_still_wz * limb5_S_handed_inertia_wz + t472);
    const REAL t517 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz;
    const REAL t329 = platform_turn_xx * platform_rate_moment_x;
    const REAL t492 = platform_turn_yx * platform_rate_moment_x - platform_turn_yy * minus_platform_rate_moment_y - t491;
    const REAL t497 = t485 + (limb4_U_handed_force_0 + (limb2_U_handed_force_0 - (t486 - (t487 + t492))));
    const REAL t365 = minus_limb3_U_handed_force_0 - (t327 + (t329 - platform_turn_xy * minus_platform_rate_moment_y - t362));
    const REAL t368 = minus_limb1_U_handed_force_0 - (t226 - (t262 + t365));
    const REAL t477 = k12 * platform_turn_yz;
    const REAL t502 = minus_limb2_U_0_cos * t162; /* limb2 */
    const REAL t482 = limb4_U_0_sin * t130 - (limb2_U_0_sin * t162 - (platform_turn_zz * t477 - t479));
    const REAL t483 = t474 - t482;
    const REAL t519 = t483 + (t483 - t517);
    const REAL limb5_S_reduced_force_wy = t473 - (minus_limb5_S_joint_acc_still_wz * t483 + t497);
    const REAL t520 = limb5_S_null_space_wz_by_limb5_S_wy * t519;
    const REAL t504 = minus_limb4_U_0_cos * t130; /* limb4 */
    const REAL t515 = limb4_U_mass_matrix_0_by_limb4_U_0 + (limb2_U_mass_matrix_0_by_limb2_U_0 + (k13 + platform_turn_yz * t477 + t512));
    const REAL limb5_S_reduced_inertia_wy_by_limb5_S_wy = t509 + t515 - t520;
    checked1 = checked1 + limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t521 = 1.0 / limb5_S_reduced_inertia_wy_by_limb5_S_wy;
    const REAL t505 = platform_turn_xz * t477 + limb3_U_0_sin * t152 - t502 + t504;
    const REAL limb5_S_handed_inertia_wz_by_limb5_S_wx = limb1_U_0_cos * t120 + (t141 + (t143 - limb3_U_0_cos * t152 + t173));
    const REAL t507 = t505 - limb1_U_0_sin * t120;
    const REAL limb5_S_reduced_inertia_wx_by_limb5_S_wy = t507 + limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_handed_inertia_wz_by_limb5_S_wx;
    const REAL limb5_S_reduced_force_wx = minus_limb5_S_joint_acc_still_wz * limb5_S_handed_inertia_wz_by_limb5_S_wx + t368;
    const REAL t522 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t521;
    const REAL t533 = limb5_S_reduced_inertia_wx_by_limb5_S_wy * t522;
    const REAL t535 = limb5_S_reduced_force_wy * t521;
    const REAL t524 = limb5_S_reduced_force_wx - limb5_S_reduced_force_wy * t522;
    const REAL t531 = limb3_U_mass_matrix_0_by_limb3_U_0 + (k13 + platform_turn_xz * (k12 * platform_turn_xz)) + t530;
    const REAL pivot_1 = limb1_U_mass_matrix_0_by_limb1_U_0 + (t525 + t531) - t533;
    checked2 = checked2 + pivot_1;
    const REAL limb5_S_joint_acc_wx = t524 / pivot_1;
    const REAL minus_limb5_S_joint_acc_wy = t522 * limb5_S_joint_acc_wx - t535;
    const REAL minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz + limb5_S_null_space_wz_by_limb5_S_wy * minus_limb5_S_joint_acc_wy;
    const REAL t544 = limb1_U_0_sin * minus_limb5_S_joint_acc_wz + limb1_U_0_cos * minus_limb5_S_joint_acc_wy; /* limb1 */
    const REAL minus_limb1_U_joint_acc_1 = t426 + limb1_U_follows_1_by_limb1_U2_0 * t544;
    RESULT(checked3, a, 1, -minus_limb1_U_joint_acc_1);
    const REAL minus_limb1_P_joint_acc = t418 + minus_limb1_U2_arm_y * t544;
    RESULT(checked0, a, 2, -minus_limb1_P_joint_acc);
    /* limb2: accelerations */
    const REAL t550 = limb2_U_follows_0_by_limb2_S_1 * (limb2_U_0_sin * minus_limb5_S_joint_acc_wz - minus_limb2_U_0_cos * limb5_S_joint_acc_wx);
    const REAL minus_limb2_U_joint_acc_0 = minus_limb5_S_joint_acc_wy - (t260 + t550);
    RESULT(checked1, a, 3, -minus_limb2_U_joint_acc_0);
    const REAL t554 = minus_limb2_U_0_cos * minus_limb5_S_joint_acc_wz + limb2_U_0_sin * limb5_S_joint_acc_wx;
    const REAL minus_limb2_U_joint_acc_1 = t359 - limb2_U_follows_1_by_limb2_S_0 * t554;
    RESULT(checked2, a, 4, -minus_limb2_U_joint_acc_1);
    const REAL minus_limb2_P_joint_acc = t344 - minus_limb2_S_arm_y * t554;
    RESULT(checked3, a, 5, -minus_limb2_P_joint_acc);
    const REAL t564 = limb3_U_0_sin * minus_limb5_S_joint_acc_wz + limb3_U_0_cos * minus_limb5_S_joint_acc_wy; /* limb3 */
    const REAL minus_limb3_U_joint_acc_1 = t461 + limb3_U_follows_1_by_limb3_S_0 * t564;
    RESULT(checked0, a, 7, -minus_limb3_U_joint_acc_1);
    const REAL limb3_P_joint_acc = t446 + limb3_S_arm_y * t564;
    WRITE(a, 8, limb3_P_joint_acc);
    /* limb4: accelerations */
    const REAL t570 = minus_limb4_U_follows_0_by_limb4_S_1 * (limb4_U_0_sin * minus_limb5_S_joint_acc_wz - minus_limb4_U_0_cos * limb5_S_joint_acc_wx);
    const REAL minus_limb4_U_joint_acc_0 = minus_limb5_S_joint_acc_wy + (t224 + t570);
    RESULT(checked1, a, 9, -minus_limb4_U_joint_acc_0);
    const REAL t574 = minus_limb4_U_0_cos * minus_limb5_S_joint_acc_wz + limb4_U_0_sin * limb5_S_joint_acc_wx;
    const REAL minus_limb4_U_joint_acc_1 = t324 - limb4_U_follows_1_by_limb4_S_0 * t574;
    RESULT(checked2, a, 10, -minus_limb4_U_joint_acc_1);
    const REAL limb4_P_joint_acc = t309 - limb4_S_arm_y * t574;
    WRITE(a, 11, limb4_P_joint_acc);
    /* platform: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t577 = platform_turn_zx * minus_limb5_S_joint_acc_wz;
    const REAL minus_platform_alpha_x = t577 + (platform_turn_yx * minus_limb5_S_joint_acc_wy - platform_turn_xx * limb5_S_joint_acc_wx);
    RESULT(checked3, a, 12, -minus_platform_alpha_x);
    const REAL t738 = platform_turn_zx * (minus_platform_force_moment_x - (t328 - k13 * minus_platform_alpha_x));
    const REAL platform_rate_force_y = platform_mz * (platform_U_still_yz + minus_platform_alpha_x);
    const REAL t581 = platform_turn_zy * minus_limb5_S_joint_acc_wz;
    const REAL minus_platform_alpha_y = t581 + (platform_turn_yy * minus_limb5_S_joint_acc_wy - platform_turn_xy * limb5_S_joint_acc_wx);
    RESULT(checked0, a, 13, -minus_platform_alpha_y);
    const REAL t739 = platform_turn_zy * (platform_force_moment_y - (t330 + k13 * minus_platform_alpha_y)) - t738;
    const REAL platform_rate_force_x = platform_mz * (platform_U_still_xz - minus_platform_alpha_y);
    const REAL t585 = platform_turn_zz * minus_limb5_S_joint_acc_wz;
    const REAL minus_platform_alpha_z = t585 + (platform_turn_yz * minus_limb5_S_joint_acc_wy - platform_turn_xz * limb5_S_joint_acc_wx);
    RESULT(checked1, a, 14, -minus_platform_alpha_z);
    const REAL t740 = platform_turn_zz * (platform_Izz * minus_platform_alpha_z) - t739;
    const REAL t557 = limb3_U_0_cos * minus_limb5_S_joint_acc_wz; /* limb3 */
    /* limb1: accelerations */
    const REAL t540 = limb1_U_follows_0_by_limb1_U2_1 * (limb1_U_0_cos * minus_limb5_S_joint_acc_wz - limb1_U_0_sin * minus_limb5_S_joint_acc_wy);
    const REAL limb1_U_joint_acc_0 = limb5_S_joint_acc_wx - (t189 + t540);
    WRITE(a, 0, limb1_U_joint_acc_0);
    const REAL t561 = t296 + minus_limb3_U_follows_0_by_limb3_S_1 * (t557 - limb3_U_0_sin * minus_limb5_S_joint_acc_wy); /* limb3 */
    const REAL limb3_U_joint_acc_0 = limb5_S_joint_acc_wx + t561;
    WRITE(a, 6, limb3_U_joint_acc_0);
    const REAL limb1_lower_U_xz = limb1_lower_cos * limb1_U_joint_acc_0;
    const REAL minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x;
    const REAL minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_lower_U_xz;
    const REAL limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y;
    const REAL limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y;
    const REAL t716 = limb1_upper_offset_x * limb1_lower_U_zx;
    /* limb1: momentum rate, eq. (35); accelerations; balance, eqs. (40)-(47) */
    const REAL limb1_lower_rate_force_z = limb_lower_mx * limb1_lower_U_zx;
    const REAL limb1_lower_rate_force_z_2 = limb1_upper_force_z + limb1_lower_rate_force_z;
    const REAL minus_limb1_upper_acc_z = limb1_P_v * (2.0 * limb1_lower_omega_y) - (gravity_z * limb1_U_0_sin + t716);
    const REAL minus_limb1_lower_U_still_xx = limb1_lower_omega_y * limb1_lower_omega_y + t410;
    const REAL minus_limb1_upper_rate_force_z = limb1_lower_rate_force_z + limb_lower_m * minus_limb1_upper_acc_z;
    const REAL minus_limb1_upper_rate_moment_y = limb_lower_mx * minus_limb1_upper_acc_z;
    const REAL t719 = limb1_upper_offset_x * minus_limb1_upper_rate_force_z - minus_limb1_upper_rate_moment_y;
    const REAL t713 = k9 * minus_limb1_lower_alpha_still_y + k8 * minus_limb1_lower_alpha_y;
    const REAL t765 = k17 * minus_limb1_lower_alpha_still_y + k16 * minus_limb1_lower_alpha_y;
    const REAL minus_limb1_upper_rate_moment_y_2 = minus_limb1_upper_rate_moment_y + t765;
    const REAL limb1_upper_force_moment_y = gravity_z_limb_lower_mx * limb1_U_0_sin;
    const REAL minus_limb1_lower_rate_moment_y_2 = limb1_upper_force_moment_y + t765;
    const REAL t720 = limb1_lower_cos * (limb1_upper_force_moment_y + t713 - t719);
    const REAL minus_limb1_U2_part_fz = t19 * (k3 * limb1_U_joint_acc_0 + (limb1_lower_sin * (k10 * limb1_lower_alpha_still_x) - t720));
    const REAL t770 = k14 * (limb1_lower_alpha_still_x + limb1_lower_sin * limb1_U_joint_acc_0);
    const REAL minus_limb1_upper_rate_moment_x = k15 * limb1_lower_alpha_still_x - t770;
    const REAL t722 = limb1_lower_sin * (limb1_U2_arm_x * minus_limb1_U2_part_fz);
    const REAL t726 = limb1_U_0_cos * (t722 - limb1_lower_cos * (minus_limb1_U2_arm_y * minus_limb1_U2_part_fz));
    const REAL limb1_lower_U_yx = limb1_lower_U_still_xy - minus_limb1_U_joint_acc_1;
    const REAL t594 = minus_limb1_lower_acc_y - limb1_upper_offset_x * limb1_lower_U_yx;
    const REAL limb1_lower_rate_force_y = limb_lower_mx * limb1_lower_U_yx;
    const REAL limb1_upper_force_moment_z = limb_lower_mx * minus_limb1_lower_acc_y;
    const REAL minus_limb1_lower_rate_force_y = minus_limb1_upper_force_y - limb1_lower_rate_force_y;
    const REAL limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) - t594;
    const REAL minus_limb1_upper_rate_force_y = limb1_lower_rate_force_y - limb_lower_m * limb1_upper_acc_y;
    const REAL minus_limb1_upper_rate_moment_z = limb_lower_mx * limb1_upper_acc_y;
    const REAL t613 = limb1_upper_offset_x * minus_limb1_upper_rate_force_y + minus_limb1_upper_rate_moment_z;
    const REAL t799 = k18 * minus_limb1_U_joint_acc_1;
    const REAL minus_limb1_lower_force_moment_z_2 = limb1_upper_force_moment_z - (k8 * limb1_lower_U_still_xy - k9 * minus_limb1_U_joint_acc_1) + t613;
    const REAL minus_limb1_U2_part_fy = t31 * minus_limb1_lower_force_moment_z_2;
    const REAL minus_limb1_upper_rate_moment_z_2 = minus_limb1_upper_rate_moment_z - (k19 * limb1_lower_U_still_xy - t799);
    const REAL t728 = limb1_U2_arm_x * minus_limb1_U2_part_fy;
    const REAL t600 = limb1_lower_sin * (limb1_U2_arm_x * minus_limb1_U_factor_0_by_3);
    const REAL minus_limb1_upper_acc_x = limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x + minus_limb1_P_joint_acc;
    const REAL minus_limb1_lower_force_x = limb_lower_m * minus_limb1_upper_acc_x;
    const REAL minus_limb1_lower_rate_force_x = limb_lower_mx * minus_limb1_lower_U_still_xx;
    const REAL limb1_upper_rate_force_x = minus_limb1_lower_rate_force_x - minus_limb1_lower_force_x;
    const REAL minus_limb1_lower_sent_force_x = minus_limb1_lower_rate_force_x - limb1_upper_force_x - limb1_P_u;
    const REAL t741 = t726 - limb1_U_0_sin * (minus_limb1_U2_arm_y * limb1_upper_rate_force_x - t728) + t740; /* platform */
    const REAL minus_limb1_U2_multiplier_fx = limb1_P_u - limb1_upper_rate_force_x;
    /* limb2: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL minus_limb2_lower_U_xz = limb2_lower_cos * minus_limb2_U_joint_acc_0;
    const REAL limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin;
    const REAL minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x;
    const REAL minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y + minus_limb2_lower_U_xz;
    const REAL limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y;
    const REAL t684 = limb2_upper_offset_x * limb2_lower_U_zx;
    const REAL limb2_lower_rate_force_z = limb_lower_mx * limb2_lower_U_zx;
    const REAL minus_limb2_lower_rate_force_z = minus_limb2_upper_force_z - limb2_lower_rate_force_z;
    const REAL t685 = gravity_z * minus_limb2_U_0_cos - t684;
    const REAL limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos;
    const REAL limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y;
    const REAL minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) + t685;
    const REAL minus_limb2_upper_rate_force_z = limb2_lower_rate_force_z + limb_lower_m * minus_limb2_upper_acc_z;
    const REAL minus_limb2_upper_rate_moment_y = limb_lower_mx * minus_limb2_upper_acc_z;
    const REAL t687 = limb2_upper_offset_x * minus_limb2_upper_rate_force_z - minus_limb2_upper_rate_moment_y;
    const REAL t681 = k9 * minus_limb2_lower_alpha_still_y + k8 * minus_limb2_lower_alpha_y;
    const REAL t850 = k17 * minus_limb2_lower_alpha_still_y + k16 * minus_limb2_lower_alpha_y;
    const REAL minus_limb2_upper_rate_moment_y_2 = minus_limb2_upper_rate_moment_y + t850;
    const REAL minus_limb2_upper_force_moment_y = gravity_z_limb_lower_mx * minus_limb2_U_0_cos;
    const REAL limb2_lower_rate_moment_y_2 = minus_limb2_upper_force_moment_y - t850;
    const REAL t688 = limb2_lower_cos * (minus_limb2_upper_force_moment_y - t681 + t687);
    const REAL limb2_lower_alpha_still_x = limb2_U_v_1 * limb2_lower_omega_y;
    const REAL minus_limb2_lower_U_still_xx = limb2_lower_omega_y * limb2_lower_omega_y + t335;
    const REAL minus_limb2_U_0_force_moment_z = k3 * minus_limb2_U_joint_acc_0 - (limb2_lower_sin * (k10 * limb2_lower_alpha_still_x) + t688);
    const REAL limb2_S_multiplier_fz = t156 * minus_limb2_U_0_force_moment_z;
    const REAL minus_limb2_upper_sent_force_z = minus_limb2_upper_rate_force_z + limb2_S_multiplier_fz;
    const REAL t855 = k14 * (limb2_lower_alpha_still_x - limb2_lower_sin * minus_limb2_U_joint_acc_0);
    const REAL minus_limb2_upper_rate_moment_x = k15 * limb2_lower_alpha_still_x - t855;
    const REAL minus_limb2_lower_sent_force_z = minus_limb2_upper_sent_force_z + minus_limb2_lower_rate_force_z;
    const REAL t690 = limb2_lower_sin * (limb2_S_arm_x * limb2_S_multiplier_fz);
    const REAL t694 = limb2_U_0_sin * (t690 - limb2_lower_cos * (minus_limb2_S_arm_y * limb2_S_multiplier_fz));
    const REAL limb2_lower_U_yx = limb2_lower_U_still_xy - minus_limb2_U_joint_acc_1;
    const REAL t703 = limb2_lower_acc_y + limb2_upper_offset_x * limb2_lower_U_yx;
    const REAL limb2_lower_rate_force_y = limb_lower_mx * limb2_lower_U_yx;
    const REAL minus_limb2_upper_force_moment_z = limb_lower_mx * limb2_lower_acc_y;
    const REAL limb2_lower_rate_force_y_2 = limb2_upper_force_y + limb2_lower_rate_force_y;
    const REAL limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + t703;
    const REAL minus_limb2_upper_rate_force_y = limb2_lower_rate_force_y - limb_lower_m * limb2_upper_acc_y;
    const REAL minus_limb2_upper_rate_moment_z = limb_lower_mx * limb2_upper_acc_y;
    const REAL t705 = limb2_upper_offset_x * minus_limb2_upper_rate_force_y + minus_limb2_upper_rate_moment_z;
    const REAL t871 = k18 * minus_limb2_U_joint_acc_1;
    const REAL limb2_lower_rate_moment_z = minus_limb2_upper_force_moment_z + (k8 * limb2_lower_U_still_xy - k9 * minus_limb2_U_joint_acc_1);
    const REAL limb2_S_multiplier_fy = t167 * (limb2_lower_rate_moment_z - t705);
    const REAL t706 = limb2_S_arm_x * limb2_S_multiplier_fy;
    const REAL minus_limb2_upper_sent_force_y = minus_limb2_upper_rate_force_y + limb2_S_multiplier_fy;
    const REAL minus_limb2_lower_sent_force_y = minus_limb2_upper_sent_force_y - limb2_lower_rate_force_y_2;
    const REAL minus_limb2_upper_rate_moment_z_2 = minus_limb2_upper_rate_moment_z - (k19 * limb2_lower_U_still_xy - t871);
    const REAL minus_limb2_upper_acc_x = limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x + minus_limb2_P_joint_acc;
    const REAL minus_limb2_lower_force_x = limb_lower_m * minus_limb2_upper_acc_x;
    const REAL minus_limb2_lower_rate_force_x = limb_lower_mx * minus_limb2_lower_U_still_xx;
    const REAL limb2_upper_rate_force_x = minus_limb2_lower_rate_force_x - minus_limb2_lower_force_x;
    const REAL minus_limb2_lower_sent_force_x = minus_limb2_lower_rate_force_x + minus_limb2_upper_force_x - limb2_P_u;
    const REAL t742 = t694 + minus_limb2_U_0_cos * (minus_limb2_S_arm_y * limb2_upper_rate_force_x + t706) + t741; /* platform */
    const REAL platform_joint_force_moment_z_by_limb2_P = minus_limb2_U_0_cos * minus_limb2_S_arm_y;
    const REAL minus_limb2_S_multiplier_fx = limb2_P_u - limb2_upper_rate_force_x;
    /* limb3: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb3_lower_U_xz = limb3_lower_cos * limb3_U_joint_acc_0;
    const REAL minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin;
    const REAL limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x;
    const REAL limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_lower_U_xz;
    const REAL minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y;
    const REAL t652 = limb3_upper_offset_x * minus_limb3_lower_U_zx;
    const REAL minus_limb3_lower_rate_force_z = limb_lower_mx * minus_limb3_lower_U_zx;
    const REAL limb3_lower_rate_force_z = limb3_upper_force_z - minus_limb3_lower_rate_force_z;
    const REAL t653 = gravity_z * limb3_U_0_sin - t652;
    const REAL limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos;
    const REAL minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y;
    const REAL minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) - t653;
    const REAL limb3_upper_rate_force_z = minus_limb3_lower_rate_force_z - limb_lower_m * minus_limb3_upper_acc_z;
    const REAL minus_limb3_upper_rate_moment_y = limb_lower_mx * minus_limb3_upper_acc_z;
    const REAL t655 = limb3_upper_offset_x * limb3_upper_rate_force_z + minus_limb3_upper_rate_moment_y;
    const REAL t649 = k9 * limb3_lower_alpha_still_y + k8 * limb3_lower_alpha_y;
    const REAL t921 = k17 * limb3_lower_alpha_still_y + k16 * limb3_lower_alpha_y;
    const REAL minus_limb3_upper_rate_moment_y_2 = minus_limb3_upper_rate_moment_y - t921;
    const REAL limb3_upper_force_moment_y = gravity_z_limb_lower_mx * limb3_U_0_sin;
    const REAL minus_limb3_lower_rate_moment_y_2 = limb3_upper_force_moment_y - t921;
    const REAL t656 = limb3_lower_cos * (limb3_upper_force_moment_y - t649 + t655);
    const REAL limb3_lower_alpha_still_x = limb3_U_v_1 * limb3_lower_omega_y;
    const REAL minus_limb3_lower_U_still_xx = limb3_lower_omega_y * limb3_lower_omega_y + t437;
    const REAL limb3_U_0_force_moment_z = k3 * limb3_U_joint_acc_0 - (minus_limb3_lower_sin * (k10 * limb3_lower_alpha_still_x) + t656);
    const REAL minus_limb3_S_multiplier_fz = t146 * limb3_U_0_force_moment_z;
    const REAL limb3_upper_sent_force_z = limb3_upper_rate_force_z + minus_limb3_S_multiplier_fz;
    const REAL limb3_lower_sent_force_z = limb3_upper_sent_force_z + limb3_lower_rate_force_z;
    const REAL t917 = k14 * (limb3_lower_alpha_still_x - minus_limb3_lower_sin * limb3_U_joint_acc_0);
    const REAL minus_limb3_upper_rate_moment_x = k15 * limb3_lower_alpha_still_x - t917;
    const REAL t658 = minus_limb3_lower_sin * (limb3_S_arm_x * minus_limb3_S_multiplier_fz);
    const REAL t662 = limb3_U_0_cos * (t658 - limb3_lower_cos * (limb3_S_arm_y * minus_limb3_S_multiplier_fz));
    const REAL minus_limb3_lower_U_yx = minus_limb3_lower_U_still_xy + minus_limb3_U_joint_acc_1;
    const REAL t671 = limb3_lower_acc_y - limb3_upper_offset_x * minus_limb3_lower_U_yx;
    const REAL minus_limb3_lower_rate_force_y = limb_lower_mx * minus_limb3_lower_U_yx;
    const REAL minus_limb3_upper_force_moment_z = limb_lower_mx * limb3_lower_acc_y;
    const REAL limb3_lower_rate_force_y = limb3_upper_force_y - minus_limb3_lower_rate_force_y;
    const REAL limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + t671;
    const REAL limb3_upper_rate_force_y = minus_limb3_lower_rate_force_y + limb_lower_m * limb3_upper_acc_y;
    const REAL minus_limb3_upper_rate_moment_z = limb_lower_mx * limb3_upper_acc_y;
    const REAL t673 = limb3_upper_offset_x * limb3_upper_rate_force_y - minus_limb3_upper_rate_moment_z;
    const REAL t945 = k18 * minus_limb3_U_joint_acc_1;
    const REAL limb3_lower_rate_moment_z = minus_limb3_upper_force_moment_z - (k8 * minus_limb3_lower_U_still_xy + k9 * minus_limb3_U_joint_acc_1);
    const REAL limb3_S_multiplier_fy = t391 * (limb3_lower_rate_moment_z + t673);
    const REAL t674 = limb3_S_arm_x * limb3_S_multiplier_fy;
    const REAL limb3_upper_sent_force_y = limb3_upper_rate_force_y - limb3_S_multiplier_fy;
    const REAL limb3_lower_sent_force_y = limb3_upper_sent_force_y + limb3_lower_rate_force_y;
    const REAL minus_limb3_upper_rate_moment_z_2 = minus_limb3_upper_rate_moment_z + (k19 * minus_limb3_lower_U_still_xy + t945);
    const REAL minus_limb3_lower_force_x = limb_lower_m * (limb3_upper_offset_x * minus_limb3_lower_U_still_xx - limb3_lower_acc_x - limb3_P_joint_acc);
    const REAL minus_limb3_lower_rate_force_x = limb_lower_mx * minus_limb3_lower_U_still_xx;
    const REAL limb3_upper_rate_force_x = minus_limb3_lower_rate_force_x - minus_limb3_lower_force_x;
    const REAL minus_limb3_lower_sent_force_x = minus_limb3_lower_rate_force_x - limb3_upper_force_x - limb3_P_u;
    const REAL t743 = t662 - limb3_U_0_sin * (limb3_S_arm_y * limb3_upper_rate_force_x - t674) - t742; /* platform */
    const REAL platform_joint_force_moment_z_by_limb3_P = limb3_U_0_sin * limb3_S_arm_y;
    const REAL minus_limb3_S_multiplier_fx = limb3_P_u - limb3_upper_rate_force_x;
    /* limb4: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL minus_limb4_lower_U_xz = limb4_lower_cos * minus_limb4_U_joint_acc_0;
    const REAL minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin;
    const REAL limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x;
    const REAL limb4_lower_alpha_y = limb4_lower_alpha_still_y - minus_limb4_lower_U_xz;
    const REAL minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y;
    const REAL t620 = limb4_upper_offset_x * minus_limb4_lower_U_zx;
    const REAL minus_limb4_lower_rate_force_z = limb_lower_mx * minus_limb4_lower_U_zx;
    const REAL minus_limb4_lower_rate_force_z_2 = minus_limb4_upper_force_z + minus_limb4_lower_rate_force_z;
    const REAL t621 = gravity_z * minus_limb4_U_0_cos + t620;
    const REAL limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos;
    const REAL minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y;
    const REAL minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + t621;
    const REAL limb4_upper_rate_force_z = minus_limb4_lower_rate_force_z - limb_lower_m * minus_limb4_upper_acc_z;
    const REAL minus_limb4_upper_rate_moment_y = limb_lower_mx * minus_limb4_upper_acc_z;
    const REAL t623 = limb4_upper_offset_x * limb4_upper_rate_force_z + minus_limb4_upper_rate_moment_y;
    const REAL t617 = k9 * limb4_lower_alpha_still_y + k8 * limb4_lower_alpha_y;
    const REAL t987 = k17 * limb4_lower_alpha_still_y + k16 * limb4_lower_alpha_y;
    const REAL minus_limb4_upper_rate_moment_y_2 = minus_limb4_upper_rate_moment_y - t987;
    const REAL minus_limb4_upper_force_moment_y = gravity_z_limb_lower_mx * minus_limb4_U_0_cos;
    const REAL limb4_lower_rate_moment_y_2 = minus_limb4_upper_force_moment_y + t987;
    const REAL t624 = limb4_lower_cos * (minus_limb4_upper_force_moment_y + t617 - t623);
    const REAL limb4_lower_alpha_still_x = limb4_U_v_1 * limb4_lower_omega_y;
    const REAL minus_limb4_lower_U_still_xx = limb4_lower_omega_y * limb4_lower_omega_y + t300;
    const REAL minus_limb4_lower_joint_force_moment_y = minus_limb4_lower_sin * (k10 * limb4_lower_alpha_still_x) - t624;
    const REAL limb4_S_multiplier_fz = t124 * (k3 * minus_limb4_U_joint_acc_0 + minus_limb4_lower_joint_force_moment_y);
    const REAL limb4_upper_sent_force_z = limb4_upper_rate_force_z - limb4_S_multiplier_fz;
    const REAL t992 = k14 * (limb4_lower_alpha_still_x + minus_limb4_lower_sin * minus_limb4_U_joint_acc_0);
    const REAL minus_limb4_upper_rate_moment_x = k15 * limb4_lower_alpha_still_x - t992;
    const REAL limb4_lower_sent_force_z = limb4_upper_sent_force_z - minus_limb4_lower_rate_force_z_2;
    const REAL t626 = minus_limb4_lower_sin * (limb4_S_arm_x * limb4_S_multiplier_fz);
    const REAL t630 = limb4_U_0_sin * (t626 - limb4_lower_cos * (limb4_S_arm_y * limb4_S_multiplier_fz));
    const REAL minus_limb4_lower_U_yx = minus_limb4_lower_U_still_xy + minus_limb4_U_joint_acc_1;
    const REAL t639 = minus_limb4_lower_acc_y + limb4_upper_offset_x * minus_limb4_lower_U_yx;
    const REAL minus_limb4_lower_rate_force_y = limb_lower_mx * minus_limb4_lower_U_yx;
    const REAL limb4_upper_force_moment_z = limb_lower_mx * minus_limb4_lower_acc_y;
    const REAL minus_limb4_lower_rate_force_y_2 = minus_limb4_upper_force_y + minus_limb4_lower_rate_force_y;
    const REAL limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) - t639;
    const REAL limb4_upper_rate_force_y = minus_limb4_lower_rate_force_y + limb_lower_m * limb4_upper_acc_y;
    const REAL minus_limb4_upper_rate_moment_z = limb_lower_mx * limb4_upper_acc_y;
    const REAL t641 = limb4_upper_offset_x * limb4_upper_rate_force_y - minus_limb4_upper_rate_moment_z;
    const REAL t1007 = k18 * minus_limb4_U_joint_acc_1;
    const REAL minus_limb4_lower_rate_moment_z = limb4_upper_force_moment_z + (k8 * minus_limb4_lower_U_still_xy + k9 * minus_limb4_U_joint_acc_1);
    const REAL minus_limb4_S_multiplier_fy = t135 * (minus_limb4_lower_rate_moment_z - t641);
    const REAL t642 = limb4_S_arm_x * minus_limb4_S_multiplier_fy;
    const REAL limb4_upper_sent_force_y = limb4_upper_rate_force_y + minus_limb4_S_multiplier_fy;
    const REAL limb4_lower_sent_force_y = limb4_upper_sent_force_y - minus_limb4_lower_rate_force_y_2;
    const REAL minus_limb4_upper_rate_moment_z_2 = minus_limb4_upper_rate_moment_z + (k19 * minus_limb4_lower_U_still_xy + t1007);
    const REAL minus_limb4_upper_acc_x = limb4_upper_offset_x * minus_limb4_lower_U_still_xx + minus_limb4_lower_acc_x - limb4_P_joint_acc;
    const REAL minus_limb4_lower_force_x = limb_lower_m * minus_limb4_upper_acc_x;
    const REAL minus_limb4_lower_rate_force_x = limb_lower_mx * minus_limb4_lower_U_still_xx;
    const REAL limb4_upper_rate_force_x = minus_limb4_lower_rate_force_x - minus_limb4_lower_force_x;
    const REAL minus_limb4_lower_sent_force_x = minus_limb4_lower_rate_force_x + minus_limb4_upper_force_x - limb4_P_u;
    const REAL platform_joint_force_moment_z = t630 + minus_limb4_U_0_cos * (limb4_S_arm_y * limb4_upper_rate_force_x + t642) + t743;
    const REAL t595 = minus_limb4_U_0_cos * limb4_S_arm_y; /* platform */
    const REAL minus_limb4_S_multiplier_fx = limb4_P_u - limb4_upper_rate_force_x;
    /* limb1: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t598 = limb1_lower_cos * (limb1_U2_constraint_mn_couple_x - minus_limb1_U2_arm_y * minus_limb1_U_factor_0_by_3);
    const REAL platform_pivot = limb1_U_0_cos * (t598 + t600) + t33;
    checked2 = checked2 + platform_pivot;
    const REAL t603 = 1.0 / platform_pivot; /* platform */
    const REAL minus_limb1_U2_part_mn = t603 * platform_joint_force_moment_z;
    const REAL limb1_U2_part_mn_by_limb1_P = limb1_U_0_sin * minus_limb1_U2_arm_y * t603;
    const REAL minus_limb1_U2_part_mn_by_limb2_P = platform_joint_force_moment_z_by_limb2_P * t603;
    const REAL minus_limb1_U2_part_mn_by_limb3_P = platform_joint_force_moment_z_by_limb3_P * t603;
    const REAL limb1_U2_part_mn_by_limb4_P = t595 * t603;
    const REAL minus_limb1_U2_part_fy_2 = minus_limb1_U2_part_fy - limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn;
    const REAL t745 = limb1_P_u * (limb1_U_factor_1_by_3 * limb1_U2_part_mn_by_limb1_P) + minus_limb1_U2_part_fy_2;
    const REAL t746 = limb2_P_u * (limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn_by_limb2_P) - t745;
    const REAL t747 = limb3_P_u * (limb1_U_factor_1_by_3 * minus_limb1_U2_part_mn_by_limb3_P) + t746;
    const REAL minus_limb1_U2_multiplier_fy = limb4_P_u * (limb1_U_factor_1_by_3 * limb1_U2_part_mn_by_limb4_P) - t747;
    const REAL minus_limb1_upper_sent_force_y = minus_limb1_upper_rate_force_y - minus_limb1_U2_multiplier_fy;
    const REAL minus_limb1_lower_sent_force_y = minus_limb1_upper_sent_force_y + minus_limb1_lower_rate_force_y;
    const REAL t748 = limb1_lower_cos * minus_limb1_lower_sent_force_y;
    const REAL t750 = limb1_lower_sin * minus_limb1_lower_sent_force_y;
    RESULT(checked3, reactions, 0, -(limb1_lower_sin * minus_limb1_lower_sent_force_x + t748));
    const REAL minus_limb1_lower_joint_sent_force_x = limb1_lower_cos * minus_limb1_lower_sent_force_x - t750;
    const REAL t761 = limb1_U_0_cos * minus_limb1_lower_joint_sent_force_x;
    const REAL t751 = limb1_U_0_sin * minus_limb1_lower_joint_sent_force_x;
    const REAL minus_limb1_U2_part_fz_2 = minus_limb1_U2_part_fz + minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn;
    const REAL t757 = limb1_P_u * (minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn_by_limb1_P) - minus_limb1_U2_part_fz_2;
    const REAL t775 = limb1_P_u * limb1_U2_part_mn_by_limb1_P - minus_limb1_U2_part_mn;
    const REAL t758 = limb2_P_u * (minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn_by_limb2_P) - t757;
    const REAL t776 = limb2_P_u * minus_limb1_U2_part_mn_by_limb2_P - t775;
    const REAL t759 = limb3_P_u * (minus_limb1_U_factor_0_by_3 * minus_limb1_U2_part_mn_by_limb3_P) + t758;
    const REAL limb1_U2_multiplier_fz = limb4_P_u * (minus_limb1_U_factor_0_by_3 * limb1_U2_part_mn_by_limb4_P) - t759;
    const REAL minus_limb1_upper_sent_force_z = minus_limb1_upper_rate_force_z + limb1_U2_multiplier_fz;
    const REAL minus_limb1_lower_sent_force_z = minus_limb1_upper_sent_force_z - limb1_lower_rate_force_z_2;
    const REAL limb1_U2_multiplier_mn = limb4_P_u * limb1_U2_part_mn_by_limb4_P - (limb3_P_u * minus_limb1_U2_part_mn_by_limb3_P + t776);
    const REAL minus_limb1_U2_joint_reaction_moment_x = limb1_U2_constraint_mn_couple_x * limb1_U2_multiplier_mn;
    const REAL minus_limb1_U2_joint_reaction_moment_z = limb1_U2_constraint_mn_couple_z * limb1_U2_multiplier_mn;
    const REAL minus_limb1_upper_sent_moment_z = minus_limb1_U2_joint_reaction_moment_z + minus_limb1_upper_rate_moment_z_2;
    const REAL minus_limb1_U_0_joint_sent_force_y = t761 + limb1_U_0_sin * minus_limb1_lower_sent_force_z;
    RESULT(checked0, reactions, 2, -minus_limb1_U_0_joint_sent_force_y);
    const REAL t779 = param_R * minus_limb1_U_0_joint_sent_force_y;
    const REAL limb1_U_0_joint_sent_force_x = t751 - limb1_U_0_cos * minus_limb1_lower_sent_force_z;
    WRITE(reactions, 1, limb1_U_0_joint_sent_force_x);
    const REAL t784 = param_R * limb1_U_0_joint_sent_force_x;
    const REAL minus_limb1_lower_sent_moment_y = minus_limb1_lower_rate_moment_y_2 + (minus_limb1_upper_rate_moment_y_2 - limb1_upper_offset_x * minus_limb1_upper_sent_force_z);
    const REAL t768 = limb1_lower_cos * minus_limb1_lower_sent_moment_y;
    const REAL t780 = limb1_lower_sin * minus_limb1_lower_sent_moment_y;
    const REAL minus_limb1_upper_sent_moment_x = minus_limb1_U2_joint_reaction_moment_x + minus_limb1_upper_rate_moment_x;
    const REAL minus_limb1_lower_sent_moment_x = minus_limb1_upper_rate_moment_x + minus_limb1_upper_sent_moment_x;
    RESULT(checked1, reactions, 3, -(t768 + limb1_lower_sin * minus_limb1_lower_sent_moment_x));
    const REAL limb1_lower_joint_sent_moment_x = t780 - limb1_lower_cos * minus_limb1_lower_sent_moment_x;
    /* limb1: reactions, eq. (32); geometry; balance, eqs. (40)-(47) */
    RESULT(checked2, reactions, 4, -(t779 + limb1_U_0_sin * limb1_lower_joint_sent_moment_x));
    RESULT(checked3, reactions, 5, limb1_U_0_cos * limb1_lower_joint_sent_moment_x - t784);
    const REAL minus_limb1_P_reaction_force_x = limb1_lower_cos * minus_limb1_upper_sent_force_y;
    RESULT(checked0, reactions, 6, -minus_limb1_P_reaction_force_x);
    const REAL t785 = limb1_U_0_cos * minus_limb1_upper_sent_force_z;
    const REAL t787 = limb1_U_0_sin * minus_limb1_upper_sent_force_z;
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    const REAL minus_limb1_P_reaction_force_y = t785 + limb1_lower_rotation_yy * minus_limb1_upper_sent_force_y;
    RESULT(checked1, reactions, 7, -minus_limb1_P_reaction_force_y);
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin;
    const REAL minus_limb1_P_reaction_force_z = t787 - minus_limb1_lower_rotation_zy * minus_limb1_upper_sent_force_y;
    RESULT(checked2, reactions, 8, -minus_limb1_P_reaction_force_z);
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    const REAL limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx;
    const REAL t789 = limb1_upper_position_z * minus_limb1_P_reaction_force_y;
    const REAL t807 = minus_limb1_upper_position_x * minus_limb1_P_reaction_force_y;
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    const REAL minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx;
    const REAL t791 = t789 + minus_limb1_upper_position_y * minus_limb1_P_reaction_force_z;
    const REAL t795 = minus_limb1_upper_position_x * minus_limb1_P_reaction_force_z;
    const REAL t793 = limb1_lower_sin * minus_limb1_upper_sent_moment_x;
    RESULT(checked3, reactions, 9, t791 - (limb1_lower_cos * minus_limb1_upper_rate_moment_y_2 + t793));
    const REAL t797 = t795 + limb1_upper_position_z * minus_limb1_P_reaction_force_x;
    const REAL t808 = minus_limb1_upper_position_y * minus_limb1_P_reaction_force_x - t807;
    const REAL t803 = minus_limb1_lower_rotation_yx * minus_limb1_upper_sent_moment_x;
    const REAL t811 = limb1_lower_rotation_zx * minus_limb1_upper_sent_moment_x;
    const REAL t804 = limb1_lower_rotation_yy * minus_limb1_upper_rate_moment_y_2 - t803;
    const REAL t812 = minus_limb1_lower_rotation_zy * minus_limb1_upper_rate_moment_y_2 - t811;
    const REAL t817 = limb1_lower_rotation_yy * minus_limb1_U2_multiplier_fy;
    const REAL t821 = minus_limb1_lower_rotation_zy * minus_limb1_U2_multiplier_fy;
    RESULT(checked0, reactions, 10, -(t797 + (limb1_U_0_cos * minus_limb1_upper_sent_moment_z + t804)));
    RESULT(checked1, reactions, 11, -(t808 + (limb1_U_0_sin * minus_limb1_upper_sent_moment_z - t812)));
    const REAL t819 = t817 - minus_limb1_lower_rotation_yx * minus_limb1_U2_multiplier_fx;
    const REAL t832 = minus_limb1_lower_rotation_yx * minus_limb1_U2_joint_reaction_moment_x;
    const REAL t816 = limb1_U_0_cos * limb1_U2_multiplier_fz;
    const REAL minus_limb1_U2_reaction_force_y = t816 - t819;
    RESULT(checked2, reactions, 13, -minus_limb1_U2_reaction_force_y);
    const REAL t820 = limb1_U_0_sin * limb1_U2_multiplier_fz;
    const REAL minus_limb1_U2_reaction_force_z = t820 + (t821 - limb1_lower_rotation_zx * minus_limb1_U2_multiplier_fx);
    RESULT(checked3, reactions, 14, -minus_limb1_U2_reaction_force_z);
    const REAL t838 = limb1_lower_rotation_zx * minus_limb1_U2_joint_reaction_moment_x;
    const REAL t827 = limb1_lower_sin * minus_limb1_U2_joint_reaction_moment_x;
    const REAL t824 = limb1_upper_position_z * minus_limb1_U2_reaction_force_y;
    const REAL t835 = minus_limb1_upper_position_x * minus_limb1_U2_reaction_force_y;
    const REAL t828 = minus_limb1_upper_position_x * minus_limb1_U2_reaction_force_z;
    RESULT(checked0, reactions, 15, t824 + minus_limb1_upper_position_y * minus_limb1_U2_reaction_force_z - t827);
    const REAL t1072 = limb1_lower_sin * minus_limb1_U2_multiplier_fy;
    const REAL limb1_U2_reaction_force_x = limb1_lower_cos * minus_limb1_U2_multiplier_fy + limb1_lower_sin * minus_limb1_U2_multiplier_fx;
    WRITE(reactions, 12, limb1_U2_reaction_force_x);
    const REAL t830 = t828 - limb1_upper_position_z * limb1_U2_reaction_force_x;
    const REAL t836 = minus_limb1_upper_position_y * limb1_U2_reaction_force_x + t835;
    const REAL t1074 = t1072 - limb1_lower_cos * minus_limb1_U2_multiplier_fx;
    RESULT(checked1, reactions, 16, -(t830 + (limb1_U_0_cos * minus_limb1_U2_joint_reaction_moment_z - t832)));
    RESULT(checked2, reactions, 17, t836 - (limb1_U_0_sin * minus_limb1_U2_joint_reaction_moment_z + t838));
    /* limb2: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t845 = limb2_lower_cos * minus_limb2_lower_sent_force_y;
    const REAL t841 = limb2_lower_sin * minus_limb2_lower_sent_force_y;
    RESULT(checked3, reactions, 19, -(limb2_lower_sin * minus_limb2_lower_sent_force_x + t845));
    const REAL minus_limb2_lower_joint_sent_force_x = limb2_lower_cos * minus_limb2_lower_sent_force_x - t841;
    const REAL limb2_lower_sent_moment_y = limb2_lower_rate_moment_y_2 - (minus_limb2_upper_rate_moment_y_2 - limb2_upper_offset_x * minus_limb2_upper_sent_force_z);
    const REAL t853 = limb2_lower_sin * limb2_lower_sent_moment_y;
    const REAL t859 = limb2_lower_cos * limb2_lower_sent_moment_y;
    const REAL minus_limb2_lower_sent_moment_x = 2.0 * minus_limb2_upper_rate_moment_x;
    const REAL minus_limb2_lower_joint_sent_moment_x = t853 + limb2_lower_cos * minus_limb2_lower_sent_moment_x;
    RESULT(checked0, reactions, 22, t859 - limb2_lower_sin * minus_limb2_lower_sent_moment_x);
    const REAL t857 = minus_limb2_U_0_cos * minus_limb2_lower_joint_sent_moment_x;
    const REAL t862 = limb2_U_0_sin * minus_limb2_lower_joint_sent_moment_x;
    const REAL t847 = minus_limb2_U_0_cos * minus_limb2_lower_sent_force_z;
    const REAL t843 = limb2_U_0_sin * minus_limb2_lower_sent_force_z;
    const REAL limb2_U_0_joint_sent_force_x = limb2_U_0_sin * minus_limb2_lower_joint_sent_force_x + t847;
    WRITE(reactions, 20, limb2_U_0_joint_sent_force_x);
    /* limb2: reactions, eq. (32); balance, eqs. (40)-(47); geometry */
    RESULT(checked1, reactions, 21, t857 - param_R * limb2_U_0_joint_sent_force_x);
    const REAL limb2_U_0_joint_sent_force_y = minus_limb2_U_0_cos * minus_limb2_lower_joint_sent_force_x - t843;
    WRITE(reactions, 18, limb2_U_0_joint_sent_force_y);
    RESULT(checked2, reactions, 23, param_R * limb2_U_0_joint_sent_force_y + t862);
    const REAL t863 = limb2_U_0_sin * minus_limb2_upper_sent_force_z;
    const REAL t865 = minus_limb2_U_0_cos * minus_limb2_upper_sent_force_z;
    const REAL limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin;
    const REAL minus_limb2_P_reaction_force_x = t863 + limb2_lower_rotation_xy * minus_limb2_upper_sent_force_y;
    RESULT(checked3, reactions, 24, -minus_limb2_P_reaction_force_x);
    const REAL minus_limb2_P_reaction_force_y = limb2_lower_cos * minus_limb2_upper_sent_force_y;
    RESULT(checked0, reactions, 25, -minus_limb2_P_reaction_force_y);
    const REAL limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin;
    const REAL limb2_P_reaction_force_z = t865 - limb2_lower_rotation_zy * minus_limb2_upper_sent_force_y;
    WRITE(reactions, 26, limb2_P_reaction_force_z);
    const REAL t868 = minus_limb2_upper_position_y * limb2_P_reaction_force_z;
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx;
    const REAL t869 = minus_limb2_upper_position_z * minus_limb2_P_reaction_force_y + t868;
    const REAL t874 = limb2_lower_rotation_xy * minus_limb2_upper_rate_moment_y_2;
    const REAL t893 = limb2_lower_rotation_xy * limb2_S_multiplier_fy;
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    const REAL minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx;
    const REAL t878 = minus_limb2_upper_position_x * limb2_P_reaction_force_z;
    const REAL t890 = minus_limb2_upper_position_x * minus_limb2_P_reaction_force_y;
    const REAL t876 = t874 - minus_limb2_lower_rotation_xx * minus_limb2_upper_rate_moment_x;
    const REAL t895 = t893 + minus_limb2_lower_rotation_xx * minus_limb2_S_multiplier_fx;
    RESULT(checked1, reactions, 27, -(t869 + (limb2_U_0_sin * minus_limb2_upper_rate_moment_z_2 + t876)));
    const REAL t884 = minus_limb2_U_0_cos * minus_limb2_upper_rate_moment_z_2;
    const REAL t880 = t878 + minus_limb2_upper_position_z * minus_limb2_P_reaction_force_x;
    const REAL t891 = minus_limb2_upper_position_y * minus_limb2_P_reaction_force_x - t890;
    const REAL t881 = limb2_lower_cos * minus_limb2_upper_rate_moment_y_2;
    const REAL t885 = limb2_lower_rotation_zy * minus_limb2_upper_rate_moment_y_2;
    const REAL t899 = limb2_lower_rotation_zy * limb2_S_multiplier_fy;
    RESULT(checked2, reactions, 28, t880 - (t881 + limb2_lower_sin * minus_limb2_upper_rate_moment_x));
    RESULT(checked3, reactions, 29, t884 - (t885 - minus_limb2_lower_rotation_zx * minus_limb2_upper_rate_moment_x) - t891);
    const REAL t901 = t899 + minus_limb2_lower_rotation_zx * minus_limb2_S_multiplier_fx;
    const REAL t892 = limb2_U_0_sin * limb2_S_multiplier_fz;
    const REAL minus_limb2_S_reaction_force_x = t892 + t895;
    RESULT(checked0, reactions, 30, -minus_limb2_S_reaction_force_x);
    const REAL t898 = minus_limb2_U_0_cos * limb2_S_multiplier_fz;
    const REAL limb2_S_reaction_force_z = t898 - t901;
    WRITE(reactions, 32, limb2_S_reaction_force_z);
    const REAL t903 = minus_limb2_upper_position_y * limb2_S_reaction_force_z;
    const REAL t904 = minus_limb2_upper_position_x * limb2_S_reaction_force_z;
    const REAL t906 = minus_limb2_upper_position_y * minus_limb2_S_reaction_force_x;
    RESULT(checked1, reactions, 34, t904 + minus_limb2_upper_position_z * minus_limb2_S_reaction_force_x);
    const REAL t1050 = limb2_lower_sin * limb2_S_multiplier_fy;
    const REAL limb2_S_reaction_force_y = limb2_lower_sin * minus_limb2_S_multiplier_fx - limb2_lower_cos * limb2_S_multiplier_fy;
    WRITE(reactions, 31, limb2_S_reaction_force_y);
    RESULT(checked2, reactions, 33, minus_limb2_upper_position_z * limb2_S_reaction_force_y - t903);
    RESULT(checked3, reactions, 35, -(t906 + minus_limb2_upper_position_x * limb2_S_reaction_force_y));
    const REAL t1051 = limb2_lower_cos * minus_limb2_S_multiplier_fx + t1050;
    /* limb3: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t909 = limb3_lower_cos * limb3_lower_sent_force_y;
    const REAL t911 = minus_limb3_lower_sin * limb3_lower_sent_force_y;
    RESULT(checked0, reactions, 36, minus_limb3_lower_sin * minus_limb3_lower_sent_force_x + t909);
    const REAL minus_limb3_lower_joint_sent_force_x = limb3_lower_cos * minus_limb3_lower_sent_force_x - t911;
    const REAL t913 = limb3_U_0_cos * limb3_lower_sent_force_z;
    const REAL minus_limb3_U_0_joint_sent_force_y = limb3_U_0_cos * minus_limb3_lower_joint_sent_force_x - limb3_U_0_sin * limb3_lower_sent_force_z;
    RESULT(checked1, reactions, 38, -minus_limb3_U_0_joint_sent_force_y);
    const REAL t925 = param_R * minus_limb3_U_0_joint_sent_force_y;
    const REAL limb3_U_0_joint_sent_force_x = limb3_U_0_sin * minus_limb3_lower_joint_sent_force_x + t913;
    WRITE(reactions, 37, limb3_U_0_joint_sent_force_x);
    const REAL t929 = param_R * limb3_U_0_joint_sent_force_x;
    const REAL minus_limb3_lower_sent_moment_y = minus_limb3_lower_rate_moment_y_2 + (minus_limb3_upper_rate_moment_y_2 + limb3_upper_offset_x * limb3_upper_sent_force_z);
    const REAL t924 = limb3_lower_cos * minus_limb3_lower_sent_moment_y;
    const REAL t926 = minus_limb3_lower_sin * minus_limb3_lower_sent_moment_y;
    const REAL minus_limb3_lower_sent_moment_x = 2.0 * minus_limb3_upper_rate_moment_x;
    RESULT(checked2, reactions, 39, minus_limb3_lower_sin * minus_limb3_lower_sent_moment_x - t924);
    const REAL minus_limb3_lower_joint_sent_moment_x = t926 + limb3_lower_cos * minus_limb3_lower_sent_moment_x;
    /* limb3: reactions, eq. (32); geometry; balance, eqs. (40)-(47) */
    RESULT(checked3, reactions, 40, t925 + limb3_U_0_sin * minus_limb3_lower_joint_sent_moment_x);
    RESULT(checked0, reactions, 41, t929 - limb3_U_0_cos * minus_limb3_lower_joint_sent_moment_x);
    const REAL t931 = limb3_U_0_cos * limb3_upper_sent_force_z;
    const REAL t933 = limb3_U_0_sin * limb3_upper_sent_force_z;
    const REAL minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin;
    const REAL limb3_P_reaction_force_y = t931 - minus_limb3_lower_rotation_yy * limb3_upper_sent_force_y;
    WRITE(reactions, 43, limb3_P_reaction_force_y);
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    const REAL limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx;
    const REAL t935 = limb3_upper_position_z * limb3_P_reaction_force_y;
    const REAL t953 = limb3_upper_position_x * limb3_P_reaction_force_y;
    const REAL limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin;
    const REAL limb3_P_reaction_force_z = t933 + limb3_lower_rotation_zy * limb3_upper_sent_force_y;
    WRITE(reactions, 44, limb3_P_reaction_force_z);
    const REAL limb3_P_reaction_force_x = limb3_lower_cos * limb3_upper_sent_force_y;
    WRITE(reactions, 42, limb3_P_reaction_force_x);
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    const REAL minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx;
    const REAL t937 = t935 + minus_limb3_upper_position_y * limb3_P_reaction_force_z;
    const REAL t941 = limb3_upper_position_x * limb3_P_reaction_force_z;
    const REAL t938 = limb3_lower_cos * minus_limb3_upper_rate_moment_y_2;
    RESULT(checked1, reactions, 45, -(t937 + (t938 - minus_limb3_lower_sin * minus_limb3_upper_rate_moment_x)));
    const REAL t943 = t941 - limb3_upper_position_z * limb3_P_reaction_force_x;
    const REAL t954 = minus_limb3_upper_position_y * limb3_P_reaction_force_x + t953;
    const REAL t948 = minus_limb3_lower_rotation_yy * minus_limb3_upper_rate_moment_y_2;
    const REAL t956 = limb3_lower_rotation_zy * minus_limb3_upper_rate_moment_y_2;
    const REAL t963 = minus_limb3_lower_rotation_yy * limb3_S_multiplier_fy;
    const REAL t967 = limb3_lower_rotation_zy * limb3_S_multiplier_fy;
    const REAL t950 = t948 + minus_limb3_lower_rotation_yx * minus_limb3_upper_rate_moment_x;
    const REAL t958 = t956 + limb3_lower_rotation_zx * minus_limb3_upper_rate_moment_x;
    const REAL t965 = t963 - minus_limb3_lower_rotation_yx * minus_limb3_S_multiplier_fx;
    const REAL t969 = t967 - limb3_lower_rotation_zx * minus_limb3_S_multiplier_fx;
    RESULT(checked2, reactions, 46, -(t943 + (limb3_U_0_cos * minus_limb3_upper_rate_moment_z_2 - t950)));
    RESULT(checked3, reactions, 47, t954 - (limb3_U_0_sin * minus_limb3_upper_rate_moment_z_2 + t958));
    const REAL t1068 = minus_limb3_lower_sin * limb3_S_multiplier_fy;
    const REAL minus_limb3_S_reaction_force_x = minus_limb3_lower_sin * minus_limb3_S_multiplier_fx + limb3_lower_cos * limb3_S_multiplier_fy;
    RESULT(checked0, reactions, 48, -minus_limb3_S_reaction_force_x);
    const REAL t1069 = limb3_lower_cos * minus_limb3_S_multiplier_fx - t1068;
    const REAL t962 = limb3_U_0_cos * minus_limb3_S_multiplier_fz;
    const REAL limb3_S_reaction_force_y = t962 + t965;
    WRITE(reactions, 49, limb3_S_reaction_force_y);
    const REAL t966 = limb3_U_0_sin * minus_limb3_S_multiplier_fz;
    const REAL limb3_S_reaction_force_z = t966 - t969;
    WRITE(reactions, 50, limb3_S_reaction_force_z);
    const REAL t970 = limb3_upper_position_z * limb3_S_reaction_force_y;
    const REAL t973 = limb3_upper_position_z * minus_limb3_S_reaction_force_x;
    const REAL t974 = limb3_upper_position_x * limb3_S_reaction_force_y;
    RESULT(checked1, reactions, 52, -(limb3_upper_position_x * limb3_S_reaction_force_z + t973));
    RESULT(checked2, reactions, 51, -(t970 + minus_limb3_upper_position_y * limb3_S_reaction_force_z));
    RESULT(checked3, reactions, 53, t974 - minus_limb3_upper_position_y * minus_limb3_S_reaction_force_x);
    /* limb4: balance, eqs. (40)-(47); reactions, eq. (32) */
    const REAL t981 = limb4_lower_cos * limb4_lower_sent_force_y;
    const REAL t977 = minus_limb4_lower_sin * limb4_lower_sent_force_y;
    RESULT(checked0, reactions, 55, minus_limb4_lower_sin * minus_limb4_lower_sent_force_x + t981);
    const REAL minus_limb4_lower_joint_sent_force_x = limb4_lower_cos * minus_limb4_lower_sent_force_x - t977;
    const REAL limb4_lower_sent_moment_y = limb4_lower_rate_moment_y_2 - (minus_limb4_upper_rate_moment_y_2 + limb4_upper_offset_x * limb4_upper_sent_force_z);
    const REAL t990 = minus_limb4_lower_sin * limb4_lower_sent_moment_y;
    const REAL t995 = limb4_lower_cos * limb4_lower_sent_moment_y;
    const REAL minus_limb4_lower_sent_moment_x = 2.0 * minus_limb4_upper_rate_moment_x;
    const REAL limb4_lower_joint_sent_moment_x = t990 - limb4_lower_cos * minus_limb4_lower_sent_moment_x;
    RESULT(checked1, reactions, 58, t995 + minus_limb4_lower_sin * minus_limb4_lower_sent_moment_x);
    const REAL t994 = minus_limb4_U_0_cos * limb4_lower_joint_sent_moment_x;
    const REAL t998 = limb4_U_0_sin * limb4_lower_joint_sent_moment_x;
    const REAL t983 = minus_limb4_U_0_cos * limb4_lower_sent_force_z;
    const REAL t979 = limb4_U_0_sin * limb4_lower_sent_force_z;
    const REAL limb4_U_0_joint_sent_force_x = limb4_U_0_sin * minus_limb4_lower_joint_sent_force_x - t983;
    WRITE(reactions, 56, limb4_U_0_joint_sent_force_x);
    /* limb4: reactions, eq. (32); balance, eqs. (40)-(47); geometry */
    RESULT(checked2, reactions, 57, param_R * limb4_U_0_joint_sent_force_x - t994);
    const REAL limb4_U_0_joint_sent_force_y = minus_limb4_U_0_cos * minus_limb4_lower_joint_sent_force_x + t979;
    WRITE(reactions, 54, limb4_U_0_joint_sent_force_y);
    RESULT(checked3, reactions, 59, -(param_R * limb4_U_0_joint_sent_force_y + t998));
    const REAL t1001 = minus_limb4_U_0_cos * limb4_upper_sent_force_z;
    const REAL t999 = limb4_U_0_sin * limb4_upper_sent_force_z;
    const REAL minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin;
    const REAL minus_limb4_P_reaction_force_z = t1001 + minus_limb4_lower_rotation_zy * limb4_upper_sent_force_y;
    RESULT(checked0, reactions, 62, -minus_limb4_P_reaction_force_z);
    const REAL t1004 = limb4_upper_position_y * minus_limb4_P_reaction_force_z;
    const REAL limb4_P_reaction_force_y = limb4_lower_cos * limb4_upper_sent_force_y;
    WRITE(reactions, 61, limb4_P_reaction_force_y);
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx;
    const REAL t1005 = minus_limb4_upper_position_z * limb4_P_reaction_force_y - t1004;
    const REAL minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin;
    const REAL limb4_P_reaction_force_x = t999 - minus_limb4_lower_rotation_xy * limb4_upper_sent_force_y;
    WRITE(reactions, 60, limb4_P_reaction_force_x);
    const REAL t1010 = minus_limb4_lower_rotation_xy * minus_limb4_upper_rate_moment_y_2;
    const REAL t1029 = minus_limb4_lower_rotation_xy * minus_limb4_S_multiplier_fy;
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    const REAL minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx;
    const REAL t1014 = minus_limb4_upper_position_x * minus_limb4_P_reaction_force_z;
    const REAL t1026 = minus_limb4_upper_position_x * limb4_P_reaction_force_y;
    const REAL t1012 = t1010 + minus_limb4_lower_rotation_xx * minus_limb4_upper_rate_moment_x;
    const REAL t1031 = t1029 + minus_limb4_lower_rotation_xx * minus_limb4_S_multiplier_fx;
    RESULT(checked1, reactions, 63, t1005 - (limb4_U_0_sin * minus_limb4_upper_rate_moment_z_2 - t1012));
    const REAL t1020 = minus_limb4_U_0_cos * minus_limb4_upper_rate_moment_z_2;
    const REAL t1016 = t1014 + minus_limb4_upper_position_z * limb4_P_reaction_force_x;
    const REAL t1027 = limb4_upper_position_y * limb4_P_reaction_force_x + t1026;
    const REAL t1017 = limb4_lower_cos * minus_limb4_upper_rate_moment_y_2;
    const REAL t1021 = minus_limb4_lower_rotation_zy * minus_limb4_upper_rate_moment_y_2;
    const REAL t1035 = minus_limb4_lower_rotation_zy * minus_limb4_S_multiplier_fy;
    RESULT(checked2, reactions, 64, -(t1016 + (t1017 - minus_limb4_lower_sin * minus_limb4_upper_rate_moment_x)));
    RESULT(checked3, reactions, 65, t1020 + (t1021 + minus_limb4_lower_rotation_zx * minus_limb4_upper_rate_moment_x) - t1027);
    const REAL t1037 = t1035 + minus_limb4_lower_rotation_zx * minus_limb4_S_multiplier_fx;
    const REAL t1028 = limb4_U_0_sin * limb4_S_multiplier_fz;
    const REAL minus_limb4_S_reaction_force_x = t1028 + t1031;
    RESULT(checked0, reactions, 66, -minus_limb4_S_reaction_force_x);
    const REAL t1034 = minus_limb4_U_0_cos * limb4_S_multiplier_fz;
    const REAL limb4_S_reaction_force_z = t1034 - t1037;
    WRITE(reactions, 68, limb4_S_reaction_force_z);
    const REAL t1033 = limb4_lower_cos * minus_limb4_S_multiplier_fy;
    const REAL t1045 = minus_limb4_lower_sin * minus_limb4_S_multiplier_fy;
    const REAL minus_limb4_S_reaction_force_y = minus_limb4_lower_sin * minus_limb4_S_multiplier_fx - t1033;
    RESULT(checked1, reactions, 67, -minus_limb4_S_reaction_force_y);
    const REAL t1046 = limb4_lower_cos * minus_limb4_S_multiplier_fx + t1045;
    const REAL t1038 = limb4_upper_position_y * limb4_S_reaction_force_z;
    const REAL t1040 = minus_limb4_upper_position_x * limb4_S_reaction_force_z;
    const REAL t1042 = limb4_upper_position_y * minus_limb4_S_reaction_force_x;
    RESULT(checked2, reactions, 70, t1040 + minus_limb4_upper_position_z * minus_limb4_S_reaction_force_x);
    RESULT(checked3, reactions, 69, t1038 - minus_limb4_upper_position_z * minus_limb4_S_reaction_force_y);
    RESULT(checked0, reactions, 71, t1042 + minus_limb4_upper_position_x * minus_limb4_S_reaction_force_y);
    /* platform: momentum rate, eq. (35) */
    const REAL platform_rate_force_y_2 = platform_m_gravity_z * platform_turn_zy + platform_rate_force_y;
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t1059 = platform_turn_xy * platform_rate_force_y_2;
    const REAL t1078 = platform_turn_yy * platform_rate_force_y_2;
    const REAL t1094 = platform_turn_zy * platform_rate_force_y_2;
    const REAL platform_rate_force_x_2 = platform_m_gravity_z * platform_turn_zx + platform_rate_force_x;
    const REAL t1062 = t1059 + platform_turn_xx * platform_rate_force_x_2;
    const REAL t1080 = t1078 + platform_turn_yx * platform_rate_force_x_2;
    const REAL t1096 = t1094 + platform_turn_zx * platform_rate_force_x_2;
    const REAL t1056 = platform_m_gravity_z * platform_turn_zz;
    const REAL minus_platform_rate_force_z_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t1056;
    const REAL t1064 = limb1_U2_reaction_force_x + (platform_turn_xz * minus_platform_rate_force_z_2 - t1062);
    const REAL t1081 = platform_turn_yz * minus_platform_rate_force_z_2 - t1080;
    const REAL t1097 = platform_turn_zz * minus_platform_rate_force_z_2 - t1096;
    const REAL t1066 = minus_limb3_S_reaction_force_x + (minus_limb2_U_0_cos * t1051 + t892 - t1064);
    const REAL t1090 = limb2_U_0_sin * t1051 - t898; /* limb2 */
    RESULT(checked1, reactions, 72, minus_limb4_U_0_cos * t1046 + t1028 + t1066);
    const REAL t1086 = limb4_U_0_sin * t1046 - t1034; /* limb4 */
    const REAL t1083 = limb2_S_reaction_force_y + (limb1_U_0_sin * t1074 - t816 + t1081);
    const REAL t1099 = t1090 + (limb1_U_0_cos * t1074 + t820 - t1097);
    RESULT(checked2, reactions, 73, minus_limb4_S_reaction_force_y + (limb3_U_0_sin * t1069 - t962 - t1083));
    RESULT(checked3, reactions, 74, t1086 - (limb3_U_0_cos * t1069 + t966 - t1099));
    WRITE(reactions, 75, CONSTANT(0.0));
    WRITE(reactions, 76, CONSTANT(0.0));
    WRITE(reactions, 77, CONSTANT(0.0));
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-06) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-06) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-06) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-06) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-05) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(limb5_S_reduced_inertia_wy_by_limb5_S_wy, 0.0007562600000000001) OR /* where limb5_S.wy feels no inertia */
        SMALL(pivot_1, 0.0007551200000000001) OR /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(platform_pivot, 4.017100000000001e-06), /* where limb1_U2.mn cannot balance platform.moment_z */
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
    const REAL t3 = limb1_upper_offset_x * (k7 - limb_lower_m * limb1_upper_offset_x);
    const REAL limb1_U_mass_matrix_1_by_limb1_U_1 = k9 - t3;
    WRITE(inertia_, 16, limb1_U_mass_matrix_1_by_limb1_U_1);
    REAL checked0 = limb1_U_mass_matrix_1_by_limb1_U_1;
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL limb1_U_mass_matrix_0_by_limb1_U_0 = k3 - limb1_lower_cos * (limb1_lower_cos * (t3 - k8));
    WRITE(inertia_, 0, limb1_U_mass_matrix_0_by_limb1_U_0);
    REAL checked1 = limb1_U_mass_matrix_0_by_limb1_U_0;
    /* limb2: geometry; inertia */
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    WRITE(closure_, 57, limb2_upper_offset_x);
    const REAL t9 = limb2_upper_offset_x * (k7 - limb_lower_m * limb2_upper_offset_x);
    const REAL limb2_U_mass_matrix_1_by_limb2_U_1 = k9 - t9;
    WRITE(inertia_, 64, limb2_U_mass_matrix_1_by_limb2_U_1);
    REAL checked2 = limb2_U_mass_matrix_1_by_limb2_U_1;
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL limb2_U_mass_matrix_0_by_limb2_U_0 = k3 - limb2_lower_cos * (limb2_lower_cos * (t9 - k8));
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
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    /* limb1: accelerations; geometry; balance, eqs. (40)-(47) */
    const REAL limb1_U_v_1 = READ(v, 1);
    const REAL minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x;
    const REAL t27 = limb1_upper_offset_x * (2.0 * minus_limb1_lower_alpha_still_y);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    const REAL t28 = t27 + gravity_z * limb1_U_0_sin;
    const REAL limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    const REAL limb1_P_v = READ(v, 2);
    const REAL t26 = limb1_P_v * (2.0 * limb1_lower_omega_y);
    const REAL minus_limb1_upper_acc_still_z = t26 - t28;
    const REAL limb1_upper_acc_still_z = t27 - t26;
    const REAL minus_limb1_upper_rate_moment_y = limb_lower_mx * minus_limb1_upper_acc_still_z;
    const REAL t29 = limb1_upper_offset_x * (k7 * minus_limb1_lower_alpha_still_y + limb_lower_m * minus_limb1_upper_acc_still_z);
    const REAL t30 = minus_limb1_upper_rate_moment_y - t29;
    const REAL t32 = limb1_lower_cos * (t30 + (gravity_z_limb_lower_mx * limb1_U_0_sin + k11 * minus_limb1_lower_alpha_still_y));
    const REAL limb1_lower_alpha_still_x = limb1_U_v_1 * limb1_lower_omega_y;
    RESULT(checked0, load_, 0, t32 - limb1_lower_sin * (k10 * limb1_lower_alpha_still_x));
    const REAL limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y;
    const REAL t36 = limb1_upper_offset_x * limb1_lower_U_still_xy;
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    const REAL limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    const REAL minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y;
    const REAL limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y;
    const REAL t37 = t36 - minus_limb1_lower_acc_y;
    const REAL limb1_upper_force_moment_z = limb_lower_mx * minus_limb1_lower_acc_y;
    const REAL t35 = limb1_P_v * (2.0 * limb1_U_v_1);
    const REAL limb1_upper_acc_still_y = t35 + t37;
    const REAL limb1_upper_acc_still_y_2 = t36 + t35;
    const REAL minus_limb1_upper_rate_moment_z = limb_lower_mx * limb1_upper_acc_still_y;
    const REAL t38 = limb1_upper_offset_x * (limb_lower_mx * limb1_lower_U_still_xy - limb_lower_m * limb1_upper_acc_still_y);
    const REAL t39 = minus_limb1_upper_rate_moment_z + t38;
    RESULT(checked1, load_, 1, t39 - (k8 * limb1_lower_U_still_xy - limb1_upper_force_moment_z));
    const REAL minus_limb1_lower_U_still_xx = limb1_lower_omega_y * limb1_lower_omega_y + limb1_U_v_1 * limb1_U_v_1;
    const REAL minus_limb1_upper_acc_still_x = limb1_upper_offset_x * minus_limb1_lower_U_still_xx;
    const REAL minus_limb1_lower_force_x = limb_lower_m * (minus_limb1_upper_acc_still_x - limb1_lower_acc_x);
    RESULT(checked2, load_, 2, READ(u, 0) - (limb_lower_mx * minus_limb1_lower_U_still_xx - minus_limb1_lower_force_x));
    /* limb2: velocities, eq. (6); geometry */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3);
    const REAL limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin;
    /* limb2: accelerations; geometry; balance, eqs. (40)-(47) */
    const REAL limb2_U_v_1 = READ(v, 4);
    const REAL minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x;
    const REAL t45 = limb2_upper_offset_x * (2.0 * minus_limb2_lower_alpha_still_y);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL t46 = t45 - gravity_z * minus_limb2_U_0_cos;
    const REAL limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos;
    const REAL limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y;
    const REAL limb2_P_v = READ(v, 5);
    const REAL t44 = limb2_P_v * (2.0 * limb2_lower_omega_y);
    const REAL minus_limb2_upper_acc_still_z = t44 - t46;
    const REAL limb2_upper_acc_still_z = t45 - t44;
    const REAL minus_limb2_upper_rate_moment_y = limb_lower_mx * minus_limb2_upper_acc_still_z;
    const REAL t47 = limb2_upper_offset_x * (k7 * minus_limb2_lower_alpha_still_y + limb_lower_m * minus_limb2_upper_acc_still_z);
    const REAL t48 = minus_limb2_upper_rate_moment_y - t47;
    const REAL minus_limb2_lower_force_moment_y = t48 - (gravity_z_limb_lower_mx * minus_limb2_U_0_cos - k11 * minus_limb2_lower_alpha_still_y);
    const REAL t50 = limb2_lower_cos * minus_limb2_lower_force_moment_y;
    RESULT(checked3, load_, 3, t50 - limb2_lower_sin * (k10 * (limb2_U_v_1 * limb2_lower_omega_y)));
    const REAL t59 = limb2_lower_omega_y * limb2_lower_omega_y;
    const REAL t54 = limb2_upper_offset_x * limb2_lower_U_still_xy;
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y;
    const REAL minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y;
    const REAL t55 = t54 + limb2_lower_acc_y;
    const REAL minus_limb2_upper_force_moment_z = limb_lower_mx * limb2_lower_acc_y;
    const REAL t53 = limb2_P_v * (2.0 * limb2_U_v_1);
    const REAL limb2_upper_acc_still_y = t53 + t55;
    const REAL limb2_upper_acc_still_y_2 = t54 + t53;
    const REAL minus_limb2_upper_rate_moment_z = limb_lower_mx * limb2_upper_acc_still_y;
    const REAL t56 = limb2_upper_offset_x * (limb_lower_mx * limb2_lower_U_still_xy - limb_lower_m * limb2_upper_acc_still_y);
    const REAL t57 = minus_limb2_upper_rate_moment_z + t56;
    RESULT(checked0, load_, 4, t57 - (k8 * limb2_lower_U_still_xy + minus_limb2_upper_force_moment_z));
    const REAL minus_limb2_lower_U_still_xx = t59 + limb2_U_v_1 * limb2_U_v_1;
    const REAL minus_limb2_upper_acc_still_x = limb2_upper_offset_x * minus_limb2_lower_U_still_xx;
    const REAL minus_limb2_lower_force_x = limb_lower_m * (minus_limb2_upper_acc_still_x + minus_limb2_lower_acc_x);
    RESULT(checked1, load_, 5, READ(u, 1) - (limb_lower_mx * minus_limb2_lower_U_still_xx - minus_limb2_lower_force_x));
    /* limb3: velocities, eq. (6); geometry */
    const REAL limb3_U_v_0 = READ(v, 6), minus_limb3_lower_sin = SINES(sine, 5);
    const REAL minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin;
    /* limb3: accelerations; geometry; balance, eqs. (40)-(47) */
    const REAL limb3_U_v_1 = READ(v, 7);
    const REAL limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x;
    const REAL t64 = limb3_upper_offset_x * (2.0 * limb3_lower_alpha_still_y);
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL t65 = t64 - gravity_z * limb3_U_0_sin;
    const REAL limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos;
    const REAL minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y;
    const REAL limb3_P_v = READ(v, 8);
    const REAL t63 = limb3_P_v * (2.0 * limb3_lower_omega_y);
    const REAL minus_limb3_upper_acc_still_z = t63 + t65;
    const REAL minus_limb3_upper_acc_still_z_2 = t64 + t63;
    const REAL minus_limb3_upper_rate_moment_y = limb_lower_mx * minus_limb3_upper_acc_still_z;
    const REAL t66 = limb3_upper_offset_x * (k7 * limb3_lower_alpha_still_y - limb_lower_m * minus_limb3_upper_acc_still_z);
    const REAL t67 = minus_limb3_upper_rate_moment_y + t66;
    const REAL t69 = limb3_lower_cos * (t67 + (gravity_z_limb_lower_mx * limb3_U_0_sin - k11 * limb3_lower_alpha_still_y));
    RESULT(checked2, load_, 6, minus_limb3_lower_sin * (k10 * (limb3_U_v_1 * limb3_lower_omega_y)) + t69);
    const REAL t77 = limb3_lower_omega_y * limb3_lower_omega_y;
    const REAL t73 = limb3_upper_offset_x * minus_limb3_lower_U_still_xy;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y;
    const REAL limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y;
    const REAL t74 = t73 - limb3_lower_acc_y;
    const REAL minus_limb3_upper_force_moment_z = limb_lower_mx * limb3_lower_acc_y;
    const REAL t72 = limb3_P_v * (2.0 * limb3_U_v_1);
    const REAL limb3_upper_acc_still_y = t72 - t74;
    const REAL minus_limb3_upper_acc_still_y = t73 - t72;
    const REAL minus_limb3_upper_rate_moment_z = limb_lower_mx * limb3_upper_acc_still_y;
    const REAL t75 = limb3_upper_offset_x * (limb_lower_mx * minus_limb3_lower_U_still_xy + limb_lower_m * limb3_upper_acc_still_y);
    const REAL t76 = minus_limb3_upper_rate_moment_z - t75;
    RESULT(checked3, load_, 7, k8 * minus_limb3_lower_U_still_xy - minus_limb3_upper_force_moment_z + t76);
    const REAL minus_limb3_lower_U_still_xx = t77 + limb3_U_v_1 * limb3_U_v_1;
    const REAL minus_limb3_upper_acc_still_x = limb3_upper_offset_x * minus_limb3_lower_U_still_xx;
    const REAL minus_limb3_lower_force_x = limb_lower_m * (minus_limb3_upper_acc_still_x - limb3_lower_acc_x);
    RESULT(checked0, load_, 8, READ(u, 2) - (limb_lower_mx * minus_limb3_lower_U_still_xx - minus_limb3_lower_force_x));
    /* limb4: velocities, eq. (6); geometry */
    const REAL limb4_U_v_0 = READ(v, 9), minus_limb4_lower_sin = SINES(sine, 7);
    const REAL minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin;
    /* limb4: accelerations; geometry; balance, eqs. (40)-(47) */
    const REAL limb4_U_v_1 = READ(v, 10);
    const REAL limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x;
    const REAL t82 = limb4_upper_offset_x * (2.0 * limb4_lower_alpha_still_y);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL t83 = t82 + gravity_z * minus_limb4_U_0_cos;
    const REAL limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos;
    const REAL minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y;
    const REAL limb4_P_v = READ(v, 11);
    const REAL t81 = limb4_P_v * (2.0 * limb4_lower_omega_y);
    const REAL minus_limb4_upper_acc_still_z = t81 + t83;
    const REAL minus_limb4_upper_acc_still_z_2 = t82 + t81;
    const REAL minus_limb4_upper_rate_moment_y = limb_lower_mx * minus_limb4_upper_acc_still_z;
    const REAL t84 = limb4_upper_offset_x * (k7 * limb4_lower_alpha_still_y - limb_lower_m * minus_limb4_upper_acc_still_z);
    const REAL t85 = minus_limb4_upper_rate_moment_y + t84;
    const REAL t87 = limb4_lower_cos * (t85 - (gravity_z_limb_lower_mx * minus_limb4_U_0_cos + k11 * limb4_lower_alpha_still_y));
    RESULT(checked1, load_, 9, minus_limb4_lower_sin * (k10 * (limb4_U_v_1 * limb4_lower_omega_y)) + t87);
    const REAL t95 = limb4_lower_omega_y * limb4_lower_omega_y;
    const REAL t91 = limb4_upper_offset_x * minus_limb4_lower_U_still_xy;
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y;
    const REAL minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y;
    const REAL t92 = t91 + minus_limb4_lower_acc_y;
    const REAL limb4_upper_force_moment_z = limb_lower_mx * minus_limb4_lower_acc_y;
    const REAL t90 = limb4_P_v * (2.0 * limb4_U_v_1);
    const REAL limb4_upper_acc_still_y = t90 - t92;
    const REAL minus_limb4_upper_acc_still_y = t91 - t90;
    const REAL minus_limb4_upper_rate_moment_z = limb_lower_mx * limb4_upper_acc_still_y;
    const REAL t93 = limb4_upper_offset_x * (limb_lower_mx * minus_limb4_lower_U_still_xy + limb_lower_m * limb4_upper_acc_still_y);
    const REAL t94 = minus_limb4_upper_rate_moment_z - t93;
    RESULT(checked2, load_, 10, k8 * minus_limb4_lower_U_still_xy + limb4_upper_force_moment_z + t94);
    const REAL minus_limb4_lower_U_still_xx = t95 + limb4_U_v_1 * limb4_U_v_1;
    const REAL minus_limb4_upper_acc_still_x = limb4_upper_offset_x * minus_limb4_lower_U_still_xx;
    const REAL minus_limb4_lower_force_x = limb_lower_m * (minus_limb4_upper_acc_still_x + minus_limb4_lower_acc_x);
    RESULT(checked3, load_, 11, READ(u, 3) - (limb_lower_mx * minus_limb4_lower_U_still_xx - minus_limb4_lower_force_x));
    /* limb5_S: geometry; reciprocal wrenches, eq. (10); loop closure */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t97 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t98 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t99 = t97 + t98;
    const REAL t100 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t101 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t102 = t100 + t101;
    const REAL t103 = t99 + t102;
    const REAL t105 = 4.0 - 2.0 * t103;
    const REAL platform_turn_xx = 1.0 - t102 * t105;
    const REAL t234 = t98 + t100;
    const REAL platform_turn_yy = 1.0 - t105 * (t98 + t101);
    const REAL platform_turn_zz = 1.0 - t105 * t234;
    const REAL t106 = limb5_S_q_qz * t105;
    const REAL t107 = limb5_S_q_qy * t106;
    const REAL t109 = limb5_S_q_qw * (limb5_S_q_qx * t105);
    const REAL t113 = limb5_S_q_qy * t105;
    const REAL platform_turn_zy = t107 + t109;
    const REAL platform_turn_yz = t107 - t109;
    const REAL limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14);
    RESULT(checked0, load_, 12, gravity_z_platform_mz * platform_turn_zy - k12 * (limb5_S_v_wy * limb5_S_v_wz));
    const REAL t112 = limb5_S_q_qx * t106;
    const REAL t125 = limb5_S_q_qw * t106;
    const REAL t114 = limb5_S_q_qw * t113;
    const REAL t124 = limb5_S_q_qx * t113;
    const REAL platform_turn_zx = t112 - t114;
    const REAL platform_turn_xz = t112 + t114;
    const REAL limb5_S_v_wx = READ(v, 12);
    RESULT(checked1, load_, 13, k12 * (limb5_S_v_wx * limb5_S_v_wz) - gravity_z_platform_mz * platform_turn_zx);
    const REAL t115 = limb1_lower_cos * limb1_upper_offset_x; /* limb1 */
    RESULT(checked2, closure_, 2, -t115);
    const REAL t127 = limb2_lower_cos * limb2_upper_offset_x; /* limb2 */
    RESULT(checked3, closure_, 45, -t127);
    const REAL t128 = limb3_lower_cos * limb3_upper_offset_x; /* limb3 */
    RESULT(checked0, closure_, 87, -t128);
    const REAL t129 = limb4_lower_cos * limb4_upper_offset_x; /* limb4 */
    RESULT(checked1, closure_, 129, -t129);
    const REAL platform_turn_yx = t124 + t125;
    const REAL platform_turn_xy = t124 - t125;
    const REAL base_lever_moment_y_by_limb1_U2_fx = param_R * (limb1_U_0_cos * limb1_lower_cos);
    const REAL t130 = platform_turn_yx * base_lever_moment_y_by_limb1_U2_fx;
    const REAL base_lever_moment_z_by_limb1_U2_fx = param_R * (limb1_U_0_sin * limb1_lower_cos);
    RESULT(checked2, closure_, 156, -(t130 + platform_turn_zx * base_lever_moment_z_by_limb1_U2_fx));
    const REAL base_lever_moment_y_by_limb1_U2_fy = limb1_U_0_cos * limb1_upper_offset_x - param_R * (limb1_U_0_cos * limb1_lower_sin);
    const REAL t135 = platform_turn_yx * base_lever_moment_y_by_limb1_U2_fy;
    const REAL base_lever_moment_z_by_limb1_U2_fy = limb1_U_0_sin * limb1_upper_offset_x - param_R * (limb1_U_0_sin * limb1_lower_sin);
    RESULT(checked3, closure_, 157, -(t135 + platform_turn_zx * base_lever_moment_z_by_limb1_U2_fy));
    /* limb1: geometry */
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL base_lever_moment_y_by_limb1_U2_fz = limb1_U_0_sin * minus_limb1_upper_position_x;
    const REAL minus_base_lever_moment_z_by_limb1_U2_fz = limb1_U_0_cos * minus_limb1_upper_position_x;
    const REAL t143 = platform_turn_xx * t115 - platform_turn_yx * base_lever_moment_y_by_limb1_U2_fz; /* mechanism */
    RESULT(checked0, closure_, 158, t143 + platform_turn_zx * minus_base_lever_moment_z_by_limb1_U2_fz);
    /* limb1: reciprocal wrenches, eq. (10); loop closure */
    const REAL t122 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy;
    const REAL t327 = limb1_lower_sin * t122;
    const REAL limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t122 - limb1_lower_sin * platform_turn_xy;
    WRITE(closure_, 16, limb1_U2_constraint_mn_couple_z);
    const REAL t146 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL limb1_U_0_lever_moment_y_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x;
    /* mechanism: reciprocal wrenches, eq. (10); loop closure; velocities, eq. (6) */
    const REAL base_lever_moment_y_by_limb1_U2_mn = t146 - limb1_U_0_sin * limb1_U_0_lever_moment_y_by_limb1_U2_mn;
    const REAL t151 = limb1_U_0_cos * limb1_U_0_lever_moment_y_by_limb1_U2_mn; /* limb1 */
    const REAL t148 = platform_turn_yx * base_lever_moment_y_by_limb1_U2_mn;
    const REAL limb1_U_0_lever_moment_z_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    WRITE(closure_, 3, limb1_U_0_lever_moment_z_by_limb1_U2_mn);
    const REAL t149 = platform_turn_xx * limb1_U_0_lever_moment_z_by_limb1_U2_mn + t148;
    const REAL base_lever_moment_z_by_limb1_U2_mn = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z + t151;
    RESULT(checked1, closure_, 159, -(t149 + platform_turn_zx * base_lever_moment_z_by_limb1_U2_mn));
    const REAL minus_base_lever_moment_z_by_limb2_S_fx = param_R * (minus_limb2_U_0_cos * limb2_lower_cos);
    const REAL t154 = platform_turn_zx * minus_base_lever_moment_z_by_limb2_S_fx;
    const REAL base_lever_moment_x_by_limb2_S_fx = param_R * (limb2_U_0_sin * limb2_lower_cos);
    RESULT(checked2, closure_, 160, t154 - platform_turn_xx * base_lever_moment_x_by_limb2_S_fx);
    const REAL minus_base_lever_moment_z_by_limb2_S_fy = minus_limb2_U_0_cos * limb2_upper_offset_x - param_R * (minus_limb2_U_0_cos * limb2_lower_sin);
    const REAL t158 = platform_turn_zx * minus_base_lever_moment_z_by_limb2_S_fy;
    const REAL base_lever_moment_x_by_limb2_S_fy = limb2_U_0_sin * limb2_upper_offset_x - param_R * (limb2_U_0_sin * limb2_lower_sin);
    RESULT(checked3, closure_, 161, t158 - platform_turn_xx * base_lever_moment_x_by_limb2_S_fy);
    const REAL t162 = platform_turn_yx * t127;
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL base_lever_moment_x_by_limb2_S_fz = minus_limb2_U_0_cos * minus_limb2_upper_position_y;
    const REAL base_lever_moment_z_by_limb2_S_fz = limb2_U_0_sin * minus_limb2_upper_position_y;
    const REAL t164 = t162 - platform_turn_xx * base_lever_moment_x_by_limb2_S_fz;
    RESULT(checked0, closure_, 162, t164 - platform_turn_zx * base_lever_moment_z_by_limb2_S_fz);
    const REAL minus_base_lever_moment_y_by_limb3_S_fx = param_R * (limb3_U_0_cos * limb3_lower_cos);
    const REAL t166 = platform_turn_yx * minus_base_lever_moment_y_by_limb3_S_fx;
    const REAL minus_base_lever_moment_z_by_limb3_S_fx = param_R * (limb3_U_0_sin * limb3_lower_cos);
    RESULT(checked1, closure_, 163, t166 + platform_turn_zx * minus_base_lever_moment_z_by_limb3_S_fx);
    const REAL base_lever_moment_y_by_limb3_S_fy = limb3_U_0_cos * limb3_upper_offset_x - param_R * (limb3_U_0_cos * minus_limb3_lower_sin);
    const REAL t170 = platform_turn_yx * base_lever_moment_y_by_limb3_S_fy;
    const REAL base_lever_moment_z_by_limb3_S_fy = limb3_U_0_sin * limb3_upper_offset_x - param_R * (limb3_U_0_sin * minus_limb3_lower_sin);
    RESULT(checked2, closure_, 164, -(t170 + platform_turn_zx * base_lever_moment_z_by_limb3_S_fy));
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL minus_base_lever_moment_y_by_limb3_S_fz = limb3_U_0_sin * limb3_upper_position_x;
    const REAL base_lever_moment_z_by_limb3_S_fz = limb3_U_0_cos * limb3_upper_position_x;
    const REAL t178 = platform_turn_xx * t128 + platform_turn_yx * minus_base_lever_moment_y_by_limb3_S_fz;
    RESULT(checked3, closure_, 165, t178 - platform_turn_zx * base_lever_moment_z_by_limb3_S_fz);
    const REAL base_lever_moment_z_by_limb4_S_fx = param_R * (minus_limb4_U_0_cos * limb4_lower_cos);
    const REAL t181 = platform_turn_zx * base_lever_moment_z_by_limb4_S_fx;
    const REAL minus_base_lever_moment_x_by_limb4_S_fx = param_R * (limb4_U_0_sin * limb4_lower_cos);
    RESULT(checked0, closure_, 166, platform_turn_xx * minus_base_lever_moment_x_by_limb4_S_fx - t181);
    const REAL t182 = minus_limb4_U_0_cos * limb4_upper_offset_x; /* limb4 */
    const REAL minus_base_lever_moment_z_by_limb4_S_fy = t182 - param_R * (minus_limb4_U_0_cos * minus_limb4_lower_sin);
    const REAL t184 = platform_turn_zx * minus_base_lever_moment_z_by_limb4_S_fy;
    const REAL base_lever_moment_x_by_limb4_S_fy = limb4_U_0_sin * limb4_upper_offset_x - param_R * (limb4_U_0_sin * minus_limb4_lower_sin);
    RESULT(checked1, closure_, 167, t184 - platform_turn_xx * base_lever_moment_x_by_limb4_S_fy);
    const REAL t188 = platform_turn_yx * t129;
    const REAL t276 = limb5_S_v_wx * platform_turn_yx;
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL minus_base_lever_moment_x_by_limb4_S_fz = minus_limb4_U_0_cos * limb4_upper_position_y;
    const REAL minus_base_lever_moment_z_by_limb4_S_fz = limb4_U_0_sin * limb4_upper_position_y;
    /* mechanism: loop closure; velocities, eq. (6) */
    const REAL t191 = t188 + platform_turn_xx * minus_base_lever_moment_x_by_limb4_S_fz;
    const REAL t287 = limb5_S_v_wx * platform_turn_xx;
    RESULT(checked2, closure_, 168, t191 + platform_turn_zx * minus_base_lever_moment_z_by_limb4_S_fz);
    const REAL t281 = limb5_S_v_wx * platform_turn_zx;
    const REAL t194 = platform_turn_zy * base_lever_moment_z_by_limb1_U2_fx;
    const REAL t236 = platform_turn_zz * base_lever_moment_z_by_limb1_U2_fx;
    RESULT(checked3, closure_, 169, -(platform_turn_yy * base_lever_moment_y_by_limb1_U2_fx + t194));
    RESULT(checked0, closure_, 182, -(platform_turn_yz * base_lever_moment_y_by_limb1_U2_fx + t236));
    const REAL t197 = platform_turn_zy * base_lever_moment_z_by_limb1_U2_fy;
    const REAL t239 = platform_turn_zz * base_lever_moment_z_by_limb1_U2_fy;
    RESULT(checked1, closure_, 170, -(platform_turn_yy * base_lever_moment_y_by_limb1_U2_fy + t197));
    RESULT(checked2, closure_, 183, -(platform_turn_yz * base_lever_moment_y_by_limb1_U2_fy + t239));
    const REAL t201 = platform_turn_xy * t115 - platform_turn_yy * base_lever_moment_y_by_limb1_U2_fz;
    const REAL t243 = platform_turn_xz * t115 - platform_turn_yz * base_lever_moment_y_by_limb1_U2_fz;
    RESULT(checked3, closure_, 171, t201 + platform_turn_zy * minus_base_lever_moment_z_by_limb1_U2_fz);
    RESULT(checked0, closure_, 184, t243 + platform_turn_zz * minus_base_lever_moment_z_by_limb1_U2_fz);
    const REAL t204 = platform_turn_yy * base_lever_moment_y_by_limb1_U2_mn;
    const REAL t246 = platform_turn_yz * base_lever_moment_y_by_limb1_U2_mn;
    const REAL t205 = platform_turn_xy * limb1_U_0_lever_moment_z_by_limb1_U2_mn + t204;
    const REAL t247 = platform_turn_xz * limb1_U_0_lever_moment_z_by_limb1_U2_mn + t246;
    RESULT(checked1, closure_, 172, -(t205 + platform_turn_zy * base_lever_moment_z_by_limb1_U2_mn));
    RESULT(checked2, closure_, 185, -(t247 + platform_turn_zz * base_lever_moment_z_by_limb1_U2_mn));
    const REAL t208 = platform_turn_zy * minus_base_lever_moment_z_by_limb2_S_fx;
    const REAL t250 = platform_turn_zz * minus_base_lever_moment_z_by_limb2_S_fx;
    RESULT(checked3, closure_, 173, t208 - platform_turn_xy * base_lever_moment_x_by_limb2_S_fx);
    RESULT(checked0, closure_, 186, t250 - platform_turn_xz * base_lever_moment_x_by_limb2_S_fx);
    const REAL t210 = platform_turn_zy * minus_base_lever_moment_z_by_limb2_S_fy;
    const REAL t252 = platform_turn_zz * minus_base_lever_moment_z_by_limb2_S_fy;
    RESULT(checked1, closure_, 174, t210 - platform_turn_xy * base_lever_moment_x_by_limb2_S_fy);
    RESULT(checked2, closure_, 187, t252 - platform_turn_xz * base_lever_moment_x_by_limb2_S_fy);
    const REAL t214 = platform_turn_yy * t127 - platform_turn_xy * base_lever_moment_x_by_limb2_S_fz;
    const REAL t256 = platform_turn_yz * t127 - platform_turn_xz * base_lever_moment_x_by_limb2_S_fz;
    RESULT(checked3, closure_, 175, t214 - platform_turn_zy * base_lever_moment_z_by_limb2_S_fz);
    RESULT(checked0, closure_, 188, t256 - platform_turn_zz * base_lever_moment_z_by_limb2_S_fz);
    const REAL t217 = platform_turn_zy * minus_base_lever_moment_z_by_limb3_S_fx;
    const REAL t259 = platform_turn_zz * minus_base_lever_moment_z_by_limb3_S_fx;
    RESULT(checked1, closure_, 176, platform_turn_yy * minus_base_lever_moment_y_by_limb3_S_fx + t217);
    RESULT(checked2, closure_, 189, platform_turn_yz * minus_base_lever_moment_y_by_limb3_S_fx + t259);
    const REAL t219 = platform_turn_zy * base_lever_moment_z_by_limb3_S_fy;
    const REAL t261 = platform_turn_zz * base_lever_moment_z_by_limb3_S_fy;
    RESULT(checked3, closure_, 177, -(platform_turn_yy * base_lever_moment_y_by_limb3_S_fy + t219));
    RESULT(checked0, closure_, 190, -(platform_turn_yz * base_lever_moment_y_by_limb3_S_fy + t261));
    const REAL t223 = platform_turn_xy * t128 + platform_turn_yy * minus_base_lever_moment_y_by_limb3_S_fz;
    const REAL t265 = platform_turn_xz * t128 + platform_turn_yz * minus_base_lever_moment_y_by_limb3_S_fz;
    RESULT(checked1, closure_, 178, t223 - platform_turn_zy * base_lever_moment_z_by_limb3_S_fz);
    RESULT(checked2, closure_, 191, t265 - platform_turn_zz * base_lever_moment_z_by_limb3_S_fz);
    const REAL t225 = platform_turn_xy * minus_base_lever_moment_x_by_limb4_S_fx;
    const REAL t267 = platform_turn_xz * minus_base_lever_moment_x_by_limb4_S_fx;
    RESULT(checked3, closure_, 179, t225 - platform_turn_zy * base_lever_moment_z_by_limb4_S_fx);
    RESULT(checked0, closure_, 192, t267 - platform_turn_zz * base_lever_moment_z_by_limb4_S_fx);
    const REAL t227 = platform_turn_zy * minus_base_lever_moment_z_by_limb4_S_fy;
    const REAL t269 = platform_turn_zz * minus_base_lever_moment_z_by_limb4_S_fy;
    RESULT(checked1, closure_, 180, t227 - platform_turn_xy * base_lever_moment_x_by_limb4_S_fy);
    RESULT(checked2, closure_, 193, t269 - platform_turn_xz * base_lever_moment_x_by_limb4_S_fy);
    const REAL t290 = limb5_S_v_wz * platform_turn_xz;
    const REAL t231 = platform_turn_yy * t129 + platform_turn_xy * minus_base_lever_moment_x_by_limb4_S_fz;
    const REAL t273 = platform_turn_yz * t129 + platform_turn_xz * minus_base_lever_moment_x_by_limb4_S_fz;
    const REAL platform_twist_angular_y = limb5_S_v_wy * platform_turn_yy + t276 + limb5_S_v_wz * platform_turn_yz;
    RESULT(checked3, closure_, 181, t231 + platform_turn_zy * minus_base_lever_moment_z_by_limb4_S_fz);
    RESULT(checked0, closure_, 194, t273 + platform_turn_zz * minus_base_lever_moment_z_by_limb4_S_fz);
    const REAL platform_twist_angular_z = limb5_S_v_wz * platform_turn_zz + (t281 + limb5_S_v_wy * platform_turn_zy);
    /* limb1: loop closure; reciprocal wrenches, eq. (10) */
    const REAL t285 = limb1_U_0_sin * platform_twist_angular_y - limb1_U_0_cos * platform_twist_angular_z;
    const REAL t293 = limb1_lower_cos * t285;
    const REAL t286 = limb1_lower_sin * t285;
    const REAL platform_twist_angular_x = t287 + limb5_S_v_wy * platform_turn_xy + t290;
    const REAL limb1_U2_opening_mn = t327 + limb1_lower_cos * platform_turn_xy;
    const REAL t295 = t293 - limb1_lower_sin * platform_twist_angular_x;
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL t296 = minus_limb1_U2_arm_y * t295;
    const REAL t292 = t286 + limb1_lower_cos * platform_twist_angular_x;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL t299 = t296 - limb1_U2_arm_x * t292;
    const REAL t300 = t292 * t299;
    const REAL t309 = t295 * t299;
    const REAL t303 = limb1_U_0_cos * platform_twist_angular_y + limb1_U_0_sin * platform_twist_angular_z;
    const REAL t304 = limb1_U2_arm_x * t303;
    const REAL t307 = minus_limb1_U2_arm_y * t303;
    RESULT(checked1, curvature_, 0, -(minus_limb1_upper_acc_still_x + (t300 - t303 * t304)));
    const REAL t311 = t295 * t304;
    const REAL t322 = limb1_lower_omega_x + t295;
    RESULT(checked2, curvature_, 1, limb1_upper_acc_still_y_2 - (t303 * t307 + t309));
    RESULT(checked3, curvature_, 2, limb1_upper_acc_still_z + (t311 + t292 * t307));
    const REAL t316 = limb1_lower_omega_y - t292;
    const REAL t314 = limb1_U_v_1 - t303;
    const REAL t320 = limb1_U2_constraint_mn_couple_x * (limb1_lower_alpha_still_x - (limb1_lower_omega_y * t314 - limb1_U_v_1 * t316));
    const REAL t326 = t320 - limb1_U2_constraint_mn_couple_z * (limb1_lower_omega_x * t316 - limb1_lower_omega_y * t322);
    const REAL t332 = t322 * (limb1_U2_opening_mn * t322 + limb1_U2_constraint_mn_couple_z * t316);
    RESULT(checked0, curvature_, 3, t326 - (t332 - t314 * (limb1_U2_constraint_mn_couple_x * t316 - limb1_U2_opening_mn * t314)));
    /* limb2: loop closure; reciprocal wrenches, eq. (10) */
    const REAL t340 = limb2_U_0_sin * platform_twist_angular_z + minus_limb2_U_0_cos * platform_twist_angular_x;
    const REAL t341 = limb2_lower_sin * t340;
    const REAL t346 = limb2_lower_cos * t340 - limb2_lower_sin * platform_twist_angular_y;
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL t347 = minus_limb2_S_arm_y * t346;
    const REAL t343 = t341 + limb2_lower_cos * platform_twist_angular_y;
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t350 = t347 - limb2_S_arm_x * t343;
    const REAL t351 = t343 * t350;
    const REAL t360 = t346 * t350;
    const REAL t354 = minus_limb2_U_0_cos * platform_twist_angular_z - limb2_U_0_sin * platform_twist_angular_x;
    const REAL t355 = limb2_S_arm_x * t354;
    const REAL t358 = minus_limb2_S_arm_y * t354;
    const REAL t362 = t346 * t355;
    RESULT(checked1, curvature_, 4, -(minus_limb2_upper_acc_still_x + (t351 - t354 * t355)));
    RESULT(checked2, curvature_, 5, limb2_upper_acc_still_y_2 - (t354 * t358 + t360));
    RESULT(checked3, curvature_, 6, limb2_upper_acc_still_z - (t362 + t343 * t358));
    /* limb3: loop closure; reciprocal wrenches, eq. (10) */
    const REAL t367 = limb3_U_0_sin * platform_twist_angular_y - limb3_U_0_cos * platform_twist_angular_z;
    const REAL t368 = minus_limb3_lower_sin * t367;
    const REAL t373 = limb3_lower_cos * t367 + minus_limb3_lower_sin * platform_twist_angular_x;
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL t374 = limb3_S_arm_y * t373;
    const REAL t370 = t368 - limb3_lower_cos * platform_twist_angular_x;
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t377 = t374 - limb3_S_arm_x * t370;
    const REAL t378 = t370 * t377;
    const REAL t387 = t373 * t377;
    const REAL t381 = limb3_U_0_cos * platform_twist_angular_y + limb3_U_0_sin * platform_twist_angular_z;
    const REAL t382 = limb3_S_arm_x * t381;
    const REAL t385 = limb3_S_arm_y * t381;
    const REAL t389 = t373 * t382;
    RESULT(checked0, curvature_, 7, -(minus_limb3_upper_acc_still_x + (t378 - t381 * t382)));
    RESULT(checked1, curvature_, 8, t381 * t385 + t387 - minus_limb3_upper_acc_still_y);
    RESULT(checked2, curvature_, 9, t389 + t370 * t385 - minus_limb3_upper_acc_still_z_2);
    /* limb4: loop closure; reciprocal wrenches, eq. (10) */
    const REAL t406 = minus_limb4_U_0_cos * platform_twist_angular_z;
    const REAL t394 = limb4_U_0_sin * platform_twist_angular_z + minus_limb4_U_0_cos * platform_twist_angular_x;
    const REAL t408 = t406 - limb4_U_0_sin * platform_twist_angular_x;
    const REAL t395 = minus_limb4_lower_sin * t394;
    const REAL t400 = limb4_lower_cos * t394 + minus_limb4_lower_sin * platform_twist_angular_y;
    const REAL t397 = t395 - limb4_lower_cos * platform_twist_angular_y;
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL t401 = limb4_S_arm_y * t400;
    const REAL t412 = limb4_S_arm_y * t408;
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t404 = t401 - limb4_S_arm_x * t397;
    const REAL t409 = limb4_S_arm_x * t408;
    const REAL t414 = t400 * t404;
    const REAL t416 = t400 * t409;
    RESULT(checked3, curvature_, 10, -(minus_limb4_upper_acc_still_x + (t397 * t404 - t408 * t409)));
    RESULT(checked0, curvature_, 11, t408 * t412 + t414 - minus_limb4_upper_acc_still_y);
    RESULT(checked1, curvature_, 12, -(minus_limb4_upper_acc_still_z_2 + (t416 + t397 * t412)));
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
    const double x2 = q[2], x5 = q[5], x8 = q[8], x11 = q[11], x12 = q[12], x13 = q[13], x14 = q[14], x15 =
        q[15];
    const double x16 = v[0], x17 = v[1], x18 = v[2], x19 = v[3], x20 = v[4], x21 = v[5], x22 = v[6], x23 =
        v[7];
    const double x24 = v[8], x25 = v[9], x26 = v[10], x27 = v[11], x28 = v[12], x29 = v[13], x30 = v[14];
    const double x31 = u[0], x32 = u[1], x33 = u[2], x34 = u[3], x51 = sine[0], x35 = cosine[0], x60 =
        sine[1];
    const double x37 = cosine[1], x252 = sine[2], x253 = cosine[2], x255 = sine[3], x259 = cosine[3];
    const double x395 = sine[4], x232 = cosine[4], x234 = sine[5], x238 = cosine[5], x196 = sine[6];
    const double x197 = cosine[6], x199 = sine[7], x203 = cosine[7];
    const double x38 = x12 * x12;
    const double x39 = x13 * x13;
    const double x40 = x38 + x39;
    const double x41 = x14 * x14;
    const double x42 = x15 * x15;
    const double x43 = x41 + x42;
    const double x44 = x40 + x43;
    const double x45 = 2.0 * x44;
    const double x46 = 4.0 - x45;
    const double x47 = x39 + x42;
    const double x98 = x39 + x41;
    const double x48 = x46 * x47;
    const double x49 = 1.0 - x48;
    const double x128 = x43 * x46;
    const double x129 = 1.0 - x128;
    const double x99 = x46 * x98;
    const double x100 = 1.0 - x99;
    const double x75 = x14 * x46;
    const double x76 = x13 * x75;
    const double x103 = x12 * x75;
    const double x52 = x15 * x46;
    const double x54 = x13 * x46;
    const double x55 = x12 * x54;
    const double x77 = x12 * x52;
    const double x91 = x76 + x77;
    const double x78 = x76 - x77;
    const double x92 = x28 * x91;
    const double x90 = x29 * x49;
    const double x93 = x90 + x92;
    const double x53 = x14 * x52;
    const double x102 = x13 * x52;
    const double x94 = x53 - x55;
    const double x56 = x53 + x55;
    const double x95 = x30 * x94;
    const double x96 = x93 + x95;
    const double x131 = x29 * x78;
    const double x130 = x28 * x129;
    const double x132 = x130 + x131;
    const double x133 = x102 + x103;
    const double x104 = x102 - x103;
    const double x134 = x30 * x133;
    const double x135 = x132 + x134;
    const three_ups_upu_s_vector4 xgathered0 = {x51, x252, x395, x196};
    const three_ups_upu_s_vector4 xgathered1 = {x96, x135, x96, x135};
    const three_ups_upu_s_vector4 xpack19 = xgathered0 * xgathered1;
    const double x105 = x28 * x104;
    const double x106 = x29 * x56;
    const double x107 = x105 + x106;
    const double x101 = x30 * x100;
    const double x108 = x101 + x107;
    const three_ups_upu_s_vector4 xgathered2 = {x35, x253, x232, x197};
    const three_ups_upu_s_vector4 xgathered3 = {x108, x108, x108, x108};
    const three_ups_upu_s_vector4 xpack20 = xgathered2 * xgathered3;
    const three_ups_upu_s_vector4 xpack21 = xpack19 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack20;
    const three_ups_upu_s_vector4 xpack9 = xgathered0 * xgathered3;
    const three_ups_upu_s_vector4 xgathered4 = {x16, x19, x22, x25};
    const three_ups_upu_s_vector4 xpack30 = xgathered4 * xpack21;
    const three_ups_upu_s_vector4 xgathered5 = {x2, x5, x8, x11};
    const three_ups_upu_s_vector4 xpack0 = xgathered5 + (three_ups_upu_s_vector4){0.3, 0.3, 0.3, 0.3};
    const three_ups_upu_s_vector4 xgathered6 = {x60, x255, x234, x199};
    const three_ups_upu_s_vector4 xpack5 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered6;
    const three_ups_upu_s_vector4 xpack6 = xpack0 - xpack5;
    const three_ups_upu_s_vector4 xpack31 = xpack6 * xpack30;
    const three_ups_upu_s_vector4 xgathered7 = {x17, x20, x23, x26};
    const three_ups_upu_s_vector4 xgathered8 = {x18, x21, x24, x27};
    const three_ups_upu_s_vector4 xpack32 = xgathered7 * xgathered8;
    const three_ups_upu_s_vector4 xpack33 = xpack31 + xpack32;
    const three_ups_upu_s_vector4 xpack8 = xgathered2 * xgathered1;
    const three_ups_upu_s_vector4 xpack10 = xpack8 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack9;
    const three_ups_upu_s_vector4 xgathered9 = {x37, x259, x238, x203};
    const three_ups_upu_s_vector4 xpack23 = xgathered7 * xgathered9;
    const three_ups_upu_s_vector4 xpack34 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack23;
    const three_ups_upu_s_vector4 xpack35 = xgathered8 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack34;
    const three_ups_upu_s_vector4 xpack36 = xpack10 * xpack35;
    const three_ups_upu_s_vector4 xpack37 = xpack33 - xpack36;
    const three_ups_upu_s_vector4 xpack24 = xpack0 * xpack23;
    const three_ups_upu_s_vector4 xpack3 = xgathered9 * xpack0;
    const three_ups_upu_s_vector4 xpack4 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack3;
    const three_ups_upu_s_vector4 xpack7 = xgathered9 * xpack4;
    const three_ups_upu_s_vector4 xpack108 = xpack37 * xpack7;
    const three_ups_upu_s_vector4 xpack39 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack0;
    const three_ups_upu_s_vector4 xpack40 = xpack39 - (three_ups_upu_s_vector4){0.426, 0.426, 0.426, 0.426};
    const three_ups_upu_s_vector4 xpack69 = xpack39 + xpack40;
    const three_ups_upu_s_vector4 xpack41 = xpack0 * xpack40;
    const three_ups_upu_s_vector4 xpack105 = xpack32 * xpack69;
    const three_ups_upu_s_vector4 xpack53 = xpack41 + (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439,
        2.3439};
    const three_ups_upu_s_vector4 xpack42 = xpack41 - (three_ups_upu_s_vector4){(-2.2727), (-2.2727),
        (-2.2727), (-2.2727)};
    const three_ups_upu_s_vector4 xpack109 = xpack53 * xpack108;
    const three_ups_upu_s_vector4 xpack43 = xgathered9 * xpack42;
    const three_ups_upu_s_vector4 xpack64 = xgathered6 * xpack42;
    const three_ups_upu_s_vector4 xpack65 = xgathered9 * xpack64;
    const three_ups_upu_s_vector4 xpack63 = xgathered6 * xpack43;
    const three_ups_upu_s_vector4 xpack66 = xpack63 + xpack65;
    const three_ups_upu_s_vector4 xpack44 = xgathered9 * xpack43;
    const three_ups_upu_s_vector4 xpack45 = xpack44 + (three_ups_upu_s_vector4){0.1112, 0.1112, 0.1112,
        0.1112};
    const three_ups_upu_s_vector4 xpack103 = (three_ups_upu_s_vector4){0.5, 0.5, 0.5, 0.5} * xpack66;
    const three_ups_upu_s_vector4 xpack85 = xgathered4 * xgathered4;
    const three_ups_upu_s_vector4 xpack104 = xpack85 * xpack103;
    const three_ups_upu_s_vector4 xpack106 = xpack105 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack104;
    const three_ups_upu_s_vector4 xpack81 = (three_ups_upu_s_vector4){9.81, 9.81, 9.81, 9.81} * xgathered2;
    const three_ups_upu_s_vector4 xpack100 = xgathered6 * xpack81;
    const three_ups_upu_s_vector4 xpack101 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack100;
    const three_ups_upu_s_vector4 xpack102 = xpack0 * xpack101;
    const three_ups_upu_s_vector4 xpack107 = xpack106 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, (-1.0)} *
        xpack102;
    const three_ups_upu_s_vector4 xpack110 = xpack109 - xpack107;
    const three_ups_upu_s_vector4 xpack82 = xgathered9 * xpack81;
    const three_ups_upu_s_vector4 xpack83 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack82;
    const three_ups_upu_s_vector4 xgathered10 = {x31, x32, x33, x34};
    const three_ups_upu_s_vector4 xpack84 = xgathered10 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0}
        * xpack83;
    const three_ups_upu_s_vector4 xpack52 = xpack6 * xpack7;
    const three_ups_upu_s_vector4 xpack111 = xpack52 * xpack110;
    const three_ups_upu_s_vector4 xpack54 = xpack53 * xpack52;
    const three_ups_upu_s_vector4 xpack55 = xpack52 * xpack54;
    const three_ups_upu_s_vector4 xpack49 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered9;
    const three_ups_upu_s_vector4 xpack93 = xpack49 * xpack30;
    const three_ups_upu_s_vector4 xpack13 = xgathered7 * xgathered6;
    const three_ups_upu_s_vector4 xpack94 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack13;
    const three_ups_upu_s_vector4 xpack95 = xpack10 * xpack94;
    const three_ups_upu_s_vector4 xpack96 = xpack93 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack95;
    const three_ups_upu_s_vector4 xpack14 = xpack0 * xpack13;
    const three_ups_upu_s_vector4 xpack97 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack96;
    const three_ups_upu_s_vector4 xpack70 = xgathered9 * xpack69;
    const three_ups_upu_s_vector4 xpack71 = xgathered9 * xpack70;
    const three_ups_upu_s_vector4 xpack89 = (three_ups_upu_s_vector4){0.5, 0.5, 0.5, 0.5} * xpack69;
    const three_ups_upu_s_vector4 xpack86 = (three_ups_upu_s_vector4){0.5, 0.5, 0.5, 0.5} * xpack71;
    const three_ups_upu_s_vector4 xpack87 = xpack85 * xpack86;
    const three_ups_upu_s_vector4 xpack88 = xgathered7 * xgathered7;
    const three_ups_upu_s_vector4 xpack90 = xpack88 * xpack89;
    const three_ups_upu_s_vector4 xpack91 = xpack87 + xpack90;
    const three_ups_upu_s_vector4 xpack92 = xpack91 + xpack84;
    const three_ups_upu_s_vector4 xpack98 = xpack97 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack92;
    const three_ups_upu_s_vector4 xpack99 = xpack49 * xpack98;
    const three_ups_upu_s_vector4 xpack112 = xpack111 + xpack99;
    const three_ups_upu_s_vector4 xpack117 = xgathered0 * xpack112;
    const three_ups_upu_s_vector4 xpack113 = xgathered2 * xpack112;
    const double x480 = 14.62961126155784 * x56;
    const double x478 = x29 * x30;
    const double x479 = 22.6251 * x478;
    const double x481 = x479 - x480;
    const double x622 = x104 * x481;
    const double x485 = 14.62961126155784 * x104;
    const double x483 = x28 * x30;
    const double x484 = 22.6251 * x483;
    const double x486 = x484 - x485;
    const double x623 = x56 * x486;
    const double x624 = x622 - x623;
    const double x665 = xpack117[2];
    const double x666 = x624 - x665;
    const double x621 = xpack117[1];
    const double x667 = x621 + x666;
    const double x620 = -xpack117[3];
    const double x668 = x620 - x667;
    const double x619 = -xpack117[0];
    const double x669 = x619 - x668;
    const three_ups_upu_s_vector4 xpack11 = xgathered4 * xpack10;
    const double x110 = xpack10[0];
    const double x141 = x17 - x110;
    const three_ups_upu_s_vector4 xpack1 = xgathered6 * xpack0;
    const three_ups_upu_s_vector4 xpack2 = xpack1 - (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8};
    const three_ups_upu_s_vector4 xpack12 = xpack2 * xpack11;
    const three_ups_upu_s_vector4 xpack15 = xgathered8 * xgathered9;
    const three_ups_upu_s_vector4 xpack16 = xpack14 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack15;
    const three_ups_upu_s_vector4 xgathered11 = {x135, x96, x135, x96};
    const three_ups_upu_s_vector4 xpack28 = xgathered11 * xpack16;
    const three_ups_upu_s_vector4 xpack17 = xgathered4 * xpack16;
    const three_ups_upu_s_vector4 xpack18 = xpack12 + xpack17;
    const three_ups_upu_s_vector4 xpack22 = xgathered8 * xgathered6;
    const three_ups_upu_s_vector4 xpack25 = xpack22 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack24;
    const three_ups_upu_s_vector4 xpack26 = xpack21 * xpack25;
    const three_ups_upu_s_vector4 xpack27 = xpack18 + xpack26;
    const three_ups_upu_s_vector4 xpack29 = xpack27 - xpack28;
    const three_ups_upu_s_vector4 xpack76 = xpack4 * xpack29;
    const three_ups_upu_s_vector4 xpack77 = xpack45 * xpack76;
    const three_ups_upu_s_vector4 xpack67 = xgathered4 * xgathered7;
    const three_ups_upu_s_vector4 xpack68 = xpack66 * xpack67;
    const three_ups_upu_s_vector4 xpack72 = xgathered4 * xgathered8;
    const three_ups_upu_s_vector4 xpack73 = xpack71 * xpack72;
    const three_ups_upu_s_vector4 xpack74 = xpack68 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack73;
    const three_ups_upu_s_vector4 xpack60 = (three_ups_upu_s_vector4){13.9302, 13.9302, 13.9302, 13.9302} *
        xgathered0;
    const three_ups_upu_s_vector4 xpack61 = xpack0 * xpack60;
    const three_ups_upu_s_vector4 xpack62 = xgathered9 * xpack61;
    const three_ups_upu_s_vector4 xpack75 = xpack74 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0} *
        xpack62;
    const three_ups_upu_s_vector4 xpack78 = xpack75 - xpack77;
    const three_ups_upu_s_vector4 xpack38 = xpack2 * xpack4;
    const three_ups_upu_s_vector4 xpack79 = xpack38 * xpack78;
    const three_ups_upu_s_vector4 xpack116 = xgathered2 * xpack79;
    const double x586 = xpack116[2];
    const double x670 = x586 + x669;
    const double x584 = xpack116[1];
    const double x671 = x584 - x670;
    const double x583 = -xpack116[3];
    const double x672 = x583 - x671;
    const double x582 = -xpack116[0];
    const double x673 = x582 - x672;
    const three_ups_upu_s_vector4 xpack80 = xgathered0 * xpack79;
    const double x121 = xpack21[0];
    const double x143 = x60 * x121;
    const double x153 = x37 * x121;
    const double x144 = x37 * x135;
    const double x145 = x143 + x144;
    const double x154 = x60 * x135;
    const double x155 = x153 - x154;
    const double x139 = x16 * x37;
    const double x146 = x139 - x145;
    const double x147 = x17 * x146;
    const double x142 = x139 * x141;
    const double x148 = x142 - x147;
    const double x140 = x17 * x139;
    const double x149 = x140 - x148;
    const double x57 = x51 * x56;
    const double x50 = x35 * x49;
    const double x58 = x50 + x57;
    const double x150 = x58 * x149;
    const double x151 = x16 * x60;
    const double x156 = x151 + x155;
    const double x152 = x151 * x146;
    const double x157 = x139 * x156;
    const double x158 = x152 - x157;
    const double x72 = x35 * x56;
    const double x71 = x51 * x49;
    const double x73 = x71 - x72;
    const double x74 = x37 * x73;
    const double x161 = x60 * x73;
    const double x79 = x60 * x78;
    const double x80 = x74 - x79;
    const double x159 = x80 * x158;
    const double x160 = x150 - x159;
    const double x83 = xpack7[0];
    const double x84 = x80 * x83;
    const double x181 = xpack37[0];
    const double x182 = x181 * x84;
    const double x82 = xpack6[0];
    const double x85 = x82 * x84;
    const double x86 = x80 - x85;
    const double x165 = x80 * x146;
    const double x168 = x58 * x146;
    const double x162 = x37 * x78;
    const double x163 = x161 + x162;
    const double x164 = x163 * x156;
    const double x166 = x164 + x165;
    const double x167 = x156 * x166;
    const double x169 = x163 * x141;
    const double x170 = x168 - x169;
    const double x171 = x141 * x170;
    const double x172 = x167 - x171;
    const double x173 = x160 - x172;
    const double x183 = x173 - x182;
    const double x64 = x60 * x58;
    const double x66 = xpack4[0];
    const double x67 = x64 * x66;
    const double x137 = -xpack29[0];
    const double x138 = x67 * x137;
    const double x184 = x138 - x183;
    const double x63 = -xpack2[0];
    const double x68 = x63 * x67;
    const double x59 = x37 * x58;
    const double x69 = x59 - x68;
    const double x87 = x51 * x86;
    const double x538 = x35 * x86;
    const double x70 = x35 * x69;
    const double x88 = x70 + x87;
    const double x89 = 1.0 / x88;
    const double x185 = x89 * x184;
    const double x537 = x51 * x69;
    const double x539 = x537 - x538;
    const double x540 = x89 * x539;
    const three_ups_upu_s_vector4 xpack46 = xpack38 * xpack45;
    const three_ups_upu_s_vector4 xpack48 = xpack38 * xpack46;
    const three_ups_upu_s_vector4 xpack50 = (three_ups_upu_s_vector4){1.136, 1.136, 1.136, 1.136} *
        xgathered9;
    const three_ups_upu_s_vector4 xpack51 = xpack49 * xpack50;
    const three_ups_upu_s_vector4 xpack56 = xpack51 + xpack55;
    const three_ups_upu_s_vector4 xpack57 = xpack48 - xpack56;
    const three_ups_upu_s_vector4 xpack58 = xgathered2 * xpack57;
    const three_ups_upu_s_vector4 xpack114 = xgathered2 * xpack58;
    const three_ups_upu_s_vector4 xpack115 = xpack56 + xpack114;
    const three_ups_upu_s_vector4 xpack119 = xpack48 - xpack114;
    const three_ups_upu_s_vector4 xpack59 = xgathered0 * xpack58;
    const double x230 = 22.6251 * x100;
    const double x558 = x100 * x230;
    const double x559 = 69.4749 + x558;
    const double x575 = xpack115[2];
    const double x576 = x559 + x575;
    const double x557 = xpack115[1];
    const double x577 = x557 + x576;
    const double x555 = xpack115[3];
    const double x578 = x555 + x577;
    const double x553 = xpack115[0];
    const double x579 = x553 + x578;
    const double x231 = x133 * x230;
    const double x580 = x185 * x579;
    const double x674 = x580 + x673;
    const double x675 = x540 * x674;
    const double x721 = x540 * x579;
    const double x690 = x91 * x481;
    const double x482 = x129 * x481;
    const double x691 = x49 * x486;
    const double x692 = x690 - x691;
    const double x693 = xpack113[2];
    const double x694 = x692 - x693;
    const double x689 = -xpack113[0];
    const double x695 = x689 + x694;
    const double x688 = xpack80[2];
    const double x696 = x688 - x695;
    const double x392 = -xpack78[1];
    const double x697 = x392 - x696;
    const double x349 = xpack78[3];
    const double x698 = x349 + x697;
    const double x687 = -xpack80[0];
    const double x699 = x687 + x698;
    const double x487 = x78 * x486;
    const double x488 = x482 - x487;
    const double x529 = xpack113[1];
    const double x530 = x488 - x529;
    const double x477 = -xpack113[3];
    const double x531 = x477 + x530;
    const double x436 = -xpack78[2];
    const double x532 = x436 - x531;
    const double x394 = xpack80[1];
    const double x533 = x394 + x532;
    const double x351 = -xpack80[3];
    const double x534 = x351 - x533;
    const double x308 = xpack78[0];
    const double x535 = x308 - x534;
    const double x679 = 22.6251 * x94;
    const double x680 = x100 * x679;
    const double x681 = xpack59[2];
    const double x682 = x680 - x681;
    const three_ups_upu_s_vector4 xpack47 = xgathered2 * xpack46;
    const double x678 = -xpack47[1];
    const double x683 = x678 - x682;
    const double x677 = -xpack47[3];
    const double x684 = x677 - x683;
    const double x676 = xpack59[0];
    const double x685 = x676 - x684;
    const double x722 = x685 - x721;
    const double x723 = x685 + x722;
    const double x686 = x185 * x685;
    const double x700 = x686 + x699;
    const double x701 = x675 - x700;
    const double x724 = x540 * x723;
    const double x250 = -xpack47[2];
    const double x251 = x231 - x250;
    const double x285 = xpack59[1];
    const double x286 = x251 + x285;
    const double x229 = xpack59[3];
    const double x287 = x229 + x286;
    const double x195 = -xpack47[0];
    const double x288 = x195 + x287;
    const three_ups_upu_s_vector4 xpack118 = xgathered0 * xpack46;
    const double x714 = x94 * x679;
    const double x715 = 69.4749 + x714;
    const double x716 = xpack119[2];
    const double x717 = x715 + x716;
    const double x269 = xpack45[1];
    const double x718 = x269 + x717;
    const double x213 = xpack45[3];
    const double x719 = x213 + x718;
    const double x713 = xpack119[0];
    const double x720 = x713 + x719;
    const double x725 = x720 - x724;
    const double x726 = 1.0 / x725;
    const double x702 = x133 * x679;
    const double x703 = -xpack118[2];
    const double x704 = x702 + x703;
    const double x705 = -xpack118[1];
    const double x706 = x704 - x705;
    const double x707 = -xpack118[3];
    const double x708 = x706 + x707;
    const double x709 = -xpack118[0];
    const double x710 = x708 - x709;
    const double x711 = x540 * x288;
    const double x712 = x710 + x711;
    const double x289 = x185 * x288;
    const double x536 = x289 + x535;
    const double x727 = x712 * x726;
    const double x739 = x712 * x727;
    const double x743 = x701 * x726;
    const double x728 = x701 * x727;
    const double x729 = x536 - x728;
    const double x731 = 22.6251 * x133;
    const double x732 = x133 * x731;
    const double x733 = 69.4749 + x732;
    const double x248 = xpack45[2];
    const double x734 = x248 + x733;
    const double x735 = xpack119[1];
    const double x736 = x734 + x735;
    const double x730 = xpack119[3];
    const double x737 = x730 + x736;
    const double x193 = xpack45[0];
    const double x738 = x193 + x737;
    const double x740 = x738 - x739;
    const double x741 = x729 / x740;
    const double x742 = x727 * x741;
    const double x744 = x742 - x743;
    const double x745 = x540 * x744;
    const double x746 = x185 + x745;
    const double x803 = x104 * x746;
    const double x804 = x91 * x744;
    const double x805 = x129 * x741;
    const double x806 = x804 - x805;
    const double x807 = x803 + x806;
    const double x808 = -x807;
    a[12] = x808;
    const double x809 = x56 * x746;
    const double x810 = x49 * x744;
    const double x811 = x78 * x741;
    const double x812 = x810 - x811;
    const double x813 = x809 + x812;
    const double x814 = -x813;
    a[13] = x814;
    const double x815 = x100 * x746;
    const double x816 = x94 * x744;
    const double x817 = x133 * x741;
    const double x818 = x816 - x817;
    const double x819 = x815 + x818;
    const double x820 = -x819;
    a[14] = x820;
    const three_ups_upu_s_vector4 xgathered12 = {x746, x746, x746, x746};
    const three_ups_upu_s_vector4 xpack120 = xgathered2 * xgathered12;
    const three_ups_upu_s_vector4 xpack126 = xgathered0 * xgathered12;
    const three_ups_upu_s_vector4 xgathered13 = {x744, x741, x744, x741};
    const three_ups_upu_s_vector4 xpack121 = xgathered0 * xgathered13;
    const three_ups_upu_s_vector4 xpack122 = xpack120 - xpack121;
    const three_ups_upu_s_vector4 xpack123 = xpack38 * xpack122;
    const three_ups_upu_s_vector4 xpack124 = xpack76 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack123;
    const three_ups_upu_s_vector4 xgathered14 = {x741, x744, x741, x744};
    const three_ups_upu_s_vector4 xpack125 = xgathered14 + (three_ups_upu_s_vector4){1.0, (-1.0), (-1.0), 1.0}
        * xpack124;
    const double x752 = xpack125[0];
    a[0] = x752;
    const double x767 = -xpack125[1];
    a[3] = x767;
    const double x780 = xpack125[2];
    a[6] = x780;
    const double x794 = xpack125[3];
    const double x795 = -x794;
    a[9] = x795;
    const three_ups_upu_s_vector4 xpack127 = xgathered2 * xgathered13;
    const three_ups_upu_s_vector4 xpack128 = xpack126 + xpack127;
    const three_ups_upu_s_vector4 xpack129 = xpack52 * xpack128;
    const three_ups_upu_s_vector4 xpack130 = xpack108 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack129;
    const double x757 = xpack130[0];
    const double x758 = -x757;
    a[1] = x758;
    const double x772 = -xpack130[1];
    a[4] = x772;
    const double x785 = xpack130[2];
    const double x786 = -x785;
    a[7] = x786;
    const double x800 = -xpack130[3];
    a[10] = x800;
    const three_ups_upu_s_vector4 xpack131 = xpack49 * xpack128;
    const three_ups_upu_s_vector4 xpack132 = xpack96 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack131;
    const double x760 = xpack132[0];
    const double x761 = -x760;
    a[2] = x761;
    const double x774 = -xpack132[1];
    a[5] = x774;
    const double x788 = xpack132[2];
    a[8] = x788;
    const double x802 = xpack132[3];
    a[11] = x802;
    const three_ups_upu_s_vector4 every = (three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)((xpack3 +
        xpack125) + (xpack130 + xpack132)) | ((xpack3 <= (three_ups_upu_s_vector4){6.62327e-06, 6.62327e-06,
        6.62327e-06, 6.62327e-06}) & (xpack3 >= -(three_ups_upu_s_vector4){6.62327e-06, 6.62327e-06,
        6.62327e-06, 6.62327e-06})));
    return fabs(x88) <= 1.0e-05 || fabs(x725) <= 0.0007562600000000001 || fabs(x740) <= 0.0007551200000000001
        || !(x44 >= 0.999999 && x44 <= 1.000001) ? (double)NAN : (((x88 + x725) + (x740 + x807)) + ((x813 +
        x819) + (every[0] + every[1]))) + (every[2] + every[3]);
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
    const double x2 = q[2], x5 = q[5], x8 = q[8], x11 = q[11], x12 = q[12], x13 = q[13], x14 = q[14], x15 =
        q[15];
    const double x16 = y_dot[0], x17 = y_dot[1], x18 = u[0], x19 = u[1], x20 = u[2], x21 = u[3], x38 =
        sine[0];
    const double x22 = cosine[0], x47 = sine[1], x24 = cosine[1], x276 = sine[2], x349 = cosine[2], x278 =
        sine[3];
    const double x282 = cosine[3], x256 = sine[4], x346 = cosine[4], x258 = sine[5], x262 = cosine[5];
    const double x296 = sine[6], x328 = cosine[6], x298 = sine[7], x302 = cosine[7];
    const double x25 = x12 * x12;
    const double x26 = x13 * x13;
    const double x27 = x25 + x26;
    const double x28 = x14 * x14;
    const double x29 = x15 * x15;
    const double x30 = x28 + x29;
    const double x31 = x27 + x30;
    const double x34 = x26 + x29;
    const double x130 = x26 + x28;
    const double x32 = 2.0 * x31;
    const double x33 = 4.0 - x32;
    const double x35 = x33 * x34;
    const double x36 = 1.0 - x35;
    const double x80 = 0.5 * x31;
    const double x81 = 1.5 - x80;
    const double x160 = x30 * x33;
    const double x161 = 1.0 - x160;
    const double x131 = x33 * x130;
    const double x132 = 1.0 - x131;
    const double x39 = x15 * x33;
    const double x40 = x14 * x39;
    const double x41 = x13 * x33;
    const double x42 = x12 * x41;
    const double x62 = x14 * x33;
    const double x43 = x40 + x42;
    const double x148 = x40 - x42;
    const double x59 = x22 * x43;
    const double x58 = x38 * x36;
    const double x60 = x58 - x59;
    const double x61 = x24 * x60;
    const double x217 = x47 * x60;
    const double x63 = x13 * x62;
    const double x145 = x12 * x62;
    const double x64 = x12 * x39;
    const double x144 = x13 * x39;
    const double x65 = x63 - x64;
    const double x164 = x63 + x64;
    const double x66 = x47 * x65;
    const double x67 = x61 - x66;
    const three_ups_upu_s_vector4 xgathered0 = {x2, x5, x8, x11};
    const three_ups_upu_s_vector4 xpack0 = xgathered0 + (three_ups_upu_s_vector4){0.3, 0.3, 0.3, 0.3};
    const three_ups_upu_s_vector4 xgathered1 = {x24, x282, x262, x302};
    const three_ups_upu_s_vector4 xpack3 = xgathered1 * xpack0;
    const three_ups_upu_s_vector4 xpack4 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack3;
    const three_ups_upu_s_vector4 xpack7 = xgathered1 * xpack4;
    const double x70 = xpack7[0];
    const double x71 = x67 * x70;
    const three_ups_upu_s_vector4 xgathered2 = {x47, x278, x258, x298};
    const three_ups_upu_s_vector4 xpack5 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered2;
    const three_ups_upu_s_vector4 xpack6 = xpack0 - xpack5;
    const double x69 = xpack6[0];
    const double x72 = x69 * x71;
    const double x73 = x67 - x72;
    const double x74 = x38 * x73;
    const double x78 = x22 * x73;
    const double x44 = x38 * x43;
    const double x37 = x22 * x36;
    const double x45 = x37 + x44;
    const double x51 = x47 * x45;
    const double x53 = xpack4[0];
    const double x54 = x51 * x53;
    const three_ups_upu_s_vector4 xpack1 = xgathered2 * xpack0;
    const three_ups_upu_s_vector4 xpack2 = xpack1 - (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8};
    const double x50 = -xpack2[0];
    const double x55 = x50 * x54;
    const double x46 = x24 * x45;
    const double x56 = x46 - x55;
    const double x57 = x22 * x56;
    const double x75 = x57 + x74;
    const double x76 = 1.0 / x75;
    const double x77 = x38 * x56;
    const double x79 = x77 - x78;
    const double x84 = x76 * x79;
    const double x83 = x13 * x81;
    const double x85 = x83 * x84;
    const double x82 = x12 * x81;
    const double x86 = x82 + x85;
    const double x87 = 0.5 * x86;
    const double x88 = 1.0 / x87;
    const double x91 = x14 * x81;
    const double x89 = x15 * x81;
    const double x92 = x91 * x84;
    const double x93 = x89 - x92;
    const double x94 = 0.5 * x93;
    const double x95 = x88 * x94;
    const double x96 = x17 * x95;
    const double x97 = x16 - x96;
    const double x90 = 0.5 * x89;
    const double x99 = x90 * x95;
    const double x98 = 0.5 * x82;
    const double x100 = x98 + x99;
    const double x101 = x97 / x100;
    const double x102 = x90 * x101;
    const double x103 = x17 + x102;
    const double x104 = x88 * x103;
    const double x105 = x79 * x104;
    const double x106 = x76 * x105;
    const double x154 = x43 * x106;
    const double x155 = x36 * x104;
    const double x156 = x65 * x101;
    const double x157 = x155 + x156;
    const double x158 = x154 + x157;
    const double x178 = x43 * x158;
    const double x162 = x144 - x145;
    const double x146 = x144 + x145;
    const double x163 = x162 * x106;
    const double x165 = x164 * x104;
    const double x166 = x161 * x101;
    const double x167 = x165 + x166;
    const double x168 = x163 + x167;
    const double x179 = x162 * x168;
    const double x180 = x178 + x179;
    const double x147 = x132 * x106;
    const double x149 = x148 * x104;
    const double x150 = x146 * x101;
    const double x151 = x149 + x150;
    const double x152 = x147 + x151;
    const double x177 = x132 * x152;
    const double x181 = x177 + x180;
    const three_ups_upu_s_vector4 xgathered3 = {x22, x349, x346, x328};
    const three_ups_upu_s_vector4 xgathered4 = {x181, x181, x181, x181};
    const three_ups_upu_s_vector4 xpack24 = xgathered3 * xgathered4;
    const three_ups_upu_s_vector4 xgathered5 = {x38, x276, x256, x296};
    const three_ups_upu_s_vector4 xpack35 = xgathered5 * xgathered4;
    const double x184 = x36 * x158;
    const double x185 = x164 * x168;
    const double x186 = x184 + x185;
    const double x183 = x148 * x152;
    const double x187 = x183 + x186;
    const double x159 = x65 * x158;
    const double x703 = x152 * x158;
    const double x704 = 22.6251 * x703;
    const double x169 = x161 * x168;
    const double x170 = x159 + x169;
    const double x698 = x152 * x168;
    const double x153 = x146 * x152;
    const double x171 = x153 + x170;
    const double x699 = 22.6251 * x698;
    const three_ups_upu_s_vector4 xgathered6 = {x187, x171, x187, x171};
    const three_ups_upu_s_vector4 xpack25 = xgathered5 * xgathered6;
    const three_ups_upu_s_vector4 xpack26 = xpack25 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack24;
    const three_ups_upu_s_vector4 xgathered7 = {x106, x106, x106, x106};
    const three_ups_upu_s_vector4 xpack28 = xgathered3 * xgathered7;
    const three_ups_upu_s_vector4 xgathered8 = {x104, x101, x104, x101};
    const three_ups_upu_s_vector4 xpack29 = xgathered5 * xgathered8;
    const three_ups_upu_s_vector4 xpack30 = xpack29 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack28;
    const three_ups_upu_s_vector4 xpack31 = xpack2 * xpack30;
    const three_ups_upu_s_vector4 xpack32 = xpack4 * xpack31;
    const three_ups_upu_s_vector4 xgathered9 = {x101, x104, x101, x104};
    const three_ups_upu_s_vector4 xpack33 = xpack32 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xgathered9;
    const three_ups_upu_s_vector4 xpack47 = xpack33 * xpack26;
    const three_ups_upu_s_vector4 xpack48 = xpack6 * xpack47;
    const three_ups_upu_s_vector4 xpack9 = xgathered5 * xgathered7;
    const three_ups_upu_s_vector4 xpack10 = xgathered3 * xgathered8;
    const three_ups_upu_s_vector4 xpack11 = xpack10 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack9;
    const three_ups_upu_s_vector4 xpack14 = xpack6 * xpack11;
    const three_ups_upu_s_vector4 xpack15 = xpack7 * xpack14;
    const three_ups_upu_s_vector4 xpack65 = xpack6 * xpack7;
    const three_ups_upu_s_vector4 xpack8 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered1;
    const three_ups_upu_s_vector4 xpack12 = xpack8 * xpack11;
    const three_ups_upu_s_vector4 xpack113 = xpack8 * xpack47;
    const three_ups_upu_s_vector4 xpack46 = xpack12 * xpack15;
    const three_ups_upu_s_vector4 xpack49 = xpack48 + xpack46;
    const three_ups_upu_s_vector4 xpack36 = xgathered3 * xgathered6;
    const three_ups_upu_s_vector4 xpack37 = xpack36 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack35;
    const three_ups_upu_s_vector4 xpack21 = xgathered1 * xpack15;
    const three_ups_upu_s_vector4 xpack43 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack21;
    const three_ups_upu_s_vector4 xpack44 = xpack12 - xpack43;
    const three_ups_upu_s_vector4 xpack45 = xpack37 * xpack44;
    const three_ups_upu_s_vector4 xpack50 = xpack45 - xpack49;
    const three_ups_upu_s_vector4 xpack97 = xpack7 * xpack50;
    const double x214 = xpack50[0];
    const double x215 = x71 * x214;
    const three_ups_upu_s_vector4 xpack22 = xpack0 * xpack21;
    const three_ups_upu_s_vector4 xpack52 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack0;
    const three_ups_upu_s_vector4 xpack53 = xpack52 - (three_ups_upu_s_vector4){0.426, 0.426, 0.426, 0.426};
    const three_ups_upu_s_vector4 xpack81 = xpack52 + xpack53;
    const three_ups_upu_s_vector4 xpack54 = xpack0 * xpack53;
    const three_ups_upu_s_vector4 xpack103 = xpack81 * xpack46;
    const three_ups_upu_s_vector4 xpack66 = xpack54 + (three_ups_upu_s_vector4){2.3439, 2.3439, 2.3439,
        2.3439};
    const three_ups_upu_s_vector4 xpack98 = xpack66 * xpack97;
    const three_ups_upu_s_vector4 xpack55 = xpack54 - (three_ups_upu_s_vector4){(-2.2727), (-2.2727),
        (-2.2727), (-2.2727)};
    const three_ups_upu_s_vector4 xpack67 = xpack66 * xpack65;
    const three_ups_upu_s_vector4 xpack68 = xpack65 * xpack67;
    const three_ups_upu_s_vector4 xpack105 = xpack33 * xpack33;
    const three_ups_upu_s_vector4 xpack56 = xgathered1 * xpack55;
    const three_ups_upu_s_vector4 xpack87 = xgathered2 * xpack55;
    const three_ups_upu_s_vector4 xpack88 = xgathered1 * xpack87;
    const three_ups_upu_s_vector4 xpack86 = xgathered2 * xpack56;
    const three_ups_upu_s_vector4 xpack89 = xpack86 + xpack88;
    const three_ups_upu_s_vector4 xpack57 = xgathered1 * xpack56;
    const three_ups_upu_s_vector4 xpack58 = xpack57 + (three_ups_upu_s_vector4){0.1112, 0.1112, 0.1112,
        0.1112};
    const three_ups_upu_s_vector4 xpack104 = (three_ups_upu_s_vector4){0.5, 0.5, 0.5, 0.5} * xpack89;
    const three_ups_upu_s_vector4 xpack106 = xpack104 * xpack105;
    const three_ups_upu_s_vector4 xpack107 = xpack103 + xpack106;
    const three_ups_upu_s_vector4 xpack99 = (three_ups_upu_s_vector4){9.81, 9.81, 9.81, 9.81} * xgathered3;
    const three_ups_upu_s_vector4 xpack100 = xgathered2 * xpack99;
    const three_ups_upu_s_vector4 xpack101 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack100;
    const three_ups_upu_s_vector4 xpack102 = xpack0 * xpack101;
    const three_ups_upu_s_vector4 xpack108 = xpack107 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack102;
    const three_ups_upu_s_vector4 xpack109 = xpack108 + xpack98;
    const three_ups_upu_s_vector4 xpack110 = xpack65 * xpack109;
    const three_ups_upu_s_vector4 xpack116 = xgathered1 * xpack99;
    const three_ups_upu_s_vector4 xpack117 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack116;
    const three_ups_upu_s_vector4 xgathered10 = {x18, x19, x20, x21};
    const three_ups_upu_s_vector4 xpack118 = xgathered10 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0}
        * xpack117;
    const three_ups_upu_s_vector4 xpack16 = xgathered2 * xpack15;
    const three_ups_upu_s_vector4 xpack111 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack16;
    const three_ups_upu_s_vector4 xpack112 = xpack37 * xpack111;
    const three_ups_upu_s_vector4 xpack114 = xpack113 + xpack112;
    const three_ups_upu_s_vector4 xpack115 = (three_ups_upu_s_vector4){1.42, 1.42, 1.42, 1.42} * xpack114;
    const three_ups_upu_s_vector4 xpack17 = xpack0 * xpack16;
    const three_ups_upu_s_vector4 xpack82 = xgathered1 * xpack81;
    const three_ups_upu_s_vector4 xpack83 = xgathered1 * xpack82;
    const three_ups_upu_s_vector4 xpack119 = (three_ups_upu_s_vector4){0.5, 0.5, 0.5, 0.5} * xpack81;
    const three_ups_upu_s_vector4 xpack122 = (three_ups_upu_s_vector4){0.5, 0.5, 0.5, 0.5} * xpack83;
    const three_ups_upu_s_vector4 xpack123 = xpack122 * xpack105;
    const three_ups_upu_s_vector4 xpack120 = xpack15 * xpack15;
    const three_ups_upu_s_vector4 xpack121 = xpack119 * xpack120;
    const three_ups_upu_s_vector4 xpack124 = xpack121 + xpack123;
    const three_ups_upu_s_vector4 xpack125 = xpack124 + xpack118;
    const three_ups_upu_s_vector4 xpack126 = xpack115 + xpack125;
    const three_ups_upu_s_vector4 xpack127 = xpack8 * xpack126;
    const three_ups_upu_s_vector4 xpack128 = xpack110 - xpack127;
    const three_ups_upu_s_vector4 xpack131 = xgathered5 * xpack128;
    const three_ups_upu_s_vector4 xpack129 = xgathered3 * xpack128;
    const double x697 = 14.62961126155784 * x162;
    const double x700 = x697 - x699;
    const double x798 = x43 * x700;
    const double x702 = 14.62961126155784 * x43;
    const double x705 = x702 - x704;
    const double x799 = x162 * x705;
    const double x800 = x798 - x799;
    const double x797 = xpack131[2];
    const double x801 = x797 - x800;
    const double x756 = -xpack131[1];
    const double x802 = x756 - x801;
    const double x755 = -xpack131[3];
    const double x803 = x755 - x802;
    const double x754 = xpack131[0];
    const double x804 = x754 - x803;
    const three_ups_upu_s_vector4 xpack38 = xpack33 * xpack37;
    const three_ups_upu_s_vector4 xpack39 = xpack2 * xpack38;
    const three_ups_upu_s_vector4 xpack51 = xpack2 * xpack4;
    const double x140 = xpack15[0], x200 = xpack37[0];
    const double x216 = x140 - x200;
    const three_ups_upu_s_vector4 xpack13 = xgathered1 * xpack12;
    const three_ups_upu_s_vector4 xpack18 = xpack13 - xpack17;
    const three_ups_upu_s_vector4 xgathered11 = {x171, x187, x171, x187};
    const three_ups_upu_s_vector4 xpack19 = xpack18 * xgathered11;
    const three_ups_upu_s_vector4 xpack34 = xpack33 * xpack18;
    const three_ups_upu_s_vector4 xpack40 = xpack34 - xpack39;
    const three_ups_upu_s_vector4 xpack20 = xgathered2 * xpack12;
    const three_ups_upu_s_vector4 xpack23 = xpack20 + xpack22;
    const three_ups_upu_s_vector4 xpack27 = xpack23 * xpack26;
    const three_ups_upu_s_vector4 xpack41 = xpack40 - xpack27;
    const three_ups_upu_s_vector4 xpack42 = xpack41 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack19;
    const three_ups_upu_s_vector4 xpack76 = xpack4 * xpack42;
    const double x205 = -xpack42[0];
    const double x206 = x54 * x205;
    const three_ups_upu_s_vector4 xpack77 = xpack58 * xpack76;
    const three_ups_upu_s_vector4 xpack84 = xpack12 * xpack33;
    const three_ups_upu_s_vector4 xpack85 = xpack83 * xpack84;
    const three_ups_upu_s_vector4 xpack90 = xpack15 * xpack33;
    const three_ups_upu_s_vector4 xpack91 = xpack89 * xpack90;
    const three_ups_upu_s_vector4 xpack92 = xpack85 - xpack91;
    const three_ups_upu_s_vector4 xpack78 = (three_ups_upu_s_vector4){13.9302, 13.9302, 13.9302, 13.9302} *
        xgathered5;
    const three_ups_upu_s_vector4 xpack79 = xpack0 * xpack78;
    const three_ups_upu_s_vector4 xpack80 = xgathered1 * xpack79;
    const three_ups_upu_s_vector4 xpack93 = xpack92 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack80;
    const three_ups_upu_s_vector4 xpack94 = xpack93 - xpack77;
    const three_ups_upu_s_vector4 xpack95 = xpack51 * xpack94;
    const three_ups_upu_s_vector4 xpack130 = xgathered3 * xpack95;
    const double x721 = xpack130[2];
    const double x805 = x721 + x804;
    const double x719 = xpack130[1];
    const double x806 = x719 + x805;
    const double x718 = -xpack130[3];
    const double x807 = x718 + x806;
    const double x717 = -xpack130[0];
    const double x808 = x717 + x807;
    const three_ups_upu_s_vector4 xpack96 = xgathered5 * xpack95;
    const double x189 = -xpack26[0];
    const double x222 = x47 * x189;
    const double x230 = x24 * x189;
    const double x221 = x24 * x171;
    const double x223 = x221 - x222;
    const double x229 = x47 * x171;
    const double x231 = x229 + x230;
    const double x196 = xpack33[0];
    const double x224 = x24 * x196;
    const double x225 = x223 - x224;
    const double x232 = x47 * x196;
    const double x233 = x231 - x232;
    const double x240 = x225 * x232;
    const double x243 = x140 * x225;
    const double x246 = x140 * x224;
    const double x244 = x216 * x224;
    const double x245 = x243 + x244;
    const double x247 = x245 - x246;
    const double x248 = x45 * x247;
    const double x239 = x224 * x233;
    const double x241 = x239 - x240;
    const double x242 = x67 * x241;
    const double x249 = x242 + x248;
    const double x226 = x45 * x225;
    const double x234 = x67 * x225;
    const double x218 = x24 * x65;
    const double x219 = x217 + x218;
    const double x220 = x219 * x216;
    const double x227 = x220 + x226;
    const double x228 = x216 * x227;
    const double x235 = x219 * x233;
    const double x236 = x234 + x235;
    const double x237 = x233 * x236;
    const double x238 = x228 + x237;
    const double x250 = x238 + x249;
    const double x251 = x215 - x250;
    const double x252 = x206 + x251;
    const double x253 = x76 * x252;
    const three_ups_upu_s_vector4 xpack59 = xpack51 * xpack58;
    const three_ups_upu_s_vector4 xpack62 = xpack51 * xpack59;
    const three_ups_upu_s_vector4 xpack63 = (three_ups_upu_s_vector4){1.136, 1.136, 1.136, 1.136} *
        xgathered1;
    const three_ups_upu_s_vector4 xpack64 = xpack8 * xpack63;
    const three_ups_upu_s_vector4 xpack69 = xpack64 + xpack68;
    const three_ups_upu_s_vector4 xpack70 = xpack62 - xpack69;
    const three_ups_upu_s_vector4 xpack71 = xgathered3 * xpack70;
    const three_ups_upu_s_vector4 xpack73 = xgathered3 * xpack71;
    const three_ups_upu_s_vector4 xpack75 = xpack69 + xpack73;
    const three_ups_upu_s_vector4 xpack74 = xpack62 - xpack73;
    const three_ups_upu_s_vector4 xpack72 = xgathered5 * xpack71;
    const double x344 = 22.6251 * x132;
    const double x418 = x132 * x344;
    const double x419 = 69.4749 + x418;
    const double x420 = xpack75[2];
    const double x421 = x419 + x420;
    const double x417 = xpack75[1];
    const double x422 = x417 + x421;
    const double x415 = xpack75[3];
    const double x423 = x415 + x422;
    const double x413 = xpack75[0];
    const double x424 = x413 + x423;
    const double x345 = x146 * x344;
    const double x715 = x253 * x424;
    const double x809 = x715 + x808;
    const double x810 = x84 * x809;
    const double x425 = x84 * x424;
    const double x816 = x36 * x700;
    const double x701 = x65 * x700;
    const double x817 = x164 * x705;
    const double x818 = x816 - x817;
    const double x815 = xpack129[2];
    const double x819 = x815 - x818;
    const double x814 = xpack129[0];
    const double x820 = x814 - x819;
    const double x813 = xpack96[2];
    const double x821 = x813 - x820;
    const double x559 = -xpack94[1];
    const double x822 = x559 + x821;
    const double x504 = xpack94[3];
    const double x823 = x504 - x822;
    const double x812 = -xpack96[0];
    const double x824 = x812 - x823;
    const double x706 = x161 * x705;
    const double x707 = x701 - x706;
    const double x696 = -xpack129[1];
    const double x708 = x696 - x707;
    const double x655 = -xpack129[3];
    const double x709 = x655 - x708;
    const double x614 = -xpack94[2];
    const double x710 = x614 - x709;
    const double x561 = xpack96[1];
    const double x711 = x561 - x710;
    const double x506 = -xpack96[3];
    const double x712 = x506 + x711;
    const double x451 = xpack94[0];
    const double x713 = x451 + x712;
    const double x254 = 22.6251 * x148;
    const double x407 = x132 * x254;
    const double x408 = xpack72[2];
    const double x409 = x407 - x408;
    const three_ups_upu_s_vector4 xpack61 = xgathered3 * xpack59;
    const double x406 = -xpack61[1];
    const double x410 = x406 - x409;
    const double x405 = -xpack61[3];
    const double x411 = x405 - x410;
    const double x404 = xpack72[0];
    const double x412 = x404 - x411;
    const double x426 = x412 - x425;
    const double x427 = x412 + x426;
    const double x811 = x253 * x412;
    const double x825 = x811 + x824;
    const double x826 = x810 - x825;
    const double x428 = x84 * x427;
    const double x347 = -xpack61[2];
    const double x348 = x345 - x347;
    const double x364 = xpack72[1];
    const double x365 = x348 + x364;
    const double x343 = xpack72[3];
    const double x366 = x343 + x365;
    const double x327 = -xpack61[0];
    const double x367 = x327 + x366;
    const three_ups_upu_s_vector4 xpack60 = xgathered5 * xpack59;
    const double x382 = x148 * x254;
    const double x383 = 69.4749 + x382;
    const double x399 = xpack74[2];
    const double x400 = x383 + x399;
    const double x292 = xpack58[1];
    const double x401 = x292 + x400;
    const double x312 = xpack58[3];
    const double x402 = x312 + x401;
    const double x381 = xpack74[0];
    const double x403 = x381 + x402;
    const double x429 = x403 - x428;
    const double x430 = 1.0 / x429;
    const double x255 = x146 * x254;
    const double x274 = -xpack60[2];
    const double x275 = x255 + x274;
    const double x294 = -xpack60[1];
    const double x295 = x275 - x294;
    const double x314 = -xpack60[3];
    const double x315 = x295 + x314;
    const double x325 = -xpack60[0];
    const double x326 = x315 - x325;
    const double x368 = x84 * x367;
    const double x369 = x326 + x368;
    const double x432 = x253 * x367;
    const double x714 = x432 + x713;
    const double x431 = x369 * x430;
    const double x838 = x369 * x431;
    const double x842 = x430 * x826;
    const double x827 = x431 * x826;
    const double x828 = x714 - x827;
    const double x830 = 22.6251 * x146;
    const double x831 = x146 * x830;
    const double x832 = 69.4749 + x831;
    const double x272 = xpack58[2];
    const double x833 = x272 + x832;
    const double x834 = xpack74[1];
    const double x835 = x833 + x834;
    const double x829 = xpack74[3];
    const double x836 = x829 + x835;
    const double x323 = xpack58[0];
    const double x837 = x323 + x836;
    const double x839 = x837 - x838;
    const double x840 = x828 / x839;
    const double x841 = x431 * x840;
    const double x843 = x841 - x842;
    const double x844 = x84 * x843;
    const double x845 = x253 + x844;
    const double x852 = x43 * x845;
    const double x853 = x36 * x843;
    const double x854 = x65 * x840;
    const double x855 = x853 - x854;
    const double x856 = x852 + x855;
    const double x875 = x65 * x856;
    const double x857 = x43 * x856;
    const double x868 = x36 * x856;
    const double x858 = x162 * x845;
    const double x846 = x132 * x845;
    const double x859 = x164 * x843;
    const double x847 = x148 * x843;
    const double x860 = x161 * x840;
    const double x861 = x859 - x860;
    const double x862 = x858 + x861;
    const double x876 = x161 * x862;
    const double x877 = x875 + x876;
    const double x848 = x146 * x840;
    const double x849 = x847 - x848;
    const double x850 = x846 + x849;
    const double x874 = x146 * x850;
    const double x878 = x874 + x877;
    const double x863 = x162 * x862;
    const double x864 = x857 + x863;
    const double x869 = x164 * x862;
    const double x870 = x868 + x869;
    const double x851 = x132 * x850;
    const double x865 = x851 + x864;
    const double x867 = x148 * x850;
    const double x871 = x867 + x870;
    const double x894 = x89 * x878;
    const double x879 = x82 * x878;
    const double x895 = x83 * x865;
    const double x896 = x894 - x895;
    const double x866 = x91 * x865;
    const double x897 = x82 * x871;
    const double x898 = x896 - x897;
    const double x872 = x89 * x871;
    const double x873 = x866 - x872;
    const double x880 = x873 - x879;
    const double x884 = x91 * x106;
    const double x885 = x89 * x104;
    const double x886 = x884 - x885;
    const double x887 = x82 * x101;
    const double x888 = x886 - x887;
    const double x889 = 0.5 * x888;
    const double x890 = x106 * x889;
    const double x117 = x82 * x106;
    const double x110 = x82 * x104;
    const double x114 = x83 * x104;
    const double x115 = x91 * x101;
    const double x116 = x114 - x115;
    const double x118 = x116 - x117;
    const double x119 = 0.5 * x118;
    const double x123 = x91 * x104;
    const double x883 = x101 * x119;
    const double x891 = x883 - x890;
    const double x120 = x104 * x119;
    const double x122 = x89 * x106;
    const double x107 = x89 * x101;
    const double x124 = x83 * x101;
    const double x125 = x123 + x124;
    const double x126 = x122 + x125;
    const double x127 = 0.5 * x126;
    const double x892 = x104 * x127;
    const double x893 = x891 - x892;
    const double x899 = x893 - x898;
    const double x900 = 0.5 * x899;
    y_ddot[1] = x900;
    const double x128 = x101 * x127;
    const double x108 = x83 * x106;
    const double x109 = x107 - x108;
    const double x111 = x109 - x110;
    const double x112 = 0.5 * x111;
    const double x113 = x106 * x112;
    const double x121 = x113 - x120;
    const double x129 = x121 - x128;
    const double x881 = x129 - x880;
    const double x882 = 0.5 * x881;
    y_ddot[0] = x882;
    const three_ups_upu_s_vector4 every = (three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)(xpack3) |
        ((xpack3 <= (three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10}) & (xpack3
        >= -(three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10})));
    return fabs(x75) <= 1.0e-09 || fabs(x87) <= 1.0e-09 || fabs(x100) <= 1.0e-09 || fabs(x429) <=
        7.562600000000002e-08 || fabs(x839) <= 7.551200000000001e-08 || !(x31 >= 0.999999 && x31 <= 1.000001)
        ? (double)NAN : (((x75 + x87) + (x100 + x429)) + ((x839 + x882) + (x900 + every[0]))) + ((every[1] +
        every[2]) + every[3]);
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
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    /* limb1: accelerations; momentum rate, eq. (35); geometry */
    const REAL limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y;
    const REAL limb1_U_v_1 = READ(v, 1);
    const REAL minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x;
    const REAL limb1_U_a_1 = READ(a, 1);
    const REAL limb1_lower_U_yx = limb1_U_a_1 + limb1_lower_U_still_xy;
    const REAL t70 = k19 * limb1_lower_U_still_xy;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL t4 = limb1_upper_offset_x * limb1_lower_U_yx;
    const REAL limb1_lower_rate_force_y = limb_lower_mx * limb1_lower_U_yx;
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    const REAL limb1_U_0_acc_y = gravity_z * limb1_U_0_cos;
    const REAL minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y;
    const REAL t5 = t4 - minus_limb1_lower_acc_y;
    const REAL limb1_lower_rate_force_y_2 = limb1_lower_rate_force_y - limb_lower_m * minus_limb1_lower_acc_y;
    const REAL limb1_lower_acc_x = limb1_lower_cos * limb1_U_0_acc_y;
    const REAL limb1_P_v = READ(v, 2);
    const REAL limb1_upper_acc_y = limb1_P_v * (2.0 * limb1_U_v_1) + t5;
    /* limb1: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    const REAL limb1_upper_sent_force_y = limb_lower_m * limb1_upper_acc_y - limb1_lower_rate_force_y - multipliers_1;
    WRITE(sized_, 7, limb1_upper_sent_force_y);
    const REAL limb1_lower_sent_force_y = limb1_lower_rate_force_y_2 + limb1_upper_sent_force_y;
    const REAL minus_limb1_upper_rate_moment_z = limb_lower_mx * limb1_upper_acc_y;
    const REAL t6 = limb1_lower_cos * limb1_lower_sent_force_y;
    const REAL t16 = limb1_lower_sin * limb1_lower_sent_force_y;
    const REAL minus_limb1_lower_U_still_xx = limb1_lower_omega_y * limb1_lower_omega_y + limb1_U_v_1 * limb1_U_v_1;
    const REAL limb1_lower_force_x = limb_lower_m * (READ(a, 2) - (limb1_upper_offset_x * minus_limb1_lower_U_still_xx - limb1_lower_acc_x));
    const REAL minus_limb1_lower_rate_force_x = limb_lower_mx * minus_limb1_lower_U_still_xx;
    const REAL limb1_upper_sent_force_x = minus_limb1_lower_rate_force_x + limb1_lower_force_x - multipliers_0;
    const REAL minus_limb1_lower_sent_force_x = minus_limb1_lower_rate_force_x - limb_lower_m * limb1_lower_acc_x - limb1_upper_sent_force_x;
    const REAL limb1_lower_joint_sent_force_y = t6 - limb1_lower_sin * minus_limb1_lower_sent_force_x;
    WRITE(reactions, 0, limb1_lower_joint_sent_force_y);
    WRITE(sized_, 1, limb1_lower_joint_sent_force_y);
    checked1 = checked1 + limb1_lower_joint_sent_force_y;
    const REAL minus_limb1_lower_joint_sent_force_x = limb1_lower_cos * minus_limb1_lower_sent_force_x + t16;
    RESULT(checked2, sized_, 0, -minus_limb1_lower_joint_sent_force_x);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t22 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t23 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t24 = t22 + t23;
    const REAL t25 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t26 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t27 = t25 + t26;
    const REAL t28 = t24 + t27;
    const REAL t30 = 4.0 - 2.0 * t28;
    const REAL t382 = t23 + t25;
    const REAL platform_turn_yy = 1.0 - t30 * (t23 + t26);
    const REAL platform_turn_xx = 1.0 - t27 * t30;
    const REAL platform_turn_zz = 1.0 - t30 * t382;
    const REAL t34 = limb5_S_q_qz * t30;
    const REAL t35 = limb5_S_q_qy * t34;
    const REAL t37 = limb5_S_q_qw * (limb5_S_q_qx * t30);
    const REAL t76 = limb5_S_q_qy * t30;
    const REAL platform_turn_zy = t35 + t37;
    /* limb1: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const REAL limb1_U_0_sin = SINES(sine, 0), multipliers_3 = READ(multipliers_, 3);
    const REAL platform_turn_yz = t35 - t37;
    const REAL minus_limb1_U2_joint_reaction_moment_x = (limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy) * multipliers_3;
    const REAL limb1_lower_alpha_still_x = limb1_U_v_1 * limb1_lower_omega_y;
    const REAL limb1_U_a_0 = READ(a, 0);
    const REAL t11 = limb1_P_v * (2.0 * limb1_lower_omega_y);
    const REAL t20 = k14 * (limb1_lower_alpha_still_x + limb1_U_a_0 * limb1_lower_sin);
    const REAL limb1_upper_rate_moment_x = t20 - k15 * limb1_lower_alpha_still_x;
    const REAL limb1_upper_sent_moment_x = limb1_upper_rate_moment_x - minus_limb1_U2_joint_reaction_moment_x;
    const REAL limb1_lower_sent_moment_x = limb1_upper_rate_moment_x + limb1_upper_sent_moment_x;
    RESULT(checked3, sized_, 9, per_length * limb1_upper_sent_moment_x);
    const REAL t47 = limb1_lower_cos * limb1_lower_sent_moment_x;
    const REAL t39 = limb1_lower_sin * limb1_lower_sent_moment_x;
    const REAL minus_limb1_lower_alpha_y = minus_limb1_lower_alpha_still_y - limb1_U_a_0 * limb1_lower_cos;
    const REAL limb1_lower_U_zx = minus_limb1_lower_alpha_still_y + minus_limb1_lower_alpha_y;
    const REAL t42 = k16 * minus_limb1_lower_alpha_y + k17 * minus_limb1_lower_alpha_still_y;
    const REAL t12 = limb1_upper_offset_x * limb1_lower_U_zx;
    const REAL limb1_lower_rate_force_z = limb_lower_mx * limb1_lower_U_zx;
    const REAL minus_limb1_upper_acc_z = t11 - (t12 + gravity_z * limb1_U_0_sin);
    const REAL minus_limb1_upper_sent_force_z = limb_lower_m * minus_limb1_upper_acc_z + limb1_lower_rate_force_z + multipliers_2;
    const REAL minus_limb1_upper_rate_moment_y_2 = limb_lower_mx * minus_limb1_upper_acc_z + t42;
    /* limb1: balance, eqs. (40)-(47); reactions, eq. (32) */
    RESULT(checked0, sized_, 8, -minus_limb1_upper_sent_force_z);
    const REAL t44 = minus_limb1_upper_rate_moment_y_2 - limb1_upper_offset_x * minus_limb1_upper_sent_force_z;
    const REAL minus_limb1_lower_sent_moment_y = gravity_z_limb_lower_mx * limb1_U_0_sin + t42 + t44;
    const REAL limb1_lower_joint_sent_moment_x = t47 + limb1_lower_sin * minus_limb1_lower_sent_moment_y;
    RESULT(checked1, sized_, 3, per_length * limb1_lower_joint_sent_moment_x);
    const REAL limb1_lower_joint_sent_moment_y = t39 - limb1_lower_cos * minus_limb1_lower_sent_moment_y;
    WRITE(reactions, 3, limb1_lower_joint_sent_moment_y);
    RESULT(checked2, sized_, 4, per_length * limb1_lower_joint_sent_moment_y);
    const REAL t49 = limb1_U_0_sin * limb1_lower_joint_sent_moment_x;
    const REAL t50 = limb1_U_0_cos * limb1_lower_joint_sent_moment_x;
    const REAL t19 = limb1_U_0_cos * minus_limb1_lower_joint_sent_force_x;
    const REAL t17 = limb1_U_0_sin * minus_limb1_lower_joint_sent_force_x;
    const REAL limb1_lower_sent_force_z = limb1_lower_rate_force_z + limb_lower_m_gravity_z * limb1_U_0_sin - minus_limb1_upper_sent_force_z;
    WRITE(sized_, 2, limb1_lower_sent_force_z);
    const REAL limb1_U_0_joint_sent_force_y = limb1_U_0_sin * limb1_lower_sent_force_z - t19;
    WRITE(reactions, 2, limb1_U_0_joint_sent_force_y);
    RESULT(checked3, reactions, 4, param_R * limb1_U_0_joint_sent_force_y - t49);
    const REAL limb1_U_0_joint_sent_force_x = limb1_U_0_cos * limb1_lower_sent_force_z + t17;
    WRITE(reactions, 1, limb1_U_0_joint_sent_force_x);
    /* limb1: reactions, eq. (32); geometry; reciprocal wrenches, eq. (10) */
    RESULT(checked0, reactions, 5, t50 - param_R * limb1_U_0_joint_sent_force_x);
    const REAL t55 = limb1_U_0_sin * minus_limb1_upper_sent_force_z;
    const REAL t53 = limb1_U_0_cos * minus_limb1_upper_sent_force_z;
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin;
    const REAL t56 = minus_limb1_lower_rotation_zy * limb1_upper_sent_force_y + t55;
    RESULT(checked1, reactions, 8, -t56);
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    const REAL minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx;
    const REAL t57 = minus_limb1_upper_position_y * t56;
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    const REAL limb1_P_reactions_fy = limb1_lower_rotation_yy * limb1_upper_sent_force_y - t53;
    WRITE(reactions, 7, limb1_P_reactions_fy);
    const REAL limb1_P_reactions_fx = limb1_lower_cos * limb1_upper_sent_force_y;
    WRITE(reactions, 6, limb1_P_reactions_fx);
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    const REAL limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t64 = minus_limb1_upper_position_x * t56;
    const REAL t59 = t57 - limb1_upper_position_z * limb1_P_reactions_fy;
    const REAL t87 = minus_limb1_upper_position_x * limb1_P_reactions_fy;
    const REAL t61 = limb1_lower_sin * limb1_upper_sent_moment_x;
    RESULT(checked2, reactions, 9, t59 - (limb1_lower_cos * minus_limb1_upper_rate_moment_y_2 - t61));
    const REAL t75 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy);
    const REAL t77 = limb5_S_q_qx * t76; /* limb5_S */
    const REAL t374 = limb5_S_q_qw * t76; /* limb5_S */
    const REAL t78 = limb5_S_q_qw * t34; /* limb5_S */
    const REAL t373 = limb5_S_q_qx * t34; /* limb5_S */
    const REAL platform_turn_xy = t77 - t78;
    const REAL platform_turn_yx = t77 + t78;
    const REAL minus_limb1_U2_joint_reaction_moment_z = (t75 - limb1_lower_sin * platform_turn_xy) * multipliers_3;
    const REAL minus_limb1_upper_sent_moment_z = minus_limb1_upper_rate_moment_z - (k18 * limb1_U_a_1 + t70) + minus_limb1_U2_joint_reaction_moment_z;
    const REAL t80 = limb1_U_0_cos * minus_limb1_upper_sent_moment_z;
    const REAL t67 = minus_limb1_lower_rotation_yx * limb1_upper_sent_moment_x;
    const REAL t83 = limb1_lower_rotation_zx * limb1_upper_sent_moment_x;
    const REAL t81 = limb1_lower_rotation_yy * minus_limb1_upper_rate_moment_y_2 + t67 + t80;
    const REAL t95 = limb1_lower_rotation_yy * multipliers_1;
    RESULT(checked3, reactions, 10, limb1_upper_position_z * limb1_P_reactions_fx - t64 - t81);
    const REAL t89 = t87 - minus_limb1_upper_position_y * limb1_P_reactions_fx;
    const REAL t85 = limb1_U_0_sin * minus_limb1_upper_sent_moment_z;
    RESULT(checked0, sized_, 11, -(per_length * minus_limb1_upper_sent_moment_z));
    RESULT(checked1, reactions, 11, minus_limb1_lower_rotation_zy * minus_limb1_upper_rate_moment_y_2 + t83 - t85 - t89);
    const REAL t100 = minus_limb1_lower_rotation_zy * multipliers_1;
    RESULT(checked2, sized_, 10, -(per_length * minus_limb1_upper_rate_moment_y_2));
    const REAL t92 = limb1_lower_sin * multipliers_0 + limb1_lower_cos * multipliers_1;
    RESULT(checked3, reactions, 12, -t92);
    const REAL t96 = minus_limb1_lower_rotation_yx * multipliers_0 - t95;
    const REAL t107 = minus_limb1_lower_rotation_yx * minus_limb1_U2_joint_reaction_moment_x;
    const REAL t93 = limb1_U_0_cos * multipliers_2;
    const REAL t97 = t93 - t96;
    RESULT(checked0, reactions, 13, -t97);
    const REAL t101 = limb1_lower_rotation_zx * multipliers_0 - t100;
    const REAL t116 = limb1_lower_rotation_zx * minus_limb1_U2_joint_reaction_moment_x;
    const REAL t98 = limb1_U_0_sin * multipliers_2;
    const REAL t102 = t98 + t101;
    RESULT(checked1, reactions, 14, -t102);
    const REAL t106 = limb1_lower_sin * minus_limb1_U2_joint_reaction_moment_x;
    RESULT(checked2, sized_, 15, -(per_length * minus_limb1_U2_joint_reaction_moment_x));
    const REAL t111 = minus_limb1_upper_position_x * t102;
    const REAL t113 = minus_limb1_upper_position_x * t97;
    RESULT(checked3, reactions, 15, minus_limb1_upper_position_y * t102 + limb1_upper_position_z * t97 - t106);
    const REAL t112 = limb1_upper_position_z * t92 + t111;
    const REAL t115 = t113 - minus_limb1_upper_position_y * t92;
    RESULT(checked0, reactions, 16, t107 - limb1_U_0_cos * minus_limb1_U2_joint_reaction_moment_z - t112);
    RESULT(checked1, reactions, 17, t115 - (t116 + limb1_U_0_sin * minus_limb1_U2_joint_reaction_moment_z));
    RESULT(checked2, sized_, 17, -(per_length * minus_limb1_U2_joint_reaction_moment_z));
    /* limb2: velocities, eq. (6); geometry */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_sin = SINES(sine, 3);
    const REAL limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin;
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos;
    /* limb2: accelerations; momentum rate, eq. (35); geometry */
    const REAL limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y;
    const REAL limb2_U_v_1 = READ(v, 4);
    const REAL minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x;
    const REAL limb2_U_a_1 = READ(a, 4);
    const REAL limb2_lower_U_yx = limb2_U_a_1 + limb2_lower_U_still_xy;
    const REAL t161 = k19 * limb2_lower_U_still_xy;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL t130 = limb2_upper_offset_x * limb2_lower_U_yx;
    const REAL limb2_lower_rate_force_y = limb_lower_mx * limb2_lower_U_yx;
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL minus_limb2_U_0_acc_y = gravity_z * limb2_U_0_sin;
    const REAL limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y;
    const REAL t131 = t130 + limb2_lower_acc_y;
    const REAL limb2_lower_rate_force_y_2 = limb2_lower_rate_force_y + limb_lower_m * limb2_lower_acc_y;
    const REAL minus_limb2_lower_acc_x = limb2_lower_cos * minus_limb2_U_0_acc_y;
    const REAL limb2_P_v = READ(v, 5);
    const REAL limb2_upper_acc_y = limb2_P_v * (2.0 * limb2_U_v_1) + t131;
    /* limb2: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    const REAL limb2_upper_sent_force_y = limb_lower_m * limb2_upper_acc_y - limb2_lower_rate_force_y - multipliers_5;
    WRITE(sized_, 25, limb2_upper_sent_force_y);
    const REAL limb2_lower_sent_force_y = limb2_lower_rate_force_y_2 + limb2_upper_sent_force_y;
    const REAL minus_limb2_upper_rate_moment_z = limb_lower_mx * limb2_upper_acc_y;
    const REAL t134 = limb2_lower_cos * limb2_lower_sent_force_y;
    const REAL t132 = limb2_lower_sin * limb2_lower_sent_force_y;
    const REAL minus_limb2_lower_U_still_xx = limb2_lower_omega_y * limb2_lower_omega_y + limb2_U_v_1 * limb2_U_v_1;
    const REAL limb2_lower_force_x = limb_lower_m * (READ(a, 5) - (limb2_upper_offset_x * minus_limb2_lower_U_still_xx + minus_limb2_lower_acc_x));
    const REAL minus_limb2_lower_rate_force_x = limb_lower_mx * minus_limb2_lower_U_still_xx;
    const REAL limb2_upper_sent_force_x = minus_limb2_lower_rate_force_x + limb2_lower_force_x - multipliers_4;
    const REAL minus_limb2_lower_sent_force_x = minus_limb2_lower_rate_force_x + limb_lower_m * minus_limb2_lower_acc_x - limb2_upper_sent_force_x;
    const REAL limb2_lower_joint_sent_force_y = t134 - limb2_lower_sin * minus_limb2_lower_sent_force_x;
    WRITE(reactions, 19, limb2_lower_joint_sent_force_y);
    WRITE(sized_, 19, limb2_lower_joint_sent_force_y);
    checked3 = checked3 + limb2_lower_joint_sent_force_y;
    const REAL minus_limb2_lower_joint_sent_force_x = limb2_lower_cos * minus_limb2_lower_sent_force_x + t132;
    RESULT(checked0, sized_, 18, -minus_limb2_lower_joint_sent_force_x);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_a_0 = READ(a, 3);
    const REAL t137 = limb2_U_0_sin * minus_limb2_lower_joint_sent_force_x;
    const REAL t133 = minus_limb2_U_0_cos * minus_limb2_lower_joint_sent_force_x;
    const REAL minus_limb2_lower_alpha_y = minus_limb2_lower_alpha_still_y - limb2_U_a_0 * limb2_lower_cos;
    const REAL limb2_lower_U_zx = minus_limb2_lower_alpha_still_y + minus_limb2_lower_alpha_y;
    const REAL t144 = k16 * minus_limb2_lower_alpha_y + k17 * minus_limb2_lower_alpha_still_y;
    const REAL t122 = limb2_upper_offset_x * limb2_lower_U_zx;
    const REAL limb2_lower_rate_force_z = limb_lower_mx * limb2_lower_U_zx;
    const REAL minus_limb2_upper_acc_z = limb2_P_v * (2.0 * limb2_lower_omega_y) - (t122 - gravity_z * minus_limb2_U_0_cos);
    const REAL limb2_lower_alpha_still_x = limb2_U_v_1 * limb2_lower_omega_y;
    const REAL minus_limb2_upper_sent_force_z = limb_lower_m * minus_limb2_upper_acc_z + limb2_lower_rate_force_z + multipliers_6;
    const REAL minus_limb2_upper_rate_moment_y_2 = limb_lower_mx * minus_limb2_upper_acc_z + t144;
    RESULT(checked1, sized_, 26, -minus_limb2_upper_sent_force_z);
    const REAL limb2_lower_sent_force_z = limb2_lower_rate_force_z - limb_lower_m_gravity_z * minus_limb2_U_0_cos - minus_limb2_upper_sent_force_z;
    WRITE(sized_, 20, limb2_lower_sent_force_z);
    const REAL minus_limb2_U_0_joint_sent_force_x = minus_limb2_U_0_cos * limb2_lower_sent_force_z - t137;
    RESULT(checked2, reactions, 20, -minus_limb2_U_0_joint_sent_force_x);
    const REAL t138 = param_R * minus_limb2_U_0_joint_sent_force_x;
    const REAL limb2_U_0_joint_sent_force_y = limb2_U_0_sin * limb2_lower_sent_force_z + t133;
    WRITE(reactions, 18, limb2_U_0_joint_sent_force_y);
    const REAL t151 = param_R * limb2_U_0_joint_sent_force_y;
    const REAL t146 = minus_limb2_upper_rate_moment_y_2 - limb2_upper_offset_x * minus_limb2_upper_sent_force_z;
    const REAL limb2_lower_sent_moment_y = gravity_z_limb_lower_mx * minus_limb2_U_0_cos - t144 - t146;
    const REAL t147 = limb2_lower_sin * limb2_lower_sent_moment_y;
    const REAL t150 = limb2_lower_cos * limb2_lower_sent_moment_y;
    const REAL t139 = k14 * (limb2_lower_alpha_still_x + limb2_U_a_0 * limb2_lower_sin);
    const REAL limb2_upper_rate_moment_x = t139 - k15 * limb2_lower_alpha_still_x;
    RESULT(checked3, sized_, 27, per_length * limb2_upper_rate_moment_x);
    const REAL limb2_lower_sent_moment_x = 2.0 * limb2_upper_rate_moment_x;
    const REAL limb2_lower_joint_sent_moment_x = limb2_lower_cos * limb2_lower_sent_moment_x - t147;
    RESULT(checked0, sized_, 21, per_length * limb2_lower_joint_sent_moment_x);
    const REAL limb2_lower_joint_sent_moment_y = limb2_lower_sin * limb2_lower_sent_moment_x + t150;
    WRITE(reactions, 22, limb2_lower_joint_sent_moment_y);
    RESULT(checked1, sized_, 22, per_length * limb2_lower_joint_sent_moment_y);
    /* limb2: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    RESULT(checked2, reactions, 21, t138 - minus_limb2_U_0_cos * limb2_lower_joint_sent_moment_x);
    RESULT(checked3, reactions, 23, t151 - limb2_U_0_sin * limb2_lower_joint_sent_moment_x);
    const REAL t156 = minus_limb2_U_0_cos * minus_limb2_upper_sent_force_z;
    const REAL t154 = limb2_U_0_sin * minus_limb2_upper_sent_force_z;
    const REAL limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin;
    const REAL limb2_P_reactions_fz = limb2_lower_rotation_zy * limb2_upper_sent_force_y + t156;
    WRITE(reactions, 26, limb2_P_reactions_fz);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL t165 = minus_limb2_upper_position_y * limb2_P_reactions_fz;
    const REAL limb2_P_reactions_fy = limb2_lower_cos * limb2_upper_sent_force_y;
    WRITE(reactions, 25, limb2_P_reactions_fy);
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx;
    const REAL t167 = t165 - minus_limb2_upper_position_z * limb2_P_reactions_fy;
    const REAL limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin;
    const REAL limb2_P_reactions_fx = limb2_lower_rotation_xy * limb2_upper_sent_force_y - t154;
    WRITE(reactions, 24, limb2_P_reactions_fx);
    const REAL t158 = limb2_lower_rotation_xy * minus_limb2_upper_rate_moment_y_2;
    const REAL t186 = limb2_lower_rotation_xy * multipliers_5;
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    const REAL minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx;
    const REAL t173 = minus_limb2_upper_position_x * limb2_P_reactions_fz;
    const REAL t180 = minus_limb2_upper_position_x * limb2_P_reactions_fy;
    const REAL t159 = minus_limb2_lower_rotation_xx * limb2_upper_rate_moment_x + t158;
    const REAL t187 = minus_limb2_lower_rotation_xx * multipliers_4 - t186;
    const REAL minus_limb2_upper_rate_moment_z_2 = minus_limb2_upper_rate_moment_z - (k18 * limb2_U_a_1 + t161);
    RESULT(checked0, reactions, 27, -(t159 + limb2_U_0_sin * minus_limb2_upper_rate_moment_z_2 + t167));
    const REAL t174 = minus_limb2_upper_position_z * limb2_P_reactions_fx - t173;
    const REAL t182 = t180 - minus_limb2_upper_position_y * limb2_P_reactions_fx;
    const REAL t170 = limb2_lower_cos * minus_limb2_upper_rate_moment_y_2;
    RESULT(checked1, reactions, 28, limb2_lower_sin * limb2_upper_rate_moment_x - t170 - t174);
    const REAL t175 = minus_limb2_lower_rotation_zx * limb2_upper_rate_moment_x;
    const REAL t177 = t175 + limb2_lower_rotation_zy * minus_limb2_upper_rate_moment_y_2;
    const REAL t195 = minus_limb2_lower_rotation_zx * multipliers_4 - limb2_lower_rotation_zy * multipliers_5;
    RESULT(checked2, sized_, 28, -(per_length * minus_limb2_upper_rate_moment_y_2));
    RESULT(checked3, reactions, 29, -(t177 - minus_limb2_U_0_cos * minus_limb2_upper_rate_moment_z_2 + t182));
    RESULT(checked0, sized_, 29, -(per_length * minus_limb2_upper_rate_moment_z_2));
    const REAL t184 = limb2_U_0_sin * multipliers_6;
    const REAL t188 = t184 - t187;
    RESULT(checked1, reactions, 30, -t188);
    const REAL t191 = limb2_lower_sin * multipliers_4 + limb2_lower_cos * multipliers_5;
    RESULT(checked2, reactions, 31, -t191);
    const REAL t192 = minus_limb2_U_0_cos * multipliers_6;
    const REAL limb2_S_reactions_fz = t192 + t195;
    WRITE(reactions, 32, limb2_S_reactions_fz);
    const REAL t196 = minus_limb2_upper_position_y * limb2_S_reactions_fz;
    const REAL t202 = minus_limb2_upper_position_y * t188;
    RESULT(checked3, reactions, 34, minus_limb2_upper_position_z * t188 + minus_limb2_upper_position_x * limb2_S_reactions_fz);
    RESULT(checked0, reactions, 33, -(t196 + minus_limb2_upper_position_z * t191));
    RESULT(checked1, reactions, 35, minus_limb2_upper_position_x * t191 - t202);
    /* limb3: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb3_U_v_0 = READ(v, 6), limb3_lower_cos = SINES(cosine, 5);
    const REAL limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos;
    const REAL limb3_U_v_1 = READ(v, 7);
    const REAL minus_limb3_lower_U_still_xx = limb3_lower_omega_y * limb3_lower_omega_y + limb3_U_v_1 * limb3_U_v_1;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_upper_acc_still_x = limb3_upper_offset_x * minus_limb3_lower_U_still_xx;
    const REAL minus_limb3_lower_rate_force_x = limb_lower_mx * minus_limb3_lower_U_still_xx;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    const REAL limb3_U_0_acc_y = gravity_z * limb3_U_0_cos;
    const REAL limb3_lower_acc_x = limb3_lower_cos * limb3_U_0_acc_y;
    const REAL limb3_upper_rate_force_x = minus_limb3_lower_rate_force_x + limb_lower_m * (READ(a, 8) - (minus_limb3_upper_acc_still_x - limb3_lower_acc_x));
    const REAL limb3_upper_sent_force_x = limb3_upper_rate_force_x - multipliers_7;
    const REAL minus_limb3_lower_sent_force_x = minus_limb3_lower_rate_force_x - limb_lower_m * limb3_lower_acc_x - limb3_upper_sent_force_x;
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y;
    const REAL t206 = minus_limb3_lower_sin * minus_limb3_lower_sent_force_x;
    const REAL t217 = limb3_lower_cos * minus_limb3_lower_sent_force_x;
    const REAL minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin;
    const REAL minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y;
    const REAL limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x;
    const REAL limb3_U_a_1 = READ(a, 7);
    const REAL limb3_lower_U_yx = limb3_U_a_1 - minus_limb3_lower_U_still_xy;
    const REAL t257 = k19 * minus_limb3_lower_U_still_xy;
    const REAL t210 = limb3_upper_offset_x * limb3_lower_U_yx + limb3_lower_acc_y;
    const REAL limb3_lower_rate_force_y = limb_lower_mx * limb3_lower_U_yx;
    const REAL limb3_P_v = READ(v, 8);
    const REAL limb3_lower_rate_force_y_2 = limb3_lower_rate_force_y + limb_lower_m * limb3_lower_acc_y;
    const REAL limb3_upper_acc_y = limb3_P_v * (2.0 * limb3_U_v_1) + t210;
    /* limb3: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    const REAL limb3_upper_sent_force_y = limb_lower_m * limb3_upper_acc_y - limb3_lower_rate_force_y - multipliers_8;
    WRITE(sized_, 43, limb3_upper_sent_force_y);
    const REAL limb3_lower_sent_force_y = limb3_lower_rate_force_y_2 + limb3_upper_sent_force_y;
    const REAL minus_limb3_upper_rate_moment_z = limb_lower_mx * limb3_upper_acc_y;
    const REAL limb3_lower_joint_sent_force_y = t206 + limb3_lower_cos * limb3_lower_sent_force_y;
    WRITE(reactions, 36, limb3_lower_joint_sent_force_y);
    WRITE(sized_, 37, limb3_lower_joint_sent_force_y);
    checked2 = checked2 + limb3_lower_joint_sent_force_y;
    const REAL minus_limb3_lower_joint_sent_force_x = t217 - minus_limb3_lower_sin * limb3_lower_sent_force_y;
    RESULT(checked3, sized_, 36, -minus_limb3_lower_joint_sent_force_x);
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_a_0 = READ(a, 6);
    const REAL t219 = limb3_U_0_sin * minus_limb3_lower_joint_sent_force_x;
    const REAL t221 = limb3_U_0_cos * minus_limb3_lower_joint_sent_force_x;
    const REAL limb3_lower_alpha_y = limb3_lower_alpha_still_y + limb3_U_a_0 * limb3_lower_cos;
    const REAL minus_limb3_lower_U_zx = limb3_lower_alpha_still_y + limb3_lower_alpha_y;
    const REAL t227 = k16 * limb3_lower_alpha_y + k17 * limb3_lower_alpha_still_y;
    const REAL t214 = limb3_upper_offset_x * minus_limb3_lower_U_zx;
    const REAL minus_limb3_lower_rate_force_z = limb_lower_mx * minus_limb3_lower_U_zx;
    const REAL minus_limb3_upper_acc_z = limb3_P_v * (2.0 * limb3_lower_omega_y) + (t214 - gravity_z * limb3_U_0_sin);
    const REAL limb3_lower_alpha_still_x = limb3_U_v_1 * limb3_lower_omega_y;
    const REAL minus_limb3_upper_sent_force_z = limb_lower_m * minus_limb3_upper_acc_z - minus_limb3_lower_rate_force_z + multipliers_9;
    const REAL minus_limb3_upper_rate_moment_y_2 = limb_lower_mx * minus_limb3_upper_acc_z - t227;
    RESULT(checked0, sized_, 44, -minus_limb3_upper_sent_force_z);
    const REAL minus_limb3_lower_sent_force_z = minus_limb3_lower_rate_force_z - limb_lower_m_gravity_z * limb3_U_0_sin + minus_limb3_upper_sent_force_z;
    RESULT(checked1, sized_, 38, -minus_limb3_lower_sent_force_z);
    const REAL minus_limb3_U_0_joint_sent_force_x = limb3_U_0_cos * minus_limb3_lower_sent_force_z - t219;
    RESULT(checked2, reactions, 37, -minus_limb3_U_0_joint_sent_force_x);
    const REAL minus_limb3_U_0_joint_sent_force_y = limb3_U_0_sin * minus_limb3_lower_sent_force_z + t221;
    RESULT(checked3, reactions, 38, -minus_limb3_U_0_joint_sent_force_y);
    const REAL t231 = param_R * minus_limb3_U_0_joint_sent_force_y;
    const REAL t236 = param_R * minus_limb3_U_0_joint_sent_force_x;
    const REAL t229 = minus_limb3_upper_rate_moment_y_2 - limb3_upper_offset_x * minus_limb3_upper_sent_force_z;
    const REAL minus_limb3_lower_sent_moment_y = gravity_z_limb_lower_mx * limb3_U_0_sin - t227 + t229;
    const REAL t230 = limb3_lower_cos * minus_limb3_lower_sent_moment_y;
    const REAL t233 = minus_limb3_lower_sin * minus_limb3_lower_sent_moment_y;
    const REAL t222 = k14 * (limb3_lower_alpha_still_x - limb3_U_a_0 * minus_limb3_lower_sin);
    const REAL limb3_upper_rate_moment_x = t222 - k15 * limb3_lower_alpha_still_x;
    RESULT(checked0, sized_, 45, per_length * limb3_upper_rate_moment_x);
    const REAL limb3_lower_sent_moment_x = 2.0 * limb3_upper_rate_moment_x;
    const REAL minus_limb3_lower_joint_sent_moment_y = minus_limb3_lower_sin * limb3_lower_sent_moment_x + t230;
    RESULT(checked1, reactions, 39, -minus_limb3_lower_joint_sent_moment_y);
    const REAL limb3_lower_joint_sent_moment_x = limb3_lower_cos * limb3_lower_sent_moment_x - t233;
    RESULT(checked2, sized_, 39, per_length * limb3_lower_joint_sent_moment_x);
    RESULT(checked3, sized_, 40, -(per_length * minus_limb3_lower_joint_sent_moment_y));
    /* limb3: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    RESULT(checked0, reactions, 40, t231 - limb3_U_0_sin * limb3_lower_joint_sent_moment_x);
    RESULT(checked1, reactions, 41, limb3_U_0_cos * limb3_lower_joint_sent_moment_x - t236);
    const REAL t238 = limb3_U_0_cos * minus_limb3_upper_sent_force_z;
    const REAL t241 = limb3_U_0_sin * minus_limb3_upper_sent_force_z;
    const REAL minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin;
    const REAL t239 = minus_limb3_lower_rotation_yy * limb3_upper_sent_force_y + t238;
    RESULT(checked2, reactions, 43, -t239);
    const REAL limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin;
    const REAL limb3_P_reactions_fz = limb3_lower_rotation_zy * limb3_upper_sent_force_y - t241;
    WRITE(reactions, 44, limb3_P_reactions_fz);
    const REAL limb3_P_reactions_fx = limb3_lower_cos * limb3_upper_sent_force_y;
    WRITE(reactions, 42, limb3_P_reactions_fx);
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    const REAL minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx;
    const REAL t245 = minus_limb3_upper_position_y * limb3_P_reactions_fz;
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    const REAL limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx;
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL t251 = limb3_upper_position_x * limb3_P_reactions_fz;
    const REAL t247 = t245 - limb3_upper_position_z * t239;
    const REAL t266 = limb3_upper_position_x * t239;
    const REAL t243 = limb3_lower_cos * minus_limb3_upper_rate_moment_y_2;
    RESULT(checked3, reactions, 45, -(minus_limb3_lower_sin * limb3_upper_rate_moment_x + t243 + t247));
    const REAL t252 = limb3_upper_position_z * limb3_P_reactions_fx - t251;
    const REAL t268 = t266 - minus_limb3_upper_position_y * limb3_P_reactions_fx;
    const REAL t254 = minus_limb3_lower_rotation_yy * minus_limb3_upper_rate_moment_y_2;
    const REAL t255 = minus_limb3_lower_rotation_yx * limb3_upper_rate_moment_x - t254;
    const REAL t261 = limb3_lower_rotation_zx * limb3_upper_rate_moment_x;
    const REAL t274 = minus_limb3_lower_rotation_yx * multipliers_7 + minus_limb3_lower_rotation_yy * multipliers_8;
    const REAL t277 = limb3_lower_rotation_zx * multipliers_7;
    const REAL minus_limb3_upper_rate_moment_z_2 = minus_limb3_upper_rate_moment_z - (k18 * limb3_U_a_1 - t257);
    RESULT(checked0, reactions, 46, t252 - (t255 + limb3_U_0_cos * minus_limb3_upper_rate_moment_z_2));
    const REAL t263 = t261 - limb3_lower_rotation_zy * minus_limb3_upper_rate_moment_y_2;
    const REAL t279 = t277 + limb3_lower_rotation_zy * multipliers_8;
    RESULT(checked1, sized_, 46, -(per_length * minus_limb3_upper_rate_moment_y_2));
    RESULT(checked2, reactions, 47, t263 - limb3_U_0_sin * minus_limb3_upper_rate_moment_z_2 - t268);
    RESULT(checked3, sized_, 47, -(per_length * minus_limb3_upper_rate_moment_z_2));
    const REAL t271 = limb3_U_0_cos * multipliers_9;
    const REAL t275 = t271 - t274;
    RESULT(checked0, reactions, 49, -t275);
    const REAL t276 = limb3_U_0_sin * multipliers_9;
    const REAL t280 = t276 + t279;
    RESULT(checked1, reactions, 50, -t280);
    const REAL t284 = limb3_upper_position_x * t280;
    const REAL t286 = limb3_upper_position_x * t275;
    RESULT(checked2, reactions, 51, minus_limb3_upper_position_y * t280 + limb3_upper_position_z * t275);
    const REAL limb3_S_reactions_fx = minus_limb3_lower_sin * multipliers_7 - limb3_lower_cos * multipliers_8;
    WRITE(reactions, 48, limb3_S_reactions_fx);
    RESULT(checked3, reactions, 52, limb3_upper_position_z * limb3_S_reactions_fx + t284);
    RESULT(checked0, reactions, 53, minus_limb3_upper_position_y * limb3_S_reactions_fx - t286);
    /* limb4: geometry; accelerations; momentum rate, eq. (35) */
    const REAL limb4_U_v_0 = READ(v, 9), limb4_lower_cos = SINES(cosine, 7);
    const REAL limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos;
    const REAL limb4_U_v_1 = READ(v, 10);
    const REAL minus_limb4_lower_U_still_xx = limb4_lower_omega_y * limb4_lower_omega_y + limb4_U_v_1 * limb4_U_v_1;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_upper_acc_still_x = limb4_upper_offset_x * minus_limb4_lower_U_still_xx;
    const REAL minus_limb4_lower_rate_force_x = limb_lower_mx * minus_limb4_lower_U_still_xx;
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    const REAL minus_limb4_U_0_acc_y = gravity_z * limb4_U_0_sin;
    const REAL minus_limb4_lower_acc_x = limb4_lower_cos * minus_limb4_U_0_acc_y;
    const REAL limb4_upper_rate_force_x = minus_limb4_lower_rate_force_x + limb_lower_m * (READ(a, 11) - (minus_limb4_upper_acc_still_x + minus_limb4_lower_acc_x));
    const REAL limb4_upper_sent_force_x = limb4_upper_rate_force_x - multipliers_10;
    const REAL minus_limb4_lower_sent_force_x = minus_limb4_lower_rate_force_x + limb_lower_m * minus_limb4_lower_acc_x - limb4_upper_sent_force_x;
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y;
    const REAL t295 = limb4_lower_cos * minus_limb4_lower_sent_force_x;
    const REAL t302 = minus_limb4_lower_sin * minus_limb4_lower_sent_force_x;
    const REAL minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin;
    const REAL minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y;
    const REAL limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x;
    const REAL limb4_U_a_1 = READ(a, 10);
    const REAL limb4_lower_U_yx = limb4_U_a_1 - minus_limb4_lower_U_still_xy;
    const REAL t331 = k19 * minus_limb4_lower_U_still_xy;
    const REAL t299 = limb4_upper_offset_x * limb4_lower_U_yx - minus_limb4_lower_acc_y;
    const REAL limb4_lower_rate_force_y = limb_lower_mx * limb4_lower_U_yx;
    const REAL limb4_P_v = READ(v, 11);
    const REAL limb4_lower_rate_force_y_2 = limb4_lower_rate_force_y - limb_lower_m * minus_limb4_lower_acc_y;
    const REAL limb4_upper_acc_y = limb4_P_v * (2.0 * limb4_U_v_1) + t299;
    /* limb4: balance, eqs. (40)-(47); momentum rate, eq. (35); accelerations */
    const REAL limb4_upper_sent_force_y = limb_lower_m * limb4_upper_acc_y - limb4_lower_rate_force_y - multipliers_11;
    WRITE(sized_, 61, limb4_upper_sent_force_y);
    const REAL limb4_lower_sent_force_y = limb4_lower_rate_force_y_2 + limb4_upper_sent_force_y;
    const REAL minus_limb4_upper_rate_moment_z = limb_lower_mx * limb4_upper_acc_y;
    const REAL minus_limb4_lower_joint_sent_force_x = t295 - minus_limb4_lower_sin * limb4_lower_sent_force_y;
    const REAL limb4_lower_joint_sent_force_y = t302 + limb4_lower_cos * limb4_lower_sent_force_y;
    WRITE(reactions, 55, limb4_lower_joint_sent_force_y);
    WRITE(sized_, 55, limb4_lower_joint_sent_force_y);
    checked1 = checked1 + limb4_lower_joint_sent_force_y;
    RESULT(checked2, sized_, 54, -minus_limb4_lower_joint_sent_force_x);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_a_0 = READ(a, 9);
    const REAL t301 = minus_limb4_U_0_cos * minus_limb4_lower_joint_sent_force_x;
    const REAL t305 = limb4_U_0_sin * minus_limb4_lower_joint_sent_force_x;
    const REAL limb4_lower_alpha_y = limb4_lower_alpha_still_y + limb4_U_a_0 * limb4_lower_cos;
    const REAL minus_limb4_lower_U_zx = limb4_lower_alpha_still_y + limb4_lower_alpha_y;
    const REAL t312 = k16 * limb4_lower_alpha_y + k17 * limb4_lower_alpha_still_y;
    const REAL t290 = limb4_upper_offset_x * minus_limb4_lower_U_zx;
    const REAL minus_limb4_lower_rate_force_z = limb_lower_mx * minus_limb4_lower_U_zx;
    const REAL minus_limb4_upper_acc_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + (t290 + gravity_z * minus_limb4_U_0_cos);
    const REAL limb4_lower_alpha_still_x = limb4_U_v_1 * limb4_lower_omega_y;
    const REAL minus_limb4_upper_sent_force_z = limb_lower_m * minus_limb4_upper_acc_z - minus_limb4_lower_rate_force_z + multipliers_12;
    const REAL minus_limb4_upper_rate_moment_y_2 = limb_lower_mx * minus_limb4_upper_acc_z - t312;
    RESULT(checked3, sized_, 62, -minus_limb4_upper_sent_force_z);
    const REAL minus_limb4_lower_sent_force_z = minus_limb4_lower_rate_force_z + limb_lower_m_gravity_z * minus_limb4_U_0_cos + minus_limb4_upper_sent_force_z;
    RESULT(checked0, sized_, 56, -minus_limb4_lower_sent_force_z);
    const REAL minus_limb4_U_0_joint_sent_force_y = limb4_U_0_sin * minus_limb4_lower_sent_force_z - t301;
    RESULT(checked1, reactions, 54, -minus_limb4_U_0_joint_sent_force_y);
    const REAL limb4_U_0_joint_sent_force_x = minus_limb4_U_0_cos * minus_limb4_lower_sent_force_z + t305;
    WRITE(reactions, 56, limb4_U_0_joint_sent_force_x);
    const REAL t306 = param_R * limb4_U_0_joint_sent_force_x;
    const REAL t319 = param_R * minus_limb4_U_0_joint_sent_force_y;
    const REAL t314 = minus_limb4_upper_rate_moment_y_2 - limb4_upper_offset_x * minus_limb4_upper_sent_force_z;
    const REAL limb4_lower_sent_moment_y = gravity_z_limb_lower_mx * minus_limb4_U_0_cos + t312 - t314;
    const REAL t315 = minus_limb4_lower_sin * limb4_lower_sent_moment_y;
    const REAL t318 = limb4_lower_cos * limb4_lower_sent_moment_y;
    const REAL t307 = k14 * (limb4_lower_alpha_still_x - limb4_U_a_0 * minus_limb4_lower_sin);
    const REAL limb4_upper_rate_moment_x = t307 - k15 * limb4_lower_alpha_still_x;
    RESULT(checked2, sized_, 63, per_length * limb4_upper_rate_moment_x);
    const REAL limb4_lower_sent_moment_x = 2.0 * limb4_upper_rate_moment_x;
    const REAL limb4_lower_joint_sent_moment_x = limb4_lower_cos * limb4_lower_sent_moment_x + t315;
    const REAL minus_limb4_lower_joint_sent_moment_y = minus_limb4_lower_sin * limb4_lower_sent_moment_x - t318;
    RESULT(checked3, reactions, 58, -minus_limb4_lower_joint_sent_moment_y);
    RESULT(checked0, sized_, 57, per_length * limb4_lower_joint_sent_moment_x);
    RESULT(checked1, sized_, 58, -(per_length * minus_limb4_lower_joint_sent_moment_y));
    /* limb4: reactions, eq. (32); geometry; momentum rate, eq. (35) */
    RESULT(checked2, reactions, 57, t306 - minus_limb4_U_0_cos * limb4_lower_joint_sent_moment_x);
    RESULT(checked3, reactions, 59, t319 - limb4_U_0_sin * limb4_lower_joint_sent_moment_x);
    const REAL t322 = limb4_U_0_sin * minus_limb4_upper_sent_force_z;
    const REAL t325 = minus_limb4_U_0_cos * minus_limb4_upper_sent_force_z;
    const REAL minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin;
    const REAL t323 = minus_limb4_lower_rotation_xy * limb4_upper_sent_force_y + t322;
    RESULT(checked0, reactions, 60, -t323);
    const REAL minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin;
    const REAL t326 = minus_limb4_lower_rotation_zy * limb4_upper_sent_force_y - t325;
    RESULT(checked1, reactions, 62, -t326);
    const REAL limb4_P_reactions_fy = limb4_lower_cos * limb4_upper_sent_force_y;
    WRITE(reactions, 61, limb4_P_reactions_fy);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL t336 = limb4_upper_position_y * t326;
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx;
    const REAL t338 = t336 - minus_limb4_upper_position_z * limb4_P_reactions_fy;
    const REAL t328 = minus_limb4_lower_rotation_xy * minus_limb4_upper_rate_moment_y_2;
    const REAL t357 = minus_limb4_lower_rotation_xy * multipliers_11;
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    const REAL minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx;
    const REAL t341 = minus_limb4_upper_position_x * t326;
    const REAL t351 = minus_limb4_upper_position_x * limb4_P_reactions_fy;
    const REAL t329 = minus_limb4_lower_rotation_xx * limb4_upper_rate_moment_x - t328;
    const REAL t358 = minus_limb4_lower_rotation_xx * multipliers_10 + t357;
    const REAL minus_limb4_upper_rate_moment_z_2 = minus_limb4_upper_rate_moment_z - (k18 * limb4_U_a_1 - t331);
    RESULT(checked2, reactions, 63, -(t329 + limb4_U_0_sin * minus_limb4_upper_rate_moment_z_2 + t338));
    const REAL t342 = minus_limb4_upper_position_z * t323 - t341;
    const REAL t353 = t351 - limb4_upper_position_y * t323;
    const REAL t344 = limb4_lower_cos * minus_limb4_upper_rate_moment_y_2;
    RESULT(checked3, reactions, 64, t342 - (minus_limb4_lower_sin * limb4_upper_rate_moment_x + t344));
    const REAL t346 = minus_limb4_lower_rotation_zx * limb4_upper_rate_moment_x;
    const REAL t348 = t346 - minus_limb4_lower_rotation_zy * minus_limb4_upper_rate_moment_y_2;
    const REAL t365 = minus_limb4_lower_rotation_zx * multipliers_10 + minus_limb4_lower_rotation_zy * multipliers_11;
    RESULT(checked0, sized_, 64, -(per_length * minus_limb4_upper_rate_moment_y_2));
    RESULT(checked1, reactions, 65, -(t348 - minus_limb4_U_0_cos * minus_limb4_upper_rate_moment_z_2 + t353));
    RESULT(checked2, sized_, 65, -(per_length * minus_limb4_upper_rate_moment_z_2));
    const REAL t355 = limb4_U_0_sin * multipliers_12;
    const REAL t359 = t355 - t358;
    RESULT(checked3, reactions, 66, -t359);
    const REAL t362 = minus_limb4_U_0_cos * multipliers_12;
    const REAL limb4_S_reactions_fz = t362 + t365;
    WRITE(reactions, 68, limb4_S_reactions_fz);
    const REAL t366 = limb4_upper_position_y * limb4_S_reactions_fz;
    const REAL t370 = limb4_upper_position_y * t359;
    RESULT(checked0, reactions, 70, minus_limb4_upper_position_z * t359 + minus_limb4_upper_position_x * limb4_S_reactions_fz);
    const REAL limb4_S_reactions_fy = minus_limb4_lower_sin * multipliers_10 - limb4_lower_cos * multipliers_11;
    WRITE(reactions, 67, limb4_S_reactions_fy);
    RESULT(checked1, reactions, 69, t366 + minus_limb4_upper_position_z * limb4_S_reactions_fy);
    RESULT(checked2, reactions, 71, t370 - minus_limb4_upper_position_x * limb4_S_reactions_fy);
    /* platform: geometry; accelerations; momentum rate, eq. (35) */
    const REAL platform_turn_zx = t373 - t374;
    const REAL limb5_S_v_wx = READ(v, 12), limb5_S_v_wz = READ(v, 14);
    const REAL platform_turn_xz = t373 + t374;
    const REAL t375 = platform_m_gravity_z * platform_turn_zx;
    const REAL platform_rate_force_x_2 = platform_mz * (READ(a, 13) + limb5_S_v_wx * limb5_S_v_wz) + t375;
    const REAL limb5_S_v_wy = READ(v, 13);
    /* platform: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t376 = platform_turn_xx * platform_rate_force_x_2;
    const REAL t400 = platform_turn_yx * platform_rate_force_x_2;
    const REAL t418 = platform_turn_zx * platform_rate_force_x_2;
    const REAL t377 = platform_m_gravity_z * platform_turn_zy;
    const REAL minus_platform_rate_force_y_2 = platform_mz * (READ(a, 12) - limb5_S_v_wy * limb5_S_v_wz) - t377;
    const REAL t379 = t376 - platform_turn_xy * minus_platform_rate_force_y_2;
    const REAL t402 = t400 - platform_turn_yy * minus_platform_rate_force_y_2;
    const REAL t420 = t418 - platform_turn_zy * minus_platform_rate_force_y_2;
    const REAL t384 = platform_m_gravity_z * platform_turn_zz;
    const REAL minus_platform_rate_force_z_2 = platform_mz * (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy) - t384;
    const REAL t387 = t379 - platform_turn_xz * minus_platform_rate_force_z_2 + t92;
    const REAL t404 = t402 - platform_turn_yz * minus_platform_rate_force_z_2;
    const REAL t422 = t420 - platform_turn_zz * minus_platform_rate_force_z_2;
    const REAL t390 = limb2_lower_cos * multipliers_4 - limb2_lower_sin * multipliers_5;
    const REAL t394 = t387 + (t184 - minus_limb2_U_0_cos * t390) - limb3_S_reactions_fx;
    const REAL t427 = t192 + limb2_U_0_sin * t390;
    const REAL t397 = limb4_lower_cos * multipliers_10 + minus_limb4_lower_sin * multipliers_11;
    const REAL platform_joint_sent_force_x = t394 + (t355 - minus_limb4_U_0_cos * t397);
    WRITE(reactions, 72, platform_joint_sent_force_x);
    WRITE(sized_, 72, platform_joint_sent_force_x);
    checked3 = checked3 + platform_joint_sent_force_x;
    const REAL t433 = t362 + limb4_U_0_sin * t397;
    const REAL t407 = limb1_lower_cos * multipliers_0 - limb1_lower_sin * multipliers_1;
    const REAL t411 = t404 + (t93 - limb1_U_0_sin * t407) + t191;
    const REAL t428 = t422 + (t98 + limb1_U_0_cos * t407) - t427;
    const REAL t414 = limb3_lower_cos * multipliers_7 + minus_limb3_lower_sin * multipliers_8;
    const REAL platform_joint_sent_force_y = t411 + (t271 - limb3_U_0_sin * t414) - limb4_S_reactions_fy;
    WRITE(reactions, 73, platform_joint_sent_force_y);
    WRITE(sized_, 73, platform_joint_sent_force_y);
    checked0 = checked0 + platform_joint_sent_force_y;
    const REAL platform_joint_sent_force_z = t428 + (t276 + limb3_U_0_cos * t414) - t433;
    WRITE(reactions, 74, platform_joint_sent_force_z);
    WRITE(sized_, 74, platform_joint_sent_force_z);
    checked1 = checked1 + platform_joint_sent_force_z;
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
