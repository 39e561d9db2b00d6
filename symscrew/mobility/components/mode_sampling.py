"""Operation modes that random configurations show, where exact algebra does not end: sampled, and said to be.

    real configurations --steps along the tangents--> poses of one mode --null spaces--> forms that vanish on all of it
                        --forms that vanish--> configurations of the same mode

A mode is told from others by its dimensions and by the linear forms and quadrics in Study's parameters that vanish on
it. Two modes that these do not tell apart count as one, and one that no start has reached is missing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import Any

import numpy as np

from symscrew.mobility.components.real_configurations import body_pose, real_configurations, wrapped
from symscrew.mobility.finite import ClosureVariety
from symscrew.mobility.joint_network import Network

Array = np.ndarray[Any, Any]

POSES = 60
"""Of a mode: far more than the 36 quadrics in Study's parameters, so that forms are not of the sample."""
STUCK = 6
"""Tangents, none of which leads anywhere, after which a configuration is taken for isolated."""
EVERY = 6
"""Of these the dimensions are looked at: the mode has those of most."""
STRIDE = 0.4
"""Of a step along the tangents, rad and sizes of the mechanism: forms differ where poses do."""
NEWTON = 12
"""Steps back to the closure: three where the motion is smooth."""
CLOSED = 1e-11
"""Closure residual of a pose of the sample, in units of the mechanism's size."""
RANK = 1e-8
"""Relative singular value of the closure below which a row is redundant: those of doubles have 1e-15."""
VANISHES = 1e-12
"""Relative singular value of the poses' monomials below which a form vanishes on them: such forms have 1e-16, and on a
surface on which walks do not get far others have 1e-11."""
ON = 1e-6
"""A form that vanishes is below this at a configuration, which is known to half the digits where branches are near."""
ALIKE = 3e-4
"""Part by which directions of forms differ that are the same: where others have 1e-11 they are known to 1e-5."""
SEED = 20231009
"""Of the steps: always the same, so that results repeat."""
SIMPLE = 1000
"""Largest denominator of a coefficient that is shown as a fraction."""
NAMES = ("x0", "x1", "x2", "x3", "y0", "y1", "y2", "y3")
PAIRS = tuple(combinations_with_replacement(range(len(NAMES)), 2))


@dataclass(frozen=True)
class SampledMode:
    """A mode: dimension of its configurations and of the body's poses, its linear forms, how many quadrics vanish.

    `count`: configurations from random starts on it; `through`: whether the reference is on it, None where linear forms
    and quadrics alone do not cut the mode out. `witness`: displacements of a configuration on it; `certified`: whether
    intervals show that near it there is one and that all configurations around have exactly the mode's dimension.
    """

    dimension: int
    poses: int
    equations: tuple[str, ...]
    quadrics: int
    count: int
    through: bool | None
    witness: Array | None = field(default=None, compare=False, repr=False)
    certified: bool = False


@dataclass(frozen=True)
class SampledModes:
    """The modes of a body against another that were found, the number of starts that ended in a configuration."""

    body: str
    modes: tuple[SampledMode, ...]
    found: int


@dataclass(frozen=True)
class _Forms:
    """What tells a mode: dimensions and the null spaces of its poses' monomials, of degree 1 and 2."""

    size: tuple[int, int]
    linear: Array
    quadratic: Array
    cut_out: bool
    witness: Array


@dataclass(frozen=True, eq=False)
class Freedoms:
    """What moves at a configuration.

    `freedoms`: of the mechanism; `poses`: of one body against another; `twists`: theirs in unit motions as columns,
    (omega ; v/length) in the axes of the ground; `gap`: smallest singular value of the closure that is not zero, over
    the largest.
    """

    freedoms: int
    poses: int
    twists: Array
    gap: float


def sampled_modes(network: Network, body: str, found: Array | None = None) -> SampledModes:
    """The modes of the body's motion against the ground that random configurations show, or those that are given."""
    found = real_configurations(network) if found is None else found
    variety = ClosureVariety(network)
    random = np.random.default_rng(SEED)
    groups: list[tuple[_Forms, int]] = []
    for q in found:
        here, size = _monomials(network, variety, q, body), _dimensions(network, variety, q, body)
        same = next((k for k, (forms, _) in enumerate(groups) if forms.size == size and _zero(forms, here)), None)
        if same is None:
            walked = _walk(network, variety, q, random)
            if len(walked) < POSES:
                continue
            forms = _forms(network, variety, walked, body)
            same = next((k for k, (other, _) in enumerate(groups) if _alike(other, forms)), None)
            if same is None:
                groups.append((forms, 0))
                same = len(groups) - 1
            elif len(forms.quadratic) < len(groups[same][0].quadratic):  # the earlier walk has not left a part
                groups[same] = (forms, groups[same][1])
        groups[same] = (groups[same][0], groups[same][1] + 1)
    groups = _merged(groups)
    reference = _monomials(network, variety, np.zeros(variety.columns), body)
    modes = []
    for forms, count in groups:
        through = _zero(forms, reference) if forms.cut_out else None
        shown = _equations(forms.linear), len(forms.quadratic)
        modes.append(SampledMode(*forms.size, *shown, count, through, forms.witness))
    modes.sort(key=lambda m: (-m.dimension, -m.poses, m.equations))
    return SampledModes(body, tuple(modes), len(found))


def _merged(groups: list[tuple[_Forms, int]]) -> list[tuple[_Forms, int]]:
    """Of groups that are alike the one with the fewest forms: the walks of the others have not left a part of it."""
    kept: list[tuple[_Forms, int]] = []
    for forms, count in sorted(groups, key=lambda group: len(group[0].quadratic)):
        same = next((k for k, (other, _) in enumerate(kept) if _alike(other, forms)), None)
        if same is None:
            kept.append((forms, count))
        else:
            kept[same] = (kept[same][0], kept[same][1] + count)
    return kept


def _walk(network: Network, variety: ClosureVariety, q: Array, random: np.random.Generator) -> Array:
    """Configurations along random tangents, one from another."""
    result: list[Array] = []
    for tried in range(4 * POSES):
        screws = variety.forward(q[None])[0]
        _, s, vt = np.linalg.svd(variety.jacobians(screws, q[None])[0])
        tangent = vt[int((s > RANK * s[0]).sum()) :]
        if not len(tangent) or (tried == STUCK and not result):
            break  # an isolated configuration, of which some have instantaneous freedoms
        direction = random.normal(size=len(tangent)) @ tangent
        after = _closed(variety, q + STRIDE * direction / np.linalg.norm(direction))
        if after is not None and np.linalg.norm(after - q) < 2 * STRIDE:
            q = wrapped(network, after[None])[0]
            result.append(q)
        if len(result) == POSES:
            break
    return np.array(result).reshape(-1, variety.columns)


def _closed(variety: ClosureVariety, q: Array) -> Array | None:
    for _ in range(NEWTON):
        residuals, jacobians = variety.evaluate(q[None])
        closed = np.abs(residuals).max(initial=0.0) < CLOSED
        q = q - np.linalg.pinv(jacobians[0], rcond=RANK) @ residuals[0]
        if closed:  # one step more leaves rounding
            return q
    return None


def freedoms_at(network: Network, variety: ClosureVariety, q: Array, between: tuple[str, str]) -> Freedoms:
    """The instantaneous motions at a configuration, and those of the second body against the first."""
    screws = variety.forward(q[None])[0]
    _, s, vt = np.linalg.svd(variety.jacobians(screws, q[None])[0])
    rank = int((s > RANK * s[0]).sum())
    motions = vt[rank:].T
    rows = np.zeros((6, variety.columns))
    for sense, end in zip((-1, 1), between, strict=True):
        for name, sign in network.path(end):
            columns = list(network.edges[name].columns)
            rows[:, columns] += sense * sign * screws[0, columns].T
    twists = rows @ motions
    values = np.linalg.svd(twists, compute_uv=False)
    poses = int((values > RANK * max(1.0, values.max(initial=0.0))).sum())
    return Freedoms(motions.shape[1], poses, twists, float(s[rank - 1] / s[0]) if rank else 1.0)


def _dimensions(network: Network, variety: ClosureVariety, q: Array, body: str) -> tuple[int, int]:
    """Of the instantaneous motions, and of the body's twists in them."""
    found = freedoms_at(network, variety, q, (network.ground, body))
    return found.freedoms, found.poses


def _forms(network: Network, variety: ClosureVariety, poses: Array, body: str) -> _Forms:
    study = np.array([_pose(network, variety, q, body) for q in poses])
    sizes = [_dimensions(network, variety, q, body) for q in poses[::EVERY]]
    size = max(set(sizes), key=sizes.count)
    linear, quadratic = _null(study), _null(_pairs(study))
    x = study[-1]
    gradients = np.zeros((len(quadratic), len(NAMES)))
    for form, (i, j) in enumerate(PAIRS):
        gradients[:, i] += quadratic[:, form] * x[j]
        gradients[:, j] += quadratic[:, form] * x[i]
    values = np.linalg.svd(np.concatenate([linear, gradients]), compute_uv=False)
    cut_out = len(NAMES) - 1 - int((values > ALIKE).sum()) == size[1]
    return _Forms(size, linear, quadratic, cut_out, poses[EVERY * sizes.index(size)])


def _null(rows: Array) -> Array:
    """An orthonormal basis of the forms that vanish on all rows."""
    _, s, vt = np.linalg.svd(rows, full_matrices=True)
    return np.asarray(vt[int((s > VANISHES * s[0]).sum()) :])


def _pose(network: Network, variety: ClosureVariety, q: Array, body: str) -> Array:
    """Study's parameters with lengths in sizes of the mechanism, so that no decision depends on the unit."""
    study = body_pose(network, variety, q[None], network.ground, body)[0]
    return np.concatenate([study[:4], study[4:] / float(network.length)])


def _pairs(study: Array) -> Array:
    return np.stack([study[:, i] * study[:, j] for i, j in PAIRS], axis=1)


def _monomials(network: Network, variety: ClosureVariety, q: Array, body: str) -> tuple[Array, Array]:
    study = _pose(network, variety, q, body)
    return study, _pairs(study[None])[0]


def _zero(forms: _Forms, monomials: tuple[Array, Array]) -> bool:
    """Whether all forms vanish there."""
    return all(
        bool(np.abs(basis @ m).max(initial=0.0) < ON * np.linalg.norm(m))
        for basis, m in zip((forms.linear, forms.quadratic), monomials, strict=True)
    )


def _alike(one: _Forms, two: _Forms) -> bool:
    """Whether both have the same dimensions and linear forms, and the quadrics of one are among those of the other."""
    if one.size != two.size or one.linear.shape != two.linear.shape:
        return False
    few, many = sorted((one.quadratic, two.quadratic), key=len)
    return _inside(one.linear, two.linear) and _inside(few, many)


def _inside(few: Array, many: Array) -> bool:
    across = few - few @ many.T @ many
    return bool(np.abs(across).max(initial=0.0) < ALIKE)


def _equations(linear: Array) -> tuple[str, ...]:
    """The linear forms in echelon form, lengths in sizes of the mechanism; fractions where they are simple."""
    rows = linear.copy()
    for k in range(len(rows)):
        column = int(np.abs(rows[k:]).max(axis=0).argmax())
        lead = k + int(np.abs(rows[k:, column]).argmax())
        rows[[k, lead]] = rows[[lead, k]]
        rows[k] = rows[k] / rows[k, column]
        others = [i for i in range(len(rows)) if i != k]
        rows[others] = rows[others] - np.outer(rows[others, column], rows[k])
    return tuple(sorted(_sum(row) for row in rows))


def _sum(row: Sequence[float]) -> str:
    terms = []
    for value, name in zip(row, NAMES, strict=True):
        if abs(value) < ALIKE:
            continue
        near = Fraction(value).limit_denominator(SIMPLE)
        text = str(near) if abs(float(near) - value) < ON else f"{value:.4g}"
        terms.append(name if text == "1" else f"{text}*{name}")
    return "+".join(terms).replace("+-", "-")
