/* One step of every method, over y = (local coordinates z, rates v, states x). */

#if !defined(CHARTS) /* whether steps near singular configurations follow charts of the branch (chart.c, branch.c) */
#define CHARTS (NR && FREE)
#endif

#if !defined(SLOPES) /* how many are kept: all that the method with the most of them has, and what dense output needs */
#define SLOPES 16
#define DENSE 8
#endif

enum { EULER, SEMI_IMPLICIT_EULER, RK4, RK8, DOP853 };

/* The branch in extended precision (precise.c), where the caller has it compiled; else NULL. */
typedef struct {
    int (*anchor)(const double *q, const double *v, const int *modes, double *base);
    int (*state)(double t, const double *y, double *q, double *v, double *dv, double *dx, double *smallest);
} Precise;

typedef struct {
    int careful;
    double base[NQ1];
    Precise precise;
#if CHARTS
    Chart chart;
#endif
    const double *u;      /* drives held by the caller, or NULL */
    double t, h, rest;    /* the step begins at t + rest: what rounding left of the time */
    double until;         /* the step ends where inputs change at once: nothing is evaluated later than this; 0: it does not */
    double start[NY1], end[NY1];
    double k[SLOPES][NY1]; /* slopes; 12 is that at the end */
    double q[NQ1], v[NV1], x[NX1], pivot; /* the state at the end, on the manifold */
    double dense[DENSE][NY1];
    int dense_ready;
    double error;
} Step;

#if CHARTS
/* The branch over y = (local coordinates, rates, states): q, v and, if dv is not NULL, slopes. */
static int near_state(const Step *s, double t, const double *y, double *q, double *v, double *dv, double *dx,
                      double *pivot)
{
    if (s->precise.state != NULL) {
        return s->precise.state(t, y, q, v, dv, dx, pivot);
    }
    return branch_state(&s->chart, t, y, y + NV, y + 2 * NV, q, v, dv, dx, pivot, s->u);
}
#endif

static int slope(Step *s, double t, const double *y, double *dy)
{
    double q[NQ1];
    COUNT_EVALUATION;
    t = s->until > 0.0 && t > s->until ? s->until : t;
#if CHARTS
    if (s->careful) {
        double v[NV1], z[NV1], pivot;
        const int outcome = near_state(s, t, y, q, v, dy + NV, dy + 2 * NV, &pivot);
        if (outcome == 0) {
            local_coordinates(s->base, q, z);
            local_rates(z, v, dy);
        }
        return outcome;
    }
#endif
    retract(s->base, y, q);
    local_rates(y, y + NV, dy);
    return valid(forces_at(t, q, y + NV, y + 2 * NV, s->u, dy + NV, dy + 2 * NV));
}

#define EACH(expression)                                                                                               \
    for (int i = 0; i < NY; ++i) {                                                                                     \
        y[i] = s->start[i] + h * (expression);                                                                         \
    }
#define STAGE(target, c)                                                                                               \
    outcome = slope(s, s->t + (c) * h, y, k[target]);                                                                  \
    if (outcome != 0) {                                                                                        \
        return outcome;                                                                                                \
    }

static int runge_kutta_4(Step *s)
{
    const double h = s->h;
    double(*k)[NY1] = s->k, y[NY1];
    int outcome;
    EACH(0.5 * k[0][i])
    STAGE(1, 0.5)
    EACH(0.5 * k[1][i])
    STAGE(2, 0.5)
    EACH(k[2][i])
    STAGE(3, 1.0)
    EACH((k[0][i] + k[3][i]) / 6.0 + (k[1][i] + k[2][i]) / 3.0)
    memcpy(s->end, y, sizeof s->end);
    return 0;
}

static int euler(Step *s, int semi_implicit)
{
    const double h = s->h;
    double(*k)[NY1] = s->k, y[NY1];
    EACH(k[0][i])
    if (semi_implicit) {
        double rates[NV1];
        local_rates(s->start, y + NV, rates);
        for (int i = 0; i < NV; ++i) {
            y[i] = s->start[i] + h * rates[i];
        }
    }
    memcpy(s->end, y, sizeof s->end);
    return 0;
}

/* Dormand and Prince's method of order 8 with error estimates of orders 5 and 3 (Hairer, Norsett, Wanner, Solving
 * Ordinary Differential Equations I, 2nd ed., II.10). */
static int dop853(Step *s)
{
    const double h = s->h;
    double(*k)[NY1] = s->k, y[NY1];
    int outcome;
#include "dop853_stages.c"
    memcpy(s->end, y, sizeof s->end);
    return 0;
}

/* Rates and states that matter no more are zero: they and their products would become denormal numbers, which take
 * many times as long, once a motion has died down or when it starts with such rates. */
static void without_dust(double *values, int count)
{
    for (int k = 0; k < count; ++k) {
        values[k] = fabs(values[k]) < DUST ? 0.0 : values[k];
    }
}

/* From end to a state on the manifold. */
static int finish(Step *s)
{
    without_dust(s->end + NV, NY - NV);
    memcpy(s->x, s->end + 2 * NV, sizeof(double) * NX);
#if CHARTS
    if (s->careful) {
        const double end = s->until > 0.0 && s->t + s->h > s->until ? s->until : s->t + s->h;
        const int outcome = near_state(s, end, s->end, s->q, s->v, NULL, NULL, &s->pivot);
        local_coordinates(s->base, s->q, s->end);
        memcpy(s->end + NV, s->v, sizeof(double) * NV);
        return outcome;
    }
#endif
    retract(s->base, s->end, s->q);
    memcpy(s->v, s->end + NV, sizeof(double) * NV);
    const int outcome = settle(s->q, s->v, &s->pivot);
    if (outcome == 0 && NR) {
        local_coordinates(s->base, s->q, s->end);
        memcpy(s->end + NV, s->v, sizeof(double) * NV);
    }
    return outcome;
}

static int take(Step *s, int method)
{
    int outcome;
    s->dense_ready = 0;
    switch (method) {
    case EULER: outcome = euler(s, 0); break;
    case SEMI_IMPLICIT_EULER: outcome = euler(s, 1); break;
    case RK4: outcome = runge_kutta_4(s); break;
    default: outcome = dop853(s); break;
    }
    return outcome == 0 ? finish(s) : outcome;
}
