/* Error estimates, and states within a step. */

static double weight(const Step *s, int i, double rtol, double atol)
{
    if (i < NV) {
        return (atol + rtol) * UNIT[i]; /* angles grow with every turn, their errors should not */
    }
    const double size = fmax(fabs(s->start[i]), fabs(s->end[i]));
    return (i < 2 * NV ? atol * UNIT[i - NV] : atol) + rtol * size;
}

static double dop853_error(const Step *s, double rtol, double atol)
{
    double fifth = 0.0, third = 0.0;
    for (int i = 0; i < NY - PASSIVE; ++i) {
        const double(*k)[NY1] = s->k, scale = weight(s, i, rtol, atol);
        const double five = DOP853_ERROR_5(i) / scale, three = DOP853_ERROR_3(i) / scale;
        fifth += five * five;
        third += three * three;
    }
    const double both = fifth + 0.01 * third;
    return both > 0.0 ? fabs(s->h) * fifth / sqrt(both * (NY - PASSIVE)) : 0.0;
}

/* The slope at the end, which is the first of the next step too. */
static int last_slope(Step *s)
{
    return slope(s, s->t + s->h, s->end, s->k[12]);
}

static int prepare_dense(Step *s, int method)
{
    const double h = s->h;
    double(*k)[NY1] = s->k, y[NY1];
    int outcome = 0;
    if (s->dense_ready) {
        return 0;
    }
    if (method == DOP853) {
#include "dop853_dense.c"
    } else {
        for (int i = 0; i < NY; ++i) { /* the cubic through both ends */
            const double change = s->end[i] - s->start[i];
            s->dense[0][i] = change;
            s->dense[1][i] = h * k[0][i] - change;
            s->dense[2][i] = 2.0 * change - h * (k[12][i] + k[0][i]);
            for (int j = 3; j < 7; ++j) {
                s->dense[j][i] = 0.0;
            }
        }
    }
    s->dense_ready = 1;
    return outcome;
}

/* The state at time t within the step, on the manifold. */
static int state_within(Step *s, int method, double t, double *q, double *v, double *x, double *pivot)
{
    const int outcome = prepare_dense(s, method);
    if (outcome != 0) {
        return outcome;
    }
    const double part = ((t - s->t) - s->rest) / s->h;
    double y[NY1];
    for (int i = 0; i < NY; ++i) {
        double value = 0.0;
        for (int j = 6; j >= 0; --j) {
            value = (value + s->dense[j][i]) * (j % 2 == 0 ? part : 1.0 - part);
        }
        y[i] = s->start[i] + value;
    }
    memcpy(x, y + 2 * NV, sizeof(double) * NX);
#if NR && FREE
    if (s->careful) {
        return near_state(s, t, y, q, v, NULL, NULL, pivot);
    }
#endif
    retract(s->base, y, q);
    memcpy(v, y + NV, sizeof(double) * NV);
    return settle(q, v, pivot);
}
