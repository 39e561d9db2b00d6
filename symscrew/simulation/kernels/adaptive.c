/* Error estimates, and states within a step. */

/* The part of the fastest rate by which another one counts as one of that size: where motions take microseconds, errors
 * of a rate that passes zero would else be held below the rounding of the others. */
#define FAST 1e-2

/* What a rate counts for at least, without units: one a second, or a part of the fastest. */
static double least_rate(const Step *s)
{
    double most = 1.0;
    for (int i = 0; i < NV; ++i) {
        most = fmax(most, FAST * fmax(fabs(s->start[NV + i]), fabs(s->end[NV + i])) / UNIT[i]);
    }
    return most;
}

static double weight(const Step *s, int i, double rtol, double atol, double least)
{
    if (i < NV) {
        return (atol + rtol) * UNIT[i]; /* angles grow with every turn, their errors should not */
    }
    const double size = fmax(fabs(s->start[i]), fabs(s->end[i]));
    return (i < 2 * NV ? atol * least * UNIT[i - NV] : atol) + rtol * size;
}

static double dop853_error(const Step *s, double rtol, double atol)
{
    const double least = least_rate(s);
    double fifth = 0.0, third = 0.0;
    for (int i = 0; i < NY - PASSIVE; ++i) {
        const double(*k)[NY1] = s->k, scale = weight(s, i, rtol, atol, least);
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

/* The dense output (NY) at a part of the step. */
static void dense_values(const Step *s, double part, double *y)
{
    for (int i = 0; i < NY; ++i) {
        double value = 0.0;
        for (int j = 6; j >= 0; --j) {
            value = (value + s->dense[j][i]) * (j % 2 == 0 ? part : 1.0 - part);
        }
        y[i] = s->start[i] + value;
    }
}

#if WORKS
#define SHARP 2      /* of dense_ready: the work within the step is integrated along the dense output, too */
#define BLURRED 100.0 /* local tolerances by which the work may be off before it is integrated along the dense output */
/* Gauss's places and weights of eight points on 0 to 1: exact for polynomials of degree 15. */
static const double GAUSS[8][2] = {
    {0.019855071751231912, 0.05061426814518853},
    {0.10166676129318664, 0.11119051722668721},
    {0.2372337950418355, 0.15685332293894344},
    {0.4082826787521751, 0.18134189168918083},
    {0.5917173212478248, 0.18134189168918083},
    {0.7627662049581645, 0.15685332293894344},
    {0.8983332387068134, 0.11119051722668721},
    {0.9801449282487681, 0.05061426814518853}};

/* The power over the state within a step, from its start to a part of it. */
static int work_within(const Step *s, double part, double *work)
{
    double y[NY1], x_dot[NX1];
    *work = 0.0;
    for (int n = 0; n < 8; ++n) {
        const double at = part * GAUSS[n][0], when = s->t + at * s->h;
        double q[NQ1];
        dense_values(s, at, y);
        retract(s->base, y, q);
        if (rates_at(s->until > 0.0 && when > s->until ? s->until : when, q, y + NV, y + 2 * NV, x_dot) > 0) {
            return FAILED;
        }
        *work += part * s->h * GAUSS[n][1] * x_dot[NX - 1];
    }
    return 0;
}

/* The work of an accepted step, which no step is shortened for: where its own error shows, it follows from the dense
 * output. Drives that are polynomials of time leave no other error: steps grow without end, and so did that of the work. */
static void sharpen_work(Step *s, int method, double tolerance)
{
    const int i = NY - 1;
    const double(*k)[NY1] = s->k;
    double most = fmax(fabs(s->start[i]), fabs(s->end[i])), work;
    for (int j = 0; j < 13; ++j) {
        most = fmax(most, fabs(s->h * k[j][i]));
    }
    if (s->careful || !(fabs(s->h * (DOP853_ERROR_5(i))) > BLURRED * tolerance * most)) {
        return;
    }
    if (prepare_dense(s, method) == 0 && work_within(s, 1.0, &work) == 0) {
        s->end[i] = s->start[i] + work;
        s->x[NX - 1] = s->end[i];
        s->dense_ready = SHARP;
    }
}
#endif

/* The state at time t within the step, on the manifold. */
static int state_within(Step *s, int method, double t, double *q, double *v, double *x, double *pivot)
{
    const int outcome = prepare_dense(s, method);
    if (outcome != 0) {
        return outcome;
    }
    const double part = ((t - s->t) - s->rest) / s->h;
    double y[NY1];
    dense_values(s, part, y);
    memcpy(x, y + 2 * NV, sizeof(double) * NX);
#if WORKS
    double work;
    if (s->dense_ready == SHARP && work_within(s, part, &work) == 0) {
        x[NX - 1] = s->start[NY - 1] + work;
    }
#endif
#if NR && FREE
    if (s->careful) {
        return near_state(s, t, y, q, v, NULL, NULL, pivot);
    }
#endif
    retract(s->base, y, q);
    memcpy(v, y + NV, sizeof(double) * NV);
    return settle(q, v, pivot);
}
