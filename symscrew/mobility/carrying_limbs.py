"""Whether a platform's freedoms are what its limbs leave it: only where limbs, side by side, are all that carries it.

An H4's limbs end at side bars on which the platform turns, so that their constraints are not the platform's; a limb
with a parallelogram that is not among its joints forbids more than its joints do.
"""

from __future__ import annotations

from symscrew.description import Mechanism


def carried_by_limbs(mechanism: Mechanism) -> bool:
    """Whether every limb leads from the ground to the platform, and no loop is closed but by their side by side."""
    named = [joint for limb in mechanism.limbs.values() for joint in limb.joints]
    if mechanism.platform is None or not named or len(set(named)) < len(named):
        return False
    for limb in mechanism.limbs.values():
        body = mechanism.ground
        for name in limb.joints:
            joint = mechanism.joints[name]
            if body not in (joint.parent, joint.child):
                return False
            body = joint.child if body == joint.parent else joint.parent
        if body != mechanism.platform:
            return False
    return len(mechanism.joints) - len(mechanism.bodies) + 1 == len(mechanism.limbs) - 1  # loops
