"""Where, in the parameters, the drives lose their hold on the platform, in the reference configuration.

With drives locked, a limb also gives the wrenches reciprocal to its passive screws alone. Where all determinants of
six wrenches of all limbs vanish, a freedom is left.

    limbs --reciprocal to passive screws--> wrenches --determinants of six--> common factors = 0

Limbs that share constraints give them again and again: in the plane all give the force across it and two couples. A
wrench that is a sum of others with numbers as factors goes first, since determinants with it are sums of those without.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from math import comb
from typing import Any

import sympy

from symscrew.description import Mechanism
from symscrew.mobility.carrying_limbs import carried_by_limbs
from symscrew.mobility.margins import drive_sets
from symscrew.mobility.symbols.generators import NotPolynomialError, Poly
from symscrew.mobility.symbols.loci_at_points import true_loci
from symscrew.mobility.symbols.locus import AT_ONCE, Locus
from symscrew.mobility.symbols.polynomial_screws import SymbolicScrews, symbolic_screws

LARGEST_LOCUS = 40
"""Terms of a factor that is still shown: a line or two of a report. A longer one is counted, not shown."""
MOST_MINORS = 60
"""Determinants of six wrenches that are looked at: all of up to eight wrenches (28) and of hardly more. Each costs up
to 720 products of polynomials; beyond it no locus is looked for, and the result says so."""

Key = tuple[int, tuple[int, ...]]
"""(component of a wrench, powers of the generators)."""


@dataclass(frozen=True)
class ActuationLoci:
    """Where the drives lose their hold, and a sentence for each set of drives that was not looked at in full."""

    found: tuple[Locus, ...] = ()
    not_tried: tuple[str, ...] = ()


def actuation_loci(mechanism: Mechanism, *, work: SymbolicScrews | None = None) -> ActuationLoci:
    """Where the drives lose their hold on the platform: all of them, and every set that is just enough.

    A set whose determinants vanish for all parameters has the locus 0 = 0. None where the description has no
    exact ring, no driven limbs, or a platform that not they alone carry. `work`: the mechanism's `symbolic_screws`
    where somebody has them already, with what was found of them.
    """
    driven = [(j.name, k) for j in mechanism.joints.values() for k in j.driven]
    inside = {joint for limb in mechanism.limbs.values() for joint in limb.joints}
    open_chain = len(mechanism.joints) < len(mechanism.bodies)
    if not driven or open_chain or any(joint not in inside for joint, _ in driven) or not carried_by_limbs(mechanism):
        return ActuationLoci()
    try:
        work = work or symbolic_screws(mechanism)
    except NotPolynomialError:
        return ActuationLoci()  # the result says why there are no symbols at all
    try:
        return _actuation_loci(work, mechanism, driven)
    except NotPolynomialError as error:
        return ActuationLoci(not_tried=(f"actuation loci: {error}",))


def _actuation_loci(work: SymbolicScrews, mechanism: Mechanism, driven: Sequence[tuple[str, int]]) -> ActuationLoci:
    bound = {name: work.of_limb(name).wrenches for name in mechanism.limbs}
    union = [wrench for wrenches in bound.values() for wrench in wrenches]
    freedoms = 6 - len(work.independent(union))
    sets, left_out = drive_sets(driven, freedoms)
    not_tried = [f"actuation loci: {text}" for text in left_out]
    # what the constraints lose, drives cannot hold either: not a matter of the drives
    known = work.ring.factors(work.of_all_limbs.dependent) if union else []
    loci: list[Locus] = []
    for locked in sets:
        wrenches = []
        for name, limb in mechanism.limbs.items():
            own = [d for d in locked if d[0] in limb.joints]
            wrenches += work.of_limb(name, own).wrenches if own else bound[name]
        label = "all drives" if locked == tuple(driven) else " ".join(_label(mechanism, *d) for d in locked)
        wrenches = _without_combinations(wrenches)
        count = comb(len(wrenches), 6)
        if count > MOST_MINORS:
            not_tried.append(f"actuation loci with {label} locked: {count} determinants are more than {MOST_MINORS}")
            continue
        meaning = f"a freedom is left with {label} locked"
        factors, all_listed = _common_factors(work, wrenches)
        not_tried += [] if all_listed else [f"actuation loci with {label} locked, {AT_ONCE}"]
        for factor in factors:
            if len(factor.terms()) > LARGEST_LOCUS:
                not_tried.append(f"actuation locus with {label} locked: not shown, it has {len(factor.terms())} terms")
            elif not factor:
                loci.append(Locus("actuation", label, sympy.S.Zero, f"{meaning}, whatever the parameters"))
            elif factor not in known and -factor not in known:
                known.append(factor)  # once for all drives, not again for each set
                loci.append(Locus("actuation", label, work.ring.expression(factor), meaning))
    kept = true_loci(work.shape, loci)
    for label in dict.fromkeys(locus.where for locus in loci if locus not in kept):
        not_tried.append(f"actuation loci with {label} locked, {AT_ONCE}")
    return ActuationLoci(kept, tuple(dict.fromkeys(not_tried)))


def _label(mechanism: Mechanism, joint: str, freedom: int) -> str:
    return joint if len(mechanism.joints[joint].driven) == 1 and freedom == 0 else f"{joint}.{freedom}"


def _without_combinations(wrenches: Sequence[list[Poly]]) -> list[list[Poly]]:
    """The first wrenches of which all are sums with rational factors: their determinants of six generate all."""
    kept, rows = [], list[tuple[Key, dict[Key, Any]]]()
    for wrench in wrenches:
        row = {(k, monomial): value for k, part in enumerate(wrench) for monomial, value in part.terms() if value}
        for pivot, other in rows:
            if factor := row.get(pivot):
                for key, value in other.items():
                    row[key] = row.get(key, 0) - factor * value
        row = {key: value for key, value in row.items() if value}
        if row:
            pivot, lead = next(iter(row.items()))
            rows.append((pivot, {key: value / lead for key, value in row.items()}))
            kept.append(wrench)
    return kept


def _common_factors(work: SymbolicScrews, wrenches: Sequence[list[Poly]]) -> tuple[list[Poly], bool]:
    """(factors that all determinants of six of the wrenches share, [0] if all vanish; whether they say all)."""
    ring = work.ring
    minors = [ring.determinant([wrenches[i] for i in chosen]) for chosen in combinations(range(len(wrenches)), 6)]
    minors = [minor for minor in minors if minor]
    if not minors:
        return [ring.ring.zero], True
    common, quotients = ring.shared(minors)
    return list(ring.factors(common)), ring.all_listed(common, quotients)
