/*
 * four_bar: kinematics.
 *   body_poses; body_twists; body_twist_rates; forward_kinematics; point_motion; joint_screws;
 *   joint_points; platform_jacobian; joint_displacements; joint_rates; drive_rates;
 *   inverse_kinematics; drive_positions; inverse_velocity
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

BODY(four_bar_body_poses)(size_t stride, const double *restrict q, double *restrict poses,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0);
    WRITE(poses, 6, crank_sin);
    WRITE(poses, 2, -crank_sin);
    /* rocker: geometry */
    const REAL minus_rocker_sin = SINES(sine, 2), rocker_cos = SINES(cosine, 2);
    /* rocker: results */
    const REAL rocker_poses_Rzx = k4 * minus_rocker_sin - k3 * rocker_cos;
    WRITE(poses, 26, rocker_poses_Rzx);
    const REAL rocker_poses_z = (-D_at_x) * rocker_poses_Rzx;
    WRITE(poses, 35, rocker_poses_z);
    REAL checked0 = rocker_poses_z;
    WRITE(poses, 30, -rocker_poses_Rzx);
    const REAL rocker_poses_Rxx = k3 * minus_rocker_sin + k4 * rocker_cos;
    WRITE(poses, 24, rocker_poses_Rxx);
    WRITE(poses, 32, rocker_poses_Rxx);
    const REAL rocker_poses_x = D_at_x - D_at_x * rocker_poses_Rxx;
    WRITE(poses, 33, rocker_poses_x);
    REAL checked1 = rocker_poses_x;
    /* coupler: geometry */
    const REAL coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    WRITE(poses, 0, crank_cos);
    WRITE(poses, 8, crank_cos);
    const REAL coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos *
        coupler_sin;
    /* coupler: results; geometry */
    const REAL t4 = k1 * coupler_rotation_xx, t8 = k2 * coupler_rotation_xx,
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      coupler_poses_Rxx = t4 - k2 * minus_coupler_rotation_xy;
    WRITE(poses, 12, coupler_poses_Rxx);
    WRITE(poses, 20, coupler_poses_Rxx);
    const REAL coupler_poses_z = B_at_z * (crank_cos - coupler_poses_Rxx);
    WRITE(poses, 23, coupler_poses_z);
    REAL checked2 = coupler_poses_z;
    const REAL coupler_poses_Rxz = t8 + k1 * minus_coupler_rotation_xy;
    WRITE(poses, 18, coupler_poses_Rxz);
    WRITE(poses, 14, -coupler_poses_Rxz);
    const REAL coupler_poses_x = B_at_z * (crank_sin - coupler_poses_Rxz);
    WRITE(poses, 21, coupler_poses_x);
    REAL checked3 = coupler_poses_x;
    WRITE(poses, 1, CONSTANT(0.0));
    WRITE(poses, 3, CONSTANT(0.0));
    WRITE(poses, 4, CONSTANT(1.0));
    WRITE(poses, 5, CONSTANT(0.0));
    WRITE(poses, 7, CONSTANT(0.0));
    WRITE(poses, 9, CONSTANT(0.0));
    WRITE(poses, 10, CONSTANT(0.0));
    WRITE(poses, 11, CONSTANT(0.0));
    WRITE(poses, 13, CONSTANT(0.0));
    WRITE(poses, 15, CONSTANT(0.0));
    WRITE(poses, 16, CONSTANT(1.0));
    WRITE(poses, 17, CONSTANT(0.0));
    WRITE(poses, 19, CONSTANT(0.0));
    WRITE(poses, 22, CONSTANT(0.0));
    WRITE(poses, 25, CONSTANT(0.0));
    WRITE(poses, 27, CONSTANT(0.0));
    WRITE(poses, 28, CONSTANT(1.0));
    WRITE(poses, 29, CONSTANT(0.0));
    WRITE(poses, 31, CONSTANT(0.0));
    WRITE(poses, 34, CONSTANT(0.0));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_body_twists)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict twists, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    REAL checked0 = READ(q, 1);
    REAL checked1 = READ(q, 2);
    /* A: velocities, eq. (6) */
    const REAL A_v = READ(v, 0);
    WRITE(twists, 1, A_v);
    const REAL B_v = READ(v, 1), coupler_omega_z = A_v + B_v;
    WRITE(twists, 7, coupler_omega_z);
    REAL checked2 = coupler_omega_z;
    const REAL D_v = READ(v, 2);
    WRITE(twists, 13, D_v);
    const REAL rocker_twist_vz = D_at_x * D_v;
    WRITE(twists, 17, rocker_twist_vz);
    REAL checked3 = rocker_twist_vz;
    RESULT(checked0, twists, 9, (-B_at_z) * SINES(cosine, 0) * B_v);
    RESULT(checked1, twists, 11, B_v * (B_at_z * SINES(sine, 0)));
    WRITE(twists, 0, CONSTANT(0.0));
    WRITE(twists, 2, CONSTANT(0.0));
    WRITE(twists, 3, CONSTANT(0.0));
    WRITE(twists, 4, CONSTANT(0.0));
    WRITE(twists, 5, CONSTANT(0.0));
    WRITE(twists, 6, CONSTANT(0.0));
    WRITE(twists, 8, CONSTANT(0.0));
    WRITE(twists, 10, CONSTANT(0.0));
    WRITE(twists, 12, CONSTANT(0.0));
    WRITE(twists, 14, CONSTANT(0.0));
    WRITE(twists, 15, CONSTANT(0.0));
    WRITE(twists, 16, CONSTANT(0.0));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_body_twist_rates)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict twist_rates, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    REAL checked0 = READ(q, 1);
    REAL checked1 = READ(q, 2);
    REAL checked2 = READ(v, 2);
    /* A: accelerations */
    const REAL A_a = READ(a, 0);
    WRITE(twist_rates, 1, A_a);
    const REAL B_a = READ(a, 1), coupler_twist_rate_wy = A_a + B_a;
    WRITE(twist_rates, 7, coupler_twist_rate_wy);
    REAL checked3 = coupler_twist_rate_wy;
    const REAL D_a = READ(a, 2);
    WRITE(twist_rates, 13, D_a);
    RESULT(checked0, twist_rates, 17, D_at_x * D_a);
    const REAL coupler_position_x = B_at_z * SINES(sine, 0), A_v = READ(v, 0), B_v = READ(v, 1),
      t2 = B_v * (A_v * coupler_position_x), /* coupler */
      t4 = B_a * coupler_position_x, /* coupler */
      coupler_position_z = B_at_z * SINES(cosine, 0);
    RESULT(checked1, twist_rates, 9, t2 - B_a * coupler_position_z);
    RESULT(checked2, twist_rates, 11, t4 + B_v * (A_v * coupler_position_z));
    WRITE(twist_rates, 0, CONSTANT(0.0));
    WRITE(twist_rates, 2, CONSTANT(0.0));
    WRITE(twist_rates, 3, CONSTANT(0.0));
    WRITE(twist_rates, 4, CONSTANT(0.0));
    WRITE(twist_rates, 5, CONSTANT(0.0));
    WRITE(twist_rates, 6, CONSTANT(0.0));
    WRITE(twist_rates, 8, CONSTANT(0.0));
    WRITE(twist_rates, 10, CONSTANT(0.0));
    WRITE(twist_rates, 12, CONSTANT(0.0));
    WRITE(twist_rates, 14, CONSTANT(0.0));
    WRITE(twist_rates, 15, CONSTANT(0.0));
    WRITE(twist_rates, 16, CONSTANT(0.0));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_forward_kinematics)(size_t stride, const double *restrict q, double *restrict positions,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    REAL checked0 = READ(q, 2);
    /* coupler: results */
    const REAL t3 = B_at_z + k5 * SINES(cosine, 1), crank_sin = SINES(sine, 0), crank_cos = SINES(cosine, 0);
    /* coupler_middle: results */
    const REAL t4 = crank_sin * t3, t7 = crank_cos * t3, t5 = k5 * SINES(sine, 1), /* coupler */
      coupler_middle_positions_x = t4 + crank_cos * t5;
    WRITE(positions, 0, coupler_middle_positions_x);
    REAL checked1 = coupler_middle_positions_x;
    const REAL coupler_middle_positions_z = t7 - crank_sin * t5;
    WRITE(positions, 2, coupler_middle_positions_z);
    REAL checked2 = coupler_middle_positions_z;
    WRITE(positions, 1, CONSTANT(0.0));
    FINITE((checked0 + checked1) + checked2);
}

BODY(four_bar_point_motion)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict positions, double *restrict velocities,
    double *restrict accelerations, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    REAL checked0 = READ(q, 2);
    REAL checked1 = READ(v, 2);
    REAL checked2 = READ(a, 2);
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_sin = SINES(sine, 1), crank_cos = SINES(cosine, 0),
      coupler_cos = SINES(cosine, 1), t7 = k5 * (crank_sin * coupler_sin - crank_cos * coupler_cos), /* coupler */
      coupler_position_z = B_at_z * crank_cos, coupler_middle_positions_z = coupler_position_z - t7;
    WRITE(positions, 2, coupler_middle_positions_z);
    const REAL A_v = READ(v, 0), B_v = READ(v, 1), coupler_omega_z = A_v + B_v;
    /* coupler_middle: results */
    const REAL t9 = B_v * coupler_position_z - coupler_omega_z * coupler_middle_positions_z;
    WRITE(velocities, 0, -t9);
    const REAL t22 = coupler_omega_z * t9,
      t4 = k5 * (crank_sin * coupler_cos + crank_cos * coupler_sin), /* coupler */
      coupler_position_x = B_at_z * crank_sin, coupler_middle_positions_x = coupler_position_x + t4;
    WRITE(positions, 0, coupler_middle_positions_x);
    const REAL coupler_middle_velocities_z = B_v * coupler_position_x - coupler_omega_z *
        coupler_middle_positions_x;
    WRITE(velocities, 2, coupler_middle_velocities_z);
    const REAL B_a = READ(a, 1), t11 = coupler_omega_z * coupler_middle_velocities_z,
      coupler_twist_rate_wy = READ(a, 0) + B_a, t15 = coupler_twist_rate_wy * coupler_middle_positions_z,
      t20 = coupler_twist_rate_wy * coupler_middle_positions_x, t17 = B_a * coupler_position_x, /* coupler */
      coupler_middle_accelerations_x = t11 - (B_a * coupler_position_z - B_v * (A_v * coupler_position_x) - t15);
    WRITE(accelerations, 0, coupler_middle_accelerations_x);
    REAL checked3 = coupler_middle_accelerations_x;
    RESULT(checked0, accelerations, 2, t17 + B_v * (A_v * coupler_position_z) - t20 + t22);
    WRITE(positions, 1, CONSTANT(0.0));
    WRITE(velocities, 1, CONSTANT(0.0));
    WRITE(accelerations, 1, CONSTANT(0.0));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_joint_screws)(size_t stride, const double *restrict q, double *restrict screws,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    REAL checked0 = READ(q, 2);
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), t7 = 0.5 * (crank_sin * coupler_cos + crank_cos * coupler_sin), /* coupler */
      coupler_position_x = B_at_z * crank_sin;
    WRITE(screws, 11, coupler_position_x);
    const REAL C_screws_vz = coupler_position_x + t7;
    WRITE(screws, 17, C_screws_vz);
    REAL checked1 = C_screws_vz;
    const REAL t4 = 0.5 * (crank_sin * coupler_sin - crank_cos * coupler_cos), /* coupler */
      coupler_position_z = B_at_z * crank_cos, C_screws_vx = t4 - coupler_position_z;
    WRITE(screws, 15, C_screws_vx);
    REAL checked2 = C_screws_vx;
    WRITE(screws, 9, -coupler_position_z);
    WRITE(screws, 0, CONSTANT(0.0));
    WRITE(screws, 1, CONSTANT(1.0));
    WRITE(screws, 2, CONSTANT(0.0));
    WRITE(screws, 3, CONSTANT(0.0));
    WRITE(screws, 4, CONSTANT(0.0));
    WRITE(screws, 5, CONSTANT(0.0));
    WRITE(screws, 6, CONSTANT(0.0));
    WRITE(screws, 7, CONSTANT(1.0));
    WRITE(screws, 8, CONSTANT(0.0));
    WRITE(screws, 10, CONSTANT(0.0));
    WRITE(screws, 12, CONSTANT(0.0));
    WRITE(screws, 13, CONSTANT(1.0));
    WRITE(screws, 14, CONSTANT(0.0));
    WRITE(screws, 16, CONSTANT(0.0));
    WRITE(screws, 18, CONSTANT(0.0));
    WRITE(screws, 19, CONSTANT(1.0));
    WRITE(screws, 20, CONSTANT(0.0));
    WRITE(screws, 21, CONSTANT(0.0));
    WRITE(screws, 22, CONSTANT(0.0));
    WRITE(screws, 23, CONSTANT(D_at_x));
    FINITE((checked0 + checked1) + checked2);
}

BODY(four_bar_joint_points)(size_t stride, const double *restrict q, double *restrict points,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    REAL checked0 = READ(q, 2);
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0);
    /* coupler: geometry; results */
    const REAL coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0), coupler_sin = SINES(sine, 1),
      t4 = 0.5 * (crank_sin * coupler_cos + crank_cos * coupler_sin), coupler_position_x = B_at_z * crank_sin;
    WRITE(points, 3, coupler_position_x);
    const REAL C_points_x = coupler_position_x + t4;
    WRITE(points, 6, C_points_x);
    REAL checked1 = C_points_x;
    const REAL t7 = 0.5 * (crank_sin * coupler_sin - crank_cos * coupler_cos),
      coupler_position_z = B_at_z * crank_cos;
    WRITE(points, 5, coupler_position_z);
    const REAL C_points_z = coupler_position_z - t7;
    WRITE(points, 8, C_points_z);
    REAL checked2 = C_points_z;
    WRITE(points, 0, CONSTANT(0.0));
    WRITE(points, 1, CONSTANT(0.0));
    WRITE(points, 2, CONSTANT(0.0));
    WRITE(points, 4, CONSTANT(0.0));
    WRITE(points, 7, CONSTANT(0.0));
    WRITE(points, 9, CONSTANT(D_at_x));
    WRITE(points, 10, CONSTANT(0.0));
    WRITE(points, 11, CONSTANT(0.0));
    FINITE((checked0 + checked1) + checked2);
}

BODY(four_bar_platform_jacobian)(size_t stride, const double *restrict q, double *restrict jacobian,
    double *restrict total)
{
    REAL checked0 = READ(q, 0);
    REAL checked1 = READ(q, 1);
    REAL checked2 = READ(q, 2);
    WRITE(jacobian, 13, CONSTANT(1.0));
    WRITE(jacobian, 14, CONSTANT(0.0));
    WRITE(jacobian, 15, CONSTANT(0.0));
    WRITE(jacobian, 16, CONSTANT(0.0));
    WRITE(jacobian, 17, CONSTANT(D_at_x));
    FINITE((checked0 + checked1) + checked2);
}

BODY(four_bar_joint_displacements)(size_t stride, const double *restrict q, double *restrict displacements,
    double *restrict total)
{
    /* D: results */
    const REAL D_q = READ(q, 2);
    WRITE(displacements, 3, D_q);
    const REAL A_q = READ(q, 0);
    WRITE(displacements, 0, A_q);
    const REAL B_q = READ(q, 1);
    WRITE(displacements, 1, B_q);
    const REAL C_displacements = D_q - A_q - B_q;
    WRITE(displacements, 2, C_displacements);
    REAL checked0 = C_displacements;
    FINITE(checked0);
}

BODY(four_bar_joint_rates)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict rates, double *restrict total)
{
    REAL checked0 = READ(q, 0);
    REAL checked1 = READ(q, 1);
    REAL checked2 = READ(q, 2);
    /* A: velocities, eq. (6) */
    const REAL A_v = READ(v, 0);
    WRITE(rates, 0, A_v);
    const REAL B_v = READ(v, 1);
    WRITE(rates, 1, B_v);
    const REAL D_v = READ(v, 2);
    WRITE(rates, 3, D_v);
    const REAL C_rates = D_v - (A_v + B_v);
    WRITE(rates, 2, C_rates);
    REAL checked3 = C_rates;
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_drive_rates)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict rates, double *restrict total)
{
    REAL checked0 = READ(q, 0);
    REAL checked1 = READ(q, 1);
    REAL checked2 = READ(q, 2);
    REAL checked3 = READ(v, 1);
    checked0 = checked0 + (READ(v, 2));
    const REAL A_v = READ(v, 0);
    WRITE(rates, 0, A_v);
    checked1 = checked1 + A_v;
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_inverse_velocity)(size_t stride, const double *restrict pose, const double *restrict rate,
    double *restrict v, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)pose;
    /* rocker: geometry; balance, eqs. (40)-(47); reciprocal wrenches, eq. (10) */
    const REAL minus_rocker_sin = SINES(sine, 0), t3 = D_at_x - k6 * minus_rocker_sin, rocker_cos =
        SINES(cosine, 0),
      t4 = t3 * t3, minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos,
      t5 = minus_rocker_joint_force_my_by_C_fz * minus_rocker_joint_force_my_by_C_fz + t4, t6 = t5 - k16,
      t9 = 0.5 * t6, t11 = k18 - t9 * t9, t12 = SQRT(t11), t14 = SELECT(0.0, -t12, t12);
    /* crank: reciprocal wrenches, eq. (10); geometry */
    const REAL crank_lever_mx_by_C_fz = k19 * t14, t15 = t3 * crank_lever_mx_by_C_fz,
      t21 = minus_rocker_joint_force_my_by_C_fz * crank_lever_mx_by_C_fz,
      minus_crank_lever_my_by_C_fz = B_at_z + k17 * t6,
      t16 = minus_rocker_joint_force_my_by_C_fz * minus_crank_lever_my_by_C_fz + t15,
      t22 = t3 * minus_crank_lever_my_by_C_fz - t21, coupler_cos = k19 * t6, t7 = 1.0 / t5, /* rocker */
      crank_cos = t7 * t16, crank_sin = t7 * t22, D_rate = READ(rate, 0);
    WRITE(v, 2, D_rate);
    const REAL crank_lever_mz_by_C_fy = t5 + k24, t17 = k6 * D_rate; /* D */
    /* C: loop closure */
    const REAL t18 = minus_rocker_sin * t17, t23 = rocker_cos * t17, t27 = crank_sin * t18,
      t25 = crank_cos * t18 + crank_sin * t23, t29 = t27 - crank_cos * t23, t26 = coupler_cos * t25,
      t32 = coupler_cos * t29, coupler_sin = k23 * t14, minus_C_opening_rate_fx = t26 - coupler_sin * t29,
      C_opening_rate_fy = coupler_sin * t25 + t32, crank_lever_mz_by_C_fx = 2.0 * t14;
    REAL checked0 = crank_lever_mz_by_C_fx;
    const REAL crank_omega_z = minus_C_opening_rate_fx / crank_lever_mz_by_C_fx;
    WRITE(v, 0, crank_omega_z);
    const REAL B_v = (-2.0) * (C_opening_rate_fy + crank_lever_mz_by_C_fy * crank_omega_z);
    WRITE(v, 1, B_v);
    REAL checked1 = B_v;
    /* else status 11: out of reach: limb A does not get there */
    NOT_BELOW(t11, 0.0, 11);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(crank_lever_mz_by_C_fx, 3.01689e-10),
            /* where the reciprocal wrench C.fx has no power along crank, as in a stretched limb */
        checked0 + checked1);
}

#if !defined(FOUR_BAR_VECTORS)

int four_bar_body_poses(const double *restrict q, double *restrict poses)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_body_poses_body(1, q, poses, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(poses, 36);
    }
    return outcome;
}

int four_bar_body_twists(const double *restrict q, const double *restrict v, double *restrict twists)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines3(q, sine, cosine);
    const int outcome = four_bar_body_twists_body(1, q, v, twists, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(twists, 18);
    }
    return outcome;
}

int four_bar_body_twist_rates(const double *restrict q, const double *restrict v, const double *restrict a,
    double *restrict twist_rates)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines3(q, sine, cosine);
    const int outcome = four_bar_body_twist_rates_body(1, q, v, a, twist_rates, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(twist_rates, 18);
    }
    return outcome;
}

int four_bar_forward_kinematics(const double *restrict q, double *restrict positions)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines5(q, sine, cosine);
    const int outcome = four_bar_forward_kinematics_body(1, q, positions, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(positions, 3);
    }
    return outcome;
}

int four_bar_point_motion(const double *restrict q, const double *restrict v, const double *restrict a,
    double *restrict positions, double *restrict velocities, double *restrict accelerations)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines5(q, sine, cosine);
    const int outcome = four_bar_point_motion_body(1, q, v, a, positions, velocities, accelerations, sine,
        cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(positions, 3);
        four_bar_set_nan(velocities, 3);
        four_bar_set_nan(accelerations, 3);
    }
    return outcome;
}

int four_bar_joint_screws(const double *restrict q, double *restrict screws)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines5(q, sine, cosine);
    const int outcome = four_bar_joint_screws_body(1, q, screws, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(screws, 24);
    }
    return outcome;
}

int four_bar_joint_points(const double *restrict q, double *restrict points)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines5(q, sine, cosine);
    const int outcome = four_bar_joint_points_body(1, q, points, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(points, 12);
    }
    return outcome;
}

int four_bar_platform_jacobian(const double *restrict q, double *restrict jacobian)
{
    four_bar_zero(jacobian, 13);
    const int outcome = four_bar_platform_jacobian_body(1, q, jacobian, NULL);
    if (outcome != 0) {
        four_bar_set_nan(jacobian, 18);
    }
    return outcome;
}

int four_bar_joint_displacements(const double *restrict q, double *restrict displacements)
{
    const int outcome = four_bar_joint_displacements_body(1, q, displacements, NULL);
    if (outcome != 0) {
        four_bar_set_nan(displacements, 4);
    }
    return outcome;
}

int four_bar_joint_rates(const double *restrict q, const double *restrict v, double *restrict rates)
{
    const int outcome = four_bar_joint_rates_body(1, q, v, rates, NULL);
    if (outcome != 0) {
        four_bar_set_nan(rates, 4);
    }
    return outcome;
}

int four_bar_drive_rates(const double *restrict q, const double *restrict v, double *restrict rates)
{
    const int outcome = four_bar_drive_rates_body(1, q, v, rates, NULL);
    if (outcome != 0) {
        four_bar_set_nan(rates, 1);
    }
    return outcome;
}

BODY(four_bar_inverse_kinematics)(size_t stride, const double *restrict pose, double *restrict q,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* rocker: geometry; balance, eqs. (40)-(47); reciprocal wrenches, eq. (10) */
    const REAL t3 = D_at_x - k6 * SINES(sine, 0), t4 = t3 * t3,
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 0),
      t5 = minus_rocker_joint_force_my_by_C_fz * minus_rocker_joint_force_my_by_C_fz + t4, t7 = t5 - k16,
      t6 = 1.0 / t5, t9 = 0.5 * t7, t11 = k18 - t9 * t9, t12 = SQRT(t11), t14 = SELECT(0.0, -t12, t12),
      crank_lever_mx_by_C_fz = k19 * t14,
      t15 = minus_rocker_joint_force_my_by_C_fz * crank_lever_mx_by_C_fz, /* crank */
      t18 = t3 * crank_lever_mx_by_C_fz, /* crank */
      minus_crank_lever_my_by_C_fz = B_at_z + k17 * t7, crank_sin = t6 * (t3 * minus_crank_lever_my_by_C_fz - t15),
      A_q = atan2(crank_sin, t6 * (minus_rocker_joint_force_my_by_C_fz * minus_crank_lever_my_by_C_fz + t18));
    WRITE(q, 0, A_q);
    REAL checked0 = A_q;
    const REAL t22 = k20 * t14 - k21 * t7, B_q = atan2(t22, 4.0 * t7 + k22 * t14);
    WRITE(q, 1, B_q);
    REAL checked1 = B_q;
    const REAL D_pose = READ(pose, 0);
    WRITE(q, 2, D_pose);
    REAL checked2 = D_pose;
    /* else status 11: out of reach: limb A does not get there */
    NOT_BELOW(t11, 0.0, 11);
    FINITE((checked0 + checked1) + checked2);
}

int four_bar_inverse_kinematics(const double *restrict pose, double *restrict q)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines11(pose, sine, cosine);
    const int outcome = four_bar_inverse_kinematics_body(1, pose, q, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(q, 3);
    }
    return outcome;
}

BODY(four_bar_drive_positions)(size_t stride, const double *restrict pose, double *restrict positions,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* D: geometry */
    REAL checked0 = READ(pose, 0);
    /* rocker: geometry; balance, eqs. (40)-(47); reciprocal wrenches, eq. (10) */
    const REAL t3 = D_at_x - k6 * SINES(sine, 0), t4 = t3 * t3,
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 0),
      t5 = minus_rocker_joint_force_my_by_C_fz * minus_rocker_joint_force_my_by_C_fz + t4, t7 = t5 - k16,
      t6 = 1.0 / t5, t9 = 0.5 * t7, t11 = k18 - t9 * t9, t12 = SQRT(t11),
      minus_crank_lever_my_by_C_fz = B_at_z + k17 * t7, crank_lever_mx_by_C_fz = k19 * SELECT(0.0, -t12, t12),
      t15 = minus_rocker_joint_force_my_by_C_fz * crank_lever_mx_by_C_fz, /* crank */
      t18 = t3 * crank_lever_mx_by_C_fz, /* crank */
      crank_sin = t6 * (t3 * minus_crank_lever_my_by_C_fz - t15),
      A_positions = atan2(crank_sin, t6 * (minus_rocker_joint_force_my_by_C_fz * minus_crank_lever_my_by_C_fz +
          t18));
    WRITE(positions, 0, A_positions);
    REAL checked1 = A_positions;
    /* else status 11: out of reach: limb A does not get there */
    NOT_BELOW(t11, 0.0, 11);
    FINITE(checked0 + checked1);
}

int four_bar_drive_positions(const double *restrict pose, double *restrict positions)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines11(pose, sine, cosine);
    const int outcome = four_bar_drive_positions_body(1, pose, positions, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(positions, 1);
    }
    return outcome;
}

int four_bar_inverse_velocity(const double *restrict pose, const double *restrict rate, double *restrict v)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines11(pose, sine, cosine);
    const int outcome = four_bar_inverse_velocity_body(1, pose, rate, v, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(v, 3);
    }
    return outcome;
}
#endif /* FOUR_BAR_VECTORS */
