"""Generated C on a microcontroller: cross-compiled, run on an emulator, measured and compared.

A program for the bare machine calls every function at its test states; QEMU runs it, counting instructions
(`-icount`: the board's timer advances by the same time with every one of them). Per function:

    flash          bytes of code and constants, without the mathematical library
    frame          bytes on the stack that the generated code can take: its frames along the deepest chain of calls,
                   second paths included, as the compiler states (-fcallgraph-info=su)
    stack          bytes of stack that the calls at the test states wrote, library included, by a painted stack
    instructions   executed by one call, library included: the largest of the states

These are instructions, not cycles: QEMU has no model of pipelines and caches.
"""

from __future__ import annotations

import re
import shutil
import struct
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.export import PRECISIONS, Precision, print_c, rounded
from symscrew.model import Model
from symscrew.runtime import CompileError

COMPILER, NAMES, EMULATOR = "arm-none-eabi-gcc", "arm-none-eabi-nm", "qemu-system-arm"
PACKAGES = {
    COMPILER: "gcc-arm-none-eabi and libnewlib-arm-none-eabi",
    NAMES: "binutils-arm-none-eabi",
    EMULATOR: "qemu-system-arm",
}
FLAGS = (
    "-std=c99",
    "-O2",
    "-fno-math-errno",
    "-ffp-contract=fast",
    "-mthumb",
    "-ffunction-sections",
    "-fdata-sections",
)
WARNINGS = ("-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wvla", "-Werror")
SHIFT = 6  # 2^6 ns of emulated time per instruction
TICK = 40  # ns of the boards' timer, less than an instruction takes: every single one is seen
BOARD = "board"  # the folder with start-up code, linker script and measuring, as it is included
STATES = 2  # test states per function: the reference configuration, and one near it
BUILD = 900  # [s] for one file of C, as of the compiler of this machine: longer, it hangs
TIMEOUT = 120  # [s]: the program of a mechanism ends after seconds; beyond it something does not end at all
SMALLEST = 1e-3  # what an output's error is divided by at least: of entries that ought to be 0, rounding is left


@dataclass(frozen=True)
class Core:
    """A processor core, how to compile for it, and the emulated board that has it."""

    name: str
    flags: tuple[str, ...]
    board: str


CORES = {
    "m4f": Core("Cortex-M4F", ("-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"), "mps2-an386"),
    "m7": Core("Cortex-M7", ("-mcpu=cortex-m7", "-mfpu=fpv5-d16", "-mfloat-abi=hard"), "mps2-an500"),
}


class EmbeddedError(CompileError):
    """A tool is missing, the compiler refused the code, or the program did not run to its end."""


def missing_tools() -> list[str]:
    """What is not installed, with the Debian package that has it."""
    return [f"{tool} (apt install {package})" for tool, package in PACKAGES.items() if shutil.which(tool) is None]


def measure(
    model: Model, core: str, precision: str = "single", functions: Sequence[str] | None = None
) -> Mapping[str, Any]:
    """Sizes, instructions and errors of functions on a core.

    Args:
        model: whose functions.
        core: a key of CORES.
        precision: "single" or "double".
        functions: by default all.

    Returns:
        What was used, and per function flash, frame, stack, instructions, and `error`: the largest difference
        from double on a computer over the largest entry of an output, at the same inputs.

    Raises:
        DescriptionError: no such core or function.
        EmbeddedError: see there.
    """
    if core not in CORES:
        raise DescriptionError(f"expected a core among {', '.join(CORES)}, got {core!r}")
    chosen = list(model.programs if functions is None else dict.fromkeys(functions))  # each of them once
    unknown = [name for name in chosen if name not in model.programs]
    if unknown:
        raise DescriptionError(f"{model.name} has no function {unknown[0]!r}; it has {', '.join(model.programs)}")
    missing = missing_tools()
    if missing:
        raise EmbeddedError(f"not found: {'; '.join(missing)}")
    model = replace(model, programs={name: model.programs[name] for name in chosen})
    real, target = PRECISIONS[precision], CORES[core]
    flash, frames, lines = _built_and_run(model, target, real)
    measured = _read(lines, chosen, model, real)
    found = {}
    for name in chosen:
        symbol = f"{model.name}_{name}"
        found[name] = {
            "flash": sum(n for s, n in flash.items() if _belongs(s, symbol, model)),
            "frame": frames[symbol],
            **measured[name],
        }
    version = called([COMPILER, "-dumpfullversion"], Path.cwd()).strip()
    return {
        "mechanism": model.name,
        "core": target.name,
        "precision": precision,
        "compiler": f"{COMPILER} {version} {' '.join((*FLAGS, *target.flags))}",
        "counted_by": f"{EMULATOR} -M {target.board} -icount shift={SHIFT}, by the system timer",
        "functions": found,
    }


def _built_and_run(model: Model, core: Core, real: Precision) -> tuple[dict[str, int], dict[str, int], list[str]]:
    """Bytes of flash per symbol, bytes of the frames per function, and what the program has printed."""
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        folder = Path(temporary)
        build(model, core, real, folder)
        lines = _run(core, folder)
        return _flash(folder, model.name), deepest_frames((folder / "model.ci").read_text()), lines


def build(model: Model, core: Core, real: Precision, folder: Path, *, states: int = STATES) -> None:
    """An image in a folder that calls every function at its first test states, up to `states` of them."""
    main = print_main(model, list(model.programs), real, states=states)
    files = {**print_c(model, precision=real, batches=False), "main.c": main}
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    (folder / BOARD).mkdir()  # a mechanism may be called like one of its files
    for file in resources.files(__package__).joinpath(BOARD).iterdir():
        (folder / BOARD / file.name).write_bytes(file.read_bytes())
    _compile(model, core, folder)


def _belongs(symbol: str, function: str, model: Model) -> bool:
    """Whether a symbol of the code is part of a function and not one of its own."""
    if symbol != function and not symbol.startswith(f"{function}_"):
        return False
    others = {f"{model.name}_{name}" for name in model.programs} - {function}
    return not any(
        other.startswith(function) and (symbol == other or symbol.startswith(f"{other}_")) for other in others
    )


def print_main(model: Model, functions: Sequence[str], real: Precision, *, states: int = STATES) -> str:
    """The program: calls at test states, their statuses, ticks of the timer, stack and results as hexadecimal bits."""
    lines = [f'#include "{model.name}.h"', f'#include "{BOARD}/measure.h"', ""]
    for f, name in enumerate(functions):
        program = model.programs[name]
        given_states = _states(model, name, real, states)
        for i, (port, rows) in enumerate(zip(program.inputs, given_states, strict=True)):
            if port.size:
                body = ", ".join("{" + ", ".join(real.number(x) for x in row) + "}" for row in rows)
                lines.append(f"static const {real.real} in{f}_{i}[{len(rows)}][{port.size}] = {{{body}}};")
        for i, port in enumerate(program.outputs):
            lines.append(f"static {real.real} out{f}_{i}[{max(port.size, 1)}];")
        given = [f"in{f}_{i}[state]" if p.size else "NULL" for i, p in enumerate(program.inputs)]
        given += [f"out{f}_{i}" for i, _ in enumerate(program.outputs)]
        lines += [
            f"static __attribute__((noinline)) void run{f}(int state)",
            "{",
            "    (void)state;",
            "    paint();",
            "    const uint32_t *const from = stack_here();",
            "    const uint32_t start = now();",
            f"    const int status = {model.name}_{name}({', '.join(given)});",
            "    const uint32_t ticks = (start - now()) & 0xFFFFFFu;",
            "    const uint32_t used = painted_over(from);",
            f'    board_print("{f}");',
            "    put_word((uint32_t)status);",
            "    put_word(ticks);",
            "    put_word(used);",
        ]
        for i, port in enumerate(program.outputs):
            lines += [
                f"    for (size_t k = 0; k < {port.size}; ++k) {{",
                f"        put_hex(&out{f}_{i}[k], sizeof(out{f}_{i}[k]));",
                "    }",
            ] * bool(port.size)
        lines += ['    board_print("\\n");', "}", ""]
    lines += ["int main(void)", "{", "    start_timer();"]
    for f, name in enumerate(functions):
        lines += [f"    run{f}({state});" for state in range(_count(model, name, states))]
    return "\n".join([*lines, "    return 0;", "}", ""])


def _count(model: Model, name: str, states: int = STATES) -> int:
    return min(states, *(len(np.atleast_2d(x)) for x in model.test_inputs[name]))


def _states(model: Model, name: str, real: Precision, states: int = STATES) -> list[np.ndarray]:
    count = _count(model, name, states)
    arrays = [np.atleast_2d(x)[:count] for x in model.test_inputs[name]]
    return [rounded(x) for x in arrays] if real.suffix else arrays


def _compile(model: Model, core: Core, folder: Path) -> None:
    common = [COMPILER, *FLAGS, *core.flags]
    called([*common, *WARNINGS, "-fcallgraph-info=su", "-c", f"{model.name}.c", "-o", "model.o"], folder)
    linked = [
        "-nostartfiles",
        "-Wl,--gc-sections",
        "-T",
        f"{BOARD}/mps2.ld",
        "main.c",
        f"{BOARD}/start.c",
        "model.o",
        "-lm",
        "-o",
        "image",
    ]
    called([*common, "-std=gnu99", *linked], folder)


def called(command: Sequence[str], folder: Path) -> str:
    """What a tool prints.

    Raises:
        EmbeddedError: it is not there, refuses, or does not end.
    """
    try:
        done = subprocess.run(
            command, cwd=folder, capture_output=True, encoding="utf-8", errors="replace", check=False, timeout=BUILD
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise EmbeddedError(f"{command[0]} does not run: {error}") from error
    if done.returncode:
        library = re.search(r"\w+\.h: No such file|cannot find -lm|cannot find -lc", done.stderr)
        cure = f" (apt install {PACKAGES[COMPILER]})" if library else ""
        raise EmbeddedError(f"{command[0]} refused{cure}: {done.stderr[-2000:]}")
    return done.stdout


def _run(core: Core, folder: Path) -> list[str]:
    command = [EMULATOR, "-M", core.board, "-nographic", "-monitor", "none", "-serial", "none"]
    command += ["-icount", f"shift={SHIFT}", "-semihosting-config", "enable=on,target=native", "-kernel", "image"]
    try:
        done = subprocess.run(
            command, cwd=folder, capture_output=True, encoding="utf-8", errors="replace", check=False, timeout=TIMEOUT
        )
    except subprocess.TimeoutExpired as error:
        raise EmbeddedError(f"{EMULATOR}: no end after {TIMEOUT} s") from error
    text = done.stdout + done.stderr
    if done.returncode or "fault" in text:
        raise EmbeddedError(f"{EMULATOR} ended with {done.returncode}: {text[-300:]}")
    return [line for line in text.splitlines() if re.match(r"\d+ [0-9a-f]{8} ", line)]


def _flash(folder: Path, model: str) -> dict[str, int]:
    """Bytes per symbol of the object file."""
    rows = [line.split() for line in called([NAMES, "-S", "model.o"], folder).splitlines()]
    sized = [row for row in rows if len(row) == 4 and row[2].lower() in "trd"]
    return {
        row[3].split(".")[0] if row[2].lower() == "t" else row[3]: int(row[1], 16) for row in sized if model in row[3]
    }


def deepest_frames(graph: str) -> dict[str, int]:
    """Bytes of stack of every function and of what it calls, from gcc's graph of calls; without other files' code."""
    own = {}
    for title, size, kind in re.findall(r'node: \{ title: "([^"]+)".*?\\n(\d+) bytes \(([^)]*)\)', graph):
        if "dynamic" in kind and "bounded" not in kind:
            raise EmbeddedError(f"{title}: expected a bounded stack, the compiler says {kind}")
        own[title] = int(size)
    called: dict[str, list[str]] = {title: [] for title in own}
    for source, target in re.findall(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', graph):
        if source in own and target in own:
            called[source].append(target)
    depth: dict[str, int] = {}
    waiting = dict(own)
    while waiting:
        ready = [title for title in waiting if all(other in depth for other in called[title])]
        if not ready:
            raise EmbeddedError(f"expected a bounded stack, but functions call themselves: {', '.join(waiting)}")
        for title in ready:
            depth[title] = waiting.pop(title) + max((depth[other] for other in called[title]), default=0)
    return {title.split(":")[-1]: size for title, size in depth.items()}


def _read(lines: Sequence[str], functions: Sequence[str], model: Model, real: Precision) -> dict[str, dict[str, Any]]:
    """Instructions, stack and errors per function from what the program has printed."""
    form = "!f" if real.suffix else "!d"
    found: dict[str, dict[str, Any]] = {}
    rows = [line.split() for line in lines]
    for f, name in enumerate(functions):
        own = [row for row in rows if row[0] == str(f)]
        if len(own) != _count(model, name):
            raise EmbeddedError(f"{name}: expected results of {_count(model, name)} states, got {len(own)}")
        expected, status = model(name, *_states(model, name, real))
        error = 0.0
        for k, row in enumerate(own):
            code = int(row[1], 16) - (int(row[1], 16) >> 31 << 32)
            if code != np.atleast_1d(status)[k]:
                raise EmbeddedError(f"{name}: status {code} at state {k}, expected {np.atleast_1d(status)[k]}")
            got = np.array([struct.unpack(form, bytes.fromhex(text))[0] for text in row[4:]])
            start = 0
            for array in expected:
                part = got[start : start + array.shape[-1]]
                start += array.shape[-1]
                largest = max(float(np.abs(array).max(initial=0.0)), SMALLEST)
                error = max(error, float(np.abs(array[k] - part).max(initial=0.0)) / largest)
        found[name] = {
            "stack": max(int(row[3], 16) for row in own),
            "instructions": max(round(int(row[2], 16) * TICK / 2**SHIFT) for row in own),
            "error": float(f"{error:.1e}"),
        }
    return found
