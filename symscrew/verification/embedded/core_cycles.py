"""Cycles of functions on a Cortex-M4F: every instruction that the emulator executes, at the most that it can take.

    image --QEMU, one instruction at a time--> addresses --disassembly, table of the core--> sum per call

The table is that of Arm's Technical Reference Manual of the core (DDI 0439, 3.3.1 and 7.2.3), with its worst cases:
three cycles to refill the pipeline at every branch that is taken, no pair of loads put together, a result that the next
instruction of the floating-point unit waits for. Memory without wait states and no interrupts are presumed. Of the
Cortex-M7, which issues two instructions at a time, Arm publishes no such table.
"""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.export import PRECISIONS
from symscrew.model import Model
from symscrew.program import Iteration
from symscrew.verification.embedded import emulation
from symscrew.verification.embedded.branch_vectors import function_vectors
from symscrew.verification.embedded.emulation import CORES, EmbeddedError

LISTING = "arm-none-eabi-objdump"
TABLED = "m4f"  # the core whose cycles are published
REFILL = 3  # of the pipeline, at most
DIVISION, ROOT = 12, 14  # of whole numbers, and in the floating-point unit: tables 3-1 and 7-1
ENDLESS = (3, 4)  # statuses that an iteration gives after thousands of steps: those are counted, not traced
ORDINARY = 3  # states of every status
QUIET = ("paint", "painted_over", "put_hex", "put_word", "board_print")  # of the board, which write no lines of a trace
LINE = re.compile(r"^ +([0-9a-f]+):\t(?:[0-9a-f]{4} ?)+\t(\S+)(?:\t(.*))?$")
TRACED = re.compile(rb"\[[0-9a-f]+/([0-9a-f]+)/")


def worst_cycles(model: Model, core: str, precision: str, functions: Sequence[str]) -> dict[str, dict[str, int]]:
    """Per function the cycles of the dearest call, among states of every status; nothing for a core without a table.

    Of an iteration `cycles` is a bound: of the most steps that it can make, `step` each.

    Raises:
        EmbeddedError: a tool is missing or fails.
    """
    if core != TABLED:
        return {}
    model = replace(model, programs={name: model.programs[name] for name in functions})
    real, states = PRECISIONS[precision], {}
    for name in functions:
        states[name] = _states(model, name, precision)
    model = replace(model, test_inputs={**model.test_inputs, **states})
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        folder = Path(temporary)
        most = max(len(arrays[0]) for arrays in states.values() if arrays)
        emulation.build(model, CORES[core], real, folder, states=most)
        listing = emulation.called([LISTING, "-d", "image"], folder)
        addresses = _symbols(emulation.called([emulation.NAMES, "-S", "image"], folder))
        trace = _traced(CORES[core].board, folder, addresses)
        costs = _costs(listing)
        found = {}
        for name in functions:
            program = model.programs[name]
            cycles = _calls(trace, costs, addresses[f"{model.name}_{name}"])
            found[name] = {"cycles": max(cycles, default=0)}
            if isinstance(program, Iteration) and f"{model.name}_{name}_step" in addresses:
                step = max(_calls(trace, costs, addresses[f"{model.name}_{name}_step"]), default=0)
                steps = program.max_steps * (2 * program.max_substeps - 1) + 1
                found[name] = {"cycles": step * steps, "step": step, "steps": steps}
        return found


def _states(model: Model, name: str, precision: str) -> tuple[np.ndarray, ...]:
    """States of a function that give each of its statuses, without those that are not numbers."""
    own = [np.atleast_2d(x) for x in model.test_inputs[name]]
    vectors = [x.astype(float) for x in function_vectors(model, name, PRECISIONS[precision]).arrays]
    if not vectors:
        return tuple(own)
    good = np.all([(np.abs(x) < 1e6).all(axis=1) for x in vectors], axis=0)  # far above machines in SI units
    vectors = [x[good] for x in vectors]
    _, status = model(name, *vectors)
    chosen: list[int] = []
    for code in sorted(set(status.tolist()) - set(ENDLESS)):
        chosen += np.flatnonzero(status == code)[:ORDINARY].tolist()
    return tuple(x[chosen] for x in vectors)


def _symbols(names: str) -> dict[str, tuple[int, int]]:
    """Symbol -> its first address, and the first one behind it."""
    found = {}
    for row in (line.split() for line in names.splitlines()):
        if len(row) == 4 and row[2].lower() == "t":
            start = int(row[0], 16) & ~1
            found[row[3].split(".")[0]] = (start, start + int(row[1], 16))
    return found


def _traced(board: str, folder: Path, addresses: Mapping[str, tuple[int, int]]) -> np.ndarray:
    """Addresses of instructions in the order of their execution."""
    last, ranges = 0, list[str]()
    for start, end in sorted(addresses[name] for name in QUIET if name in addresses):
        ranges, last = [*ranges, *([f"{last:#x}..{start - 1:#x}"] if start > last else [])], end
    ranges.append(f"{last:#x}..0xffffff")
    command = [emulation.EMULATOR, "-M", board, "-nographic", "-monitor", "none", "-serial", "none", "-singlestep"]
    command += ["-d", "exec,nochain", "-D", "trace", "-dfilter", ",".join(ranges)]
    command += ["-semihosting-config", "enable=on,target=native", "-kernel", "image"]
    try:
        subprocess.run(command, cwd=folder, capture_output=True, check=True, timeout=emulation.TIMEOUT)
    except (OSError, subprocess.SubprocessError) as error:
        raise EmbeddedError(f"{emulation.EMULATOR} does not trace: {error}") from error
    return np.array([int(x, 16) for x in TRACED.findall((folder / "trace").read_bytes())], dtype=np.int64)


def _costs(listing: str) -> dict[int, tuple[int, int, int]]:
    """Address -> cycles where the next instruction follows, where it does not, and the length in bytes."""
    found = {}
    for line in listing.splitlines():
        match = LINE.match(line)
        if match:
            at, name, operands = int(match[1], 16), match[2], match[3] or ""
            length = 4 if re.search(r"\t[0-9a-f]{4} [0-9a-f]{4}", line) else 2
            cost = most(name, operands)
            found[at] = (cost, cost + REFILL, length)
    return found


def most(name: str, operands: str) -> int:
    """Cycles of an instruction, its branch apart.

    >>> most("ldr.w", "r0, [r1]"), most("push", "{r4, r5, lr}"), most("vdiv.f32", "s0, s1, s2"), most("adds", "r0, #1")
    (2, 4, 14, 1)
    """
    base = name.split(".")[0]
    listed = re.search(r"\{(.*)\}", operands)
    if listed:
        return 1 + sum(_registers(part) for part in listed[1].split(","))
    if base.startswith(("ldrd", "strd")) or (base.startswith(("vldr", "vstr")) and ".64" in name):
        return 3
    if base.startswith(("ldr", "str", "vldr", "vstr", "tb", "mrs", "msr")):
        return 2
    if base.startswith(("sdiv", "udiv")):
        return DIVISION
    if base.startswith(("vdiv", "vsqrt")):
        return ROOT
    if base.startswith(("vmla", "vmls", "vnml", "vfm", "vfnm")):
        return 4  # three, and one where the next instruction waits
    if base.startswith("v"):
        return 2
    return 2 if base.startswith(("ml", "mul", "sm", "um")) else 1


def _registers(part: str) -> int:
    """How many registers a part of a list names: `r4`, `s16-s19`."""
    ends = [int(x) for x in re.findall(r"\d+", part)]
    return ends[1] - ends[0] + 1 if "-" in part and len(ends) == 2 else 1


def _calls(trace: np.ndarray, costs: Mapping[int, tuple[int, int, int]], symbol: tuple[int, int]) -> list[int]:
    """Cycles of every call of a function, from its first instruction to the return."""
    entry, found = symbol[0], list[int]()
    begins = np.flatnonzero(trace == entry)
    for at in begins:
        if at == 0:
            continue
        caller = int(trace[at - 1])
        back = caller + costs.get(caller, (1, 4, 4))[2]
        ends = np.flatnonzero(trace[at : at + LONGEST] == back)
        if len(ends):
            found.append(_sum(trace[at : at + ends[0] + 1], costs))
    return found


LONGEST = 20_000_000  # instructions of a call that is looked for: the second path takes some hundred thousand


def _sum(steps: np.ndarray, costs: Mapping[int, Any]) -> int:
    """Cycles of instructions in this order; the last one only says where the one before went."""
    places, counts = np.unique(np.column_stack([steps[:-1], steps[1:]]), axis=0, return_counts=True)
    total = 0
    for (here, there), count in zip(places.tolist(), counts.tolist(), strict=True):
        follows, taken, length = costs.get(here, (REFILL, 2 * REFILL, 4))
        total += count * (follows if there == here + length else taken)
    return total
