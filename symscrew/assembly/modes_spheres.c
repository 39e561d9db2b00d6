/* ---- Modes with the platform as it is turned in the reference: each arm carries two points whose rods are parallel and
   alike, so that both say the same, and three spheres meet in two points. ---- */

typedef struct {
    double u[3][3], square[3], off[3]; /* from the spheres' centres to O, radii squared, bounds on errors of the first */
} Spheres;

static double inner(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void crossed(const double *a, const double *b, double *out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static void spheres_of(const double *drives, Spheres *at)
{
    for (int k = 0; k < 3; ++k) {
        const int drive = level_drive[k];
        const double value = (drives[drive] - drive_reference[drive]) * (level_sign[k] / drive_unit[drive]);
        const double c = level_turns[k] ? cos(value) : value, s = level_turns[k] ? sin(value) : 0.0;
        double sum = 0.0, steep = 0.0;
        at->square[k] = level_square[k];
        for (int i = 0; i < 3; ++i) {
            at->u[k][i] = level_start[k][i] - c * level_cos[k][i] - s * level_sin[k][i];
            sum += fabs(level_start[k][i]) + fabs(c * level_cos[k][i]) + fabs(s * level_sin[k][i]);
            steep += fabs(level_cos[k][i]) + fabs(level_sin[k][i]);
        }
        /* tables, products and sums, the library's cosine and sine, and the value that they are given */
        at->off[k] = 8.0 * UNIT * (sum + steep * (2.0 + fabs(drive_reference[drive] / drive_unit[drive]) + fabs(value)));
    }
}

/* Whether one point of all three spheres lies near x: Newton's operator Y with F(x), 1 - Y dF(x) and the derivative's
   rate, which is the same everywhere; `error` bounds how far. */
static int on_spheres(const Spheres *at, const double *x, double *error)
{
    double rows[3][3], y[3][3], step = 0.0, defect = 0.0, rate = 0.0, largest = 0.0, total = 0.0;
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
            rows[k][i] = x[i] + at->u[k][i];
            largest += fabs(x[i]) + fabs(at->u[k][i]);
        }
    }
    for (int k = 0; k < 3; ++k) { /* columns of the inverse, before the determinant */
        crossed(rows[(k + 1) % 3], rows[(k + 2) % 3], y[k]);
    }
    const double determinant = inner(rows[0], y[0]);
    if (!(fabs(determinant) > 0.0)) {
        return 0;
    }
    for (int i = 0; i < 3; ++i) {
        double moved_by = 0.0, all = 0.0;
        for (int k = 0; k < 3; ++k) {
            y[k][i] /= determinant;
            const double left = 0.5 * (inner(rows[k], rows[k]) - at->square[k]);
            const double off = (at->off[k] + 16.0 * UNIT * largest) * (largest + at->off[k]);
            moved_by += y[k][i] * left;
            step += fabs(y[k][i]) * off;
            all += y[k][i];
            total += fabs(y[k][i]);
        }
        step += fabs(moved_by);
        rate += fabs(all);
        for (int j = 0; j < 3; ++j) {
            double entry = i == j ? 1.0 : 0.0;
            for (int k = 0; k < 3; ++k) {
                entry -= y[k][i] * rows[k][j];
            }
            defect += fabs(entry);
        }
    }
    defect += total * (16.0 * UNIT * largest + at->off[0] + at->off[1] + at->off[2]);
    rate += 16.0 * UNIT * total;
    const double radius = 2.5 * step * SLACK + TINY; /* sums of parts stand for norms, and bound them */
    *error = radius;
    return (step + defect * radius + 0.5 * rate * radius * radius) * SLACK < radius &&
        (defect + rate * radius) * SLACK < 1.0;
}

/* Whether the spheres have no point in common, for all errors of their centres: with y = x + u_0, one . y = p and
   two . y = q, the least |y| of these is |p two - q one| / |n|, further than the first sphere is wide. Centres near a
   line leave little of either, and little is proved there. */
static int apart(const Spheres *at, const double *one, const double *two, const double *n)
{
    double a = 0.0, b = 0.0, sizes = 0.0, w[3];
    for (int i = 0; i < 3; ++i) {
        a += fabs(one[i]);
        b += fabs(two[i]);
        sizes += fabs(at->u[0][i]) + fabs(at->u[1][i]) + fabs(at->u[2][i]);
    }
    const double p = 0.5 * (at->square[1] - at->square[0] - inner(one, one));
    const double q = 0.5 * (at->square[2] - at->square[0] - inner(two, two));
    for (int i = 0; i < 3; ++i) {
        w[i] = p * two[i] - q * one[i];
    }
    /* bounds on errors, of sums of parts for norms: `off` of entries of one and two, then of p, q, w and n */
    const double off = at->off[0] + at->off[1] + at->off[2] + 4.0 * UNIT * sizes;
    const double off_p = 8.0 * UNIT * (at->square[1] + at->square[0] + a * a) + (a + 3.0 * off) * off;
    const double off_q = 8.0 * UNIT * (at->square[2] + at->square[0] + b * b) + (b + 3.0 * off) * off;
    const double off_w = 3.0 * off * (fabs(p) + fabs(q)) + off_p * (b + 3.0 * off) + off_q * (a + 3.0 * off) +
        4.0 * UNIT * (fabs(p) * b + fabs(q) * a);
    const double off_n = 2.0 * off * (a + b + 3.0 * off) + 4.0 * UNIT * a * b;
    const double wide = sqrt(at->square[0]) * (sqrt(inner(n, n)) * SLACK + off_n) * SLACK * SLACK;
    return sqrt(inner(w, w)) > (wide + off_w * SLACK) * SLACK;
}

int LEVEL(const double *drives, MODE *modes, int *count)
{
    Spheres at;
    double one[3], two[3], n[3], foot[3], a[3], b[3], sum = 0.0;
    int lost = 0;
    *count = 0;
    for (int k = 0; k < N_DRIVES; ++k) {
        sum += 0.0 * drives[k];
    }
    if (!isfinite(sum)) {
        return 2;
    }
    spheres_of(drives, &at);
    double right[2];
    for (int i = 0; i < 3; ++i) {
        one[i] = at.u[1][i] - at.u[0][i];
        two[i] = at.u[2][i] - at.u[0][i];
    }
    const double own = inner(at.u[0], at.u[0]) - at.square[0];
    right[0] = 0.5 * (own - inner(at.u[1], at.u[1]) + at.square[1]);
    right[1] = 0.5 * (own - inner(at.u[2], at.u[2]) + at.square[2]);
    crossed(one, two, n); /* along the line in which the planes between the spheres meet */
    crossed(two, n, a);
    crossed(n, one, b);
    const double size = inner(n, n);
    if (!(size > 1e-20 * inner(one, one) * inner(two, two))) {
        return MODES_INCOMPLETE; /* centres on a line, or nearly so */
    }
    for (int i = 0; i < 3; ++i) {
        foot[i] = (right[0] * a[i] + right[1] * b[i]) / size;
        a[i] = foot[i] + at.u[0][i];
    }
    const double middle = inner(a, n) / size, rest = middle * middle - (inner(a, a) - at.square[0]) / size;
    if (rest < 0.0 && apart(&at, one, two, n)) {
        return 0;
    }
    double between = 2.0 * sqrt(rest > 0.0 ? rest * size : 0.0);
    for (int k = 0; k < 2; ++k) {
        MODE *mode = &modes[*count];
        const double along = (k ? 1.0 : -1.0) * sqrt(rest > 0.0 ? rest : 0.0) - middle;
        double x[3], error;
        for (int i = 0; i < 3; ++i) {
            x[i] = foot[i] + along * n[i];
        }
        if (!on_spheres(&at, x, &error)) {
            ++lost;
            continue;
        }
        for (int i = 0; i < N_DRIVES; ++i) {
            mode->drives[i] = drives[i];
        }
        for (int i = 0; i < WIDTH; ++i) {
            mode->z[i] = i == 0 ? 1.0 : 0.0;
        }
        for (int i = 0; i < 9; ++i) {
            mode->pose[i] = i % 4 ? 0.0 : 1.0;
        }
        for (int i = 0; i < 3; ++i) {
            mode->z[5 + i] = 0.5 * x[i];
            mode->pose[9 + i] = SIZE * (frame[0][i] * x[0] + frame[1][i] * x[1] + frame[2][i] * x[2]);
        }
        mode->error = error;
        mode->certified = 1;
        between -= 2.0 * error;
        ++*count;
    }
    if (*count == 2 && !(between > 0.0)) { /* both may be the same */
        *count = 0;
        return MODES_INCOMPLETE;
    }
    return lost ? MODES_INCOMPLETE : 0;
}
