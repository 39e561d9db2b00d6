/*
 * three_ups_upu_s: kinematics.
 *   body_poses; body_twists; body_twist_rates; forward_kinematics; point_motion; joint_screws;
 *   joint_points; platform_jacobian; joint_displacements; joint_rates; drive_rates;
 *   inverse_kinematics; inverse_velocity
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

BODY(three_ups_upu_s_body_poses)(size_t stride, const double *restrict q, double *restrict poses,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb4: geometry */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL limb4_U_0_cos = -minus_limb4_U_0_cos;
    WRITE(poses, 86, limb4_U_0_cos);
    WRITE(poses, 98, limb4_U_0_cos);
    REAL checked0 = limb4_U_0_cos;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL limb2_U_0_cos = -minus_limb2_U_0_cos;
    WRITE(poses, 38, limb2_U_0_cos);
    WRITE(poses, 50, limb2_U_0_cos);
    REAL checked1 = limb2_U_0_cos;
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    WRITE(poses, 84, limb4_U_0_sin);
    WRITE(poses, 96, limb4_U_0_sin);
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    /* limb4: results; geometry */
    const REAL t116 = 0.5 * minus_limb4_lower_rotation_zx;
    const REAL minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin;
    const REAL limb4_lower_poses_Rzy = t116 + k1 * minus_limb4_lower_rotation_zy;
    WRITE(poses, 89, limb4_lower_poses_Rzy);
    WRITE(poses, 101, limb4_lower_poses_Rzy);
    const REAL t125 = 0.5 * minus_limb4_lower_rotation_zy;
    const REAL t138 = 0.5 * limb4_lower_poses_Rzy;
    const REAL limb4_lower_poses_z = -(param_R * limb4_lower_poses_Rzy);
    WRITE(poses, 95, limb4_lower_poses_z);
    REAL checked2 = limb4_lower_poses_z;
    const REAL t126 = k1 * minus_limb4_lower_rotation_zx - t125;
    const REAL limb4_lower_poses_Rzz = -t126;
    WRITE(poses, 92, limb4_lower_poses_Rzz);
    WRITE(poses, 104, limb4_lower_poses_Rzz);
    REAL checked3 = limb4_lower_poses_Rzz;
    const REAL t140 = t138 - param_H * t126;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    RESULT(checked0, poses, 107, -(limb4_upper_offset_x * minus_limb4_lower_rotation_zx + t140));
    const REAL limb4_lower_poses_Ryy = 0.5 * minus_limb4_lower_sin - k1 * limb4_lower_cos;
    WRITE(poses, 88, limb4_lower_poses_Ryy);
    WRITE(poses, 100, limb4_lower_poses_Ryy);
    const REAL t135 = 0.5 * limb4_lower_poses_Ryy;
    RESULT(checked1, poses, 94, param_R - param_R * limb4_lower_poses_Ryy);
    const REAL t123 = k1 * minus_limb4_lower_sin + 0.5 * limb4_lower_cos;
    const REAL limb4_lower_poses_Ryz = -t123;
    WRITE(poses, 91, limb4_lower_poses_Ryz);
    WRITE(poses, 103, limb4_lower_poses_Ryz);
    checked2 = checked2 + limb4_lower_poses_Ryz;
    RESULT(checked3, poses, 106, param_R - minus_limb4_lower_sin * limb4_upper_offset_x - (t135 - param_H * t123));
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    const REAL minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx;
    const REAL t112 = 0.5 * minus_limb4_lower_rotation_xx;
    const REAL t118 = k1 * minus_limb4_lower_rotation_xx;
    const REAL minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin;
    const REAL limb4_lower_poses_Rxy = t112 + k1 * minus_limb4_lower_rotation_xy;
    WRITE(poses, 87, limb4_lower_poses_Rxy);
    WRITE(poses, 99, limb4_lower_poses_Rxy);
    const REAL t120 = t118 - 0.5 * minus_limb4_lower_rotation_xy;
    const REAL limb4_lower_poses_Rxz = -t120;
    WRITE(poses, 90, limb4_lower_poses_Rxz);
    WRITE(poses, 102, limb4_lower_poses_Rxz);
    checked0 = checked0 + limb4_lower_poses_Rxz;
    RESULT(checked1, poses, 105, -(minus_limb4_upper_position_x + (0.5 * limb4_lower_poses_Rxy - param_H * t120)));
    RESULT(checked2, poses, 93, -(param_R * limb4_lower_poses_Rxy));
    /* limb3: geometry */
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    WRITE(poses, 64, limb3_U_0_cos);
    WRITE(poses, 76, limb3_U_0_cos);
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    /* limb3: results; geometry */
    const REAL t87 = 0.5 * limb3_lower_rotation_zx;
    const REAL limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin;
    const REAL t89 = t87 - k1 * limb3_lower_rotation_zy;
    const REAL t97 = 0.5 * limb3_lower_rotation_zy;
    RESULT(checked3, poses, 71, param_R * t89);
    const REAL limb3_lower_poses_Rzx = -t89;
    WRITE(poses, 62, limb3_lower_poses_Rzx);
    WRITE(poses, 74, limb3_lower_poses_Rzx);
    checked0 = checked0 + limb3_lower_poses_Rzx;
    const REAL t108 = 0.5 * t89;
    const REAL limb3_lower_poses_Rzz = k1 * limb3_lower_rotation_zx + t97;
    WRITE(poses, 68, limb3_lower_poses_Rzz);
    WRITE(poses, 80, limb3_lower_poses_Rzz);
    const REAL t110 = t108 - param_H * limb3_lower_poses_Rzz;
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    RESULT(checked1, poses, 83, limb3_upper_offset_x * limb3_lower_rotation_zx + t110);
    const REAL limb3_U_0_sin = SINES(sine, 4);
    WRITE(poses, 65, limb3_U_0_sin);
    WRITE(poses, 77, limb3_U_0_sin);
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    const REAL t85 = 0.5 * minus_limb3_lower_rotation_yx;
    const REAL minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin;
    const REAL limb3_lower_poses_Ryx = t85 - k1 * minus_limb3_lower_rotation_yy;
    WRITE(poses, 61, limb3_lower_poses_Ryx);
    WRITE(poses, 73, limb3_lower_poses_Ryx);
    const REAL t94 = 0.5 * minus_limb3_lower_rotation_yy;
    const REAL t104 = 0.5 * limb3_lower_poses_Ryx;
    RESULT(checked2, poses, 70, -(param_R * limb3_lower_poses_Ryx));
    const REAL t95 = k1 * minus_limb3_lower_rotation_yx + t94;
    const REAL minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx;
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    const REAL limb3_lower_poses_Ryz = -t95;
    WRITE(poses, 67, limb3_lower_poses_Ryz);
    WRITE(poses, 79, limb3_lower_poses_Ryz);
    checked3 = checked3 + limb3_lower_poses_Ryz;
    RESULT(checked0, poses, 82, -(minus_limb3_upper_position_y + (t104 - param_H * t95)));
    const REAL limb3_lower_poses_Rxx = 0.5 * minus_limb3_lower_sin + k1 * limb3_lower_cos;
    WRITE(poses, 60, limb3_lower_poses_Rxx);
    WRITE(poses, 72, limb3_lower_poses_Rxx);
    const REAL t101 = 0.5 * limb3_lower_poses_Rxx;
    RESULT(checked1, poses, 69, param_R - param_R * limb3_lower_poses_Rxx);
    const REAL t92 = k1 * minus_limb3_lower_sin - 0.5 * limb3_lower_cos;
    const REAL limb3_lower_poses_Rxz = -t92;
    WRITE(poses, 66, limb3_lower_poses_Rxz);
    WRITE(poses, 78, limb3_lower_poses_Rxz);
    checked2 = checked2 + limb3_lower_poses_Rxz;
    RESULT(checked3, poses, 81, limb3_upper_position_x - (t101 - param_H * t92));
    /* limb2: geometry */
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    WRITE(poses, 36, limb2_U_0_sin);
    WRITE(poses, 48, limb2_U_0_sin);
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL limb2_lower_sin = SINES(sine, 3);
    /* limb2: results; geometry */
    const REAL t57 = 0.5 * minus_limb2_lower_rotation_zx;
    const REAL limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin;
    const REAL t59 = t57 + k1 * limb2_lower_rotation_zy;
    const REAL t66 = 0.5 * limb2_lower_rotation_zy;
    const REAL limb2_lower_poses_Rzy = -t59;
    WRITE(poses, 41, limb2_lower_poses_Rzy);
    WRITE(poses, 53, limb2_lower_poses_Rzy);
    checked0 = checked0 + limb2_lower_poses_Rzy;
    const REAL t78 = 0.5 * t59;
    RESULT(checked1, poses, 47, -(param_R * t59));
    const REAL t67 = k1 * minus_limb2_lower_rotation_zx - t66;
    const REAL limb2_lower_poses_Rzz = -t67;
    WRITE(poses, 44, limb2_lower_poses_Rzz);
    WRITE(poses, 56, limb2_lower_poses_Rzz);
    checked2 = checked2 + limb2_lower_poses_Rzz;
    const REAL t80 = t78 - param_H * t67;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    RESULT(checked3, poses, 59, -(limb2_upper_offset_x * minus_limb2_lower_rotation_zx + t80));
    const REAL limb2_lower_poses_Ryy = 0.5 * limb2_lower_sin - k1 * limb2_lower_cos;
    WRITE(poses, 40, limb2_lower_poses_Ryy);
    WRITE(poses, 52, limb2_lower_poses_Ryy);
    const REAL t75 = 0.5 * limb2_lower_poses_Ryy;
    RESULT(checked0, poses, 46, param_R * limb2_lower_poses_Ryy - param_R);
    const REAL limb2_lower_poses_Ryz = k1 * limb2_lower_sin + 0.5 * limb2_lower_cos;
    WRITE(poses, 43, limb2_lower_poses_Ryz);
    WRITE(poses, 55, limb2_lower_poses_Ryz);
    RESULT(checked1, poses, 58, t75 - param_H * limb2_lower_poses_Ryz - (param_R - limb2_lower_sin * limb2_upper_offset_x));
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    const REAL minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx;
    const REAL t52 = 0.5 * minus_limb2_lower_rotation_xx;
    const REAL t60 = k1 * minus_limb2_lower_rotation_xx;
    const REAL limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin;
    const REAL t54 = t52 + k1 * limb2_lower_rotation_xy;
    const REAL t62 = t60 - 0.5 * limb2_lower_rotation_xy;
    const REAL limb2_lower_poses_Rxz = -t62;
    WRITE(poses, 42, limb2_lower_poses_Rxz);
    WRITE(poses, 54, limb2_lower_poses_Rxz);
    checked2 = checked2 + limb2_lower_poses_Rxz;
    const REAL t72 = param_H * t62;
    const REAL limb2_lower_poses_Rxy = -t54;
    WRITE(poses, 39, limb2_lower_poses_Rxy);
    WRITE(poses, 51, limb2_lower_poses_Rxy);
    checked3 = checked3 + limb2_lower_poses_Rxy;
    RESULT(checked0, poses, 57, -(minus_limb2_upper_position_x + (0.5 * t54 - t72)));
    RESULT(checked1, poses, 45, -(param_R * t54));
    /* limb1: geometry */
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    WRITE(poses, 16, limb1_U_0_cos);
    WRITE(poses, 28, limb1_U_0_cos);
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    const REAL limb1_lower_sin = SINES(sine, 1);
    /* limb1: results; geometry */
    const REAL t30 = 0.5 * limb1_lower_rotation_zx;
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin;
    const REAL limb1_lower_poses_Rzx = t30 - k1 * minus_limb1_lower_rotation_zy;
    WRITE(poses, 14, limb1_lower_poses_Rzx);
    WRITE(poses, 26, limb1_lower_poses_Rzx);
    const REAL t38 = 0.5 * minus_limb1_lower_rotation_zy;
    RESULT(checked2, poses, 23, param_R * limb1_lower_poses_Rzx);
    const REAL t48 = 0.5 * limb1_lower_poses_Rzx;
    const REAL limb1_lower_poses_Rzz = k1 * limb1_lower_rotation_zx + t38;
    WRITE(poses, 20, limb1_lower_poses_Rzz);
    WRITE(poses, 32, limb1_lower_poses_Rzz);
    const REAL t50 = t48 - param_H * limb1_lower_poses_Rzz;
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    RESULT(checked3, poses, 35, limb1_upper_offset_x * limb1_lower_rotation_zx + t50);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    WRITE(poses, 17, limb1_U_0_sin);
    WRITE(poses, 29, limb1_U_0_sin);
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    const REAL t27 = 0.5 * minus_limb1_lower_rotation_yx;
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    const REAL t29 = t27 - k1 * limb1_lower_rotation_yy;
    const REAL t35 = 0.5 * limb1_lower_rotation_yy;
    const REAL limb1_lower_poses_Ryx = -t29;
    WRITE(poses, 13, limb1_lower_poses_Ryx);
    WRITE(poses, 25, limb1_lower_poses_Ryx);
    checked0 = checked0 + limb1_lower_poses_Ryx;
    const REAL t44 = 0.5 * t29;
    RESULT(checked1, poses, 22, -(param_R * t29));
    const REAL t36 = k1 * minus_limb1_lower_rotation_yx + t35;
    const REAL minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    const REAL limb1_lower_poses_Ryz = -t36;
    WRITE(poses, 19, limb1_lower_poses_Ryz);
    WRITE(poses, 31, limb1_lower_poses_Ryz);
    checked2 = checked2 + limb1_lower_poses_Ryz;
    RESULT(checked3, poses, 34, -(minus_limb1_upper_position_y + (t44 - param_H * t36)));
    const REAL limb1_lower_poses_Rxx = 0.5 * limb1_lower_sin + k1 * limb1_lower_cos;
    WRITE(poses, 12, limb1_lower_poses_Rxx);
    WRITE(poses, 24, limb1_lower_poses_Rxx);
    const REAL t41 = 0.5 * limb1_lower_poses_Rxx;
    RESULT(checked0, poses, 21, param_R * limb1_lower_poses_Rxx - param_R);
    const REAL limb1_lower_poses_Rxz = k1 * limb1_lower_sin - 0.5 * limb1_lower_cos;
    WRITE(poses, 18, limb1_lower_poses_Rxz);
    WRITE(poses, 30, limb1_lower_poses_Rxz);
    RESULT(checked1, poses, 33, t41 - param_H * limb1_lower_poses_Rxz - minus_limb1_upper_position_x);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t4 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t5 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t6 = t4 + t5;
    const REAL t1 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t2 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t3 = t1 + t2;
    const REAL t7 = t6 + t3;
    const REAL t9 = 4.0 - 2.0 * t7;
    const REAL t17 = t5 + t2;
    RESULT(checked2, poses, 8, 1.0 - t9 * (t5 + t1));
    RESULT(checked3, poses, 4, 1.0 - t9 * t17);
    RESULT(checked0, poses, 0, 1.0 - t3 * t9);
    const REAL t13 = limb5_S_q_qz * t9;
    const REAL t19 = limb5_S_q_qy * t13;
    const REAL t21 = limb5_S_q_qw * (limb5_S_q_qx * t9);
    RESULT(checked1, poses, 7, t19 - t21);
    RESULT(checked2, poses, 5, t19 + t21);
    const REAL t11 = limb5_S_q_qy * t9;
    const REAL t15 = limb5_S_q_qx * t13;
    const REAL t14 = limb5_S_q_qw * t13;
    const REAL t16 = limb5_S_q_qw * t11;
    RESULT(checked3, poses, 6, t15 + t16);
    RESULT(checked0, poses, 2, t15 - t16);
    const REAL t12 = limb5_S_q_qx * t11;
    RESULT(checked1, poses, 3, t12 - t14);
    RESULT(checked2, poses, 1, t12 + t14);
    WRITE(poses, 9, CONSTANT(0.0));
    WRITE(poses, 10, CONSTANT(0.0));
    WRITE(poses, 11, CONSTANT(0.0));
    WRITE(poses, 15, CONSTANT(0.0));
    WRITE(poses, 27, CONSTANT(0.0));
    WRITE(poses, 37, CONSTANT(0.0));
    WRITE(poses, 49, CONSTANT(0.0));
    WRITE(poses, 63, CONSTANT(0.0));
    WRITE(poses, 75, CONSTANT(0.0));
    WRITE(poses, 85, CONSTANT(0.0));
    WRITE(poses, 97, CONSTANT(0.0));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_body_twists)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict twists, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    REAL checked0 = READ(q, 2);
    REAL checked1 = READ(q, 5);
    REAL checked2 = READ(q, 8);
    REAL checked3 = READ(q, 11);
    /* limb4: velocities, eq. (6); geometry */
    const REAL limb4_U_v_1 = READ(v, 10), limb4_U_0_sin = SINES(cosine, 6);
    const REAL limb4_lower_twist_angular_x = limb4_U_v_1 * limb4_U_0_sin;
    WRITE(twists, 42, limb4_lower_twist_angular_x);
    WRITE(twists, 48, limb4_lower_twist_angular_x);
    checked0 = checked0 + limb4_lower_twist_angular_x;
    /* limb3: velocities, eq. (6); geometry */
    const REAL limb3_U_v_1 = READ(v, 7), limb3_U_0_sin = SINES(sine, 4);
    const REAL limb3_lower_twist_angular_z = limb3_U_v_1 * limb3_U_0_sin;
    WRITE(twists, 32, limb3_lower_twist_angular_z);
    WRITE(twists, 38, limb3_lower_twist_angular_z);
    checked1 = checked1 + limb3_lower_twist_angular_z;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    const REAL limb3_lower_twist_angular_y = limb3_U_v_1 * limb3_U_0_cos;
    WRITE(twists, 31, limb3_lower_twist_angular_y);
    WRITE(twists, 37, limb3_lower_twist_angular_y);
    checked2 = checked2 + limb3_lower_twist_angular_y;
    /* limb2: velocities, eq. (6); geometry */
    const REAL limb2_P_v = READ(v, 5);
    RESULT(checked3, twists, 28, limb2_P_v * SINES(sine, 3));
    const REAL limb2_U_v_1 = READ(v, 4), limb2_U_0_sin = SINES(cosine, 2);
    const REAL limb2_lower_twist_angular_x = limb2_U_v_1 * limb2_U_0_sin;
    WRITE(twists, 18, limb2_lower_twist_angular_x);
    WRITE(twists, 24, limb2_lower_twist_angular_x);
    checked0 = checked0 + limb2_lower_twist_angular_x;
    /* limb1: velocities, eq. (6); geometry */
    const REAL limb1_P_v = READ(v, 2);
    RESULT(checked1, twists, 15, limb1_P_v * SINES(sine, 1));
    const REAL limb1_U_v_1 = READ(v, 1), limb1_U_0_sin = SINES(sine, 0);
    const REAL limb1_lower_twist_angular_z = limb1_U_v_1 * limb1_U_0_sin;
    WRITE(twists, 8, limb1_lower_twist_angular_z);
    WRITE(twists, 14, limb1_lower_twist_angular_z);
    checked2 = checked2 + limb1_lower_twist_angular_z;
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    const REAL limb1_lower_twist_angular_y = limb1_U_v_1 * limb1_U_0_cos;
    WRITE(twists, 7, limb1_lower_twist_angular_y);
    WRITE(twists, 13, limb1_lower_twist_angular_y);
    checked3 = checked3 + limb1_lower_twist_angular_y;
    /* limb4: velocities, eq. (6); geometry */
    const REAL minus_limb4_lower_twist_linear_z = limb4_U_v_1 * (param_R * limb4_U_0_sin);
    RESULT(checked0, twists, 47, -minus_limb4_lower_twist_linear_z);
    const REAL limb4_lower_cos = SINES(cosine, 7), limb4_P_v = READ(v, 11);
    RESULT(checked1, twists, 53, -(minus_limb4_lower_twist_linear_z + limb4_P_v * (limb4_U_0_sin * limb4_lower_cos)));
    RESULT(checked2, twists, 52, -(limb4_P_v * SINES(sine, 7)));
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL minus_limb4_lower_twist_linear_x = limb4_U_v_1 * (param_R * minus_limb4_U_0_cos);
    RESULT(checked3, twists, 45, -minus_limb4_lower_twist_linear_x);
    RESULT(checked0, twists, 51, -(minus_limb4_lower_twist_linear_x + limb4_P_v * (minus_limb4_U_0_cos * limb4_lower_cos)));
    const REAL limb4_lower_twist_angular_z = -(limb4_U_v_1 * minus_limb4_U_0_cos);
    WRITE(twists, 44, limb4_lower_twist_angular_z);
    WRITE(twists, 50, limb4_lower_twist_angular_z);
    checked1 = checked1 + limb4_lower_twist_angular_z;
    /* limb3: velocities, eq. (6); geometry */
    const REAL limb3_lower_twist_linear_z = limb3_U_v_1 * (param_R * limb3_U_0_cos);
    WRITE(twists, 35, limb3_lower_twist_linear_z);
    const REAL limb3_lower_cos = SINES(cosine, 5), limb3_P_v = READ(v, 8);
    RESULT(checked2, twists, 41, limb3_lower_twist_linear_z + limb3_P_v * (limb3_U_0_cos * limb3_lower_cos));
    const REAL minus_limb3_lower_twist_linear_y = limb3_U_v_1 * (param_R * limb3_U_0_sin);
    RESULT(checked3, twists, 34, -minus_limb3_lower_twist_linear_y);
    RESULT(checked0, twists, 40, -(minus_limb3_lower_twist_linear_y + limb3_P_v * (limb3_U_0_sin * limb3_lower_cos)));
    RESULT(checked1, twists, 39, -(limb3_P_v * SINES(sine, 5)));
    /* limb2: velocities, eq. (6); geometry */
    const REAL limb2_lower_twist_linear_z = limb2_U_v_1 * (param_R * limb2_U_0_sin);
    WRITE(twists, 23, limb2_lower_twist_linear_z);
    const REAL limb2_lower_cos = SINES(cosine, 3);
    RESULT(checked2, twists, 29, limb2_lower_twist_linear_z - limb2_P_v * (limb2_U_0_sin * limb2_lower_cos));
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL limb2_lower_twist_linear_x = limb2_U_v_1 * (param_R * minus_limb2_U_0_cos);
    WRITE(twists, 21, limb2_lower_twist_linear_x);
    RESULT(checked3, twists, 27, limb2_lower_twist_linear_x - limb2_P_v * (minus_limb2_U_0_cos * limb2_lower_cos));
    const REAL limb2_lower_twist_angular_z = -(limb2_U_v_1 * minus_limb2_U_0_cos);
    WRITE(twists, 20, limb2_lower_twist_angular_z);
    WRITE(twists, 26, limb2_lower_twist_angular_z);
    checked0 = checked0 + limb2_lower_twist_angular_z;
    /* limb1: geometry; velocities, eq. (6) */
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL t38 = limb1_P_v * (limb1_U_0_cos * limb1_lower_cos);
    const REAL minus_limb1_lower_twist_linear_z = limb1_U_v_1 * (param_R * limb1_U_0_cos);
    RESULT(checked1, twists, 17, t38 - minus_limb1_lower_twist_linear_z);
    RESULT(checked2, twists, 11, -minus_limb1_lower_twist_linear_z);
    const REAL limb1_lower_twist_linear_y = limb1_U_v_1 * (param_R * limb1_U_0_sin);
    WRITE(twists, 10, limb1_lower_twist_linear_y);
    RESULT(checked3, twists, 16, limb1_lower_twist_linear_y - limb1_P_v * (limb1_U_0_sin * limb1_lower_cos));
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t4 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t5 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t6 = t4 + t5;
    const REAL t1 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t2 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t3 = t1 + t2;
    const REAL t7 = t6 + t3;
    const REAL t9 = 4.0 - 2.0 * t7;
    const REAL limb5_S_v_wz = READ(v, 14), limb5_S_v_wy = READ(v, 13), limb5_S_v_wx = READ(v, 12);
    const REAL t32 = limb5_S_v_wz * (1.0 - t9 * (t5 + t1));
    const REAL t23 = limb5_S_v_wy * (1.0 - t9 * (t5 + t2));
    const REAL t11 = limb5_S_v_wx * (1.0 - t3 * t9);
    const REAL t14 = limb5_S_q_qz * t9;
    const REAL t18 = limb5_S_q_qx * t14;
    const REAL t12 = limb5_S_q_qy * t9;
    const REAL t28 = limb5_S_q_qw * (limb5_S_q_qx * t9);
    const REAL t19 = limb5_S_q_qw * t12;
    const REAL t13 = limb5_S_q_qx * t12;
    const REAL t33 = limb5_S_v_wx * (t18 - t19);
    const REAL t20 = limb5_S_v_wz * (t18 + t19);
    const REAL t26 = limb5_S_q_qy * t14;
    const REAL t15 = limb5_S_q_qw * t14;
    const REAL platform_turn_yz = t26 - t28;
    RESULT(checked0, twists, 2, t32 + (t33 + limb5_S_v_wy * (t26 + t28)));
    const REAL platform_turn_xy = t13 - t15;
    RESULT(checked1, twists, 1, t23 + limb5_S_v_wx * (t13 + t15) + limb5_S_v_wz * platform_turn_yz);
    RESULT(checked2, twists, 0, t11 + limb5_S_v_wy * platform_turn_xy + t20);
    const REAL limb1_U_v_0 = READ(v, 0);
    WRITE(twists, 6, limb1_U_v_0);
    WRITE(twists, 12, limb1_U_v_0);
    checked3 = checked3 + limb1_U_v_0;
    const REAL limb2_U_v_0 = READ(v, 3);
    WRITE(twists, 19, limb2_U_v_0);
    WRITE(twists, 25, limb2_U_v_0);
    checked0 = checked0 + limb2_U_v_0;
    const REAL limb3_U_v_0 = READ(v, 6);
    WRITE(twists, 30, limb3_U_v_0);
    WRITE(twists, 36, limb3_U_v_0);
    checked1 = checked1 + limb3_U_v_0;
    const REAL limb4_U_v_0 = READ(v, 9);
    WRITE(twists, 43, limb4_U_v_0);
    WRITE(twists, 49, limb4_U_v_0);
    checked2 = checked2 + limb4_U_v_0;
    WRITE(twists, 3, CONSTANT(0.0));
    WRITE(twists, 4, CONSTANT(0.0));
    WRITE(twists, 5, CONSTANT(0.0));
    WRITE(twists, 9, CONSTANT(0.0));
    WRITE(twists, 22, CONSTANT(0.0));
    WRITE(twists, 33, CONSTANT(0.0));
    WRITE(twists, 46, CONSTANT(0.0));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_body_twist_rates)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict twist_rates, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    REAL checked0 = READ(q, 2);
    REAL checked1 = READ(q, 5);
    REAL checked2 = READ(q, 8);
    REAL checked3 = READ(q, 11);
    checked0 = checked0 + (READ(v, 12));
    checked1 = checked1 + (READ(v, 13));
    checked2 = checked2 + (READ(v, 14));
    /* limb4: geometry */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL minus_limb4_U_1_screw_linear_x = param_R * minus_limb4_U_0_cos;
    /* limb4: accelerations; geometry; velocities, eq. (6) */
    const REAL limb4_U_v_0 = READ(v, 9), limb4_U_v_1 = READ(v, 10), limb4_U_a_1 = READ(a, 10);
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    const REAL t137 = limb4_U_v_1 * (limb4_U_v_0 * minus_limb4_U_1_screw_linear_x);
    const REAL t132 = limb4_U_a_1 * minus_limb4_U_1_screw_linear_x;
    const REAL minus_limb4_U_1_screw_linear_z = param_R * limb4_U_0_sin;
    const REAL minus_limb4_lower_twist_rate_linear_z = limb4_U_a_1 * minus_limb4_U_1_screw_linear_z - t137;
    const REAL minus_limb4_lower_twist_rate_linear_x = t132 + limb4_U_v_1 * (limb4_U_v_0 * minus_limb4_U_1_screw_linear_z);
    RESULT(checked3, twist_rates, 47, -minus_limb4_lower_twist_rate_linear_z);
    RESULT(checked0, twist_rates, 45, -minus_limb4_lower_twist_rate_linear_x);
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL limb4_P_a = READ(a, 11);
    const REAL t151 = minus_limb4_lower_twist_rate_linear_z + limb4_P_a * minus_limb4_lower_rotation_zx;
    const REAL limb4_lower_twist_angular_x = limb4_U_v_1 * limb4_U_0_sin;
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL t152 = minus_limb4_lower_sin * limb4_lower_twist_angular_x;
    const REAL t146 = minus_limb4_lower_rotation_zx * limb4_lower_twist_angular_x;
    const REAL t141 = limb4_U_v_0 * minus_limb4_lower_rotation_zx;
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    const REAL limb4_P_v = READ(v, 11);
    RESULT(checked1, twist_rates, 53, -(t151 + limb4_P_v * (t152 - limb4_U_v_0 * minus_limb4_lower_rotation_xx)));
    const REAL minus_limb4_lower_twist_angular_z = limb4_U_v_1 * minus_limb4_U_0_cos;
    const REAL t148 = limb4_P_v * (minus_limb4_lower_rotation_xx * minus_limb4_lower_twist_angular_z + t146);
    const REAL t140 = minus_limb4_lower_twist_rate_linear_x + limb4_P_a * minus_limb4_lower_rotation_xx;
    RESULT(checked2, twist_rates, 51, -(t140 + limb4_P_v * (t141 + minus_limb4_lower_sin * minus_limb4_lower_twist_angular_z)));
    RESULT(checked3, twist_rates, 52, t148 - limb4_P_a * minus_limb4_lower_sin);
    const REAL limb4_lower_twist_rate_angular_z = -(limb4_U_a_1 * minus_limb4_U_0_cos + limb4_U_v_1 * (limb4_U_v_0 * limb4_U_0_sin));
    WRITE(twist_rates, 44, limb4_lower_twist_rate_angular_z);
    WRITE(twist_rates, 50, limb4_lower_twist_rate_angular_z);
    checked0 = checked0 + limb4_lower_twist_rate_angular_z;
    const REAL limb4_lower_twist_rate_angular_x = limb4_U_a_1 * limb4_U_0_sin - limb4_U_v_1 * (limb4_U_v_0 * minus_limb4_U_0_cos);
    WRITE(twist_rates, 42, limb4_lower_twist_rate_angular_x);
    WRITE(twist_rates, 48, limb4_lower_twist_rate_angular_x);
    checked1 = checked1 + limb4_lower_twist_rate_angular_x;
    /* limb3: geometry */
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL minus_limb3_U_1_screw_linear_y = param_R * limb3_U_0_sin;
    /* limb3: accelerations; geometry; velocities, eq. (6) */
    const REAL limb3_U_v_0 = READ(v, 6), limb3_U_v_1 = READ(v, 7), limb3_U_a_1 = READ(a, 7);
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    const REAL t107 = limb3_U_v_1 * (limb3_U_v_0 * minus_limb3_U_1_screw_linear_y);
    const REAL t102 = limb3_U_a_1 * minus_limb3_U_1_screw_linear_y;
    const REAL limb3_U_1_screw_linear_z = param_R * limb3_U_0_cos;
    const REAL limb3_lower_twist_rate_linear_z = limb3_U_a_1 * limb3_U_1_screw_linear_z - t107;
    WRITE(twist_rates, 35, limb3_lower_twist_rate_linear_z);
    const REAL minus_limb3_lower_twist_rate_linear_y = t102 + limb3_U_v_1 * (limb3_U_v_0 * limb3_U_1_screw_linear_z);
    RESULT(checked2, twist_rates, 34, -minus_limb3_lower_twist_rate_linear_y);
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    const REAL limb3_P_a = READ(a, 8);
    const REAL t121 = limb3_lower_twist_rate_linear_z + limb3_P_a * limb3_lower_rotation_zx;
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    const REAL t122 = limb3_U_v_0 * minus_limb3_lower_rotation_yx;
    const REAL limb3_lower_twist_angular_y = limb3_U_v_1 * limb3_U_0_cos;
    const REAL minus_limb3_lower_sin = SINES(sine, 5), limb3_P_v = READ(v, 8);
    RESULT(checked3, twist_rates, 41, t121 - limb3_P_v * (t122 - minus_limb3_lower_sin * limb3_lower_twist_angular_y));
    const REAL t109 = limb3_lower_rotation_zx * limb3_lower_twist_angular_y;
    const REAL t117 = limb3_U_v_0 * limb3_lower_rotation_zx;
    const REAL t115 = minus_limb3_lower_twist_rate_linear_y + limb3_P_a * minus_limb3_lower_rotation_yx;
    const REAL limb3_lower_twist_angular_z = limb3_U_v_1 * limb3_U_0_sin;
    const REAL t111 = t109 + minus_limb3_lower_rotation_yx * limb3_lower_twist_angular_z;
    RESULT(checked0, twist_rates, 40, -(t115 + limb3_P_v * (minus_limb3_lower_sin * limb3_lower_twist_angular_z + t117)));
    RESULT(checked1, twist_rates, 39, limb3_P_v * t111 - limb3_P_a * minus_limb3_lower_sin);
    const REAL limb3_lower_twist_rate_angular_z = limb3_U_a_1 * limb3_U_0_sin + limb3_U_v_1 * (limb3_U_v_0 * limb3_U_0_cos);
    WRITE(twist_rates, 32, limb3_lower_twist_rate_angular_z);
    WRITE(twist_rates, 38, limb3_lower_twist_rate_angular_z);
    checked2 = checked2 + limb3_lower_twist_rate_angular_z;
    const REAL limb3_lower_twist_rate_angular_y = limb3_U_a_1 * limb3_U_0_cos - limb3_U_v_1 * (limb3_U_v_0 * limb3_U_0_sin);
    WRITE(twist_rates, 31, limb3_lower_twist_rate_angular_y);
    WRITE(twist_rates, 37, limb3_lower_twist_rate_angular_y);
    checked3 = checked3 + limb3_lower_twist_rate_angular_y;
    /* limb2: geometry */
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL limb2_U_1_screw_linear_x = param_R * minus_limb2_U_0_cos;
    /* limb2: accelerations; geometry; velocities, eq. (6) */
    const REAL limb2_U_v_0 = READ(v, 3), limb2_U_v_1 = READ(v, 4), limb2_U_a_1 = READ(a, 4);
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL t77 = limb2_U_v_1 * (limb2_U_v_0 * limb2_U_1_screw_linear_x);
    const REAL t72 = limb2_U_a_1 * limb2_U_1_screw_linear_x;
    const REAL limb2_U_1_screw_linear_z = param_R * limb2_U_0_sin;
    const REAL limb2_lower_twist_rate_linear_z = limb2_U_a_1 * limb2_U_1_screw_linear_z - t77;
    WRITE(twist_rates, 23, limb2_lower_twist_rate_linear_z);
    const REAL limb2_lower_twist_rate_linear_x = t72 + limb2_U_v_1 * (limb2_U_v_0 * limb2_U_1_screw_linear_z);
    WRITE(twist_rates, 21, limb2_lower_twist_rate_linear_x);
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL limb2_P_a = READ(a, 5);
    const REAL t91 = limb2_lower_twist_rate_linear_z - limb2_P_a * minus_limb2_lower_rotation_zx;
    const REAL limb2_lower_twist_angular_x = limb2_U_v_1 * limb2_U_0_sin;
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL t92 = limb2_lower_sin * limb2_lower_twist_angular_x;
    const REAL t87 = minus_limb2_lower_rotation_zx * limb2_lower_twist_angular_x;
    const REAL t81 = limb2_U_v_0 * minus_limb2_lower_rotation_zx;
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    const REAL limb2_P_v = READ(v, 5);
    RESULT(checked0, twist_rates, 29, t91 + limb2_P_v * (t92 + limb2_U_v_0 * minus_limb2_lower_rotation_xx));
    const REAL minus_limb2_lower_twist_angular_z = limb2_U_v_1 * minus_limb2_U_0_cos;
    const REAL t89 = limb2_P_v * (minus_limb2_lower_rotation_xx * minus_limb2_lower_twist_angular_z + t87);
    const REAL t80 = limb2_lower_twist_rate_linear_x - limb2_P_a * minus_limb2_lower_rotation_xx;
    RESULT(checked1, twist_rates, 27, t80 - limb2_P_v * (t81 - limb2_lower_sin * minus_limb2_lower_twist_angular_z));
    RESULT(checked2, twist_rates, 28, limb2_P_a * limb2_lower_sin + t89);
    const REAL limb2_lower_twist_rate_angular_z = -(limb2_U_a_1 * minus_limb2_U_0_cos + limb2_U_v_1 * (limb2_U_v_0 * limb2_U_0_sin));
    WRITE(twist_rates, 20, limb2_lower_twist_rate_angular_z);
    WRITE(twist_rates, 26, limb2_lower_twist_rate_angular_z);
    checked3 = checked3 + limb2_lower_twist_rate_angular_z;
    const REAL limb2_lower_twist_rate_angular_x = limb2_U_a_1 * limb2_U_0_sin - limb2_U_v_1 * (limb2_U_v_0 * minus_limb2_U_0_cos);
    WRITE(twist_rates, 18, limb2_lower_twist_rate_angular_x);
    WRITE(twist_rates, 24, limb2_lower_twist_rate_angular_x);
    checked0 = checked0 + limb2_lower_twist_rate_angular_x;
    /* limb1: geometry */
    const REAL limb1_U_0_sin = SINES(sine, 0);
    const REAL limb1_U_1_screw_linear_y = param_R * limb1_U_0_sin;
    /* limb1: accelerations; geometry; velocities, eq. (6) */
    const REAL limb1_U_v_0 = READ(v, 0), limb1_U_v_1 = READ(v, 1), limb1_U_a_1 = READ(a, 1);
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    const REAL t47 = limb1_U_v_1 * (limb1_U_v_0 * limb1_U_1_screw_linear_y);
    const REAL t42 = limb1_U_a_1 * limb1_U_1_screw_linear_y;
    const REAL minus_limb1_U_1_screw_linear_z = param_R * limb1_U_0_cos;
    const REAL minus_limb1_lower_twist_rate_linear_z = limb1_U_a_1 * minus_limb1_U_1_screw_linear_z - t47;
    const REAL limb1_lower_twist_rate_linear_y = t42 + limb1_U_v_1 * (limb1_U_v_0 * minus_limb1_U_1_screw_linear_z);
    WRITE(twist_rates, 10, limb1_lower_twist_rate_linear_y);
    RESULT(checked1, twist_rates, 11, -minus_limb1_lower_twist_rate_linear_z);
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    const REAL limb1_P_a = READ(a, 2);
    const REAL t61 = minus_limb1_lower_twist_rate_linear_z - limb1_P_a * limb1_lower_rotation_zx;
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    const REAL t62 = limb1_U_v_0 * minus_limb1_lower_rotation_yx;
    const REAL limb1_lower_twist_angular_y = limb1_U_v_1 * limb1_U_0_cos;
    const REAL limb1_lower_sin = SINES(sine, 1), limb1_P_v = READ(v, 2);
    RESULT(checked2, twist_rates, 17, -(t61 + limb1_P_v * (t62 + limb1_lower_sin * limb1_lower_twist_angular_y)));
    const REAL t50 = limb1_lower_rotation_zx * limb1_lower_twist_angular_y;
    const REAL t57 = limb1_U_v_0 * limb1_lower_rotation_zx;
    const REAL t55 = limb1_lower_twist_rate_linear_y - limb1_P_a * minus_limb1_lower_rotation_yx;
    const REAL limb1_lower_twist_angular_z = limb1_U_v_1 * limb1_U_0_sin;
    const REAL t52 = t50 + minus_limb1_lower_rotation_yx * limb1_lower_twist_angular_z;
    RESULT(checked3, twist_rates, 16, t55 + limb1_P_v * (limb1_lower_sin * limb1_lower_twist_angular_z - t57));
    RESULT(checked0, twist_rates, 15, limb1_P_a * limb1_lower_sin + limb1_P_v * t52);
    const REAL limb1_lower_twist_rate_angular_z = limb1_U_a_1 * limb1_U_0_sin + limb1_U_v_1 * (limb1_U_v_0 * limb1_U_0_cos);
    WRITE(twist_rates, 8, limb1_lower_twist_rate_angular_z);
    WRITE(twist_rates, 14, limb1_lower_twist_rate_angular_z);
    checked1 = checked1 + limb1_lower_twist_rate_angular_z;
    const REAL limb1_lower_twist_rate_angular_y = limb1_U_a_1 * limb1_U_0_cos - limb1_U_v_1 * (limb1_U_v_0 * limb1_U_0_sin);
    WRITE(twist_rates, 7, limb1_lower_twist_rate_angular_y);
    WRITE(twist_rates, 13, limb1_lower_twist_rate_angular_y);
    checked2 = checked2 + limb1_lower_twist_rate_angular_y;
    /* limb5_S: geometry; accelerations */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t4 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t5 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t6 = t4 + t5;
    const REAL t1 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t2 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t3 = t1 + t2;
    const REAL t7 = t6 + t3;
    const REAL t9 = 4.0 - 2.0 * t7;
    const REAL limb5_S_a_wz = READ(a, 14), limb5_S_a_wy = READ(a, 13), limb5_S_a_wx = READ(a, 12);
    const REAL t35 = limb5_S_a_wz * (1.0 - t9 * (t5 + t1));
    const REAL t24 = limb5_S_a_wy * (1.0 - t9 * (t5 + t2));
    const REAL t11 = limb5_S_a_wx * (1.0 - t3 * t9);
    const REAL t14 = limb5_S_q_qz * t9;
    const REAL t18 = limb5_S_q_qx * t14;
    const REAL t12 = limb5_S_q_qy * t9;
    const REAL t28 = limb5_S_q_qw * (limb5_S_q_qx * t9);
    const REAL t19 = limb5_S_q_qw * t12;
    const REAL t13 = limb5_S_q_qx * t12;
    const REAL t30 = limb5_S_a_wx * (t18 - t19);
    const REAL t20 = limb5_S_a_wz * (t18 + t19);
    const REAL t26 = limb5_S_q_qy * t14;
    const REAL t15 = limb5_S_q_qw * t14;
    const REAL platform_turn_yz = t26 - t28;
    RESULT(checked3, twist_rates, 2, t30 + limb5_S_a_wy * (t26 + t28) + t35);
    const REAL platform_turn_xy = t13 - t15;
    RESULT(checked0, twist_rates, 1, limb5_S_a_wx * (t13 + t15) + t24 + limb5_S_a_wz * platform_turn_yz);
    RESULT(checked1, twist_rates, 0, t11 + limb5_S_a_wy * platform_turn_xy + t20);
    const REAL limb1_U_a_0 = READ(a, 0);
    WRITE(twist_rates, 6, limb1_U_a_0);
    WRITE(twist_rates, 12, limb1_U_a_0);
    checked2 = checked2 + limb1_U_a_0;
    const REAL limb2_U_a_0 = READ(a, 3);
    WRITE(twist_rates, 19, limb2_U_a_0);
    WRITE(twist_rates, 25, limb2_U_a_0);
    checked3 = checked3 + limb2_U_a_0;
    const REAL limb3_U_a_0 = READ(a, 6);
    WRITE(twist_rates, 30, limb3_U_a_0);
    WRITE(twist_rates, 36, limb3_U_a_0);
    checked0 = checked0 + limb3_U_a_0;
    const REAL limb4_U_a_0 = READ(a, 9);
    WRITE(twist_rates, 43, limb4_U_a_0);
    WRITE(twist_rates, 49, limb4_U_a_0);
    checked1 = checked1 + limb4_U_a_0;
    WRITE(twist_rates, 3, CONSTANT(0.0));
    WRITE(twist_rates, 4, CONSTANT(0.0));
    WRITE(twist_rates, 5, CONSTANT(0.0));
    WRITE(twist_rates, 9, CONSTANT(0.0));
    WRITE(twist_rates, 22, CONSTANT(0.0));
    WRITE(twist_rates, 33, CONSTANT(0.0));
    WRITE(twist_rates, 46, CONSTANT(0.0));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_forward_kinematics)(size_t stride, const double *restrict q, double *restrict positions,
    double *restrict total)
{
    const FOURS fours = (FOUR(q, 0) + FOUR(q, 4)) + FOUR(q, 8);
    REAL checked0 = SUM_OF_FOUR(fours);
    /* limb5_S: geometry; results */
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
    const REAL t9 = 4.0 - 2.0 * t7;
    const REAL t26 = t2 + t5;
    const REAL E_positions_z = param_H * (1.0 - t9 * (t2 + t4));
    WRITE(positions, 5, E_positions_z);
    const REAL t28 = 0.5 * (1.0 - t9 * t26);
    const REAL t20 = 0.5 * (1.0 - t6 * t9);
    const REAL t10 = limb5_S_q_qz * t9;
    const REAL t14 = limb5_S_q_qy * t10;
    const REAL t16 = limb5_S_q_qw * (limb5_S_q_qx * t9);
    const REAL t12 = limb5_S_q_qy * t9;
    const REAL platform_turn_yz = t14 - t16;
    const REAL t29 = 0.5 * (t14 + t16);
    const REAL limb4_lower_limb_target_x = E_positions_z + t29;
    WRITE(positions, 29, limb4_lower_limb_target_x);
    REAL checked1 = limb4_lower_limb_target_x;
    const REAL limb2_lower_limb_target_x = E_positions_z - t29;
    WRITE(positions, 23, limb2_lower_limb_target_x);
    REAL checked2 = limb2_lower_limb_target_x;
    const REAL E_positions_y = param_H * platform_turn_yz;
    WRITE(positions, 4, E_positions_y);
    const REAL limb4_upper_position_y = E_positions_y + t28;
    WRITE(positions, 28, limb4_upper_position_y);
    REAL checked3 = limb4_upper_position_y;
    RESULT(checked0, positions, 22, E_positions_y - t28);
    const REAL t11 = limb5_S_q_qx * t10;
    const REAL t22 = limb5_S_q_qw * t10;
    const REAL t13 = limb5_S_q_qw * t12;
    const REAL t21 = limb5_S_q_qx * t12;
    const REAL platform_turn_zx = t11 - t13;
    const REAL E_positions_x = param_H * (t11 + t13);
    WRITE(positions, 3, E_positions_x);
    const REAL t24 = 0.5 * platform_turn_zx;
    RESULT(checked1, positions, 26, t24 + E_positions_z);
    RESULT(checked2, positions, 20, E_positions_z - t24);
    RESULT(checked3, positions, 24, t20 + E_positions_x);
    RESULT(checked0, positions, 18, E_positions_x - t20);
    const REAL platform_turn_yx = t21 + t22;
    const REAL t25 = 0.5 * (t21 - t22);
    RESULT(checked1, positions, 27, E_positions_x + t25);
    RESULT(checked2, positions, 21, E_positions_x - t25);
    const REAL t23 = 0.5 * platform_turn_yx;
    RESULT(checked3, positions, 25, t23 + E_positions_y);
    RESULT(checked0, positions, 19, E_positions_y - t23);
    WRITE(positions, 0, CONSTANT(0.0));
    WRITE(positions, 1, CONSTANT(0.0));
    WRITE(positions, 2, CONSTANT(0.0));
    WRITE(positions, 6, CONSTANT((-param_R)));
    WRITE(positions, 7, CONSTANT(0.0));
    WRITE(positions, 8, CONSTANT(0.0));
    WRITE(positions, 9, CONSTANT(0.0));
    WRITE(positions, 10, CONSTANT((-param_R)));
    WRITE(positions, 11, CONSTANT(0.0));
    WRITE(positions, 12, CONSTANT(param_R));
    WRITE(positions, 13, CONSTANT(0.0));
    WRITE(positions, 14, CONSTANT(0.0));
    WRITE(positions, 15, CONSTANT(0.0));
    WRITE(positions, 16, CONSTANT(param_R));
    WRITE(positions, 17, CONSTANT(0.0));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_point_motion)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict positions, double *restrict velocities,
    double *restrict accelerations, double *restrict total)
{
    const FOURS fours = (((FOUR(a, 0) + FOUR(a, 4)) + (FOUR(a, 8) + FOUR(q, 0))) + ((FOUR(q, 4) + FOUR(q, 8)) + (FOUR(v, 0) + FOUR(v, 4)))) + FOUR(v, 8);
    REAL checked0 = SUM_OF_FOUR(fours);
    /* limb5_S: geometry; velocities, eq. (6); results */
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
    const REAL t9 = 4.0 - 2.0 * t7;
    const REAL t26 = t2 + t5;
    const REAL platform_turn_zz = 1.0 - t9 * (t2 + t4);
    const REAL platform_turn_xx = 1.0 - t6 * t9;
    const REAL platform_turn_yy = 1.0 - t9 * t26;
    const REAL t10 = limb5_S_q_qz * t9;
    const REAL t11 = limb5_S_q_qx * t10;
    const REAL t12 = limb5_S_q_qy * t9;
    const REAL t16 = limb5_S_q_qw * (limb5_S_q_qx * t9);
    const REAL t13 = limb5_S_q_qw * t12;
    const REAL t21 = limb5_S_q_qx * t12;
    const REAL platform_turn_zx = t11 - t13;
    const REAL platform_turn_xz = t11 + t13;
    const REAL limb5_S_v_wx = READ(v, 12);
    const REAL t36 = limb5_S_v_wx * platform_turn_zx;
    const REAL t14 = limb5_S_q_qy * t10;
    const REAL t22 = limb5_S_q_qw * t10;
    const REAL platform_turn_zy = t14 + t16;
    const REAL platform_turn_yz = t14 - t16;
    const REAL limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14);
    const REAL platform_twist_angular_z = limb5_S_v_wz * platform_turn_zz + (t36 + limb5_S_v_wy * platform_turn_zy);
    const REAL E_positions_x = param_H * platform_turn_xz;
    WRITE(positions, 3, E_positions_x);
    const REAL platform_turn_xy = t21 - t22;
    const REAL platform_turn_yx = t21 + t22;
    const REAL t25 = 0.5 * platform_turn_xy;
    const REAL limb4_lower_limb_target_y = E_positions_x + t25;
    WRITE(positions, 27, limb4_lower_limb_target_y);
    const REAL limb2_lower_limb_target_y = E_positions_x - t25;
    WRITE(positions, 21, limb2_lower_limb_target_y);
    const REAL limb5_S_a_wy = READ(a, 13);
    const REAL t71 = limb4_lower_limb_target_y * platform_twist_angular_z;
    const REAL t91 = limb5_S_a_wy * platform_turn_xy;
    const REAL t43 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy;
    const REAL platform_twist_angular_x = t43 + limb5_S_v_wz * platform_turn_xz;
    const REAL limb5_S_a_wz = READ(a, 14);
    const REAL t93 = limb5_S_a_wz * platform_turn_xz;
    const REAL t29 = 0.5 * platform_turn_zy;
    const REAL t81 = limb5_S_a_wy * platform_turn_zy;
    const REAL E_positions_z = param_H * platform_turn_zz;
    WRITE(positions, 5, E_positions_z);
    const REAL t83 = limb5_S_a_wz * platform_turn_zz;
    const REAL limb4_lower_limb_target_x = E_positions_z + t29;
    WRITE(positions, 29, limb4_lower_limb_target_x);
    const REAL limb2_lower_limb_target_x = E_positions_z - t29;
    WRITE(positions, 23, limb2_lower_limb_target_x);
    const REAL C4_velocities_y = t71 - limb4_lower_limb_target_x * platform_twist_angular_x;
    WRITE(velocities, 28, C4_velocities_y);
    const REAL t177 = platform_twist_angular_x * C4_velocities_y;
    const REAL t166 = platform_twist_angular_z * C4_velocities_y;
    const REAL t32 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx;
    const REAL platform_twist_angular_y = t32 + limb5_S_v_wz * platform_turn_yz;
    const REAL t69 = limb4_lower_limb_target_x * platform_twist_angular_y;
    const REAL E_positions_y = param_H * platform_turn_yz;
    WRITE(positions, 4, E_positions_y);
    const REAL t78 = limb5_S_a_wz * platform_turn_yz;
    const REAL t28 = 0.5 * platform_turn_yy;
    const REAL t76 = limb5_S_a_wy * platform_turn_yy;
    const REAL limb4_upper_position_y = E_positions_y + t28;
    WRITE(positions, 28, limb4_upper_position_y);
    const REAL limb2_upper_position_y = E_positions_y - t28;
    WRITE(positions, 22, limb2_upper_position_y);
    const REAL C4_velocities_x = t69 - limb4_upper_position_y * platform_twist_angular_z;
    WRITE(velocities, 27, C4_velocities_x);
    const REAL limb5_S_a_wx = READ(a, 12);
    /* C3: results; accelerations; geometry */
    const REAL t179 = t177 - platform_twist_angular_y * C4_velocities_x;
    const REAL t171 = platform_twist_angular_z * C4_velocities_x;
    const REAL platform_twist_rate_angular_x = limb5_S_a_wx * platform_turn_xx + t91 + t93;
    const REAL t20 = 0.5 * platform_turn_xx;
    const REAL t174 = limb4_upper_position_y * platform_twist_rate_angular_x;
    const REAL platform_twist_rate_angular_y = limb5_S_a_wx * platform_turn_yx + t76 + t78;
    const REAL t23 = 0.5 * platform_turn_yx;
    const REAL C4_accelerations_z = t174 - limb4_lower_limb_target_y * platform_twist_rate_angular_y + t179;
    WRITE(accelerations, 29, C4_accelerations_z);
    REAL checked1 = C4_accelerations_z;
    const REAL t73 = limb4_upper_position_y * platform_twist_angular_x;
    const REAL C4_velocities_z = t73 - limb4_lower_limb_target_y * platform_twist_angular_y;
    WRITE(velocities, 29, C4_velocities_z);
    const REAL t173 = t171 - platform_twist_angular_x * C4_velocities_z;
    const REAL t167 = platform_twist_angular_y * C4_velocities_z - t166;
    const REAL platform_twist_rate_angular_z = limb5_S_a_wx * platform_turn_zx + t81 + t83;
    const REAL t168 = limb4_lower_limb_target_y * platform_twist_rate_angular_z;
    const REAL t163 = limb4_upper_position_y * platform_twist_rate_angular_z;
    const REAL t24 = 0.5 * platform_turn_zx;
    const REAL C4_accelerations_y = t168 - limb4_lower_limb_target_x * platform_twist_rate_angular_x + t173;
    WRITE(accelerations, 28, C4_accelerations_y);
    REAL checked2 = C4_accelerations_y;
    const REAL C4_accelerations_x = limb4_lower_limb_target_x * platform_twist_rate_angular_y - t163 + t167;
    WRITE(accelerations, 27, C4_accelerations_x);
    REAL checked3 = C4_accelerations_x;
    const REAL limb3_upper_position_x = t20 + E_positions_x;
    WRITE(positions, 24, limb3_upper_position_x);
    const REAL minus_limb1_upper_position_x = t20 - E_positions_x;
    RESULT(checked0, positions, 18, -minus_limb1_upper_position_x);
    const REAL t65 = limb3_upper_position_x * platform_twist_angular_z;
    const REAL limb3_lower_limb_target_y = t24 + E_positions_z;
    WRITE(positions, 26, limb3_lower_limb_target_y);
    const REAL minus_limb1_lower_limb_target_y = t24 - E_positions_z;
    RESULT(checked1, positions, 20, -minus_limb1_lower_limb_target_y);
    const REAL C3_velocities_y = t65 - limb3_lower_limb_target_y * platform_twist_angular_x;
    WRITE(velocities, 25, C3_velocities_y);
    const REAL t159 = platform_twist_angular_x * C3_velocities_y;
    const REAL t148 = platform_twist_angular_z * C3_velocities_y;
    const REAL t63 = limb3_lower_limb_target_y * platform_twist_angular_y;
    const REAL limb3_lower_limb_target_x = t23 + E_positions_y;
    WRITE(positions, 25, limb3_lower_limb_target_x);
    const REAL minus_limb1_lower_limb_target_x = t23 - E_positions_y;
    RESULT(checked2, positions, 19, -minus_limb1_lower_limb_target_x);
    const REAL C3_velocities_x = t63 - limb3_lower_limb_target_x * platform_twist_angular_z;
    WRITE(velocities, 24, C3_velocities_x);
    const REAL t161 = t159 - platform_twist_angular_y * C3_velocities_x;
    const REAL t153 = platform_twist_angular_z * C3_velocities_x;
    const REAL t156 = limb3_lower_limb_target_x * platform_twist_rate_angular_x;
    RESULT(checked3, accelerations, 26, t156 - limb3_upper_position_x * platform_twist_rate_angular_y + t161);
    const REAL t67 = limb3_lower_limb_target_x * platform_twist_angular_x;
    const REAL t145 = limb3_lower_limb_target_x * platform_twist_rate_angular_z;
    const REAL C3_velocities_z = t67 - limb3_upper_position_x * platform_twist_angular_y;
    WRITE(velocities, 26, C3_velocities_z);
    const REAL t150 = limb3_upper_position_x * platform_twist_rate_angular_z;
    const REAL t155 = t153 - platform_twist_angular_x * C3_velocities_z;
    const REAL t149 = platform_twist_angular_y * C3_velocities_z - t148;
    RESULT(checked0, accelerations, 25, t150 - limb3_lower_limb_target_y * platform_twist_rate_angular_x + t155);
    RESULT(checked1, accelerations, 24, limb3_lower_limb_target_y * platform_twist_rate_angular_y - t145 + t149);
    const REAL t59 = limb2_lower_limb_target_y * platform_twist_angular_z;
    const REAL C2_velocities_y = t59 - limb2_lower_limb_target_x * platform_twist_angular_x;
    WRITE(velocities, 22, C2_velocities_y);
    const REAL t141 = platform_twist_angular_x * C2_velocities_y;
    const REAL t130 = platform_twist_angular_z * C2_velocities_y;
    const REAL t57 = limb2_lower_limb_target_x * platform_twist_angular_y;
    const REAL C2_velocities_x = t57 - limb2_upper_position_y * platform_twist_angular_z;
    WRITE(velocities, 21, C2_velocities_x);
    const REAL t143 = t141 - platform_twist_angular_y * C2_velocities_x;
    const REAL t135 = platform_twist_angular_z * C2_velocities_x;
    const REAL t138 = limb2_upper_position_y * platform_twist_rate_angular_x;
    RESULT(checked2, accelerations, 23, t138 - limb2_lower_limb_target_y * platform_twist_rate_angular_y + t143);
    const REAL t61 = limb2_upper_position_y * platform_twist_angular_x;
    const REAL t127 = limb2_upper_position_y * platform_twist_rate_angular_z;
    const REAL C2_velocities_z = t61 - limb2_lower_limb_target_y * platform_twist_angular_y;
    WRITE(velocities, 23, C2_velocities_z);
    const REAL t132 = limb2_lower_limb_target_y * platform_twist_rate_angular_z;
    const REAL t137 = t135 - platform_twist_angular_x * C2_velocities_z;
    const REAL t131 = platform_twist_angular_y * C2_velocities_z - t130;
    RESULT(checked3, accelerations, 22, t132 - limb2_lower_limb_target_x * platform_twist_rate_angular_x + t137);
    RESULT(checked0, accelerations, 21, limb2_lower_limb_target_x * platform_twist_rate_angular_y - t127 + t131);
    const REAL t51 = minus_limb1_upper_position_x * platform_twist_angular_z;
    const REAL t53 = t51 - minus_limb1_lower_limb_target_y * platform_twist_angular_x;
    RESULT(checked1, velocities, 19, -t53);
    const REAL t122 = platform_twist_angular_x * t53;
    const REAL t109 = platform_twist_angular_z * t53;
    const REAL t48 = minus_limb1_lower_limb_target_y * platform_twist_angular_y;
    const REAL t50 = t48 - minus_limb1_lower_limb_target_x * platform_twist_angular_z;
    RESULT(checked2, velocities, 18, -t50);
    const REAL t124 = t122 - platform_twist_angular_y * t50;
    const REAL t115 = platform_twist_angular_z * t50;
    const REAL t119 = minus_limb1_lower_limb_target_x * platform_twist_rate_angular_x;
    RESULT(checked3, accelerations, 20, -(t119 - minus_limb1_upper_position_x * platform_twist_rate_angular_y + t124));
    const REAL t54 = minus_limb1_lower_limb_target_x * platform_twist_angular_x;
    const REAL t106 = minus_limb1_lower_limb_target_x * platform_twist_rate_angular_z;
    const REAL t56 = t54 - minus_limb1_upper_position_x * platform_twist_angular_y;
    const REAL t112 = minus_limb1_upper_position_x * platform_twist_rate_angular_z;
    RESULT(checked0, velocities, 20, -t56);
    const REAL t117 = t115 - platform_twist_angular_x * t56;
    const REAL t110 = platform_twist_angular_y * t56 - t109;
    RESULT(checked1, accelerations, 19, -(t112 - minus_limb1_lower_limb_target_y * platform_twist_rate_angular_x + t117));
    RESULT(checked2, accelerations, 18, -(minus_limb1_lower_limb_target_y * platform_twist_rate_angular_y - t106 + t110));
    const REAL E_velocities_y = E_positions_x * platform_twist_angular_z - E_positions_z * platform_twist_angular_x;
    WRITE(velocities, 4, E_velocities_y);
    const REAL t102 = platform_twist_angular_x * E_velocities_y;
    const REAL t87 = platform_twist_angular_z * E_velocities_y;
    const REAL E_velocities_x = E_positions_z * platform_twist_angular_y - E_positions_y * platform_twist_angular_z;
    WRITE(velocities, 3, E_velocities_x);
    const REAL t96 = platform_twist_angular_z * E_velocities_x;
    const REAL t104 = t102 - platform_twist_angular_y * E_velocities_x;
    const REAL t94 = E_positions_z * platform_twist_rate_angular_x;
    const REAL t79 = E_positions_z * platform_twist_rate_angular_y;
    const REAL t101 = E_positions_y * platform_twist_rate_angular_x - E_positions_x * platform_twist_rate_angular_y;
    RESULT(checked3, accelerations, 5, t101 + t104);
    const REAL t85 = t79 - E_positions_y * platform_twist_rate_angular_z;
    const REAL t95 = E_positions_x * platform_twist_rate_angular_z - t94;
    const REAL E_velocities_z = E_positions_y * platform_twist_angular_x - E_positions_x * platform_twist_angular_y;
    WRITE(velocities, 5, E_velocities_z);
    RESULT(checked0, accelerations, 4, t95 + (t96 - platform_twist_angular_x * E_velocities_z));
    RESULT(checked1, accelerations, 3, t85 + (platform_twist_angular_y * E_velocities_z - t87));
    WRITE(positions, 0, CONSTANT(0.0));
    WRITE(positions, 1, CONSTANT(0.0));
    WRITE(positions, 2, CONSTANT(0.0));
    WRITE(positions, 6, CONSTANT((-param_R)));
    WRITE(positions, 7, CONSTANT(0.0));
    WRITE(positions, 8, CONSTANT(0.0));
    WRITE(positions, 9, CONSTANT(0.0));
    WRITE(positions, 10, CONSTANT((-param_R)));
    WRITE(positions, 11, CONSTANT(0.0));
    WRITE(positions, 12, CONSTANT(param_R));
    WRITE(positions, 13, CONSTANT(0.0));
    WRITE(positions, 14, CONSTANT(0.0));
    WRITE(positions, 15, CONSTANT(0.0));
    WRITE(positions, 16, CONSTANT(param_R));
    WRITE(positions, 17, CONSTANT(0.0));
    WRITE(velocities, 0, CONSTANT(0.0));
    WRITE(velocities, 1, CONSTANT(0.0));
    WRITE(velocities, 2, CONSTANT(0.0));
    WRITE(accelerations, 0, CONSTANT(0.0));
    WRITE(accelerations, 1, CONSTANT(0.0));
    WRITE(accelerations, 2, CONSTANT(0.0));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_joint_screws)(size_t stride, const double *restrict q, double *restrict screws,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb4: geometry */
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_lower_sin = -minus_limb4_lower_sin;
    WRITE(screws, 118, limb4_lower_sin);
    REAL checked0 = limb4_lower_sin;
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    const REAL limb4_U_0_cos = -minus_limb4_U_0_cos;
    WRITE(screws, 110, limb4_U_0_cos);
    WRITE(screws, 122, limb4_U_0_cos);
    REAL checked1 = limb4_U_0_cos;
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_lower_sin = -minus_limb3_lower_sin;
    WRITE(screws, 81, limb3_lower_sin);
    REAL checked2 = limb3_lower_sin;
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    WRITE(screws, 73, limb3_U_0_cos);
    WRITE(screws, 91, limb3_U_0_cos);
    const REAL limb3_U_1_screw_linear_z = param_R * limb3_U_0_cos;
    WRITE(screws, 77, limb3_U_1_screw_linear_z);
    REAL checked3 = limb3_U_1_screw_linear_z;
    /* limb2: geometry */
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    WRITE(screws, 36, limb2_U_0_sin);
    WRITE(screws, 48, limb2_U_0_sin);
    RESULT(checked0, screws, 41, param_R * limb2_U_0_sin);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    RESULT(checked1, screws, 39, param_R * minus_limb2_U_0_cos);
    const REAL limb2_U_0_cos = -minus_limb2_U_0_cos;
    WRITE(screws, 38, limb2_U_0_cos);
    WRITE(screws, 50, limb2_U_0_cos);
    checked2 = checked2 + limb2_U_0_cos;
    const REAL limb1_U_0_sin = SINES(sine, 0);
    WRITE(screws, 8, limb1_U_0_sin);
    RESULT(checked3, screws, 10, param_R * limb1_U_0_sin);
    /* limb4: geometry */
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    RESULT(checked0, screws, 117, -minus_limb4_lower_rotation_xx);
    /* limb4: screws, eq. (5); geometry */
    const REAL t119 = k1 * minus_limb4_lower_rotation_xx;
    const REAL minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin;
    const REAL t121 = t119 - 0.5 * minus_limb4_lower_rotation_xy;
    RESULT(checked1, screws, 132, -t121);
    const REAL t107 = k1 * minus_limb4_lower_rotation_xy;
    const REAL t134 = limb4_upper_position_y * t121;
    const REAL minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx;
    const REAL limb4_S_screws_y_wx = 0.5 * minus_limb4_lower_rotation_xx + t107;
    WRITE(screws, 126, limb4_S_screws_y_wx);
    const REAL t124 = k1 * minus_limb4_lower_sin + 0.5 * limb4_lower_cos;
    RESULT(checked2, screws, 133, -t124);
    RESULT(checked3, screws, 137, minus_limb4_upper_position_x * t124 + t134);
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    WRITE(screws, 108, limb4_U_0_sin);
    WRITE(screws, 120, limb4_U_0_sin);
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx;
    const REAL t131 = minus_limb4_upper_position_z * t121;
    const REAL t129 = minus_limb4_upper_position_z * t124;
    RESULT(checked0, screws, 119, -minus_limb4_lower_rotation_zx);
    const REAL t125 = k1 * minus_limb4_lower_rotation_zx;
    const REAL t110 = 0.5 * minus_limb4_lower_rotation_zx;
    const REAL minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin;
    const REAL t127 = t125 - 0.5 * minus_limb4_lower_rotation_zy;
    RESULT(checked1, screws, 134, -t127);
    const REAL limb4_S_screws_y_wz = t110 + k1 * minus_limb4_lower_rotation_zy;
    WRITE(screws, 128, limb4_S_screws_y_wz);
    RESULT(checked2, screws, 136, t131 - minus_limb4_upper_position_x * t127);
    RESULT(checked3, screws, 135, -(limb4_upper_position_y * t127 + t129));
    const REAL t117 = limb4_upper_position_y * limb4_S_screws_y_wx;
    const REAL t115 = minus_limb4_upper_position_z * limb4_S_screws_y_wx;
    const REAL limb4_S_screws_y_wy = 0.5 * minus_limb4_lower_sin - k1 * limb4_lower_cos;
    WRITE(screws, 127, limb4_S_screws_y_wy);
    RESULT(checked0, screws, 131, -(minus_limb4_upper_position_x * limb4_S_screws_y_wy + t117));
    const REAL t113 = minus_limb4_upper_position_z * limb4_S_screws_y_wy;
    const REAL t103 = limb4_U_0_sin * minus_limb4_upper_position_z;
    RESULT(checked1, screws, 130, minus_limb4_upper_position_x * limb4_S_screws_y_wz - t115);
    RESULT(checked2, screws, 129, limb4_upper_position_y * limb4_S_screws_y_wz + t113);
    RESULT(checked3, screws, 124, -(t103 + minus_limb4_U_0_cos * minus_limb4_upper_position_x));
    RESULT(checked0, screws, 125, -(limb4_U_0_sin * limb4_upper_position_y));
    RESULT(checked1, screws, 123, -(minus_limb4_U_0_cos * limb4_upper_position_y));
    RESULT(checked2, screws, 113, -(param_R * limb4_U_0_sin));
    RESULT(checked3, screws, 111, -(param_R * minus_limb4_U_0_cos));
    /* limb3: geometry */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    RESULT(checked0, screws, 95, limb3_U_0_cos * limb3_upper_position_x);
    const REAL limb3_U_0_sin = SINES(sine, 4);
    WRITE(screws, 74, limb3_U_0_sin);
    WRITE(screws, 92, limb3_U_0_sin);
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    RESULT(checked1, screws, 82, -minus_limb3_lower_rotation_yx);
    /* limb3: screws, eq. (5); geometry */
    const REAL t88 = k1 * minus_limb3_lower_rotation_yx;
    const REAL minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin;
    const REAL t90 = t88 + 0.5 * minus_limb3_lower_rotation_yy;
    RESULT(checked2, screws, 97, -t90);
    const REAL t71 = k1 * minus_limb3_lower_rotation_yy;
    const REAL t98 = limb3_upper_position_x * t90;
    const REAL minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx;
    const REAL limb3_S_screws_x_wy = 0.5 * minus_limb3_lower_rotation_yx - t71;
    WRITE(screws, 85, limb3_S_screws_x_wy);
    const REAL t87 = k1 * minus_limb3_lower_sin - 0.5 * limb3_lower_cos;
    RESULT(checked3, screws, 96, -t87);
    RESULT(checked0, screws, 101, -(t98 + minus_limb3_upper_position_y * t87));
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    WRITE(screws, 83, limb3_lower_rotation_zx);
    const REAL limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx;
    const REAL t95 = limb3_upper_position_z * t87;
    const REAL t93 = limb3_upper_position_z * t90;
    const REAL t91 = k1 * limb3_lower_rotation_zx;
    const REAL t72 = 0.5 * limb3_lower_rotation_zx;
    const REAL limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin;
    const REAL limb3_S_screws_z_wz = t91 + 0.5 * limb3_lower_rotation_zy;
    WRITE(screws, 98, limb3_S_screws_z_wz);
    const REAL t74 = t72 - k1 * limb3_lower_rotation_zy;
    RESULT(checked1, screws, 86, -t74);
    RESULT(checked2, screws, 100, -(t95 + limb3_upper_position_x * limb3_S_screws_z_wz));
    RESULT(checked3, screws, 99, t93 - minus_limb3_upper_position_y * limb3_S_screws_z_wz);
    RESULT(checked0, screws, 94, -(limb3_U_0_sin * limb3_upper_position_x));
    RESULT(checked1, screws, 93, -(limb3_U_0_sin * minus_limb3_upper_position_y + limb3_U_0_cos * limb3_upper_position_z));
    const REAL t80 = limb3_upper_position_x * limb3_S_screws_x_wy;
    const REAL t79 = limb3_upper_position_x * t74;
    RESULT(checked2, screws, 87, minus_limb3_upper_position_y * t74 - limb3_upper_position_z * limb3_S_screws_x_wy);
    const REAL limb3_S_screws_x_wx = 0.5 * minus_limb3_lower_sin + k1 * limb3_lower_cos;
    WRITE(screws, 84, limb3_S_screws_x_wx);
    RESULT(checked3, screws, 89, t80 + minus_limb3_upper_position_y * limb3_S_screws_x_wx);
    RESULT(checked0, screws, 88, limb3_upper_position_z * limb3_S_screws_x_wx + t79);
    RESULT(checked1, screws, 76, -(param_R * limb3_U_0_sin));
    /* limb2: geometry */
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL limb2_lower_sin = SINES(sine, 3);
    WRITE(screws, 46, limb2_lower_sin);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    RESULT(checked2, screws, 53, limb2_U_0_sin * minus_limb2_upper_position_y);
    RESULT(checked3, screws, 51, minus_limb2_U_0_cos * minus_limb2_upper_position_y);
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    RESULT(checked0, screws, 45, -minus_limb2_lower_rotation_xx);
    /* limb2: screws, eq. (5); geometry */
    const REAL t52 = k1 * minus_limb2_lower_rotation_xx;
    const REAL limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin;
    const REAL t54 = t52 - 0.5 * limb2_lower_rotation_xy;
    RESULT(checked1, screws, 60, -t54);
    const REAL t38 = k1 * limb2_lower_rotation_xy;
    const REAL t65 = minus_limb2_upper_position_y * t54;
    const REAL minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx;
    const REAL t39 = 0.5 * minus_limb2_lower_rotation_xx + t38;
    RESULT(checked2, screws, 54, -t39);
    const REAL limb2_S_screws_z_wy = k1 * limb2_lower_sin + 0.5 * limb2_lower_cos;
    WRITE(screws, 61, limb2_S_screws_z_wy);
    RESULT(checked3, screws, 65, -(minus_limb2_upper_position_x * limb2_S_screws_z_wy + t65));
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx;
    const REAL t62 = minus_limb2_upper_position_z * t54;
    const REAL t61 = minus_limb2_upper_position_z * limb2_S_screws_z_wy;
    RESULT(checked0, screws, 47, -minus_limb2_lower_rotation_zx);
    const REAL t57 = k1 * minus_limb2_lower_rotation_zx;
    const REAL t42 = 0.5 * minus_limb2_lower_rotation_zx;
    const REAL limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin;
    const REAL t59 = t57 - 0.5 * limb2_lower_rotation_zy;
    RESULT(checked1, screws, 62, -t59);
    const REAL t44 = t42 + k1 * limb2_lower_rotation_zy;
    RESULT(checked2, screws, 56, -t44);
    RESULT(checked3, screws, 64, t62 - minus_limb2_upper_position_x * t59);
    RESULT(checked0, screws, 63, minus_limb2_upper_position_y * t59 + t61);
    const REAL t50 = minus_limb2_upper_position_y * t39;
    const REAL t45 = minus_limb2_upper_position_y * t44;
    RESULT(checked1, screws, 58, minus_limb2_upper_position_z * t39 - minus_limb2_upper_position_x * t44);
    const REAL limb2_S_screws_y_wy = 0.5 * limb2_lower_sin - k1 * limb2_lower_cos;
    WRITE(screws, 55, limb2_S_screws_y_wy);
    RESULT(checked2, screws, 59, -(minus_limb2_upper_position_x * limb2_S_screws_y_wy + t50));
    RESULT(checked3, screws, 57, t45 + minus_limb2_upper_position_z * limb2_S_screws_y_wy);
    const REAL t34 = limb2_U_0_sin * minus_limb2_upper_position_z;
    RESULT(checked0, screws, 52, -(t34 + minus_limb2_U_0_cos * minus_limb2_upper_position_x));
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t8 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t9 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14), limb5_S_q_qz = READ(q, 15);
    const REAL t10 = t8 + t9;
    const REAL t11 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL t12 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t14 = t10 + (t11 + t12);
    const REAL t21 = t9 + t12;
    const REAL t16 = 4.0 - 2.0 * t14;
    const REAL platform_turn_yy = 1.0 - t16 * t21;
    WRITE(screws, 25, platform_turn_yy);
    const REAL t18 = limb5_S_q_qx * (limb5_S_q_qy * t16);
    const REAL t19 = limb5_S_q_qz * t16;
    const REAL t25 = limb5_S_q_qw * (limb5_S_q_qx * t16);
    const REAL platform_turn_xy = t18 - limb5_S_q_qw * t19;
    WRITE(screws, 24, platform_turn_xy);
    const REAL platform_turn_zy = limb5_S_q_qy * t19 + t25;
    WRITE(screws, 26, platform_turn_zy);
    /* limb1: geometry; screws, eq. (5) */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_lower_cos = SINES(cosine, 1);
    WRITE(screws, 18, limb1_lower_cos);
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    RESULT(checked1, screws, 16, -minus_limb1_lower_rotation_yx);
    const REAL minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx;
    const REAL limb1_lower_sin = SINES(sine, 1);
    WRITE(screws, 15, limb1_lower_sin);
    const REAL t31 = platform_turn_xy * minus_limb1_upper_position_y;
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    RESULT(checked2, screws, 29, t31 - platform_turn_yy * minus_limb1_upper_position_x);
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    WRITE(screws, 7, limb1_U_0_cos);
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    WRITE(screws, 17, limb1_lower_rotation_zx);
    const REAL limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx;
    /* limb1: screws, eq. (5); geometry */
    const REAL t27 = platform_turn_yy * limb1_upper_position_z;
    RESULT(checked3, screws, 28, platform_turn_xy * limb1_upper_position_z + platform_turn_zy * minus_limb1_upper_position_x);
    RESULT(checked0, screws, 27, -(platform_turn_zy * minus_limb1_upper_position_y + t27));
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    WRITE(screws, 19, limb1_lower_rotation_yy);
    const REAL t7 = limb1_lower_rotation_yy * minus_limb1_upper_position_x;
    const REAL t3 = limb1_lower_rotation_yy * limb1_upper_position_z;
    const REAL t4 = limb1_lower_cos * limb1_upper_position_z;
    RESULT(checked1, screws, 23, limb1_lower_cos * minus_limb1_upper_position_y - t7);
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin;
    RESULT(checked2, screws, 22, t4 - minus_limb1_lower_rotation_zy * minus_limb1_upper_position_x);
    RESULT(checked3, screws, 21, minus_limb1_lower_rotation_zy * minus_limb1_upper_position_y - t3);
    RESULT(checked0, screws, 20, -minus_limb1_lower_rotation_zy);
    RESULT(checked1, screws, 11, -(param_R * limb1_U_0_cos));
    WRITE(screws, 0, CONSTANT(1.0));
    WRITE(screws, 1, CONSTANT(0.0));
    WRITE(screws, 2, CONSTANT(0.0));
    WRITE(screws, 3, CONSTANT(0.0));
    WRITE(screws, 4, CONSTANT(0.0));
    WRITE(screws, 5, CONSTANT(0.0));
    WRITE(screws, 6, CONSTANT(0.0));
    WRITE(screws, 9, CONSTANT(0.0));
    WRITE(screws, 12, CONSTANT(0.0));
    WRITE(screws, 13, CONSTANT(0.0));
    WRITE(screws, 14, CONSTANT(0.0));
    WRITE(screws, 30, CONSTANT(0.0));
    WRITE(screws, 31, CONSTANT(1.0));
    WRITE(screws, 32, CONSTANT(0.0));
    WRITE(screws, 33, CONSTANT(0.0));
    WRITE(screws, 34, CONSTANT(0.0));
    WRITE(screws, 35, CONSTANT(0.0));
    WRITE(screws, 37, CONSTANT(0.0));
    WRITE(screws, 40, CONSTANT(0.0));
    WRITE(screws, 42, CONSTANT(0.0));
    WRITE(screws, 43, CONSTANT(0.0));
    WRITE(screws, 44, CONSTANT(0.0));
    WRITE(screws, 49, CONSTANT(0.0));
    WRITE(screws, 66, CONSTANT(1.0));
    WRITE(screws, 67, CONSTANT(0.0));
    WRITE(screws, 68, CONSTANT(0.0));
    WRITE(screws, 69, CONSTANT(0.0));
    WRITE(screws, 70, CONSTANT(0.0));
    WRITE(screws, 71, CONSTANT(0.0));
    WRITE(screws, 72, CONSTANT(0.0));
    WRITE(screws, 75, CONSTANT(0.0));
    WRITE(screws, 78, CONSTANT(0.0));
    WRITE(screws, 79, CONSTANT(0.0));
    WRITE(screws, 80, CONSTANT(0.0));
    WRITE(screws, 90, CONSTANT(0.0));
    WRITE(screws, 102, CONSTANT(0.0));
    WRITE(screws, 103, CONSTANT(1.0));
    WRITE(screws, 104, CONSTANT(0.0));
    WRITE(screws, 105, CONSTANT(0.0));
    WRITE(screws, 106, CONSTANT(0.0));
    WRITE(screws, 107, CONSTANT(0.0));
    WRITE(screws, 109, CONSTANT(0.0));
    WRITE(screws, 112, CONSTANT(0.0));
    WRITE(screws, 114, CONSTANT(0.0));
    WRITE(screws, 115, CONSTANT(0.0));
    WRITE(screws, 116, CONSTANT(0.0));
    WRITE(screws, 121, CONSTANT(0.0));
    WRITE(screws, 138, CONSTANT(1.0));
    WRITE(screws, 139, CONSTANT(0.0));
    WRITE(screws, 140, CONSTANT(0.0));
    WRITE(screws, 141, CONSTANT(0.0));
    WRITE(screws, 142, CONSTANT(0.0));
    WRITE(screws, 143, CONSTANT(0.0));
    WRITE(screws, 144, CONSTANT(0.0));
    WRITE(screws, 145, CONSTANT(1.0));
    WRITE(screws, 146, CONSTANT(0.0));
    WRITE(screws, 147, CONSTANT(0.0));
    WRITE(screws, 148, CONSTANT(0.0));
    WRITE(screws, 149, CONSTANT(0.0));
    WRITE(screws, 150, CONSTANT(0.0));
    WRITE(screws, 151, CONSTANT(0.0));
    WRITE(screws, 152, CONSTANT(1.0));
    WRITE(screws, 153, CONSTANT(0.0));
    WRITE(screws, 154, CONSTANT(0.0));
    WRITE(screws, 155, CONSTANT(0.0));
    NOT_BELOW(t14, 0.999999, 5);
    NOT_ABOVE(t14, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_joint_points)(size_t stride, const double *restrict q, double *restrict points,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    REAL checked0 = READ(q, 12);
    REAL checked1 = READ(q, 13);
    REAL checked2 = READ(q, 14);
    REAL checked3 = READ(q, 15);
    /* limb1: geometry; results */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    RESULT(checked0, points, 6, -minus_limb1_upper_position_x);
    RESULT(checked1, points, 3, -(minus_limb1_upper_position_x + limb_upper_phase * limb1_lower_sin));
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL minus_limb1_lower_rotation_yx = SINES(sine, 0) * limb1_lower_cos;
    const REAL t4 = limb_upper_phase * minus_limb1_lower_rotation_yx;
    const REAL minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx;
    RESULT(checked2, points, 4, t4 - minus_limb1_upper_position_y);
    RESULT(checked3, points, 7, -minus_limb1_upper_position_y);
    const REAL limb1_lower_rotation_zx = SINES(cosine, 0) * limb1_lower_cos;
    const REAL limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx;
    WRITE(points, 8, limb1_upper_position_z);
    RESULT(checked0, points, 5, limb1_upper_position_z - limb_upper_phase * limb1_lower_rotation_zx);
    /* limb2: geometry; results */
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_rotation_xx = SINES(sine, 2) * limb2_lower_cos;
    const REAL t7 = limb_upper_phase * minus_limb2_lower_rotation_xx;
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5);
    const REAL minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx;
    RESULT(checked1, points, 12, t7 - minus_limb2_upper_position_x);
    RESULT(checked2, points, 15, -minus_limb2_upper_position_x);
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    RESULT(checked3, points, 16, -minus_limb2_upper_position_y);
    RESULT(checked0, points, 13, -(minus_limb2_upper_position_y + limb_upper_phase * limb2_lower_sin));
    const REAL minus_limb2_lower_rotation_zx = SINES(cosine, 2) * limb2_lower_cos;
    const REAL minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx;
    RESULT(checked1, points, 14, limb_upper_phase * minus_limb2_lower_rotation_zx - minus_limb2_upper_position_z);
    RESULT(checked2, points, 17, -minus_limb2_upper_position_z);
    /* limb3: geometry; results */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    const REAL limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    WRITE(points, 24, limb3_upper_position_x);
    RESULT(checked3, points, 21, limb3_upper_position_x + limb_upper_phase * minus_limb3_lower_sin);
    const REAL limb3_lower_cos = SINES(cosine, 5);
    const REAL minus_limb3_lower_rotation_yx = SINES(sine, 4) * limb3_lower_cos;
    const REAL t14 = limb_upper_phase * minus_limb3_lower_rotation_yx;
    const REAL minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx;
    RESULT(checked0, points, 22, t14 - minus_limb3_upper_position_y);
    RESULT(checked1, points, 25, -minus_limb3_upper_position_y);
    const REAL limb3_lower_rotation_zx = SINES(cosine, 4) * limb3_lower_cos;
    const REAL limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx;
    WRITE(points, 26, limb3_upper_position_z);
    RESULT(checked2, points, 23, limb3_upper_position_z - limb_upper_phase * limb3_lower_rotation_zx);
    /* limb4: geometry; results */
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL minus_limb4_lower_rotation_xx = SINES(sine, 6) * limb4_lower_cos;
    const REAL t17 = limb_upper_phase * minus_limb4_lower_rotation_xx;
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11);
    const REAL minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx;
    RESULT(checked3, points, 30, t17 - minus_limb4_upper_position_x);
    RESULT(checked0, points, 33, -minus_limb4_upper_position_x);
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x;
    WRITE(points, 34, limb4_upper_position_y);
    RESULT(checked1, points, 31, limb4_upper_position_y + limb_upper_phase * minus_limb4_lower_sin);
    const REAL minus_limb4_lower_rotation_zx = SINES(cosine, 6) * limb4_lower_cos;
    const REAL minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx;
    RESULT(checked2, points, 32, limb_upper_phase * minus_limb4_lower_rotation_zx - minus_limb4_upper_position_z);
    RESULT(checked3, points, 35, -minus_limb4_upper_position_z);
    WRITE(points, 0, CONSTANT((-param_R)));
    WRITE(points, 1, CONSTANT(0.0));
    WRITE(points, 2, CONSTANT(0.0));
    WRITE(points, 9, CONSTANT(0.0));
    WRITE(points, 10, CONSTANT((-param_R)));
    WRITE(points, 11, CONSTANT(0.0));
    WRITE(points, 18, CONSTANT(param_R));
    WRITE(points, 19, CONSTANT(0.0));
    WRITE(points, 20, CONSTANT(0.0));
    WRITE(points, 27, CONSTANT(0.0));
    WRITE(points, 28, CONSTANT(param_R));
    WRITE(points, 29, CONSTANT(0.0));
    WRITE(points, 36, CONSTANT(0.0));
    WRITE(points, 37, CONSTANT(0.0));
    WRITE(points, 38, CONSTANT(0.0));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_platform_jacobian)(size_t stride, const double *restrict q, double *restrict jacobian,
    double *restrict total)
{
    const FOURS fours = (FOUR(q, 0) + FOUR(q, 4)) + FOUR(q, 8);
    REAL checked0 = SUM_OF_FOUR(fours);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13);
    const REAL t4 = limb5_S_q_qw * limb5_S_q_qw;
    const REAL t5 = limb5_S_q_qx * limb5_S_q_qx;
    const REAL limb5_S_q_qy = READ(q, 14);
    const REAL t6 = t4 + t5;
    const REAL t1 = limb5_S_q_qy * limb5_S_q_qy;
    const REAL limb5_S_q_qz = READ(q, 15);
    const REAL t2 = limb5_S_q_qz * limb5_S_q_qz;
    const REAL t3 = t1 + t2;
    const REAL t7 = t6 + t3;
    const REAL t9 = 4.0 - 2.0 * t7;
    const REAL t17 = t5 + t2;
    const REAL platform_turn_zz = 1.0 - t9 * (t5 + t1);
    WRITE(jacobian, 86, platform_turn_zz);
    REAL checked1 = platform_turn_zz;
    const REAL platform_turn_yy = 1.0 - t9 * t17;
    WRITE(jacobian, 79, platform_turn_yy);
    REAL checked2 = platform_turn_yy;
    const REAL platform_turn_xx = 1.0 - t3 * t9;
    WRITE(jacobian, 72, platform_turn_xx);
    REAL checked3 = platform_turn_xx;
    const REAL t13 = limb5_S_q_qz * t9;
    const REAL t19 = limb5_S_q_qy * t13;
    const REAL t21 = limb5_S_q_qw * (limb5_S_q_qx * t9);
    RESULT(checked0, jacobian, 85, t19 - t21);
    RESULT(checked1, jacobian, 80, t19 + t21);
    const REAL t11 = limb5_S_q_qy * t9;
    const REAL t15 = limb5_S_q_qx * t13;
    const REAL t14 = limb5_S_q_qw * t13;
    const REAL t16 = limb5_S_q_qw * t11;
    RESULT(checked2, jacobian, 84, t15 + t16);
    RESULT(checked3, jacobian, 74, t15 - t16);
    const REAL t12 = limb5_S_q_qx * t11;
    RESULT(checked0, jacobian, 78, t12 - t14);
    RESULT(checked1, jacobian, 73, t12 + t14);
    WRITE(jacobian, 75, CONSTANT(0.0));
    WRITE(jacobian, 76, CONSTANT(0.0));
    WRITE(jacobian, 77, CONSTANT(0.0));
    WRITE(jacobian, 81, CONSTANT(0.0));
    WRITE(jacobian, 82, CONSTANT(0.0));
    WRITE(jacobian, 83, CONSTANT(0.0));
    WRITE(jacobian, 87, CONSTANT(0.0));
    WRITE(jacobian, 88, CONSTANT(0.0));
    WRITE(jacobian, 89, CONSTANT(0.0));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_joint_rates)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict rates, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    REAL checked0 = READ(q, 2);
    REAL checked1 = READ(q, 5);
    REAL checked2 = READ(q, 8);
    REAL checked3 = READ(q, 11);
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
    const REAL limb5_S_v_wx = READ(v, 12);
    const REAL t29 = limb5_S_v_wx * (1.0 - t7 * t10);
    const REAL t44 = t3 + t5;
    const REAL platform_turn_yy = 1.0 - t10 * (t3 + t6);
    const REAL limb5_S_v_wz = READ(v, 14);
    const REAL t46 = limb5_S_v_wz * (1.0 - t10 * t44);
    const REAL t11 = limb5_S_q_qy * t10;
    const REAL t12 = limb5_S_q_qx * t11;
    const REAL t33 = limb5_S_q_qw * t11;
    const REAL t13 = limb5_S_q_qz * t10;
    const REAL t22 = limb5_S_q_qw * (limb5_S_q_qx * t10);
    const REAL t14 = limb5_S_q_qw * t13;
    const REAL platform_turn_xy = t12 - t14;
    const REAL limb5_S_v_wy = READ(v, 13);
    const REAL t38 = limb5_S_v_wx * (t12 + t14);
    const REAL t31 = t29 + limb5_S_v_wy * platform_turn_xy;
    const REAL t32 = limb5_S_q_qx * t13;
    const REAL t20 = limb5_S_q_qy * t13;
    const REAL platform_turn_zx = t32 - t33;
    const REAL platform_twist_angular_x = t31 + limb5_S_v_wz * (t32 + t33);
    WRITE(rates, 23, platform_twist_angular_x);
    const REAL limb1_U_v_0 = READ(v, 0);
    WRITE(rates, 0, limb1_U_v_0);
    const REAL t47 = limb5_S_v_wx * platform_turn_zx;
    const REAL t35 = limb1_U_v_0 - platform_twist_angular_x; /* limb1 */
    const REAL limb1_lower_cos = SINES(cosine, 1);
    const REAL t53 = platform_turn_xy * t35; /* limb1 */
    const REAL t15 = limb1_lower_cos * platform_turn_xy; /* limb1 */
    const REAL t36 = limb1_lower_cos * t35; /* limb1 */
    const REAL t39 = limb5_S_v_wy * platform_turn_yy + t38;
    const REAL platform_turn_yz = t20 - t22;
    const REAL platform_turn_zy = t20 + t22;
    const REAL platform_twist_angular_y = t39 + limb5_S_v_wz * platform_turn_yz;
    WRITE(rates, 24, platform_twist_angular_y);
    /* limb1: velocities, eq. (6); geometry; results */
    const REAL limb1_U_v_1 = READ(v, 1);
    WRITE(rates, 1, limb1_U_v_1);
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    const REAL t41 = platform_twist_angular_y - limb1_U_v_1 * limb1_U_0_cos;
    const REAL t55 = t53 - platform_turn_yy * t41;
    const REAL platform_twist_angular_z = t46 + (t47 + limb5_S_v_wy * platform_turn_zy);
    WRITE(rates, 25, platform_twist_angular_z);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    /* limb1: results; geometry */
    const REAL t50 = platform_twist_angular_z - limb1_U_v_1 * limb1_U_0_sin;
    const REAL t57 = t55 - platform_turn_zy * t50;
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    const REAL t19 = t15 + platform_turn_yy * limb1_lower_rotation_yy;
    const REAL t43 = t36 - limb1_lower_rotation_yy * t41;
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin;
    const REAL t24 = t19 - platform_turn_zy * minus_limb1_lower_rotation_zy;
    const REAL t52 = t43 + minus_limb1_lower_rotation_zy * t50;
    const REAL t59 = t52 - t24 * t57;
    const REAL t62 = t57 - t24 * t52;
    const REAL t27 = 1.0 / (1.0 - t24 * t24);
    RESULT(checked0, rates, 3, -(t27 * t59));
    RESULT(checked1, rates, 4, -(t27 * t62));
    /* limb2: velocities, eq. (6); geometry; results */
    const REAL limb2_U_v_1 = READ(v, 4);
    WRITE(rates, 6, limb2_U_v_1);
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    const REAL t64 = platform_twist_angular_x - limb2_U_v_1 * limb2_U_0_sin;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    /* limb2: results; geometry */
    const REAL t65 = limb2_U_0_sin * t64;
    const REAL t66 = platform_twist_angular_z + limb2_U_v_1 * minus_limb2_U_0_cos;
    RESULT(checked2, rates, 8, t65 - minus_limb2_U_0_cos * t66);
    const REAL limb2_lower_cos = SINES(cosine, 3);
    const REAL minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    const REAL limb2_lower_sin = SINES(sine, 3);
    const REAL t69 = 0.5 * minus_limb2_lower_rotation_xx;
    const REAL t84 = k1 * minus_limb2_lower_rotation_xx;
    const REAL limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin;
    const REAL limb2_U_v_0 = READ(v, 3);
    WRITE(rates, 5, limb2_U_v_0);
    const REAL t72 = (t69 + k1 * limb2_lower_rotation_xy) * t64;
    const REAL t87 = (t84 - 0.5 * limb2_lower_rotation_xy) * t64;
    const REAL t76 = limb2_U_v_0 - platform_twist_angular_y;
    const REAL t78 = t72 + (0.5 * limb2_lower_sin - k1 * limb2_lower_cos) * t76;
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos;
    const REAL t79 = 0.5 * minus_limb2_lower_rotation_zx;
    const REAL t93 = k1 * minus_limb2_lower_rotation_zx;
    const REAL limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin;
    RESULT(checked3, rates, 9, -(t78 + (t79 + k1 * limb2_lower_rotation_zy) * t66));
    const REAL t96 = (t93 - 0.5 * limb2_lower_rotation_zy) * t66;
    const REAL t97 = t87 + (k1 * limb2_lower_sin + 0.5 * limb2_lower_cos) * t76 + t96;
    RESULT(checked0, rates, 10, -t97);
    /* limb3: results; geometry; velocities, eq. (6) */
    const REAL limb3_U_v_0 = READ(v, 6);
    WRITE(rates, 11, limb3_U_v_0);
    const REAL t102 = limb3_U_v_0 - platform_twist_angular_x;
    const REAL minus_limb3_lower_sin = SINES(sine, 5), limb3_lower_cos = SINES(cosine, 5), limb3_U_v_1 = READ(v, 7);
    WRITE(rates, 12, limb3_U_v_1);
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    const REAL t103 = (0.5 * minus_limb3_lower_sin + k1 * limb3_lower_cos) * t102;
    const REAL t107 = platform_twist_angular_y - limb3_U_v_1 * limb3_U_0_cos;
    const REAL limb4_U_v_0 = READ(v, 9);
    WRITE(rates, 17, limb4_U_v_0);
    const REAL t143 = limb4_U_v_0 - platform_twist_angular_y; /* limb4 */
    const REAL limb3_U_0_sin = SINES(sine, 4);
    const REAL minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    const REAL t104 = 0.5 * minus_limb3_lower_rotation_yx;
    const REAL t122 = k1 * minus_limb3_lower_rotation_yx;
    const REAL minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin;
    const REAL t109 = t103 - (t104 - k1 * minus_limb3_lower_rotation_yy) * t107;
    const REAL t125 = (t122 + 0.5 * minus_limb3_lower_rotation_yy) * t107;
    const REAL t116 = limb3_U_0_cos * t107;
    const REAL t113 = platform_twist_angular_z - limb3_U_v_1 * limb3_U_0_sin;
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    const REAL t110 = 0.5 * limb3_lower_rotation_zx;
    const REAL t127 = k1 * limb3_lower_rotation_zx;
    const REAL limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin;
    RESULT(checked1, rates, 14, -(t109 + (t110 - k1 * limb3_lower_rotation_zy) * t113));
    const REAL t130 = (t127 + 0.5 * limb3_lower_rotation_zy) * t113;
    RESULT(checked2, rates, 15, t116 + limb3_U_0_sin * t113);
    RESULT(checked3, rates, 16, (k1 * minus_limb3_lower_sin - 0.5 * limb3_lower_cos) * t102 - t125 + t130);
    /* limb4: velocities, eq. (6); geometry; results */
    const REAL limb4_U_v_1 = READ(v, 10);
    WRITE(rates, 18, limb4_U_v_1);
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    const REAL t131 = platform_twist_angular_x - limb4_U_v_1 * limb4_U_0_sin;
    const REAL minus_limb4_U_0_cos = SINES(sine, 6);
    /* limb4: results; geometry */
    const REAL t132 = limb4_U_0_sin * t131;
    const REAL t133 = platform_twist_angular_z + limb4_U_v_1 * minus_limb4_U_0_cos;
    RESULT(checked0, rates, 20, t132 - minus_limb4_U_0_cos * t133);
    const REAL limb4_lower_cos = SINES(cosine, 7);
    const REAL minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    const REAL t136 = 0.5 * minus_limb4_lower_rotation_xx;
    const REAL t150 = k1 * minus_limb4_lower_rotation_xx;
    const REAL minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin;
    const REAL t139 = (t136 + k1 * minus_limb4_lower_rotation_xy) * t131;
    const REAL t153 = (t150 - 0.5 * minus_limb4_lower_rotation_xy) * t131;
    const REAL t145 = t139 - (0.5 * minus_limb4_lower_sin - k1 * limb4_lower_cos) * t143;
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos;
    const REAL t146 = 0.5 * minus_limb4_lower_rotation_zx;
    const REAL t159 = k1 * minus_limb4_lower_rotation_zx;
    const REAL minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin;
    RESULT(checked1, rates, 21, t145 + (t146 + k1 * minus_limb4_lower_rotation_zy) * t133);
    const REAL t162 = (t159 - 0.5 * minus_limb4_lower_rotation_zy) * t133;
    const REAL t163 = t153 - (k1 * minus_limb4_lower_sin + 0.5 * limb4_lower_cos) * t143 + t162;
    RESULT(checked2, rates, 22, -t163);
    const REAL limb1_P_v = READ(v, 2);
    WRITE(rates, 2, limb1_P_v);
    checked3 = checked3 + limb1_P_v;
    const REAL limb2_P_v = READ(v, 5);
    WRITE(rates, 7, limb2_P_v);
    checked0 = checked0 + limb2_P_v;
    const REAL limb3_P_v = READ(v, 8);
    WRITE(rates, 13, limb3_P_v);
    checked1 = checked1 + limb3_P_v;
    const REAL limb4_P_v = READ(v, 11);
    WRITE(rates, 19, limb4_P_v);
    checked2 = checked2 + limb4_P_v;
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_drive_rates)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict rates, double *restrict total)
{
    const FOURS fours = (FOUR(q, 0) + FOUR(q, 4)) + (FOUR(q, 8) + FOUR(q, 12));
    REAL checked0 = SUM_OF_FOUR(fours);
    REAL checked1 = READ(v, 0);
    REAL checked2 = READ(v, 1);
    REAL checked3 = READ(v, 3);
    checked0 = checked0 + (READ(v, 4));
    checked1 = checked1 + (READ(v, 6));
    checked2 = checked2 + (READ(v, 7));
    checked3 = checked3 + (READ(v, 9));
    checked0 = checked0 + (READ(v, 10));
    checked1 = checked1 + (READ(v, 12));
    checked2 = checked2 + (READ(v, 13));
    checked3 = checked3 + (READ(v, 14));
    const REAL limb1_P_v = READ(v, 2);
    WRITE(rates, 0, limb1_P_v);
    checked0 = checked0 + limb1_P_v;
    const REAL limb2_P_v = READ(v, 5);
    WRITE(rates, 1, limb2_P_v);
    checked1 = checked1 + limb2_P_v;
    const REAL limb3_P_v = READ(v, 8);
    WRITE(rates, 2, limb3_P_v);
    checked2 = checked2 + limb3_P_v;
    const REAL limb4_P_v = READ(v, 11);
    WRITE(rates, 3, limb4_P_v);
    checked3 = checked3 + limb4_P_v;
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_inverse_velocity)(size_t stride, const double *restrict pose,
    const double *restrict rate, double *restrict v, double *restrict total)
{
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_pose_qw = READ(pose, 0), limb5_S_pose_qx = READ(pose, 1);
    const REAL t1 = limb5_S_pose_qw * limb5_S_pose_qw;
    const REAL t2 = limb5_S_pose_qx * limb5_S_pose_qx;
    const REAL limb5_S_pose_qy = READ(pose, 2);
    const REAL t3 = t1 + t2;
    const REAL t4 = limb5_S_pose_qy * limb5_S_pose_qy;
    const REAL limb5_S_pose_qz = READ(pose, 3);
    const REAL t5 = limb5_S_pose_qz * limb5_S_pose_qz;
    const REAL t6 = t4 + t5;
    const REAL t7 = t3 + t6;
    const REAL t9 = 4.0 - 2.0 * t7;
    const REAL t45 = t2 + t5;
    const REAL platform_turn_zz = 1.0 - t9 * (t2 + t4);
    const REAL platform_turn_xx = 1.0 - t6 * t9;
    const REAL platform_turn_yy = 1.0 - t9 * t45;
    const REAL t10 = limb5_S_pose_qy * t9;
    const REAL t11 = limb5_S_pose_qx * t10;
    const REAL t21 = limb5_S_pose_qw * t10;
    const REAL t12 = limb5_S_pose_qz * t9;
    const REAL t17 = limb5_S_pose_qw * (limb5_S_pose_qx * t9);
    const REAL t13 = limb5_S_pose_qw * t12;
    const REAL platform_turn_yx = t11 + t13;
    const REAL platform_turn_xy = t11 - t13;
    const REAL t14 = 0.5 * platform_turn_yx;
    const REAL limb5_S_rate_wx = READ(rate, 0);
    WRITE(v, 12, limb5_S_rate_wx);
    const REAL t48 = limb5_S_rate_wx * platform_turn_yx;
    const REAL t15 = limb5_S_pose_qy * t12;
    const REAL t20 = limb5_S_pose_qx * t12;
    const REAL platform_turn_yz = t15 - t17;
    const REAL platform_turn_zy = t15 + t17;
    const REAL t18 = param_H * platform_turn_yz;
    const REAL limb5_S_rate_wz = READ(rate, 2);
    WRITE(v, 14, limb5_S_rate_wz);
    const REAL t50 = limb5_S_rate_wz * platform_turn_yz;
    const REAL minus_limb1_lower_limb_target_x = t14 - t18;
    const REAL limb3_lower_limb_target_x = t14 + t18;
    const REAL t19 = minus_limb1_lower_limb_target_x * minus_limb1_lower_limb_target_x; /* limb1 */
    const REAL platform_turn_zx = t20 - t21;
    const REAL platform_turn_xz = t20 + t21;
    const REAL t22 = 0.5 * platform_turn_zx;
    const REAL t33 = limb5_S_rate_wx * platform_turn_zx;
    const REAL t25 = param_H * platform_turn_zz;
    const REAL t32 = limb5_S_rate_wz * platform_turn_zz;
    const REAL minus_limb1_lower_limb_target_y = t22 - t25;
    const REAL limb3_lower_limb_target_y = t22 + t25;
    const REAL t27 = t19 + minus_limb1_lower_limb_target_y * minus_limb1_lower_limb_target_y; /* limb1 */
    const REAL limb1_U_0_pivot = SQRT(t27);
    const REAL t28 = 1.0 / limb1_U_0_pivot; /* limb1 */
    const REAL minus_limb1_U_0_cos = minus_limb1_lower_limb_target_y * t28;
    const REAL limb5_S_rate_wy = READ(rate, 1);
    WRITE(v, 13, limb5_S_rate_wy);
    const REAL platform_twist_angular_z = t32 + (t33 + limb5_S_rate_wy * platform_turn_zy);
    const REAL t31 = param_H * platform_turn_xz;
    const REAL t40 = limb5_S_rate_wz * platform_turn_xz;
    const REAL t30 = 0.5 * platform_turn_xx;
    const REAL t37 = limb5_S_rate_wx * platform_turn_xx;
    /* limb1: geometry */
    const REAL minus_limb1_upper_position_x = t30 - t31;
    const REAL limb3_upper_position_x = t30 + t31;
    /* limb1: loop closure; geometry; velocities, eq. (6) */
    const REAL t36 = minus_limb1_upper_position_x * platform_twist_angular_z;
    const REAL platform_twist_angular_x = t37 + limb5_S_rate_wy * platform_turn_xy + t40;
    const REAL t42 = t36 - minus_limb1_lower_limb_target_y * platform_twist_angular_x;
    const REAL t43 = t42 * minus_limb1_U_0_cos;
    const REAL limb1_U_0_sin = minus_limb1_lower_limb_target_x * t28;
    const REAL t57 = t42 * limb1_U_0_sin;
    const REAL t44 = minus_limb1_lower_limb_target_x * platform_twist_angular_x;
    const REAL t62 = minus_limb1_lower_limb_target_x * platform_twist_angular_z;
    const REAL platform_twist_angular_y = limb5_S_rate_wy * platform_turn_yy + t48 + t50;
    const REAL t63 = minus_limb1_lower_limb_target_y * platform_twist_angular_y - t62;
    const REAL t52 = t44 - minus_limb1_upper_position_x * platform_twist_angular_y;
    const REAL limb1_lower_limb_target_z = param_R - minus_limb1_upper_position_x;
    const REAL limb1_U_0_omega_z = -(t28 * (t43 - t52 * limb1_U_0_sin));
    WRITE(v, 0, limb1_U_0_omega_z);
    REAL checked0 = limb1_U_0_omega_z;
    const REAL t59 = t57 + t52 * minus_limb1_U_0_cos;
    const REAL t145 = platform_turn_yy * limb1_U_0_sin;
    const REAL t73 = 0.5 * platform_turn_yy; /* platform */
    const REAL t147 = t145 + platform_turn_zy * minus_limb1_U_0_cos;
    const REAL t67 = 0.5 * platform_turn_zy; /* platform */
    const REAL limb1_lower_limb_length = SQRT(t27 + limb1_lower_limb_target_z * limb1_lower_limb_target_z);
    REAL checked1 = limb1_lower_limb_length;
    const REAL t56 = 1.0 / limb1_lower_limb_length;
    const REAL limb1_lower_sin = limb1_lower_limb_target_z * t56;
    const REAL limb1_lower_cos = limb1_U_0_pivot * t56;
    const REAL t148 = limb1_lower_sin * t147;
    const REAL t60 = limb1_lower_sin * t59;
    const REAL minus_limb1_U2_opening_rate_fx = limb1_lower_cos * t59 - t63 * limb1_lower_sin;
    WRITE(v, 2, minus_limb1_U2_opening_rate_fx);
    REAL checked2 = minus_limb1_U2_opening_rate_fx;
    const REAL limb1_lower_omega_z = -(t56 * (t60 + t63 * limb1_lower_cos));
    WRITE(v, 1, limb1_lower_omega_z);
    REAL checked3 = limb1_lower_omega_z;
    const REAL limb1_U2_opening_mn = t148 + platform_turn_xy * limb1_lower_cos;
    const REAL t150 = limb1_U2_opening_mn * limb1_U2_opening_mn;
    const REAL t69 = 0.5 * platform_turn_xy; /* platform */
    /* limb2: geometry; reciprocal wrenches, eq. (10) */
    const REAL limb2_lower_limb_target_x = t25 - t67;
    const REAL limb4_lower_limb_target_x = t25 + t67;
    const REAL t68 = limb2_lower_limb_target_x * limb2_lower_limb_target_x;
    const REAL limb2_lower_limb_target_y = t31 - t69;
    const REAL limb4_lower_limb_target_y = t31 + t69;
    const REAL t71 = t68 + limb2_lower_limb_target_y * limb2_lower_limb_target_y;
    const REAL limb2_U_0_lever_moment_z_by_limb2_S_fz = SQRT(t71);
    const REAL t72 = 1.0 / limb2_U_0_lever_moment_z_by_limb2_S_fz;
    const REAL minus_limb2_U_0_cos = limb2_lower_limb_target_y * t72;
    const REAL limb2_upper_position_y = t18 - t73;
    const REAL limb4_upper_position_y = t18 + t73;
    /* limb2: loop closure; geometry; velocities, eq. (6) */
    const REAL t74 = limb2_upper_position_y * platform_twist_angular_x;
    const REAL t76 = t74 - limb2_lower_limb_target_y * platform_twist_angular_y;
    const REAL t89 = limb2_lower_limb_target_y * platform_twist_angular_z;
    const REAL t77 = t76 * minus_limb2_U_0_cos;
    const REAL limb2_U_0_sin = limb2_lower_limb_target_x * t72;
    const REAL t85 = t76 * limb2_U_0_sin;
    const REAL t78 = limb2_lower_limb_target_x * platform_twist_angular_y;
    const REAL t91 = t89 - limb2_lower_limb_target_x * platform_twist_angular_x;
    const REAL t80 = t78 - limb2_upper_position_y * platform_twist_angular_z;
    RESULT(checked0, v, 3, -(t72 * (t77 - t80 * limb2_U_0_sin)));
    const REAL t87 = t85 + t80 * minus_limb2_U_0_cos;
    const REAL limb2_lower_limb_target_z = param_R + limb2_upper_position_y;
    const REAL limb2_lower_limb_length = SQRT(t71 + limb2_lower_limb_target_z * limb2_lower_limb_target_z);
    checked1 = checked1 + limb2_lower_limb_length;
    const REAL t84 = 1.0 / limb2_lower_limb_length;
    const REAL limb2_lower_sin = limb2_lower_limb_target_z * t84;
    const REAL minus_limb2_lower_cos = limb2_U_0_lever_moment_z_by_limb2_S_fz * t84;
    const REAL t93 = minus_limb2_lower_cos * t87;
    RESULT(checked2, v, 4, t84 * (limb2_lower_sin * t87 - t91 * minus_limb2_lower_cos));
    RESULT(checked3, v, 5, t93 + t91 * limb2_lower_sin);
    /* limb3: reciprocal wrenches, eq. (10); geometry */
    const REAL t95 = limb3_lower_limb_target_x * limb3_lower_limb_target_x;
    const REAL t97 = t95 + limb3_lower_limb_target_y * limb3_lower_limb_target_y;
    const REAL limb3_U_0_pivot = SQRT(t97);
    const REAL t98 = 1.0 / limb3_U_0_pivot;
    const REAL limb3_U_0_cos = limb3_lower_limb_target_y * t98;
    /* limb3: loop closure; geometry; velocities, eq. (6) */
    const REAL t99 = limb3_upper_position_x * platform_twist_angular_z;
    const REAL t101 = t99 - limb3_lower_limb_target_y * platform_twist_angular_x;
    const REAL t114 = limb3_lower_limb_target_y * platform_twist_angular_y;
    const REAL t102 = t101 * limb3_U_0_cos;
    const REAL minus_limb3_U_0_sin = limb3_lower_limb_target_x * t98;
    const REAL t110 = t101 * minus_limb3_U_0_sin;
    const REAL t103 = limb3_lower_limb_target_x * platform_twist_angular_x;
    const REAL t116 = t114 - limb3_lower_limb_target_x * platform_twist_angular_z;
    const REAL t105 = t103 - limb3_upper_position_x * platform_twist_angular_y;
    RESULT(checked0, v, 6, -(t98 * (t102 - t105 * minus_limb3_U_0_sin)));
    const REAL t112 = t110 + t105 * limb3_U_0_cos;
    const REAL minus_limb3_lower_limb_target_z = param_R - limb3_upper_position_x;
    const REAL limb3_lower_limb_length = SQRT(t97 + minus_limb3_lower_limb_target_z * minus_limb3_lower_limb_target_z);
    checked1 = checked1 + limb3_lower_limb_length;
    const REAL t109 = 1.0 / limb3_lower_limb_length;
    const REAL minus_limb3_lower_sin = minus_limb3_lower_limb_target_z * t109;
    const REAL limb3_lower_cos = limb3_U_0_pivot * t109;
    const REAL t118 = limb3_lower_cos * t112;
    RESULT(checked2, v, 7, t109 * (minus_limb3_lower_sin * t112 + t116 * limb3_lower_cos));
    RESULT(checked3, v, 8, t118 - t116 * minus_limb3_lower_sin);
    /* limb4: reciprocal wrenches, eq. (10); geometry */
    const REAL t120 = limb4_lower_limb_target_x * limb4_lower_limb_target_x;
    const REAL t122 = t120 + limb4_lower_limb_target_y * limb4_lower_limb_target_y;
    const REAL limb4_U_0_lever_moment_z_by_limb4_S_fz = SQRT(t122);
    const REAL t123 = 1.0 / limb4_U_0_lever_moment_z_by_limb4_S_fz;
    const REAL minus_limb4_U_0_cos = limb4_lower_limb_target_y * t123;
    /* limb4: loop closure; geometry; velocities, eq. (6) */
    const REAL t124 = limb4_upper_position_y * platform_twist_angular_x;
    const REAL t140 = limb4_lower_limb_target_x * platform_twist_angular_x;
    const REAL t126 = t124 - limb4_lower_limb_target_y * platform_twist_angular_y;
    const REAL t128 = limb4_lower_limb_target_x * platform_twist_angular_y;
    const REAL limb4_U_0_sin = limb4_lower_limb_target_x * t123;
    const REAL t141 = limb4_lower_limb_target_y * platform_twist_angular_z - t140;
    const REAL t130 = t128 - limb4_upper_position_y * platform_twist_angular_z;
    const REAL minus_limb4_lower_limb_target_z = param_R - limb4_upper_position_y;
    const REAL t135 = t126 * limb4_U_0_sin;
    RESULT(checked0, v, 9, -(t123 * (t126 * minus_limb4_U_0_cos - t130 * limb4_U_0_sin)));
    const REAL t137 = t135 + t130 * minus_limb4_U_0_cos;
    const REAL limb4_lower_limb_length = SQRT(t122 + minus_limb4_lower_limb_target_z * minus_limb4_lower_limb_target_z);
    checked1 = checked1 + limb4_lower_limb_length;
    const REAL t134 = 1.0 / limb4_lower_limb_length;
    const REAL minus_limb4_lower_sin = minus_limb4_lower_limb_target_z * t134;
    const REAL minus_limb4_lower_cos = limb4_U_0_lever_moment_z_by_limb4_S_fz * t134;
    const REAL t143 = minus_limb4_lower_cos * t137;
    RESULT(checked2, v, 10, -(t134 * (minus_limb4_lower_sin * t137 + t141 * minus_limb4_lower_cos)));
    RESULT(checked3, v, 11, t143 - t141 * minus_limb4_lower_sin);
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    NOT_ABOVE(t150, 1.0e-12, 6);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(limb3_lower_limb_length, 6.62327e-10) OR /* where the points of limb3_lower coincide */
        SMALL(limb2_lower_limb_length, 6.62327e-10) OR /* where the points of limb2_lower coincide */
        SMALL(limb4_lower_limb_length, 6.62327e-10) OR /* where the points of limb4_lower coincide */
        SMALL(limb1_lower_limb_length, 6.62327e-10) OR /* where the points of limb1_lower coincide */
        SMALL(limb3_U_0_pivot, 6.62327e-10) OR /* where the reciprocal wrench limb3_S.fz has no power along limb3_U.0, as in a stretched limb */
        SMALL(limb2_U_0_lever_moment_z_by_limb2_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb */
        SMALL(limb4_U_0_lever_moment_z_by_limb4_S_fz, 6.62327e-10) OR /* where the reciprocal wrench limb4_S.fz has no power along limb4_U.0, as in a stretched limb */
        SMALL(limb1_U_0_pivot, 6.62327e-10), /* where the reciprocal wrench limb1_U2.fz has no power along limb1_U.0, as in a stretched limb */
        (checked0 + checked1) + (checked2 + checked3));
}

#if !defined(THREE_UPS_UPU_S_VECTORS)

int three_ups_upu_s_body_poses(const double *restrict q, double *restrict poses)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_body_poses_body(1, q, poses, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(poses, 108);
    }
    return outcome;
}

int three_ups_upu_s_body_twists(const double *restrict q, const double *restrict v, double *restrict twists)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_body_twists_body(1, q, v, twists, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(twists, 54);
    }
    return outcome;
}

int three_ups_upu_s_body_twist_rates(const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict twist_rates)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_body_twist_rates_body(1, q, v, a, twist_rates, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(twist_rates, 54);
    }
    return outcome;
}

int three_ups_upu_s_forward_kinematics(const double *restrict q, double *restrict positions)
{
    const int outcome = three_ups_upu_s_forward_kinematics_body(1, q, positions, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(positions, 30);
    }
    return outcome;
}

int three_ups_upu_s_point_motion(const double *restrict q, const double *restrict v, const double *restrict a,
    double *restrict positions, double *restrict velocities, double *restrict accelerations)
{
    three_ups_upu_s_zero(velocities + 6, 12);
    three_ups_upu_s_zero(accelerations + 6, 12);
    const int outcome = three_ups_upu_s_point_motion_body(1, q, v, a, positions, velocities, accelerations,
        NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(positions, 30);
        three_ups_upu_s_set_nan(velocities, 30);
        three_ups_upu_s_set_nan(accelerations, 30);
    }
    return outcome;
}

int three_ups_upu_s_joint_screws(const double *restrict q, double *restrict screws)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_joint_screws_body(1, q, screws, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(screws, 156);
    }
    return outcome;
}

int three_ups_upu_s_joint_points(const double *restrict q, double *restrict points)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_joint_points_body(1, q, points, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(points, 39);
    }
    return outcome;
}

int three_ups_upu_s_platform_jacobian(const double *restrict q, double *restrict jacobian)
{
    three_ups_upu_s_zero(jacobian, 72);
    const int outcome = three_ups_upu_s_platform_jacobian_body(1, q, jacobian, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(jacobian, 90);
    }
    return outcome;
}

BODY(three_ups_upu_s_joint_displacements)(size_t stride, const double *restrict q,
    double *restrict displacements, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    /* limb5_S: geometry; results */
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
    const REAL platform_turn_xx = 1.0 - t7 * t10;
    const REAL t39 = t3 + t5;
    const REAL platform_turn_yy = 1.0 - t10 * (t3 + t6);
    const REAL t377 = t6 + t39;
    const REAL platform_turn_zz = 1.0 - t10 * t39;
    const REAL t378 = SQRT(t377);
    const REAL t13 = limb5_S_q_qz * t10;
    const REAL t19 = limb5_S_q_qy * t13;
    const REAL t21 = limb5_S_q_qw * (limb5_S_q_qx * t10);
    const REAL t11 = limb5_S_q_qy * t10;
    const REAL platform_turn_zy = t19 + t21;
    const REAL platform_turn_yz = t19 - t21;
    const REAL limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0), limb1_lower_cos = SINES(cosine, 1);
    const REAL t24 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy); /* limb1 */
    const REAL t12 = limb5_S_q_qx * t11;
    const REAL t32 = limb5_S_q_qw * t11;
    const REAL t14 = limb5_S_q_qw * t13;
    const REAL t31 = limb5_S_q_qx * t13;
    const REAL platform_turn_xy = t12 - t14;
    const REAL platform_turn_yx = t12 + t14;
    /* limb1: geometry; reciprocal wrenches, eq. (10) */
    const REAL limb1_lower_sin = SINES(sine, 1);
    const REAL minus_limb1_U2_constraint_mn_couple_z = limb1_lower_sin * platform_turn_xy - t24;
    /* limb1: results; geometry */
    const REAL limb1_U2_displacements_0 = atan2(minus_limb1_U2_constraint_mn_couple_z, limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy);
    WRITE(displacements, 3, limb1_U2_displacements_0);
    REAL checked0 = limb1_U2_displacements_0;
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    const REAL t37 = platform_turn_yz * limb1_lower_rotation_yy;
    const REAL t30 = limb1_lower_cos * platform_turn_xx + platform_turn_yx * limb1_lower_rotation_yy;
    const REAL platform_turn_zx = t31 - t32;
    const REAL platform_turn_xz = t31 + t32;
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin;
    const REAL t34 = t30 - platform_turn_zx * minus_limb1_lower_rotation_zy;
    const REAL t35 = 0.5 * t34;
    const REAL t46 = k1 * t34;
    const REAL t42 = limb1_lower_cos * platform_turn_xz + t37 - platform_turn_zz * minus_limb1_lower_rotation_zy;
    const REAL t49 = atan2(-(t35 + k1 * t42), t46 - 0.5 * t42);
    const REAL limb1_U2_displacements_1 = -t49;
    WRITE(displacements, 4, limb1_U2_displacements_1);
    REAL checked1 = limb1_U2_displacements_1;
    /* platform: results */
    const REAL t51 = 0.5 * platform_turn_zy;
    const REAL t52 = k1 * platform_turn_zz;
    const REAL t73 = 0.5 * platform_turn_zz;
    const REAL t53 = t51 + t52;
    const REAL t275 = t51 - t52;
    const REAL limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2);
    const REAL t54 = limb2_U_0_sin * t53; /* limb2 */
    const REAL t120 = minus_limb2_U_0_cos * t53; /* limb2 */
    const REAL t55 = 0.5 * platform_turn_xy;
    const REAL t56 = k1 * platform_turn_xz;
    const REAL t77 = 0.5 * platform_turn_xz;
    const REAL t57 = t55 + t56;
    const REAL t277 = t55 - t56;
    const REAL t59 = t54 + minus_limb2_U_0_cos * t57; /* limb2 */
    const REAL t122 = t120 - limb2_U_0_sin * t57; /* limb2 */
    const REAL limb2_lower_cos = SINES(cosine, 3), limb2_lower_sin = SINES(sine, 3);
    const REAL t60 = limb2_lower_cos * t59; /* limb2 */
    const REAL t67 = limb2_lower_sin * t59; /* limb2 */
    const REAL t62 = k1 * platform_turn_yz;
    const REAL t83 = 0.5 * platform_turn_yz;
    const REAL t61 = 0.5 * platform_turn_yy;
    const REAL t63 = t61 + t62;
    const REAL t281 = t61 - t62;
    /* limb2: results */
    const REAL t65 = t60 - limb2_lower_sin * t63;
    const REAL t69 = t67 + limb2_lower_cos * t63;
    const REAL t96 = k1 * t65;
    const REAL t71 = 0.5 * t65 + k1 * t69;
    const REAL t98 = t96 - 0.5 * t69;
    const REAL t72 = k1 * t71;
    const REAL t151 = 0.5 * t71;
    const REAL t74 = k1 * platform_turn_zy; /* platform */
    const REAL t75 = t73 - t74; /* platform */
    const REAL t291 = t73 + t74; /* platform */
    const REAL t76 = limb2_U_0_sin * t75;
    const REAL t124 = minus_limb2_U_0_cos * t75;
    const REAL t78 = k1 * platform_turn_xy; /* platform */
    const REAL t79 = t77 - t78; /* platform */
    const REAL t293 = t77 + t78; /* platform */
    const REAL t81 = t76 + minus_limb2_U_0_cos * t79;
    const REAL t126 = t124 - limb2_U_0_sin * t79;
    const REAL t82 = limb2_lower_cos * t81;
    const REAL t89 = limb2_lower_sin * t81;
    const REAL t84 = k1 * platform_turn_yy; /* platform */
    const REAL t85 = t83 - t84; /* platform */
    const REAL t297 = t83 + t84; /* platform */
    const REAL t87 = t82 - limb2_lower_sin * t85;
    const REAL t91 = t89 + limb2_lower_cos * t85;
    const REAL t100 = k1 * t87;
    const REAL t93 = 0.5 * t87 + k1 * t91;
    const REAL t102 = t100 - 0.5 * t91;
    const REAL t153 = t151 - k1 * t93;
    const REAL t145 = k1 * t98;
    const REAL t105 = t72 + 0.5 * t93 - (0.5 * t98 - k1 * t102);
    const REAL t106 = 0.5 * t105;
    const REAL t147 = t145 + 0.5 * t102;
    const REAL t107 = t106 * t106;
    const REAL t110 = limb2_U_0_sin * platform_turn_zx + minus_limb2_U_0_cos * platform_turn_xx;
    const REAL t115 = limb2_lower_sin * t110;
    const REAL t113 = limb2_lower_cos * t110 - limb2_lower_sin * platform_turn_yx;
    const REAL t114 = k1 * t113;
    const REAL t133 = 0.5 * t113;
    const REAL t117 = t115 + limb2_lower_cos * platform_turn_yx;
    const REAL t135 = t133 + k1 * t117;
    const REAL t136 = 0.5 * t122;
    const REAL t129 = t114 - 0.5 * t117 - (k1 * t122 + 0.5 * t126);
    const REAL t130 = 0.5 * t129;
    const REAL t140 = 0.5 * (t135 - (t136 - k1 * t126));
    const REAL t143 = SQRT(t107 + t130 * t130 + t140 * t140);
    const REAL t144 = LESS(t143, 1.0e-08);
    const REAL t160 = SELECT(t144, 1.0, t143);
    const REAL t156 = 1.0 + (t147 + (minus_limb2_U_0_cos * platform_turn_zx - limb2_U_0_sin * platform_turn_xx + t153));
    const REAL t162 = SELECT(t144, 1.0, atan2(t143, -(0.5 * t156)) / t160);
    const REAL limb2_S_displacements_x = t106 * t162;
    WRITE(displacements, 8, limb2_S_displacements_x);
    REAL checked2 = limb2_S_displacements_x;
    const REAL limb2_S_displacements_y = t130 * t162;
    WRITE(displacements, 9, limb2_S_displacements_y);
    REAL checked3 = limb2_S_displacements_y;
    RESULT(checked0, displacements, 10, -(t140 * t162));
    const REAL t178 = 0.5 * platform_turn_yx - t62; /* platform */
    /* limb3: geometry */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    /* limb3: results; geometry */
    const REAL t197 = limb3_U_0_sin * t178;
    const REAL t179 = limb3_U_0_cos * t178;
    const REAL t181 = 0.5 * platform_turn_zx - t52; /* platform */
    const REAL t199 = t197 - limb3_U_0_cos * t181;
    const REAL t183 = t179 + limb3_U_0_sin * t181;
    const REAL limb3_lower_cos = SINES(cosine, 5), minus_limb3_lower_sin = SINES(sine, 5);
    const REAL t200 = limb3_lower_cos * t199;
    const REAL t206 = minus_limb3_lower_sin * t199;
    const REAL t202 = 0.5 * platform_turn_xx - t56; /* platform */
    const REAL t204 = t200 + minus_limb3_lower_sin * t202;
    const REAL t208 = t206 - limb3_lower_cos * t202;
    const REAL t228 = k1 * t204;
    const REAL t210 = 0.5 * t204 - k1 * t208;
    const REAL t230 = t228 + 0.5 * t208;
    const REAL t211 = k1 * t210;
    const REAL t259 = 0.5 * t210;
    const REAL t186 = k1 * platform_turn_yx + t83; /* platform */
    const REAL t212 = limb3_U_0_sin * t186;
    const REAL t187 = limb3_U_0_cos * t186;
    const REAL t189 = k1 * platform_turn_zx + t73; /* platform */
    const REAL t214 = t212 - limb3_U_0_cos * t189;
    const REAL t191 = t187 + limb3_U_0_sin * t189;
    const REAL t215 = limb3_lower_cos * t214;
    const REAL t221 = minus_limb3_lower_sin * t214;
    const REAL t217 = k1 * platform_turn_xx + t77; /* platform */
    const REAL t219 = t215 + minus_limb3_lower_sin * t217;
    const REAL t223 = t221 - limb3_lower_cos * t217;
    const REAL t232 = k1 * t219;
    const REAL t225 = 0.5 * t219 - k1 * t223;
    const REAL t234 = t232 + 0.5 * t223;
    const REAL t261 = t259 + k1 * t225;
    const REAL t253 = k1 * t230;
    const REAL t237 = t211 - 0.5 * t225 - (0.5 * t230 + k1 * t234);
    const REAL t238 = 0.5 * t237;
    const REAL t255 = t253 - 0.5 * t234;
    const REAL t239 = t238 * t238;
    const REAL t257 = limb3_U_0_sin * platform_turn_zy;
    const REAL t167 = limb3_U_0_sin * platform_turn_yy - limb3_U_0_cos * platform_turn_zy;
    const REAL t265 = 0.5 * (1.0 - (t255 + (limb3_U_0_cos * platform_turn_yy + t257 + t261)));
    const REAL t266 = -t265;
    const REAL t172 = minus_limb3_lower_sin * t167;
    const REAL t170 = limb3_lower_cos * t167 + minus_limb3_lower_sin * platform_turn_xy;
    const REAL t174 = t172 - limb3_lower_cos * platform_turn_xy;
    const REAL t176 = k1 * t170 + 0.5 * t174;
    const REAL t243 = 0.5 * t170 - k1 * t174;
    const REAL t244 = 0.5 * t183;
    const REAL t195 = 0.5 * (t176 - (k1 * t183 - 0.5 * t191));
    const REAL t248 = 0.5 * (t243 - (t244 + k1 * t191));
    const REAL t251 = SQRT(t195 * t195 + t239 + t248 * t248);
    const REAL t267 = atan2(t251, t266);
    const REAL t252 = LESS(t251, 1.0e-08);
    const REAL t270 = SELECT(t252, 1.0, t267 / SELECT(t252, 1.0, t251));
    RESULT(checked1, displacements, 14, -(t195 * t270));
    RESULT(checked2, displacements, 15, -(t238 * t270));
    RESULT(checked3, displacements, 16, -(t248 * t270));
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    /* limb4: results; geometry */
    const REAL t332 = minus_limb4_U_0_cos * t275;
    const REAL t279 = limb4_U_0_sin * t275 + minus_limb4_U_0_cos * t277;
    const REAL t334 = t332 - limb4_U_0_sin * t277;
    const REAL limb4_lower_cos = SINES(cosine, 7), minus_limb4_lower_sin = SINES(sine, 7);
    const REAL t285 = minus_limb4_lower_sin * t279;
    const REAL t283 = limb4_lower_cos * t279 + minus_limb4_lower_sin * t281;
    const REAL t287 = t285 - limb4_lower_cos * t281;
    const REAL t308 = k1 * t283;
    const REAL t289 = 0.5 * t283 + k1 * t287;
    const REAL t310 = t308 - 0.5 * t287;
    const REAL t290 = k1 * t289;
    const REAL t363 = 0.5 * t289;
    const REAL t336 = minus_limb4_U_0_cos * t291;
    const REAL t295 = limb4_U_0_sin * t291 + minus_limb4_U_0_cos * t293;
    const REAL t338 = t336 - limb4_U_0_sin * t293;
    const REAL t301 = minus_limb4_lower_sin * t295;
    const REAL t299 = limb4_lower_cos * t295 + minus_limb4_lower_sin * t297;
    const REAL t303 = t301 - limb4_lower_cos * t297;
    const REAL t312 = k1 * t299;
    const REAL t305 = 0.5 * t299 + k1 * t303;
    const REAL t314 = t312 - 0.5 * t303;
    const REAL t365 = t363 + k1 * t305;
    const REAL t357 = k1 * t310;
    const REAL t317 = t290 - 0.5 * t305 - (0.5 * t310 + k1 * t314);
    const REAL t318 = 0.5 * t317;
    const REAL t359 = t357 - 0.5 * t314;
    const REAL t319 = t318 * t318;
    const REAL t360 = minus_limb4_U_0_cos * platform_turn_zx;
    const REAL t322 = limb4_U_0_sin * platform_turn_zx + minus_limb4_U_0_cos * platform_turn_xx;
    const REAL t369 = 0.5 * (1.0 - (t359 - (t360 - limb4_U_0_sin * platform_turn_xx - t365)));
    const REAL t370 = -t369;
    const REAL t327 = minus_limb4_lower_sin * t322;
    const REAL t325 = limb4_lower_cos * t322 + minus_limb4_lower_sin * platform_turn_yx;
    const REAL t329 = t327 - limb4_lower_cos * platform_turn_yx;
    const REAL t331 = k1 * t325 - 0.5 * t329;
    const REAL t347 = 0.5 * t325 + k1 * t329;
    const REAL t348 = 0.5 * t334;
    const REAL t342 = 0.5 * (t331 + (k1 * t334 - 0.5 * t338));
    const REAL t352 = 0.5 * (t347 + (t348 + k1 * t338));
    const REAL t355 = SQRT(t319 + t342 * t342 + t352 * t352);
    const REAL t371 = atan2(t355, t370);
    const REAL t356 = LESS(t355, 1.0e-08);
    const REAL t374 = SELECT(t356, 1.0, t371 / SELECT(t356, 1.0, t355));
    RESULT(checked0, displacements, 20, t318 * t374);
    RESULT(checked1, displacements, 21, t342 * t374);
    RESULT(checked2, displacements, 22, t352 * t374);
    const REAL t376 = SELECT(LESS(limb5_S_q_qw, 0.0), (-1.0), 1.0); /* limb5_S */
    const REAL t382 = 2.0 * atan2(t378, limb5_S_q_qw * t376); /* limb5_S */
    const REAL t379 = LESS(t378, 1.0e-08); /* limb5_S */
    const REAL t386 = t376 * SELECT(t379, 2.0, t382 / SELECT(t379, 1.0, t378)); /* limb5_S */
    RESULT(checked3, displacements, 23, limb5_S_q_qx * t386);
    RESULT(checked0, displacements, 24, limb5_S_q_qy * t386);
    RESULT(checked1, displacements, 25, limb5_S_q_qz * t386);
    const REAL limb1_U_q_0 = READ(q, 0);
    WRITE(displacements, 0, limb1_U_q_0);
    checked2 = checked2 + limb1_U_q_0;
    const REAL limb1_U_q_1 = READ(q, 1);
    WRITE(displacements, 1, limb1_U_q_1);
    checked3 = checked3 + limb1_U_q_1;
    const REAL limb1_P_q = READ(q, 2);
    WRITE(displacements, 2, limb1_P_q);
    checked0 = checked0 + limb1_P_q;
    const REAL limb2_U_q_0 = READ(q, 3);
    WRITE(displacements, 5, limb2_U_q_0);
    const REAL limb2_U_q_1 = READ(q, 4);
    WRITE(displacements, 6, limb2_U_q_1);
    const REAL limb2_P_q = READ(q, 5);
    WRITE(displacements, 7, limb2_P_q);
    checked1 = checked1 + limb2_P_q;
    const REAL limb3_U_q_0 = READ(q, 6);
    WRITE(displacements, 11, limb3_U_q_0);
    const REAL limb3_U_q_1 = READ(q, 7);
    WRITE(displacements, 12, limb3_U_q_1);
    const REAL limb3_P_q = READ(q, 8);
    WRITE(displacements, 13, limb3_P_q);
    checked2 = checked2 + limb3_P_q;
    const REAL limb4_U_q_0 = READ(q, 9);
    WRITE(displacements, 17, limb4_U_q_0);
    const REAL limb4_U_q_1 = READ(q, 10);
    WRITE(displacements, 18, limb4_U_q_1);
    const REAL limb4_P_q = READ(q, 11);
    WRITE(displacements, 19, limb4_P_q);
    checked3 = checked3 + limb4_P_q;
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

int three_ups_upu_s_joint_displacements(const double *restrict q, double *restrict displacements)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_joint_displacements_body(1, q, displacements, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(displacements, 26);
    }
    return outcome;
}

int three_ups_upu_s_joint_rates(const double *restrict q, const double *restrict v, double *restrict rates)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines1(q, sine, cosine);
    const int outcome = three_ups_upu_s_joint_rates_body(1, q, v, rates, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(rates, 26);
    }
    return outcome;
}

int three_ups_upu_s_drive_rates(const double *restrict q, const double *restrict v, double *restrict rates)
{
    const int outcome = three_ups_upu_s_drive_rates_body(1, q, v, rates, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(rates, 4);
    }
    return outcome;
}

BODY(three_ups_upu_s_inverse_kinematics)(size_t stride, const double *restrict pose, double *restrict q,
    double *restrict total)
{
    /* limb5_S: geometry */
    const REAL limb5_S_pose_qw = READ(pose, 0);
    WRITE(q, 12, limb5_S_pose_qw);
    const REAL limb5_S_pose_qx = READ(pose, 1);
    WRITE(q, 13, limb5_S_pose_qx);
    const REAL t1 = limb5_S_pose_qw * limb5_S_pose_qw;
    const REAL t2 = limb5_S_pose_qx * limb5_S_pose_qx;
    const REAL limb5_S_pose_qy = READ(pose, 2);
    WRITE(q, 14, limb5_S_pose_qy);
    const REAL t3 = t1 + t2;
    const REAL t4 = limb5_S_pose_qy * limb5_S_pose_qy;
    const REAL limb5_S_pose_qz = READ(pose, 3);
    WRITE(q, 15, limb5_S_pose_qz);
    const REAL t5 = limb5_S_pose_qz * limb5_S_pose_qz;
    const REAL t6 = t4 + t5;
    const REAL t7 = t3 + t6;
    const REAL t9 = 4.0 - 2.0 * t7;
    const REAL t48 = t2 + t5;
    const REAL t25 = param_H * (1.0 - t9 * (t2 + t4));
    const REAL t31 = 0.5 * (1.0 - t6 * t9);
    const REAL platform_turn_yy = 1.0 - t9 * t48;
    const REAL t10 = limb5_S_pose_qy * t9;
    const REAL t11 = limb5_S_pose_qx * t10;
    const REAL t21 = limb5_S_pose_qw * t10;
    const REAL t12 = limb5_S_pose_qz * t9;
    const REAL t17 = limb5_S_pose_qw * (limb5_S_pose_qx * t9);
    const REAL t13 = limb5_S_pose_qw * t12;
    const REAL platform_turn_yx = t11 + t13;
    const REAL platform_turn_xy = t11 - t13;
    const REAL t14 = 0.5 * platform_turn_yx;
    const REAL t15 = limb5_S_pose_qy * t12;
    const REAL t20 = limb5_S_pose_qx * t12;
    const REAL platform_turn_yz = t15 - t17;
    const REAL platform_turn_zy = t15 + t17;
    const REAL t18 = param_H * platform_turn_yz;
    const REAL minus_limb1_lower_limb_target_x = t14 - t18;
    const REAL limb3_lower_limb_target_x = t14 + t18;
    /* limb1: geometry; results; loop closure */
    const REAL t19 = minus_limb1_lower_limb_target_x * minus_limb1_lower_limb_target_x;
    const REAL platform_turn_xz = t20 + t21;
    const REAL t22 = 0.5 * (t20 - t21); /* platform */
    const REAL t32 = param_H * platform_turn_xz; /* platform */
    const REAL minus_limb1_lower_limb_target_y = t22 - t25;
    const REAL limb3_lower_limb_target_y = t22 + t25;
    const REAL t27 = t19 + minus_limb1_lower_limb_target_y * minus_limb1_lower_limb_target_y;
    const REAL t28 = SQRT(t27);
    const REAL t29 = 1.0 / t28;
    const REAL minus_limb1_U_0_cos = minus_limb1_lower_limb_target_y * t29;
    const REAL limb1_U_0_sin = minus_limb1_lower_limb_target_x * t29;
    const REAL limb1_U_q_0 = atan2(limb1_U_0_sin, -minus_limb1_U_0_cos);
    WRITE(q, 0, limb1_U_q_0);
    REAL checked0 = limb1_U_q_0;
    const REAL t87 = platform_turn_yy * limb1_U_0_sin;
    const REAL t50 = 0.5 * platform_turn_yy; /* platform */
    const REAL t89 = t87 + platform_turn_zy * minus_limb1_U_0_cos;
    const REAL t43 = 0.5 * platform_turn_zy; /* platform */
    const REAL limb1_lower_limb_target_z = param_R - (t31 - t32);
    const REAL minus_limb3_lower_limb_target_z = param_R - (t31 + t32);
    const REAL limb1_lower_limb_length = SQRT(t27 + limb1_lower_limb_target_z * limb1_lower_limb_target_z);
    const REAL limb1_P_q = limb1_lower_limb_length - limb_upper_phase;
    WRITE(q, 2, limb1_P_q);
    REAL checked1 = limb1_P_q;
    const REAL t35 = 1.0 / limb1_lower_limb_length;
    const REAL limb1_lower_sin = limb1_lower_limb_target_z * t35;
    const REAL limb1_lower_cos = t28 * t35;
    const REAL t90 = limb1_lower_sin * t89;
    const REAL t38 = k1 * limb1_lower_sin - 0.5 * limb1_lower_cos;
    const REAL limb1_U_q_1 = atan2(t38, k1 * limb1_lower_cos + 0.5 * limb1_lower_sin);
    WRITE(q, 1, limb1_U_q_1);
    REAL checked2 = limb1_U_q_1;
    const REAL limb1_U2_opening_mn = t90 + platform_turn_xy * limb1_lower_cos;
    const REAL t92 = limb1_U2_opening_mn * limb1_U2_opening_mn;
    const REAL t42 = 0.5 * platform_turn_xy; /* platform */
    /* limb2: geometry; reciprocal wrenches, eq. (10); results */
    const REAL limb2_lower_limb_target_x = t25 - t43;
    const REAL limb4_lower_limb_target_x = t25 + t43;
    const REAL t44 = limb2_lower_limb_target_x * limb2_lower_limb_target_x;
    const REAL limb2_lower_limb_target_y = t32 - t42;
    const REAL limb4_lower_limb_target_y = t32 + t42;
    const REAL t46 = t44 + limb2_lower_limb_target_y * limb2_lower_limb_target_y;
    const REAL limb2_U_0_lever_moment_z_by_limb2_S_fz = SQRT(t46);
    const REAL t47 = 1.0 / limb2_U_0_lever_moment_z_by_limb2_S_fz;
    const REAL limb2_U_q_0 = atan2(limb2_lower_limb_target_y * t47, limb2_lower_limb_target_x * t47);
    WRITE(q, 3, limb2_U_q_0);
    REAL checked3 = limb2_U_q_0;
    const REAL limb4_upper_position_y = t18 + t50;
    const REAL limb2_lower_limb_target_z = param_R + (t18 - t50);
    const REAL minus_limb4_lower_limb_target_z = param_R - limb4_upper_position_y;
    const REAL limb2_lower_limb_length = SQRT(t46 + limb2_lower_limb_target_z * limb2_lower_limb_target_z);
    RESULT(checked0, q, 5, limb2_lower_limb_length - limb_upper_phase);
    const REAL t53 = 1.0 / limb2_lower_limb_length;
    const REAL minus_limb2_lower_cos = limb2_U_0_lever_moment_z_by_limb2_S_fz * t53;
    const REAL limb2_lower_sin = limb2_lower_limb_target_z * t53;
    const REAL t56 = 0.5 * minus_limb2_lower_cos - k1 * limb2_lower_sin;
    RESULT(checked1, q, 4, atan2(t56, k1 * minus_limb2_lower_cos + 0.5 * limb2_lower_sin));
    /* limb3: reciprocal wrenches, eq. (10); geometry; results */
    const REAL t60 = limb3_lower_limb_target_x * limb3_lower_limb_target_x;
    const REAL t62 = t60 + limb3_lower_limb_target_y * limb3_lower_limb_target_y;
    const REAL t63 = SQRT(t62);
    const REAL t64 = 1.0 / t63;
    RESULT(checked2, q, 6, atan2(-(limb3_lower_limb_target_x * t64), limb3_lower_limb_target_y * t64));
    const REAL limb3_lower_limb_length = SQRT(t62 + minus_limb3_lower_limb_target_z * minus_limb3_lower_limb_target_z);
    RESULT(checked3, q, 8, limb3_lower_limb_length - limb_upper_phase);
    const REAL t67 = 1.0 / limb3_lower_limb_length;
    const REAL limb3_lower_cos = t63 * t67;
    const REAL minus_limb3_lower_sin = minus_limb3_lower_limb_target_z * t67;
    const REAL t70 = 0.5 * limb3_lower_cos - k1 * minus_limb3_lower_sin;
    RESULT(checked0, q, 7, atan2(t70, k1 * limb3_lower_cos + 0.5 * minus_limb3_lower_sin));
    /* limb4: reciprocal wrenches, eq. (10); geometry; results */
    const REAL t74 = limb4_lower_limb_target_x * limb4_lower_limb_target_x;
    const REAL t76 = t74 + limb4_lower_limb_target_y * limb4_lower_limb_target_y;
    const REAL limb4_U_0_lever_moment_z_by_limb4_S_fz = SQRT(t76);
    const REAL t77 = 1.0 / limb4_U_0_lever_moment_z_by_limb4_S_fz;
    RESULT(checked1, q, 9, atan2(limb4_lower_limb_target_y * t77, limb4_lower_limb_target_x * t77));
    const REAL limb4_lower_limb_length = SQRT(t76 + minus_limb4_lower_limb_target_z * minus_limb4_lower_limb_target_z);
    RESULT(checked2, q, 11, limb4_lower_limb_length - limb_upper_phase);
    const REAL t80 = 1.0 / limb4_lower_limb_length;
    const REAL minus_limb4_lower_sin = minus_limb4_lower_limb_target_z * t80;
    const REAL minus_limb4_lower_cos = limb4_U_0_lever_moment_z_by_limb4_S_fz * t80;
    const REAL t83 = k1 * minus_limb4_lower_sin - 0.5 * minus_limb4_lower_cos;
    RESULT(checked3, q, 10, atan2(t83, k1 * minus_limb4_lower_cos + 0.5 * minus_limb4_lower_sin));
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    NOT_ABOVE(t92, 1.0e-12, 6);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_inverse_kinematics_packed_lane(const double *restrict pose,
    double *restrict q)
{
    const double x0 = pose[0], x1 = pose[1], x2 = pose[2], x3 = pose[3];
    q[12] = x0;
    q[13] = x1;
    q[14] = x2;
    q[15] = x3;
    const double x4 = x0 * x0;
    const double x5 = x1 * x1;
    const double x6 = x4 + x5;
    const double x7 = x2 * x2;
    const double x8 = x3 * x3;
    const double x9 = x7 + x8;
    const double x10 = x6 + x9;
    const double x11 = 2.0 * x10;
    const double x12 = 4.0 - x11;
    const double x30 = x5 + x7;
    const double x78 = x5 + x8;
    const double x31 = x12 * x30;
    const double x32 = 1.0 - x31;
    const double x33 = 0.5196152422706631 * x32;
    const double x43 = x9 * x12;
    const double x44 = 1.0 - x43;
    const double x45 = 0.5 * x44;
    const double x79 = x12 * x78;
    const double x80 = 1.0 - x79;
    const double x13 = x2 * x12;
    const double x14 = x1 * x13;
    const double x27 = x0 * x13;
    const double x15 = x3 * x12;
    const double x20 = x1 * x12;
    const double x21 = x0 * x20;
    const double x16 = x0 * x15;
    const double x17 = x14 + x16;
    const double x64 = x14 - x16;
    const double x18 = 0.5 * x17;
    const double x19 = x2 * x15;
    const double x26 = x1 * x15;
    const double x22 = x19 - x21;
    const double x67 = x19 + x21;
    const double x23 = 0.5196152422706631 * x22;
    const double x68 = 0.5 * x67;
    const three_ups_upu_s_vector4 xgathered0 = {x18, x33, x18, x33};
    const three_ups_upu_s_vector4 xgathered1 = {x23, x68, x23, x68};
    const three_ups_upu_s_vector4 xpack0 = xgathered0 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xgathered1;
    const three_ups_upu_s_vector4 xpack1 = xpack0 * xpack0;
    const double x28 = x26 - x27;
    const double x46 = x26 + x27;
    const double x29 = 0.5 * x28;
    const double x47 = 0.5196152422706631 * x46;
    const double x65 = 0.5 * x64;
    const three_ups_upu_s_vector4 xgathered2 = {x29, x47, x29, x47};
    const three_ups_upu_s_vector4 xgathered3 = {x33, x65, x33, x65};
    const three_ups_upu_s_vector4 xpack2 = xgathered2 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xgathered3;
    const three_ups_upu_s_vector4 xpack3 = xpack2 * xpack2;
    const three_ups_upu_s_vector4 xpack4 = xpack1 + xpack3;
    const three_ups_upu_s_vector4 xpack5 = three_ups_upu_s_vector4_sqrt(xpack4);
    const three_ups_upu_s_vector4 xpack6 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack5;
    const three_ups_upu_s_vector4 xpack7 = xpack0 * xpack6;
    const three_ups_upu_s_vector4 xpack8 = xpack2 * xpack6;
    const double x39 = xpack7[0], x40 = xpack8[0];
    const double x41 = -x40;
    const double x42 = atan2(x39, x41);
    q[0] = x42;
    const double x75 = xpack8[1], x76 = xpack7[1];
    const double x77 = atan2(x75, x76);
    q[3] = x77;
    const double x105 = xpack7[2];
    const double x106 = -x105;
    const double x107 = xpack8[2];
    const double x108 = atan2(x106, x107);
    q[6] = x108;
    const double x132 = xpack8[3], x133 = xpack7[3];
    const double x134 = atan2(x132, x133);
    q[9] = x134;
    const double x152 = x67 * x40;
    const double x151 = x80 * x39;
    const double x153 = x151 + x152;
    const double x81 = 0.5 * x80;
    const three_ups_upu_s_vector4 xgathered4 = {x45, x23, x45, x23};
    const three_ups_upu_s_vector4 xgathered5 = {x47, x81, x47, x81};
    const three_ups_upu_s_vector4 xpack9 = xgathered4 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xgathered5;
    const three_ups_upu_s_vector4 xpack10 = xpack9 + (three_ups_upu_s_vector4){(-0.8), 0.8, (-0.8), (-0.8)};
    const three_ups_upu_s_vector4 xpack11 = xpack10 * xpack10;
    const three_ups_upu_s_vector4 xpack12 = xpack4 + xpack11;
    const three_ups_upu_s_vector4 xpack13 = three_ups_upu_s_vector4_sqrt(xpack12);
    const three_ups_upu_s_vector4 xpack23 = xpack13 + (three_ups_upu_s_vector4){(-0.3), (-0.3), (-0.3),
        (-0.3)};
    const double x63 = xpack23[0];
    q[2] = x63;
    const double x97 = xpack23[1];
    q[5] = x97;
    const double x124 = xpack23[2];
    q[8] = x124;
    const double x150 = xpack23[3];
    q[11] = x150;
    const three_ups_upu_s_vector4 xpack14 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack13;
    const three_ups_upu_s_vector4 xpack15 = xpack10 * xpack14;
    const three_ups_upu_s_vector4 xpack17 = xpack5 * xpack14;
    const double x54 = -xpack15[0];
    const double x154 = x54 * x153;
    const double x56 = xpack17[0];
    const double x155 = x64 * x56;
    const double x156 = x154 + x155;
    const double x157 = x156 * x156;
    const three_ups_upu_s_vector4 xpack16 = (three_ups_upu_s_vector4){(-0.8660254037844386),
        0.8660254037844386, (-0.8660254037844386), (-0.8660254037844386)} * xpack15;
    const three_ups_upu_s_vector4 xpack21 = (three_ups_upu_s_vector4){(-0.5), 0.5, (-0.5), (-0.5)} * xpack15;
    const three_ups_upu_s_vector4 xpack18 = (three_ups_upu_s_vector4){0.5, 0.5, 0.5, 0.5} * xpack17;
    const three_ups_upu_s_vector4 xpack19 = xpack18 - xpack16;
    const three_ups_upu_s_vector4 xpack20 = (three_ups_upu_s_vector4){0.8660254037844386, 0.8660254037844386,
        0.8660254037844386, 0.8660254037844386} * xpack17;
    const three_ups_upu_s_vector4 xpack22 = xpack21 + xpack20;
    const double x58 = -xpack19[0], x61 = xpack22[0];
    const double x62 = atan2(x58, x61);
    q[1] = x62;
    const double x92 = xpack19[1], x95 = xpack22[1];
    const double x96 = atan2(x92, x95);
    q[4] = x96;
    const double x119 = xpack19[2], x122 = xpack22[2];
    const double x123 = atan2(x119, x122);
    q[7] = x123;
    const double x145 = -xpack19[3], x148 = xpack22[3];
    const double x149 = atan2(x145, x148);
    q[10] = x149;
    const three_ups_upu_s_vector4 every = xpack23;
    return !(x10 >= 0.999999 && x10 <= 1.000001) || !(x157 <= 1.0e-12) ? (double)NAN : (((x42 + x62) + (x77 +
        x96)) + ((x108 + x123) + (x134 + x149))) + ((every[0] + every[1]) + (every[2] + every[3]));
}
#endif

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_inverse_kinematics_limb_by_limb(const double *restrict pose, double *restrict q)
{
    const int outcome = three_ups_upu_s_inverse_kinematics_body(1, pose, q, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(q, 16);
    }
    return outcome;
}

int three_ups_upu_s_inverse_kinematics(const double *restrict pose, double *restrict q)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    if (isfinite(three_ups_upu_s_inverse_kinematics_packed_lane(pose, q))) {
        return 0;
    }
#endif
    return three_ups_upu_s_inverse_kinematics_limb_by_limb(pose, q);
}

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
static inline THREE_UPS_UPU_S_INLINE double three_ups_upu_s_inverse_velocity_packed_lane(const double *restrict pose,
    const double *restrict rate, double *restrict v)
{
    const double x0 = pose[0], x1 = pose[1], x2 = pose[2], x3 = pose[3], x4 = rate[0], x5 = rate[1], x6 =
        rate[2];
    v[12] = x4;
    v[13] = x5;
    v[14] = x6;
    const double x7 = x0 * x0;
    const double x8 = x1 * x1;
    const double x9 = x7 + x8;
    const double x10 = x2 * x2;
    const double x11 = x3 * x3;
    const double x12 = x10 + x11;
    const double x13 = x9 + x12;
    const double x14 = 2.0 * x13;
    const double x15 = 4.0 - x14;
    const double x33 = x8 + x10;
    const double x66 = x8 + x11;
    const double x34 = x15 * x33;
    const double x35 = 1.0 - x34;
    const double x42 = x12 * x15;
    const double x43 = 1.0 - x42;
    const double x67 = x15 * x66;
    const double x68 = 1.0 - x67;
    const double x16 = x2 * x15;
    const double x17 = x1 * x16;
    const double x30 = x0 * x16;
    const double x18 = x3 * x15;
    const double x23 = x1 * x15;
    const double x24 = x0 * x23;
    const double x19 = x0 * x18;
    const double x20 = x17 + x19;
    const double x56 = x17 - x19;
    const double x21 = 0.5 * x20;
    const double x70 = x4 * x20;
    const double x22 = x2 * x18;
    const double x29 = x1 * x18;
    const double x25 = x22 - x24;
    const double x50 = x22 + x24;
    const double x26 = 0.5196152422706631 * x25;
    const double x72 = x6 * x25;
    const double x102 = 0.5 * x50;
    const double x36 = 0.5196152422706631 * x35;
    const three_ups_upu_s_vector4 xgathered0 = {x21, x36, x21, x36};
    const three_ups_upu_s_vector4 xgathered1 = {x26, x102, x26, x102};
    const three_ups_upu_s_vector4 xpack0 = xgathered0 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xgathered1;
    const double x48 = x6 * x35;
    const three_ups_upu_s_vector4 xpack1 = xpack0 * xpack0;
    const double x31 = x29 - x30;
    const double x45 = x29 + x30;
    const double x32 = 0.5 * x31;
    const double x49 = x4 * x31;
    const double x46 = 0.5196152422706631 * x45;
    const double x59 = x6 * x45;
    const double x105 = 0.5 * x56;
    const three_ups_upu_s_vector4 xgathered2 = {x32, x46, x32, x46};
    const three_ups_upu_s_vector4 xgathered3 = {x36, x105, x36, x105};
    const three_ups_upu_s_vector4 xpack2 = xgathered2 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xgathered3;
    const three_ups_upu_s_vector4 xpack3 = xpack2 * xpack2;
    const three_ups_upu_s_vector4 xpack4 = xpack1 + xpack3;
    const three_ups_upu_s_vector4 xpack5 = three_ups_upu_s_vector4_sqrt(xpack4);
    const three_ups_upu_s_vector4 xpack6 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack5;
    const three_ups_upu_s_vector4 xpack11 = xpack2 * xpack6;
    const double x51 = x5 * x50;
    const double x52 = x49 + x51;
    const double x53 = x48 + x52;
    const double x63 = xpack11[0];
    const double x230 = x50 * x63;
    const double x57 = x5 * x56;
    const double x55 = x4 * x43;
    const double x58 = x55 + x57;
    const double x60 = x58 + x59;
    const double x44 = 0.5 * x43;
    const double x111 = 0.5 * x68;
    const three_ups_upu_s_vector4 xgathered4 = {x44, x26, x44, x26};
    const three_ups_upu_s_vector4 xgathered5 = {x46, x111, x46, x111};
    const three_ups_upu_s_vector4 xpack7 = xgathered4 + (three_ups_upu_s_vector4){(-1.0), (-1.0), 1.0, 1.0} *
        xgathered5;
    const three_ups_upu_s_vector4 xgathered6 = {x53, x60, x53, x60};
    const three_ups_upu_s_vector4 xpack8 = xpack7 * xgathered6;
    const double x69 = x5 * x68;
    const double x71 = x69 + x70;
    const double x73 = x71 + x72;
    const three_ups_upu_s_vector4 xgathered7 = {x60, x73, x60, x73};
    const three_ups_upu_s_vector4 xpack9 = xpack2 * xgathered7;
    const three_ups_upu_s_vector4 xpack10 = xpack8 - xpack9;
    const three_ups_upu_s_vector4 xgathered8 = {x73, x53, x73, x53};
    const three_ups_upu_s_vector4 xpack30 = xpack2 * xgathered8;
    const three_ups_upu_s_vector4 xpack12 = xpack10 * xpack11;
    const three_ups_upu_s_vector4 xpack16 = xpack0 * xpack6;
    const three_ups_upu_s_vector4 xpack26 = xpack10 * xpack16;
    const double x76 = xpack16[0];
    const double x229 = x68 * x76;
    const double x231 = x229 + x230;
    const three_ups_upu_s_vector4 xpack13 = xpack0 * xgathered7;
    const three_ups_upu_s_vector4 xpack31 = xpack0 * xgathered6;
    const three_ups_upu_s_vector4 xpack14 = xpack7 * xgathered8;
    const three_ups_upu_s_vector4 xpack15 = xpack13 - xpack14;
    const three_ups_upu_s_vector4 xpack32 = xpack30 - xpack31;
    const three_ups_upu_s_vector4 xpack17 = xpack15 * xpack16;
    const three_ups_upu_s_vector4 xpack18 = xpack12 - xpack17;
    const three_ups_upu_s_vector4 xpack19 = xpack6 * xpack18;
    const double x79 = xpack19[0];
    const double x80 = -x79;
    v[0] = x80;
    const double x124 = xpack19[1];
    const double x125 = -x124;
    v[3] = x125;
    const double x165 = xpack19[2];
    const double x166 = -x165;
    v[6] = x166;
    const double x206 = xpack19[3];
    const double x207 = -x206;
    v[9] = x207;
    const three_ups_upu_s_vector4 xpack27 = xpack15 * xpack11;
    const three_ups_upu_s_vector4 xpack28 = xpack26 + xpack27;
    const three_ups_upu_s_vector4 xpack20 = xpack7 + (three_ups_upu_s_vector4){(-0.8), 0.8, (-0.8), (-0.8)};
    const three_ups_upu_s_vector4 xpack21 = xpack20 * xpack20;
    const three_ups_upu_s_vector4 xpack22 = xpack4 + xpack21;
    const three_ups_upu_s_vector4 xpack23 = three_ups_upu_s_vector4_sqrt(xpack22);
    const three_ups_upu_s_vector4 xpack24 = (three_ups_upu_s_vector4){1.0, 1.0, 1.0, 1.0} / xpack23;
    const three_ups_upu_s_vector4 xpack25 = xpack20 * xpack24;
    const three_ups_upu_s_vector4 xpack33 = xpack5 * xpack24;
    const double x86 = -xpack25[0];
    const double x232 = x86 * x231;
    const double x94 = xpack33[0];
    const double x233 = x56 * x94;
    const double x234 = x232 + x233;
    const double x235 = x234 * x234;
    const three_ups_upu_s_vector4 xpack29 = xpack25 * xpack28;
    const three_ups_upu_s_vector4 xpack37 = xpack33 * xpack28;
    const three_ups_upu_s_vector4 xpack34 = xpack32 * xpack33;
    const three_ups_upu_s_vector4 xpack35 = xpack29 - xpack34;
    const three_ups_upu_s_vector4 xpack36 = xpack24 * xpack35;
    const double x97 = -xpack36[0];
    const double x98 = -x97;
    v[1] = x98;
    const double x142 = xpack36[1];
    v[4] = x142;
    const double x183 = -xpack36[2];
    v[7] = x183;
    const double x224 = -xpack36[3];
    const double x225 = -x224;
    v[10] = x225;
    const three_ups_upu_s_vector4 xpack38 = xpack32 * xpack25;
    const three_ups_upu_s_vector4 xpack39 = xpack37 + xpack38;
    const double x101 = xpack39[0];
    v[2] = x101;
    const double x145 = xpack39[1];
    v[5] = x145;
    const double x186 = xpack39[2];
    v[8] = x186;
    const double x228 = xpack39[3];
    v[11] = x228;
    const three_ups_upu_s_vector4 every = (three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)((xpack19 +
        xpack23) + (xpack36 + xpack39)) | ((xpack5 <= (three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10}) & (xpack5 >= -(three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10})) | ((xpack23 <= (three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10}) & (xpack23 >= -(three_ups_upu_s_vector4){6.62327e-10, 6.62327e-10,
        6.62327e-10, 6.62327e-10})));
    return !(x13 >= 0.999999 && x13 <= 1.000001) || !(x235 <= 1.0e-12) ? (double)NAN : (every[0] + every[1]) +
        (every[2] + every[3]);
}
#endif

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
__attribute__((noinline))
#endif
static int three_ups_upu_s_inverse_velocity_limb_by_limb(const double *restrict pose, const double *restrict rate,
    double *restrict v)
{
    const int outcome = three_ups_upu_s_inverse_velocity_body(1, pose, rate, v, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(v, 15);
    }
    return outcome;
}

int three_ups_upu_s_inverse_velocity(const double *restrict pose, const double *restrict rate,
    double *restrict v)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
    if (isfinite(three_ups_upu_s_inverse_velocity_packed_lane(pose, rate, v))) {
        return 0;
    }
#endif
    return three_ups_upu_s_inverse_velocity_limb_by_limb(pose, rate, v);
}
#endif /* THREE_UPS_UPU_S_VECTORS */
