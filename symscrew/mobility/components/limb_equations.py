"""The equations that a serial chain lays on the pose of its end, in Study's parameters: linear ones and quadrics.

    screws --product of 1 + t (w + eps v)--> X(t) --coefficients of t--> all forms of degree 1, 2 with p(X(t)) = 0

p(X(t)) vanishes as a polynomial in t, so that nothing is sampled (linear implicitisation: D. R. Walter, M. Husty, On
implicitization of kinematic constraint equations, 2010). What the chain reaches is a part of the zeros: near its
generic poses all of them, where `cut_out` says so.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import Any

import numpy as np

from symscrew.mobility.components.polynomials import (
    Dual,
    Polynomial,
    constant,
    joint_factor,
    product,
    total,
    variable,
)
from symscrew.mobility.symbols import Exact, exact_inverse, exact_value

Array = np.ndarray[Any, Any]
Screw = Sequence[Exact]
Form = dict[tuple[int, ...], Exact]
"""Indices of Study's parameters that are multiplied -> coefficient."""
PARAMETERS = 8
"""Study's parameters x0 .. x3, y0 .. y3."""
LARGEST_CHAIN = 6
"""Freedoms of a chain: more reach every pose, and the expansion has 3^n terms."""
SAME = 1e-9
"""Relative singular value below which a rank at a random pose counts as lower."""
SEED = 20231009
"""Of the random poses: always the same, so that results repeat."""


def implicit_forms(chain: Sequence[Screw]) -> list[Form]:
    """A basis of the linear forms that vanish on the chain's poses, and quadrics that do not follow from them.

    None of a chain that reaches a neighbourhood of a random pose.
    """
    if _reached(chain)[1] == LARGEST_CHAIN:
        return []
    pose = _expanded(chain)
    linear = _vanishing(pose, 1)
    leading = {next(iter(form))[0] for form in linear}  # each in one form only
    quadrics = _vanishing(pose, 2, without=leading)
    return [*linear, *quadrics]


def _expanded(chain: Sequence[Screw]) -> Dual:
    count = len(chain)
    pose: Dual = [constant(Fraction(int(k == 0)), count) for k in range(PARAMETERS)]
    for k, screw in enumerate(chain):
        pose = product(pose, joint_factor(screw, variable(k, count), count))
    return pose


def _vanishing(pose: Dual, degree: int, without: frozenset[int] | set[int] = frozenset()) -> list[Form]:
    """Forms of the degree that vanish, free of the parameters in `without`, which linear forms express by others."""
    places = [k for k in range(PARAMETERS) if k not in without]
    monomials = list(combinations_with_replacement(places, degree))
    rows: dict[tuple[int, ...], dict[int, Exact]] = {}
    for column, monomial in enumerate(monomials):
        value = pose[monomial[0]]
        for k in monomial[1:]:
            value = value * pose[k]
        for key, c in value.terms.items():
            rows.setdefault(key, {})[column] = c
    found = null_space(sorted(rows.values(), key=len), len(monomials))
    return [{monomials[column]: c for column, c in vector.items()} for vector in found]


def null_space(rows: Sequence[dict[int, Exact]], columns: int) -> list[dict[int, Exact]]:
    """A basis of the null space of sparse rows; each vector begins with the column that it alone has."""
    pivots: dict[int, dict[int, Exact]] = {}
    for given in rows:
        row = dict(given)
        while row:
            lead = min(row)
            if lead not in pivots:
                back = exact_inverse(row[lead])
                pivots[lead] = {j: c * back for j, c in row.items()}
                break
            _subtract(row, pivots[lead], row[lead])
    for lead in sorted(pivots, reverse=True):
        for other in pivots:
            if other < lead and lead in pivots[other]:
                _subtract(pivots[other], pivots[lead], pivots[other][lead])
    result = []
    for free in (j for j in range(columns) if j not in pivots):
        vector: dict[int, Exact] = {free: Fraction(1)}
        vector |= {lead: -row[free] for lead, row in pivots.items() if free in row}
        result.append(vector)
    return result


def _subtract(row: dict[int, Exact], other: dict[int, Exact], factor: Exact) -> None:
    for j, c in other.items():
        value = row.get(j, Fraction(0)) - factor * c
        if value:
            row[j] = value
        else:
            row.pop(j, None)


def cut_out(chain: Sequence[Screw], forms: Sequence[Form]) -> bool:
    """Whether forms and Study's quadric have no other zeros near a random pose of the chain: by ranks in doubles."""
    if not chain:
        return True
    pose, reached = _reached(chain)
    study: Form = {(k, k + 4): Fraction(1) for k in range(4)}
    gradients = np.array([_gradient(form, pose) for form in (study, *forms)])
    return PARAMETERS - _rank(gradients) - 1 == reached


def _reached(chain: Sequence[Screw]) -> tuple[Array, int]:
    """(a random pose of the chain, the dimension of its poses near it)."""
    random = np.random.default_rng(SEED)
    screws = [np.array([float(exact_value(c)) for c in screw]) for screw in chain]
    sizes = [max(1.0, float(np.abs(s).max())) for s in screws]
    values = random.uniform(0.5, 1.5, size=len(chain))
    factors = [np.concatenate([[1.0], t * s[:3], [0.0], t * s[3:]]) for s, t in zip(screws, values, strict=True)]
    slopes = [np.concatenate([[0.0], s[:3], [0.0], s[3:]]) / size for s, size in zip(screws, sizes, strict=True)]
    pose = _numbers(factors)
    along = [_numbers([*factors[:k], slopes[k], *factors[k + 1 :]]) for k in range(len(chain))]
    return pose, _rank(np.array([pose, *along])) - 1


def _numbers(factors: Sequence[Array]) -> Array:
    pose = np.eye(PARAMETERS)[0]
    for factor in factors:
        one, two, three, four = (np.asarray(p) for p in (pose[:4], factor[:4], pose[4:], factor[4:]))
        pose = np.concatenate([_times(one, two), _times(one, four) + _times(three, two)])
    return np.asarray(pose)


def _times(a: Array, b: Array) -> Array:
    return np.array([a[0] * b[0] - a[1:] @ b[1:], *(a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:]))])


def _gradient(form: Form, pose: Array) -> Array:
    result = np.zeros(PARAMETERS)
    for monomial, c in form.items():
        for place, k in enumerate(monomial):
            rest = monomial[:place] + monomial[place + 1 :]
            result[k] += float(exact_value(c)) * float(np.prod(pose[list(rest)]))
    largest = float(np.abs(result).max())
    return np.asarray(result / largest if largest else result)


def _rank(rows: Array) -> int:
    sizes = np.linalg.norm(rows, axis=1)
    values = np.linalg.svd(rows[sizes > 0] / sizes[sizes > 0, None], compute_uv=False)
    return int((values > SAME * values[0]).sum())


def applied(form: Form, pose: Dual) -> Polynomial:
    """The form at a pose whose Study parameters are polynomials."""
    terms = []
    for monomial, c in form.items():
        value = pose[monomial[0]].scaled(c)
        for k in monomial[1:]:
            value = value * pose[k]
        terms.append(value)
    return total(terms)
