"""Coordinate lines through a smooth configuration: one independent coordinate moves, the others rest.

    configuration, independent columns --predictor, Newton--> poses along each line, both ways --> Track

At each pose the closure's Jacobian gives all instantaneous motions, and with them what of the mechanism is close to
losing rank there: the closure itself, the hold of the drives, the freedoms of the platform, a limb.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

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
    variety = setting.variety
    screws = variety.forward(q[None])[0][0]
    jacobian = variety.jacobians(screws[None], q[None])[0]
    rank = variety.columns - setting.dimension
    _, s, vt = np.linalg.svd(jacobian)
    motions = vt[rank:].T
    rest = np.linalg.svd(motions[list(held)])[2][len(held) :] if held else np.eye(setting.dimension)
    line = motions @ rest[0]
    if before is not None:
        if len(held) < setting.dimension - 1 or rank == 0:
            line = before
        line = line if line @ before >= 0 else -line
    margins = {"closure": float(s[rank - 1]) if rank else 1.0}
    if len(setting.drives) >= setting.dimension:
        margins["drives"] = float(np.linalg.svd(motions[list(setting.drives)], compute_uv=False)[setting.dimension - 1])
    if setting.order:
        twists = body_twists(setting.network, variety, screws, setting.body) @ motions
        margins["platform"] = float(np.linalg.svd(twists, compute_uv=False)[setting.order - 1])
    for name, (columns, most) in setting.limbs.items():
        margins[name] = float(np.linalg.svd(screws[list(columns)], compute_uv=False)[most - 1])
    return Pose(q, motions, line, margins)


def corrected(setting: Setting, q: Array, held: Sequence[int]) -> Array | None:
    """The pose nearest to q with the loops closed and the held coordinates at the reference; None without one."""
    variety, start = setting.variety, q
    picked = np.eye(variety.columns)[list(held)]
    for _ in range(NEWTON):
        residuals, jacobians = variety.evaluate(q[None])
        residual = np.concatenate([residuals[0], q[list(held)]])
        if np.linalg.norm(residual) < CLOSED:
            return q
        q = q - np.linalg.pinv(np.concatenate([jacobians[0], picked]), rcond=CUT_OFF) @ residual
        if np.linalg.norm(q - start) > JUMPED * STRIDE:
            return None
    return None


def track(setting: Setting, column: int, held: Sequence[int], sign: int, *, most: int = MOST_STEPS) -> Track:
    """The line of one coordinate from the reference in one direction, at most so many poses."""
    origin = np.zeros(setting.variety.columns)
    pose = pose_at(setting, origin, held, None)
    direction = pose.direction * sign * (1 if pose.direction[column] >= 0 else -1)
    pose = pose_at(setting, origin, held, direction)
    poses = [pose]
    slides = {start for e in setting.network.edges.values() for motion, start in e.motions if motion.prismatic}
    turns = np.array([0.0 if c in slides else 2 * np.pi for c in range(setting.variety.columns)])
    limit = ENDS[1] if column in slides else ENDS[0]
    while len(poses) < most:
        stepped = _step(setting, poses[-1], held)
        if stepped is None:
            return Track(column, tuple(held), tuple(poses), "the line could not be followed further")
        stepped = the_other_way_round(setting, stepped, held)
        poses.append(stepped)
        if abs(stepped.q[column]) > limit:
            return Track(column, tuple(held), tuple(poses), "half a turn" if limit == ENDS[0] else "far away")
        away = np.abs(stepped.q)
        away = np.where(turns > 0, np.abs((away + np.pi) % (2 * np.pi) - np.pi), away)
        if len(poses) > 4 and np.linalg.norm(away) < 0.6 * STRIDE and stepped.direction @ poses[0].direction > 0:
            return Track(column, tuple(held), tuple(poses), "back at the reference")
    return Track(column, tuple(held), tuple(poses), "as far as was looked")


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
    screws = setting.variety.forward(q[None])[0][0]
    seen = np.eye(len(q))
    for columns in balls:
        seen[np.ix_(columns, columns)] = screws[columns, :3].T
    return seen


def _step(setting: Setting, pose: Pose, held: Sequence[int]) -> Pose | None:
    for part in SHRINK:
        q = corrected(setting, pose.q + part * STRIDE * pose.direction, held)
        if q is not None and (q - pose.q) @ pose.direction > 0:
            after = pose_at(setting, q, held, pose.direction)
            if after.direction @ pose.direction > JUMPED:
                return after
    return None
