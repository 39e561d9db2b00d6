"""Inertial parameters of all bodies, and the combinations of them that motion and drives can tell: base parameters.

Decided by numbers: the regressor at many random consistent states, stacked, its columns of unit
length; its rank is where its singular values fall most, and the gap is stated. (Gautier, Numerical
calculation of the base inertial parameters of robots, J. Robotic Systems 8(4), 1991: QR with column pivoting.)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.description import Mechanism
from symscrew.effects import Effect, Gravity, given_effects
from symscrew.errors import expect
from symscrew.functions.kinematic import moving_bodies
from symscrew.functions.regressor import PARAMETERS, parameter_labels, regressor_functions
from symscrew.kinematics import System
from symscrew.loops import Loops
from symscrew.program import evaluate, lower

Array = np.ndarray
FAINT = 1e-10
"""A column of the regressor below this, relative to the greatest, is zero: rounding leaves 1e-14, and a parameter that
moves nothing must not be scaled up to unit length. Such a parameter is listed as unidentifiable."""

FLOOR = 1e-14  # singular values below this, relative to the greatest, are rounding, and make no gap among themselves

CLEAR = 1e3
"""The least ratio across the gap of the singular values for the rank to be a statement: rounding leaves 1e10 and more
where states excite all parameters, chance gaps between neighbours stay below 100. A smaller one raises RankError."""

FAR = 30
"""States whose regressor is this many times the median in size are left out: close to where the closure degenerates
they would outweigh all others."""

ROUNDS = 60  # steps of every walker at most; fewer states are used if more turn round, and half of them must agree

STEP = 0.4
"""A step of a walk on the closure manifold [rad, or characteristic lengths]: longer ones leave Newton's reach, shorter
ones give states that differ less. A walker that lands further than that away has left its branch and turns round."""

DEPENDENT = 1e-9  # rows of the closure Jacobian whose singular values are below this, relative, are redundant ones

ROUNDING = 1e-9  # coefficients below this, without units, are zero, and those so near a number of nine digits are that

TIED = 1e-6  # columns that are equal to this count as equal when one is chosen: the first one, on every machine


class RankError(ArithmeticError):
    """The singular values show no clear gap, so that the number of base parameters is undecided."""


@dataclass(frozen=True, repr=False)
class BaseParameters:
    """The combinations of inertial parameters that the generalised forces depend on: base = combination @ pi.

    Attributes:
        labels: all parameters `<body>.<parameter>` (n), the columns of the regressor.
        independent: indices of the parameters that stand for a combination each (r of them).
        combination: (r, n); column independent[i] is a unit vector, so Y pi = Y[:, independent] combination pi.
        unidentifiable: labels that no generalised force depends on.
        singular_values: of the stacked regressor with columns of unit length, relative to the greatest.
        gap: (smallest singular value that counts, greatest one that does not).
    """

    labels: tuple[str, ...]
    independent: tuple[int, ...]
    combination: Array
    unidentifiable: tuple[str, ...]
    singular_values: Array
    gap: tuple[float, float]

    def __repr__(self) -> str:
        above, below = self.gap
        return (
            f"BaseParameters({len(self)} of {len(self.labels)}, {len(self.unidentifiable)} unidentifiable, "
            f"gap {above:.1e} to {below:.1e})"
        )

    def __len__(self) -> int:
        """How many base parameters there are."""
        return len(self.independent)

    def words(self, digits: int = 6) -> tuple[str, ...]:
        """Every base parameter as a sum of inertial parameters."""
        return tuple(self._sum(row, digits) for row in self.combination)

    def _sum(self, row: Array, digits: int) -> str:
        text = ""
        for k in np.argsort(row != 1, kind="stable"):
            value = row[k]
            if value == 0:
                continue
            size = "" if abs(value) == 1 else f"{abs(value):.{digits}g} "
            sign = "-" if value < 0 else "+"
            text += f" {sign} {size}{self.labels[k]}" if text else f"{'-' if value < 0 else ''}{size}{self.labels[k]}"
        return text


def inertial_parameters(mechanism: Mechanism) -> Array:
    """pi of a mechanism, shape (10 bodies,): m, m c, and the inertia about O of every moving body [kg, m].

    Absolute axes of the reference configuration, origin O; bodies and parameters in the order of the columns of
    `regressor`. Run-time parameters take their default values.
    """
    expect(mechanism, Mechanism)
    result: list[float] = []
    for name, body in mechanism.bodies.items():
        if name == mechanism.ground:
            continue
        if body.mass is None or body.com is None:
            result += [0.0] * len(PARAMETERS)
            continue
        mass = float(mechanism.number(body.mass))
        com = np.array([float(mechanism.number(c)) for c in body.com])
        own = np.zeros((3, 3))
        if body.inertia is not None:
            own = np.array([[float(mechanism.number(c)) for c in row] for row in body.inertia])
        about = own + mass * (com @ com * np.eye(3) - np.outer(com, com))
        result += [mass, *(mass * com), *about[np.triu_indices(3)]]
    return np.array(result)


def base_parameters(
    mechanism: Mechanism, effects: Sequence[Effect] = (Gravity(),), *, states: int = 0, seed: int = 1
) -> BaseParameters:
    """The base inertial parameters: of the whole tree for open chains, along the closure for closed ones.

    For closed chains only null_space^T regressor counts: what the drives can tell. `states` random consistent
    states are used (default: enough for four times as many rows as columns).

    Raises:
        RankError: the singular values show no clear gap, or half of the states tell another number.
    """
    expect(mechanism, Mechanism)
    effects = given_effects(effects)
    system = System(mechanism)
    system.use_samples()
    loops = Loops(system)
    name = "regressor_independent" if system.cuts else "regressor"
    functions = {f.name: f for f in regressor_functions(system, effects, loops)}
    program = lower(functions[name])
    count, columns = program.outputs[0].shape
    number = states or 20 + 4 * columns // max(count, 1)
    random = np.random.default_rng(seed)
    q = _configurations(system, loops, number, random)
    number = len(q)
    rates = random.uniform(-3, 3, (2, number, program.inputs[1].size))
    known = {"p": np.repeat(system.parameter_values[None], number, 0)}
    further = [known.get(p.name, random.uniform(-1, 1, (number, p.size))) for p in program.inputs[3:]]
    (values,), status = evaluate(program, [q, *rates, *further])
    stacked = values[status == 0].reshape(-1, columns, count).swapaxes(1, 2)
    units = np.array([1.0, *([system.length] * 3), *([system.length**2] * 6)] * len(moving_bodies(system)))
    rows = np.array([1.0 if u.startswith("N/") else 1.0 / system.length for u in program.outputs[0].units[:count]])
    blocks = stacked * rows[:, None] / units
    sizes = np.abs(blocks).max(axis=(1, 2), initial=0.0)
    well = sizes <= FAR * np.median(sizes)
    blocks = blocks[well] / np.where(sizes > 0, sizes, 1.0)[well, None, None]
    matrix = blocks.reshape(-1, columns)
    norms = np.linalg.norm(matrix, axis=0)
    seen = norms > FAINT * norms.max(initial=0.0)
    scales = np.where(seen, norms, 1.0)
    matrix = np.where(seen, matrix / scales, 0.0)
    half = _rank(matrix[: len(blocks) // 2 * count])[0]
    found = _decided(matrix, units * scales, parameter_labels(system))
    if half != len(found):
        raise RankError(
            f"base parameters: expected the same number from half of the states, got {half} and {len(found)}; "
            "use more states"
        )
    return found


def _rank(matrix: Array) -> tuple[int, Array, tuple[float, float]]:
    """Where the singular values fall most, the values relative to the greatest, and those beside the gap."""
    singular = np.linalg.svd(matrix, compute_uv=False)
    if not singular.size or singular[0] == 0:
        return 0, np.zeros(matrix.shape[1]), (1.0, 0.0)
    relative = np.zeros(matrix.shape[1] + 1)
    relative[: len(singular)] = singular / singular[0]
    floored = np.maximum(relative, FLOOR)
    rank = 1 + int(np.argmax(floored[:-1] / floored[1:]))
    return rank, relative[:-1], (float(relative[rank - 1]), float(relative[rank]))


def _decided(matrix: Array, units: Array, labels: tuple[str, ...]) -> BaseParameters:
    rank, singular, (above, below) = _rank(matrix)
    if rank and above < CLEAR * max(below, FLOOR):
        raise RankError(
            f"base parameters: expected singular values with a clear gap, got {above:.1e} above and {below:.1e} below "
            "it; use more states or scale the mechanism"
        )
    order, upper = _pivoted(matrix, rank)
    independent = order[:rank]
    combination = np.zeros((rank, len(labels)))
    combination[:, independent] = np.eye(rank)
    combination[:, order[rank:]] = np.linalg.solve(upper[:, :rank], upper[:, rank:])
    combination[np.abs(combination) < ROUNDING] = 0.0
    combination *= units / units[independent][:, None]
    near = np.round(combination, 9)
    combination = np.where(np.abs(combination - near) < ROUNDING * np.abs(combination), near, combination)
    sequence = np.argsort(independent)
    unidentifiable = tuple(labels[k] for k in np.flatnonzero(~combination.any(axis=0)))
    return BaseParameters(
        labels,
        tuple(int(k) for k in independent[sequence]),
        combination[sequence],
        unidentifiable,
        singular,
        (above, below),
    )


def _pivoted(matrix: Array, rank: int) -> tuple[Array, Array]:
    """Order of the columns and the first rows of R, by Householder QR with column pivoting."""
    work, n = matrix.copy(), matrix.shape[1]
    order = np.arange(n)
    for k in range(rank):
        sizes = (work[k:, k:] ** 2).sum(axis=0)
        best = k + int(np.flatnonzero(sizes > (1 - TIED) * sizes.max())[0])
        work[:, [k, best]] = work[:, [best, k]]
        order[[k, best]] = order[[best, k]]
        vector = work[k:, k].copy()
        vector[0] += np.copysign(np.linalg.norm(vector), vector[0])
        vector /= np.linalg.norm(vector)
        work[k:, k:] -= 2 * np.outer(vector, vector @ work[k:, k:])
    return order, np.triu(work[:rank])


def _configurations(system: System, loops: Loops, count: int, random: np.random.Generator) -> Array:
    """Random configurations: anywhere for a tree, along walks on the closure manifold otherwise."""
    if not system.cuts:
        reach = np.array([system.length if c.kind == "length" else np.pi for c in system.tree.v])
        step = reach * random.uniform(-1, 1, (count, len(reach)))
        return system.advance(np.repeat(system.reference[None, :], count, 0), step)
    return _walks(system, loops, count, random)


def _walks(system: System, loops: Loops, count: int, random: np.random.Generator) -> Array:
    """Walks along the manifold from the sample states, each with a heading of its own.

    A step must close the loops again on the branch where it began, told by the signs of the closure's pivots;
    one that does not turns the walker round.
    """
    start = system.sample_states[0][1:]
    scales = system.scales
    n, walkers = len(scales), max(16, count // 8)
    q = np.resize(start, (walkers, start.shape[1]))
    headings = random.uniform(-1, 1, (walkers, n))
    signs = np.sign(system.numeric(loops.pivots, (system.inputs.q, q))) if loops.pivots else np.zeros((walkers, 0))
    found = [q]
    for _ in range(ROUNDS):
        jacobian = system.numeric(system.closure.dense(), (system.inputs.q, q)).reshape(walkers, -1, n) * scales
        pairs = zip(headings, jacobian, strict=True)
        tangent = np.array([h - np.linalg.pinv(j, rcond=DEPENDENT) @ (j @ h) for h, j in pairs])
        size = np.abs(tangent).max(axis=1, keepdims=True)
        step = STEP * tangent / np.where(size > 0, size, 1.0) * random.uniform(0.5, 1.0, (walkers, 1))
        moved = system.advance(q, scales * step)
        closed = system.samples.closed(moved)
        same = np.abs(closed - moved).max(axis=1) < STEP
        if loops.pivots:
            same &= (np.sign(system.numeric(loops.pivots, (system.inputs.q, closed))) == signs).all(axis=1)
        q = np.where(same[:, None], closed, q)
        headings = np.where(same[:, None], headings, random.uniform(-1, 1, (walkers, n)))
        found.append(q[same])
        if sum(map(len, found)) >= count:
            break
    return np.concatenate(found)[:count]
