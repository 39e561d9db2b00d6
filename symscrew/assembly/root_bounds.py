"""How many zeros a structure can have, by Groebner bases: exactly, or modulo two primes, right with probability one.

    numbers of one mechanism, exactly --closure_ideal--> dimension of its zeros, their number: proved
    numbers modulo p --the same--> dimension, number;  others, modulo another prime --the larger of both--> a bound

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
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.assembly.angle_numbers import ideal_in_tangent
from symscrew.assembly.closure_ideal import ClosureIdeal, Exactly, Modulo
from symscrew.assembly.closure_structure import Structure
from symscrew.assembly.equal_axes import axis_of, axis_pairs
from symscrew.assembly.exact_slots import exact_equations
from symscrew.assembly.residues import LARGEST_PRIME, residues_of
from symscrew.assembly.what_is_held import Held
from symscrew.mobility import ALGEBRA_PROGRAM, NotDecidableError, algebra_answer
from symscrew.runtime import entry, key_of

Array = np.ndarray[Any, Any]

STORED = Path(__file__).with_name("start_systems.json")
"""Written by `python -m symscrew.assembly.stored_systems`."""
SECONDS = 20.0
"""Of the processor; modulo a prime a platform on six legs takes 0.2 s."""
EXACT_SECONDS = 3.0
"""Of the processor, with exact numbers: delta and 3-UPU take 0.5 and 2 s. General platforms on six legs, whose numbers
have hundreds of digits on the way, do not end in it."""
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


def family_bound(structure: Structure) -> Bound | str:
    """That of all mechanisms of one structure, or why there is none."""
    ideals = [_general(structure, prime) for prime in (LARGEST_PRIME, SECOND_PRIME)]
    return _bound(ideals, "for every mechanism of this structure: Groebner bases modulo two primes at two of them")


def _general(structure: Structure, prime: int) -> ClosureIdeal:
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
    return ClosureIdeal(structure, slots, Modulo(prime))


def _hinge(structure: Structure, slot: int) -> bool:
    """Whether an axis is that of a hinge: in a planar mechanism it is no free choice."""
    return any(slot in group.slots and group.kind == "turn" for group in structure.groups)


def exact_bound(held: Held, seconds: float = EXACT_SECONDS) -> Bound | str:
    """The number of zeros of a mechanism with these values held, proved, or why it is not known."""
    try:
        ideal = _exact(held)
    except NotDecidableError as error:
        return f"its numbers are in no field that is decidable: {error}"
    return _bound([ideal], "of this very mechanism: Groebner basis of its exact numbers", seconds=seconds)


def _exact(held: Held) -> ClosureIdeal:
    """A mechanism in its own numbers; raises NotDecidableError."""
    try:
        exact = exact_equations(held)
    except NotDecidableError:  # an angle that is a fraction [rad]
        return ideal_in_tangent(held)
    return ClosureIdeal(exact.equations.structure, exact.slots, Exactly(exact.field))


def own_bound(held: Held) -> Bound | str:
    """That of a mechanism with these values held, or why there is none."""
    try:
        ideals = _own(held)
    except NotDecidableError as error:
        return f"its numbers are in no field that is decidable: {error}"
    return _bound(ideals, "for this very mechanism: Groebner bases of its numbers modulo two primes")


def _own(held: Held) -> list[ClosureIdeal]:
    """A mechanism modulo two primes; raises NotDecidableError."""
    structure, slots, prime = residues_of(held)
    again, others, second = residues_of(held, most=prime - 1)
    return [ClosureIdeal(structure, slots, Modulo(prime)), ClosureIdeal(again, others, Modulo(second))]


def regular_bound(held: Held) -> Bound | str:
    """That of the regular zeros of a mechanism, where dF has full rank, or why there is none.

    Adjoined is u det(A dF) = 1, with dF along the motions of all groups and A a matrix of general numbers: every
    regular zero has one u.
    """
    try:
        ideals = _own(held)
    except NotDecidableError as error:
        return f"its numbers are in no field that is decidable: {error}"
    groups = ideals[0].structure.groups
    if any(g.kind not in ("turn", "slide") for g in groups) or len(groups) > MOST_GROUPS:
        return f"regular zeros are counted of at most {MOST_GROUPS} turns and slides"
    how = (
        "on regular ones of this very mechanism: Groebner bases of its numbers and of u det(A dF) = 1 modulo two primes"
    )
    return _bound(ideals, how, regular=True)


def _bound(ideals: Sequence[ClosureIdeal], how: str, *, regular: bool = False, seconds: float = SECONDS) -> Bound | str:
    """The largest of the bounds of these ideals, or why one of them has none.

    What is found is kept, and how long was looked for what was not.
    """
    programs = [ideal.program(regular=regular) for ideal in ideals]
    key = _key(programs)
    stored = stored_entries().get(key)
    if stored is not None:
        count, dimension = stored["own"]
        return Bound(count, dimension, how)
    with entry(key) as kept:
        content = kept.read()
        known = None if content is None else json.loads(content)
        if isinstance(known, list):
            count, dimension = known
            return Bound(count, dimension, how)
        if known is not None and seconds <= known:
            return _not_ended(known)
        bounds = list[Bound]()
        for ideal, program in zip(ideals, programs, strict=True):
            found = _run(program, ideal.covers, how, seconds)
            if isinstance(found, str):
                if found == _not_ended(seconds):
                    kept.write(json.dumps(seconds).encode())
                return found
            bounds.append(found)
        largest = max(bounds, key=lambda bound: (bound.dimension, bound.count))
        kept.write(json.dumps([largest.count, largest.dimension]).encode())
    return largest


def _key(programs: Sequence[str]) -> str:
    return key_of(b"root bound", *(program.encode() for program in programs))


def own_keys(held: Held) -> tuple[str, str]:
    """Under which `own_bound` and `exact_bound` of these values are stored; raises NotDecidableError."""
    return _key([ideal.program() for ideal in _own(held)]), _key([_exact(held).program()])


@cache
def stored_entries() -> Mapping[str, Any]:
    """What comes with the package: key -> start system, or bound of one mechanism at its reference."""
    return dict(json.loads(STORED.read_text())) if STORED.is_file() else {}


def _not_ended(seconds: float) -> str:
    return f"the Groebner basis did not end within {seconds:g} s of the processor"


def _run(script: str, covers: int, how: str, seconds: float) -> Bound | str:
    answer = algebra_answer(script, seconds)
    if answer is None:
        return f"a bound needs the program {ALGEBRA_PROGRAM}, which is not on the path"
    output, ended = answer
    if not ended:
        return _not_ended(seconds)
    found = re.search(r"@zeros (-?\d+) (-?\d+)", output)
    if found is None:
        return f"{ALGEBRA_PROGRAM} did not accept the equations"
    dimension, count = int(found[1]), int(found[2])
    if dimension < 0:
        return Bound(0, -1, how)
    if dimension > 0:
        return Bound(-1, dimension, how)
    return Bound(count // covers, 0, how)
