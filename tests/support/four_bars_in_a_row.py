"""Four-bars in a row: the motion of their cranks in closed form."""

from __future__ import annotations

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipj, ellipkinc

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism


def n_four_bar(count: int) -> Mechanism:
    """`count` square four-bars in a row, links of 1 m and 1 kg, relative joint angles."""
    builder = MechanismBuilder(f"n_four_bar_{count}")
    z = [[0, 0, 1]]
    for k in range(count + 1):
        builder.body(f"crank{k}", mass=1, com=[k, "1/2", 0], inertia=["1/12", 0, "1/12"])
    for k in range(count):
        builder.body(f"coupler{k}", mass=1, com=[f"{k} + 1/2", 1, 0], inertia=[0, "1/12", "1/12"])
    for k in range(count + 1):
        builder.joint(f"A{k}", "R", parent="base", child=f"crank{k}", point=[k, 0, 0], axes=z)
    for k in range(count):
        builder.joint(f"B{k}", "R", parent=f"crank{k}", child=f"coupler{k}", point=[k, 1, 0], axes=z)
        builder.joint(f"C{k}", "R", parent=f"coupler{k}", child=f"crank{k + 1}", point=[k + 1, 1, 0], axes=z)
    return builder.build()


def crank_angle(count: int, t: np.ndarray) -> np.ndarray:
    """Closed form of the angle from upright: J th'' = c sin th with J = (N+1)/3 + N, c = ((N+1)/2 + N) g."""
    rate = ((count + 1) / 2 + count) * 9.81 / ((count + 1) / 3 + count)
    energy = 0.5 + rate  # th' = 1 at th = 0
    # th' = sqrt(2 (energy - rate cos th)): with th = pi + 2 a, a' = w sqrt(1 - m sin^2 a)
    w, m = np.sqrt((energy + rate) / 2), 2 * rate / (energy + rate)
    _, _, _, amplitude = ellipj(w * t + ellipkinc(-np.pi / 2, m), m)
    return np.pi + 2 * amplitude


def crossing_times(count: int, until: float) -> np.ndarray:
    """When the cranks are horizontal."""
    times, k = [], 0
    while True:
        target = np.pi / 2 + k * np.pi
        if crank_angle(count, np.array(until)) < target:
            return np.array(times)
        times.append(brentq(lambda t, a=target: float(crank_angle(count, np.array(t))) - a, 0, until, xtol=1e-13))
        k += 1
