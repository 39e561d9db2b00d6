"""How long steps of an explicit method can be before they grow errors: the limit that a stiff scene sets.

A mode of the motion that decays with the rate r needs h r below the method's limit on the negative real axis, however
little of it is left. Rates are eigenvalues of the equations of motion, linearised by differences at one state.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from symscrew.program import evaluate
from symscrew.scene import INTEGRATION_METHODS, Scene
from symscrew.simulation.recording import History, State, shown_time
from symscrew.simulation.state_programs import Plant

# Mean steps above this part of the longest stable one count as bound by it, and an event says so: a step that stability
# bounds grows up to the limit and is cut back, so its mean is near the limit. Below, accuracy chose the steps.
CLOSE = 0.5
STEP = 1e-6  # of central differences: about the cube root of rounding, where its error and theirs are least


def with_longest_stable_step(scene: Scene, plant: Plant, history: History, start: State) -> History:
    """The history with `longest_stable_step` [s] among its counters, and an event where it bound the steps."""
    method, end = scene.integrator.method, (history.q[-1], history.v[-1], history.x[-1])
    limit = INTEGRATION_METHODS[method].stable
    if limit is None:
        return history
    found = [rate for t, state in ((0.0, start), (history.t[-1], end)) if (rate := fastest(scene, plant, t, state))]
    if not found:
        return history
    longest = limit / max(found)
    mean = scene.integrator.step or history.t[-1] / max(history.counters.get("steps", 1.0), 1.0)
    events = history.events
    if mean > CLOSE * longest:
        bound, when = "are bound by" if history.ok else "are above or near", shown_time(history.t[-1])
        events += (
            f"t = {when} s: steps of {mean:.3g} s {bound} the longest at which {method} is stable, about "
            f"{longest:.3g} s (a rate of {max(found):.3g} 1/s); an implicit method (cvodes, radau) has none",
        )
    return replace(history, counters={**history.counters, "longest_stable_step": longest}, events=events)


def fastest(scene: Scene, plant: Plant, t: float, state: State) -> float:
    """The largest decay rate [1/s] at a state; 0 where there is none, or where accelerations are not defined."""
    q, v, x = state
    if not all(np.isfinite(part).all() for part in state):
        return 0.0
    nv, count, advance = len(v), 2 * len(v) + len(x), plant.system.advance
    steps = STEP * np.concatenate([np.eye(count), -np.eye(count)])
    table = [float(values(t)) for values in scene.tables.values()]
    given = {
        "t": np.array([t]),
        "q": advance(np.repeat(q[None], 2 * count, 0), steps[:, :nv]),
        "v": v + steps[:, nv : 2 * nv],
        "x": x + steps[:, 2 * nv :],
        "u": np.zeros(plant.sizes["u"]),
        "s": np.concatenate([table, np.zeros(plant.sizes["s"] - len(table))]),
        "p": plant.parameters,
    }
    (a, x_dot), status = evaluate(plant.slopes, [given[port.name] for port in plant.slopes.inputs])
    if status.any() or not count:
        return 0.0
    slopes = np.concatenate([given["v"], a, x_dot], 1)
    matrix = (slopes[:count] - slopes[count:]).T / (2 * STEP)
    return float(max(-np.linalg.eigvals(matrix).real.min(), 0.0))
