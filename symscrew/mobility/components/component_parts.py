"""Components, and those of a closure whose variables fall apart: loops that share no joint move independently.

ClosureEquations --independent_shares--> one for each set of variables that equations link
components of each --joined_parts--> their products: dimensions add up, degrees multiply
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod

from symscrew.mobility.components.polynomials import Exponents


@dataclass(frozen=True)
class Part:
    """A component: dimension and degree, its first equations, whether the reference is on it.

    `irreducible`: over the field of the description; otherwise it may consist of several of its dimension and lower,
    or, `irreducible_in_its_dimension`, of one of its dimension and lower ones.
    `polynomials`: the equations in doubles; `held`: (joint, angle [rad]) all over it, where these are variables of
    another chart; `multiplicity`: of an irreducible one at the reference, 1 where it is smooth; 0 where it does not
    pass through it, or that is not known.
    """

    dimension: int
    degree: int
    equations: tuple[str, ...]
    through: bool
    irreducible: bool
    polynomials: tuple[Mapping[Exponents, float], ...] = ()
    held: tuple[tuple[str, float], ...] = ()
    multiplicity: int = 0
    irreducible_in_its_dimension: bool = False


def linear_equations(part: Part) -> tuple[str, ...]:
    """Those of degree one, which hold on the part and maybe more; all where there are none."""
    both = zip(part.equations, part.polynomials, strict=True)
    return tuple(e for e, p in both if max(map(sum, p)) == 1) or part.equations


@dataclass(frozen=True)
class ExactParts:
    """All components, or why there are none; `complete`: whether their union is proved to be all configurations."""

    parts: tuple[Part, ...]
    complete: bool
    reason: str = ""


def joined(chosen: Sequence[tuple[Part, int]]) -> Part:
    """The product of components, each in so many variables of its own, in all these one after another.

    A component with a smooth point in the field is one over all numbers, and so is the product of such with another; of
    two without such a point it is not known.
    """
    parts, polynomials, before = [part for part, _ in chosen], list[Mapping[Exponents, float]](), 0
    count = sum(own for _, own in chosen)
    for part, own in chosen:
        left, right = (0,) * before, (0,) * (count - before - own)
        polynomials += [{(*left, *key, *right): c for key, c in p.items()} for p in part.polynomials]
        before += own
    known = sum(part.multiplicity == 1 or part.degree == 1 for part in parts)
    return Part(
        sum(part.dimension for part in parts), prod(part.degree for part in parts),
        tuple(e for part in parts for e in part.equations), all(part.through for part in parts),
        all(part.irreducible for part in parts) and known >= len(parts) - 1, tuple(polynomials),
        tuple(held for part in parts for held in part.held), prod(part.multiplicity for part in parts),
    )  # fmt: skip
