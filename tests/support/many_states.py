"""Scenes under gravity with a fixed step, and many states on their loops to start from."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from symscrew.scene import Initial, Scene, parse_scene
from symscrew.simulation import Plant
from symscrew.simulation.initial import initial_states_together

SCENE = """
[scene]
name = "turned"
mechanism = "{}"
duration = 0.1
rate = 10
{}
[[effects]]
type = "gravity"
[integrator]
method = "{}"
step = 1e-3
"""


def scene_of(mechanism: str, drives: str, method: str) -> Scene:
    return parse_scene(SCENE.format(mechanism, drives, method))


def starts(scene: Scene, made: Plant, rates: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """q and v (size, states), with these rates of the first coordinate that has one of its own."""
    tree = made.system.tree
    label = next(c.label for c in tree.v if c.label in {x.label for x in tree.q})
    begins = [replace(scene, initial=Initial(rates={label: float(rate)})) for rate in rates]
    found = initial_states_together(made.model, [(begin, made.parameters) for begin in begins])
    q, v = (np.ascontiguousarray(np.array([state[k] for state in found]).T) for k in (0, 1))
    return q, v
