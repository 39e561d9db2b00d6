"""Where three driven limbs of a planar mechanism lose their hold: three lines of force in the plane.

With its drive locked, a limb of three hinges and slides about and along the plane's normal gives one force in the
plane: through the axes of its two other hinges, or through its hinge across its slide. Three forces of a plane are
dependent exactly where their lines meet in a point or are parallel.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from symscrew.mobility.carrying_limbs import carried_by_limbs

if TYPE_CHECKING:
    from symscrew.description import Joint
    from symscrew.mobility.analysis import Mobility


def lines_of_drives(found: Mobility) -> list[str]:
    """The condition as a line of words; nothing where the mechanism is no such one."""
    mechanism = found.mechanism
    planar = found.platform.body == mechanism.platform and found.platform.motion_type == "1R2T"
    if not planar or len(mechanism.limbs) != 3 or not carried_by_limbs(mechanism):
        return []
    if not all(loop.group.startswith("G") for loop in found.counts.loops):
        return []
    lines = [_line([mechanism.joints[name] for name in limb.joints]) for limb in mechanism.limbs.values()]
    if not all(lines):
        return []
    named = ", ".join(f"of {name} {line}" for name, line in zip(mechanism.limbs, lines, strict=True))
    return [f"A freedom is left with all drives locked where three lines meet in a point or are parallel: {named}"]


def _line(joints: list[Joint]) -> str:
    """Through which axes the force of a limb runs; empty where it is no limb of three hinges and slides, one driven."""
    motions = [j.kind.motions for j in joints]
    if [len(of) == 1 and not (of[0].spherical or of[0].helical) for of in motions] != [True] * 3:
        return ""
    if sum(bool(j.driven) for j in joints) != 1:
        return ""
    first, second = (j for j in joints if not j.driven)
    hinges = [j for j in (first, second) if j.kind.turning]
    if len(hinges) == 2:
        return f"through {first.name} and {second.name}"
    if not hinges:
        return ""  # two slides leave a couple, a line at infinity
    return f"through {hinges[0].name} across {(second if hinges[0] is first else first).name}"
