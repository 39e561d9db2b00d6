"""Constraints, freedoms and loci of the reference configuration, in the parameters, as mobility analysis finds them.

Mobility.symbolic --lengths named, common factors taken out--> wrenches (f ; m_O), twists (omega ; v_O), conditions
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy

from symscrew.mobility import Mobility, condition
from symscrew.paper_formulas.formula import Formula, Part, index_of, latex_of, vector_latex
from symscrew.paper_formulas.limb_formulas import Freedom
from symscrew.paper_formulas.named_lengths import Lengths

LONGEST_WRENCH = 600  # letters of LaTeX of a wrench: two lines of a paper
LONGEST = 2000  # letters of LaTeX of a condition: a longer one is for a program


def platform_parts(found: Mobility, lengths: Lengths, firsts: Mapping[int, Sequence[Freedom] | str]) -> list[Part]:
    """What limbs forbid, what the platform keeps, and where that changes; nothing where there are no symbols.

    `firsts`: the freedoms of limbs that are no others turned, by their number from 1.
    """
    symbolic = found.symbolic
    if symbolic is None:
        return []
    resting: list[Formula] = []
    for number, limb in enumerate(symbolic.limbs, 1):
        for k, wrench in enumerate(limb.constraints, 1):
            resting.append(
                Formula(rf"\boldsymbol{{W}}_{{{number}{k}}}", _screw(wrench, lengths), ("constraint", limb.name))
            )
    parts = []
    if resting:
        words = "Wrenches that the limbs transmit without drives, in the reference configuration, up to their size."
        parts.append(Part("Constraints", words, tuple(resting)))
    parts += _displaced(found, lengths, firsts)
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
        short = condition(locus.expression)
        text = "" if short is None else latex_of(lengths.tidy(lengths.named(short)), lengths.names)
        if 0 < len(text) <= LONGEST:
            if text not in (known := [formula.latex for formula in loci]):
                loci.append(Formula(rf"L_{{{len(loci) + 1}}}", text, ("locus", str(k))))
                known.append(text)
            where.setdefault((str(known.index(text) + 1), locus.meaning), []).append(locus.where)
    said = [f"$L_{{{k}}}$: {', '.join(names)}, {meaning}" for (k, meaning), names in where.items()]
    if loci:
        words = f"Where one of these is zero, the reference configuration is special: {'; '.join(said)}."
        parts.append(Part("Loci of degeneration", words, tuple(loci)))
    return parts


def _displaced(found: Mobility, lengths: Lengths, firsts: Mapping[int, Sequence[Freedom] | str]) -> list[Part]:
    """Wrenches of limbs at their own displacements, in axes that their first joint turns."""
    made: list[Formula] = []
    symbols: dict[str, str] = {}
    named = list(found.mechanism.limbs)
    for number, freedoms in firsts.items():
        limb = named[number - 1]
        pose = found.limb_poses.get(limb)
        if pose is None or isinstance(pose, str) or isinstance(freedoms, str):
            continue
        names, place = dict(lengths.names), {freedom.label: k for k, freedom in enumerate(freedoms)}
        known: dict[str, str] = {}
        for symbol, label in zip(pose.displacements, pose.of, strict=True):
            k = place[label]
            turns = freedoms[k].turns
            names[symbol] = (r"\theta" if turns else "d") + f"_{index_of(number, k)}"
            kind, unit = ("angle", "rad") if turns else ("displacement", "m")
            known[names[symbol]] = f"{kind} of {label} from the reference configuration [{unit}]"
        for k, wrench in enumerate(pose.constraints, 1):
            text = _screw(wrench, lengths, names)
            if len(text) <= LONGEST_WRENCH:
                name = rf"\boldsymbol{{V}}_{{{number}{k}}}"
                made.append(Formula(name, text, ("displaced", limb)))
                symbols |= {symbol: said for symbol, said in known.items() if symbol in text}
    if not made:
        return []
    words = (
        "The same with the joints inside a limb displaced, in axes that its first freedom carries along, of a "
        "spherical joint all three; limbs that are another one turned have these turned likewise."
    )
    return [Part("Constraints of displaced limbs", words, tuple(made), symbols)]


def _screw(vector: Sequence[sympy.Expr], lengths: Lengths, names: Mapping[sympy.Symbol, str] | None = None) -> str:
    entries = [sympy.factor(lengths.tidy(lengths.named(e))) for e in vector]
    common = sympy.gcd_list([e for e in entries if e != 0]) if any(e != 0 for e in entries) else sympy.Integer(1)
    reduced = [lengths.tidy(sympy.cancel(e / common)) for e in entries]
    return vector_latex(sympy.Matrix(reduced), lengths.names if names is None else names)
