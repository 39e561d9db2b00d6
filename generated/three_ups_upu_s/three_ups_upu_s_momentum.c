/*
 * three_ups_upu_s: momentum.
 *   momentum_screws; momentum_rates; energy; mass_matrix; bias
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

typedef struct {
    EACH4 lower_momentum_px, lower_momentum_py, lower_momentum_pz, lower_momentum_Lx, lower_momentum_Ly,
      signed_lower_momentum_Lz, signed_upper_momentum_px, upper_momentum_py, signed_upper_momentum_pz,
      upper_momentum_Lx, upper_momentum_Ly, signed_upper_momentum_Lz;
} LIMBS(momentum_screws);

STAGE(momentum_screws, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    double *restrict momenta, const double *restrict sine, const double *restrict cosine,
    REAL signed_U_1_screw_vy, REAL signed_U_1_screw_vz, LIMBS(momentum_screws) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0), each_k1 = -sign2 * k1,
      factor_2 = sign2 * 0.5, factor_3 = -sign2 * 0.5, each_limb_lower_m = sign1 * limb_lower_m,
      each_limb_lower_m_2 = -sign2 * limb_lower_m, sign3 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: geometry */
    const LIMB4 signed_lower_rotation_zx = U_0_cos * lower_cos, signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: momentum, eq. (31); geometry; velocities, eq. (6) */
    const LIMB4 t1 = 0.5 * signed_lower_rotation_zx, signed_lower_rotation_zy = U_0_cos * signed_lower_sin,
      t3 = t1 + each_k1 * signed_lower_rotation_zy, t125 = 0.5 * t3,
      t8 = k1 * signed_lower_rotation_zx + factor_2 * signed_lower_rotation_zy, t127 = t125 - param_H * t8,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase, P_v = IN_EACH4(READ, v, 2, 3),
      t128 = upper_offset_x * signed_lower_rotation_zx + t127, t158 = P_v * signed_lower_rotation_zx,
      t132 = t128 - (limb_upper_com_x * t3 - limb_upper_com_z * t8), U_v_0 = IN_EACH4(READ, v, 0, 3),
      t155 = U_v_0 * t132, t28 = 0.5 * signed_lower_sin - each_k1 * lower_cos, t146 = 0.5 * t28,
      t34 = k1 * signed_lower_sin + factor_3 * lower_cos,
      t149 = signed_lower_sin * upper_offset_x + (-param_R) + (t146 - param_H * t34),
      t153 = t149 - (limb_upper_com_x * t28 - limb_upper_com_z * t34), t172 = sign1 * IN_EACH4(READ, v, 1, 3),
      signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), signed_lower_twist_wz = t172 * signed_U_0_sin,
      t156 = signed_lower_twist_wz * t153 - t155, lower_twist_vy = t172 * signed_U_1_screw_vy,
      minus_lower_rotation_yx = signed_U_0_sin * lower_cos,
      minus_upper_position_y = upper_offset_x * minus_lower_rotation_yx;
    OWN(upper_momentum_py) = limb_lower_m * (lower_twist_vy - P_v * minus_lower_rotation_yx + t156);
    WRITE4(momenta, 13, 24, 37, 48, OWN(upper_momentum_py));
    const LIMB4 t169 = t153 * OWN(upper_momentum_py), t164 = t132 * OWN(upper_momentum_py),
      signed_lower_twist_wy = t172 * U_0_cos, signed_lower_twist_vz = t172 * signed_U_1_screw_vz,
      signed_upper_twist_vz = signed_lower_twist_vz - t158, t133 = signed_lower_twist_wy * t132,
      t13 = 0.5 * minus_lower_rotation_yx, t18 = k1 * minus_lower_rotation_yx,
      signed_lower_rotation_yy = signed_U_0_sin * signed_lower_sin, t15 = t13 + each_k1 * signed_lower_rotation_yy,
      t20 = t18 - factor_3 * signed_lower_rotation_yy, t137 = minus_upper_position_y + (0.5 * t15 - param_H * t20),
      t141 = t137 - (limb_upper_com_x * t15 - limb_upper_com_z * t20);
    OWN(signed_upper_momentum_px) = limb_lower_m * (P_v * signed_lower_sin + (t133 + signed_lower_twist_wz * t141));
    WRITE4(momenta, 12, 25, 36, 49, sign1 * OWN(signed_upper_momentum_px));
    const LIMB4 t171 = t169 + t141 * OWN(signed_upper_momentum_px),
      t178 = sign1 * (t132 * OWN(signed_upper_momentum_px)), t102 = limb_lower_Ixx * t3 - limb_lower_Ixz * t8,
      t110 = t15 * t102, t111 = limb_lower_Iyy * signed_U_0_sin, t113 = t110 - U_0_cos * t111,
      t119 = signed_U_0_sin * t111, t106 = limb_lower_Ixz * t3 - limb_lower_Izz * t8,
      t116 = signed_lower_twist_wy * (t113 - t20 * t106), t117 = U_v_0 * (t28 * t102 - t34 * t106) - t116,
      t124 = t117 + signed_lower_twist_wz * (t3 * t102 + t119 - t8 * t106);
    OWN(signed_upper_momentum_Lz) = t124 + t171;
    WRITE4(momenta, 17, 29, 41, 53, sign3 * OWN(signed_upper_momentum_Lz));
    OWN(signed_upper_momentum_pz) = each_limb_lower_m * (signed_upper_twist_vz + (U_v_0 * t141 +
        signed_lower_twist_wy * t153));
    WRITE4(momenta, 14, 26, 38, 50, -sign3 * OWN(signed_upper_momentum_pz));
    const LIMB4 t168 = t178 + t153 * OWN(signed_upper_momentum_pz),
      t165 = t164 - sign1 * (t141 * OWN(signed_upper_momentum_pz)), t74 = limb_lower_Ixx * t15 - limb_lower_Ixz *
          t20,
      t82 = t15 * t74, t83 = limb_lower_Iyy * U_0_cos, t85 = t82 + U_0_cos * t83, t91 = signed_U_0_sin * t83,
      t78 = limb_lower_Ixz * t15 - limb_lower_Izz * t20, t88 = signed_lower_twist_wy * (t85 - t20 * t78),
      t89 = U_v_0 * (t28 * t74 - t34 * t78) - t88, t96 = t89 + signed_lower_twist_wz * (t3 * t74 - t91 - t8 * t78),
      t175 = sign1 * t96;
    OWN(upper_momentum_Ly) = t168 - t175;
    WRITE4(momenta, 16, 27, 40, 51, OWN(upper_momentum_Ly));
    const LIMB4 t55 = limb_lower_Izz * t34 - limb_lower_Ixz * t28, t56 = t34 * t55, t35 = limb_lower_com_z * t34,
      t51 = limb_lower_Ixz * t34 - limb_lower_Ixx * t28, t58 = U_v_0 * (t56 - t28 * t51),
      t63 = t58 + signed_lower_twist_wy * (t15 * t51 - t20 * t55),
      t68 = t63 + signed_lower_twist_wz * (t8 * t55 - t3 * t51);
    OWN(upper_momentum_Lx) = t68 - t165;
    WRITE4(momenta, 15, 28, 39, 52, OWN(upper_momentum_Lx));
    const LIMB4 t21 = limb_lower_com_z * t20, t11 = param_R * t3 + (limb_lower_com_z * t8 - limb_lower_com_x * t3),
      t39 = U_v_0 * t11, t37 = param_R * t28 + (-param_R) - (limb_lower_com_x * t28 - t35);
    OWN(lower_momentum_py) = limb_lower_m * (lower_twist_vy + (signed_lower_twist_wz * t37 - t39));
    WRITE4(momenta, 7, 18, 31, 42, OWN(lower_momentum_py));
    const LIMB4 t97 = t37 * OWN(lower_momentum_py), t47 = t11 * OWN(lower_momentum_py),
      t12 = signed_lower_twist_wy * t11, t43 = signed_lower_twist_wy * t37,
      t23 = param_R * t15 - (limb_lower_com_x * t15 - t21);
    OWN(lower_momentum_px) = each_limb_lower_m * (t12 + signed_lower_twist_wz * t23);
    WRITE4(momenta, 6, 19, 30, 43, OWN(lower_momentum_px));
    const LIMB4 t69 = t11 * OWN(lower_momentum_px);
    OWN(signed_lower_momentum_Lz) = t97 + sign1 * (t23 * OWN(lower_momentum_px)) + t124;
    WRITE4(momenta, 11, 23, 35, 47, sign3 * OWN(signed_lower_momentum_Lz));
    OWN(lower_momentum_pz) = each_limb_lower_m_2 * (signed_lower_twist_vz + (U_v_0 * t23 + t43));
    WRITE4(momenta, 8, 20, 32, 44, OWN(lower_momentum_pz));
    const LIMB4 t46 = t23 * OWN(lower_momentum_pz);
    OWN(lower_momentum_Ly) = t69 - sign3 * (t37 * OWN(lower_momentum_pz)) - t175;
    WRITE4(momenta, 10, 21, 34, 45, OWN(lower_momentum_Ly));
    OWN(lower_momentum_Lx) = t68 - (sign2 * t46 + t47);
    WRITE4(momenta, 9, 22, 33, 46, OWN(lower_momentum_Lx));
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
      t162 = platform_momentum_Lz + limbs.signed_lower_momentum_Lz[0] + limbs.signed_upper_momentum_Lz[0];
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
      t135 = platform_momentum_py + limbs.lower_momentum_py[0] + limbs.upper_momentum_py[0] +
          limbs.lower_momentum_px[1],
      t138 = t135 + limbs.signed_upper_momentum_px[1] + limbs.lower_momentum_py[2] + limbs.upper_momentum_py[2],
      py_total = t138 + limbs.lower_momentum_px[3] - limbs.signed_upper_momentum_px[3];
    WRITE(total_, 1, py_total);
    REAL checked1 = py_total;
    const REAL t128 = platform_momentum_px + limbs.lower_momentum_px[0] + limbs.signed_upper_momentum_px[0] +
        limbs.lower_momentum_py[1],
      t131 = t128 + limbs.upper_momentum_py[1] + limbs.lower_momentum_px[2] - limbs.signed_upper_momentum_px[2],
      px_total = t131 + limbs.lower_momentum_py[3] + limbs.upper_momentum_py[3];
    WRITE(total_, 0, px_total);
    REAL checked2 = px_total;
    const REAL platform_momentum_pz = platform_m * (t27 * platform_twist_wx - t36 * platform_twist_wy);
    WRITE(momenta, 2, platform_momentum_pz);
    const REAL t76 = t74 - t36 * platform_momentum_pz, t50 = t27 * platform_momentum_pz - t49,
      t142 = platform_momentum_pz + limbs.lower_momentum_pz[0] - limbs.signed_upper_momentum_pz[0] +
          limbs.lower_momentum_pz[1],
      t145 = t142 + limbs.signed_upper_momentum_pz[1] + limbs.lower_momentum_pz[2] +
          limbs.signed_upper_momentum_pz[2],
      pz_total = t145 + limbs.lower_momentum_pz[3] - limbs.signed_upper_momentum_pz[3];
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
    const REAL t156 = platform_momentum_Ly + limbs.lower_momentum_Ly[0] + limbs.upper_momentum_Ly[0] +
        limbs.lower_momentum_Lx[1],
      t160 = t156 + limbs.upper_momentum_Lx[1] + limbs.lower_momentum_Ly[2] + limbs.upper_momentum_Ly[2] +
          limbs.lower_momentum_Lx[3];
    RESULT(checked0, total_, 4, t160 + limbs.upper_momentum_Lx[3]);
    const REAL t53 = platform_Ixx * platform_turn_xy, t54 = platform_turn_xy * t53, t61 = platform_turn_yy * t53,
      t68 = platform_turn_zy * t53, t51 = platform_Ixx * platform_turn_xx, t55 = platform_turn_xx * t51 + t54,
      t62 = platform_turn_yx * t51 + t61, t69 = platform_turn_zx * t51 + t68, t56 = platform_Izz * platform_turn_xz,
      t59 = platform_twist_wx * (t55 + platform_turn_xz * t56),
      t66 = t59 + platform_twist_wy * (t62 + platform_turn_yz * t56),
      platform_momentum_Lx = t50 + (t66 + platform_twist_wz * (t69 + platform_turn_zz * t56));
    WRITE(momenta, 3, platform_momentum_Lx);
    const REAL t149 = platform_momentum_Lx + limbs.lower_momentum_Lx[0] + limbs.upper_momentum_Lx[0] +
        limbs.lower_momentum_Ly[1],
      t153 = t149 + limbs.upper_momentum_Ly[1] + limbs.lower_momentum_Lx[2] + limbs.upper_momentum_Lx[2] +
          limbs.lower_momentum_Ly[3];
    RESULT(checked1, total_, 3, t153 + limbs.upper_momentum_Ly[3]);
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
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0), each_k1 = -sign2 * k1,
      factor_2 = -sign2 * 0.5, sign3 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: geometry; momentum rate, eq. (35) */
    const LIMB4 minus_lower_rotation_yx = signed_U_0_sin * lower_cos, signed_lower_sin = IN_EACH4(SINES, sine, 1,
        2),
      t19 = 0.5 * minus_lower_rotation_yx, signed_lower_rotation_yy = signed_U_0_sin * signed_lower_sin,
      t21 = t19 + each_k1 * signed_lower_rotation_yy, t23 = limb_lower_com_x * t21,
      t26 = k1 * minus_lower_rotation_yx - factor_2 * signed_lower_rotation_yy,
      t29 = param_R * t21 - (t23 - limb_lower_com_z * t26), t325 = sign1 * IN_EACH4(READ, v, 0, 3);
    /* each limb: momentum, eq. (31); velocities, eq. (6); momentum rate, eq. (35) */
    const LIMB4 t33 = t325 * t29, t36 = 0.5 * signed_lower_sin - each_k1 * lower_cos,
      t38 = param_R * t36 + (-param_R), t39 = limb_lower_com_x * t36,
      t42 = k1 * signed_lower_sin + factor_2 * lower_cos, t45 = t38 - (t39 - limb_lower_com_z * t42),
      U_v_1 = IN_EACH4(READ, v, 1, 3), U_0_cos = IN_EACH4(SINES, cosine, 0, 2), lower_twist_wy = U_v_1 * U_0_cos,
      t47 = t33 + lower_twist_wy * t45, t328 = sign1 * signed_U_1_screw_vz, t329 = sign1 * (U_v_1 * t328),
      signed_lower_momentum_pz = limb_lower_m * (t329 + t47), t49 = lower_twist_wy * signed_lower_momentum_pz,
      signed_lower_rotation_zx = U_0_cos * lower_cos, t4 = 0.5 * signed_lower_rotation_zx,
      signed_lower_rotation_zy = U_0_cos * signed_lower_sin, t6 = t4 + each_k1 * signed_lower_rotation_zy,
      t8 = limb_lower_com_x * t6, t11 = k1 * signed_lower_rotation_zx - factor_2 * signed_lower_rotation_zy,
      t14 = param_R * t6 - (t8 - limb_lower_com_z * t11), t51 = t325 * t14,
      signed_lower_twist_wz = U_v_1 * signed_U_0_sin, t52 = signed_lower_twist_wz * t45 - t51,
      signed_lower_twist_vy = U_v_1 * signed_U_1_screw_vy,
      signed_lower_momentum_py = limb_lower_m * (signed_lower_twist_vy + t52), U_a_1 = IN_EACH4(READ, a, 1, 3);
    /* each limb: momentum rate, eq. (35); accelerations; momentum, eq. (31) */
    const LIMB4 t55 = t49 + signed_lower_twist_wz * signed_lower_momentum_py,
      signed_lower_twist_rate_wy = U_v_1 * (t325 * signed_U_0_sin) - sign1 * (U_a_1 * U_0_cos),
      t15 = signed_lower_twist_rate_wy * t14,
      signed_lower_twist_rate_wz = sign1 * (U_a_1 * signed_U_0_sin) + U_v_1 * (t325 * U_0_cos),
      t32 = (-limb_lower_m) * (t15 - signed_lower_twist_rate_wz * t29), signed_lower_rate_at_O_fx = t55 - t32;
    WRITE4(momentum_rates, 6, 19, 30, 43, -sign1 * signed_lower_rate_at_O_fx);
    LIMB4 checked = signed_lower_rate_at_O_fx;
    const LIMB4 t60 = t325 * signed_lower_momentum_pz,
      lower_momentum_px = limb_lower_m * (lower_twist_wy * t14 + signed_lower_twist_wz * t29),
      U_a_0 = IN_EACH4(READ, a, 0, 3), t61 = signed_lower_twist_wz * lower_momentum_px + t60,
      t67 = signed_lower_twist_rate_wz * t45 - U_a_0 * t14, t73 = U_a_1 * t328,
      t330 = sign1 * (U_a_1 * signed_U_1_screw_vy + U_v_1 * (t325 * t328)), t69 = limb_lower_m * (t330 + t67),
      lower_rate_at_O_fy = t61 + t69;
    WRITE4(momentum_rates, 7, 18, 31, 42, lower_rate_at_O_fy);
    checked = checked + lower_rate_at_O_fy;
    const LIMB4 t72 = t325 * signed_lower_momentum_py - lower_twist_wy * lower_momentum_px,
      t78 = U_a_0 * t29 - signed_lower_twist_rate_wy * t45,
      signed_lower_twist_rate_vz = U_v_1 * (t325 * signed_U_1_screw_vy) - t73,
      t80 = limb_lower_m * (t78 - signed_lower_twist_rate_vz), signed_lower_rate_at_O_fz = t72 - t80;
    WRITE4(momentum_rates, 8, 20, 32, 44, sign2 * signed_lower_rate_at_O_fz);
    checked = checked + signed_lower_rate_at_O_fz;
    /* each limb: momentum, eq. (31); momentum rate, eq. (35) */
    const LIMB4 t107 = t45 * signed_lower_momentum_py + t29 * lower_momentum_px,
      t110 = limb_lower_Ixz * t11 - limb_lower_Ixx * t6, t118 = t21 * t110, t119 = limb_lower_Iyy * signed_U_0_sin,
      t121 = t118 + U_0_cos * t119, t127 = signed_U_0_sin * t119, t114 = limb_lower_Ixz * t6 - limb_lower_Izz * t11,
      t123 = t121 + t26 * t114, t124 = lower_twist_wy * t123, t199 = signed_lower_twist_rate_wy * t123,
      t128 = t6 * t110 - t127, t116 = t36 * t110 + t42 * t114, t130 = t128 + t11 * t114, t200 = U_a_0 * t116 + t199,
      t132 = t124 - t325 * t116 - signed_lower_twist_wz * t130, signed_lower_momentum_Lz = t107 + t132,
      t202 = t200 + signed_lower_twist_rate_wz * t130, t133 = lower_twist_wy * signed_lower_momentum_Lz,
      t177 = t325 * signed_lower_momentum_Lz, t136 = t14 * lower_momentum_px + t45 * signed_lower_momentum_pz,
      t139 = limb_lower_Ixx * t21 - limb_lower_Ixz * t26, t147 = t21 * t139, t148 = limb_lower_Iyy * U_0_cos,
      t150 = t147 + U_0_cos * t148, t156 = signed_U_0_sin * t148, t143 = limb_lower_Ixz * t21 - limb_lower_Izz *
          t26,
      t152 = t150 - t26 * t143, t153 = lower_twist_wy * t152, t185 = signed_lower_twist_rate_wy * t152,
      t157 = t6 * t139 - t156, t145 = t36 * t139 - t42 * t143, t159 = t157 - t11 * t143;
    /* each limb: momentum rate, eq. (35); momentum, eq. (31); accelerations */
    const LIMB4 t186 = U_a_0 * t145 + t185, t161 = t325 * t145 - t153 + signed_lower_twist_wz * t159,
      lower_momentum_Ly = t136 - t161, t188 = t186 + signed_lower_twist_rate_wz * t159,
      t163 = t133 - signed_lower_twist_wz * lower_momentum_Ly, t190 = t325 * lower_momentum_Ly,
      t167 = t163 + (t329 * signed_lower_momentum_py - signed_lower_twist_vy * signed_lower_momentum_pz),
      t170 = t29 * signed_lower_momentum_pz - t14 * signed_lower_momentum_py, t83 = t14 * t69 - t29 * t80,
      t189 = t14 * t32 + t45 * t80 - t188, t203 = t45 * t69 + t29 * t32 - t202,
      t86 = limb_lower_Ixx * t36 - limb_lower_Ixz * t42, t87 = t36 * t86,
      t90 = limb_lower_Ixz * t36 - limb_lower_Izz * t42, t92 = t87 - t42 * t90, t93 = U_a_0 * t92, t171 = t325 *
          t92,
      t99 = t6 * t86, t96 = t21 * t86 - t26 * t90, t101 = t99 - t11 * t90, t173 = t171 - lower_twist_wy * t96,
      t103 = t93 + signed_lower_twist_rate_wy * t96 + signed_lower_twist_rate_wz * t101,
      lower_rate_at_O_mx = t167 - (t83 - t103);
    WRITE4(momentum_rates, 9, 22, 33, 46, lower_rate_at_O_mx);
    checked = checked + lower_rate_at_O_mx;
    const LIMB4 t175 = t173 + signed_lower_twist_wz * t101, signed_lower_momentum_Lx = t170 + t175,
      t192 = t190 - lower_twist_wy * signed_lower_momentum_Lx,
      signed_lower_rate_at_O_my = signed_lower_twist_wz * signed_lower_momentum_Lx - t177 - t329 * lower_momentum_px
          + t189;
    WRITE4(momentum_rates, 10, 21, 34, 45, sign1 * signed_lower_rate_at_O_my);
    checked = checked + signed_lower_rate_at_O_my;
    const LIMB4 signed_lower_rate_at_O_mz = t192 - signed_lower_twist_vy * lower_momentum_px + t203;
    WRITE4(momentum_rates, 11, 23, 35, 47, sign3 * signed_lower_rate_at_O_mz);
    checked = checked + signed_lower_rate_at_O_mz;
    const LIMB4 t220 = 0.5 * t21 - param_H * t26, t224 = limb_upper_com_x * t21 - limb_upper_com_z * t26,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      t225 = upper_offset_x * minus_lower_rotation_yx + t220 - t224, t231 = t325 * t225,
      t238 = limb_upper_com_z * t42 - limb_upper_com_x * t36,
      t235 = signed_lower_sin * upper_offset_x + (-param_R) + (0.5 * t36 - param_H * t42), t239 = t235 + t238,
      signed_upper_position_z = upper_offset_x * signed_lower_rotation_zx, t241 = t231 + lower_twist_wy * t239,
      t331 = sign1 * IN_EACH4(READ, v, 2, 3), signed_upper_twist_vz = t329 - t331 * signed_lower_rotation_zx,
      signed_upper_momentum_pz = limb_lower_m * (signed_upper_twist_vz + t241),
      t243 = lower_twist_wy * signed_upper_momentum_pz, t212 = signed_upper_position_z + (0.5 * t6 - param_H * t11),
      t216 = t212 - (limb_upper_com_x * t6 - limb_upper_com_z * t11),
      t247 = signed_lower_twist_wz * t239 - t325 * t216,
      signed_upper_twist_vy = signed_lower_twist_vy - t331 * minus_lower_rotation_yx,
      signed_upper_momentum_py = limb_lower_m * (signed_upper_twist_vy + t247), P_a = IN_EACH4(READ, a, 2, 3),
      t250 = t243 + signed_lower_twist_wz * signed_upper_momentum_py, t279 = signed_lower_twist_rate_wy * t239,
      t227 = signed_lower_twist_rate_wy * t216 - signed_lower_twist_rate_wz * t225,
      t264 = signed_lower_twist_rate_wz * t239,
      t208 = t331 * (signed_lower_rotation_zx * lower_twist_wy + minus_lower_rotation_yx * signed_lower_twist_wz),
      t229 = limb_lower_m * (P_a * signed_lower_sin + t208 - t227), signed_upper_rate_at_O_fx = t229 - t250;
    WRITE4(momentum_rates, 12, 25, 36, 49, sign1 * signed_upper_rate_at_O_fx);
    checked = checked + signed_upper_rate_at_O_fx;
    const LIMB4 t253 = lower_twist_wy * t216 + signed_lower_twist_wz * t225, upper_twist_vx = t331 *
        signed_lower_sin,
      upper_momentum_px = limb_lower_m * (upper_twist_vx + t253),
      t257 = signed_lower_twist_wz * upper_momentum_px + t325 * signed_upper_momentum_pz, t266 = U_a_0 * t216 -
          t264,
      t259 = P_a * minus_lower_rotation_yx - t330, t274 = t325 * minus_lower_rotation_yx,
      t267 = t259 - t331 * (signed_lower_sin * signed_lower_twist_wz - t325 * signed_lower_rotation_zx) + t266,
      t268 = limb_lower_m * t267, upper_rate_at_O_fy = t257 - t268;
    WRITE4(momentum_rates, 13, 24, 37, 48, upper_rate_at_O_fy);
    checked = checked + upper_rate_at_O_fy;
    const LIMB4 t273 = signed_lower_twist_rate_vz + P_a * signed_lower_rotation_zx,
      t271 = t325 * signed_upper_momentum_py - lower_twist_wy * upper_momentum_px, t280 = U_a_0 * t225 - t279,
      t282 = limb_lower_m * (t273 - t331 * (t274 + signed_lower_sin * lower_twist_wy) - t280),
      signed_upper_rate_at_O_fz = t271 + t282;
    WRITE4(momentum_rates, 14, 26, 38, 50, sign2 * signed_upper_rate_at_O_fz);
    checked = checked + signed_upper_rate_at_O_fz;
    const LIMB4 signed_upper_momentum_Lz = t132 + (t239 * signed_upper_momentum_py + t225 * upper_momentum_px),
      t286 = lower_twist_wy * signed_upper_momentum_Lz, t304 = t325 * signed_upper_momentum_Lz,
      minus_upper_momentum_Ly = t161 - (t216 * upper_momentum_px + t239 * signed_upper_momentum_pz),
      t318 = t325 * minus_upper_momentum_Ly, t291 = t286 + signed_lower_twist_wz * minus_upper_momentum_Ly,
      t292 = signed_upper_twist_vy * signed_upper_momentum_pz, t322 = signed_upper_twist_vy * upper_momentum_px,
      t306 = signed_upper_twist_vz * upper_momentum_px,
      t295 = t292 - signed_upper_twist_vz * signed_upper_momentum_py - t291, t314 = t239 * t268, t311 = t239 * t282,
      upper_rate_at_O_mx = t103 + (t216 * t268 - t225 * t282) - t295;
    WRITE4(momentum_rates, 15, 28, 39, 52, upper_rate_at_O_mx);
    checked = checked + upper_rate_at_O_mx;
    const LIMB4 t308 = t306 - upper_twist_vx * signed_upper_momentum_pz,
      t323 = upper_twist_vx * signed_upper_momentum_py - t322,
      signed_upper_momentum_Lx = t175 + (t225 * signed_upper_momentum_pz - t216 * signed_upper_momentum_py),
      t309 = signed_lower_twist_wz * signed_upper_momentum_Lx - t304 - t308,
      t324 = t318 + lower_twist_wy * signed_upper_momentum_Lx - t323,
      signed_upper_rate_at_O_my = t309 - (t188 - (t216 * t229 - t311));
    WRITE4(momentum_rates, 16, 27, 40, 51, sign1 * signed_upper_rate_at_O_my);
    checked = checked + signed_upper_rate_at_O_my;
    const LIMB4 signed_upper_rate_at_O_mz = t202 + (t314 - t225 * t229) + t324;
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
    EACH4 U_0_energy_kinetic_up_to, t1, t2, signed_lower_rotation_zx, t3;
} LIMBS(energy);

STAGE(energy, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict sine, const double *restrict cosine, LIMBS(energy) *own)
{
    (void)limb, (void)stride;
    /* each limb: geometry */
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      lower_cos = IN_EACH4(SINES, cosine, 0, 1);
    OWN(signed_lower_rotation_zx) = IN_EACH4(SINES, cosine, 4, 1) * lower_cos;
    /* each limb: energy; velocities, eq. (6) */
    const LIMB4 t26 = limb_lower_m * (upper_offset_x * OWN(signed_lower_rotation_zx));
    OWN(t3) = (-gravity_z) * (t26 - limb_lower_mx * OWN(signed_lower_rotation_zx));
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3), upper_vel_y = U_v_1 * upper_offset_x, P_v = IN_EACH4(READ, v, 2,
        3),
      t19 = upper_vel_y * (limb_lower_m * upper_vel_y - k7 * U_v_1), U_v_0 = IN_EACH4(READ, v, 0, 3),
      t20 = P_v * (limb_lower_m * P_v) + t19, lower_omega_y = U_v_0 * lower_cos,
      minus_upper_vel_z = upper_offset_x * lower_omega_y;
    OWN(t2) = t20 + minus_upper_vel_z * (limb_lower_m * minus_upper_vel_z - k7 * lower_omega_y);
    const LIMB4 signed_lower_omega_x = U_v_0 * IN_EACH4(SINES, sine, 0, 1),
      t4 = U_v_1 * U_v_1 + (signed_lower_omega_x * signed_lower_omega_x + lower_omega_y * lower_omega_y),
      t5 = k4 * t4, t10 = signed_lower_omega_x * (k4 * signed_lower_omega_x) + lower_omega_y * (k5 * lower_omega_y);
    OWN(t1) = t5 + (U_v_1 * (k5 * U_v_1) - t10);
    OWN(U_0_energy_kinetic_up_to) = k3 * (U_v_0 * U_v_0);
}

BODY(three_ups_upu_s_energy)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict energy, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    LIMBS(energy) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t15 = limb5_S_q_qw * limb5_S_q_qw,
      t16 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t17 = t15 + t16,
      t18 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t24 = t16 + t18,
      t21 = t17 + (t18 + limb5_S_q_qz * limb5_S_q_qz);
    /* potential: energy; accelerations */
    const REAL t26 = gravity_z_platform_mz * (1.0 - (4.0 - 2.0 * t21) * t24);
    FIRST_LIMB(0, energy, 0, stride, q, v, sine, cosine, &limbs);
    NEXT_LIMB(1, energy, 0, stride, q, v, sine, cosine, &limbs);
    const REAL t27 = limbs.signed_lower_rotation_zx[0] - limbs.signed_lower_rotation_zx[1];
    NEXT_LIMB(2, energy, 0, stride, q, v, sine, cosine, &limbs);
    const REAL t28 = limbs.signed_lower_rotation_zx[2] + t27;
    NEXT_LIMB(3, energy, 0, stride, q, v, sine, cosine, &limbs);
    const REAL t33 = limbs.t3[1] - (limbs.t3[0] - (t26 - gravity_z_limb_lower_mx *
        (limbs.signed_lower_rotation_zx[3] - t28))),
      potential_energy = limbs.t3[3] - (limbs.t3[2] - t33);
    WRITE(energy, 1, potential_energy);
    REAL checked0 = potential_energy;
    const REAL limb2_lower_energy_kinetic_up_to = limbs.U_0_energy_kinetic_up_to[0] + limbs.t1[0] +
        limbs.U_0_energy_kinetic_up_to[1] + limbs.t1[1],
      limb4_U_0_energy_kinetic_up_to = limb2_lower_energy_kinetic_up_to + limbs.U_0_energy_kinetic_up_to[2] +
          limbs.t1[2] + limbs.U_0_energy_kinetic_up_to[3],
      limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14),
      limb4_lower_energy_kinetic_up_to = limb4_U_0_energy_kinetic_up_to + limbs.t1[3],
      t5 = k6 * (limb5_S_v_wz * limb5_S_v_wz + (limb5_S_v_wx * limb5_S_v_wx + limb5_S_v_wy * limb5_S_v_wy)),
      t10 = limb5_S_v_wx * (platform_sxx * limb5_S_v_wx) + limb5_S_v_wy * (platform_sxx * limb5_S_v_wy),
      platform_energy_kinetic_up_to = limb4_lower_energy_kinetic_up_to + (t5 - (t10 + limb5_S_v_wz * (platform_szz *
          limb5_S_v_wz))),
      kinetic_energy = 0.5 * (platform_energy_kinetic_up_to + limbs.t2[0] + limbs.t2[1] + limbs.t2[2] +
          limbs.t2[3]);
    WRITE(energy, 0, kinetic_energy);
    REAL checked1 = kinetic_energy;
    /* else status 5: no rotation */
    NOT_BELOW(t21, 0.999999, 5);
    NOT_ABOVE(t21, 1.000001, 5);
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

typedef struct {
    EACH4 checked;
} LIMBS(bias);

STAGE(bias, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, LIMBS(bias) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0), factor_2 = sign2 * 2.0,
      each_gravity_z = -sign2 * gravity_z, each_gravity_z_limb_lower_mx = sign2 * gravity_z_limb_lower_mx;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: accelerations; momentum rate, eq. (35); balance, eqs. (40)-(47) */
    const LIMB4 signed_lower_omega_x = U_v_0 * signed_lower_sin, U_v_1 = IN_EACH4(READ, v, 1, 3),
      signed_lower_alpha_still_y = U_v_1 * signed_lower_omega_x,
      signed_lower_U_still_zx = factor_2 * signed_lower_alpha_still_y,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      t5 = each_gravity_z * signed_U_0_sin - sign2 * (upper_offset_x * signed_lower_U_still_zx),
      t19 = sign1 * IN_EACH4(SINES, cosine, 1, 2), signed_lower_omega_y = U_v_0 * t19,
      lower_U_still_xy = signed_lower_omega_x * signed_lower_omega_y, P_v = IN_EACH4(READ, v, 2, 3),
      signed_upper_acc_still_z = P_v * (2.0 * signed_lower_omega_y) + t5,
      signed_upper_rate_my = limb_lower_mx * signed_upper_acc_still_z,
      t7 = signed_upper_rate_my - upper_offset_x * (k7 * signed_lower_alpha_still_y + limb_lower_m *
          signed_upper_acc_still_z),
      t9 = t19 * (t7 + (each_gravity_z_limb_lower_mx * signed_U_0_sin + k11 * signed_lower_alpha_still_y)),
      U_0_moment_z = signed_lower_sin * (k10 * (U_v_1 * signed_lower_omega_y)) - t9;
    WRITE4(bias, 0, 3, 6, 9, U_0_moment_z);
    LIMB4 checked = U_0_moment_z;
    const LIMB4 t17 = signed_lower_omega_y * signed_lower_omega_y, t13 = upper_offset_x * lower_U_still_xy,
      signed_U_0_acc_y = each_gravity_z * IN_EACH4(SINES, cosine, 0, 2), minus_lower_acc_x = t19 * signed_U_0_acc_y,
      lower_acc_y = signed_lower_sin * signed_U_0_acc_y, minus_upper_moment_z = limb_lower_mx * lower_acc_y,
      upper_acc_still_y = P_v * (2.0 * U_v_1) + (t13 + lower_acc_y),
      minus_upper_rate_mz = limb_lower_mx * upper_acc_still_y,
      t16 = upper_offset_x * (limb_lower_m * upper_acc_still_y - limb_lower_mx * lower_U_still_xy) -
          minus_upper_rate_mz,
      lower_moment_z = k8 * lower_U_still_xy + minus_upper_moment_z + t16;
    WRITE4(bias, 1, 4, 7, 10, lower_moment_z);
    checked = checked + lower_moment_z;
    const LIMB4 minus_lower_U_still_xx = t17 + U_v_1 * U_v_1,
      minus_lower_force_x = limb_lower_m * (upper_offset_x * minus_lower_U_still_xx + minus_lower_acc_x),
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
    RESULT(checked0, bias, 12, k12 * (READ(v, 13) * limb5_S_v_wz) - minus_platform_moment_x);
    RESULT(checked1, bias, 13, platform_moment_y - k12 * (READ(v, 12) * limb5_S_v_wz));
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
