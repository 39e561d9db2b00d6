/*
 * three_ups_upu_s: momentum.
 *   momentum_screws; momentum_rates; energy; mass_matrix; bias
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

BODY(three_ups_upu_s_momentum_screws)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict momenta, double *restrict total_, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    /* limb1: geometry */
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1),
      minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos, limb1_lower_sin = SINES(sine, 1);
    /* limb1: momentum, eq. (31); geometry; velocities, eq. (6) */
    const REAL t139 = 0.5 * minus_limb1_lower_rotation_yx, limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin,
      t141 = t139 - k1 * limb1_lower_rotation_yy, t143 = limb_lower_com_x * t141,
      t146 = k1 * minus_limb1_lower_rotation_yx + 0.5 * limb1_lower_rotation_yy,
      t149 = param_R * t141 - (t143 - limb_lower_com_z * t146), limb1_U_v_0 = READ(v, 0), t168 = limb1_U_v_0 * t149,
      t154 = 0.5 * limb1_lower_sin + k1 * limb1_lower_cos, t156 = param_R - param_R * t154,
      t157 = limb_lower_com_x * t154, t160 = k1 * limb1_lower_sin - 0.5 * limb1_lower_cos,
      t163 = t156 + (t157 - limb_lower_com_z * t160), limb1_U_v_1 = READ(v, 1), limb1_U_0_cos = SINES(cosine, 0),
      limb1_lower_twist_wy = limb1_U_v_1 * limb1_U_0_cos, t170 = t168 - limb1_lower_twist_wy * t163,
      minus_limb1_lower_twist_vz = limb1_U_v_1 * (param_R * limb1_U_0_cos),
      minus_limb1_lower_momentum_pz = limb_lower_m * (minus_limb1_lower_twist_vz + t170),
      limb1_lower_momentum_pz = -minus_limb1_lower_momentum_pz;
    WRITE(momenta, 8, limb1_lower_momentum_pz);
    REAL checked0 = limb1_lower_momentum_pz;
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos, t127 = 0.5 * limb1_lower_rotation_zx,
      minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin,
      t129 = t127 - k1 * minus_limb1_lower_rotation_zy, t131 = limb_lower_com_x * t129,
      t134 = k1 * limb1_lower_rotation_zx + 0.5 * minus_limb1_lower_rotation_zy,
      t137 = param_R * t129 - (t131 - limb_lower_com_z * t134), t165 = limb1_U_v_0 * t137,
      limb1_lower_twist_wz = limb1_U_v_1 * limb1_U_0_sin, t166 = limb1_lower_twist_wz * t163 + t165,
      limb1_lower_twist_vy = limb1_U_v_1 * (param_R * limb1_U_0_sin),
      limb1_lower_momentum_py = limb_lower_m * (limb1_lower_twist_vy - t166);
    WRITE(momenta, 7, limb1_lower_momentum_py);
    const REAL t223 = t163 * limb1_lower_momentum_py, t196 = t163 * minus_limb1_lower_momentum_pz,
      limb1_lower_momentum_px = limb_lower_m * (limb1_lower_twist_wy * t137 + limb1_lower_twist_wz * t149);
    WRITE(momenta, 6, limb1_lower_momentum_px);
    const REAL t225 = t223 - t149 * limb1_lower_momentum_px, t172 = t149 * minus_limb1_lower_momentum_pz,
      t228 = limb_lower_Ixx * t129 - limb_lower_Ixz * t134, t236 = t141 * t228, t237 = limb_lower_Iyy * limb1_U_0_sin,
      t239 = t236 - limb1_U_0_cos * t237, t245 = limb1_U_0_sin * t237,
      t232 = limb_lower_Ixz * t129 - limb_lower_Izz * t134, t242 = limb1_lower_twist_wy * (t239 - t146 * t232),
      t243 = limb1_U_v_0 * (t154 * t228 - t160 * t232) - t242,
      t250 = t243 + limb1_lower_twist_wz * (t129 * t228 + t245 - t134 * t232),
      minus_limb1_lower_momentum_Lz = t225 - t250, limb1_lower_momentum_Lz = -minus_limb1_lower_momentum_Lz;
    WRITE(momenta, 11, limb1_lower_momentum_Lz);
    REAL checked1 = limb1_lower_momentum_Lz;
    const REAL t262 = 0.5 * t141 - param_H * t146, limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      limb1_P_v = READ(v, 2), t263 = limb1_upper_offset_x * minus_limb1_lower_rotation_yx + t262,
      limb1_upper_twist_vy = limb1_lower_twist_vy - limb1_P_v * minus_limb1_lower_rotation_yx,
      t267 = t263 - (limb_upper_com_x * t141 - limb_upper_com_z * t146), t285 = limb1_U_v_0 * t267,
      t275 = param_R - limb1_lower_sin * limb1_upper_offset_x - (0.5 * t154 - param_H * t160),
      limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx,
      minus_limb1_upper_twist_vz = minus_limb1_lower_twist_vz - limb1_P_v * limb1_lower_rotation_zx,
      t279 = t275 + (limb_upper_com_x * t154 - limb_upper_com_z * t160),
      minus_limb1_upper_momentum_pz = limb_lower_m * (minus_limb1_upper_twist_vz + (t285 - limb1_lower_twist_wy * t279)),
      limb1_upper_momentum_pz = -minus_limb1_upper_momentum_pz;
    WRITE(momenta, 14, limb1_upper_momentum_pz);
    REAL checked2 = limb1_upper_momentum_pz;
    const REAL t254 = limb1_upper_position_z + (0.5 * t129 - param_H * t134),
      t258 = t254 - (limb_upper_com_x * t129 - limb_upper_com_z * t134),
      limb1_upper_momentum_px = limb_lower_m * (limb1_P_v * limb1_lower_sin + (limb1_lower_twist_wy * t258 + limb1_lower_twist_wz * t267));
    WRITE(momenta, 12, limb1_upper_momentum_px);
    const REAL t294 = t258 * limb1_upper_momentum_px - t279 * minus_limb1_upper_momentum_pz,
      t200 = limb_lower_Ixx * t141 - limb_lower_Ixz * t146, t208 = t141 * t200, t209 = limb_lower_Iyy * limb1_U_0_cos,
      t211 = t208 + limb1_U_0_cos * t209, t217 = limb1_U_0_sin * t209,
      t204 = limb_lower_Ixz * t141 - limb_lower_Izz * t146, t214 = limb1_lower_twist_wy * (t211 - t146 * t204),
      t215 = limb1_U_v_0 * (t154 * t200 - t160 * t204) - t214,
      t222 = t215 + limb1_lower_twist_wz * (t129 * t200 - t217 - t134 * t204),
      minus_limb1_upper_momentum_Ly = t222 - t294, limb1_upper_momentum_Ly = -minus_limb1_upper_momentum_Ly;
    WRITE(momenta, 16, limb1_upper_momentum_Ly);
    REAL checked3 = limb1_upper_momentum_Ly;
    /* limb2: geometry */
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_lower_cos = SINES(cosine, 3),
      minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos, limb2_lower_sin = SINES(sine, 3);
    /* limb2: momentum, eq. (31); geometry; velocities, eq. (6) */
    const REAL t326 = 0.5 * minus_limb2_lower_rotation_xx,
      limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin, t328 = t326 + k1 * limb2_lower_rotation_xy,
      t330 = limb_lower_com_x * t328, t333 = k1 * minus_limb2_lower_rotation_xx - 0.5 * limb2_lower_rotation_xy,
      t336 = param_R * t328 - (t330 - limb_lower_com_z * t333), limb2_U_v_0 = READ(v, 3), t341 = limb2_U_v_0 * t336,
      t313 = 0.5 * limb2_lower_sin - k1 * limb2_lower_cos, t315 = param_R - param_R * t313,
      t316 = limb_lower_com_x * t313, t319 = k1 * limb2_lower_sin + 0.5 * limb2_lower_cos,
      t322 = t315 + (t316 - limb_lower_com_z * t319), limb2_U_v_1 = READ(v, 4), limb2_U_0_sin = SINES(cosine, 2),
      limb2_lower_twist_wx = limb2_U_v_1 * limb2_U_0_sin, t342 = limb2_lower_twist_wx * t322 - t341,
      limb2_lower_twist_vz = limb2_U_v_1 * (param_R * limb2_U_0_sin),
      limb2_lower_momentum_pz = limb_lower_m * (limb2_lower_twist_vz - t342);
    WRITE(momenta, 20, limb2_lower_momentum_pz);
    const REAL t344 = t322 * limb2_lower_momentum_pz, minus_limb2_lower_twist_wz = limb2_U_v_1 * minus_limb2_U_0_cos,
      t337 = minus_limb2_lower_twist_wz * t336, minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos,
      t299 = 0.5 * minus_limb2_lower_rotation_zx, limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin,
      t301 = t299 + k1 * limb2_lower_rotation_zy, t303 = limb_lower_com_x * t301,
      t306 = k1 * minus_limb2_lower_rotation_zx - 0.5 * limb2_lower_rotation_zy,
      t309 = param_R * t301 - (t303 - limb_lower_com_z * t306),
      limb2_lower_momentum_py = limb_lower_m * (t337 + limb2_lower_twist_wx * t309);
    WRITE(momenta, 19, limb2_lower_momentum_py);
    const REAL t346 = t344 - t309 * limb2_lower_momentum_py, t351 = limb_lower_Ixx * t328 - limb_lower_Ixz * t333,
      t352 = t328 * t351, t347 = limb_lower_Iyy * limb2_U_0_sin, t353 = limb2_U_0_sin * t347 + t352,
      t365 = minus_limb2_U_0_cos * t347, t356 = limb_lower_Ixz * t328 - limb_lower_Izz * t333,
      t359 = limb2_lower_twist_wx * (t353 - t333 * t356), t364 = t359 - limb2_U_v_0 * (t313 * t351 - t319 * t356),
      t371 = t364 + minus_limb2_lower_twist_wz * (t365 - t301 * t351 + t306 * t356),
      minus_limb2_lower_momentum_Lx = t346 - t371;
    RESULT(checked0, momenta, 21, -minus_limb2_lower_momentum_Lx);
    const REAL t324 = limb2_U_v_0 * t309 + minus_limb2_lower_twist_wz * t322,
      limb2_lower_twist_vx = limb2_U_v_1 * (param_R * minus_limb2_U_0_cos),
      limb2_lower_momentum_px = limb_lower_m * (limb2_lower_twist_vx - t324);
    WRITE(momenta, 18, limb2_lower_momentum_px);
    const REAL t374 = t309 * limb2_lower_momentum_px - t336 * limb2_lower_momentum_pz,
      t397 = t336 * limb2_lower_momentum_py - t322 * limb2_lower_momentum_px,
      t377 = limb_lower_Ixx * t313 - limb_lower_Ixz * t319, t378 = t328 * t377,
      t381 = limb_lower_Ixz * t313 - limb_lower_Izz * t319, t384 = limb2_lower_twist_wx * (t378 - t333 * t381),
      t389 = t384 - limb2_U_v_0 * (t313 * t377 - t319 * t381),
      t394 = t389 - minus_limb2_lower_twist_wz * (t301 * t377 - t306 * t381),
      minus_limb2_lower_momentum_Ly = t374 + t394;
    RESULT(checked1, momenta, 22, -minus_limb2_lower_momentum_Ly);
    const REAL t402 = limb_lower_Ixx * t301 - limb_lower_Ixz * t306, t403 = t328 * t402,
      t398 = limb_lower_Iyy * minus_limb2_U_0_cos, t404 = limb2_U_0_sin * t398 - t403,
      t416 = minus_limb2_U_0_cos * t398, t407 = limb_lower_Ixz * t301 - limb_lower_Izz * t306,
      t410 = limb2_lower_twist_wx * (t404 + t333 * t407), t415 = t410 + limb2_U_v_0 * (t313 * t402 - t319 * t407),
      t422 = t415 + minus_limb2_lower_twist_wz * (t416 + t301 * t402 - t306 * t407),
      minus_limb2_lower_momentum_Lz = t397 + t422;
    RESULT(checked2, momenta, 23, -minus_limb2_lower_momentum_Lz);
    const REAL t426 = 0.5 * t301 - param_H * t306, t430 = limb_upper_com_x * t301 - limb_upper_com_z * t306,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      t431 = limb2_upper_offset_x * minus_limb2_lower_rotation_zx + t426 - t430, limb2_P_v = READ(v, 5),
      limb2_upper_twist_vz = limb2_lower_twist_vz - limb2_P_v * minus_limb2_lower_rotation_zx,
      t432 = limb2_U_v_0 * t431, t439 = limb_upper_com_x * t313 - limb_upper_com_z * t319,
      t436 = param_R - limb2_lower_sin * limb2_upper_offset_x - (0.5 * t313 - param_H * t319), t440 = t436 + t439,
      minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx,
      limb2_upper_twist_vx = limb2_lower_twist_vx - limb2_P_v * minus_limb2_lower_rotation_xx,
      limb2_upper_momentum_px = limb_lower_m * (limb2_upper_twist_vx - (t432 + minus_limb2_lower_twist_wz * t440));
    WRITE(momenta, 24, limb2_upper_momentum_px);
    const REAL t464 = t431 * limb2_upper_momentum_px,
      t447 = minus_limb2_upper_position_x + (0.5 * t328 - param_H * t333),
      t451 = t447 - (limb_upper_com_x * t328 - limb_upper_com_z * t333), t452 = minus_limb2_lower_twist_wz * t451,
      limb2_upper_momentum_pz = limb_lower_m * (limb2_upper_twist_vz - (limb2_lower_twist_wx * t440 - limb2_U_v_0 * t451));
    WRITE(momenta, 26, limb2_upper_momentum_pz);
    const REAL t454 = t452 + limb2_lower_twist_wx * t431,
      minus_limb2_upper_momentum_Ly = t394 + (t464 - t451 * limb2_upper_momentum_pz);
    RESULT(checked3, momenta, 28, -minus_limb2_upper_momentum_Ly);
    const REAL limb2_upper_momentum_py = limb_lower_m * (limb2_P_v * limb2_lower_sin + t454);
    WRITE(momenta, 25, limb2_upper_momentum_py);
    const REAL t462 = t431 * limb2_upper_momentum_py,
      minus_limb2_upper_momentum_Lz = t422 + (t451 * limb2_upper_momentum_py - t440 * limb2_upper_momentum_px);
    RESULT(checked0, momenta, 29, -minus_limb2_upper_momentum_Lz);
    const REAL limb2_upper_momentum_Lx = t371 - (t440 * limb2_upper_momentum_pz - t462);
    WRITE(momenta, 27, limb2_upper_momentum_Lx);
    /* limb3: geometry */
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_lower_cos = SINES(cosine, 5),
      limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos, minus_limb3_lower_sin = SINES(sine, 5);
    /* limb3: momentum, eq. (31); geometry; velocities, eq. (6) */
    const REAL t471 = 0.5 * limb3_lower_rotation_zx, limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin,
      t473 = t471 - k1 * limb3_lower_rotation_zy, t475 = limb_lower_com_x * t473,
      t478 = k1 * limb3_lower_rotation_zx + 0.5 * limb3_lower_rotation_zy,
      t481 = param_R * t473 - (t475 - limb_lower_com_z * t478), limb3_U_v_0 = READ(v, 6), t509 = limb3_U_v_0 * t481,
      t498 = 0.5 * minus_limb3_lower_sin + k1 * limb3_lower_cos, t500 = param_R - param_R * t498,
      t501 = limb_lower_com_x * t498, t504 = k1 * minus_limb3_lower_sin - 0.5 * limb3_lower_cos,
      t507 = t500 + (t501 - limb_lower_com_z * t504), limb3_U_v_1 = READ(v, 7), limb3_U_0_sin = SINES(sine, 4),
      limb3_lower_twist_wz = limb3_U_v_1 * limb3_U_0_sin, t510 = limb3_lower_twist_wz * t507 - t509,
      minus_limb3_lower_twist_vy = limb3_U_v_1 * (param_R * limb3_U_0_sin),
      minus_limb3_lower_momentum_py = limb_lower_m * (minus_limb3_lower_twist_vy - t510);
    RESULT(checked1, momenta, 31, -minus_limb3_lower_momentum_py);
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos,
      t483 = 0.5 * minus_limb3_lower_rotation_yx,
      minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin,
      t485 = t483 - k1 * minus_limb3_lower_rotation_yy, t487 = limb_lower_com_x * t485,
      t490 = k1 * minus_limb3_lower_rotation_yx + 0.5 * minus_limb3_lower_rotation_yy,
      t493 = param_R * t485 - (t487 - limb_lower_com_z * t490), t512 = limb3_U_v_0 * t493,
      limb3_lower_twist_wy = limb3_U_v_1 * limb3_U_0_cos, t514 = t512 + limb3_lower_twist_wy * t507,
      limb3_lower_twist_vz = limb3_U_v_1 * (param_R * limb3_U_0_cos),
      limb3_lower_momentum_pz = limb_lower_m * (limb3_lower_twist_vz - t514);
    WRITE(momenta, 32, limb3_lower_momentum_pz);
    const REAL t518 = t493 * limb3_lower_momentum_pz - t481 * minus_limb3_lower_momentum_py,
      t521 = limb_lower_Ixx * t498 - limb_lower_Ixz * t504, t522 = t498 * t521,
      t525 = limb_lower_Ixz * t498 - limb_lower_Izz * t504, t528 = limb3_U_v_0 * (t522 - t504 * t525),
      t533 = t528 + limb3_lower_twist_wy * (t485 * t521 - t490 * t525),
      t538 = t533 - limb3_lower_twist_wz * (t473 * t521 - t478 * t525), minus_limb3_lower_momentum_Lx = t518 - t538;
    RESULT(checked2, momenta, 33, -minus_limb3_lower_momentum_Lx);
    const REAL t567 = t507 * minus_limb3_lower_momentum_py, t540 = t507 * limb3_lower_momentum_pz,
      limb3_lower_momentum_px = limb_lower_m * (limb3_lower_twist_wy * t481 + limb3_lower_twist_wz * t493);
    WRITE(momenta, 30, limb3_lower_momentum_px);
    const REAL t569 = t567 - t493 * limb3_lower_momentum_px, t541 = t481 * limb3_lower_momentum_px - t540,
      t572 = limb_lower_Ixx * t473 - limb_lower_Ixz * t478, t580 = t485 * t572, t581 = limb_lower_Iyy * limb3_U_0_sin,
      t583 = t580 - limb3_U_0_cos * t581, t589 = limb3_U_0_sin * t581,
      t576 = limb_lower_Ixz * t473 - limb_lower_Izz * t478, t586 = limb3_lower_twist_wy * (t583 - t490 * t576),
      t587 = limb3_U_v_0 * (t498 * t572 - t504 * t576) + t586,
      t594 = t587 - limb3_lower_twist_wz * (t473 * t572 + t589 - t478 * t576),
      minus_limb3_lower_momentum_Lz = t569 + t594;
    RESULT(checked3, momenta, 35, -minus_limb3_lower_momentum_Lz);
    const REAL t597 = 0.5 * t473 - param_H * t478, limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      limb3_P_v = READ(v, 8), t598 = limb3_upper_offset_x * limb3_lower_rotation_zx + t597,
      limb3_upper_twist_vz = limb3_lower_twist_vz + limb3_P_v * limb3_lower_rotation_zx,
      t602 = t598 - (limb_upper_com_x * t473 - limb_upper_com_z * t478), t603 = limb3_lower_twist_wy * t602,
      t607 = limb3_upper_offset_x * minus_limb3_lower_rotation_yx + (0.5 * t485 - param_H * t490),
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x,
      minus_limb3_upper_twist_vy = minus_limb3_lower_twist_vy + limb3_P_v * minus_limb3_lower_rotation_yx,
      t611 = t607 - (limb_upper_com_x * t485 - limb_upper_com_z * t490),
      minus_limb3_upper_momentum_px = limb_lower_m * (limb3_P_v * minus_limb3_lower_sin - (t603 + limb3_lower_twist_wz * t611));
    RESULT(checked0, momenta, 36, -minus_limb3_upper_momentum_px);
    const REAL t625 = limb3_U_v_0 * t602, t619 = limb3_upper_position_x - (0.5 * t498 - param_H * t504),
      t623 = t619 + (limb_upper_com_x * t498 - limb_upper_com_z * t504),
      minus_limb3_upper_momentum_py = limb_lower_m * (minus_limb3_upper_twist_vy - (limb3_lower_twist_wz * t623 - t625));
    RESULT(checked1, momenta, 37, -minus_limb3_upper_momentum_py);
    const REAL minus_limb3_upper_momentum_Lz = t594 + (t623 * minus_limb3_upper_momentum_py + t611 * minus_limb3_upper_momentum_px);
    RESULT(checked2, momenta, 41, -minus_limb3_upper_momentum_Lz);
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), limb4_lower_cos = SINES(cosine, 7),
      minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos, minus_limb4_lower_sin = SINES(sine, 7);
    /* limb4: momentum, eq. (31); geometry; velocities, eq. (6) */
    const REAL t643 = 0.5 * minus_limb4_lower_rotation_zx,
      minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin,
      t645 = t643 + k1 * minus_limb4_lower_rotation_zy, t647 = limb_lower_com_x * t645,
      t650 = k1 * minus_limb4_lower_rotation_zx - 0.5 * minus_limb4_lower_rotation_zy,
      t653 = param_R * t645 - (t647 - limb_lower_com_z * t650), limb4_U_v_0 = READ(v, 9), t654 = limb4_U_v_0 * t653,
      t657 = 0.5 * minus_limb4_lower_sin - k1 * limb4_lower_cos, t659 = param_R - param_R * t657,
      t660 = limb_lower_com_x * t657, t663 = k1 * minus_limb4_lower_sin + 0.5 * limb4_lower_cos,
      t666 = t659 + (t660 - limb_lower_com_z * t663), limb4_U_v_1 = READ(v, 10), minus_limb4_U_0_cos = SINES(sine, 6),
      minus_limb4_lower_twist_wz = limb4_U_v_1 * minus_limb4_U_0_cos, t668 = t654 - minus_limb4_lower_twist_wz * t666,
      minus_limb4_lower_twist_vx = limb4_U_v_1 * (param_R * minus_limb4_U_0_cos),
      minus_limb4_lower_momentum_px = limb_lower_m * (minus_limb4_lower_twist_vx + t668);
    RESULT(checked3, momenta, 42, -minus_limb4_lower_momentum_px);
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos,
      t670 = 0.5 * minus_limb4_lower_rotation_xx,
      minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin,
      t672 = t670 + k1 * minus_limb4_lower_rotation_xy, t674 = limb_lower_com_x * t672,
      t677 = k1 * minus_limb4_lower_rotation_xx - 0.5 * minus_limb4_lower_rotation_xy,
      t680 = param_R * t672 - (t674 - limb_lower_com_z * t677), t685 = limb4_U_v_0 * t680,
      limb4_lower_twist_wx = limb4_U_v_1 * limb4_U_0_sin, t686 = limb4_lower_twist_wx * t666 + t685,
      minus_limb4_lower_twist_vz = limb4_U_v_1 * (param_R * limb4_U_0_sin),
      minus_limb4_lower_momentum_pz = limb_lower_m * (minus_limb4_lower_twist_vz - t686);
    RESULT(checked0, momenta, 44, -minus_limb4_lower_momentum_pz);
    const REAL t688 = t666 * minus_limb4_lower_momentum_pz, t740 = t666 * minus_limb4_lower_momentum_px,
      limb4_lower_momentum_py = limb_lower_m * (minus_limb4_lower_twist_wz * t680 + limb4_lower_twist_wx * t653);
    WRITE(momenta, 43, limb4_lower_momentum_py);
    const REAL t690 = t688 - t653 * limb4_lower_momentum_py, t716 = t653 * minus_limb4_lower_momentum_px,
      t695 = limb_lower_Ixx * t672 - limb_lower_Ixz * t677, t696 = t672 * t695, t691 = limb_lower_Iyy * limb4_U_0_sin,
      t697 = limb4_U_0_sin * t691 + t696, t709 = minus_limb4_U_0_cos * t691,
      t700 = limb_lower_Ixz * t672 - limb_lower_Izz * t677, t703 = limb4_lower_twist_wx * (t697 - t677 * t700),
      t708 = t703 + limb4_U_v_0 * (t657 * t695 - t663 * t700),
      t715 = t708 + minus_limb4_lower_twist_wz * (t709 - t645 * t695 + t650 * t700),
      minus_limb4_lower_momentum_Lx = t690 - t715;
    RESULT(checked1, momenta, 45, -minus_limb4_lower_momentum_Lx);
    const REAL t741 = t680 * limb4_lower_momentum_py - t740, t718 = t716 - t680 * minus_limb4_lower_momentum_pz,
      t746 = limb_lower_Ixx * t645 - limb_lower_Ixz * t650, t747 = t672 * t746,
      t742 = limb_lower_Iyy * minus_limb4_U_0_cos, t748 = limb4_U_0_sin * t742 - t747,
      t760 = minus_limb4_U_0_cos * t742, t751 = limb_lower_Ixz * t645 - limb_lower_Izz * t650,
      t754 = limb4_lower_twist_wx * (t748 + t677 * t751), t759 = t754 - limb4_U_v_0 * (t657 * t746 - t663 * t751),
      t766 = t759 + minus_limb4_lower_twist_wz * (t760 + t645 * t746 - t650 * t751),
      minus_limb4_lower_momentum_Lz = t741 + t766;
    RESULT(checked2, momenta, 47, -minus_limb4_lower_momentum_Lz);
    const REAL t770 = 0.5 * t645 - param_H * t650, limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      limb4_P_v = READ(v, 11), t771 = limb4_upper_offset_x * minus_limb4_lower_rotation_zx + t770,
      minus_limb4_upper_twist_vz = minus_limb4_lower_twist_vz + limb4_P_v * minus_limb4_lower_rotation_zx,
      t775 = t771 - (limb_upper_com_x * t645 - limb_upper_com_z * t650), t776 = limb4_U_v_0 * t775,
      t780 = param_R - minus_limb4_lower_sin * limb4_upper_offset_x - (0.5 * t657 - param_H * t663),
      minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx,
      minus_limb4_upper_twist_vx = minus_limb4_lower_twist_vx + limb4_P_v * minus_limb4_lower_rotation_xx,
      t784 = t780 + (limb_upper_com_x * t657 - limb_upper_com_z * t663),
      minus_limb4_upper_momentum_px = limb_lower_m * (minus_limb4_upper_twist_vx + (t776 - minus_limb4_lower_twist_wz * t784));
    RESULT(checked3, momenta, 48, -minus_limb4_upper_momentum_px);
    const REAL t791 = minus_limb4_upper_position_x + (0.5 * t672 - param_H * t677),
      t795 = t791 - (limb_upper_com_x * t672 - limb_upper_com_z * t677),
      t798 = minus_limb4_lower_twist_wz * t795 + limb4_lower_twist_wx * t775,
      minus_limb4_upper_momentum_py = limb_lower_m * (limb4_P_v * minus_limb4_lower_sin - t798);
    RESULT(checked0, momenta, 49, -minus_limb4_upper_momentum_py);
    const REAL minus_limb4_upper_momentum_pz = limb_lower_m * (minus_limb4_upper_twist_vz - (limb4_lower_twist_wx * t784 + limb4_U_v_0 * t795));
    RESULT(checked1, momenta, 50, -minus_limb4_upper_momentum_pz);
    const REAL t809 = t795 * minus_limb4_upper_momentum_pz,
      minus_limb4_upper_momentum_Lz = t766 - (t795 * minus_limb4_upper_momentum_py + t784 * minus_limb4_upper_momentum_px);
    RESULT(checked2, momenta, 53, -minus_limb4_upper_momentum_Lz);
    /* platform: geometry; velocities, eq. (6); momentum, eq. (31) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13),
      t805 = t784 * minus_limb4_upper_momentum_pz, /* limb4 */
      t1 = limb5_S_q_qw * limb5_S_q_qw, t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2,
      t4 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5,
      t7 = t3 + t6, t9 = 4.0 - 2.0 * t7, t10 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5),
      platform_turn_zz = 1.0 - t9 * t10, platform_turn_xx = 1.0 - t6 * t9, t16 = limb5_S_q_qy * t9,
      t17 = limb5_S_q_qx * t16, t30 = limb5_S_q_qw * t16, t18 = limb5_S_q_qz * t9,
      t24 = limb5_S_q_qw * (limb5_S_q_qx * t9), t19 = limb5_S_q_qw * t18, platform_turn_yx = t17 + t19,
      platform_turn_xy = t17 - t19, limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13),
      t21 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, t22 = limb5_S_q_qy * t18,
      t29 = limb5_S_q_qx * t18, platform_turn_yz = t22 - t24, platform_turn_zy = t22 + t24,
      limb5_S_v_wz = READ(v, 14), platform_twist_wy = t21 + limb5_S_v_wz * platform_turn_yz,
      t12 = param_H * platform_turn_zz, t26 = t12 * platform_twist_wy, platform_turn_zx = t29 - t30,
      platform_turn_xz = t29 + t30, t33 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t33, t27 = param_H * platform_turn_yz,
      platform_momentum_px = platform_m * (t26 - t27 * platform_twist_wz);
    WRITE(momenta, 0, platform_momentum_px);
    const REAL t816 = platform_momentum_px + limb1_lower_momentum_px + limb1_upper_momentum_px + limb2_lower_momentum_px,
      t820 = t816 + limb2_upper_momentum_px + limb3_lower_momentum_px - minus_limb3_upper_momentum_px - minus_limb4_lower_momentum_px;
    RESULT(checked3, total_, 0, t820 - minus_limb4_upper_momentum_px);
    const REAL limb1_lower_momentum_Ly = t137 * limb1_lower_momentum_px - t196 - t222;
    WRITE(momenta, 10, limb1_lower_momentum_Ly);
    const REAL t174 = t172 - t137 * limb1_lower_momentum_py, /* limb1 */
      t636 = t602 * minus_limb3_upper_momentum_px, /* limb3 */
      t634 = t602 * minus_limb3_upper_momentum_py, /* limb3 */
      t810 = t775 * minus_limb4_upper_momentum_px - t809, /* limb4 */
      limb4_upper_momentum_Lx = t715 - (t805 + t775 * minus_limb4_upper_momentum_py);
    WRITE(momenta, 51, limb4_upper_momentum_Lx);
    const REAL t296 = t267 * limb1_upper_momentum_px, /* limb1 */
      t289 = t267 * minus_limb1_upper_momentum_pz, /* limb1 */
      t36 = param_H * platform_turn_xz, t37 = t36 * platform_twist_wz,
      t41 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      platform_twist_wx = t41 + limb5_S_v_wz * platform_turn_xz,
      platform_momentum_py = platform_m * (t37 - t12 * platform_twist_wx);
    WRITE(momenta, 1, platform_momentum_py);
    const REAL t821 = platform_momentum_py + limb1_lower_momentum_py,
      limb1_upper_momentum_py = limb_lower_m * (limb1_upper_twist_vy - (limb1_lower_twist_wz * t279 + limb1_U_v_0 * t258));
    WRITE(momenta, 13, limb1_upper_momentum_py);
    const REAL t825 = t821 + limb1_upper_momentum_py + limb2_lower_momentum_py + limb2_upper_momentum_py - minus_limb3_lower_momentum_py;
    RESULT(checked0, total_, 1, t825 - minus_limb3_upper_momentum_py + limb4_lower_momentum_py - minus_limb4_upper_momentum_py);
    const REAL t291 = t289 - t258 * limb1_upper_momentum_py, /* limb1 */
      limb1_upper_momentum_Lz = t250 - (t279 * limb1_upper_momentum_py - t296);
    WRITE(momenta, 17, limb1_upper_momentum_Lz);
    const REAL platform_momentum_pz = platform_m * (t27 * platform_twist_wx - t36 * platform_twist_wy);
    WRITE(momenta, 2, platform_momentum_pz);
    const REAL t830 = platform_momentum_pz - minus_limb1_lower_momentum_pz - minus_limb1_upper_momentum_pz + limb2_lower_momentum_pz,
      t832 = t830 + limb2_upper_momentum_pz + limb3_lower_momentum_pz,
      limb3_upper_momentum_pz = limb_lower_m * (limb3_upper_twist_vz - (limb3_U_v_0 * t611 + limb3_lower_twist_wy * t623));
    WRITE(momenta, 38, limb3_upper_momentum_pz);
    RESULT(checked1, total_, 2, t832 + limb3_upper_momentum_pz - minus_limb4_lower_momentum_pz - minus_limb4_upper_momentum_pz);
    const REAL limb3_upper_momentum_Lx = t538 - (t611 * limb3_upper_momentum_pz - t634);
    WRITE(momenta, 39, limb3_upper_momentum_Lx);
    const REAL t638 = t636 + t623 * limb3_upper_momentum_pz; /* limb3 */
    /* platform: momentum, eq. (31) */
    const REAL t50 = t27 * platform_momentum_pz - t12 * platform_momentum_py,
      t76 = t12 * platform_momentum_px - t36 * platform_momentum_pz,
      t102 = t36 * platform_momentum_py - t27 * platform_momentum_px, t53 = platform_Ixx * platform_turn_xy,
      t54 = platform_turn_xy * t53, t51 = platform_Ixx * platform_turn_xx, t55 = platform_turn_xx * t51 + t54,
      t56 = platform_Izz * platform_turn_xz, t59 = platform_twist_wx * (t55 + platform_turn_xz * t56),
      t69 = platform_turn_zx * t51 + platform_turn_zy * t53,
      t65 = platform_twist_wy * (platform_turn_yx * t51 + platform_turn_yy * t53 + platform_turn_yz * t56),
      platform_momentum_Lx = t50 + (t59 + t65 + platform_twist_wz * (t69 + platform_turn_zz * t56));
    WRITE(momenta, 3, platform_momentum_Lx);
    /* limb1: momentum, eq. (31) */
    const REAL t177 = limb_lower_Ixx * t154 - limb_lower_Ixz * t160, t185 = t141 * t177, t190 = t129 * t177,
      t178 = t154 * t177, t181 = limb_lower_Ixz * t154 - limb_lower_Izz * t160,
      t184 = limb1_U_v_0 * (t178 - t160 * t181), t189 = t184 - limb1_lower_twist_wy * (t185 - t146 * t181),
      t194 = t189 + limb1_lower_twist_wz * (t190 - t134 * t181), limb1_lower_momentum_Lx = t174 + t194;
    WRITE(momenta, 9, limb1_lower_momentum_Lx);
    /* Lx: results */
    const REAL t835 = platform_momentum_Lx + limb1_lower_momentum_Lx, limb1_upper_momentum_Lx = t194 + t291;
    WRITE(momenta, 15, limb1_upper_momentum_Lx);
    const REAL t839 = t835 + limb1_upper_momentum_Lx - minus_limb2_lower_momentum_Lx + limb2_upper_momentum_Lx - minus_limb3_lower_momentum_Lx;
    RESULT(checked2, total_, 3, t839 + limb3_upper_momentum_Lx - minus_limb4_lower_momentum_Lx + limb4_upper_momentum_Lx);
    /* platform: momentum, eq. (31); results */
    const REAL t77 = platform_Ixx * platform_turn_yx, t78 = platform_turn_xx * t77,
      t79 = platform_Ixx * platform_turn_yy, t81 = t78 + platform_turn_xy * t79,
      t82 = platform_Izz * platform_turn_yz, t85 = platform_twist_wx * (t81 + platform_turn_xz * t82),
      t95 = platform_turn_zx * t77 + platform_turn_zy * t79,
      t91 = platform_twist_wy * (platform_turn_yx * t77 + platform_turn_yy * t79 + platform_turn_yz * t82),
      platform_momentum_Ly = t76 + (t85 + t91 + platform_twist_wz * (t95 + platform_turn_zz * t82));
    WRITE(momenta, 4, platform_momentum_Ly);
    const REAL t844 = platform_momentum_Ly + limb1_lower_momentum_Ly - minus_limb1_upper_momentum_Ly - minus_limb2_lower_momentum_Ly,
      t845 = t844 - minus_limb2_upper_momentum_Ly;
    /* limb3: momentum, eq. (31) */
    const REAL t544 = limb_lower_Ixx * t485 - limb_lower_Ixz * t490, t545 = t498 * t544, t560 = t473 * t544,
      t552 = t485 * t544, t546 = limb_lower_Ixz * t485, t553 = limb_lower_Iyy * limb3_U_0_cos,
      t555 = t552 + limb3_U_0_cos * t553, t562 = t560 - limb3_U_0_sin * t553, t548 = t546 - limb_lower_Izz * t490,
      t558 = limb3_lower_twist_wy * (t555 - t490 * t548), t565 = limb3_lower_twist_wz * (t562 - t478 * t548),
      t566 = limb3_U_v_0 * (t545 - t504 * t548) + t558 - t565, limb3_lower_momentum_Ly = t541 + t566;
    WRITE(momenta, 34, limb3_lower_momentum_Ly);
    const REAL t846 = t845 + limb3_lower_momentum_Ly, /* Ly */
      limb3_upper_momentum_Ly = t566 - t638;
    WRITE(momenta, 40, limb3_upper_momentum_Ly);
    const REAL t847 = t846 + limb3_upper_momentum_Ly; /* Ly */
    /* limb4: momentum, eq. (31) */
    const REAL t721 = limb_lower_Ixx * t657 - limb_lower_Ixz * t663, t722 = t672 * t721, t734 = t645 * t721,
      t729 = t657 * t721, t725 = limb_lower_Ixz * t657 - limb_lower_Izz * t663,
      t728 = limb4_lower_twist_wx * (t722 - t677 * t725), t737 = minus_limb4_lower_twist_wz * (t734 - t650 * t725),
      t738 = t728 + limb4_U_v_0 * (t729 - t663 * t725) - t737, limb4_lower_momentum_Ly = t718 + t738;
    WRITE(momenta, 46, limb4_lower_momentum_Ly);
    /* Ly: results */
    const REAL t848 = t847 + limb4_lower_momentum_Ly, limb4_upper_momentum_Ly = t738 + t810;
    WRITE(momenta, 52, limb4_upper_momentum_Ly);
    RESULT(checked3, total_, 4, t848 + limb4_upper_momentum_Ly);
    /* platform: momentum, eq. (31); results */
    const REAL t103 = platform_Ixx * platform_turn_zx, t104 = platform_turn_xx * t103, t112 = platform_turn_yx * t103,
      t119 = platform_turn_zx * t103, t105 = platform_Ixx * platform_turn_zy, t107 = t104 + platform_turn_xy * t105,
      t114 = t112 + platform_turn_yy * t105, t121 = t119 + platform_turn_zy * t105,
      t108 = platform_Izz * platform_turn_zz, t111 = platform_twist_wx * (t107 + platform_turn_xz * t108),
      t118 = t111 + platform_twist_wy * (t114 + platform_turn_yz * t108),
      platform_momentum_Lz = t102 + (t118 + platform_twist_wz * (t121 + platform_turn_zz * t108));
    WRITE(momenta, 5, platform_momentum_Lz);
    const REAL t851 = platform_momentum_Lz - minus_limb1_lower_momentum_Lz + limb1_upper_momentum_Lz - minus_limb2_lower_momentum_Lz,
      t854 = t851 - minus_limb2_upper_momentum_Lz - minus_limb3_lower_momentum_Lz - minus_limb3_upper_momentum_Lz;
    RESULT(checked0, total_, 5, t854 - minus_limb4_lower_momentum_Lz - minus_limb4_upper_momentum_Lz);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_momentum_rates)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict momentum_rates, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    /* platform: geometry; velocities, eq. (6); momentum, eq. (31) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      platform_turn_xx = 1.0 - t6 * t9, t36 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5),
      platform_turn_zz = 1.0 - t9 * t36, t13 = limb5_S_q_qy * t9, t14 = limb5_S_q_qx * t13, t29 = limb5_S_q_qw * t13,
      t15 = limb5_S_q_qz * t9, t21 = limb5_S_q_qw * (limb5_S_q_qx * t9), t16 = limb5_S_q_qw * t15,
      platform_turn_xy = t14 - t16, platform_turn_yx = t14 + t16, limb5_S_v_wy = READ(v, 13),
      limb5_S_v_wx = READ(v, 12), t27 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      t28 = limb5_S_q_qx * t15, t19 = limb5_S_q_qy * t15, platform_turn_xz = t28 + t29, platform_turn_zx = t28 - t29,
      limb5_S_v_wz = READ(v, 14), platform_twist_wx = t27 + limb5_S_v_wz * platform_turn_xz,
      platform_turn_yz = t19 - t21, platform_turn_zy = t19 + t21, t23 = param_H * platform_turn_yz,
      t31 = t23 * platform_twist_wx, t18 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      platform_twist_wy = t18 + limb5_S_v_wz * platform_turn_yz, t32 = param_H * platform_turn_xz,
      platform_momentum_pz = platform_m * (t31 - t32 * platform_twist_wy),
      t35 = platform_twist_wy * platform_momentum_pz,
      t41 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t41, t42 = t32 * platform_twist_wz,
      t43 = param_H * platform_turn_zz, platform_momentum_py = platform_m * (t42 - t43 * platform_twist_wx),
      limb5_S_a_wx = READ(a, 12), limb5_S_a_wy = READ(a, 13), limb5_S_a_wz = READ(a, 14),
      t47 = t35 - platform_twist_wz * platform_momentum_py,
      t50 = limb5_S_a_wx * platform_turn_yx + limb5_S_a_wy * platform_turn_yy,
      platform_twist_rate_wy = t50 + limb5_S_a_wz * platform_turn_yz, t52 = t43 * platform_twist_rate_wy,
      t55 = limb5_S_a_wx * platform_turn_zx + limb5_S_a_wy * platform_turn_zy,
      platform_twist_rate_wz = t55 + limb5_S_a_wz * platform_turn_zz;
    /* platform: momentum rate, eq. (35); momentum, eq. (31); accelerations */
    const REAL t59 = platform_m * (t52 - t23 * platform_twist_rate_wz), platform_rate_at_O_fx = t47 + t59;
    WRITE(momentum_rates, 0, platform_rate_at_O_fx);
    REAL checked0 = platform_rate_at_O_fx;
    const REAL platform_momentum_px = platform_m * (t43 * platform_twist_wy - t23 * platform_twist_wz),
      t65 = platform_twist_wz * platform_momentum_px - platform_twist_wx * platform_momentum_pz,
      t66 = t32 * platform_twist_rate_wz, t69 = limb5_S_a_wx * platform_turn_xx + limb5_S_a_wy * platform_turn_xy,
      platform_twist_rate_wx = t69 + limb5_S_a_wz * platform_turn_xz,
      t73 = platform_m * (t66 - t43 * platform_twist_rate_wx), platform_rate_at_O_fy = t65 + t73;
    WRITE(momentum_rates, 1, platform_rate_at_O_fy);
    REAL checked1 = platform_rate_at_O_fy;
    const REAL t76 = platform_twist_wx * platform_momentum_py - platform_twist_wy * platform_momentum_px,
      t80 = platform_m * (t23 * platform_twist_rate_wx - t32 * platform_twist_rate_wy),
      platform_rate_at_O_fz = t76 + t80;
    WRITE(momentum_rates, 2, platform_rate_at_O_fz);
    REAL checked2 = platform_rate_at_O_fz;
    /* platform: momentum, eq. (31); momentum rate, eq. (35) */
    const REAL t164 = t43 * platform_momentum_py, t83 = t32 * platform_momentum_py - t23 * platform_momentum_px,
      t108 = t43 * platform_momentum_px, t84 = platform_Ixx * platform_turn_zx, t85 = platform_turn_xx * t84,
      t86 = platform_Ixx * platform_turn_zy, t88 = t85 + platform_turn_xy * t86,
      t89 = platform_Izz * platform_turn_zz, t91 = t88 + platform_turn_xz * t89, t92 = platform_twist_wx * t91,
      t189 = platform_twist_rate_wx * t91, t102 = platform_turn_zx * t84 + platform_turn_zy * t86,
      t97 = platform_turn_yx * t84 + platform_turn_yy * t86 + platform_turn_yz * t89,
      t104 = t102 + platform_turn_zz * t89, t191 = t189 + platform_twist_rate_wy * t97,
      platform_momentum_Lz = t83 + (t92 + platform_twist_wy * t97 + platform_twist_wz * t104),
      t193 = t191 + platform_twist_rate_wz * t104, t107 = platform_twist_wy * platform_momentum_Lz,
      t172 = platform_twist_wx * platform_momentum_Lz, t110 = t108 - t32 * platform_momentum_pz,
      t165 = t23 * platform_momentum_pz - t164, t111 = platform_Ixx * platform_turn_yx,
      t112 = platform_turn_xx * t111, t113 = platform_Ixx * platform_turn_yy, t115 = t112 + platform_turn_xy * t113,
      t116 = platform_Izz * platform_turn_yz, t118 = t115 + platform_turn_xz * t116, t119 = platform_twist_wx * t118;
    /* platform: momentum rate, eq. (35); momentum, eq. (31) */
    const REAL t177 = platform_twist_rate_wx * t118, t129 = platform_turn_zx * t111 + platform_turn_zy * t113,
      t124 = platform_turn_yx * t111 + platform_turn_yy * t113 + platform_turn_yz * t116,
      t131 = t129 + platform_turn_zz * t116, t179 = t177 + platform_twist_rate_wy * t124,
      platform_momentum_Ly = t110 + (t119 + platform_twist_wy * t124 + platform_twist_wz * t131),
      t135 = t107 - platform_twist_wz * platform_momentum_Ly, t183 = platform_twist_wx * platform_momentum_Ly,
      t138 = t23 * t80 - t43 * t73, t182 = t43 * t59 - t32 * t80 + (t179 + platform_twist_rate_wz * t131),
      t194 = t32 * t73 - t23 * t59 + t193, t141 = platform_Ixx * platform_turn_xy, t142 = platform_turn_xy * t141,
      t149 = platform_turn_yy * t141, t156 = platform_turn_zy * t141, t139 = platform_Ixx * platform_turn_xx,
      t143 = platform_turn_xx * t139 + t142, t150 = platform_turn_yx * t139 + t149,
      t157 = platform_turn_zx * t139 + t156, t144 = platform_Izz * platform_turn_xz,
      t146 = t143 + platform_turn_xz * t144, t147 = platform_twist_rate_wx * t146, t166 = platform_twist_wx * t146,
      t152 = t150 + platform_turn_yz * t144, t159 = t157 + platform_turn_zz * t144,
      platform_rate_at_O_mx = t135 + (t138 + (t147 + platform_twist_rate_wy * t152 + platform_twist_rate_wz * t159));
    WRITE(momentum_rates, 3, platform_rate_at_O_mx);
    REAL checked3 = platform_rate_at_O_mx;
    const REAL platform_momentum_Lx = t165 + (t166 + platform_twist_wy * t152 + platform_twist_wz * t159);
    RESULT(checked0, momentum_rates, 4, platform_twist_wz * platform_momentum_Lx - t172 + t182);
    RESULT(checked1, momentum_rates, 5, t183 - platform_twist_wy * platform_momentum_Lx + t194);
    /* limb1: geometry; momentum rate, eq. (35); momentum, eq. (31) */
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1),
      minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos, limb1_lower_sin = SINES(sine, 1),
      t214 = 0.5 * minus_limb1_lower_rotation_yx, limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin,
      t216 = t214 - k1 * limb1_lower_rotation_yy, t218 = limb_lower_com_x * t216,
      t221 = k1 * minus_limb1_lower_rotation_yx + 0.5 * limb1_lower_rotation_yy,
      t224 = param_R * t216 - (t218 - limb_lower_com_z * t221), limb1_U_v_0 = READ(v, 0), t228 = limb1_U_v_0 * t224,
      t231 = 0.5 * limb1_lower_sin + k1 * limb1_lower_cos, t233 = param_R - param_R * t231,
      t234 = limb_lower_com_x * t231, t237 = k1 * limb1_lower_sin - 0.5 * limb1_lower_cos,
      t240 = t233 + (t234 - limb_lower_com_z * t237), limb1_U_v_1 = READ(v, 1), limb1_U_0_cos = SINES(cosine, 0),
      limb1_lower_twist_wy = limb1_U_v_1 * limb1_U_0_cos, t242 = t228 - limb1_lower_twist_wy * t240,
      minus_limb1_U_1_screw_vz = param_R * limb1_U_0_cos,
      minus_limb1_lower_twist_vz = limb1_U_v_1 * minus_limb1_U_1_screw_vz,
      minus_limb1_lower_momentum_pz = limb_lower_m * (minus_limb1_lower_twist_vz + t242),
      t244 = limb1_lower_twist_wy * minus_limb1_lower_momentum_pz,
      limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos, t199 = 0.5 * limb1_lower_rotation_zx,
      minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin,
      t201 = t199 - k1 * minus_limb1_lower_rotation_zy, t203 = limb_lower_com_x * t201,
      t206 = k1 * limb1_lower_rotation_zx + 0.5 * minus_limb1_lower_rotation_zy,
      t209 = param_R * t201 - (t203 - limb_lower_com_z * t206), t246 = limb1_U_v_0 * t209,
      limb1_lower_twist_wz = limb1_U_v_1 * limb1_U_0_sin, t247 = limb1_lower_twist_wz * t240 + t246,
      limb1_U_1_screw_vy = param_R * limb1_U_0_sin, limb1_lower_twist_vy = limb1_U_v_1 * limb1_U_1_screw_vy,
      limb1_lower_momentum_py = limb_lower_m * (limb1_lower_twist_vy - t247), limb1_U_a_1 = READ(a, 1);
    /* limb1: momentum rate, eq. (35); accelerations; momentum, eq. (31) */
    const REAL t250 = t244 + limb1_lower_twist_wz * limb1_lower_momentum_py,
      limb1_lower_twist_rate_wy = limb1_U_a_1 * limb1_U_0_cos - limb1_U_v_1 * (limb1_U_v_0 * limb1_U_0_sin),
      t210 = limb1_lower_twist_rate_wy * t209,
      limb1_lower_twist_rate_wz = limb1_U_a_1 * limb1_U_0_sin + limb1_U_v_1 * (limb1_U_v_0 * limb1_U_0_cos),
      t227 = limb_lower_m * (t210 + limb1_lower_twist_rate_wz * t224);
    RESULT(checked2, momentum_rates, 6, t227 - t250);
    const REAL t255 = limb1_U_v_0 * minus_limb1_lower_momentum_pz,
      limb1_lower_momentum_px = limb_lower_m * (limb1_lower_twist_wy * t209 + limb1_lower_twist_wz * t224),
      limb1_U_a_0 = READ(a, 0), t256 = limb1_lower_twist_wz * limb1_lower_momentum_px + t255,
      t262 = limb1_lower_twist_rate_wz * t240 + limb1_U_a_0 * t209, t268 = limb1_U_a_1 * minus_limb1_U_1_screw_vz,
      limb1_lower_twist_rate_vy = limb1_U_a_1 * limb1_U_1_screw_vy + limb1_U_v_1 * (limb1_U_v_0 * minus_limb1_U_1_screw_vz),
      t264 = limb_lower_m * (limb1_lower_twist_rate_vy - t262);
    RESULT(checked3, momentum_rates, 7, t256 + t264);
    const REAL minus_limb1_lower_twist_rate_vz = t268 - limb1_U_v_1 * (limb1_U_v_0 * limb1_U_1_screw_vy),
      t267 = limb1_U_v_0 * limb1_lower_momentum_py - limb1_lower_twist_wy * limb1_lower_momentum_px,
      t275 = limb_lower_m * (minus_limb1_lower_twist_rate_vz + (limb1_U_a_0 * t224 - limb1_lower_twist_rate_wy * t240));
    RESULT(checked0, momentum_rates, 8, t267 - t275);
    /* limb1: momentum, eq. (31); momentum rate, eq. (35) */
    const REAL t302 = t240 * limb1_lower_momentum_py - t224 * limb1_lower_momentum_px,
      t305 = limb_lower_Ixx * t201 - limb_lower_Ixz * t206, t313 = t216 * t305, t314 = limb_lower_Iyy * limb1_U_0_sin,
      t316 = t313 - limb1_U_0_cos * t314, t322 = limb1_U_0_sin * t314,
      t309 = limb_lower_Ixz * t201 - limb_lower_Izz * t206, t318 = t316 - t221 * t309,
      t319 = limb1_lower_twist_wy * t318, t394 = limb1_lower_twist_rate_wy * t318, t323 = t201 * t305 + t322,
      t311 = t231 * t305 - t237 * t309, t325 = t323 - t206 * t309, t395 = limb1_U_a_0 * t311 - t394,
      t327 = limb1_U_v_0 * t311 - t319 + limb1_lower_twist_wz * t325, minus_limb1_lower_momentum_Lz = t302 - t327,
      t397 = t395 + limb1_lower_twist_rate_wz * t325, t328 = limb1_lower_twist_wy * minus_limb1_lower_momentum_Lz,
      t372 = limb1_U_v_0 * minus_limb1_lower_momentum_Lz,
      t331 = t209 * limb1_lower_momentum_px - t240 * minus_limb1_lower_momentum_pz,
      t334 = limb_lower_Ixx * t216 - limb_lower_Ixz * t221, t342 = t216 * t334, t343 = limb_lower_Iyy * limb1_U_0_cos,
      t345 = t342 + limb1_U_0_cos * t343, t351 = limb1_U_0_sin * t343,
      t338 = limb_lower_Ixz * t216 - limb_lower_Izz * t221, t347 = t345 - t221 * t338,
      t348 = limb1_lower_twist_wy * t347, t380 = limb1_lower_twist_rate_wy * t347, t352 = t201 * t334 - t351,
      t340 = t231 * t334 - t237 * t338, t354 = t352 - t206 * t338;
    /* limb1: momentum rate, eq. (35); momentum, eq. (31); accelerations */
    const REAL t381 = limb1_U_a_0 * t340 - t380, t356 = limb1_U_v_0 * t340 - t348 + limb1_lower_twist_wz * t354,
      limb1_lower_momentum_Ly = t331 - t356, t383 = t381 + limb1_lower_twist_rate_wz * t354,
      t358 = t328 + limb1_lower_twist_wz * limb1_lower_momentum_Ly, t385 = limb1_U_v_0 * limb1_lower_momentum_Ly,
      t359 = limb1_lower_twist_vy * minus_limb1_lower_momentum_pz,
      t362 = t358 + (t359 - minus_limb1_lower_twist_vz * limb1_lower_momentum_py),
      t365 = t224 * minus_limb1_lower_momentum_pz - t209 * limb1_lower_momentum_py, t278 = t224 * t275 - t209 * t264,
      t384 = t209 * t227 - t240 * t275 - t383, t398 = t240 * t264 - t224 * t227 - t397,
      t281 = limb_lower_Ixx * t231 - limb_lower_Ixz * t237, t282 = t231 * t281,
      t285 = limb_lower_Ixz * t231 - limb_lower_Izz * t237, t287 = t282 - t237 * t285, t288 = limb1_U_a_0 * t287,
      t366 = limb1_U_v_0 * t287, t294 = t201 * t281, t291 = t216 * t281 - t221 * t285, t296 = t294 - t206 * t285,
      t368 = t366 - limb1_lower_twist_wy * t291,
      t298 = t288 - limb1_lower_twist_rate_wy * t291 + limb1_lower_twist_rate_wz * t296;
    RESULT(checked1, momentum_rates, 9, t278 + t298 - t362);
    const REAL t370 = t368 + limb1_lower_twist_wz * t296, limb1_lower_momentum_Lx = t365 + t370,
      t373 = limb1_lower_twist_wz * limb1_lower_momentum_Lx + t372,
      t387 = t385 - limb1_lower_twist_wy * limb1_lower_momentum_Lx;
    RESULT(checked2, momentum_rates, 10, t373 - minus_limb1_lower_twist_vz * limb1_lower_momentum_px + t384);
    RESULT(checked3, momentum_rates, 11, t387 - limb1_lower_twist_vy * limb1_lower_momentum_px - t398);
    const REAL t415 = 0.5 * t216 - param_H * t221, t419 = limb_upper_com_x * t216 - limb_upper_com_z * t221,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      t420 = limb1_upper_offset_x * minus_limb1_lower_rotation_yx + t415 - t419, t426 = limb1_U_v_0 * t420,
      t433 = limb_upper_com_x * t231 - limb_upper_com_z * t237,
      t430 = param_R - limb1_lower_sin * limb1_upper_offset_x - (0.5 * t231 - param_H * t237), t434 = t430 + t433,
      limb1_P_v = READ(v, 2), limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx,
      t436 = t426 - limb1_lower_twist_wy * t434,
      minus_limb1_upper_twist_vz = minus_limb1_lower_twist_vz - limb1_P_v * limb1_lower_rotation_zx,
      minus_limb1_upper_momentum_pz = limb_lower_m * (minus_limb1_upper_twist_vz + t436),
      t438 = limb1_lower_twist_wy * minus_limb1_upper_momentum_pz,
      t407 = limb1_upper_position_z + (0.5 * t201 - param_H * t206),
      t411 = t407 - (limb_upper_com_x * t201 - limb_upper_com_z * t206),
      t442 = limb1_lower_twist_wz * t434 + limb1_U_v_0 * t411,
      limb1_upper_twist_vy = limb1_lower_twist_vy - limb1_P_v * minus_limb1_lower_rotation_yx,
      limb1_upper_momentum_py = limb_lower_m * (limb1_upper_twist_vy - t442),
      t445 = t438 + limb1_lower_twist_wz * limb1_upper_momentum_py, t474 = limb1_lower_twist_rate_wy * t434,
      t422 = limb1_lower_twist_rate_wy * t411 + limb1_lower_twist_rate_wz * t420,
      t459 = limb1_lower_twist_rate_wz * t434, t400 = limb1_lower_rotation_zx * limb1_lower_twist_wy,
      limb1_P_a = READ(a, 2), t403 = limb1_P_v * (t400 + minus_limb1_lower_rotation_yx * limb1_lower_twist_wz),
      t424 = limb_lower_m * (limb1_P_a * limb1_lower_sin + t403 + t422);
    RESULT(checked0, momentum_rates, 12, t424 - t445);
    const REAL t448 = limb1_lower_twist_wy * t411 + limb1_lower_twist_wz * t420,
      limb1_upper_twist_vx = limb1_P_v * limb1_lower_sin,
      limb1_upper_momentum_px = limb_lower_m * (limb1_upper_twist_vx + t448),
      t452 = limb1_lower_twist_wz * limb1_upper_momentum_px + limb1_U_v_0 * minus_limb1_upper_momentum_pz,
      t461 = t459 + limb1_U_a_0 * t411, t454 = limb1_lower_twist_rate_vy - limb1_P_a * minus_limb1_lower_rotation_yx,
      t469 = limb1_U_v_0 * minus_limb1_lower_rotation_yx,
      limb1_upper_twist_rate_vy = t454 + limb1_P_v * (limb1_lower_sin * limb1_lower_twist_wz - limb1_U_v_0 * limb1_lower_rotation_zx),
      t463 = limb_lower_m * (limb1_upper_twist_rate_vy - t461);
    RESULT(checked1, momentum_rates, 13, t452 + t463);
    const REAL t468 = minus_limb1_lower_twist_rate_vz - limb1_P_a * limb1_lower_rotation_zx,
      t466 = limb1_U_v_0 * limb1_upper_momentum_py - limb1_lower_twist_wy * limb1_upper_momentum_px,
      t475 = limb1_U_a_0 * t420 - t474,
      t477 = limb_lower_m * (t468 + limb1_P_v * (t469 + limb1_lower_sin * limb1_lower_twist_wy) + t475);
    RESULT(checked2, momentum_rates, 14, t466 - t477);
    const REAL limb1_upper_momentum_Lz = t327 - (t434 * limb1_upper_momentum_py - t420 * limb1_upper_momentum_px),
      t481 = limb1_lower_twist_wy * limb1_upper_momentum_Lz, t499 = limb1_U_v_0 * limb1_upper_momentum_Lz,
      minus_limb1_upper_momentum_Ly = t356 - (t411 * limb1_upper_momentum_px - t434 * minus_limb1_upper_momentum_pz),
      t486 = t481 + limb1_lower_twist_wz * minus_limb1_upper_momentum_Ly,
      t513 = limb1_U_v_0 * minus_limb1_upper_momentum_Ly, t487 = limb1_upper_twist_vy * minus_limb1_upper_momentum_pz,
      t517 = limb1_upper_twist_vy * limb1_upper_momentum_px,
      t501 = minus_limb1_upper_twist_vz * limb1_upper_momentum_px,
      t490 = t486 - (t487 - minus_limb1_upper_twist_vz * limb1_upper_momentum_py), t506 = t434 * t477,
      t509 = t434 * t463;
    RESULT(checked3, momentum_rates, 15, t490 + (t298 + (t420 * t477 - t411 * t463)));
    const REAL t503 = t501 - limb1_upper_twist_vx * minus_limb1_upper_momentum_pz,
      t518 = limb1_upper_twist_vx * limb1_upper_momentum_py - t517,
      limb1_upper_momentum_Lx = t370 + (t420 * minus_limb1_upper_momentum_pz - t411 * limb1_upper_momentum_py),
      t504 = limb1_lower_twist_wz * limb1_upper_momentum_Lx - t499 - t503,
      t519 = t513 + limb1_lower_twist_wy * limb1_upper_momentum_Lx - t518;
    RESULT(checked0, momentum_rates, 16, t504 - (t383 - (t411 * t424 - t506)));
    RESULT(checked1, momentum_rates, 17, t397 - (t509 - t420 * t424) - t519);
    /* limb2: geometry */
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_lower_cos = SINES(cosine, 3),
      minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos, limb2_lower_sin = SINES(sine, 3);
    /* limb2: momentum, eq. (31); momentum rate, eq. (35); accelerations */
    const REAL t534 = 0.5 * minus_limb2_lower_rotation_xx,
      limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin, t536 = t534 + k1 * limb2_lower_rotation_xy,
      t538 = limb_lower_com_x * t536, t541 = k1 * minus_limb2_lower_rotation_xx - 0.5 * limb2_lower_rotation_xy,
      t544 = param_R * t536 - (t538 - limb_lower_com_z * t541), limb2_U_v_0 = READ(v, 3), t545 = limb2_U_v_0 * t544,
      t523 = 0.5 * limb2_lower_sin - k1 * limb2_lower_cos, t525 = param_R - param_R * t523,
      t526 = limb_lower_com_x * t523, t529 = k1 * limb2_lower_sin + 0.5 * limb2_lower_cos,
      t532 = t525 + (t526 - limb_lower_com_z * t529), limb2_U_v_1 = READ(v, 4), limb2_U_0_sin = SINES(cosine, 2),
      limb2_lower_twist_wx = limb2_U_v_1 * limb2_U_0_sin, t546 = limb2_lower_twist_wx * t532 - t545,
      limb2_U_1_screw_vz = param_R * limb2_U_0_sin, limb2_lower_twist_vz = limb2_U_v_1 * limb2_U_1_screw_vz,
      limb2_lower_momentum_pz = limb_lower_m * (limb2_lower_twist_vz - t546),
      t548 = limb2_U_v_0 * limb2_lower_momentum_pz, minus_limb2_lower_twist_wz = limb2_U_v_1 * minus_limb2_U_0_cos,
      t549 = minus_limb2_lower_twist_wz * t544, minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos,
      t550 = 0.5 * minus_limb2_lower_rotation_zx, limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin,
      t552 = t550 + k1 * limb2_lower_rotation_zy, t554 = limb_lower_com_x * t552,
      t557 = k1 * minus_limb2_lower_rotation_zx - 0.5 * limb2_lower_rotation_zy,
      t560 = param_R * t552 - (t554 - limb_lower_com_z * t557),
      limb2_lower_momentum_py = limb_lower_m * (t549 + limb2_lower_twist_wx * t560), limb2_U_a_0 = READ(a, 3),
      limb2_U_a_1 = READ(a, 4), t564 = t548 + minus_limb2_lower_twist_wz * limb2_lower_momentum_py,
      t568 = limb2_U_a_0 * t560,
      minus_limb2_lower_twist_rate_wz = limb2_U_a_1 * minus_limb2_U_0_cos + limb2_U_v_1 * (limb2_U_v_0 * limb2_U_0_sin),
      t573 = t568 + minus_limb2_lower_twist_rate_wz * t532, t567 = limb2_U_v_1 * (limb2_U_v_0 * limb2_U_1_screw_vz),
      t593 = limb2_U_a_1 * limb2_U_1_screw_vz, limb2_U_1_screw_vx = param_R * minus_limb2_U_0_cos,
      limb2_lower_twist_rate_vx = limb2_U_a_1 * limb2_U_1_screw_vx + t567,
      t575 = limb_lower_m * (limb2_lower_twist_rate_vx - t573);
    RESULT(checked2, momentum_rates, 18, t564 + t575);
    const REAL t585 = limb2_U_v_0 * t560 + minus_limb2_lower_twist_wz * t532,
      limb2_lower_twist_vx = limb2_U_v_1 * limb2_U_1_screw_vx,
      limb2_lower_momentum_px = limb_lower_m * (limb2_lower_twist_vx - t585),
      limb2_lower_twist_rate_vz = t593 - limb2_U_v_1 * (limb2_U_v_0 * limb2_U_1_screw_vx);
    /* limb2: momentum rate, eq. (35); accelerations */
    const REAL t587 = minus_limb2_lower_twist_wz * limb2_lower_momentum_px,
      t589 = t587 + limb2_lower_twist_wx * limb2_lower_momentum_pz, t576 = minus_limb2_lower_twist_rate_wz * t544,
      limb2_lower_twist_rate_wx = limb2_U_a_1 * limb2_U_0_sin - limb2_U_v_1 * (limb2_U_v_0 * minus_limb2_U_0_cos),
      t582 = limb_lower_m * (t576 + limb2_lower_twist_rate_wx * t560);
    RESULT(checked3, momentum_rates, 19, t582 - t589);
    const REAL t592 = limb2_lower_twist_wx * limb2_lower_momentum_py - limb2_U_v_0 * limb2_lower_momentum_px,
      t600 = limb_lower_m * (limb2_lower_twist_rate_vz - (limb2_lower_twist_rate_wx * t532 - limb2_U_a_0 * t544));
    RESULT(checked0, momentum_rates, 20, t592 + t600);
    /* limb2: momentum, eq. (31); momentum rate, eq. (35) */
    const REAL t603 = t544 * limb2_lower_momentum_py - t532 * limb2_lower_momentum_px,
      t608 = limb_lower_Ixx * t552 - limb_lower_Ixz * t557, t609 = t536 * t608,
      t604 = limb_lower_Iyy * minus_limb2_U_0_cos, t610 = limb2_U_0_sin * t604 - t609,
      t622 = minus_limb2_U_0_cos * t604, t613 = limb_lower_Ixz * t552 - limb_lower_Izz * t557,
      t615 = t610 + t541 * t613, t616 = limb2_lower_twist_wx * t615, t718 = limb2_lower_twist_rate_wx * t615,
      t624 = t622 + t552 * t608, t619 = t523 * t608 - t529 * t613, t626 = t624 - t557 * t613,
      t720 = t718 + limb2_U_a_0 * t619, t628 = t616 + limb2_U_v_0 * t619 + minus_limb2_lower_twist_wz * t626,
      minus_limb2_lower_momentum_Lz = t603 + t628, t722 = t720 + minus_limb2_lower_twist_rate_wz * t626,
      t629 = limb2_U_v_0 * minus_limb2_lower_momentum_Lz, t695 = limb2_lower_twist_wx * minus_limb2_lower_momentum_Lz,
      t697 = limb2_lower_twist_vz * limb2_lower_momentum_px,
      t632 = t560 * limb2_lower_momentum_px - t544 * limb2_lower_momentum_pz,
      t635 = limb_lower_Ixx * t523 - limb_lower_Ixz * t529, t636 = t536 * t635,
      t639 = limb_lower_Ixz * t523 - limb_lower_Izz * t529, t641 = t636 - t541 * t639,
      t642 = limb2_lower_twist_wx * t641, t704 = limb2_lower_twist_rate_wx * t641, t648 = t552 * t635,
      t645 = t523 * t635 - t529 * t639, t650 = t648 - t557 * t639;
    /* limb2: momentum rate, eq. (35); momentum, eq. (31) */
    const REAL t706 = t704 - limb2_U_a_0 * t645, t652 = t642 - limb2_U_v_0 * t645 - minus_limb2_lower_twist_wz * t650,
      minus_limb2_lower_momentum_Ly = t632 + t652, t708 = t706 - minus_limb2_lower_twist_rate_wz * t650,
      t654 = t629 + minus_limb2_lower_twist_wz * minus_limb2_lower_momentum_Ly,
      t710 = limb2_lower_twist_wx * minus_limb2_lower_momentum_Ly,
      t656 = t654 + limb2_lower_twist_vz * limb2_lower_momentum_py, t702 = t544 * t600, t715 = t544 * t582,
      t659 = t532 * t600 - t560 * t582, t664 = limb_lower_Ixx * t536 - limb_lower_Ixz * t541, t665 = t536 * t664,
      t660 = limb_lower_Iyy * limb2_U_0_sin, t666 = limb2_U_0_sin * t660 + t665, t678 = minus_limb2_U_0_cos * t660,
      t669 = limb_lower_Ixz * t536 - limb_lower_Izz * t541, t671 = t666 - t541 * t669,
      t672 = limb2_lower_twist_rate_wx * t671, t689 = limb2_lower_twist_wx * t671, t680 = t678 - t552 * t664,
      t675 = t523 * t664 - t529 * t669, t682 = t680 + t557 * t669, t691 = t689 - limb2_U_v_0 * t675,
      t684 = t672 - limb2_U_a_0 * t675 + minus_limb2_lower_twist_rate_wz * t682;
    RESULT(checked1, momentum_rates, 21, -(t656 + (t659 - t684)));
    const REAL t693 = t691 + minus_limb2_lower_twist_wz * t682,
      t699 = t697 - limb2_lower_twist_vx * limb2_lower_momentum_pz, t717 = t715 - t532 * t575,
      t703 = t560 * t575 - t702,
      minus_limb2_lower_momentum_Lx = t532 * limb2_lower_momentum_pz - t560 * limb2_lower_momentum_py - t693,
      t713 = limb2_lower_twist_vx * limb2_lower_momentum_py, t723 = t717 + t722;
    RESULT(checked2, momentum_rates, 22, minus_limb2_lower_twist_wz * minus_limb2_lower_momentum_Lx + t695 + t699 - (t703 + t708));
    RESULT(checked3, momentum_rates, 23, -(t710 - limb2_U_v_0 * minus_limb2_lower_momentum_Lx - t713 + t723));
    /* limb2: momentum, eq. (31); velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t736 = 0.5 * t536 - param_H * t541, t740 = limb_upper_com_x * t536 - limb_upper_com_z * t541,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      t741 = limb2_upper_offset_x * minus_limb2_lower_rotation_xx + t736 - t740, t742 = limb2_U_v_0 * t741,
      t731 = limb_upper_com_x * t523 - limb_upper_com_z * t529,
      t728 = param_R - limb2_lower_sin * limb2_upper_offset_x - (0.5 * t523 - param_H * t529), t732 = t728 + t731,
      limb2_P_v = READ(v, 5), minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx,
      t743 = limb2_lower_twist_wx * t732 - t742,
      limb2_upper_twist_vz = limb2_lower_twist_vz - limb2_P_v * minus_limb2_lower_rotation_zx,
      limb2_upper_momentum_pz = limb_lower_m * (limb2_upper_twist_vz - t743),
      t745 = limb2_U_v_0 * limb2_upper_momentum_pz, t746 = minus_limb2_lower_twist_wz * t741,
      t750 = minus_limb2_upper_position_z + (0.5 * t552 - param_H * t557),
      t754 = t750 - (limb_upper_com_x * t552 - limb_upper_com_z * t557), t756 = t746 + limb2_lower_twist_wx * t754,
      limb2_upper_twist_vy = limb2_P_v * limb2_lower_sin,
      limb2_upper_momentum_py = limb_lower_m * (limb2_upper_twist_vy + t756), limb2_P_a = READ(a, 5),
      t759 = t745 + minus_limb2_lower_twist_wz * limb2_upper_momentum_py,
      t768 = limb2_U_a_0 * t754 + minus_limb2_lower_twist_rate_wz * t732,
      t776 = minus_limb2_lower_twist_rate_wz * t741,
      t761 = limb2_lower_twist_rate_vx - limb2_P_a * minus_limb2_lower_rotation_xx,
      t765 = limb2_P_v * (limb2_U_v_0 * minus_limb2_lower_rotation_zx - limb2_lower_sin * minus_limb2_lower_twist_wz),
      t770 = limb_lower_m * (t761 - t765 - t768);
    RESULT(checked0, momentum_rates, 24, t759 + t770);
    const REAL t784 = limb2_U_v_0 * t754 + minus_limb2_lower_twist_wz * t732,
      limb2_upper_twist_vx = limb2_lower_twist_vx - limb2_P_v * minus_limb2_lower_rotation_xx,
      limb2_upper_momentum_px = limb_lower_m * (limb2_upper_twist_vx - t784);
    /* limb2: momentum rate, eq. (35); accelerations; momentum, eq. (31) */
    const REAL t786 = minus_limb2_lower_twist_wz * limb2_upper_momentum_px,
      t788 = t786 + limb2_lower_twist_wx * limb2_upper_momentum_pz, t778 = t776 + limb2_lower_twist_rate_wx * t754,
      t798 = limb2_lower_twist_rate_wx * t732, t772 = minus_limb2_lower_rotation_xx * minus_limb2_lower_twist_wz,
      t795 = limb2_U_v_0 * minus_limb2_lower_rotation_xx,
      t775 = limb2_P_v * (t772 + minus_limb2_lower_rotation_zx * limb2_lower_twist_wx),
      t793 = limb2_lower_twist_rate_vz - limb2_P_a * minus_limb2_lower_rotation_zx,
      t780 = limb_lower_m * (limb2_P_a * limb2_lower_sin + t775 + t778);
    RESULT(checked1, momentum_rates, 25, t780 - t788);
    const REAL t791 = limb2_lower_twist_wx * limb2_upper_momentum_py - limb2_U_v_0 * limb2_upper_momentum_px,
      t800 = t798 - limb2_U_a_0 * t741,
      t802 = limb_lower_m * (t793 + limb2_P_v * (limb2_lower_sin * limb2_lower_twist_wx + t795) - t800);
    RESULT(checked2, momentum_rates, 26, t791 + t802);
    const REAL minus_limb2_upper_momentum_Lz = t628 + (t741 * limb2_upper_momentum_py - t732 * limb2_upper_momentum_px),
      t810 = limb2_U_v_0 * minus_limb2_upper_momentum_Lz, t824 = limb2_lower_twist_wx * minus_limb2_upper_momentum_Lz,
      minus_limb2_upper_momentum_Ly = t652 + (t754 * limb2_upper_momentum_px - t741 * limb2_upper_momentum_pz),
      t834 = limb2_lower_twist_wx * minus_limb2_upper_momentum_Ly,
      t815 = t810 + minus_limb2_lower_twist_wz * minus_limb2_upper_momentum_Ly,
      t838 = limb2_upper_twist_vy * limb2_upper_momentum_px, t826 = limb2_upper_twist_vz * limb2_upper_momentum_px,
      t818 = limb2_upper_twist_vy * limb2_upper_momentum_pz - limb2_upper_twist_vz * limb2_upper_momentum_py,
      t831 = t741 * t802, t841 = t741 * t780;
    RESULT(checked3, momentum_rates, 27, t684 - (t732 * t802 - t754 * t780) - (t815 - t818));
    const REAL t828 = t826 - limb2_upper_twist_vx * limb2_upper_momentum_pz,
      t839 = limb2_upper_twist_vx * limb2_upper_momentum_py - t838,
      limb2_upper_momentum_Lx = t693 - (t732 * limb2_upper_momentum_pz - t754 * limb2_upper_momentum_py),
      t829 = minus_limb2_lower_twist_wz * limb2_upper_momentum_Lx - t824 - t828;
    RESULT(checked0, momentum_rates, 28, -(t829 + (t708 + (t754 * t770 - t831))));
    const REAL t844 = t722 + (t841 - t732 * t770);
    RESULT(checked1, momentum_rates, 29, -(t834 + limb2_U_v_0 * limb2_upper_momentum_Lx - t839 + t844));
    /* limb3: geometry */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_lower_cos = SINES(cosine, 5),
      minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos, minus_limb3_lower_sin = SINES(sine, 5);
    /* limb3: momentum, eq. (31); geometry; velocities, eq. (6) */
    const REAL t846 = 0.5 * minus_limb3_lower_rotation_yx,
      minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin,
      t848 = t846 - k1 * minus_limb3_lower_rotation_yy, t850 = limb_lower_com_x * t848,
      t853 = k1 * minus_limb3_lower_rotation_yx + 0.5 * minus_limb3_lower_rotation_yy,
      t856 = param_R * t848 - (t850 - limb_lower_com_z * t853), limb3_U_v_0 = READ(v, 6), t857 = limb3_U_v_0 * t856,
      t860 = 0.5 * minus_limb3_lower_sin + k1 * limb3_lower_cos, t862 = param_R - param_R * t860,
      t863 = limb_lower_com_x * t860, t866 = k1 * minus_limb3_lower_sin - 0.5 * limb3_lower_cos,
      t869 = t862 + (t863 - limb_lower_com_z * t866), limb3_U_v_1 = READ(v, 7), limb3_U_0_cos = SINES(cosine, 4),
      limb3_lower_twist_wy = limb3_U_v_1 * limb3_U_0_cos, t871 = t857 + limb3_lower_twist_wy * t869,
      limb3_U_1_screw_vz = param_R * limb3_U_0_cos, limb3_lower_twist_vz = limb3_U_v_1 * limb3_U_1_screw_vz,
      limb3_lower_momentum_pz = limb_lower_m * (limb3_lower_twist_vz - t871),
      t873 = limb3_lower_twist_wy * limb3_lower_momentum_pz,
      limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos, t875 = 0.5 * limb3_lower_rotation_zx,
      limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin, t877 = t875 - k1 * limb3_lower_rotation_zy,
      t879 = limb_lower_com_x * t877, t882 = k1 * limb3_lower_rotation_zx + 0.5 * limb3_lower_rotation_zy,
      t885 = param_R * t877 - (t879 - limb_lower_com_z * t882), t886 = limb3_U_v_0 * t885,
      limb3_lower_twist_wz = limb3_U_v_1 * limb3_U_0_sin, t887 = limb3_lower_twist_wz * t869 - t886,
      minus_limb3_U_1_screw_vy = param_R * limb3_U_0_sin,
      minus_limb3_lower_twist_vy = limb3_U_v_1 * minus_limb3_U_1_screw_vy,
      minus_limb3_lower_momentum_py = limb_lower_m * (minus_limb3_lower_twist_vy - t887), limb3_U_a_1 = READ(a, 7);
    /* limb3: momentum rate, eq. (35); accelerations; momentum, eq. (31) */
    const REAL t890 = t873 + limb3_lower_twist_wz * minus_limb3_lower_momentum_py,
      limb3_lower_twist_rate_wy = limb3_U_a_1 * limb3_U_0_cos - limb3_U_v_1 * (limb3_U_v_0 * limb3_U_0_sin),
      t894 = limb3_lower_twist_rate_wy * t885,
      limb3_lower_twist_rate_wz = limb3_U_a_1 * limb3_U_0_sin + limb3_U_v_1 * (limb3_U_v_0 * limb3_U_0_cos),
      t900 = limb_lower_m * (t894 + limb3_lower_twist_rate_wz * t856);
    RESULT(checked2, momentum_rates, 30, t890 + t900);
    const REAL t905 = limb3_U_v_0 * limb3_lower_momentum_pz,
      limb3_lower_momentum_px = limb_lower_m * (limb3_lower_twist_wy * t885 + limb3_lower_twist_wz * t856),
      limb3_U_a_0 = READ(a, 6), t906 = limb3_lower_twist_wz * limb3_lower_momentum_px - t905,
      t912 = limb3_lower_twist_rate_wz * t869 - limb3_U_a_0 * t885, t915 = limb3_U_a_1 * limb3_U_1_screw_vz,
      minus_limb3_lower_twist_rate_vy = limb3_U_a_1 * minus_limb3_U_1_screw_vy + limb3_U_v_1 * (limb3_U_v_0 * limb3_U_1_screw_vz),
      t914 = limb_lower_m * (minus_limb3_lower_twist_rate_vy - t912);
    RESULT(checked3, momentum_rates, 31, t906 - t914);
    const REAL limb3_lower_twist_rate_vz = t915 - limb3_U_v_1 * (limb3_U_v_0 * minus_limb3_U_1_screw_vy),
      t925 = limb3_U_v_0 * minus_limb3_lower_momentum_py + limb3_lower_twist_wy * limb3_lower_momentum_px,
      t922 = limb_lower_m * (limb3_lower_twist_rate_vz - (limb3_U_a_0 * t856 + limb3_lower_twist_rate_wy * t869));
    RESULT(checked0, momentum_rates, 32, t922 - t925);
    /* limb3: momentum, eq. (31); momentum rate, eq. (35) */
    const REAL t928 = t869 * minus_limb3_lower_momentum_py - t856 * limb3_lower_momentum_px,
      t931 = limb_lower_Ixx * t877 - limb_lower_Ixz * t882, t939 = t848 * t931, t940 = limb_lower_Iyy * limb3_U_0_sin,
      t942 = t939 - limb3_U_0_cos * t940, t948 = limb3_U_0_sin * t940,
      t935 = limb_lower_Ixz * t877 - limb_lower_Izz * t882, t944 = t942 - t853 * t935,
      t945 = limb3_lower_twist_wy * t944, t1044 = limb3_lower_twist_rate_wy * t944, t949 = t877 * t931 + t948,
      t937 = t860 * t931 - t866 * t935, t951 = t949 - t882 * t935, t1045 = limb3_U_a_0 * t937 + t1044,
      t953 = limb3_U_v_0 * t937 + t945 - limb3_lower_twist_wz * t951, minus_limb3_lower_momentum_Lz = t928 + t953,
      t1047 = t1045 - limb3_lower_twist_rate_wz * t951, t954 = limb3_lower_twist_wy * minus_limb3_lower_momentum_Lz,
      t1031 = limb3_U_v_0 * minus_limb3_lower_momentum_Lz,
      t957 = t885 * limb3_lower_momentum_px - t869 * limb3_lower_momentum_pz,
      t960 = limb_lower_Ixx * t848 - limb_lower_Ixz * t853, t968 = t848 * t960, t969 = limb_lower_Iyy * limb3_U_0_cos,
      t971 = t968 + limb3_U_0_cos * t969, t977 = limb3_U_0_sin * t969,
      t964 = limb_lower_Ixz * t848 - limb_lower_Izz * t853, t973 = t971 - t853 * t964,
      t974 = limb3_lower_twist_wy * t973, t1017 = limb3_lower_twist_rate_wy * t973, t978 = t877 * t960 - t977,
      t966 = t860 * t960 - t866 * t964, t980 = t978 - t882 * t964;
    /* limb3: momentum rate, eq. (35); momentum, eq. (31) */
    const REAL t1018 = limb3_U_a_0 * t966 + t1017, t982 = limb3_U_v_0 * t966 + t974 - limb3_lower_twist_wz * t980,
      limb3_lower_momentum_Ly = t957 + t982, t1020 = t1018 - limb3_lower_twist_rate_wz * t980,
      t984 = t954 + limb3_lower_twist_wz * limb3_lower_momentum_Ly, t1035 = limb3_U_v_0 * limb3_lower_momentum_Ly,
      t985 = minus_limb3_lower_twist_vy * limb3_lower_momentum_pz,
      t988 = t984 + (t985 - limb3_lower_twist_vz * minus_limb3_lower_momentum_py),
      t1024 = t856 * limb3_lower_momentum_pz - t885 * minus_limb3_lower_momentum_py, t991 = t856 * t922 - t885 * t914,
      t1021 = t885 * t900 - t869 * t922 + t1020, t1048 = t869 * t914 - t856 * t900 + t1047,
      t994 = limb_lower_Ixx * t860 - limb_lower_Ixz * t866, t995 = t860 * t994,
      t998 = limb_lower_Ixz * t860 - limb_lower_Izz * t866, t1000 = t995 - t866 * t998, t1001 = limb3_U_a_0 * t1000,
      t1025 = limb3_U_v_0 * t1000, t1007 = t877 * t994, t1004 = t848 * t994 - t853 * t998,
      t1009 = t1007 - t882 * t998, t1027 = t1025 + limb3_lower_twist_wy * t1004,
      t1011 = t1001 + limb3_lower_twist_rate_wy * t1004 - limb3_lower_twist_rate_wz * t1009;
    RESULT(checked1, momentum_rates, 33, -(t988 + (t991 - t1011)));
    const REAL t1029 = t1027 - limb3_lower_twist_wz * t1009, minus_limb3_lower_momentum_Lx = t1024 - t1029,
      t1032 = limb3_lower_twist_wz * minus_limb3_lower_momentum_Lx - t1031,
      t1037 = t1035 + limb3_lower_twist_wy * minus_limb3_lower_momentum_Lx;
    RESULT(checked2, momentum_rates, 34, t1021 - (t1032 - limb3_lower_twist_vz * limb3_lower_momentum_px));
    RESULT(checked3, momentum_rates, 35, t1037 + minus_limb3_lower_twist_vy * limb3_lower_momentum_px - t1048);
    /* limb3: momentum, eq. (31); velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t1052 = 0.5 * t848 - param_H * t853, t1056 = limb_upper_com_x * t848 - limb_upper_com_z * t853,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      t1057 = limb3_upper_offset_x * minus_limb3_lower_rotation_yx + t1052 - t1056, t1058 = limb3_U_v_0 * t1057,
      t1065 = limb_upper_com_x * t860 - limb_upper_com_z * t866,
      t1062 = param_R - minus_limb3_lower_sin * limb3_upper_offset_x - (0.5 * t860 - param_H * t866),
      t1066 = t1062 + t1065, limb3_P_v = READ(v, 8),
      limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx,
      t1068 = t1058 + limb3_lower_twist_wy * t1066,
      limb3_upper_twist_vz = limb3_lower_twist_vz + limb3_P_v * limb3_lower_rotation_zx,
      limb3_upper_momentum_pz = limb_lower_m * (limb3_upper_twist_vz - t1068),
      t1070 = limb3_lower_twist_wy * limb3_upper_momentum_pz,
      t1076 = limb3_upper_position_z + (0.5 * t877 - param_H * t882),
      t1080 = t1076 - (limb_upper_com_x * t877 - limb_upper_com_z * t882),
      t1082 = limb3_lower_twist_wz * t1066 - limb3_U_v_0 * t1080,
      minus_limb3_upper_twist_vy = minus_limb3_lower_twist_vy + limb3_P_v * minus_limb3_lower_rotation_yx,
      minus_limb3_upper_momentum_py = limb_lower_m * (minus_limb3_upper_twist_vy - t1082),
      t1085 = t1070 + limb3_lower_twist_wz * minus_limb3_upper_momentum_py, t1121 = limb3_lower_twist_rate_wy * t1066,
      t1093 = limb3_lower_twist_rate_wy * t1080 + limb3_lower_twist_rate_wz * t1057,
      t1109 = limb3_lower_twist_rate_wz * t1066, t1087 = limb3_lower_rotation_zx * limb3_lower_twist_wy,
      limb3_P_a = READ(a, 8), t1090 = limb3_P_v * (t1087 + minus_limb3_lower_rotation_yx * limb3_lower_twist_wz),
      t1095 = limb_lower_m * (limb3_P_a * minus_limb3_lower_sin - t1090 - t1093);
    RESULT(checked0, momentum_rates, 36, t1085 - t1095);
    const REAL t1098 = limb3_lower_twist_wy * t1080 + limb3_lower_twist_wz * t1057,
      minus_limb3_upper_twist_vx = limb3_P_v * minus_limb3_lower_sin,
      minus_limb3_upper_momentum_px = limb_lower_m * (minus_limb3_upper_twist_vx - t1098);
    /* limb3: momentum rate, eq. (35); accelerations; momentum, eq. (31) */
    const REAL t1102 = limb3_lower_twist_wz * minus_limb3_upper_momentum_px + limb3_U_v_0 * limb3_upper_momentum_pz,
      t1111 = t1109 - limb3_U_a_0 * t1080,
      t1104 = minus_limb3_lower_twist_rate_vy + limb3_P_a * minus_limb3_lower_rotation_yx,
      t1116 = limb3_U_v_0 * minus_limb3_lower_rotation_yx,
      t1108 = limb3_P_v * (minus_limb3_lower_sin * limb3_lower_twist_wz + limb3_U_v_0 * limb3_lower_rotation_zx),
      t1113 = limb_lower_m * (t1104 + t1108 - t1111);
    RESULT(checked1, momentum_rates, 37, -(t1102 + t1113));
    const REAL t1115 = limb3_lower_twist_rate_vz + limb3_P_a * limb3_lower_rotation_zx,
      t1125 = limb3_U_v_0 * minus_limb3_upper_momentum_py,
      t1127 = t1125 - limb3_lower_twist_wy * minus_limb3_upper_momentum_px, t1122 = limb3_U_a_0 * t1057 + t1121,
      t1124 = limb_lower_m * (t1115 - limb3_P_v * (t1116 - minus_limb3_lower_sin * limb3_lower_twist_wy) - t1122);
    RESULT(checked2, momentum_rates, 38, t1124 - t1127);
    const REAL minus_limb3_upper_momentum_Lz = t953 + (t1066 * minus_limb3_upper_momentum_py + t1057 * minus_limb3_upper_momentum_px),
      t1135 = limb3_lower_twist_wy * minus_limb3_upper_momentum_Lz,
      t1149 = limb3_U_v_0 * minus_limb3_upper_momentum_Lz,
      limb3_upper_momentum_Ly = t982 - (t1080 * minus_limb3_upper_momentum_px + t1066 * limb3_upper_momentum_pz),
      t1140 = t1135 + limb3_lower_twist_wz * limb3_upper_momentum_Ly, t1159 = limb3_U_v_0 * limb3_upper_momentum_Ly,
      t1141 = minus_limb3_upper_twist_vy * limb3_upper_momentum_pz,
      t1163 = minus_limb3_upper_twist_vy * minus_limb3_upper_momentum_px,
      t1151 = limb3_upper_twist_vz * minus_limb3_upper_momentum_px,
      t1144 = t1140 + (t1141 - limb3_upper_twist_vz * minus_limb3_upper_momentum_py), t1156 = t1066 * t1124,
      t1166 = t1066 * t1113;
    RESULT(checked3, momentum_rates, 39, t1011 - (t1057 * t1124 - t1080 * t1113) - t1144);
    const REAL t1153 = t1151 - minus_limb3_upper_twist_vx * limb3_upper_momentum_pz,
      t1164 = minus_limb3_upper_twist_vx * minus_limb3_upper_momentum_py - t1163,
      limb3_upper_momentum_Lx = t1029 - (t1057 * limb3_upper_momentum_pz - t1080 * minus_limb3_upper_momentum_py),
      t1154 = limb3_lower_twist_wz * limb3_upper_momentum_Lx + t1149 - t1153,
      t1165 = t1159 - limb3_lower_twist_wy * limb3_upper_momentum_Lx + t1164;
    RESULT(checked0, momentum_rates, 40, t1154 + (t1020 - (t1080 * t1095 + t1156)));
    RESULT(checked1, momentum_rates, 41, t1165 - (t1047 + (t1166 + t1057 * t1095)));
    /* limb4: geometry */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_lower_cos = SINES(cosine, 7),
      minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos, minus_limb4_lower_sin = SINES(sine, 7);
    /* limb4: momentum, eq. (31); momentum rate, eq. (35); accelerations */
    const REAL t1184 = 0.5 * minus_limb4_lower_rotation_xx,
      minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin,
      t1186 = t1184 + k1 * minus_limb4_lower_rotation_xy, t1188 = limb_lower_com_x * t1186,
      t1191 = k1 * minus_limb4_lower_rotation_xx - 0.5 * minus_limb4_lower_rotation_xy,
      t1194 = param_R * t1186 - (t1188 - limb_lower_com_z * t1191), limb4_U_v_0 = READ(v, 9),
      t1195 = limb4_U_v_0 * t1194, t1173 = 0.5 * minus_limb4_lower_sin - k1 * limb4_lower_cos,
      t1175 = param_R - param_R * t1173, t1176 = limb_lower_com_x * t1173,
      t1179 = k1 * minus_limb4_lower_sin + 0.5 * limb4_lower_cos, t1182 = t1175 + (t1176 - limb_lower_com_z * t1179),
      limb4_U_v_1 = READ(v, 10), limb4_U_0_sin = SINES(cosine, 6), limb4_lower_twist_wx = limb4_U_v_1 * limb4_U_0_sin,
      t1196 = limb4_lower_twist_wx * t1182 + t1195, minus_limb4_U_1_screw_vz = param_R * limb4_U_0_sin,
      minus_limb4_lower_twist_vz = limb4_U_v_1 * minus_limb4_U_1_screw_vz,
      minus_limb4_lower_momentum_pz = limb_lower_m * (minus_limb4_lower_twist_vz - t1196),
      t1198 = limb4_U_v_0 * minus_limb4_lower_momentum_pz,
      minus_limb4_lower_twist_wz = limb4_U_v_1 * minus_limb4_U_0_cos, t1199 = minus_limb4_lower_twist_wz * t1194,
      minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos, t1200 = 0.5 * minus_limb4_lower_rotation_zx,
      minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin,
      t1202 = t1200 + k1 * minus_limb4_lower_rotation_zy, t1204 = limb_lower_com_x * t1202,
      t1207 = k1 * minus_limb4_lower_rotation_zx - 0.5 * minus_limb4_lower_rotation_zy,
      t1210 = param_R * t1202 - (t1204 - limb_lower_com_z * t1207),
      limb4_lower_momentum_py = limb_lower_m * (t1199 + limb4_lower_twist_wx * t1210), limb4_U_a_0 = READ(a, 9),
      limb4_U_a_1 = READ(a, 10), t1214 = t1198 - minus_limb4_lower_twist_wz * limb4_lower_momentum_py,
      t1218 = limb4_U_a_0 * t1210,
      minus_limb4_lower_twist_rate_wz = limb4_U_a_1 * minus_limb4_U_0_cos + limb4_U_v_1 * (limb4_U_v_0 * limb4_U_0_sin),
      t1223 = t1218 - minus_limb4_lower_twist_rate_wz * t1182,
      t1217 = limb4_U_v_1 * (limb4_U_v_0 * minus_limb4_U_1_screw_vz), t1243 = limb4_U_a_1 * minus_limb4_U_1_screw_vz,
      minus_limb4_U_1_screw_vx = param_R * minus_limb4_U_0_cos,
      minus_limb4_lower_twist_rate_vx = limb4_U_a_1 * minus_limb4_U_1_screw_vx + t1217,
      t1225 = limb_lower_m * (minus_limb4_lower_twist_rate_vx + t1223);
    RESULT(checked2, momentum_rates, 42, -(t1214 + t1225));
    const REAL t1228 = limb4_U_v_0 * t1210 - minus_limb4_lower_twist_wz * t1182,
      minus_limb4_lower_twist_vx = limb4_U_v_1 * minus_limb4_U_1_screw_vx,
      minus_limb4_lower_momentum_px = limb_lower_m * (minus_limb4_lower_twist_vx + t1228),
      minus_limb4_lower_twist_rate_vz = t1243 - limb4_U_v_1 * (limb4_U_v_0 * minus_limb4_U_1_screw_vx);
    /* limb4: momentum rate, eq. (35); accelerations */
    const REAL t1230 = minus_limb4_lower_twist_wz * minus_limb4_lower_momentum_px,
      t1232 = t1230 + limb4_lower_twist_wx * minus_limb4_lower_momentum_pz,
      t1233 = minus_limb4_lower_twist_rate_wz * t1194,
      limb4_lower_twist_rate_wx = limb4_U_a_1 * limb4_U_0_sin - limb4_U_v_1 * (limb4_U_v_0 * minus_limb4_U_0_cos),
      t1239 = limb_lower_m * (t1233 + limb4_lower_twist_rate_wx * t1210);
    RESULT(checked3, momentum_rates, 43, t1232 + t1239);
    const REAL t1242 = limb4_lower_twist_wx * limb4_lower_momentum_py + limb4_U_v_0 * minus_limb4_lower_momentum_px,
      t1250 = limb_lower_m * (minus_limb4_lower_twist_rate_vz - (limb4_lower_twist_rate_wx * t1182 + limb4_U_a_0 * t1194));
    RESULT(checked0, momentum_rates, 44, t1242 - t1250);
    /* limb4: momentum, eq. (31); momentum rate, eq. (35) */
    const REAL t1253 = t1194 * limb4_lower_momentum_py - t1182 * minus_limb4_lower_momentum_px,
      t1258 = limb_lower_Ixx * t1202 - limb_lower_Ixz * t1207, t1259 = t1186 * t1258,
      t1254 = limb_lower_Iyy * minus_limb4_U_0_cos, t1260 = limb4_U_0_sin * t1254 - t1259,
      t1272 = minus_limb4_U_0_cos * t1254, t1263 = limb_lower_Ixz * t1202 - limb_lower_Izz * t1207,
      t1265 = t1260 + t1191 * t1263, t1266 = limb4_lower_twist_wx * t1265, t1368 = limb4_lower_twist_rate_wx * t1265,
      t1274 = t1272 + t1202 * t1258, t1269 = t1173 * t1258 - t1179 * t1263, t1276 = t1274 - t1207 * t1263,
      t1370 = t1368 - limb4_U_a_0 * t1269, t1278 = t1266 - limb4_U_v_0 * t1269 + minus_limb4_lower_twist_wz * t1276,
      minus_limb4_lower_momentum_Lz = t1253 + t1278, t1372 = t1370 + minus_limb4_lower_twist_rate_wz * t1276,
      t1279 = limb4_U_v_0 * minus_limb4_lower_momentum_Lz,
      t1345 = limb4_lower_twist_wx * minus_limb4_lower_momentum_Lz,
      t1347 = minus_limb4_lower_twist_vz * minus_limb4_lower_momentum_px,
      t1282 = t1210 * minus_limb4_lower_momentum_px - t1194 * minus_limb4_lower_momentum_pz,
      t1285 = limb_lower_Ixx * t1173 - limb_lower_Ixz * t1179, t1286 = t1186 * t1285,
      t1289 = limb_lower_Ixz * t1173 - limb_lower_Izz * t1179, t1291 = t1286 - t1191 * t1289,
      t1292 = limb4_lower_twist_wx * t1291, t1354 = limb4_lower_twist_rate_wx * t1291, t1298 = t1202 * t1285,
      t1295 = t1173 * t1285 - t1179 * t1289, t1300 = t1298 - t1207 * t1289;
    /* limb4: momentum rate, eq. (35); momentum, eq. (31) */
    const REAL t1356 = t1354 + limb4_U_a_0 * t1295,
      t1302 = t1292 + limb4_U_v_0 * t1295 - minus_limb4_lower_twist_wz * t1300,
      limb4_lower_momentum_Ly = t1282 + t1302, t1358 = t1356 - minus_limb4_lower_twist_rate_wz * t1300,
      t1304 = t1279 - minus_limb4_lower_twist_wz * limb4_lower_momentum_Ly,
      t1360 = limb4_lower_twist_wx * limb4_lower_momentum_Ly,
      t1306 = t1304 - minus_limb4_lower_twist_vz * limb4_lower_momentum_py, t1352 = t1194 * t1250,
      t1365 = t1194 * t1239, t1309 = t1182 * t1250 - t1210 * t1239,
      t1314 = limb_lower_Ixx * t1186 - limb_lower_Ixz * t1191, t1315 = t1186 * t1314,
      t1310 = limb_lower_Iyy * limb4_U_0_sin, t1316 = limb4_U_0_sin * t1310 + t1315,
      t1328 = minus_limb4_U_0_cos * t1310, t1319 = limb_lower_Ixz * t1186 - limb_lower_Izz * t1191,
      t1321 = t1316 - t1191 * t1319, t1322 = limb4_lower_twist_rate_wx * t1321, t1339 = limb4_lower_twist_wx * t1321,
      t1330 = t1328 - t1202 * t1314, t1325 = t1173 * t1314 - t1179 * t1319, t1332 = t1330 + t1207 * t1319,
      t1341 = t1339 + limb4_U_v_0 * t1325,
      t1334 = t1322 + limb4_U_a_0 * t1325 + minus_limb4_lower_twist_rate_wz * t1332;
    RESULT(checked1, momentum_rates, 45, -(t1306 + (t1309 - t1334)));
    const REAL t1343 = t1341 + minus_limb4_lower_twist_wz * t1332,
      t1349 = t1347 - minus_limb4_lower_twist_vx * minus_limb4_lower_momentum_pz, t1367 = t1365 - t1182 * t1225,
      t1353 = t1210 * t1225 - t1352,
      minus_limb4_lower_momentum_Lx = t1182 * minus_limb4_lower_momentum_pz - t1210 * limb4_lower_momentum_py - t1343,
      t1363 = minus_limb4_lower_twist_vx * limb4_lower_momentum_py, t1373 = t1367 + t1372;
    RESULT(checked2, momentum_rates, 46, minus_limb4_lower_twist_wz * minus_limb4_lower_momentum_Lx + t1345 + t1349 + (t1353 + t1358));
    RESULT(checked3, momentum_rates, 47, t1360 + limb4_U_v_0 * minus_limb4_lower_momentum_Lx - t1363 - t1373);
    /* limb4: momentum, eq. (31); velocities, eq. (6); momentum rate, eq. (35) */
    const REAL t1386 = 0.5 * t1186 - param_H * t1191, t1390 = limb_upper_com_x * t1186 - limb_upper_com_z * t1191,
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      t1391 = limb4_upper_offset_x * minus_limb4_lower_rotation_xx + t1386 - t1390, t1392 = limb4_U_v_0 * t1391,
      t1381 = limb_upper_com_x * t1173 - limb_upper_com_z * t1179,
      t1378 = param_R - minus_limb4_lower_sin * limb4_upper_offset_x - (0.5 * t1173 - param_H * t1179),
      t1382 = t1378 + t1381, limb4_P_v = READ(v, 11),
      minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx,
      t1393 = limb4_lower_twist_wx * t1382 + t1392,
      minus_limb4_upper_twist_vz = minus_limb4_lower_twist_vz + limb4_P_v * minus_limb4_lower_rotation_zx,
      minus_limb4_upper_momentum_pz = limb_lower_m * (minus_limb4_upper_twist_vz - t1393),
      t1395 = limb4_U_v_0 * minus_limb4_upper_momentum_pz, t1396 = minus_limb4_lower_twist_wz * t1391,
      t1400 = minus_limb4_upper_position_z + (0.5 * t1202 - param_H * t1207),
      t1404 = t1400 - (limb_upper_com_x * t1202 - limb_upper_com_z * t1207),
      t1406 = t1396 + limb4_lower_twist_wx * t1404, minus_limb4_upper_twist_vy = limb4_P_v * minus_limb4_lower_sin,
      minus_limb4_upper_momentum_py = limb_lower_m * (minus_limb4_upper_twist_vy - t1406), limb4_P_a = READ(a, 11),
      t1409 = t1395 + minus_limb4_lower_twist_wz * minus_limb4_upper_momentum_py,
      t1418 = limb4_U_a_0 * t1404 - minus_limb4_lower_twist_rate_wz * t1382,
      t1434 = minus_limb4_lower_twist_rate_wz * t1391,
      t1411 = minus_limb4_lower_twist_rate_vx + limb4_P_a * minus_limb4_lower_rotation_xx,
      t1412 = limb4_U_v_0 * minus_limb4_lower_rotation_zx,
      t1420 = limb_lower_m * (t1411 + limb4_P_v * (t1412 + minus_limb4_lower_sin * minus_limb4_lower_twist_wz) + t1418);
    RESULT(checked0, momentum_rates, 48, -(t1409 + t1420));
    const REAL t1424 = limb4_U_v_0 * t1404 - minus_limb4_lower_twist_wz * t1382,
      minus_limb4_upper_twist_vx = minus_limb4_lower_twist_vx + limb4_P_v * minus_limb4_lower_rotation_xx,
      minus_limb4_upper_momentum_px = limb_lower_m * (minus_limb4_upper_twist_vx + t1424);
    /* limb4: momentum rate, eq. (35); accelerations; momentum, eq. (31) */
    const REAL t1426 = minus_limb4_lower_twist_wz * minus_limb4_upper_momentum_px,
      t1428 = t1426 + limb4_lower_twist_wx * minus_limb4_upper_momentum_pz,
      t1436 = t1434 + limb4_lower_twist_rate_wx * t1404, t1448 = limb4_lower_twist_rate_wx * t1382,
      t1430 = minus_limb4_lower_rotation_xx * minus_limb4_lower_twist_wz,
      t1445 = limb4_U_v_0 * minus_limb4_lower_rotation_xx,
      t1433 = limb4_P_v * (t1430 + minus_limb4_lower_rotation_zx * limb4_lower_twist_wx),
      t1443 = minus_limb4_lower_twist_rate_vz + limb4_P_a * minus_limb4_lower_rotation_zx,
      t1438 = limb_lower_m * (limb4_P_a * minus_limb4_lower_sin - t1433 - t1436);
    RESULT(checked1, momentum_rates, 49, t1428 - t1438);
    const REAL t1439 = limb4_lower_twist_wx * minus_limb4_upper_momentum_py,
      t1441 = t1439 - limb4_U_v_0 * minus_limb4_upper_momentum_px, t1450 = t1448 + limb4_U_a_0 * t1391,
      t1452 = limb_lower_m * (t1443 + limb4_P_v * (minus_limb4_lower_sin * limb4_lower_twist_wx - t1445) - t1450);
    RESULT(checked2, momentum_rates, 50, -(t1441 + t1452));
    const REAL minus_limb4_upper_momentum_Lz = t1278 - (t1391 * minus_limb4_upper_momentum_py + t1382 * minus_limb4_upper_momentum_px),
      t1460 = limb4_U_v_0 * minus_limb4_upper_momentum_Lz,
      t1478 = limb4_lower_twist_wx * minus_limb4_upper_momentum_Lz,
      limb4_upper_momentum_Ly = t1302 + (t1404 * minus_limb4_upper_momentum_px - t1391 * minus_limb4_upper_momentum_pz),
      t1484 = limb4_lower_twist_wx * limb4_upper_momentum_Ly,
      t1465 = t1460 - minus_limb4_lower_twist_wz * limb4_upper_momentum_Ly,
      t1466 = minus_limb4_upper_twist_vy * minus_limb4_upper_momentum_pz,
      t1488 = minus_limb4_upper_twist_vy * minus_limb4_upper_momentum_px,
      t1480 = minus_limb4_upper_twist_vz * minus_limb4_upper_momentum_px,
      t1469 = t1465 - (t1466 - minus_limb4_upper_twist_vz * minus_limb4_upper_momentum_py), t1471 = t1391 * t1452,
      t1491 = t1391 * t1438;
    RESULT(checked3, momentum_rates, 51, t1334 - (t1382 * t1452 + t1404 * t1438) - t1469);
    const REAL t1482 = t1480 - minus_limb4_upper_twist_vx * minus_limb4_upper_momentum_pz,
      t1489 = minus_limb4_upper_twist_vx * minus_limb4_upper_momentum_py - t1488,
      limb4_upper_momentum_Lx = t1343 - (t1382 * minus_limb4_upper_momentum_pz + t1404 * minus_limb4_upper_momentum_py),
      t1483 = minus_limb4_lower_twist_wz * limb4_upper_momentum_Lx - t1478 - t1482;
    RESULT(checked0, momentum_rates, 52, t1358 + (t1404 * t1420 - t1471) - t1483);
    const REAL t1494 = t1372 - (t1491 + t1382 * t1420);
    RESULT(checked1, momentum_rates, 53, t1484 - limb4_U_v_0 * limb4_upper_momentum_Lx + t1489 - t1494);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_energy)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict energy, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    /* limb1: accelerations; velocities, eq. (6); energy */
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_omega_x = limb1_U_v_0 * SINES(sine, 1),
      limb1_lower_cos = SINES(cosine, 1), t3 = limb1_lower_omega_x * limb1_lower_omega_x,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, limb1_U_v_1 = READ(v, 1),
      t6 = k4 * (limb1_U_v_1 * limb1_U_v_1 + (t3 + limb1_lower_omega_y * limb1_lower_omega_y)),
      t8 = limb1_lower_omega_x * (k4 * limb1_lower_omega_x),
      t14 = t8 + limb1_lower_omega_y * (k5 * limb1_lower_omega_y) - limb1_U_v_1 * (k5 * limb1_U_v_1);
    /* limb2: accelerations; energy; velocities, eq. (6) */
    const REAL limb2_U_v_0 = READ(v, 3),
      limb1_lower_energy_kinetic_up_to = k3 * (limb1_U_v_0 * limb1_U_v_0) + (t6 - t14),
      limb2_U_0_energy_kinetic_up_to = limb1_lower_energy_kinetic_up_to + k3 * (limb2_U_v_0 * limb2_U_v_0),
      limb2_lower_omega_x = limb2_U_v_0 * SINES(sine, 3), limb2_lower_cos = SINES(cosine, 3),
      t19 = limb2_lower_omega_x * limb2_lower_omega_x, limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos,
      limb2_U_v_1 = READ(v, 4),
      t22 = k4 * (limb2_U_v_1 * limb2_U_v_1 + (t19 + limb2_lower_omega_y * limb2_lower_omega_y)),
      t24 = limb2_lower_omega_x * (k4 * limb2_lower_omega_x),
      t30 = t24 + limb2_lower_omega_y * (k5 * limb2_lower_omega_y) - limb2_U_v_1 * (k5 * limb2_U_v_1);
    /* limb3: accelerations; energy; velocities, eq. (6) */
    const REAL limb3_U_v_0 = READ(v, 6),
      limb3_U_0_energy_kinetic_up_to = limb2_U_0_energy_kinetic_up_to + (t22 - t30) + k3 * (limb3_U_v_0 * limb3_U_v_0),
      minus_limb3_lower_omega_x = limb3_U_v_0 * SINES(sine, 5), limb3_lower_cos = SINES(cosine, 5),
      t35 = minus_limb3_lower_omega_x * minus_limb3_lower_omega_x,
      limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos, limb3_U_v_1 = READ(v, 7),
      t38 = k4 * (limb3_U_v_1 * limb3_U_v_1 + (t35 + limb3_lower_omega_y * limb3_lower_omega_y)),
      t40 = minus_limb3_lower_omega_x * (k4 * minus_limb3_lower_omega_x),
      t46 = t40 + limb3_lower_omega_y * (k5 * limb3_lower_omega_y) - limb3_U_v_1 * (k5 * limb3_U_v_1);
    /* limb4: accelerations; energy; velocities, eq. (6) */
    const REAL limb4_U_v_0 = READ(v, 9),
      limb4_U_0_energy_kinetic_up_to = limb3_U_0_energy_kinetic_up_to + (t38 - t46) + k3 * (limb4_U_v_0 * limb4_U_v_0),
      minus_limb4_lower_omega_x = limb4_U_v_0 * SINES(sine, 7), limb4_lower_cos = SINES(cosine, 7),
      t51 = minus_limb4_lower_omega_x * minus_limb4_lower_omega_x,
      limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos, limb4_U_v_1 = READ(v, 10),
      t54 = k4 * (limb4_U_v_1 * limb4_U_v_1 + (t51 + limb4_lower_omega_y * limb4_lower_omega_y)),
      t56 = minus_limb4_lower_omega_x * (k4 * minus_limb4_lower_omega_x),
      t62 = t56 + limb4_lower_omega_y * (k5 * limb4_lower_omega_y) - limb4_U_v_1 * (k5 * limb4_U_v_1),
      limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14),
      limb4_lower_energy_kinetic_up_to = limb4_U_0_energy_kinetic_up_to + (t54 - t62),
      t68 = k6 * (limb5_S_v_wz * limb5_S_v_wz + (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy)), /* platform */
      t73 = limb5_S_v_wx * (platform_sxx * limb5_S_v_wx) + limb5_S_v_wy * (platform_sxx * limb5_S_v_wy), /* limb5_S */
      platform_energy_kinetic_up_to = limb4_lower_energy_kinetic_up_to + (t68 - (t73 + limb5_S_v_wz * (platform_szz * limb5_S_v_wz)));
    /* limb1: geometry; velocities, eq. (6); energy */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      limb1_upper_vel_y = limb1_U_v_1 * limb1_upper_offset_x, limb1_P_v = READ(v, 2),
      t83 = limb1_upper_vel_y * (k7 * limb1_U_v_1 - limb_lower_m * limb1_upper_vel_y),
      t84 = limb1_P_v * (limb_lower_m * limb1_P_v) - t83,
      minus_limb1_upper_vel_z = limb1_upper_offset_x * limb1_lower_omega_y,
      t88 = minus_limb1_upper_vel_z * (k7 * limb1_lower_omega_y - limb_lower_m * minus_limb1_upper_vel_z),
      limb1_upper_energy_kinetic_up_to = platform_energy_kinetic_up_to + (t84 - t88);
    /* limb2: geometry; velocities, eq. (6); energy */
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      limb2_upper_vel_y = limb2_U_v_1 * limb2_upper_offset_x, limb2_P_v = READ(v, 5),
      t95 = limb2_upper_vel_y * (k7 * limb2_U_v_1 - limb_lower_m * limb2_upper_vel_y),
      t96 = limb2_P_v * (limb_lower_m * limb2_P_v) - t95,
      minus_limb2_upper_vel_z = limb2_upper_offset_x * limb2_lower_omega_y,
      t100 = minus_limb2_upper_vel_z * (k7 * limb2_lower_omega_y - limb_lower_m * minus_limb2_upper_vel_z),
      limb2_upper_energy_kinetic_up_to = limb1_upper_energy_kinetic_up_to + (t96 - t100);
    /* limb3: geometry; velocities, eq. (6); energy */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      limb3_upper_vel_y = limb3_U_v_1 * limb3_upper_offset_x, limb3_P_v = READ(v, 8),
      t107 = limb3_upper_vel_y * (k7 * limb3_U_v_1 - limb_lower_m * limb3_upper_vel_y),
      t108 = limb3_P_v * (limb_lower_m * limb3_P_v) - t107,
      minus_limb3_upper_vel_z = limb3_upper_offset_x * limb3_lower_omega_y,
      t112 = minus_limb3_upper_vel_z * (k7 * limb3_lower_omega_y - limb_lower_m * minus_limb3_upper_vel_z),
      limb3_upper_energy_kinetic_up_to = limb2_upper_energy_kinetic_up_to + (t108 - t112),
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11), limb4_upper_vel_y = limb4_U_v_1 * limb4_upper_offset_x,
      limb4_P_v = READ(v, 11),
      t119 = limb4_upper_vel_y * (k7 * limb4_U_v_1 - limb_lower_m * limb4_upper_vel_y), /* limb4 */
      t120 = limb4_P_v * (limb_lower_m * limb4_P_v) - t119, /* limb4 */
      minus_limb4_upper_vel_z = limb4_upper_offset_x * limb4_lower_omega_y,
      t124 = minus_limb4_upper_vel_z * (k7 * limb4_lower_omega_y - limb_lower_m * minus_limb4_upper_vel_z); /* limb4 */
    /* kinetic: energy */
    const REAL kinetic_energy = 0.5 * (limb3_upper_energy_kinetic_up_to + (t120 - t124));
    WRITE(energy, 0, kinetic_energy);
    REAL checked0 = kinetic_energy;
    /* limb5_S: geometry; energy */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t142 = limb5_S_q_qw * limb5_S_q_qw,
      t143 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t144 = t142 + t143,
      t145 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t151 = t143 + t145,
      t148 = t144 + (t145 + limb5_S_q_qz * limb5_S_q_qz),
      t153 = gravity_z_platform_mz * (1.0 - (4.0 - 2.0 * t148) * t151),
      limb1_lower_rotation_zx = SINES(cosine, 0) * limb1_lower_cos,
      t139 = limb_lower_m * (limb1_upper_offset_x * limb1_lower_rotation_zx), /* limb1 */
      minus_limb2_lower_rotation_zx = SINES(cosine, 2) * limb2_lower_cos,
      t135 = limb_lower_m * (limb2_upper_offset_x * minus_limb2_lower_rotation_zx), /* limb2 */
      t154 = limb1_lower_rotation_zx - minus_limb2_lower_rotation_zx,
      t141 = gravity_z * (limb_lower_mx * limb1_lower_rotation_zx - t139), /* limb1 */
      t137 = gravity_z * (limb_lower_mx * minus_limb2_lower_rotation_zx - t135), /* limb2 */
      limb3_lower_rotation_zx = SINES(cosine, 4) * limb3_lower_cos, t155 = limb3_lower_rotation_zx + t154,
      t131 = limb_lower_m * (limb3_upper_offset_x * limb3_lower_rotation_zx), /* limb3 */
      t133 = gravity_z * (limb_lower_mx * limb3_lower_rotation_zx - t131), /* limb3 */
      minus_limb4_lower_rotation_zx = SINES(cosine, 6) * limb4_lower_cos,
      t161 = t133 - (t137 - (t141 - (t153 - gravity_z_limb_lower_mx * (minus_limb4_lower_rotation_zx - t155)))),
      t127 = limb_lower_m * (limb4_upper_offset_x * minus_limb4_lower_rotation_zx), /* limb4 */
      potential_energy = gravity_z * (limb_lower_mx * minus_limb4_lower_rotation_zx - t127) - t161;
    WRITE(energy, 1, potential_energy);
    REAL checked1 = potential_energy;
    /* else status 5: no rotation */
    NOT_BELOW(t148, 0.999999, 5);
    NOT_ABOVE(t148, 1.000001, 5);
    FINITE(checked0 + checked1);
}

BODY(three_ups_upu_s_mass_matrix)(size_t stride, const double *restrict q, double *restrict mass_matrix,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)sine;
    REAL checked0 = READ(q, 0);
    REAL checked1 = READ(q, 3);
    REAL checked2 = READ(q, 6);
    REAL checked3 = READ(q, 9);
    checked0 = checked0 + (READ(q, 12));
    checked1 = checked1 + (READ(q, 13));
    checked2 = checked2 + (READ(q, 14));
    checked3 = checked3 + (READ(q, 15));
    /* limb1: geometry; inertia */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      t3 = limb1_upper_offset_x * (k7 - limb_lower_m * limb1_upper_offset_x);
    RESULT(checked0, mass_matrix, 16, k9 - t3);
    const REAL limb1_lower_cos = SINES(cosine, 0);
    RESULT(checked1, mass_matrix, 0, k3 - limb1_lower_cos * (limb1_lower_cos * (t3 - k8)));
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      t9 = limb2_upper_offset_x * (k7 - limb_lower_m * limb2_upper_offset_x); /* limb2 */
    RESULT(checked2, mass_matrix, 64, k9 - t9);
    const REAL limb2_lower_cos = SINES(cosine, 1);
    RESULT(checked3, mass_matrix, 48, k3 - limb2_lower_cos * (limb2_lower_cos * (t9 - k8)));
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      t15 = limb3_upper_offset_x * (k7 - limb_lower_m * limb3_upper_offset_x); /* limb3 */
    RESULT(checked0, mass_matrix, 112, k9 - t15);
    const REAL limb3_lower_cos = SINES(cosine, 2);
    RESULT(checked1, mass_matrix, 96, k3 - limb3_lower_cos * (limb3_lower_cos * (t15 - k8)));
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      t21 = limb4_upper_offset_x * (k7 - limb_lower_m * limb4_upper_offset_x); /* limb4 */
    RESULT(checked2, mass_matrix, 160, k9 - t21);
    const REAL limb4_lower_cos = SINES(cosine, 3);
    RESULT(checked3, mass_matrix, 144, k3 - limb4_lower_cos * (limb4_lower_cos * (t21 - k8)));
    WRITE(mass_matrix, 32, CONSTANT(limb_lower_m));
    WRITE(mass_matrix, 80, CONSTANT(limb_lower_m));
    WRITE(mass_matrix, 128, CONSTANT(limb_lower_m));
    WRITE(mass_matrix, 176, CONSTANT(limb_lower_m));
    WRITE(mass_matrix, 192, CONSTANT(k13));
    WRITE(mass_matrix, 208, CONSTANT(k13));
    WRITE(mass_matrix, 224, CONSTANT(platform_Izz));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_bias)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), limb5_S_q_qy = READ(q, 14),
      limb5_S_q_qz = READ(q, 15), t80 = limb5_S_q_qw * limb5_S_q_qw + limb5_S_q_qx * limb5_S_q_qx,
      t84 = t80 + (limb5_S_q_qy * limb5_S_q_qy + limb5_S_q_qz * limb5_S_q_qz), t86 = 4.0 - 2.0 * t84,
      t87 = limb5_S_q_qz * t86, limb5_S_v_wz = READ(v, 14),
      platform_moment_y = gravity_z_platform_mz * (limb5_S_q_qx * t87 - limb5_S_q_qw * (limb5_S_q_qy * t86)),
      minus_platform_moment_x = gravity_z_platform_mz * (limb5_S_q_qy * t87 + limb5_S_q_qw * (limb5_S_q_qx * t86)),
      platform_rate_my = platform_moment_y - k12 * (READ(v, 12) * limb5_S_v_wz);
    WRITE(bias, 13, platform_rate_my);
    REAL checked0 = platform_rate_my;
    const REAL platform_rate_mx = k12 * (READ(v, 13) * limb5_S_v_wz) - minus_platform_moment_x;
    WRITE(bias, 12, platform_rate_mx);
    REAL checked1 = platform_rate_mx;
    /* limb4: velocities, eq. (6); accelerations; momentum rate, eq. (35) */
    const REAL limb4_U_v_0 = READ(v, 9), limb4_lower_cos = SINES(cosine, 7),
      limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos, limb4_U_v_1 = READ(v, 10),
      minus_limb4_lower_U_still_xx = limb4_lower_omega_y * limb4_lower_omega_y + limb4_U_v_1 * limb4_U_v_1,
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      minus_limb4_upper_acc_still_x = limb4_upper_offset_x * minus_limb4_lower_U_still_xx,
      minus_limb4_lower_rate_fx = limb_lower_mx * minus_limb4_lower_U_still_xx,
      minus_limb4_U_0_acc_y = gravity_z * SINES(cosine, 6),
      limb4_upper_rate_fx = minus_limb4_lower_rate_fx - limb_lower_m * (minus_limb4_upper_acc_still_x + limb4_lower_cos * minus_limb4_U_0_acc_y);
    WRITE(bias, 11, limb4_upper_rate_fx);
    REAL checked2 = limb4_upper_rate_fx;
    const REAL minus_limb4_lower_sin = SINES(sine, 7),
      minus_limb4_lower_acc_y = minus_limb4_lower_sin * minus_limb4_U_0_acc_y,
      minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin,
      minus_limb4_lower_U_still_xy = minus_limb4_lower_omega_x * limb4_lower_omega_y,
      limb4_lower_alpha_still_y = limb4_U_v_1 * minus_limb4_lower_omega_x, limb4_P_v = READ(v, 11),
      t72 = limb4_upper_offset_x * minus_limb4_lower_U_still_xy + minus_limb4_lower_acc_y,
      limb4_upper_moment_z = limb_lower_mx * minus_limb4_lower_acc_y,
      limb4_upper_acc_still_y = limb4_P_v * (2.0 * limb4_U_v_1) - t72,
      minus_limb4_upper_rate_mz = limb_lower_mx * limb4_upper_acc_still_y;
    /* limb4: balance, eqs. (40)-(47); geometry; accelerations */
    const REAL t73 = limb4_upper_offset_x * (limb_lower_mx * minus_limb4_lower_U_still_xy + limb_lower_m * limb4_upper_acc_still_y),
      limb4_lower_moment_z = -(k8 * minus_limb4_lower_U_still_xy + limb4_upper_moment_z + (minus_limb4_upper_rate_mz - t73));
    WRITE(bias, 10, limb4_lower_moment_z);
    REAL checked3 = limb4_lower_moment_z;
    const REAL minus_limb4_U_0_cos = SINES(sine, 6),
      t63 = limb4_upper_offset_x * (2.0 * limb4_lower_alpha_still_y) + gravity_z * minus_limb4_U_0_cos,
      minus_limb4_upper_acc_still_z = limb4_P_v * (2.0 * limb4_lower_omega_y) + t63,
      t59 = minus_limb4_lower_sin * (k10 * (limb4_U_v_1 * limb4_lower_omega_y)),
      minus_limb4_upper_rate_my = limb_lower_mx * minus_limb4_upper_acc_still_z,
      t64 = limb4_upper_offset_x * (k7 * limb4_lower_alpha_still_y - limb_lower_m * minus_limb4_upper_acc_still_z),
      t65 = minus_limb4_upper_rate_my + t64,
      t67 = limb4_lower_cos * (t65 - (gravity_z_limb_lower_mx * minus_limb4_U_0_cos + k11 * limb4_lower_alpha_still_y));
    RESULT(checked0, bias, 9, -(t59 + t67));
    /* limb3: velocities, eq. (6); geometry; accelerations */
    const REAL limb3_U_v_0 = READ(v, 6), limb3_lower_cos = SINES(cosine, 5),
      limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos, limb3_U_v_1 = READ(v, 7),
      minus_limb3_lower_U_still_xx = limb3_lower_omega_y * limb3_lower_omega_y + limb3_U_v_1 * limb3_U_v_1,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      minus_limb3_upper_acc_still_x = limb3_upper_offset_x * minus_limb3_lower_U_still_xx,
      minus_limb3_lower_rate_fx = limb_lower_mx * minus_limb3_lower_U_still_xx,
      limb3_U_0_acc_y = gravity_z * SINES(cosine, 4);
    RESULT(checked1, bias, 8, minus_limb3_lower_rate_fx - limb_lower_m * (minus_limb3_upper_acc_still_x - limb3_lower_cos * limb3_U_0_acc_y));
    const REAL minus_limb3_lower_sin = SINES(sine, 5), limb3_lower_acc_y = minus_limb3_lower_sin * limb3_U_0_acc_y,
      minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin,
      minus_limb3_lower_U_still_xy = minus_limb3_lower_omega_x * limb3_lower_omega_y,
      limb3_lower_alpha_still_y = limb3_U_v_1 * minus_limb3_lower_omega_x, limb3_P_v = READ(v, 8),
      t53 = limb3_upper_offset_x * minus_limb3_lower_U_still_xy - limb3_lower_acc_y,
      minus_limb3_upper_moment_z = limb_lower_mx * limb3_lower_acc_y,
      limb3_upper_acc_still_y = limb3_P_v * (2.0 * limb3_U_v_1) - t53,
      minus_limb3_upper_rate_mz = limb_lower_mx * limb3_upper_acc_still_y;
    /* limb3: balance, eqs. (40)-(47); geometry; accelerations */
    const REAL t54 = limb3_upper_offset_x * (limb_lower_mx * minus_limb3_lower_U_still_xy + limb_lower_m * limb3_upper_acc_still_y),
      t55 = minus_limb3_upper_rate_mz - t54;
    RESULT(checked2, bias, 7, -(k8 * minus_limb3_lower_U_still_xy - minus_limb3_upper_moment_z + t55));
    const REAL limb3_U_0_sin = SINES(sine, 4),
      t44 = limb3_upper_offset_x * (2.0 * limb3_lower_alpha_still_y) - gravity_z * limb3_U_0_sin,
      minus_limb3_upper_acc_still_z = limb3_P_v * (2.0 * limb3_lower_omega_y) + t44,
      t40 = minus_limb3_lower_sin * (k10 * (limb3_U_v_1 * limb3_lower_omega_y)),
      minus_limb3_upper_rate_my = limb_lower_mx * minus_limb3_upper_acc_still_z,
      t45 = limb3_upper_offset_x * (k7 * limb3_lower_alpha_still_y - limb_lower_m * minus_limb3_upper_acc_still_z),
      t46 = minus_limb3_upper_rate_my + t45,
      t48 = limb3_lower_cos * (t46 + (gravity_z_limb_lower_mx * limb3_U_0_sin - k11 * limb3_lower_alpha_still_y));
    RESULT(checked3, bias, 6, -(t40 + t48));
    /* limb2: geometry; accelerations; balance, eqs. (40)-(47) */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_lower_cos = SINES(cosine, 3),
      limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos, limb2_U_v_1 = READ(v, 4),
      minus_limb2_lower_U_still_xx = limb2_lower_omega_y * limb2_lower_omega_y + limb2_U_v_1 * limb2_U_v_1,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      minus_limb2_upper_acc_still_x = limb2_upper_offset_x * minus_limb2_lower_U_still_xx,
      minus_limb2_lower_rate_fx = limb_lower_mx * minus_limb2_lower_U_still_xx,
      minus_limb2_U_0_acc_y = gravity_z * SINES(cosine, 2);
    RESULT(checked0, bias, 5, minus_limb2_lower_rate_fx - limb_lower_m * (minus_limb2_upper_acc_still_x + limb2_lower_cos * minus_limb2_U_0_acc_y));
    const REAL limb2_lower_sin = SINES(sine, 3), limb2_lower_acc_y = limb2_lower_sin * minus_limb2_U_0_acc_y,
      limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin,
      limb2_lower_U_still_xy = limb2_lower_omega_x * limb2_lower_omega_y,
      minus_limb2_lower_alpha_still_y = limb2_U_v_1 * limb2_lower_omega_x, limb2_P_v = READ(v, 5),
      t34 = limb2_upper_offset_x * limb2_lower_U_still_xy + limb2_lower_acc_y,
      minus_limb2_upper_moment_z = limb_lower_mx * limb2_lower_acc_y,
      limb2_upper_acc_still_y = limb2_P_v * (2.0 * limb2_U_v_1) + t34,
      minus_limb2_upper_rate_mz = limb_lower_mx * limb2_upper_acc_still_y,
      t35 = limb2_upper_offset_x * (limb_lower_mx * limb2_lower_U_still_xy - limb_lower_m * limb2_upper_acc_still_y);
    RESULT(checked1, bias, 4, k8 * limb2_lower_U_still_xy + minus_limb2_upper_moment_z - (minus_limb2_upper_rate_mz + t35));
    const REAL minus_limb2_U_0_cos = SINES(sine, 2),
      t24 = limb2_upper_offset_x * (2.0 * minus_limb2_lower_alpha_still_y),
      minus_limb2_upper_acc_still_z = limb2_P_v * (2.0 * limb2_lower_omega_y) - (t24 - gravity_z * minus_limb2_U_0_cos),
      t21 = limb2_lower_sin * (k10 * (limb2_U_v_1 * limb2_lower_omega_y)),
      minus_limb2_upper_rate_my = limb_lower_mx * minus_limb2_upper_acc_still_z,
      t26 = limb2_upper_offset_x * (k7 * minus_limb2_lower_alpha_still_y + limb_lower_m * minus_limb2_upper_acc_still_z),
      t27 = minus_limb2_upper_rate_my - t26,
      minus_limb2_lower_moment_y = t27 - (gravity_z_limb_lower_mx * minus_limb2_U_0_cos - k11 * minus_limb2_lower_alpha_still_y);
    RESULT(checked2, bias, 3, t21 - limb2_lower_cos * minus_limb2_lower_moment_y);
    /* limb1: geometry; accelerations; balance, eqs. (40)-(47) */
    const REAL limb1_U_v_0 = READ(v, 0), limb1_lower_cos = SINES(cosine, 1),
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, limb1_U_v_1 = READ(v, 1),
      minus_limb1_lower_U_still_xx = limb1_lower_omega_y * limb1_lower_omega_y + limb1_U_v_1 * limb1_U_v_1,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      minus_limb1_upper_acc_still_x = limb1_upper_offset_x * minus_limb1_lower_U_still_xx,
      minus_limb1_lower_rate_fx = limb_lower_mx * minus_limb1_lower_U_still_xx,
      limb1_U_0_acc_y = gravity_z * SINES(cosine, 0);
    RESULT(checked3, bias, 2, minus_limb1_lower_rate_fx - limb_lower_m * (minus_limb1_upper_acc_still_x - limb1_lower_cos * limb1_U_0_acc_y));
    const REAL limb1_lower_sin = SINES(sine, 1), minus_limb1_lower_acc_y = limb1_lower_sin * limb1_U_0_acc_y,
      limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin,
      limb1_lower_U_still_xy = limb1_lower_omega_x * limb1_lower_omega_y,
      minus_limb1_lower_alpha_still_y = limb1_U_v_1 * limb1_lower_omega_x, limb1_P_v = READ(v, 2),
      t15 = limb1_upper_offset_x * limb1_lower_U_still_xy - minus_limb1_lower_acc_y,
      limb1_upper_moment_z = limb_lower_mx * minus_limb1_lower_acc_y,
      limb1_upper_acc_still_y = limb1_P_v * (2.0 * limb1_U_v_1) + t15,
      minus_limb1_upper_rate_mz = limb_lower_mx * limb1_upper_acc_still_y,
      t16 = limb1_upper_offset_x * (limb_lower_mx * limb1_lower_U_still_xy - limb_lower_m * limb1_upper_acc_still_y);
    RESULT(checked0, bias, 1, k8 * limb1_lower_U_still_xy - limb1_upper_moment_z - (minus_limb1_upper_rate_mz + t16));
    const REAL limb1_U_0_sin = SINES(sine, 0),
      t6 = limb1_upper_offset_x * (2.0 * minus_limb1_lower_alpha_still_y) + gravity_z * limb1_U_0_sin,
      minus_limb1_upper_acc_still_z = limb1_P_v * (2.0 * limb1_lower_omega_y) - t6,
      t2 = limb1_lower_sin * (k10 * (limb1_U_v_1 * limb1_lower_omega_y)),
      minus_limb1_upper_rate_my = limb_lower_mx * minus_limb1_upper_acc_still_z,
      t7 = limb1_upper_offset_x * (k7 * minus_limb1_lower_alpha_still_y + limb_lower_m * minus_limb1_upper_acc_still_z),
      t8 = minus_limb1_upper_rate_my - t7,
      t10 = limb1_lower_cos * (t8 + (gravity_z_limb_lower_mx * limb1_U_0_sin + k11 * minus_limb1_lower_alpha_still_y));
    RESULT(checked1, bias, 0, t2 - t10);
    WRITE(bias, 14, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t84, 0.999999, 5);
    NOT_ABOVE(t84, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

#if !defined(THREE_UPS_UPU_S_VECTORS)

int three_ups_upu_s_momentum_screws(const double *restrict q, const double *restrict v,
    double *restrict momenta, double *restrict total_)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_momentum_screws_body(1, q, v, momenta, total_, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(momenta, 54);
        three_ups_upu_s_set_nan(total_, 6);
    }
    return outcome;
}

int three_ups_upu_s_momentum_rates(const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict momentum_rates)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_momentum_rates_body(1, q, v, a, momentum_rates, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(momentum_rates, 54);
    }
    return outcome;
}

int three_ups_upu_s_energy(const double *restrict q, const double *restrict v, double *restrict energy)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_energy_body(1, q, v, energy, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(energy, 2);
    }
    return outcome;
}

int three_ups_upu_s_mass_matrix(const double *restrict q, double *restrict mass_matrix)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    three_ups_upu_s_sines3(q, sine, cosine);
    three_ups_upu_s_zero(mass_matrix + 1, 15);
    three_ups_upu_s_zero(mass_matrix + 17, 15);
    three_ups_upu_s_zero(mass_matrix + 33, 15);
    three_ups_upu_s_zero(mass_matrix + 49, 15);
    three_ups_upu_s_zero(mass_matrix + 65, 15);
    three_ups_upu_s_zero(mass_matrix + 81, 15);
    three_ups_upu_s_zero(mass_matrix + 97, 15);
    three_ups_upu_s_zero(mass_matrix + 113, 15);
    three_ups_upu_s_zero(mass_matrix + 129, 15);
    three_ups_upu_s_zero(mass_matrix + 145, 15);
    three_ups_upu_s_zero(mass_matrix + 161, 15);
    three_ups_upu_s_zero(mass_matrix + 177, 15);
    three_ups_upu_s_zero(mass_matrix + 193, 15);
    three_ups_upu_s_zero(mass_matrix + 209, 15);
    const int outcome = three_ups_upu_s_mass_matrix_body(1, q, mass_matrix, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(mass_matrix, 225);
    }
    return outcome;
}

int three_ups_upu_s_bias(const double *restrict q, const double *restrict v, double *restrict bias)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_bias_body(1, q, v, bias, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(bias, 15);
    }
    return outcome;
}
#endif /* THREE_UPS_UPU_S_VECTORS */
