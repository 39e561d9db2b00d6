"""Is generated output what the tool generates today, does it compile, and do its targets agree?

`check` derives the model again from the directory's mechanism.toml and the effects in its manifest, and
compares bytes. Only what has just been generated is compiled, loaded and run, nothing found in the directory: .casadi
files, too, are compared by their bytes and never read.
"""

from __future__ import annotations

import dataclasses
import os
import re
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.errors import expect, shorten
from symscrew.export import (
    HASHES,
    PRECISIONS,
    FileHash,
    OutputError,
    file_hash,
    read_form,
    read_hashes,
    read_json,
    read_manifest,
)
from symscrew.generation import EMBEDDED, TARGETS, Case, Results, by_value, compare_values, render, with_brought
from symscrew.model import Model
from symscrew.runtime import CompileError, model_of
from symscrew.verification.embedded import CORES, measure, missing_tools
from symscrew.workers import pool

VECTORS = "test_vectors.json"
OTHER = 0.05  # share by which parameters are moved: enough for every digit, too little for a pivot to vanish
FIGURES = {"flash", "frame", "stack", "instructions"}  # of a measured function, in ops.json


NOT_LOOKED_AT = re.compile(r"no [^:]+ here\b|.*: not compared$")
"""How a target says that a tool is not here, or another one than that of a record."""


@dataclass(frozen=True)
class CheckResult:
    """`ok`, and a line per check: "<mechanism>: ok: ...", "... FAILED: ..." or "... skipped: ..."."""

    ok: bool
    lines: tuple[str, ...]

    def __repr__(self) -> str:
        failed = sum(": FAILED: " in line for line in self.lines)
        count = f"{failed} of {len(self.lines)}" if failed else str(len(self.lines))
        left_out = f", {len(self.skipped)} skipped" if self.skipped else ""
        return f"CheckResult({'ok' if self.ok else 'FAILED'}: {count} checks{left_out})"

    @property
    def skipped(self) -> tuple[str, ...]:
        """Lines of what was not looked at, because a tool for it is not here."""
        return tuple(line for line in self.lines if ": skipped: " in line)

    @property
    def verdict(self) -> str:
        """What is said at the end: that all passed only where all was looked at."""
        if not self.ok:
            return "FAILED"
        if self.skipped:
            return f"no check failed, but {len(self.skipped)} of {len(self.lines)} were skipped: a tool is missing"
        return "all checks passed"


def check(directory: str | Path) -> CheckResult:
    """Check one generated directory, or every one in a directory of such.

    A file that differs or does not compile, a rise of operations and a number that is off are lines of the result,
    not exceptions.

    Args:
        directory: what `generate` wrote, whole or with hashes only, or a directory of such folders.

    Raises:
        OutputError: there is nothing generated at this place, or a file that says what was generated cannot be read.
        DescriptionError: mechanism.toml describes no mechanism.
    """
    expect(directory, str, PathLike)
    root = Path(directory)
    if (root / "manifest.json").is_file():
        found = [root]
    elif root.is_dir():
        found = sorted(path.parent for path in root.glob("*/manifest.json"))
    else:
        found = []
    if not found:
        raise OutputError(f"{root}: expected generated output (a manifest.json), found none; generate first")
    if len(found) == 1:
        results = [_check_all(found[0])]
    else:  # a directory is mostly its compilers' time: as many at a time as there are cores
        with pool(min(len(found), os.cpu_count() or 1), "spawn") as processes:
            results = list(processes.map(_check_all, found))
    lines = [
        f"{path.name}: {'FAILED' if not passed else 'skipped' if NOT_LOOKED_AT.match(text) else 'ok'}: {text}"
        for path, result in zip(found, results, strict=True)
        for passed, text in result
    ]
    return CheckResult(all(passed for result in results for passed, _ in result), tuple(lines))


def _check_all(directory: Path) -> list[tuple[bool, str]]:
    return list(_check_one(directory))


def _check_one(directory: Path) -> Iterator[tuple[bool, str]]:
    """(passed, what) of every check of one directory."""
    content = read_manifest(directory)
    model = _regenerate(directory, content)
    targets = [t for t in TARGETS if t in content.get("targets", TARGETS)]
    precision = "single" if content.get("precision") == "single" else "double"
    measured, hashes = _measured(directory), read_hashes(directory)
    form = read_form(content)
    files = render(model, targets, precision=precision, measured=measured, form=form)
    yield from _compare_operations(directory, model)
    for record in measured:
        yield _compare_embedded(record, model, precision)
    yield from _compare_files(directory, files, hashes)
    expected = {name: model(name, *model.test_inputs[name]) for name in model.programs}
    if VECTORS not in hashes:
        yield from _compare_recorded(directory, model, expected)
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        fresh = Path(temporary) / "fresh"
        fresh.mkdir()
        for name, data in files.items():
            (fresh / name).write_bytes(data)
        other = _with_other_parameters(model)
        if other is not model:
            expected = {name: other(name, *other.test_inputs[name]) for name in other.programs}
        case = Case(other, expected, fresh, directory, PRECISIONS[precision], form)
        for target in sorted(with_brought(targets), key=_place):
            try:
                yield from TARGETS[target].compare(case)
            except CompileError as error:
                yield False, f"{target}: {shorten(str(error), 300)}"


def _with_other_parameters(model: Model) -> Model:
    """The model with run-time parameters that are not the declared ones at every second of its test states.

    Code that held the declared numbers in place of what it is given would agree at all states otherwise.
    """
    if not len(model.system.parameter_values):
        return model
    random = np.random.default_rng(len(model.system.parameter_values))
    inputs = dict(model.test_inputs)
    for name, program in model.programs.items():
        arrays = [np.array(x) for x in inputs[name]]
        for port, x in zip(program.inputs, arrays, strict=True):
            if port.name == "p":
                size = np.where(x[1::2] == 0.0, 1.0, np.abs(x[1::2]))
                x[1::2] += OTHER * size * random.uniform(0.5, 1.0, x[1::2].shape)
        inputs[name] = tuple(arrays)
    return dataclasses.replace(model, test_inputs=inputs)


def _place(target: str) -> int:
    """The place of a target in the report: right after what it brings along and builds on, else as in the table."""
    order = list(TARGETS)
    return min(order.index(name) for name in (target, *TARGETS[target].brings))


def _regenerate(directory: Path, content: Mapping[str, Any]) -> Model:
    """The model of a directory, with the recorded states as test inputs where they fit."""
    model = model_of(directory, content)
    recorded = {} if VECTORS in read_hashes(directory) else read_json(directory / VECTORS)
    inputs = dict(model.test_inputs)
    for name, program in model.programs.items():
        entry = recorded.get(name, {}) if isinstance(recorded, dict) else {}
        arrays = _arrays(entry.get("inputs"), [(p.name, p.size) for p in program.inputs])
        inputs[name] = arrays if arrays is not None else inputs[name]
    return dataclasses.replace(model, test_inputs=inputs)


def _arrays(entry: Any, ports: Sequence[tuple[str, int]], states: int = 1) -> tuple[np.ndarray, ...] | None:
    """Arrays (states, size) of a recorded entry, or None if it does not fit the ports; `states` if all are empty."""
    try:
        arrays = tuple(np.array(entry[name], dtype=float).reshape(-1, max(n, 1))[:, :n] for name, n in ports if n)
        return tuple(_with_empty(arrays, ports, states))
    except (KeyError, TypeError, ValueError, IndexError):
        return None


def _with_empty(arrays: Sequence[np.ndarray], ports: Sequence[tuple[str, int]], states: int) -> Iterator[np.ndarray]:
    """`arrays` in the order of the ports, with arrays (states, 0) for ports without entries."""
    states = len(arrays[0]) if arrays else states
    remaining = iter(arrays)
    for _, n in ports:
        yield next(remaining) if n else np.zeros((states, 0))


def _compare_operations(directory: Path, model: Model) -> Iterator[tuple[bool, str]]:
    recorded = read_json(directory / "ops.json")
    changed = []
    for name, program in model.programs.items():
        now, then = program.operations, recorded.get(name) if isinstance(recorded, dict) else None
        if now != then:
            before = then.get("total") if isinstance(then, dict) else None
            word = "rose" if isinstance(before, int) and now["total"] > before else "changed"
            changed.append(f"operations of {name} {word} from {before} to {now['total']}")
    total = sum(p.operations["total"] for p in model.programs.values())
    yield (False, "; ".join(changed)) if changed else (True, f"{total} operations as in ops.json")


def _measured(directory: Path) -> list[dict[str, Any]]:
    """What ops.json holds of microcontrollers, as far as it has the form of such a record."""
    recorded = read_json(directory / "ops.json")
    entries = recorded.get(EMBEDDED, []) if isinstance(recorded, dict) else []
    found = []
    for entry in entries if isinstance(entries, list) else []:
        sound = isinstance(entry, dict) and all(isinstance(entry.get(key), str) for key in ("core", "compiler"))
        functions = entry.get("functions") if sound else None
        figures = list(functions.values()) if isinstance(functions, dict) else [None]
        if not all(isinstance(figure, dict) and figure.keys() >= FIGURES for figure in figures):
            raise OutputError(f"{directory}/ops.json: {EMBEDDED!r} is no list of measurements; generate again")
        found.append(entry)
    return found


def _compare_embedded(record: Mapping[str, Any], model: Model, precision: str) -> tuple[bool, str]:
    """Flash, stack and instructions as recorded, where the compiler of the record is installed."""
    core = next((key for key, core in CORES.items() if core.name == record["core"]), None)
    missing = missing_tools()
    if core is None or missing:
        why = f"not found: {'; '.join(missing)}" if missing else f"expected {', '.join(c.name for c in CORES.values())}"
        return core is not None, f"{record['core']}: not measured again, {why}"
    functions = [name for name in record["functions"] if name in model.programs]
    now = measure(model, core, precision, functions)
    if now["compiler"] != record["compiler"]:
        return True, f"{record['core']}: recorded with {record['compiler']}, here is {now['compiler']}: not compared"
    for name in functions:
        for key in sorted(FIGURES):
            before, after = record["functions"][name][key], now["functions"][name][key]
            if before != after:
                return False, f"{record['core']}: {key} of {name} changed from {before} to {after}"
    return True, f"{record['core']}: flash, stack and instructions of {len(functions)} functions as in ops.json"


def _compare_files(
    directory: Path, files: Mapping[str, bytes], hashes: Mapping[str, FileHash]
) -> Iterator[tuple[bool, str]]:
    """Bytes of every file, or its hash; recorded values are compared by value."""
    same = 0
    for name, data in sorted(files.items()):
        path = directory / name
        if name in hashes and not path.exists():
            if hashes[name] == file_hash(data):
                same += 1
            else:
                yield False, f"{name} differs from what is generated today by its hash in {HASHES}; generate again"
        elif not path.is_file():
            if not by_value(name):
                yield False, f"{name} is missing; generate again"
        elif path.read_bytes() == data:
            same += 1
        elif by_value(name):
            yield (
                False,
                f"{name} has other bytes than this version of its library writes, and is not read; generate again",
            )
        elif name != VECTORS:
            yield False, f"{name} differs from what is generated today{_first_difference(path.read_bytes(), data)}"
    for name in sorted(set(hashes) - set(files)):
        yield False, f"{name} is in {HASHES}, but is not generated today; generate again"
    by_hash = f", {len(hashes)} of them by hash" if hashes else ""
    yield same > 0, f"{same} of {len(files)} files have the same bytes{by_hash}"


def _first_difference(found: bytes, expected: bytes) -> str:
    if b"\0" in expected:  # an archive: nothing to read
        return ""
    there = found.decode("utf-8", "replace").split("\n")
    here = expected.decode("utf-8", "replace").split("\n")
    for number, (a, b) in enumerate(zip(there, here, strict=False), 1):
        if a != b:
            return f", line {number}: found {a.strip()[:70]!r}, expected {b.strip()[:70]!r}"
    return f": found {len(there)} lines, expected {len(here)}"


def _compare_recorded(directory: Path, model: Model, expected: Mapping[str, Results]) -> Iterator[tuple[bool, str]]:
    """The outputs in test_vectors.json against today's."""
    recorded = read_json(directory / VECTORS)

    def results(name: str, inputs: Sequence[np.ndarray]) -> Results:
        entry = recorded[name]
        ports = [(p.name, p.size) for p in model.programs[name].outputs]
        arrays = _arrays(entry["outputs"], ports, len(np.ravel(entry["status"])))
        if arrays is None:
            raise ValueError(f"the outputs of {name} do not fit its ports")
        return arrays, np.array(entry["status"])

    try:
        yield compare_values("test_vectors.json", model, expected, results)
    except (KeyError, TypeError, ValueError) as error:
        yield False, f"test_vectors.json does not fit the functions ({error}); generate again"
