/* Steps of fixed size of many states, a thread each: those of the loop in C (loop.c) where no singular configuration is
 * near. A state that comes near one, or cannot go on, stays where its last good step ended, and says how many it took. */

ROUTINE int one_step(double dt, double t, double *q, double *v, double *x, const double *u)
{
    Step s;
    s.careful = 0;
    s.precise.anchor = NULL;
    s.precise.state = NULL;
    s.u = u;
    s.t = t;
    s.h = dt;
    s.rest = s.until = 0.0;
    memcpy(s.base, q, sizeof(double) * NQ);
    memset(s.start, 0, sizeof(double) * NV);
    memcpy(s.start + NV, v, sizeof(double) * NV);
    memcpy(s.start + 2 * NV, x, sizeof(double) * NX);
    int outcome = slope(&s, t, s.start, s.k[0]);
    if (outcome == 0) {
        outcome = take(&s, METHOD);
    }
    if (outcome != 0) {
        return 1;
    }
    for (int k = 0; k < NV; ++k) {
        if (!isfinite(s.v[k])) {
            return 1;
        }
    }
    if (NR && FREE && s.pivot < CAREFUL) {
        return 3;
    }
    memcpy(q, s.q, sizeof(double) * NQ);
    memcpy(v, s.v, sizeof(double) * NV);
    memcpy(x, s.x, sizeof(double) * NX);
    return 0;
}

KERNEL STEPS_KERNEL(size_t count, size_t stride, double t, double h, int steps, double *q, double *v, double *x,
                    const double *u, int *status, int *taken)
{
    for (size_t index = FIRST_STATE; index < count; index += NEXT_STATE) {
        double own_q[NQ1], own_v[NV1], own_x[NX1] = {0.0}, own_u[NU1];
        int done = 0, outcome = 0;
        for (int k = 0; k < NQ; ++k) {
            own_q[k] = q[k * stride + index];
        }
        for (int k = 0; k < NV; ++k) {
            own_v[k] = v[k * stride + index];
        }
        for (int k = 0; k < NX; ++k) {
            own_x[k] = x[k * stride + index];
        }
        for (int k = 0; k < NU; ++k) {
            own_u[k] = u[k * stride + index];
        }
        while (done < steps && outcome == 0) {
            outcome = one_step(h, t + done * h, own_q, own_v, own_x, own_u);
            done += outcome == 0;
        }
        for (int k = 0; k < NQ; ++k) {
            q[k * stride + index] = own_q[k];
        }
        for (int k = 0; k < NV; ++k) {
            v[k * stride + index] = own_v[k];
        }
        for (int k = 0; k < NX; ++k) {
            x[k * stride + index] = own_x[k];
        }
        status[index] = outcome;
        taken[index] = done;
    }
}
