"""Where a solver starts that knows an earlier motion: its unknowns and multipliers carried to another mesh.

A constraint at a point has a multiplier that is a density over relative time (the costate of the motion) times the
weight of the point in the integral; the constraint that joins two intervals has the costate itself.
"""

from __future__ import annotations

import numpy as np

from symscrew.optimisation.result import Trajectory
from symscrew.optimisation.transcription import Transcribed
from symscrew.optimisation.unknowns import Unknowns

JOINING = "continuity of"  # how labels of constraints begin that join two intervals


def carried_unknowns(warm: Trajectory, transcribed: Transcribed) -> dict[str, np.ndarray]:
    """Unknowns of a transcription from an earlier trajectory of the same mechanism."""
    mesh, points = transcribed.mesh, transcribed.point_tau
    at_mesh = warm.blocks(mesh)
    same = np.array_equal(mesh, warm.transcribed.mesh)
    # the end of an interval belongs to it, not to the next one
    inside = warm.blocks(points.ravel(), np.repeat(np.arange(len(points)), points.shape[1]) if same else None)
    q, _ = warm.configurations(points.ravel(), inside["y"])
    layout = transcribed.model.equations.layout
    result = {**inside, "z": q[:, list(layout.z)]}
    result |= {name: at_mesh[name] for name in ("y", "y_1", "x")}
    # what a motion has once: duration, design, peak, coordinates where conditions are observed
    result |= {name: array for name, array in warm.arrays.items() if name not in result}
    if "T" not in result:
        result["T"] = np.array([warm.duration])
    return result


def shifted(warm: Trajectory, shift: float) -> tuple[np.ndarray, np.ndarray]:
    """Unknowns and multipliers of constraints of a motion `shift` seconds later, on its own mesh; its end is held."""
    made = warm.transcribed
    scheme, unknowns, part = made.scheme, made.unknowns, shift / warm.duration
    assert scheme is not None  # no shooting
    at_mesh = warm.blocks(np.clip(made.mesh + part, 0.0, 1.0))
    later = np.clip(made.point_tau.ravel() + part, 0.0, 1.0)
    inside = warm.blocks(later)
    k = np.clip(np.searchsorted(made.mesh, later, side="right") - 1, 0, len(made.mesh) - 2)
    weights = scheme.basis((later - made.mesh[k]) / np.diff(made.mesh)[k])
    inside["z"] = np.einsum("nj,njd->nd", weights, warm.arrays["z"][k])
    shape = (*made.point_tau.shape, -1)
    inside["u"] = np.einsum("ij,njm->nim", np.linalg.inv(scheme.control), inside["u"].reshape(shape))
    arrays = {**warm.arrays, **{name: array for name, array in inside.items() if name in unknowns.index}}
    x = unknowns.pack(arrays | {name: at_mesh[name] for name in ("y", "y_1", "x")})
    rows, first = warm.multipliers.copy(), 0
    for family in made.families:
        count = len(family.function.rows)
        own = rows[first : first + family.count * count].reshape(family.count, count)
        if family.weights.any():
            density = own / family.weights[:, None]
            own[:] = _interpolated(family.tau, density, family.tau + part) * family.weights[:, None]
        first += family.count * count
    return x, rows


def carried_multipliers(
    warm: Trajectory, transcribed: Transcribed, cost_scale: float
) -> tuple[np.ndarray, np.ndarray] | None:
    """Multipliers of all constraints and of all unknowns' bounds; None where the two problems differ in kind."""
    before = warm.transcribed
    ratio = warm.cost_scale / cost_scale
    count = sum(f.count * len(f.function.rows) for f in transcribed.families) + len(transcribed.linear.labels)
    if len(warm.multipliers) == count and len(warm.x) == transcribed.unknowns.size:
        return ratio * warm.multipliers, ratio * warm.bound_multipliers
    alike = [[r.label for r in f.function.rows] for f in before.families] == [
        [r.label for r in f.function.rows] for f in transcribed.families
    ]
    if not alike or set(before.linear.labels) != set(transcribed.linear.labels):
        return None
    if set(before.unknowns.index) != set(transcribed.unknowns.index):
        return None
    parts, first = [], 0
    for old, new in zip(before.families, transcribed.families, strict=True):
        count = len(old.function.rows)
        own = warm.multipliers[first : first + old.count * count].reshape(old.count, count)
        first += old.count * count
        dense = old.weights.any()
        density = own / old.weights[:, None] if dense else own
        moved = _interpolated(old.tau, density, new.tau)
        parts.append((moved * new.weights[:, None] if dense else moved).ravel())
    parts.append(_linear(warm, transcribed, warm.multipliers[first:]))
    return ratio * np.concatenate(parts), ratio * _bounds(before.unknowns, warm, transcribed.unknowns, transcribed.mesh)


def _linear(warm: Trajectory, transcribed: Transcribed, multipliers: np.ndarray) -> np.ndarray:
    old, new = warm.transcribed.linear, transcribed.linear
    old_labels, new_labels = np.array(old.labels), np.array(new.labels)
    result = np.zeros(len(new_labels))
    for label in dict.fromkeys(new.labels):
        here, there = np.flatnonzero(old_labels == label), np.flatnonzero(new_labels == label)
        share = 1.0 if label.startswith(JOINING) else len(here) / len(there)
        result[there] = share * _interpolated(old.tau[here], multipliers[here, None], new.tau[there])[:, 0]
    return result


def _bounds(old: Unknowns, warm: Trajectory, new: Unknowns, mesh: np.ndarray) -> np.ndarray:
    """Multipliers of the bounds of unknowns: densities where there is one unknown per point."""
    result = np.zeros(new.size)
    for name, at in new.index.items():
        own = warm.bound_multipliers[old.index[name]]
        if not own.size:
            continue
        if own.ndim < 3:  # at the ends of intervals, or once
            if own.ndim == 2 and len(own) > 1:
                result[at[[0, -1]]] = own[[0, -1]]
            else:
                result[at] = own
            continue
        steps, finer = np.diff(warm.transcribed.mesh), np.diff(mesh)
        density = own / steps[:, None, None]
        times, places = (_spread(m, k.shape[1]) for m, k in ((warm.transcribed.mesh, own), (mesh, at)))
        moved = _interpolated(times, density.reshape(-1, own.shape[2]), places).reshape(at.shape)
        result[at] = moved * finer[:, None, None]
    return result


def _spread(mesh: np.ndarray, count: int) -> np.ndarray:
    """Middles of `count` equal parts of every interval."""
    return np.asarray(mesh[:-1, None] + np.diff(mesh)[:, None] * (np.arange(count) + 0.5) / count).ravel()


def _interpolated(times: np.ndarray, values: np.ndarray, at: np.ndarray) -> np.ndarray:
    """Columns of values (n, m) at ascending times, linearly between them."""
    order = np.argsort(times, kind="stable")
    columns = [np.interp(at, times[order], column[order]) for column in values.T]
    return np.stack(columns, axis=1) if columns else np.zeros((len(at), 0))
