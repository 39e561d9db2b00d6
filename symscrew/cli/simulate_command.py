"""`symscrew simulate`: the motion of a scene, or many of it, as a file, a picture, numbers, or the loop in C."""

from __future__ import annotations

import argparse
import json
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, FAILED, UsageError
from symscrew.cli.shared_options import add_no_cache, check_folder, keep_inputs, need_matplotlib
from symscrew.whole_files import destination, stage

if TYPE_CHECKING:
    from symscrew.cli.same_files import Outcome
    from symscrew.scene import Scene
    from symscrew.simulation import Run

EXAMPLES = (
    "symscrew simulate examples/scenes/hanging_platform.toml --out run.npz --plot run.png",
    "symscrew simulate scene.toml --many starts.npz --out runs.npz",
    "symscrew simulate scene.toml --emit-c loop",
)
FORMATS = (".npz", ".csv")
MANY = (
    "a run per entry of the arrays of this .npz file: initial.coordinates.LABEL, initial.rates.LABEL, parameters.NAME "
    "(runs,), or whole states q, v, x (runs, size); on all processors"
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew simulate`."""
    command.add_argument(
        "scene", metavar="SCENE", help="a TOML file with mechanism, effects, start, drives, integrator"
    )
    command.add_argument("--out", metavar="FILE", help="the run: .npz (everything) or .csv")
    command.add_argument("--many", metavar="FILE.npz", help=MANY)
    command.add_argument("--threads", type=int, metavar="N", help="with --many; default: one per processor")
    command.add_argument("--plot", metavar="FILE.png", help="a picture of the run")
    command.add_argument("--emit-c", metavar="DIR", help="write the loop for real time: one step of fixed size in C99")
    text = "the same steps on many states at once, a thread a state: CUDA, which is C++, too"
    command.add_argument("--emit-cuda", metavar="DIR", help=text)
    command.add_argument("--json", action="store_true", help="numbers of the run as JSON")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Read, derive, integrate, write; 1 where the run ended early or is not as good as asked for."""
    from symscrew.cli.same_files import once_of_files, told

    formats = (".npz",) if options.many is not None else FORMATS
    out = destination(options.out, formats, "--out") if options.out else None
    picture = destination(options.plot, (".png",), "--plot") if options.plot is not None else None
    if picture is not None:
        need_matplotlib("--plot needs")
    for name, folder in (("--emit-c", options.emit_c), ("--emit-cuda", options.emit_cuda)):
        if folder is not None:
            check_folder(folder, name)
    _check_many(options)
    if out is not None and options.many is not None:
        keep_inputs([out], [options.many])
    if options.many is not None:
        return _run_many(_loaded(options.scene), options, out)
    if options.emit_c or options.emit_cuda:
        _emit(_loaded(options.scene), options)
        if not (out or picture or options.json):
            return DONE
    words = (out and out.suffix, picture is not None)
    outcome = once_of_files("simulate", words, options.scene, lambda: _made(_loaded(options.scene), out, picture))
    written = {"run": out, "picture": picture}
    return told(outcome, written, as_json=options.json, said=EARLIER)


EARLIER = "the motion of an earlier run of the same scene; --no-cache integrates it again"


def _loaded(path: str) -> Scene:
    """The scene of a file, and what is said of it."""
    from symscrew.scene import load_scene

    scene = load_scene(path)
    for notice in scene.initial.notices:
        print(f"note: {notice}", file=sys.stderr)
    return scene


def _emit(scene: Scene, options: argparse.Namespace) -> None:
    """The loop for real time and the steps of many states, as far as they were asked for."""
    from symscrew.simulation import write_loop, write_steps

    written = write_loop(scene, Path(options.emit_c)) if options.emit_c else []
    written += write_steps(scene, Path(options.emit_cuda)) if options.emit_cuda else []
    for path in written:
        print(path)


def _made(scene: Scene, out: Path | None, picture: Path | None) -> Outcome:
    """The motion integrated; its numbers, words and files."""
    from symscrew.cli.same_files import Outcome
    from symscrew.display import bar_on_terminal
    from symscrew.simulation import ON_NUMPY, prepare, run_summary, simulate, write_run

    prepared = prepare(scene)
    with bar_on_terminal(total=1.0, desc=scene.name) as bar:
        found = simulate(scene, prepared=prepared, progress=lambda part: bar.update(max(0.0, part - bar.n)))
    files = {}
    with ExitStack() as held:  # all files are made before the first of them is there
        if out is not None:
            files["run"] = write_run(found, held.enter_context(stage(out)) / out.name).read_bytes()
        if picture is not None:
            from symscrew.simulation import plot_run  # brings Matplotlib, a third of a short run's time

            files["picture"] = plot_run(found, held.enter_context(stage(picture)) / picture.name).read_bytes()
    facts = {"numbers": _numbers(found), "lines": run_summary(found), "notices": list(scene.initial.notices)}
    # where a compiler failed, it may do its work the next time
    compiled = not any(event.startswith(ON_NUMPY) for event in found.events)
    return Outcome(facts, files, good=found.ok and found.accurate and compiled)


def _check_many(options: argparse.Namespace) -> None:
    """Raises UsageError where options do not go together, or the number of threads is none."""
    if options.threads is not None and (options.many is None or options.threads < 1):
        raise UsageError("--threads: expected a number above 0, beside --many")
    for name, given in (("--plot", options.plot), ("--emit-c", options.emit_c), ("--emit-cuda", options.emit_cuda)):
        if options.many is not None and given is not None:
            raise UsageError(f"{name} is of one run: leave it out, or --many")


def _run_many(scene: Scene, options: argparse.Namespace, out: Path | None) -> int:
    """As `run`, from the starts of a file; 1 where any run ended early or is not as good as asked for."""
    from symscrew.array_archives import read_archive
    from symscrew.display import bar_on_terminal, print_text
    from symscrew.simulation import runs_numbers, runs_summary, simulate_many, write_runs

    starts = read_archive(options.many)
    with bar_on_terminal(unit="run", desc=scene.name) as bar:
        found = simulate_many(
            scene, starts, threads=options.threads, progress=lambda done: bar.update(max(0, done - bar.n))
        )
    written = write_runs(found, out) if out else None
    if options.json:
        print(json.dumps(runs_numbers(found), indent=1))
    else:
        print_text("\n".join(runs_summary(found)))
    if written:
        print(f"wrote {written}", file=sys.stderr)
    return DONE if found.all_ok else FAILED


def _numbers(found: Run) -> dict[str, object]:
    """What `--json` prints."""
    import numpy as np

    return {
        "scene": found.scene.name,
        "ok": found.ok and found.accurate,
        "status": found.verdict,
        "estimated_error": found.estimate.error
        if found.estimate is not None and np.isfinite(found.estimate.error)
        else None,
        "impacts_took": dict(found.losses),
        "assembly_mode": {"name": found.mode, "start": found.modes[0], "end": found.modes[1]},
        "outputs": len(found.t),
        "end": float(found.t[-1]),
        "closure_error": float(found.closure_error.max(initial=0.0)),
        "energy_balance": float(np.abs(found.energy_balance).max(initial=0.0)),
        "largest_kinetic_energy": float(found.energy[:, 0].max(initial=0.0)),
        "counters": dict(found.counters),
        "crossings": [{"t": c.t, "lost": c.lost, "rows": list(c.rows), "q": c.q.tolist()} for c in found.crossings],
        "events": list(found.events),
    }
