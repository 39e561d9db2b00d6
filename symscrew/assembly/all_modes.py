"""Every assembly mode of a mechanism for given values of its drives: found, certified, named.

Mechanism, values --held_structure--> structure --start_system--> zeros of a general member, up to the bound
          --target_roots--> ends of all paths --certified_roots--> boxes with one zero each
          --joint_angles--> displacements of all joints --exponentials of their screws--> residual, singular values
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from symscrew import notebook
from symscrew.algebra import CONTEXT
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import Certificate
from symscrew.assembly.closure_structure import Structure
from symscrew.assembly.completeness import Completeness, proof_of
from symscrew.assembly.coupled_columns import Follower
from symscrew.assembly.elementary_graph import held_graph
from symscrew.assembly.families import MOST_RADIANS, AllNumbers, Family, WhatIsHeld
from symscrew.assembly.held_structure import held_structure
from symscrew.assembly.joint_angles import CLOSED, JointAngles
from symscrew.assembly.mode_names import Named, distances_of, names_by_ways, numbered
from symscrew.assembly.mode_signs import LOCKED, ModeSigns
from symscrew.assembly.path_tracking import Tracker
from symscrew.assembly.rectangles import read
from symscrew.assembly.root_bounds import Bound
from symscrew.assembly.slot_numbers import Displacements, Scalars
from symscrew.assembly.split_roots import NEAR, split_ends
from symscrew.assembly.start_system import StartSystem, start_system, together
from symscrew.assembly.target_roots import Account, End, reference_end, target_roots
from symscrew.assembly.what_is_held import Held, held_by
from symscrew.assembly.without_boxes import without_boxes
from symscrew.description import Mechanism
from symscrew.errors import expect
from symscrew.mobility import Network, NotAlgebraicError

Array = np.ndarray[Any, Any]

DIGITS_60 = Scalars(CONTEXT.cos, CONTEXT.sin, CONTEXT.mpf)
SAME_PLACE = 1e-9
"""Difference of poses, of rotations and sizes of the mechanism, of which only joints of limbs differ: certified poses
have 1e-16."""
AT_REFERENCE = 1e-4
"""Distance of points of length one of a zero that is the reference: where several zeros meet paths end at 1e-5."""
FOLLOWED = 1e-9
"""Displacements of what is held too much, rad and sizes of the mechanism, that are met: loops close to 1e-12."""


@dataclass(frozen=True, repr=False)
class AssemblyMode:
    """One real solution of the closure.

    `name`: stable along motions without singularities, see `symscrew.assembly.mode_names`. `coordinates`: of the
    platform's body (`body`): displacement from the reference, `rotation` (3, 3), `translation` [m] of its points at O.
    `q`: displacements of all freedoms from the reference [rad, sizes of the mechanism], None where a limb does not
    reach. `residual`: opening of the loops at q, by exponentials of the screws. `smallest`: smallest singular value of
    the passive joints' matrix, lengths in sizes of the mechanism; `volume`: the product of all. `signs`: of the
    determinants against the reference. `radius`: of the box, around coordinates of size 1, that holds one zero and no
    other; None where there is no certificate. `paths`: how many end here, two of a double root; `curve`: whether there
    are solutions beside it without end. `close`: one of two that almost meet, told apart in 60 digits.
    """

    name: str
    rotation: Array
    translation: Array
    quaternion: Array
    q: Array | None
    values: Mapping[str, float]
    residual: float
    smallest: float
    volume: float
    signs: Mapping[str, str]
    radius: float | None
    paths: int = 1
    curve: bool = False
    ways: int = 1
    close: bool = False
    exact: bool = False
    meeting: int = 1
    z: Array = field(default_factory=lambda: np.zeros(0))
    poses: Mapping[str, tuple[Array, Array]] = field(default_factory=dict, repr=False)

    def __repr__(self) -> str:
        proved = "certified" if self.certified else "not certified"
        return f"AssemblyMode({self.name}: {proved}, smallest singular value {self.smallest:.3g})"

    @property
    def certified(self) -> bool:
        """Whether it is proved that there is one solution at this place, or one at which several meet."""
        return self.radius is not None or self.exact


@dataclass(frozen=True, repr=False)
class AssemblyModes:
    """All real solutions of a mechanism for what is held, and the account of all paths.

    `held`: values by coordinate, as the description counts them. `bound`: on isolated complex solutions, or None.
    `complete`: "proved", as many certified solutions as exact numbers count; "bounded", as many as a bound allows that
    is right with probability one; "regular", the same of all solutions but singular ones; "tracked" or "sampled"; `why`
    says what it rests on. `out_of_reach`: solutions of the closure that the joints of a limb do not reach. `family`: of
    which the mechanism is a member. `columns`: displacements of what is held, in the order of `held`, then of
    `followers`, which couplings settle. `chosen`: the columns that hold it, of more drives than freedoms those that are
    needed.
    """

    mechanism: Mechanism
    network: Network
    body: str
    held: Mapping[str, float]
    modes: tuple[AssemblyMode, ...]
    out_of_reach: int
    account: Account
    bound: Bound | None
    complete: str
    why: str
    family: Family | None = field(default=None, repr=False)
    columns: Mapping[int, float] = field(default_factory=dict, repr=False)
    chosen: tuple[int, ...] = field(default=(), repr=False)
    followers: tuple[Follower, ...] = field(default=(), repr=False)

    def __repr__(self) -> str:
        names = ", ".join(mode.name for mode in self.modes)
        return f"AssemblyModes({self.mechanism.name}: {len(self.modes)}, {self.complete}: {names})"

    def _repr_html_(self) -> str:
        rows = [
            (
                mode.name, ", ".join(f"{x:.6g}" for x in mode.translation),
                ", ".join(f"{x:.6g}" for x in mode.quaternion), f"{mode.smallest:.3g}",
                "yes" if mode.certified else "no",
            )
            for mode in self.modes
        ]  # fmt: skip
        header = ("mode", f"O of {self.body} [m]", "quaternion w, x, y, z", "smallest singular value", "certified")
        return notebook.table(repr(self), header, rows)

    @property
    def curves(self) -> int:
        """Paths that end on solutions without end: in some of its places the mechanism moves with what is held."""
        return sum(end.paths for end in self.account.ends if end.curve)

    def mode(self, name: str) -> AssemblyMode:
        """The mode of a name; raises KeyError."""
        return {mode.name: mode for mode in self.modes}[name]


def assembly_modes(
    mechanism: Mechanism | Any,
    drives: Mapping[str, Any] | None = None,
    *,
    at: Mapping[str, Any] | None = None,
    progress: Callable[[str], None] = lambda _: None,
) -> AssemblyModes:
    """Every assembly mode for given drives, certified; `symscrew assemble` on the command line.

    The one configuration near a guess, from the independent coordinates, is what `symscrew.assemble` gives.

    Args:
        mechanism: a mechanism, or a model of one.
        drives: driven coordinate (`joint`, `joint.i`) -> value [rad, m]; others are as in the reference.
        at: parameters, or coordinates of joints that are held in place of the drives.
        progress: is told how far the start system is.

    Raises:
        DescriptionError: unknown names, too little held, a closure that is not algebraic.
    """
    mechanism = getattr(mechanism, "mechanism", mechanism)
    expect(mechanism, Mechanism)
    expect(drives or {}, Mapping)
    held = held_by(getattr(mechanism, "mechanism", mechanism), drives or {}, at or {})
    try:
        structure = structure_of(held)
        if structure.equations > structure.unknowns:
            held = held.fewer()
            structure = structure_of(held)
    except NotAlgebraicError as error:
        raise held.error(f"the closure has no polynomials: {error}") from error
    if structure.unknowns > structure.equations:
        free = structure.unknowns - structure.equations
        raise held.error(f"the mechanism can still move, with {free} freedom{'s' * (free > 1)}: hold more coordinates")
    if not structure.groups:
        return _alone(held)
    return _Search(held, structure, progress).modes()


def structure_of(held: Held) -> Structure:
    """The structure of a mechanism with what is held."""
    network = held.network
    graph = held_graph(network, held.chosen, held.mechanism.platform, held.links)
    points = [edge.point for edge in network.edges.values()]
    x, y, z = (sum(p[k] for p in points) / len(points) for k in range(3))
    return held_structure(graph, (x, y, z), held.mechanism.platform)


def _alone(held: Held) -> AssemblyModes:
    """Of a mechanism of which nothing is left to be solved."""
    signs = ModeSigns(held.network, held.mechanism, list(held.chosen))
    q = np.zeros(held.network.freedoms)
    for column, value in held.values.items():
        q[column] = value
    seen = signs.look(q)
    rotation, translation = seen.pose(held.body)
    mode = AssemblyMode(
        "home", rotation, translation, quaternion(rotation), q, held.labelled(q), seen.residual, seen.smallest,
        seen.volume, seen.signs, 0.0, poses=seen.poses,
    )  # fmt: skip
    bound = Bound(1, 0, "nothing is left to be solved")
    return AssemblyModes(
        held.mechanism, held.network, held.body, held.shown, (mode,), 0, Account((), 0, 0), bound, "proved",
        "what is held fixes all bodies",
    )  # fmt: skip


def known_zero(equations: BatchEquations) -> Array:
    """The zero that the description gives."""
    z = np.zeros(equations.width, dtype=complex)
    for part in equations.parts:
        z[part.start] = 1.0
    return z


class _Search:
    def __init__(self, held: Held, structure: Structure, progress: Callable[[str], None]) -> None:
        self.held, self.structure, self.progress = held, structure, progress
        self.equations = BatchEquations(structure)
        square = structure.unknowns == structure.equations
        self.drives = WhatIsHeld(self.equations, held.drives, held.followers)
        self.family: Family = AllNumbers(self.equations) if square else self.drives
        self.signs = ModeSigns(held.network, held.mechanism, list(held.chosen))

    def modes(self) -> AssemblyModes:
        """All of them, with what they rest on."""
        start = start_system(self.family, known_zero(self.equations), self.progress)
        account = target_roots(self.family, start, self.family.member(dict(self.held.values)))
        fine = Displacements(self.structure, DIGITS_60, self.held.exact).slots()
        boxes = [read(s) if np.ndim(s) == 0 else [read(c) for c in s] for s in fine]
        account = split_ends(self.equations, boxes, account)
        account = self._with_reference(start, account)
        account = without_boxes(self.held, self.family, account, known_zero(self.equations))
        ends = [end for end in account.ends if end.kind == "real"]
        ends = [_polished(self.equations, self.family, self.held, end) for end in ends]
        certificates = [proof_of(self.equations, boxes, end) for end in ends]
        ends = [end if box is None else replace(end, z=box.z) for end, box in zip(ends, certificates, strict=True)]
        modes, missed = self._seen(ends, certificates)
        modes = _one_of_each(modes, self.held)
        whole = Completeness(self.held, self.equations, boxes, self.progress)
        complete, why, bound = whole.verdict(start, account, certificates)
        names = self._names(start, modes)
        modes = sorted((replace(m, name=n) for m, n in zip(modes, names, strict=True)), key=lambda m: _order(m.name))
        return AssemblyModes(
            self.held.mechanism, self.held.network, self.held.body, self.held.shown, tuple(modes), missed, account,
            bound, complete, why, self.family, self.held.values, self.held.chosen,
            self.held.followers,
        )  # fmt: skip

    def _with_reference(self, start: StartSystem, account: Account) -> Account:
        """The account with the reference, where that is what is asked for and no path came to it.

        So it is where more is free in it than what is held: paths end elsewhere on its curve, or nowhere real.
        """
        if any(self.held.values.values()):
            return account
        place = reference_end(
            self.family, start, self.family.member(dict(self.held.values)), known_zero(self.equations)
        )
        near = any(end.kind == "real" and np.abs(end.z - place.z).max() < AT_REFERENCE for end in account.ends)
        return account if near else replace(account, ends=(*account.ends, place))

    def _names(self, start: StartSystem, modes: Sequence[AssemblyMode]) -> list[str]:
        """Of modes at what is held, by straight ways to the reference."""
        still = not any(self.held.values.values())
        at_rest = replace(self.held, values=dict.fromkeys(self.held.values, 0.0), exact={})
        others = modes
        if not still:
            search = _Search(at_rest, self.structure, self.progress)
            account = target_roots(self.family, start, self.family.member({}))
            regular = [end for end in account.ends if end.kind == "real" and end.regular]
            others = _one_of_each(search._seen(regular, None)[0], self.held)
        known = [self._named(m) for m in others]
        home = together(self.equations, self._points(known), self.equations.scaled(known_zero(self.equations)[None])[0])
        names = numbered(known, int(np.flatnonzero(home)[0]) if home.any() else None)
        if still:
            return names
        here = self.drives.member(dict(self.held.values))
        if self.drives.span(here, self.drives.own) > MOST_RADIANS:
            return numbered([self._named(m) for m in modes], None, "n")
        way = self.drives.way(here, self.drives.own)
        return names_by_ways(way, self.equations, [self._named(m) for m in modes], (known, names))

    def _named(self, mode: AssemblyMode) -> Named:
        translation = mode.translation / float(self.held.network.length)
        return Named(
            mode.z, mode.rotation, translation, mode.signs.get(LOCKED, "m"),
            distances_of(self._marks, mode.rotation, translation),
        )  # fmt: skip

    @cached_property
    def _marks(self) -> Array:
        """Points of the joints in the reference, and a size of the mechanism along hinges (n, 3) [its sizes]."""
        points, ends = list[list[float]](), list[list[float]]()
        for edge in self.held.network.edges.values():
            points.append([float(c) for c in edge.point])
            axes = [edge.screws[start - edge.start][:3] for motion, start in edge.motions if motion.revolute]
            ends += [[float(c + a) for c, a in zip(edge.point, axis, strict=True)] for axis in axes]
        return np.array(points + ends)

    def _points(self, modes: Sequence[Named]) -> Array:
        zeros = np.array([m.z for m in modes], dtype=complex).reshape(-1, self.equations.width)
        return self.equations.scaled(zeros) if len(zeros) else zeros

    def _seen(self, ends: Sequence[End], boxes: Sequence[Certificate | None] | None) -> tuple[list[AssemblyMode], int]:
        """(modes with displacements of all joints, how many solutions no limb reaches)."""
        if not ends:
            return [], 0
        zeros = np.array([end.z.real for end in ends])
        angles = JointAngles(self.equations, self.held.values, self.held.network.freedoms)
        q, off = angles.solved(zeros)
        places = angles.bodies(zeros).get(self.held.body)
        modes, missed = [], 0
        for k, (end, box, at, gap) in enumerate(zip(ends, boxes or [None] * len(ends), q, off, strict=True)):
            if gap > CLOSED:
                missed += 1
                continue
            if any(abs(self.held.off(column, at[column])) > FOLLOWED for column in self.held.extra):
                continue
            seen = self.signs.look(at)
            rotation, translation = seen.pose(self.held.body)
            if places is not None:  # right to the last bit, where displacements of joints are solved in doubles
                rotation, translation = self._about_origin(places[0][k], places[1][k])
            modes.append(AssemblyMode(
                "", rotation, translation, quaternion(rotation), at, self.held.labelled(at), seen.residual,
                seen.smallest, seen.volume, seen.signs, None if box is None else box.radius, end.paths, end.curve,
                close=end.proof is not None and end.proof.beside is not None, exact=end.exact is not None,
                meeting=end.exact.meeting if end.exact else 1, z=end.z, poses=seen.poses,
            ))  # fmt: skip
        return modes, missed

    def _about_origin(self, turn: Array, shift: Array) -> tuple[Array, Array]:
        """A displacement in absolute axes, of what is at O [m], from one in the structure's frame."""
        frame = np.array([[float(c) for c in row] for row in self.structure.frame])
        centre = np.array([float(c) for c in self.structure.centre])
        rotation = frame.T @ turn @ frame
        return rotation, (centre - rotation @ centre + frame.T @ shift) * float(self.held.network.length)


def _one_of_each(modes: Sequence[AssemblyMode], held: Held) -> list[AssemblyMode]:
    """Of solutions with the platform in one place that whose joints are nearest to the reference."""
    result = list[AssemblyMode]()
    if not held.mechanism.limbs:  # no body is said to be carried by limbs
        return list(modes)
    for mode in sorted(modes, key=lambda m: float(np.linalg.norm(m.q)) if m.q is not None else np.inf):
        same = next((k for k, m in enumerate(result) if _together(m, mode, float(held.network.length))), None)
        if same is None:
            result.append(mode)
        else:
            result[same] = replace(result[same], ways=result[same].ways + 1)
    return result


def _together(one: AssemblyMode, two: AssemblyMode, size: float) -> bool:
    turn, way = one.rotation - two.rotation, (one.translation - two.translation) / size
    pair = one.close and two.close and np.abs(one.z - two.z).max() < NEAR
    return bool(np.abs(turn).max() < SAME_PLACE and np.abs(way).max() < SAME_PLACE and not pair)


def _polished(equations: BatchEquations, family: Family, held: Held, end: End) -> End:
    """A real zero by real Newton steps."""
    if end.proof is not None or end.exact is not None:
        return end
    if not end.regular:
        return replace(end, z=end.z.real + 0j)
    goal = family.way(family.member(dict(held.values)), family.member(dict(held.values))).at(np.zeros(1))
    tracker, z = Tracker(equations), (end.z.real + 0j)[None]
    for _ in range(3):
        z = z + tracker.newton(z, goal)
    return replace(end, z=z[0].real + 0j)


def _order(name: str) -> tuple[bool, str, int]:
    letters = name.rstrip("0123456789")
    return name != "home", letters, int(name[len(letters) :] or 0)


def quaternion(rotation: Array) -> Array:
    """(w, x, y, z) of a rotation, w not negative."""
    r = rotation
    trace = np.trace(r)
    rows = np.array([
        [1 + trace, r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
        [r[2, 1] - r[1, 2], 1 + 2 * r[0, 0] - trace, r[0, 1] + r[1, 0], r[0, 2] + r[2, 0]],
        [r[0, 2] - r[2, 0], r[0, 1] + r[1, 0], 1 + 2 * r[1, 1] - trace, r[1, 2] + r[2, 1]],
        [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], 1 + 2 * r[2, 2] - trace],
    ])  # fmt: skip
    x = rows[int(np.diag(rows).argmax())]
    x = x / np.linalg.norm(x)
    return np.asarray(x if x[0] > 0 or (x[0] == 0 and x[np.flatnonzero(x)[0]] > 0) else -x)
