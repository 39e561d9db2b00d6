/* Steps near a singular configuration, where the closure loses rank and projection alone goes astray.
 *
 * Branches of the motion cross there, but along each of them the motion is smooth. So a state is carried along its own
 * branch: the branch is the graph over the tangent space T of an anchor, a nearby configuration that is regular.
 * A point of the graph is reached from the anchor in short strides, extrapolated from the strides before and corrected
 * by Newton's method at fixed tangential coordinates; the neighbourhood of the singular configuration itself (pivot
 * below ZONE) is never corrected or evaluated, but interpolated from both sides. The slopes are then a smooth function
 * of the tangential coordinates, so every Runge-Kutta formula keeps its order across the crossing.
 */
#if NR && FREE

/* A walk along a straight line in tangential coordinates: the last points, for the extrapolation. */
#define MEMORY 6
typedef struct {
    int count;
    double place[MEMORY];
    double z[MEMORY][NV1]; /* without units */
} Walk;

static void remember(Walk *w, double place, const double *z)
{
    if (w->count == MEMORY) {
        memmove(w->place, w->place + 1, sizeof w->place - sizeof *w->place);
        memmove(w->z, w->z + 1, sizeof w->z - sizeof *w->z);
        --w->count;
    }
    w->place[w->count] = place;
    memcpy(w->z[w->count], z, sizeof w->z[0]);
    ++w->count;
}

/* The polynomial through the remembered points at `place`. */
static void extrapolated(const Walk *w, double place, double *z)
{
    for (int k = 0; k < NV; ++k) {
        z[k] = 0.0;
    }
    for (int i = 0; i < w->count; ++i) {
        double weight = 1.0;
        for (int j = 0; j < w->count; ++j) {
            weight *= j == i ? 1.0 : (place - w->place[j]) / (w->place[i] - w->place[j]);
        }
        for (int k = 0; k < NV; ++k) {
            z[k] += weight * w->z[i][k];
        }
    }
}

static void unscaled(double *z)
{
    for (int k = 0; k < NV; ++k) {
        z[k] *= UNIT[k];
    }
}

static void scaled(double *z)
{
    for (int k = 0; k < NV; ++k) {
        z[k] /= UNIT[k];
    }
}

/* One stride to `place` on the line start + place direction. IN_ZONE: not corrected, not remembered. */
static int stride(const Chart *c, const double *start, const double *direction, double place, Walk *w, double *q)
{
    double z[NV1], y[FREE], moved;
    Opening o;
    Rows f;
    for (int j = 0; j < FREE; ++j) {
        y[j] = start[j] + place * direction[j];
    }
    if (w->count == 1) { /* along the tangent space */
        for (int k = 0; k < NV; ++k) {
            z[k] = w->z[0][k];
            for (int j = 0; j < FREE; ++j) {
                z[k] += (place - w->place[0]) * direction[j] * c->tangent[j][k];
            }
        }
    } else {
        extrapolated(w, place, z);
    }
    unscaled(z);
    retract(c->base, z, q);
    const int outcome = corrected(c, y, q, &o, &f, &moved);
    if (outcome == 0 && moved > 0.3 * f.smallest / c->slope) {
        return FAILED; /* the other branch may be as near */
    }
    if (outcome == 0) {
        local_coordinates(c->base, q, z);
        scaled(z);
        remember(w, place, z);
    }
    return outcome;
}

/* Walks from the last remembered place to `goal`, over the zone where it must. IN_ZONE: the goal itself is in it. */
static int walk(const Chart *c, const double *start, const double *direction, double goal, Walk *w, double *q)
{
    const double longest = STRIDE * c->scale;
    double length = longest, place = w->place[w->count - 1];
    const double sign = goal > place ? 1.0 : -1.0;
    for (int step = 0; step < 400; ++step) {
        const double left = fabs(goal - place);
        if (left < 1e-15) {
            return 0;
        }
        const double next = left <= length ? goal : place + sign * length;
        const int outcome = stride(c, start, direction, next, w, q);
        if (outcome == 0) {
            place = next;
            length = fmin(longest, 1.5 * length);
        } else if (outcome == IN_ZONE) {
            if (left <= length) {
                return IN_ZONE;
            }
            length += 0.4 * longest;
            if (length > 20.0 * longest) {
                return FAILED;
            }
        } else {
            length *= 0.5;
            if (length < 1e-3 * longest) {
                return FAILED;
            }
        }
    }
    return FAILED;
}

static int rates_on_branch(const Chart *c, const Opening *o, const Rows *f, const double *w, double *v)
{
    double along[NV1], right[NR], d[NV1];
    for (int k = 0; k < NV; ++k) {
        along[k] = 0.0;
        for (int j = 0; j < FREE; ++j) {
            along[k] += w[j] * c->tangent[j][k];
        }
    }
    for (int i = 0; i < NR; ++i) {
        right[i] = 0.0;
    }
    subtract_product(o, along, right);
    if (shortest_across(c, f, right, d) != 0) {
        return FAILED;
    }
    for (int k = 0; k < NV; ++k) {
        v[k] = (along[k] + d[k]) * UNIT[k];
    }
    return 0;
}

/* State of the branch at a regular point q: rates with tangential part w, accelerations, slopes of x. */
static int state_on_branch(const Chart *c, double t, const double *q, const double *w, const double *x, double *v,
                           double *a, double *x_dot, const double *u)
{
    Opening o;
    Rows f;
    if (opening(q, &o) != 0) {
        return FAILED;
    }
    row_space(&o, RANK_FLOOR, &f);
    if (rates_on_branch(c, &o, &f, w, v) != 0) {
        return FAILED;
    }
    return a == NULL ? 0 : valid(forces_at(t, q, v, x, u, a, x_dot));
}

/* Walks from the anchor to the tangential coordinates `goal`; `way` keeps the last points, `length` how far it is. */
static int reach(const Chart *c, const double *goal, Walk *way, double *length, double *q)
{
    const double zero[FREE] = {0.0}, origin[NV1] = {0.0};
    double ray[FREE];
    *length = 0.0;
    for (int j = 0; j < FREE; ++j) {
        *length += goal[j] * goal[j];
    }
    *length = sqrt(*length);
    way->count = 0;
    remember(way, 0.0, origin);
    memcpy(q, c->base, sizeof(double) * NQ);
    if (*length < 1e-15) {
        return 0;
    }
    for (int j = 0; j < FREE; ++j) {
        ray[j] = goal[j] / *length;
    }
    return walk(c, zero, ray, *length, way, q);
}

#define SIDE 6
/* The state at y, inside the zone, from SIDE points on either side along the line of motion. */
static int interpolated_state(const Chart *c, double t, const double *y, const double *w, const double *x,
                              double spacing, double *q_out, double *v_out, double *a, double *x_dot, const double *u)
{
    static const double WEIGHTS[SIDE] = {6.0 / 7.0, -15.0 / 28.0, 5.0 / 21.0, -1.0 / 14.0, 1.0 / 77.0, -1.0 / 924.0};
    double direction[FREE], speed = 0.0, begin[FREE], length, q[NQ1], last[NV1];
    double zs[NV1] = {0.0}, vs[NV1] = {0.0}, as[NV1] = {0.0}, xs[NX1] = {0.0};
    Walk way, line;
    for (int j = 0; j < FREE; ++j) {
        speed += w[j] * w[j];
    }
    if (!(speed > 0.0)) {
        return AT_REST; /* nothing says along which branch */
    }
    for (int j = 0; j < FREE; ++j) {
        direction[j] = w[j] / sqrt(speed);
        begin[j] = y[j] - SIDE * spacing * direction[j];
    }
    int outcome = reach(c, begin, &way, &length, q);
    if (outcome != 0) {
        return outcome;
    }
    local_coordinates(c->base, q, last);
    scaled(last);
    line.count = 0;
    remember(&line, -SIDE * spacing, last);
    for (int i = -SIDE; i <= SIDE; ++i) {
        double vi[NV1], ai[NV1], xi[NX1], zi[NV1];
        if (i == 0) {
            continue;
        }
        outcome = i > -SIDE ? walk(c, y, direction, i * spacing, &line, q) : 0;
        if (outcome == 0) {
            outcome = state_on_branch(c, t, q, w, x, vi, a == NULL ? NULL : ai, xi, u);
        }
        if (outcome != 0) {
            return outcome;
        }
        const double weight = WEIGHTS[(i < 0 ? -i : i) - 1];
        local_coordinates(c->base, q, zi);
        for (int k = 0; k < NV; ++k) {
            zs[k] += weight * zi[k];
            vs[k] += weight * vi[k];
            as[k] += a == NULL ? 0.0 : weight * ai[k];
        }
        for (int k = 0; k < NX && a != NULL; ++k) {
            xs[k] += weight * xi[k];
        }
    }
    retract(c->base, zs, q_out);
    memcpy(v_out, vs, sizeof(double) * NV);
    if (a != NULL) {
        memcpy(a, as, sizeof(double) * NV);
        memcpy(x_dot, xs, sizeof(double) * NX);
    }
    return 0;
}

/* The branch over the tangential coordinates of (z, v): q, v on it and, if a is not NULL, accelerations and x_dot. */
static int branch_state(const Chart *c, double t, const double *z, const double *v, const double *x, double *q_out,
                        double *v_out, double *a, double *x_dot, double *smallest, const double *u)
{
    double y[FREE], w[FREE], q[NQ1], moved;
    Opening o;
    Rows f;
    tangential(c, z, y);
    tangential(c, v, w);
    retract(c->base, z, q);
    int outcome = corrected(c, y, q, &o, &f, &moved);
    if (outcome != 0 || moved > 0.1 * f.smallest / c->slope) {
        Walk way;
        double length;
        outcome = reach(c, y, &way, &length, q);
    }
    if (outcome == 0) {
        if (opening(q, &o) != 0) {
            return FAILED;
        }
        row_space(&o, RANK_FLOOR, &f);
        *smallest = f.smallest;
        if (rates_on_branch(c, &o, &f, w, v_out) != 0) {
            return FAILED;
        }
        memcpy(q_out, q, sizeof(double) * NQ);
        return a == NULL ? 0 : valid(forces_at(t, q_out, v_out, x, u, a, x_dot));
    }
    if (outcome != IN_ZONE) {
        return FAILED;
    }
    const double least = SPACING * c->scale, first = fmin(fmax(least, 2.1 * ZONE / c->slope), 8.0 * least);
    for (double spacing = first; spacing < 16.0 * least; spacing *= 1.4) {
        outcome = interpolated_state(c, t, y, w, x, spacing, q_out, v_out, a, x_dot, u);
        if (outcome != IN_ZONE) {
            break;
        }
    }
    if (outcome != 0 || opening(q_out, &o) != 0) {
        return outcome == AT_REST ? AT_REST : FAILED;
    }
    /* What the interpolation left open in the rows that are regular here too. */
    for (int step = 0; step < 3; ++step) {
        double d[NV1];
        row_space(&o, ZONE, &f);
        if (step == 2) {
            break;
        }
        if (shortest_across(c, &f, o.residual, d) != 0) {
            return FAILED;
        }
        for (int k = 0; k < NV; ++k) {
            d[k] *= -UNIT[k];
        }
        retract(q_out, d, q);
        memcpy(q_out, q, sizeof(double) * NQ);
        if (opening(q_out, &o) != 0) {
            return FAILED;
        }
    }
    double rates[NR], change[NV1];
    closure_rates(&o, v_out, rates);
    if (shortest_across(c, &f, rates, change) != 0) {
        return FAILED;
    }
    for (int k = 0; k < NV; ++k) {
        v_out[k] -= change[k] * UNIT[k];
    }
    row_space(&o, RANK_FLOOR, &f);
    *smallest = f.smallest;
    return 0;
}
#endif
