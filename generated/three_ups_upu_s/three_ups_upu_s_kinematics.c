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
      sign2 = OF4(1.0, 1.0, -1.0, -1.0), each_param_R = sign2 * param_R, each_param_R_2 = -sign2 * param_R,
      factor_2 = -sign1 * 0.5, each_param_R_3 = -sign1 * param_R, sign3 = OF4(1.0, -1.0, -1.0, 1.0);
    const LIMB4 t25 = sign1 * IN_EACH4(SINES, cosine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2);
    /* each limb: geometry */
    const LIMB4 lower_rotation_zx = t25 * lower_cos, signed_lower_sin = IN_EACH4(SINES, sine, 1, 2);
    /* each limb: results; geometry */
    const LIMB4 t5 = (-0.5) * lower_rotation_zx, t24 = sign1 * signed_lower_sin,
      signed_lower_rotation_zy = t25 * t24, signed_lower_poses_Rzx = t5 + k1 * signed_lower_rotation_zy;
    WRITE4(poses, 14, 41, 62, 89, -sign2 * signed_lower_poses_Rzx);
    WRITE4(poses, 26, 53, 74, 101, -sign2 * signed_lower_poses_Rzx);
    const LIMB4 t13 = 0.5 * signed_lower_rotation_zy, lower_poses_z = (-param_R) * signed_lower_poses_Rzx;
    WRITE4(poses, 23, 47, 71, 95, lower_poses_z);
    LIMB4 checked = lower_poses_z;
    const LIMB4 t21 = 0.5 * signed_lower_poses_Rzx, lower_poses_Rzz = k1 * lower_rotation_zx + t13;
    WRITE4(poses, 20, 44, 68, 92, lower_poses_Rzz);
    WRITE4(poses, 32, 56, 80, 104, lower_poses_Rzz);
    const LIMB4 t23 = t21 + param_H * lower_poses_Rzz, upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      upper_poses_z = upper_offset_x * lower_rotation_zx - t23;
    WRITE4(poses, 35, 59, 83, 107, upper_poses_z);
    checked = checked + upper_poses_z;
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), signed_lower_rotation_yy = signed_U_0_sin * t24,
      signed_upper_position_x = t24 * upper_offset_x + each_param_R_3, t10 = 0.5 * signed_lower_rotation_yy,
      t4 = k1 * signed_lower_rotation_yy, minus_lower_rotation_yx = signed_U_0_sin * lower_cos,
      minus_upper_position_y = upper_offset_x * minus_lower_rotation_yx, t11 = k1 * minus_lower_rotation_yx + t10;
    WRITE4(poses, 19, 42, 67, 90, -t11);
    WRITE4(poses, 31, 54, 79, 102, -t11);
    const LIMB4 t18 = param_H * t11, lower_poses_Ryx = 0.5 * minus_lower_rotation_yx - t4;
    WRITE4(poses, 13, 39, 61, 87, -sign2 * lower_poses_Ryx);
    WRITE4(poses, 25, 51, 73, 99, -sign2 * lower_poses_Ryx);
    const LIMB4 lower_poses_y = (-param_R) * lower_poses_Ryx;
    WRITE4(poses, 22, 45, 70, 93, lower_poses_y);
    checked = checked + lower_poses_y;
    const LIMB4 upper_poses_y = t18 - 0.5 * lower_poses_Ryx - minus_upper_position_y;
    WRITE4(poses, 34, 57, 82, 105, upper_poses_y);
    checked = checked + upper_poses_y;
    const LIMB4 lower_poses_Rxx = 0.5 * signed_lower_sin + each_k1 * lower_cos;
    WRITE4(poses, 12, 40, 60, 88, lower_poses_Rxx);
    WRITE4(poses, 24, 52, 72, 100, lower_poses_Rxx);
    const LIMB4 t15 = factor_2 * lower_poses_Rxx, lower_poses_x = each_param_R * lower_poses_Rxx + each_param_R_2;
    WRITE4(poses, 21, 46, 69, 94, lower_poses_x);
    checked = checked + lower_poses_x;
    const LIMB4 signed_lower_poses_Rxz = each_k1_2 * signed_lower_sin + 0.5 * lower_cos;
    WRITE4(poses, 18, 43, 66, 91, -sign3 * signed_lower_poses_Rxz);
    WRITE4(poses, 30, 55, 78, 103, -sign3 * signed_lower_poses_Rxz);
    const LIMB4 signed_upper_poses_x = t15 - param_H * signed_lower_poses_Rxz - signed_upper_position_x;
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
    const REAL t11 = limb5_S_q_qy * t9, t15 = limb5_S_q_qx * t13, t14 = limb5_S_q_qw * t13, t16 = limb5_S_q_qw *
        t11;
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
    FIRST_LIMB(0, body_twists, 0, stride, v, twists, sine, cosine, param_R * limb1_U_0_sin, param_R * limb1_U_0_cos,
        &limbs);
    checked3 = checked3 + ALONE(limbs.checked[0]);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2);
    NEXT_LIMB(1, body_twists, 0, stride, v, twists, sine, cosine, param_R * minus_limb2_U_0_cos, param_R *
        limb2_U_0_sin, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[1]);
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    NEXT_LIMB(2, body_twists, 0, stride, v, twists, sine, cosine, param_R * limb3_U_0_sin, param_R * limb3_U_0_cos,
        &limbs);
    checked1 = checked1 + ALONE(limbs.checked[2]);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6);
    NEXT_LIMB(3, body_twists, 0, stride, v, twists, sine, cosine, param_R * minus_limb4_U_0_cos, param_R *
        limb4_U_0_sin, &limbs);
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
    const LIMB4 signed_U_0_sin = IN_EACH4(SINES, sine, 0, 2), lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      t33 = sign1 * (signed_U_0_sin * lower_cos), U_v_0 = IN_EACH4(READ, v, 0, 3), U_v_1 = IN_EACH4(READ, v, 1, 3),
      U_0_cos = IN_EACH4(SINES, cosine, 0, 2);
    /* each limb: accelerations; velocities, eq. (6); geometry */
    const LIMB4 t26 = U_v_0 * t33, lower_twist_wy = U_v_1 * U_0_cos, signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      P_v = IN_EACH4(READ, v, 2, 3), U_a_1 = IN_EACH4(READ, a, 1, 3),
      t29 = P_v * (t26 + signed_lower_sin * lower_twist_wy),
      signed_lower_twist_rate_vz = U_a_1 * signed_U_1_screw_vz - U_v_1 * (U_v_0 * signed_U_1_screw_vy);
    WRITE4(twist_rates, 11, 23, 35, 47, -sign2 * signed_lower_twist_rate_vz);
    const LIMB4 t32 = sign1 * IN_EACH4(READ, a, 2, 3), signed_lower_rotation_zx = U_0_cos * lower_cos,
      t14 = signed_lower_rotation_zx * lower_twist_wy,
      signed_upper_twist_rate_vz = t32 * signed_lower_rotation_zx - signed_lower_twist_rate_vz - t29;
    WRITE4(twist_rates, 17, 29, 41, 53, sign2 * signed_upper_twist_rate_vz);
    LIMB4 checked = signed_upper_twist_rate_vz;
    const LIMB4 t21 = U_v_0 * signed_lower_rotation_zx,
      lower_twist_rate_vy = sign1 * (U_a_1 * signed_U_1_screw_vy) + sign1 * (U_v_1 * (U_v_0 * signed_U_1_screw_vz));
    WRITE4(twist_rates, 10, 21, 34, 45, lower_twist_rate_vy);
    const LIMB4 t19 = lower_twist_rate_vy - t32 * t33, t13 = t32 * signed_lower_sin,
      t34 = sign1 * (U_v_1 * signed_U_0_sin), t16 = t14 + t33 * t34,
      upper_twist_rate_vy = t19 + P_v * (signed_lower_sin * t34 - t21);
    WRITE4(twist_rates, 16, 27, 40, 51, upper_twist_rate_vy);
    checked = checked + upper_twist_rate_vy;
    const LIMB4 upper_twist_rate_vx = t13 + P_v * t16;
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
    FIRST_LIMB(0, body_twist_rates, 0, stride, v, a, twist_rates, sine, cosine, param_R * limb1_U_0_sin, param_R *
        limb1_U_0_cos, &limbs);
    checked2 = checked2 + ALONE(limbs.checked[0]);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2), limb2_U_0_sin = SINES(cosine, 2);
    NEXT_LIMB(1, body_twist_rates, 0, stride, v, a, twist_rates, sine, cosine, param_R * minus_limb2_U_0_cos,
        param_R * limb2_U_0_sin, &limbs);
    checked3 = checked3 + ALONE(limbs.checked[1]);
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    NEXT_LIMB(2, body_twist_rates, 0, stride, v, a, twist_rates, sine, cosine, param_R * limb3_U_0_sin, param_R *
        limb3_U_0_cos, &limbs);
    checked0 = checked0 + ALONE(limbs.checked[2]);
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_0_sin = SINES(cosine, 6);
    NEXT_LIMB(3, body_twist_rates, 0, stride, v, a, twist_rates, sine, cosine, param_R * minus_limb4_U_0_cos,
        param_R * limb4_U_0_sin, &limbs);
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
    const REAL t11 = limb5_S_q_qx * t10, t22 = limb5_S_q_qw * t10, t13 = limb5_S_q_qw * t12,
      t21 = limb5_S_q_qx * t12, platform_turn_zx = t11 - t13, E_positions_x = param_H * (t11 + t13);
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
    const FOURS fours = (((FOUR(a, 0) + FOUR(a, 4)) + (FOUR(a, 8) + FOUR(q, 0))) + ((FOUR(q, 4) + FOUR(q, 8)) +
        (FOUR(v, 0) + FOUR(v, 4)))) + FOUR(v, 8);
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
      t91 = limb5_S_a_wy * platform_turn_xy, t43 = limb5_S_v_wx * platform_turn_xx + limb5_S_v_wy *
          platform_turn_xy,
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
    const REAL t174 = platform_twist_wx * C4_velocities_y, t163 = platform_twist_wz * C4_velocities_y,
      t32 = limb5_S_v_wy * platform_turn_yy + limb5_S_v_wx * platform_turn_yx,
      platform_twist_wy = t32 + limb5_S_v_wz * platform_turn_yz, t69 = limb4_lower_limb_target_x *
          platform_twist_wy,
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
    const REAL t176 = t174 - platform_twist_wy * C4_velocities_x, t168 = platform_twist_wz * C4_velocities_x,
      platform_twist_rate_wx = limb5_S_a_wx * platform_turn_xx + t91 + t93, t20 = 0.5 * platform_turn_xx,
      t171 = limb4_upper_position_y * platform_twist_rate_wx,
      platform_twist_rate_wy = limb5_S_a_wx * platform_turn_yx + t76 + t78, t23 = 0.5 * platform_turn_yx,
      C4_accelerations_z = t171 - limb4_lower_limb_target_y * platform_twist_rate_wy + t176;
    WRITE(accelerations, 29, C4_accelerations_z);
    REAL checked1 = C4_accelerations_z;
    const REAL C4_velocities_z = limb4_upper_position_y * platform_twist_wx - limb4_lower_limb_target_y *
        platform_twist_wy;
    WRITE(velocities, 29, C4_velocities_z);
    const REAL t170 = t168 - platform_twist_wx * C4_velocities_z, t164 = platform_twist_wy * C4_velocities_z - t163,
      platform_twist_rate_wz = limb5_S_a_wx * platform_turn_zx + t81 + t83,
      t165 = limb4_lower_limb_target_y * platform_twist_rate_wz,
      t160 = limb4_upper_position_y * platform_twist_rate_wz, t24 = 0.5 * platform_turn_zx,
      C4_accelerations_y = t165 - limb4_lower_limb_target_x * platform_twist_rate_wx + t170;
    WRITE(accelerations, 28, C4_accelerations_y);
    REAL checked2 = C4_accelerations_y;
    const REAL C4_accelerations_x = limb4_lower_limb_target_x * platform_twist_rate_wy - t160 + t164;
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
    const REAL t156 = platform_twist_wx * C3_velocities_y, t145 = platform_twist_wz * C3_velocities_y,
      t63 = limb3_lower_limb_target_y * platform_twist_wy, limb3_lower_limb_target_x = t23 + E_positions_y;
    WRITE(positions, 25, limb3_lower_limb_target_x);
    const REAL minus_limb1_lower_limb_target_x = t23 - E_positions_y;
    WRITE(positions, 19, -minus_limb1_lower_limb_target_x);
    const REAL C3_velocities_x = t63 - limb3_lower_limb_target_x * platform_twist_wz;
    WRITE(velocities, 24, C3_velocities_x);
    const REAL t158 = t156 - platform_twist_wy * C3_velocities_x, t150 = platform_twist_wz * C3_velocities_x,
      t153 = limb3_lower_limb_target_x * platform_twist_rate_wx;
    RESULT(checked0, accelerations, 26, t153 - limb3_upper_position_x * platform_twist_rate_wy + t158);
    const REAL t142 = limb3_lower_limb_target_x * platform_twist_rate_wz,
      C3_velocities_z = limb3_lower_limb_target_x * platform_twist_wx - limb3_upper_position_x * platform_twist_wy;
    WRITE(velocities, 26, C3_velocities_z);
    const REAL t147 = limb3_upper_position_x * platform_twist_rate_wz,
      t152 = t150 - platform_twist_wx * C3_velocities_z, t146 = platform_twist_wy * C3_velocities_z - t145;
    RESULT(checked1, accelerations, 25, t147 - limb3_lower_limb_target_y * platform_twist_rate_wx + t152);
    RESULT(checked2, accelerations, 24, limb3_lower_limb_target_y * platform_twist_rate_wy - t142 + t146);
    const REAL C2_velocities_y = limb2_lower_limb_target_y * platform_twist_wz - limb2_lower_limb_target_x *
        platform_twist_wx;
    WRITE(velocities, 22, C2_velocities_y);
    const REAL t138 = platform_twist_wx * C2_velocities_y, t127 = platform_twist_wz * C2_velocities_y,
      C2_velocities_x = limb2_lower_limb_target_x * platform_twist_wy - limb2_upper_position_y * platform_twist_wz;
    WRITE(velocities, 21, C2_velocities_x);
    const REAL t140 = t138 - platform_twist_wy * C2_velocities_x, t132 = platform_twist_wz * C2_velocities_x,
      t135 = limb2_upper_position_y * platform_twist_rate_wx;
    RESULT(checked3, accelerations, 23, t135 - limb2_lower_limb_target_y * platform_twist_rate_wy + t140);
    const REAL t124 = limb2_upper_position_y * platform_twist_rate_wz,
      C2_velocities_z = limb2_upper_position_y * platform_twist_wx - limb2_lower_limb_target_y * platform_twist_wy;
    WRITE(velocities, 23, C2_velocities_z);
    const REAL t129 = limb2_lower_limb_target_y * platform_twist_rate_wz,
      t134 = t132 - platform_twist_wx * C2_velocities_z, t128 = platform_twist_wy * C2_velocities_z - t127;
    RESULT(checked0, accelerations, 22, t129 - limb2_lower_limb_target_x * platform_twist_rate_wx + t134);
    RESULT(checked1, accelerations, 21, limb2_lower_limb_target_x * platform_twist_rate_wy - t124 + t128);
    const REAL t51 = minus_limb1_upper_position_x * platform_twist_wz,
      t53 = t51 - minus_limb1_lower_limb_target_y * platform_twist_wx;
    WRITE(velocities, 19, -t53);
    const REAL t120 = platform_twist_wx * t53, t109 = platform_twist_wz * t53,
      t48 = minus_limb1_lower_limb_target_y * platform_twist_wy,
      t50 = t48 - minus_limb1_lower_limb_target_x * platform_twist_wz;
    WRITE(velocities, 18, -t50);
    const REAL t122 = t120 - platform_twist_wy * t50, t114 = platform_twist_wz * t50,
      t117 = minus_limb1_upper_position_x * platform_twist_rate_wy;
    RESULT(checked2, accelerations, 20, t117 - minus_limb1_lower_limb_target_x * platform_twist_rate_wx - t122);
    const REAL t54 = minus_limb1_lower_limb_target_x * platform_twist_wx,
      t105 = minus_limb1_lower_limb_target_x * platform_twist_rate_wz,
      t56 = t54 - minus_limb1_upper_position_x * platform_twist_wy,
      t112 = minus_limb1_upper_position_x * platform_twist_rate_wz;
    WRITE(velocities, 20, -t56);
    const REAL t116 = t114 - platform_twist_wx * t56, t110 = platform_twist_wy * t56 - t109;
    RESULT(checked3, accelerations, 19, minus_limb1_lower_limb_target_y * platform_twist_rate_wx - t112 - t116);
    RESULT(checked0, accelerations, 18, t105 - minus_limb1_lower_limb_target_y * platform_twist_rate_wy - t110);
    const REAL E_velocities_y = E_positions_x * platform_twist_wz - E_positions_z * platform_twist_wx;
    WRITE(velocities, 4, E_velocities_y);
    const REAL t102 = platform_twist_wx * E_velocities_y, t87 = platform_twist_wz * E_velocities_y,
      E_velocities_x = E_positions_z * platform_twist_wy - E_positions_y * platform_twist_wz;
    WRITE(velocities, 3, E_velocities_x);
    const REAL t96 = platform_twist_wz * E_velocities_x, t104 = t102 - platform_twist_wy * E_velocities_x,
      t94 = E_positions_z * platform_twist_rate_wx, t79 = E_positions_z * platform_twist_rate_wy;
    RESULT(checked1, accelerations, 5, E_positions_y * platform_twist_rate_wx - E_positions_x *
        platform_twist_rate_wy + t104);
    const REAL t85 = t79 - E_positions_y * platform_twist_rate_wz,
      t95 = E_positions_x * platform_twist_rate_wz - t94,
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
    const REAL limb4_U_0_sin = SINES(cosine, 6);
    WRITE(screws, 108, limb4_U_0_sin);
    WRITE(screws, 120, limb4_U_0_sin);
    const REAL limb4_U_1_screw_vz = (-param_R) * limb4_U_0_sin;
    WRITE(screws, 113, limb4_U_1_screw_vz);
    REAL checked0 = limb4_U_1_screw_vz;
    const REAL minus_limb4_U_0_cos = SINES(sine, 6), limb4_U_1_screw_vx = (-param_R) * minus_limb4_U_0_cos;
    WRITE(screws, 111, limb4_U_1_screw_vx);
    REAL checked1 = limb4_U_1_screw_vx;
    const REAL limb4_U_0_cos = -minus_limb4_U_0_cos;
    WRITE(screws, 110, limb4_U_0_cos);
    WRITE(screws, 122, limb4_U_0_cos);
    /* limb3: geometry */
    const REAL minus_limb3_lower_sin = SINES(sine, 5);
    WRITE(screws, 81, -minus_limb3_lower_sin);
    const REAL limb3_U_0_cos = SINES(cosine, 4);
    WRITE(screws, 73, limb3_U_0_cos);
    WRITE(screws, 91, limb3_U_0_cos);
    const REAL limb3_U_1_screw_vz = param_R * limb3_U_0_cos;
    WRITE(screws, 77, limb3_U_1_screw_vz);
    REAL checked2 = limb3_U_1_screw_vz;
    const REAL limb3_U_0_sin = SINES(sine, 4);
    WRITE(screws, 74, limb3_U_0_sin);
    WRITE(screws, 92, limb3_U_0_sin);
    const REAL limb3_U_1_screw_vy = (-param_R) * limb3_U_0_sin;
    WRITE(screws, 76, limb3_U_1_screw_vy);
    REAL checked3 = limb3_U_1_screw_vy;
    const REAL limb2_U_0_sin = SINES(cosine, 2);
    WRITE(screws, 36, limb2_U_0_sin);
    WRITE(screws, 48, limb2_U_0_sin);
    RESULT(checked0, screws, 41, param_R * limb2_U_0_sin);
    const REAL minus_limb2_U_0_cos = SINES(sine, 2);
    RESULT(checked1, screws, 39, param_R * minus_limb2_U_0_cos);
    const REAL limb2_U_0_cos = -minus_limb2_U_0_cos;
    WRITE(screws, 38, limb2_U_0_cos);
    WRITE(screws, 50, limb2_U_0_cos);
    const REAL limb1_U_0_cos = SINES(cosine, 0);
    WRITE(screws, 7, limb1_U_0_cos);
    RESULT(checked2, screws, 11, (-param_R) * limb1_U_0_cos);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    WRITE(screws, 8, limb1_U_0_sin);
    RESULT(checked3, screws, 10, param_R * limb1_U_0_sin);
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
    /* limb3: geometry; screws, eq. (5) */
    const REAL limb3_upper_offset_x = limb_upper_phase + READ(q, 8),
      limb3_upper_position_x = param_R - minus_limb3_lower_sin * limb3_upper_offset_x;
    RESULT(checked1, screws, 95, limb3_U_0_cos * limb3_upper_position_x);
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
    checked2 = checked2 + t98;
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
    checked3 = checked3 + t95;
    WRITE(screws, 100, -t95);
    RESULT(checked0, screws, 99, t91 - minus_limb3_upper_position_y * limb3_S_screws_z_wz);
    const REAL t82 = limb3_U_0_sin * limb3_upper_position_x;
    checked1 = checked1 + t82;
    WRITE(screws, 94, -t82);
    const REAL t81 = limb3_U_0_sin * minus_limb3_upper_position_y + limb3_U_0_cos * limb3_upper_position_z;
    checked2 = checked2 + t81;
    WRITE(screws, 93, -t81);
    const REAL t77 = limb3_upper_position_x * limb3_S_screws_x_wy, t76 = limb3_upper_position_x * t72;
    RESULT(checked3, screws, 87, minus_limb3_upper_position_y * t72 - limb3_upper_position_z * limb3_S_screws_x_wy);
    const REAL limb3_S_screws_x_wx = 0.5 * minus_limb3_lower_sin + k1 * limb3_lower_cos;
    WRITE(screws, 84, limb3_S_screws_x_wx);
    RESULT(checked0, screws, 89, t77 + minus_limb3_upper_position_y * limb3_S_screws_x_wx);
    RESULT(checked1, screws, 88, limb3_upper_position_z * limb3_S_screws_x_wx + t76);
    /* limb2: geometry; screws, eq. (5) */
    const REAL limb2_upper_offset_x = limb_upper_phase + READ(q, 5), limb2_lower_sin = SINES(sine, 3);
    WRITE(screws, 46, limb2_lower_sin);
    const REAL minus_limb2_upper_position_y = param_R - limb2_lower_sin * limb2_upper_offset_x;
    RESULT(checked2, screws, 53, limb2_U_0_sin * minus_limb2_upper_position_y);
    RESULT(checked3, screws, 51, minus_limb2_U_0_cos * minus_limb2_upper_position_y);
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
    checked0 = checked0 + t64;
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
    RESULT(checked1, screws, 64, t60 - minus_limb2_upper_position_x * t57);
    RESULT(checked2, screws, 63, minus_limb2_upper_position_y * t57 + t59);
    const REAL t48 = minus_limb2_upper_position_y * t37, t43 = minus_limb2_upper_position_y * t42;
    RESULT(checked3, screws, 58, minus_limb2_upper_position_z * t37 - minus_limb2_upper_position_x * t42);
    const REAL limb2_S_screws_y_wy = 0.5 * limb2_lower_sin - k1 * limb2_lower_cos;
    WRITE(screws, 55, limb2_S_screws_y_wy);
    const REAL t49 = minus_limb2_upper_position_x * limb2_S_screws_y_wy + t48;
    checked0 = checked0 + t49;
    WRITE(screws, 59, -t49);
    RESULT(checked1, screws, 57, t43 + minus_limb2_upper_position_z * limb2_S_screws_y_wy);
    const REAL t32 = limb2_U_0_sin * minus_limb2_upper_position_z,
      t34 = t32 + minus_limb2_U_0_cos * minus_limb2_upper_position_x;
    checked2 = checked2 + t34;
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
    /* limb1: geometry */
    const REAL limb1_upper_offset_x = limb_upper_phase + READ(q, 2), limb1_lower_cos = SINES(cosine, 1);
    WRITE(screws, 18, limb1_lower_cos);
    const REAL minus_limb1_lower_rotation_yx = limb1_U_0_sin * limb1_lower_cos;
    WRITE(screws, 16, -minus_limb1_lower_rotation_yx);
    const REAL minus_limb1_upper_position_y = limb1_upper_offset_x * minus_limb1_lower_rotation_yx,
      limb1_lower_sin = SINES(sine, 1);
    WRITE(screws, 15, limb1_lower_sin);
    /* limb1: screws, eq. (5); geometry */
    const REAL t29 = platform_turn_xy * minus_limb1_upper_position_y,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x;
    RESULT(checked3, screws, 29, t29 - platform_turn_yy * minus_limb1_upper_position_x);
    const REAL limb1_lower_rotation_zx = limb1_U_0_cos * limb1_lower_cos;
    WRITE(screws, 17, limb1_lower_rotation_zx);
    const REAL limb1_upper_position_z = limb1_upper_offset_x * limb1_lower_rotation_zx,
      t25 = platform_turn_yy * limb1_upper_position_z, t2 = limb1_lower_cos * limb1_upper_position_z;
    RESULT(checked0, screws, 28, platform_turn_xy * limb1_upper_position_z + platform_turn_zy *
        minus_limb1_upper_position_x);
    const REAL t26 = platform_turn_zy * minus_limb1_upper_position_y + t25;
    checked1 = checked1 + t26;
    WRITE(screws, 27, -t26);
    const REAL t4 = limb1_lower_cos * minus_limb1_upper_position_y,
      limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin;
    WRITE(screws, 19, limb1_lower_rotation_yy);
    RESULT(checked2, screws, 23, t4 - limb1_lower_rotation_yy * minus_limb1_upper_position_x);
    const REAL minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin;
    RESULT(checked3, screws, 22, t2 - minus_limb1_lower_rotation_zy * minus_limb1_upper_position_x);
    WRITE(screws, 20, -minus_limb1_lower_rotation_zy);
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
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, -1.0), each_limb_upper_phase = -sign1 * limb_upper_phase,
      each_param_R = -sign1 * param_R, sign2 = OF4(1.0, -1.0, 1.0, -1.0);
    /* each limb: geometry; results */
    const LIMB4 upper_offset_x = IN_EACH4(READ, q, 2, 3) + limb_upper_phase,
      lower_cos = IN_EACH4(SINES, cosine, 1, 2),
      signed_lower_rotation_zx = IN_EACH4(SINES, cosine, 0, 2) * lower_cos,
      signed_upper_position_z = upper_offset_x * signed_lower_rotation_zx;
    WRITE4(points, 8, 17, 26, 35, sign2 * signed_upper_position_z);
    const LIMB4 signed_P_points_z = signed_upper_position_z - limb_upper_phase * signed_lower_rotation_zx;
    WRITE4(points, 5, 14, 23, 32, sign2 * signed_P_points_z);
    LIMB4 checked = signed_P_points_z;
    const LIMB4 minus_lower_rotation_yx = IN_EACH4(SINES, sine, 0, 2) * lower_cos,
      t2 = limb_upper_phase * minus_lower_rotation_yx,
      minus_upper_position_y = upper_offset_x * minus_lower_rotation_yx;
    WRITE4(points, 7, 15, 25, 33, -minus_upper_position_y);
    const LIMB4 P_points_y = t2 - minus_upper_position_y;
    WRITE4(points, 4, 12, 22, 30, P_points_y);
    checked = checked + P_points_y;
    const LIMB4 signed_lower_sin = IN_EACH4(SINES, sine, 1, 2),
      upper_position_x = sign1 * signed_lower_sin * upper_offset_x + each_param_R;
    WRITE4(points, 6, 16, 24, 34, upper_position_x);
    const LIMB4 P_points_x = each_limb_upper_phase * signed_lower_sin + upper_position_x;
    WRITE4(points, 3, 13, 21, 31, P_points_x);
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
    const REAL t11 = limb5_S_q_qy * t9, t15 = limb5_S_q_qx * t13, t14 = limb5_S_q_qw * t13, t16 = limb5_S_q_qw *
        t11;
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
      limb5_S_q_qz = READ(q, 15), t6 = limb5_S_q_qz * limb5_S_q_qz, t7 = t5 + t6, t8 = t4 + t7, t10 = 4.0 - 2.0 *
          t8,
      limb5_S_v_wx = READ(v, 12), t26 = limb5_S_v_wx * (1.0 - t7 * t10), t41 = t3 + t5,
      platform_turn_yy = 1.0 - t10 * (t3 + t6), limb5_S_v_wz = READ(v, 14), t43 = limb5_S_v_wz * (1.0 - t10 * t41),
      t11 = limb5_S_q_qy * t10, t12 = limb5_S_q_qx * t11, t30 = limb5_S_q_qw * t11, t13 = limb5_S_q_qz * t10,
      t22 = limb5_S_q_qw * (limb5_S_q_qx * t10), t14 = limb5_S_q_qw * t13, platform_turn_xy = t12 - t14,
      limb5_S_v_wy = READ(v, 13), t35 = limb5_S_v_wx * (t12 + t14), t28 = t26 + limb5_S_v_wy * platform_turn_xy,
      t29 = limb5_S_q_qx * t13, t20 = limb5_S_q_qy * t13, platform_turn_zx = t29 - t30,
      platform_twist_wx = t28 + limb5_S_v_wz * (t29 + t30);
    WRITE(rates, 23, platform_twist_wx);
    const REAL limb1_U_v_0 = READ(v, 0);
    WRITE(rates, 0, limb1_U_v_0);
    const REAL t44 = limb5_S_v_wx * platform_turn_zx, t32 = limb1_U_v_0 - platform_twist_wx, /* limb1 */
      limb1_lower_cos = SINES(cosine, 1), t33 = platform_turn_xy * t32, /* limb1 */
      t15 = limb1_lower_cos * platform_turn_xy, /* limb1 */
      t51 = limb1_lower_cos * t32, /* limb1 */
      t36 = limb5_S_v_wy * platform_turn_yy + t35, platform_turn_yz = t20 - t22, platform_turn_zy = t20 + t22,
      platform_twist_wy = t36 + limb5_S_v_wz * platform_turn_yz;
    WRITE(rates, 24, platform_twist_wy);
    /* limb1: velocities, eq. (6); geometry; results */
    const REAL limb1_U_v_1 = READ(v, 1);
    WRITE(rates, 1, limb1_U_v_1);
    const REAL limb1_U_0_cos = SINES(cosine, 0), t38 = platform_twist_wy - limb1_U_v_1 * limb1_U_0_cos,
      t40 = t33 - platform_turn_yy * t38, platform_twist_wz = t43 + (t44 + limb5_S_v_wy * platform_turn_zy);
    WRITE(rates, 25, platform_twist_wz);
    const REAL limb1_U_0_sin = SINES(sine, 0);
    /* limb1: results; geometry */
    const REAL t47 = platform_twist_wz - limb1_U_v_1 * limb1_U_0_sin, t49 = t40 - platform_turn_zy * t47,
      limb1_lower_sin = SINES(sine, 1), limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin,
      t19 = t15 + platform_turn_yy * limb1_lower_rotation_yy, t53 = t51 - limb1_lower_rotation_yy * t38,
      minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin,
      t24 = t19 - platform_turn_zy * minus_limb1_lower_rotation_zy, t55 = t53 + minus_limb1_lower_rotation_zy * t47,
      t56 = t24 * t49 - t55, t61 = t24 * t55 - t49, t59 = 1.0 / (1.0 - t24 * t24);
    RESULT(checked0, rates, 3, t56 * t59);
    RESULT(checked1, rates, 4, t61 * t59);
    /* limb2: velocities, eq. (6); geometry; results */
    const REAL limb2_U_v_1 = READ(v, 4);
    WRITE(rates, 6, limb2_U_v_1);
    const REAL limb2_U_0_sin = SINES(cosine, 2), t62 = platform_twist_wx - limb2_U_v_1 * limb2_U_0_sin,
      minus_limb2_U_0_cos = SINES(sine, 2);
    /* limb2: results; geometry */
    const REAL t63 = limb2_U_0_sin * t62, t64 = platform_twist_wz + limb2_U_v_1 * minus_limb2_U_0_cos;
    RESULT(checked2, rates, 8, t63 - minus_limb2_U_0_cos * t64);
    const REAL limb2_lower_cos = SINES(cosine, 3),
      minus_limb2_lower_rotation_xx = minus_limb2_U_0_cos * limb2_lower_cos, limb2_lower_sin = SINES(sine, 3),
      t67 = (-0.5) * minus_limb2_lower_rotation_xx, t82 = k1 * minus_limb2_lower_rotation_xx,
      limb2_lower_rotation_xy = minus_limb2_U_0_cos * limb2_lower_sin, limb2_U_v_0 = READ(v, 3);
    WRITE(rates, 5, limb2_U_v_0);
    const REAL t70 = (t67 - k1 * limb2_lower_rotation_xy) * t62, t84 = (0.5 * limb2_lower_rotation_xy - t82) * t62,
      t74 = limb2_U_v_0 - platform_twist_wy, t76 = t70 - (0.5 * limb2_lower_sin - k1 * limb2_lower_cos) * t74,
      minus_limb2_lower_rotation_zx = limb2_U_0_sin * limb2_lower_cos, t77 = 0.5 * minus_limb2_lower_rotation_zx,
      t90 = k1 * minus_limb2_lower_rotation_zx, limb2_lower_rotation_zy = limb2_U_0_sin * limb2_lower_sin;
    RESULT(checked3, rates, 9, t76 - (t77 + k1 * limb2_lower_rotation_zy) * t64);
    const REAL t93 = (t90 - 0.5 * limb2_lower_rotation_zy) * t64;
    RESULT(checked0, rates, 10, t84 - (k1 * limb2_lower_sin + 0.5 * limb2_lower_cos) * t74 - t93);
    /* limb3: velocities, eq. (6); geometry; results */
    const REAL limb3_U_v_1 = READ(v, 7);
    WRITE(rates, 12, limb3_U_v_1);
    const REAL limb3_U_0_cos = SINES(cosine, 4), t98 = platform_twist_wy - limb3_U_v_1 * limb3_U_0_cos,
      limb4_U_v_0 = READ(v, 9);
    WRITE(rates, 17, limb4_U_v_0);
    const REAL t138 = limb4_U_v_0 - platform_twist_wy, /* limb4 */
      limb3_U_0_sin = SINES(sine, 4), limb3_lower_cos = SINES(cosine, 5),
      minus_limb3_lower_rotation_yx = limb3_U_0_sin * limb3_lower_cos, minus_limb3_lower_sin = SINES(sine, 5);
    /* limb3: results; geometry */
    const REAL t95 = 0.5 * minus_limb3_lower_rotation_yx, t117 = k1 * minus_limb3_lower_rotation_yx,
      minus_limb3_lower_rotation_yy = limb3_U_0_sin * minus_limb3_lower_sin, limb3_U_v_0 = READ(v, 6);
    WRITE(rates, 11, limb3_U_v_0);
    const REAL t99 = (t95 - k1 * minus_limb3_lower_rotation_yy) * t98,
      t120 = (t117 + 0.5 * minus_limb3_lower_rotation_yy) * t98, t111 = limb3_U_0_cos * t98,
      t103 = limb3_U_v_0 - platform_twist_wx,
      t105 = t99 - (0.5 * minus_limb3_lower_sin + k1 * limb3_lower_cos) * t103,
      t109 = platform_twist_wz - limb3_U_v_1 * limb3_U_0_sin,
      limb3_lower_rotation_zx = limb3_U_0_cos * limb3_lower_cos, t106 = 0.5 * limb3_lower_rotation_zx,
      t122 = k1 * limb3_lower_rotation_zx, limb3_lower_rotation_zy = limb3_U_0_cos * minus_limb3_lower_sin;
    RESULT(checked1, rates, 14, t105 - (t106 - k1 * limb3_lower_rotation_zy) * t109);
    const REAL t125 = (t122 + 0.5 * limb3_lower_rotation_zy) * t109;
    RESULT(checked2, rates, 15, t111 + limb3_U_0_sin * t109);
    RESULT(checked3, rates, 16, (k1 * minus_limb3_lower_sin - 0.5 * limb3_lower_cos) * t103 - t120 + t125);
    /* limb4: velocities, eq. (6); geometry; results */
    const REAL limb4_U_v_1 = READ(v, 10);
    WRITE(rates, 18, limb4_U_v_1);
    const REAL limb4_U_0_sin = SINES(cosine, 6), t126 = platform_twist_wx - limb4_U_v_1 * limb4_U_0_sin,
      minus_limb4_U_0_cos = SINES(sine, 6);
    /* limb4: results; geometry */
    const REAL t127 = limb4_U_0_sin * t126, t128 = platform_twist_wz + limb4_U_v_1 * minus_limb4_U_0_cos;
    RESULT(checked0, rates, 20, t127 - minus_limb4_U_0_cos * t128);
    const REAL limb4_lower_cos = SINES(cosine, 7),
      minus_limb4_lower_rotation_xx = minus_limb4_U_0_cos * limb4_lower_cos, minus_limb4_lower_sin = SINES(sine, 7),
      t131 = 0.5 * minus_limb4_lower_rotation_xx, t149 = k1 * minus_limb4_lower_rotation_xx,
      minus_limb4_lower_rotation_xy = minus_limb4_U_0_cos * minus_limb4_lower_sin,
      t134 = (t131 + k1 * minus_limb4_lower_rotation_xy) * t126,
      t152 = (t149 - 0.5 * minus_limb4_lower_rotation_xy) * t126,
      t140 = t134 - (0.5 * minus_limb4_lower_sin - k1 * limb4_lower_cos) * t138,
      minus_limb4_lower_rotation_zx = limb4_U_0_sin * limb4_lower_cos, t141 = 0.5 * minus_limb4_lower_rotation_zx,
      t154 = k1 * minus_limb4_lower_rotation_zx,
      minus_limb4_lower_rotation_zy = limb4_U_0_sin * minus_limb4_lower_sin;
    RESULT(checked1, rates, 21, t140 + (t141 + k1 * minus_limb4_lower_rotation_zy) * t128);
    const REAL t157 = (t154 - 0.5 * minus_limb4_lower_rotation_zy) * t128;
    RESULT(checked2, rates, 22, (k1 * minus_limb4_lower_sin + 0.5 * limb4_lower_cos) * t138 - t152 - t157);
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
    const REAL t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6, t9 = 4.0 - 2.0 * t7,
      t30 = t2 + t5, t21 = param_H * (1.0 - t9 * (t2 + t4)), platform_turn_yy = 1.0 - t9 * t30,
      t29 = 0.5 * (1.0 - t6 * t9), t10 = limb5_S_pose_qy * t9, t11 = limb5_S_pose_qx * t10,
      t24 = limb5_S_pose_qw * t10, t12 = limb5_S_pose_qz * t9, t17 = limb5_S_pose_qw * (limb5_S_pose_qx * t9),
      t13 = limb5_S_pose_qw * t12, platform_turn_yx = t11 + t13, platform_turn_xy = t11 - t13,
      t14 = 0.5 * platform_turn_yx;
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
    const REAL t36 = limbs.signed_lower_sin[0] * (platform_turn_yy * limbs.signed_U_0_sin[0] + platform_turn_zy *
        limbs.signed_U_0_cos[0]), /* limb1 */
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
      t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx,
      limb5_S_pose_qy = READ(pose, 2), t3 = t1 + t2, t4 = limb5_S_pose_qy * limb5_S_pose_qy,
      limb5_S_pose_qz = READ(pose, 3), t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6,
      t9 = 4.0 - 2.0 * t7, t38 = t2 + t5, t25 = param_H * (1.0 - t9 * (t2 + t4)), t29 = 0.5 * (1.0 - t6 * t9),
      platform_turn_yy = 1.0 - t9 * t38, t10 = limb5_S_pose_qy * t9, t11 = limb5_S_pose_qx * t10,
      t21 = limb5_S_pose_qw * t10, t12 = limb5_S_pose_qz * t9, t17 = limb5_S_pose_qw * (limb5_S_pose_qx * t9),
      t13 = limb5_S_pose_qw * t12, platform_turn_yx = t11 + t13, platform_turn_xy = t11 - t13,
      t14 = 0.5 * platform_turn_yx, t15 = limb5_S_pose_qy * t12, t20 = limb5_S_pose_qx * t12,
      platform_turn_yz = t15 - t17, platform_turn_zy = t15 + t17, t18 = param_H * platform_turn_yz,
      minus_limb1_lower_limb_target_x = t14 - t18, limb3_lower_limb_target_x = t14 + t18,
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
      limb3_P_positions = SQRT(t45 + minus_limb3_lower_limb_target_z * minus_limb3_lower_limb_target_z) -
          limb_upper_phase;
    WRITE(positions, 2, limb3_P_positions);
    REAL checked0 = limb3_P_positions;
    const REAL limb1_lower_limb_length = SQRT(t27 + limb1_lower_limb_target_z * limb1_lower_limb_target_z),
      limb1_P_positions = limb1_lower_limb_length - limb_upper_phase;
    WRITE(positions, 0, limb1_P_positions);
    REAL checked1 = limb1_P_positions;
    const REAL minus_limb1_U_0_lever_mz_by_limb1_U2_fz = SQRT(t27),
      t57 = limb1_lower_limb_target_z * (t55 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz),
      limb1_U2_opening_mn = (t57 + platform_turn_xy * minus_limb1_U_0_lever_mz_by_limb1_U2_fz) /
          limb1_lower_limb_length,
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
      limb4_P_positions = SQRT(t50 + minus_limb4_lower_limb_target_z * minus_limb4_lower_limb_target_z) -
          limb_upper_phase;
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
    EACH4 signed_lower_limb_target_x, signed_upper_position_x, signed_lower_limb_target_y,
      signed_U_0_lever_mz_by_S_fz, t1, signed_U_0_sin, signed_U_0_cos, lower_limb_length, t2,
      signed_lower_sin, signed_lower_cos, checked;
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
    OWN(signed_lower_limb_target_y) = GIVEN(given_5) - sign1 * GIVEN(given_6);
    const LIMB4 t3 = t1 + OWN(signed_lower_limb_target_y) * OWN(signed_lower_limb_target_y);
    OWN(signed_U_0_lever_mz_by_S_fz) = SQRT4(t3);
    OWN(t1) = 1.0 / OWN(signed_U_0_lever_mz_by_S_fz);
    OWN(signed_U_0_sin) = OWN(signed_lower_limb_target_x) * OWN(t1);
    OWN(signed_U_0_cos) = OWN(signed_lower_limb_target_y) * OWN(t1);
    OWN(signed_upper_position_x) = GIVEN(given_3) - sign1 * GIVEN(given_4);
    const LIMB4 signed_lower_limb_target_z = OWN(signed_upper_position_x) + each_param_R;
    OWN(lower_limb_length) = SQRT4(t3 + signed_lower_limb_target_z * signed_lower_limb_target_z);
    LIMB4 checked = OWN(lower_limb_length);
    OWN(t2) = 1.0 / OWN(lower_limb_length);
    OWN(signed_lower_sin) = signed_lower_limb_target_z * OWN(t2);
    OWN(signed_lower_cos) = OWN(signed_U_0_lever_mz_by_S_fz) * OWN(t2);
    OWN(checked) = checked;
}

STAGE(inverse_velocity, 1)(size_t limb, size_t stride, double *restrict v, const EACH4 platform_twist_wx,
    const EACH4 platform_twist_wy, const EACH4 platform_twist_wz, LIMBS(inverse_velocity) *own)
{
    (void)limb, (void)stride;
    const NUMBER4 sign1 = OF4(1.0, 1.0, -1.0, 1.0);
    /* each limb: loop closure; velocities, eq. (6) */
    const LIMB4 t5 = OWN(signed_upper_position_x) * GIVEN(platform_twist_wz),
      t7 = t5 - OWN(signed_lower_limb_target_y) * GIVEN(platform_twist_wx), t9 = t7 * OWN(signed_U_0_sin),
      t8 = t7 * OWN(signed_U_0_cos), t1 = OWN(signed_lower_limb_target_x) * GIVEN(platform_twist_wx),
      t3 = t1 - OWN(signed_upper_position_x) * GIVEN(platform_twist_wy), t11 = t9 + t3 * OWN(signed_U_0_cos),
      U_0_omega_z = (t3 * OWN(signed_U_0_sin) - t8) * OWN(t1);
    WRITE4(v, 0, 3, 6, 9, U_0_omega_z);
    LIMB4 checked = OWN(checked) + U_0_omega_z;
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
      t1 = limb5_S_pose_qw * limb5_S_pose_qw, t2 = limb5_S_pose_qx * limb5_S_pose_qx,
      limb5_S_pose_qy = READ(pose, 2), t3 = t1 + t2, t4 = limb5_S_pose_qy * limb5_S_pose_qy,
      limb5_S_pose_qz = READ(pose, 3), t5 = limb5_S_pose_qz * limb5_S_pose_qz, t6 = t4 + t5, t7 = t3 + t6,
      t9 = 4.0 - 2.0 * t7, platform_turn_xx = 1.0 - t6 * t9, t19 = t2 + t4, platform_turn_yy = 1.0 - t9 * (t2 + t5),
      platform_turn_zz = 1.0 - t9 * t19, t10 = limb5_S_pose_qy * t9, t11 = limb5_S_pose_qx * t10,
      t28 = limb5_S_pose_qw * t10, t12 = limb5_S_pose_qz * t9, t17 = limb5_S_pose_qw * (limb5_S_pose_qx * t9),
      t13 = limb5_S_pose_qw * t12, platform_turn_xy = t11 - t13, platform_turn_yx = t11 + t13,
      limb5_S_rate_wy = READ(rate, 1);
    WRITE(v, 13, limb5_S_rate_wy);
    const REAL limb5_S_rate_wx = READ(rate, 0);
    WRITE(v, 12, limb5_S_rate_wx);
    const REAL t26 = limb5_S_rate_wx * platform_turn_xx + limb5_S_rate_wy * platform_turn_xy,
      t36 = 0.5 * platform_turn_xx, t27 = limb5_S_pose_qx * t12, t15 = limb5_S_pose_qy * t12,
      platform_turn_xz = t27 + t28, platform_turn_zx = t27 - t28, limb5_S_rate_wz = READ(rate, 2);
    WRITE(v, 14, limb5_S_rate_wz);
    const REAL platform_twist_wx = t26 + limb5_S_rate_wz * platform_turn_xz, t37 = param_H * platform_turn_xz,
      t33 = limb5_S_rate_wx * platform_turn_yx, t14 = 0.5 * platform_turn_yx,
      t34 = limb5_S_rate_wy * platform_turn_yy + t33, platform_turn_yz = t15 - t17, platform_turn_zy = t15 + t17,
      platform_twist_wy = t34 + limb5_S_rate_wz * platform_turn_yz, t18 = param_H * platform_turn_yz;
    const EACH4 given_3 = {t36, t18, t36, t18},
      platform_twist_wx_2 = {platform_twist_wx, platform_twist_wy, platform_twist_wx, platform_twist_wy};
    const REAL t40 = limb5_S_rate_wx * platform_turn_zx, t43 = 0.5 * platform_turn_zx;
    const EACH4 given_5 = {t43, t37, t43, t37};
    const REAL platform_twist_wz = limb5_S_rate_wz * platform_turn_zz + (t40 + limb5_S_rate_wy * platform_turn_zy);
    const EACH4 platform_twist_wy_2 = {platform_twist_wy, platform_twist_wz, platform_twist_wy, platform_twist_wz},
      platform_twist_wz_2 = {platform_twist_wz, platform_twist_wx, platform_twist_wz, platform_twist_wx};
    const REAL t21 = param_H * platform_turn_zz;
    const EACH4 given = {t14, t21, t14, t21};
    const REAL t22 = 0.5 * platform_turn_zy;
    const EACH4 given_2 = {t18, t22, t18, t22};
    const REAL t38 = 0.5 * platform_turn_yy;
    const EACH4 given_4 = {t37, t38, t37, t38};
    const REAL t44 = 0.5 * platform_turn_xy;
    const EACH4 given_6 = {t21, t44, t21, t44};
    FIRST_LIMB(3, inverse_velocity, 0, stride, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    FIRST_LIMB(3, inverse_velocity, 1, stride, v, platform_twist_wx_2, platform_twist_wy_2, platform_twist_wz_2,
        &limbs);
    REAL checked0 = ALONE(limbs.checked[3]);
    NEXT_LIMB(2, inverse_velocity, 0, stride, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    NEXT_LIMB(2, inverse_velocity, 1, stride, v, platform_twist_wx_2, platform_twist_wy_2, platform_twist_wz_2,
        &limbs);
    REAL checked1 = ALONE(limbs.checked[2]);
    NEXT_LIMB(1, inverse_velocity, 0, stride, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    NEXT_LIMB(0, inverse_velocity, 0, stride, given, given_2, given_3, given_4, given_5, given_6, &limbs);
    NEXT_LIMB(1, inverse_velocity, 1, stride, v, platform_twist_wx_2, platform_twist_wy_2, platform_twist_wz_2,
        &limbs);
    REAL checked2 = ALONE(limbs.checked[1]);
    NEXT_LIMB(0, inverse_velocity, 1, stride, v, platform_twist_wx_2, platform_twist_wy_2, platform_twist_wz_2,
        &limbs);
    REAL checked3 = ALONE(limbs.checked[0]);
    const REAL t48 = limbs.signed_lower_sin[0] * (platform_turn_yy * limbs.signed_U_0_sin[0] + platform_turn_zy *
        limbs.signed_U_0_cos[0]), /* limb1 */
      limb1_U2_opening_mn = platform_turn_xy * limbs.signed_lower_cos[0] - t48,
      t50 = limb1_U2_opening_mn * limb1_U2_opening_mn;
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    /* else status 6: not on the mechanism */
    NOT_ABOVE(t50, 1.0e-12, 6);
    FINITE_UNLESS4( /* status 1 where a pivot is smaller than its limit: */
        SMALL4(limbs.lower_limb_length, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10) OR
            /* where the points of limb_lower coincide */
        SMALL4(limbs.signed_U_0_lever_mz_by_S_fz, 6.62327e-10, 6.62327e-10, 6.62327e-10, 6.62327e-10),
            /* where the reciprocal wrench limb_U2.fz has no power along limb_U.0, as in a stretched limb; where the
               reciprocal wrench limb_S.fz has no power along limb_U.0, as in a stretched limb */
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
      platform_turn_xx = 1.0 - t7 * t10, t39 = t3 + t5, platform_turn_yy = 1.0 - t10 * (t3 + t6), t507 = t6 + t39,
      platform_turn_zz = 1.0 - t10 * t39, t508 = SQRT(t507), t13 = limb5_S_q_qz * t10, t19 = limb5_S_q_qy * t13,
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
    const REAL limb1_U2_displacements_0 = atan2(minus_limb1_U2_constraint_mn_couple_z, limb1_U_0_cos *
        platform_turn_yy + limb1_U_0_sin * platform_turn_zy);
    WRITE(displacements, 3, limb1_U2_displacements_0);
    REAL checked1 = limb1_U2_displacements_0;
    const REAL limb1_lower_rotation_yy = limb1_U_0_sin * limb1_lower_sin,
      t37 = platform_turn_yz * limb1_lower_rotation_yy,
      t30 = limb1_lower_cos * platform_turn_xx + platform_turn_yx * limb1_lower_rotation_yy,
      platform_turn_zx = t31 - t32, platform_turn_xz = t31 + t32,
      minus_limb1_lower_rotation_zy = limb1_U_0_cos * limb1_lower_sin,
      t34 = t30 - platform_turn_zx * minus_limb1_lower_rotation_zy, t35 = (-0.5) * t34, t45 = k1 * t34,
      t42 = limb1_lower_cos * platform_turn_xz + t37 - platform_turn_zz * minus_limb1_lower_rotation_zy,
      t48 = atan2(t35 - k1 * t42, t45 - 0.5 * t42);
    REAL checked2 = t48;
    WRITE(displacements, 4, -t48);
    /* platform: results */
    const REAL t54 = 0.5 * platform_turn_zy, t55 = k1 * platform_turn_zz, t76 = 0.5 * platform_turn_zz,
      t56 = t54 + t55, t361 = t54 - t55, limb2_U_0_sin = SINES(cosine, 2), minus_limb2_U_0_cos = SINES(sine, 2),
      t57 = limb2_U_0_sin * t56, /* limb2 */
      t142 = minus_limb2_U_0_cos * t56, /* limb2 */
      t58 = 0.5 * platform_turn_xy, t59 = k1 * platform_turn_xz, t80 = 0.5 * platform_turn_xz, t60 = t58 + t59,
      t363 = t58 - t59, t62 = t57 + minus_limb2_U_0_cos * t60, /* limb2 */
      t144 = t142 - limb2_U_0_sin * t60, /* limb2 */
      limb2_lower_cos = SINES(cosine, 3), limb2_lower_sin = SINES(sine, 3),
      t63 = limb2_lower_cos * t62, /* limb2 */
      t70 = limb2_lower_sin * t62, /* limb2 */
      t65 = k1 * platform_turn_yz, t86 = 0.5 * platform_turn_yz, t64 = 0.5 * platform_turn_yy, t66 = t64 + t65,
      t367 = t64 - t65;
    /* limb2: results */
    const REAL t68 = t63 - limb2_lower_sin * t66, t72 = t70 + limb2_lower_cos * t66, t100 = k1 * t68,
      t74 = 0.5 * t68 + k1 * t72, t102 = t100 - 0.5 * t72, t75 = 0.5 * t74, t161 = k1 * t74,
      t77 = k1 * platform_turn_zy, /* platform */
      t78 = t76 - t77, /* platform */
      t377 = t76 + t77, /* platform */
      t79 = limb2_U_0_sin * t78, t146 = minus_limb2_U_0_cos * t78, t81 = k1 * platform_turn_xy, /* platform */
      t82 = t80 - t81, /* platform */
      t379 = t80 + t81, /* platform */
      t84 = t79 + minus_limb2_U_0_cos * t82, t148 = t146 - limb2_U_0_sin * t82, t85 = limb2_lower_cos * t84,
      t92 = limb2_lower_sin * t84, t87 = k1 * platform_turn_yy, /* platform */
      t88 = t86 - t87, /* platform */
      t383 = t86 + t87, /* platform */
      t90 = t85 - limb2_lower_sin * t88, t94 = t92 + limb2_lower_cos * t88, t104 = k1 * t90,
      t96 = 0.5 * t90 + k1 * t94, t106 = t104 - 0.5 * t94, t98 = t75 - k1 * t96, t163 = t161 + 0.5 * t96,
      t118 = 1.0 - 2.0 * t98, t51 = minus_limb2_U_0_cos * platform_turn_zx - limb2_U_0_sin * platform_turn_xx,
      t120 = t98 + (t51 + t118), t164 = 0.5 * t102, t108 = k1 * t102 + 0.5 * t106, t121 = t108 + t120,
      t166 = t164 - k1 * t106, t109 = 1.0 - t51 - t98 - t108, t114 = t108 + (t98 + (t51 + (1.0 - 2.0 * t51))),
      t115 = LESS(t109, t114), t116 = SELECT(t115, t114, t109), t122 = LESS(t116, t121),
      t123 = SELECT(t122, t121, t116), t128 = t108 + (t98 + (t51 + (1.0 - 2.0 * t108))), t129 = LESS(t123, t128),
      t174 = 1.0 / (2.0 * SQRT(SELECT(t129, t128, t123))), t167 = t163 - t166, t168 = SELECT(t115, t114, t167),
      t178 = SELECT(t115, t167, t109), t186 = -(t163 + t166),
      t132 = limb2_U_0_sin * platform_turn_zx + minus_limb2_U_0_cos * platform_turn_xx,
      t137 = limb2_lower_sin * t132, t135 = limb2_lower_cos * t132 - limb2_lower_sin * platform_turn_yx,
      t153 = 0.5 * t135, t136 = k1 * t135, t139 = t137 + limb2_lower_cos * platform_turn_yx, t155 = t153 + k1 *
          t139,
      t141 = t136 - 0.5 * t139, t145 = k1 * t144, t158 = 0.5 * t144 - k1 * t148, t150 = t145 + 0.5 * t148,
      t159 = t155 + t158, t176 = t158 - t155, t160 = -t159, t169 = SELECT(t122, t160, t168), t151 = t141 + t150,
      t177 = t141 - t150, t152 = -t151, t175 = SELECT(t129, t152, t169) * t174,
      t195 = SELECT(t129, t128, SELECT(t122, t186, SELECT(t115, t152, t176))),
      t180 = SELECT(t129, t176, SELECT(t122, t177, t178)),
      t190 = SELECT(t129, t186, SELECT(t122, t121, SELECT(t115, t160, t177))) * t174, t196 = t195 * t174,
      t181 = t180 * t174, t199 = SQRT(t175 * t175 + t190 * t190 + t196 * t196),
      t183 = SELECT(LESS(t181, 0.0), (-1.0), 1.0), t203 = 2.0 * atan2(t199, t181 * t183), t200 = LESS(t199,
          1.0e-08),
      t207 = t183 * SELECT(t200, 2.0, t203 / SELECT(t200, 1.0, t199)), limb2_S_displacements_x = t175 * t207;
    WRITE(displacements, 8, limb2_S_displacements_x);
    REAL checked3 = limb2_S_displacements_x;
    RESULT(checked0, displacements, 9, t190 * t207);
    RESULT(checked1, displacements, 10, t196 * t207);
    const REAL t210 = 0.5 * platform_turn_yx - t65; /* platform */
    /* limb3: geometry */
    const REAL limb3_U_0_sin = SINES(sine, 4), limb3_U_0_cos = SINES(cosine, 4);
    /* limb3: results; geometry */
    const REAL t211 = limb3_U_0_sin * t210, t303 = limb3_U_0_cos * t210,
      t213 = 0.5 * platform_turn_zx - t55, /* platform */
      t215 = t211 - limb3_U_0_cos * t213, t305 = t303 + limb3_U_0_sin * t213, limb3_lower_cos = SINES(cosine, 5),
      minus_limb3_lower_sin = SINES(sine, 5), t216 = limb3_lower_cos * t215, t222 = minus_limb3_lower_sin * t215,
      t218 = 0.5 * platform_turn_xx - t59, /* platform */
      t220 = t216 + minus_limb3_lower_sin * t218, t224 = t222 - limb3_lower_cos * t218, t221 = k1 * t220,
      t253 = 0.5 * t220 - k1 * t224, t226 = t221 + 0.5 * t224, t254 = 0.5 * t253, t283 = k1 * t253,
      t229 = k1 * platform_turn_yx + t86, /* platform */
      t230 = limb3_U_0_sin * t229, t307 = limb3_U_0_cos * t229, t232 = k1 * platform_turn_zx + t76, /* platform */
      t234 = t230 - limb3_U_0_cos * t232, t309 = t307 + limb3_U_0_sin * t232, t235 = limb3_lower_cos * t234,
      t241 = minus_limb3_lower_sin * t234, t237 = k1 * platform_turn_xx + t80, /* platform */
      t239 = t235 + minus_limb3_lower_sin * t237, t243 = t241 - limb3_lower_cos * t237, t240 = k1 * t239,
      t257 = 0.5 * t239 - k1 * t243, t245 = t240 + 0.5 * t243, t259 = t254 + k1 * t257, t285 = t283 - 0.5 * t257,
      t265 = 1.0 + 2.0 * t259 - t259, t292 = limb3_U_0_cos * platform_turn_zy,
      t250 = limb3_U_0_cos * platform_turn_yy + limb3_U_0_sin * platform_turn_zy, t266 = t265 - t250,
      t293 = limb3_U_0_sin * platform_turn_yy - t292, t286 = 0.5 * t226, t247 = k1 * t226 - 0.5 * t245,
      t267 = t266 - t247, t288 = t286 + k1 * t245, t262 = t247 + (t250 + (1.0 + t259)), t268 = LESS(t262, t267),
      t269 = SELECT(t268, t267, t262), t274 = 1.0 + 2.0 * t250 - t259 - t250 - t247, t275 = LESS(t269, t274),
      t276 = SELECT(t275, t274, t269), t281 = 1.0 + 2.0 * t247 - t259 - t250 - t247, t282 = LESS(t276, t281),
      t326 = 1.0 / (2.0 * SQRT(SELECT(t282, t281, t276))), t306 = 0.5 * t305, t315 = k1 * t305 - 0.5 * t309,
      t311 = t306 + k1 * t309, t298 = minus_limb3_lower_sin * t293,
      t296 = limb3_lower_cos * t293 + minus_limb3_lower_sin * platform_turn_xy,
      t300 = t298 - limb3_lower_cos * platform_turn_xy, t297 = 0.5 * t296, t318 = k1 * t296 + 0.5 * t300,
      t302 = t297 - k1 * t300, t319 = t315 - t318, t320 = SELECT(t268, t267, t319), t330 = SELECT(t268, t319, t262),
      t338 = -(t318 + t315), t312 = t302 + t311, t328 = t311 - t302, t321 = SELECT(t275, t312, t320),
      t289 = t285 + t288, t329 = t288 - t285, t290 = -t289, t327 = SELECT(t282, t290, t321) * t326,
      t347 = SELECT(t282, t281, SELECT(t275, t338, SELECT(t268, t290, t328))),
      t332 = SELECT(t282, t328, SELECT(t275, t329, t330)),
      t342 = SELECT(t282, t338, SELECT(t275, t274, SELECT(t268, t312, t329))) * t326, t348 = t347 * t326,
      t333 = t332 * t326, t351 = SQRT(t327 * t327 + t342 * t342 + t348 * t348),
      t335 = SELECT(LESS(t333, 0.0), (-1.0), 1.0), t355 = 2.0 * atan2(t351, t333 * t335), t352 = LESS(t351,
          1.0e-08),
      t359 = t335 * SELECT(t352, 2.0, t355 / SELECT(t352, 1.0, t351));
    RESULT(checked2, displacements, 14, t327 * t359);
    RESULT(checked3, displacements, 15, t342 * t359);
    RESULT(checked0, displacements, 16, t348 * t359);
    /* limb4: geometry */
    const REAL limb4_U_0_sin = SINES(cosine, 6), minus_limb4_U_0_cos = SINES(sine, 6);
    /* limb4: results; geometry */
    const REAL t429 = minus_limb4_U_0_cos * t361, t365 = limb4_U_0_sin * t361 + minus_limb4_U_0_cos * t363,
      t431 = t429 - limb4_U_0_sin * t363, limb4_lower_cos = SINES(cosine, 7), minus_limb4_lower_sin =
          SINES(sine, 7),
      t371 = minus_limb4_lower_sin * t365, t369 = limb4_lower_cos * t365 + minus_limb4_lower_sin * t367,
      t373 = t371 - limb4_lower_cos * t367, t370 = k1 * t369, t396 = 0.5 * t369 + k1 * t373,
      t375 = t370 - 0.5 * t373, t397 = 0.5 * t396, t458 = k1 * t396, t433 = minus_limb4_U_0_cos * t377,
      t381 = limb4_U_0_sin * t377 + minus_limb4_U_0_cos * t379, t435 = t433 - limb4_U_0_sin * t379,
      t387 = minus_limb4_lower_sin * t381, t385 = limb4_lower_cos * t381 + minus_limb4_lower_sin * t383,
      t389 = t387 - limb4_lower_cos * t383, t386 = k1 * t385, t400 = 0.5 * t385 + k1 * t389,
      t391 = t386 - 0.5 * t389, t402 = t397 + k1 * t400, t460 = t458 - 0.5 * t400, t417 = 1.0 + 2.0 * t402,
      t438 = limb4_U_0_sin * platform_turn_zx,
      t405 = minus_limb4_U_0_cos * platform_turn_zx - limb4_U_0_sin * platform_turn_xx, t419 = t405 + t417 - t402,
      t440 = t438 + minus_limb4_U_0_cos * platform_turn_xx, t461 = 0.5 * t375, t393 = k1 * t375 - 0.5 * t391,
      t420 = t419 - t393, t463 = t461 + k1 * t391, t408 = t393 + (t402 + (1.0 - t405)),
      t413 = t405 + (1.0 - 2.0 * t405) - t402 - t393, t414 = LESS(t408, t413), t415 = SELECT(t414, t413, t408),
      t421 = LESS(t415, t420), t422 = SELECT(t421, t420, t415), t427 = t405 + (1.0 + 2.0 * t393) - t402 - t393,
      t428 = LESS(t422, t427), t471 = 1.0 / (2.0 * SQRT(SELECT(t428, t427, t422))), t464 = t460 - t463,
      t465 = SELECT(t414, t413, t464), t475 = SELECT(t414, t464, t408), t483 = -(t460 + t463),
      t445 = minus_limb4_lower_sin * t440, t443 = limb4_lower_cos * t440 + minus_limb4_lower_sin * platform_turn_yx,
      t447 = t445 - limb4_lower_cos * platform_turn_yx, t444 = k1 * t443, t453 = 0.5 * t443 + k1 * t447,
      t449 = t444 - 0.5 * t447, t432 = k1 * t431, t456 = 0.5 * t431 + k1 * t435, t437 = t432 - 0.5 * t435,
      t457 = t453 - t456, t473 = t453 + t456, t466 = SELECT(t421, t457, t465), t450 = t437 - t449,
      t474 = t449 + t437, t472 = SELECT(t428, t450, t466) * t471,
      t492 = SELECT(t428, t427, SELECT(t421, t483, SELECT(t414, t450, t473))),
      t477 = SELECT(t428, t473, SELECT(t421, t474, t475)),
      t487 = SELECT(t428, t483, SELECT(t421, t420, SELECT(t414, t457, t474))) * t471, t493 = t492 * t471,
      t478 = t477 * t471, t496 = SQRT(t472 * t472 + t487 * t487 + t493 * t493),
      t480 = SELECT(LESS(t478, 0.0), (-1.0), 1.0), t500 = 2.0 * atan2(t496, t478 * t480), t497 = LESS(t496,
          1.0e-08),
      t504 = t480 * SELECT(t497, 2.0, t500 / SELECT(t497, 1.0, t496));
    RESULT(checked1, displacements, 20, t472 * t504);
    RESULT(checked2, displacements, 21, t487 * t504);
    RESULT(checked3, displacements, 22, t493 * t504);
    const REAL t506 = SELECT(LESS(limb5_S_q_qw, 0.0), (-1.0), 1.0), /* limb5_S */
      t512 = 2.0 * atan2(t508, limb5_S_q_qw * t506), /* limb5_S */
      t509 = LESS(t508, 1.0e-08), /* limb5_S */
      t516 = t506 * SELECT(t509, 2.0, t512 / SELECT(t509, 1.0, t508)); /* limb5_S */
    RESULT(checked0, displacements, 23, limb5_S_q_qx * t516);
    RESULT(checked1, displacements, 24, limb5_S_q_qy * t516);
    RESULT(checked2, displacements, 25, limb5_S_q_qz * t516);
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
