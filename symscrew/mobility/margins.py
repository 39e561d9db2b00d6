"""How far a configuration is from a singularity of each of three kinds: numbers of q that vanish exactly there.

Limb (serial) singularity: the joint screws of a limb become dependent. Constraint singularity: the closure of
the loops loses rank, so that the mechanism gains a freedom whatever its drives do. Actuation singularity: with
the drives locked a freedom is left. C. Gosselin, J. Angeles, IEEE Trans. Robotics Autom. 6 (1990) 281-290 (limb
and actuation as types 1 and 2); D. Zlatanov, I. Bonev, C. Gosselin, IEEE ICRA 2002, 496-502 (constraint).

Every margin is a volume: a determinant of screws or wrenches with lengths divided by the characteristic length,
unit 1, a polynomial in coordinates, sines and cosines. It is finite everywhere, at the singularity too, because
nothing is divided. Where the matrix is square the determinant is signed, positive in the reference configuration,
and changes sign through a generic singularity. Where it is not (fewer than six screws, redundant joints or
drives), rank is lost on a set of two or more dimensions less than the configurations', which no number can pass
with a change of sign; the margin is then the squared volume, the sum of the squares of all maximal minors.

The kinds are kept apart: the rates that only one cut joint's rows know are eliminated with the wrenches
reciprocal to them (minors without their common factor), so that the platform's determinants do not vanish where
only a limb is singular. Which entries, rows and columns are zero is read from the sample states: on the closure
manifold, on the assembly branch of the reference configuration.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from math import comb

import numpy as np

from symscrew.algebra import (
    IDENTITY,
    NEGLIGIBLE,
    ZERO,
    Grid,
    Node,
    Tape,
    TooLargeError,
    Vector,
    Volume,
    dot,
    rank_of,
    reciprocal_factors,
    sampled,
    scale,
    transform,
    trimmed,
    vanishes,
    volume,
    zeroed,
)
from symscrew.description import Motion, rotation
from symscrew.kinematics import GROUND, Cut, Row, System, pair_of, universal_axes

LONG = 10  # limbs with more freedoms are not looked at from all of their links
MOST_SUBSETS = 20  # sets of drives that get a margin of their own

FORMS = {
    "signed": "signed volume",
    "squared": "squared volume",
    "mixed": "signed volume of a part times squared volume of the rest",
}


@dataclass(frozen=True)
class Margin:
    """`value` is zero exactly at the singularity [1]. `kind`: limb, constraint or actuation.

    `name`: the limb, the platform, or the drives that are locked. `form`: see `Volume`; signed and mixed ones are
    positive in the reference configuration or, where they are zero there, at the next sample state.
    """

    kind: str
    name: str
    value: Node
    form: str
    meaning: str


def limb_margins(system: System) -> tuple[Margin, ...]:
    """One margin for every limb: volume of its joint screws (omega ; v / length).

    Without described limbs: the open chain, or the chain of joints that belongs to one cut joint alone; and, with
    the platform held at rest, whether the others can still move (type 1 of Gosselin and Angeles).
    """
    result = []
    for name, joints in limbs(system).items():
        made = _attempt(lambda joints=joints: _limb_volume(system, joints))  # type: ignore[misc]
        if made is not None:
            text = f"joint screws of {name} become dependent"
            result.append(_margin(system, "limb", name, made, text))
    platform = system.mechanism.platform
    if system.cuts and not system.mechanism.limbs and platform is not None:
        path = system.tree.path(system.tree.link_of_body[platform])
        held = {k for i in path for k in range(system.tree.links[i].v.start, system.tree.links[i].v.stop)}
        grid = _Closure(system).grid((), held)
        made = _attempt(lambda: _closure_volume(system, grid))
        if made is not None:
            result.append(_margin(system, "limb", platform, made, f"joints can move while {platform} rests"))
    return tuple(result)


def constraint_margins(system: System) -> tuple[Margin, ...]:
    """The rank of the closure with all drives free; none for an open chain or a platform without constraints."""
    grid = _Closure(system).grid(())
    made = _attempt(lambda: _closure_volume(system, grid)) if grid else None
    if made is None:
        return ()
    name = system.mechanism.platform or "closure"
    return (_margin(system, "constraint", name, made, "the constraints lose rank: a freedom more, drives or not"),)


def actuation_margins(system: System) -> tuple[Margin, ...]:
    """With all drives locked; where there are more drives than freedoms also with every set that is just enough."""
    if not system.cuts or not system.drives:
        return ()
    closure = _Closure(system)
    every = tuple(range(len(system.drives)))
    chosen = [every]
    freedoms = closure.freedoms
    if 0 < freedoms < len(every) and comb(len(every), freedoms) <= MOST_SUBSETS:
        chosen += list(combinations(every, freedoms))
    result = []
    for locked in chosen:
        made = _attempt(lambda locked=locked: _closure_volume(system, closure.grid(locked)))  # type: ignore[misc]
        if made is not None and closure.left(locked) == closure.left(every):
            name = "all drives" if locked == every else " ".join(_drive_name(system, k) for k in locked)
            text = f"a freedom is left with {name} locked"
            result.append(_margin(system, "actuation", name, made, text))
    return tuple(result)


def limbs(system: System) -> dict[str, tuple[str, ...]]:
    """Name -> joints of every chain that has a margin of its own."""
    mechanism, tree = system.mechanism, system.tree
    if mechanism.limbs:
        return {name: limb.joints for name, limb in mechanism.limbs.items()}
    if not system.cuts:
        end = mechanism.platform or list(mechanism.bodies)[-1]
        path = reversed(tree.path(tree.link_of_body[end]))
        return {end: tuple(dict.fromkeys(tree.links[i].joint for i in path))}
    closure = _Closure(system)
    if not closure.shared:
        return {}
    owner = {k: link.joint for link in tree.links[1:] for k in range(link.v.start, link.v.stop)}
    chains = {}
    for cut, private in zip(system.cuts, closure.private, strict=True):
        if private:
            chains[cut.joint.name] = (*dict.fromkeys(owner[k] for k in private), cut.joint.name)
    return chains


def _drive_name(system: System, index: int) -> str:
    joint, freedom = system.drives[index]
    single = system.mechanism.joints[joint].kind.freedom == 1
    return joint if single else f"{joint}.{freedom}"


def _margin(system: System, kind: str, name: str, made: Volume, text: str) -> Margin:
    value = made.value
    if made.form != "squared":
        samples = np.atleast_1d(system.tape.sample(value))
        first = next((x for x in samples if abs(x) > NEGLIGIBLE), 1.0)
        value = -value if first < 0 else value
    return Margin(kind, name, value, made.form, f"{FORMS[made.form]}; 0: {text}")


def _attempt(make: Callable[[], Volume | None]) -> Volume | None:
    try:
        return make()
    except TooLargeError:
        return None


# -- limbs ----------------------------------------------------------------------------------------------


def _limb_volume(system: System, joints: Sequence[str]) -> Volume:
    """In the axes of the limb's link in which most entries are zero; signed where the span is constant in one."""
    tape = system.tape
    pieces = [piece for joint in joints for piece in _pieces(system, joint)]
    best: tuple[tuple, Grid] | None = None
    for frame in _candidate_frames([link for link, *_ in pieces]):
        columns = [_seen(system, piece, frame, known=len(pieces) > LONG) for piece in pieces]
        grid = zeroed(tape, [[column[i] for column in columns] for i in range(6)])
        rows = _constant_span(tape, grid)
        entries = [e for row in grid for e in row if e is not tape.zero]
        rank = (rows is None, sum(e.value is None for e in entries), len(entries))
        if best is None or rank < best[0]:
            best = (rank, [grid[i] for i in rows] if rows is not None else grid)
    if best is None:
        return Volume(tape.one, "signed")
    return volume(tape, best[1], rank_of(tape, best[1]))


def _candidate_frames(links: Sequence[int]) -> list[int]:
    """The links in whose axes a limb is looked at: all of it, of a long one the ground only, where poses are known."""
    found = list(dict.fromkeys([*links, GROUND]))
    return found if len(found) <= LONG + 1 else [GROUND]


Piece = tuple[int, Motion, Vector, Vector, object]


def _pieces(system: System, name: str) -> list[Piece]:
    """(link, motion, axis, point, pitch) of every freedom of a joint, in coordinates of a link."""
    cut = next((c for c in system.cuts if c.joint.name == name), None)
    if cut is not None:
        return _cut_pieces(system, cut)
    result: list[Piece] = []
    for link in system.tree.links_of(name):
        frame = system.frames[link.index]
        if link.motion.spherical:
            result += [(link.index, rotation(), axis, ZERO, None) for axis in IDENTITY]
        elif link.motion.single:  # a slider keeps its parent's axes
            axis = (0, 0, 1) if link.motion.turns else frame.axis
            result.append((link.index, link.motion, axis, ZERO, frame.pitch))
    return result


def _cut_pieces(system: System, cut: Cut) -> list[Piece]:
    kind = cut.joint.kind
    if kind.spherical:
        return [(cut.tip, rotation(), axis, cut.tip_point, None) for axis in IDENTITY]
    axes = universal_axes(cut, system.linkage) if kind.universal else cut.tip_axes
    pitch = system.geometry.scalar(cut.joint.pitch) if cut.joint.pitch is not None else None
    return [(cut.tip, m, axes[m.axis or 0], cut.tip_point, pitch) for m in kind.motions]


def _seen(system: System, piece: Piece, frame: int, *, known: bool = False) -> list[Node]:
    """The unit screw of a freedom (omega ; v / length) at the origin and in the axes of a link.

    Joint after joint between the two, or with `known` from the poses, which all of a long limb's screws share.
    """
    link, motion, axis, point, pitch = piece
    tape = system.tape
    by_pose = known and frame == GROUND and link != GROUND
    pose = system.pose[link]
    axis = transform(pose.rotation, axis) if by_pose else system.linkage.carry(link, frame, axis)
    if not motion.turns:
        (twist,) = pair_of(motion).screws(axis, ZERO, pitch)
        linear = twist.linear
    else:
        at = pose.point(point) if by_pose else system.linkage.carry_point(link, frame, point)
        (twist,) = pair_of(motion).screws(axis, at, pitch)
        linear = scale(tape.constant(1 / system.length), twist.linear)
    return [tape.node(c) for c in (*twist.angular, *linear)]


def _constant_span(tape: Tape, grid: Grid) -> list[int] | None:
    """Rows that tell the columns apart, if these span one and the same space at all samples; else None."""
    count = len(grid[0])
    if count >= 6:
        return None
    values = sampled(tape, grid)
    together = np.concatenate(list(values), axis=1)
    if np.linalg.matrix_rank(together, tol=NEGLIGIBLE) != count:
        return None
    basis = np.linalg.svd(together)[0][:, :count]
    return list(max(combinations(range(6), count), key=lambda rows: _size(basis[list(rows)])))


def _size(matrix: np.ndarray) -> float:
    """|det|, rounded so that the last digits of another machine choose nothing else."""
    return round(abs(float(np.linalg.det(matrix))), 6)


# -- closure --------------------------------------------------------------------------------------------


class _Closure:
    """The rows of all cut joints over the joint rates, without units; `private` columns belong to one cut."""

    def __init__(self, system: System) -> None:
        self.system = system
        tape = system.tape
        self.by_length = tape.constant(1 / system.length)
        self.columns = [tape.constant(system.length) if c.kind == "length" else tape.one for c in system.tree.v]
        self.spins: set[int] = set()
        self.turned = system.closure
        self.cut_drives = system.cut_drives()
        self.rows = [self._entries(cut, cut.rows) for cut in system.cuts]
        known = [{k for row in rows for k in row} for rows in self.rows]
        uses = Counter(k for columns in known for k in columns)
        self.shared = sorted(k for k, n in uses.items() if n > 1)
        self.private = [sorted(k for k in columns if uses[k] == 1) for columns in known]
        self._use_own_axes()
        self._left: dict[tuple[int, ...], int] = {}

    def _use_own_axes(self) -> None:
        """Rates of private spherical joints in the axes of their link instead of those before the rotation.

        There a leg that spins about itself has a constant direction, so that the same two of its rates are always
        independent.
        """
        tree, private = self.system.tree, {k for columns in self.private for k in columns}
        turning = []
        for link in tree.links[1:]:
            below = {k for i in tree.path(link.parent) for k in range(tree.links[i].v.start, tree.links[i].v.stop)}
            own = set(range(link.v.start, link.v.stop))
            if link.motion.spherical and own <= private and not below & private:
                turning.append(link)
        if not turning:
            return
        placed = list(self.system.placed)
        for link in turning:
            placed[link.index] = replace(placed[link.index], turn=IDENTITY)
            self.spins |= set(range(link.v.start, link.v.stop))
        linkage = replace(self.system.linkage, placed=tuple(placed))
        self.turned = replace(self.turned, linkage=linkage)
        self.rows = [self._entries(cut, cut.rows) for cut in self.system.cuts]

    def _entries(self, cut: Cut, rows: Sequence[Row]) -> list[dict[int, Node]]:
        """Rows of a cut joint without units."""
        given = replace(cut, rows=tuple(rows))
        entries = self.system.closure.cut_rows(given)
        if self.spins:
            others = self.turned.cut_rows(given)
            entries = [{k: e for k, e in row.items() if k not in self.spins}
                       | {k: e for k, e in other.items() if k in self.spins}
                       for row, other in zip(entries, others, strict=True)]  # fmt: skip
        return [self._unitless(row, e) for row, e in zip(rows, entries, strict=True)]

    def _unitless(self, row: Row, entries: dict[int, Node]) -> dict[int, Node]:
        tape = self.system.tape
        factor = self.by_length if row.unit == "N" else tape.one
        scaled = {k: factor * self.columns[k] * e for k, e in entries.items()}
        return {k: e for k, e in scaled.items() if not vanishes(tape, e)}

    def _locked(self, locked: Sequence[int]) -> tuple[set[int], list[list[dict[int, Node]]]]:
        """(columns of locked drives of the tree, rows of all cuts with those of locked drives of cut joints)."""
        columns = {v for v, u in self.system.drive_rows().items() if u in locked}
        rows = []
        for c, (cut, own) in enumerate(zip(self.system.cuts, self.rows, strict=True)):
            held = [row for u, row in self.cut_drives.get(c, ()) if u in locked]
            rows.append([*own, *self._entries(cut, held)])
        return columns, rows

    def grid(self, locked: Sequence[int], held: Iterable[int] = ()) -> Grid:
        """The closure with the given drives locked and rates `held` at 0.

        Rates private to a cut joint are eliminated, if there are shared ones.
        """
        tape = self.system.tape
        gone, rows = self._locked(locked)
        gone |= set(held)
        result = []
        for own, private in zip(rows, self.private, strict=True):
            columns = [k for k in private if k not in gone] if self.shared else []
            block = [[row.get(k, tape.zero) for k in columns] for row in own]
            for factors in reciprocal_factors(tape, block):
                combined: dict[int, Node] = {}
                for i, factor in factors.items():
                    for k, entry in own[i].items():
                        if k not in columns:
                            combined[k] = combined.get(k, tape.zero) + factor * entry
                result.append(combined)
        left = self.shared if self.shared else sorted({k for row in result for k in row})
        return [[row.get(k, tape.zero) for k in left if k not in gone] for row in result]

    def left(self, locked: Sequence[int]) -> int:
        """Freedoms that are left with the given drives locked, in general position."""
        key = tuple(locked)
        if key not in self._left:
            gone, rows = self._locked(locked)
            free = [k for k in range(len(self.system.tree.v)) if k not in gone]
            zero = self.system.tape.zero
            every = [[row.get(k, zero) for k in free] for own in rows for row in own]
            self._left[key] = len(free) - (rank_of(self.system.tape, every) if every and free else 0)
        return self._left[key]

    @property
    def freedoms(self) -> int:
        """Freedoms with no drive locked, in general position."""
        return self.left(())


def _closure_volume(system: System, grid: Grid) -> Volume | None:
    """Volume at the rank in general position; None for no constraints at all.

    A wide grid is taken in axes in which it is square, if a link has such.
    """
    tape = system.tape
    lean = trimmed(tape, grid)
    if not lean:
        return None
    rank = rank_of(tape, lean)
    if len(lean) == rank and len(lean[0]) > rank:
        lean = _turned(system, grid) or lean
    return volume(tape, lean, rank)


def _turned(system: System, grid: Grid) -> Grid | None:
    """The grid of a spherical joint's three columns in the axes of a link that leaves a square one, if any.

    A constraint that passes through an axis of its limb acts on the joint only across that axis.
    """
    tape, tree = system.tape, system.tree
    hubs = [link for link in tree.links[1:] if link.motion.spherical]
    if len(grid[0]) != 3 or len(hubs) != 1:
        return None
    for link in tree.links[1:]:
        axes = [system.linkage.carry(link.index, hubs[0].index, axis, before=True) for axis in IDENTITY]
        turned = trimmed(tape, [[tape.node(dot((row[0], row[1], row[2]), axis)) for axis in axes] for row in grid])
        if len(turned) == len(turned[0]) == len(grid):
            return turned
    return None
