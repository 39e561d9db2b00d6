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
from symscrew.simulation import Functions, Plant, RunError
from symscrew.studies.accuracy.formulation_libraries import TREE
from symscrew.studies.accuracy.measuring import Setup, Stopwatch

Array = np.ndarray
TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11)
SCIPY = ("Radau", "BDF")
PANEL = "stiff libraries"
LONGEST = 5.0  # seconds after which a run is given up
MOST = 5_000  # steps of CVODES between two outputs


def stiff_setups(
    scene: Scene, plant: Plant, start: tuple[Array, Array, Array], error_of: Callable[[Array], float], watch: Stopwatch
) -> tuple[list[Setup], list[str]]:
    """Runs by the libraries that are installed, and what is left out."""
    setups: list[Setup] = []
    missing = []
    without = "no stabilisation" if plant.closure is not None else TREE
    if importlib.util.find_spec("scipy") is None:
        missing.append("Radau and BDF of SciPy: SciPy is not installed")
    else:
        functions = watch("compile", Functions, plant, list(scene.tables.values()), compiled=True)
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
    return [_setup(scene, curve, tolerance, run_at, error_of) for tolerance in TOLERANCES]


def _setup(scene, curve, tolerance, run_at, error_of) -> Setup:  # type: ignore[no-untyped-def]
    found: list[Array] = []

    def run() -> float:
        taken, q = run_at(tolerance)
        found[:] = [q]
        return taken

    setting = f"tolerance {tolerance:g}"
    return Setup(curve, setting, run, lambda: error_of(found[0]), scene.duration, {"panel": PANEL})


def _by_scipy(scene: Scene, functions: Functions, start: tuple, method: str) -> Callable[[float], tuple[float, Array]]:
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
                a, x_dot = functions.slopes(t, q, v, y[nq + nv :], nothing, nothing)
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


def _by_cvodes(scene: Scene, plant: Plant, start: tuple, watch: Stopwatch) -> Callable[[float], tuple[float, Array]]:
    from symscrew.simulation import whole_run

    functions = Functions(plant, list(scene.tables.values()), compiled=False)
    made: dict[float, Callable[[tuple], Array]] = {}

    def run(tolerance: float) -> tuple[float, Array]:
        if tolerance not in made:
            made[tolerance] = watch("compile", whole_run, scene, plant, tolerance, MOST)
        begin = time.thread_time()
        states = made[tolerance](start)
        return time.thread_time() - begin, _normalised(functions, states)

    return run


def _normalised(functions: Functions, states: Array) -> Array:
    return np.array([functions.normalised(y[: functions.nq]) for y in states])
