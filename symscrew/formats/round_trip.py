"""What a file in another format keeps of a mechanism: the same names, joints and places, inertias to rounding.

Mechanism --writer--> file --reader--> Mechanism --difference--> None, or the first thing that is not the same
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from symscrew.description import Joint, Mechanism, slope
from symscrew.formats.mjcf_couplings import reference_value
from symscrew.reference import NumericMechanism, numeric, rotation_about

PLACES = 1e-14
"""Of the mechanism's size, at least 1 m: what doubles in a file lose of a coordinate. More is another place."""
INERTIA = 1.1e-9
"""Of the whole: what MJCF raises bodies without inertia to (1e-9), and rounding. More is another inertia."""
RATIO = 1e-12
"""Of a ratio of a coupling: what doubles in a file lose of it."""
CONSTANT = ("", 0)
"""Key of what a coupling's sum is, beside those of its coordinates."""
KEPT = ("R", "P", "fixed")
"""Types of joints that every format has; others come back as chains of them where a format lacks them."""
TURNED_ROUND = (*KEPT, "H")
"""Types whose axis comes back the other way round where the tree comes to the joint from its child."""

Array = NDArray[np.float64]


def difference(written: Mechanism, read: Mechanism) -> str | None:
    """The first thing in which a mechanism that was read back differs from the one that was written, or None.

    Bodies that the format adds (copies at cut joints, the links of chains) are left out, as are joints between them.
    A URDF has no reference values of its own: what is read is compared where its coordinates have those of `written`.
    """
    missing = [body for body in written.bodies if body not in read.bodies]
    if missing:
        return f"body {missing[0]} is missing"
    a, b = numeric(written), _where_it_was(written, numeric(read))
    whole = a.mass.sum() or 1.0
    for name, body in written.bodies.items():
        i, j = a.bodies.index(name), b.bodies.index(name)
        if name == written.ground or body.mass is None:
            continue
        inertia = np.abs(a.inertia[i] - b.inertia[j]).max() / a.length**2
        if max(abs(a.mass[i] - b.mass[j]), inertia) > INERTIA * whole or _apart(a.com[i], b.com[j], a.length):
            return f"body {name} has another inertia"
    for name, joint in written.joints.items():
        other = read.joints.get(name)
        if other is not None and {other.parent, other.child} == {joint.parent, joint.child}:
            found = _joint(a, b, joint, other)
            if found:
                return f"joint {name}: {found}"
        elif other is None and joint.type in KEPT:
            return f"joint {name} is missing"
    return _couplings(written, read)


def _where_it_was(written: Mechanism, read: NumericMechanism) -> NumericMechanism:
    """A tree that was read in the configuration where its coordinates have the values of `written`'s reference."""
    steps = {}
    for j, name in enumerate(read.joints):
        given = np.zeros(len(read.freedoms[j]))
        if name in written.joints:
            wanted, own = ([float(m.number(x)) for x in m.joints[name].reference] for m in (written, read.mechanism))
            given[: max(len(wanted), len(own))] += np.subtract(wanted or 0.0, own or 0.0)
        steps[j] = given
    if not any(given.any() for given in steps.values()):
        return read
    moved = {0: (np.eye(3), np.zeros(3))}
    while len(moved) < len(read.bodies):
        for j, given in steps.items():
            parent, child = int(read.parents[j]), int(read.children[j])
            if (parent in moved) == (child in moved):
                continue
            turn, shift = np.eye(3), np.zeros(3)
            for k, amount in zip(read.freedoms[j], given, strict=True):
                about = rotation_about(amount * read.turns[k] * read.axes[k])
                slid = amount * read.slides[k] * read.axes[k] + read.points[j] - about @ read.points[j]
                turn, shift = turn @ about, turn @ slid + shift
            inward, outer = (parent, child) if parent in moved else (child, parent)
            if inward == child:
                turn, shift = turn.T, -turn.T @ shift
            rotation, place = moved[inward]
            moved[outer] = (rotation @ turn, rotation @ shift + place)
    order = [moved[i] for i in range(len(read.bodies))]
    return replace(
        read,
        com=np.array([r @ at + p for (r, p), at in zip(order, read.com, strict=True)]),
        inertia=np.array([r @ i @ r.T for (r, _), i in zip(order, read.inertia, strict=True)]),
        points=np.array([order[c][0] @ at + order[c][1] for c, at in zip(read.children, read.points, strict=True)]),
        axes=np.array([order[c][0] @ axis for c, axis in zip(read.carriers, read.axes, strict=True)]).reshape(-1, 3),
    )


def _couplings(written: Mechanism, read: Mechanism) -> str | None:
    """Couplings come back with the same ratios of their slopes, and the same constant, under any name."""
    wanted, found = ({name: _ratios(m, name) for name in m.couplings} for m in (written, read))
    for name, ratios in wanted.items():
        if not any(_equal(ratios, other) for other in found.values()):
            return f"coupling {name} is missing, or has another ratio"
    return None


def _ratios(mechanism: Mechanism, name: str) -> dict[tuple[str, int], float]:
    terms = mechanism.couplings[name].terms
    values = {(term.joint, term.motion): float(mechanism.number(slope(mechanism, term))) for term in terms}
    first = next(value for key, value in sorted(values.items()) if value)
    at = [reference_value(mechanism, term) for term in terms]
    powers = [[float(mechanism.number(c)) for c in term.coefficients] for term in terms]
    constant = sum(c * x**k for x, listed in zip(at, powers, strict=True) for k, c in enumerate(listed, start=1))
    return {CONSTANT: constant / first} | {key: value / first for key, value in values.items()}


def _equal(one: dict[tuple[str, int], float], other: dict[tuple[str, int], float]) -> bool:
    least = {key: 1.0 if key == CONSTANT else 0.0 for key in one}
    return set(one) == set(other) and all(
        abs(one[key] - other[key]) <= RATIO * max(abs(one[key]), least[key]) for key in one
    )


def _joint(a: NumericMechanism, b: NumericMechanism, one: Joint, other: Joint) -> str | None:
    if (one.type, one.driven) != (other.type, other.driven):
        return f"type and drives were {one.type} {one.driven}, came back as {other.type} {other.driven}"
    i, j = a.joints.index(one.name), b.joints.index(one.name)
    if _apart(a.points[i], b.points[j], a.length):
        return f"its point was {a.points[i]}, came back as {b.points[j]}"
    turned = 1 if one.parent == other.parent or one.type not in TURNED_ROUND else -1
    axes = (a.axes[a.freedoms[i]], turned * b.axes[b.freedoms[j]])
    if axes[0].shape != axes[1].shape or _apart(*axes, 1.0):
        return f"its axes were {axes[0]}, came back as {axes[1]}"
    return None


def _apart(first: Array, second: Array, size: float) -> bool:
    return bool(np.abs(first - second).max(initial=0.0) > PLACES * max(size, 1.0))
