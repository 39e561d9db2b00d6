/* Where a chart of the branch is anchored. */
#if NR && FREE

/* A regular configuration near (q, v): q itself, or one a little before or behind on the way. */
static int anchored(const double *q, const double *v, Chart *c)
{
    Opening o;
    Rows f;
    double size = 0.0, at[NQ1], z[NV1], still[NV1] = {0.0}, here = 0.0, smallest;
    for (int k = 0; k < NV; ++k) {
        size += (v[k] / UNIT[k]) * (v[k] / UNIT[k]);
    }
    size = sqrt(size);
    c->scale = 1.0;
    if (size > 0.0) {
        double most = 0.0;
        for (int k = 0; k < NV; ++k) {
            most = fmax(most, fabs(v[k] / UNIT[k]));
        }
        c->scale = size / most;
    }
    double sign = -1.0, rate = 0.0;
    c->slope = 0.5 * PIVOT / c->scale;
    for (int step = 0; step < 17; ++step) {
        const double distance = sign * (step % 2 == 0 ? -1.0 : 1.0) * ((step + 1) / 2);
        memcpy(at, q, sizeof(double) * NQ);
        if (step > 0) {
            if (!(size > 0.0)) {
                return AT_REST;
            }
            const double length = fmax(0.02 * c->scale, fmin(0.1 * c->scale, rate > 0.0 ? 1.6 * ZONE / rate : 0.0));
            for (int k = 0; k < NV; ++k) {
                z[k] = v[k] / size * length * distance;
            }
            retract(q, z, at);
            if (settle(at, still, &smallest) != 0) {
                continue;
            }
        }
        if (opening(at, &o) != 0) {
            return FAILED;
        }
        row_space(&o, RANK_FLOOR, &f);
        const int regular = f.smallest > 1.5 * ZONE;
        int outcome = 0;
        if (regular) {
            memcpy(c->base, at, sizeof(double) * NQ);
            outcome = tangent_space(&f, c->tangent);
        }
        if (step == 0 && size > 0.0) { /* away from the singular configuration first */
            here = f.smallest;
            for (int k = 0; k < NV; ++k) {
                z[k] = v[k] / size * 1e-6;
            }
            retract(q, z, at);
            if (opening(at, &o) != 0) {
                return FAILED;
            }
            row_space(&o, RANK_FLOOR, &f);
            rate = fabs(f.smallest - here) / 1e-6;
            sign = f.smallest > here ? 1.0 : -1.0;
            c->slope = fmin(fmax(rate * c->scale / PIVOT, 0.04), 6.0) * PIVOT / c->scale;
        }
        if (regular) {
            return outcome;
        }
    }
    return FAILED;
}
#endif
