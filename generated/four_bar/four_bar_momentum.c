/*
 * four_bar: momentum.
 *   momentum_screws; momentum_rates; energy; mass_matrix; bias
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

BODY(four_bar_momentum_screws)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict momenta, double *restrict total_, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0);
    /* coupler: geometry; momentum, eq. (31); velocities, eq. (6) */
    const REAL coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0), coupler_sin = SINES(sine, 1),
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin, t18 = k1 * coupler_rotation_xx,
      t12 = k2 * coupler_rotation_xx, minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t20 = t18 - k2 * minus_coupler_rotation_xy, t16 = t12 + k1 * minus_coupler_rotation_xy, t21 = B_at_z * t20,
      t26 = coupler_com_x * t20, coupler_position_z = B_at_z * crank_cos, B_v = READ(v, 1),
      minus_coupler_twist_vx = B_v * coupler_position_z;
    /* coupler: momentum, eq. (31); velocities, eq. (6); geometry */
    const REAL t23 = coupler_com_x * t16 - (coupler_position_z + t21), A_v = READ(v, 0), t27 = B_at_z * t16,
      coupler_omega_z = A_v + B_v,
      minus_coupler_momentum_px = rocker_m * (minus_coupler_twist_vx + coupler_omega_z * t23),
      t33 = t23 * minus_coupler_momentum_px;
    WRITE(momenta, 6, -minus_coupler_momentum_px);
    const REAL coupler_position_x = B_at_z * crank_sin, t29 = t26 + (coupler_position_x + t27),
      coupler_momentum_pz = rocker_m * (B_v * coupler_position_x - coupler_omega_z * t29);
    WRITE(momenta, 8, coupler_momentum_pz);
    const REAL coupler_momentum_Ly = coupler_Iyy * coupler_omega_z + (t33 - t29 * coupler_momentum_pz);
    WRITE(momenta, 10, coupler_momentum_Ly);
    /* crank: momentum, eq. (31) */
    const REAL t1 = crank_com_z * crank_cos, crank_momentum_px = 0.5 * (A_v * t1);
    WRITE(momenta, 0, crank_momentum_px);
    const REAL t5 = t1 * crank_momentum_px, t57 = crank_momentum_px - minus_coupler_momentum_px, /* px */
      t3 = crank_com_z * crank_sin, minus_crank_momentum_pz = 0.5 * (A_v * t3),
      t7 = t5 + t3 * minus_crank_momentum_pz, t58 = minus_crank_momentum_pz - coupler_momentum_pz; /* pz */
    WRITE(momenta, 2, -minus_crank_momentum_pz);
    const REAL crank_momentum_Ly = t7 + crank_Ixx * A_v;
    WRITE(momenta, 4, crank_momentum_Ly);
    /* rocker: geometry */
    const REAL minus_rocker_sin = SINES(sine, 2), rocker_cos = SINES(cosine, 2),
      t59 = crank_momentum_Ly + coupler_momentum_Ly; /* Ly */
    /* rocker: momentum, eq. (31) */
    const REAL t39 = k3 * minus_rocker_sin + k4 * rocker_cos, t49 = D_at_x - k7 * t39, t40 = rocker_com_z * t39,
      t43 = k4 * minus_rocker_sin - k3 * rocker_cos, t50 = rocker_com_z * t43 - t49, t45 = t40 - k7 * t43,
      D_v = READ(v, 2), rocker_momentum_pz = rocker_m * (D_v * (D_at_x + t50));
    WRITE(momenta, 14, rocker_momentum_pz);
    const REAL pz_total = rocker_momentum_pz - t58;
    WRITE(total_, 2, pz_total);
    REAL checked0 = pz_total;
    const REAL t55 = t50 * rocker_momentum_pz, rocker_momentum_px = rocker_m * (D_v * t45);
    WRITE(momenta, 12, rocker_momentum_px);
    const REAL px_total = rocker_momentum_px + t57;
    WRITE(total_, 0, px_total);
    REAL checked1 = px_total;
    const REAL rocker_momentum_Ly = rocker_Iyy * D_v + (t45 * rocker_momentum_px + t55);
    WRITE(momenta, 16, rocker_momentum_Ly);
    const REAL Ly_total = rocker_momentum_Ly + t59;
    WRITE(total_, 4, Ly_total);
    REAL checked2 = Ly_total;
    WRITE(momenta, 1, CONSTANT(0.0));
    WRITE(momenta, 3, CONSTANT(0.0));
    WRITE(momenta, 5, CONSTANT(0.0));
    WRITE(momenta, 7, CONSTANT(0.0));
    WRITE(momenta, 9, CONSTANT(0.0));
    WRITE(momenta, 11, CONSTANT(0.0));
    WRITE(momenta, 13, CONSTANT(0.0));
    WRITE(momenta, 15, CONSTANT(0.0));
    WRITE(momenta, 17, CONSTANT(0.0));
    WRITE(total_, 1, CONSTANT(0.0));
    WRITE(total_, 3, CONSTANT(0.0));
    WRITE(total_, 5, CONSTANT(0.0));
    FINITE((checked0 + checked1) + checked2);
}

BODY(four_bar_momentum_rates)(size_t stride, const double *restrict q, const double *restrict v,
    const double *restrict a, double *restrict momentum_rates, const double *restrict sine,
    const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* rocker: geometry; momentum, eq. (31); momentum rate, eq. (35) */
    const REAL minus_rocker_sin = SINES(sine, 2), rocker_cos = SINES(cosine, 2),
      t67 = k3 * minus_rocker_sin + k4 * rocker_cos, t69 = D_at_x - k7 * t67, t74 = rocker_com_z * t67,
      t63 = k4 * minus_rocker_sin - k3 * rocker_cos, t70 = rocker_com_z * t63 - t69, t76 = t74 - k7 * t63,
      D_a = READ(a, 2), t81 = rocker_m * (D_a * (D_at_x + t70)), D_v = READ(v, 2);
    /* rocker: momentum rate, eq. (35); momentum, eq. (31); velocities, eq. (6) */
    const REAL t87 = t70 * t81, t71 = D_v * t70, t78 = rocker_m * (D_a * t76), t88 = t76 * t78 + t87,
      rocker_momentum_px = rocker_m * (D_v * t76), t89 = rocker_Iyy * D_a + t88, rocker_twist_vz = D_at_x * D_v,
      t72 = rocker_twist_vz + t71, rocker_rate_at_O_my = rocker_twist_vz * rocker_momentum_px + t89;
    WRITE(momentum_rates, 16, rocker_rate_at_O_my);
    REAL checked0 = rocker_rate_at_O_my;
    const REAL rocker_rate_at_O_fz = t81 - D_v * rocker_momentum_px;
    WRITE(momentum_rates, 14, rocker_rate_at_O_fz);
    REAL checked1 = rocker_rate_at_O_fz;
    const REAL rocker_rate_at_O_fx = D_v * (rocker_m * t72) + t78;
    WRITE(momentum_rates, 12, rocker_rate_at_O_fx);
    REAL checked2 = rocker_rate_at_O_fx;
    const REAL crank_sin = SINES(sine, 0);
    /* coupler: geometry; momentum, eq. (31); momentum rate, eq. (35) */
    const REAL coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0), coupler_sin = SINES(sine, 1),
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin, t18 = k1 * coupler_rotation_xx,
      t24 = k2 * coupler_rotation_xx, minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      t22 = t18 - k2 * minus_coupler_rotation_xy, t26 = t24 + k1 * minus_coupler_rotation_xy, t37 = B_at_z * t22,
      t23 = coupler_com_x * t22, coupler_position_z = B_at_z * crank_cos,
      t39 = coupler_com_x * t26 - (coupler_position_z + t37), A_a = READ(a, 0), B_a = READ(a, 1), t27 = B_at_z *
          t26,
      coupler_twist_rate_wy = A_a + B_a, t40 = coupler_twist_rate_wy * t39, coupler_position_x = B_at_z * crank_sin,
      t29 = t23 + (coupler_position_x + t27), A_v = READ(v, 0), B_v = READ(v, 1),
      t42 = rocker_m * (B_a * coupler_position_z - B_v * (A_v * coupler_position_x) + t40), t53 = t39 * t42,
      t49 = coupler_twist_rate_wy * t29, t52 = coupler_Iyy * coupler_twist_rate_wy,
      t48 = B_v * (A_v * coupler_position_z), minus_coupler_twist_vx = B_v * coupler_position_z;
    /* coupler: momentum rate, eq. (35); velocities, eq. (6); momentum, eq. (31) */
    const REAL t51 = rocker_m * (B_a * coupler_position_x + t48 - t49), coupler_twist_vz = B_v * coupler_position_x,
      t56 = t52 + (t53 - t29 * t51), coupler_omega_z = A_v + B_v,
      minus_coupler_momentum_px = rocker_m * (minus_coupler_twist_vx + coupler_omega_z * t39),
      t57 = coupler_twist_vz * minus_coupler_momentum_px,
      coupler_momentum_pz = rocker_m * (coupler_twist_vz - coupler_omega_z * t29),
      coupler_rate_at_O_my = t56 - (t57 - minus_coupler_twist_vx * coupler_momentum_pz);
    WRITE(momentum_rates, 10, coupler_rate_at_O_my);
    REAL checked3 = coupler_rate_at_O_my;
    RESULT(checked0, momentum_rates, 8, coupler_omega_z * minus_coupler_momentum_px + t51);
    RESULT(checked1, momentum_rates, 6, coupler_omega_z * coupler_momentum_pz - t42);
    /* crank: momentum rate, eq. (35); momentum, eq. (31) */
    const REAL t1 = crank_com_z * crank_cos, t3 = 0.5 * (A_a * t1), t11 = t1 * t3, t8 = (-0.5) * (A_v * t1) * A_v,
      t4 = crank_com_z * crank_sin, t10 = 0.5 * (A_a * t4);
    RESULT(checked2, momentum_rates, 2, t8 - t10);
    const REAL t13 = t11 + t4 * t10;
    RESULT(checked3, momentum_rates, 0, t3 - A_v * (0.5 * (A_v * t4)));
    RESULT(checked0, momentum_rates, 4, t13 + crank_Ixx * A_a);
    WRITE(momentum_rates, 1, CONSTANT(0.0));
    WRITE(momentum_rates, 3, CONSTANT(0.0));
    WRITE(momentum_rates, 5, CONSTANT(0.0));
    WRITE(momentum_rates, 7, CONSTANT(0.0));
    WRITE(momentum_rates, 9, CONSTANT(0.0));
    WRITE(momentum_rates, 11, CONSTANT(0.0));
    WRITE(momentum_rates, 13, CONSTANT(0.0));
    WRITE(momentum_rates, 15, CONSTANT(0.0));
    WRITE(momentum_rates, 17, CONSTANT(0.0));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_energy)(size_t stride, const double *restrict q, const double *restrict v,
    double *restrict energy, const double *restrict sine, const double *restrict cosine,
    double *restrict total)
{
    (void)q;
    /* A: velocities, eq. (6) */
    const REAL A_v = READ(v, 0), coupler_omega_z = A_v + READ(v, 1), coupler_cos = SINES(cosine, 1),
      D_v = READ(v, 2), t1 = coupler_sxx * (coupler_omega_z * coupler_omega_z), /* coupler */
      t8 = A_v * (k8 * A_v + coupler_cos * (k9 * coupler_omega_z)), /* coupler */
      kinetic_energy = 0.5 * (t1 + (rocker_sxx * (D_v * D_v) + t8));
    WRITE(energy, 0, kinetic_energy);
    REAL checked0 = kinetic_energy;
    const REAL crank_cos = SINES(cosine, 0),
      t18 = k10 * crank_cos - k11 * (SINES(sine, 0) * SINES(sine, 1) - crank_cos * coupler_cos), /* potential */
      potential_energy = gravity_z_crank_mx * crank_cos + gravity_z_rocker_mx * SINES(cosine, 2) + gravity_z * t18;
    WRITE(energy, 1, potential_energy);
    REAL checked1 = potential_energy;
    FINITE(checked0 + checked1);
}

BODY(four_bar_mass_matrix)(size_t stride, const double *restrict q, double *restrict mass_matrix,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)sine;
    REAL checked0 = READ(q, 0);
    REAL checked1 = READ(q, 2);
    /* coupler: geometry */
    const REAL coupler_cos = SINES(cosine, 0), A_mass_matrix_by_A = k9 * coupler_cos + k12;
    WRITE(mass_matrix, 0, A_mass_matrix_by_A);
    REAL checked2 = A_mass_matrix_by_A;
    const REAL A_mass_matrix_by_B = coupler_sxx + k13 * coupler_cos;
    WRITE(mass_matrix, 1, A_mass_matrix_by_B);
    WRITE(mass_matrix, 3, A_mass_matrix_by_B);
    REAL checked3 = A_mass_matrix_by_B;
    WRITE(mass_matrix, 2, CONSTANT(0.0));
    WRITE(mass_matrix, 4, CONSTANT(coupler_sxx));
    WRITE(mass_matrix, 5, CONSTANT(0.0));
    WRITE(mass_matrix, 6, CONSTANT(0.0));
    WRITE(mass_matrix, 7, CONSTANT(0.0));
    WRITE(mass_matrix, 8, CONSTANT(rocker_sxx));
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(four_bar_bias)(size_t stride, const double *restrict q, const double *restrict v, double *restrict bias,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    REAL checked0 = READ(v, 2);
    /* rocker: momentum rate, eq. (35) */
    const REAL rocker_rate_mz = gravity_z_rocker_mx * SINES(sine, 2);
    WRITE(bias, 2, rocker_rate_mz);
    REAL checked1 = rocker_rate_mz;
    const REAL A_v = READ(v, 0), coupler_sin = SINES(sine, 1), crank_sin = SINES(sine, 0),
      t4 = coupler_sin * (B_at_z * (A_v * A_v) - gravity_z * SINES(cosine, 0)), /* coupler */
      coupler_rate_mz = k11 * (t4 - SINES(cosine, 1) * (gravity_z * crank_sin));
    WRITE(bias, 1, coupler_rate_mz);
    const REAL coupler_omega_z = A_v + READ(v, 1),
      t7 = coupler_rate_mz - B_at_z * (coupler_sin * (k11 * (coupler_omega_z * coupler_omega_z))), /* crank */
      crank_moment_z = t7 - k14 * crank_sin;
    WRITE(bias, 0, crank_moment_z);
    REAL checked2 = crank_moment_z;
    FINITE((checked0 + checked1) + checked2);
}

#if !defined(FOUR_BAR_VECTORS)

int four_bar_momentum_screws(const double *restrict q, const double *restrict v, double *restrict momenta,
    double *restrict total_)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_momentum_screws_body(1, q, v, momenta, total_, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(momenta, 18);
        four_bar_set_nan(total_, 6);
    }
    return outcome;
}

int four_bar_momentum_rates(const double *restrict q, const double *restrict v, const double *restrict a,
    double *restrict momentum_rates)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_momentum_rates_body(1, q, v, a, momentum_rates, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(momentum_rates, 18);
    }
    return outcome;
}

int four_bar_energy(const double *restrict q, const double *restrict v, double *restrict energy)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines6(q, sine, cosine);
    const int outcome = four_bar_energy_body(1, q, v, energy, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(energy, 2);
    }
    return outcome;
}

int four_bar_mass_matrix(const double *restrict q, double *restrict mass_matrix)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines8(q, sine, cosine);
    const int outcome = four_bar_mass_matrix_body(1, q, mass_matrix, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(mass_matrix, 9);
    }
    return outcome;
}

int four_bar_bias(const double *restrict q, const double *restrict v, double *restrict bias)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines9(q, sine, cosine);
    const int outcome = four_bar_bias_body(1, q, v, bias, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(bias, 3);
    }
    return outcome;
}
#endif /* FOUR_BAR_VECTORS */
