"""What a sweep says in a few numbers: how much is reached, strokes, forces, the tilt in every direction, tolerances."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from symscrew.display import fitting_table
from symscrew.studies.workspace.plan import AZIMUTH, TILT, Plan

Results = Mapping[str, np.ndarray]
DEGREE = 180 / np.pi  # per radian
TURN = 2 * np.pi
EARTH = 9.81  # [m/s^2]
ANGLES = {TILT: "rad", AZIMUTH: "rad"}  # axes that are no coordinates
NOISE = 1e-12  # of the largest value of a unit: what is smaller is rounding, and is printed as zero


def sweep_summary(plan: Plan, results: Results, units: Mapping[str, str], engine: str = "") -> dict[str, Any]:
    """Counts, ranges over the allowed cases, the reach of the tilt and the effect of tolerances, as JSON values.

    `engine`: what computed them, in words.
    """
    allowed = results["allowed"] > 0
    found: dict[str, Any] = {
        "mechanism": plan.mechanism.name,
        "plan": plan.hash,
        "cases": plan.count,
        **({"engine": engine} if engine else {}),
        "reached": int((results["reached"] > 0).sum()),
        **({"around": around} if (around := int(results.get("around", np.zeros(1)).sum())) else {}),
        "regular": int(((results["reached"] > 0) & (results["regular"] > 0)).sum()),
        "allowed": int(allowed.sum()),
        **({"mode": plan.mode} if plan.mode else {}),
        "weight": _weight(plan),
        "axes": {a.name: [a.low, a.high, a.count] for a in plan.axes},
        "axis_units": {a.name: ANGLES.get(a.name) or units.get(a.name, "1") for a in plan.axes},
        "limits": {name: [_bound(low), _bound(high)] for name, low, high in plan.limits},
        "ranges": {},
    }
    for name in _shown(plan, results):
        values = results[name][allowed & np.isfinite(results[name])]
        if len(values):
            found["ranges"][name] = {
                "unit": units.get(name, "1"), "least": float(values.min()), "largest": float(values.max()),
            }  # fmt: skip
    reach = tilt_reach(plan, results)
    if reach is not None:
        azimuths, tilts = reach
        least = "every_direction" if all_around(plan) else "directions_looked_at"
        reached = [_bound(tilt) for tilt in tilts.tolist()]
        found["tilt"] = {"azimuth": azimuths.tolist(), "reach": reached, least: _bound(float(tilts.min()))}
    if plan.tolerances:
        found["tolerance"] = _tolerances(plan, results, units)
    return found


def tilt_reach(plan: Plan, results: Results) -> tuple[np.ndarray, np.ndarray] | None:
    """(azimuth, largest tilt up to which all tilts are allowed) [rad], NaN where the least is not; None without them.

    All other axes and samples must be allowed, too.
    """
    names = [axis.name for axis in plan.axes]
    if TILT not in names or AZIMUTH not in names:
        return None
    shape = (*(axis.count for axis in plan.axes), plan.samples)
    first = (results["allowed"] > 0).reshape(shape)
    first = np.moveaxis(first, (names.index(AZIMUTH), names.index(TILT)), (0, 1))
    allowed = np.all(first.reshape(first.shape[0], first.shape[1], -1), axis=2)
    azimuth, tilt = plan.axes[names.index(AZIMUTH)].values, plan.axes[names.index(TILT)].values
    size = np.abs(tilt)
    failed = np.where(allowed, np.inf, size).min(axis=1, keepdims=True)  # the least tilt that is not
    inside = size < failed * (1 - NOISE)  # of tilts of both signs neither may fail
    return azimuth, np.where(inside.any(axis=1), np.where(inside, size, 0.0).max(axis=1), np.nan)


def all_around(plan: Plan) -> bool:
    """Whether the axes tilt and azimuth go from upright in every direction, as far as a grid can.

    That is: a tilt is zero (up to rounding), and no two neighbours of the azimuths, around the whole turn, are farther
    apart than the axis steps; nor by half a turn, for directions on one side say nothing of the other. Tilts of both
    signs look at the opposite azimuths, too, where they go as far.
    """
    axes = {axis.name: axis for axis in plan.axes}
    if not {TILT, AZIMUTH} <= set(axes):
        return False
    tilt, azimuth = axes[TILT].values, axes[AZIMUTH].values
    size = np.abs(tilt)
    both = abs(float(tilt.max() + tilt.min())) <= NOISE * float(size.max())
    looked_at = np.concatenate([azimuth, azimuth + np.pi]) if both else azimuth
    around = np.sort(looked_at % TURN)
    gap = float(np.diff(around, append=around[0] + TURN).max())
    step = float(np.ptp(azimuth)) / max(len(azimuth) - 1, 1)
    return bool(size.min() <= NOISE * size.max() and gap <= step + NOISE and gap < np.pi - NOISE)


def _weight(plan: Plan) -> float:
    """Of all bodies on earth [N]: what forces are compared with to tell them from rounding."""
    masses = [body.mass for body in plan.mechanism.bodies.values() if body.mass is not None]
    return EARTH * sum(float(plan.mechanism.number(mass)) for mass in masses)


def _bound(value: float) -> float | None:
    return value if np.isfinite(value) else None


def _shown(plan: Plan, results: Results) -> list[str]:
    """Drives' strokes and forces, joints with limits, points of the platform, quality."""
    driven = {f"{n}.{k}" if len(j.driven) > 1 or f"{n}.{k}" in results else n
              for n, j in plan.mechanism.joints.items() for k in j.driven}  # fmt: skip
    limited = {name for name, _, _ in plan.limits}
    platform = {n for n, p in plan.mechanism.points.items() if p.body == plan.mechanism.platform}
    return [
        name
        for name in results
        if name in driven | limited | {"condition", "stiffness least", "stiffness largest", "margin"}
        or name.startswith("drive ")
        or (name.startswith("point ") and name[6:].rpartition(".")[0] in platform)
    ]


def _tolerances(plan: Plan, results: Results, units: Mapping[str, str]) -> dict[str, Any]:
    """Standard deviation and 5 and 95 % about the mean of the samples at each place, over all places."""
    found = {}
    for name in _shown(plan, results):
        values = results[name].reshape(-1, plan.samples)
        about = (values - np.nanmean(values, axis=1, keepdims=True)).ravel()
        about = about[np.isfinite(about)]
        if len(about):
            low, high = np.percentile(about, (5, 95))
            found[name] = {
                "unit": units.get(name, "1"),
                "deviation": float(about.std()),
                "5": float(low),
                "95": float(high),
            }
    return found


def _without_noise(own: Mapping[str, Any], found: Mapping[str, Any]) -> list[float]:
    """Least, largest and span; zero where they are rounding beside the largest value of the same unit.

    Of forces beside the weight as well: those of a mechanism that carries none are all rounding.
    """
    size = _size(own["unit"], found)
    least, largest = (own[key] if abs(own[key]) > NOISE * size else 0.0 for key in ("least", "largest"))
    span = largest - least
    return [least, largest, span if span > NOISE * max(abs(least), abs(largest)) else 0.0]


def _size(unit: str, found: Mapping[str, Any]) -> float:
    """The largest value of a unit, of forces the weight if that is more."""
    same = [r for r in found["ranges"].values() if r["unit"] == unit]
    size = max((abs(r[key]) for r in same for key in ("least", "largest")), default=0.0)
    return max(size, found.get("weight", 0.0)) if unit == "N" else size


def _axis(name: str, ends: Sequence[float], unit: str) -> str:
    """An axis in words, angles in degrees, as they are typed."""
    low, high, count = ends
    factor, shown = (DEGREE, "deg") if unit == "rad" else (1.0, unit)
    return f"{name} {low * factor:.6g} to {high * factor:.6g}{'' if shown == '1' else f' {shown}'} ({count})"


def _tilt(found: Mapping[str, Any]) -> str:
    """How far the platform tilts, in a sentence; the least tilt that was looked at may not be allowed."""
    everywhere = "every_direction" in found
    least = found["every_direction" if everywhere else "directions_looked_at"]
    if least is None:
        where = found["azimuth"][found["reach"].index(None)] * DEGREE
        smallest = "not even upright" if everywhere else "not even the least tilt that was looked at"
        return f"no tilt is reached in every direction: {smallest} is allowed at azimuth {where:.4g} degrees"
    where_to = "every direction" if everywhere else "the directions that were looked at, which are not all"
    where = found["azimuth"][found["reach"].index(least)] * DEGREE
    return f"tilt of {least * DEGREE:.4g} degrees reached in {where_to}; least at azimuth {where:.4g} degrees"


def sweep_summary_text(found: Mapping[str, Any]) -> str:
    """The summary as text and tables."""
    units = found.get("axis_units", {})  # of a summary that an older version wrote
    axes = ", ".join(_axis(name, ends, units.get(name, "1")) for name, ends in found["axes"].items())
    around = f", {found['around']} more round holes" if "around" in found else ""
    in_mode = f" in mode {found['mode']}" if "mode" in found else ""
    lines = [
        f"{found['mechanism']}{in_mode}: {found['cases']} cases{': ' if axes else ''}{axes}",
        f"{found['reached'] - found.get('around', 0)} are reached straight from the start{around}, "
        f"{found['regular']} of them without passing a singularity, {found['allowed']} also within all limits",
    ]
    if "engine" in found:
        lines.append(f"computed by {found['engine']}")
    if "tilt" in found:
        lines.append(_tilt(found["tilt"]))
    if found["ranges"]:
        rows = [
            [name, *(f"{number:.6g}" for number in _without_noise(own, found)), own["unit"]]
            for name, own in found["ranges"].items()
        ]
        lines += ["", fitting_table(("over the allowed cases", "least", "largest", "span", "unit"), rows)]
    if "tolerance" in found:
        rows = []
        for name, r in found["tolerance"].items():
            noise = NOISE * _size(r["unit"], found)
            numbers = (r[key] if abs(r[key]) > noise else 0.0 for key in ("deviation", "5", "95"))
            rows.append([name, *(f"{number:.4g}" for number in numbers), r["unit"]])
        lines += [
            "",
            fitting_table(("about the mean of the samples", "standard deviation", "5 %", "95 %", "unit"), rows),
        ]
    return "\n".join(lines)
