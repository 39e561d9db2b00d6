"""A motion of a planar 3-RRR on which the nearest solution jumps, and on which the certified one refuses to follow.

Newton's method from the last pose is what controllers do. Here two assembly modes meet and are gone on the way:
Newton's method finds another one, the platform of the model jumps, the real one would be driven into its singularity.
The C of target `modes` leads the mode by proved steps and stops before, with a status. With a file name as argument
all modes along the motion are drawn.
"""

import ctypes
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

import symscrew

STEPS = 200
GOAL = np.array([1.448, 0.36, -0.808])  # rad, of the three cranks

mechanism = symscrew.load_catalogue("planar_3rrr")
out = Path("planar_3rrr_modes")
symscrew.generate(symscrew.derive(mechanism).only(["assemble"]), out, ["modes"])
compiler = shutil.which("cc") or sys.exit("this example needs a C compiler")
source, library = out / "planar_3rrr_modes.c", out.resolve() / "modes.so"
subprocess.run([compiler, "-std=c99", "-O1", "-fPIC", "-shared", source, "-o", library, "-lm"], check=True)
c = ctypes.CDLL(str(library))


class Mode(ctypes.Structure):
    """As in planar_3rrr_modes.h."""

    _fields_ = [("drives", ctypes.c_double * 3), ("pose", ctypes.c_double * 12), ("z", ctypes.c_double * 4),
                ("error", ctypes.c_double), ("certified", ctypes.c_int)]  # fmt: skip

    @property
    def angle(self) -> float:
        """Of the platform [rad]."""
        return float(np.arctan2(self.pose[1], self.pose[0]))


def array(values: np.ndarray) -> ctypes.Array:
    return (ctypes.c_double * 3)(*values)


def all_modes(cranks: np.ndarray) -> list[Mode]:
    modes, count = (Mode * 6)(), ctypes.c_int()
    c.planar_3rrr_assembly_modes(array(cranks), modes, ctypes.byref(count))
    return list(modes[: count.value])


def turn(angle: float) -> np.ndarray:
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


thirds = [turn(2 * np.pi / 3 * k) for k in range(3)]
base, elbow, tip = (np.array([t @ np.array(p) for t in thirds]) for p in ([0, 0.45], [-0.2, 0.3], [0, 0.15]))


def nearest(pose: np.ndarray, cranks: np.ndarray) -> np.ndarray:
    """Newton's method for x, y, angle from the last pose: links are 0.25 m long; long steps are shortened."""
    elbows = base + np.array([turn(a) @ (e - b) for a, e, b in zip(cranks, elbow, base, strict=True)])
    for _ in range(300):
        arm = tip @ turn(pose[2]).T
        way = pose[:2] + arm - elbows
        length = np.linalg.norm(way, axis=1)
        unit = way / length[:, None]
        slopes = np.column_stack([unit, unit[:, 1] * arm[:, 0] - unit[:, 0] * arm[:, 1]])
        step = np.linalg.solve(slopes, 0.25 - length)
        pose = pose + step * min(1.0, 0.3 / max(np.abs(step).max(), 1e-300))
        if np.abs(step).max() < 1e-13:
            break
    return pose


mode = min(all_modes(np.zeros(3)), key=lambda m: abs(m.angle))
pose, newton, certified = np.zeros(3), [(0.0, 0.0)], [(0.0, 0.0)]
jump, jumped_at, refused_at = 0.0, 0.0, 0.0
for s in np.arange(1, STEPS + 1) / STEPS:
    after = nearest(pose, s * GOAL)
    jump, jumped_at = max((jump, jumped_at), (abs(after[2] - pose[2]), float(s)))
    pose = after
    newton.append((float(s), float(np.degrees(pose[2]))))
    if not refused_at:
        status = c.planar_3rrr_nearest_mode(ctypes.byref(mode), array(s * GOAL))
        if status == 0:
            certified.append((float(s), float(np.degrees(mode.angle))))
        else:
            refused_at = float(s)

counts = [len(all_modes(s * GOAL)) for s in (jumped_at - 1 / STEPS, jumped_at)]
usual = np.median(np.abs(np.diff([angle for _, angle in newton])))
print(f"modes before and after: {counts}")
print(f"Newton's method: the platform jumps by {np.degrees(jump):.1f} deg at s = {jumped_at:.3f}, usually {usual:.2f}")
print(
    f"the certified nearest mode: status {status} at s = {refused_at:.3f}, the mode stays at {certified[-1][1]:.1f} deg"
)
assert np.degrees(jump) > 15 and refused_at == jumped_at and counts[0] == counts[1] + 2
assert all(abs(a - b) < 1e-6 for (_, a), (_, b) in zip(newton, certified, strict=False))  # the same until then

if len(sys.argv) > 1:
    from matplotlib import pyplot as plt

    figure, axes = plt.subplots(figsize=(6.4, 3.6), layout="constrained")
    every = [(s, np.degrees(m.angle)) for s in np.linspace(0, 1, 401) for m in all_modes(s * GOAL)]
    axes.plot(*zip(*every, strict=True), ".", color="0.75", markersize=3, label="all modes")
    axes.plot(*zip(*newton, strict=True), "--", color="tab:red", label="Newton's method from the last pose")
    axes.plot(*zip(*certified, strict=True), color="tab:blue", linewidth=2, label="certified nearest mode")
    axes.plot(*certified[-1], "o", color="tab:blue")
    axes.set(xlabel="part of the motion of the cranks", ylabel="angle of the platform [deg]")
    axes.legend(frameon=False)
    figure.savefig(sys.argv[1], dpi=110)
