"""Sines and cosines of a function's angles, four at a time where the machine can, in C.

Half of the time of a lean function goes into sines and cosines of its input angles. They are independent of
each other, so they are gathered in front of everything else and handed in fours to `<model>_sincos`, which
uses glibc's vector functions under AVX2 and calls `sin` and `cos` one by one elsewhere (or everywhere, if
`<MODEL>_SCALAR` is defined). The vector functions are accurate to a unit in the last place or so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.export.listing import Operand
from symscrew.program import Instruction

LANES = 4
SIMPLE = frozenset(("add", "sub", "neg"))  # what may be computed before the sines: offsets of input angles


@dataclass(frozen=True)
class Angles:
    """Instructions to print first, (angle, sine, cosine) slots to gather, and the instructions that remain."""

    first: tuple[Instruction, ...]
    gathered: tuple[tuple[int, int, int], ...]
    rest: tuple[Instruction, ...]


def gather(live: Sequence[Instruction]) -> Angles:
    """Angles made of inputs by additions whose sine and cosine are both needed, if there are several."""
    defined = {i.target: i for i in live}
    sines = {i.args[0]: i.target for i in live if i.op == "sin"}
    cosines = {i.args[0]: i.target for i in live if i.op == "cos"}
    gathered, first = [], set()
    for angle in (a for a in sines if a in cosines and isinstance(a, int)):
        below = _simple_definitions(angle, defined)
        if below is not None:
            gathered.append((angle, sines[angle], cosines[angle]))
            first |= below
    if len(gathered) < 2:
        return Angles((), (), tuple(live))
    done = first | {slot for _, sine, cosine in gathered for slot in (sine, cosine)}
    return Angles(
        tuple(i for i in live if i.target in first),
        tuple(gathered),
        tuple(i for i in live if i.target not in done),
    )


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


def prologue(model: str) -> list[str]:
    """The function that takes sines and cosines of up to four angles."""
    upper = model.upper()
    lanes = " && ".join(f"defined({m})" for m in ("__GNUC__", "__GLIBC__", "__x86_64__", "__AVX2__"))
    arguments = "int count, const double angle[4], double sine[4], double cosine[4]"
    return [
        f"/* Sines and cosines of `count` angles out of four lanes; define {upper}_SCALAR to take them one by one. */",
        f"#if {lanes} && !defined({upper}_SCALAR)",
        f"typedef double {model}_lanes __attribute__((vector_size(32)));",
        f"{model}_lanes _ZGVdN4v_sin({model}_lanes);",
        f"{model}_lanes _ZGVdN4v_cos({model}_lanes);",
        f"static inline void {model}_sincos({arguments})",
        "{",
        f"    const {model}_lanes all = {{angle[0], angle[1], angle[2], angle[3]}};",
        f"    const {model}_lanes s = _ZGVdN4v_sin(all);",
        f"    const {model}_lanes c = _ZGVdN4v_cos(all);",
        "    for (int k = 0; k < count; ++k) {",
        "        sine[k] = s[k];",
        "        cosine[k] = c[k];",
        "    }",
        "}",
        "#else",
        f"static inline void {model}_sincos({arguments})",
        "{",
        "    for (int k = 0; k < count; ++k) {",
        "        sine[k] = sin(angle[k]);",
        "        cosine[k] = cos(angle[k]);",
        "    }",
        "}",
        "#endif",
    ]


def calls(model: str, angles: Angles, prefix: str, operand: Operand) -> list[str]:
    """The gathered sines and cosines of a function, as constants."""
    lines = []
    for start in range(0, len(angles.gathered), LANES):
        group = angles.gathered[start : start + LANES]
        padded = [operand(angle) for angle, _, _ in group]
        padded += [padded[-1]] * (LANES - len(padded))
        number = start // LANES
        angle, sine, cosine = (f"{name}{number}" for name in ("angle", "sine", "cosine"))
        lines += [
            f"    const double {angle}[4] = {{{', '.join(padded)}}};",
            f"    double {sine}[4], {cosine}[4];",
            f"    {model}_sincos({len(group)}, {angle}, {sine}, {cosine});",
        ]
        for k, (_, s, c) in enumerate(group):
            lines.append(f"    const double {prefix}{s} = {sine}[{k}];")
            lines.append(f"    const double {prefix}{c} = {cosine}[{k}];")
    return lines
