"""A JAX module of a model: one self-contained file, pure functions under `jit`, `vmap`, `grad` and `jvp`.

    u, status = inverse_dynamics(q, v, a)            arrays (*batch, size); named arguments; NaN where status is not 0

The file is the recorder and differentiator (`recorded`), the engine (`jax_engine`), and a listing per function, which
is called once to be recorded. Functions with a rank-revealing second path have only their first one: status 1 there.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from pathlib import Path

from symscrew.export.constants import Constants
from symscrew.export.folding import statements
from symscrew.export.listing import (
    banner,
    check_names,
    checked_slots,
    code_lines,
    decimal,
    first_path,
    function_lines,
    input_entries,
    live_instructions,
    wrapped,
)
from symscrew.export.numpy import TABLE as NUMPY
from symscrew.export.python_text import python_lines, python_writing
from symscrew.export.stages import Stages, headed
from symscrew.export.value_names import value_names
from symscrew.model import Model
from symscrew.program import NO_ROTATION, Iteration, Program

PARTS = ("recorded", "jax_engine")  # files of this folder that are printed, without what they import from each other
FUNCTIONS = ("sqrt", "exp", "sin", "cos", "tan", "atan2", "abs", "less", "select")
TABLE = {**NUMPY, **{f: f"op.{f}({', '.join(f'{{{k}}}' for k in range(NUMPY[f].count('{')))})" for f in FUNCTIONS}}
ABOUT = """
Each function takes arrays (*batch, size) by position or name and returns a named tuple: its outputs (*batch, size),
matrices column by column, and the status (*batch). Where the status is not 0, outputs are NaN, and so are their
derivatives, except where a cotangent is 0. Derivatives by coordinates are those of the formulas: along changes that
keep the loops closed they are those of the mechanism, as where q comes from assemble(y, guess). Needs JAX, 0.4.36 or
later, and nothing else; double precision is that of jax.config.update("jax_enable_x64", True).
"""


def print_jax(model: Model) -> dict[str, str]:
    """File name to text: `<name>_jax.py`."""
    check_names(model)
    lines = ['"""' + banner(model)[0], "", *banner(model)[1:], "", *ABOUT.strip("\n").splitlines(), '"""', ""]
    texts = [_part(name) for name in PARTS]
    imports = sorted({line for found, _ in texts for line in found}, key=_import_order)
    lines += [*imports, *(line for _, body in texts for line in ["", *body])]
    constants = Constants(model, python_writing(set[str]().union(*(_names(body) for _, body in texts))))
    functions: list[str] = []
    for name, program in model.programs.items():
        straight = first_path(program, "the JAX module")
        if isinstance(straight, Iteration):
            functions += ["", "", *_iteration(name, straight, constants)]
        else:
            functions += ["", "", *_function(name, straight, constants)]
    lines += ["", "", *constants.lines(), *functions]
    return {f"{model.name}_jax.py": "\n".join([*lines, ""])}


def _part(name: str) -> tuple[list[str], list[str]]:
    """The imports of a printed file, without those of this package, and what follows them."""
    text = Path(__file__).with_name(f"{name}.py").read_text(encoding="utf-8")
    nodes = [node for node in ast.parse(text).body if isinstance(node, ast.Import | ast.ImportFrom)]
    lines = text.splitlines()
    found = [lines[n.lineno - 1 : n.end_lineno] for n in nodes if "symscrew" not in (getattr(n, "module", "") or "")]
    return [" ".join(map(str.strip, statement)) for statement in found], lines[nodes[-1].end_lineno or 0 :]


def _names(lines: Sequence[str]) -> set[str]:
    """What a part of the module defines."""
    nodes = ast.parse("\n".join(lines)).body
    named = {name.id for n in nodes for name in ast.walk(n) if isinstance(name, ast.Name) and not n.col_offset}
    return named | {n.name for n in nodes if isinstance(n, ast.FunctionDef | ast.ClassDef)}


def _import_order(line: str) -> tuple[int, str]:
    group = 0 if "__future__" in line else 2 if "jax" in line or "numpy" in line else 1
    return group, line


def _function(name: str, program: Program, constants: Constants) -> list[str]:
    return [
        *_listing(name, program, constants),
        "",
        "",
        f"{name} = straight(",
        f'    "{name}",',
        *_step(name, program),
        *_text(function_lines(name, program)),
        ")",
    ]


def _iteration(name: str, iteration: Iteration, constants: Constants) -> list[str]:
    step = f"{name}_step"
    settings = {
        "independent": _several(list(map(str, iteration.independent))),
        "tolerance": decimal(iteration.tolerance),
        "steps": iteration.max_steps,
        "substeps": iteration.max_substeps,
        "refused": NO_ROTATION,
    }
    return [
        *_listing(step, iteration.step, constants),
        "",
        "",
        f"{name} = iterated(",
        f'    "{name}",',
        *_step(step, iteration.step),
        *_text(function_lines(name, iteration)),
        *(f"    {key}={value}," for key, value in settings.items()),
        ")",
    ]


def _listing(name: str, program: Program, constants: Constants) -> list[str]:
    """The function that is called once, to be recorded: results, then what is tested."""
    called = value_names(program, ("op", "entries", *constants.names.values()))

    def operand(value: int | float) -> str:
        return called[value] if isinstance(value, int) else constants.text(value)

    given = [operand(k) for k in range(len(input_entries(program)))]
    found = statements(program, live_instructions(program)[0], TABLE, operand)
    body = headed(((f"{called[k]} = {text}", k) for k, text in found), Stages(program), operand, "# {}")
    results = [slot for slots in program.results for slot in slots]
    tested = [*(slot for slot, _ in program.guards), *(slot for slot, *_ in program.limits)]
    total = " + ".join(operand(slot) for slot in checked_slots(program)) or "0.0"
    returned = ", ".join([*map(operand, [*results, *tested]), total])
    return [
        f"def _{name}(op, entries):",
        *(
            ["    (", *wrapped(", ".join(given) + ",", first=" " * 8, later=" " * 8), "    ) = entries"]
            if given
            else []
        ),
        *python_lines(body, " " * 4),
        *wrapped(f"return ({returned},)", first=" " * 4, later=" " * 8),
    ]


def _step(name: str, program: Program) -> list[str]:
    """The listing with its sizes and what decides its status."""
    sizes = [", ".join(f'"{port.name}": {port.size}' for port in ports) for ports in (program.inputs, program.outputs)]
    guards = _several([decimal(threshold) for _, threshold in program.guards])
    limits = _several([f"({_bound(low)}, {_bound(high)}, {code})" for _, low, high, code in program.limits])
    parts = [f"inputs={{{sizes[0]}}}", f"outputs={{{sizes[1]}}}"]
    parts += [f"{key}={text}" for key, text in (("guards", guards), ("limits", limits)) if text != "()"]
    return code_lines(f"Step(_{name}, {', '.join(parts)}),", first="    ")


def _several(terms: Sequence[str]) -> str:
    return "(" + ", ".join(terms) + ("," if len(terms) == 1 else "") + ")"


def _bound(value: float | None) -> str:
    return "None" if value is None else decimal(value)


def _text(lines: Sequence[str]) -> list[str]:
    return [f'    """{lines[0]}', *((f"    {line}").rstrip() for line in lines[1:]), '    """,']
