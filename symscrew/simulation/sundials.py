"""Stiff runs by CVODES of SUNDIALS, through CasADi: exact Jacobians from the programs.

slopes as a CasADi expression of (t, q, v, x) --CVODES (BDF, Newton)--> state at the next output --projection-->
"""

from __future__ import annotations

import itertools
from collections.abc import Callable

import casadi as ca
import numpy as np

from symscrew.export import program_function
from symscrew.scene import Scene, Table, features_in_time
from symscrew.simulation.recording import History, Instant, State, faster, shown_time
from symscrew.simulation.run_source import SPAN
from symscrew.simulation.scene_functions import PlantFunctions, RunError
from symscrew.simulation.singular_watch import singular_watch
from symscrew.simulation.state_programs import Plant

WITHIN = (0.23, 0.47, 0.71)  # parts of the way to the next output at which it is looked how fast the motion is
LEAST = 1e-13  # tolerance of single steps: below it CVODES gives up, for its Newton steps cannot reach it in doubles


def integrate(
    scene: Scene,
    plant: Plant,
    start: State,
    progress: Callable[[float], None] | None = None,
) -> History:
    """The run of a scene, from output to output and to what inputs do in time; projected and started again at each."""
    functions = PlantFunctions(plant, list(scene.tables.values()), compiled=False)
    nq, nv, nx = functions.nq, functions.nv, functions.nx
    local = max(1e-3 * scene.integrator.tolerance, LEAST)
    options = {"abstol": local, "reltol": local, "max_num_steps": scene.integrator.most_steps}
    t, y, span = ca.SX.sym("t"), ca.SX.sym("y", nq + nv + nx), ca.SX.sym("span", 3)
    at = ca.fmin(span[0] + t * span[1], span[2])
    rates = span[1] * state_rates(scene, functions, at, y)
    ode = {"x": y, "t": t, "p": span, "ode": rates}
    solver = ca.integrator("run", "cvodes", ode, 0.0, [*WITHIN, 1.0], options)
    features, longest = features_in_time(scene, plant.model), scene.integrator.longest_step or np.inf
    times = scene.times
    watch = singular_watch(functions, scene.duration)
    fastest: Instant | None = None
    states, status, ok = [np.concatenate(start)], "completed", True
    try:
        states = [np.concatenate([*functions.settled_start(start[0], start[1]), start[2]])]
    except RunError as error:
        status, ok = f"stopped at t = 0 s: {error}", False
    for left, right in itertools.pairwise(times if ok else times[:1]):
        now, at_end = float(left), states[-1]
        try:
            while now < right:
                until, latest = features.ahead(now, float(right), SPAN)
                until = min(until, now + longest)
                all_found = np.asarray(solver(x0=at_end, p=[now, until - now, latest])["xf"], dtype=float).T
                if not np.isfinite(all_found).all():
                    raise RunError("the state is not finite")
                for part, state in zip((*WITHIN, 1.0), all_found, strict=True):
                    instant = Instant(now + part * (until - now), *np.split(state, [nq, nq + nv]))
                    fastest = faster(fastest, instant, plant.units)
                found = all_found[-1]
                q, v, smallest = functions.settle(found[:nq], found[nq : nq + nv])
                now, at_end = until, np.concatenate([q, v, found[nq + nv :]])
                if watch is not None:
                    watch.seen(now, smallest)
        except (RuntimeError, RunError) as error:
            reason = str(error).splitlines()[-1][:200]
            status, ok = f"stopped at t = {shown_time(left)} s: {reason}", False
            break
        states.append(at_end)
        if progress is not None:
            progress(right / scene.duration)
    y_all = np.array(states)
    parts = y_all[:, :nq], y_all[:, nq : nq + nv], y_all[:, nq + nv :]
    doubts = () if watch is None else watch.doubts
    return History(
        times[: len(states)], *parts, ok, status, "cvodes", events=features.notices, doubts=doubts, fastest=fastest
    )


def whole_run(scene: Scene, plant: Plant, tolerance: float, most_steps: int) -> Callable[[State], np.ndarray]:
    """CVODES from a start (q, v, x) to all outputs, never projected or started again: states (outputs, q v x).

    `tolerance` is of single steps, relative and absolute; `most_steps` may lie between two outputs. Calls raise
    RunError where the integrator gives up.
    """
    functions = PlantFunctions(plant, list(scene.tables.values()), compiled=False)
    t, y = ca.SX.sym("t"), ca.SX.sym("y", functions.nq + functions.nv + functions.nx)
    ode = {"x": y, "t": t, "ode": state_rates(scene, functions, t, y)}
    options = {"abstol": tolerance, "reltol": tolerance, "max_num_steps": most_steps}
    solver = ca.integrator("run", "cvodes", ode, 0.0, [float(time) for time in scene.times[1:]], options)

    def run(start: State) -> np.ndarray:
        begin = np.concatenate(start)
        try:
            states = np.asarray(solver(x0=begin)["xf"], dtype=float).T
        except RuntimeError as error:
            raise RunError(str(error).splitlines()[-1][:120]) from error
        return np.concatenate([begin[None], states])

    return run


def state_rates(scene: Scene, functions: PlantFunctions, t: ca.SX, y: ca.SX) -> ca.SX:
    """Rates of y = (q, v, x) at the time t under the scene's controller."""
    plant, nq, nv = functions.plant, functions.nq, functions.nv
    q, v, x = y[:nq], y[nq : nq + nv], y[nq + nv :]
    s = ca.vertcat(ca.SX(0, 1), *[_table(table, t) for table in scene.tables.values()])
    a, x_dot, _ = program_function(plant.slopes)(t, q, v, x, ca.SX(0, 1), s, ca.SX(plant.parameters))
    rates = ca.SX.zeros(nq)
    for i, k in functions.plain:
        rates[int(i)] = v[int(k)]
    for i, k in functions.spheres:
        w, r, omega = q[i], q[i + 1 : i + 4], v[k : k + 3]
        rates[i] = -ca.dot(r, omega) / 2
        rates[i + 1 : i + 4] = (w * omega + ca.cross(r, omega)) / 2
    return ca.vertcat(rates, a, x_dot)


def _table(table: Table, t: ca.SX) -> ca.SX:
    """A table as a piecewise polynomial."""
    at = ca.fmin(ca.fmax(t, table.times[0]), table.times[-1])
    breaks = ca.DM(list(table.times[1:-1]))

    def piecewise(values: np.ndarray) -> ca.SX:
        return ca.pw_const(at, breaks, ca.DM(values)) if len(values) > 1 else ca.SX(float(values[0]))

    pieces = table.pieces()
    d = at - piecewise(np.array(table.times[:-1]))
    c = [piecewise(pieces[:, k]) for k in range(4)]
    return c[0] + d * (c[1] + d * (c[2] + d * c[3]))
