/* Steps end where a condition of the slopes changes its sign (switches.py): across such a corner an error estimate may
 * be blind, however small the tolerance. A step that would pass one is taken once more, up to the zero of its
 * polynomial, and so on as by Newton: what is left behind the corner spoils that zero less each time. */
#if SWITCHES
#define LANDINGS 8 /* takes of a step for one corner: the zero moves by squares, three are usual */
#define TOUCH 0.03 /* of what a condition moves in a step: so near to zero its turning is looked at by a step of its own */
#define CREDIT 20  /* short steps onto corners in a row; then every other step passes them: work stays bounded */

/* Conditions at y over the base of the step, not put back onto the loops: that is a change within its error. */
static int conditions(const Step *s, double t, const double *y, double *g)
{
    double q[NQ1];
#if CHARTS
    if (s->careful) {
        double v[NV1], pivot;
        const int outcome = near_state(s, t, y, q, v, NULL, NULL, &pivot);
        return outcome != 0 ? outcome : switches_at(t, q, v, y + 2 * NV, g);
    }
#endif
    retract(s->base, y, q);
    return switches_at(t, q, y + NV, y + 2 * NV, g);
}

/* What rounding of the state leaves of the conditions: their change with it, by directions that nothing else has. */
static int rounding_of(const Step *s, double t, const double *y, const double *g, double *noise)
{
    double other[NY1], size = 0.0;
    for (int i = 0; i < NY; ++i) {
        const double unit = i < NV ? UNIT[i] : i < 2 * NV ? UNIT[i - NV] : 0.0;
        size = 0.618034 * (i + 1);
        size = 0.5 + (size - floor(size));
        other[i] = y[i] + (i % 2 == 0 ? 4e-15 : -4e-15) * size * fmax(fabs(y[i]), unit);
    }
    const int outcome = conditions(s, t, other, noise);
    for (int k = 0; k < SWITCHES; ++k) {
        noise[k] = fabs(noise[k] - g[k]);
    }
    return outcome;
}

/* Whether no condition can reach zero in the step: the cubics through both ends with their rates stay away from it by
 * more than half of what they move. */
static int conditions_are_far(const Step *s, const double *first, const double *last)
{
    const double part = 1e-3, h = s->h;
    double y[NY1], near_first[SWITCHES], near_last[SWITCHES];
    for (int i = 0; i < NY; ++i) {
        y[i] = s->start[i] + part * h * s->k[0][i];
    }
    if (conditions(s, s->t + part * h, y, near_first) != 0) {
        return 0;
    }
    for (int i = 0; i < NY; ++i) {
        y[i] = s->end[i] - part * h * s->k[12][i];
    }
    if (conditions(s, s->t + (1.0 - part) * h, y, near_last) != 0) {
        return 0;
    }
    for (int k = 0; k < SWITCHES; ++k) {
        const double a = first[k], b = a + (near_first[k] - a) / (3.0 * part), d = last[k];
        const double c = d + (near_last[k] - d) / (3.0 * part);
        const double low = fmin(fmin(a, b), fmin(c, d)), high = fmax(fmax(a, b), fmax(c, d));
        if (!(fmax(low, -high) > 0.5 * (high - low))) {
            return 0;
        }
    }
    return 1;
}

/* The first zero of p behind the start, whose value there counts as zero up to `slack`; 2: none. */
static double first_change(const Polynomial *p, double slack)
{
    double b[SAMPLES];
    const int zero = fabs(p->c[0]) <= slack;
    for (int k = 0; k < SAMPLES; ++k) {
        b[k] = k + zero < SAMPLES ? p->c[k + zero] : 0.0;
    }
    if (b[0] < 0.0) {
        for (int k = 0; k < SAMPLES; ++k) {
            b[k] = -b[k];
        }
    }
    return b[0] > 0.0 ? first_end(b) : 2.0;
}

/* The zero of p near the end of the step; 2: none is. */
static double zero_at_end(const Polynomial *p)
{
    double part = 1.0;
    for (int pass = 0; pass < 4; ++pass) {
        double value = 0.0, rate = 0.0;
        for (int k = DEGREE; k >= 0; --k) {
            rate = value + part * rate;
            value = p->c[k] + part * value;
        }
        part -= rate != 0.0 ? value / rate : 0.0;
    }
    return fabs(part - 1.0) < 0.25 ? part : 2.0;
}

typedef struct {
    double part;            /* of the step, where a condition changes first; 2: none does */
    int which;              /* that condition, or -1 */
    int turning;            /* it does not change there, but turns back so close that the step may have missed it */
    int at_zero[SWITCHES];  /* conditions that are zero at the end of the step */
} Switch;

/* Where the step that was just taken should have ended. `from`: conditions that are zero at its start; `aimed`: the
 * condition at whose zero it should end, or -1. */
static int first_switch(Step *s, int method, const int *from, int aimed, Switch *e)
{
    double g[SAMPLES][SWITCHES], noise[SWITCHES], values[SAMPLES], y[NY1];
    e->part = 2.0;
    e->which = -1;
    e->turning = 0;
    memset(e->at_zero, 0, sizeof e->at_zero);
    int outcome = conditions(s, s->t, s->start, g[0]);
    outcome = outcome == 0 ? conditions(s, s->t + s->h, s->end, g[DEGREE]) : outcome;
    if (outcome != 0 || (aimed < 0 && conditions_are_far(s, g[0], g[DEGREE]))) {
        return outcome;
    }
    outcome = rounding_of(s, s->t + s->h, s->end, g[DEGREE], noise);
    outcome = outcome == 0 ? prepare_dense(s, method) : outcome;
    for (int i = 1; i < DEGREE && outcome == 0; ++i) {
        const double part = sample_place(i);
        for (int n = 0; n < NY; ++n) {
            double value = 0.0;
            for (int j = 6; j >= 0; --j) {
                value = (value + s->dense[j][n]) * (j % 2 == 0 ? part : 1.0 - part);
            }
            y[n] = s->start[n] + value;
        }
        outcome = conditions(s, s->t + part * s->h, y, g[i]);
    }
    if (outcome != 0) {
        return outcome;
    }
    const double shortest = 4.5e-16 * fmax(fabs(s->t), s->h) / s->h; /* rounding of the time, as a part of the step */
    for (int k = 0; k < SWITCHES; ++k) {
        double most = 0.0;
        int nearest = 0;
        for (int i = 0; i < SAMPLES; ++i) {
            values[i] = g[i][k];
            most = fmax(most, fabs(g[i][k]));
            nearest = fabs(g[i][k]) < fabs(g[nearest][k]) ? i : nearest;
        }
        if (!(most > 4.0 * noise[k])) {
            continue; /* it is rounding throughout */
        }
        const Polynomial p = through(values);
        double part = first_change(&p, from[k] ? fmax(fabs(p.c[0]), noise[k]) : noise[k]);
        if (k == aimed && part > 1.0) {
            part = zero_at_end(&p);
        }
        e->at_zero[k] = fabs(part - 1.0) <= shortest || fabs(g[DEGREE][k]) <= 0.0625 * noise[k];
        if (part <= 8.0 * shortest || e->at_zero[k]) { /* at the start: a step up to there would be too short */
            continue;
        }
        const int turning = part > 1.0 && k != aimed && nearest > 0 && nearest < DEGREE;
        if (turning && e->which < 0 && fabs(g[nearest][k]) < TOUCH * most) {
            e->turning = 1;
            e->part = sample_place(nearest);
        } else if ((e->turning || part < e->part) && (part < 1.0 || (k == aimed && part < 1.5))) {
            e->part = part;
            e->which = k;
            e->turning = 0;
        }
    }
    return 0;
}
#endif
