"""The states of a mechanism that moves as it is asked to: q by Newton's method along the motion, v and a from it.

goals p(t) --Newton on the loops, from the state before--> q(t) --null space--> v(t), a(t), with what is missed

A twist is integrated from the reference configuration (`symscrew.studies.platform_motion`), which gives v and a.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.model import Model
from symscrew.program import Program, evaluate
from symscrew.runtime import CompiledModel
from symscrew.studies.given_motion.goals import Goals, goals_of
from symscrew.studies.given_motion.wanted_motion import WantedMotion
from symscrew.studies.platform_motion import integrate

Array = np.ndarray
WALK = 16  # parts of the way from the reference configuration to the motion's first pose: steps of a few degrees
STEPS = 12  # of Newton's method for a pose: it doubles its digits in each, so that 6 are used where it converges
CLOSED = 1e-11  # [1] of goals and loops, lengths by the characteristic length: what twice rounding leaves of 16 digits
MISSED = 1e-8  # the same, of a pose that counts as reached; a mechanism that cannot take it misses it by far more
RANK = 1e-9  # of the smallest singular value by the largest, below which the goals leave a freedom open
TINY = 1e-300  # in place of the zero size of a column that nothing moves along
FARTHEST = 0.5  # [1] of a step of Newton's method: longer ones could jump to another assembly branch


@dataclass(frozen=True)
class Followed:
    """q (n, nq), v, a (n, nv) at the motion's times; `missed`: largest miss of a goal, its rate, its acceleration [1].

    Lengths are divided by the characteristic length.
    """

    q: Array
    v: Array
    a: Array
    missed: tuple[float, float, float]
    opening: float


def follow(
    model: Model,
    functions: CompiledModel,
    wanted: WantedMotion,
    *,
    steps: Callable[[Sequence[int]], Iterable[int]] = iter,
) -> Followed:
    """The states of a motion; `steps` may wrap the loop, for progress.

    Raises:
        DescriptionError: names that do not exist or do not determine the motion; a pose, rate or acceleration that the
            mechanism cannot have, with the time and how far it is off.
        EvaluationError: a configuration in which a function fails.
    """
    if wanted.twist:
        return _of_twist(model, functions, wanted, steps)
    goals, wanted = goals_of(model, functions, wanted)
    q = _configurations(goals, wanted, steps)
    v, a, missed = _rates(goals, wanted, q)
    offs = (goals.values(q) - wanted.values) / _sizes(goals)
    return Followed(q, v, a, (float(np.abs(offs).max()), *missed), _opening(functions, model, q))


def _configurations(goals: Goals, wanted: WantedMotion, steps: Callable[[Sequence[int]], Iterable[int]]) -> Array:
    q = np.empty((len(wanted.t), len(goals.model.system.reference)))
    here = goals.model.system.reference[None]
    start = goals.values(here)[0]
    for part in np.linspace(0, 1, WALK + 1)[1:]:
        here = _reached(goals, wanted, here, start + part * (wanted.values[0] - start), at=None if part < 1 else 0)
    q[0] = here[0]
    for k in steps(range(1, len(wanted.t))):
        q[k] = here = _reached(goals, wanted, here, wanted.values[k], at=k)
        here = here[None] if here.ndim == 1 else here
    return q


def _reached(goals: Goals, wanted: WantedMotion, q: Array, goal: Array, *, at: int | None) -> Array:
    """The configuration nearby with these goals; `at`: which sample, None on the way to the first."""
    model, functions = goals.model, goals.functions
    size, rows = 0.0, _sizes(goals)
    for _ in range(STEPS):
        miss = (goals.values(q)[0] - goal) / rows
        opening = _opening(functions, model, q)
        size = max(float(np.abs(miss).max()), opening)
        if size < CLOSED:
            return q
        basis = np.asarray(functions.null_space(q))
        along = goals.along(q, basis)[0] / rows[:, None]
        scale = _checked_rank(along, wanted, at)
        y_dot = -np.linalg.lstsq(along / scale, miss, rcond=RANK)[0] / scale
        move = basis[0] @ y_dot
        largest = float(np.abs(move).max()) / FARTHEST
        q = _closed(model, functions, model.system.moved(q, (move / max(1.0, largest))[None]))
    if at is not None and size > MISSED:
        worst = int(np.abs(miss).argmax())
        far = f"{wanted.names[worst]} is off by {abs(miss[worst]) * rows[worst]:.3g}"
        far += f", the loops are open by {opening:.1e}" if opening > MISSED else ""
        raise DescriptionError(
            f"at t = {wanted.t[at]:g} s the mechanism does not get there: {far}; ask for less, or for fewer numbers"
        )
    return q


def _open_freedoms(along: Array, scale: Array) -> Array:
    """How many freedoms the goals leave open, in each state."""
    values = np.linalg.svd(along / scale, compute_uv=False)
    short = max(0, along.shape[2] - along.shape[1])
    found: Array = short + (values < RANK * np.maximum(values[:, :1], TINY)).sum(axis=1)
    return found


def _checked_rank(along: Array, wanted: WantedMotion, at: int | None) -> Array:
    """Sizes of the freedoms' columns; raises where the goals leave a freedom open."""
    scale: Array = np.maximum(np.abs(along).max(axis=0), TINY)
    loose = int(_open_freedoms(along[None], scale[None, None])[0])
    if loose:
        where = "" if at is None else f" at t = {wanted.t[at]:g} s"
        raise DescriptionError(
            f"{', '.join(wanted.names)}: expected numbers that determine all {along.shape[1]} freedoms of the "
            f"mechanism, these leave {loose} of them open{where}"
        )
    return scale


def _closed(model: Model, functions: CompiledModel, q: Array) -> Array:
    """The configuration on the loops nearest to q, in the metric of the closing function."""
    if "close_position" not in functions.functions:
        return q
    for _ in range(STEPS):
        found = functions.close_position(q)
        assert isinstance(found, tuple)
        q = np.asarray(found[0])
        if float(np.abs(np.asarray(found[1])).max()) < CLOSED:
            break
    return q


def _opening(functions: CompiledModel, model: Model, q: Array) -> float:
    """How far the loops are open, lengths by the characteristic length."""
    if "closure" not in functions.functions:
        return 0.0
    program = model.programs["closure"]
    assert isinstance(program, Program)
    rows = np.array([model.system.length if unit == "m" else 1.0 for unit in program.outputs[0].units])
    return float(np.abs(np.asarray(functions.closure(q)) / rows).max(initial=0.0))


def _sizes(goals: Goals) -> Array:
    """What goals are divided by: the characteristic length where they are lengths."""
    tree = goals.model.system.tree
    sizes = []
    for kind, k in goals.order:
        length = kind == "place" or (kind == "coordinate" and tree.q[goals.coordinates[k]].unit == "m")
        sizes.append(goals.model.system.length if length else 1.0)
    return np.array(sizes)


def _rates(goals: Goals, wanted: WantedMotion, q: Array) -> tuple[Array, Array, tuple[float, float]]:
    """v and a that the motion asks for, by least squares in the freedoms, and what that misses."""
    functions, sizes = goals.functions, _sizes(goals)
    basis = np.asarray(functions.null_space(q))
    along = goals.along(q, basis) / sizes[:, None]
    scale = np.maximum(np.abs(along).max(axis=1, keepdims=True), TINY)
    inverse = np.linalg.pinv(along / scale) / np.swapaxes(scale, 1, 2)
    for k in np.flatnonzero(_open_freedoms(along, scale)):
        _checked_rank(along[k], wanted, int(k))
    v = np.einsum("nij,njk,nk->ni", basis, inverse, wanted.rates / sizes)
    still = np.asarray(functions.acceleration(q, v, np.zeros((len(q), basis.shape[-1]))))
    missing = (wanted.accelerations - goals.accelerations(q, v, still)) / sizes
    a = np.asarray(functions.acceleration(q, v, np.einsum("njk,nk->nj", inverse, missing)))
    rate_off = np.abs(goals.rates(q, v) - wanted.rates) / sizes
    gain_off = np.abs(goals.accelerations(q, v, a) - wanted.accelerations) / sizes
    for what, off, full in (("rate", rate_off, wanted.rates), ("acceleration", gain_off, wanted.accelerations)):
        allowed = max(MISSED, 10 * wanted.uncertain) * max(1.0, float(np.abs(full / sizes).max()))
        if off.max() > allowed:
            k, worst = np.unravel_index(off.argmax(), off.shape)
            raise DescriptionError(
                f"at t = {wanted.t[k]:g} s the mechanism cannot move so: the {what} of {wanted.names[worst]} is off by "
                f"{off.max() * sizes[worst]:.3g}; leave out what follows from the rest"
            )
    return v, a, (float(rate_off.max()), float(gain_off.max()))


@dataclass(frozen=True)
class _Twist:
    """The platform's twist as `integrate` takes it."""

    components: tuple[str, ...]
    program: Program

    def rate(self, t: Array) -> Array:
        """Components at times of any shape."""
        return self._of(t, 0)

    def acceleration(self, t: Array) -> Array:
        """Their derivatives."""
        return self._of(t, 1)

    def _of(self, t: Array, which: int) -> Array:
        times = np.asarray(t, dtype=float)
        found = evaluate(self.program, (times.reshape(-1, 1),))[0][which]
        return np.asarray(found).reshape(*times.shape, len(self.components))


def _of_twist(
    model: Model, functions: CompiledModel, wanted: WantedMotion, steps: Callable[[Sequence[int]], Iterable[int]]
) -> Followed:
    assert wanted.program is not None
    freedoms = model.programs["null_space"].outputs[0].shape[1]
    if len(wanted.names) != freedoms:
        raise DescriptionError(
            f"{', '.join(wanted.names)}: expected as many components of the platform's twist as the mechanism has "
            f"freedoms, {freedoms}; the others follow"
        )
    try:
        found = integrate(model, functions, _Twist(wanted.names, wanted.program), wanted.t, steps=steps)
    except np.linalg.LinAlgError as error:
        raise DescriptionError(
            f"{', '.join(wanted.names)}: the platform cannot turn or move so alone: choose components that "
            "determine its freedoms"
        ) from error
    return Followed(found.q, found.v, found.a, (found.drift, 0.0, 0.0), _opening(functions, model, found.q))
