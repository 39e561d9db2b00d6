"""A motion of multiple shooting between the ends of its intervals: quintic polynomials through y, y', y''.

Shooting knows y and y' at the ends only; y'' there is what forward dynamics gives with the drives of the interval,
so it jumps where the drives do.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.consistent_poses import Kinematics
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.point import point_symbols

Arrays = Mapping[str, np.ndarray]


def quintic(
    arrays: Arrays, mesh: np.ndarray, ends: tuple[np.ndarray, np.ndarray], *, k: np.ndarray, s: np.ndarray
) -> dict[str, np.ndarray]:
    """Unknowns of points at parts s (n,) of the intervals k (n,); `ends`: y'' at both ends of all intervals."""
    h, s = np.diff(mesh)[k][:, None], s[:, None]
    a, b = arrays["y_1"][k] * h, arrays["y_1"][k + 1] * h
    c, d = (end[k] * h**2 for end in ends)
    rise = arrays["y"][k + 1] - arrays["y"][k]
    c3 = 10 * rise - 6 * a - 4 * b - 1.5 * c + 0.5 * d
    c4 = -15 * rise + 8 * a + 7 * b + 1.5 * c - d
    c5 = 6 * rise - 3 * (a + b) - 0.5 * c + 0.5 * d
    return {
        "y": arrays["y"][k] + s * (a + s * (c / 2 + s * (c3 + s * (c4 + s * c5)))),
        "y_1": (a + s * (c + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h,
        "y_2": (c + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / h**2,
        "u": arrays["u"][k, 0],
        "x": arrays["x"][k] + s * (arrays["x"][k + 1] - arrays["x"][k]),
        "x_1": (arrays["x"][k + 1] - arrays["x"][k]) / h,
    }


def end_accelerations(
    kinematics: Kinematics, arrays: Arrays, mesh: np.ndarray, duration: float
) -> tuple[np.ndarray, np.ndarray]:
    """y'' by forward dynamics at start and end of every interval, with its drives: (intervals, d) each."""
    model = kinematics.model
    blocks = point_symbols(model, moving=True)
    at = MotionQuantities(model, blocks)
    order = ("y", "y_1", "z", "u", "x", "T", "p", "tau")
    function = ca.Function(
        "ends",
        [blocks[name] for name in order],
        [symbolic_outputs(model.equations.forward, at.known)["y_ddot"] * at.T**2],
    )
    n, layout = len(arrays["u"]), list(model.equations.layout.z)
    start_z = arrays["z"][:, 0]
    start_q, _ = kinematics.closure(arrays["y"][:-1], start_z)
    end_q = np.array([_assembled(kinematics, arrays["y"][j + 1], start_q[j]) for j in range(n)])
    T = np.full((1, n), duration) if "T" in arrays else np.zeros((0, n))
    p = np.repeat(arrays["p"][:, None], n, 1) if "p" in arrays else np.zeros((0, n))

    def found(shift: int, z: np.ndarray) -> np.ndarray:
        pick = slice(shift, n + shift)
        values = [arrays["y"][pick].T, arrays["y_1"][pick].T, z.T, arrays["u"][:, 0].T, arrays["x"][pick].T]
        return np.array(function.map(n)(*values, T, p, mesh[pick][None])).T

    return found(0, start_z), found(1, end_q[:, layout])


def _assembled(kinematics: Kinematics, y: np.ndarray, near: np.ndarray) -> np.ndarray:
    """The configuration with y; where none is found the one it was looked for from."""
    found = kinematics.assemble(y, near)
    return near if found is None else found
