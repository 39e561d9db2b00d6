"""Other configurations: parameters and joint coordinates set, loops assembled from the reference configuration.

    reference --24 steps, Newton in double precision--> coordinates --refined to 60 digits--> screws there

The path to the given coordinates is walked in small steps, each closed by Newton's method in double precision; the
end is refined to 60 digits. The mechanism then has the screws of the displaced joints.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.description import Mechanism, followed, given_value, numeric, validate
from symscrew.errors import DescriptionError, expect
from symscrew.kinematics import System, given_coordinates, given_parameter, quaternion_entry
from symscrew.mobility.finite import CLOSED, DIGITS_60, Array, ClosureVariety, moved
from symscrew.mobility.joint_network import Network
from symscrew.mobility.pose_targets import VECTOR, Target, read_coordinates, targets_of

STEPS = 24
"""Steps from the reference to the given coordinates: a turn by pi in steps of 7.5 degrees, from which Newton's method
stays on the assembly branch. Where a step does not close, the error says so: nothing else is tried."""
NEWTON = 30
"""Steps of Newton's method: regular poses take five; a singular one gains a bit a step and may end at `NEARLY`."""
JUMPED = np.pi
"""In one of these steps [rad, lengths]: Newton's method has left for another way round, by whole turns of joints. At a
coordinate that nothing moves at first, as a ball joint's own turn, its first step has no bound."""
CLOSED_IN_DOUBLE = 1e-13
"""Closure residual, in units of the mechanism's size, that is rounding of double precision."""
NEARLY = 1e-9
"""What a step of the walk may leave open (at a singular pose); the end is refined to `CLOSED` or refused."""
SNAPPED = 1e-12
"""Joints that the walk leaves this close to their reference stay exactly there, if the loops close with them: a
singular pose of round numbers is then met exactly. Else all are refined as the walk has left them."""
CUT_OFF = 1e-9
"""Relative singular values below this are left out of the inverse: redundant closure equations have 1e-16."""
NEAR, SAMPLES = 0.2, 4
"""How far [rad, lengths of the mechanism] configurations near the reference are sought, and how many: a number that
no motion changes is the same to rounding in all of them, one that some motion changes only by chance."""
DEPENDS = 1e-6
"""A number whose gradient along the motions is, beside those of others, smaller than this follows from these."""
FITS = 1e-11
"""What numbers that follow from others may miss [rad, the mechanism's size]: as typed in 12 digits."""
REFINEMENTS = 8
"""Steps to 60 digits, of about 14 digits each at a regular pose."""
REFINED = 1e-52
"""Closure residual that is rounding of 60 digits."""


class UnreachedError(DescriptionError):
    """No configuration has these coordinates: how many numbers were given, and how many the mechanism leaves free."""

    def __init__(self, names: str, numbers: int, free: int, left: float = 0.0) -> None:
        many = f"; {numbers} numbers are given and {free} are free: leave some out, and they follow"
        text = f"the loops close only to {left:.1e}; a singular configuration?"
        if not left:
            text = "the loops cannot be assembled there from the reference configuration" + many * (numbers > free)
        super().__init__(f"at {names}: {text}")
        self.numbers, self.free = numbers, free


@dataclass(frozen=True, repr=False)
class Reached:
    """A configuration: the network with the screws there, and how far its loops are open, in units of its size.

    `values`: every coordinate of every joint, and of the platform, by its name [rad, m]; of a spherical joint its
    rotation vector.
    """

    network: Network
    closed_to: float
    values: Mapping[str, float]

    def __repr__(self) -> str:
        return f"Reached({len(self.values)} coordinates, loops closed to {self.closed_to:.1e})"

    def tree(self, system: System) -> Array:
        """The coordinates q of the spanning tree."""
        found = np.array(system.reference, dtype=float)
        for link in system.tree.links[1:]:
            if link.motion.spherical:
                vector = np.array([self.values[f"{link.joint}.r{c}"] for c in VECTOR])
                vector = -vector if link.inverted else vector
                angle = float(np.linalg.norm(vector))
                found[link.q] = [np.cos(angle / 2), *(np.sinc(angle / (2 * np.pi)) / 2 * vector)]
            elif link.motion.single:
                found[link.q] = self.values[system.tree.q[link.q.start].label]
        return found


def with_parameters(mechanism: Mechanism, at: Mapping[str, Any]) -> tuple[Mechanism, dict[str, Any]]:
    """(the mechanism with the parameters among `at` changed and all that follow them, the other entries of `at`)."""
    expect(mechanism, Mechanism)
    expect(at, Mapping)
    others = {name: value for name, value in at.items() if name not in mechanism.parameters}
    if len(others) == len(at):
        return mechanism, others
    given = {n: given_parameter(mechanism, n, value) for n, value in at.items() if n not in others}
    for name, number in given.items():
        numeric(number, where=name)
    result = replace(mechanism, parameters=followed(mechanism.parameters, given))
    validate(result)
    return result, others


def displaced(mechanism: Mechanism, network: Network, at: Mapping[str, Any]) -> Reached:
    """The configuration where the named coordinates have the given values, assembled from the reference.

    Names are those of `symscrew.kinematics.coordinate_names`, values texts with units or numbers [rad, m].

    Raises:
        DescriptionError: unknown coordinate, or the loops cannot be assembled there.
    """
    fine = ClosureVariety(network, DIGITS_60)
    if not at:
        return Reached(network, 0.0, read_coordinates(mechanism, fine, np.full(fine.columns, CONTEXT.zero)))
    targets = targets_of(mechanism, network, given_coordinates(mechanism, at))
    names = ", ".join(at)
    try:
        point, left = _assembled(network, targets, names)
    except UnreachedError:  # more numbers than freedoms, as of a whole pose, fit together to their own digits only
        found = _with_some_of(network, targets, names)
        if found is None:
            raise
        point, left = found
    return Reached(moved(network, fine, point), left, read_coordinates(mechanism, fine, point))


def _assembled(network: Network, targets: Sequence[Target], names: str) -> tuple[Array, float]:
    """Displacements in 60 digits where all targets are met, and the closure residual."""
    coarse, fine = ClosureVariety(network), ClosureVariety(network, DIGITS_60)
    q = np.zeros(coarse.columns)
    goal = np.array([float(target.goal) for target in targets])
    for k in range(1, STEPS + 1):
        before, q = q, _closed(coarse, q, targets, goal=goal * k / STEPS, names=names)
        if np.abs(q - before).max(initial=0.0) > JUMPED:
            raise UnreachedError(names, len(targets), _free(coarse))
    given = {target.column for target in targets}
    still = [c for c in range(len(q)) if c not in given and abs(q[c]) < SNAPPED]
    snapped = [*(Target(CONTEXT.zero, _coordinate(c), c) for c in still), *targets]
    point, left = _refined(coarse, fine, q, snapped)
    if left > CLOSED:
        point, left = _refined(coarse, fine, q, targets)
    if left > CLOSED:
        raise UnreachedError(names, len(targets), _free(coarse), left)
    return point, left


def _with_some_of(network: Network, targets: Sequence[Target], names: str) -> tuple[Array, float] | None:
    """The same by targets that are independent in the reference configuration, if the others are met with them."""
    coarse = ClosureVariety(network)
    rest = np.zeros(coarse.columns)
    values, rows = np.linalg.svd(coarse.evaluate(rest[None])[1][0])[1:]
    motions = rows[int((values > CUT_OFF).sum()) :].T
    left_over = [target.gradient(coarse, rest) @ motions for target in targets]
    chosen = list[Target]()
    while left_over:  # what moves most is followed most surely
        k = int(np.argmax([np.linalg.norm(slope) for slope in left_over]))
        size = float(np.linalg.norm(left_over[k]))
        if size < DEPENDS:
            break
        unit = left_over[k] / size
        left_over = [slope - unit * float(unit @ slope) for slope in left_over]
        chosen.append(targets[k])
    if len(chosen) == len(targets):
        return None
    try:
        point, left = _assembled(network, chosen, names)
    except UnreachedError:
        return None
    q = point.astype(float)
    met = all(abs(float(target.of(coarse, q)) - float(target.goal)) < FITS for target in targets)
    return (point, left) if met else None


def in_words(coordinates: Mapping[str, Any], parameters: Mapping[str, Any]) -> str:
    """Which configuration and which parameters were asked for; what an entry of a quaternion is as an angle."""
    given = ", ".join(f"{name} = {value}{_in_degrees(name, value)}" for name, value in coordinates.items())
    where = f"at {given}" if given else "in the reference configuration"
    changed = ", ".join(f"{name} = {value}" for name, value in parameters.items())
    return f"{where} with {changed}" if changed else where


def _in_degrees(name: str, value: Any) -> str:
    said = quaternion_entry(name, float(given_value(value, where=name).value)) if name[-3:-1] == ".q" else ""
    return f" ({said})" if said else ""


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


def motions_near(network: Network, names: str) -> Array:
    """Displacements (n, columns) of configurations near the reference, loops closed; the same ones every time."""
    variety = ClosureVariety(network)
    rest = np.zeros(variety.columns)
    jacobian = variety.evaluate(rest[None])[1][0]
    values, rows = np.linalg.svd(jacobian)[1:]
    free = rows[int((values > CUT_OFF).sum()) :].T
    steps = NEAR * np.random.default_rng(1).uniform(-1, 1, (SAMPLES, free.shape[1]))
    found = []
    for step in steps:
        try:
            found.append(_closed(variety, free @ step, (), goal=np.zeros(0), names=names))
        except UnreachedError:
            continue
    return np.array(found).reshape(-1, variety.columns)


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
    raise UnreachedError(names, len(targets), _free(variety))


def _free(variety: ClosureVariety) -> int:
    """Instantaneous freedoms in the reference configuration."""
    jacobian = variety.evaluate(np.zeros((1, variety.columns)))[1][0]
    return variety.columns - int(np.linalg.matrix_rank(jacobian, tol=CUT_OFF))
