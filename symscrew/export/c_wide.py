"""Functions of several states in C, on vector types of GCC and clang.

`<symbol>_wide` has the statements of a function for as many states as the widest vector of the machine holds, at most
`LANES`: entry k of an argument lies at k * stride, of sines and cosines at k * LANES, state after state.

Vectors that a compiler makes of a loop over states are no substitute: GCC computes the places of all entries in front
of the loop, more than there are registers (a fifth of the time of all reactions of the seed), and clang gives up.
No vector type crosses a function's boundary but those of small functions that are inlined.
"""

from __future__ import annotations

from collections.abc import Sequence, Set

from symscrew.export import c_limb_macros
from symscrew.export.c_precision import Precision

LANES = 8  # states of a block: those of one AVX-512 register of doubles, and of two or four smaller ones


def guard(model: str) -> str:
    """The condition of the preprocessor for blocks: vectors of GCC and clang, on machines that have them."""
    machine = "defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))"
    return f"{machine} && !defined({model.upper()}_SCALAR) && !defined({model.upper()}_STATE_BY_STATE)"


def types(model: str, precision: Precision, operations: Set[str], limbs: Sequence[int] = ()) -> list[str]:
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
        f"#define {zero} (({wide}){{{precision.number(0.0)}}})",
        *(line for op, lines in routines.items() if op in operations for line in lines),
        *c_limb_macros.types(wide, f"{wide}_each", limbs),
        "#endif",
    ]


def one_state(model: str, precision: Precision, limbs: Sequence[int]) -> list[str]:
    """The macros of bodies that take one state; `limbs` are the numbers of equal limbs that there are."""
    upper, real, fabs = model.upper(), precision.real, precision.function("fabs")
    one, zero = precision.number(1.0), precision.number(0.0)
    return [
        "/* Bodies of functions are written once. Here they take one state ... */",
        f"#define BODY(function) static inline {upper}_INLINE int function##_body",
        f"#define REAL {real}",
        "#define READ(array, k) ((array)[k])",
        "#define SINES(array, k) ((array)[k])",
        "#define WRITE(array, k, x) ((array)[k] = (x))",
        "#define CONSTANT(x) (x)",
        f"#define SQRT(x) {precision.function('sqrt')}(x)",
        f"#define ABS(x) {fabs}(x)",
        f"#define LESS(a, b) ((a) < (b) ? {one} : {zero})",
        f"#define SELECT(condition, a, b) ((condition) != {zero} ? (a) : (b))",
        f"#define FOURS {model}_four",
        f"#define FOUR(array, k) {upper}_FOUR((array) + (k))",
        f"#define SUM_OF_FOUR(x) {upper}_SUM(x)",
        f"#define SMALL(pivot, limit) ({fabs}(pivot) <= (limit))",
        "#define OR ||",
        "#define FINITE_UNLESS(small, sum) (void)stride, (void)total; return (small) ? 1 : isfinite(sum) ? 0 : 2",
        "#define FINITE(sum) (void)stride, (void)total; return isfinite(sum) ? 0 : 2",
        "#define UNCHECKED() (void)stride, (void)total; return 0",
        "#define NOT_BELOW(x, low, status) \\",
        "    if (!((x) >= (low))) { (void)stride, (void)total; return isfinite(x) ? (status) : 2; }",
        "#define NOT_ABOVE(x, high, status) \\",
        "    if (!((x) <= (high))) { (void)stride, (void)total; return isfinite(x) ? (status) : 2; }",
        *RESULT,
        *c_limb_macros.one_by_one(model, "", f"{model}_each", real=precision.real, limbs=limbs),
    ]


# A result goes to its place and into a sum that tells at the end whether all results are finite.
RESULT = [
    "#define RESULT(checked, array, k, x) \\",
    "    { const REAL result_ = (x); WRITE(array, k, result_); checked = checked + result_; }",
]
_MACROS = """
    BODY REAL READ SINES WRITE CONSTANT SQRT ABS LESS SELECT FOURS FOUR SUM_OF_FOUR SMALL OR FINITE_UNLESS FINITE
    UNCHECKED NOT_BELOW NOT_ABOVE RESULT
"""
MACROS = tuple(_MACROS.split())


def undefined(limbs: Sequence[int]) -> list[str]:
    """The end of these macros."""
    return [f"#undef {macro}" for macro in (*MACROS, *c_limb_macros.names(limbs))]


def states(model: str, precision: Precision, limbs: Sequence[int]) -> list[str]:
    """The macros of bodies that take as many states as a vector holds."""
    upper, wide, mask = model.upper(), f"{model}_wide", f"({model}_wide_mask)"
    zero = f"{upper}_ZERO"
    return [
        "/* ... and here as many states as a vector holds: entry k of an argument lies at k * stride. */",
        "#define BODY(function) __attribute__((noinline)) static void function##_wide",
        f"#define REAL {wide}",
        f"#define READ(array, k) (*(const {wide}_there *)&(array)[(k) * stride])",
        f"#define SINES(array, k) (*(const {wide}_there *)&(array)[(k) * {LANES}])",
        f"#define WRITE(array, k, x) (*({wide}_there *)&(array)[(k) * stride] = (x))",
        f"#define CONSTANT(x) ((x) - {zero})",
        f"#define SQRT(x) {wide}_sqrt(x)",
        f"#define ABS(x) {wide}_abs((x) - {zero})",
        f"#define LESS(a, b) {wide}_less((a) - {zero}, (b) - {zero})",
        f"#define SELECT(condition, a, b) {wide}_select((condition) - {zero}, (a) - {zero}, (b) - {zero})",
        f"#define FOURS {wide}",
        "#define FOUR(array, k) \\",
        "    ((READ(array, k) + READ(array, (k) + 1)) + (READ(array, (k) + 2) + READ(array, (k) + 3)))",
        "#define SUM_OF_FOUR(x) (x)",
        f"#define SMALL(pivot, limit) ({mask}((pivot) <= (limit)) & {mask}((pivot) >= -(limit)))",
        "#define OR |",
        "/* All bits set are a NaN. */",
        "#define FINITE_UNLESS(small, sum) \\",
        f"    (void)stride, *({wide}_there *)total = ({wide})({mask}(sum) | (small))",
        f"#define FINITE(sum) (void)stride, *({wide}_there *)total = (sum)",
        f"#define UNCHECKED() (void)stride, *({wide}_there *)total = {zero}",
        f"#define NOT_BELOW(x, low, status) checked0 = ({wide})({mask}checked0 | ~{mask}((x) >= (low)))",
        f"#define NOT_ABOVE(x, high, status) checked0 = ({wide})({mask}checked0 | ~{mask}((x) <= (high)))",
        *RESULT,
        *c_limb_macros.one_by_one(model, "_wide", f"{wide}_each", real=precision.real, limbs=limbs),
    ]


def side_by_side(model: str, precision: Precision, limbs: int) -> list[str]:
    """The macros of bodies that take one state with so many equal limbs in the lanes of a vector."""
    upper, real, zero = model.upper(), precision.real, precision.number(0.0)
    vector, fabs = f"{model}_vector{limbs}", precision.function("fabs")
    changed = {
        "BODY(": f"#define BODY(function) static inline {upper}_INLINE {real} function##_packed_lane",
        "SMALL(": f"#define SMALL(pivot, limit) (({vector}_mask){{-({fabs}(pivot) <= (limit))}})",
        "OR ": "#define OR |",
        "FINITE_UNLESS(": "#define FINITE_UNLESS(small, sum) \\\n"
        f"    (void)stride, (void)total; return (sum) + {vector}_sum(({vector})(small))",
        "FINITE(": "#define FINITE(sum) (void)stride, (void)total; return (sum)",
        "UNCHECKED(": f"#define UNCHECKED() (void)stride, (void)total; return {zero}",
        "NOT_BELOW(": f"#define NOT_BELOW(x, low, status) if (!((x) >= (low))) {{ return ({real})NAN; }}",
        "NOT_ABOVE(": f"#define NOT_ABOVE(x, high, status) if (!((x) <= (high))) {{ return ({real})NAN; }}",
    }
    lines = ["/* ... and here one state with equal limbs side by side; what fails is NaN, all bits set. */"]
    for line in one_state(model, precision, ())[1:]:
        if line.startswith("    if (!(("):
            continue
        name = next((name for name in changed if line.startswith(f"#define {name}")), "")
        lines.append(changed[name] if name else line)
    return [*lines, *c_limb_macros.side_by_side(model, limbs, f"-{zero}")]
