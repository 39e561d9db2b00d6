"""`symscrew embedded NAME`: what functions cost on a microcontroller, as a table and as embedded.json."""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, FAILED
from symscrew.cli.shared_options import add_described_mechanism, find_mechanism
from symscrew.whole_files import destination, write_text

if TYPE_CHECKING:
    from symscrew.model import Model

EXAMPLES = (
    "symscrew embedded three_ups_upu_s --core m4f --out embedded.json",
    "symscrew embedded four_bar --core m4f --function velocity --report evidence.md",
)
USUAL_FUNCTIONS = (
    "inverse_dynamics",
    "inverse_dynamics_platform",
    "joint_reactions",
    "forward_dynamics",
    "forward_dynamics_independent",
    "assemble",
)
COLUMNS = ("flash", "frame", "stack", "instructions", "error")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew embedded`."""
    add_described_mechanism(command)
    command.add_argument("--core", nargs="+", choices=("m4f", "m7"), default=["m4f", "m7"], help="default: both")
    command.add_argument("--precision", choices=("single", "double"), help="default: single on m4f, double on m7")
    command.add_argument("--function", nargs="+", metavar="NAME", help="default: dynamics and assembly; all: every one")
    command.add_argument("--out", metavar="FILE.json", help="also write the numbers here")
    text = "evidence for an assessor: MISRA C:2012 findings, loops, stack, vectors, branches; of the first core"
    command.add_argument("--report", metavar="FILE.md", help=text)
    command.add_argument("--json", action="store_true", help="numbers as JSON instead of the table")


def run(options: argparse.Namespace) -> int:
    """Measure, print, write."""
    from symscrew.display import Progress, fitting_table
    from symscrew.model import derive
    from symscrew.verification import measure

    path = destination(options.out, (".json",), "--out") if options.out else None
    report = destination(options.report, (".md",), "--report") if options.report else None
    progress = Progress()
    mechanism = find_mechanism(options.mechanism, acting=True)
    with progress.step(f"derive {mechanism.name}"):
        model = derive(mechanism)
    functions = options.function or [name for name in USUAL_FUNCTIONS if name in model.programs]
    functions = list(model.programs) if functions == ["all"] else functions
    if report is not None:
        return _report(model, functions, options, path=report)
    found = []
    for core in dict.fromkeys(options.core):
        precision = options.precision or ("single" if core == "m4f" else "double")
        with progress.step(f"compile for {core}, {precision} precision, and run on the emulator"):
            found.append(measure(model, core, precision, functions))
    text = json.dumps(found, indent=1) + "\n"
    if options.json:
        print(text, end="")
    else:
        header = ("core", "precision", "function", "flash [B]", "frame [B]", "stack [B]", "instructions", "error")
        rows = [
            [one["core"], one["precision"], name, *(str(entry[column]) for column in COLUMNS)]
            for one in found
            for name, entry in one["functions"].items()
        ]
        print(fitting_table(header, rows))
    if path is not None:
        write_text(path, text)
    return DONE


def _report(model: Model, functions: list[str], options: argparse.Namespace, *, path: Path) -> int:
    """Collect the evidence on one core, write it, say the verdict; exit code 1 where it is not ok."""
    from symscrew.display import Progress, print_text
    from symscrew.verification import collect

    progress, core = Progress(), options.core[0]
    precision = options.precision or ("single" if core == "m4f" else "double")
    with progress.step(f"collect evidence on {core}, {precision} precision"):
        evidence = collect(model, core, precision, functions)
    write_text(path, evidence.text)
    if options.out:
        write_text(destination(options.out, (".json",), "--out"), json.dumps(evidence.facts, indent=1) + "\n")
    if options.json:
        print(json.dumps({"ok": evidence.ok, "reasons": evidence.reasons, **evidence.facts}, indent=1))
    else:
        branches = evidence.facts["branches"]
        told = f"{branches['of']} branches, {branches['by_inputs']} taken by inputs, {branches['nothing']} by nothing"
        print_text(f"{path}: {'ok' if evidence.ok else 'not ok'}, {told}")
        for reason in evidence.reasons:
            print_text(f"  {reason}")
    return DONE if evidence.ok else FAILED
