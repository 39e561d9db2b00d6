"""How far joints may go, for the page: from end stops of the model, and from whoever read a robot's file.

end stops of the effects, limits by joint --joint_limits--> a row per limited freedom
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from symscrew.description import Mechanism, exact
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.functions import joint_freedom_labels
from symscrew.model import Model

Reach = tuple[float | None, float | None]
"""Lower and upper limit of a displacement [rad or m]; None: no limit on this side."""


def joint_limits(model: Model, given: Mapping[str, Reach]) -> list[dict[str, Any]]:
    """The limits of a model's joints: given ones by joint or freedom (`limb1_U.0`), else those of its end stops.

    Returns:
        Rows of plain data: joint (its number), freedom, at (entry of `joint_displacements`), label, low, high, and
        start, the displacement in the reference configuration.

    Raises:
        DescriptionError: a name that is no joint, or a lower limit that is not below the upper one.
    """
    labels = [(label, name) for label, _, name in joint_freedom_labels(model.system)]
    if not labels or "joint_displacements" not in model.programs:
        return []
    reaches = {**_of_stops(model), **{_label(name, labels): reach for name, reach in given.items()}}
    if not reaches:
        return []
    values = model.system.parameter_values
    inputs = [model.system.reference[None], *([values[None]] if len(values) else [])]
    start = model("joint_displacements", *inputs)[0][0][0]
    joints, made = list(model.mechanism.joints), []
    for at, (label, name) in enumerate(labels):
        if label in reaches:
            low, high = reaches[label]
            if low is not None and high is not None and not low < high:
                raise DescriptionError(f"limits of {label}: expected lower < upper, got {low:g} and {high:g}")
            freedom = [found for found, owner in labels if owner == name].index(label)
            made.append(
                {"joint": joints.index(name), "freedom": freedom, "at": at, "label": label, "low": low, "high": high,
                 "start": float(start[at])}
            )  # fmt: skip
    return made


def _label(name: str, labels: list[tuple[str, str]]) -> str:
    own = [label for label, joint in labels if name in (label, joint)]
    if not own:
        raise DescriptionError(f"limits: no joint {name!r}; {did_you_mean(name, [label for label, _ in labels])}")
    return own[0]


def _of_stops(model: Model) -> dict[str, Reach]:
    """The reach of every freedom that has end stops, the narrowest where it has several."""
    mechanism, found = model.mechanism, dict[str, Reach]()
    for joint, freedom, *ends in (stop for effect in model.effects for stop in effect.stops()):
        label = mechanism.joints[joint].kind.freedom_names(joint)[freedom]
        low, high = (_number(mechanism, end) for end in ends)
        before = found.get(label, (None, None))
        lows, highs = ([e for e in pair if e is not None] for pair in ((low, before[0]), (high, before[1])))
        found[label] = max(lows, default=None), min(highs, default=None)
    return found


def _number(mechanism: Mechanism, value: object) -> float | None:
    names = {name: parameter.symbol for name, parameter in mechanism.parameters.items()}
    return None if value is None else float(mechanism.number(exact(value, names, where="end stop")))
