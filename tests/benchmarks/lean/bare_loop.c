/* DOP853 with projection and nothing else: no pivots, no crossings, no breaks of inputs, no care near singular places.
 *
 * Stands behind the generated functions, rows.c and manifold.c, as the kernels of `simulate` do; what it is compared
 * with is the same mathematics with all that a run watches. */
typedef struct {
    double t, h, base[NQ1], start[NY1], end[NY1], k[16][NY1], dense[8][NY1];
} Step;

static int slope(Step *s, double t, const double *y, double *dy)
{
    double q[NQ1];
    retract(s->base, y, q);
    local_rates(y, y + NV, dy);
    return valid(forces_at(t, q, y + NV, y + 2 * NV, NULL, dy + NV, dy + 2 * NV));
}

#define EACH(expression)                                                                                               \
    for (int i = 0; i < NY; ++i) {                                                                                     \
        y[i] = s->start[i] + h * (expression);                                                                         \
    }
#define STAGE(target, c)                                                                                               \
    outcome = slope(s, s->t + (c) * h, y, k[target]);                                                                  \
    if (outcome != 0) {                                                                                                \
        return outcome;                                                                                                \
    }

static int stages(Step *s)
{
    const double h = s->h;
    double(*k)[NY1] = s->k, y[NY1];
    int outcome;
#include "dop853_stages.c"
    memcpy(s->end, y, sizeof s->end);
    return 0;
}

static int dense_output(Step *s)
{
    const double h = s->h;
    double(*k)[NY1] = s->k, y[NY1];
    int outcome = 0;
#include "dop853_dense.c"
    return outcome;
}

static double error_of(const Step *s, double tolerance)
{
    double fifth = 0.0, third = 0.0;
    for (int i = 0; i < NY - PASSIVE; ++i) {
        const double(*k)[NY1] = s->k, size = fmax(fabs(s->start[i]), fabs(s->end[i]));
        const double unit = i < 2 * NV ? UNIT[i % NV] : 1.0;
        const double scale = i < NV ? 2.0 * tolerance * unit : tolerance * (unit + size);
        const double five = DOP853_ERROR_5(i) / scale, three = DOP853_ERROR_3(i) / scale;
        fifth += five * five;
        third += three * three;
    }
    const double both = fifth + 0.01 * third;
    return both > 0.0 ? fabs(s->h) * fifth / sqrt(both * (NY - PASSIVE)) : 0.0;
}

/* From q, v, x to all output times, the first of which is that of the start. Steps taken, or -1. */
long bare_run(const double *q0, const double *v0, const double *x0, double h, double tolerance, const double *times,
              size_t count, double *q, double *v, double *x)
{
    static Step step;
    Step *s = &step;
    double at[NQ1], rate[NV1], state[NX1], pivot, y[NY1];
    size_t written = 0;
    long steps = 0;
    memset(s, 0, sizeof *s);
    memcpy(at, q0, sizeof(double) * NQ);
    memcpy(rate, v0, sizeof(double) * NV);
    memcpy(state, x0, sizeof(double) * NX);
    s->t = times[0];
    if (settle(at, rate, &pivot) != 0) {
        return -1;
    }
    for (int fresh = 1;; fresh = 0) {
        memcpy(s->base, at, sizeof(double) * NQ);
        memset(s->start, 0, sizeof(double) * NV);
        memcpy(s->start + NV, rate, sizeof(double) * NV);
        memcpy(s->start + 2 * NV, state, sizeof(double) * NX);
        if (fresh) {
            memcpy(q, at, sizeof(double) * NQ);
            memcpy(v, rate, sizeof(double) * NV);
            memcpy(x, state, sizeof(double) * NX);
            written = 1;
            if (slope(s, s->t, s->start, s->k[0]) != 0) {
                return -1;
            }
        } else {
            memcpy(s->k[0], s->k[12], sizeof s->k[0]);
            local_rates(s->start, rate, s->k[0]);
        }
        if (written == count) {
            return steps;
        }
        for (double error = 2.0; !(error < 1.0);) {
            s->h = h;
            if (!(h > 1e-14) || stages(s) != 0) {
                return -1;
            }
            error = error_of(s, tolerance);
            h *= fmin(error < 1.0 ? 2.0 : 0.9, fmax(0.333, 0.9 * pow(fmax(error, 1e-8), -0.125)));
        }
        ++steps;
        retract(s->base, s->end, at);
        memcpy(rate, s->end + NV, sizeof(double) * NV);
        memcpy(state, s->end + 2 * NV, sizeof(double) * NX);
        if (settle(at, rate, &pivot) != 0) {
            return -1;
        }
        local_coordinates(s->base, at, s->end);
        memcpy(s->end + NV, rate, sizeof(double) * NV);
        if (slope(s, s->t + s->h, s->end, s->k[12]) != 0) {
            return -1;
        }
        const int inside = times[written] <= s->t + s->h;
        if (inside && dense_output(s) != 0) {
            return -1;
        }
        for (; written < count && times[written] <= s->t + s->h; ++written) {
            const double part = (times[written] - s->t) / s->h;
            for (int i = 0; i < NY; ++i) {
                double value = 0.0;
                for (int j = 6; j >= 0; --j) {
                    value = (value + s->dense[j][i]) * (j % 2 == 0 ? part : 1.0 - part);
                }
                y[i] = s->start[i] + value;
            }
            retract(s->base, y, q + written * NQ);
            memcpy(v + written * NV, y + NV, sizeof(double) * NV);
            memcpy(x + written * NX, y + 2 * NV, sizeof(double) * NX);
            if (settle(q + written * NQ, v + written * NV, &pivot) != 0) {
                return -1;
            }
        }
        s->t += s->h;
    }
}
