"""A model as files: C, CasADi, NumPy, and what a user or `check` needs beside them.

    <name>.h  <name>.c  <name>.hpp  example.c  CMakeLists.txt       target "c"
    <function>.casadi                                               target "casadi"
    <name>_numpy.py                                                 target "numpy"
    <name>_external.c  <name>_jacobians.h  <name>_jacobians.c       target "external", with those of "c"
    <name>.js                                                       target "javascript"
    <name>.fmu                                                      target "fmu", FMI 3.0 without binaries
    <name>.xml                                                      target "mjcf"
    <name>.urdf                                                     target "urdf", open chains only
    model.md                                                        target "markdown"
    README.md  manifest.json  ops.json  test_vectors.json  mechanism.toml

Equal input gives equal bytes. Everything is written to a folder of its own first and moved into place at the
end, and no file is replaced that the tool did not write.
"""

from __future__ import annotations

import json
import math
import os
import re
import secrets
import shutil
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.description import to_toml
from symscrew.export import (
    DOUBLE,
    PRECISIONS,
    OutputError,
    manifest,
    print_c,
    print_cmake,
    print_cpp,
    print_example,
    print_external,
    print_javascript,
    print_markdown,
    print_numpy,
    print_readme,
    read_manifest,
)
from symscrew.fmu import archive, at_rest, readme_section, unit_contents
from symscrew.formats import text_of
from symscrew.generation.targets import SINGLE_TARGETS, TARGETS, USUAL
from symscrew.model import Model
from symscrew.program import Iteration, Program

EMBEDDED = "embedded"  # among the functions of ops.json: what microcontrollers were measured to take
FORMATS = {"mjcf": ".xml", "urdf": ".urdf"}
_PLAIN_FILE = re.compile(r"[A-Za-z][A-Za-z0-9_]*(\.[A-Za-z0-9_]+)+", re.ASCII)


def generate(
    model: Model,
    out_dir: str | Path,
    targets: Sequence[str] = USUAL,
    *,
    precision: str = "double",
    measured: Sequence[Mapping[str, Any]] = (),
) -> tuple[Path, ...]:
    """Write the files of a model into `out_dir` and return their paths, sorted.

    Args:
        model: what to print.
        out_dir: a directory that does not exist, is empty, or holds earlier output of this tool.
        targets: any of TARGETS; "external" brings "c" with it.
        precision: "double", or "single" for C of type float; the other targets are double only.
        measured: results of `symscrew.verification.embedded.emulation.measure`, which stand in the C header and in
            ops.json then.

    Raises:
        OutputError: the directory holds something else; nothing has been written then.
        DescriptionError: a format cannot hold the mechanism; nothing has been written then.
    """
    directory = Path(os.path.abspath(out_dir))
    earlier = _earlier_files(directory)
    files = render(model, targets, precision=precision, measured=measured)
    foreign = sorted(f for f in files if f not in earlier and (directory / f).exists())
    if foreign:
        raise OutputError(f"{directory}: {foreign[0]} was not written by this tool; move it or use another directory")
    _write(directory, files, stale=earlier - set(files))
    return tuple(directory / file for file in sorted(files))


def render(
    model: Model,
    targets: Sequence[str] = USUAL,
    *,
    precision: str = "double",
    measured: Sequence[Mapping[str, Any]] = (),
) -> dict[str, bytes]:
    """File name to content of everything that `generate` writes."""
    unknown = [target for target in targets if target not in TARGETS]
    if unknown:
        raise ValueError(f"expected targets among {', '.join(TARGETS)}, got {unknown[0]!r}")
    if precision not in PRECISIONS:
        raise ValueError(f"expected the precision {' or '.join(PRECISIONS)}, got {precision!r}")
    real = PRECISIONS[precision]
    doubles = [target for target in targets if target not in SINGLE_TARGETS]
    if real is not DOUBLE and doubles:
        raise ValueError(f"expected targets among {', '.join(SINGLE_TARGETS)} in single precision, got {doubles[0]!r}")
    targets = [*targets, "c"] if "external" in targets else targets
    chosen = [target for target in TARGETS if target in targets]
    texts: dict[str, str] = {}
    files: dict[str, bytes] = {}
    if "c" in targets:
        texts |= print_c(_noted(model, measured), precision=real) | print_cpp(model, real)
        texts |= {"example.c": print_example(model, real), "CMakeLists.txt": print_cmake(model)}
    if "numpy" in targets:
        texts |= print_numpy(model)
    if "casadi" in targets:
        files |= _casadi_files(model)
    if "external" in targets:
        texts |= print_external(model)
    if "javascript" in targets:
        texts |= print_javascript(model)
    if "fmu" in targets:
        files[f"{model.name}.fmu"] = archive(unit_contents(at_rest(model.mechanism, model.effects)))
    for target, suffix in FORMATS.items():
        if target in targets:
            texts[f"{model.name}{suffix}"] = text_of(model.mechanism, suffix)
    if "markdown" in targets:
        texts |= print_markdown(model)
    section = readme_section(model.name, model.system.tree.q[0].label) if "fmu" in targets else []
    texts["README.md"] = print_readme(model, chosen, real, section)
    counts: dict[str, Any] = {name: p.operations for name, p in model.programs.items()}
    texts["ops.json"] = _table_text(counts | ({EMBEDDED: list(measured)} if measured else {}))
    texts["test_vectors.json"] = _vectors_text(model)
    texts["mechanism.toml"] = to_toml(model.mechanism)
    files |= {name: text.encode("utf-8") for name, text in texts.items()}
    content = manifest(model, targets=chosen, files=[*files, "manifest.json"], precision=precision)
    files["manifest.json"] = (json.dumps(content, indent=1, ensure_ascii=False) + "\n").encode("utf-8")
    return files


def _noted(model: Model, measured: Sequence[Mapping[str, Any]]) -> Model:
    """The model with what its functions cost on microcontrollers among their notes."""
    programs: dict[str, Program | Iteration] = dict(model.programs)
    for found in measured:
        where = f"{found['core']}, {' '.join(found['compiler'].split()[:2])} -O2"
        for name, entry in found["functions"].items():
            if name in programs:
                stack = f"{entry['stack']} of stack (own frames at most {entry['frame']})"
                size = f"{entry['flash']} bytes of flash, {stack}"
                note = f"{where}: {size}, {entry['instructions']} instructions"
                programs[name] = replace(programs[name], notes=(*programs[name].notes, note))
    return replace(model, programs=programs)


def _casadi_files(model: Model) -> dict[str, bytes]:
    from symscrew.export import casadi_functions

    files = {}
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        for name, function in casadi_functions(model).items():
            path = Path(temporary) / f"{name}.casadi"
            function.save(str(path))
            files[path.name] = path.read_bytes()
    return files


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
    if not any(directory.iterdir()):
        return set()
    if not (directory / "manifest.json").is_file():
        raise OutputError(f"{directory}: holds files that this tool did not write; use an empty directory")
    try:
        listed = read_manifest(directory).get("files", [])
    except OutputError as error:  # which says to generate again: that is what this is
        reason = str(error).rpartition(";")[0] or str(error)
        raise OutputError(f"{reason}; remove the directory, or use another one") from error
    return {f for f in listed if isinstance(f, str) and _PLAIN_FILE.fullmatch(f)} | {"manifest.json"}


def _write(directory: Path, files: Mapping[str, bytes], *, stale: set[str]) -> None:
    """Write in `directory` or, if there is none, beside its place, then move into place; the manifest goes last."""
    staging = (directory if directory.is_dir() else directory.parent) / f".{directory.name}.{secrets.token_hex(6)}"
    try:
        directory.parent.mkdir(parents=True, exist_ok=True)
        staging.mkdir()
        for name, content in files.items():
            (staging / name).write_bytes(content)
    except OSError as error:
        shutil.rmtree(staging, ignore_errors=True)
        what = error.strerror or error
        raise OutputError(f"{directory}: cannot be written ({what}); nothing was, use another place") from error
    try:
        if directory.exists():
            for name in sorted(files, key=lambda name: (name == "manifest.json", name)):
                os.replace(staging / name, directory / name)
            for name in sorted(stale):
                (directory / name).unlink(missing_ok=True)
        else:
            os.replace(staging, directory)
    finally:
        shutil.rmtree(staging, ignore_errors=True)  # our own staging directory
