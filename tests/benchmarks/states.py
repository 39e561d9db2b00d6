"""Many consistent states of a model, by its own assembly, velocity and acceleration."""

from __future__ import annotations

import numpy as np

from symscrew.model import Model
from symscrew.runtime.compiled import CompiledModel

Array = np.ndarray


def consistent_states(model: Model, compiled: CompiledModel, count: int) -> tuple[Array, Array, Array]:
    """(q, v, a) of `count` random states near the reference configuration, shapes (count, n)."""
    random = np.random.default_rng(1)
    system = model.system
    inputs = {port.name: port for port in model.programs["velocity"].inputs}
    freedoms = inputs["y_dot"].size
    if not system.cuts:
        q, v, a = (random.uniform(-1, 1, (count, len(system.tree.q))) for _ in range(3))
        return np.pi * q, v, a
    guess = system.reference
    labels = [c.label for c in system.tree.q]
    start = guess[[labels.index(label) for label in inputs_of(model, "assemble", "y")]]
    shift = 0.2 * random.uniform(-1, 1, (3 * count, len(start)))
    q, status = compiled.assemble(start + shift, np.broadcast_to(guess, (3 * count, len(guess))), check=False)
    q = q[status == 0][:count]
    if len(q) < count:
        raise RuntimeError(f"{model.name}: only {len(q)} of {3 * count} random states could be assembled")
    y_dot, y_ddot = random.uniform(-1, 1, (2, count, freedoms))
    v = compiled.velocity(q, y_dot)
    return q, v, compiled.acceleration(q, v, y_ddot)


def inputs_of(model: Model, function: str, port: str) -> tuple[str, ...]:
    """Labels of an input."""
    return next(p.labels for p in model.programs[function].inputs if p.name == port)
