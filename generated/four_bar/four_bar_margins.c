/*
 * four_bar: margins.
 *   limb_margins; constraint_margin; actuation_margins
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

BODY(four_bar_limb_margins)(size_t stride, const double *restrict q, double *restrict margins,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)cosine;
    REAL checked0 = READ(q, 0);
    REAL checked1 = READ(q, 2);
    /* rocker: results */
    const REAL rocker_margins = k25 * SINES(sine, 0);
    WRITE(margins, 0, rocker_margins);
    REAL checked2 = rocker_margins;
    FINITE((checked0 + checked1) + checked2);
}

BODY(four_bar_constraint_margin)(size_t stride, const double *restrict q, double *restrict margins,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_sin = SINES(sine, 1), crank_cos = SINES(cosine, 0),
      coupler_cos = SINES(cosine, 1), minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos,
      minus_rocker_joint_force_my_by_C_fz = k6 * SINES(cosine, 2),
      t13 = minus_coupler_rotation_xy * minus_rocker_joint_force_my_by_C_fz, /* C */
      coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin,
      t5 = coupler_rotation_xx * minus_rocker_joint_force_my_by_C_fz, /* C */
      minus_rocker_joint_force_mx_by_C_fz = k6 * SINES(sine, 2),
      C_closure_fy_by_D = t13 + coupler_rotation_xx * minus_rocker_joint_force_mx_by_C_fz,
      minus_C_closure_fx_by_D = t5 - minus_coupler_rotation_xy * minus_rocker_joint_force_mx_by_C_fz,
      t16 = per_length_B_at_z * (coupler_sin * C_closure_fy_by_D), /* rocker */
      t21 = per_length * (t16 + minus_C_closure_fx_by_D * (per_length * (0.5 + B_at_z * coupler_cos))), /* rocker */
      t22 = t21 * t21, /* rocker */
      t9 = k26 * minus_C_closure_fx_by_D, /* C */
      t10 = t9 * t9, /* C */
      t11 = k25 * coupler_sin, /* coupler */
      rocker_margins = t10 + (t11 * t11 + t22);
    WRITE(margins, 0, rocker_margins);
    REAL checked0 = rocker_margins;
    FINITE(checked0);
}

BODY(four_bar_actuation_margins)(size_t stride, const double *restrict q, double *restrict margins,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0),
      coupler_sin = SINES(sine, 1),
      t5 = SINES(cosine, 2) * (crank_sin * coupler_cos + crank_cos * coupler_sin), /* all drives */
      all_drives_margins = k27 * (t5 - SINES(sine, 2) * (crank_sin * coupler_sin - crank_cos * coupler_cos));
    WRITE(margins, 0, all_drives_margins);
    REAL checked0 = all_drives_margins;
    FINITE(checked0);
}

#if !defined(FOUR_BAR_VECTORS)

int four_bar_limb_margins(const double *restrict q, double *restrict margins)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines12(q, sine, cosine);
    const int outcome = four_bar_limb_margins_body(1, q, margins, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(margins, 1);
    }
    return outcome;
}

int four_bar_constraint_margin(const double *restrict q, double *restrict margins)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_constraint_margin_body(1, q, margins, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(margins, 1);
    }
    return outcome;
}

int four_bar_actuation_margins(const double *restrict q, double *restrict margins)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines1(q, sine, cosine);
    const int outcome = four_bar_actuation_margins_body(1, q, margins, sine, cosine, NULL);
    if (outcome != 0) {
        four_bar_set_nan(margins, 1);
    }
    return outcome;
}
#endif /* FOUR_BAR_VECTORS */
