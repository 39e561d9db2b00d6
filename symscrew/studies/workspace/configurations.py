"""Configurations of many cases at once: each walks alone from where it starts to where it is wanted.

A case's result depends on its own coordinates and parameters only, not on its neighbours, so that a sweep gives the
same numbers however it is cut and wherever its pieces run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from symscrew.model import Model
from symscrew.runtime import CompiledModel

Array = np.ndarray
Call = Callable[..., tuple[Sequence[Array], Array]]
"""(function, arrays (cases, size)) -> results and status (cases), 0 where it worked."""

Reach = Callable[[float, Array, Sequence[Array]], tuple[Array, Array]]
"""(part of the way, configurations (cases, nq), parameters) -> configurations there and status (cases)."""


def calls_of(compiled: CompiledModel) -> Call:
    """A compiled model's functions as a `Call`."""

    def call(name: str, *arrays: Array) -> tuple[Sequence[Array], Array]:
        found: tuple[Array, ...] = compiled[name](*arrays, check=False)  # type: ignore[assignment]
        *results, status = found
        flat = [r.reshape(len(r), -1) if r.ndim < 3 else np.moveaxis(r, 2, 1).reshape(len(r), -1) for r in results]
        return flat, status

    return call


STEPS = 16  # of the walk; at each the loops are closed from the last, and longer ones may end in another assembly
# A way on which a margin comes near zero is walked again with so many times the steps, until it does not, or there are
# that many: a margin that is zero twice between two steps has the same sign at both. One of a five-bar's 3721 places
# was called regular for that; what is nearer than the finest steps tell is left to `--certify`.
FINER, FINEST = 4, 256
SINGULAR = 1e-9  # a margin (it has no unit) below this where the walk starts is 0: nothing can be compared with it


def independent_labels(model: Model) -> tuple[str, ...]:
    """Labels of the independent coordinates y; of all coordinates for an open chain."""
    if "assemble" in model.programs:
        return tuple(model.programs["assemble"].inputs[0].labels)
    return tuple(c.label for c in model.system.tree.q)


def reference_coordinates(model: Model, begin: Array | None = None) -> Array:
    """y in the reference configuration, or in others (..., nq)."""
    labels = [c.label for c in model.system.tree.q]
    q = model.system.reference if begin is None else begin
    return np.asarray(q[..., [labels.index(label) for label in independent_labels(model)]])


def walk(
    model: Model,
    call: Call,
    y: Array,
    parameters: Array | None = None,
    *,
    steps: int = STEPS,
    watch: bool = True,
    reach: Reach | None = None,
    begin: Array | None = None,
    origin: tuple[Array, Array | None] | None = None,
) -> tuple[Array, Array, dict[str, Array], Array]:
    """Configurations q (cases, nq) at independent coordinates y (cases, ny), by equal steps from the reference.

    Args:
        model: the model.
        call: its functions, interpreted or compiled.
        y: wanted coordinates.
        parameters: run-time parameters (cases, np), walked to from their values in the description; None if none.
        steps: of the walk.
        watch: whether to look at the margins on the way.
        begin: configuration (nq,) from which it starts in place of the reference.
        origin: configurations (cases, nq) and run-time parameters (cases, np) from which each case starts instead;
            margins are compared with those of the reference, or of `begin`.
        reach: takes over from y: what brings all cases to a part of the way to where they are wanted.

    Returns:
        q, NaN where the loops cannot be closed; status of the last assembly; and per watched margin
        ("constraint platform" ...) its least value along the walk relative to the reference: at or below 0 a
        singularity was passed; and whether one may have been passed twice between two steps (cases,): a margin changes
        by more in a step, or in a neighbour of it, than it is off zero at its ends.
    """
    count = len(y)
    first_q, first_p = model.system.reference if begin is None else begin, model.system.parameter_values
    q, p0 = (np.repeat(of[None, :], count, 0) for of in (first_q, first_p)) if origin is None else origin
    if p0 is None:
        p0 = np.zeros((count, 0))
    start, p1 = reference_coordinates(model, q), p0 if parameters is None else parameters
    status = np.zeros(count, dtype=int)
    extra = (p0,) if p0.shape[1] else ()
    first = start_margins(model, call, begin) if watch else {}
    here = watched_margins(model, call, q, extra) if watch and origin is not None else {}
    along = {name: [here[name] / value if here else np.ones(count)] for name, value in first.items()}
    for k in range(1, steps + 1):
        part = k / steps
        extra = ((1 - part) * p0 + part * p1,) if p0.shape[1] else ()
        target = (1 - part) * start + part * y if k < steps else y
        if reach is not None or "assemble" in model.programs:
            found, new = reach(part, q, extra) if reach else _assembled(call, target, q, extra)
            q = np.where((new == 0)[:, None] & (status == 0)[:, None], found, np.nan)
            status = np.where(status == 0, new, status)
        else:
            q = target.copy()
        now = watched_margins(model, call, q, extra) if watch else {}
        for name, value in first.items():
            along[name].append(now[name] / value)
    least = {name: np.fmin.reduce(values) for name, values in along.items()}
    close = np.zeros(count, dtype=bool)
    for values in along.values():
        close |= _near_zero(np.array(values))
    return q, status, least, close


def _near_zero(margin: Array) -> Array:
    """Whether a margin (steps + 1, cases) may be zero between two steps at the pace that it has there."""
    moved = np.abs(np.diff(margin, axis=0))
    around = np.pad(moved, ((1, 1), (0, 0)))
    pace = np.maximum(np.maximum(around[:-2], around[2:]), moved)
    return np.asarray((np.minimum(margin[:-1], margin[1:]) < pace).any(axis=0))


def _assembled(call: Call, target: Array, q: Array, extra: Sequence[Array]) -> tuple[Array, Array]:
    results, status = call("assemble", target, q, *extra)
    return results[0], status


def watched_margins(model: Model, call: Call, q: Array, extra: Sequence[Array]) -> dict[str, Array]:
    """Margins of every limb, of the constraints and of the drives together, by kind and name [1].

    Sets of a few drives, which lose their hold without harm while the others keep theirs, are left out.
    """
    found = {}
    for kind in ("limb_margins", "constraint_margin", "actuation_margins"):
        if kind not in model.programs:
            continue
        labels = model.programs[kind].outputs[0].labels
        values = call(kind, q, *extra)[0][0].reshape(len(q), -1)
        for k, label in enumerate(labels[:1] if kind == "actuation_margins" else labels):
            found[f"{kind.split('_')[0]} {label}"] = values[:, k]
    return found


def start_margins(model: Model, call: Call, begin: Array | None = None) -> dict[str, float]:
    """The watched margins where a walk begins, usually in the reference; those that are zero there are left out."""
    values = model.system.parameter_values
    extra = (values[None, :],) if len(values) else ()
    q = model.system.reference if begin is None else begin
    found = watched_margins(model, call, q[None, :], extra)
    return {name: float(value[0]) for name, value in found.items() if abs(value[0]) > SINGULAR}
