/*
 * four_bar: forward_dynamics.
 *   forward_dynamics; forward_dynamics_independent; forward_dynamics_reactions
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

BODY(four_bar_forward_dynamics)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    (void)q;
    /* D: accelerations; rates that follow */
    const REAL D_v = READ(v, 2);
    const REAL t7 = k6 * (D_v * D_v); /* rocker */
    const REAL rocker_cos = SINES(cosine, 2);
    const REAL t8 = rocker_cos * t7; /* rocker */
    const REAL minus_rocker_sin = SINES(sine, 2);
    const REAL t10 = minus_rocker_sin * t7; /* rocker */
    const REAL crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0);
    const REAL t14 = crank_sin * t8; /* C */
    const REAL t12 = crank_cos * t8 - crank_sin * t10; /* C */
    const REAL t16 = t14 + crank_cos * t10; /* C */
    const REAL coupler_cos = SINES(cosine, 1), coupler_sin = SINES(sine, 1), A_v = READ(v, 0);
    const REAL t29 = coupler_cos * t12 - coupler_sin * t16; /* C */
    const REAL t18 = coupler_sin * t12 + coupler_cos * t16; /* C */
    const REAL t2 = B_at_z * (A_v * A_v); /* crank */
    const REAL minus_coupler_acc_still_x = coupler_cos * t2;
    const REAL coupler_omega_z = A_v + READ(v, 1);
    const REAL minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z;
    const REAL C_opening_bias_fx = t29 - (minus_coupler_acc_still_x + 0.5 * minus_coupler_U_still_xx);
    const REAL minus_crank_force_y = coupler_sin * (coupler_com_z * minus_coupler_U_still_xx);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t21 = k6 * rocker_cos; /* rocker */
    const REAL t32 = coupler_rotation_xx * t21; /* C */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t22 = minus_coupler_rotation_xy * t21; /* C */
    const REAL t25 = k6 * minus_rocker_sin; /* rocker */
    const REAL minus_C_closure_fx_by_D = t32 - minus_coupler_rotation_xy * t25;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t22 + coupler_rotation_xx * t25;
    const REAL t34 = 1.0 / minus_C_closure_fx_by_D; /* C */
    const REAL D_joint_acc_still = C_opening_bias_fx * t34;
    const REAL t36 = coupler_sin * t2 - t18 + C_closure_fy_by_D * D_joint_acc_still; /* coupler */
    const REAL t39 = B_at_z * (minus_crank_force_y + coupler_cos * (k2 * t36)); /* crank */
    const REAL t37 = coupler_com_x * t36; /* coupler */
    const REAL minus_B_joint_acc_still = 2.0 * t36;
    const REAL coupler_acc_still_y = coupler_sin * (t2 - gravity_z * crank_cos) - coupler_cos * (gravity_z * crank_sin);
    const REAL coupler_rate_moment_z_2 = coupler_com_z * coupler_acc_still_y - t37;
    const REAL minus_A_generalised_force = READ(u, 0) + (k10 * crank_sin - (coupler_rate_moment_z_2 - t39));
    const REAL D_null_space_by_A = B_at_z * coupler_sin * t34;
    const REAL t43 = 0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A; /* B */
    const REAL minus_B_null_space_by_A = 2.0 * t43;
    /* A: free motion; inertia; accelerations */
    const REAL t45 = minus_A_generalised_force + minus_B_null_space_by_A * coupler_rate_moment_z_2;
    const REAL t55 = coupler_com_x * t43; /* B */
    const REAL t47 = D_null_space_by_A * (gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * D_joint_acc_still);
    const REAL A_reduced_force = t45 - t47;
    const REAL A_mass_matrix_by_B = coupler_sxx + B_at_z_coupler_com_z * coupler_cos;
    const REAL t53 = minus_B_null_space_by_A * A_mass_matrix_by_B;
    const REAL t57 = minus_B_null_space_by_A * (A_mass_matrix_by_B - t55);
    const REAL t49 = coupler_cos * (coupler_sxx * coupler_cos); /* coupler */
    const REAL t54 = coupler_sxx - t49 + (k7 + (t49 + k9 * coupler_cos)) - t53;
    const REAL A_reduced_inertia_by_A = t54 - t57 + D_null_space_by_A * (rocker_sxx * D_null_space_by_A);
    REAL checked1 = A_reduced_inertia_by_A;
    const REAL A_joint_acc = A_reduced_force / A_reduced_inertia_by_A;
    WRITE(a, 0, A_joint_acc);
    const REAL D_joint_acc = D_joint_acc_still + D_null_space_by_A * A_joint_acc;
    WRITE(a, 2, D_joint_acc);
    REAL checked2 = D_joint_acc;
    const REAL B_joint_acc = -(minus_B_joint_acc_still + minus_B_null_space_by_A * A_joint_acc);
    WRITE(a, 1, B_joint_acc);
    REAL checked3 = B_joint_acc;
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-06) OR /* where D does not move the loop at C */
        SMALL(A_reduced_inertia_by_A, 3.264600000000001e-07), /* where A feels no inertia */
        (checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_forward_dynamics_independent)(size_t stride, const double *restrict q,
    const double *restrict y_dot, const double *restrict u, double *restrict y_ddot,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry; reciprocal wrenches, eq. (10); balance, eqs. (40)-(47) */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_sin = SINES(sine, 1);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL rocker_cos = SINES(cosine, 2);
    const REAL t7 = k6 * rocker_cos; /* rocker */
    const REAL t8 = coupler_rotation_xx * t7; /* C */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL minus_rocker_sin = SINES(sine, 2);
    const REAL t26 = minus_coupler_rotation_xy * t7; /* C */
    const REAL t11 = k6 * minus_rocker_sin; /* rocker */
    const REAL minus_C_closure_fx_by_D = t8 - minus_coupler_rotation_xy * t11;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t26 + coupler_rotation_xx * t11;
    const REAL t13 = 1.0 / minus_C_closure_fx_by_D; /* C */
    const REAL crank_lever_moment_z_by_C_fx = B_at_z * coupler_sin;
    const REAL A_y_dot = READ(y_dot, 0);
    const REAL D_joint_rate = crank_lever_moment_z_by_C_fx * A_y_dot * t13;
    const REAL D_null_space_by_A = crank_lever_moment_z_by_C_fx * t13;
    const REAL t14 = k6 * (D_joint_rate * D_joint_rate); /* rocker */
    const REAL t33 = C_closure_fy_by_D * D_joint_rate; /* B */
    const REAL t15 = rocker_cos * t14; /* rocker */
    const REAL t17 = minus_rocker_sin * t14; /* rocker */
    const REAL t21 = crank_sin * t15; /* C */
    const REAL t19 = crank_cos * t15 - crank_sin * t17; /* C */
    const REAL t23 = t21 + crank_cos * t17; /* C */
    const REAL t30 = coupler_cos * t19 - coupler_sin * t23; /* C */
    const REAL t25 = coupler_sin * t19 + coupler_cos * t23; /* C */
    const REAL crank_lever_moment_z_by_C_fy = 0.5 + B_at_z * coupler_cos;
    const REAL coupler_omega_z = A_y_dot - 2.0 * (crank_lever_moment_z_by_C_fy * A_y_dot + t33);
    const REAL minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z;
    const REAL t35 = 0.5 * minus_coupler_U_still_xx; /* coupler */
    const REAL minus_crank_force_y = coupler_sin * (coupler_com_z * minus_coupler_U_still_xx);
    const REAL t2 = B_at_z * (A_y_dot * A_y_dot);
    const REAL D_joint_acc_still = t13 * (t30 - (coupler_cos * t2 + t35));
    const REAL t37 = C_closure_fy_by_D * D_joint_acc_still; /* coupler */
    const REAL t47 = crank_lever_moment_z_by_C_fy + C_closure_fy_by_D * D_null_space_by_A; /* B */
    const REAL t50 = rocker_sxx * D_joint_acc_still; /* D */
    const REAL t38 = coupler_sin * t2 - t25 + t37; /* coupler */
    const REAL t44 = B_at_z * (minus_crank_force_y + coupler_cos * (k2 * t38));
    const REAL t39 = coupler_com_x * t38; /* coupler */
    const REAL minus_coupler_acc_y = coupler_cos * (gravity_z * crank_sin) + coupler_sin * (gravity_z * crank_cos - t2);
    const REAL minus_coupler_rate_moment_z_2 = t39 + coupler_com_z * minus_coupler_acc_y;
    /* A: free motion; inertia; accelerations */
    const REAL minus_A_generalised_force = READ(u, 0) + (k10 * crank_sin + (minus_coupler_rate_moment_z_2 + t44));
    const REAL minus_B_null_space_by_A = 2.0 * t47;
    const REAL t49 = minus_A_generalised_force - minus_B_null_space_by_A * minus_coupler_rate_moment_z_2;
    const REAL t59 = coupler_com_x * t47; /* B */
    const REAL A_reduced_force = t49 - D_null_space_by_A * (gravity_z_rocker_mx * minus_rocker_sin + t50);
    const REAL A_mass_matrix_by_B = coupler_sxx + B_at_z_coupler_com_z * coupler_cos;
    const REAL t57 = minus_B_null_space_by_A * A_mass_matrix_by_B;
    const REAL t61 = minus_B_null_space_by_A * (A_mass_matrix_by_B - t59);
    const REAL t53 = coupler_cos * (coupler_sxx * coupler_cos); /* coupler */
    const REAL t58 = coupler_sxx - t53 + (k7 + (t53 + k9 * coupler_cos)) - t57;
    const REAL A_reduced_inertia_by_A = t58 - t61 + D_null_space_by_A * (rocker_sxx * D_null_space_by_A);
    REAL checked1 = A_reduced_inertia_by_A;
    const REAL A_joint_acc = A_reduced_force / A_reduced_inertia_by_A;
    WRITE(y_ddot, 0, A_joint_acc);
    REAL checked2 = A_joint_acc;
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 3.01689e-10) OR /* where D does not move the loop at C */
        SMALL(A_reduced_inertia_by_A, 3.2646e-11), /* where A feels no inertia */
        (checked0 + checked1) + checked2);
}

BODY(four_bar_forward_dynamics_reactions)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a, double *restrict reactions, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* D: accelerations; rates that follow */
    const REAL D_v = READ(v, 2);
    const REAL minus_rocker_U_still_xx = D_v * D_v;
    const REAL t7 = k6 * minus_rocker_U_still_xx; /* rocker */
    const REAL rocker_cos = SINES(cosine, 2);
    const REAL minus_rocker_rate_force_x = rocker_mx * minus_rocker_U_still_xx;
    const REAL t8 = rocker_cos * t7; /* rocker */
    const REAL minus_rocker_sin = SINES(sine, 2);
    const REAL t10 = minus_rocker_sin * t7; /* rocker */
    const REAL crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0);
    const REAL t14 = crank_sin * t8; /* C */
    const REAL t12 = crank_cos * t8 - crank_sin * t10; /* C */
    const REAL t16 = t14 + crank_cos * t10; /* C */
    const REAL coupler_cos = SINES(cosine, 1), coupler_sin = SINES(sine, 1), A_v = READ(v, 0);
    const REAL t29 = coupler_cos * t12 - coupler_sin * t16; /* C */
    const REAL t18 = coupler_sin * t12 + coupler_cos * t16; /* C */
    const REAL minus_crank_U_still_xx = A_v * A_v;
    const REAL t2 = B_at_z * minus_crank_U_still_xx; /* crank */
    const REAL t64 = crank_mx * minus_crank_U_still_xx; /* crank */
    const REAL minus_coupler_acc_still_x = coupler_cos * t2;
    const REAL coupler_omega_z = A_v + READ(v, 1);
    const REAL minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z;
    const REAL C_opening_bias_fx = t29 - (minus_coupler_acc_still_x + 0.5 * minus_coupler_U_still_xx);
    const REAL minus_coupler_rate_force_x = coupler_com_z * minus_coupler_U_still_xx;
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t21 = k6 * rocker_cos; /* rocker */
    const REAL t32 = coupler_rotation_xx * t21; /* C */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t25 = k6 * minus_rocker_sin; /* rocker */
    const REAL minus_C_closure_fx_by_D = t32 - minus_coupler_rotation_xy * t25;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL t34 = 1.0 / minus_C_closure_fx_by_D; /* C */
    const REAL D_joint_acc_still = C_opening_bias_fx * t34;
    const REAL C_closure_fy_by_D = minus_coupler_rotation_xy * t21 + coupler_rotation_xx * t25;
    const REAL t36 = coupler_sin * t2 - t18 + C_closure_fy_by_D * D_joint_acc_still; /* coupler */
    const REAL t39 = B_at_z * (coupler_sin * minus_coupler_rate_force_x + coupler_cos * (k2 * t36)); /* crank */
    const REAL t37 = coupler_com_x * t36; /* coupler */
    const REAL minus_B_joint_acc_still = 2.0 * t36;
    const REAL t3 = t2 - gravity_z * crank_cos; /* crank */
    const REAL t4 = coupler_sin * t3; /* coupler */
    const REAL t82 = coupler_cos * t3; /* coupler */
    const REAL minus_crank_acc_y = gravity_z * crank_sin;
    const REAL coupler_rate_moment_z_2 = coupler_com_z * (t4 - coupler_cos * minus_crank_acc_y) - t37;
    const REAL minus_A_generalised_force = READ(u, 0) + (k10 * crank_sin - (coupler_rate_moment_z_2 - t39));
    const REAL D_null_space_by_A = B_at_z * coupler_sin * t34;
    const REAL t43 = 0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A; /* B */
    const REAL minus_B_null_space_by_A = 2.0 * t43;
    /* A: free motion; inertia; accelerations */
    const REAL t45 = minus_A_generalised_force + minus_B_null_space_by_A * coupler_rate_moment_z_2;
    const REAL t55 = coupler_com_x * t43; /* B */
    const REAL t46 = rocker_sxx * D_joint_acc_still; /* D */
    const REAL rocker_rate_moment_z = gravity_z_rocker_mx * minus_rocker_sin;
    const REAL A_reduced_force = t45 - D_null_space_by_A * (rocker_rate_moment_z + t46);
    const REAL A_mass_matrix_by_B = coupler_sxx + B_at_z_coupler_com_z * coupler_cos;
    const REAL t53 = minus_B_null_space_by_A * A_mass_matrix_by_B;
    const REAL t57 = minus_B_null_space_by_A * (A_mass_matrix_by_B - t55);
    const REAL t49 = coupler_cos * (coupler_sxx * coupler_cos); /* coupler */
    const REAL t54 = coupler_sxx - t49 + (k7 + (t49 + k9 * coupler_cos)) - t53;
    const REAL A_reduced_inertia_by_A = t54 - t57 + D_null_space_by_A * (rocker_sxx * D_null_space_by_A);
    REAL checked1 = A_reduced_inertia_by_A;
    const REAL A_joint_acc = A_reduced_force / A_reduced_inertia_by_A;
    WRITE(a, 0, A_joint_acc);
    const REAL minus_B_joint_acc = minus_B_joint_acc_still + minus_B_null_space_by_A * A_joint_acc;
    const REAL B_joint_acc = -minus_B_joint_acc;
    WRITE(a, 1, B_joint_acc);
    REAL checked2 = B_joint_acc;
    const REAL coupler_alpha_z = A_joint_acc - minus_B_joint_acc;
    const REAL D_joint_acc = D_joint_acc_still + D_null_space_by_A * A_joint_acc;
    WRITE(a, 2, D_joint_acc);
    const REAL t68 = minus_crank_acc_y - B_at_z * A_joint_acc; /* coupler */
    const REAL t92 = crank_mx * A_joint_acc;
    const REAL coupler_acc_y = t4 - coupler_cos * t68;
    const REAL minus_coupler_rate_force_x_2 = minus_coupler_rate_force_x + rocker_m * (t82 + coupler_sin * t68);
    const REAL t86 = rocker_m * coupler_acc_y; /* coupler */
    const REAL C_multiplier_fy = 2.0 * (coupler_sxx * coupler_alpha_z + coupler_com_z * coupler_acc_y);
    const REAL minus_coupler_sent_force_y = C_multiplier_fy - (coupler_com_z * coupler_alpha_z + t86);
    const REAL t71 = coupler_sin * C_multiplier_fy; /* rocker */
    const REAL t72 = crank_sin * t71; /* rocker */
    const REAL t73 = coupler_cos * C_multiplier_fy; /* rocker */
    const REAL t76 = t21 * (t72 - crank_cos * t73); /* rocker */
    const REAL t81 = t76 + t25 * (crank_cos * t71 + crank_sin * t73); /* rocker */
    const REAL minus_C_multiplier_fx = t34 * (rocker_rate_moment_z + rocker_sxx * D_joint_acc - t81);
    const REAL coupler_sent_force_x = minus_C_multiplier_fx - minus_coupler_rate_force_x_2;
    const REAL rocker_rate_force_y = rocker_mx * D_joint_acc;
    const REAL t89 = coupler_sin * coupler_sent_force_x; /* coupler */
    const REAL coupler_joint_sent_force_x = coupler_cos * coupler_sent_force_x + coupler_sin * minus_coupler_sent_force_y;
    const REAL coupler_joint_sent_force_y = t89 - coupler_cos * minus_coupler_sent_force_y;
    /* crank: balance, eqs. (40)-(47) */
    const REAL crank_sent_force_x = crank_m_gravity_z * crank_cos - t64 + coupler_joint_sent_force_x;
    const REAL t88 = crank_sin * crank_sent_force_x;
    const REAL t94 = crank_cos * crank_sent_force_x;
    const REAL crank_sent_force_y = coupler_joint_sent_force_y - (crank_m_gravity_z * crank_sin - t92);
    const REAL crank_joint_sent_force_y = t88 + crank_cos * crank_sent_force_y;
    WRITE(reactions, 0, crank_joint_sent_force_y);
    REAL checked3 = crank_joint_sent_force_y;
    RESULT(checked0, reactions, 2, t94 - crank_sin * crank_sent_force_y);
    const REAL t98 = crank_cos * coupler_joint_sent_force_x; /* B */
    const REAL B_reaction_force_x = crank_sin * coupler_joint_sent_force_x + crank_cos * coupler_joint_sent_force_y;
    WRITE(reactions, 6, B_reaction_force_x);
    const REAL B_reaction_force_z = t98 - crank_sin * coupler_joint_sent_force_y;
    WRITE(reactions, 8, B_reaction_force_z);
    const REAL coupler_position_z = B_at_z * crank_cos;
    const REAL t100 = coupler_position_z * B_reaction_force_x; /* B */
    const REAL coupler_position_x = B_at_z * crank_sin;
    RESULT(checked1, reactions, 10, t100 - coupler_position_x * B_reaction_force_z);
    const REAL minus_C_reaction_force_z = minus_coupler_rotation_xy * minus_C_multiplier_fx - coupler_rotation_xx * C_multiplier_fy;
    RESULT(checked2, reactions, 14, -minus_C_reaction_force_z);
    const REAL C_reaction_force_x = coupler_rotation_xx * minus_C_multiplier_fx + minus_coupler_rotation_xy * C_multiplier_fy;
    WRITE(reactions, 12, C_reaction_force_x);
    const REAL t108 = (coupler_position_z - 0.5 * minus_coupler_rotation_xy) * C_reaction_force_x; /* C */
    const REAL t155 = per_length * minus_coupler_rotation_xy; /* coupler */
    RESULT(checked3, reactions, 16, t108 + (coupler_position_x + 0.5 * coupler_rotation_xx) * minus_C_reaction_force_z);
    const REAL t153 = per_length * coupler_rotation_xx; /* coupler */
    /* rocker: balance, eqs. (40)-(47); momentum rate, eq. (35); pivots */
    const REAL t118 = t71 + coupler_cos * minus_C_multiplier_fx;
    const REAL t121 = t73 - coupler_sin * minus_C_multiplier_fx;
    const REAL t123 = crank_sin * t118 - crank_cos * t121;
    const REAL t129 = crank_cos * t118 + crank_sin * t121;
    const REAL rocker_rate_force_y_2 = rocker_m_gravity_z * minus_rocker_sin + rocker_rate_force_y;
    const REAL t115 = rocker_cos * rocker_rate_force_y_2;
    const REAL t125 = minus_rocker_sin * rocker_rate_force_y_2;
    const REAL minus_rocker_rate_force_x_2 = minus_rocker_rate_force_x - rocker_m_gravity_z * rocker_cos;
    RESULT(checked0, reactions, 18, minus_rocker_sin * minus_rocker_rate_force_x_2 + t115 - t123);
    const REAL minus_rocker_joint_sent_force_x = rocker_cos * minus_rocker_rate_force_x_2 - t125 + t129;
    RESULT(checked1, reactions, 20, -minus_rocker_joint_sent_force_x);
    RESULT(checked2, reactions, 22, D_at_x * minus_rocker_joint_sent_force_x);
    const REAL t130 = per_length_crank_m * coupler_sin; /* coupler */
    const REAL t132 = 2.0 + t130 * t130; /* coupler */
    const REAL t133 = per_length_crank_m * coupler_cos; /* coupler */
    const REAL t136 = 1.0 + (t132 + t133 * t133); /* coupler */
    const REAL t137 = k11 * minus_rocker_sin;
    const REAL t139 = t136 + t137 * t137; /* mechanism */
    const REAL t140 = k11 * rocker_cos;
    const REAL t143 = 1.0 + (t139 + t140 * t140); /* mechanism */
    const REAL minus_crank_lever_moment_y_by_C_fz = B_at_z + 0.5 * coupler_cos;
    const REAL t145 = crank_sin * minus_crank_lever_moment_y_by_C_fz; /* crank */
    const REAL t150 = crank_cos * minus_crank_lever_moment_y_by_C_fz; /* crank */
    const REAL crank_lever_moment_x_by_C_fz = 0.5 * coupler_sin;
    const REAL t146 = per_length * (crank_cos * crank_lever_moment_x_by_C_fz + t145); /* base */
    const REAL t151 = per_length * (crank_sin * crank_lever_moment_x_by_C_fz - t150); /* base */
    const REAL pivot_0 = t143 + t146 * t146 + t151 * t151;
    checked3 = checked3 + pivot_0;
    const REAL t178 = 1.0 / pivot_0; /* mechanism */
    const REAL t170 = t137 * t155; /* mechanism */
    const REAL t190 = t137 * t153; /* mechanism */
    const REAL t157 = per_length * coupler_cos; /* coupler */
    const REAL t167 = t130 * t157; /* coupler */
    const REAL t160 = per_length * coupler_sin; /* coupler */
    const REAL t187 = t130 * t160; /* coupler */
    /* mechanism: pivots */
    const REAL t171 = t167 - t133 * t160 + t170;
    const REAL t161 = t160 * t160; /* coupler */
    const REAL t191 = t187 + t133 * t157 - t190;
    const REAL t158 = t157 * t157; /* coupler */
    const REAL t195 = t191 - t140 * t155 + t146 * t153;
    const REAL t177 = t171 - t140 * t153 - t146 * t155 + t151 * t153;
    const REAL t154 = t153 * t153; /* coupler */
    const REAL t197 = t195 + t151 * t155;
    const REAL t156 = t155 * t155; /* coupler */
    const REAL t180 = t177 * (t177 * t178);
    const REAL t198 = t197 * t178;
    const REAL t200 = t177 * t198;
    const REAL t199 = t197 * t198;
    const REAL t166 = t154 + (t156 + (per_length_squared + t158 + t161 + t156 + t154)); /* coupler */
    const REAL pivot_1 = t166 - t180;
    checked0 = checked0 + pivot_1;
    const REAL t203 = t199 + t200 * (t200 / pivot_1);
    const REAL t186 = t156 + (t154 + (t156 + (t154 + (t158 + (per_length_squared + t161))))); /* coupler */
    const REAL pivot_2 = t186 - t203;
    checked1 = checked1 + pivot_2;
    WRITE(reactions, 1, CONSTANT(0.0));
    WRITE(reactions, 3, CONSTANT(0.0));
    WRITE(reactions, 4, CONSTANT(0.0));
    WRITE(reactions, 5, CONSTANT(0.0));
    WRITE(reactions, 7, CONSTANT(0.0));
    WRITE(reactions, 9, CONSTANT(0.0));
    WRITE(reactions, 11, CONSTANT(0.0));
    WRITE(reactions, 13, CONSTANT(0.0));
    WRITE(reactions, 15, CONSTANT(0.0));
    WRITE(reactions, 17, CONSTANT(0.0));
    WRITE(reactions, 19, CONSTANT(0.0));
    WRITE(reactions, 21, CONSTANT(0.0));
    WRITE(reactions, 23, CONSTANT(0.0));
    FINITE_UNLESS( /* status 1 where a pivot is smaller than its limit: */
        SMALL(minus_C_closure_fx_by_D, 5.057800000000001e-06) OR /* where D does not move the loop at C */
        SMALL(A_reduced_inertia_by_A, 3.264600000000001e-07) OR /* where A feels no inertia */
        SMALL(pivot_0, 0.0001379) OR /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(pivot_1, 0.00043948) OR /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(pivot_2, 0.00043948), /* where step 2 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3));
}

#if !defined(FOUR_BAR_VECTORS)

BODY(four_bar_forward_dynamics_dense)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict inertia_, double *restrict load_, double *restrict closure_,
    double *restrict curvature_, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    (void)q;
    /* coupler: geometry */
    const REAL coupler_sin = SINES(sine, 1);
    const REAL crank_lever_moment_z_by_C_fx = B_at_z * coupler_sin;
    WRITE(closure_, 0, crank_lever_moment_z_by_C_fx);
    REAL checked0 = crank_lever_moment_z_by_C_fx;
    const REAL D_v = READ(v, 2);
    const REAL t25 = k6 * (D_v * D_v); /* rocker */
    const REAL rocker_cos = SINES(cosine, 2);
    const REAL t26 = rocker_cos * t25; /* rocker */
    const REAL minus_rocker_sin = SINES(sine, 2);
    const REAL t28 = minus_rocker_sin * t25; /* rocker */
    const REAL crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0);
    /* C: loop closure */
    const REAL t32 = crank_sin * t26;
    const REAL t30 = crank_cos * t26 - crank_sin * t28;
    const REAL t34 = t32 + crank_cos * t28;
    const REAL coupler_cos = SINES(cosine, 1), A_v = READ(v, 0);
    const REAL t41 = coupler_sin * t30 + coupler_cos * t34;
    const REAL t36 = coupler_cos * t30 - coupler_sin * t34;
    const REAL t7 = B_at_z * (A_v * A_v); /* crank */
    const REAL C_opening_bias_fy = coupler_sin * t7 - t41;
    WRITE(curvature_, 1, C_opening_bias_fy);
    REAL checked1 = C_opening_bias_fy;
    const REAL minus_coupler_acc_still_x = coupler_cos * t7;
    const REAL coupler_omega_z = A_v + READ(v, 1);
    const REAL minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z;
    const REAL C_opening_bias_fx = t36 - (minus_coupler_acc_still_x + 0.5 * minus_coupler_U_still_xx);
    WRITE(curvature_, 0, C_opening_bias_fx);
    REAL checked2 = C_opening_bias_fx;
    const REAL t11 = B_at_z * (coupler_sin * (coupler_com_z * minus_coupler_U_still_xx)); /* crank */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t21 = k6 * rocker_cos; /* rocker */
    const REAL t23 = minus_coupler_rotation_xy * t21;
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t22 = coupler_rotation_xx * t21;
    const REAL t17 = k6 * minus_rocker_sin; /* rocker */
    const REAL C_closure_fy_by_D = t23 + coupler_rotation_xx * t17;
    WRITE(closure_, 11, C_closure_fy_by_D);
    REAL checked3 = C_closure_fy_by_D;
    RESULT(checked0, closure_, 10, minus_coupler_rotation_xy * t17 - t22);
    RESULT(checked1, closure_, 1, 0.5 + B_at_z * coupler_cos);
    RESULT(checked2, load_, 2, -(gravity_z_rocker_mx * minus_rocker_sin));
    const REAL coupler_acc_still_y = coupler_sin * (t7 - gravity_z * crank_cos) - coupler_cos * (gravity_z * crank_sin);
    const REAL coupler_rate_moment_z = coupler_com_z * coupler_acc_still_y;
    RESULT(checked3, load_, 1, -coupler_rate_moment_z);
    RESULT(checked0, load_, 0, k10 * crank_sin - (coupler_rate_moment_z - t11) + READ(u, 0));
    const REAL A_mass_matrix_by_B = coupler_sxx + B_at_z_coupler_com_z * coupler_cos;
    WRITE(inertia_, 1, A_mass_matrix_by_B);
    WRITE(inertia_, 3, A_mass_matrix_by_B);
    checked1 = checked1 + A_mass_matrix_by_B;
    const REAL t3 = coupler_cos * (coupler_sxx * coupler_cos); /* coupler */
    RESULT(checked2, inertia_, 0, coupler_sxx - t3 + (k7 + (t3 + k9 * coupler_cos)));
    WRITE(inertia_, 2, CONSTANT(0.0));
    WRITE(inertia_, 4, CONSTANT(coupler_sxx));
    WRITE(inertia_, 5, CONSTANT(0.0));
    WRITE(inertia_, 6, CONSTANT(0.0));
    WRITE(inertia_, 7, CONSTANT(0.0));
    WRITE(inertia_, 8, CONSTANT(rocker_sxx));
    WRITE(closure_, 2, CONSTANT(0.0));
    WRITE(closure_, 3, CONSTANT(0.0));
    WRITE(closure_, 4, CONSTANT(0.0));
    WRITE(closure_, 5, CONSTANT(0.0));
    WRITE(closure_, 6, CONSTANT(0.5));
    WRITE(closure_, 7, CONSTANT(0.0));
    WRITE(closure_, 8, CONSTANT(0.0));
    WRITE(closure_, 9, CONSTANT(0.0));
    WRITE(closure_, 12, CONSTANT(0.0));
    WRITE(closure_, 13, CONSTANT(0.0));
    WRITE(closure_, 14, CONSTANT(0.0));
    WRITE(curvature_, 2, CONSTANT(0.0));
    WRITE(curvature_, 3, CONSTANT(0.0));
    WRITE(curvature_, 4, CONSTANT(0.0));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

static int four_bar_forward_dynamics_dense(const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict inertia_, double *restrict load_, double *restrict closure_,
    double *restrict curvature_)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_forward_dynamics_dense_body(1, q, v, u, inertia_, load_, closure_,
        curvature_, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(inertia_, 9);
        four_bar_set_nan(load_, 3);
        four_bar_set_nan(closure_, 15);
        four_bar_set_nan(curvature_, 5);
    }
    return outcome;
}

static int four_bar_forward_dynamics_rank_revealing(const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a)
{
    static const double rate_scale[3] = {1.0, 1.0, 1.0};
    static const double row_scale[5] = {3.3146717314850727, 3.3146717314850727, 3.3146717314850727, 1.0, 1.0};
    double inertia[9], load[3], closure[15], curvature[5];
    double turn[9], work[18], multipliers[5];
    (void)four_bar_forward_dynamics_dense(q, v, u, inertia, load, closure, curvature);
    for (int j = 0; j < 3; ++j) {
        load[j] *= rate_scale[j];
        for (int i = 0; i < 3; ++i) {
            inertia[i + j * 3] *= rate_scale[i] * rate_scale[j];
        }
        for (int i = 0; i < 5; ++i) {
            closure[i + j * 5] *= row_scale[i] * rate_scale[j];
        }
    }
    for (int i = 0; i < 5; ++i) {
        curvature[i] *= row_scale[i];
    }
    const int rank = four_bar_constrained(3, 5, inertia, load, closure, curvature, turn, work, a, multipliers);
    double total = four_bar_dot(3, a, a);
    for (int j = 0; j < 3; ++j) {
        a[j] *= rate_scale[j];
    }
    if (rank < 0 || !isfinite(total)) {
        four_bar_set_nan(a, 3);
        return isfinite(total) ? 1 : 2;
    }
    return rank == 2 ? -1 : -2;
}

int four_bar_forward_dynamics(const double *restrict q, const double *restrict v, const double *restrict u,
    double *restrict a)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_forward_dynamics_body(1, q, v, u, a, sine, cosine, NULL);
    if (outcome == 1) {
        return four_bar_forward_dynamics_rank_revealing(q, v, u, a);
    }
    if (outcome != 0) {
        four_bar_set_nan(a, 3);
    }
    return outcome;
}

int four_bar_forward_dynamics_independent(const double *restrict q, const double *restrict y_dot,
    const double *restrict u, double *restrict y_ddot)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_forward_dynamics_independent_body(1, q, y_dot, u, y_ddot, sine, cosine,
        NULL);
    if (outcome != 0) {
        four_bar_set_nan(y_ddot, 1);
    }
    return outcome;
}


BODY(four_bar_forward_dynamics_reactions_wrenches)(size_t stride, const double *restrict q,
    const double *restrict v, const double *restrict u, const double *restrict a,
    const double *restrict multipliers_, double *restrict reactions, double *restrict sized_,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    REAL checked0 = READ(u, 0);
    /* mechanism: reactions, eq. (32) */
    const REAL multipliers_2 = READ(multipliers_, 2);
    WRITE(reactions, 19, multipliers_2);
    WRITE(sized_, 20, multipliers_2);
    /* C: reactions, eq. (32) */
    const REAL C_joint_reaction_force_z = -multipliers_2;
    WRITE(reactions, 1, C_joint_reaction_force_z);
    WRITE(reactions, 7, C_joint_reaction_force_z);
    WRITE(reactions, 13, C_joint_reaction_force_z);
    WRITE(sized_, 2, C_joint_reaction_force_z);
    WRITE(sized_, 8, C_joint_reaction_force_z);
    WRITE(sized_, 14, C_joint_reaction_force_z);
    REAL checked1 = C_joint_reaction_force_z;
    const REAL multipliers_0 = READ(multipliers_, 0);
    const REAL C_joint_reaction_force_x = -multipliers_0;
    WRITE(sized_, 12, C_joint_reaction_force_x);
    REAL checked2 = C_joint_reaction_force_x;
    const REAL multipliers_1 = READ(multipliers_, 1);
    const REAL C_joint_reaction_force_y = -multipliers_1;
    WRITE(sized_, 13, C_joint_reaction_force_y);
    REAL checked3 = C_joint_reaction_force_y;
    const REAL A_v = READ(v, 0);
    const REAL minus_crank_U_still_xx = A_v * A_v;
    const REAL crank_cos = SINES(cosine, 0);
    const REAL t2 = crank_mx * minus_crank_U_still_xx; /* crank */
    const REAL t5 = B_at_z * minus_crank_U_still_xx - gravity_z * crank_cos; /* crank */
    /* coupler: geometry; accelerations; momentum rate, eq. (35) */
    const REAL coupler_cos = SINES(cosine, 1), coupler_sin = SINES(sine, 1), A_a = READ(a, 0);
    const REAL crank_sin = SINES(sine, 0);
    const REAL t6 = coupler_cos * t5;
    const REAL t12 = coupler_sin * t5;
    const REAL t8 = B_at_z * A_a - gravity_z * crank_sin;
    const REAL t10 = rocker_m * (t6 - coupler_sin * t8);
    const REAL t14 = rocker_m * (t12 + coupler_cos * t8);
    const REAL coupler_omega_z = A_v + READ(v, 1);
    /* coupler: balance, eqs. (40)-(47) */
    const REAL minus_coupler_sent_force_x = coupler_com_z * (coupler_omega_z * coupler_omega_z) + t10 + multipliers_0;
    const REAL t11 = coupler_cos * minus_coupler_sent_force_x;
    const REAL t19 = coupler_sin * minus_coupler_sent_force_x;
    const REAL coupler_sent_force_y = coupler_com_z * (A_a + READ(a, 1)) + t14 - multipliers_1;
    const REAL minus_coupler_joint_sent_force_x = t11 + coupler_sin * coupler_sent_force_y;
    const REAL minus_coupler_joint_sent_force_y = t19 - coupler_cos * coupler_sent_force_y;
    RESULT(checked0, sized_, 6, -minus_coupler_joint_sent_force_x);
    RESULT(checked1, sized_, 7, -minus_coupler_joint_sent_force_y);
    /* crank: balance, eqs. (40)-(47) */
    const REAL crank_sent_force_x = crank_m_gravity_z * crank_cos - t2 - minus_coupler_joint_sent_force_x;
    const REAL t16 = crank_sin * crank_sent_force_x;
    const REAL t22 = crank_cos * crank_sent_force_x;
    const REAL minus_crank_sent_force_y = crank_m_gravity_z * crank_sin - crank_mx * A_a + minus_coupler_joint_sent_force_y;
    const REAL crank_joint_sent_force_y = t16 - crank_cos * minus_crank_sent_force_y;
    WRITE(reactions, 0, crank_joint_sent_force_y);
    WRITE(sized_, 1, crank_joint_sent_force_y);
    checked2 = checked2 + crank_joint_sent_force_y;
    const REAL crank_joint_sent_force_x = t22 + crank_sin * minus_crank_sent_force_y;
    WRITE(reactions, 2, crank_joint_sent_force_x);
    WRITE(sized_, 0, crank_joint_sent_force_x);
    checked3 = checked3 + crank_joint_sent_force_x;
    const REAL multipliers_4 = READ(multipliers_, 4);
    const REAL minus_coupler_sent_moment_y = multipliers_4 - 0.5 * multipliers_2;
    const REAL multipliers_3 = READ(multipliers_, 3);
    const REAL t29 = coupler_cos * minus_coupler_sent_moment_y; /* coupler */
    const REAL t26 = coupler_sin * minus_coupler_sent_moment_y; /* coupler */
    const REAL t28 = coupler_sin * multipliers_3; /* coupler */
    const REAL minus_coupler_joint_sent_moment_y = t28 + t29;
    const REAL minus_crank_sent_moment_y = minus_coupler_joint_sent_moment_y - B_at_z * multipliers_2;
    const REAL t31 = crank_cos * minus_crank_sent_moment_y;
    const REAL t33 = crank_sin * minus_crank_sent_moment_y;
    const REAL t24 = coupler_cos * multipliers_3; /* coupler */
    const REAL minus_coupler_joint_sent_moment_x = t24 - t26;
    const REAL t27 = crank_sin * minus_coupler_joint_sent_moment_x;
    const REAL minus_crank_joint_sent_moment_y = t27 + t31;
    RESULT(checked0, reactions, 3, -minus_crank_joint_sent_moment_y);
    RESULT(checked1, sized_, 4, -(per_length * minus_crank_joint_sent_moment_y));
    const REAL t32 = crank_cos * minus_coupler_joint_sent_moment_x;
    const REAL minus_crank_joint_sent_moment_x = t32 - t33;
    RESULT(checked2, reactions, 5, -minus_crank_joint_sent_moment_x);
    RESULT(checked3, sized_, 3, -(per_length * minus_crank_joint_sent_moment_x));
    RESULT(checked0, sized_, 9, -(per_length * minus_coupler_joint_sent_moment_x));
    /* B: reactions, eq. (32) */
    const REAL t37 = crank_cos * minus_coupler_joint_sent_force_x;
    const REAL t36 = crank_sin * minus_coupler_joint_sent_force_x + crank_cos * minus_coupler_joint_sent_force_y;
    RESULT(checked1, reactions, 6, -t36);
    const REAL t39 = t37 - crank_sin * minus_coupler_joint_sent_force_y;
    RESULT(checked2, reactions, 8, -t39);
    const REAL t42 = t27 + crank_cos * minus_coupler_joint_sent_moment_y;
    const REAL coupler_position_z = B_at_z * crank_cos;
    const REAL t44 = coupler_position_z * t36;
    RESULT(checked3, reactions, 9, coupler_position_z * multipliers_2 - t42);
    const REAL coupler_position_x = B_at_z * crank_sin;
    RESULT(checked0, reactions, 10, coupler_position_x * t39 - t44);
    const REAL t46 = t32 - crank_sin * minus_coupler_joint_sent_moment_y;
    RESULT(checked1, sized_, 10, -(per_length * minus_coupler_joint_sent_moment_y));
    RESULT(checked2, reactions, 11, -(t46 + coupler_position_x * multipliers_2));
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    /* C: reactions, eq. (32) */
    const REAL t51 = coupler_rotation_xx * multipliers_0;
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t55 = t51 - minus_coupler_rotation_xy * multipliers_1;
    RESULT(checked3, reactions, 12, -t55);
    const REAL t59 = coupler_position_z - 0.5 * minus_coupler_rotation_xy; /* coupler */
    const REAL t64 = t59 * t55;
    const REAL t60 = t59 * multipliers_2;
    RESULT(checked0, reactions, 15, t60 - (coupler_rotation_xx * multipliers_3 - minus_coupler_rotation_xy * multipliers_4));
    const REAL t66 = coupler_position_x + 0.5 * coupler_rotation_xx; /* coupler */
    const REAL t69 = minus_coupler_rotation_xy * multipliers_3;
    const REAL C_reactions_fz = minus_coupler_rotation_xy * multipliers_0 + coupler_rotation_xx * multipliers_1;
    WRITE(reactions, 14, C_reactions_fz);
    RESULT(checked1, reactions, 16, -(t64 + t66 * C_reactions_fz));
    RESULT(checked2, reactions, 17, t69 + coupler_rotation_xx * multipliers_4 - t66 * multipliers_2);
    const REAL D_v = READ(v, 2);
    /* rocker: geometry; momentum rate, eq. (35) */
    const REAL rocker_cos = SINES(cosine, 2);
    const REAL minus_rocker_rate_force_x_2 = rocker_mx * (D_v * D_v) - rocker_m_gravity_z * rocker_cos;
    const REAL minus_rocker_sin = SINES(sine, 2);
    /* rocker: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t75 = minus_rocker_sin * minus_rocker_rate_force_x_2;
    const REAL t88 = rocker_cos * minus_rocker_rate_force_x_2;
    const REAL rocker_rate_force_y_2 = rocker_mx * READ(a, 2) + rocker_m_gravity_z * minus_rocker_sin;
    const REAL t78 = t75 + rocker_cos * rocker_rate_force_y_2;
    const REAL t90 = t88 - minus_rocker_sin * rocker_rate_force_y_2;
    const REAL t81 = coupler_cos * multipliers_0 - coupler_sin * multipliers_1;
    const REAL t82 = crank_sin * t81;
    const REAL t91 = crank_cos * t81;
    const REAL t85 = coupler_sin * multipliers_0 + coupler_cos * multipliers_1;
    const REAL rocker_joint_sent_force_y = t78 + (t82 + crank_cos * t85);
    WRITE(reactions, 18, rocker_joint_sent_force_y);
    WRITE(sized_, 19, rocker_joint_sent_force_y);
    checked3 = checked3 + rocker_joint_sent_force_y;
    const REAL minus_rocker_joint_sent_force_x = t90 - (t91 - crank_sin * t85);
    const REAL rocker_joint_sent_force_x = -minus_rocker_joint_sent_force_x;
    WRITE(reactions, 20, rocker_joint_sent_force_x);
    WRITE(sized_, 18, rocker_joint_sent_force_x);
    checked0 = checked0 + rocker_joint_sent_force_x;
    RESULT(checked1, reactions, 22, D_at_x * minus_rocker_joint_sent_force_x);
    const REAL t95 = t24 - coupler_sin * multipliers_4;
    const REAL t103 = crank_cos * t95;
    const REAL t96 = crank_sin * t95;
    const REAL t98 = t28 + coupler_cos * multipliers_4;
    const REAL t100 = t96 + crank_cos * t98;
    const REAL rocker_joint_sent_moment_x = t103 - crank_sin * t98 - k6 * minus_rocker_sin * multipliers_2;
    RESULT(checked2, sized_, 21, per_length * rocker_joint_sent_moment_x);
    RESULT(checked3, reactions, 23, rocker_joint_sent_moment_x + D_at_x * multipliers_2);
    RESULT(checked0, sized_, 15, -(per_length * multipliers_3));
    RESULT(checked1, sized_, 16, -(per_length * multipliers_4));
    const REAL rocker_joint_sent_moment_y = t100 - k6 * rocker_cos * multipliers_2;
    WRITE(reactions, 21, rocker_joint_sent_moment_y);
    RESULT(checked2, sized_, 22, per_length * rocker_joint_sent_moment_y);
    WRITE(reactions, 4, CONSTANT(0.0));
    WRITE(sized_, 5, CONSTANT(0.0));
    WRITE(sized_, 11, CONSTANT(0.0));
    WRITE(sized_, 17, CONSTANT(0.0));
    WRITE(sized_, 23, CONSTANT(0.0));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

static int four_bar_forward_dynamics_reactions_wrenches(const double *restrict q, const double *restrict v,
    const double *restrict u, const double *restrict a, const double *restrict multipliers_,
    double *restrict reactions, double *restrict sized_)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_forward_dynamics_reactions_wrenches_body(1, q, v, u, a, multipliers_,
        reactions, sized_, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(reactions, 24);
        four_bar_set_nan(sized_, 24);
    }
    return outcome;
}

static int four_bar_forward_dynamics_reactions_rank_revealing(const double *restrict q,
    const double *restrict v, const double *restrict u, double *restrict a, double *restrict reactions)
{
    static const double rate_scale[3] = {1.0, 1.0, 1.0};
    static const double row_scale[5] = {3.3146717314850727, 3.3146717314850727, 3.3146717314850727, 1.0, 1.0};
    double inertia[9], load[3], closure[15], curvature[5];
    double turn[9], work[18], multipliers[5];
    (void)four_bar_forward_dynamics_dense(q, v, u, inertia, load, closure, curvature);
    for (int j = 0; j < 3; ++j) {
        load[j] *= rate_scale[j];
        for (int i = 0; i < 3; ++i) {
            inertia[i + j * 3] *= rate_scale[i] * rate_scale[j];
        }
        for (int i = 0; i < 5; ++i) {
            closure[i + j * 5] *= row_scale[i] * rate_scale[j];
        }
    }
    for (int i = 0; i < 5; ++i) {
        curvature[i] *= row_scale[i];
    }
    const int rank = four_bar_constrained(3, 5, inertia, load, closure, curvature, turn, work, a, multipliers);
    double total = four_bar_dot(3, a, a);
    for (int j = 0; j < 3; ++j) {
        a[j] *= rate_scale[j];
    }
    double sized[24], shifted[24], loads[25] = {0.0}, columns[120] = {0.0};
    double mix[25] = {0.0}, amount[5] = {0.0};
    for (int i = 0; i < 5; ++i) {
        multipliers[i] *= row_scale[i];
    }
    (void)four_bar_forward_dynamics_reactions_wrenches(q, v, u, a, multipliers, reactions, sized);
    const int internal = 5 - (rank > 0 ? rank : 0);
    for (int k = 0; k < internal && rank >= 0; ++k) {
        double moved[5];
        four_bar_internal_load(3, 5, closure, k, loads);
        for (int i = 0; i < 5; ++i) {
            moved[i] = multipliers[i] + row_scale[i] * loads[i + k * 5];
        }
        (void)four_bar_forward_dynamics_reactions_wrenches(q, v, u, a, moved, shifted, columns + k * 24);
        for (int i = 0; i < 24; ++i) {
            columns[i + k * 24] -= sized[i];
        }
    }
    four_bar_orthogonalise(24, internal, columns, mix);
    double largest = 0.0;
    for (int k = 0; k < internal; ++k) {
        const double part = four_bar_dot(24, columns + k * 24, columns + k * 24);
        largest = part > largest ? part : largest;
        amount[k] = 0.0;
    }
    for (int k = 0; k < internal; ++k) {
        const double part = four_bar_dot(24, columns + k * 24, columns + k * 24);
        if (part > 1.0e-18 * largest) {
            const double factor = -four_bar_dot(24, columns + k * 24, sized) / part;
            for (int i = 0; i < internal; ++i) {
                amount[i] += factor * mix[i + k * internal];
            }
        }
    }
    for (int k = 0; k < internal; ++k) {
        for (int i = 0; i < 5; ++i) {
            multipliers[i] += amount[k] * row_scale[i] * loads[i + k * 5];
        }
    }
    (void)four_bar_forward_dynamics_reactions_wrenches(q, v, u, a, multipliers, reactions, sized);
    total += four_bar_dot(24, reactions, reactions);
    if (rank < 0 || !isfinite(total)) {
        four_bar_set_nan(a, 3);
        four_bar_set_nan(reactions, 24);
        return isfinite(total) ? 1 : 2;
    }
    return rank == 2 ? -1 : -2;
}

int four_bar_forward_dynamics_reactions(const double *restrict q, const double *restrict v,
    const double *restrict u, double *restrict a, double *restrict reactions)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_forward_dynamics_reactions_body(1, q, v, u, a, reactions, sine, cosine,
        NULL);
    if (outcome == 1) {
        return four_bar_forward_dynamics_reactions_rank_revealing(q, v, u, a, reactions);
    }
    if (outcome != 0) {
        four_bar_set_nan(a, 3);
        four_bar_set_nan(reactions, 24);
    }
    return outcome;
}
#endif /* FOUR_BAR_VECTORS */
