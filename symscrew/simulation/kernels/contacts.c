/* Contacts: joints that stick or slip, and rigid stops (contacts.py). Within a mode the force of a contact is given by
 * its law, or it is what keeps the contact's rate at zero. Accelerations are affine in the forces. */
#if CONTACTS
enum { FRICTION, STOP };
typedef struct {
    int kind, v, q;
    double coulomb, fixed, stribeck, lower, upper; /* `fixed`: the static level */
} Contact;
#if !defined(CONTACT_STORAGE)
#define CONTACT_STORAGE static const
#endif
CONTACT_STORAGE Contact CONTACT[CONTACTS] = CONTACT_TABLE;
static int contact_mode[CONTACTS]; /* friction: sign of the slip, 0 stuck; stops: -1 lower, 0 free, +1 upper */

static int held(int k)
{
    return CONTACT[k].kind == FRICTION ? contact_mode[k] == 0 : contact_mode[k] != 0;
}

static double slip_level(const Contact *c, double rate)
{
    if (!(c->fixed > c->coulomb) || !(c->stribeck < 1e300)) {
        return c->coulomb;
    }
    return c->coulomb + (c->fixed - c->coulomb) / (1.0 + (rate / c->stribeck) * (rate / c->stribeck));
}

/* Eigenvalues of a symmetric matrix by Jacobi's rotations: `m` becomes diagonal, `e` has the vectors as columns. */
static void eigenvectors(int n, double (*m)[CONTACTS], double (*e)[CONTACTS])
{
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            e[i][j] = i == j ? 1.0 : 0.0;
        }
    }
    for (int sweep = 0; sweep < 30; ++sweep) {
        double off = 0.0;
        for (int i = 0; i < n; ++i) {
            for (int j = i + 1; j < n; ++j) {
                off += fabs(m[i][j]);
                if (m[i][j] == 0.0) {
                    continue;
                }
                const double ratio = 0.5 * (m[j][j] - m[i][i]) / m[i][j];
                const double t = (ratio < 0.0 ? -1.0 : 1.0) / (fabs(ratio) + sqrt(1.0 + ratio * ratio));
                const double c = 1.0 / sqrt(1.0 + t * t), s = t * c;
                for (int k = 0; k < n; ++k) {
                    const double a = m[k][i], b = m[k][j];
                    m[k][i] = c * a - s * b;
                    m[k][j] = s * a + c * b;
                }
                for (int k = 0; k < n; ++k) {
                    const double a = m[i][k], b = m[j][k], p = e[k][i], q = e[k][j];
                    m[i][k] = c * a - s * b;
                    m[j][k] = s * a + c * b;
                    e[k][i] = c * p - s * q;
                    e[k][j] = s * p + c * q;
                }
            }
        }
        if (off == 0.0) {
            return;
        }
    }
}

/* What forces of the held contacts do: `column[j]`, accelerations by a unit force of contact unknown[j]; `gain` the same
 * at the held contacts alone, without units. */
typedef struct {
    int count, unknown[CONTACTS];
    double column[CONTACTS][NV1], size[CONTACTS];
    double value[CONTACTS], vector[CONTACTS][CONTACTS];
} Grip;

/* The answer of all rates to a unit force of contact k beside what makes the accelerations a. Where these are far larger,
 * a unit's part would be rounding: a larger force is divided by its size (contacts.py). */
static int answer(double t, const double *q, const double *v, const double *x, const double *u, const double *a, int k,
                  double *column)
{
    double x_dot[NX1], size = 1.0;
    for (int pass = 0; pass < 2; ++pass) {
        const double given = CONTACT_FORCE[k];
        CONTACT_FORCE[k] = given + size;
        const int outcome = plain_forces_at(t, q, v, x, u, column, x_dot);
        CONTACT_FORCE[k] = given;
        if (outcome > 0 && outcome != LEAST_SQUARES) {
            return outcome;
        }
        double most = 0.0, own = 0.0;
        for (int i = 0; i < NV; ++i) {
            column[i] = (column[i] - a[i]) / size;
            most = fmax(most, fabs(a[i]) / UNIT[i]);
            own = fmax(own, fabs(column[i]) / UNIT[i]);
        }
        if (!(own > 0.0 && most > SMALL_ANSWER * own * size)) {
            break;
        }
        size = most / own;
    }
    return 0;
}

static int gripped(double t, const double *q, const double *v, const double *x, const double *u, const double *a,
                   Grip *g)
{
    double gain[CONTACTS][CONTACTS];
    g->count = 0;
    for (int k = 0; k < CONTACTS; ++k) {
        if (!held(k)) {
            continue;
        }
        double *column = g->column[g->count];
        const int outcome = answer(t, q, v, x, u, a, k, column);
        if (outcome != 0) {
            return outcome;
        }
        g->unknown[g->count++] = k;
    }
    for (int i = 0; i < g->count; ++i) {
        const double own = g->column[i][CONTACT[g->unknown[i]].v];
        g->size[i] = own > 0.0 ? 1.0 / sqrt(own) : 0.0; /* a force that does not move its joint holds nothing */
    }
    for (int i = 0; i < g->count; ++i) {
        for (int j = 0; j < g->count; ++j) {
            const double one = g->column[j][CONTACT[g->unknown[i]].v], other = g->column[i][CONTACT[g->unknown[j]].v];
            gain[i][j] = 0.5 * (one + other) * g->size[i] * g->size[j];
        }
    }
    eigenvectors(g->count, gain, g->vector);
    for (int i = 0; i < g->count; ++i) {
        g->value[i] = gain[i][i];
    }
    return 0;
}

/* Smallest forces that give the held contacts the accelerations `wanted`. */
static void grip(const Grip *g, const double *wanted, double *force)
{
    double along[CONTACTS];
    for (int r = 0; r < g->count; ++r) {
        along[r] = 0.0;
        for (int i = 0; i < g->count; ++i) {
            along[r] += g->vector[i][r] * g->size[i] * wanted[i];
        }
        along[r] = g->value[r] > SHARED ? along[r] / g->value[r] : 0.0;
    }
    for (int i = 0; i < g->count; ++i) {
        force[i] = 0.0;
        for (int r = 0; r < g->count; ++r) {
            force[i] += g->size[i] * g->vector[i][r] * along[r];
        }
    }
}

/* Whether joint k cannot move as long as the others are held: what is left, beside them, of its answer to its own force
 * is rounding (contacts.py). A joint that does not answer its own force is not held. */
static int held_with(int k, double t, const double *q, const double *v, const double *x)
{
    Grip g;
    double a[NV1], x_dot[NX1], own[NV1], wanted[CONTACTS], force[CONTACTS], most = 0.0, least = 0.0;
    const int row = CONTACT[k].v;
    memset(CONTACT_FORCE, 0, sizeof CONTACT_FORCE);
    if (valid(plain_forces_at(t, q, v, x, NULL, a, x_dot)) != 0 || gripped(t, q, v, x, NULL, a, &g) != 0 ||
        g.count == 0 || answer(t, q, v, x, NULL, a, k, own) != 0) {
        return 0;
    }
    for (int i = 0; i < NV; ++i) {
        most = fmax(most, fabs(own[i]) / UNIT[i]);
        least = fmax(least, fabs(a[i]) / UNIT[i]);
    }
    if (own[row] / UNIT[row] < HELD * most || most < 1e-12 * least) {
        return 0;
    }
    for (int i = 0; i < g.count; ++i) {
        wanted[i] = -own[CONTACT[g.unknown[i]].v];
    }
    grip(&g, wanted, force);
    double left = own[row];
    for (int i = 0; i < g.count; ++i) {
        left += g.column[i][row] * force[i];
    }
    return fabs(left) <= HELD_WITH * own[row];
}

static int forces_at(double t, const double *q, const double *v, const double *x, const double *u, double *a,
                     double *x_dot)
{
    Grip g;
    int any = 0;
    for (int k = 0; k < CONTACTS; ++k) {
        const Contact *c = CONTACT + k;
        const int slips = c->kind == FRICTION && contact_mode[k] != 0;
        CONTACT_FORCE[k] = slips ? -contact_mode[k] * slip_level(c, v[c->v]) : 0.0;
        any |= held(k);
    }
    int outcome = plain_forces_at(t, q, v, x, u, a, x_dot);
    if (!any || (outcome > 0 && outcome != LEAST_SQUARES)) {
        return outcome;
    }
    outcome = gripped(t, q, v, x, u, a, &g);
    for (int pass = 0; pass < 2 && outcome == 0; ++pass) { /* once more for what rounding left of large forces */
        double wanted[CONTACTS], force[CONTACTS];
        for (int i = 0; i < g.count; ++i) {
            wanted[i] = -a[CONTACT[g.unknown[i]].v];
        }
        grip(&g, wanted, force);
        for (int i = 0; i < g.count; ++i) {
            CONTACT_FORCE[g.unknown[i]] += force[i];
        }
        outcome = valid(plain_forces_at(t, q, v, x, u, a, x_dot));
    }
    for (int i = 0; i < g.count && outcome == 0; ++i) {
        a[CONTACT[g.unknown[i]].v] = g.size[i] > 0.0 ? 0.0 : a[CONTACT[g.unknown[i]].v];
    }
    return outcome;
}
#endif
