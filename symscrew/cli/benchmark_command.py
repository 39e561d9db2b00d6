"""`symscrew benchmark NAME`: times as a table, as JSON, as a plot."""

from __future__ import annotations

import argparse
import importlib.util
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from symscrew.studies.benchmark import Row


def run(options: argparse.Namespace) -> int:
    """Measure, print, draw."""
    from symscrew import catalogue
    from symscrew.display import Progress, table
    from symscrew.errors import DescriptionError
    from symscrew.model import derive
    from symscrew.studies.benchmark import USUAL, throughput
    from symscrew.studies.benchmark import run as measure

    if options.repeats < 1:
        raise DescriptionError(f"--repeats: expected a positive number, got {options.repeats}")
    if options.plot and Path(options.plot).suffix != ".png":
        raise DescriptionError(f"--plot: expected a file name that ends in .png, got {options.plot!r}")
    if options.plot and importlib.util.find_spec("matplotlib") is None:
        raise DescriptionError("--plot needs matplotlib: pip install 'symscrew[plot]'")
    progress = Progress()
    mechanism = catalogue.find(options.mechanism)
    with progress.step(f"derive {mechanism.name}"):
        model = derive(mechanism)
    functions = options.function or [name for name in USUAL if name in model.programs]
    with progress.step(f"compile and time {', '.join(functions)}"):
        against, repeats = options.against, options.repeats
        rows, notes = measure(model, functions, against, repeats=repeats, run_time=options.run_time)
    batches: list[dict[str, Any]] = []
    if options.throughput:
        with progress.step(f"throughput of {functions[0]}"):
            batches = throughput(model, functions[0])
    if options.json:
        content = {"rows": [row.as_json() for row in rows], "throughput": batches, "notes": notes}
        print(json.dumps({"mechanism": mechanism.name, **content}, indent=1))
    else:
        header = ("function", "variant", "operations", "least ns", "median ns (quartiles)", "difference")
        print(table(header, [_cells(row) for row in rows]))
        for note in notes:
            print(f"not compared: {note}")
        if batches:
            variants = [key for key in batches[0] if key != "states"]
            print(f"\n{functions[0]}, least ns per state; a batch is one call from Python on arrays of NumPy")
            cells = [[str(b["states"]), *(f"{b[v]['least']:.3g}" for v in variants)] for b in batches]
            print(table(("states", *variants), cells))
    if options.plot:
        print(_plot(rows, Path(options.plot), mechanism.name), file=sys.stderr if options.json else sys.stdout)
    return 0


def _cells(row: Row) -> list[str]:
    operations = "" if row.operations is None else str(row.operations)
    return [row.function, row.variant, operations, f"{row.times.least:.3g}", row.times.text, f"{row.agreement:.0e}"]


def _plot(rows: Sequence[Row], path: Path, name: str) -> Path:
    """Medians with quartiles, one bar per variant, grouped by function, on a logarithmic scale."""
    from symscrew.display import COLOURS, curve_style, figure, save_figure
    from symscrew.whole_files import replaced

    made, (axes,) = figure(1, 1, width=8.0, height=0.6 + 0.22 * len(rows))
    variants = list(dict.fromkeys(row.variant for row in rows))
    with curve_style():
        for place, row in enumerate(rows):
            median = row.times.median
            spread = [[median - row.times.lower], [row.times.upper - median]]
            colour = COLOURS[variants.index(row.variant) % len(COLOURS)]
            axes.barh(place, median, xerr=spread, color=colour, ecolor="0.35", height=0.75)
        axes.set_yticks(range(len(rows)), [f"{row.function}: {row.variant.split(': ')[-1]}" for row in rows])
        axes.invert_yaxis()
        axes.set_xscale("log")
        axes.xaxis.set_minor_formatter("")
        axes.set_xlabel("time per state  [ns], median and quartiles")
        axes.set_title(name, loc="left")
        axes.grid(False, axis="y")
    path.parent.mkdir(parents=True, exist_ok=True)
    return replaced(path, lambda part: save_figure(made, part))
