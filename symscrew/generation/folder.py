"""A model as files: those of every target, and what a user or `check` needs beside them.

    targets (`symscrew.generation.targets`)  --files-->  <name>.h  <name>_*.c  <name>_numpy.py  *.casadi  ...
    beside them          README.md  manifest.json  ops.json  test_vectors.json  mechanism.toml
    with hashes only     *.h  manifest.json  ops.json  mechanism.toml  hashes.json in place of the others

Equal input gives equal bytes. All files are replaced at once (`symscrew.whole_files`), and none that the tool did not
write.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.description import to_toml
from symscrew.errors import expect
from symscrew.export import (
    HASHES,
    MANIFEST,
    PRECISIONS,
    USUAL_FORM,
    Form,
    OutputError,
    manifest,
    own_files,
    print_hashes,
    print_readme,
    read_hashes,
    read_manifest,
)
from symscrew.garbage import nothing_to_collect
from symscrew.generation.target_file import Order
from symscrew.generation.targets import TARGETS, USUAL, apart, by_value, printable, with_brought
from symscrew.model import Model
from symscrew.program import Iteration
from symscrew.runtime import remember_folder
from symscrew.whole_files import PENDING, is_staging, one_at_a_time, put_files
from symscrew.workers import beside

EMBEDDED = "embedded"  # among the functions of ops.json: what microcontrollers were measured to take
# Instructions of all functions whose values at the test states are computed by a process of their own: copying this one
# takes as long as computing so many.
EVALUATED_BESIDE = 5000
READ = (".h", "ops.json", "manifest.json", "mechanism.toml")  # endings of what stays beside hashes.json


def generate(
    model: Model,
    out_dir: str | Path,
    targets: Sequence[str] = USUAL,
    *,
    precision: str = "double",
    measured: Sequence[Mapping[str, Any]] = (),
    hashes_only: bool = False,
    form: Form = USUAL_FORM,
    processes: int = 1,
) -> tuple[Path, ...]:
    """Write the files of a model into `out_dir` and return their paths, sorted.

    Args:
        model: what to print.
        out_dir: a directory that does not exist, is empty, or holds earlier output of this tool.
        targets: any of TARGETS; "external" brings "c" with it.
        precision: "double", or "single" for C of type float; the other targets are double only.
        measured: results of `symscrew.verification.embedded.emulation.measure`, which stand in the C header and in
            ops.json then.
        hashes_only: write what a reader learns from, and of the rest hashes.json with its hashes: enough for
            `check`, at most a tenth of the size, and no code that could be called.
        form: of the C, in one file or in several, with functions of many states or without.
        processes: how many may print; two take two thirds of the time of one where there are as many processors.

    Raises:
        OutputError: the directory holds something else; nothing has been written then.
        DescriptionError: a format cannot hold the mechanism; nothing has been written then.
    """
    expect(model, Model)
    check_place(out_dir)
    files = render(model, targets, precision=precision, measured=measured, form=form, processes=processes)
    return write_folder(with_hashes(files) if hashes_only else files, out_dir)


def check_place(out_dir: str | Path) -> None:
    """Whether a folder can be written anew; waits for whoever writes there.

    Raises:
        OutputError: it holds something that this tool did not write.
    """
    directory = Path(os.path.abspath(out_dir))
    with one_at_a_time(directory.parent):  # whoever writes there has an end
        _earlier_files(directory)


def write_folder(files: Mapping[str, bytes], out_dir: str | Path) -> tuple[Path, ...]:
    """Write the files of `render` as a folder and return their paths, sorted.

    Raises:
        OutputError: the folder holds something else, or cannot be written; nothing has been written then.
    """
    directory = Path(os.path.abspath(out_dir))

    def check() -> None:
        earlier = _earlier_files(directory)
        foreign = sorted(f for f in files if f not in earlier and (directory / f).exists())
        if foreign:
            text = f"{directory}: {foreign[0]} was not written by this tool; move it or use another directory"
            raise OutputError(text)

    try:
        put_files(directory, files, last=MANIFEST, owned=own_files, check=check)
    except OSError as error:
        what = error.strerror or error
        raise OutputError(f"{directory}: cannot be written ({what}); nothing was, use another place") from error
    remember_folder(files)
    return tuple(directory / file for file in sorted(files))


@nothing_to_collect()
def render(
    model: Model,
    targets: Sequence[str] = USUAL,
    *,
    precision: str = "double",
    measured: Sequence[Mapping[str, Any]] = (),
    form: Form = USUAL_FORM,
    processes: int = 1,
) -> dict[str, bytes]:
    """File name to content of everything that `generate` writes, without hashes.json.

    Raises:
        ValueError: an unknown target or precision, or a target that the precision cannot have.
        OutputError: two targets that no folder holds together.
    """
    chosen = with_brought(targets)
    if precision not in PRECISIONS:
        raise ValueError(f"expected the precision {' or '.join(PRECISIONS)}, got {precision!r}")
    possible = printable(precision)
    for target in targets:
        if target not in possible:
            raise ValueError(f"expected targets among {', '.join(possible)} in {precision} precision, got {target!r}")
    if both := apart(targets):
        raise OutputError(both)
    order = Order(model, PRECISIONS[precision], measured, form, processes)
    with _vectors(model, processes) as vectors:
        made = _made(order, chosen)
        made["test_vectors.json"] = vectors()
    content = manifest(model, targets=chosen, files=[*made, "manifest.json"], precision=precision, form=form)
    made["manifest.json"] = json.dumps(content, indent=1, ensure_ascii=False) + "\n"
    return {name: data.encode("utf-8") if isinstance(data, str) else data for name, data in made.items()}


def _made(order: Order, chosen: Sequence[str]) -> dict[str, str | bytes]:
    """The files of all targets, and of what stands beside them those that are read."""
    model, measured = order.model, order.measured
    made: dict[str, str | bytes] = {}
    writer: dict[str, str] = {}
    further: list[str] = []
    for target in chosen:
        files = TARGETS[target].files(order)
        both = sorted(file for file in files if made.get(file, files[file]) != files[file])
        if both:
            first = writer[both[0]]
            raise OutputError(f"targets {first} and {target} both write {both[0]}; use a directory for each")
        made |= files
        writer |= dict.fromkeys(files, target)
        further += TARGETS[target].section(order)
    about = {target: TARGETS[target].about for target in chosen}
    counts: dict[str, Any] = {name: p.operations for name, p in model.programs.items()}
    made |= {
        "README.md": print_readme(model, about, order.precision, further, files=_sizes(made)),
        "ops.json": _table_text(counts | ({EMBEDDED: list(measured)} if measured else {})),
        "mechanism.toml": to_toml(model.mechanism),
    }
    return made


def _vectors(model: Model, processes: int) -> AbstractContextManager[Callable[[], str]]:
    """What gives the text of test_vectors.json; with several processes it is made beside what is done meanwhile."""
    programs = [p.step if isinstance(p, Iteration) else p for p in model.programs.values()]
    if processes > 1 and sum(len(p.instructions) for p in programs) > EVALUATED_BESIDE:
        return beside(lambda: _vectors_text(model))
    return nullcontext(lambda: _vectors_text(model))


def with_hashes(files: Mapping[str, bytes]) -> dict[str, bytes]:
    """Of the files of a folder those that are read, and hashes.json of the others.

    Files whose bytes depend on the version of a library are left out altogether: a hash of them says nothing.
    """
    kept = {name: data for name, data in files.items() if name.endswith(READ) and not name.endswith("_support.h")}
    others = {name: data for name, data in files.items() if name not in kept and not by_value(name)}
    return kept | {HASHES: print_hashes(others).encode("utf-8")}


def _sizes(files: Mapping[str, str | bytes]) -> dict[str, int]:
    """Bytes of every file."""
    return {name: len(data.encode("utf-8") if isinstance(data, str) else data) for name, data in files.items()}


def _table_text(table: Mapping[str, Any]) -> str:
    """JSON with one line per entry."""
    rows = [f" {json.dumps(key)}: {json.dumps(value)}" for key, value in table.items()]
    return "{\n" + ",\n".join(rows) + "\n}\n"


def _vectors_text(model: Model) -> str:
    """Inputs, outputs and status of every function at the test states; NaN as null."""
    blocks = []
    for name, program in model.programs.items():
        results, status = model(name, *model.test_inputs[name])
        inputs = {p.name: _rows(x) for p, x in zip(program.inputs, model.test_inputs[name], strict=True)}
        outputs = {p.name: _rows(x) for p, x in zip(program.outputs, results, strict=True)}
        entry = {"inputs": inputs, "outputs": outputs, "status": np.atleast_1d(status).tolist()}
        rows = [f"  {json.dumps(k)}: {json.dumps(v, separators=(',', ':'))}" for k, v in entry.items()]
        blocks.append(f" {json.dumps(name)}: {{\n" + ",\n".join(rows) + "\n }")
    return "{\n" + ",\n".join(blocks) + "\n}\n"


def _rows(array: np.ndarray) -> list[list[float | None]]:
    rows = np.atleast_2d(np.asarray(array, dtype=float)).tolist()
    return [[x if math.isfinite(x) else None for x in row] for row in rows]


def _earlier_files(directory: Path) -> set[str]:
    """Files in `directory` that this tool wrote.

    Raises:
        OutputError: it is no directory, or holds files but no manifest of this tool.
    """
    if not directory.exists() and not directory.is_symlink():
        return set()
    if not directory.is_dir():
        raise OutputError(f"{directory}: expected a directory, found a file; use another place")
    names = {path.name for path in directory.iterdir() if not is_staging(path.name)}
    if not names:
        return set()
    if not names & {MANIFEST, PENDING}:
        raise OutputError(f"{directory}: holds files that this tool did not write; use an empty directory")
    try:
        read_manifest(directory)
        read_hashes(directory)
    except OutputError as error:  # which says to generate again: that is what this is
        reason = str(error).rpartition(";")[0] or str(error)
        raise OutputError(f"{reason}; remove the directory, or use another one") from error
    return own_files(directory)
