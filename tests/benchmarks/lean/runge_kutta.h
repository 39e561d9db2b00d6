/* STEP: a step of 1 ms of Runge and Kutta's fourth-order method on FORWARD, accelerations of the seed's tree from its
   coordinates, rates and drives, which are held. Loops are not closed after it; both sides take this text. */
static inline __attribute__((always_inline)) void JOINED(STEP, moved)(
    const double *restrict q, const double *restrict v, const double *restrict slope_q, const double *restrict slope_v,
    double h, double *restrict q_next, double *restrict v_next)
{
    for (int k = 0; k < 16; ++k) {
        q_next[k] = q[k] + h * slope_q[k];
    }
    for (int k = 0; k < 15; ++k) {
        v_next[k] = v[k] + h * slope_v[k];
    }
}

/* Rates of the coordinates: angular velocity in the platform's axes, the others are their own. */
static inline __attribute__((always_inline)) void JOINED(STEP, rates)(
    const double *restrict q, const double *restrict v, double *restrict q_dot)
{
    const double x = 0.5 * v[12], y = 0.5 * v[13], z = 0.5 * v[14];
    for (int k = 0; k < 12; ++k) {
        q_dot[k] = v[k];
    }
    q_dot[12] = -q[13] * x - q[14] * y - q[15] * z;
    q_dot[13] = q[12] * x + q[14] * z - q[15] * y;
    q_dot[14] = q[12] * y + q[15] * x - q[13] * z;
    q_dot[15] = q[12] * z + q[13] * y - q[14] * x;
}

int STEP(const double *restrict q, const double *restrict v, const double *restrict u, double *restrict q_next,
         double *restrict v_next)
{
    const double h = 1e-3;
    double p[4][16], a[4][15], at[16], rate[15];
    int worst = FORWARD(q, v, u, a[0]), status;
    JOINED(STEP, rates)(q, v, p[0]);
    for (int k = 1; k < 4; ++k) {
        JOINED(STEP, moved)(q, v, p[k - 1], a[k - 1], k == 3 ? h : 0.5 * h, at, rate);
        JOINED(STEP, rates)(at, rate, p[k]);
        status = FORWARD(at, rate, u, a[k]);
        worst = status > worst ? status : worst;
    }
    for (int k = 0; k < 16; ++k) {
        q_next[k] = q[k] + h / 6.0 * (p[0][k] + 2.0 * (p[1][k] + p[2][k]) + p[3][k]);
    }
    for (int k = 0; k < 15; ++k) {
        v_next[k] = v[k] + h / 6.0 * (a[0][k] + 2.0 * (a[1][k] + a[2][k]) + a[3][k]);
    }
    return worst;
}
#undef STEP
#undef FORWARD
