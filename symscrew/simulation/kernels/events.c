/* Where the mode of a contact ends within a step. */
#if CONTACTS
/* The part of the step at which a margin ends; 2: it does not. A margin within `slack` of zero at the start counts as
 * zero there: what it does next decides. Where its rate is zero, too, that is its second derivative, of which the step's
 * polynomial has the sign only if it is large: a stop that is left as the force on it fades was met again at once, and
 * so on without end. There a margin that falls ends where it is below -slack. */
static double end_of(Polynomial p, double slack)
{
    double b[SAMPLES], size = 0.0;
    int zeros = 0;
    for (int k = 1; k < SAMPLES; ++k) {
        size = fmax(size, fabs(p.c[k]));
    }
    while (zeros < DEGREE && fabs(p.c[zeros]) <= (zeros == 0 ? slack : 1e-9 * size)) {
        ++zeros;
    }
    if (zeros == DEGREE) {
        return 2.0; /* it stays zero */
    }
    for (int k = 0; k < SAMPLES; ++k) { /* what is left without these zeros, which has the same sign behind them */
        b[k] = k + zeros < SAMPLES ? p.c[k + zeros] : 0.0;
    }
    if (zeros < 2 || b[0] > 0.0) {
        return first_end(b);
    }
    p.c[0] = slack;
    const double below = first_end(p.c);
    double most = 0.0;
    for (int i = 1; i < SAMPLES && below <= 1.0; ++i) {
        double value = 0.0;
        for (int k = DEGREE; k >= 0; --k) {
            value = p.c[k] + below * i / SAMPLES * value;
        }
        most = fmax(most, value);
    }
    return most > 2.0 * slack ? below : below <= 1.0 ? 0.0 : 2.0; /* it came back later, or falls from the start */
}

typedef struct {
    double part; /* of the step */
    int contact;
} Event;

/* Keeps the earlier of two ends. */
static void consider(Event *e, int k, double part)
{
    if (part <= 1.0 && part < e->part) {
        e->part = part;
        e->contact = k;
    }
}

/* Whether a free stop could be reached in this step: it is far where ten times the way of the fastest slope is less. */
static int near_stop(const Step *s, const Contact *c)
{
    double fastest = 0.0;
    for (int j = 0; j < 13; ++j) {
        fastest = fmax(fastest, fabs(s->k[j][c->v]));
    }
    const double place = s->base[c->q] + s->start[c->v], way = 10.0 * fabs(s->h) * fastest;
    return place + way >= c->upper || place - way <= c->lower;
}

/* The largest rate within the step, without units: rates are small beside it. */
static double fastest(const Step *s)
{
    double most = 0.0;
    for (int j = 0; j < 13; ++j) {
        for (int i = 0; i < NV; ++i) {
            most = fmax(most, fabs(s->k[j][i]) / UNIT[i]);
        }
    }
    return most;
}

static int sampled(Step *s, int method, double (*q)[NQ1], double (*v)[NV1], double (*force)[CONTACTS], int forces)
{
    double x[NX1], a[NV1], x_dot[NX1], pivot;
    for (int i = 0; i < SAMPLES; ++i) {
        const double t = s->t + s->h * sample_place(i);
        int outcome = state_within(s, method, t, q[i], v[i], x, &pivot);
        if (outcome == 0 && forces) {
            outcome = valid(forces_at(t, q[i], v[i], x, s->u, a, x_dot));
            memcpy(force[i], CONTACT_FORCE, sizeof force[i]);
        }
        if (outcome != 0) {
            return outcome;
        }
    }
    return 0;
}

/* Whether what is held at the start of the step holds joint k, too. */
static int rests(Step *s, int method, int k)
{
    double q[NQ1], v[NV1], x[NX1], pivot;
    return state_within(s, method, s->t, q, v, x, &pivot) == 0 && held_with(k, s->t, q, v, x);
}

/* The first end of a mode within the step. 0, or why the step cannot be looked at. `fresh`: the contact whose mode has
 * just changed, or -1: its margin begins at zero up to what putting the state onto the loops has moved it by. */
static int first_event(Step *s, int method, int fresh, Event *e)
{
    double q[SAMPLES][NQ1], v[SAMPLES][NV1], force[SAMPLES][CONTACTS], values[SAMPLES];
    int grips = 0, looks = s->careful;
    e->part = 2.0;
    e->contact = -1;
    for (int k = 0; k < CONTACTS; ++k) {
        grips |= held(k);
        looks |= held(k) || CONTACT[k].kind == FRICTION || near_stop(s, CONTACT + k);
    }
    if (!looks) {
        return 0;
    }
    int outcome = prepare_dense(s, method);
    if (outcome == 0 && (grips || s->careful)) {
        outcome = sampled(s, method, q, v, force, grips);
    }
    if (outcome != 0) {
        return outcome;
    }
    for (int k = 0; k < CONTACTS; ++k) {
        const Contact *c = CONTACT + k;
        Polynomial p;
        if (held(k)) {
            for (int side = -1; side <= 1; side += 2) { /* friction: both levels; a stop: only the side that it is on */
                if (c->kind == STOP && side != contact_mode[k]) {
                    continue;
                }
                double most = 0.0;
                for (int i = 0; i < SAMPLES; ++i) {
                    values[i] = (c->kind == FRICTION ? c->fixed : 0.0) - side * force[i][k];
                    most = fmax(most, fabs(force[i][k]));
                }
                double zero = 1e-12 * fmax(most, c->kind == FRICTION ? c->fixed : 0.0);
                if (k == fresh && c->kind == FRICTION && values[0] < 0.0 && -values[0] < MOST_MOVED * c->fixed) {
                    zero = fmax(zero, -values[0]); /* it has just stuck, as its force fell from the level */
                }
                consider(e, k, end_of(through(values), zero));
            }
            continue;
        }
        const int index = c->kind == FRICTION ? NV + c->v : c->v;
        if (s->careful) {
            for (int i = 0; i < SAMPLES; ++i) {
                values[i] = c->kind == FRICTION ? v[i][c->v] : q[i][c->q];
            }
            p = through(values);
        } else {
            p = dense_polynomial(s, index);
            p.c[0] += c->kind == FRICTION ? 0.0 : s->base[c->q];
        }
        const double slack = 1e-11 * UNIT[c->v] * (c->kind == FRICTION ? fastest(s) : 1.0);
        for (int side = -1; side <= 1; side += 2) {
            Polynomial margin = p;
            if (c->kind == FRICTION && side != contact_mode[k]) {
                continue;
            }
            const double sign = c->kind == FRICTION ? side : -side; /* side 1: the upper stop */
            for (int i = 0; i < SAMPLES; ++i) {
                margin.c[i] *= sign;
            }
            if (c->kind == STOP) {
                const double end = side > 0 ? c->upper : c->lower;
                if (!(fabs(end) < 1e300)) {
                    continue;
                }
                margin.c[0] += side * end;
            }
            margin.c[0] += c->kind == FRICTION ? slack : 0.0; /* a rate that only touches zero does not end a slip */
            const double other = c->kind == STOP ? fabs(p.c[0] - (side > 0 ? c->lower : c->upper)) : 1e300;
            const int own = fabs(margin.c[0]) <= other; /* of two stops the one that was met, however near they are */
            const int zero = k == fresh && own && fabs(margin.c[0]) < MOST_MOVED * UNIT[c->v];
            const double part = end_of(margin, zero ? fmax(slack, fabs(margin.c[0])) : slack);
            if (c->kind == STOP || !grips || part > 1.0 || !rests(s, method, k)) {
                consider(e, k, part);
            }
        }
    }
    return 0;
}

/* What is held stays where it is: rates to zero, places onto the stops, by forces of the held contacts. */
static int kept(double t, double *q, double *v, const double *x)
{
    Grip g;
    double a[NV1], x_dot[NX1], error[CONTACTS], force[CONTACTS], z[NV1], moved[NQ1], pivot;
    int any = 0;
    for (int k = 0; k < CONTACTS; ++k) {
        any |= held(k);
    }
    if (!any) {
        return 0;
    }
    for (int pass = 0; pass < 2; ++pass) { /* places, then rates: each is put back onto the loops */
        memset(CONTACT_FORCE, 0, sizeof CONTACT_FORCE);
        int outcome = valid(plain_forces_at(t, q, v, x, NULL, a, x_dot));
        outcome = outcome == 0 ? gripped(t, q, v, x, NULL, a, &g) : outcome;
        if (outcome != 0) {
            return outcome;
        }
        for (int i = 0; i < g.count; ++i) {
            const Contact *c = CONTACT + g.unknown[i];
            const double end = contact_mode[g.unknown[i]] > 0 ? c->upper : c->lower;
            error[i] = pass == 1 ? -v[c->v] : c->kind == STOP ? end - q[c->q] : 0.0;
        }
        grip(&g, error, force);
        memset(z, 0, sizeof z);
        for (int i = 0; i < g.count; ++i) {
            for (int k = 0; k < NV; ++k) {
                z[k] += g.column[i][k] * force[i];
            }
        }
        if (pass == 0) {
            retract(q, z, moved);
            memcpy(q, moved, sizeof(double) * NQ);
        } else {
            for (int k = 0; k < NV; ++k) {
                v[k] += z[k];
            }
        }
        if (settle(q, v, &pivot) != 0) {
            return FAILED;
        }
    }
    return 0;
}
#endif
