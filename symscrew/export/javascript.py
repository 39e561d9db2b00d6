"""JavaScript of a model: one script without dependencies, for a page or for Node, a function per program.

    const { status, v } = four_bar.velocity(q, y_dot);

Arguments are arrays of numbers, results are Float64Arrays, matrices column by column as in the C code; the
statuses are the same, and results are NaN where the status is not 0. Rank-revealing second paths are not printed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from symscrew.export.constants import Constants, Writing
from symscrew.export.folding import statements
from symscrew.export.listing import (
    balanced_sum,
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
from symscrew.export.pivots import SMALL, pivots_told
from symscrew.export.stages import Stages, headed
from symscrew.export.value_names import value_names
from symscrew.model import Model
from symscrew.program import NO_ROTATION, Iteration, Program

TABLE = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "neg": "-{0}",
    "reciprocal": "1.0 / {0}",
    "div": "{0} / {1}",
    "sqrt": "Math.sqrt({0})",
    "exp": "Math.exp({0})",
    "sin": "Math.sin({0})",
    "cos": "Math.cos({0})",
    "tan": "Math.tan({0})",
    "atan2": "Math.atan2({0}, {1})",
    "abs": "Math.abs({0})",
    "less": "({0} < {1} ? 1.0 : 0.0)",
    "select": "({0} !== 0.0 ? {1} : {2})",
}

WRITING = Writing(decimal, "  {name} = {number}{end} ", ("/* ", "   ", " */"), "const")
WORDS = "arguments debugger eval function implements in instanceof interface let module null package super undefined"
OBJECTS = "Array Float64Array Infinity Math NaN Number Object TypeError exports isFinite require"
RESERVED = frozenset(f"{WORDS} {OBJECTS} var with document globalThis self top window".split())

RUNTIME = """
  /* The arrays of a call, after a check of how many there are and how long they are. */
  function check(name, sizes, given) {
    const ports = Object.keys(sizes);
    if (given.length !== ports.length) {
      throw new TypeError(`${name} expects ${ports.length} arrays (${ports.join(", ")}), got ${given.length}`);
    }
    ports.forEach((port, k) => {
      if (given[k].length !== sizes[port]) {
        throw new TypeError(`${name}: ${port} has ${sizes[port]} entries, got ${given[k].length}`);
      }
    });
  }

  /* Status 0 if `value` is within `low` and `high`, 2 if it is not finite, else `code`. */
  function limited(value, low, high, code) {
    return value >= low && value <= high ? 0 : Number.isFinite(value) ? code : 2;
  }

  /* Status 2 if `total` is not finite; outputs are NaN where the status is not 0. */
  function finish(status, total, outputs) {
    outputs.status = status === 0 && !Number.isFinite(total) ? 2 : status;
    if (outputs.status !== 0) {
      for (const value of Object.values(outputs)) {
        if (typeof value === "object") {
          value.fill(NaN);
        }
      }
    }
    return outputs;
  }

  /* Newton's iteration at one target: { status, q }. */
  function newton(step, settings, q, target, parameters, branch) {
    for (let count = 0; count < settings.max_steps; ++count) {
      const made = step(q, target, ...parameters);
      if (made.status !== 0) {
        return { status: 3, q };
      }
      q = made.q_next;
      if (made.residual[0] < settings.tolerance && made.step[0] < settings.tolerance) {
        return { status: made.orientation[0] * branch > 0.0 ? 0 : 4, q };
      }
    }
    return { status: 3, q };
  }

  /* From the guess to y with more and more substeps until all of them converge on the guess's branch. */
  function iterate(step, settings, y, guess, ...parameters) {
    if (![y, guess, ...parameters].every((array) => Array.from(array).every(Number.isFinite))) {
      return { q: new Float64Array(guess.length).fill(NaN), status: 2 };
    }
    const start = settings.independent.map((k) => guess[k]);
    const first = step(guess, start, ...parameters);
    if (first.status >= REFUSED) {
      return { q: new Float64Array(guess.length).fill(NaN), status: first.status };
    }
    const branch = first.orientation[0];
    let status = 3;
    for (let substeps = 1; substeps <= settings.max_substeps; substeps *= 2) {
      let q = guess;
      status = 0;
      for (let k = 1; k <= substeps && status === 0; ++k) {
        const target = start.map((from, i) => from + (y[i] - from) * (k / substeps));
        ({ status, q } = newton(step, settings, q, target, parameters, branch));
      }
      if (status === 0) {
        return { q: Float64Array.from(q), status };
      }
    }
    return { q: new Float64Array(guess.length).fill(NaN), status };
  }
"""


def print_javascript(model: Model) -> dict[str, str]:
    """File name to text: `<name>.js`, with all functions of a model.

    The script defines the constant `<name>` (with an underscore after a word that JavaScript keeps for itself),
    an object of functions; Node gets it by `require`.
    """
    return {f"{model.name}.js": print_script(model, model.name + "_" * (model.name in RESERVED))}


def print_script(model: Model, constant: str, functions: Iterable[str] | None = None) -> str:
    """A script that defines `constant`, an object with all functions of a model, or only those named.

    Each function returns an object with `status`, an array per output, and `guard`: the smallest pivot as a
    multiple of the threshold below which the function fails (Infinity where nothing is guarded).
    """
    check_names(model)
    chosen = list(model.programs) if functions is None else [n for n in model.programs if n in set(functions)]
    lines = ["/*", *(f" * {line}".rstrip() for line in banner(model)), " */", '"use strict";']
    programs = {name: first_path(model.programs[name], "the JavaScript") for name in chosen}
    constants = Constants(model, WRITING, programs.values())
    printed: list[str] = []
    for name, program in programs.items():
        if isinstance(program, Iteration):
            body = _iteration(name, program, constants)
        else:
            body = _function(name, program, constants)
        printed += ["", *(f"  {line}".rstrip() for line in [*_comment(function_lines(name, program)), *body])]
    lines += [f"const {constant} = (() => {{", *(f"  {line}" for line in constants.lines()), ""]
    lines += [*RUNTIME.replace("REFUSED", str(NO_ROTATION)).strip("\n").splitlines(), *printed]
    lines += ["", *wrapped(f"return {{ {', '.join(chosen)} }};", first="  ", later="    "), "})();"]
    lines += ['if (typeof module !== "undefined") {', f"  module.exports = {constant};", "}"]
    return "\n".join([*lines, ""])


def _comment(lines: Sequence[str]) -> list[str]:
    return ["/*", *(f" * {line}" for line in lines), " */"]


def _sizes(program: Program | Iteration) -> str:
    return "{ " + "".join(f"{port.name}: {port.size}, " for port in program.inputs).rstrip(", ") + " }"


def _function(name: str, program: Program, constants: Constants) -> list[str]:
    """The definition of a straight-line function: load, compute, check."""
    called = value_names(program, constants.names.values())

    def operand(value: int | float) -> str:
        return called[value] if isinstance(value, int) else constants.text(value)

    live, read = live_instructions(program)
    body = ((f"const {called[k]} = {text};", k) for k, text in statements(program, live, TABLE, operand))
    place = {port.name: i for i, port in enumerate(program.inputs)}
    loads = [
        f"  const {operand(slot)} = given[{place[port.name]}][{k}];"
        for slot, (port, k) in enumerate(input_entries(program))
        if slot in read
    ]
    pivots = [
        line
        for slot, limit, told in pivots_told(program)
        for line in code_lines(f"  Math.abs({operand(slot)}) / {decimal(limit)}, // {told}", comment="//", later="  ")
    ]
    small = " || ".join(f"Math.abs({operand(slot)}) <= {decimal(limit)}" for slot, limit in program.guards)
    limits = [
        f"limited({operand(slot)}, {_bound(low, '-')}, {_bound(high)}, {c})" for slot, low, high, c in program.limits
    ]
    status = " || ".join([*limits, f"({small} ? 1 : 0)" if limits and small else f"{small} ? 1 : 0" if small else "0"])
    total = balanced_sum([operand(slot) for slot in checked_slots(program)] or ["0.0"])
    outputs = [
        line
        for port, slots in zip(program.outputs, program.results, strict=True)
        for line in code_lines(f"    {port.name}: Float64Array.of({', '.join(map(operand, slots))}),")
    ]
    return [
        f"function {name}(...given) {{",
        f'  check("{name}", {_sizes(program)}, given);',
        *loads,
        *_lines(headed(body, Stages(program), operand, "// {}")),
        *_lines([f"const guard = Math.min( // {SMALL}", *pivots, ");"] if pivots else ["const guard = Infinity;"]),
        *_lines([f"const status = {status};", f"const total = {total};", "return finish(status, total, {"]),
        *outputs,
        "    guard,",
        "  });",
        "}",
    ]


def _lines(statements: Iterable[str]) -> list[str]:
    """Statements of a function, the long ones over several lines."""
    return [line for text in statements for line in code_lines(text, comment="//", first="  ")]


def _bound(value: float | None, sign: str = "") -> str:
    return f"{sign}Infinity" if value is None else decimal(value)


def _iteration(name: str, iteration: Iteration, constants: Constants) -> list[str]:
    settings = (
        f"{{ tolerance: {decimal(iteration.tolerance)}, max_steps: {iteration.max_steps}, "
        f"max_substeps: {iteration.max_substeps}, independent: [{', '.join(map(str, iteration.independent))}] }}"
    )
    return [
        *_function(f"{name}_step", iteration.step, constants),
        "",
        f"function {name}(...given) {{",
        f'  check("{name}", {_sizes(iteration)}, given);',
        *_lines([f"return iterate({name}_step, {settings}, ...given);"]),
        "}",
    ]
