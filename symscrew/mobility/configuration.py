"""Other configurations: parameters and joint coordinates set, loops assembled from the reference configuration.

    reference --24 steps, Newton in double precision--> coordinates --refined to 60 digits--> screws there

The path to the given coordinates is walked in small steps, each closed by Newton's method in double precision; the
end is refined to 60 digits. The mechanism then has the screws of the displaced joints.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT, high_precision
from symscrew.description import Mechanism, exact, numeric, validate
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.mobility.finite import CLOSED, DIGITS_60, Array, ClosureVariety, moved
from symscrew.mobility.joint_network import Network

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

    Names are `joint` or `joint.i`; values are angles [rad] and lengths [m] as the description counts them.

    Raises:
        DescriptionError: unknown coordinate, or the loops cannot be assembled there.
    """
    if not at:
        return network, 0.0
    targets = dict(_target(mechanism, network, name, value) for name, value in at.items())
    coarse, fine = ClosureVariety(network), ClosureVariety(network, DIGITS_60)
    q = np.zeros(coarse.columns)
    columns = list(targets)
    goal = np.array([float(targets[c]) for c in columns])
    for k in range(1, STEPS + 1):
        q = _closed(coarse, q, columns, goal=goal * k / STEPS, names=", ".join(at))
    snapped = {c: CONTEXT.zero for c in range(len(q)) if c not in targets and abs(q[c]) < SNAPPED}
    point, left = _refined(coarse, fine, q, {**snapped, **targets})
    if left > CLOSED:
        point, left = _refined(coarse, fine, q, targets)
    if left > CLOSED:
        raise DescriptionError(f"at {', '.join(at)}: the loops close only to {left:.1e}; a singular configuration?")
    return moved(network, fine, point), left


def _refined(coarse: ClosureVariety, fine: ClosureVariety, q: Array, targets: Mapping[int, Any]) -> tuple[Array, float]:
    """(q with the targets met and the loops closed in 60 digits, closure residual)."""
    columns = list(targets)
    point = np.array([CONTEXT.mpf(float(c)) for c in q], dtype=object)
    goal = np.array([float(targets[c]) for c in columns])
    inverse = np.linalg.pinv(_stacked(coarse, q, columns, goal)[1], rcond=CUT_OFF)
    for _ in range(REFINEMENTS):
        missing = np.array([point[c] - targets[c] for c in columns], dtype=object)
        residual = np.concatenate([fine.residual(point), missing]).astype(float)
        if np.linalg.norm(residual) < REFINED:
            break
        point = point - np.array([CONTEXT.mpf(float(c)) for c in inverse @ residual], dtype=object)
    return point, float(np.linalg.norm(np.concatenate([fine.residual(point), missing]).astype(float)))


def _target(mechanism: Mechanism, network: Network, name: str, value: Any) -> tuple[int, Any]:
    """(column, displacement from the reference in units of the network)."""
    joint, _, index = name.partition(".")
    if joint not in network.edges:
        known = [*mechanism.parameters, *network.edges]
        raise DescriptionError(f"at {name}: no parameter or joint of this name; {did_you_mean(joint, known)}")
    edge = network.edges[joint]
    motions = [motion for motion, _ in edge.motions]
    spherical = any(motion.spherical for motion in motions)
    place = int(index) if index.isdecimal() else 0
    if spherical or place >= len(motions) or (not index and len(motions) > 1) or (index and not index.isdecimal()):
        raise DescriptionError(
            f"at {name}: expected {joint} or {joint}.i for a single coordinate; this joint of type {edge.type} has "
            f"{'rotations that are no coordinates' if spherical else len(motions)}"
        )
    reference = mechanism.joints[joint].reference
    start = high_precision(mechanism.number(reference[place])) if place < len(reference) else CONTEXT.zero
    displacement = high_precision(exact(value, where=name)) - start
    return edge.motions[place][1], displacement / network.length if motions[place].prismatic else displacement


def _stacked(variety: ClosureVariety, q: Array, columns: list[int], goal: Array) -> tuple[Array, Array]:
    residuals, jacobians = variety.evaluate(q[None])
    picked = np.eye(len(q))[columns]
    return np.concatenate([residuals[0], q[columns] - goal]), np.concatenate([jacobians[0], picked])


def _closed(variety: ClosureVariety, q: Array, columns: list[int], *, goal: Array, names: str) -> Array:
    """q with the loops closed and the coordinates of `columns` at `goal`, in double precision."""
    for _ in range(NEWTON):
        residual, jacobian = _stacked(variety, q, columns, goal)
        if np.linalg.norm(residual) < CLOSED_IN_DOUBLE:
            return q
        q = q - np.linalg.pinv(jacobian, rcond=CUT_OFF) @ residual
    if np.linalg.norm(residual) < NEARLY:
        return q
    raise DescriptionError(f"at {names}: the loops cannot be assembled there from the reference configuration")
