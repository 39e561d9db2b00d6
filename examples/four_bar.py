"""A planar four-bar from Python: description, model, compiled C, torque of the crank.

Run it: python examples/four_bar.py
"""

import numpy as np

from symscrew.description import MechanismBuilder
from symscrew.model import derive
from symscrew.runtime import load

builder = MechanismBuilder("my_four_bar", platform="rocker")
builder.parameter("a", "0.15", unit="m", description="length of the crank")

# slender rods in the x-z plane: crank A-B, coupler B-C, rocker C-D; all joints turn about y
builder.body("crank", mass="0.5", com=[0, 0, "a/2"], inertia=["0.5*a^2/12", "0.5*a^2/12", 0])
builder.body("coupler", mass="1.2", com=["0.2", 0, "0.3"], inertia=["0.009", "0.025", "0.016"])
builder.body("rocker", mass="1.2", com=["0.52", 0, "0.225"], inertia=["0.02025", "0.02601", "0.00576"])
for name, parent, child, point in (
    ("A", "base", "crank", [0, 0, 0]),
    ("B", "crank", "coupler", [0, 0, "a"]),
    ("C", "coupler", "rocker", ["0.4", 0, "0.45"]),
    ("D", "base", "rocker", ["0.64", 0, 0]),
):
    builder.joint(name, "R", parent=parent, child=child, point=point, axes=[[0, 1, 0]], driven=name == "A")

model = derive(builder.build())
functions = load(model)  # prints C, compiles it, calls it; CasADi where there is no C compiler

# a crank that turns at 10 rad/s: configuration, rates and accelerations of all joints from the crank's
crank = np.linspace(0, 2 * np.pi, 181)[:, None]
q = np.tile(model.system.reference, (len(crank), 1))
for k in range(1, len(crank)):
    q[k] = functions.assemble(crank[k], q[k - 1])
v = functions.velocity(q, np.full_like(crank, 10.0))
a = functions.acceleration(q, v, np.zeros_like(crank))
torque = functions.inverse_dynamics(q, v, a)

print(f"crank torque between {torque.min():.3f} and {torque.max():.3f} N m")

# what the motor puts in is kinetic and potential energy, here from a quarter turn to a half
energy = functions.energy(q, v).sum(axis=1)
quarter = slice(45, 91)
work = np.trapezoid(torque[quarter, 0], crank[quarter, 0])
print(f"work {work:.4f} J, energy {energy[90] - energy[45]:.4f} J")
assert abs(work - (energy[90] - energy[45])) < 1e-3
