"""Real configurations from random starts, by another route than the polynomials: exponentials of the joint screws.

    ClosureVariety --Newton from random displacements--> q --poses of bodies--> values of the closure's variables

Whatever is found must lie on a component that algebra lists, so it can refute a list; it never proves one.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from symscrew.mobility.components.closure_parts import ClosureEquations, Length
from symscrew.mobility.finite import ClosureVariety
from symscrew.mobility.joint_network import Network
from symscrew.mobility.symbols import exact_value

Array = np.ndarray[Any, Any]

STARTS = 64
"""Random starts: one in two to ten ends in a configuration."""
NEWTON = 60
"""Steps from a start; those that have not closed the loops by then rarely do."""
CLOSED = 1e-12
"""Closure residual, in units of the mechanism's size, of a configuration: rounding of a few operations."""
CUT_OFF = 1e-9
"""Relative singular values below this are left out of Newton's steps: redundant equations have 1e-16."""
BLURRED = (1e-12, 1e-7)
"""A relative singular value between these says that loops closed to `CLOSED` do not tell where a configuration is:
where solutions meet three at a time it is 1e-9 and the place is known to 1e-4. Those of redundant equations are
below."""
FAR = 1.5
"""Slides start within this many sizes of the mechanism from the reference."""
SEED = 20231009
"""Of the starts: always the same, so that results repeat."""


def real_configurations(network: Network, starts: int = STARTS) -> Array:
    """Displacements of configurations, one a row, found from random starts."""
    variety = ClosureVariety(network)
    random = np.random.default_rng(SEED)
    slides = {start for e in network.edges.values() for motion, start in e.motions if motion.prismatic}
    reach = np.array([FAR if c in slides else np.pi for c in range(variety.columns)])
    q = random.uniform(-1, 1, size=(starts, variety.columns)) * reach
    for _ in range(NEWTON):
        residuals, jacobians = variety.evaluate(q)
        step = (np.linalg.pinv(jacobians, rcond=CUT_OFF) @ residuals[..., None])[..., 0]
        size = np.linalg.norm(step, axis=1, keepdims=True)
        q = wrapped(network, q - step / np.maximum(1.0, size))
    residuals, _ = variety.evaluate(q)
    return np.asarray(q[(np.abs(residuals).max(axis=1, initial=0.0) < CLOSED) & np.isfinite(q).all(axis=1)])


def told_apart(network: Network, q: Array) -> Array:
    """Which configurations are known to about the error of their closure: they may refute what others cannot."""
    if not len(q):
        return np.ones(0, dtype=bool)
    variety = ClosureVariety(network)
    residuals, jacobians = variety.evaluate(q)
    for _ in range(2):  # to rounding, so that redundant equations are redundant to rounding
        q = q - (np.linalg.pinv(jacobians, rcond=CUT_OFF) @ residuals[..., None])[..., 0]
        residuals, jacobians = variety.evaluate(q)
    values = np.linalg.svd(jacobians, compute_uv=False)
    relative = values / values[:, :1]
    return np.asarray(~((relative > BLURRED[0]) & (relative < BLURRED[1])).any(axis=1))


def wrapped(network: Network, q: Array) -> Array:
    """The same configurations with rotation vectors of ball joints no longer than half a turn.

    At a whole turn they stop being coordinates: all directions are the same rotation.
    """
    q = q.copy()
    for edge in network.edges.values():
        for motion, start in edge.motions:
            if motion.spherical:
                vector = q[:, start : start + 3]
                size = np.linalg.norm(vector, axis=1, keepdims=True)
                turns = np.round(size / (2 * np.pi))
                q[:, start : start + 3] = vector * (1 - 2 * np.pi * turns / np.maximum(size, 1.0))
    return q


def variables_at(closure: ClosureEquations, network: Network, q: Array) -> Array | None:
    """The closure's variables at displacements, one row each; None where a ball joint's angles are among them."""
    if any(network.edges[length.joint].motions[0][0].spherical for length in closure.lengths):
        return None
    variety = ClosureVariety(network)
    poses = variety.forward(q)[1]
    columns: list[Array] = []
    if closure.axis is not None:
        axis = np.array([float(exact_value(c)) for c in closure.axis])
        size = float(np.linalg.norm(axis))
        for body in closure.turning:
            rotation = poses[body][0]
            turn = np.stack([rotation[:, 2, 1] - rotation[:, 1, 2], rotation[:, 0, 2] - rotation[:, 2, 0],
                             rotation[:, 1, 0] - rotation[:, 0, 1]], axis=1) / 2  # fmt: skip
            columns += [(np.trace(rotation, axis1=1, axis2=2) - 1) / 2, turn @ axis / size**2]
    lengths = [_displacement(length, network, q) for length in closure.lengths]
    columns += lengths
    if closure.body:
        columns += list(body_pose(network, variety, q, closure.base, closure.body).T)
    return np.stack(columns, axis=1)


def body_pose(network: Network, variety: ClosureVariety, q: Array, *between: str) -> Array:
    """Study's parameters of the displacement of the second body against the first, lengths in metres, one a row."""
    centre = np.array([float(c) for c in variety.centre])
    poses = variety.forward(q)[1]
    base, body = (_about_origin(poses[name], centre, float(network.length)) for name in between)
    return _study(base, body)


def _displacement(length: Length, network: Network, q: Array) -> Array:
    """tan(angle / 2) / |w|, or half the way / |v|, without the zero; of a planar slide the way / |v|."""
    edge = network.edges[length.joint]
    exact = np.array([float(exact_value(c)) for c in length.screw])
    unit = np.array([float(c) for c in edge.screws[length.freedom]])
    part = slice(0, 3) if exact[:3].any() else slice(3, 6)
    size = float(np.linalg.norm(exact[part])) * np.sign(exact[part] @ unit[part])
    moved = length.sign * q[:, edge.start + length.freedom]
    if length.zero is None:
        return np.asarray(moved * float(network.length) / size)
    if part.start:
        return np.asarray(moved * float(network.length) / (2 * size) - float(length.zero))
    return np.asarray(np.tan(moved / 2 - np.arctan(float(length.zero) * size)) / size)


def turning(length: Length) -> bool:
    """Whether the variable is a tangent of half an angle, which has no value at one angle."""
    return length.zero is not None and any(length.screw[:3])


def resting_angles(closure: ClosureEquations, network: Network) -> tuple[tuple[str, float], ...]:
    """(freedom, its displacement [rad]) at which a variable of the closure has no value, one for each that turns."""
    found = []
    for length in closure.lengths:
        if not turning(length):
            continue
        exact = np.array([float(exact_value(c)) for c in length.screw[:3]])
        edge = network.edges[length.joint]
        unit = np.array([float(c) for c in edge.screws[length.freedom]])[:3]
        size = float(np.linalg.norm(exact)) * np.sign(exact @ unit)
        angle = length.sign * (np.pi + 2 * np.arctan(float(length.zero or 0) * size))
        name = length.joint if len(edge.screws) == 1 else f"{length.joint}.{length.freedom}"
        found.append((name, float((angle + np.pi) % (2 * np.pi) - np.pi)))
    return tuple(found)


def _about_origin(pose: tuple[Array, Array], centre: Array, unit: float) -> tuple[Array, Array]:
    rotation, translation = pose
    return rotation, (centre - rotation @ centre + translation) * unit


def _study(base: tuple[Array, Array], body: tuple[Array, Array]) -> Array:
    """Study's parameters of the displacement of the body against the base, of length one."""
    back = np.swapaxes(base[0], 1, 2)
    rotation = back @ body[0]
    moved = (back @ (body[1] - base[1])[..., None])[..., 0]
    trace = np.trace(rotation, axis1=1, axis2=2)
    r = rotation
    # four times the products of the quaternion with its first, second, third and fourth component
    x, y, z = r[:, 2, 1] - r[:, 1, 2], r[:, 0, 2] - r[:, 2, 0], r[:, 1, 0] - r[:, 0, 1]
    xy, xz, yz = r[:, 0, 1] + r[:, 1, 0], r[:, 0, 2] + r[:, 2, 0], r[:, 1, 2] + r[:, 2, 1]
    squares = [1 + trace, *(1 + 2 * r[:, k, k] - trace for k in range(3))]
    listed = (squares[0], x, y, z, x, squares[1], xy, xz, y, xy, squares[2], yz, z, xz, yz, squares[3])
    rows = np.stack(listed, axis=1).reshape(-1, 4, 4)
    largest = np.einsum("nii->ni", rows).argmax(axis=1)
    turn = rows[np.arange(len(rows)), largest]
    turn = turn / np.linalg.norm(turn, axis=1, keepdims=True)
    first = -(moved * turn[:, 1:]).sum(axis=1, keepdims=True) / 2
    others = (moved * turn[:, :1] + np.cross(moved, turn[:, 1:])) / 2
    return np.concatenate([turn, first, others], axis=1)
