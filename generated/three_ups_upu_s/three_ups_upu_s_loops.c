/*
 * three_ups_upu_s: loops.
 *   closure; closure_jacobian; closure_bias; velocity; null_space; acceleration; close_position;
 *   close_velocity; assemble
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 t1, t2, t3, checked;
} LIMBS(closure);

STAGE(closure, 0)(size_t limb, size_t stride, const double *restrict q, double *restrict residual_,
    const double *restrict sine, const double *restrict cosine, REAL given, REAL given_2, REAL given_3,
    REAL given_4, REAL given_5, REAL given_6, LIMBS(closure) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, -1.0, -1.0), sign2 = OF4(1.0, 1.0, -1.0, -1.0),
      sign3 = OF4(1.0, -1.0, 1.0, -1.0), each_param_R = -sign1 * param_R, sign4 = OF4(1.0, -1.0, 1.0, 1.0),
      sign5 = OF4(1.0, 1.0, -1.0, 1.0);
    const LIMB4 t11 = sign1 * (IN_EACH4(READ, q, 2, 3) + limb_upper_phase),
      signed_U_0_cos = OF4(SINES(cosine, 0), SINES(sine, 2), SINES(cosine, 4), SINES(sine, 6)),
      lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: geometry */
    const LIMB4 signed_lower_rotation_zx = signed_U_0_cos * lower_cos;
    /* each limb: loop closure; geometry */
    const LIMB4 t1 = t11 * signed_lower_rotation_zx + sign3 * (given - sign2 * given_2);
    OWN(t1) = signed_lower_rotation_zx * t1;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      t2 = signed_lower_sin * t11 + each_param_R + (sign2 * given_3 - given_4);
    OWN(t2) = signed_lower_sin * t2;
    const LIMB4 U_0_sin = OF4(SINES(sine, 0), SINES(cosine, 2), SINES(sine, 4), SINES(cosine, 6)),
      t4 = lower_cos * t2, minus_lower_rotation_yx = U_0_sin * lower_cos,
      t3 = given_5 - sign2 * given_6 - t11 * minus_lower_rotation_yx;
    OWN(t3) = minus_lower_rotation_yx * t3;
    const LIMB4 t10 = signed_U_0_cos * t3,
      signed_S_opening_fy = t4 + signed_lower_sin * (U_0_sin * t3 - signed_U_0_cos * t1);
    WRITE4(residual_, 1, 5, 8, 11, sign4 * signed_S_opening_fy);
    LIMB4 checked = signed_S_opening_fy;
    const LIMB4 signed_S_opening_fz = U_0_sin * t1 + t10;
    WRITE4(residual_, 2, 6, 9, 12, sign5 * signed_S_opening_fz);
    checked = checked + signed_S_opening_fz;
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
      t28 = t2 + t5, t17 = param_H * (1.0 - t9 * (t2 + t4)), t23 = 0.5 * (1.0 - t6 * t9),
      platform_turn_yy = 1.0 - t9 * t28, t10 = limb5_S_q_qz * t9, t11 = limb5_S_q_qx * t10, t12 = limb5_S_q_qy * t9,
      t26 = limb5_S_q_qw * (limb5_S_q_qx * t9), t13 = limb5_S_q_qw * t12, t19 = limb5_S_q_qx * t12,
      platform_turn_xz = t11 + t13, t14 = 0.5 * (t11 - t13), t18 = param_H * platform_turn_xz,
      t20 = limb5_S_q_qw * t10, t24 = limb5_S_q_qy * t10, platform_turn_yx = t19 + t20, platform_turn_xy = t19 -
          t20,
      t31 = 0.5 * platform_turn_yx, platform_turn_yz = t24 - t26, platform_turn_zy = t24 + t26,
      t27 = param_H * platform_turn_yz;
    FIRST_LIMB(0, closure, 0, stride, q, residual_, sine, cosine, t14, t17, t23, t18, t31, t27, &limbs);
    REAL checked0 = ALONE(limbs.checked[0]);
    NEXT_LIMB(2, closure, 0, stride, q, residual_, sine, cosine, t14, t17, t23, t18, t31, t27, &limbs);
    REAL checked1 = ALONE(limbs.checked[2]);
    /* limb1: loop closure; geometry */
    const REAL limb1_U2_opening_fx = limbs.t1[0] - (limbs.t3[0] - limbs.t2[0]);
    WRITE(residual_, 0, limb1_U2_opening_fx);
    REAL checked2 = limb1_U2_opening_fx;
    const REAL limb1_U_0_cos = SINES(cosine, 0), t35 = limb1_U_0_cos * platform_turn_zy,
      t32 = 0.5 * platform_turn_zy, /* platform */
      limb1_U_0_sin = SINES(sine, 0), limb1_lower_sin = SINES(sine, 1),
      t37 = limb1_lower_sin * (limb1_U_0_sin * platform_turn_yy - t35),
      t30 = 0.5 * platform_turn_yy, /* platform */
      limb1_lower_cos = SINES(cosine, 1), limb1_U2_opening_mn = t37 + limb1_lower_cos * platform_turn_xy;
    WRITE(residual_, 3, limb1_U2_opening_mn);
    REAL checked3 = limb1_U2_opening_mn;
    const REAL t21 = 0.5 * platform_turn_xy; /* platform */
    NEXT_LIMB(1, closure, 0, stride, q, residual_, sine, cosine, t18, t21, t27, t30, t17, t32, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[1]);
    NEXT_LIMB(3, closure, 0, stride, q, residual_, sine, cosine, t18, t21, t27, t30, t17, t32, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
    RESULT(checked2, residual_, 4, limbs.t3[1] - (limbs.t1[1] + limbs.t2[1]));
    RESULT(checked3, residual_, 10, limbs.t3[3] - (limbs.t1[3] + limbs.t2[3]));
    const REAL minus_limb3_S_opening_fx = limbs.t1[2] + (limbs.t2[2] - limbs.t3[2]);
    checked0 = checked0 + minus_limb3_S_opening_fx;
    WRITE(residual_, 7, -minus_limb3_S_opening_fx);
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
    const double *restrict sine, const double *restrict cosine, REAL platform_turn_yx, REAL platform_turn_zx,
    REAL platform_turn_xx, REAL platform_turn_yy, REAL platform_turn_zy, REAL platform_turn_xy,
    REAL platform_turn_yz, REAL platform_turn_zz, REAL platform_turn_xz, LIMBS(closure_jacobian) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = -sign1 * param_R;
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: reciprocal wrenches, eq. (10); results; geometry */
    const LIMB4 signed_base_lever_mx_by_S_fx = param_R * (U_0_cos * lower_cos);
    OWN(t1) = platform_turn_yx * signed_base_lever_mx_by_S_fx;
    OWN(t7) = platform_turn_yy * signed_base_lever_mx_by_S_fx;
    OWN(t13) = platform_turn_yz * signed_base_lever_mx_by_S_fx;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      signed_base_lever_mz_by_S_fx = param_R * (signed_U_0_sin * lower_cos);
    OWN(t2) = platform_turn_zx * signed_base_lever_mz_by_S_fx;
    OWN(t8) = platform_turn_zy * signed_base_lever_mz_by_S_fx;
    OWN(t14) = platform_turn_zz * signed_base_lever_mz_by_S_fx;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2), t1 = param_R * signed_lower_sin,
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    WRITE4(jacobian, 14, 57, 99, 141, upper_offset_x);
    const LIMB4 minus_S_arm_x = t1 - upper_offset_x, t8 = sign1 * upper_offset_x,
      minus_base_lever_mx_by_S_fy = U_0_cos * minus_S_arm_x;
    OWN(t3) = platform_turn_yx * minus_base_lever_mx_by_S_fy;
    const LIMB4 signed_base_lever_mz_by_S_fy = signed_U_0_sin * minus_S_arm_x;
    OWN(t4) = platform_turn_zx * signed_base_lever_mz_by_S_fy;
    OWN(t9) = platform_turn_yy * minus_base_lever_mx_by_S_fy;
    OWN(t15) = platform_turn_yz * minus_base_lever_mx_by_S_fy;
    OWN(t10) = platform_turn_zy * signed_base_lever_mz_by_S_fy;
    OWN(t16) = platform_turn_zz * signed_base_lever_mz_by_S_fy;
    const LIMB4 upper_position_x = signed_lower_sin * t8 + each_param_R,
      signed_U_0_lever_mz_by_S_fz = lower_cos * t8;
    WRITE4(jacobian, 2, 45, 87, 129, -sign1 * signed_U_0_lever_mz_by_S_fz);
    const LIMB4 t9 = sign1 * signed_U_0_lever_mz_by_S_fz, signed_base_lever_mz_by_S_fz = U_0_cos * upper_position_x;
    OWN(t5) = platform_turn_zx * signed_base_lever_mz_by_S_fz;
    const LIMB4 minus_base_lever_mx_by_S_fz = signed_U_0_sin * upper_position_x;
    OWN(t11) = platform_turn_zy * signed_base_lever_mz_by_S_fz;
    OWN(t17) = platform_turn_zz * signed_base_lever_mz_by_S_fz;
    OWN(t6) = platform_turn_xx * t9 + platform_turn_yx * minus_base_lever_mx_by_S_fz;
    const LIMB4 t7 = platform_turn_yz * minus_base_lever_mx_by_S_fz;
    OWN(t12) = platform_turn_xy * t9 + platform_turn_yy * minus_base_lever_mx_by_S_fz;
    OWN(t18) = platform_turn_xz * t9 + t7;
}

BODY(three_ups_upu_s_closure_jacobian)(size_t stride, const double *restrict q, double *restrict jacobian,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(closure_jacobian) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t48 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), platform_turn_zz = 1.0 - t9 * t48,
      platform_turn_xx = 1.0 - t6 * t9, t13 = limb5_S_q_qz * t9, t14 = limb5_S_q_qy * t13,
      t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t22 = limb5_S_q_qy * t9, platform_turn_zy = t14 + t16,
      platform_turn_yz = t14 - t16, limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_cos = SINES(cosine, 1),
      t21 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy), /* limb1 */
      t23 = limb5_S_q_qx * t22, t28 = limb5_S_q_qw * t22, t24 = limb5_S_q_qw * t13, t27 = limb5_S_q_qx * t13,
      platform_turn_xy = t23 - t24, platform_turn_yx = t23 + t24;
    /* limb1: geometry */
    const REAL limb1_lower_sin = SINES(sine, 1);
    /* limb1: reciprocal wrenches, eq. (10) */
    const REAL limb1_U2_constraint_mn_couple_z = t21 - limb1_lower_sin * platform_turn_xy;
    WRITE(jacobian, 16, limb1_U2_constraint_mn_couple_z);
    const REAL t32 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z,
      t35 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    WRITE(jacobian, 3, limb1_U_0_lever_mz_by_limb1_U2_mn);
    /* base: reciprocal wrenches, eq. (10) */
    const REAL base_lever_my_by_limb1_U2_mn = t32 - limb1_U_0_sin * limb1_U_0_lever_my_by_limb1_U2_mn,
      base_lever_mz_by_limb1_U2_mn = t35 + limb1_U_0_cos * limb1_U_0_lever_my_by_limb1_U2_mn;
    /* mechanism: results; geometry */
    const REAL t53 = platform_turn_yz * base_lever_my_by_limb1_U2_mn, platform_turn_xz = t27 + t28,
      platform_turn_zx = t27 - t28, t54 = platform_turn_xz * limb1_U_0_lever_mz_by_limb1_U2_mn + t53,
      t56 = t54 + platform_turn_zz * base_lever_mz_by_limb1_U2_mn;
    REAL checked0 = t56;
    WRITE(jacobian, 185, -t56);
    FIRST_LIMB(0, closure_jacobian, 0, stride, q, jacobian, sine, cosine, platform_turn_yx, platform_turn_zx,
        platform_turn_xx, platform_turn_yy, platform_turn_zy, platform_turn_xy, platform_turn_yz, platform_turn_zz,
        platform_turn_xz, &limbs);
    const REAL jacobian_184 = limbs.t18[0] - limbs.t17[0];
    WRITE(jacobian, 184, jacobian_184);
    REAL checked1 = jacobian_184;
    const REAL t51 = limbs.t15[0] + limbs.t16[0];
    WRITE(jacobian, 183, t51);
    REAL checked2 = t51;
    const REAL jacobian_171 = limbs.t12[0] - limbs.t11[0];
    WRITE(jacobian, 171, jacobian_171);
    REAL checked3 = jacobian_171;
    RESULT(checked0, jacobian, 170, limbs.t9[0] + limbs.t10[0]);
    RESULT(checked1, jacobian, 158, limbs.t6[0] - limbs.t5[0]);
    RESULT(checked2, jacobian, 157, limbs.t3[0] + limbs.t4[0]);
    const REAL t50 = limbs.t13[0] + limbs.t14[0];
    checked3 = checked3 + t50;
    WRITE(jacobian, 182, -t50);
    const REAL t43 = platform_turn_yy * base_lever_my_by_limb1_U2_mn,
      t33 = platform_turn_yx * base_lever_my_by_limb1_U2_mn,
      t44 = platform_turn_xy * limb1_U_0_lever_mz_by_limb1_U2_mn + t43,
      t34 = platform_turn_xx * limb1_U_0_lever_mz_by_limb1_U2_mn + t33,
      t46 = t44 + platform_turn_zy * base_lever_mz_by_limb1_U2_mn;
    checked0 = checked0 + t46;
    WRITE(jacobian, 172, -t46);
    const REAL t38 = t34 + platform_turn_zx * base_lever_mz_by_limb1_U2_mn;
    checked1 = checked1 + t38;
    WRITE(jacobian, 159, -t38);
    const REAL t40 = limbs.t7[0] + limbs.t8[0];
    checked2 = checked2 + t40;
    WRITE(jacobian, 169, -t40);
    const REAL t29 = limbs.t1[0] + limbs.t2[0];
    checked3 = checked3 + t29;
    WRITE(jacobian, 156, -t29);
    NEXT_LIMB(3, closure_jacobian, 0, stride, q, jacobian, sine, cosine, platform_turn_xx, platform_turn_zx,
        platform_turn_yx, platform_turn_xy, platform_turn_zy, platform_turn_yy, platform_turn_xz, platform_turn_zz,
        platform_turn_yz, &limbs);
    RESULT(checked0, jacobian, 194, limbs.t17[3] + limbs.t18[3]);
    RESULT(checked1, jacobian, 193, limbs.t15[3] - limbs.t16[3]);
    RESULT(checked2, jacobian, 192, limbs.t13[3] - limbs.t14[3]);
    RESULT(checked3, jacobian, 181, limbs.t11[3] + limbs.t12[3]);
    RESULT(checked0, jacobian, 180, limbs.t9[3] - limbs.t10[3]);
    RESULT(checked1, jacobian, 179, limbs.t7[3] - limbs.t8[3]);
    RESULT(checked2, jacobian, 168, limbs.t5[3] + limbs.t6[3]);
    RESULT(checked3, jacobian, 167, limbs.t3[3] - limbs.t4[3]);
    RESULT(checked0, jacobian, 166, limbs.t1[3] - limbs.t2[3]);
    NEXT_LIMB(2, closure_jacobian, 0, stride, q, jacobian, sine, cosine, platform_turn_yx, platform_turn_zx,
        platform_turn_xx, platform_turn_yy, platform_turn_zy, platform_turn_xy, platform_turn_yz, platform_turn_zz,
        platform_turn_xz, &limbs);
    NEXT_LIMB(1, closure_jacobian, 0, stride, q, jacobian, sine, cosine, platform_turn_xx, platform_turn_zx,
        platform_turn_yx, platform_turn_xy, platform_turn_zy, platform_turn_yy, platform_turn_xz, platform_turn_zz,
        platform_turn_yz, &limbs);
    RESULT(checked1, jacobian, 191, limbs.t18[2] - limbs.t17[2]);
    RESULT(checked2, jacobian, 190, limbs.t15[2] + limbs.t16[2]);
    RESULT(checked3, jacobian, 189, limbs.t13[2] + limbs.t14[2]);
    RESULT(checked0, jacobian, 188, limbs.t18[1] + limbs.t17[1]);
    RESULT(checked1, jacobian, 187, limbs.t15[1] - limbs.t16[1]);
    RESULT(checked2, jacobian, 186, limbs.t14[1] - limbs.t13[1]);
    RESULT(checked3, jacobian, 178, limbs.t12[2] - limbs.t11[2]);
    RESULT(checked0, jacobian, 177, limbs.t9[2] + limbs.t10[2]);
    RESULT(checked1, jacobian, 176, limbs.t7[2] + limbs.t8[2]);
    RESULT(checked2, jacobian, 175, limbs.t12[1] + limbs.t11[1]);
    RESULT(checked3, jacobian, 174, limbs.t9[1] - limbs.t10[1]);
    RESULT(checked0, jacobian, 173, limbs.t8[1] - limbs.t7[1]);
    RESULT(checked1, jacobian, 165, limbs.t6[2] - limbs.t5[2]);
    RESULT(checked2, jacobian, 164, limbs.t3[2] + limbs.t4[2]);
    RESULT(checked3, jacobian, 163, limbs.t1[2] + limbs.t2[2]);
    RESULT(checked0, jacobian, 162, limbs.t6[1] + limbs.t5[1]);
    RESULT(checked1, jacobian, 161, limbs.t3[1] - limbs.t4[1]);
    RESULT(checked2, jacobian, 160, limbs.t2[1] - limbs.t1[1]);
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
    EACH4 t1, t2, t3, lower_omega_y, signed_lower_omega_x, checked;
} LIMBS(closure_bias);

STAGE(closure_bias, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, REAL platform_twist_wy,
    REAL platform_twist_wz, REAL platform_twist_wx, LIMBS(closure_bias) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, 1.0, -1.0, -1.0), factor_2 = sign3 * 2.0;
    const LIMB4 t34 = sign1 * platform_twist_wy, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: loop closure; reciprocal wrenches, eq. (10); velocities, eq. (6) */
    const LIMB4 t1 = U_0_cos * t34, t8 = U_0_cos * platform_twist_wz - signed_U_0_sin * t34,
      lower_cos = IN_EACH4(SINES, cosine, 1, 2), signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      t11 = lower_cos * t8, t9 = signed_lower_sin * t8, t35 = sign2 * platform_twist_wx;
    OWN(t3) = t11 + signed_lower_sin * t35;
    OWN(t2) = lower_cos * t35 - t9;
    const LIMB4 signed_S_arm_y = param_R * lower_cos, t13 = signed_S_arm_y * OWN(t3),
      upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      S_arm_x = upper_offset_x - param_R * signed_lower_sin, t15 = t13 + S_arm_x * OWN(t2), t16 = OWN(t2) * t15,
      t25 = OWN(t3) * t15;
    OWN(t1) = t1 + signed_U_0_sin * platform_twist_wz;
    const LIMB4 t4 = S_arm_x * OWN(t1), t23 = signed_S_arm_y * OWN(t1), U_v_0 = IN_EACH4(READ, v, 0, 3),
      t17 = OWN(t1) * t4 + t16, t29 = OWN(t2) * t23 - OWN(t3) * t4, t37 = sign3 * (OWN(t1) * t23 + t25);
    OWN(lower_omega_y) = U_v_0 * lower_cos;
    const LIMB4 t36 = sign3 * OWN(lower_omega_y), U_v_1 = IN_EACH4(READ, v, 1, 3),
      S_opening_bias_fx = t17 - upper_offset_x * (t36 * t36 + U_v_1 * U_v_1);
    WRITE4(bias, 0, 4, 7, 10, S_opening_bias_fx);
    LIMB4 checked = S_opening_bias_fx;
    OWN(signed_lower_omega_x) = U_v_0 * signed_lower_sin;
    const LIMB4 P_v = IN_EACH4(READ, v, 2, 3), t20 = upper_offset_x * (OWN(signed_lower_omega_x) * t36),
      S_opening_bias_fz = t29 + factor_2 * (upper_offset_x * (U_v_1 * OWN(signed_lower_omega_x)) - P_v * t36);
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
      t30 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5), limb5_S_v_wz = READ(v, 14), limb5_S_v_wx =
          READ(v, 12),
      t32 = limb5_S_v_wz * (1.0 - t9 * t30), t24 = limb5_S_v_wx * (1.0 - t6 * t9), t13 = limb5_S_q_qy * t9,
      t14 = limb5_S_q_qx * t13, t28 = limb5_S_q_qw * t13, t15 = limb5_S_q_qz * t9,
      t21 = limb5_S_q_qw * (limb5_S_q_qx * t9), t16 = limb5_S_q_qw * t15, platform_turn_yx = t14 + t16,
      platform_turn_xy = t14 - t16, limb5_S_v_wy = READ(v, 13),
      t18 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, t19 = limb5_S_q_qy * t15,
      t27 = limb5_S_q_qx * t15, platform_turn_yz = t19 - t21, platform_turn_zy = t19 + t21,
      platform_twist_wy = t18 + limb5_S_v_wz * platform_turn_yz, t29 = limb5_S_v_wz * (t27 + t28),
      platform_twist_wz = t32 + (limb5_S_v_wx * (t27 - t28) + limb5_S_v_wy * platform_turn_zy),
      platform_twist_wx = t24 + limb5_S_v_wy * platform_turn_xy + t29;
    FIRST_LIMB(1, closure_bias, 0, stride, q, v, bias, sine, cosine, platform_twist_wx, platform_twist_wz,
        platform_twist_wy, &limbs);
    REAL checked0 = ALONE(limbs.checked[1]);
    NEXT_LIMB(2, closure_bias, 0, stride, q, v, bias, sine, cosine, platform_twist_wy, platform_twist_wz,
        platform_twist_wx, &limbs);
    REAL checked1 = ALONE(limbs.checked[2]);
    NEXT_LIMB(3, closure_bias, 0, stride, q, v, bias, sine, cosine, platform_twist_wx, platform_twist_wz,
        platform_twist_wy, &limbs);
    REAL checked2 = ALONE(limbs.checked[3]);
    NEXT_LIMB(0, closure_bias, 0, stride, q, v, bias, sine, cosine, platform_twist_wy, platform_twist_wz,
        platform_twist_wx, &limbs);
    REAL checked3 = ALONE(limbs.checked[0]);
    /* limb1: loop closure; geometry; reciprocal wrenches, eq. (10) */
    const REAL t39 = limbs.lower_omega_y[0] - limbs.t2[0], limb1_U_0_sin = SINES(sine, 0),
      limb1_U_0_cos = SINES(cosine, 0), t42 = limb1_U_0_cos * platform_turn_zy,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t43 = limb1_U_0_sin * platform_turn_yy - t42, limb1_U_v_1 = READ(v, 1),
      t40 = limb1_U2_constraint_mn_couple_x * t39, t36 = limb1_U_v_1 - limbs.t1[0], limb1_lower_sin =
          SINES(sine, 1),
      limb1_lower_cos = SINES(cosine, 1), t51 = limb1_lower_cos * t43,
      limb1_U2_opening_mn = limb1_lower_sin * t43 + limb1_lower_cos * platform_turn_xy,
      limb1_U2_constraint_mn_couple_z = t51 - limb1_lower_sin * platform_turn_xy,
      t48 = t36 * (t40 - limb1_U2_opening_mn * t36), t49 = limbs.signed_lower_omega_x[0] - limbs.t3[0],
      t56 = t48 - t49 * (limb1_U2_opening_mn * t49 + limb1_U2_constraint_mn_couple_z * t39),
      t60 = limb1_U2_constraint_mn_couple_z * (limbs.signed_lower_omega_x[0] * t39 - limbs.lower_omega_y[0] * t49),
      t65 = t60 - limb1_U2_constraint_mn_couple_x * (limb1_U_v_1 * t39 + limbs.lower_omega_y[0] * limbs.t1[0]);
    RESULT(checked0, bias, 3, t56 - t65);
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
      each_param_R = sign2 * param_R, sign3 = OF4(1.0, 1.0, -1.0, 1.0), sign4 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: velocities, eq. (6) */
    const LIMB4 t8 = signed_U_0_sin * limb5_S_joint_rate_wz + U_0_cos * GIVEN(signed_limb5_S_joint_rate_wy),
      P_joint_rate = each_param_R * IN_EACH4(SINES, cosine, 1, 2) * t8;
    WRITE4(v, 2, 5, 8, 11, P_joint_rate);
    LIMB4 checked = OWN(checked) + P_joint_rate;
    const LIMB4 signed_U_joint_rate_1 = OWN(t2) * (OWN(S_arm_x) * t8);
    WRITE4(v, 1, 4, 7, 10, sign3 * signed_U_joint_rate_1);
    checked = checked + signed_U_joint_rate_1;
    const LIMB4 t4 = OWN(signed_upper_position_x) * (U_0_cos * limb5_S_joint_rate_wz - signed_U_0_sin *
        GIVEN(signed_limb5_S_joint_rate_wy)),
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
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] *
        (limb1_U2_constraint_mn_couple_z * limbs.t2[0]),
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
      t46 = 0.5 * (t39 - t44), t40 = 0.5 * t39, limb5_S_y_dot_qx = READ(y_dot, 0), limb5_S_y_dot_qy =
          READ(y_dot, 1),
      t47 = t40 * t46, t41 = t40 * limb5_S_y_dot_qx, t55 = limb5_S_y_dot_qy * t46,
      t49 = limb5_S_q_qx * t35 * limb5_S_null_space_wz_by_limb5_S_wy, t36 = limb5_S_q_qw * t35,
      t51 = 0.5 * (t36 + t49), t37 = 0.5 * t36, a_pivot = t47 + t37 * t51;
    REAL checked1 = a_pivot;
    const REAL t53 = 1.0 / a_pivot, limb5_S_joint_rate_wy = (t37 * limb5_S_y_dot_qy + t41) * t53,
      limb5_S_joint_rate_wz = t30 * (t33 * limb5_S_joint_rate_wy), t61 = platform_turn_yx * limb5_S_joint_rate_wy,
      minus_limb5_S_joint_rate_wx = t53 * (t55 - limb5_S_y_dot_qx * t51),
      t64 = t61 - platform_turn_xx * minus_limb5_S_joint_rate_wx, t65 = platform_turn_zy * limb5_S_joint_rate_wz,
      platform_omega_y = t65 + (platform_turn_yy * limb5_S_joint_rate_wy - platform_turn_xy *
          minus_limb5_S_joint_rate_wx);
    WRITE(v, 13, platform_omega_y);
    REAL checked2 = platform_omega_y;
    const REAL t71 = platform_turn_zz * limb5_S_joint_rate_wz, t72 = platform_turn_yz * limb5_S_joint_rate_wy,
      platform_turn_xz = t58 + t59, platform_omega_x = (t58 - t59) * limb5_S_joint_rate_wz + t64;
    WRITE(v, 12, platform_omega_x);
    REAL checked3 = platform_omega_x;
    RESULT(checked0, v, 14, t71 + (t72 - platform_turn_xz * minus_limb5_S_joint_rate_wx));
    const EACH4 signed_limb5_S_joint_rate_wy = {limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx,
        limb5_S_joint_rate_wy, minus_limb5_S_joint_rate_wx},
      signed_limb5_S_joint_rate_wx = {minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy,
          minus_limb5_S_joint_rate_wx, limb5_S_joint_rate_wy};
    FIRST_LIMB(0, velocity, 1, stride, v, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy,
        signed_limb5_S_joint_rate_wx, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[0]);
    NEXT_LIMB(1, velocity, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(1, velocity, 1, stride, v, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy,
        signed_limb5_S_joint_rate_wx, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, velocity, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(2, velocity, 1, stride, v, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy,
        signed_limb5_S_joint_rate_wx, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, velocity, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(3, velocity, 1, stride, v, sine, cosine, limb5_S_joint_rate_wz, signed_limb5_S_joint_rate_wy,
        signed_limb5_S_joint_rate_wx, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
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
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] *
        (limb1_U2_constraint_mn_couple_z * limbs.t2[0]),
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
      limb5_S_null_space_wz_by_limb5_S_wy = t34 * t37, t44 = limb5_S_q_qy * t9 *
          limb5_S_null_space_wz_by_limb5_S_wy,
      t41 = limb5_S_q_qz * t9, t46 = 0.5 * (t41 - t44), t42 = 0.5 * t41, t47 = t42 * t46,
      t38 = limb5_S_q_qx * t9 * limb5_S_null_space_wz_by_limb5_S_wy, t10 = limb5_S_q_qw * t9,
      t40 = 0.5 * (t10 + t38), t48 = 0.5 * t10, a_pivot = t47 + t48 * t40;
    REAL checked1 = a_pivot;
    const REAL t50 = 1.0 / a_pivot, limb5_S_null_space_wy_by_limb5_S_qx = t42 * t50,
      limb5_S_null_space_wx_by_limb5_S_qx = t40 * t50, limb5_S_null_space_wy_by_limb5_S_qy = t48 * t50,
      t70 = t46 * t50, limb5_S_null_space_wz_by_limb5_S_qx = t34 * (t37 * limb5_S_null_space_wy_by_limb5_S_qx),
      limb5_S_null_space_wz_by_limb5_S_qy = t34 * (t37 * limb5_S_null_space_wy_by_limb5_S_qy);
    FIRST_LIMB(0, null_space, 1, stride, null_space, sine, cosine, limb5_S_null_space_wz_by_limb5_S_qx,
        limb5_S_null_space_wy_by_limb5_S_qx, limb5_S_null_space_wx_by_limb5_S_qx,
        limb5_S_null_space_wz_by_limb5_S_qy, limb5_S_null_space_wy_by_limb5_S_qy, t70, &limbs);
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
    NEXT_LIMB(1, null_space, 1, stride, null_space, sine, cosine, limb5_S_null_space_wz_by_limb5_S_qx,
        limb5_S_null_space_wx_by_limb5_S_qx, limb5_S_null_space_wy_by_limb5_S_qx,
        limb5_S_null_space_wz_by_limb5_S_qy, t70, limb5_S_null_space_wy_by_limb5_S_qy, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, null_space, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(2, null_space, 1, stride, null_space, sine, cosine, limb5_S_null_space_wz_by_limb5_S_qx,
        limb5_S_null_space_wy_by_limb5_S_qx, limb5_S_null_space_wx_by_limb5_S_qx,
        limb5_S_null_space_wz_by_limb5_S_qy, limb5_S_null_space_wy_by_limb5_S_qy, t70, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, null_space, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(3, null_space, 1, stride, null_space, sine, cosine, limb5_S_null_space_wz_by_limb5_S_qx,
        limb5_S_null_space_wx_by_limb5_S_qx, limb5_S_null_space_wy_by_limb5_S_qx,
        limb5_S_null_space_wz_by_limb5_S_qy, t70, limb5_S_null_space_wy_by_limb5_S_qy, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 signed_U_0_lever_mz_by_S_fz, t1, signed_upper_position_x, S_arm_x, t2, t3, t4, t5, t6, t7, t8, t9,
      t10, t11, checked;
} LIMBS(acceleration);

STAGE(acceleration, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict sine, const double *restrict cosine, LIMBS(acceleration) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0);
    /* each limb: geometry; reciprocal wrenches, eq. (10); accelerations */
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(signed_upper_position_x) = signed_lower_sin * upper_offset_x + (-param_R);
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    const LIMB4 t7 = sign1 * IN_EACH4(SINES, cosine, 1, 2);
    OWN(signed_U_0_lever_mz_by_S_fz) = t7 * upper_offset_x;
    LIMB4 checked = OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(t1) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(t2) = t7 * OWN(t1);
    const LIMB4 U_v_1 = IN_EACH4(READ, v, 1, 3);
    OWN(t3) = U_v_1 * signed_lower_sin;
    const LIMB4 P_v = IN_EACH4(READ, v, 2, 3);
    OWN(t4) = upper_offset_x * OWN(t3) - P_v * t7;
    const LIMB4 t4 = U_v_1 * t7, t5 = upper_offset_x * t4;
    OWN(t10) = P_v + (-param_R) * t4;
    OWN(t6) = P_v * signed_lower_sin + t5;
    OWN(checked) = checked;
}

STAGE(acceleration, 1)(size_t limb, size_t stride, const double *restrict v, const double *restrict sine,
    const double *restrict cosine, const EACH4 platform_twist_wx, const EACH4 platform_twist_wy,
    REAL platform_twist_wz, LIMBS(acceleration) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 t11 = sign1 * GIVEN(platform_twist_wy), U_0_cos = IN_EACH4(SINES, cosine, 0, 2),
      signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: accelerations */
    const LIMB4 t2 = signed_U_0_sin * t11;
    OWN(t7) = U_0_cos * t11 + signed_U_0_sin * platform_twist_wz;
    OWN(t11) = OWN(t7) * OWN(t10);
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3),
      t9 = U_v_0 * (OWN(t4) + sign1 * (OWN(signed_upper_position_x) * OWN(t7)));
    OWN(t5) = t2 - U_0_cos * platform_twist_wz;
    OWN(t9) = U_v_0 * OWN(t5);
    OWN(t8) = GIVEN(platform_twist_wx) * OWN(t4) - (OWN(t5) * (sign1 * OWN(t6)) + t9);
}

STAGE(acceleration, 2)(size_t limb, size_t stride, double *restrict a, const double *restrict sine,
    const double *restrict cosine, REAL given, const EACH4 signed_limb5_S_joint_acc_wy,
    REAL minus_limb5_S_joint_acc_still_wz, const EACH4 signed_limb5_S_joint_acc_wx, const EACH4 given_2,
    const EACH4 given_3, LIMBS(acceleration) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, 1.0, -1.0, 1.0),
      sign3 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = -sign3 * param_R, sign4 = OF4(1.0, -1.0, -1.0, -1.0),
      sign5 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2);
    /* each limb: accelerations */
    const LIMB4 t4 = OWN(signed_upper_position_x) * (U_0_cos * given - signed_U_0_sin *
        GIVEN(signed_limb5_S_joint_acc_wy)),
      t7 = sign1 * OWN(t8) - OWN(signed_upper_position_x) * (U_0_cos * minus_limb5_S_joint_acc_still_wz),
      signed_U_joint_acc_0 = OWN(t1) * (t4 + t7) + GIVEN(signed_limb5_S_joint_acc_wx);
    WRITE4(a, 0, 3, 6, 9, -sign1 * signed_U_joint_acc_0);
    LIMB4 checked = OWN(checked) + signed_U_joint_acc_0;
    const LIMB4 t12 = signed_U_0_sin * given + U_0_cos * GIVEN(signed_limb5_S_joint_acc_wy),
      signed_U_joint_acc_1 = OWN(t2) * (GIVEN(given_2) - sign2 * (OWN(S_arm_x) * t12));
    WRITE4(a, 1, 4, 7, 10, -sign4 * signed_U_joint_acc_1);
    checked = checked + signed_U_joint_acc_1;
    const LIMB4 t19 = param_R * IN_EACH4(SINES, cosine, 1, 2) * (GIVEN(given_3) + (OWN(t9) - t12)),
      signed_P_joint_acc = each_param_R * OWN(t3) * OWN(t7) - t19;
    WRITE4(a, 2, 5, 8, 11, sign5 * signed_P_joint_acc);
    checked = checked + signed_P_joint_acc;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_acceleration)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict y_ddot, double *restrict a, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    LIMBS(acceleration) limbs;
    /* limb5_S: geometry; accelerations; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t10 = t2 + t5,
      t65 = t2 + t4, t9 = 4.0 - 2.0 * t7, platform_turn_xx = 1.0 - t6 * t9, platform_turn_yy = 1.0 - t9 * t10,
      platform_turn_zz = 1.0 - t9 * t65, t35 = k2 - 0.5 * t7, t24 = limb5_S_q_qy * t9, t25 = limb5_S_q_qx * t24,
      t56 = limb5_S_q_qw * t24, t13 = limb5_S_q_qz * t9, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9),
      t26 = limb5_S_q_qw * t13, platform_turn_xy = t25 - t26, platform_turn_yx = t25 + t26,
      limb5_S_v_wy = READ(v, 13), limb5_S_v_wx = READ(v, 12),
      t54 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy, t55 = limb5_S_q_qx * t13,
      t14 = limb5_S_q_qy * t13, platform_turn_xz = t55 + t56, platform_turn_zx = t55 - t56,
      limb5_S_v_wz = READ(v, 14), platform_twist_wx = t54 + limb5_S_v_wz * platform_turn_xz,
      t61 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, platform_turn_yz = t14 - t16,
      platform_turn_zy = t14 + t16, platform_twist_wy = t61 + limb5_S_v_wz * platform_turn_yz;
    const EACH4 platform_twist_wx_2 = {platform_twist_wx, platform_twist_wy, platform_twist_wx, platform_twist_wy},
      platform_twist_wy_2 = {platform_twist_wy, platform_twist_wx, platform_twist_wy, platform_twist_wx};
    const REAL t70 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t70;
    FIRST_LIMB(0, acceleration, 0, stride, q, v, sine, cosine, &limbs);
    FIRST_LIMB(0, acceleration, 1, stride, v, sine, cosine, platform_twist_wx_2, platform_twist_wy_2,
        platform_twist_wz, &limbs);
    /* limb1: geometry; accelerations; reciprocal wrenches, eq. (10) */
    const REAL limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1), limb1_U_v_0 = READ(v, 0),
      t99 = limb1_lower_cos * limbs.t5[0] - limb1_lower_sin * platform_twist_wx, /* limb5_S */
      limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin, t100 = limb1_lower_omega_x + t99, /* limb5_S */
      limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      t22 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t23 = limb1_lower_cos * t22,
      limb1_U2_opening_mn = limb1_lower_sin * t22 + limb1_lower_cos * platform_turn_xy;
    /* limb5_S: accelerations; pivots; rates that follow */
    const REAL t103 = limb1_U2_opening_mn * t100,
      t106 = limb1_lower_sin * limbs.t5[0] + limb1_lower_cos * platform_twist_wx,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, t107 = limb1_lower_omega_y - t106,
      t117 = limb1_lower_omega_x * t107, limb1_U2_constraint_mn_couple_z = t23 - limb1_lower_sin * platform_turn_xy,
      t110 = t100 * (t103 + limb1_U2_constraint_mn_couple_z * t107),
      t120 = limb1_U2_constraint_mn_couple_z * (t117 - limb1_lower_omega_y * t100),
      t122 = limb1_lower_omega_y * limbs.t7[0],
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      limb1_U_v_1 = READ(v, 1), t112 = limb1_U2_constraint_mn_couple_x * t107,
      t125 = t120 - limb1_U2_constraint_mn_couple_x * (limb1_U_v_1 * t107 + t122), t111 = limb1_U_v_1 - limbs.t7[0],
      limb1_P_v = READ(v, 2), t126 = t110 - t111 * (t112 - limb1_U2_opening_mn * t111) + t125,
      t95 = limbs.S_arm_x[0] * limbs.t9[0] + limb1_U_v_1 * limb1_P_v - limbs.t11[0],
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t2[0],
      t127 = t95 * limb1_U_factor_1_by_3 + t126,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      t128 = minus_limb1_U_factor_0_by_3 * limbs.t8[0] + t127,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn + limbs.signed_upper_position_x[0] *
          minus_limb1_U_factor_0_by_3,
      t32 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3, /* limb1 */
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin *
          minus_limb1_U2_factor_0_by_3;
    REAL checked0 = minus_limb5_S_pivot_wz;
    const REAL t30 = 1.0 / minus_limb5_S_pivot_wz, minus_limb5_S_joint_acc_still_wz = t30 * t128,
      t33 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t32, /* limb1 */
      t38 = limb5_S_q_qy * t35, t129 = t38 * minus_limb5_S_joint_acc_still_wz, t76 = platform_twist_wx * t38,
      t45 = limb5_S_q_qx * t35, t78 = t76 - platform_twist_wy * t45, t43 = limb5_S_q_qw * t35,
      t36 = limb5_S_q_qz * t35, t80 = 0.5 * (platform_twist_wz * t43 + t78), t81 = platform_twist_wy * t80,
      t142 = platform_twist_wx * t80,
      t87 = 0.5 * (platform_twist_wy * t43 + (platform_twist_wz * t45 - platform_twist_wx * t36)),
      t89 = t81 - platform_twist_wz * t87,
      t73 = 0.5 * (platform_twist_wx * t45 + platform_twist_wy * t38 + platform_twist_wz * t36),
      t132 = READ(y_ddot, 0) + 0.5 * (platform_twist_wx * t73 - t89 - t129), t135 = platform_twist_wx * t43,
      t134 = platform_twist_wy * t73, t136 = platform_twist_wy * t36, t37 = 0.5 * t36, t133 = t37 * t132,
      t145 = t45 * minus_limb5_S_joint_acc_still_wz,
      t143 = platform_twist_wz * (0.5 * (t135 + (t136 - platform_twist_wz * t38))) - t142,
      t148 = READ(y_ddot, 1) + 0.5 * (t134 - t143 + t145), t44 = 0.5 * t43, t150 = t133 + t44 * t148,
      limb5_S_null_space_wz_by_limb5_S_wy = t30 * t33, t47 = t43 + t45 * limb5_S_null_space_wz_by_limb5_S_wy,
      t41 = 0.5 * (t36 - t38 * limb5_S_null_space_wz_by_limb5_S_wy), t42 = t37 * t41, t153 = t41 * t148,
      t48 = 0.5 * t47, a_pivot = t42 + t44 * t48;
    REAL checked1 = a_pivot;
    const REAL t155 = t153 - t48 * t132, t50 = 1.0 / a_pivot, limb5_S_joint_acc_wy = t50 * t150,
      minus_limb5_S_joint_acc_wx = t50 * t155, t152 = t30 * (t33 * limb5_S_joint_acc_wy);
    /* limb5_S: results; accelerations */
    const REAL t179 = platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx,
      t183 = platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx,
      t187 = platform_turn_yz * limb5_S_joint_acc_wy - platform_turn_xz * minus_limb5_S_joint_acc_wx,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz - t152,
      limb5_S_a_wx = t179 - platform_turn_zx * minus_limb5_S_joint_acc_wz;
    WRITE(a, 12, limb5_S_a_wx);
    REAL checked2 = limb5_S_a_wx;
    const REAL limb5_S_a_wy = t183 - platform_turn_zy * minus_limb5_S_joint_acc_wz;
    WRITE(a, 13, limb5_S_a_wy);
    REAL checked3 = limb5_S_a_wy;
    RESULT(checked0, a, 14, t187 - platform_turn_zz * minus_limb5_S_joint_acc_wz);
    const EACH4 signed_limb5_S_joint_acc_wy = {limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx,
        limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx},
      signed_limb5_S_joint_acc_wx = {minus_limb5_S_joint_acc_wx, limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx,
          limb5_S_joint_acc_wy};
    const REAL minus_limb2_U_0_cos = SINES(sine, 2),
      t160 = minus_limb2_U_0_cos * minus_limb5_S_joint_acc_still_wz; /* limb2 */
    NEXT_LIMB(1, acceleration, 0, stride, q, v, sine, cosine, &limbs);
    NEXT_LIMB(1, acceleration, 1, stride, v, sine, cosine, platform_twist_wx_2, platform_twist_wy_2,
        platform_twist_wz, &limbs);
    const REAL limb2_U_v_1 = READ(v, 4), limb2_P_v = READ(v, 5), minus_limb4_U_0_cos = SINES(sine, 6),
      t189 = -(limbs.t11[1] + (limb2_U_v_1 * limb2_P_v - limbs.S_arm_x[1] * (limbs.t9[1] + t160))),
      t172 = minus_limb4_U_0_cos * minus_limb5_S_joint_acc_still_wz; /* limb4 */
    NEXT_LIMB(3, acceleration, 0, stride, q, v, sine, cosine, &limbs);
    NEXT_LIMB(3, acceleration, 1, stride, v, sine, cosine, platform_twist_wx_2, platform_twist_wy_2,
        platform_twist_wz, &limbs);
    const REAL limb4_U_v_1 = READ(v, 10), limb4_P_v = READ(v, 11), limb3_U_0_sin = SINES(sine, 4),
      t190 = -(limbs.t11[3] + (limb4_U_v_1 * limb4_P_v - limbs.S_arm_x[3] * (limbs.t9[3] + t172))),
      t166 = limb3_U_0_sin * minus_limb5_S_joint_acc_still_wz; /* limb3 */
    NEXT_LIMB(2, acceleration, 0, stride, q, v, sine, cosine, &limbs);
    NEXT_LIMB(2, acceleration, 1, stride, v, sine, cosine, platform_twist_wx_2, platform_twist_wy_2,
        platform_twist_wz, &limbs);
    const REAL limb3_U_v_1 = READ(v, 7), limb3_P_v = READ(v, 8),
      t170 = limbs.t11[2] - (limb3_U_v_1 * limb3_P_v + limbs.S_arm_x[2] * (limbs.t9[2] + t166)), /* limb3 */
      t156 = limb1_U_0_sin * minus_limb5_S_joint_acc_still_wz; /* limb1 */
    const EACH4 given_3 = {t156, t160, t166, t172}, given_2 = {t95 + limbs.S_arm_x[0] * t156, t189, t170, t190};
    FIRST_LIMB(0, acceleration, 2, stride, a, sine, cosine, t152, signed_limb5_S_joint_acc_wy,
        minus_limb5_S_joint_acc_still_wz, signed_limb5_S_joint_acc_wx, given_2, given_3, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[0]);
    NEXT_LIMB(1, acceleration, 2, stride, a, sine, cosine, t152, signed_limb5_S_joint_acc_wy,
        minus_limb5_S_joint_acc_still_wz, signed_limb5_S_joint_acc_wx, given_2, given_3, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, acceleration, 2, stride, a, sine, cosine, t152, signed_limb5_S_joint_acc_wy,
        minus_limb5_S_joint_acc_still_wz, signed_limb5_S_joint_acc_wx, given_2, given_3, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, acceleration, 2, stride, a, sine, cosine, t152, signed_limb5_S_joint_acc_wy,
        minus_limb5_S_joint_acc_still_wz, signed_limb5_S_joint_acc_wx, given_2, given_3, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[3]);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.signed_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 minus_U_0_lever_mz_by_S_fz, t1, signed_S_opening_fz, signed_upper_position_x, S_arm_x, t2, t3,
      signed_S_opening_fy, signed_S_arm_y, t4, t5, signed_P_null_space_by_limb5_S_wy, t6,
      signed_U_null_space_1_by_limb5_S_wy, signed_U_null_space_0_by_limb5_S_wy, t7, t8, S_opening_fx, t9,
      t10, t11, t12, P_q_next, t13, t14, t15, checked;
} LIMBS(close_position);

STAGE(close_position, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict sine,
    const double *restrict cosine, REAL given, REAL given_2, REAL given_3, REAL given_4, REAL given_5,
    REAL given_6, LIMBS(close_position) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, -1.0),
      sign3 = OF4(1.0, 1.0, -1.0, 1.0), sign4 = OF4(1.0, -1.0, 1.0, 1.0);
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: reciprocal wrenches, eq. (10); geometry; rates that follow */
    OWN(signed_S_arm_y) = param_R * lower_cos;
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    OWN(S_arm_x) = upper_offset_x - param_R * signed_lower_sin;
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * upper_offset_x;
    OWN(t1) = 1.0 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    const LIMB4 signed_U_0_cos = OF4(SINES(cosine, 0), SINES(sine, 2), SINES(cosine, 4), SINES(sine, 6)),
      t16 = sign3 * (given_3 - sign1 * given_4), signed_lower_rotation_zx = signed_U_0_cos * lower_cos;
    /* each limb: loop closure; geometry; results */
    const LIMB4 t3 = upper_offset_x * signed_lower_rotation_zx + t16;
    OWN(t7) = signed_lower_rotation_zx * t3;
    const LIMB4 U_0_sin = OF4(SINES(sine, 0), SINES(cosine, 2), SINES(sine, 4), SINES(cosine, 6)),
      t14 = sign2 * (given - sign1 * given_2), minus_lower_rotation_yx = U_0_sin * lower_cos,
      t1 = upper_offset_x * minus_lower_rotation_yx - t14;
    OWN(t8) = minus_lower_rotation_yx * t1;
    OWN(signed_upper_position_x) = signed_lower_sin * upper_offset_x + (-param_R);
    const LIMB4 t7 = U_0_sin * t1;
    OWN(signed_S_opening_fz) = signed_U_0_cos * t1 - U_0_sin * t3;
    const LIMB4 t11 = per_length * OWN(signed_S_opening_fz);
    OWN(t13) = t11 * t11;
    const LIMB4 t10 = signed_lower_sin * (t7 + signed_U_0_cos * t3);
    OWN(t3) = OWN(signed_upper_position_x) + sign4 * (given_5 - sign1 * given_6);
    OWN(signed_S_opening_fy) = t10 - lower_cos * OWN(t3);
    const LIMB4 t12 = per_length * OWN(signed_S_opening_fy);
    OWN(t14) = t12 * t12;
}

STAGE(close_position, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL limb5_S_null_space_wz_by_limb5_S_wy, REAL given, REAL given_2,
    LIMBS(close_position) *own)
{
    (void)limb, (void)stride;
    /* each limb: rates that follow; loop closure; results */
    OWN(t4) = OF4(SINES(cosine, 0), SINES(sine, 2), SINES(cosine, 4), SINES(sine, 6)) *
        limb5_S_null_space_wz_by_limb5_S_wy;
    OWN(t5) = OF4(SINES(sine, 0), SINES(cosine, 2), SINES(sine, 4), SINES(cosine, 6)) *
        limb5_S_null_space_wz_by_limb5_S_wy;
    OWN(S_opening_fx) = IN_EACH4(SINES, sine, 1, 2) * OWN(t3) + given + given_2;
    const LIMB4 t3 = (-per_length) * OWN(S_opening_fx);
    OWN(t15) = t3 * t3;
}

STAGE(close_position, 2)(size_t limb, size_t stride, REAL given, REAL given_2, LIMBS(close_position) *own)
{
    (void)limb, (void)stride;
    /* each limb: rates that follow; results; pivots */
    OWN(signed_P_null_space_by_limb5_S_wy) = OWN(signed_S_arm_y) * given;
    OWN(t6) = 2.2795812745707664 * OWN(signed_P_null_space_by_limb5_S_wy);
    OWN(t9) = OWN(signed_P_null_space_by_limb5_S_wy) * OWN(t6);
    OWN(signed_U_null_space_1_by_limb5_S_wy) = OWN(t2) * (OWN(S_arm_x) * given);
    OWN(t10) = OWN(signed_U_null_space_1_by_limb5_S_wy) * OWN(signed_U_null_space_1_by_limb5_S_wy);
    OWN(signed_U_null_space_0_by_limb5_S_wy) = OWN(t1) * given_2;
    OWN(t11) = OWN(signed_U_null_space_0_by_limb5_S_wy) * OWN(signed_U_null_space_0_by_limb5_S_wy);
}

STAGE(close_position, 3)(size_t limb, size_t stride, const double *restrict q, double *restrict q_next,
    REAL given, REAL given_2, REAL given_3, REAL given_4, REAL P_q, LIMBS(close_position) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0);
    const LIMB4 t6 = sign1 * given;
    /* each limb: results */
    OWN(t12) = OWN(signed_U_null_space_1_by_limb5_S_wy) * t6;
    const LIMB4 U_q_next_0 = IN_EACH4(READ, q, 0, 3) - (given_3 - sign2 * (given_2 -
        OWN(signed_U_null_space_0_by_limb5_S_wy) * t6));
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
      platform_turn_xy = t11 - t13, t14 = 0.5 * (t11 + t13);
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; results */
    const REAL limb1_U2_constraint_mn_couple_z = t37 - limb1_lower_sin * platform_turn_xy,
      platform_turn_xz = t23 + t24, t25 = 0.5 * (t23 - t24), /* platform */
      t26 = param_H * platform_turn_xz; /* platform */
    FIRST_LIMB(0, close_position, 0, stride, q, sine, cosine, t14, t18, t25, t21, t46, t26, &limbs);
    REAL checked0 = limbs.minus_U_0_lever_mz_by_S_fz[0];
    NEXT_LIMB(2, close_position, 0, stride, q, sine, cosine, t14, t18, t25, t21, t46, t26, &limbs);
    REAL checked1 = limbs.minus_U_0_lever_mz_by_S_fz[2];
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t2[0],
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      t48 = limb1_U_factor_1_by_3 * limbs.signed_S_opening_fy[0], t40 = limb1_U_0_sin *
          minus_limb1_U2_factor_0_by_3,
      t77 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3, t31 = limb1_U_0_sin * platform_turn_zy,
      t22 = 0.5 * platform_turn_zy, /* platform */
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + t31,
      t47 = 0.5 * platform_turn_yy, /* platform */
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn + limbs.signed_upper_position_x[0] *
          minus_limb1_U_factor_0_by_3,
      t42 = limbs.signed_S_opening_fz[0] * minus_limb1_U_factor_0_by_3;
    /* limb5_S: pivots; results; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t40;
    REAL checked2 = minus_limb5_S_pivot_wz;
    const REAL t41 = 1.0 / minus_limb5_S_pivot_wz,
      limb5_S_null_space_wz_by_limb5_S_wy = t41 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t77);
    FIRST_LIMB(0, close_position, 1, stride, sine, cosine, limb5_S_null_space_wz_by_limb5_S_wy, limbs.t8[0],
        limbs.t7[0], &limbs);
    const REAL t263 = -(limbs.signed_upper_position_x[0] * (limb1_U_0_sin - limbs.t4[0]));
    FIRST_LIMB(0, close_position, 2, stride, limb1_U_0_cos + limbs.t5[0], t263, &limbs);
    const REAL limb1_U2_opening_mn = t43 + limb1_lower_cos * platform_turn_xy;
    /* mechanism: results; geometry; balance, eqs. (40)-(47) */
    const REAL t51 = t41 * (t42 - (limb1_U2_opening_mn + t48)), t27 = 0.5 * platform_turn_xy,
      t250 = limb1_U2_opening_mn * limb1_U2_opening_mn, /* limb1 */
      t157 = limb1_U_0_sin * t51, t163 = limbs.t2[0] * (limbs.signed_S_opening_fy[0] - limbs.S_arm_x[0] * t157),
      t159 = limbs.S_opening_fx[0] + limbs.signed_S_arm_y[0] * t157,
      t253 = t250 + (limbs.t13[0] + (limbs.t15[0] + limbs.t14[0])), /* limb1 */
      t164 = limbs.signed_U_null_space_1_by_limb5_S_wy[0] * t163,
      t55 = limbs.t1[0] * (limbs.signed_S_opening_fz[0] - limbs.signed_upper_position_x[0] * (limb1_U_0_cos * t51)),
      t167 = t164 + limbs.signed_U_null_space_0_by_limb5_S_wy[0] * t55 - limbs.t6[0] * t159, t268 = -t159;
    NEXT_LIMB(1, close_position, 0, stride, q, sine, cosine, t21, t22, t26, t27, t18, t47, &limbs);
    NEXT_LIMB(3, close_position, 0, stride, q, sine, cosine, t21, t22, t26, t27, t18, t47, &limbs);
    NEXT_LIMB(1, close_position, 1, stride, sine, cosine, limb5_S_null_space_wz_by_limb5_S_wy, limbs.t7[1],
        limbs.t8[1], &limbs);
    const REAL t256 = limbs.t13[1] + (limbs.t14[1] + (limbs.t15[1] + t253));
    NEXT_LIMB(1, close_position, 2, stride, limbs.t4[1], limbs.minus_U_0_lever_mz_by_S_fz[1] +
        limbs.signed_upper_position_x[1] * limbs.t5[1], &limbs);
    const REAL limb2_U_0_sin = SINES(cosine, 2),
      t131 = limbs.t1[1] * (limbs.signed_upper_position_x[1] * (limb2_U_0_sin * t51) -
          limbs.signed_S_opening_fz[1]),
      minus_limb2_U_0_cos = SINES(sine, 2), t168 = limbs.signed_U_null_space_0_by_limb5_S_wy[1] * t131 - t167,
      t120 = minus_limb2_U_0_cos * t51,
      t126 = limbs.t2[1] * (limbs.signed_S_opening_fy[1] + limbs.S_arm_x[1] * t120),
      t122 = limbs.S_opening_fx[1] - limbs.signed_S_arm_y[1] * t120,
      t170 = limbs.t6[1] * t122 - (limbs.signed_U_null_space_1_by_limb5_S_wy[1] * t126 + t168);
    NEXT_LIMB(2, close_position, 1, stride, sine, cosine, limb5_S_null_space_wz_by_limb5_S_wy, limbs.t8[2],
        limbs.t7[2], &limbs);
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4),
      t259 = limbs.t13[2] + (limbs.t14[2] + (limbs.t15[2] + t256)),
      t264 = -(limbs.signed_upper_position_x[2] * (limb3_U_0_sin - limbs.t4[2]));
    NEXT_LIMB(2, close_position, 2, stride, limb3_U_0_cos + limbs.t5[2], t264, &limbs);
    const REAL t119 = limbs.t1[2] * (limbs.signed_S_opening_fz[2] + limbs.signed_upper_position_x[2] *
        (limb3_U_0_cos * t51)),
      t171 = limbs.signed_U_null_space_0_by_limb5_S_wy[2] * t119 - t170, t145 = limb3_U_0_sin * t51,
      t151 = limbs.t2[2] * (limbs.signed_S_opening_fy[2] + limbs.S_arm_x[2] * t145),
      t147 = limbs.signed_S_arm_y[2] * t145 - limbs.S_opening_fx[2],
      t173 = limbs.t6[2] * t147 + (limbs.signed_U_null_space_1_by_limb5_S_wy[2] * t151 + t171);
    NEXT_LIMB(3, close_position, 1, stride, sine, cosine, limb5_S_null_space_wz_by_limb5_S_wy, limbs.t7[3],
        limbs.t8[3], &limbs);
    const REAL residual_residual = SQRT(limbs.t13[3] + (limbs.t14[3] + (limbs.t15[3] + t259)));
    WRITE(residual_, 0, residual_residual);
    REAL checked3 = residual_residual;
    NEXT_LIMB(3, close_position, 2, stride, limbs.t4[3], limbs.minus_U_0_lever_mz_by_S_fz[3] -
        limbs.signed_upper_position_x[3] * limbs.t5[3], &limbs);
    const REAL limb4_U_0_sin = SINES(cosine, 6),
      t114 = limbs.t1[3] * (limbs.signed_S_opening_fz[3] + limbs.signed_upper_position_x[3] * (limb4_U_0_sin *
          t51)),
      minus_limb4_U_0_cos = SINES(sine, 6), t174 = t173 - limbs.signed_U_null_space_0_by_limb5_S_wy[3] * t114,
      t103 = minus_limb4_U_0_cos * t51,
      t109 = limbs.t2[3] * (limbs.signed_S_opening_fy[3] - limbs.S_arm_x[3] * t103),
      t105 = limbs.S_opening_fx[3] + limbs.signed_S_arm_y[3] * t103,
      t176 = limbs.t6[3] * t105 - (limbs.signed_U_null_space_1_by_limb5_S_wy[3] * t109 - t174),
      t177 = limb5_S_null_space_wz_by_limb5_S_wy * t51 + t176,
      limb2_U_null_space_0_by_limb5_S_wx = limbs.t1[1] * (minus_limb2_U_0_cos * limbs.signed_upper_position_x[1]),
      t93 = limbs.signed_U_null_space_0_by_limb5_S_wy[0] - limb2_U_null_space_0_by_limb5_S_wx *
          limbs.signed_U_null_space_0_by_limb5_S_wy[1],
      limb2_U_null_space_1_by_limb5_S_wx = limb2_U_0_sin * limbs.S_arm_x[1] * limbs.t2[1],
      minus_platform_joint_force_mx_by_limb2_P = limb2_U_0_sin * limbs.signed_S_arm_y[1],
      t94 = limb2_U_null_space_1_by_limb5_S_wx * limbs.signed_U_null_space_1_by_limb5_S_wy[1] + t93,
      t96 = minus_platform_joint_force_mx_by_limb2_P * limbs.t6[1] + t94 -
          limbs.signed_U_null_space_0_by_limb5_S_wy[2],
      minus_limb4_U_null_space_0_by_limb5_S_wx = limbs.t1[3] * (minus_limb4_U_0_cos *
          limbs.signed_upper_position_x[3]),
      t98 = t96 + minus_limb4_U_null_space_0_by_limb5_S_wx * limbs.signed_U_null_space_0_by_limb5_S_wy[3],
      limb4_U_null_space_1_by_limb5_S_wx = limb4_U_0_sin * limbs.S_arm_x[3] * limbs.t2[3],
      platform_joint_force_mx_by_limb4_P = limb4_U_0_sin * limbs.signed_S_arm_y[3],
      t100 = t98 + limb4_U_null_space_1_by_limb5_S_wx * limbs.signed_U_null_space_1_by_limb5_S_wy[3],
      t101 = platform_joint_force_mx_by_limb4_P * limbs.t6[3] + t100,
      t66 = 1.0 + limb2_U_null_space_0_by_limb5_S_wx * limb2_U_null_space_0_by_limb5_S_wx, /* limb2 */
      t69 = t66 + limb2_U_null_space_1_by_limb5_S_wx * limb2_U_null_space_1_by_limb5_S_wx; /* limb2 */
    /* mechanism: pivots; results */
    const REAL t62 = 2.2795812745707664 * minus_platform_joint_force_mx_by_limb2_P,
      t71 = 1.0 + (minus_platform_joint_force_mx_by_limb2_P * t62 + t69), t123 = t62 * t122,
      t72 = minus_limb4_U_null_space_0_by_limb5_S_wx * minus_limb4_U_null_space_0_by_limb5_S_wx + t71,
      t73 = limb4_U_null_space_1_by_limb5_S_wx * limb4_U_null_space_1_by_limb5_S_wx + t72,
      t56 = 2.2795812745707664 * platform_joint_force_mx_by_limb4_P,
      pivot_0 = 1.0 + (platform_joint_force_mx_by_limb4_P * t56 + t73);
    checked0 = checked0 + pivot_0;
    /* mechanism: results; pivots */
    const REAL t75 = 1.0 / pivot_0, t106 = t56 * t105, t102 = t75 * t101, t179 = t101 * t102,
      t134 = limb2_U_null_space_1_by_limb5_S_wx * t126 - (limb2_U_null_space_0_by_limb5_S_wx * t131 + t55),
      t137 = minus_limb4_U_null_space_0_by_limb5_S_wx * t114 + (t119 + (t123 - t134)), t267 = -t114,
      t139 = t106 - (limb4_U_null_space_1_by_limb5_S_wx * t109 + t137), t196 = t75 * t139, t178 = t102 * t139 -
          t177,
      t185 = limbs.t9[1] + (limbs.t10[1] + (limbs.t11[1] + (limbs.t9[0] + (limbs.t10[0] + limbs.t11[0])))),
      t191 = limbs.t9[3] + (limbs.t10[3] + (limbs.t11[3] + (limbs.t9[2] + (limbs.t10[2] + (limbs.t11[2] + t185))))),
      minus_pivot_1 = t179 - (limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_null_space_wz_by_limb5_S_wy + (1.0 +
          t191));
    checked1 = checked1 + minus_pivot_1;
    const REAL t194 = t178 / minus_pivot_1, t197 = t102 * t194 - t196, limb1_P_q = READ(q, 2);
    FIRST_LIMB(0, close_position, 3, stride, q, q_next, t194, t197, t55, t268, limb1_P_q, &limbs);
    WRITE(q_next, 2, limbs.P_q_next[0]);
    checked2 = checked2 + limbs.P_q_next[0];
    checked3 = checked3 + ALONE(limbs.checked[0]);
    const REAL limb3_P_q = READ(q, 8);
    NEXT_LIMB(2, close_position, 3, stride, q, q_next, t194, t197, t119, t147, limb3_P_q, &limbs);
    WRITE(q_next, 8, limbs.P_q_next[2]);
    checked0 = checked0 + limbs.P_q_next[2];
    checked1 = checked1 + ALONE(limbs.checked[2]);
    RESULT(checked2, q_next, 1, READ(q, 1) + (t163 + limbs.t12[0]));
    RESULT(checked3, q_next, 7, READ(q, 7) - (t151 + limbs.t12[2]));
    NEXT_LIMB(1, close_position, 3, stride, q, q_next, t194, -(limb2_U_null_space_0_by_limb5_S_wx * t197), t131,
        minus_platform_joint_force_mx_by_limb2_P * t197, t122, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[1]);
    RESULT(checked1, q_next, 4, READ(q, 4) + (t126 - (limbs.t12[1] - limb2_U_null_space_1_by_limb5_S_wx * t197)));
    const REAL limb2_P_q = READ(q, 5);
    RESULT(checked2, q_next, 5, limb2_P_q - limbs.P_q_next[1]);
    NEXT_LIMB(3, close_position, 3, stride, q, q_next, t194, -(minus_limb4_U_null_space_0_by_limb5_S_wx * t197),
        t267, platform_joint_force_mx_by_limb4_P * t197, t105, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[3]);
    RESULT(checked0, q_next, 10, READ(q, 10) - (t109 - (limbs.t12[3] + limb4_U_null_space_1_by_limb5_S_wx * t197)));
    const REAL limb4_P_q = READ(q, 11);
    RESULT(checked1, q_next, 11, limb4_P_q - limbs.P_q_next[3]);
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
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(pivot_0, 5.4106e-09) OR
            /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(minus_pivot_1, 5.4385e-09),
            /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
BODY(three_ups_upu_s_close_velocity)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict v_next, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t32 = limb5_S_q_qw * limb5_S_q_qw,
      t33 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t34 = t32 + t33,
      t29 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15), t30 = limb5_S_q_qz * limb5_S_q_qz,
      t31 = t29 + t30, t35 = t34 + t31, t37 = 4.0 - 2.0 * t35, t125 = t33 + t29,
      platform_turn_yy = 1.0 - t37 * (t33 + t30), platform_turn_zz = 1.0 - t37 * t125,
      platform_turn_xx = 1.0 - t31 * t37, t42 = limb5_S_q_qz * t37, t68 = limb5_S_q_qy * t42,
      t70 = limb5_S_q_qw * (limb5_S_q_qx * t37), t40 = limb5_S_q_qy * t37, platform_turn_zy = t68 + t70,
      platform_turn_yz = t68 - t70, limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_cos = SINES(cosine, 1),
      t73 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy), /* limb1 */
      t41 = limb5_S_q_qx * t40, t47 = limb5_S_q_qw * t40, t43 = limb5_S_q_qw * t42, t46 = limb5_S_q_qx * t42,
      platform_turn_xy = t41 - t43, platform_turn_yx = t41 + t43;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; results */
    const REAL limb1_lower_sin = SINES(sine, 1),
      limb1_U2_constraint_mn_couple_z = t73 - limb1_lower_sin * platform_turn_xy,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t76 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t77 = limb1_lower_cos * t76,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t77,
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t79 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3, t87 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U2_factor_1_by_3 = limb1_U2_constraint_mn_couple_x * (limb1_lower_cos - t76 * (limb1_lower_sin *
          minus_limb1_upper_position_x)),
      t86 = t79 - limb1_U_0_sin * minus_limb1_U2_factor_1_by_3,
      minus_limb5_S_pivot_wz = t87 + limb1_U_0_cos * minus_limb1_U2_factor_1_by_3;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL t89 = t86 / minus_limb5_S_pivot_wz, /* limb5_S */
      t152 = limb1_U_0_cos - limb1_U_0_sin * t89, limb1_U_null_space_1_by_limb5_S_wy = t77 * (limb1_U2_arm_x *
          t152),
      t156 = READ(v, 1) * limb1_U_null_space_1_by_limb5_S_wy,
      minus_limb1_U_null_space_0_by_limb5_S_wy = t76 * (minus_limb1_upper_position_x * (limb1_U_0_sin +
          limb1_U_0_cos * t89)),
      limb1_U_v_0 = READ(v, 0), t158 = t156 - limb1_U_v_0 * minus_limb1_U_null_space_0_by_limb5_S_wy,
      limb1_P_null_space_by_limb5_S_wy = param_R * limb1_lower_cos * t152,
      t153 = 2.2795812745707664 * limb1_P_null_space_by_limb5_S_wy;
    /* limb2: geometry; rates that follow */
    const REAL limb2_U_0_sin = SINES(cosine, 2), t159 = READ(v, 2) * t153 + t158, /* limb1 */
      t183 = limb1_P_null_space_by_limb5_S_wy * t153, /* limb1 */
      t109 = limb2_U_0_sin * t89, limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      limb2_lower_sin = SINES(sine, 3),
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      minus_limb2_U_0_cos = SINES(sine, 2), limb2_lower_cos = SINES(cosine, 3);
    /* limb2: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t110 = minus_limb2_upper_position_y * t109, t15 = minus_limb2_U_0_cos * minus_limb2_upper_position_y,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x,
      t111 = minus_limb2_U_0_lever_mz_by_limb2_S_fz + t110, t14 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      limb2_U_null_space_0_by_limb5_S_wy = t14 * t111, minus_limb2_U_null_space_0_by_limb5_S_wx = t14 * t15,
      t20 = limb2_lower_cos * t14, limb2_U_v_0 = READ(v, 3),
      t160 = limb2_U_v_0 * limb2_U_null_space_0_by_limb5_S_wy + t159, /* mechanism */
      t104 = minus_limb2_U_0_cos * t89, limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin,
      limb2_U_null_space_1_by_limb5_S_wy = t20 * (limb2_S_arm_x * t104),
      limb2_U_null_space_1_by_limb5_S_wx = limb2_U_0_sin * limb2_S_arm_x * t20, limb2_U_v_1 = READ(v, 4),
      t161 = limb2_U_v_1 * limb2_U_null_space_1_by_limb5_S_wy + t160, /* mechanism */
      minus_limb2_S_arm_y = param_R * limb2_lower_cos, limb2_P_null_space_by_limb5_S_wy = minus_limb2_S_arm_y *
          t104,
      minus_platform_joint_force_mx_by_limb2_P = limb2_U_0_sin * minus_limb2_S_arm_y,
      t105 = 2.2795812745707664 * limb2_P_null_space_by_limb5_S_wy, limb2_P_v = READ(v, 5);
    /* limb3: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_0_sin = SINES(sine, 4),
      t162 = limb2_P_v * t105 + t161, /* mechanism */
      t102 = limb3_U_0_sin + limb3_U_0_cos * t89, limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      minus_limb3_lower_sin = SINES(sine, 5), limb3_lower_cos = SINES(cosine, 5),
      t103 = (param_R - minus_limb3_lower_sin * limb3_upper_offset_x) * t102,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t100 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz, limb3_U_null_space_0_by_limb5_S_wy = t100 *
        t103,
      limb3_U_v_0 = READ(v, 6), t143 = limb3_lower_cos * t100,
      t163 = limb3_U_v_0 * limb3_U_null_space_0_by_limb5_S_wy + t162, /* mechanism */
      t140 = limb3_U_0_cos - limb3_U_0_sin * t89,
      limb3_U_null_space_1_by_limb5_S_wy = t143 * ((limb3_upper_offset_x - param_R * minus_limb3_lower_sin) * t140),
      t164 = READ(v, 7) * limb3_U_null_space_1_by_limb5_S_wy + t163, /* mechanism */
      minus_limb3_P_null_space_by_limb5_S_wy = param_R * limb3_lower_cos * t140,
      t141 = 2.2795812745707664 * minus_limb3_P_null_space_by_limb5_S_wy;
    /* limb4: geometry; rates that follow */
    const REAL limb4_U_0_sin = SINES(cosine, 6), t165 = READ(v, 8) * t141 - t164, /* mechanism */
      t177 = minus_limb3_P_null_space_by_limb5_S_wy * t141, /* limb3 */
      t95 = limb4_U_0_sin * t89, limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      minus_limb4_lower_sin = SINES(sine, 7),
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      minus_limb4_U_0_cos = SINES(sine, 6), limb4_lower_cos = SINES(cosine, 7);
    /* limb4: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t96 = limb4_upper_position_y * t95, t9 = minus_limb4_U_0_cos * limb4_upper_position_y,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x,
      t97 = minus_limb4_U_0_lever_mz_by_limb4_S_fz - t96, t6 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_U_null_space_0_by_limb5_S_wy = t6 * t97, limb4_U_null_space_0_by_limb5_S_wx = t6 * t9,
      t7 = limb4_lower_cos * t6, limb4_U_v_0 = READ(v, 9),
      t166 = limb4_U_v_0 * limb4_U_null_space_0_by_limb5_S_wy - t165, /* mechanism */
      t90 = minus_limb4_U_0_cos * t89, limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      limb4_U_null_space_1_by_limb5_S_wy = t7 * (limb4_S_arm_x * t90),
      limb4_U_null_space_1_by_limb5_S_wx = limb4_U_0_sin * limb4_S_arm_x * t7, limb4_U_v_1 = READ(v, 10);
    /* mechanism: results; velocities, eq. (6); geometry */
    const REAL t167 = limb4_U_v_1 * limb4_U_null_space_1_by_limb5_S_wy + t166,
      limb4_S_arm_y = param_R * limb4_lower_cos, minus_limb4_P_null_space_by_limb5_S_wy = limb4_S_arm_y * t90,
      platform_joint_force_mx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y,
      t91 = 2.2795812745707664 * minus_limb4_P_null_space_by_limb5_S_wy, /* limb4 */
      limb4_P_v = READ(v, 11), limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14),
      t168 = limb4_P_v * t91 - t167, t134 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      t169 = t134 + limb5_S_v_wz * platform_turn_yz - t168, platform_turn_zx = t46 - t47,
      platform_turn_xz = t46 + t47, t130 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      t170 = (limb5_S_v_wz * platform_turn_zz + t130) * t89 - t169,
      t116 = minus_limb2_U_null_space_0_by_limb5_S_wx * limb2_U_null_space_0_by_limb5_S_wy +
          minus_limb1_U_null_space_0_by_limb5_S_wy,
      t117 = limb2_U_null_space_1_by_limb5_S_wx * limb2_U_null_space_1_by_limb5_S_wy - t116,
      t119 = limb3_U_null_space_0_by_limb5_S_wy + (minus_platform_joint_force_mx_by_limb2_P * t105 + t117),
      t180 = limb2_P_null_space_by_limb5_S_wy * t105, /* limb2 */
      t120 = limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wy + t119,
      t121 = limb4_U_null_space_1_by_limb5_S_wx * limb4_U_null_space_1_by_limb5_S_wy + t120,
      t122 = platform_joint_force_mx_by_limb4_P * t91 + t121,
      t174 = minus_limb4_P_null_space_by_limb5_S_wy * t91, /* limb4 */
      t17 = 1.0 + minus_limb2_U_null_space_0_by_limb5_S_wx * minus_limb2_U_null_space_0_by_limb5_S_wx, /* limb2 */
      t22 = t17 + limb2_U_null_space_1_by_limb5_S_wx * limb2_U_null_space_1_by_limb5_S_wx; /* limb2 */
    /* mechanism: pivots; results */
    const REAL t12 = 2.2795812745707664 * minus_platform_joint_force_mx_by_limb2_P,
      t24 = 1.0 + (minus_platform_joint_force_mx_by_limb2_P * t12 + t22), t52 = limb2_P_v * t12,
      t25 = limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wx + t24,
      t26 = limb4_U_null_space_1_by_limb5_S_wx * limb4_U_null_space_1_by_limb5_S_wx + t25,
      t2 = 2.2795812745707664 * platform_joint_force_mx_by_limb4_P,
      pivot_0 = 1.0 + (platform_joint_force_mx_by_limb4_P * t2 + t26);
    REAL checked3 = pivot_0;
    /* mechanism: results; pivots; velocities, eq. (6) */
    const REAL t28 = 1.0 / pivot_0, t49 = limb4_P_v * t2, t123 = t28 * t122, t172 = t122 * t123,
      t54 = limb1_U_v_0 - limb2_U_v_0 * minus_limb2_U_null_space_0_by_limb5_S_wx,
      t58 = limb3_U_v_0 + (t52 + (t54 + limb2_U_v_1 * limb2_U_null_space_1_by_limb5_S_wx)),
      t59 = limb4_U_v_0 * limb4_U_null_space_0_by_limb5_S_wx + t58,
      t61 = t49 - (limb4_U_v_1 * limb4_U_null_space_1_by_limb5_S_wx + t59),
      t45 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      t62 = t45 + limb5_S_v_wz * platform_turn_xz - t61, t63 = t28 * t62, t171 = t62 * t123 + t170,
      t184 = limb1_U_null_space_1_by_limb5_S_wy * limb1_U_null_space_1_by_limb5_S_wy, /* limb1 */
      t187 = t183 + (t184 + minus_limb1_U_null_space_0_by_limb5_S_wy * minus_limb1_U_null_space_0_by_limb5_S_wy);
          /* limb1 */
    /* mechanism: pivots; results */
    const REAL t188 = limb2_U_null_space_0_by_limb5_S_wy * limb2_U_null_space_0_by_limb5_S_wy + t187,
      t190 = t180 + (limb2_U_null_space_1_by_limb5_S_wy * limb2_U_null_space_1_by_limb5_S_wy + t188),
      t191 = limb3_U_null_space_0_by_limb5_S_wy * limb3_U_null_space_0_by_limb5_S_wy + t190,
      t193 = t177 + (limb3_U_null_space_1_by_limb5_S_wy * limb3_U_null_space_1_by_limb5_S_wy + t191),
      t194 = limb4_U_null_space_0_by_limb5_S_wy * limb4_U_null_space_0_by_limb5_S_wy + t193,
      t197 = 1.0 + (t174 + (limb4_U_null_space_1_by_limb5_S_wy * limb4_U_null_space_1_by_limb5_S_wy + t194)),
      minus_pivot_1 = t172 - (t89 * t89 + t197);
    checked0 = checked0 + minus_pivot_1;
    const REAL t199 = t171 / minus_pivot_1;
    RESULT(checked1, v_next, 1, limb1_U_null_space_1_by_limb5_S_wy * t199);
    RESULT(checked2, v_next, 2, limb1_P_null_space_by_limb5_S_wy * t199);
    RESULT(checked3, v_next, 7, limb3_U_null_space_1_by_limb5_S_wy * t199);
    const REAL t201 = t63 - t123 * t199;
    RESULT(checked0, v_next, 0, t201 - minus_limb1_U_null_space_0_by_limb5_S_wy * t199);
    RESULT(checked1, v_next, 3, limb2_U_null_space_0_by_limb5_S_wy * t199 - minus_limb2_U_null_space_0_by_limb5_S_wx
        * t201);
    RESULT(checked2, v_next, 4, limb2_U_null_space_1_by_limb5_S_wy * t199 + limb2_U_null_space_1_by_limb5_S_wx *
        t201);
    RESULT(checked3, v_next, 5, limb2_P_null_space_by_limb5_S_wy * t199 + minus_platform_joint_force_mx_by_limb2_P *
        t201);
    RESULT(checked0, v_next, 6, t201 + limb3_U_null_space_0_by_limb5_S_wy * t199);
    const REAL t210 = minus_limb3_P_null_space_by_limb5_S_wy * t199; /* limb3 */
    checked1 = checked1 + t210; /* limb3 */
    WRITE(v_next, 8, -t210);
    RESULT(checked2, v_next, 9, limb4_U_null_space_0_by_limb5_S_wy * t199 + limb4_U_null_space_0_by_limb5_S_wx *
        t201);
    RESULT(checked3, v_next, 10, limb4_U_null_space_1_by_limb5_S_wy * t199 + limb4_U_null_space_1_by_limb5_S_wx *
        t201);
    const REAL t217 = minus_limb4_P_null_space_by_limb5_S_wy * t199 + platform_joint_force_mx_by_limb4_P * t201;
        /* limb4 */
    checked0 = checked0 + t217; /* limb4 */
    WRITE(v_next, 11, -t217);
    const REAL t220 = platform_turn_yx * t199 + platform_turn_xx * t201, t221 = t89 * t199;
    RESULT(checked1, v_next, 12, t220 - platform_turn_zx * t221);
    const REAL t229 = platform_turn_yz * t199 + platform_turn_xz * t201;
    RESULT(checked2, v_next, 13, platform_turn_yy * t199 + platform_turn_xy * t201 - platform_turn_zy * t221);
    RESULT(checked3, v_next, 14, t229 - platform_turn_zz * t221);
    /* else status 5: no rotation */
    NOT_BELOW(t35, 0.999999, 5);
    NOT_ABOVE(t35, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-10) OR
            /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-10) OR
            /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-10) OR
            /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-10) OR
            /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(pivot_0, 5.4106e-09) OR
            /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(minus_pivot_1, 5.4385e-09),
            /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
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
      minus_lower_rotation_yx, minus_upper_position_y, signed_lower_rotation_zx, signed_upper_position_z,
      signed_S_opening_fz, signed_S_opening_fy, t3, t4, t5, signed_S_arm_y, signed_lower_limb_target_y,
      signed_lower_limb_target_x_2, t6, t7, t8, t9, signed_lower_limb_target_z, lower_limb_length, t10, t11,
      t12, t13, checked;
} LIMBS(assemble_step);

STAGE(assemble_step, 0)(size_t limb, size_t stride, const double *restrict q, const double *restrict sine,
    const double *restrict cosine, LIMBS(assemble_step) *own)
{
    (void)limb, (void)stride;
    const LIMB4 lower_cos = OF4(SINES(cosine, 1), SINES(cosine, 4), SINES(cosine, 6), SINES(cosine, 9));
    /* each limb: reciprocal wrenches, eq. (10); geometry; rates that follow */
    OWN(signed_S_arm_y) = param_R * lower_cos;
    OWN(upper_offset_x) = IN_EACH4(READ, q, 2, 3) + limb_upper_phase;
    OWN(signed_lower_rotation_zx) = OF4(SINES(cosine, 0), SINES(sine, 2), SINES(cosine, 5), SINES(sine, 7)) *
        lower_cos;
    OWN(signed_upper_position_z) = OWN(upper_offset_x) * OWN(signed_lower_rotation_zx);
    OWN(minus_lower_rotation_yx) = OF4(SINES(sine, 0), SINES(cosine, 2), SINES(sine, 5), SINES(cosine, 7)) *
        lower_cos;
    OWN(minus_upper_position_y) = OWN(upper_offset_x) * OWN(minus_lower_rotation_yx);
    OWN(minus_U_0_lever_mz_by_S_fz) = lower_cos * OWN(upper_offset_x);
    OWN(t1) = 1.0 / OWN(minus_U_0_lever_mz_by_S_fz);
    OWN(t2) = lower_cos * OWN(t1);
    const LIMB4 signed_lower_sin = OF4(SINES(sine, 1), SINES(sine, 4), SINES(sine, 6), SINES(sine, 9));
    OWN(S_arm_x) = OWN(upper_offset_x) - param_R * signed_lower_sin;
    OWN(signed_upper_position_x) = signed_lower_sin * OWN(upper_offset_x) + (-param_R);
}

STAGE(assemble_step, 1)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, REAL given_2, REAL given_3, REAL given_4, REAL given_5,
    REAL given_6, LIMBS(assemble_step) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0),
      sign3 = OF4(1.0, 1.0, 1.0, -1.0), sign4 = OF4(1.0, -1.0, -1.0, -1.0), sign5 = OF4(1.0, -1.0, 1.0, -1.0),
      each_per_length = sign5 * per_length;
    /* each limb: loop closure; results */
    const LIMB4 t1 = OWN(minus_upper_position_y) + sign2 * (given - sign1 * given_2);
    OWN(t5) = OWN(minus_lower_rotation_yx) * t1;
    const LIMB4 U_0_sin = OF4(SINES(sine, 0), SINES(cosine, 2), SINES(sine, 5), SINES(cosine, 7)),
      signed_U_0_cos = OF4(SINES(cosine, 0), SINES(sine, 2), SINES(cosine, 5), SINES(sine, 7)), t7 = U_0_sin * t1,
      t2 = signed_U_0_cos * t1, t3 = OWN(signed_upper_position_z) - sign3 * (given_3 - sign1 * given_4);
    OWN(t3) = OWN(signed_lower_rotation_zx) * t3;
    const LIMB4 signed_lower_sin = OF4(SINES(sine, 1), SINES(sine, 4), SINES(sine, 6), SINES(sine, 9)),
      t10 = signed_lower_sin * (t7 + signed_U_0_cos * t3);
    OWN(signed_S_opening_fz) = t2 - U_0_sin * t3;
    const LIMB4 t11 = each_per_length * OWN(signed_S_opening_fz);
    OWN(t12) = t11 * t11;
    const LIMB4 t5 = given_5 - sign1 * given_6 - sign4 * OWN(signed_upper_position_x);
    OWN(t4) = signed_lower_sin * t5;
    OWN(signed_S_opening_fy) = sign4 * (OF4(SINES(cosine, 1), SINES(cosine, 4), SINES(cosine, 6), SINES(cosine, 9))
        * t5) + t10;
    const LIMB4 t12 = per_length * OWN(signed_S_opening_fy);
    OWN(t13) = t12 * t12;
}

STAGE(assemble_step, 2)(size_t limb, size_t stride, double *restrict q_next, const double *restrict sine,
    const double *restrict cosine, REAL given, REAL given_2, REAL given_3, REAL given_4, REAL given_5,
    REAL given_6, LIMBS(assemble_step) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, 1.0, 1.0, -1.0), each_param_R = -sign3 * param_R;
    /* each limb: geometry; results */
    OWN(signed_lower_limb_target_x_2) = given_3 + sign2 * given_4;
    const LIMB4 t1 = OF4(SINES(sine, 0), SINES(sine, 3), SINES(sine, 5), SINES(sine, 8)) *
        OWN(signed_lower_limb_target_x_2),
      t4 = OWN(signed_lower_limb_target_x_2) * OWN(signed_lower_limb_target_x_2);
    OWN(signed_lower_limb_target_y) = given - sign1 * given_2;
    const LIMB4 t2 = OF4(SINES(cosine, 0), SINES(cosine, 3), SINES(cosine, 5), SINES(cosine, 8)) *
        OWN(signed_lower_limb_target_y);
    OWN(t6) = t1 + t2;
    OWN(t7) = OWN(signed_lower_limb_target_y) * OWN(signed_lower_limb_target_y) + t4;
    OWN(signed_lower_limb_target_z) = sign1 * given_5 + given_6 + each_param_R;
    OWN(lower_limb_length) = SQRT4(OWN(signed_lower_limb_target_z) * OWN(signed_lower_limb_target_z) + OWN(t7));
    const LIMB4 P_q_next = OWN(lower_limb_length) + (-limb_upper_phase);
    WRITE4(q_next, 2, 5, 8, 11, P_q_next);
    LIMB4 checked = P_q_next;
    OWN(checked) = checked;
}

STAGE(assemble_step, 3)(size_t limb, size_t stride, const double *restrict sine,
    const double *restrict cosine, REAL given, LIMBS(assemble_step) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, 1.0, -1.0);
    /* each limb: geometry; results */
    const LIMB4 t1 = SQRT4(OWN(t7)), t2 = given / t1, t8 = given * t1,
      minus_U_0_cos = OWN(signed_lower_limb_target_y) * t2, minus_U_0_sin = OWN(signed_lower_limb_target_x_2) * t2,
      U_0_sin = OF4(SINES(sine, 0), SINES(sine, 3), SINES(sine, 5), SINES(sine, 8)),
      U_0_cos = OF4(SINES(cosine, 0), SINES(cosine, 3), SINES(cosine, 5), SINES(cosine, 8)),
      t6 = U_0_cos * minus_U_0_cos;
    OWN(t8) = U_0_sin * minus_U_0_cos - U_0_cos * minus_U_0_sin;
    OWN(t9) = U_0_sin * minus_U_0_sin + t6;
    const LIMB4 t7 = 1.0 / OWN(lower_limb_length), minus_lower_cos = t7 * t8,
      signed_lower_sin_2 = OWN(signed_lower_limb_target_z) * t7,
      signed_lower_sin = OF4(SINES(sine, 1), SINES(sine, 4), SINES(sine, 6), SINES(sine, 9)),
      lower_cos = OF4(SINES(cosine, 1), SINES(cosine, 4), SINES(cosine, 6), SINES(cosine, 9)),
      t14 = sign1 * (lower_cos * minus_lower_cos);
    OWN(t10) = signed_lower_sin * minus_lower_cos - sign1 * (lower_cos * signed_lower_sin_2);
    OWN(t11) = signed_lower_sin * signed_lower_sin_2 + t14;
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
    const REAL t19 = t6 + t9, t58 = t6 + t8, t18 = 4.0 - 2.0 * t11, platform_turn_yy = 1.0 - t18 * t19,
      t13 = k2 - 0.5 * t11, t60 = param_H * (1.0 - t18 * t58), t71 = 0.5 * (1.0 - t10 * t18),
      t22 = limb5_S_q_qz * t18, t23 = limb5_S_q_qy * t22, t25 = limb5_S_q_qw * (limb5_S_q_qx * t18),
      t33 = limb5_S_q_qy * t18, platform_turn_zy = t23 + t25, t57 = param_H * (t23 - t25),
      limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      t31 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t32 = limb1_lower_cos * t31, /* limb1 */
      t68 = limb1_lower_sin * t31, /* limb1 */
      t34 = limb5_S_q_qx * t33, t63 = limb5_S_q_qw * t33, t35 = limb5_S_q_qw * t22, t62 = limb5_S_q_qx * t22,
      platform_turn_xy = t34 - t35, t56 = 0.5 * (t34 + t35);
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; pivots */
    const REAL limb1_U2_constraint_mn_couple_z = t32 - limb1_lower_sin * platform_turn_xy;
    FIRST_LIMB(0, assemble_step, 0, stride, q, sine, cosine, &limbs);
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * limbs.t2[0],
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limbs.S_arm_x[0] * limb1_U_factor_1_by_3,
      t38 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t41 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      t26 = limb1_U_0_sin * platform_turn_zy, t61 = 0.5 * platform_turn_zy, /* platform */
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + t26;
    /* limb5_S: geometry; pivots; rates that follow */
    const REAL t72 = 0.5 * platform_turn_yy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * limbs.t1[0],
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn + limbs.signed_upper_position_x[0] *
          minus_limb1_U_factor_0_by_3,
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t38,
      t42 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t41, /* limb1 */
      t39 = 1.0 / minus_limb5_S_pivot_wz, limb5_S_null_space_wz_by_limb5_S_wy = t39 * t42;
    /* step: results; geometry */
    const REAL t16 = limb5_S_q_qy * t13, t43 = t16 * limb5_S_null_space_wz_by_limb5_S_wy, t14 = limb5_S_q_qz * t13,
      t45 = 0.5 * (t14 - t43), t15 = 0.5 * t14, t46 = t15 * t45, t49 = limb5_S_q_qx * t13,
      t50 = t49 * limb5_S_null_space_wz_by_limb5_S_wy, t47 = limb5_S_q_qw * t13, t52 = 0.5 * (t47 + t50),
      t48 = 0.5 * t47, a_pivot = t46 + t48 * t52;
    NEXT_LIMB(1, assemble_step, 0, stride, q, sine, cosine, &limbs);
    NEXT_LIMB(2, assemble_step, 0, stride, q, sine, cosine, &limbs);
    const REAL t333 = limbs.upper_offset_x[1] * limbs.upper_offset_x[2];
    NEXT_LIMB(3, assemble_step, 0, stride, q, sine, cosine, &limbs);
    const REAL t336 = limbs.minus_U_0_lever_mz_by_S_fz[2] * (limbs.upper_offset_x[0] * (limbs.upper_offset_x[3] *
        t333)),
      t339 = limbs.minus_U_0_lever_mz_by_S_fz[0] * (limbs.minus_U_0_lever_mz_by_S_fz[3] *
          (limbs.minus_U_0_lever_mz_by_S_fz[1] * t336)),
      t341 = a_pivot * (t339 * minus_limb5_S_pivot_wz);
    REAL checked0 = t341;
    WRITE(orientation_, 0, -t341);
    const REAL t54 = 1.0 / a_pivot, platform_turn_xz = t62 + t63, t64 = 0.5 * (t62 - t63),
      t65 = param_H * platform_turn_xz;
    FIRST_LIMB(0, assemble_step, 1, stride, sine, cosine, t57, t56, t60, t64, t65, t71, &limbs);
    NEXT_LIMB(2, assemble_step, 1, stride, sine, cosine, t57, t56, t60, t64, t65, t71, &limbs);
    const REAL t73 = limb1_U_factor_1_by_3 * limbs.signed_S_opening_fy[0], /* limb1 */
      t67 = limbs.signed_S_opening_fz[0] * minus_limb1_U_factor_0_by_3, /* limb1 */
      limb1_U2_opening_mn = t68 + limb1_lower_cos * platform_turn_xy,
      t76 = t39 * (t67 - (limb1_U2_opening_mn + t73)), t78 = 0.5 * (t16 * t76), t83 = 0.5 * (t49 * t76),
      t66 = 0.5 * platform_turn_xy, t318 = limb1_U2_opening_mn * limb1_U2_opening_mn, /* limb1 */
      t79 = limb5_S_q_qx - READ(y, 0) + t78, t80 = t15 * t79, t94 = t52 * t79, t84 = limb5_S_q_qy - READ(y, 1) -
          t83,
      t95 = t45 * t84 - t94, t87 = t54 * (t80 + t48 * t84), t96 = t54 * t95, t89 = t39 * (t42 * t87),
      t198 = limbs.signed_upper_position_x[0] * (limb1_U_0_cos * t89 - limb1_U_0_sin * t87),
      t202 = limbs.signed_S_opening_fz[0] - limbs.signed_upper_position_x[0] * (limb1_U_0_cos * t76) - t198,
      t204 = t96 - limbs.t1[0] * t202, t205 = t204 * t204, t182 = limb1_U_0_sin * t89 + limb1_U_0_cos * t87,
      t189 = limbs.S_arm_x[0] * t182, t183 = limb1_U_0_sin * t76, t184 = t182 + t183,
      t193 = limbs.t2[0] * (t189 - (limbs.signed_S_opening_fy[0] - limbs.S_arm_x[0] * t183)),
      t185 = limbs.signed_S_arm_y[0] * t184, t206 = t193 * t193 + t205,
      minus_limb1_U2_opening_fx = limbs.t4[0] - limbs.t5[0] - limbs.t3[0],
      t187 = per_length * (minus_limb1_U2_opening_fx - t185), t207 = t187 * t187 + t206,
      t319 = per_length * minus_limb1_U2_opening_fx, /* limb1 */
      limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2),
      t323 = t318 + (limbs.t12[0] + (t319 * t319 + limbs.t13[0])), /* limb1 */
      t171 = limbs.signed_upper_position_x[1] * (limb2_U_0_sin * t89 - minus_limb2_U_0_cos * t96),
      t173 = limbs.signed_upper_position_x[1] * (limb2_U_0_sin * t76);
    NEXT_LIMB(1, assemble_step, 1, stride, sine, cosine, t61, t60, t66, t65, t72, t57, &limbs);
    NEXT_LIMB(3, assemble_step, 1, stride, sine, cosine, t61, t60, t66, t65, t72, t57, &limbs);
    const REAL t177 = t87 + limbs.t1[1] * (t171 + (t173 - limbs.signed_S_opening_fz[1])), t208 = t177 * t177 + t207,
      t155 = minus_limb2_U_0_cos * t89 + limb2_U_0_sin * t96, t162 = limbs.S_arm_x[1] * t155,
      t156 = minus_limb2_U_0_cos * t76, t157 = t155 + t156,
      t166 = limbs.t2[1] * (t162 + (limbs.signed_S_opening_fy[1] + limbs.S_arm_x[1] * t156)),
      t158 = limbs.signed_S_arm_y[1] * t157, t209 = t166 * t166 + t208,
      limb2_S_opening_fx = limbs.t3[1] + limbs.t4[1] + limbs.t5[1], t160 = per_length * (limb2_S_opening_fx - t158),
      t210 = t160 * t160 + t209, t316 = per_length * limb2_S_opening_fx, /* limb2 */
      limb3_U_0_cos = SINES(cosine, 5), limb3_U_0_sin = SINES(sine, 5),
      t326 = limbs.t12[1] + (limbs.t13[1] + (t316 * t316 + t323)),
      t144 = limbs.signed_upper_position_x[2] * (limb3_U_0_cos * t89 - limb3_U_0_sin * t87),
      t148 = t144 + (limbs.signed_S_opening_fz[2] + limbs.signed_upper_position_x[2] * (limb3_U_0_cos * t76)),
      t150 = t96 - limbs.t1[2] * t148, t211 = t150 * t150 + t210, t128 = limb3_U_0_sin * t89 + limb3_U_0_cos * t87,
      t135 = limbs.S_arm_x[2] * t128, t129 = limb3_U_0_sin * t76, t130 = t128 + t129,
      t139 = limbs.t2[2] * (t135 + (limbs.signed_S_opening_fy[2] + limbs.S_arm_x[2] * t129)),
      t131 = limbs.signed_S_arm_y[2] * t130, t212 = t139 * t139 + t211,
      limb3_S_opening_fx = limbs.t4[2] + limbs.t5[2] + limbs.t3[2], t133 = per_length * (t131 - limb3_S_opening_fx),
      t213 = t133 * t133 + t212, t314 = per_length * limb3_S_opening_fx, /* limb3 */
      limb4_U_0_sin = SINES(cosine, 7), minus_limb4_U_0_cos = SINES(sine, 7),
      t329 = limbs.t12[2] + (limbs.t13[2] + (t314 * t314 + t326)),
      t117 = limbs.signed_upper_position_x[3] * (limb4_U_0_sin * t89 - minus_limb4_U_0_cos * t96),
      t121 = t117 + (limbs.signed_S_opening_fz[3] + limbs.signed_upper_position_x[3] * (limb4_U_0_sin * t76)),
      t123 = t87 - limbs.t1[3] * t121, t214 = t123 * t123 + t213, t99 = minus_limb4_U_0_cos * t89, t90 = t76 + t89,
      t102 = minus_limb4_U_0_cos * t76, t101 = t99 + limb4_U_0_sin * t96, t103 = t101 + t102,
      t112 = limbs.t2[3] * (limbs.S_arm_x[3] * t101 - (limbs.signed_S_opening_fy[3] - limbs.S_arm_x[3] * t102)),
      t104 = limbs.signed_S_arm_y[3] * t103, t215 = t112 * t112 + t214,
      limb4_S_opening_fx = limbs.t3[3] + limbs.t4[3] + limbs.t5[3], t106 = per_length * (limb4_S_opening_fx + t104),
      t216 = t106 * t106 + t215, t312 = per_length * limb4_S_opening_fx, /* limb4 */
      residual_residual = SQRT(limbs.t12[3] + (limbs.t13[3] + (t312 * t312 + t329)));
    WRITE(residual_, 0, residual_residual);
    REAL checked1 = residual_residual;
    const REAL t219 = t90 * t90 + (t87 * t87 + (t96 * t96 + t216)), step_step = SQRT(t219);
    WRITE(step, 0, step_step);
    REAL checked2 = step_step;
    const REAL t220 = LESS(step_step, 0.5), t223 = SELECT(t220, 1.0, 0.5 / SELECT(t220, 1.0, step_step)),
      t225 = 0.5 * (t87 * t223), t231 = t90 * t223, t228 = 0.5 * (t96 * t223), t232 = 0.5 * t231,
      t256 = limb5_S_q_qw + (limb5_S_q_qz * t232 + (limb5_S_q_qy * t225 - limb5_S_q_qx * t228)), t257 = t256 * t256,
      t249 = limb5_S_q_qy * t232 - limb5_S_q_qz * t225 + (limb5_S_q_qx + limb5_S_q_qw * t228),
      t258 = t249 * t249 + t257, t229 = limb5_S_q_qy * t228, t234 = limb5_S_q_qz - limb5_S_q_qw * t232,
      t242 = limb5_S_q_qz * t228 + limb5_S_q_qx * t232 - (limb5_S_q_qy - limb5_S_q_qw * t225),
      t235 = limb5_S_q_qx * t225 + t229 + t234, t262 = 1.0 / SQRT(t235 * t235 + (t242 * t242 + t258)),
      t264 = t242 * t262;
    WRITE(q_next, 14, -t264);
    const REAL limb5_S_q_next_qz = t235 * t262;
    WRITE(q_next, 15, limb5_S_q_next_qz);
    const REAL limb5_S_q_next_qx = t249 * t262;
    WRITE(q_next, 13, limb5_S_q_next_qx);
    const REAL limb5_S_q_next_qw = t256 * t262;
    WRITE(q_next, 12, limb5_S_q_next_qw);
    /* limb5_S: geometry */
    const REAL t263 = limb5_S_q_next_qz * limb5_S_q_next_qz, t265 = t264 * t264, t266 = t263 + t265,
      t267 = limb5_S_q_next_qx * limb5_S_q_next_qx, t273 = t267 + t265, t302 = t263 + t267,
      t272 = 4.0 - 2.0 * (t266 + (t267 + limb5_S_q_next_qw * limb5_S_q_next_qw)), t278 = limb5_S_q_next_qz * t272,
      t275 = param_H * (1.0 - t272 * t273), t304 = 0.5 * (1.0 - t302 * t272), t301 = 0.5 * (1.0 - t266 * t272),
      t281 = limb5_S_q_next_qw * t278, t276 = t264 * t272, t286 = limb5_S_q_next_qw * (limb5_S_q_next_qx * t272),
      t277 = limb5_S_q_next_qw * t276, t282 = limb5_S_q_next_qx * t276, t279 = limb5_S_q_next_qx * t278,
      t287 = t264 * t278, platform_turn_yx_2 = t281 - t282, t283 = 0.5 * (t281 + t282),
      t289 = 0.5 * platform_turn_yx_2, platform_turn_zx_2 = t277 + t279, t284 = param_H * (t277 - t279),
      t280 = 0.5 * platform_turn_zx_2, minus_platform_turn_yz = t286 + t287, t290 = 0.5 * (t286 - t287),
      t288 = param_H * minus_platform_turn_yz;
    FIRST_LIMB(3, assemble_step, 2, stride, q_next, sine, cosine, t283, t284, t290, t275, t304, t288, &limbs);
    REAL checked3 = ALONE(limbs.checked[3]);
    NEXT_LIMB(1, assemble_step, 2, stride, q_next, sine, cosine, t283, t284, t290, t275, t304, t288, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[1]);
    FIRST_LIMB(3, assemble_step, 3, stride, sine, cosine, SELECT(LESS(limbs.t6[3], 0.0), (-1.0), 1.0), &limbs);
    RESULT(checked1, q_next, 10, READ(q, 10) + atan2(-limbs.t10[3], limbs.t11[3]));
    RESULT(checked2, q_next, 9, READ(q, 9) + atan2(-limbs.t8[3], limbs.t9[3]));
    NEXT_LIMB(2, assemble_step, 2, stride, q_next, sine, cosine, t275, t280, t288, t289, t284, t301, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[2]);
    NEXT_LIMB(0, assemble_step, 2, stride, q_next, sine, cosine, t275, t280, t288, t289, t284, t301, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[0]);
    NEXT_LIMB(2, assemble_step, 3, stride, sine, cosine, SELECT(LESS(-limbs.t6[2], 0.0), (-1.0), 1.0), &limbs);
    RESULT(checked1, q_next, 7, READ(q, 7) + atan2(-limbs.t10[2], -limbs.t11[2]));
    RESULT(checked2, q_next, 6, READ(q, 6) + atan2(limbs.t8[2], -limbs.t9[2]));
    NEXT_LIMB(1, assemble_step, 3, stride, sine, cosine, SELECT(LESS(-limbs.t6[1], 0.0), (-1.0), 1.0), &limbs);
    RESULT(checked3, q_next, 4, READ(q, 4) + atan2(limbs.t10[1], -limbs.t11[1]));
    RESULT(checked0, q_next, 3, READ(q, 3) + atan2(limbs.t8[1], -limbs.t9[1]));
    NEXT_LIMB(0, assemble_step, 3, stride, sine, cosine, SELECT(LESS(-limbs.t6[0], 0.0), (-1.0), 1.0), &limbs);
    RESULT(checked1, q_next, 1, READ(q, 1) + atan2(limbs.t10[0], -limbs.t11[0]));
    RESULT(checked2, q_next, 0, READ(q, 0) + atan2(limbs.t8[0], -limbs.t9[0]));
    /* else status 5: no rotation */
    NOT_BELOW(t11, 0.999999, 5);
    NOT_ABOVE(t11, 1.000001, 5);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.minus_U_0_lever_mz_by_S_fz, 6.62327e-13, 6.62327e-13, 6.62327e-13, 6.62327e-13) OR
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
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
