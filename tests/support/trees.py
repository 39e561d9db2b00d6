"""A branching tree with every kind of motion."""

from __future__ import annotations

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism


def spatial_tree() -> Mechanism:
    """A branching tree with every kind of motion."""
    builder = MechanismBuilder("spatial_tree")
    places = {"hub": (0, 0, 0), "wrist": (1, 0, 1), "nut": (2, 1, 1), "ball": (1, 2, 0), "cross": (0, 1, 2)}
    for k, (name, at) in enumerate(places.items()):
        com = [x + 0.1 * (k + 1) for x in at]
        builder.body(name, mass=1 + k, com=com, inertia=[0.3, 0.4, 0.5])
    z, tilted, x = ["0", "0", "1"], ["3/5", "0", "4/5"], [1, 0, 0]
    builder.joint("space", "free", parent="base", child="hub", point=[0, 0, 0], driven=[0, 1, 2, 3, 4, 5])
    builder.joint("slide", "P", parent="hub", child="wrist", point=[1, 0, 1], axes=[tilted], driven=True)
    builder.joint("screw", "H", parent="wrist", child="nut", point=[2, 1, 1], axes=[tilted], pitch=0.05, driven=True)
    builder.joint("socket", "S", parent="hub", child="ball", point=[1, 2, 0], driven=[0, 1, 2])
    builder.joint("cardan", "U", parent="ball", child="cross", point=[0, 1, 2], axes=[x, z], driven=[0, 1])
    return builder.build()
