/* RK4 with fixed steps on the accelerations of a planar chain of loops; after every step q and v go back onto the
 * closure by the generated functions. Where those meet a small pivot, the step stays as it is: the next one corrects. */

static long left_open;

static int slopes(const double *y, double *dy)
{
    const int status = accelerations_at(y, y + NV, dy + NV);
    memcpy(dy, y + NV, sizeof(double) * NV);
    return status > 0 ? status : 0;
}

int fall(long steps, double h, const double *start, long every, double *outputs, long *skipped)
{
    double y[2 * NV], k[4][2 * NV], z[2 * NV], next[NV], residual[1];
    memcpy(y, start, sizeof y);
    left_open = 0;
    for (long n = 0; n <= steps; ++n) {
        if (n % every == 0) {
            memcpy(outputs + n / every * NV, y, sizeof(double) * NV);
        }
        if (n == steps) {
            break;
        }
        for (int stage = 0; stage < 4; ++stage) {
            const double part = stage == 0 ? 0.0 : stage == 3 ? h : 0.5 * h;
            for (int i = 0; i < 2 * NV; ++i) {
                z[i] = stage == 0 ? y[i] : y[i] + part * k[stage - 1][i];
            }
            const int status = slopes(z, k[stage]);
            if (status) {
                return status;
            }
        }
        for (int i = 0; i < 2 * NV; ++i) {
            y[i] += h / 6.0 * (k[0][i] + 2.0 * (k[1][i] + k[2][i]) + k[3][i]);
        }
        if (close_q(y, next, residual) > 0) {
            ++left_open;
            continue;
        }
        memcpy(y, next, sizeof next);
        if (close_v(y, y + NV, next) > 0) {
            ++left_open;
            continue;
        }
        memcpy(y + NV, next, sizeof next);
    }
    *skipped = left_open;
    return 0;
}
