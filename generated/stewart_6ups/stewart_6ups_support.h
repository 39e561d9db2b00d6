/*
 * stewart_6ups: what its sources share.
 * Generated with stewart_6ups.h, which says of what; do not edit.
 */
#ifndef STEWART_6UPS_SUPPORT_H
#define STEWART_6UPS_SUPPORT_H

#include "stewart_6ups.h"

#include <math.h>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "compile without -ffinite-math-only and -ffast-math: the checks for NaN would vanish"
#endif

/* Vectors that GCC makes of scalar code here cost more than they save; no comparison here traps. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#pragma GCC optimize("no-tree-slp-vectorize,no-trapping-math")
#endif
#if defined(__GNUC__)
#define STEWART_6UPS_INLINE __attribute__((always_inline))
#define STEWART_6UPS_UNUSED __attribute__((unused))
#else
#define STEWART_6UPS_INLINE
#define STEWART_6UPS_UNUSED
#endif

STEWART_6UPS_UNUSED static inline void stewart_6ups_set_nan(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = (double)NAN;
    }
}

STEWART_6UPS_UNUSED static inline void stewart_6ups_zero(double *array, size_t size)
{
    for (size_t k = 0; k < size; ++k) {
        array[k] = 0.0;
    }
}

/* Sines and cosines of the first `count` of 4 angles; STEWART_6UPS_SCALAR takes them one by one. */
#if defined(__GNUC__) && defined(__GLIBC__) && defined(__x86_64__) && defined(__AVX2__) && !defined(STEWART_6UPS_SCALAR)
typedef double stewart_6ups_lanes __attribute__((vector_size(32)));
stewart_6ups_lanes _ZGVdN4v_sin(stewart_6ups_lanes);
stewart_6ups_lanes _ZGVdN4v_cos(stewart_6ups_lanes);
STEWART_6UPS_UNUSED static inline STEWART_6UPS_INLINE void stewart_6ups_sincos(int count, const double *angle, double *sine, double *cosine)
{
    if (count == 1) {
        sine[0] = sin(angle[0]);
        cosine[0] = cos(angle[0]);
        return;
    }
    const stewart_6ups_lanes all = {angle[0], angle[1], angle[2], angle[3]};
    const stewart_6ups_lanes s = _ZGVdN4v_sin(all);
    const stewart_6ups_lanes c = _ZGVdN4v_cos(all);
    for (int k = 0; k < count; ++k) {
        sine[k] = s[k];
        cosine[k] = c[k];
    }
}
#else
STEWART_6UPS_UNUSED static inline STEWART_6UPS_INLINE void stewart_6ups_sincos(int count, const double *angle, double *sine, double *cosine)
{
    for (int k = 0; k < count; ++k) {
        sine[k] = sin(angle[k]);
        cosine[k] = cos(angle[k]);
    }
}
#endif

#if defined(__GNUC__) && defined(__AVX__) && !defined(STEWART_6UPS_SCALAR)
typedef double stewart_6ups_four __attribute__((vector_size(32)));
typedef double stewart_6ups_four_there __attribute__((vector_size(32), aligned(8), may_alias));
#define STEWART_6UPS_FOUR(x) (*(const stewart_6ups_four_there *)(x))
#define STEWART_6UPS_SUM(four) (((four)[0] + (four)[1]) + ((four)[2] + (four)[3]))
#else
typedef double stewart_6ups_four;
#define STEWART_6UPS_FOUR(x) (((x)[0] + (x)[1]) + ((x)[2] + (x)[3]))
#define STEWART_6UPS_SUM(four) (four)
#endif

#if defined(__GNUC__) && defined(__AVX2__) && !defined(STEWART_6UPS_SCALAR) && !defined(STEWART_6UPS_LIMB_BY_LIMB)
typedef double stewart_6ups_vector4 __attribute__((vector_size(32)));
typedef long long stewart_6ups_vector4_mask __attribute__((vector_size(32)));
static inline stewart_6ups_vector4 stewart_6ups_vector4_sqrt(stewart_6ups_vector4 x)
{
    stewart_6ups_vector4 root = x;
    for (int k = 0; k < 4; ++k) {
        root[k] = sqrt(x[k]);
    }
    return root;
}
#endif

/* Of the second path of functions, in the support's source. */
void stewart_6ups_orthogonalise(int rows, int columns, double *a, double *v);
double stewart_6ups_dot(int size, const double *x, const double *y);
int stewart_6ups_cholesky(int size, double *matrix, double *right);
int stewart_6ups_constrained(int n, int m, const double *mass, const double *force, double *jacobian,
                             const double *bias, double *v, double *work, double *a, double *multipliers);
void stewart_6ups_internal_load(int n, int m, const double *jacobian, int found, double *loads);

/* Constants: numbers of the description, and what was folded of them. */
STEWART_6UPS_UNUSED static const double
    gravity_z = 9.81, /* [m/s^2] acceleration of the effect of gravity: 981/100 */
    gravity_z_leg_lower_mx = 3.4335, /* gravity_z * leg_lower_mx */
    gravity_z_platform_m = 49.05, /* gravity_z * platform_m */
    leg_S_at_x = 0.3856725658119236, /* [m] point, absolute axes, of leg1_S, leg2_S, C1, C2: 3*cos(5*pi/18)/5 */
    leg_S_at_x_2 = 0.20521208599540125, /* [m] point, absolute axes, of leg3_S, leg6_S, C3, C6: 3*cos(7*pi/18)/5 */
    leg_S_at_x_3 = 0.5908846518073249, /* [m] point, absolute axes, of leg4_S, leg5_S, C4, C5: 3*cos(pi/18)/5 */
    leg_S_at_y = 0.45962666587138684, /* [m] point, absolute axes, of leg1_S, leg2_S, C1, C2: 3*sin(5*pi/18)/5 */
    leg_S_at_y_2 = 0.563815572471545, /* [m] point, absolute axes, of leg3_S, leg6_S, C3, C6: 3*sin(7*pi/18)/5 */
    leg_S_at_y_3 = 0.10418890660015821, /* [m] point, absolute axes, of leg4_S, leg5_S, C4, C5: 3*sin(pi/18)/5 */
    leg_U_0_axes_xx = 0.9024648745597685, /* [1] rotation of the axes before the motion of leg1_U.0, leg2_U.0, also axes_yz of leg1_U.0: -(-cos(pi/18) +
        3*cos(5*pi/18)/5)/sqrt(34/25 - 6*cos(2*pi/9)/5) */
    leg_U_0_axes_xx_2 = 0.8242845283333535, /* [1] rotation of the axes before the motion of leg3_U.0, leg6_U.0, also axes_yz of leg3_U.0:
        8*cos(7*pi/18)/(5*sqrt(34/25 - 6*cos(2*pi/9)/5)) */
    leg_U_0_axes_xx_3 = 0.07818034622641509, /* [1] rotation of the axes before the motion of leg4_U.0, leg5_U.0, also axes_yz of leg4_U.0: (-3*cos(pi/18)/5 +
        cos(5*pi/18))/sqrt(34/25 - 6*cos(2*pi/9)/5) */
    leg_U_0_axes_xz = 0.43076345038294644, /* [1] rotation of the axes before the motion of leg1_U.0, leg2_U.0, also axes_yx of leg1_U.0: (-sin(pi/18) +
        3*sin(5*pi/18)/5)/sqrt(34/25 - 6*cos(2*pi/9)/5) */
    leg_U_0_axes_xz_2 = 0.5661757822004231, /* [1] rotation of the axes before the motion of leg3_U.0, leg6_U.0, also axes_yx of leg3_U.0:
        2*sin(7*pi/18)/(5*sqrt(34/25 - 6*cos(2*pi/9)/5)) */
    leg_U_0_axes_xz_3 = 0.9969392325833696, /* [1] rotation of the axes before the motion of leg4_U.0, leg5_U.0, also axes_yx of leg4_U.0: (-3*sin(pi/18)/5 +
        sin(5*pi/18))/sqrt(34/25 - 6*cos(2*pi/9)/5) */
    leg_U_0_phase = 0.5860761254153768, /* [rad] what is added to the coordinate of leg1_U.0, leg2_U.0, leg3_U.0, leg4_U.0 ...: atan2(sqrt(34/25 -
        6*cos(2*pi/9)/5)/sqrt(59/25 - 6*cos(2*pi/9)/5), leg_U_0_axes_xz * (-(-3*sin(5*pi/18)/5 +
        sin(pi/18))/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5))) - ((-leg_U_0_axes_xx) *
        (-(-cos(pi/18) + 3*cos(5*pi/18)/5)/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5))))) */
    leg_U_at_x = 0.984807753012208, /* [m] point, absolute axes, of leg1_U, leg2_U, A1, A2, also offset_x of leg1_U.0: cos(pi/18) */
    leg_U_at_x_2 = 0.3420201433256687, /* [m] point, absolute axes, of leg3_U, leg6_U, A3, A6, also offset_x of leg3_U.0: cos(7*pi/18) */
    leg_U_at_x_3 = 0.6427876096865394, /* [m] point, absolute axes, of leg4_U, leg5_U, A4, A5, also offset_x of leg4_U.0: cos(5*pi/18) */
    leg_U_at_y = 0.17364817766693036, /* [m] point, absolute axes, of leg1_U, leg2_U, A1, A2, also offset_y of leg1_U.0: sin(pi/18) */
    leg_U_at_y_2 = 0.9396926207859084, /* [m] point, absolute axes, of leg3_U, leg6_U, A3, A6, also offset_y of leg3_U.0: sin(7*pi/18) */
    leg_U_at_y_3 = 0.766044443118978, /* [m] point, absolute axes, of leg4_U, leg5_U, A4, A5, also offset_y of leg4_U.0: sin(5*pi/18) */
    leg_lower_Ixx = 0.015016986949194433, /* [kg m^2] inertia, absolute axes, of leg1_lower, leg2_lower: -(-cos(pi/18) + 3*cos(5*pi/18)/5)**2/(50*(59/25 -
        6*cos(2*pi/9)/5)) + 1/50 */
    leg_lower_Ixx_2 = 0.015842945614166184, /* [kg m^2] inertia, absolute axes, of leg3_lower, leg6_lower: -32*cos(7*pi/18)**2/(625*(59/25 -
        6*cos(2*pi/9)/5)) + 1/50 */
    leg_lower_Ixx_3 = 0.01996260387622662, /* [kg m^2] inertia, absolute axes, of leg4_lower, leg5_lower: -(-3*cos(pi/18)/5 + cos(5*pi/18))**2/(50*(59/25 -
        6*cos(2*pi/9)/5)) + 1/50 */
    leg_lower_Ixy = 0.00237848580656986, /* [kg m^2] inertia, absolute axes, of leg1_lower, leg2_lower, also Iyx of leg1_lower: (-3*sin(5*pi/18)/5 +
        sin(pi/18))*(-cos(pi/18) + 3*cos(5*pi/18)/5)/(50*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_lower_Ixy_2 = 0.0028553532641308037, /* [kg m^2] inertia, absolute axes, of leg3_lower, leg6_lower, also Iyx of leg3_lower:
        8*sin(7*pi/18)*cos(7*pi/18)/(625*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_lower_Ixy_3 = 0.00047686745756094395, /* [kg m^2] inertia, absolute axes, of leg4_lower, leg5_lower, also Iyx of leg4_lower: -(-sin(5*pi/18) +
        3*sin(pi/18)/5)*(-3*cos(pi/18)/5 + cos(5*pi/18))/(50*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_lower_Ixz = 0.008317009511811229, /* [kg m^2] inertia, absolute axes, of leg1_lower, leg2_lower, also Izx of leg1_lower: -(-cos(pi/18) +
        3*cos(5*pi/18)/5)/(50*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_lower_Ixz_2 = 0.007596508690636359, /* [kg m^2] inertia, absolute axes, of leg3_lower, leg6_lower, also Izx of leg3_lower: 4*cos(7*pi/18)/(125*(59/25
        - 6*cos(2*pi/9)/5)) */
    leg_lower_Ixz_3 = 0.0007205008211748702, /* [kg m^2] inertia, absolute axes, of leg4_lower, leg5_lower, also Izx of leg4_lower: (-3*cos(pi/18)/5 +
        cos(5*pi/18))/(50*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_lower_Iyy = 0.018864704010530392, /* [kg m^2] inertia, absolute axes, of leg1_lower, leg2_lower: -(-3*sin(5*pi/18)/5 + sin(pi/18))**2/(50*(59/25 -
        6*cos(2*pi/9)/5)) + 1/50 */
    leg_lower_Iyy_2 = 0.018038745345558643, /* [kg m^2] inertia, absolute axes, of leg3_lower, leg6_lower: -2*sin(7*pi/18)**2/(625*(59/25 - 6*cos(2*pi/9)/5))
        + 1/50 */
    leg_lower_Iyy_3 = 0.013919087083498203, /* [kg m^2] inertia, absolute axes, of leg4_lower, leg5_lower: -(-sin(5*pi/18) + 3*sin(pi/18)/5)**2/(50*(59/25 -
        6*cos(2*pi/9)/5)) + 1/50 */
    leg_lower_Iyz = 0.0039698649943835755, /* [kg m^2] inertia, absolute axes, of leg1_lower, leg2_lower, also Izy of leg1_lower: -(-3*sin(5*pi/18)/5 +
        sin(pi/18))/(50*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_lower_Iyz_2 = 0.005217809023553549, /* [kg m^2] inertia, absolute axes, of leg3_lower, leg6_lower, also Izy of leg3_lower: sin(7*pi/18)/(125*(59/25 -
        6*cos(2*pi/9)/5)) */
    leg_lower_Iyz_3 = 0.009187674017937124, /* [kg m^2] inertia, absolute axes, of leg4_lower, leg5_lower, also Izy of leg4_lower: -(-sin(5*pi/18) +
        3*sin(pi/18)/5)/(50*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_lower_Izz = 0.006118309040275175, /* [kg m^2] inertia, absolute axes, of leg1_lower, leg2_lower, leg3_lower, leg4_lower ...: 1/50 - 1/(50*(59/25 -
        6*cos(2*pi/9)/5)) */
    leg_lower_com_x = 0.8101052775398093, /* [m] centre of mass, absolute axes, of leg1_lower, leg2_lower: 7*(-cos(pi/18) +
        3*cos(5*pi/18)/5)/(20*sqrt(59/25 - 6*cos(2*pi/9)/5)) + cos(pi/18) */
    leg_lower_com_x_2 = 0.18245210732461956, /* [m] centre of mass, absolute axes, of leg3_lower, leg6_lower: -14*cos(7*pi/18)/(25*sqrt(59/25 -
        6*cos(2*pi/9)/5)) + cos(7*pi/18) */
    leg_lower_com_x_3 = 0.6276531702151897, /* [m] centre of mass, absolute axes, of leg4_lower, leg5_lower: -7*(-3*cos(pi/18)/5 +
        cos(5*pi/18))/(20*sqrt(59/25 - 6*cos(2*pi/9)/5)) + cos(5*pi/18) */
    leg_lower_com_y = 0.2570369535033782, /* [m] centre of mass, absolute axes, of leg1_lower, leg2_lower: -7*(-3*sin(5*pi/18)/5 +
        sin(pi/18))/(20*sqrt(59/25 - 6*cos(2*pi/9)/5)) + sin(pi/18) */
    leg_lower_com_y_2 = 0.8300902268410072, /* [m] centre of mass, absolute axes, of leg3_lower, leg6_lower: -7*sin(7*pi/18)/(50*sqrt(59/25 -
        6*cos(2*pi/9)/5)) + sin(7*pi/18) */
    leg_lower_com_y_3 = 0.573053273337629, /* [m] centre of mass, absolute axes, of leg4_lower, leg5_lower: 7*(-sin(5*pi/18) +
        3*sin(pi/18)/5)/(20*sqrt(59/25 - 6*cos(2*pi/9)/5)) + sin(5*pi/18) */
    leg_lower_com_z = 0.29159107861578093, /* [m] centre of mass, absolute axes, of leg1_lower, leg2_lower, leg3_lower, leg4_lower ...: 7/(20*sqrt(59/25 -
        6*cos(2*pi/9)/5)) */
    leg_lower_mx = 0.35, /* [kg m] first moment, link axes, of leg1_lower, leg2_lower, leg3_lower, leg4_lower ...: (-0.4991499299211394) *
        (-0.17470247547239878) + (-0.23825364524699386) * (-0.08338877583644785) + (0.15459088447872588 +
        0.678526482994934) * leg_lower_com_z */
    leg_lower_sxx = 0.1425, /* [kg m^2] second moment (sum of m r r), link axes, of leg1_lower, leg2_lower, leg3_lower, leg4_lower ...:
        0.008615269007658929 * leg_U_0_axes_xz + (-0.01804929749119537) * (-leg_U_0_axes_xx) + leg_lower_mx *
        leg_lower_mx */
    leg_upper_Ixx = 0.011262740211895824, /* [kg m^2] inertia, absolute axes, of leg1_upper, leg2_upper: -3*(-cos(pi/18) + 3*cos(5*pi/18)/5)**2/(200*(59/25
        - 6*cos(2*pi/9)/5)) + 3/200 */
    leg_upper_Ixx_2 = 0.011882209210624637, /* [kg m^2] inertia, absolute axes, of leg3_upper, leg6_upper: -24*cos(7*pi/18)**2/(625*(59/25 -
        6*cos(2*pi/9)/5)) + 3/200 */
    leg_upper_Ixx_3 = 0.014971952907169966, /* [kg m^2] inertia, absolute axes, of leg4_upper, leg5_upper: -3*(-3*cos(pi/18)/5 + cos(5*pi/18))**2/(200*(59/25
        - 6*cos(2*pi/9)/5)) + 3/200 */
    leg_upper_Ixy = 0.001783864354927395, /* [kg m^2] inertia, absolute axes, of leg1_upper, leg2_upper, also Iyx of leg1_upper: 3*(-3*sin(5*pi/18)/5 +
        sin(pi/18))*(-cos(pi/18) + 3*cos(5*pi/18)/5)/(200*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_upper_Ixy_2 = 0.002141514948098103, /* [kg m^2] inertia, absolute axes, of leg3_upper, leg6_upper, also Iyx of leg3_upper:
        6*sin(7*pi/18)*cos(7*pi/18)/(625*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_upper_Ixy_3 = 0.00035765059317070797, /* [kg m^2] inertia, absolute axes, of leg4_upper, leg5_upper, also Iyx of leg4_upper: -3*(-sin(5*pi/18) +
        3*sin(pi/18)/5)*(-3*cos(pi/18)/5 + cos(5*pi/18))/(200*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_upper_Ixz = 0.006237757133858422, /* [kg m^2] inertia, absolute axes, of leg1_upper, leg2_upper, also Izx of leg1_upper: -3*(-cos(pi/18) +
        3*cos(5*pi/18)/5)/(200*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_upper_Ixz_2 = 0.005697381517977269, /* [kg m^2] inertia, absolute axes, of leg3_upper, leg6_upper, also Izx of leg3_upper: 3*cos(7*pi/18)/(125*(59/25
        - 6*cos(2*pi/9)/5)) */
    leg_upper_Ixz_3 = 0.0005403756158811527, /* [kg m^2] inertia, absolute axes, of leg4_upper, leg5_upper, also Izx of leg4_upper: 3*(-3*cos(pi/18)/5 +
        cos(5*pi/18))/(200*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_upper_Iyy = 0.014148528007897794, /* [kg m^2] inertia, absolute axes, of leg1_upper, leg2_upper: -3*(-3*sin(5*pi/18)/5 + sin(pi/18))**2/(200*(59/25
        - 6*cos(2*pi/9)/5)) + 3/200 */
    leg_upper_Iyy_2 = 0.013529059009168981, /* [kg m^2] inertia, absolute axes, of leg3_upper, leg6_upper: -3*sin(7*pi/18)**2/(1250*(59/25 -
        6*cos(2*pi/9)/5)) + 3/200 */
    leg_upper_Iyy_3 = 0.010439315312623652, /* [kg m^2] inertia, absolute axes, of leg4_upper, leg5_upper: -3*(-sin(5*pi/18) + 3*sin(pi/18)/5)**2/(200*(59/25
        - 6*cos(2*pi/9)/5)) + 3/200 */
    leg_upper_Iyz = 0.0029773987457876816, /* [kg m^2] inertia, absolute axes, of leg1_upper, leg2_upper, also Izy of leg1_upper: -3*(-3*sin(5*pi/18)/5 +
        sin(pi/18))/(200*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_upper_Iyz_2 = 0.003913356767665161, /* [kg m^2] inertia, absolute axes, of leg3_upper, leg6_upper, also Izy of leg3_upper: 3*sin(7*pi/18)/(500*(59/25
        - 6*cos(2*pi/9)/5)) */
    leg_upper_Iyz_3 = 0.006890755513452844, /* [kg m^2] inertia, absolute axes, of leg4_upper, leg5_upper, also Izy of leg4_upper: -3*(-sin(5*pi/18) +
        3*sin(pi/18)/5)/(200*(59/25 - 6*cos(2*pi/9)/5)) */
    leg_upper_Izz = 0.004588731780206382, /* [kg m^2] inertia, absolute axes, of leg1_upper, leg2_upper, leg3_upper, leg4_upper ...: 3/200 - 3/(200*(59/25
        - 6*cos(2*pi/9)/5)) */
    leg_upper_com_x = 0.5354175447882654, /* [m] centre of mass, absolute axes, of leg1_upper, leg2_upper: -3*(-cos(pi/18) +
        3*cos(5*pi/18)/5)/(10*sqrt(59/25 - 6*cos(2*pi/9)/5)) + 3*cos(5*pi/18)/5 */
    leg_upper_com_x_2 = 0.06843948370878765, /* [m] centre of mass, absolute axes, of leg3_upper, leg6_upper: -12*cos(7*pi/18)/(25*sqrt(59/25 -
        6*cos(2*pi/9)/5)) + 3*cos(7*pi/18)/5 */
    leg_upper_com_x_3 = 0.603857028497053, /* [m] centre of mass, absolute axes, of leg4_upper, leg5_upper: 3*(-3*cos(pi/18)/5 +
        cos(5*pi/18))/(10*sqrt(59/25 - 6*cos(2*pi/9)/5)) + 3*cos(pi/18)/5 */
    leg_upper_com_y = 0.38815057229728867, /* [m] centre of mass, absolute axes, of leg1_upper, leg2_upper: 3*(-3*sin(5*pi/18)/5 +
        sin(pi/18))/(10*sqrt(59/25 - 6*cos(2*pi/9)/5)) + 3*sin(5*pi/18)/5 */
    leg_upper_com_y_2 = 0.6577604815671747, /* [m] centre of mass, absolute axes, of leg3_upper, leg6_upper: 3*sin(7*pi/18)/(25*sqrt(59/25 -
        6*cos(2*pi/9)/5)) + 3*sin(7*pi/18)/5 */
    leg_upper_com_y_3 = 0.269609909269886, /* [m] centre of mass, absolute axes, of leg4_upper, leg5_upper: 3*sin(pi/18)/5 - 3*(-sin(5*pi/18) +
        3*sin(pi/18)/5)/(10*sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    leg_upper_com_z = 0.750064789757902, /* [m] centre of mass, absolute axes, of leg1_upper, leg2_upper, leg3_upper, leg4_upper ...: 1 - 3/(10*sqrt(59/25
        - 6*cos(2*pi/9)/5)) */
    leg_upper_m = 0.6, /* [kg] mass of leg1_upper, leg2_upper, leg3_upper, leg4_upper ...: 3/5 */
    leg_upper_mx = 0.18, /* [kg m] first moment, link axes, of leg1_upper, leg2_upper, leg3_upper, leg4_upper ...: -(leg_upper_m *
        (-(-(-(-(-0.07474519576208351 - 0.017029439842044122)) - (-(0.8331173674736598 *
        (-0.24993521024209797))))))) */
    leg_upper_sxx = 0.069, /* [kg m^2] second moment (sum of m r r), link axes, of leg1_upper, leg2_upper, leg3_upper, leg4_upper ...:
        0.006461451755744196 * leg_U_0_axes_xz + (-0.01353697311839653) * (-leg_U_0_axes_xx) + (-leg_upper_mx)
        * (-(-(-0.09177463560412763 - 0.20822536439587236))) */
    per_length = 1.0923315051345042, /* [1/m] 1 over the characteristic length */
    platform_Ixx = 0.4, /* [kg m^2] inertia, absolute axes, of platform: 2/5 */
    platform_Iyy = 0.45, /* [kg m^2] inertia, absolute axes, of platform: 9/20 */
    platform_Izz = 0.8, /* [kg m^2] inertia, absolute axes, of platform: 4/5 */
    platform_m = 5.0, /* [kg] mass of platform: 5 */
    platform_sxx = 0.425, /* [kg m^2] second moment (sum of m r r), link axes, of platform: (0.85 + platform_Izz) * 0.5 - platform_Ixx */
    platform_syy = 0.375, /* [kg m^2] second moment (sum of m r r), link axes, of platform: (0.85 + platform_Izz) * 0.5 - platform_Iyy */
    platform_szz = 0.025, /* [kg m^2] second moment (sum of m r r), link axes, of platform: (0.85 + platform_Izz) * 0.5 - platform_Izz */
    k1 = 0.4991499299211394, /* -((-leg_U_0_axes_xx) * (sqrt(34/25 - 6*cos(2*pi/9)/5)/sqrt(59/25 - 6*cos(2*pi/9)/5))) */
    k2 = 0.678526482994934, /* -((-leg_U_0_axes_xx) * (-(-cos(pi/18) + 3*cos(5*pi/18)/5)/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 -
        6*cos(2*pi/9)/5)))) */
    k3 = 0.3238734461922218, /* (-(-cos(pi/18) + 3*cos(5*pi/18)/5)/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5))) *
        leg_U_0_axes_xz */
    k4 = 0.7518591605306811, /* -(-cos(pi/18) + 3*cos(5*pi/18)/5)/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k5 = 0.23825364524699386, /* leg_U_0_axes_xz * (sqrt(34/25 - 6*cos(2*pi/9)/5)/sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k6 = 0.15459088447872588, /* leg_U_0_axes_xz * (-(-3*sin(5*pi/18)/5 + sin(pi/18))/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 -
        6*cos(2*pi/9)/5))) */
    k7 = 0.3588765117869108, /* -(-3*sin(5*pi/18)/5 + sin(pi/18))/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k8 = 0.8331173674736598, /* leg_U_0_axes_xz * (-(-3*sin(5*pi/18)/5 + sin(pi/18))/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 -
        6*cos(2*pi/9)/5))) - ((-leg_U_0_axes_xx) * (-(-cos(pi/18) + 3*cos(5*pi/18)/5)/(sqrt(34/25 -
        6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5)))) */
    k9 = 0.5530962411857079, /* sqrt(34/25 - 6*cos(2*pi/9)/5)/sqrt(59/25 - 6*cos(2*pi/9)/5) */
    k10 = 0.45590867428871196, /* leg_U_0_axes_xx_2 * (sqrt(34/25 - 6*cos(2*pi/9)/5)/sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k11 = 0.5660574161214544, /* -(leg_U_0_axes_xx_2 * (-(8*cos(7*pi/18)/(5*sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5))))) */
    k12 = 0.38880749222713124, /* -((-(8*cos(7*pi/18)/(5*sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5)))) * leg_U_0_axes_xz_2) */
    k13 = 0.6867257562943508, /* 8*cos(7*pi/18)/(5*sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k14 = 0.31314969698543205, /* leg_U_0_axes_xz_2 * (sqrt(34/25 - 6*cos(2*pi/9)/5)/sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k15 = 0.2670599513522054, /* leg_U_0_axes_xz_2 * (2*sin(7*pi/18)/(5*sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5))) */
    k16 = 0.47169087719415675, /* 2*sin(7*pi/18)/(5*sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k17 = 0.04324125563242743, /* leg_U_0_axes_xx_3 * (sqrt(34/25 - 6*cos(2*pi/9)/5)/sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k18 = 0.005092152094101347, /* -(leg_U_0_axes_xx_3 * (-((-3*cos(pi/18)/5 + cos(5*pi/18))/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 -
        6*cos(2*pi/9)/5))))) */
    k19 = 0.06493404603490945, /* -((-((-3*cos(pi/18)/5 + cos(5*pi/18))/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5)))) *
        leg_U_0_axes_xz_3) */
    k20 = 0.06513340423633021, /* (-3*cos(pi/18)/5 + cos(5*pi/18))/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k21 = 0.5514033422324259, /* leg_U_0_axes_xz_3 * (sqrt(34/25 - 6*cos(2*pi/9)/5)/sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k22 = 0.8280252153795585, /* leg_U_0_axes_xz_3 * (-(-sin(5*pi/18) + 3*sin(pi/18)/5)/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 -
        6*cos(2*pi/9)/5))) */
    k23 = 0.8305673889810676, /* -(-sin(5*pi/18) + 3*sin(pi/18)/5)/(sqrt(34/25 - 6*cos(2*pi/9)/5)*sqrt(59/25 - 6*cos(2*pi/9)/5)) */
    k24 = 0.8139531171231321, /* -(-(-(leg_U_at_x * (-leg_U_0_axes_xx))) - ((-leg_U_0_axes_xz) * leg_U_at_y)) */
    k25 = 0.5809305665271339, /* leg_U_at_x * leg_U_0_axes_xz + (-leg_U_at_y) * (-leg_U_0_axes_xx) */
    k26 = 0.6001555357274534, /* -(-(-(-(-((-0.4991499299211394) * 0.29956759360014223)) - (-((-0.23825364524699386) * 0.14298924410222824))))
        - (-((0.15459088447872588 + 0.678526482994934) * (-0.5)))) */
    k27 = 1.5, /* 0.5 * 3 */
    k28 = 0.825, /* (platform_Ixx + platform_Iyy + platform_Izz) * 0.5 */
    k29 = 0.2115, /* leg_lower_sxx + leg_upper_sxx */
    k30 = 0.36, /* -(2 * (-leg_upper_mx)) */
    k31 = 0.423, /* 2 * (leg_lower_sxx + leg_upper_sxx) */
    k32 = 0.05, /* platform_sxx - platform_syy */
    k33 = 0.15636069245283019, /* leg_U_0_axes_xx_3 * 2 */
    k34 = 1.804929749119537, /* -((-leg_U_0_axes_xx) * 2) */
    k35 = 1.648569056666707, /* leg_U_0_axes_xx_2 * 2 */
    k36 = 0.9999999999999999; /* per_length * characteristic_length */

static inline STEWART_6UPS_INLINE void stewart_6ups_angles0(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    const double angle0 = leg_U_0_phase + q[0];
    const double angle1 = leg_U_0_phase + q[3 * stride];
    const double angle2 = leg_U_0_phase + q[6 * stride];
    const double angle3 = leg_U_0_phase + q[9 * stride];
    const double angle4 = leg_U_0_phase + q[12 * stride];
    const double angle5 = leg_U_0_phase + q[15 * stride];
    angle[0] = angle0;
    angle[pitch] = q[stride];
    angle[2 * pitch] = angle1;
    angle[3 * pitch] = q[4 * stride];
    angle[4 * pitch] = angle2;
    angle[5 * pitch] = q[7 * stride];
    angle[6 * pitch] = angle3;
    angle[7 * pitch] = q[10 * stride];
    angle[8 * pitch] = angle4;
    angle[9 * pitch] = q[13 * stride];
    angle[10 * pitch] = angle5;
    angle[11 * pitch] = q[16 * stride];
}

static inline STEWART_6UPS_INLINE void stewart_6ups_sines1(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[12] = {0.0};
    stewart_6ups_angles0(1, 1, q, angle);
    stewart_6ups_sincos(4, angle, sine, cosine);
    stewart_6ups_sincos(4, angle + 4, sine + 4, cosine + 4);
    stewart_6ups_sincos(4, angle + 8, sine + 8, cosine + 8);
}

static inline STEWART_6UPS_INLINE void stewart_6ups_angles2(size_t stride, size_t pitch, const double *restrict q,
    double *restrict angle)
{
    (void)stride;
    (void)pitch;
    angle[0] = q[stride];
    angle[pitch] = q[4 * stride];
    angle[2 * pitch] = q[7 * stride];
    angle[3 * pitch] = q[10 * stride];
    angle[4 * pitch] = q[13 * stride];
    angle[5 * pitch] = q[16 * stride];
}

static inline STEWART_6UPS_INLINE void stewart_6ups_sines3(const double *restrict q, double *restrict sine,
    double *restrict cosine)
{
    double angle[8] = {0.0};
    stewart_6ups_angles2(1, 1, q, angle);
    angle[6] = angle[5];
    angle[7] = angle[5];
    stewart_6ups_sincos(4, angle, sine, cosine);
    stewart_6ups_sincos(2, angle + 4, sine + 4, cosine + 4);
}

/* Bodies of functions are written once. Here they take one state ... */
#define BODY(function) static inline STEWART_6UPS_INLINE int function##_body
#define REAL double
#define READ(array, k) ((array)[k])
#define SINES(array, k) ((array)[k])
#define WRITE(array, k, x) ((array)[k] = (x))
#define CONSTANT(x) (x)
#define SQRT(x) sqrt(x)
#define ABS(x) fabs(x)
#define LESS(a, b) ((a) < (b) ? 1.0 : 0.0)
#define SELECT(condition, a, b) ((condition) != 0.0 ? (a) : (b))
#define FOURS stewart_6ups_four
#define FOUR(array, k) STEWART_6UPS_FOUR((array) + (k))
#define SUM_OF_FOUR(x) STEWART_6UPS_SUM(x)
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

#endif /* STEWART_6UPS_SUPPORT_H */
