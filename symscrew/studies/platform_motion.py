"""Motion of a mechanism whose platform's twist is prescribed in as many components as there are freedoms.

The components that are not prescribed follow from the closure of the loops: with the null space N of the
closure and the Jacobian J of the platform, v = N y_dot and the rows of J N y_dot = twist that are
prescribed determine y_dot. Everything comes from the generated functions of the model.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from symscrew.functions import TWIST_LABELS
from symscrew.model import Model
from symscrew.reference import BodyState
from symscrew.runtime import CompiledModel

Array = np.ndarray

ADAMS = (55 / 24, -59 / 24, 37 / 24, -9 / 24)
"""Weights of the latest slopes in the Adams-Bashforth method of order 4, newest first."""


class PlatformTwist(Protocol):
    """Components of the platform's twist (omega ; v_O) as functions of time.

    `components` are among wx, wy, wz, vx, vy, vz; `rate` and `acceleration` take times (...) and return
    the components (..., len(components)) and their time derivatives.
    """

    @property
    def components(self) -> Sequence[str]:
        """Which components are prescribed, as many as the mechanism has freedoms."""

    def rate(self, t: Array) -> Array:
        """The components [rad/s or m/s]."""

    def acceleration(self, t: Array) -> Array:
        """Their time derivatives."""


@dataclass(frozen=True)
class Motion:
    """States of the tree over time: t (n,), q (n, nq), v and a (n, nv); platform's twist at O (n, 6).

    `opening` is the largest closure residual of all states [m or rad] after the projection, `drift` the
    largest change of a coordinate that the projection made: the error of the integration.
    """

    t: Array
    q: Array
    v: Array
    a: Array
    twist: Array
    opening: float
    drift: float

    def __repr__(self) -> str:
        return f"Motion({len(self.t)} states to {self.t[-1]:g} s, loops open by {self.opening:.1e})"


def integrate(
    model: Model,
    functions: CompiledModel,
    wanted: PlatformTwist,
    time: Array,
    *,
    steps: Callable[[Sequence[int]], Iterable[int]] = iter,
) -> Motion:
    """The motion from the reference configuration, with the (equal) steps of `time`.

    Adams-Bashforth of order 4, started by Runge-Kutta of order 4: one evaluation a step.
    Afterwards all states are projected on the closure by `assemble` at their independent coordinates, and
    rates and accelerations are those of the projected states. `steps` may wrap the loop, for progress.

    Raises:
        ValueError: not as many components as the mechanism has freedoms.
        EvaluationError: a configuration is singular or cannot be assembled.
    """
    rows = [TWIST_LABELS.index(c) for c in wanted.components]
    columns = model.programs["null_space"].outputs[0].shape[1]
    if len(rows) != columns:
        raise ValueError(
            f"expected as many twist components as freedoms ({columns}), got {', '.join(wanted.components)}"
        )
    q = np.empty((len(time), len(model.system.reference)))
    q[0] = model.system.reference

    def q_dot(t: float, state: Array) -> Array:
        state = _normalised(model, state.copy())  # within a step quaternions leave their length: no rotation
        return coordinate_rates(model, state, _rates(functions, rows, wanted.rate(np.asarray(t)), state)[0])

    slopes: list[Array] = []
    for k in steps(range(len(time) - 1)):
        h = time[k + 1] - time[k]
        slopes = [q_dot(time[k], q[k]), *slopes[: len(ADAMS) - 1]]
        if len(slopes) < len(ADAMS):
            change = _runge_kutta(q_dot, time[k], q[k], h=h, first=slopes[0])
        else:
            change = h * sum((c * s for c, s in zip(ADAMS, slopes, strict=True)), np.zeros_like(q[0]))
        q[k + 1] = _normalised(model, q[k] + change)
    projected = _assembled(model, functions, q)
    v, select = _rates(functions, rows, wanted.rate(time), projected)
    a = _accelerations(model, functions, projected, v, wanted=wanted.acceleration(time), rows=rows, select=select)
    opening = np.abs(np.asarray(functions.closure(projected))).max() if "closure" in functions.functions else 0.0
    jacobian = np.asarray(functions.platform_jacobian(projected))
    twist = np.einsum("nij,nj->ni", jacobian, v)
    return Motion(time, projected, v, a, twist, float(opening), float(np.abs(projected - q).max()))


def _runge_kutta(slope: Callable[[float, Array], Array], t: float, q: Array, *, h: float, first: Array) -> Array:
    """Change of q over a step, order 4; `first` is the slope at its start."""
    second = slope(t + h / 2, q + h / 2 * first)
    third = slope(t + h / 2, q + h / 2 * second)
    fourth = slope(t + h, q + h * third)
    change: Array = h / 6 * (first + 2 * second + 2 * third + fourth)
    return change


def _rates(functions: CompiledModel, rows: Sequence[int], wanted: Array, q: Array) -> tuple[Array, Array]:
    """v of the tree at which the twist has the components `wanted`, and the matrix that takes y_dot to them."""
    basis = np.asarray(functions.null_space(q))
    select = np.asarray(functions.platform_jacobian(q))[..., rows, :] @ basis
    y_dot = np.linalg.solve(select, wanted[..., None])
    v: Array = (basis @ y_dot)[..., 0]
    return v, select


def _accelerations(
    model: Model,
    functions: CompiledModel,
    q: Array,
    v: Array,
    *,
    wanted: Array,
    rows: Sequence[int],
    select: Array,
) -> Array:
    """Accelerations with which the prescribed components have the derivative `wanted`.

    The twist rate is affine in y_ddot with the same matrix as the twist in y_dot.
    """
    zero = np.zeros((len(q), select.shape[-1]))
    drift = functions.body_twist_rates(q, v, functions.acceleration(q, v, zero))
    missing = wanted - np.asarray(drift)[:, rows, platform_index(model)]
    y_ddot = np.linalg.solve(select, missing[..., None])[..., 0]
    return np.asarray(functions.acceleration(q, v, y_ddot))


def _assembled(model: Model, functions: CompiledModel, q: Array) -> Array:
    if "assemble" not in functions.functions:
        return q
    labels = list(model.programs["null_space"].inputs[0].labels)
    independent = [labels.index(label) for label in model.programs["assemble"].inputs[0].labels]
    return np.asarray(functions.assemble(q[:, independent], q))


def coordinate_rates(model: Model, q: Array, v: Array) -> Array:
    """dq/dt (..., nq) from v (..., nv): v itself, and half quaternion times angular velocity (child axes)."""
    rates = np.empty_like(q)
    for link in model.system.tree.links[1:]:
        if link.q.stop - link.q.start == 4:
            w, x, y, z = np.moveaxis(q[..., link.q], -1, 0)
            a, b, c = np.moveaxis(v[..., link.v], -1, 0)
            product = (-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a)
            rates[..., link.q] = 0.5 * np.stack(product, axis=-1)
        else:
            rates[..., link.q] = v[..., link.v]
    return rates


def _normalised(model: Model, q: Array) -> Array:
    for link in model.system.tree.links[1:]:
        if link.q.stop - link.q.start == 4:
            q[link.q] /= np.linalg.norm(q[link.q])
    return q


def moving_bodies(model: Model) -> list[str]:
    """All bodies but the ground, in the order of the columns of `body_twists`."""
    return [name for name in model.mechanism.bodies if name != model.mechanism.ground]


def platform_index(model: Model) -> int:
    """Which of the moving bodies the platform is (the last one if the description names none)."""
    bodies = moving_bodies(model)
    return bodies.index(model.mechanism.platform) if model.mechanism.platform else len(bodies) - 1


def body_states(model: Model, functions: CompiledModel, motion: Motion) -> dict[str, BodyState]:
    """States of all moving bodies, as method B (`symscrew.reference.newton_euler_method`) takes them."""
    poses = np.asarray(functions.body_poses(motion.q))
    twists = np.asarray(functions.body_twists(motion.q, motion.v))
    rates = np.asarray(functions.body_twist_rates(motion.q, motion.v, motion.a))
    return {
        name: BodyState(
            poses[:, :9, k].reshape(-1, 3, 3).transpose(0, 2, 1), poses[:, 9:, k], twists[:, :, k], rates[:, :, k]
        )
        for k, name in enumerate(moving_bodies(model))
    }
