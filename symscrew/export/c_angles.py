"""Sines and cosines of a function's angles, several at a time where the machine can, in C.

Half of the time of a lean function goes into sines and cosines of its input angles. They are independent of
each other, so they are gathered in front of everything else and handed in groups to `<model>_sincos`, which
uses glibc's vector functions under AVX2 and calls `sin` and `cos` one by one elsewhere (or everywhere, if
`<MODEL>_SCALAR` is defined). The vector functions are accurate to a unit in the last place or so.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from symscrew.export.c_precision import Precision
from symscrew.program import Instruction

SIMPLE = frozenset(("add", "sub", "neg"))  # what may be computed before the sines: offsets of input angles


@dataclass(frozen=True)
class Angles:
    """Instructions to compute first, (angle, sine, cosine) slots to gather, and the instructions that remain.

    A sine or cosine that nothing reads is None. Instructions of the first that the remaining ones read are
    among these, too.
    """

    first: tuple[Instruction, ...]
    gathered: tuple[tuple[int, int | None, int | None], ...]
    rest: tuple[Instruction, ...]


def gather(live: Sequence[Instruction], results: Iterable[int]) -> Angles:
    """Angles that are inputs or made of inputs by additions; `results` are slots that must remain."""
    defined = {i.target: i for i in live}
    sines = {i.args[0]: i.target for i in live if i.op == "sin"}
    cosines = {i.args[0]: i.target for i in live if i.op == "cos"}
    found: list[tuple[int, tuple[int, int | None, int | None], set[int]]] = []
    for angle in dict.fromkeys((*(a for a in sines if a in cosines), *sines, *cosines)):
        below = _simple_definitions(angle, defined) if isinstance(angle, int) else None
        if below is not None and isinstance(angle, int):
            entry = (angle, sines.get(angle), cosines.get(angle))
            found.append((_first_input(angle, defined), entry, below))
    found.sort(key=lambda item: item[0])  # as they stand in the inputs: functions of the same angles share their text
    gathered = [entry for _, entry, _ in found]
    first = {slot for *_, below in found for slot in below}
    done = {slot for _, *pair in gathered for slot in pair if slot is not None}
    rest = [i for i in live if i.target not in done]
    read = {a for i in rest if i.target not in first for a in i.args if isinstance(a, int)} | set(results)
    for i in reversed(rest):
        if i.target in first and i.target in read:
            read |= {a for a in i.args if isinstance(a, int)}
    owner = {slot: place for place, _, below in reversed(found) for slot in below}
    return Angles(
        tuple(sorted((i for i in live if i.target in first), key=lambda i: owner[i.target])),
        tuple(gathered),
        tuple(i for i in rest if i.target not in first or i.target in read),
    )


def _first_input(slot: int, defined: Mapping[int, Instruction]) -> int:
    """The first input entry that an angle is made of."""
    if slot not in defined:
        return slot
    return min((_first_input(a, defined) for a in defined[slot].args if isinstance(a, int)), default=slot)


def _simple_definitions(slot: int, defined: dict[int, Instruction]) -> set[int] | None:
    """The slots that must be computed before `slot`, itself included; None if more than additions are needed."""
    if slot not in defined:
        return set()  # an input
    instruction = defined[slot]
    if instruction.op not in SIMPLE:
        return None
    below = {slot}
    for arg in instruction.args:
        if isinstance(arg, int):
            inner = _simple_definitions(arg, defined)
            if inner is None:
                return None
            below |= inner
    return below


def prologue(model: str, precision: Precision) -> list[str]:
    """The function that takes sines and cosines of one group of angles or less."""
    upper, real, group = model.upper(), precision.real, precision.group
    sin, cos = precision.function("sin"), precision.function("cos")
    lanes = " && ".join(f"defined({m})" for m in ("__GNUC__", "__GLIBC__", "__x86_64__", "__AVX2__"))
    arguments = f"int count, const {real} *angle, {real} *sine, {real} *cosine"
    return [
        f"/* Sines and cosines of the first `count` of {group} angles; {upper}_SCALAR takes them one by one. */",
        f"#if {lanes} && !defined({upper}_SCALAR)",
        f"typedef {real} {model}_lanes __attribute__((vector_size(32)));",
        f"{model}_lanes _ZGVdN{group}v_{sin}({model}_lanes);",
        f"{model}_lanes _ZGVdN{group}v_{cos}({model}_lanes);",
        f"{upper}_UNUSED static inline {upper}_INLINE void {model}_sincos({arguments})",
        "{",
        "    if (count == 1) {",
        f"        sine[0] = {sin}(angle[0]);",
        f"        cosine[0] = {cos}(angle[0]);",
        "        return;",
        "    }",
        f"    const {model}_lanes all = {{{', '.join(f'angle[{k}]' for k in range(group))}}};",
        f"    const {model}_lanes s = _ZGVdN{group}v_{sin}(all);",
        f"    const {model}_lanes c = _ZGVdN{group}v_{cos}(all);",
        "    for (int k = 0; k < count; ++k) {",
        "        sine[k] = s[k];",
        "        cosine[k] = c[k];",
        "    }",
        "}",
        "#else",
        f"{upper}_UNUSED static inline {upper}_INLINE void {model}_sincos({arguments})",
        "{",
        "    for (int k = 0; k < count; ++k) {",
        f"        sine[k] = {sin}(angle[k]);",
        f"        cosine[k] = {cos}(angle[k]);",
        "    }",
        "}",
        "#endif",
    ]


def calls(model: str, count: int, precision: Precision) -> list[str]:
    """The calls that fill `sine` and `cosine` from `angle`, `count` of each."""
    lines = []
    for start in range(0, count, precision.group):
        plus = f" + {start}" if start else ""
        some = min(precision.group, count - start)
        lines.append(f"    {model}_sincos({some}, angle{plus}, sine{plus}, cosine{plus});")
    return lines
