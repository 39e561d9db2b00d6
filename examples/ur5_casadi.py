"""Inverse dynamics of the UR5 as a CasADi function: saved by symscrew, loaded with CasADi alone.

Run it: python examples/ur5_casadi.py
"""

import tempfile
from pathlib import Path

import casadi as ca

from symscrew import catalogue
from symscrew.generation import generate
from symscrew.model import derive

mechanism = catalogue.load("ur5")
directory = Path(tempfile.mkdtemp(prefix="ur5_"))
generate(derive(mechanism), directory, targets=["casadi"])

# from here on without symscrew
inverse_dynamics = ca.Function.load(str(directory / "inverse_dynamics.casadi"))
print(inverse_dynamics)

q, v, a = ca.SX.sym("q", 6), ca.SX.sym("v", 6), ca.SX.sym("a", 6)
torque = inverse_dynamics(q=q, v=v, a=a)["u"]
stiffness = ca.Function("stiffness", [q, v, a], [ca.jacobian(torque, q)])
print("d torque / d q at rest:", stiffness(0, 0, 0))

# the torque of the second joint holds the weight of the whole stretched arm
at_rest = inverse_dynamics(q=0, v=0, a=0)["u"]
axis = [float(c) for c in mechanism.joints["shoulder_lift_joint"].axes[0]]
pivot = [float(mechanism.number(c)) for c in mechanism.joints["shoulder_lift_joint"].point]
by_hand = 0.0
for name in ("upper_arm_link", "forearm_link", "wrist_1_link", "wrist_2_link", "wrist_3_link"):
    body = mechanism.bodies[name]
    arm = [float(mechanism.number(c)) - p for c, p in zip(body.com, pivot, strict=True)]
    # -axis . (arm x weight), weight = (0, 0, -m g)
    by_hand += float(mechanism.number(body.mass)) * 9.81 * (axis[0] * arm[1] - axis[1] * arm[0])
print(f"shoulder {float(at_rest[1]):.6f} N m, by hand {by_hand:.6f} N m")
assert abs(float(at_rest[1]) - by_hand) < 1e-9
