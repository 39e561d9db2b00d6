"""A NumPy module of a model: one self-contained file, a function per program, whole batches at once.

    (u,), status = inverse_dynamics(q, v, a)

Arrays have the shape (*batch, size), matrices column by column as in the C code; the statuses are the same.
"""

from __future__ import annotations

import inspect
from collections.abc import Sequence

from symscrew.export.constants import Constants
from symscrew.export.folding import statements
from symscrew.export.listing import (
    LINE,
    banner,
    check_names,
    checked_slots,
    decimal,
    function_lines,
    input_entries,
    live_instructions,
    wrapped,
)
from symscrew.export.pivots import SMALL, pivots_told
from symscrew.export.python_text import BEHIND, python_lines, python_writing
from symscrew.export.stages import Stages, headed
from symscrew.export.value_names import value_names
from symscrew.model import Model
from symscrew.program import NO_ROTATION, RANK, Iteration, Program, RankRevealing, second_path

TABLE = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "neg": "-{0}",
    "reciprocal": "1.0 / {0}",
    "div": "{0} / {1}",
    "sqrt": "np.sqrt({0})",
    "exp": "np.exp({0})",
    "sin": "np.sin({0})",
    "cos": "np.cos({0})",
    "tan": "np.tan({0})",
    "atan2": "np.arctan2({0}, {1})",
    "abs": "np.abs({0})",
    "less": "np.where({0} < {1}, 1.0, 0.0)",
    "select": "np.where({0} != 0.0, {1}, {2})",
}

RUNTIME = '''
def _real(argument):
    """An argument as an array of doubles; of complex numbers NumPy would take the real part."""
    array = np.asarray(argument)
    if array.dtype.kind == "c":
        raise TypeError(f"expected real numbers, got {array.dtype}; take x.real if its imaginary part is zero")
    return np.asarray(array, dtype=float)


def _entries(name, sizes, arguments):
    """Every entry of every argument as an array over the batch, and the shape of the batch."""
    if len(arguments) != len(sizes):
        raise TypeError(f"{name} expects {len(sizes)} arrays, got {len(arguments)}")
    entries, batch = [], ()
    for (port, size), argument in zip(sizes.items(), arguments):
        array = _real(argument)
        if array.shape[-1:] != (size,):
            raise ValueError(f"{name}: {port} has {size} entries in its last dimension, got {array.shape}")
        batch = np.broadcast_shapes(batch, array.shape[:-1])
        entries += [array[..., k] for k in range(size)]
    return entries, batch


def _finish(batch, outputs, guards, checked, limits=()):
    """Outputs as arrays (*batch, size), NaN where the status (*batch) is not 0."""
    results = []
    for columns in outputs:
        shape = (*batch, len(columns))
        result = np.empty(shape)
        for k, column in enumerate(columns):
            result[..., k] = column
        results.append(result)
    status = np.zeros(batch, dtype=int)
    for value, low, high, code in limits:
        within = (value >= (-np.inf if low is None else low)) & (value <= (np.inf if high is None else high))
        status = np.where((status == 0) & ~within, np.where(np.isfinite(value), code, 2), status)
    for value, threshold in guards:
        status = np.where((status == 0) & (np.abs(value) <= threshold), 1, status)
    status = np.where((status == 0) & ~np.isfinite(sum(checked)), 2, status)
    for result in results:
        result[status != 0] = np.nan
    return tuple(results), status


def _iterate(step, independent, tolerance, max_steps, max_substeps, y, guess, parameters):
    """Newton's iteration from `guess`, with more and more substeps from the guess to `y`."""
    if not all(np.isfinite(array).all() for array in (y, guess, *parameters)):
        return np.full_like(guess, np.nan), 2
    start = guess[independent]
    (_, _, _, branch), first = step(guess, start, *parameters)
    if first >= REFUSED:
        return np.full_like(guess, np.nan), int(first)
    substeps, outcome = 1, 3
    while substeps <= max_substeps:
        q = guess
        for k in range(1, substeps + 1):
            target = start + (y - start) * (k / substeps)
            outcome = 3
            for _ in range(max_steps):
                (following, residual, change, orientation), status = step(q, target, *parameters)
                if status:
                    break
                q = following
                if residual[0] < tolerance and change[0] < tolerance:
                    outcome = 0 if orientation[0] * branch[0] > 0.0 else 4
                    break
            if outcome:
                break
        if outcome == 0:
            return q, 0
        substeps *= 2
    return np.full_like(guess, np.nan), outcome


def _iterate_batch(arguments, *settings):
    """`_iterate` state by state."""
    arrays = [_real(argument) for argument in arguments]
    batch = np.broadcast_shapes(*(array.shape[:-1] for array in arrays))
    count = int(np.prod(batch))  # not -1: an array may have no entries
    rows = [np.broadcast_to(a, (*batch, a.shape[-1])).reshape(count, a.shape[-1]) for a in arrays]
    found = [_iterate(*settings, y, guess, parameters) for y, guess, *parameters in zip(*rows)]
    q = np.array([state for state, _ in found]).reshape(*batch, rows[1].shape[-1])
    return (q,), np.array([status for _, status in found], dtype=int).reshape(batch)
'''


TAKEN = ("second_path",)  # names of the module that could be one of a constant
SECOND_PATH = '''\
def _rank_revealing(first, dense, wrenches, arguments, *settings):
    """Results of `first`; where it fails by a small pivot, those of the second path."""
    results, status = first(*arguments)
    for state in map(tuple, np.argwhere(status == 1)):
        inputs = [np.broadcast_to(_real(x), (*status.shape, np.shape(x)[-1]))[state] for x in arguments]
        reactions = (lambda a, m, x=inputs: wrenches(*x, a, m)[0]) if wrenches else None
        found, status[state] = second_path(*dense(*inputs)[0], *settings, reactions)
        for result, value in zip(results, found):
            result[state] = value
    return results, status
'''


def print_numpy(model: Model) -> dict[str, str]:
    """File name to text: `<name>_numpy.py`."""
    check_names(model)
    constants = Constants(model, python_writing(TAKEN))
    functions = [line for name, program in model.programs.items() for line in _printed(name, program, constants)]
    lines = ['"""' + banner(model)[0], "", *banner(model)[1:], ""]
    lines += wrapped(
        "Each function takes arrays (*batch, size) and returns (outputs, status): a tuple of arrays "
        "(*batch, size), matrices column by column, and the status (*batch). Outputs are NaN where the "
        "status is not 0."
    )
    lines += [
        '"""',
        "",
        "from __future__ import annotations",
        "",
        "import numpy as np",
        "",
        *constants.lines(),
        "",
        *RUNTIME.replace("REFUSED", str(NO_ROTATION)).splitlines(),
    ]
    if any(isinstance(program, RankRevealing) for program in model.programs.values()):
        lines += ["", "", *SECOND_PATH.splitlines(), "", "", *_second_path_alone()]
    return {f"{model.name}_numpy.py": "\n".join([*lines, *functions, ""])}


def _printed(name: str, program: Program | Iteration, constants: Constants) -> list[str]:
    if isinstance(program, Iteration):
        return ["", "", *_iteration(name, program, constants)]
    if isinstance(program, RankRevealing):
        return ["", "", *_with_second_path(name, program, constants)]
    return ["", "", *_function(name, function_lines(name, program), program, constants)]


def _second_path_alone() -> list[str]:
    """The text of `second_path` itself, but for the star: `_rank_revealing` hands settings over in their order."""
    return [line for line in inspect.getsource(second_path).splitlines() if line != "    *,"]


def _function(name: str, about: Sequence[str], program: Program, constants: Constants) -> list[str]:
    called = value_names(program, constants.names.values())

    def operand(value: int | float) -> str:
        return called[value] if isinstance(value, int) else constants.text(value)

    def several(terms: Sequence[str]) -> str:
        return "(" + ", ".join(terms) + ("," if len(terms) == 1 else "") + ")"

    sizes = ", ".join(f'"{port.name}": {port.size}' for port in program.inputs)
    given = [operand(k) for k in range(len(input_entries(program)))]
    unpacked = wrapped(", ".join(given) + ",", first=" " * 8, later=" " * 8)
    pivots = [
        line
        for slot, limit, told in pivots_told(program)
        for line in _behind(f"    ({operand(slot)}, {decimal(limit)}),", told)
    ]
    guards = [f"guards = ({BEHIND}{SMALL}", *pivots, ")"] if pivots else ["guards = ()"]
    checked = several([operand(slot) for slot in checked_slots(program)])
    tested = [(operand(slot), _bound(low), _bound(high), code) for slot, low, high, code in program.limits]
    limits = f", {several([f'({slot}, {low}, {high}, {code})' for slot, low, high, code in tested])}" if tested else ""
    outputs = [several([operand(slot) for slot in slots]) for slots in program.results]
    found = statements(program, live_instructions(program)[0], TABLE, operand)
    body = headed(((f"{called[k]} = {text}", k) for k, text in found), Stages(program), operand, "# {}")
    return [
        f"def {name}(*arguments):",
        *_docstring(about),
        *wrapped(f'entries, batch = _entries("{name}", {{{sizes}}}, arguments)', first=" " * 4, later=" " * 8),
        *(["    (", *unpacked, "    ) = entries"] if given else []),
        '    with np.errstate(all="ignore"):',
        *python_lines(body, " " * 8),
        *(f"        {line}" for line in guards),
        *wrapped(
            f"return _finish(batch, {several(outputs)}, guards, {checked}{limits})", first=" " * 8, later=" " * 12
        ),
    ]


def _behind(code: str, told: str) -> list[str]:
    """A line, and what is said of it: behind it, or on further lines."""
    return wrapped(told, first=f"{code}{BEHIND}", later=f"    {BEHIND.strip()} ", width=LINE - 8)


def _bound(value: float | None) -> str:
    return "None" if value is None else decimal(value)


def _with_second_path(name: str, program: RankRevealing, constants: Constants) -> list[str]:
    """The first path, what the second one solves, and the function that chooses between them."""
    assert program.dense is not None
    parts = [("first", program), ("dense", program.dense), ("wrenches", program.wrenches)]
    lines = []
    for part, found in parts:
        if found is not None:
            lines += [*_function(f"_{name}_{part}", [f"The {part} path of {name}."], found, constants), "", ""]
    scales = ", ".join(f"({', '.join(map(constants.text, values))},)" for values in (program.rates, program.rows))
    called = [f"_{name}_{part}" if found is not None else "None" for part, found in parts]
    return [
        *lines,
        f"def {name}(*arguments):",
        *_docstring(function_lines(name, program)),
        *wrapped(f"settings = ({scales}, {program.regular}, {decimal(RANK)})", first=" " * 4, later=" " * 8),
        *wrapped(f"return _rank_revealing({', '.join(called)}, arguments, *settings)", first=" " * 4, later=" " * 8),
    ]


def _iteration(name: str, iteration: Iteration, constants: Constants) -> list[str]:
    step = _function(f"_{name}_step", ["One step of the iteration and its measures."], iteration.step, constants)
    independent = "[" + ", ".join(str(k) for k in iteration.independent) + "]"
    limits = f"{decimal(iteration.tolerance)}, {iteration.max_steps}, {iteration.max_substeps}"
    return [
        *step,
        "",
        "",
        f"def {name}(*arguments):",
        *_docstring(function_lines(name, iteration)),
        f"    return _iterate_batch(arguments, _{name}_step, {independent}, {limits})",
    ]


def _docstring(lines: Sequence[str]) -> list[str]:
    if len(lines) == 1:
        return [f'    """{lines[0]}"""']
    return [f'    """{lines[0]}', *((f"    {line}").rstrip() for line in lines[1:]), '    """']
