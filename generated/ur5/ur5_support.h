/*
 * ur5: what its sources share.
 * Generated with ur5.h, which says of what; do not edit.
 */
#ifndef UR5_SUPPORT_H
#define UR5_SUPPORT_H

#include "ur5.h"

#include <math.h>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "compile without -ffinite-math-only and -ffast-math: the checks for NaN would vanish"
#endif

/* Vectors that GCC makes of scalar code here cost more than they save; no comparison here traps. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#pragma GCC optimize("no-tree-slp-vectorize,no-trapping-math")
#endif
#if defined(__GNUC__)
#define UR5_INLINE __attribute__((always_inline))
#define UR5_UNUSED __attribute__((unused))
#else
#define UR5_INLINE
#define UR5_UNUSED
#endif

UR5_UNUSED static inline void ur5_set_nan(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = (double)NAN;
    }
}

UR5_UNUSED static inline void ur5_zero(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = 0.0;
    }
}

/* Sines and cosines of the first `count` of 4 angles; UR5_SCALAR takes them one by one. */
#if defined(__GNUC__) && defined(__GLIBC__) && defined(__x86_64__) && defined(__AVX2__) && !defined(UR5_SCALAR)
typedef double ur5_lanes __attribute__((vector_size(32)));
ur5_lanes _ZGVdN4v_sin(ur5_lanes);
ur5_lanes _ZGVdN4v_cos(ur5_lanes);
UR5_UNUSED static inline UR5_INLINE void ur5_sincos(int count, const double *angle, double *sine, double *cosine)
{
    if (count == 1) {
        sine[0] = sin(angle[0]);
        cosine[0] = cos(angle[0]);
        return;
    }
    const ur5_lanes all = {angle[0], angle[1], angle[2], angle[3]};
    const ur5_lanes s = _ZGVdN4v_sin(all);
    const ur5_lanes c = _ZGVdN4v_cos(all);
    for (int k = 0; k < count; ++k) {
        sine[k] = s[k];
        cosine[k] = c[k];
    }
}
#else
UR5_UNUSED static inline UR5_INLINE void ur5_sincos(int count, const double *angle, double *sine, double *cosine)
{
    for (int k = 0; k < count; ++k) {
        sine[k] = sin(angle[k]);
        cosine[k] = cos(angle[k]);
    }
}
#endif

#if defined(__GNUC__) && defined(__AVX__) && !defined(UR5_SCALAR)
typedef double ur5_four __attribute__((vector_size(32)));
typedef double ur5_four_there __attribute__((vector_size(32), aligned(8), may_alias));
#define UR5_FOUR(x) (*(const ur5_four_there *)(x))
#define UR5_SUM(four) (((four)[0] + (four)[1]) + ((four)[2] + (four)[3]))
#else
typedef double ur5_four;
#define UR5_FOUR(x) (((x)[0] + (x)[1]) + ((x)[2] + (x)[3]))
#define UR5_SUM(four) (four)
#endif

/* Constants: numbers of the description, and what was folded of them. */
UR5_UNUSED static const double
    elbow_joint_at_x = 0.425, /* [m] point, absolute axes, of elbow_joint, also offset_x of forearm_link: 17/40 */
    forearm_link_Ixx = 0.004095, /* [kg m^2] inertia, absolute axes, of forearm_link: 819/200000 */
    forearm_link_Iyy = 0.031216803515624995, /* [kg m^2] inertia, absolute axes, of forearm_link, also Izz of forearm_link:
        6243360703124999/200000000000000000 */
    forearm_link_com_x = 0.66725, /* [m] centre of mass, absolute axes, of forearm_link: 2669/4000 */
    forearm_link_com_y = 0.0265, /* [m] centre of mass, absolute axes, of forearm_link: 53/2000 */
    forearm_link_m = 2.33, /* [kg] mass of forearm_link: 233/100 */
    forearm_link_mx = 0.5644425, /* [kg m] first moment, link axes, of forearm_link: forearm_link_m * (-(-forearm_link_com_x + elbow_joint_at_x)) */
    forearm_link_mz = 0.061745, /* [kg m] first moment, link axes, of forearm_link: forearm_link_m * forearm_link_com_y */
    forearm_link_sxz = 0.01495772625, /* [kg m^2] second moment (sum of m r r), link axes, of forearm_link, also szx of forearm_link: forearm_link_mx *
        forearm_link_com_y */
    forearm_link_syy = 0.0020475, /* [kg m^2] second moment (sum of m r r), link axes, of forearm_link: (0.035311803515625 + forearm_link_Iyy) *
        0.5 - forearm_link_Iyy */
    gravity_z = 9.81, /* [m/s^2] acceleration of the effect of gravity: 981/100 */
    param_d1 = 0.089159, /* [m] Denavit-Hartenberg length d1, also com_z of upper_arm_link: 89159/1000000 */
    per_length = 2.7086104016056645, /* [1/m] 1 over the characteristic length */
    shoulder_link_Izz = 0.01040625, /* [kg m^2] inertia, absolute axes, of shoulder_link: 333/32000 */
    shoulder_link_com_y = 0.00193, /* [m] centre of mass, absolute axes, of shoulder_link: 193/100000 */
    shoulder_link_m = 3.7, /* [kg] mass of shoulder_link: 37/10 */
    shoulder_link_mx = 0.007141, /* [kg m] first moment, link axes, of shoulder_link: shoulder_link_m * shoulder_link_com_y */
    shoulder_link_mz = 0.2351313, /* [kg m] first moment, link axes, of shoulder_link: shoulder_link_com_z * shoulder_link_m */
    shoulder_link_sxz = 0.000453803409, /* [kg m^2] second moment (sum of m r r), link axes, of shoulder_link, also szx of shoulder_link:
        shoulder_link_mx * shoulder_link_com_z */
    shoulder_link_syy = 0.005203125, /* [kg m^2] second moment (sum of m r r), link axes, of shoulder_link: (0.029944716666666663 + shoulder_link_Izz)
        * 0.5 - shoulder_link_Ixx */
    upper_arm_link_Ixx = 0.0151074, /* [kg m^2] inertia, absolute axes, of upper_arm_link: 75537/5000000 */
    upper_arm_link_Iyy = 0.13388583541666665, /* [kg m^2] inertia, absolute axes, of upper_arm_link, also Izz of upper_arm_link:
        2677716708333333/20000000000000000 */
    upper_arm_link_com_x = 0.2125, /* [m] centre of mass, absolute axes, of upper_arm_link: 17/80 */
    upper_arm_link_com_y = 0.11336, /* [m] centre of mass, absolute axes, of upper_arm_link: 1417/12500 */
    upper_arm_link_m = 8.393, /* [kg] mass of upper_arm_link: 8393/1000 */
    upper_arm_link_mx = 1.7835125, /* [kg m] first moment, link axes, of upper_arm_link: upper_arm_link_m * upper_arm_link_com_x */
    upper_arm_link_mz = 0.95143048, /* [kg m] first moment, link axes, of upper_arm_link: upper_arm_link_m * upper_arm_link_com_y */
    upper_arm_link_sxz = 0.202178977, /* [kg m^2] second moment (sum of m r r), link axes, of upper_arm_link, also szx of upper_arm_link:
        upper_arm_link_mx * upper_arm_link_com_y */
    upper_arm_link_syy = 0.0075537, /* [kg m^2] second moment (sum of m r r), link axes, of upper_arm_link: (0.14899323541666665 +
        upper_arm_link_Iyy) * 0.5 - upper_arm_link_Iyy */
    wrist_1_link_Ixx = 0.002013889583333333, /* [kg m^2] inertia, absolute axes, of wrist_1_link, also Izz of wrist_1_link:
        2013889583333333/1000000000000000000 */
    wrist_1_link_Iyy = 0.0021942, /* [kg m^2] inertia, absolute axes, of wrist_1_link, also Izz of wrist_2_link: 10971/5000000 */
    wrist_1_link_com_x = 0.81725, /* [m] centre of mass, absolute axes, of wrist_1_link, wrist_2_link, wrist_3_link, also at_x of wrist_1_joint:
        3269/4000 */
    wrist_1_link_com_y = 0.10735, /* [m] centre of mass, absolute axes, of wrist_1_link: 2147/20000 */
    wrist_1_link_com_z = 0.072819, /* [m] centre of mass, absolute axes, of wrist_1_link: 72819/1000000 */
    wrist_1_link_m = 1.219, /* [kg] mass of wrist_1_link, wrist_2_link: 1219/1000 */
    wrist_1_link_mx = 0.01991846, /* [kg m] first moment, link axes, of wrist_1_link, wrist_2_link: wrist_1_link_m * (-(wrist_1_link_com_z -
        param_d1)) */
    wrist_1_link_mz = 0.13085965, /* [kg m] first moment, link axes, of wrist_1_link: wrist_1_link_m * wrist_1_link_com_y */
    wrist_1_link_offset_x = 0.39225, /* [m] offset from the parent's origin of wrist_1_link: -(-wrist_1_link_com_x + elbow_joint_at_x) */
    wrist_1_link_sxz = 0.002138246681, /* [kg m^2] second moment (sum of m r r), link axes, of wrist_1_link, also szx of wrist_1_link: wrist_1_link_mx *
        wrist_1_link_com_y */
    wrist_1_link_syy = 0.0010971, /* [kg m^2] second moment (sum of m r r), link axes, of wrist_1_link, wrist_2_link: (0.004027779166666666 +
        wrist_1_link_Iyy) * 0.5 - wrist_1_link_Ixx */
    wrist_2_joint_at_y = 0.10915, /* [m] point, absolute axes, of wrist_2_joint, wrist_3_joint, also offset_z of wrist_2_link: 2183/20000 */
    wrist_2_link_Ixx = 0.0018310395833333333, /* [kg m^2] inertia, absolute axes, of wrist_2_link, also Iyy of wrist_2_link:
        18310395833333333/10000000000000000000 */
    wrist_2_link_com_y = 0.12549, /* [m] centre of mass, absolute axes, of wrist_2_link: 12549/100000 */
    wrist_2_link_com_z = 0.003691, /* [m] centre of mass, absolute axes, of wrist_2_link: 3691/1000000 */
    wrist_2_link_mz = 0.11318415, /* [kg m] first moment, link axes, of wrist_2_link: wrist_1_link_m * (-(-wrist_2_link_com_z - param_d1)) */
    wrist_2_link_sxz = 0.001849429011, /* [kg m^2] second moment (sum of m r r), link axes, of wrist_2_link, also szx of wrist_2_link: wrist_1_link_mx *
        (-(-wrist_2_link_com_z - param_d1)) */
    wrist_3_link_Ixx = 8.062475833333332e-05, /* [kg m^2] inertia, absolute axes, of wrist_3_link, also Izz of wrist_3_link:
        2015618958333333/25000000000000000000 */
    wrist_3_link_Iyy = 0.0001321171875, /* [kg m^2] inertia, absolute axes, of wrist_3_link: 16911/128000000 */
    wrist_3_link_com_y = 0.190291, /* [m] centre of mass, absolute axes, of wrist_3_link: 190291/1000000 */
    wrist_3_link_com_z = 0.005491, /* [m] centre of mass, absolute axes, of wrist_3_link, also at_z of wrist_3_joint: 5491/1000000 */
    wrist_3_link_m = 0.1879, /* [kg] mass of wrist_3_link: 1879/10000 */
    wrist_3_link_mz = 0.0152463939, /* [kg m] first moment, link axes, of wrist_3_link: wrist_3_link_m * (-(-wrist_3_link_com_y +
        wrist_2_joint_at_y)) */
    wrist_3_link_offset_z = 0.09465, /* [m] offset from the parent's origin of wrist_3_link: -(-wrist_3_link_com_z - param_d1) */
    wrist_3_link_sxx = 6.605859375e-05, /* [kg m^2] second moment (sum of m r r), link axes, of wrist_3_link, also syy of wrist_3_link:
        (0.00016124951666666664 + wrist_3_link_Iyy) * 0.5 - wrist_3_link_Ixx */
    k1 = 0.0823, /* -(-flange_at_y + wrist_2_joint_at_y) */
    k2 = 0.16673279803888333, /* shoulder_link_sxx + upper_arm_link_szz + 0.038554331696083334 + upper_arm_link_syy */
    k3 = 1.4004879791666667, /* upper_arm_link_sxx + 4.9559 * elbow_joint_at_x * elbow_joint_at_x */
    k4 = 0.349300285625, /* upper_arm_link_sxz + (forearm_link_mz + 0.284422785) * elbow_joint_at_x */
    k5 = 3.18890355, /* 2 * (forearm_link_mx + 2.6259 * wrist_1_link_offset_x) */
    k6 = 0.569926637259375, /* forearm_link_sxx + 2.6259 * wrist_1_link_offset_x * wrist_1_link_offset_x */
    k7 = 0.12652256366625, /* forearm_link_sxz + (wrist_1_link_mz + 0.153563135) * wrist_1_link_offset_x */
    k8 = 0.30177469, /* 2 * (wrist_1_link_mx + wrist_2_link_mz + 0.017784735) */
    k9 = 0.015446080714983334, /* wrist_1_link_sxx + wrist_2_link_szz + 0.00168332516775 + wrist_1_link_syy */
    k10 = 0.01643350047875, /* wrist_1_link_sxz + (wrist_2_link_mz + 0.017784735) * wrist_2_joint_at_y */
    k11 = 0.0703297078, /* 2 * (wrist_1_link_mx + wrist_3_link_mz) */
    k12 = 0.0027403000421732334, /* wrist_1_link_sxx + wrist_3_link_szz + wrist_3_link_sxx */
    k13 = 0.003292500193635, /* wrist_2_link_sxz + wrist_3_link_mz * wrist_3_link_offset_z */
    k14 = 0.748311487, /* upper_arm_link_m * param_d1 */
    k15 = 2.306638053, /* -((-gravity_z) * shoulder_link_mz) */
    k16 = 0.0015110828546732334, /* wrist_1_link_sxx + 0.0013177324057732332 - wrist_3_link_sxx - (wrist_1_link_syy + wrist_3_link_sxx) */
    k17 = 0.0026742414484232334, /* wrist_1_link_sxx + wrist_3_link_szz + wrist_3_link_sxx - wrist_3_link_sxx */
    k18 = 0.00767648760637, /* wrist_2_joint_at_y * (2 * (wrist_1_link_mx + wrist_3_link_mz)) */
    k19 = 0.15603449803888333, /* shoulder_link_sxx + 0.15396219090888333 + upper_arm_link_syy - (-(-upper_arm_link_syy - (-(-forearm_link_syy -
        wrist_1_link_syy)))) */
    k20 = 0.00226025859375, /* wrist_1_link_syy + wrist_1_link_syy + wrist_3_link_sxx */
    k21 = 0.012154780714983333, /* wrist_1_link_sxx + 0.014023513078583334 - (-(-wrist_1_link_syy + wrist_3_link_sxx)) - (wrist_1_link_syy +
        wrist_1_link_syy + wrist_3_link_sxx) */
    k22 = 0.00658500038727, /* 2 * (wrist_2_link_sxz + wrist_3_link_mz * wrist_3_link_offset_z) */
    k23 = 0.0351648539, /* wrist_1_link_mx + wrist_3_link_mz */
    k24 = 0.150887345, /* wrist_1_link_mx + wrist_2_link_mz + wrist_3_link_m * wrist_3_link_offset_z */
    k25 = 0.7845, /* wrist_1_link_offset_x * 2 */
    k26 = 0.016462539308733332, /* forearm_link_syy + wrist_1_link_sxx + 0.014023513078583334 - (-(-wrist_1_link_syy + wrist_3_link_sxx)) */
    k27 = 1.594451775, /* forearm_link_mx + (wrist_1_link_m + 1.4069) * wrist_1_link_offset_x */
    k28 = 0.85, /* elbow_joint_at_x * 2 */
    k29 = 0.003838243803185, /* wrist_2_joint_at_y * (wrist_1_link_mx + wrist_3_link_mz) */
    k30 = 0.013793413942275, /* wrist_1_link_offset_x * (wrist_1_link_mx + wrist_3_link_mz) */
    k31 = 0.0149450629075, /* elbow_joint_at_x * (wrist_1_link_mx + wrist_3_link_mz) */
    k32 = 0.003837400042173233, /* wrist_1_link_sxx + wrist_3_link_szz + wrist_3_link_sxx + wrist_1_link_syy */
    k33 = 0.016675297902483333, /* wrist_1_link_sxx + 0.014023513078583334 - (-(-wrist_1_link_syy + wrist_3_link_sxx)) + wrist_1_link_syy +
        wrist_1_link_syy + wrist_3_link_sxx */
    k34 = 0.0016432000421732333, /* -(-(-wrist_1_link_syy + wrist_3_link_sxx)) + wrist_1_link_sxx + 0.0013177324057732332 - wrist_3_link_sxx */
    k35 = 0.014348980714983334, /* -wrist_1_link_syy + wrist_1_link_sxx + 0.012926413078583334 + wrist_1_link_syy */
    k36 = 0.016543180714983334, /* wrist_1_link_sxx + 0.012926413078583334 + wrist_1_link_syy + wrist_1_link_syy */
    k37 = 0.567879137259375, /* -forearm_link_syy + forearm_link_sxx + 1.030009275 * wrist_1_link_offset_x */
    k38 = 0.571974137259375, /* forearm_link_sxx + 1.030009275 * wrist_1_link_offset_x + forearm_link_syy */
    k39 = 1.35528400875, /* (forearm_link_mx + 2.6259 * wrist_1_link_offset_x) * elbow_joint_at_x * 2 */
    k40 = 2.8009759583333333, /* -upper_arm_link_syy + upper_arm_link_sxx + 0.8951594375 + upper_arm_link_sxx + 0.8951594375 +
        upper_arm_link_syy */
    k41 = 1.3929342791666666, /* -upper_arm_link_syy + upper_arm_link_sxx + 2.1062575 * elbow_joint_at_x */
    k42 = 38.1586437, /* (upper_arm_link_mx + 4.9559 * elbow_joint_at_x) * gravity_z */
    k43 = 0.677642004375, /* (forearm_link_mx + 2.6259 * wrist_1_link_offset_x) * elbow_joint_at_x */
    k44 = 1.4080416791666666, /* upper_arm_link_sxx + 2.1062575 * elbow_joint_at_x + upper_arm_link_syy */
    k45 = 0.17193592303888333, /* shoulder_link_sxx + 0.15396219090888333 + upper_arm_link_syy + shoulder_link_syy */
    k46 = 82.33533, /* upper_arm_link_m * gravity_z */
    k47 = 0.99025, /* forearm_link_m * elbow_joint_at_x */
    k48 = 36.297, /* shoulder_link_m * gravity_z */
    k49 = 0.012340187910833333, /* wrist_1_link_syy + wrist_2_link_szz */
    k50 = 0.010145987910833333, /* -(wrist_1_link_syy - wrist_2_link_szz) */
    k51 = 0.0013177324057732332, /* wrist_3_link_szz + wrist_3_link_sxx */
    k52 = 0.0011856152182732334, /* -(wrist_3_link_sxx - wrist_3_link_szz) */
    k53 = 0.012665655547233333, /* wrist_2_link_szz + wrist_1_link_sxx */
    k54 = 0.009820520274433333, /* wrist_2_link_szz - wrist_1_link_sxx */
    k55 = 0.0025196676364, /* wrist_1_link_sxx + wrist_1_link_syy */
    k56 = 0.0003254676364, /* wrist_1_link_mx * (-(wrist_1_link_com_z - param_d1)) */
    k57 = 0.167952999140625, /* forearm_link_sxx + forearm_link_syy */
    k58 = 0.163857999140625, /* forearm_link_sxx - forearm_link_syy */
    k59 = 0.5128822416666666, /* upper_arm_link_sxx + upper_arm_link_syy */
    k60 = 0.49777484166666663, /* upper_arm_link_sxx - upper_arm_link_syy */
    k61 = 17.496257625, /* upper_arm_link_mx * gravity_z */
    k62 = 0.016061673010833333, /* wrist_1_link_syy + wrist_1_link_szz */
    k63 = 0.013867473010833332, /* -(wrist_1_link_syy - wrist_1_link_szz) */
    k64 = 0.016387140647233334, /* wrist_1_link_szz + wrist_1_link_sxx */
    k65 = 0.013542005374433333, /* wrist_1_link_szz - wrist_1_link_sxx */
    k66 = 0.0057312425, /* forearm_link_syy + forearm_link_szz */
    k67 = 0.0016362425, /* forearm_link_mz * forearm_link_com_y */
    k68 = 0.169589241640625, /* forearm_link_szz + forearm_link_sxx */
    k69 = 0.162221756640625, /* -(forearm_link_szz - forearm_link_sxx) */
    k70 = 0.2398880625, /* forearm_link_mx * elbow_joint_at_x */
    k71 = 0.1229615592128, /* upper_arm_link_syy + upper_arm_link_szz */
    k72 = 0.1078541592128, /* upper_arm_link_mz * upper_arm_link_com_y */
    k73 = 9.3335330088, /* upper_arm_link_mz * gravity_z */
    k74 = 0.6207364008794667, /* upper_arm_link_szz + upper_arm_link_sxx */
    k75 = 0.38992068245386663, /* -(upper_arm_link_szz - upper_arm_link_sxx) */
    k76 = 0.07005321, /* shoulder_link_mx * gravity_z */
    k77 = 7569.03790432263, /* 1 / wrist_3_link_Iyy */
    k78 = 260.59310705424144, /* 1 / (wrist_1_link_sxx + 0.0013177324057732332 + wrist_1_link_syy) */
    k79 = 0.8580028554360363, /* (1 / (0.0027403000421732334 + wrist_1_link_syy)) * (wrist_2_link_sxz + wrist_3_link_mz *
        wrist_3_link_offset_z) */
    k80 = 1.062452430029822, /* per_length * wrist_1_link_offset_x */
    k81 = 0.25636997451197613; /* per_length * wrist_3_link_offset_z */

static inline UR5_INLINE void ur5_angles0(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    angle[0] = q[0];
    angle[pitch] = q[stride];
    angle[2 * pitch] = q[2 * stride];
    angle[3 * pitch] = q[3 * stride];
    angle[4 * pitch] = q[4 * stride];
    angle[5 * pitch] = q[5 * stride];
}

static inline UR5_INLINE void ur5_sines1(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[8] = {0.0};
    ur5_angles0(1, 1, q, angle);
    angle[6] = angle[5];
    angle[7] = angle[5];
    ur5_sincos(4, angle, sine, cosine);
    ur5_sincos(2, angle + 4, sine + 4, cosine + 4);
}

static inline UR5_INLINE void ur5_angles2(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    angle[0] = q[0];
    angle[pitch] = q[stride];
    angle[2 * pitch] = q[2 * stride];
    angle[3 * pitch] = q[3 * stride];
    angle[4 * pitch] = q[4 * stride];
}

static inline UR5_INLINE void ur5_sines3(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[8] = {0.0};
    ur5_angles2(1, 1, q, angle);
    angle[5] = angle[4];
    angle[6] = angle[4];
    angle[7] = angle[4];
    ur5_sincos(4, angle, sine, cosine);
    ur5_sincos(1, angle + 4, sine + 4, cosine + 4);
}

static inline UR5_INLINE void ur5_angles4(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    angle[0] = q[0];
    angle[pitch] = q[stride];
    angle[2 * pitch] = q[2 * stride];
    angle[3 * pitch] = q[3 * stride];
}

static inline UR5_INLINE void ur5_sines5(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[4] = {0.0};
    ur5_angles4(1, 1, q, angle);
    ur5_sincos(4, angle, sine, cosine);
}

static inline UR5_INLINE void ur5_angles6(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    angle[0] = q[stride];
    angle[pitch] = q[2 * stride];
    angle[2 * pitch] = q[3 * stride];
    angle[3 * pitch] = q[4 * stride];
    angle[4 * pitch] = q[5 * stride];
}

static inline UR5_INLINE void ur5_sines7(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[8] = {0.0};
    ur5_angles6(1, 1, q, angle);
    angle[5] = angle[4];
    angle[6] = angle[4];
    angle[7] = angle[4];
    ur5_sincos(4, angle, sine, cosine);
    ur5_sincos(1, angle + 4, sine + 4, cosine + 4);
}

static inline UR5_INLINE void ur5_angles8(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    angle[0] = q[stride];
    angle[pitch] = q[2 * stride];
    angle[2 * pitch] = q[3 * stride];
    angle[3 * pitch] = q[4 * stride];
}

static inline UR5_INLINE void ur5_sines9(const double *restrict q, double *restrict sine, double *restrict cosine)
{
    double angle[4] = {0.0};
    ur5_angles8(1, 1, q, angle);
    ur5_sincos(4, angle, sine, cosine);
}

/* Bodies of functions are written once. Here they take one state ... */
#define BODY(function) static inline UR5_INLINE int function##_body
#define REAL double
#define READ(array, k) ((array)[k])
#define SINES(array, k) ((array)[k])
#define WRITE(array, k, x) ((array)[k] = (x))
#define CONSTANT(x) (x)
#define SQRT(x) sqrt(x)
#define ABS(x) fabs(x)
#define LESS(a, b) ((a) < (b) ? 1.0 : 0.0)
#define SELECT(condition, a, b) ((condition) != 0.0 ? (a) : (b))
#define FOURS ur5_four
#define FOUR(array, k) UR5_FOUR((array) + (k))
#define SUM_OF_FOUR(x) UR5_SUM(x)
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

#endif /* UR5_SUPPORT_H */
