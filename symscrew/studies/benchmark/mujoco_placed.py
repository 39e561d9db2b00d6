"""A MuJoCo model put into the state of a mechanism's bodies, by MuJoCo's own Jacobians; needs MuJoCo to be imported."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mujoco
import numpy as np

from symscrew.reference import BodyState

Array = np.ndarray
CONSISTENT = 1e-9  # relative gap above which the bodies are not where the joints can have them: an error
RANK = 1e-9  # relative: below, a direction that the joints do not move; above, one that they do


class PlacedModel:
    """A MuJoCo model of a mechanism and the state of its bodies.

    Every body of `order` (parents first) must have absolute axes in the reference configuration, where its
    origin is at `home[body]`, and must be carried by joints of its own.
    """

    def __init__(self, model: Any, ground: str, home: Mapping[str, Array]) -> None:
        self.model, self.ground, self.home, self.order = model, ground, home, list(home)
        self.data = mujoco.MjData(model)
        kind = mujoco.mjtObj.mjOBJ_BODY
        self.index = {name: mujoco.mj_name2id(model, kind, name) for name in self.order}

    def set_state(self, states: Mapping[str, BodyState]) -> None:
        """Set qpos, qvel, qacc of the engine's tree from the bodies; ValueError if its joints do not fit."""
        model, data = self.model, self.data
        mujoco.mj_resetData(model, data)
        for name in self.order:
            self._place(name, states[name])
        mujoco.mj_fwdPosition(model, data)
        points = {name: data.xpos[self.index[name]].copy() for name in self.order}
        data.qvel[:] = self.velocity(states)
        mujoco.mj_fwdVelocity(model, data)
        jacobian = np.concatenate([self._jacobian(n, points[n]) for n in self.order])
        drift = np.concatenate([self._jacobian_rate(n, points[n]) @ data.qvel for n in self.order])
        rates = [np.r_[states[n].twist_rate[:3], states[n].acceleration_at(points[n])] for n in self.order]
        data.qacc[:] = _exact(jacobian, np.concatenate(rates) - drift, "twist rates")

    def velocity(self, states: Mapping[str, BodyState]) -> Array:
        """Velocities (nv,) of the engine's joints in the present pose from the twists of the bodies."""
        points = {name: self.data.xpos[self.index[name]] for name in self.order}
        jacobian = np.concatenate([self._jacobian(n, points[n]) for n in self.order])
        twists = [np.r_[states[n].twist[:3], states[n].velocity_at(points[n])] for n in self.order]
        return _exact(jacobian, np.concatenate(twists), "twists")

    def _place(self, name: str, state: BodyState) -> None:
        """Newton on the coordinates of the joint that carries the body; all bodies before it are in place."""
        model, data, i = self.model, self.data, self.index[name]
        dofs = np.flatnonzero(model.dof_bodyid == i)
        goal = state.rotation @ self.home[name] + state.translation
        for _ in range(40):
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            turn = _rotation_vector(state.rotation @ data.xmat[i].reshape(3, 3).T)
            error = np.r_[turn, goal - data.xpos[i]]
            step = np.zeros(model.nv)
            step[dofs] = np.linalg.lstsq(self._jacobian(name, data.xpos[i])[:, dofs], error, rcond=None)[0]
            mujoco.mj_integratePos(model, data.qpos, step, 1.0)
            if np.abs(step).max(initial=0.0) < 1e-15:
                break
        mujoco.mj_kinematics(model, data)
        turned = np.abs(data.xmat[i].reshape(3, 3) - state.rotation).max()
        gap = max(np.abs(data.xpos[i] - goal).max(), turned)
        if gap > 1e-9:
            raise ValueError(f"body '{name}' is {gap:.1e} off what its joints allow")

    def _jacobian(self, body: str, point: Array) -> Array:
        """(6, nv): angular velocity of the body, then velocity of its point that is at `point` just now."""
        return self._point_jacobian(mujoco.mj_jac, body, point)

    def _jacobian_rate(self, body: str, point: Array) -> Array:
        """(6, nv): time derivative of `_jacobian` for the point as one of the body."""
        return self._point_jacobian(mujoco.mj_jacDot, body, point)

    def _point_jacobian(self, function: Callable[..., None], body: str, point: Array) -> Array:
        turn, shift = np.zeros((3, self.model.nv)), np.zeros((3, self.model.nv))
        if body != self.ground:
            function(self.model, self.data, shift, turn, np.array(point), self.index[body])
        return np.concatenate([turn, shift])

    def _rotation(self, body: str) -> Array:
        return np.eye(3) if body == self.ground else self.data.xmat[self.index[body]].reshape(3, 3)

    def twist_rates(self, acceleration: Array) -> dict[str, Array]:
        """{body: (alpha ; d v_O/dt)} from generalised accelerations in the state that is set."""
        rates = {}
        for name in self.order:
            point = self.data.xpos[self.index[name]]
            jacobian, change = self._jacobian(name, point), self._jacobian_rate(name, point)
            rate = jacobian @ acceleration + change @ self.data.qvel
            twist = jacobian @ self.data.qvel
            linear = rate[3:] - np.cross(rate[:3], point) - np.cross(twist[:3], twist[3:])
            rates[name] = np.r_[rate[:3], linear]
        return rates


def _rotation_vector(rotation: Array) -> Array:
    """The rotation vector of a rotation matrix (3, 3), through MuJoCo's quaternion."""
    quaternion, vector = np.zeros(4), np.zeros(3)
    mujoco.mju_mat2Quat(quaternion, np.ascontiguousarray(rotation).ravel())
    mujoco.mju_quat2Vel(vector, quaternion, 1.0)
    return vector


def _exact(matrix: Array, right: Array, what: str) -> Array:
    """Solution of a consistent overdetermined system; ValueError when it is not consistent."""
    solution: Array = np.linalg.lstsq(matrix, right, rcond=RANK)[0]
    gap = np.abs(matrix @ solution - right).max(initial=0.0)
    if gap > CONSISTENT * max(1.0, np.abs(right).max(initial=0.0)):
        raise ValueError(f"the {what} of the bodies are {gap:.1e} off what the joints of the tree allow")
    return solution
