"""How many zeros a structure can have, by Groebner bases modulo two primes: a computation, right with probability one.

    numbers modulo p in the slots --forms--> polynomials --Singular--> dimension of the zeros, their number
    the same with other numbers, modulo another prime --the larger of both--> the bound

A mechanism has at most as many zeros, with multiplicity, as it has modulo p, unless one of them goes to infinity there,
as that of p x = 1 does: p then divides one integer that belongs to the mechanism, or the numbers of the member that was
taken at random lie on one hypersurface. Few primes of 31 bits do, and both would have to. No theorem excludes it, so
that nobody says "proved" of it. A member of a family has at most as many isolated zeros as the general one (A. Morgan,
A. Sommese, 1989: parameter continuation). Homogeneous coordinates are cut by |x|^2 = 1, which gives every zero once for
each of two signs, and leaves out none.
"""

from __future__ import annotations

import json
import random
import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.assembly.closure_structure import WIDTH, Group, Structure
from symscrew.assembly.dual_forms import PRODUCT
from symscrew.assembly.equal_axes import axis_of, axis_pairs
from symscrew.assembly.residues import LARGEST_PRIME, residues_of
from symscrew.assembly.slot_numbers import matrices, spins_of
from symscrew.assembly.what_is_held import Held
from symscrew.mobility import NotDecidableError
from symscrew.runtime import entry, key_of

Array = np.ndarray[Any, Any]

PROGRAM = "Singular"
"""Of W. Decker, G.-M. Greuel, G. Pfister, H. Schoenemann; Debian's package is singular-ui."""
STORED = Path(__file__).with_name("start_systems.json")
"""Written by `python -m symscrew.assembly.stored_systems`."""
SECONDS = 20.0
"""By the clock; a platform on six legs takes 0.2 s."""
MOST_GROUPS = 5
"""Of which the determinant is expanded: of more it has too many terms."""
SECOND_PRIME = 2147483587
"""The next one below the largest."""
SEED = 20231009
"""Of the members of the family: always the same, so that results repeat."""


@dataclass(frozen=True)
class Bound:
    """At most `count` isolated zeros; `dimension` of all zeros over the complex numbers, -1 without any.

    `how`: the way it was found, for people.
    """

    count: int
    dimension: int
    how: str


@dataclass(frozen=True)
class Look:
    """The numbers of one mechanism modulo a prime, in the slots of its structure."""

    structure: Structure
    slots: Sequence[Any]
    prime: int


def family_bound(structure: Structure) -> Bound | str:
    """That of all mechanisms of one structure, or why there is none."""
    looks = [_general(structure, prime) for prime in (LARGEST_PRIME, SECOND_PRIME)]
    return _bound(looks, "for every mechanism of this structure: Groebner bases modulo two primes at two of them")


def _general(structure: Structure, prime: int) -> Look:
    """A member of the family whose numbers are taken at random."""
    rng = random.Random(SEED + LARGEST_PRIME - prime)
    slots: list[Any] = []
    for slot in structure.slots:
        if slot.kind in ("point", "axis"):
            if structure.planar and slot.kind == "axis" and _hinge(structure, len(slots)):
                slots.append([0, 0, 1])
                continue
            depth = 0 if structure.planar else rng.randrange(prime)
            slots.append([rng.randrange(prime), rng.randrange(prime), depth])
        elif slot.kind in ("turned", "slid"):
            slots.append([rng.randrange(prime), rng.randrange(prime), 0])
        else:
            slots.append(rng.randrange(prime))
    for pair in axis_pairs(structure):
        made = [axis_of([rng.randrange(prime) for _ in range(4)]) for _ in pair]
        for place, (axis, _), (_, other) in zip(pair, made, made[::-1], strict=True):
            slots[place] = [c * other % prime for c in axis]
    return Look(structure, slots, prime)


def _hinge(structure: Structure, slot: int) -> bool:
    """Whether an axis is that of a hinge: in a planar mechanism it is no free choice."""
    return any(slot in group.slots and group.kind == "turn" for group in structure.groups)


def own_bound(held: Held) -> Bound | str:
    """That of a mechanism with these values held, or why there is none."""
    try:
        looks = _own(held)
    except NotDecidableError as error:
        return f"its numbers are in no field that is decidable: {error}"
    return _bound(looks, "for this very mechanism: Groebner bases of its numbers modulo two primes")


def _own(held: Held) -> list[Look]:
    """A mechanism modulo two primes; raises NotDecidableError."""
    one = Look(*residues_of(held))
    return [one, Look(*residues_of(held, most=one.prime - 1))]


def regular_bound(held: Held) -> Bound | str:
    """That of the regular zeros of a mechanism, where dF has full rank, or why there is none.

    Adjoined is u det(A dF) = 1, with dF along the motions of all groups and A a matrix of general numbers: every
    regular zero has one u.
    """
    try:
        looks = _own(held)
    except NotDecidableError as error:
        return f"its numbers are in no field that is decidable: {error}"
    groups = looks[0].structure.groups
    if any(g.kind not in ("turn", "slide") for g in groups) or len(groups) > MOST_GROUPS:
        return f"regular zeros are counted of at most {MOST_GROUPS} turns and slides"
    how = (
        "on regular ones of this very mechanism: Groebner bases of its numbers and of u det(A dF) = 1 modulo two primes"
    )
    return _bound(looks, how, regular=True)


def _bound(looks: Sequence[Look], how: str, *, regular: bool = False) -> Bound | str:
    """The larger of the bounds at all looks, or why one of them has none."""
    scripts = [_script(look.structure, look.slots, look.prime, regular=regular) for look in looks]
    key = _key(scripts)
    stored = stored_entries().get(key)
    if stored is not None:
        count, dimension = stored["own"]
        return Bound(count, dimension, how)
    with entry(key) as kept:
        content = kept.read()
        if content is not None:
            count, dimension = json.loads(content)
            return Bound(count, dimension, how)
        bounds = list[Bound]()
        for script, covers in scripts:
            found = _run(script, covers, how)
            if isinstance(found, str):
                return found
            bounds.append(found)
        largest = max(bounds, key=lambda bound: (bound.dimension, bound.count))
        kept.write(json.dumps([largest.count, largest.dimension]).encode())
    return largest


def _key(scripts: Sequence[tuple[str, int]]) -> str:
    return key_of(b"root bound", *(script.encode() for script, _ in scripts))


def own_key(held: Held) -> str:
    """Under which `own_bound` of these values is stored; raises NotDecidableError."""
    return _key([_script(look.structure, look.slots, look.prime) for look in _own(held)])


@cache
def stored_entries() -> Mapping[str, Any]:
    """What comes with the package: key -> start system, or bound of one mechanism at its reference."""
    return dict(json.loads(STORED.read_text())) if STORED.is_file() else {}


def _run(script: str, covers: int, how: str) -> Bound | str:
    program = shutil.which(PROGRAM)
    if program is None:
        return f"a bound needs the program {PROGRAM}, which is not on the path"
    try:
        done = subprocess.run(
            [program, "--quiet", "--no-rc"], input=script, capture_output=True, text=True, timeout=SECONDS
        )
    except subprocess.TimeoutExpired:
        return f"the Groebner basis did not end within {SECONDS:g} s"
    found = re.search(r"@zeros (-?\d+) (-?\d+)", done.stdout)
    if found is None:
        return f"{PROGRAM} did not accept the equations"
    dimension, count = int(found[1]), int(found[2])
    if dimension < 0:
        return Bound(0, -1, how)
    if dimension > 0:
        return Bound(-1, dimension, how)
    return Bound(count // covers, 0, how)


def _script(structure: Structure, slots: Sequence[Any], prime: int, *, regular: bool = False) -> tuple[str, int]:
    """(the program, how often every zero is counted); `regular`: with what singular zeros do not fulfil."""
    motions, loops = matrices(structure, slots)
    names, made, cuts = list[str](), list[str](), list[str]()
    covers = 1
    for k, group in enumerate(structure.groups):
        own = [f"z{k}_{i}" for i in range(WIDTH[group.kind])]
        names += own
        made += [_sum([(motions[k][i, j], own[j]) for j in range(len(own))], prime) for i in range(8)]
        cuts.append(_cut(structure.groups[k], own, slots, prime))
        covers *= 1 if group.kind == "slide" else 2
        if group.kind == "free":
            cuts.append("+".join(f"{own[i]}*{own[4 + i]}" for i in range(4)))
    for spin, motion in zip(structure.spins, spins_of(structure), strict=True):
        own = [f"z{spin.group}_{j}" for j in range(WIDTH[structure.groups[spin.group].kind])]
        made += [_sum([(motion[i, j], own[j]) for j in range(len(own))], prime) for i in range(8)]
    lines = [f"poly f{k // 8}_{k % 8} = {text};" for k, text in enumerate(made)]
    equations = [*cuts]
    for n, (square, linear) in enumerate(loops):
        lines += _loop_lines(structure, n, prime)
        g = [f"g{n}_{i}" for i in range(8)]
        for form in square:
            equations.append(
                _sum(
                    [(form[i, j] * (1 if i == j else 2), f"{g[i]}*{g[j]}") for i in range(8) for j in range(i, 8)],
                    prime,
                )
            )
        equations += [_sum([(row[i], g[i]) for i in range(8)], prime) for row in linear]
    only = _regular_lines(structure, slots, len(equations) - len(cuts), prime) if regular else []
    names += ["u"] * regular
    text = "\n".join(lines)
    ideal = ",\n".join(equations)
    return (
        f"ring r = {prime},({','.join(names)}),dp;\n{text}\nideal i = {ideal};\n{''.join(only)}ideal s = slimgb(i);\n"
        "int d = dim(s); int v = 0; if (d == 0) { v = vdim(s); }\n"
        'print("@zeros " + string(d) + " " + string(v));\nquit;\n'
    ), covers


def _regular_lines(structure: Structure, slots: Sequence[Any], rows: int, prime: int) -> list[str]:
    """Adjoins u det(A dF) - 1 to the ideal i: its first entries are the cuts, the others the equations."""
    rng, count = random.Random(SEED), len(structure.groups)
    lines = ["poly p;\n", f"matrix m[{count}][{count}];\n"]
    for row in range(count):
        terms = (f"{rng.randrange(1, prime)}*i[{count + k + 1}]" for k in range(rows))
        lines.append(f"p = {'+'.join(terms)};\n")
        for column, group in enumerate(structure.groups):
            one, two = f"z{column}_0", f"z{column}_1"
            square = sum(c * c for c in slots[group.slots[0]]) % prime
            around = f"{one}*diff(p, {two})-{square}*{two}*diff(p, {one})"
            lines.append(f"m[{row + 1},{column + 1}] = {f'diff(p, {two})' if group.kind == 'slide' else around};\n")
    return [*lines, "i = i, u*det(m)-1;\n"]


def _cut(group: Group, names: Sequence[str], slots: Sequence[Any], prime: int) -> str:
    """The equation that leaves one point, or two, of each displacement of a group."""
    if group.kind == "slide":
        return f"{names[0]}-1"
    if group.kind == "turn":
        axis = slots[group.slots[0]]
        return f"{names[0]}^2+{sum(c * c for c in axis) % prime}*{names[1]}^2-1"
    return "+".join(f"{name}^2" for name in names[: 2 if group.kind == "planar" else 4]) + "-1"


def _loop_lines(structure: Structure, n: int, prime: int) -> list[str]:
    """The displacement around a loop as a product."""
    loop = structure.loops[n]
    one, two = structure.chains[loop.base], structure.chains[loop.body]
    common = 0
    while common < min(len(one), len(two)) and one[common] == two[common]:
        common += 1
    factors = [(k, True) for k in reversed(one[common:])] + [(k, False) for k in two[common:]]
    factors += [(len(structure.groups) + k, back) for k, back in loop.spins]
    lines = []
    before: list[str] = []
    for place, (k, back) in enumerate(factors):
        sign = ["", "-", "-", "-"] * 2 if back else [""] * 8
        own = [f"{sign[i]}f{k}_{i}" for i in range(8)]
        after = own if not before else _product(before, own, prime)
        last = place == len(factors) - 1
        names = [f"g{n}_{i}" if last else f"h{n}_{place}_{i}" for i in range(8)]
        lines += [f"poly {name} = {text};" for name, text in zip(names, after, strict=True)]
        before = names
    return lines


def _product(a: Sequence[str], b: Sequence[str], prime: int) -> list[str]:
    return [
        _sum([(int(PRODUCT[k, i, j]), f"{a[i]}*({b[j]})") for i in range(8) for j in range(8)], prime) for k in range(8)
    ]


def _sum(terms: Sequence[tuple[Any, str]], prime: int) -> str:
    parts = [f"{int(c) % prime}*{name}" for c, name in terms if int(c) % prime]
    return "+".join(parts) or "0"
