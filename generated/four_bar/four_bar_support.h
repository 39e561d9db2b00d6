/*
 * four_bar: what its sources share.
 * Generated with four_bar.h, which says of what; do not edit.
 */
#ifndef FOUR_BAR_SUPPORT_H
#define FOUR_BAR_SUPPORT_H

#include "four_bar.h"

#include <math.h>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "compile without -ffinite-math-only and -ffast-math: the checks for NaN would vanish"
#endif

/* Vectors that GCC makes of scalar code here cost more than they save; no comparison here traps. The other passes
   find nothing in straight lines, where values are shared already, and take a fifth of the time of compiling. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#pragma GCC optimize("no-tree-slp-vectorize,no-trapping-math")
#pragma GCC optimize("no-gcse,no-tree-pre,no-code-hoisting,no-cse-follow-jumps")
#pragma GCC optimize("no-rerun-cse-after-loop,no-dse")
#endif
#if defined(__GNUC__)
#define FOUR_BAR_INLINE __attribute__((always_inline))
#define FOUR_BAR_UNUSED __attribute__((unused))
#else
#define FOUR_BAR_INLINE
#define FOUR_BAR_UNUSED
#endif

FOUR_BAR_UNUSED static inline void four_bar_set_nan(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = (double)NAN;
    }
}

FOUR_BAR_UNUSED static inline void four_bar_zero(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = 0.0;
    }
}

/* Of 4 angles the sines of the first ones, and the cosines; FOUR_BAR_SCALAR takes both of each, one by one. */
#if defined(__GNUC__) && defined(__GLIBC__) && defined(__x86_64__) && defined(__AVX2__) && !defined(FOUR_BAR_SCALAR)
typedef double four_bar_lanes __attribute__((vector_size(32)));
four_bar_lanes _ZGVdN4v_sin(four_bar_lanes);
four_bar_lanes _ZGVdN4v_cos(four_bar_lanes);
FOUR_BAR_UNUSED static inline FOUR_BAR_INLINE void four_bar_sincos(int sines, int cosines, const double *angle,
    double *sine, double *cosine)
{
    if (sines < 2 && cosines < 2) {
        if (sines > 0) {
            sine[0] = sin(angle[0]);
        }
        if (cosines > 0) {
            cosine[0] = cos(angle[0]);
        }
        return;
    }
    const four_bar_lanes all = {angle[0], angle[1], angle[2], angle[3]};
    if (sines > 0) {
        const four_bar_lanes s = _ZGVdN4v_sin(all);
        for (int k = 0; k < sines; ++k) {
            sine[k] = s[k];
        }
    }
    if (cosines > 0) {
        const four_bar_lanes c = _ZGVdN4v_cos(all);
        for (int k = 0; k < cosines; ++k) {
            cosine[k] = c[k];
        }
    }
}
#else
FOUR_BAR_UNUSED static inline FOUR_BAR_INLINE void four_bar_sincos(int sines, int cosines, const double *angle,
    double *sine, double *cosine)
{
    const int count = sines > cosines ? sines : cosines;
    for (int k = 0; k < count; ++k) {
        sine[k] = sin(angle[k]);
        cosine[k] = cos(angle[k]);
    }
}
#endif

/* Of the second path of functions, in the support's source. */
void four_bar_orthogonalise(int rows, int columns, double *a, double *v);
double four_bar_dot(int size, const double *x, const double *y);
int four_bar_cholesky(int size, double *matrix, double *right);
int four_bar_constrained(int n, int m, const double *mass, const double *force, double *jacobian,
                             const double *bias, double *v, double *work, double *a, double *multipliers);
void four_bar_internal_load(int n, int m, const double *jacobian, int found, double *loads);

/* Names of values: part, quantity, component: limb1_lower_omega_x. Components of screws: fx ... mz of wrenches, wx
   ... vz of twists, px ... Lz of momenta. Quantities: omega, alpha; U = [alpha]x + [omega]x^2; vel, acc of a link's
   origin; rate, of the momentum screw; force_x ... moment_z, what a link and all that hangs on it need; sent, what
   it transmits; still: at joint accelerations zero; by: what a coefficient belongs to; minus_: the opposite; t1, t2
   ...: the theory has no name for it. Vectors of equal limbs: limb_lower_omega_x; signed_: each lane up to its
   sign; each_limb1_: what corresponds to that of limb1 in every limb; lanes_1 ...: no name. */
/* Constants: numbers of the description, and what was folded of them. */
FOUR_BAR_UNUSED static const double
    B_at_z = 0.15, /* [m] point, absolute axes, of B, also offset_x of coupler: 3/20 */
    D_at_x = 0.64, /* [m] point, absolute axes, of D, also offset_x of rocker: 16/25 */
    coupler_Iyy = 0.025, /* [kg m^2] inertia, absolute axes, of coupler: 1/40 */
    coupler_com_x = 0.2, /* [m] centre of mass, absolute axes, of coupler, also at_x of coupler_middle: 1/5 */
    coupler_phase = 0.9272952180016122, /* [rad] what is added to the coordinate of coupler: atan2(C_at_x /
        crank_m, k11 / crank_m) */
    coupler_sxx = 0.1, /* [kg m^2] second moment (sum of m r r), link axes, of coupler */
    crank_Ixx = 0.0009375, /* [kg m^2] inertia, absolute axes, of crank, also Iyy of crank: 3/3200 */
    crank_com_z = 0.075, /* [m] centre of mass, absolute axes, of crank: 3/40 */
    crank_m_gravity_z = 4.905, /* [m/s^2] 0.5 * gravity_z; also [N] crank_m * gravity_z */
    crank_mx = 0.0375, /* [kg m] first moment, link axes, of crank: crank_m * crank_com_z */
    gravity_z = 9.81, /* [m/s^2] acceleration of the effect of gravity: 981/100 */
    gravity_z_crank_mx = 0.367875, /* [N m] gravity_z * crank_mx */
    gravity_z_rocker_mx = 3.00186, /* [N m] gravity_z * rocker_mx */
    per_length = 3.3146717314850727, /* [1/m] 1 over the characteristic length */
    per_length_B_at_z = 0.4972007597227609, /* [1] per_length * B_at_z */
    per_length_crank_m = 1.6573358657425363, /* [1/m] per_length * 0.5; also [kg/m] per_length * crank_m */
    per_length_squared = 10.987048687506249, /* [1/m^2] 1 over the square of the characteristic length */
    rocker_Iyy = 0.02601, /* [kg m^2] inertia, absolute axes, of rocker: 2601/100000 */
    rocker_com_z = 0.225, /* [m] centre of mass, absolute axes, of rocker: 9/40 */
    rocker_m = 1.2, /* [kg] mass of rocker, coupler: 6/5 */
    rocker_m_gravity_z = 11.772, /* [N] rocker_m * gravity_z */
    rocker_mx = 0.306, /* [kg m] first moment, link axes, of rocker: rocker_m * (0.47058823529411764 * 0.12 +
        0.8823529411764706 * rocker_com_z) */
    rocker_phase = 0.4899573262537283, /* [rad] what is added to the coordinate of rocker: -atan2((C_at_x -
        D_at_x) / 0.51, C_at_z / 0.51) */
    rocker_sxx = 0.10404, /* [kg m^2] second moment (sum of m r r), link axes, of rocker: rocker_Iyy + rocker_mx
        * (0.05647058823529412 + 0.19852941176470587) */
    k1 = 0.8, /* [m/kg] C_at_x / crank_m; also [m] 2 * C_at_x */
    k2 = 0.6, /* k11 / crank_m */
    k3 = 0.47058823529411764, /* [1] (D_at_x - C_at_x) / sqrt(0.2601) */
    k4 = 0.8823529411764706, /* [1] C_at_z / sqrt(0.2601) */
    k5 = 0.25, /* [m^2] C_at_x * C_at_x + k11 * k11 */
    k6 = 0.51, /* [m] sqrt(0.24 * 0.24 + C_at_z * C_at_z) */
    k7 = 0.12, /* [m] D_at_x - rocker_com_x */
    k8 = 0.03075, /* [kg m^2] crank_sxx + 0.6 * k11 * B_at_z */
    k9 = 0.09, /* k11 * k11 */
    k10 = 0.18, /* k11 / crank_m * k11 */
    k11 = 0.3, /* [m] centre of mass, absolute axes, of coupler, also at_z of coupler_middle: 3/10; also [kg m]
        first moment, link axes, of coupler */
    k12 = 0.13075, /* [kg m^2] coupler_sxx + 0.03075 */
    k13 = 0.045, /* B_at_z * k11 */
    k14 = 2.133675, /* 0.2175 * gravity_z */
    k15 = 1.690482583057387, /* [1] per_length * sqrt(0.0576 + 0.2025) */
    k16 = 0.2725, /* [m^2] B_at_z * B_at_z + C_at_x * C_at_x + k11 * k11 */
    k17 = 3.3333333333333335, /* [1/m] crank_com_z / (B_at_z * B_at_z) */
    k18 = 0.005625, /* [m^4] B_at_z * B_at_z * (C_at_x * C_at_x + k11 * k11) */
    k19 = 6.666666666666667, /* [1/m] 1 / B_at_z */
    k20 = 8.0, /* k11 / crank_m * 44.44444444444444 * crank_com_z / 0.25 */
    k21 = 5.333333333333333, /* [1/kg] C_at_x / crank_m / B_at_z; also [1] 2 * C_at_x / B_at_z */
    k22 = 10.666666666666666, /* [1/(kg m^2)] C_at_x / crank_m * 44.44444444444444 * crank_com_z / 0.25; also
        [1/m^2] 2 * C_at_x * 44.44444444444444 * crank_com_z / 0.25; also [1/kg] C_at_x / crank_m * 4 *
        44.44444444444444 * crank_com_z; also [1] 2 * C_at_x * 4 * 44.44444444444444 * crank_com_z */
    k23 = 13.333333333333334, /* [1/m^3] crank_com_z / 0.0225 / (0.16 + 0.09); also [1/m] 4 * crank_com_z /
        0.0225 */
    k24 = 0.2275, /* of the mechanism */
    k25 = 0.8240286515629687, /* [1/m] per_length * 0.5 * per_length * B_at_z; also [kg/m] per_length * crank_m *
        per_length * B_at_z */
    k26 = 5.4935243437531245, /* [1/m^2] per_length * 0.5 * per_length; also [kg/m^2] per_length * crank_m *
        per_length */
    k27 = 2.8016974153140937; /* [1/m] per_length * 0.5 * per_length * sqrt(0.0576 + 0.2025); also [kg/m]
        per_length * crank_m * per_length * sqrt(0.0576 + 0.2025) */
/* They are made of these, too, which no statement reads:
   C_at_x = 0.4 [m] point, absolute axes, of C: 2/5
   C_at_z = 0.45 [m] point, absolute axes, of C: 9/20
   crank_m = 0.5 [kg] mass of crank; also [m] sqrt(C_at_x * C_at_x + k11 * k11)
   crank_sxx = 0.00375 [kg m^2] second moment (sum of m r r), link axes, of crank: crank_Ixx + crank_mx *
       crank_com_z
   rocker_com_x = 0.52 [m] centre of mass, absolute axes, of rocker: 13/25 */

static inline FOUR_BAR_INLINE void four_bar_angles0(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = coupler_phase + q[stride];
    const double angle1 = rocker_phase - q[2 * stride];
    angle[0] = q[0];
    angle[pitch] = angle0;
    angle[2 * pitch] = angle1;
}

static inline FOUR_BAR_INLINE void four_bar_sines1(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    four_bar_angles0(1, 1, q, angle);
    angle[3] = angle[2];
    four_bar_sincos(3, 3, angle, sine, cosine);
}

static inline FOUR_BAR_INLINE void four_bar_angles2(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    angle[0] = q[0];
}

static inline FOUR_BAR_INLINE void four_bar_sines3(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    four_bar_angles2(1, 1, q, angle);
    angle[1] = angle[0];
    angle[2] = angle[0];
    angle[3] = angle[0];
    four_bar_sincos(1, 1, angle, sine, cosine);
}

static inline FOUR_BAR_INLINE void four_bar_angles4(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = coupler_phase + q[stride];
    angle[0] = q[0];
    angle[pitch] = angle0;
}

static inline FOUR_BAR_INLINE void four_bar_sines5(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    four_bar_angles4(1, 1, q, angle);
    angle[2] = angle[1];
    angle[3] = angle[1];
    four_bar_sincos(2, 2, angle, sine, cosine);
}

static inline FOUR_BAR_INLINE void four_bar_sines6(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    four_bar_angles0(1, 1, q, angle);
    angle[3] = angle[2];
    four_bar_sincos(2, 3, angle, sine, cosine);
}

static inline FOUR_BAR_INLINE void four_bar_angles7(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = coupler_phase + q[stride];
    angle[0] = angle0;
}

static inline FOUR_BAR_INLINE void four_bar_sines8(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    four_bar_angles7(1, 1, q, angle);
    angle[1] = angle[0];
    angle[2] = angle[0];
    angle[3] = angle[0];
    four_bar_sincos(0, 1, angle, sine, cosine);
}

static inline FOUR_BAR_INLINE void four_bar_sines9(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    four_bar_angles0(1, 1, q, angle);
    angle[3] = angle[2];
    four_bar_sincos(3, 2, angle, sine, cosine);
}

static inline FOUR_BAR_INLINE void four_bar_angles10(size_t stride, size_t pitch, const double *restrict pose,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = rocker_phase - pose[0];
    angle[0] = angle0;
}

static inline FOUR_BAR_INLINE void four_bar_sines11(const double *restrict pose, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    four_bar_angles10(1, 1, pose, angle);
    angle[1] = angle[0];
    angle[2] = angle[0];
    angle[3] = angle[0];
    four_bar_sincos(1, 1, angle, sine, cosine);
}

static inline FOUR_BAR_INLINE void four_bar_sines12(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    four_bar_angles7(1, 1, q, angle);
    angle[1] = angle[0];
    angle[2] = angle[0];
    angle[3] = angle[0];
    four_bar_sincos(1, 0, angle, sine, cosine);
}

/* Bodies of functions are written once. Here they take one state ... */
#define BODY(function) static inline FOUR_BAR_INLINE int function##_body
#define REAL double
#define READ(array, k) ((array)[k])
#define SINES(array, k) ((array)[k])
#define WRITE(array, k, x) ((array)[k] = (x))
#define CONSTANT(x) (x)
#define SQRT(x) sqrt(x)
#define ABS(x) fabs(x)
#define LESS(a, b) ((a) < (b) ? 1.0 : 0.0)
#define SELECT(condition, a, b) ((condition) != 0.0 ? (a) : (b))
#define FOURS four_bar_four
#define FOUR(array, k) FOUR_BAR_FOUR((array) + (k))
#define SUM_OF_FOUR(x) FOUR_BAR_SUM(x)
#define SMALL(pivot, limit) (fabs(pivot) <= (limit))
#define OR ||
#define FINITE_UNLESS(small, sum) (void)stride, (void)total; return (small) ? 1 : isfinite(sum) ? 0 : 2
#define FINITE(sum) (void)stride, (void)total; return isfinite(sum) ? 0 : 2
#define UNCHECKED() (void)stride, (void)total; return 0
#define NOT_BELOW(x, low, status) \
    if (!((x) >= (low))) { (void)stride, (void)total; return isfinite(x) ? (status) : 2; }
#define NOT_ABOVE(x, high, status) \
    if (!((x) <= (high))) { (void)stride, (void)total; return isfinite(x) ? (status) : 2; }
#define RESULT(checked, array, k, x) \
    { const REAL result_ = (x); WRITE(array, k, result_); checked = checked + result_; }

#endif /* FOUR_BAR_SUPPORT_H */
