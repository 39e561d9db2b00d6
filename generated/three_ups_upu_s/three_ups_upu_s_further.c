/*
 * three_ups_upu_s: further.
 *   drive_positions
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

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
      platform_turn_xz = t20 + t21, t22 = 0.5 * (t20 - t21), t30 = param_H * platform_turn_xz,
      minus_limb1_lower_limb_target_y = t22 - t25, limb3_lower_limb_target_y = t22 + t25,
      t45 = t43 + limb3_lower_limb_target_y * limb3_lower_limb_target_y; /* limb3 */
    /* limb1: geometry; results; loop closure */
    const REAL t27 = t19 + minus_limb1_lower_limb_target_y * minus_limb1_lower_limb_target_y,
      limb1_lower_limb_target_z = param_R - (t29 - t30), minus_limb3_lower_limb_target_z = param_R - (t29 + t30),
      limb3_P_positions = SQRT(t45 + minus_limb3_lower_limb_target_z * minus_limb3_lower_limb_target_z) - limb_upper_phase;
    WRITE(positions, 2, limb3_P_positions);
    REAL checked0 = limb3_P_positions;
    const REAL limb1_lower_limb_length = SQRT(t27 + limb1_lower_limb_target_z * limb1_lower_limb_target_z),
      limb1_P_positions = limb1_lower_limb_length - limb_upper_phase;
    WRITE(positions, 0, limb1_P_positions);
    REAL checked1 = limb1_P_positions;
    const REAL minus_limb1_U_0_lever_mz_by_limb1_U2_fz = SQRT(t27), t53 = 1.0 / limb1_lower_limb_length,
      limb1_lower_sin = limb1_lower_limb_target_z * t53,
      limb1_lower_cos = minus_limb1_U_0_lever_mz_by_limb1_U2_fz * t53,
      t54 = 1.0 / minus_limb1_U_0_lever_mz_by_limb1_U2_fz,
      minus_limb1_U_0_cos = minus_limb1_lower_limb_target_y * t54,
      t55 = platform_turn_yy * (minus_limb1_lower_limb_target_x * t54),
      t40 = 0.5 * platform_turn_yy, /* platform */
      t58 = limb1_lower_sin * (t55 + platform_turn_zy * minus_limb1_U_0_cos),
      t33 = 0.5 * platform_turn_zy, /* platform */
      limb1_U2_opening_mn = t58 + platform_turn_xy * limb1_lower_cos, t60 = limb1_U2_opening_mn * limb1_U2_opening_mn,
      t35 = 0.5 * platform_turn_xy, /* platform */
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
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
    NOT_ABOVE(t60, 1.0e-12, 6);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

#if !defined(THREE_UPS_UPU_S_VECTORS)

int three_ups_upu_s_drive_positions(const double *restrict pose, double *restrict positions)
{
    const int outcome = three_ups_upu_s_drive_positions_body(1, pose, positions, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(positions, 4);
    }
    return outcome;
}
#endif /* THREE_UPS_UPU_S_VECTORS */
