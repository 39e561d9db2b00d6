/* A step of sequential quadratic programming, stage by stage: the minimum of a quadratic cost between bounds.

   Stage k has states x_k and controls w_k, z_k = (x_k, w_k), steps from where the program was evaluated:

       min  sum z_k' H_k z_k / 2 + g_k' z_k     x_{k+1} = T_k z_k + t_k,   low <= (z_k, C_k z_k) <= high

   The bounds that hold as equations are guessed from the last multipliers, solved for exactly, and guessed again from
   the solution, until nothing changes (a primal-dual active set: M. Hintermueller, K. Ito, K. Kunisch, SIAM J. Optim.
   13(3), 2002). With the bounds chosen, unknowns are eliminated backwards in time: equations that the controls of a
   stage cannot meet become conditions on its states, for the stage before. So a cost that is indefinite across the
   equations of a stage does no harm where the whole is convex on all of them. */

#include <math.h>
#include <stddef.h>
#include <string.h>

enum { LOW = -1, FREE = 0, HIGH = 1, EQUATION = 2 };
enum { SOLVED, NOT_CONVEX, CONTRADICTION, UNSETTLED };

/* Entries of equations between unknowns near 1 that are rounding: of sums of up to a hundred terms. */
static const double NOTHING = 1e-10;
/* Curvature, as a part of the largest of the stage, at which a cost is called flat. */
static const double FLAT = 1e-14;
/* By how much a bound may be missed, or a multiplier have the wrong sign, before the guess changes. */
static const double MISSED = 1e-11;

typedef struct {
    int nx, nw, paths, next, n, length;     /* sizes; states of the next stage; nx + nw; length of a row of `table` */
    const double *hessian, *gradient, *rows, *offset; /* H, g, T above C, t */
    const double *low, *high;               /* of z and of the paths */
    int *state;                             /* which of them hold */
    double *multiplier;                     /* of the same */
    double *z;                              /* the solution */
    double *costate;                        /* multipliers of x_{k+1} = T z + t */
    double *full, *linear;                  /* cost along z, with the best that can follow: M, m */
    double *left, *slope;                   /* the same, of what is not eliminated yet */
    double *rule;                           /* z_i = rule_i . (z, 1) of those that are eliminated */
    double *table;                          /* equations: [z | right side | combination of those that were given] */
    double *pull;                           /* multipliers of the conditions on the states */
    int *who;                               /* what a given equation is of: z or path, or -1 - condition behind */
    int *pivot;                             /* what an equation is solved for */
    int *sequence;                          /* what is eliminated, in order */
    int equations, by_controls, by_states, eliminated;
} Stage;

static double *row_of(const Stage *s, int row)
{
    return s->table + (ptrdiff_t)row * s->length;
}

/* The equations of a stage: bounds that hold, and the conditions on the next states. */
static void collect(Stage *s, const Stage *after)
{
    const int n = s->n;
    int count = 0;
    for (int k = 0; k < n + s->paths; ++k) {
        if (s->state[k] != FREE) {
            double *row = row_of(s, count);
            memset(row, 0, (size_t)s->length * sizeof *row);
            if (k < n) {
                row[k] = 1.0;
            } else {
                memcpy(row, s->rows + (ptrdiff_t)(s->next + k - n) * n, (size_t)n * sizeof *row);
            }
            row[n] = s->state[k] == HIGH ? s->high[k] : s->low[k];
            s->who[count++] = k;
        }
    }
    for (int c = 0; after != NULL && c < after->by_states; ++c) {
        const double *condition = row_of(after, after->by_controls + c);
        double *row = row_of(s, count);
        memset(row, 0, (size_t)s->length * sizeof *row);
        row[n] = condition[after->n];
        for (int i = 0; i < s->next; ++i) {
            if (condition[i] != 0.0) {
                for (int j = 0; j < n; ++j) {
                    row[j] += condition[i] * s->rows[(ptrdiff_t)i * n + j];
                }
                row[n] -= condition[i] * s->offset[i];
            }
        }
        s->who[count++] = -1 - c;
    }
    for (int r = 0; r < count; ++r) {
        row_of(s, r)[n + 1 + r] = 1.0;
    }
    s->equations = count;
}

/* Solve the equations from `first` on for the largest entries of columns [from, to), Gauss and Jordan. How many are. */
static int solve_for(Stage *s, int first, int from, int to)
{
    const int used = s->n + 1 + s->equations;
    int done = first;
    while (done < s->equations) {
        double largest = NOTHING;
        int best = -1, column = from;
        for (int r = done; r < s->equations; ++r) {
            const double *row = row_of(s, r);
            for (int c = from; c < to; ++c) {
                if (fabs(row[c]) > largest) {
                    largest = fabs(row[c]);
                    best = r;
                    column = c;
                }
            }
        }
        if (best < 0) {
            break;
        }
        double *chosen = row_of(s, done), *given = row_of(s, best);
        const double scale = 1.0 / given[column];
        for (int c = 0; c < used; ++c) {
            const double kept = chosen[c];
            chosen[c] = given[c] * scale;
            given[c] = best == done ? chosen[c] : kept;
        }
        chosen[column] = 1.0;
        for (int r = 0; r < s->equations; ++r) {
            double *other = row_of(s, r);
            const double part = other[column];
            if (r != done && part != 0.0) {
                for (int c = 0; c < used; ++c) {
                    other[c] -= part * chosen[c];
                }
                other[column] = 0.0;
            }
        }
        s->pivot[done++] = column;
    }
    return done - first;
}

/* Cost along z with what is best behind it: M, m. */
static void gather(Stage *s, const Stage *after)
{
    const int n = s->n;
    double *pulled = s->rule;               /* not needed yet: a row of P T */
    memcpy(s->full, s->hessian, (size_t)n * (size_t)n * sizeof *s->full);
    memcpy(s->linear, s->gradient, (size_t)n * sizeof *s->linear);
    for (int i = 0; after != NULL && i < s->next; ++i) {
        double total = after->slope[i];
        memset(pulled, 0, (size_t)n * sizeof *pulled);
        for (int j = 0; j < s->next; ++j) {
            const double part = after->left[(ptrdiff_t)i * after->n + j];
            const double *line = s->rows + (ptrdiff_t)j * n;
            total += part * s->offset[j];
            for (int c = 0; c < n; ++c) {
                pulled[c] += part * line[c];
            }
        }
        for (int r = 0; r < n; ++r) {
            const double part = s->rows[(ptrdiff_t)i * n + r];
            if (part != 0.0) {
                double *line = s->full + (ptrdiff_t)r * n;
                for (int c = 0; c < n; ++c) {
                    line[c] += part * pulled[c];
                }
                s->linear[r] += part * total;
            }
        }
    }
    memcpy(s->left, s->full, (size_t)n * (size_t)n * sizeof *s->left);
    memcpy(s->slope, s->linear, (size_t)n * sizeof *s->slope);
}

/* z_p is no longer free: its row and column of the cost that is left go. */
static void close_column(Stage *s, int p)
{
    for (int c = 0; c < s->n; ++c) {
        s->left[(ptrdiff_t)p * s->n + c] = 0.0;
        s->left[(ptrdiff_t)c * s->n + p] = 0.0;
    }
    s->slope[p] = 0.0;
    s->sequence[s->eliminated++] = p;
}

/* Put an equation z_p = v - sum r_c z_c into the cost: M -= r b' + b r', b = M_p - r M_pp / 2. */
static void substitute(Stage *s, int equation)
{
    const int n = s->n, p = s->pivot[equation];
    const double *row = row_of(s, equation);
    double *rule = s->rule + (ptrdiff_t)p * (n + 1), *own = s->left + (ptrdiff_t)p * n;
    const double corner = own[p], value = row[n], slope = s->slope[p];
    for (int c = 0; c < n; ++c) {
        rule[c] = c == p ? 0.0 : -row[c];
        own[c] = c == p ? 0.0 : own[c] + 0.5 * corner * rule[c];
    }
    rule[n] = value;
    for (int c = 0; c < n; ++c) {
        const double part = rule[c], across = own[c];
        if (part != 0.0 || across != 0.0) {
            double *line = s->left + (ptrdiff_t)c * n;
            if (c != p) {
                for (int d = 0; d < n; ++d) {
                    line[d] += part * own[d] + across * rule[d];
                }
                s->slope[c] += part * slope + value * (across + 0.5 * corner * part);
            }
        }
    }
    close_column(s, p);
}

/* The best z_p, whatever the others are: z_p = -(M_p . z + m_p) / M_pp. */
static int minimise(Stage *s, int p, double largest)
{
    const int n = s->n;
    double *rule = s->rule + (ptrdiff_t)p * (n + 1);
    const double *own = s->left + (ptrdiff_t)p * n;
    if (!(own[p] > FLAT * largest)) {
        return NOT_CONVEX;
    }
    const double scale = -1.0 / own[p];
    for (int c = 0; c < n; ++c) {
        rule[c] = c == p ? 0.0 : scale * own[c];
    }
    rule[n] = scale * s->slope[p];
    for (int c = 0; c < n; ++c) {
        const double part = rule[c];
        if (part != 0.0) {
            double *line = s->left + (ptrdiff_t)c * n;
            for (int d = 0; d < n; ++d) {
                line[d] += part * own[d];
            }
            s->slope[c] += part * s->slope[p];
        }
    }
    close_column(s, p);
    return SOLVED;
}

static int minimise_rest(Stage *s, int from, int to)
{
    double largest = 0.0;
    for (int p = from; p < to; ++p) {
        largest = fmax(largest, fabs(s->full[(ptrdiff_t)p * s->n + p]));
    }
    for (int p = from; p < to; ++p) {
        int taken = 0;
        for (int k = 0; k < s->eliminated; ++k) {
            taken = taken || s->sequence[k] == p;
        }
        if (!taken && minimise(s, p, largest) != SOLVED) {
            return NOT_CONVEX;
        }
    }
    return SOLVED;
}

/* Everything of a stage but its states; of the first stage these too. */
static int eliminate(Stage *s, const Stage *after, int first)
{
    collect(s, after);
    s->by_controls = solve_for(s, 0, s->nx, s->n);
    s->by_states = solve_for(s, s->by_controls, 0, s->nx);
    if (first) {
        s->by_controls += s->by_states;
        s->by_states = 0;
    }
    for (int r = s->by_controls + s->by_states; r < s->equations; ++r) {
        if (fabs(row_of(s, r)[s->n]) > NOTHING) {
            return CONTRADICTION;
        }
    }
    gather(s, after);
    s->eliminated = 0;
    for (int r = 0; r < s->by_controls; ++r) {
        substitute(s, r);
    }
    return minimise_rest(s, first ? 0 : s->nx, s->n);
}

/* Solution and multipliers of a stage whose states and pulls are known; the states and pulls of the next one. */
static void follow(Stage *s, Stage *after)
{
    const int n = s->n;
    double *pulls = s->slope;               /* of the equations as they were solved; no longer needed as slopes */
    for (int k = s->eliminated; k-- > 0;) {
        const int p = s->sequence[k];
        const double *rule = s->rule + (ptrdiff_t)p * (n + 1);
        double total = rule[n];
        for (int c = 0; c < n; ++c) {
            total += c == p ? 0.0 : rule[c] * s->z[c];
        }
        s->z[p] = total;
    }
    for (int r = 0; r < s->by_controls; ++r) {
        const double *line = s->full + (ptrdiff_t)s->pivot[r] * n;
        double total = s->linear[s->pivot[r]];
        for (int c = 0; c < n; ++c) {
            total += line[c] * s->z[c];
        }
        pulls[r] = -total;
    }
    for (int r = 0; r < s->by_states; ++r) {
        pulls[s->by_controls + r] = s->pull[r];
    }
    memset(s->multiplier, 0, (size_t)(n + s->paths) * sizeof *s->multiplier);
    for (int given = 0; given < s->equations; ++given) {
        double total = 0.0;
        for (int r = 0; r < s->by_controls + s->by_states; ++r) {
            total += row_of(s, r)[n + 1 + given] * pulls[r];
        }
        if (s->who[given] >= 0) {
            s->multiplier[s->who[given]] = total;
        } else {
            after->pull[-1 - s->who[given]] = total;
        }
    }
    for (int i = 0; after != NULL && i < s->next; ++i) {
        double total = s->offset[i];
        for (int c = 0; c < n; ++c) {
            total += s->rows[(ptrdiff_t)i * n + c] * s->z[c];
        }
        after->z[i] = total;
    }
    for (int i = 0; after != NULL && i < s->next; ++i) {
        double total = after->slope[i];
        for (int j = 0; j < s->next; ++j) {
            total += after->left[(ptrdiff_t)i * after->n + j] * after->z[j];
        }
        for (int r = 0; r < after->by_states; ++r) {
            total += row_of(after, after->by_controls + r)[i] * after->pull[r];
        }
        s->costate[i] = total;
    }
}

/* Guess again which bounds hold; how many guesses change. */
static int guess(Stage *s)
{
    int changed = 0;
    for (int k = 0; k < s->n + s->paths; ++k) {
        double value = 0.0;
        int *state = s->state + k;
        const int before = *state;
        if (k < s->n) {
            value = s->z[k];
        } else if (before == FREE) {
            const double *row = s->rows + (ptrdiff_t)(s->next + k - s->n) * s->n;
            for (int c = 0; c < s->n; ++c) {
                value += row[c] * s->z[c];
            }
        }
        if (before == FREE) {
            *state = value < s->low[k] - MISSED ? LOW : value > s->high[k] + MISSED ? HIGH : FREE;
        } else if (before != EQUATION && before * s->multiplier[k] < -MISSED) {
            *state = FREE;
        }
        changed += *state != before;
    }
    return changed;
}

/* The stages on the arrays of the caller. */
static void place(
    Stage *stages, int count, const int *sizes, const double *data, const double *low, const double *high,
    int *state, double *z, double *multiplier, double *costate, double *work, int *places)
{
    for (int k = 0; k < count; ++k) {
        Stage *s = stages + k;
        s->nx = sizes[3 * k];
        s->nw = sizes[3 * k + 1];
        s->paths = sizes[3 * k + 2];
        s->next = k + 1 < count ? sizes[3 * k + 3] : 0;
        s->n = s->nx + s->nw;
        const int n = s->n, most = n + s->paths + s->next;
        const ptrdiff_t square = (ptrdiff_t)n * n;
        s->length = n + 1 + most;
        s->hessian = data;
        s->gradient = data += square;
        s->rows = data += n;
        s->offset = data += (ptrdiff_t)(s->next + s->paths) * n;
        data += s->next;
        s->low = low;
        s->high = high;
        s->state = state;
        s->multiplier = multiplier;
        low += n + s->paths;
        high += n + s->paths;
        state += n + s->paths;
        multiplier += n + s->paths;
        s->z = z;
        s->costate = costate;
        z += n;
        costate += s->next;
        s->full = work;
        s->left = work += square;
        s->linear = work += square;
        s->slope = work += n;
        s->pull = work += most;
        s->rule = work += s->nx;
        s->table = work += square + n;
        work += (ptrdiff_t)most * s->length;
        s->who = places;
        s->pivot = places += most;
        s->sequence = places += most;
        places += n;
    }
}

/* Bytes of a stage's description, for who keeps them. */
int stage_size(void)
{
    return (int)sizeof(Stage);
}

/* The step: `state` [-1 low, 0 free, 1 high, 2 equation] of the bounds guessed in and found out, `z`, multipliers of
   (z, paths) above 0 at upper bounds, `costate` of the steps from stage to stage. `sizes`: nx, nw, paths of every stage;
   `data` of every stage: H, g, rows (next + paths) x n, t. `tries`: in, the most guesses; out, those made. Statuses:
   0 solved, 1 the cost is not convex where the equations hold, 2 these contradict each other, 3 no guess settled. */
int stage_step(
    int count, const int *sizes, const double *data, const double *low, const double *high, int *state, double *z,
    double *multiplier, double *costate, double *work, int *places, void *descriptions, int *tries)
{
    Stage *stages = descriptions;
    const int most = *tries;
    place(stages, count, sizes, data, low, high, state, z, multiplier, costate, work, places);
    for (*tries = 1; *tries <= most; ++*tries) {
        int changed = 0;
        for (int k = count; k-- > 0;) {
            const int said = eliminate(stages + k, k + 1 < count ? stages + k + 1 : NULL, k == 0);
            if (said != SOLVED) {
                return said;
            }
        }
        for (int k = 0; k < count; ++k) {
            follow(stages + k, k + 1 < count ? stages + k + 1 : NULL);
        }
        for (int k = 0; k < count; ++k) {
            changed += guess(stages + k);
        }
        if (changed == 0) {
            return SOLVED;
        }
    }
    return UNSETTLED;
}
