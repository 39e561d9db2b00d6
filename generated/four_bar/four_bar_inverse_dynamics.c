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
    /* A: accelerations; momentum rate, eq. (35) */
    const REAL A_v = READ(v, 0), crank_cos = SINES(cosine, 0), coupler_sin = SINES(sine, 1), A_a = READ(a, 0),
      crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1),
      t6 = coupler_sin * (B_at_z * (A_v * A_v) - gravity_z * crank_cos), /* coupler */
      t10 = k11 * (t6 + coupler_cos * (B_at_z * A_a - gravity_z * crank_sin)), /* coupler */
      coupler_twist_rate_wy = A_a + READ(a, 1), C_multiplier_fy = 2.0 * (coupler_sxx * coupler_twist_rate_wy + t10),
      t13 = coupler_cos * coupler_twist_rate_wy; /* coupler */
    /* rocker: balance, eqs. (40)-(47); geometry */
    const REAL t19 = coupler_sin * C_multiplier_fy, t11 = coupler_cos * C_multiplier_fy, /* A */
      t24 = crank_cos * t19, t22 = crank_sin * t19 - crank_cos * t11,
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 2), minus_rocker_sin = SINES(sine, 2),
      t23 = minus_rocker_joint_force_my_by_C_fz * t22, t26 = t24 + crank_sin * t11,
      minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin,
      t28 = t23 + minus_rocker_joint_force_mx_by_C_fz * t26,
      t29 = coupler_sin * (gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * READ(a, 2) - t28), /* A */
      t32 = (crank_sin * coupler_cos + crank_cos * coupler_sin) * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_C_closure_fx_by_D = t32 - (crank_sin * coupler_sin - crank_cos * coupler_cos) *
          minus_rocker_joint_force_mx_by_C_fz;
    REAL checked1 = minus_C_closure_fx_by_D;
    const REAL t36 = t29 / minus_C_closure_fx_by_D, /* A */
      coupler_omega_z = A_v + READ(v, 1),
      t37 = t11 + k11 * (coupler_sin * (coupler_omega_z * coupler_omega_z) - t13) - t36, /* A */
      A_balance = k8 * A_a - k14 * crank_sin - B_at_z * t37;
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
    /* crank: geometry; reciprocal wrenches, eq. (10); accelerations */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      rocker_cos = SINES(cosine, 2), minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos,
      t5 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      minus_rocker_sin = SINES(sine, 2), minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin,
      t14 = coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz, /* C */
      minus_C_closure_fx_by_D = t5 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL t9 = 1.0 / minus_C_closure_fx_by_D, /* C */
      C_closure_fy_by_D = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz + t14,
      crank_lever_mz_by_C_fx = B_at_z * coupler_sin, A_y_dot = READ(y_dot, 0),
      D_joint_rate = crank_lever_mz_by_C_fx * A_y_dot * t9, t19 = k6 * (D_joint_rate * D_joint_rate), /* rocker */
      t16 = C_closure_fy_by_D * D_joint_rate, /* B */
      t20 = rocker_cos * t19, /* rocker */
      t22 = minus_rocker_sin * t19, /* rocker */
      t29 = crank_cos * t20 - crank_sin * t22, /* D */
      t24 = crank_sin * t20 + crank_cos * t22, /* D */
      t26 = B_at_z * (A_y_dot * A_y_dot), t30 = t26 - t29, /* D */
      t32 = coupler_sin * t24 + coupler_cos * t30, /* D */
      t47 = coupler_cos * t24 - coupler_sin * t30, /* B */
      crank_lever_mz_by_C_fy = 0.5 + B_at_z * coupler_cos;
    /* coupler: accelerations; balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL coupler_omega_z = A_y_dot - 2.0 * (crank_lever_mz_by_C_fy * A_y_dot + t16),
      minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z, A_y_ddot = READ(y_ddot, 0),
      t48 = crank_lever_mz_by_C_fy * A_y_ddot - t47, /* B */
      t64 = coupler_sin * minus_coupler_U_still_xx,
      D_joint_acc = t9 * (crank_lever_mz_by_C_fx * A_y_ddot - (0.5 * minus_coupler_U_still_xx + t32)),
      coupler_alpha_z = A_y_ddot - 2.0 * (C_closure_fy_by_D * D_joint_acc + t48),
      t35 = rocker_sxx * D_joint_acc, /* D */
      t50 = coupler_sxx * coupler_alpha_z, t67 = k11 * (t64 - coupler_cos * coupler_alpha_z),
      t38 = coupler_sin * (gravity_z * crank_cos - t26),
      t42 = k11 * (t38 + coupler_cos * (gravity_z * crank_sin - B_at_z * A_y_ddot)),
      minus_C_multiplier_fy = 2.0 * (t42 - t50), t51 = coupler_sin * minus_C_multiplier_fy, /* rocker */
      t53 = coupler_cos * minus_C_multiplier_fy, /* rocker */
      t69 = B_at_z * (t53 - t67), /* A */
      t56 = minus_rocker_joint_force_my_by_C_fz * (crank_sin * t51 - crank_cos * t53), /* rocker */
      t61 = t56 + minus_rocker_joint_force_mx_by_C_fz * (crank_cos * t51 + crank_sin * t53), /* rocker */
      t62 = crank_lever_mz_by_C_fx * (t9 * (gravity_z_rocker_mx * minus_rocker_sin + t35 + t61)), /* A */
      A_balance = t62 - (k14 * crank_sin - k8 * A_y_ddot - t69);
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
    const REAL minus_rocker_sin = SINES(sine, 0), minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin;
    /* rocker: reciprocal wrenches, eq. (10); geometry; balance, eqs. (40)-(47) */
    const REAL t3 = D_at_x - minus_rocker_joint_force_mx_by_C_fz, rocker_cos = SINES(cosine, 0), t4 = t3 * t3,
      minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos,
      t5 = minus_rocker_joint_force_my_by_C_fz * minus_rocker_joint_force_my_by_C_fz + t4, t6 = t5 - k16,
      t7 = 0.5 * t6, t9 = k18 - t7 * t7, t10 = SQRT(t9), t12 = SELECT(0.0, -t10, t10);
    /* crank: reciprocal wrenches, eq. (10); geometry */
    const REAL crank_lever_mx_by_C_fz = k19 * t12, t19 = t3 * crank_lever_mx_by_C_fz,
      t16 = minus_rocker_joint_force_my_by_C_fz * crank_lever_mx_by_C_fz,
      minus_crank_lever_my_by_C_fz = B_at_z + k17 * t6, t17 = t3 * minus_crank_lever_my_by_C_fz - t16,
      t20 = minus_rocker_joint_force_my_by_C_fz * minus_crank_lever_my_by_C_fz + t19, coupler_cos = k19 * t6,
      t14 = 1.0 / t5, /* rocker */
      crank_cos = t14 * t20, crank_sin = t14 * t17, crank_lever_mz_by_C_fy = t5 + k24, D_rate = READ(rate, 0),
      t21 = k6 * D_rate; /* D */
    /* C: loop closure; balance, eqs. (40)-(47) */
    const REAL t22 = minus_rocker_sin * t21, t24 = rocker_cos * t21, t28 = crank_sin * t22,
      t26 = crank_cos * t22 + crank_sin * t24, t30 = t28 - crank_cos * t24, t27 = coupler_cos * t26,
      coupler_sin = k23 * t12, crank_lever_mz_by_C_fx = 2.0 * t12, minus_C_opening_rate_fx = t27 - coupler_sin *
          t30,
      C_opening_rate_fy = coupler_sin * t26 + coupler_cos * t30, minus_C_part_fx_by_A = 1.0 /
          crank_lever_mz_by_C_fx,
      crank_omega_z = minus_C_opening_rate_fx * minus_C_part_fx_by_A,
      coupler_omega_z = crank_omega_z - 2.0 * (C_opening_rate_fy + crank_lever_mz_by_C_fy * crank_omega_z),
      minus_coupler_U_xx = coupler_omega_z * coupler_omega_z,
      t50 = B_at_z * (crank_omega_z * crank_omega_z), /* crank */
      t37 = 0.5 * minus_coupler_U_xx, /* coupler */
      t88 = coupler_sin * minus_coupler_U_xx, /* coupler */
      t38 = k6 * (D_rate * D_rate), /* rocker */
      D_acc = READ(acceleration, 0), t39 = rocker_cos * t38, /* rocker */
      t44 = minus_rocker_sin * t38, /* rocker */
      t40 = k6 * D_acc, /* D */
      t42 = t39 - minus_rocker_sin * t40, t46 = t44 + rocker_cos * t40, t43 = crank_sin * t42,
      t54 = t50 - (crank_cos * t42 - crank_sin * t46), t48 = t43 + crank_cos * t46,
      t59 = coupler_sin * t54, /* coupler */
      crank_alpha_z = minus_C_part_fx_by_A * (t37 + (coupler_sin * t48 + coupler_cos * t54)),
      coupler_alpha_z = crank_alpha_z - 2.0 * (crank_lever_mz_by_C_fy * crank_alpha_z - (coupler_cos * t48 - t59)),
      t63 = coupler_sxx * coupler_alpha_z, /* coupler */
      t91 = k11 * (t88 - coupler_cos * coupler_alpha_z), /* coupler */
      t95 = k8 * crank_alpha_z, /* crank */
      t68 = coupler_cos * (gravity_z * crank_sin - B_at_z * crank_alpha_z), /* coupler */
      coupler_rate_mz = t63 + k11 * (coupler_sin * (t50 - gravity_z * crank_cos) - t68),
      C_multiplier_fy = 2.0 * coupler_rate_mz, t70 = coupler_sin * C_multiplier_fy, /* rocker */
      t72 = coupler_cos * C_multiplier_fy, /* rocker */
      t93 = B_at_z * (t72 + t91), /* A */
      t75 = minus_rocker_joint_force_my_by_C_fz * (crank_sin * t70 - crank_cos * t72), /* rocker */
      t80 = t75 + minus_rocker_joint_force_mx_by_C_fz * (crank_cos * t70 + crank_sin * t72), /* rocker */
      rocker_joint_force_mz = gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * D_acc - t80,
      t83 = minus_rocker_joint_force_my_by_C_fz * (crank_sin * coupler_cos + crank_cos * coupler_sin),
      minus_C_closure_fx_by_D = t83 + minus_rocker_joint_force_mx_by_C_fz * (crank_cos * coupler_cos - crank_sin *
          coupler_sin);
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL t87 = crank_lever_mz_by_C_fx * (rocker_joint_force_mz / minus_C_closure_fx_by_D), /* A */
      A_balance = t87 - (t93 + (k14 * crank_sin - t95));
    WRITE(u, 0, A_balance);
    REAL checked1 = A_balance;
    /* else status 11: out of reach: limb A does not get there */
    NOT_BELOW(t9, 0.0, 11);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(crank_lever_mz_by_C_fx, 3.01689e-10) OR
            /* where the reciprocal wrench C.fx has no power along crank, as in a stretched limb */
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
    four_bar_sines11(pose, sine, cosine);
    const int outcome = four_bar_inverse_dynamics_platform_body(1, pose, rate, acceleration, u, sine, cosine,
        NULL);
    if (outcome != 0) {
        four_bar_set_nan(u, 1);
    }
    return outcome;
}
#endif /* FOUR_BAR_VECTORS */
