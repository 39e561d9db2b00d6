"""`symscrew optimise`: the best motion of a problem, as a file, a picture, and in words or numbers."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager, redirect_stdout
from dataclasses import replace
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import add_no_cache, need_matplotlib
from symscrew.whole_files import destination, stage

if TYPE_CHECKING:
    from pathlib import Path

    from symscrew.cli.same_files import Outcome
    from symscrew.optimisation import JoinedPlan, JoinedProblem, Replay, Statistics, Trajectory, TrajectoryProblem

EXAMPLES = ("symscrew optimise examples/optimisation/seed_rest_to_rest.toml --out motion.npz --plot motion.png",)
FORMATS = (".npz", ".csv")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew optimise`."""
    command.add_argument(
        "problem", metavar="PROBLEM.toml",
        help="mechanism or scene, conditions, bounds, objectives; all its keys: --keys, or docs/how_to/optimise.md",
    )  # fmt: skip
    command.add_argument("--keys", action=_Keys, nargs=0, help="print every key of a problem file, and end")
    command.add_argument("--out", metavar="FILE", required=True, help="the motion: .npz (everything) or .csv (a table)")
    command.add_argument("--plot", metavar="FILE.png", help="a picture of the motion")
    command.add_argument("--rate", type=float, metavar="HZ", help="samples per second in the file; default: 501 in all")
    command.add_argument("--time-limit", type=float, metavar="S", help="seconds for all that is solved; default: none")
    command.add_argument(
        "--starts", type=int, metavar="N", help="guesses on all cores, the usual one and random ones; default: 1"
    )
    command.add_argument("--json", action="store_true", help="the outcome as JSON")
    add_no_cache(command)


class _Keys(argparse.Action):
    """Prints the keys of a problem file."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        from symscrew.optimisation import tables_of_keys

        print(tables_of_keys(), end="")
        parser.exit(DONE)


def run(options: argparse.Namespace) -> int:
    """Read, derive, optimise, write; 1 where no motion was found and confirmed (the last iterate is written then)."""
    from symscrew.cli.same_files import once_of_files, told

    out = destination(options.out, FORMATS, "--out")
    picture = destination(options.plot, (".png",), "--plot") if options.plot else None
    if picture is not None:
        need_matplotlib("--plot needs")
    if options.rate is not None and not 0 < options.rate < float("inf"):
        raise UsageError(f"--rate: expected samples per second above 0, got {options.rate:g}")
    words = (out.suffix, picture is not None, options.rate, options.time_limit, options.starts)
    written = {"plan": out, "picture": picture}
    with _solvers_aside():
        outcome = once_of_files("optimise", words, options.problem, lambda: _found(options, out, picture))
    return told(outcome, written, as_json=options.json, said=EARLIER)


EARLIER = "found in an earlier run of the same problem (times are those of then); --no-cache solves it again"


@contextmanager
def _solvers_aside() -> Iterator[None]:
    """What solvers print goes to the standard error, where progress is told: results stand on the standard output."""
    with redirect_stdout(sys.stderr):
        try:
            kept = os.dup(1)
            os.dup2(2, 1)
        except OSError:  # one of them is closed
            yield
            return
        try:
            yield
        finally:
            os.dup2(kept, 1)
            os.close(kept)


def _found(options: argparse.Namespace, out: Path, picture: Path | None) -> Outcome:
    """The motion or motions of a problem file: those found before of the same problem, or found now."""
    from symscrew.cli.kept_outcomes import once
    from symscrew.optimisation import JoinedProblem, load_problem_file

    problem = load_problem_file(options.problem)
    parts = problem.parts if isinstance(problem, JoinedProblem) else (problem,)
    notices = list(dict.fromkeys(notice for part in parts for notice in part.notices))
    for notice in notices:
        print(f"note: {notice}", file=sys.stderr)
    if options.time_limit is not None and not options.time_limit > 0:
        raise UsageError(f"--time-limit: expected seconds above 0, got {options.time_limit:g}")
    if isinstance(problem, JoinedProblem):
        return _joined(problem, options, out)
    if options.time_limit is not None:
        problem = replace(problem, solver=replace(problem.solver, time_limit=options.time_limit))
    if options.starts is not None:
        if options.starts < 1:
            raise UsageError(f"--starts: expected at least 1, got {options.starts}")
        problem = replace(problem, starts=options.starts)
    found = once("optimise", (problem, out.suffix, options.rate, picture is not None), lambda: _solved(
        problem, out, picture, rate=options.rate))  # fmt: skip
    if found.earlier:
        print(EARLIER, file=sys.stderr)
    return replace(found, facts={**found.facts, "notices": notices}, earlier=False)


def _solved(problem: TrajectoryProblem, out: Path, picture: Path | None, *, rate: float | None) -> Outcome:
    """The motion found; its numbers, words and files."""
    from symscrew.cli.same_files import Outcome
    from symscrew.optimisation import replay, solve, write_plan

    found = solve(problem, progress=lambda text: print(text, file=sys.stderr))
    again = replay(found) if found.ok and found.model.equations.accelerates else None
    files = {}
    with ExitStack() as held:  # all files are made before the first of them is there
        plan = held.enter_context(stage(out)) / out.name
        write_plan(found, plan, rate=rate)
        files["plan"] = plan.read_bytes()
        if picture is not None:
            from symscrew.optimisation import plot_plan  # brings Matplotlib

            drawn = held.enter_context(stage(picture)) / picture.name
            plot_plan(found, drawn, again)
            files["picture"] = drawn.read_bytes()
    facts = {"numbers": _numbers(found, again), "lines": summary(found, again)}
    return Outcome(facts, files, good=bool(found.ok) and problem.solver.time_limit == float("inf"))


def _joined(problem: JoinedProblem, options: argparse.Namespace, out: Path) -> Outcome:
    """The same for phases or load cases, which are not kept."""
    from symscrew.cli.same_files import Outcome
    from symscrew.optimisation import solve_joined, write_joined

    for name in ("plot", "starts"):
        if getattr(options, name) is not None:
            raise UsageError(f"--{name}: a problem with several motions has none; leave it out")
    if options.time_limit is not None:
        limit = options.time_limit
        parts = tuple(replace(p, solver=replace(p.solver, time_limit=limit)) for p in problem.parts)
        problem = replace(problem, parts=parts)
    found = solve_joined(problem, progress=lambda text: print(text, file=sys.stderr))
    write_joined(found, out, rate=options.rate)
    return Outcome({"numbers": _joined_numbers(found), "lines": joined_summary(found)}, good=False)


def joined_summary(found: JoinedPlan) -> list[str]:
    """The outcome of phases or load cases in words."""
    problem = found.problem
    lines = [f"{problem.name}: {found.status}"]
    if not found.ok:
        lines += [f"  {reason}" for reason in found.reasons if reason not in found.status]
        lines += _undefined(found.statistics)
        return [*lines, "  what is written is the last iterate, no motions to be relied on"]
    lines.append(f"cost {found.cost:.10g}, {len(found.parts)} parts")
    lines += [f"{name} = {value:.10g}" for name, value in found.parameters.items()]
    for k, part in enumerate(found.parts):
        lines.append(
            f"{problem.called(k)}: cost {part.cost:.10g}, duration {part.duration:.10g} s, {len(part.mesh) - 1} "
            f"intervals, bounds broken by at most {part.errors.violation:.1e} of their size"
        )
        link = found.links[k] if k < len(found.links) else None
        if link is not None:
            changes = _changes(part, link.before, link.behind)
            lines.append(f"  then rates become others: {changes}, which takes {link.lost:.6g} J")
    if found.end_error is not None:
        lines.append(f"replayed from phase to phase: ends {found.end_error:.1e} from the plan")
    done = f"{_counted(found.statistics.iterations, 'iteration')}, {_counted(found.refinements, 'refinement')}"
    return [*lines, *found.notes, *_undefined(found.statistics), done]


def _undefined(spent: Statistics) -> list[str]:
    """Where functions were undefined on the solver's way, in words."""
    if not spent.undefined:
        return []
    named = ", ".join(f"{equation} ({count})" for equation, count in spent.undefined.items())
    return [f"warnings of the solver, not finite where it went (evaluations): {named}"]


def _changes(part: Trajectory, before: Iterable[float], behind: Iterable[float]) -> str:
    """Rates of the independent coordinates before and behind a link, by name with units."""
    units = {c.label: c.unit for c in part.model.system.tree.v}
    rates = zip(part.model.equations.labels, before, behind, strict=True)
    return ", ".join(f"{name} {a:.6g} to {b:.6g} {units.get(name, '')}".rstrip() for name, a, b in rates)


def _counted(count: int, name: str) -> str:
    return f"{count} {name}{'s' * (count != 1)}"


def _joined_numbers(found: JoinedPlan) -> dict[str, object]:
    parts = []
    for k, part in enumerate(found.parts):
        own = {key: value for key, value in _numbers(part, part.replayed).items() if key not in UNSHARED}
        parts.append({"part": found.problem.called(k), **own})
    links = [
        None if x is None else {"before": x.before.tolist(), "behind": x.behind.tolist(), "lost": x.lost}
        for x in found.links
    ]
    return {
        "problem": found.problem.name, "ok": found.ok, "status": found.status, "reasons": list(found.reasons),
        "notes": list(found.notes), "cost": found.cost if found.ok else None, "parameters": found.parameters,
        "iterations": found.statistics.iterations, "refinements": found.refinements, "parts": parts, "links": links,
        "end_error": found.end_error, "times": dict(found.statistics.times),
        "processor_times": dict(found.statistics.processor), "warnings": dict(found.statistics.undefined),
    }  # fmt: skip


UNSHARED = (
    "problem",
    "iterations",
    "refinements",
    "times",
    "processor_times",
    "warnings",
    "parameters",
)  # of all parts together


def summary(found: Trajectory, again: Replay | None = None) -> list[str]:
    """The outcome in words, with a table of time."""
    from symscrew.display import aligned_table
    from symscrew.functions import u_port

    lines = [f"{found.problem.name}: {found.status}"]
    if not found.ok:
        lines += [f"  {reason}" for reason in found.reasons if reason not in found.status]
        lines += _undefined(found.statistics)
        lines.append("  what is written is the last iterate, no motion to be relied on")
        return lines
    errors = found.errors
    lines.append(f"cost {found.cost:.10g} (estimated error {errors.cost:.1e}), duration {found.duration:.10g} s")
    lines += [f"{name} = {value:.10g}" for name, value in found.parameters.items()]
    for k, (label, unit) in enumerate(zip(found.drive_labels, u_port(found.model.system).units, strict=True)):
        u = found.drives_at_points[:, k]
        low, high = found.model.drive_range(label)
        near = 1e-3 * found.model.scales.u[k]
        share = 100 * float(((u < low + near) | (u > high - near)).mean())
        lines.append(f"drive {label}: {u.min():.6g} to {u.max():.6g} {unit}, on a bound at {share:.0f} % of the points")
    lines.append(
        f"between the points: closure {errors.closure:.1e}, dynamic error {errors.dynamic:.1e} 1/s^2 (at the end "
        f"{errors.drift:.1e}), bounds broken by at most {errors.violation:.1e} of their size; smallest pivot of the "
        f"coordinates {errors.pivot:.2g}"
    )
    if again is not None:
        lines.append(
            f"replayed by forward simulation: ends {again.end_error:.1e} from the plan, closure {again.closure:.1e}, "
            f"integration error {again.integration:.1e}"
        )
    spent = found.statistics
    lines += [*found.notes, *_undefined(spent)]
    rows = [[name, f"{seconds:.3f}", f"{spent.processor[name]:.3f}"] for name, seconds in spent.times.items()]
    finer = _counted(found.refinements, "refinement")
    lines.append(f"{_counted(spent.iterations, 'iteration')}, {finer} to {len(found.mesh) - 1} intervals")
    return [*lines, aligned_table(("part", "time [s]", "processor [s]"), rows)]


def _numbers(found: Trajectory, again: Replay | None) -> dict[str, object]:
    result: dict[str, object] = {
        "problem": found.problem.name,
        "ok": found.ok,
        "status": found.status,
        "reasons": list(found.reasons),
        "notes": list(found.notes),
        "cost": found.cost if found.ok else None,
        "duration": found.duration,
        "parameters": found.parameters,
        "iterations": found.statistics.iterations,
        "intervals": len(found.mesh) - 1,
        "refinements": found.refinements,
        "times": dict(found.statistics.times),
        "processor_times": dict(found.statistics.processor),
        "warnings": dict(found.statistics.undefined),
    }
    if found.ok:
        errors = found.errors
        result["errors"] = {
            name: getattr(errors, name) for name in ("closure", "dynamic", "drift", "cost", "pivot", "violation")
        }
    if again is not None:
        result["replay"] = {
            "end_error": again.end_error, "closure": again.closure, "integration": again.integration
        }  # fmt: skip
    return result
