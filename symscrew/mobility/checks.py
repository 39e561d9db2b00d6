"""Every claim of a mobility result checked again by another route.

    Mobility --verify--> Check(claim, holds, evidence): ranks, motions, reciprocity, real motions, symbols

The tolerances below are of residuals in 60 digits; numbers of the geometry are of order one, so that a wrong claim
misses them by tens of powers of ten.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy

from symscrew.algebra import CONTEXT
from symscrew.mobility.analysis import Mobility
from symscrew.mobility.finite import DIGITS_60, ClosureVariety, moved, recheck
from symscrew.mobility.joint_network import network_of
from symscrew.mobility.proof_file import mobility_proof
from symscrew.mobility.proofs import check_proof
from symscrew.mobility.rank_evidence import OF_CONSTRAINTS
from symscrew.mobility.screw_systems import ZERO_BELOW, Real, Screw, eliminate, unit_rows
from symscrew.mobility.second_routes import second_routes
from symscrew.mobility.symbols import Vector, numbers_at

DISPLACED = 1e-45
"""Power of a symbolic constraint on displaced screws: 60 digits through exponentials and a page of formula."""
CLOSURE_IN_SYMBOLS = 1e-40
"""Velocity of closure of symbolic rates at the parameters' values: rates are not normalised and may be large."""
CLOSURE = 1e-25
"""Velocity of closure of the numeric motions: zeros of a rank are taken from 1e-27 (`ZERO_BELOW`)."""
POWER = 1e-20
"""Power of a freedom on a constraint that is reciprocal to it: zeros from 1e-27, times conditions and metres."""
SMALL = 1e-12
"""Part of the sizes of a screw and a wrench below which the terms of their product are zeros, up to rounding."""
OF_MOTION = ("finite mobility", "smooth", "branches")
"""Claims of a proof file about the real motion begin with one of these."""
NEGLECTED = 1e-11
"""Relative singular value, in double precision, that may belong to a redundant row."""


@dataclass(frozen=True)
class Check:
    """A claim, whether it holds, and by how much."""

    claim: str
    holds: bool
    evidence: str
    withdraws: str = ""
    """The statement that falls with it (`symscrew.mobility.withheld.WITHDRAWN`); empty: the result as a whole."""


def verified(found: Mobility) -> tuple[Mobility, tuple[Check, ...]]:
    """(the result without the statements whose check failed, every check)."""
    checks = verify(found)
    failed = {check.withdraws for check in checks if not check.holds} - {""}
    return (found.without(failed) if failed else found), checks


def verify(found: Mobility) -> tuple[Check, ...]:
    """Every claim by a route that it was not found by.

    Ranks by singular values and over an exact field, reciprocity, motions in the closure, finite mobility by power
    series (smooth points and branches) or by displacements (isolated points), symbols against numbers, and what is
    proved by the checker of proof files.
    """
    checks = [_rank(found), _closure(found), _reciprocity(found)]
    count = found.kutzbach + found.overconstraints == found.dof
    checks.append(Check("Kutzbach + overconstraints = dof", count, f"{found.kutzbach} + {found.overconstraints}"))
    if found.counts.by_limbs is not None:
        numbers = f"{found.counts.by_limbs} by the limbs' constraints, {found.counts.redundant} by the closure"
        same = found.counts.by_limbs == found.counts.redundant
        checks.append(Check("redundant constraints by limbs as by loops", same, numbers))
    if found.finite.dof is not None:
        bounded = found.finite.dof <= found.dof and (not found.finite.smooth or found.finite.dof == found.dof)
        checks.append(Check("finite mobility at most the instantaneous", bounded, f"{found.finite.dof} <= {found.dof}"))
    checks += [Check(*recheck(witness), withdraws="finite") for witness in found.finite.witnesses]
    if found.decisions.field is not None:
        checks.append(_over_the_field(found))
    others = [Check(*one) for one in second_routes(found)]
    return (*checks, *others, *_symbols(found), *_displaced(found), *_motions(found), *_by_the_checker(found))


def _by_the_checker(found: Mobility) -> list[Check]:
    """The proof file, judged by its checker, which makes screws, loops and matrices from the description by itself."""
    if found.taken is not None or not found.in_reference:
        return []  # geometry that was solved for has no exact numbers that a file could hold
    verdict = check_proof(json.loads(json.dumps(mobility_proof(found))))
    real = all(text.startswith(OF_MOTION) for text in verdict.refused)
    text = f"{len(verdict.proved)} claims proved from exact numbers, {len(verdict.not_proved)} not"
    evidence = "; ".join(verdict.refused) if verdict.refused else text
    return [Check("proof file, by its checker", verdict.holds, evidence, "finite" if real else "")]


def _displaced(found: Mobility) -> list[Check]:
    """Symbolic constraints of displaced limbs do no work on the screws that exponentials in 60 digits displace."""
    checks = []
    for name, pose in found.limb_poses.items():
        if isinstance(pose, str):
            continue
        joints = {j: found.mechanism.joints[j] for j in found.mechanism.limbs[name].joints}
        network = network_of(replace(found.mechanism, joints=joints))
        fine = ClosureVariety(network, DIGITS_60)
        q = np.array([CONTEXT.zero] * fine.columns, dtype=object)
        values: dict[Any, Any] = {}
        for k, (symbol, joint) in enumerate(zip(pose.displacements, pose.of, strict=True), start=1):
            edge, _, index = joint.partition(".")
            column = network.edges[edge].motions[int(index or 0)][1]
            size = sympy.Rational(k, 5) * (sympy.Rational(1, 4) if symbol.name.startswith("d") else 1)
            values[symbol] = size
            exact = CONTEXT.mpf(int(size.p)) / int(size.q)
            q[column] = exact / network.length if network.edges[edge].motions[int(index or 0)][0].prismatic else exact
        screws = moved(network, fine, q).screws
        worst = 0.0
        for wrench in pose.constraints:
            numbers = numbers_at([tuple(c.xreplace(values) for c in wrench)], found.mechanism)[0]
            scaled = (*numbers[:3], *(c / network.length for c in numbers[3:]))
            terms = ([screw[k] * scaled[(k + 3) % 6] for k in range(6)] for screw in screws)
            sizes = (_size(scaled) * _size(screw) for screw in screws)
            worst = max(worst, *(_relative(t, least=SMALL * size) for t, size in zip(terms, sizes, strict=True)))
        claim = f"{name}: constraints in its displacements"
        text = f"largest power {worst:.1e} of its terms on screws displaced by exponentials"
        checks.append(Check(claim, worst < DISPLACED, text, "poses"))
    return checks


def _motions(found: Mobility) -> list[Check]:
    """The symbolic joint rates close the loops in 60 digits."""
    if found.limbs or not found.network.chords or isinstance(found.loops, str):
        return []
    edges = found.network.edges.values()
    lengths = [motion.prismatic for edge in edges for motion, _ in edge.motions for _ in range(motion.freedom)]
    worst = 0.0
    for rates in numbers_at(found.loops.rates, found.mechanism):
        scaled = [r / found.network.length if long else r for r, long in zip(rates, lengths, strict=True)]
        largest = max(abs(r) for r in scaled)
        for row in found.first_order.rows:
            worst = max(worst, float(abs(sum(a * b for a, b in zip(row, scaled, strict=True))) / largest))
    found_all = len(found.loops.rates) <= found.dof
    text = f"{len(found.loops.rates)} motions, largest velocity of closure {worst:.1e} of their rates"
    holds = worst < CLOSURE_IN_SYMBOLS and found_all
    return [Check("joint rates in symbols keep all loops closed", holds, text, "loops")]


def _over_the_field(found: Mobility) -> Check:
    """Elimination over the exact field against elimination in 60 digits.

    Rounded decimals make ranks larger, but those of limbs leave fewer constraints, of less rank, too.
    """
    decided = [d for d in found.decisions.ranks if d.exact is not None]
    different = [d for d in decided if d.exact != d.numeric]
    larger = [d for d in different if (d.exact or 0) > d.numeric]
    limbs = any(d.claim == f"rank of {name}" for d in larger for name in found.mechanism.limbs)
    rounded = bool(larger) and all(d in larger or (limbs and d.claim == OF_CONSTRAINTS) for d in different)
    text = f"{len(decided)} ranks over {found.decisions.field}"
    if rounded:
        text += f", {len(different)} of them others by rounded decimals: {found.decisions.why}"
    return Check("ranks over an exact field", not different or rounded, text)


def _rank(found: Mobility) -> Check:
    rank = found.first_order.closure.rank
    rows = np.array([[float(c) for c in row] for row in found.first_order.rows])
    if not rows.size:
        return Check("rank of the closure", rank == 0, "no loops")
    values = np.linalg.svd(rows, compute_uv=False)
    smallest = values[rank - 1] if rank else float("inf")
    largest = values[rank] if rank < len(values) else 0.0
    text = f"singular values {smallest:.2e} | {largest:.2e} in double precision"
    holds = bool(largest < NEGLECTED * values[0] and smallest > largest)
    if smallest < NEGLECTED * values[0] and found.decisions.exact:  # what doubles cannot tell, the field has told
        text += f", which do not tell it; elimination over {found.decisions.field} does"
        holds = bool(largest < NEGLECTED * values[0])
    return Check("rank of the closure", holds, text)


def _closure(found: Mobility) -> Check:
    worst = max(
        (abs(sum(a * b for a, b in zip(row, motion, strict=True)))
         for motion in unit_rows(found.first_order.motions) for row in found.first_order.rows),
        default=0,
    )  # fmt: skip
    return Check(
        "motions keep all loops closed", bool(worst < CLOSURE), f"largest velocity of closure {float(worst):.1e}"
    )


def _reciprocity(found: Mobility) -> Check:
    wrenches = [*found.platform.constraints.basis, *(w for limb in found.limbs for w in limb.constraints.basis)]
    if found.constraints is None or found.platform.body != found.mechanism.platform:
        wrenches = [*found.platform.constraints.basis]
    length = found.network.length
    twists = unit_rows([(*t[:3], *(c / length for c in t[3:])) for t in found.platform.freedoms.basis])
    scaled = unit_rows([(*w[:3], *(c / length for c in w[3:])) for w in wrenches])
    worst = max((abs(_power(t, w)) for t in twists for w in scaled), default=0)
    dimensions = found.platform.dof + len(found.platform.constraints.basis)
    return Check(
        "freedoms reciprocal to constraints, dimensions add to 6",
        bool(worst < POWER) and dimensions == 6,
        f"largest power {float(worst):.1e}, {found.platform.dof} + {6 - found.platform.dof}",
    )


def _symbols(found: Mobility) -> list[Check]:
    """The symbolic spaces at the parameters' values against the numeric ones."""
    if found.symbolic is None:
        return []
    checks = []
    for limb, numeric in zip(found.symbolic.limbs, found.limbs, strict=True):
        checks.append(
            _symbolic_space(found, limb.name, limb.constraints, numeric=numeric.constraints.basis, kind="limb")
        )
    if found.constraints is not None and found.platform.body == found.mechanism.platform:
        name, freedoms = found.platform.body, found.platform.freedoms.basis
        checks.append(_symbolic_space(found, name, found.symbolic.freedoms, numeric=freedoms, kind="constraint"))
    return checks


def _symbolic_space(
    found: Mobility, name: str, symbols: Sequence[Vector], *, numeric: Sequence[Screw], kind: str
) -> Check:
    """The same space; on a locus of degeneration the numbers must contain what the symbols say."""
    assert found.symbolic is not None
    length = found.network.length
    values = unit_rows([(*v[:3], *(c / length for c in v[3:])) for v in numbers_at(symbols, found.mechanism)])
    known = unit_rows([(*v[:3], *(c / length for c in v[3:])) for v in numeric])
    degenerate = [
        locus
        for locus in found.symbolic.loci
        if locus.kind in (kind, "limb")
        and (locus.where == name or kind == "constraint")
        and abs(numbers_at([(locus.expression,)], found.mechanism)[0][0]) < ZERO_BELOW
    ]
    claim = f"{name}: symbols agree with numbers"
    if degenerate:
        inside = eliminate([*known, *values], 6).rank == len(known)
        text = f"on the locus {degenerate[0].expression} = 0, where they have more"
        return Check(claim, inside, text, "symbols")
    return Check(claim, _same_space(values, known), f"{len(values)} vectors", "symbols")


def _relative(terms: Sequence[Real], *, least: Real) -> float:
    """A sum over the sum of its terms' sizes: what rounding leaves does not grow with the length of formulas.

    Where all terms are rounding of zeros, over `least`.
    """
    size = max(sum(abs(c) for c in terms), least)
    return float(abs(sum(terms)) / size) if size else 0.0


def _size(vector: Sequence[Real]) -> Real:
    return CONTEXT.sqrt(sum(c * c for c in vector))


def _same_space(a: Sequence[Sequence[Real]], b: Sequence[Sequence[Real]]) -> bool:
    ranks = {eliminate(list(x), 6).rank for x in (a, b, [*a, *b])}
    return len(ranks) == 1


def _power(twist: Sequence[Real], wrench: Sequence[Real]) -> Real:
    return sum(twist[k] * wrench[(k + 3) % 6] for k in range(6))
