"""Functions of several states in C, on vector types of GCC and clang.

`<symbol>_wide` has the statements of a function for as many states as the widest vector of the machine holds, at most
`LANES`: entry k of an argument lies at k * stride, of sines and cosines at k * LANES, state after state.

Vectors that a compiler makes of a loop over states are no substitute: GCC computes the places of all entries in front
of the loop, more than there are registers (a fifth of the time of all reactions of the seed), and clang gives up.
No vector type crosses a function's boundary but those of small functions that are inlined.
"""

from __future__ import annotations

from collections.abc import Sequence, Set

from symscrew.export.c_function import sines, statements, unread
from symscrew.export.c_names import arguments, declare, wrapped_code
from symscrew.export.c_precision import Precision
from symscrew.export.c_printed import Form, Printed
from symscrew.export.listing import checked_slots

LANES = 8  # states of a block: those of one AVX-512 register of doubles, and of two or four smaller ones


def guard(model: str) -> str:
    """The condition of the preprocessor for blocks: vectors of GCC and clang, on machines that have them."""
    machine = "defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))"
    return f"{machine} && !defined({model.upper()}_SCALAR) && !defined({model.upper()}_STATE_BY_STATE)"


def types(model: str, precision: Precision, operations: Set[str]) -> list[str]:
    """Vectors of states, how they are read and written where they are, and what has no sign in C."""
    upper, real, size = model.upper(), precision.real, precision.size
    wide, mask, zero = f"{model}_wide", f"({model}_wide_mask)", f"{upper}_ZERO"

    def inline(name: str, given: Sequence[str], body: Sequence[str]) -> list[str]:
        return [f"static inline {wide} {wide}_{name}({', '.join(f'{wide} {x}' for x in given)})", "{", *body, "}"]

    bits = f"return ({wide})"
    routines = {
        "sqrt": precision.vector_root(wide, f"{upper}_WIDE"),
        "abs": inline("abs", "x", [f"    {bits}({mask}x & ~{mask}(-{zero}));"]),
        "less": inline("less", "ab", [f"    {bits}({mask}(a < b) & {mask}({zero} + {precision.number(1.0)}));"]),
        "select": inline("select", "cab", [
            f"    const {model}_wide_mask other = {mask}(c == {zero});",
            f"    {bits}(({mask}a & ~other) | ({mask}b & other));",
        ]),
    }  # fmt: skip
    return [
        f"#if {guard(model)}",
        "#if defined(__AVX512F__)",
        f"#define {upper}_WIDE {min(LANES, 64 // size)}",
        "#elif defined(__AVX__)",
        f"#define {upper}_WIDE {min(LANES, 32 // size)}",
        "#else",
        f"#define {upper}_WIDE {16 // size}",
        "#endif",
        f"typedef {real} {wide} __attribute__((vector_size({upper}_WIDE * {size})));",
        f"typedef {precision.integer} {wide}_mask __attribute__((vector_size({upper}_WIDE * {size})));",
        f"typedef {real} {wide}_there",
        f"    __attribute__((vector_size({upper}_WIDE * {size}), aligned({size}), may_alias));",
        f"#define {upper}_READ(place) (*(const {wide}_there *)&(place))",
        f"#define {upper}_WRITTEN(place) (*({wide}_there *)&(place))",
        f"#define {zero} (({wide}){{{precision.number(0.0)}}})",
        *(line for op, lines in routines.items() if op in operations for line in lines),
        "#endif",
    ]


def _form(printed: Printed) -> Form:
    """How several states are written in vectors."""
    upper, wide = printed.model.upper(), f"{printed.model}_wide"
    vector = f"{{}} - {upper}_ZERO"  # of a number, too; the difference is folded
    table = dict(printed.precision.table)
    table["sqrt"] = f"{wide}_sqrt({{0}})"
    for op, count in (("abs", 1), ("less", 2), ("select", 3)):
        table[op] = f"{wide}_{op}({', '.join(vector.format(f'{{{k}}}') for k in range(count))})"
    read, written = f"{upper}_READ({{}})", f"{upper}_WRITTEN({{}})"
    return Form(wide, table, "stride", str(LANES), read, written, vector)


def function(printed: Printed) -> list[str]:
    """`<symbol>_wide`: results, and of each state the sum of what must be finite, NaN at a small pivot."""
    program, precision, form = printed.program, printed.precision, _form(printed)
    mask = f"({printed.model}_wide_mask)"
    given = ["size_t stride", *arguments(program, precision), *sines(printed), f"{precision.real} *restrict total"]
    found, total = statements(printed, form, printed.stored)
    if not checked_slots(program):
        total = form.constant.format(total)
    small = []
    for slot, threshold in program.guards:
        pivot, limit = printed.operand(slot), precision.threshold(threshold)
        small.append(f"({mask}({pivot} <= {limit}) & {mask}({pivot} >= -{limit}))")
    if small:  # all bits set are a NaN
        total = f"({form.real})({mask}({total}) | {' | '.join(small)})"
    return [
        "__attribute__((noinline))",
        declare(f"{printed.symbol}_wide", given, "static void "),
        "{",
        "    (void)stride;",
        *unread(printed),
        *(line for statement in found for line in wrapped_code(statement)),
        *wrapped_code(f"{form.written.format('total[0]')} = {total};"),
        "}",
    ]
