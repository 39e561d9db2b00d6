"""Given rates as rows on the rates of the tree: of its own coordinates, of passive joints, of parts of a body's pose.

"limb2_S.rx", "tilt", "A" --programs at q, for every rate of the tree--> rows of d(coordinate)/dt by v
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.functions import joint_freedom_labels, moving_bodies
from symscrew.kinematics import (
    BODY_PARTS,
    SPHERICAL_PARTS,
    body_centre,
    coordinate_units,
    full_name,
    nearest_names,
    pose_rates,
    typable_names,
)
from symscrew.mobility import with_parameters
from symscrew.model import Model

Array = np.ndarray


def rate_rows(model: Model, q: Array, rates: Mapping[str, float], parameters: Mapping[str, float]) -> Array:
    """A row (nv,) for each of the rates: what is multiplied with v gives it [rad/s, m/s], at the configuration q.

    Args:
        model: with kinematics of all bodies and joints.
        q: configuration (nq,).
        rates: by labels of v, or by the names of coordinates that `--at` takes.
        parameters: values of run-time parameters that are not the description's.

    Raises:
        DescriptionError: an unknown name, or a rate that does not exist there.
    """
    at = _Motions(model, q, parameters)
    return np.array([at.row(name) for name in rates]).reshape(len(rates), len(model.system.tree.v))


class _Motions:
    """Every rate of the tree by itself: what joints and bodies then do."""

    def __init__(self, model: Model, q: Array, parameters: Mapping[str, float]) -> None:
        self.model, self.q, self.parameters = model, q, parameters
        self.labels = [c.label for c in model.system.tree.v]
        self.mechanism = model.mechanism

    def row(self, name: str) -> Array:
        if name in self.labels:
            return np.asarray(np.eye(len(self.labels))[self.labels.index(name)])
        label = full_name(self.mechanism, name)
        if label not in coordinate_units(self.mechanism) and label not in self.joint_labels:
            known = [*self.labels, *typable_names(self.mechanism)]
            raise DescriptionError(f"initial.rates: there is no {name!r}; {nearest_names(name, known)}")
        row = self._row(label)
        if row is None or not np.isfinite(row).all():
            raise DescriptionError(
                f"initial.rates: {name} has no rate here; expected rates of x, y, z, rx, ry, rz, or of joints"
            )
        return row

    def _row(self, label: str) -> Array | None:
        owner, _, part = label.rpartition(".")
        if label in self.joint_labels:
            return np.asarray(self._joint_rates[:, self.joint_labels.index(label)])
        joint = self.mechanism.joints.get(owner)
        if joint is not None and part in SPHERICAL_PARTS:
            return self._of_bodies(joint.parent, joint.child).get(part)
        virtual = owner.removesuffix("_pose")  # the joint on which the package hangs a platform
        body = owner if owner in self.mechanism.bodies else virtual
        return self._of_bodies(self.mechanism.ground, body).get(part) if part in BODY_PARTS else None

    @cached_property
    def joint_labels(self) -> list[str]:
        """Labels of all freedoms, of cut joints too."""
        return [label for label, _, _ in joint_freedom_labels(self.model.system)]

    def _of_bodies(self, parent: str, child: str) -> dict[str, Array]:
        """Rates of all parts of the pose of a body in the axes of another, which moves, too."""
        one, first = self._body(parent)
        two, second = self._body(child)
        turn = one[:, :3].T @ two[:, :3]
        omega = (second[:, :3] - first[:, :3]) @ one[:, :3]
        mechanism, _ = with_parameters(self.mechanism, self.parameters)
        place = body_centre(mechanism, child)
        now = two[:, :3] @ place + two[:, 3]
        return pose_rates(turn, now - place, omega, second[:, 3:] + np.cross(second[:, :3], now))

    def _body(self, name: str) -> tuple[Array, Array]:
        """A body's rotation and translation from the reference (3, 4), and its twists at O (nv, 6)."""
        moving = moving_bodies(self.model.system)
        if name not in moving:
            return np.eye(3, 4), np.zeros((len(self.labels), 6))
        k = moving.index(name)
        pose = self._asked("body_poses", self.q)[0][12 * k : 12 * k + 12]
        return np.column_stack([pose[:9].reshape(3, 3).T, pose[9:]]), self._twists[:, 6 * k : 6 * k + 6]

    @cached_property
    def _twists(self) -> Array:
        return self._asked("body_twists", self.q, np.eye(len(self.labels)))

    @cached_property
    def _joint_rates(self) -> Array:
        return self._asked("joint_rates", self.q, np.eye(len(self.labels)))

    def _asked(self, function: str, q: Array, *v: Array) -> Array:
        """A function for every row of v; the parameters' values where it takes them."""
        many = len(v[0]) if v else 1
        given = [np.repeat(q[None], many, axis=0), *v]
        run_time = [p for p in self.mechanism.parameters.values() if p.run_time]
        values = np.array([[self.parameters.get(p.name, float(p.value)) for p in run_time]] * many)
        taken = self.model.programs[function].inputs
        known = [*given, values] if any(port.name == "p" for port in taken) else given
        (found,), _ = self.model(function, *known)
        return np.asarray(found)
