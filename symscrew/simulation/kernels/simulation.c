/* A run: steps, their control, samples at given times, and what happens on the way. */

enum { DONE = 0, GOING_ON, STEP_TOO_SMALL, TOO_MANY_STEPS, NOT_CLOSED, NOT_DEFINED, STUCK, FULL, EVENT, NEEDS_PRECISION = 11, TOO_VAGUE };

typedef struct {
    double t, x[NX1], q[NQ1], v[NV1];
    double rest;       /* of the time, by which t is rounded: many short steps would add it up */
    double pivot;      /* at t, and its rate there */
    double pivot_rate;
    double h;          /* the next step */
    double earlier_error;
    double rtol, atol, longest, shortest;
    int method, started;
    long steps, rejected, careful, evaluations, crawling; /* `crawling`: steps in a row that lead nowhere */
    long budget;
    int reason;        /* why the last step failed */
    int event;         /* the contact whose mode has ended */
    int fresh;         /* the same, and 1, in the first step behind it; else 0 */
    const double *edges;          /* of intervals of time (time_features.py) */
    const double *lefts;          /* where inputs change at once: the latest time before the edge; else 0 */
    size_t edge_count, edge_at;   /* the first one behind t */
    double lands;      /* the edge on which the step ends exactly; 0: on none */
#if SWITCHES
    int at_zero[SWITCHES]; /* conditions that are zero at t */
    int credit;            /* short steps onto zeros that may follow each other */
#endif
    long unlooked;     /* steps for which that credit was used up */
    double fast, fast_t;  /* the greatest rates at the end of a step, squared, without units, and the state there */
    double fast_q[NQ1], fast_v[NV1], fast_x[NX1];
    int asks;          /* for the branch in extended precision before the first careful step */
    double careful_tolerance; /* least local tolerance of careful steps */
    Step step;
} Simulation;

typedef struct {
    double t, pivot;
    double q[NQ1], v[NV1];
    double lost;       /* how many rows of the closure lose their independence */
    double rows[NR1];  /* 1 for such a row */
} Crossing;

size_t simulation_size(void) { return sizeof(Simulation); }
size_t crossing_size(void) { return sizeof(Crossing); }

/* How fast the pivot changes along the motion. */
static double pivot_rate(const double *q, const double *v)
{
#if NR && FREE
    double z[NV1], at[NQ1], size = 0.0, pivot[2];
    for (int k = 0; k < NV; ++k) {
        size = fmax(size, fabs(v[k] / UNIT[k]));
    }
    if (!(size > 0.0)) {
        return 0.0;
    }
    for (int side = 0; side < 2; ++side) {
        Opening o;
        Rows f;
        for (int k = 0; k < NV; ++k) {
            z[k] = (side == 0 ? -1e-7 : 1e-7) / size * v[k];
        }
        retract(q, z, at);
        if (opening(at, &o) != 0) {
            return 0.0;
        }
        row_space(&o, RANK_FLOOR, &f);
        pivot[side] = f.smallest;
    }
    return (pivot[1] - pivot[0]) * size / 2e-7;
#else
    (void)q;
    (void)v;
    return 0.0;
#endif
}

/* Remembers the state if nothing was faster so far: samples may all be taken where the motion rests. */
static void look_how_fast(Simulation *s)
{
    double size = 0.0;
    for (int k = 0; k < NV; ++k) {
        size += (s->v[k] / UNIT[k]) * (s->v[k] / UNIT[k]);
    }
    if (size > s->fast) {
        s->fast = size;
        s->fast_t = s->t;
        memcpy(s->fast_q, s->q, sizeof s->q);
        memcpy(s->fast_v, s->v, sizeof s->v);
        memcpy(s->fast_x, s->x, sizeof s->x);
    }
}

int simulation_start(Simulation *s, double t, const double *q, const double *v, const double *x, int method, double h,
                     double rtol, double atol, double longest, long budget, const double *edges, const double *lefts,
                     size_t edge_count)
{
    memset(s, 0, sizeof *s);
    s->t = t;
    memcpy(s->q, q, sizeof(double) * NQ);
    memcpy(s->v, v, sizeof(double) * NV);
    memcpy(s->x, x, sizeof(double) * NX);
    s->method = method;
    s->h = h;
    s->rtol = rtol;
    s->atol = atol;
    s->longest = longest;
    s->earlier_error = 1e-4;
    s->budget = budget;
    s->edges = edges;
    s->lefts = lefts;
    s->edge_count = edge_count;
#if SWITCHES
    s->credit = CREDIT;
#endif
    without_dust(s->v, NV);
    without_dust(s->x, NX);
    s->careful_tolerance = CAREFUL_TOLERANCE;
    const int outcome = settled_start(s->q, s->v, &s->pivot);
    s->pivot_rate = pivot_rate(s->q, s->v);
    return outcome == 0 ? 0 : outcome == VAGUE ? TOO_VAGUE : NOT_CLOSED;
}

/* The branch in extended precision, whose rounding is `rounding`; both NULL: the run returns NEEDS_PRECISION where it
 * would be called. A run that was told nothing takes double precision. */
void simulation_precision(Simulation *s, int (*anchor)(const double *, const double *, const int *, double *),
                          int (*state)(double, const double *, double *, double *, double *, double *, double *),
                          double rounding)
{
    s->step.precise.anchor = anchor;
    s->step.precise.state = state;
    s->asks = state == NULL;
    s->careful_tolerance = state != NULL && rounding < ROUNDING_OF_PRECISE ? PRECISE_TOLERANCE : CAREFUL_TOLERANCE;
}

static int begin(const Simulation *s, Step *step, double h, int careful)
{
    const double *base = s->q;
    double z[NV1] = {0.0};
    step->careful = careful;
    step->u = NULL;
#if NR && FREE
    if (careful) {
#if CONTACTS
        const int *modes = contact_mode;
#else
        const int *modes = NULL;
#endif
        const Precise *precise = &step->precise;
        const int outcome = precise->anchor != NULL ? precise->anchor(s->q, s->v, modes, step->chart.base)
                                                    : anchored(s->q, s->v, &step->chart);
        if (outcome != 0) {
            return outcome;
        }
        base = step->chart.base;
        local_coordinates(base, s->q, z);
    }
#endif
    memcpy(step->base, base, sizeof(double) * NQ);
    memcpy(step->start, z, sizeof(double) * NV);
    memcpy(step->start + NV, s->v, sizeof(double) * NV);
    memcpy(step->start + 2 * NV, s->x, sizeof(double) * NX);
    step->t = s->t;
    step->rest = s->rest;
    step->h = h;
    return 0;
}

/* A first step by Hairer's rule: a small explicit step, and the change of the slope along it. */
static double first_step(Simulation *s, Step *step)
{
    double y[NY1], dy[NY1], size = 0.0, rate = 0.0, change = 0.0;
    memcpy(step->end, step->start, sizeof step->end);
    memcpy(step->q, s->q, sizeof s->q);
    const double least = least_rate(step);
    for (int i = 0; i < NY - PASSIVE; ++i) {
        const double w = weight(step, i, s->rtol, s->atol, least);
        const double value = i < NV ? 0.0 : step->start[i] / w;
        size += value * value;
        rate += (step->k[0][i] / w) * (step->k[0][i] / w);
    }
    double h = size < 1e-10 || rate < 1e-10 ? 1e-6 : 0.01 * sqrt(size / rate);
    h = fmin(h, s->longest);
    for (int i = 0; i < NY; ++i) {
        y[i] = step->start[i] + h * step->k[0][i];
    }
    if (slope(step, s->t + h, y, dy) != 0) {
        return fmin(1e-6, s->longest);
    }
    for (int i = 0; i < NY - PASSIVE; ++i) {
        const double w = weight(step, i, s->rtol, s->atol, least), difference = (dy[i] - step->k[0][i]) / w;
        change += difference * difference;
    }
    const double steepest = fmax(sqrt(rate), sqrt(change) / h);
    const double second = steepest <= 1e-15 ? fmax(1e-6, h * 1e-3) : pow(0.01 / steepest, 0.125);
    return fmin(fmin(100.0 * h, second), s->longest);
}

static int needs_care(const Simulation *s, double h)
{
#if NR && FREE
    return s->pivot < CAREFUL || s->pivot + 1.5 * fabs(h) * fmin(s->pivot_rate, 0.0) < CAREFUL;
#else
    (void)s;
    (void)h;
    return 0;
#endif
}

#define PIECES 4
/* Where the pivot is smallest between left and right, if it has a minimum there below LOOK. */
static int crossing_between(Simulation *s, double left, double right, double low, double low_rate, double high,
                            double high_rate, Crossing *found)
{
#if NR && FREE
    Step *step = &s->step;
    double x[NX1];
    high_rate = -high_rate;
    if (!(low_rate < 0.0 && high_rate < 0.0)) {
        return 0;
    }
    found->t = left;
    found->pivot = low;
    for (int pass = 0; pass < 60; ++pass) {
        /* Newton from the nearer end towards the zero of the pivot, the middle where that leaves the bracket */
        double guess = low < high ? left - low / low_rate : right + high / high_rate;
        const double width = right - left;
        if (!(guess > left + 1e-3 * width * (pass > 0) && guess < right - 1e-3 * width * (pass > 0)) || pass % 4 == 3) {
            guess = 0.5 * (left + right);
        }
        if (state_within(step, s->method, guess, found->q, found->v, x, &found->pivot) != 0) {
            return 0;
        }
        found->t = guess;
        const double rate = pivot_rate(found->q, found->v);
        if (found->pivot < 1e-8 * PIVOT || width < 1e-12 * fmax(1.0, fabs(guess))) {
            break;
        }
        if (rate < 0.0) {
            left = guess;
            low = found->pivot;
            low_rate = rate;
        } else {
            right = guess;
            high = found->pivot;
            high_rate = -rate;
        }
        if (pass > 8 && fmin(low, high) > 0.1 * PIVOT) { /* a minimum, but a regular one */
            return 0;
        }
    }
    if (found->pivot > LOOK) {
        return 0;
    }
    Opening o;
    Rows f;
    if (opening(found->q, &o) != 0) {
        return 0;
    }
    row_space(&o, RANK_FLOOR, &f);
    found->lost = 0.0;
    memset(found->rows, 0, sizeof found->rows);
    for (int k = 0; k < FRONTS; ++k) {
        for (int r = 0; r < FRONT[k].rank; ++r) {
            const int lost = f.pivot[FRONT[k].pivot + r] < LOOK;
            found->rows[LIVE_ROW[FRONT[k].row + f.order[FRONT[k].row + r]]] = lost ? 1.0 : 0.0;
            found->lost += lost;
        }
    }
    return 1;
#else
    (void)s;
    (void)left;
    (void)right;
    (void)low;
    (void)low_rate;
    (void)high;
    (void)high_rate;
    (void)found;
    return 0;
#endif
}

/* The crossings within the step just taken. They are looked for where the pivot, at its rates, could reach zero. */
static size_t crossings_within(Simulation *s, double rate_at_end, Crossing *found, size_t room)
{
    Step *step = &s->step;
    const double steepest = fmax(fabs(s->pivot_rate), fabs(rate_at_end));
    double left = step->t, low = s->pivot, low_rate = s->pivot_rate, q[NQ1], v[NV1], x[NX1];
    size_t met = 0;
    const int near = fmin(s->pivot, step->pivot) < 0.5 * PIVOT && s->pivot + step->pivot < 1.5 * step->h * steepest;
    if (NR == 0 || FREE == 0 || !(near || step->careful)) {
        return 0;
    }
    for (int i = 1; i <= PIECES && met < room; ++i) {
        double right = step->t + step->h * i / PIECES, high = step->pivot, high_rate = rate_at_end;
        if (i < PIECES) {
            if (state_within(step, s->method, right, q, v, x, &high) != 0) {
                continue;
            }
            high_rate = pivot_rate(q, v);
        }
        met += (size_t)crossing_between(s, left, right, low, low_rate, high, high_rate, found + met);
        left = right;
        low = high;
        low_rate = high_rate;
    }
    return met;
}

#define AT_EDGE 2e-15 /* of the time: an edge that is nearer is now, for no step is as short as that */
/* The latest end of a step that does not pass what changes in time unseen: the next break, or SPAN edges ahead. An event
 * at the instant of a break may have been found some roundings before it. */
static double reach_in_time(Simulation *s, double *left)
{
    *left = 0.0;
    while (s->edge_at < s->edge_count && s->edges[s->edge_at] - s->t <= AT_EDGE * fabs(s->t)) {
        if (s->edges[s->edge_at] > s->t) {
            s->t = s->edges[s->edge_at];
            s->rest = 0.0;
            s->started = 0;
        }
        ++s->edge_at;
    }
    for (size_t k = s->edge_at; k < s->edge_count; ++k) {
        if (s->lefts[k] > 0.0 || k + 1 == s->edge_at + SPAN) {
            *left = s->lefts[k];
            return s->edges[k];
        }
    }
    return 0.0;
}

/* Shortens a step to what changes in time: onto it, or onto half of the way where one step does not reach it. */
static double shortened(Simulation *s, double h, double limit, double left)
{
    s->lands = s->step.until = 0.0;
    if (!(limit > 0.0) || s->t + 2.0 * h <= limit) {
        return h;
    }
    if (s->t + h * (1.0 + 1e-9) < limit) {
        return 0.5 * (limit - s->t);
    }
    s->lands = limit;
    s->step.until = left;
    return (limit - s->t) - s->rest;
}

/* One accepted step of at most h (fixed methods: of exactly h), with retries. */
static int advance(Simulation *s, double target)
{
    Step *step = &s->step;
    const int adaptive = s->method == DOP853;
    int cautious = 0;
    double last_error = 0.0, noise = 0.0;
#if SWITCHES
    double onto = 0.0, natural = 0.0; /* the length of a step onto a corner, of the one that would pass it */
    int landings = 0, aimed = -1, landed[SWITCHES] = {0};
#endif
    for (int attempt = 0; attempt < 60; ++attempt) {
        double left;
        const double limit = reach_in_time(s, &left), whole = fmin(s->h, s->longest);
        double h = adaptive ? whole : s->h;
        s->lands = s->step.until = 0.0;
        if (!adaptive) { /* equal parts of the way to the next output or break */
            const int first = left > 0.0 && limit < target;
            const double way = ((first ? limit : target) - s->t) - s->rest;
            const double parts = fmax(1.0, ceil(way / h - 1e-9));
            h = way / parts;
            s->lands = first && parts == 1.0 ? limit : 0.0;
            s->step.until = s->lands > 0.0 ? left : 0.0;
        } else if (s->h > 0.0) {
            h = shortened(s, whole, limit, left);
        }
#if SWITCHES
        if (onto > 0.0 && onto < h) {
            h = onto;
            s->lands = s->step.until = 0.0;
        }
#endif
        const int careful = cautious || needs_care(s, h);
        if (careful && s->asks) {
            return NEEDS_PRECISION;
        }
        const int fresh = !s->started || careful || step->careful;
        if (fresh) {
            int outcome = begin(s, step, h, careful);
            if (outcome == 0) {
                outcome = slope(step, s->t, step->start, step->k[0]);
            }
            if (outcome != 0) {
                s->reason = outcome;
                return outcome == AT_REST ? STUCK : NOT_DEFINED;
            }
        } else {
            memcpy(step->k[0], step->k[12], sizeof step->k[0]);
            begin(s, step, h, 0);
            local_rates(step->start, s->v, step->k[0]);
        }
        if (!s->started && adaptive && s->h <= 0.0) {
            s->h = first_step(s, step);
            h = shortened(s, s->h, limit, left);
        }
        s->started = 1;
        if (careful && adaptive) { /* the chart covers a neighbourhood only */
            double size = 0.0;
            for (int k = 0; k < NV; ++k) {
                size = fmax(size, fabs(s->v[k] / UNIT[k]));
            }
            const double least = size > 0.0 ? fmin(h, REACH / size) : h;
            if (least < h) {
                s->lands = step->until = 0.0;
                h = least;
            }
        }
        step->h = h;
        if (!(fabs(h) > s->shortest + 1e-15 * fabs(s->t))) {
            return STEP_TOO_SMALL;
        }
        int outcome = take(step, s->method);
        if (outcome == 0 && adaptive) { /* near the zone accelerations are noise below that tolerance */
            const double floor = fmax(careful ? s->careful_tolerance : 0.0, noise);
            step->error = dop853_error(step, fmax(s->rtol, floor), fmax(s->atol, floor));
            if (step->error >= 1.0 && last_error > 0.0 && step->error > 0.05 * last_error && noise < MOST_NOISE) {
                noise = fmax(10.0 * noise, LEAST_NOISE); /* of order 8 it would have fallen: rounding is what is left */
                step->error = dop853_error(step, fmax(s->rtol, fmax(floor, noise)), fmax(s->atol, fmax(floor, noise)));
            }
            last_error = step->error;
        } else {
            step->error = 0.0;
        }
        if (outcome == 0 && step->error < 1.0) {
            outcome = last_slope(step);
#if SWITCHES
            s->unlooked += outcome == 0 && s->method >= RK4 && s->credit <= 0;
            if (outcome == 0 && s->method >= RK4 && s->credit > 0 && landings < LANDINGS) {
                Switch found;
                outcome = first_switch(step, s->method, s->at_zero, h == onto ? aimed : -1, &found);
                if (outcome == 0 && (found.which >= 0 || found.turning)) {
                    natural = landings == 0 ? h : natural;
                    onto = found.part * h;
                    aimed = found.which;
                    ++landings;
                    memcpy(step->k[12], step->k[0], sizeof step->k[0]);
                    last_error = 0.0;
                    continue;
                }
                memcpy(landed, found.at_zero, sizeof landed);
            }
#endif
            if (outcome == 0) {
                if (adaptive) { /* Gustafsson's control: Hairer, Wanner II, IV.2 */
                    const double error = fmax(step->error, 1e-8);
                    double factor = 0.9 * pow(error, -0.125 + 0.75 * 0.04) * pow(s->earlier_error, 0.04);
                    factor = fmin(2.0, fmax(0.333, factor)); /* longer leaps are taken back as often as not */
                    const double next = h * (attempt > 0 ? fmin(1.0, factor) : factor);
                    s->h = attempt == 0 && h < whole ? fmax(next, whole) : next; /* time cut it short, not its error */
                    s->earlier_error = fmax(error, 1e-4);
                }
#if SWITCHES
                memcpy(s->at_zero, landed, sizeof landed); /* without a look at them: zeros, none */
                s->h = fmax(s->h, natural);
                s->credit += landings > 0 && h < 0.1 * natural ? -1 : s->credit < CREDIT;
#endif
#if WORKS
                if (adaptive) {
                    sharpen_work(step, s->method, s->rtol);
                }
#endif
                s->careful += careful;
                ++s->steps;
                return DONE;
            }
        }
        s->reason = outcome;
        ++s->rejected;
        memcpy(step->k[12], step->k[0], sizeof step->k[0]); /* an attempt may begin from the same slope again */
        if (outcome != 0) {
            if (!adaptive && cautious) {
                return outcome == AT_REST ? STUCK : NOT_CLOSED;
            }
            if (!adaptive) {
                cautious = NR && FREE;
                if (!cautious) {
                    return NOT_DEFINED;
                }
                continue;
            }
            cautious = (attempt >= 2 && NR && FREE) ? 1 : cautious;
            s->h = 0.25 * h;
        } else {
            s->h = h * fmax(0.2, 0.9 * pow(step->error, -0.125));
        }
    }
    return s->reason == AT_REST ? STUCK : STEP_TOO_SMALL;
}

/* A step between whose ends there are no states (its dense output has three stages of its own, and is put onto the loops)
 * is taken again, shorter, as one is whose stages fail. */
static void taken_back(Simulation *s)
{
    s->h = 0.25 * s->step.h;
    s->started = 0;
    --s->steps;
    ++s->rejected;
}

/* Goes on until the last of `count` output times (ascending, not before t) or for `most` steps; writes samples
 * and crossings, of these and of events none behind the last output. Returns GOING_ON while there is more to do, else how it ended. */
int simulation_advance(Simulation *s, long most, const double *times, size_t count, size_t *written, double *q, double *v,
                       double *x, Crossing *crossings, size_t room, size_t *met)
{
    evaluations = 0;
    for (long done = 0; *written < count; ++done) {
        if (done == most) {
            s->evaluations += evaluations;
            return GOING_ON;
        }
        while (*written < count && times[*written] <= s->t) { /* the very first */
            memcpy(q + *written * NQ, s->q, sizeof(double) * NQ);
            memcpy(v + *written * NV, s->v, sizeof(double) * NV);
            memcpy(x + *written * NX, s->x, sizeof(double) * NX);
            ++*written;
        }
        if (*written == count) {
            break;
        }
        if (s->steps >= s->budget) {
            return TOO_MANY_STEPS;
        }
        const size_t met_before = *met;
#if SWITCHES
        int at_zero[SWITCHES];
        memcpy(at_zero, s->at_zero, sizeof at_zero);
#endif
        const int outcome = advance(s, times[*written]);
        if (outcome != DONE) {
            s->evaluations += evaluations;
            return outcome;
        }
        Step *step = &s->step;
        const double short_of = ((times[*written] - step->t) - step->rest) - step->h; /* the next output */
        double end = s->method == DOP853 || short_of > 1e-9 * step->h ? step->t + step->h : times[*written];
        end = s->lands > 0.0 ? s->lands : end;
        int whole = 1; /* the step counts up to its end; with an event only to that instant */
#if CONTACTS
        Event event;
        if (first_event(step, s->method, s->fresh - 1, &event) != 0) {
            taken_back(s);
#if SWITCHES
            memcpy(s->at_zero, at_zero, sizeof at_zero);
#endif
            continue;
        }
        if (event.contact >= 0) {
            end = step->t + event.part * step->h;
            /* What is held lets go behind the instant, by its last digits: before it, it would be held again. */
            end = held(event.contact) ? fmin(end + LATE * fabs(end), step->t + step->h) : end;
            whole = 0;
        }
#endif
        const int regular = step->pivot > 0.5 * PIVOT && !step->careful; /* a secant will do */
        const double rate = regular ? (step->pivot - s->pivot) / step->h : pivot_rate(step->q, step->v);
        *met += crossings_within(s, rate, crossings + *met, room - *met);
        while (*met > 0 && crossings[*met - 1].t > fmin(end, times[count - 1])) { /* behind an event or the run's end */
            --*met;
        }
        int within = 1; /* whether there is a state at every output within the step */
        while (*written < count && times[*written] <= end && within) {
            double pivot;
            const double when = times[*written];
            if (when == end && whole) {
                memcpy(q + *written * NQ, step->q, sizeof(double) * NQ);
                memcpy(v + *written * NV, step->v, sizeof(double) * NV);
                memcpy(x + *written * NX, step->x, sizeof(double) * NX);
            } else {
                within = state_within(step, s->method, when, q + *written * NQ, v + *written * NV, x + *written * NX,
                                      &pivot) == 0;
            }
            *written += (size_t)within;
        }
        if (!within) {
            if (s->method != DOP853) {
                s->evaluations += evaluations;
                return NOT_CLOSED;
            }
            taken_back(s);
            *met = met_before;
#if SWITCHES
            memcpy(s->at_zero, at_zero, sizeof at_zero);
#endif
            continue;
        }
#if CONTACTS
        if (event.contact >= 0 && end <= times[count - 1]) {
            s->event = event.contact;
            s->fresh = event.contact + 1;
            if (state_within(step, s->method, end, s->q, s->v, s->x, &s->pivot) != 0) {
                return NOT_CLOSED;
            }
            s->t = end;
            s->rest = 0.0;
            s->pivot_rate = pivot_rate(s->q, s->v);
            s->started = 0;
            s->evaluations += evaluations;
            look_how_fast(s);
            return EVENT;
        }
        if (step->pivot > CAREFUL && !step->careful && kept(end, step->q, step->v, step->x) != 0) {
            return NOT_CLOSED;
        }
#endif
        s->crawling = step->h < CRAWL * times[count - 1] ? s->crawling + 1 : 0;
        if (s->crawling > MOST_CRAWLING) {
            s->evaluations += evaluations;
            return STEP_TOO_SMALL;
        }
        s->fresh = 0;
        s->started = step->until > 0.0 ? 0 : s->started; /* behind a break the slope is another one */
        s->rest = end == step->t + step->h ? ((step->t - end) + step->h) + step->rest : 0.0;
        s->t = end;
        memcpy(s->q, step->q, sizeof s->q);
        memcpy(s->v, step->v, sizeof s->v);
        memcpy(s->x, step->x, sizeof s->x);
        s->pivot = step->pivot;
        s->pivot_rate = rate;
        look_how_fast(s);
    }
    s->evaluations += evaluations;
    return DONE;
}

/* Whether there was a state with rates at the end of a step, and the one with the greatest. */
int simulation_fastest(const Simulation *s, double *t, double *q, double *v, double *x)
{
    *t = s->fast_t;
    memcpy(q, s->fast_q, sizeof(double) * NQ);
    memcpy(v, s->fast_v, sizeof(double) * NV);
    memcpy(x, s->fast_x, sizeof(double) * NX);
    return s->fast > 0.0;
}

void simulation_report(const Simulation *s, double *t, double *q, double *v, double *x, double *numbers)
{
    *t = s->t;
    memcpy(q, s->q, sizeof(double) * NQ);
    memcpy(v, s->v, sizeof(double) * NV);
    memcpy(x, s->x, sizeof(double) * NX);
    numbers[0] = (double)s->steps;
    numbers[1] = (double)s->rejected;
    numbers[2] = (double)s->careful;
    numbers[3] = (double)s->evaluations;
    numbers[4] = s->pivot;
    numbers[5] = s->h;
    numbers[6] = (double)s->reason;
    numbers[7] = (double)s->event;
    numbers[8] = (double)s->unlooked;
}

#if CONTACTS
/* Goes on from another state and other modes at the same time. */
int simulation_change(Simulation *s, const double *q, const double *v, const double *modes)
{
    memcpy(s->q, q, sizeof(double) * NQ);
    memcpy(s->v, v, sizeof(double) * NV);
    for (int k = 0; k < CONTACTS; ++k) {
        contact_mode[k] = (int)modes[k];
    }
    s->started = 0;
    if (s->pivot < CAREFUL) {
        return 0;
    }
    const int outcome = settle(s->q, s->v, &s->pivot);
    return outcome == 0 ? kept(s->t, s->q, s->v, s->x) : outcome;
}

/* Accelerations by given forces of the contacts. */
int simulation_accelerations(double t, const double *q, const double *v, const double *x, const double *force, double *a)
{
    double x_dot[NX1];
    memcpy(CONTACT_FORCE, force, sizeof CONTACT_FORCE);
    return valid(plain_forces_at(t, q, v, x, NULL, a, x_dot));
}
#endif
