"""Stiff integrators of well-kept libraries as further curves of the study "forward".

SciPy's Radau and BDF step in Python and call the scene's compiled slopes; their Jacobians are finite differences.
CVODES (BDF, variable order, of SUNDIALS) runs inside CasADi with exact Jacobians. All integrate the equations without
stabilisation and give every output from one run: loops, where there are some, drift.
"""

from __future__ import annotations

import importlib.util
import time
from collections.abc import Callable

import numpy as np

from symscrew.scene import Scene
from symscrew.simulation import Plant, PlantFunctions, RunError
from symscrew.studies.accuracy.formulation_libraries import TREE, Start
from symscrew.studies.accuracy.measuring import Setup, Stopwatch

Array = np.ndarray
TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11)  # absolute and relative, from coarse to near rounding
SCIPY = ("Radau", "BDF")
PANEL = "stiff libraries"
LONGEST = 5.0  # seconds after which a run is given up: SciPy steps in Python, and a study has many settings
MOST = 5_000  # steps of CVODES between two outputs; what needs more is not stiff but does not converge


def stiff_setups(
    scene: Scene, plant: Plant, start: Start, error_of: Callable[[Array], float], *, watch: Stopwatch
) -> tuple[list[Setup], list[str]]:
    """Runs by the libraries that are installed, and what is left out."""
    setups: list[Setup] = []
    missing = []
    without = "no stabilisation" if plant.closure is not None else TREE
    if importlib.util.find_spec("scipy") is None:
        missing.append("Radau and BDF of SciPy: SciPy is not installed")
    else:
        functions = watch("compile", PlantFunctions, plant, list(scene.tables.values()), compiled=True)
        for method in SCIPY:
            curve = f"{method} of SciPy, {without}"
            setups += _setups(scene, curve, _by_scipy(scene, functions, start, method), error_of)
    if importlib.util.find_spec("casadi") is None:
        missing.append("CVODES: CasADi is not installed")
    else:
        curve = f"CVODES in CasADi, {without}"
        setups += _setups(scene, curve, _by_cvodes(scene, plant, start, watch), error_of)
    return setups, missing


def _setups(
    scene: Scene, curve: str, run_at: Callable[[float], tuple[float, Array]], error_of: Callable[[Array], float]
) -> list[Setup]:
    def at(tolerance: float) -> Setup:
        found: list[Array] = []

        def run() -> float:
            taken, q = run_at(tolerance)
            found[:] = [q]
            return taken

        setting = f"tolerance {tolerance:g}"
        return Setup(curve, setting, run, lambda: error_of(found[0]), scene.duration, {"family": PANEL})

    return [at(tolerance) for tolerance in TOLERANCES]


def _by_scipy(
    scene: Scene, functions: PlantFunctions, start: Start, method: str
) -> Callable[[float], tuple[float, Array]]:
    from scipy import integrate

    nq, nv = functions.nq, functions.nv
    nothing = np.zeros(0)

    def run(tolerance: float) -> tuple[float, Array]:
        begin = time.thread_time()

        def slopes(t: float, y: Array) -> Array:
            if time.thread_time() - begin > LONGEST:
                raise ArithmeticError(f"given up after {LONGEST:g} s")
            q, v = y[:nq], y[nq : nq + nv]
            try:
                a, x_dot = functions.slopes(t, q, v, y[nq + nv :], u=nothing, outside=nothing)
            except RunError:  # the integrator then takes a smaller step
                return np.full_like(y, np.nan)
            return np.concatenate([functions.coordinate_rates(q, v), a, x_dot])

        y = np.concatenate(start)
        span = (0.0, float(scene.times[-1]))
        found = integrate.solve_ivp(slopes, span, y, method, scene.times, rtol=max(tolerance, 3e-14), atol=tolerance)
        taken = time.thread_time() - begin
        if not found.success:
            raise ArithmeticError(found.message)
        return taken, _normalised(functions, found.y.T)

    return run


def _by_cvodes(scene: Scene, plant: Plant, start: Start, watch: Stopwatch) -> Callable[[float], tuple[float, Array]]:
    from symscrew.simulation import whole_run

    functions = PlantFunctions(plant, list(scene.tables.values()), compiled=False)
    made: dict[float, Callable[[Start], Array]] = {}

    def run(tolerance: float) -> tuple[float, Array]:
        if tolerance not in made:
            made[tolerance] = watch("compile", whole_run, scene, plant, tolerance, MOST)
        begin = time.thread_time()
        states = made[tolerance](start)
        return time.thread_time() - begin, _normalised(functions, states)

    return run


def _normalised(functions: PlantFunctions, states: Array) -> Array:
    return np.array([functions.normalised(y[: functions.nq]) for y in states])
