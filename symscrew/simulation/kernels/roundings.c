/*
 * Whether accelerations are good: where no pivot is small, and where two evaluations with different roundings are no
 * farther apart than those of regular states.
 */
static int regular_pivots(const double *pivot)
{
    int regular = 1;
    for (int k = 0; k < PIVOTS; ++k) {
        regular &= fabs(pivot[k]) > REGULAR_PIVOT[k];
    }
    return regular;
}

static int as_usual(const double *a, const double *turned)
{
    double apart = 0.0, size = 0.0;
    for (int k = 0; k < NV; ++k) {
        const double moved = fabs(a[k] - turned[k]) / UNIT[k];
        apart = moved <= apart ? apart : moved; /* NaN is larger than all */
        size = fmax(size, fabs(a[k]) / UNIT[k]);
    }
    return apart <= fmax(APART, APART_OF_SIZE * size);
}
