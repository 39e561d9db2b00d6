"""MuJoCo as an independent engine for any mechanism, exact to rounding.

The engine grows its own breadth-first tree from the ground. Its MuJoCo bodies have absolute axes in the
reference configuration and their origin at the point of the joint that carries them. Joints that would close
a loop are cut and not given to MuJoCo (its equality constraints are soft): their constraint rows are taken
from MuJoCo's Jacobians at the joint's point on both bodies, their rates from `mj_jacDot`.

MuJoCo refuses bodies without inertia. A body whose inertia is missing or singular gets an isotropic extra
inertia, and the wrench that this extra needs is applied to the body from outside, computed from MuJoCo's own
accelerations: the result is that of the given inertia, without a small number anywhere.

From the package only the description, the plain data of `BodyState` and `PlacedModel`, which sets the state of a
MuJoCo model by MuJoCo's own Jacobians, are used.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from symscrew.description.mechanism import Joint, Mechanism
from symscrew.reference.maximal_coordinates import BodyState, plane_axes
from symscrew.studies.benchmark.mujoco_placed import PlacedModel

Array = np.ndarray
RANK = 1e-9


@dataclass(frozen=True)
class Freedom:
    """An elementary motion: whether it turns or slides, its reference axis, and who carries the axis."""

    turns: bool
    axis: Array
    by_child: bool = False


@dataclass(frozen=True)
class EngineJoint:
    """A joint with its numbers; `freedoms` in order from parent to child."""

    name: str
    parent: str
    child: str
    point: Array
    freedoms: tuple[Freedom, ...]
    spherical: bool
    driven: tuple[int, ...]


def engine_joint(mechanism: Mechanism, joint: Joint) -> EngineJoint:
    """The numbers of a joint; raises NotImplementedError for a helical joint, which MuJoCo does not have."""
    axes = [np.array([float(mechanism.number(c)) for c in axis]) for axis in joint.axes]
    x, y, z = np.eye(3)
    ball = (Freedom(True, x), Freedom(True, y), Freedom(True, z))
    if joint.type == "R":
        freedoms: tuple[Freedom, ...] = (Freedom(True, axes[0]),)
    elif joint.type == "P":
        freedoms = (Freedom(False, axes[0]),)
    elif joint.type == "C":
        freedoms = (Freedom(False, axes[0]), Freedom(True, axes[0]))
    elif joint.type == "U":
        freedoms = (Freedom(True, axes[0]), Freedom(True, axes[1], by_child=True))
    elif joint.type == "E":
        first, second = plane_axes(axes[0])
        freedoms = (Freedom(False, first), Freedom(False, second), Freedom(True, axes[0]))
    elif joint.type == "S":
        freedoms = ball
    elif joint.type == "fixed":
        freedoms = ()
    elif joint.type == "free":
        freedoms = (Freedom(False, x), Freedom(False, y), Freedom(False, z), *ball)
    else:
        raise NotImplementedError(f"joint '{joint.name}': MuJoCo has no joint of type {joint.type}")
    point = np.array([float(mechanism.number(c)) for c in joint.point])
    spherical = joint.type in ("S", "free")
    return EngineJoint(joint.name, joint.parent, joint.child, point, freedoms, spherical, joint.driven)


class MujocoEngine(PlacedModel):
    """Dynamics of a mechanism by MuJoCo; the ground is at rest."""

    def __init__(self, mechanism: Mechanism, gravity: Sequence[float] = (0.0, 0.0, -9.81)) -> None:
        self.mechanism = mechanism
        self.gravity = np.array(gravity, dtype=float)
        self.joints = {name: engine_joint(mechanism, joint) for name, joint in mechanism.joints.items()}
        self.carrier = _breadth_first(mechanism.ground, self.joints)
        self.cut = [j for j in self.joints.values() if j.name not in {t.name for t in self.carrier.values()}]
        self.extra: dict[str, tuple[float, float]] = {}
        # Origins of the MuJoCo bodies in the reference configuration.
        home = {name: joint.point for name, joint in self.carrier.items()}
        super().__init__(self._compiled(), mechanism.ground, home)

    def _compiled(self) -> mujoco.MjModel:
        spec = mujoco.MjSpec()
        spec.option.gravity = self.gravity
        spec.compiler.degree = False
        made = {self.mechanism.ground: (spec.worldbody, np.zeros(3))}
        given = [body.mass for body in self.mechanism.bodies.values() if body.mass is not None]
        masses = [_number(self.mechanism, mass) for mass in given]
        typical = max(masses, default=1.0) or 1.0
        for name, joint in self.carrier.items():
            reverse = joint.parent == name
            base, origin = made[joint.child if reverse else joint.parent]
            body = base.add_body(name=name, pos=joint.point - origin)
            made[name] = (body, joint.point)
            self._add_inertia(body, name, joint.point, typical)
            motions = [(f.turns, f.axis) for f in joint.freedoms if not (joint.spherical and f.turns)]
            hinge, slide, ball = (getattr(mujoco.mjtJoint, f"mjJNT_{k}") for k in ("HINGE", "SLIDE", "BALL"))
            kinds = [(hinge if turns else slide, axis) for turns, axis in motions]
            if joint.spherical:
                kinds.append((ball, np.array([0.0, 0.0, 1.0])))
            for kind, axis in reversed(kinds) if reverse else kinds:
                body.add_joint(type=kind, axis=-axis if reverse else axis, pos=np.zeros(3))
        return spec.compile()

    def _add_inertia(self, body: mujoco.MjsBody, name: str, origin: Array, typical: float) -> None:
        given = self.mechanism.bodies[name]
        mass = 0.0 if given.mass is None else _number(self.mechanism, given.mass)
        com = origin if given.com is None else np.array([_number(self.mechanism, c) for c in given.com])
        inertia = np.zeros((3, 3))
        if given.inertia is not None:
            inertia = np.array([[_number(self.mechanism, c) for c in row] for row in given.inertia])
        principal, frame = np.linalg.eigh(inertia)
        regular = mass > 0 and principal[0] > 1e-9 and principal[0] + principal[1] >= principal[2]
        if not regular:
            self.extra[name] = (typical, typical)
            mass, principal = mass + typical, principal + typical
        frame = frame * np.linalg.det(frame)
        quaternion = np.zeros(4)
        mujoco.mju_mat2Quat(quaternion, frame.ravel())
        # Principal axes are handed over because MuJoCo's own diagonalisation is good to 1e-12 only.
        body.mass, body.ipos, body.inertia, body.iquat = mass, com - origin, principal, quaternion
        body.explicitinertial = True

    def _joint_point(self, joint: EngineJoint) -> Array:
        if joint.child == self.mechanism.ground:
            return joint.point
        place = self.data.xpos[self.index[joint.child]]
        return place + self._rotation(joint.child) @ (joint.point - self.home[joint.child])

    def _relative(self, joint: EngineJoint) -> Array:
        """(6, nv): twist of the child less that of the parent at the joint's point."""
        point = self._joint_point(joint)
        return self._jacobian(joint.child, point) - self._jacobian(joint.parent, point)

    def _axes(self, joint: EngineJoint) -> list[Array]:
        return [self._rotation(joint.child if f.by_child else joint.parent) @ f.axis for f in joint.freedoms]

    def _freedom_columns(self, joint: EngineJoint) -> Array:
        """(6, freedom): unit screws of the joint, angular first, at its point."""
        columns = np.zeros((6, len(joint.freedoms)))
        for k, (freedom, axis) in enumerate(zip(joint.freedoms, self._axes(joint), strict=True)):
            columns[slice(0, 3) if freedom.turns else slice(3, 6), k] = axis
        return columns

    def _drive_columns(self) -> tuple[Array, list[tuple[EngineJoint, Array]]]:
        """Generalised forces (nv, drives) of unit drives; joint and wrench (m ; f) at its point of each."""
        units = []
        for joint in self.joints.values():
            # Dual to the joint's screws: unit work on one freedom, none on the others.
            dual = np.linalg.pinv(self._freedom_columns(joint)).T
            units += [(joint, dual[:, k]) for k in joint.driven]
        columns = [self._relative(joint).T @ wrench for joint, wrench in units]
        return np.array(columns).reshape(-1, self.model.nv).T, units

    def _constraints(self) -> tuple[Array, Array, list[tuple[EngineJoint, Array]]]:
        """Rows (n, nv) of all cut joints, right-hand side of rows @ qacc, and the rows' wrenches (m ; f)."""
        rows, right, owners = [], [], []
        velocity = self.data.qvel
        for joint in self.cut:
            point, axes, relative = self._joint_point(joint), self._axes(joint), self._relative(joint)
            columns = self._freedom_columns(joint)
            forbidden = np.linalg.svd(columns)[0][:, columns.shape[1] :] if joint.freedoms else np.eye(6)
            twist = relative @ velocity
            rates = np.linalg.lstsq(columns, twist, rcond=None)[0] if joint.freedoms else np.zeros(0)
            ends = (joint.parent, joint.child)
            omega = {body: (self._jacobian(body, point) @ velocity)[:3] for body in ends}
            # Accelerations of the two material points at `point`, less what the joint's own motion brings.
            material = self._jacobian_rate(joint.child, point) - self._jacobian_rate(joint.parent, point)
            drift = -material @ velocity
            for freedom, axis, rate in zip(joint.freedoms, axes, rates, strict=True):
                turning = np.cross(omega[joint.child if freedom.by_child else joint.parent], axis) * rate
                drift[slice(0, 3) if freedom.turns else slice(3, 6)] += turning
            # The child's point slides over the parent: the second half of Coriolis' acceleration.
            drift[3:] += np.cross(omega[joint.parent], twist[3:])
            rows.append(forbidden.T @ relative)
            right.append(forbidden.T @ drift)
            owners += [(joint, wrench) for wrench in forbidden.T]
        if not rows:
            return np.zeros((0, self.model.nv)), np.zeros(0), []
        return np.concatenate(rows), np.concatenate(right), owners

    def _applied(self, loads: Mapping[str, Array], acceleration: Array) -> dict[str, Array]:
        """(f ; m about the centre of mass) on each body: loads, and what extra inertias need."""
        applied = {name: np.zeros(6) for name in self.order}
        for name, load in loads.items():
            if name != self.mechanism.ground:
                centre = self.data.xipos[self.index[name]]
                applied[name] += np.r_[load[:3], np.asarray(load)[3:] - np.cross(centre, load[:3])]
        for name, (mass, inertia) in self.extra.items():
            centre = self.data.xipos[self.index[name]]
            rate = self._jacobian(name, centre) @ acceleration
            rate = rate + self._jacobian_rate(name, centre) @ self.data.qvel
            applied[name] += np.r_[mass * (rate[3:] - self.gravity), inertia * rate[:3]]
        return applied

    def _generalised(self, applied: Mapping[str, Array]) -> Array:
        force = np.zeros(self.model.nv)
        for name, wrench in applied.items():
            force += self._jacobian(name, self.data.xipos[self.index[name]]).T @ np.r_[wrench[3:], wrench[:3]]
        return force

    def _solved(self, loads: Mapping[str, Array]) -> tuple[Array, Array]:
        """Minimum-norm drives and multipliers of the cut joints for the state that is set."""
        data = self.data
        acceleration = data.qacc.copy()
        mujoco.mj_inverse(self.model, data)
        demand = data.qfrc_inverse - self._generalised(self._applied(loads, acceleration))
        columns, _ = self._drive_columns()
        rows, _, _ = self._constraints()
        free = _null(rows)
        drives = np.linalg.lstsq(free.T @ columns, free.T @ demand, rcond=RANK)[0]
        multipliers = np.linalg.lstsq(rows.T, demand - columns @ drives, rcond=RANK)[0]
        return drives, multipliers

    def inverse_dynamics(self, states: Mapping[str, BodyState], loads: Mapping[str, Array] | None = None) -> Array:
        """Drives of least norm (drives,), in the order of the description; loads are (f ; m_O)."""
        self.set_state(states)
        return self._solved(loads or {})[0]

    def reactions(self, states: Mapping[str, BodyState], loads: Mapping[str, Array] | None = None) -> dict[str, Array]:
        """{joint: (6,)} wrench (f ; m_O) from parent on child without the drive's share.

        Joints of the tree from `mj_rnePostConstraint`, cut joints from the multipliers. One solution of many
        when the mechanism is overconstrained.
        """
        self.set_state(states)
        data = self.data
        acceleration = data.qacc.copy()
        drives, multipliers = self._solved(loads or {})
        found = {name: np.zeros(6) for name in self.joints}
        share = {name: np.zeros(6) for name in self.joints}
        for (joint, wrench), amount in zip(self._constraints()[2], multipliers, strict=True):
            found[joint.name] += self._at_origin(joint, amount * wrench)
        for (joint, wrench), amount in zip(self._drive_columns()[1], drives, strict=True):
            share[joint.name] += self._at_origin(joint, amount * wrench)
        applied = self._applied(loads or {}, acceleration)
        for joint in self.cut:
            total = found[joint.name] + share[joint.name]
            for body, sign in ((joint.child, 1.0), (joint.parent, -1.0)):
                if body != self.mechanism.ground:
                    centre = data.xipos[self.index[body]]
                    applied[body] += sign * np.r_[total[:3], total[3:] - np.cross(centre, total[:3])]
        for name, wrench in applied.items():
            data.xfrc_applied[self.index[name]] = wrench
        data.qacc[:] = acceleration
        mujoco.mj_rnePostConstraint(self.model, data)
        for name, joint in self.carrier.items():
            i = self.index[name]
            moment, force = data.cfrc_int[i, :3], data.cfrc_int[i, 3:]
            centre = data.subtree_com[self.model.body_rootid[i]]
            total = np.r_[force, moment + np.cross(centre, force)]
            found[joint.name] = (total if joint.child == name else -total) - share[joint.name]
        return found

    def forward_acceleration(
        self, states: Mapping[str, BodyState], drives: Array, loads: Mapping[str, Array] | None = None
    ) -> tuple[Array, dict[str, Array]]:
        """qacc (nv,) and {body: twist rate (6,)} for given drives; twist rates of `states` are not used."""
        self.set_state(states)
        model, data = self.model, self.data
        mass = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, mass)
        force = self._drive_columns()[0] @ np.asarray(drives, dtype=float) - data.qfrc_bias
        force = force + self._generalised(self._applied(loads or {}, np.zeros(model.nv)))
        for name, (extra, inertia) in self.extra.items():
            jacobian = self._jacobian(name, data.xipos[self.index[name]])
            mass -= jacobian.T @ (np.array([inertia] * 3 + [extra] * 3)[:, None] * jacobian)
        rows, right, _ = self._constraints()
        free = _null(rows)
        start = np.linalg.lstsq(rows, right, rcond=RANK)[0]
        motion = np.linalg.solve(free.T @ mass @ free, free.T @ (force - mass @ start))
        acceleration = start + free @ motion
        return acceleration, self.twist_rates(acceleration)

    def _at_origin(self, joint: EngineJoint, wrench: Array) -> Array:
        """(m ; f) at the joint's point as (f ; m_O)."""
        force = wrench[3:]
        return np.r_[force, wrench[:3] + np.cross(self._joint_point(joint), force)]


def _breadth_first(ground: str, joints: Mapping[str, EngineJoint]) -> dict[str, EngineJoint]:
    """{body: the joint that carries it} in an order where carriers come first."""
    carrier: dict[str, EngineJoint] = {}
    front = [ground]
    while front:
        reached = []
        for body in front:
            for joint in joints.values():
                for near, far in ((joint.parent, joint.child), (joint.child, joint.parent)):
                    if near == body and far != ground and far not in carrier:
                        carrier[far] = joint
                        reached.append(far)
        front = reached
    return carrier


def _null(rows: Array) -> Array:
    if not len(rows):
        return np.eye(rows.shape[1])
    _, values, right = np.linalg.svd(rows)
    return right[int((values > RANK * values[0]).sum()) :].T


def _number(mechanism: Mechanism, expression: object) -> float:
    return float(mechanism.number(expression))  # type: ignore[arg-type]
