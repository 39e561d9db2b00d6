"""The formulas of a mobility result: as LaTeX, and from there as MathML and as they are typed.

Mobility --expressions--> LaTeX between dollar signs in every line --formulas, typed--> MathML, plain text
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

import sympy

from symscrew.mobility.field_counts import as_lines
from symscrew.mobility.findings.counts_typeset import counts_as_mathml, typed_counts
from symscrew.mobility.symbols import conditions

if TYPE_CHECKING:
    from symscrew.mobility.analysis import Mobility
    from symscrew.mobility.symbols import Vector

LONG = 100
"""Letters of LaTeX that fit a line of a document: a longer sum is written in pieces between which a line may end."""

ROW = 80
"""Letters of a screw as it is typed that fit half a line of a document, where words stand before it: a longer one is
written as a column."""

LONGEST_NUMBER = 10**9
"""Numerators and denominators beyond this are written as decimals of six digits: nobody reads or pastes them. The JSON
has them exactly."""


TYPED = 30
"""Digits of long numbers before they are shown with six."""


def _long(expression: sympy.Expr) -> set[sympy.Rational]:
    """Numbers with many digits in it."""
    return {n for n in expression.atoms(sympy.Rational) if max(abs(n.p), n.q) > LONGEST_NUMBER}


def signs_ahead(expression: sympy.Expr) -> sympy.Expr:
    """The same with minus signs in front of products, where sums within them then have fewer, or begin without one.

    >>> R, r, s = sympy.symbols("R r s")
    >>> signs_ahead(R - s * (-R + r)), signs_ahead((-R + r) * (-r - s))
    (R + s*(R - r), (R - r)*(r + s))
    """

    def negative(total: sympy.Expr) -> bool:
        minus = [term.could_extract_minus_sign() for term in total.as_ordered_terms()]
        return bool((2 * sum(minus), minus[0]) > (len(minus), False))

    def ahead(product: sympy.Expr) -> sympy.Expr:
        turned = [f.is_Add and negative(f) for f in product.args]
        factors = [-f if turn else f for f, turn in zip(product.args, turned, strict=True)]
        return sympy.Mul((-1) ** sum(turned), *factors)

    return expression.replace(lambda e: e.is_Mul and any(f.is_Add for f in e.args), ahead)


def presentable(expression: sympy.Expr) -> sympy.Expr:
    """The expression as it is shown: numbers with many digits as decimals, signs in front."""
    long = {n: sympy.Float(n, 6) for n in _long(expression)}
    expression = signs_ahead(expression)
    if not long:
        return expression
    shown = expression.xreplace(long)
    return shown if shown.free_symbols else shown.evalf(6)


def vanishing(expression: sympy.Expr) -> sympy.Expr:
    """What is said to be zero, as it is shown, of the sign with which it begins without a minus.

    >>> R, r = sympy.symbols("R r")
    >>> vanishing(r - R), vanishing(-2 * R + r - 1)
    (R - r, 2*R - r + 1)
    """
    found = presentable(expression)
    begins = found.as_ordered_terms()[0]
    return presentable(-expression) if begins.could_extract_minus_sign() else found


def shown(vector: Vector) -> Vector:
    """A screw as it is shown: of unit direction where its length is a number, with presentable components.

    A screw in parameters whose length depends on them stays as it is: divided, it would have poles.
    """
    lead = vector[:3] if any(vector[:3]) else vector[3:]
    square = sympy.expand(sum(c * c for c in lead))
    if square.is_number and square != 1 and square != 0:
        if _long(square) and not any(c.free_symbols for c in vector):  # a root of long integers is found by factors
            size = sympy.sqrt(square.evalf(TYPED))
            return tuple((c.evalf(TYPED) / size).evalf(6) if c else c for c in vector)
        if not _long(square):
            size = sympy.sqrt(square)
            vector = tuple(_over(c, size) if c else c for c in vector)
    return tuple(presentable(c) for c in vector)


def _over(component: sympy.Expr, size: sympy.Expr) -> sympy.Expr:
    """A component over a number; sums with sines and cosines of displacements as they were, ordered by these."""
    turning = sorted((f for f in component.atoms(sympy.sin, sympy.cos) if f.free_symbols), key=str)
    if not turning:
        return sympy.radsimp(component / size)
    return sympy.collect(sympy.expand(sympy.radsimp(sympy.expand(component) / size)), turning, sympy.factor_terms)


def inline(vectors: Sequence[Vector]) -> str:
    """Screws as LaTeX between dollar signs."""
    return ", ".join("$" + screw_latex(shown(vector)) + "$" for vector in vectors)


def say_more(vectors: Sequence[Vector]) -> bool:
    """Whether screws in symbols say more than their numbers: parameters, or roots."""
    return any(not c.is_Rational for vector in vectors for c in shown(vector))


def _is_column(vector: Vector) -> bool:
    return sum(len(str(c)) for c in vector) > ROW


def screw_latex(vector: Vector) -> str:
    """One screw: (omega ; v) or (f ; m) in a row, or in a column where it is long."""
    texts = [sympy.latex(c) for c in vector]
    if _is_column(vector):
        return r"\begin{pmatrix}" + r" \\ ".join(texts) + r"\end{pmatrix}"
    return r"\left(" + ", ".join(texts[:3]) + r";\; " + ", ".join(texts[3:]) + r"\right)"


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
            loci += [locus.expression for locus in conditions(pose.loci)]
            single += pose.displacements
    if not found.limbs and not isinstance(found.loops, str):
        vectors += found.loops.freedoms
        single += [rate for motion in found.loops.rates for rate in motion]
    return [shown(v) for v in vectors], [vanishing(e) for e in loci], [presentable(e) for e in single]


def typed_formulas(found: Mobility) -> dict[str, str]:
    """LaTeX of every formula of the report -> as it is typed."""
    vectors, loci, single = _expressions(found)

    def typed(expression: sympy.Expr) -> str:
        return str(expression).replace("**", "^")

    result = {screw_latex(v): f"({', '.join(map(typed, v[:3]))}; {', '.join(map(typed, v[3:]))})" for v in vectors}
    result.update({f"{sympy.latex(e)} = 0": f"{typed(e)} = 0" for e in loci})
    result.update({sympy.latex(e): typed(e) for e in single})
    return result | typed_counts(as_lines(found.counts))


def mathml(expression: sympy.Expr) -> str:
    """An expression as MathML."""
    return f"<math>{_presented(expression)}</math>"


OPENING, CLOSING = (f'<mo fence="true" stretchy="true" form="{form}">' for form in ("prefix", "postfix"))
"""A bracket as high as what it is around, where a browser does not take it for one by its place."""


def _presented(expression: sympy.Expr) -> str:
    from sympy.printing.mathml import mathml as printed

    text = str(printed(expression, printer="presentation")).replace("<mo>-</mo>", "<mo>&#x2212;</mo>")
    text = re.sub(r"<mn>-([^<]*)</mn>", r"<mn>&#x2212;\1</mn>", text)
    text = text.replace("<mo>(</mo>", f"{OPENING}(</mo>").replace("<mo>)</mo>", f"{CLOSING})</mo>")
    for function in ("sin", "cos"):
        text = text.replace(f"<mi>{function}</mi>", f'<mspace width="0.15em"/><mi>{function}</mi>')
    return text


def formulas(found: Mobility) -> dict[str, str]:
    """LaTeX of every formula of the report -> MathML."""
    vectors, loci, single = _expressions(found)
    result: dict[str, str] = {}
    for vector in vectors:
        cells = [_presented(c) for c in vector]
        if _is_column(vector):
            rows = "".join(f"<mtr><mtd>{cell}</mtd></mtr>" for cell in cells)
            result[screw_latex(vector)] = _fenced(f"<mtable>{rows}</mtable>")
            continue
        inside = "<mo>,</mo>".join(cells[:3]) + "<mo>;</mo>" + "<mo>,</mo>".join(cells[3:])
        result[screw_latex(vector)] = _fenced(inside)
    for expression in loci:
        result[f"{sympy.latex(expression)} = 0"] = _equation(expression)
    result.update({sympy.latex(e): f"<math>{_presented(e)}</math>" for e in single})
    return result | counts_as_mathml(as_lines(found.counts))


def _fenced(inside: str) -> str:
    return f"<math><mrow>{OPENING}(</mo>{inside}{CLOSING})</mo></mrow></math>"


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
