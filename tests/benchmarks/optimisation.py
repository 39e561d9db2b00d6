"""Trajectory optimisation against hand-written plain CasADi SX and against opty, the same problems in one run.

The hand-written form is the usual good one for a tree: recursive Newton-Euler dynamics written in SX for one point,
states and accelerations as unknowns at Radau points, the same mesh, guess, bounds and tolerance, exact Hessian by
CasADi's own differentiation of the whole program. Solves are cold: everything from the problem to the optimum.

opty takes its more accurate rule (midpoint) on so many nodes that its error is of the size of ours, by both of its
backends: Cython compiles the equations, NumPy does not. Times are processor times, of child processes (compilers) too.
"""

from __future__ import annotations

import contextlib
import importlib.util
import io
import math
import resource
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from symscrew.optimisation.followed_motion import replay
from symscrew.optimisation.guess import first_guess
from symscrew.optimisation.problem import TrajectoryProblem
from symscrew.optimisation.problem_file import load_problem
from symscrew.optimisation.solution import prepare, solve
from symscrew.optimisation.tableau import tableau

from . import re_optimisation
from .newton_euler import newton_euler
from .tables import table

EXAMPLES = Path(__file__).parents[2] / "examples" / "optimisation"
DURATION = 0.5  # [s] of the Panda beside hand-written code
CASES = ("seed_rest_to_rest", "seed_minimum_time", "five_bar_pick_and_place", "panda_point_to_point")


def run(*, repeats: int) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    rows, raw = [], {}
    for name in CASES:
        problem = load_problem(EXAMPLES / f"{name}.toml")
        seconds, found = min((_timed(lambda p=problem: solve(p)) for _ in range(repeats)), key=lambda t: t[0])
        raw[name] = {"seconds": seconds, "cost": found.cost, **dict(found.statistics.processor)}
        times = [f"{v:.2f}" for v in found.statistics.processor.values()]
        spent = (f"{len(found.mesh) - 1}", str(found.statistics.iterations), *times)
        rows.append([name, *spent, f"{found.cost:.8g}", f"{replay(found).end_error:.1e}"])
    header = ("case", "intervals", "iterations", *found.statistics.processor, "cost", "replay ends off by")
    text = "Cold solves, processor time [s], least of the repeats.\n\n" + table(header, rows)
    beside, numbers = _panda_beside_handwritten(repeats)
    text += "\n\nPanda, least effort in 0.5 s, 20 intervals, Radau 3: beside plain CasADi SX.\n\n" + beside
    other, more = _cart_pole_beside_opty(repeats)
    text += "\n\nPendulum on a cart, swing-up in 2 s: beside opty.\n\n" + other
    again, rates = re_optimisation.run()
    text += "\n\nThe same problem again and again, 20 intervals of Radau 3, least effort, one thread.\n\n" + again
    return text, {**raw, "panda_by_hand": numbers, "opty": more, "again": rates}


def _timed(job: Callable[[], Any]) -> tuple[float, Any]:
    """Processor time of a job and of what it starts, and its result."""
    began = _processor()
    result = job()
    return _processor() - began, result


def _processor() -> float:
    used = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(u.ru_utime + u.ru_stime for u in used)


# -- Panda by hand ----------------------------------------------------------------------------------------------


def _panda() -> TrajectoryProblem:
    problem = load_problem(EXAMPLES / "panda_point_to_point.toml")
    from symscrew.optimisation.problem import Objective, Transcription

    return replace(
        problem,
        duration=DURATION,
        objectives=(Objective("effort"),),
        transcription=Transcription("radau", 3, 20),
        accuracy=None,
    )


def by_hand(problem: TrajectoryProblem, values: dict[str, np.ndarray]) -> tuple[float, int]:
    """Cost and iterations of the Panda's least effort by plain CasADi SX with the given guess."""
    n, scheme = problem.transcription.intervals, tableau("radau", 3)
    h, count = float(problem.duration) / n, 7  # type: ignore[arg-type]
    limits = np.array([problem.bounds.drives[f"joint{k}"][1] for k in range(1, 8)])
    x, low, high, guess, g, cost = [], [], [], [], [], ca.SX(0)

    def unknown(name: str, start: np.ndarray, bound: np.ndarray | float = np.inf) -> ca.SX:
        x.append(ca.SX.sym(name, count))
        low.append(np.broadcast_to(-np.asarray(bound, dtype=float), count))
        high.append(np.broadcast_to(np.asarray(bound, dtype=float), count))
        guess.append(start)
        return x[-1]

    q, v = unknown("q0", values["y"][0]), unknown("v0", values["y_1"][0])
    first = values["y"][0]
    low[0] = high[0] = first
    low[1] = high[1] = np.zeros(count)
    for k in range(n):
        a = [unknown(f"a{k}{j}", values["y_2"][3 * k + j]) for j in range(3)]
        u = [unknown(f"u{k}{j}", np.clip(values["u"][3 * k + j], -limits, limits), limits) for j in range(3)]
        for i in range(3):
            at = q + h * scheme.nodes[i] * v + h**2 * sum(scheme.position[i, j] * a[j] for j in range(3))
            rate = v + h * sum(scheme.rate[i, j] * a[j] for j in range(3))
            g.append(newton_euler(at, rate, a[i]) - u[i])
            cost += h * scheme.weights[i] * ca.dot(u[i], u[i])
        q_end = q + h * v + h**2 * sum(scheme.end_position[j] * a[j] for j in range(3))
        v_end = v + h * sum(scheme.end_rate[j] * a[j] for j in range(3))
        q, v = unknown(f"q{k + 1}", values["y"][k + 1]), unknown(f"v{k + 1}", values["y_1"][k + 1])
        g += [q - q_end, v - v_end]
    low[-2] = high[-2] = values["y"][-1]
    low[-1] = high[-1] = np.zeros(count)
    nlp = {"x": ca.vertcat(*x), "f": cost, "g": ca.vertcat(*g)}
    quiet = {"print_time": False, "ipopt": {"print_level": 0, "sb": "yes", "tol": problem.solver.tolerance}}
    solver = ca.nlpsol("by_hand", "ipopt", nlp, quiet)
    found = solver(x0=np.concatenate(guess), lbx=np.concatenate(low), ubx=np.concatenate(high), lbg=0, ubg=0)
    assert solver.stats()["success"]
    return float(found["f"]), int(solver.stats()["iter_count"])


def _panda_beside_handwritten(repeats: int) -> tuple[str, dict[str, Any]]:
    problem = _panda()
    prepared = prepare(problem)
    mesh = np.linspace(0, 1, 21)
    points = mesh[:-1, None] + np.diff(mesh)[:, None] * tableau("radau", 3).nodes
    values = first_guess(prepared.model).arrays(prepared.model, mesh, points)
    values |= {"y_1": values["y_1"] / DURATION, "y_2": values["y_2"] / DURATION**2}
    ours, theirs, mapped = [], [], []
    for _ in range(repeats):
        seconds, found = _timed(lambda: solve(problem))
        ours.append(seconds)
        seconds, (cost, iterations) = _timed(lambda: by_hand(problem, values))
        theirs.append(seconds)
        seconds, (other, more) = _timed(lambda: re_optimisation.Rival(problem, compiled=False).solved_from(values))
        mapped.append(seconds)
    assert abs(cost - other) < 1e-6 * abs(cost), (cost, other)
    # ours keeps the bounds between the points as well, which costs a little more
    assert abs(cost - found.cost) < 1e-4 * abs(cost), (cost, found.cost)
    rows = [
        ["symscrew", f"{min(ours):.2f}", str(found.statistics.iterations), f"{found.cost:.9g}"],
        ["plain CasADi, one SX point function in MX and map", f"{min(mapped):.2f}", str(more), f"{other:.9g}"],
        ["plain CasADi SX, all points in one graph", f"{min(theirs):.2f}", str(iterations), f"{cost:.9g}"],
        ["ratios to ours", f"{min(mapped) / min(ours):.2f}; {min(theirs) / min(ours):.2f}", "", ""],
    ]
    raw = {"ours": ours, "mapped": mapped, "by_hand": theirs}
    return table(("", "cold solve [s]", "iterations", "cost"), rows), raw


# -- opty ---------------------------------------------------------------------------------------------------------


NODES = 401
BACKENDS = ("cython", "numpy")


def _cart_pole_beside_opty(repeats: int) -> tuple[str, dict[str, Any]]:
    if importlib.util.find_spec("opty") is None:
        return 'opty is not installed, nothing is compared: pip install -e ".[opty]" (builds cyipopt on IPOPT)', {}
    from symscrew.optimisation.problem import Transcription
    from tests.support.optimal_problems import cart_pole_problem

    known = solve(cart_pole_problem(Transcription("gauss", 6, 60))).cost
    jobs: dict[str, Callable[[], float]] = {
        "symscrew, Gauss 2, 20 intervals": lambda: solve(cart_pole_problem(Transcription("gauss", 2, 20))).cost,
        "symscrew, Radau 3, 50 intervals": lambda: solve(cart_pole_problem(Transcription("radau", 3, 50))).cost,
    }
    jobs |= {
        f"opty, midpoint, {NODES} nodes, {name}": lambda name=name: opty_cart_pole(NODES, name) for name in BACKENDS
    }
    seconds: dict[str, list[float]] = {name: [] for name in jobs}
    costs: dict[str, float] = {}
    for _ in range(repeats):
        for name, job in jobs.items():
            with contextlib.redirect_stdout(io.StringIO()):
                spent, costs[name] = _timed(job)
            seconds[name].append(spent)
    first = min(next(iter(seconds.values())))
    rows = [
        [
            name,
            f"{min(spent):.3f}",
            f"{min(spent) / first:.1f}",
            f"{costs[name]:.8g}",
            f"{abs(costs[name] - known):.1e}",
        ]
        for name, spent in seconds.items()
    ]
    header = ("", "cold solve [s]", "over the first", "cost", "error of the cost")
    return table(header, rows), {"seconds": seconds, "costs": costs, "known": known}


def opty_cart_pole(nodes: int, backend: str) -> float:
    """Cost of the swing-up by opty: midpoint rule, exact first derivatives, second ones approximated by IPOPT."""
    import sympy
    import sympy.physics.mechanics as me
    from opty.direct_collocation import Problem

    t = me.dynamicsymbols._t
    x, angle, v, w, u = me.dynamicsymbols("x angle v w u")
    m1, m2, l, g = 1.0, 0.3, 0.5, 9.81
    s, c = sympy.sin(angle), sympy.cos(angle)
    equations = sympy.Matrix(
        [
            x.diff(t) - v,
            angle.diff(t) - w,
            (m1 + m2) * v.diff(t) + m2 * l * c * w.diff(t) - m2 * l * s * w**2 - u,
            c * v.diff(t) + l * w.diff(t) + g * s,
        ]
    )
    h = 2.0 / (nodes - 1)

    def cost(free: np.ndarray) -> float:
        return h * float((free[4 * nodes :] ** 2).sum())

    def slope(free: np.ndarray) -> np.ndarray:
        result = np.zeros_like(free)
        result[4 * nodes :] = 2 * h * free[4 * nodes :]
        return result

    ends: Sequence[Any] = [
        x.subs(t, 0), angle.subs(t, 0), v.subs(t, 0), w.subs(t, 0),
        x.subs(t, 2.0) - 1.0, angle.subs(t, 2.0) - math.pi, v.subs(t, 2.0), w.subs(t, 2.0),
    ]  # fmt: skip
    made: Callable[..., Any] = Problem
    problem = made(
        cost, slope, equations, (x, angle, v, w), nodes, h, instance_constraints=ends,
        bounds={u: (-20.0, 20.0), x: (-2.0, 2.0)}, time_symbol=t, integration_method="midpoint", backend=backend,
    )  # fmt: skip
    problem.add_option("print_level", 0)
    part = np.linspace(0, 1, nodes)
    guess = np.concatenate([part, math.pi * part, np.full(nodes, 0.5), np.full(nodes, math.pi / 2), np.zeros(nodes)])
    _, info = problem.solve(guess)
    return float(info["obj_val"])
