"""`symscrew benchmark NAME`: times as a table, as JSON, as a plot."""

from __future__ import annotations

import argparse
import json
import sys
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import add_described_mechanism, add_no_cache, find_mechanism, need_matplotlib
from symscrew.whole_files import destination

if TYPE_CHECKING:
    from symscrew.studies.benchmark import Row

EXAMPLES = (
    "symscrew benchmark ur5 --against pinocchio mujoco --plot times.png",
    "symscrew benchmark three_ups_upu_s --function inverse_dynamics --throughput",
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew benchmark`."""
    add_described_mechanism(command)
    command.add_argument("--function", nargs="+", metavar="NAME", help="default: dynamics, reactions, mass matrix")
    command.add_argument("--against", nargs="+", choices=("pinocchio", "mujoco"), default=[], help="other libraries")
    command.add_argument("--repeats", type=int, default=25, help="interleaved repeats (default: 25)")
    command.add_argument("--throughput", action="store_true", help="also batches of 1, 8, 1000 and 1000000 states")
    command.add_argument("--run-time", action="store_true", help="also code that reads all parameters at run time")
    command.add_argument("--plot", metavar="FILE.png", help="medians and quartiles as a picture")
    command.add_argument("--json", action="store_true", help="numbers as JSON instead of the tables")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Measure, print, draw."""
    from symscrew.display import Progress, print_table, print_text
    from symscrew.model import derive
    from symscrew.studies.benchmark import USUAL_FUNCTIONS, throughput, time_functions

    if options.repeats < 1:
        raise UsageError(f"--repeats: expected a positive number, got {options.repeats}")
    picture = destination(options.plot, (".png",), "--plot") if options.plot else None
    if picture:
        need_matplotlib("--plot needs")
    progress = Progress()
    mechanism = find_mechanism(options.mechanism, acting=True)
    with progress.step(f"derive {mechanism.name}"):
        model = derive(mechanism)
    functions = options.function or [name for name in USUAL_FUNCTIONS if name in model.programs]
    with progress.step(f"compile and time {', '.join(functions)}"):
        rows, notes = time_functions(
            model, functions, options.against, repeats=options.repeats, run_time=options.run_time
        )
    batches = []
    if options.throughput:
        with progress.step(f"throughput of {functions[0]}"):
            batches = throughput(model, functions[0])
    if options.json:
        content = {"rows": [row.as_json() for row in rows], "throughput": batches, "notes": notes}
        print(json.dumps({"mechanism": mechanism.name, **content}, indent=1))
    else:
        header = ("function", "variant", "operations", "least ns", "median ns (quartiles)", "difference")
        print_table(header, [_cells(row) for row in rows])
        for note in notes:
            print_text(f"not compared: {note}")
        if batches:
            variants = [key for key in batches[0] if key != "states"]
            print(f"\n{functions[0]}, least ns per state; a batch is one call from Python on arrays of NumPy")
            cells = [[str(b["states"]), *(f"{b[v]['least']:.3g}" for v in variants)] for b in batches]
            print_table(("states", *variants), cells)
    if picture:
        from symscrew.studies.benchmark import draw_times

        path = draw_times(rows, picture, mechanism.name)
        print(path, file=sys.stderr if options.json else sys.stdout)
    return DONE


def _cells(row: Row) -> list[str]:
    operations = "" if row.operations is None else str(row.operations)
    return [row.function, row.variant, operations, f"{row.times.least:.3g}", row.times.text, f"{row.agreement:.0e}"]
