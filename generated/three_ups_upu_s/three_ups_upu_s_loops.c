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
    const REAL t22 = 0.5 * (1.0 - t7 * t10);
    const REAL t42 = t3 + t6;
    const REAL t18 = param_H * (1.0 - t10 * (t3 + t5));
    const REAL platform_turn_yy = 1.0 - t10 * t42;
    const REAL t11 = limb5_S_q_qz * t10;
    const REAL t12 = limb5_S_q_qx * t11;
    const REAL t13 = limb5_S_q_qy * t10;
    const REAL t31 = limb5_S_q_qw * (limb5_S_q_qx * t10);
    const REAL t14 = limb5_S_q_qw * t13;
    const REAL t26 = limb5_S_q_qx * t13;
    const REAL platform_turn_zx = t12 - t14;
    const REAL t23 = param_H * (t12 + t14);
    const REAL t15 = 0.5 * platform_turn_zx;
    const REAL minus_limb1_upper_position_x_2 = t22 - t23;
    const REAL limb3_upper_position_x_2 = t22 + t23;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL t24 = param_R - limb1_lower_sin * limb1_upper_offset_x - minus_limb1_upper_position_x_2; /* limb1 */
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL t25 = limb1_lower_sin * t24; /* limb1 */
    const REAL t36 = limb1_lower_cos * t24; /* limb1 */
    const REAL t27 = limb5_S_q_qw * t11;
    const REAL t29 = limb5_S_q_qy * t11;
    const REAL platform_turn_yx = t26 + t27;
    const REAL platform_turn_xy = t26 - t27;
    const REAL t28 = 0.5 * platform_turn_yx;
    const REAL platform_turn_yz = t29 - t31;
    const REAL platform_turn_zy = t29 + t31;
    const REAL t32 = param_H * platform_turn_yz;
    /* limb1: geometry */
    const REAL limb1_U_0_sin = SINES(sine, 0);
    const REAL minus_limb1_lower_limb_target_x = t28 - t32;
    const REAL limb3_lower_limb_target_x = t28 + t32;
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    /* limb1: loop closure; geometry */
    const REAL t33 = limb1_upper_offset_x * minus_limb1_lower_rotation_yx - minus_limb1_lower_limb_target_x;
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    const REAL t35 = t25 - minus_limb1_lower_rotation_yx * t33;
    const REAL minus_limb1_lower_limb_target_y = t15 - t18;
    const REAL limb3_lower_limb_target_y = t15 + t18;
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    const REAL t19 = limb1_upper_offset_x * limb1_lower_rotation_zx + minus_limb1_lower_limb_target_y;
    const REAL limb1_U2_opening_fx = limb1_lower_rotation_zx * t19 - t35;
    WRITE(residual_, 0, limb1_U2_opening_fx);
    REAL checked0 = limb1_U2_opening_fx;
    const REAL t41 = limb1_U_0_cos * t33;
    const REAL minus_limb1_U2_opening_fy = t36 + limb1_U_0_sin * limb1_lower_sin * t33 + limb1_U_0_cos * limb1_lower_sin * t19;
    const REAL limb1_U2_opening_fy = -minus_limb1_U2_opening_fy;
    WRITE(residual_, 1, limb1_U2_opening_fy);
    REAL checked1 = limb1_U2_opening_fy;
    const REAL limb1_U2_opening_fz = limb1_U_0_sin * t19 - t41;
    WRITE(residual_, 2, limb1_U2_opening_fz);
    REAL checked2 = limb1_U2_opening_fz;
    const REAL t45 = limb1_U_0_cos * platform_turn_zy;
    const REAL t57 = 0.5 * platform_turn_zy; /* platform */
    const REAL t47 = limb1_lower_sin * (limb1_U_0_sin * platform_turn_yy - t45);
    const REAL t53 = 0.5 * platform_turn_yy; /* platform */
    const REAL limb1_U2_opening_mn = t47 + limb1_lower_cos * platform_turn_xy;
    WRITE(residual_, 3, limb1_U2_opening_mn);
    REAL checked3 = limb1_U2_opening_mn;
    const REAL t50 = 0.5 * platform_turn_xy; /* platform */
    /* limb2: geometry; loop closure */
    const REAL limb2_lower_limb_target_y = t23 - t50;
    const REAL limb4_lower_limb_target_y = t23 + t50;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    const REAL t51 = limb2_upper_offset_x * minus_limb2_lower_rotation_xx + limb2_lower_limb_target_y;
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL t52 = minus_limb2_lower_rotation_xx * t51;
    const REAL limb4_upper_position_y_2 = t32 + t53;
    /* limb2: loop closure; geometry */
    const REAL t54 = param_R - limb2_lower_sin * limb2_upper_offset_x + (t32 - t53);
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL t56 = t52 - limb2_lower_sin * t54;
    const REAL t61 = limb2_lower_cos * t54;
    const REAL limb2_lower_limb_target_x = t18 - t57;
    const REAL limb4_lower_limb_target_x = t18 + t57;
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL t58 = limb2_upper_offset_x * minus_limb2_lower_rotation_zx + limb2_lower_limb_target_x;
    RESULT(checked0, residual_, 4, t56 + minus_limb2_lower_rotation_zx * t58);
    const REAL t65 = limb2_U_0_sin * t51;
    const REAL minus_limb2_S_opening_fy = minus_limb2_U_0_cos * limb2_lower_sin * t51 + t61 + limb2_U_0_sin * limb2_lower_sin * t58;
    RESULT(checked1, residual_, 5, -minus_limb2_S_opening_fy);
    RESULT(checked2, residual_, 6, minus_limb2_U_0_cos * t58 - t65);
    /* limb3: geometry; loop closure */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL t70 = param_R - minus_limb3_lower_sin * limb3_upper_offset_x - limb3_upper_position_x_2;
    const REAL limb3_lower_cos = SINES(cosine, 5), limb3_U_0_sin = SINES(sine, 4);
    /* limb3: loop closure; geometry */
    const REAL t71 = minus_limb3_lower_sin * t70;
    const REAL t75 = limb3_lower_cos * t70;
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    const REAL t72 = limb3_upper_offset_x * minus_limb3_lower_rotation_yx + limb3_lower_limb_target_x;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    const REAL t74 = t71 - minus_limb3_lower_rotation_yx * t72;
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    const REAL t67 = limb3_upper_offset_x * limb3_lower_rotation_zx - limb3_lower_limb_target_y;
    RESULT(checked3, residual_, 7, limb3_lower_rotation_zx * t67 - t74);
    const REAL t80 = limb3_U_0_cos * t72;
    RESULT(checked0, residual_, 8, t75 + limb3_U_0_sin * minus_limb3_lower_sin * t72 + limb3_U_0_cos * minus_limb3_lower_sin * t67);
    RESULT(checked1, residual_, 9, limb3_U_0_sin * t67 - t80);
    /* limb4: geometry */
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_lower_cos = SINES(cosine, 7);
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    /* limb4: loop closure; geometry */
    const REAL t82 = limb4_upper_offset_x * minus_limb4_lower_rotation_xx + limb4_lower_limb_target_y;
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL t83 = minus_limb4_lower_rotation_xx * t82;
    const REAL t85 = param_R - minus_limb4_lower_sin * limb4_upper_offset_x - limb4_upper_position_y_2;
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    const REAL t87 = t83 - minus_limb4_lower_sin * t85;
    const REAL t91 = limb4_lower_cos * t85;
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL t88 = limb4_upper_offset_x * minus_limb4_lower_rotation_zx + limb4_lower_limb_target_x;
    RESULT(checked2, residual_, 10, t87 + minus_limb4_lower_rotation_zx * t88);
    const REAL t92 = minus_limb4_U_0_cos * minus_limb4_lower_sin * t82 + t91;
    const REAL t95 = limb4_U_0_sin * t82;
    RESULT(checked3, residual_, 11, t92 + limb4_U_0_sin * minus_limb4_lower_sin * t88);
    RESULT(checked0, residual_, 12, minus_limb4_U_0_cos * t88 - t95);
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_closure_jacobian)(size_t stride, const double *restrict q, double *restrict jacobian,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry; results; reciprocal wrenches, eq. (10) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t3 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t4 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t5 = t3 + t4;
    const REAL t6 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t7 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t8 = t6 + t7;
    const REAL t9 = t5 + t8;
    const REAL t11 = 4.0 - 2.0 * t9;
    const REAL t12 = t4 + t7;
    const REAL platform_turn_zz = 1.0 - t11 * (t4 + t6);
    const REAL platform_turn_yy = 1.0 - t11 * t12;
    const REAL platform_turn_xx = 1.0 - t8 * t11;
    const REAL t15 = limb5_S_q_qz * t11;
    const REAL t16 = limb5_S_q_qy * t15;
    const REAL t18 = limb5_S_q_qw * (limb5_S_q_qx * t11);
    const REAL t24 = limb5_S_q_qy * t11;
    const REAL platform_turn_yz = t16 - t18;
    const REAL platform_turn_zy = t16 + t18;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    WRITE(jacobian, 141, limb4_upper_offset_x);
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL t33 = limb4_lower_cos * limb4_upper_offset_x; /* limb4 */
    const REAL limb4_U_0_lever_moment_z_by_limb4_S_fz = -t33;
    WRITE(jacobian, 129, limb4_U_0_lever_moment_z_by_limb4_S_fz);
    REAL checked0 = limb4_U_0_lever_moment_z_by_limb4_S_fz;
    const REAL t177 = platform_turn_yz * t33;
    const REAL t35 = limb5_S_q_qx * t15;
    const REAL t26 = limb5_S_q_qw * t15;
    const REAL t36 = limb5_S_q_qw * t24;
    const REAL t25 = limb5_S_q_qx * t24;
    const REAL platform_turn_xz = t35 + t36;
    const REAL platform_turn_zx = t35 - t36;
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL minus_base_lever_moment_x_by_limb4_S_fz = minus_limb4_U_0_cos * limb4_upper_position_y;
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    const REAL minus_base_lever_moment_z_by_limb4_S_fz = limb4_U_0_sin * limb4_upper_position_y;
    /* mechanism: results; reciprocal wrenches, eq. (10) */
    const REAL t179 = t177 + platform_turn_xz * minus_base_lever_moment_x_by_limb4_S_fz;
    const REAL jacobian_194 = t179 + platform_turn_zz * minus_base_lever_moment_z_by_limb4_S_fz;
    WRITE(jacobian, 194, jacobian_194);
    REAL checked1 = jacobian_194;
    const REAL t88 = minus_limb4_U_0_cos * limb4_upper_offset_x; /* limb4 */
    const REAL base_lever_moment_x_by_limb4_S_fy = limb4_U_0_sin * limb4_upper_offset_x - param_R * (limb4_U_0_sin * minus_limb4_lower_sin);
    const REAL t176 = platform_turn_xz * base_lever_moment_x_by_limb4_S_fy;
    const REAL minus_base_lever_moment_z_by_limb4_S_fy = t88 - param_R * (minus_limb4_U_0_cos * minus_limb4_lower_sin);
    const REAL jacobian_193 = platform_turn_zz * minus_base_lever_moment_z_by_limb4_S_fy - t176;
    WRITE(jacobian, 193, jacobian_193);
    REAL checked2 = jacobian_193;
    const REAL minus_base_lever_moment_x_by_limb4_S_fx = param_R * (limb4_U_0_sin * limb4_lower_cos);
    const REAL t173 = platform_turn_xz * minus_base_lever_moment_x_by_limb4_S_fx;
    const REAL base_lever_moment_z_by_limb4_S_fx = param_R * (minus_limb4_U_0_cos * limb4_lower_cos);
    const REAL jacobian_192 = t173 - platform_turn_zz * base_lever_moment_z_by_limb4_S_fx;
    WRITE(jacobian, 192, jacobian_192);
    REAL checked3 = jacobian_192;
    /* limb3: geometry; reciprocal wrenches, eq. (10) */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    WRITE(jacobian, 99, limb3_upper_offset_x);
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL t31 = limb3_lower_cos * limb3_upper_offset_x;
    RESULT(checked0, jacobian, 87, -t31);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    /* mechanism: results; reciprocal wrenches, eq. (10) */
    const REAL t169 = platform_turn_xz * t31;
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL minus_base_lever_moment_y_by_limb3_S_fz = limb3_U_0_sin * limb3_upper_position_x;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    const REAL base_lever_moment_z_by_limb3_S_fz = limb3_U_0_cos * limb3_upper_position_x;
    const REAL t171 = t169 + platform_turn_yz * minus_base_lever_moment_y_by_limb3_S_fz;
    RESULT(checked1, jacobian, 191, t171 - platform_turn_zz * base_lever_moment_z_by_limb3_S_fz);
    const REAL t77 = limb3_U_0_sin * limb3_upper_offset_x; /* limb3 */
    const REAL base_lever_moment_y_by_limb3_S_fy = limb3_U_0_cos * limb3_upper_offset_x - param_R * (limb3_U_0_cos * minus_limb3_lower_sin);
    const REAL t166 = platform_turn_yz * base_lever_moment_y_by_limb3_S_fy;
    const REAL base_lever_moment_z_by_limb3_S_fy = t77 - param_R * (limb3_U_0_sin * minus_limb3_lower_sin);
    RESULT(checked2, jacobian, 190, -(t166 + platform_turn_zz * base_lever_moment_z_by_limb3_S_fy));
    const REAL minus_base_lever_moment_y_by_limb3_S_fx = param_R * (limb3_U_0_cos * limb3_lower_cos);
    const REAL t164 = platform_turn_yz * minus_base_lever_moment_y_by_limb3_S_fx;
    const REAL minus_base_lever_moment_z_by_limb3_S_fx = param_R * (limb3_U_0_sin * limb3_lower_cos);
    RESULT(checked3, jacobian, 189, t164 + platform_turn_zz * minus_base_lever_moment_z_by_limb3_S_fx);
    /* limb2: geometry; reciprocal wrenches, eq. (10) */
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    WRITE(jacobian, 57, limb2_upper_offset_x);
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL t29 = limb2_lower_cos * limb2_upper_offset_x;
    RESULT(checked0, jacobian, 45, -t29);
    const REAL limb2_lower_sin = SINES(sine, 3);
    /* mechanism: results; reciprocal wrenches, eq. (10) */
    const REAL t160 = platform_turn_yz * t29;
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL base_lever_moment_x_by_limb2_S_fz = minus_limb2_U_0_cos * minus_limb2_upper_position_y;
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL base_lever_moment_z_by_limb2_S_fz = limb2_U_0_sin * minus_limb2_upper_position_y;
    const REAL t162 = t160 - platform_turn_xz * base_lever_moment_x_by_limb2_S_fz;
    RESULT(checked1, jacobian, 188, t162 - platform_turn_zz * base_lever_moment_z_by_limb2_S_fz);
    const REAL t62 = minus_limb2_U_0_cos * limb2_upper_offset_x; /* limb2 */
    const REAL base_lever_moment_x_by_limb2_S_fy = limb2_U_0_sin * limb2_upper_offset_x - param_R * (limb2_U_0_sin * limb2_lower_sin);
    const REAL t159 = platform_turn_xz * base_lever_moment_x_by_limb2_S_fy;
    const REAL minus_base_lever_moment_z_by_limb2_S_fy = t62 - param_R * (minus_limb2_U_0_cos * limb2_lower_sin);
    RESULT(checked2, jacobian, 187, platform_turn_zz * minus_base_lever_moment_z_by_limb2_S_fy - t159);
    const REAL base_lever_moment_x_by_limb2_S_fx = param_R * (limb2_U_0_sin * limb2_lower_cos);
    const REAL t157 = platform_turn_xz * base_lever_moment_x_by_limb2_S_fx;
    const REAL minus_base_lever_moment_z_by_limb2_S_fx = param_R * (minus_limb2_U_0_cos * limb2_lower_cos);
    RESULT(checked3, jacobian, 186, platform_turn_zz * minus_base_lever_moment_z_by_limb2_S_fx - t157);
    /* limb1: geometry */
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1);
    /* limb1: reciprocal wrenches, eq. (10); geometry */
    const REAL t23 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy);
    const REAL platform_turn_xy = t25 - t26;
    const REAL platform_turn_yx = t25 + t26;
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_U2_constraint_mn_couple_z = t23 - limb1_lower_sin * platform_turn_xy;
    WRITE(jacobian, 16, limb1_U2_constraint_mn_couple_z);
    const REAL t52 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z;
    const REAL t56 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL limb1_U_0_lever_moment_y_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x;
    const REAL limb1_U_0_lever_moment_z_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    WRITE(jacobian, 3, limb1_U_0_lever_moment_z_by_limb1_U2_mn);
    const REAL base_lever_moment_y_by_limb1_U2_mn = t52 - limb1_U_0_sin * limb1_U_0_lever_moment_y_by_limb1_U2_mn;
    const REAL base_lever_moment_z_by_limb1_U2_mn = t56 + limb1_U_0_cos * limb1_U_0_lever_moment_y_by_limb1_U2_mn;
    const REAL t152 = platform_turn_yz * base_lever_moment_y_by_limb1_U2_mn; /* mechanism */
    const REAL t153 = platform_turn_xz * limb1_U_0_lever_moment_z_by_limb1_U2_mn + t152; /* mechanism */
    RESULT(checked0, jacobian, 185, -(t153 + platform_turn_zz * base_lever_moment_z_by_limb1_U2_mn));
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    WRITE(jacobian, 14, limb1_upper_offset_x);
    const REAL t2 = limb1_lower_cos * limb1_upper_offset_x;
    /* mechanism: results; reciprocal wrenches, eq. (10) */
    const REAL t147 = platform_turn_xz * t2;
    RESULT(checked1, jacobian, 2, -t2);
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL base_lever_moment_y_by_limb1_U2_fz = limb1_U_0_sin * minus_limb1_upper_position_x;
    const REAL minus_base_lever_moment_z_by_limb1_U2_fz = limb1_U_0_cos * minus_limb1_upper_position_x;
    const REAL t149 = t147 - platform_turn_yz * base_lever_moment_y_by_limb1_U2_fz;
    RESULT(checked2, jacobian, 184, t149 + platform_turn_zz * minus_base_lever_moment_z_by_limb1_U2_fz);
    const REAL t42 = limb1_U_0_sin * limb1_upper_offset_x; /* limb1 */
    const REAL base_lever_moment_y_by_limb1_U2_fy = limb1_U_0_cos * limb1_upper_offset_x - param_R * (limb1_U_0_cos * limb1_lower_sin);
    const REAL t144 = platform_turn_yz * base_lever_moment_y_by_limb1_U2_fy;
    const REAL base_lever_moment_z_by_limb1_U2_fy = t42 - param_R * (limb1_U_0_sin * limb1_lower_sin);
    RESULT(checked3, jacobian, 183, -(t144 + platform_turn_zz * base_lever_moment_z_by_limb1_U2_fy));
    const REAL base_lever_moment_y_by_limb1_U2_fx = param_R * (limb1_U_0_cos * limb1_lower_cos);
    const REAL t139 = platform_turn_yz * base_lever_moment_y_by_limb1_U2_fx;
    const REAL base_lever_moment_z_by_limb1_U2_fx = param_R * (limb1_U_0_sin * limb1_lower_cos);
    RESULT(checked0, jacobian, 182, -(t139 + platform_turn_zz * base_lever_moment_z_by_limb1_U2_fx));
    const REAL t137 = platform_turn_yy * t33 + platform_turn_xy * minus_base_lever_moment_x_by_limb4_S_fz;
    const REAL t97 = platform_turn_yx * t33 + platform_turn_xx * minus_base_lever_moment_x_by_limb4_S_fz;
    RESULT(checked1, jacobian, 181, t137 + platform_turn_zy * minus_base_lever_moment_z_by_limb4_S_fz);
    RESULT(checked2, jacobian, 168, t97 + platform_turn_zx * minus_base_lever_moment_z_by_limb4_S_fz);
    const REAL t133 = platform_turn_zy * minus_base_lever_moment_z_by_limb4_S_fy;
    const REAL t90 = platform_turn_zx * minus_base_lever_moment_z_by_limb4_S_fy;
    RESULT(checked3, jacobian, 180, t133 - platform_turn_xy * base_lever_moment_x_by_limb4_S_fy);
    RESULT(checked0, jacobian, 167, t90 - platform_turn_xx * base_lever_moment_x_by_limb4_S_fy);
    const REAL t131 = platform_turn_xy * minus_base_lever_moment_x_by_limb4_S_fx;
    const REAL t86 = platform_turn_xx * minus_base_lever_moment_x_by_limb4_S_fx;
    RESULT(checked1, jacobian, 179, t131 - platform_turn_zy * base_lever_moment_z_by_limb4_S_fx);
    RESULT(checked2, jacobian, 166, t86 - platform_turn_zx * base_lever_moment_z_by_limb4_S_fx);
    const REAL t129 = platform_turn_xy * t31 + platform_turn_yy * minus_base_lever_moment_y_by_limb3_S_fz;
    const REAL t84 = platform_turn_xx * t31 + platform_turn_yx * minus_base_lever_moment_y_by_limb3_S_fz;
    RESULT(checked3, jacobian, 178, t129 - platform_turn_zy * base_lever_moment_z_by_limb3_S_fz);
    RESULT(checked0, jacobian, 165, t84 - platform_turn_zx * base_lever_moment_z_by_limb3_S_fz);
    const REAL t125 = platform_turn_zy * base_lever_moment_z_by_limb3_S_fy;
    const REAL t79 = platform_turn_zx * base_lever_moment_z_by_limb3_S_fy;
    RESULT(checked1, jacobian, 177, -(platform_turn_yy * base_lever_moment_y_by_limb3_S_fy + t125));
    RESULT(checked2, jacobian, 164, -(platform_turn_yx * base_lever_moment_y_by_limb3_S_fy + t79));
    const REAL t123 = platform_turn_zy * minus_base_lever_moment_z_by_limb3_S_fx;
    const REAL t73 = platform_turn_zx * minus_base_lever_moment_z_by_limb3_S_fx;
    RESULT(checked3, jacobian, 176, platform_turn_yy * minus_base_lever_moment_y_by_limb3_S_fx + t123);
    RESULT(checked0, jacobian, 163, platform_turn_yx * minus_base_lever_moment_y_by_limb3_S_fx + t73);
    const REAL t120 = platform_turn_yy * t29 - platform_turn_xy * base_lever_moment_x_by_limb2_S_fz;
    const REAL t70 = platform_turn_yx * t29 - platform_turn_xx * base_lever_moment_x_by_limb2_S_fz;
    RESULT(checked1, jacobian, 175, t120 - platform_turn_zy * base_lever_moment_z_by_limb2_S_fz);
    RESULT(checked2, jacobian, 162, t70 - platform_turn_zx * base_lever_moment_z_by_limb2_S_fz);
    const REAL t116 = platform_turn_zy * minus_base_lever_moment_z_by_limb2_S_fy;
    const REAL t64 = platform_turn_zx * minus_base_lever_moment_z_by_limb2_S_fy;
    RESULT(checked3, jacobian, 174, t116 - platform_turn_xy * base_lever_moment_x_by_limb2_S_fy);
    RESULT(checked0, jacobian, 161, t64 - platform_turn_xx * base_lever_moment_x_by_limb2_S_fy);
    const REAL t114 = platform_turn_zy * minus_base_lever_moment_z_by_limb2_S_fx;
    const REAL t60 = platform_turn_zx * minus_base_lever_moment_z_by_limb2_S_fx;
    RESULT(checked1, jacobian, 173, t114 - platform_turn_xy * base_lever_moment_x_by_limb2_S_fx);
    RESULT(checked2, jacobian, 160, t60 - platform_turn_xx * base_lever_moment_x_by_limb2_S_fx);
    const REAL t110 = platform_turn_yy * base_lever_moment_y_by_limb1_U2_mn;
    const REAL t54 = platform_turn_yx * base_lever_moment_y_by_limb1_U2_mn;
    const REAL t111 = platform_turn_xy * limb1_U_0_lever_moment_z_by_limb1_U2_mn + t110;
    const REAL t105 = platform_turn_xy * t2;
    const REAL t55 = platform_turn_xx * limb1_U_0_lever_moment_z_by_limb1_U2_mn + t54;
    const REAL t47 = platform_turn_xx * t2;
    RESULT(checked3, jacobian, 172, -(t111 + platform_turn_zy * base_lever_moment_z_by_limb1_U2_mn));
    RESULT(checked0, jacobian, 159, -(t55 + platform_turn_zx * base_lever_moment_z_by_limb1_U2_mn));
    const REAL t107 = t105 - platform_turn_yy * base_lever_moment_y_by_limb1_U2_fz;
    const REAL t49 = t47 - platform_turn_yx * base_lever_moment_y_by_limb1_U2_fz;
    RESULT(checked1, jacobian, 171, t107 + platform_turn_zy * minus_base_lever_moment_z_by_limb1_U2_fz);
    RESULT(checked2, jacobian, 158, t49 + platform_turn_zx * minus_base_lever_moment_z_by_limb1_U2_fz);
    const REAL t103 = platform_turn_zy * base_lever_moment_z_by_limb1_U2_fy;
    const REAL t100 = platform_turn_zy * base_lever_moment_z_by_limb1_U2_fx;
    const REAL t44 = platform_turn_zx * base_lever_moment_z_by_limb1_U2_fy;
    const REAL t37 = platform_turn_zx * base_lever_moment_z_by_limb1_U2_fx;
    RESULT(checked3, jacobian, 170, -(platform_turn_yy * base_lever_moment_y_by_limb1_U2_fy + t103));
    RESULT(checked0, jacobian, 169, -(platform_turn_yy * base_lever_moment_y_by_limb1_U2_fx + t100));
    RESULT(checked1, jacobian, 157, -(platform_turn_yx * base_lever_moment_y_by_limb1_U2_fy + t44));
    RESULT(checked2, jacobian, 156, -(platform_turn_yx * base_lever_moment_y_by_limb1_U2_fx + t37));
    WRITE(jacobian, 0, CONSTANT(0.0));
    WRITE(jacobian, 1, CONSTANT(0.0));
    WRITE(jacobian, 15, CONSTANT(0.0));
    WRITE(jacobian, 26, CONSTANT(1.0));
    WRITE(jacobian, 69, CONSTANT(1.0));
    WRITE(jacobian, 111, CONSTANT(1.0));
    WRITE(jacobian, 153, CONSTANT(1.0));
    WRITE(jacobian, 154, CONSTANT(0.0));
    WRITE(jacobian, 155, CONSTANT(0.0));
    NOT_BELOW(t9, 0.999999, 5);
    NOT_ABOVE(t9, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_closure_bias)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t4 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t5 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t6 = t4 + t5;
    const REAL t7 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t8 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t9 = t7 + t8;
    const REAL t10 = t6 + t9;
    const REAL t12 = 4.0 - 2.0 * t10;
    const REAL t27 = t5 + t7;
    const REAL platform_turn_yy = 1.0 - t12 * (t5 + t8);
    const REAL limb5_S_v_wz = READ(v, 14), limb5_S_v_wx = READ(v, 12);
    const REAL t29 = limb5_S_v_wz * (1.0 - t12 * t27);
    const REAL t39 = limb5_S_v_wx * (1.0 - t9 * t12);
    const REAL t16 = limb5_S_q_qy * t12;
    const REAL t17 = limb5_S_q_qx * t16;
    const REAL t31 = limb5_S_q_qw * t16;
    const REAL t18 = limb5_S_q_qz * t12;
    const REAL t24 = limb5_S_q_qw * (limb5_S_q_qx * t12);
    const REAL t19 = limb5_S_q_qw * t18;
    const REAL platform_turn_yx = t17 + t19;
    const REAL platform_turn_xy = t17 - t19;
    const REAL limb5_S_v_wy = READ(v, 13);
    const REAL t21 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx;
    const REAL t22 = limb5_S_q_qy * t18;
    const REAL t30 = limb5_S_q_qx * t18;
    const REAL platform_turn_yz = t22 - t24;
    const REAL platform_turn_zy = t22 + t24;
    const REAL platform_twist_angular_y = t21 + limb5_S_v_wz * platform_turn_yz;
    /* limb1: geometry; loop closure */
    const REAL limb1_U_0_sin = SINES(sine, 0);
    const REAL t26 = limb1_U_0_sin * platform_twist_angular_y;
    const REAL t42 = limb5_S_v_wz * (t30 + t31); /* platform */
    const REAL platform_twist_angular_z = t29 + (limb5_S_v_wx * (t30 - t31) + limb5_S_v_wy * platform_turn_zy);
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    const REAL t36 = t26 - limb1_U_0_cos * platform_twist_angular_z;
    const REAL limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1);
    /* limb1: loop closure; reciprocal wrenches, eq. (10); accelerations */
    const REAL t45 = limb1_lower_cos * t36;
    const REAL t37 = limb1_lower_sin * t36;
    const REAL platform_twist_angular_x = t39 + limb5_S_v_wy * platform_turn_xy + t42;
    const REAL t47 = t45 - limb1_lower_sin * platform_twist_angular_x;
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL t48 = minus_limb1_U2_arm_y * t47;
    const REAL t44 = t37 + limb1_lower_cos * platform_twist_angular_x;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL t51 = t48 - limb1_U2_arm_x * t44;
    const REAL t52 = t44 * t51;
    const REAL t64 = t47 * t51;
    const REAL t55 = limb1_U_0_cos * platform_twist_angular_y + limb1_U_0_sin * platform_twist_angular_z;
    const REAL t56 = limb1_U2_arm_x * t55;
    const REAL t62 = minus_limb1_U2_arm_y * t55;
    const REAL limb1_U_v_0 = READ(v, 0);
    const REAL t58 = t52 - t55 * t56;
    const REAL t69 = t47 * t56;
    const REAL limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    const REAL limb1_U_v_1 = READ(v, 1);
    const REAL minus_limb1_upper_acc_still_x = limb1_upper_offset_x * (limb1_lower_omega_y * limb1_lower_omega_y + limb1_U_v_1 * limb1_U_v_1);
    const REAL limb1_U2_opening_bias_fx = -(minus_limb1_upper_acc_still_x + t58);
    WRITE(bias, 0, limb1_U2_opening_bias_fx);
    REAL checked0 = limb1_U2_opening_bias_fx;
    const REAL t65 = t55 * t62 + t64;
    const REAL t71 = t69 + t44 * t62;
    const REAL t76 = limb1_lower_omega_y - t44;
    const REAL t74 = limb1_U_v_1 - t55;
    const REAL limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    const REAL t87 = limb1_lower_omega_x + t47;
    const REAL limb1_P_v = READ(v, 2);
    const REAL t59 = limb1_upper_offset_x * (limb1_lower_omega_x * limb1_lower_omega_y);
    const REAL limb1_U2_opening_bias_fy = t59 + limb1_P_v * (2.0 * limb1_U_v_1) - t65;
    WRITE(bias, 1, limb1_U2_opening_bias_fy);
    REAL checked1 = limb1_U2_opening_bias_fy;
    const REAL t66 = limb1_upper_offset_x * (2.0 * (limb1_U_v_1 * limb1_lower_omega_x));
    const REAL t86 = limb1_lower_omega_x * t76;
    const REAL limb1_U2_opening_bias_fz = t66 - limb1_P_v * (2.0 * limb1_lower_omega_y) + t71;
    WRITE(bias, 2, limb1_U2_opening_bias_fz);
    REAL checked2 = limb1_U2_opening_bias_fz;
    const REAL t79 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t74 - limb1_U_v_1 * t76);
    const REAL t89 = t86 - limb1_lower_omega_y * t87;
    const REAL t82 = limb1_U_0_cos * platform_turn_zy;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL t80 = limb1_U2_constraint_mn_couple_x * t79;
    const REAL t83 = limb1_U_0_sin * platform_turn_yy - t82;
    const REAL t98 = limb1_U2_constraint_mn_couple_x * t76;
    const REAL t92 = limb1_lower_sin * t83;
    const REAL limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t83 - limb1_lower_sin * platform_turn_xy;
    const REAL t91 = t80 - limb1_U2_constraint_mn_couple_z * t89;
    const REAL t95 = limb1_U2_constraint_mn_couple_z * t76;
    const REAL limb1_U2_opening_mn = t92 + limb1_lower_cos * platform_turn_xy;
    const REAL t97 = t87 * (limb1_U2_opening_mn * t87 + t95);
    const REAL limb1_U2_opening_bias_mn = t91 - (t97 - t74 * (t98 - limb1_U2_opening_mn * t74));
    WRITE(bias, 3, limb1_U2_opening_bias_mn);
    REAL checked3 = limb1_U2_opening_bias_mn;
    /* limb2: geometry; loop closure */
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL t108 = limb2_U_0_sin * platform_twist_angular_z + minus_limb2_U_0_cos * platform_twist_angular_x;
    const REAL limb2_lower_cos = SINES(cosine, 3), limb2_lower_sin = SINES(sine, 3);
    /* limb2: loop closure; velocities, eq. (6); accelerations */
    const REAL t109 = limb2_lower_sin * t108;
    const REAL t114 = limb2_lower_cos * t108 - limb2_lower_sin * platform_twist_angular_y;
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL t115 = minus_limb2_S_arm_y * t114;
    const REAL t111 = t109 + limb2_lower_cos * platform_twist_angular_y;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t118 = t115 - limb2_S_arm_x * t111;
    const REAL t119 = t111 * t118;
    const REAL t131 = t114 * t118;
    const REAL t122 = minus_limb2_U_0_cos * platform_twist_angular_z - limb2_U_0_sin * platform_twist_angular_x;
    const REAL t123 = limb2_S_arm_x * t122;
    const REAL t129 = minus_limb2_S_arm_y * t122;
    const REAL limb2_U_v_0 = READ(v, 3);
    const REAL t125 = t119 - t122 * t123;
    const REAL t132 = t122 * t129 + t131;
    const REAL t138 = t114 * t123 + t111 * t129;
    const REAL limb2_lower_omega_y = limb2_U_v_0 * limb2_lower_cos;
    const REAL limb2_U_v_1 = READ(v, 4);
    const REAL minus_limb2_upper_acc_still_x = limb2_upper_offset_x * (limb2_lower_omega_y * limb2_lower_omega_y + limb2_U_v_1 * limb2_U_v_1);
    RESULT(checked0, bias, 4, -(minus_limb2_upper_acc_still_x + t125));
    const REAL limb2_lower_omega_x = limb2_U_v_0 * limb2_lower_sin;
    const REAL limb2_P_v = READ(v, 5);
    const REAL t126 = limb2_upper_offset_x * (limb2_lower_omega_x * limb2_lower_omega_y);
    const REAL t133 = limb2_upper_offset_x * (2.0 * (limb2_U_v_1 * limb2_lower_omega_x));
    RESULT(checked1, bias, 6, t133 - limb2_P_v * (2.0 * limb2_lower_omega_y) - t138);
    RESULT(checked2, bias, 5, t126 + limb2_P_v * (2.0 * limb2_U_v_1) - t132);
    /* limb3: geometry; loop closure */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    const REAL t144 = limb3_U_0_sin * platform_twist_angular_y - limb3_U_0_cos * platform_twist_angular_z;
    const REAL limb3_lower_cos = SINES(cosine, 5), minus_limb3_lower_sin = SINES(sine, 5);
    /* limb3: loop closure; velocities, eq. (6); accelerations */
    const REAL t145 = minus_limb3_lower_sin * t144;
    const REAL t150 = limb3_lower_cos * t144 + minus_limb3_lower_sin * platform_twist_angular_x;
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL t151 = limb3_S_arm_y * t150;
    const REAL t147 = t145 - limb3_lower_cos * platform_twist_angular_x;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t154 = t151 - limb3_S_arm_x * t147;
    const REAL t155 = t147 * t154;
    const REAL t164 = t150 * t154;
    const REAL t158 = limb3_U_0_cos * platform_twist_angular_y + limb3_U_0_sin * platform_twist_angular_z;
    const REAL t159 = limb3_S_arm_x * t158;
    const REAL t162 = limb3_S_arm_y * t158;
    const REAL limb3_U_v_0 = READ(v, 6);
    const REAL t161 = t155 - t158 * t159;
    const REAL t165 = t158 * t162 + t164;
    const REAL t171 = t150 * t159 + t147 * t162;
    const REAL limb3_lower_omega_y = limb3_U_v_0 * limb3_lower_cos;
    const REAL limb3_U_v_1 = READ(v, 7);
    const REAL minus_limb3_upper_acc_still_x = limb3_upper_offset_x * (limb3_lower_omega_y * limb3_lower_omega_y + limb3_U_v_1 * limb3_U_v_1);
    RESULT(checked3, bias, 7, -(minus_limb3_upper_acc_still_x + t161));
    const REAL minus_limb3_lower_omega_x = limb3_U_v_0 * minus_limb3_lower_sin;
    const REAL limb3_P_v = READ(v, 8);
    const REAL t166 = limb3_upper_offset_x * (minus_limb3_lower_omega_x * limb3_lower_omega_y);
    const REAL t172 = limb3_upper_offset_x * (2.0 * (limb3_U_v_1 * minus_limb3_lower_omega_x));
    RESULT(checked0, bias, 9, t171 - (t172 + limb3_P_v * (2.0 * limb3_lower_omega_y)));
    RESULT(checked1, bias, 8, t165 - (t166 - limb3_P_v * (2.0 * limb3_U_v_1)));
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    /* limb4: loop closure; geometry; accelerations */
    const REAL t192 = minus_limb4_U_0_cos * platform_twist_angular_z;
    const REAL t180 = limb4_U_0_sin * platform_twist_angular_z + minus_limb4_U_0_cos * platform_twist_angular_x;
    const REAL t194 = t192 - limb4_U_0_sin * platform_twist_angular_x;
    const REAL limb4_lower_cos = SINES(cosine, 7), minus_limb4_lower_sin = SINES(sine, 7);
    const REAL t181 = minus_limb4_lower_sin * t180;
    const REAL t186 = limb4_lower_cos * t180 + minus_limb4_lower_sin * platform_twist_angular_y;
    const REAL t183 = t181 - limb4_lower_cos * platform_twist_angular_y;
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL t187 = limb4_S_arm_y * t186;
    const REAL t198 = limb4_S_arm_y * t194;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t190 = t187 - limb4_S_arm_x * t183;
    const REAL t195 = limb4_S_arm_x * t194;
    const REAL limb4_U_v_0 = READ(v, 9);
    const REAL t197 = t183 * t190 - t194 * t195;
    const REAL t201 = t194 * t198 + t186 * t190;
    const REAL t210 = t186 * t195 + t183 * t198;
    const REAL limb4_lower_omega_y = limb4_U_v_0 * limb4_lower_cos;
    const REAL limb4_U_v_1 = READ(v, 10);
    const REAL minus_limb4_upper_acc_still_x = limb4_upper_offset_x * (limb4_lower_omega_y * limb4_lower_omega_y + limb4_U_v_1 * limb4_U_v_1);
    RESULT(checked2, bias, 10, -(minus_limb4_upper_acc_still_x + t197));
    const REAL minus_limb4_lower_omega_x = limb4_U_v_0 * minus_limb4_lower_sin;
    const REAL limb4_P_v = READ(v, 11);
    const REAL t202 = limb4_upper_offset_x * (minus_limb4_lower_omega_x * limb4_lower_omega_y);
    const REAL t205 = limb4_upper_offset_x * (2.0 * (limb4_U_v_1 * minus_limb4_lower_omega_x));
    RESULT(checked3, bias, 12, -(t205 + limb4_P_v * (2.0 * limb4_lower_omega_y) + t210));
    RESULT(checked0, bias, 11, t201 - (t202 - limb4_P_v * (2.0 * limb4_U_v_1)));
    NOT_BELOW(t10, 0.999999, 5);
    NOT_ABOVE(t10, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_velocity)(size_t stride, const double *restrict q, const double *restrict y_dot,
    double *restrict v, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t1 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t2 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t3 = t1 + t2;
    const REAL t4 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t5 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t6 = t4 + t5;
    const REAL t7 = t3 + t6;
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL t15 = t2 + t5;
    const REAL t116 = t2 + t4;
    const REAL t14 = 4.0 - 2.0 * t7;
    const REAL platform_turn_yy = 1.0 - t14 * t15;
    const REAL t9 = k2 - 0.5 * t7;
    const REAL platform_turn_zz = 1.0 - t14 * t116;
    const REAL platform_turn_xx = 1.0 - t6 * t14;
    const REAL t18 = limb5_S_q_qz * t14;
    const REAL t19 = limb5_S_q_qy * t18;
    const REAL t21 = limb5_S_q_qw * (limb5_S_q_qx * t14);
    const REAL t30 = limb5_S_q_qy * t14;
    const REAL platform_turn_zy = t19 + t21;
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1);
    const REAL platform_turn_yz = t19 - t21;
    const REAL t29 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy); /* limb1 */
    const REAL t31 = limb5_S_q_qx * t30;
    const REAL t106 = limb5_S_q_qw * t30;
    const REAL t32 = limb5_S_q_qw * t18;
    const REAL t105 = limb5_S_q_qx * t18;
    const REAL platform_turn_xy = t31 - t32;
    /* limb1: geometry; reciprocal wrenches, eq. (10); rates that follow */
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL platform_turn_yx = t31 + t32;
    const REAL limb1_U2_constraint_mn_couple_z = t29 - limb1_lower_sin * platform_turn_xy;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = limb1_U_0_pivot;
    const REAL t23 = 1.0 / limb1_U_0_pivot;
    const REAL t35 = limb1_lower_cos * t23;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t35;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t37 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    const REAL t40 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL t24 = minus_limb1_upper_position_x * (limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t23);
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t24;
    /* limb5_S: pivots; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t37;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL t38 = 1.0 / minus_limb5_S_pivot_wz;
    const REAL t41 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t40; /* limb1 */
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t38 * t41;
    /* limb5_S: velocities, eq. (6); geometry */
    const REAL t42 = limb5_S_q_qx * t9 * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL t10 = limb5_S_q_qw * t9;
    const REAL a_pivot = 0.5 * (t10 + t42);
    REAL checked2 = a_pivot;
    const REAL t44 = 1.0 / a_pivot;
    const REAL t53 = 0.5 * t10;
    const REAL t47 = limb5_S_q_qy * t9 * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL t45 = limb5_S_q_qz * t9;
    const REAL t50 = t44 * (0.5 * (t45 - t47));
    const REAL t54 = 0.5 * t45;
    const REAL limb5_S_y_dot_qy = READ(y_dot, 1);
    const REAL t52 = READ(y_dot, 0) - limb5_S_y_dot_qy * t50;
    const REAL a_pivot_2 = t53 + t54 * t50;
    REAL checked3 = a_pivot_2;
    const REAL limb5_S_joint_rate_wx = t52 / a_pivot_2;
    const REAL limb5_S_joint_rate_wy = t44 * (limb5_S_y_dot_qy + t54 * limb5_S_joint_rate_wx);
    const REAL limb5_S_joint_rate_wz = t38 * (t41 * limb5_S_joint_rate_wy);
    const REAL t118 = platform_turn_zz * limb5_S_joint_rate_wz;
    const REAL t119 = platform_turn_yz * limb5_S_joint_rate_wy;
    const REAL t112 = platform_turn_zy * limb5_S_joint_rate_wz;
    RESULT(checked0, v, 13, t112 + (platform_turn_yy * limb5_S_joint_rate_wy + platform_turn_xy * limb5_S_joint_rate_wx));
    const REAL t111 = platform_turn_yx * limb5_S_joint_rate_wy + platform_turn_xx * limb5_S_joint_rate_wx;
    const REAL platform_turn_zx = t105 - t106;
    RESULT(checked1, v, 14, t118 + (t119 + (t105 + t106) * limb5_S_joint_rate_wx));
    RESULT(checked2, v, 12, platform_turn_zx * limb5_S_joint_rate_wz + t111);
    /* limb4: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6);
    const REAL t103 = minus_limb4_U_0_cos * limb5_S_joint_rate_wz - limb4_U_0_sin * limb5_S_joint_rate_wx;
    const REAL limb4_lower_cos = SINES(cosine, 7);
    RESULT(checked3, v, 11, param_R * limb4_lower_cos * t103);
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL minus_limb4_upper_vel_y = (limb4_upper_offset_x - param_R * minus_limb4_lower_sin) * t103;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    checked0 = checked0 + limb4_U_0_pivot;
    const REAL t93 = 1.0 / limb4_U_0_pivot;
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    RESULT(checked1, v, 10, -(minus_limb4_upper_vel_y * (limb4_lower_cos * t93)));
    const REAL t98 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_joint_rate_wz + minus_limb4_U_0_cos * limb5_S_joint_rate_wx);
    RESULT(checked2, v, 9, limb5_S_joint_rate_wy + t93 * t98);
    /* limb3: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    const REAL t90 = limb3_U_0_sin * limb5_S_joint_rate_wz + limb3_U_0_cos * limb5_S_joint_rate_wy;
    const REAL limb3_lower_cos = SINES(cosine, 5);
    RESULT(checked3, v, 8, -(param_R * limb3_lower_cos * t90));
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_upper_vel_y = (limb3_upper_offset_x - param_R * minus_limb3_lower_sin) * t90;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    checked0 = checked0 + limb3_U_0_pivot;
    const REAL t80 = 1.0 / limb3_U_0_pivot;
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    RESULT(checked1, v, 7, limb3_upper_vel_y * (limb3_lower_cos * t80));
    const REAL t85 = limb3_upper_position_x * (limb3_U_0_cos * limb5_S_joint_rate_wz - limb3_U_0_sin * limb5_S_joint_rate_wy);
    RESULT(checked2, v, 6, limb5_S_joint_rate_wx - t80 * t85);
    /* limb2: geometry; velocities, eq. (6); reciprocal wrenches, eq. (10) */
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2);
    const REAL t77 = minus_limb2_U_0_cos * limb5_S_joint_rate_wz - limb2_U_0_sin * limb5_S_joint_rate_wx;
    const REAL limb2_lower_cos = SINES(cosine, 3);
    RESULT(checked3, v, 5, -(param_R * limb2_lower_cos * t77));
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL minus_limb2_upper_vel_y = (limb2_upper_offset_x - param_R * limb2_lower_sin) * t77;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    checked0 = checked0 + limb2_U_0_pivot;
    const REAL t68 = 1.0 / limb2_U_0_pivot;
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    RESULT(checked1, v, 4, -(minus_limb2_upper_vel_y * (limb2_lower_cos * t68)));
    const REAL t72 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_joint_rate_wz + minus_limb2_U_0_cos * limb5_S_joint_rate_wx);
    RESULT(checked2, v, 3, limb5_S_joint_rate_wy - t68 * t72);
    const REAL t59 = limb1_U_0_cos * limb5_S_joint_rate_wz; /* limb1 */
    const REAL t66 = limb1_U_0_sin * limb5_S_joint_rate_wz + limb1_U_0_cos * limb5_S_joint_rate_wy; /* limb1 */
    RESULT(checked3, v, 1, t35 * (limb1_U2_arm_x * t66));
    RESULT(checked0, v, 0, limb5_S_joint_rate_wx + t23 * (minus_limb1_upper_position_x * (t59 - limb1_U_0_sin * limb5_S_joint_rate_wy)));
    RESULT(checked1, v, 2, param_R * limb1_lower_cos * t66);
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        SMALL(minus_limb5_S_pivot_wz, 1.0e-09) OR /* where the loops no longer determine limb5_S.wz */
        SMALL(a_pivot, 1.0e-09) OR /* where the elimination meets a singularity */
        SMALL(a_pivot_2, 1.0e-09), /* where the elimination meets a singularity */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_null_space)(size_t stride, const double *restrict q, double *restrict null_space,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb5_S: rates that follow */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t1 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t2 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t3 = t1 + t2;
    const REAL t4 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t5 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t6 = t4 + t5;
    const REAL t7 = t3 + t6;
    /* limb5_S: geometry; rates that follow */
    const REAL t18 = t2 + t5;
    const REAL t117 = t2 + t4;
    const REAL t17 = 4.0 - 2.0 * t7;
    const REAL platform_turn_yy = 1.0 - t17 * t18;
    const REAL t9 = k2 - 0.5 * t7;
    const REAL platform_turn_zz = 1.0 - t17 * t117;
    const REAL platform_turn_xx = 1.0 - t6 * t17;
    const REAL t21 = limb5_S_q_qz * t17;
    const REAL t22 = limb5_S_q_qy * t21;
    const REAL t24 = limb5_S_q_qw * (limb5_S_q_qx * t17);
    const REAL t33 = limb5_S_q_qy * t17;
    const REAL platform_turn_zy = t22 + t24;
    const REAL platform_turn_yz = t22 - t24;
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1);
    const REAL t32 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy); /* limb1 */
    const REAL t34 = limb5_S_q_qx * t33;
    const REAL t107 = limb5_S_q_qw * t33;
    const REAL t35 = limb5_S_q_qw * t21;
    const REAL t106 = limb5_S_q_qx * t21;
    const REAL platform_turn_xy = t34 - t35;
    const REAL platform_turn_yx = t34 + t35;
    /* limb1: geometry; reciprocal wrenches, eq. (10); rates that follow */
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_U2_constraint_mn_couple_z = t32 - limb1_lower_sin * platform_turn_xy;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = limb1_U_0_pivot;
    const REAL t26 = 1.0 / limb1_U_0_pivot;
    const REAL t38 = limb1_lower_cos * t26;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t38;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t40 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    const REAL t43 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL t27 = minus_limb1_upper_position_x * (limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t26);
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t27;
    /* limb5_S: pivots */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t40;
    REAL checked1 = minus_limb5_S_pivot_wz;
    /* limb5_S: rates that follow; geometry */
    const REAL t41 = 1.0 / minus_limb5_S_pivot_wz;
    const REAL t44 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t43; /* limb1 */
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t41 * t44;
    const REAL t45 = limb5_S_q_qx * t9 * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL t10 = limb5_S_q_qw * t9;
    const REAL a_pivot = 0.5 * (t10 + t45);
    REAL checked2 = a_pivot;
    const REAL t47 = 1.0 / a_pivot;
    const REAL t11 = 0.5 * t10;
    const REAL t49 = limb5_S_q_qy * t9 * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL t12 = limb5_S_q_qz * t9;
    const REAL t52 = t47 * (0.5 * (t12 - t49));
    const REAL t13 = 0.5 * t12;
    const REAL a_pivot_2 = t11 + t13 * t52;
    REAL checked3 = a_pivot_2;
    const REAL limb5_S_null_space_wx_by_limb5_S_qx = 1.0 / a_pivot_2;
    const REAL t123 = t52 * limb5_S_null_space_wx_by_limb5_S_qx;
    const REAL limb5_S_null_space_wy_by_limb5_S_qy = t47 * (1.0 - t13 * t123);
    const REAL limb5_S_null_space_wy_by_limb5_S_qx = t47 * (t13 * limb5_S_null_space_wx_by_limb5_S_qx);
    const REAL limb5_S_null_space_wz_by_limb5_S_qy = t41 * (t44 * limb5_S_null_space_wy_by_limb5_S_qy);
    const REAL limb5_S_null_space_wz_by_limb5_S_qx = t41 * (t44 * limb5_S_null_space_wy_by_limb5_S_qx);
    const REAL t171 = platform_turn_zz * limb5_S_null_space_wz_by_limb5_S_qy;
    const REAL t119 = platform_turn_zz * limb5_S_null_space_wz_by_limb5_S_qx;
    const REAL t172 = platform_turn_yz * limb5_S_null_space_wy_by_limb5_S_qy;
    const REAL t120 = platform_turn_yz * limb5_S_null_space_wy_by_limb5_S_qx;
    const REAL platform_turn_xz = t106 + t107;
    const REAL platform_turn_zx = t106 - t107;
    RESULT(checked0, null_space, 29, t171 + (t172 - platform_turn_xz * t123));
    RESULT(checked1, null_space, 14, t119 + (t120 + platform_turn_xz * limb5_S_null_space_wx_by_limb5_S_qx));
    const REAL t167 = platform_turn_zy * limb5_S_null_space_wz_by_limb5_S_qy;
    const REAL t113 = platform_turn_zy * limb5_S_null_space_wz_by_limb5_S_qx;
    const REAL t114 = platform_turn_yy * limb5_S_null_space_wy_by_limb5_S_qx;
    RESULT(checked2, null_space, 28, t167 + (platform_turn_yy * limb5_S_null_space_wy_by_limb5_S_qy - platform_turn_xy * t123));
    RESULT(checked3, null_space, 13, t113 + (t114 + platform_turn_xy * limb5_S_null_space_wx_by_limb5_S_qx));
    const REAL t163 = platform_turn_zx * limb5_S_null_space_wz_by_limb5_S_qy;
    const REAL t108 = platform_turn_zx * limb5_S_null_space_wz_by_limb5_S_qx;
    const REAL t109 = platform_turn_yx * limb5_S_null_space_wy_by_limb5_S_qx;
    RESULT(checked0, null_space, 27, t163 + (platform_turn_yx * limb5_S_null_space_wy_by_limb5_S_qy - platform_turn_xx * t123));
    RESULT(checked1, null_space, 12, t108 + (t109 + platform_turn_xx * limb5_S_null_space_wx_by_limb5_S_qx));
    /* limb4: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6);
    const REAL t161 = minus_limb4_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qy + limb4_U_0_sin * t123;
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    RESULT(checked2, null_space, 26, limb4_S_arm_y * t161);
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t162 = limb4_S_arm_x * t161;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    checked3 = checked3 + limb4_U_0_pivot;
    const REAL t93 = 1.0 / limb4_U_0_pivot;
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL t100 = limb4_lower_cos * t93;
    RESULT(checked0, null_space, 25, -(t100 * t162));
    const REAL t157 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qy - minus_limb4_U_0_cos * t123);
    RESULT(checked1, null_space, 24, limb5_S_null_space_wy_by_limb5_S_qy + t93 * t157);
    /* limb3: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    const REAL t150 = limb3_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qy;
    const REAL t152 = t150 + limb3_U_0_cos * limb5_S_null_space_wy_by_limb5_S_qy;
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    RESULT(checked2, null_space, 23, -(limb3_S_arm_y * t152));
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t153 = limb3_S_arm_x * t152;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    checked3 = checked3 + limb3_U_0_pivot;
    const REAL t79 = 1.0 / limb3_U_0_pivot;
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL t86 = limb3_lower_cos * t79;
    RESULT(checked0, null_space, 22, t86 * t153);
    const REAL t145 = limb3_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qy;
    const REAL t149 = t79 * (limb3_upper_position_x * (t145 - limb3_U_0_sin * limb5_S_null_space_wy_by_limb5_S_qy));
    RESULT(checked1, null_space, 21, -(t123 + t149));
    /* limb2: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2);
    const REAL t143 = minus_limb2_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qy + limb2_U_0_sin * t123;
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    RESULT(checked2, null_space, 20, -(minus_limb2_S_arm_y * t143));
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t144 = limb2_S_arm_x * t143;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    checked3 = checked3 + limb2_U_0_pivot;
    const REAL t66 = 1.0 / limb2_U_0_pivot;
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL t72 = limb2_lower_cos * t66;
    RESULT(checked0, null_space, 19, -(t72 * t144));
    const REAL t139 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qy - minus_limb2_U_0_cos * t123);
    RESULT(checked1, null_space, 18, limb5_S_null_space_wy_by_limb5_S_qy - t66 * t139);
    /* limb1: rates that follow; reciprocal wrenches, eq. (10) */
    const REAL t132 = limb1_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qy;
    const REAL t127 = limb1_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qy;
    const REAL t134 = t132 + limb1_U_0_cos * limb5_S_null_space_wy_by_limb5_S_qy;
    const REAL t131 = t26 * (minus_limb1_upper_position_x * (t127 - limb1_U_0_sin * limb5_S_null_space_wy_by_limb5_S_qy));
    RESULT(checked2, null_space, 15, t131 - t123);
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    RESULT(checked3, null_space, 17, minus_limb1_U2_arm_y * t134);
    RESULT(checked0, null_space, 16, t38 * (limb1_U2_arm_x * t134));
    const REAL t102 = minus_limb4_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qx; /* limb4 */
    const REAL t104 = t102 - limb4_U_0_sin * limb5_S_null_space_wx_by_limb5_S_qx; /* limb4 */
    RESULT(checked1, null_space, 11, limb4_S_arm_y * t104);
    RESULT(checked2, null_space, 10, -(t100 * (limb4_S_arm_x * t104)));
    const REAL t95 = limb4_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qx; /* limb4 */
    const REAL t99 = t93 * (limb4_upper_position_y * (t95 + minus_limb4_U_0_cos * limb5_S_null_space_wx_by_limb5_S_qx)); /* limb4 */
    RESULT(checked3, null_space, 9, limb5_S_null_space_wy_by_limb5_S_qx + t99);
    const REAL t88 = limb3_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qx; /* limb3 */
    const REAL t90 = t88 + limb3_U_0_cos * limb5_S_null_space_wy_by_limb5_S_qx; /* limb3 */
    RESULT(checked0, null_space, 8, -(limb3_S_arm_y * t90));
    RESULT(checked1, null_space, 7, t86 * (limb3_S_arm_x * t90));
    const REAL t81 = limb3_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qx; /* limb3 */
    RESULT(checked2, null_space, 6, limb5_S_null_space_wx_by_limb5_S_qx - t79 * (limb3_upper_position_x * (t81 - limb3_U_0_sin * limb5_S_null_space_wy_by_limb5_S_qx)));
    const REAL t74 = minus_limb2_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qx; /* limb2 */
    const REAL t76 = t74 - limb2_U_0_sin * limb5_S_null_space_wx_by_limb5_S_qx; /* limb2 */
    RESULT(checked3, null_space, 5, -(minus_limb2_S_arm_y * t76));
    RESULT(checked0, null_space, 4, -(t72 * (limb2_S_arm_x * t76)));
    const REAL t67 = limb2_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qx; /* limb2 */
    const REAL t70 = minus_limb2_upper_position_y * (t67 + minus_limb2_U_0_cos * limb5_S_null_space_wx_by_limb5_S_qx); /* limb2 */
    RESULT(checked1, null_space, 3, limb5_S_null_space_wy_by_limb5_S_qx - t66 * t70);
    const REAL t61 = limb1_U_0_sin * limb5_S_null_space_wz_by_limb5_S_qx;
    const REAL t56 = limb1_U_0_cos * limb5_S_null_space_wz_by_limb5_S_qx;
    const REAL t63 = t61 + limb1_U_0_cos * limb5_S_null_space_wy_by_limb5_S_qx;
    RESULT(checked2, null_space, 2, minus_limb1_U2_arm_y * t63);
    RESULT(checked3, null_space, 1, t38 * (limb1_U2_arm_x * t63));
    const REAL t60 = t26 * (minus_limb1_upper_position_x * (t56 - limb1_U_0_sin * limb5_S_null_space_wy_by_limb5_S_qx));
    RESULT(checked0, null_space, 0, limb5_S_null_space_wx_by_limb5_S_qx + t60);
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
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
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t1 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t2 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t3 = t1 + t2;
    const REAL t4 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t5 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t6 = t4 + t5;
    const REAL t7 = t3 + t6;
    /* limb5_S: geometry; accelerations; velocities, eq. (6) */
    const REAL t15 = t2 + t5;
    const REAL t65 = t2 + t4;
    const REAL t14 = 4.0 - 2.0 * t7;
    const REAL platform_turn_yy = 1.0 - t14 * t15;
    const REAL platform_turn_zz = 1.0 - t14 * t65;
    const REAL platform_turn_xx = 1.0 - t6 * t14;
    const REAL t9 = k2 - 0.5 * t7;
    const REAL t30 = limb5_S_q_qy * t14;
    const REAL t31 = limb5_S_q_qx * t30;
    const REAL t60 = limb5_S_q_qw * t30;
    const REAL t18 = limb5_S_q_qz * t14;
    const REAL t21 = limb5_S_q_qw * (limb5_S_q_qx * t14);
    const REAL t32 = limb5_S_q_qw * t18;
    const REAL platform_turn_yx = t31 + t32;
    const REAL platform_turn_xy = t31 - t32;
    const REAL limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13);
    const REAL t53 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx;
    const REAL t19 = limb5_S_q_qy * t18;
    const REAL t59 = limb5_S_q_qx * t18;
    const REAL platform_turn_yz = t19 - t21;
    const REAL platform_turn_zy = t19 + t21;
    const REAL limb5_S_v_wz = READ(v, 14);
    const REAL platform_twist_angular_y = t53 + limb5_S_v_wz * platform_turn_yz;
    const REAL limb1_U_0_sin = SINES(sine, 0);
    const REAL t104 = limb1_U_0_sin * platform_twist_angular_y;
    const REAL platform_turn_zx = t59 - t60;
    const REAL platform_turn_xz = t59 + t60;
    const REAL t70 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy;
    const REAL platform_twist_angular_z = limb5_S_v_wz * platform_turn_zz + t70;
    /* limb1: geometry; loop closure; accelerations */
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    const REAL t106 = t104 - limb1_U_0_cos * platform_twist_angular_z; /* limb5_S */
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL t117 = limb1_lower_sin * t106;
    const REAL t58 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy; /* platform */
    const REAL platform_twist_angular_x = t58 + limb5_S_v_wz * platform_turn_xz;
    const REAL limb1_lower_cos = SINES(cosine, 1), limb1_U_v_0 = READ(v, 0);
    const REAL t119 = t117 + limb1_lower_cos * platform_twist_angular_x;
    const REAL limb1_lower_omega_y = limb1_U_v_0 * limb1_lower_cos;
    /* limb1: loop closure; accelerations; reciprocal wrenches, eq. (10) */
    const REAL t120 = limb1_lower_omega_y - t119;
    const REAL limb1_U_v_1 = READ(v, 1);
    const REAL t121 = limb1_U_v_1 * t120;
    const REAL t95 = limb1_U_0_cos * platform_twist_angular_y + limb1_U_0_sin * platform_twist_angular_z; /* limb5_S */
    const REAL t115 = limb1_U_v_1 - t95;
    const REAL t123 = limb1_U_v_1 * limb1_lower_omega_y - (limb1_lower_omega_y * t115 - t121);
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL t124 = limb1_U2_constraint_mn_couple_x * t123;
    const REAL limb1_lower_omega_x = limb1_U_v_0 * limb1_lower_sin;
    const REAL t125 = limb1_lower_omega_x * t120;
    const REAL t129 = limb1_lower_omega_x + (limb1_lower_cos * t106 - limb1_lower_sin * platform_twist_angular_x);
    const REAL t131 = t125 - limb1_lower_omega_y * t129;
    const REAL t28 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy;
    const REAL t134 = limb1_lower_sin * t28;
    const REAL limb1_U2_constraint_mn_couple_z = limb1_lower_cos * t28 - limb1_lower_sin * platform_turn_xy;
    const REAL t133 = t124 - limb1_U2_constraint_mn_couple_z * t131;
    const REAL limb1_U2_opening_mn = t134 + limb1_lower_cos * platform_turn_xy;
    const REAL t139 = t129 * (limb1_U2_opening_mn * t129 + limb1_U2_constraint_mn_couple_z * t120);
    const REAL limb1_U2_opening_bias_mn = t133 - (t139 - t115 * (limb1_U2_constraint_mn_couple_x * t120 - limb1_U2_opening_mn * t115));
    const REAL t145 = limb1_U_v_0 * t106; /* limb5_S */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL limb1_P_v = READ(v, 2);
    const REAL t148 = limb1_U2_arm_x * t145 + limb1_U_v_1 * limb1_P_v; /* limb5_S */
    const REAL t107 = limb1_U_v_1 * limb1_lower_cos;
    const REAL t152 = t148 - t95 * (limb1_P_v - param_R * t107); /* limb5_S */
    const REAL t108 = limb1_upper_offset_x * t107;
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = limb1_U_0_pivot;
    const REAL t23 = 1.0 / limb1_U_0_pivot;
    const REAL t35 = limb1_lower_cos * t23;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t35;
    const REAL t154 = limb1_U2_opening_bias_mn - t152 * limb1_U_factor_1_by_3; /* limb5_S */
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL t96 = limb1_U_v_0 * t95; /* limb5_S */
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t97 = minus_limb1_upper_position_x * t96; /* limb5_S */
    const REAL t98 = limb1_U_v_1 * limb1_lower_sin;
    const REAL t204 = t95 * (param_R * t98);
    const REAL t101 = limb1_upper_offset_x * t98 - limb1_P_v * limb1_lower_cos;
    /* limb5_S: accelerations; pivots; rates that follow */
    const REAL t112 = platform_twist_angular_x * t101;
    const REAL t111 = t97 - limb1_U_v_0 * t101 - t106 * (limb1_P_v * limb1_lower_sin + t108);
    const REAL t113 = t111 + t112;
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t23;
    const REAL limb1_U_0_lever_moment_y_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x;
    const REAL t155 = minus_limb1_U_factor_0_by_3 * t113 - t154;
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_moment_y_by_limb1_U2_mn - minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3;
    const REAL t40 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3; /* limb1 */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL t38 = 1.0 / minus_limb5_S_pivot_wz;
    const REAL minus_limb5_S_joint_acc_still_wz = t38 * t155;
    const REAL t41 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t40; /* limb1 */
    const REAL t11 = limb5_S_q_qx * t9;
    const REAL t157 = 0.5 * (t11 * minus_limb5_S_joint_acc_still_wz);
    const REAL t45 = limb5_S_q_qz * t9;
    const REAL t76 = platform_twist_angular_y * t45;
    const REAL t46 = limb5_S_q_qy * t9;
    const REAL t10 = limb5_S_q_qw * t9;
    const REAL t81 = platform_twist_angular_z * (0.5 * (platform_twist_angular_x * t10 + (t76 - platform_twist_angular_z * t46)));
    const REAL t85 = platform_twist_angular_x * t46 - platform_twist_angular_y * t11;
    const REAL t87 = 0.5 * (platform_twist_angular_z * t10 + t85);
    const REAL t89 = t81 - platform_twist_angular_x * t87;
    const REAL t161 = platform_twist_angular_y * t87;
    const REAL t64 = platform_twist_angular_x * t11 + platform_twist_angular_y * t46;
    const REAL t73 = 0.5 * (t64 + platform_twist_angular_z * t45);
    const REAL t158 = READ(y_ddot, 1) + 0.5 * (platform_twist_angular_y * t73 - t89) + t157;
    const REAL t160 = platform_twist_angular_x * t73;
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t38 * t41;
    const REAL a_pivot = 0.5 * (t10 + t11 * limb5_S_null_space_wz_by_limb5_S_wy);
    REAL checked2 = a_pivot;
    const REAL t44 = 1.0 / a_pivot;
    const REAL t50 = t44 * (0.5 * (t45 - t46 * limb5_S_null_space_wz_by_limb5_S_wy));
    const REAL t174 = 0.5 * (t46 * minus_limb5_S_joint_acc_still_wz);
    const REAL t159 = t50 * t158;
    const REAL t165 = platform_twist_angular_z * t11 - platform_twist_angular_x * t45;
    const REAL t178 = 0.5 * t45;
    const REAL t179 = t178 * t50;
    const REAL t170 = t160 - (t161 - platform_twist_angular_z * (0.5 * (platform_twist_angular_y * t10 + t165)));
    const REAL t176 = t159 - (READ(y_ddot, 0) + 0.5 * t170 - t174);
    const REAL a_pivot_2 = 0.5 * t10 + t179;
    REAL checked3 = a_pivot_2;
    const REAL minus_limb5_S_joint_acc_wx = t176 / a_pivot_2;
    const REAL limb5_S_joint_acc_wy = t44 * (t158 - t178 * minus_limb5_S_joint_acc_wx);
    /* limb1: accelerations; reciprocal wrenches, eq. (10) */
    const REAL t183 = t38 * (t41 * limb5_S_joint_acc_wy);
    const REAL t379 = platform_turn_yx * limb5_S_joint_acc_wy - platform_turn_xx * minus_limb5_S_joint_acc_wx; /* limb5_S */
    const REAL t383 = platform_turn_yy * limb5_S_joint_acc_wy - platform_turn_xy * minus_limb5_S_joint_acc_wx; /* limb5_S */
    const REAL t387 = platform_turn_yz * limb5_S_joint_acc_wy - platform_turn_xz * minus_limb5_S_joint_acc_wx; /* limb5_S */
    const REAL t188 = t23 * (minus_limb1_upper_position_x * (limb1_U_0_cos * t183 - limb1_U_0_sin * limb5_S_joint_acc_wy));
    const REAL t189 = minus_limb5_S_joint_acc_wx - t188;
    const REAL minus_limb1_U_joint_acc_still_0 = t23 * (t113 + minus_limb1_upper_position_x * (limb1_U_0_cos * minus_limb5_S_joint_acc_still_wz));
    RESULT(checked0, a, 0, -(t189 + minus_limb1_U_joint_acc_still_0));
    const REAL t195 = limb1_U_0_sin * t183 + limb1_U_0_cos * limb5_S_joint_acc_wy;
    const REAL t196 = limb1_U2_arm_x * t195;
    const REAL t197 = limb1_U_0_sin * minus_limb5_S_joint_acc_still_wz;
    RESULT(checked1, a, 1, t35 * (t196 - (t152 + limb1_U2_arm_x * t197)));
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    RESULT(checked2, a, 2, minus_limb1_U2_arm_y * t195 - (minus_limb1_U2_arm_y * t145 + t204 + minus_limb1_U2_arm_y * t197));
    /* limb2: geometry; accelerations */
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL t211 = limb2_U_0_sin * t183 - minus_limb2_U_0_cos * minus_limb5_S_joint_acc_wx;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL limb2_lower_cos = SINES(cosine, 3);
    /* limb2: accelerations; reciprocal wrenches, eq. (10) */
    const REAL t212 = minus_limb2_upper_position_y * t211;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    checked3 = checked3 + limb2_U_0_pivot;
    const REAL t208 = 1.0 / limb2_U_0_pivot;
    const REAL t214 = limb5_S_joint_acc_wy - t208 * t212;
    const REAL t237 = minus_limb2_upper_position_y * (limb2_U_0_sin * minus_limb5_S_joint_acc_still_wz);
    const REAL t217 = minus_limb2_U_0_cos * platform_twist_angular_z - limb2_U_0_sin * platform_twist_angular_x;
    const REAL limb2_U_v_0 = READ(v, 3), limb2_U_v_1 = READ(v, 4);
    const REAL t219 = minus_limb2_upper_position_y * (limb2_U_v_0 * t217);
    const REAL t220 = limb2_U_v_1 * limb2_lower_sin;
    const REAL limb2_P_v = READ(v, 5);
    const REAL t260 = t217 * (param_R * t220);
    const REAL t223 = limb2_upper_offset_x * t220 - limb2_P_v * limb2_lower_cos;
    const REAL t225 = t219 + limb2_U_v_0 * t223;
    const REAL t234 = platform_twist_angular_y * t223;
    const REAL t228 = limb2_U_0_sin * platform_twist_angular_z + minus_limb2_U_0_cos * platform_twist_angular_x;
    const REAL t229 = limb2_U_v_1 * limb2_lower_cos;
    const REAL t251 = t217 * (limb2_P_v - param_R * t229);
    const REAL t235 = t225 + t228 * (limb2_P_v * limb2_lower_sin + limb2_upper_offset_x * t229) - t234;
    RESULT(checked0, a, 3, t214 + t208 * (t235 + t237));
    const REAL t245 = limb2_U_v_0 * t228;
    const REAL t239 = limb2_lower_cos * t208;
    const REAL t243 = minus_limb2_U_0_cos * t183 + limb2_U_0_sin * minus_limb5_S_joint_acc_wx;
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t244 = limb2_S_arm_x * t243;
    const REAL t253 = minus_limb2_U_0_cos * minus_limb5_S_joint_acc_still_wz;
    const REAL t255 = limb2_S_arm_x * t245 + limb2_U_v_1 * limb2_P_v + t251 - limb2_S_arm_x * t253;
    RESULT(checked1, a, 4, -(t239 * (t244 + t255)));
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL minus_limb2_P_joint_acc = minus_limb2_S_arm_y * t243 + (minus_limb2_S_arm_y * t245 - t260 - minus_limb2_S_arm_y * t253);
    RESULT(checked2, a, 5, -minus_limb2_P_joint_acc);
    /* limb3: geometry; accelerations */
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_0_sin = SINES(sine, 4);
    const REAL t292 = limb3_U_0_cos * t183 - limb3_U_0_sin * limb5_S_joint_acc_wy;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL limb3_lower_cos = SINES(cosine, 5);
    /* limb3: accelerations; reciprocal wrenches, eq. (10) */
    const REAL t293 = limb3_upper_position_x * t292;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    checked3 = checked3 + limb3_U_0_pivot;
    const REAL t264 = 1.0 / limb3_U_0_pivot;
    const REAL t295 = minus_limb5_S_joint_acc_wx + t264 * t293;
    const REAL t288 = limb3_upper_position_x * (limb3_U_0_cos * minus_limb5_S_joint_acc_still_wz);
    const REAL t268 = limb3_U_0_cos * platform_twist_angular_y + limb3_U_0_sin * platform_twist_angular_z;
    const REAL limb3_U_v_0 = READ(v, 6), limb3_U_v_1 = READ(v, 7);
    const REAL t270 = limb3_upper_position_x * (limb3_U_v_0 * t268);
    const REAL t271 = limb3_U_v_1 * minus_limb3_lower_sin;
    const REAL limb3_P_v = READ(v, 8);
    const REAL t316 = t268 * (param_R * t271);
    const REAL t274 = limb3_upper_offset_x * t271 + limb3_P_v * limb3_lower_cos;
    const REAL t276 = t270 - limb3_U_v_0 * t274;
    const REAL t285 = platform_twist_angular_x * t274;
    const REAL t279 = limb3_U_0_sin * platform_twist_angular_y - limb3_U_0_cos * platform_twist_angular_z;
    const REAL t280 = limb3_U_v_1 * limb3_lower_cos;
    const REAL t308 = t268 * (limb3_P_v + param_R * t280);
    const REAL t286 = t276 - t279 * (limb3_P_v * minus_limb3_lower_sin - limb3_upper_offset_x * t280) + t285;
    RESULT(checked0, a, 6, t264 * (t286 + t288) - t295);
    const REAL t302 = limb3_U_v_0 * t279;
    const REAL t296 = limb3_lower_cos * t264;
    const REAL t300 = limb3_U_0_sin * t183 + limb3_U_0_cos * limb5_S_joint_acc_wy;
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t301 = limb3_S_arm_x * t300;
    const REAL t310 = limb3_U_0_sin * minus_limb5_S_joint_acc_still_wz;
    const REAL t312 = limb3_S_arm_x * t302 + limb3_U_v_1 * limb3_P_v - t308 + limb3_S_arm_x * t310;
    RESULT(checked1, a, 7, t296 * (t301 - t312));
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    RESULT(checked2, a, 8, limb3_S_arm_y * t302 - t316 + limb3_S_arm_y * t310 - limb3_S_arm_y * t300);
    /* limb4: geometry; accelerations */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL t325 = limb4_U_0_sin * t183 - minus_limb4_U_0_cos * minus_limb5_S_joint_acc_wx;
    const REAL t356 = limb4_U_0_sin * minus_limb5_S_joint_acc_wx;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL limb4_lower_cos = SINES(cosine, 7);
    /* limb4: accelerations; reciprocal wrenches, eq. (10) */
    const REAL t326 = limb4_upper_position_y * t325;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    checked3 = checked3 + limb4_U_0_pivot;
    const REAL t321 = 1.0 / limb4_U_0_pivot;
    const REAL t328 = limb5_S_joint_acc_wy + t321 * t326;
    const REAL t351 = limb4_upper_position_y * (limb4_U_0_sin * minus_limb5_S_joint_acc_still_wz);
    const REAL t340 = limb4_U_0_sin * platform_twist_angular_z;
    const REAL t331 = minus_limb4_U_0_cos * platform_twist_angular_z - limb4_U_0_sin * platform_twist_angular_x;
    const REAL t342 = t340 + minus_limb4_U_0_cos * platform_twist_angular_x;
    const REAL limb4_U_v_0 = READ(v, 9), limb4_U_v_1 = READ(v, 10);
    const REAL t333 = limb4_upper_position_y * (limb4_U_v_0 * t331);
    const REAL t334 = limb4_U_v_1 * minus_limb4_lower_sin;
    const REAL limb4_P_v = READ(v, 11);
    const REAL t374 = t331 * (param_R * t334);
    const REAL t337 = limb4_upper_offset_x * t334 + limb4_P_v * limb4_lower_cos;
    const REAL t348 = platform_twist_angular_y * t337;
    const REAL t339 = t333 + limb4_U_v_0 * t337;
    const REAL t343 = limb4_U_v_1 * limb4_lower_cos;
    const REAL t365 = t331 * (limb4_P_v + param_R * t343);
    const REAL t349 = t339 + t342 * (limb4_P_v * minus_limb4_lower_sin - limb4_upper_offset_x * t343) - t348;
    RESULT(checked0, a, 9, t328 - t321 * (t349 + t351));
    const REAL t359 = limb4_U_v_0 * t342;
    const REAL t353 = limb4_lower_cos * t321;
    const REAL t357 = minus_limb4_U_0_cos * t183 + t356;
    const REAL minus_limb5_S_joint_acc_wz = minus_limb5_S_joint_acc_still_wz - t183;
    const REAL t367 = minus_limb4_U_0_cos * minus_limb5_S_joint_acc_still_wz;
    RESULT(checked1, a, 12, t379 - platform_turn_zx * minus_limb5_S_joint_acc_wz);
    RESULT(checked2, a, 13, t383 - platform_turn_zy * minus_limb5_S_joint_acc_wz);
    RESULT(checked3, a, 14, t387 - platform_turn_zz * minus_limb5_S_joint_acc_wz);
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t358 = limb4_S_arm_x * t357;
    const REAL t369 = limb4_S_arm_x * t359 + limb4_U_v_1 * limb4_P_v + t365 - limb4_S_arm_x * t367;
    RESULT(checked0, a, 10, -(t353 * (t358 + t369)));
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    RESULT(checked1, a, 11, limb4_S_arm_y * t357 + (limb4_S_arm_y * t359 + t374 - limb4_S_arm_y * t367));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
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
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t3 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t4 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t5 = t3 + t4;
    const REAL t6 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t7 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t8 = t6 + t7;
    const REAL t9 = t5 + t8;
    const REAL t11 = 4.0 - 2.0 * t9;
    const REAL t51 = 0.5 * (1.0 - t8 * t11);
    const REAL t31 = t4 + t7;
    const REAL t28 = param_H * (1.0 - t11 * (t4 + t6));
    const REAL platform_turn_yy = 1.0 - t11 * t31;
    const REAL t14 = limb5_S_q_qz * t11;
    const REAL t23 = limb5_S_q_qx * t14;
    const REAL t12 = limb5_S_q_qy * t11;
    const REAL t19 = limb5_S_q_qw * (limb5_S_q_qx * t11);
    const REAL t24 = limb5_S_q_qw * t12;
    const REAL t13 = limb5_S_q_qx * t12;
    const REAL platform_turn_zx = t23 - t24;
    const REAL t52 = param_H * (t23 + t24);
    const REAL t25 = 0.5 * platform_turn_zx;
    /* limb1: geometry; loop closure */
    const REAL limb1_P_q = READ(q, 2);
    const REAL minus_limb1_upper_position_x_2 = t51 - t52;
    const REAL limb3_upper_position_x_2 = t51 + t52;
    const REAL limb1_upper_offset_x = limb_upper_phase + limb1_P_q;
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t53 = minus_limb1_upper_position_x - minus_limb1_upper_position_x_2;
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL t237 = limb1_lower_sin * t53;
    const REAL t54 = limb1_lower_cos * t53;
    /* platform: geometry */
    const REAL t15 = limb5_S_q_qw * t14;
    const REAL t17 = limb5_S_q_qy * t14;
    const REAL platform_turn_yx = t13 + t15;
    const REAL platform_turn_xy = t13 - t15;
    const REAL t16 = 0.5 * platform_turn_yx;
    const REAL platform_turn_yz = t17 - t19;
    const REAL platform_turn_zy = t17 + t19;
    const REAL t20 = param_H * platform_turn_yz;
    /* limb1: geometry; loop closure; results */
    const REAL limb1_U_0_sin = SINES(sine, 0);
    const REAL minus_limb1_lower_limb_target_x = t16 - t20;
    const REAL limb3_lower_limb_target_x = t16 + t20;
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    const REAL t21 = limb1_upper_offset_x * minus_limb1_lower_rotation_yx - minus_limb1_lower_limb_target_x;
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    const REAL t239 = t237 - minus_limb1_lower_rotation_yx * t21;
    const REAL minus_limb1_lower_limb_target_y = t25 - t28;
    const REAL limb3_lower_limb_target_y = t25 + t28;
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    const REAL t29 = limb1_upper_offset_x * limb1_lower_rotation_zx + minus_limb1_lower_limb_target_y;
    const REAL minus_limb1_U2_opening_fx = t239 - limb1_lower_rotation_zx * t29;
    const REAL t373 = per_length * minus_limb1_U2_opening_fx;
    const REAL t374 = t373 * t373;
    const REAL t22 = limb1_U_0_cos * t21;
    const REAL minus_limb1_U2_opening_fy = t54 + limb1_U_0_sin * limb1_lower_sin * t21 + limb1_U_0_cos * limb1_lower_sin * t29;
    const REAL minus_limb1_U2_opening_fz = t22 - limb1_U_0_sin * t29;
    const REAL t375 = per_length * minus_limb1_U2_opening_fy;
    const REAL t377 = t374 + t375 * t375;
    const REAL t378 = per_length * minus_limb1_U2_opening_fz;
    const REAL t380 = t377 + t378 * t378;
    const REAL t39 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy;
    const REAL t40 = limb1_lower_cos * t39;
    const REAL limb1_U2_opening_mn = limb1_lower_sin * t39 + limb1_lower_cos * platform_turn_xy;
    const REAL t382 = t380 + limb1_U2_opening_mn * limb1_U2_opening_mn;
    const REAL t132 = 0.5 * platform_turn_xy; /* platform */
    const REAL limb1_U2_constraint_mn_couple_z = t40 - limb1_lower_sin * platform_turn_xy;
    /* limb2: geometry; loop closure; results */
    const REAL limb2_P_q = READ(q, 5);
    const REAL limb2_lower_limb_target_y = t52 - t132;
    const REAL limb4_lower_limb_target_y = t52 + t132;
    const REAL limb2_upper_offset_x = limb_upper_phase + limb2_P_q;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    const REAL t161 = limb2_upper_offset_x * minus_limb2_lower_rotation_xx + limb2_lower_limb_target_y;
    const REAL t162 = minus_limb2_lower_rotation_xx * t161;
    const REAL t135 = 0.5 * platform_turn_yy; /* platform */
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL t33 = limb1_U_0_cos * platform_turn_yy; /* limb1 */
    const REAL limb2_upper_position_y = t20 - t135;
    const REAL limb4_upper_position_y_2 = t20 + t135;
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL t163 = minus_limb2_upper_position_y + limb2_upper_position_y;
    const REAL t165 = t162 - limb2_lower_sin * t163;
    const REAL t173 = limb2_lower_cos * t163;
    const REAL t139 = 0.5 * platform_turn_zy; /* platform */
    const REAL limb1_U2_constraint_mn_couple_x = t33 + limb1_U_0_sin * platform_turn_zy;
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL limb2_lower_limb_target_x = t28 - t139;
    const REAL limb4_lower_limb_target_x = t28 + t139;
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL t166 = limb2_upper_offset_x * minus_limb2_lower_rotation_zx + limb2_lower_limb_target_x;
    const REAL limb2_S_opening_fx = t165 + minus_limb2_lower_rotation_zx * t166;
    const REAL t383 = per_length * limb2_S_opening_fx;
    const REAL t385 = t382 + t383 * t383; /* residual */
    const REAL t180 = limb2_U_0_sin * t161;
    const REAL minus_limb2_S_opening_fy = minus_limb2_U_0_cos * limb2_lower_sin * t161 + t173 + limb2_U_0_sin * limb2_lower_sin * t166;
    const REAL minus_limb2_S_opening_fz = t180 - minus_limb2_U_0_cos * t166;
    const REAL t386 = per_length * minus_limb2_S_opening_fy;
    const REAL t388 = t385 + t386 * t386; /* residual */
    const REAL t389 = per_length * minus_limb2_S_opening_fz;
    /* limb3: geometry; loop closure */
    const REAL limb3_P_q = READ(q, 8);
    const REAL t391 = t388 + t389 * t389; /* residual */
    const REAL limb3_upper_offset_x = limb_upper_phase + limb3_P_q;
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL t210 = limb3_upper_position_x - limb3_upper_position_x_2;
    const REAL limb3_lower_cos = SINES(cosine, 5), limb3_U_0_sin = SINES(sine, 4);
    const REAL t211 = minus_limb3_lower_sin * t210;
    const REAL t222 = limb3_lower_cos * t210;
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    /* limb3: loop closure; geometry; results */
    const REAL t190 = limb3_upper_offset_x * minus_limb3_lower_rotation_yx + limb3_lower_limb_target_x;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    const REAL t213 = t211 - minus_limb3_lower_rotation_yx * t190;
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    const REAL t192 = limb3_upper_offset_x * limb3_lower_rotation_zx - limb3_lower_limb_target_y;
    const REAL minus_limb3_S_opening_fx = t213 - limb3_lower_rotation_zx * t192;
    const REAL t392 = per_length * minus_limb3_S_opening_fx;
    const REAL t394 = t391 + t392 * t392; /* residual */
    const REAL t224 = t222 + limb3_U_0_sin * minus_limb3_lower_sin * t190;
    const REAL t191 = limb3_U_0_cos * t190;
    const REAL limb3_S_opening_fy = t224 + limb3_U_0_cos * minus_limb3_lower_sin * t192;
    const REAL minus_limb3_S_opening_fz = t191 - limb3_U_0_sin * t192;
    const REAL t395 = per_length * limb3_S_opening_fy;
    const REAL t397 = t394 + t395 * t395; /* residual */
    const REAL t398 = per_length * minus_limb3_S_opening_fz;
    /* limb4: geometry; loop closure */
    const REAL limb4_P_q = READ(q, 11);
    const REAL t400 = t397 + t398 * t398; /* residual */
    const REAL limb4_upper_offset_x = limb_upper_phase + limb4_P_q;
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_lower_cos = SINES(cosine, 7);
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    const REAL t133 = limb4_upper_offset_x * minus_limb4_lower_rotation_xx + limb4_lower_limb_target_y;
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL t134 = minus_limb4_lower_rotation_xx * t133;
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    /* limb4: loop closure; geometry; results */
    const REAL t136 = limb4_upper_position_y - limb4_upper_position_y_2;
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    const REAL t138 = t134 - minus_limb4_lower_sin * t136;
    const REAL t147 = limb4_lower_cos * t136;
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL t140 = limb4_upper_offset_x * minus_limb4_lower_rotation_zx + limb4_lower_limb_target_x;
    const REAL limb4_S_opening_fx = t138 + minus_limb4_lower_rotation_zx * t140;
    const REAL t401 = per_length * limb4_S_opening_fx;
    const REAL t403 = t400 + t401 * t401; /* residual */
    const REAL t148 = minus_limb4_U_0_cos * minus_limb4_lower_sin * t133 + t147;
    const REAL t154 = limb4_U_0_sin * t133;
    const REAL limb4_S_opening_fy = t148 + limb4_U_0_sin * minus_limb4_lower_sin * t140;
    const REAL minus_limb4_S_opening_fz = t154 - minus_limb4_U_0_cos * t140;
    const REAL t404 = per_length * limb4_S_opening_fy;
    const REAL t406 = t403 + t404 * t404; /* residual */
    const REAL t407 = per_length * minus_limb4_S_opening_fz;
    const REAL residual_residual = SQRT(t406 + t407 * t407);
    WRITE(residual_, 0, residual_residual);
    REAL checked0 = residual_residual;
    /* limb1: reciprocal wrenches, eq. (10); rates that follow; results */
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked1 = limb1_U_0_pivot;
    const REAL t2 = 1.0 / limb1_U_0_pivot;
    const REAL t43 = limb1_lower_cos * t2;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t43;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL t59 = limb1_U2_opening_mn + minus_limb1_U2_opening_fy * limb1_U_factor_1_by_3;
    const REAL t45 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    const REAL t95 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t2;
    const REAL limb1_U_0_lever_moment_y_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x;
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_moment_y_by_limb1_U2_mn - minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3;
    const REAL t60 = minus_limb1_U2_opening_fz * minus_limb1_U_factor_0_by_3 - t59;
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t45;
    REAL checked2 = minus_limb5_S_pivot_wz;
    const REAL t46 = 1.0 / minus_limb5_S_pivot_wz; /* limb5_S */
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t46 * (limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t95);
    const REAL t61 = t46 * t60;
    const REAL t235 = limb1_U_0_cos + limb1_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb1_U_null_space_1_by_limb5_S_wy = t43 * (limb1_U2_arm_x * t235);
    const REAL t276 = limb1_U_null_space_1_by_limb5_S_wy * limb1_U_null_space_1_by_limb5_S_wy;
    const REAL t111 = minus_limb1_upper_position_x * (limb1_U_0_sin - limb1_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy);
    const REAL minus_limb1_U_null_space_0_by_limb5_S_wy = t2 * t111;
    const REAL t278 = t276 + minus_limb1_U_null_space_0_by_limb5_S_wy * minus_limb1_U_null_space_0_by_limb5_S_wy;
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL limb1_P_null_space_by_limb5_S_wy = minus_limb1_U2_arm_y * t235;
    const REAL t236 = 2.2795812745707664 * limb1_P_null_space_by_limb5_S_wy;
    const REAL t279 = limb1_P_null_space_by_limb5_S_wy * t236 + t278;
    /* limb2: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t106 = minus_limb2_upper_position_y * (limb2_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy);
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    const REAL t107 = limb2_U_0_pivot - t106;
    const REAL t80 = 1.0 / limb2_U_0_pivot;
    const REAL limb2_U_null_space_0_by_limb5_S_wy = t80 * t107;
    const REAL t280 = limb2_U_null_space_0_by_limb5_S_wy * limb2_U_null_space_0_by_limb5_S_wy + t279; /* mechanism */
    const REAL t100 = minus_limb2_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t103 = limb2_S_arm_x * t100;
    const REAL t85 = limb2_lower_cos * t80;
    const REAL minus_limb2_U_null_space_1_by_limb5_S_wy = t85 * t103;
    const REAL t281 = minus_limb2_U_null_space_1_by_limb5_S_wy * minus_limb2_U_null_space_1_by_limb5_S_wy + t280; /* mechanism */
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL minus_limb2_P_null_space_by_limb5_S_wy = minus_limb2_S_arm_y * t100;
    const REAL t101 = 2.2795812745707664 * minus_limb2_P_null_space_by_limb5_S_wy;
    const REAL t282 = minus_limb2_P_null_space_by_limb5_S_wy * t101 + t281; /* mechanism */
    /* limb3: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t120 = limb3_upper_position_x * (limb3_U_0_sin - limb3_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy);
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked3 = limb3_U_0_pivot;
    const REAL t116 = 1.0 / limb3_U_0_pivot;
    const REAL limb3_U_null_space_0_by_limb5_S_wy = t116 * t120;
    const REAL t283 = limb3_U_null_space_0_by_limb5_S_wy * limb3_U_null_space_0_by_limb5_S_wy + t282; /* mechanism */
    const REAL t208 = limb3_U_0_cos + limb3_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t221 = limb3_S_arm_x * t208;
    const REAL t219 = limb3_lower_cos * t116;
    const REAL limb3_U_null_space_1_by_limb5_S_wy = t219 * t221;
    const REAL t284 = limb3_U_null_space_1_by_limb5_S_wy * limb3_U_null_space_1_by_limb5_S_wy + t283; /* mechanism */
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL minus_limb3_P_null_space_by_limb5_S_wy = limb3_S_arm_y * t208;
    const REAL t209 = 2.2795812745707664 * minus_limb3_P_null_space_by_limb5_S_wy;
    const REAL t285 = minus_limb3_P_null_space_by_limb5_S_wy * t209 + t284; /* mechanism */
    /* limb4: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t123 = limb4_upper_position_y * (limb4_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy);
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    const REAL t124 = limb4_U_0_pivot + t123;
    const REAL t71 = 1.0 / limb4_U_0_pivot;
    const REAL limb4_U_null_space_0_by_limb5_S_wy = t71 * t124;
    const REAL t286 = limb4_U_null_space_0_by_limb5_S_wy * limb4_U_null_space_0_by_limb5_S_wy + t285; /* mechanism */
    const REAL t97 = minus_limb4_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t127 = limb4_S_arm_x * t97;
    const REAL t72 = limb4_lower_cos * t71;
    const REAL minus_limb4_U_null_space_1_by_limb5_S_wy = t72 * t127;
    const REAL t287 = minus_limb4_U_null_space_1_by_limb5_S_wy * minus_limb4_U_null_space_1_by_limb5_S_wy + t286; /* mechanism */
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL limb4_P_null_space_by_limb5_S_wy = limb4_S_arm_y * t97;
    const REAL t98 = 2.2795812745707664 * limb4_P_null_space_by_limb5_S_wy;
    const REAL t289 = 1.0 + (limb4_P_null_space_by_limb5_S_wy * t98 + t287); /* mechanism */
    const REAL t290 = limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_null_space_wz_by_limb5_S_wy + t289; /* mechanism */
    const REAL minus_limb2_U_null_space_0_by_limb5_S_wx = minus_limb2_U_0_cos * minus_limb2_upper_position_y * t80;
    const REAL t112 = minus_limb2_U_null_space_0_by_limb5_S_wx * limb2_U_null_space_0_by_limb5_S_wy + minus_limb1_U_null_space_0_by_limb5_S_wy; /* limb1 */
    const REAL limb2_U_null_space_1_by_limb5_S_wx = limb2_U_0_sin * limb2_S_arm_x * t85;
    const REAL t113 = limb2_U_null_space_1_by_limb5_S_wx * minus_limb2_U_null_space_1_by_limb5_S_wy + t112; /* limb1 */
    const REAL t77 = limb2_U_0_sin * minus_limb2_S_arm_y; /* platform */
    const REAL t121 = t77 * t101 + t113 - limb3_U_null_space_0_by_limb5_S_wy; /* limb1 */
    const REAL limb4_U_null_space_0_by_limb5_S_wx = minus_limb4_U_0_cos * limb4_upper_position_y * t71;
    const REAL t126 = t121 - limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wy; /* limb1 */
    const REAL limb4_U_null_space_1_by_limb5_S_wx = limb4_U_0_sin * limb4_S_arm_x * t72;
    const REAL t129 = t126 + limb4_U_null_space_1_by_limb5_S_wx * minus_limb4_U_null_space_1_by_limb5_S_wy; /* limb1 */
    /* platform: balance, eqs. (40)-(47) */
    const REAL platform_joint_force_moment_x_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y;
    const REAL t130 = platform_joint_force_moment_x_by_limb4_P * t98 + t129; /* limb1 */
    const REAL t82 = 1.0 + minus_limb2_U_null_space_0_by_limb5_S_wx * minus_limb2_U_null_space_0_by_limb5_S_wx; /* limb2 */
    const REAL t87 = t82 + limb2_U_null_space_1_by_limb5_S_wx * limb2_U_null_space_1_by_limb5_S_wx; /* limb2 */
    /* mechanism: pivots; results */
    const REAL t78 = 2.2795812745707664 * t77;
    const REAL t89 = 1.0 + (t77 * t78 + t87);
    const REAL t90 = limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wx + t89;
    const REAL t91 = limb4_U_null_space_1_by_limb5_S_wx * limb4_U_null_space_1_by_limb5_S_wx + t90;
    const REAL t67 = 2.2795812745707664 * platform_joint_force_moment_x_by_limb4_P;
    const REAL pivot_0 = 1.0 + (platform_joint_force_moment_x_by_limb4_P * t67 + t91);
    checked0 = checked0 + pivot_0;
    const REAL t93 = 1.0 / pivot_0;
    /* limb1: results */
    const REAL t131 = t93 * t130;
    const REAL minus_pivot_1 = t130 * t131 - t290;
    checked1 = checked1 + minus_pivot_1;
    const REAL t241 = limb1_U_0_sin * t61;
    const REAL t248 = t43 * (minus_limb1_U2_opening_fy - limb1_U2_arm_x * t241);
    const REAL t243 = minus_limb1_U2_opening_fx - minus_limb1_U2_arm_y * t241;
    const REAL t244 = t236 * t243;
    const REAL t249 = limb1_U_null_space_1_by_limb5_S_wy * t248;
    const REAL t65 = t2 * (minus_limb1_U2_opening_fz + minus_limb1_upper_position_x * (limb1_U_0_cos * t61));
    const REAL t252 = t244 + (t249 + minus_limb1_U_null_space_0_by_limb5_S_wy * t65);
    const REAL t185 = t80 * (minus_limb2_S_opening_fz - minus_limb2_upper_position_y * (limb2_U_0_sin * t61));
    const REAL t253 = limb2_U_null_space_0_by_limb5_S_wy * t185 - t252;
    const REAL t168 = minus_limb2_U_0_cos * t61;
    const REAL t178 = t85 * (minus_limb2_S_opening_fy + limb2_S_arm_x * t168);
    const REAL t170 = limb2_S_opening_fx - minus_limb2_S_arm_y * t168;
    const REAL t171 = t78 * t170;
    const REAL t255 = t101 * t170 - (minus_limb2_U_null_space_1_by_limb5_S_wy * t178 + t253);
    const REAL t197 = t116 * (minus_limb3_S_opening_fz - limb3_upper_position_x * (limb3_U_0_cos * t61));
    const REAL t256 = limb3_U_null_space_0_by_limb5_S_wy * t197 - t255;
    const REAL t215 = limb3_U_0_sin * t61;
    const REAL t228 = t219 * (limb3_S_opening_fy + limb3_S_arm_x * t215);
    const REAL t217 = minus_limb3_S_opening_fx + limb3_S_arm_y * t215;
    const REAL t258 = t209 * t217 + (limb3_U_null_space_1_by_limb5_S_wy * t228 + t256);
    const REAL t159 = t71 * (minus_limb4_S_opening_fz + limb4_upper_position_y * (limb4_U_0_sin * t61));
    const REAL t259 = limb4_U_null_space_0_by_limb5_S_wy * t159 + t258;
    const REAL t142 = minus_limb4_U_0_cos * t61;
    const REAL t152 = t72 * (limb4_S_opening_fy - limb4_S_arm_x * t142);
    const REAL t144 = limb4_S_opening_fx + limb4_S_arm_y * t142;
    const REAL t145 = t67 * t144;
    const REAL t261 = t98 * t144 - (minus_limb4_U_null_space_1_by_limb5_S_wy * t152 - t259);
    const REAL t262 = limb5_S_null_space_wz_by_limb5_S_wy * t61 + t261;
    const REAL t187 = minus_limb2_U_null_space_0_by_limb5_S_wx * t185 - t65;
    const REAL t198 = t171 - (limb2_U_null_space_1_by_limb5_S_wx * t178 + t187) + t197;
    const REAL t200 = limb4_U_null_space_1_by_limb5_S_wx * t152 + (limb4_U_null_space_0_by_limb5_S_wx * t159 + t198);
    const REAL t201 = t145 - t200;
    const REAL t293 = t93 * t201;
    const REAL t291 = (t131 * t201 - t262) / minus_pivot_1;
    const REAL t294 = t131 * t291 - t293;
    const REAL t335 = 0.5 * (t61 - limb5_S_null_space_wz_by_limb5_S_wy * t291); /* limb5_S */
    const REAL t332 = t144 - (limb4_P_null_space_by_limb5_S_wy * t291 - platform_joint_force_moment_x_by_limb4_P * t294); /* limb4 */
    RESULT(checked2, q_next, 11, limb4_P_q - t332);
    const REAL t328 = t152 + (minus_limb4_U_null_space_1_by_limb5_S_wy * t291 - limb4_U_null_space_1_by_limb5_S_wx * t294); /* limb4 */
    RESULT(checked3, q_next, 10, READ(q, 10) - t328);
    const REAL t324 = t159 - (limb4_U_null_space_0_by_limb5_S_wy * t291 + limb4_U_null_space_0_by_limb5_S_wx * t294); /* limb4 */
    RESULT(checked0, q_next, 9, READ(q, 9) - t324);
    RESULT(checked1, q_next, 8, limb3_P_q + (t217 - minus_limb3_P_null_space_by_limb5_S_wy * t291));
    RESULT(checked2, q_next, 7, READ(q, 7) - (t228 - limb3_U_null_space_1_by_limb5_S_wy * t291));
    RESULT(checked3, q_next, 6, READ(q, 6) - (t197 - (t294 + limb3_U_null_space_0_by_limb5_S_wy * t291)));
    RESULT(checked0, q_next, 5, limb2_P_q - (t170 + (minus_limb2_P_null_space_by_limb5_S_wy * t291 - t77 * t294)));
    const REAL t309 = t178 - (minus_limb2_U_null_space_1_by_limb5_S_wy * t291 - limb2_U_null_space_1_by_limb5_S_wx * t294); /* limb2 */
    RESULT(checked1, q_next, 4, READ(q, 4) + t309);
    const REAL t305 = t185 - (limb2_U_null_space_0_by_limb5_S_wy * t291 - minus_limb2_U_null_space_0_by_limb5_S_wx * t294); /* limb2 */
    RESULT(checked2, q_next, 3, READ(q, 3) - t305);
    RESULT(checked3, q_next, 2, limb1_P_q + (t243 + limb1_P_null_space_by_limb5_S_wy * t291));
    RESULT(checked0, q_next, 1, READ(q, 1) + (t248 + limb1_U_null_space_1_by_limb5_S_wy * t291));
    const REAL t295 = minus_limb1_U_null_space_0_by_limb5_S_wy * t291;
    const REAL t337 = 0.5 * t291;
    RESULT(checked1, q_next, 0, READ(q, 0) - (t65 - (t294 - t295)));
    const REAL t339 = 0.5 * t294;
    /* limb5_S: results */
    const REAL t343 = limb5_S_q_qw + (limb5_S_q_qz * t335 - (limb5_S_q_qy * t337 + limb5_S_q_qx * t339));
    const REAL t365 = t343 * t343;
    const REAL t363 = limb5_S_q_qy * t335 + limb5_S_q_qz * t337 + (limb5_S_q_qx + limb5_S_q_qw * t339);
    const REAL t366 = t363 * t363 + t365;
    const REAL t345 = limb5_S_q_qy * t339;
    const REAL t348 = limb5_S_q_qz - limb5_S_q_qw * t335;
    const REAL t356 = limb5_S_q_qz * t339 + limb5_S_q_qx * t335 - (limb5_S_q_qy + limb5_S_q_qw * t337);
    const REAL t349 = limb5_S_q_qx * t337 - t345 - t348;
    const REAL t370 = 1.0 / SQRT(t349 * t349 + (t356 * t356 + t366));
    RESULT(checked2, q_next, 13, t363 * t370);
    RESULT(checked3, q_next, 12, t343 * t370);
    RESULT(checked0, q_next, 15, -(t349 * t370));
    RESULT(checked1, q_next, 14, -(t356 * t370));
    NOT_BELOW(t9, 0.999999, 5);
    NOT_ABOVE(t9, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
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
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t3 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t4 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t5 = t3 + t4;
    const REAL t6 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t7 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t8 = t6 + t7;
    const REAL t9 = t5 + t8;
    const REAL t11 = 4.0 - 2.0 * t9;
    const REAL t122 = t4 + t6;
    const REAL platform_turn_yy = 1.0 - t11 * (t4 + t7);
    const REAL platform_turn_zz = 1.0 - t11 * t122;
    const REAL platform_turn_xx = 1.0 - t8 * t11;
    const REAL t15 = limb5_S_q_qz * t11;
    const REAL t16 = limb5_S_q_qy * t15;
    const REAL t18 = limb5_S_q_qw * (limb5_S_q_qx * t11);
    const REAL t26 = limb5_S_q_qy * t11;
    const REAL platform_turn_zy = t16 + t18;
    const REAL platform_turn_yz = t16 - t18;
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1);
    const REAL t25 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy); /* limb1 */
    const REAL t27 = limb5_S_q_qx * t26;
    const REAL t105 = limb5_S_q_qw * t26;
    const REAL t28 = limb5_S_q_qw * t15;
    const REAL t104 = limb5_S_q_qx * t15;
    const REAL platform_turn_xy = t27 - t28;
    const REAL platform_turn_yx = t27 + t28;
    /* limb1: geometry; reciprocal wrenches, eq. (10) */
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_U2_constraint_mn_couple_z = t25 - limb1_lower_sin * platform_turn_xy;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    REAL checked0 = limb1_U_0_pivot;
    /* limb1: rates that follow; reciprocal wrenches, eq. (10); results */
    const REAL t2 = 1.0 / limb1_U_0_pivot;
    const REAL t31 = limb1_lower_cos * t2;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t31;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL t33 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL t36 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy;
    const REAL t20 = minus_limb1_upper_position_x * (limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t2);
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_lower_cos * limb1_U2_constraint_mn_couple_x - t20;
    const REAL t34 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t33;
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t36;
    REAL checked1 = minus_limb5_S_pivot_wz;
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t34 / minus_limb5_S_pivot_wz;
    const REAL t149 = limb1_U_0_cos + limb1_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb1_U_null_space_1_by_limb5_S_wy = t31 * (limb1_U2_arm_x * t149);
    const REAL t153 = READ(v, 1) * limb1_U_null_space_1_by_limb5_S_wy;
    const REAL t39 = minus_limb1_upper_position_x * (limb1_U_0_sin - limb1_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy);
    const REAL minus_limb1_U_null_space_0_by_limb5_S_wy = t2 * t39;
    const REAL limb1_U_v_0 = READ(v, 0);
    const REAL t155 = t153 - limb1_U_v_0 * minus_limb1_U_null_space_0_by_limb5_S_wy;
    const REAL limb1_P_null_space_by_limb5_S_wy = param_R * limb1_lower_cos * t149;
    const REAL t150 = 2.2795812745707664 * limb1_P_null_space_by_limb5_S_wy;
    /* limb2: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL t156 = READ(v, 2) * t150 + t155; /* limb1 */
    const REAL t180 = limb1_P_null_space_by_limb5_S_wy * t150; /* limb1 */
    const REAL t76 = limb2_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_lower_cos = SINES(cosine, 3);
    const REAL t77 = minus_limb2_upper_position_y * t76;
    const REAL base_lever_moment_x_by_limb2_S_fz = minus_limb2_U_0_cos * minus_limb2_upper_position_y;
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    /* limb2: rates that follow; results; reciprocal wrenches, eq. (10) */
    const REAL t78 = limb2_U_0_pivot - t77;
    const REAL t54 = 1.0 / limb2_U_0_pivot;
    const REAL limb2_U_null_space_0_by_limb5_S_wy = t54 * t78;
    const REAL minus_limb2_U_null_space_0_by_limb5_S_wx = base_lever_moment_x_by_limb2_S_fz * t54;
    const REAL t59 = limb2_lower_cos * t54;
    const REAL limb2_U_v_0 = READ(v, 3);
    const REAL t157 = limb2_U_v_0 * limb2_U_null_space_0_by_limb5_S_wy + t156; /* limb1 */
    const REAL t71 = minus_limb2_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL minus_limb2_U_null_space_1_by_limb5_S_wy = t59 * (limb2_S_arm_x * t71);
    const REAL limb2_U_null_space_1_by_limb5_S_wx = limb2_U_0_sin * limb2_S_arm_x * t59;
    const REAL limb2_U_v_1 = READ(v, 4);
    const REAL t158 = limb2_U_v_1 * minus_limb2_U_null_space_1_by_limb5_S_wy - t157; /* limb1 */
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL minus_limb2_P_null_space_by_limb5_S_wy = minus_limb2_S_arm_y * t71;
    const REAL t51 = limb2_U_0_sin * minus_limb2_S_arm_y; /* platform */
    const REAL t72 = 2.2795812745707664 * minus_limb2_P_null_space_by_limb5_S_wy;
    const REAL limb2_P_v = READ(v, 5);
    /* limb3: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL limb3_U_0_cos = SINES(cosine, 4), limb3_U_0_sin = SINES(sine, 4);
    const REAL t159 = limb2_P_v * t72 + t158; /* limb1 */
    const REAL t87 = limb3_U_0_sin - limb3_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5), limb3_lower_cos = SINES(cosine, 5);
    const REAL t88 = (param_R - minus_limb3_lower_sin * limb3_upper_offset_x) * t87;
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    REAL checked2 = limb3_U_0_pivot;
    const REAL t84 = 1.0 / limb3_U_0_pivot;
    const REAL limb3_U_null_space_0_by_limb5_S_wy = t84 * t88;
    const REAL limb3_U_v_0 = READ(v, 6);
    const REAL t140 = limb3_lower_cos * t84;
    const REAL t160 = limb3_U_v_0 * limb3_U_null_space_0_by_limb5_S_wy - t159; /* limb1 */
    const REAL t137 = limb3_U_0_cos + limb3_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb3_U_null_space_1_by_limb5_S_wy = t140 * ((limb3_upper_offset_x - param_R * minus_limb3_lower_sin) * t137);
    const REAL t161 = READ(v, 7) * limb3_U_null_space_1_by_limb5_S_wy + t160; /* limb1 */
    const REAL minus_limb3_P_null_space_by_limb5_S_wy = param_R * limb3_lower_cos * t137;
    const REAL t138 = 2.2795812745707664 * minus_limb3_P_null_space_by_limb5_S_wy;
    /* limb4: geometry; rates that follow; reciprocal wrenches, eq. (10) */
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    const REAL t162 = READ(v, 8) * t138 - t161; /* limb1 */
    const REAL t174 = minus_limb3_P_null_space_by_limb5_S_wy * t138; /* limb3 */
    const REAL t90 = limb4_U_0_sin * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_lower_cos = SINES(cosine, 7);
    const REAL t91 = limb4_upper_position_y * t90;
    const REAL minus_base_lever_moment_x_by_limb4_S_fz = minus_limb4_U_0_cos * limb4_upper_position_y;
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    /* limb4: rates that follow; results; reciprocal wrenches, eq. (10) */
    const REAL t92 = limb4_U_0_pivot + t91;
    const REAL t45 = 1.0 / limb4_U_0_pivot;
    const REAL limb4_U_null_space_0_by_limb5_S_wy = t45 * t92;
    const REAL limb4_U_null_space_0_by_limb5_S_wx = minus_base_lever_moment_x_by_limb4_S_fz * t45;
    const REAL t46 = limb4_lower_cos * t45;
    const REAL limb4_U_v_0 = READ(v, 9);
    const REAL t163 = limb4_U_v_0 * limb4_U_null_space_0_by_limb5_S_wy - t162; /* limb1 */
    const REAL t68 = minus_limb4_U_0_cos * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL minus_limb4_U_null_space_1_by_limb5_S_wy = t46 * (limb4_S_arm_x * t68);
    const REAL limb4_U_null_space_1_by_limb5_S_wx = limb4_U_0_sin * limb4_S_arm_x * t46;
    const REAL limb4_U_v_1 = READ(v, 10);
    const REAL t164 = limb4_U_v_1 * minus_limb4_U_null_space_1_by_limb5_S_wy - t163; /* limb1 */
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL limb4_P_null_space_by_limb5_S_wy = limb4_S_arm_y * t68;
    /* limb5_S: balance, eqs. (40)-(47); velocities, eq. (6) */
    const REAL platform_joint_force_moment_x_by_limb4_P = limb4_U_0_sin * limb4_S_arm_y;
    const REAL t69 = 2.2795812745707664 * limb4_P_null_space_by_limb5_S_wy; /* limb4 */
    const REAL limb4_P_v = READ(v, 11), limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13);
    const REAL limb5_S_v_wz = READ(v, 14);
    const REAL t165 = limb4_P_v * t69 - t164; /* limb1 */
    const REAL t131 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx;
    /* limb1: results */
    const REAL t166 = t131 + limb5_S_v_wz * platform_turn_yz + t165;
    const REAL platform_turn_zx = t104 - t105;
    const REAL platform_turn_xz = t104 + t105;
    const REAL t127 = limb5_S_v_wx * platform_turn_zx + limb5_S_v_wy * platform_turn_zy; /* platform */
    const REAL t167 = (limb5_S_v_wz * platform_turn_zz + t127) * limb5_S_null_space_wz_by_limb5_S_wy + t166;
    const REAL t80 = minus_limb2_U_null_space_0_by_limb5_S_wx * limb2_U_null_space_0_by_limb5_S_wy + minus_limb1_U_null_space_0_by_limb5_S_wy;
    const REAL t82 = t51 * t72 + (limb2_U_null_space_1_by_limb5_S_wx * minus_limb2_U_null_space_1_by_limb5_S_wy + t80);
    const REAL t89 = t82 - limb3_U_null_space_0_by_limb5_S_wy;
    const REAL t177 = minus_limb2_P_null_space_by_limb5_S_wy * t72; /* limb2 */
    const REAL t94 = t89 - limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wy;
    const REAL t97 = t94 + limb4_U_null_space_1_by_limb5_S_wx * minus_limb4_U_null_space_1_by_limb5_S_wy;
    const REAL t98 = platform_joint_force_moment_x_by_limb4_P * t69 + t97;
    const REAL t171 = limb4_P_null_space_by_limb5_S_wy * t69; /* limb4 */
    const REAL t56 = 1.0 + minus_limb2_U_null_space_0_by_limb5_S_wx * minus_limb2_U_null_space_0_by_limb5_S_wx; /* limb2 */
    const REAL t61 = t56 + limb2_U_null_space_1_by_limb5_S_wx * limb2_U_null_space_1_by_limb5_S_wx; /* limb2 */
    /* mechanism: pivots; results */
    const REAL t52 = 2.2795812745707664 * t51;
    const REAL t63 = 1.0 + (t51 * t52 + t61);
    const REAL t110 = limb2_P_v * t52; /* limb1 */
    const REAL t64 = limb4_U_null_space_0_by_limb5_S_wx * limb4_U_null_space_0_by_limb5_S_wx + t63;
    const REAL t65 = limb4_U_null_space_1_by_limb5_S_wx * limb4_U_null_space_1_by_limb5_S_wx + t64;
    const REAL t41 = 2.2795812745707664 * platform_joint_force_moment_x_by_limb4_P;
    const REAL pivot_0 = 1.0 + (platform_joint_force_moment_x_by_limb4_P * t41 + t65);
    REAL checked3 = pivot_0;
    const REAL t67 = 1.0 / pivot_0;
    /* limb1: results; pivots */
    const REAL t107 = limb4_P_v * t41;
    const REAL t99 = t67 * t98;
    const REAL t169 = t98 * t99;
    const REAL t112 = limb1_U_v_0 - limb2_U_v_0 * minus_limb2_U_null_space_0_by_limb5_S_wx;
    const REAL t116 = limb3_U_v_0 + (t110 + (t112 + limb2_U_v_1 * limb2_U_null_space_1_by_limb5_S_wx));
    const REAL t117 = limb4_U_v_0 * limb4_U_null_space_0_by_limb5_S_wx + t116;
    const REAL t119 = t107 - (limb4_U_v_1 * limb4_U_null_space_1_by_limb5_S_wx + t117);
    const REAL t103 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy; /* platform */
    const REAL t120 = t103 + limb5_S_v_wz * platform_turn_xz - t119;
    const REAL t199 = t67 * t120;
    const REAL t168 = t99 * t120 + t167;
    const REAL t181 = limb1_U_null_space_1_by_limb5_S_wy * limb1_U_null_space_1_by_limb5_S_wy;
    const REAL t184 = t180 + (t181 + minus_limb1_U_null_space_0_by_limb5_S_wy * minus_limb1_U_null_space_0_by_limb5_S_wy);
    /* mechanism: pivots; results */
    const REAL t185 = limb2_U_null_space_0_by_limb5_S_wy * limb2_U_null_space_0_by_limb5_S_wy + t184;
    const REAL t187 = t177 + (minus_limb2_U_null_space_1_by_limb5_S_wy * minus_limb2_U_null_space_1_by_limb5_S_wy + t185);
    const REAL t188 = limb3_U_null_space_0_by_limb5_S_wy * limb3_U_null_space_0_by_limb5_S_wy + t187;
    const REAL t190 = t174 + (limb3_U_null_space_1_by_limb5_S_wy * limb3_U_null_space_1_by_limb5_S_wy + t188);
    const REAL t191 = limb4_U_null_space_0_by_limb5_S_wy * limb4_U_null_space_0_by_limb5_S_wy + t190;
    const REAL t193 = t171 + (minus_limb4_U_null_space_1_by_limb5_S_wy * minus_limb4_U_null_space_1_by_limb5_S_wy + t191);
    const REAL minus_pivot_1 = t169 - (limb5_S_null_space_wz_by_limb5_S_wy * limb5_S_null_space_wz_by_limb5_S_wy + (1.0 + t193));
    checked0 = checked0 + minus_pivot_1;
    const REAL t196 = t168 / minus_pivot_1; /* limb1 */
    RESULT(checked1, v_next, 8, minus_limb3_P_null_space_by_limb5_S_wy * t196);
    const REAL t200 = t99 * t196 - t199; /* limb1 */
    RESULT(checked2, v_next, 0, minus_limb1_U_null_space_0_by_limb5_S_wy * t196 - t200);
    RESULT(checked3, v_next, 1, -(limb1_U_null_space_1_by_limb5_S_wy * t196));
    RESULT(checked0, v_next, 2, -(limb1_P_null_space_by_limb5_S_wy * t196));
    RESULT(checked1, v_next, 3, minus_limb2_U_null_space_0_by_limb5_S_wx * t200 - limb2_U_null_space_0_by_limb5_S_wy * t196);
    RESULT(checked2, v_next, 4, minus_limb2_U_null_space_1_by_limb5_S_wy * t196 - limb2_U_null_space_1_by_limb5_S_wx * t200);
    RESULT(checked3, v_next, 5, minus_limb2_P_null_space_by_limb5_S_wy * t196 - t51 * t200);
    RESULT(checked0, v_next, 6, -(t200 + limb3_U_null_space_0_by_limb5_S_wy * t196));
    RESULT(checked1, v_next, 7, -(limb3_U_null_space_1_by_limb5_S_wy * t196));
    RESULT(checked2, v_next, 9, -(limb4_U_null_space_0_by_limb5_S_wy * t196 + limb4_U_null_space_0_by_limb5_S_wx * t200));
    RESULT(checked3, v_next, 10, minus_limb4_U_null_space_1_by_limb5_S_wy * t196 - limb4_U_null_space_1_by_limb5_S_wx * t200);
    RESULT(checked0, v_next, 11, platform_joint_force_moment_x_by_limb4_P * t200 - limb4_P_null_space_by_limb5_S_wy * t196);
    const REAL t223 = platform_turn_yx * t196 + platform_turn_xx * t200;
    const REAL t219 = limb5_S_null_space_wz_by_limb5_S_wy * t196;
    RESULT(checked1, v_next, 12, -(platform_turn_zx * t219 + t223));
    const REAL t233 = platform_turn_yz * t196 + platform_turn_xz * t200;
    RESULT(checked2, v_next, 13, -(platform_turn_zy * t219 + (platform_turn_yy * t196 + platform_turn_xy * t200)));
    RESULT(checked3, v_next, 14, -(platform_turn_zz * t219 + t233));
    NOT_BELOW(t9, 0.999999, 5);
    NOT_ABOVE(t9, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
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
    const double x2 = q[2], x5 = q[5], x8 = q[8], x11 = q[11], x12 = q[12], x13 = q[13], x14 = q[14], x15 =
        q[15];
    const double x16 = y_dot[0], x17 = y_dot[1], x38 = sine[0], x29 = cosine[0], x47 = sine[1], x31 =
        cosine[1];
    const double x126 = sine[2], x124 = cosine[2], x121 = sine[3], x117 = cosine[3], x154 = sine[4];
    const double x152 = cosine[4], x149 = sine[5], x145 = cosine[5], x181 = sine[6], x179 = cosine[6];
    const double x176 = sine[7], x172 = cosine[7];
    const double x18 = x12 * x12;
    const double x19 = x13 * x13;
    const double x20 = x18 + x19;
    const double x21 = x14 * x14;
    const double x22 = x15 * x15;
    const double x23 = x21 + x22;
    const double x24 = x20 + x23;
    const double x34 = x19 + x22;
    const double x214 = x19 + x21;
    const double x32 = 2.0 * x24;
    const double x33 = 4.0 - x32;
    const double x35 = x33 * x34;
    const double x36 = 1.0 - x35;
    const double x25 = 0.5 * x24;
    const double x26 = 1.5 - x25;
    const double x215 = x33 * x214;
    const double x216 = 1.0 - x215;
    const double x204 = x23 * x33;
    const double x205 = 1.0 - x204;
    const double x39 = x15 * x33;
    const double x40 = x14 * x39;
    const double x41 = x13 * x33;
    const double x42 = x12 * x41;
    const double x62 = x14 * x33;
    const double x43 = x40 + x42;
    const double x218 = x40 - x42;
    const double x59 = x29 * x43;
    const double x58 = x38 * x36;
    const double x60 = x58 - x59;
    const double x61 = x31 * x60;
    const double x63 = x13 * x62;
    const double x199 = x12 * x62;
    const double x64 = x12 * x39;
    const double x198 = x13 * x39;
    const double x65 = x63 - x64;
    const double x202 = x63 + x64;
    const double x66 = x47 * x65;
    const double x67 = x61 - x66;
    const three_ups_upu_s_vector4 xgathered0 = {x2, x5, x8, x11};
    const three_ups_upu_s_vector4 xpack0 = xgathered0 + (three_ups_upu_s_vector4){0.3, 0.3, 0.3, 0.3};
    const three_ups_upu_s_vector4 xgathered1 = {x31, x117, x145, x172};
    const three_ups_upu_s_vector4 xpack3 = xgathered1 * xpack0;
    const three_ups_upu_s_vector4 xpack4 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack3;
    const three_ups_upu_s_vector4 xpack7 = xgathered1 * xpack4;
    const double x70 = xpack7[0];
    const double x71 = x67 * x70;
    const three_ups_upu_s_vector4 xgathered2 = {x47, x121, x149, x176};
    const three_ups_upu_s_vector4 xpack5 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered2;
    const three_ups_upu_s_vector4 xpack6 = xpack0 - xpack5;
    const double x69 = xpack6[0];
    const double x72 = x69 * x71;
    const double x73 = x67 - x72;
    const three_ups_upu_s_vector4 xpack1 = xgathered2 * xpack0;
    const three_ups_upu_s_vector4 xpack2 = xpack1 - (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8};
    const double x74 = x38 * x73;
    const double x78 = x29 * x73;
    const double x44 = x38 * x43;
    const double x37 = x29 * x36;
    const double x45 = x37 + x44;
    const double x51 = x47 * x45;
    const double x53 = xpack4[0];
    const double x54 = x51 * x53;
    const double x50 = -xpack2[0];
    const double x55 = x50 * x54;
    const double x46 = x31 * x45;
    const double x56 = x46 - x55;
    const double x57 = x29 * x56;
    const double x75 = x57 + x74;
    const double x76 = 1.0 / x75;
    const double x77 = x38 * x56;
    const double x79 = x77 - x78;
    const double x80 = x76 * x79;
    const double x28 = x13 * x26;
    const double x81 = x28 * x80;
    const double x27 = x12 * x26;
    const double x82 = x27 + x81;
    const double x83 = 0.5 * x82;
    const double x84 = 1.0 / x83;
    const double x93 = 0.5 * x27;
    const double x86 = x14 * x26;
    const double x87 = x86 * x80;
    const double x85 = x15 * x26;
    const double x88 = x85 - x87;
    const double x89 = 0.5 * x88;
    const double x90 = x84 * x89;
    const double x94 = 0.5 * x85;
    const double x91 = x17 * x90;
    const double x92 = x16 - x91;
    const double x95 = x94 * x90;
    const double x96 = x93 + x95;
    const double x97 = x92 / x96;
    const double x98 = x94 * x97;
    const double x99 = x17 + x98;
    const double x100 = x84 * x99;
    const double x101 = x79 * x100;
    const double x102 = x76 * x101;
    const double x217 = x216 * x102;
    const double x219 = x218 * x100;
    const double x209 = x43 * x102;
    const double x210 = x36 * x100;
    const double x211 = x65 * x97;
    const double x212 = x210 + x211;
    const double x213 = x209 + x212;
    v[13] = x213;
    const double x203 = x202 * x100;
    const double x206 = x205 * x97;
    const double x207 = x203 + x206;
    const double x220 = x198 + x199;
    const double x200 = x198 - x199;
    const double x221 = x220 * x97;
    const double x222 = x219 + x221;
    const double x223 = x217 + x222;
    v[14] = x223;
    const double x201 = x200 * x102;
    const double x208 = x201 + x207;
    v[12] = x208;
    const three_ups_upu_s_vector4 xgathered3 = {x38, x126, x154, x181};
    const three_ups_upu_s_vector4 xgathered4 = {x102, x102, x102, x102};
    const three_ups_upu_s_vector4 xpack14 = xgathered3 * xgathered4;
    const three_ups_upu_s_vector4 xgathered5 = {x29, x124, x152, x179};
    const three_ups_upu_s_vector4 xpack8 = xgathered5 * xgathered4;
    const three_ups_upu_s_vector4 xgathered6 = {x100, x97, x100, x97};
    const three_ups_upu_s_vector4 xpack15 = xgathered5 * xgathered6;
    const three_ups_upu_s_vector4 xpack16 = xpack15 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack14;
    const three_ups_upu_s_vector4 xpack17 = xpack6 * xpack16;
    const three_ups_upu_s_vector4 xpack18 = xpack7 * xpack17;
    const double x113 = xpack18[0];
    v[1] = x113;
    const double x139 = -xpack18[1];
    const double x140 = -x139;
    v[4] = x140;
    const double x167 = xpack18[2];
    v[7] = x167;
    const double x194 = -xpack18[3];
    const double x195 = -x194;
    v[10] = x195;
    const three_ups_upu_s_vector4 xpack19 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered1;
    const three_ups_upu_s_vector4 xpack20 = xpack19 * xpack16;
    const double x115 = xpack20[0];
    v[2] = x115;
    const double x142 = -xpack20[1];
    const double x143 = -x142;
    v[5] = x143;
    const double x169 = xpack20[2];
    const double x170 = -x169;
    v[8] = x170;
    const double x197 = -xpack20[3];
    v[11] = x197;
    const three_ups_upu_s_vector4 xpack9 = xgathered3 * xgathered6;
    const three_ups_upu_s_vector4 xpack10 = xpack9 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack8;
    const three_ups_upu_s_vector4 xpack11 = xpack2 * xpack10;
    const three_ups_upu_s_vector4 xpack12 = xpack4 * xpack11;
    const three_ups_upu_s_vector4 xgathered7 = {x97, x100, x97, x100};
    const three_ups_upu_s_vector4 xpack13 = xpack12 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xgathered7;
    const double x108 = xpack13[0];
    v[0] = x108;
    const double x131 = xpack13[1];
    v[3] = x131;
    const double x159 = -xpack13[2];
    v[6] = x159;
    const double x186 = -xpack13[3];
    v[9] = x186;
    const three_ups_upu_s_vector4 every = (three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)((xpack3 +
        xpack13) + (xpack18 + xpack20)) | ((xpack3 <= (three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10}) & (xpack3 >= -(three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10})));
    return fabs(x75) <= 1.0e-09 || fabs(x83) <= 1.0e-09 || fabs(x96) <= 1.0e-09 || !(x24 >= 0.999999 && x24 <=
        1.000001) ? (double)NAN : (((x75 + x83) + (x96 + x208)) + ((x213 + x223) + (every[0] + every[1]))) +
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
    const double x2 = q[2], x5 = q[5], x8 = q[8], x11 = q[11], x12 = q[12], x13 = q[13], x14 = q[14], x15 =
        q[15];
    const double x16 = v[0], x17 = v[1], x18 = v[2], x19 = v[3], x20 = v[4], x21 = v[5], x22 = v[6], x23 =
        v[7];
    const double x24 = v[8], x25 = v[9], x26 = v[10], x27 = v[11], x28 = v[12], x29 = v[13], x30 = v[14];
    const double x31 = y_ddot[0], x32 = y_ddot[1], x53 = sine[0], x44 = cosine[0], x62 = sine[1], x46 =
        cosine[1];
    const double x298 = sine[2], x296 = cosine[2], x293 = sine[3], x289 = cosine[3], x372 = sine[4];
    const double x370 = cosine[4], x367 = sine[5], x363 = cosine[5], x444 = sine[6], x442 = cosine[6];
    const double x439 = sine[7], x435 = cosine[7];
    const double x33 = x12 * x12;
    const double x34 = x13 * x13;
    const double x35 = x33 + x34;
    const double x36 = x14 * x14;
    const double x37 = x15 * x15;
    const double x38 = x36 + x37;
    const double x39 = x35 + x38;
    const double x49 = x34 + x37;
    const double x126 = x34 + x36;
    const double x47 = 2.0 * x39;
    const double x48 = 4.0 - x47;
    const double x50 = x48 * x49;
    const double x51 = 1.0 - x50;
    const double x113 = x38 * x48;
    const double x114 = 1.0 - x113;
    const double x127 = x48 * x126;
    const double x128 = 1.0 - x127;
    const double x40 = 0.5 * x39;
    const double x41 = 1.5 - x40;
    const double x77 = x14 * x48;
    const double x78 = x13 * x77;
    const double x119 = x12 * x77;
    const double x54 = x15 * x48;
    const double x56 = x13 * x48;
    const double x57 = x12 * x56;
    const double x79 = x12 * x54;
    const double x107 = x78 + x79;
    const double x80 = x78 - x79;
    const double x108 = x28 * x107;
    const double x106 = x29 * x51;
    const double x109 = x106 + x108;
    const double x55 = x14 * x54;
    const double x118 = x13 * x54;
    const double x110 = x55 - x57;
    const double x58 = x55 + x57;
    const double x111 = x30 * x110;
    const double x112 = x109 + x111;
    const double x116 = x29 * x80;
    const double x115 = x28 * x114;
    const double x117 = x115 + x116;
    const double x120 = x118 + x119;
    const double x130 = x118 - x119;
    const double x121 = x30 * x120;
    const double x122 = x117 + x121;
    const three_ups_upu_s_vector4 xgathered0 = {x53, x298, x372, x444};
    const three_ups_upu_s_vector4 xgathered1 = {x112, x122, x112, x122};
    const three_ups_upu_s_vector4 xpack19 = xgathered0 * xgathered1;
    const double x131 = x28 * x130;
    const double x132 = x29 * x58;
    const double x133 = x131 + x132;
    const double x129 = x30 * x128;
    const double x134 = x129 + x133;
    const three_ups_upu_s_vector4 xgathered2 = {x44, x296, x370, x442};
    const three_ups_upu_s_vector4 xgathered3 = {x134, x134, x134, x134};
    const three_ups_upu_s_vector4 xpack20 = xgathered2 * xgathered3;
    const three_ups_upu_s_vector4 xpack21 = xpack20 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack19;
    const double x170 = -xpack21[0];
    const double x184 = x62 * x170;
    const double x185 = x46 * x122;
    const double x186 = x184 + x185;
    const double x180 = x16 * x46;
    const double x187 = x180 - x186;
    const double x188 = x17 * x187;
    const three_ups_upu_s_vector4 xpack8 = xgathered2 * xgathered1;
    const three_ups_upu_s_vector4 xpack9 = xgathered0 * xgathered3;
    const three_ups_upu_s_vector4 xpack10 = xpack8 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack9;
    const double x159 = xpack10[0];
    const double x182 = x17 - x159;
    const double x183 = x180 * x182;
    const double x189 = x183 - x188;
    const double x181 = x17 * x180;
    const double x190 = x181 - x189;
    const double x59 = x53 * x58;
    const double x52 = x44 * x51;
    const double x60 = x52 + x59;
    const double x191 = x60 * x190;
    const double x192 = x16 * x62;
    const double x193 = x192 * x187;
    const double x194 = x46 * x170;
    const double x195 = x62 * x122;
    const double x196 = x194 - x195;
    const double x197 = x192 + x196;
    const double x198 = x180 * x197;
    const double x199 = x193 - x198;
    const double x74 = x44 * x58;
    const double x73 = x53 * x51;
    const double x75 = x73 - x74;
    const double x76 = x46 * x75;
    const double x202 = x62 * x75;
    const double x81 = x62 * x80;
    const double x82 = x76 - x81;
    const double x200 = x82 * x199;
    const double x201 = x191 - x200;
    const double x203 = x46 * x80;
    const double x204 = x202 + x203;
    const double x205 = x204 * x197;
    const double x210 = x204 * x182;
    const double x206 = x82 * x187;
    const double x207 = x205 + x206;
    const double x208 = x197 * x207;
    const double x209 = x60 * x187;
    const double x211 = x209 - x210;
    const double x212 = x182 * x211;
    const double x213 = x208 - x212;
    const double x214 = x201 - x213;
    const three_ups_upu_s_vector4 xgathered4 = {x16, x19, x22, x25};
    const three_ups_upu_s_vector4 xpack30 = xgathered4 * xpack21;
    const three_ups_upu_s_vector4 xgathered5 = {x2, x5, x8, x11};
    const three_ups_upu_s_vector4 xpack0 = xgathered5 + (three_ups_upu_s_vector4){0.3, 0.3, 0.3, 0.3};
    const three_ups_upu_s_vector4 xgathered6 = {x62, x293, x367, x439};
    const three_ups_upu_s_vector4 xpack5 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered6;
    const three_ups_upu_s_vector4 xpack6 = xpack0 - xpack5;
    const three_ups_upu_s_vector4 xpack31 = xpack6 * xpack30;
    const three_ups_upu_s_vector4 xgathered7 = {x17, x20, x23, x26};
    const three_ups_upu_s_vector4 xgathered8 = {x18, x21, x24, x27};
    const three_ups_upu_s_vector4 xpack32 = xgathered7 * xgathered8;
    const three_ups_upu_s_vector4 xpack33 = xpack31 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack32;
    const three_ups_upu_s_vector4 xgathered9 = {x46, x289, x363, x435};
    const three_ups_upu_s_vector4 xpack23 = xgathered7 * xgathered9;
    const three_ups_upu_s_vector4 xpack34 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack23;
    const three_ups_upu_s_vector4 xpack35 = xgathered8 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack34;
    const three_ups_upu_s_vector4 xpack36 = xpack10 * xpack35;
    const three_ups_upu_s_vector4 xpack37 = xpack33 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack36;
    const three_ups_upu_s_vector4 xpack24 = xpack0 * xpack23;
    const three_ups_upu_s_vector4 xpack3 = xgathered9 * xpack0;
    const three_ups_upu_s_vector4 xpack4 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack3;
    const three_ups_upu_s_vector4 xpack7 = xgathered9 * xpack4;
    const double x85 = xpack7[0];
    const double x86 = x82 * x85;
    const double x222 = -xpack37[0];
    const double x223 = x222 * x86;
    const double x224 = x214 - x223;
    const double x84 = xpack6[0];
    const double x87 = x84 * x86;
    const double x88 = x82 - x87;
    const three_ups_upu_s_vector4 xpack11 = xgathered4 * xpack10;
    const three_ups_upu_s_vector4 xpack1 = xgathered6 * xpack0;
    const three_ups_upu_s_vector4 xpack2 = xpack1 - (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8};
    const three_ups_upu_s_vector4 xpack12 = xpack2 * xpack11;
    const three_ups_upu_s_vector4 xpack13 = xgathered7 * xgathered6;
    const three_ups_upu_s_vector4 xpack14 = xpack0 * xpack13;
    const three_ups_upu_s_vector4 xpack61 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xpack13;
    const three_ups_upu_s_vector4 xpack62 = xpack10 * xpack61;
    const three_ups_upu_s_vector4 xpack15 = xgathered8 * xgathered9;
    const three_ups_upu_s_vector4 xpack16 = xpack14 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xpack15;
    const three_ups_upu_s_vector4 xpack17 = xgathered4 * xpack16;
    const three_ups_upu_s_vector4 xpack18 = xpack12 + xpack17;
    const three_ups_upu_s_vector4 xgathered10 = {x122, x112, x122, x112};
    const three_ups_upu_s_vector4 xpack28 = xgathered10 * xpack16;
    const three_ups_upu_s_vector4 xpack22 = xgathered8 * xgathered6;
    const three_ups_upu_s_vector4 xpack25 = xpack22 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xpack24;
    const three_ups_upu_s_vector4 xpack26 = xpack21 * xpack25;
    const three_ups_upu_s_vector4 xpack27 = xpack26 + (three_ups_upu_s_vector4){(-1.0), 1.0, (-1.0), 1.0} *
        xpack18;
    const three_ups_upu_s_vector4 xpack29 = xpack27 + (three_ups_upu_s_vector4){1.0, (-1.0), 1.0, (-1.0)} *
        xpack28;
    const double x66 = x62 * x60;
    const double x68 = xpack4[0];
    const double x69 = x66 * x68;
    const double x61 = x46 * x60;
    const double x178 = xpack29[0];
    const double x179 = x69 * x178;
    const double x225 = x179 - x224;
    const double x65 = -xpack2[0];
    const double x70 = x65 * x69;
    const double x71 = x61 - x70;
    const double x89 = x53 * x88;
    const double x93 = x44 * x88;
    const double x72 = x44 * x71;
    const double x90 = x72 + x89;
    const double x91 = 1.0 / x90;
    const double x226 = x91 * x225;
    const double x92 = x53 * x71;
    const double x94 = x92 - x93;
    const double x43 = x13 * x41;
    const double x227 = x43 * x226;
    const double x228 = 0.5 * x227;
    const double x100 = x15 * x41;
    const double x140 = x112 * x100;
    const double x101 = x14 * x41;
    const double x42 = x12 * x41;
    const double x141 = x134 * x101;
    const double x142 = x140 - x141;
    const double x139 = x122 * x42;
    const double x143 = x139 + x142;
    const double x144 = 0.5 * x143;
    const double x145 = x134 * x144;
    const double x147 = x122 * x101;
    const double x148 = x112 * x43;
    const double x149 = x147 - x148;
    const double x146 = x134 * x42;
    const double x150 = x146 + x149;
    const double x151 = 0.5 * x150;
    const double x152 = x122 * x151;
    const double x153 = x145 - x152;
    const double x232 = x112 * x151;
    const double x123 = x122 * x43;
    const double x124 = x112 * x101;
    const double x125 = x123 + x124;
    const double x135 = x134 * x100;
    const double x136 = x125 + x135;
    const double x137 = 0.5 * x136;
    const double x138 = x112 * x137;
    const double x154 = x138 - x153;
    const double x155 = 0.5 * x154;
    const double x156 = x32 + x155;
    const double x229 = x156 + x228;
    const double x233 = x112 * x42;
    const double x231 = x122 * x137;
    const double x235 = x122 * x100;
    const double x95 = x91 * x94;
    const double x96 = x43 * x95;
    const double x97 = x42 + x96;
    const double x98 = 0.5 * x97;
    const double x99 = 1.0 / x98;
    const double x102 = x101 * x95;
    const double x103 = x100 - x102;
    const double x104 = 0.5 * x103;
    const double x105 = x99 * x104;
    const double x244 = x101 * x226;
    const double x245 = 0.5 * x244;
    const double x234 = x134 * x43;
    const double x236 = x234 - x235;
    const double x237 = x233 + x236;
    const double x238 = 0.5 * x237;
    const double x239 = x134 * x238;
    const double x240 = x232 - x239;
    const double x241 = x231 - x240;
    const double x242 = 0.5 * x241;
    const double x243 = x31 + x242;
    const double x246 = x243 - x245;
    const double x249 = 0.5 * x100;
    const double x248 = 0.5 * x42;
    const double x230 = x105 * x229;
    const double x247 = x230 - x246;
    const double x250 = x249 * x105;
    const double x251 = x248 + x250;
    const double x252 = x247 / x251;
    const double x253 = x249 * x252;
    const double x254 = x229 - x253;
    const double x255 = x99 * x254;
    const double x256 = x94 * x255;
    const double x257 = x91 * x256;
    const double x518 = x110 * x255;
    const double x519 = x120 * x252;
    const double x520 = x518 - x519;
    const double x513 = x51 * x255;
    const double x514 = x80 * x252;
    const double x515 = x513 - x514;
    const double x507 = x107 * x255;
    const double x508 = x114 * x252;
    const double x509 = x507 - x508;
    const double x510 = x226 - x257;
    const double x521 = x128 * x510;
    const double x522 = x520 - x521;
    a[14] = x522;
    const double x516 = x58 * x510;
    const double x517 = x515 - x516;
    a[13] = x517;
    const double x511 = x130 * x510;
    const double x512 = x509 - x511;
    a[12] = x512;
    const three_ups_upu_s_vector4 xgathered11 = {x257, x257, x257, x257};
    const three_ups_upu_s_vector4 xpack49 = xgathered0 * xgathered11;
    const three_ups_upu_s_vector4 xpack38 = xgathered2 * xgathered11;
    const three_ups_upu_s_vector4 xgathered12 = {x255, x252, x255, x252};
    const three_ups_upu_s_vector4 xpack50 = xgathered2 * xgathered12;
    const three_ups_upu_s_vector4 xpack51 = xpack49 + xpack50;
    const three_ups_upu_s_vector4 xpack58 = (three_ups_upu_s_vector4){0.8, 0.8, 0.8, 0.8} * xgathered9;
    const three_ups_upu_s_vector4 xpack60 = xpack58 * xpack30;
    const three_ups_upu_s_vector4 xpack63 = xpack60 + (three_ups_upu_s_vector4){(-1.0), 1.0, 1.0, (-1.0)} *
        xpack62;
    const three_ups_upu_s_vector4 xpack59 = xpack58 * xpack51;
    const three_ups_upu_s_vector4 xpack52 = xpack6 * xpack51;
    const three_ups_upu_s_vector4 xgathered13 = {x226, x226, x226, x226};
    const three_ups_upu_s_vector4 xpack53 = xgathered0 * xgathered13;
    const three_ups_upu_s_vector4 xpack64 = xpack58 * xpack53;
    const three_ups_upu_s_vector4 xpack65 = xpack64 - xpack63;
    const three_ups_upu_s_vector4 xpack66 = xpack65 - xpack59;
    const double x287 = -xpack66[0];
    a[2] = x287;
    const double x360 = -xpack66[1];
    const double x361 = -x360;
    a[5] = x361;
    const double x433 = xpack66[2];
    a[8] = x433;
    const double x506 = -xpack66[3];
    a[11] = x506;
    const three_ups_upu_s_vector4 xpack54 = xpack6 * xpack53;
    const three_ups_upu_s_vector4 xpack55 = xpack54 - xpack37;
    const three_ups_upu_s_vector4 xpack56 = xpack55 - xpack52;
    const three_ups_upu_s_vector4 xpack57 = xpack7 * xpack56;
    const double x278 = -xpack57[0];
    a[1] = x278;
    const double x350 = -xpack57[1];
    const double x351 = -x350;
    a[4] = x351;
    const double x424 = -xpack57[2];
    a[7] = x424;
    const double x496 = -xpack57[3];
    const double x497 = -x496;
    a[10] = x497;
    const three_ups_upu_s_vector4 xpack44 = xgathered2 * xgathered13;
    const three_ups_upu_s_vector4 xpack45 = xpack2 * xpack44;
    const three_ups_upu_s_vector4 xpack46 = xpack29 - xpack45;
    const three_ups_upu_s_vector4 xpack47 = xpack4 * xpack46;
    const three_ups_upu_s_vector4 xpack39 = xgathered0 * xgathered12;
    const three_ups_upu_s_vector4 xpack40 = xpack38 - xpack39;
    const three_ups_upu_s_vector4 xpack41 = xpack2 * xpack40;
    const three_ups_upu_s_vector4 xpack42 = xpack4 * xpack41;
    const three_ups_upu_s_vector4 xgathered14 = {x252, x255, x252, x255};
    const three_ups_upu_s_vector4 xpack43 = xpack42 + (three_ups_upu_s_vector4){1.0, 1.0, (-1.0), (-1.0)} *
        xgathered14;
    const three_ups_upu_s_vector4 xpack48 = xpack47 + xpack43;
    const double x268 = xpack48[0];
    const double x269 = -x268;
    a[0] = x269;
    const double x330 = xpack48[1];
    a[3] = x330;
    const double x404 = xpack48[2];
    a[6] = x404;
    const double x476 = -xpack48[3];
    a[9] = x476;
    const three_ups_upu_s_vector4 every = (three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)((xpack3 +
        xpack48) + (xpack57 + xpack66)) | ((xpack3 <= (three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10}) & (xpack3 >= -(three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10})));
    return fabs(x90) <= 1.0e-09 || fabs(x98) <= 1.0e-09 || fabs(x251) <= 1.0e-09 || !(x39 >= 0.999999 && x39
        <= 1.000001) ? (double)NAN : (((x90 + x98) + (x251 + x512)) + ((x517 + x522) + (every[0] + every[1])))
        + (every[2] + every[3]);
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
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t1 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t2 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t3 = t1 + t2;
    const REAL t4 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t5 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t6 = t4 + t5;
    const REAL t7 = t3 + t6;
    /* limb5_S: geometry; results */
    const REAL t15 = t2 + t5;
    const REAL t53 = t2 + t4;
    const REAL t14 = 4.0 - 2.0 * t7;
    const REAL platform_turn_yy = 1.0 - t14 * t15;
    const REAL t9 = k2 - 0.5 * t7;
    const REAL t62 = 0.5 * (1.0 - t6 * t14);
    const REAL t55 = param_H * (1.0 - t14 * t53);
    const REAL t18 = limb5_S_q_qz * t14;
    const REAL t19 = limb5_S_q_qy * t18;
    const REAL t21 = limb5_S_q_qw * (limb5_S_q_qx * t14);
    const REAL t30 = limb5_S_q_qy * t14;
    const REAL platform_turn_zy = t19 + t21;
    const REAL t47 = param_H * (t19 - t21);
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0);
    const REAL t28 = limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy; /* limb1 */
    const REAL limb1_lower_cos = SINES(cosine, 1), limb1_lower_sin = SINES(sine, 1);
    const REAL t29 = limb1_lower_cos * t28; /* limb1 */
    const REAL t59 = limb1_lower_sin * t28; /* limb1 */
    const REAL t31 = limb5_S_q_qx * t30;
    const REAL t51 = limb5_S_q_qw * t30;
    const REAL t32 = limb5_S_q_qw * t18;
    const REAL t50 = limb5_S_q_qx * t18;
    const REAL platform_turn_xy = t31 - t32;
    const REAL t46 = 0.5 * (t31 + t32);
    /* limb1: reciprocal wrenches, eq. (10); geometry; rates that follow */
    const REAL limb1_U2_constraint_mn_couple_z = t29 - limb1_lower_sin * platform_turn_xy;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_U_0_pivot = limb1_lower_cos * limb1_upper_offset_x;
    const REAL t23 = 1.0 / limb1_U_0_pivot;
    const REAL t35 = limb1_lower_cos * t23;
    const REAL limb1_U_factor_1_by_3 = limb1_U2_constraint_mn_couple_z * t35;
    const REAL limb1_U2_arm_x = limb1_upper_offset_x - param_R * limb1_lower_sin;
    const REAL minus_limb1_U2_factor_0_by_3 = limb1_U2_constraint_mn_couple_z - limb1_U2_arm_x * limb1_U_factor_1_by_3;
    const REAL t37 = limb1_U_0_sin * minus_limb1_U2_factor_0_by_3;
    const REAL t40 = limb1_U_0_cos * minus_limb1_U2_factor_0_by_3;
    const REAL t22 = limb1_U_0_sin * platform_turn_zy;
    const REAL t110 = 0.5 * platform_turn_zy; /* platform */
    const REAL limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + t22;
    const REAL t106 = 0.5 * platform_turn_yy; /* platform */
    const REAL minus_limb1_U_factor_0_by_3 = limb1_lower_sin * limb1_U2_constraint_mn_couple_x * t23;
    const REAL limb1_U_0_lever_moment_y_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL minus_limb1_U2_factor_1_by_3 = limb1_U_0_lever_moment_y_by_limb1_U2_mn - minus_limb1_upper_position_x * minus_limb1_U_factor_0_by_3;
    /* limb5_S: pivots; rates that follow */
    const REAL minus_limb5_S_pivot_wz = limb1_U_0_cos * minus_limb1_U2_factor_1_by_3 + t37;
    const REAL t41 = limb1_U_0_sin * minus_limb1_U2_factor_1_by_3 - t40; /* limb1 */
    const REAL t38 = 1.0 / minus_limb5_S_pivot_wz;
    const REAL limb5_S_null_space_wz_by_limb5_S_wy = t38 * t41;
    /* limb5_S: results; geometry */
    const REAL t11 = limb5_S_q_qx * t9;
    const REAL t42 = t11 * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL t10 = limb5_S_q_qw * t9;
    const REAL a_pivot = 0.5 * (t10 + t42);
    const REAL t89 = 0.5 * t10;
    const REAL t44 = 1.0 / a_pivot;
    const REAL t78 = limb5_S_q_qy * t9;
    const REAL t79 = t78 * limb5_S_null_space_wz_by_limb5_S_wy;
    const REAL t76 = limb5_S_q_qz * t9;
    const REAL t82 = t44 * (0.5 * (t76 - t79));
    const REAL t77 = 0.5 * t76;
    const REAL platform_turn_zx = t50 - t51;
    const REAL t63 = param_H * (t50 + t51);
    const REAL t52 = 0.5 * platform_turn_zx;
    /* limb1: loop closure; geometry; results */
    const REAL t64 = minus_limb1_upper_position_x - (t62 - t63);
    const REAL limb3_upper_position_x_2 = t62 + t63;
    const REAL t65 = limb1_lower_cos * t64;
    const REAL t241 = limb1_lower_sin * t64;
    const REAL minus_limb1_lower_limb_target_x = t46 - t47;
    const REAL limb3_lower_limb_target_x = t46 + t47;
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    const REAL t48 = limb1_upper_offset_x * minus_limb1_lower_rotation_yx - minus_limb1_lower_limb_target_x;
    const REAL t243 = t241 - minus_limb1_lower_rotation_yx * t48;
    const REAL t67 = t65 + limb1_U_0_sin * limb1_lower_sin * t48;
    const REAL t49 = limb1_U_0_cos * t48;
    const REAL minus_limb1_lower_limb_target_y = t52 - t55;
    const REAL limb3_lower_limb_target_y = t52 + t55;
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    const REAL t56 = limb1_upper_offset_x * limb1_lower_rotation_zx + minus_limb1_lower_limb_target_y;
    const REAL minus_limb1_U2_opening_fx = t243 - limb1_lower_rotation_zx * t56;
    const REAL minus_limb1_U2_opening_fy = t67 + limb1_U_0_cos * limb1_lower_sin * t56;
    const REAL t69 = minus_limb1_U2_opening_fy * limb1_U_factor_1_by_3;
    const REAL minus_limb1_U2_opening_fz = t49 - limb1_U_0_sin * t56;
    const REAL t58 = minus_limb1_U2_opening_fz * minus_limb1_U_factor_0_by_3;
    const REAL limb1_U2_opening_mn = t59 + limb1_lower_cos * platform_turn_xy;
    /* step: results; geometry */
    const REAL t72 = t38 * (t58 - (limb1_U2_opening_mn + t69));
    const REAL t74 = 0.5 * (t11 * t72);
    const REAL t86 = 0.5 * (t78 * t72);
    const REAL t102 = 0.5 * platform_turn_xy;
    const REAL t505 = limb1_U2_opening_mn * limb1_U2_opening_mn; /* limb1 */
    const REAL t75 = limb5_S_q_qy - READ(y, 1) - t74;
    const REAL t83 = t82 * t75;
    const REAL a_pivot_2 = t89 + t77 * t82;
    const REAL t91 = (t83 - (limb5_S_q_qx - READ(y, 0) + t86)) / a_pivot_2;
    const REAL t94 = t44 * (t75 - t77 * t91);
    const REAL t96 = t38 * (t41 * t94);
    const REAL t264 = t91 - t23 * (minus_limb1_upper_position_x * (limb1_U_0_cos * t96 - limb1_U_0_sin * t94));
    const REAL t265 = t23 * (minus_limb1_U2_opening_fz + minus_limb1_upper_position_x * (limb1_U_0_cos * t72)) - t264;
    const REAL t266 = t265 * t265;
    const REAL t502 = per_length * minus_limb1_U2_opening_fz; /* limb1 */
    const REAL t503 = t502 * t502; /* limb1 */
    const REAL t250 = limb1_U_0_sin * t96 + limb1_U_0_cos * t94;
    const REAL t269 = limb1_U2_arm_x * t250;
    const REAL t245 = limb1_U_0_sin * t72;
    const REAL t271 = t35 * (minus_limb1_U2_opening_fy - limb1_U2_arm_x * t245 - t269);
    const REAL t273 = t266 + t271 * t271;
    const REAL t499 = per_length * minus_limb1_U2_opening_fy; /* limb1 */
    const REAL t500 = t499 * t499; /* limb1 */
    const REAL minus_limb1_U2_arm_y = param_R * limb1_lower_cos;
    const REAL t253 = per_length * (minus_limb1_U2_opening_fx - minus_limb1_U2_arm_y * t245 - minus_limb1_U2_arm_y * t250);
    const REAL t274 = t253 * t253 + t273;
    const REAL t497 = per_length * minus_limb1_U2_opening_fx; /* limb1 */
    /* limb2: geometry; results; loop closure */
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL t506 = t497 * t497 + t500 + t503 + t505; /* limb1 */
    const REAL t235 = limb2_U_0_sin * t96 - minus_limb2_U_0_cos * t91; /* step */
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 4);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    const REAL limb2_lower_cos = SINES(cosine, 4);
    const REAL t236 = minus_limb2_upper_position_y * t235; /* step */
    const REAL limb2_U_0_pivot = limb2_lower_cos * limb2_upper_offset_x;
    const REAL t214 = 1.0 / limb2_U_0_pivot;
    const REAL t238 = t94 - t214 * t236; /* step */
    const REAL t230 = minus_limb2_upper_position_y * (limb2_U_0_sin * t72); /* step */
    const REAL limb2_lower_limb_target_y = t63 - t102;
    const REAL limb4_lower_limb_target_y = t63 + t102;
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    const REAL t197 = limb2_upper_offset_x * minus_limb2_lower_rotation_xx + limb2_lower_limb_target_y;
    const REAL t198 = minus_limb2_lower_rotation_xx * t197;
    const REAL t227 = limb2_U_0_sin * t197;
    const REAL limb2_lower_limb_target_x = t55 - t110;
    const REAL limb4_lower_limb_target_x = t55 + t110;
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL t202 = limb2_upper_offset_x * minus_limb2_lower_rotation_zx + limb2_lower_limb_target_x;
    const REAL t203 = minus_limb2_lower_rotation_zx * t202;
    const REAL minus_limb2_S_opening_fz = t227 - minus_limb2_U_0_cos * t202;
    const REAL t239 = t214 * (minus_limb2_S_opening_fz - t230) + t238; /* step */
    const REAL t275 = t239 * t239 + t274; /* step */
    const REAL t215 = limb2_lower_cos * t214;
    const REAL t513 = per_length * minus_limb2_S_opening_fz;
    const REAL t514 = t513 * t513;
    const REAL t209 = minus_limb2_U_0_cos * t96 + limb2_U_0_sin * t91; /* step */
    const REAL limb2_S_arm_x = limb2_upper_offset_x - param_R * limb2_lower_sin;
    const REAL t223 = limb2_S_arm_x * t209; /* step */
    const REAL t204 = minus_limb2_U_0_cos * t72; /* step */
    const REAL t221 = limb2_S_arm_x * t204; /* step */
    const REAL t216 = minus_limb2_U_0_cos * limb2_lower_sin * t197;
    const REAL t199 = minus_limb2_upper_position_y + (t47 - t106);
    const REAL limb4_upper_position_y_2 = t47 + t106;
    const REAL t218 = t216 + limb2_lower_cos * t199;
    const REAL limb2_S_opening_fx = t198 - limb2_lower_sin * t199 + t203;
    const REAL minus_limb2_S_opening_fy = t218 + limb2_U_0_sin * limb2_lower_sin * t202;
    const REAL t225 = t215 * (minus_limb2_S_opening_fy + t221 + t223); /* step */
    const REAL t276 = t225 * t225 + t275; /* step */
    const REAL t510 = per_length * minus_limb2_S_opening_fy;
    const REAL t511 = t510 * t510;
    const REAL minus_limb2_S_arm_y = param_R * limb2_lower_cos;
    const REAL t212 = per_length * (limb2_S_opening_fx - minus_limb2_S_arm_y * t204 - minus_limb2_S_arm_y * t209); /* step */
    const REAL t277 = t212 * t212 + t276; /* step */
    const REAL t507 = per_length * limb2_S_opening_fx;
    /* limb3: geometry; loop closure; results */
    const REAL limb3_U_0_cos = SINES(cosine, 5), limb3_U_0_sin = SINES(sine, 5);
    const REAL t515 = t506 + t507 * t507 + t511 + t514; /* residual */
    const REAL t190 = limb3_U_0_cos * t96 - limb3_U_0_sin * t94; /* step */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 6);
    const REAL t534 = limb2_upper_offset_x * limb3_upper_offset_x; /* orientation */
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL t191 = limb3_upper_position_x * t190; /* step */
    const REAL t152 = limb3_upper_position_x - limb3_upper_position_x_2;
    const REAL limb3_lower_cos = SINES(cosine, 6);
    const REAL limb3_U_0_pivot = limb3_lower_cos * limb3_upper_offset_x;
    const REAL t169 = 1.0 / limb3_U_0_pivot;
    const REAL t193 = t91 + t169 * t191; /* step */
    const REAL t185 = limb3_upper_position_x * (limb3_U_0_cos * t72); /* step */
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    const REAL t154 = limb3_upper_offset_x * minus_limb3_lower_rotation_yx + limb3_lower_limb_target_x;
    const REAL t155 = minus_limb3_lower_rotation_yx * t154;
    const REAL t182 = limb3_U_0_cos * t154;
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    const REAL t157 = limb3_upper_offset_x * limb3_lower_rotation_zx - limb3_lower_limb_target_y;
    const REAL t158 = limb3_lower_rotation_zx * t157;
    const REAL minus_limb3_S_opening_fz = t182 - limb3_U_0_sin * t157;
    const REAL t194 = t169 * (minus_limb3_S_opening_fz - t185) - t193; /* step */
    const REAL t278 = t194 * t194 + t277; /* step */
    const REAL t170 = limb3_lower_cos * t169;
    const REAL t522 = per_length * minus_limb3_S_opening_fz;
    const REAL t523 = t522 * t522;
    const REAL t164 = limb3_U_0_sin * t96 + limb3_U_0_cos * t94; /* step */
    const REAL limb3_S_arm_x = limb3_upper_offset_x - param_R * minus_limb3_lower_sin;
    const REAL t178 = limb3_S_arm_x * t164; /* step */
    const REAL t159 = limb3_U_0_sin * t72; /* step */
    const REAL t176 = limb3_S_arm_x * t159; /* step */
    const REAL t171 = limb3_lower_cos * t152;
    const REAL minus_limb3_S_opening_fx = minus_limb3_lower_sin * t152 - t155 - t158;
    const REAL t173 = t171 + limb3_U_0_sin * minus_limb3_lower_sin * t154;
    const REAL limb3_S_opening_fy = t173 + limb3_U_0_cos * minus_limb3_lower_sin * t157;
    const REAL t180 = t170 * (limb3_S_opening_fy + t176 + t178); /* step */
    const REAL t279 = t180 * t180 + t278; /* step */
    const REAL t519 = per_length * limb3_S_opening_fy;
    const REAL t520 = t519 * t519;
    const REAL limb3_S_arm_y = param_R * limb3_lower_cos;
    const REAL t167 = per_length * (minus_limb3_S_opening_fx + limb3_S_arm_y * t159 + limb3_S_arm_y * t164); /* step */
    const REAL t280 = t167 * t167 + t279; /* step */
    const REAL t516 = per_length * minus_limb3_S_opening_fx;
    /* limb4: geometry; loop closure; reciprocal wrenches, eq. (10) */
    const REAL limb4_U_0_sin = SINES(cosine, 7), minus_limb4_U_0_cos = SINES(sine, 7);
    const REAL t524 = t515 + t516 * t516 + t520 + t523; /* residual */
    const REAL t144 = limb4_U_0_sin * t96 - minus_limb4_U_0_cos * t91; /* step */
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_lower_sin = SINES(sine, 9);
    const REAL t538 = limb2_U_0_pivot * (limb3_U_0_pivot * (limb1_upper_offset_x * (limb4_upper_offset_x * t534))); /* orientation */
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL t145 = limb4_upper_position_y * t144; /* step */
    const REAL t107 = limb4_upper_position_y - limb4_upper_position_y_2;
    const REAL limb4_lower_cos = SINES(cosine, 9);
    const REAL limb4_U_0_pivot = limb4_lower_cos * limb4_upper_offset_x;
    const REAL t543 = a_pivot_2 * (a_pivot * (minus_limb5_S_pivot_wz * (limb1_U_0_pivot * (limb4_U_0_pivot * t538)))); /* orientation */
    const REAL orientation_orientation = -t543;
    WRITE(orientation_, 0, orientation_orientation);
    REAL checked0 = orientation_orientation;
    const REAL t123 = 1.0 / limb4_U_0_pivot;
    const REAL t147 = t94 + t123 * t145; /* step */
    const REAL t139 = limb4_upper_position_y * (limb4_U_0_sin * t72); /* step */
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    const REAL t103 = limb4_upper_offset_x * minus_limb4_lower_rotation_xx + limb4_lower_limb_target_y;
    const REAL t104 = minus_limb4_lower_rotation_xx * t103;
    const REAL t136 = limb4_U_0_sin * t103;
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL t111 = limb4_upper_offset_x * minus_limb4_lower_rotation_zx + limb4_lower_limb_target_x;
    const REAL t112 = minus_limb4_lower_rotation_zx * t111;
    const REAL minus_limb4_S_opening_fz = t136 - minus_limb4_U_0_cos * t111;
    /* step: results; geometry */
    const REAL t148 = t123 * (minus_limb4_S_opening_fz + t139) + t147;
    const REAL t281 = t148 * t148 + t280;
    const REAL t124 = limb4_lower_cos * t123; /* limb4 */
    const REAL t531 = per_length * minus_limb4_S_opening_fz; /* limb4 */
    const REAL t532 = t531 * t531; /* limb4 */
    const REAL t116 = minus_limb4_U_0_cos * t96;
    const REAL t97 = t72 + t96;
    const REAL t113 = minus_limb4_U_0_cos * t72;
    const REAL t118 = t116 + limb4_U_0_sin * t91;
    const REAL limb4_S_arm_x = limb4_upper_offset_x - param_R * minus_limb4_lower_sin;
    const REAL t132 = limb4_S_arm_x * t118;
    const REAL t130 = limb4_S_arm_x * t113;
    const REAL t127 = minus_limb4_U_0_cos * minus_limb4_lower_sin * t103 + limb4_lower_cos * t107; /* limb4 */
    const REAL limb4_S_opening_fx = t104 - minus_limb4_lower_sin * t107 + t112;
    const REAL limb4_S_opening_fy = t127 + limb4_U_0_sin * minus_limb4_lower_sin * t111;
    const REAL t134 = t124 * (limb4_S_opening_fy - t130 - t132);
    const REAL t282 = t134 * t134 + t281;
    const REAL t528 = per_length * limb4_S_opening_fy; /* limb4 */
    const REAL t529 = t528 * t528; /* limb4 */
    const REAL limb4_S_arm_y = param_R * limb4_lower_cos;
    const REAL t121 = per_length * (limb4_S_opening_fx + limb4_S_arm_y * t113 + limb4_S_arm_y * t118);
    const REAL t283 = t121 * t121 + t282;
    const REAL t525 = per_length * limb4_S_opening_fx; /* limb4 */
    const REAL residual_residual = SQRT(t524 + t525 * t525 + t529 + t532);
    WRITE(residual_, 0, residual_residual);
    REAL checked1 = residual_residual;
    const REAL t286 = t97 * t97 + (t94 * t94 + (t91 * t91 + t283));
    const REAL step_step = SQRT(t286);
    WRITE(step, 0, step_step);
    REAL checked2 = step_step;
    const REAL t287 = LESS(step_step, 0.5);
    const REAL t290 = SELECT(t287, 1.0, 0.5 / SELECT(t287, 1.0, step_step));
    const REAL t292 = 0.5 * (t94 * t290);
    const REAL t298 = t97 * t290;
    const REAL t295 = 0.5 * (t91 * t290);
    const REAL t299 = 0.5 * t298;
    const REAL t323 = limb5_S_q_qw + (limb5_S_q_qz * t299 + (limb5_S_q_qy * t292 - limb5_S_q_qx * t295));
    const REAL t324 = t323 * t323;
    const REAL t316 = limb5_S_q_qy * t299 - limb5_S_q_qz * t292 + (limb5_S_q_qx + limb5_S_q_qw * t295);
    const REAL t325 = t316 * t316 + t324;
    const REAL t296 = limb5_S_q_qy * t295;
    const REAL t301 = limb5_S_q_qz - limb5_S_q_qw * t299;
    const REAL t309 = limb5_S_q_qz * t295 + limb5_S_q_qx * t299 - (limb5_S_q_qy - limb5_S_q_qw * t292);
    const REAL t302 = limb5_S_q_qx * t292 + t296 + t301;
    const REAL t329 = 1.0 / SQRT(t302 * t302 + (t309 * t309 + t325));
    const REAL limb5_S_q_next_qz = t302 * t329;
    WRITE(q_next, 15, limb5_S_q_next_qz);
    const REAL t331 = t309 * t329;
    const REAL limb5_S_q_next_qx = t316 * t329;
    WRITE(q_next, 13, limb5_S_q_next_qx);
    const REAL limb5_S_q_next_qw = t323 * t329;
    WRITE(q_next, 12, limb5_S_q_next_qw);
    const REAL limb5_S_q_next_qy = -t331;
    WRITE(q_next, 14, limb5_S_q_next_qy);
    REAL checked3 = limb5_S_q_next_qy;
    /* limb5_S: geometry */
    const REAL t330 = limb5_S_q_next_qz * limb5_S_q_next_qz;
    const REAL t332 = t331 * t331;
    const REAL t333 = t330 + t332;
    const REAL t334 = limb5_S_q_next_qx * limb5_S_q_next_qx;
    const REAL t340 = t334 + t332;
    const REAL t413 = t330 + t334;
    const REAL t339 = 4.0 - 2.0 * (t333 + (t334 + limb5_S_q_next_qw * limb5_S_q_next_qw));
    const REAL t345 = limb5_S_q_next_qz * t339;
    const REAL t342 = param_H * (1.0 - t339 * t340);
    const REAL t376 = 0.5 * (1.0 - t333 * t339);
    const REAL t415 = 0.5 * (1.0 - t413 * t339);
    const REAL t349 = limb5_S_q_next_qw * (limb5_S_q_next_qx * t339);
    const REAL t343 = t331 * t339;
    const REAL t350 = t331 * t345;
    const REAL platform_turn_zy_2 = t349 - t350;
    const REAL t351 = param_H * (t349 + t350);
    const REAL t392 = 0.5 * platform_turn_zy_2;
    const REAL t352 = limb5_S_q_next_qw * t345;
    const REAL t344 = limb5_S_q_next_qw * t343;
    const REAL t353 = limb5_S_q_next_qx * t343;
    const REAL t346 = limb5_S_q_next_qx * t345;
    const REAL minus_platform_turn_xy = t352 + t353;
    const REAL t354 = 0.5 * (t352 - t353);
    const REAL t391 = 0.5 * minus_platform_turn_xy;
    const REAL minus_limb1_lower_limb_target_x_2 = t351 + t354;
    const REAL minus_limb3_lower_limb_target_x = t351 - t354;
    /* limb1: geometry; results */
    const REAL t355 = limb1_U_0_sin * minus_limb1_lower_limb_target_x_2;
    const REAL minus_platform_turn_xz = t344 - t346;
    const REAL t347 = 0.5 * (t344 + t346); /* platform */
    const REAL t374 = param_H * minus_platform_turn_xz; /* platform */
    const REAL limb1_lower_limb_target_y = t342 - t347;
    const REAL limb3_lower_limb_target_y_2 = t342 + t347;
    const REAL t360 = SELECT(LESS(-(t355 + limb1_U_0_cos * limb1_lower_limb_target_y), 0.0), (-1.0), 1.0);
    const REAL t361 = limb1_lower_limb_target_y * limb1_lower_limb_target_y;
    const REAL t363 = t361 + minus_limb1_lower_limb_target_x_2 * minus_limb1_lower_limb_target_x_2;
    const REAL t364 = SQRT(t363);
    const REAL t365 = t360 / t364;
    const REAL t381 = t360 * t364;
    const REAL minus_limb1_U_0_sin = minus_limb1_lower_limb_target_x_2 * t365;
    const REAL minus_limb1_U_0_cos = limb1_lower_limb_target_y * t365;
    const REAL t372 = -(limb1_U_0_sin * minus_limb1_U_0_sin + limb1_U_0_cos * minus_limb1_U_0_cos);
    RESULT(checked0, q_next, 0, READ(q, 0) + atan2(limb1_U_0_sin * minus_limb1_U_0_cos - limb1_U_0_cos * minus_limb1_U_0_sin, t372));
    const REAL limb1_lower_limb_target_z = param_R - (t374 + t376);
    const REAL minus_limb3_lower_limb_target_z = param_R + (t374 - t376);
    const REAL limb1_lower_limb_length = SQRT(limb1_lower_limb_target_z * limb1_lower_limb_target_z + t363);
    RESULT(checked1, q_next, 2, limb1_lower_limb_length - limb_upper_phase);
    const REAL t380 = 1.0 / limb1_lower_limb_length;
    const REAL minus_limb1_lower_cos = t380 * t381;
    const REAL limb1_lower_sin_2 = limb1_lower_limb_target_z * t380;
    const REAL t384 = limb1_lower_sin * minus_limb1_lower_cos + limb1_lower_cos * limb1_lower_sin_2;
    RESULT(checked2, q_next, 1, READ(q, 1) + atan2(t384, limb1_lower_sin * limb1_lower_sin_2 - limb1_lower_cos * minus_limb1_lower_cos));
    /* limb2: geometry; results */
    const REAL minus_limb2_lower_limb_target_x = t392 - t342;
    const REAL limb4_lower_limb_target_x_2 = t392 + t342;
    const REAL t390 = SINES(sine, 3);
    const REAL t393 = t390 * minus_limb2_lower_limb_target_x;
    const REAL limb2_lower_limb_target_y_2 = t391 - t374;
    const REAL minus_limb4_lower_limb_target_y = t391 + t374;
    const REAL t394 = SINES(cosine, 3);
    const REAL t399 = SELECT(LESS(-(t393 + t394 * limb2_lower_limb_target_y_2), 0.0), (-1.0), 1.0);
    const REAL t400 = limb2_lower_limb_target_y_2 * limb2_lower_limb_target_y_2;
    const REAL t402 = t400 + minus_limb2_lower_limb_target_x * minus_limb2_lower_limb_target_x;
    const REAL t403 = SQRT(t402);
    const REAL t404 = t399 / t403;
    const REAL t420 = t399 * t403;
    const REAL minus_limb2_U_0_sin = minus_limb2_lower_limb_target_x * t404;
    const REAL minus_limb2_U_0_cos_2 = limb2_lower_limb_target_y_2 * t404;
    const REAL t411 = -(t390 * minus_limb2_U_0_sin + t394 * minus_limb2_U_0_cos_2);
    RESULT(checked3, q_next, 3, READ(q, 3) + atan2(t390 * minus_limb2_U_0_cos_2 - t394 * minus_limb2_U_0_sin, t411));
    const REAL t482 = t415 - t351; /* platform */
    const REAL limb2_lower_limb_target_z = param_R - (t415 + t351);
    const REAL minus_limb4_lower_limb_target_z = param_R - t482;
    const REAL limb2_lower_limb_length = SQRT(limb2_lower_limb_target_z * limb2_lower_limb_target_z + t402);
    RESULT(checked0, q_next, 5, limb2_lower_limb_length - limb_upper_phase);
    const REAL t419 = 1.0 / limb2_lower_limb_length;
    const REAL minus_limb2_lower_cos = t419 * t420;
    const REAL limb2_lower_sin_2 = limb2_lower_limb_target_z * t419;
    const REAL t423 = limb2_lower_sin * minus_limb2_lower_cos + limb2_lower_cos * limb2_lower_sin_2;
    RESULT(checked1, q_next, 4, READ(q, 4) + atan2(t423, limb2_lower_sin * limb2_lower_sin_2 - limb2_lower_cos * minus_limb2_lower_cos));
    /* limb3: geometry; results */
    const REAL t430 = limb3_U_0_sin * minus_limb3_lower_limb_target_x + limb3_U_0_cos * limb3_lower_limb_target_y_2;
    const REAL t433 = SELECT(LESS(-t430, 0.0), (-1.0), 1.0);
    const REAL t434 = limb3_lower_limb_target_y_2 * limb3_lower_limb_target_y_2;
    const REAL t436 = t434 + minus_limb3_lower_limb_target_x * minus_limb3_lower_limb_target_x;
    const REAL t437 = SQRT(t436);
    const REAL t438 = t433 / t437;
    const REAL t451 = t433 * t437;
    const REAL minus_limb3_U_0_sin = minus_limb3_lower_limb_target_x * t438;
    const REAL minus_limb3_U_0_cos = limb3_lower_limb_target_y_2 * t438;
    const REAL t445 = -(limb3_U_0_sin * minus_limb3_U_0_sin + limb3_U_0_cos * minus_limb3_U_0_cos);
    RESULT(checked2, q_next, 6, READ(q, 6) + atan2(limb3_U_0_sin * minus_limb3_U_0_cos - limb3_U_0_cos * minus_limb3_U_0_sin, t445));
    const REAL limb3_lower_limb_length = SQRT(minus_limb3_lower_limb_target_z * minus_limb3_lower_limb_target_z + t436);
    RESULT(checked3, q_next, 8, limb3_lower_limb_length - limb_upper_phase);
    const REAL t450 = 1.0 / limb3_lower_limb_length;
    const REAL minus_limb3_lower_cos = t450 * t451;
    const REAL minus_limb3_lower_sin_2 = minus_limb3_lower_limb_target_z * t450;
    const REAL t455 = -(minus_limb3_lower_sin * minus_limb3_lower_cos + limb3_lower_cos * minus_limb3_lower_sin_2);
    const REAL t459 = atan2(t455, minus_limb3_lower_sin * minus_limb3_lower_sin_2 - limb3_lower_cos * minus_limb3_lower_cos);
    RESULT(checked0, q_next, 7, READ(q, 7) + t459);
    /* limb4: results; geometry */
    const REAL t462 = SINES(sine, 8), t461 = SINES(cosine, 8);
    const REAL t467 = SELECT(LESS(t462 * limb4_lower_limb_target_x_2 + t461 * minus_limb4_lower_limb_target_y, 0.0), (-1.0), 1.0);
    const REAL t468 = minus_limb4_lower_limb_target_y * minus_limb4_lower_limb_target_y;
    const REAL t470 = t468 + limb4_lower_limb_target_x_2 * limb4_lower_limb_target_x_2;
    const REAL t471 = SQRT(t470);
    const REAL t472 = t467 / t471;
    const REAL t486 = t467 * t471;
    const REAL t473 = limb4_lower_limb_target_x_2 * t472;
    const REAL t475 = minus_limb4_lower_limb_target_y * t472;
    const REAL t477 = t461 * t473 - t462 * t475;
    RESULT(checked1, q_next, 9, READ(q, 9) + atan2(t477, t462 * t473 + t461 * t475));
    const REAL limb4_lower_limb_length = SQRT(minus_limb4_lower_limb_target_z * minus_limb4_lower_limb_target_z + t470);
    RESULT(checked2, q_next, 11, limb4_lower_limb_length - limb_upper_phase);
    const REAL t485 = 1.0 / limb4_lower_limb_length;
    const REAL t487 = t485 * t486;
    const REAL t489 = minus_limb4_lower_limb_target_z * t485;
    const REAL t492 = -(minus_limb4_lower_sin * t487 + limb4_lower_cos * t489);
    RESULT(checked3, q_next, 10, READ(q, 10) + atan2(t492, minus_limb4_lower_sin * t489 - limb4_lower_cos * t487));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_U_0_pivot, 6.62327e-13) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_pivot, 6.62327e-13) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_pivot, 6.62327e-13) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-13) OR /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
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
