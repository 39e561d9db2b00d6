/*
 * three_ups_upu_s: loops.
 *   closure; closure_jacobian; closure_bias; velocity; null_space; acceleration; close_position;
 *   close_velocity; assemble
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 t1, t2, t3, t4, t5, checked;
} LIMBS(closure);

STAGE(closure, 0)(size_t limb, size_t stride, const double *restrict q, double *restrict residual_,
    const double *restrict sine, const double *restrict cosine, REAL given, REAL given_2, REAL given_3,
    REAL given_4, REAL given_5, REAL given_6, LIMBS(closure) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, 1.0, 1.0, -1.0),
      sign3 = OF4(1.0, -1.0, -1.0, -1.0), sign4 = OF4(1.0, -1.0, 1.0, 1.0), sign5 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 t8 = sign4 * (given_5 - sign1 * given_6);
    /* each limb: geometry */
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      U_0_sin = OF4(SINES(sine, 0), SINES(cosine, 2), SINES(sine, 4), SINES(cosine, 6)),
      lower_cos = IN_EACH4(SINES, cosine, 1, 2), minus_lower_rotation_yx = U_0_sin * lower_cos;
    /* each limb: loop closure; geometry */
    OWN(t4) = upper_offset_x * minus_lower_rotation_yx + t8;
    OWN(t5) = minus_lower_rotation_yx * OWN(t4);
    const LIMB4 signed_U_0_cos = OF4(SINES(cosine, 0), SINES(sine, 2), SINES(cosine, 4), SINES(sine, 6)),
      t2 = signed_U_0_cos * OWN(t4), t4 = sign2 * (given - sign1 * given_2),
      signed_lower_rotation_zx = signed_U_0_cos * lower_cos;
    OWN(t1) = upper_offset_x * signed_lower_rotation_zx - t4;
    OWN(t2) = signed_lower_rotation_zx * OWN(t1);
    const LIMB4 signed_S_opening_fz = t2 - U_0_sin * OWN(t1);
    WRITE4(residual_, 2, 6, 9, 12, -sign5 * signed_S_opening_fz);
    LIMB4 checked = signed_S_opening_fz;
    OWN(t3) = IN_EACH4(SINES, sine, 1, 2) * upper_offset_x + (-param_R) - sign3 * (given_3 - sign1 * given_4);
    OWN(checked) = checked;
}

STAGE(closure, 1)(size_t limb, size_t stride, double *restrict residual_, const double *restrict sine,
    const double *restrict cosine, REAL given, REAL given_2, REAL given_3, REAL given_4, LIMBS(closure) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0);
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: loop closure */
    const LIMB4 S_opening_fx = given_2 + (signed_lower_sin * OWN(t3) + given);
    WRITE4(residual_, 0, 4, 7, 10, S_opening_fx);
    LIMB4 checked = OWN(checked) + S_opening_fx;
    const LIMB4 t4 = IN_EACH4(SINES, sine, 0, 2) * signed_lower_sin * given_3,
      t5 = t4 - IN_EACH4(SINES, cosine, 1, 2) * OWN(t3),
      signed_S_opening_fy = t5 + IN_EACH4(SINES, cosine, 0, 2) * signed_lower_sin * given_4;
    WRITE4(residual_, 1, 5, 8, 11, -sign1 * signed_S_opening_fy);
    checked = checked + signed_S_opening_fy;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_closure)(size_t stride, const double *restrict q, double *restrict residual_,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(closure) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t15 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), t17 = param_H * (1.0 - t9 * t15),
      t23 = 0.5 * (1.0 - t6 * t9), t10 = limb5_S_q_qz * t9, t24 = limb5_S_q_qy * t10,
      t26 = limb5_S_q_qw * (limb5_S_q_qx * t9), t12 = limb5_S_q_qy * t9, platform_turn_zy = t24 + t26,
      t27 = param_H * (t24 - t26), limb1_U_0_cos = SINES(cosine, 0),
      t34 = limb1_U_0_cos * platform_turn_zy, /* limb1 */
      t32 = 0.5 * platform_turn_zy, limb1_U_0_sin = SINES(sine, 0), limb1_lower_sin = SINES(sine, 1),
      t36 = limb1_lower_sin * (limb1_U_0_sin * platform_turn_yy - t34), /* limb1 */
      t30 = 0.5 * platform_turn_yy, t19 = limb5_S_q_qx * t12, t13 = limb5_S_q_qw * t12, t20 = limb5_S_q_qw * t10,
      t11 = limb5_S_q_qx * t10, platform_turn_xy = t19 - t20, t31 = 0.5 * (t19 + t20),
      limb1_lower_cos = SINES(cosine, 1), limb1_U2_opening_mn = t36 + limb1_lower_cos * platform_turn_xy;
    WRITE(residual_, 3, limb1_U2_opening_mn);
    REAL checked0 = limb1_U2_opening_mn;
    const REAL t21 = 0.5 * platform_turn_xy, platform_turn_xz = t11 + t13, t14 = 0.5 * (t11 - t13),
      t18 = param_H * platform_turn_xz;
    FIRST_LIMB(0, closure, 0, stride, q, residual_, sine, cosine, t17, t14, t18, t23, t27, t31, &limbs);
    NEXT_LIMB(2, closure, 0, stride, q, residual_, sine, cosine, t17, t14, t18, t23, t27, t31, &limbs);
    FIRST_LIMB(0, closure, 1, stride, residual_, sine, cosine, limbs.t5[0], limbs.t2[0], limbs.t4[0], limbs.t1[0], &limbs);
    REAL checked1 = ALONE(limbs.checked[0]);
    NEXT_LIMB(2, closure, 1, stride, residual_, sine, cosine, limbs.t5[2], limbs.t2[2], limbs.t4[2], limbs.t1[2], &limbs);
    REAL checked2 = ALONE(limbs.checked[2]);
    NEXT_LIMB(1, closure, 0, stride, q, residual_, sine, cosine, t21, t18, t30, t27, t32, t17, &limbs);
    NEXT_LIMB(3, closure, 0, stride, q, residual_, sine, cosine, t21, t18, t30, t27, t32, t17, &limbs);
    NEXT_LIMB(1, closure, 1, stride, residual_, sine, cosine, limbs.t2[1], limbs.t5[1], limbs.t1[1], limbs.t4[1], &limbs);
    REAL checked3 = ALONE(limbs.checked[1]);
    NEXT_LIMB(3, closure, 1, stride, residual_, sine, cosine, limbs.t2[3], limbs.t5[3], limbs.t1[3], limbs.t4[3], &limbs);
    checked0 = checked0 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18;
} LIMBS(closure_jacobian);

STAGE(closure_jacobian, 0)(size_t limb, size_t stride, const double *restrict q, double *restrict jacobian,
    const double *restrict sine, const double *restrict cosine, REAL platform_turn_yx,
    REAL minus_lower_rotation_yx, REAL platform_turn_zx, REAL signed_lower_rotation_yy, REAL platform_turn_xx,
    REAL platform_turn_yy, REAL platform_turn_zy, REAL platform_turn_xy, REAL platform_turn_yz,
    REAL platform_turn_zz, REAL platform_turn_xz, LIMBS(closure_jacobian) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0);
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: reciprocal wrenches, eq. (10) */
    const LIMB4 signed_base_lever_mx_by_S_fx = param_R * (U_0_cos * lower_cos);
    /* each limb: results; reciprocal wrenches, eq. (10); geometry */
    OWN(t1) = platform_turn_yx * signed_base_lever_mx_by_S_fx;
    OWN(t7) = platform_turn_yy * signed_base_lever_mx_by_S_fx;
    OWN(t13) = platform_turn_yz * signed_base_lever_mx_by_S_fx;
    const LIMB4 signed_base_lever_mz_by_S_fx = param_R * minus_lower_rotation_yx;
    OWN(t2) = platform_turn_zx * signed_base_lever_mz_by_S_fx;
    OWN(t8) = platform_turn_zy * signed_base_lever_mz_by_S_fx;
    OWN(t14) = platform_turn_zz * signed_base_lever_mz_by_S_fx;
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    WRITE4(jacobian, 14, 57, 99, 141, upper_offset_x);
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      base_lever_mx_by_S_fy = U_0_cos * upper_offset_x - param_R * (U_0_cos * signed_lower_sin);
    OWN(t3) = platform_turn_yx * base_lever_mx_by_S_fy;
    OWN(t9) = platform_turn_yy * base_lever_mx_by_S_fy;
    OWN(t15) = platform_turn_yz * base_lever_mx_by_S_fy;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      signed_base_lever_mz_by_S_fy = signed_U_0_sin * upper_offset_x - param_R * signed_lower_rotation_yy;
    OWN(t4) = platform_turn_zx * signed_base_lever_mz_by_S_fy;
    OWN(t10) = platform_turn_zy * signed_base_lever_mz_by_S_fy;
    OWN(t16) = platform_turn_zz * signed_base_lever_mz_by_S_fy;
    const LIMB4 signed_upper_position_x = signed_lower_sin * upper_offset_x + (-param_R),
      minus_U_0_lever_mz_by_S_fz = lower_cos * upper_offset_x;
    WRITE4(jacobian, 2, 45, 87, 129, -minus_U_0_lever_mz_by_S_fz);
    const LIMB4 t11 = sign1 * minus_U_0_lever_mz_by_S_fz,
      signed_base_lever_mx_by_S_fz = signed_U_0_sin * signed_upper_position_x,
      signed_base_lever_mz_by_S_fz = U_0_cos * signed_upper_position_x;
    OWN(t6) = platform_turn_zx * signed_base_lever_mz_by_S_fz;
    OWN(t12) = platform_turn_zy * signed_base_lever_mz_by_S_fz;
    OWN(t18) = platform_turn_zz * signed_base_lever_mz_by_S_fz;
    OWN(t5) = platform_turn_xx * t11 + platform_turn_yx * signed_base_lever_mx_by_S_fz;
    const LIMB4 t10 = platform_turn_yz * signed_base_lever_mx_by_S_fz;
    OWN(t11) = platform_turn_xy * t11 + platform_turn_yy * signed_base_lever_mx_by_S_fz;
    OWN(t17) = platform_turn_xz * t11 + t10;
}

BODY(three_ups_upu_s_closure_jacobian)(size_t stride, const double *restrict q, double *restrict jacobian,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(closure_jacobian) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      platform_turn_xx = 1.0 - t6 * t9, t48 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5),
      platform_turn_zz = 1.0 - t9 * t48, t22 = limb5_S_q_qy * t9, t23 = limb5_S_q_qx * t22, t28 = limb5_S_q_qw * t22,
      t13 = limb5_S_q_qz * t9, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t24 = limb5_S_q_qw * t13,
      platform_turn_yx = t23 + t24, platform_turn_xy = t23 - t24, t27 = limb5_S_q_qx * t13, t14 = limb5_S_q_qy * t13,
      platform_turn_zx = t27 - t28, platform_turn_xz = t27 + t28, platform_turn_zy = t14 + t16,
      platform_turn_yz = t14 - t16, limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1),
      limb1_lower_sin = SINES(sine, 1);
    FIRST_LIMB(0, closure_jacobian, 0, stride, q, jacobian, sine, cosine, platform_turn_yx, limb1_U_0_sin * limb1_lower_cos, platform_turn_zx, limb1_U_0_sin * limb1_lower_sin, platform_turn_xx, platform_turn_yy, platform_turn_zy, platform_turn_xy, platform_turn_yz, platform_turn_zz, platform_turn_xz, &limbs);
    /* mechanism: results */
    const REAL jacobian_158 = limbs.t5[0] - limbs.t6[0];
    WRITE(jacobian, 158, jacobian_158);
    REAL checked0 = jacobian_158;
    const REAL jacobian_171 = limbs.t11[0] - limbs.t12[0];
    WRITE(jacobian, 171, jacobian_171);
    REAL checked1 = jacobian_171;
    const REAL jacobian_184 = limbs.t17[0] - limbs.t18[0];
    WRITE(jacobian, 184, jacobian_184);
    REAL checked2 = jacobian_184;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_lower_cos = SINES(cosine, 3),
      limb2_lower_sin = SINES(sine, 3);
    NEXT_LIMB(1, closure_jacobian, 0, stride, q, jacobian, sine, cosine, platform_turn_xx, minus_limb2_U_0_cos * limb2_lower_cos, platform_turn_zx, minus_limb2_U_0_cos * limb2_lower_sin, platform_turn_yx, platform_turn_xy, platform_turn_zy, platform_turn_yy, platform_turn_xz, platform_turn_zz, platform_turn_yz, &limbs);
    const REAL jacobian_160 = limbs.t2[1] - limbs.t1[1];
    WRITE(jacobian, 160, jacobian_160);
    REAL checked3 = jacobian_160;
    RESULT(checked0, jacobian, 161, limbs.t4[1] - limbs.t3[1]);
    RESULT(checked1, jacobian, 162, limbs.t5[1] + limbs.t6[1]);
    RESULT(checked2, jacobian, 173, limbs.t8[1] - limbs.t7[1]);
    RESULT(checked3, jacobian, 174, limbs.t10[1] - limbs.t9[1]);
    RESULT(checked0, jacobian, 175, limbs.t11[1] + limbs.t12[1]);
    RESULT(checked1, jacobian, 186, limbs.t14[1] - limbs.t13[1]);
    RESULT(checked2, jacobian, 187, limbs.t16[1] - limbs.t15[1]);
    RESULT(checked3, jacobian, 188, limbs.t17[1] + limbs.t18[1]);
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_lower_cos = SINES(cosine, 5),
      minus_limb3_lower_sin = SINES(sine, 5);
    NEXT_LIMB(2, closure_jacobian, 0, stride, q, jacobian, sine, cosine, platform_turn_yx, limb3_U_0_sin * limb3_lower_cos, platform_turn_zx, limb3_U_0_sin * minus_limb3_lower_sin, platform_turn_xx, platform_turn_yy, platform_turn_zy, platform_turn_xy, platform_turn_yz, platform_turn_zz, platform_turn_xz, &limbs);
    RESULT(checked0, jacobian, 163, limbs.t1[2] + limbs.t2[2]);
    RESULT(checked1, jacobian, 165, limbs.t6[2] - limbs.t5[2]);
    RESULT(checked2, jacobian, 176, limbs.t7[2] + limbs.t8[2]);
    RESULT(checked3, jacobian, 178, limbs.t12[2] - limbs.t11[2]);
    RESULT(checked0, jacobian, 189, limbs.t13[2] + limbs.t14[2]);
    RESULT(checked1, jacobian, 191, limbs.t18[2] - limbs.t17[2]);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_lower_cos = SINES(cosine, 7),
      minus_limb4_lower_sin = SINES(sine, 7);
    NEXT_LIMB(3, closure_jacobian, 0, stride, q, jacobian, sine, cosine, platform_turn_xx, minus_limb4_U_0_cos * limb4_lower_cos, platform_turn_zx, minus_limb4_U_0_cos * minus_limb4_lower_sin, platform_turn_yx, platform_turn_xy, platform_turn_zy, platform_turn_yy, platform_turn_xz, platform_turn_zz, platform_turn_yz, &limbs);
    RESULT(checked2, jacobian, 166, limbs.t1[3] - limbs.t2[3]);
    RESULT(checked3, jacobian, 167, limbs.t4[3] - limbs.t3[3]);
    RESULT(checked0, jacobian, 179, limbs.t7[3] - limbs.t8[3]);
    RESULT(checked1, jacobian, 180, limbs.t10[3] - limbs.t9[3]);
    RESULT(checked2, jacobian, 192, limbs.t13[3] - limbs.t14[3]);
    RESULT(checked3, jacobian, 193, limbs.t16[3] - limbs.t15[3]);
    const REAL t29 = limbs.t1[0] + limbs.t2[0];
    checked0 = checked0 + t29;
    WRITE(jacobian, 156, -t29);
    const REAL t30 = limbs.t3[0] + limbs.t4[0];
    checked1 = checked1 + t30;
    WRITE(jacobian, 157, -t30);
    /* limb1: geometry */
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    /* limb1: reciprocal wrenches, eq. (10) */
    const REAL t21 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy),
      limb1_U2_constraint_mn_couple_z = t21 - limb1_lower_sin * platform_turn_xy;
    WRITE(jacobian, 16, limb1_U2_constraint_mn_couple_z);
    const REAL t32 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z,
      t35 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    WRITE(jacobian, 3, limb1_U_0_lever_mz_by_limb1_U2_mn);
    /* mechanism: results; reciprocal wrenches, eq. (10) */
    const REAL t31 = platform_turn_xx * limb1_U_0_lever_mz_by_limb1_U2_mn,
      t42 = platform_turn_xy * limb1_U_0_lever_mz_by_limb1_U2_mn,
      t52 = platform_turn_xz * limb1_U_0_lever_mz_by_limb1_U2_mn,
      base_lever_my_by_limb1_U2_mn = t32 - limb1_U_0_sin * limb1_U_0_lever_my_by_limb1_U2_mn,
      t34 = t31 + platform_turn_yx * base_lever_my_by_limb1_U2_mn,
      base_lever_mz_by_limb1_U2_mn = t35 + limb1_U_0_cos * limb1_U_0_lever_my_by_limb1_U2_mn,
      t38 = t34 + platform_turn_zx * base_lever_mz_by_limb1_U2_mn;
    checked2 = checked2 + t38;
    WRITE(jacobian, 159, -t38);
    const REAL t44 = t42 + platform_turn_yy * base_lever_my_by_limb1_U2_mn,
      t54 = t52 + platform_turn_yz * base_lever_my_by_limb1_U2_mn,
      t46 = t44 + platform_turn_zy * base_lever_mz_by_limb1_U2_mn;
    checked3 = checked3 + t46;
    WRITE(jacobian, 172, -t46);
    const REAL t56 = t54 + platform_turn_zz * base_lever_mz_by_limb1_U2_mn;
    checked0 = checked0 + t56;
    WRITE(jacobian, 185, -t56);
    const REAL t39 = limbs.t3[2] + limbs.t4[2];
    checked1 = checked1 + t39;
    WRITE(jacobian, 164, -t39);
    const REAL minus_jacobian_168 = limbs.t5[3] + limbs.t6[3];
    checked2 = checked2 + minus_jacobian_168;
    WRITE(jacobian, 168, -minus_jacobian_168);
    const REAL t40 = limbs.t7[0] + limbs.t8[0];
    checked3 = checked3 + t40;
    WRITE(jacobian, 169, -t40);
    const REAL t41 = limbs.t9[0] + limbs.t10[0];
    checked0 = checked0 + t41;
    WRITE(jacobian, 170, -t41);
    const REAL t47 = limbs.t9[2] + limbs.t10[2];
    checked1 = checked1 + t47;
    WRITE(jacobian, 177, -t47);
    const REAL t57 = limbs.t15[2] + limbs.t16[2];
    checked2 = checked2 + t57;
    WRITE(jacobian, 190, -t57);
    const REAL minus_jacobian_181 = limbs.t11[3] + limbs.t12[3];
    checked3 = checked3 + minus_jacobian_181;
    WRITE(jacobian, 181, -minus_jacobian_181);
    const REAL minus_jacobian_194 = limbs.t17[3] + limbs.t18[3];
    checked0 = checked0 + minus_jacobian_194;
    WRITE(jacobian, 194, -minus_jacobian_194);
    const REAL t50 = limbs.t13[0] + limbs.t14[0];
    checked1 = checked1 + t50;
    WRITE(jacobian, 182, -t50);
    const REAL t51 = limbs.t15[0] + limbs.t16[0];
    checked2 = checked2 + t51;
    WRITE(jacobian, 183, -t51);
    WRITE(jacobian, 0, CONSTANT(0.0));
    WRITE(jacobian, 1, CONSTANT(0.0));
    WRITE(jacobian, 15, CONSTANT(0.0));
    WRITE(jacobian, 26, CONSTANT(1.0));
    WRITE(jacobian, 69, CONSTANT(1.0));
    WRITE(jacobian, 111, CONSTANT(1.0));
    WRITE(jacobian, 153, CONSTANT(1.0));
    WRITE(jacobian, 154, CONSTANT(0.0));
    WRITE(jacobian, 155, CONSTANT(0.0));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 signed_lower_omega_y, t1, t2, t3, signed_lower_omega_x, checked;
} LIMBS(closure_bias);

STAGE(closure_bias, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, REAL platform_twist_wy,
    REAL platform_twist_wz, REAL platform_twist_wx, LIMBS(closure_bias) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, -1.0),
      each_param_R = -sign1 * param_R, factor_2 = sign1 * 2.0;
    const LIMB4 t36 = sign2 * platform_twist_wz, U_0_cos = IN_EACH4(SINES, cosine, 0, 2),
      signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: loop closure; reciprocal wrenches, eq. (10); velocities, eq. (6) */
    const LIMB4 t16 = signed_U_0_sin * t36, t5 = signed_U_0_sin * platform_twist_wy - U_0_cos * t36,
      lower_cos = IN_EACH4(SINES, cosine, 1, 2), t33 = sign1 * lower_cos,
      signed_lower_sin = IN_EACH4(SINES, sine, 1, 2), t6 = signed_lower_sin * t5;
    OWN(t2) = t33 * t5 - signed_lower_sin * platform_twist_wx;
    const LIMB4 signed_S_arm_y = param_R * lower_cos, t10 = signed_S_arm_y * OWN(t2);
    OWN(t1) = t6 + t33 * platform_twist_wx;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3);
    OWN(signed_lower_omega_y) = U_v_0 * t33;
    const LIMB4 t35 = sign1 * (IN_EACH4(READ, q, 2, 3) + limb_upper_phase),
      signed_S_arm_x = t35 + each_param_R * signed_lower_sin, t13 = t10 - signed_S_arm_x * OWN(t1),
      t14 = OWN(t1) * t13, t25 = OWN(t2) * t13;
    OWN(t3) = U_0_cos * platform_twist_wy + t16;
    const LIMB4 t17 = signed_S_arm_x * OWN(t3), t23 = signed_S_arm_y * OWN(t3), t19 = t14 - OWN(t3) * t17,
      t32 = OWN(t2) * t17 + OWN(t1) * t23, t37 = sign1 * (OWN(t3) * t23 + t25),
      t34 = sign1 * OWN(signed_lower_omega_y), P_v = IN_EACH4(READ, v, 2, 3), U_v_1 = IN_EACH4(READ, v, 1, 3),
      t29 = P_v * (factor_2 * OWN(signed_lower_omega_y)),
      signed_S_opening_bias_fx = t35 * (t34 * t34 + U_v_1 * U_v_1) + t19;
    WRITE4(bias, 0, 4, 7, 10, -sign1 * signed_S_opening_bias_fx);
    LIMB4 checked = signed_S_opening_bias_fx;
    OWN(signed_lower_omega_x) = U_v_0 * signed_lower_sin;
    const LIMB4 t20 = t35 * (OWN(signed_lower_omega_x) * t34),
      S_opening_bias_fz = t32 - (t29 - t35 * (2.0 * (U_v_1 * OWN(signed_lower_omega_x))));
    WRITE4(bias, 2, 6, 9, 12, S_opening_bias_fz);
    checked = checked + S_opening_bias_fz;
    const LIMB4 S_opening_bias_fy = t20 + P_v * (2.0 * U_v_1) - t37;
    WRITE4(bias, 1, 5, 8, 11, S_opening_bias_fy);
    checked = checked + S_opening_bias_fy;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_closure_bias)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(closure_bias) limbs;
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t30 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), limb5_S_v_wz = READ(v, 14), limb5_S_v_wx = READ(v, 12),
      t32 = limb5_S_v_wz * (1.0 - t9 * t30), t24 = limb5_S_v_wx * (1.0 - t6 * t9), t13 = limb5_S_q_qy * t9,
      t14 = limb5_S_q_qx * t13, t28 = limb5_S_q_qw * t13, t15 = limb5_S_q_qz * t9,
      t21 = limb5_S_q_qw * (limb5_S_q_qx * t9), t16 = limb5_S_q_qw * t15, platform_turn_yx = t14 + t16,
      platform_turn_xy = t14 - t16, limb5_S_v_wy = READ(v, 13),
      t18 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, t19 = limb5_S_q_qy * t15,
      t27 = limb5_S_q_qx * t15, platform_turn_yz = t19 - t21, platform_turn_zy = t19 + t21,
      platform_twist_wy = t18 + limb5_S_v_wz * platform_turn_yz, t29 = limb5_S_v_wz * (t27 + t28),
      platform_twist_wz = t32 + (limb5_S_v_wx * (t27 - t28) + limb5_S_v_wy * platform_turn_zy),
      platform_twist_wx = t24 + limb5_S_v_wy * platform_turn_xy + t29;
    FIRST_LIMB(1, closure_bias, 0, stride, q, v, bias, sine, cosine, platform_twist_wx, platform_twist_wz, platform_twist_wy, &limbs);
    REAL checked0 = ALONE(limbs.checked[1]);
    NEXT_LIMB(2, closure_bias, 0, stride, q, v, bias, sine, cosine, platform_twist_wy, platform_twist_wz, platform_twist_wx, &limbs);
    REAL checked1 = ALONE(limbs.checked[2]);
    NEXT_LIMB(3, closure_bias, 0, stride, q, v, bias, sine, cosine, platform_twist_wx, platform_twist_wz, platform_twist_wy, &limbs);
    REAL checked2 = ALONE(limbs.checked[3]);
    NEXT_LIMB(0, closure_bias, 0, stride, q, v, bias, sine, cosine, platform_twist_wy, platform_twist_wz, platform_twist_wx, &limbs);
    REAL checked3 = ALONE(limbs.checked[0]);
    /* limb1: loop closure; geometry; reciprocal wrenches, eq. (10) */
    const REAL limb1_U_v_1 = READ(v, 1), t38 = limb1_U_v_1 - limbs.t3[0], t39 = limbs.signed_lower_omega_y[0] * t38,
      t40 = limbs.signed_lower_omega_y[0] - limbs.t1[0], limb1_U_0_sin = SINES(sine, 0),
      limb1_U_0_cos = SINES(cosine, 0), t43 = limb1_U_v_1 * limbs.signed_lower_omega_y[0] - (t39 - limb1_U_v_1 * t40),
      t46 = limb1_U_0_cos * platform_turn_zy,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    /* limb1: loop closure; reciprocal wrenches, eq. (10); geometry */
    const REAL t44 = limb1_U2_constraint_mn_couple_x * t43, t47 = limb1_U_0_sin * platform_turn_yy - t46,
      t62 = limb1_U2_constraint_mn_couple_x * t40, t50 = limbs.signed_lower_omega_x[0] * t40,
      t51 = limbs.signed_lower_omega_x[0] + limbs.t2[0], limb1_lower_cos = SINES(cosine, 1),
      limb1_lower_sin = SINES(sine, 1), t53 = t50 - limbs.signed_lower_omega_y[0] * t51, t56 = limb1_lower_sin * t47,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t47 - limb1_lower_sin * platform_turn_xy,
      t55 = t44 - limb1_U2_constraint_mn_couple_z * t53, t59 = limb1_U2_constraint_mn_couple_z * t40,
      limb1_U2_opening_mn = t56 + limb1_lower_cos * platform_turn_xy, t61 = t51 * (limb1_U2_opening_mn * t51 + t59);
    RESULT(checked0, bias, 3, t55 - (t61 - t38 * (t62 - limb1_U2_opening_mn * t38)));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 minus_U_0_lever_mz_by_S_fz, t1, signed_upper_position_x, S_arm_x, t2, checked;
} LIMBS(velocity);

STAGE(velocity, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict sine,
    const double *restrict cosine, LIMBS(velocity) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, -1.0);
    /* each limb: geometry; reciprocal wrenches, eq. (10); rates that follow */
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(signed_upper_position_x) = signed_lower_sin * upper_offset_x + (-param_R);
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * upper_offset_x;
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = sign1 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    OWN(checked) = checked;
}

STAGE(velocity, 1)(size_t limb, size_t stride, double *restrict v, const double *restrict sine,
    const double *restrict cosine, REAL limb5_S_joint_rate_wz, const EACH4 signed_limb5_S_joint_rate_wy,
    const EACH4 signed_limb5_S_joint_rate_wx, LIMBS(velocity) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, 1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, 1.0, -1.0, 1.0), sign4 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: velocities, eq. (6) */
    const LIMB4 t8 = signed_U_0_sin * limb5_S_joint_rate_wz + U_0_cos * GIVEN(signed_limb5_S_joint_rate_wy),
      signed_P_joint_rate = param_R * IN_EACH4(SINES, cosine, 1, 2) * t8;
    WRITE4(v, 2, 5, 8, 11, sign2 * signed_P_joint_rate);
    LIMB4 checked = OWN(checked) + signed_P_joint_rate;
    const LIMB4 signed_U_joint_rate_1 = OWN(t2) * (OWN(S_arm_x) * t8);
    WRITE4(v, 1, 4, 7, 10, sign3 * signed_U_joint_rate_1);
    checked = checked + signed_U_joint_rate_1;
    const LIMB4 t4 = OWN(signed_upper_position_x) * (U_0_cos * limb5_S_joint_rate_wz - signed_U_0_sin * GIVEN(signed_limb5_S_joint_rate_wy)),
      signed_U_joint_rate_0 = sign1 * (OWN(t1) * t4) + GIVEN(signed_limb5_S_joint_rate_wx);
    WRITE4(v, 0, 3, 6, 9, -sign4 * signed_U_joint_rate_0);
    checked = checked + signed_U_joint_rate_0;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_velocity)(size_t stride, const double *restrict q, const double *restrict y_dot,
    double *restrict v, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(velocity) limbs;
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t10 = t2 + t5,
      t69 = t2 + t4, t9 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t9 * t10, t35 = k2 - 0.5 * t7,
      platform_turn_xx = 1.0 - t6 * t9, platform_turn_zz = 1.0 - t9 * t69, t13 = limb5_S_q_qz * t9,
      t14 = limb5_S_q_qy * t13, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t24 = limb5_S_q_qy * t9,
      platform_turn_zy = t14 + t16, limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_cos = SINES(cosine, 1), platform_turn_yz = t14 - t16,
      t23 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy), /* limb1 */
      t25 = limb5_S_q_qx * t24, t59 = limb5_S_q_qw * t24, t26 = limb5_S_q_qw * t13, t58 = limb5_S_q_qx * t13,
      platform_turn_xy = t25 - t26;
    /* limb1: geometry; reciprocal wrenches, eq. (10); rates that follow */
    const REAL limb1_lower_sin = SINES(sine, 1), platform_turn_yx = t25 + t26,
      limb1_U2_constraint_mn_couple_z = t23 - limb1_lower_sin * platform_turn_xy;
    FIRST_LIMB(0, velocity, 0, stride, q, sine, cosine, &limbs);
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * (limb1_U2_constraint_mn_couple_z * limbs.t2[0]),
      t29 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t32 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t18 = limbs.signed_upper_position_x[0] * (limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0]),
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x + t18;
    /* limb5_S: pivots; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t29;
    REAL checked0 = minus_limb5_S_pivot_wz;
    const REAL t30 = 1.0 / minus_limb5_S_pivot_wz,
      t33 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t32, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t30 * t33;
    /* limb5_S: velocities, eq. (6); geometry */
    const REAL t44 = limb5_S_q_qy * t35 * limb5_S_null_space_wz_by_limb5_S_wy, t39 = limb5_S_q_qz * t35,
      t46 = 0.5 * (t39 - t44), t40 = 0.5 * t39, limb5_S_y_dot_qx = READ(y_dot, 0), limb5_S_y_dot_qy = READ(y_dot, 1),
      t47 = t40 * t46, t41 = t40 * limb5_S_y_dot_qx, t55 = limb5_S_y_dot_qy * t46,
      t49 = limb5_S_q_qx * t35 * limb5_S_null_space_wz_by_limb5_S_wy, t36 = limb5_S_q_qw * t35,
      t51 = 0.5 * (t36 + t49), t37 = 0.5 * t36, a_pivot = t47 + t37 * t51;
    REAL checked1 = a_pivot;
    const REAL t53 = 1.0 / a_pivot, limb5_S_joint_rate_wy = (t37 * limb5_S_y_dot_qy + t41) * t53,
      limb5_S_joint_rate_wz = t30 * (t33 * limb5_S_joint_rate_wy), t61 = platform_turn_yx * limb5_S_joint_rate_wy,
      minus_limb5_S_joint_rate_wx = t53 * (t55 - limb5_S_y_dot_qx * t51),
      t64 = t61 - platform_turn_xx * minus_limb5_S_joint_rate_wx, t65 = platform_turn_zy * limb5_S_joint_rate_wz,
      platform_omega_y = t65 + (platform_turn_yy * limb5_S_joint_rate_wy - platform_turn_xy * minus_limb5_S_joint_rate_wx);
    WRITE(v, 13, platform_omega_y);
    REAL checked2 = platform_omega_y;
    const REAL t71 = platform_turn_zz * limb5_S_joint_rate_wz, t72 = platform_turn_yz * limb5_S_joint_rate_wy,
      platform_turn_xz = t58 + t59, platform_omega_x = (t58 - t59) * limb5_S_joint_rate_wz + t64;
    WRITE(v, 12, platform_omega_x);
    REAL checked3 = platform_omega_x;
    RESULT(checked0, v, 14, t71 + (t72 - platform_turn_xz * minus_limb5_S_joint_rate_wx));
    const EACH4 signed_limb5_S_joint_rate_wy = {limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx},
      signed_limb5_S_joint_rate_wx = {minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy};
    FIRST_LIMB(0, velocity, 1, stride, v, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, signed_limb5_S_joint_rate_wx, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[0]);
    NEXT_LIMB(1, velocity, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(1, velocity, 1, stride, v, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, signed_limb5_S_joint_rate_wx, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, velocity, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(2, velocity, 1, stride, v, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, signed_limb5_S_joint_rate_wx, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, velocity, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(3, velocity, 1, stride, v, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy, signed_limb5_S_joint_rate_wx, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 signed_upper_position_x, minus_U_0_lever_mz_by_S_fz, t1, S_arm_x, t2, checked;
} LIMBS(null_space);

STAGE(null_space, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict sine,
    const double *restrict cosine, LIMBS(null_space) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, 1.0);
    /* each limb: geometry; reciprocal wrenches, eq. (10); rates that follow */
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(signed_upper_position_x) = signed_lower_sin * upper_offset_x + (-param_R);
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * upper_offset_x;
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = sign1 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    OWN(checked) = checked;
}

STAGE(null_space, 1)(size_t limb, size_t stride, double *restrict null_space, const double *restrict sine,
    const double *restrict cosine, REAL limb5_S_null_space_wz_by_limb5_S_qx,
    REAL limb5_S_null_space_wy_by_limb5_S_qx, REAL limb5_S_null_space_wx_by_limb5_S_qx,
    REAL limb5_S_null_space_wz_by_limb5_S_qy, REAL limb5_S_null_space_wy_by_limb5_S_qy,
    REAL limb5_S_null_space_wy_by_limb5_S_qy_2, LIMBS(null_space) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, 1.0, -1.0, 1.0),
      sign3 = OF4(1.0, -1.0, -1.0, -1.0), sign4 = OF4(1.0, 1.0, 1.0, -1.0), sign5 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 t19 = sign1 * limb5_S_null_space_wy_by_limb5_S_qx, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: rates that follow; reciprocal wrenches, eq. (10) */
    const LIMB4 t7 = U_0_cos * t19,
      t4 = OWN(signed_upper_position_x) * (U_0_cos * limb5_S_null_space_wz_by_limb5_S_qx - signed_U_0_sin * t19),
      U_null_space_0_by_limb5_S_qx = limb5_S_null_space_wx_by_limb5_S_qx - sign2 * (OWN(t1) * t4);
    WRITE4(null_space, 0, 3, 6, 9, U_null_space_0_by_limb5_S_qx);
    LIMB4 checked = OWN(checked) + U_null_space_0_by_limb5_S_qx;
    const LIMB4 t8 = signed_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qx + t7,
      signed_U_null_space_1_by_limb5_S_qx = OWN(t2) * (OWN(S_arm_x) * t8);
    WRITE4(null_space, 1, 4, 7, 10, sign4 * signed_U_null_space_1_by_limb5_S_qx);
    checked = checked + signed_U_null_space_1_by_limb5_S_qx;
    const LIMB4 signed_S_arm_y = param_R * IN_EACH4(SINES, cosine, 1, 2),
      signed_P_null_space_by_limb5_S_qx = signed_S_arm_y * t8;
    WRITE4(null_space, 2, 5, 8, 11, sign5 * signed_P_null_space_by_limb5_S_qx);
    checked = checked + signed_P_null_space_by_limb5_S_qx;
    const LIMB4 t11 = signed_U_0_sin * limb5_S_null_space_wy_by_limb5_S_qy,
      t14 = OWN(t1) * (OWN(signed_upper_position_x) * (t11 - U_0_cos * limb5_S_null_space_wz_by_limb5_S_qy)),
      signed_U_null_space_0_by_limb5_S_qy = t14 - sign3 * limb5_S_null_space_wy_by_limb5_S_qy_2;
    WRITE4(null_space, 15, 18, 21, 24, sign2 * signed_U_null_space_0_by_limb5_S_qy);
    checked = checked + signed_U_null_space_0_by_limb5_S_qy;
    const LIMB4 t15 = signed_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qy,
      t17 = t15 + U_0_cos * limb5_S_null_space_wy_by_limb5_S_qy,
      signed_P_null_space_by_limb5_S_qy = signed_S_arm_y * t17;
    WRITE4(null_space, 17, 20, 23, 26, sign5 * signed_P_null_space_by_limb5_S_qy);
    checked = checked + signed_P_null_space_by_limb5_S_qy;
    const LIMB4 signed_U_null_space_1_by_limb5_S_qy = OWN(t2) * (OWN(S_arm_x) * t17);
    WRITE4(null_space, 16, 19, 22, 25, sign4 * signed_U_null_space_1_by_limb5_S_qy);
    checked = checked + signed_U_null_space_1_by_limb5_S_qy;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_null_space)(size_t stride, const double *restrict q, double *restrict null_space,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(null_space) limbs;
    /* limb5_S: rates that follow */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6;
    /* limb5_S: geometry; rates that follow */
    const REAL t14 = t2 + t5, t63 = t2 + t4, t13 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t13 * t14,
      t9 = k2 - 0.5 * t7, platform_turn_xx = 1.0 - t6 * t13, platform_turn_zz = 1.0 - t13 * t63,
      t17 = limb5_S_q_qz * t13, t18 = limb5_S_q_qy * t17, t20 = limb5_S_q_qw * (limb5_S_q_qx * t13),
      t28 = limb5_S_q_qy * t13, platform_turn_zy = t18 + t20, platform_turn_yz = t18 - t20,
      limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1),
      t27 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy), /* limb1 */
      t29 = limb5_S_q_qx * t28, t53 = limb5_S_q_qw * t28, t30 = limb5_S_q_qw * t17, t52 = limb5_S_q_qx * t17,
      platform_turn_xy = t29 - t30, platform_turn_yx = t29 + t30;
    /* limb1: geometry; reciprocal wrenches, eq. (10); rates that follow */
    const REAL limb1_lower_sin = SINES(sine, 1),
      limb1_U2_constraint_mn_couple_z = t27 - limb1_lower_sin * platform_turn_xy;
    FIRST_LIMB(0, null_space, 0, stride, q, sine, cosine, &limbs);
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * (limb1_U2_constraint_mn_couple_z * limbs.t2[0]),
      t33 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t36 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t22 = limbs.signed_upper_position_x[0] * (limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0]),
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x + t22;
    /* limb5_S: pivots */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t33;
    REAL checked0 = minus_limb5_S_pivot_wz;
    /* limb5_S: rates that follow; geometry */
    const REAL t34 = 1.0 / minus_limb5_S_pivot_wz,
      t37 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t36, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t34 * t37, t44 = limb5_S_q_qy * t9 * limb5_S_null_space_wz_by_limb5_S_wy,
      t41 = limb5_S_q_qz * t9, t46 = 0.5 * (t41 - t44), t42 = 0.5 * t41, t47 = t42 * t46,
      t38 = limb5_S_q_qx * t9 * limb5_S_null_space_wz_by_limb5_S_wy, t10 = limb5_S_q_qw * t9, t40 = 0.5 * (t10 + t38),
      t48 = 0.5 * t10, a_pivot = t47 + t48 * t40;
    REAL checked1 = a_pivot;
    const REAL t50 = 1.0 / a_pivot, limb5_S_null_space_wy_by_limb5_S_qx = t42 * t50,
      limb5_S_null_space_wx_by_limb5_S_qx = t40 * t50, limb5_S_null_space_wy_by_limb5_S_qy = t48 * t50,
      t70 = t46 * t50, limb5_S_null_space_wz_by_limb5_S_qx = t34 * (t37 * limb5_S_null_space_wy_by_limb5_S_qx),
      limb5_S_null_space_wz_by_limb5_S_qy = t34 * (t37 * limb5_S_null_space_wy_by_limb5_S_qy);
    FIRST_LIMB(0, null_space, 1, stride, null_space, sine, cosine, limb5_S_null_space_wz_by_limb5_S_qx, limb5_S_null_space_wy_by_limb5_S_qx, limb5_S_null_space_wx_by_limb5_S_qx, limb5_S_null_space_wz_by_limb5_S_qy, limb5_S_null_space_wy_by_limb5_S_qy, t70, &limbs);
    REAL checked2 = ALONE(limbs.checked[0]);
    const REAL platform_turn_zx = t52 - t53, platform_turn_xz = t52 + t53,
      t54 = platform_turn_zx * limb5_S_null_space_wz_by_limb5_S_qx,
      t71 = platform_turn_zx * limb5_S_null_space_wz_by_limb5_S_qy,
      t55 = platform_turn_yx * limb5_S_null_space_wy_by_limb5_S_qx,
      t72 = platform_turn_yx * limb5_S_null_space_wy_by_limb5_S_qy,
      limb5_S_null_space_wx_by_limb5_S_qx_2 = t54 + (t55 + platform_turn_xx * limb5_S_null_space_wx_by_limb5_S_qx);
    WRITE(null_space, 12, limb5_S_null_space_wx_by_limb5_S_qx_2);
    REAL checked3 = limb5_S_null_space_wx_by_limb5_S_qx_2;
    RESULT(checked0, null_space, 27, t71 + (t72 - platform_turn_xx * t70));
    const REAL t59 = platform_turn_zy * limb5_S_null_space_wz_by_limb5_S_qx,
      t75 = platform_turn_zy * limb5_S_null_space_wz_by_limb5_S_qy,
      t60 = platform_turn_yy * limb5_S_null_space_wy_by_limb5_S_qx,
      t76 = platform_turn_yy * limb5_S_null_space_wy_by_limb5_S_qy;
    RESULT(checked1, null_space, 13, t59 + (t60 + platform_turn_xy * limb5_S_null_space_wx_by_limb5_S_qx));
    RESULT(checked2, null_space, 28, t75 + (t76 - platform_turn_xy * t70));
    const REAL t65 = platform_turn_zz * limb5_S_null_space_wz_by_limb5_S_qx,
      t79 = platform_turn_zz * limb5_S_null_space_wz_by_limb5_S_qy,
      t66 = platform_turn_yz * limb5_S_null_space_wy_by_limb5_S_qx,
      t80 = platform_turn_yz * limb5_S_null_space_wy_by_limb5_S_qy;
    RESULT(checked3, null_space, 14, t65 + (t66 + platform_turn_xz * limb5_S_null_space_wx_by_limb5_S_qx));
    RESULT(checked0, null_space, 29, t79 + (t80 - platform_turn_xz * t70));
    NEXT_LIMB(1, null_space, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(1, null_space, 1, stride, null_space, sine, cosine, limb5_S_null_space_wz_by_limb5_S_qx, limb5_S_null_space_wx_by_limb5_S_qx, limb5_S_null_space_wy_by_limb5_S_qx, limb5_S_null_space_wz_by_limb5_S_qy, t70, limb5_S_null_space_wy_by_limb5_S_qy, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, null_space, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(2, null_space, 1, stride, null_space, sine, cosine, limb5_S_null_space_wz_by_limb5_S_qx, limb5_S_null_space_wy_by_limb5_S_qx, limb5_S_null_space_wx_by_limb5_S_qx, limb5_S_null_space_wz_by_limb5_S_qy, limb5_S_null_space_wy_by_limb5_S_qy, t70, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, null_space, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(3, null_space, 1, stride, null_space, sine, cosine, limb5_S_null_space_wz_by_limb5_S_qx, limb5_S_null_space_wx_by_limb5_S_qx, limb5_S_null_space_wy_by_limb5_S_qx, limb5_S_null_space_wz_by_limb5_S_qy, t70, limb5_S_null_space_wy_by_limb5_S_qy, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 upper_position_x, minus_U_0_lever_mz_by_S_fz, t1, S_arm_x, t2, t3, t4, t5, t6, t7, t8, t9, t10,
      t11, signed_S_arm_y, t12, t13, checked;
} LIMBS(acceleration);

STAGE(acceleration, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict sine, const double *restrict cosine, LIMBS(acceleration) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = -sign1 * param_R,
      sign2 = OF4(1.0, -1.0, 1.0, -1.0), each_param_R_2 = sign1 * param_R;
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3), P_v = IN_EACH4(READ, v, 2, 3);
    /* each limb: accelerations; reciprocal wrenches, eq. (10); geometry */
    OWN(t9) = U_v_1 * P_v;
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    OWN(signed_S_arm_y) = param_R * lower_cos;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2), t8 = sign1 * signed_lower_sin,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    OWN(upper_position_x) = t8 * upper_offset_x + each_param_R;
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * upper_offset_x;
    LIMB4 checked = OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t1) = sign2 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    const LIMB4 t2 = U_v_1 * t8, upper_twist_vx = P_v * t8;
    OWN(t12) = param_R * t2;
    OWN(t4) = P_v * lower_cos - upper_offset_x * t2;
    OWN(t5) = IN_EACH4(READ, v, 0, 3) * (sign2 * OWN(t4));
    const LIMB4 t5 = U_v_1 * lower_cos;
    OWN(t7) = upper_twist_vx + upper_offset_x * t5;
    OWN(t10) = each_param_R_2 * t5 - P_v;
    OWN(checked) = checked;
}

STAGE(acceleration, 1)(size_t limb, size_t stride, const double *restrict v, const double *restrict sine,
    const double *restrict cosine, const EACH4 platform_twist_wy, REAL platform_twist_wz,
    const EACH4 platform_twist_wx, LIMBS(acceleration) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 t17 = sign1 * GIVEN(platform_twist_wy), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: accelerations */
    const LIMB4 t1 = U_0_cos * t17;
    OWN(t6) = signed_U_0_sin * t17 - U_0_cos * platform_twist_wz;
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), t11 = U_v_0 * OWN(t6), t8 = OWN(t6) * OWN(t7),
      t15 = OWN(signed_S_arm_y) * t11, t12 = OWN(S_arm_x) * t11;
    OWN(t3) = t1 + signed_U_0_sin * platform_twist_wz;
    OWN(t13) = t15 + OWN(t3) * OWN(t12);
    OWN(t11) = t12 + sign1 * OWN(t9) + OWN(t3) * OWN(t10);
    const LIMB4 t9 = OWN(t5) - OWN(upper_position_x) * (U_v_0 * OWN(t3)) - t8;
    OWN(t8) = t9 - GIVEN(platform_twist_wx) * (sign1 * OWN(t4));
}

STAGE(acceleration, 2)(size_t limb, size_t stride, double *restrict a, const double *restrict sine,
    const double *restrict cosine, REAL given, const EACH4 signed_limb5_S_joint_acc_wy,
    const EACH4 signed_limb5_S_joint_acc_wx, REAL minus_limb5_S_joint_acc_still_wz, LIMBS(acceleration) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: accelerations */
    const LIMB4 t12 = signed_U_0_sin * given + U_0_cos * GIVEN(signed_limb5_S_joint_acc_wy),
      t18 = OWN(signed_S_arm_y) * t12, t13 = OWN(S_arm_x) * t12,
      t14 = signed_U_0_sin * minus_limb5_S_joint_acc_still_wz,
      signed_P_joint_acc = t18 - (OWN(t13) + OWN(signed_S_arm_y) * t14);
    WRITE4(a, 2, 5, 8, 11, sign2 * signed_P_joint_acc);
    LIMB4 checked = OWN(checked) + signed_P_joint_acc;
    const LIMB4 U_joint_acc_1 = OWN(t2) * (t13 - (OWN(t11) + OWN(S_arm_x) * t14));
    WRITE4(a, 1, 4, 7, 10, U_joint_acc_1);
    checked = checked + U_joint_acc_1;
    const LIMB4 t4 = OWN(upper_position_x) * (U_0_cos * given - signed_U_0_sin * GIVEN(signed_limb5_S_joint_acc_wy)),
      t6 = sign1 * GIVEN(signed_limb5_S_joint_acc_wx) + OWN(t1) * t4,
      U_joint_acc_0 = OWN(t1) * (OWN(upper_position_x) * (U_0_cos * minus_limb5_S_joint_acc_still_wz) - OWN(t8)) - t6;
    WRITE4(a, 0, 3, 6, 9, U_joint_acc_0);
    checked = checked + U_joint_acc_0;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_acceleration)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict y_ddot, double *restrict a, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    LIMBS(acceleration) limbs;
    /* limb5_S: accelerations */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6;
    /* limb5_S: geometry; accelerations; velocities, eq. (6) */
    const REAL t15 = t2 + t5, t65 = t2 + t4, t14 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t14 * t15,
      platform_turn_xx = 1.0 - t6 * t14, platform_turn_zz = 1.0 - t14 * t65, t9 = k2 - 0.5 * t7,
      t29 = limb5_S_q_qy * t14, t30 = limb5_S_q_qx * t29, t60 = limb5_S_q_qw * t29, t18 = limb5_S_q_qz * t14,
      t21 = limb5_S_q_qw * (limb5_S_q_qx * t14), t31 = limb5_S_q_qw * t18, platform_turn_yx = t30 + t31,
      platform_turn_xy = t30 - t31, limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13),
      t53 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, t19 = limb5_S_q_qy * t18,
      t59 = limb5_S_q_qx * t18, platform_turn_yz = t19 - t21, platform_turn_zy = t19 + t21,
      limb5_S_v_wz = READ(v, 14), platform_twist_wy = t53 + limb5_S_v_wz * platform_turn_yz,
      t58 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy, platform_turn_xz = t59 + t60,
      platform_turn_zx = t59 - t60, platform_twist_wx = t58 + limb5_S_v_wz * platform_turn_xz;
    const EACH4 platform_twist_wy_2 = {platform_twist_wy, platform_twist_wx, platform_twist_wy, platform_twist_wx},
      platform_twist_wx_2 = {platform_twist_wx, platform_twist_wy, platform_twist_wx, platform_twist_wy};
    const REAL t70 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t70;
    FIRST_LIMB(0, acceleration, 0, stride, q, v, sine, cosine, &limbs);
    FIRST_LIMB(0, acceleration, 1, stride, v, sine, cosine, platform_twist_wy_2, platform_twist_wz, platform_twist_wx_2, &limbs);
    /* limb1: geometry; accelerations; loop closure */
    const REAL limb1_lower_sin = SINES(sine, 1), limb1_lower_cos = SINES(cosine, 1), limb1_U_v_0 = READ(v, 0),
      t98 = limb1_lower_sin * limbs.t6[0] + limb1_lower_cos * platform_twist_wx,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, t99 = limb1_lower_omega_y - t98, limb1_U_v_1 = READ(v, 1),
      t100 = limb1_U_v_1 * t99, t94 = limb1_U_v_1 - limbs.t3[0], limb1_U_0_sin = SINES(sine, 0),
      limb1_U_0_cos = SINES(cosine, 0);
    /* limb1: loop closure; reciprocal wrenches, eq. (10); rates that follow */
    const REAL t102 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t94 - t100),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t103 = limb1_U2_constraint_mn_couple_x * t102, limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin,
      t104 = limb1_lower_omega_x * t99,
      t108 = limb1_lower_omega_x + (limb1_lower_cos * limbs.t6[0] - limb1_lower_sin * platform_twist_wx),
      t110 = t104 - limb1_lower_omega_y * t108,
      t27 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t113 = limb1_lower_sin * t27,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t27 - limb1_lower_sin * platform_turn_xy,
      t112 = t103 - limb1_U2_constraint_mn_couple_z * t110,
      limb1_U2_opening_mn = t113 + limb1_lower_cos * platform_turn_xy,
      t118 = t108 * (limb1_U2_opening_mn * t108 + limb1_U2_constraint_mn_couple_z * t99),
      limb1_U2_opening_bias_mn = t112 - (t118 - t94 * (limb1_U2_constraint_mn_couple_x * t99 - limb1_U2_opening_mn * t94)),
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t2[0],
      t125 = limb1_U2_opening_bias_mn - limbs.t11[0] * limb1_U_factor_1_by_3, /* limb5_S */
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x;
    /* limb5_S: accelerations; pivots; rates that follow */
    const REAL t126 = minus_limb1_U_factor_0_by_3 * limbs.t8[0] - t125,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn + limbs.upper_position_x[0] * minus_limb1_U_factor_0_by_3,
      t37 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3, /* limb1 */
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    REAL checked0 = minus_limb5_S_pivot_wz;
    const REAL t35 = 1.0 / minus_limb5_S_pivot_wz, minus_limb5_S_joint_acc_still_wz = t35 * t126,
      t38 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t37, /* limb1 */
      t12 = limb5_S_q_qy * t9, t145 = 0.5 * (t12 * minus_limb5_S_joint_acc_still_wz), t83 = platform_twist_wx * t12,
      t45 = limb5_S_q_qx * t9, t85 = t83 - platform_twist_wy * t45, t43 = limb5_S_q_qw * t9, t10 = limb5_S_q_qz * t9,
      t87 = 0.5 * (platform_twist_wz * t43 + t85), t132 = platform_twist_wy * t87, t88 = platform_twist_wx * t87,
      t138 = 0.5 * (platform_twist_wy * t43 + (platform_twist_wz * t45 - platform_twist_wx * t10)),
      t140 = t132 - platform_twist_wz * t138,
      t73 = 0.5 * (platform_twist_wx * t45 + platform_twist_wy * t12 + platform_twist_wz * t10),
      t146 = READ(y_ddot, 0) + 0.5 * (platform_twist_wx * t73 - t140) - t145, t75 = platform_twist_wx * t43,
      t74 = platform_twist_wy * t73, t76 = platform_twist_wy * t10, t11 = 0.5 * t10, t149 = t11 * t146,
      t128 = 0.5 * (t45 * minus_limb5_S_joint_acc_still_wz),
      t89 = platform_twist_wz * (0.5 * (t75 + (t76 - platform_twist_wz * t12))) - t88,
      t129 = READ(y_ddot, 1) + 0.5 * (t74 - t89) + t128, t44 = 0.5 * t43, t151 = t149 + t44 * t129,
      limb5_S_null_space_wz_by_limb5_S_wy = t35 * t38, t47 = t43 + t45 * limb5_S_null_space_wz_by_limb5_S_wy,
      t41 = 0.5 * (t10 - t12 * limb5_S_null_space_wz_by_limb5_S_wy), t42 = t11 * t41, t130 = t41 * t129,
      t48 = 0.5 * t47, a_pivot = t42 + t44 * t48;
    REAL checked1 = a_pivot;
    const REAL t148 = t130 - t48 * t146, t50 = 1.0 / a_pivot, limb5_S_joint_acc_wy = t151 * t50,
      minus_limb5_S_joint_acc_wx = t50 * t148, t153 = t35 * (t38 * limb5_S_joint_acc_wy);
    /* limb5_S: results; accelerations */
    const REAL t156 = platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx,
      t160 = platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx,
      t164 = platform_turn_yz * limb5_S_joint_acc_wy - platform_turn_xz * minus_limb5_S_joint_acc_wx,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz - t153,
      limb5_S_a_wx = t156 - platform_turn_zx * minus_limb5_S_joint_acc_wz;
    WRITE(a, 12, limb5_S_a_wx);
    REAL checked2 = limb5_S_a_wx;
    const REAL limb5_S_a_wy = t160 - platform_turn_zy * minus_limb5_S_joint_acc_wz;
    WRITE(a, 13, limb5_S_a_wy);
    REAL checked3 = limb5_S_a_wy;
    RESULT(checked0, a, 14, t164 - platform_turn_zz * minus_limb5_S_joint_acc_wz);
    const EACH4 signed_limb5_S_joint_acc_wy = {limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx, limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx},
      signed_limb5_S_joint_acc_wx = {minus_limb5_S_joint_acc_wx, limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx, limb5_S_joint_acc_wy};
    FIRST_LIMB(0, acceleration, 2, stride, a, sine, cosine, t153, signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_still_wz, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[0]);
    NEXT_LIMB(1, acceleration, 0, stride, q, v, sine, cosine, &limbs);
    NEXT_LIMB(1, acceleration, 1, stride, v, sine, cosine, platform_twist_wy_2, platform_twist_wz, platform_twist_wx_2, &limbs);
    NEXT_LIMB(1, acceleration, 2, stride, a, sine, cosine, t153, signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_still_wz, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, acceleration, 0, stride, q, v, sine, cosine, &limbs);
    NEXT_LIMB(2, acceleration, 1, stride, v, sine, cosine, platform_twist_wy_2, platform_twist_wz, platform_twist_wx_2, &limbs);
    NEXT_LIMB(2, acceleration, 2, stride, a, sine, cosine, t153, signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_still_wz, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, acceleration, 0, stride, q, v, sine, cosine, &limbs);
    NEXT_LIMB(3, acceleration, 1, stride, v, sine, cosine, platform_twist_wy_2, platform_twist_wz, platform_twist_wx_2, &limbs);
    NEXT_LIMB(3, acceleration, 2, stride, a, sine, cosine, t153, signed_limb5_S_joint_acc_wy, signed_limb5_S_joint_acc_wx, minus_limb5_S_joint_acc_still_wz, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 minus_U_0_lever_mz_by_S_fz, t1, signed_S_opening_fz, signed_upper_position_x, S_arm_x, t2, t3, t4,
      signed_S_opening_fy, signed_S_arm_y, t5, t6, signed_P_null_space_by_limb5_S_wy, t7,
      signed_U_null_space_1_by_limb5_S_wy, signed_U_null_space_0_by_limb5_S_wy, t8, t9, S_opening_fx, t10,
      t11, t12, t13, P_q_next, t14, t15, t16, checked;
} LIMBS(close_position);

STAGE(close_position, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict sine,
    const double *restrict cosine, REAL given, REAL given_2, REAL given_3, REAL given_4,
    LIMBS(close_position) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, -1.0),
      sign3 = OF4(1.0, 1.0, -1.0, 1.0);
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: reciprocal wrenches, eq. (10); geometry; rates that follow */
    OWN(signed_S_arm_y) = param_R * lower_cos;
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(signed_upper_position_x) = signed_lower_sin * upper_offset_x + (-param_R);
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * upper_offset_x;
    OWN(t1) = 1.0 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    const LIMB4 U_0_sin = OF4(SINES(sine, 0), SINES(cosine, 2), SINES(sine, 4), SINES(cosine, 6)),
      t8 = sign2 * (given - sign1 * given_2), minus_lower_rotation_yx = U_0_sin * lower_cos;
    /* each limb: loop closure; geometry; results */
    const LIMB4 t1 = upper_offset_x * minus_lower_rotation_yx - t8;
    OWN(t9) = minus_lower_rotation_yx * t1;
    OWN(t3) = U_0_sin * signed_lower_sin * t1;
    const LIMB4 signed_U_0_cos = OF4(SINES(cosine, 0), SINES(sine, 2), SINES(cosine, 4), SINES(sine, 6)),
      t2 = signed_U_0_cos * t1, t10 = sign3 * (given_3 - sign1 * given_4),
      signed_lower_rotation_zx = signed_U_0_cos * lower_cos, t3 = upper_offset_x * signed_lower_rotation_zx + t10;
    OWN(t8) = signed_lower_rotation_zx * t3;
    OWN(t4) = signed_U_0_cos * signed_lower_sin * t3;
    OWN(signed_S_opening_fz) = t2 - U_0_sin * t3;
    const LIMB4 t6 = per_length * OWN(signed_S_opening_fz);
    OWN(t16) = t6 * t6;
}

STAGE(close_position, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, REAL given_2, REAL given_3, REAL given_4,
    REAL limb5_S_null_space_wz_by_limb5_S_wy, REAL given_5, REAL given_6, LIMBS(close_position) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0);
    /* each limb: rates that follow; loop closure; results */
    OWN(t5) = OF4(SINES(cosine, 0), SINES(sine, 2), SINES(cosine, 4), SINES(sine, 6)) * limb5_S_null_space_wz_by_limb5_S_wy;
    OWN(t6) = OF4(SINES(sine, 0), SINES(cosine, 2), SINES(sine, 4), SINES(cosine, 6)) * limb5_S_null_space_wz_by_limb5_S_wy;
    const LIMB4 t1 = OWN(signed_upper_position_x) + sign2 * (given - sign1 * given_2);
    OWN(S_opening_fx) = IN_EACH4(SINES, sine, 1, 2) * t1 + given_5 + given_6;
    const LIMB4 t6 = (-per_length) * OWN(S_opening_fx);
    OWN(t14) = t6 * t6;
    OWN(signed_S_opening_fy) = given_4 - (IN_EACH4(SINES, cosine, 1, 2) * t1 - given_3);
    const LIMB4 t7 = per_length * OWN(signed_S_opening_fy);
    OWN(t15) = t7 * t7;
}

STAGE(close_position, 2)(size_t limb, size_t stride, REAL given, REAL given_2, LIMBS(close_position) *own)
{
    (void)limb, (void)stride;
    /* each limb: rates that follow; results; pivots */
    OWN(signed_P_null_space_by_limb5_S_wy) = OWN(signed_S_arm_y) * given;
    OWN(t7) = 2.2795812745707664 * OWN(signed_P_null_space_by_limb5_S_wy);
    OWN(t10) = OWN(signed_P_null_space_by_limb5_S_wy) * OWN(t7);
    OWN(signed_U_null_space_1_by_limb5_S_wy) = OWN(t2) * (OWN(S_arm_x) * given);
    OWN(t11) = OWN(signed_U_null_space_1_by_limb5_S_wy) * OWN(signed_U_null_space_1_by_limb5_S_wy);
    OWN(signed_U_null_space_0_by_limb5_S_wy) = OWN(t1) * given_2;
    OWN(t12) = OWN(signed_U_null_space_0_by_limb5_S_wy) * OWN(signed_U_null_space_0_by_limb5_S_wy);
}

STAGE(close_position, 3)(size_t limb, size_t stride, const double *restrict q, double *restrict q_next,
    REAL given, REAL given_2, REAL given_3, REAL given_4, REAL P_q, LIMBS(close_position) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0);
    const LIMB4 t6 = sign1 * given;
    /* each limb: results */
    OWN(t13) = OWN(signed_U_null_space_1_by_limb5_S_wy) * t6;
    const LIMB4 U_q_next_0 = IN_EACH4(READ, q, 0, 3) - (given_3 - sign2 * (given_2 - OWN(signed_U_null_space_0_by_limb5_S_wy) * t6));
    WRITE4(q_next, 0, 3, 6, 9, U_q_next_0);
    LIMB4 checked = U_q_next_0;
    OWN(P_q_next) = P_q + (sign2 * given_4 + OWN(signed_P_null_space_by_limb5_S_wy) * t6);
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_close_position)(size_t stride, const double *restrict q, double *restrict q_next,
    double *restrict residual_, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    LIMBS(close_position) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t19 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), t21 = param_H * (1.0 - t9 * t19),
      t46 = 0.5 * (1.0 - t6 * t9), t12 = limb5_S_q_qz * t9, t15 = limb5_S_q_qy * t12,
      t17 = limb5_S_q_qw * (limb5_S_q_qx * t9), t10 = limb5_S_q_qy * t9, platform_turn_zy = t15 + t17,
      t18 = param_H * (t15 - t17), limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      t36 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t37 = limb1_lower_cos * t36, /* limb1 */
      t43 = limb1_lower_sin * t36, /* limb1 */
      t11 = limb5_S_q_qx * t10, t24 = limb5_S_q_qw * t10, t13 = limb5_S_q_qw * t12, t23 = limb5_S_q_qx * t12,
      platform_turn_xy = t11 - t13, t14 = 0.5 * (t11 + t13),
      limb1_U2_constraint_mn_couple_z = t37 - limb1_lower_sin * platform_turn_xy, platform_turn_xz = t23 + t24,
      t25 = 0.5 * (t23 - t24), t26 = param_H * platform_turn_xz;
    FIRST_LIMB(0, close_position, 0, stride, q, sine, cosine, t14, t18, t25, t21, &limbs);
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; pivots */
    REAL checked0 = limbs.minus_U_0_lever_mz_by_S_fz[0];
    NEXT_LIMB(2, close_position, 0, stride, q, sine, cosine, t14, t18, t25, t21, &limbs);
    REAL checked1 = limbs.minus_U_0_lever_mz_by_S_fz[2];
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t2[0],
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      t40 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t77 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      t31 = limb1_U_0_sin * platform_turn_zy, t22 = 0.5 * platform_turn_zy, /* platform */
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + t31,
      t47 = 0.5 * platform_turn_yy, /* platform */
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn + limbs.signed_upper_position_x[0] * minus_limb1_U_factor_0_by_3,
      t42 = limbs.signed_S_opening_fz[0] * minus_limb1_U_factor_0_by_3;
    /* limb5_S: pivots; results; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t40;
    REAL checked2 = minus_limb5_S_pivot_wz;
    const REAL t41 = 1.0 / minus_limb5_S_pivot_wz,
      limb5_S_null_space_wz_by_limb5_S_wy = t41 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t77);
    FIRST_LIMB(0, close_position, 1, stride, sine, cosine, t46, t26, limbs.t3[0], limbs.t4[0], limb5_S_null_space_wz_by_limb5_S_wy, limbs.t9[0], limbs.t8[0], &limbs);
    const REAL t48 = limbs.signed_S_opening_fy[0] * limb1_U_factor_1_by_3; /* limb1 */
    NEXT_LIMB(2, close_position, 1, stride, sine, cosine, t46, t26, limbs.t3[2], limbs.t4[2], limb5_S_null_space_wz_by_limb5_S_wy, limbs.t9[2], limbs.t8[2], &limbs);
    const REAL limb1_U2_opening_mn = t43 + limb1_lower_cos * platform_turn_xy;
    /* mechanism: results; balance, eqs. (40)-(47); pivots */
    const REAL t51 = t41 * (t42 - (limb1_U2_opening_mn + t48)), t27 = 0.5 * platform_turn_xy,
      t252 = limb1_U2_opening_mn * limb1_U2_opening_mn, /* limb1 */
      t157 = limb1_U_0_sin * t51, t163 = limbs.t2[0] * (limbs.signed_S_opening_fy[0] - limbs.S_arm_x[0] * t157),
      t159 = limbs.S_opening_fx[0] + limbs.signed_S_arm_y[0] * t157,
      t263 = -(limbs.signed_upper_position_x[0] * (limb1_U_0_sin - limbs.t5[0]));
    FIRST_LIMB(0, close_position, 2, stride, limb1_U_0_cos + limbs.t6[0], t263, &limbs);
    const REAL t253 = limbs.t14[0] + limbs.t15[0] + limbs.t16[0] + t252, /* limb1 */
      t164 = limbs.signed_U_null_space_1_by_limb5_S_wy[0] * t163,
      t55 = limbs.t1[0] * (limbs.signed_S_opening_fz[0] - limbs.signed_upper_position_x[0] * (limb1_U_0_cos * t51)),
      limb2_U_0_sin = SINES(cosine, 2),
      t167 = t164 + limbs.signed_U_null_space_0_by_limb5_S_wy[0] * t55 - limbs.t7[0] * t159, t268 = -t159,
      t124 = limb2_U_0_sin * t51;
    NEXT_LIMB(1, close_position, 0, stride, q, sine, cosine, t21, t22, t26, t27, &limbs);
    NEXT_LIMB(3, close_position, 0, stride, q, sine, cosine, t21, t22, t26, t27, &limbs);
    const REAL t127 = limbs.t1[1] * (limbs.signed_upper_position_x[1] * t124 - limbs.signed_S_opening_fz[1]);
    NEXT_LIMB(1, close_position, 1, stride, sine, cosine, t18, t47, limbs.t4[1], limbs.t3[1], limb5_S_null_space_wz_by_limb5_S_wy, limbs.t8[1], limbs.t9[1], &limbs);
    NEXT_LIMB(3, close_position, 1, stride, sine, cosine, t18, t47, limbs.t4[3], limbs.t3[3], limb5_S_null_space_wz_by_limb5_S_wy, limbs.t8[3], limbs.t9[3], &limbs);
    const REAL t259 = t253 + limbs.t14[1] + limbs.t15[1] + limbs.t16[1] + limbs.t14[2] + limbs.t15[2] + limbs.t16[2],
      residual_residual = SQRT(t259 + limbs.t14[3] + limbs.t15[3] + limbs.t16[3]);
    WRITE(residual_, 0, residual_residual);
    REAL checked3 = residual_residual;
    NEXT_LIMB(1, close_position, 2, stride, limbs.t5[1], limbs.minus_U_0_lever_mz_by_S_fz[1] + limbs.signed_upper_position_x[1] * limbs.t6[1], &limbs);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2),
      t168 = limbs.signed_U_null_space_0_by_limb5_S_wy[1] * t127 - t167, t116 = minus_limb2_U_0_cos * t51,
      t122 = limbs.t2[1] * (limbs.signed_S_opening_fy[1] + limbs.S_arm_x[1] * t116),
      t118 = limbs.S_opening_fx[1] - limbs.signed_S_arm_y[1] * t116, limb3_U_0_cos = SINES(cosine, 4),
      t170 = limbs.t7[1] * t118 - (limbs.signed_U_null_space_1_by_limb5_S_wy[1] * t122 + t168),
      t135 = limbs.t1[2] * (limbs.signed_S_opening_fz[2] + limbs.signed_upper_position_x[2] * (limb3_U_0_cos * t51)),
      limb3_U_0_sin = SINES(sine, 4), t264 = -(limbs.signed_upper_position_x[2] * (limb3_U_0_sin - limbs.t5[2]));
    NEXT_LIMB(2, close_position, 2, stride, limb3_U_0_cos + limbs.t6[2], t264, &limbs);
    const REAL t171 = limbs.signed_U_null_space_0_by_limb5_S_wy[2] * t135 - t170, t145 = limb3_U_0_sin * t51,
      t151 = limbs.t2[2] * (limbs.signed_S_opening_fy[2] + limbs.S_arm_x[2] * t145),
      t147 = limbs.signed_S_arm_y[2] * t145 - limbs.S_opening_fx[2], limb4_U_0_sin = SINES(cosine, 6),
      t173 = limbs.t7[2] * t147 + (limbs.signed_U_null_space_1_by_limb5_S_wy[2] * t151 + t171),
      t114 = limbs.t1[3] * (limbs.signed_S_opening_fz[3] + limbs.signed_upper_position_x[3] * (limb4_U_0_sin * t51));
    NEXT_LIMB(3, close_position, 2, stride, limbs.t5[3], limbs.minus_U_0_lever_mz_by_S_fz[3] - limbs.signed_upper_position_x[3] * limbs.t6[3], &limbs);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6),
      t174 = t173 - limbs.signed_U_null_space_0_by_limb5_S_wy[3] * t114, t103 = minus_limb4_U_0_cos * t51,
      t109 = limbs.t2[3] * (limbs.signed_S_opening_fy[3] - limbs.S_arm_x[3] * t103),
      t105 = limbs.S_opening_fx[3] + limbs.signed_S_arm_y[3] * t103,
      t176 = limbs.t7[3] * t105 - (limbs.signed_U_null_space_1_by_limb5_S_wy[3] * t109 - t174),
      t177 = limb5_S_null_space_wz_by_limb5_S_wy * t51 + t176,
      limb2_U_null_space_0_by_limb5_S_wx = limbs.t1[1] * (minus_limb2_U_0_cos * limbs.signed_upper_position_x[1]),
      t129 = limb2_U_null_space_0_by_limb5_S_wx * t127 + t55,
      limb2_U_null_space_1_by_limb5_S_wx = limb2_U_0_sin * limbs.S_arm_x[1] * limbs.t2[1],
      minus_platform_joint_force_mx_by_limb2_P = limb2_U_0_sin * limbs.signed_S_arm_y[1],
      t130 = limb2_U_null_space_1_by_limb5_S_wx * t122 - t129,
      t62 = 2.2795812745707664 * minus_platform_joint_force_mx_by_limb2_P, t136 = t62 * t118 - t130 + t135,
      t63 = minus_platform_joint_force_mx_by_limb2_P * t62,
      minus_limb4_U_null_space_0_by_limb5_S_wx = limbs.t1[3] * (minus_limb4_U_0_cos * limbs.signed_upper_position_x[3]),
      t137 = minus_limb4_U_null_space_0_by_limb5_S_wx * t114 + t136, t267 = -t114,
      limb4_U_null_space_1_by_limb5_S_wx = limb4_U_0_sin * limbs.S_arm_x[3] * limbs.t2[3],
      platform_joint_force_mx_by_limb4_P = limb4_U_0_sin * limbs.signed_S_arm_y[3],
      t138 = limb4_U_null_space_1_by_limb5_S_wx * t109 + t137,
      t56 = 2.2795812745707664 * platform_joint_force_mx_by_limb4_P, t139 = t56 * t105 - t138,
      t57 = platform_joint_force_mx_by_limb4_P * t56,
      t93 = limbs.signed_U_null_space_0_by_limb5_S_wy[0] - limb2_U_null_space_0_by_limb5_S_wx * limbs.signed_U_null_space_0_by_limb5_S_wy[1],
      t94 = limb2_U_null_space_1_by_limb5_S_wx * limbs.signed_U_null_space_1_by_limb5_S_wy[1] + t93,
      t96 = minus_platform_joint_force_mx_by_limb2_P * limbs.t7[1] + t94 - limbs.signed_U_null_space_0_by_limb5_S_wy[2],
      t98 = t96 + minus_limb4_U_null_space_0_by_limb5_S_wx * limbs.signed_U_null_space_0_by_limb5_S_wy[3],
      t100 = t98 + limb4_U_null_space_1_by_limb5_S_wx * limbs.signed_U_null_space_1_by_limb5_S_wy[3],
      t101 = platform_joint_force_mx_by_limb4_P * limbs.t7[3] + t100,
      t66 = 1.0 + limb2_U_null_space_0_by_limb5_S_wx * limb2_U_null_space_0_by_limb5_S_wx; /* limb2 */
    /* mechanism: pivots; results */
    const REAL t71 = 1.0 + (t63 + (t66 + limb2_U_null_space_1_by_limb5_S_wx * limb2_U_null_space_1_by_limb5_S_wx)),
      t72 = minus_limb4_U_null_space_0_by_limb5_S_wx * minus_limb4_U_null_space_0_by_limb5_S_wx + t71,
      pivot_0 = 1.0 + (t57 + (limb4_U_null_space_1_by_limb5_S_wx * limb4_U_null_space_1_by_limb5_S_wx + t72));
    checked0 = checked0 + pivot_0;
    const REAL t75 = 1.0 / pivot_0, t102 = t75 * t101, t179 = t101 * t102, t196 = t75 * t139,
      t178 = t102 * t139 - t177,
      t185 = limbs.t10[1] + (limbs.t11[1] + (limbs.t12[1] + (limbs.t10[0] + (limbs.t11[0] + limbs.t12[0])))),
      t191 = limbs.t10[3] + (limbs.t11[3] + (limbs.t12[3] + (limbs.t10[2] + (limbs.t11[2] + (limbs.t12[2] + t185))))),
      minus_pivot_1 = t179 - (limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_null_space_wz_by_limb5_S_wy + (1.0 + t191));
    checked1 = checked1 + minus_pivot_1;
    const REAL t194 = t178 / minus_pivot_1, t197 = t102 * t194 - t196, limb1_P_q = READ(q, 2);
    FIRST_LIMB(0, close_position, 3, stride, q, q_next, t194, t197, t55, t268, limb1_P_q, &limbs);
    WRITE(q_next, 2, limbs.P_q_next[0]);
    checked2 = checked2 + limbs.P_q_next[0];
    checked3 = checked3 + ALONE(limbs.checked[0]);
    const REAL limb3_P_q = READ(q, 8);
    NEXT_LIMB(2, close_position, 3, stride, q, q_next, t194, t197, t135, t147, limb3_P_q, &limbs);
    WRITE(q_next, 8, limbs.P_q_next[2]);
    checked0 = checked0 + limbs.P_q_next[2];
    checked1 = checked1 + ALONE(limbs.checked[2]);
    RESULT(checked2, q_next, 1, READ(q, 1) + (t163 + limbs.t13[0]));
    RESULT(checked3, q_next, 7, READ(q, 7) - (t151 + limbs.t13[2]));
    NEXT_LIMB(1, close_position, 3, stride, q, q_next, t194, -(limb2_U_null_space_0_by_limb5_S_wx * t197), t127, minus_platform_joint_force_mx_by_limb2_P * t197, t118, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[1]);
    RESULT(checked1, q_next, 4, READ(q, 4) + (t122 - (limbs.t13[1] - limb2_U_null_space_1_by_limb5_S_wx * t197)));
    const REAL limb2_P_q = READ(q, 5);
    RESULT(checked2, q_next, 5, limb2_P_q - limbs.P_q_next[1]);
    NEXT_LIMB(3, close_position, 3, stride, q, q_next, t194, -(minus_limb4_U_null_space_0_by_limb5_S_wx * t197), t267, platform_joint_force_mx_by_limb4_P * t197, t105, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[3]);
    RESULT(checked0, q_next, 10, READ(q, 10) - (t109 - (limbs.t13[3] + limb4_U_null_space_1_by_limb5_S_wx * t197)));
    const REAL limb4_P_q = READ(q, 11);
    RESULT(checked1, q_next, 11, limb4_P_q - limbs.P_q_next[3]);
    /* limb5_S: results */
    const REAL t216 = 0.5 * t197, t211 = t51 - limb5_S_null_space_wz_by_limb5_S_wy * t194, t214 = 0.5 * t194,
      t212 = 0.5 * t211, t220 = limb5_S_q_qw + (limb5_S_q_qz * t212 - (limb5_S_q_qy * t214 + limb5_S_q_qx * t216)),
      t242 = t220 * t220, t240 = limb5_S_q_qy * t212 + limb5_S_q_qz * t214 + (limb5_S_q_qx + limb5_S_q_qw * t216),
      t243 = t240 * t240 + t242, t222 = limb5_S_q_qy * t216, t225 = limb5_S_q_qz - limb5_S_q_qw * t212,
      t233 = limb5_S_q_qz * t216 + limb5_S_q_qx * t212 - (limb5_S_q_qy + limb5_S_q_qw * t214),
      t226 = limb5_S_q_qx * t214 - t222 - t225, t247 = 1.0 / SQRT(t226 * t226 + (t233 * t233 + t243));
    RESULT(checked2, q_next, 12, t220 * t247);
    RESULT(checked3, q_next, 13, t240 * t247);
    const REAL t248 = t233 * t247;
    checked0 = checked0 + t248;
    WRITE(q_next, 14, -t248);
    const REAL t249 = t226 * t247;
    checked1 = checked1 + t249;
    WRITE(q_next, 15, -t249);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(pivot_0, 5.4106e-09) OR /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(minus_pivot_1, 5.4385e-09), /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
BODY(three_ups_upu_s_close_velocity)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict v_next, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t3 = limb5_S_q_qw * limb5_S_q_qw,
      t4 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t5 = t3 + t4, t6 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t7 = limb5_S_q_qz * limb5_S_q_qz, t8 = t6 + t7, t9 = t5 + t8, t11 = 4.0 - 2.0 * t9,
      t121 = t4 + t6, platform_turn_yy = 1.0 - t11 * (t4 + t7), platform_turn_zz = 1.0 - t11 * t121,
      platform_turn_xx = 1.0 - t8 * t11, t15 = limb5_S_q_qz * t11, t16 = limb5_S_q_qy * t15,
      t18 = limb5_S_q_qw * (limb5_S_q_qx * t11), t26 = limb5_S_q_qy * t11, platform_turn_zy = t16 + t18,
      platform_turn_yz = t16 - t18, limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_cos = SINES(cosine, 1),
      t25 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy), /* limb1 */
      t27 = limb5_S_q_qx * t26, t104 = limb5_S_q_qw * t26, t28 = limb5_S_q_qw * t15, t103 = limb5_S_q_qx * t15,
      platform_turn_xy = t27 - t28, platform_turn_yx = t27 + t28;
    /* limb1: geometry; reciprocal wrenches, eq. (10) */
    const REAL limb1_lower_sin = SINES(sine, 1),
      limb1_U2_constraint_mn_couple_z = t25 - limb1_lower_sin * platform_turn_xy,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    /* limb1: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t2 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t31 = limb1_lower_cos * t2,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t31,
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t33 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3, t36 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t20 = minus_limb1_upper_position_x * (limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t2),
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t20,
      t34 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t33,
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t36;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t34 / minus_limb5_S_pivot_wz,
      t148 = limb1_U_0_cos + limb1_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy,
      limb1_U_null_space_1_by_limb5_S_wy = t31 * (limb1_U2_arm_x * t148),
      t152 = READ(v, 1) * limb1_U_null_space_1_by_limb5_S_wy,
      t39 = minus_limb1_upper_position_x * (limb1_U_0_sin - limb1_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy),
      minus_limb1_U_null_space_0_by_limb5_S_wy = t2 * t39, limb1_U_v_0 = READ(v, 0),
      t154 = t152 - limb1_U_v_0 * minus_limb1_U_null_space_0_by_limb5_S_wy,
      limb1_P_null_space_by_limb5_S_wy = param_R * limb1_lower_cos * t148,
      t149 = 2.2795812745707664 * limb1_P_null_space_by_limb5_S_wy;
    /* limb2: geometry; rates that follow */
    const REAL limb2_U_0_sin = SINES(cosine, 2), t155 = READ(v, 2) * t149 + t154, /* limb1 */
      t179 = limb1_P_null_space_by_limb5_S_wy * t149, /* limb1 */
      t76 = limb2_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy, limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      limb2_lower_sin = SINES(sine, 3),
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      minus_limb2_U_0_cos = SINES(sine, 2), limb2_lower_cos = SINES(cosine, 3);
    /* limb2: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t77 = minus_limb2_upper_position_y * t76, t54 = minus_limb2_U_0_cos * minus_limb2_upper_position_y,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x,
      t78 = minus_limb2_U_0_lever_mz_by_limb2_S_fz - t77, t53 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      limb2_U_null_space_0_by_limb5_S_wy = t53 * t78, minus_limb2_U_null_space_0_by_limb5_S_wx = t53 * t54,
      t59 = limb2_lower_cos * t53, limb2_U_v_0 = READ(v, 3),
      t156 = limb2_U_v_0 * limb2_U_null_space_0_by_limb5_S_wy + t155, /* mechanism */
      t71 = minus_limb2_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin,
      minus_limb2_U_null_space_1_by_limb5_S_wy = t59 * (limb2_S_arm_x * t71),
      limb2_U_null_space_1_by_limb5_S_wx = limb2_U_0_sin * limb2_S_arm_x * t59, limb2_U_v_1 = READ(v, 4),
      t157 = limb2_U_v_1 * minus_limb2_U_null_space_1_by_limb5_S_wy - t156, /* mechanism */
      minus_limb2_S_arm_y = param_R * limb2_lower_cos,
      minus_limb2_P_null_space_by_limb5_S_wy = minus_limb2_S_arm_y * t71,
      minus_platform_joint_force_mx_by_limb2_P = limb2_U_0_sin * minus_limb2_S_arm_y,
      t72 = 2.2795812745707664 * minus_limb2_P_null_space_by_limb5_S_wy, limb2_P_v = READ(v, 5);
    /* limb3: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_0_sin = SINES(sine, 4),
      t158 = limb2_P_v * t72 + t157, /* mechanism */
      t86 = limb3_U_0_sin - limb3_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      limb3_lower_cos = SINES(cosine, 5), t87 = (param_R - minus_limb3_lower_sin * limb3_upper_offset_x) * t86,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t84 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz, limb3_U_null_space_0_by_limb5_S_wy = t84 * t87,
      limb3_U_v_0 = READ(v, 6), t141 = limb3_lower_cos * t84,
      t159 = limb3_U_v_0 * limb3_U_null_space_0_by_limb5_S_wy - t158, /* mechanism */
      t136 = limb3_U_0_cos + limb3_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy,
      limb3_U_null_space_1_by_limb5_S_wy = (limb3_upper_offset_x - param_R * minus_limb3_lower_sin) * t136 * t141,
      t160 = READ(v, 7) * limb3_U_null_space_1_by_limb5_S_wy + t159, /* mechanism */
      minus_limb3_P_null_space_by_limb5_S_wy = param_R * limb3_lower_cos * t136,
      t137 = 2.2795812745707664 * minus_limb3_P_null_space_by_limb5_S_wy;
    /* limb4: geometry; rates that follow */
    const REAL limb4_U_0_sin = SINES(cosine, 6), t161 = READ(v, 8) * t137 - t160, /* mechanism */
      t173 = minus_limb3_P_null_space_by_limb5_S_wy * t137, /* limb3 */
      t89 = limb4_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy,
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11), minus_limb4_lower_sin = SINES(sine, 7),
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      minus_limb4_U_0_cos = SINES(sine, 6), limb4_lower_cos = SINES(cosine, 7);
    /* limb4: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t90 = limb4_upper_position_y * t89, t48 = minus_limb4_U_0_cos * limb4_upper_position_y,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x,
      t91 = minus_limb4_U_0_lever_mz_by_limb4_S_fz + t90, t45 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_U_null_space_0_by_limb5_S_wy = t45 * t91, limb4_U_null_space_0_by_limb5_S_wx = t45 * t48,
      t46 = limb4_lower_cos * t45, limb4_U_v_0 = READ(v, 9),
      t162 = limb4_U_v_0 * limb4_U_null_space_0_by_limb5_S_wy - t161, /* mechanism */
      t68 = minus_limb4_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy,
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      minus_limb4_U_null_space_1_by_limb5_S_wy = t46 * (limb4_S_arm_x * t68),
      limb4_U_null_space_1_by_limb5_S_wx = limb4_U_0_sin * limb4_S_arm_x * t46, limb4_U_v_1 = READ(v, 10);
    /* mechanism: results; velocities, eq. (6); geometry */
    const REAL t163 = limb4_U_v_1 * minus_limb4_U_null_space_1_by_limb5_S_wy - t162,
      limb4_S_arm_y = param_R * limb4_lower_cos, limb4_P_null_space_by_limb5_S_wy = limb4_S_arm_y * t68,
      platform_joint_force_mx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y,
      t69 = 2.2795812745707664 * limb4_P_null_space_by_limb5_S_wy, /* limb4 */
      limb4_P_v = READ(v, 11), limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14),
      t164 = limb4_P_v * t69 - t163, t130 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      t165 = t130 + limb5_S_v_wz * platform_turn_yz + t164, platform_turn_zx = t103 - t104,
      platform_turn_xz = t103 + t104, t126 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      t166 = (limb5_S_v_wz * platform_turn_zz + t126) * limb5_S_null_space_wz_by_limb5_S_wy + t165,
      t80 = minus_limb2_U_null_space_0_by_limb5_S_wx * limb2_U_null_space_0_by_limb5_S_wy + minus_limb1_U_null_space_0_by_limb5_S_wy,
      t81 = limb2_U_null_space_1_by_limb5_S_wx * minus_limb2_U_null_space_1_by_limb5_S_wy + t80,
      t88 = minus_platform_joint_force_mx_by_limb2_P * t72 + t81 - limb3_U_null_space_0_by_limb5_S_wy,
      t176 = minus_limb2_P_null_space_by_limb5_S_wy * t72, /* limb2 */
      t93 = t88 - limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wy,
      t96 = t93 + limb4_U_null_space_1_by_limb5_S_wx * minus_limb4_U_null_space_1_by_limb5_S_wy,
      t97 = platform_joint_force_mx_by_limb4_P * t69 + t96,
      t170 = limb4_P_null_space_by_limb5_S_wy * t69, /* limb4 */
      t56 = 1.0 + minus_limb2_U_null_space_0_by_limb5_S_wx * minus_limb2_U_null_space_0_by_limb5_S_wx, /* limb2 */
      t61 = t56 + limb2_U_null_space_1_by_limb5_S_wx * limb2_U_null_space_1_by_limb5_S_wx; /* limb2 */
    /* mechanism: pivots; results */
    const REAL t51 = 2.2795812745707664 * minus_platform_joint_force_mx_by_limb2_P,
      t63 = 1.0 + (minus_platform_joint_force_mx_by_limb2_P * t51 + t61), t109 = limb2_P_v * t51,
      t64 = limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wx + t63,
      t65 = limb4_U_null_space_1_by_limb5_S_wx * limb4_U_null_space_1_by_limb5_S_wx + t64,
      t41 = 2.2795812745707664 * platform_joint_force_mx_by_limb4_P,
      pivot_0 = 1.0 + (platform_joint_force_mx_by_limb4_P * t41 + t65);
    REAL checked3 = pivot_0;
    /* mechanism: results; pivots; velocities, eq. (6) */
    const REAL t67 = 1.0 / pivot_0, t106 = limb4_P_v * t41, t98 = t67 * t97, t168 = t97 * t98,
      t111 = limb1_U_v_0 - limb2_U_v_0 * minus_limb2_U_null_space_0_by_limb5_S_wx,
      t115 = limb3_U_v_0 + (t109 + (t111 + limb2_U_v_1 * limb2_U_null_space_1_by_limb5_S_wx)),
      t116 = limb4_U_v_0 * limb4_U_null_space_0_by_limb5_S_wx + t115,
      t118 = t106 - (limb4_U_v_1 * limb4_U_null_space_1_by_limb5_S_wx + t116),
      t102 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      t119 = t102 + limb5_S_v_wz * platform_turn_xz - t118, t198 = t67 * t119, t167 = t98 * t119 + t166,
      t180 = limb1_U_null_space_1_by_limb5_S_wy * limb1_U_null_space_1_by_limb5_S_wy, /* limb1 */
      t183 = t179 + (t180 + minus_limb1_U_null_space_0_by_limb5_S_wy * minus_limb1_U_null_space_0_by_limb5_S_wy); /* limb1 */
    /* mechanism: pivots; results */
    const REAL t184 = limb2_U_null_space_0_by_limb5_S_wy * limb2_U_null_space_0_by_limb5_S_wy + t183,
      t186 = t176 + (minus_limb2_U_null_space_1_by_limb5_S_wy * minus_limb2_U_null_space_1_by_limb5_S_wy + t184),
      t187 = limb3_U_null_space_0_by_limb5_S_wy * limb3_U_null_space_0_by_limb5_S_wy + t186,
      t189 = t173 + (limb3_U_null_space_1_by_limb5_S_wy * limb3_U_null_space_1_by_limb5_S_wy + t187),
      t190 = limb4_U_null_space_0_by_limb5_S_wy * limb4_U_null_space_0_by_limb5_S_wy + t189,
      t192 = t170 + (minus_limb4_U_null_space_1_by_limb5_S_wy * minus_limb4_U_null_space_1_by_limb5_S_wy + t190),
      minus_pivot_1 = t168 - (limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_null_space_wz_by_limb5_S_wy + (1.0 + t192));
    checked0 = checked0 + minus_pivot_1;
    const REAL t195 = t167 / minus_pivot_1;
    RESULT(checked1, v_next, 8, minus_limb3_P_null_space_by_limb5_S_wy * t195);
    const REAL t199 = t98 * t195 - t198;
    RESULT(checked2, v_next, 0, minus_limb1_U_null_space_0_by_limb5_S_wy * t195 - t199);
    const REAL t200 = limb1_U_null_space_1_by_limb5_S_wy * t195; /* limb1 */
    checked3 = checked3 + t200; /* limb1 */
    WRITE(v_next, 1, -t200);
    const REAL t201 = limb1_P_null_space_by_limb5_S_wy * t195; /* limb1 */
    checked0 = checked0 + t201; /* limb1 */
    WRITE(v_next, 2, -t201);
    RESULT(checked1, v_next, 3, minus_limb2_U_null_space_0_by_limb5_S_wx * t199 - limb2_U_null_space_0_by_limb5_S_wy * t195);
    RESULT(checked2, v_next, 4, minus_limb2_U_null_space_1_by_limb5_S_wy * t195 - limb2_U_null_space_1_by_limb5_S_wx * t199);
    RESULT(checked3, v_next, 5, minus_limb2_P_null_space_by_limb5_S_wy * t195 - minus_platform_joint_force_mx_by_limb2_P * t199);
    const REAL t209 = t199 + limb3_U_null_space_0_by_limb5_S_wy * t195; /* limb3 */
    checked0 = checked0 + t209; /* limb3 */
    WRITE(v_next, 6, -t209);
    const REAL t210 = limb3_U_null_space_1_by_limb5_S_wy * t195; /* limb3 */
    checked1 = checked1 + t210; /* limb3 */
    WRITE(v_next, 7, -t210);
    const REAL t213 = limb4_U_null_space_0_by_limb5_S_wy * t195 + limb4_U_null_space_0_by_limb5_S_wx * t199; /* limb4 */
    checked2 = checked2 + t213; /* limb4 */
    WRITE(v_next, 9, -t213);
    RESULT(checked3, v_next, 10, minus_limb4_U_null_space_1_by_limb5_S_wy * t195 - limb4_U_null_space_1_by_limb5_S_wx * t199);
    RESULT(checked0, v_next, 11, platform_joint_force_mx_by_limb4_P * t199 - limb4_P_null_space_by_limb5_S_wy * t195);
    /* limb5_S: results */
    const REAL t222 = platform_turn_yx * t195 + platform_turn_xx * t199,
      t218 = limb5_S_null_space_wz_by_limb5_S_wy * t195, t223 = platform_turn_zx * t218 + t222;
    checked1 = checked1 + t223;
    WRITE(v_next, 12, -t223);
    const REAL t232 = platform_turn_yz * t195 + platform_turn_xz * t199,
      t228 = platform_turn_zy * t218 + (platform_turn_yy * t195 + platform_turn_xy * t199);
    checked2 = checked2 + t228;
    WRITE(v_next, 13, -t228);
    const REAL t233 = platform_turn_zz * t218 + t232;
    checked3 = checked3 + t233;
    WRITE(v_next, 14, -t233);
    /* else status 5: no rotation */
    NOT_BELOW(t9, 0.999999, 5);
    NOT_ABOVE(t9, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(pivot_0, 5.4106e-09) OR /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(minus_pivot_1, 5.4385e-09), /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3));
}
#endif

#if !defined(THREE_UPS_UPU_S_VECTORS)

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
#define THREE_UPS_UPU_S_VECTORS
#define THREE_UPS_UPU_S_LANES 4
#include "three_ups_upu_s_support.h" /* for all limbs at once */
#include "three_ups_upu_s_loops.c"
#undef THREE_UPS_UPU_S_VECTORS
#undef THREE_UPS_UPU_S_LANES
#include "three_ups_upu_s_support.h" /* for one limb again */
#endif

int three_ups_upu_s_closure(const double *restrict q, double *restrict residual_)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_closure_body(1, q, residual_, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(residual_, 13);
    }
    return outcome;
}

int three_ups_upu_s_closure_jacobian(const double *restrict q, double *restrict jacobian)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    three_ups_upu_s_zero(jacobian + 4, 10);
    three_ups_upu_s_zero(jacobian + 17, 9);
    three_ups_upu_s_zero(jacobian + 27, 18);
    three_ups_upu_s_zero(jacobian + 46, 11);
    three_ups_upu_s_zero(jacobian + 58, 11);
    three_ups_upu_s_zero(jacobian + 70, 17);
    three_ups_upu_s_zero(jacobian + 88, 11);
    three_ups_upu_s_zero(jacobian + 100, 11);
    three_ups_upu_s_zero(jacobian + 112, 17);
    three_ups_upu_s_zero(jacobian + 130, 11);
    three_ups_upu_s_zero(jacobian + 142, 11);
    const int outcome = three_ups_upu_s_closure_jacobian_body(1, q, jacobian, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(jacobian, 195);
    }
    return outcome;
}

int three_ups_upu_s_closure_bias(const double *restrict q, const double *restrict v, double *restrict bias)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_closure_bias_body(1, q, v, bias, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(bias, 13);
    }
    return outcome;
}


#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_velocity_limb_by_limb(const double *restrict q, const double *restrict y_dot,
    double *restrict v)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_velocity_body(1, q, y_dot, v, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(v, 15);
    }
    return outcome;
}

int three_ups_upu_s_velocity(const double *restrict q, const double *restrict y_dot, double *restrict v)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    if (isfinite(three_ups_upu_s_velocity_packed_lane(1, q, y_dot, v, sine, cosine, NULL))) {
        return 0;
    }
#endif
    return three_ups_upu_s_velocity_limb_by_limb(q, y_dot, v);
}

int three_ups_upu_s_null_space(const double *restrict q, double *restrict null_space)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_null_space_body(1, q, null_space, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(null_space, 30);
    }
    return outcome;
}


#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_acceleration_limb_by_limb(const double *restrict q, const double *restrict v,
    const double *restrict y_ddot, double *restrict a)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_acceleration_body(1, q, v, y_ddot, a, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(a, 15);
    }
    return outcome;
}

int three_ups_upu_s_acceleration(const double *restrict q, const double *restrict v,
    const double *restrict y_ddot, double *restrict a)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    if (isfinite(three_ups_upu_s_acceleration_packed_lane(1, q, v, y_ddot, a, sine, cosine, NULL))) {
        return 0;
    }
#endif
    return three_ups_upu_s_acceleration_limb_by_limb(q, v, y_ddot, a);
}

int three_ups_upu_s_close_position(const double *restrict q, double *restrict q_next,
    double *restrict residual_)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_close_position_body(1, q, q_next, residual_, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(q_next, 16);
        three_ups_upu_s_set_nan(residual_, 1);
    }
    return outcome;
}

int three_ups_upu_s_close_velocity(const double *restrict q, const double *restrict v,
    double *restrict v_next)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_close_velocity_body(1, q, v, v_next, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(v_next, 15);
    }
    return outcome;
}

typedef struct {
    EACH4 upper_offset_x, signed_upper_position_x, minus_U_0_lever_mz_by_S_fz, t1, S_arm_x, t2,
      signed_S_opening_fz, t3, t4, signed_S_opening_fy, signed_S_arm_y, t5, t6, S_opening_fx,
      signed_lower_limb_target_y, signed_lower_limb_target_x_2, t7, t8, t9, t10, signed_lower_limb_target_z,
      lower_limb_length, t11, t12, t13, t14, t15, checked;
} LIMBS(assemble_step);

STAGE(assemble_step, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict sine,
    const double *restrict cosine, REAL given, REAL given_2, REAL given_3, REAL given_4,
    LIMBS(assemble_step) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, -1.0),
      sign3 = OF4(1.0, 1.0, -1.0, 1.0);
    const LIMB4 lower_cos = OF4(SINES(cosine, 1), SINES(cosine, 4), SINES(cosine, 6), SINES(cosine, 9));
    /* each limb: reciprocal wrenches, eq. (10); geometry; rates that follow */
    OWN(signed_S_arm_y) = param_R * lower_cos;
    OWN(upper_offset_x) = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    const LIMB4 signed_lower_sin = OF4(SINES(sine, 1), SINES(sine, 4), SINES(sine, 6), SINES(sine, 9));
    OWN(signed_upper_position_x) = signed_lower_sin * OWN(upper_offset_x) + (-param_R);
    OWN(S_arm_x) = OWN(upper_offset_x) - param_R * signed_lower_sin;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * OWN(upper_offset_x);
    OWN(t1) = 1.0 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    const LIMB4 U_0_sin = OF4(SINES(sine, 0), SINES(cosine, 2), SINES(sine, 5), SINES(cosine, 7)),
      t8 = sign2 * (given - sign1 * given_2), minus_lower_rotation_yx = U_0_sin * lower_cos;
    /* each limb: loop closure; geometry; results */
    const LIMB4 t2 = OWN(upper_offset_x) * minus_lower_rotation_yx - t8;
    OWN(t6) = minus_lower_rotation_yx * t2;
    OWN(t3) = U_0_sin * signed_lower_sin * t2;
    const LIMB4 signed_U_0_cos = OF4(SINES(cosine, 0), SINES(sine, 2), SINES(cosine, 5), SINES(sine, 7)),
      t3 = signed_U_0_cos * t2, t10 = sign3 * (given_3 - sign1 * given_4),
      signed_lower_rotation_zx = signed_U_0_cos * lower_cos,
      t4 = OWN(upper_offset_x) * signed_lower_rotation_zx + t10;
    OWN(t5) = signed_lower_rotation_zx * t4;
    OWN(t4) = signed_U_0_cos * signed_lower_sin * t4;
    OWN(signed_S_opening_fz) = t3 - U_0_sin * t4;
    const LIMB4 t6 = per_length * OWN(signed_S_opening_fz);
    OWN(t15) = t6 * t6;
}

STAGE(assemble_step, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, REAL given_2, REAL given_3, REAL given_4, REAL given_5,
    REAL given_6, LIMBS(assemble_step) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0);
    /* each limb: loop closure; results */
    const LIMB4 t1 = OWN(signed_upper_position_x) + sign2 * (given - sign1 * given_2);
    OWN(S_opening_fx) = OF4(SINES(sine, 1), SINES(sine, 4), SINES(sine, 6), SINES(sine, 9)) * t1 + given_5 + given_6;
    const LIMB4 t6 = (-per_length) * OWN(S_opening_fx);
    OWN(t13) = t6 * t6;
    OWN(signed_S_opening_fy) = given_4 - (OF4(SINES(cosine, 1), SINES(cosine, 4), SINES(cosine, 6), SINES(cosine, 9)) * t1 - given_3);
    const LIMB4 t7 = per_length * OWN(signed_S_opening_fy);
    OWN(t14) = t7 * t7;
}

STAGE(assemble_step, 2)(size_t limb, size_t stride, double *restrict q_next, const double *restrict sine,
    const double *restrict cosine, REAL given, REAL given_2, REAL given_3, REAL given_4, REAL given_5,
    REAL given_6, LIMBS(assemble_step) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, 1.0, -1.0, 1.0), each_param_R = -sign3 * param_R;
    /* each limb: geometry; results */
    OWN(signed_lower_limb_target_x_2) = given_3 + sign2 * given_4;
    const LIMB4 t1 = OF4(SINES(sine, 0), SINES(sine, 3), SINES(sine, 5), SINES(sine, 8)) * OWN(signed_lower_limb_target_x_2),
      t4 = OWN(signed_lower_limb_target_x_2) * OWN(signed_lower_limb_target_x_2);
    OWN(signed_lower_limb_target_y) = given - sign1 * given_2;
    const LIMB4 t2 = OF4(SINES(cosine, 0), SINES(cosine, 3), SINES(cosine, 5), SINES(cosine, 8)) * OWN(signed_lower_limb_target_y);
    OWN(t7) = t1 + t2;
    OWN(t8) = OWN(signed_lower_limb_target_y) * OWN(signed_lower_limb_target_y) + t4;
    OWN(signed_lower_limb_target_z) = given_5 + sign1 * given_6 + each_param_R;
    OWN(lower_limb_length) = SQRT4(OWN(signed_lower_limb_target_z) * OWN(signed_lower_limb_target_z) + OWN(t8));
    const LIMB4 P_q_next = OWN(lower_limb_length) + (-limb_upper_phase);
    WRITE4(q_next, 2, 5, 8, 11, P_q_next);
    LIMB4 checked = P_q_next;
    OWN(checked) = checked;
}

STAGE(assemble_step, 3)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, LIMBS(assemble_step) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, 1.0);
    /* each limb: geometry; results */
    const LIMB4 t1 = SQRT4(OWN(t8)), t2 = given / t1, t8 = given * t1,
      minus_U_0_cos = OWN(signed_lower_limb_target_y) * t2, minus_U_0_sin = OWN(signed_lower_limb_target_x_2) * t2,
      U_0_sin = OF4(SINES(sine, 0), SINES(sine, 3), SINES(sine, 5), SINES(sine, 8)),
      U_0_cos = OF4(SINES(cosine, 0), SINES(cosine, 3), SINES(cosine, 5), SINES(cosine, 8)),
      t6 = U_0_cos * minus_U_0_cos;
    OWN(t9) = U_0_sin * minus_U_0_cos - U_0_cos * minus_U_0_sin;
    OWN(t10) = U_0_sin * minus_U_0_sin + t6;
    const LIMB4 t7 = 1.0 / OWN(lower_limb_length), minus_lower_cos = t7 * t8,
      minus_lower_sin_2 = OWN(signed_lower_limb_target_z) * t7,
      signed_lower_sin = OF4(SINES(sine, 1), SINES(sine, 4), SINES(sine, 6), SINES(sine, 9)),
      lower_cos = OF4(SINES(cosine, 1), SINES(cosine, 4), SINES(cosine, 6), SINES(cosine, 9)),
      t14 = sign1 * (lower_cos * minus_lower_cos);
    OWN(t11) = signed_lower_sin * minus_lower_cos - sign1 * (lower_cos * minus_lower_sin_2);
    OWN(t12) = signed_lower_sin * minus_lower_sin_2 + t14;
}

BODY(three_ups_upu_s_assemble_step)(size_t stride, const double *restrict q, const double *restrict y,
    double *restrict q_next, double *restrict residual_, double *restrict step, double *restrict orientation_,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(assemble_step) limbs;
    /* limb5_S: results */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t5 = limb5_S_q_qw * limb5_S_q_qw,
      t6 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t7 = t5 + t6, t8 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t9 = limb5_S_q_qz * limb5_S_q_qz, t10 = t8 + t9, t11 = t7 + t10;
    /* limb5_S: geometry; results */
    const REAL t20 = t6 + t9, t43 = t6 + t8, t19 = 4.0 - 2.0 * t11, platform_turn_yy = 1.0 - t19 * t20,
      t45 = param_H * (1.0 - t19 * t43), t13 = k2 - 0.5 * t11, t56 = 0.5 * (1.0 - t10 * t19),
      t23 = limb5_S_q_qz * t19, t24 = limb5_S_q_qy * t23, t26 = limb5_S_q_qw * (limb5_S_q_qx * t19),
      t34 = limb5_S_q_qy * t19, platform_turn_zy = t24 + t26, t42 = param_H * (t24 - t26),
      limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      t32 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t33 = limb1_lower_cos * t32, /* limb1 */
      t53 = limb1_lower_sin * t32, /* limb1 */
      t35 = limb5_S_q_qx * t34, t48 = limb5_S_q_qw * t34, t36 = limb5_S_q_qw * t23, t47 = limb5_S_q_qx * t23,
      platform_turn_xy = t35 - t36, t41 = 0.5 * (t35 + t36),
      limb1_U2_constraint_mn_couple_z = t33 - limb1_lower_sin * platform_turn_xy, platform_turn_xz = t47 + t48,
      t49 = 0.5 * (t47 - t48), t50 = param_H * platform_turn_xz;
    FIRST_LIMB(0, assemble_step, 0, stride, q, sine, cosine, t41, t42, t49, t45, &limbs);
    NEXT_LIMB(2, assemble_step, 0, stride, q, sine, cosine, t41, t42, t49, t45, &limbs);
    /* limb1: rates that follow; pivots; reciprocal wrenches, eq. (10) */
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t2[0],
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      t39 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t76 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      t27 = limb1_U_0_sin * platform_turn_zy, t46 = 0.5 * platform_turn_zy, /* platform */
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + t27,
      t57 = 0.5 * platform_turn_yy, /* platform */
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn + limbs.signed_upper_position_x[0] * minus_limb1_U_factor_0_by_3,
      t52 = limbs.signed_S_opening_fz[0] * minus_limb1_U_factor_0_by_3;
    /* limb5_S: pivots */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t39,
      t77 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t76; /* limb1 */
    /* step: results; rates that follow; geometry */
    const REAL t40 = 1.0 / minus_limb5_S_pivot_wz, limb5_S_null_space_wz_by_limb5_S_wy = t40 * t77,
      t17 = limb5_S_q_qy * t13, t78 = t17 * limb5_S_null_space_wz_by_limb5_S_wy, t14 = limb5_S_q_qz * t13,
      t80 = 0.5 * (t14 - t78), t15 = 0.5 * t14, t81 = t15 * t80, t69 = limb5_S_q_qx * t13,
      t82 = t69 * limb5_S_null_space_wz_by_limb5_S_wy, t66 = limb5_S_q_qw * t13, t84 = 0.5 * (t66 + t82),
      t67 = 0.5 * t66, a_pivot = t81 + t67 * t84, t51 = 0.5 * platform_turn_xy,
      limb1_U2_opening_mn = t53 + limb1_lower_cos * platform_turn_xy;
    NEXT_LIMB(1, assemble_step, 0, stride, q, sine, cosine, t45, t46, t50, t51, &limbs);
    NEXT_LIMB(3, assemble_step, 0, stride, q, sine, cosine, t45, t46, t50, t51, &limbs);
    const REAL t331 = limbs.upper_offset_x[0] * (limbs.upper_offset_x[3] * (limbs.upper_offset_x[1] * limbs.upper_offset_x[2])),
      t334 = limbs.minus_U_0_lever_mz_by_S_fz[3] * (limbs.minus_U_0_lever_mz_by_S_fz[1] * (limbs.minus_U_0_lever_mz_by_S_fz[2] * t331)),
      t337 = a_pivot * (limbs.minus_U_0_lever_mz_by_S_fz[0] * t334 * minus_limb5_S_pivot_wz);
    REAL checked0 = t337;
    WRITE(orientation_, 0, -t337);
    const REAL t86 = 1.0 / a_pivot;
    FIRST_LIMB(0, assemble_step, 1, stride, sine, cosine, t56, t50, limbs.t3[0], limbs.t4[0], limbs.t6[0], limbs.t5[0], &limbs);
    NEXT_LIMB(2, assemble_step, 1, stride, sine, cosine, t56, t50, limbs.t3[2], limbs.t4[2], limbs.t6[2], limbs.t5[2], &limbs);
    const REAL t61 = t40 * (t52 - (limb1_U2_opening_mn + limbs.signed_S_opening_fy[0] * limb1_U_factor_1_by_3)),
      t71 = 0.5 * (t69 * t61), t318 = limb1_U2_opening_mn * limb1_U2_opening_mn, /* limb1 */
      t64 = limb5_S_q_qx - READ(y, 0) + 0.5 * (t17 * t61), t65 = t15 * t64, t94 = t84 * t64,
      t72 = limb5_S_q_qy - READ(y, 1) - t71, t95 = t80 * t72 - t94, t87 = (t65 + t67 * t72) * t86, t96 = t86 * t95,
      t89 = t40 * (t77 * t87),
      t196 = limbs.t1[0] * (limbs.signed_upper_position_x[0] * (limb1_U_0_cos * t89 - limb1_U_0_sin * t87)),
      t197 = t96 + t196,
      t201 = limbs.t1[0] * (limbs.signed_S_opening_fz[0] - limbs.signed_upper_position_x[0] * (limb1_U_0_cos * t61)),
      t202 = t197 - t201, t203 = t202 * t202, t184 = limb1_U_0_sin * t89 + limb1_U_0_cos * t87,
      t204 = limbs.S_arm_x[0] * t184, t185 = limbs.signed_S_arm_y[0] * t184, t186 = limb1_U_0_sin * t61,
      t208 = limbs.t2[0] * (t204 - (limbs.signed_S_opening_fy[0] - limbs.S_arm_x[0] * t186)),
      t210 = t203 + t208 * t208,
      t190 = per_length * (t185 + (limbs.S_opening_fx[0] + limbs.signed_S_arm_y[0] * t186)),
      limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2), t211 = t190 * t190 + t210,
      t319 = limbs.t13[0] + limbs.t14[0] + limbs.t15[0] + t318, /* limb1 */
      t174 = limbs.t1[1] * (limbs.signed_upper_position_x[1] * (limb2_U_0_sin * t89 - minus_limb2_U_0_cos * t96)),
      t175 = t87 + t174,
      t179 = limbs.t1[1] * (limbs.signed_upper_position_x[1] * (limb2_U_0_sin * t61) - limbs.signed_S_opening_fz[1]),
      t180 = t175 + t179, t212 = t180 * t180 + t211, t156 = minus_limb2_U_0_cos * t89 + limb2_U_0_sin * t96,
      t164 = limbs.S_arm_x[1] * t156, t157 = limbs.signed_S_arm_y[1] * t156, t158 = minus_limb2_U_0_cos * t61,
      t165 = limbs.S_arm_x[1] * t158, t159 = limbs.signed_S_arm_y[1] * t158;
    NEXT_LIMB(1, assemble_step, 1, stride, sine, cosine, t42, t57, limbs.t4[1], limbs.t3[1], limbs.t5[1], limbs.t6[1], &limbs);
    NEXT_LIMB(3, assemble_step, 1, stride, sine, cosine, t42, t57, limbs.t4[3], limbs.t3[3], limbs.t5[3], limbs.t6[3], &limbs);
    const REAL t168 = limbs.t2[1] * (t164 + (limbs.signed_S_opening_fy[1] + t165)), t213 = t168 * t168 + t212,
      t162 = per_length * (t157 - (limbs.S_opening_fx[1] - t159)), t214 = t162 * t162 + t213,
      t325 = t319 + limbs.t13[1] + limbs.t14[1] + limbs.t15[1] + limbs.t13[2] + limbs.t14[2] + limbs.t15[2],
      residual_residual = SQRT(t325 + limbs.t13[3] + limbs.t14[3] + limbs.t15[3]);
    WRITE(residual_, 0, residual_residual);
    REAL checked1 = residual_residual;
    const REAL limb3_U_0_cos = SINES(cosine, 5), limb3_U_0_sin = SINES(sine, 5),
      t146 = limbs.t1[2] * (limbs.signed_upper_position_x[2] * (limb3_U_0_cos * t89 - limb3_U_0_sin * t87)),
      t147 = t96 - t146,
      t151 = limbs.t1[2] * (limbs.signed_S_opening_fz[2] + limbs.signed_upper_position_x[2] * (limb3_U_0_cos * t61)),
      t152 = t147 - t151, t215 = t152 * t152 + t214, t128 = limb3_U_0_sin * t89 + limb3_U_0_cos * t87,
      t136 = limbs.S_arm_x[2] * t128, t129 = limbs.signed_S_arm_y[2] * t128, t130 = limb3_U_0_sin * t61,
      t140 = limbs.t2[2] * (t136 + (limbs.signed_S_opening_fy[2] + limbs.S_arm_x[2] * t130)),
      t216 = t140 * t140 + t215,
      t134 = per_length * (t129 + (limbs.signed_S_arm_y[2] * t130 - limbs.S_opening_fx[2])),
      limb4_U_0_sin = SINES(cosine, 7), minus_limb4_U_0_cos = SINES(sine, 7), t217 = t134 * t134 + t216,
      t118 = limbs.t1[3] * (limbs.signed_upper_position_x[3] * (limb4_U_0_sin * t89 - minus_limb4_U_0_cos * t96)),
      t119 = t87 - t118,
      t123 = limbs.t1[3] * (limbs.signed_S_opening_fz[3] + limbs.signed_upper_position_x[3] * (limb4_U_0_sin * t61)),
      t124 = t119 - t123, t218 = t124 * t124 + t217, t98 = minus_limb4_U_0_cos * t89, t90 = t61 + t89,
      t102 = minus_limb4_U_0_cos * t61, t100 = t98 + limb4_U_0_sin * t96, t101 = limbs.signed_S_arm_y[3] * t100,
      t112 = limbs.t2[3] * (limbs.S_arm_x[3] * t100 - (limbs.signed_S_opening_fy[3] - limbs.S_arm_x[3] * t102)),
      t219 = t112 * t112 + t218,
      t106 = per_length * (t101 + (limbs.S_opening_fx[3] + limbs.signed_S_arm_y[3] * t102)),
      t222 = t87 * t87 + (t96 * t96 + (t106 * t106 + t219)), step_step = SQRT(t90 * t90 + t222);
    WRITE(step, 0, step_step);
    REAL checked2 = step_step;
    const REAL t224 = LESS(step_step, 0.5), t227 = SELECT(t224, 1.0, 0.5 / SELECT(t224, 1.0, step_step)),
      t229 = 0.5 * (t87 * t227), t235 = t90 * t227, t232 = 0.5 * (t96 * t227), t236 = 0.5 * t235,
      t260 = limb5_S_q_qw + (limb5_S_q_qz * t236 + (limb5_S_q_qy * t229 - limb5_S_q_qx * t232)), t261 = t260 * t260,
      t253 = limb5_S_q_qy * t236 - limb5_S_q_qz * t229 + (limb5_S_q_qx + limb5_S_q_qw * t232),
      t262 = t253 * t253 + t261, t233 = limb5_S_q_qy * t232, t238 = limb5_S_q_qz - limb5_S_q_qw * t236,
      t246 = limb5_S_q_qz * t232 + limb5_S_q_qx * t236 - (limb5_S_q_qy - limb5_S_q_qw * t229),
      t239 = limb5_S_q_qx * t229 + t233 + t238, t266 = 1.0 / SQRT(t239 * t239 + (t246 * t246 + t262)),
      t268 = t246 * t266;
    WRITE(q_next, 14, -t268);
    const REAL limb5_S_q_next_qz = t239 * t266;
    WRITE(q_next, 15, limb5_S_q_next_qz);
    const REAL limb5_S_q_next_qx = t253 * t266;
    WRITE(q_next, 13, limb5_S_q_next_qx);
    const REAL limb5_S_q_next_qw = t260 * t266;
    WRITE(q_next, 12, limb5_S_q_next_qw);
    /* limb5_S: geometry */
    const REAL t267 = limb5_S_q_next_qz * limb5_S_q_next_qz, t269 = t268 * t268, t270 = t267 + t269,
      t271 = limb5_S_q_next_qx * limb5_S_q_next_qx, t277 = t271 + t269, t306 = t267 + t271,
      t276 = 4.0 - 2.0 * (t270 + (t271 + limb5_S_q_next_qw * limb5_S_q_next_qw)), t282 = limb5_S_q_next_qz * t276,
      t279 = param_H * (1.0 - t276 * t277), t308 = 0.5 * (1.0 - t306 * t276), t305 = 0.5 * (1.0 - t270 * t276),
      t285 = limb5_S_q_next_qw * t282, t280 = t268 * t276, t290 = limb5_S_q_next_qw * (limb5_S_q_next_qx * t276),
      t281 = limb5_S_q_next_qw * t280, t286 = limb5_S_q_next_qx * t280, t283 = limb5_S_q_next_qx * t282,
      t291 = t268 * t282, platform_turn_yx_2 = t285 - t286, t287 = 0.5 * (t285 + t286),
      t293 = 0.5 * platform_turn_yx_2, platform_turn_zx_2 = t281 + t283, t288 = param_H * (t281 - t283),
      t284 = 0.5 * platform_turn_zx_2, minus_platform_turn_yz = t290 + t291, t294 = 0.5 * (t290 - t291),
      t292 = param_H * minus_platform_turn_yz;
    FIRST_LIMB(3, assemble_step, 2, stride, q_next, sine, cosine, t287, t288, t294, t279, t308, t292, &limbs);
    REAL checked3 = ALONE(limbs.checked[3]);
    NEXT_LIMB(1, assemble_step, 2, stride, q_next, sine, cosine, t287, t288, t294, t279, t308, t292, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[1]);
    FIRST_LIMB(3, assemble_step, 3, stride, sine, cosine, SELECT(LESS(limbs.t7[3], 0.0), (-1.0), 1.0), &limbs);
    RESULT(checked1, q_next, 10, READ(q, 10) + atan2(-limbs.t11[3], -limbs.t12[3]));
    RESULT(checked2, q_next, 9, READ(q, 9) + atan2(-limbs.t9[3], limbs.t10[3]));
    NEXT_LIMB(2, assemble_step, 2, stride, q_next, sine, cosine, t279, t284, t292, t293, t288, t305, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[2]);
    NEXT_LIMB(0, assemble_step, 2, stride, q_next, sine, cosine, t279, t284, t292, t293, t288, t305, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[0]);
    NEXT_LIMB(2, assemble_step, 3, stride, sine, cosine, SELECT(LESS(-limbs.t7[2], 0.0), (-1.0), 1.0), &limbs);
    RESULT(checked1, q_next, 7, READ(q, 7) + atan2(-limbs.t11[2], limbs.t12[2]));
    RESULT(checked2, q_next, 6, READ(q, 6) + atan2(limbs.t9[2], -limbs.t10[2]));
    NEXT_LIMB(1, assemble_step, 3, stride, sine, cosine, SELECT(LESS(-limbs.t7[1], 0.0), (-1.0), 1.0), &limbs);
    RESULT(checked3, q_next, 4, READ(q, 4) + atan2(limbs.t11[1], -limbs.t12[1]));
    RESULT(checked0, q_next, 3, READ(q, 3) + atan2(limbs.t9[1], -limbs.t10[1]));
    NEXT_LIMB(0, assemble_step, 3, stride, sine, cosine, SELECT(LESS(-limbs.t7[0], 0.0), (-1.0), 1.0), &limbs);
    RESULT(checked1, q_next, 1, READ(q, 1) + atan2(limbs.t11[0], -limbs.t12[0]));
    RESULT(checked2, q_next, 0, READ(q, 0) + atan2(limbs.t9[0], -limbs.t10[0]));
    /* else status 5: no rotation */
    NOT_BELOW(t11, 0.999999, 5);
    NOT_ABOVE(t11, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-13, 6.62327e-13, 6.62327e-13, 6.62327e-13) OR /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-12) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-12), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}

static int three_ups_upu_s_assemble_step(const double *restrict q, const double *restrict y,
    double *restrict q_next, double *restrict residual_, double *restrict step, double *restrict orientation_)
{
    double sine[12] = {0.0}, cosine[12] = {0.0};
    three_ups_upu_s_sines7(q, sine, cosine);
    const int outcome = three_ups_upu_s_assemble_step_body(1, q, y, q_next, residual_, step, orientation_,
        sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(q_next, 16);
        three_ups_upu_s_set_nan(residual_, 1);
        three_ups_upu_s_set_nan(step, 1);
        three_ups_upu_s_set_nan(orientation_, 1);
    }
    return outcome;
}

static int three_ups_upu_s_assemble_newton(double *q, const double *y, double branch)
{
    double next[16], residual[1], change[1], orientation[1];
    for (int step = 0; step < 25; ++step) {
        if (three_ups_upu_s_assemble_step(q, y, next, residual, change, orientation) != 0) {
            return 3;
        }
        for (int k = 0; k < 16; ++k) {
            q[k] = next[k];
        }
        if (residual[0] < 1.0e-13 && change[0] < 1.0e-13) {
            return orientation[0] * branch > 0.0 ? 0 : 4;
        }
    }
    return 3;
}

static int three_ups_upu_s_assemble_attempt(int substeps, const double *y, const double *guess,
    const double *start, double branch, double *q)
{
    double target[2] = {0.0};
    for (int k = 0; k < 16; ++k) {
        q[k] = guess[k];
    }
    for (int k = 1; k <= substeps; ++k) {
        const double part = (double)k / (double)substeps;
        target[0] = start[0] + (y[0] - start[0]) * part;
        target[1] = start[1] + (y[1] - start[1]) * part;
        const int outcome = three_ups_upu_s_assemble_newton(q, target, branch);
        if (outcome != 0) {
            return outcome;
        }
    }
    return 0;
}

int three_ups_upu_s_assemble(const double *restrict y, const double *restrict guess, double *restrict q)
{
    const double total = ((((y[0] + y[1]) + (guess[0] + guess[1])) + ((guess[2] + guess[3]) + (guess[4] +
        guess[5]))) + (((guess[6] + guess[7]) + (guess[8] + guess[9])) + ((guess[10] + guess[11]) + (guess[12]
        + guess[13])))) + (guess[14] + guess[15]);
    int outcome = isfinite(total) ? 3 : 2;
    if (outcome == 3) {
        double next[16], residual[1], change[1], orientation[1];
        double start[2] = {0.0};
        start[0] = guess[13];
        start[1] = guess[14];
        const int first = three_ups_upu_s_assemble_step(guess, start, next, residual, change, orientation);
        outcome = first >= 5 ? first : outcome;
        const int most = 64;
        for (int substeps = 1; substeps <= most && outcome != 0 && outcome < 5; substeps *= 2) {
            outcome = three_ups_upu_s_assemble_attempt(substeps, y, guess, start, orientation[0], q);
        }
    }
    if (outcome != 0) {
        three_ups_upu_s_set_nan(q, 16);
    }
    return outcome;
}
#endif /* THREE_UPS_UPU_S_VECTORS */
