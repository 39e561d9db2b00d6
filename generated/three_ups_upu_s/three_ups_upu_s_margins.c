/*
 * three_ups_upu_s: margins.
 *   limb_margins; constraint_margin; actuation_margins
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

BODY(three_ups_upu_s_limb_margins)(size_t stride, const double *restrict q, double *restrict margins,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    REAL checked0 = READ(q, 3);
    REAL checked1 = READ(q, 6);
    REAL checked2 = READ(q, 9);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t10 = limb5_S_q_qw * limb5_S_q_qw,
      t11 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), limb5_S_q_qz = READ(q, 15), t12 = t10 + t11,
      t13 = limb5_S_q_qy * limb5_S_q_qy, t14 = limb5_S_q_qz * limb5_S_q_qz, t16 = t12 + (t13 + t14), t19 = t11 +
          t14,
      t18 = 4.0 - 2.0 * t16;
    /* limb1: reciprocal wrenches, eq. (10); geometry */
    const REAL t21 = SINES(cosine, 0) * (1.0 - t18 * t19),
      limb1_U2_constraint_mn_couple_x = t21 + SINES(sine, 0) * (t18 * (limb5_S_q_qy * limb5_S_q_qz + limb5_S_q_qw *
          limb5_S_q_qx)),
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    /* limb1: results; geometry */
    const REAL t27 = per_length * (limb1_upper_offset_x * limb1_U2_constraint_mn_couple_x),
      t3 = per_length * limb1_upper_offset_x, limb1_lower_sin = SINES(sine, 1), t4 = limb1_lower_sin * t3,
      t5 = t4 * t4, t7 = SINES(cosine, 1) * t3,
      limb1_margins = (limb1_lower_sin * limb1_lower_sin + t5 + t7 * t7) * t27;
    WRITE(margins, 0, limb1_margins);
    REAL checked3 = limb1_margins;
    const REAL t28 = per_length * (limb_upper_phase + READ(q, 5)), /* limb2 */
      t31 = t28 * (SINES(cosine, 2) * t28); /* limb2 */
    checked0 = checked0 + t31; /* limb2 */
    WRITE(margins, 1, -t31);
    const REAL t32 = per_length * (limb_upper_phase + READ(q, 8)); /* limb3 */
    RESULT(checked1, margins, 2, t32 * (SINES(cosine, 3) * t32));
    const REAL t35 = per_length * (limb_upper_phase + READ(q, 11)), /* limb4 */
      t38 = t35 * (SINES(cosine, 4) * t35); /* limb4 */
    checked2 = checked2 + t38; /* limb4 */
    WRITE(margins, 3, -t38);
    WRITE(margins, 4, CONSTANT(1.0));
    /* else status 5: no rotation */
    NOT_BELOW(t16, 0.999999, 5);
    NOT_ABOVE(t16, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

BODY(three_ups_upu_s_constraint_margin)(size_t stride, const double *restrict q, double *restrict margins,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    const FOURS fours = FOUR(q, 3) + FOUR(q, 7);
    REAL checked0 = SUM_OF_FOUR(fours);
    REAL checked1 = READ(q, 11);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t2 = limb5_S_q_qw * limb5_S_q_qw,
      t3 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), limb5_S_q_qz = READ(q, 15), t4 = t2 + t3,
      t5 = limb5_S_q_qy * limb5_S_q_qy, t6 = limb5_S_q_qz * limb5_S_q_qz, t8 = t4 + (t5 + t6), t11 = t3 + t6,
      t10 = 4.0 - 2.0 * t8, platform_turn_yy = 1.0 - t10 * t11, t14 = limb5_S_q_qz * t10, t23 = limb5_S_q_qw * t14,
      platform_turn_zy = limb5_S_q_qy * t14 + limb5_S_q_qw * (limb5_S_q_qx * t10);
    /* limb1: geometry */
    const REAL limb1_lower_sin = SINES(sine, 1), limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_cos = SINES(cosine, 1);
    /* limb1: reciprocal wrenches, eq. (10) */
    const REAL t24 = limb1_lower_sin * (limb5_S_q_qx * (limb5_S_q_qy * t10) - t23),
      t27 = limb1_U_0_sin * platform_turn_zy,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos *
          platform_turn_zy) - t24,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + t27,
      t25 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z, t36 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    /* base: reciprocal wrenches, eq. (10) */
    const REAL base_lever_mz_by_limb1_U2_mn = t25 + limb1_U_0_cos * limb1_U_0_lever_my_by_limb1_U2_mn,
      base_lever_my_by_limb1_U2_mn = t36 - limb1_U_0_sin * limb1_U_0_lever_my_by_limb1_U2_mn,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      t30 = limb1_upper_offset_x * (per_length * limb1_lower_cos); /* limb1 */
    /* platform: results */
    const REAL t31 = base_lever_mz_by_limb1_U2_mn * t30, t37 = base_lever_my_by_limb1_U2_mn * t30,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t33 = limb1_U_0_lever_mz_by_limb1_U2_mn * (per_length * (limb1_U_0_cos * minus_limb1_upper_position_x)),
      t35 = limb1_U_0_cos * (t31 - t33),
      t39 = limb1_U_0_lever_mz_by_limb1_U2_mn * (per_length * (limb1_U_0_sin * minus_limb1_upper_position_x)),
      platform_margins = t35 - limb1_U_0_sin * (t37 + t39);
    WRITE(margins, 0, platform_margins);
    REAL checked2 = platform_margins;
    /* else status 5: no rotation */
    NOT_BELOW(t8, 0.999999, 5);
    NOT_ABOVE(t8, 1.000001, 5);
    FINITE((checked0 + checked1) + checked2);
}

BODY(three_ups_upu_s_actuation_margins)(size_t stride, const double *restrict q, double *restrict margins,
    const double *restrict sine, const double *restrict cosine, double *restrict total)
{
    REAL checked0 = READ(q, 5);
    REAL checked1 = READ(q, 8);
    REAL checked2 = READ(q, 11);
    /* limb5_S: geometry */
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t18 = limb5_S_q_qw * limb5_S_q_qw,
      t19 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), limb5_S_q_qz = READ(q, 15), t20 = t18 + t19,
      t21 = limb5_S_q_qy * limb5_S_q_qy, t22 = limb5_S_q_qz * limb5_S_q_qz, t24 = t20 + (t21 + t22), t27 = t19 +
          t22,
      t26 = 4.0 - 2.0 * t24, platform_turn_yy = 1.0 - t26 * t27, t30 = limb5_S_q_qz * t26, t39 = limb5_S_q_qw * t30,
      platform_turn_zy = limb5_S_q_qy * t30 + limb5_S_q_qw * (limb5_S_q_qx * t26);
    /* limb1: geometry */
    const REAL limb1_lower_sin = SINES(sine, 1), limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_cos = SINES(cosine, 1);
    /* limb1: reciprocal wrenches, eq. (10) */
    const REAL t40 = limb1_lower_sin * (limb5_S_q_qx * (limb5_S_q_qy * t26) - t39),
      t43 = limb1_U_0_sin * platform_turn_zy,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos *
          platform_turn_zy) - t40,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + t43,
      t41 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z, t51 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    /* base: reciprocal wrenches, eq. (10) */
    const REAL base_lever_my_by_limb1_U2_mn = t41 - limb1_U_0_sin * limb1_U_0_lever_my_by_limb1_U2_mn,
      base_lever_mz_by_limb1_U2_mn = t51 + limb1_U_0_cos * limb1_U_0_lever_my_by_limb1_U2_mn,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      t45 = limb1_upper_offset_x * (per_length * limb1_lower_cos); /* limb1 */
    /* all drives: results */
    const REAL t46 = base_lever_my_by_limb1_U2_mn * t45, t53 = base_lever_mz_by_limb1_U2_mn * t45,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t48 = limb1_U_0_lever_mz_by_limb1_U2_mn * (per_length * (limb1_U_0_sin * minus_limb1_upper_position_x)),
      t49 = t46 + t48,
      t55 = limb1_U_0_lever_mz_by_limb1_U2_mn * (per_length * (limb1_U_0_cos * minus_limb1_upper_position_x)),
      t56 = t53 - t55, limb3_lower_cos = SINES(cosine, 6),
      t15 = per_length_param_R * (SINES(sine, 3) * limb3_lower_cos), /* limb3 */
      t97 = t15 * t49, t4 = per_length_param_R * (SINES(cosine, 3) * limb3_lower_cos), /* limb3 */
      t99 = t97 - t4 * t56, limb4_lower_cos = SINES(cosine, 7),
      t10 = per_length_param_R * (SINES(cosine, 4) * limb4_lower_cos), /* limb4 */
      limb3_P_limb4_P_margins = t10 * t99;
    WRITE(margins, 5, limb3_P_limb4_P_margins);
    REAL checked3 = limb3_P_limb4_P_margins;
    const REAL limb2_lower_cos = SINES(cosine, 5),
      t2 = per_length_param_R * (SINES(cosine, 2) * limb2_lower_cos); /* limb2 */
    RESULT(checked0, margins, 3, t2 * t99);
    const REAL t6 = per_length_param_R * (SINES(sine, 4) * limb4_lower_cos), /* limb4 */
      t60 = t2 * t6, t8 = t2 * (t4 * t6),
      t9 = per_length_param_R * (SINES(sine, 2) * limb2_lower_cos), /* limb2 */
      t62 = t60 - t9 * t10, t63 = t62 * t49;
    WRITE(margins, 4, -t63);
    const REAL t64 = t63 * t63, t71 = per_length_param_R * (limb1_U_0_cos * limb1_lower_cos), /* limb1 */
      t77 = t71 * t62, t78 = t77 * t77, t83 = t71 * t56,
      t73 = per_length_param_R * (limb1_U_0_sin * limb1_lower_cos), /* limb1 */
      t85 = t83 - t73 * t49, t88 = t10 * t85;
    WRITE(margins, 2, -t88);
    const REAL t86 = t2 * t85;
    WRITE(margins, 1, -t86);
    const REAL t90 = t86 * t86 + t88 * t88, t65 = t2 * t15, t67 = t2 * t4, t16 = t15 * t10, t11 = t4 * t10,
      t13 = t8 - t9 * t11, t14 = t13 * t13, t72 = t71 * t16, t66 = t65 * t49, t50 = t16 * t49,
      t81 = t71 * t65 - t73 * t67, t92 = t78 + (t81 * t81 + t90), t75 = t72 - t73 * t11, t93 = t75 * t75 + t92,
      t69 = t66 - t67 * t56, t58 = t50 - t11 * t56;
    RESULT(checked1, margins, 0, t14 + (t58 * t58 + (t64 + (t69 * t69 + t93))));
    /* else status 5: no rotation */
    NOT_BELOW(t24, 0.999999, 5);
    NOT_ABOVE(t24, 1.000001, 5);
    FINITE((checked0 + checked1) + (checked2 + checked3));
}

#if !defined(THREE_UPS_UPU_S_VECTORS)

int three_ups_upu_s_limb_margins(const double *restrict q, double *restrict margins)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines9(q, sine, cosine);
    const int outcome = three_ups_upu_s_limb_margins_body(1, q, margins, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(margins, 5);
    }
    return outcome;
}

int three_ups_upu_s_constraint_margin(const double *restrict q, double *restrict margins)
{
    double sine[4] = {0.0}, cosine[4] = {0.0};
    three_ups_upu_s_sines11(q, sine, cosine);
    const int outcome = three_ups_upu_s_constraint_margin_body(1, q, margins, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(margins, 1);
    }
    return outcome;
}

int three_ups_upu_s_actuation_margins(const double *restrict q, double *restrict margins)
{
    double sine[8] = {0.0}, cosine[8] = {0.0};
    three_ups_upu_s_sines13(q, sine, cosine);
    const int outcome = three_ups_upu_s_actuation_margins_body(1, q, margins, sine, cosine, NULL);
    if (outcome != 0) {
        three_ups_upu_s_set_nan(margins, 6);
    }
    return outcome;
}
#endif /* THREE_UPS_UPU_S_VECTORS */
