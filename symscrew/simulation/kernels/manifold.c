/* Local coordinates of a configuration, and the way back onto the manifold.
 *
 * Local coordinates z (NV) count from a base configuration: a plain coordinate moves by z, a quaternion turns
 * by the rotation vector z in the axes of the child, q = base exp(z). Their rates are z_dot = dexpinv(z) v
 * (Iserles et al., Lie-group methods, Acta Numerica 2000, eq. (2.46), for body-fixed rates).
 */

/* The rank-revealing path of forward dynamics gives valid accelerations too. */
static int valid(int outcome)
{
    return outcome < 0 || outcome == LEAST_SQUARES ? 0 : outcome;
}

static void retract(const double *base, const double *z, double *q)
{
    for (int i = 0; i < PLAIN_COUNT; ++i) {
        q[PLAIN[i][0]] = base[PLAIN[i][0]] + z[PLAIN[i][1]];
    }
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        const double *b = base + SPHERES[i][0], *r = z + SPHERES[i][1];
        double *o = q + SPHERES[i][0];
        const double square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
        double c, s; /* cosine of half the angle, its sine by the angle */
        if (square < 1e-4) {
            c = 1.0 - square / 8.0 * (1.0 - square / 48.0 * (1.0 - square / 120.0));
            s = 0.5 * (1.0 - square / 24.0 * (1.0 - square / 80.0 * (1.0 - square / 168.0)));
        } else {
            const double angle = sqrt(square);
            c = cos(0.5 * angle);
            s = sin(0.5 * angle) / angle;
        }
        const double x = s * r[0], y = s * r[1], w = s * r[2];
        const double t0 = b[0] * c - b[1] * x - b[2] * y - b[3] * w;
        const double t1 = b[0] * x + b[1] * c + b[2] * w - b[3] * y;
        const double t2 = b[0] * y - b[1] * w + b[2] * c + b[3] * x;
        const double t3 = b[0] * w + b[1] * y - b[2] * x + b[3] * c;
        const double inverse = 1.0 / sqrt(t0 * t0 + t1 * t1 + t2 * t2 + t3 * t3);
        o[0] = t0 * inverse;
        o[1] = t1 * inverse;
        o[2] = t2 * inverse;
        o[3] = t3 * inverse;
    }
}

static void local_coordinates(const double *base, const double *q, double *z)
{
    for (int i = 0; i < PLAIN_COUNT; ++i) {
        z[PLAIN[i][1]] = q[PLAIN[i][0]] - base[PLAIN[i][0]];
    }
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        const double *b = base + SPHERES[i][0], *o = q + SPHERES[i][0];
        double *r = z + SPHERES[i][1];
        double w = b[0] * o[0] + b[1] * o[1] + b[2] * o[2] + b[3] * o[3];
        const double sign = w < 0.0 ? -1.0 : 1.0;
        const double x = sign * (b[0] * o[1] - b[1] * o[0] - b[2] * o[3] + b[3] * o[2]);
        const double y = sign * (b[0] * o[2] + b[1] * o[3] - b[2] * o[0] - b[3] * o[1]);
        const double u = sign * (b[0] * o[3] - b[1] * o[2] + b[2] * o[1] - b[3] * o[0]);
        const double sine = sqrt(x * x + y * y + u * u);
        w *= sign;
        const double factor = sine < 1e-9 ? 2.0 : 2.0 * atan2(sine, w) / sine;
        r[0] = factor * x;
        r[1] = factor * y;
        r[2] = factor * u;
    }
}

static void local_rates(const double *z, const double *v, double *z_dot)
{
    for (int i = 0; i < NV; ++i) {
        z_dot[i] = v[i];
    }
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        const double *r = z + SPHERES[i][1], *w = v + SPHERES[i][1];
        double *o = z_dot + SPHERES[i][1];
        const double square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
        double factor;
        if (square < 1e-2) {
            factor = 1.0 / 12.0 + square * (1.0 / 720.0 + square * (1.0 / 30240.0 + square / 1209600.0));
        } else {
            const double angle = sqrt(square);
            factor = (1.0 - 0.5 * angle / tan(0.5 * angle)) / square;
        }
        const double a = r[1] * w[2] - r[2] * w[1], b = r[2] * w[0] - r[0] * w[2], c = r[0] * w[1] - r[1] * w[0];
        o[0] = w[0] + 0.5 * a + factor * (r[1] * c - r[2] * b);
        o[1] = w[1] + 0.5 * b + factor * (r[2] * a - r[0] * c);
        o[2] = w[2] + 0.5 * c + factor * (r[0] * b - r[1] * a);
    }
}

#if NR
static double largest(const double *values, int count)
{
    double most = 0.0;
    for (int i = 0; i < count; ++i) {
        most = fmax(most, fabs(values[i]));
        most = isfinite(values[i]) ? most : 1e300;
    }
    return most;
}

static void closure_rates(const Opening *o, const double *v, double *rates)
{
    for (int i = 0; i < NR; ++i) {
        rates[i] = 0.0;
    }
    for (int e = 0; e < ENTRIES; ++e) {
        rates[ENTRY[e][0]] += o->value[e] * (v[ENTRY[e][1]] / UNIT[ENTRY[e][1]]);
    }
}

/* An opening that rounding of the coordinates may leave: 45 units in the last place of the largest one. */
static double nearly_closed(const double *q)
{
    double size = 1.0;
    for (int i = 0; i < PLAIN_COUNT; ++i) {
        size = fmax(size, 0.01 * fabs(q[PLAIN[i][0]]) / UNIT[PLAIN[i][1]]);
    }
    return NEARLY_CLOSED * size;
}

/* Puts q and v back onto the closure by steps of smallest weighted norm, down to rounding: what is left between would
 * be left to the same side step after step. The pivot found on the way tells how near a singular configuration is.
 * 0, or FAILED if the loops cannot be closed from here. */
static int settle(double *q, double *v, double *smallest)
{
    Opening o;
    Rows f;
    double d[NV1], rates[NR], before = 1e300;
    if (opening(q, &o) != 0) {
        return FAILED;
    }
    row_space(&o, RANK_FLOOR, &f);
    *smallest = f.smallest;
    for (int step = 0; step < MOST_CORRECTIONS; ++step) {
        const double open = largest(o.residual, NR), enough = nearly_closed(q);
        if (!(open < 1e299) || (open > enough && open >= 0.5 * before)) {
            return FAILED;
        }
        if (open > 0.1 * before) {
            row_space(&o, RANK_FLOOR, &f);
        }
        const int last = open < CLOSED || (open <= enough && open >= 0.5 * before);
        before = open;
        shortest(&f, o.residual, d);
        if (largest(d, NV) > 1.0) {
            return FAILED;
        }
        double z[NV1], moved[NQ1];
        for (int k = 0; k < NV; ++k) {
            z[k] = -d[k] * UNIT[k];
        }
        retract(q, z, moved);
        memcpy(q, moved, sizeof(double) * NQ);
        if (last) {
            break;
        }
        if (step == MOST_CORRECTIONS - 1 || opening(q, &o) != 0) {
            return FAILED;
        }
    }
    for (int step = 0; step < 3; ++step) { /* the factors may be of a configuration nearby: each takes six digits */
        closure_rates(&o, v, rates);
        const double open = largest(rates, NR);
        shortest(&f, rates, d);
        for (int k = 0; k < NV; ++k) {
            v[k] -= d[k] * UNIT[k];
        }
        if (open <= SETTLED * largest(v, NV)) {
            break;
        }
    }
    return 0;
}
#else
static int settle(double *q, double *v, double *smallest)
{
    (void)q;
    (void)v;
    *smallest = 1.0;
    return 0;
}
#endif
