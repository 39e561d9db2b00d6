/*
 * three_ups_upu_s: kinematics.
 *   body_poses; body_twists; body_twist_rates; forward_kinematics; point_motion; joint_screws;
 *   joint_points; platform_jacobian; joint_displacements; joint_rates; drive_rates;
 *   inverse_kinematics; drive_positions; inverse_velocity
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 checked;
} LIMBS(body_poses);

STAGE(body_poses, 0)(size_t limb, size_t stride, const double *restrict q, double *restrict poses,
    const double *restrict sine, const double *restrict cosine, LIMBS(body_poses) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), each_k1 = sign1 * k1, each_k1_2 = -sign1 * k1,
      factor_2 = sign1 * 0.5, sign2 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = sign2 * param_R,
      each_param_R_2 = -sign2 * param_R, each_param_R_3 = -sign1 * param_R, factor_3 = -sign1 * 0.5,
      each_param_H = -sign1 * param_H, sign3 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2), t26 = sign1 * lower_cos,
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: geometry */
    const LIMB4 lower_rotation_zx = U_0_cos * t26, signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      signed_lower_rotation_yx = signed_U_0_sin * t26, signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: results; geometry */
    const LIMB4 t5 = 0.5 * lower_rotation_zx, t27 = sign1 * signed_lower_sin,
      signed_lower_rotation_zy = U_0_cos * t27, signed_lower_poses_Rzx = t5 - each_k1 * signed_lower_rotation_zy;
    WRITE4(poses, 14, 41, 62, 89, sign2 * signed_lower_poses_Rzx);
    WRITE4(poses, 26, 53, 74, 101, sign2 * signed_lower_poses_Rzx);
    const LIMB4 t13 = factor_2 * signed_lower_rotation_zy, lower_poses_z = param_R * signed_lower_poses_Rzx;
    WRITE4(poses, 23, 47, 71, 95, lower_poses_z);
    LIMB4 checked = lower_poses_z;
    const LIMB4 t23 = 0.5 * signed_lower_poses_Rzx, lower_poses_Rzz = k1 * lower_rotation_zx + t13;
    WRITE4(poses, 20, 44, 68, 92, lower_poses_Rzz);
    WRITE4(poses, 32, 56, 80, 104, lower_poses_Rzz);
    const LIMB4 t25 = t23 - param_H * lower_poses_Rzz, upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      upper_poses_z = upper_offset_x * lower_rotation_zx + t25;
    WRITE4(poses, 35, 59, 83, 107, upper_poses_z);
    checked = checked + upper_poses_z;
    const LIMB4 t3 = 0.5 * signed_lower_rotation_yx, signed_lower_rotation_yy = signed_U_0_sin * t27,
      t9 = (-k1) * signed_lower_rotation_yx, t29 = sign1 * (upper_offset_x * signed_lower_rotation_yx),
      signed_upper_position_x = t27 * upper_offset_x + each_param_R_3,
      signed_lower_poses_Ryx = t3 - each_k1 * signed_lower_rotation_yy;
    WRITE4(poses, 13, 39, 61, 87, -sign3 * signed_lower_poses_Ryx);
    WRITE4(poses, 25, 51, 73, 99, -sign3 * signed_lower_poses_Ryx);
    const LIMB4 t11 = t9 - factor_2 * signed_lower_rotation_yy;
    WRITE4(poses, 19, 42, 67, 90, sign1 * t11);
    WRITE4(poses, 31, 54, 79, 102, sign1 * t11);
    const LIMB4 t20 = each_param_H * t11, t15 = each_param_R_3 * signed_lower_poses_Ryx;
    WRITE4(poses, 22, 45, 70, 93, t15);
    checked = checked + t15;
    const LIMB4 t22 = t20 - sign1 * (0.5 * signed_lower_poses_Ryx) - t29;
    WRITE4(poses, 34, 57, 82, 105, t22);
    checked = checked + t22;
    const LIMB4 lower_poses_Rxx = 0.5 * signed_lower_sin + each_k1 * lower_cos;
    WRITE4(poses, 12, 40, 60, 88, lower_poses_Rxx);
    WRITE4(poses, 24, 52, 72, 100, lower_poses_Rxx);
    const LIMB4 t16 = factor_3 * lower_poses_Rxx, lower_poses_x = each_param_R * lower_poses_Rxx + each_param_R_2;
    WRITE4(poses, 21, 46, 69, 94, lower_poses_x);
    checked = checked + lower_poses_x;
    const LIMB4 signed_lower_poses_Rxz = each_k1_2 * signed_lower_sin + 0.5 * lower_cos;
    WRITE4(poses, 18, 43, 66, 91, -sign3 * signed_lower_poses_Rxz);
    WRITE4(poses, 30, 55, 78, 103, -sign3 * signed_lower_poses_Rxz);
    const LIMB4 signed_upper_poses_x = t16 - param_H * signed_lower_poses_Rxz - signed_upper_position_x;
    WRITE4(poses, 33, 58, 81, 106, -sign3 * signed_upper_poses_x);
    checked = checked + signed_upper_poses_x;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_body_poses)(size_t stride, const double *restrict q, double *restrict poses,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(body_poses) limbs;
    /* limb4: geometry */
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), minus_limb4_U_0_cos_2 = -minus_limb4_U_0_cos;
    WRITE(poses, 86, minus_limb4_U_0_cos_2);
    WRITE(poses, 98, minus_limb4_U_0_cos_2);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), minus_limb2_U_0_cos_2 = -minus_limb2_U_0_cos;
    WRITE(poses, 38, minus_limb2_U_0_cos_2);
    WRITE(poses, 50, minus_limb2_U_0_cos_2);
    FIRST_LIMB(3, body_poses, 0, stride, q, poses, sine, cosine, &limbs);
    REAL checked0 = ALONE(limbs.checked[3]);
    NEXT_LIMB(2, body_poses, 0, stride, q, poses, sine, cosine, &limbs);
    REAL checked1 = ALONE(limbs.checked[2]);
    NEXT_LIMB(1, body_poses, 0, stride, q, poses, sine, cosine, &limbs);
    REAL checked2 = ALONE(limbs.checked[1]);
    NEXT_LIMB(0, body_poses, 0, stride, q, poses, sine, cosine, &limbs);
    REAL checked3 = ALONE(limbs.checked[0]);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t4 = limb5_S_q_qw * limb5_S_q_qw,
      t5 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t6 = t4 + t5, t1 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t2 = limb5_S_q_qz * limb5_S_q_qz, t3 = t1 + t2, t7 = t6 + t3, t9 = 4.0 - 2.0 * t7,
      t17 = t5 + t2;
    RESULT(checked0, poses, 8, 1.0 - t9 * (t5 + t1));
    RESULT(checked1, poses, 4, 1.0 - t9 * t17);
    RESULT(checked2, poses, 0, 1.0 - t3 * t9);
    const REAL t13 = limb5_S_q_qz * t9, t19 = limb5_S_q_qy * t13, t21 = limb5_S_q_qw * (limb5_S_q_qx * t9);
    RESULT(checked3, poses, 7, t19 - t21);
    RESULT(checked0, poses, 5, t19 + t21);
    const REAL t11 = limb5_S_q_qy * t9, t15 = limb5_S_q_qx * t13, t14 = limb5_S_q_qw * t13, t16 = limb5_S_q_qw * t11;
    RESULT(checked1, poses, 6, t15 + t16);
    RESULT(checked2, poses, 2, t15 - t16);
    const REAL t12 = limb5_S_q_qx * t11;
    RESULT(checked3, poses, 3, t12 - t14);
    RESULT(checked0, poses, 1, t12 + t14);
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    WRITE(poses, 16, limb1_U_0_cos);
    WRITE(poses, 28, limb1_U_0_cos);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    WRITE(poses, 17, limb1_U_0_sin);
    WRITE(poses, 29, limb1_U_0_sin);
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    WRITE(poses, 36, limb2_U_0_sin);
    WRITE(poses, 48, limb2_U_0_sin);
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    WRITE(poses, 64, limb3_U_0_cos);
    WRITE(poses, 76, limb3_U_0_cos);
    const REAL limb3_U_0_sin = SINES(sine, 4);
    WRITE(poses, 65, limb3_U_0_sin);
    WRITE(poses, 77, limb3_U_0_sin);
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    WRITE(poses, 84, limb4_U_0_sin);
    WRITE(poses, 96, limb4_U_0_sin);
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
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 checked;
} LIMBS(body_twists);

STAGE(body_twists, 0)(size_t limb, size_t stride, const double *restrict v, double *restrict twists,
    const double *restrict sine, const double *restrict cosine, REAL signed_U_1_screw_vy,
    REAL signed_U_1_screw_vz, LIMBS(body_twists) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 P_v = IN_EACH4(READ, v, 2, 3);
    /* each limb: velocities, eq. (6) */
    const LIMB4 signed_upper_twist_vx = P_v * IN_EACH4(SINES, sine, 1, 2);
    WRITE4(twists, 15, 28, 39, 52, sign1 * signed_upper_twist_vx);
    LIMB4 checked = signed_upper_twist_vx;
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t2 = P_v * (U_0_cos * lower_cos), t3 = sign1 * IN_EACH4(READ, v, 1, 3),
      signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), signed_lower_twist_wz = t3 * signed_U_0_sin;
    WRITE4(twists, 8, 20, 32, 44, sign2 * signed_lower_twist_wz);
    WRITE4(twists, 14, 26, 38, 50, sign2 * signed_lower_twist_wz);
    checked = checked + signed_lower_twist_wz;
    const LIMB4 signed_lower_twist_wy = t3 * U_0_cos;
    WRITE4(twists, 7, 18, 31, 42, sign1 * signed_lower_twist_wy);
    WRITE4(twists, 13, 24, 37, 48, sign1 * signed_lower_twist_wy);
    checked = checked + signed_lower_twist_wy;
    const LIMB4 signed_lower_twist_vz = t3 * signed_U_1_screw_vz;
    WRITE4(twists, 11, 23, 35, 47, -sign3 * signed_lower_twist_vz);
    const LIMB4 signed_upper_twist_vz = t2 - signed_lower_twist_vz;
    WRITE4(twists, 17, 29, 41, 53, sign3 * signed_upper_twist_vz);
    checked = checked + signed_upper_twist_vz;
    const LIMB4 lower_twist_vy = t3 * signed_U_1_screw_vy;
    WRITE4(twists, 10, 21, 34, 45, lower_twist_vy);
    const LIMB4 upper_twist_vy = lower_twist_vy - P_v * (signed_U_0_sin * lower_cos);
    WRITE4(twists, 16, 27, 40, 51, upper_twist_vy);
    checked = checked + upper_twist_vy;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_body_twists)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict twists, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    LIMBS(body_twists) limbs;
    REAL checked0 = READ(q, 2);
    REAL checked1 = READ(q, 5);
    REAL checked2 = READ(q, 8);
    REAL checked3 = READ(q, 11);
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t4 = limb5_S_q_qw * limb5_S_q_qw,
      t5 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t6 = t4 + t5, t1 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t2 = limb5_S_q_qz * limb5_S_q_qz, t3 = t1 + t2, t7 = t6 + t3, t9 = 4.0 - 2.0 * t7,
      limb5_S_v_wx = READ(v, 12), limb5_S_v_wy = READ(v, 13), limb5_S_v_wz = READ(v, 14),
      t11 = limb5_S_v_wx * (1.0 - t3 * t9), t23 = limb5_S_v_wy * (1.0 - t9 * (t5 + t2)),
      t32 = limb5_S_v_wz * (1.0 - t9 * (t5 + t1)), t12 = limb5_S_q_qy * t9, t13 = limb5_S_q_qx * t12,
      t19 = limb5_S_q_qw * t12, t14 = limb5_S_q_qz * t9, t28 = limb5_S_q_qw * (limb5_S_q_qx * t9),
      t15 = limb5_S_q_qw * t14, t17 = t11 + limb5_S_v_wy * (t13 - t15), t25 = t23 + limb5_S_v_wx * (t13 + t15),
      t18 = limb5_S_q_qx * t14, t26 = limb5_S_q_qy * t14, platform_turn_zx = t18 - t19;
    RESULT(checked0, twists, 0, t17 + limb5_S_v_wz * (t18 + t19));
    const REAL t33 = limb5_S_v_wx * platform_turn_zx, platform_turn_zy = t26 + t28;
    RESULT(checked1, twists, 1, t25 + limb5_S_v_wz * (t26 - t28));
    RESULT(checked2, twists, 2, t32 + (t33 + limb5_S_v_wy * platform_turn_zy));
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0);
    FIRST_LIMB(0, body_twists, 0, stride, v, twists, sine, cosine, param_R * limb1_U_0_sin, param_R * limb1_U_0_cos, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[0]);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2);
    NEXT_LIMB(1, body_twists, 0, stride, v, twists, sine, cosine, param_R * minus_limb2_U_0_cos, param_R * limb2_U_0_sin, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[1]);
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    NEXT_LIMB(2, body_twists, 0, stride, v, twists, sine, cosine, param_R * limb3_U_0_sin, param_R * limb3_U_0_cos, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[2]);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6);
    NEXT_LIMB(3, body_twists, 0, stride, v, twists, sine, cosine, param_R * minus_limb4_U_0_cos, param_R * limb4_U_0_sin, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[3]);
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
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 checked;
} LIMBS(body_twist_rates);

STAGE(body_twist_rates, 0)(size_t limb, size_t stride, const double *restrict v, const double *restrict a,
    double *restrict twist_rates, const double *restrict sine, const double *restrict cosine,
    REAL signed_U_1_screw_vy, REAL signed_U_1_screw_vz, LIMBS(body_twist_rates) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, 1.0),
      sign3 = OF4(1.0, -1.0, 1.0, -1.0);
    const LIMB4 U_v_0 = IN_EACH4(READ, v, 0, 3), U_v_1 = IN_EACH4(READ, v, 1, 3), U_a_1 = IN_EACH4(READ, a, 1, 3);
    /* each limb: accelerations; geometry; velocities, eq. (6) */
    const LIMB4 signed_lower_twist_rate_vz = U_a_1 * signed_U_1_screw_vz - U_v_1 * (U_v_0 * signed_U_1_screw_vy);
    WRITE4(twist_rates, 11, 23, 35, 47, -sign2 * signed_lower_twist_rate_vz);
    const LIMB4 U_0_cos = IN_EACH4(SINES, cosine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t33 = sign1 * signed_lower_twist_rate_vz, signed_lower_rotation_zx = U_0_cos * lower_cos,
      P_a = IN_EACH4(READ, a, 2, 3), signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2),
      t25 = t33 - P_a * signed_lower_rotation_zx, minus_lower_rotation_yx = signed_U_0_sin * lower_cos,
      t26 = U_v_0 * minus_lower_rotation_yx, t32 = sign1 * IN_EACH4(SINES, sine, 1, 2),
      lower_twist_wy = U_v_1 * U_0_cos, P_v = IN_EACH4(READ, v, 2, 3),
      signed_upper_twist_rate_vz = t25 + P_v * (t26 + t32 * lower_twist_wy);
    WRITE4(twist_rates, 17, 29, 41, 53, -sign3 * signed_upper_twist_rate_vz);
    LIMB4 checked = signed_upper_twist_rate_vz;
    const LIMB4 t14 = signed_lower_rotation_zx * lower_twist_wy, t21 = U_v_0 * signed_lower_rotation_zx,
      lower_twist_rate_vy = sign1 * (U_a_1 * signed_U_1_screw_vy) + sign1 * (U_v_1 * (U_v_0 * signed_U_1_screw_vz));
    WRITE4(twist_rates, 10, 21, 34, 45, lower_twist_rate_vy);
    const LIMB4 t19 = lower_twist_rate_vy - P_a * minus_lower_rotation_yx,
      signed_lower_twist_wz = U_v_1 * signed_U_0_sin, t16 = t14 + minus_lower_rotation_yx * signed_lower_twist_wz,
      upper_twist_rate_vy = t19 + P_v * (t32 * signed_lower_twist_wz - t21);
    WRITE4(twist_rates, 16, 27, 40, 51, upper_twist_rate_vy);
    checked = checked + upper_twist_rate_vy;
    const LIMB4 upper_twist_rate_vx = P_a * t32 + P_v * t16;
    WRITE4(twist_rates, 15, 28, 39, 52, upper_twist_rate_vx);
    checked = checked + upper_twist_rate_vx;
    const LIMB4 signed_lower_twist_rate_wz = U_a_1 * signed_U_0_sin + U_v_1 * (U_v_0 * U_0_cos);
    WRITE4(twist_rates, 8, 20, 32, 44, sign3 * signed_lower_twist_rate_wz);
    WRITE4(twist_rates, 14, 26, 38, 50, sign3 * signed_lower_twist_rate_wz);
    checked = checked + signed_lower_twist_rate_wz;
    const LIMB4 lower_twist_rate_wy = U_a_1 * U_0_cos - U_v_1 * (U_v_0 * signed_U_0_sin);
    WRITE4(twist_rates, 7, 18, 31, 42, lower_twist_rate_wy);
    WRITE4(twist_rates, 13, 24, 37, 48, lower_twist_rate_wy);
    checked = checked + lower_twist_rate_wy;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_body_twist_rates)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict twist_rates, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    LIMBS(body_twist_rates) limbs;
    REAL checked0 = READ(q, 2);
    REAL checked1 = READ(q, 5);
    REAL checked2 = READ(q, 8);
    REAL checked3 = READ(q, 11);
    checked0 = checked0 + (READ(v, 12));
    checked1 = checked1 + (READ(v, 13));
    checked2 = checked2 + (READ(v, 14));
    /* limb5_S: geometry; accelerations */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t4 = limb5_S_q_qw * limb5_S_q_qw,
      t5 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t6 = t4 + t5, t1 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t2 = limb5_S_q_qz * limb5_S_q_qz, t3 = t1 + t2, t7 = t6 + t3, t9 = 4.0 - 2.0 * t7,
      limb5_S_a_wx = READ(a, 12), limb5_S_a_wy = READ(a, 13), limb5_S_a_wz = READ(a, 14),
      t11 = limb5_S_a_wx * (1.0 - t3 * t9), t24 = limb5_S_a_wy * (1.0 - t9 * (t5 + t2)),
      t35 = limb5_S_a_wz * (1.0 - t9 * (t5 + t1)), t12 = limb5_S_q_qy * t9, t13 = limb5_S_q_qx * t12,
      t19 = limb5_S_q_qw * t12, t14 = limb5_S_q_qz * t9, t28 = limb5_S_q_qw * (limb5_S_q_qx * t9),
      t15 = limb5_S_q_qw * t14, t17 = t11 + limb5_S_a_wy * (t13 - t15), t25 = limb5_S_a_wx * (t13 + t15) + t24,
      t18 = limb5_S_q_qx * t14, t26 = limb5_S_q_qy * t14, platform_turn_zx = t18 - t19;
    RESULT(checked3, twist_rates, 0, t17 + limb5_S_a_wz * (t18 + t19));
    const REAL t30 = limb5_S_a_wx * platform_turn_zx, platform_turn_zy = t26 + t28;
    RESULT(checked0, twist_rates, 1, t25 + limb5_S_a_wz * (t26 - t28));
    RESULT(checked1, twist_rates, 2, t30 + limb5_S_a_wy * platform_turn_zy + t35);
    const REAL limb1_U_0_sin = SINES(sine, 0), limb1_U_0_cos = SINES(cosine, 0);
    FIRST_LIMB(0, body_twist_rates, 0, stride, v, a, twist_rates, sine, cosine, param_R * limb1_U_0_sin, param_R * limb1_U_0_cos, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[0]);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2);
    NEXT_LIMB(1, body_twist_rates, 0, stride, v, a, twist_rates, sine, cosine, param_R * minus_limb2_U_0_cos, param_R * limb2_U_0_sin, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[1]);
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    NEXT_LIMB(2, body_twist_rates, 0, stride, v, a, twist_rates, sine, cosine, param_R * limb3_U_0_sin, param_R * limb3_U_0_cos, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[2]);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6);
    NEXT_LIMB(3, body_twist_rates, 0, stride, v, a, twist_rates, sine, cosine, param_R * minus_limb4_U_0_cos, param_R * limb4_U_0_sin, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[3]);
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
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
BODY(three_ups_upu_s_forward_kinematics)(size_t stride, const double *restrict q, double *restrict positions,
    double *restrict total)
{
    const FOURS fours = (FOUR(q, 0) + FOUR(q, 4)) + FOUR(q, 8);
    REAL checked0 = SUM_OF_FOUR(fours);
    /* limb5_S: geometry; results */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t26 = t2 + t5, E_positions_z = param_H * (1.0 - t9 * (t2 + t4));
    WRITE(positions, 5, E_positions_z);
    const REAL t28 = 0.5 * (1.0 - t9 * t26), t20 = 0.5 * (1.0 - t6 * t9), t10 = limb5_S_q_qz * t9,
      t14 = limb5_S_q_qy * t10, t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t12 = limb5_S_q_qy * t9,
      platform_turn_yz = t14 - t16, t29 = 0.5 * (t14 + t16), limb4_lower_limb_target_x = E_positions_z + t29;
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
    const REAL t11 = limb5_S_q_qx * t10, t22 = limb5_S_q_qw * t10, t13 = limb5_S_q_qw * t12, t21 = limb5_S_q_qx * t12,
      platform_turn_zx = t11 - t13, E_positions_x = param_H * (t11 + t13);
    WRITE(positions, 3, E_positions_x);
    const REAL t24 = 0.5 * platform_turn_zx;
    RESULT(checked1, positions, 26, t24 + E_positions_z);
    RESULT(checked2, positions, 20, E_positions_z - t24);
    RESULT(checked3, positions, 24, t20 + E_positions_x);
    RESULT(checked0, positions, 18, E_positions_x - t20);
    const REAL platform_turn_yx = t21 + t22, t25 = 0.5 * (t21 - t22);
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
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
BODY(three_ups_upu_s_point_motion)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict positions, double *restrict velocities,
    double *restrict accelerations, double *restrict total)
{
    const FOURS fours = (((FOUR(a, 0) + FOUR(a, 4)) + (FOUR(a, 8) + FOUR(q, 0))) + ((FOUR(q, 4) + FOUR(q, 8)) + (FOUR(v, 0) + FOUR(v, 4)))) + FOUR(v, 8);
    REAL checked0 = SUM_OF_FOUR(fours);
    /* limb5_S: geometry; velocities, eq. (6); results */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t3 = t1 + t2, t4 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t5 = limb5_S_q_qz * limb5_S_q_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t26 = t2 + t5, platform_turn_zz = 1.0 - t9 * (t2 + t4), platform_turn_xx = 1.0 - t6 * t9,
      platform_turn_yy = 1.0 - t9 * t26, t10 = limb5_S_q_qz * t9, t11 = limb5_S_q_qx * t10, t12 = limb5_S_q_qy * t9,
      t16 = limb5_S_q_qw * (limb5_S_q_qx * t9), t13 = limb5_S_q_qw * t12, t21 = limb5_S_q_qx * t12,
      platform_turn_zx = t11 - t13, platform_turn_xz = t11 + t13, limb5_S_v_wx = READ(v, 12),
      t36 = limb5_S_v_wx * platform_turn_zx, t14 = limb5_S_q_qy * t10, t22 = limb5_S_q_qw * t10,
      platform_turn_zy = t14 + t16, platform_turn_yz = t14 - t16, limb5_S_v_wy = READ(v, 13),
      limb5_S_v_wz = READ(v, 14),
      platform_twist_wz = limb5_S_v_wz * platform_turn_zz + (t36 + limb5_S_v_wy * platform_turn_zy),
      E_positions_x = param_H * platform_turn_xz;
    WRITE(positions, 3, E_positions_x);
    const REAL platform_turn_xy = t21 - t22, platform_turn_yx = t21 + t22, t25 = 0.5 * platform_turn_xy,
      limb4_lower_limb_target_y = E_positions_x + t25;
    WRITE(positions, 27, limb4_lower_limb_target_y);
    const REAL limb2_lower_limb_target_y = E_positions_x - t25;
    WRITE(positions, 21, limb2_lower_limb_target_y);
    const REAL limb5_S_a_wy = READ(a, 13), t71 = limb4_lower_limb_target_y * platform_twist_wz,
      t91 = limb5_S_a_wy * platform_turn_xy, t43 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy * platform_turn_xy,
      platform_twist_wx = t43 + limb5_S_v_wz * platform_turn_xz, limb5_S_a_wz = READ(a, 14),
      t93 = limb5_S_a_wz * platform_turn_xz, t29 = 0.5 * platform_turn_zy, t81 = limb5_S_a_wy * platform_turn_zy,
      E_positions_z = param_H * platform_turn_zz;
    WRITE(positions, 5, E_positions_z);
    const REAL t83 = limb5_S_a_wz * platform_turn_zz, limb4_lower_limb_target_x = E_positions_z + t29;
    WRITE(positions, 29, limb4_lower_limb_target_x);
    const REAL limb2_lower_limb_target_x = E_positions_z - t29;
    WRITE(positions, 23, limb2_lower_limb_target_x);
    const REAL C4_velocities_y = t71 - limb4_lower_limb_target_x * platform_twist_wx;
    WRITE(velocities, 28, C4_velocities_y);
    const REAL t177 = platform_twist_wx * C4_velocities_y, t166 = platform_twist_wz * C4_velocities_y,
      t32 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      platform_twist_wy = t32 + limb5_S_v_wz * platform_turn_yz, t69 = limb4_lower_limb_target_x * platform_twist_wy,
      E_positions_y = param_H * platform_turn_yz;
    WRITE(positions, 4, E_positions_y);
    const REAL t78 = limb5_S_a_wz * platform_turn_yz, t28 = 0.5 * platform_turn_yy,
      t76 = limb5_S_a_wy * platform_turn_yy, limb4_upper_position_y = E_positions_y + t28;
    WRITE(positions, 28, limb4_upper_position_y);
    const REAL limb2_upper_position_y = E_positions_y - t28;
    WRITE(positions, 22, limb2_upper_position_y);
    const REAL C4_velocities_x = t69 - limb4_upper_position_y * platform_twist_wz;
    WRITE(velocities, 27, C4_velocities_x);
    const REAL limb5_S_a_wx = READ(a, 12);
    /* C1: results; accelerations; geometry */
    const REAL t179 = t177 - platform_twist_wy * C4_velocities_x, t171 = platform_twist_wz * C4_velocities_x,
      platform_twist_rate_wx = limb5_S_a_wx * platform_turn_xx + t91 + t93, t20 = 0.5 * platform_turn_xx,
      t174 = limb4_upper_position_y * platform_twist_rate_wx,
      platform_twist_rate_wy = limb5_S_a_wx * platform_turn_yx + t76 + t78, t23 = 0.5 * platform_turn_yx,
      C4_accelerations_z = t174 - limb4_lower_limb_target_y * platform_twist_rate_wy + t179;
    WRITE(accelerations, 29, C4_accelerations_z);
    REAL checked1 = C4_accelerations_z;
    const REAL C4_velocities_z = limb4_upper_position_y * platform_twist_wx - limb4_lower_limb_target_y * platform_twist_wy;
    WRITE(velocities, 29, C4_velocities_z);
    const REAL t173 = t171 - platform_twist_wx * C4_velocities_z, t167 = platform_twist_wy * C4_velocities_z - t166,
      platform_twist_rate_wz = limb5_S_a_wx * platform_turn_zx + t81 + t83,
      t168 = limb4_lower_limb_target_y * platform_twist_rate_wz,
      t163 = limb4_upper_position_y * platform_twist_rate_wz, t24 = 0.5 * platform_turn_zx,
      C4_accelerations_y = t168 - limb4_lower_limb_target_x * platform_twist_rate_wx + t173;
    WRITE(accelerations, 28, C4_accelerations_y);
    REAL checked2 = C4_accelerations_y;
    const REAL C4_accelerations_x = limb4_lower_limb_target_x * platform_twist_rate_wy - t163 + t167;
    WRITE(accelerations, 27, C4_accelerations_x);
    REAL checked3 = C4_accelerations_x;
    const REAL limb3_upper_position_x = t20 + E_positions_x;
    WRITE(positions, 24, limb3_upper_position_x);
    const REAL minus_limb1_upper_position_x = t20 - E_positions_x;
    WRITE(positions, 18, -minus_limb1_upper_position_x);
    const REAL t65 = limb3_upper_position_x * platform_twist_wz, limb3_lower_limb_target_y = t24 + E_positions_z;
    WRITE(positions, 26, limb3_lower_limb_target_y);
    const REAL minus_limb1_lower_limb_target_y = t24 - E_positions_z;
    WRITE(positions, 20, -minus_limb1_lower_limb_target_y);
    const REAL C3_velocities_y = t65 - limb3_lower_limb_target_y * platform_twist_wx;
    WRITE(velocities, 25, C3_velocities_y);
    const REAL t159 = platform_twist_wx * C3_velocities_y, t148 = platform_twist_wz * C3_velocities_y,
      t63 = limb3_lower_limb_target_y * platform_twist_wy, limb3_lower_limb_target_x = t23 + E_positions_y;
    WRITE(positions, 25, limb3_lower_limb_target_x);
    const REAL minus_limb1_lower_limb_target_x = t23 - E_positions_y;
    WRITE(positions, 19, -minus_limb1_lower_limb_target_x);
    const REAL C3_velocities_x = t63 - limb3_lower_limb_target_x * platform_twist_wz;
    WRITE(velocities, 24, C3_velocities_x);
    const REAL t161 = t159 - platform_twist_wy * C3_velocities_x, t153 = platform_twist_wz * C3_velocities_x,
      t156 = limb3_lower_limb_target_x * platform_twist_rate_wx;
    RESULT(checked0, accelerations, 26, t156 - limb3_upper_position_x * platform_twist_rate_wy + t161);
    const REAL t145 = limb3_lower_limb_target_x * platform_twist_rate_wz,
      C3_velocities_z = limb3_lower_limb_target_x * platform_twist_wx - limb3_upper_position_x * platform_twist_wy;
    WRITE(velocities, 26, C3_velocities_z);
    const REAL t150 = limb3_upper_position_x * platform_twist_rate_wz,
      t155 = t153 - platform_twist_wx * C3_velocities_z, t149 = platform_twist_wy * C3_velocities_z - t148;
    RESULT(checked1, accelerations, 25, t150 - limb3_lower_limb_target_y * platform_twist_rate_wx + t155);
    RESULT(checked2, accelerations, 24, limb3_lower_limb_target_y * platform_twist_rate_wy - t145 + t149);
    const REAL C2_velocities_y = limb2_lower_limb_target_y * platform_twist_wz - limb2_lower_limb_target_x * platform_twist_wx;
    WRITE(velocities, 22, C2_velocities_y);
    const REAL t141 = platform_twist_wx * C2_velocities_y, t130 = platform_twist_wz * C2_velocities_y,
      C2_velocities_x = limb2_lower_limb_target_x * platform_twist_wy - limb2_upper_position_y * platform_twist_wz;
    WRITE(velocities, 21, C2_velocities_x);
    const REAL t143 = t141 - platform_twist_wy * C2_velocities_x, t135 = platform_twist_wz * C2_velocities_x,
      t138 = limb2_upper_position_y * platform_twist_rate_wx;
    RESULT(checked3, accelerations, 23, t138 - limb2_lower_limb_target_y * platform_twist_rate_wy + t143);
    const REAL t127 = limb2_upper_position_y * platform_twist_rate_wz,
      C2_velocities_z = limb2_upper_position_y * platform_twist_wx - limb2_lower_limb_target_y * platform_twist_wy;
    WRITE(velocities, 23, C2_velocities_z);
    const REAL t132 = limb2_lower_limb_target_y * platform_twist_rate_wz,
      t137 = t135 - platform_twist_wx * C2_velocities_z, t131 = platform_twist_wy * C2_velocities_z - t130;
    RESULT(checked0, accelerations, 22, t132 - limb2_lower_limb_target_x * platform_twist_rate_wx + t137);
    RESULT(checked1, accelerations, 21, limb2_lower_limb_target_x * platform_twist_rate_wy - t127 + t131);
    const REAL t51 = minus_limb1_upper_position_x * platform_twist_wz,
      t53 = t51 - minus_limb1_lower_limb_target_y * platform_twist_wx;
    WRITE(velocities, 19, -t53);
    const REAL t122 = platform_twist_wx * t53, t109 = platform_twist_wz * t53,
      t48 = minus_limb1_lower_limb_target_y * platform_twist_wy,
      t50 = t48 - minus_limb1_lower_limb_target_x * platform_twist_wz;
    WRITE(velocities, 18, -t50);
    const REAL t124 = t122 - platform_twist_wy * t50, t115 = platform_twist_wz * t50,
      t119 = minus_limb1_lower_limb_target_x * platform_twist_rate_wx,
      t125 = t119 - minus_limb1_upper_position_x * platform_twist_rate_wy + t124;
    checked2 = checked2 + t125;
    WRITE(accelerations, 20, -t125);
    const REAL t54 = minus_limb1_lower_limb_target_x * platform_twist_wx,
      t106 = minus_limb1_lower_limb_target_x * platform_twist_rate_wz,
      t56 = t54 - minus_limb1_upper_position_x * platform_twist_wy,
      t112 = minus_limb1_upper_position_x * platform_twist_rate_wz;
    WRITE(velocities, 20, -t56);
    const REAL t117 = t115 - platform_twist_wx * t56, t110 = platform_twist_wy * t56 - t109,
      t118 = t112 - minus_limb1_lower_limb_target_y * platform_twist_rate_wx + t117;
    checked3 = checked3 + t118;
    WRITE(accelerations, 19, -t118);
    const REAL t111 = minus_limb1_lower_limb_target_y * platform_twist_rate_wy - t106 + t110;
    checked0 = checked0 + t111;
    WRITE(accelerations, 18, -t111);
    const REAL E_velocities_y = E_positions_x * platform_twist_wz - E_positions_z * platform_twist_wx;
    WRITE(velocities, 4, E_velocities_y);
    const REAL t102 = platform_twist_wx * E_velocities_y, t87 = platform_twist_wz * E_velocities_y,
      E_velocities_x = E_positions_z * platform_twist_wy - E_positions_y * platform_twist_wz;
    WRITE(velocities, 3, E_velocities_x);
    const REAL t96 = platform_twist_wz * E_velocities_x, t104 = t102 - platform_twist_wy * E_velocities_x,
      t94 = E_positions_z * platform_twist_rate_wx, t79 = E_positions_z * platform_twist_rate_wy;
    RESULT(checked1, accelerations, 5, E_positions_y * platform_twist_rate_wx - E_positions_x * platform_twist_rate_wy + t104);
    const REAL t85 = t79 - E_positions_y * platform_twist_rate_wz, t95 = E_positions_x * platform_twist_rate_wz - t94,
      E_velocities_z = E_positions_y * platform_twist_wx - E_positions_x * platform_twist_wy;
    WRITE(velocities, 5, E_velocities_z);
    RESULT(checked2, accelerations, 4, t95 + (t96 - platform_twist_wx * E_velocities_z));
    RESULT(checked3, accelerations, 3, t85 + (platform_twist_wy * E_velocities_z - t87));
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
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
BODY(three_ups_upu_s_joint_screws)(size_t stride, const double *restrict q, double *restrict screws,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* limb4: geometry */
    const REAL minus_limb4_lower_sin = SINES(sine, 7);
    WRITE(screws, 118, -minus_limb4_lower_sin);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_cos = -minus_limb4_U_0_cos;
    WRITE(screws, 110, limb4_U_0_cos);
    WRITE(screws, 122, limb4_U_0_cos);
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    WRITE(screws, 81, -minus_limb3_lower_sin);
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    WRITE(screws, 73, limb3_U_0_cos);
    WRITE(screws, 91, limb3_U_0_cos);
    /* limb2_U: screws, eq. (5) */
    const REAL limb3_U_1_screw_vz = param_R * limb3_U_0_cos;
    WRITE(screws, 77, limb3_U_1_screw_vz);
    REAL checked0 = limb3_U_1_screw_vz;
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    WRITE(screws, 36, limb2_U_0_sin);
    WRITE(screws, 48, limb2_U_0_sin);
    const REAL limb2_U_1_screw_vz = param_R * limb2_U_0_sin;
    WRITE(screws, 41, limb2_U_1_screw_vz);
    REAL checked1 = limb2_U_1_screw_vz;
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_1_screw_vx = param_R * minus_limb2_U_0_cos;
    WRITE(screws, 39, limb2_U_1_screw_vx);
    REAL checked2 = limb2_U_1_screw_vx;
    const REAL limb2_U_0_cos = -minus_limb2_U_0_cos;
    WRITE(screws, 38, limb2_U_0_cos);
    WRITE(screws, 50, limb2_U_0_cos);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    WRITE(screws, 8, limb1_U_0_sin);
    const REAL limb1_U_1_screw_vy = param_R * limb1_U_0_sin;
    WRITE(screws, 10, limb1_U_1_screw_vy);
    REAL checked3 = limb1_U_1_screw_vy;
    /* limb4: geometry */
    const REAL limb4_upper_offset_x = limb_upper_phase + READ(q, 11),
      limb4_upper_position_y = param_R - minus_limb4_lower_sin * limb4_upper_offset_x,
      limb4_lower_cos = SINES(cosine, 7), minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos;
    WRITE(screws, 117, -minus_limb4_lower_rotation_xx);
    /* limb4: screws, eq. (5); geometry */
    const REAL t118 = k1 * minus_limb4_lower_rotation_xx,
      minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin,
      t120 = t118 - 0.5 * minus_limb4_lower_rotation_xy;
    WRITE(screws, 132, -t120);
    const REAL t106 = k1 * minus_limb4_lower_rotation_xy, t133 = limb4_upper_position_y * t120,
      minus_limb4_upper_position_x = limb4_upper_offset_x * minus_limb4_lower_rotation_xx,
      limb4_S_screws_y_wx = 0.5 * minus_limb4_lower_rotation_xx + t106;
    WRITE(screws, 126, limb4_S_screws_y_wx);
    const REAL t123 = k1 * minus_limb4_lower_sin + 0.5 * limb4_lower_cos;
    WRITE(screws, 133, -t123);
    RESULT(checked0, screws, 137, minus_limb4_upper_position_x * t123 + t133);
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    WRITE(screws, 108, limb4_U_0_sin);
    WRITE(screws, 120, limb4_U_0_sin);
    const REAL minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos,
      minus_limb4_upper_position_z = limb4_upper_offset_x * minus_limb4_lower_rotation_zx,
      t130 = minus_limb4_upper_position_z * t120, t128 = minus_limb4_upper_position_z * t123;
    WRITE(screws, 119, -minus_limb4_lower_rotation_zx);
    const REAL t124 = k1 * minus_limb4_lower_rotation_zx, t109 = 0.5 * minus_limb4_lower_rotation_zx,
      minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin,
      t126 = t124 - 0.5 * minus_limb4_lower_rotation_zy;
    WRITE(screws, 134, -t126);
    const REAL limb4_S_screws_y_wz = t109 + k1 * minus_limb4_lower_rotation_zy;
    WRITE(screws, 128, limb4_S_screws_y_wz);
    RESULT(checked1, screws, 136, t130 - minus_limb4_upper_position_x * t126);
    const REAL t129 = limb4_upper_position_y * t126 + t128;
    checked2 = checked2 + t129;
    WRITE(screws, 135, -t129);
    const REAL t116 = limb4_upper_position_y * limb4_S_screws_y_wx,
      t114 = minus_limb4_upper_position_z * limb4_S_screws_y_wx,
      limb4_S_screws_y_wy = 0.5 * minus_limb4_lower_sin - k1 * limb4_lower_cos;
    WRITE(screws, 127, limb4_S_screws_y_wy);
    const REAL t117 = minus_limb4_upper_position_x * limb4_S_screws_y_wy + t116;
    checked3 = checked3 + t117;
    WRITE(screws, 131, -t117);
    const REAL t112 = minus_limb4_upper_position_z * limb4_S_screws_y_wy,
      t101 = limb4_U_0_sin * minus_limb4_upper_position_z;
    RESULT(checked0, screws, 130, minus_limb4_upper_position_x * limb4_S_screws_y_wz - t114);
    RESULT(checked1, screws, 129, limb4_upper_position_y * limb4_S_screws_y_wz + t112);
    const REAL t103 = t101 + minus_limb4_U_0_cos * minus_limb4_upper_position_x;
    checked2 = checked2 + t103;
    WRITE(screws, 124, -t103);
    const REAL t104 = limb4_U_0_sin * limb4_upper_position_y;
    checked3 = checked3 + t104;
    WRITE(screws, 125, -t104);
    const REAL t100 = minus_limb4_U_0_cos * limb4_upper_position_y;
    checked0 = checked0 + t100;
    WRITE(screws, 123, -t100);
    const REAL minus_limb4_U_1_screw_vz = param_R * limb4_U_0_sin;
    checked1 = checked1 + minus_limb4_U_1_screw_vz;
    WRITE(screws, 113, -minus_limb4_U_1_screw_vz);
    const REAL minus_limb4_U_1_screw_vx = param_R * minus_limb4_U_0_cos;
    checked2 = checked2 + minus_limb4_U_1_screw_vx;
    WRITE(screws, 111, -minus_limb4_U_1_screw_vx);
    /* limb3: geometry; screws, eq. (5) */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    RESULT(checked3, screws, 95, limb3_U_0_cos * limb3_upper_position_x);
    const REAL limb3_U_0_sin = SINES(sine, 4);
    WRITE(screws, 74, limb3_U_0_sin);
    WRITE(screws, 92, limb3_U_0_sin);
    const REAL limb3_lower_cos = SINES(cosine, 5), minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos;
    WRITE(screws, 82, -minus_limb3_lower_rotation_yx);
    /* limb3: screws, eq. (5); geometry */
    const REAL t86 = k1 * minus_limb3_lower_rotation_yx,
      minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin,
      t88 = t86 + 0.5 * minus_limb3_lower_rotation_yy;
    WRITE(screws, 97, -t88);
    const REAL t69 = k1 * minus_limb3_lower_rotation_yy, t96 = limb3_upper_position_x * t88,
      minus_limb3_upper_position_y = limb3_upper_offset_x * minus_limb3_lower_rotation_yx,
      limb3_S_screws_x_wy = 0.5 * minus_limb3_lower_rotation_yx - t69;
    WRITE(screws, 85, limb3_S_screws_x_wy);
    const REAL t85 = k1 * minus_limb3_lower_sin - 0.5 * limb3_lower_cos;
    WRITE(screws, 96, -t85);
    const REAL t98 = t96 + minus_limb3_upper_position_y * t85;
    checked0 = checked0 + t98;
    WRITE(screws, 101, -t98);
    const REAL limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos;
    WRITE(screws, 83, limb3_lower_rotation_zx);
    const REAL limb3_upper_position_z = limb3_upper_offset_x * limb3_lower_rotation_zx,
      t93 = limb3_upper_position_z * t85, t91 = limb3_upper_position_z * t88, t89 = k1 * limb3_lower_rotation_zx,
      t70 = 0.5 * limb3_lower_rotation_zx, limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin,
      limb3_S_screws_z_wz = t89 + 0.5 * limb3_lower_rotation_zy;
    WRITE(screws, 98, limb3_S_screws_z_wz);
    const REAL t72 = t70 - k1 * limb3_lower_rotation_zy;
    WRITE(screws, 86, -t72);
    const REAL t95 = t93 + limb3_upper_position_x * limb3_S_screws_z_wz;
    checked1 = checked1 + t95;
    WRITE(screws, 100, -t95);
    RESULT(checked2, screws, 99, t91 - minus_limb3_upper_position_y * limb3_S_screws_z_wz);
    const REAL t82 = limb3_U_0_sin * limb3_upper_position_x;
    checked3 = checked3 + t82;
    WRITE(screws, 94, -t82);
    const REAL t81 = limb3_U_0_sin * minus_limb3_upper_position_y + limb3_U_0_cos * limb3_upper_position_z;
    checked0 = checked0 + t81;
    WRITE(screws, 93, -t81);
    const REAL t77 = limb3_upper_position_x * limb3_S_screws_x_wy, t76 = limb3_upper_position_x * t72;
    RESULT(checked1, screws, 87, minus_limb3_upper_position_y * t72 - limb3_upper_position_z * limb3_S_screws_x_wy);
    const REAL limb3_S_screws_x_wx = 0.5 * minus_limb3_lower_sin + k1 * limb3_lower_cos;
    WRITE(screws, 84, limb3_S_screws_x_wx);
    RESULT(checked2, screws, 89, t77 + minus_limb3_upper_position_y * limb3_S_screws_x_wx);
    RESULT(checked3, screws, 88, limb3_upper_position_z * limb3_S_screws_x_wx + t76);
    const REAL minus_limb3_U_1_screw_vy = param_R * limb3_U_0_sin;
    checked0 = checked0 + minus_limb3_U_1_screw_vy;
    WRITE(screws, 76, -minus_limb3_U_1_screw_vy);
    /* limb2: geometry; screws, eq. (5) */
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5), limb2_lower_sin = SINES(sine, 3);
    WRITE(screws, 46, limb2_lower_sin);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    RESULT(checked1, screws, 53, limb2_U_0_sin * minus_limb2_upper_position_y);
    RESULT(checked2, screws, 51, minus_limb2_U_0_cos * minus_limb2_upper_position_y);
    const REAL limb2_lower_cos = SINES(cosine, 3),
      minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos;
    WRITE(screws, 45, -minus_limb2_lower_rotation_xx);
    /* limb2: screws, eq. (5); geometry */
    const REAL t50 = k1 * minus_limb2_lower_rotation_xx,
      limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin, t52 = t50 - 0.5 * limb2_lower_rotation_xy;
    WRITE(screws, 60, -t52);
    const REAL t36 = k1 * limb2_lower_rotation_xy, t63 = minus_limb2_upper_position_y * t52,
      minus_limb2_upper_position_x = limb2_upper_offset_x * minus_limb2_lower_rotation_xx,
      t37 = 0.5 * minus_limb2_lower_rotation_xx + t36;
    WRITE(screws, 54, -t37);
    const REAL limb2_S_screws_z_wy = k1 * limb2_lower_sin + 0.5 * limb2_lower_cos;
    WRITE(screws, 61, limb2_S_screws_z_wy);
    const REAL t64 = minus_limb2_upper_position_x * limb2_S_screws_z_wy + t63;
    checked3 = checked3 + t64;
    WRITE(screws, 65, -t64);
    const REAL minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos,
      minus_limb2_upper_position_z = limb2_upper_offset_x * minus_limb2_lower_rotation_zx,
      t60 = minus_limb2_upper_position_z * t52, t59 = minus_limb2_upper_position_z * limb2_S_screws_z_wy;
    WRITE(screws, 47, -minus_limb2_lower_rotation_zx);
    const REAL t55 = k1 * minus_limb2_lower_rotation_zx, t40 = 0.5 * minus_limb2_lower_rotation_zx,
      limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin, t57 = t55 - 0.5 * limb2_lower_rotation_zy;
    WRITE(screws, 62, -t57);
    const REAL t42 = t40 + k1 * limb2_lower_rotation_zy;
    WRITE(screws, 56, -t42);
    RESULT(checked0, screws, 64, t60 - minus_limb2_upper_position_x * t57);
    RESULT(checked1, screws, 63, minus_limb2_upper_position_y * t57 + t59);
    const REAL t48 = minus_limb2_upper_position_y * t37, t43 = minus_limb2_upper_position_y * t42;
    RESULT(checked2, screws, 58, minus_limb2_upper_position_z * t37 - minus_limb2_upper_position_x * t42);
    const REAL limb2_S_screws_y_wy = 0.5 * limb2_lower_sin - k1 * limb2_lower_cos;
    WRITE(screws, 55, limb2_S_screws_y_wy);
    const REAL t49 = minus_limb2_upper_position_x * limb2_S_screws_y_wy + t48;
    checked3 = checked3 + t49;
    WRITE(screws, 59, -t49);
    RESULT(checked0, screws, 57, t43 + minus_limb2_upper_position_z * limb2_S_screws_y_wy);
    const REAL t32 = limb2_U_0_sin * minus_limb2_upper_position_z,
      t34 = t32 + minus_limb2_U_0_cos * minus_limb2_upper_position_x;
    checked1 = checked1 + t34;
    WRITE(screws, 52, -t34);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t6 = limb5_S_q_qw * limb5_S_q_qw,
      t7 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), limb5_S_q_qz = READ(q, 15), t8 = t6 + t7,
      t9 = limb5_S_q_qy * limb5_S_q_qy, t10 = limb5_S_q_qz * limb5_S_q_qz, t12 = t8 + (t9 + t10), t19 = t7 + t10,
      t14 = 4.0 - 2.0 * t12, platform_turn_yy = 1.0 - t14 * t19;
    WRITE(screws, 25, platform_turn_yy);
    const REAL t16 = limb5_S_q_qx * (limb5_S_q_qy * t14), t17 = limb5_S_q_qz * t14,
      t23 = limb5_S_q_qw * (limb5_S_q_qx * t14), platform_turn_xy = t16 - limb5_S_q_qw * t17;
    WRITE(screws, 24, platform_turn_xy);
    const REAL platform_turn_zy = limb5_S_q_qy * t17 + t23;
    WRITE(screws, 26, platform_turn_zy);
    /* limb1: geometry; screws, eq. (5) */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2), limb1_lower_cos = SINES(cosine, 1);
    WRITE(screws, 18, limb1_lower_cos);
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    WRITE(screws, 16, -minus_limb1_lower_rotation_yx);
    const REAL minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx,
      limb1_lower_sin = SINES(sine, 1);
    WRITE(screws, 15, limb1_lower_sin);
    const REAL t29 = platform_turn_xy * minus_limb1_upper_position_y,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    RESULT(checked2, screws, 29, t29 - platform_turn_yy * minus_limb1_upper_position_x);
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    WRITE(screws, 7, limb1_U_0_cos);
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    WRITE(screws, 17, limb1_lower_rotation_zx);
    const REAL limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx;
    /* limb1: screws, eq. (5); geometry */
    const REAL t25 = platform_turn_yy * limb1_upper_position_z, t2 = limb1_lower_cos * limb1_upper_position_z;
    RESULT(checked3, screws, 28, platform_turn_xy * limb1_upper_position_z + platform_turn_zy * minus_limb1_upper_position_x);
    const REAL t26 = platform_turn_zy * minus_limb1_upper_position_y + t25;
    checked0 = checked0 + t26;
    WRITE(screws, 27, -t26);
    const REAL t4 = limb1_lower_cos * minus_limb1_upper_position_y,
      limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    WRITE(screws, 19, limb1_lower_rotation_yy);
    RESULT(checked1, screws, 23, t4 - limb1_lower_rotation_yy * minus_limb1_upper_position_x);
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin;
    RESULT(checked2, screws, 22, t2 - minus_limb1_lower_rotation_zy * minus_limb1_upper_position_x);
    WRITE(screws, 20, -minus_limb1_lower_rotation_zy);
    const REAL minus_limb1_U_1_screw_vz = param_R * limb1_U_0_cos;
    checked3 = checked3 + minus_limb1_U_1_screw_vz;
    WRITE(screws, 11, -minus_limb1_U_1_screw_vz);
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
    WRITE(screws, 21, CONSTANT(0.0));
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
    /* else status 5: no rotation */
    NOT_BELOW(t12, 0.999999, 5);
    NOT_ABOVE(t12, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
typedef struct {
    EACH4 checked;
} LIMBS(joint_points);

STAGE(joint_points, 0)(size_t limb, size_t stride, const double *restrict q, double *restrict points,
    const double *restrict sine, const double *restrict cosine, LIMBS(joint_points) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, -1.0, 1.0, -1.0), sign2 = OF4(1.0, 1.0, -1.0, -1.0);
    const LIMB4 lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: geometry; results */
    const LIMB4 signed_lower_rotation_zx = IN_EACH4(SINES, cosine, 0, 2) * lower_cos,
      t3 = limb_upper_phase * signed_lower_rotation_zx, upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      signed_upper_position_z = upper_offset_x * signed_lower_rotation_zx;
    WRITE4(points, 8, 17, 26, 35, sign1 * signed_upper_position_z);
    const LIMB4 signed_P_points_z = t3 - signed_upper_position_z;
    WRITE4(points, 5, 14, 23, 32, -sign1 * signed_P_points_z);
    LIMB4 checked = signed_P_points_z;
    const LIMB4 minus_lower_rotation_yx = IN_EACH4(SINES, sine, 0, 2) * lower_cos,
      t2 = limb_upper_phase * minus_lower_rotation_yx,
      minus_upper_position_y = upper_offset_x * minus_lower_rotation_yx;
    WRITE4(points, 7, 15, 25, 33, -minus_upper_position_y);
    const LIMB4 P_points_y = t2 - minus_upper_position_y;
    WRITE4(points, 4, 12, 22, 30, P_points_y);
    checked = checked + P_points_y;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      signed_upper_position_x = signed_lower_sin * upper_offset_x + (-param_R);
    WRITE4(points, 6, 16, 24, 34, sign2 * signed_upper_position_x);
    const LIMB4 P_points_x = limb_upper_phase * signed_lower_sin - signed_upper_position_x;
    WRITE4(points, 3, 13, 21, 31, -sign2 * P_points_x);
    checked = checked + P_points_x;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_joint_points)(size_t stride, const double *restrict q, double *restrict points,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    LIMBS(joint_points) limbs;
    REAL checked0 = READ(q, 12);
    REAL checked1 = READ(q, 13);
    REAL checked2 = READ(q, 14);
    REAL checked3 = READ(q, 15);
    FIRST_LIMB(0, joint_points, 0, stride, q, points, sine, cosine, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[0]);
    NEXT_LIMB(1, joint_points, 0, stride, q, points, sine, cosine, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[1]);
    NEXT_LIMB(2, joint_points, 0, stride, q, points, sine, cosine, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[2]);
    NEXT_LIMB(3, joint_points, 0, stride, q, points, sine, cosine, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[3]);
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
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
BODY(three_ups_upu_s_platform_jacobian)(size_t stride, const double *restrict q, double *restrict jacobian,
    double *restrict total)
{
    const FOURS fours = (FOUR(q, 0) + FOUR(q, 4)) + FOUR(q, 8);
    REAL checked0 = SUM_OF_FOUR(fours);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t4 = limb5_S_q_qw * limb5_S_q_qw,
      t5 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t6 = t4 + t5, t1 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t2 = limb5_S_q_qz * limb5_S_q_qz, t3 = t1 + t2, t7 = t6 + t3, t9 = 4.0 - 2.0 * t7,
      t17 = t5 + t2, platform_turn_zz = 1.0 - t9 * (t5 + t1);
    WRITE(jacobian, 86, platform_turn_zz);
    REAL checked1 = platform_turn_zz;
    const REAL platform_turn_yy = 1.0 - t9 * t17;
    WRITE(jacobian, 79, platform_turn_yy);
    REAL checked2 = platform_turn_yy;
    const REAL platform_turn_xx = 1.0 - t3 * t9;
    WRITE(jacobian, 72, platform_turn_xx);
    REAL checked3 = platform_turn_xx;
    const REAL t13 = limb5_S_q_qz * t9, t19 = limb5_S_q_qy * t13, t21 = limb5_S_q_qw * (limb5_S_q_qx * t9);
    RESULT(checked0, jacobian, 85, t19 - t21);
    RESULT(checked1, jacobian, 80, t19 + t21);
    const REAL t11 = limb5_S_q_qy * t9, t15 = limb5_S_q_qx * t13, t14 = limb5_S_q_qw * t13, t16 = limb5_S_q_qw * t11;
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
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
BODY(three_ups_upu_s_joint_rates)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict rates, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    REAL checked0 = READ(q, 2);
    REAL checked1 = READ(q, 5);
    REAL checked2 = READ(q, 8);
    REAL checked3 = READ(q, 11);
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t2 = limb5_S_q_qw * limb5_S_q_qw,
      t3 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), t4 = t2 + t3, t5 = limb5_S_q_qy * limb5_S_q_qy,
      limb5_S_q_qz = READ(q, 15), t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7, t10 = 4.0 - 2.0 * t8,
      limb5_S_v_wx = READ(v, 12), t29 = limb5_S_v_wx * (1.0 - t7 * t10), t44 = t3 + t5,
      platform_turn_yy = 1.0 - t10 * (t3 + t6), limb5_S_v_wz = READ(v, 14), t46 = limb5_S_v_wz * (1.0 - t10 * t44),
      t11 = limb5_S_q_qy * t10, t12 = limb5_S_q_qx * t11, t33 = limb5_S_q_qw * t11, t13 = limb5_S_q_qz * t10,
      t22 = limb5_S_q_qw * (limb5_S_q_qx * t10), t14 = limb5_S_q_qw * t13, platform_turn_xy = t12 - t14,
      limb5_S_v_wy = READ(v, 13), t38 = limb5_S_v_wx * (t12 + t14), t31 = t29 + limb5_S_v_wy * platform_turn_xy,
      t32 = limb5_S_q_qx * t13, t20 = limb5_S_q_qy * t13, platform_turn_zx = t32 - t33,
      platform_twist_wx = t31 + limb5_S_v_wz * (t32 + t33);
    WRITE(rates, 23, platform_twist_wx);
    const REAL limb1_U_v_0 = READ(v, 0);
    WRITE(rates, 0, limb1_U_v_0);
    const REAL t47 = limb5_S_v_wx * platform_turn_zx, t35 = limb1_U_v_0 - platform_twist_wx, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), t53 = platform_turn_xy * t35, /* limb1 */
      t15 = limb1_lower_cos * platform_turn_xy, /* limb1 */
      t36 = limb1_lower_cos * t35, /* limb1 */
      t39 = limb5_S_v_wy * platform_turn_yy + t38, platform_turn_yz = t20 - t22, platform_turn_zy = t20 + t22,
      platform_twist_wy = t39 + limb5_S_v_wz * platform_turn_yz;
    WRITE(rates, 24, platform_twist_wy);
    /* limb1: velocities, eq. (6); geometry; results */
    const REAL limb1_U_v_1 = READ(v, 1);
    WRITE(rates, 1, limb1_U_v_1);
    const REAL limb1_U_0_cos = SINES(cosine, 0), t41 = platform_twist_wy - limb1_U_v_1 * limb1_U_0_cos,
      t55 = t53 - platform_turn_yy * t41, platform_twist_wz = t46 + (t47 + limb5_S_v_wy * platform_turn_zy);
    WRITE(rates, 25, platform_twist_wz);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    /* limb1: results; geometry */
    const REAL t50 = platform_twist_wz - limb1_U_v_1 * limb1_U_0_sin, t57 = t55 - platform_turn_zy * t50,
      limb1_lower_sin = SINES(sine, 1), limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin,
      t19 = t15 + platform_turn_yy * limb1_lower_rotation_yy, t43 = t36 - limb1_lower_rotation_yy * t41,
      minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin,
      t24 = t19 - platform_turn_zy * minus_limb1_lower_rotation_zy, t52 = t43 + minus_limb1_lower_rotation_zy * t50,
      t59 = t52 - t24 * t57, t62 = t57 - t24 * t52, t27 = 1.0 / (1.0 - t24 * t24), t60 = t27 * t59;
    checked0 = checked0 + t60;
    WRITE(rates, 3, -t60);
    const REAL t63 = t27 * t62;
    checked1 = checked1 + t63;
    WRITE(rates, 4, -t63);
    /* limb2: velocities, eq. (6); geometry; results */
    const REAL limb2_U_v_1 = READ(v, 4);
    WRITE(rates, 6, limb2_U_v_1);
    const REAL limb2_U_0_sin = SINES(cosine, 2), t64 = platform_twist_wx - limb2_U_v_1 * limb2_U_0_sin,
      minus_limb2_U_0_cos = SINES(sine, 2);
    /* limb2: results; geometry */
    const REAL t65 = limb2_U_0_sin * t64, t66 = platform_twist_wz + limb2_U_v_1 * minus_limb2_U_0_cos;
    RESULT(checked2, rates, 8, t65 - minus_limb2_U_0_cos * t66);
    const REAL limb2_lower_cos = SINES(cosine, 3),
      minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos, limb2_lower_sin = SINES(sine, 3),
      t69 = 0.5 * minus_limb2_lower_rotation_xx, t84 = k1 * minus_limb2_lower_rotation_xx,
      limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin, limb2_U_v_0 = READ(v, 3);
    WRITE(rates, 5, limb2_U_v_0);
    const REAL t72 = (t69 + k1 * limb2_lower_rotation_xy) * t64, t87 = (t84 - 0.5 * limb2_lower_rotation_xy) * t64,
      t76 = limb2_U_v_0 - platform_twist_wy, t78 = t72 + (0.5 * limb2_lower_sin - k1 * limb2_lower_cos) * t76,
      minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos, t79 = 0.5 * minus_limb2_lower_rotation_zx,
      t93 = k1 * minus_limb2_lower_rotation_zx, limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin,
      t83 = t78 + (t79 + k1 * limb2_lower_rotation_zy) * t66;
    checked3 = checked3 + t83;
    WRITE(rates, 9, -t83);
    const REAL t96 = (t93 - 0.5 * limb2_lower_rotation_zy) * t66,
      t97 = t87 + (k1 * limb2_lower_sin + 0.5 * limb2_lower_cos) * t76 + t96;
    checked0 = checked0 + t97;
    WRITE(rates, 10, -t97);
    /* limb3: results; geometry; velocities, eq. (6) */
    const REAL limb3_U_v_0 = READ(v, 6);
    WRITE(rates, 11, limb3_U_v_0);
    const REAL t102 = limb3_U_v_0 - platform_twist_wx, minus_limb3_lower_sin = SINES(sine, 5),
      limb3_lower_cos = SINES(cosine, 5), limb3_U_v_1 = READ(v, 7);
    WRITE(rates, 12, limb3_U_v_1);
    const REAL limb3_U_0_cos = SINES(cosine, 4), t103 = (0.5 * minus_limb3_lower_sin + k1 * limb3_lower_cos) * t102,
      t107 = platform_twist_wy - limb3_U_v_1 * limb3_U_0_cos, limb4_U_v_0 = READ(v, 9);
    WRITE(rates, 17, limb4_U_v_0);
    const REAL t143 = limb4_U_v_0 - platform_twist_wy, /* limb4 */
      limb3_U_0_sin = SINES(sine, 4), minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos,
      t104 = 0.5 * minus_limb3_lower_rotation_yx, t122 = k1 * minus_limb3_lower_rotation_yx,
      minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin,
      t109 = t103 - (t104 - k1 * minus_limb3_lower_rotation_yy) * t107,
      t125 = (t122 + 0.5 * minus_limb3_lower_rotation_yy) * t107, t116 = limb3_U_0_cos * t107,
      t113 = platform_twist_wz - limb3_U_v_1 * limb3_U_0_sin,
      limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos, t110 = 0.5 * limb3_lower_rotation_zx,
      t127 = k1 * limb3_lower_rotation_zx, limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin,
      t115 = t109 + (t110 - k1 * limb3_lower_rotation_zy) * t113;
    checked1 = checked1 + t115;
    WRITE(rates, 14, -t115);
    const REAL t130 = (t127 + 0.5 * limb3_lower_rotation_zy) * t113;
    RESULT(checked2, rates, 15, t116 + limb3_U_0_sin * t113);
    RESULT(checked3, rates, 16, (k1 * minus_limb3_lower_sin - 0.5 * limb3_lower_cos) * t102 - t125 + t130);
    /* limb4: velocities, eq. (6); geometry; results */
    const REAL limb4_U_v_1 = READ(v, 10);
    WRITE(rates, 18, limb4_U_v_1);
    const REAL limb4_U_0_sin = SINES(cosine, 6), t131 = platform_twist_wx - limb4_U_v_1 * limb4_U_0_sin,
      minus_limb4_U_0_cos = SINES(sine, 6);
    /* limb4: results; geometry */
    const REAL t132 = limb4_U_0_sin * t131, t133 = platform_twist_wz + limb4_U_v_1 * minus_limb4_U_0_cos;
    RESULT(checked0, rates, 20, t132 - minus_limb4_U_0_cos * t133);
    const REAL limb4_lower_cos = SINES(cosine, 7),
      minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos, minus_limb4_lower_sin = SINES(sine, 7),
      t136 = 0.5 * minus_limb4_lower_rotation_xx, t150 = k1 * minus_limb4_lower_rotation_xx,
      minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin,
      t139 = (t136 + k1 * minus_limb4_lower_rotation_xy) * t131,
      t153 = (t150 - 0.5 * minus_limb4_lower_rotation_xy) * t131,
      t145 = t139 - (0.5 * minus_limb4_lower_sin - k1 * limb4_lower_cos) * t143,
      minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos, t146 = 0.5 * minus_limb4_lower_rotation_zx,
      t159 = k1 * minus_limb4_lower_rotation_zx,
      minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin;
    RESULT(checked1, rates, 21, t145 + (t146 + k1 * minus_limb4_lower_rotation_zy) * t133);
    const REAL t162 = (t159 - 0.5 * minus_limb4_lower_rotation_zy) * t133,
      t163 = t153 - (k1 * minus_limb4_lower_sin + 0.5 * limb4_lower_cos) * t143 + t162;
    checked2 = checked2 + t163;
    WRITE(rates, 22, -t163);
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
    /* else status 5: no rotation */
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
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
#endif

#if !defined(THREE_UPS_UPU_S_VECTORS) || (defined(THREE_UPS_UPU_S_LANES) && THREE_UPS_UPU_S_LANES == 4)
typedef struct {
    EACH4 signed_U_0_sin, signed_U_0_cos, signed_lower_sin, signed_lower_cos, t1, t2, checked;
} LIMBS(inverse_kinematics);

STAGE(inverse_kinematics, 0)(size_t limb, size_t stride, double *restrict q, const EACH4 given,
    const EACH4 given_2, const EACH4 given_3, const EACH4 given_4, const EACH4 given_5, const EACH4 given_6,
    LIMBS(inverse_kinematics) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, -1.0, -1.0),
      each_param_R = sign2 * param_R, each_k1 = sign2 * k1, factor_2 = sign2 * 0.5;
    /* each limb: geometry; reciprocal wrenches, eq. (10); results */
    const LIMB4 signed_lower_limb_target_x = GIVEN(given) - sign1 * GIVEN(given_2),
      t1 = signed_lower_limb_target_x * signed_lower_limb_target_x,
      signed_lower_limb_target_y = GIVEN(given_3) - sign1 * GIVEN(given_4),
      t3 = t1 + signed_lower_limb_target_y * signed_lower_limb_target_y, signed_U_0_lever_mz_by_S_fz = SQRT4(t3),
      t4 = 1.0 / signed_U_0_lever_mz_by_S_fz;
    OWN(signed_U_0_sin) = signed_lower_limb_target_x * t4;
    OWN(signed_U_0_cos) = signed_lower_limb_target_y * t4;
    const LIMB4 signed_lower_limb_target_z = GIVEN(given_5) - sign1 * GIVEN(given_6) + each_param_R,
      lower_limb_length = SQRT4(t3 + signed_lower_limb_target_z * signed_lower_limb_target_z),
      P_q = lower_limb_length + (-limb_upper_phase);
    WRITE4(q, 2, 5, 8, 11, P_q);
    LIMB4 checked = P_q;
    const LIMB4 t7 = 1.0 / lower_limb_length;
    OWN(signed_lower_sin) = signed_lower_limb_target_z * t7;
    OWN(signed_lower_cos) = signed_U_0_lever_mz_by_S_fz * t7;
    const LIMB4 t11 = factor_2 * OWN(signed_lower_sin);
    OWN(t1) = each_k1 * OWN(signed_lower_sin) - 0.5 * OWN(signed_lower_cos);
    OWN(t2) = k1 * OWN(signed_lower_cos) + t11;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_inverse_kinematics)(size_t stride, const double *restrict pose, double *restrict q,
    double *restrict total)
{
    LIMBS(inverse_kinematics) limbs;
    /* limb5_S: geometry */
    const REAL limb5_S_pose_qw = READ(pose, 0);
    WRITE(q, 12, limb5_S_pose_qw);
    const REAL limb5_S_pose_qx = READ(pose, 1);
    WRITE(q, 13, limb5_S_pose_qx);
    const REAL t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx,
      limb5_S_pose_qy = READ(pose, 2);
    WRITE(q, 14, limb5_S_pose_qy);
    const REAL t3 = t1 + t2, t4 = limb5_S_pose_qy * limb5_S_pose_qy, limb5_S_pose_qz = READ(pose, 3);
    WRITE(q, 15, limb5_S_pose_qz);
    const REAL t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7, t30 = t2 + t5,
      t21 = param_H * (1.0 - t9 * (t2 + t4)), platform_turn_yy = 1.0 - t9 * t30, t29 = 0.5 * (1.0 - t6 * t9),
      t10 = limb5_S_pose_qy * t9, t11 = limb5_S_pose_qx * t10, t24 = limb5_S_pose_qw * t10,
      t12 = limb5_S_pose_qz * t9, t17 = limb5_S_pose_qw * (limb5_S_pose_qx * t9), t13 = limb5_S_pose_qw * t12,
      platform_turn_yx = t11 + t13, platform_turn_xy = t11 - t13, t14 = 0.5 * platform_turn_yx;
    const EACH4 given = {t14, t21, t14, t21};
    const REAL t15 = limb5_S_pose_qy * t12, t23 = limb5_S_pose_qx * t12, platform_turn_yz = t15 - t17,
      platform_turn_zy = t15 + t17, t18 = param_H * platform_turn_yz;
    const EACH4 given_6 = {t29, t18, t29, t18};
    const REAL t22 = 0.5 * platform_turn_zy;
    const EACH4 given_2 = {t18, t22, t18, t22};
    const REAL platform_turn_xz = t23 + t24, t25 = 0.5 * (t23 - t24), t26 = param_H * platform_turn_xz;
    const EACH4 given_3 = {t25, t26, t25, t26};
    const REAL t27 = 0.5 * platform_turn_xy;
    const EACH4 given_4 = {t21, t27, t21, t27};
    const REAL t32 = 0.5 * platform_turn_yy;
    const EACH4 given_5 = {t26, t32, t26, t32};
    FIRST_LIMB(0, inverse_kinematics, 0, stride, q, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    REAL checked0 = ALONE(limbs.checked[0]);
    const REAL t36 = limbs.signed_lower_sin[0] * (platform_turn_yy * limbs.signed_U_0_sin[0] + platform_turn_zy * limbs.signed_U_0_cos[0]), /* limb1 */
      limb1_U2_opening_mn = t36 + platform_turn_xy * limbs.signed_lower_cos[0],
      t38 = limb1_U2_opening_mn * limb1_U2_opening_mn, limb1_U_q_1 = atan2(limbs.t1[0], limbs.t2[0]);
    WRITE(q, 1, limb1_U_q_1);
    REAL checked1 = limb1_U_q_1;
    NEXT_LIMB(3, inverse_kinematics, 0, stride, q, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    REAL checked2 = ALONE(limbs.checked[3]);
    const REAL limb4_U_q_1 = atan2(limbs.t1[3], limbs.t2[3]);
    WRITE(q, 10, limb4_U_q_1);
    REAL checked3 = limb4_U_q_1;
    RESULT(checked0, q, 9, atan2(limbs.signed_U_0_cos[3], limbs.signed_U_0_sin[3]));
    NEXT_LIMB(2, inverse_kinematics, 0, stride, q, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    checked1 = checked1 + ALONE(limbs.checked[2]);
    NEXT_LIMB(1, inverse_kinematics, 0, stride, q, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[1]);
    RESULT(checked3, q, 3, atan2(limbs.signed_U_0_cos[1], limbs.signed_U_0_sin[1]));
    RESULT(checked0, q, 7, atan2(-limbs.t1[2], limbs.t2[2]));
    RESULT(checked1, q, 6, atan2(-limbs.signed_U_0_sin[2], limbs.signed_U_0_cos[2]));
    RESULT(checked2, q, 4, atan2(-limbs.t1[1], limbs.t2[1]));
    RESULT(checked3, q, 0, atan2(limbs.signed_U_0_sin[0], -limbs.signed_U_0_cos[0]));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    /* else status 6: not on the mechanism */
    NOT_ABOVE(t38, 1.0e-12, 6);
    FINITE4((checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES)
BODY(three_ups_upu_s_drive_positions)(size_t stride, const double *restrict pose, double *restrict positions,
    double *restrict total)
{
    /* limb5_S: geometry */
    const REAL limb5_S_pose_qw = READ(pose, 0), limb5_S_pose_qx = READ(pose, 1),
      t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx, limb5_S_pose_qy = READ(pose, 2),
      t3 = t1 + t2, t4 = limb5_S_pose_qy * limb5_S_pose_qy, limb5_S_pose_qz = READ(pose, 3),
      t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7, t38 = t2 + t5,
      t25 = param_H * (1.0 - t9 * (t2 + t4)), t29 = 0.5 * (1.0 - t6 * t9), platform_turn_yy = 1.0 - t9 * t38,
      t10 = limb5_S_pose_qy * t9, t11 = limb5_S_pose_qx * t10, t21 = limb5_S_pose_qw * t10,
      t12 = limb5_S_pose_qz * t9, t17 = limb5_S_pose_qw * (limb5_S_pose_qx * t9), t13 = limb5_S_pose_qw * t12,
      platform_turn_yx = t11 + t13, platform_turn_xy = t11 - t13, t14 = 0.5 * platform_turn_yx,
      t15 = limb5_S_pose_qy * t12, t20 = limb5_S_pose_qx * t12, platform_turn_yz = t15 - t17,
      platform_turn_zy = t15 + t17, t18 = param_H * platform_turn_yz, minus_limb1_lower_limb_target_x = t14 - t18,
      limb3_lower_limb_target_x = t14 + t18,
      t43 = limb3_lower_limb_target_x * limb3_lower_limb_target_x, /* limb3 */
      t19 = minus_limb1_lower_limb_target_x * minus_limb1_lower_limb_target_x, /* limb1 */
      t53 = platform_turn_yy * minus_limb1_lower_limb_target_x, /* limb1 */
      t40 = 0.5 * platform_turn_yy, platform_turn_xz = t20 + t21, t22 = 0.5 * (t20 - t21),
      t30 = param_H * platform_turn_xz, minus_limb1_lower_limb_target_y = t22 - t25,
      limb3_lower_limb_target_y = t22 + t25,
      t45 = t43 + limb3_lower_limb_target_y * limb3_lower_limb_target_y, /* limb3 */
      t27 = t19 + minus_limb1_lower_limb_target_y * minus_limb1_lower_limb_target_y, /* limb1 */
      t55 = t53 + platform_turn_zy * minus_limb1_lower_limb_target_y, /* limb1 */
      t33 = 0.5 * platform_turn_zy;
    /* limb1: geometry; results; loop closure */
    const REAL limb1_lower_limb_target_z = param_R - (t29 - t30),
      minus_limb3_lower_limb_target_z = param_R - (t29 + t30),
      limb3_P_positions = SQRT(t45 + minus_limb3_lower_limb_target_z * minus_limb3_lower_limb_target_z) - limb_upper_phase;
    WRITE(positions, 2, limb3_P_positions);
    REAL checked0 = limb3_P_positions;
    const REAL limb1_lower_limb_length = SQRT(t27 + limb1_lower_limb_target_z * limb1_lower_limb_target_z),
      limb1_P_positions = limb1_lower_limb_length - limb_upper_phase;
    WRITE(positions, 0, limb1_P_positions);
    REAL checked1 = limb1_P_positions;
    const REAL minus_limb1_U_0_lever_mz_by_limb1_U2_fz = SQRT(t27),
      t57 = limb1_lower_limb_target_z * (t55 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz),
      limb1_U2_opening_mn = (t57 + platform_turn_xy * minus_limb1_U_0_lever_mz_by_limb1_U2_fz) / limb1_lower_limb_length,
      t60 = limb1_U2_opening_mn * limb1_U2_opening_mn, t35 = 0.5 * platform_turn_xy, /* platform */
      limb2_lower_limb_target_x = t25 - t33, limb4_lower_limb_target_x = t25 + t33,
      t34 = limb2_lower_limb_target_x * limb2_lower_limb_target_x, /* limb2 */
      t48 = limb4_lower_limb_target_x * limb4_lower_limb_target_x, /* limb4 */
      limb2_lower_limb_target_y = t30 - t35, limb4_lower_limb_target_y = t30 + t35,
      t37 = t34 + limb2_lower_limb_target_y * limb2_lower_limb_target_y, /* limb2 */
      t50 = t48 + limb4_lower_limb_target_y * limb4_lower_limb_target_y, /* limb4 */
      limb4_upper_position_y = t18 + t40, limb2_lower_limb_target_z = param_R + (t18 - t40),
      limb2_P_positions = SQRT(t37 + limb2_lower_limb_target_z * limb2_lower_limb_target_z) - limb_upper_phase;
    WRITE(positions, 1, limb2_P_positions);
    REAL checked2 = limb2_P_positions;
    const REAL minus_limb4_lower_limb_target_z = param_R - limb4_upper_position_y,
      limb4_P_positions = SQRT(t50 + minus_limb4_lower_limb_target_z * minus_limb4_lower_limb_target_z) - limb_upper_phase;
    WRITE(positions, 3, limb4_P_positions);
    REAL checked3 = limb4_P_positions;
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    /* else status 6: not on the mechanism */
    NOT_ABOVE(t60, 1.0e-12, 6);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}
#endif

#if !defined(THREE_UPS_UPU_S_LANES) || THREE_UPS_UPU_S_LANES == 4
typedef struct {
    EACH4 signed_lower_limb_target_x, signed_lower_limb_target_y, signed_U_0_lever_mz_by_S_fz, t1,
      signed_upper_position_x, signed_U_0_cos, signed_U_0_sin, lower_limb_length, t2, signed_lower_sin,
      signed_lower_cos, checked;
} LIMBS(inverse_velocity);

STAGE(inverse_velocity, 0)(size_t limb, size_t stride, const EACH4 given, const EACH4 given_2,
    const EACH4 given_3, const EACH4 given_4, const EACH4 given_5, const EACH4 given_6,
    LIMBS(inverse_velocity) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), sign2 = OF4(1.0, -1.0, 1.0, 1.0),
      each_param_R = -sign2 * param_R;
    /* each limb: geometry; reciprocal wrenches, eq. (10) */
    OWN(signed_lower_limb_target_x) = GIVEN(given) - sign1 * GIVEN(given_2);
    const LIMB4 t1 = OWN(signed_lower_limb_target_x) * OWN(signed_lower_limb_target_x);
    OWN(signed_lower_limb_target_y) = GIVEN(given_3) - sign1 * GIVEN(given_4);
    const LIMB4 t3 = t1 + OWN(signed_lower_limb_target_y) * OWN(signed_lower_limb_target_y);
    OWN(signed_U_0_lever_mz_by_S_fz) = SQRT4(t3);
    OWN(t1) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(signed_U_0_cos) = OWN(signed_lower_limb_target_y) * OWN(t1);
    OWN(signed_U_0_sin) = OWN(signed_lower_limb_target_x) * OWN(t1);
    OWN(signed_upper_position_x) = GIVEN(given_5) - sign1 * GIVEN(given_6);
    const LIMB4 signed_lower_limb_target_z = OWN(signed_upper_position_x) + each_param_R;
    OWN(lower_limb_length) = SQRT4(t3 + signed_lower_limb_target_z * signed_lower_limb_target_z);
    LIMB4 checked = OWN(lower_limb_length);
    OWN(t2) = 1.0 / OWN(lower_limb_length);
    OWN(signed_lower_sin) = signed_lower_limb_target_z * OWN(t2);
    OWN(signed_lower_cos) = OWN(signed_U_0_lever_mz_by_S_fz) * OWN(t2);
    OWN(checked) = checked;
}

STAGE(inverse_velocity, 1)(size_t limb, size_t stride, double *restrict v, const EACH4 platform_twist_wz,
    const EACH4 platform_twist_wx, const EACH4 platform_twist_wy, LIMBS(inverse_velocity) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, 1.0);
    /* each limb: loop closure; velocities, eq. (6) */
    const LIMB4 t1 = OWN(signed_upper_position_x) * GIVEN(platform_twist_wz),
      t3 = t1 - OWN(signed_lower_limb_target_y) * GIVEN(platform_twist_wx), t9 = t3 * OWN(signed_U_0_sin),
      t4 = t3 * OWN(signed_U_0_cos), t6 = OWN(signed_upper_position_x) * GIVEN(platform_twist_wy),
      t7 = t6 - OWN(signed_lower_limb_target_x) * GIVEN(platform_twist_wx), t11 = t9 - t7 * OWN(signed_U_0_cos),
      minus_U_0_omega_z = OWN(t1) * (t4 + t7 * OWN(signed_U_0_sin));
    WRITE4(v, 0, 3, 6, 9, -minus_U_0_omega_z);
    LIMB4 checked = OWN(checked) + minus_U_0_omega_z;
    const LIMB4 t17 = OWN(signed_lower_cos) * t11, t12 = OWN(signed_lower_sin) * t11,
      t14 = OWN(signed_lower_limb_target_x) * GIVEN(platform_twist_wz),
      t15 = t14 - OWN(signed_lower_limb_target_y) * GIVEN(platform_twist_wy),
      minus_S_opening_rate_fx = t17 - t15 * OWN(signed_lower_sin);
    WRITE4(v, 2, 5, 8, 11, minus_S_opening_rate_fx);
    checked = checked + minus_S_opening_rate_fx;
    const LIMB4 signed_lower_omega_z = OWN(t2) * (t12 + t15 * OWN(signed_lower_cos));
    WRITE4(v, 1, 4, 7, 10, sign1 * signed_lower_omega_z);
    checked = checked + signed_lower_omega_z;
    OWN(checked) = checked;
}

BODY(three_ups_upu_s_inverse_velocity)(size_t stride, const double *restrict pose,
    const double *restrict rate, double *restrict v, double *restrict total)
{
    LIMBS(inverse_velocity) limbs;
    /* limb5_S: geometry; velocities, eq. (6) */
    const REAL limb5_S_pose_qw = READ(pose, 0), limb5_S_pose_qx = READ(pose, 1),
      t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx, limb5_S_pose_qy = READ(pose, 2),
      t3 = t1 + t2, t4 = limb5_S_pose_qy * limb5_S_pose_qy, limb5_S_pose_qz = READ(pose, 3),
      t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7, t30 = t2 + t5,
      platform_turn_zz = 1.0 - t9 * (t2 + t4), platform_turn_xx = 1.0 - t6 * t9, platform_turn_yy = 1.0 - t9 * t30,
      t12 = limb5_S_pose_qz * t9, t23 = limb5_S_pose_qx * t12, t10 = limb5_S_pose_qy * t9,
      t17 = limb5_S_pose_qw * (limb5_S_pose_qx * t9), t24 = limb5_S_pose_qw * t10, t11 = limb5_S_pose_qx * t10,
      platform_turn_zx = t23 - t24, platform_turn_xz = t23 + t24, limb5_S_rate_wx = READ(rate, 0);
    WRITE(v, 12, limb5_S_rate_wx);
    const REAL t34 = limb5_S_rate_wx * platform_turn_zx, t25 = 0.5 * platform_turn_zx, t15 = limb5_S_pose_qy * t12,
      t13 = limb5_S_pose_qw * t12, platform_turn_zy = t15 + t17, platform_turn_yz = t15 - t17,
      limb5_S_rate_wy = READ(rate, 1);
    WRITE(v, 13, limb5_S_rate_wy);
    const REAL limb5_S_rate_wz = READ(rate, 2);
    WRITE(v, 14, limb5_S_rate_wz);
    const REAL platform_twist_wz = limb5_S_rate_wz * platform_turn_zz + (t34 + limb5_S_rate_wy * platform_turn_zy),
      t21 = param_H * platform_turn_zz, platform_turn_xy = t11 - t13, platform_turn_yx = t11 + t13,
      t39 = limb5_S_rate_wx * platform_turn_xx + limb5_S_rate_wy * platform_turn_xy, t29 = 0.5 * platform_turn_xx,
      platform_twist_wx = t39 + limb5_S_rate_wz * platform_turn_xz, t26 = param_H * platform_turn_xz;
    const EACH4 given_3 = {t25, t26, t25, t26},
      platform_twist_wz_2 = {platform_twist_wz, platform_twist_wx, platform_twist_wz, platform_twist_wx};
    const REAL t42 = limb5_S_rate_wx * platform_turn_yx, t14 = 0.5 * platform_turn_yx;
    const EACH4 given = {t14, t21, t14, t21};
    const REAL platform_twist_wy = limb5_S_rate_wy * platform_turn_yy + t42 + limb5_S_rate_wz * platform_turn_yz;
    const EACH4 platform_twist_wx_2 = {platform_twist_wx, platform_twist_wy, platform_twist_wx, platform_twist_wy},
      platform_twist_wy_2 = {platform_twist_wy, platform_twist_wz, platform_twist_wy, platform_twist_wz};
    const REAL t18 = param_H * platform_turn_yz;
    const EACH4 given_5 = {t29, t18, t29, t18};
    const REAL t22 = 0.5 * platform_turn_zy;
    const EACH4 given_2 = {t18, t22, t18, t22};
    const REAL t27 = 0.5 * platform_turn_xy;
    const EACH4 given_4 = {t21, t27, t21, t27};
    const REAL t32 = 0.5 * platform_turn_yy;
    const EACH4 given_6 = {t26, t32, t26, t32};
    FIRST_LIMB(3, inverse_velocity, 0, stride, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    FIRST_LIMB(3, inverse_velocity, 1, stride, v, platform_twist_wz_2, platform_twist_wx_2, platform_twist_wy_2, &limbs);
    REAL checked0 = ALONE(limbs.checked[3]);
    NEXT_LIMB(2, inverse_velocity, 0, stride, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    NEXT_LIMB(2, inverse_velocity, 1, stride, v, platform_twist_wz_2, platform_twist_wx_2, platform_twist_wy_2, &limbs);
    REAL checked1 = ALONE(limbs.checked[2]);
    NEXT_LIMB(1, inverse_velocity, 0, stride, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    NEXT_LIMB(0, inverse_velocity, 0, stride, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    NEXT_LIMB(1, inverse_velocity, 1, stride, v, platform_twist_wz_2, platform_twist_wx_2, platform_twist_wy_2, &limbs);
    REAL checked2 = ALONE(limbs.checked[1]);
    NEXT_LIMB(0, inverse_velocity, 1, stride, v, platform_twist_wz_2, platform_twist_wx_2, platform_twist_wy_2, &limbs);
    REAL checked3 = ALONE(limbs.checked[0]);
    const REAL t48 = limbs.signed_lower_sin[0] * (platform_turn_yy * limbs.signed_U_0_sin[0] + platform_turn_zy * limbs.signed_U_0_cos[0]), /* limb1 */
      limb1_U2_opening_mn = platform_turn_xy * limbs.signed_lower_cos[0] - t48,
      t50 = limb1_U2_opening_mn * limb1_U2_opening_mn;
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    /* else status 6: not on the mechanism */
    NOT_ABOVE(t50, 1.0e-12, 6);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.lower_limb_length, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR /* where the points of limb_lower coincide */
        SMALL4(limbs.signed_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10), /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
        (checked0 + checked1) + (checked2 + checked3), limbs.checked);
}
#endif

#if !defined(THREE_UPS_UPU_S_VECTORS)

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
#define THREE_UPS_UPU_S_VECTORS
#define THREE_UPS_UPU_S_LANES 4
#include "three_ups_upu_s_support.h" /* for all limbs at once */
#include "three_ups_upu_s_kinematics.c"
#undef THREE_UPS_UPU_S_VECTORS
#undef THREE_UPS_UPU_S_LANES
#include "three_ups_upu_s_support.h" /* for one limb again */
#endif

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
    const REAL limb5_S_q_qw = READ(q, 12);
    REAL checked0 = limb5_S_q_qw;
    const REAL limb5_S_q_qx = READ(q, 13), t2 = limb5_S_q_qw * limb5_S_q_qw, t3 = limb5_S_q_qx * limb5_S_q_qx,
      limb5_S_q_qy = READ(q, 14), t4 = t2 + t3, t5 = limb5_S_q_qy * limb5_S_q_qy, limb5_S_q_qz = READ(q, 15),
      t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7, t10 = 4.0 - 2.0 * t8,
      platform_turn_xx = 1.0 - t7 * t10, t39 = t3 + t5, platform_turn_yy = 1.0 - t10 * (t3 + t6), t515 = t6 + t39,
      platform_turn_zz = 1.0 - t10 * t39, t516 = SQRT(t515), t13 = limb5_S_q_qz * t10, t19 = limb5_S_q_qy * t13,
      t21 = limb5_S_q_qw * (limb5_S_q_qx * t10), t11 = limb5_S_q_qy * t10, platform_turn_zy = t19 + t21,
      platform_turn_yz = t19 - t21, limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_cos = SINES(cosine, 1),
      t24 = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos * platform_turn_zy), /* limb1 */
      t12 = limb5_S_q_qx * t11, t32 = limb5_S_q_qw * t11, t14 = limb5_S_q_qw * t13, t31 = limb5_S_q_qx * t13,
      platform_turn_xy = t12 - t14, platform_turn_yx = t12 + t14;
    /* limb1: geometry; reciprocal wrenches, eq. (10) */
    const REAL limb1_lower_sin = SINES(sine, 1),
      minus_limb1_U2_constraint_mn_couple_z = limb1_lower_sin * platform_turn_xy - t24;
    /* limb1: results; geometry */
    const REAL limb1_U2_displacements_0 = atan2(minus_limb1_U2_constraint_mn_couple_z, limb1_U_0_cos * platform_turn_yy + limb1_U_0_sin * platform_turn_zy);
    WRITE(displacements, 3, limb1_U2_displacements_0);
    REAL checked1 = limb1_U2_displacements_0;
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin,
      t37 = platform_turn_yz * limb1_lower_rotation_yy,
      t30 = limb1_lower_cos * platform_turn_xx + platform_turn_yx * limb1_lower_rotation_yy,
      platform_turn_zx = t31 - t32, platform_turn_xz = t31 + t32,
      minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin,
      t34 = t30 - platform_turn_zx * minus_limb1_lower_rotation_zy, t35 = 0.5 * t34, t46 = k1 * t34,
      t42 = limb1_lower_cos * platform_turn_xz + t37 - platform_turn_zz * minus_limb1_lower_rotation_zy,
      t49 = atan2(-(t35 + k1 * t42), t46 - 0.5 * t42);
    REAL checked2 = t49;
    WRITE(displacements, 4, -t49);
    /* platform: results */
    const REAL t51 = 0.5 * platform_turn_zy, t52 = k1 * platform_turn_zz, t73 = 0.5 * platform_turn_zz,
      t53 = t51 + t52, t366 = t51 - t52, limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2),
      t54 = limb2_U_0_sin * t53, /* limb2 */
      t144 = minus_limb2_U_0_cos * t53, /* limb2 */
      t55 = 0.5 * platform_turn_xy, t56 = k1 * platform_turn_xz, t77 = 0.5 * platform_turn_xz, t57 = t55 + t56,
      t368 = t55 - t56, t59 = t54 + minus_limb2_U_0_cos * t57, /* limb2 */
      t146 = t144 - limb2_U_0_sin * t57, /* limb2 */
      limb2_lower_cos = SINES(cosine, 3), limb2_lower_sin = SINES(sine, 3),
      t60 = limb2_lower_cos * t59, /* limb2 */
      t67 = limb2_lower_sin * t59, /* limb2 */
      t62 = k1 * platform_turn_yz, t83 = 0.5 * platform_turn_yz, t61 = 0.5 * platform_turn_yy, t63 = t61 + t62,
      t372 = t61 - t62;
    /* limb2: results */
    const REAL t65 = t60 - limb2_lower_sin * t63, t69 = t67 + limb2_lower_cos * t63, t66 = k1 * t65,
      t98 = 0.5 * t65 + k1 * t69, t71 = t66 - 0.5 * t69, t99 = 0.5 * t98, t163 = k1 * t98,
      t74 = k1 * platform_turn_zy, /* platform */
      t75 = t73 - t74, /* platform */
      t382 = t73 + t74, /* platform */
      t76 = limb2_U_0_sin * t75, t148 = minus_limb2_U_0_cos * t75, t78 = k1 * platform_turn_xy, /* platform */
      t79 = t77 - t78, /* platform */
      t384 = t77 + t78, /* platform */
      t81 = t76 + minus_limb2_U_0_cos * t79, t150 = t148 - limb2_U_0_sin * t79, t82 = limb2_lower_cos * t81,
      t89 = limb2_lower_sin * t81, t84 = k1 * platform_turn_yy, /* platform */
      t85 = t83 - t84, /* platform */
      t388 = t83 + t84, /* platform */
      t87 = t82 - limb2_lower_sin * t85, t91 = t89 + limb2_lower_cos * t85, t88 = k1 * t87,
      t102 = 0.5 * t87 + k1 * t91, t93 = t88 - 0.5 * t91, t104 = t99 - k1 * t102, t165 = t163 + 0.5 * t102,
      t107 = minus_limb2_U_0_cos * platform_turn_zx - limb2_U_0_sin * platform_turn_xx, t109 = t104 - (1.0 - t107),
      t166 = 0.5 * t71, t95 = k1 * t71 + 0.5 * t93, t111 = -(t95 + t109), t168 = t166 - k1 * t93,
      t116 = t95 + (t104 + (t107 + (1.0 - 2.0 * t107))), t117 = LESS(t111, t116), t118 = SELECT(t117, t116, t111),
      t123 = t95 + (t104 + (t107 + (1.0 - 2.0 * t104))), t124 = LESS(t118, t123), t125 = SELECT(t124, t123, t118),
      t130 = t95 + (t104 + (t107 + (1.0 - 2.0 * t95))), t131 = LESS(t125, t130),
      t176 = 1.0 / (2.0 * SQRT(SELECT(t131, t130, t125))), t169 = t165 - t168, t170 = SELECT(t117, t116, t169),
      t180 = SELECT(t117, t169, t111), t188 = -(t165 + t168),
      t134 = limb2_U_0_sin * platform_turn_zx + minus_limb2_U_0_cos * platform_turn_xx, t139 = limb2_lower_sin * t134,
      t137 = limb2_lower_cos * t134 - limb2_lower_sin * platform_turn_yx, t155 = 0.5 * t137, t138 = k1 * t137,
      t141 = t139 + limb2_lower_cos * platform_turn_yx, t157 = t155 + k1 * t141, t143 = t138 - 0.5 * t141,
      t147 = k1 * t146, t160 = 0.5 * t146 - k1 * t150, t152 = t147 + 0.5 * t150, t161 = t157 + t160,
      t178 = t160 - t157, t162 = -t161, t171 = SELECT(t124, t162, t170), t153 = t143 + t152, t179 = t143 - t152,
      t154 = -t153, t177 = SELECT(t131, t154, t171) * t176,
      t197 = SELECT(t131, t130, SELECT(t124, t188, SELECT(t117, t154, t178))),
      t182 = SELECT(t131, t178, SELECT(t124, t179, t180)),
      t192 = SELECT(t131, t188, SELECT(t124, t123, SELECT(t117, t162, t179))) * t176, t198 = t197 * t176,
      t183 = t182 * t176, t201 = SQRT(t177 * t177 + t192 * t192 + t198 * t198),
      t185 = SELECT(LESS(t183, 0.0), (-1.0), 1.0), t205 = 2.0 * atan2(t201, t183 * t185), t202 = LESS(t201, 1.0e-08),
      t209 = t185 * SELECT(t202, 2.0, t205 / SELECT(t202, 1.0, t201)), limb2_S_displacements_x = t177 * t209;
    WRITE(displacements, 8, limb2_S_displacements_x);
    REAL checked3 = limb2_S_displacements_x;
    RESULT(checked0, displacements, 9, t192 * t209);
    RESULT(checked1, displacements, 10, t198 * t209);
    const REAL t212 = 0.5 * platform_turn_yx - t62; /* platform */
    /* limb3: geometry */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    /* limb3: results; geometry */
    const REAL t213 = limb3_U_0_sin * t212, t308 = limb3_U_0_cos * t212,
      t215 = 0.5 * platform_turn_zx - t52, /* platform */
      t217 = t213 - limb3_U_0_cos * t215, t310 = t308 + limb3_U_0_sin * t215, limb3_lower_cos = SINES(cosine, 5),
      minus_limb3_lower_sin = SINES(sine, 5), t218 = limb3_lower_cos * t217, t224 = minus_limb3_lower_sin * t217,
      t220 = 0.5 * platform_turn_xx - t56, /* platform */
      t222 = t218 + minus_limb3_lower_sin * t220, t226 = t224 - limb3_lower_cos * t220, t223 = k1 * t222,
      t255 = 0.5 * t222 - k1 * t226, t228 = t223 + 0.5 * t226, t256 = 0.5 * t255, t288 = k1 * t255,
      t231 = k1 * platform_turn_yx + t83, /* platform */
      t232 = limb3_U_0_sin * t231, t312 = limb3_U_0_cos * t231, t234 = k1 * platform_turn_zx + t73, /* platform */
      t236 = t232 - limb3_U_0_cos * t234, t314 = t312 + limb3_U_0_sin * t234, t237 = limb3_lower_cos * t236,
      t243 = minus_limb3_lower_sin * t236, t239 = k1 * platform_turn_xx + t77, /* platform */
      t241 = t237 + minus_limb3_lower_sin * t239, t245 = t243 - limb3_lower_cos * t239, t242 = k1 * t241,
      t259 = 0.5 * t241 - k1 * t245, t247 = t242 + 0.5 * t245, t261 = t256 + k1 * t259, t290 = t288 - 0.5 * t259,
      t267 = t261 - (1.0 + 2.0 * t261), t297 = limb3_U_0_cos * platform_turn_zy,
      t252 = limb3_U_0_cos * platform_turn_yy + limb3_U_0_sin * platform_turn_zy, t268 = t252 + t267,
      t298 = limb3_U_0_sin * platform_turn_yy - t297, t291 = 0.5 * t228, t249 = k1 * t228 - 0.5 * t247,
      t270 = -(t249 + t268), t293 = t291 + k1 * t247, t264 = t249 + (t252 + (1.0 + t261)), t271 = LESS(t264, t270),
      t272 = SELECT(t271, t270, t264), t278 = -(t249 + (t252 + (t261 - (1.0 + 2.0 * t252)))), t279 = LESS(t272, t278),
      t280 = SELECT(t279, t278, t272), t286 = -(t249 + (t252 + (t261 - (1.0 + 2.0 * t249)))), t287 = LESS(t280, t286),
      t331 = 1.0 / (2.0 * SQRT(SELECT(t287, t286, t280))), t311 = 0.5 * t310, t320 = k1 * t310 - 0.5 * t314,
      t316 = t311 + k1 * t314, t303 = minus_limb3_lower_sin * t298,
      t301 = limb3_lower_cos * t298 + minus_limb3_lower_sin * platform_turn_xy,
      t305 = t303 - limb3_lower_cos * platform_turn_xy, t302 = 0.5 * t301, t323 = k1 * t301 + 0.5 * t305,
      t307 = t302 - k1 * t305, t324 = t320 - t323, t325 = SELECT(t271, t270, t324), t335 = SELECT(t271, t324, t264),
      t343 = -(t323 + t320), t317 = t307 + t316, t333 = t316 - t307, t326 = SELECT(t279, t317, t325),
      t294 = t290 + t293, t334 = t293 - t290, t295 = -t294, t332 = SELECT(t287, t295, t326) * t331,
      t352 = SELECT(t287, t286, SELECT(t279, t343, SELECT(t271, t295, t333))),
      t337 = SELECT(t287, t333, SELECT(t279, t334, t335)),
      t347 = SELECT(t287, t343, SELECT(t279, t278, SELECT(t271, t317, t334))) * t331, t353 = t352 * t331,
      t338 = t337 * t331, t356 = SQRT(t332 * t332 + t347 * t347 + t353 * t353),
      t340 = SELECT(LESS(t338, 0.0), (-1.0), 1.0), t360 = 2.0 * atan2(t356, t338 * t340), t357 = LESS(t356, 1.0e-08),
      t364 = t340 * SELECT(t357, 2.0, t360 / SELECT(t357, 1.0, t356));
    RESULT(checked2, displacements, 14, t332 * t364);
    RESULT(checked3, displacements, 15, t347 * t364);
    RESULT(checked0, displacements, 16, t353 * t364);
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    /* limb4: results; geometry */
    const REAL t437 = minus_limb4_U_0_cos * t366, t370 = limb4_U_0_sin * t366 + minus_limb4_U_0_cos * t368,
      t439 = t437 - limb4_U_0_sin * t368, limb4_lower_cos = SINES(cosine, 7), minus_limb4_lower_sin = SINES(sine, 7),
      t376 = minus_limb4_lower_sin * t370, t374 = limb4_lower_cos * t370 + minus_limb4_lower_sin * t372,
      t378 = t376 - limb4_lower_cos * t372, t375 = k1 * t374, t401 = 0.5 * t374 + k1 * t378, t380 = t375 - 0.5 * t378,
      t402 = 0.5 * t401, t466 = k1 * t401, t441 = minus_limb4_U_0_cos * t382,
      t386 = limb4_U_0_sin * t382 + minus_limb4_U_0_cos * t384, t443 = t441 - limb4_U_0_sin * t384,
      t392 = minus_limb4_lower_sin * t386, t390 = limb4_lower_cos * t386 + minus_limb4_lower_sin * t388,
      t394 = t392 - limb4_lower_cos * t388, t391 = k1 * t390, t405 = 0.5 * t390 + k1 * t394, t396 = t391 - 0.5 * t394,
      t407 = t402 + k1 * t405, t468 = t466 - 0.5 * t405, t423 = 1.0 + 2.0 * t407,
      t446 = limb4_U_0_sin * platform_turn_zx,
      t410 = minus_limb4_U_0_cos * platform_turn_zx - limb4_U_0_sin * platform_turn_xx, t425 = t407 - (t410 + t423),
      t448 = t446 + minus_limb4_U_0_cos * platform_turn_xx, t469 = 0.5 * t380, t398 = k1 * t380 - 0.5 * t396,
      t427 = -(t398 + t425), t471 = t469 + k1 * t396, t419 = -(t398 + (t407 - (t410 + (1.0 - 2.0 * t410)))),
      t413 = t398 + (t407 + (1.0 - t410)), t420 = LESS(t413, t419), t421 = SELECT(t420, t419, t413),
      t428 = LESS(t421, t427), t429 = SELECT(t428, t427, t421), t435 = -(t398 + (t407 - (t410 + (1.0 + 2.0 * t398)))),
      t436 = LESS(t429, t435), t479 = 1.0 / (2.0 * SQRT(SELECT(t436, t435, t429))), t472 = t468 - t471,
      t473 = SELECT(t420, t419, t472), t483 = SELECT(t420, t472, t413), t491 = -(t468 + t471),
      t453 = minus_limb4_lower_sin * t448, t451 = limb4_lower_cos * t448 + minus_limb4_lower_sin * platform_turn_yx,
      t455 = t453 - limb4_lower_cos * platform_turn_yx, t452 = k1 * t451, t461 = 0.5 * t451 + k1 * t455,
      t457 = t452 - 0.5 * t455, t440 = k1 * t439, t464 = 0.5 * t439 + k1 * t443, t445 = t440 - 0.5 * t443,
      t465 = t461 - t464, t481 = t461 + t464, t474 = SELECT(t428, t465, t473), t458 = t445 - t457, t482 = t457 + t445,
      t480 = SELECT(t436, t458, t474) * t479, t500 = SELECT(t436, t435, SELECT(t428, t491, SELECT(t420, t458, t481))),
      t485 = SELECT(t436, t481, SELECT(t428, t482, t483)),
      t495 = SELECT(t436, t491, SELECT(t428, t427, SELECT(t420, t465, t482))) * t479, t501 = t500 * t479,
      t486 = t485 * t479, t504 = SQRT(t480 * t480 + t495 * t495 + t501 * t501),
      t488 = SELECT(LESS(t486, 0.0), (-1.0), 1.0), t508 = 2.0 * atan2(t504, t486 * t488), t505 = LESS(t504, 1.0e-08),
      t512 = t488 * SELECT(t505, 2.0, t508 / SELECT(t505, 1.0, t504));
    RESULT(checked1, displacements, 20, t480 * t512);
    RESULT(checked2, displacements, 21, t495 * t512);
    RESULT(checked3, displacements, 22, t501 * t512);
    const REAL t514 = SELECT(LESS(limb5_S_q_qw, 0.0), (-1.0), 1.0), /* limb5_S */
      t520 = 2.0 * atan2(t516, limb5_S_q_qw * t514), /* limb5_S */
      t517 = LESS(t516, 1.0e-08), /* limb5_S */
      t524 = t514 * SELECT(t517, 2.0, t520 / SELECT(t517, 1.0, t516)); /* limb5_S */
    RESULT(checked0, displacements, 23, limb5_S_q_qx * t524);
    RESULT(checked1, displacements, 24, limb5_S_q_qy * t524);
    RESULT(checked2, displacements, 25, limb5_S_q_qz * t524);
    const REAL limb1_U_q_0 = READ(q, 0);
    WRITE(displacements, 0, limb1_U_q_0);
    checked3 = checked3 + limb1_U_q_0;
    const REAL limb1_U_q_1 = READ(q, 1);
    WRITE(displacements, 1, limb1_U_q_1);
    checked0 = checked0 + limb1_U_q_1;
    const REAL limb1_P_q = READ(q, 2);
    WRITE(displacements, 2, limb1_P_q);
    checked1 = checked1 + limb1_P_q;
    const REAL limb2_U_q_0 = READ(q, 3);
    WRITE(displacements, 5, limb2_U_q_0);
    checked2 = checked2 + limb2_U_q_0;
    const REAL limb2_U_q_1 = READ(q, 4);
    WRITE(displacements, 6, limb2_U_q_1);
    checked3 = checked3 + limb2_U_q_1;
    const REAL limb2_P_q = READ(q, 5);
    WRITE(displacements, 7, limb2_P_q);
    checked0 = checked0 + limb2_P_q;
    const REAL limb3_U_q_0 = READ(q, 6);
    WRITE(displacements, 11, limb3_U_q_0);
    checked1 = checked1 + limb3_U_q_0;
    const REAL limb3_U_q_1 = READ(q, 7);
    WRITE(displacements, 12, limb3_U_q_1);
    checked2 = checked2 + limb3_U_q_1;
    const REAL limb3_P_q = READ(q, 8);
    WRITE(displacements, 13, limb3_P_q);
    checked3 = checked3 + limb3_P_q;
    const REAL limb4_U_q_0 = READ(q, 9);
    WRITE(displacements, 17, limb4_U_q_0);
    checked0 = checked0 + limb4_U_q_0;
    const REAL limb4_U_q_1 = READ(q, 10);
    WRITE(displacements, 18, limb4_U_q_1);
    checked1 = checked1 + limb4_U_q_1;
    const REAL limb4_P_q = READ(q, 11);
    WRITE(displacements, 19, limb4_P_q);
    checked2 = checked2 + limb4_P_q;
    /* else status 5: no rotation */
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
    if (isfinite(three_ups_upu_s_inverse_kinematics_packed_lane(1, pose, q, NULL))) {
        return 0;
    }
#endif
    return three_ups_upu_s_inverse_kinematics_limb_by_limb(pose, q);
}

int three_ups_upu_s_drive_positions(const double *restrict pose, double *restrict positions)
{
    const int outcome = three_ups_upu_s_drive_positions_body(1, pose, positions, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(positions, 4);
    }
    return outcome;
}


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
    if (isfinite(three_ups_upu_s_inverse_velocity_packed_lane(1, pose, rate, v, NULL))) {
        return 0;
    }
#endif
    return three_ups_upu_s_inverse_velocity_limb_by_limb(pose, rate, v);
}
#endif /* THREE_UPS_UPU_S_VECTORS */
