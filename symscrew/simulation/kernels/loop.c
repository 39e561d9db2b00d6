/* One step of fixed size for real time: no allocation, no state kept, bounded work. */

static int one_step(double dt, double t, double *q, double *v, double *x, const double *u, int careful)
{
    Step s;
    double z[NV1] = {0.0};
    int outcome = 0;
    memset(&s, 0, sizeof s);
    s.careful = careful;
    s.u = u;
    s.t = t;
    s.h = dt;
    memcpy(s.base, q, sizeof(double) * NQ);
#if NR && FREE
    if (careful) {
        outcome = anchored(q, v, &s.chart);
        if (outcome != 0) {
            return outcome;
        }
        memcpy(s.base, s.chart.base, sizeof(double) * NQ);
        local_coordinates(s.base, q, z);
    }
#endif
    memcpy(s.start, z, sizeof(double) * NV);
    memcpy(s.start + NV, v, sizeof(double) * NV);
    if (NX) {
        memcpy(s.start + 2 * NV, x, sizeof(double) * NX);
    }
    outcome = slope(&s, t, s.start, s.k[0]);
    if (outcome == 0) {
        outcome = take(&s, METHOD);
    }
    if (outcome == 0 && !careful && s.pivot < CAREFUL && NR && FREE) {
        return NEEDS_CARE;
    }
    if (outcome == 0) {
        memcpy(q, s.q, sizeof(double) * NQ);
        memcpy(v, s.v, sizeof(double) * NV);
        if (NX) {
            memcpy(x, s.x, sizeof(double) * NX);
        }
    }
    return outcome;
}

int LOOP_STEP(double dt, double t, double *q, double *v, double *x, const double *u)
{
    (void)UNIT; /* of open chains nothing is scaled */
    (void)ROW_SCALE;
    int outcome = one_step(dt, t, q, v, x, u, 0);
    if (outcome != 0 && NR && FREE) {
        outcome = one_step(dt, t, q, v, x, u, 1);
    }
    return outcome == 0 ? 0 : outcome == AT_REST ? 2 : 1;
}
