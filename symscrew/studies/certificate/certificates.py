"""Regions of coordinates that are proved free of singularities, of losses of the assembly mode and of passed limits.

Plan --region--> edges, disk --start--> a configuration --file_equations--> equations --splitting--> boxes
     --certificate_checker--> verdict --> Certificate: summary, file
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.description import to_toml
from symscrew.errors import DescriptionError
from symscrew.model import Model, derive
from symscrew.studies.certificate.certificate_checker import (
    FORMAT,
    OF_MECHANISM,
    OF_START,
    Equations,
    Verdict,
    check_certificate,
    configurations,
)
from symscrew.studies.certificate.derived_again import OF_WALK, begins_elsewhere, what_was_asked
from symscrew.studies.certificate.file_equations import file_equations, sampled_margins, vanishing_margins
from symscrew.studies.certificate.splitting import Box, Splitting
from symscrew.studies.certificate.way_from_reference import proved_way
from symscrew.studies.workspace import (
    AZIMUTH,
    TILT,
    Axis,
    Plan,
    check_plan,
    has_own_axes,
    independent_labels,
    quaternion_labels,
)
from symscrew.whole_files import write_text

Array = np.ndarray
STEPS = 64
"""Of the walk from the reference configuration to a region without it: each a few degrees of a wide workspace."""
FULL_TURN = 2 * math.pi * (1 - 1e-12)
"""An azimuth over less is no whole turn, up to rounding of degrees."""
CLAIMED_LESS = 1e-9
"""Part by which claims are below what was found, so that sums in another order carry them."""
DIGITS = 15
"""Significant digits of claims, which round them by less than `CLAIMED_LESS`."""
STATES = {"certified": "not joined", "outside": "outside the limits"}
STATE_NAMES = ("certified", "undecided", "outside the limits", "not joined")
WORDS = {"closure": "the configuration, which a singularity may end", "drives": "whether the drives hold"}


@dataclass(frozen=True)
class Region:
    """What is asked for: edges with their range and smallest size [rad, m, or the quaternion's], and a disk in them.

    `disk`: (first edge, second edge, radius): of the quaternion components that tilt the platform, sin(tilt / 2).
    """

    names: tuple[str, ...]
    low: Array
    high: Array
    smallest: Array
    disk: tuple[int, int, float] | None
    fixed: Mapping[str, float]


@dataclass(frozen=True, repr=False)
class Certificate:
    """What was proved of a region.

    Attributes:
        plan: what was asked for.
        region: in coordinates.
        root: the splitting; `root.leaves` are its boxes with their state.
        values: the file: what the checker needs, as JSON values.
        verdict: what the checker says of the file.
        summary: the result as JSON values, see `docs/how_to/workspace.md`.
    """

    plan: Plan
    region: Region
    root: Box
    values: Mapping[str, Any]
    verdict: Verdict
    summary: Mapping[str, Any]

    def __repr__(self) -> str:
        name, share = self.plan.mechanism.name, self.summary["share"]
        return f"<Certificate {name}: {100 * share:.4g} % of the region proved in {self.summary['boxes']} boxes>"

    @property
    def ok(self) -> bool:
        """Whether there is a proof, and the checker takes it."""
        return self.summary["boxes"] > 0 and self.verdict.holds

    def write(self, path: Path) -> Path:
        """The file that `certificate_checker.py` judges alone."""
        return write_text(path, json.dumps(self.values, separators=(",", ":")) + "\n")


def certify(plan: Plan, progress: Callable[[int], None] = lambda count: None) -> Certificate:
    """Boxes of the plan's axes in which no singularity, no loss of the assembly mode and no passed limit exists.

    Args:
        plan: axes are ranges: count - 1 is the number of the smallest boxes across. Its limits are those of
            joints, points, drives at rest and margins.
        progress: called with the number of boxes that were looked at.

    Raises:
        DescriptionError: axes, limits or tolerances that a certificate cannot have.

    >>> from symscrew import load_catalogue
    >>> certify(Plan(load_catalogue("four_bar"), (), (Axis("A", -0.1, 0.1, 9),))).summary["whole"]
    True
    """
    if plan.tolerances:
        raise DescriptionError("--certify: no tolerances; give the parameter's range as an axis: --over r=0.49:0.51")
    if plan.mode:
        raise DescriptionError(f"--mode {plan.mode}: certificates begin in the reference configuration; leave it out")
    model = derive(plan.mechanism, plan.effects, independent=plan.independent)
    check_plan(plan, model)
    if not has_own_axes(plan, model):
        raise DescriptionError(
            f"--over: certificates are over independent coordinates ({', '.join(independent_labels(model))}) and what "
            "tilt and azimuth say of these; --independent chooses others"
        )
    region = region_of(plan, model)
    start, way = _start(model, region)
    values = file_equations(model, region.names, plan.limits, start)
    values["parameters"] = [float(x) for x in _parameters(model, region)]
    equations = Equations.read(values)
    z = np.clip(_reference(model, region), region.low, region.high)
    begin = (z, start[equations.dependent])
    found = Splitting(equations, region.low, region.high, region.smallest, begin, region.disk, progress).run()
    return _certificate((plan, model, region), values, (begin, way), found)


def region_of(plan: Plan, model: Model) -> Region:
    """The ranges of a plan as edges of a box; tilt and azimuth as the square about the disk of all directions.

    Raises:
        DescriptionError: axes that are no coordinates of the model, or an azimuth over a part of a turn.
    """
    own = {f"{model.mechanism.platform}.{part}": part for part in (TILT, AZIMUTH)}
    axes = {own.get(axis.name, axis.name): axis for axis in plan.axes}
    if TILT in axes:
        first, second = quaternion_labels(model) or ("", "")
        tilt = axes.pop(TILT)
        around = axes.pop(AZIMUTH, None)
        if around is not None and (tilt.low != 0 or around.high - around.low < FULL_TURN):
            raise DescriptionError("--certify: expected tilt from 0 and azimuth over a whole turn, azimuth=0:360deg")
        ends = math.sin(tilt.low / 2), math.sin(tilt.high / 2)
        if max(abs(tilt.low), abs(tilt.high)) > math.pi:
            raise DescriptionError(f"--certify: expected a tilt within half a turn, got {tilt.high:g} rad")
        if around is not None:
            count = 2 * (tilt.count - 1) + 1
            square = Axis("", -ends[1] * (1 + 1e-12), ends[1] * (1 + 1e-12), count)
            axes |= {first: replace(square, name=first), second: replace(square, name=second)}
        else:
            axes |= {first: replace(tilt, name=first, low=ends[0], high=ends[1]), second: Axis(second, 0.0, 0.0, 1)}
    else:
        around = None
    edges = [axis for axis in axes.values() if axis.low != axis.high]
    if not edges:
        raise DescriptionError("--certify: nothing to certify: give --over COORDINATE=from:to")
    names = tuple(axis.name for axis in edges)
    low, high = (np.array([getattr(axis, end) for axis in edges]) for end in ("low", "high"))
    smallest = (high - low) / np.array([max(1, axis.count - 1) for axis in edges])
    disk = (names.index(first), names.index(second), ends[1]) if around is not None else None
    fixed = {axis.name: axis.low for axis in axes.values() if axis.low == axis.high}
    return Region(names, low, high, smallest, disk, fixed)


def _reference(model: Model, region: Region) -> Array:
    labels = [c.label for c in model.system.tree.q]
    known = dict(zip(labels, model.system.reference, strict=True))
    names = [n for n, p in model.mechanism.parameters.items() if p.run_time]
    known |= dict(zip(names, model.system.parameter_values, strict=True))
    return np.array([float(known[name]) for name in region.names])


def _parameters(model: Model, region: Region) -> Array:
    names = [n for n, p in model.mechanism.parameters.items() if p.run_time]
    found = np.array(model.system.parameter_values, dtype=float)
    for name, value in region.fixed.items():
        if name in names:
            found[names.index(name)] = value
    return found


def _start(model: Model, region: Region) -> tuple[Array, dict[str, Any] | None]:
    """A closed configuration q (nq,) of the region, the nearest to the reference, and the proved way there.

    There is no way where it is the reference configuration, and where none could be proved: then a walk led there.

    Raises:
        DescriptionError: the walk comes to no configuration.
    """
    labels = [c.label for c in model.system.tree.q]
    parameters = [n for n, p in model.mechanism.parameters.items() if p.run_time]
    names = [*region.names, *region.fixed]
    values = file_equations(model, names, (), model.system.reference)
    equations = Equations.read(values)
    first = _reference(model, replace(region, names=tuple(names)))
    last = np.array([*np.clip(first[: len(region.names)], region.low, region.high), *region.fixed.values()])
    q, way = model.system.reference[equations.dependent], None
    if (first != last).any():
        walked = _walk(equations, (first, last), q, names)  # sooner than a proof finds that there is nothing to prove
        way = proved_way(equations, first, last, q)
        q = walked if way is None else way.end[1]
    found = np.array(model.system.reference, dtype=float)
    for name, value in zip(names, last, strict=True):
        if name not in parameters:
            found[labels.index(name)] = value
    found[equations.dependent] = q
    return found, None if way is None else way.values(values)


def _walk(equations: Equations, ends: tuple[Array, Array], start: Array, names: Sequence[str]) -> Array:
    """Dependent coordinates (m,) at the second end, by Newton's method from step to step."""
    (first, last), q = ends, start[:, None]
    with np.errstate(all="ignore"):
        for k in range(1, STEPS + 1):
            z = first + (last - first) * (k / STEPS)
            q, still = configurations(equations, z[:, None], q)
            if not still.all():
                where = ", ".join(f"{n} = {x:.6g}" for n, x in zip(names, z, strict=True))
                raise DescriptionError(
                    f"--certify: no configuration was found at {where}, on the way from the reference configuration "
                    f"to the region; choose other ranges, or other coordinates with --independent"
                )
    return np.asarray(q[:, 0])


def _certificate(
    asked: tuple[Plan, Model, Region],
    equations: dict[str, Any],
    came: tuple[tuple[Array, Array], dict[str, Any] | None],
    found: tuple[Box, list[Box], list[tuple[int, int]]],
) -> Certificate:
    """The file with the claims that its checker carries, and the summary of all boxes."""
    (plan, model, region), (root, boxes, pairs), (begin, way) = asked, found, came
    values: dict[str, Any] = {
        "format": FORMAT,
        "mechanism": {"name": plan.mechanism.name, "toml": to_toml(plan.mechanism)},
        "asked": what_was_asked(plan, region.fixed),
        "equations": equations,
        "region": {"names": region.names, "low": region.low.tolist(), "high": region.high.tolist()},
        "disk": None if region.disk is None else {"axes": region.disk[:2], "radius": region.disk[2]},
        "splitting": root.codes,
        "configurations": [box.centre.tolist() for box in boxes if box.centre is not None],
        "joints": pairs,
        "start": {"box": pairs[0][0] if pairs else 0, "z": begin[0].tolist(), "q": begin[1].tolist()},
        "way": way,
        "claims": {},
    }
    name = plan.mechanism.name
    verdict = Verdict(name, (), ("no box is proved",), (), {})
    if boxes:
        verdict = check_certificate(json.loads(json.dumps(values)))
        values["claims"] = _claims(verdict.facts)
        left = [text for text in verdict.assumed if text not in (OF_MECHANISM, OF_START)]  # both by the making of it
        left += [OF_WALK] if begins_elsewhere(values, model) else []
        verdict = replace(
            verdict, assumed=tuple(left), proved=tuple(f"{k} {json.dumps(v)}" for k, v in values["claims"].items())
        )
    return Certificate(plan, region, root, values, verdict, _summary(asked, root, verdict))


def _claims(fact: Any) -> Any:
    """A little less than what was found: other machines sum in another order."""
    if isinstance(fact, Mapping):
        return {key: _claims(value) for key, value in fact.items()}
    return float(f"{fact * (1 - CLAIMED_LESS):.{DIGITS}g}") if isinstance(fact, float) else fact


def _summary(asked: tuple[Plan, Model, Region], root: Box, verdict: Verdict) -> dict[str, Any]:
    plan, model, region = asked
    leaves = [box for box in root.leaves if box.state != "beyond"]
    sizes = np.array([float(np.prod((b.high - b.low) / (region.high - region.low))) for b in leaves])
    states = np.array(["certified" if b.joined else STATES.get(b.state, b.state) for b in leaves])
    shares = {name: float(sizes[states == name].sum() / sizes.sum()) for name in dict.fromkeys(STATE_NAMES)}
    reasons: dict[str, float] = {}
    for box, size in zip(leaves, sizes, strict=True):
        for reason in box.reasons if box.state == "undecided" else ():
            reasons[reason] = reasons.get(reason, 0.0) + float(size / sizes.sum())
    facts = verdict.facts
    found: dict[str, Any] = {
        "mechanism": plan.mechanism.name,
        "region": {n: [float(a), float(b)] for n, a, b in zip(region.names, region.low, region.high, strict=True)},
        "fixed": dict(region.fixed),
        "smallest": dict(zip(region.names, region.smallest.tolist(), strict=True)),
        "boxes": int(facts.get("boxes", 0)),
        "looked_at": len(leaves),
        "whole": bool(facts.get("whole", False)),
        "share": float(facts.get("share", 0.0)),
        "shares": shares,
        "undecided": dict(sorted(reasons.items(), key=lambda item: -item[1])),
        "limits": {n: [_bound(low), _bound(high)] for n, low, high in plan.limits},
        "least_margins": {},
        "left_out": vanishing_margins(model),
        "proved": verdict.holds and bool(facts),
        "refused": list(verdict.refused),
        "assumed": list(verdict.assumed),
    }
    reference = sampled_margins(model)
    for name, value in facts.get("least", {}).items():
        found["least_margins"][name] = {"at_least": value, "reference": float(abs(reference[name][0]))}
    if "radius" in facts:
        found["tilt"] = {"every_direction": 2 * math.asin(min(1.0, facts["radius"] * (1 - CLAIMED_LESS)))}
    return found


def _bound(value: float) -> float | None:
    return value if math.isfinite(value) else None


def certificate_text(found: Mapping[str, Any]) -> str:
    """The summary in words."""
    axes = ", ".join(f"{n} {low:.6g} to {high:.6g}" for n, (low, high) in found["region"].items())
    fixed = "".join(f", {n} = {x:.6g}" for n, x in found["fixed"].items())
    shares = found["shares"]
    lines = [
        f"{found['mechanism']}: {axes}{fixed}",
        f"proved in {found['boxes']} boxes, {_percent(shares['certified'])} of the region: one configuration for every "
        f"point, on the branch {'to which a walk led' if OF_WALK in found['assumed'] else 'of the reference'}; no "
        "singularity"
        + (" of those that were looked at" if found["left_out"] else "")
        + (", all limits hold" if found["limits"] else "")
        if found["proved"]
        else "nothing is proved",
    ]
    if found["whole"]:
        lines.append("the whole region is proved")
    if "tilt" in found:
        lines.append(f"tilt of {math.degrees(found['tilt']['every_direction']):.4f} degrees proved in every direction")
    if shares["outside the limits"]:
        lines.append(f"outside the limits: {_percent(shares['outside the limits'])}")
    if shares["not joined"]:
        lines.append(
            f"free of singularities, but not joined to the reference by proved boxes: {_percent(shares['not joined'])}"
        )
    if shares["undecided"]:
        why = ", ".join(f"{WORDS.get(n, n)} ({_percent(x)})" for n, x in found["undecided"].items())
        lines.append(f"undecided at the smallest size: {_percent(shares['undecided'])}; open there: {why}")
    lines += [
        f"{name}: at least {m['at_least']:.4g}, in the reference configuration {m['reference']:.4g}"
        for name, m in found["least_margins"].items()
    ]
    lines += [f"not looked at, as it is zero wherever it was tried: {name}" for name in found["left_out"]]
    lines += [f"refused: {text}" for text in found["refused"]]
    lines += [f"assumed: {text}" for text in found["assumed"]]
    return "\n".join(lines)


def _percent(part: float) -> str:
    return f"{100 * part:.4g} %"
