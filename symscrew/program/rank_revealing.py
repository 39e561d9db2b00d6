"""The second path of forward dynamics: where a pivot is small, an orthogonal solution that reveals the rank.

The first path is straight-line code whose pivots were chosen while deriving. Near a configuration where one
of them vanishes it would lose digits, so that all is solved again without any choice made beforehand: with
the closure's Jacobian J (rates and rows without units: lengths divided by the characteristic length) and its
singular value decomposition,

    a = -J^+ bias + Z z,     Z^T M Z z = Z^T (f - M a_particular),     multipliers = (J^T)^+ (M a - f)

with Z the null space. It is as accurate as the problem allows wherever the closure keeps its rank, and says
so when it does not.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from symscrew.program.numpy_evaluation import evaluate
from symscrew.program.straight_line import Program, digest

# Singular values of the closure below this part of the largest, at least of 1, count as zero: states that simulations
# reach close the loops to 1e-12 or so, and 1e-9 of a unit screw is finer than a machine is built. Above, a direction is
# a constraint; below, it is a freedom that opens, and the status is -2.
RANK = 1e-9
# A pivot below this, without units, hands over to the second path (status -1): the first path would lose five of
# sixteen digits there. Above, the second one would only take longer.
SWITCH = 1e-5


@dataclass(frozen=True, repr=False)
class RankRevealing(Program):
    """A straight-line program whose near-singular states are solved by a second, rank-revealing path.

    `dense` takes the same inputs and gives the mass matrix (n, n), the forces f (n) such that M a = f + J^T
    multipliers, the closure Jacobian (m, n) for v and its bias (m). `rates` and `rows` are the unit scales:
    a = rates * a_scaled, residual_scaled = rows * residual. `regular` is the rank of the closure at regular
    states. `wrenches`, if there is one, takes the inputs, a and the multipliers and gives the reactions and
    the same without units at the joints' points, whose sum of squares internal loads keep smallest.

    Status -1: the second path was taken, at full rank. Status -2: it was taken where the closure loses rank;
    the accelerations are those of smallest norm that the remaining constraints and the equations allow.
    """

    dense: Program | None = None
    wrenches: Program | None = None
    rates: tuple[float, ...] = ()
    rows: tuple[float, ...] = ()
    regular: int = 0

    @cached_property
    def hash(self) -> str:
        """Of all parts."""
        parts = [digest(self)]
        parts += [part.hash for part in (self.dense, self.wrenches) if part is not None]
        return "".join(part[: 16 // len(parts)] for part in parts)

    @property
    def loads_matter(self) -> bool:
        """Whether reactions depend on the multipliers: not where gears alone close loops."""
        if self.wrenches is None:
            return False
        *others, multipliers = (port.size for port in self.wrenches.inputs)
        first = sum(others)
        results = [s for slots in self.wrenches.results for s in slots]
        read = {*results, *(arg for _, _, args in self.wrenches.instructions for arg in args if isinstance(arg, int))}
        return any(slot in read for slot in range(first, first + multipliers))


def evaluate_rank_revealing(
    program: RankRevealing, arguments: Sequence[object]
) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
    """Run the first path on all states and the second one where it fails by a small pivot.

    Arguments (*batch, size of the port), results and errors are those of `evaluate`; a status (*batch) below 0 says
    that the second path was taken.
    """
    assert program.dense is not None
    results, status = evaluate(program, arguments)
    sizes = [port.size for port in program.inputs]
    full = [np.broadcast_to(np.asarray(x, float), (*status.shape, n)) for x, n in zip(arguments, sizes, strict=True)]
    for state in np.argwhere(status == 1):
        index = tuple(state)
        inputs = [x[index] for x in full]
        mass, force, jacobian, bias = evaluate(program.dense, inputs)[0]
        reactions = partial(_reactions, program.wrenches, inputs) if program.wrenches else None
        scales = {"rates": program.rates, "rows": program.rows}
        found, status[index] = second_path(
            mass, force, jacobian, bias, **scales, regular=program.regular, tolerance=RANK, reactions=reactions
        )
        for result, value in zip(results, found, strict=True):
            result[index] = value
    return results, status


def _reactions(
    wrenches: Program, inputs: Sequence[np.ndarray], a: np.ndarray, multipliers: np.ndarray
) -> tuple[np.ndarray, ...]:
    return evaluate(wrenches, [*inputs, a, multipliers])[0]


def second_path(
    mass: np.ndarray,
    force: np.ndarray,
    jacobian: np.ndarray,
    bias: np.ndarray,
    *,
    rates: Sequence[float],
    rows: Sequence[float],
    regular: int,
    tolerance: float,
    reactions: Callable[[np.ndarray, np.ndarray], Sequence[np.ndarray]] | None,
) -> tuple[list[np.ndarray], int]:
    """Accelerations, and reactions if asked for, by singular values; and the status -1, -2, or 1 and 2 with NaN.

    Args:
        mass: mass matrix (n n), forces `force` (n,), closure `jacobian` (m n) and `bias` (m,): matrices by columns.
        force: generalised forces without the loops'.
        jacobian: of the loops' rows by the rates.
        bias: what the rows' second rates are at no acceleration.
        rates: what each rate is divided by, the characteristic length or 1, n of them.
        rows: by what each row is multiplied, m of them, so that all entries compare.
        regular: the rank of the loops in general; with a smaller one the status is -2.
        tolerance: singular values below this part of the largest one are zero.
        reactions: from accelerations (n,) and multipliers (m,) to further results.
    """
    n, m = len(force), len(bias)
    if not all(np.isfinite(x).all() for x in (mass, force, jacobian, bias)):
        lost = [np.full(n, np.nan)]
        return [*lost, *([np.full_like(reactions(lost[0], bias)[0], np.nan)] if reactions else [])], 2
    scale, weight = np.array(rates), np.array(rows)
    inertia = mass.reshape(n, n).T * np.outer(scale, scale)
    closure = jacobian.reshape(n, m).T * np.outer(weight, scale)
    load = force * scale
    left, sizes, right = np.linalg.svd(closure, full_matrices=True)
    rank = int((sizes > tolerance * max(sizes[0], 1.0)).sum())  # unit screws: one is their size
    inverse = (right[:rank].T / sizes[:rank]) @ left[:, :rank].T
    null = right[rank:].T
    gain = -inverse @ (weight * bias)
    reduced = null.T @ inertia @ null
    sound = not len(reduced) or np.linalg.eigvalsh(reduced)[0] > 1e-14 * np.abs(reduced).max()
    if sound and len(reduced):
        gain = gain + null @ np.linalg.solve(reduced, null.T @ (load - inertia @ gain))
    found = [scale * gain]
    if reactions is not None:
        multipliers = inverse.T @ (inertia @ gain - load)
        values, sized = reactions(found[0], weight * multipliers)
        internal = left[:, rank:].T
        shifted = [reactions(found[0], weight * (multipliers + load)) for load in internal]
        if shifted:
            columns = np.array([other - sized for _, other in shifted]).T
            amounts = np.linalg.lstsq(columns, -sized, rcond=1e-9)[0]
            values = values + sum(x * (other - values) for x, (other, _) in zip(amounts, shifted, strict=True))
        found.append(values)
    status = (-1 if rank == regular else -2) if sound else 1
    if not all(np.isfinite(x).all() for x in found):
        status = max(status, 2)
    if status > 0:
        found = [np.full_like(x, np.nan) for x in found]
    return found, status
