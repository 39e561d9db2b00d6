"""Enclosures of functions of one variable x in [-r, r]: values, first and second derivatives between two numbers each.

An `Enclosure` carries intervals of a quantity and of its derivatives by x over the whole range, and the value and the
slope in the middle. What a program of sums, products and elementary functions makes of them follows operation by
operation; after each the value is cut to what the middle and the second derivative allow,

    f(x) in f(0) + f'(0) [-r, r] + f''([-r, r]) [0, r^2 / 2],

so that the excess falls with the third power of r where the second derivative does not vary much (R. E. Moore, R. B.
Kearfott, M. J. Cloud, Introduction to Interval Analysis, SIAM 2009, chapters 6 and 9). Rounding, 1e-16 per operation,
is left aside. All parts are arrays over many ranges at once.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

Pair = tuple[np.ndarray, np.ndarray]


@dataclass(frozen=True)
class Enclosure:
    """`low`, `high` (orders, n): bounds of the value, and with three orders of both derivatives; `middle` (2, n)."""

    low: np.ndarray
    high: np.ndarray
    middle: np.ndarray

    @property
    def orders(self) -> int:
        """1: values alone, 3: with the derivatives."""
        return len(self.low)

    @property
    def value(self) -> Pair:
        """Bounds of the value: two arrays (n,)."""
        return self.low[0], self.high[0]


Number = Enclosure | float
NONE = np.zeros((2, 1))  # the middle of what has none
NONE.flags.writeable = False


def interval(low: np.ndarray, high: np.ndarray) -> Enclosure:
    """Values between two arrays (n,), of which nothing else is known."""
    return Enclosure(low[None], high[None], NONE)


def polynomial(coefficients: np.ndarray, radius: np.ndarray) -> Enclosure:
    """Enclosure of sum_i coefficients[i] x^i (degree + 1, n) over [-radius, radius]."""
    count = len(coefficients)
    powers = np.arange(count)
    low, high = [], []
    now = coefficients
    for _ in range(3):
        reach = np.abs(now[1:]) * radius ** powers[1 : len(now), None]
        odd, even = reach[0::2].sum(axis=0), now[2::2] * radius ** powers[2 : len(now) : 2, None]
        low.append(now[0] - odd + np.minimum(even, 0.0).sum(axis=0))
        high.append(now[0] + odd + np.maximum(even, 0.0).sum(axis=0))
        now = now[1:] * powers[1 : len(now), None] if len(now) > 1 else np.zeros_like(now)
    slope = coefficients[1] if count > 1 else np.zeros_like(coefficients[0])
    return Enclosure(np.array(low), np.array(high), np.array([coefficients[0], slope]))


# -- intervals as pairs of arrays ------------------------------------------------------------------------------


def product(a: Pair, b: Pair) -> Pair:
    """All products of numbers in a and b; everything where a bound is not a number."""
    least, most, lower, upper = a[0] * b[0], a[1] * b[1], a[0] * b[1], a[1] * b[0]
    low = np.minimum(np.minimum(least, most), np.minimum(lower, upper))
    high = np.maximum(np.maximum(least, most), np.maximum(lower, upper))
    lost = low != low
    return (np.where(lost, -np.inf, low), np.where(lost, np.inf, high)) if lost.any() else (low, high)


def _plus(a: Pair, b: Pair) -> Pair:
    return a[0] + b[0], a[1] + b[1]


def _times(a: Pair, factor: float) -> Pair:
    return (a[0] * factor, a[1] * factor) if factor >= 0 else (a[1] * factor, a[0] * factor)


def _square(a: Pair) -> Pair:
    low, high = a[0] * a[0], a[1] * a[1]
    return np.where((a[0] <= 0) & (a[1] >= 0), 0.0, np.minimum(low, high)), np.maximum(low, high)


def _inverse(a: Pair) -> Pair:
    through = (a[0] <= 0) & (a[1] >= 0)
    return np.where(through, -np.inf, 1.0 / a[1]), np.where(through, np.inf, 1.0 / a[0])


def _rising(function: Callable[[np.ndarray], np.ndarray]) -> Callable[[Pair], Pair]:
    def bounds(a: Pair) -> Pair:
        low, high = function(a[0]), function(a[1])
        return np.where(np.isnan(low), -np.inf, low), np.where(np.isnan(high), np.inf, high)

    return bounds


def _cosine(a: Pair) -> Pair:
    """Largest where a multiple of two pi is inside, smallest where an odd multiple of pi is."""
    ends = np.cos(a[0]), np.cos(a[1])
    turn = 2 * np.pi
    top = np.floor(a[1] / turn) * turn >= a[0]
    bottom = (np.floor((a[1] - np.pi) / turn) * turn + np.pi) >= a[0]
    wide = ~np.isfinite(a[0] + a[1])
    return (
        np.where(bottom | wide, -1.0, np.minimum(*ends)),
        np.where(top | wide, 1.0, np.maximum(*ends)),
    )


def _sine(a: Pair) -> Pair:
    return _cosine((a[0] - np.pi / 2, a[1] - np.pi / 2))


def _negative(a: Pair) -> Pair:
    return -a[1], -a[0]


def _shifted(a: Pair, by: float) -> Pair:
    return a[0] + by, a[1] + by


def _root(a: Pair) -> Pair:
    """Of what is at least 0 of it: everything where nothing is."""
    return np.where(a[0] >= 0, np.sqrt(np.maximum(a[0], 0)), -np.inf), np.where(
        a[0] >= 0, np.sqrt(np.maximum(a[1], 0)), np.inf
    )


def _tangent(a: Pair) -> Pair:
    through = _cosine(a)
    pole = (through[0] <= 0) & (through[1] >= 0)
    return np.where(pole, -np.inf, np.tan(a[0])), np.where(pole, np.inf, np.tan(a[1]))


def _size(a: Pair) -> Pair:
    through = (a[0] <= 0) & (a[1] >= 0)
    ends = np.abs(a[0]), np.abs(a[1])
    return np.where(through, 0.0, np.minimum(*ends)), np.maximum(*ends)


def _sign(a: Pair) -> Pair:
    return np.where(a[0] >= 0, 1.0, -1.0), np.where(a[1] <= 0, -1.0, 1.0)


def _kink(a: Pair) -> Pair:
    """Second derivative of the absolute value: none at 0."""
    through = (a[0] <= 0) & (a[1] >= 0)
    return np.where(through, -np.inf, 0.0), np.where(through, np.inf, 0.0)


def _within_one(a: Pair) -> Pair:
    """1 - a^2."""
    return _shifted(_negative(_square(a)), 1.0)


def _slope_of_arc(a: Pair) -> Pair:
    return _inverse(_root(_within_one(a)))


def _slope_of_arctangent(a: Pair) -> Pair:
    return _inverse(_shifted(_square(a), 1.0))


@dataclass(frozen=True)
class Elementary:
    """A function of one argument on intervals, with its two derivatives."""

    value: Callable[[Pair], Pair]
    slope: Callable[[Pair], Pair]
    curvature: Callable[[Pair], Pair]


ELEMENTARY: Mapping[int, Elementary] = {
    ca.OP_SQ: Elementary(_square, lambda a: _times(a, 2.0), lambda a: (np.full_like(a[0], 2.0),) * 2),
    ca.OP_INV: Elementary(
        _inverse,
        lambda a: _negative(_square(_inverse(a))),
        lambda a: _times(product(_inverse(a), _square(_inverse(a))), 2.0),
    ),
    ca.OP_SQRT: Elementary(
        _root,
        lambda a: _times(_inverse(_root(a)), 0.5),
        lambda a: _times(product(_inverse(_root(a)), _inverse(a)), -0.25),
    ),
    ca.OP_SIN: Elementary(_sine, _cosine, lambda a: _negative(_sine(a))),
    ca.OP_COS: Elementary(_cosine, lambda a: _negative(_sine(a)), lambda a: _negative(_cosine(a))),
    ca.OP_TAN: Elementary(
        _tangent,
        lambda a: _shifted(_square(_tangent(a)), 1.0),
        lambda a: _times(product(_tangent(a), _shifted(_square(_tangent(a)), 1.0)), 2.0),
    ),
    ca.OP_ATAN: Elementary(
        _rising(np.arctan),
        _slope_of_arctangent,
        lambda a: _times(product(a, _square(_slope_of_arctangent(a))), -2.0),
    ),
    ca.OP_ASIN: Elementary(
        _rising(np.arcsin), _slope_of_arc, lambda a: product(product(a, _slope_of_arc(a)), _square(_slope_of_arc(a)))
    ),
    ca.OP_ACOS: Elementary(
        lambda a: _shifted(_negative(_rising(np.arcsin)(a)), np.pi / 2),
        lambda a: _negative(_slope_of_arc(a)),
        lambda a: _negative(product(product(a, _slope_of_arc(a)), _square(_slope_of_arc(a)))),
    ),
    ca.OP_EXP: Elementary(_rising(np.exp), _rising(np.exp), _rising(np.exp)),
    ca.OP_LOG: Elementary(_rising(np.log), _inverse, lambda a: _negative(_square(_inverse(a)))),
    ca.OP_FABS: Elementary(_size, _sign, _kink),
}


# -- operations ------------------------------------------------------------------------------------------------


class Arithmetic:
    """Operations on enclosures over ranges of half widths `radius` (n,)."""

    def __init__(self, radius: np.ndarray) -> None:
        self.radius, self.half = radius, radius**2 / 2

    def _cut(self, low: Sequence[np.ndarray], high: Sequence[np.ndarray], middle: Sequence[np.ndarray]) -> Enclosure:
        """With the value and the slope cut to what the middle and the second derivative allow."""
        value, slope = middle
        reach = np.maximum(np.abs(low[2]), np.abs(high[2])) * self.radius
        # fmax and fmin leave a number where the other side is none
        return Enclosure(
            np.array([np.fmax(low[0], value - self._rise(slope, -low[2])), np.fmax(low[1], slope - reach), low[2]]),
            np.array([np.fmin(high[0], value + self._rise(slope, high[2])), np.fmin(high[1], slope + reach), high[2]]),
            np.array([value, slope]),
        )

    def _rise(self, slope: np.ndarray, curvature: np.ndarray) -> np.ndarray:
        """Largest slope x + curvature x^2 / 2 over the range."""
        slope = np.abs(slope)
        inside = slope < -curvature * self.radius
        return np.asarray(
            np.where(
                inside,
                -(slope**2) / (2 * np.where(inside, curvature, 1.0)),
                slope * self.radius + curvature * self.half,
            )
        )

    def add(self, a: Number, b: Number, sign: float = 1.0) -> Number:
        """a + sign b."""
        if not isinstance(b, Enclosure):
            return self._raised(a, sign * b) if isinstance(a, Enclosure) else a + sign * b
        low, high, middle = (b.low, b.high, b.middle) if sign > 0 else (-b.high, -b.low, -b.middle)
        if not isinstance(a, Enclosure):
            return self._raised(Enclosure(low, high, middle), a)
        if a.orders == 1 or b.orders == 1:
            return Enclosure(a.low[:1] + low[:1], a.high[:1] + high[:1], NONE)
        return self._cut(a.low + low, a.high + high, a.middle + middle)

    def _raised(self, a: Enclosure, by: float) -> Enclosure:
        low, high, middle = a.low.copy(), a.high.copy(), a.middle.copy()
        low[0], high[0], middle[0] = low[0] + by, high[0] + by, middle[0] + by
        return Enclosure(low, high, middle)

    def scaled(self, a: Number, factor: float) -> Number:
        """factor a."""
        if not isinstance(a, Enclosure):
            return a * factor
        return Enclosure(*_times((a.low, a.high), factor), a.middle * factor)

    def multiply(self, a: Number, b: Number) -> Number:
        """a b."""
        if not isinstance(a, Enclosure):
            return self.scaled(b, a)
        if not isinstance(b, Enclosure):
            return self.scaled(a, b)
        if a.orders == 1 or b.orders == 1:
            return Enclosure(*product((a.low[:1], a.high[:1]), (b.low[:1], b.high[:1])), NONE)
        left, right = [0, 1, 0, 2, 1, 0], [0, 0, 1, 0, 1, 2]
        low, high = product((a.low[left], a.high[left]), (b.low[right], b.high[right]))
        (f, f_1), (g, g_1) = a.middle, b.middle
        return self._cut(
            [low[0], low[1] + low[2], low[3] + 2 * low[4] + low[5]],
            [high[0], high[1] + high[2], high[3] + 2 * high[4] + high[5]],
            [f * g, f_1 * g + f * g_1],
        )

    def of(self, made: Elementary, a: Enclosure) -> Enclosure:
        """An elementary function of a."""
        value = made.value(a.value)
        if a.orders == 1:
            return interval(*value)
        slope, curvature = made.slope(a.value), made.curvature(a.value)
        first, second = (a.low[1], a.high[1]), (a.low[2], a.high[2])
        d1 = product(slope, first)
        d2 = _plus(product(curvature, _square(first)), product(slope, second))
        point = a.middle[0], a.middle[0]
        middle = made.value(point)[0], made.slope(point)[0] * a.middle[1]
        return self._cut([value[0], d1[0], d2[0]], [value[1], d1[1], d2[1]], middle)

    def angle(self, y: Enclosure, x: Enclosure) -> Enclosure:
        """atan2(y, x); everything where (0, 0) or the cut along the negative x cannot be excluded."""
        centre = np.arctan2(y.middle[0], x.middle[0])
        r2 = _plus(_square(y.value), _square(x.value))
        safe = (r2[0] > 0) & ~((x.low[0] <= 0) & (y.low[0] <= 0) & (y.high[0] >= 0))
        every = np.where(safe, np.pi, np.inf)
        if min(x.orders, y.orders) == 1:
            corners = np.stack([np.arctan2(v, u) for v in y.value for u in x.value])
            return interval(np.where(safe, corners.min(axis=0), -np.inf), np.where(safe, corners.max(axis=0), np.inf))
        over = _inverse(r2)
        x1, y1, x2, y2 = ((e.low[k], e.high[k]) for k in (1, 2) for e in (x, y))
        turn = _plus(product(x.value, y1), _negative(product(y.value, x1)))
        d1 = product(turn, over)
        swing = _plus(product(x.value, x1), product(y.value, y1))
        d2 = product(_plus(product(x.value, y2), _negative(product(y.value, x2))), over)
        d2 = _plus(d2, _times(product(product(d1, swing), over), -2.0))
        d1, d2 = ((np.where(safe, d[0], -np.inf), np.where(safe, d[1], np.inf)) for d in (d1, d2))
        (u, u1), (v, v1) = x.middle, y.middle
        return self._cut([-every, d1[0], d2[0]], [every, d1[1], d2[1]], [centre, (u * v1 - v * u1) / (u * u + v * v)])

    def larger(self, a: Enclosure, b: Enclosure) -> Enclosure:
        """The larger of a and b; its slope is one of both where either may be larger, and has a kink."""
        n = min(a.orders, b.orders)
        first, second = a.low[0] >= b.high[0], b.low[0] >= a.high[0]
        low = np.where(first, a.low[:n], np.where(second, b.low[:n], np.minimum(a.low[:n], b.low[:n])))
        high = np.where(first, a.high[:n], np.where(second, b.high[:n], np.maximum(a.high[:n], b.high[:n])))
        low[0], high[0] = np.maximum(a.low[0], b.low[0]), np.maximum(a.high[0], b.high[0])
        middle = np.where(a.middle[0] >= b.middle[0], a.middle, b.middle)
        if n == 1:
            return interval(low[0], high[0])
        either = ~(first | second)
        low[2], high[2] = np.where(either, -np.inf, low[2]), np.where(either, np.inf, high[2])
        return Enclosure(low, high, np.broadcast_to(middle, (2, low.shape[1])))

    def smaller(self, a: Enclosure, b: Enclosure) -> Enclosure:
        """The smaller of a and b."""
        minus = [self.scaled(x, -1.0) for x in (a, b)]
        assert isinstance(minus[0], Enclosure) and isinstance(minus[1], Enclosure)
        found = self.scaled(self.larger(minus[0], minus[1]), -1.0)
        assert isinstance(found, Enclosure)
        return found

    def power(self, a: Number, exponent: Number) -> Number:
        """a to an exponent; everything where a may be negative and the exponent is not a small whole number."""
        if not isinstance(a, Enclosure) and not isinstance(exponent, Enclosure):
            return float(a**exponent)
        fixed = None if isinstance(exponent, Enclosure) else float(exponent)
        whole = int(fixed) if fixed is not None and fixed.is_integer() and 0 < abs(fixed) <= 8 else 0
        if not whole or not isinstance(a, Enclosure):
            return self._by_logarithm(a, exponent)
        total: Number = a
        for _ in range(abs(whole) - 1):
            total = self.multiply(total, a)
        assert isinstance(total, Enclosure)
        return total if whole > 0 else self.of(ELEMENTARY[ca.OP_INV], total)

    def _by_logarithm(self, a: Number, exponent: Number) -> Enclosure:
        """exp(exponent log(a)), for a that is not negative."""
        if not isinstance(a, Enclosure):
            times = self.scaled(exponent, float(np.log(a)) if a > 0 else np.nan)
            defined = np.array([a > 0])
        else:
            times, defined = self.multiply(exponent, self.of(ELEMENTARY[ca.OP_LOG], a)), a.low[0] >= 0
        assert isinstance(times, Enclosure)
        found = self.of(ELEMENTARY[ca.OP_EXP], times)
        return Enclosure(np.where(defined, found.low, -np.inf), np.where(defined, found.high, np.inf), found.middle)


def bounds_of(value: Number, n: int) -> Pair:
    """Bounds (n,) of a value."""
    if isinstance(value, Enclosure):
        low, high = (np.broadcast_to(v, (n,)) for v in value.value)
        return np.where(np.isnan(low), -np.inf, low), np.where(np.isnan(high), np.inf, high)
    return np.full(n, float(value)), np.full(n, float(value))


def constant(value: float, n: int, orders: int = 3) -> Enclosure:
    """A number over n ranges."""
    parts = np.zeros((orders, n))
    parts[0] = value
    return Enclosure(parts, parts, np.concatenate([parts[:1], np.zeros((1, n))]))


def everything(n: int) -> Enclosure:
    """Of which nothing is known over n ranges."""
    return Enclosure(np.full((3, n), -np.inf), np.full((3, n), np.inf), np.full((2, n), np.nan))
