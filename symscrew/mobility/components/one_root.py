"""A closure whose numbers are in several roots, over the one that a sum of them generates: as Singular has them.

Q(g, h, ...) --theta = g + 2 h + ..., its powers in products of g, h, ...--> g, h as polynomials in theta
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from itertools import product
from operator import mul

from symscrew.mobility.components.closure_parts import ClosureEquations, NotAlgebraicError
from symscrew.mobility.components.limb_equations import null_space
from symscrew.mobility.components.polynomials import Polynomial
from symscrew.mobility.symbols import (
    Exact,
    Field,
    Generator,
    exact_value,
    generator_itself,
    terms_of,
)

MOST = 8
"""Degree of the field at most: three square roots. Coefficients over more have hundreds of digits."""
Row = list[Fraction]


def over_one_root(closure: ClosureEquations) -> ClosureEquations:
    """The same equations over a field of one root; as they are where they have no more; raises NotAlgebraicError."""
    generators, degree = closure.field.generators, closure.field.degree
    if len(generators) < 2:
        return closure
    if degree > MOST:
        raise NotAlgebraicError(f"the numbers are in {closure.field}, of degree {degree}: expected {MOST} at most")
    theta = sum((generator_itself(g) * (k + 1) for k, g in enumerate(generators)), start=Fraction(0))
    keys = list(product(*(range(g.degree) for g in generators)))
    powers, one = [_row(Fraction(1), keys, generators)], Fraction(1)
    for _ in range(degree):
        one = one * theta
        powers.append(_row(one, keys, generators))
    modulus = _combination(powers[:-1], powers[-1])
    name = sum((k + 1) * g.name for k, g in enumerate(generators))
    root = Generator(0, tuple(-c for c in modulus), exact_value(theta), name)
    field = Field()
    field.generators = [root]
    images = [_image(_combination(powers[:-1], _row(generator_itself(g), keys, generators)), root) for g in generators]

    def moved(number: Exact) -> Exact:
        terms = terms_of(number, generators).items()
        return sum((reduce(mul, [i for i, e in zip(images, key, strict=True) for _ in range(e)], c)
                    for key, c in terms), start=Fraction(0))  # fmt: skip

    def each(polynomials: Sequence[Polynomial]) -> tuple[Polynomial, ...]:
        return tuple(Polynomial({key: moved(c) for key, c in p.terms.items()}) for p in polynomials)

    return replace(
        closure, equations=each(closure.equations), excluded=each(closure.excluded),
        reference=tuple(map(moved, closure.reference)), field=field,
    )  # fmt: skip


def _row(number: Exact, keys: Sequence[tuple[int, ...]], generators: Sequence[Generator]) -> Row:
    terms: Mapping[tuple[int, ...], Fraction] = terms_of(number, generators)
    return [terms.get(key, Fraction(0)) for key in keys]


def _combination(rows: Sequence[Row], wanted: Row) -> Row:
    """Of rows that are independent, what the wanted one is made of."""
    columns = [*rows, wanted]
    sparse = [{j: row[i] for j, row in enumerate(columns) if row[i]} for i in range(len(wanted))]
    (found,) = null_space(sparse, len(columns))
    return [-found.get(j, Fraction(0)) for j in range(len(rows))]


def _image(coefficients: Row, root: Generator) -> Exact:
    theta, power, value = generator_itself(root), Fraction(1), Fraction(0)
    for c in coefficients:
        value, power = value + power * c, power * theta
    return value
