/* DOP853 with projection as somebody would write it who has the generated functions and nothing else of ours.
 *
 * The method is SciPy's: its tableau, printed in front of this file as sums over the stages k (OTHER_STAGES,
 * OTHER_NEXT, OTHER_FIVE, OTHER_THREE, and OTHER_MORE, OTHER_DENSE_0 ... 3 for its dense output), its error norm and its
 * control of steps. State (q, v), quaternions as four numbers; after every step these are
 * made of length one, q is put onto the closure by Gauss and Newton, v into its tangent space, with dense normal
 * equations; outputs too, so that they are on the mechanism, unless OTHER_RAW is 1. Rows of the closure must be
 * independent. */
#define DIM (NQ + NV)

static void other_rates(const double *q, const double *v, double *dq)
{
    for (int i = 0; i < PLAIN_COUNT; ++i) {
        dq[PLAIN[i][0]] = v[PLAIN[i][1]];
    }
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        const double *b = q + SPHERES[i][0], *w = v + SPHERES[i][1];
        double *d = dq + SPHERES[i][0];
        d[0] = 0.5 * (-b[1] * w[0] - b[2] * w[1] - b[3] * w[2]);
        d[1] = 0.5 * (b[0] * w[0] + b[2] * w[2] - b[3] * w[1]);
        d[2] = 0.5 * (b[0] * w[1] + b[3] * w[0] - b[1] * w[2]);
        d[3] = 0.5 * (b[0] * w[2] + b[1] * w[1] - b[2] * w[0]);
    }
}

static void other_normal(double *q)
{
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        double *b = q + SPHERES[i][0];
        const double size = 1.0 / sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2] + b[3] * b[3]);
        for (int k = 0; k < 4; ++k) {
            b[k] *= size;
        }
    }
}

static int other_slope(double t, const double *y, double *dy)
{
    double q[NQ1], none[NX1] = {0.0}, unread[NX1];
    memcpy(q, y, sizeof(double) * NQ);
    other_normal(q);
    other_rates(y, y + NQ, dy);
    return forces_at(t, q, y + NQ, none, NULL, dy + NQ, unread) > 0;
}

#if NR
/* The shortest d with jacobian d = right, whose square root of normal equations is in `lower`. */
static void other_shortest(double (*lower)[NR], double (*jacobian)[NV], const double *right, double *d)
{
    double z[NR];
    for (int i = 0; i < NR; ++i) {
        double sum = right[i];
        for (int k = 0; k < i; ++k) {
            sum -= lower[i][k] * z[k];
        }
        z[i] = sum / lower[i][i];
    }
    for (int i = NR - 1; i >= 0; --i) {
        double sum = z[i];
        for (int k = i + 1; k < NR; ++k) {
            sum -= lower[k][i] * z[k];
        }
        z[i] = sum / lower[i][i];
    }
    for (int k = 0; k < NV; ++k) {
        d[k] = 0.0;
        for (int i = 0; i < NR; ++i) {
            d[k] += jacobian[i][k] * z[i];
        }
    }
}

static int other_project(double *y)
{
    double residual[NR], value[ENTRIES1], jacobian[NR][NV], lower[NR][NR], d[NV1], rate[NQ1], size = 1.0;
    other_normal(y);
    for (int pass = 0; pass < 10 && size > 1e-13; ++pass) {
        if (closure_at(y, residual, value) != 0) {
            return 1;
        }
        memset(jacobian, 0, sizeof jacobian);
        for (int e = 0; e < ENTRIES; ++e) {
            jacobian[ENTRY[e][0]][ENTRY[e][1]] = value[e];
        }
        for (int i = 0; i < NR; ++i) {
            for (int j = 0; j <= i; ++j) {
                double sum = 0.0;
                for (int k = 0; k < NV; ++k) {
                    sum += jacobian[i][k] * jacobian[j][k];
                }
                for (int k = 0; k < j; ++k) {
                    sum -= lower[i][k] * lower[j][k];
                }
                lower[i][j] = i == j ? sqrt(sum) : sum / lower[j][j];
            }
        }
        other_shortest(lower, jacobian, residual, d);
        other_rates(y, d, rate);
        size = 0.0;
        for (int k = 0; k < NQ; ++k) {
            y[k] -= rate[k];
            size = fmax(size, fabs(rate[k]));
        }
        other_normal(y);
    }
    for (int i = 0; i < NR; ++i) {
        residual[i] = 0.0;
        for (int k = 0; k < NV; ++k) {
            residual[i] += jacobian[i][k] * y[NQ + k];
        }
    }
    other_shortest(lower, jacobian, residual, d);
    for (int k = 0; k < NV; ++k) {
        y[NQ + k] -= d[k];
    }
    return 0;
}
#else
static int other_project(double *y)
{
    other_normal(y);
    return 0;
}
#endif

static double other_error(double (*k)[DIM], double h, const double *y, const double *next, double tolerance)
{
    double five = 0.0, three = 0.0;
    for (int i = 0; i < DIM; ++i) {
        const double scale = tolerance * (1.0 + fmax(fabs(y[i]), fabs(next[i])));
        const double e5 = (OTHER_FIVE) / scale, e3 = (OTHER_THREE) / scale;
        five += e5 * e5;
        three += e3 * e3;
    }
    return five == 0.0 && three == 0.0 ? 0.0 : fabs(h) * five / sqrt((five + 0.01 * three) * DIM);
}

#define OTHER_STAGE(s, c, sum)                                                                                         \
    for (int i = 0; i < DIM; ++i) {                                                                                    \
        at[i] = y[i] + h * (sum);                                                                                      \
    }                                                                                                                  \
    if (other_slope(t + (c) * h, at, k[s]) != 0) {                                                                     \
        return 1;                                                                                                      \
    }

static int other_stages(double (*k)[DIM], double t, double h, const double *y)
{
    double at[DIM];
    OTHER_STAGES
    return 0;
}

static int other_more(double (*k)[DIM], double t, double h, const double *y)
{
    double at[DIM];
    OTHER_MORE
    return 0;
}

/* The outputs within the step from y to next. */
static int other_outputs(double (*k)[DIM], double t, double h, const double *y, const double *next,
                         const double *times, size_t count, size_t *written, double *q, double *v)
{
    double f[7][DIM], at[DIM];
    if (other_more(k, t, h, y) != 0) {
        return 1;
    }
    for (int i = 0; i < DIM; ++i) {
        f[0][i] = next[i] - y[i];
        f[1][i] = h * k[0][i] - f[0][i];
        f[2][i] = 2.0 * f[0][i] - h * (k[12][i] + k[0][i]);
        f[3][i] = h * (OTHER_DENSE_0);
        f[4][i] = h * (OTHER_DENSE_1);
        f[5][i] = h * (OTHER_DENSE_2);
        f[6][i] = h * (OTHER_DENSE_3);
    }
    for (; *written < count && times[*written] <= t + h; ++*written) {
        const double x = (times[*written] - t) / h;
        for (int i = 0; i < DIM; ++i) {
            double sum = 0.0;
            for (int r = 6; r >= 0; --r) {
                sum = (sum + f[r][i]) * (r % 2 == 0 ? x : 1.0 - x);
            }
            at[i] = y[i] + sum;
        }
        if (!OTHER_RAW && other_project(at) != 0) {
            return 1;
        }
        memcpy(q + *written * NQ, at, sizeof(double) * NQ);
        memcpy(v + *written * NV, at + NQ, sizeof(double) * NV);
    }
    return 0;
}

/* From (q0, v0) to all output times, the first of which is that of the start. Steps taken, or -1. */
long other_run(const double *q0, const double *v0, double h, double tolerance, const double *times, size_t count,
               double *q, double *v)
{
    static double k[16][DIM];
    double y[DIM], next[DIM], t = times[0];
    long steps = 0;
    size_t written = 1;
    memcpy(y, q0, sizeof(double) * NQ);
    memcpy(y + NQ, v0, sizeof(double) * NV);
    memcpy(q, q0, sizeof(double) * NQ);
    memcpy(v, v0, sizeof(double) * NV);
    if (other_project(y) != 0 || other_slope(t, y, k[0]) != 0) {
        return -1;
    }
    while (written < count) {
        for (int rejected = 0;; rejected = 1) {
            if (!(h > 1e-14) || other_stages(k, t, h, y) != 0) {
                return -1;
            }
            for (int i = 0; i < DIM; ++i) {
                next[i] = y[i] + h * (OTHER_NEXT);
            }
            if (other_slope(t + h, next, k[12]) != 0) {
                return -1;
            }
            const double error = other_error(k, h, y, next, tolerance);
            const double factor = error == 0.0 ? 10.0 : fmin(10.0, fmax(0.2, 0.9 * pow(error, -0.125)));
            if (error < 1.0) {
                ++steps;
                if (times[written] <= t + h && other_outputs(k, t, h, y, next, times, count, &written, q, v) != 0) {
                    return -1;
                }
                t += h;
                h *= rejected ? fmin(1.0, factor) : factor;
                break;
            }
            h *= factor;
        }
        memcpy(y, next, sizeof y);
        if (other_project(y) != 0 || other_slope(t, y, k[0]) != 0) {
            return -1;
        }
    }
    return steps;
}
