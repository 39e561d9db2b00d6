/*
 * three_ups_upu_s: momentum.
 *   momentum_screws; momentum_rates; energy; mass_matrix; bias
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

typedef struct {
    EACH4 signed_lower_momentum_px, lower_momentum_py, signed_lower_momentum_pz, lower_momentum_Lx,
      signed_lower_momentum_Ly, signed_lower_momentum_Lz, signed_upper_momentum_px, upper_momentum_py,
      signed_upper_momentum_pz, upper_momentum_Lx, signed_upper_momentum_Ly, signed_upper_momentum_Lz;
} LIMBS(momentum_screws);

STAGE(momentum_screws, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    double *restrict momenta, const double *restrict sine, const double *restrict cosine,
    REAL signed_U_1_screw_vy, REAL signed_U_1_screw_vz, LIMBS(momentum_screws) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0), factor_2 = sign2 * 0.5,
      each_k1 = -sign2 * k1, factor_3 = -sign2 * 0.5, sign3 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: geometry */
    const LIMB4 minus_lower_rotation_yx = signed_U_0_sin * lower_cos, signed_lower_sin =
        IN_EACH4(SINES, sine, 1, 2);
    /* each limb: momentum, eq. (31); geometry; velocities, eq. (6) */
    const LIMB4 t11 = k1 * minus_lower_rotation_yx, signed_lower_rotation_yy = signed_U_0_sin * signed_lower_sin,
      t13 = t11 - factor_3 * signed_lower_rotation_yy, t14 = limb_lower_com_z * t13,
      t17 = 0.5 * minus_lower_rotation_yx + each_k1 * signed_lower_rotation_yy, t19 = t14 + k3 * t17,
      U_v_0 = IN_EACH4(READ, v, 0, 3), t36 = U_v_0 * t19, t28 = 0.5 * signed_lower_sin - each_k1 * lower_cos,
      t29 = k3 * t28, t30 = t29 + (-param_R), t24 = k1 * signed_lower_sin + factor_3 * lower_cos,
      t25 = limb_lower_com_z * t24, t31 = t25 + t30, t126 = t25 + t29, t146 = sign1 * IN_EACH4(READ, v, 1, 3),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_lower_twist_wy = t146 * U_0_cos,
      t38 = t36 + signed_lower_twist_wy * t31, signed_lower_twist_vz = t146 * signed_U_1_screw_vz;
    OWN(signed_lower_momentum_pz) = limb_lower_m * (signed_lower_twist_vz + t38);
    WRITE4(momenta, 8, 20, 32, 44, -sign2 * OWN(signed_lower_momentum_pz));
    const LIMB4 t60 = t19 * OWN(signed_lower_momentum_pz), t89 = t31 * OWN(signed_lower_momentum_pz),
      signed_lower_twist_wz = t146 * signed_U_0_sin, lower_twist_vy = t146 * signed_U_1_screw_vy,
      t32 = signed_lower_twist_wz * t31, signed_lower_rotation_zx = U_0_cos * lower_cos,
      t1 = k1 * signed_lower_rotation_zx, signed_lower_rotation_zy = U_0_cos * signed_lower_sin,
      t3 = t1 + factor_2 * signed_lower_rotation_zy, t4 = limb_lower_com_z * t3,
      t7 = 0.5 * signed_lower_rotation_zx + each_k1 * signed_lower_rotation_zy, t9 = t4 + k3 * t7;
    OWN(lower_momentum_py) = limb_lower_m * (lower_twist_vy + (t32 - U_v_0 * t9));
    WRITE4(momenta, 7, 18, 31, 42, OWN(lower_momentum_py));
    const LIMB4 t116 = t31 * OWN(lower_momentum_py), t62 = t60 - t9 * OWN(lower_momentum_py),
      t46 = limb_lower_Izz * t24 - limb_lower_Ixz * t28, t47 = t24 * t46,
      t42 = limb_lower_Ixz * t24 - limb_lower_Ixx * t28, t49 = U_v_0 * (t47 - t28 * t42),
      t54 = t49 + signed_lower_twist_wy * (t17 * t42 - t13 * t46),
      t59 = t54 + signed_lower_twist_wz * (t3 * t46 - t7 * t42);
    OWN(lower_momentum_Lx) = t59 + t62;
    WRITE4(momenta, 9, 22, 33, 46, OWN(lower_momentum_Lx));
    const LIMB4 t65 = limb_lower_Ixx * t17 - limb_lower_Ixz * t13, t73 = t17 * t65, t74 = limb_lower_Iyy * U_0_cos,
      t76 = t73 + U_0_cos * t74, t82 = signed_U_0_sin * t74, t69 = limb_lower_Ixz * t17 - limb_lower_Izz * t13,
      t79 = signed_lower_twist_wy * (t76 - t13 * t69), t80 = U_v_0 * (t28 * t65 - t24 * t69) - t79,
      t87 = t80 + signed_lower_twist_wz * (t7 * t65 - t82 - t3 * t69);
    OWN(signed_lower_momentum_px) = limb_lower_m * (signed_lower_twist_wy * t9 + signed_lower_twist_wz * t19);
    WRITE4(momenta, 6, 19, 30, 43, sign1 * OWN(signed_lower_momentum_px));
    OWN(signed_lower_momentum_Ly) = t87 - (t9 * OWN(signed_lower_momentum_px) + t89);
    WRITE4(momenta, 10, 21, 34, 45, -sign1 * OWN(signed_lower_momentum_Ly));
    const LIMB4 t118 = t116 + t19 * OWN(signed_lower_momentum_px), t93 = limb_lower_Ixx * t7 - limb_lower_Ixz * t3,
      t101 = t17 * t93, t94 = t28 * t93, t109 = t7 * t93, t95 = limb_lower_Ixz * t7,
      t102 = limb_lower_Iyy * signed_U_0_sin, t104 = t101 - U_0_cos * t102, t111 = t109 + signed_U_0_sin * t102,
      t97 = t95 - limb_lower_Izz * t3, t107 = signed_lower_twist_wy * (t104 - t13 * t97),
      t108 = U_v_0 * (t94 - t24 * t97) - t107, t115 = t108 + signed_lower_twist_wz * (t111 - t3 * t97);
    OWN(signed_lower_momentum_Lz) = t115 + t118;
    WRITE4(momenta, 11, 23, 35, 47, sign3 * OWN(signed_lower_momentum_Lz));
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      t121 = upper_offset_x * minus_lower_rotation_yx - t19, P_v = IN_EACH4(READ, v, 2, 3),
      minus_upper_twist_vy = P_v * minus_lower_rotation_yx - lower_twist_vy, t133 = U_v_0 * t121,
      t127 = signed_lower_sin * upper_offset_x + (-param_R) - t126,
      t119 = t9 - upper_offset_x * signed_lower_rotation_zx,
      t136 = signed_lower_twist_vz - P_v * signed_lower_rotation_zx + (t133 + signed_lower_twist_wy * t127);
    OWN(signed_upper_momentum_pz) = limb_lower_m * t136;
    WRITE4(momenta, 14, 26, 38, 50, -sign2 * OWN(signed_upper_momentum_pz));
    const LIMB4 t120 = signed_lower_twist_wy * t119, t137 = t121 * OWN(signed_upper_momentum_pz),
      t141 = t127 * OWN(signed_upper_momentum_pz);
    OWN(upper_momentum_py) = limb_lower_m * (signed_lower_twist_wz * t127 + U_v_0 * t119 - minus_upper_twist_vy);
    WRITE4(momenta, 13, 24, 37, 48, OWN(upper_momentum_py));
    const LIMB4 t123 = t120 - signed_lower_twist_wz * t121, t143 = t127 * OWN(upper_momentum_py);
    OWN(upper_momentum_Lx) = t59 + (t137 + t119 * OWN(upper_momentum_py));
    WRITE4(momenta, 15, 28, 39, 52, OWN(upper_momentum_Lx));
    OWN(signed_upper_momentum_px) = limb_lower_m * (P_v * signed_lower_sin - t123);
    WRITE4(momenta, 12, 25, 36, 49, sign1 * OWN(signed_upper_momentum_px));
    OWN(signed_upper_momentum_Ly) = t87 + (t119 * OWN(signed_upper_momentum_px) - t141);
    WRITE4(momenta, 16, 27, 40, 51, -sign1 * OWN(signed_upper_momentum_Ly));
    OWN(signed_upper_momentum_Lz) = t115 + (t143 + t121 * OWN(signed_upper_momentum_px));
    WRITE4(momenta, 17, 29, 41, 53, sign3 * OWN(signed_upper_momentum_Lz));
}

BODY(three_ups_upu_s_momentum_screws)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict momenta, double *restrict total_, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    LIMBS(momentum_screws) limbs;
    /* limb5_S: geometry; velocities, eq. (6); momentum, eq. (31) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t13 = t2 + t5, platform_turn_zz = 1.0 - t9 * (t2 + t4), platform_turn_xx = 1.0 - t6 * t9,
      platform_turn_yy = 1.0 - t9 * t13, t18 = limb5_S_q_qz * t9, t29 = limb5_S_q_qx * t18, t16 = limb5_S_q_qy * t9,
      t24 = limb5_S_q_qw * (limb5_S_q_qx * t9), t30 = limb5_S_q_qw * t16, t17 = limb5_S_q_qx * t16,
      platform_turn_zx = t29 - t30, platform_turn_xz = t29 + t30, limb5_S_v_wx = READ(v, 12),
      t31 = limb5_S_v_wx * platform_turn_zx, t22 = limb5_S_q_qy * t18, t19 = limb5_S_q_qw * t18,
      platform_turn_zy = t22 + t24, platform_turn_yz = t22 - t24, limb5_S_v_wy = READ(v, 13),
      limb5_S_v_wz = READ(v, 14),
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + (t31 + limb5_S_v_wy * platform_turn_zy),
      t36 = param_H * platform_turn_xz, t37 = t36 * platform_twist_wz, platform_turn_xy = t17 - t19,
      platform_turn_yx = t17 + t19, t41 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      platform_twist_wx = t41 + limb5_S_v_wz * platform_turn_xz;
    /* platform: momentum, eq. (31); velocities, eq. (6); results */
    const REAL t12 = param_H * platform_turn_zz, platform_momentum_py = platform_m * (t37 - t12 *
        platform_twist_wx);
    WRITE(momenta, 1, platform_momentum_py);
    const REAL t100 = t36 * platform_momentum_py,
      t21 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      platform_twist_wy = t21 + limb5_S_v_wz * platform_turn_yz, t26 = t12 * platform_twist_wy,
      t27 = param_H * platform_turn_yz, platform_momentum_px = platform_m * (t26 - t27 * platform_twist_wz);
    WRITE(momenta, 0, platform_momentum_px);
    const REAL t102 = t100 - t27 * platform_momentum_px, t103 = platform_Ixx * platform_turn_zx,
      t104 = platform_turn_xx * t103, t105 = platform_Ixx * platform_turn_zy, t107 = t104 + platform_turn_xy * t105,
      t108 = platform_Izz * platform_turn_zz, t111 = platform_twist_wx * (t107 + platform_turn_xz * t108),
      t121 = platform_turn_zx * t103 + platform_turn_zy * t105,
      t117 = platform_twist_wy * (platform_turn_yx * t103 + platform_turn_yy * t105 + platform_turn_yz * t108),
      platform_momentum_Lz = t102 + (t111 + t117 + platform_twist_wz * (t121 + platform_turn_zz * t108));
    WRITE(momenta, 5, platform_momentum_Lz);
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0);
    FIRST_LIMB(0, momentum_screws, 0, stride, q, v, momenta, sine, cosine, param_R * limb1_U_0_sin, param_R *
        limb1_U_0_cos, &limbs);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2),
      t162 = limbs.signed_upper_momentum_Lz[0] + (platform_momentum_Lz + limbs.signed_lower_momentum_Lz[0]);
    NEXT_LIMB(1, momentum_screws, 0, stride, q, v, momenta, sine, cosine, param_R * minus_limb2_U_0_cos, param_R *
        limb2_U_0_sin, &limbs);
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    /* platform: results; momentum, eq. (31) */
    const REAL t164 = t162 - limbs.signed_lower_momentum_Lz[1] - limbs.signed_upper_momentum_Lz[1];
    NEXT_LIMB(2, momentum_screws, 0, stride, q, v, momenta, sine, cosine, param_R * limb3_U_0_sin, param_R *
        limb3_U_0_cos, &limbs);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6),
      t166 = t164 - limbs.signed_lower_momentum_Lz[2] - limbs.signed_upper_momentum_Lz[2];
    NEXT_LIMB(3, momentum_screws, 0, stride, q, v, momenta, sine, cosine, param_R * minus_limb4_U_0_cos, param_R *
        limb4_U_0_sin, &limbs);
    const REAL Lz_total = t166 + limbs.signed_lower_momentum_Lz[3] + limbs.signed_upper_momentum_Lz[3];
    WRITE(total_, 5, Lz_total);
    REAL checked0 = Lz_total;
    const REAL t74 = t12 * platform_momentum_px, t49 = t12 * platform_momentum_py,
      t135 = limbs.signed_lower_momentum_px[1] + (limbs.upper_momentum_py[0] + (platform_momentum_py +
          limbs.lower_momentum_py[0])),
      t138 = limbs.upper_momentum_py[2] + (limbs.lower_momentum_py[2] + (limbs.signed_upper_momentum_px[1] + t135)),
      py_total = t138 - limbs.signed_lower_momentum_px[3] - limbs.signed_upper_momentum_px[3];
    WRITE(total_, 1, py_total);
    REAL checked1 = py_total;
    const REAL t127 = limbs.signed_upper_momentum_px[0] + (platform_momentum_px +
        limbs.signed_lower_momentum_px[0]),
      t130 = limbs.upper_momentum_py[1] + (limbs.lower_momentum_py[1] + t127) - limbs.signed_lower_momentum_px[2],
      px_total = t130 - limbs.signed_upper_momentum_px[2] + limbs.lower_momentum_py[3] + limbs.upper_momentum_py[3];
    WRITE(total_, 0, px_total);
    REAL checked2 = px_total;
    const REAL platform_momentum_pz = platform_m * (t27 * platform_twist_wx - t36 * platform_twist_wy);
    WRITE(momenta, 2, platform_momentum_pz);
    const REAL t76 = t74 - t36 * platform_momentum_pz, t50 = t27 * platform_momentum_pz - t49,
      t141 = limbs.signed_upper_momentum_pz[0] - (platform_momentum_pz - limbs.signed_lower_momentum_pz[0]),
      t144 = limbs.signed_upper_momentum_pz[1] + (limbs.signed_lower_momentum_pz[1] - t141) -
          limbs.signed_lower_momentum_pz[2],
      pz_total = t144 - limbs.signed_upper_momentum_pz[2] + limbs.signed_lower_momentum_pz[3] +
          limbs.signed_upper_momentum_pz[3];
    WRITE(total_, 2, pz_total);
    REAL checked3 = pz_total;
    /* platform: momentum, eq. (31); results */
    const REAL t77 = platform_Ixx * platform_turn_yx, t78 = platform_turn_xx * t77,
      t79 = platform_Ixx * platform_turn_yy, t81 = t78 + platform_turn_xy * t79,
      t82 = platform_Izz * platform_turn_yz, t85 = platform_twist_wx * (t81 + platform_turn_xz * t82),
      t95 = platform_turn_zx * t77 + platform_turn_zy * t79,
      t91 = platform_twist_wy * (platform_turn_yx * t77 + platform_turn_yy * t79 + platform_turn_yz * t82),
      platform_momentum_Ly = t76 + (t85 + t91 + platform_twist_wz * (t95 + platform_turn_zz * t82));
    WRITE(momenta, 4, platform_momentum_Ly);
    const REAL t155 = limbs.signed_upper_momentum_Ly[0] - (platform_momentum_Ly -
        limbs.signed_lower_momentum_Ly[0]),
      t158 = limbs.signed_lower_momentum_Ly[2] - (t155 - limbs.lower_momentum_Lx[1] - limbs.upper_momentum_Lx[1]);
    RESULT(checked0, total_, 4, limbs.upper_momentum_Lx[3] + (limbs.lower_momentum_Lx[3] +
        (limbs.signed_upper_momentum_Ly[2] + t158)));
    const REAL t53 = platform_Ixx * platform_turn_xy, t54 = platform_turn_xy * t53, t61 = platform_turn_yy * t53,
      t68 = platform_turn_zy * t53, t51 = platform_Ixx * platform_turn_xx, t55 = platform_turn_xx * t51 + t54,
      t62 = platform_turn_yx * t51 + t61, t69 = platform_turn_zx * t51 + t68, t56 = platform_Izz * platform_turn_xz,
      t59 = platform_twist_wx * (t55 + platform_turn_xz * t56),
      t66 = t59 + platform_twist_wy * (t62 + platform_turn_yz * t56),
      platform_momentum_Lx = t50 + (t66 + platform_twist_wz * (t69 + platform_turn_zz * t56));
    WRITE(momenta, 3, platform_momentum_Lx);
    const REAL t149 = limbs.upper_momentum_Lx[0] + (platform_momentum_Lx + limbs.lower_momentum_Lx[0]) -
        limbs.signed_lower_momentum_Ly[1],
      t152 = limbs.upper_momentum_Lx[2] + (limbs.lower_momentum_Lx[2] + (t149 - limbs.signed_upper_momentum_Ly[1]));
    RESULT(checked1, total_, 3, limbs.signed_upper_momentum_Ly[3] + (limbs.signed_lower_momentum_Ly[3] + t152));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

typedef struct {
    EACH4 checked;
} LIMBS(momentum_rates);

STAGE(momentum_rates, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict momentum_rates, const double *restrict sine,
    const double *restrict cosine, REAL signed_U_1_screw_vz, REAL signed_U_1_screw_vy,
    LIMBS(momentum_rates) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0), factor_2 = -sign2 * 0.5,
      each_k1 = -sign2 * k1, each_k1_2 = sign2 * k1, sign3 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: geometry; momentum rate, eq. (35) */
    const LIMB4 minus_lower_rotation_yx = signed_U_0_sin * lower_cos, signed_lower_sin =
        IN_EACH4(SINES, sine, 1, 2),
      t17 = k1 * minus_lower_rotation_yx, signed_lower_rotation_yy = signed_U_0_sin * signed_lower_sin,
      t19 = t17 - factor_2 * signed_lower_rotation_yy, t20 = limb_lower_com_z * t19,
      t23 = 0.5 * minus_lower_rotation_yx + each_k1 * signed_lower_rotation_yy, t25 = t20 + k3 * t23,
      t300 = sign1 * IN_EACH4(READ, v, 0, 3);
    /* each limb: momentum, eq. (31); velocities, eq. (6); momentum rate, eq. (35) */
    const LIMB4 t29 = t300 * t25, t36 = 0.5 * signed_lower_sin + each_k1_2 * lower_cos, t37 = k3 * t36,
      t38 = t37 + (-param_R), t32 = k1 * signed_lower_sin + factor_2 * lower_cos, t33 = limb_lower_com_z * t32,
      t39 = t33 + t38, U_v_1 = IN_EACH4(READ, v, 1, 3), U_0_cos = IN_EACH4(SINES, cosine, 0, 2), t212 = t33 + t37,
      lower_twist_wy = U_v_1 * U_0_cos, t41 = t29 + lower_twist_wy * t39,
      signed_lower_twist_vz = U_v_1 * signed_U_1_screw_vz,
      signed_lower_momentum_pz = limb_lower_m * (signed_lower_twist_vz + t41),
      t43 = lower_twist_wy * signed_lower_momentum_pz, signed_lower_twist_wz = U_v_1 * signed_U_0_sin,
      t44 = signed_lower_twist_wz * t39, signed_lower_rotation_zx = U_0_cos * lower_cos,
      t4 = k1 * signed_lower_rotation_zx, signed_lower_rotation_zy = U_0_cos * signed_lower_sin,
      t6 = t4 - factor_2 * signed_lower_rotation_zy, t7 = limb_lower_com_z * t6,
      t10 = 0.5 * signed_lower_rotation_zx + each_k1 * signed_lower_rotation_zy, t12 = t7 + k3 * t10,
      t46 = t44 - t300 * t12, signed_lower_twist_vy = U_v_1 * signed_U_1_screw_vy,
      signed_lower_momentum_py = limb_lower_m * (signed_lower_twist_vy + t46);
    /* each limb: momentum rate, eq. (35); accelerations; momentum, eq. (31) */
    const LIMB4 t49 = t43 + signed_lower_twist_wz * signed_lower_momentum_py, t3 = U_v_1 * (t300 * signed_U_0_sin),
      t299 = sign1 * IN_EACH4(READ, a, 1, 3), signed_lower_twist_rate_wy = t299 * U_0_cos - t3,
      t13 = signed_lower_twist_rate_wy * t12,
      signed_lower_twist_rate_wz = t299 * signed_U_0_sin + U_v_1 * (t300 * U_0_cos),
      t28 = limb_lower_m * (t13 + signed_lower_twist_rate_wz * t25), signed_lower_rate_at_O_fx = t49 - t28;
    WRITE4(momentum_rates, 6, 19, 30, 43, -sign1 * signed_lower_rate_at_O_fx);
    LIMB4 checked = signed_lower_rate_at_O_fx;
    const LIMB4 t62 = t300 * signed_lower_momentum_pz,
      lower_momentum_px = limb_lower_m * (lower_twist_wy * t12 + signed_lower_twist_wz * t25),
      U_a_0 = IN_EACH4(READ, a, 0, 3), t63 = signed_lower_twist_wz * lower_momentum_px + t62,
      t55 = signed_lower_twist_rate_wz * t39 - U_a_0 * t12,
      lower_twist_rate_vy = t299 * signed_U_1_screw_vy + U_v_1 * (t300 * signed_U_1_screw_vz),
      t57 = limb_lower_m * (lower_twist_rate_vy + t55), lower_rate_at_O_fy = t57 + t63;
    WRITE4(momentum_rates, 7, 18, 31, 42, lower_rate_at_O_fy);
    checked = checked + lower_rate_at_O_fy;
    const LIMB4 t66 = t300 * signed_lower_momentum_py - lower_twist_wy * lower_momentum_px,
      t72 = U_a_0 * t25 + signed_lower_twist_rate_wy * t39,
      signed_lower_twist_rate_vz = U_v_1 * (t300 * signed_U_1_screw_vy) - t299 * signed_U_1_screw_vz,
      t74 = (-limb_lower_m) * (signed_lower_twist_rate_vz - t72), signed_lower_rate_at_O_fz = t66 - t74;
    WRITE4(momentum_rates, 8, 20, 32, 44, sign2 * signed_lower_rate_at_O_fz);
    checked = checked + signed_lower_rate_at_O_fz;
    /* each limb: momentum, eq. (31); momentum rate, eq. (35) */
    const LIMB4 t77 = limb_lower_Ixz * t6 - limb_lower_Ixx * t10, t85 = t23 * t77,
      t86 = limb_lower_Iyy * signed_U_0_sin, t88 = t85 + U_0_cos * t86, t94 = signed_U_0_sin * t86,
      t81 = limb_lower_Ixz * t10 - limb_lower_Izz * t6, t90 = t88 + t19 * t81, t91 = lower_twist_wy * t90,
      t185 = signed_lower_twist_rate_wy * t90, t95 = t10 * t77 - t94, t83 = t36 * t77 + t32 * t81,
      t97 = t95 + t6 * t81, t186 = U_a_0 * t83 - t185, t99 = t91 - t300 * t83 - signed_lower_twist_wz * t97,
      t188 = t186 + signed_lower_twist_rate_wz * t97,
      signed_lower_momentum_Lz = t99 + (t39 * signed_lower_momentum_py + t25 * lower_momentum_px),
      t103 = lower_twist_wy * signed_lower_momentum_Lz, t171 = t300 * signed_lower_momentum_Lz,
      t106 = limb_lower_Ixx * t23 - limb_lower_Ixz * t19, t114 = t23 * t106, t115 = limb_lower_Iyy * U_0_cos,
      t117 = t114 + U_0_cos * t115, t123 = signed_U_0_sin * t115, t110 = limb_lower_Ixz * t23 - limb_lower_Izz *
          t19,
      t119 = t117 - t19 * t110, t120 = lower_twist_wy * t119, t176 = signed_lower_twist_rate_wy * t119,
      t124 = t10 * t106 - t123, t112 = t36 * t106 - t32 * t110, t126 = t124 - t6 * t110;
    /* each limb: momentum rate, eq. (35); momentum, eq. (31); accelerations */
    const LIMB4 t177 = U_a_0 * t112 - t176, t128 = t300 * t112 - t120 + signed_lower_twist_wz * t126,
      t179 = t177 + signed_lower_twist_rate_wz * t126,
      minus_lower_momentum_Ly = t128 - (t12 * lower_momentum_px + t39 * signed_lower_momentum_pz),
      t133 = t103 + signed_lower_twist_wz * minus_lower_momentum_Ly, t194 = t300 * minus_lower_momentum_Ly,
      t135 = signed_lower_twist_vz * signed_lower_momentum_py,
      t137 = t133 + (t135 - signed_lower_twist_vy * signed_lower_momentum_pz),
      t169 = t25 * signed_lower_momentum_pz - t12 * signed_lower_momentum_py, t181 = t39 * t74, t189 = t39 * t57,
      t160 = t25 * t74 - t12 * t57, t140 = limb_lower_Ixx * t36 - limb_lower_Ixz * t32, t148 = t23 * t140,
      t153 = t10 * t140, t141 = t36 * t140, t144 = limb_lower_Ixz * t36 - limb_lower_Izz * t32,
      t146 = t141 - t32 * t144, t150 = t148 - t19 * t144, t155 = t153 - t6 * t144,
      t164 = t300 * t146 - lower_twist_wy * t150,
      t157 = U_a_0 * t146 - signed_lower_twist_rate_wy * t150 + signed_lower_twist_rate_wz * t155,
      lower_rate_at_O_mx = t137 + (t157 + t160);
    WRITE4(momentum_rates, 9, 22, 33, 46, lower_rate_at_O_mx);
    checked = checked + lower_rate_at_O_mx;
    const LIMB4 t166 = t164 + signed_lower_twist_wz * t155, signed_lower_momentum_Lx = t166 + t169,
      t172 = signed_lower_twist_wz * signed_lower_momentum_Lx - t171,
      t197 = signed_lower_twist_vy * lower_momentum_px + (t194 + lower_twist_wy * signed_lower_momentum_Lx),
      signed_lower_rate_at_O_my = t172 - signed_lower_twist_vz * lower_momentum_px - (t179 - (t12 * t28 + t181));
    WRITE4(momentum_rates, 10, 21, 34, 45, sign1 * signed_lower_rate_at_O_my);
    checked = checked + signed_lower_rate_at_O_my;
    const LIMB4 signed_lower_rate_at_O_mz = t188 - (t189 + t25 * t28) + t197;
    WRITE4(momentum_rates, 11, 23, 35, 47, -sign3 * signed_lower_rate_at_O_mz);
    checked = checked + signed_lower_rate_at_O_mz;
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      t205 = upper_offset_x * minus_lower_rotation_yx - t25, t211 = t300 * t205,
      t213 = signed_lower_sin * upper_offset_x + (-param_R) - t212,
      t203 = upper_offset_x * signed_lower_rotation_zx - t12, t215 = t211 + lower_twist_wy * t213,
      t301 = sign1 * IN_EACH4(READ, v, 2, 3),
      signed_upper_twist_vz = signed_lower_twist_vz - t301 * signed_lower_rotation_zx,
      signed_upper_momentum_pz = limb_lower_m * (signed_upper_twist_vz + t215),
      t217 = lower_twist_wy * signed_upper_momentum_pz, t221 = signed_lower_twist_wz * t213 - t300 * t203,
      signed_upper_twist_vy = signed_lower_twist_vy - t301 * minus_lower_rotation_yx,
      signed_upper_momentum_py = limb_lower_m * (signed_upper_twist_vy + t221), P_a = IN_EACH4(READ, a, 2, 3),
      t224 = t217 + signed_lower_twist_wz * signed_upper_momentum_py, t253 = signed_lower_twist_rate_wy * t213,
      t207 = signed_lower_twist_rate_wy * t203 + signed_lower_twist_rate_wz * t205,
      t231 = signed_lower_twist_rate_wz * t213,
      t202 = t301 * (signed_lower_rotation_zx * lower_twist_wy + minus_lower_rotation_yx * signed_lower_twist_wz),
      t209 = limb_lower_m * (P_a * signed_lower_sin + t202 + t207), signed_upper_rate_at_O_fx = t209 - t224;
    WRITE4(momentum_rates, 12, 25, 36, 49, sign1 * signed_upper_rate_at_O_fx);
    checked = checked + signed_upper_rate_at_O_fx;
    const LIMB4 t238 = lower_twist_wy * t203 + signed_lower_twist_wz * t205,
      upper_twist_vx = t301 * signed_lower_sin, upper_momentum_px = limb_lower_m * (upper_twist_vx + t238),
      t242 = signed_lower_twist_wz * upper_momentum_px + t300 * signed_upper_momentum_pz, t233 = U_a_0 * t203 -
          t231,
      t226 = P_a * minus_lower_rotation_yx - lower_twist_rate_vy, t248 = t300 * minus_lower_rotation_yx,
      t234 = t233 - (t301 * (signed_lower_sin * signed_lower_twist_wz - t300 * signed_lower_rotation_zx) - t226),
      t235 = limb_lower_m * t234, upper_rate_at_O_fy = t242 - t235;
    WRITE4(momentum_rates, 13, 24, 37, 48, upper_rate_at_O_fy);
    checked = checked + upper_rate_at_O_fy;
    const LIMB4 t247 = signed_lower_twist_rate_vz + P_a * signed_lower_rotation_zx,
      t245 = t300 * signed_upper_momentum_py - lower_twist_wy * upper_momentum_px, t254 = U_a_0 * t205 + t253,
      t256 = limb_lower_m * (t247 - t301 * (t248 + signed_lower_sin * lower_twist_wy) - t254),
      signed_upper_rate_at_O_fz = t245 + t256;
    WRITE4(momentum_rates, 14, 26, 38, 50, sign2 * signed_upper_rate_at_O_fz);
    checked = checked + signed_upper_rate_at_O_fz;
    const LIMB4 signed_upper_momentum_Lz = t99 + (t213 * signed_upper_momentum_py + t205 * upper_momentum_px),
      t260 = lower_twist_wy * signed_upper_momentum_Lz, t278 = t300 * signed_upper_momentum_Lz,
      minus_upper_momentum_Ly = t128 - (t203 * upper_momentum_px + t213 * signed_upper_momentum_pz),
      t292 = t300 * minus_upper_momentum_Ly, t265 = t260 + signed_lower_twist_wz * minus_upper_momentum_Ly,
      t266 = signed_upper_twist_vy * signed_upper_momentum_pz, t296 = signed_upper_twist_vy * upper_momentum_px,
      t280 = signed_upper_twist_vz * upper_momentum_px,
      t269 = t266 - signed_upper_twist_vz * signed_upper_momentum_py - t265, t288 = t213 * t235, t285 = t213 * t256,
      upper_rate_at_O_mx = t157 + (t203 * t235 - t205 * t256) - t269;
    WRITE4(momentum_rates, 15, 28, 39, 52, upper_rate_at_O_mx);
    checked = checked + upper_rate_at_O_mx;
    const LIMB4 t282 = t280 - upper_twist_vx * signed_upper_momentum_pz,
      t297 = upper_twist_vx * signed_upper_momentum_py - t296,
      signed_upper_momentum_Lx = t166 + (t205 * signed_upper_momentum_pz - t203 * signed_upper_momentum_py),
      t283 = signed_lower_twist_wz * signed_upper_momentum_Lx - t278 - t282,
      t298 = t292 + lower_twist_wy * signed_upper_momentum_Lx - t297,
      signed_upper_rate_at_O_my = t283 - (t179 - (t203 * t209 - t285));
    WRITE4(momentum_rates, 16, 27, 40, 51, sign1 * signed_upper_rate_at_O_my);
    checked = checked + signed_upper_rate_at_O_my;
    const LIMB4 signed_upper_rate_at_O_mz = t188 + (t288 - t205 * t209) + t298;
    WRITE4(momentum_rates, 17, 29, 41, 53, -sign3 * signed_upper_rate_at_O_mz);
    checked = checked + signed_upper_rate_at_O_mz;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_momentum_rates)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict momentum_rates, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    LIMBS(momentum_rates) limbs;
    /* platform: geometry; velocities, eq. (6); momentum, eq. (31) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      platform_turn_xx = 1.0 - t6 * t9, t36 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5),
      platform_turn_zz = 1.0 - t9 * t36, t13 = limb5_S_q_qy * t9, t14 = limb5_S_q_qx * t13, t29 = limb5_S_q_qw *
          t13,
      t15 = limb5_S_q_qz * t9, t21 = limb5_S_q_qw * (limb5_S_q_qx * t9), t16 = limb5_S_q_qw * t15,
      platform_turn_xy = t14 - t16, platform_turn_yx = t14 + t16, limb5_S_v_wy = READ(v, 13),
      limb5_S_v_wx = READ(v, 12), t27 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      t28 = limb5_S_q_qx * t15, t19 = limb5_S_q_qy * t15, platform_turn_xz = t28 + t29, platform_turn_zx = t28 -
          t29,
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
      t116 = platform_Izz * platform_turn_yz, t118 = t115 + platform_turn_xz * t116, t119 = platform_twist_wx *
          t118;
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
      platform_rate_at_O_mx = t135 + (t138 + (t147 + platform_twist_rate_wy * t152 + platform_twist_rate_wz *
          t159));
    WRITE(momentum_rates, 3, platform_rate_at_O_mx);
    REAL checked3 = platform_rate_at_O_mx;
    const REAL platform_momentum_Lx = t165 + (t166 + platform_twist_wy * t152 + platform_twist_wz * t159);
    RESULT(checked0, momentum_rates, 4, platform_twist_wz * platform_momentum_Lx - t172 + t182);
    RESULT(checked1, momentum_rates, 5, t183 - platform_twist_wy * platform_momentum_Lx + t194);
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0);
    FIRST_LIMB(0, momentum_rates, 0, stride, q, v, a, momentum_rates, sine, cosine, param_R * limb1_U_0_cos, param_R
        * limb1_U_0_sin, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[0]);
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2);
    NEXT_LIMB(1, momentum_rates, 0, stride, q, v, a, momentum_rates, sine, cosine, param_R * limb2_U_0_sin, param_R
        * minus_limb2_U_0_cos, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[1]);
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_0_sin = SINES(sine, 4);
    NEXT_LIMB(2, momentum_rates, 0, stride, q, v, a, momentum_rates, sine, cosine, param_R * limb3_U_0_cos, param_R
        * limb3_U_0_sin, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[2]);
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    NEXT_LIMB(3, momentum_rates, 0, stride, q, v, a, momentum_rates, sine, cosine, param_R * limb4_U_0_sin, param_R
        * minus_limb4_U_0_cos, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}

typedef struct {
    EACH4 minus_U_0_U_still_xx, t1, t2, t3, t4, t5, t6, t7, signed_lower_rotation_zx, t8;
} LIMBS(energy);

STAGE(energy, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict sine, const double *restrict cosine, LIMBS(energy) *own)
{
    (void)limb, (void)stride;
    const LIMB4 P_v = IN_EACH4(READ, v, 2, 3);
    /* each limb: energy; accelerations; velocities, eq. (6) */
    OWN(t7) = P_v * P_v;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3);
    OWN(minus_U_0_U_still_xx) = U_v_0 * U_v_0;
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      lower_cos = IN_EACH4(SINES, cosine, 0, 1), t7 = limb_lower_m * upper_offset_x + (-limb_lower_mx);
    OWN(signed_lower_rotation_zx) = IN_EACH4(SINES, cosine, 4, 1) * lower_cos;
    OWN(t8) = OWN(signed_lower_rotation_zx) * t7;
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3), upper_vel_y = U_v_1 * upper_offset_x;
    OWN(t6) = upper_vel_y * (limb_lower_m * upper_vel_y - k8 * U_v_1);
    const LIMB4 lower_omega_y = U_v_0 * lower_cos, minus_upper_vel_z = upper_offset_x * lower_omega_y;
    OWN(t5) = minus_upper_vel_z * (limb_lower_m * minus_upper_vel_z - k8 * lower_omega_y);
    OWN(t3) = lower_omega_y * lower_omega_y;
    const LIMB4 signed_lower_omega_x = U_v_0 * IN_EACH4(SINES, sine, 0, 1);
    OWN(t1) = signed_lower_omega_x * signed_lower_omega_x;
    const LIMB4 minus_lower_U_still_zz = OWN(t1) + OWN(t3);
    OWN(t2) = U_v_1 * U_v_1;
    OWN(t4) = OWN(t2) + minus_lower_U_still_zz;
}

BODY(three_ups_upu_s_energy)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict energy, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    LIMBS(energy) limbs;
    /* limb5_S: geometry; energy */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t50 = limb5_S_q_qw * limb5_S_q_qw,
      t51 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t52 = t50 + t51,
      t53 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t59 = t51 + t53,
      t56 = t52 + (t53 + limb5_S_q_qz * limb5_S_q_qz), t61 = gravity_z_platform_mz * (1.0 - (4.0 - 2.0 * t56) *
          t59);
    FIRST_LIMB(0, energy, 0, stride, q, v, sine, cosine, &limbs);
    NEXT_LIMB(1, energy, 0, stride, q, v, sine, cosine, &limbs);
    const REAL t62 = limbs.signed_lower_rotation_zx[0] - limbs.signed_lower_rotation_zx[1];
    NEXT_LIMB(2, energy, 0, stride, q, v, sine, cosine, &limbs);
    const REAL t63 = limbs.signed_lower_rotation_zx[2] + t62;
    NEXT_LIMB(3, energy, 0, stride, q, v, sine, cosine, &limbs);
    const REAL t66 = t61 - gravity_z_limb_lower_mx * (limbs.signed_lower_rotation_zx[3] - t63),
      potential_energy = t66 - gravity_z * (limbs.t8[3] + (limbs.t8[1] - limbs.t8[0] - limbs.t8[2]));
    WRITE(energy, 1, potential_energy);
    REAL checked0 = potential_energy;
    /* limb4: energy */
    const REAL t10 = limbs.t4[3] - (limbs.t1[2] - (limbs.t4[2] - (limbs.t1[1] - (limbs.t4[1] - (limbs.t1[0] -
        limbs.t4[0]))))),
      t12 = k5 * (limbs.t1[3] - t10),
      t18 = limbs.t3[3] - (limbs.t2[2] - (limbs.t3[2] - (limbs.t2[1] - (limbs.t3[1] + (limbs.t3[0] -
          limbs.t2[0]))))),
      t21 = t12 - k6 * (limbs.t2[3] - t18),
      t2 = limbs.minus_U_0_U_still_xx[2] + (limbs.minus_U_0_U_still_xx[0] + limbs.minus_U_0_U_still_xx[1]),
      limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13), t22 = k4 * (limbs.minus_U_0_U_still_xx[3] + t2) - t21,
      minus_platform_U_still_zz = limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy,
      limb5_S_v_wz = READ(v, 14), t27 = k7 * (limb5_S_v_wz * limb5_S_v_wz + minus_platform_U_still_zz),
      t32 = t27 - (limb5_S_v_wz * (platform_szz * limb5_S_v_wz) + platform_sxx * minus_platform_U_still_zz),
      t33 = t22 + t32,
      t39 = limbs.t5[0] + (limbs.t6[0] + limb_lower_m * (limbs.t7[0] + limbs.t7[1] + limbs.t7[2] + limbs.t7[3])),
      t44 = t33 + t39 + (limbs.t6[1] + limbs.t5[1]) + (limbs.t6[2] + limbs.t5[2]),
      kinetic_energy = 0.5 * (t44 + (limbs.t6[3] + limbs.t5[3]));
    WRITE(energy, 0, kinetic_energy);
    REAL checked1 = kinetic_energy;
    /* else status 5: no rotation */
    NOT_BELOW(t56, 0.999999, 5);
    NOT_ABOVE(t56, 1.000001, 5);
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
      t3 = limb1_upper_offset_x * (k8 - limb_lower_m * limb1_upper_offset_x);
    RESULT(checked0, mass_matrix, 16, k10 - t3);
    const REAL limb1_lower_cos = SINES(cosine, 0);
    RESULT(checked1, mass_matrix, 0, k4 - limb1_lower_cos * (limb1_lower_cos * (t3 - k9)));
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      t9 = limb2_upper_offset_x * (k8 - limb_lower_m * limb2_upper_offset_x); /* limb2 */
    RESULT(checked2, mass_matrix, 64, k10 - t9);
    const REAL limb2_lower_cos = SINES(cosine, 1);
    RESULT(checked3, mass_matrix, 48, k4 - limb2_lower_cos * (limb2_lower_cos * (t9 - k9)));
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      t15 = limb3_upper_offset_x * (k8 - limb_lower_m * limb3_upper_offset_x); /* limb3 */
    RESULT(checked0, mass_matrix, 112, k10 - t15);
    const REAL limb3_lower_cos = SINES(cosine, 2);
    RESULT(checked1, mass_matrix, 96, k4 - limb3_lower_cos * (limb3_lower_cos * (t15 - k9)));
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      t21 = limb4_upper_offset_x * (k8 - limb_lower_m * limb4_upper_offset_x); /* limb4 */
    RESULT(checked2, mass_matrix, 160, k10 - t21);
    const REAL limb4_lower_cos = SINES(cosine, 3);
    RESULT(checked3, mass_matrix, 144, k4 - limb4_lower_cos * (limb4_lower_cos * (t21 - k9)));
    WRITE(mass_matrix, 32, CONSTANT(limb_lower_m));
    WRITE(mass_matrix, 80, CONSTANT(limb_lower_m));
    WRITE(mass_matrix, 128, CONSTANT(limb_lower_m));
    WRITE(mass_matrix, 176, CONSTANT(limb_lower_m));
    WRITE(mass_matrix, 192, CONSTANT(k14));
    WRITE(mass_matrix, 208, CONSTANT(k14));
    WRITE(mass_matrix, 224, CONSTANT(platform_Izz));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

typedef struct {
    EACH4 checked;
} LIMBS(bias);

STAGE(bias, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, LIMBS(bias) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, -1.0, -1.0, -1.0), each_k11 = sign3 * k11, sign4 = OF4(1.0, 1.0, 1.0, -1.0),
      each_gravity_z = -sign2 * gravity_z;
    const LIMB4 t22 = sign1 * IN_EACH4(SINES, cosine, 1, 2), U_v_0 = IN_EACH4(READ, v, 0, 3),
      t24 = sign2 * (U_v_0 * t22), P_v = IN_EACH4(READ, v, 2, 3), U_v_1 = IN_EACH4(READ, v, 1, 3),
      t25 = sign2 * (P_v * t24), t23 = sign2 * U_v_1, signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const LIMB4 signed_lower_omega_x = U_v_0 * signed_lower_sin,
      signed_lower_alpha_still_y = t23 * signed_lower_omega_x, lower_U_still_xy = signed_lower_omega_x * t24,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      signed_upper_acc_still_z = gravity_z * signed_U_0_sin - 2.0 * (t25 - upper_offset_x *
          signed_lower_alpha_still_y),
      signed_upper_rate_my = limb_lower_mx * signed_upper_acc_still_z,
      t9 = signed_upper_rate_my + upper_offset_x * (k8 * signed_lower_alpha_still_y - limb_lower_m *
          signed_upper_acc_still_z),
      t10 = t22 * (gravity_z_limb_lower_mx * signed_U_0_sin + k12 * signed_lower_alpha_still_y - t9),
      U_0_moment_z = sign4 * (signed_lower_sin * (each_k11 * (t23 * t24))) - t10;
    WRITE4(bias, 0, 3, 6, 9, U_0_moment_z);
    LIMB4 checked = U_0_moment_z;
    const LIMB4 minus_lower_U_still_xx = t24 * t24 + t23 * t23, t14 = upper_offset_x * lower_U_still_xy,
      signed_U_0_acc_y = each_gravity_z * IN_EACH4(SINES, cosine, 0, 2), signed_lower_acc_x = t22 *
          signed_U_0_acc_y,
      lower_acc_y = signed_lower_sin * signed_U_0_acc_y, t27 = sign2 * signed_lower_acc_x,
      upper_acc_still_y = P_v * (2.0 * U_v_1) + (t14 + lower_acc_y),
      t18 = k9 * lower_U_still_xy + limb_lower_mx * (lower_acc_y - upper_acc_still_y),
      lower_moment_z = t18 + upper_offset_x * (limb_lower_m * upper_acc_still_y - limb_lower_mx * lower_U_still_xy);
    WRITE4(bias, 1, 4, 7, 10, lower_moment_z);
    checked = checked + lower_moment_z;
    const LIMB4 minus_lower_force_x = limb_lower_m * (upper_offset_x * minus_lower_U_still_xx + t27),
      upper_rate_fx = limb_lower_mx * minus_lower_U_still_xx - minus_lower_force_x;
    WRITE4(bias, 2, 5, 8, 11, upper_rate_fx);
    checked = checked + upper_rate_fx;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_bias)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(bias) limbs;
    FIRST_LIMB(0, bias, 0, stride, q, v, bias, sine, cosine, &limbs);
    REAL checked0 = ALONE(limbs.checked[0]);
    NEXT_LIMB(1, bias, 0, stride, q, v, bias, sine, cosine, &limbs);
    REAL checked1 = ALONE(limbs.checked[1]);
    NEXT_LIMB(2, bias, 0, stride, q, v, bias, sine, cosine, &limbs);
    REAL checked2 = ALONE(limbs.checked[2]);
    NEXT_LIMB(3, bias, 0, stride, q, v, bias, sine, cosine, &limbs);
    REAL checked3 = ALONE(limbs.checked[3]);
    /* limb5_S: geometry; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), limb5_S_q_qy = READ(q, 14),
      limb5_S_q_qz = READ(q, 15), t4 = limb5_S_q_qw * limb5_S_q_qw + limb5_S_q_qx * limb5_S_q_qx,
      t8 = t4 + (limb5_S_q_qy * limb5_S_q_qy + limb5_S_q_qz * limb5_S_q_qz), t10 = 4.0 - 2.0 * t8,
      t11 = limb5_S_q_qz * t10, limb5_S_v_wz = READ(v, 14),
      minus_platform_moment_x = gravity_z_platform_mz * (limb5_S_q_qy * t11 + limb5_S_q_qw * (limb5_S_q_qx * t10)),
      platform_moment_y = gravity_z_platform_mz * (limb5_S_q_qx * t11 - limb5_S_q_qw * (limb5_S_q_qy * t10));
    RESULT(checked0, bias, 12, k13 * (READ(v, 13) * limb5_S_v_wz) - minus_platform_moment_x);
    RESULT(checked1, bias, 13, platform_moment_y - k13 * (READ(v, 12) * limb5_S_v_wz));
    WRITE(bias, 14, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
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
    three_ups_upu_s_sines3(q, sine, cosine);
    const int outcome = three_ups_upu_s_energy_body(1, q, v, energy, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(energy, 2);
    }
    return outcome;
}

int three_ups_upu_s_mass_matrix(const double *restrict q, double *restrict mass_matrix)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    three_ups_upu_s_sines5(q, sine, cosine);
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
