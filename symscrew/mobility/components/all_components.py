"""All components of the configuration space of a mechanism, exactly where that ends: dimension, degree, equations.

    Mechanism --closure_equations--> polynomials --exact_parts--> components, proved to be all of them
              --real_configurations--> each lies on one of these, or the list is withdrawn

Components are over the complex numbers: one may have few real points, or none. What is proved: every configuration lies
on one of these. Components on all of which a joint rests at the one angle where its variable has no value are looked
for in other charts, and where that does not end the angles are named. Where the variables do not settle all joints,
components are of the body's poses: those of configurations that differ with the body at the same poses are one, motions
of limbs with the body at rest are none of their own, and a part of the zeros may be beyond the reach of a limb.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from math import prod
from typing import Any

import numpy as np

from symscrew.description import Mechanism
from symscrew.mobility.components.algebraic_closure import closure_equations
from symscrew.mobility.components.allowed_time import AllowedTime
from symscrew.mobility.components.charts import held_components
from symscrew.mobility.components.closure_parts import ClosureEquations, NotAlgebraicError
from symscrew.mobility.components.component_parts import Part, joined
from symscrew.mobility.components.exact_parts import SECONDS, exact_parts
from symscrew.mobility.components.polynomials import Exponents
from symscrew.mobility.components.real_configurations import (
    real_configurations,
    resting_angles,
    told_apart,
    variables_at,
)
from symscrew.mobility.finite import blocks_of
from symscrew.mobility.joint_network import Network

Array = np.ndarray[Any, Any]

ON = 1e-5
"""A polynomial is zero where its value is below this part of what its terms can be with variables of that size: loops
are closed to 1e-12, and where branches touch Newton's method gives half these digits."""
NEARLY_ON = 1e-2
"""The same where many solutions meet in one: there a closure of 1e-12 tells the place to 1e-4, or 1e-3 of four."""
LOOKED_AT = 6
"""Configurations of a part whose derivatives are taken: a smooth one is mostly the first."""
INDEPENDENT = 1e-6
"""Singular value of derivatives of length one that counts: points are known to 1e-9, where nothing meets."""
MOST_PRODUCTS = 256
"""Products of components that are listed: eight independent loops with two components each."""
DIVIDED = "products of components of independent loops, which numbers outside of the field might divide"
NO_VALUE = 1e8
"""A tangent beyond this belongs to a joint within 1e-8 rad of the angle at which it has no value: it rests there, and
lies on what another chart shows."""


@dataclass(frozen=True)
class ConfigurationSpace:
    """The components with the variables in which their degree is counted.

    `subject`: what the variables fix, `settles`: whether all joints of the loops; `resting`: (joint, angle [rad]) such
    that a component on all of which the joint stands at the angle would be missed; none where other charts have been
    decomposed, too; `reason`: what was not done, empty
    where all parts are irreducible; `found`: real configurations from random starts, without those near to no part of
    which doubles do not tell where they are; `on`: how many of them lie on each part; `smooth`: about how many,
    of a few that were looked at, its equations leave exactly its dimension, so that it has as many real ones.
    """

    subject: str
    variables: tuple[str, ...]
    field: str
    parts: tuple[Part, ...]
    reason: str
    found: int
    on: tuple[int, ...]
    resting: tuple[tuple[str, float], ...] = ()
    settles: bool = True
    smooth: tuple[int, ...] = ()

    @property
    def proved(self) -> bool:
        """Whether every part is irreducible, by exact algebra; of all but what `resting` and `settles` leave out."""
        return all(part.irreducible for part in self.parts)


def configuration_space(mechanism: Mechanism, network: Network, seconds: float = SECONDS) -> ConfigurationSpace | str:
    """The components, or why they are not decided; exact algebra is given up after so many seconds in all.

    Loops that share no joint move independently: each set of these is decomposed for itself.
    """
    allowed = AllowedTime(seconds)
    blocks = [block for block in blocks_of(network) if block.chords]
    if len(blocks) < 2:
        return _of_one(mechanism, network, seconds)
    spaces = list[ConfigurationSpace]()
    for block in blocks:
        space = _of_one(mechanism, block, allowed.left)
        if isinstance(space, str):
            return space
        spaces.append(space)
    if prod(len(space.parts) for space in spaces) > MOST_PRODUCTS:
        return f"not decided: more than {MOST_PRODUCTS} products of components of independent loops"
    return _product(spaces)


def _product(spaces: Sequence[ConfigurationSpace]) -> ConfigurationSpace:
    """The products of the components of independent loops; configurations of each go together in every way."""
    named = [_apart(space, k + 1) for k, space in enumerate(spaces)]
    each = [list(zip(space.parts, space.on, space.smooth, strict=True)) for space in named]
    found = []
    for chosen in product(*each):
        sized = [(part, len(space.variables)) for (part, _, _), space in zip(chosen, named, strict=True)]
        found.append((joined(sized), prod(on for _, on, _ in chosen), prod(smooth for _, _, smooth in chosen)))
    found.sort(key=lambda one: (-one[0].dimension, one[0].degree, one[0].equations))
    reason = next((space.reason for space in named if space.reason), "")
    return ConfigurationSpace(
        "; ".join(dict.fromkeys(space.subject for space in named)),
        tuple(name for space in named for name in space.variables),
        ", ".join(dict.fromkeys(space.field for space in named)), tuple(part for part, _, _ in found),
        reason or ("" if all(part.irreducible for part, _, _ in found) else DIVIDED),
        prod(space.found for space in named), tuple(on for _, on, _ in found),
        tuple(rest for space in named for rest in space.resting), all(space.settles for space in named),
        tuple(smooth for _, _, smooth in found),
    )  # fmt: skip


def _apart(space: ConfigurationSpace, number: int) -> ConfigurationSpace:
    """The same with names of variables that other loops do not have."""

    def renamed(text: str) -> str:
        return re.sub(names, rf"\1_{number}", text)

    names = re.compile(rf"\b({'|'.join(map(re.escape, space.variables))})\b")
    parts = tuple(replace(p, equations=tuple(map(renamed, p.equations))) for p in space.parts)
    return replace(space, variables=tuple(map(renamed, space.variables)), parts=parts)


def _of_one(mechanism: Mechanism, network: Network, seconds: float) -> ConfigurationSpace | str:
    """The components of loops that are linked by joints."""
    try:
        closure = closure_equations(mechanism, network)
    except NotAlgebraicError as error:
        return f"not decided: {error}"
    allowed = AllowedTime(seconds)
    exact = exact_parts(closure, seconds, local=True)
    if not exact.complete:
        return f"not decided: {exact.reason}"
    held = None  # what is no list of irreducible components would not be one with more of them
    if all(part.irreducible for part in exact.parts):
        held = held_components(mechanism, network, closure, allowed.left)
    parts = [*((part, closure) for part in exact.parts), *(held or ())]
    q = real_configurations(network)
    values = [_values(own, network, q) for _, own in parts]
    count = len(values[0]) if values else 0
    told = told_apart(network, q[:count])
    open_to = np.where(told, ON, NEARLY_ON)
    on_each = [on_part(part, v, open_to) for (part, _), v in zip(parts, values, strict=True)]
    members = np.array(on_each).reshape(len(parts), count)
    seen = members.any(axis=0)
    if (told & ~seen).any():
        return "not decided: a configuration was found that is on none of the components of the equations"
    on = tuple(int(row.sum()) for row in members)
    smooth = tuple(
        _smooth(part, v[row], part.dimension + bool(own.scaled))
        for (part, own), v, row in zip(parts, values, members, strict=True)
    )
    return ConfigurationSpace(
        closure.subject, closure.variables, str(closure.field), tuple(part for part, _ in parts), exact.reason,
        int((seen | told).sum()),
        on, resting_angles(closure, network) if held is None else (), closure.settles, smooth,
    )  # fmt: skip


def _values(closure: ClosureEquations, network: Network, q: Array) -> Array:
    values = variables_at(closure, network, q)
    return np.zeros((0, len(closure.variables))) if values is None else values


def _smooth(part: Part, values: Array, left: int) -> int:
    """About how many of the first points the part's equations have derivatives that leave so many dimensions."""
    count = 0
    for point in values[:LOOKED_AT]:
        rows = np.array([_slopes(polynomial, point) for polynomial in part.polynomials]).reshape(-1, len(point))
        sizes = np.linalg.norm(rows, axis=1, keepdims=True)
        s = np.linalg.svd(rows / np.where(sizes > 0, sizes, 1.0), compute_uv=False)
        count += len(point) - int((s > INDEPENDENT).sum()) == left
    return count


def _slopes(polynomial: Mapping[Exponents, float], point: Array) -> Array:
    slopes = np.zeros(len(point))
    for key, c in polynomial.items():
        for k in np.flatnonzero(key):
            lower = np.array(key)
            lower[k] -= 1
            slopes[k] += c * key[k] * float(np.prod(point**lower))
    return slopes


def on_part(part: Part, values: Array, open_to: Array) -> Array:
    """Which rows of values are zeros of all equations of the part, each as near as it is known."""
    inside = np.array(np.abs(values).max(axis=1, initial=0.0) < NO_VALUE)
    largest = np.abs(values).max(axis=1, initial=1.0)
    for polynomial in part.polynomials:
        value = sum(c * np.prod(values ** np.array(key), axis=1) for key, c in polynomial.items())
        size = sum(abs(c) * largest ** sum(key) for key, c in polynomial.items())
        inside &= np.abs(value) <= open_to * size
    return inside
