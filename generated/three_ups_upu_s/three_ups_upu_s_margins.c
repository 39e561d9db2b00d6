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
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t1 = limb5_S_q_qw * limb5_S_q_qw,
      t2 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), limb5_S_q_qz = READ(q, 15), t3 = t1 + t2,
      t4 = limb5_S_q_qy * limb5_S_q_qy, t5 = limb5_S_q_qz * limb5_S_q_qz, t7 = t3 + (t4 + t5), t10 = t2 + t5,
      t9 = 4.0 - 2.0 * t7;
    /* limb1: reciprocal wrenches, eq. (10); geometry */
    const REAL t12 = SINES(cosine, 0) * (1.0 - t9 * t10),
      t17 = SINES(sine, 0) * (limb5_S_q_qy * (limb5_S_q_qz * t9) + limb5_S_q_qw * (limb5_S_q_qx * t9)),
      limb1_U2_constraint_mn_couple_x = t12 + t17, limb1_upper_offset_x = limb_upper_phase + READ(q, 2);
    /* limb1: results; geometry */
    const REAL t19 = per_length * (limb1_upper_offset_x * limb1_U2_constraint_mn_couple_x),
      t22 = per_length * limb1_upper_offset_x, limb1_lower_sin = SINES(sine, 1), t23 = limb1_lower_sin * t22,
      t24 = t23 * t23, t26 = SINES(cosine, 1) * t22,
      limb1_margins = t19 * (limb1_lower_sin * limb1_lower_sin + t24 + t26 * t26);
    WRITE(margins, 0, limb1_margins);
    REAL checked3 = limb1_margins;
    const REAL t29 = per_length * (limb_upper_phase + READ(q, 5)), /* limb2 */
      t32 = t29 * (SINES(cosine, 2) * t29); /* limb2 */
    checked0 = checked0 + t32; /* limb2 */
    WRITE(margins, 1, -t32);
    const REAL t33 = per_length * (limb_upper_phase + READ(q, 8)); /* limb3 */
    RESULT(checked1, margins, 2, t33 * (SINES(cosine, 3) * t33));
    const REAL t36 = per_length * (limb_upper_phase + READ(q, 11)), /* limb4 */
      t39 = t36 * (SINES(cosine, 4) * t36); /* limb4 */
    checked2 = checked2 + t39; /* limb4 */
    WRITE(margins, 3, -t39);
    WRITE(margins, 4, CONSTANT(1.0));
    /* else status 5: no rotation */
    NOT_BELOW(t7, 0.999999, 5);
    NOT_ABOVE(t7, 1.000001, 5);
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
    const REAL limb5_S_q_qw = READ(q, 12), limb5_S_q_qx = READ(q, 13), t35 = limb5_S_q_qw * limb5_S_q_qw,
      t36 = limb5_S_q_qx * limb5_S_q_qx, limb5_S_q_qy = READ(q, 14), limb5_S_q_qz = READ(q, 15), t37 = t35 + t36,
      t38 = limb5_S_q_qy * limb5_S_q_qy, t39 = limb5_S_q_qz * limb5_S_q_qz, t41 = t37 + (t38 + t39), t44 = t36 +
          t39,
      t43 = 4.0 - 2.0 * t41, platform_turn_yy = 1.0 - t43 * t44, t47 = limb5_S_q_qz * t43, t56 = limb5_S_q_qw * t47,
      platform_turn_zy = limb5_S_q_qy * t47 + limb5_S_q_qw * (limb5_S_q_qx * t43);
    /* limb1: geometry */
    const REAL limb1_lower_sin = SINES(sine, 1), limb1_U_0_cos = SINES(cosine, 0), limb1_U_0_sin = SINES(sine, 0),
      limb1_lower_cos = SINES(cosine, 1);
    /* limb1: reciprocal wrenches, eq. (10) */
    const REAL t57 = limb1_lower_sin * (limb5_S_q_qx * (limb5_S_q_qy * t43) - t56),
      t60 = limb1_U_0_sin * platform_turn_zy,
      limb1_U2_constraint_mn_couple_z = limb1_lower_cos * (limb1_U_0_sin * platform_turn_yy - limb1_U_0_cos *
          platform_turn_zy) - t57,
      limb1_U2_constraint_mn_couple_x = limb1_U_0_cos * platform_turn_yy + t60,
      t58 = limb1_U_0_sin * limb1_U2_constraint_mn_couple_z, t70 = limb1_U_0_cos * limb1_U2_constraint_mn_couple_z,
      limb1_U_0_lever_my_by_limb1_U2_mn = limb1_lower_cos * limb1_U2_constraint_mn_couple_x,
      limb1_U_0_lever_mz_by_limb1_U2_mn = limb1_lower_sin * limb1_U2_constraint_mn_couple_x;
    /* base: reciprocal wrenches, eq. (10) */
    const REAL base_lever_mz_by_limb1_U2_mn = t58 + limb1_U_0_cos * limb1_U_0_lever_my_by_limb1_U2_mn,
      base_lever_my_by_limb1_U2_mn = t70 - limb1_U_0_sin * limb1_U_0_lever_my_by_limb1_U2_mn,
      limb1_upper_offset_x = limb_upper_phase + READ(q, 2),
      t63 = limb1_upper_offset_x * (per_length * limb1_lower_cos); /* limb1 */
    /* all drives: results */
    const REAL t64 = base_lever_mz_by_limb1_U2_mn * t63, t71 = base_lever_my_by_limb1_U2_mn * t63,
      minus_limb1_upper_position_x = param_R - limb1_lower_sin * limb1_upper_offset_x,
      t66 = limb1_U_0_lever_mz_by_limb1_U2_mn * (per_length * (limb1_U_0_cos * minus_limb1_upper_position_x)),
      t67 = t64 - t66,
      t73 = limb1_U_0_lever_mz_by_limb1_U2_mn * (per_length * (limb1_U_0_sin * minus_limb1_upper_position_x)),
      t74 = t71 + t73, limb2_lower_cos = SINES(cosine, 5),
      t2 = per_length_param_R * (SINES(cosine, 2) * limb2_lower_cos), /* limb2 */
      t68 = t2 * t67, t16 = per_length_param_R * (limb1_U_0_cos * limb1_lower_cos), /* limb1 */
      t69 = t16 * t68, t75 = t2 * t74, t20 = per_length_param_R * (limb1_U_0_sin * limb1_lower_cos), /* limb1 */
      t77 = t69 - t20 * t75, limb4_lower_cos = SINES(cosine, 7), t78 = t77 * t77,
      t10 = per_length_param_R * (SINES(cosine, 4) * limb4_lower_cos), /* limb4 */
      t83 = t16 * (t10 * t67) - t20 * (t10 * t74), limb3_lower_cos = SINES(cosine, 6), t85 = t78 + t83 * t83,
      t17 = per_length_param_R * (SINES(sine, 3) * limb3_lower_cos), /* limb3 */
      t29 = t2 * t17, t30 = t16 * t29, t89 = t29 * t74,
      t4 = per_length_param_R * (SINES(cosine, 3) * limb3_lower_cos), /* limb3 */
      t31 = t2 * t4, t33 = t30 - t20 * t31, t86 = t33 * t33 + t85, t91 = t89 - t31 * t67, t92 = t91 * t91,
      t6 = per_length_param_R * (SINES(sine, 4) * limb4_lower_cos), /* limb4 */
      t24 = t2 * t6, t8 = t2 * (t4 * t6), t9 = per_length_param_R * (SINES(sine, 2) * limb2_lower_cos), /* limb2 */
      t26 = t24 - t9 * t10, t27 = t16 * t26, t87 = t27 * t27 + t86, t94 = t26 * t74;
    WRITE(margins, 4, -t94);
    const REAL t95 = t94 * t94, t18 = t17 * t10, t107 = t17 * t74, t19 = t16 * t18, t97 = t18 * t74,
      t104 = t16 * t67 - t20 * t74, t11 = t4 * t10, t22 = t19 - t20 * t11, t96 = t22 * t22 + t87 + t92 + t95,
      t13 = t8 - t9 * t11, t99 = t97 - t11 * t67, t109 = t107 - t4 * t67,
      all_drives_margins = t13 * t13 + (t96 + t99 * t99);
    WRITE(margins, 0, all_drives_margins);
    REAL checked3 = all_drives_margins;
    RESULT(checked0, margins, 3, t2 * t109);
    RESULT(checked1, margins, 5, t10 * t109);
    const REAL t105 = t2 * t104;
    checked2 = checked2 + t105;
    WRITE(margins, 1, -t105);
    const REAL t106 = t10 * t104;
    checked3 = checked3 + t106;
    WRITE(margins, 2, -t106);
    /* else status 5: no rotation */
    NOT_BELOW(t41, 0.999999, 5);
    NOT_ABOVE(t41, 1.000001, 5);
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
