"""Other configurations: parameters and joint coordinates set, loops assembled from the reference configuration.

    reference --24 steps, Newton in double precision--> coordinates --refined to 60 digits--> screws there

The path to the given coordinates is walked in small steps, each closed by Newton's method in double precision; the
end is refined to 60 digits. The mechanism then has the screws of the displaced joints.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.description import Mechanism, exact, numeric, validate
from symscrew.errors import DescriptionError
from symscrew.mobility.finite import CLOSED, DIGITS_60, Array, ClosureVariety, moved
from symscrew.mobility.joint_network import Network
from symscrew.mobility.pose_targets import Target, target_of

STEPS = 24
"""Steps from the reference to the given coordinates: a turn by pi in steps of 7.5 degrees, from which Newton's method
stays on the assembly branch. Where a step does not close, the error says so: nothing else is tried."""
NEWTON = 30
"""Steps of Newton's method: regular poses take five; a singular one gains a bit a step and may end at `NEARLY`."""
CLOSED_IN_DOUBLE = 1e-13
"""Closure residual, in units of the mechanism's size, that is rounding of double precision."""
NEARLY = 1e-9
"""What a step of the walk may leave open (at a singular pose); the end is refined to `CLOSED` or refused."""
SNAPPED = 1e-12
"""Joints that the walk leaves this close to their reference stay exactly there, if the loops close with them: a
singular pose of round numbers is then met exactly. Else all are refined as the walk has left them."""
CUT_OFF = 1e-9
"""Relative singular values below this are left out of the inverse: redundant closure equations have 1e-16."""
REFINEMENTS = 8
"""Steps to 60 digits, of about 14 digits each at a regular pose."""
REFINED = 1e-52
"""Closure residual that is rounding of 60 digits."""


def with_parameters(mechanism: Mechanism, at: Mapping[str, Any]) -> tuple[Mechanism, dict[str, Any]]:
    """(the mechanism with the parameters among `at` changed, the other entries of `at`)."""
    changed, others = dict(mechanism.parameters), {}
    for name, value in at.items():
        if name in changed:
            number = exact(value, where=name)
            numeric(number, where=name)
            changed[name] = replace(changed[name], value=number)
        else:
            others[name] = value
    if len(others) == len(at):
        return mechanism, others
    result = replace(mechanism, parameters=changed)
    validate(result)
    return result, others


def displaced(mechanism: Mechanism, network: Network, at: Mapping[str, Any]) -> tuple[Network, float]:
    """(the network where the named joint coordinates have the given values, closure residual).

    Names are those of `symscrew.mobility.pose_targets`: `joint`, `joint.i`, `joint.qx`, `body.x` and so on; values are
    angles [rad] and lengths [m] as the description counts them, of a body its displacement from the reference.

    Raises:
        DescriptionError: unknown coordinate, or the loops cannot be assembled there.
    """
    if not at:
        return network, 0.0
    targets = [target_of(mechanism, network, name, value) for name, value in at.items()]
    coarse, fine = ClosureVariety(network), ClosureVariety(network, DIGITS_60)
    q = np.zeros(coarse.columns)
    goal = np.array([float(target.goal) for target in targets])
    for k in range(1, STEPS + 1):
        q = _closed(coarse, q, targets, goal=goal * k / STEPS, names=", ".join(at))
    given = {target.column for target in targets}
    still = [c for c in range(len(q)) if c not in given and abs(q[c]) < SNAPPED]
    snapped = [*(Target(CONTEXT.zero, _coordinate(c), c) for c in still), *targets]
    point, left = _refined(coarse, fine, q, snapped)
    if left > CLOSED:
        point, left = _refined(coarse, fine, q, targets)
    if left > CLOSED:
        raise DescriptionError(f"at {', '.join(at)}: the loops close only to {left:.1e}; a singular configuration?")
    return moved(network, fine, point), left


def _coordinate(column: int) -> Callable[[ClosureVariety, Array], Array]:
    return lambda _, q: q[:, column]


def _refined(coarse: ClosureVariety, fine: ClosureVariety, q: Array, targets: Sequence[Target]) -> tuple[Array, float]:
    """(q with the targets met and the loops closed in 60 digits, closure residual)."""
    point = np.array([CONTEXT.mpf(float(c)) for c in q], dtype=object)
    goal = np.array([float(target.goal) for target in targets])
    inverse = np.linalg.pinv(_stacked(coarse, q, targets, goal)[1], rcond=CUT_OFF)
    for _ in range(REFINEMENTS):
        residual = _missing(fine, point, targets)
        if np.linalg.norm(residual) < REFINED:
            break
        point = point - np.array([CONTEXT.mpf(float(c)) for c in inverse @ residual], dtype=object)
    return point, float(np.linalg.norm(_missing(fine, point, targets)))


def _missing(fine: ClosureVariety, point: Array, targets: Sequence[Target]) -> Array:
    missing = np.array([target.of(fine, point) - target.goal for target in targets], dtype=object)
    return np.concatenate([fine.residual(point), missing]).astype(float)


def _stacked(variety: ClosureVariety, q: Array, targets: Sequence[Target], goal: Array) -> tuple[Array, Array]:
    residuals, jacobians = variety.evaluate(q[None])
    picked = np.array([target.gradient(variety, q) for target in targets]).reshape(len(targets), len(q))
    now = np.array([float(target.of(variety, q)) for target in targets])
    return np.concatenate([residuals[0], now - goal]), np.concatenate([jacobians[0], picked])


def _closed(variety: ClosureVariety, q: Array, targets: Sequence[Target], *, goal: Array, names: str) -> Array:
    """q with the loops closed and the targets at `goal`, in double precision."""
    for _ in range(NEWTON):
        residual, jacobian = _stacked(variety, q, targets, goal)
        if np.linalg.norm(residual) < CLOSED_IN_DOUBLE:
            return q
        q = q - np.linalg.pinv(jacobian, rcond=CUT_OFF) @ residual
    if np.linalg.norm(residual) < NEARLY:
        return q
    raise DescriptionError(f"at {names}: the loops cannot be assembled there from the reference configuration")
