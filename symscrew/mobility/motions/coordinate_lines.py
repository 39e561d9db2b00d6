"""Coordinate lines through a smooth configuration: one independent coordinate moves, the others rest.

    configuration, independent columns --predictor, Newton--> poses along each line, both ways --> Track

At each pose the closure's Jacobian gives all instantaneous motions, and with them what of the mechanism is close to
losing rank there: the closure itself, the hold of the drives, the freedoms of the platform, a limb.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from symscrew.mobility.finite import DIGITS_60, ClosureVariety
from symscrew.mobility.joint_network import Network
from symscrew.mobility.motions.held_spins import HeldSpins
from symscrew.mobility.motions.seen_poses import body_twists

Array = np.ndarray[Any, Any]

STRIDE = 0.1
"""Length of a step, rad and lengths in units of the mechanism: some sixty steps in a turn of one joint."""
MOST_STEPS = 160
"""Steps in one direction: a crank that turns by pi while other joints turn five times as far."""
ENDS = (np.pi, 2.0)
"""A coordinate is followed to half a turn, or to twice the mechanism's size, from the reference."""
NEWTON = 8
"""Steps of Newton's method: three at a regular pose."""
CLOSED = 1e-10
"""Closure residual, in units of the mechanism's size, of a pose on a line: margins are known to about that."""
JUMPED = 0.5
"""Newton's method may move a predicted pose by this part of a step; more is another branch."""
CUT_OFF = 1e-8
"""Relative singular values below this are left out of Newton's steps: redundant equations have 1e-16."""
WELL = 1e8
"""Bound of the squared condition of independent equations below which their normal equations leave eight digits, which
the next step of Newton's method mends; beyond it singular values are found."""
MOST_TURNED = 1.2 * np.pi
"""Size of a ball joint's rotation vector [rad] beyond which the other one of the same rotation takes its place: at a
full turn the coordinates are singular where the mechanism is not."""
SHRINK = (1.0, 0.5, 1.6, 0.25, 0.1)
"""Steps that are tried, in strides: over a point where branches cross a longer one may do better than a short one."""


@dataclass(frozen=True)
class Setting:
    """What is looked at along the lines.

    Attributes:
        network: the reference configuration.
        variety: its closure with passive spins held.
        dimension: of its motions without them, at regular poses.
        body: whose freedoms, of which there are `order` at regular poses.
        drives: driven columns.
        limbs: name -> (columns, rank at the reference).
    """

    network: Network
    variety: HeldSpins
    dimension: int
    body: str
    order: int
    drives: tuple[int, ...]
    limbs: Mapping[str, tuple[tuple[int, ...], int]]

    @property
    def whole(self) -> int:
        """The dimension with the passive spins."""
        return self.dimension + len(self.variety.ends)

    @cached_property
    def fine(self) -> HeldSpins:
        """The closure with passive spins held, in 60 digits."""
        return HeldSpins(self.network, self.body, DIGITS_60)

    @cached_property
    def fine_with_spins(self) -> ClosureVariety:
        """The closure with no spin held, in 60 digits."""
        return ClosureVariety(self.network, DIGITS_60)


@dataclass(frozen=True)
class Pose:
    """A pose on a line: displacements, instantaneous motions (columns), direction of the line.

    `margins`: what -> singular value that is zero where it is singular; `closure`, `drives`, `platform`, limbs by name.
    """

    q: Array
    motions: Array
    direction: Array
    margins: Mapping[str, float]


@dataclass(frozen=True)
class Track:
    """The poses along one coordinate's line in one direction, from the reference, and how it ended."""

    column: int
    held: tuple[int, ...]
    poses: tuple[Pose, ...]
    end: str


def independent_columns(network: Network, motions: Array, drives: Sequence[int]) -> tuple[int, ...]:
    """Freedoms that can be chosen at will at the configuration: the drives where they can, else what moves most."""
    dimension = motions.shape[1]
    if len(drives) == dimension and np.linalg.svd(motions[list(drives)], compute_uv=False)[-1] > CUT_OFF:
        return tuple(drives)
    single = [start for e in network.edges.values() for motion, start in e.motions if motion.single]
    single = single or list(range(network.freedoms))  # of ball joints alone
    left, chosen = motions[single].copy(), list[int]()
    for _ in range(min(dimension, len(single))):
        k = int(np.linalg.norm(left, axis=1).argmax())
        size = float(np.linalg.norm(left[k]))
        if size < CUT_OFF:
            break
        chosen.append(single[k])
        left = left - np.outer(left @ (left[k] / size), left[k] / size)
    return tuple(chosen)


def pose_at(setting: Setting, q: Array, held: Sequence[int], before: Array | None) -> Pose:
    """The pose with its margins; its direction continues the one before."""
    screws = setting.variety.displaced(q[None])
    jacobians = setting.variety.jacobians(screws, q[None])
    return _posed(setting, _Places(q[None], screws, jacobians), [held], [before])[0]


@dataclass(frozen=True)
class _Places:
    """Displacements N x columns with the displaced screws and the closure's Jacobians there."""

    q: Array
    screws: Array
    jacobians: Array

    def at(self, index: Array) -> _Places:
        return _Places(self.q[index], self.screws[index], self.jacobians[index])


def _posed(
    setting: Setting, places: _Places, held: Sequence[Sequence[int]], before: Sequence[Array | None]
) -> list[Pose]:
    """The poses at these places, each of a line of its own; `held` are equally many on all lines."""
    variety, screws, count = setting.variety, places.screws, len(places.q)
    rank = variety.columns - setting.dimension
    _, s, vt = np.linalg.svd(places.jacobians)
    motions = np.swapaxes(vt[:, rank:], 1, 2)
    margins = {"closure": s[:, rank - 1] if rank else np.ones(count)}
    if len(setting.drives) >= setting.dimension:
        driven = np.linalg.svd(motions[:, list(setting.drives)], compute_uv=False)
        margins["drives"] = driven[:, setting.dimension - 1]
    if setting.order:
        twists = body_twists(setting.network, variety, screws, setting.body) @ motions
        margins["platform"] = np.linalg.svd(twists, compute_uv=False)[:, setting.order - 1]
    for name, (columns, most) in setting.limbs.items():
        margins[name] = np.linalg.svd(screws[:, list(columns)], compute_uv=False)[:, most - 1]
    poses = []
    for k in range(count):
        rest = np.linalg.svd(motions[k][list(held[k])])[2][len(held[k]) :] if held[k] else np.eye(setting.dimension)
        line, old = motions[k] @ rest[0], before[k]
        if old is not None:
            if len(held[k]) < setting.dimension - 1 or rank == 0:
                line = old
            line = line if line @ old >= 0 else -line
        poses.append(Pose(places.q[k], motions[k], line, {kind: float(found[k]) for kind, found in margins.items()}))
    return poses


def poses_next_to(
    setting: Setting, starts: Array, held: Sequence[Sequence[int]], before: Sequence[Array | None]
) -> list[Pose | None]:
    """Of every start the nearest pose with the loops closed and the held coordinates at the reference; None without."""
    found: list[Pose | None] = [None] * len(starts)
    index, places = _closed(setting, starts, held)
    poses = _posed(setting, places, [held[k] for k in index], [before[k] for k in index]) if len(index) else []
    for k, pose in zip(index, poses, strict=True):
        found[k] = pose
    return found


def _closed(setting: Setting, starts: Array, held: Sequence[Sequence[int]]) -> tuple[Array, _Places]:
    """(which of the starts closed, the places they led to), by Newton's method."""
    variety, q, left = setting.variety, starts, np.arange(len(starts))
    rest = np.array([list(columns) for columns in held], dtype=int).reshape(len(starts), -1)
    picked = np.eye(variety.columns)[rest]
    ended = list[tuple[Array, _Places]]()
    for _ in range(NEWTON):
        screws, poses = variety.forward(q)
        places = _Places(q, screws, variety.jacobians(screws, q))
        off = np.concatenate([variety.gaps(poses, q), np.take_along_axis(q, rest[left], axis=1)], axis=1)
        good = np.linalg.norm(off, axis=1) < CLOSED
        ended.append((left[good], places.at(good)))
        q, left = q[~good], left[~good]
        if not len(left):
            break
        rows = np.concatenate([places.jacobians[~good], picked[left]], axis=1)
        q = q - _shortest(setting, rows, off[~good])
        near = np.linalg.norm(q - starts[left], axis=1) <= JUMPED * STRIDE
        q, left = q[near], left[near]
        if not len(left):
            break
    index = np.concatenate([index for index, _ in ended])
    parts = [places for _, places in ended]
    return index, _Places(*(np.concatenate(of) for of in zip(*((p.q, p.screws, p.jacobians) for p in parts),
                                                            strict=True)))  # fmt: skip


def _shortest(setting: Setting, rows: Array, off: Array) -> Array:
    """The shortest steps that the linear equations ask for, N at once; singular values are cut off at `CUT_OFF`.

    Independent equations that are well conditioned need no singular values: x = A' (A A')^-1 b, at a tenth of the time.
    """
    left, steps = np.ones(len(rows), dtype=bool), np.empty((len(rows), rows.shape[2]))
    if setting.variety.rows + len(setting.variety.ends) == setting.variety.columns - setting.dimension:
        across = np.swapaxes(rows, 1, 2)
        products = rows @ across
        try:
            inverse = np.linalg.inv(products)
        except np.linalg.LinAlgError:
            inverse = np.full(products.shape, np.inf)
        left = ~(np.linalg.norm(products, axis=(1, 2)) * np.linalg.norm(inverse, axis=(1, 2)) < WELL)
        steps[~left] = (across @ (inverse @ off[..., None]))[~left, :, 0]
    if left.any():
        steps[left] = (np.linalg.pinv(rows[left], rcond=CUT_OFF) @ off[left, :, None])[..., 0]
    return steps


def track(setting: Setting, column: int, held: Sequence[int], sign: int, *, most: int = MOST_STEPS) -> Track:
    """The line of one coordinate from the reference in one direction, at most so many poses."""
    return tracks(setting, [(column, held, sign)], most=most)[0]


def tracks(
    setting: Setting, wanted: Sequence[tuple[int, Sequence[int], int]], *, most: int = MOST_STEPS
) -> list[Track]:
    """The lines of (coordinate, those held, direction) from the reference, at most so many poses each.

    They are followed side by side: a step of all of them costs little more than one of one.
    """
    origin, columns = np.zeros(setting.variety.columns), setting.variety.columns
    lines = list[list[Pose]]()
    for column, held, sign in wanted:
        pose = pose_at(setting, origin, held, None)
        direction = pose.direction * sign * (1 if pose.direction[column] >= 0 else -1)
        lines.append([pose_at(setting, origin, held, direction)])
    slides = {start for e in setting.network.edges.values() for motion, start in e.motions if motion.prismatic}
    turns = np.array([0.0 if c in slides else 2 * np.pi for c in range(columns)])
    ends = ["as far as was looked"] * len(lines)
    going = list(range(len(lines)))
    while going := [k for k in going if len(lines[k]) < most]:
        for k, stepped in zip(going, _steps(setting, [(lines[k][-1], wanted[k][1]) for k in going]), strict=True):
            if stepped is None:
                ends[k] = "the line could not be followed further"
                continue
            after = the_other_way_round(setting, stepped, wanted[k][1])
            lines[k].append(after)
            ends[k] = _ended(lines[k], wanted[k][0], slides, turns) or ends[k]
        going = [k for k in going if ends[k] == "as far as was looked"]
    return [Track(column, tuple(held), tuple(poses), end)
            for (column, held, _), poses, end in zip(wanted, lines, ends, strict=True)]  # fmt: skip


def _ended(poses: Sequence[Pose], column: int, slides: Set[int], turns: Array) -> str:
    """Why a line ends with its last pose; empty where it goes on."""
    limit = ENDS[1] if column in slides else ENDS[0]
    if abs(poses[-1].q[column]) > limit:
        return "half a turn" if limit == ENDS[0] else "far away"
    away = np.abs(poses[-1].q)
    away = np.where(turns > 0, np.abs((away + np.pi) % (2 * np.pi) - np.pi), away)
    back = np.linalg.norm(away) < 0.6 * STRIDE and poses[-1].direction @ poses[0].direction > 0
    return "back at the reference" if len(poses) > 5 and back else ""


def the_other_way_round(setting: Setting, pose: Pose, held: Sequence[int]) -> Pose:
    """The same pose and direction with rotation vectors of ball joints shortened by a turn where they are long."""
    balls = [list(e.columns) for e in setting.network.edges.values() for motion, _ in e.motions if motion.spherical]
    q = pose.q.copy()
    for columns in balls:
        size = float(np.linalg.norm(q[columns]))
        if size > MOST_TURNED:
            q[columns] *= 1 - 2 * np.pi / size
    if (q == pose.q).all():
        return pose
    line = np.linalg.solve(_turning(setting, q, balls), _turning(setting, pose.q, balls) @ pose.direction)
    return replace(pose_at(setting, q, held, None), direction=line / np.linalg.norm(line))


def _turning(setting: Setting, q: Array, balls: Sequence[list[int]]) -> Array:
    """Rates of joints as they are seen, angular velocities of ball joints, by rates of the coordinates."""
    screws = setting.variety.displaced(q[None])[0]
    seen = np.eye(len(q))
    for columns in balls:
        seen[np.ix_(columns, columns)] = screws[columns, :3].T
    return seen


def _steps(setting: Setting, lines: Sequence[tuple[Pose, Sequence[int]]]) -> list[Pose | None]:
    """The next pose of every line (last pose, held coordinates); None where no step that is tried arrives."""
    found: list[Pose | None] = [None] * len(lines)
    for part in SHRINK:
        left = [k for k, after in enumerate(found) if after is None]
        if not left:
            break
        poses, held = [lines[k][0] for k in left], [lines[k][1] for k in left]
        starts = np.array([pose.q + part * STRIDE * pose.direction for pose in poses])
        for k, pose, after in zip(
            left, poses, poses_next_to(setting, starts, held, [pose.direction for pose in poses]), strict=True
        ):
            if after is not None and (after.q - pose.q) @ pose.direction > 0:
                found[k] = after if after.direction @ pose.direction > JUMPED else None
    return found
