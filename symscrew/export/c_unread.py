"""Inputs that are only checked, four side by side in C: of a function that leaves out what a scene does not call for,
they may be most of what it reads (a tenth of the time of a delta's drives one by one).

Vectors of GCC and clang where the machine has them, else the same sums in plain C.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from symscrew.export.c_precision import Precision
from symscrew.export.listing import balanced_sum

FOUR = 4  # entries that are added at once: those of one AVX register of doubles


def prologue(model: str, precision: Precision) -> list[str]:
    """What adds four entries that follow each other, where vectors of four hold them and where not."""
    upper, real, size = model.upper(), precision.real, precision.size
    vector = f"__attribute__((vector_size({FOUR * size})"
    return [
        "",
        f"#if defined(__GNUC__) && defined(__AVX__) && !defined({upper}_SCALAR)",
        f"typedef {real} {model}_four {vector}));",
        f"typedef {real} {model}_four_there {vector}, aligned({size}), may_alias));",
        f"#define {upper}_FOUR(x) (*(const {model}_four_there *)(x))",
        f"#define {upper}_SUM(four) (((four)[0] + (four)[1]) + ((four)[2] + (four)[3]))",
        "#else",
        f"typedef {real} {model}_four;",
        f"#define {upper}_FOUR(x) (((x)[0] + (x)[1]) + ((x)[2] + (x)[3]))",
        f"#define {upper}_SUM(four) (four)",
        "#endif",
    ]


def fours(entries: Mapping[int, tuple[str, int]], slots: Iterable[int]) -> tuple[list[int], list[int]]:
    """The first slots of fours of entries that follow each other, if there are several, and all other slots."""
    slots = list(slots)
    at = {entries[slot]: slot for slot in slots if slot in entries}
    firsts: list[int] = []
    together: set[int] = set()
    for (array, k), slot in sorted(at.items()):
        run = [(array, k + n) for n in range(FOUR)]
        if all(entry in at for entry in run):
            firsts.append(slot)
            together |= {at.pop(entry) for entry in run}
    return (firsts, [slot for slot in slots if slot not in together]) if len(firsts) > 1 else ([], slots)


def statement(model: str, entries: Mapping[int, tuple[str, int]], firsts: Iterable[int]) -> str:
    """The statement that adds all fours."""
    places = ((array, k) for array, k in (entries[slot] for slot in firsts))
    terms = [f"{model.upper()}_FOUR({f'{array} + {k}' if k else array})" for array, k in places]
    return f"const {model}_four fours = {balanced_sum(terms)};"


def total(model: str) -> str:
    """The sum of all entries of all fours."""
    return f"{model.upper()}_SUM(fours)"
