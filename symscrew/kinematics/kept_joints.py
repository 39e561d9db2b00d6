"""Joints whose displacement is read beyond half a turn, and so are no places to cut a loop: others are cut instead.

    tree, joints that must stay --swap along the loop--> tree that has them

A pitch makes of a whole turn another place, and an effect may ask for any number of turns. A pose does not tell them;
a coordinate of the tree does, and so does a sum of coordinates where all axes of the loop are parallel.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping

import sympy

from symscrew.description import Joint, Mechanism
from symscrew.errors import DescriptionError
from symscrew.kinematics.parameter_trials import always_below

Reached = dict[str, tuple[str, bool]]
"""Body -> (joint that reaches it, whether passed from child to parent)."""

SAME_DIRECTION = 1e-25
"""Components of unit axes, or their cosine and 1, that differ by less, of 30 digits, are equal: a planar mechanism must
be so by design."""


def keeping(
    mechanism: Mechanism,
    joints: Mapping[str, Joint],
    reached: Reached,
    *,
    read: Collection[str],
    coupled: Collection[str] = (),
    grow: Callable[[dict[str, Joint]], Reached],
) -> Reached:
    """A tree with all joints of `read` and all helical ones whose turns its coordinates do not add up to, all coupled
    ones and others that need coordinates of their own, and those at which no loop can be cut, as free ones.

    `grow` makes the tree of some joints. Of a loop a joint without a drive and with most freedoms is cut instead.

    Raises:
        DescriptionError: all joints of a loop would have to stay.
    """
    # A ball's turns add up to nothing: it has no displacement beyond half a turn.
    turning = {name for name, joint in joints.items() if len(joint.kind.turning) == 1 and not joint.kind.spherical}
    turning |= {name for name, joint in joints.items() if joint.kind.universal}
    uncut = {name for name, joint in joints.items() if not joint.kind.closable}
    must = {name for name in turning if joints[name].kind.helical or name in read} | {*coupled, *uncut}
    for name in [name for name in mechanism.joints if name in must]:
        used = {joint for joint, _ in reached.values()}
        if name in used:
            continue
        loop = _loop(mechanism, joints, reached, joints[name])
        if name not in coupled and name not in uncut and _parallel(mechanism, [*loop, joints[name]]):
            continue
        free = [j for j in loop if j.name not in must and j.name in mechanism.joints]
        if not free and name in uncut:
            continue  # which `cut_joints` says
        if not free:
            raise DescriptionError(
                f"joints.{name}: its displacement is asked for over whole turns, coupled, bound by events or turns a "
                "rotor, and so is that of every joint of its loop, of which one has to be cut; divide one of them into "
                "two with a body between them"
            )
        cut = max(free, key=lambda j: (not j.driven, j.kind.freedom))
        reached = grow({n: j for n, j in joints.items() if (n in used and n != cut.name) or n == name})
    return reached


def _loop(mechanism: Mechanism, joints: Mapping[str, Joint], reached: Reached, closing: Joint) -> list[Joint]:
    """The joints of the tree between the two bodies of a joint that closes a loop."""
    ways = []
    for end in (closing.parent, closing.child):
        way, body = list[str](), end
        while body != mechanism.ground:
            name, inverted = reached[body]
            way.append(name)
            body = joints[name].child if inverted else joints[name].parent
        ways.append(way)
    return [joints[name] for k, way in enumerate(ways) for name in way if name not in ways[1 - k]]


def _parallel(mechanism: Mechanism, loop: list[Joint]) -> bool:
    """Whether all that turns in a loop turns about parallel axes."""
    axes = []
    for joint in loop:
        if joint.kind.spherical:
            return False
        axes += [joint.axes[k if len(joint.axes) > 1 else 0] for k in joint.kind.turning]
    cosines = (sum(a * b for a, b in zip(axes[0], other, strict=True)) for other in axes)
    return all(always_below(mechanism, abs(sympy.S(cosine)) - 1, SAME_DIRECTION) for cosine in cosines)
