/* Drives of the seed, 3UPS-UPU-S with physical inertias, from the platform's pose, rates and accelerations: written
   by hand as lean as we can, one state, four legs in four lanes, and eight states side by side. No checks.

   Each leg gives the moment of its tip force about O; the first, whose upper joint is universal, also a couple. The
   platform's three equations, less the couple, are solved with the least squares of the drives. */
#include <math.h>
#include <stddef.h>

#define JOIN(a, b) a##_##b
#define TIMES(a, b) JOIN(a, b)
#define NAME(a) TIMES(a, KIND)

#define R_BASE 0.8
#define R_TIP 0.5
#define HEIGHT 0.51961524227066319
#define G 9.81
#define LEG_COSINE 0.86602540378443865
#define LEG_OFFSET 0.3
#define M1 1.42
#define M2 1.42
#define E1 0.15
#define E2 0.15
#define JX 0.0232
#define JY 0.0228
#define JZ 0.001112
#define PLATFORM_XX (6.87e-2 + 2.87 * HEIGHT * HEIGHT)
#define PLATFORM_ZZ 9.21e-2
#define PLATFORM_WEIGHT (2.87 * HEIGHT * G)

#define REAL double
#define KIND one
#define ROOT(x) sqrt(x)
#include "limb.h"
#undef REAL
#undef KIND
#undef ROOT

typedef double lanes __attribute__((vector_size(32)));
static inline lanes roots(lanes x)
{
    lanes root = x;
    for (int k = 0; k < 4; ++k) {
        root[k] = sqrt(x[k]);
    }
    return root;
}
#define REAL lanes
#define KIND four
#define ROOT(x) roots(x)
#include "limb.h"
#undef REAL
#undef KIND
#undef ROOT

/* Axes of the platform (unit vectors times r for x and y, times H for z), their velocities and accelerations. */
typedef struct {
    double x[3], y[3], z[3];
} axes;

static inline __attribute__((always_inline)) void motion(
    const double *restrict pose, const double *restrict rate, const double *restrict gain, size_t stride,
    axes *restrict at, axes *restrict v, axes *restrict a, double *restrict moment)
{
    const double e0 = pose[0], e1 = pose[stride], e2 = pose[2 * stride], e3 = pose[3 * stride];
    const double p = rate[0], q = rate[stride], r = rate[2 * stride];
    const double dp = gain[0], dq = gain[stride], dr = gain[2 * stride];
    const double t1 = 2.0 * e1, t2 = 2.0 * e2, t3 = 2.0 * e3;
    const double e11 = e1 * t1, e22 = e2 * t2, e33 = e3 * t3, e12 = e1 * t2, e13 = e1 * t3, e23 = e2 * t3;
    const double e01 = e0 * t1, e02 = e0 * t2, e03 = e0 * t3;
    const double X[3] = {1.0 - (e22 + e33), e12 + e03, e13 - e02};
    const double Y[3] = {e12 - e03, 1.0 - (e11 + e33), e23 + e01};
    const double Z[3] = {e13 + e02, e23 - e01, 1.0 - (e11 + e22)};
    const double rx = R_TIP * r, qx = R_TIP * q, px = R_TIP * p, qh = HEIGHT * q, ph = HEIGHT * p;
    const double pq = p * q, pr = p * r, qr = q * r, pp = p * p, qq = q * q, rr = r * r;
    /* second derivatives of the axes, in the axes */
    const double xx = -R_TIP * (qq + rr), xy = R_TIP * (dr + pq), xz = R_TIP * (pr - dq);
    const double yx = R_TIP * (pq - dr), yy = -R_TIP * (pp + rr), yz = R_TIP * (dp + qr);
    const double zx = HEIGHT * (dq + pr), zy = HEIGHT * (qr - dp), zz = -HEIGHT * (pp + qq);
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        at->x[k] = R_TIP * X[k];
        at->y[k] = R_TIP * Y[k];
        at->z[k] = HEIGHT * Z[k];
        v->x[k] = rx * Y[k] - qx * Z[k];
        v->y[k] = px * Z[k] - rx * X[k];
        v->z[k] = qh * X[k] - ph * Y[k];
        a->x[k] = xx * X[k] + xy * Y[k] + xz * Z[k];
        a->y[k] = yx * X[k] + yy * Y[k] + yz * Z[k];
        a->z[k] = zx * X[k] + zy * Y[k] + zz * Z[k];
    }
    const double mx = PLATFORM_XX * dp + (PLATFORM_ZZ - PLATFORM_XX) * qr - PLATFORM_WEIGHT * Y[2];
    const double my = PLATFORM_XX * dq + (PLATFORM_XX - PLATFORM_ZZ) * pr + PLATFORM_WEIGHT * X[2];
    const double mz = PLATFORM_ZZ * dr;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        moment[k] = mx * X[k] + my * Y[k] + mz * Z[k];
    }
}

/* Couple and drives: g, h as in the columns (0, g, h) of legs 1 and 3, (-g, 0, h) of legs 2 and 4; `first` is leg 1,
   C its tip, y the platform's y axis times r. */
static inline __attribute__((always_inline)) void drives(
    const double *restrict g, const double *restrict h, double cosine, double sine, double across, double along,
    double slope, double reciprocal, const double *restrict C, const double *restrict y, const double *restrict b,
    double *restrict u, size_t stride, double *restrict couple)
{
    const double pW = cosine * y[2] - sine * y[1];
    const double nz = cosine * y[1] + sine * y[2], ny = -(along * y[0] + across * pW);
    const double fx = ny * reciprocal, fy = -slope * nz * reciprocal;
    /* force fx x + fy y and moment -(ny y + nz z) on the platform */
    const double fW = -along * fx, nW = across * nz;
    const double fX = across * fx, fY = cosine * fy - sine * fW, fZ = sine * fy + cosine * fW;
    const double nX = along * nz, nY = cosine * ny - sine * nW, nZ = sine * ny + cosine * nW;
    const double kx = C[1] * fZ - C[2] * fY - nX, ky = C[2] * fX - C[0] * fZ - nY, kz = C[0] * fY - C[1] * fX - nZ;
    const double over = 1.0 / kz, ex = kx * over, ey = ky * over;
    const double x1 = -ex * h[0], x2 = -g[1] - ex * h[1], x3 = -ex * h[2], x4 = -g[3] - ex * h[3];
    const double y1 = g[0] - ey * h[0], y2 = -ey * h[1], y3 = g[2] - ey * h[2], y4 = -ey * h[3];
    const double bx = b[0] - ex * b[2], by = b[1] - ey * b[2];
    const double xx = x1 * x1 + x2 * x2 + x3 * x3 + x4 * x4, yy = y1 * y1 + y2 * y2 + y3 * y3 + y4 * y4;
    const double xy = x1 * y1 + x2 * y2 + x3 * y3 + x4 * y4;
    const double determinant = 1.0 / (xx * yy - xy * xy);
    const double p = (yy * bx - xy * by) * determinant, q = (xx * by - xy * bx) * determinant;
    u[0] = x1 * p + y1 * q;
    u[stride] = x2 * p + y2 * q;
    u[2 * stride] = x3 * p + y3 * q;
    u[3 * stride] = x4 * p + y4 * q;
    const double most = h[0] * u[0] + h[1] * u[stride] + h[2] * u[2 * stride] + h[3] * u[3 * stride];
    const double size = (b[2] - most) * over;
    couple[0] = size * fx;
    couple[1] = size * fy;
    couple[2] = size * ny;
    couple[3] = size * nz;
}

/* Coordinates, rates and accelerations of the tree; sines, then cosines of the first angles of the four legs, then those
   of the second ones, which turn the other way in local axes in legs 2 and 4. */
typedef struct {
    int given;
    const double *q, *v, *a, *sines;
} tree;

/* Drives; if the tree's coordinates are given, legs from these, and the wrenches of all joints. */
static inline __attribute__((always_inline)) void state(
    const double *restrict pose, const double *restrict rate, const double *restrict gain, double *restrict u,
    double *restrict reactions, size_t stride, tree own)
{
    axes at, v, a;
    leg_one legs[4];
    double b[3], g[4], h[4], tips[4][3], couple[4];
    motion(pose, rate, gain, stride, &at, &v, &a, b);
#define AT(m, i) own.m[(size_t)(i) * stride]
#define OWN(k, side, sign)                                                                                         \
    own_one(AT(sines, k), AT(sines, 4 + k), sign AT(sines, 8 + k), AT(sines, 12 + k), AT(q, 3 * k + 2),            \
            AT(v, 3 * k), sign AT(v, 3 * k + 1), AT(v, 3 * k + 2), AT(a, 3 * k), sign AT(a, 3 * k + 1),            \
            AT(a, 3 * k + 2), -(side 0.5))
#define LEG(k, side, axis, X, Y, sign, x_, y_)                                                                     \
    {                                                                                                              \
        const double CX = at.z[X] side at.axis[X], CY = sign(at.z[Y] side at.axis[Y]), CZ = at.z[2] side at.axis[2]; \
        const leg_one leg = own.given ? OWN(k, side, sign) : limb_one(                                             \
            CX - (0.0 side R_BASE), CY, CZ, v.z[X] side v.axis[X], sign(v.z[Y] side v.axis[Y]),                    \
            v.z[2] side v.axis[2], a.z[X] side a.axis[X], sign(a.z[Y] side a.axis[Y]), a.z[2] side a.axis[2]);     \
        const double force = (0.0 side R_BASE) * leg.across;                                                       \
        g[k] = -force * leg.cosine;                                                                                \
        h[k] = -force * leg.sine;                                                                                  \
        const double mX = CY * leg.fZ - CZ * leg.fY, mY = CZ * leg.fX - CX * leg.fZ, mZ = CX * leg.fY - CY * leg.fX; \
        b[0] += x_;                                                                                                \
        b[1] += y_;                                                                                                \
        b[2] += mZ;                                                                                                \
        legs[k] = leg;                                                                                             \
        tips[k][0] = CX;                                                                                           \
        tips[k][1] = CY;                                                                                           \
        tips[k][2] = CZ;                                                                                           \
    }
    LEG(0, -, x, 0, 1, +, mX, mY)
    LEG(1, -, y, 1, 0, -, -mY, mX)
    LEG(2, +, x, 0, 1, +, mX, mY)
    LEG(3, +, y, 1, 0, -, -mY, mX)
    drives(g, h, legs[0].cosine, legs[0].sine, legs[0].across, legs[0].along, legs[0].slope, legs[0].reciprocal,
           tips[0], at.y, b, u, stride, couple);
    if (!own.given) {
        return;
    }
    const double zero[4] = {0.0, 0.0, 0.0, 0.0};
    double hub[3] = {2.87 * a.z[0], 2.87 * a.z[1], 2.87 * (a.z[2] + G)};
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
        const double *n = k == 0 ? couple : zero;
        const wrenches_one found = joints_one(
            &legs[k], u[(size_t)k * stride], n[0], n[1], n[2], n[3], tips[k][0], tips[k][1], tips[k][2],
            k < 2 ? -R_BASE : R_BASE);
        double *to = reactions + (size_t)(18 * k) * stride;
#define PUT(from, place, X, Y, sign)                                                                               \
    to[(place + X) * stride] = found.from[0];                                                                      \
    to[(place + Y) * stride] = sign found.from[1];                                                                 \
    to[(place + 2) * stride] = found.from[2];                                                                      \
    to[(place + 3 + X) * stride] = found.from[3];                                                                  \
    to[(place + 3 + Y) * stride] = sign found.from[4];                                                             \
    to[(place + 5) * stride] = found.from[5];
        if (k == 0 || k == 2) {
            PUT(base, 0, 0, 1, +)
            PUT(slider, 6, 0, 1, +)
            PUT(tip, 12, 0, 1, +)
            hub[0] -= found.tip[0];
            hub[1] -= found.tip[1];
        } else {
            PUT(base, 0, 1, 0, -)
            PUT(slider, 6, 1, 0, -)
            PUT(tip, 12, 1, 0, -)
            hub[0] += found.tip[1];
            hub[1] -= found.tip[0];
        }
        hub[2] -= found.tip[2];
    }
#pragma GCC unroll 3
    for (size_t k = 0; k < 3; ++k) {
        reactions[(72 + k) * stride] = hub[k];
        reactions[(75 + k) * stride] = 0.0;
    }
}

static const tree platform_only = {0, NULL, NULL, NULL, NULL};

int lean_seed(const double *restrict pose, const double *restrict rate, const double *restrict gain, double *restrict u)
{
    state(pose, rate, gain, u, u, 1, platform_only);
    return 0;
}

lanes _ZGVdN4v_sin(lanes);
lanes _ZGVdN4v_cos(lanes);
static inline __attribute__((always_inline)) void sines_of(const double *restrict q, lanes *restrict found)
{
    const lanes one = {q[0], q[3], q[6], q[9]}, two = {q[1], q[4], q[7], q[10]};
    found[0] = _ZGVdN4v_sin(one);
    found[1] = _ZGVdN4v_cos(one);
    found[2] = _ZGVdN4v_sin(two);
    found[3] = _ZGVdN4v_cos(two);
}

static inline __attribute__((always_inline)) void sines_one(const double *restrict q, double *restrict all)
{
    lanes found[4];
    sines_of(q, found);
#pragma GCC unroll 16
    for (int k = 0; k < 16; ++k) {
        all[k] = found[k / 4][k % 4];
    }
}

int lean_seed_reactions(
    const double *restrict q, const double *restrict v, const double *restrict a, double *restrict u,
    double *restrict reactions)
{
    double all[16];
    sines_one(q, all);
    state(q + 12, v + 12, a + 12, u, reactions, 1, (tree){1, q, v, a, all});
    return 0;
}

static inline __attribute__((always_inline)) leg_four own_lanes(tree own, lanes side)
{
    lanes sines[4];
    sines_of(own.q, sines);
    const lanes turned = {1.0, -1.0, 1.0, -1.0};
#define THIRD(m, i) ((lanes){own.m[i], own.m[i + 3], own.m[i + 6], own.m[i + 9]})
    return own_four(sines[0], sines[1], turned * sines[2], sines[3], THIRD(q, 2), THIRD(v, 0), turned * THIRD(v, 1),
                    THIRD(v, 2), THIRD(a, 0), turned * THIRD(a, 1), THIRD(a, 2), -0.5 * side);
}

static inline __attribute__((always_inline)) void in_lanes(
    const double *restrict pose, const double *restrict rate, const double *restrict gain, double *restrict u,
    double *restrict reactions, tree own)
{
    axes at, v, a;
    double b[3], couple[4];
    motion(pose, rate, gain, 1, &at, &v, &a, b);
    const lanes side = {-1.0, -1.0, 1.0, 1.0};
#define AXIS(m, X, Y) ((lanes){m.x[X], m.y[Y], m.x[X], m.y[Y]})
#define HUB(m, X, Y) ((lanes){m.z[X], m.z[Y], m.z[X], m.z[Y]})
#define CROSS(m) ((lanes){m.z[1], -m.z[0], m.z[1], -m.z[0]} + side * (lanes){m.x[1], -m.y[0], m.x[1], -m.y[0]})
    const lanes CX = HUB(at, 0, 1) + side * AXIS(at, 0, 1), CY = CROSS(at), CZ = HUB(at, 2, 2) + side * AXIS(at, 2, 2);
    const leg_four leg = own.given ? own_lanes(own, side) : limb_four(
        CX - R_BASE * side, CY, CZ, HUB(v, 0, 1) + side * AXIS(v, 0, 1), CROSS(v), HUB(v, 2, 2) + side * AXIS(v, 2, 2),
        HUB(a, 0, 1) + side * AXIS(a, 0, 1), CROSS(a), HUB(a, 2, 2) + side * AXIS(a, 2, 2));
    const lanes arm = R_BASE * side * leg.across;
    const lanes g = -arm * leg.cosine, h = -arm * leg.sine;
    const lanes mX = CY * leg.fZ - CZ * leg.fY, mY = CZ * leg.fX - CX * leg.fZ, mZ = CX * leg.fY - CY * leg.fX;
    b[0] += (mX[0] + mX[2]) - (mY[1] + mY[3]);
    b[1] += (mY[0] + mY[2]) + (mX[1] + mX[3]);
    b[2] += (mZ[0] + mZ[1]) + (mZ[2] + mZ[3]);
    const double gs[4] = {g[0], g[1], g[2], g[3]}, hs[4] = {h[0], h[1], h[2], h[3]}, tip[3] = {CX[0], CY[0], CZ[0]};
    drives(gs, hs, leg.cosine[0], leg.sine[0], leg.across[0], leg.along[0], leg.slope[0], leg.reciprocal[0], tip, at.y,
           b, u, 1, couple);
    if (reactions == NULL) {
        return;
    }
    const lanes force = {u[0], u[1], u[2], u[3]}, kx = {couple[0]}, ky = {couple[1]}, ny = {couple[2]}, nz = {couple[3]};
    const wrenches_four found = joints_four(&leg, force, kx, ky, ny, nz, CX, CY, CZ, R_BASE * side);
    double hub[3] = {2.87 * a.z[0], 2.87 * a.z[1], 2.87 * (a.z[2] + G)};
    const size_t stride = 1;
#undef PUT
#define PUT(from, place, X, Y, sign)                                                                               \
    to[(place + X) * stride] = found.from[0][k];                                                                   \
    to[(place + Y) * stride] = sign found.from[1][k];                                                              \
    to[(place + 2) * stride] = found.from[2][k];                                                                   \
    to[(place + 3 + X) * stride] = found.from[3][k];                                                               \
    to[(place + 3 + Y) * stride] = sign found.from[4][k];                                                          \
    to[(place + 5) * stride] = found.from[5][k];
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
        double *to = reactions + 18 * k;
        if (k == 0 || k == 2) {
            PUT(base, 0, 0, 1, +)
            PUT(slider, 6, 0, 1, +)
            PUT(tip, 12, 0, 1, +)
            hub[0] -= found.tip[0][k];
            hub[1] -= found.tip[1][k];
        } else {
            PUT(base, 0, 1, 0, -)
            PUT(slider, 6, 1, 0, -)
            PUT(tip, 12, 1, 0, -)
            hub[0] += found.tip[1][k];
            hub[1] -= found.tip[0][k];
        }
        hub[2] -= found.tip[2][k];
    }
    for (int k = 0; k < 3; ++k) {
        reactions[72 + k] = hub[k];
        reactions[75 + k] = 0.0;
    }
}

int lean_seed_lanes(
    const double *restrict pose, const double *restrict rate, const double *restrict gain, double *restrict u)
{
    in_lanes(pose, rate, gain, u, NULL, platform_only);
    return 0;
}

int lean_seed_reactions_lanes(
    const double *restrict q, const double *restrict v, const double *restrict a, double *restrict u,
    double *restrict reactions)
{
    in_lanes(q + 12, v + 12, a + 12, u, reactions, (tree){1, q, v, a, NULL});
    return 0;
}

int lean_seed_batch(
    const double *restrict pose, const double *restrict rate, const double *restrict gain, double *restrict u)
{
#pragma omp simd
    for (int k = 0; k < 8; ++k) {
        state(pose + k, rate + k, gain + k, u + k, u + k, 8, platform_only);
    }
    return 0;
}

/* Sines and cosines in loops of their own: of one angle together GCC does not take them in vectors. */
double sin(double) __attribute__((simd("notinbranch")));
double cos(double) __attribute__((simd("notinbranch")));

static inline __attribute__((always_inline)) void sines_eight(const double *restrict q, double *restrict sines)
{
#pragma GCC unroll 4
    for (int leg = 0; leg < 4; ++leg) {
#pragma omp simd
        for (int k = 0; k < 8; ++k) {
            sines[8 * leg + k] = sin(q[24 * leg + k]);
            sines[8 * leg + 64 + k] = sin(q[24 * leg + 8 + k]);
        }
    }
#pragma GCC unroll 4
    for (int leg = 0; leg < 4; ++leg) {
#pragma omp simd
        for (int k = 0; k < 8; ++k) {
            sines[8 * leg + 32 + k] = cos(q[24 * leg + k]);
            sines[8 * leg + 96 + k] = cos(q[24 * leg + 8 + k]);
        }
    }
}

int lean_seed_reactions_batch(
    const double *restrict q, const double *restrict v, const double *restrict a, double *restrict u,
    double *restrict reactions)
{
    double sines[16 * 8] __attribute__((aligned(64)));
    sines_eight(q, sines);
#pragma omp simd
    for (int k = 0; k < 8; ++k) {
        state(q + 96 + k, v + 96 + k, a + 96 + k, u + k, reactions + k, 8, (tree){1, q + k, v + k, a + k, sines + k});
    }
    return 0;
}
