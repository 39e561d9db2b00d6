"""C of a function of one point for all points of a family: four of them at a time, side by side in vector registers.

CasADi function of scalars --its instructions, once for four points--> C in the ABI of CasADi's external functions

All points obey the same straight-line program, so that four of them take hardly longer than one where a processor has
registers of four doubles; a compiler makes pairs, or single operations, of the same C elsewhere. Elementary functions
are called point by point. Behind the last point of a number that is no multiple of four that point is computed again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import casadi as ca

# States side by side: doubles of a register of AVX2; where registers are shorter a compiler takes two or four of them.
LANES = 4
# Statements of one C function: a compiler's time and memory grow faster than a function (5 GB for one of 60,000), and
# what parts hand on to each other costs little.
PART = 2_000
HEAD = f"""#include <math.h>
typedef double lanes __attribute__((vector_size({8 * LANES})));
static const lanes NONE = {{0.0}};
#define EACH(name, value) \\
    static inline lanes name(lanes a, lanes b) {{ \\
        lanes r; \\
        for (int k = 0; k < {LANES}; ++k) {{ const double x = a[k], y = b[k]; (void) y; r[k] = value; }} \\
        return r; \\
    }}
"""

# Operations that C has for vectors and numbers together.
INFIX: Mapping[int, str] = {ca.OP_ADD: "+", ca.OP_SUB: "-", ca.OP_MUL: "*", ca.OP_DIV: "/"}
WRITTEN: Mapping[int, Callable[[str], str]] = {
    ca.OP_NEG: "-{0}".format, ca.OP_TWICE: "{0} + {0}".format, ca.OP_SQ: "{0} * {0}".format,
    ca.OP_INV: "1.0 / {0}".format, ca.OP_ASSIGN: "{0}".format,
}  # fmt: skip
# Those that are computed point by point: name in C, value of x and y.
EACH: Mapping[int, tuple[str, str]] = {
    ca.OP_SIN: ("sines", "sin(x)"), ca.OP_COS: ("cosines", "cos(x)"), ca.OP_TAN: ("tangents", "tan(x)"),
    ca.OP_ASIN: ("arcsines", "asin(x)"), ca.OP_ACOS: ("arccosines", "acos(x)"), ca.OP_ATAN: ("arctangents", "atan(x)"),
    ca.OP_ATAN2: ("angles", "atan2(x, y)"), ca.OP_SQRT: ("roots", "sqrt(x)"), ca.OP_EXP: ("exponentials", "exp(x)"),
    ca.OP_LOG: ("logarithms", "log(x)"), ca.OP_POW: ("powers", "pow(x, y)"), ca.OP_CONSTPOW: ("powers", "pow(x, y)"),
    ca.OP_TANH: ("tanhs", "tanh(x)"), ca.OP_FABS: ("sizes", "fabs(x)"), ca.OP_FMIN: ("smaller", "fmin(x, y)"),
    ca.OP_FMAX: ("larger", "fmax(x, y)"), ca.OP_SIGN: ("signs", "x > 0 ? 1 : x < 0 ? -1 : x"),
    ca.OP_LT: ("less", "x < y"), ca.OP_LE: ("at_most", "x <= y"), ca.OP_EQ: ("equal", "x == y"),
    ca.OP_NE: ("other", "x != y"), ca.OP_NOT: ("negated", "!(x != 0)"), ca.OP_AND: ("both", "x != 0 && y != 0"),
    ca.OP_OR: ("either", "x != 0 || y != 0"), ca.OP_IF_ELSE_ZERO: ("chosen", "x != 0 ? y : 0"),
}  # fmt: skip
OPERATIONS = {*INFIX, *WRITTEN, *EACH, ca.OP_CONST, ca.OP_INPUT, ca.OP_OUTPUT}


def printable(function: ca.Function) -> bool:
    """Whether C has all operations of a function."""
    return all(function.instruction_id(k) in OPERATIONS for k in range(function.n_instructions()))


def printed_lanes(functions: Mapping[str, tuple[ca.Function, int, Sequence[int]]]) -> str:
    """C of functions by name: each of a point, for so many points; the numbers of which inputs are those of all."""
    used = {f.instruction_id(k) for f, _, _ in functions.values() for k in range(f.n_instructions())}
    each = dict(EACH[op] for op in used if op in EACH)
    lines = [HEAD, *(f"EACH({name}, {value})" for name, value in sorted(each.items()))]
    for name, (function, count, common) in functions.items():
        body, held = _body(name, function)
        of_all = name, function, count, common
        lines += [*body, *_calls(*of_all, held=held), *_described(*of_all)]
    return "\n".join(lines) + "\n"


@dataclass(frozen=True)
class _Statement:
    """A value that is computed (`output` None) or handed out, from arguments: texts of numbers, or statements."""

    op: int
    args: tuple[str | int, ...]
    output: tuple[int, int] | None = None


def _statements(function: ca.Function) -> list[_Statement]:
    """The program of one point, every value named once, by its place in the list."""
    known: dict[int, str | int] = {}  # place in the work vector -> what holds it now
    found: list[_Statement] = []
    for k in range(function.n_instructions()):
        op, given, made = function.instruction_id(k), function.instruction_input(k), function.instruction_output(k)
        if op == ca.OP_CONST:
            number = repr(float(function.instruction_constant(k)))
            known[made[0]] = f"({number.replace('inf', 'INFINITY').replace('nan', 'NAN')})"
        elif op == ca.OP_OUTPUT:
            found.append(_Statement(op, (known[given[0]],), (made[0], made[1])))
        else:
            args = (f"in[{given[0]}][{given[1]}]",) if op == ca.OP_INPUT else tuple(known[j] for j in given)
            known[made[0]] = len(found)
            found.append(_Statement(op, args))
    return found


def _body(name: str, function: ca.Function) -> tuple[list[str], int]:
    """C functions of parts of the program of one point, on four, and how many values they hand on to each other."""
    statements = _statements(function)
    last: dict[int, int] = {}  # statement -> the last part that reads it
    for k, statement in enumerate(statements):
        last |= {j: k // PART for j in statement.args if isinstance(j, int)}
    lines, places, free, size = list[str](), dict[int, int](), list[int](), 0
    parts = range(0, max(len(statements), 1), PART)
    for number, start in enumerate(parts):
        lines.append(f"static void {name}_part{number}(const lanes *const *in, lanes *const *out, lanes *w)")
        lines.append("{\n    (void) in; (void) out; (void) w;")
        read: set[int] = set()
        for k in range(start, min(start + PART, len(statements))):
            statement = statements[k]
            for j in statement.args:
                if isinstance(j, int) and j < start and j not in read:
                    read.add(j)
                    lines.append(f"    const lanes a{j} = w[{places[j]}];")
            if statement.output is not None:
                lines.append(f"    out[{statement.output[0]}][{statement.output[1]}] = {_lanes(statement.args[0])};")
                continue
            lines.append(f"    const lanes a{k} = {_value(statement)};")
            if last.get(k, number) > number:
                places[k] = free.pop() if free else size
                size = max(size, places[k] + 1)
                lines.append(f"    w[{places[k]}] = a{k};")
        lines.append("}")
        free += [place for j, place in places.items() if last[j] == number]
    lines.append(f"static void {name}_lanes(const lanes *const *in, lanes *const *out, lanes *w)")
    calls = (f"    {name}_part{number}(in, out, w);" for number in range(len(parts)))
    return [*lines, "{", *calls, "}"], size


def _value(statement: _Statement) -> str:
    op, args = statement.op, statement.args
    if op == ca.OP_INPUT:
        return str(args[0])
    if not any(isinstance(a, int) for a in args):
        texts = [_lanes(a) for a in args]
    else:
        texts = [f"a{a}" if isinstance(a, int) else a for a in args]
    if op in INFIX:
        return f"{texts[0]} {INFIX[op]} {texts[1]}"
    if op in WRITTEN:
        return WRITTEN[op](texts[0])
    return f"{EACH[op][0]}({', '.join(_lanes(a) for a in (*args, args[0])[:2])})"


def _lanes(value: str | int) -> str:
    """A value, or a number in all lanes."""
    return f"a{value}" if isinstance(value, int) else f"(NONE + {value})"


def _calls(name: str, function: ca.Function, count: int, common: Sequence[int], *, held: int) -> Iterator[str]:
    """The loop over all points; inputs and outputs of a point stand one after the other."""
    inputs = [max(function.nnz_in(k), 1) for k in range(function.n_in())]
    outputs = [max(function.nnz_out(k), 1) for k in range(function.n_out())]
    yield (
        f"int {name}(const double **arg, double **res, long long int *iw, double *w, int mem)\n"
        "{\n"
        "    (void) iw; (void) w; (void) mem;\n"
        f"    lanes held[{held + 1}];"
    )
    for kind, sizes in (("in", inputs), ("out", outputs)):
        yield from (f"    lanes {kind}{k}[{size}];" for k, size in enumerate(sizes))
    names = ", ".join(f"in{k}" for k in range(len(inputs)))
    yield f"    const lanes *const in[] = {{{names}}};"
    yield f"    lanes *const out[] = {{{', '.join(f'out{k}' for k in range(len(outputs)))}}};"
    yield f"    for (int first = 0; first < {count}; first += {LANES}) {{"
    yield f"        for (int k = 0; k < {LANES}; ++k) {{"
    yield f"            const int at = first + k < {count} ? first + k : {count - 1};"
    yield "            (void) at;"
    for k in range(function.n_in()):
        size = function.nnz_in(k)
        value = f"arg[{k}][{'i' if k in common else f'at * {size} + i'}]"
        if size:
            yield f"            for (int i = 0; i < {size}; ++i) {{ in{k}[i][k] = arg[{k}] ? {value} : 0.0; }}"
    yield "        }"
    yield f"        {name}_lanes(in, out, held);"
    yield f"        for (int k = 0; k < {LANES} && first + k < {count}; ++k) {{"
    for k in range(function.n_out()):
        size = function.nnz_out(k)
        if size:
            yield f"            for (int i = 0; res[{k}] && i < {size}; ++i) {{"
            yield f"                res[{k}][(first + k) * {size} + i] = out{k}[i][k];"
            yield "            }"
    yield "        }"
    yield "    }\n    return 0;\n}"


def _described(name: str, function: ca.Function, count: int, common: Sequence[int]) -> Iterator[str]:
    """Numbers and patterns of inputs and outputs of all points."""
    yield f"long long int {name}_n_in(void) {{ return {function.n_in()}; }}"
    yield f"long long int {name}_n_out(void) {{ return {function.n_out()}; }}"
    yield f"int {name}_work(long long int *a, long long int *r, long long int *i, long long int *w)"
    yield f"{{ *a = {function.n_in()}; *r = {function.n_out()}; *i = 0; *w = 0; return 0; }}"
    for kind, number in (("in", function.n_in()), ("out", function.n_out())):
        given = function.sparsity_in if kind == "in" else function.sparsity_out
        for k in range(number):
            whole = given(k) if kind == "in" and k in common else ca.horzcat(*count * [given(k)])
            values = ", ".join(str(v) for v in whole.compress())
            yield f"static const long long int {name}_{kind}{k}[] = {{{values}}};"
        cases = " ".join(f"case {k}: return {name}_{kind}{k};" for k in range(number))
        yield f"const long long int *{name}_sparsity_{kind}(long long int k)"
        yield f"{{ switch (k) {{ {cases} default: return 0; }} }}"
