"""The screws of a mechanism over an exact field: what ranks without rounding are taken of.

    Mechanism --exact_system--> screws of every freedom --loop_rows--> the closure's rows, over one `Field`

Directions need no unit length: a screw times a number spans the same line, and a root less keeps the field small.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy

from symscrew.algebra import IDENTITY, Vector, cross, dot, scale, subtract
from symscrew.description import Joint, Mechanism, slope
from symscrew.kinematics import motion_screws
from symscrew.mobility.joint_network import Network
from symscrew.mobility.symbols.exact_field import Field
from symscrew.mobility.symbols.exact_numbers import Exact

Row = list[Exact]


@dataclass(frozen=True)
class ExactSystem:
    """Exact screws (directions of any length) of every joint's freedoms, at O, in metres; their field."""

    field: Field
    screws: Mapping[str, tuple[tuple[Exact, ...], ...]]


def exact_system(mechanism: Mechanism, further: Sequence[sympy.Expr] = ()) -> ExactSystem:
    """The screws of all joints in the reference configuration; raises NotDecidableError where there is no field.

    `further`: numbers whose angles must have a place in the field, too.
    """
    number = mechanism.number
    points = {name: [number(c) for c in joint.point] for name, joint in mechanism.joints.items()}
    axes = {name: [[number(c) for c in axis] for axis in joint.axes] for name, joint in mechanism.joints.items()}
    pitches = {name: number(j.pitch) for name, j in mechanism.joints.items() if j.pitch is not None}
    every = [*(c for p in points.values() for c in p), *(c for a in axes.values() for x in a for c in x),
             *pitches.values(), *further,
             *(number(slope(mechanism, t)) for c in mechanism.couplings.values() for t in c.terms)]  # fmt: skip
    field = Field(every)
    directions = {name: [field.direction(axis) for axis in given] for name, given in axes.items()}
    screws = {}
    for name, joint in mechanism.joints.items():
        pitch = field.read(pitches[name]) if name in pitches else Fraction(0)
        # only the line matters: any of its points will do, and the pure direction of a slider needs none
        turns = any(motion.turns for motion in joint.kind.motions)
        point = [field.read(c) for c in points[name]] if turns else [Fraction(0)] * 3
        screws[name] = _screws(joint, point, directions[name], pitch)
    return ExactSystem(field, screws)


def _screws(
    joint: Joint, point: Sequence[Exact], axes: Sequence[Sequence[Exact]], pitch: Exact
) -> tuple[tuple[Exact, ...], ...]:
    given = [(a[0], a[1], a[2]) for a in axes]
    triad = joint.kind.motion_axes(given, IDENTITY, lambda normal: across(normal, [bool(c) for c in normal])[:2])
    made = motion_screws(joint.kind, triad, (point[0], point[1], point[2]), pitch)
    return tuple(tuple(_exact(c) for c in twist.components) for _, twists in made for twist in twists)


def _exact(entry: Exact | int) -> Exact:
    return Fraction(entry) if isinstance(entry, int) else entry


def across(normal: Sequence[Exact], present: Sequence[bool]) -> tuple[Vector, Vector, Vector]:
    """Two directions across the normal and the normal, mutually perpendicular, over any scalars, without roots.

    `present`: which components of the normal are not zero.
    """
    n = (normal[0], normal[1], normal[2])
    nearest = IDENTITY[min(range(3), key=lambda k: present[k])]
    first = subtract(scale(dot(n, n), nearest), scale(dot(nearest, n), n))
    return (first, cross(n, first), n)


def unmeasured_plane(joints: Iterable[Joint], number: Callable[[sympy.Expr], sympy.Expr]) -> str:
    """Why displacements in the plane of a joint have no symbols; empty where `across` has unit directions for all.

    Across a normal with a component that is zero an absolute axis is one of the directions; of others the lengths are
    roots, so that symbols along them would not be lengths. `number`: an expression at the parameters' values.
    """
    for joint in joints:
        if joint.kind.planar and all(number(c) != 0 for c in joint.axes[0]):
            return f"no symbols: unit directions in the plane of {joint.name}, across no absolute axis, are roots"
    return ""


def loop_rows(network: Network, system: ExactSystem, loop: Sequence[tuple[str, int]]) -> list[Row]:
    """Six rows over all joint freedoms: the signed screws of the joints on the way."""
    rows: list[Row] = [[Fraction(0)] * network.freedoms for _ in range(6)]
    for name, sign in loop:
        for column, screw in zip(network.edges[name].columns, system.screws[name], strict=True):
            for i in range(6):
                rows[i][column] = sign * screw[i]
    return rows


ExactTie = tuple[tuple[str, int, Exact], ...]
"""The slopes of a coupling in the reference configuration: (joint, motion, slope)."""


def coupled_lengths(mechanism: Mechanism, system: ExactSystem) -> dict[tuple[str, int], Exact]:
    """(joint, freedom) -> the length of the exact direction of a coupled coordinate, by which its rate is divided.

    Raises:
        NotDecidableError: more roots than a field may have.
    """
    lengths: dict[tuple[str, int], Exact] = {}
    for term in (term for coupling in mechanism.couplings.values() for term in coupling.terms):
        kind = mechanism.joints[term.joint].kind
        screw = system.screws[term.joint][kind.starts[term.motion]]
        axis = screw[:3] if kind.motions[term.motion].turns else screw[3:]
        square = sum((c * c for c in axis), Fraction(0))
        lengths[term.joint, kind.starts[term.motion]] = system.field.sqrt(square)
    return lengths


def exact_ties(mechanism: Mechanism, system: ExactSystem) -> tuple[ExactTie, ...]:
    """The couplings' slopes over the field of the screws, for rates along the exact directions.

    Raises:
        NotDecidableError: a slope or the length of a direction has no place in the field.
    """
    lengths = coupled_lengths(mechanism, system)
    made = []
    for coupling in mechanism.couplings.values():
        entries = []
        for term in coupling.terms:
            along = lengths[term.joint, mechanism.joints[term.joint].kind.starts[term.motion]]
            entries.append(
                (term.joint, term.motion, system.field.read(mechanism.number(slope(mechanism, term))) * along)
            )
        made.append(tuple(entries))
    return tuple(made)


def tie_row(network: Network, system: ExactSystem, tie: ExactTie) -> Row:
    """The row of a coupling over all joint freedoms."""
    row: Row = [Fraction(0)] * network.freedoms
    for joint, motion, value in tie:
        row[network.tied_column(joint, motion)] += value
    return row
