"""An own planar 3-RRR from limb strings: mobility, C files, torques of its three motors.

Run it: python examples/planar_3rrr.py [DIR]
"""

import sys
import tempfile

import numpy as np

from symscrew.description import MechanismBuilder
from symscrew.effects import ExternalWrench
from symscrew.generation import generate
from symscrew.mobility import analyse_mobility
from symscrew.model import derive
from symscrew.runtime import load

builder = MechanismBuilder("table", platform="plate")
builder.body("plate", mass="1.5", com=[0, 0, 0], inertia=["0.01", "0.01", "0.02"])
for k, angle in enumerate(("pi/2", "7*pi/6", "11*pi/6"), 1):
    c, s = f"cos({angle})", f"sin({angle})"
    builder.limb(
        f"limb{k}",
        "R*RR",
        points=[
            [f"0.45*{c}", f"0.45*{s}", 0],  # on the base
            [f"0.30*{c}-0.2*{s}", f"0.30*{s}+0.2*{c}", 0],  # elbow
            [f"0.15*{c}", f"0.15*{s}", 0],  # on the plate
        ],
        axes=[[0, 0, 1]] * 3,
    )
builder.point("E", body="plate", at=[0, 0, 0])
mechanism = builder.build()
mobility = analyse_mobility(mechanism)
print(mobility.report())
assert mobility.dof == 3

# gravity acts across the plane and is left out; a load at E is an input
model = derive(mechanism, (ExternalWrench("E"),))
directory = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp(prefix="table_")
files = generate(model, directory, targets=["c"])
print(f"{len(files)} files in {directory}")

functions = load(directory)  # from the files: the model is not needed any more
rest = np.zeros(len(model.system.tree.v))
torques = functions.inverse_dynamics(model.system.reference, rest, rest, np.array([0, 0, 0, 0, 0, 1.0]))
print("torques that hold 1 N m on the plate:", torques)

# by hand: a crank turns by -1/2 of the plate's angle here, and the three motors share the power
assert abs(torques - 2 / 3).max() < 1e-12
