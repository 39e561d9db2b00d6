/* ---- Proof that two configurations are on one mode, with the closure of the tables above. ----

   Between `from` and `to` the independent coordinates go straight, y(s). For a box about both ends and an approximate
   inverse P of the slopes there

       T(x, s) = x - P F(x, y(s))     maps the box into itself and contracts it, for every s

   (L. V. Kantorovich; R. Krawczyk, Computing 4, 1969, 187-201): then the closure F = 0 has one solution in the box for
   every s, which moves continuously with s. Both ends are within CERTIFICATE_NEAR of it, and the box reaches so far
   beyond them, so that what is proved of one call goes on in the next. Lengths are divided by the characteristic one.

   Numbers are balls, middle and radius. CERTIFICATE_ROUNDING is twice what an operation of IEEE 754 loses in its middle;
   CERTIFICATE_LIBRARY is what sine, cosine, exponential and arc tangent of the C library may be off, relative to
   numbers of size 1: some units in the last place. Radii are sums, products and quotients of positive numbers, of which
   less than a millionth is lost in a million operations: CERTIFICATE_SLACK. */

typedef struct { /* room for a proof, of the caller: stacks of controllers are small */
    Ball box[CERTIFICATE_Q], open[CERTIFICATE_N], drift[CERTIFICATE_N];
    Ball slope[CERTIFICATE_N * CERTIFICATE_Q], found[CERTIFICATE_SLOPES];
    double square[CERTIFICATE_N * CERTIFICATE_N], inverse[CERTIFICATE_N * CERTIFICATE_N];
    double middle[CERTIFICATE_Q], step[CERTIFICATE_Q]; /* of the box, and half of the way of every coordinate */
    double half[CERTIFICATE_N], reach[CERTIFICATE_N]; /* radii of the box, and what they must be at least; no units */
    double wanted[CERTIFICATE_N], most[CERTIFICATE_N];
    double least; /* by how much T contracts */
} CertificateWork;

/* P of the slopes a (by columns) in place by elimination; 1 where a pivot is lost. */
static int certificate_inverse(double *a, double *inverse)
{
    enum { n = CERTIFICATE_N };
    for (int k = 0; k < n * n; ++k) {
        inverse[k] = k % n == k / n ? 1.0 : 0.0;
    }
    for (int j = 0; j < n; ++j) {
        int best = j;
        for (int i = j + 1; i < n; ++i) {
            best = fabs(a[i + j * n]) > fabs(a[best + j * n]) ? i : best;
        }
        if (!(fabs(a[best + j * n]) > 0.0)) {
            return 1;
        }
        for (int k = 0; k < n; ++k) {
            const double moved = a[j + k * n], kept = inverse[j + k * n];
            a[j + k * n] = a[best + k * n];
            a[best + k * n] = moved;
            inverse[j + k * n] = inverse[best + k * n];
            inverse[best + k * n] = kept;
        }
        const double pivot = 1.0 / a[j + j * n];
        for (int k = 0; k < n; ++k) {
            a[j + k * n] *= pivot;
            inverse[j + k * n] *= pivot;
        }
        for (int i = 0; i < n; ++i) {
            const double factor = a[i + j * n];
            if (i == j || factor == 0.0) {
                continue;
            }
            for (int k = 0; k < n; ++k) {
                a[i + k * n] -= factor * a[j + k * n];
                inverse[i + k * n] -= factor * inverse[j + k * n];
            }
        }
    }
    return 0;
}

/* What P times a vector of balls can be at most, entry by entry. */
static void certificate_sizes(const double *inverse, const Ball *vector, double *most)
{
    enum { n = CERTIFICATE_N };
    for (int i = 0; i < n; ++i) {
        double middle = 0.0, radius = 0.0;
        for (int j = 0; j < n; ++j) {
            const double p = inverse[i + j * n];
            middle += p * vector[j].m;
            radius += fabs(p) * (vector[j].r + (n + 1) * CERTIFICATE_ROUNDING * fabs(vector[j].m));
        }
        most[i] = fabs(middle) + radius;
    }
}

/* The closure at a configuration: its loops, and the lengths of its quaternions. */
static void certificate_closure(const Ball *q, Ball *made)
{
    certificate_openings(q, made);
    for (int k = 0; k < CERTIFICATE_TURNS; ++k) {
        const Ball *a = q + certificate_turn[k];
        double sum = -1.0, size = 1.0, radius = 0.0;
        for (int i = 0; i < 4; ++i) {
            sum += a[i].m * a[i].m;
            size += a[i].m * a[i].m;
            radius += a[i].r * (2.0 * fabs(a[i].m) + a[i].r);
        }
        made[CERTIFICATE_N - CERTIFICATE_TURNS + k] =
            (Ball){0.5 * sum, 0.5 * radius + 8.0 * CERTIFICATE_ROUNDING * size};
    }
}

/* Its slopes by every coordinate (CERTIFICATE_N x CERTIFICATE_Q by columns). */
static void certificate_every_slope(const Ball *q, Ball *found, Ball *made)
{
    for (int k = 0; k < CERTIFICATE_N * CERTIFICATE_Q; ++k) {
        made[k] = (Ball){0.0, 0.0};
    }
    certificate_slopes(q, found);
    for (int k = 0; k < CERTIFICATE_SLOPES; ++k) {
        made[certificate_row[k] + CERTIFICATE_N * certificate_column[k]] = found[k];
    }
    for (int k = 0; k < CERTIFICATE_TURNS; ++k) {
        for (int i = certificate_turn[k]; i < certificate_turn[k] + 4; ++i) {
            made[CERTIFICATE_N - CERTIFICATE_TURNS + k + CERTIFICATE_N * i] = q[i];
        }
    }
}

/* Whether T maps the box into itself; `inverse` is P then, `least` by how much T contracts, `wanted` what `half` would
   have to be. */
static int certificate_box(CertificateWork *work)
{
    enum { n = CERTIFICATE_N };
    Ball *const box = work->box, *const slope = work->slope, *const drift = work->drift;
    const double *const middle = work->middle, *const step = work->step, *const half = work->half;
    const double *const inverse = work->inverse;
    for (int k = 0; k < CERTIFICATE_Q; ++k) {
        box[k] = (Ball){middle[k], 0.0};
    }
    certificate_closure(box, work->open);
    for (int k = 0; k < CERTIFICATE_FREE; ++k) {
        const int at = certificate_free[k];
        box[at].r = fabs(step[at]) + 2.0 * CERTIFICATE_ROUNDING * fabs(middle[at]);
    }
    for (int k = 0; k < n; ++k) {
        box[certificate_dependent[k]].r = half[k] * certificate_unit[k];
    }
    certificate_every_slope(box, work->found, slope);
    for (int i = 0; i < n; ++i) { /* what F does on the way of the independent coordinates, and the rounding of y(s) */
        drift[i] = (Ball){0.0, 0.0};
        for (int k = 0; k < CERTIFICATE_FREE; ++k) {
            const int at = certificate_free[k];
            const Ball s = slope[i + n * at];
            drift[i].m += s.m * step[at];
            drift[i].r += s.r * fabs(step[at]) + (fabs(s.m) + s.r) * CERTIFICATE_ROUNDING *
                                                     (2.0 * fabs(middle[at]) + (CERTIFICATE_FREE + 3) * fabs(step[at]));
        }
        for (int k = 0; k < n; ++k) {
            work->square[i + n * k] = slope[i + n * certificate_dependent[k]].m * certificate_unit[k];
        }
    }
    if (certificate_inverse(work->square, work->inverse) != 0) {
        return 0;
    }
    int inside = 1;
    double contraction = 0.0;
    certificate_sizes(inverse, work->open, work->wanted);
    certificate_sizes(inverse, drift, work->most);
    for (int i = 0; i < n; ++i) {
        double off = 0.0;
        for (int k = 0; k < n; ++k) {
            double middle_of = i == k ? -1.0 : 0.0, size = 1.0, radius = 0.0;
            for (int j = 0; j < n; ++j) {
                const double p = inverse[i + j * n], unit = certificate_unit[k];
                const Ball s = slope[j + n * certificate_dependent[k]];
                middle_of += p * s.m * unit;
                size += fabs(p * s.m) * unit;
                radius += fabs(p) * s.r * unit;
            }
            off += (fabs(middle_of) + radius + (n + 4) * CERTIFICATE_ROUNDING * size) * half[k];
        }
        work->wanted[i] += work->most[i] + off;
        inside = work->wanted[i] * CERTIFICATE_SLACK < half[i] ? inside : 0;
        contraction = off > contraction * half[i] ? off / half[i] : contraction;
    }
    work->least = 1.0 - contraction * CERTIFICATE_SLACK;
    return inside;
}

/* Whether a configuration is within CERTIFICATE_NEAR of the solution in a box that was proved. */
static int certificate_near(CertificateWork *work, const double *q)
{
    const double *const half = work->half;
    double largest = 0.0;
    for (int k = 0; k < CERTIFICATE_Q; ++k) {
        work->box[k] = (Ball){q[k], 0.0};
    }
    certificate_closure(work->box, work->open);
    certificate_sizes(work->inverse, work->open, work->most);
    for (int k = 0; k < CERTIFICATE_N; ++k) { /* in the norm of the box, in which T contracts */
        const double off = work->most[k] / half[k];
        largest = off > largest || !(off >= 0.0) ? off : largest;
    }
    for (int k = 0; k < CERTIFICATE_N; ++k) {
        if (!(largest * half[k] * CERTIFICATE_SLACK <= CERTIFICATE_NEAR * work->least)) {
            return 0;
        }
    }
    return 1;
}

/* 1 where it is proved that `to` continues the mode of `from`: from one to the other the loops close in one way alone
   near them. 0: nothing is known; a shorter step may be proved. */
static int mode_certified(CertificateWork *work, const double *from, const double *to)
{
    double longest = 0.0;
    for (int k = 0; k < CERTIFICATE_Q; ++k) {
        work->middle[k] = 0.5 * (from[k] + to[k]);
        work->step[k] = 0.5 * (to[k] - from[k]);
    }
    for (int k = 0; k < CERTIFICATE_N; ++k) {
        const int at = certificate_dependent[k];
        const double rounding = 4.0 * CERTIFICATE_ROUNDING * fabs(work->middle[at]);
        const double way = (fabs(work->step[at]) + rounding) / certificate_unit[k];
        longest = way > longest ? way : longest;
        work->reach[k] = way + 1.01 * CERTIFICATE_NEAR;
        work->half[k] = 1.25 * work->reach[k];
    }
    for (int k = 0; k < CERTIFICATE_N; ++k) { /* of coordinates that hardly move, too: the others bend into them */
        work->half[k] += 0.1 * longest;
    }
    for (int trial = 0; trial < 3; ++trial) {
        if (certificate_box(work)) {
            return certificate_near(work, from) && certificate_near(work, to);
        }
        for (int k = 0; k < CERTIFICATE_N; ++k) {
            const double next = 1.2 * work->wanted[k];
            work->half[k] = next > work->reach[k] ? next : work->reach[k];
            if (!(next < 1.0)) { /* wider than the mechanism, or not a number */
                return 0;
            }
        }
    }
    return 0;
}
