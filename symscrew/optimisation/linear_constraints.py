"""The linear constraints of every transcription: conditions on y and y', rates of drives, periodicity.

problem --> rows  lower <= A X <= upper  of the unknowns X,  e.g.  y'(tau) - rate T = 0
"""

from __future__ import annotations

import numpy as np

from symscrew.optimisation.linear_rows import LinearRows
from symscrew.optimisation.problem import Conditions
from symscrew.optimisation.unknowns import Terms


def add_conditions(rows: LinearRows) -> None:
    """y and y' at the start, the end and via points; values at the ends that are bounds of unknowns left aside."""
    model, problem = rows.model, rows.model.problem
    given: list[tuple[str, float, Conditions]] = [("the start", 0.0, problem.start), ("the end", 1.0, problem.end)]
    given += [(f"via point {k + 1}", float(c.time or 0), c) for k, c in enumerate(problem.via)]
    for where, tau, c in given:
        inside = 0 < tau < 1
        for k, label in enumerate(model.equations.labels):
            if inside and label in c.coordinates:
                row = rows.new([f"{label} at {where}"], tau, c.coordinates[label], c.coordinates[label])
                _add_entry(rows, row, k, tau, order=0)
            value = 0.0 if c.at_rest else c.rates.get(label)
            at_an_end = not inside and (value == 0.0 or not problem.free_duration)  # a bound of the unknown itself
            if value is not None and not at_an_end:
                _add_rate_condition(rows, k, where, tau=tau, value=value)


def _add_rate_condition(rows: LinearRows, k: int, where: str, *, tau: float, value: float) -> None:
    """y'_k - value T = 0."""
    duration = rows.model.problem.duration
    fixed = value * duration if not isinstance(duration, tuple) else 0.0
    row = rows.new([f"rate of {rows.model.equations.labels[k]} at {where}"], tau, fixed, fixed)
    _add_entry(rows, row, k, tau, order=1)
    if isinstance(duration, tuple) and value:
        rows.terms.add(row, rows.unknowns.index["T"], -value)


def _add_entry(rows: LinearRows, row: np.ndarray, k: int, tau: float, *, order: int) -> None:
    """Entry k of y (order 0) or y' (order 1) at a time."""
    every = Terms(rows.unknowns)
    rows.grid.add_interpolated(every, np.arange(rows.model.d), tau, order=order)
    numbers, columns, values = every.entries()
    chosen = numbers == k
    rows.terms.rows.append(np.full(int(chosen.sum()), int(row[0, 0])))
    rows.terms.columns.append(columns[chosen])
    rows.terms.values.append(values[chosen])


def add_drive_rates(rows: LinearRows) -> None:
    """Rates of the drives' polynomials by their control points; no jumps between intervals."""
    model, grid, scheme = rows.model, rows.grid, rows.grid.scheme
    tau = grid.point_tau
    for k, label in enumerate(model.drive_labels):
        if label not in model.problem.bounds.drive_rates:
            continue
        u = rows.unknowns.index["u"][..., k]
        if scheme is None or scheme.degree == 1:
            _add_rate(rows, k, u[:-1, 0], u[1:, 0], gaps=np.diff(tau[:, 0]), tau=tau[1:, 0])
            continue
        gaps = grid.steps / (scheme.degree - 1)
        for j in range(scheme.degree - 1):
            _add_rate(rows, k, u[:, j], u[:, j + 1], gaps=gaps, tau=tau[:, j + 1])
        row = rows.new([f"no jump of drive {label}"], grid.mesh[1:-1])
        rows.terms.add(row[:, 0], u[1:, 0], 1 / model.scales.u[k])
        rows.terms.add(row[:, 0], u[:-1, -1], -1 / model.scales.u[k])


def _add_rate(
    rows: LinearRows, k: int, first: np.ndarray, last: np.ndarray, *, gaps: np.ndarray, tau: np.ndarray
) -> None:
    """lower gap T <= last - first <= upper gap T for values of drive k."""
    problem, label, size = rows.model.problem, rows.model.drive_labels[k], rows.model.scales.u[k]
    duration = problem.duration
    for sign, limit in zip((1, -1), problem.bounds.drive_rates[label], strict=True):
        if not np.isfinite(limit):
            continue
        fixed = 0.0 if isinstance(duration, tuple) else (limit * gaps * duration / size)[:, None]
        low, high = (fixed, np.inf) if sign > 0 else (-np.inf, fixed)
        row = rows.new([f"rate of drive {label}"], tau, low, high)
        rows.terms.add(row[:, 0], last, 1 / size)
        rows.terms.add(row[:, 0], first, -1 / size)
        if isinstance(duration, tuple):
            rows.terms.add(row[:, 0], rows.unknowns.index["T"][0], -limit * gaps / size)


def add_periodicity(rows: LinearRows) -> None:
    """The motion ends as it began: y, y' and the effects' states."""
    model, index = rows.model, rows.unknowns.index
    if not model.problem.periodic:
        return
    groups = [("y", [f"periodicity of {label}" for label in model.equations.labels])]
    groups += [("y_1", [f"periodicity of rate of {label}" for label in model.equations.labels])]
    groups += [("x", [f"periodicity of the state {name}" for name in model.states])]
    for name, labels in groups:
        if labels:
            further = [2 * np.pi * model.problem.turns.get(label, 0) for label in model.equations.labels]
            target = further if name == "y" else np.zeros(len(labels))
            row = rows.new(labels, 1.0, target, target)
            rows.terms.add(row[0], index[name][-1])
            rows.terms.add(row[0], index[name][0], -1.0)
