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
    const REAL rocker_margins = k21 * SINES(sine, 0);
    WRITE(margins, 0, rocker_margins);
    REAL checked2 = rocker_margins;
    FINITE((checked0 + checked1) + checked2);
}

BODY(four_bar_constraint_margin)(size_t stride, const double *restrict q, double *restrict margins,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_sin = SINES(sine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_cos = SINES(cosine, 1);
    const REAL minus_coupler_rotation_xy = crank_sin * coupler_sin - crank_cos * coupler_cos;
    const REAL t8 = k6 * SINES(cosine, 2); /* rocker */
    const REAL t9 = minus_coupler_rotation_xy * t8; /* C */
    const REAL coupler_rotation_xx = crank_sin * coupler_cos + crank_cos * coupler_sin;
    const REAL t16 = coupler_rotation_xx * t8; /* C */
    const REAL t12 = k6 * SINES(sine, 2); /* rocker */
    const REAL C_closure_fy_by_D = t9 + coupler_rotation_xx * t12;
    const REAL minus_C_closure_fx_by_D = t16 - minus_coupler_rotation_xy * t12;
    const REAL t15 = per_length_B_at_z * coupler_sin * (per_length * C_closure_fy_by_D); /* rocker */
    const REAL t18 = per_length * minus_C_closure_fx_by_D; /* C */
    const REAL t25 = k22 * minus_C_closure_fx_by_D; /* C */
    const REAL t26 = t25 * t25; /* C */
    const REAL t22 = t15 + t18 * (per_length * (0.5 + B_at_z * coupler_cos)); /* rocker */
    const REAL t23 = t22 * t22; /* rocker */
    const REAL t2 = k21 * coupler_sin; /* coupler */
    const REAL rocker_margins = t2 * t2 + t23 + t26;
    WRITE(margins, 0, rocker_margins);
    REAL checked0 = rocker_margins;
    FINITE(checked0);
}

BODY(four_bar_actuation_margins)(size_t stride, const double *restrict q, double *restrict margins,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    (void)q;
    /* crank: geometry */
    const REAL crank_sin = SINES(sine, 0), coupler_cos = SINES(cosine, 1), crank_cos = SINES(cosine, 0);
    const REAL coupler_sin = SINES(sine, 1);
    const REAL t6 = (crank_sin * coupler_cos + crank_cos * coupler_sin) * (k6 * SINES(cosine, 2)); /* C */
    const REAL minus_C_closure_fx_by_D = t6 - (crank_sin * coupler_sin - crank_cos * coupler_cos) * (k6 * SINES(sine, 2));
    const REAL all_drives_margins = k22 * minus_C_closure_fx_by_D;
    WRITE(margins, 0, all_drives_margins);
    REAL checked0 = all_drives_margins;
    FINITE(checked0);
}

#if !defined(FOUR_BAR_VECTORS)

int four_bar_limb_margins(const double *restrict q, double *restrict margins)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    four_bar_sines7(q, sine, cosine);
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
