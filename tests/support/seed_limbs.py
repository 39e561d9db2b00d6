"""The paper's limbs in symbols."""

from __future__ import annotations

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism


def inclined(angle: str = "pi/6", fourth: tuple = ("cos(theta)", 0, "-sin(theta)")) -> Mechanism:
    """The paper's limb 1, one UPS limb and the S limb, in R, L and the limb's inclination theta."""
    builder = MechanismBuilder("inclined", platform="platform").body("platform")
    builder.parameter("R", "0.8", "m").parameter("L", "0.6", "m").parameter("theta", angle, "rad")
    tip = ["-R+L*sin(theta)", 0, "L*cos(theta)"]
    axes = [[[1, 0, 0], [0, 1, 0]], [], [list(fourth), [0, 1, 0]]]
    builder.limb("limb1", "UP*U", points=[["-R", 0, 0], tip], axes=axes)
    points = [[0, "-R", 0], [0, "-R+L*sin(theta)", "L*cos(theta)"]]
    builder.limb("limb2", "UP*S", points=points, axes=[[[0, 1, 0], [1, 0, 0]], [], []])
    builder.limb("limb5", "S", points=[[0, 0, 0]])
    return builder.build()
