/* The start of a run onto the loops.
 *
 * Near a singular configuration one that is on them to rounding stays as it was given: what moves there is known to
 * rounding by the pivot, and a correction would take it as far off. One that is not, and that the correction moves by
 * more than MAGNIFIED times what was open, is VAGUE: of seven digits there would be left four, and which motion was meant
 * is not known.
 */
#define VAGUE 1005
#define MAGNIFIED 1e3

#if NR
static int settled_start(double *q, double *v, double *pivot)
{
    Opening o;
    double given[NQ1], rates[NV1], missed[NR], z[NV1], fastest = 0.0, moved = 0.0, changed = 0.0;
    memcpy(given, q, sizeof(double) * NQ);
    memcpy(rates, v, sizeof(double) * NV);
    const int outcome = settle(q, v, pivot);
    if (outcome != 0 || *pivot >= CAREFUL || opening(given, &o) != 0) {
        return outcome;
    }
    closure_rates(&o, rates, missed);
    local_coordinates(given, q, z);
    for (int k = 0; k < NV; ++k) {
        fastest = fmax(fastest, fabs(rates[k]) / UNIT[k]);
        moved = fmax(moved, fabs(z[k]) / UNIT[k]);
        changed = fmax(changed, fabs(v[k] - rates[k]) / UNIT[k]);
    }
    const double open = largest(o.residual, NR), wrong = largest(missed, NR), rounding = 0.1 * nearly_closed(given);
    if (open <= rounding && wrong <= CLOSED * fastest) {
        memcpy(q, given, sizeof(double) * NQ);
        memcpy(v, rates, sizeof(double) * NV);
        return 0;
    }
    const double known = fmax(open, rounding); /* of places, and of what the loops ask of rates there */
    return moved > MAGNIFIED * known || changed > MAGNIFIED * fmax(wrong, known * fastest) ? VAGUE : 0;
}
#else
static int settled_start(double *q, double *v, double *pivot)
{
    return settle(q, v, pivot);
}
#endif
