"""Configurations of many cases where coordinates of any joint, or of the platform's pose, have given values.

q, a part of the way --Newton on loops and goals together--> q with the loops closed; what is not given stays as near
as the loops allow, by the least step of all joints.

The rows of the goals are differentiated by central differences of the model's compiled functions, so that any number
that a function gives can be a goal; the loops have their own Jacobian.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.functions import moving_bodies
from symscrew.kinematics import BODY_PARTS, Doubles, PoseRow, body_centre, pose_rows
from symscrew.model import Model
from symscrew.studies.workspace.configurations import Call

Array = np.ndarray
DIFFERENCE = 1e-6  # [rad, lengths]: half the step of central differences, right to ten digits
MOST_STEPS = 25  # of Newton's method at each step of the walk: regular ones take four
REACHED = 1e-11  # without units: loops and goals open by less, rounding of differences and of the compiled functions
CUT_OFF = 1e-9  # relative singular values below are left out: redundant closure equations have 1e-16
NOT_CONVERGED = 3  # the status that `assemble` has for it


@dataclass(frozen=True)
class NamedCoordinates:
    """Names with the values that every case wants (cases) [rad, m], and the model whose functions say where it is.

    `begun`: the values (cases) where the walks begin; those of the reference configuration where empty.
    """

    model: Model
    call: Call
    wanted: Mapping[str, Array]
    begun: Mapping[str, Array] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Raises DescriptionError for a coordinate that no function of the model gives."""
        displaced = self._displacements
        for name in self.wanted:
            owner, _, part = name.rpartition(".")
            if name not in displaced and not (owner in self.model.mechanism.bodies and part in BODY_PARTS):
                raise DescriptionError(f"--over: {name} cannot be swept; give a joint's displacement or a body's pose")

    @property
    def _displacements(self) -> list[str]:
        return list(self.model.programs["joint_displacements"].outputs[0].labels)

    def reached(self, part: float, q: Array, extra: Sequence[Array]) -> tuple[Array, Array]:
        """q (cases, nq) with the goals at a part of the way from where it begins, and status (cases)."""
        system, q = self.model.system, np.array(q)
        units = np.array([system.length if c.kind == "length" else 1.0 for c in system.tree.v])
        goals = self._goals(part, len(q))
        left = np.full(len(q), np.inf)
        for _ in range(MOST_STEPS):
            miss, slopes = self._rows(q, extra, goals, units)
            left = np.abs(miss).max(axis=1, initial=0.0)
            going = np.isfinite(miss).all(axis=1) & np.isfinite(slopes).all(axis=(1, 2)) & (left > REACHED)
            if not going.any():
                break
            step = np.zeros((len(q), len(units)))
            inverse = np.linalg.pinv(slopes[going], rcond=CUT_OFF)
            step[going] = -(inverse @ miss[going][:, :, None])[:, :, 0]
            q = np.where(going[:, None], system.moved(q, step * units), q)
        good = left <= REACHED
        return np.where(good[:, None], q, np.nan), np.where(good, 0, NOT_CONVERGED)

    def _goals(self, part: float, count: int) -> list[tuple[str, list[PoseRow]]]:
        """Body -> rows of its pose, and "" -> rows of displacements, at a part of the way."""
        poses: dict[str, dict[str, Array]] = {}
        rows: list[PoseRow] = []
        start = self.call("joint_displacements", self.model.system.reference[None], *self._defaults)[0][0][0]
        for name, value in self.wanted.items():
            if name in self._displacements:
                k = self._displacements.index(name)
                slides = self.model.programs["joint_displacements"].outputs[0].units[k] == "m"
                first = self.begun.get(name, start[k])
                rows.append(_displacement(k, (1 - part) * first + part * value, slides))
            else:
                body, _, end = name.rpartition(".")
                first = self.begun.get(name, value if end == "azimuth" else 0.0)  # upright has any azimuth
                poses.setdefault(body, {})[end] = (1 - part) * first + part * value
        made = [(body, pose_rows(parts, Doubles(), np.tan)) for body, parts in poses.items()]
        return [*made, ("", rows)]

    @property
    def _defaults(self) -> list[Array]:
        values = self.model.system.parameter_values
        return [values[None]] if len(values) else []

    def _rows(
        self, q: Array, extra: Sequence[Array], goals: Sequence[tuple[str, list[PoseRow]]], units: Array
    ) -> tuple[Array, Array]:
        """What loops and goals miss (cases, rows), and its slopes by the rates, without units."""
        system, count, nv = self.model.system, len(q), len(units)
        miss, slopes = [], []
        if system.cuts:
            rows = np.array([1 / system.length if r.unit == "N" else 1.0 for cut in system.cuts for r in cut.rows])
            miss.append(self.call("closure", q, *extra)[0][0] * rows)
            flat = self.call("closure_jacobian", q, *extra)[0][0]
            slopes.append(flat.reshape(count, nv, -1).transpose(0, 2, 1) * rows[:, None] * units)
        miss.append(self._missed(q, extra, goals))
        steps = np.repeat(DIFFERENCE * np.concatenate([np.eye(nv), -np.eye(nv)])[None], count, 0).reshape(-1, nv)
        near = system.moved(np.repeat(q, 2 * nv, 0), steps * units)
        tiled = [(body, [_repeated(row, 2 * nv) for row in rows_]) for body, rows_ in goals]
        around = self._missed(near, [np.repeat(p, 2 * nv, 0) for p in extra], tiled).reshape(count, 2, nv, -1)
        slopes.append(((around[:, 0] - around[:, 1]) / (2 * DIFFERENCE)).transpose(0, 2, 1))
        return np.concatenate(miss, axis=1), np.concatenate(slopes, axis=1)

    def _missed(self, q: Array, extra: Sequence[Array], goals: Sequence[tuple[str, list[PoseRow]]]) -> Array:
        """How far the goals are missed (cases, goals), lengths divided by the characteristic length."""
        system, made = self.model.system, []
        poses = self.call("body_poses", q, *extra)[0][0] if any(body for body, _ in goals) else None
        bodies = moving_bodies(system)
        for body, rows in goals:
            if body:
                assert poses is not None
                block = poses[:, 12 * bodies.index(body) : 12 * bodies.index(body) + 12]
                r = block[:, :9].reshape(-1, 3, 3).transpose(2, 1, 0)
                c = body_centre(system.mechanism, body)
                place: Array = np.einsum("ijn,j->in", r, c) + block[:, 9:].T - c[:, None]
            elif rows:
                r = place = self.call("joint_displacements", q, *extra)[0][0].T
            for row in rows:
                size = system.length if row.is_length else 1.0
                made.append((row.of(r, place) - row.goal) / size)
        return np.stack(made, axis=1)


def _displacement(k: int, goal: Array, slides: bool) -> PoseRow:
    return PoseRow(lambda _, values: values[k], goal, slides)


def _repeated(row: PoseRow, times: int) -> PoseRow:
    return PoseRow(row.of, np.repeat(row.goal, times), row.is_length)
