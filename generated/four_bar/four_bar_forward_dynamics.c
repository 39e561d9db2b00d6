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
    /* D: accelerations */
    const REAL D_v = READ(v, 2), t11 = k6 * (D_v * D_v), /* rocker */
      rocker_cos = SINES(cosine, 2), t12 = rocker_cos * t11, /* rocker */
      minus_rocker_sin = SINES(sine, 2), t14 = minus_rocker_sin * t11, /* rocker */
      crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0), t21 = crank_cos * t12 - crank_sin * t14, /* C */
      t16 = crank_sin * t12 + crank_cos * t14, /* C */
      A_v = READ(v, 0), t18 = B_at_z * (A_v * A_v), /* crank */
      t22 = t18 - t21, /* C */
      coupler_cos = SINES(cosine, 1), coupler_sin = SINES(sine, 1),
      t24 = coupler_sin * t16 + coupler_cos * t22, /* C */
      t38 = coupler_cos * t16 - coupler_sin * t22, /* coupler */
      coupler_omega_z = A_v + READ(v, 1), minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z,
      minus_C_opening_bias_fx = 0.5 * minus_coupler_U_still_xx + t24,
      minus_crank_force_y = coupler_sin * (k11 * minus_coupler_U_still_xx),
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos,
      t5 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t28 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin,
      minus_C_closure_fx_by_D = t5 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t28 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      t9 = 1.0 / minus_C_closure_fx_by_D, /* C */
      minus_D_joint_acc_still = t9 * minus_C_opening_bias_fx,
      t39 = C_closure_fy_by_D * minus_D_joint_acc_still + t38, /* coupler */
      t43 = B_at_z * (minus_crank_force_y - coupler_cos * (k2 * t39)), /* crank */
      t40 = coupler_com_x * t39, /* coupler */
      B_joint_acc_still = 2.0 * t39,
      coupler_acc_still_y = coupler_sin * (t18 - gravity_z * crank_cos) - coupler_cos * (gravity_z * crank_sin),
      coupler_rate_mz_2 = k11 * coupler_acc_still_y + t40;
    /* A: free motion; inertia; accelerations */
    const REAL t46 = READ(u, 0) + (k14 * crank_sin - (coupler_rate_mz_2 - t43)),
      D_null_space_by_A = B_at_z * coupler_sin * t9,
      t31 = 0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A, /* B */
      minus_B_null_space_by_A = 2.0 * t31, t47 = minus_B_null_space_by_A * coupler_rate_mz_2 + t46,
      t51 = coupler_com_x * t31, /* B */
      t26 = D_null_space_by_A * (gravity_z_rocker_mx * minus_rocker_sin - rocker_sxx * minus_D_joint_acc_still),
      minus_A_reduced_force = t26 - t47, A_mass_matrix_by_B = coupler_sxx + k13 * coupler_cos,
      t54 = minus_B_null_space_by_A * (A_mass_matrix_by_B + (A_mass_matrix_by_B - t51)),
      A_reduced_inertia_by_A = D_null_space_by_A * (rocker_sxx * D_null_space_by_A) - (t54 - (k9 * coupler_cos +
          k12));
    REAL checked1 = A_reduced_inertia_by_A;
    const REAL minus_A_joint_acc = minus_A_reduced_force / A_reduced_inertia_by_A;
    WRITE(a, 0, -minus_A_joint_acc);
    const REAL B_joint_acc = B_joint_acc_still + minus_B_null_space_by_A * minus_A_joint_acc;
    WRITE(a, 1, B_joint_acc);
    REAL checked2 = B_joint_acc;
    const REAL minus_D_joint_acc = minus_D_joint_acc_still + D_null_space_by_A * minus_A_joint_acc;
    REAL checked3 = minus_D_joint_acc;
    WRITE(a, 2, -minus_D_joint_acc);
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
    /* crank: geometry; reciprocal wrenches, eq. (10); loop closure */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1), coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      rocker_cos = SINES(cosine, 2), minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos,
      t5 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      minus_rocker_sin = SINES(sine, 2),
      t12 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin,
      minus_C_closure_fx_by_D = t5 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL C_closure_fy_by_D = t12 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      t9 = 1.0 / minus_C_closure_fx_by_D, /* C */
      crank_lever_mz_by_C_fx = B_at_z * coupler_sin, A_y_dot = READ(y_dot, 0),
      D_joint_rate = crank_lever_mz_by_C_fx * A_y_dot * t9, D_null_space_by_A = crank_lever_mz_by_C_fx * t9,
      t18 = k6 * (D_joint_rate * D_joint_rate), /* rocker */
      t15 = C_closure_fy_by_D * D_joint_rate, /* B */
      t19 = rocker_cos * t18, /* rocker */
      t21 = minus_rocker_sin * t18, /* rocker */
      t28 = crank_cos * t19 - crank_sin * t21, /* C */
      t23 = crank_sin * t19 + crank_cos * t21, /* C */
      t25 = B_at_z * (A_y_dot * A_y_dot), t29 = t25 - t28, /* C */
      t31 = coupler_sin * t23 + coupler_cos * t29, /* C */
      t42 = coupler_cos * t23 - coupler_sin * t29, /* coupler */
      crank_lever_mz_by_C_fy = 0.5 + B_at_z * coupler_cos,
      coupler_omega_z = A_y_dot - 2.0 * (crank_lever_mz_by_C_fy * A_y_dot + t15),
      minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z,
      minus_D_joint_acc_still = t9 * (0.5 * minus_coupler_U_still_xx + t31),
      minus_crank_force_y = coupler_sin * (k11 * minus_coupler_U_still_xx),
      t43 = C_closure_fy_by_D * minus_D_joint_acc_still + t42, /* coupler */
      t35 = crank_lever_mz_by_C_fy + C_closure_fy_by_D * D_null_space_by_A, /* B */
      t32 = rocker_sxx * minus_D_joint_acc_still, /* D */
      t47 = B_at_z * (minus_crank_force_y - coupler_cos * (k2 * t43)), t44 = coupler_com_x * t43, /* coupler */
      minus_coupler_acc_y = coupler_cos * (gravity_z * crank_sin) + coupler_sin * (gravity_z * crank_cos - t25),
      minus_coupler_rate_mz_2 = k11 * minus_coupler_acc_y - t44;
    /* A: free motion; inertia; accelerations */
    const REAL t50 = READ(u, 0) + (k14 * crank_sin + (minus_coupler_rate_mz_2 + t47)),
      minus_B_null_space_by_A = 2.0 * t35, t51 = minus_B_null_space_by_A * minus_coupler_rate_mz_2 - t50,
      t55 = coupler_com_x * t35, /* B */
      A_reduced_force = (t32 - gravity_z_rocker_mx * minus_rocker_sin) * D_null_space_by_A - t51,
      A_mass_matrix_by_B = coupler_sxx + k13 * coupler_cos,
      t58 = minus_B_null_space_by_A * (A_mass_matrix_by_B + (A_mass_matrix_by_B - t55)),
      A_reduced_inertia_by_A = D_null_space_by_A * (rocker_sxx * D_null_space_by_A) - (t58 - (k9 * coupler_cos +
          k12));
    REAL checked1 = A_reduced_inertia_by_A;
    const REAL A_joint_acc = A_reduced_force * (1.0 / A_reduced_inertia_by_A);
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
    const REAL D_v = READ(v, 2), minus_rocker_U_still_xx = D_v * D_v,
      t11 = k6 * minus_rocker_U_still_xx, /* rocker */
      rocker_cos = SINES(cosine, 2), minus_rocker_rate_fx = rocker_mx * minus_rocker_U_still_xx,
      t12 = rocker_cos * t11, /* rocker */
      minus_rocker_sin = SINES(sine, 2), t14 = minus_rocker_sin * t11, /* rocker */
      crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0), t21 = crank_cos * t12 - crank_sin * t14, /* C */
      t16 = crank_sin * t12 + crank_cos * t14, /* C */
      A_v = READ(v, 0), minus_crank_U_still_xx = A_v * A_v, t18 = B_at_z * minus_crank_U_still_xx, /* crank */
      t22 = t18 - t21, /* C */
      coupler_cos = SINES(cosine, 1), coupler_sin = SINES(sine, 1),
      t61 = crank_mx * minus_crank_U_still_xx, /* crank */
      t24 = coupler_sin * t16 + coupler_cos * t22, /* C */
      t38 = coupler_cos * t16 - coupler_sin * t22, /* coupler */
      coupler_omega_z = A_v + READ(v, 1), minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z,
      minus_C_opening_bias_fx = 0.5 * minus_coupler_U_still_xx + t24,
      minus_coupler_rate_fx = k11 * minus_coupler_U_still_xx,
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos,
      t5 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t28 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin,
      minus_C_closure_fx_by_D = t5 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL t9 = 1.0 / minus_C_closure_fx_by_D, /* C */
      minus_D_joint_acc_still = t9 * minus_C_opening_bias_fx,
      C_closure_fy_by_D = t28 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      t39 = C_closure_fy_by_D * minus_D_joint_acc_still + t38, /* coupler */
      t42 = coupler_cos * (k2 * t39), /* coupler */
      minus_crank_force_y = coupler_sin * minus_coupler_rate_fx,
      t43 = B_at_z * (minus_crank_force_y - t42), /* crank */
      t40 = coupler_com_x * t39, /* coupler */
      B_joint_acc_still = 2.0 * t39, t32 = t18 - gravity_z * crank_cos, /* crank */
      t33 = coupler_sin * t32, /* coupler */
      t75 = coupler_cos * t32, /* coupler */
      minus_crank_acc_y = gravity_z * crank_sin,
      coupler_rate_mz_2 = k11 * (t33 - coupler_cos * minus_crank_acc_y) + t40,
      t44 = coupler_rate_mz_2 - t43, /* A */
      minus_crank_rate_mz = k14 * crank_sin, A_u = READ(u, 0), t46 = A_u + (minus_crank_rate_mz - t44), /* A */
      crank_lever_mz_by_C_fx = B_at_z * coupler_sin, D_null_space_by_A = crank_lever_mz_by_C_fx * t9,
      t31 = 0.5 + B_at_z * coupler_cos + C_closure_fy_by_D * D_null_space_by_A, /* B */
      minus_B_null_space_by_A = 2.0 * t31;
    /* A: free motion; inertia; accelerations */
    const REAL t47 = minus_B_null_space_by_A * coupler_rate_mz_2 + t46, t51 = coupler_com_x * t31, /* B */
      t26 = D_null_space_by_A * (gravity_z_rocker_mx * minus_rocker_sin - rocker_sxx * minus_D_joint_acc_still),
      minus_A_reduced_force = t26 - t47, A_mass_matrix_by_B = coupler_sxx + k13 * coupler_cos,
      t54 = minus_B_null_space_by_A * (A_mass_matrix_by_B + (A_mass_matrix_by_B - t51)),
      A_reduced_inertia_by_A = D_null_space_by_A * (rocker_sxx * D_null_space_by_A) - (t54 - (k9 * coupler_cos +
          k12));
    REAL checked1 = A_reduced_inertia_by_A;
    const REAL minus_A_joint_acc = minus_A_reduced_force / A_reduced_inertia_by_A;
    WRITE(a, 0, -minus_A_joint_acc);
    const REAL minus_D_joint_acc = minus_D_joint_acc_still + D_null_space_by_A * minus_A_joint_acc;
    WRITE(a, 2, -minus_D_joint_acc);
    const REAL B_joint_acc = B_joint_acc_still + minus_B_null_space_by_A * minus_A_joint_acc;
    WRITE(a, 1, B_joint_acc);
    const REAL minus_coupler_alpha_z = minus_A_joint_acc - B_joint_acc,
      minus_rocker_rate_fy = rocker_mx * minus_D_joint_acc,
      t64 = minus_crank_acc_y + B_at_z * minus_A_joint_acc, /* coupler */
      coupler_acc_y = t33 - coupler_cos * t64,
      t78 = minus_coupler_rate_fx + rocker_m * (t75 + coupler_sin * t64), /* coupler */
      t80 = rocker_m * coupler_acc_y, /* coupler */
      minus_C_multiplier_fy = 2.0 * (coupler_sxx * minus_coupler_alpha_z - k11 * coupler_acc_y),
      minus_coupler_rate_fy = k11 * minus_coupler_alpha_z,
      t69 = minus_crank_force_y + coupler_cos * minus_coupler_rate_fy, /* crank */
      coupler_sent_fy = minus_C_multiplier_fy - (minus_coupler_rate_fy - t80),
      t67 = coupler_cos * minus_C_multiplier_fy, /* crank */
      t74 = A_u - (B_at_z * (t67 - t69) - (minus_crank_rate_mz + k8 * minus_A_joint_acc)), /* C */
      minus_C_multiplier_fx = t74 / crank_lever_mz_by_C_fx, coupler_sent_fx = minus_C_multiplier_fx - t78,
      t87 = crank_mx * minus_A_joint_acc, t84 = coupler_sin * coupler_sent_fx, /* coupler */
      coupler_joint_sent_fx = coupler_cos * coupler_sent_fx - coupler_sin * coupler_sent_fy,
      coupler_joint_sent_fy = t84 + coupler_cos * coupler_sent_fy;
    /* crank: balance, eqs. (40)-(47) */
    const REAL crank_sent_fx = crank_m_gravity_z * crank_cos - t61 + coupler_joint_sent_fx,
      t83 = crank_sin * crank_sent_fx, t90 = crank_cos * crank_sent_fx,
      crank_sent_fy = coupler_joint_sent_fy - (crank_m_gravity_z * crank_sin + t87),
      crank_joint_sent_fy = t83 + crank_cos * crank_sent_fy;
    WRITE(reactions, 0, crank_joint_sent_fy);
    REAL checked2 = crank_joint_sent_fy;
    const REAL crank_joint_sent_fx = t90 - crank_sin * crank_sent_fy;
    WRITE(reactions, 2, crank_joint_sent_fx);
    REAL checked3 = crank_joint_sent_fx;
    const REAL t94 = crank_cos * coupler_joint_sent_fx, /* B */
      B_reaction_fx = crank_sin * coupler_joint_sent_fx + crank_cos * coupler_joint_sent_fy;
    WRITE(reactions, 6, B_reaction_fx);
    const REAL B_reaction_fz = t94 - crank_sin * coupler_joint_sent_fy;
    WRITE(reactions, 8, B_reaction_fz);
    const REAL coupler_position_z = B_at_z * crank_cos, t96 = coupler_position_z * B_reaction_fx, /* B */
      coupler_position_x = B_at_z * crank_sin;
    RESULT(checked0, reactions, 10, t96 - coupler_position_x * B_reaction_fz);
    const REAL minus_C_reaction_fz = minus_coupler_rotation_xy * minus_C_multiplier_fx + coupler_rotation_xx *
        minus_C_multiplier_fy;
    WRITE(reactions, 14, -minus_C_reaction_fz);
    const REAL C_reaction_fx = coupler_rotation_xx * minus_C_multiplier_fx - minus_coupler_rotation_xy *
        minus_C_multiplier_fy;
    WRITE(reactions, 12, C_reaction_fx);
    /* rocker: balance, eqs. (40)-(47); momentum rate, eq. (35); pivots */
    const REAL t113 = coupler_sin * minus_C_multiplier_fy,
      t104 = (coupler_position_z - 0.5 * minus_coupler_rotation_xy) * C_reaction_fx, /* C */
      t150 = per_length * minus_coupler_rotation_xy; /* coupler */
    RESULT(checked1, reactions, 16, t104 + (coupler_position_x + 0.5 * coupler_rotation_xx) * minus_C_reaction_fz);
    const REAL t153 = per_length * coupler_rotation_xx, /* coupler */
      t115 = t113 - coupler_cos * minus_C_multiplier_fx, t118 = t67 + coupler_sin * minus_C_multiplier_fx,
      t120 = crank_sin * t115 - crank_cos * t118, t126 = crank_cos * t115 + crank_sin * t118,
      rocker_rate_fy = rocker_m_gravity_z * minus_rocker_sin - minus_rocker_rate_fy,
      t111 = rocker_cos * rocker_rate_fy, t122 = minus_rocker_sin * rocker_rate_fy,
      minus_rocker_rate_fx_2 = minus_rocker_rate_fx - rocker_m_gravity_z * rocker_cos;
    RESULT(checked2, reactions, 18, minus_rocker_sin * minus_rocker_rate_fx_2 + t111 + t120);
    const REAL minus_rocker_joint_sent_fx = rocker_cos * minus_rocker_rate_fx_2 - t122 - t126;
    WRITE(reactions, 20, -minus_rocker_joint_sent_fx);
    RESULT(checked3, reactions, 22, D_at_x * minus_rocker_joint_sent_fx);
    const REAL t127 = per_length_crank_m * coupler_sin, /* coupler */
      t129 = 2.0 + t127 * t127, /* coupler */
      t130 = per_length_crank_m * coupler_cos, /* coupler */
      t133 = 1.0 + (t129 + t130 * t130), /* coupler */
      t134 = k15 * minus_rocker_sin, t136 = t133 + t134 * t134, /* mechanism */
      t137 = k15 * rocker_cos, t140 = 1.0 + (t136 + t137 * t137), /* mechanism */
      minus_crank_lever_my_by_C_fz = B_at_z + 0.5 * coupler_cos,
      t142 = crank_sin * minus_crank_lever_my_by_C_fz, /* crank */
      t147 = crank_cos * minus_crank_lever_my_by_C_fz, /* crank */
      crank_lever_mx_by_C_fz = 0.5 * coupler_sin,
      t143 = per_length * (crank_cos * crank_lever_mx_by_C_fz + t142), /* base */
      t148 = per_length * (crank_sin * crank_lever_mx_by_C_fz - t147); /* base */
    /* mechanism: pivots */
    const REAL t151 = t134 - t143, t145 = t140 + t143 * t143, t154 = t137 - t148, pivot_0 = t145 + t148 * t148;
    checked0 = checked0 + pivot_0;
    const REAL t157 = 1.0 / pivot_0, t178 = t153 * t151, t156 = t150 * t151 - t153 * t154, t174 = t150 * t154,
      t169 = 2.0 * (t150 * t150 + t153 * t153), /* coupler */
      t159 = t156 * (t157 * t156), t160 = per_length * coupler_cos, /* coupler */
      t176 = t130 * t160, /* coupler */
      t161 = t160 * t160, /* coupler */
      t162 = per_length_squared + t161, /* coupler */
      t163 = per_length * coupler_sin, /* coupler */
      t180 = t174 - (t127 * t163 + t176 - t178), t164 = t163 * t163, /* coupler */
      minus_pivot_1 = t159 - (t162 + t164 + t169);
    checked1 = checked1 + minus_pivot_1;
    const REAL t181 = t157 * t180, t183 = t156 * t181, t186 = t180 * t181 - t183 * (t183 / minus_pivot_1),
      pivot_2 = t161 + (per_length_squared + t164) + t169 - t186;
    checked2 = checked2 + pivot_2;
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
        SMALL(minus_C_closure_fx_by_D, 3.01689e-06) OR /* where D does not move the loop at C */
        SMALL(A_reduced_inertia_by_A, 3.264600000000001e-07) OR /* where A feels no inertia */
        SMALL(crank_lever_mz_by_C_fx, 1.2634000000000003e-06) OR
            /* where the reciprocal wrench C.fx has no power along crank, as in a stretched limb */
        SMALL(pivot_0, 0.0001379) OR
            /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(minus_pivot_1, 0.00043948) OR
            /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(pivot_2, 0.00043948),
            /* where step 2 of symmetric equations loses rank: of drives, inertia or internal loads */
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
    const REAL coupler_sin = SINES(sine, 1), crank_lever_mz_by_C_fx = B_at_z * coupler_sin;
    WRITE(closure_, 0, crank_lever_mz_by_C_fx);
    REAL checked0 = crank_lever_mz_by_C_fx;
    /* rocker: geometry; momentum rate, eq. (35); loop closure */
    const REAL minus_rocker_sin = SINES(sine, 2), minus_rocker_rate_mz = (-gravity_z_rocker_mx) * minus_rocker_sin;
    WRITE(load_, 2, minus_rocker_rate_mz);
    REAL checked1 = minus_rocker_rate_mz;
    const REAL D_v = READ(v, 2), t21 = k6 * (D_v * D_v), rocker_cos = SINES(cosine, 2), t22 = rocker_cos * t21,
      t24 = minus_rocker_sin * t21, crank_cos = SINES(cosine, 0), crank_sin = SINES(sine, 0);
    /* C: loop closure */
    const REAL t30 = crank_cos * t22 - crank_sin * t24, t26 = crank_sin * t22 + crank_cos * t24, A_v = READ(v, 0),
      t4 = B_at_z * (A_v * A_v), /* crank */
      t31 = t4 - t30, coupler_cos = SINES(cosine, 1), t32 = coupler_cos * t31,
      C_opening_bias_fy = coupler_sin * t31 - coupler_cos * t26;
    WRITE(curvature_, 1, C_opening_bias_fy);
    REAL checked2 = C_opening_bias_fy;
    const REAL t33 = coupler_sin * t26 + t32, coupler_omega_z = A_v + READ(v, 1),
      minus_coupler_U_still_xx = coupler_omega_z * coupler_omega_z,
      C_opening_bias_fx = (-0.5) * minus_coupler_U_still_xx - t33;
    WRITE(curvature_, 0, C_opening_bias_fx);
    REAL checked3 = C_opening_bias_fx;
    const REAL t8 = B_at_z * (coupler_sin * (k11 * minus_coupler_U_still_xx)), /* crank */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos,
      t18 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz,
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      t17 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz,
      minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin;
    RESULT(checked0, closure_, 11, t18 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz);
    RESULT(checked1, closure_, 10, minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz - t17);
    RESULT(checked2, closure_, 1, 0.5 + B_at_z * coupler_cos);
    const REAL coupler_acc_still_y = coupler_sin * (t4 - gravity_z * crank_cos) - coupler_cos * (gravity_z *
        crank_sin),
      coupler_rate_mz = k11 * coupler_acc_still_y;
    WRITE(load_, 1, -coupler_rate_mz);
    RESULT(checked3, load_, 0, k14 * crank_sin - (coupler_rate_mz - t8) + READ(u, 0));
    const REAL A_mass_matrix_by_B = coupler_sxx + k13 * coupler_cos;
    WRITE(inertia_, 1, A_mass_matrix_by_B);
    WRITE(inertia_, 3, A_mass_matrix_by_B);
    checked0 = checked0 + A_mass_matrix_by_B;
    RESULT(checked1, inertia_, 0, k9 * coupler_cos + k12);
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
    const int failed = four_bar_forward_dynamics_dense(q, v, u, inertia, load, closure, curvature);
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
    if (failed != 0 || rank < 0 || !isfinite(total)) {
        four_bar_set_nan(a, 3);
        return failed == 0 && isfinite(total) ? 1 : 2;
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
    const REAL C_joint_reaction_fz = -multipliers_2;
    WRITE(reactions, 1, C_joint_reaction_fz);
    WRITE(reactions, 7, C_joint_reaction_fz);
    WRITE(reactions, 13, C_joint_reaction_fz);
    WRITE(sized_, 2, C_joint_reaction_fz);
    WRITE(sized_, 8, C_joint_reaction_fz);
    WRITE(sized_, 14, C_joint_reaction_fz);
    /* mechanism: balance, eqs. (40)-(47); results */
    const REAL multipliers_0 = READ(multipliers_, 0);
    WRITE(sized_, 12, -multipliers_0);
    const REAL multipliers_1 = READ(multipliers_, 1);
    WRITE(sized_, 13, -multipliers_1);
    const REAL multipliers_3 = READ(multipliers_, 3), sized_15 = (-per_length) * multipliers_3;
    WRITE(sized_, 15, sized_15);
    REAL checked1 = sized_15;
    const REAL multipliers_4 = READ(multipliers_, 4), sized_16 = (-per_length) * multipliers_4;
    WRITE(sized_, 16, sized_16);
    REAL checked2 = sized_16;
    const REAL A_v = READ(v, 0), minus_crank_U_still_xx = A_v * A_v, crank_cos = SINES(cosine, 0),
      t2 = crank_mx * minus_crank_U_still_xx, /* crank */
      t5 = B_at_z * minus_crank_U_still_xx - gravity_z * crank_cos; /* crank */
    /* coupler: geometry; accelerations; momentum rate, eq. (35) */
    const REAL coupler_cos = SINES(cosine, 1), coupler_sin = SINES(sine, 1), A_a = READ(a, 0),
      crank_sin = SINES(sine, 0), t6 = coupler_cos * t5, t12 = coupler_sin * t5,
      t8 = B_at_z * A_a - gravity_z * crank_sin, t10 = rocker_m * (t6 - coupler_sin * t8),
      t14 = rocker_m * (t12 + coupler_cos * t8), coupler_omega_z = A_v + READ(v, 1);
    /* coupler: balance, eqs. (40)-(47) */
    const REAL minus_coupler_sent_fx = k11 * (coupler_omega_z * coupler_omega_z) + t10 + multipliers_0,
      t11 = coupler_cos * minus_coupler_sent_fx, t19 = coupler_sin * minus_coupler_sent_fx,
      coupler_sent_fy = k11 * (A_a + READ(a, 1)) + t14 - multipliers_1,
      minus_coupler_joint_sent_fx = t11 + coupler_sin * coupler_sent_fy,
      minus_coupler_joint_sent_fy = t19 - coupler_cos * coupler_sent_fy;
    WRITE(sized_, 6, -minus_coupler_joint_sent_fx);
    WRITE(sized_, 7, -minus_coupler_joint_sent_fy);
    /* crank: balance, eqs. (40)-(47) */
    const REAL crank_sent_fx = crank_m_gravity_z * crank_cos - t2 - minus_coupler_joint_sent_fx,
      t16 = crank_sin * crank_sent_fx, t22 = crank_cos * crank_sent_fx,
      minus_crank_sent_fy = crank_m_gravity_z * crank_sin - crank_mx * A_a + minus_coupler_joint_sent_fy,
      crank_joint_sent_fy = t16 - crank_cos * minus_crank_sent_fy;
    WRITE(reactions, 0, crank_joint_sent_fy);
    WRITE(sized_, 1, crank_joint_sent_fy);
    REAL checked3 = crank_joint_sent_fy;
    const REAL crank_joint_sent_fx = t22 + crank_sin * minus_crank_sent_fy;
    WRITE(reactions, 2, crank_joint_sent_fx);
    WRITE(sized_, 0, crank_joint_sent_fx);
    checked0 = checked0 + crank_joint_sent_fx;
    const REAL minus_coupler_sent_my = multipliers_4 - 0.5 * multipliers_2,
      t29 = coupler_cos * minus_coupler_sent_my, /* coupler */
      t26 = coupler_sin * minus_coupler_sent_my, /* coupler */
      t28 = coupler_sin * multipliers_3, /* coupler */
      minus_coupler_joint_sent_my = t28 + t29;
    RESULT(checked1, sized_, 10, (-per_length) * minus_coupler_joint_sent_my);
    const REAL minus_crank_sent_my = minus_coupler_joint_sent_my - B_at_z * multipliers_2,
      t31 = crank_cos * minus_crank_sent_my, t33 = crank_sin * minus_crank_sent_my,
      t24 = coupler_cos * multipliers_3, /* coupler */
      minus_coupler_joint_sent_mx = t24 - t26;
    RESULT(checked2, sized_, 9, (-per_length) * minus_coupler_joint_sent_mx);
    const REAL t27 = crank_sin * minus_coupler_joint_sent_mx, minus_crank_joint_sent_my = t27 + t31;
    WRITE(reactions, 3, -minus_crank_joint_sent_my);
    RESULT(checked3, sized_, 4, (-per_length) * minus_crank_joint_sent_my);
    const REAL t32 = crank_cos * minus_coupler_joint_sent_mx, minus_crank_joint_sent_mx = t32 - t33;
    WRITE(reactions, 5, -minus_crank_joint_sent_mx);
    RESULT(checked0, sized_, 3, (-per_length) * minus_crank_joint_sent_mx);
    /* B: reactions, eq. (32) */
    const REAL t37 = crank_cos * minus_coupler_joint_sent_fx,
      t36 = crank_sin * minus_coupler_joint_sent_fx + crank_cos * minus_coupler_joint_sent_fy;
    WRITE(reactions, 6, -t36);
    const REAL t39 = t37 - crank_sin * minus_coupler_joint_sent_fy;
    WRITE(reactions, 8, -t39);
    const REAL t42 = t27 + crank_cos * minus_coupler_joint_sent_my,
      t46 = crank_sin * minus_coupler_joint_sent_my - t32, coupler_position_z = B_at_z * crank_cos,
      t44 = coupler_position_z * t36;
    RESULT(checked1, reactions, 9, coupler_position_z * multipliers_2 - t42);
    const REAL coupler_position_x = B_at_z * crank_sin;
    RESULT(checked2, reactions, 10, coupler_position_x * t39 - t44);
    RESULT(checked3, reactions, 11, t46 - coupler_position_x * multipliers_2);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    /* C: reactions, eq. (32) */
    const REAL t50 = coupler_rotation_xx * multipliers_0,
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t54 = t50 - minus_coupler_rotation_xy * multipliers_1;
    WRITE(reactions, 12, -t54);
    const REAL t58 = coupler_position_z - 0.5 * minus_coupler_rotation_xy, /* coupler */
      t63 = t58 * t54, t59 = t58 * multipliers_2;
    RESULT(checked0, reactions, 15, t59 - (coupler_rotation_xx * multipliers_3 - minus_coupler_rotation_xy *
        multipliers_4));
    const REAL t65 = coupler_position_x + 0.5 * coupler_rotation_xx, /* coupler */
      t68 = minus_coupler_rotation_xy * multipliers_3,
      C_reactions_fz = minus_coupler_rotation_xy * multipliers_0 + coupler_rotation_xx * multipliers_1;
    WRITE(reactions, 14, C_reactions_fz);
    const REAL t67 = t63 + t65 * C_reactions_fz;
    checked1 = checked1 + t67;
    WRITE(reactions, 16, -t67);
    RESULT(checked2, reactions, 17, t68 + coupler_rotation_xx * multipliers_4 - t65 * multipliers_2);
    const REAL D_v = READ(v, 2);
    /* rocker: geometry; momentum rate, eq. (35) */
    const REAL rocker_cos = SINES(cosine, 2),
      minus_rocker_rate_fx_2 = rocker_mx * (D_v * D_v) - rocker_m_gravity_z * rocker_cos,
      minus_rocker_sin = SINES(sine, 2);
    /* rocker: balance, eqs. (40)-(47); momentum rate, eq. (35) */
    const REAL t74 = minus_rocker_sin * minus_rocker_rate_fx_2, t87 = rocker_cos * minus_rocker_rate_fx_2,
      rocker_rate_fy_2 = rocker_mx * READ(a, 2) + rocker_m_gravity_z * minus_rocker_sin,
      t77 = t74 + rocker_cos * rocker_rate_fy_2, t89 = t87 - minus_rocker_sin * rocker_rate_fy_2,
      t80 = coupler_cos * multipliers_0 - coupler_sin * multipliers_1, t81 = crank_sin * t80, t90 = crank_cos * t80,
      t84 = coupler_sin * multipliers_0 + coupler_cos * multipliers_1,
      rocker_joint_sent_fy = t77 + (t81 + crank_cos * t84);
    WRITE(reactions, 18, rocker_joint_sent_fy);
    WRITE(sized_, 19, rocker_joint_sent_fy);
    checked3 = checked3 + rocker_joint_sent_fy;
    const REAL minus_rocker_joint_sent_fx = t89 - (t90 - crank_sin * t84),
      rocker_joint_sent_fx = -minus_rocker_joint_sent_fx;
    WRITE(reactions, 20, rocker_joint_sent_fx);
    WRITE(sized_, 18, rocker_joint_sent_fx);
    RESULT(checked0, reactions, 22, D_at_x * minus_rocker_joint_sent_fx);
    const REAL t94 = t24 - coupler_sin * multipliers_4, t101 = crank_cos * t94, t95 = crank_sin * t94,
      t97 = t28 + coupler_cos * multipliers_4, t99 = t95 + crank_cos * t97,
      rocker_joint_sent_mx = t101 - crank_sin * t97 - k6 * minus_rocker_sin * multipliers_2;
    RESULT(checked1, sized_, 21, per_length * rocker_joint_sent_mx);
    RESULT(checked2, reactions, 23, rocker_joint_sent_mx + D_at_x * multipliers_2);
    const REAL rocker_joint_sent_my = t99 - k6 * rocker_cos * multipliers_2;
    WRITE(reactions, 21, rocker_joint_sent_my);
    RESULT(checked3, sized_, 22, per_length * rocker_joint_sent_my);
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
    const int failed = four_bar_forward_dynamics_dense(q, v, u, inertia, load, closure, curvature);
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
    if (failed != 0 || rank < 0 || !isfinite(total)) {
        four_bar_set_nan(a, 3);
        four_bar_set_nan(reactions, 24);
        return failed == 0 && isfinite(total) ? 1 : 2;
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
