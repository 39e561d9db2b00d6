"""Instructions of generated functions beside those of lean C: figures that no other load of the machine changes.

    callgrind of so many calls, less that of none --> instructions a call;   the function's code --> arithmetic in it

Of the rows of `lean` that lie above 1.1. Both are compiled for Haswell, which valgrind knows, without fused products:
an arithmetic instruction is an operation, of one state or of four lanes. What ours has beside these is checks (pivots,
the length of quaternions, that all is finite), and entries put into lanes. Code by hand checks nothing, see `lean`.
"""

from __future__ import annotations

import re
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.export.c import print_c
from symscrew.model import Model, derive

from .lean import EIGHT, FLAGS, LANES, ROWS, SEED, SOURCES, Row
from .tables import table

CALLS = 200
COMPILED = ("-std=gnu11", "-O2", "-fno-math-errno", "-march=haswell", "-ffp-contract=off")
ABOVE = (  # mechanism and function of the rows above 1.1
    (SEED, "forward_dynamics"), (SEED, "velocity"), (SEED, "joint_reactions"),
    ("delta", "inverse_dynamics"), ("delta", "velocity"), ("delta", "forward_dynamics"),
)  # fmt: skip
ARITHMETIC = re.compile(r"\tv(add|sub|mul|div|sqrt|min|max)[sp]d")
MAIN = """#include <stdlib.h>
#include <stddef.h>
int {function}({types});
int main(int count, char **arguments)
{{
{arrays}
    int calls = count > 1 ? atoi(arguments[1]) : 0, status = 0;
    while (calls-- > 0) {{
        status |= {function}({names});
    }}
    return status;
}}
"""


def run(*, repeats: int = 1) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers; once is enough."""
    chosen = [row for row in ROWS if (row.mechanism, row.function) in ABOVE and row.lean and row.form != EIGHT]
    rows = [row for row in chosen if row.mechanism == SEED or (row.one_mode and row.form == LANES)]
    raw = []
    with tempfile.TemporaryDirectory(prefix="benchmark_") as name:
        folder = Path(name)
        here = Path(__file__).parent / "lean"
        (folder / "lean.c").write_text("".join(f'#include "{here / source}.c"\n' for source in SOURCES))
        lean = _compiled(folder / "lean.c", *FLAGS, f"-I{here}")
        for row in rows:
            model = derive(catalogue.load(row.mechanism), one_mode=row.one_mode).only([row.function])
            ours = _library(model, folder / str(len(raw)), row)
            raw.append({"row": row.name, "ours": _counts(model, row, ours, f"{row.mechanism}_{row.function}")}
                       | {"lean": _counts(model, row, lean, str(row.lean))})  # fmt: skip
    lines = []
    for row, found in zip(rows, raw, strict=True):
        (mine, own), (theirs, other) = found["ours"], found["lean"]
        ratio, rest = f"{mine / theirs:.2f}", f"{own / other:.2f}"
        lines.append(
            [row.model, row.function, row.form, *map(str, (mine, theirs)), ratio, *map(str, (own, other)), rest]
        )
    header = ["mechanism", "function", "form", "instructions", "by hand", "ratio", "arithmetic", "by hand", "ratio"]
    return table(header, lines), {"rows": raw}


def _library(model: Model, folder: Path, row: Row) -> Path:
    """Our function as an object file."""
    folder.mkdir()
    for file, text in print_c(model, lanes=row.form == LANES).items():
        (folder / file).write_text(text, encoding="utf-8")
    return _compiled(folder / f"{model.name}.c")


def _compiled(source: Path, *flags: str) -> Path:
    made = source.with_suffix(".o")
    subprocess.run(["gcc", *COMPILED, *flags, "-c", str(source), "-o", str(made)], check=True)
    return made


def _counts(model: Model, row: Row, code: Path, function: str) -> tuple[int, int]:
    """Instructions a call, and how many of those that are there do arithmetic."""
    program = model.programs[row.function]
    given = [np.atleast_2d(x)[0] for x in model.test_inputs[row.function]]
    arrays = [
        f"    static const double i{k}[] = {{{', '.join(repr(float(v)) for v in x)}}};" for k, x in enumerate(given)
    ]
    arrays += [f"    static double o{k}[{port.size}];" for k, port in enumerate(program.outputs)]
    names = [f"i{k}" for k in range(len(given))] + [f"o{k}" for k in range(len(program.outputs))]
    types = ["const double *"] * len(given) + ["double *"] * len(program.outputs)
    text = MAIN.format(function=function, types=", ".join(types), arrays="\n".join(arrays), names=", ".join(names))
    main = code.with_name("main.c")
    main.write_text(text, encoding="utf-8")
    tool = main.with_suffix("")
    subprocess.run(["gcc", "-O1", str(main), str(code), "-lm", "-lmvec", "-o", str(tool)], check=True)
    counts = []
    for calls in (0, CALLS):
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", str(tool), str(calls)]
        said = subprocess.run(command, capture_output=True, text=True, check=True).stderr
        counts.append(int(re.findall(r"Collected : (\d+)", said)[0]))
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", f"--disassemble={function}", str(code)],
                             capture_output=True, text=True, check=True).stdout  # fmt: skip
    return (counts[1] - counts[0]) // CALLS, len(ARITHMETIC.findall(listing))
