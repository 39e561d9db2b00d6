"""Macros by which stages of equal limbs (see `c_limbs`) work on one limb, or on all of them in the lanes of a vector.

OF4(a, b, c, d)     limb == 0 ? a : limb == 1 ? b ...      or  (vector){a, b, c, d}
OWN(x)              x[limb]                                or  x
"""

from __future__ import annotations

from collections.abc import Sequence

LETTERS = "abcdefgh"
OF_ALL = ("STAGE", "LIMBS", "FIRST_LIMB", "NEXT_LIMB", "OWN", "GIVEN", "ALONE")
BY_COUNT = ("EACH", "LIMB", "NUMBER", "OF", "IN_EACH", "WRITE", "SQRT", "SMALL", "FINITE_UNLESS", "FINITE")


def names(limbs: Sequence[int]) -> list[str]:
    """All of these macros."""
    return [*OF_ALL, *(f"{name}{n}" for n in limbs for name in BY_COUNT)] if limbs else []


def types(value: str, name: str, limbs: Sequence[int]) -> list[str]:
    """Types of one value per limb: `name` and their number."""
    return [f"typedef {value} {name}{n}[{n}];" for n in limbs]


def one_by_one(model: str, kind: str, each: str, *, real: str, limbs: Sequence[int]) -> list[str]:
    """Of one limb, whose number is `limb`; `each` is the name of types."""
    if not limbs:
        return []
    upper, symbol = model.upper(), f"{model}_##function##{kind}_limb"
    lines = [
        "/* Stages are what equal limbs do, written once: here of the limb with the number `limb`. Values have the",
        "   names of the theory without the limb's. OWN(x): what a limb hands on; limbs.x[0]: that of the first limb;",
        "   GIVEN(x): what each limb is given; sign1 ...: 1 or -1 by limb, where equal limbs mirror each other. */",
        f"#define STAGE(function, n) static inline {upper}_INLINE void {symbol}##n",
        f"#define LIMBS(function) {symbol}s",
        f"#define FIRST_LIMB(k, function, n, ...) {symbol}##n(k, __VA_ARGS__)",
        f"#define NEXT_LIMB(k, function, n, ...) {symbol}##n(k, __VA_ARGS__)",
        "#define OWN(x) own->x[limb]",
        "#define GIVEN(x) (x)[limb]",
        "#define ALONE(x) (x)",
    ]
    for n in limbs:
        letters = LETTERS[:n]
        chosen = "".join(f"limb == {k} ? ({a}) : " for k, a in enumerate(letters[:-1])) + f"({letters[-1]})"
        listed = ", ".join(letters)
        lines += [
            f"#define EACH{n} {each}{n}",
            f"#define LIMB{n} REAL",
            f"#define NUMBER{n} {real}",
            f"#define OF{n}({listed}) ({chosen})",
            f"#define IN_EACH{n}(read, array, first, step) read(array, (first) + (step) * limb)",
            f"#define WRITE{n}(array, {listed}, x) WRITE(array, OF{n}({listed}), x)",
            f"#define SQRT{n}(x) SQRT(x)",
            f"#define SMALL{n}(x, {listed}) ({' OR '.join(f'SMALL((x)[{k}], {a})' for k, a in enumerate(letters))})",
            f"#define FINITE_UNLESS{n}(small, sum, each) FINITE_UNLESS(small, sum)",
            f"#define FINITE{n}(sum, each) FINITE(sum)",
        ]
    return lines


def side_by_side(model: str, limbs: int, minus_zero: str) -> list[str]:
    """Of all limbs at once: whichever is called first, in text, stands for all of them."""
    upper, vector, n = model.upper(), f"{model}_vector{limbs}", limbs
    symbol, letters = f"{model}_##function##_lanes", LETTERS[:limbs]
    listed = ", ".join(letters)
    places = ["first", "(first) + (step)", *(f"(first) + {k} * (step)" for k in range(2, n))]
    writes = " ".join(f"WRITE(array, {a}, out_[{k}]);" for k, a in enumerate(letters))
    return [
        f"#define STAGE(function, n) static inline {upper}_INLINE void {symbol}##n",
        f"#define LIMBS(function) {symbol}",
        f"#define FIRST_LIMB(k, function, n, ...) {symbol}##n(k, __VA_ARGS__)",
        "#define NEXT_LIMB(k, function, n, ...) (void)0",
        "#define OWN(x) own->x",
        "#define GIVEN(x) (x)",
        f"#define ALONE(x) ({minus_zero}) /* adds nothing: limbs are summed together */",
        *(f"#define {name}{n} {vector}" for name in ("EACH", "LIMB", "NUMBER")),
        f"#define OF{n}({listed}) ({vector}){{{listed}}}",
        f"#define IN_EACH{n}(read, array, first, step) \\",
        f"    ({vector}){{{', '.join(f'read(array, {place})' for place in places)}}}",
        f"#define WRITE{n}(array, {listed}, x) {{ const {vector} out_ = (x); {writes} }}",
        f"#define SQRT{n}(x) {vector}_sqrt(x)",
        f"#define SMALL{n}(x, {listed}) (((x) <= OF{n}({listed})) & ((x) >= -OF{n}({listed})))",
        f"#define FINITE_UNLESS{n}(small, sum, each) \\",
        f"    (void)stride, (void)total; return (sum) + {vector}_sum(({vector})(({vector}_mask)(each) | (small)))",
        f"#define FINITE{n}(sum, each) (void)stride, (void)total; return (sum) + {vector}_sum(each)",
    ]
