"""Target "modelica": a package with external functions around the target "c", which OpenModelica takes where it is."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from symscrew.export import library_sources, print_modelica
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.model import Model
from symscrew.runtime import find_compiler

LIMIT = 300  # seconds of OpenModelica's compiler: it reads a package in one


def files(order: Order) -> Mapping[str, str]:
    """<name>.mo."""
    return print_modelica(order.model)


def section(order: Order) -> Sequence[str]:
    """How the library that tools link is made."""
    name = order.model.name
    return [
        "### Modelica",
        "",
        "The library that the package links, in this folder:",
        "",
        "```sh",
        f"cc -O2 -fPIC -shared {name}*.c -o lib{name}.so -lm",
        "```",
        "",
        f"Then open `{name}.mo`: `{name}.<function>` is a function, `{name}.<function>_block` a block.",
    ]


def compare(case: Case) -> Iterator[Finding]:
    """That OpenModelica's compiler checks the package, and what a function gives there at a state."""
    omc = shutil.which("omc")
    if omc is None or find_compiler() is None:
        yield True, "no OpenModelica (omc) here: the Modelica package was not run"
        return
    yield _checked(omc, case)


def _checked(omc: str, case: Case) -> Finding:
    model, folder = case.model, case.fresh
    function = next(name for name, (_, status) in case.expected.items() if status.ravel()[0] == 0)
    given = ", ".join(_array(array[0]) for array in case.model.test_inputs[function])
    script = [f'loadFile("{name}.mo");' for name in (model.name,)]
    script += [f"checkModel({model.name}.{name}_block);" for name in model.programs]
    script += [f"{model.name}.{function}({given});", "getErrorString();"]
    (folder / "script.mos").write_text("\n".join(script), encoding="utf-8")
    failed = library(model, folder)
    if failed:
        return False, failed
    try:
        done = subprocess.run(
            [omc, "script.mos"], cwd=folder, capture_output=True, encoding="utf-8", errors="replace", check=False,
            timeout=LIMIT,
        )  # fmt: skip
    except (OSError, subprocess.TimeoutExpired) as error:
        return False, f"omc does not run: {error}"
    good = done.returncode == 0 and "Error" not in done.stdout
    return good, f"OpenModelica: {done.stdout.strip()[-200:]}" if not good else "OpenModelica takes the package"


def _array(values: Sequence[float]) -> str:
    return "{" + ", ".join(repr(float(x)) for x in values) + "}" if len(values) else "fill(0.0, 0)"


def library(model: Model, folder: Path) -> str:
    """lib<name>.so of the C in a folder; "" or what the compiler says."""
    sources = library_sources((path.name for path in folder.iterdir()), model.name)
    command = [find_compiler() or "cc", "-O0", "-fPIC", "-shared", *sources, "-o", f"lib{model.name}.so", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", check=False, timeout=LIMIT)
    return done.stderr[:500] if done.returncode else ""
