/* Drives of the Stewart platform from the platform's pose, rates and accelerations, by hand; see seed.c. No checks.

   Forces of the six legs and moments about the platform's reference point: six equations, solved without choice of
   pivots in an order that fits the reference pose. */
#undef R_BASE
#undef R_TIP
#undef HEIGHT
#undef G
#undef M1
#undef M2
#undef E1
#undef E2
#undef JX
#undef JY
#undef JZ
#undef LEG
#define G 9.81
#define M1 1.0
#define M2 0.6
#define E1 0.35
#define E2 0.3
#define JX 0.035
#define JY 0.035
#define JZ 0.0

#define REAL double
#define KIND stewart
#define ROOT(x) sqrt(x)
#include "limb.h"
#undef REAL
#undef KIND
#undef ROOT

#define STEWART_MASS 5.0
#define STEWART_X 0.4
#define STEWART_Y 0.45
#define STEWART_Z 0.8

/* Base point, platform point from the centre, and first axis of the universal joint, in an order that needs no choice
   of pivots near the reference pose. */
static const double stewart_leg[6][6] = {
    {0.984807753012208, -0.17364817766693033, 0.3856725658119236, -0.4596266658713868, 0.4307634503829465, -0.9024648745597685},
    {-0.3420201433256694, -0.9396926207859082, 0.2052120859954009, -0.5638155724715451, -0.5661757822004226, 0.8242845283333537},
    {-0.3420201433256687, 0.9396926207859084, 0.20521208599540128, 0.563815572471545, 0.5661757822004232, 0.8242845283333534},
    {0.984807753012208, 0.17364817766693033, 0.3856725658119236, 0.4596266658713868, -0.4307634503829465, -0.9024648745597685},
    {-0.6427876096865394, 0.766044443118978, -0.5908846518073247, 0.10418890660015816, 0.9969392325833696, 0.07818034622641527},
    {-0.6427876096865395, -0.7660444431189779, -0.5908846518073247, -0.10418890660015828, -0.9969392325833695, 0.07818034622641545},
};
static const int stewart_place[6] = {0, 5, 2, 1, 3, 4};

int lean_stewart(
    const double *restrict pose, const double *restrict rate, const double *restrict gain, double *restrict u)
{
    const double e0 = pose[3], e1 = pose[4], e2 = pose[5], e3 = pose[6];
    const double p = rate[3], q = rate[4], r = rate[5], dp = gain[3], dq = gain[4], dr = gain[5];
    const double t1 = 2.0 * e1, t2 = 2.0 * e2, t3 = 2.0 * e3;
    const double e11 = e1 * t1, e22 = e2 * t2, e33 = e3 * t3, e12 = e1 * t2, e13 = e1 * t3, e23 = e2 * t3;
    const double e01 = e0 * t1, e02 = e0 * t2, e03 = e0 * t3;
    const double X[3] = {1.0 - (e22 + e33), e12 + e03, e13 - e02};
    const double Y[3] = {e12 - e03, 1.0 - (e11 + e33), e23 + e01};
    const double Z[3] = {e13 + e02, e23 - e01, 1.0 - (e11 + e22)};
    const double pq = p * q, pr = p * r, qr = q * r, pp = p * p, qq = q * q, rr = r * r;
    const double xx = -(qq + rr), xy = dr + pq, xz = pr - dq, yx = pq - dr, yy = -(pp + rr), yz = dp + qr;
    const double mx = STEWART_X * dp + (STEWART_Z - STEWART_Y) * qr;
    const double my = STEWART_Y * dq + (STEWART_X - STEWART_Z) * pr;
    const double mz = STEWART_Z * dr + (STEWART_Y - STEWART_X) * pq;
    double vX[3], vY[3], aX[3], aY[3], b[6];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        vX[k] = r * Y[k] - q * Z[k];
        vY[k] = p * Z[k] - r * X[k];
        aX[k] = xx * X[k] + xy * Y[k] + xz * Z[k];
        aY[k] = yx * X[k] + yy * Y[k] + yz * Z[k];
        b[k] = STEWART_MASS * gain[k];
        b[3 + k] = mx * X[k] + my * Y[k] + mz * Z[k];
    }
    b[2] += STEWART_MASS * G;
    double rows[6][7];
#pragma GCC unroll 1 /* a loop over the legs is faster than six of them */
    for (int k = 0; k < 6; ++k) {
        const double *L = stewart_leg[k];
        double C[3], d[3], v[3], a[3];
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i) {
            C[i] = L[2] * X[i] + L[3] * Y[i];
            d[i] = C[i] + (i < 2 ? pose[i] - L[i] : pose[i]);
            v[i] = rate[i] + L[2] * vX[i] + L[3] * vY[i];
            a[i] = gain[i] + L[2] * aX[i] + L[3] * aY[i];
        }
        const double x = L[4], y = L[5];
        const leg_stewart leg = limb_stewart(
            x * d[0] + y * d[1], x * d[1] - y * d[0], d[2], x * v[0] + y * v[1], x * v[1] - y * v[0], v[2],
            x * a[0] + y * a[1], x * a[1] - y * a[0], a[2]);
        const double fx = x * leg.fX - y * leg.fY, fy = y * leg.fX + x * leg.fY, fz = leg.fZ;
        b[0] += fx;
        b[1] += fy;
        b[2] += fz;
        b[3] += C[1] * fz - C[2] * fy;
        b[4] += C[2] * fx - C[0] * fz;
        b[5] += C[0] * fy - C[1] * fx;
        const double side = -leg.across * leg.sine;
        const double sx = x * leg.along - y * side, sy = y * leg.along + x * side, sz = leg.across * leg.cosine;
        rows[0][k] = sz;
        rows[1][k] = sx;
        rows[2][k] = C[1] * sz - C[2] * sy;
        rows[3][k] = C[0] * sy - C[1] * sx;
        rows[4][k] = sy;
        rows[5][k] = C[2] * sx - C[0] * sz;
    }
    rows[0][6] = b[2];
    rows[1][6] = b[0];
    rows[2][6] = b[3];
    rows[3][6] = b[5];
    rows[4][6] = b[1];
    rows[5][6] = b[4];
    double over[6];
#pragma GCC unroll 6
    for (int k = 0; k < 6; ++k) {
        over[k] = 1.0 / rows[k][k];
#pragma GCC unroll 6
        for (int i = k + 1; i < 6; ++i) {
            const double factor = rows[i][k] * over[k];
#pragma GCC unroll 7
            for (int j = k + 1; j < 7; ++j) {
                rows[i][j] -= factor * rows[k][j];
            }
        }
    }
    double solved[6];
#pragma GCC unroll 6
    for (int k = 5; k >= 0; --k) {
        double sum = rows[k][6];
#pragma GCC unroll 6
        for (int j = k + 1; j < 6; ++j) {
            sum -= rows[k][j] * solved[j];
        }
        solved[k] = sum * over[k];
        u[stewart_place[k]] = solved[k];
    }
    return 0;
}
