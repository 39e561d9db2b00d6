/*
 * three_ups_upu_s: what its sources share.
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#ifndef THREE_UPS_UPU_S_SUPPORT_H
#define THREE_UPS_UPU_S_SUPPORT_H

#include "three_ups_upu_s.h"

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
#define THREE_UPS_UPU_S_INLINE __attribute__((always_inline))
#define THREE_UPS_UPU_S_UNUSED __attribute__((unused))
#else
#define THREE_UPS_UPU_S_INLINE
#define THREE_UPS_UPU_S_UNUSED
#endif

THREE_UPS_UPU_S_UNUSED static inline void three_ups_upu_s_set_nan(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = (double)NAN;
    }
}

THREE_UPS_UPU_S_UNUSED static inline void three_ups_upu_s_zero(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = 0.0;
    }
}

/* Of 4 angles the sines of the first ones, and the cosines; THREE_UPS_UPU_S_SCALAR takes both of each, one by one. */
#if defined(__GNUC__) && defined(__GLIBC__) && defined(__x86_64__) && defined(__AVX2__) && \
    !defined(THREE_UPS_UPU_S_SCALAR)
typedef double three_ups_upu_s_lanes __attribute__((vector_size(32)));
three_ups_upu_s_lanes _ZGVdN4v_sin(three_ups_upu_s_lanes);
three_ups_upu_s_lanes _ZGVdN4v_cos(three_ups_upu_s_lanes);
THREE_UPS_UPU_S_UNUSED static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sincos(int sines, int cosines,
    const double *angle, double *sine, double *cosine)
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
    const three_ups_upu_s_lanes all = {angle[0], angle[1], angle[2], angle[3]};
    if (sines > 0) {
        const three_ups_upu_s_lanes s = _ZGVdN4v_sin(all);
        for (int k = 0; k < sines; ++k) {
            sine[k] = s[k];
        }
    }
    if (cosines > 0) {
        const three_ups_upu_s_lanes c = _ZGVdN4v_cos(all);
        for (int k = 0; k < cosines; ++k) {
            cosine[k] = c[k];
        }
    }
}
#else
THREE_UPS_UPU_S_UNUSED static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sincos(int sines, int cosines,
    const double *angle, double *sine, double *cosine)
{
    const int count = sines > cosines ? sines : cosines;
    for (int k = 0; k < count; ++k) {
        sine[k] = sin(angle[k]);
        cosine[k] = cos(angle[k]);
    }
}
#endif

#if defined(__GNUC__) && defined(__AVX__) && !defined(THREE_UPS_UPU_S_SCALAR)
typedef double three_ups_upu_s_four __attribute__((vector_size(32)));
typedef double three_ups_upu_s_four_there __attribute__((vector_size(32), aligned(8), may_alias));
#define THREE_UPS_UPU_S_FOUR(x) (*(const three_ups_upu_s_four_there *)(x))
#define THREE_UPS_UPU_S_SUM(four) (((four)[0] + (four)[1]) + ((four)[2] + (four)[3]))
#else
typedef double three_ups_upu_s_four;
#define THREE_UPS_UPU_S_FOUR(x) (((x)[0] + (x)[1]) + ((x)[2] + (x)[3]))
#define THREE_UPS_UPU_S_SUM(four) (four)
#endif

/* One value per limb. */
typedef double three_ups_upu_s_each4[4];

#if defined(__GNUC__) && defined(__AVX2__) && !defined(THREE_UPS_UPU_S_SCALAR) && !defined(THREE_UPS_UPU_S_LIMB_BY_LIMB)
typedef double three_ups_upu_s_vector4 __attribute__((vector_size(32)));
typedef long long three_ups_upu_s_vector4_mask __attribute__((vector_size(32)));
static inline three_ups_upu_s_vector4 three_ups_upu_s_vector4_sqrt(three_ups_upu_s_vector4 x)
{
    three_ups_upu_s_vector4 root = x;
    for (int k = 0; k < 4; ++k) {
        root[k] = sqrt(x[k]);
    }
    return root;
}
THREE_UPS_UPU_S_UNUSED static inline double three_ups_upu_s_vector4_sum(three_ups_upu_s_vector4 x)
{
    return (x[0] + x[1]) + (x[2] + x[3]);
}
#endif

/* Of the second path of functions, in the support's source. */
void three_ups_upu_s_orthogonalise(int rows, int columns, double *a, double *v);
double three_ups_upu_s_dot(int size, const double *x, const double *y);
int three_ups_upu_s_cholesky(int size, double *matrix, double *right);
int three_ups_upu_s_constrained(int n, int m, const double *mass, const double *force, double *jacobian,
                             const double *bias, double *v, double *work, double *a, double *multipliers);
void three_ups_upu_s_internal_load(int n, int m, const double *jacobian, int found, double *loads);

/* Names of values: part, quantity, component: limb1_lower_omega_x. Components of screws: fx ... mz of wrenches, wx
   ... vz of twists, px ... Lz of momenta. Quantities: omega, alpha; U = [alpha]x + [omega]x^2; vel, acc of a link's
   origin; rate, of the momentum screw; force_x ... moment_z, what a link and all that hangs on it need; sent, what
   it transmits; still: at joint accelerations zero; by: what a coefficient belongs to; minus_: the opposite; t1, t2
   ...: the theory has no name for it. Vectors of equal limbs: limb_lower_omega_x; signed_: each lane up to its
   sign; each_limb1_: what corresponds to that of limb1 in every limb; lanes_1 ...: no name. */
/* Constants: numbers of the description, and what was folded of them. */
THREE_UPS_UPU_S_UNUSED static const double
    gravity_z = 9.81, /* [m/s^2] acceleration of the effect of gravity: 981/100 */
    gravity_z_limb_lower_mx = 2.08953, /* [N m] gravity_z * limb_lower_mx */
    gravity_z_platform_mz = 14.62961126155784, /* [N m] gravity_z * platform_mz */
    limb_U_0_phase = 1.5707963267948966, /* [rad] what is added to the coordinate of limb2_U.0, limb4_U.0:
        atan2(1, 0) */
    limb_lower_Ixx = 0.8839, /* [kg m^2] inertia, absolute axes, of limb1_lower, limb1_upper, limb3_lower,
        limb3_upper, also Iyy of limb2_lower: 8839/10000 */
    limb_lower_Ixz = 0.478219227969767, /* [kg m^2] inertia, absolute axes, of limb1_lower, limb1_upper,
        limb3_lower, limb3_upper, also Izx of limb1_lower: 2761*sqrt(3)/10000 */
    limb_lower_Iyy = 1.14, /* [kg m^2] inertia, absolute axes, of limb1_lower, limb1_upper, limb3_lower,
        limb3_upper, also Ixx of limb2_lower: 57/50 */
    limb_lower_Izz = 0.3317, /* [kg m^2] inertia, absolute axes, of limb1_lower, limb1_upper, limb2_lower,
        limb2_upper ...: 3317/10000 */
    limb_lower_com_z = 0.12990381056766578, /* [m] centre of mass, absolute axes, of limb1_lower, limb2_lower,
        limb3_lower, limb4_lower: 3*sqrt(3)/40 */
    limb_lower_m = 1.42, /* [kg] mass of limb1_lower, limb2_lower, limb3_lower, limb4_lower ...: 71/50 */
    limb_lower_m_gravity_z = 13.9302, /* [N] limb_lower_m * gravity_z */
    limb_lower_mx = 0.213, /* [kg m] first moment, link axes, of limb1_lower, limb2_lower, limb3_lower,
        limb4_lower ...: limb_lower_m * (param_R - limb_P_at_x) */
    limb_lower_phase = 0.5235987755982989, /* [rad] what is added to the coordinate of limb1_lower, limb3_lower:
        atan2(0.5, sqrt(3)/2) */
    limb_lower_phase_2 = 2.6179938779914944, /* [rad] what is added to the coordinate of limb2_lower,
        limb4_lower: atan2(0.5, -(sqrt(3)/2)) */
    limb_upper_phase = 0.3, /* [m] what is added to the coordinate of limb1_upper, limb2_upper, limb3_upper,
        limb4_upper: 3/10 */
    param_H = 0.5196152422706631, /* [m] height of the platform's centre E above O, also com_z of platform:
        3*sqrt(3)/10 */
    param_R = 0.8, /* [m] radius of the base points A1..A4, also at_x of limb1_U: 4/5 */
    per_length = 1.5098282268426322, /* [1/m] 1 over the characteristic length */
    per_length_param_R = 1.2078625814741057, /* [1] per_length * param_R */
    platform_Ixx = 68.7, /* [kg m^2] inertia, absolute axes, of platform, also Iyy of platform: 687/10 */
    platform_Izz = 92.1, /* [kg m^2] inertia, absolute axes, of platform: 921/10 */
    platform_m = 2.87, /* [kg] mass of platform: 287/100 */
    platform_m_gravity_z = 28.1547, /* [N] platform_m * gravity_z */
    platform_mz = 1.4912957453168034, /* [kg m] first moment, link axes, of platform: platform_m * param_H */
    platform_sxx = 46.05, /* [kg m^2] second moment (sum of m r r), link axes, of platform, also syy of platform:
        (137.4 + platform_Izz) * 0.5 - platform_Ixx */
    platform_szz = 23.4249, /* [kg m^2] second moment (sum of m r r), link axes, of platform: 229.5 * 0.5 -
        platform_Izz + platform_mz * param_H */
    k1 = 0.8660254037844386, /* sqrt(3)/2 */
    k2 = 1.5, /* [1] 0.5 * 3; also [m] value_param_r * 3 */
    k3 = 0.075, /* [m] param_R - limb_lower_com_x */
    k4 = 0.1112, /* [kg m^2] 2 * limb_lower_szz + 2 * limb_lower_syy */
    k5 = 2.3083, /* [kg m^2] 2 * limb_lower_sxx */
    k6 = 0.0356, /* [kg m^2] 2 * limb_lower_syy */
    k7 = 115.5249, /* [kg m^2] platform_Izz + platform_szz */
    k8 = 0.426, /* [kg m] 2 * limb_lower_mx */
    k9 = 2.2727, /* [kg m^2] 2 * limb_lower_sxx - 2 * limb_lower_syy */
    k10 = 2.3439, /* [kg m^2] 2 * limb_lower_sxx + 2 * limb_lower_syy */
    k11 = 0.0712, /* [kg m^2] 2 * 2 * limb_lower_syy */
    k12 = 4.6166, /* [kg m^2] 2 * limb_lower_sxx - 2 * limb_lower_syy + 2 * limb_lower_sxx + 2 * limb_lower_syy */
    k13 = 22.6251, /* [kg m^2] platform_sxx - platform_szz */
    k14 = 69.4749, /* [kg m^2] platform_sxx + platform_szz */
    k15 = 0.0556, /* (0.44195 - 0.41415) * 0.5 + (0.2872606264352983 - 0.2391096139848835) * (sqrt(3)/2) */
    k16 = 0.02, /* [kg m^2] limb_lower_szz - limb_lower_syy */
    k17 = 1.19195, /* [kg m^2] limb_lower_szz + limb_lower_sxx */
    k18 = 1.11635, /* [kg m^2] limb_lower_sxx - limb_lower_szz */
    k19 = 1.17195, /* [kg m^2] limb_lower_sxx + limb_lower_syy */
    k20 = 1.13635, /* [kg m^2] limb_lower_sxx - limb_lower_syy */
    k21 = 1.136; /* [kg m] limb_lower_m * param_R */
/* They are made of these, too, which no statement reads:
   limb_P_at_x = 0.65 [m] point, absolute axes, of limb1_P, limb3_P, also at_y of limb2_P: 13/20
   limb_lower_com_x = 0.725 [m] centre of mass, absolute axes, of limb1_lower, limb3_lower, also com_y of
       limb2_lower: 29/40
   limb_lower_sxx = 1.15415 [kg m^2] second moment (sum of m r r), link axes, of limb1_lower, limb2_lower,
       limb3_lower, limb4_lower ...: 2.3556 * 0.5 - (0.0139 + 0.0417) + limb_lower_mx * (param_R - limb_P_at_x)
   limb_lower_syy = 0.0178 [kg m^2] second moment (sum of m r r), link axes, of limb1_lower, limb2_lower,
       limb3_lower, limb4_lower ...: (1.2156 + limb_lower_Iyy) * 0.5 - (1.0045894683899488 * (sqrt(3)/2) + 0.58 *
       0.5)
   limb_lower_szz = 0.0378 [kg m^2] second moment (sum of m r r), link axes, of limb1_lower, limb2_lower,
       limb3_lower, limb4_lower ...: (1.2156 + limb_lower_Iyy) * 0.5 - limb_lower_Iyy
   value_param_r = 0.5 [m] radius of the platform points C1..C4, also at_x of limb1_U2: 1/2 */

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_angles0(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = limb_lower_phase + q[stride];
    const double angle1 = limb_lower_phase_2 + q[4 * stride];
    const double angle2 = limb_lower_phase - q[7 * stride];
    const double angle3 = limb_lower_phase_2 - q[10 * stride];
    angle[0] = q[0];
    angle[pitch] = angle0;
    angle[2 * pitch] = q[3 * stride];
    angle[3 * pitch] = angle1;
    angle[4 * pitch] = q[6 * stride];
    angle[5 * pitch] = angle2;
    angle[6 * pitch] = q[9 * stride];
    angle[7 * pitch] = angle3;
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sines1(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[8] = {0.0};
    three_ups_upu_s_angles0(1, 1, q, angle);
    three_ups_upu_s_sincos(4, 4, angle, sine, cosine);
    three_ups_upu_s_sincos(4, 4, angle + 4, sine + 4, cosine + 4);
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_angles2(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = limb_lower_phase + q[stride];
    const double angle1 = limb_lower_phase_2 + q[4 * stride];
    const double angle2 = limb_lower_phase - q[7 * stride];
    const double angle3 = limb_lower_phase_2 - q[10 * stride];
    angle[0] = angle0;
    angle[pitch] = angle1;
    angle[2 * pitch] = angle2;
    angle[3 * pitch] = angle3;
    angle[4 * pitch] = q[0];
    angle[5 * pitch] = q[3 * stride];
    angle[6 * pitch] = q[6 * stride];
    angle[7 * pitch] = q[9 * stride];
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sines3(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[8] = {0.0};
    three_ups_upu_s_angles2(1, 1, q, angle);
    three_ups_upu_s_sincos(4, 4, angle, sine, cosine);
    three_ups_upu_s_sincos(0, 4, angle + 4, sine + 4, cosine + 4);
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_angles4(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = limb_lower_phase + q[stride];
    const double angle1 = limb_lower_phase_2 + q[4 * stride];
    const double angle2 = limb_lower_phase - q[7 * stride];
    const double angle3 = limb_lower_phase_2 - q[10 * stride];
    angle[0] = angle0;
    angle[pitch] = angle1;
    angle[2 * pitch] = angle2;
    angle[3 * pitch] = angle3;
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sines5(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    three_ups_upu_s_angles4(1, 1, q, angle);
    three_ups_upu_s_sincos(0, 4, angle, sine, cosine);
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_angles6(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = limb_lower_phase + q[stride];
    const double angle1 = limb_U_0_phase + q[3 * stride];
    const double angle2 = limb_lower_phase_2 + q[4 * stride];
    const double angle3 = limb_lower_phase - q[7 * stride];
    const double angle4 = limb_U_0_phase + q[9 * stride];
    const double angle5 = limb_lower_phase_2 - q[10 * stride];
    angle[0] = q[0];
    angle[pitch] = angle0;
    angle[2 * pitch] = q[3 * stride];
    angle[3 * pitch] = angle1;
    angle[4 * pitch] = angle2;
    angle[5 * pitch] = q[6 * stride];
    angle[6 * pitch] = angle3;
    angle[7 * pitch] = q[9 * stride];
    angle[8 * pitch] = angle4;
    angle[9 * pitch] = angle5;
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sines7(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[12] = {0.0};
    three_ups_upu_s_angles6(1, 1, q, angle);
    angle[10] = angle[9];
    angle[11] = angle[9];
    three_ups_upu_s_sincos(4, 4, angle, sine, cosine);
    three_ups_upu_s_sincos(4, 4, angle + 4, sine + 4, cosine + 4);
    three_ups_upu_s_sincos(2, 2, angle + 8, sine + 8, cosine + 8);
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_angles8(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = limb_lower_phase + q[stride];
    const double angle1 = limb_lower_phase_2 + q[4 * stride];
    const double angle2 = limb_lower_phase - q[7 * stride];
    const double angle3 = limb_lower_phase_2 - q[10 * stride];
    angle[0] = q[0];
    angle[pitch] = angle0;
    angle[2 * pitch] = angle1;
    angle[3 * pitch] = angle2;
    angle[4 * pitch] = angle3;
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sines9(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[8] = {0.0};
    three_ups_upu_s_angles8(1, 1, q, angle);
    angle[5] = angle[4];
    angle[6] = angle[4];
    angle[7] = angle[4];
    three_ups_upu_s_sincos(2, 4, angle, sine, cosine);
    three_ups_upu_s_sincos(0, 1, angle + 4, sine + 4, cosine + 4);
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_angles10(size_t stride, size_t pitch, const double
    *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = limb_lower_phase + q[stride];
    angle[0] = q[0];
    angle[pitch] = angle0;
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sines11(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[4] = {0.0};
    three_ups_upu_s_angles10(1, 1, q, angle);
    angle[2] = angle[1];
    angle[3] = angle[1];
    three_ups_upu_s_sincos(2, 2, angle, sine, cosine);
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_angles12(size_t stride, size_t pitch, const double
    *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = limb_lower_phase + q[stride];
    const double angle1 = limb_lower_phase_2 + q[4 * stride];
    const double angle2 = limb_lower_phase - q[7 * stride];
    const double angle3 = limb_lower_phase_2 - q[10 * stride];
    angle[0] = q[0];
    angle[pitch] = angle0;
    angle[2 * pitch] = q[3 * stride];
    angle[3 * pitch] = q[6 * stride];
    angle[4 * pitch] = q[9 * stride];
    angle[5 * pitch] = angle1;
    angle[6 * pitch] = angle2;
    angle[7 * pitch] = angle3;
}

static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sines13(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[8] = {0.0};
    three_ups_upu_s_angles12(1, 1, q, angle);
    three_ups_upu_s_sincos(4, 4, angle, sine, cosine);
    three_ups_upu_s_sincos(1, 4, angle + 4, sine + 4, cosine + 4);
}


#endif /* THREE_UPS_UPU_S_SUPPORT_H */

/* Read again where bodies are, with equal limbs side by side. */
#if !defined(THREE_UPS_UPU_S_VECTORS) || defined(THREE_UPS_UPU_S_LANES)
#undef BODY
#undef REAL
#undef READ
#undef SINES
#undef WRITE
#undef CONSTANT
#undef SQRT
#undef ABS
#undef LESS
#undef SELECT
#undef FOURS
#undef FOUR
#undef SUM_OF_FOUR
#undef SMALL
#undef OR
#undef FINITE_UNLESS
#undef FINITE
#undef UNCHECKED
#undef NOT_BELOW
#undef NOT_ABOVE
#undef RESULT
#undef STAGE
#undef LIMBS
#undef FIRST_LIMB
#undef NEXT_LIMB
#undef OWN
#undef GIVEN
#undef ALONE
#undef EACH4
#undef LIMB4
#undef NUMBER4
#undef OF4
#undef IN_EACH4
#undef WRITE4
#undef SQRT4
#undef SMALL4
#undef FINITE_UNLESS4
#undef FINITE4
#endif
#if defined(THREE_UPS_UPU_S_LANES) && THREE_UPS_UPU_S_LANES == 4
/* ... and here one state with equal limbs side by side; what fails is NaN, all bits set. */
#define BODY(function) static inline THREE_UPS_UPU_S_INLINE double function##_packed_lane
#define REAL double
#define READ(array, k) ((array)[k])
#define SINES(array, k) ((array)[k])
#define WRITE(array, k, x) ((array)[k] = (x))
#define CONSTANT(x) (x)
#define SQRT(x) sqrt(x)
#define ABS(x) fabs(x)
#define LESS(a, b) ((a) < (b) ? 1.0 : 0.0)
#define SELECT(condition, a, b) ((condition) != 0.0 ? (a) : (b))
#define FOURS three_ups_upu_s_four
#define FOUR(array, k) THREE_UPS_UPU_S_FOUR((array) + (k))
#define SUM_OF_FOUR(x) THREE_UPS_UPU_S_SUM(x)
#define SMALL(pivot, limit) ((three_ups_upu_s_vector4_mask){-(fabs(pivot) <= (limit))})
#define OR |
#define FINITE_UNLESS(small, sum) \
    (void)stride, (void)total; return (sum) + three_ups_upu_s_vector4_sum((three_ups_upu_s_vector4)(small))
#define FINITE(sum) (void)stride, (void)total; return (sum)
#define UNCHECKED() (void)stride, (void)total; return 0.0
#define NOT_BELOW(x, low, status) if (!((x) >= (low))) { return (double)NAN; }
#define NOT_ABOVE(x, high, status) if (!((x) <= (high))) { return (double)NAN; }
#define RESULT(checked, array, k, x) \
    { const REAL result_ = (x); WRITE(array, k, result_); checked = checked + result_; }
#define STAGE(function, n) static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_##function##_lanes##n
#define LIMBS(function) three_ups_upu_s_##function##_lanes
#define FIRST_LIMB(k, function, n, ...) three_ups_upu_s_##function##_lanes##n(k, __VA_ARGS__)
#define NEXT_LIMB(k, function, n, ...) (void)0
#define OWN(x) own->x
#define GIVEN(x) (x)
#define ALONE(x) (-0.0) /* adds nothing: limbs are summed together */
#define EACH4 three_ups_upu_s_vector4
#define LIMB4 three_ups_upu_s_vector4
#define NUMBER4 three_ups_upu_s_vector4
#define OF4(a, b, c, d) (three_ups_upu_s_vector4){a, b, c, d}
#define IN_EACH4(read, array, first, step) \
    (three_ups_upu_s_vector4){read(array, first), read(array, (first) + (step)), read(array, (first) + 2 * (step)), \
        read(array, (first) + 3 * (step))}
#define WRITE4(array, a, b, c, d, x) { const three_ups_upu_s_vector4 out_ = (x); WRITE(array, a, out_[0]); \
    WRITE(array, b, out_[1]); WRITE(array, c, out_[2]); WRITE(array, d, out_[3]); }
#define SQRT4(x) three_ups_upu_s_vector4_sqrt(x)
#define SMALL4(x, a, b, c, d) (((x) <= OF4(a, b, c, d)) & ((x) >= -OF4(a, b, c, d)))
#define FINITE_UNLESS4(small, sum, each) \
    (void)stride, (void)total; return (sum) + \
        three_ups_upu_s_vector4_sum((three_ups_upu_s_vector4)((three_ups_upu_s_vector4_mask)(each) | (small)))
#define FINITE4(sum, each) (void)stride, (void)total; return (sum) + three_ups_upu_s_vector4_sum(each)
#endif
#if !defined(THREE_UPS_UPU_S_VECTORS)
/* Bodies of functions are written once. Here they take one state ... */
#define BODY(function) static inline THREE_UPS_UPU_S_INLINE int function##_body
#define REAL double
#define READ(array, k) ((array)[k])
#define SINES(array, k) ((array)[k])
#define WRITE(array, k, x) ((array)[k] = (x))
#define CONSTANT(x) (x)
#define SQRT(x) sqrt(x)
#define ABS(x) fabs(x)
#define LESS(a, b) ((a) < (b) ? 1.0 : 0.0)
#define SELECT(condition, a, b) ((condition) != 0.0 ? (a) : (b))
#define FOURS three_ups_upu_s_four
#define FOUR(array, k) THREE_UPS_UPU_S_FOUR((array) + (k))
#define SUM_OF_FOUR(x) THREE_UPS_UPU_S_SUM(x)
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
/* Stages are what equal limbs do, written once: here of the limb with the number `limb`. Values have the
   names of the theory without the limb's. OWN(x): what a limb hands on; limbs.x[0]: that of the first limb;
   GIVEN(x): what each limb is given; sign1 ...: 1 or -1 by limb, where equal limbs mirror each other. */
#define STAGE(function, n) static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_##function##_limb##n
#define LIMBS(function) three_ups_upu_s_##function##_limbs
#define FIRST_LIMB(k, function, n, ...) three_ups_upu_s_##function##_limb##n(k, __VA_ARGS__)
#define NEXT_LIMB(k, function, n, ...) three_ups_upu_s_##function##_limb##n(k, __VA_ARGS__)
#define OWN(x) own->x[limb]
#define GIVEN(x) (x)[limb]
#define ALONE(x) (x)
#define EACH4 three_ups_upu_s_each4
#define LIMB4 REAL
#define NUMBER4 double
#define OF4(a, b, c, d) (limb == 0 ? (a) : limb == 1 ? (b) : limb == 2 ? (c) : (d))
#define IN_EACH4(read, array, first, step) read(array, (first) + (step) * limb)
#define WRITE4(array, a, b, c, d, x) WRITE(array, OF4(a, b, c, d), x)
#define SQRT4(x) SQRT(x)
#define SMALL4(x, a, b, c, d) (SMALL((x)[0], a) OR SMALL((x)[1], b) OR SMALL((x)[2], c) OR SMALL((x)[3], d))
#define FINITE_UNLESS4(small, sum, each) FINITE_UNLESS(small, sum)
#define FINITE4(sum, each) FINITE(sum)
#endif
