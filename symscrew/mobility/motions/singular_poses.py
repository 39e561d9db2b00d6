"""Singular poses on the coordinate lines through the reference: where, of which kind, what the mechanism does there.

Track --a margin that dips to zero, a coordinate that turns back--> pose, refined --rank_loss--> lost, almost, or open
      --germs there--> SingularPose
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

import numpy as np

from symscrew.mobility.finite import (
    ClosureVariety,
    ReducedClosure,
    local_at,
    moved,
    quadratic_forms,
    without_spins,
)
from symscrew.mobility.motions.coordinate_lines import STRIDE, Pose, Setting, Track, poses_next_to
from symscrew.mobility.motions.germs import germs_at
from symscrew.mobility.motions.one_equation import sheets_of_one_equation
from symscrew.mobility.motions.rank_loss import Loss, at_pose, decided, freedoms_at

Array = np.ndarray[Any, Any]

DIPS = 0.5
"""A margin that is lowest at a pose, below this part of its median along the line, may be zero nearby."""
ZERO = 1e-5
"""Part of its median below which a margin, refined, is zero as far as doubles tell: it goes through zero like a
distance along the line, which is known to 1e-8."""
NOWHERE = 1e-8
"""Median of a margin along a line below which it is zero all along: poses are known to 1e-10."""
FLAT = 0.2
"""What golden section leaves of the first values of a margin where it has a minimum and no zero: of one that goes
through zero it leaves an eighth at most."""
ALMOST = 1e-3
"""Part of its median below which a margin that is not zero is worth a word."""
ASIDE = 0.3
"""A pose that the equations of a loss lead to is on the line where it lies, this part of a stride, beside its tangent:
the line bends by half the square of a stride times its curvature."""
GOLDEN, TIMES = (5**0.5 - 1) / 2, 8
"""Golden section on a stretch of two strides, to a hundredth of it."""
SECANTS, NARROWER = 5, 20
"""Then secants from both sides, on a stretch ten times narrower each time: their error is its square."""
SAME = 1e-4
"""Poses closer together than this are one, of several kinds, as far as doubles tell."""
SAME_OF_60 = 1e-8
"""The same of poses that are known to 60 digits."""

MOST_FREEDOMS = 12
"""Instantaneous freedoms without passive spins up to which branches that meet are told apart: of 19 it takes 2 to 5 s a
pose, growing like the fourth power, and starts are too few for what is found to be all. Machines have six or seven."""


@dataclass(frozen=True)
class SingularPose:
    """A singular pose on a coordinate line.

    Attributes:
        column: of the coordinate that moves, the others being at rest.
        q: displacements of all joint freedoms from the reference [rad, lengths in units of the mechanism].
        kinds: what is lost there to 60 digits: `closure`, `drives`, `platform`, `coordinate`, or the name of a limb.
        instantaneous: instantaneous freedoms there.
        branches: dimensions of the branches that meet there, where the closure is singular; empty where not told.
        almost: kinds that are almost lost, and are not as typed -> by how much the equations of the loss stay open.
        open: kinds that are lost as far as doubles tell, no more.
        untried: there are more than `MOST_FREEDOMS`, so that branches were not looked for.
        locked: instantaneous freedoms there with all drives locked, without passive spins; None where not asked.
        ends_passed: how often the coordinate has turned back on the way from the reference.
    """

    column: int
    q: Array
    kinds: tuple[str, ...]
    instantaneous: int
    branches: tuple[int, ...]
    almost: Mapping[str, float] = field(default_factory=dict)
    open: tuple[str, ...] = ()
    untried: bool = False
    locked: int | None = None
    ends_passed: int = 0


def singular_poses(setting: Setting, tracks: Sequence[Track]) -> tuple[SingularPose, ...]:
    """Those on all lines, each once."""
    found: list[tuple[Track, list[Loss], Array, int]] = []
    for line in tracks:
        for loss, passed in _on(setting, line):
            joints = setting.variety.places(loss.place)
            same = [group for of, group, there, _ in found if of.column == line.column
                    and (_same((group[0], there), (loss, joints)) or _also(setting, of, loss, group))]  # fmt: skip
            if not same:
                found.append((line, [loss], joints, passed))
            elif all(loss.kind != other.kind for other in same[0]):
                same[0].append(loss)
    return tuple(replace(_judged(setting, line, group), ends_passed=passed) for line, group, _, passed in found)


def _same(a: tuple[Loss, Array], b: tuple[Loss, Array]) -> bool:
    """Whether two losses, each with the places of the joints there, are at one pose."""
    exact = a[0].real is True and b[0].real is True
    return bool(np.linalg.norm(a[1] - b[1]) < (SAME_OF_60 if exact else SAME))


def _also(setting: Setting, line: Track, loss: Loss, group: Sequence[Loss]) -> bool:
    """Whether a loss next to others is at their pose: of several at once each is found apart, to half the digits."""
    first = group[0]
    if not loss.real or not first.real or any(loss.kind == other.kind for other in group):
        return False
    near = np.linalg.norm(loss.place - first.place) < SAME
    return bool(near) and bool(at_pose(setting, line, replace(loss, real=None), first).real)


def _on(setting: Setting, line: Track) -> Iterator[tuple[Loss, int]]:
    """What is lost, or almost, along one line, with how often the coordinate has turned back before."""
    poses, turns = line.poses, list[Loss]()
    back = dict[int, Array]()  # after which pose the coordinate turns back -> where
    for k, (before, after) in enumerate(pairwise(poses)):
        if before.direction[line.column] * after.direction[line.column] < 0:
            back[k] = before.q
            loss = _at_once(setting, line, before, "coordinate")
            q = None if loss is not None else _lowest(setting, line, before, None)
            if q is not None:
                loss = decided(setting, line, q[0], "coordinate")
            if loss is not None:
                turns.append(loss)
                back[k] = loss.place
                yield loss, len(back) - 1
    for kind in poses[0].margins:
        values = np.array([pose.margins[kind] for pose in poses])
        typical = float(np.median(values))
        if typical < NOWHERE:
            continue  # lost all along: `lost_lines`
        size = max(typical, float(values.max()) * ZERO)
        for k in range(len(poses) - 1):
            last = values[k - 1] if k else np.inf  # the other side of the reference is another track
            if values[k] <= min(last, values[k + 1]) and values[k] < DIPS * typical:
                known = _known(setting, line, poses[k], turns) if kind == "drives" else None
                loss = known or _at_once(setting, line, poses[k], kind)
                start, strides = poses[max(k - 1, 0)], 2.2 if k else 1.1
                found = None if loss is not None else _lowest(setting, line, start, kind, strides=strides)
                if found is not None and found[1] < ALMOST * size:
                    loss = decided(setting, line, found[0], kind)
                    if loss.real is None and found[1] >= ZERO * size:
                        continue
                if loss is not None and (k or np.linalg.norm(loss.place) > SAME):  # the report judges the reference
                    yield loss, sum(_passed(poses[t], where, loss, k - t) for t, where in back.items())


def _passed(before: Pose, turn: Array, loss: Loss, poses: int) -> bool:
    """Whether a loss is behind where the coordinate turns back, found so many poses after the one before that."""
    return poses > 0 if abs(poses - 0.5) > 1 else float((loss.place - turn) @ before.direction) > 0


def _known(setting: Setting, line: Track, pose: Pose, turns: Sequence[Loss]) -> Loss | None:
    """Where the independent coordinates are the drives, these lose their hold where a coordinate turns back."""
    if {*line.held, line.column} != set(setting.drives):
        return None
    near = (loss for loss in turns if loss.real and np.linalg.norm(loss.place - pose.q) < 2 * STRIDE)
    return next((replace(loss, kind="drives") for loss in near), None)


def lost_lines(tracks: Sequence[Track]) -> tuple[tuple[int, str], ...]:
    """(column, kind) of margins that are zero all along the line of a coordinate, as far as doubles tell."""
    found = [(line.column, kind) for line in tracks for kind in line.poses[0].margins
             if float(np.median([pose.margins[kind] for pose in line.poses])) < NOWHERE]  # fmt: skip
    return tuple(dict.fromkeys(found))


def _at_once(setting: Setting, line: Track, pose: Pose, kind: str) -> Loss | None:
    """A loss of rank on the line that its equations lead to from a pose a stride away; None where they do not."""
    loss = decided(setting, line, pose.q, kind, within=2 * STRIDE)
    if not loss.real:
        return None
    step = loss.place - pose.q
    aside = step - pose.direction * float(step @ pose.direction)
    return loss if np.linalg.norm(aside) < ASIDE * STRIDE else None


def _lowest(
    setting: Setting, line: Track, start: Pose, kind: str | None, *, strides: float = 1.2
) -> tuple[Array, float] | None:
    """(displacements, value) where a margin is lowest on the stretch after a pose, by golden section.

    Without a kind the value is the coordinate's own rate.
    """

    def at(*parts: float) -> list[tuple[float, Array] | None]:
        aside = np.array([start.q + part * STRIDE * start.direction for part in parts])
        count = len(parts)
        poses = poses_next_to(setting, aside, [line.held] * count, [start.direction] * count)
        return [None if pose is None else (_value(pose, line.column, kind), pose.q) for pose in poses]

    low, high = 0.0, strides
    inner = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)]
    values = at(*inner)
    before = max((value[0] for value in values if value is not None), default=0.0)
    for _ in range(TIMES):
        left = values[1] is None or (values[0] is not None and values[0][0] < values[1][0])
        if left:
            high, inner = inner[1], [inner[1] - GOLDEN * (inner[1] - low), inner[0]]
            values = [*at(inner[0]), values[0]]
        else:
            low, inner = inner[0], [inner[1], inner[0] + GOLDEN * (high - inner[0])]
            values = [values[1], *at(inner[1])]
    best = min((v for v in values if v is not None), key=lambda pair: pair[0], default=None)
    if best is not None and best[0] > FLAT * before:
        return best[1], best[0]
    for _ in range(SECANTS):  # a margin goes through zero like a distance: both sides of the V meet there
        ends = at(low, high)
        if ends[0] is None or ends[1] is None or not ends[0][0] + ends[1][0] > 0:
            break
        middle = (ends[0][0] * high + ends[1][0] * low) / (ends[0][0] + ends[1][0])
        there = at(middle)[0]
        if there is None:
            break
        best = there if best is None or there[0] < best[0] else best
        low, high = middle - (high - low) / NARROWER, middle + (high - low) / NARROWER
    return None if best is None else (best[1], best[0])


def _value(pose: Pose, column: int, kind: str | None) -> float:
    return abs(float(pose.direction[column])) if kind is None else pose.margins[kind]


def _judged(setting: Setting, line: Track, losses: Sequence[Loss]) -> SingularPose:
    """The pose with the branches that meet there."""
    known = next((loss for loss in losses if loss.real), None)
    if known is not None:
        losses = [loss if loss.real is not None else at_pose(setting, line, loss, known)
                  for loss in losses]  # fmt: skip
    kinds = tuple(loss.kind for loss in losses if loss.real)
    undecided = tuple(loss.kind for loss in losses if loss.real is None)
    almost = {loss.kind: loss.left for loss in losses if loss.real is False}
    q = (known or losses[0]).place
    closure = known is not None and "closure" in kinds
    instantaneous, branches = _crossing(setting, known.q) if closure and known is not None else (setting.whole, ())
    locked = None
    if closure and known is not None and setting.drives:
        locked = freedoms_at(setting, known.q, setting.drives) - (setting.whole - setting.dimension)
    untried = branches is None
    return SingularPose(line.column, q, kinds, instantaneous, branches or (), almost, undecided, untried, locked)


def _crossing(setting: Setting, q: Array) -> tuple[int, tuple[int, ...] | None]:
    """(instantaneous freedoms at a pose of 60 digits, dimensions of the branches that meet there; None: not tried)."""
    instantaneous = freedoms_at(setting, q)
    if instantaneous <= setting.whole:
        return instantaneous, ()
    there, spins = without_spins(moved(setting.network, setting.fine_with_spins, q))
    if instantaneous - spins > MOST_FREEDOMS:
        return instantaneous, None
    variety = ClosureVariety(there)
    here = local_at(variety, np.zeros(variety.columns), rank=variety.columns - instantaneous + spins)
    if len(here.stresses) == 1:  # what one equation tells needs no zeros of it
        normals = sheets_of_one_equation(ReducedClosure(variety, here), quadratic_forms(variety, here))
        if normals is not None:
            return instantaneous, (instantaneous - 1,) * max(1, len(normals))
    found = germs_at(variety, here, {d: d for d in range(1, instantaneous - spins)})
    return instantaneous, tuple(sorted((germ.dimension + spins for germ in found), reverse=True))
