"""Chains of joints that close on the ground, from letters; every configuration of a closure from many starts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from symscrew import Mechanism, MechanismBuilder
from symscrew.mobility import ClosureVariety, network_of

Array = np.ndarray[Any, Any]


COMPLETE = ("proved", "bounded")
"""What `AssemblyModes.complete` says where the modes are all, by exact numbers or by a bound."""


def single_loop(types: str, points: Sequence[Any], axes: Sequence[Any], platform: str | None = None) -> Mechanism:
    """Bodies b0, b1 ... between joints j0 (driven), j1 ... of these types, the last one on the ground."""
    named = {} if platform is None else {"platform": platform}
    builder = MechanismBuilder("loop", ground="ground", **named)
    bodies = ["ground", *(f"b{k}" for k in range(len(types) - 1))]
    for body in bodies[1:]:
        builder.body(body)
    for k, (kind, point, axis) in enumerate(zip(types, points, axes, strict=True)):
        child = bodies[k + 1] if k + 1 < len(bodies) else "ground"
        parent = bodies[k]
        if child == "ground":
            parent, child = child, parent
        more = {} if axis is None else {"axes": axis}
        builder.joint(f"j{k}", kind, parent=parent, child=child, point=point, driven=k == 0, **more)
    return builder.build()


def joined(edges: Sequence[tuple[str, str, str, Any, Any]]) -> Mechanism:
    """A planar linkage of (type, parent, child, point [x, y], axis of a slide or None), the first driven."""
    builder = MechanismBuilder("linkage", ground="ground")
    for body in dict.fromkeys(end for edge in edges for end in edge[1:3] if end != "ground"):
        builder.body(body)
    for k, (kind, parent, child, point, axis) in enumerate(edges):
        axes = [axis or [0, 0, 1]]
        builder.joint(f"j{k}", kind, parent=parent, child=child, point=[*point, 0], axes=axes, driven=k == 0)
    return builder.build()


def spherical_wrist(limbs: Sequence[Sequence[Any]]) -> Mechanism:
    """Limbs of three hinges each through the origin, the first driven."""
    builder = MechanismBuilder("wrist", ground="base", platform="tool")
    builder.body("tool")
    for k, axes in enumerate(limbs):
        bodies = ["base", f"inner{k}", f"outer{k}", "tool"]
        for body in bodies[1:-1]:
            builder.body(body)
        for j, axis in enumerate(axes):
            builder.joint(f"j{k}{j}", "R", parent=bodies[j], child=bodies[j + 1], point=[0, 0, 0], axes=[axis],
                          driven=j == 0)  # fmt: skip
    return builder.build()


def by_many_starts(mechanism: Mechanism, held: Mapping[int, float], starts: int, seed: int = 0) -> list[Array]:
    """Displacements of all joints, one of each configuration, by Newton's method on exponentials of the screws."""
    variety = ClosureVariety(network_of(mechanism))
    q = np.random.default_rng(seed).uniform(-np.pi, np.pi, (starts, variety.columns))
    free = [c for c in range(variety.columns) if c not in held]
    for column, value in held.items():
        q[:, column] = value
    for _ in range(60):
        left, slopes = variety.evaluate(q)
        step = (np.linalg.pinv(slopes[:, :, free], rcond=1e-9) @ left[..., None])[..., 0]
        q[:, free] -= step / np.maximum(1.0, np.linalg.norm(step, axis=1, keepdims=True) / 0.7)
    q = q[np.abs(variety.evaluate(q)[0]).max(axis=1) < 1e-11]
    if not len(q):
        return []
    poses = variety.forward(q)[1]
    places = np.concatenate([np.concatenate([r.reshape(len(q), 9), t], axis=1) for r, t in poses.values()], axis=1)
    found: list[int] = []
    for k, place in enumerate(places):
        if all(np.abs(place - places[other]).max() > 1e-6 for other in found):
            found.append(k)
    return [q[k] for k in found]
