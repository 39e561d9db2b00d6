"""Shapes that follow run-time parameters: one more function of the page, and its sliders.

model --with_outline--> model with `outline(p)`: points and axes of the description [m], absolute, in the reference
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from symscrew.description import Vector
from symscrew.display.shape import FLAT, numbers
from symscrew.functions import columns_port, function
from symscrew.model import Model
from symscrew.program import lower

Array = np.ndarray
REACH = 0.5  # of a parameter's slider, to either side: half of its value; of one that is 0, of its unit


class Outline:
    """Every point, axis and centre of mass of a description, each once, by the formula that gives it."""

    def __init__(self, model: Model) -> None:
        mechanism = model.mechanism
        points = [joint.point for joint in mechanism.joints.values()]
        points += [point.at for point in mechanism.points.values()]
        others = [axis for joint in mechanism.joints.values() for axis in joint.axes]
        others += [body.com for body in mechanism.bodies.values() if body.com is not None]
        self.vectors: list[Vector] = list(dict.fromkeys(tuple(v) for v in (*points, *others)))
        self.places = np.array([numbers(mechanism, v) for v in points]).reshape(-1, 3)
        self._of_place = [self.at(v) for v in points]

    def at(self, vector: Vector) -> int:
        """The number of a vector of the description."""
        return self.vectors.index(tuple(vector))

    def near(self, place: Array) -> int:
        """The number of the point that is at a place [m] with the parameters' own values."""
        gaps = np.linalg.norm(self.places - place, axis=1)
        assert gaps.min() < max(FLAT, FLAT * float(np.abs(self.places).max()))
        return self._of_place[int(gaps.argmin())]


def with_outline(model: Model) -> Model:
    """The model with the function `outline(p)`, where it has run-time parameters; else as it is."""
    system = model.system
    if not system.parameters:
        return model
    vectors = Outline(model).vectors
    values = [c for vector in vectors for c in system.geometry.vector(vector)]
    port = columns_port("points", [f"v{k}" for k in range(len(vectors))], "xyz", ("m",) * 3, description="of the shape")
    made = function(system, "outline", "Points, axes and centres of mass in the reference.", inputs=[],
                    outputs=[(port, values)])  # fmt: skip
    return replace(model, programs={**model.programs, "outline": lower(made)})


def tunable(model: Model) -> list[dict[str, Any]]:
    """The run-time parameters as sliders: name, value, its unit, what it is, and between which values."""
    made = []
    for parameter in model.mechanism.parameters.values():
        if parameter.run_time:
            value = float(parameter.value)
            reach = REACH * abs(value) or REACH
            made.append(
                {"name": parameter.name, "value": value, "unit": parameter.unit, "description": parameter.description,
                 "low": value - reach, "high": value + reach}
            )  # fmt: skip
    return made
