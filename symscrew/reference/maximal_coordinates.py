"""A mechanism's numbers and the state of each of its bodies, in maximal coordinates, with NumPy.

    Mechanism --numeric--> arrays;   arrays, states of bodies --joint_screws--> present screws of all joints

Method B (`newton_euler_method`) and the numeric check of kinematics (`joint_motion`) stand on this module. It uses
the description (`Mechanism`) and the table of joint types, nothing that is derived symbolically, so what it says
about a state is independent of the generated code.

All vectors are in absolute axes. A twist is (omega ; v_O), a wrench (f ; m_O). Every array of a state may
have leading axes, for many states at once: `rotation` of shape (..., 3, 3) and so on.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy

from symscrew.description import Joint, Mechanism, characteristic_length

Array = np.ndarray[Any, Any]

PARALLEL = 1e-12
"""Sine of the angle below which two axes of the reference configuration count as parallel."""


@dataclass(frozen=True)
class BodyState:
    """Where a body is, how it moves, and how its motion changes.

    `rotation` (..., 3, 3) and `translation` (..., 3) [m] map the body's points from their place in the
    reference configuration to their present place, x = rotation x_ref + translation (absolute axes).
    `twist` (..., 6) is (omega ; v_O) [rad/s ; m/s]; `twist_rate` (..., 6) its derivative by components,
    (alpha ; d v_O/dt) [rad/s^2 ; m/s^2].

    Warning: v_O is the velocity of the body's point that is at the origin just now, not of a fixed point of
    the body, and d v_O/dt is not the acceleration of any point of the body.
    """

    rotation: Array
    translation: Array
    twist: Array
    twist_rate: Array

    def __repr__(self) -> str:
        return f"<BodyState: {int(np.prod(self.translation.shape[:-1], dtype=int))} states>"

    def velocity_at(self, point: Array) -> Array:
        """Velocity v_O + omega x r [m/s] of the body's point that is at r (..., 3) [m]."""
        velocity: Array = self.twist[..., 3:] + cross(self.twist[..., :3], point)
        return velocity

    def acceleration_at(self, point: Array) -> Array:
        """Acceleration d v_O/dt + alpha x r + omega x v_r [m/s^2] of the body's point at r (..., 3)."""
        spin = cross(self.twist[..., :3], self.velocity_at(point))
        acceleration: Array = self.twist_rate[..., 3:] + cross(self.twist_rate[..., :3], point) + spin
        return acceleration


REST = BodyState(np.eye(3), np.zeros(3), np.zeros(6), np.zeros(6))
"""A body at rest in its reference configuration, as the ground is unless its state is handed over."""


@dataclass(frozen=True)
class NumericMechanism:
    """The numbers of a mechanism as arrays; make it once with `numeric` and use it for many states.

    Bodies are in the order of the description with the ground first. Freedoms are all elementary motions of
    all joints in order, a spherical motion as three of them, about the parent's axes (those that are absolute
    axes in the reference configuration). `freedoms` are their indices for each joint, `driven` those of the
    drives, `drive_joints` the names of their joints. `axes` (freedoms, 3) are unit vectors in the reference
    configuration, `carriers` the index of the body that carries each axis, `turns` is 1 for rotation,
    spherical and helical freedoms and 0 for translations, `slides` is 1 for translations, the pitch [m/rad]
    for helical freedoms, else 0.
    `length` [m] is the characteristic length, by which moments are divided where they meet forces.
    """

    mechanism: Mechanism
    bodies: tuple[str, ...]
    mass: Array
    com: Array
    inertia: Array
    joints: tuple[str, ...]
    parents: Array
    children: Array
    points: Array
    freedoms: tuple[Array, ...]
    axes: Array
    carriers: Array
    turns: Array
    slides: Array
    driven: tuple[int, ...]
    drive_joints: tuple[str, ...]
    references: tuple[Array, ...]
    length: float

    def __repr__(self) -> str:
        count = f"{len(self.bodies)} bodies, {len(self.joints)} joints, {len(self.axes)} freedoms"
        return f"<NumericMechanism {self.mechanism.name}: {count}>"


def numeric(mechanism: Mechanism | NumericMechanism) -> NumericMechanism:
    """The numbers of `mechanism`, with every parameter replaced by its value."""
    if isinstance(mechanism, NumericMechanism):
        return mechanism
    bodies = (mechanism.ground, *(name for name in mechanism.bodies if name != mechanism.ground))
    index = {name: i for i, name in enumerate(bodies)}
    joints = tuple(mechanism.joints.values())
    rows = [_elementary(mechanism, joint) for joint in joints]
    starts = np.cumsum([0, *(len(own) for own in rows)])
    mass, com, inertia = _inertias(mechanism, bodies)
    points = np.array([_vector(mechanism, joint.point) for joint in joints]).reshape(-1, 3)
    return NumericMechanism(
        mechanism=mechanism,
        bodies=bodies,
        mass=mass,
        com=com,
        inertia=inertia,
        joints=tuple(mechanism.joints),
        parents=np.array([index[joint.parent] for joint in joints], dtype=int),
        children=np.array([index[joint.child] for joint in joints], dtype=int),
        points=points,
        freedoms=tuple(np.arange(a, b) for a, b in itertools.pairwise(starts)),
        axes=np.array([row.axis for own in rows for row in own]).reshape(-1, 3),
        carriers=np.array(
            [
                index[joint.child if row.by_child else joint.parent]
                for joint, own in zip(joints, rows, strict=True)
                for row in own
            ],
            dtype=int,
        ),
        turns=np.array([row.turn for own in rows for row in own]),
        slides=np.array([row.slide for own in rows for row in own]),
        driven=tuple(int(a) + k for a, joint in zip(starts, joints, strict=False) for k in joint.driven),
        drive_joints=tuple(joint.name for joint in joints for _ in joint.driven),
        references=tuple(_vector(mechanism, joint.reference) for joint in joints),
        length=characteristic_length(mechanism),
    )


def stack_states(numbers: NumericMechanism, states: Mapping[str, BodyState]) -> BodyState:
    """The states of all bodies in one `BodyState`, bodies on the axis before the last ones of each array.

    A missing ground is at rest in its reference configuration. Raises ValueError naming bodies that are
    missing or unknown, and arrays of a wrong shape or with entries that are not finite.
    """
    missing = [name for name in numbers.bodies[1:] if name not in states]
    unknown = [name for name in states if name not in numbers.bodies]
    if missing or unknown:
        raise ValueError(
            f"expected the state of each moving body of '{numbers.mechanism.name}'; "
            f"missing: {missing or 'none'}, not in the mechanism: {unknown or 'none'}"
        )
    listed = [states.get(name, REST) for name in numbers.bodies]
    arrays = {}
    for part, last in (("rotation", 2), ("translation", 1), ("twist", 1), ("twist_rate", 1)):
        shape = np.shape(getattr(REST, part))
        arrays[part] = [np.asarray(getattr(state, part), dtype=float) for state in listed]
        for name, array in zip(numbers.bodies, arrays[part], strict=True):
            if array.shape[array.ndim - last :] != shape:
                raise ValueError(f"expected {part} of body '{name}' with last axes {shape}, got shape {array.shape}")
            if not np.isfinite(array).all():
                raise ValueError(f"expected finite numbers in {part} of body '{name}', got NaN or infinity")
    leads = {array.shape[:-1] for part in arrays if part != "rotation" for array in arrays[part]}
    lead = np.broadcast_shapes(*leads, *{array.shape[:-2] for array in arrays["rotation"]})
    stacked = {}
    for part, parts in arrays.items():
        shape = lead + np.shape(getattr(REST, part))
        whole = [array if array.shape == shape else np.broadcast_to(array, shape) for array in parts]
        stacked[part] = np.stack(whole, axis=len(lead))
    return BodyState(**stacked)


@dataclass(frozen=True)
class JointScrews:
    """The joints of one state (or many): everything at each joint's present point, in absolute axes.

    `point` (..., joints, 3) [m] is carried by the child. `axis` (..., freedoms, 3) are the present unit axes,
    `axis_dot` their rates. `relative` (..., joints, 6) is the child's twist less the parent's, reduced to the
    joint's point, `relative_rate` likewise (the componentwise rate of the twist at O, reduced to that point).
    """

    point: Array
    point_velocity: Array
    axis: Array
    axis_dot: Array
    relative: Array
    relative_rate: Array


def joint_screws(numbers: NumericMechanism, whole: BodyState) -> JointScrews:
    """Present points and axes of all joints from the stacked states of all bodies (`stack_states`)."""
    rotation = whole.rotation[..., numbers.children, :, :]
    point = np.einsum("...ij,...j->...i", rotation, numbers.points)
    point = point + whole.translation[..., numbers.children, :]
    axis = np.einsum("...ij,...j->...i", whole.rotation[..., numbers.carriers, :, :], numbers.axes)
    child_twist = whole.twist[..., numbers.children, :]
    difference = child_twist - whole.twist[..., numbers.parents, :]
    rate = whole.twist_rate[..., numbers.children, :] - whole.twist_rate[..., numbers.parents, :]
    return JointScrews(
        point=point,
        point_velocity=child_twist[..., 3:] + cross(child_twist[..., :3], point),
        axis=axis,
        axis_dot=cross(whole.twist[..., numbers.carriers, :3], axis),
        relative=reduced(difference, point),
        relative_rate=reduced(rate, point),
    )


def freedom_screws(numbers: NumericMechanism, screws: JointScrews, joint: int) -> Array:
    """Unit screws (..., 6, freedom) of a joint, (e ; h e) or (0 ; e), at the joint's point."""
    own = numbers.freedoms[joint]
    axis = screws.axis[..., own, :]
    columns = np.concatenate([axis * numbers.turns[own, None], axis * numbers.slides[own, None]], axis=-1)
    return np.swapaxes(columns, -1, -2)


@dataclass(frozen=True)
class _Freedom:
    """One elementary motion of a joint: unit axis, 1 if it turns, metres per unit, who carries the axis."""

    axis: Array
    turn: float
    slide: float
    by_child: bool


def _elementary(mechanism: Mechanism, joint: Joint) -> list[_Freedom]:
    """The freedoms of a joint in order from parent to child."""
    given = [_vector(mechanism, axis) for axis in joint.axes]
    kind = joint.kind
    axes = kind.motion_axes(given, list(np.eye(3)), plane_axes)
    pitch = 0.0 if joint.pitch is None else _number(mechanism, joint.pitch)
    rows: list[_Freedom] = []
    for place, motion in enumerate(kind.motions):
        if motion.axis is None:
            rows += [_Freedom(axis, 1.0, 0.0, by_child=False) for axis in np.eye(3)]
            continue
        axis = axes[motion.axis]
        turns_it = [
            other.axis is None or float(np.linalg.norm(cross(axes[other.axis], axis))) > PARALLEL
            for other in kind.motions
            if other.turns
        ]
        before = sum(other.turns for other in kind.motions[:place])
        by_child = any(turns_it[:before])
        if by_child and any(turns_it[before:]):
            raise ValueError(
                f"joint '{joint.name}' of type {joint.type}: expected each axis to be carried by the parent "
                f"or the child, but axis {motion.axis} moves relative to both; describe it as several joints"
            )
        slide = pitch if motion.helical else float(motion.slides)
        rows.append(_Freedom(axis, float(motion.turns), slide, by_child))
    return rows


def _inertias(mechanism: Mechanism, bodies: tuple[str, ...]) -> tuple[Array, Array, Array]:
    """Masses (bodies,), centres of mass (bodies, 3) and inertias (bodies, 3, 3); zero where not given."""
    count = len(bodies)
    mass, com, inertia = np.zeros(count), np.zeros((count, 3)), np.zeros((count, 3, 3))
    for i, name in enumerate(bodies):
        body = mechanism.bodies.get(name)
        if body is not None and body.mass is not None:
            mass[i] = _number(mechanism, body.mass)
        if body is not None and body.com is not None:
            com[i] = _vector(mechanism, body.com)
        if body is not None and body.inertia is not None:
            inertia[i] = [_vector(mechanism, row) for row in body.inertia]
    return mass, com, inertia


def plane_axes(normal: Array) -> tuple[Array, Array]:
    """Two unit vectors that complete a unit normal to a right-handed triad (first, second, normal).

    The first is the absolute axis that is least along the normal, projected onto the plane.
    """
    nearest = np.eye(3)[int(np.argmin(np.abs(normal)))]
    first = nearest - (nearest @ normal) * normal
    first = first / np.linalg.norm(first)
    return first, cross(normal, first)


def cross(a: Array, b: Array) -> Array:
    """a x b along the last axis; NumPy's own costs ten times as much for one pair of vectors."""
    product: Array = a[..., [1, 2, 0]] * b[..., [2, 0, 1]] - a[..., [2, 0, 1]] * b[..., [1, 2, 0]]
    return product


def reduced(screw: Array, point: Array) -> Array:
    """Twists or their rates (..., 6) at O, reduced to points (..., 3): (omega ; v_O + omega x r)."""
    linear = screw[..., 3:] + cross(screw[..., :3], point)
    return np.concatenate([screw[..., :3], linear], axis=-1)


def _number(mechanism: Mechanism, expression: sympy.Expr) -> float:
    return float(mechanism.number(expression))


def _vector(mechanism: Mechanism, expressions: tuple[sympy.Expr, ...]) -> Array:
    return np.array([_number(mechanism, expression) for expression in expressions])
