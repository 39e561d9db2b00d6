/* Derivatives of inverse dynamics of an arm of revolute joints by q, v and a, for the table LUMPED of COUNT links.

   Frames as in arm.h. What lies on a joint's axis moves with the link before just as well: it is lumped there, so that
   links carry no mass, no first moment along their axis and one inertia less. Links outboard of a joint are one body
   with first moment h, second moment S, P = 2 sum m r', C = 2 sum m r' r^T. A change (w, b, a) of the state of its
   frame changes the acceleration of a point by a + b x r + 2 w x r', and the wrench by

     force b x h + w x P,   moment h x a + (tr S - S) b + (tr C - C) w.

   Columns are such wrenches for a joint's own q, v and a; rows are what a joint's torque takes of changes further
   inboard. Both are carried down to the base. */
typedef struct {
    double force[3], moment[3];
} NAME(wrench);

typedef struct {
    double w[3], b[3], a[3];
} NAME(change);

static inline __attribute__((always_inline)) void NAME(add_cross)(
    const double *restrict a, const double *restrict b, double *restrict sum)
{
    sum[0] += a[1] * b[2] - a[2] * b[1];
    sum[1] += a[2] * b[0] - a[0] * b[2];
    sum[2] += a[0] * b[1] - a[1] * b[0];
}

/* sum += (tr A - A) b or, transposed, (tr A - A') b */
static inline __attribute__((always_inline)) void NAME(add_spread)(
    const double A[3][3], const double *restrict b, double *restrict sum, int transposed)
{
    const double x = A[1][1] + A[2][2], y = A[0][0] + A[2][2], z = A[0][0] + A[1][1];
    sum[0] += x * b[0] - (transposed ? A[1][0] : A[0][1]) * b[1] - (transposed ? A[2][0] : A[0][2]) * b[2];
    sum[1] += y * b[1] - (transposed ? A[0][1] : A[1][0]) * b[0] - (transposed ? A[2][1] : A[1][2]) * b[2];
    sum[2] += z * b[2] - (transposed ? A[0][2] : A[2][0]) * b[0] - (transposed ? A[1][2] : A[2][1]) * b[1];
}

int NAME(inverse_dynamics_derivatives)(
    const double *restrict q, const double *restrict v, const double *restrict a, double *restrict dq,
    double *restrict dv, double *restrict da)
{
    double sine[COUNT], cosine[COUNT];
    double w[COUNT][3], at[COUNT][3], K[COUNT][3][3], twice[COUNT][3];
    double h[COUNT][3], S[COUNT][3][3], P[COUNT][3], C[COUNT][3][3];
    NAME(wrench) body[COUNT], by_q[COUNT], by_v[COUNT], by_a[COUNT];
    NAME(change) row[COUNT];
    NAME(sines)(q, sine, cosine);
#pragma GCC unroll 8
    for (int k = 0; k < COUNT; ++k) {
        const int e = LUMPED[k].axis, i = e == 2 ? 0 : 2, j = e == 2 ? 1 : 0;
        const double *p = LUMPED[k].place, *s = LUMPED[k].second, *first = LUMPED[k].moment;
        const double rate = LUMPED[k].sign * v[k];
        double dw[3] = {0.0, 0.0, 0.0};
        if (k == 0) {
            w[k][0] = w[k][1] = w[k][2] = at[k][0] = at[k][1] = 0.0;
            at[k][2] = 9.81;
        } else {
#pragma GCC unroll 3
            for (int r = 0; r < 3; ++r) {
                w[k][r] = w[k - 1][r];
                at[k][r] = at[k - 1][r] + K[k - 1][r][0] * p[0] + K[k - 1][r][1] * p[1] + K[k - 1][r][2] * p[2];
                twice[k][r] = 0.0;
            }
            const double both[3] = {2.0 * w[k][0], 2.0 * w[k][1], 2.0 * w[k][2]};
            NAME(add_cross)(both, p, twice[k]);
            dw[0] = 0.5 * (K[k - 1][2][1] - K[k - 1][1][2]);
            dw[1] = 0.5 * (K[k - 1][0][2] - K[k - 1][2][0]);
            dw[2] = 0.5 * (K[k - 1][1][0] - K[k - 1][0][1]);
            NAME(turn)(e, cosine[k], -sine[k], w[k]);
            NAME(turn)(e, cosine[k], -sine[k], dw);
            NAME(turn)(e, cosine[k], -sine[k], at[k]);
        }
        dw[i] += rate * w[k][j];
        dw[j] -= rate * w[k][i];
        dw[e] += LUMPED[k].sign * a[k];
        w[k][e] += rate;
        const double x = w[k][0], y = w[k][1], z = w[k][2];
        const double xx = x * x, yy = y * y, zz = z * z, xy = x * y, xz = x * z, yz = y * z;
        K[k][0][0] = -(yy + zz);
        K[k][1][1] = -(xx + zz);
        K[k][2][2] = -(xx + yy);
        K[k][0][1] = xy - dw[2];
        K[k][1][0] = xy + dw[2];
        K[k][0][2] = xz + dw[1];
        K[k][2][0] = xz - dw[1];
        K[k][1][2] = yz - dw[0];
        K[k][2][1] = yz + dw[0];
        const double Ix = s[1] + s[2], Iy = s[0] + s[2], Iz = s[0] + s[1];
        double *n = body[k].moment, *f = body[k].force;
        n[0] = Ix * dw[0] + (s[1] - s[2]) * yz + s[3] * K[k][2][0] - s[4] * K[k][1][0] + s[5] * (zz - yy);
        n[1] = Iy * dw[1] + (s[2] - s[0]) * xz + s[5] * K[k][0][1] - s[3] * K[k][2][1] + s[4] * (xx - zz);
        n[2] = Iz * dw[2] + (s[0] - s[1]) * xy + s[4] * K[k][1][2] - s[5] * K[k][0][2] + s[3] * (yy - xx);
        NAME(add_cross)(first, at[k], n);
        S[k][0][0] = s[0];
        S[k][1][1] = s[1];
        S[k][2][2] = s[2];
        S[k][0][1] = S[k][1][0] = s[3];
        S[k][0][2] = S[k][2][0] = s[4];
        S[k][1][2] = S[k][2][1] = s[5];
        const double both[3] = {2.0 * x, 2.0 * y, 2.0 * z};
#pragma GCC unroll 3
        for (int r = 0; r < 3; ++r) {
            f[r] = K[k][r][0] * first[0] + K[k][r][1] * first[1] + K[k][r][2] * first[2];
            h[k][r] = first[r];
            P[k][r] = 0.0;
            C[k][0][r] = both[1] * S[k][2][r] - both[2] * S[k][1][r];
            C[k][1][r] = both[2] * S[k][0][r] - both[0] * S[k][2][r];
            C[k][2][r] = both[0] * S[k][1][r] - both[1] * S[k][0][r];
        }
        NAME(add_cross)(both, first, P[k]);
    }
#pragma GCC unroll 8
    for (int k = COUNT - 1; k >= 0; --k) {
        const int e = LUMPED[k].axis, i = e == 2 ? 0 : 2, j = e == 2 ? 1 : 0;
        const double c = cosine[k], s = sine[k], *p = LUMPED[k].place;
        double unit[3] = {0.0, 0.0, 0.0}, turned[3] = {0.0, 0.0, 0.0}, sideways[3] = {0.0, 0.0, 0.0};
        unit[e] = 1.0;
        turned[i] = w[k][j];
        turned[j] = -w[k][i];
        sideways[i] = at[k][j];
        sideways[j] = -at[k][i];
        const double faster[3] = {2.0 * turned[0], 2.0 * turned[1], 2.0 * turned[2]};
        const double column[3] = {K[k][0][e], K[k][1][e], K[k][2][e]};
        by_q[k] = by_v[k] = by_a[k] = (NAME(wrench)){{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        row[k] = (NAME(change)){{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        NAME(add_cross)(unit, h[k], row[k].a);
        NAME(add_spread)(S[k], unit, row[k].b, 0);
        NAME(add_spread)(C[k], unit, row[k].w, 1);
        NAME(add_cross)(faster, h[k], by_v[k].force);
        NAME(add_cross)(unit, P[k], by_v[k].force);
        NAME(add_spread)(S[k], faster, by_v[k].moment, 0);
        NAME(add_spread)(C[k], unit, by_v[k].moment, 0);
        NAME(add_cross)(column, h[k], by_q[k].force);
        NAME(add_cross)(turned, P[k], by_q[k].force);
        NAME(add_cross)(h[k], sideways, by_q[k].moment);
        NAME(add_spread)(S[k], column, by_q[k].moment, 0);
        NAME(add_spread)(C[k], turned, by_q[k].moment, 0);
        NAME(add_cross)(unit, body[k].force, by_q[k].force);
        NAME(add_cross)(unit, body[k].moment, by_q[k].moment);
#pragma GCC unroll 8
        for (int l = COUNT - 1; l >= k; --l) {
            const double sign = LUMPED[k].sign * LUMPED[l].sign, *W = row[l].w, *b = row[l].b, *o = row[l].a;
            dq[l * COUNT + k] = sign * by_q[l].moment[e];
            dv[l * COUNT + k] = sign * by_v[l].moment[e];
            da[l * COUNT + k] = da[k * COUNT + l] = sign * b[e];
            if (l > k) {
                dq[k * COUNT + l] = sign * (turned[i] * W[i] + turned[j] * W[j] + sideways[i] * o[i] +
                    sideways[j] * o[j] + column[0] * b[0] + column[1] * b[1] + column[2] * b[2]);
                dv[k * COUNT + l] = sign * (W[e] + faster[i] * b[i] + faster[j] * b[j]);
            }
            if (k > 0) {
                NAME(turn)(e, c, s, by_q[l].force);
                NAME(turn)(e, c, s, by_q[l].moment);
                NAME(turn)(e, c, s, by_v[l].force);
                NAME(turn)(e, c, s, by_v[l].moment);
                NAME(turn)(e, c, s, row[l].w);
                NAME(turn)(e, c, s, row[l].b);
                NAME(turn)(e, c, s, row[l].a);
                NAME(add_cross)(p, by_q[l].force, by_q[l].moment);
                NAME(add_cross)(p, by_v[l].force, by_v[l].moment);
                NAME(add_cross)(p, row[l].a, row[l].b);
                NAME(add_cross)(twice[k], row[l].a, row[l].w);
            }
        }
        if (k > 0) {
            NAME(turn)(e, c, s, h[k]);
            NAME(turn)(e, c, s, P[k]);
            NAME(turn)(e, c, s, body[k].force);
            NAME(turn)(e, c, s, body[k].moment);
            NAME(add_cross)(p, body[k].force, body[k].moment);
            double (*T)[3] = S[k];
            const double t = c * T[i][i] - s * T[i][j], d = c * T[i][j] - s * T[j][j];
            const double ii = c * t - s * d, ij = s * t + c * d, jj = T[i][i] + T[j][j] - ii;
            const double ie = c * T[i][e] - s * T[j][e], je = s * T[i][e] + c * T[j][e];
            T[i][i] = ii;
            T[j][j] = jj;
            T[i][j] = T[j][i] = ij;
            T[i][e] = T[e][i] = ie;
            T[j][e] = T[e][j] = je;
            const double trace = C[k][i][i] + C[k][j][j];
#pragma GCC unroll 3
            for (int r = 0; r < 3; ++r) {
                NAME(turn)(e, c, s, C[k][r]);
            }
#pragma GCC unroll 3
            for (int r = 0; r < 3; ++r) {
                const double first = c * C[k][i][r] - s * C[k][j][r];
                C[k][j][r] = s * C[k][i][r] + c * C[k][j][r];
                C[k][i][r] = first;
            }
            C[k][j][j] = trace - C[k][i][i];
#pragma GCC unroll 3
            for (int r = 0; r < 3; ++r) {
                h[k - 1][r] += h[k][r];
                P[k - 1][r] += P[k][r];
                body[k - 1].force[r] += body[k].force[r];
                body[k - 1].moment[r] += body[k].moment[r];
#pragma GCC unroll 3
                for (int g = 0; g < 3; ++g) {
                    S[k - 1][r][g] += T[r][g] + (p[r] * h[k][g] + h[k][r] * p[g]);
                    C[k - 1][r][g] += C[k][r][g] + P[k][r] * p[g] + twice[k][r] * h[k][g];
                }
            }
        }
    }
    return 0;
}
