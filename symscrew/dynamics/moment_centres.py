"""Points about which moments of a hub on a virtual free joint are taken: where one of its limbs pulls.

A free joint transmits nothing, so that all six rows of its hub vanish, and the moments about any point of the hub do
as well as those about its origin. About the end of a limb that ends in a ball, what the limb exerts has no moment: its
column of the equations at the hub has three zeros, and of limbs that share the point every one.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from symscrew.algebra import Vector
from symscrew.dynamics.rods import Rod
from symscrew.dynamics.setting import Setting


def moment_centre(setting: Setting, rods: Mapping[int, Rod]) -> dict[int, Vector]:
    """The link of the hub -> the point of it, in its coordinates, that most limbs end at; {} without such a hub."""
    tree = setting.tree
    hub = next((link for link in tree.links[1:] if link.joint == tree.virtual and link.motion.spherical), None)
    if hub is None or any(setting.virtual_directions):
        return {}
    ends = [rod.far for rod in rods.values() if rod.hub == hub.index]
    for c, cut in enumerate(setting.cuts):
        if cut.hub == hub.index and c not in rods and cut.is_joint and cut.joint.kind.ball and cut.arm is None:
            ends.append(cut.contact)
    return {hub.index: Counter(ends).most_common(1)[0][0]} if ends else {}
