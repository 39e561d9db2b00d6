"""Constraints, freedoms and loci of the reference configuration, in the parameters, as mobility analysis finds them.

Mobility.symbolic --lengths named, common factors taken out--> wrenches (f ; m_O), twists (omega ; v_O), conditions
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy

from symscrew.mobility import Mobility
from symscrew.paper_formulas.formula import Formula, Part, latex_of, vector_latex
from symscrew.paper_formulas.named_lengths import Lengths

LONGEST = 2000  # letters of LaTeX of a condition: a longer one is for a program


def platform_parts(found: Mobility, lengths: Lengths) -> list[Part]:
    """What limbs forbid, what the platform keeps, and where that changes; nothing where there are no symbols."""
    symbolic = found.symbolic
    if symbolic is None:
        return []
    limbs: list[Formula] = []
    for number, limb in enumerate(symbolic.limbs, 1):
        for k, wrench in enumerate(limb.constraints, 1):
            limbs.append(
                Formula(rf"\boldsymbol{{W}}_{{{number}{k}}}", _screw(wrench, lengths), ("constraint", limb.name))
            )
    parts = []
    if limbs:
        words = "Wrenches that the limbs transmit without drives, in the reference configuration, up to their size."
        parts.append(Part("Constraints", words, tuple(limbs)))
    freedoms = tuple(
        Formula(rf"\boldsymbol{{F}}_{{{k}}}", _screw(twist, lengths), ("freedom",))
        for k, twist in enumerate(symbolic.freedoms, 1)
    )
    if freedoms:
        words = "Twists that the platform can have in the reference configuration, up to their size."
        parts.append(Part("Freedoms of the platform", words, freedoms))
    loci: list[Formula] = []
    where: dict[tuple[str, str], list[str]] = {}
    for k, locus in enumerate(symbolic.loci):
        text = latex_of(lengths.tidy(lengths.named(locus.expression)), lengths.names)
        if len(text) <= LONGEST:
            if text not in (known := [formula.latex for formula in loci]):
                loci.append(Formula(rf"L_{{{len(loci) + 1}}}", text, ("locus", str(k))))
                known.append(text)
            where.setdefault((str(known.index(text) + 1), locus.meaning), []).append(locus.where)
    said = [f"$L_{{{k}}}$: {', '.join(names)}, {meaning}" for (k, meaning), names in where.items()]
    if loci:
        words = f"Where one of these is zero, the reference configuration is special: {'; '.join(said)}."
        parts.append(Part("Loci of degeneration", words, tuple(loci)))
    return parts


def _screw(vector: Sequence[sympy.Expr], lengths: Lengths) -> str:
    entries = [sympy.factor(lengths.named(e)) for e in vector]
    common = sympy.gcd_list([e for e in entries if e != 0]) if any(e != 0 for e in entries) else sympy.Integer(1)
    reduced = [lengths.tidy(sympy.cancel(e / common)) for e in entries]
    return vector_latex(sympy.Matrix(reduced), lengths.names)
