/* The closure of the loops without units, dense: its rows made orthonormal one after the other, the longest first;
 * shortest corrections in the independent rows. Stands on closure_at(q, residual, jacobian), column-major. */

#define FAILED 1001
#define LEAST_SQUARES 5

/* The rank-revealing path of forward dynamics gives valid accelerations too. */
static int valid(int outcome)
{
    return outcome < 0 || outcome == LEAST_SQUARES ? 0 : outcome;
}

static void coordinate_rates(const double *q, const double *v, double *q_dot)
{
    for (int i = 0; i < PLAIN_COUNT; ++i) {
        q_dot[PLAIN[i][0]] = v[PLAIN[i][1]];
    }
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        const double *w = v + SPHERES[i][1], *r = q + SPHERES[i][0];
        double *o = q_dot + SPHERES[i][0];
        o[0] = -0.5 * (w[0] * r[1] + w[1] * r[2] + w[2] * r[3]);
        o[1] = 0.5 * (r[0] * w[0] - w[1] * r[3] + w[2] * r[2]);
        o[2] = 0.5 * (r[0] * w[1] - w[2] * r[1] + w[0] * r[3]);
        o[3] = 0.5 * (r[0] * w[2] - w[0] * r[2] + w[1] * r[1]);
    }
}

static void normalise(double *q)
{
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        double *o = q + SPHERES[i][0];
        const double scale = 1.0 / sqrt(o[0] * o[0] + o[1] * o[1] + o[2] * o[2] + o[3] * o[3]);
        for (int k = 0; k < 4; ++k) {
            o[k] *= scale;
        }
    }
}

#if NR
typedef struct {
    double residual[NR], jacobian[NR][NV1];
    double basis[RANK1][NV1], lower[NR][RANK1];
    int order[NR], rank;
} Closure;

static int opened(const double *q, Closure *c)
{
    double raw[NR], columns[NR * NV1];
    const int outcome = closure_at(q, raw, columns);
    for (int i = 0; i < NR; ++i) {
        c->residual[i] = raw[i] * ROW_SCALE[i];
        for (int k = 0; k < NV; ++k) {
            c->jacobian[i][k] = columns[k * NR + i] * ROW_SCALE[i] * UNIT[k];
        }
    }
    return outcome > 0 ? outcome : 0;
}

static double inner(const double *a, const double *b)
{
    double total = 0.0;
    for (int k = 0; k < NV; ++k) {
        total += a[k] * b[k];
    }
    return total;
}

static void orthonormal(Closure *c)
{
    double rows[NR][NV1];
    memcpy(rows, c->jacobian, sizeof rows);
    for (int i = 0; i < NR; ++i) {
        c->order[i] = i;
    }
    for (c->rank = 0; c->rank < RANK; ++c->rank) {
        const int r = c->rank;
        int best = r;
        for (int i = r + 1; i < NR; ++i) {
            best = inner(rows[c->order[i]], rows[c->order[i]]) > inner(rows[c->order[best]], rows[c->order[best]]) ? i : best;
        }
        const int chosen = c->order[best];
        c->order[best] = c->order[r];
        c->order[r] = chosen;
        for (int j = 0; j < r; ++j) { /* once more: rounding must not tilt a short row */
            const double along = inner(rows[chosen], c->basis[j]);
            for (int k = 0; k < NV; ++k) {
                rows[chosen][k] -= along * c->basis[j][k];
            }
        }
        const double norm = sqrt(inner(rows[chosen], rows[chosen]));
        if (norm < 1e-10) {
            break;
        }
        for (int k = 0; k < NV; ++k) {
            c->basis[r][k] = rows[chosen][k] / norm;
        }
        c->lower[chosen][r] = norm;
        for (int i = r + 1; i < NR; ++i) {
            const int other = c->order[i];
            const double along = inner(rows[other], c->basis[r]);
            for (int k = 0; k < NV; ++k) {
                rows[other][k] -= along * c->basis[r][k];
            }
            c->lower[other][r] = along;
        }
    }
}

/* The shortest d with jacobian d = right in the independent rows. */
static void shortest(const Closure *c, const double *right, double *d)
{
    double amount[RANK1];
    memset(d, 0, sizeof(double) * NV);
    for (int r = 0; r < c->rank; ++r) {
        const int row = c->order[r];
        double value = right[row];
        for (int j = 0; j < r; ++j) {
            value -= c->lower[row][j] * amount[j];
        }
        amount[r] = value / c->lower[row][r];
        for (int k = 0; k < NV; ++k) {
            d[k] += amount[r] * c->basis[r][k];
        }
    }
}

static void closure_rates(const Closure *c, const double *v, double *rates)
{
    double scaled[NV1];
    for (int k = 0; k < NV; ++k) {
        scaled[k] = v[k] / UNIT[k];
    }
    for (int i = 0; i < NR; ++i) {
        rates[i] = inner(c->jacobian[i], scaled);
    }
}

static double largest(const double *values, int count)
{
    double most = 0.0;
    for (int i = 0; i < count; ++i) {
        most = fabs(values[i]) <= most ? most : fabs(values[i]);
    }
    return most;
}

/* Puts q and v back onto the closure by shortest steps: with the rows at the first q, which it makes anew only where
 * they do not bring the loops closer by a factor of ten. */
static int projected(double *q, double *v)
{
    Closure c;
    double d[NV1], q_dot[NQ1], rates[NR], before = 1e300;
    if (opened(q, &c) != 0) {
        return FAILED;
    }
    orthonormal(&c);
    for (int pass = 0;; ++pass) {
        const double open = largest(c.residual, NR);
        if (open < 1e-14 || (open < 1e-12 && open >= 0.5 * before)) {
            break;
        }
        if (!(open < 1e3) || pass == 12) {
            return FAILED;
        }
        if (open > 0.1 * before) {
            orthonormal(&c);
        }
        before = open;
        shortest(&c, c.residual, d);
        for (int k = 0; k < NV; ++k) {
            d[k] *= -UNIT[k];
        }
        coordinate_rates(q, d, q_dot);
        for (int k = 0; k < NQ; ++k) {
            q[k] += q_dot[k];
        }
        normalise(q);
        if (opened(q, &c) != 0) {
            return FAILED;
        }
    }
    for (int pass = 0; pass < 3; ++pass) {
        closure_rates(&c, v, rates);
        if (largest(rates, NR) < 1e-14 * (1.0 + largest(v, NV))) {
            break;
        }
        shortest(&c, rates, d);
        for (int k = 0; k < NV; ++k) {
            v[k] -= d[k] * UNIT[k];
        }
    }
    return 0;
}
#endif
