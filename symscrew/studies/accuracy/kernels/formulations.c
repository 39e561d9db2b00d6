/* The equations of a closed chain in several formulations, integrated by RK4 with fixed steps or by DOP853 with error
 * control. Stands on closure.c (opened, orthonormal, shortest, projected) and on the adapters forces_at, terms_at,
 * assembled_at, rates_of of the generated functions.
 *
 *   NONE        q' = v, v' = a(q, v): accelerations that fulfil the twice differentiated closure
 *   PROJECTION  the same, q and v put back onto the closure after every step
 *   BAUMGARTE   J a + b = -2 gain J v - gain^2 closure
 *   STABILISED  q' = v less its part across the closure (Gear, Gupta, Leimkuhler, with the multipliers eliminated)
 *   PENALTY     (M + alpha J^T J) a = f - alpha J^T (b + 2 gain J v + gain^2 closure)    (Bayo et al.)
 *   MINIMAL     independent coordinates y: y' and y'' integrated, q assembled, v from y' at every evaluation
 */

enum { NONE, PROJECTION, BAUMGARTE, STABILISED, PENALTY, MINIMAL };
enum { BY_RK4, BY_DOP853 };
#define NSTATE (NQ + NV + NX)
#define NSTATE1 (NSTATE > 0 ? NSTATE : 1)

typedef struct {
    int formulation;
    double gain, alpha, t, h;
    double start[NSTATE1], k[13][NSTATE1], y[NSTATE1];
    double guess[NQ1];
    long evaluations;
} March;

#if NR
static int penalised(const March *m, double t, const double *q, const double *v, const double *x, double *a)
{
    static double mass[NV * NV], matrix[NV][NV];
    double force[NV], bias[NR], speed[NR], right[NV];
    Closure o;
    if (terms_at(t, q, v, x, mass, force, bias) > 0 || opened(q, &o) != 0) {
        return FAILED;
    }
    closure_rates(&o, v, speed);
    for (int i = 0; i < NR; ++i) {
        speed[i] = bias[i] * ROW_SCALE[i] + 2.0 * m->gain * speed[i] + m->gain * m->gain * o.residual[i];
    }
    for (int i = 0; i < NV; ++i) {
        right[i] = force[i] * UNIT[i];
        for (int r = 0; r < NR; ++r) {
            right[i] -= m->alpha * o.jacobian[r][i] * speed[r];
        }
        for (int j = 0; j <= i; ++j) {
            double entry = mass[j * NV + i] * UNIT[i] * UNIT[j];
            for (int r = 0; r < NR; ++r) {
                entry += m->alpha * o.jacobian[r][i] * o.jacobian[r][j];
            }
            for (int k = 0; k < j; ++k) {
                entry -= matrix[i][k] * matrix[j][k];
            }
            if (i == j && !(entry > 0.0)) {
                return FAILED;
            }
            matrix[i][j] = i == j ? sqrt(entry) : entry / matrix[j][j];
        }
    }
    for (int i = 0; i < NV; ++i) {
        for (int k = 0; k < i; ++k) {
            right[i] -= matrix[i][k] * right[k];
        }
        right[i] /= matrix[i][i];
    }
    for (int i = NV - 1; i >= 0; --i) {
        for (int k = i + 1; k < NV; ++k) {
            right[i] -= matrix[k][i] * right[k];
        }
        right[i] /= matrix[i][i];
    }
    for (int i = 0; i < NV; ++i) {
        a[i] = right[i] * UNIT[i];
    }
    return 0;
}
#endif

static int derivative(March *m, double t, const double *y, double *dy)
{
    double q[NQ1], v[NV1], a[NV1], q_dot[NQ1];
    ++m->evaluations;
#if NR
    if (m->formulation == MINIMAL) {
        const double *x = y + 2 * FREE;
        memcpy(q, m->guess, sizeof q);
        if (assembled_at(y, m->guess, q) != 0 || rates_of(q, y + FREE, v) > 0) {
            return FAILED;
        }
        memcpy(m->guess, q, sizeof q);
        const int outcome = valid(forces_at(t, q, v, x, a, dy + 2 * FREE));
        if (outcome != 0) {
            return outcome;
        }
        double second[NQ1], of_rates[NQ1];
        coordinate_rates(q, v, q_dot);
        coordinate_rates(q, a, second);
        coordinate_rates(q_dot, v, of_rates); /* for quaternions: the rate of q in q' = B(q) v */
        for (int i = 0; i < FREE; ++i) {
            dy[i] = y[FREE + i];
            dy[FREE + i] = second[INDEPENDENT[i]] + (OF_SPHERE[i] ? of_rates[INDEPENDENT[i]] : 0.0);
        }
        return 0;
    }
#endif
    memcpy(q, y, sizeof(double) * NQ);
    memcpy(v, y + NQ, sizeof(double) * NV);
    const double *x = y + NQ + NV;
    double *x_dot = dy + NQ + NV;
    int outcome;
    outcome = valid(forces_at(t, q, v, x, a, x_dot));
    if (outcome != 0) {
        return outcome;
    }
    coordinate_rates(q, v, q_dot);
#if NR
    if (m->formulation == PENALTY) {
        outcome = penalised(m, t, q, v, x, a);
        if (outcome != 0) {
            return outcome;
        }
    }
    if (m->formulation == BAUMGARTE || m->formulation == STABILISED) {
        Closure o;
        double right[NR], d[NV1];
        if (opened(q, &o) != 0) {
            return FAILED;
        }
        orthonormal(&o);
        closure_rates(&o, v, right);
        if (m->formulation == BAUMGARTE) {
            for (int i = 0; i < NR; ++i) {
                right[i] = -2.0 * m->gain * right[i] - m->gain * m->gain * o.residual[i];
            }
        }
        shortest(&o, right, d);
        for (int k = 0; k < NV; ++k) {
            if (m->formulation == BAUMGARTE) {
                a[k] += d[k] * UNIT[k];
            } else {
                v[k] -= d[k] * UNIT[k];
            }
        }
        coordinate_rates(q, v, q_dot);
    }
#endif
    memcpy(dy, q_dot, sizeof(double) * NQ);
    memcpy(dy + NQ, a, sizeof(double) * NV);
    return 0;
}

#define EACH(expression)                                                                                               \
    for (int i = 0; i < size; ++i) {                                                                                   \
        y[i] = m->start[i] + h * (expression);                                                                         \
    }
#define STAGE(target, c)                                                                                               \
    outcome = derivative(m, m->t + (c) * h, y, k[target]);                                                             \
    if (outcome != 0) {                                                                                                \
        return outcome;                                                                                                \
    }

static int by_rk4(March *m, int size)
{
    const double h = m->h;
    double(*k)[NSTATE1] = m->k, *y = m->y;
    int outcome;
    EACH(0.5 * k[0][i])
    STAGE(1, 0.5)
    EACH(0.5 * k[1][i])
    STAGE(2, 0.5)
    EACH(k[2][i])
    STAGE(3, 1.0)
    EACH((k[0][i] + k[3][i]) / 6.0 + (k[1][i] + k[2][i]) / 3.0)
    return 0;
}

static int by_dop853(March *m, int size)
{
    const double h = m->h;
    double(*k)[NSTATE1] = m->k, *y = m->y;
    int outcome;
#include "dop853_stages.c"
    return 0;
}

static double estimated(const March *m, int size, double tolerance)
{
    const double(*k)[NSTATE1] = (const double(*)[NSTATE1])m->k;
    double fifth = 0.0, third = 0.0;
    for (int i = 0; i < size; ++i) {
        const double w = tolerance * (1.0 + fmax(fabs(m->start[i]), fabs(m->y[i])));
        const double a = DOP853_ERROR_5(i) / w, b = DOP853_ERROR_3(i) / w;
        fifth += a * a;
        third += b * b;
    }
    const double below = fifth + 0.01 * third;
    return below > 0.0 ? fabs(m->h) * fifth / sqrt(below * size) : 0.0;
}

/* From `start` (q, v, x) over the ascending `times`; writes q, v of each. Returns 0, or what stopped it. `steps` bounds
 * the number of steps and is the number taken; for MINIMAL the state is (y, y', x). */
int march(int formulation, int method, double gain, double alpha, double h, double tolerance, const double *start,
          const double *guess, const double *times, size_t count, double *q_out, double *v_out, long *steps,
          long *evaluations)
{
    static March march_state;
    March *m = &march_state;
    const int size = formulation == MINIMAL ? 2 * FREE + NX : NSTATE;
    const long most = *steps;
    double step = h;
    memset(m, 0, sizeof *m);
    m->formulation = formulation;
    m->gain = gain;
    m->alpha = alpha;
    m->t = times[0];
    memcpy(m->start, start, sizeof(double) * (size_t)size);
    memcpy(m->guess, guess, sizeof(double) * NQ);
    *steps = 0;
    for (size_t n = 0; n < count; ++n) {
        const double end = times[n];
        const double span = end - m->t;
        const long parts = span > 0.0 ? (long)ceil(span / h - 1e-9) : 0; /* of the fixed step */
        for (long part = 0; method == BY_RK4 ? part < parts : m->t < end;) {
            if (*steps >= most) {
                return 1003;
            }
            const double left = end - m->t;
            const int last = method == BY_RK4 ? part == parts - 1 : step >= left * (1.0 - 1e-12);
            m->h = method == BY_RK4 ? span / (double)parts : (last ? left : step);
            if (!(m->h > 1e-15 * (fabs(m->t) + span))) {
                return 1004;
            }
            int outcome = derivative(m, m->t, m->start, m->k[0]);
            if (outcome != 0) {
                return outcome;
            }
            outcome = method == BY_RK4 ? by_rk4(m, size) : by_dop853(m, size);
            ++*steps;
            if (method == BY_DOP853) {
                const double error = outcome == 0 ? estimated(m, size, tolerance) : 1e6;
                const double factor = fmin(6.0, fmax(0.2, 0.9 * pow(fmax(error, 1e-10), -0.125)));
                if (!(error < 1.0)) {
                    step = m->h * fmin(factor, 0.9);
                    continue;
                }
                step = last ? fmax(step, m->h * factor) : m->h * factor;
                step = last && m->h * factor < step && left > 0.5 * step ? m->h * factor : step;
            } else if (outcome != 0) {
                return outcome;
            }
            memcpy(m->start, m->y, sizeof(double) * (size_t)size);
            for (int i = 0; i < size; ++i) {
                if (!(fabs(m->start[i]) < 1e100)) {
                    return 2;
                }
            }
            m->t = last ? end : m->t + m->h;
            ++part;
            if (formulation != MINIMAL) {
                normalise(m->start);
            }
#if NR
            if (formulation == PROJECTION && projected(m->start, m->start + NQ) != 0) {
                return FAILED;
            }
#endif
        }
        if (formulation == MINIMAL) {
#if NR
            memcpy(q_out + n * NQ, m->guess, sizeof(double) * NQ);
            if (assembled_at(m->start, m->guess, q_out + n * NQ) != 0) {
                return FAILED;
            }
            memcpy(m->guess, q_out + n * NQ, sizeof(double) * NQ);
            rates_of(q_out + n * NQ, m->start + FREE, v_out + n * NV);
#endif
        } else {
            memcpy(q_out + n * NQ, m->start, sizeof(double) * NQ);
            memcpy(v_out + n * NV, m->start + NQ, sizeof(double) * NV);
        }
    }
    *evaluations = m->evaluations;
    return 0;
}
