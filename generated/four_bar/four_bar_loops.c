/*
 * four_bar: loops.
 *   closure; closure_jacobian; closure_bias; velocity; null_space; acceleration; close_position;
 *   close_velocity; assemble
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

BODY(four_bar_closure)(size_t stride, const double *restrict q, double *restrict residual_,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    /* C: loop closure */
    const REAL t8 = B_at_z * crank_sin + 0.5 * coupler_rotation_xx - (D_at_x - k6 * SINES(sine, 2)),
      t9 = coupler_rotation_xx * t8, minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t16 = minus_coupler_rotation_xy * t8,
      t14 = B_at_z * crank_cos - 0.5 * minus_coupler_rotation_xy - k6 * SINES(cosine, 2),
      C_opening_fx = t9 - minus_coupler_rotation_xy * t14;
    WRITE(residual_, 0, C_opening_fx);
    REAL checked0 = C_opening_fx;
    const REAL minus_C_opening_fy = t16 + coupler_rotation_xx * t14;
    REAL checked1 = minus_C_opening_fy;
    WRITE(residual_, 1, -minus_C_opening_fy);
    WRITE(residual_, 2, CONSTANT(0.0));
    WRITE(residual_, 3, CONSTANT(0.0));
    WRITE(residual_, 4, CONSTANT(0.0));
    FINITE(checked0 + checked1);
}

BODY(four_bar_closure_jacobian)(size_t stride, const double *restrict q, double *restrict jacobian,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* coupler: geometry */
    const REAL coupler_sin = SINES(sine, 1);
    /* crank: reciprocal wrenches, eq. (10); geometry */
    const REAL crank_lever_mz_by_C_fx = B_at_z * coupler_sin;
    WRITE(jacobian, 0, crank_lever_mz_by_C_fx);
    REAL checked0 = crank_lever_mz_by_C_fx;
    const REAL coupler_cos = SINES(cosine, 1), crank_lever_mz_by_C_fy = 0.5 + B_at_z * coupler_cos;
    WRITE(jacobian, 1, crank_lever_mz_by_C_fy);
    REAL checked1 = crank_lever_mz_by_C_fy;
    const REAL crank_sin = SINES(sine, 0), crank_cos = SINES(cosine, 0),
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      minus_rocker_joint_force_mx_by_C_fz = k6 * SINES(sine, 2);
    /* C: loop closure */
    const REAL t6 = minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz,
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      t11 = coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 2),
      C_closure_fx_by_D = t6 - coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz;
    WRITE(jacobian, 10, C_closure_fx_by_D);
    REAL checked2 = C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz + t11;
    WRITE(jacobian, 11, C_closure_fy_by_D);
    REAL checked3 = C_closure_fy_by_D;
    WRITE(jacobian, 2, CONSTANT(0.0));
    WRITE(jacobian, 3, CONSTANT(0.0));
    WRITE(jacobian, 4, CONSTANT(0.0));
    WRITE(jacobian, 5, CONSTANT(0.0));
    WRITE(jacobian, 6, CONSTANT(0.5));
    WRITE(jacobian, 7, CONSTANT(0.0));
    WRITE(jacobian, 8, CONSTANT(0.0));
    WRITE(jacobian, 9, CONSTANT(0.0));
    WRITE(jacobian, 12, CONSTANT(0.0));
    WRITE(jacobian, 13, CONSTANT(0.0));
    WRITE(jacobian, 14, CONSTANT(0.0));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_closure_bias)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict bias, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* D: accelerations */
    const REAL D_v = READ(v, 2), t4 = k6 * (D_v * D_v), /* rocker */
      t5 = SINES(cosine, 2) * t4, /* rocker */
      t7 = SINES(sine, 2) * t4, /* rocker */
      crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0);
    /* C: loop closure */
    const REAL t14 = crank_cos * t5 - crank_sin * t7, t9 = crank_sin * t5 + crank_cos * t7, A_v = READ(v, 0),
      t15 = B_at_z * (A_v * A_v) - t14, coupler_sin = SINES(sine, 1), coupler_cos = SINES(cosine, 1),
      t16 = coupler_cos * t15, C_opening_bias_fy = coupler_sin * t15 - coupler_cos * t9;
    WRITE(bias, 1, C_opening_bias_fy);
    REAL checked0 = C_opening_bias_fy;
    const REAL t17 = coupler_sin * t9 + t16, coupler_omega_z = A_v + READ(v, 1),
      C_opening_bias_fx = (-0.5) * (coupler_omega_z * coupler_omega_z) - t17;
    WRITE(bias, 0, C_opening_bias_fx);
    REAL checked1 = C_opening_bias_fx;
    WRITE(bias, 2, CONSTANT(0.0));
    WRITE(bias, 3, CONSTANT(0.0));
    WRITE(bias, 4, CONSTANT(0.0));
    FINITE(checked0 + checked1);
}

BODY(four_bar_velocity)(size_t stride, const double *restrict q, const double *restrict y_dot,
    double *restrict v, const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 2),
      t12 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t7 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_rocker_joint_force_mx_by_C_fz = k6 * SINES(sine, 2),
      minus_C_closure_fx_by_D = t12 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL A_y_dot = READ(y_dot, 0);
    WRITE(v, 0, A_y_dot);
    const REAL C_closure_fy_by_D = t7 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      D_joint_rate = B_at_z * coupler_sin * A_y_dot / minus_C_closure_fx_by_D;
    WRITE(v, 2, D_joint_rate);
    const REAL B_joint_rate = (-2.0) * ((0.5 + B_at_z * coupler_cos) * A_y_dot + C_closure_fy_by_D * D_joint_rate);
    WRITE(v, 1, B_joint_rate);
    REAL checked1 = B_joint_rate;
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-10), /* where D does not move the loop at C */
        checked0 + checked1);
}

BODY(four_bar_null_space)(size_t stride, const double *restrict q, double *restrict null_space,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 2),
      t10 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t6 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_rocker_joint_force_mx_by_C_fz = k6 * SINES(sine, 2),
      minus_C_closure_fx_by_D = t10 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t6 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      D_null_space_by_A = B_at_z * coupler_sin / minus_C_closure_fx_by_D;
    WRITE(null_space, 2, D_null_space_by_A);
    const REAL B_null_space_by_A = (-2.0) * (0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A);
    WRITE(null_space, 1, B_null_space_by_A);
    REAL checked1 = B_null_space_by_A;
    WRITE(null_space, 0, CONSTANT(1.0));
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-10), /* where D does not move the loop at C */
        checked0 + checked1);
}

BODY(four_bar_acceleration)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict y_ddot, double *restrict a, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* D: accelerations */
    const REAL D_v = READ(v, 2), t11 = k6 * (D_v * D_v), /* rocker */
      rocker_cos = SINES(cosine, 2), t12 = rocker_cos * t11, /* rocker */
      minus_rocker_sin = SINES(sine, 2), t14 = minus_rocker_sin * t11, /* rocker */
      crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0), t16 = crank_cos * t12 - crank_sin * t14,
      t21 = crank_sin * t12 + crank_cos * t14, A_v = READ(v, 0), t17 = B_at_z * (A_v * A_v) - t16,
      coupler_cos = SINES(cosine, 1), coupler_sin = SINES(sine, 1), A_y_ddot = READ(y_ddot, 0);
    WRITE(a, 0, A_y_ddot);
    const REAL t25 = coupler_cos * t17 + coupler_sin * (t21 - B_at_z * A_y_ddot),
      t34 = coupler_cos * t21 - coupler_sin * t17, /* B */
      coupler_omega_z = A_v + READ(v, 1), t26 = 0.5 * (coupler_omega_z * coupler_omega_z) + t25,
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos,
      t27 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t5 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin,
      minus_C_closure_fx_by_D = t27 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL minus_D_joint_acc = t26 / minus_C_closure_fx_by_D,
      t29 = (t5 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz) * minus_D_joint_acc; /* B */
    WRITE(a, 2, -minus_D_joint_acc);
    const REAL B_joint_acc = 2.0 * (t29 - ((0.5 + B_at_z * coupler_cos) * A_y_ddot - t34));
    WRITE(a, 1, B_joint_acc);
    REAL checked1 = B_joint_acc;
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-10), /* where D does not move the loop at C */
        checked0 + checked1);
}

BODY(four_bar_close_position)(size_t stride, const double *restrict q, double *restrict q_next,
    double *restrict residual_, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      t16 = B_at_z * crank_sin + 0.5 * coupler_rotation_xx, /* coupler */
      minus_rocker_joint_force_mx_by_C_fz = k6 * SINES(sine, 2);
    /* C: loop closure; rates that follow; results */
    const REAL t18 = t16 - (D_at_x - minus_rocker_joint_force_mx_by_C_fz), t24 = coupler_rotation_xx * t18,
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t19 = minus_coupler_rotation_xy * t18,
      t21 = B_at_z * crank_cos - 0.5 * minus_coupler_rotation_xy, /* coupler */
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 2), t22 = t21 - minus_rocker_joint_force_my_by_C_fz,
      C_opening_fx = t24 - minus_coupler_rotation_xy * t22, minus_C_opening_fy = t19 + coupler_rotation_xx * t22,
      t10 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz,
      t6 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz,
      minus_C_closure_fx_by_D = t10 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t6 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      t12 = 1.0 / minus_C_closure_fx_by_D, t26 = C_opening_fx * t12, t41 = per_length * C_opening_fx,
      t42 = t41 * t41, t29 = 2.0 * (minus_C_opening_fy - C_closure_fy_by_D * t26),
      t43 = per_length * minus_C_opening_fy, residual_residual = SQRT(t42 + t43 * t43);
    WRITE(residual_, 0, residual_residual);
    REAL checked1 = residual_residual;
    const REAL D_null_space_by_A = B_at_z * coupler_sin * t12,
      minus_B_null_space_by_A = 2.0 * (0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A),
      t32 = minus_B_null_space_by_A * t29 - D_null_space_by_A * t26, /* A */
      pivot_0 = 1.0 + minus_B_null_space_by_A * minus_B_null_space_by_A + D_null_space_by_A * D_null_space_by_A;
    REAL checked2 = pivot_0;
    const REAL t36 = t32 / pivot_0, /* A */
      A_q_next = READ(q, 0) + t36;
    WRITE(q_next, 0, A_q_next);
    REAL checked3 = A_q_next;
    RESULT(checked0, q_next, 1, READ(q, 1) + (t29 - minus_B_null_space_by_A * t36));
    RESULT(checked1, q_next, 2, READ(q, 2) + (t26 + D_null_space_by_A * t36));
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-10) OR /* where D does not move the loop at C */
        SMALL(pivot_0, 2.4194e-09),
            /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_close_velocity)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict v_next, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 2),
      t10 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t6 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_rocker_joint_force_mx_by_C_fz = k6 * SINES(sine, 2),
      minus_C_closure_fx_by_D = t10 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t6 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      D_null_space_by_A = B_at_z * coupler_sin / minus_C_closure_fx_by_D,
      minus_B_null_space_by_A = 2.0 * (0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A),
      t17 = READ(v, 0) - READ(v, 1) * minus_B_null_space_by_A + READ(v, 2) * D_null_space_by_A, /* A */
      pivot_0 = 1.0 + minus_B_null_space_by_A * minus_B_null_space_by_A + D_null_space_by_A * D_null_space_by_A;
    REAL checked1 = pivot_0;
    const REAL A_v_next = t17 / pivot_0;
    WRITE(v_next, 0, A_v_next);
    const REAL D_v_next = D_null_space_by_A * A_v_next;
    WRITE(v_next, 2, D_v_next);
    REAL checked2 = D_v_next;
    const REAL t21 = minus_B_null_space_by_A * A_v_next; /* B */
    REAL checked3 = t21; /* B */
    WRITE(v_next, 1, -t21);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-10) OR /* where D does not move the loop at C */
        SMALL(pivot_0, 2.4194e-09),
            /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3));
}

#if !defined(FOUR_BAR_VECTORS)

int four_bar_closure(const double *restrict q, double *restrict residual_)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_closure_body(1, q, residual_, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(residual_, 5);
    }
    return outcome;
}

int four_bar_closure_jacobian(const double *restrict q, double *restrict jacobian)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_closure_jacobian_body(1, q, jacobian, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(jacobian, 15);
    }
    return outcome;
}

int four_bar_closure_bias(const double *restrict q, const double *restrict v, double *restrict bias)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_closure_bias_body(1, q, v, bias, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(bias, 5);
    }
    return outcome;
}

int four_bar_velocity(const double *restrict q, const double *restrict y_dot, double *restrict v)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_velocity_body(1, q, y_dot, v, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(v, 3);
    }
    return outcome;
}

int four_bar_null_space(const double *restrict q, double *restrict null_space)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_null_space_body(1, q, null_space, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(null_space, 3);
    }
    return outcome;
}

int four_bar_acceleration(const double *restrict q, const double *restrict v, const double *restrict y_ddot,
    double *restrict a)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_acceleration_body(1, q, v, y_ddot, a, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(a, 3);
    }
    return outcome;
}

int four_bar_close_position(const double *restrict q, double *restrict q_next, double *restrict residual_)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_close_position_body(1, q, q_next, residual_, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(q_next, 3);
        four_bar_set_nan(residual_, 1);
    }
    return outcome;
}

int four_bar_close_velocity(const double *restrict q, const double *restrict v, double *restrict v_next)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_close_velocity_body(1, q, v, v_next, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(v_next, 3);
    }
    return outcome;
}

BODY(four_bar_assemble_step)(size_t stride, const double *restrict q, const double *restrict y,
    double *restrict q_next, double *restrict residual_, double *restrict step, double *restrict orientation_,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      t6 = B_at_z * crank_sin + 0.5 * coupler_rotation_xx, /* coupler */
      minus_rocker_joint_force_mx_by_C_fz = k6 * SINES(sine, 2);
    /* C: loop closure; results */
    const REAL t9 = t6 - (D_at_x - minus_rocker_joint_force_mx_by_C_fz), t10 = coupler_rotation_xx * t9,
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t26 = minus_coupler_rotation_xy * t9,
      t14 = B_at_z * crank_cos - 0.5 * minus_coupler_rotation_xy, /* coupler */
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 2), t15 = t14 - minus_rocker_joint_force_my_by_C_fz,
      C_opening_fx = t10 - minus_coupler_rotation_xy * t15, minus_C_opening_fy = t26 + coupler_rotation_xx * t15,
      t17 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz,
      t28 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz,
      minus_C_closure_fx_by_D = t17 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz,
      C_closure_fy_by_D = t28 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      orientation_orientation = (-0.5) * minus_C_closure_fx_by_D;
    WRITE(orientation_, 0, orientation_orientation);
    REAL checked0 = orientation_orientation;
    const REAL t19 = 1.0 / minus_C_closure_fx_by_D, t20 = C_opening_fx * t19, t48 = per_length * C_opening_fx,
      t49 = t48 * t48, t31 = minus_C_opening_fy - C_closure_fy_by_D * t20, t50 = per_length * minus_C_opening_fy,
      residual_residual = SQRT(t49 + t50 * t50);
    WRITE(residual_, 0, residual_residual);
    REAL checked1 = residual_residual;
    const REAL A_q = READ(q, 0), crank_lever_mz_by_C_fx = B_at_z * coupler_sin, t1 = A_q - READ(y, 0); /* A */
    /* step: results */
    const REAL t22 = t19 * (crank_lever_mz_by_C_fx * t1), t34 = C_closure_fy_by_D * t22, t23 = t20 - t22,
      t37 = 2.0 * (t31 + ((0.5 + B_at_z * coupler_cos) * t1 + t34)),
      step_step = SQRT(t23 * t23 + (t1 * t1 + t37 * t37));
    WRITE(step, 0, step_step);
    REAL checked2 = step_step;
    const REAL t41 = LESS(step_step, 0.5), t44 = SELECT(t41, 1.0, 0.5 / SELECT(t41, 1.0, step_step)),
      A_q_next = A_q - t1 * t44;
    WRITE(q_next, 0, A_q_next);
    REAL checked3 = A_q_next;
    RESULT(checked0, q_next, 1, READ(q, 1) + t37 * t44);
    RESULT(checked1, q_next, 2, READ(q, 2) + t23 * t44);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-13), /* where D does not move the loop at C */
        (checked0 + checked1) + (checked2 + checked3));
}

static int four_bar_assemble_step(const double *restrict q, const double *restrict y, double *restrict q_next,
    double *restrict residual_, double *restrict step, double *restrict orientation_)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_assemble_step_body(1, q, y, q_next, residual_, step, orientation_, sine,
        cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(q_next, 3);
        four_bar_set_nan(residual_, 1);
        four_bar_set_nan(step, 1);
        four_bar_set_nan(orientation_, 1);
    }
    return outcome;
}

static int four_bar_assemble_newton(double *q, const double *y, double branch)
{
    double next[3], residual[1], change[1], orientation[1];
    for (int step = 0; step < 25; ++step) {
        if (four_bar_assemble_step(q, y, next, residual, change, orientation) != 0) {
            return 3;
        }
        for (int k = 0; k < 3; ++k) {
            q[k] = next[k];
        }
        if (residual[0] < 1.0e-13 && change[0] < 1.0e-13) {
            return orientation[0] * branch > 0.0 ? 0 : 4;
        }
    }
    return 3;
}

static int four_bar_assemble_attempt(int substeps, const double *y, const double *guess, const double *start,
    double branch, double *q)
{
    double target[1] = {0.0};
    for (int k = 0; k < 3; ++k) {
        q[k] = guess[k];
    }
    for (int k = 1; k <= substeps; ++k) {
        const double part = (double)k / (double)substeps;
        target[0] = start[0] + (y[0] - start[0]) * part;
        const int outcome = four_bar_assemble_newton(q, target, branch);
        if (outcome != 0) {
            return outcome;
        }
    }
    return 0;
}

int four_bar_assemble(const double *restrict y, const double *restrict guess, double *restrict q)
{
    const double total = (y[0] + guess[0]) + (guess[1] + guess[2]);
    int outcome = isfinite(total) ? 3 : 2;
    if (outcome == 3) {
        double next[3], residual[1], change[1], orientation[1];
        double start[1] = {0.0};
        start[0] = guess[0];
        (void)four_bar_assemble_step(guess, start, next, residual, change, orientation);
        const int most = 64;
        for (int substeps = 1; substeps <= most && outcome != 0; substeps *= 2) {
            outcome = four_bar_assemble_attempt(substeps, y, guess, start, orientation[0], q);
        }
    }
    if (outcome != 0) {
        four_bar_set_nan(q, 3);
    }
    return outcome;
}
#endif /* FOUR_BAR_VECTORS */
