"""Mobility in the reference configuration by reciprocal screws, eqs. (10)-(18), in 50 digits.

The null space of S_limb^T N is the limb's constraint system, the union over the limbs is the platform's,
and the twists reciprocal to the union are its freedoms. For the mechanism as a whole the closure of all
loops is written in the joint rates: mobility = number of joint freedoms - rank. Ranks are decided with 50
digits; the smallest pivot that was used and the largest number that was taken for zero are part of the result.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.joints import JOINT_TYPES
from symscrew.mechanism import Joint, Mechanism
from symscrew.operations import CONTEXT
from symscrew.screws import IDENTITY, Vector, cross, dot, helical, prismatic, revolute, scale, subtract
from symscrew.tape import high_precision

Row = list
ZERO_BELOW = CONTEXT.mpf(10) ** -35


@dataclass(frozen=True)
class ScrewSystem:
    """A null space: its basis (6-vectors) and the evidence for its dimension."""

    basis: tuple[tuple, ...]
    rank: int
    smallest_pivot: float
    largest_zero: float


@dataclass(frozen=True)
class LimbMobility:
    """A limb: the names of its joints, its screws (omega ; v) and its constraints (f ; m), at O."""

    name: str
    joints: tuple[str, ...]
    screws: tuple[tuple, ...]
    constraints: ScrewSystem


@dataclass(frozen=True)
class Mobility:
    """Mobility of a mechanism in its reference configuration.

    `dof`: instantaneous mobility of the whole; `kutzbach`: Kutzbach-Gruebler's count; `overconstraints`:
    their difference; `constraints` and `freedoms` of the platform (None without limbs); `method` says how
    ranks were decided.
    """

    mechanism: Mechanism
    dof: int
    kutzbach: int
    overconstraints: int
    limbs: tuple[LimbMobility, ...]
    constraints: ScrewSystem | None
    freedoms: ScrewSystem | None
    method: str

    def report(self) -> str:
        """The result in words, one line a fact."""
        lines = [
            f"{self.mechanism.name}: mobility {self.dof} in the reference configuration "
            f"(Kutzbach-Gruebler {self.kutzbach}, redundant constraints {self.overconstraints})"
        ]
        for limb in self.limbs:
            lines.append(f"{limb.name}: {len(limb.screws)} joint freedoms, {len(limb.constraints.basis)} constraints")
            lines += [f"    {describe_wrench(w)}" for w in limb.constraints.basis]
        if self.constraints is not None and self.freedoms is not None:
            lines.append(
                f"{self.mechanism.platform}: constraint system of rank {self.constraints.rank}, "
                f"{len(self.freedoms.basis)} freedoms"
            )
            lines += [f"    {describe_twist(t)}" for t in self.freedoms.basis]
        lines.append(self.method)
        return "\n".join(lines)


def analyse_mobility(mechanism: Mechanism) -> Mobility:
    """Mobility of the mechanism in its reference configuration."""
    screws = {name: joint_screws(mechanism, joint) for name, joint in mechanism.joints.items()}
    closure = _loop_matrix(mechanism, screws)
    freedoms = sum(len(s) for s in screws.values())
    system = null_space(closure, freedoms)
    loops = len(mechanism.joints) - (len(_bodies(mechanism)) - 1)
    kutzbach = freedoms - 6 * loops
    limbs = tuple(_limb(mechanism, name, limb.joints, screws) for name, limb in mechanism.limbs.items())
    constraints = platform_freedoms = None
    if limbs and mechanism.platform is not None:
        rows = [list(w) for limb in limbs for w in limb.constraints.basis]
        platform_freedoms = null_space([_swapped(row) for row in rows], 6)
        constraints = ScrewSystem(
            tuple(tuple(r) for r in rows),
            platform_freedoms.rank,
            platform_freedoms.smallest_pivot,
            platform_freedoms.largest_zero,
        )
    method = (
        f"ranks decided with 50 digits: smallest pivot {system.smallest_pivot:.1e}, "
        f"largest number taken for zero {system.largest_zero:.1e}"
    )
    return Mobility(
        mechanism, freedoms - system.rank, kutzbach, freedoms - system.rank - kutzbach, limbs, constraints,
        platform_freedoms, method,
    )  # fmt: skip


def joint_screws(mechanism: Mechanism, joint: Joint) -> list[tuple]:
    """Unit screws (omega ; v) of a joint's freedoms at O in the reference configuration, 50 digits."""
    point = _vector(mechanism, joint.point)
    axes = _axes(mechanism, joint)
    result = []
    for motion in JOINT_TYPES[joint.type].motions:
        if motion.kind == "S":
            result += [revolute(axis, point) for axis in IDENTITY]
            continue
        axis = axes[motion.axis or 0]
        if motion.kind == "P":
            result.append(prismatic(axis))
        elif motion.kind == "H":
            result.append(helical(axis, point, _number(mechanism, joint.pitch)))
        else:
            result.append(revolute(axis, point))
    return [tuple(CONTEXT.mpf(c) for c in screw.components) for screw in result]


def _number(mechanism: Mechanism, value: object) -> object:
    return high_precision(mechanism.number(value))  # type: ignore[arg-type]


def _vector(mechanism: Mechanism, values: Sequence) -> Vector:
    x, y, z = (_number(mechanism, v) for v in values)
    return (x, y, z)


def _axes(mechanism: Mechanism, joint: Joint) -> tuple[Vector, ...]:
    if joint.type == "free":
        return IDENTITY
    given = tuple(_vector(mechanism, axis) for axis in joint.axes)
    if joint.type != "E":
        return given
    normal = given[0]
    sizes = [abs(c) for c in normal]
    nearest = IDENTITY[sizes.index(min(sizes))]
    across = subtract(nearest, scale(dot(nearest, normal), normal))
    first = scale(1 / CONTEXT.sqrt(dot(across, across)), across)
    return (first, cross(normal, first), normal)


def _bodies(mechanism: Mechanism) -> set[str]:
    return {mechanism.ground, *mechanism.bodies}


def _loop_matrix(mechanism: Mechanism, screws: dict[str, list[tuple]]) -> list[Row]:
    """Six rows per independent loop: the signed screws of its joints add up to zero."""
    columns: dict[str, int] = {}
    for name in mechanism.joints:
        columns[name] = sum(len(screws[n]) for n in columns)
    total = sum(len(s) for s in screws.values())
    path: dict[str, list[tuple[str, int]]] = {mechanism.ground: []}
    used: set[str] = set()
    frontier = [mechanism.ground]
    while frontier:
        body = frontier.pop(0)
        for name, joint in mechanism.joints.items():
            for near, far, sign in ((joint.parent, joint.child, 1), (joint.child, joint.parent, -1)):
                if near == body and far not in path:
                    path[far] = [*path[body], (name, sign)]
                    used.add(name)
                    frontier.append(far)
    rows: list[Row] = []
    for name, joint in mechanism.joints.items():
        if name in used:
            continue
        block = [[CONTEXT.mpf(0)] * total for _ in range(6)]
        steps = [*path[joint.parent], (name, 1), *((n, -s) for n, s in reversed(path[joint.child]))]
        for step, sign in steps:
            for k, screw in enumerate(screws[step]):
                for i in range(6):
                    block[i][columns[step] + k] += sign * screw[i]
        rows += block
    return rows


def _limb(mechanism: Mechanism, name: str, joints: Sequence[str], screws: dict[str, list[tuple]]) -> LimbMobility:
    chain = tuple(s for joint in joints for s in screws[joint])
    # the wrench (f ; m) is reciprocal to (omega ; v): omega . m + v . f = 0
    system = null_space([[*s[3:], *s[:3]] for s in chain], 6)
    basis = tuple(_normalised(w) for w in system.basis)
    return LimbMobility(
        name,
        tuple(joints),
        chain,
        ScrewSystem(basis, system.rank, system.smallest_pivot, system.largest_zero),
    )


def _swapped(row: Sequence) -> Row:
    return [*row[3:], *row[:3]]


def _normalised(screw: Sequence) -> tuple:
    """First half of unit length if it is not zero, else the second half; first nonzero entry positive."""
    for half in (screw[:3], screw[3:]):
        size = CONTEXT.sqrt(sum(c * c for c in half))
        if size > ZERO_BELOW:
            sign = next(1 if c > 0 else -1 for c in half if abs(c) > ZERO_BELOW)
            return tuple(c * sign / size for c in screw)
    return tuple(screw)


def null_space(rows: Sequence[Sequence], columns: int) -> ScrewSystem:
    """Null space by Gauss-Jordan elimination with full pivoting, in 50 digits."""
    matrix = [list(row) for row in rows]
    largest = max((abs(c) for row in matrix for c in row), default=CONTEXT.mpf(1)) or CONTEXT.mpf(1)
    pivots: list[int] = []
    smallest, residue = float("inf"), 0.0
    for r in range(len(matrix)):
        candidates = [
            (abs(matrix[i][j]), i, j) for i in range(r, len(matrix)) for j in range(columns) if j not in pivots
        ]
        size, i, j = max(candidates, key=lambda c: c[0], default=(CONTEXT.mpf(0), r, 0))
        if size < ZERO_BELOW * largest:
            residue = max(residue, float(size))
            break
        smallest = min(smallest, float(size))
        matrix[r], matrix[i] = matrix[i], matrix[r]
        matrix[r] = [c / matrix[r][j] for c in matrix[r]]
        for k in range(len(matrix)):
            factor = matrix[k][j]
            if k != r and factor != 0:
                matrix[k] = [a - factor * b for a, b in zip(matrix[k], matrix[r], strict=True)]
        pivots.append(j)
    basis = []
    for free in (j for j in range(columns) if j not in pivots):
        vector = [CONTEXT.mpf(0)] * columns
        vector[free] = CONTEXT.mpf(1)
        for r, j in enumerate(pivots):
            value = -matrix[r][free]
            vector[j] = value if abs(value) > ZERO_BELOW else CONTEXT.mpf(0)
        basis.append(tuple(vector))
    return ScrewSystem(tuple(basis), len(pivots), smallest if pivots else float("nan"), residue)


def describe_wrench(wrench: Sequence) -> str:
    """A wrench in words: a force along a line, a couple, or a wrench with pitch."""
    return (
        f"{_words(wrench, 'force along', 'couple along', 'wrench along')}: ({_text(wrench[:3])}; {_text(wrench[3:])})"
    )


def describe_twist(twist: Sequence) -> str:
    """A twist in words: a rotation about a line, a translation, or a screw motion."""
    words = _words(twist, "rotation about", "translation along", "screw motion about")
    return f"{words}: ({_text(twist[:3])}; {_text(twist[3:])})"


def _words(screw: Sequence, line: str, free: str, general: str) -> str:
    direction, moment = tuple(screw[:3]), tuple(screw[3:])
    square = dot(direction, direction)
    if square < ZERO_BELOW:
        return f"{free} {_direction(moment)}"
    pitch = dot(direction, moment) / square
    point = scale(1 / square, cross(direction, moment))  # type: ignore[arg-type]
    place = "O" if all(abs(c) < ZERO_BELOW for c in point) else f"({_text(point)})"
    if abs(pitch) < ZERO_BELOW:
        return f"{line} {_direction(direction)} through {place}"
    return f"{general} {_direction(direction)} through {place}, pitch {float(pitch):.6g} m"


def _direction(vector: Sequence) -> str:
    size = max(abs(c) for c in vector)
    large = [i for i, c in enumerate(vector) if abs(c) > ZERO_BELOW * size]
    return "xyz"[large[0]] if len(large) == 1 else f"({_text(vector)})"


def _text(vector: Sequence) -> str:
    return ", ".join(f"{float(c):.6g}" for c in vector)
