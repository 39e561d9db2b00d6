"""Mobility of the pointing platform 3UPS-UPU-S: which limbs it needs, and what its fourth axis does.

Run it: python examples/seed_mobility.py
"""

from dataclasses import replace
from itertools import combinations

import sympy

from symscrew import analyse_mobility, catalogue

seed = catalogue.load("three_ups_upu_s")


def without(*limbs):
    """The mechanism without some of its limbs."""
    return replace(
        seed,
        joints={name: joint for name, joint in seed.joints.items() if not name.startswith(limbs)},
        bodies={name: body for name, body in seed.bodies.items() if not name.startswith(limbs)},
        limbs={name: limb for name, limb in seed.limbs.items() if name not in limbs},
    )


# section 3.2 of the paper: UPU + S + one UPS has the freedoms of the whole
whole = analyse_mobility(seed).platform
for kept in ("limb2", "limb3", "limb4"):
    left_out = tuple(name for name in ("limb2", "limb3", "limb4") if name != kept)
    fewer = analyse_mobility(without(*left_out)).platform
    assert (fewer.type, fewer.freedoms.basis) == (whole.type, whole.freedoms.basis)
print(f"UPU + S + one UPS: {whole.type}, the same freedoms as the whole")

# limbs that may be left out: in the reference pose the drives that remain must hold the platform
may_go = []
for count in (1, 2, 3):
    for limbs in combinations(("limb2", "limb3", "limb4"), count):
        left = analyse_mobility(without(*limbs)).dof_drives_locked
        print(f"without {', '.join(limbs)}: {left} freedoms left with the drives locked")
        may_go += [limbs] if left == 0 else []
assert may_go == [("limb2",), ("limb3",), ("limb4",), ("limb2", "limb3"), ("limb3", "limb4")]

# a horizontal fourth axis: limb 1 gives a couple about z instead of a force along y
joint = seed.joints["limb1_U2"]
x = (sympy.Integer(1), sympy.Integer(0), sympy.Integer(0))
horizontal = analyse_mobility(
    replace(seed, joints={**seed.joints, "limb1_U2": replace(joint, axes=(x, joint.axes[1]))})
)
(couple,) = horizontal.symbolic.limbs[0].constraints
print(f"limb 1 with a horizontal fourth axis constrains by (f ; m) = {couple}")
assert couple == (0, 0, 0, 0, 0, 1) and horizontal.platform.type == "2R"
