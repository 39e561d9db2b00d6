"""A mobility result as text, JSON values, Markdown, HTML and LaTeX."""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import sympy

from symscrew.mobility.screw_text import describe_twist, describe_wrench
from symscrew.mobility.singularities import as_lines, as_values

if TYPE_CHECKING:
    from symscrew.mobility.analysis import Mobility
    from symscrew.mobility.symbolic_screws import Locus, Vector


STYLE = (
    "body{font:17px/1.45 'Latin Modern Roman','STIX Two Text',Georgia,serif;max-width:46em;margin:2.5em auto}"
    "h1{font-size:1.5em;font-weight:normal}h2{font-size:1.1em;margin:1.3em 0 .3em}ul{margin:.2em 0;padding-left:1.3em}"
    "table{border-collapse:collapse;border-top:1.5px solid;border-bottom:1.5px solid}td{padding:.1em .8em}"
    "td+td{text-align:right}math{font-size:1.05em}"
)
LONG = 100
"""Letters of LaTeX; a longer screw is written as a column."""


def mobility_values(found: Mobility) -> dict[str, Any]:
    """The result as JSON values; exact forms as strings beside the numbers."""
    finite, platform, symbolic = found.finite, found.platform, found.symbolic
    exact = {limb.name: limb.constraints for limb in symbolic.limbs} if symbolic else {}
    return {
        "mechanism": found.mechanism.name,
        "kutzbach": found.kutzbach,
        "dof": found.dof,
        "dof_finite": finite.dof,
        "smooth": finite.smooth,
        "branches": None if finite.branches is None else list(finite.branches),
        "overconstraints": found.overconstraints,
        "internal_freedoms": found.internal_freedoms,
        "platform": {
            "body": platform.body,
            "dof": platform.dof,
            "type": platform.type,
            "freedoms": [[float(c) for c in twist] for twist in platform.freedoms.basis],
            "freedoms_exact": [[str(c) for c in t] for t in symbolic.freedoms] if symbolic else None,
        },
        "limbs": [
            {
                "name": limb.name,
                "constraints": [[float(c) for c in wrench] for wrench in limb.constraints.basis],
                "constraints_exact": [[str(c) for c in w] for w in exact[limb.name]] if limb.name in exact else None,
                "constraints_displaced": _pose(found, limb.name),
            }
            for limb in found.limbs
        ],
        "dof_drives_locked": found.dof_drives_locked,
        "loci": [
            {"kind": locus.kind, "where": locus.where, "zero": str(locus.expression), "meaning": locus.meaning}
            for locus in found.loci
        ],
        "singularities": as_values(found.singularities),
        "motions_exact": _rates(found),
        "overconstraint_joints": list(found.redundant.statically_indeterminate),
        "method": found.method,
        "exact": found.decisions.exact,
        "field": found.decisions.field,
        "ranks": [{"claim": d.claim, "rank": d.numeric, "exact": d.exact} for d in found.decisions.ranks],
        "singular_values": list(found.decisions.singular_values),
        "nearly_parallel": list(found.nearly_parallel),
        "evidence": list(finite.evidence),
        "proved": finite.proved,
    }


def _pose(found: Mobility, limb: str) -> dict[str, Any] | None:
    pose = found.limb_poses.get(limb)
    if pose is None or isinstance(pose, str):
        return {"reason": pose} if pose else None
    return {
        "displacements": {str(symbol): joint for symbol, joint in zip(pose.displacements, pose.of, strict=True)},
        "constraints": [[str(c) for c in w] for w in pose.constraints],
        "loci": [{"kind": locus.kind, "zero": str(locus.expression)} for locus in pose.loci],
    }


def _rates(found: Mobility) -> list[dict[str, str]] | None:
    if found.limbs or not found.network.chords or isinstance(found.loops, str):
        return None
    joints = found.loops.joints
    return [{j: str(r) for j, r in zip(joints, rates, strict=True)} for rates in found.loops.rates]


def sections(found: Mobility) -> list[tuple[str, list[str]]]:
    """(heading, lines) of the whole report in words; formulas between dollar signs."""
    result = [("Mobility", _summary(found))]
    symbolic = {limb.name: limb for limb in found.symbolic.limbs} if found.symbolic else {}
    limbs: dict[tuple[str, ...], list[str]] = {}
    for limb in found.limbs:
        lines = [f"{_count(len(limb.screws), 'joint freedom')}, {_count(len(limb.constraints.basis), 'constraint')}"]
        lines += [describe_wrench(w) for w in limb.constraints.basis]
        if limb.name in symbolic and symbolic[limb.name].constraints:
            lines.append(f"in symbols (f ; m): {_formulas(symbolic[limb.name].constraints)}")
        limbs.setdefault((*lines, *_displaced(found, limb.name)), []).append(limb.name)
    for facts, names in limbs.items():
        result.append((f"{'Limbs' if len(names) > 1 else 'Limb'} {', '.join(names)}", list(facts)))
    lines = [f"{_count(found.platform.dof, 'freedom')}, type {found.platform.type}"]
    lines += [describe_twist(t) for t in found.platform.freedoms.basis]
    if found.symbolic is not None and found.platform.body == found.mechanism.platform and found.symbolic.freedoms:
        lines.append(f"in symbols (omega ; v): {_formulas(found.symbolic.freedoms)}")
    if found.without_symbols:
        lines.append(found.without_symbols)
    result.append((f"Freedoms of {found.platform.body}", lines))
    if not found.limbs and found.network.chords:
        result.append(("Motions of the loops in symbols", _motions(found)))
    if found.loci:
        lines = [f"{_zero(locus)} ({locus.where}): {locus.meaning}" for locus in found.loci]
        result.append(("Where it degenerates", lines))
    if lines := as_lines(found.singularities):
        result.append(("How far from singularities (0 at one)", lines))
    if found.redundant.count:
        result.append(("Redundant constraints", _redundant(found)))
    if found.nearly_parallel:
        result.append(("Almost parallel", list(found.nearly_parallel)))
    result.append(("How it was decided", [found.method, *found.finite.evidence]))
    return result


def _count(number: int, what: str) -> str:
    return f"{number or 'no'} {what}{'' if number == 1 else 's'}"


def key_figures(found: Mobility) -> list[tuple[str, str]]:
    """(what, value) for the table at the head of a report."""
    finite = found.finite
    branches = "smooth" if finite.branches is None else ", ".join(map(str, finite.branches)) or "isolated"
    figures = [
        ("instantaneous mobility", str(found.dof)),
        ("finite mobility", "not decided" if finite.dof is None else str(finite.dof)),
        ("branches", branches),
        ("Kutzbach-Gruebler", str(found.kutzbach)),
        ("redundant constraints", str(found.overconstraints)),
        (f"freedoms of {found.platform.body}", f"{found.platform.dof} ({found.platform.type})"),
        ("internal freedoms", str(found.internal_freedoms)),
    ]
    if found.dof_drives_locked is not None:
        figures.append(("with drives locked", str(found.dof_drives_locked)))
    return [*figures, ("ranks", "exact" if found.decisions.exact else "certified numeric")]


def _summary(found: Mobility) -> list[str]:
    finite = found.finite
    lines = [f"{_count(found.dof, 'instantaneous freedom')}; Kutzbach-Gruebler counts {found.kutzbach}"]
    if found.overconstraints:
        lines.append(
            f"The count is {found.overconstraints} too low, because {found.overconstraints} of the "
            f"{6 * len(found.network.chords)} closure equations follow from the others"
        )
    if found.internal_freedoms:
        lines.append(f"{_count(found.internal_freedoms, 'freedom')} with {found.platform.body} at rest (internal)")
    if found.dof and not found.platform.dof and finite.dof:
        lines.append(
            f"{found.platform.body} is at rest for an instant while the mechanism moves (a dead point for it), "
            "or it does not move at all; --body shows another body"
        )
    if finite.smooth:
        lines.append(f"Finite mobility {finite.dof}: a smooth point of the configuration space")
    elif finite.dof is None:
        lines.append("A singular point of the configuration space; the finite mobility is not decided")
    elif not finite.branches:
        lines.append("No finite mobility: the configuration is isolated, its freedoms are infinitesimal (shaky)")
    else:
        lines.append(
            f"Finite mobility {finite.dof}: a singular point ({finite.kind}); dimensions of the branches through it: "
            + ", ".join(map(str, finite.branches))
        )
    if found.dof_drives_locked is not None:
        lines.append(f"{_count(found.dof_drives_locked, 'freedom')} left with all drives locked")
    return lines


def _displaced(found: Mobility, limb: str) -> list[str]:
    """The constraints of a limb with symbols for its own joints, or the sentence why not."""
    pose = found.limb_poses.get(limb)
    if pose is None or isinstance(pose, str):
        return [f"away from the reference configuration: {pose}"] if pose else []
    names = ", ".join(f"${sympy.latex(s)}$ of {joint}" for s, joint in zip(pose.displacements, pose.of, strict=True))
    lines = [f"displaced by {names}, in axes that move with {pose.carried_by} (f ; m): {_formulas(pose.constraints)}"]
    return lines + [f"{locus.meaning} where ${sympy.latex(locus.expression)} = 0$" for locus in pose.loci]


def _motions(found: Mobility) -> list[str]:
    """Joint rates of a mechanism without limbs, or the sentence why not."""
    loops = found.loops
    if isinstance(loops, str):
        return [loops]
    lines = []
    for rates in loops.rates:
        moving = [(joint, rate) for joint, rate in zip(loops.joints, rates, strict=True) if rate != 0]
        lines.append("rates " + ", ".join(f"{joint} ${sympy.latex(rate)}$" for joint, rate in moving))
        if resting := [joint for joint, rate in zip(loops.joints, rates, strict=True) if rate == 0]:
            lines.append(f"at rest in it: {', '.join(resting)}")
    if loops.freedoms:
        lines.append(f"{loops.body} moves by (omega ; v): {_formulas(loops.freedoms)}")
    return lines


def _redundant(found: Mobility) -> list[str]:
    joints = ", ".join(found.redundant.statically_indeterminate)
    return [
        f"The reactions of {joints} are not unique",
        "One change for each redundant constraint:",
        *found.redundant.cure,
    ]


def _zero(locus: Locus) -> str:
    return f"${sympy.latex(locus.expression)} = 0$" if locus.expression != 0 else "always"


def _formulas(vectors: Sequence[Vector]) -> str:
    return ", ".join("$" + _screw(vector) + "$" for vector in vectors)


def _screw(vector: Vector) -> str:
    texts = [sympy.latex(c) for c in vector]
    if sum(map(len, texts)) > LONG:
        return r"\begin{pmatrix}" + r" \\ ".join(texts) + r"\end{pmatrix}"
    return r"\left(" + ", ".join(texts[:3]) + r";\; " + ", ".join(texts[3:]) + r"\right)"


def mobility_text(found: Mobility) -> str:
    """Plain text, one line a fact; formulas as they are typed."""
    formulas = _typed(found)
    lines = []
    for heading, facts in sections(found):
        lines += [heading, *(f"    {_with(fact, formulas, str)}" for fact in facts)]
    return "\n".join(lines)


def mobility_markdown(found: Mobility) -> str:
    """A Markdown document with formulas between dollar signs."""
    lines = [f"# Mobility of {found.mechanism.name}", ""]
    if found.mechanism.source:
        lines += [found.mechanism.source, ""]
    lines += ["| | |", "|---|---|", *(f"| {what} | {value} |" for what, value in key_figures(found)), ""]
    for heading, facts in sections(found):
        lines += [f"## {heading}", "", *(f"- {fact}" for fact in facts), ""]
    return "\n".join(lines)


def mobility_page(found: Mobility) -> str:
    """An HTML page without scripts: formulas as MathML, which browsers render."""
    name = html.escape(found.mechanism.name)
    source = html.escape(found.mechanism.source)
    parts = [f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>Mobility of {name}</title>',
             f"<style>{STYLE}</style>",
             f"</head><body>\n<h1>Mobility of {name}</h1>",
             f"<p>{html.escape(found.mechanism.description)}<br><i>{source}</i></p>", "<table>"]  # fmt: skip
    parts += [
        f"<tr><td>{html.escape(what)}</td><td>{html.escape(value)}</td></tr>" for what, value in key_figures(found)
    ]
    parts.append("</table>")
    known = formulas(found)
    for heading, facts in sections(found):
        parts.append(f"<h2>{html.escape(heading)}</h2>\n<ul>")
        parts += [f"<li>{_with(fact, known, html.escape)}</li>" for fact in facts]
        parts.append("</ul>")
    return "\n".join([*parts, "</body></html>\n"])


def _expressions(found: Mobility) -> tuple[list[Vector], list[sympy.Expr], list[sympy.Expr]]:
    """(screws, loci, single expressions) that the report shows."""
    vectors: list[Vector] = []
    loci = [locus.expression for locus in found.loci]
    single: list[sympy.Expr] = []
    if found.symbolic is not None:
        vectors += [*(w for limb in found.symbolic.limbs for w in limb.constraints), *found.symbolic.freedoms]
    for pose in found.limb_poses.values():
        if not isinstance(pose, str):
            vectors += pose.constraints
            loci += [locus.expression for locus in pose.loci]
            single += pose.displacements
    if not found.limbs and not isinstance(found.loops, str):
        vectors += found.loops.freedoms
        single += [rate for motion in found.loops.rates for rate in motion]
    return vectors, loci, single


def _typed(found: Mobility) -> dict[str, str]:
    """LaTeX of every formula of the report -> as it is typed."""
    vectors, loci, single = _expressions(found)

    def typed(expression: sympy.Expr) -> str:
        return str(expression).replace("**", "^")

    result = {_screw(v): f"({', '.join(map(typed, v[:3]))}; {', '.join(map(typed, v[3:]))})" for v in vectors}
    result.update({f"{sympy.latex(e)} = 0": f"{typed(e)} = 0" for e in loci})
    result.update({sympy.latex(e): typed(e) for e in single})
    return result


def mathml(expression: sympy.Expr) -> str:
    """An expression as MathML."""
    return f"<math>{_presented(expression)}</math>"


def _presented(expression: sympy.Expr) -> str:
    from sympy.printing.mathml import mathml as printed

    mobility_text = str(printed(expression, printer="presentation")).replace("<mo>-</mo>", "<mo>&#x2212;</mo>")
    for function in ("sin", "cos"):
        mobility_text = mobility_text.replace(f"<mi>{function}</mi>", f'<mspace width="0.15em"/><mi>{function}</mi>')
    return mobility_text


def formulas(found: Mobility) -> dict[str, str]:
    """LaTeX of every formula of the report -> MathML."""
    vectors, loci, single = _expressions(found)
    result: dict[str, str] = {}
    for vector in vectors:
        cells = [_presented(c) for c in vector]
        if sum(len(sympy.latex(c)) for c in vector) > LONG:
            rows = "".join(f"<mtr><mtd>{cell}</mtd></mtr>" for cell in cells)
            result[_screw(vector)] = f"<math><mo>(</mo><mtable>{rows}</mtable><mo>)</mo></math>"
            continue
        inside = "<mo>,</mo>".join(cells[:3]) + "<mo>;</mo>" + "<mo>,</mo>".join(cells[3:])
        result[_screw(vector)] = f"<math><mo>(</mo>{inside}<mo>)</mo></math>"
    for expression in loci:
        result[f"{sympy.latex(expression)} = 0"] = _equation(expression)
    result.update({sympy.latex(e): f"<math>{_presented(e)}</math>" for e in single})
    return result


def _equation(expression: sympy.Expr) -> str:
    """MathML of expression = 0; a long sum in pieces, between which a line may end."""
    if len(sympy.latex(expression)) <= LONG or not expression.is_Add:
        return f"<math>{_presented(expression)}<mo>=</mo><mn>0</mn></math>"
    pieces = []
    for k, term in enumerate(expression.as_ordered_terms()):
        negative = term.could_extract_minus_sign()
        sign = f'<mo form="infix">{"&#x2212;" if negative else "+"}</mo>' if k or negative else ""
        pieces.append(f"<math>{sign}{_presented(-term if negative else term)}</math>")
    return " ".join([*pieces, '<math><mo form="infix">=</mo><mn>0</mn></math>'])


def _with(fact: str, formulas: dict[str, str], words: Callable[[str], str]) -> str:
    """A line with its formulas replaced and its words written in their way."""
    pieces = re.split(r"\$(.*?)\$", fact)
    return "".join(formulas.get(p, words(p)) if k % 2 else words(p) for k, p in enumerate(pieces))


def mobility_latex(found: Mobility) -> str:
    """A LaTeX document of the report."""
    lines = [r"\documentclass{article}", r"\usepackage[T1]{fontenc}", r"\usepackage{amsmath}",
             r"\usepackage[margin=28mm]{geometry}", r"\setlength{\emergencystretch}{3em}", r"\begin{document}",
             rf"\section*{{Mobility of {_escaped(found.mechanism.name)}}}"]  # fmt: skip
    lines += [r"\begin{center}\begin{tabular}{lr}\hline"]
    lines += [rf"{_escaped(what)} & {_escaped(value)} \\" for what, value in key_figures(found)]
    lines += [r"\hline\end{tabular}\end{center}"]
    for heading, facts in sections(found):
        lines += [rf"\subsection*{{{_escaped(heading)}}}", r"\begin{itemize}"]
        for fact in facts:
            pieces = re.split(r"(\$.*?\$)", fact)
            lines.append(r"\item " + "".join(p if p.startswith("$") else _escaped(p) for p in pieces))
        lines.append(r"\end{itemize}")
    return "\n".join([*lines, r"\end{document}", ""])


def _escaped(words: str) -> str:
    marks = {"\\": r"\textbackslash{}", "^": r"\^{}", "~": r"\~{}", "|": r"\textbar{}", "<": r"\textless{}"}
    return "".join(marks.get(c, "\\" + c if c in "_%&#${}" else c) for c in words)
