/* What both standards share: an instance, its variables by value reference, derivatives, projection, steps. Comes after
 * the loop of the scene and the constants NP, NO, VARIABLES, FMU_STEP, TOKEN, START_*. */

#include <stdlib.h>
#include <stdarg.h>
#include <stdio.h>

#define OPEN_ENOUGH 1e-10 /* opening of the loops, without units, from which a model exchange asks for an event */

/* Where an instance is in its life, one bit each; which functions may be called there, both standards say in tables. */
enum { INSTANTIATED = 1, INITIALISING = 2, EVENT = 4, CONTINUOUS = 8, STEPPING = 16, TERMINATED = 32 };
#define STARTED (EVENT | CONTINUOUS | STEPPING)
#define READABLE (INITIALISING | STARTED | TERMINATED)
#define WRITABLE (INSTANTIATED | INITIALISING | STARTED)

#define MOST_STEPS 1e9 /* of a communication step: with more it does not end, and cannot be counted */

typedef struct {
    double t, start_time, step;
    double q[NQ1], v[NV1], x[NX1], u[NU + 1], outside[NO + 1], p[NP + 1];
    double a[NV1], x_dot[NX1]; /* derivatives at the present state */
    int derived, mode;
    unsigned char x_given[NX1]; /* at the start, by the importer */
} State;

typedef void (*Report)(void *instance, int is_error, const char *message);

typedef struct {
    State state;
    void *environment, *logger;
    char *name;
    Report report;
    int logging, steps_itself; /* co-simulation; else model exchange */
} Instance;

/* Whether a function may be called now; if not, why is reported. */
static int allowed(void *instance, int modes, const char *function)
{
    Instance *m = instance;
    if (m == NULL) {
        return 0;
    }
    if ((m->state.mode & modes) == 0) {
        char text[160];
        const char *now = m->state.mode == INSTANTIATED ? "before it is initialised"
                          : m->state.mode == INITIALISING ? "in initialization mode"
                          : m->state.mode == EVENT ? "in event mode"
                          : m->state.mode == CONTINUOUS ? "in continuous-time mode"
                          : m->state.mode == STEPPING ? "in step mode"
                                                      : "after it is terminated";
        snprintf(text, sizeof text, "%s cannot be called %s", function, now);
        m->report(m, 1, text);
        return 0;
    }
    return 1;
}

/* The same for functions of model exchange alone, or of co-simulation alone. */
static int allowed_if(int steps_itself, void *instance, int modes, const char *function)
{
    Instance *m = instance;
    if (m != NULL && m->steps_itself != steps_itself) {
        char text[160];
        snprintf(text, sizeof text, "%s is not for %s", function, m->steps_itself ? "co-simulation" : "model exchange");
        m->report(m, 1, text);
        return 0;
    }
    return allowed(m, modes, function);
}

static int enter_mode(void *instance, int mode)
{
    ((Instance *)instance)->state.mode = mode;
    return 0;
}

static const double Q_START[NQ1] = START_Q, V_START[NV1] = START_V, X_START[NX1] = START_X, P_START[NP + 1] = START_P;

static void initialise(Instance *m)
{
    State *s = &m->state;
    memset(s, 0, sizeof *s);
    memcpy(s->q, Q_START, sizeof Q_START);
    memcpy(s->v, V_START, sizeof V_START);
    memcpy(s->x, X_START, sizeof X_START);
    memcpy(s->p, P_START, sizeof P_START);
    s->step = FMU_STEP;
    s->mode = INSTANTIATED;
}

static void load(const State *s)
{
    memcpy(PARAMETERS, s->p, sizeof(double) * NP);
    memcpy(OUTSIDE, s->outside, sizeof(double) * NO);
}

static int derive(Instance *m)
{
    State *s = &m->state;
    if (s->derived) {
        return 0;
    }
    load(s);
    const int outcome = forces_at(s->t, s->q, s->v, s->x, s->u, s->a, s->x_dot);
    if (outcome > 0) {
        m->report(m, 1, "the accelerations are not defined here: a singular configuration, or a number is not finite");
        return 1;
    }
    s->derived = 1;
    return 0;
}

static double q_rate(const State *s, int index)
{
    for (int k = 0; k < PLAIN_COUNT; ++k) {
        if (PLAIN[k][0] == index) {
            return s->v[PLAIN[k][1]];
        }
    }
    for (int k = 0; k < SPHERE_COUNT; ++k) {
        const int first = SPHERES[k][0], part = index - first;
        if (part >= 0 && part < 4) {
            const double *e = s->q + first, *w = s->v + SPHERES[k][1];
            switch (part) { /* half of (quaternion) (0, rates in the child's axes) */
            case 0: return -0.5 * (e[1] * w[0] + e[2] * w[1] + e[3] * w[2]);
            case 1: return 0.5 * (e[0] * w[0] + e[2] * w[2] - e[3] * w[1]);
            case 2: return 0.5 * (e[0] * w[1] + e[3] * w[0] - e[1] * w[2]);
            default: return 0.5 * (e[0] * w[2] + e[1] * w[1] - e[2] * w[0]);
            }
        }
    }
    return 0.0;
}

/* Value references: time, step, u, outside, p, q, v, x, rates of q, v, x. */
enum {
    VR_TIME, VR_STEP, VR_U, VR_OUTSIDE = VR_U + NU, VR_P = VR_OUTSIDE + NO, VR_Q = VR_P + NP, VR_V = VR_Q + NQ,
    VR_X = VR_V + NV, VR_Q_RATE = VR_X + NX, VR_V_RATE = VR_Q_RATE + NQ, VR_X_RATE = VR_V_RATE + NV,
    VR_END = VR_X_RATE + NX
};

static int get_value(Instance *m, unsigned int vr, double *value)
{
    State *s = &m->state;
    const int k = (int)vr;
    if (vr >= VR_END) {
        m->report(m, 1, "no variable has this value reference");
        return 1;
    }
    if (k >= VR_V_RATE && derive(m) != 0) {
        return 1;
    }
    *value = k >= VR_X_RATE   ? s->x_dot[k - VR_X_RATE]
             : k >= VR_V_RATE ? s->a[k - VR_V_RATE]
             : k >= VR_Q_RATE ? q_rate(s, k - VR_Q_RATE)
             : k >= VR_X      ? s->x[k - VR_X]
             : k >= VR_V      ? s->v[k - VR_V]
             : k >= VR_Q      ? s->q[k - VR_Q]
             : k >= VR_P      ? s->p[k - VR_P]
             : k >= VR_OUTSIDE ? s->outside[k - VR_OUTSIDE]
             : k >= VR_U      ? s->u[k - VR_U]
             : k == VR_STEP   ? s->step
                              : s->t;
    return 0;
}

static int set_value(Instance *m, unsigned int vr, double value)
{
    State *s = &m->state;
    const int k = (int)vr;
    double *place = k >= VR_Q_RATE    ? NULL
                    : k >= VR_X       ? s->x + (k - VR_X)
                    : k >= VR_V       ? s->v + (k - VR_V)
                    : k >= VR_Q       ? s->q + (k - VR_Q)
                    : k >= VR_P       ? s->p + (k - VR_P)
                    : k >= VR_OUTSIDE ? s->outside + (k - VR_OUTSIDE)
                    : k >= VR_U       ? s->u + (k - VR_U)
                    : k == VR_STEP    ? &s->step
                                      : NULL;
    if (vr >= VR_END || place == NULL) {
        m->report(m, 1, "this variable cannot be set");
        return 1;
    }
    if (!isfinite(value) || (k == VR_STEP && !(value > 0.0))) {
        m->report(m, 1, "expected a finite number, for the step a positive one");
        return 1;
    }
    *place = value;
    s->derived = 0;
    if (k >= VR_X && (s->mode & (INSTANTIATED | INITIALISING)) != 0) {
        s->x_given[k - VR_X] = 1;
    }
    return 0;
}

/* Quaternions of unit length and loops closed by `onto`, settle or settled_start; 1 if they cannot be. */
static int close_state(Instance *m, int (*onto)(double *q, double *v, double *pivot))
{
    State *s = &m->state;
    double pivot = 1.0;
    load(s);
    for (int k = 0; k < SPHERE_COUNT; ++k) {
        double *e = s->q + SPHERES[k][0];
        const double size = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);
        if (!(size > 0.0)) {
            m->report(m, 1, "a quaternion is zero");
            return 1;
        }
        for (int i = 0; i < 4; ++i) {
            e[i] /= size;
        }
    }
    s->derived = 0;
    const int outcome = onto(s->q, s->v, &pivot);
    if (outcome != 0) {
        m->report(m, 1, outcome == VAGUE ? "the start is beside a singular configuration and off the loops by more than "
                                           "rounding, which moves it a thousand times as far: give q and v with all digits"
                                         : "the loops cannot be closed from this configuration");
        return 1;
    }
    return 0;
}

/* The start as it was given: loops closed, and states of effects where its q, v and parameters put them, but those that
 * were given as well; 1 if that cannot be. */
static int begin(Instance *m)
{
    State *s = &m->state;
    const int other = memcmp(s->q, Q_START, sizeof Q_START) != 0 || memcmp(s->v, V_START, sizeof V_START) != 0
                      || memcmp(s->p, P_START, sizeof P_START) != 0;
    if (close_state(m, settled_start) != 0) {
        return 1;
    }
#ifdef STARTED_STATES
    if (other) {
        double x[STARTED_STATES];
        if (STATES_AT_START(s->q, s->v, x) > 0) {
            m->report(m, 1, "the states of effects have no values at this start");
            return 1;
        }
        for (int k = 0; k < STARTED_STATES; ++k) {
            if (!s->x_given[k]) {
                s->x[k] = x[k];
            }
        }
    }
#else
    (void)other;
#endif
    return 0;
}

/* Whether the state has drifted off the closure, or a quaternion off the unit length. */
static int drifted(Instance *m)
{
    State *s = &m->state;
    load(s);
    for (int k = 0; k < SPHERE_COUNT; ++k) {
        const double *e = s->q + SPHERES[k][0];
        if (fabs(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3] - 1.0) > OPEN_ENOUGH) {
            return 1;
        }
    }
#if NR
    double residual[NR1], jacobian[NR1 * NV1], total = 0.0;
    if (closure_at(s->q, residual, jacobian) != 0) {
        return 1;
    }
    for (int i = 0; i < NR; ++i) {
        total += residual[i] * residual[i] * ROW_SCALE[i] * ROW_SCALE[i];
    }
    return sqrt(total) > OPEN_ENOUGH;
#else
    return 0;
#endif
}

/* A communication step by steps of at most `step`, each projected onto the closure. */
static int communicate(Instance *m, double t, double h)
{
    State *s = &m->state;
    if (!(h > 0.0) || !isfinite(h) || !isfinite(t) || !(h / s->step <= MOST_STEPS)) {
        m->report(m, 1, "expected a finite time and a positive communication step of at most 1e9 steps");
        return 1;
    }
    load(s);
    s->derived = 0;
    const long count = h > s->step ? (long)ceil(h / s->step - 1e-9) : 1;
    for (long k = 0; k < count; ++k) {
        const int outcome = LOOP_STEP(h / (double)count, t + h * (double)k / (double)count, s->q, s->v, s->x, s->u);
        if (outcome != 0) {
            s->t = t + h * (double)k / (double)count;
            m->report(m, 1, outcome == 2 ? "at rest in a singular configuration, where several motions begin"
                                         : "the motion cannot be continued: the loops open, or a number is not finite");
            return 1;
        }
    }
    s->t = t + h;
    return 0;
}
