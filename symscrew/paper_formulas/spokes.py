r"""Inverse kinematics, Jacobian and statics of limbs that are spokes: a slider on the line between two points.

r_i = t + Q c_i - a_i, l_i = |r_i|, s_i = r_i / l_i; row of the Jacobian ((a_i x s_i) ; s_i); wrench (s_i ; a_i x s_i)
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy

from symscrew.description import Mechanism
from symscrew.paper_formulas.formula import Formula, Part, latex_of, vector_latex
from symscrew.paper_formulas.moved_rods import about_a_point
from symscrew.paper_formulas.named_lengths import Lengths


def spoke_part(mechanism: Mechanism, limbs: Sequence[Sequence[str]], lengths: Lengths) -> Part | None:
    """What the platform's pose gives for every limb that is a spoke with a driven slider; None without any."""
    spokes = {k: joints for k, joints in enumerate(limbs, 1) if is_spoke(mechanism, joints, lengths)}
    if not spokes:
        return None
    formulas = [formula for k, joints in spokes.items() for formula in _of_limb(mechanism, joints, k, lengths)]
    numbers = tuple(str(k) for k in spokes)
    formulas += [Formula(name, text, ("each", *numbers)) for name, text in GENERAL]
    words = (
        r"The platform's pose takes its points from the reference configuration to $\boldsymbol{t} + \boldsymbol{Q} "
        r"\boldsymbol{c}$; its twist is $(\boldsymbol{\omega} ; \boldsymbol{v}_O)$. Of limb $i$: $\boldsymbol{a}_i$ on "
        r"the base, $\boldsymbol{c}_i$ on the platform, the length $\lambda_i$ along $\boldsymbol{s}_i$ ($\lambda_{0i}$"
        r" in the reference configuration), the displacement $d_i$ of its slider, the wrench $\boldsymbol{w}_i$ "
        r"that lengthens the limb. The lengths change with $\dot \lambda_i = \boldsymbol{w}_i \circ "
        r"(\boldsymbol{\omega} ; \boldsymbol{v}_O)$, the reciprocal product; forces $u_i$ act on the platform with "
        r"$\sum_i u_i \boldsymbol{w}_i$, beside what the limbs forbid."
    )
    return Part("Inverse kinematics, rates and statics", words, tuple(formulas))


def is_spoke(mechanism: Mechanism, joints: Sequence[str], lengths: Lengths) -> bool:
    """Whether a limb is a driven slider on the line between an R, U or S on the base and one on the platform."""
    if len(joints) != 3:
        return False
    first, slider, last = (mechanism.joints[name] for name in joints)
    if not (about_a_point(first) and about_a_point(last)):
        return False
    if not slider.kind.slider or not slider.driven or first.driven or last.driven:
        return False
    bodies = (first.parent, first.child, last.child)
    if bodies != (mechanism.ground, slider.parent, mechanism.platform):
        return False
    way = sympy.Matrix(last.point) - sympy.Matrix(first.point)
    across = way.cross(sympy.Matrix(slider.axes[0]))
    return all(abs(lengths.number(e, other=other)) < 1e-12 for e in across for other in (False, True))  # m: rounding


def _of_limb(mechanism: Mechanism, joints: Sequence[str], number: int, lengths: Lengths) -> list[Formula]:
    """Points, the length in the reference configuration, and on which end the slider's axis points."""
    first, slider, last = (mechanism.joints[name] for name in joints)
    i = f"_{{{number}}}"
    start, end = (sympy.Matrix(j.point).applyfunc(lengths.named) for j in (first, last))
    way = sympy.Matrix(last.point) - sympy.Matrix(first.point)
    rest = lengths.distance(way)
    outwards = lengths.number((way.T @ sympy.Matrix(slider.axes[0]))[0]) > 0
    change = rf"\lambda{i} - \lambda_{{0{number}}}"
    return [
        Formula(rf"\boldsymbol{{a}}{i}", vector_latex(start, lengths.names)),
        Formula(rf"\boldsymbol{{c}}{i}", vector_latex(end, lengths.names)),
        Formula(rf"\lambda_{{0{number}}}", latex_of(rest, lengths.names)),
        Formula(f"d{i}", change if outwards else f"-({change})", ("displacement", slider.name, str(number))),
    ]


GENERAL = (
    (r"\boldsymbol{r}_{i}", r"\boldsymbol{t} + \boldsymbol{Q} \boldsymbol{c}_{i} - \boldsymbol{a}_{i}"),
    (r"\lambda_{i}", r"\sqrt{\boldsymbol{r}_{i} \cdot \boldsymbol{r}_{i}}"),
    (r"\boldsymbol{s}_{i}", r"\frac{\boldsymbol{r}_{i}}{\lambda_{i}}"),
    (
        r"\boldsymbol{w}_{i}",
        r"\begin{pmatrix} \boldsymbol{s}_{i} \\ \boldsymbol{a}_{i} \times \boldsymbol{s}_{i} \end{pmatrix}",
    ),
)
"""What is the same for every spoke, with its number for i."""
