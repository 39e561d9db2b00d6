"""The pointing platform 3UPS-UPU-S from its TOML file: drives in motion, drives under a load at rest.

Run it: python examples/seed_statics.py
"""

from pathlib import Path

import numpy as np

import symscrew.catalogue
from symscrew.description import load_description
from symscrew.effects import ExternalWrench, Gravity
from symscrew.model import derive
from symscrew.runtime import load

file = Path(symscrew.catalogue.__file__).parent / "three_ups_upu_s_physical.toml"
mechanism = load_description(file)

# the load at point E is a further input of the functions
model = derive(mechanism, (Gravity(), ExternalWrench("E")))
functions = load(model)

q = model.system.reference
rest = np.zeros(15)
force_and_moment = np.array([0, 0, 1000, 1000, 0, 0])  # N, N m
drives = functions.inverse_dynamics(q, rest, rest, force_and_moment)
for label, drive in zip(functions["inverse_dynamics"].outputs[0].labels, drives, strict=True):
    print(f"{label} {drive:9.3f} N")

# by hand: two legs, each leaning by 30 degrees at the radius R, share the moment of 1000 N m
by_hand = 1000 / (2 * 0.8 * np.cos(np.radians(30)))
assert abs(drives - [0, by_hand, 0, -by_hand]).max() < 1e-9

# in motion: velocities and accelerations follow from those of the independent coordinates
v = functions.velocity(q, np.array([0.1, 0.2]))
a = functions.acceleration(q, v, np.array([1.0, 0.0]))
u, reactions = functions.joint_reactions(q, v, a, np.zeros(6))
print("drives in motion:", u.round(4))
print("force at O:", reactions[:3, list(mechanism.joints).index("limb5_S")].round(4))
