"""How far a hexapod's tool is off with parts as they are made: a million machines drawn at random, in seconds.

Run it: python examples/hexapod_tolerances.py [SAMPLES] [PICTURE.png]        a million samples without

Centres of the twelve joints are off by 20 um in every direction, the six legs by 10 um (standard deviations).
The tool stands at a pose off the middle, where the controller of the nominal machine puts it: every sample is a whole
forward solution of its own geometry, by compiled code on all processors. Linear propagation, covariance = J S J^T with
J by central differences, says what to expect for small errors; the samples say whether they are small.
"""

import sys
import time

import numpy as np

from symscrew.description import MechanismBuilder
from symscrew.model import derive
from symscrew.runtime import load

samples = int(sys.argv[1]) if len(sys.argv) > 1 and sys.argv[1].isdecimal() else 1_000_000
picture = next((name for name in sys.argv[1:] if name.endswith(".png")), None)
JOINT, LEG = 20e-6, 10e-6  # standard deviations [m]
PIECE = 100_000  # samples at a time: memory does not grow with their number

degrees = np.radians([[-10, -50], [10, 50], [110, 70], [130, 170], [230, 190], [250, 290]])
ring = np.stack([np.cos(degrees), np.sin(degrees)], axis=2)
height = 0.8
base = np.pad(0.5 * ring[:, 0], ((0, 0), (0, 1)))
platform = np.pad(0.3 * ring[:, 1], ((0, 0), (0, 1)), constant_values=height)

builder = MechanismBuilder("hexapod", platform="platform")
builder.body("platform", mass=2, com=[0, 0, height], inertia=["0.02", "0.02", "0.04"])
legs = platform - base
along = legs / np.linalg.norm(legs, axis=1)[:, None]
for k in range(6):
    for place in ("base", "platform"):
        for axis in "xyz":
            builder.parameter(f"{place}{k + 1}{axis}", 0, "m", run_time=True)
    across = np.cross([0, 0, 1], along[k])
    across /= np.linalg.norm(across)
    builder.limb(
        f"leg{k + 1}",
        "UP*S",
        points=[
            [f"{float(x)!r} + {name}{k + 1}{axis}" for x, axis in zip(point[k], "xyz", strict=True)]
            for name, point in (("base", base), ("platform", platform))
        ],
        axes=[[across.tolist(), np.cross(along[k], across).tolist()], [along[k].tolist()], []],
    )
builder.point("tool", body="platform", at=[0, 0, height + 0.1])
mechanism = builder.build()
drives = [f"leg{k + 1}_P2" for k in range(6)]
model = derive(mechanism, (), independent=drives).only(["assemble", "forward_kinematics"])
functions = load(model)
names = [p.name for p in mechanism.parameters.values()]

# where the controller puts it: 60 mm aside, 40 mm up, tilted by 10 degrees about x; lengths of its legs there
c, s = np.cos(np.radians(10)), np.sin(np.radians(10))
turned = (platform - [0, 0, height]) @ np.array([[1, 0, 0], [0, c, -s], [0, s, c]]).T
wanted = turned + np.array([0.06, 0.0, height + 0.04])
lengths = np.linalg.norm(wanted - base, axis=1)


def strokes(deviations, errors):
    """Coordinates of the sliders (n, 6) [m] at which legs have their lengths, with errors of these (n, 6)."""
    moved = deviations.reshape(-1, 6, 2, 3)  # leg, place, axis
    ends = legs + moved[:, :, 1] - moved[:, :, 0]
    part = np.einsum("nka,ka->nk", ends, along)
    return np.sqrt(part**2 - (ends**2).sum(axis=2) + (lengths + errors) ** 2) - part


def tools(deviations, errors, guess):
    """Where the tool is (n, 3) [m], with deviations of the parameters (n, 36) and of the lengths (n, 6)."""
    y = strokes(deviations, errors)
    q, status = functions.assemble(y, guess, deviations, check=False, threads=2)
    assert not status.any(), "every machine can be assembled"
    return functions.forward_kinematics(q, deviations)[:, :, 0]


assert names == [f"{place}{k + 1}{axis}" for k in range(6) for place in ("base", "platform") for axis in "xyz"]
still, guess = np.zeros((1, 36)), model.system.reference
for part in np.linspace(0.1, 1, 10):  # to the pose in strides, so that it is the branch that is meant
    way = np.linalg.norm(base + legs + part * (wanted - platform) - base, axis=1)
    y = strokes(still, way - lengths)
    guess = functions.assemble(y, guess, still)[0]
nominal = tools(still, np.zeros((1, 6)), guess)[0]
by_hand = np.array([0.06, -0.1 * s, height + 0.04 + 0.1 * c])
assert np.abs(nominal - by_hand).max() < 1e-12

# linear: J by central differences, whose steps are a tenth of the tolerances
sigma = np.repeat([JOINT, LEG], [36, 6])
steps = 0.1 * np.concatenate([np.diag(sigma), -np.diag(sigma)])
found = tools(steps[:, :36], steps[:, 36:], guess)
slopes = (found[:42] - found[42:]) / (0.2 * sigma)[:, None]
linear = (slopes * sigma[:, None]).T @ (slopes * sigma[:, None])

random = np.random.default_rng(7)
errors = np.empty((samples, 3))
begin = time.perf_counter()
for first in range(0, samples, PIECE):
    drawn = random.standard_normal((min(PIECE, samples - first), 42)) * sigma
    errors[first : first + len(drawn)] = tools(drawn[:, :36], drawn[:, 36:], guess) - nominal
seconds = time.perf_counter() - begin
sampled = np.cov(errors.T)
size = np.linalg.norm(errors, axis=1)
print(f"{samples} machines in {seconds:.1f} s")
for name, one, other, mean in zip("xyz", np.diag(sampled), np.diag(linear), errors.mean(axis=0), strict=True):
    print(f"{name}: {one**0.5 * 1e6:.2f} um (linear {other**0.5 * 1e6:.2f}), mean {mean * 1e6:+.3f} um")
print(f"off by at most {np.quantile(size, 0.95) * 1e6:.1f} um in 95 of 100 machines, {size.max() * 1e6:.1f} um of all")

# what samples leave: a covariance has a relative deviation of sqrt(2 / n), a mean that of sqrt(1 / n)
scale = np.sqrt(np.outer(np.diag(linear), np.diag(linear)))
assert np.abs((sampled - linear) / scale).max() < 5 * np.sqrt(2 / samples) + 1e-4
assert np.abs(errors.mean(axis=0) / np.sqrt(np.diag(linear))).max() < 5 * np.sqrt(1 / samples) + 1e-3

if picture is not None:
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    across, up = errors[:, 0] * 1e6, errors[:, 2] * 1e6
    left.hist2d(across, up, bins=150, cmap="Greys", rasterized=True)
    angle = np.linspace(0, 2 * np.pi, 200)
    root = np.linalg.cholesky(linear[np.ix_([0, 2], [0, 2])]) * 1e6
    for radius in (1, 2, 3):
        left.plot(*(radius * root @ [np.cos(angle), np.sin(angle)]), "C3", linewidth=1)
    left.set(xlabel="tool off in x [µm]", ylabel="in z [µm]", aspect="equal", title="samples; 1, 2, 3 sigma by J S Jᵀ")
    right.hist(size * 1e6, bins=200, density=True, color="0.6")
    right.axvline(np.quantile(size, 0.95) * 1e6, color="C3", linewidth=1, label="95 %")
    right.set(xlabel="distance of the tool from nominal [µm]", ylabel="share [1/µm]", title=f"{samples:,} machines")
    right.legend()
    figure.savefig(picture, dpi=100)
