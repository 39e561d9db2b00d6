/* Accelerations of the seed's tree from its coordinates, rates and drives: one state, four limbs in four lanes, and
   eight states side by side. The limbs are taken into the platform's inertia (swing.h), the passive couple of the first into a row of the platform's
   acceleration, and two equations remain. Nothing is checked.

   Also a step of Runge and Kutta's fourth-order method on it, and the tree's rates from those of two coordinates. */
#undef NAME
#define NAME(a) TIMES(a, KIND)

#define REAL double
#define KIND one
#include "swing.h"
#undef REAL
#undef KIND
#define REAL lanes
#define KIND four
#include "swing.h"
#undef REAL
#undef KIND

typedef struct {
    double X[3], Y[3], Z[3];       /* axes of the platform */
    double w[3], spin;             /* its angular velocity; about Z */
} platform;

static inline __attribute__((always_inline)) void turned(const double *restrict pose, platform *restrict at)
{
    const double e0 = pose[0], e1 = pose[1], e2 = pose[2], e3 = pose[3];
    const double t1 = 2.0 * e1, t2 = 2.0 * e2, t3 = 2.0 * e3;
    const double e11 = e1 * t1, e22 = e2 * t2, e33 = e3 * t3, e12 = e1 * t2, e13 = e1 * t3, e23 = e2 * t3;
    const double e01 = e0 * t1, e02 = e0 * t2, e03 = e0 * t3;
    *at = (platform){
        {1.0 - (e22 + e33), e12 + e03, e13 - e02}, {e12 - e03, 1.0 - (e11 + e33), e23 + e01},
        {e13 + e02, e23 - e01, 1.0 - (e11 + e22)}, {0.0, 0.0, 0.0}, 0.0};
}

static inline __attribute__((always_inline)) void moved(
    const double *restrict pose, const double *restrict rate, platform *restrict at)
{
    turned(pose, at);
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        at->w[k] = rate[0] * at->X[k] + rate[1] * at->Y[k] + rate[2] * at->Z[k];
    }
    at->spin = rate[2];
}

/* Row kY, kZ of the platform's angular velocity that the first limb holds at zero, from the couple (0, ny, nz) it
   passes in leg axes; y: the platform's y axis in X, y, W. */
typedef struct {
    double mu, ny, nz, height, kY, kZ;
} row;

static inline __attribute__((always_inline)) row held(
    double c, double s, double across, double along, double ratio, double turn, const double *restrict Y)
{
    row out;
    const double y = c * Y[1] + s * Y[2], W = c * Y[2] - s * Y[1];
    out.mu = across * Y[0] - along * W;
    out.ny = -(along * Y[0] + across * W);
    out.nz = y;
    out.height = along * ratio + across;
    const double ky = out.ny * (1.0 - turn), kW = y * out.height;
    out.kY = c * ky - s * kW;
    out.kZ = s * ky + c * kW;
    return out;
}

/* What the row's acceleration is: v1, v2 the rates of the first limb's angles, r the platform's rate relative to it. */
static inline __attribute__((always_inline)) double held_rate(const row *n, const swing_one *limb, double v1, double v2)
{
    const double rx = limb->wW * (limb->across * limb->ratio - limb->along), ry = limb->wy * (1.0 - limb->turn);
    const double rz = limb->wW * n->height;
    const double carried = n->nz * (v1 * limb->across * ry - v2 * rx) - n->ny * v1 * limb->wW;
    const double bent = (rx * n->mu + ry * n->nz - rz * n->ny) * rx - (rx * rx + ry * ry + rz * rz) * n->mu;
    return n->nz * (limb->along * limb->first + limb->across * v1 * v2) + n->ny * limb->second + carried + bent;
}

/* Acceleration of the platform from the limbs' inertia I (XX, XY, XZ, YY, YZ, ZZ) and moment F. */
static inline __attribute__((always_inline)) void accelerated(
    const platform *restrict at, const row *n, double rate, const double *restrict I, const double *restrict F,
    double *restrict a)
{
    const double over = 1.0 / n->kZ, e = -n->kY * over, d = rate * over, flat = PLATFORM_ZZ - PLATFORM_XX;
    const double *Z = at->Z, *w = at->w;
    const double zX = flat * Z[0], zY = flat * Z[1], spin = flat * at->spin;
    const double XX = I[0] + PLATFORM_XX + zX * Z[0], XY = I[1] + zX * Z[1], XZ = I[2] + zX * Z[2];
    const double YY = I[3] + PLATFORM_XX + zY * Z[1], YZ = I[4] + zY * Z[2];
    const double ZZ = I[5] + PLATFORM_XX + flat * Z[2] * Z[2];
    const double fX = F[0] + spin * (w[1] * Z[2] - w[2] * Z[1]) + PLATFORM_WEIGHT * Z[1] + XZ * d;
    const double fY = F[1] + spin * (w[2] * Z[0] - w[0] * Z[2]) - PLATFORM_WEIGHT * Z[0] + YZ * d;
    const double fZ = F[2] + spin * (w[0] * Z[1] - w[1] * Z[0]) + ZZ * d;
    const double xy = XY + e * XZ, half = YZ + e * ZZ, yy = YY + e * (YZ + half), f = fY + e * fZ;
    const double determinant = 1.0 / (XX * yy - xy * xy);
    a[0] = (xy * f - yy * fX) * determinant;
    a[1] = (xy * fX - XX * f) * determinant;
    a[2] = e * a[1] + d;
}

static inline __attribute__((always_inline)) void sines(
    const double *restrict q, lanes *restrict s, lanes *restrict c, lanes *restrict sine, lanes *restrict cosine)
{
    const lanes one = {q[0], q[3], q[6], q[9]}, two = {q[1], -q[4], q[7], -q[10]};
    *s = _ZGVdN4v_sin(one);
    *c = _ZGVdN4v_cos(one);
    *sine = _ZGVdN4v_sin(two);
    *cosine = _ZGVdN4v_cos(two);
}

static inline __attribute__((always_inline)) void put_platform(
    const platform *restrict at, const double *restrict w, double *restrict out)
{
    out[0] = at->X[0] * w[0] + at->X[1] * w[1] + at->X[2] * w[2];
    out[1] = at->Y[0] * w[0] + at->Y[1] * w[1] + at->Y[2] * w[2];
    out[2] = at->Z[0] * w[0] + at->Z[1] * w[1] + at->Z[2] * w[2];
}

/* One state, or one of several side by side; sines as in seed.c. */
static inline __attribute__((always_inline)) void forward(
    const double *restrict q, const double *restrict v, const double *restrict u, const double *restrict angles,
    size_t stride, double *restrict a)
{
    platform at;
#define AT_(m, i) m[(size_t)(i) * stride]
    const double pose[4] = {AT_(q, 12), AT_(q, 13), AT_(q, 14), AT_(q, 15)};
    const double rate[3] = {AT_(v, 12), AT_(v, 13), AT_(v, 14)};
    moved(pose, rate, &at);
    const double *w = at.w;
#define SWUNG(k, side, sign, wY)                                                                                   \
    swung_one(AT_(angles, k), AT_(angles, 4 + k), sign AT_(angles, 8 + k), AT_(angles, 12 + k), AT_(q, 3 * k + 2), \
              AT_(v, 3 * k), sign AT_(v, 3 * k + 1), AT_(v, 3 * k + 2), AT_(u, k), wY, w[2], side R_BASE, -(side 0.5))
    const swing_one one = SWUNG(0, -, +, w[1]), two = SWUNG(1, -, -, -w[0]);
    const swing_one three = SWUNG(2, +, +, w[1]), four = SWUNG(3, +, -, -w[0]);
    const row n = held(one.c, one.s, one.across, one.along, one.ratio, one.turn, at.Y);
    const double I[6] = {
        one.XX + three.XX + (two.YY + four.YY), one.XY + three.XY - (two.XY + four.XY),
        one.XZ + three.XZ - (two.YZ + four.YZ), one.YY + three.YY + (two.XX + four.XX),
        one.YZ + three.YZ + (two.XZ + four.XZ), one.ZZ + three.ZZ + (two.ZZ + four.ZZ)};
    const double F[3] = {
        one.X + three.X - (two.Y + four.Y), one.Y + three.Y + (two.X + four.X), one.Z + three.Z + (two.Z + four.Z)};
    double b[3], out[3];
    accelerated(&at, &n, held_rate(&n, &one, v[0], v[stride]), I, F, b);
#define FOLLOW(limb, k, sign, wX, wY)                                                                              \
    follow_one(&limb, wX, wY, b[2], out);                                                                          \
    AT_(a, k) = out[0];                                                                                            \
    AT_(a, k + 1) = sign out[1];                                                                                   \
    AT_(a, k + 2) = out[2];
    FOLLOW(one, 0, +, b[0], b[1])
    FOLLOW(two, 3, -, b[1], -b[0])
    FOLLOW(three, 6, +, b[0], b[1])
    FOLLOW(four, 9, -, b[1], -b[0])
    put_platform(&at, b, out);
    AT_(a, 12) = out[0];
    AT_(a, 13) = out[1];
    AT_(a, 14) = out[2];
}

int lean_seed_forward(
    const double *restrict q, const double *restrict v, const double *restrict u, double *restrict a)
{
    double angles[16];
    sines_one(q, angles);
    forward(q, v, u, angles, 1, a);
    return 0;
}

int lean_seed_forward_batch(
    const double *restrict q, const double *restrict v, const double *restrict u, double *restrict a)
{
    double angles[16 * 8] __attribute__((aligned(64)));
    sines_eight(q, angles);
#pragma omp simd
    for (int k = 0; k < 8; ++k) {
        forward(q + k, v + k, u + k, angles + k, 8, a + k);
    }
    return 0;
}

int lean_seed_forward_lanes(
    const double *restrict q, const double *restrict v, const double *restrict u, double *restrict a)
{
    platform at;
    lanes s, c, sine, cosine, out[3];
    sines(q, &s, &c, &sine, &cosine);
    moved(q + 12, v + 12, &at);
    const lanes side = {-1.0, -1.0, 1.0, 1.0};
    const swing_four limb = swung_four(
        s, c, sine, cosine, (lanes){q[2], q[5], q[8], q[11]}, (lanes){v[0], v[3], v[6], v[9]},
        (lanes){v[1], -v[4], v[7], -v[10]}, (lanes){v[2], v[5], v[8], v[11]}, (lanes){u[0], u[1], u[2], u[3]},
        (lanes){at.w[1], -at.w[0], at.w[1], -at.w[0]}, (lanes){at.w[2], at.w[2], at.w[2], at.w[2]}, R_BASE * side,
        -0.5 * side);
#define ODD(m) (limb.m[0] + limb.m[2])
#define EVEN(m) (limb.m[1] + limb.m[3])
    const double I[6] = {ODD(XX) + EVEN(YY), ODD(XY) - EVEN(XY), ODD(XZ) - EVEN(YZ),
                         ODD(YY) + EVEN(XX), ODD(YZ) + EVEN(XZ), ODD(ZZ) + EVEN(ZZ)};
    const double F[3] = {ODD(X) - EVEN(Y), ODD(Y) + EVEN(X), ODD(Z) + EVEN(Z)};
    const swing_one one = {
        .across = limb.across[0], .along = limb.along[0], .ratio = limb.ratio[0], .turn = limb.turn[0],
        .wy = limb.wy[0], .wW = limb.wW[0], .first = limb.first[0], .second = limb.second[0]};
    const row n = held(limb.c[0], limb.s[0], one.across, one.along, one.ratio, one.turn, at.Y);
    double b[3];
    accelerated(&at, &n, held_rate(&n, &one, v[0], v[1]), I, F, b);
    follow_four(&limb, (lanes){b[0], b[1], b[0], b[1]}, (lanes){b[1], -b[0], b[1], -b[0]},
                (lanes){b[2], b[2], b[2], b[2]}, out);
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
        a[3 * k] = out[0][k];
        a[3 * k + 1] = k % 2 ? -out[1][k] : out[1][k];
        a[3 * k + 2] = out[2][k];
    }
    put_platform(&at, b, a + 12);
    return 0;
}

/* Angular velocity of the platform from the rates of qx and qy. */
static inline __attribute__((always_inline)) void swept(
    const double *restrict q, const double *restrict y, const row *n, double *restrict w)
{
    /* 2 d(qx) = q0 wX + (qz - e qy) wY, 2 d(qy) = -qz wX + (q0 + e qx) wY, with wZ = e wY; all times kZ */
    const double b = q[15] * n->kZ + q[14] * n->kY, d = q[12] * n->kZ - q[13] * n->kY;
    const double over = 2.0 / (q[12] * d + q[15] * b);
    w[0] = (d * y[0] - b * y[1]) * over;
    const double size = (q[12] * y[1] + q[15] * y[0]) * over;
    w[1] = n->kZ * size;
    w[2] = -n->kY * size;
}

/* Rates of the tree from those of qx and qy: the first limb's row gives the angular velocity about the vertical. */
int lean_seed_velocity(const double *restrict q, const double *restrict y, double *restrict v)
{
    platform at;
    lanes s, c, sine, cosine;
    sines(q, &s, &c, &sine, &cosine);
    turned(q + 12, &at);
    double w[3];
#define ROWS(k, side)                                                                                              \
    const double lean_##k = -(side 0.5), A_##k = side R_BASE, length_##k = q[3 * k + 2] + LEG_OFFSET;              \
    const double along_##k = lean_##k * cosine[k] + LEG_COSINE * sine[k];                                          \
    const double across_##k = LEG_COSINE * cosine[k] - lean_##k * sine[k];                                         \
    const double over_##k = 1.0 / (length_##k * across_##k);                                                       \
    const double ratio_##k = (A_##k + length_##k * along_##k) * over_##k;                                          \
    const double turn_##k = 1.0 + A_##k * along_##k * (over_##k * across_##k);
    ROWS(0, -)
    ROWS(1, -)
    ROWS(2, +)
    ROWS(3, +)
    const row n = held(c[0], s[0], across_0, along_0, ratio_0, turn_0, at.Y);
    swept(q, y, &n, w);
#define RATES(k, sign, wX, wY)                                                                                     \
    {                                                                                                              \
        const double wy = c[k] * (wY) + s[k] * w[2], wW = c[k] * w[2] - s[k] * (wY);                               \
        v[3 * k] = (wX) - ratio_##k * wW;                                                                          \
        v[3 * k + 1] = sign turn_##k * wy;                                                                         \
        v[3 * k + 2] = -A_##k * across_##k * wy;                                                                   \
    }
    RATES(0, +, w[0], w[1])
    RATES(1, -, w[1], -w[0])
    RATES(2, +, w[0], w[1])
    RATES(3, -, w[1], -w[0])
    put_platform(&at, w, v + 12);
    return 0;
}

int lean_seed_velocity_lanes(const double *restrict q, const double *restrict y, double *restrict v)
{
    platform at;
    lanes s, c, sine, cosine;
    sines(q, &s, &c, &sine, &cosine);
    turned(q + 12, &at);
    double w[3];
    const lanes side = {-1.0, -1.0, 1.0, 1.0}, lean = -0.5 * side, A = R_BASE * side;
    const lanes length = (lanes){q[2], q[5], q[8], q[11]} + LEG_OFFSET;
    const lanes along = lean * cosine + LEG_COSINE * sine, across = LEG_COSINE * cosine - lean * sine;
    const lanes over = 1.0 / (length * across), ratio = (A + length * along) * over;
    const lanes turn = 1.0 + A * along * (over * across);
    const row n = held(c[0], s[0], across[0], along[0], ratio[0], turn[0], at.Y);
    swept(q, y, &n, w);
    const lanes wX = {w[0], w[1], w[0], w[1]}, wY = {w[1], -w[0], w[1], -w[0]}, wZ = {w[2], w[2], w[2], w[2]};
    const lanes wy = c * wY + s * wZ, wW = c * wZ - s * wY;
    const lanes first = wX - ratio * wW, second = turn * wy, third = -A * across * wy;
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
        v[3 * k] = first[k];
        v[3 * k + 1] = k % 2 ? -second[k] : second[k];
        v[3 * k + 2] = third[k];
    }
    put_platform(&at, w, v + 12);
    return 0;
}

/* Twists at O of the platform per rate of the tree: its axes. */
int lean_seed_jacobian(const double *restrict q, double *restrict jacobian)
{
    platform at;
    turned(q + 12, &at);
    for (int k = 0; k < 90; ++k) {
        jacobian[k] = 0.0;
    }
    for (int k = 0; k < 3; ++k) {
        jacobian[72 + k] = at.X[k];
        jacobian[78 + k] = at.Y[k];
        jacobian[84 + k] = at.Z[k];
    }
    return 0;
}

#define JOINED(a, b) TIMES(a, b)
#define STEP lean_seed_step
#define FORWARD lean_seed_forward
#include "runge_kutta.h"
#define STEP lean_seed_step_lanes
#define FORWARD lean_seed_forward_lanes
#include "runge_kutta.h"
