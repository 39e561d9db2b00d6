"""Target "st": function blocks of IEC 61131-3, which matiec translates and a C compiler runs here."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from symscrew.export import block_ports, print_structured_text
from symscrew.generation.rust_target import call
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import Results, compare_values
from symscrew.model import Model
from symscrew.runtime import find_compiler

LIMIT = 600  # seconds for matiec and the C compiler, which take some seconds for the longest blocks of the catalogue

# What matiec needs around blocks: a program in a task.
AROUND = """
PROGRAM symscrew_main
VAR
DECLARED
  symscrew_done : BOOL;
END_VAR
symscrew_done := TRUE;
END_PROGRAM
CONFIGURATION symscrew_configuration
  RESOURCE symscrew_resource ON PLC
    TASK symscrew_task(INTERVAL := T#1ms, PRIORITY := 0);
    PROGRAM symscrew_instance WITH symscrew_task : symscrew_main;
  END_RESOURCE
END_CONFIGURATION
"""
MAIN = """
#include <math.h>
#include <stdio.h>
#include "iec_std_lib.h"
#include "accessor.h"
#include "POUS.h"
#include "POUS.c"
TIME __CURRENT_TIME;
BOOL __DEBUG;

static double next(void)
{
    double value = 0.0;
    return fread(&value, sizeof value, 1, stdin) == 1 ? value : (double)NAN;
}

static void told(double value)
{
    fwrite(&value, sizeof value, 1, stdout);
}

int main(void)
{
CALLS
    return 0;
}
"""


def files(order: Order) -> Mapping[str, str]:
    """<name>.st."""
    return print_structured_text(order.model)


def compare(case: Case) -> Iterator[Finding]:
    """Values by matiec and a C compiler; there is no second path: where the others take it, the status is 1."""
    if shutil.which("iec2c") is None or find_compiler() is None:
        yield True, "no matiec (iec2c) here: structured text not run"
        return
    failed = build(case.model, case.fresh)
    if failed:
        yield False, failed
        return
    given = {name: case.model.test_inputs[name] for name in case.expected}
    found = call(case.model, case.fresh, given, np.dtype("<f8"))
    wanted: dict[str, Results] = {}
    for name, (arrays, status) in case.expected.items():
        second = np.asarray(status) < 0
        wanted[name] = tuple(np.where(second[:, None], np.nan, x) for x in arrays), np.where(second, 1, status)
    yield compare_values("structured text", case.model, wanted, lambda name, _: found[name])


def build(model: Model, directory: Path) -> str:
    """The file <name>.st in a folder as a program `main` that calls its blocks; "" or what matiec says."""
    declared = [f"  a_{name} : {model.name}_{name};" for name in model.programs]
    return translated(directory, f"{model.name}.st", declared, _calls(model))


def translated(directory: Path, file: str, declared: Sequence[str], calls: Sequence[str]) -> str:
    """A file in a folder, and a program of C around its blocks, as `main`; "" or what matiec and the compiler say."""
    translator = shutil.which("iec2c")
    assert translator is not None
    library = Path(translator).resolve().parent / "lib"
    text = (directory / file).read_text() + AROUND.replace("DECLARED", "\n".join(declared))
    (directory / "whole.st").write_text(text)
    (directory / "main.c").write_text(MAIN.replace("CALLS", "\n".join(calls)))
    compiler = [find_compiler() or "cc", "-O0", "-w", "-ffp-contract=off", f"-I{library / 'C'}", "main.c", "-o", "main"]
    for command in ([translator, "-I", str(library), "whole.st"], [*compiler, "-lm"]):
        try:
            done = subprocess.run(
                command, cwd=directory, capture_output=True, encoding="utf-8", errors="replace", check=False,
                timeout=LIMIT,
            )  # fmt: skip
        except (OSError, subprocess.TimeoutExpired) as error:
            return f"{command[0]} does not translate {file}: {error}"
        if done.returncode:
            return f"{Path(command[0]).name} on {file}: {done.stderr.strip()[:300]}"
    return ""


def _calls(model: Model) -> list[str]:
    """Each block at as many states as it is told first; results of states that fail are NaN."""
    lines = []
    for name, program in model.programs.items():
        given, made = block_ports(program)
        kind = f"{model.name}_{name}".upper()
        lines += ["    {", f"        static {kind} block;", "        const int count = (int)next();"]
        lines += [f"        {kind}_init__(&block, 0);", "        for (int state = 0; state < count; ++state) {"]
        for port, symbol in zip(program.inputs, given, strict=True):
            lines += [f"            for (int k = 0; k < {port.size}; ++k) {{"]
            lines += [f"                block.{symbol.upper()}.value.table[k] = next();", "            }"]
        lines += [f"            {kind}_body__(&block);"]
        for port, symbol in zip(program.outputs, made, strict=True):
            value = f"block.{symbol.upper()}.value.table[k]"
            lines += [f"            for (int k = 0; k < {port.size}; ++k) {{"]
            lines += [f"                told(block.VALID.value ? {value} : (double)NAN);", "            }"]
        lines += ["            told(block.STATUS.value);", "        }", "    }"]
    return lines
