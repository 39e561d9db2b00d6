/* Joint positions from a platform's twist: forward Euler or Runge-Kutta of order 4, with or without projection.
 * rates_at(q, twist, rates) and closed_at(q, next) are the generated functions; rates of spherical joints are in the
 * parent's axes. `twists` has a row of six per instant: every step for Euler, every half step for Runge-Kutta. */

static void slopes(const double *q, const double *twist, double *q_dot)
{
    double rates[NW];
    rates_at(q, twist, rates);
    for (int i = 0; i < PLAIN_COUNT; ++i) {
        q_dot[PLAIN[i][0]] = rates[PLAIN[i][1]];
    }
    for (int i = 0; i < SPHERE_COUNT; ++i) {
        const double *w = rates + SPHERES[i][1], *r = q + SPHERES[i][0];
        double *o = q_dot + SPHERES[i][0];
        o[0] = -0.5 * (w[0] * r[1] + w[1] * r[2] + w[2] * r[3]);
        o[1] = 0.5 * (r[0] * w[0] + w[1] * r[3] - w[2] * r[2]);
        o[2] = 0.5 * (r[0] * w[1] + w[2] * r[1] - w[0] * r[3]);
        o[3] = 0.5 * (r[0] * w[2] + w[0] * r[2] - w[1] * r[1]);
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

static void shifted(const double *q, const double *slope, double h, double *moved)
{
    for (int k = 0; k < NQ; ++k) {
        moved[k] = q[k] + h * slope[k];
    }
    normalise(moved); /* within a step quaternions leave their length: rates_at takes no others */
}

/* `outputs` states q, one every `every` steps from the first on. */
int integrate(long steps, double h, int order, const double *start, const double *twists, long every, double *outputs)
{
    double q[NQ], next[NQ], k1[NQ], k2[NQ], k3[NQ], k4[NQ];
    memcpy(q, start, sizeof q);
    for (long n = 0; n <= steps; ++n) {
        if (n % every == 0) {
            memcpy(outputs + n / every * NQ, q, sizeof q);
        }
        if (n == steps) {
            break;
        }
        if (order == 1) {
            slopes(q, twists + 6 * n, k1);
            shifted(q, k1, h, next);
        } else {
            const double *twist = twists + 12 * n;
            slopes(q, twist, k1);
            shifted(q, k1, 0.5 * h, next);
            slopes(next, twist + 6, k2);
            shifted(q, k2, 0.5 * h, next);
            slopes(next, twist + 6, k3);
            shifted(q, k3, h, next);
            slopes(next, twist + 12, k4);
            for (int k = 0; k < NQ; ++k) {
                next[k] = q[k] + h / 6.0 * (k1[k] + 2.0 * (k2[k] + k3[k]) + k4[k]);
            }
        }
        normalise(next);
        memcpy(q, next, sizeof q);
#if PROJECTED
        if (closed_at(q, next) > 0) {
            return 1;
        }
        memcpy(q, next, sizeof q);
#endif
    }
    return 0;
}
