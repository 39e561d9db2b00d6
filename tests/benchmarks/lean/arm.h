/* Inverse and forward dynamics, mass matrix, flange and Jacobian of an arm of revolute joints, for the table LINKS of COUNT links.

   Link frames are parallel to the base's at rest and lie on the joints, whose axes are y or z, so that a rotation
   touches two coordinates. All loops are unrolled and the table is constant: what is zero in it vanishes. Forces use
   first moments and inertia about the joint; the matrix K = [dw] + [w][w] is used for all points of a link. */
static inline __attribute__((always_inline)) void NAME(turn)(int axis, double c, double s, double *restrict x)
{
    const int i = axis == 2 ? 0 : 2, j = axis == 2 ? 1 : 0;
    const double first = c * x[i] - s * x[j];
    x[j] = s * x[i] + c * x[j];
    x[i] = first;
}

static inline __attribute__((always_inline)) void NAME(sines)(
    const double *restrict q, double *restrict sine, double *restrict cosine)
{
    const four low = {q[0], q[1], q[2], q[3]}, high = {q[4], q[5], q[COUNT - 1], q[COUNT - 1]};
    const four s = _ZGVdN4v_sin(low), c = _ZGVdN4v_cos(low), t = _ZGVdN4v_sin(high), d = _ZGVdN4v_cos(high);
#pragma GCC unroll 8
    for (int k = 0; k < COUNT; ++k) {
        sine[k] = LINKS[k].sign * (k < 4 ? s[k & 3] : t[k & 3]);
        cosine[k] = k < 4 ? c[k & 3] : d[k & 3];
    }
}

static inline __attribute__((always_inline)) void NAME(forces)(
    const double *restrict sine, const double *restrict cosine, const double *restrict v, const double *restrict a,
    double *restrict u)
{
    double f[COUNT][3], n[COUNT][3];
    double w[3] = {0.0, 0.0, 0.0}, dw[3] = {0.0, 0.0, 0.0}, at[3] = {0.0, 0.0, 9.81};
    double K[3][3] = {{0.0}};
#pragma GCC unroll 8
    for (int k = 0; k < COUNT; ++k) {
        const int axis = LINKS[k].axis, i = axis == 2 ? 0 : 2, j = axis == 2 ? 1 : 0;
        const double *p = LINKS[k].place, *h = LINKS[k].moment, *I = LINKS[k].inertia;
        const double rate = LINKS[k].sign * v[k];
#pragma GCC unroll 3
        for (int r = 0; r < 3; ++r) {
            at[r] += K[r][0] * p[0] + K[r][1] * p[1] + K[r][2] * p[2];
        }
        NAME(turn)(axis, cosine[k], -sine[k], w);
        NAME(turn)(axis, cosine[k], -sine[k], dw);
        NAME(turn)(axis, cosine[k], -sine[k], at);
        /* dw + w x (rate e) + gain e */
        dw[i] += rate * w[j];
        dw[j] -= rate * w[i];
        dw[axis] += LINKS[k].sign * a[k];
        w[axis] += rate;
        const double xx = w[0] * w[0], yy = w[1] * w[1], zz = w[2] * w[2];
        const double xy = w[0] * w[1], xz = w[0] * w[2], yz = w[1] * w[2];
        K[0][0] = -(yy + zz);
        K[1][1] = -(xx + zz);
        K[2][2] = -(xx + yy);
        K[0][1] = xy - dw[2];
        K[1][0] = xy + dw[2];
        K[0][2] = xz + dw[1];
        K[2][0] = xz - dw[1];
        K[1][2] = yz - dw[0];
        K[2][1] = yz + dw[0];
        /* I dw + w x I w, by the entries of K */
        n[k][0] = I[0] * dw[0] + I[3] * K[2][0] * -1.0 + I[4] * K[1][0] + (I[2] - I[1]) * yz + I[5] * (yy - zz);
        n[k][1] = I[1] * dw[1] + I[3] * K[2][1] - I[5] * K[0][1] + (I[0] - I[2]) * xz + I[4] * (zz - xx);
        n[k][2] = I[2] * dw[2] - I[4] * K[1][2] + I[5] * K[0][2] + (I[1] - I[0]) * xy + I[3] * (xx - yy);
        n[k][0] += h[1] * at[2] - h[2] * at[1];
        n[k][1] += h[2] * at[0] - h[0] * at[2];
        n[k][2] += h[0] * at[1] - h[1] * at[0];
#pragma GCC unroll 3
        for (int r = 0; r < 3; ++r) {
            f[k][r] = LINKS[k].mass * at[r] + K[r][0] * h[0] + K[r][1] * h[1] + K[r][2] * h[2];
        }
    }
#pragma GCC unroll 8
    for (int k = COUNT - 1; k >= 0; --k) {
        const double *p = LINKS[k].place;
        u[k] = LINKS[k].sign * n[k][LINKS[k].axis];
        if (k > 0) {
            NAME(turn)(LINKS[k].axis, cosine[k], sine[k], f[k]);
            NAME(turn)(LINKS[k].axis, cosine[k], sine[k], n[k]);
            n[k - 1][0] += n[k][0] + p[1] * f[k][2] - p[2] * f[k][1];
            n[k - 1][1] += n[k][1] + p[2] * f[k][0] - p[0] * f[k][2];
            n[k - 1][2] += n[k][2] + p[0] * f[k][1] - p[1] * f[k][0];
            f[k - 1][0] += f[k][0];
            f[k - 1][1] += f[k][1];
            f[k - 1][2] += f[k][2];
        }
    }
}

int NAME(inverse_dynamics)(
    const double *restrict q, const double *restrict v, const double *restrict a, double *restrict u)
{
    double sine[COUNT], cosine[COUNT];
    NAME(sines)(q, sine, cosine);
    NAME(forces)(sine, cosine, v, a, u);
    return 0;
}

/* Composite inertias towards the base; a column is what a unit acceleration of its joint takes, carried down. */
static inline __attribute__((always_inline)) void NAME(inertia)(
    const double *restrict sine, const double *restrict cosine, double *restrict M)
{
    double mass = 0.0, h[3] = {0.0, 0.0, 0.0};
    double I[3][3] = {{0.0}};
#pragma GCC unroll 8
    for (int k = COUNT - 1; k >= 0; --k) {
        const int axis = LINKS[k].axis, i = axis == 2 ? 0 : 2, j = axis == 2 ? 1 : 0;
        const double *own = LINKS[k].inertia;
        mass += LINKS[k].mass;
        I[0][0] += own[0];
        I[1][1] += own[1];
        I[2][2] += own[2];
        I[0][1] += own[3];
        I[0][2] += own[4];
        I[1][2] += own[5];
#pragma GCC unroll 3
        for (int r = 0; r < 3; ++r) {
            h[r] += LINKS[k].moment[r];
        }
        I[1][0] = I[0][1];
        I[2][0] = I[0][2];
        I[2][1] = I[1][2];
        double f[3] = {0.0, 0.0, 0.0}, n[3] = {I[0][axis], I[1][axis], I[2][axis]};
        f[i] = -h[j];
        f[j] = h[i];
        M[k * COUNT + k] = n[axis];
#pragma GCC unroll 8
        for (int l = k; l > 0; --l) {
            const double *p = LINKS[l].place;
            NAME(turn)(LINKS[l].axis, cosine[l], sine[l], f);
            NAME(turn)(LINKS[l].axis, cosine[l], sine[l], n);
            n[0] += p[1] * f[2] - p[2] * f[1];
            n[1] += p[2] * f[0] - p[0] * f[2];
            n[2] += p[0] * f[1] - p[1] * f[0];
            M[k * COUNT + l - 1] = M[(l - 1) * COUNT + k] = LINKS[k].sign * LINKS[l - 1].sign * n[LINKS[l - 1].axis];
        }
        if (k > 0) {
            const double c = cosine[k], s = sine[k], *p = LINKS[k].place;
            const double t = c * I[i][i] - s * I[i][j], d = c * I[i][j] - s * I[j][j];
            const double ii = c * t - s * d, ij = s * t + c * d, jj = I[i][i] + I[j][j] - ii;
            const double ia = c * I[i][axis] - s * I[j][axis], ja = s * I[i][axis] + c * I[j][axis];
            I[i][i] = ii;
            I[j][j] = jj;
            I[i][j] = I[j][i] = ij;
            I[i][axis] = I[axis][i] = ia;
            I[j][axis] = I[axis][j] = ja;
            NAME(turn)(axis, c, s, h);
            /* about the joint below: with g = h + m p / 2, I + 2 g.p - g p' - p g' */
            const double g[3] = {h[0] + 0.5 * mass * p[0], h[1] + 0.5 * mass * p[1], h[2] + 0.5 * mass * p[2]};
            const double x = 2.0 * g[0] * p[0], y = 2.0 * g[1] * p[1], z = 2.0 * g[2] * p[2];
            I[0][0] += y + z;
            I[1][1] += x + z;
            I[2][2] += x + y;
            I[0][1] -= g[0] * p[1] + g[1] * p[0];
            I[0][2] -= g[0] * p[2] + g[2] * p[0];
            I[1][2] -= g[1] * p[2] + g[2] * p[1];
#pragma GCC unroll 3
            for (int r = 0; r < 3; ++r) {
                h[r] += mass * p[r];
            }
        }
    }
}

int NAME(mass_matrix)(const double *restrict q, double *restrict M)
{
    double sine[COUNT], cosine[COUNT];
    NAME(sines)(q, sine, cosine);
    NAME(inertia)(sine, cosine, M);
    return 0;
}

/* M a = u - h by L^T D L from the last joint, whose rows are the shortest. */
int NAME(forward_dynamics)(
    const double *restrict q, const double *restrict v, const double *restrict u, double *restrict a)
{
    double sine[COUNT], cosine[COUNT], M[COUNT * COUNT], h[COUNT], over[COUNT];
    const double still[COUNT] = {0.0};
    NAME(sines)(q, sine, cosine);
    NAME(forces)(sine, cosine, v, still, h);
    NAME(inertia)(sine, cosine, M);
#pragma GCC unroll 8
    for (int k = COUNT - 1; k >= 0; --k) {
        h[k] = u[k] - h[k];
    }
#pragma GCC unroll 8
    for (int k = COUNT - 1; k > 0; --k) {
        over[k] = 1.0 / M[k * COUNT + k];
#pragma GCC unroll 8
        for (int i = 0; i < k; ++i) {
            const double factor = M[k * COUNT + i] * over[k];
            h[i] -= factor * h[k];
#pragma GCC unroll 8
            for (int j = 0; j <= i; ++j) {
                M[i * COUNT + j] -= factor * M[k * COUNT + j];
            }
        }
    }
    over[0] = 1.0 / M[0];
#pragma GCC unroll 8
    for (int k = 0; k < COUNT; ++k) {
        double left = h[k];
#pragma GCC unroll 8
        for (int i = 0; i < k; ++i) {
            left -= M[k * COUNT + i] * a[i];
        }
        a[k] = left * over[k];
    }
    return 0;
}

/* The flange's position, from the last link to the base. */
int NAME(forward_kinematics)(const double *restrict q, double *restrict x)
{
    double sine[COUNT], cosine[COUNT], at[3] = {FLANGE[0], FLANGE[1], FLANGE[2]};
    NAME(sines)(q, sine, cosine);
#pragma GCC unroll 8
    for (int k = COUNT - 1; k >= 0; --k) {
        NAME(turn)(LINKS[k].axis, cosine[k], sine[k], at);
#pragma GCC unroll 3
        for (int r = 0; r < 3; ++r) {
            at[r] += LINKS[k].place[r];
        }
    }
    x[0] = at[0];
    x[1] = at[1];
    x[2] = at[2];
    return 0;
}

/* Twists at O of the last link per rate: the axis and its moment, in absolute axes. */
int NAME(platform_jacobian)(const double *restrict q, double *restrict jacobian)
{
    double sine[COUNT], cosine[COUNT], R[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    double at[3] = {0.0, 0.0, 0.0}; /* R[k] is the k-th axis of the link */
    NAME(sines)(q, sine, cosine);
#pragma GCC unroll 8
    for (int k = 0; k < COUNT; ++k) {
        const int axis = LINKS[k].axis, i = axis == 2 ? 0 : 2, j = axis == 2 ? 1 : 0;
        const double *p = LINKS[k].place;
#pragma GCC unroll 3
        for (int r = 0; r < 3; ++r) {
            at[r] += R[0][r] * p[0] + R[1][r] * p[1] + R[2][r] * p[2];
        }
        const double e[3] = {LINKS[k].sign * R[axis][0], LINKS[k].sign * R[axis][1], LINKS[k].sign * R[axis][2]};
        double *column = jacobian + 6 * k;
        column[0] = e[0];
        column[1] = e[1];
        column[2] = e[2];
        column[3] = at[1] * e[2] - at[2] * e[1];
        column[4] = at[2] * e[0] - at[0] * e[2];
        column[5] = at[0] * e[1] - at[1] * e[0];
#pragma GCC unroll 3
        for (int r = 0; r < 3; ++r) {
            const double first = cosine[k] * R[i][r] + sine[k] * R[j][r];
            R[j][r] = cosine[k] * R[j][r] - sine[k] * R[i][r];
            R[i][r] = first;
        }
    }
    return 0;
}
