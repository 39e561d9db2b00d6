"""`symscrew embedded NAME`: what functions cost on a microcontroller, as a table and as embedded.json."""

from __future__ import annotations

import argparse
import json

from symscrew.whole_files import destination, write_text

USUAL = (
    "inverse_dynamics",
    "inverse_dynamics_platform",
    "joint_reactions",
    "forward_dynamics",
    "forward_dynamics_independent",
    "assemble",
)
COLUMNS = ("flash", "frame", "stack", "instructions", "error")


def run(options: argparse.Namespace) -> int:
    """Measure, print, write."""
    from symscrew import catalogue
    from symscrew.display import Progress, table
    from symscrew.model import derive
    from symscrew.verification import measure

    path = destination(options.out, (".json",), "--out") if options.out else None
    progress = Progress()
    mechanism = catalogue.find(options.mechanism)
    with progress.step(f"derive {mechanism.name}"):
        model = derive(mechanism)
    functions = options.function or [name for name in USUAL if name in model.programs]
    functions = list(model.programs) if functions == ["all"] else functions
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
        print(table(header, rows))
    if path is not None:
        write_text(path, text)
    return 0
