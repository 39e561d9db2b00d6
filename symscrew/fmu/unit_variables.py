"""The variables of a unit, in the order of their value references (see c/instance.c)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.simulation import Plant

DEFAULT_STEP = 1e-3  # [s], where the scene names none: RK4 errs by about (w step)^4, 1e-12 for motion of 1 rad/s
Start = tuple[np.ndarray, np.ndarray, np.ndarray]  # q, v and the effects' states x at the start


@dataclass(frozen=True)
class Variable:
    """One real variable: its index in the list is its value reference; `derivative` is that of its state."""

    name: str
    causality: str
    variability: str
    unit: str
    description: str
    start: float | None = None
    derivative: int | None = None


def variables(
    plant: Plant, start: Start, outside: Sequence[tuple[str, str]], *, step: float = DEFAULT_STEP
) -> list[Variable]:
    """Time, step, inputs u and those of effects, parameters, states q, v, x, and the states' rates.

    `outside`: (name, unit) of every entry of the effects' inputs that are given from outside; `step` [s]: the longest.
    """
    ports = {port.name: port for port in plant.slopes.inputs}
    result = [
        Variable("time", "independent", "continuous", "s", "time"),
        Variable("step", "parameter", "tunable", "s", "largest step of co-simulation", float(step)),
    ]
    for label, unit in zip(ports["u"].labels, ports["u"].units, strict=True):
        result.append(Variable(structured("u", label), "input", "continuous", unit, f"drive of {label}", 0.0))
    result += [
        Variable(structured("", name), "input", "continuous", unit, "input of an effect", 0.0) for name, unit in outside
    ]
    for parameter, value in zip(_run_time(plant), plant.parameters, strict=True):
        name, unit, text = parameter
        result.append(Variable(f"p.{name}", "parameter", "tunable", unit, text, float(value)))
    first = len(result)
    tree = plant.system.tree
    q, v, x = (values.tolist() for values in start)
    for c, value in zip(tree.q, q, strict=True):
        result.append(
            Variable(structured("q", c.label), "output", "continuous", c.unit, f"coordinate {c.label}", value)
        )
    for c, value in zip(tree.v, v, strict=True):
        result.append(Variable(structured("v", c.label), "output", "continuous", c.unit, f"rate {c.label}", value))
    for label, value in zip(plant.x_labels, x, strict=True):
        result.append(Variable(structured("x", label), "output", "continuous", "1", f"state {label}", value))
    for index, state in enumerate(result[first:], first):
        unit = {"1": "1/s", "rad": "rad/s", "m": "m/s", "rad/s": "rad/s^2", "m/s": "m/s^2"}.get(state.unit, "1/s")
        text = f"rate of {state.name}"
        result.append(Variable(f"der({state.name})", "local", "continuous", unit, text, derivative=index))
    return result


def structured(group: str, label: str) -> str:
    """A name by the standards' structured convention: limb1_U.0 is an entry of limb1_U."""
    name = re.sub(r"\.(\d+)(?=\.|$)", r"[\1]", re.sub(r"[^\w.]", "_", label))
    return f"{group}.{name}" if group else name


def _run_time(plant: Plant) -> list[tuple[str, str, str]]:
    chosen = [p for p in plant.system.mechanism.parameters.values() if p.run_time]
    return [(p.name, p.unit, p.description or p.name) for p in chosen]
