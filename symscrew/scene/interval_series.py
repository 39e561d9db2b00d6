"""Taylor series of functions of time with intervals as coefficients, on many intervals of time at once.

t in [left, right] --expression--> c_0 ... c_n with f^(k)(t) / k! in c_k for every t of the interval

Recurrences for the coefficients: Moore, Kearfott, Cloud, Introduction to Interval Analysis, 2009, section 9.3. Rounding
is not directed outwards: what is asked are sizes.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import sympy

ORDER = 8  # of the integrator: what it resolves in a step is a polynomial of this order
Array = np.ndarray
Interval = tuple[Array, Array]
Series = list[Interval]  # ORDER + 1 coefficients


def _times(a: Interval, b: Interval) -> Interval:
    products = np.stack([x * y for x in a for y in b])
    products[np.isnan(products)] = 0.0  # 0 times an infinite end
    return products.min(axis=0), products.max(axis=0)


def _plus(a: Interval, b: Interval) -> Interval:
    return a[0] + b[0], a[1] + b[1]


def _scaled(a: Interval, factor: float) -> Interval:
    one, other = a[0] * factor, a[1] * factor
    return np.minimum(one, other), np.maximum(one, other)


def _inverse(a: Interval) -> Interval:
    zero = (a[0] <= 0) & (a[1] >= 0)
    low, high = np.where(zero, 1.0, a[0]), np.where(zero, 1.0, a[1])
    return np.where(zero, -np.inf, 1 / high), np.where(zero, np.inf, 1 / low)


def _sum(terms: list[Interval], like: Interval) -> Interval:
    total = (np.zeros_like(like[0]), np.zeros_like(like[0]))
    for term in terms:
        total = _plus(total, term)
    return total


def _product(a: Series, b: Series) -> Series:
    made = [_sum([_times(a[j], b[k - j]) for j in range(k + 1)], a[0]) for k in range(len(a))]
    if a is b:  # a square is not negative
        low = np.where((a[0][0] <= 0) & (a[0][1] >= 0), 0.0, np.minimum(a[0][0] ** 2, a[0][1] ** 2))
        made[0] = low, np.maximum(a[0][0] ** 2, a[0][1] ** 2)
    return made


def _quotient(a: Series, b: Series) -> Series:
    inverse, made = _inverse(b[0]), Series()
    for k in range(len(a)):
        known = _sum([_times(b[j], made[k - j]) for j in range(1, k + 1)], a[0])
        made.append(_times(_plus(a[k], _scaled(known, -1.0)), inverse))
    return made


def _exponential(a: Series) -> Series:
    made = [(np.exp(a[0][0]), np.exp(a[0][1]))]
    for k in range(1, len(a)):
        made.append(_scaled(_sum([_scaled(_times(a[j], made[k - j]), j) for j in range(1, k + 1)], a[0]), 1 / k))
    return made


def _sine_range(a: Interval) -> Interval:
    low, high = a
    known = np.isfinite(low) & np.isfinite(high)
    low, high = np.where(known, low, 0.0), np.where(known, high, 7.0)
    ends = np.sin(np.stack([low, high]))
    top = np.floor((high - np.pi / 2) / (2 * np.pi)) >= np.ceil((low - np.pi / 2) / (2 * np.pi))
    bottom = np.floor((high + np.pi / 2) / (2 * np.pi)) >= np.ceil((low + np.pi / 2) / (2 * np.pi))
    return np.where(bottom, -1.0, ends.min(axis=0)), np.where(top, 1.0, ends.max(axis=0))


def _sine_cosine(a: Series) -> tuple[Series, Series]:
    quarter = np.pi / 2
    sine, cosine = [_sine_range(a[0])], [_sine_range((a[0][0] + quarter, a[0][1] + quarter))]
    for k in range(1, len(a)):
        rise = _sum([_scaled(_times(a[j], cosine[k - j]), j) for j in range(1, k + 1)], a[0])
        fall = _sum([_scaled(_times(a[j], sine[k - j]), j) for j in range(1, k + 1)], a[0])
        sine.append(_scaled(rise, 1 / k))
        cosine.append(_scaled(fall, -1 / k))
    return sine, cosine


def _power(a: Series, exponent: float) -> Series:
    """a^exponent for a real exponent; of no bound where a may be 0 or less."""
    positive = a[0][0] > 0
    safe = np.where(positive, a[0][0], 1.0), np.where(positive, a[0][1], 1.0)
    ends = np.stack([safe[0] ** exponent, safe[1] ** exponent])
    wide = np.where(positive, ends.min(axis=0), -np.inf), np.where(positive, ends.max(axis=0), np.inf)
    inverse, made = _inverse(safe), [wide]
    for k in range(1, len(a)):
        terms = [_scaled(_times(a[j], made[k - j]), exponent * j - (k - j)) for j in range(1, k + 1)]
        made.append(_times(_scaled(_sum(terms, a[0]), 1 / k), inverse))
    return made


def _whole_power(a: Series, exponent: int) -> Series:
    if exponent < 0:
        one = _constant(1.0, a[0][0])
        return _quotient(one, _whole_power(a, -exponent))
    if exponent == 0:
        return _constant(1.0, a[0][0])
    if exponent == 1:
        return a
    half = _whole_power(a, exponent // 2)
    square = _product(half, half)
    return _product(square, a) if exponent % 2 else square


def _from_rate(a: Series, start: Interval, divisor: Series) -> Series:
    """The series f with f_0 = start and f' = a' / divisor."""
    inverse, made = _inverse(divisor[0]), [start]
    for k in range(1, len(a)):
        known = _sum([_scaled(_times(made[j], divisor[k - j]), j / k) for j in range(1, k)], a[0])
        made.append(_times(_plus(a[k], _scaled(known, -1.0)), inverse))
    return made


def _arc_tangent(a: Series) -> Series:
    square = _product(a, a)
    return _from_rate(a, (np.arctan(a[0][0]), np.arctan(a[0][1])), [_plus(square[0], _UNIT), *square[1:]])


def _arc_sine(a: Series) -> Series:
    square = _product(a, a)
    left = [_plus(_UNIT, _scaled(square[0], -1.0)), *(_scaled(c, -1.0) for c in square[1:])]
    start = np.arcsin(np.clip(a[0][0], -1, 1)), np.arcsin(np.clip(a[0][1], -1, 1))
    return _from_rate(a, start, _power(left, 0.5))


def _absolute(a: Series) -> Series:
    """|a|; of no bound from the first rate on where a may change its sign."""
    both = (a[0][0] < 0) & (a[0][1] > 0)
    down = a[0][1] <= 0
    made = [(np.where(down, -c[1], c[0]), np.where(down, -c[0], c[1])) for c in a]
    largest = np.maximum(-a[0][0], a[0][1])
    made[0] = np.where(both, 0.0, made[0][0]), np.where(both, largest, made[0][1])
    return [made[0], *((np.where(both, -np.inf, low), np.where(both, np.inf, high)) for low, high in made[1:])]


def _sign(a: Series) -> Series:
    """The sign of a, as derivatives of |a| have it; of no bound from the first rate on where a may change its sign."""
    low, high = np.sign(a[0][0]), np.sign(a[0][1])
    wide = np.where(low == high, 0.0, np.inf)
    return [(low, high), *([(-wide, wide)] * (len(a) - 1))]


def _constant(value: float, like: Array) -> Series:
    zero = (np.zeros_like(like), np.zeros_like(like))
    return [(np.full_like(like, value), np.full_like(like, value)), *([zero] * ORDER)]


_UNIT: Interval = (np.ones(1), np.ones(1))
_UNARY: dict[object, Callable[[Series], Series]] = {
    sympy.exp: _exponential,
    sympy.sin: lambda a: _sine_cosine(a)[0],
    sympy.cos: lambda a: _sine_cosine(a)[1],
    sympy.tan: lambda a: _quotient(*_sine_cosine(a)),
    sympy.cot: lambda a: _quotient(*_sine_cosine(a)[::-1]),
    sympy.asin: _arc_sine,
    sympy.acos: lambda a: [_scaled(c, -1.0) if k else _plus((np.pi / 2, np.pi / 2), _scaled(c, -1.0))  # type: ignore[arg-type]
                           for k, c in enumerate(_arc_sine(a))],
    sympy.atan: _arc_tangent,
    sympy.Abs: _absolute,
    sympy.sign: _sign,
}  # fmt: skip


def series(expression: sympy.Expr, left: Array, right: Array) -> Series:
    """Coefficients of a function of time alone on the intervals [left, right] (n,).

    Raises:
        ValueError: a function that is not known here.
    """
    if expression.is_number:
        return _constant(float(expression), left)
    if expression.is_Symbol:
        return [(left, right), (np.ones_like(left), np.ones_like(left)), *_constant(0.0, left)[2:]]
    if expression.is_Pow and expression.exp.is_number:
        base = series(expression.base, left, right)
        whole = expression.exp.is_Integer
        return _whole_power(base, int(expression.exp)) if whole else _power(base, float(expression.exp))
    parts = [series(arg, left, right) for arg in expression.args]
    if expression.is_Add:
        return [_sum([part[k] for part in parts], (left, right)) for k in range(ORDER + 1)]
    if expression.is_Mul:
        made = parts[0]
        for part in parts[1:]:
            made = _product(made, part)
        return made
    if expression.func not in _UNARY:
        raise ValueError(f"{expression.func} of time")
    return _UNARY[expression.func](parts[0])
