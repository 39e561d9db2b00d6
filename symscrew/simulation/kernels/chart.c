/* Charts of a branch: the graph over the tangent space of an anchor, and Newton's method at fixed coordinates on it. */
#if NR && FREE

typedef struct {
    double base[NQ1];           /* the anchor */
    double tangent[FREE][NV1];  /* orthonormal, without units */
    double scale;               /* length of the motion by its largest part: distances grow with it, not parts */
    double slope;               /* of the pivot along the way: pivot by slope is the distance to the zone's middle */
} Chart;

static int tangent_space(Rows *f, double (*tangent)[NV1])
{
    int found = 0;
    for (int k = 0; k < FRONTS; ++k) { /* what the rows of a tree of fronts leave is left in its top */
        const Front *s = FRONT + k;
        double *vectors = f->turn + s->turn, local[WIDTHS];
        for (int r = f->rank[k]; r < s->width && s->parent < 0 && found < FREE; ++r) {
            if (another(vectors, r, s->width) != 0) {
                return FAILED;
            }
            clear(local, WIDTHS);
            for (int i = 0; i < s->width; ++i) {
                local[s->at + i] = vectors[r * s->width + i];
            }
            memset(tangent[found], 0, sizeof tangent[found]);
            spread(f, NULL, local, tangent[found++]);
        }
    }
    for (int k = 0; k < NV && found < FREE; ++k) {
        if (SPOT[k] < 0) { /* no row knows this rate */
            memset(tangent[found], 0, sizeof tangent[found]);
            tangent[found++][k] = 1.0;
        }
    }
    return found == FREE ? 0 : FAILED;
}

/* The shortest d with jacobian d = right for the independent rows and nothing along the tangents. */
static int shortest_across(const Chart *c, const Rows *f, const double *right, double *d)
{
    double free[FREE][NV1], matrix[FREE][FREE], w[FREE];
    shortest(f, right, d);
    for (int j = 0; j < FREE; ++j) { /* what no row sees of the tangents, and how much of d is along them */
        unseen(f, c->tangent[j], free[j]);
        w[j] = -product(c->tangent[j], d, NV);
    }
    for (int j = 0; j < FREE; ++j) { /* Cholesky's factorisation, and forwards */
        for (int i = j; i < FREE; ++i) {
            matrix[i][j] = product(free[i], free[j], NV);
            for (int k = 0; k < j; ++k) {
                matrix[i][j] -= matrix[i][k] * matrix[j][k];
            }
            if (i == j && !(matrix[j][j] > 1e-12)) { /* the chart has turned over */
                return FAILED;
            }
            matrix[i][j] = i == j ? sqrt(matrix[j][j]) : matrix[i][j] / matrix[j][j];
        }
        for (int k = 0; k < j; ++k) {
            w[j] -= matrix[j][k] * w[k];
        }
        w[j] /= matrix[j][j];
    }
    for (int j = FREE - 1; j >= 0; --j) {
        for (int k = j + 1; k < FREE; ++k) {
            w[j] -= matrix[k][j] * w[k];
        }
        w[j] /= matrix[j][j];
        for (int k = 0; k < NV; ++k) {
            d[k] += w[j] * free[j][k];
        }
    }
    return 0;
}

static void tangential(const Chart *c, const double *z, double *y)
{
    for (int j = 0; j < FREE; ++j) {
        y[j] = 0.0;
        for (int k = 0; k < NV; ++k) {
            y[j] += c->tangent[j][k] * (z[k] / UNIT[k]);
        }
    }
}

/* Newton from q to the point of the branch with tangential coordinates y. `moved`: size of the first correction. */
static int corrected(const Chart *c, const double *y, double *q, Opening *o, Rows *f, double *moved)
{
    double z[NV1], here[FREE], right[NR], d[NV1], next[NQ1], before = 1e300;
    *moved = -1.0;
    for (int step = 0; step < 12; ++step) {
        if (opening(q, o) != 0) {
            return FAILED;
        }
        row_space(o, RANK_FLOOR, f);
        if (f->smallest < ZONE) {
            return IN_ZONE;
        }
        local_coordinates(c->base, q, z);
        tangential(c, z, here);
        double along[NV1], off = 0.0;
        for (int k = 0; k < NV; ++k) {
            along[k] = 0.0;
        }
        for (int j = 0; j < FREE; ++j) {
            off = fmax(off, fabs(y[j] - here[j]));
            for (int k = 0; k < NV; ++k) {
                along[k] += (y[j] - here[j]) * c->tangent[j][k];
            }
        }
        for (int i = 0; i < NR; ++i) {
            right[i] = -o->residual[i];
        }
        subtract_product(o, along, right);
        if (shortest_across(c, f, right, d) != 0) {
            return FAILED;
        }
        const double open = fmax(off, largest(o->residual, NR));
        if (!(open < 1e3 * before)) {
            return FAILED;
        }
        const int last = open < CLOSED || (open < NEARLY_CLOSED && open > 0.5 * before);
        before = open;
        double size = 0.0;
        for (int k = 0; k < NV; ++k) {
            size += d[k] * d[k];
            z[k] = (d[k] + along[k]) * UNIT[k];
        }
        if (*moved < 0.0) {
            *moved = sqrt(size);
        }
        if (!(size < c->scale * c->scale)) {
            return FAILED;
        }
        retract(q, z, next);
        memcpy(q, next, sizeof(double) * NQ);
        if (last) { /* that step too: near the zone every digit of q counts */
            return 0;
        }
    }
    return FAILED;
}
#endif
