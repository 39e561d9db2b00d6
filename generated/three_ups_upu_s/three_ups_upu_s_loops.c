/*
 * three_ups_upu_s: loops.
 *   closure; closure_jacobian; closure_bias; velocity; null_space; acceleration; close_position;
 *   close_velocity; assemble
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

BODY(three_ups_upu_s_closure)(size_t stride, const double *restrict q, double *restrict residual_,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t2 = limb5_S_q_qw * limb5_S_q_qw,
      t3 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t4 = t2 + t3, t5 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7, t10 = 4.0 - 2.0 * t8,
      t22 = 0.5 * (1.0 - t7 * t10), t42 = t3 + t6, t18 = param_H * (1.0 - t10 * (t3 + t5)),
      platform_turn_yy = 1.0 - t10 * t42, t11 = limb5_S_q_qz * t10, t12 = limb5_S_q_qx * t11,
      t13 = limb5_S_q_qy * t10, t31 = limb5_S_q_qw * (limb5_S_q_qx * t10), t14 = limb5_S_q_qw * t13,
      t26 = limb5_S_q_qx * t13, platform_turn_zx = t12 - t14, t23 = param_H * (t12 + t14),
      t15 = 0.5 * platform_turn_zx, minus_limb1_upper_position_x_2 = t22 - t23, limb3_upper_position_x_2 = t22 + t23,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2), limb1_lower_sin = SINES(sine, 1),
      t24 = param_R - limb1_lower_sin * limb1_upper_offset_x - minus_limb1_upper_position_x_2, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), t25 = limb1_lower_sin * t24, /* limb1 */
      t36 = limb1_lower_cos * t24, /* limb1 */
      t27 = limb5_S_q_qw * t11, t29 = limb5_S_q_qy * t11, platform_turn_yx = t26 + t27, platform_turn_xy = t26 - t27,
      t28 = 0.5 * platform_turn_yx, platform_turn_yz = t29 - t31, platform_turn_zy = t29 + t31,
      t32 = param_H * platform_turn_yz;
    /* limb1: geometry */
    const REAL limb1_U_0_sin = SINES(sine, 0), minus_limb1_lower_limb_target_x = t28 - t32,
      limb3_lower_limb_target_x = t28 + t32, minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    /* limb1: loop closure; geometry */
    const REAL t33 = limb1_upper_offset_x * minus_limb1_lower_rotation_yx - minus_limb1_lower_limb_target_x,
      limb1_U_0_cos = SINES(cosine, 0), t35 = t25 - minus_limb1_lower_rotation_yx * t33,
      minus_limb1_lower_limb_target_y = t15 - t18, limb3_lower_limb_target_y = t15 + t18,
      limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos,
      t19 = limb1_upper_offset_x * limb1_lower_rotation_zx + minus_limb1_lower_limb_target_y,
      limb1_U2_opening_fx = limb1_lower_rotation_zx * t19 - t35;
    WRITE(residual_, 0, limb1_U2_opening_fx);
    REAL checked0 = limb1_U2_opening_fx;
    const REAL t41 = limb1_U_0_cos * t33,
      minus_limb1_U2_opening_fy = t36 + limb1_U_0_sin * limb1_lower_sin * t33 + limb1_U_0_cos * limb1_lower_sin * t19,
      limb1_U2_opening_fy = -minus_limb1_U2_opening_fy;
    WRITE(residual_, 1, limb1_U2_opening_fy);
    REAL checked1 = limb1_U2_opening_fy;
    const REAL limb1_U2_opening_fz = limb1_U_0_sin * t19 - t41;
    WRITE(residual_, 2, limb1_U2_opening_fz);
    REAL checked2 = limb1_U2_opening_fz;
    const REAL t45 = limb1_U_0_cos * platform_turn_zy, t57 = 0.5 * platform_turn_zy, /* platform */
      t47 = limb1_lower_sin * (limb1_U_0_sin * platform_turn_yy - t45),
      t53 = 0.5 * platform_turn_yy, /* platform */
      limb1_U2_opening_mn = t47 + limb1_lower_cos * platform_turn_xy;
    WRITE(residual_, 3, limb1_U2_opening_mn);
    REAL checked3 = limb1_U2_opening_mn;
    const REAL t50 = 0.5 * platform_turn_xy; /* platform */
    /* limb2: geometry; loop closure */
    const REAL limb2_lower_limb_target_y = t23 - t50, limb4_lower_limb_target_y = t23 + t50,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5), minus_limb2_U_0_cos = SINES(sine, 2),
      limb2_lower_cos = SINES(cosine, 3), minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos,
      t51 = limb2_upper_offset_x * minus_limb2_lower_rotation_xx + limb2_lower_limb_target_y,
      limb2_lower_sin = SINES(sine, 3), t52 = minus_limb2_lower_rotation_xx * t51,
      limb4_upper_position_y_2 = t32 + t53;
    /* limb2: loop closure; geometry */
    const REAL t54 = param_R - limb2_lower_sin * limb2_upper_offset_x + (t32 - t53), limb2_U_0_sin = SINES(cosine, 2),
      t56 = t52 - limb2_lower_sin * t54, t61 = limb2_lower_cos * t54, limb2_lower_limb_target_x = t18 - t57,
      limb4_lower_limb_target_x = t18 + t57, minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos,
      t58 = limb2_upper_offset_x * minus_limb2_lower_rotation_zx + limb2_lower_limb_target_x;
    RESULT(checked0, residual_, 4, t56 + minus_limb2_lower_rotation_zx * t58);
    const REAL t65 = limb2_U_0_sin * t51,
      minus_limb2_S_opening_fy = minus_limb2_U_0_cos * limb2_lower_sin * t51 + t61 + limb2_U_0_sin * limb2_lower_sin * t58;
    RESULT(checked1, residual_, 5, -minus_limb2_S_opening_fy);
    RESULT(checked2, residual_, 6, minus_limb2_U_0_cos * t58 - t65);
    /* limb3: geometry; loop closure */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      t69 = param_R - minus_limb3_lower_sin * limb3_upper_offset_x - limb3_upper_position_x_2,
      limb3_lower_cos = SINES(cosine, 5), limb3_U_0_sin = SINES(sine, 4);
    /* limb3: loop closure; geometry */
    const REAL t70 = minus_limb3_lower_sin * t69, t74 = limb3_lower_cos * t69,
      minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos,
      t71 = limb3_upper_offset_x * minus_limb3_lower_rotation_yx + limb3_lower_limb_target_x,
      limb3_U_0_cos = SINES(cosine, 4), t73 = t70 - minus_limb3_lower_rotation_yx * t71,
      limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos,
      t67 = limb3_upper_offset_x * limb3_lower_rotation_zx - limb3_lower_limb_target_y;
    RESULT(checked3, residual_, 7, limb3_lower_rotation_zx * t67 - t73);
    const REAL t79 = limb3_U_0_cos * t71;
    RESULT(checked0, residual_, 8, t74 + limb3_U_0_sin * minus_limb3_lower_sin * t71 + limb3_U_0_cos * minus_limb3_lower_sin * t67);
    RESULT(checked1, residual_, 9, limb3_U_0_sin * t67 - t79);
    /* limb4: geometry */
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11), minus_limb4_U_0_cos = SINES(sine, 6),
      limb4_lower_cos = SINES(cosine, 7), minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    /* limb4: loop closure; geometry */
    const REAL t81 = limb4_upper_offset_x * minus_limb4_lower_rotation_xx + limb4_lower_limb_target_y,
      minus_limb4_lower_sin = SINES(sine, 7), t82 = minus_limb4_lower_rotation_xx * t81,
      t83 = param_R - minus_limb4_lower_sin * limb4_upper_offset_x - limb4_upper_position_y_2,
      limb4_U_0_sin = SINES(cosine, 6), t85 = t82 - minus_limb4_lower_sin * t83, t89 = limb4_lower_cos * t83,
      minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos,
      t86 = limb4_upper_offset_x * minus_limb4_lower_rotation_zx + limb4_lower_limb_target_x;
    RESULT(checked2, residual_, 10, t85 + minus_limb4_lower_rotation_zx * t86);
    const REAL t90 = minus_limb4_U_0_cos * minus_limb4_lower_sin * t81 + t89, t93 = limb4_U_0_sin * t81;
    RESULT(checked3, residual_, 11, t90 + limb4_U_0_sin * minus_limb4_lower_sin * t86);
    RESULT(checked0, residual_, 12, minus_limb4_U_0_cos * t86 - t93);
    /* else status 5: no rotation */
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_closure_jacobian)(size_t stride, const double *restrict q, double *restrict jacobian,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry; results; reciprocal wrenches, eq. (10) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t2 = limb5_S_q_qw * limb5_S_q_qw,
      t3 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t4 = t2 + t3, t5 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7, t10 = 4.0 - 2.0 * t8,
      t11 = t3 + t6, platform_turn_zz = 1.0 - t10 * (t3 + t5), platform_turn_yy = 1.0 - t10 * t11,
      platform_turn_xx = 1.0 - t7 * t10, t14 = limb5_S_q_qz * t10, t15 = limb5_S_q_qy * t14,
      t17 = limb5_S_q_qw * (limb5_S_q_qx * t10), t23 = limb5_S_q_qy * t10, platform_turn_yz = t15 - t17,
      platform_turn_zy = t15 + t17, limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    WRITE(jacobian, 141, limb4_upper_offset_x);
    const REAL limb4_lower_cos = SINES(cosine, 7),
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x,
      limb4_U_0_lever_mz_by_limb4_S_fz = -minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    WRITE(jacobian, 129, limb4_U_0_lever_mz_by_limb4_S_fz);
    REAL checked0 = limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t170 = platform_turn_yz * minus_limb4_U_0_lever_mz_by_limb4_S_fz, t31 = limb5_S_q_qx * t14,
      t25 = limb5_S_q_qw * t14, t32 = limb5_S_q_qw * t23, t24 = limb5_S_q_qx * t23, platform_turn_xz = t31 + t32,
      platform_turn_zx = t31 - t32, minus_limb4_lower_sin = SINES(sine, 7),
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      minus_limb4_U_0_cos = SINES(sine, 6),
      minus_base_lever_mx_by_limb4_S_fz = minus_limb4_U_0_cos * limb4_upper_position_y,
      limb4_U_0_sin = SINES(cosine, 6), minus_base_lever_mz_by_limb4_S_fz = limb4_U_0_sin * limb4_upper_position_y;
    /* mechanism: results; reciprocal wrenches, eq. (10) */
    const REAL t172 = t170 + platform_turn_xz * minus_base_lever_mx_by_limb4_S_fz,
      jacobian_194 = t172 + platform_turn_zz * minus_base_lever_mz_by_limb4_S_fz;
    WRITE(jacobian, 194, jacobian_194);
    REAL checked1 = jacobian_194;
    const REAL t82 = minus_limb4_U_0_cos * limb4_upper_offset_x, /* limb4 */
      base_lever_mx_by_limb4_S_fy = limb4_U_0_sin * limb4_upper_offset_x - param_R * (limb4_U_0_sin * minus_limb4_lower_sin),
      t169 = platform_turn_xz * base_lever_mx_by_limb4_S_fy,
      minus_base_lever_mz_by_limb4_S_fy = t82 - param_R * (minus_limb4_U_0_cos * minus_limb4_lower_sin),
      jacobian_193 = platform_turn_zz * minus_base_lever_mz_by_limb4_S_fy - t169;
    WRITE(jacobian, 193, jacobian_193);
    REAL checked2 = jacobian_193;
    const REAL minus_base_lever_mx_by_limb4_S_fx = param_R * (limb4_U_0_sin * limb4_lower_cos),
      t166 = platform_turn_xz * minus_base_lever_mx_by_limb4_S_fx,
      base_lever_mz_by_limb4_S_fx = param_R * (minus_limb4_U_0_cos * limb4_lower_cos),
      jacobian_192 = t166 - platform_turn_zz * base_lever_mz_by_limb4_S_fx;
    WRITE(jacobian, 192, jacobian_192);
    REAL checked3 = jacobian_192;
    /* limb3: geometry; reciprocal wrenches, eq. (10) */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    WRITE(jacobian, 99, limb3_upper_offset_x);
    const REAL limb3_lower_cos = SINES(cosine, 5),
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    RESULT(checked0, jacobian, 87, -minus_limb3_U_0_lever_mz_by_limb3_S_fz);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    /* mechanism: results; reciprocal wrenches, eq. (10) */
    const REAL t162 = platform_turn_xz * minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x, limb3_U_0_sin = SINES(sine, 4),
      minus_base_lever_my_by_limb3_S_fz = limb3_U_0_sin * limb3_upper_position_x, limb3_U_0_cos = SINES(cosine, 4),
      base_lever_mz_by_limb3_S_fz = limb3_U_0_cos * limb3_upper_position_x,
      t164 = t162 + platform_turn_yz * minus_base_lever_my_by_limb3_S_fz;
    RESULT(checked1, jacobian, 191, t164 - platform_turn_zz * base_lever_mz_by_limb3_S_fz);
    const REAL t72 = limb3_U_0_sin * limb3_upper_offset_x, /* limb3 */
      base_lever_my_by_limb3_S_fy = limb3_U_0_cos * limb3_upper_offset_x - param_R * (limb3_U_0_cos * minus_limb3_lower_sin),
      t159 = platform_turn_yz * base_lever_my_by_limb3_S_fy,
      base_lever_mz_by_limb3_S_fy = t72 - param_R * (limb3_U_0_sin * minus_limb3_lower_sin);
    RESULT(checked2, jacobian, 190, -(t159 + platform_turn_zz * base_lever_mz_by_limb3_S_fy));
    const REAL minus_base_lever_my_by_limb3_S_fx = param_R * (limb3_U_0_cos * limb3_lower_cos),
      t157 = platform_turn_yz * minus_base_lever_my_by_limb3_S_fx,
      minus_base_lever_mz_by_limb3_S_fx = param_R * (limb3_U_0_sin * limb3_lower_cos);
    RESULT(checked3, jacobian, 189, t157 + platform_turn_zz * minus_base_lever_mz_by_limb3_S_fx);
    /* limb2: geometry; reciprocal wrenches, eq. (10) */
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    WRITE(jacobian, 57, limb2_upper_offset_x);
    const REAL limb2_lower_cos = SINES(cosine, 3),
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    RESULT(checked0, jacobian, 45, -minus_limb2_U_0_lever_mz_by_limb2_S_fz);
    const REAL limb2_lower_sin = SINES(sine, 3);
    /* mechanism: results; reciprocal wrenches, eq. (10) */
    const REAL t153 = platform_turn_yz * minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      minus_limb2_U_0_cos = SINES(sine, 2),
      base_lever_mx_by_limb2_S_fz = minus_limb2_U_0_cos * minus_limb2_upper_position_y,
      limb2_U_0_sin = SINES(cosine, 2), base_lever_mz_by_limb2_S_fz = limb2_U_0_sin * minus_limb2_upper_position_y,
      t155 = t153 - platform_turn_xz * base_lever_mx_by_limb2_S_fz;
    RESULT(checked1, jacobian, 188, t155 - platform_turn_zz * base_lever_mz_by_limb2_S_fz);
    const REAL t57 = minus_limb2_U_0_cos * limb2_upper_offset_x, /* limb2 */
      base_lever_mx_by_limb2_S_fy = limb2_U_0_sin * limb2_upper_offset_x - param_R * (limb2_U_0_sin * limb2_lower_sin),
      t152 = platform_turn_xz * base_lever_mx_by_limb2_S_fy,
      minus_base_lever_mz_by_limb2_S_fy = t57 - param_R * (minus_limb2_U_0_cos * limb2_lower_sin);
    RESULT(checked2, jacobian, 187, platform_turn_zz * minus_base_lever_mz_by_limb2_S_fy - t152);
    const REAL base_lever_mx_by_limb2_S_fx = param_R * (limb2_U_0_sin * limb2_lower_cos),
      t150 = platform_turn_xz * base_lever_mx_by_limb2_S_fx,
      minus_base_lever_mz_by_limb2_S_fx = param_R * (minus_limb2_U_0_cos * limb2_lower_cos);
    RESULT(checked3, jacobian, 186, platform_turn_zz * minus_base_lever_mz_by_limb2_S_fx - t150);
    /* limb1: geometry */
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1);
    /* limb1: reciprocal wrenches, eq. (10); geometry */
    const REAL t22 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy),
      platform_turn_xy = t24 - t25, platform_turn_yx = t24 + t25, limb1_lower_sin = SINES(sine, 1),
      limb1_U2_constraint_mn_couple_z = t22 - limb1_lower_sin * platform_turn_xy;
    WRITE(jacobian, 16, limb1_U2_constraint_mn_couple_z);
    const REAL t48 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z,
      t51 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    WRITE(jacobian, 3, limb1_U_0_lever_mz_by_limb1_U2_mn);
    const REAL base_lever_my_by_limb1_U2_mn = t48 - limb1_U_0_sin * limb1_U_0_lever_my_by_limb1_U2_mn,
      base_lever_mz_by_limb1_U2_mn = t51 + limb1_U_0_cos * limb1_U_0_lever_my_by_limb1_U2_mn,
      t145 = platform_turn_yz * base_lever_my_by_limb1_U2_mn, /* mechanism */
      t146 = platform_turn_xz * limb1_U_0_lever_mz_by_limb1_U2_mn + t145; /* mechanism */
    RESULT(checked0, jacobian, 185, -(t146 + platform_turn_zz * base_lever_mz_by_limb1_U2_mn));
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    WRITE(jacobian, 14, limb1_upper_offset_x);
    const REAL minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    /* mechanism: results; reciprocal wrenches, eq. (10) */
    const REAL t140 = platform_turn_xz * minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    RESULT(checked1, jacobian, 2, -minus_limb1_U_0_lever_mz_by_limb1_U2_fz);
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      base_lever_my_by_limb1_U2_fz = limb1_U_0_sin * minus_limb1_upper_position_x,
      minus_base_lever_mz_by_limb1_U2_fz = limb1_U_0_cos * minus_limb1_upper_position_x,
      t142 = t140 - platform_turn_yz * base_lever_my_by_limb1_U2_fz;
    RESULT(checked2, jacobian, 184, t142 + platform_turn_zz * minus_base_lever_mz_by_limb1_U2_fz);
    const REAL t38 = limb1_U_0_sin * limb1_upper_offset_x, /* limb1 */
      base_lever_my_by_limb1_U2_fy = limb1_U_0_cos * limb1_upper_offset_x - param_R * (limb1_U_0_cos * limb1_lower_sin),
      t137 = platform_turn_yz * base_lever_my_by_limb1_U2_fy,
      base_lever_mz_by_limb1_U2_fy = t38 - param_R * (limb1_U_0_sin * limb1_lower_sin);
    RESULT(checked3, jacobian, 183, -(t137 + platform_turn_zz * base_lever_mz_by_limb1_U2_fy));
    const REAL base_lever_my_by_limb1_U2_fx = param_R * (limb1_U_0_cos * limb1_lower_cos),
      t132 = platform_turn_yz * base_lever_my_by_limb1_U2_fx,
      base_lever_mz_by_limb1_U2_fx = param_R * (limb1_U_0_sin * limb1_lower_cos);
    RESULT(checked0, jacobian, 182, -(t132 + platform_turn_zz * base_lever_mz_by_limb1_U2_fx));
    const REAL t129 = platform_turn_xy * minus_base_lever_mx_by_limb4_S_fz,
      t89 = platform_turn_xx * minus_base_lever_mx_by_limb4_S_fz,
      t130 = platform_turn_yy * minus_limb4_U_0_lever_mz_by_limb4_S_fz + t129,
      t90 = platform_turn_yx * minus_limb4_U_0_lever_mz_by_limb4_S_fz + t89;
    RESULT(checked1, jacobian, 181, t130 + platform_turn_zy * minus_base_lever_mz_by_limb4_S_fz);
    RESULT(checked2, jacobian, 168, t90 + platform_turn_zx * minus_base_lever_mz_by_limb4_S_fz);
    const REAL t126 = platform_turn_zy * minus_base_lever_mz_by_limb4_S_fy,
      t84 = platform_turn_zx * minus_base_lever_mz_by_limb4_S_fy;
    RESULT(checked3, jacobian, 180, t126 - platform_turn_xy * base_lever_mx_by_limb4_S_fy);
    RESULT(checked0, jacobian, 167, t84 - platform_turn_xx * base_lever_mx_by_limb4_S_fy);
    const REAL t124 = platform_turn_xy * minus_base_lever_mx_by_limb4_S_fx,
      t80 = platform_turn_xx * minus_base_lever_mx_by_limb4_S_fx;
    RESULT(checked1, jacobian, 179, t124 - platform_turn_zy * base_lever_mz_by_limb4_S_fx);
    RESULT(checked2, jacobian, 166, t80 - platform_turn_zx * base_lever_mz_by_limb4_S_fx);
    const REAL t120 = platform_turn_xy * minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      t76 = platform_turn_xx * minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      t122 = t120 + platform_turn_yy * minus_base_lever_my_by_limb3_S_fz,
      t78 = t76 + platform_turn_yx * minus_base_lever_my_by_limb3_S_fz;
    RESULT(checked3, jacobian, 178, t122 - platform_turn_zy * base_lever_mz_by_limb3_S_fz);
    RESULT(checked0, jacobian, 165, t78 - platform_turn_zx * base_lever_mz_by_limb3_S_fz);
    const REAL t74 = platform_turn_zx * base_lever_mz_by_limb3_S_fy,
      t119 = platform_turn_yy * base_lever_my_by_limb3_S_fy + platform_turn_zy * base_lever_mz_by_limb3_S_fy;
    RESULT(checked1, jacobian, 177, -t119);
    RESULT(checked2, jacobian, 164, -(platform_turn_yx * base_lever_my_by_limb3_S_fy + t74));
    const REAL t116 = platform_turn_zy * minus_base_lever_mz_by_limb3_S_fx,
      t68 = platform_turn_zx * minus_base_lever_mz_by_limb3_S_fx;
    RESULT(checked3, jacobian, 176, platform_turn_yy * minus_base_lever_my_by_limb3_S_fx + t116);
    RESULT(checked0, jacobian, 163, platform_turn_yx * minus_base_lever_my_by_limb3_S_fx + t68);
    const REAL t112 = platform_turn_xy * base_lever_mx_by_limb2_S_fz,
      t64 = platform_turn_xx * base_lever_mx_by_limb2_S_fz,
      t113 = platform_turn_yy * minus_limb2_U_0_lever_mz_by_limb2_S_fz - t112,
      t65 = platform_turn_yx * minus_limb2_U_0_lever_mz_by_limb2_S_fz - t64;
    RESULT(checked1, jacobian, 175, t113 - platform_turn_zy * base_lever_mz_by_limb2_S_fz);
    RESULT(checked2, jacobian, 162, t65 - platform_turn_zx * base_lever_mz_by_limb2_S_fz);
    const REAL t109 = platform_turn_zy * minus_base_lever_mz_by_limb2_S_fy,
      t59 = platform_turn_zx * minus_base_lever_mz_by_limb2_S_fy;
    RESULT(checked3, jacobian, 174, t109 - platform_turn_xy * base_lever_mx_by_limb2_S_fy);
    RESULT(checked0, jacobian, 161, t59 - platform_turn_xx * base_lever_mx_by_limb2_S_fy);
    const REAL t107 = platform_turn_zy * minus_base_lever_mz_by_limb2_S_fx,
      t55 = platform_turn_zx * minus_base_lever_mz_by_limb2_S_fx;
    RESULT(checked1, jacobian, 173, t107 - platform_turn_xy * base_lever_mx_by_limb2_S_fx);
    RESULT(checked2, jacobian, 160, t55 - platform_turn_xx * base_lever_mx_by_limb2_S_fx);
    const REAL t103 = platform_turn_yy * base_lever_my_by_limb1_U2_mn,
      t49 = platform_turn_yx * base_lever_my_by_limb1_U2_mn,
      t104 = platform_turn_xy * limb1_U_0_lever_mz_by_limb1_U2_mn + t103,
      t98 = platform_turn_xy * minus_limb1_U_0_lever_mz_by_limb1_U2_fz,
      t50 = platform_turn_xx * limb1_U_0_lever_mz_by_limb1_U2_mn + t49,
      t43 = platform_turn_xx * minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    RESULT(checked3, jacobian, 172, -(t104 + platform_turn_zy * base_lever_mz_by_limb1_U2_mn));
    RESULT(checked0, jacobian, 159, -(t50 + platform_turn_zx * base_lever_mz_by_limb1_U2_mn));
    const REAL t100 = t98 - platform_turn_yy * base_lever_my_by_limb1_U2_fz,
      t45 = t43 - platform_turn_yx * base_lever_my_by_limb1_U2_fz;
    RESULT(checked1, jacobian, 171, t100 + platform_turn_zy * minus_base_lever_mz_by_limb1_U2_fz);
    RESULT(checked2, jacobian, 158, t45 + platform_turn_zx * minus_base_lever_mz_by_limb1_U2_fz);
    const REAL t96 = platform_turn_zy * base_lever_mz_by_limb1_U2_fy,
      t93 = platform_turn_zy * base_lever_mz_by_limb1_U2_fx, t40 = platform_turn_zx * base_lever_mz_by_limb1_U2_fy,
      t33 = platform_turn_zx * base_lever_mz_by_limb1_U2_fx;
    RESULT(checked3, jacobian, 170, -(platform_turn_yy * base_lever_my_by_limb1_U2_fy + t96));
    RESULT(checked0, jacobian, 169, -(platform_turn_yy * base_lever_my_by_limb1_U2_fx + t93));
    RESULT(checked1, jacobian, 157, -(platform_turn_yx * base_lever_my_by_limb1_U2_fy + t40));
    RESULT(checked2, jacobian, 156, -(platform_turn_yx * base_lever_my_by_limb1_U2_fx + t33));
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
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_closure_bias)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t4 = limb5_S_q_qw * limb5_S_q_qw,
      t5 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t6 = t4 + t5, t7 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t8 = limb5_S_q_qz * limb5_S_q_qz, t9 = t7 + t8, t10 = t6 + t9,
      t12 = 4.0 - 2.0 * t10, t27 = t5 + t7, platform_turn_yy = 1.0 - t12 * (t5 + t8), limb5_S_v_wz = READ(v, 14),
      limb5_S_v_wx = READ(v, 12), t29 = limb5_S_v_wz * (1.0 - t12 * t27), t39 = limb5_S_v_wx * (1.0 - t9 * t12),
      t16 = limb5_S_q_qy * t12, t17 = limb5_S_q_qx * t16, t31 = limb5_S_q_qw * t16, t18 = limb5_S_q_qz * t12,
      t24 = limb5_S_q_qw * (limb5_S_q_qx * t12), t19 = limb5_S_q_qw * t18, platform_turn_yx = t17 + t19,
      platform_turn_xy = t17 - t19, limb5_S_v_wy = READ(v, 13),
      t21 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, t22 = limb5_S_q_qy * t18,
      t30 = limb5_S_q_qx * t18, platform_turn_yz = t22 - t24, platform_turn_zy = t22 + t24,
      platform_twist_wy = t21 + limb5_S_v_wz * platform_turn_yz;
    /* limb1: geometry; loop closure */
    const REAL limb1_U_0_sin = SINES(sine, 0), t26 = limb1_U_0_sin * platform_twist_wy,
      t42 = limb5_S_v_wz * (t30 + t31), /* platform */
      platform_twist_wz = t29 + (limb5_S_v_wx * (t30 - t31) + limb5_S_v_wy * platform_turn_zy),
      limb1_U_0_cos = SINES(cosine, 0), t36 = t26 - limb1_U_0_cos * platform_twist_wz,
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1);
    /* limb1: loop closure; reciprocal wrenches, eq. (10); accelerations */
    const REAL t45 = limb1_lower_cos * t36, t37 = limb1_lower_sin * t36,
      platform_twist_wx = t39 + limb5_S_v_wy * platform_turn_xy + t42,
      t47 = t45 - limb1_lower_sin * platform_twist_wx, minus_limb1_U2_arm_y = param_R * limb1_lower_cos,
      t48 = minus_limb1_U2_arm_y * t47, t44 = t37 + limb1_lower_cos * platform_twist_wx,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin, t51 = t48 - limb1_U2_arm_x * t44,
      t52 = t44 * t51, t64 = t47 * t51, t55 = limb1_U_0_cos * platform_twist_wy + limb1_U_0_sin * platform_twist_wz,
      t56 = limb1_U2_arm_x * t55, t62 = minus_limb1_U2_arm_y * t55, limb1_U_v_0 = READ(v, 0), t58 = t52 - t55 * t56,
      t69 = t47 * t56, limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, limb1_U_v_1 = READ(v, 1),
      minus_limb1_upper_acc_still_x = limb1_upper_offset_x * (limb1_lower_omega_y * limb1_lower_omega_y + limb1_U_v_1 * limb1_U_v_1),
      limb1_U2_opening_bias_fx = -(minus_limb1_upper_acc_still_x + t58);
    WRITE(bias, 0, limb1_U2_opening_bias_fx);
    REAL checked0 = limb1_U2_opening_bias_fx;
    const REAL t65 = t55 * t62 + t64, t71 = t69 + t44 * t62, t76 = limb1_lower_omega_y - t44, t74 = limb1_U_v_1 - t55,
      limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin, t87 = limb1_lower_omega_x + t47, limb1_P_v = READ(v, 2),
      t59 = limb1_upper_offset_x * (limb1_lower_omega_x * limb1_lower_omega_y),
      limb1_U2_opening_bias_fy = t59 + limb1_P_v * (2.0 * limb1_U_v_1) - t65;
    WRITE(bias, 1, limb1_U2_opening_bias_fy);
    REAL checked1 = limb1_U2_opening_bias_fy;
    const REAL t66 = limb1_upper_offset_x * (2.0 * (limb1_U_v_1 * limb1_lower_omega_x)),
      t86 = limb1_lower_omega_x * t76, limb1_U2_opening_bias_fz = t66 - limb1_P_v * (2.0 * limb1_lower_omega_y) + t71;
    WRITE(bias, 2, limb1_U2_opening_bias_fz);
    REAL checked2 = limb1_U2_opening_bias_fz;
    const REAL t79 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t74 - limb1_U_v_1 * t76),
      t89 = t86 - limb1_lower_omega_y * t87, t82 = limb1_U_0_cos * platform_turn_zy,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t80 = limb1_U2_constraint_mn_couple_x * t79, t83 = limb1_U_0_sin * platform_turn_yy - t82,
      t98 = limb1_U2_constraint_mn_couple_x * t76, t92 = limb1_lower_sin * t83,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t83 - limb1_lower_sin * platform_turn_xy,
      t91 = t80 - limb1_U2_constraint_mn_couple_z * t89, t95 = limb1_U2_constraint_mn_couple_z * t76,
      limb1_U2_opening_mn = t92 + limb1_lower_cos * platform_turn_xy, t97 = t87 * (limb1_U2_opening_mn * t87 + t95),
      limb1_U2_opening_bias_mn = t91 - (t97 - t74 * (t98 - limb1_U2_opening_mn * t74));
    WRITE(bias, 3, limb1_U2_opening_bias_mn);
    REAL checked3 = limb1_U2_opening_bias_mn;
    /* limb2: geometry; loop closure */
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2),
      t108 = limb2_U_0_sin * platform_twist_wz + minus_limb2_U_0_cos * platform_twist_wx,
      limb2_lower_cos = SINES(cosine, 3), limb2_lower_sin = SINES(sine, 3);
    /* limb2: loop closure; velocities, eq. (6); accelerations */
    const REAL t109 = limb2_lower_sin * t108, t114 = limb2_lower_cos * t108 - limb2_lower_sin * platform_twist_wy,
      minus_limb2_S_arm_y = param_R * limb2_lower_cos, t115 = minus_limb2_S_arm_y * t114,
      t111 = t109 + limb2_lower_cos * platform_twist_wy, limb2_upper_offset_x = limb_upper_phase + READ(q, 5),
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin, t118 = t115 - limb2_S_arm_x * t111,
      t119 = t111 * t118, t131 = t114 * t118,
      t122 = minus_limb2_U_0_cos * platform_twist_wz - limb2_U_0_sin * platform_twist_wx, t123 = limb2_S_arm_x * t122,
      t129 = minus_limb2_S_arm_y * t122, limb2_U_v_0 = READ(v, 3), t125 = t119 - t122 * t123,
      t132 = t122 * t129 + t131, t138 = t114 * t123 + t111 * t129,
      limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos, limb2_U_v_1 = READ(v, 4),
      minus_limb2_upper_acc_still_x = limb2_upper_offset_x * (limb2_lower_omega_y * limb2_lower_omega_y + limb2_U_v_1 * limb2_U_v_1);
    RESULT(checked0, bias, 4, -(minus_limb2_upper_acc_still_x + t125));
    const REAL limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin, limb2_P_v = READ(v, 5),
      t126 = limb2_upper_offset_x * (limb2_lower_omega_x * limb2_lower_omega_y),
      t133 = limb2_upper_offset_x * (2.0 * (limb2_U_v_1 * limb2_lower_omega_x));
    RESULT(checked1, bias, 6, t133 - limb2_P_v * (2.0 * limb2_lower_omega_y) - t138);
    RESULT(checked2, bias, 5, t126 + limb2_P_v * (2.0 * limb2_U_v_1) - t132);
    /* limb3: geometry; loop closure */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4),
      t144 = limb3_U_0_sin * platform_twist_wy - limb3_U_0_cos * platform_twist_wz,
      limb3_lower_cos = SINES(cosine, 5), minus_limb3_lower_sin = SINES(sine, 5);
    /* limb3: loop closure; velocities, eq. (6); accelerations */
    const REAL t145 = minus_limb3_lower_sin * t144,
      t150 = limb3_lower_cos * t144 + minus_limb3_lower_sin * platform_twist_wx,
      limb3_S_arm_y = param_R * limb3_lower_cos, t151 = limb3_S_arm_y * t150,
      t147 = t145 - limb3_lower_cos * platform_twist_wx, limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin, t154 = t151 - limb3_S_arm_x * t147,
      t155 = t147 * t154, t164 = t150 * t154,
      t158 = limb3_U_0_cos * platform_twist_wy + limb3_U_0_sin * platform_twist_wz, t159 = limb3_S_arm_x * t158,
      t162 = limb3_S_arm_y * t158, limb3_U_v_0 = READ(v, 6), t161 = t155 - t158 * t159, t165 = t158 * t162 + t164,
      t171 = t150 * t159 + t147 * t162, limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos, limb3_U_v_1 = READ(v, 7),
      minus_limb3_upper_acc_still_x = limb3_upper_offset_x * (limb3_lower_omega_y * limb3_lower_omega_y + limb3_U_v_1 * limb3_U_v_1);
    RESULT(checked3, bias, 7, -(minus_limb3_upper_acc_still_x + t161));
    const REAL minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin, limb3_P_v = READ(v, 8),
      t166 = limb3_upper_offset_x * (minus_limb3_lower_omega_x * limb3_lower_omega_y),
      t172 = limb3_upper_offset_x * (2.0 * (limb3_U_v_1 * minus_limb3_lower_omega_x));
    RESULT(checked0, bias, 9, t171 - (t172 + limb3_P_v * (2.0 * limb3_lower_omega_y)));
    RESULT(checked1, bias, 8, t165 - (t166 - limb3_P_v * (2.0 * limb3_U_v_1)));
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    /* limb4: loop closure; geometry; accelerations */
    const REAL t192 = minus_limb4_U_0_cos * platform_twist_wz,
      t180 = limb4_U_0_sin * platform_twist_wz + minus_limb4_U_0_cos * platform_twist_wx,
      t194 = t192 - limb4_U_0_sin * platform_twist_wx, limb4_lower_cos = SINES(cosine, 7),
      minus_limb4_lower_sin = SINES(sine, 7), t181 = minus_limb4_lower_sin * t180,
      t186 = limb4_lower_cos * t180 + minus_limb4_lower_sin * platform_twist_wy,
      t183 = t181 - limb4_lower_cos * platform_twist_wy, limb4_S_arm_y = param_R * limb4_lower_cos,
      t187 = limb4_S_arm_y * t186, t198 = limb4_S_arm_y * t194, limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin, t190 = t187 - limb4_S_arm_x * t183,
      t195 = limb4_S_arm_x * t194, limb4_U_v_0 = READ(v, 9), t197 = t183 * t190 - t194 * t195,
      t201 = t194 * t198 + t186 * t190, t210 = t186 * t195 + t183 * t198,
      limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos, limb4_U_v_1 = READ(v, 10),
      minus_limb4_upper_acc_still_x = limb4_upper_offset_x * (limb4_lower_omega_y * limb4_lower_omega_y + limb4_U_v_1 * limb4_U_v_1);
    RESULT(checked2, bias, 10, -(minus_limb4_upper_acc_still_x + t197));
    const REAL minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin, limb4_P_v = READ(v, 11),
      t202 = limb4_upper_offset_x * (minus_limb4_lower_omega_x * limb4_lower_omega_y),
      t205 = limb4_upper_offset_x * (2.0 * (limb4_U_v_1 * minus_limb4_lower_omega_x));
    RESULT(checked3, bias, 12, -(t205 + limb4_P_v * (2.0 * limb4_lower_omega_y) + t210));
    RESULT(checked0, bias, 11, t201 - (t202 - limb4_P_v * (2.0 * limb4_U_v_1)));
    /* else status 5: no rotation */
    NOT_BELOW(t10, 0.999999, 5);
    NOT_ABOVE(t10, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_velocity)(size_t stride, const double *restrict q, const double *restrict y_dot,
    double *restrict v, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6;
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL t15 = t2 + t5, t114 = t2 + t4, t14 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t14 * t15,
      t9 = k2 - 0.5 * t7, platform_turn_zz = 1.0 - t14 * t114, platform_turn_xx = 1.0 - t6 * t14,
      t18 = limb5_S_q_qz * t14, t19 = limb5_S_q_qy * t18, t21 = limb5_S_q_qw * (limb5_S_q_qx * t14),
      t30 = limb5_S_q_qy * t14, platform_turn_zy = t19 + t21, limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1), platform_turn_yz = t19 - t21,
      t29 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy), /* limb1 */
      t31 = limb5_S_q_qx * t30, t104 = limb5_S_q_qw * t30, t32 = limb5_S_q_qw * t18, t103 = limb5_S_q_qx * t18,
      platform_turn_xy = t31 - t32;
    /* limb1: geometry; reciprocal wrenches, eq. (10); rates that follow */
    const REAL limb1_lower_sin = SINES(sine, 1), platform_turn_yx = t31 + t32,
      limb1_U2_constraint_mn_couple_z = t29 - limb1_lower_sin * platform_turn_xy,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t23 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t35 = limb1_lower_cos * t23,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t35,
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t37 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t40 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t24 = minus_limb1_upper_position_x * (limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t23),
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t24;
    /* limb5_S: pivots; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t37;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL t38 = 1.0 / minus_limb5_S_pivot_wz,
      t41 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t40, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t38 * t41;
    /* limb5_S: velocities, eq. (6); geometry */
    const REAL t42 = limb5_S_q_qx * t9 * limb5_S_null_space_wz_by_limb5_S_wy, t10 = limb5_S_q_qw * t9,
      a_pivot = 0.5 * (t10 + t42);
    REAL checked2 = a_pivot;
    const REAL t44 = 1.0 / a_pivot, t53 = 0.5 * t10, t47 = limb5_S_q_qy * t9 * limb5_S_null_space_wz_by_limb5_S_wy,
      t45 = limb5_S_q_qz * t9, t50 = t44 * (0.5 * (t45 - t47)), t54 = 0.5 * t45, limb5_S_y_dot_qy = READ(y_dot, 1),
      t52 = READ(y_dot, 0) - limb5_S_y_dot_qy * t50, a_pivot_2 = t53 + t54 * t50;
    REAL checked3 = a_pivot_2;
    const REAL limb5_S_joint_rate_wx = t52 / a_pivot_2,
      limb5_S_joint_rate_wy = t44 * (limb5_S_y_dot_qy + t54 * limb5_S_joint_rate_wx),
      limb5_S_joint_rate_wz = t38 * (t41 * limb5_S_joint_rate_wy), t116 = platform_turn_zz * limb5_S_joint_rate_wz,
      t117 = platform_turn_yz * limb5_S_joint_rate_wy, t110 = platform_turn_zy * limb5_S_joint_rate_wz;
    RESULT(checked0, v, 13, t110 + (platform_turn_yy * limb5_S_joint_rate_wy + platform_turn_xy * limb5_S_joint_rate_wx));
    const REAL t109 = platform_turn_yx * limb5_S_joint_rate_wy + platform_turn_xx * limb5_S_joint_rate_wx,
      platform_turn_zx = t103 - t104;
    RESULT(checked1, v, 14, t116 + (t117 + (t103 + t104) * limb5_S_joint_rate_wx));
    RESULT(checked2, v, 12, platform_turn_zx * limb5_S_joint_rate_wz + t109);
    /* limb4: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6),
      t101 = minus_limb4_U_0_cos * limb5_S_joint_rate_wz - limb4_U_0_sin * limb5_S_joint_rate_wx,
      limb4_lower_cos = SINES(cosine, 7);
    RESULT(checked3, v, 11, param_R * limb4_lower_cos * t101);
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11), minus_limb4_lower_sin = SINES(sine, 7),
      minus_limb4_upper_vel_y = (limb4_upper_offset_x - param_R * minus_limb4_lower_sin) * t101,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    checked0 = checked0 + minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t92 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    RESULT(checked1, v, 10, -(minus_limb4_upper_vel_y * (limb4_lower_cos * t92)));
    const REAL t96 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_joint_rate_wz + minus_limb4_U_0_cos * limb5_S_joint_rate_wx);
    RESULT(checked2, v, 9, limb5_S_joint_rate_wy + t92 * t96);
    /* limb3: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4),
      t89 = limb3_U_0_sin * limb5_S_joint_rate_wz + limb3_U_0_cos * limb5_S_joint_rate_wy,
      limb3_lower_cos = SINES(cosine, 5);
    RESULT(checked3, v, 8, -(param_R * limb3_lower_cos * t89));
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      limb3_upper_vel_y = (limb3_upper_offset_x - param_R * minus_limb3_lower_sin) * t89,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    checked0 = checked0 + minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t80 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    RESULT(checked1, v, 7, limb3_upper_vel_y * (limb3_lower_cos * t80));
    const REAL t84 = limb3_upper_position_x * (limb3_U_0_cos * limb5_S_joint_rate_wz - limb3_U_0_sin * limb5_S_joint_rate_wy);
    RESULT(checked2, v, 6, limb5_S_joint_rate_wx - t80 * t84);
    /* limb2: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2),
      t77 = minus_limb2_U_0_cos * limb5_S_joint_rate_wz - limb2_U_0_sin * limb5_S_joint_rate_wx,
      limb2_lower_cos = SINES(cosine, 3);
    RESULT(checked3, v, 5, -(param_R * limb2_lower_cos * t77));
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5), limb2_lower_sin = SINES(sine, 3),
      minus_limb2_upper_vel_y = (limb2_upper_offset_x - param_R * limb2_lower_sin) * t77,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    checked0 = checked0 + minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t68 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    RESULT(checked1, v, 4, -(minus_limb2_upper_vel_y * (limb2_lower_cos * t68)));
    const REAL t72 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_joint_rate_wz + minus_limb2_U_0_cos * limb5_S_joint_rate_wx);
    RESULT(checked2, v, 3, limb5_S_joint_rate_wy - t68 * t72);
    const REAL t59 = limb1_U_0_cos * limb5_S_joint_rate_wz, /* limb1 */
      t66 = limb1_U_0_sin * limb5_S_joint_rate_wz + limb1_U_0_cos * limb5_S_joint_rate_wy; /* limb1 */
    RESULT(checked3, v, 1, t35 * (limb1_U2_arm_x * t66));
    RESULT(checked0, v, 0, limb5_S_joint_rate_wx + t23 * (minus_limb1_upper_position_x * (t59 - limb1_U_0_sin * limb5_S_joint_rate_wy)));
    RESULT(checked1, v, 2, param_R * limb1_lower_cos * t66);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(a_pivot_2, 1.0e-09), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_null_space)(size_t stride, const double *restrict q, double *restrict null_space,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: rates that follow */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6;
    /* limb5_S: geometry; rates that follow */
    const REAL t18 = t2 + t5, t115 = t2 + t4, t17 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t17 * t18,
      t9 = k2 - 0.5 * t7, platform_turn_zz = 1.0 - t17 * t115, platform_turn_xx = 1.0 - t6 * t17,
      t21 = limb5_S_q_qz * t17, t22 = limb5_S_q_qy * t21, t24 = limb5_S_q_qw * (limb5_S_q_qx * t17),
      t33 = limb5_S_q_qy * t17, platform_turn_zy = t22 + t24, platform_turn_yz = t22 - t24,
      limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1),
      t32 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy), /* limb1 */
      t34 = limb5_S_q_qx * t33, t105 = limb5_S_q_qw * t33, t35 = limb5_S_q_qw * t21, t104 = limb5_S_q_qx * t21,
      platform_turn_xy = t34 - t35, platform_turn_yx = t34 + t35;
    /* limb1: geometry; reciprocal wrenches, eq. (10); rates that follow */
    const REAL limb1_lower_sin = SINES(sine, 1),
      limb1_U2_constraint_mn_couple_z = t32 - limb1_lower_sin * platform_turn_xy,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t26 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t38 = limb1_lower_cos * t26,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t38,
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t40 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t43 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t27 = minus_limb1_upper_position_x * (limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t26),
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t27;
    /* limb5_S: pivots */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t40;
    REAL checked1 = minus_limb5_S_pivot_wz;
    /* limb5_S: rates that follow; geometry */
    const REAL t41 = 1.0 / minus_limb5_S_pivot_wz,
      t44 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t43, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t41 * t44, t45 = limb5_S_q_qx * t9 * limb5_S_null_space_wz_by_limb5_S_wy,
      t10 = limb5_S_q_qw * t9, a_pivot = 0.5 * (t10 + t45);
    REAL checked2 = a_pivot;
    const REAL t47 = 1.0 / a_pivot, t11 = 0.5 * t10, t49 = limb5_S_q_qy * t9 * limb5_S_null_space_wz_by_limb5_S_wy,
      t12 = limb5_S_q_qz * t9, t52 = t47 * (0.5 * (t12 - t49)), t13 = 0.5 * t12, a_pivot_2 = t11 + t13 * t52;
    REAL checked3 = a_pivot_2;
    const REAL limb5_S_null_space_wx_by_limb5_S_qx = 1.0 / a_pivot_2,
      t121 = t52 * limb5_S_null_space_wx_by_limb5_S_qx,
      limb5_S_null_space_wy_by_limb5_S_qy = t47 * (1.0 - t13 * t121),
      limb5_S_null_space_wy_by_limb5_S_qx = t47 * (t13 * limb5_S_null_space_wx_by_limb5_S_qx),
      limb5_S_null_space_wz_by_limb5_S_qy = t41 * (t44 * limb5_S_null_space_wy_by_limb5_S_qy),
      limb5_S_null_space_wz_by_limb5_S_qx = t41 * (t44 * limb5_S_null_space_wy_by_limb5_S_qx),
      t169 = platform_turn_zz * limb5_S_null_space_wz_by_limb5_S_qy,
      t117 = platform_turn_zz * limb5_S_null_space_wz_by_limb5_S_qx,
      t170 = platform_turn_yz * limb5_S_null_space_wy_by_limb5_S_qy,
      t118 = platform_turn_yz * limb5_S_null_space_wy_by_limb5_S_qx, platform_turn_xz = t104 + t105,
      platform_turn_zx = t104 - t105;
    RESULT(checked0, null_space, 29, t169 + (t170 - platform_turn_xz * t121));
    RESULT(checked1, null_space, 14, t117 + (t118 + platform_turn_xz * limb5_S_null_space_wx_by_limb5_S_qx));
    const REAL t165 = platform_turn_zy * limb5_S_null_space_wz_by_limb5_S_qy,
      t111 = platform_turn_zy * limb5_S_null_space_wz_by_limb5_S_qx,
      t112 = platform_turn_yy * limb5_S_null_space_wy_by_limb5_S_qx;
    RESULT(checked2, null_space, 28, t165 + (platform_turn_yy * limb5_S_null_space_wy_by_limb5_S_qy - platform_turn_xy * t121));
    RESULT(checked3, null_space, 13, t111 + (t112 + platform_turn_xy * limb5_S_null_space_wx_by_limb5_S_qx));
    const REAL t161 = platform_turn_zx * limb5_S_null_space_wz_by_limb5_S_qy,
      t106 = platform_turn_zx * limb5_S_null_space_wz_by_limb5_S_qx,
      t107 = platform_turn_yx * limb5_S_null_space_wy_by_limb5_S_qx;
    RESULT(checked0, null_space, 27, t161 + (platform_turn_yx * limb5_S_null_space_wy_by_limb5_S_qy - platform_turn_xx * t121));
    RESULT(checked1, null_space, 12, t106 + (t107 + platform_turn_xx * limb5_S_null_space_wx_by_limb5_S_qx));
    /* limb4: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6),
      t159 = minus_limb4_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qy + limb4_U_0_sin * t121,
      limb4_lower_cos = SINES(cosine, 7), limb4_S_arm_y = param_R * limb4_lower_cos;
    RESULT(checked2, null_space, 26, limb4_S_arm_y * t159);
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11), minus_limb4_lower_sin = SINES(sine, 7),
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin, t160 = limb4_S_arm_x * t159,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    checked3 = checked3 + minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t92 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x, t98 = limb4_lower_cos * t92;
    RESULT(checked0, null_space, 25, -(t160 * t98));
    const REAL t155 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qy - minus_limb4_U_0_cos * t121);
    RESULT(checked1, null_space, 24, limb5_S_null_space_wy_by_limb5_S_qy + t92 * t155);
    /* limb3: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4),
      t148 = limb3_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qy,
      t150 = t148 + limb3_U_0_cos * limb5_S_null_space_wy_by_limb5_S_qy, limb3_lower_cos = SINES(cosine, 5),
      limb3_S_arm_y = param_R * limb3_lower_cos;
    RESULT(checked2, null_space, 23, -(limb3_S_arm_y * t150));
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin, t151 = limb3_S_arm_x * t150,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    checked3 = checked3 + minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t79 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz,
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x, t85 = limb3_lower_cos * t79;
    RESULT(checked0, null_space, 22, t151 * t85);
    const REAL t143 = limb3_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qy,
      t147 = t79 * (limb3_upper_position_x * (t143 - limb3_U_0_sin * limb5_S_null_space_wy_by_limb5_S_qy));
    RESULT(checked1, null_space, 21, -(t121 + t147));
    /* limb2: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2),
      t141 = minus_limb2_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qy + limb2_U_0_sin * t121,
      limb2_lower_cos = SINES(cosine, 3), minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    RESULT(checked2, null_space, 20, -(minus_limb2_S_arm_y * t141));
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5), limb2_lower_sin = SINES(sine, 3),
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin, t142 = limb2_S_arm_x * t141,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    checked3 = checked3 + minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t66 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x, t72 = limb2_lower_cos * t66;
    RESULT(checked0, null_space, 19, -(t142 * t72));
    const REAL t137 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qy - minus_limb2_U_0_cos * t121);
    RESULT(checked1, null_space, 18, limb5_S_null_space_wy_by_limb5_S_qy - t66 * t137);
    /* limb1: rates that follow; reciprocal wrenches, eq. (10) */
    const REAL t130 = limb1_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qy,
      t125 = limb1_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qy,
      t132 = t130 + limb1_U_0_cos * limb5_S_null_space_wy_by_limb5_S_qy,
      t129 = t26 * (minus_limb1_upper_position_x * (t125 - limb1_U_0_sin * limb5_S_null_space_wy_by_limb5_S_qy));
    RESULT(checked2, null_space, 15, t129 - t121);
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    RESULT(checked3, null_space, 17, minus_limb1_U2_arm_y * t132);
    RESULT(checked0, null_space, 16, t38 * (limb1_U2_arm_x * t132));
    const REAL t100 = minus_limb4_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qx, /* limb4 */
      t102 = t100 - limb4_U_0_sin * limb5_S_null_space_wx_by_limb5_S_qx; /* limb4 */
    RESULT(checked1, null_space, 11, limb4_S_arm_y * t102);
    RESULT(checked2, null_space, 10, -(t98 * (limb4_S_arm_x * t102)));
    const REAL t93 = limb4_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qx, /* limb4 */
      t97 = t92 * (limb4_upper_position_y * (t93 + minus_limb4_U_0_cos * limb5_S_null_space_wx_by_limb5_S_qx)); /* limb4 */
    RESULT(checked3, null_space, 9, limb5_S_null_space_wy_by_limb5_S_qx + t97);
    const REAL t87 = limb3_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qx, /* limb3 */
      t89 = t87 + limb3_U_0_cos * limb5_S_null_space_wy_by_limb5_S_qx; /* limb3 */
    RESULT(checked0, null_space, 8, -(limb3_S_arm_y * t89));
    RESULT(checked1, null_space, 7, t85 * (limb3_S_arm_x * t89));
    const REAL t80 = limb3_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qx; /* limb3 */
    RESULT(checked2, null_space, 6, limb5_S_null_space_wx_by_limb5_S_qx - t79 * (limb3_upper_position_x * (t80 - limb3_U_0_sin * limb5_S_null_space_wy_by_limb5_S_qx)));
    const REAL t74 = minus_limb2_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qx, /* limb2 */
      t76 = t74 - limb2_U_0_sin * limb5_S_null_space_wx_by_limb5_S_qx; /* limb2 */
    RESULT(checked3, null_space, 5, -(minus_limb2_S_arm_y * t76));
    RESULT(checked0, null_space, 4, -(t72 * (limb2_S_arm_x * t76)));
    const REAL t67 = limb2_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qx, /* limb2 */
      t70 = minus_limb2_upper_position_y * (t67 + minus_limb2_U_0_cos * limb5_S_null_space_wx_by_limb5_S_qx); /* limb2 */
    RESULT(checked1, null_space, 3, limb5_S_null_space_wy_by_limb5_S_qx - t66 * t70);
    const REAL t61 = limb1_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qx,
      t56 = limb1_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qx,
      t63 = t61 + limb1_U_0_cos * limb5_S_null_space_wy_by_limb5_S_qx;
    RESULT(checked2, null_space, 2, minus_limb1_U2_arm_y * t63);
    RESULT(checked3, null_space, 1, t38 * (limb1_U2_arm_x * t63));
    const REAL t60 = t26 * (minus_limb1_upper_position_x * (t56 - limb1_U_0_sin * limb5_S_null_space_wy_by_limb5_S_qx));
    RESULT(checked0, null_space, 0, limb5_S_null_space_wx_by_limb5_S_qx + t60);
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(a_pivot_2, 1.0e-09), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_acceleration)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict y_ddot, double *restrict a, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    /* limb5_S: accelerations */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6;
    /* limb5_S: geometry; accelerations; velocities, eq. (6) */
    const REAL t15 = t2 + t5, t65 = t2 + t4, t14 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t14 * t15,
      platform_turn_zz = 1.0 - t14 * t65, platform_turn_xx = 1.0 - t6 * t14, t9 = k2 - 0.5 * t7,
      t30 = limb5_S_q_qy * t14, t31 = limb5_S_q_qx * t30, t60 = limb5_S_q_qw * t30, t18 = limb5_S_q_qz * t14,
      t21 = limb5_S_q_qw * (limb5_S_q_qx * t14), t32 = limb5_S_q_qw * t18, platform_turn_yx = t31 + t32,
      platform_turn_xy = t31 - t32, limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13),
      t53 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx, t19 = limb5_S_q_qy * t18,
      t59 = limb5_S_q_qx * t18, platform_turn_yz = t19 - t21, platform_turn_zy = t19 + t21,
      limb5_S_v_wz = READ(v, 14), platform_twist_wy = t53 + limb5_S_v_wz * platform_turn_yz,
      limb1_U_0_sin = SINES(sine, 0), t104 = limb1_U_0_sin * platform_twist_wy, platform_turn_zx = t59 - t60,
      platform_turn_xz = t59 + t60, t70 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t70;
    /* limb1: geometry; loop closure; accelerations */
    const REAL limb1_U_0_cos = SINES(cosine, 0), t106 = t104 - limb1_U_0_cos * platform_twist_wz, /* limb5_S */
      limb1_lower_sin = SINES(sine, 1), t117 = limb1_lower_sin * t106,
      t58 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy, /* platform */
      platform_twist_wx = t58 + limb5_S_v_wz * platform_turn_xz, limb1_lower_cos = SINES(cosine, 1),
      limb1_U_v_0 = READ(v, 0), t119 = t117 + limb1_lower_cos * platform_twist_wx,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    /* limb1: loop closure; accelerations; reciprocal wrenches, eq. (10) */
    const REAL t120 = limb1_lower_omega_y - t119, limb1_U_v_1 = READ(v, 1), t121 = limb1_U_v_1 * t120,
      t95 = limb1_U_0_cos * platform_twist_wy + limb1_U_0_sin * platform_twist_wz, /* limb5_S */
      t115 = limb1_U_v_1 - t95, t123 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t115 - t121),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t124 = limb1_U2_constraint_mn_couple_x * t123, limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin,
      t125 = limb1_lower_omega_x * t120,
      t129 = limb1_lower_omega_x + (limb1_lower_cos * t106 - limb1_lower_sin * platform_twist_wx),
      t131 = t125 - limb1_lower_omega_y * t129,
      t28 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t134 = limb1_lower_sin * t28,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t28 - limb1_lower_sin * platform_turn_xy,
      t133 = t124 - limb1_U2_constraint_mn_couple_z * t131,
      limb1_U2_opening_mn = t134 + limb1_lower_cos * platform_turn_xy,
      t139 = t129 * (limb1_U2_opening_mn * t129 + limb1_U2_constraint_mn_couple_z * t120),
      limb1_U2_opening_bias_mn = t133 - (t139 - t115 * (limb1_U2_constraint_mn_couple_x * t120 - limb1_U2_opening_mn * t115)),
      t145 = limb1_U_v_0 * t106, /* limb5_S */
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin, limb1_P_v = READ(v, 2),
      t148 = limb1_U2_arm_x * t145 + limb1_U_v_1 * limb1_P_v, /* limb5_S */
      t107 = limb1_U_v_1 * limb1_lower_cos, t152 = t148 - t95 * (limb1_P_v - param_R * t107), /* limb5_S */
      t108 = limb1_upper_offset_x * t107,
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t23 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t35 = limb1_lower_cos * t23,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t35,
      t154 = limb1_U2_opening_bias_mn - t152 * limb1_U_factor_1_by_3, /* limb5_S */
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      t96 = limb1_U_v_0 * t95, /* limb5_S */
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t97 = minus_limb1_upper_position_x * t96, /* limb5_S */
      t98 = limb1_U_v_1 * limb1_lower_sin, t204 = t95 * (param_R * t98),
      t101 = limb1_upper_offset_x * t98 - limb1_P_v * limb1_lower_cos;
    /* limb5_S: accelerations; pivots; rates that follow */
    const REAL t112 = platform_twist_wx * t101,
      t111 = t97 - limb1_U_v_0 * t101 - t106 * (limb1_P_v * limb1_lower_sin + t108), t113 = t111 + t112,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t23,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      t155 = minus_limb1_U_factor_0_by_3 * t113 - t154,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn - minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3,
      t40 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3, /* limb1 */
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL t38 = 1.0 / minus_limb5_S_pivot_wz, minus_limb5_S_joint_acc_still_wz = t38 * t155,
      t41 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t40, /* limb1 */
      t11 = limb5_S_q_qx * t9, t157 = 0.5 * (t11 * minus_limb5_S_joint_acc_still_wz), t45 = limb5_S_q_qz * t9,
      t76 = platform_twist_wy * t45, t46 = limb5_S_q_qy * t9, t10 = limb5_S_q_qw * t9,
      t81 = platform_twist_wz * (0.5 * (platform_twist_wx * t10 + (t76 - platform_twist_wz * t46))),
      t87 = 0.5 * (platform_twist_wz * t10 + (platform_twist_wx * t46 - platform_twist_wy * t11)),
      t89 = t81 - platform_twist_wx * t87, t161 = platform_twist_wy * t87,
      t73 = 0.5 * (platform_twist_wx * t11 + platform_twist_wy * t46 + platform_twist_wz * t45),
      t158 = READ(y_ddot, 1) + 0.5 * (platform_twist_wy * t73 - t89) + t157, t160 = platform_twist_wx * t73,
      limb5_S_null_space_wz_by_limb5_S_wy = t38 * t41,
      a_pivot = 0.5 * (t10 + t11 * limb5_S_null_space_wz_by_limb5_S_wy);
    REAL checked2 = a_pivot;
    const REAL t44 = 1.0 / a_pivot, t50 = t44 * (0.5 * (t45 - t46 * limb5_S_null_space_wz_by_limb5_S_wy)),
      t174 = 0.5 * (t46 * minus_limb5_S_joint_acc_still_wz), t159 = t50 * t158,
      t165 = platform_twist_wz * t11 - platform_twist_wx * t45, t178 = 0.5 * t45, t179 = t178 * t50,
      t170 = t160 - (t161 - platform_twist_wz * (0.5 * (platform_twist_wy * t10 + t165))),
      t176 = t159 - (READ(y_ddot, 0) + 0.5 * t170 - t174), a_pivot_2 = 0.5 * t10 + t179;
    REAL checked3 = a_pivot_2;
    const REAL minus_limb5_S_joint_acc_wx = t176 / a_pivot_2,
      limb5_S_joint_acc_wy = t44 * (t158 - t178 * minus_limb5_S_joint_acc_wx);
    /* limb1: accelerations; reciprocal wrenches, eq. (10) */
    const REAL t183 = t38 * (t41 * limb5_S_joint_acc_wy),
      t377 = platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx, /* limb5_S */
      t381 = platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx, /* limb5_S */
      t385 = platform_turn_yz * limb5_S_joint_acc_wy - platform_turn_xz * minus_limb5_S_joint_acc_wx, /* limb5_S */
      t188 = t23 * (minus_limb1_upper_position_x * (limb1_U_0_cos * t183 - limb1_U_0_sin * limb5_S_joint_acc_wy)),
      t189 = minus_limb5_S_joint_acc_wx - t188,
      minus_limb1_U_joint_acc_still_0 = t23 * (t113 + minus_limb1_upper_position_x * (limb1_U_0_cos * minus_limb5_S_joint_acc_still_wz));
    RESULT(checked0, a, 0, -(t189 + minus_limb1_U_joint_acc_still_0));
    const REAL t195 = limb1_U_0_sin * t183 + limb1_U_0_cos * limb5_S_joint_acc_wy, t196 = limb1_U2_arm_x * t195,
      t197 = limb1_U_0_sin * minus_limb5_S_joint_acc_still_wz;
    RESULT(checked1, a, 1, t35 * (t196 - (t152 + limb1_U2_arm_x * t197)));
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    RESULT(checked2, a, 2, minus_limb1_U2_arm_y * t195 - (minus_limb1_U2_arm_y * t145 + t204 + minus_limb1_U2_arm_y * t197));
    /* limb2: geometry; accelerations */
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2),
      t211 = limb2_U_0_sin * t183 - minus_limb2_U_0_cos * minus_limb5_S_joint_acc_wx,
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5), limb2_lower_sin = SINES(sine, 3),
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      limb2_lower_cos = SINES(cosine, 3);
    /* limb2: accelerations; reciprocal wrenches, eq. (10) */
    const REAL t212 = minus_limb2_upper_position_y * t211,
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x;
    checked3 = checked3 + minus_limb2_U_0_lever_mz_by_limb2_S_fz;
    const REAL t208 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz, t214 = limb5_S_joint_acc_wy - t208 * t212,
      t237 = minus_limb2_upper_position_y * (limb2_U_0_sin * minus_limb5_S_joint_acc_still_wz),
      t217 = minus_limb2_U_0_cos * platform_twist_wz - limb2_U_0_sin * platform_twist_wx, limb2_U_v_0 = READ(v, 3),
      limb2_U_v_1 = READ(v, 4), t219 = minus_limb2_upper_position_y * (limb2_U_v_0 * t217),
      t220 = limb2_U_v_1 * limb2_lower_sin, limb2_P_v = READ(v, 5), t260 = t217 * (param_R * t220),
      t223 = limb2_upper_offset_x * t220 - limb2_P_v * limb2_lower_cos, t225 = t219 + limb2_U_v_0 * t223,
      t234 = platform_twist_wy * t223,
      t228 = limb2_U_0_sin * platform_twist_wz + minus_limb2_U_0_cos * platform_twist_wx,
      t229 = limb2_U_v_1 * limb2_lower_cos, t251 = t217 * (limb2_P_v - param_R * t229),
      t235 = t225 + t228 * (limb2_P_v * limb2_lower_sin + limb2_upper_offset_x * t229) - t234;
    RESULT(checked0, a, 3, t214 + t208 * (t235 + t237));
    const REAL t245 = limb2_U_v_0 * t228, t239 = limb2_lower_cos * t208,
      t243 = minus_limb2_U_0_cos * t183 + limb2_U_0_sin * minus_limb5_S_joint_acc_wx,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin, t244 = limb2_S_arm_x * t243,
      t253 = minus_limb2_U_0_cos * minus_limb5_S_joint_acc_still_wz,
      t255 = limb2_S_arm_x * t245 + limb2_U_v_1 * limb2_P_v + t251 - limb2_S_arm_x * t253;
    RESULT(checked1, a, 4, -(t239 * (t244 + t255)));
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos,
      minus_limb2_P_joint_acc = minus_limb2_S_arm_y * t243 + (minus_limb2_S_arm_y * t245 - t260 - minus_limb2_S_arm_y * t253);
    RESULT(checked2, a, 5, -minus_limb2_P_joint_acc);
    /* limb3: geometry; accelerations */
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_0_sin = SINES(sine, 4),
      t291 = limb3_U_0_cos * t183 - limb3_U_0_sin * limb5_S_joint_acc_wy,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x,
      limb3_lower_cos = SINES(cosine, 5);
    /* limb3: accelerations; reciprocal wrenches, eq. (10) */
    const REAL t292 = limb3_upper_position_x * t291,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    checked3 = checked3 + minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t264 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz, t294 = minus_limb5_S_joint_acc_wx + t264 * t292,
      t287 = limb3_upper_position_x * (limb3_U_0_cos * minus_limb5_S_joint_acc_still_wz),
      t267 = limb3_U_0_cos * platform_twist_wy + limb3_U_0_sin * platform_twist_wz, limb3_U_v_0 = READ(v, 6),
      limb3_U_v_1 = READ(v, 7), t269 = limb3_upper_position_x * (limb3_U_v_0 * t267),
      t270 = limb3_U_v_1 * minus_limb3_lower_sin, limb3_P_v = READ(v, 8), t315 = t267 * (param_R * t270),
      t273 = limb3_upper_offset_x * t270 + limb3_P_v * limb3_lower_cos, t275 = t269 - limb3_U_v_0 * t273,
      t284 = platform_twist_wx * t273, t278 = limb3_U_0_sin * platform_twist_wy - limb3_U_0_cos * platform_twist_wz,
      t279 = limb3_U_v_1 * limb3_lower_cos, t307 = t267 * (limb3_P_v + param_R * t279),
      t285 = t275 - t278 * (limb3_P_v * minus_limb3_lower_sin - limb3_upper_offset_x * t279) + t284;
    RESULT(checked0, a, 6, t264 * (t285 + t287) - t294);
    const REAL t301 = limb3_U_v_0 * t278, t295 = limb3_lower_cos * t264,
      t299 = limb3_U_0_sin * t183 + limb3_U_0_cos * limb5_S_joint_acc_wy,
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin, t300 = limb3_S_arm_x * t299,
      t309 = limb3_U_0_sin * minus_limb5_S_joint_acc_still_wz,
      t311 = limb3_S_arm_x * t301 + limb3_U_v_1 * limb3_P_v - t307 + limb3_S_arm_x * t309;
    RESULT(checked1, a, 7, t295 * (t300 - t311));
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    RESULT(checked2, a, 8, limb3_S_arm_y * t301 - t315 + limb3_S_arm_y * t309 - limb3_S_arm_y * t299);
    /* limb4: geometry; accelerations */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6),
      t323 = limb4_U_0_sin * t183 - minus_limb4_U_0_cos * minus_limb5_S_joint_acc_wx,
      t354 = limb4_U_0_sin * minus_limb5_S_joint_acc_wx, limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      minus_limb4_lower_sin = SINES(sine, 7),
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      limb4_lower_cos = SINES(cosine, 7);
    /* limb4: accelerations; reciprocal wrenches, eq. (10) */
    const REAL t324 = limb4_upper_position_y * t323,
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x;
    checked3 = checked3 + minus_limb4_U_0_lever_mz_by_limb4_S_fz;
    const REAL t320 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz, t326 = limb5_S_joint_acc_wy + t320 * t324,
      t349 = limb4_upper_position_y * (limb4_U_0_sin * minus_limb5_S_joint_acc_still_wz),
      t338 = limb4_U_0_sin * platform_twist_wz,
      t329 = minus_limb4_U_0_cos * platform_twist_wz - limb4_U_0_sin * platform_twist_wx,
      t340 = t338 + minus_limb4_U_0_cos * platform_twist_wx, limb4_U_v_0 = READ(v, 9), limb4_U_v_1 = READ(v, 10),
      t331 = limb4_upper_position_y * (limb4_U_v_0 * t329), t332 = limb4_U_v_1 * minus_limb4_lower_sin,
      limb4_P_v = READ(v, 11), t372 = t329 * (param_R * t332),
      t335 = limb4_upper_offset_x * t332 + limb4_P_v * limb4_lower_cos, t346 = platform_twist_wy * t335,
      t337 = t331 + limb4_U_v_0 * t335, t341 = limb4_U_v_1 * limb4_lower_cos,
      t363 = t329 * (limb4_P_v + param_R * t341),
      t347 = t337 + t340 * (limb4_P_v * minus_limb4_lower_sin - limb4_upper_offset_x * t341) - t346;
    RESULT(checked0, a, 9, t326 - t320 * (t347 + t349));
    const REAL t357 = limb4_U_v_0 * t340, t351 = limb4_lower_cos * t320, t355 = minus_limb4_U_0_cos * t183 + t354,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz - t183,
      t365 = minus_limb4_U_0_cos * minus_limb5_S_joint_acc_still_wz;
    RESULT(checked1, a, 12, t377 - platform_turn_zx * minus_limb5_S_joint_acc_wz);
    RESULT(checked2, a, 13, t381 - platform_turn_zy * minus_limb5_S_joint_acc_wz);
    RESULT(checked3, a, 14, t385 - platform_turn_zz * minus_limb5_S_joint_acc_wz);
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin, t356 = limb4_S_arm_x * t355,
      t367 = limb4_S_arm_x * t357 + limb4_U_v_1 * limb4_P_v + t363 - limb4_S_arm_x * t365;
    RESULT(checked0, a, 10, -(t351 * (t356 + t367)));
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    RESULT(checked1, a, 11, limb4_S_arm_y * t355 + (limb4_S_arm_y * t357 + t372 - limb4_S_arm_y * t365));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(a_pivot_2, 1.0e-09), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_close_position)(size_t stride, const double *restrict q, double *restrict q_next,
    double *restrict residual_, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t3 = limb5_S_q_qw * limb5_S_q_qw,
      t4 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t5 = t3 + t4, t6 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t7 = limb5_S_q_qz * limb5_S_q_qz, t8 = t6 + t7, t9 = t5 + t8, t11 = 4.0 - 2.0 * t9,
      t51 = 0.5 * (1.0 - t8 * t11), t31 = t4 + t7, t28 = param_H * (1.0 - t11 * (t4 + t6)),
      platform_turn_yy = 1.0 - t11 * t31, t14 = limb5_S_q_qz * t11, t23 = limb5_S_q_qx * t14,
      t12 = limb5_S_q_qy * t11, t19 = limb5_S_q_qw * (limb5_S_q_qx * t11), t24 = limb5_S_q_qw * t12,
      t13 = limb5_S_q_qx * t12, platform_turn_zx = t23 - t24, t52 = param_H * (t23 + t24),
      t25 = 0.5 * platform_turn_zx;
    /* limb1: geometry; loop closure */
    const REAL limb1_P_q = READ(q, 2), minus_limb1_upper_position_x_2 = t51 - t52,
      limb3_upper_position_x_2 = t51 + t52, limb1_upper_offset_x = limb_upper_phase + limb1_P_q,
      limb1_lower_sin = SINES(sine, 1),
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t53 = minus_limb1_upper_position_x - minus_limb1_upper_position_x_2, limb1_lower_cos = SINES(cosine, 1),
      t236 = limb1_lower_sin * t53, t54 = limb1_lower_cos * t53;
    /* platform: geometry */
    const REAL t15 = limb5_S_q_qw * t14, t17 = limb5_S_q_qy * t14, platform_turn_yx = t13 + t15,
      platform_turn_xy = t13 - t15, t16 = 0.5 * platform_turn_yx, platform_turn_yz = t17 - t19,
      platform_turn_zy = t17 + t19, t20 = param_H * platform_turn_yz;
    /* limb1: geometry; loop closure; results */
    const REAL limb1_U_0_sin = SINES(sine, 0), minus_limb1_lower_limb_target_x = t16 - t20,
      limb3_lower_limb_target_x = t16 + t20, minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos,
      t21 = limb1_upper_offset_x * minus_limb1_lower_rotation_yx - minus_limb1_lower_limb_target_x,
      limb1_U_0_cos = SINES(cosine, 0), t238 = t236 - minus_limb1_lower_rotation_yx * t21,
      minus_limb1_lower_limb_target_y = t25 - t28, limb3_lower_limb_target_y = t25 + t28,
      limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos,
      t29 = limb1_upper_offset_x * limb1_lower_rotation_zx + minus_limb1_lower_limb_target_y,
      minus_limb1_U2_opening_fx = t238 - limb1_lower_rotation_zx * t29, t372 = per_length * minus_limb1_U2_opening_fx,
      t373 = t372 * t372, t22 = limb1_U_0_cos * t21,
      minus_limb1_U2_opening_fy = t54 + limb1_U_0_sin * limb1_lower_sin * t21 + limb1_U_0_cos * limb1_lower_sin * t29,
      minus_limb1_U2_opening_fz = t22 - limb1_U_0_sin * t29, t374 = per_length * minus_limb1_U2_opening_fy,
      t376 = t373 + t374 * t374, t377 = per_length * minus_limb1_U2_opening_fz, t379 = t376 + t377 * t377,
      t39 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t40 = limb1_lower_cos * t39,
      limb1_U2_opening_mn = limb1_lower_sin * t39 + limb1_lower_cos * platform_turn_xy,
      t381 = t379 + limb1_U2_opening_mn * limb1_U2_opening_mn, t131 = 0.5 * platform_turn_xy, /* platform */
      limb1_U2_constraint_mn_couple_z = t40 - limb1_lower_sin * platform_turn_xy;
    /* limb2: geometry; loop closure; results */
    const REAL limb2_P_q = READ(q, 5), limb2_lower_limb_target_y = t52 - t131, limb4_lower_limb_target_y = t52 + t131,
      limb2_upper_offset_x = limb_upper_phase + limb2_P_q, minus_limb2_U_0_cos = SINES(sine, 2),
      limb2_lower_cos = SINES(cosine, 3), minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos,
      t160 = limb2_upper_offset_x * minus_limb2_lower_rotation_xx + limb2_lower_limb_target_y,
      t161 = minus_limb2_lower_rotation_xx * t160, t134 = 0.5 * platform_turn_yy, /* platform */
      limb2_lower_sin = SINES(sine, 3), t33 = limb1_U_0_cos * platform_turn_yy, /* limb1 */
      limb2_upper_position_y = t20 - t134, limb4_upper_position_y_2 = t20 + t134,
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      t162 = minus_limb2_upper_position_y + limb2_upper_position_y, t164 = t161 - limb2_lower_sin * t162,
      t172 = limb2_lower_cos * t162, t138 = 0.5 * platform_turn_zy, /* platform */
      limb1_U2_constraint_mn_couple_x = t33 + limb1_U_0_sin * platform_turn_zy, limb2_U_0_sin = SINES(cosine, 2),
      limb2_lower_limb_target_x = t28 - t138, limb4_lower_limb_target_x = t28 + t138,
      minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos,
      t165 = limb2_upper_offset_x * minus_limb2_lower_rotation_zx + limb2_lower_limb_target_x,
      limb2_S_opening_fx = t164 + minus_limb2_lower_rotation_zx * t165, t382 = per_length * limb2_S_opening_fx,
      t384 = t381 + t382 * t382, /* residual */
      t179 = limb2_U_0_sin * t160,
      minus_limb2_S_opening_fy = minus_limb2_U_0_cos * limb2_lower_sin * t160 + t172 + limb2_U_0_sin * limb2_lower_sin * t165,
      minus_limb2_S_opening_fz = t179 - minus_limb2_U_0_cos * t165, t385 = per_length * minus_limb2_S_opening_fy,
      t387 = t384 + t385 * t385, /* residual */
      t388 = per_length * minus_limb2_S_opening_fz;
    /* limb3: geometry; loop closure */
    const REAL limb3_P_q = READ(q, 8), t390 = t387 + t388 * t388, /* residual */
      limb3_upper_offset_x = limb_upper_phase + limb3_P_q, minus_limb3_lower_sin = SINES(sine, 5),
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x,
      t209 = limb3_upper_position_x - limb3_upper_position_x_2, limb3_lower_cos = SINES(cosine, 5),
      limb3_U_0_sin = SINES(sine, 4), t210 = minus_limb3_lower_sin * t209, t221 = limb3_lower_cos * t209,
      minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    /* limb3: loop closure; geometry; results */
    const REAL t189 = limb3_upper_offset_x * minus_limb3_lower_rotation_yx + limb3_lower_limb_target_x,
      limb3_U_0_cos = SINES(cosine, 4), t212 = t210 - minus_limb3_lower_rotation_yx * t189,
      limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos,
      t191 = limb3_upper_offset_x * limb3_lower_rotation_zx - limb3_lower_limb_target_y,
      minus_limb3_S_opening_fx = t212 - limb3_lower_rotation_zx * t191, t391 = per_length * minus_limb3_S_opening_fx,
      t393 = t390 + t391 * t391, /* residual */
      t223 = t221 + limb3_U_0_sin * minus_limb3_lower_sin * t189, t190 = limb3_U_0_cos * t189,
      limb3_S_opening_fy = t223 + limb3_U_0_cos * minus_limb3_lower_sin * t191,
      minus_limb3_S_opening_fz = t190 - limb3_U_0_sin * t191, t394 = per_length * limb3_S_opening_fy,
      t396 = t393 + t394 * t394, /* residual */
      t397 = per_length * minus_limb3_S_opening_fz;
    /* limb4: geometry; loop closure */
    const REAL limb4_P_q = READ(q, 11), t399 = t396 + t397 * t397, /* residual */
      limb4_upper_offset_x = limb_upper_phase + limb4_P_q, minus_limb4_U_0_cos = SINES(sine, 6),
      limb4_lower_cos = SINES(cosine, 7), minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos,
      t132 = limb4_upper_offset_x * minus_limb4_lower_rotation_xx + limb4_lower_limb_target_y,
      minus_limb4_lower_sin = SINES(sine, 7), t133 = minus_limb4_lower_rotation_xx * t132,
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    /* limb4: loop closure; geometry; results */
    const REAL t135 = limb4_upper_position_y - limb4_upper_position_y_2, limb4_U_0_sin = SINES(cosine, 6),
      t137 = t133 - minus_limb4_lower_sin * t135, t146 = limb4_lower_cos * t135,
      minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos,
      t139 = limb4_upper_offset_x * minus_limb4_lower_rotation_zx + limb4_lower_limb_target_x,
      limb4_S_opening_fx = t137 + minus_limb4_lower_rotation_zx * t139, t400 = per_length * limb4_S_opening_fx,
      t402 = t399 + t400 * t400, /* residual */
      t147 = minus_limb4_U_0_cos * minus_limb4_lower_sin * t132 + t146, t153 = limb4_U_0_sin * t132,
      limb4_S_opening_fy = t147 + limb4_U_0_sin * minus_limb4_lower_sin * t139,
      minus_limb4_S_opening_fz = t153 - minus_limb4_U_0_cos * t139, t403 = per_length * limb4_S_opening_fy,
      t405 = t402 + t403 * t403, /* residual */
      t406 = per_length * minus_limb4_S_opening_fz, residual_residual = SQRT(t405 + t406 * t406);
    WRITE(residual_, 0, residual_residual);
    REAL checked0 = residual_residual;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; results */
    const REAL minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked1 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz;
    const REAL t2 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t43 = limb1_lower_cos * t2,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t43,
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      t59 = limb1_U2_opening_mn + minus_limb1_U2_opening_fy * limb1_U_factor_1_by_3,
      t45 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t95 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t2,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn - minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3,
      t60 = minus_limb1_U2_opening_fz * minus_limb1_U_factor_0_by_3 - t59,
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t45;
    REAL checked2 = minus_limb5_S_pivot_wz;
    const REAL t46 = 1.0 / minus_limb5_S_pivot_wz, /* limb5_S */
      limb5_S_null_space_wz_by_limb5_S_wy = t46 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t95),
      t61 = t46 * t60, t234 = limb1_U_0_cos + limb1_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy,
      limb1_U_null_space_1_by_limb5_S_wy = t43 * (limb1_U2_arm_x * t234),
      t275 = limb1_U_null_space_1_by_limb5_S_wy * limb1_U_null_space_1_by_limb5_S_wy,
      t111 = minus_limb1_upper_position_x * (limb1_U_0_sin - limb1_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy),
      minus_limb1_U_null_space_0_by_limb5_S_wy = t2 * t111,
      t277 = t275 + minus_limb1_U_null_space_0_by_limb5_S_wy * minus_limb1_U_null_space_0_by_limb5_S_wy,
      minus_limb1_U2_arm_y = param_R * limb1_lower_cos,
      limb1_P_null_space_by_limb5_S_wy = minus_limb1_U2_arm_y * t234,
      t235 = 2.2795812745707664 * limb1_P_null_space_by_limb5_S_wy,
      t278 = limb1_P_null_space_by_limb5_S_wy * t235 + t277;
    /* limb2: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t106 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy),
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x,
      t107 = minus_limb2_U_0_lever_mz_by_limb2_S_fz - t106, t79 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz,
      limb2_U_null_space_0_by_limb5_S_wy = t79 * t107,
      t279 = limb2_U_null_space_0_by_limb5_S_wy * limb2_U_null_space_0_by_limb5_S_wy + t278, /* mechanism */
      t100 = minus_limb2_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin, t103 = limb2_S_arm_x * t100,
      t85 = limb2_lower_cos * t79, minus_limb2_U_null_space_1_by_limb5_S_wy = t85 * t103,
      t280 = minus_limb2_U_null_space_1_by_limb5_S_wy * minus_limb2_U_null_space_1_by_limb5_S_wy + t279, /* mechanism */
      minus_limb2_S_arm_y = param_R * limb2_lower_cos,
      minus_limb2_P_null_space_by_limb5_S_wy = minus_limb2_S_arm_y * t100,
      t101 = 2.2795812745707664 * minus_limb2_P_null_space_by_limb5_S_wy,
      t281 = minus_limb2_P_null_space_by_limb5_S_wy * t101 + t280; /* mechanism */
    /* limb3: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t119 = limb3_upper_position_x * (limb3_U_0_sin - limb3_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy),
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked3 = minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t116 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz, limb3_U_null_space_0_by_limb5_S_wy = t116 * t119,
      t282 = limb3_U_null_space_0_by_limb5_S_wy * limb3_U_null_space_0_by_limb5_S_wy + t281, /* mechanism */
      t207 = limb3_U_0_cos + limb3_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy,
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin, t219 = limb3_S_arm_x * t207,
      t220 = limb3_lower_cos * t116, limb3_U_null_space_1_by_limb5_S_wy = t219 * t220,
      t283 = limb3_U_null_space_1_by_limb5_S_wy * limb3_U_null_space_1_by_limb5_S_wy + t282, /* mechanism */
      limb3_S_arm_y = param_R * limb3_lower_cos, minus_limb3_P_null_space_by_limb5_S_wy = limb3_S_arm_y * t207,
      t208 = 2.2795812745707664 * minus_limb3_P_null_space_by_limb5_S_wy,
      t284 = minus_limb3_P_null_space_by_limb5_S_wy * t208 + t283; /* mechanism */
    /* limb4: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t122 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy),
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x,
      t123 = minus_limb4_U_0_lever_mz_by_limb4_S_fz + t122, t71 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz,
      limb4_U_null_space_0_by_limb5_S_wy = t71 * t123,
      t285 = limb4_U_null_space_0_by_limb5_S_wy * limb4_U_null_space_0_by_limb5_S_wy + t284, /* mechanism */
      t97 = minus_limb4_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy,
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin, t126 = limb4_S_arm_x * t97,
      t72 = limb4_lower_cos * t71, minus_limb4_U_null_space_1_by_limb5_S_wy = t72 * t126,
      t286 = minus_limb4_U_null_space_1_by_limb5_S_wy * minus_limb4_U_null_space_1_by_limb5_S_wy + t285, /* mechanism */
      limb4_S_arm_y = param_R * limb4_lower_cos, limb4_P_null_space_by_limb5_S_wy = limb4_S_arm_y * t97,
      t98 = 2.2795812745707664 * limb4_P_null_space_by_limb5_S_wy,
      t288 = 1.0 + (limb4_P_null_space_by_limb5_S_wy * t98 + t286), /* mechanism */
      t289 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_null_space_wz_by_limb5_S_wy + t288, /* mechanism */
      minus_limb2_U_null_space_0_by_limb5_S_wx = t79 * (minus_limb2_U_0_cos * minus_limb2_upper_position_y),
      t112 = minus_limb2_U_null_space_0_by_limb5_S_wx * limb2_U_null_space_0_by_limb5_S_wy + minus_limb1_U_null_space_0_by_limb5_S_wy, /* limb1 */
      limb2_U_null_space_1_by_limb5_S_wx = limb2_U_0_sin * limb2_S_arm_x * t85,
      t113 = limb2_U_null_space_1_by_limb5_S_wx * minus_limb2_U_null_space_1_by_limb5_S_wy + t112, /* limb1 */
      minus_platform_joint_force_mx_by_limb2_P = limb2_U_0_sin * minus_limb2_S_arm_y,
      t120 = minus_platform_joint_force_mx_by_limb2_P * t101 + t113 - limb3_U_null_space_0_by_limb5_S_wy, /* limb1 */
      limb4_U_null_space_0_by_limb5_S_wx = t71 * (minus_limb4_U_0_cos * limb4_upper_position_y),
      t125 = t120 - limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wy, /* limb1 */
      limb4_U_null_space_1_by_limb5_S_wx = limb4_U_0_sin * limb4_S_arm_x * t72,
      t128 = t125 + limb4_U_null_space_1_by_limb5_S_wx * minus_limb4_U_null_space_1_by_limb5_S_wy; /* limb1 */
    /* platform: balance, eqs. (40)-(47) */
    const REAL platform_joint_force_mx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y,
      t129 = platform_joint_force_mx_by_limb4_P * t98 + t128, /* limb1 */
      t82 = 1.0 + minus_limb2_U_null_space_0_by_limb5_S_wx * minus_limb2_U_null_space_0_by_limb5_S_wx, /* limb2 */
      t87 = t82 + limb2_U_null_space_1_by_limb5_S_wx * limb2_U_null_space_1_by_limb5_S_wx; /* limb2 */
    /* mechanism: pivots; results */
    const REAL t77 = 2.2795812745707664 * minus_platform_joint_force_mx_by_limb2_P,
      t89 = 1.0 + (minus_platform_joint_force_mx_by_limb2_P * t77 + t87),
      t90 = limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wx + t89,
      t91 = limb4_U_null_space_1_by_limb5_S_wx * limb4_U_null_space_1_by_limb5_S_wx + t90,
      t67 = 2.2795812745707664 * platform_joint_force_mx_by_limb4_P,
      pivot_0 = 1.0 + (platform_joint_force_mx_by_limb4_P * t67 + t91);
    checked0 = checked0 + pivot_0;
    const REAL t93 = 1.0 / pivot_0;
    /* limb1: results */
    const REAL t130 = t93 * t129, minus_pivot_1 = t129 * t130 - t289;
    checked1 = checked1 + minus_pivot_1;
    const REAL t240 = limb1_U_0_sin * t61, t247 = t43 * (minus_limb1_U2_opening_fy - limb1_U2_arm_x * t240),
      t242 = minus_limb1_U2_opening_fx - minus_limb1_U2_arm_y * t240, t243 = t235 * t242,
      t248 = limb1_U_null_space_1_by_limb5_S_wy * t247,
      t65 = t2 * (minus_limb1_U2_opening_fz + minus_limb1_upper_position_x * (limb1_U_0_cos * t61)),
      t251 = t243 + (t248 + minus_limb1_U_null_space_0_by_limb5_S_wy * t65),
      t184 = t79 * (minus_limb2_S_opening_fz - minus_limb2_upper_position_y * (limb2_U_0_sin * t61)),
      t252 = limb2_U_null_space_0_by_limb5_S_wy * t184 - t251, t167 = minus_limb2_U_0_cos * t61,
      t177 = t85 * (minus_limb2_S_opening_fy + limb2_S_arm_x * t167),
      t169 = limb2_S_opening_fx - minus_limb2_S_arm_y * t167, t170 = t77 * t169,
      t254 = t101 * t169 - (minus_limb2_U_null_space_1_by_limb5_S_wy * t177 + t252),
      t196 = t116 * (minus_limb3_S_opening_fz - limb3_upper_position_x * (limb3_U_0_cos * t61)),
      t255 = limb3_U_null_space_0_by_limb5_S_wy * t196 - t254, t214 = limb3_U_0_sin * t61,
      t227 = t220 * (limb3_S_opening_fy + limb3_S_arm_x * t214),
      t216 = minus_limb3_S_opening_fx + limb3_S_arm_y * t214,
      t257 = t208 * t216 + (limb3_U_null_space_1_by_limb5_S_wy * t227 + t255),
      t158 = t71 * (minus_limb4_S_opening_fz + limb4_upper_position_y * (limb4_U_0_sin * t61)),
      t258 = limb4_U_null_space_0_by_limb5_S_wy * t158 + t257, t141 = minus_limb4_U_0_cos * t61,
      t151 = t72 * (limb4_S_opening_fy - limb4_S_arm_x * t141), t143 = limb4_S_opening_fx + limb4_S_arm_y * t141,
      t144 = t67 * t143, t260 = t98 * t143 - (minus_limb4_U_null_space_1_by_limb5_S_wy * t151 - t258),
      t261 = limb5_S_null_space_wz_by_limb5_S_wy * t61 + t260,
      t186 = minus_limb2_U_null_space_0_by_limb5_S_wx * t184 - t65,
      t197 = t170 - (limb2_U_null_space_1_by_limb5_S_wx * t177 + t186) + t196,
      t199 = limb4_U_null_space_1_by_limb5_S_wx * t151 + (limb4_U_null_space_0_by_limb5_S_wx * t158 + t197),
      t200 = t144 - t199, t292 = t93 * t200, t290 = (t130 * t200 - t261) / minus_pivot_1, t293 = t130 * t290 - t292,
      t334 = 0.5 * (t61 - limb5_S_null_space_wz_by_limb5_S_wy * t290); /* limb5_S */
    RESULT(checked2, q_next, 11, limb4_P_q - (t143 - (limb4_P_null_space_by_limb5_S_wy * t290 - platform_joint_force_mx_by_limb4_P * t293)));
    const REAL t327 = t151 + (minus_limb4_U_null_space_1_by_limb5_S_wy * t290 - limb4_U_null_space_1_by_limb5_S_wx * t293); /* limb4 */
    RESULT(checked3, q_next, 10, READ(q, 10) - t327);
    const REAL t323 = t158 - (limb4_U_null_space_0_by_limb5_S_wy * t290 + limb4_U_null_space_0_by_limb5_S_wx * t293); /* limb4 */
    RESULT(checked0, q_next, 9, READ(q, 9) - t323);
    RESULT(checked1, q_next, 8, limb3_P_q + (t216 - minus_limb3_P_null_space_by_limb5_S_wy * t290));
    RESULT(checked2, q_next, 7, READ(q, 7) - (t227 - limb3_U_null_space_1_by_limb5_S_wy * t290));
    RESULT(checked3, q_next, 6, READ(q, 6) - (t196 - (t293 + limb3_U_null_space_0_by_limb5_S_wy * t290)));
    const REAL t311 = minus_limb2_P_null_space_by_limb5_S_wy * t290 - minus_platform_joint_force_mx_by_limb2_P * t293; /* limb2 */
    RESULT(checked0, q_next, 5, limb2_P_q - (t169 + t311));
    const REAL t308 = t177 - (minus_limb2_U_null_space_1_by_limb5_S_wy * t290 - limb2_U_null_space_1_by_limb5_S_wx * t293); /* limb2 */
    RESULT(checked1, q_next, 4, READ(q, 4) + t308);
    const REAL t304 = t184 - (limb2_U_null_space_0_by_limb5_S_wy * t290 - minus_limb2_U_null_space_0_by_limb5_S_wx * t293); /* limb2 */
    RESULT(checked2, q_next, 3, READ(q, 3) - t304);
    RESULT(checked3, q_next, 2, limb1_P_q + (t242 + limb1_P_null_space_by_limb5_S_wy * t290));
    RESULT(checked0, q_next, 1, READ(q, 1) + (t247 + limb1_U_null_space_1_by_limb5_S_wy * t290));
    const REAL t294 = minus_limb1_U_null_space_0_by_limb5_S_wy * t290, t336 = 0.5 * t290;
    RESULT(checked1, q_next, 0, READ(q, 0) - (t65 - (t293 - t294)));
    const REAL t338 = 0.5 * t293;
    /* limb5_S: results */
    const REAL t342 = limb5_S_q_qw + (limb5_S_q_qz * t334 - (limb5_S_q_qy * t336 + limb5_S_q_qx * t338)),
      t364 = t342 * t342, t362 = limb5_S_q_qy * t334 + limb5_S_q_qz * t336 + (limb5_S_q_qx + limb5_S_q_qw * t338),
      t365 = t362 * t362 + t364, t344 = limb5_S_q_qy * t338, t347 = limb5_S_q_qz - limb5_S_q_qw * t334,
      t355 = limb5_S_q_qz * t338 + limb5_S_q_qx * t334 - (limb5_S_q_qy + limb5_S_q_qw * t336),
      t348 = limb5_S_q_qx * t336 - t344 - t347, t369 = 1.0 / SQRT(t348 * t348 + (t355 * t355 + t365));
    RESULT(checked2, q_next, 13, t362 * t369);
    RESULT(checked3, q_next, 12, t342 * t369);
    RESULT(checked0, q_next, 15, -(t348 * t369));
    RESULT(checked1, q_next, 14, -(t355 * t369));
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
      t156 = limb2_U_v_0 * limb2_U_null_space_0_by_limb5_S_wy + t155, /* limb1 */
      t71 = minus_limb2_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy,
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin,
      minus_limb2_U_null_space_1_by_limb5_S_wy = t59 * (limb2_S_arm_x * t71),
      limb2_U_null_space_1_by_limb5_S_wx = limb2_U_0_sin * limb2_S_arm_x * t59, limb2_U_v_1 = READ(v, 4),
      t157 = limb2_U_v_1 * minus_limb2_U_null_space_1_by_limb5_S_wy - t156, /* limb1 */
      minus_limb2_S_arm_y = param_R * limb2_lower_cos,
      minus_limb2_P_null_space_by_limb5_S_wy = minus_limb2_S_arm_y * t71,
      minus_platform_joint_force_mx_by_limb2_P = limb2_U_0_sin * minus_limb2_S_arm_y,
      t72 = 2.2795812745707664 * minus_limb2_P_null_space_by_limb5_S_wy, limb2_P_v = READ(v, 5);
    /* limb3: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_0_sin = SINES(sine, 4),
      t158 = limb2_P_v * t72 + t157, /* limb1 */
      t86 = limb3_U_0_sin - limb3_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy,
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 5),
      limb3_lower_cos = SINES(cosine, 5), t87 = (param_R - minus_limb3_lower_sin * limb3_upper_offset_x) * t86,
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = minus_limb3_U_0_lever_mz_by_limb3_S_fz;
    const REAL t84 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz, limb3_U_null_space_0_by_limb5_S_wy = t84 * t87,
      limb3_U_v_0 = READ(v, 6), t141 = limb3_lower_cos * t84,
      t159 = limb3_U_v_0 * limb3_U_null_space_0_by_limb5_S_wy - t158, /* limb1 */
      t136 = limb3_U_0_cos + limb3_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy,
      limb3_U_null_space_1_by_limb5_S_wy = (limb3_upper_offset_x - param_R * minus_limb3_lower_sin) * t136 * t141,
      t160 = READ(v, 7) * limb3_U_null_space_1_by_limb5_S_wy + t159, /* limb1 */
      minus_limb3_P_null_space_by_limb5_S_wy = param_R * limb3_lower_cos * t136,
      t137 = 2.2795812745707664 * minus_limb3_P_null_space_by_limb5_S_wy;
    /* limb4: geometry; rates that follow */
    const REAL limb4_U_0_sin = SINES(cosine, 6), t161 = READ(v, 8) * t137 - t160, /* limb1 */
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
      t162 = limb4_U_v_0 * limb4_U_null_space_0_by_limb5_S_wy - t161, /* limb1 */
      t68 = minus_limb4_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy,
      limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      minus_limb4_U_null_space_1_by_limb5_S_wy = t46 * (limb4_S_arm_x * t68),
      limb4_U_null_space_1_by_limb5_S_wx = limb4_U_0_sin * limb4_S_arm_x * t46, limb4_U_v_1 = READ(v, 10),
      t163 = limb4_U_v_1 * minus_limb4_U_null_space_1_by_limb5_S_wy - t162, /* limb1 */
      limb4_S_arm_y = param_R * limb4_lower_cos, limb4_P_null_space_by_limb5_S_wy = limb4_S_arm_y * t68;
    /* limb5_S: balance, eqs. (40)-(47); velocities, eq. (6) */
    const REAL platform_joint_force_mx_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y,
      t69 = 2.2795812745707664 * limb4_P_null_space_by_limb5_S_wy, /* limb4 */
      limb4_P_v = READ(v, 11), limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14),
      t164 = limb4_P_v * t69 - t163, /* limb1 */
      t130 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx;
    /* limb1: results */
    const REAL t165 = t130 + limb5_S_v_wz * platform_turn_yz + t164, platform_turn_zx = t103 - t104,
      platform_turn_xz = t103 + t104,
      t126 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy, /* platform */
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
      t63 = 1.0 + (minus_platform_joint_force_mx_by_limb2_P * t51 + t61), t109 = limb2_P_v * t51, /* limb1 */
      t64 = limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wx + t63,
      t65 = limb4_U_null_space_1_by_limb5_S_wx * limb4_U_null_space_1_by_limb5_S_wx + t64,
      t41 = 2.2795812745707664 * platform_joint_force_mx_by_limb4_P,
      pivot_0 = 1.0 + (platform_joint_force_mx_by_limb4_P * t41 + t65);
    REAL checked3 = pivot_0;
    const REAL t67 = 1.0 / pivot_0;
    /* limb1: results; pivots */
    const REAL t106 = limb4_P_v * t41, t98 = t67 * t97, t168 = t97 * t98,
      t111 = limb1_U_v_0 - limb2_U_v_0 * minus_limb2_U_null_space_0_by_limb5_S_wx,
      t115 = limb3_U_v_0 + (t109 + (t111 + limb2_U_v_1 * limb2_U_null_space_1_by_limb5_S_wx)),
      t116 = limb4_U_v_0 * limb4_U_null_space_0_by_limb5_S_wx + t115,
      t118 = t106 - (limb4_U_v_1 * limb4_U_null_space_1_by_limb5_S_wx + t116),
      t102 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy, /* platform */
      t119 = t102 + limb5_S_v_wz * platform_turn_xz - t118, t198 = t67 * t119, t167 = t98 * t119 + t166,
      t180 = limb1_U_null_space_1_by_limb5_S_wy * limb1_U_null_space_1_by_limb5_S_wy,
      t183 = t179 + (t180 + minus_limb1_U_null_space_0_by_limb5_S_wy * minus_limb1_U_null_space_0_by_limb5_S_wy);
    /* mechanism: pivots; results */
    const REAL t184 = limb2_U_null_space_0_by_limb5_S_wy * limb2_U_null_space_0_by_limb5_S_wy + t183,
      t186 = t176 + (minus_limb2_U_null_space_1_by_limb5_S_wy * minus_limb2_U_null_space_1_by_limb5_S_wy + t184),
      t187 = limb3_U_null_space_0_by_limb5_S_wy * limb3_U_null_space_0_by_limb5_S_wy + t186,
      t189 = t173 + (limb3_U_null_space_1_by_limb5_S_wy * limb3_U_null_space_1_by_limb5_S_wy + t187),
      t190 = limb4_U_null_space_0_by_limb5_S_wy * limb4_U_null_space_0_by_limb5_S_wy + t189,
      t192 = t170 + (minus_limb4_U_null_space_1_by_limb5_S_wy * minus_limb4_U_null_space_1_by_limb5_S_wy + t190),
      minus_pivot_1 = t168 - (limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_null_space_wz_by_limb5_S_wy + (1.0 + t192));
    checked0 = checked0 + minus_pivot_1;
    const REAL t195 = t167 / minus_pivot_1; /* limb1 */
    RESULT(checked1, v_next, 8, minus_limb3_P_null_space_by_limb5_S_wy * t195);
    const REAL t199 = t98 * t195 - t198; /* limb1 */
    RESULT(checked2, v_next, 0, minus_limb1_U_null_space_0_by_limb5_S_wy * t195 - t199);
    RESULT(checked3, v_next, 1, -(limb1_U_null_space_1_by_limb5_S_wy * t195));
    RESULT(checked0, v_next, 2, -(limb1_P_null_space_by_limb5_S_wy * t195));
    RESULT(checked1, v_next, 3, minus_limb2_U_null_space_0_by_limb5_S_wx * t199 - limb2_U_null_space_0_by_limb5_S_wy * t195);
    RESULT(checked2, v_next, 4, minus_limb2_U_null_space_1_by_limb5_S_wy * t195 - limb2_U_null_space_1_by_limb5_S_wx * t199);
    RESULT(checked3, v_next, 5, minus_limb2_P_null_space_by_limb5_S_wy * t195 - minus_platform_joint_force_mx_by_limb2_P * t199);
    RESULT(checked0, v_next, 6, -(t199 + limb3_U_null_space_0_by_limb5_S_wy * t195));
    RESULT(checked1, v_next, 7, -(limb3_U_null_space_1_by_limb5_S_wy * t195));
    RESULT(checked2, v_next, 9, -(limb4_U_null_space_0_by_limb5_S_wy * t195 + limb4_U_null_space_0_by_limb5_S_wx * t199));
    RESULT(checked3, v_next, 10, minus_limb4_U_null_space_1_by_limb5_S_wy * t195 - limb4_U_null_space_1_by_limb5_S_wx * t199);
    RESULT(checked0, v_next, 11, platform_joint_force_mx_by_limb4_P * t199 - limb4_P_null_space_by_limb5_S_wy * t195);
    const REAL t222 = platform_turn_yx * t195 + platform_turn_xx * t199,
      t218 = limb5_S_null_space_wz_by_limb5_S_wy * t195;
    RESULT(checked1, v_next, 12, -(platform_turn_zx * t218 + t222));
    const REAL t232 = platform_turn_yz * t195 + platform_turn_xz * t199;
    RESULT(checked2, v_next, 13, -(platform_turn_zy * t218 + (platform_turn_yy * t195 + platform_turn_xy * t199)));
    RESULT(checked3, v_next, 14, -(platform_turn_zz * t218 + t232));
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

#if !defined(THREE_UPS_UPU_S_VECTORS)

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
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_velocity_packed_lane(const double *restrict q,
    const double *restrict y_dot, double *restrict v, const double *restrict sine,
    const double *restrict cosine)
{
    typedef three_ups_upu_s_vector4 lanes4;
    const double limb5_S_q_qw = q[12], limb5_S_q_qx = q[13], limb5_S_q_qy = q[14], limb5_S_q_qz = q[15],
      limb5_S_y_dot_qy = y_dot[1], limb1_U_0_sin = sine[0], limb1_U_0_cos = cosine[0], limb1_lower_sin =
        sine[1],
      limb1_lower_cos = cosine[1];
    /* limb5_S: velocities, eq. (6) */
    const double t1 = limb5_S_q_qw * limb5_S_q_qw, t2 = limb5_S_q_qx * limb5_S_q_qx, t3 = t1 + t2,
      t4 = limb5_S_q_qy * limb5_S_q_qy, t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6;
    /* limb5_S: geometry; velocities, eq. (6) */
    const double t15 = t2 + t5, t114 = t2 + t4, t14 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t14 * t15,
      t9 = k2 - 0.5 * t7, platform_turn_zz = 1.0 - t14 * t114, platform_turn_xx = 1.0 - t6 * t14,
      t18 = limb5_S_q_qz * t14, t19 = limb5_S_q_qy * t18, t21 = limb5_S_q_qw * (limb5_S_q_qx * t14),
      t30 = limb5_S_q_qy * t14, platform_turn_zy = t19 + t21, platform_turn_yz = t19 - t21,
      t29 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy), /* limb1 */
      t31 = limb5_S_q_qx * t30, t104 = limb5_S_q_qw * t30, t32 = limb5_S_q_qw * t18, t103 = limb5_S_q_qx *
        t18,
      platform_turn_xy = t31 - t32, platform_turn_yx = t31 + t32,
      limb1_U2_constraint_mn_couple_z = t29 - limb1_lower_sin * platform_turn_xy;
    const lanes4 limb_upper_offset_x = (lanes4){q[2], q[5], q[8], q[11]} + limb_upper_phase,
      limb_lower_cos = {limb1_lower_cos, cosine[3], cosine[5], cosine[7]},
      each_limb1_U_0_lever_mz_by_limb1_U2_fz = limb_lower_cos * limb_upper_offset_x,
      lanes_2 = (lanes4){1.0, -1.0, 1.0, 1.0} / each_limb1_U_0_lever_mz_by_limb1_U2_fz,
      lanes_3 = limb_lower_cos * lanes_2;
    /* limb1: rates that follow; pivots; reciprocal wrenches, eq. (10) */
    const double limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * lanes_3[0];
    const lanes4 signed_limb_lower_sin = {limb1_lower_sin, sine[3], sine[5], sine[7]},
      each_limb1_U2_arm_x = limb_upper_offset_x - param_R * signed_limb_lower_sin;
    const double minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - each_limb1_U2_arm_x[0] *
        limb1_U_factor_1_by_3;
    const lanes4 each_limb1_upper_position_x = signed_limb_lower_sin * limb_upper_offset_x + (-param_R);
    const double t37 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3,
      t40 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * lanes_2[0],
      t24 = (-each_limb1_upper_position_x[0]) * minus_limb1_U_factor_0_by_3,
      minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t24;
    /* limb5_S: pivots; rates that follow */
    const double minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t37,
      t38 = 1.0 / minus_limb5_S_pivot_wz, t41 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t40, /* limb1 */
      limb5_S_null_space_wz_by_limb5_S_wy = t38 * t41;
    /* limb5_S: velocities, eq. (6); geometry */
    const double t42 = limb5_S_q_qx * t9 * limb5_S_null_space_wz_by_limb5_S_wy, t10 = limb5_S_q_qw * t9,
      a_pivot = 0.5 * (t10 + t42), t44 = 1.0 / a_pivot, t53 = 0.5 * t10,
      t47 = limb5_S_q_qy * t9 * limb5_S_null_space_wz_by_limb5_S_wy, t45 = limb5_S_q_qz * t9,
      t50 = t44 * (0.5 * (t45 - t47)), t54 = 0.5 * t45, t52 = y_dot[0] - limb5_S_y_dot_qy * t50,
      a_pivot_2 = t53 + t54 * t50, limb5_S_joint_rate_wx = t52 / a_pivot_2,
      limb5_S_joint_rate_wy = t44 * (limb5_S_y_dot_qy + t54 * limb5_S_joint_rate_wx),
      limb5_S_joint_rate_wz = t38 * (t41 * limb5_S_joint_rate_wy), t116 = platform_turn_zz *
        limb5_S_joint_rate_wz,
      t117 = platform_turn_yz * limb5_S_joint_rate_wy, t110 = platform_turn_zy * limb5_S_joint_rate_wz,
      platform_omega_y = t110 + (platform_turn_yy * limb5_S_joint_rate_wy + platform_turn_xy *
        limb5_S_joint_rate_wx);
    v[13] = platform_omega_y;
    const double t109 = platform_turn_yx * limb5_S_joint_rate_wy + platform_turn_xx * limb5_S_joint_rate_wx,
      platform_turn_zx = t103 - t104, platform_omega_z = t116 + (t117 + (t103 + t104) *
        limb5_S_joint_rate_wx);
    v[14] = platform_omega_z;
    const double platform_omega_x = platform_turn_zx * limb5_S_joint_rate_wz + t109;
    v[12] = platform_omega_x;
    const lanes4 each_limb1_U_0_sin = {limb1_U_0_sin, sine[2], sine[4], sine[6]},
      lanes_5 = each_limb1_U_0_sin * limb5_S_joint_rate_wz,
      lanes_7 = (lanes4){1.0, -1.0, 1.0, -1.0} * (lanes4){limb1_U_0_cos, cosine[2], cosine[4], cosine[6]},
      lanes_8 = lanes_7 * limb5_S_joint_rate_wz,
      each_limb5_S_joint_rate_wy = {limb5_S_joint_rate_wy, limb5_S_joint_rate_wx, limb5_S_joint_rate_wy,
        limb5_S_joint_rate_wx},
      lanes_10 = lanes_5 + lanes_7 * each_limb5_S_joint_rate_wy,
      signed_limb_U_joint_rate_1 = lanes_3 * (each_limb1_U2_arm_x * lanes_10);
    v[1] = signed_limb_U_joint_rate_1[0];
    v[4] = -(-signed_limb_U_joint_rate_1[1]);
    v[7] = signed_limb_U_joint_rate_1[2];
    v[10] = -signed_limb_U_joint_rate_1[3];
    const lanes4 signed_limb_P_joint_rate = param_R * limb_lower_cos * lanes_10;
    v[2] = signed_limb_P_joint_rate[0];
    v[5] = -signed_limb_P_joint_rate[1];
    v[8] = -signed_limb_P_joint_rate[2];
    v[11] = signed_limb_P_joint_rate[3];
    const lanes4 lanes_14 = lanes_2 * (each_limb1_upper_position_x * (lanes_8 - each_limb1_U_0_sin *
        each_limb5_S_joint_rate_wy)),
      each_limb5_S_joint_rate_wx = {limb5_S_joint_rate_wx, limb5_S_joint_rate_wy, limb5_S_joint_rate_wx,
        limb5_S_joint_rate_wy},
      limb_U_joint_rate_0 = each_limb5_S_joint_rate_wx - (lanes4){1.0, -1.0, -1.0, -1.0} * lanes_14;
    v[0] = limb_U_joint_rate_0[0];
    v[3] = limb_U_joint_rate_0[1];
    v[6] = limb_U_joint_rate_0[2];
    v[9] = limb_U_joint_rate_0[3];
    const lanes4 every = (lanes4)((three_ups_upu_s_vector4_mask)((each_limb1_U_0_lever_mz_by_limb1_U2_fz +
        limb_U_joint_rate_0) + (signed_limb_U_joint_rate_1 + signed_limb_P_joint_rate)) |
        ((each_limb1_U_0_lever_mz_by_limb1_U2_fz <= (lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10,
        6.62327e-10}) & (each_limb1_U_0_lever_mz_by_limb1_U2_fz >= -(lanes4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10})));
    return fabs(minus_limb5_S_pivot_wz) <= 1.0e-09 || fabs(a_pivot) <= 1.0e-09 || fabs(a_pivot_2) <= 1.0e-09
        || !(t7 >= 0.999999 && t7 <= 1.000001) ? (double)NAN : (((minus_limb5_S_pivot_wz + a_pivot) +
        (a_pivot_2 + platform_omega_x)) + ((platform_omega_y + platform_omega_z) + (every[0] + every[1]))) +
        (every[2] + every[3]);
}
#endif

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
    if (isfinite(three_ups_upu_s_velocity_packed_lane(q, y_dot, v, sine, cosine))) {
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
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_acceleration_packed_lane(const double *restrict q,
    const double *restrict v, const double *restrict y_ddot, double *restrict a, const double *restrict sine,
    const double *restrict cosine)
{
    typedef three_ups_upu_s_vector4 lanes4;
    const double limb5_S_q_qw = q[12], limb5_S_q_qx = q[13], limb5_S_q_qy = q[14], limb5_S_q_qz = q[15],
      limb1_U_v_0 = v[0], limb1_U_v_1 = v[1], limb5_S_v_wx = v[12], limb5_S_v_wy = v[13], limb5_S_v_wz =
        v[14],
      limb1_U_0_sin = sine[0], limb1_U_0_cos = cosine[0], limb1_lower_sin = sine[1], limb1_lower_cos =
        cosine[1];
    /* limb5_S: accelerations */
    const double t1 = limb5_S_q_qw * limb5_S_q_qw, t2 = limb5_S_q_qx * limb5_S_q_qx, t3 = t1 + t2,
      t4 = limb5_S_q_qy * limb5_S_q_qy, t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6;
    /* platform: geometry; accelerations; velocities, eq. (6) */
    const double t15 = t2 + t5, t65 = t2 + t4, t14 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t14 * t15,
      platform_turn_xx = 1.0 - t6 * t14, platform_turn_zz = 1.0 - t14 * t65, t9 = k2 - 0.5 * t7,
      t30 = limb5_S_q_qy * t14, t31 = limb5_S_q_qx * t30, t60 = limb5_S_q_qw * t30, t18 = limb5_S_q_qz * t14,
      t21 = limb5_S_q_qw * (limb5_S_q_qx * t14), t32 = limb5_S_q_qw * t18, platform_turn_yx = t31 + t32,
      platform_turn_xy = t31 - t32, t53 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      t19 = limb5_S_q_qy * t18, t59 = limb5_S_q_qx * t18, platform_turn_yz = t19 - t21, platform_turn_zy = t19
        + t21,
      platform_twist_wy = t53 + limb5_S_v_wz * platform_turn_yz,
      t58 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy, platform_turn_xz = t59 + t60,
      platform_turn_zx = t59 - t60, platform_twist_wx = t58 + limb5_S_v_wz * platform_turn_xz;
    const lanes4 each_limb1_U_0_sin = {limb1_U_0_sin, sine[2], sine[4], sine[6]},
      each_platform_twist_wy = {platform_twist_wy, platform_twist_wx, platform_twist_wy, platform_twist_wx},
      lanes_2 = (lanes4){1.0, -1.0, 1.0, -1.0} * each_platform_twist_wy, lanes_3 = each_limb1_U_0_sin *
        lanes_2;
    const double t70 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy,
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + t70;
    const lanes4 each_limb1_U_0_cos = {limb1_U_0_cos, cosine[2], cosine[4], cosine[6]},
      lanes_5 = lanes_3 - each_limb1_U_0_cos * platform_twist_wz;
    const double t106 = lanes_5[0];
    /* limb1: loop closure; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const double t119 = limb1_lower_sin * t106 + limb1_lower_cos * platform_twist_wx,
      limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos, t120 = limb1_lower_omega_y - t119,
      t121 = limb1_U_v_1 * t120;
    const lanes4 lanes_8 = each_limb1_U_0_cos * lanes_2 + each_limb1_U_0_sin * platform_twist_wz;
    const double t115 = limb1_U_v_1 - lanes_8[0],
      t123 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t115 - t121),
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy,
      t124 = limb1_U2_constraint_mn_couple_x * t123, limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin,
      t125 = limb1_lower_omega_x * t120,
      t129 = limb1_lower_omega_x + (limb1_lower_cos * t106 - limb1_lower_sin * platform_twist_wx),
      t131 = t125 - limb1_lower_omega_y * t129,
      t28 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, t134 = limb1_lower_sin * t28,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t28 - limb1_lower_sin * platform_turn_xy,
      t133 = t124 - limb1_U2_constraint_mn_couple_z * t131,
      limb1_U2_opening_mn = t134 + limb1_lower_cos * platform_turn_xy,
      t139 = t129 * (limb1_U2_opening_mn * t129 + limb1_U2_constraint_mn_couple_z * t120),
      limb1_U2_opening_bias_mn = t133 - (t139 - t115 * (limb1_U2_constraint_mn_couple_x * t120 -
        limb1_U2_opening_mn * t115));
    const lanes4 limb_U_v_0 = {limb1_U_v_0, v[3], v[6], v[9]};
    /* limbs together: accelerations; geometry; reciprocal wrenches, eq. (10) */
    const lanes4 lanes_9 = limb_U_v_0 * lanes_5,
      limb_upper_offset_x = (lanes4){q[2], q[5], q[8], q[11]} + limb_upper_phase,
      signed_limb_lower_sin = {limb1_lower_sin, sine[3], sine[5], sine[7]},
      each_limb1_U2_arm_x = limb_upper_offset_x - param_R * signed_limb_lower_sin,
      lanes_11 = each_limb1_U2_arm_x * lanes_9, limb_U_v_1 = {limb1_U_v_1, v[4], v[7], v[10]},
      limb_P_v = {v[2], v[5], v[8], v[11]},
      lanes_15 = lanes_11 + (lanes4){1.0, -1.0, 1.0, -1.0} * (limb_U_v_1 * limb_P_v),
      limb_lower_cos = {limb1_lower_cos, cosine[3], cosine[5], cosine[7]}, lanes_16 = limb_U_v_1 *
        limb_lower_cos,
      lanes_21 = lanes_15 + lanes_8 * ((lanes4){param_R, param_R, -param_R, -param_R} * lanes_16 - limb_P_v),
      lanes_22 = limb_upper_offset_x * lanes_16,
      each_limb1_U_0_lever_mz_by_limb1_U2_fz = limb_lower_cos * limb_upper_offset_x,
      lanes_24 = (lanes4){1.0, -1.0, 1.0, -1.0} / each_limb1_U_0_lever_mz_by_limb1_U2_fz,
      lanes_25 = limb_lower_cos * lanes_24;
    const double limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * lanes_25[0],
      t154 = limb1_U2_opening_bias_mn - lanes_21[0] * limb1_U_factor_1_by_3, /* limb5_S */
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - each_limb1_U2_arm_x[0] *
        limb1_U_factor_1_by_3;
    const lanes4 lanes_26 = limb_U_v_0 * lanes_8, lanes_28 = (lanes4){1.0, 1.0, -1.0, -1.0} *
        signed_limb_lower_sin,
      each_limb1_upper_position_x = lanes_28 * limb_upper_offset_x + (lanes4){-param_R, -param_R, param_R,
        param_R},
      lanes_30 = each_limb1_upper_position_x * lanes_26, lanes_31 = limb_U_v_1 * lanes_28,
      lanes_34 = lanes_8 * (param_R * lanes_31),
      lanes_38 = (lanes4){1.0, -1.0, 1.0, -1.0} * (limb_P_v * limb_lower_cos - limb_upper_offset_x *
        lanes_31),
      lanes_41 = (lanes4){platform_twist_wx, platform_twist_wy, platform_twist_wx, platform_twist_wy} *
        lanes_38,
      lanes_44 = limb_U_v_0 * lanes_38 - lanes_30 - lanes_5 * (limb_P_v * lanes_28 + lanes_22),
      lanes_45 = lanes_44 - lanes_41;
    const double minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x *
        lanes_24[0],
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x;
    /* limb5_S: accelerations; pivots; rates that follow */
    const double t155 = minus_limb1_U_factor_0_by_3 * lanes_45[0] - t154,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn - (-each_limb1_upper_position_x[0]) *
        minus_limb1_U_factor_0_by_3,
      t40 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3, /* limb1 */
      minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin *
        minus_limb1_U2_factor_0_by_3,
      t38 = 1.0 / minus_limb5_S_pivot_wz, minus_limb5_S_joint_acc_still_wz = t38 * t155,
      t41 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t40, /* limb1 */
      t11 = limb5_S_q_qx * t9, t157 = 0.5 * (t11 * minus_limb5_S_joint_acc_still_wz), t45 = limb5_S_q_qz * t9,
      t76 = platform_twist_wy * t45, t46 = limb5_S_q_qy * t9, t10 = limb5_S_q_qw * t9,
      t81 = platform_twist_wz * (0.5 * (platform_twist_wx * t10 + (t76 - platform_twist_wz * t46))),
      t87 = 0.5 * (platform_twist_wz * t10 + (platform_twist_wx * t46 - platform_twist_wy * t11)),
      t89 = t81 - platform_twist_wx * t87, t161 = platform_twist_wy * t87,
      t73 = 0.5 * (platform_twist_wx * t11 + platform_twist_wy * t46 + platform_twist_wz * t45),
      t158 = y_ddot[1] + 0.5 * (platform_twist_wy * t73 - t89) + t157, t162 = platform_twist_wy * t10,
      t160 = platform_twist_wx * t73, t164 = platform_twist_wx * t45, limb5_S_null_space_wz_by_limb5_S_wy =
        t38 * t41,
      a_pivot = 0.5 * (t10 + t11 * limb5_S_null_space_wz_by_limb5_S_wy), t44 = 1.0 / a_pivot,
      t50 = t44 * (0.5 * (t45 - t46 * limb5_S_null_space_wz_by_limb5_S_wy)),
      t174 = 0.5 * (t46 * minus_limb5_S_joint_acc_still_wz),
      t169 = t161 - platform_twist_wz * (0.5 * (t162 + (platform_twist_wz * t11 - t164))),
      t175 = y_ddot[0] + 0.5 * (t160 - t169) - t174, t178 = 0.5 * t45, t176 = t50 * t158 - t175,
      a_pivot_2 = 0.5 * t10 + t178 * t50, minus_limb5_S_joint_acc_wx = t176 / a_pivot_2,
      limb5_S_joint_acc_wy = t44 * (t158 - t178 * minus_limb5_S_joint_acc_wx),
      t183 = t38 * (t41 * limb5_S_joint_acc_wy); /* limb1 */
    /* limb5_S: results; accelerations */
    const double t385 = platform_turn_yz * limb5_S_joint_acc_wy - platform_turn_xz *
        minus_limb5_S_joint_acc_wx,
      t381 = platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx,
      t377 = platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx,
      minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz - t183,
      limb5_S_a_wz = t385 - platform_turn_zz * minus_limb5_S_joint_acc_wz;
    a[14] = limb5_S_a_wz;
    const double limb5_S_a_wy = t381 - platform_turn_zy * minus_limb5_S_joint_acc_wz;
    a[13] = limb5_S_a_wy;
    const double limb5_S_a_wx = t377 - platform_turn_zx * minus_limb5_S_joint_acc_wz;
    a[12] = limb5_S_a_wx;
    /* limbs together: accelerations; reciprocal wrenches, eq. (10) */
    const lanes4 lanes_46 = each_limb1_U_0_sin * t183, lanes_47 = each_limb1_U_0_cos * t183,
      each_limb5_S_joint_acc_wy = {limb5_S_joint_acc_wy, minus_limb5_S_joint_acc_wx, limb5_S_joint_acc_wy,
        minus_limb5_S_joint_acc_wx},
      lanes_49 = lanes_46 + each_limb1_U_0_cos * each_limb5_S_joint_acc_wy,
      each_limb1_U2_arm_y = param_R * limb_lower_cos, lanes_51 = each_limb1_U2_arm_y * lanes_9 + lanes_34,
      lanes_52 = each_limb1_U2_arm_y * lanes_49, lanes_53 = each_limb1_U2_arm_x * lanes_49,
      lanes_54 = each_limb1_U_0_sin * minus_limb5_S_joint_acc_still_wz,
      signed_limb_P_joint_acc = lanes_52 - (lanes_51 + each_limb1_U2_arm_y * lanes_54);
    a[2] = signed_limb_P_joint_acc[0];
    a[5] = -signed_limb_P_joint_acc[1];
    a[8] = -signed_limb_P_joint_acc[2];
    a[11] = signed_limb_P_joint_acc[3];
    const lanes4 limb_U_joint_acc_1 = lanes_25 * (lanes_53 - (lanes_21 + each_limb1_U2_arm_x * lanes_54));
    a[1] = limb_U_joint_acc_1[0];
    a[4] = -(-limb_U_joint_acc_1[1]);
    a[7] = limb_U_joint_acc_1[2];
    a[10] = -(-limb_U_joint_acc_1[3]);
    const lanes4 lanes_61 = each_limb1_upper_position_x * (each_limb1_U_0_cos *
        minus_limb5_S_joint_acc_still_wz) - lanes_45,
      limb_U_joint_acc_still_0 = lanes_24 * lanes_61,
      lanes_65 = lanes_24 * (each_limb1_upper_position_x * (lanes_47 - each_limb1_U_0_sin *
        each_limb5_S_joint_acc_wy)),
      each_limb5_S_joint_acc_wx = {minus_limb5_S_joint_acc_wx, limb5_S_joint_acc_wy,
        minus_limb5_S_joint_acc_wx, limb5_S_joint_acc_wy},
      limb_U_joint_acc_0 = limb_U_joint_acc_still_0 - ((lanes4){1.0, -1.0, 1.0, -1.0} *
        each_limb5_S_joint_acc_wx + lanes_65);
    a[0] = -(-limb_U_joint_acc_0[0]);
    a[3] = limb_U_joint_acc_0[1];
    a[6] = limb_U_joint_acc_0[2];
    a[9] = limb_U_joint_acc_0[3];
    const lanes4 every = (lanes4)((three_ups_upu_s_vector4_mask)((each_limb1_U_0_lever_mz_by_limb1_U2_fz +
        limb_U_joint_acc_0) + (limb_U_joint_acc_1 + signed_limb_P_joint_acc)) |
        ((each_limb1_U_0_lever_mz_by_limb1_U2_fz <= (lanes4){6.62327e-10, 6.62327e-10, 6.62327e-10,
        6.62327e-10}) & (each_limb1_U_0_lever_mz_by_limb1_U2_fz >= -(lanes4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10})));
    return fabs(minus_limb5_S_pivot_wz) <= 1.0e-09 || fabs(a_pivot) <= 1.0e-09 || fabs(a_pivot_2) <= 1.0e-09
        || !(t7 >= 0.999999 && t7 <= 1.000001) ? (double)NAN : (((minus_limb5_S_pivot_wz + a_pivot) +
        (a_pivot_2 + limb5_S_a_wx)) + ((limb5_S_a_wy + limb5_S_a_wz) + (every[0] + every[1]))) + (every[2] +
        every[3]);
}
#endif

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
    if (isfinite(three_ups_upu_s_acceleration_packed_lane(q, v, y_ddot, a, sine, cosine))) {
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

BODY(three_ups_upu_s_assemble_step)(size_t stride, const double *restrict q, const double *restrict y,
    double *restrict q_next, double *restrict residual_, double *restrict step, double *restrict orientation_,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: results */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6;
    /* limb5_S: geometry; results */
    const REAL t15 = t2 + t5, t53 = t2 + t4, t14 = 4.0 - 2.0 * t7, platform_turn_yy = 1.0 - t14 * t15,
      t9 = k2 - 0.5 * t7, t62 = 0.5 * (1.0 - t6 * t14), t55 = param_H * (1.0 - t14 * t53), t18 = limb5_S_q_qz * t14,
      t19 = limb5_S_q_qy * t18, t21 = limb5_S_q_qw * (limb5_S_q_qx * t14), t30 = limb5_S_q_qy * t14,
      platform_turn_zy = t19 + t21, t47 = param_H * (t19 - t21), limb1_U_0_cos = SINES(cosine, 0),
      limb1_U_0_sin = SINES(sine, 0),
      t28 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1),
      t29 = limb1_lower_cos * t28, /* limb1 */
      t59 = limb1_lower_sin * t28, /* limb1 */
      t31 = limb5_S_q_qx * t30, t51 = limb5_S_q_qw * t30, t32 = limb5_S_q_qw * t18, t50 = limb5_S_q_qx * t18,
      platform_turn_xy = t31 - t32, t46 = 0.5 * (t31 + t32);
    /* limb1: reciprocal wrenches, eq. (10); geometry; rates that follow */
    const REAL limb1_U2_constraint_mn_couple_z = t29 - limb1_lower_sin * platform_turn_xy,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      minus_limb1_U_0_lever_mz_by_limb1_U2_fz = limb1_lower_cos * limb1_upper_offset_x,
      t23 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz, t35 = limb1_lower_cos * t23,
      limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t35,
      limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin,
      minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3,
      t37 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3, t40 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3,
      t22 = limb1_U_0_sin * platform_turn_zy, t113 = 0.5 * platform_turn_zy, /* platform */
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + t22,
      t109 = 0.5 * platform_turn_yy, /* platform */
      minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t23,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_my_by_limb1_U2_mn - minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3;
    /* limb5_S: pivots; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t37,
      t41 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t40, /* limb1 */
      t38 = 1.0 / minus_limb5_S_pivot_wz, limb5_S_null_space_wz_by_limb5_S_wy = t38 * t41;
    /* limb5_S: results; geometry */
    const REAL t11 = limb5_S_q_qx * t9, t42 = t11 * limb5_S_null_space_wz_by_limb5_S_wy, t10 = limb5_S_q_qw * t9,
      a_pivot = 0.5 * (t10 + t42), t89 = 0.5 * t10, t44 = 1.0 / a_pivot, t78 = limb5_S_q_qy * t9,
      t79 = t78 * limb5_S_null_space_wz_by_limb5_S_wy, t76 = limb5_S_q_qz * t9, t82 = t44 * (0.5 * (t76 - t79)),
      t77 = 0.5 * t76, platform_turn_zx = t50 - t51, t63 = param_H * (t50 + t51), t52 = 0.5 * platform_turn_zx;
    /* limb1: loop closure; geometry; results */
    const REAL t64 = minus_limb1_upper_position_x - (t62 - t63), limb3_upper_position_x_2 = t62 + t63,
      t65 = limb1_lower_cos * t64, t243 = limb1_lower_sin * t64, minus_limb1_lower_limb_target_x = t46 - t47,
      limb3_lower_limb_target_x = t46 + t47, minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos,
      t48 = limb1_upper_offset_x * minus_limb1_lower_rotation_yx - minus_limb1_lower_limb_target_x,
      t245 = t243 - minus_limb1_lower_rotation_yx * t48, t67 = t65 + limb1_U_0_sin * limb1_lower_sin * t48,
      t49 = limb1_U_0_cos * t48, minus_limb1_lower_limb_target_y = t52 - t55, limb3_lower_limb_target_y = t52 + t55,
      limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos,
      t56 = limb1_upper_offset_x * limb1_lower_rotation_zx + minus_limb1_lower_limb_target_y,
      minus_limb1_U2_opening_fx = t245 - limb1_lower_rotation_zx * t56,
      minus_limb1_U2_opening_fy = t67 + limb1_U_0_cos * limb1_lower_sin * t56,
      t69 = minus_limb1_U2_opening_fy * limb1_U_factor_1_by_3, minus_limb1_U2_opening_fz = t49 - limb1_U_0_sin * t56,
      t58 = minus_limb1_U2_opening_fz * minus_limb1_U_factor_0_by_3,
      limb1_U2_opening_mn = t59 + limb1_lower_cos * platform_turn_xy;
    /* step: results; geometry */
    const REAL t72 = t38 * (t58 - (limb1_U2_opening_mn + t69)), t74 = 0.5 * (t11 * t72), t86 = 0.5 * (t78 * t72),
      t106 = 0.5 * platform_turn_xy, t503 = limb1_U2_opening_mn * limb1_U2_opening_mn, /* limb1 */
      t75 = limb5_S_q_qy - READ(y, 1) - t74, t83 = t82 * t75, a_pivot_2 = t89 + t77 * t82,
      t91 = (t83 - (limb5_S_q_qx - READ(y, 0) + t86)) / a_pivot_2, t94 = t44 * (t75 - t77 * t91),
      t96 = t38 * (t41 * t94),
      t258 = t91 - t23 * (minus_limb1_upper_position_x * (limb1_U_0_cos * t96 - limb1_U_0_sin * t94)),
      t263 = t258 - t23 * (minus_limb1_U2_opening_fz + minus_limb1_upper_position_x * (limb1_U_0_cos * t72)),
      t264 = t263 * t263, t500 = per_length * minus_limb1_U2_opening_fz, /* limb1 */
      t501 = t500 * t500, /* limb1 */
      t241 = limb1_U_0_sin * t96 + limb1_U_0_cos * t94, t265 = limb1_U2_arm_x * t241, t247 = limb1_U_0_sin * t72,
      t269 = t35 * (t265 - (minus_limb1_U2_opening_fy - limb1_U2_arm_x * t247)), t271 = t264 + t269 * t269,
      t497 = per_length * minus_limb1_U2_opening_fy, /* limb1 */
      t498 = t497 * t497, /* limb1 */
      minus_limb1_U2_arm_y = param_R * limb1_lower_cos,
      t251 = per_length * (minus_limb1_U2_arm_y * t241 - (minus_limb1_U2_opening_fx - minus_limb1_U2_arm_y * t247)),
      t272 = t251 * t251 + t271, t495 = per_length * minus_limb1_U2_opening_fx; /* limb1 */
    /* limb2: geometry; results; loop closure */
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2),
      t504 = t495 * t495 + t498 + t501 + t503, /* limb1 */
      t227 = limb2_U_0_sin * t96 - minus_limb2_U_0_cos * t91, /* step */
      limb2_upper_offset_x = limb_upper_phase + READ(q, 5), limb2_lower_sin = SINES(sine, 4),
      minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x,
      limb2_lower_cos = SINES(cosine, 4), t228 = minus_limb2_upper_position_y * t227, /* step */
      minus_limb2_U_0_lever_mz_by_limb2_S_fz = limb2_lower_cos * limb2_upper_offset_x,
      t212 = 1.0 / minus_limb2_U_0_lever_mz_by_limb2_S_fz, t230 = t94 - t212 * t228, /* step */
      t234 = minus_limb2_upper_position_y * (limb2_U_0_sin * t72), /* step */
      limb2_lower_limb_target_y = t63 - t106, limb4_lower_limb_target_y = t63 + t106,
      minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos,
      t199 = limb2_upper_offset_x * minus_limb2_lower_rotation_xx + limb2_lower_limb_target_y,
      t200 = minus_limb2_lower_rotation_xx * t199, t231 = limb2_U_0_sin * t199,
      limb2_lower_limb_target_x = t55 - t113, limb4_lower_limb_target_x = t55 + t113,
      minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos,
      t204 = limb2_upper_offset_x * minus_limb2_lower_rotation_zx + limb2_lower_limb_target_x,
      t205 = minus_limb2_lower_rotation_zx * t204, minus_limb2_S_opening_fz = t231 - minus_limb2_U_0_cos * t204,
      t237 = t230 + t212 * (minus_limb2_S_opening_fz - t234), /* step */
      t273 = t237 * t237 + t272, /* step */
      t213 = limb2_lower_cos * t212, t511 = per_length * minus_limb2_S_opening_fz, t512 = t511 * t511,
      t197 = minus_limb2_U_0_cos * t96 + limb2_U_0_sin * t91, /* step */
      limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin, t215 = limb2_S_arm_x * t197, /* step */
      t206 = minus_limb2_U_0_cos * t72, /* step */
      t220 = limb2_S_arm_x * t206, /* step */
      t216 = minus_limb2_U_0_cos * limb2_lower_sin * t199, t201 = minus_limb2_upper_position_y + (t47 - t109),
      limb4_upper_position_y_2 = t47 + t109, t218 = t216 + limb2_lower_cos * t201,
      limb2_S_opening_fx = t200 - limb2_lower_sin * t201 + t205,
      minus_limb2_S_opening_fy = t218 + limb2_U_0_sin * limb2_lower_sin * t204,
      t223 = t213 * (t215 + (minus_limb2_S_opening_fy + t220)), /* step */
      t274 = t223 * t223 + t273, /* step */
      t508 = per_length * minus_limb2_S_opening_fy, t509 = t508 * t508,
      minus_limb2_S_arm_y = param_R * limb2_lower_cos,
      t210 = per_length * (minus_limb2_S_arm_y * t197 - (limb2_S_opening_fx - minus_limb2_S_arm_y * t206)), /* step */
      t275 = t210 * t210 + t274, /* step */
      t505 = per_length * limb2_S_opening_fx;
    /* limb3: geometry; loop closure; results */
    const REAL limb3_U_0_cos = SINES(cosine, 5), limb3_U_0_sin = SINES(sine, 5),
      t513 = t504 + t505 * t505 + t509 + t512, /* residual */
      t182 = limb3_U_0_cos * t96 - limb3_U_0_sin * t94, /* step */
      limb3_upper_offset_x = limb_upper_phase + READ(q, 8), minus_limb3_lower_sin = SINES(sine, 6),
      t532 = limb2_upper_offset_x * limb3_upper_offset_x, /* orientation */
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x,
      t183 = limb3_upper_position_x * t182, /* step */
      t154 = limb3_upper_position_x - limb3_upper_position_x_2, limb3_lower_cos = SINES(cosine, 6),
      minus_limb3_U_0_lever_mz_by_limb3_S_fz = limb3_lower_cos * limb3_upper_offset_x,
      t167 = 1.0 / minus_limb3_U_0_lever_mz_by_limb3_S_fz, t185 = t91 + t167 * t183, /* step */
      t189 = limb3_upper_position_x * (limb3_U_0_cos * t72), /* step */
      minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos,
      t156 = limb3_upper_offset_x * minus_limb3_lower_rotation_yx + limb3_lower_limb_target_x,
      t157 = minus_limb3_lower_rotation_yx * t156, t186 = limb3_U_0_cos * t156,
      limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos,
      t159 = limb3_upper_offset_x * limb3_lower_rotation_zx - limb3_lower_limb_target_y,
      t160 = limb3_lower_rotation_zx * t159, minus_limb3_S_opening_fz = t186 - limb3_U_0_sin * t159,
      t192 = t185 - t167 * (minus_limb3_S_opening_fz - t189), /* step */
      t276 = t192 * t192 + t275, /* step */
      t168 = limb3_lower_cos * t167, t520 = per_length * minus_limb3_S_opening_fz, t521 = t520 * t520,
      t152 = limb3_U_0_sin * t96 + limb3_U_0_cos * t94, /* step */
      limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin,
      t170 = limb3_S_arm_x * t152, /* step */
      t161 = limb3_U_0_sin * t72, /* step */
      t175 = limb3_S_arm_x * t161, /* step */
      t171 = limb3_lower_cos * t154, minus_limb3_S_opening_fx = minus_limb3_lower_sin * t154 - t157 - t160,
      t173 = t171 + limb3_U_0_sin * minus_limb3_lower_sin * t156,
      limb3_S_opening_fy = t173 + limb3_U_0_cos * minus_limb3_lower_sin * t159,
      t178 = t168 * (t170 + (limb3_S_opening_fy + t175)), /* step */
      t277 = t178 * t178 + t276, /* step */
      t517 = per_length * limb3_S_opening_fy, t518 = t517 * t517, limb3_S_arm_y = param_R * limb3_lower_cos,
      t165 = per_length * (limb3_S_arm_y * t152 + (minus_limb3_S_opening_fx + limb3_S_arm_y * t161)), /* step */
      t278 = t165 * t165 + t277, /* step */
      t514 = per_length * minus_limb3_S_opening_fx, limb4_U_0_sin = SINES(cosine, 7),
      minus_limb4_U_0_cos = SINES(sine, 7), t522 = t513 + t514 * t514 + t518 + t521, /* residual */
      t137 = limb4_U_0_sin * t96 - minus_limb4_U_0_cos * t91, /* step */
      limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      t535 = minus_limb3_U_0_lever_mz_by_limb3_S_fz * (limb1_upper_offset_x * (limb4_upper_offset_x * t532)), /* orientation */
      minus_limb4_lower_sin = SINES(sine, 9),
      t536 = minus_limb2_U_0_lever_mz_by_limb2_S_fz * t535, /* orientation */
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      t138 = limb4_upper_position_y * t137, /* step */
      t110 = limb4_upper_position_y - limb4_upper_position_y_2, /* limb4 */
      limb4_lower_cos = SINES(cosine, 9),
      minus_limb4_U_0_lever_mz_by_limb4_S_fz = limb4_lower_cos * limb4_upper_offset_x,
      t539 = minus_limb1_U_0_lever_mz_by_limb1_U2_fz * (minus_limb4_U_0_lever_mz_by_limb4_S_fz * t536) * minus_limb5_S_pivot_wz, /* orientation */
      orientation_orientation = -(a_pivot_2 * (a_pivot * t539));
    WRITE(orientation_, 0, orientation_orientation);
    REAL checked0 = orientation_orientation;
    /* limb4: results; geometry; loop closure */
    const REAL t122 = 1.0 / minus_limb4_U_0_lever_mz_by_limb4_S_fz, t140 = t94 + t122 * t138, /* step */
      t144 = limb4_upper_position_y * (limb4_U_0_sin * t72), /* step */
      minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos,
      t107 = limb4_upper_offset_x * minus_limb4_lower_rotation_xx + limb4_lower_limb_target_y,
      t108 = minus_limb4_lower_rotation_xx * t107, t141 = limb4_U_0_sin * t107,
      minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos,
      t114 = limb4_upper_offset_x * minus_limb4_lower_rotation_zx + limb4_lower_limb_target_x,
      t115 = minus_limb4_lower_rotation_zx * t114, minus_limb4_S_opening_fz = t141 - minus_limb4_U_0_cos * t114;
    /* step: results; geometry */
    const REAL t147 = t140 + t122 * (minus_limb4_S_opening_fz + t144), t279 = t147 * t147 + t278,
      t123 = limb4_lower_cos * t122, /* limb4 */
      t529 = per_length * minus_limb4_S_opening_fz, /* limb4 */
      t530 = t529 * t529, /* limb4 */
      t102 = minus_limb4_U_0_cos * t96, t97 = t72 + t96, t116 = minus_limb4_U_0_cos * t72,
      t104 = t102 + limb4_U_0_sin * t91, limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin,
      t125 = limb4_S_arm_x * t104, t130 = limb4_S_arm_x * t116,
      t128 = minus_limb4_U_0_cos * minus_limb4_lower_sin * t107 + limb4_lower_cos * t110, /* limb4 */
      limb4_S_opening_fx = t108 - minus_limb4_lower_sin * t110 + t115,
      limb4_S_opening_fy = t128 + limb4_U_0_sin * minus_limb4_lower_sin * t114,
      t133 = t123 * (t125 - (limb4_S_opening_fy - t130)), t280 = t133 * t133 + t279,
      t526 = per_length * limb4_S_opening_fy, /* limb4 */
      t527 = t526 * t526, /* limb4 */
      limb4_S_arm_y = param_R * limb4_lower_cos,
      t120 = per_length * (limb4_S_arm_y * t104 + (limb4_S_opening_fx + limb4_S_arm_y * t116)),
      t281 = t120 * t120 + t280, t523 = per_length * limb4_S_opening_fx, /* limb4 */
      residual_residual = SQRT(t522 + t523 * t523 + t527 + t530);
    WRITE(residual_, 0, residual_residual);
    REAL checked1 = residual_residual;
    const REAL t284 = t97 * t97 + (t94 * t94 + (t91 * t91 + t281)), step_step = SQRT(t284);
    WRITE(step, 0, step_step);
    REAL checked2 = step_step;
    const REAL t285 = LESS(step_step, 0.5), t288 = SELECT(t285, 1.0, 0.5 / SELECT(t285, 1.0, step_step)),
      t290 = 0.5 * (t94 * t288), t296 = t97 * t288, t293 = 0.5 * (t91 * t288), t297 = 0.5 * t296,
      t321 = limb5_S_q_qw + (limb5_S_q_qz * t297 + (limb5_S_q_qy * t290 - limb5_S_q_qx * t293)), t322 = t321 * t321,
      t314 = limb5_S_q_qy * t297 - limb5_S_q_qz * t290 + (limb5_S_q_qx + limb5_S_q_qw * t293),
      t323 = t314 * t314 + t322, t294 = limb5_S_q_qy * t293, t299 = limb5_S_q_qz - limb5_S_q_qw * t297,
      t307 = limb5_S_q_qz * t293 + limb5_S_q_qx * t297 - (limb5_S_q_qy - limb5_S_q_qw * t290),
      t300 = limb5_S_q_qx * t290 + t294 + t299, t327 = 1.0 / SQRT(t300 * t300 + (t307 * t307 + t323)),
      limb5_S_q_next_qz = t300 * t327;
    WRITE(q_next, 15, limb5_S_q_next_qz);
    const REAL t329 = t307 * t327, limb5_S_q_next_qx = t314 * t327;
    WRITE(q_next, 13, limb5_S_q_next_qx);
    const REAL limb5_S_q_next_qw = t321 * t327;
    WRITE(q_next, 12, limb5_S_q_next_qw);
    const REAL limb5_S_q_next_qy = -t329;
    WRITE(q_next, 14, limb5_S_q_next_qy);
    REAL checked3 = limb5_S_q_next_qy;
    /* limb5_S: geometry */
    const REAL t328 = limb5_S_q_next_qz * limb5_S_q_next_qz, t330 = t329 * t329, t331 = t328 + t330,
      t332 = limb5_S_q_next_qx * limb5_S_q_next_qx, t338 = t332 + t330, t411 = t328 + t332,
      t337 = 4.0 - 2.0 * (t331 + (t332 + limb5_S_q_next_qw * limb5_S_q_next_qw)), t343 = limb5_S_q_next_qz * t337,
      t340 = param_H * (1.0 - t337 * t338), t374 = 0.5 * (1.0 - t331 * t337), t413 = 0.5 * (1.0 - t411 * t337),
      t347 = limb5_S_q_next_qw * (limb5_S_q_next_qx * t337), t341 = t329 * t337, t348 = t329 * t343,
      platform_turn_zy_2 = t347 - t348, t349 = param_H * (t347 + t348), t390 = 0.5 * platform_turn_zy_2,
      t350 = limb5_S_q_next_qw * t343, t342 = limb5_S_q_next_qw * t341, t351 = limb5_S_q_next_qx * t341,
      t344 = limb5_S_q_next_qx * t343, minus_platform_turn_xy = t350 + t351, t352 = 0.5 * (t350 - t351),
      t389 = 0.5 * minus_platform_turn_xy, minus_limb1_lower_limb_target_x_2 = t349 + t352,
      minus_limb3_lower_limb_target_x = t349 - t352;
    /* limb1: geometry; results */
    const REAL t353 = limb1_U_0_sin * minus_limb1_lower_limb_target_x_2, minus_platform_turn_xz = t342 - t344,
      t345 = 0.5 * (t342 + t344), /* platform */
      t372 = param_H * minus_platform_turn_xz, /* platform */
      limb1_lower_limb_target_y = t340 - t345, limb3_lower_limb_target_y_2 = t340 + t345,
      t358 = SELECT(LESS(-(t353 + limb1_U_0_cos * limb1_lower_limb_target_y), 0.0), (-1.0), 1.0),
      t359 = limb1_lower_limb_target_y * limb1_lower_limb_target_y,
      t361 = t359 + minus_limb1_lower_limb_target_x_2 * minus_limb1_lower_limb_target_x_2, t362 = SQRT(t361),
      t363 = t358 / t362, t379 = t358 * t362, minus_limb1_U_0_sin = minus_limb1_lower_limb_target_x_2 * t363,
      minus_limb1_U_0_cos = limb1_lower_limb_target_y * t363,
      t370 = -(limb1_U_0_sin * minus_limb1_U_0_sin + limb1_U_0_cos * minus_limb1_U_0_cos);
    RESULT(checked0, q_next, 0, READ(q, 0) + atan2(limb1_U_0_sin * minus_limb1_U_0_cos - limb1_U_0_cos * minus_limb1_U_0_sin, t370));
    const REAL limb1_lower_limb_target_z = param_R - (t372 + t374),
      minus_limb3_lower_limb_target_z = param_R + (t372 - t374),
      limb1_lower_limb_length = SQRT(limb1_lower_limb_target_z * limb1_lower_limb_target_z + t361);
    RESULT(checked1, q_next, 2, limb1_lower_limb_length - limb_upper_phase);
    const REAL t378 = 1.0 / limb1_lower_limb_length, minus_limb1_lower_cos = t378 * t379,
      limb1_lower_sin_2 = limb1_lower_limb_target_z * t378,
      t382 = limb1_lower_sin * minus_limb1_lower_cos + limb1_lower_cos * limb1_lower_sin_2;
    RESULT(checked2, q_next, 1, READ(q, 1) + atan2(t382, limb1_lower_sin * limb1_lower_sin_2 - limb1_lower_cos * minus_limb1_lower_cos));
    /* limb2: geometry; results */
    const REAL minus_limb2_lower_limb_target_x = t390 - t340, limb4_lower_limb_target_x_2 = t390 + t340,
      t388 = SINES(sine, 3), t391 = t388 * minus_limb2_lower_limb_target_x, limb2_lower_limb_target_y_2 = t389 - t372,
      minus_limb4_lower_limb_target_y = t389 + t372, t392 = SINES(cosine, 3),
      t397 = SELECT(LESS(-(t391 + t392 * limb2_lower_limb_target_y_2), 0.0), (-1.0), 1.0),
      t398 = limb2_lower_limb_target_y_2 * limb2_lower_limb_target_y_2,
      t400 = t398 + minus_limb2_lower_limb_target_x * minus_limb2_lower_limb_target_x, t401 = SQRT(t400),
      t402 = t397 / t401, t418 = t397 * t401, minus_limb2_U_0_sin = minus_limb2_lower_limb_target_x * t402,
      minus_limb2_U_0_cos_2 = limb2_lower_limb_target_y_2 * t402,
      t409 = -(t388 * minus_limb2_U_0_sin + t392 * minus_limb2_U_0_cos_2);
    RESULT(checked3, q_next, 3, READ(q, 3) + atan2(t388 * minus_limb2_U_0_cos_2 - t392 * minus_limb2_U_0_sin, t409));
    const REAL t480 = t413 - t349, /* platform */
      limb2_lower_limb_target_z = param_R - (t413 + t349), minus_limb4_lower_limb_target_z = param_R - t480,
      limb2_lower_limb_length = SQRT(limb2_lower_limb_target_z * limb2_lower_limb_target_z + t400);
    RESULT(checked0, q_next, 5, limb2_lower_limb_length - limb_upper_phase);
    const REAL t417 = 1.0 / limb2_lower_limb_length, minus_limb2_lower_cos = t417 * t418,
      limb2_lower_sin_2 = limb2_lower_limb_target_z * t417,
      t421 = limb2_lower_sin * minus_limb2_lower_cos + limb2_lower_cos * limb2_lower_sin_2;
    RESULT(checked1, q_next, 4, READ(q, 4) + atan2(t421, limb2_lower_sin * limb2_lower_sin_2 - limb2_lower_cos * minus_limb2_lower_cos));
    /* limb3: geometry; results */
    const REAL t428 = limb3_U_0_sin * minus_limb3_lower_limb_target_x + limb3_U_0_cos * limb3_lower_limb_target_y_2,
      t431 = SELECT(LESS(-t428, 0.0), (-1.0), 1.0), t432 = limb3_lower_limb_target_y_2 * limb3_lower_limb_target_y_2,
      t434 = t432 + minus_limb3_lower_limb_target_x * minus_limb3_lower_limb_target_x, t435 = SQRT(t434),
      t436 = t431 / t435, t449 = t431 * t435, minus_limb3_U_0_sin = minus_limb3_lower_limb_target_x * t436,
      minus_limb3_U_0_cos = limb3_lower_limb_target_y_2 * t436,
      t443 = -(limb3_U_0_sin * minus_limb3_U_0_sin + limb3_U_0_cos * minus_limb3_U_0_cos);
    RESULT(checked2, q_next, 6, READ(q, 6) + atan2(limb3_U_0_sin * minus_limb3_U_0_cos - limb3_U_0_cos * minus_limb3_U_0_sin, t443));
    const REAL limb3_lower_limb_length = SQRT(minus_limb3_lower_limb_target_z * minus_limb3_lower_limb_target_z + t434);
    RESULT(checked3, q_next, 8, limb3_lower_limb_length - limb_upper_phase);
    const REAL t448 = 1.0 / limb3_lower_limb_length, minus_limb3_lower_cos = t448 * t449,
      minus_limb3_lower_sin_2 = minus_limb3_lower_limb_target_z * t448,
      t453 = -(minus_limb3_lower_sin * minus_limb3_lower_cos + limb3_lower_cos * minus_limb3_lower_sin_2),
      t457 = atan2(t453, minus_limb3_lower_sin * minus_limb3_lower_sin_2 - limb3_lower_cos * minus_limb3_lower_cos);
    RESULT(checked0, q_next, 7, READ(q, 7) + t457);
    /* limb4: results; geometry */
    const REAL t460 = SINES(sine, 8), t459 = SINES(cosine, 8),
      t465 = SELECT(LESS(t460 * limb4_lower_limb_target_x_2 + t459 * minus_limb4_lower_limb_target_y, 0.0), (-1.0), 1.0),
      t466 = minus_limb4_lower_limb_target_y * minus_limb4_lower_limb_target_y,
      t468 = t466 + limb4_lower_limb_target_x_2 * limb4_lower_limb_target_x_2, t469 = SQRT(t468), t470 = t465 / t469,
      t484 = t465 * t469, t471 = limb4_lower_limb_target_x_2 * t470, t473 = minus_limb4_lower_limb_target_y * t470,
      t475 = t459 * t471 - t460 * t473;
    RESULT(checked1, q_next, 9, READ(q, 9) + atan2(t475, t460 * t471 + t459 * t473));
    const REAL limb4_lower_limb_length = SQRT(minus_limb4_lower_limb_target_z * minus_limb4_lower_limb_target_z + t468);
    RESULT(checked2, q_next, 11, limb4_lower_limb_length - limb_upper_phase);
    const REAL t483 = 1.0 / limb4_lower_limb_length, t485 = t483 * t484,
      t487 = minus_limb4_lower_limb_target_z * t483, t490 = -(minus_limb4_lower_sin * t485 + limb4_lower_cos * t487);
    RESULT(checked3, q_next, 10, READ(q, 10) + atan2(t490, minus_limb4_lower_sin * t487 - limb4_lower_cos * t485));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_limb3_U_0_lever_mz_by_limb3_S_fz, 6.62327e-13) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(minus_limb2_U_0_lever_mz_by_limb2_S_fz, 6.62327e-13) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(minus_limb4_U_0_lever_mz_by_limb4_S_fz, 6.62327e-13) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(minus_limb1_U_0_lever_mz_by_limb1_U2_fz, 6.62327e-13) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-12) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-12) OR /* where the elimination meets a singularity */
        SMALL(a_pivot_2, 1.0e-12), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

static int three_ups_upu_s_assemble_step(const double *restrict q, const double *restrict y,
    double *restrict q_next, double *restrict residual_, double *restrict step, double *restrict orientation_)
{
    double sine[12] = {0.0}, cosine[12] = {0.0};
    three_ups_upu_s_sines5(q, sine, cosine);
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
