"""Singularities of three kinds at a configuration: the margins' values there, and actuation loci in symbols.

The margins are those that every model has as functions (`symscrew.mobility.margins`). The loci hold in the reference
configuration: with drives locked, a limb also gives the wrenches reciprocal to its passive screws alone; where all
determinants of six wrenches vanish, a freedom is left.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import comb
from typing import Any

import numpy as np
import sympy

from symscrew.description import Mechanism, exact
from symscrew.kinematics import System
from symscrew.mobility.generators import NotPolynomialError, Poly
from symscrew.mobility.margins import FORMS, MOST_SUBSETS, Margin, actuation_margins, constraint_margins, limb_margins
from symscrew.mobility.symbolic_screws import Locus, SymbolicScrews, symbolic_screws

SINGULAR = 1e-9  # a margin below this counts as zero: the margins have no unit
STEPS = 24
LARGEST_LOCUS = 40  # terms of a factor that is still shown
MOST_MINORS = 60  # determinants of six wrenches that are looked at


@dataclass(frozen=True)
class MarginValue:
    """A margin at the configuration; see `symscrew.mobility.margins.Margin`."""

    kind: str
    name: str
    form: str
    value: float
    meaning: str

    @property
    def singular(self) -> bool:
        """Whether the configuration is singular in this sense."""
        return abs(self.value) < SINGULAR


@dataclass(frozen=True)
class Singularities:
    """`margins` at the configuration (None where they are not known there), with lengths divided by `length` [m].

    `loci`: where, in the parameters, drives lose their hold in the reference configuration.
    """

    length: float
    margins: tuple[MarginValue, ...] | None
    loci: tuple[Locus, ...]


def singularities(mechanism: Mechanism, coordinates: Mapping[str, Any]) -> Singularities:
    """Margins in the reference configuration, or where the given joint coordinates take the mechanism."""
    system = System(mechanism)
    system.use_samples()
    q = _configuration(system, {name: float(exact(value, where=name)) for name, value in coordinates.items()})
    found = [*limb_margins(system), *constraint_margins(system), *actuation_margins(system)]
    loci = actuation_loci(mechanism) if not coordinates else ()
    return Singularities(system.length, None if q is None else _values(system, found, q), loci)


def _values(system: System, margins: Sequence[Margin], q: np.ndarray) -> tuple[MarginValue, ...]:
    if not margins:
        return ()
    values = system.numeric([m.value for m in margins], (system.inputs.q, q[None]))[0]
    return tuple(
        MarginValue(m.kind, m.name, m.form, float(value), m.meaning) for m, value in zip(margins, values, strict=True)
    )


def _configuration(system: System, targets: Mapping[str, float]) -> np.ndarray | None:
    """q with the given coordinates, walked to from the reference; None if a cut joint's is given or it fails."""
    q = system.reference[None].copy()
    if not targets:
        return q[0]
    tree = system.tree
    entry = {c.label: k for k, c in enumerate(tree.q)}
    if any(label not in entry for label in targets):
        return None
    links = {link.q.start: link for link in tree.links[1:] if link.q.stop > link.q.start}
    held = {links[entry[label]].v.start: (entry[label], value) for label, value in targets.items()}
    free = [k for k in range(len(tree.v)) if k not in held]
    scales = np.array([system.length if c.kind == "length" else 1.0 for c in tree.v])
    start = q[0].copy()
    for step in range(1, STEPS + 1):
        for index, value in held.values():
            q[0, index] = start[index] + (value - start[index]) * step / STEPS
        if system.cuts and not _close(system, q, free, scales):
            return None
    return q[0]


def _close(system: System, q: np.ndarray, free: Sequence[int], scales: np.ndarray) -> bool:
    """Newton's method on the closure in the free rates, in place; whether the loops are closed."""
    for _ in range(30):
        residual = system.numeric(system.residual, (system.inputs.q, q))[0]
        if np.abs(residual).max() < 1e-13 * max(1.0, system.length):
            return True
        jacobian = system.numeric(system.closure.dense(), (system.inputs.q, q)).reshape(-1, len(scales)) * scales
        step = np.zeros(len(scales))
        step[free] = np.linalg.lstsq(jacobian[:, free], -residual, rcond=1e-9)[0]
        q[:] = system.advance(q, (scales * step)[None])
    return bool(np.abs(system.numeric(system.residual, (system.inputs.q, q))).max() < 1e-10 * max(1.0, system.length))


# -- in symbols -----------------------------------------------------------------------------------------


def actuation_loci(mechanism: Mechanism) -> tuple[Locus, ...]:
    """Where the drives lose their hold on the platform: all of them, and every set that is just enough.

    A set whose determinants vanish for all parameters has the locus 0 = 0. None where the description has no
    exact ring, or no driven limbs.
    """
    driven = [(j.name, k) for j in mechanism.joints.values() for k in j.driven]
    inside = {joint for limb in mechanism.limbs.values() for joint in limb.joints}
    open_chain = len(mechanism.joints) < len(mechanism.bodies)
    if mechanism.platform is None or not driven or open_chain or any(joint not in inside for joint, _ in driven):
        return ()
    try:
        work = symbolic_screws(mechanism)
        return _actuation_loci(work, mechanism, driven)
    except NotPolynomialError:
        return ()


def _actuation_loci(work: SymbolicScrews, mechanism: Mechanism, driven: Sequence[tuple[str, int]]) -> tuple[Locus, ...]:
    bound = {name: _limb_wrenches(work, mechanism, name, ()) for name in mechanism.limbs}
    union = [wrench for wrenches in bound.values() for wrench in wrenches]
    freedoms = 6 - len(work.independent(union))
    sets = [tuple(driven)]
    if 0 < freedoms < len(driven) and comb(len(driven), freedoms) <= MOST_SUBSETS:
        sets += list(combinations(driven, freedoms))
    # what the constraints lose, drives cannot hold either: not a matter of the drives
    known = work.ring.factors(work.reciprocal(union)[1]) if union else []
    loci: list[Locus] = []
    for locked in sets:
        wrenches = []
        for name, limb in mechanism.limbs.items():
            own = [d for d in locked if d[0] in limb.joints]
            wrenches += _limb_wrenches(work, mechanism, name, own) if own else bound[name]
        label = "all drives" if locked == tuple(driven) else " ".join(_label(mechanism, *d) for d in locked)
        found = _common_factors(work, wrenches)
        if found is None:
            continue
        meaning = f"a freedom is left with {label} locked"
        for factor in found:
            if not factor:
                loci.append(Locus("actuation", label, sympy.S.Zero, f"{meaning}, whatever the parameters"))
            elif factor not in known and -factor not in known:
                known.append(factor)  # once for all drives, not again for each set
                loci.append(Locus("actuation", label, work.ring.expression(factor), meaning))
    return tuple(loci)


def _label(mechanism: Mechanism, joint: str, freedom: int) -> str:
    return joint if len(mechanism.joints[joint].driven) == 1 and freedom == 0 else f"{joint}.{freedom}"


def _limb_wrenches(
    work: SymbolicScrews, mechanism: Mechanism, limb: str, locked: Sequence[tuple[str, int]]
) -> list[list[Poly]]:
    screws = [
        screw
        for name in mechanism.limbs[limb].joints
        for k, screw in enumerate(work.screws(mechanism.joints[name]))
        if (name, k) not in locked
    ]
    return work.reciprocal(screws)[0]


def _common_factors(work: SymbolicScrews, wrenches: Sequence[list[Poly]]) -> list[Poly] | None:
    """Factors that all determinants of six of the wrenches share; [0] if all vanish; None if there are too many."""
    ring = work.ring
    if comb(len(wrenches), 6) > MOST_MINORS:
        return None
    minors = [ring.determinant([wrenches[i] for i in chosen]) for chosen in combinations(range(len(wrenches)), 6)]
    minors = [minor for minor in minors if minor]
    if not minors:
        return [ring.ring.zero]
    return [f for f in ring.factors(ring.common_factor(minors)) if len(f.terms()) <= LARGEST_LOCUS]


# -- for people ------------------------------------------------------------------------------------------


def as_values(found: Singularities) -> dict[str, Any]:
    """The margins as JSON values, by kind."""
    result: dict[str, Any] = {"characteristic_length": found.length, "unit": "1"}
    for kind in ("limb", "constraint", "actuation"):
        result[kind] = None if found.margins is None else [
            {"name": m.name, "margin": m.value, "form": FORMS[m.form], "singular": m.singular, "meaning": m.meaning}
            for m in found.margins
            if m.kind == kind
        ]  # fmt: skip
    return result


def as_lines(found: Singularities) -> list[str]:
    """One line a margin."""
    if found.margins is None:
        return ["Margins are not known here: a coordinate of a joint that closes a loop was given"]
    if not found.margins:
        return []
    lines = [f"Volumes of screws and wrenches with lengths divided by {found.length:g} m, without unit"]
    for m in found.margins:
        value = "SINGULAR here" if m.singular else f"{m.value:.6g}"
        lines.append(f"{m.kind} ({m.name}): {value}, {m.meaning}")
    return lines
