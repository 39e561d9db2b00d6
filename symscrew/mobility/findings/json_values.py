"""A mobility result as JSON values: numbers, with exact forms as strings beside them, six components a screw."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from symscrew.mobility.findings.at_rest import resting_joints
from symscrew.mobility.findings.places import place_values
from symscrew.mobility.finite import lone_pairs, named_spins
from symscrew.mobility.motions import branch_values
from symscrew.mobility.singularities import as_values
from symscrew.mobility.symbols import conditions

if TYPE_CHECKING:
    from symscrew.mobility.analysis import Mobility


def mobility_values(found: Mobility) -> dict[str, Any]:
    """The result as JSON values; exact forms as strings beside the numbers."""
    finite, platform, symbolic = found.finite, found.platform, found.symbolic
    exact = {limb.name: limb.constraints for limb in symbolic.limbs} if symbolic else {}
    return {
        "mechanism": found.mechanism.name,
        "configuration": {
            "in_words": found.configuration,
            "coordinates": {name: str(value) for name, value in found.coordinates.items()},
            "parameters": {name: str(value) for name, value in found.parameters.items()},
            "all": place_values(found),
        },
        "kutzbach": found.kutzbach,
        "dof": found.dof,
        "dof_finite": finite.dof,
        "smooth": finite.smooth,
        "branches": None if finite.branches is None else list(finite.branches),
        "overconstraints": found.overconstraints,
        "internal_freedoms": found.internal_freedoms,
        "passive_spins": [list(pair) for pair in named_spins(found.network)],
        "passive_freedoms": [list(pair) for pair in lone_pairs(found.network)],
        "platform": {
            "body": platform.body,
            "dof": platform.dof,
            "type": platform.type,
            "motion_type": platform.motion_type,
            "freedoms": [[float(c) for c in twist] for twist in platform.freedoms.basis],
            "freedoms_exact": [[str(c) for c in t] for t in symbolic.freedoms] if symbolic else None,
        },
        "limbs": [
            {
                "name": limb.name,
                "constraints": [[float(c) for c in wrench] for wrench in limb.constraints.basis],
                "constraints_exact": [[str(c) for c in w] for w in exact[limb.name]] if limb.name in exact else None,
                "constraints_displaced": _pose(found, limb.name),
            }
            for limb in found.limbs
        ],
        "dof_drives_locked": found.dof_drives_locked,
        "loci": [
            {"kind": locus.kind, "where": locus.where, "zero": str(locus.expression), "meaning": locus.meaning}
            for locus in found.loci
        ],
        "singularities": as_values(found.singularities),
        "motions_exact": _rates(found),
        "overconstraint_joints": list(found.redundant.statically_indeterminate),
        "counts": _counts(found),
        "method": found.method,
        "exact": found.decisions.exact,
        "field": found.decisions.field,
        "ranks": [{"claim": d.claim, "rank": d.numeric, "exact": d.exact} for d in found.decisions.ranks],
        "singular_values": list(found.decisions.singular_values),
        "nearly_parallel": list(found.nearly_parallel),
        "evidence": list(finite.evidence),
        "proved": finite.proved,
        "judgement": finite.judgement,
        "branch_table": None if found.branches is None else branch_values(found.branches, found.network),
        "joints_at_rest_proved": list(resting_joints(found)),
        "near": _near(found),
        "taken": _taken(found),
        "nearly_singular": found.nearly_singular or None,
        "nearly_special": list(found.nearly_special),
        "withdrawn": sorted(found.withdrawn),
    }


def _near(found: Mobility) -> dict[str, Any] | None:
    """The special geometry next to the one typed: its distance [m], its mobility, and what to type for it."""
    if found.near is None:
        return None
    meant = found.near.meant
    return {
        "distance": found.near.distance,
        "dof": meant.dof,
        "dof_finite": meant.finite.dof,
        "judgement": meant.finite.judgement,
        "branches": None if meant.finite.branches is None else list(meant.finite.branches),
        "overconstraints": meant.overconstraints,
        "platform": meant.platform.type,
        "dof_drives_locked": meant.dof_drives_locked,
        "changes": dict(found.near.changes),
        "type_instead": {name: _typed(*place) for name, place in found.near.places().items()},
    }


def _typed(point: tuple[str, ...], axes: tuple[tuple[str, ...], ...], pitch: str | None) -> dict[str, Any]:
    values: dict[str, Any] = {"point": list(point), "axes": [list(axis) for axis in axes]}
    return values if pitch is None else {**values, "pitch": pitch}


def _counts(found: Mobility) -> dict[str, Any]:
    """The numbers of the field's formulas; letters as in `symscrew.mobility.field_counts`."""
    counts = found.counts
    return {
        "n": counts.links,
        "g": counts.joints,
        "sum_f": counts.freedoms,
        "q": len(counts.loops),
        "p": counts.couplings,
        "r": counts.rank,
        "kutzbach": counts.kutzbach,
        "lambda": counts.common,
        "d": counts.order,
        "nu": counts.redundant,
        "zeta": counts.isolated,
        "modified_kutzbach": counts.modified,
        "M": counts.mobility,
        "S_F": counts.platform,
        "N": counts.overconstraint,
        "T": counts.redundancy,
        "limbs": [{"name": m.name, "f": m.freedoms, "S_G": m.connectivity} for m in counts.limbs],
        "loops": [asdict(loop) for loop in counts.loops],
        "by_groups": counts.by_groups,
        "by_orders": counts.by_orders,
    }


def _taken(found: Mobility) -> dict[str, Any] | None:
    """What was typed, where special geometry was taken for it: how far it is [m] and its mobility as typed."""
    if found.taken is None:
        return None
    typed = found.taken.typed
    return {
        "distance": found.taken.distance,
        "tolerance": found.taken.tolerance,
        "dof_as_typed": typed.dof,
        "dof_finite_as_typed": typed.finite.dof,
        "platform_as_typed": typed.platform.type,
    }


def _pose(found: Mobility, limb: str) -> dict[str, Any] | None:
    pose = found.limb_poses.get(limb)
    if pose is None or isinstance(pose, str):
        return {"reason": pose} if pose else None
    return {
        "displacements": {str(symbol): joint for symbol, joint in zip(pose.displacements, pose.of, strict=True)},
        "constraints": [[str(c) for c in w] for w in pose.constraints],
        "loci": [{"kind": locus.kind, "zero": str(locus.expression)} for locus in conditions(pose.loci)],
        "dependent_at": {str(symbol): value for symbol, value in pose.further.items()},
    }


def _rates(found: Mobility) -> list[dict[str, str]] | None:
    if found.limbs or not found.network.chords or isinstance(found.loops, str):
        return None
    joints = found.loops.joints
    return [{j: str(r) for j, r in zip(joints, rates, strict=True)} for rates in found.loops.rates]
