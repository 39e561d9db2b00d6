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
    const REAL A_v = READ(v, 0), minus_crank_U_still_xx = A_v * A_v, crank_cos = SINES(cosine, 0),
      t41 = crank_mx * minus_crank_U_still_xx, /* crank */
      t6 = B_at_z * minus_crank_U_still_xx - gravity_z * crank_cos; /* crank */
    /* coupler: geometry; accelerations; momentum rate, eq. (35) */
    const REAL coupler_sin = SINES(sine, 1), coupler_cos = SINES(cosine, 1), A_a = READ(a, 0),
      crank_sin = SINES(sine, 0), t7 = coupler_sin * t6, t34 = coupler_cos * t6,
      t9 = B_at_z * A_a - gravity_z * crank_sin, coupler_acc_y = t7 + coupler_cos * t9,
      t36 = rocker_m * (t34 - coupler_sin * t9), t11 = k7 * coupler_acc_y, t38 = rocker_m * coupler_acc_y,
      coupler_twist_rate_wy = A_a + READ(a, 1), C_multiplier_fy = 2.0 * (coupler_sxx * coupler_twist_rate_wy + t11),
      coupler_rate_fy = k7 * coupler_twist_rate_wy, t30 = coupler_cos * coupler_rate_fy,
      minus_coupler_sent_fy = C_multiplier_fy - (coupler_rate_fy + t38);
    /* rocker: balance, eqs. (40)-(47); geometry */
    const REAL t12 = coupler_sin * C_multiplier_fy, t13 = crank_sin * t12, t14 = coupler_cos * C_multiplier_fy,
      rocker_cos = SINES(cosine, 2), t16 = t13 - crank_cos * t14,
      minus_rocker_joint_force_my_by_C_fz = k6 * rocker_cos, minus_rocker_sin = SINES(sine, 2),
      t17 = minus_rocker_joint_force_my_by_C_fz * t16, t20 = crank_cos * t12 + crank_sin * t14,
      minus_rocker_joint_force_mx_by_C_fz = k6 * minus_rocker_sin, D_a = READ(a, 2),
      t22 = t17 + minus_rocker_joint_force_mx_by_C_fz * t20,
      rocker_joint_force_mz = gravity_z_rocker_mx * minus_rocker_sin + rocker_sxx * D_a - t22,
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      t25 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      minus_C_closure_fx_by_D = t25 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz;
    REAL checked0 = minus_C_closure_fx_by_D;
    const REAL minus_C_multiplier_fx = rocker_joint_force_mz / minus_C_closure_fx_by_D,
      t29 = B_at_z * coupler_sin * minus_C_multiplier_fx, /* A */
      coupler_omega_z = A_v + READ(v, 1), minus_coupler_rate_fx = k7 * (coupler_omega_z * coupler_omega_z),
      t32 = B_at_z * (coupler_sin * minus_coupler_rate_fx - t30 + t14), /* crank */
      coupler_sent_fx = minus_C_multiplier_fx - (minus_coupler_rate_fx + t36),
      A_balance = t29 - (t32 + (k12 * crank_sin - k8 * A_a));
    WRITE(u, 0, A_balance);
    REAL checked1 = A_balance;
    const REAL t43 = coupler_sin * coupler_sent_fx, /* coupler */
      coupler_joint_sent_fx = coupler_cos * coupler_sent_fx + coupler_sin * minus_coupler_sent_fy,
      coupler_joint_sent_fy = t43 - coupler_cos * minus_coupler_sent_fy;
    /* crank: balance, eqs. (40)-(47) */
    const REAL crank_sent_fx = coupler_joint_sent_fx + (crank_m_gravity_z * crank_cos - t41),
      t42 = crank_sin * crank_sent_fx, t48 = crank_cos * crank_sent_fx,
      crank_sent_fy = coupler_joint_sent_fy - (crank_m_gravity_z * crank_sin - crank_mx * A_a),
      crank_joint_sent_fy = t42 + crank_cos * crank_sent_fy;
    WRITE(reactions, 0, crank_joint_sent_fy);
    REAL checked2 = crank_joint_sent_fy;
    const REAL crank_joint_sent_fx = t48 - crank_sin * crank_sent_fy;
    WRITE(reactions, 2, crank_joint_sent_fx);
    REAL checked3 = crank_joint_sent_fx;
    const REAL t52 = crank_cos * coupler_joint_sent_fx, /* B */
      B_reaction_fx = crank_sin * coupler_joint_sent_fx + crank_cos * coupler_joint_sent_fy;
    WRITE(reactions, 6, B_reaction_fx);
    const REAL B_reaction_fz = t52 - crank_sin * coupler_joint_sent_fy;
    WRITE(reactions, 8, B_reaction_fz);
    const REAL coupler_position_z = B_at_z * crank_cos, t54 = coupler_position_z * B_reaction_fx, /* B */
      coupler_position_x = B_at_z * crank_sin;
    RESULT(checked0, reactions, 10, t54 - coupler_position_x * B_reaction_fz);
    const REAL minus_C_reaction_fz = minus_coupler_rotation_xy * minus_C_multiplier_fx - coupler_rotation_xx * C_multiplier_fy;
    WRITE(reactions, 14, -minus_C_reaction_fz);
    const REAL C_reaction_fx = coupler_rotation_xx * minus_C_multiplier_fx + minus_coupler_rotation_xy * C_multiplier_fy;
    WRITE(reactions, 12, C_reaction_fx);
    const REAL t62 = (coupler_position_z - 0.5 * minus_coupler_rotation_xy) * C_reaction_fx, /* C */
      t109 = per_length * minus_coupler_rotation_xy; /* coupler */
    RESULT(checked1, reactions, 16, t62 + (coupler_position_x + 0.5 * coupler_rotation_xx) * minus_C_reaction_fz);
    const REAL t107 = per_length * coupler_rotation_xx; /* coupler */
    /* rocker: balance, eqs. (40)-(47); momentum rate, eq. (35); pivots */
    const REAL t72 = t12 + coupler_cos * minus_C_multiplier_fx, t75 = t14 - coupler_sin * minus_C_multiplier_fx,
      D_v = READ(v, 2), t77 = crank_sin * t72 - crank_cos * t75, t83 = crank_cos * t72 + crank_sin * t75,
      minus_rocker_rate_fx_2 = rocker_mx * (D_v * D_v) - rocker_m_gravity_z * rocker_cos,
      t67 = minus_rocker_sin * minus_rocker_rate_fx_2, t78 = rocker_cos * minus_rocker_rate_fx_2,
      rocker_rate_fy_2 = rocker_mx * D_a + rocker_m_gravity_z * minus_rocker_sin;
    RESULT(checked2, reactions, 18, t67 + rocker_cos * rocker_rate_fy_2 - t77);
    const REAL minus_rocker_joint_sent_fx = t78 - minus_rocker_sin * rocker_rate_fy_2 + t83;
    WRITE(reactions, 20, -minus_rocker_joint_sent_fx);
    RESULT(checked3, reactions, 22, D_at_x * minus_rocker_joint_sent_fx);
    const REAL t84 = per_length_crank_m * coupler_sin, /* coupler */
      t86 = 2.0 + t84 * t84, /* coupler */
      t87 = per_length_crank_m * coupler_cos, /* coupler */
      t90 = 1.0 + (t86 + t87 * t87), /* coupler */
      t91 = k13 * minus_rocker_sin, t93 = t90 + t91 * t91, /* mechanism */
      t94 = k13 * rocker_cos, t97 = 1.0 + (t93 + t94 * t94), /* mechanism */
      minus_crank_lever_my_by_C_fz = B_at_z + 0.5 * coupler_cos,
      t99 = crank_sin * minus_crank_lever_my_by_C_fz, /* crank */
      t104 = crank_cos * minus_crank_lever_my_by_C_fz, /* crank */
      crank_lever_mx_by_C_fz = 0.5 * coupler_sin,
      t100 = per_length * (crank_cos * crank_lever_mx_by_C_fz + t99), /* base */
      t105 = per_length * (crank_sin * crank_lever_mx_by_C_fz - t104), /* base */
      pivot_0 = t97 + t100 * t100 + t105 * t105;
    checked0 = checked0 + pivot_0;
    const REAL t132 = 1.0 / pivot_0, /* mechanism */
      t124 = t91 * t109, /* mechanism */
      t144 = t91 * t107, /* mechanism */
      t111 = per_length * coupler_cos, /* coupler */
      t121 = t84 * t111, /* coupler */
      t114 = per_length * coupler_sin, /* coupler */
      t141 = t84 * t114; /* coupler */
    /* mechanism: pivots */
    const REAL t125 = t121 - t87 * t114 + t124, t115 = t114 * t114, /* coupler */
      t145 = t141 + t87 * t111 - t144, t112 = t111 * t111, /* coupler */
      t149 = t145 - t94 * t109 + t100 * t107, t131 = t125 - t94 * t107 - t100 * t109 + t105 * t107,
      t108 = t107 * t107, /* coupler */
      t151 = t149 + t105 * t109, t110 = t109 * t109, /* coupler */
      t134 = t131 * (t131 * t132), t152 = t151 * t132, t154 = t131 * t152, t153 = t151 * t152,
      t120 = t108 + (t110 + (per_length_squared + t112 + t115 + t110 + t108)), /* coupler */
      pivot_1 = t120 - t134;
    checked1 = checked1 + pivot_1;
    const REAL t157 = t153 + t154 * (t154 / pivot_1),
      t140 = t110 + (t108 + (t110 + (t108 + (t112 + (per_length_squared + t115))))), /* coupler */
      pivot_2 = t140 - t157;
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
