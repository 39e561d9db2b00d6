"""`symscrew simulate`."""

from __future__ import annotations

import argparse
import importlib.util
import json
import sys
from pathlib import Path

import numpy as np
from tqdm import tqdm

from symscrew.errors import DescriptionError
from symscrew.scene import load_scene
from symscrew.simulation import FORMATS, prepare, run_summary, simulate, write_run
from symscrew.whole_files import destination


def run(options: argparse.Namespace) -> int:
    """Read, derive, integrate, write; 1 where the run ended early."""
    out = destination(options.out, FORMATS, "--out") if options.out is not None else None
    picture = destination(options.plot, (".png",), "--plot") if options.plot is not None else None
    if picture is not None and importlib.util.find_spec("matplotlib") is None:
        raise DescriptionError('--plot needs matplotlib, which is not installed: pip install "symscrew[plot]"')
    scene = load_scene(options.scene)
    if options.emit_c:
        from symscrew.simulation import write_loop

        for path in write_loop(scene, Path(options.emit_c)):
            print(path)
        if not (out or picture or options.json):
            return 0
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
    return 0 if found.ok else 1


def _numbers(found) -> dict[str, object]:  # type: ignore[no-untyped-def]
    return {
        "scene": found.scene.name,
        "ok": found.ok,
        "status": found.status,
        "outputs": len(found.t),
        "end": float(found.t[-1]),
        "closure_error": float(found.closure_error.max(initial=0.0)),
        "energy_balance": float(np.abs(found.energy_balance).max(initial=0.0)),
        "largest_kinetic_energy": float(found.energy[:, 0].max(initial=0.0)),
        "counters": {k: found.counters[k] for k in found.counters},
        "crossings": [{"t": c.t, "lost": c.lost, "rows": list(c.rows), "q": c.q.tolist()} for c in found.crossings],
        "events": list(found.events),
    }
