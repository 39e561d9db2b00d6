/*
 * delta: what its sources share.
 * Generated with delta.h, which says of what; do not edit.
 */
#ifndef DELTA_SUPPORT_H
#define DELTA_SUPPORT_H

#include "delta.h"

#include <math.h>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "compile without -ffinite-math-only and -ffast-math: the checks for NaN would vanish"
#endif

/* Vectors that GCC makes of scalar code here cost more than they save; no comparison here traps. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#pragma GCC optimize("no-tree-slp-vectorize,no-trapping-math")
#endif
#if defined(__GNUC__)
#define DELTA_INLINE __attribute__((always_inline))
#define DELTA_UNUSED __attribute__((unused))
#else
#define DELTA_INLINE
#define DELTA_UNUSED
#endif

DELTA_UNUSED static inline void delta_set_nan(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = (double)NAN;
    }
}

DELTA_UNUSED static inline void delta_zero(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = 0.0;
    }
}

/* Sines and cosines of the first `count` of 4 angles; DELTA_SCALAR takes them one by one. */
#if defined(__GNUC__) && defined(__GLIBC__) && defined(__x86_64__) && defined(__AVX2__) && !defined(DELTA_SCALAR)
typedef double delta_lanes __attribute__((vector_size(32)));
delta_lanes _ZGVdN4v_sin(delta_lanes);
delta_lanes _ZGVdN4v_cos(delta_lanes);
DELTA_UNUSED static inline DELTA_INLINE void delta_sincos(int count, const double *angle, double *sine, double *cosine)
{
    if (count == 1) {
        sine[0] = sin(angle[0]);
        cosine[0] = cos(angle[0]);
        return;
    }
    const delta_lanes all = {angle[0], angle[1], angle[2], angle[3]};
    const delta_lanes s = _ZGVdN4v_sin(all);
    const delta_lanes c = _ZGVdN4v_cos(all);
    for (int k = 0; k < count; ++k) {
        sine[k] = s[k];
        cosine[k] = c[k];
    }
}
#else
DELTA_UNUSED static inline DELTA_INLINE void delta_sincos(int count, const double *angle, double *sine, double *cosine)
{
    for (int k = 0; k < count; ++k) {
        sine[k] = sin(angle[k]);
        cosine[k] = cos(angle[k]);
    }
}
#endif

#if defined(__GNUC__) && defined(__AVX__) && !defined(DELTA_SCALAR)
typedef double delta_four __attribute__((vector_size(32)));
typedef double delta_four_there __attribute__((vector_size(32), aligned(8), may_alias));
#define DELTA_FOUR(x) (*(const delta_four_there *)(x))
#define DELTA_SUM(four) (((four)[0] + (four)[1]) + ((four)[2] + (four)[3]))
#else
typedef double delta_four;
#define DELTA_FOUR(x) (((x)[0] + (x)[1]) + ((x)[2] + (x)[3]))
#define DELTA_SUM(four) (four)
#endif

#if defined(__GNUC__) && defined(__AVX2__) && !defined(DELTA_SCALAR) && !defined(DELTA_LIMB_BY_LIMB)
typedef double delta_vector4 __attribute__((vector_size(32)));
typedef long long delta_vector4_mask __attribute__((vector_size(32)));
static inline delta_vector4 delta_vector4_sqrt(delta_vector4 x)
{
    delta_vector4 root = x;
    for (int k = 0; k < 4; ++k) {
        root[k] = sqrt(x[k]);
    }
    return root;
}
#endif

/* Of the second path of functions, in the support's source. */
void delta_orthogonalise(int rows, int columns, double *a, double *v);
double delta_dot(int size, const double *x, const double *y);
int delta_cholesky(int size, double *matrix, double *right);
int delta_constrained(int n, int m, const double *mass, const double *force, double *jacobian,
                             const double *bias, double *v, double *work, double *a, double *multipliers);
void delta_internal_load(int n, int m, const double *jacobian, int found, double *loads);

/* Constants: numbers of the description, and what was folded of them. */
DELTA_UNUSED static const double
    arm1_Iyy = 0.003, /* [kg m^2] inertia, absolute axes, of arm1, also Izz of arm1: 3/1000 */
    arm1_com_x = 0.35, /* [m] centre of mass, absolute axes, of arm1: 7/20 */
    arm_Ixx = 0.00225, /* [kg m^2] inertia, absolute axes, of arm2, arm3: 9/4000 */
    arm_Ixy = 0.001299038105676658, /* [kg m^2] inertia, absolute axes, of arm2, arm3, also Iyx of arm2: 3*sqrt(3)/4000 */
    arm_Iyy = 0.00075, /* [kg m^2] inertia, absolute axes, of arm2, arm3: 3/4000 */
    arm_R_at_y = 0.17320508075688773, /* [m] point, absolute axes, of arm2_R, arm3_R, also offset_y of arm2: sqrt(3)/10 */
    arm_axes_xz = 0.8660254037844386, /* [1] rotation of the axes before the motion of arm2, arm3, also axes_yx of arm2: sqrt(3)/2 */
    arm_axes_xz_arm_axes_xz = 0.75, /* (-arm_axes_xz) * (-arm_axes_xz) */
    arm_axes_xz_rod1a_U_at_x = 0.4330127018922193, /* (-arm_axes_xz) * (-0.5) */
    arm_com_x = 0.175, /* [m] centre of mass, absolute axes, of arm2, arm3: 7/40 */
    arm_com_y = 0.30310889132455354, /* [m] centre of mass, absolute axes, of arm2, arm3: 7*sqrt(3)/40 */
    arm_mx = 0.06, /* [kg m] first moment, link axes, of arm1, arm2, arm3: m_arm * (arm1_com_x - base_radius) */
    base_radius = 0.2, /* [m] radius of the driven joints, also at_x of arm1_R: 1/5 */
    gravity_z = 9.81, /* [m/s^2] acceleration of the effect of gravity: 981/100 */
    gravity_z_arm_mx = 0.5886, /* gravity_z * arm_mx */
    gravity_z_rod1a_U_at_x = 4.905, /* gravity_z * 0.5 */
    half_spacing = 0.04, /* [m] half the distance between the two rods of an arm, also com_y of rod1a: 1/25 */
    m_arm = 0.4, /* [kg] mass of an arm, also m of arm1: 2/5 */
    m_arm_arm_R_at_y = 0.06928203230275509, /* m_arm * arm_R_at_y */
    m_arm_base_radius = 0.08, /* m_arm * base_radius */
    m_arm_gravity_z = 3.924, /* m_arm * gravity_z */
    m_rod = 0.1, /* [kg] mass of a rod, also at_x of arm2_R: 1/10 */
    per_length = 2.3963575365444525, /* [1/m] 1 over the characteristic length */
    per_length_squared = 5.742529442953397, /* [1/m^2] 1 over the square of the characteristic length */
    platform_Ixx = 0.0006, /* [kg m^2] inertia, absolute axes, of platform, also Iyy of platform: 3/5000 */
    platform_Izz = 0.0011, /* [kg m^2] inertia, absolute axes, of platform: 11/10000 */
    platform_com_z = 0.5361902647381804, /* [m] centre of mass, absolute axes, of platform, also at_z of rod1a_S: sqrt(115)/20 */
    platform_radius = 0.05, /* [m] radius of the rods' ends on the platform, also at_x of rod1a_S: 1/20 */
    platform_sxx = 0.00055, /* [kg m^2] second moment (sum of m r r), link axes, of platform, also syy of platform: (0.0012 + platform_Izz) *
        0.5 - platform_Ixx */
    platform_szz = 5.0e-05, /* [kg m^2] second moment (sum of m r r), link axes, of platform: (0.0012 + platform_Izz) * 0.5 - platform_Izz */
    rod1a_Ixx = 0.002395833333333333, /* [kg m^2] inertia, absolute axes, of rod1a, rod1b: 23/9600 */
    rod1a_Ixz = 0.0020107134927681764, /* [kg m^2] inertia, absolute axes, of rod1a, rod1b, also Izx of rod1a: 3*sqrt(115)/16000 */
    rod1a_Iyy = 0.004083333333333333, /* [kg m^2] inertia, absolute axes, of rod1a, rod1b: 49/12000 */
    rod1a_com_x = 0.275, /* [m] centre of mass, absolute axes, of rod1a, rod1b: 11/40 */
    rod2a_S_at_x = 0.05964101615137755, /* [m] point, absolute axes, of rod2a_S, rod3b_S: 1/40 + sqrt(3)/50 */
    rod2a_S_at_y = 0.023301270189221932, /* [m] point, absolute axes, of rod2a_S, rod3b_S: -1/50 + sqrt(3)/40 */
    rod2a_U_at_x = 0.28464101615137755, /* [m] point, absolute axes, of rod2a_U, rod3b_U: sqrt(3)/50 + 1/4 */
    rod2a_U_at_y = 0.41301270189221934, /* [m] point, absolute axes, of rod2a_U, rod3b_U: -1/50 + sqrt(3)/4 */
    rod2a_com_x = 0.17214101615137756, /* [m] centre of mass, absolute axes, of rod2a, rod3b: sqrt(3)/50 + 11/80 */
    rod2a_com_y = 0.21815698604072062, /* [m] centre of mass, absolute axes, of rod2a, rod3b: -1/50 + 11*sqrt(3)/80 */
    rod2b_S_at_x = 0.009641016151377546, /* [m] point, absolute axes, of rod2b_S, rod3a_S: -1/40 + sqrt(3)/50 */
    rod2b_S_at_y = 0.06330127018922194, /* [m] point, absolute axes, of rod2b_S, rod3a_S: 1/50 + sqrt(3)/40 */
    rod2b_U_at_x = 0.21535898384862245, /* [m] point, absolute axes, of rod2b_U, rod3a_U: 1/4 - sqrt(3)/50 */
    rod2b_U_at_y = 0.4530127018922193, /* [m] point, absolute axes, of rod2b_U, rod3a_U: 1/50 + sqrt(3)/4 */
    rod2b_com_x = 0.10285898384862245, /* [m] centre of mass, absolute axes, of rod2b, rod3a: 11/80 - sqrt(3)/50 */
    rod2b_com_y = 0.2581569860407206, /* [m] centre of mass, absolute axes, of rod2b, rod3a: 1/50 + 11*sqrt(3)/80 */
    roda_Ixx = 0.0036614583333333334, /* [kg m^2] inertia, absolute axes, of rod2a, rod2b, rod3a, rod3b: 703/192000 */
    roda_Ixy = 0.0007307089344431202, /* [kg m^2] inertia, absolute axes, of rod2a, rod2b, rod3a, rod3b, also Iyx of rod2a: 27*sqrt(3)/64000 */
    roda_Ixz = 0.0010053567463840882, /* [kg m^2] inertia, absolute axes, of rod2a, rod2b, rod3a, rod3b, also Izx of rod2a: 3*sqrt(115)/32000 */
    roda_Iyy = 0.0028177083333333335, /* [kg m^2] inertia, absolute axes, of rod2a, rod2b, rod3a, rod3b: 541/192000 */
    roda_Iyz = 0.001741328964469379, /* [kg m^2] inertia, absolute axes, of rod2a, rod2b, rod3a, rod3b, also Izy of rod2a: 3*sqrt(345)/32000 */
    roda_Izz = 0.0016875, /* [kg m^2] inertia, absolute axes, of rod1a, rod1b, rod2a, rod2b ...: 27/16000 */
    roda_U_0_offset_x = 0.3, /* [m] offset from the parent's origin of rod1a_U.0, rod1b_U.0, rod2a_U.0, rod2b_U.0 ...: 0.5 - base_radius */
    roda_U_0_phase = 0.6982224733625599, /* [rad] what is added to the coordinate of rod1a_U.0, rod1b_U.0, rod2a_U.0, rod2b_U.0 ...: atan2(9/14,
        sqrt(115)/14) */
    roda_com_z = 0.2680951323690902, /* [m] centre of mass, absolute axes, of rod1a, rod1b, rod2a, rod2b ...: sqrt(115)/40 */
    roda_mx = 0.035, /* [kg m] first moment, link axes, of rod1a, rod1b, rod2a, rod2b ...: m_rod * arm1_com_x */
    roda_sxx = 0.01633333333333333, /* [kg m^2] second moment (sum of m r r), link axes, of rod1a, rod1b, rod2a, rod2b ...: rod1a_Iyy + roda_mx *
        arm1_com_x */
    k1 = 0.6428571428571429, /* 9/14 */
    k2 = 0.7659860924831149, /* sqrt(115)/14 */
    k3 = 0.32142857142857145, /* (-0.5) * (-9/14) */
    k4 = 0.25, /* -((-0.5) * 0.5) */
    k5 = 0.38299304624155744, /* sqrt(115)/28 */
    k6 = 0.5567306167185677, /* (-arm_axes_xz) * (-9/14) */
    k7 = 0.663363415035954, /* sqrt(345)/28 */
    k8 = 0.15, /* arm1_com_x - base_radius */
    k9 = 0.13464101615137755, /* -(-(-(half_spacing * (-arm_axes_xz))) - m_rod) */
    k10 = 0.25980762113533157, /* rod2a_U_at_y - arm_R_at_y - (half_spacing * (-0.5)) */
    k11 = 0.15320508075688774, /* -(-(half_spacing * (-0.5))) + arm_R_at_y */
    k12 = 0.06535898384862246, /* -(-(half_spacing * (-arm_axes_xz)) - m_rod) */
    k13 = 0.19320508075688772, /* -(half_spacing * (-0.5)) + arm_R_at_y */
    k14 = 0.7, /* (-9/14) * (-(-(platform_radius - 0.5))) - ((sqrt(115)/14) * (-platform_com_z)) */
    k15 = 1.4, /* ((-9/14) * (-0.45) - ((sqrt(115)/14) * (-platform_com_z))) * 2 */
    k16 = 0.49, /* (-(-(platform_radius - 0.5))) * (-(-(platform_radius - 0.5))) + (-platform_com_z) * (-platform_com_z) */
    k17 = 0.1767857142857143, /* rod1a_com_x * (9/14) */
    k18 = 0.20535714285714285, /* (-sqrt(115)/28) * (-platform_com_z) */
    k19 = 0.0015, /* -(-(-((-0.5) * arm_Ixx)) - (-((-0.5) * arm_Iyy))) */
    k20 = 0.002598076211353316, /* -(-(-((-arm_axes_xz) * arm_Ixx)) - (-((-0.5) * arm_Ixy))) */
    k21 = 0.00115, /* (2 * platform_Ixx + platform_Izz) * 0.5 */
    k22 = 0.03, /* (-(-(half_spacing * (-arm_axes_xz)))) * (-arm_axes_xz) */
    k23 = 0.07, /* 2 * roda_mx */
    k24 = 0.6, /* 0.5 + m_rod */
    k25 = 1.1772, /* (roda_U_0_offset_x * roda_U_0_offset_x + (-0.034641016151377546) * (-arm_axes_xz)) * gravity_z */
    k26 = 0.03266666666666666, /* 2 * roda_sxx */
    k27 = 0.0005, /* platform_sxx - platform_szz */
    k28 = 0.004330127018922193, /* (platform_radius - (0.008003333333333333 * 4.164931278633903)) * (rod2a_U_at_y - arm_R_at_y - (half_spacing *
        (-0.5))) */
    k29 = 0.0025, /* (platform_radius - (0.008003333333333333 * 4.164931278633903)) * (arm1_com_x - base_radius) */
    k30 = 0.00091, /* 0.0008383333333333333 + 3.0983064143707567e-06 + (-rod2a_S_at_x) * (-0.0019880338717125847) - platform_szz */
    k31 = 0.00101, /* 0.0008383333333333333 + 3.0983064143707567e-06 + (-rod2a_S_at_x) * (-0.0019880338717125847) + platform_szz */
    k32 = 0.00192, /* 2 * (0.0008383333333333333 + 3.0983064143707567e-06 + (-rod2a_S_at_x) * (-0.0019880338717125847)) */
    k33 = 0.005, /* (platform_radius - (0.008003333333333333 * 4.164931278633903)) * roda_U_0_offset_x */
    k34 = 0.01, /* (-(-(half_spacing * (-0.5)))) * (-0.5) */
    k35 = 0.03333333333333333, /* ((0.2892857142857143 + 0.4107142857142857) * roda_sxx * 0.7) * ((1 / 0.49) * (1 / 0.49)) */
    k36 = 0.008660254037844387, /* 2 * ((platform_radius - 0.03333333333333333) * (0.2398076211353316 + 0.02)) */
    k37 = 0.016666666666666666, /* platform_radius - (0.7 * 0.011433333333333334 * 2.0408163265306123 * 2.0408163265306123) */
    k38 = 0.7848, /* m_arm * base_radius * gravity_z */
    k39 = 0.018, /* (-(-((0.5 + m_rod) * (-arm_R_at_y)))) * (-arm_R_at_y) */
    k40 = 1.4285714285714286, /* 1 / ((-9/14) * (-0.45) - ((sqrt(115)/14) * (-platform_com_z))) */
    k41 = 6.867, /* ((-9/14) * (-0.45) - ((sqrt(115)/14) * (-platform_com_z))) * gravity_z */
    k42 = 0.3984, /* -(roda_U_0_offset_x * roda_U_0_offset_x + half_spacing * half_spacing - ((-0.45) * (-0.45) + (-platform_com_z)
        * (-platform_com_z))) */
    k43 = 1.6666666666666667, /* (1 / roda_U_0_offset_x) * 0.5 */
    k44 = 0.13333333333333333, /* half_spacing * (1 / roda_U_0_offset_x) */
    k45 = 0.7142857142857143, /* 1 / ((0.2892857142857143 + 0.4107142857142857) * 2) */
    k46 = 0.0823543, /* (0.2401 * 0.7 * (0.2892857142857143 + 0.4107142857142857)) * ((-9/14) * (-0.45) - ((sqrt(115)/14) *
        (-platform_com_z))) */
    k47 = 2.8138394270471645, /* (per_length * (0.2892857142857143 + 0.4107142857142857)) * (per_length * (0.2892857142857143 +
        0.4107142857142857)) */
    k48 = 0.7189072609633358; /* per_length * roda_U_0_offset_x */

static inline DELTA_INLINE void delta_angles0(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = roda_U_0_phase + q[stride];
    const double angle1 = roda_U_0_phase + q[3 * stride];
    const double angle2 = roda_U_0_phase + q[6 * stride];
    const double angle3 = roda_U_0_phase + q[8 * stride];
    const double angle4 = roda_U_0_phase + q[11 * stride];
    const double angle5 = roda_U_0_phase + q[13 * stride];
    angle[0] = q[0];
    angle[pitch] = angle0;
    angle[2 * pitch] = q[2 * stride];
    angle[3 * pitch] = angle1;
    angle[4 * pitch] = q[4 * stride];
    angle[5 * pitch] = q[5 * stride];
    angle[6 * pitch] = angle2;
    angle[7 * pitch] = q[7 * stride];
    angle[8 * pitch] = angle3;
    angle[9 * pitch] = q[9 * stride];
    angle[10 * pitch] = q[10 * stride];
    angle[11 * pitch] = angle4;
    angle[12 * pitch] = q[12 * stride];
    angle[13 * pitch] = angle5;
    angle[14 * pitch] = q[14 * stride];
}

static inline DELTA_INLINE void delta_sines1(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[16] = {0.0};
    delta_angles0(1, 1, q, angle);
    angle[15] = angle[14];
    delta_sincos(4, angle, sine, cosine);
    delta_sincos(4, angle + 4, sine + 4, cosine + 4);
    delta_sincos(4, angle + 8, sine + 8, cosine + 8);
    delta_sincos(3, angle + 12, sine + 12, cosine + 12);
}

static inline DELTA_INLINE void delta_angles2(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = roda_U_0_phase + q[stride];
    const double angle1 = roda_U_0_phase + q[3 * stride];
    const double angle2 = roda_U_0_phase + q[6 * stride];
    const double angle3 = roda_U_0_phase + q[8 * stride];
    const double angle4 = roda_U_0_phase + q[11 * stride];
    const double angle5 = roda_U_0_phase + q[13 * stride];
    angle[0] = q[0];
    angle[pitch] = angle0;
    angle[2 * pitch] = angle1;
    angle[3 * pitch] = q[5 * stride];
    angle[4 * pitch] = angle2;
    angle[5 * pitch] = angle3;
    angle[6 * pitch] = q[10 * stride];
    angle[7 * pitch] = angle4;
    angle[8 * pitch] = angle5;
}

static inline DELTA_INLINE void delta_sines3(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[12] = {0.0};
    delta_angles2(1, 1, q, angle);
    angle[9] = angle[8];
    angle[10] = angle[8];
    angle[11] = angle[8];
    delta_sincos(4, angle, sine, cosine);
    delta_sincos(4, angle + 4, sine + 4, cosine + 4);
    delta_sincos(1, angle + 8, sine + 8, cosine + 8);
}

static inline DELTA_INLINE void delta_angles4(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    angle[0] = q[0];
    angle[pitch] = q[2 * stride];
    angle[2 * pitch] = q[4 * stride];
    angle[3 * pitch] = q[5 * stride];
    angle[4 * pitch] = q[7 * stride];
    angle[5 * pitch] = q[9 * stride];
    angle[6 * pitch] = q[10 * stride];
    angle[7 * pitch] = q[12 * stride];
    angle[8 * pitch] = q[14 * stride];
}

static inline DELTA_INLINE void delta_sines5(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[12] = {0.0};
    delta_angles4(1, 1, q, angle);
    angle[9] = angle[8];
    angle[10] = angle[8];
    angle[11] = angle[8];
    delta_sincos(4, angle, sine, cosine);
    delta_sincos(4, angle + 4, sine + 4, cosine + 4);
    delta_sincos(1, angle + 8, sine + 8, cosine + 8);
}

static inline DELTA_INLINE void delta_angles6(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = roda_U_0_phase + q[stride];
    const double angle1 = roda_U_0_phase + q[3 * stride];
    const double angle2 = roda_U_0_phase + q[6 * stride];
    const double angle3 = roda_U_0_phase + q[8 * stride];
    const double angle4 = roda_U_0_phase + q[11 * stride];
    const double angle5 = roda_U_0_phase + q[13 * stride];
    angle[0] = angle0;
    angle[pitch] = q[2 * stride];
    angle[2 * pitch] = angle1;
    angle[3 * pitch] = q[4 * stride];
    angle[4 * pitch] = angle2;
    angle[5 * pitch] = q[7 * stride];
    angle[6 * pitch] = angle3;
    angle[7 * pitch] = q[9 * stride];
    angle[8 * pitch] = angle4;
    angle[9 * pitch] = q[12 * stride];
    angle[10 * pitch] = angle5;
    angle[11 * pitch] = q[14 * stride];
}

static inline DELTA_INLINE void delta_sines7(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[12] = {0.0};
    delta_angles6(1, 1, q, angle);
    delta_sincos(4, angle, sine, cosine);
    delta_sincos(4, angle + 4, sine + 4, cosine + 4);
    delta_sincos(4, angle + 8, sine + 8, cosine + 8);
}

static inline DELTA_INLINE void delta_angles8(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    angle[0] = q[0];
    angle[pitch] = q[5 * stride];
    angle[2 * pitch] = q[10 * stride];
}

static inline DELTA_INLINE void delta_sines9(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[4] = {0.0};
    delta_angles8(1, 1, q, angle);
    angle[3] = angle[2];
    delta_sincos(3, angle, sine, cosine);
}

static inline DELTA_INLINE void delta_angles10(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = roda_U_0_phase + q[stride];
    const double angle1 = roda_U_0_phase + q[6 * stride];
    const double angle2 = roda_U_0_phase + q[11 * stride];
    angle[0] = angle0;
    angle[pitch] = q[2 * stride];
    angle[2 * pitch] = q[4 * stride];
    angle[3 * pitch] = angle1;
    angle[4 * pitch] = q[7 * stride];
    angle[5 * pitch] = q[9 * stride];
    angle[6 * pitch] = angle2;
    angle[7 * pitch] = q[12 * stride];
    angle[8 * pitch] = q[14 * stride];
}

static inline DELTA_INLINE void delta_sines11(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[12] = {0.0};
    delta_angles10(1, 1, q, angle);
    angle[9] = angle[8];
    angle[10] = angle[8];
    angle[11] = angle[8];
    delta_sincos(4, angle, sine, cosine);
    delta_sincos(4, angle + 4, sine + 4, cosine + 4);
    delta_sincos(1, angle + 8, sine + 8, cosine + 8);
}

/* Bodies of functions are written once. Here they take one state ... */
#define BODY(function) static inline DELTA_INLINE int function##_body
#define REAL double
#define READ(array, k) ((array)[k])
#define SINES(array, k) ((array)[k])
#define WRITE(array, k, x) ((array)[k] = (x))
#define CONSTANT(x) (x)
#define SQRT(x) sqrt(x)
#define ABS(x) fabs(x)
#define LESS(a, b) ((a) < (b) ? 1.0 : 0.0)
#define SELECT(condition, a, b) ((condition) != 0.0 ? (a) : (b))
#define FOURS delta_four
#define FOUR(array, k) DELTA_FOUR((array) + (k))
#define SUM_OF_FOUR(x) DELTA_SUM(x)
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

#endif /* DELTA_SUPPORT_H */
