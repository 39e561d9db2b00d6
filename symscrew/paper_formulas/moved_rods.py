r"""Inverse kinematics, Jacobian and statics of limbs whose drive on the base moves a rod to the platform.

|t + Q c_i - b_i| = rho_i, b_i the end of the rod that the driven joint moves:
    turn about e_i through a_i   b_i = a_i + cos theta_i m_i + sin theta_i n_i, n_i = e_i x m_i
    slide along e_i              b_i = a_i + d_i e_i
wrench of the rod w_i = (s_i ; b_i x s_i), w_i o (omega ; v_O) = j_i times the drive's rate

A point on all axes of a joint is fixed in both bodies of the joint, so that this holds for R, U and S at either end.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy

from symscrew.description import Joint, Mechanism
from symscrew.paper_formulas.formula import Formula, Part, latex_of, vector_latex
from symscrew.paper_formulas.named_lengths import Lengths

SHORT = 1e-9  # [m] of a rod or a crank that counts as none: doubles leave 1e-16


@dataclass(frozen=True)
class Rod:
    """A driven joint on the base, and the ends of the rod that it moves: all in the reference configuration."""

    drive: Joint
    start: sympy.Matrix
    end: sympy.Matrix
    turns: bool
    centre: sympy.Matrix
    axis: sympy.Matrix

    @property
    def arm(self) -> sympy.Matrix:
        """From the axis of a turn straight to the rod."""
        return self.start - self.centre


def about_a_point(joint: Joint) -> bool:
    """Whether a joint leaves a point where it is in both bodies."""
    return joint.kind.hinge or joint.kind.universal or joint.kind.ball


def rod_of(mechanism: Mechanism, joints: Sequence[str], lengths: Lengths) -> Rod | None:
    """The rod of a limb, or None: driven R or P on the base, then joints about a point at both ends of a rod."""
    if len(joints) != 3:
        return None
    drive, first, last = (mechanism.joints[name] for name in joints)
    if not (drive.kind.hinge or drive.kind.slider) or not drive.driven or first.driven or last.driven:
        return None
    if not (about_a_point(first) and about_a_point(last)):
        return None
    if drive.parent != mechanism.ground or last.child != mechanism.platform:
        return None
    if first.parent != drive.child or last.parent != first.child:
        return None
    start, end, axis = sympy.Matrix(first.point), sympy.Matrix(last.point), sympy.Matrix(drive.axes[0])
    turns, foot = drive.kind.hinge, sympy.Matrix(drive.point)
    centre = foot + axis * axis.dot(start - foot) if turns else start
    rod = Rod(drive, start, end, turns, centre, axis)
    if _size(end - start, lengths) < SHORT or (rod.turns and _size(rod.arm, lengths) < SHORT):
        return None
    return rod


def _size(vector: sympy.Matrix, lengths: Lengths) -> float:
    return max(abs(lengths.number(entry)) for entry in vector)


def rod_part(mechanism: Mechanism, limbs: Sequence[Sequence[str]], lengths: Lengths) -> Part | None:
    """What the platform's pose gives for every drive that moves a rod; None without any.

    Of several rods that one drive moves the first is enough: the others give the same.
    """
    rods: dict[int, Rod] = {}
    for number, joints in enumerate(limbs, 1):
        rod = rod_of(mechanism, joints, lengths)
        if rod is not None and all(rod.drive.name != other.drive.name for other in rods.values()):
            rods[number] = rod
    if not rods:
        return None
    formulas = [formula for k, rod in rods.items() for formula in _geometry(rod, k, lengths)]
    formulas += _each(rods, BEFORE)
    formulas += [_drive(rod, k, lengths) for k, rod in rods.items()]
    formulas += _each(rods, AFTER)
    return Part("Inverse kinematics, rates and statics of rods", _words(rods), tuple(formulas))


def _words(rods: dict[int, Rod]) -> str:
    turn, slide = (any(rod.turns is turns for rod in rods.values()) for turns in (True, False))
    moved = []
    if turn:
        moved.append(
            r"a crank $\boldsymbol{m}_i$ that turns by $\theta_i$ about $\boldsymbol{e}_i$ through $\boldsymbol{a}_i$"
        )
    if slide:
        moved.append(r"a slider that moves by $d_i$ along $\boldsymbol{e}_i$ from $\boldsymbol{a}_i$")
    drives = ", ".join(f"{rod.drive.name} in limb {k}" for k, rod in rods.items())
    return (
        r"The platform's pose takes its points from the reference configuration to $\boldsymbol{t} + \boldsymbol{Q} "
        r"\boldsymbol{c}$; its twist is $(\boldsymbol{\omega} ; \boldsymbol{v}_O)$. Limb $i$ has "
        f"{' or '.join(moved)}, and a rod of length "
        r"$\rho_i$ from there to $\boldsymbol{c}_i$ on the platform, along $\boldsymbol{s}_i$, with the wrench "
        r"$\boldsymbol{w}_i$. The sign before the root is that of the reference configuration; the other one is the "
        r"other way to put the limb together. Rates: $j_i$ times the drive's rate is $\boldsymbol{w}_i \circ "
        r"(\boldsymbol{\omega} ; \boldsymbol{v}_O)$, the reciprocal product; a torque or force $\tau_i$ of the drive "
        r"acts on the platform with $\tau_i \boldsymbol{w}_i / j_i$, beside what the limb forbids. "
        f"Drives: {drives}."
    )


def _geometry(rod: Rod, number: int, lengths: Lengths) -> list[Formula]:
    """Points, axis, crank and length of a limb's rod."""
    vectors = {"a": rod.centre, "e": rod.axis} | ({"m": rod.arm} if rod.turns else {}) | {"c": rod.end}
    made = [
        Formula(rf"\boldsymbol{{{letter}}}_{{{number}}}", vector_latex(lengths.constant(vector), lengths.names))
        for letter, vector in vectors.items()
    ]
    return [*made, Formula(rf"\rho_{{{number}}}", latex_of(lengths.distance(rod.end - rod.start), lengths.names))]


def _each(rods: dict[int, Rod], general: Sequence[tuple[str, str, str]]) -> list[Formula]:
    """Formulas that are the same for every rod of their kind, with its number for i."""
    made = []
    for kinds, name, text in general:
        numbers = tuple(str(k) for k, rod in rods.items() if ("turn" if rod.turns else "slide") in kinds)
        if numbers:
            made.append(Formula(name, text, ("each", *numbers)))
    return made


def _drive(rod: Rod, number: int, lengths: Lengths) -> Formula:
    """The drive's displacement, on the side of the reference configuration."""
    i = f"_{{{number}}}"
    way = rod.end - rod.centre
    if rod.turns:
        side = lengths.number(rod.axis.cross(rod.arm).dot(way))
        sign = "-" if side > 0 else "+"
        root = rf"\arccos \frac{{k{i}}}{{\sqrt{{x{i}^{{2}} + y{i}^{{2}}}}}}"
        text = rf"\operatorname{{atan2}}(y{i}, x{i}) {sign} {root}"
        return Formula(rf"\theta{i}", text, ("drive", rod.drive.name, str(number)))
    sign = "-" if lengths.number(rod.axis.dot(way)) > 0 else "+"
    root = rf"\sqrt{{x{i}^{{2}} - \boldsymbol{{r}}{i} \cdot \boldsymbol{{r}}{i} + \rho{i}^{{2}}}}"
    return Formula(f"d{i}", rf"x{i} {sign} {root}", ("drive", rod.drive.name, str(number)))


BEFORE = (
    ("turn", r"\boldsymbol{n}_{i}", r"\boldsymbol{e}_{i} \times \boldsymbol{m}_{i}"),
    ("turn slide", r"\boldsymbol{r}_{i}", r"\boldsymbol{t} + \boldsymbol{Q} \boldsymbol{c}_{i} - \boldsymbol{a}_{i}"),
    ("turn", "x_{i}", r"\boldsymbol{m}_{i} \cdot \boldsymbol{r}_{i}"),
    ("turn", "y_{i}", r"\boldsymbol{n}_{i} \cdot \boldsymbol{r}_{i}"),
    (
        "turn",
        "k_{i}",
        r"\frac{\boldsymbol{r}_{i} \cdot \boldsymbol{r}_{i} + \boldsymbol{m}_{i} \cdot \boldsymbol{m}_{i} "
        r"- \rho_{i}^{2}}{2}",
    ),
    ("slide", "x_{i}", r"\boldsymbol{e}_{i} \cdot \boldsymbol{r}_{i}"),
)
"""What drives need: kinds of rods, name and text with the limb's number for i."""

AFTER = (
    (
        "turn",
        r"\boldsymbol{b}_{i}",
        r"\boldsymbol{a}_{i} + \cos(\theta_{i}) \boldsymbol{m}_{i} + \sin(\theta_{i}) \boldsymbol{n}_{i}",
    ),
    ("slide", r"\boldsymbol{b}_{i}", r"\boldsymbol{a}_{i} + d_{i} \boldsymbol{e}_{i}"),
    (
        "turn slide",
        r"\boldsymbol{s}_{i}",
        r"\frac{\boldsymbol{t} + \boldsymbol{Q} \boldsymbol{c}_{i} - \boldsymbol{b}_{i}}{\rho_{i}}",
    ),
    (
        "turn slide",
        r"\boldsymbol{w}_{i}",
        r"\begin{pmatrix} \boldsymbol{s}_{i} \\ \boldsymbol{b}_{i} \times \boldsymbol{s}_{i} \end{pmatrix}",
    ),
    (
        "turn",
        "j_{i}",
        r"\boldsymbol{s}_{i} \cdot \left(\boldsymbol{e}_{i} \times \left(\boldsymbol{b}_{i} - "
        r"\boldsymbol{a}_{i}\right)\right)",
    ),
    ("slide", "j_{i}", r"\boldsymbol{s}_{i} \cdot \boldsymbol{e}_{i}"),
)
"""The same for rates and forces."""
