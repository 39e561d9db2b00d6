/*
 * four_bar: reactions.
 *   joint_reactions
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

BODY(four_bar_joint_reactions)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict u, double *restrict reactions, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* A: accelerations */
    const REAL A_v = READ(v, 0);
    const REAL minus_crank_U_still_xx = A_v * A_v;
    const REAL crank_cos = SINES(cosine, 0);
    const REAL t43 = crank_mx * minus_crank_U_still_xx; /* crank */
    const REAL t7 = B_at_z * minus_crank_U_still_xx - gravity_z * crank_cos; /* crank */
    /* coupler: geometry; accelerations; momentum rate, eq. (35) */
    const REAL coupler_sin = SINES(sine, 1), coupler_cos = SINES(cosine, 1), A_a = READ(a, 0);
    const REAL crank_sin = SINES(sine, 0);
    const REAL t8 = coupler_sin * t7;
    const REAL t36 = coupler_cos * t7;
    const REAL t10 = B_at_z * A_a - gravity_z * crank_sin;
    const REAL coupler_acc_y = t8 + coupler_cos * t10;
    const REAL t38 = rocker_m * (t36 - coupler_sin * t10);
    const REAL t12 = coupler_com_z * coupler_acc_y;
    const REAL t40 = rocker_m * coupler_acc_y;
    const REAL coupler_twist_rate_angular_y = A_a + READ(a, 1);
    const REAL C_multiplier_fy = 2.0 * (coupler_sxx * coupler_twist_rate_angular_y + t12);
    const REAL coupler_rate_force_y = coupler_com_z * coupler_twist_rate_angular_y;
    const REAL t32 = coupler_cos * coupler_rate_force_y;
    const REAL minus_coupler_sent_force_y = C_multiplier_fy - (coupler_rate_force_y + t40);
    /* rocker: balance, eqs. (40)-(47); geometry */
    const REAL t13 = coupler_sin * C_multiplier_fy;
    const REAL t14 = crank_sin * t13;
    const REAL t15 = coupler_cos * C_multiplier_fy;
    const REAL rocker_cos = SINES(cosine, 2);
    const REAL t17 = t14 - crank_cos * t15;
    const REAL t4 = k6 * rocker_cos;
    const REAL minus_rocker_sin = SINES(sine, 2);
    const REAL t18 = t4 * t17;
    const REAL t22 = crank_cos * t13 + crank_sin * t15;
    const REAL t19 = k6 * minus_rocker_sin;
    const REAL D_a = READ(a, 2);
    const REAL rocker_joint_force_moment_z = gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * D_a - (t18 + t19 * t22);
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t27 = coupler_rotation_xx * t4; /* C */
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL minus_C_closure_fx_by_D = t27 - minus_coupler_rotation_xy * t19;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL minus_C_multiplier_fx = rocker_joint_force_moment_z / minus_C_closure_fx_by_D;
    const REAL t31 = B_at_z * coupler_sin * minus_C_multiplier_fx; /* A */
    const REAL coupler_omega_z = A_v + READ(v, 1);
    const REAL minus_coupler_rate_force_x = coupler_com_z * (coupler_omega_z * coupler_omega_z);
    const REAL t34 = B_at_z * (coupler_sin * minus_coupler_rate_force_x - t32 + t15); /* crank */
    const REAL coupler_sent_force_x = minus_C_multiplier_fx - (minus_coupler_rate_force_x + t38);
    const REAL A_balance = t31 - (t34 + (k10 * crank_sin - k7 * A_a));
    WRITE(u, 0, A_balance);
    REAL checked1 = A_balance;
    const REAL t45 = coupler_sin * coupler_sent_force_x; /* coupler */
    const REAL coupler_joint_sent_force_x = coupler_cos * coupler_sent_force_x + coupler_sin * minus_coupler_sent_force_y;
    const REAL coupler_joint_sent_force_y = t45 - coupler_cos * minus_coupler_sent_force_y;
    /* crank: balance, eqs. (40)-(47) */
    const REAL crank_sent_force_x = coupler_joint_sent_force_x + (crank_m_gravity_z * crank_cos - t43);
    const REAL t44 = crank_sin * crank_sent_force_x;
    const REAL t50 = crank_cos * crank_sent_force_x;
    const REAL crank_sent_force_y = coupler_joint_sent_force_y - (crank_m_gravity_z * crank_sin - crank_mx * A_a);
    const REAL crank_joint_sent_force_y = t44 + crank_cos * crank_sent_force_y;
    WRITE(reactions, 0, crank_joint_sent_force_y);
    REAL checked2 = crank_joint_sent_force_y;
    const REAL crank_joint_sent_force_x = t50 - crank_sin * crank_sent_force_y;
    WRITE(reactions, 2, crank_joint_sent_force_x);
    REAL checked3 = crank_joint_sent_force_x;
    const REAL t54 = crank_cos * coupler_joint_sent_force_x; /* B */
    const REAL B_reaction_force_x = crank_sin * coupler_joint_sent_force_x + crank_cos * coupler_joint_sent_force_y;
    WRITE(reactions, 6, B_reaction_force_x);
    const REAL B_reaction_force_z = t54 - crank_sin * coupler_joint_sent_force_y;
    WRITE(reactions, 8, B_reaction_force_z);
    const REAL coupler_position_z = B_at_z * crank_cos;
    const REAL t56 = coupler_position_z * B_reaction_force_x; /* B */
    const REAL coupler_position_x = B_at_z * crank_sin;
    RESULT(checked0, reactions, 10, t56 - coupler_position_x * B_reaction_force_z);
    const REAL minus_C_reaction_force_z = minus_coupler_rotation_xy * minus_C_multiplier_fx - coupler_rotation_xx * C_multiplier_fy;
    RESULT(checked1, reactions, 14, -minus_C_reaction_force_z);
    const REAL C_reaction_force_x = coupler_rotation_xx * minus_C_multiplier_fx + minus_coupler_rotation_xy * C_multiplier_fy;
    WRITE(reactions, 12, C_reaction_force_x);
    const REAL t64 = (coupler_position_z - 0.5 * minus_coupler_rotation_xy) * C_reaction_force_x; /* C */
    const REAL t111 = per_length * minus_coupler_rotation_xy; /* coupler */
    RESULT(checked2, reactions, 16, t64 + (coupler_position_x + 0.5 * coupler_rotation_xx) * minus_C_reaction_force_z);
    const REAL t109 = per_length * coupler_rotation_xx; /* coupler */
    /* rocker: balance, eqs. (40)-(47); momentum rate, eq. (35); pivots */
    const REAL t74 = t13 + coupler_cos * minus_C_multiplier_fx;
    const REAL t77 = t15 - coupler_sin * minus_C_multiplier_fx;
    const REAL D_v = READ(v, 2);
    const REAL t79 = crank_sin * t74 - crank_cos * t77;
    const REAL t85 = crank_cos * t74 + crank_sin * t77;
    const REAL minus_rocker_rate_force_x_2 = rocker_mx * (D_v * D_v) - rocker_m_gravity_z * rocker_cos;
    const REAL t69 = minus_rocker_sin * minus_rocker_rate_force_x_2;
    const REAL t80 = rocker_cos * minus_rocker_rate_force_x_2;
    const REAL rocker_rate_force_y_2 = rocker_mx * D_a + rocker_m_gravity_z * minus_rocker_sin;
    RESULT(checked3, reactions, 18, t69 + rocker_cos * rocker_rate_force_y_2 - t79);
    const REAL minus_rocker_joint_sent_force_x = t80 - minus_rocker_sin * rocker_rate_force_y_2 + t85;
    RESULT(checked0, reactions, 20, -minus_rocker_joint_sent_force_x);
    RESULT(checked1, reactions, 22, D_at_x * minus_rocker_joint_sent_force_x);
    const REAL t86 = per_length_crank_m * coupler_sin; /* coupler */
    const REAL t88 = 2.0 + t86 * t86; /* coupler */
    const REAL t89 = per_length_crank_m * coupler_cos; /* coupler */
    const REAL t92 = 1.0 + (t88 + t89 * t89); /* coupler */
    const REAL t93 = k11 * minus_rocker_sin;
    const REAL t95 = t92 + t93 * t93; /* mechanism */
    const REAL t96 = k11 * rocker_cos;
    const REAL t99 = 1.0 + (t95 + t96 * t96); /* mechanism */
    const REAL minus_crank_lever_moment_y_by_C_fz = B_at_z + 0.5 * coupler_cos;
    const REAL t101 = crank_sin * minus_crank_lever_moment_y_by_C_fz; /* crank */
    const REAL t106 = crank_cos * minus_crank_lever_moment_y_by_C_fz; /* crank */
    const REAL crank_lever_moment_x_by_C_fz = 0.5 * coupler_sin;
    const REAL t102 = per_length * (crank_cos * crank_lever_moment_x_by_C_fz + t101); /* base */
    const REAL t107 = per_length * (crank_sin * crank_lever_moment_x_by_C_fz - t106); /* base */
    const REAL pivot_0 = t99 + t102 * t102 + t107 * t107;
    checked2 = checked2 + pivot_0;
    const REAL t134 = 1.0 / pivot_0; /* mechanism */
    const REAL t126 = t93 * t111; /* mechanism */
    const REAL t146 = t93 * t109; /* mechanism */
    const REAL t113 = per_length * coupler_cos; /* coupler */
    const REAL t123 = t86 * t113; /* coupler */
    const REAL t116 = per_length * coupler_sin; /* coupler */
    const REAL t143 = t86 * t116; /* coupler */
    /* mechanism: pivots */
    const REAL t127 = t123 - t89 * t116 + t126;
    const REAL t117 = t116 * t116; /* coupler */
    const REAL t147 = t143 + t89 * t113 - t146;
    const REAL t114 = t113 * t113; /* coupler */
    const REAL t151 = t147 - t96 * t111 + t102 * t109;
    const REAL t133 = t127 - t96 * t109 - t102 * t111 + t107 * t109;
    const REAL t110 = t109 * t109; /* coupler */
    const REAL t153 = t151 + t107 * t111;
    const REAL t112 = t111 * t111; /* coupler */
    const REAL t136 = t133 * (t133 * t134);
    const REAL t154 = t153 * t134;
    const REAL t156 = t133 * t154;
    const REAL t155 = t153 * t154;
    const REAL t122 = t110 + (t112 + (per_length_squared + t114 + t117 + t112 + t110)); /* coupler */
    const REAL pivot_1 = t122 - t136;
    checked3 = checked3 + pivot_1;
    const REAL t159 = t155 + t156 * (t156 / pivot_1);
    const REAL t142 = t112 + (t110 + (t112 + (t110 + (t114 + (per_length_squared + t117))))); /* coupler */
    const REAL pivot_2 = t142 - t159;
    checked0 = checked0 + pivot_2;
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
        SMALL(minus_C_closure_fx_by_D, 5.057800000000001e-10) OR /* where D does not move the loop at C */
        SMALL(pivot_0, 1.3789999999999998e-08) OR /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(pivot_1, 4.3948000000000004e-08) OR /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(pivot_2, 4.3948000000000004e-08), /* where step 2 of symmetric equations loses rank: of drives, inertia or internal loads */
        (checked0 + checked1) + (checked2 + checked3));
}

#if !defined(FOUR_BAR_VECTORS)

int four_bar_joint_reactions(const double *restrict q, const double *restrict v, const double *restrict a,
    double *restrict u, double *restrict reactions)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_joint_reactions_body(1, q, v, a, u, reactions, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(u, 1);
        four_bar_set_nan(reactions, 24);
    }
    return outcome;
}
#endif /* FOUR_BAR_VECTORS */
