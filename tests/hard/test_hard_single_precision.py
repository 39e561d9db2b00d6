"""Generated code of type float along whole motions: within the error stated for it, with the rank decisions of double.

Accelerations, with the scene's controller inside, are from C of type float; states and the closing of the loops are in
double, as on a controller that keeps its state in double.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest
from support.marks import slow
from support.runs import EXAMPLES, prepared

from hard import case
from symscrew.model import Model
from symscrew.program.numpy_evaluation import evaluate
from symscrew.runtime.compiled import CompiledFunction, find_compiler, load
from symscrew.scene.scene_file import load_scene
from symscrew.simulation.initial import initial_state
from symscrew.studies.accuracy.run_history import read_reference
from symscrew.studies.platform_motion import coordinate_rates

pytestmark = [
    pytest.mark.slow,
    pytest.mark.optimised,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: these cases are of compiled code"),
]


def compiled(found: Model, names: Sequence[str], precision: str | None = None) -> list[Callable]:
    """Functions of one state: arrays to the first output and the status, without the checks of shapes."""
    few = replace(found, programs={name: found.programs[name] for name in names})
    loaded = load(few, backend="c", precision=precision, flags=("-O1",))
    return [_of_one_state(loaded[name]) for name in names]


def _of_one_state(function: CompiledFunction) -> Callable:
    def call(*arguments: np.ndarray) -> tuple[np.ndarray, int]:
        results, status = [np.empty((1, port.size)) for port in function.outputs], np.zeros(1, dtype=np.intc)
        function.evaluator([x[None] for x in arguments], results, status)
        return results[0][0], int(status[0])

    return call


def marched(name: str, steps_per_output: int) -> tuple[float, set[int]]:
    """Error of a benchmark's outputs by RK4 with accelerations of type float; the statuses they came with."""
    path = EXAMPLES / "benchmarks" / f"{name}.toml"
    reference = read_reference(path)
    assert reference is not None
    scene = replace(load_scene(path), rate=1 / reference.times[1], duration=reference.times[-1])
    found, plant = prepared(name)
    (forces,) = compiled(found, ("forward_dynamics",), "single")
    close_position, close_velocity = compiled(found, ("close_position", "close_velocity"))
    q, v = initial_state(scene, found, plant.parameters)
    only_angles_and_lengths = len(found.system.tree.q) == len(found.system.tree.v)
    h, statuses, t = float(scene.times[1]) / steps_per_output, set(), 0.0
    ports = [port.name for port in plant.forward.inputs]
    known = {"x": np.zeros(plant.sizes["x"]), "u": np.zeros(0), "s": np.zeros(0), "p": plant.parameters}

    def slope(t: float, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        state = {**known, "t": np.array([t]), "q": q, "v": v}
        if plant.inputs.outputs:
            commands, _ = evaluate(plant.inputs, [state[port.name] for port in plant.inputs.inputs])
            names = [port.name.removesuffix("_command") for port in plant.inputs.outputs]
            state |= dict(zip(names, commands, strict=True))
        a, status = forces(*[state[port] for port in ports])
        statuses.add(status)
        return v if only_angles_and_lengths else coordinate_rates(found, q, v), a

    samples = [q]
    for _ in range(len(scene.times) - 1):
        for _ in range(steps_per_output):
            p1, a1 = slope(t, q, v)
            p2, a2 = slope(t + h / 2, q + h / 2 * p1, v + h / 2 * a1)
            p3, a3 = slope(t + h / 2, q + h / 2 * p2, v + h / 2 * a2)
            p4, a4 = slope(t + h, q + h * p3, v + h * a3)
            q, v, t = q + h / 6 * (p1 + 2 * p2 + 2 * p3 + p4), v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), t + h
            q, _ = close_position(q)
            v, _ = close_velocity(q, v)
        samples.append(q)
    return reference.error_of(found)(np.array(samples)), statuses


@pytest.mark.parametrize(
    "name, steps, bound, scale",
    [
        slow("bricard", 10, 5e-6, 1.0),
        ("spatial_slider_crank", 60, 2e-4, 1.0),
        slow("delta", 10, 2e-6, 1.0),
        pytest.param(
            "andrews", 20, 5e-7, 0.007, marks=pytest.mark.slow
        ),  # the reference has beta: F is 7 mm from the axis
    ],
)
def test_float_code_along_a_motion(name: str, steps: int, bound: float, scale: float) -> None:
    """Every step's status is that of full rank, as in double; steps are so small that rounding is most of the error."""
    assert "A04 <= 5e-6, slidercrank <= 2e-4, delta <= 2e-6, A03 point F <= 5e-7 m" in case(28)["pass_criterion"]
    error, statuses = marched(name, steps)
    assert statuses <= {0, -1}
    assert scale * error < bound
    assert error > 1e-12  # it was float
