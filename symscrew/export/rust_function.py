"""The bodies of functions in Rust, on arrays, with the status as a number: what the typed functions call."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib import resources

from symscrew.export.c_precision import Precision
from symscrew.export.constants import Constants, Writing
from symscrew.export.folding import statements
from symscrew.export.listing import (
    balanced_sum,
    checked_slots,
    code_lines,
    filled,
    input_entries,
    live_instructions,
    wrapped,
)
from symscrew.export.pivots import pivots_told
from symscrew.export.rust_names import RESERVED, arguments, real, safe
from symscrew.export.stages import Stages, headed
from symscrew.export.value_names import value_names
from symscrew.model import Model
from symscrew.program import NO_ROTATION, RANK, Iteration, Program, RankRevealing

TEMPLATE = "rust_second_path.rs"
TABLE = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "neg": "-{0}",
    "reciprocal": "1.0 / {0}",
    "div": "{0} / {1}",
    "sqrt": "M::sqrt({0})",
    "exp": "M::exp({0})",
    "sin": "M::sin({0})",
    "cos": "M::cos({0})",
    "tan": "M::tan({0})",
    "atan2": "M::atan2({0}, {1})",
    "abs": "size({0})",
    "less": "(if {0} < {1} {{ 1.0 }} else {{ 0.0 }})",
    "select": "(if {0} != 0.0 {{ {1} }} else {{ {2} }})",
}

SHARED = """\
type Real = REAL;

/// The absolute value, which is not in `core` of all versions.
#[inline]
fn size(x: Real) -> Real {
    Real::from_bits(x.to_bits() & (BITS::MAX >> 1))
}

/// Status 0 if `value` is within `low` and `high`, 2 if it is not finite, else `code`.
#[inline]
fn limited(value: Real, low: Real, high: Real, code: i32) -> i32 {
    if value >= low && value <= high {
        0
    } else if value.is_finite() {
        code
    } else {
        2
    }
}
"""


def arrays_module(model: Model, precision: Precision) -> list[str]:
    """The private module with all functions on arrays."""
    kind = real(precision)
    constants = Constants(model, _writing(precision))
    lines: list[str] = []
    seconds = [p for p in model.programs.values() if isinstance(p, RankRevealing)]
    if seconds:
        bounds = {"RANK": RANK, "LEAST": 1e-30, "EQUAL": 1e-15, "LOST": 1e-14}
        text = resources.files("symscrew.export").joinpath(TEMPLATE).read_text("utf-8")
        words = {word: number(precision.threshold(bound)) for word, bound in bounds.items()}
        lines += ["", *filled(text, words)]
    known: dict[object, str] = {}
    for name, program in model.programs.items():
        if isinstance(program, Iteration):
            lines += ["", *_iteration(safe(name), program, precision, constants)]
        elif isinstance(program, RankRevealing):
            lines += _with_second_path(safe(name), program, constants, precision=precision, known=known)
        else:
            lines += ["", *_Function(safe(name), program, precision, constants).lines()]
    allowed = "#[allow(dead_code, non_snake_case, non_upper_case_globals, unused_parens, unused_variables)]"
    shared = filled(SHARED, {"REAL": kind, "BITS": f"u{kind[1:]}"})
    lines = ["use super::Math;", "", *shared, "", *constants.lines(), *lines]
    return [allowed, "mod arrays {", *(f"    {x}".rstrip() for x in lines), "}"]


def _writing(precision: Precision) -> Writing:
    """How constants are written: with the names that the C has, which no other constants of Rust have."""

    def decimal(value: float) -> str:
        return number(precision.number(value))

    return Writing(decimal, "const {name}: Real = {number}; ", ("// ", "// ", ""), taken=RESERVED)


def number(text: str) -> str:
    """A constant of C as one of Rust: types are inferred."""
    return text.replace("f", "")


def _signature(name: str, program: Program | Iteration) -> list[str]:
    given = [f"{n}: &[Real; {p.size}]" for n, p in zip(arguments(program.inputs), program.inputs, strict=True)]
    made = [f"{n}: &mut [Real; {p.size}]" for n, p in zip(_outputs(program), program.outputs, strict=True)]
    return wrapped(f"pub(super) fn {name}<M: Math>({', '.join([*given, *made])}) -> i32 {{", later="    ")


def _outputs(program: Program | Iteration) -> list[str]:
    """Names of outputs; one that an input has, too, gets an underscore."""
    given = set(arguments(program.inputs))
    return [f"{name}_" if name in given else name for name in arguments(program.outputs)]


class _Function:
    """A straight-line function; `second` is its way out of small pivots."""

    def __init__(
        self, name: str, program: Program, precision: Precision, constants: Constants, *, second: str = ""
    ) -> None:
        self.name, self.program, self.precision, self.second = name, program, precision, second
        self.constants = constants
        taken = {*RESERVED, *arguments(program.inputs), *_outputs(program), *constants.names.values()}
        self.called = value_names(program, taken)

    def operand(self, value: int | float) -> str:
        """A slot by its name, or a number."""
        return self.called[value] if isinstance(value, int) else self.constants.text(value)

    def lines(self) -> list[str]:
        """Load, compute, check, store."""
        program = self.program
        live, read = live_instructions(program)
        given = {port.name: name for port, name in zip(program.inputs, arguments(program.inputs), strict=True)}
        loads = [
            f"let {self.operand(slot)} = {given[port.name]}[{k}];"
            for slot, (port, k) in enumerate(input_entries(program))
            if slot in read
        ]
        body = ((f"let {self.called[k]} = {text};", k) for k, text in statements(program, live, TABLE, self.operand))
        stores = [
            f"{name}[{k}] = {self.operand(slot)};"
            for name, slots in zip(_outputs(program), program.results, strict=True)
            for k, slot in enumerate(slots)
        ]
        fill = [f"*{name} = [Real::NAN; {p.size}];" for name, p in zip(_outputs(program), program.outputs, strict=True)]
        way_out = ["if code == 1 {", f"    return {self.second};", "}"] if self.second and program.guards else []
        inner = [
            *loads,
            *headed(body, Stages(program), self.operand, "// {}"),
            *self._code(),
            *way_out,
            "if code != 0 {",
            *(f"    {line}" for line in fill),
            "    return code;",
            "}",
            *stores,
            "0",
        ]
        lines = [line for text in inner for line in code_lines(text, comment="//", first="    ")]
        return [*_signature(self.name, program), *lines, "}"]

    def _code(self) -> Iterator[str]:
        """The status: limits, pivots, and whether everything is finite."""
        program, threshold = self.program, self.precision.threshold
        yield "let mut code = 0;"
        for slot, low, high, status in program.limits:
            bounds = [
                f"{sign}Real::INFINITY" if bound is None else number(self.precision.number(bound))
                for sign, bound in (("-", low), ("", high))
            ]
            yield "if code == 0 {"
            yield f"    code = limited({self.operand(slot)}, {', '.join(bounds)}, {status});"
            yield "}"
        for slot, limit, told in pivots_told(program):
            yield f"// {told}"
            yield f"if code == 0 && size({self.operand(slot)}) <= {number(threshold(limit))} {{"
            yield "    code = 1;"
            yield "}"
        total = balanced_sum([self.operand(slot) for slot in checked_slots(program)] or ["0.0"])
        yield f"let total: Real = {total};"
        yield "if code == 0 && !total.is_finite() {"
        yield "    code = 2;"
        yield "}"


def _with_second_path(
    name: str, program: RankRevealing, constants: Constants, *, precision: Precision, known: dict[object, str]
) -> list[str]:
    """The function, the programs of its second path, and that path; `known`: dense programs that are there already."""
    assert program.dense is not None
    dense = program.dense
    key = (dense.inputs, dense.instructions, dense.results, dense.guards)
    lines = []
    if key not in known:
        known[key] = f"{name}_dense"
        lines += ["", *_Function(known[key], dense, precision, constants).lines()]
    if program.wrenches is not None:
        lines += ["", *_Function(f"{name}_wrenches", program.wrenches, precision, constants).lines()]
    call = f"{name}_rank_revealing::<M>({', '.join([*arguments(program.inputs), *_outputs(program)])})"
    lines += ["", *_second_path(name, program, precision, known[key])]
    return [*lines, "", *_Function(name, program, precision, constants, second=call).lines()]


def _second_path(name: str, program: RankRevealing, precision: Precision, dense: str) -> list[str]:
    """The same operations as `symscrew.export.c_rank_revealing` prints in C."""
    n, m = len(program.rates), len(program.rows)
    outputs = _outputs(program)
    given = "".join(f"{x}, " for x in arguments(program.inputs))
    a = outputs[0]

    def numbers(values: Sequence[float]) -> str:
        return ", ".join(number(precision.number(x)) for x in values)

    inner = [
        *wrapped(f"let rate_scale: [Real; {n}] = [{numbers(program.rates)}];", later="    "),
        *wrapped(f"let row_scale: [Real; {m}] = [{numbers(program.rows)}];", later="    "),
        f"let (mut inertia, mut load) = ([0.0; {n * n}], [0.0; {n}]);",
        f"let (mut closure, mut curvature) = ([0.0; {n * m}], [0.0; {m}]);",
        f"let (mut turn, mut work, mut multipliers) = ([0.0; {n * n}], [0.0; {n * n + 3 * n}], [0.0; {m}]);",
        f"let known = {dense}::<M>({given}&mut inertia, &mut load, &mut closure, &mut curvature) == 0;",
        f"for j in 0..{n} {{",
        "    load[j] *= rate_scale[j];",
        f"    for i in 0..{n} {{",
        f"        inertia[i + j * {n}] *= rate_scale[i] * rate_scale[j];",
        "    }",
        f"    for i in 0..{m} {{",
        f"        closure[i + j * {m}] *= row_scale[i] * rate_scale[j];",
        "    }",
        "}",
        f"for i in 0..{m} {{",
        "    curvature[i] *= row_scale[i];",
        "}",
        "let parts = Given { mass: &inertia, force: &load, bias: &curvature };",
        "let rank =",
        f"    constrained::<M>(&parts, &mut closure, &mut turn, &mut work, &mut *{a}, &mut multipliers);",
        f"let {'mut ' if program.wrenches else ''}total = dot(&*{a}, &*{a});",
        f"for j in 0..{n} {{",
        f"    {a}[j] *= rate_scale[j];",
        "}",
        *(_internal_loads(name, program, precision) if program.wrenches else []),
        "if !known || rank < 0 || !total.is_finite() {",
        *(f"    *{x} = [Real::NAN; {p.size}];" for x, p in zip(outputs, program.outputs, strict=True)),
        "    return if known && total.is_finite() { 1 } else { 2 };",
        "}",
        f"if rank == {program.regular} {{ -1 }} else {{ -2 }}",
    ]
    return [*_signature(f"{name}_rank_revealing", program), *(f"    {line}" for line in inner), "}"]


def _internal_loads(name: str, program: RankRevealing, precision: Precision) -> list[str]:
    """Reactions for the multipliers found, plus the internal loads that make their sum of squares smallest."""
    a, reactions = _outputs(program)
    m, size = len(program.rows), program.outputs[1].size
    n = len(program.rates)
    call = f"{name}_wrenches::<M>({''.join(f'{x}, ' for x in arguments(program.inputs))}&*{a}"
    solved = [
        f"for i in 0..{m} {{",
        "    multipliers[i] *= row_scale[i];",
        "}",
        f"{call}, &multipliers, &mut *{reactions}, &mut sized);",
    ]
    summed = f"total += dot(&*{reactions}, &*{reactions});"
    if not program.loads_matter:
        return [f"let mut sized = [0.0; {size}];", *solved, summed]
    return [
        f"let (mut sized, mut shifted, mut other) = ([0.0; {size}], [0.0; {size}], [0.0; {size}]);",
        f"let (mut loads, mut columns) = ([0.0; {m * m}], [0.0; {m * size}]);",
        f"let (mut mix, mut amount) = ([0.0; {m * m}], [0.0; {m}]);",
        *solved,
        f"let internal = if rank >= 0 {{ {m} - rank as usize }} else {{ 0 }};",
        "for k in 0..internal {",
        f"    let mut moved = [0.0; {m}];",
        f"    internal_load::<M>({n}, {m}, &closure, k, &mut loads);",
        f"    for i in 0..{m} {{",
        f"        moved[i] = multipliers[i] + row_scale[i] * loads[i + k * {m}];",
        "    }",
        f"    {call}, &moved, &mut shifted, &mut other);",
        f"    for i in 0..{size} {{",
        f"        columns[i + k * {size}] = other[i] - sized[i];",
        "    }",
        "}",
        f"orthogonalise::<M>({size}, internal, &mut columns, &mut mix);",
        "let mut largest = 0.0;",
        "for k in 0..internal {",
        f"    let column = &columns[k * {size}..(k + 1) * {size}];",
        "    let part = dot(column, column);",
        "    largest = if part > largest { part } else { largest };",
        "}",
        "for k in 0..internal {",
        f"    let column = &columns[k * {size}..(k + 1) * {size}];",
        "    let part = dot(column, column);",
        f"    if part > {number(precision.threshold(1e-18))} * largest {{",
        "        let factor = -dot(column, &sized) / part;",
        "        for i in 0..internal {",
        "            amount[i] += factor * mix[i + k * internal];",
        "        }",
        "    }",
        "}",
        "for k in 0..internal {",
        f"    for i in 0..{m} {{",
        f"        multipliers[i] += amount[k] * row_scale[i] * loads[i + k * {m}];",
        "    }",
        "}",
        f"{call}, &multipliers, &mut *{reactions}, &mut sized);",
        summed,
    ]


def _iteration(name: str, iteration: Iteration, precision: Precision, constants: Constants) -> list[str]:
    """A step, and Newton's iteration in more and more parts of the way from the guess, as in C."""
    n, m = iteration.outputs[0].size, iteration.inputs[0].size
    y, guess, *more = arguments(iteration.inputs)
    (q,) = _outputs(iteration)
    extra = "".join(f", {x}" for x in more)
    finite = [f"{x}[{k}]" for x, p in zip([y, guess, *more], iteration.inputs, strict=True) for k in range(p.size)]
    tolerance = number(precision.threshold(iteration.tolerance))
    refuses = bool(iteration.step.limits)
    step = f"{name}_step::<M>"
    measures = "&mut next, &mut residual, &mut change, &mut orientation"
    start = [f"{guess}[{k}]" for k in iteration.independent]
    inner = [
        *wrapped(f"let total: Real = {balanced_sum(finite or ['0.0'])};", later="    "),
        f"*{q} = [Real::NAN; {n}];",
        "if !total.is_finite() {",
        "    return 2;",
        "}",
        f"let start: [Real; {m}] = [{', '.join(start)}];",
        f"let (mut next, mut residual, mut change, mut orientation) = ([0.0; {n}], [0.0], [0.0], [0.0]);",
        f"let first = {step}({guess}, &start{extra}, {measures});",
        *([f"if first >= {NO_ROTATION} {{", "    return first;", "}"] if refuses else []),
        "let branch = orientation[0];",
        "let mut code = 3;",
        "let mut substeps = 1;",
        f"while substeps <= {iteration.max_substeps} && code != 0 {{",
        f"    let mut found = *{guess};",
        "    code = 0;",
        "    let mut k = 1;",
        "    while k <= substeps && code == 0 {",
        "        let part = k as Real / substeps as Real;",
        "        let mut target = start;",
        f"        for i in 0..{m} {{",
        f"            target[i] = start[i] + ({y}[i] - start[i]) * part;",
        "        }",
        "        code = 3;",
        f"        for _ in 0..{iteration.max_steps} {{",
        f"            if {step}(&found, &target{extra}, {measures}) != 0 {{",
        "                break;",
        "            }",
        "            found = next;",
        f"            if residual[0] < {tolerance} && change[0] < {tolerance} {{",
        "                code = if orientation[0] * branch > 0.0 { 0 } else { 4 };",
        "                break;",
        "            }",
        "        }",
        "        k += 1;",
        "    }",
        "    if code == 0 {",
        f"        *{q} = found;",
        "    }",
        "    substeps *= 2;",
        "}",
        "code",
    ]
    lines = _Function(f"{name}_step", iteration.step, precision, constants).lines()
    return [*lines, "", *_signature(name, iteration), *(f"    {line}" for line in inner), "}"]
