"""Zeros that Krawczyk's test has no box for: where several meet, and of more equations than unknowns.

more equations than unknowns --Newton's method from random places--> zeros that no way led to
ends without a box --exact_roots--> in exact numbers
                   --overconstrained_way--> the one that the proved motion through the reference leads to
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.exact_roots import ExactRoots
from symscrew.assembly.families import Family
from symscrew.assembly.overconstrained_way import on_the_motion
from symscrew.assembly.path_tracking import Tracker
from symscrew.assembly.start_system import together
from symscrew.assembly.target_roots import APART, SINGULAR, Account, End
from symscrew.assembly.what_is_held import Held

Array = np.ndarray[Any, Any]

STARTS = 100
"""Random places from which zeros are looked for: a solution has a tenth of them and more."""
STEPS = 30
"""Of Newton's method by least squares."""
STILL = 1e-12
"""Of a step, and of a residual, at the end of it."""
SEED = 20251125
"""Of the random places: always the same, so that results repeat."""


def without_boxes(held: Held, family: Family, account: Account, known: Array) -> Account:
    """The account with proofs of ends for which there are no boxes. `known`: the zero of the reference."""
    equations = family.equations
    structure = equations.structure
    square = structure.unknowns == structure.equations
    member = family.member(dict(held.values))
    numbers = family.way(member, member).at(np.zeros(1))
    ends = list(account.ends) if square else [*account.ends, *_further(equations, numbers, account.ends)]
    if not any(_asks(end, square=square) for end in ends):
        return account
    exact = ExactRoots(held, equations)
    for k, end in enumerate(ends):
        root = exact.root(end.z, numbers[0]) if _asks(end, square=square) else None
        ends[k] = end if root is None else replace(end, z=root.z, exact=root)
    if not square and any(_asks(end, square=square) for end in ends):
        ends = _on_the_motion(held, equations, ends, known)
    return replace(account, ends=tuple(ends))


def _asks(end: End, *, square: bool) -> bool:
    """Whether a zero has no box."""
    known = end.proof is not None or end.exact is not None
    return end.kind == "real" and not known and not end.curve and not (end.regular and square)


def _further(equations: BatchEquations, numbers: Array, ends: Sequence[End]) -> list[End]:
    """Real zeros, regular ones, that are not among the ends: no path leads to them."""
    random = np.random.default_rng(SEED)
    z = equations.scaled(random.normal(size=(STARTS, equations.width)) + 0j)
    tracker, last = Tracker(equations), np.full(STARTS, np.inf)
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            step = tracker.newton(z, numbers)
            last = np.abs(step).max(axis=1)
            z = equations.scaled(np.nan_to_num(z + step, nan=1.0, posinf=1.0, neginf=1.0))
        values, slopes = equations.evaluate(z, numbers)
        whole = np.concatenate([slopes, equations.patches(z)], axis=1)
        sizes = np.linalg.svd(np.nan_to_num(whole), compute_uv=False)
    sound = (last < STILL) & (np.abs(values).max(axis=1) < STILL) & (sizes[:, -1] > SINGULAR * sizes[:, 0])
    found = list[Array]()
    every = [equations.scaled(end.z[None])[0] for end in ends if end.kind == "real"]
    for point in z[sound]:
        if not together(equations, np.array([*every, *found]).reshape(-1, equations.width), point, APART).any():
            found.append(point)
    return [End(point, "real", paths=0) for point in found]


def _on_the_motion(held: Held, equations: BatchEquations, ends: Sequence[End], known: Array) -> list[End]:
    """Of more equations than unknowns, the end that is on the motion through the reference has a proof."""
    proof = on_the_motion(held, equations, known)
    if proof is None:
        return list(ends)
    zeros = np.array([end.z for end in ends], dtype=complex)
    at = together(equations, equations.scaled(zeros), equations.scaled(proof.z[None])[0], APART)
    return [
        replace(end, z=proof.z, proof=proof) if same and _asks(end, square=False) else end
        for end, same in zip(ends, at, strict=True)
    ]
