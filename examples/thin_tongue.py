"""A five-bar whose rods do not quite reach each other on a strip of drive angles: a grid misses it, a proof does not.

Arms stretched away from each other put the elbows 2.002 m apart, both rods together are 2.0018 m long. Every one of
11 x 11 samples can be put together; the certificate leaves the strip undecided and joins no box behind it to the start.
With a file name as argument boxes and samples are drawn.
"""

import sys

import numpy as np

import symscrew
from symscrew.studies.certificate import certify
from symscrew.studies.workspace import Axis, Plan

GAP, ARM, ROD = 0.001, 1.0, 1.0009  # m: half the distance of the pivots, an arm, a rod
START = np.array([2.55, 0.35])  # rad, of the arms in the reference configuration
LOW, HIGH = np.array([-0.1, -0.7616]), np.array([0.7, 0.0384])  # rad, from there
SAMPLES = 11


def elbows(angles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    left, right = (ARM * np.stack([np.cos(a), np.sin(a)], axis=-1) for a in np.moveaxis(angles, -1, 0))
    return left - np.array([GAP, 0]), right + np.array([GAP, 0])


def apart(angles: np.ndarray) -> np.ndarray:
    """How far the elbows are from what both rods reach [m]: above zero the mechanism cannot be put together."""
    left, right = elbows(angles)
    return np.asarray(np.linalg.norm(right - left, axis=-1) - 2 * ROD)


a, b = elbows(START)
half = (b - a) / 2
tip = (a + b) / 2 + np.array([-half[1], half[0]]) * np.sqrt(ROD**2 / (half @ half) - 1)
builder = symscrew.MechanismBuilder("thin_tongue", platform="left_rod")
for body in ("left_arm", "right_arm", "left_rod", "right_rod"):
    builder.body(body, mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
for name, parent, child, (x, y) in (
    ("left", "base", "left_arm", (-GAP, 0.0)), ("left_elbow", "left_arm", "left_rod", a),
    ("right", "base", "right_arm", (GAP, 0.0)), ("right_elbow", "right_arm", "right_rod", b),
    ("tip", "right_rod", "left_rod", tip),
):  # fmt: skip
    driven = name in ("left", "right")
    at = [float(x), float(y), 0]
    builder.joint(name, "R", parent=parent, child=child, point=at, axes=[[0, 0, 1]], driven=driven)
mechanism = builder.build()

samples = np.stack(np.meshgrid(*np.linspace(LOW, HIGH, SAMPLES).T, indexing="ij"), axis=-1).reshape(-1, 2)
closed = int((apart(START + samples) < 0).sum())
print(f"{closed} of {SAMPLES} x {SAMPLES} samples can be put together: a grid sees nothing")

names = ("left", "right")
found = certify(Plan(mechanism, (), tuple(Axis(n, *ends, 17) for n, *ends in zip(names, LOW, HIGH, strict=True))))
shares = found.summary["shares"]
print(f"proved: {found.summary['share']:.0%} of the region, in {found.summary['boxes']} boxes")
print(f"undecided: {shares['undecided']:.0%} ({', '.join(found.summary['undecided'])})")
print(f"free of singularities, but no chain of such boxes leads there: {shares['not joined']:.0%}")

fine = np.stack(np.meshgrid(*np.linspace(LOW, HIGH, 401).T, indexing="ij"), axis=-1).reshape(-1, 2)
lost = fine[apart(START + fine) > 0]
print(f"of 401 x 401 samples {len(lost) / len(fine):.1%} cannot be put together: all in undecided boxes")
assert closed == SAMPLES**2 and len(lost) > 1000 and not found.summary["whole"]
for box in found.root.leaves:
    inside = ((box.low <= lost) & (lost <= box.high)).all(axis=1)
    assert box.state == "undecided" or not inside.any()

if len(sys.argv) > 1:
    from matplotlib import pyplot as plt
    from matplotlib.patches import Rectangle

    figure, axes = plt.subplots(figsize=(5.2, 4.4), layout="constrained")
    colours = {"proved": "#b8d8ba", "not joined to the start": "#cfd8e6", "undecided": "#f2c9a0"}
    for box in found.root.leaves:
        kind = "proved" if box.joined else "undecided" if box.state == "undecided" else "not joined to the start"
        size = box.high - box.low
        axes.add_patch(Rectangle(box.low, *size, facecolor=colours[kind], edgecolor="white", linewidth=0.4))
    for kind, colour in colours.items():
        axes.plot([], [], "s", color=colour, label=kind)
    axes.plot(*lost[::3].T, ",", color="tab:red")
    axes.plot([], [], "s", color="tab:red", label="cannot be put together")
    axes.plot(*samples.T, "k.", markersize=4, label=f"{SAMPLES} x {SAMPLES} samples")
    axes.set(xlabel="left [rad]", ylabel="right [rad]", xlim=(LOW[0], HIGH[0]), ylim=(LOW[1], HIGH[1]))
    figure.legend(loc="outside upper center", ncols=3, frameon=False, fontsize=8)
    figure.savefig(sys.argv[1], dpi=110)
