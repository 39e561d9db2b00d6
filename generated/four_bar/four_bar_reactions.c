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
    /* A: velocities, eq. (6) */
    const REAL A_v = READ(v, 0), minus_crank_U_still_xx = A_v * A_v, crank_cos = SINES(cosine, 0),
      t42 = crank_mx * minus_crank_U_still_xx, /* crank */
      t6 = B_at_z * minus_crank_U_still_xx - gravity_z * crank_cos; /* crank */
    /* coupler: geometry; accelerations; momentum rate, eq. (35) */
    const REAL coupler_sin = SINES(sine, 1), coupler_cos = SINES(cosine, 1), A_a = READ(a, 0),
      crank_sin = SINES(sine, 0), t7 = coupler_sin * t6, t35 = coupler_cos * t6,
      t9 = B_at_z * A_a - gravity_z * crank_sin, coupler_acc_y = t7 + coupler_cos * t9,
      t37 = rocker_m * (t35 - coupler_sin * t9), t11 = k11 * coupler_acc_y, t39 = rocker_m * coupler_acc_y,
      coupler_twist_rate_wy = A_a + READ(a, 1), C_multiplier_fy = 2.0 * (coupler_sxx * coupler_twist_rate_wy + t11),
      coupler_rate_fy = k11 * coupler_twist_rate_wy, t3 = coupler_cos * coupler_rate_fy,
      minus_coupler_sent_fy = C_multiplier_fy - (coupler_rate_fy + t39);
    /* rocker: balance, eqs. (40)-(47); geometry */
    const REAL t16 = coupler_sin * C_multiplier_fy, t17 = crank_sin * t16,
      t12 = coupler_cos * C_multiplier_fy, /* A */
      rocker_cos = SINES(cosine, 2), t19 = t17 - crank_cos * t12,
      minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos, minus_rocker_sin = SINES(sine, 2),
      t20 = minus_rocker_joint_force_my_by_C_fz * t19, t23 = crank_cos * t16 + crank_sin * t12,
      minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin, D_a = READ(a, 2),
      t25 = t20 + minus_rocker_joint_force_mx_by_C_fz * t23,
      rocker_joint_force_mz = gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * D_a - t25,
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      t28 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      minus_C_closure_fx_by_D = t28 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL minus_C_multiplier_fx = rocker_joint_force_mz / minus_C_closure_fx_by_D,
      t32 = coupler_sin * minus_C_multiplier_fx, /* A */
      coupler_omega_z = A_v + READ(v, 1), minus_coupler_rate_fx = k11 * (coupler_omega_z * coupler_omega_z),
      minus_coupler_rate_fx_2 = minus_coupler_rate_fx + t37,
      t33 = coupler_sin * minus_coupler_rate_fx - t3 + t12 - t32, /* A */
      t75 = t12 - t32, /* A */
      t34 = B_at_z * t33, /* A */
      coupler_sent_fx = minus_C_multiplier_fx - minus_coupler_rate_fx_2,
      A_balance = k8 * A_a - k14 * crank_sin - t34;
    WRITE(u, 0, A_balance);
    REAL checked1 = A_balance;
    const REAL t44 = coupler_sin * coupler_sent_fx, /* coupler */
      coupler_joint_sent_fx = coupler_cos * coupler_sent_fx + coupler_sin * minus_coupler_sent_fy,
      coupler_joint_sent_fy = t44 - coupler_cos * minus_coupler_sent_fy;
    /* crank: balance, eqs. (40)-(47) */
    const REAL crank_sent_fx = coupler_joint_sent_fx + (crank_m_gravity_z * crank_cos - t42),
      t43 = crank_sin * crank_sent_fx, t49 = crank_cos * crank_sent_fx,
      crank_sent_fy = coupler_joint_sent_fy - (crank_m_gravity_z * crank_sin - crank_mx * A_a),
      crank_joint_sent_fy = t43 + crank_cos * crank_sent_fy;
    WRITE(reactions, 0, crank_joint_sent_fy);
    REAL checked2 = crank_joint_sent_fy;
    const REAL crank_joint_sent_fx = t49 - crank_sin * crank_sent_fy;
    WRITE(reactions, 2, crank_joint_sent_fx);
    REAL checked3 = crank_joint_sent_fx;
    const REAL t53 = crank_cos * coupler_joint_sent_fx, /* B */
      B_reaction_fx = crank_sin * coupler_joint_sent_fx + crank_cos * coupler_joint_sent_fy;
    WRITE(reactions, 6, B_reaction_fx);
    const REAL B_reaction_fz = t53 - crank_sin * coupler_joint_sent_fy;
    WRITE(reactions, 8, B_reaction_fz);
    const REAL coupler_position_z = B_at_z * crank_cos, t55 = coupler_position_z * B_reaction_fx, /* B */
      coupler_position_x = B_at_z * crank_sin;
    RESULT(checked0, reactions, 10, t55 - coupler_position_x * B_reaction_fz);
    const REAL minus_C_reaction_fz = minus_coupler_rotation_xy * minus_C_multiplier_fx - coupler_rotation_xx *
        C_multiplier_fy;
    WRITE(reactions, 14, -minus_C_reaction_fz);
    const REAL C_reaction_fx = coupler_rotation_xx * minus_C_multiplier_fx + minus_coupler_rotation_xy *
        C_multiplier_fy;
    WRITE(reactions, 12, C_reaction_fx);
    const REAL t73 = t16 + coupler_cos * minus_C_multiplier_fx, /* rocker */
      t63 = (coupler_position_z - 0.5 * minus_coupler_rotation_xy) * C_reaction_fx, /* C */
      t107 = per_length * minus_coupler_rotation_xy; /* coupler */
    RESULT(checked1, reactions, 16, t63 + (coupler_position_x + 0.5 * coupler_rotation_xx) * minus_C_reaction_fz);
    const REAL t110 = per_length * coupler_rotation_xx, /* coupler */
      D_v = READ(v, 2);
    /* rocker: balance, eqs. (40)-(47); momentum rate, eq. (35); pivots */
    const REAL t77 = crank_sin * t73 - crank_cos * t75, t83 = crank_cos * t73 + crank_sin * t75,
      minus_rocker_rate_fx_2 = rocker_mx * (D_v * D_v) - rocker_m_gravity_z * rocker_cos,
      t68 = minus_rocker_sin * minus_rocker_rate_fx_2, t78 = rocker_cos * minus_rocker_rate_fx_2,
      rocker_rate_fy_2 = rocker_mx * D_a + rocker_m_gravity_z * minus_rocker_sin;
    RESULT(checked2, reactions, 18, t68 + rocker_cos * rocker_rate_fy_2 - t77);
    const REAL minus_rocker_joint_sent_fx = t78 - minus_rocker_sin * rocker_rate_fy_2 + t83;
    WRITE(reactions, 20, -minus_rocker_joint_sent_fx);
    RESULT(checked3, reactions, 22, D_at_x * minus_rocker_joint_sent_fx);
    const REAL t84 = per_length_crank_m * coupler_sin, /* coupler */
      t86 = 2.0 + t84 * t84, /* coupler */
      t87 = per_length_crank_m * coupler_cos, /* coupler */
      t90 = 1.0 + (t86 + t87 * t87), /* coupler */
      t91 = k15 * minus_rocker_sin, t93 = t90 + t91 * t91, /* mechanism */
      t94 = k15 * rocker_cos, t97 = 1.0 + (t93 + t94 * t94), /* mechanism */
      minus_crank_lever_my_by_C_fz = B_at_z + 0.5 * coupler_cos,
      t99 = crank_sin * minus_crank_lever_my_by_C_fz, /* crank */
      t104 = crank_cos * minus_crank_lever_my_by_C_fz, /* crank */
      crank_lever_mx_by_C_fz = 0.5 * coupler_sin,
      t100 = per_length * (crank_cos * crank_lever_mx_by_C_fz + t99), /* base */
      t105 = per_length * (crank_sin * crank_lever_mx_by_C_fz - t104); /* base */
    /* mechanism: pivots */
    const REAL t108 = t91 - t100, t102 = t97 + t100 * t100, t111 = t94 - t105, pivot_0 = t102 + t105 * t105;
    checked0 = checked0 + pivot_0;
    const REAL t114 = 1.0 / pivot_0, t135 = t110 * t108, t113 = t107 * t108 - t110 * t111, t131 = t107 * t111,
      t126 = 2.0 * (t107 * t107 + t110 * t110), /* coupler */
      t116 = t113 * (t114 * t113), t117 = per_length * coupler_cos, /* coupler */
      t133 = t87 * t117, /* coupler */
      t118 = t117 * t117, /* coupler */
      t119 = per_length_squared + t118, /* coupler */
      t120 = per_length * coupler_sin, /* coupler */
      t137 = t131 - (t84 * t120 + t133 - t135), t121 = t120 * t120, /* coupler */
      minus_pivot_1 = t116 - (t119 + t121 + t126);
    checked1 = checked1 + minus_pivot_1;
    const REAL t138 = t114 * t137, t140 = t113 * t138, t143 = t137 * t138 - t140 * (t140 / minus_pivot_1),
      pivot_2 = t118 + (per_length_squared + t121) + t126 - t143;
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
        SMALL(minus_C_closure_fx_by_D, 5.057800000000001e-10) OR /* where D does not move the loop at C */
        SMALL(pivot_0, 1.3789999999999998e-08) OR
            /* where step 0 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(minus_pivot_1, 4.3948000000000004e-08) OR
            /* where step 1 of symmetric equations loses rank: of drives, inertia or internal loads */
        SMALL(pivot_2, 4.3948000000000004e-08),
            /* where step 2 of symmetric equations loses rank: of drives, inertia or internal loads */
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
