"""A transcription of its own: piecewise Chebyshev pseudospectral optimal control on plain CasADi SX.

States and drive are polynomials through Chebyshev points; the differentiation matrix and the Clenshaw-Curtis
weights are those of L. N. Trefethen, Spectral Methods in MATLAB, SIAM 2000 (programs cheb and clencurt). Shares
nothing with the package.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import casadi as ca
import numpy as np


def chebyshev(n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points on [-1, 1] ascending, differentiation matrix, quadrature weights."""
    x = np.cos(np.pi * np.arange(n + 1) / n)
    c = np.ones(n + 1)
    c[[0, -1]] = 2
    c *= (-1.0) ** np.arange(n + 1)
    apart = x[:, None] - x[None] + np.eye(n + 1)
    matrix = np.outer(c, 1 / c) / apart
    matrix -= np.diag(matrix.sum(axis=1))
    angles = np.pi * np.arange(n + 1) / n
    weights = np.zeros(n + 1)
    inner = np.ones(n - 1)
    even = n % 2 == 0
    weights[[0, -1]] = 1 / (n**2 - 1) if even else 1 / n**2
    for k in range(1, n // 2 if even else (n - 1) // 2 + 1):
        inner -= 2 * np.cos(2 * k * angles[1:-1]) / (4 * k**2 - 1)
    if even:
        inner -= np.cos(n * angles[1:-1]) / (n**2 - 1)
    weights[1:-1] = 2 * inner / n
    return x[::-1], matrix[::-1, ::-1], weights[::-1]


def least_effort(
    slope: Callable[[Sequence[ca.SX], ca.SX], ca.SX],
    start: Sequence[float],
    end: Sequence[float],
    duration: float,
    *,
    degree: int,
    pieces: int,
) -> float:
    """The least integral of u^2 for x' = slope(x, u) from start to end."""
    s, matrix, weights = chebyshev(degree)
    n, h = len(start), duration / pieces
    unknowns, guess, equations, cost = [], [], [], ca.SX(0)
    before = None
    for k in range(pieces):
        x, u = ca.SX.sym(f"x{k}", degree + 1, n), ca.SX.sym(f"u{k}", degree + 1)
        part = (k + (1 + s) / 2) / pieces
        guess += [np.outer(part, np.array(end) - np.array(start)).ravel(order="F") + np.repeat(start, degree + 1)]
        guess += [np.zeros(degree + 1)]
        unknowns += [ca.vec(x), u]
        rates = ca.vertcat(*[slope([x[i, j] for j in range(n)], u[i]).T for i in range(degree + 1)])
        equations.append(ca.vec(matrix @ x - h / 2 * rates))
        if before is not None:
            equations.append(ca.vec(x[0, :] - before))
        else:
            equations.append(ca.vec(x[0, :] - ca.DM(start).T))
        before = x[degree, :]
        cost += h / 2 * ca.dot(weights, u**2)
    equations.append(ca.vec(before - ca.DM(end).T))
    nlp = {"x": ca.vertcat(*unknowns), "f": cost, "g": ca.vertcat(*equations)}
    quiet = {"print_time": False, "ipopt": {"print_level": 0, "sb": "yes", "tol": 1e-10, "max_iter": 300}}
    solver = ca.nlpsol("solver", "ipopt", nlp, quiet)
    found = solver(x0=np.concatenate(guess), lbg=0, ubg=0)
    assert solver.stats()["success"]
    return float(found["f"])
