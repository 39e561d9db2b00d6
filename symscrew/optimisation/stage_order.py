"""The order in which a solver that goes stage by stage wants a transcription: states, controls, states, controls ...

Transcribed + pattern of the Jacobian --> order of unknowns and rows, sizes of the stages;   none where something spans
more than two neighbours (a free duration, a peak, design parameters, rates of drives)
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symscrew.optimisation.sparse import NonlinearProgram
from symscrew.optimisation.transcription import Transcribed

STATES = ("y", "y_1", "x")  # unknowns at the ends of the intervals


@dataclass(frozen=True)
class Stages:
    """`unknowns`, `rows`: positions in the program, in order; states, controls and path constraints of every stage."""

    unknowns: np.ndarray
    rows: np.ndarray
    states: tuple[int, ...]
    controls: tuple[int, ...]
    paths: tuple[int, ...]


def stages_of(transcribed: Transcribed, program: NonlinearProgram) -> Stages | None:
    """The stages of a program, if it falls into such."""
    index, count = transcribed.unknowns.index, len(transcribed.mesh) - 1
    inside = [name for name, at in index.items() if name not in STATES and at.ndim == 3]
    if set(index) - set(STATES) - set(inside) or not all(len(index[name]) == count for name in inside):
        return None
    ends = [np.concatenate([index[name][k].ravel() for name in STATES]) for k in range(count + 1)]
    between = [np.concatenate([index[name][k].ravel() for name in inside]) for k in range(count)]
    between.append(np.zeros(0, int))
    stage = np.empty(transcribed.unknowns.size, int)
    for k, parts in enumerate(zip(ends, between, strict=True)):
        for part in parts:
            stage[part] = k
    one, other = (np.array(part) for part in program.hessian.sparsity_out(0).get_triplet())
    if (stage[one] != stage[other]).any():
        return None
    pattern = program.jacobian.sparsity_out(1)
    rows, columns = (np.array(part) for part in pattern.get_triplet())
    first, last = np.full(pattern.size1(), count + 1), np.full(pattern.size1(), -1)
    np.minimum.at(first, rows, stage[columns])
    np.maximum.at(last, rows, stage[columns])
    if (last - first > 1).any() or (last < 0).any():
        return None
    order, paths = [], []
    for k in range(count + 1):
        path = np.flatnonzero((first == k) & (last == k))
        if k < count:
            spanning = np.flatnonzero((first == k) & (last == k + 1))
            joining = _joining(spanning, ends[k + 1], stage=stage, rows=rows, columns=columns)
            if joining is None:
                return None
            order.append(joining)
        order.append(path)
        paths.append(len(path))
    unknowns = np.concatenate([part for parts in zip(ends, between, strict=True) for part in parts])
    sizes = (tuple(map(len, ends)), tuple(map(len, between)))
    return Stages(unknowns, np.concatenate(order), *sizes, tuple(paths))


def _joining(
    spanning: np.ndarray, following: np.ndarray, *, stage: np.ndarray, rows: np.ndarray, columns: np.ndarray
) -> np.ndarray | None:
    """The rows that give each of the next states, in their order; None unless each has one of its own."""
    own = np.isin(rows, spanning) & (stage[columns] == (stage[following[0]] if len(following) else -1))
    pairs = dict(zip(columns[own].tolist(), rows[own].tolist(), strict=True))
    alone = own.sum() == len(following) == len(spanning) == len(set(pairs.values()))
    return np.array([pairs[column] for column in following.tolist()], int) if alone else None
