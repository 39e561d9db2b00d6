"""Guesses that lead to the best optimum: every problem from its usual guess and from random ones.

Costs are those on the problem's first mesh; the last column says what the usual guess alone finds. Published: cart-pole
of M. Kelly, SIAM Review 59(4), 2017 (58.8077 by an independent transcription in tests/oracles); blocks in closed form.
"""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path
from typing import Any

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.optimisation.many_starts import Search
from symscrew.optimisation.problem import Bounds, Objective, Solver, TrajectoryProblem, Transcription
from symscrew.optimisation.problem_file import load_problem
from symscrew.optimisation.solution import solve
from tests.support.optimal_problems import cart_pole_problem, rest_to_rest, slider

from .tables import table

EXAMPLES = Path(__file__).parents[2] / "examples" / "optimisation"
ITERATIONS = 200  # of an attempt: those that end well need fewer, others would take most of the time


def two_links(name: str, driven: tuple[bool, bool]) -> Mechanism:
    """Two uniform rods of 1 kg and 1 m, hanging; each joint driven or not."""
    made = MechanismBuilder(name)
    for k, (link, parent) in enumerate((("upper", "base"), ("lower", "upper"))):
        centre = f"-{k}-1/2"
        made.body(link, mass=1, com=[0, 0, centre], inertia=["1/12", "1/12", 0])
        made.joint(
            ("shoulder", "elbow")[k], "R", parent=parent, child=link, point=[0, 0, -k], axes=[[0, 1, 0]],
            driven=driven[k],
        )  # fmt: skip
    return made.build()


def problems() -> dict[str, TrajectoryProblem]:
    """By name; all on meshes of their own without refinement."""
    up = rest_to_rest({"shoulder": 0.0, "elbow": 0.0}, {"shoulder": 3.141592653589793, "elbow": 0.0})
    both = {"independent": ("shoulder", "elbow")}
    mesh = {"transcription": Transcription(intervals=30)}
    block = {**rest_to_rest({"slide": 0.0}, {"slide": 1.0}), "effects": (), **mesh}
    weak = Bounds(drives={"shoulder": (-12.0, 12.0), "elbow": (-6.0, 6.0)})
    found = {
        "block, least effort": TrajectoryProblem(slider(), **block),  # type: ignore[arg-type]
        "block, least time": TrajectoryProblem(
            slider(), **block, duration=(0.1, 5.0), objectives=(Objective("time"),),  # type: ignore[arg-type]
            bounds=Bounds(drives={"slide": (-1.0, 1.0)}),
        ),
        "block, least energy": TrajectoryProblem(
            slider(), **block, objectives=(Objective("energy"),),  # type: ignore[arg-type]
            bounds=Bounds(drives={"slide": (-20.0, 20.0)}),
        ),
        "cart-pole (Kelly 2017)": cart_pole_problem(Transcription(intervals=30)),
        "2R arm, weak drives": TrajectoryProblem(
            two_links("arm", (True, True)), **up, **mesh, duration=2.0, bounds=weak  # type: ignore[arg-type]
        ),
        "acrobot, 3 s": TrajectoryProblem(
            two_links("acrobot", (False, True)), **up, **both, duration=3.0,  # type: ignore[arg-type]
            transcription=Transcription(intervals=40),
        ),
    }  # fmt: skip
    for name in ("five_bar_pick_and_place", "five_bar_through_singularity", "seed_rest_to_rest", "seed_minimum_time",
                 "delta_pick_and_place"):  # fmt: skip
        found[name] = load_problem(EXAMPLES / f"{name}.toml")
    five = found["five_bar_pick_and_place"]
    for kind in ("energy", "electrical"):
        weights = {"base_left": 0.05, "base_right": 0.05} if kind == "electrical" else {}
        found[f"five_bar, least {kind}"] = replace(five, duration=0.5, objectives=(Objective(kind, weights=weights),))
    return found


def run(*, repeats: int) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers; `repeats`: guesses of a problem."""
    rows, raw = [], {}
    for name, problem in problems().items():
        began = time.perf_counter()
        mesh = replace(problem.transcription, intervals=min(problem.transcription.intervals, 40))
        posed = replace(
            problem, starts=repeats, accuracy=None, transcription=mesh, solver=Solver(iterations=ITERATIONS)
        )
        search = solve(posed).search
        assert isinstance(search, Search)
        spent = time.perf_counter() - began
        usual = search.attempts[0]
        raw[name] = {"costs": [a.cost for a in search.attempts], "ok": [a.ok for a in search.attempts]}
        others = ", ".join(f"{cost:.6g} ({count})" for cost, count in search.optima[1:4]) or "-"
        none = sum(not a.ok for a in search.attempts)
        best = f"{search.optima[0][0]:.7g}" if search.optima else "-"
        rows.append([name, best, f"{100 * search.share:.0f} %", others, str(none),
                     f"{usual.cost:.6g}" if usual.ok else "none", f"{spent:.0f}"])  # fmt: skip
    header = ("problem", "best cost", f"share of {repeats} guesses", "next costs (guesses)", "no motion",
              "usual guess", "wall time [s]")  # fmt: skip
    return table(header, rows), raw
