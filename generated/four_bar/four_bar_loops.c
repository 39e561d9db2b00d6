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
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_sin = SINES(sine, 1);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    /* C: loop closure */
    const REAL t9 = B_at_z * crank_sin + 0.5 * coupler_rotation_xx - (D_at_x - k6 * SINES(sine, 2));
    const REAL t10 = coupler_rotation_xx * t9;
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t18 = minus_coupler_rotation_xy * t9;
    const REAL t16 = B_at_z * crank_cos - 0.5 * minus_coupler_rotation_xy - k6 * SINES(cosine, 2);
    const REAL C_opening_fx = t10 - minus_coupler_rotation_xy * t16;
    WRITE(residual_, 0, C_opening_fx);
    REAL checked0 = C_opening_fx;
    const REAL C_opening_fy = -(t18 + coupler_rotation_xx * t16);
    WRITE(residual_, 1, C_opening_fy);
    REAL checked1 = C_opening_fy;
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
    const REAL crank_lever_moment_z_by_C_fx = B_at_z * coupler_sin;
    WRITE(jacobian, 0, crank_lever_moment_z_by_C_fx);
    REAL checked0 = crank_lever_moment_z_by_C_fx;
    const REAL coupler_cos = SINES(cosine, 1);
    const REAL crank_lever_moment_z_by_C_fy = 0.5 + B_at_z * coupler_cos;
    WRITE(jacobian, 1, crank_lever_moment_z_by_C_fy);
    REAL checked1 = crank_lever_moment_z_by_C_fy;
    const REAL crank_sin = SINES(sine, 0), crank_cos = SINES(cosine, 0);
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t6 = k6 * SINES(sine, 2); /* rocker */
    /* C: loop closure */
    const REAL t7 = minus_coupler_rotation_xy * t6;
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t13 = coupler_rotation_xx * t6;
    const REAL t10 = k6 * SINES(cosine, 2); /* rocker */
    const REAL C_closure_fx_by_D = t7 - coupler_rotation_xx * t10;
    WRITE(jacobian, 10, C_closure_fx_by_D);
    REAL checked2 = C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = minus_coupler_rotation_xy * t10 + t13;
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
    const REAL D_v = READ(v, 2);
    const REAL t3 = k6 * (D_v * D_v); /* rocker */
    const REAL t4 = SINES(cosine, 2) * t3; /* rocker */
    const REAL t6 = SINES(sine, 2) * t3; /* rocker */
    const REAL crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0);
    /* C: loop closure */
    const REAL t10 = crank_sin * t4;
    const REAL t8 = crank_cos * t4 - crank_sin * t6;
    const REAL t12 = t10 + crank_cos * t6;
    const REAL coupler_sin = SINES(sine, 1), coupler_cos = SINES(cosine, 1), A_v = READ(v, 0);
    const REAL t20 = coupler_sin * t8 + coupler_cos * t12;
    const REAL t14 = coupler_cos * t8 - coupler_sin * t12;
    const REAL t15 = B_at_z * (A_v * A_v); /* crank */
    const REAL C_opening_bias_fy = coupler_sin * t15 - t20;
    WRITE(bias, 1, C_opening_bias_fy);
    REAL checked0 = C_opening_bias_fy;
    const REAL minus_coupler_acc_still_x = coupler_cos * t15;
    const REAL coupler_omega_z = A_v + READ(v, 1);
    const REAL C_opening_bias_fx = t14 - (minus_coupler_acc_still_x + 0.5 * (coupler_omega_z * coupler_omega_z));
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
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_sin = SINES(sine, 1);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t7 = k6 * SINES(cosine, 2); /* rocker */
    const REAL t14 = coupler_rotation_xx * t7; /* C */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t8 = minus_coupler_rotation_xy * t7; /* C */
    const REAL t11 = k6 * SINES(sine, 2); /* rocker */
    const REAL minus_C_closure_fx_by_D = t14 - minus_coupler_rotation_xy * t11;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL A_y_dot = READ(y_dot, 0);
    WRITE(v, 0, A_y_dot);
    const REAL C_closure_fy_by_D = t8 + coupler_rotation_xx * t11;
    const REAL D_joint_rate = B_at_z * coupler_sin * A_y_dot / minus_C_closure_fx_by_D;
    WRITE(v, 2, D_joint_rate);
    const REAL minus_B_joint_rate = 2.0 * ((0.5 + B_at_z * coupler_cos) * A_y_dot + C_closure_fy_by_D * D_joint_rate);
    const REAL B_joint_rate = -minus_B_joint_rate;
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
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_sin = SINES(sine, 1);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t6 = k6 * SINES(cosine, 2); /* rocker */
    const REAL t12 = coupler_rotation_xx * t6; /* C */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t7 = minus_coupler_rotation_xy * t6; /* C */
    const REAL t10 = k6 * SINES(sine, 2); /* rocker */
    const REAL minus_C_closure_fx_by_D = t12 - minus_coupler_rotation_xy * t10;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t7 + coupler_rotation_xx * t10;
    const REAL D_null_space_by_A = B_at_z * coupler_sin / minus_C_closure_fx_by_D;
    WRITE(null_space, 2, D_null_space_by_A);
    const REAL B_null_space_by_A = -(2.0 * (0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A));
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
    const REAL D_v = READ(v, 2);
    const REAL t4 = k6 * (D_v * D_v); /* rocker */
    const REAL rocker_cos = SINES(cosine, 2);
    const REAL t5 = rocker_cos * t4; /* rocker */
    const REAL minus_rocker_sin = SINES(sine, 2);
    const REAL t7 = minus_rocker_sin * t4; /* rocker */
    const REAL crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0);
    const REAL t11 = crank_sin * t5; /* C */
    const REAL t9 = crank_cos * t5 - crank_sin * t7; /* C */
    const REAL t13 = t11 + crank_cos * t7; /* C */
    const REAL coupler_cos = SINES(cosine, 1), coupler_sin = SINES(sine, 1), A_v = READ(v, 0);
    const REAL t29 = coupler_cos * t9 - coupler_sin * t13; /* C */
    const REAL t15 = coupler_sin * t9 + coupler_cos * t13; /* C */
    const REAL t2 = B_at_z * (A_v * A_v); /* crank */
    const REAL minus_coupler_acc_still_x = coupler_cos * t2;
    const REAL C_opening_bias_fy = coupler_sin * t2 - t15;
    const REAL coupler_omega_z = A_v + READ(v, 1);
    const REAL A_y_ddot = READ(y_ddot, 0);
    WRITE(a, 0, A_y_ddot);
    const REAL C_opening_bias_fx = t29 - (minus_coupler_acc_still_x + 0.5 * (coupler_omega_z * coupler_omega_z));
    const REAL t33 = C_opening_bias_fx + B_at_z * coupler_sin * A_y_ddot;
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t21 = k6 * rocker_cos; /* rocker */
    const REAL t34 = coupler_rotation_xx * t21; /* C */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t22 = minus_coupler_rotation_xy * t21; /* C */
    const REAL t25 = k6 * minus_rocker_sin; /* rocker */
    const REAL minus_C_closure_fx_by_D = t34 - minus_coupler_rotation_xy * t25;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL D_joint_acc = t33 / minus_C_closure_fx_by_D;
    WRITE(a, 2, D_joint_acc);
    const REAL t36 = (t22 + coupler_rotation_xx * t25) * D_joint_acc; /* B */
    const REAL minus_B_joint_acc = 2.0 * (C_opening_bias_fy + (0.5 + B_at_z * coupler_cos) * A_y_ddot + t36);
    const REAL B_joint_acc = -minus_B_joint_acc;
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
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_sin = SINES(sine, 1);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t18 = B_at_z * crank_sin + 0.5 * coupler_rotation_xx; /* coupler */
    const REAL t10 = k6 * SINES(sine, 2); /* rocker */
    /* C: loop closure; rates that follow; results */
    const REAL t20 = t18 - (D_at_x - t10);
    const REAL t26 = coupler_rotation_xx * t20;
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t21 = minus_coupler_rotation_xy * t20;
    const REAL t23 = B_at_z * crank_cos - 0.5 * minus_coupler_rotation_xy; /* coupler */
    const REAL t6 = k6 * SINES(cosine, 2); /* rocker */
    const REAL t24 = t23 - t6;
    const REAL C_opening_fx = t26 - minus_coupler_rotation_xy * t24;
    const REAL minus_C_opening_fy = t21 + coupler_rotation_xx * t24;
    const REAL t7 = minus_coupler_rotation_xy * t6;
    const REAL minus_C_closure_fx_by_D = coupler_rotation_xx * t6 - minus_coupler_rotation_xy * t10;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t7 + coupler_rotation_xx * t10;
    const REAL t14 = 1.0 / minus_C_closure_fx_by_D;
    const REAL t28 = C_opening_fx * t14;
    const REAL t43 = per_length * C_opening_fx;
    const REAL t44 = t43 * t43;
    const REAL t31 = 2.0 * (minus_C_opening_fy - C_closure_fy_by_D * t28);
    const REAL t45 = per_length * minus_C_opening_fy;
    const REAL residual_residual = SQRT(t44 + t45 * t45);
    WRITE(residual_, 0, residual_residual);
    REAL checked1 = residual_residual;
    const REAL D_null_space_by_A = B_at_z * coupler_sin * t14;
    const REAL minus_B_null_space_by_A = 2.0 * (0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A);
    const REAL t34 = minus_B_null_space_by_A * t31 - D_null_space_by_A * t28; /* A */
    const REAL pivot_0 = 1.0 + minus_B_null_space_by_A * minus_B_null_space_by_A + D_null_space_by_A * D_null_space_by_A;
    REAL checked2 = pivot_0;
    const REAL t38 = t34 / pivot_0; /* A */
    const REAL A_q_next = READ(q, 0) + t38;
    WRITE(q_next, 0, A_q_next);
    REAL checked3 = A_q_next;
    RESULT(checked0, q_next, 1, READ(q, 1) + (t31 - minus_B_null_space_by_A * t38));
    RESULT(checked1, q_next, 2, READ(q, 2) + (t28 + D_null_space_by_A * t38));
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-10) OR /* where D does not move the loop at C */
        SMALL(pivot_0, 2.4194e-09), /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_close_velocity)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict v_next, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_sin = SINES(sine, 1);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t6 = k6 * SINES(cosine, 2); /* rocker */
    const REAL t12 = coupler_rotation_xx * t6; /* C */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t7 = minus_coupler_rotation_xy * t6; /* C */
    const REAL t10 = k6 * SINES(sine, 2); /* rocker */
    const REAL minus_C_closure_fx_by_D = t12 - minus_coupler_rotation_xy * t10;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t7 + coupler_rotation_xx * t10;
    const REAL D_null_space_by_A = B_at_z * coupler_sin / minus_C_closure_fx_by_D;
    const REAL minus_B_null_space_by_A = 2.0 * (0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A);
    const REAL t19 = READ(v, 0) - READ(v, 1) * minus_B_null_space_by_A + READ(v, 2) * D_null_space_by_A; /* A */
    const REAL pivot_0 = 1.0 + minus_B_null_space_by_A * minus_B_null_space_by_A + D_null_space_by_A * D_null_space_by_A;
    REAL checked1 = pivot_0;
    const REAL A_v_next = t19 / pivot_0;
    WRITE(v_next, 0, A_v_next);
    const REAL D_v_next = D_null_space_by_A * A_v_next;
    WRITE(v_next, 2, D_v_next);
    REAL checked2 = D_v_next;
    const REAL B_v_next = -(minus_B_null_space_by_A * A_v_next);
    WRITE(v_next, 1, B_v_next);
    REAL checked3 = B_v_next;
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-10) OR /* where D does not move the loop at C */
        SMALL(pivot_0, 2.4194e-09), /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
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
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_sin = SINES(sine, 1);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t6 = B_at_z * crank_sin + 0.5 * coupler_rotation_xx; /* coupler */
    const REAL t8 = k6 * SINES(sine, 2); /* rocker */
    /* C: loop closure; results */
    const REAL t10 = t6 - (D_at_x - t8);
    const REAL t11 = coupler_rotation_xx * t10;
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t28 = minus_coupler_rotation_xy * t10;
    const REAL t15 = B_at_z * crank_cos - 0.5 * minus_coupler_rotation_xy; /* coupler */
    const REAL t16 = k6 * SINES(cosine, 2); /* rocker */
    const REAL t17 = t15 - t16;
    const REAL C_opening_fx = t11 - minus_coupler_rotation_xy * t17;
    const REAL minus_C_opening_fy = t28 + coupler_rotation_xx * t17;
    const REAL t30 = minus_coupler_rotation_xy * t16;
    const REAL minus_C_closure_fx_by_D = coupler_rotation_xx * t16 - minus_coupler_rotation_xy * t8;
    const REAL C_closure_fy_by_D = t30 + coupler_rotation_xx * t8;
    const REAL t21 = 1.0 / minus_C_closure_fx_by_D;
    const REAL orientation_orientation = -(0.5 * minus_C_closure_fx_by_D);
    WRITE(orientation_, 0, orientation_orientation);
    REAL checked0 = orientation_orientation;
    const REAL t22 = C_opening_fx * t21;
    const REAL t50 = per_length * C_opening_fx;
    const REAL t51 = t50 * t50;
    const REAL t33 = minus_C_opening_fy - C_closure_fy_by_D * t22;
    const REAL t52 = per_length * minus_C_opening_fy;
    const REAL residual_residual = SQRT(t51 + t52 * t52);
    WRITE(residual_, 0, residual_residual);
    REAL checked1 = residual_residual;
    const REAL A_q = READ(q, 0);
    const REAL crank_lever_moment_z_by_C_fx = B_at_z * coupler_sin;
    const REAL t1 = A_q - READ(y, 0); /* A */
    /* step: results */
    const REAL t24 = t21 * (crank_lever_moment_z_by_C_fx * t1);
    const REAL t36 = C_closure_fy_by_D * t24;
    const REAL t25 = t22 - t24;
    const REAL t39 = 2.0 * (t33 + ((0.5 + B_at_z * coupler_cos) * t1 + t36));
    const REAL step_step = SQRT(t25 * t25 + (t1 * t1 + t39 * t39));
    WRITE(step, 0, step_step);
    REAL checked2 = step_step;
    const REAL t43 = LESS(step_step, 0.5);
    const REAL t46 = SELECT(t43, 1.0, 0.5 / SELECT(t43, 1.0, step_step));
    const REAL A_q_next = A_q - t1 * t46;
    WRITE(q_next, 0, A_q_next);
    REAL checked3 = A_q_next;
    RESULT(checked0, q_next, 1, READ(q, 1) + t39 * t46);
    RESULT(checked1, q_next, 2, READ(q, 2) + t25 * t46);
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
