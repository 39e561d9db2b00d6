"""Time for accuracy of whole runs: the compiled loop on the benchmark problems, solver call only.

Then the same for N four-bars in a row, through their singular positions, with the exponent of the time over N.

Beside it, in the same process: the same generated functions and DOP853 without anything that keeps the loops closed.
The other engines' times are those recorded in tests/data/dynamics/peers.json, on their own machine.
"""

from __future__ import annotations

import json
import statistics
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from symscrew.effects.gravity import Gravity
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation import native
from symscrew.simulation.initial import initial_state, initial_states
from symscrew.simulation.motion import _observed, prepare
from symscrew.simulation.state_programs import Plant
from tests.hard.mechanisms import four_bars, swung
from tests.support.runs import error_of, scene_of

from .tables import table

GOALS = {
    "andrews": (1e-10, 3.0), "bricard": (1e-10, 5.0), "spatial_slider_crank": (1e-10, 10.0),
    "flyball_governor": (1e-8, 20.0), "n_four_bar": (1e-6, None), "delta": (1e-10, None), "heavy_top": (1e-8, None),
}  # fmt: skip
LOOPS = (1, 2, 5, 10, 20, 40)
TOLERANCES = [10.0**-k for k in range(2, 13)]
PEERS = Path(__file__).parents[1] / "data" / "dynamics" / "peers.json"


def _start(scene, model, plant):  # type: ignore[no-untyped-def]
    q, v = initial_state(scene, model, plant.parameters)
    x = initial_states(scene, model, q, v)
    return q, v, np.concatenate([x, np.zeros(len(plant.x_labels) - len(x))])


def _bare(plant: Plant) -> Plant:
    """The same functions for an integrator that knows of no loops."""
    return replace(plant, closure=None, rows=np.zeros(0), fronts=())


def _fastest(name: str, library: native.Library, start, model, plant: Plant, goal: float, repeats: int):  # type: ignore[no-untyped-def]
    """The loosest tolerance that reaches the goal: its error, median and least processor time [ms]."""
    for tolerance in TOLERANCES:
        scene = scene_of(name, tolerance=tolerance)
        history = native.run_natively(library, scene, start)
        if not history.ok:
            continue
        error = error_of(name, _observed(scene, model, plant, history))
        if error <= goal:
            times = []
            for _ in range(repeats):
                begin = time.thread_time()
                native.run_natively(library, scene, start)
                times.append(1e3 * (time.thread_time() - begin))
            return tolerance, error, statistics.median(times), min(times)
    return None


def run(repeats: int = 25) -> tuple[str, dict]:
    """A Markdown table and the raw numbers."""
    peers = json.loads(PEERS.read_text())["points"] if PEERS.exists() else {}
    rows, raw = [], {}
    for name, (goal, target) in GOALS.items():
        scene = scene_of(name)
        model, plant = prepare(scene)
        code = native.table_code(list(scene.tables.values()))
        start = _start(scene, model, plant)
        ours = _fastest(name, native.Library(plant, code), start, model, plant, goal, repeats)
        bare_plant = _bare(plant)
        bare = _fastest(name, native.Library(bare_plant, code), start, model, plant, goal, repeats)
        best = _peer(peers.get(name, {}), goal)
        raw[name] = {"goal": goal, "ours": ours, "bare": bare, "peer": best}
        rows.append([
            name, f"{goal:.0e}", f"{ours[2]:.2f} ({ours[3]:.2f})" if ours else "-", f"{ours[1]:.1e}" if ours else "-",
            f"{bare[2]:.2f} ({bare[3]:.2f})" if bare else "not reached",
            f"{ours[2] / bare[2]:.2f}" if ours and bare else "-", f"{target:g}" if target else "-",
            f"{best[0]} {1e3 * best[2]:.1f} at {best[1]}" if best else "-",
        ])  # fmt: skip
    header = ["problem", "error wanted", "ms, median (least)", "error", "ms without projection", "ratio", "goal [ms]",
              "best engine [ms]"]  # fmt: skip
    chain, raw["n four-bars"] = _chain(repeats)
    return f"{table(header, rows)}\n\nN four-bars in a row, 10 s (exponent from N = 5 on)\n\n{chain}", raw


def _chain(repeats: int) -> tuple[str, dict]:
    """Time over the number of loops at equal accuracy, with what was done in it and the crossings found (all: 10)."""
    names = ("evaluations", "crossings", "error", "ms")
    found: dict[str, list[float]] = {name: [] for name in names}
    for count in LOOPS:
        start = Initial(rates={"A0": -1.0})
        gravity, method = (Gravity((0, "-9.81", 0)),), Integrator("dop853", tolerance=1e-6)
        scene = Scene(f"row{count}", four_bars(count), gravity, 10.0, 20.0, start, integrator=method)
        model, plant = prepare(scene)
        library, state = native.Library(plant), _start(scene, model, plant)
        times = []
        for _ in range(repeats):
            begin = time.thread_time()
            history = native.run_natively(library, scene, state)
            times.append(1e3 * (time.thread_time() - begin))
        angle = -history.q[:, [c.label for c in model.system.tree.q].index("A0")]
        moment = ((count + 1) / 2 + count) * 9.81
        error = float(np.abs(angle - swung((count + 1) / 3 + count, moment, 1.0, history.t)).max())
        row = (history.counters["evaluations"], len(history.crossings), error, min(times))
        for name, value in zip(names, row, strict=True):
            found[name].append(value)
    rows = [[n, *(f"{found[name][k]:.3g}" for name in names)] for k, n in enumerate(LOOPS)]
    growth = np.polyfit(np.log(LOOPS[2:]), np.log(found["ms"][2:]), 1)[0]
    return table(["N", *names], [*rows, ["exponent", "", "", "", f"{growth:.2f}"]]), {"N": LOOPS, **found}


def _peer(points: dict, goal: float) -> tuple[str, str, float] | None:
    """The engine with the tightest error not below the goal, then the least time."""
    found = [
        (float(error), seconds, solver)
        for solver, reached in points.items()
        for error, seconds in reached.items()
        if float(error) >= goal * 0.99
    ]
    if not found:
        return None
    tightest = min(error for error, _, _ in found)
    seconds, solver = min((s, name) for error, s, name in found if error == tightest)
    return solver, f"{tightest:.0e}", seconds
