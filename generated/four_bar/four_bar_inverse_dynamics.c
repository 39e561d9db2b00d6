/*
 * four_bar: inverse_dynamics.
 *   inverse_dynamics; inverse_dynamics_independent; inverse_dynamics_platform
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

BODY(four_bar_inverse_dynamics)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    (void)q;
    REAL checked0 = READ(v, 2);
    /* A: accelerations */
    const REAL A_v = READ(v, 0), crank_cos = SINES(cosine, 0), coupler_sin = SINES(sine, 1), A_a = READ(a, 0);
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1);
    const REAL t8 = coupler_sin * (B_at_z * (A_v * A_v) - gravity_z * crank_cos); /* coupler */
    const REAL t12 = coupler_com_z * (t8 + coupler_cos * (B_at_z * A_a - gravity_z * crank_sin)); /* coupler */
    const REAL coupler_twist_rate_angular_y = A_a + READ(a, 1);
    const REAL C_multiplier_fy = 2.0 * (coupler_sxx * coupler_twist_rate_angular_y + t12);
    const REAL t32 = coupler_cos * (coupler_com_z * coupler_twist_rate_angular_y); /* coupler */
    /* rocker: balance, eqs. (40)-(47); geometry */
    const REAL t13 = coupler_sin * C_multiplier_fy;
    const REAL t15 = coupler_cos * C_multiplier_fy;
    const REAL t20 = crank_cos * t13;
    const REAL t17 = crank_sin * t13 - crank_cos * t15;
    const REAL t4 = k6 * SINES(cosine, 2);
    const REAL minus_rocker_sin = SINES(sine, 2);
    const REAL t18 = t4 * t17;
    const REAL t22 = t20 + crank_sin * t15;
    const REAL t19 = k6 * minus_rocker_sin;
    const REAL rocker_joint_force_moment_z = gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * READ(a, 2) - (t18 + t19 * t22);
    const REAL t27 = (crank_sin * coupler_cos + crank_cos * coupler_sin) * t4; /* C */
    const REAL minus_C_closure_fx_by_D = t27 - (crank_sin * coupler_sin - crank_cos * coupler_cos) * t19;
    REAL checked1 = minus_C_closure_fx_by_D;
    const REAL t31 = B_at_z * coupler_sin * (rocker_joint_force_moment_z / minus_C_closure_fx_by_D); /* A */
    const REAL coupler_omega_z = A_v + READ(v, 1);
    const REAL t34 = B_at_z * (coupler_sin * (coupler_com_z * (coupler_omega_z * coupler_omega_z)) - t32 + t15); /* crank */
    const REAL A_balance = t31 - (t34 + (k10 * crank_sin - k7 * A_a));
    WRITE(u, 0, A_balance);
    REAL checked2 = A_balance;
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 5.057800000000001e-10), /* where D does not move the loop at C */
        (checked0 + checked1) + checked2);
}

BODY(four_bar_inverse_dynamics_independent)(size_t stride, const double *restrict q,
    const double *restrict y_dot, const double *restrict y_ddot, double *restrict u,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry; reciprocal wrenches, eq. (10); balance, eqs. (40)-(47) */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_sin = SINES(sine, 1);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL rocker_cos = SINES(cosine, 2);
    const REAL t5 = k6 * rocker_cos; /* rocker */
    const REAL t6 = coupler_rotation_xx * t5; /* C */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL minus_rocker_sin = SINES(sine, 2);
    const REAL t9 = k6 * minus_rocker_sin; /* rocker */
    const REAL t30 = coupler_rotation_xx * t9; /* C */
    const REAL minus_C_closure_fx_by_D = t6 - minus_coupler_rotation_xy * t9;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL t11 = 1.0 / minus_C_closure_fx_by_D; /* C */
    const REAL C_closure_fy_by_D = minus_coupler_rotation_xy * t5 + t30;
    const REAL crank_lever_moment_z_by_C_fx = B_at_z * coupler_sin;
    const REAL A_y_dot = READ(y_dot, 0);
    const REAL D_joint_rate = crank_lever_moment_z_by_C_fx * A_y_dot * t11;
    const REAL t14 = k6 * (D_joint_rate * D_joint_rate); /* rocker */
    const REAL t31 = C_closure_fy_by_D * D_joint_rate; /* B */
    const REAL t15 = rocker_cos * t14; /* rocker */
    const REAL t17 = minus_rocker_sin * t14; /* rocker */
    const REAL t21 = crank_sin * t15; /* C */
    const REAL t19 = crank_cos * t15 - crank_sin * t17; /* C */
    const REAL t23 = t21 + crank_cos * t17; /* C */
    const REAL t25 = coupler_cos * t19 - coupler_sin * t23; /* C */
    const REAL t40 = coupler_sin * t19 + coupler_cos * t23; /* C */
    const REAL crank_lever_moment_z_by_C_fy = 0.5 + B_at_z * coupler_cos;
    const REAL coupler_omega_z = A_y_dot - 2.0 * (crank_lever_moment_z_by_C_fy * A_y_dot + t31);
    const REAL minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z;
    const REAL A_y_ddot = READ(y_ddot, 0);
    const REAL t37 = crank_lever_moment_z_by_C_fy * A_y_ddot; /* B */
    const REAL t33 = 0.5 * minus_coupler_U_still_xx; /* coupler */
    const REAL minus_crank_force_y = coupler_sin * (coupler_com_z * minus_coupler_U_still_xx);
    const REAL t26 = B_at_z * (A_y_dot * A_y_dot);
    const REAL D_joint_acc = t11 * (crank_lever_moment_z_by_C_fx * A_y_ddot + (t25 - (coupler_cos * t26 + t33)));
    const REAL t36 = rocker_sxx * D_joint_acc; /* D */
    const REAL minus_B_joint_acc = 2.0 * (t37 + (coupler_sin * t26 - t40) + C_closure_fy_by_D * D_joint_acc);
    const REAL coupler_alpha_z = A_y_ddot - minus_B_joint_acc;
    const REAL t44 = coupler_sxx * coupler_alpha_z; /* coupler */
    const REAL minus_coupler_joint_force_force_y = minus_crank_force_y - coupler_cos * (coupler_com_z * coupler_alpha_z);
    const REAL t46 = coupler_sin * (gravity_z * crank_cos - t26); /* coupler */
    const REAL t50 = coupler_com_z * (t46 + coupler_cos * (gravity_z * crank_sin - B_at_z * A_y_ddot)); /* coupler */
    const REAL C_multiplier_fy = 2.0 * (t44 - t50);
    const REAL t51 = coupler_sin * C_multiplier_fy; /* rocker */
    const REAL t53 = coupler_cos * C_multiplier_fy; /* rocker */
    const REAL t65 = B_at_z * (minus_coupler_joint_force_force_y + t53);
    const REAL t56 = t5 * (crank_sin * t51 - crank_cos * t53); /* rocker */
    const REAL t61 = t56 + t9 * (crank_cos * t51 + crank_sin * t53); /* rocker */
    const REAL t62 = crank_lever_moment_z_by_C_fx * (t11 * (gravity_z_rocker_mx * minus_rocker_sin + t36 - t61)); /* A */
    const REAL A_balance = t62 - (t65 + (k10 * crank_sin - k7 * A_y_ddot));
    WRITE(u, 0, A_balance);
    REAL checked1 = A_balance;
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 5.057800000000001e-10), /* where D does not move the loop at C */
        checked0 + checked1);
}

BODY(four_bar_inverse_dynamics_platform)(size_t stride, const double *restrict pose,
    const double *restrict rate, const double *restrict acceleration, double *restrict u,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)pose;
    /* rocker: geometry; balance, eqs. (40)-(47) */
    const REAL minus_rocker_sin = SINES(sine, 0);
    const REAL t4 = k6 * minus_rocker_sin;
    /* rocker: reciprocal wrenches, eq. (10); geometry; balance, eqs. (40)-(47) */
    const REAL t5 = D_at_x - t4;
    const REAL rocker_cos = SINES(cosine, 0);
    const REAL t6 = t5 * t5;
    const REAL t2 = k6 * rocker_cos;
    const REAL t7 = t2 * t2 + t6;
    const REAL t8 = t7 - k12;
    const REAL t9 = 0.5 * t8;
    const REAL t11 = k14 - t9 * t9;
    const REAL t12 = SQRT(t11);
    const REAL t14 = SELECT(0.0, -t12, t12);
    /* crank: reciprocal wrenches, eq. (10); geometry */
    const REAL crank_lever_moment_x_by_C_fz = k15 * t14;
    const REAL t21 = t5 * crank_lever_moment_x_by_C_fz;
    const REAL t18 = t2 * crank_lever_moment_x_by_C_fz;
    const REAL minus_crank_lever_moment_y_by_C_fz = B_at_z + k13 * t8;
    const REAL t19 = t5 * minus_crank_lever_moment_y_by_C_fz - t18;
    const REAL t22 = t2 * minus_crank_lever_moment_y_by_C_fz + t21;
    const REAL coupler_cos = k15 * t8;
    const REAL t16 = 1.0 / t7; /* rocker */
    const REAL crank_cos = t16 * t22;
    const REAL crank_sin = t16 * t19;
    const REAL crank_lever_moment_z_by_C_fy = t7 + k20;
    const REAL D_rate = READ(rate, 0);
    const REAL t40 = k6 * D_rate; /* D */
    /* C: loop closure; balance, eqs. (40)-(47) */
    const REAL t41 = minus_rocker_sin * t40;
    const REAL t43 = rocker_cos * t40;
    const REAL t47 = crank_sin * t41;
    const REAL t45 = crank_cos * t41 + crank_sin * t43;
    const REAL t49 = t47 - crank_cos * t43;
    const REAL t46 = coupler_cos * t45;
    const REAL coupler_sin = k19 * t14;
    const REAL crank_lever_moment_z_by_C_fx = 2.0 * t14;
    const REAL minus_C_opening_rate_fx = t46 - coupler_sin * t49;
    const REAL C_opening_rate_fy = coupler_sin * t45 + coupler_cos * t49;
    const REAL minus_C_part_fx_by_A = 1.0 / crank_lever_moment_z_by_C_fx;
    const REAL crank_omega_z = minus_C_opening_rate_fx * minus_C_part_fx_by_A;
    const REAL coupler_omega_z = crank_omega_z - 2.0 * (C_opening_rate_fy + crank_lever_moment_z_by_C_fy * crank_omega_z);
    const REAL minus_coupler_U_xx = coupler_omega_z * coupler_omega_z;
    const REAL t51 = B_at_z * (crank_omega_z * crank_omega_z); /* crank */
    const REAL t90 = coupler_sin * (coupler_com_z * minus_coupler_U_xx); /* coupler */
    const REAL t58 = coupler_cos * t51 + 0.5 * minus_coupler_U_xx; /* coupler */
    const REAL t23 = k6 * (D_rate * D_rate); /* rocker */
    const REAL D_acc = READ(acceleration, 0);
    const REAL t24 = rocker_cos * t23; /* rocker */
    const REAL t29 = minus_rocker_sin * t23; /* rocker */
    const REAL t25 = k6 * D_acc; /* D */
    const REAL t27 = t24 - minus_rocker_sin * t25;
    const REAL t31 = t29 + rocker_cos * t25;
    const REAL t35 = crank_sin * t27;
    const REAL t33 = crank_cos * t27 - crank_sin * t31;
    const REAL t37 = t35 + crank_cos * t31;
    const REAL t59 = coupler_sin * t33;
    const REAL minus_crank_alpha_z = minus_C_part_fx_by_A * (coupler_cos * t33 - coupler_sin * t37 - t58);
    const REAL t62 = crank_lever_moment_z_by_C_fy * minus_crank_alpha_z; /* crank */
    const REAL t64 = 2.0 * (coupler_sin * t51 - (t59 + coupler_cos * t37) - t62); /* coupler */
    const REAL minus_coupler_alpha_z = minus_crank_alpha_z + t64;
    const REAL t65 = coupler_sxx * minus_coupler_alpha_z; /* coupler */
    const REAL minus_coupler_joint_force_force_y = t90 + coupler_cos * (coupler_com_z * minus_coupler_alpha_z);
    const REAL t94 = k7 * minus_crank_alpha_z; /* crank */
    const REAL t70 = coupler_cos * (gravity_z * crank_sin + B_at_z * minus_crank_alpha_z); /* coupler */
    const REAL minus_coupler_rate_moment_z = t65 - coupler_com_z * (coupler_sin * (t51 - gravity_z * crank_cos) - t70);
    const REAL minus_C_multiplier_fy = 2.0 * minus_coupler_rate_moment_z;
    const REAL t72 = coupler_sin * minus_C_multiplier_fy; /* rocker */
    const REAL t74 = coupler_cos * minus_C_multiplier_fy; /* rocker */
    const REAL t93 = B_at_z * (minus_coupler_joint_force_force_y - t74); /* crank */
    const REAL t77 = t2 * (crank_sin * t72 - crank_cos * t74); /* rocker */
    const REAL t82 = t77 + t4 * (crank_cos * t72 + crank_sin * t74); /* rocker */
    const REAL rocker_joint_force_moment_z = gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * D_acc + t82;
    const REAL t85 = t2 * (crank_sin * coupler_cos + crank_cos * coupler_sin);
    const REAL minus_C_closure_fx_by_D = t85 + t4 * (crank_cos * coupler_cos - crank_sin * coupler_sin);
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL t89 = crank_lever_moment_z_by_C_fx * (rocker_joint_force_moment_z / minus_C_closure_fx_by_D); /* A */
    const REAL A_balance = t89 - (t93 + (t94 + k10 * crank_sin));
    WRITE(u, 0, A_balance);
    REAL checked1 = A_balance;
    NOT_BELOW(t11, 0.0, 11);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(crank_lever_moment_z_by_C_fx, 3.01689e-10) OR /* where the reciprocal wrench C.fx has no power along crank, as in a stretched limb */
        SMALL(minus_C_closure_fx_by_D, 5.057800000000001e-10), /* where D does not move the loop at C */
        checked0 + checked1);
}

#if !defined(FOUR_BAR_VECTORS)

int four_bar_inverse_dynamics(const double *restrict q, const double *restrict v, const double *restrict a,
    double *restrict u)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_inverse_dynamics_body(1, q, v, a, u, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(u, 1);
    }
    return outcome;
}

int four_bar_inverse_dynamics_independent(const double *restrict q, const double *restrict y_dot,
    const double *restrict y_ddot, double *restrict u)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_inverse_dynamics_independent_body(1, q, y_dot, y_ddot, u, sine, cosine,
        NULL);
    if (outcome != 0) {
        four_bar_set_nan(u, 1);
    }
    return outcome;
}

int four_bar_inverse_dynamics_platform(const double *restrict pose, const double *restrict rate,
    const double *restrict acceleration, double *restrict u)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines9(pose, sine, cosine);
    const int outcome = four_bar_inverse_dynamics_platform_body(1, pose, rate, acceleration, u, sine, cosine,
        NULL);
    if (outcome != 0) {
        four_bar_set_nan(u, 1);
    }
    return outcome;
}
#endif /* FOUR_BAR_VECTORS */
