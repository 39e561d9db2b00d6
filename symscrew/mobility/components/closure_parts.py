"""What the closure of a mechanism as polynomials is made of: its variables, and limbs between two bodies.

freedoms of a chain --as few as leave a tail that its forms cut out--> variables, forms of the rest
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from symscrew.mobility.components.limb_equations import LARGEST_CHAIN, Form, Screw, cut_out, implicit_forms
from symscrew.mobility.components.polynomials import Polynomial
from symscrew.mobility.symbols import Exact, Field

MOST_VARIABLES = 40
"""Beyond it no decomposition ends in reasonable time: twenty planar bodies."""
CHARTS = tuple(Fraction(a, b) for a, b in ((3, 7), (-5, 11), (2, 9), (-4, 13), (6, 17), (-1, 5)))
"""Tangents, negative, at which joint variables are in the reference. A component on which a joint rests exactly half a
turn from where its variable is zero is missed in this chart, and seen in others, which begin later in this list
(`charts.held_components`); no description prefers these."""
SETTLED = 2
"""Freedoms at the end of a limb, with independent screws, whose displacements the pose and the other variables fix."""
Vector = tuple[Exact, Exact, Exact]


class NotAlgebraicError(ValueError):
    """The closure has no such polynomials; the text says why."""


@dataclass(frozen=True)
class Length:
    """A variable that a freedom's displacement sets: joint, which of its freedoms, in which sense, screw, zero.

    `zero`: the tangent that the variable lacks; None of a planar mechanism's slide, where the variable times the screw
    is the displacement itself.
    """

    joint: str
    freedom: int
    sign: int
    screw: Screw
    zero: Fraction | None


@dataclass(frozen=True)
class ClosureEquations:
    """Polynomials that are zero at all configurations, with the variables' names and meaning.

    `reference`: the variables' values there; `scaled`: those of which only ratios matter (Study's parameters, none
    for planar ones); `excluded`: polynomials that vanish at no configuration; `subject`: what the variables fix;
    `body`: whose pose against `base` it is; empty of planar mechanisms, for which `axis` and `turning` name the axis
    and the bodies of the cosines and sines; `lengths`: the variables of single freedoms, slides or joints of limbs;
    `settles`: whether the variables fix the displacements of all joints of the loops, so that no two configurations are
    one zero, and no zero is beyond the reach of a limb.
    """

    variables: tuple[str, ...]
    equations: tuple[Polynomial, ...]
    reference: tuple[Exact, ...]
    scaled: tuple[int, ...]
    excluded: tuple[Polynomial, ...]
    field: Field
    subject: str
    base: str = ""
    body: str = ""
    axis: Vector | None = None
    turning: tuple[str, ...] = ()
    lengths: tuple[Length, ...] = ()
    settles: bool = True


Step = tuple[str, int, int, Screw]
"""Joint, its freedom, the sense in which it is passed, and the screw."""


@dataclass(frozen=True)
class Limb:
    """A chain from base to body: screws of the freedoms that stay variables, and forms of what follows them."""

    heads: tuple[Step, ...]
    forms: tuple[Form, ...]
    settled: bool


def turned_to(screw: Screw, tangent: Fraction) -> list[Exact]:
    """The displacement along a freedom by an angle whose half has this tangent, over |w|."""
    scaled = [tangent * c for c in screw]
    return [Fraction(1), *scaled[:3], Fraction(0), *scaled[3:]]


def limb_of(steps: Sequence[Step], *, single: bool) -> Limb:
    """A limb of which as few freedoms stay variables as leave a tail that its forms cut out.

    Of a single loop all but two, so that the variables fix every joint.
    """
    for heads in range(max(0, len(steps) - 2) if single else 0, len(steps) + 1):
        tail = [screw for *_, screw in steps[heads:]]
        if len(tail) <= LARGEST_CHAIN:
            forms = implicit_forms(tail)
            if cut_out(tail, forms):
                return Limb(tuple(steps[:heads]), tuple(forms), _settled(tail))
    raise NotAlgebraicError("a limb that its equations do not cut out")


def _settled(tail: Sequence[Screw]) -> bool:
    """Whether a pose of the tail fixes its displacements: of two freedoms unless they are about or along one line."""
    if len(tail) < SETTLED:
        return True
    one, two = tail[0], tail[-1]
    pairs = ((i, j) for i in range(len(one)) for j in range(i))
    return len(tail) == SETTLED and any(one[i] * two[j] - one[j] * two[i] for i, j in pairs)
