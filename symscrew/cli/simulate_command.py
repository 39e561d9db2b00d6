"""`symscrew simulate`: the motion of a scene, as a file, a picture, numbers, or the loop in C."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, FAILED
from symscrew.cli.shared_options import add_no_cache, check_folder, need_matplotlib
from symscrew.whole_files import destination

if TYPE_CHECKING:
    from symscrew.simulation import Run

EXAMPLES = (
    "symscrew simulate examples/scenes/hanging_platform.toml --out run.npz --plot run.png",
    "symscrew simulate scene.toml --emit-c loop",
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew simulate`."""
    command.add_argument(
        "scene", metavar="SCENE", help="a TOML file with mechanism, effects, start, drives, integrator"
    )
    command.add_argument("--out", metavar="FILE", help="the run: .npz (everything) or .csv")
    command.add_argument("--plot", metavar="FILE.png", help="a picture of the run")
    command.add_argument("--emit-c", metavar="DIR", help="write the loop for real time: one step of fixed size in C99")
    command.add_argument("--json", action="store_true", help="numbers of the run as JSON")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Read, derive, integrate, write; 1 where the run ended early or is not as good as asked for."""
    from tqdm import tqdm

    from symscrew.scene import load_scene
    from symscrew.simulation import FORMATS, prepare, run_summary, simulate, write_loop, write_run

    out = destination(options.out, FORMATS, "--out") if options.out is not None else None
    picture = destination(options.plot, (".png",), "--plot") if options.plot is not None else None
    if picture is not None:
        need_matplotlib("--plot needs")
    if options.emit_c:
        check_folder(options.emit_c, "--emit-c")
    scene = load_scene(options.scene)
    for notice in scene.initial.notices:
        print(f"note: {notice}", file=sys.stderr)
    if options.emit_c:
        for path in write_loop(scene, Path(options.emit_c)):
            print(path)
        if not (out or picture or options.json):
            return DONE
    prepared = prepare(scene)
    with tqdm(total=1.0, desc=scene.name, leave=False, disable=not sys.stderr.isatty(), file=sys.stderr) as bar:
        found = simulate(scene, prepared=prepared, progress=lambda part: bar.update(max(0.0, part - bar.n)))
    written = [write_run(found, out)] if out else []
    if picture:
        from symscrew.simulation import plot_run

        written.append(plot_run(found, picture))
    if options.json:
        print(json.dumps(_numbers(found), indent=1))
    else:
        print("\n".join(run_summary(found)))
    for path in written:
        print(f"wrote {path}", file=sys.stderr)
    return DONE if found.ok and found.accurate else FAILED


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
