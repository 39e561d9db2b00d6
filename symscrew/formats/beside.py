"""What a draft has beside its mechanism: effects, limits, and the account of everything."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from symscrew.errors import DescriptionError, shorten
from symscrew.formats.draft import Draft
from symscrew.formats.file_names import safe_names
from symscrew.formats.imported import Account, JointLimits
from symscrew.formats.rigid_displacements import Real

Named = Callable[[str], tuple[str, int | None]]


def loads_of(draft: Draft, points: Mapping[str, str]) -> tuple[Mapping[str, Any], ...]:
    """The draft's wrenches; `points`: point of the file -> point of the mechanism."""
    tables: list[dict[str, Any]] = []
    for load in draft.loads:
        table: dict[str, Any] = {"kind": "load", "point": points[load.point]}
        more = {"axes": "body"} if load.wrench is None else {"wrench": [float(c) for c in load.wrench]}
        tables.append({**table, **more})
    return tuple(tables)


def drags_of(draft: Draft, bodies: Mapping[str, str]) -> tuple[Mapping[str, Any], ...]:
    """What a medium does to bodies; `bodies`: body of the file -> body of the mechanism."""
    return tuple({"kind": "drag", "body": bodies[body], **table} for body, table in draft.drags.items())


def cords_of(draft: Draft, points: Mapping[str, str]) -> tuple[Mapping[str, Any], ...]:
    """The draft's springs over points; `points`: point of the file -> point of the mechanism."""
    tables = []
    for cord in draft.cords:
        plain = {key: value for key, value in cord.items() if key not in ("start", "through", "end")}
        through = tuple(points[name] for name in cord["through"])
        ends: dict[str, Any] = {"start": points[cord["start"]], "end": points[cord["end"]]}
        tables.append({"kind": "cord", **ends, **({"through": through} if through else {}), **plain})
    return tuple(tables)


def tendons_of(draft: Draft, points: Mapping[str, str]) -> tuple[Mapping[str, Any], ...]:
    """The draft's tendons and muscles; `points`: point of the file -> point of the mechanism."""
    called = safe_names(str(tendon["name"]) for tendon in draft.tendons)
    return tuple(
        {**tendon, "name": called[str(tendon["name"])], "path": [_passed(entry, points) for entry in tendon["path"]]}
        for tendon in draft.tendons
    )


def _passed(entry: Any, points: Mapping[str, str]) -> Any:
    """An entry of a path with the mechanism's names: those of points are the first and the last text of a wrap."""
    if isinstance(entry, str):
        return points[entry]
    if entry[0] == "pulley":
        return entry
    return [entry[0], points[entry[1]], *entry[2:4], *(points.get(side, side) for side in entry[4:])]


NOT_NEGATIVE = {"armature": "inertia", "damping": "coefficient", "friction": "coulomb"}
"""Kinds of forces -> the number of theirs that would bring in energy if it were negative."""


def check_forces(draft: Draft) -> None:
    """Refuse forces that no effect has, with the file's own names, and say limits that leave no place to be.

    Raises:
        DescriptionError: a rotor inertia, damping or friction is negative.
    """
    for effect in draft.effects:
        kind = effect.table["kind"]
        value = effect.table.get(NOT_NEGATIVE.get(kind, ""), 0)
        if value < 0:
            raise DescriptionError(
                f"joint {shorten(effect.joint)}, {kind}: expected a number of at least 0, got {value}"
            )
    for joint, found in draft.limits.items():
        for key in ("velocity", "effort"):
            size = getattr(found, key)
            if size is not None and size < 0:
                draft.ledger.changed.append(f"limits of {joint}: {key} {float(size):.6g} is below 0; it is not taken")
                setattr(found, key, None)
        if found.lower is not None and found.upper is not None and found.lower > found.upper:
            draft.ledger.changed.append(
                f"limits of {joint}: the lower one, {float(found.lower):.6g}, is above the upper one, "
                f"{float(found.upper):.6g}; neither is taken"
            )
            found.lower = found.upper = None


def forces_of(draft: Draft, named: Named) -> tuple[Mapping[str, Any], ...]:
    """The draft's forces of joints; `named`: joint of the file -> (joint of the mechanism, freedom or None)."""
    tables: list[dict[str, Any]] = []
    for effect in draft.effects:
        joint, freedom = named(effect.joint)
        table = {"kind": effect.table["kind"], "joint": joint, **effect.table}
        if freedom is not None and "freedom" not in table:
            table["freedom"] = freedom
        if effect.joint in draft.leads:
            table |= _about_the_screw(table, *map(float, draft.leads[effect.joint]))
        tables.append(table)
    return tuple(tables)


def _about_the_screw(table: Mapping[str, Any], pitch: float, slid: float, turned: float) -> dict[str, float]:
    """What of a force on the slide of a screw is another number at its hinge: s - slid = pitch (h - turned)."""
    squared = {key: table[key] * pitch**2 for key in ("inertia", "coefficient", "stiffness", "damping") if key in table}
    level = {"coulomb": table["coulomb"] * abs(pitch)} if "coulomb" in table else {}
    rest = {"rest": turned + (table["rest"] - slid) / pitch} if "rest" in table and pitch else {}
    return squared | level | rest


def starts_of(given: Mapping[str, Mapping[tuple[str, str], Real]], named: Named) -> dict[str, dict[str, float]]:
    """Keyframe -> label of a coordinate or rate -> value; parts of joints that have none of their own are left out."""
    found: dict[str, dict[str, float]] = {}
    for name, values in given.items():
        found[name] = {}
        for (joint, part), value in values.items():
            whole, freedom = named(joint)
            suffix = part or ("" if freedom is None else str(freedom))
            found[name][f"{whole}.{suffix}" if suffix else whole] = float(value)
    return found


def limits_of(draft: Draft, places: Callable[[str], str | None]) -> dict[str, JointLimits]:
    """Limits as doubles; `places`: joint of the file -> joint of the mechanism, or freedom of one with several.

    A screw has those of its hinge, and of its slide the reach, as turns of the hinge.
    """
    made: dict[str, JointLimits] = {}
    for joint, found in draft.limits.items():
        place = places(joint)
        if place is None or joint in draft.leads:
            continue
        values = (found.lower, found.upper, found.velocity, found.effort)
        made[place] = JointLimits(*(None if value is None else float(value) for value in values))
    for joint, (pitch, slid, turned) in draft.leads.items():
        place, ends = places(joint), draft.limits.get(joint)
        if place is None or ends is None or not pitch:
            continue
        reach = [None if end is None else float(turned + (end - slid) / pitch) for end in (ends.lower, ends.upper)]
        low, high = reach if pitch > 0 else reach[::-1]
        own = made.get(place, JointLimits())
        lows, highs = ([e for e in pair if e is not None] for pair in ((low, own.lower), (high, own.upper)))
        made[place] = replace(own, lower=max(lows, default=None), upper=min(highs, default=None))
    return made


def account_of(draft: Draft) -> Account:
    """What became of everything that the file says."""
    taken = {
        "bodies": len(draft.bodies),
        "joints": len(draft.joints),
        "driven joints": sum(bool(joint.driven) for joint in draft.joints),
        "couplings": len(draft.couplings),
        "points": len(draft.points),
    }
    found = {what: count for what, count in taken.items() if count}
    ledger = draft.ledger
    return Account(found, dict(ledger.effects), dict(ledger.harmless), dict(ledger.influence), tuple(ledger.changed))
