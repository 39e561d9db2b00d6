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
    const REAL A_v = READ(v, 0), crank_cos = SINES(cosine, 0), coupler_sin = SINES(sine, 1), A_a = READ(a, 0),
      crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1),
      t7 = coupler_sin * (B_at_z * (A_v * A_v) - gravity_z * crank_cos), /* coupler */
      t11 = k7 * (t7 + coupler_cos * (B_at_z * A_a - gravity_z * crank_sin)), /* coupler */
      coupler_twist_rate_wy = A_a + READ(a, 1), C_multiplier_fy = 2.0 * (coupler_sxx * coupler_twist_rate_wy + t11),
      t30 = coupler_cos * (k7 * coupler_twist_rate_wy); /* coupler */
    /* rocker: balance, eqs. (40)-(47); geometry */
    const REAL t12 = coupler_sin * C_multiplier_fy, t14 = coupler_cos * C_multiplier_fy, t18 = crank_cos * t12,
      t16 = crank_sin * t12 - crank_cos * t14, minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 2),
      minus_rocker_sin = SINES(sine, 2), t17 = minus_rocker_joint_force_my_by_C_fz * t16, t20 = t18 + crank_sin * t14,
      minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin,
      t22 = t17 + minus_rocker_joint_force_mx_by_C_fz * t20,
      rocker_joint_force_mz = gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * READ(a, 2) - t22,
      t25 = (crank_sin * coupler_cos + crank_cos * coupler_sin) * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_C_closure_fx_by_D = t25 - (crank_sin * coupler_sin - crank_cos * coupler_cos) * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked1 = minus_C_closure_fx_by_D;
    const REAL t29 = B_at_z * coupler_sin * (rocker_joint_force_mz / minus_C_closure_fx_by_D), /* A */
      coupler_omega_z = A_v + READ(v, 1),
      t32 = B_at_z * (coupler_sin * (k7 * (coupler_omega_z * coupler_omega_z)) - t30 + t14), /* crank */
      A_balance = t29 - (t32 + (k12 * crank_sin - k8 * A_a));
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
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      rocker_cos = SINES(cosine, 2), minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos,
      t5 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      minus_rocker_sin = SINES(sine, 2), minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin,
      t28 = coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz, /* C */
      minus_C_closure_fx_by_D = t5 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL t9 = 1.0 / minus_C_closure_fx_by_D, /* C */
      C_closure_fy_by_D = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz + t28,
      crank_lever_mz_by_C_fx = B_at_z * coupler_sin, A_y_dot = READ(y_dot, 0),
      D_joint_rate = crank_lever_mz_by_C_fx * A_y_dot * t9, t12 = k6 * (D_joint_rate * D_joint_rate), /* rocker */
      t29 = C_closure_fy_by_D * D_joint_rate, /* B */
      t13 = rocker_cos * t12, /* rocker */
      t15 = minus_rocker_sin * t12, /* rocker */
      t19 = crank_sin * t13, /* C */
      t17 = crank_cos * t13 - crank_sin * t15, /* C */
      t21 = t19 + crank_cos * t15, /* C */
      t23 = coupler_cos * t17 - coupler_sin * t21, /* C */
      t38 = coupler_sin * t17 + coupler_cos * t21, /* C */
      crank_lever_mz_by_C_fy = 0.5 + B_at_z * coupler_cos,
      coupler_omega_z = A_y_dot - 2.0 * (crank_lever_mz_by_C_fy * A_y_dot + t29),
      minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z, A_y_ddot = READ(y_ddot, 0),
      t35 = crank_lever_mz_by_C_fy * A_y_ddot, /* B */
      t31 = 0.5 * minus_coupler_U_still_xx, /* coupler */
      minus_crank_force_y = coupler_sin * (k7 * minus_coupler_U_still_xx), t24 = B_at_z * (A_y_dot * A_y_dot),
      D_joint_acc = t9 * (crank_lever_mz_by_C_fx * A_y_ddot + (t23 - (coupler_cos * t24 + t31))),
      t34 = rocker_sxx * D_joint_acc, /* D */
      minus_B_joint_acc = 2.0 * (t35 + (coupler_sin * t24 - t38) + C_closure_fy_by_D * D_joint_acc),
      coupler_alpha_z = A_y_ddot - minus_B_joint_acc, t42 = coupler_sxx * coupler_alpha_z, /* coupler */
      minus_coupler_joint_force_fy = minus_crank_force_y - coupler_cos * (k7 * coupler_alpha_z),
      t44 = coupler_sin * (gravity_z * crank_cos - t24), /* coupler */
      t48 = k7 * (t44 + coupler_cos * (gravity_z * crank_sin - B_at_z * A_y_ddot)), /* coupler */
      C_multiplier_fy = 2.0 * (t42 - t48), t49 = coupler_sin * C_multiplier_fy, /* rocker */
      t51 = coupler_cos * C_multiplier_fy, /* rocker */
      t63 = B_at_z * (minus_coupler_joint_force_fy + t51),
      t54 = minus_rocker_joint_force_my_by_C_fz * (crank_sin * t49 - crank_cos * t51), /* rocker */
      t59 = t54 + minus_rocker_joint_force_mx_by_C_fz * (crank_cos * t49 + crank_sin * t51), /* rocker */
      t60 = crank_lever_mz_by_C_fx * (t9 * (gravity_z_rocker_mx * minus_rocker_sin + t34 - t59)), /* A */
      A_balance = t60 - (t63 + (k12 * crank_sin - k8 * A_y_ddot));
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
      t5 = minus_rocker_joint_force_my_by_C_fz * minus_rocker_joint_force_my_by_C_fz + t4, t6 = t5 - k14,
      t7 = 0.5 * t6, t9 = k16 - t7 * t7, t10 = SQRT(t9), t12 = SELECT(0.0, -t10, t10);
    /* crank: reciprocal wrenches, eq. (10); geometry */
    const REAL crank_lever_mx_by_C_fz = k17 * t12, t19 = t3 * crank_lever_mx_by_C_fz,
      t16 = minus_rocker_joint_force_my_by_C_fz * crank_lever_mx_by_C_fz,
      minus_crank_lever_my_by_C_fz = B_at_z + k15 * t6, t17 = t3 * minus_crank_lever_my_by_C_fz - t16,
      t20 = minus_rocker_joint_force_my_by_C_fz * minus_crank_lever_my_by_C_fz + t19, coupler_cos = k17 * t6,
      t14 = 1.0 / t5, /* rocker */
      crank_cos = t14 * t20, crank_sin = t14 * t17, crank_lever_mz_by_C_fy = t5 + k22, D_rate = READ(rate, 0),
      t38 = k6 * D_rate; /* D */
    /* C: loop closure; balance, eqs. (40)-(47) */
    const REAL t39 = minus_rocker_sin * t38, t41 = rocker_cos * t38, t45 = crank_sin * t39,
      t43 = crank_cos * t39 + crank_sin * t41, t47 = t45 - crank_cos * t41, t44 = coupler_cos * t43,
      coupler_sin = k21 * t12, crank_lever_mz_by_C_fx = 2.0 * t12, minus_C_opening_rate_fx = t44 - coupler_sin * t47,
      C_opening_rate_fy = coupler_sin * t43 + coupler_cos * t47, minus_C_part_fx_by_A = 1.0 / crank_lever_mz_by_C_fx,
      crank_omega_z = minus_C_opening_rate_fx * minus_C_part_fx_by_A,
      coupler_omega_z = crank_omega_z - 2.0 * (C_opening_rate_fy + crank_lever_mz_by_C_fy * crank_omega_z),
      minus_coupler_U_xx = coupler_omega_z * coupler_omega_z,
      t49 = B_at_z * (crank_omega_z * crank_omega_z), /* crank */
      t88 = coupler_sin * (k7 * minus_coupler_U_xx), /* coupler */
      t56 = coupler_cos * t49 + 0.5 * minus_coupler_U_xx, /* coupler */
      t21 = k6 * (D_rate * D_rate), /* rocker */
      D_acc = READ(acceleration, 0), t22 = rocker_cos * t21, /* rocker */
      t27 = minus_rocker_sin * t21, /* rocker */
      t23 = k6 * D_acc, /* D */
      t25 = t22 - minus_rocker_sin * t23, t29 = t27 + rocker_cos * t23, t33 = crank_sin * t25,
      t31 = crank_cos * t25 - crank_sin * t29, t35 = t33 + crank_cos * t29, t57 = coupler_sin * t31,
      minus_crank_alpha_z = minus_C_part_fx_by_A * (coupler_cos * t31 - coupler_sin * t35 - t56),
      t61 = coupler_sin * t49 - (t57 + coupler_cos * t35) - crank_lever_mz_by_C_fy * minus_crank_alpha_z, /* coupler */
      minus_coupler_alpha_z = minus_crank_alpha_z + 2.0 * t61,
      t63 = coupler_sxx * minus_coupler_alpha_z, /* coupler */
      minus_coupler_joint_force_fy = t88 + coupler_cos * (k7 * minus_coupler_alpha_z),
      t92 = k8 * minus_crank_alpha_z, /* crank */
      t68 = coupler_cos * (gravity_z * crank_sin + B_at_z * minus_crank_alpha_z), /* coupler */
      minus_coupler_rate_mz = t63 - k7 * (coupler_sin * (t49 - gravity_z * crank_cos) - t68),
      minus_C_multiplier_fy = 2.0 * minus_coupler_rate_mz, t70 = coupler_sin * minus_C_multiplier_fy, /* rocker */
      t72 = coupler_cos * minus_C_multiplier_fy, /* rocker */
      t91 = B_at_z * (minus_coupler_joint_force_fy - t72), /* crank */
      t75 = minus_rocker_joint_force_my_by_C_fz * (crank_sin * t70 - crank_cos * t72), /* rocker */
      t80 = t75 + minus_rocker_joint_force_mx_by_C_fz * (crank_cos * t70 + crank_sin * t72), /* rocker */
      rocker_joint_force_mz = gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * D_acc + t80,
      t83 = minus_rocker_joint_force_my_by_C_fz * (crank_sin * coupler_cos + crank_cos * coupler_sin),
      minus_C_closure_fx_by_D = t83 + minus_rocker_joint_force_mx_by_C_fz * (crank_cos * coupler_cos - crank_sin * coupler_sin);
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL t87 = crank_lever_mz_by_C_fx * (rocker_joint_force_mz / minus_C_closure_fx_by_D), /* A */
      A_balance = t87 - (t91 + (t92 + k12 * crank_sin));
    WRITE(u, 0, A_balance);
    REAL checked1 = A_balance;
    /* else status 11: out of reach: limb A does not get there */
    NOT_BELOW(t9, 0.0, 11);
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(crank_lever_mz_by_C_fx, 3.01689e-10) OR /* where the reciprocal wrench C.fx has no power along crank, as in a stretched limb */
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
