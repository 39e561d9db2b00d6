"""Rectangles of integers hold what they must, and no more than rounding asks for."""

from __future__ import annotations

import itertools
import random
from fractions import Fraction

import pytest

from symscrew.assembly.dual_forms import PRODUCT, SIZE
from symscrew.assembly.rectangles import ONE, Rectangle, chain, dot

ENDS = (-7 * ONE // 3, -ONE // 5, -1, 0, 1, ONE // 7, 5 * ONE // 3)
INTERVALS = [(a, b) for a in ENDS for b in ENDS if a <= b]


@pytest.mark.parametrize("a", INTERVALS)
def test_a_product_is_the_hull_of_its_corners_whatever_the_signs(a: tuple[int, int]) -> None:
    for b in INTERVALS:
        corners = [Fraction(x * y, ONE) for x in a for y in b]
        low, high = (Rectangle(a) * Rectangle(b)).real
        assert low <= min(corners) < low + 1 and high - 1 < max(corners) <= high


def test_sums_of_products_hold_those_of_points_within() -> None:
    random.seed(5)

    def point(box: Rectangle) -> tuple[Fraction, Fraction]:
        one, two = (Fraction(random.choice(ends), ONE) for ends in (box.real, box.imaginary))
        return one, two

    def times(x: tuple[Fraction, Fraction], y: tuple[Fraction, Fraction]) -> tuple[Fraction, Fraction]:
        return x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]

    def holds(box: Rectangle, values: list[tuple[Fraction, Fraction]]) -> bool:
        ends = zip((box.real, box.imaginary), (sum(v[0] for v in values), sum(v[1] for v in values)), strict=True)
        return all(low <= value * ONE <= high for (low, high), value in ends)

    def some() -> list[Rectangle]:
        boxes = [Rectangle(random.choice(INTERVALS), random.choice(INTERVALS)) for _ in range(SIZE)]
        return [box if random.random() < 0.7 else Rectangle((0, 0)) for box in boxes]

    for _ in range(50):
        one, two = some(), some()
        p, q = [point(box) for box in one], [point(box) for box in two]
        assert holds(dot(one, two), [times(x, y) for x, y in zip(p, q, strict=True)])
        for k, box in enumerate(chain([one, two])):
            terms = [times(p[i], q[j]) for i, j in itertools.product(range(SIZE), repeat=2)]
            signs = [int(PRODUCT[k, i, j]) for i, j in itertools.product(range(SIZE), repeat=2)]
            assert holds(box, [(s * x, s * y) for s, (x, y) in zip(signs, terms, strict=True)])
