"""Scenes of the benchmark problems with their reference histories; runs of them, compiled once."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Scene
from symscrew.scene.scene_file import load_scene
from symscrew.simulation import native
from symscrew.simulation.initial import initial_state, initial_states
from symscrew.simulation.motion import Run, _observed, evaluated, prepare, simulate
from symscrew.simulation.stability import with_longest_stable_step

EXAMPLES = Path(__file__).parents[2] / "examples"
DATA = json.loads((Path(__file__).parents[1] / "data" / "dynamics" / "references.json").read_text())
COORDINATES = {
    "n_four_bar": ["A0"], "andrews": ["O"], "flyball_governor": ["slide", "rod1_R", "shaft_R"],
    "spatial_slider_crank": ["slide", "A"], "light_cart_pole": ["slide", "hinge"],
    "delta": ["arm1_R", "arm2_R", "arm3_R"],
}  # fmt: skip
POINTS = {"bricard": "P3", "heavy_top": "centre", "delta": "E"}
COLUMNS = {
    "n_four_bar": ["theta_from_up"], "andrews": ["beta"], "flyball_governor": ["s", "alpha", "phi"],
    "spatial_slider_crank": ["s", "theta"], "light_cart_pole": ["x", "theta"],
    "delta": ["th1", "th2", "th3", "px", "py", "pz"], "bricard": ["P3x", "P3y", "P3z"], "heavy_top": ["x", "y", "z"],
}  # fmt: skip


def reference(name: str, until: float = np.inf) -> tuple[np.ndarray, np.ndarray]:
    """Times and values (n, columns) of a problem's reference history."""
    entry = DATA[name]
    values = np.array(entry["values"], dtype=float)
    values = values[values[:, 0] <= until * (1 + 1e-12)]
    return values[:, 0], values[:, [entry["columns"].index(c) for c in COLUMNS[name]]]


def scene_of(name: str, until: float | None = None, **integrator: object) -> Scene:
    """A benchmark's scene with the reference's outputs, and with another end or integrator."""
    scene = load_scene(EXAMPLES / "benchmarks" / f"{name}.toml")
    times, _ = reference(name)
    rate = 1.0 / times[1]
    scene = replace(scene, rate=rate, duration=until or float(times[-1]))
    return replace(scene, integrator=replace(scene.integrator, **integrator)) if integrator else scene


@cache
def prepared(name: str):  # type: ignore[no-untyped-def]
    """Model and programs of a benchmark."""
    return prepare(scene_of(name))


@cache
def compiled(name: str):  # type: ignore[no-untyped-def]
    """Model, programs and compiled loop of a benchmark."""
    scene = scene_of(name)
    model, plant = prepared(name)
    library = native.Library(plant, native.table_code(list(scene.tables.values()))) if find_compiler() else None
    return model, plant, library


def run_of(name: str, scene: Scene, other: native.Library | None = None) -> Run:
    """The run of a benchmark's scene by the loop compiled before (or another one), or without a compiler."""
    model, plant, library = compiled(name)
    library = other or library
    if library is None:
        return simulate(scene, prepared=(model, plant))
    q, v = initial_state(scene, model, plant.parameters)
    x = initial_states(scene, model, q, v)
    x = np.concatenate([x, np.zeros(len(plant.x_labels) - len(x))])
    history = with_longest_stable_step(scene, plant, native.run_natively(library, scene, (q, v, x)), (q, v, x))
    return _observed(scene, model, plant, history)


def values_of(name: str, run: Run) -> np.ndarray:
    """The quantities of a problem's reference, (n, columns)."""
    labels = [c.label for c in run.model.system.tree.q]
    columns: list[np.ndarray] = [run.q[:, [labels.index(n) for n in COORDINATES.get(name, [])]]]
    if name in POINTS:
        positions = evaluated(run.model, "forward_kinematics", {"q": run.q})["positions"].reshape(len(run.t), -1, 3)
        columns.append(positions[:, list(run.model.mechanism.points).index(POINTS[name])])
    sign = -1.0 if name == "n_four_bar" else 1.0  # the reference counts clockwise
    return sign * np.concatenate(columns, 1)


def error_of(name: str, run: Run) -> float:
    """Largest difference to the reference over all its times and columns."""
    times, expected = reference(name, run.scene.duration)
    assert np.allclose(run.t, times, rtol=0, atol=1e-12)
    return float(np.abs(values_of(name, run) - expected).max())


def order(steps: Sequence[float], errors: Sequence[float]) -> float:
    """Slope of log(error) over log(step)."""
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
