/*
 * four_bar: further.
 *   drive_positions
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

BODY(four_bar_drive_positions)(size_t stride, const double *restrict pose, double *restrict positions,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* D: geometry */
    REAL checked0 = READ(pose, 0);
    /* rocker: geometry; balance, eqs. (40)-(47); reciprocal wrenches, eq. (10) */
    const REAL t3 = D_at_x - k6 * SINES(sine, 0), t4 = t3 * t3,
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 0),
      t5 = minus_rocker_joint_force_my_by_C_fz * minus_rocker_joint_force_my_by_C_fz + t4, t7 = t5 - k12,
      t6 = 1.0 / t5, t9 = 0.5 * t7, t11 = k14 - t9 * t9, t12 = SQRT(t11),
      minus_crank_lever_my_by_C_fz = B_at_z + k13 * t7, crank_lever_mx_by_C_fz = k15 * SELECT(0.0, -t12, t12),
      t15 = minus_rocker_joint_force_my_by_C_fz * crank_lever_mx_by_C_fz, /* crank */
      t18 = t3 * crank_lever_mx_by_C_fz, /* crank */
      crank_sin = t6 * (t3 * minus_crank_lever_my_by_C_fz - t15),
      A_positions = atan2(crank_sin, t6 * (minus_rocker_joint_force_my_by_C_fz * minus_crank_lever_my_by_C_fz + t18));
    WRITE(positions, 0, A_positions);
    REAL checked1 = A_positions;
    NOT_BELOW(t11, 0.0, 11);
    FINITE(checked0 + checked1);
}

int four_bar_drive_positions(const double *restrict pose, double *restrict positions)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines9(pose, sine, cosine);
    const int outcome = four_bar_drive_positions_body(1, pose, positions, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(positions, 1);
    }
    return outcome;
}
