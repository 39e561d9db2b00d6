"""Selections of functions by what somebody is about to do: `generate --functions kinematics`, or `control`.

names of functions and of presets, the functions that a model has --selected--> those of them that are meant
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence

from symscrew.errors import DescriptionError, did_you_mean

ALL = "all"
_PLACES = "forward_kinematics|platform_jacobian|drive_rates|drive_positions|inverse_kinematics|inverse_velocity"
_LOOPS = "velocity|acceleration|null_space|assemble"
PRESETS: Mapping[str, tuple[str, str]] = {
    "kinematics": (
        "places, rates and accelerations of all parts, closed loops, margins: nothing that needs a mass",
        rf"{_PLACES}|{_LOOPS}|body_(poses|twists|twist_rates)|point_motion|joint_(screws|points|displacements|rates)"
        r"|closure|closure_(jacobian|bias)|close_(position|velocity)|(limb|actuation)_margins|constraint_margin",
    ),
    "control": (
        "what a controller calls in every cycle: the way from motors to the platform and back, drive forces, mass "
        "matrix and bias",
        rf"{_PLACES}|{_LOOPS}|inverse_dynamics\w*(?<!_derivatives)|mass_matrix|bias",
    ),
}
"""Name -> what it is for, and a pattern of the functions in it; each with its checked variant."""

_STEMS = (
    rf"{_PLACES}|{_LOOPS}|body_(poses|twists|twist_rates)|point_motion|joint_(screws|points|displacements|rates)"
    r"|closure(_jacobian|_bias)?|close_(position|velocity)|(limb|actuation)_margins|constraint_margin|linearisation"
    r"|(inverse|forward)_dynamics(_independent)?|inverse_dynamics_(platform|preload)|forward_dynamics_reactions"
    r"|joint_reactions|mass_matrix|bias|energy|momentum_(screws|rates)|regressor(_drives|_independent)?"
    r"|(coupling|rolling)_forces|effect_(power|state_rates)"
)
_KNOWN = re.compile(rf"({_STEMS})(_derivatives|_hessian(_product)?)?(_checked)?")


def known_function(name: str) -> bool:
    """Whether some model may have a function of this name, the one at hand or another.

    >>> known_function("velocity_checked"), known_function("velocty")
    (True, False)
    """
    return bool(_KNOWN.fullmatch(name))


def preset(name: str, functions: Collection[str]) -> tuple[str, ...]:
    """Those of a model's functions that a preset names, in their order.

    >>> preset("control", ["body_poses", "velocity", "inverse_dynamics", "inverse_dynamics_checked", "energy"])
    ('velocity', 'inverse_dynamics', 'inverse_dynamics_checked')
    """
    return tuple(f for f in functions if name == ALL or re.fullmatch(rf"({PRESETS[name][1]})(_checked)?", f))


def selected(names: Sequence[str], functions: Collection[str], where: str = "the model") -> tuple[str, ...]:
    """The functions that names of functions and of presets mean, in the order of the model.

    Raises:
        DescriptionError: a name that is neither.
    """
    wanted: set[str] = set()
    for name in names:
        if name in functions:
            wanted.add(name)
        elif name == ALL or name in PRESETS:
            wanted.update(preset(name, functions))
        else:
            near = did_you_mean(name, [*functions, *PRESETS, ALL])
            raise DescriptionError(f"no {name!r} in {where}; {near}")
    return tuple(f for f in functions if f in wanted)
