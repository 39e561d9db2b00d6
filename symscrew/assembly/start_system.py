"""All zeros of one general member of a structure's family, found once: by monodromy, up to the proved bound.

    a known zero of the mechanism --way to random complex numbers--> a zero of a general member
    zeros --loops through other random members--> further zeros, until there are as many as the bound or no more come

Where all numbers are free, loops permute the zeros so that each comes from each: every equation has a number of its own
that it fixes, so that pairs of members and zeros are one piece. Where only what is held is free, there may be several
pieces, and the search is a sample. (T. Duff, C. Hill, A. Jensen, K. Lee, A. Leykin, J.
Sommars, Solving polynomial systems via homotopy continuation and monodromy, 2019.) What was found is kept: in the
package for common structures, else in the user's cache.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.families import Family
from symscrew.assembly.path_tracking import Tracker
from symscrew.assembly.root_bounds import Bound, family_bound, stored_entries
from symscrew.runtime import entry, key_of

Array = np.ndarray[Any, Any]

SEED = 20231009
"""Of the random members: always the same, so that results repeat."""
MOST_LOOPS = 40
"""Through three members each; forty zeros take eight."""
MEMBERS = 3
"""General members to which a way is tried: one can pass near a place where solutions go to infinity."""
QUIET = 8
"""Loops after the last new zero at which a search without a bound ends."""
SAME = 1 - 1e-9
"""Points of length one whose product is above this are one: zeros of random members are 1e-3 apart."""
STARTS, STEPS, STILL = (100, 1000, 4000), 40, 1e-12
"""Of Newton's method where no path leads away from the reference: places, more of them where it came to no zero, steps,
a step at a zero. Of loops of slides and a ball one place in two hundred leads to a displacement, others to infinity."""
FINITE = 1e-4
"""|x|^2 of points of length one that are displacements."""
FORMAT = "3"
"""Of what is kept: another one is not read."""


@dataclass(frozen=True)
class StartSystem:
    """A general member of the family, its zeros [count x coordinates], the bound, whether all are found.

    `bound`: None where the program for it is missing or the family has none. `why`: then, the reason.
    """

    member: tuple[Any, ...]
    zeros: Array
    bound: Bound | None
    why: str = ""

    @property
    def complete(self) -> bool:
        """Whether there are as many zeros as the bound has: no other member has more isolated ones."""
        return self.bound is not None and self.bound.count == len(self.zeros)


def start_system(family: Family, known: Array, progress: Callable[[str], None] = lambda _: None) -> StartSystem:
    """The kept one of this family, or a new one from a zero of the mechanism itself."""
    key = start_key(family)
    stored = stored_entries().get(key)
    if stored is not None:
        return decoded(stored)
    with entry(key) as kept:
        content = kept.read()
        found = None if content is None else decoded(json.loads(content))
        if found is not None and len(found.zeros) and _finite(family.equations, found.zeros).any():
            return found
        made = searched(family, known, progress)
        if len(made.zeros):  # a search that did not leave this mechanism may succeed from another of its structure
            kept.write(json.dumps(encoded(made)).encode())
    return made


def start_key(family: Family) -> str:
    """Under which its start system is kept."""
    return key_of(b"start system", FORMAT.encode(), family.key.encode())


def searched(family: Family, known: Array, progress: Callable[[str], None] = lambda _: None) -> StartSystem:
    """A start system by monodromy."""
    random, equations = np.random.default_rng(SEED), family.equations
    found = family_bound(equations.structure) if family.whole else "only what is held is free in this family"
    bound = found if isinstance(found, Bound) and found.dimension == 0 else None
    tracker = Tracker(equations)
    for _ in range(MEMBERS):
        member = family.random(random)
        first = tracker.follow(known[None], family.way(family.own, member).at)
        zeros, quiet = first.z[first.reached & _finite(equations, first.z)], 0
        if len(zeros):
            break
    if not len(zeros) and family.whole:  # a singular reference is left on no way
        zeros = _by_newton(tracker, family.way(member, member).at(np.zeros(1)), random)
    for _ in range(MOST_LOOPS):
        if not len(zeros) or (bound is not None and len(zeros) >= bound.count) or (bound is None and quiet == QUIET):
            break
        back, here = zeros, member
        for there in (family.random(random), family.random(random), member):
            ends = tracker.follow(back, family.way(here, there).at)
            back, here = ends.z[ends.reached], there
        before = len(zeros)
        for z in back:
            if not together(equations, zeros, z).any():
                zeros = np.concatenate([zeros, z[None]])
        quiet = 0 if len(zeros) > before else quiet + 1
        progress(f"start system: {len(zeros)} of {'an unknown number' if bound is None else bound.count}")
    why = "" if bound is not None else found if isinstance(found, str) else "general members have no isolated zeros"
    return StartSystem(tuple(member), zeros, bound, why)


def _by_newton(tracker: Tracker, numbers: Array, random: np.random.Generator) -> Array:
    """A regular zero of a general member, by Newton's method from random places; none where it finds none."""
    equations = tracker.equations
    for count in STARTS:
        places = random.normal(size=(count, equations.width)) + 1j * random.normal(size=(count, equations.width))
        z, last = equations.scaled(places), np.full(count, np.inf)
        with np.errstate(all="ignore"):
            for _ in range(STEPS):
                step = tracker.newton(z, numbers)
                last = np.linalg.norm(step, axis=1)
                z = equations.scaled(np.nan_to_num(z + step, nan=1.0, posinf=1.0, neginf=1.0))
            sound = (last < STILL) & _finite(equations, z)
        if sound.any():
            break
    return np.asarray(z[sound][:1])


def _finite(equations: BatchEquations, z: Array) -> Array:
    """Which points are displacements: from those at infinity, as of a singular reference, no way leads to others."""
    return np.asarray(equations.norms(equations.scaled(z)).min(axis=1, initial=1.0) > FINITE)


def together(equations: BatchEquations, zeros: Array, z: Array, same_above: float = SAME) -> Array:
    """Which of the zeros, groups of length one, is the same as z."""
    same = np.ones(len(zeros), dtype=bool)
    for part in equations.parts:
        same &= np.abs(zeros[:, part].conj() @ z[part]) > same_above
    return same


def encoded(system: StartSystem) -> dict[str, Any]:
    """As JSON values: numbers to the last bit."""
    return {
        "member": [[_bytes(np.asarray(s, dtype=complex)), np.ndim(s)] for s in system.member],
        "zeros": [_bytes(system.zeros), len(system.zeros)],
        "bound": None if system.bound is None else [system.bound.count, system.bound.dimension, system.bound.how],
        "why": system.why,
    }


def decoded(values: dict[str, Any]) -> StartSystem:
    """What `encoded` has made."""
    member = [_array(text) if ndim else complex(_array(text)[0]) for text, ndim in values["member"]]
    text, count = values["zeros"]
    bound = None if values["bound"] is None else Bound(*values["bound"])
    return StartSystem(tuple(member), _array(text).reshape(count, -1 if count else 0), bound, values["why"])


def _bytes(values: Array) -> str:
    return base64.b64encode(np.ascontiguousarray(values).astype("<c16").tobytes()).decode()


def _array(text: str) -> Array:
    return np.frombuffer(base64.b64decode(text), dtype="<c16").astype(complex)
