"""The same problem again and again: rates of an `optimisation_problem` beside a new `solve` and plain CasADi.

20 intervals of Radau points of degree 3, least effort in a fixed time, tolerance 1e-8, one thread. Every solve starts
0.1 to 1 % of the motion off the last start, with the last motion as its own start. The rival for the Panda is what a
good engineer writes: recursive Newton-Euler in SX for one point, `map` over all points in MX, states and accelerations
as unknowns, the bounds of the start as parameters, IPOPT from the last motion and multipliers; the whole program,
derivatives included, printed by CasADi and compiled. The same interpreted stands beside it. From its own guess it
ends in another local optimum of the same program, so that the rates are of different motions.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from symscrew import catalogue
from symscrew.optimisation import (
    Bounds,
    Conditions,
    OptimisationProblem,
    TrajectoryProblem,
    Transcription,
    load_problem,
    prepare,
    solve,
)
from symscrew.optimisation.tableau import tableau
from symscrew.runtime import compile_c

from .newton_euler import newton_euler
from .tables import table

EXAMPLES = Path(__file__).parents[2] / "examples" / "optimisation"
MESH = Transcription("radau", 3, 20)
SHARES = (0.01, 0.001)  # of the motion, by which the start moves from solve to solve
SOLVES = 10
COMPILER = 1800.0  # [s] at most for the functions of one problem


def problems() -> dict[str, TrajectoryProblem]:
    """Least effort in a fixed time, by name."""
    seed = load_problem(EXAMPLES / "seed_rest_to_rest.toml")
    panda = load_problem(EXAMPLES / "panda_point_to_point.toml")
    places = [f"platform_pose.{k}" for k in range(3)]
    ends = [
        Conditions(dict(zip(places, at, strict=True)), at_rest=True) for at in ((-0.1, 0, -0.55), (0.1, 0.05, -0.55))
    ]
    delta = TrajectoryProblem(
        catalogue.load("delta"), duration=0.3, start=ends[0], end=ends[1], independent=tuple(places)
    )
    delta = replace(delta, bounds=Bounds(drives=dict.fromkeys(("arm1_R", "arm2_R", "arm3_R"), (-12.0, 12.0))))
    panda = replace(panda, duration=0.8, objectives=seed.objectives)
    return {name: replace(p, transcription=MESH, accuracy=None) for name, p in
            (("seed", seed), ("delta", delta), ("panda", panda))}  # fmt: skip


def moved(problem: TrajectoryProblem, share: float) -> dict[str, float]:
    """The start, a share of the way nearer to the goal."""
    start, end = problem.start.coordinates, problem.end.coordinates
    return {label: value + share * (end[label] - value) for label, value in start.items()}


def rates(problem: TrajectoryProblem) -> dict[str, Any]:
    """Processor seconds of every kind of solve, and what they cost and agree to."""
    prepared = prepare(problem)
    built, made = timed(lambda: OptimisationProblem(problem, prepared=prepared))
    compiled = made.compiled(wait=COMPILER)
    cold, first = timed(made.solve)
    assert first.solved, first.status
    found: dict[str, Any] = {"built": built, "compiled": compiled, "cold": min(cold, timed(made.solve)[0])}
    for share in SHARES:
        spent, plan, costs = [], first, []
        for k in range(SOLVES):
            start = moved(problem, share * (k + 1))
            seconds, plan = timed(lambda start=start, warm=plan: made.solve(start=start, warm=warm))
            assert plan.solved, plan.status
            spent.append(seconds)
            costs.append(plan.cost)
        found[f"warm {share:g}"] = {
            "median": float(np.median(spent)),
            "best": min(spent),
            "steps": plan.statistics.iterations,
        }
        changed = replace(problem, start=replace(problem.start, coordinates=start))
        again, known = timed(lambda changed=changed: solve(changed, warm=first, prepared=prepared))
        found[f"solve {share:g}"] = again
        assert abs(known.cost - costs[-1]) < 1e-7 * abs(known.cost), (known.cost, costs[-1])
    return found


def timed(job: Callable[[], Any]) -> tuple[float, Any]:
    """Processor time of this process, and the result."""
    began = time.process_time()
    result = job()
    return time.process_time() - began, result


def run(names: tuple[str, ...] = ("seed", "delta", "panda"), *, rival: bool = True) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    rows: list[list[str]] = []
    raw: dict[str, Any] = {}
    for name in names:
        found = raw[name] = rates(problems()[name])
        warm = [found[f"warm {share:g}"] for share in SHARES]
        steps = [f"{1 / w['median']:.0f} ({w['steps']})" for w in warm]
        rows.append([name, f"{1 / found['cold']:.0f}", *steps, *(f"{1 / found[f'solve {s:g}']:.1f}" for s in SHARES)])
    if rival and "panda" in names:
        for way in ("interpreted", "compiled"):
            found = raw[f"panda by hand, {way}"] = Rival(problems()["panda"], compiled=way == "compiled").rates()
            warm = [found[f"warm {share:g}"] for share in SHARES]
            steps = [f"{1 / w['median']:.0f} ({w['steps']})" for w in warm]
            rows.append([f"panda, plain CasADi, {way}", f"{1 / found['cold']:.0f}", *steps, *([""] * len(SHARES))])
    header = ["solves per second", "cold, built", *(f"warm, {share:.1%} off (steps)" for share in SHARES)]
    header += [f"`solve`, warm, {share:.1%} off" for share in SHARES]
    return table(header, rows), raw


class Rival:
    """The Panda's least effort as plain CasADi, compiled whole."""

    def __init__(self, problem: TrajectoryProblem, *, compiled: bool = True) -> None:
        """Write the program, print and compile it; or have it interpreted."""
        self.problem, self.scheme = problem, tableau("radau", 3)
        self.n, self.h, count = 20, float(problem.duration) / 20, 7  # type: ignore[arg-type]
        q, v, a = (ca.SX.sym(name, count) for name in "qva")
        torque = ca.Function("torque", [q, v, a], [newton_euler(q, v, a)]).map(self.n)
        sizes = [(count, self.n + 1)] * 2 + [(count, self.n)] * 6
        parts = [ca.MX.sym(f"part{k}", *size) for k, size in enumerate(sizes)]
        y, rate, second, u = parts[0], parts[1], parts[2:5], parts[5:]
        g, cost, s, h = [], ca.MX(0), self.scheme, self.h
        for i in range(3):
            at = y[:, :-1] + h * s.nodes[i] * rate[:, :-1]
            at += h**2 * sum(s.position[i, j] * second[j] for j in range(3))
            moving = rate[:, :-1] + h * sum(s.rate[i, j] * second[j] for j in range(3))
            g.append(ca.vec(torque(at, moving, second[i]) - u[i]))
            cost += h * s.weights[i] * ca.sumsqr(u[i])
        far = y[:, :-1] + h * rate[:, :-1] + h**2 * sum(s.end_position[j] * second[j] for j in range(3))
        fast = rate[:, :-1] + h * sum(s.end_rate[j] * second[j] for j in range(3))
        g += [ca.vec(y[:, 1:] - far), ca.vec(rate[:, 1:] - fast)]
        nlp = {"x": ca.vertcat(*map(ca.vec, parts)), "f": cost, "g": ca.vertcat(*g)}
        own = {"print_level": 0, "sb": "yes", "tol": problem.solver.tolerance}
        warm = {**own, "warm_start_init_point": "yes", "mu_init": 1e-4}
        program = self.compiled(nlp) if compiled else None
        options = [{"print_time": False, "ipopt": o} for o in (own, warm)]
        made = [ca.nlpsol("rival", "ipopt", str(program) if program else nlp, given) for given in options]
        self.cold, self.warm = made
        self.labels = [f"joint{k}" for k in range(1, 8)]
        self.limits = np.array([problem.bounds.drives[label][1] for label in self.labels])
        self.sizes = [int(np.prod(size)) for size in sizes]

    def compiled(self, nlp: dict[str, Any]) -> Path:
        """The program and all derivatives as a library: six megabytes of C, which takes a compiler minutes."""
        self.folder = tempfile.TemporaryDirectory()
        library = Path(self.folder.name, "librival.so")
        ca.nlpsol("rival", "ipopt", nlp, {"print_time": False}).generate_dependencies("rival.c", {})
        source = Path("rival.c").rename(Path(self.folder.name, "rival.c"))
        compile_c(source, library, flags=["-O1"])
        return library

    def given(self, start: dict[str, float]) -> dict[str, np.ndarray]:
        """Bounds and a guess on the straight way."""
        first = np.array([start[label] for label in self.labels])
        last = np.array([self.problem.end.coordinates[label] for label in self.labels])
        low = [np.full(size, -np.inf) for size in self.sizes]
        high = [-part for part in low]
        for side in (low, high):
            side[0][:7], side[0][-7:] = first, last
            side[1][:7] = side[1][-7:] = 0.0
        for k in range(5, 8):
            high[k] = np.tile(self.limits, self.n)
            low[k] = -high[k]
        way = first + np.linspace(0, 1, self.n + 1)[:, None] * (last - first)
        guess = [way.ravel(), *(np.zeros(size) for size in self.sizes[1:])]
        return {"lbx": np.concatenate(low), "ubx": np.concatenate(high), "x0": np.concatenate(guess)}

    def packed(self, values: Mapping[str, np.ndarray]) -> np.ndarray:
        """Unknowns from y, y_1 (nodes, 7) and y_2, u (points, 7), rates by time."""
        points = {name: values[name].reshape(self.n, 3, -1) for name in ("y_2", "u")}
        parts = [values["y"], values["y_1"], *(points[name][:, i] for name in ("y_2", "u") for i in range(3))]
        return np.concatenate([np.ravel(part) for part in parts])

    def solved_from(self, values: Mapping[str, np.ndarray]) -> tuple[float, int]:
        """Cost and iterations of one solve from a guess."""
        first = self.given(dict(self.problem.start.coordinates))
        guess = np.clip(self.packed(values), first["lbx"], first["ubx"])
        plan = self.cold(**{**first, "x0": guess}, lbg=0, ubg=0)
        assert self.cold.stats()["success"]
        return float(plan["f"]), int(self.cold.stats()["iter_count"])

    def rates(self) -> dict[str, Any]:
        """As `rates` measures ours."""
        first = self.given(dict(self.problem.start.coordinates))
        self.cold(**first, lbg=0, ubg=0)
        cold, plan = timed(lambda: self.cold(**first, lbg=0, ubg=0))
        found: dict[str, Any] = {"cold": cold, "cost": float(plan["f"])}
        for share in SHARES:
            spent, last = [], plan
            for k in range(SOLVES):
                near = {**self.given(moved(self.problem, share * (k + 1))), "x0": last["x"]}
                near |= {"lam_x0": last["lam_x"], "lam_g0": last["lam_g"]}
                seconds, last = timed(lambda near=near: self.warm(**near, lbg=0, ubg=0))
                assert self.warm.stats()["success"]
                spent.append(seconds)
            steps = int(self.warm.stats()["iter_count"])
            found[f"warm {share:g}"] = {"median": float(np.median(spent)), "best": min(spent), "steps": steps}
        return found
