"""What names of a motion mean: numbers of a configuration, how fast they change, and what of that rates alone do.

name --goals_of--> Goals: values (n, m), rows of their Jacobian in v (n, m, nv), accelerations at a = 0

"limb5_S.qx", "arm1_R"          a coordinate of the tree, by its label [rad, m, or an entry of a quaternion]
"platform.x"                    how far the middle of the platform's joints is displaced from the reference [m]
"platform.qx", "platform.rx"    how the platform is turned from the reference: quaternion, rotation vector [rad]
"platform.tilt", "platform.yaw" the same as tilt, azimuth, torsion, or roll, pitch, yaw; `tilt` alone is the platform's
"tool.x"                        where a named point of the platform is [m]
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.kinematics import PoseRow, full_name
from symscrew.model import Model
from symscrew.runtime import CompiledModel
from symscrew.studies.given_motion.pose_parts import PARTS, Jet, met_rows, rows_of, wanted_rows
from symscrew.studies.given_motion.wanted_motion import WantedMotion
from symscrew.studies.platform_motion import coordinate_rates, platform_index

Array = np.ndarray
AXES = "xyz"
TURNED = ("qw", "qx", "qy", "qz")
VECTOR = ("rx", "ry", "rz")
PART = "platform's"  # begins the names of rows of a pose; no name of a user has an apostrophe
SMALL = 1e-2  # rotation vectors below this [rad] by the series below, whose next term is 1e-18 of the first there


class Body(NamedTuple):
    """The platform at states: rotation (n, 3, 3), place of O's point (n, 3), twist and its rate (n, 6), quaternion."""

    rotation: Array
    place: Array
    twist: Array
    rate: Array
    turn: Array


@dataclass(frozen=True, repr=False)
class Goals:
    """Numbers of configurations, in the order of the motion's names.

    `coordinates`: columns into q; `turned`: entries of the platform's quaternion; `places`: (point [m] in the
    reference, axis, what is taken off); `parts`: functions of the platform's rotation. Each entry of `order` is (kind,
    place among its kind).
    """

    model: Model
    functions: CompiledModel
    coordinates: tuple[int, ...]
    turned: tuple[int, ...]
    places: tuple[tuple[tuple[float, float, float], int, float], ...]
    parts: tuple[PoseRow, ...]
    order: tuple[tuple[str, int], ...]

    def __repr__(self) -> str:
        return f"Goals({self.model.name}: {len(self.order)} numbers)"

    def values(self, q: Array) -> Array:
        """(n, m) at q (n, nq)."""
        zero = np.zeros((len(q), len(self.model.system.tree.v)))
        return self._picked(q[:, list(self.coordinates)], *self._of_body(self._body(q, zero, zero), 0))

    def along(self, q: Array, basis: Array) -> Array:
        """How fast the numbers change along the columns of a basis of v (n, nv, d): (n, m, d)."""
        count = basis.shape[-1]
        v = np.swapaxes(basis, 1, 2).reshape(-1, basis.shape[1])
        found = self.rates(np.repeat(q, count, axis=0), v)
        return np.swapaxes(found.reshape(len(q), count, -1), 1, 2)

    def rates(self, q: Array, v: Array) -> Array:
        """(n, m) at q and v."""
        moved = coordinate_rates(self.model, q, v)[:, list(self.coordinates)]
        return self._picked(moved, *self._of_body(self._body(q, v, np.zeros_like(v)), 1))

    def accelerations(self, q: Array, v: Array, a: Array) -> Array:
        """(n, m) at q, v and a."""
        second = _second_rates(self.model, q, v, a)[:, list(self.coordinates)]
        return self._picked(second, *self._of_body(self._body(q, v, a), 2))

    def _picked(self, coordinates: Array, turned: Array, places: Array, parts: Array) -> Array:
        kinds = {"coordinate": coordinates, "turned": turned, "place": places, "part": parts}
        return np.stack([kinds[kind][:, k] for kind, k in self.order], axis=1)

    def _body(self, q: Array, v: Array, a: Array) -> Body | None:
        if not self.turned and not self.places and not self.parts:
            return None
        k = platform_index(self.model)
        pose = np.asarray(self.functions.body_poses(q))[:, :, k]
        twist = np.asarray(self.functions.body_twists(q, v))[:, :, k]
        rate = np.asarray(self.functions.body_twist_rates(q, v, a))[:, :, k]
        rotation = pose[:, :9].reshape(-1, 3, 3).transpose(0, 2, 1)
        return Body(rotation, pose[:, 9:], twist, rate, quaternion_of(rotation))

    def _of_body(self, body: Body | None, order: int) -> tuple[Array, Array, Array]:
        """Quaternion's entries, places and parts of the pose, or their first or second derivatives."""
        if body is None:
            return np.zeros((0, 0)), np.zeros((0, 0)), np.zeros((0, 0))
        spin, gain = body.twist[:, :3], body.rate[:, :3]
        turn = body.turn
        if order:
            first = _by_spin(spin, body.turn)
            turn = first if order == 1 else _by_spin(gain, body.turn) + _by_spin(spin, first)
        made = []
        for point, axis, off in self.places:
            here = body.rotation @ np.array(point) + body.place
            if order == 0:
                made.append(here[:, axis] - off)
                continue
            moved = body.twist[:, 3:] + np.cross(spin, here)
            second = body.rate[:, 3:] + np.cross(gain, here) + np.cross(spin, moved)
            made.append((moved if order == 1 else second)[:, axis])
        places = np.stack(made, axis=1) if made else np.zeros((len(turn), 0))
        jets = met_rows(self.parts, body.rotation, spin, gain)
        parts = [(jet.value, jet.first, jet.second)[order] for jet in jets]
        return turn[:, list(self.turned)], places, np.stack(parts, axis=1) if parts else np.zeros((len(turn), 0))


def quaternion_of(rotation: Array) -> Array:
    """(n, 4), w first and not negative, of rotations (n, 3, 3); by the largest entry, so that none is near zero."""
    trace = np.trace(rotation, axis1=1, axis2=2)
    squares = np.stack([trace, *(rotation[:, k, k] * 2 - trace for k in range(3))], axis=1)
    full = np.empty((len(rotation), 4, 4))
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        full[:, 0, k + 1] = full[:, k + 1, 0] = rotation[:, j, i] - rotation[:, i, j]
        full[:, i + 1, j + 1] = full[:, j + 1, i + 1] = rotation[:, i, j] + rotation[:, j, i]
    full[:, range(4), range(4)] = 1 + squares
    best = full[np.arange(len(full)), squares.argmax(axis=1)]
    unit = best / np.linalg.norm(best, axis=1, keepdims=True)
    found: Array = unit * np.where(unit[:, :1] < 0, -1.0, 1.0)
    return found


def _by_spin(spin: Array, turn: Array) -> Array:
    """Half the product of an angular velocity, absolute axes, with a quaternion: its rate."""
    w, vector = turn[:, :1], turn[:, 1:]
    scalar = -(spin * vector).sum(axis=1, keepdims=True)
    found: Array = 0.5 * np.concatenate([scalar, w * spin + np.cross(spin, vector)], axis=1)
    return found


def _second_rates(model: Model, q: Array, v: Array, a: Array) -> Array:
    """d2 q / dt2: rates are linear in q and v, q_dot = E(q) v, so E(q) a + E(q_dot) v."""
    steady = [k for link in model.system.tree.links[1:] if link.q.stop - link.q.start != 4
              for k in range(link.q.start, link.q.stop)]  # fmt: skip
    carried = coordinate_rates(model, coordinate_rates(model, q, v), v)
    carried[:, steady] = 0.0
    found: Array = coordinate_rates(model, q, a) + carried
    return found


def goals_of(model: Model, functions: CompiledModel, wanted: WantedMotion) -> tuple[Goals, WantedMotion]:
    """What is asked for of a model; and the motion with rotation vectors turned into quaternions.

    Raises:
        DescriptionError: a name that is no coordinate, body or point of the platform.
    """
    mechanism, labels = model.mechanism, [c.label for c in model.system.tree.q]
    platform = mechanism.platform or list(mechanism.bodies)[-1]
    wanted, parts = _parts(_quaternions(_with_owners(wanted, mechanism, labels)), platform, labels)
    own = {p.name: p for p in mechanism.points.values() if p.body == platform}
    coordinates: list[int] = []
    turned: list[int] = []
    places: list[tuple[tuple[float, float, float], int, float]] = []
    order: list[tuple[str, int]] = []
    for name in wanted.names:
        owner, _, part = name.rpartition(".")
        if name in labels:
            order.append(("coordinate", len(coordinates)))
            coordinates.append(labels.index(name))
        elif owner == platform and part in TURNED:
            order.append(("turned", len(turned)))
            turned.append(TURNED.index(part))
        elif name.startswith(PART):
            order.append(("part", int(part)))
        elif part in tuple(AXES) and (owner == platform or owner in own):
            at = _middle(model, platform) if owner == platform else _numbers(mechanism, own[owner].at)
            axis = AXES.index(part)
            order.append(("place", len(places)))
            places.append((at, axis, at[axis] if owner == platform else 0.0))
        else:
            known = [*labels, *(f"{platform}.{k}" for k in (*AXES, *VECTOR, *TURNED, *PARTS))]
            known += [f"{point}.{k}" for point in own for k in AXES]
            raise DescriptionError(
                f"{name}: expected a coordinate, {platform!r} or a point of it with .x ...; {did_you_mean(name, known)}"
            )
    return Goals(model, functions, tuple(coordinates), tuple(turned), tuple(places), parts, tuple(order)), wanted


def _with_owners(wanted: WantedMotion, mechanism: Mechanism, labels: Sequence[str]) -> WantedMotion:
    """The motion with full names: `tilt` and `z` alone are the platform's."""
    names = tuple(name if name in labels else full_name(mechanism, name) for name in wanted.names)
    if len(set(names)) < len(names):
        twice = next(name for name in names if names.count(name) > 1)
        raise DescriptionError(f"{twice}: is given twice, with its owner and without")
    return replace(wanted, names=names)


def _parts(wanted: WantedMotion, platform: str, labels: Sequence[str]) -> tuple[WantedMotion, tuple[PoseRow, ...]]:
    """The motion with rows of a pose in place of tilt, azimuth ... yaw, and the functions that these are."""
    at = {part: f"{platform}.{part}" for part in PARTS}
    given = {p: wanted.names.index(name) for p, name in at.items() if name in wanted.names and name not in labels}
    if not given:
        return wanted, ()
    rows = tuple(rows_of(tuple(given)))
    jets = {p: Jet(wanted.values[:, k], wanted.rates[:, k], wanted.accelerations[:, k]) for p, k in given.items()}
    found = wanted_rows(jets)
    kept = [k for k in range(len(wanted.names)) if k not in given.values()]
    names = [wanted.names[k] for k in kept] + [f"{PART} {' '.join(given)}.{k}" for k in range(len(rows))]
    histories = (
        np.concatenate([before[:, kept], np.stack(more, axis=1)], axis=1)
        for before, more in (
            (wanted.values, [jet.value for jet in found]),
            (wanted.rates, [jet.first for jet in found]),
            (wanted.accelerations, [jet.second for jet in found]),
        )
    )
    values, rates, accelerations = histories
    return replace(wanted, names=tuple(names), values=values, rates=rates, accelerations=accelerations), rows


def _numbers(mechanism: object, at: object) -> tuple[float, float, float]:
    x, y, z = (float(mechanism.number(c)) for c in at)  # type: ignore[attr-defined]
    return x, y, z


def _middle(model: Model, body: str) -> tuple[float, float, float]:
    """The middle of a body's joints in the reference configuration [m]."""
    joints = [j for j in model.mechanism.joints.values() if body in (j.parent, j.child)]
    x, y, z = np.mean([_numbers(model.mechanism, j.point) for j in joints], axis=0)
    return float(x), float(y), float(z)


def _quaternions(wanted: WantedMotion) -> WantedMotion:
    """Rotation vectors of a body, all three components of which must be given, as quaternions."""
    names = list(wanted.names)
    for owner in dict.fromkeys(n.rpartition(".")[0] for n in names if n.rpartition(".")[2] in VECTOR):
        parts = [f"{owner}.{k}" for k in VECTOR]
        missing = [p for p in parts if p not in names]
        if missing:
            raise DescriptionError(
                f"{', '.join(missing)}: missing; a rotation vector has three components. To ask for fewer, give "
                f"entries of the quaternion: {owner}.qx is about half the angle about x"
            )
        at = [names.index(p) for p in parts]
        found = turn_of_vector(wanted.values[:, at], wanted.rates[:, at], wanted.accelerations[:, at])
        kept = [k for k in range(len(names)) if k not in at]
        names = [names[k] for k in kept] + [f"{owner}.{k}" for k in TURNED]
        values, rates, accelerations = (
            np.concatenate([before[:, kept], more], axis=1)
            for before, more in zip((wanted.values, wanted.rates, wanted.accelerations), found, strict=True)
        )
        wanted = replace(wanted, names=tuple(names), values=values, rates=rates, accelerations=accelerations)
    return wanted


def turn_of_vector(r: Array, r_dot: Array, r_ddot: Array) -> tuple[Array, Array, Array]:
    """Quaternions (n, 4) of rotation vectors (n, 3) with first and second derivatives.

    With x = r . r: (cos(sqrt(x)/2), s r), s = sin(sqrt(x)/2)/sqrt(x), and d cos(sqrt(x)/2)/dx = -s/4.
    """
    x = (r * r).sum(axis=1, keepdims=True)
    x1 = 2 * (r * r_dot).sum(axis=1, keepdims=True)
    x2 = 2 * ((r_dot * r_dot) + (r * r_ddot)).sum(axis=1, keepdims=True)
    s, ds, dds = _sine_and_slopes(x)
    s1, s2 = ds * x1, dds * x1**2 + ds * x2
    w, w1, w2 = np.cos(np.sqrt(x) / 2), -s * x1 / 4, -(s1 * x1 + s * x2) / 4
    vector = s * r
    first = s1 * r + s * r_dot
    second = s2 * r + 2 * s1 * r_dot + s * r_ddot
    return (np.concatenate([w, vector], 1), np.concatenate([w1, first], 1), np.concatenate([w2, second], 1))


def _sine_and_slopes(x: Array) -> tuple[Array, Array, Array]:
    """s(x) = sin(sqrt(x)/2)/sqrt(x) and its derivatives by x, through x = 0."""
    small = x < SMALL**2
    safe = np.where(small, 1.0, x)
    root = np.sqrt(safe)
    sine, cosine = np.sin(root / 2), np.cos(root / 2)
    s = sine / root
    ds = (cosine / 4 - s / 2) / safe
    dds = (-s / 16 - 3 * ds / 2) / safe
    series = (0.5 - x / 48 + x**2 / 3840, -1 / 48 + x / 1920, 1 / 1920 - x / 107520)
    return tuple(np.where(small, a, b) for a, b in zip(series, (s, ds, dds), strict=True))  # type: ignore[return-value]
