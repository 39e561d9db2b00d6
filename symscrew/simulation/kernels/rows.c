/* The row space of the closure, front by front (fronts.py), and what is shortest in it.
 *
 * The live rows of a front are made orthonormal one after the other, the longest remaining row first, over the
 * front's directions: its own rates, then the directions that its children leave. A front below a parent completes
 * its vectors to an orthonormal basis and passes the rest on; a front at the top of its tree need not. No vector is
 * ever as long as the mechanism is, so that a chain of loops costs as much per loop however long it is.
 */
#if NR
/* The closure's Jacobian without units (rows by ROW_SCALE, columns by UNIT): its ENTRIES that are not always zero, at
 * rows and columns ENTRY. Only the LIVE rows have any. */
typedef struct {
    double residual[NR];
    double value[ENTRIES1];
} Opening;

static int opening(const double *q, Opening *o)
{
    const int outcome = closure_at(q, o->residual, o->value);
    for (int i = 0; i < NR; ++i) {
        o->residual[i] *= ROW_SCALE[i];
    }
    for (int e = 0; e < ENTRIES; ++e) {
        o->value[e] *= ROW_SCALE[ENTRY[e][0]] * UNIT[ENTRY[e][1]];
    }
    return outcome;
}

/* right -= jacobian d. */
static void subtract_product(const Opening *o, const double *d, double *right)
{
    for (int e = 0; e < ENTRIES; ++e) {
        right[ENTRY[e][0]] -= o->value[e] * d[ENTRY[e][1]];
    }
}

typedef struct {
    int row, rows;     /* its live rows */
    int pivot, rank;   /* their pivots, in a regular configuration */
    int at, width;     /* its directions */
    int own;           /* the first of them: rates that come in here */
    int parent, up;    /* the directions that it leaves are its parent's from `up` on; parent -1: a top */
    int turn;          /* its orthonormal vectors */
} Front;

/* `smallest` is the last pivot that a regular configuration has in each front, the smallest of them: it tends to zero
 * with the smallest singular value. In a top, rows shorter than `floor` are as if they were not there (`rank`); below
 * a parent they only do not count (`inverse` 0), for the width of what goes on is fixed. */
typedef struct {
    double turn[TURNS];
    double lower[LOWERS];
    double pivot[RANK1], inverse[RANK1];
    int order[LIVE1];
    int rank[FRONTS];
    double smallest;
} Rows;

static const Front FRONT[FRONTS] = FRONT_TABLE;

static inline double product(const double *a, const double *b, int width)
{
    double sum[4] = {0.0, 0.0, 0.0, 0.0};
    int k = 0;
    if (width < 4) {
        for (; k < width; ++k) {
            sum[0] += a[k] * b[k];
        }
        return sum[0];
    }
    for (; k + 4 <= width; k += 4) {
        for (int i = 0; i < 4; ++i) {
            sum[i] += a[k + i] * b[k + i];
        }
    }
    for (; k < width; ++k) {
        sum[0] += a[k] * b[k];
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static inline double without(double *row, const double *direction, int width)
{
    const double along = product(row, direction, width);
    for (int k = 0; k < width; ++k) {
        row[k] -= along * direction[k];
    }
    return along;
}

static void clear(double *values, int count)
{
    for (int k = 0; k < count; ++k) {
        values[k] = 0.0;
    }
}

/* One more unit vector across the first `count` of a front: the axis that they leave most of. */
static int another(double *vectors, int count, int width)
{
    double *vector = vectors + count * width, most = -1.0;
    int best = 0;
    for (int k = 0; k < width; ++k) {
        double left = 1.0;
        for (int j = 0; j < count; ++j) {
            left -= vectors[j * width + k] * vectors[j * width + k];
        }
        if (left > most * (1.0 + 1e-9)) {
            most = left;
            best = k;
        }
    }
    for (int k = 0; k < width; ++k) {
        vector[k] = k == best ? 1.0 : 0.0;
    }
    for (int pass = 0; pass < 2; ++pass) {
        for (int j = 0; j < count; ++j) {
            without(vector, vectors + j * width, width);
        }
    }
    const double size = sqrt(product(vector, vector, width));
    if (!(size > 1e-10)) {
        return FAILED;
    }
    for (int k = 0; k < width; ++k) {
        vector[k] /= size;
    }
    return 0;
}

/* A live row in its front's directions; its parts along the vectors of fronts below go to f->lower. */
static void enter(const Opening *o, int row, Rows *f, const Front *s, double *entered)
{
    double local[WIDTHS], *lower = f->lower + LOWER_AT[row];
    for (int i = PATH_START[row]; i < PATH_START[row + 1]; ++i) {
        clear(local + FRONT[PATH[i]].at, FRONT[PATH[i]].width);
    }
    clear(local + s->at, s->width);
    for (int e = ENTRY_START[LIVE_ROW[row]]; e < ENTRY_START[LIVE_ROW[row] + 1]; ++e) {
        local[SPOT[ENTRY[e][1]]] = o->value[e];
    }
    for (int i = PATH_START[row]; i < PATH_START[row + 1]; ++i) {
        const Front *below = FRONT + PATH[i];
        for (int r = 0; r < below->width; ++r) {
            const double along = product(f->turn + below->turn + r * below->width, local + below->at, below->width);
            if (r < below->rank) {
                *lower++ = along;
            } else {
                local[below->up + r - below->rank] = along;
            }
        }
    }
    for (int k = 0; k < s->width; ++k) {
        entered[k] = local[s->at + k];
    }
}

static void front_space(const Opening *o, double floor, int index, Rows *f)
{
    const Front *s = FRONT + index;
    const int width = s->width;
    double rows[MOST_ROWS][MOST_WIDTH], square[MOST_ROWS], whole[MOST_ROWS];
    double *lower[MOST_ROWS], *vectors = f->turn + s->turn;
    int *order = f->order + s->row;
    for (int i = 0; i < s->rows; ++i) {
        enter(o, s->row + i, f, s, rows[i]);
        lower[i] = f->lower + LOWER_AT[s->row + i + 1] - s->rank;
        order[i] = i;
        whole[i] = square[i] = product(rows[i], rows[i], width);
    }
    int r = 0;
    for (; r < s->rank; ++r) {
        int best = r;
        for (int i = r + 1; i < s->rows; ++i) {
            best = square[order[i]] > square[order[best]] ? i : best;
        }
        const int chosen = order[best];
        order[best] = order[r];
        order[r] = chosen;
        double *row = rows[chosen];
        const double left = product(row, row, width);
        const int every = left < 1e-10 * whole[chosen];
        for (int j = 0; j < r && left < TILTED * whole[chosen]; ++j) { /* once more: rounding tilts a short row */
            if (every || lower[chosen][j] != 0.0) {
                without(row, vectors + j * width, width);
            }
        }
        const double norm = sqrt(product(row, row, width));
        f->smallest = norm < f->smallest ? norm : f->smallest;
        f->pivot[s->pivot + r] = norm;
        f->inverse[s->pivot + r] = norm < floor ? 0.0 : 1.0 / norm;
        if (norm < floor && s->parent < 0) {
            break;
        }
        if (norm < 1e-13) {
            another(vectors, r, width);
        } else {
            for (int k = 0; k < width; ++k) {
                vectors[r * width + k] = row[k] / norm;
            }
        }
        for (int i = r + 1; i < s->rows; ++i) {
            const int other = order[i];
            const double along = lower[other][r] = without(rows[other], vectors + r * width, width);
            square[other] -= along * along;
            if (square[other] < 1e-4 * whole[other]) { /* digits are lost */
                square[other] = product(rows[other], rows[other], width);
            }
        }
    }
    f->rank[index] = r;
    for (; r < s->rank; ++r) {
        f->pivot[s->pivot + r] = f->inverse[s->pivot + r] = 0.0;
    }
    for (; s->parent >= 0 && r < width; ++r) {
        another(vectors, r, width);
    }
}

static void row_space(const Opening *o, double floor, Rows *f)
{
    f->smallest = 1e300;
    for (int k = 0; k < FRONTS; ++k) {
        front_space(o, floor, k, f);
    }
    if (RANK == 0) { /* no row restricts the tree: none can be lost */
        f->smallest = PIVOT;
    }
}

/* The vector with parts c along the pivots' vectors (NULL: none) and what `local` has in the tops besides. Rates that
 * no row knows stay as they are. */
static void spread(const Rows *f, const double *c, double *local, double *d)
{
    for (int k = FRONTS - 1; k >= 0; --k) {
        const Front *s = FRONT + k;
        const double *vectors = f->turn + s->turn;
        double *here = local + s->at;
        const int count = s->parent < 0 ? f->rank[k] : s->width;
        if (s->parent >= 0) {
            clear(here, s->width);
        }
        for (int r = c == NULL ? (s->parent < 0 ? count : s->rank) : 0; r < count; ++r) {
            const double part = r < s->rank ? c[s->pivot + r] : local[s->up + r - s->rank];
            for (int i = 0; i < s->width; ++i) {
                here[i] += part * vectors[r * s->width + i];
            }
        }
        for (int i = 0; i < s->own; ++i) {
            d[COLUMN[s->at + i]] = here[i];
        }
    }
}

/* The shortest d with jacobian d = right for the independent rows. */
static void shortest(const Rows *f, const double *right, double *d)
{
    double c[RANK1], local[WIDTHS];
    memset(local, 0, sizeof local);
    memset(d, 0, sizeof(double) * NV);
    for (int k = 0; k < FRONTS; ++k) {
        const Front *s = FRONT + k;
        for (int r = 0; r < f->rank[k]; ++r) {
            const int row = s->row + f->order[s->row + r];
            const double *lower = f->lower + LOWER_AT[row];
            double value = right[LIVE_ROW[row]];
            for (int i = PATH_START[row]; i < PATH_START[row + 1]; ++i) {
                const Front *below = FRONT + PATH[i];
                for (int j = 0; j < below->rank; ++j) {
                    value -= *lower++ * c[below->pivot + j];
                }
            }
            for (int j = 0; j < r; ++j) {
                value -= lower[j] * c[s->pivot + j];
            }
            c[s->pivot + r] = value * f->inverse[s->pivot + r];
        }
    }
    spread(f, c, local, d);
}

/* What no row sees of x. */
static void unseen(const Rows *f, const double *x, double *rest)
{
    double local[WIDTHS];
    for (int k = 0; k < FRONTS; ++k) {
        const Front *s = FRONT + k;
        for (int i = 0; i < s->own; ++i) {
            local[s->at + i] = x[COLUMN[s->at + i]];
        }
    }
    for (int k = 0; k < FRONTS; ++k) {
        const Front *s = FRONT + k;
        const double *vectors = f->turn + s->turn;
        for (int r = s->parent < 0 ? 0 : s->rank; r < (s->parent < 0 ? f->rank[k] : s->width); ++r) {
            if (s->parent < 0) {
                without(local + s->at, vectors + r * s->width, s->width);
            } else {
                local[s->up + r - s->rank] = product(local + s->at, vectors + r * s->width, s->width);
            }
        }
    }
    memcpy(rest, x, sizeof(double) * NV);
    spread(f, NULL, local, rest);
}
#endif
