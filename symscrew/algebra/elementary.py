"""Sine, cosine, tangent, exponential and arc tangent of NumPy arrays with the same bits on every machine.

NumPy takes these from the C library or from vector code of the processor, whose last digits differ. Here each is a
fixed sequence of IEEE additions, multiplications, divisions and roundings, which are the same everywhere: the
argument reductions and polynomials of fdlibm (K. C. Ng, Sun Microsystems 1993). Errors are below 1 unit in the last
place (tangent and arc tangent of two numbers: 2).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np

EXACT = mpmath.ctx_mp.MPContext()
EXACT.dps = 400  # reduces the largest double, 1.8e308, by multiples of pi to 90 digits
# The parts of pi/2 below are exact in their products up to 2^20 quarter turns; larger angles are reduced in many digits
LARGEST = 2.0**19
# Arrays up to this size are faster number by number: one costs 3 us, the array operations 37 us whatever its size
FEW = 8
# pi/2 in four parts of 33 bits each but the last
HALF_PI = (1.57079632673412561417, 6.07710050630396597660e-11, 2.02226624871116645580e-21, 8.47842766036889956997e-32)
TURNS = 2.0 / np.pi  # quarter turns of a radian
# coefficients of fdlibm's polynomials, lowest power first: of x + x^3 (...)
SINE = (
    -1.66666666666666324348e-01,
    8.33333333332248946124e-03,
    -1.98412698298579493134e-04,
    2.75573137070700676789e-06,
    -2.50507602534068634195e-08,
    1.58969099521155010221e-10,
)
# of 1 - x^2/2 + x^4 (...)
COSINE = (
    4.16666666666666019037e-02,
    -1.38888888888741095749e-03,
    2.48015872894767294178e-05,
    -2.75573143513906633035e-07,
    2.08757232129817482790e-09,
    -1.13596475577881948265e-11,
)
# ln 2 in two parts, the first of 32 bits
LOG_2 = (6.93147180369123816490e-01, 1.90821492927058770002e-10)
BEYOND = 1000.0  # exp of more overflows, of less than minus that is 0: so are those of these ends
# of x - x^2 (...) on [0, ln(2)/2]
EXPONENTIAL = (
    1.66666666666666019037e-01,
    -2.77777777770155933842e-03,
    6.61375632143793436117e-05,
    -1.65339022054652515390e-06,
    4.13813679705723846039e-08,
)
# of 1/3 - x^2/5 ..., up to x = 7/16
ARC_TANGENT = (
    3.33333333333329318027e-01,
    -1.99999999998764832476e-01,
    1.42857142725034663711e-01,
    -1.11111104054623557880e-01,
    9.09088713343650656196e-02,
    -7.69187620504482999495e-02,
    6.66107313738753120669e-02,
    -5.83357013379057348645e-02,
    4.97687799461593236017e-02,
    -3.65315727442169155270e-02,
    1.62858201153657823623e-02,
)
# from which argument on, what is subtracted (1 without end), and its arc tangent in two parts
BREAKS = (
    (0.4375, 0.5, 4.63647609000806093515e-01, 2.26987774529616870924e-17),
    (0.6875, 1.0, 7.85398163397448278999e-01, 3.06161699786838301793e-17),
    (1.1875, 1.5, 9.82793723247329054082e-01, 1.39033110312309984516e-17),
    (2.4375, np.inf, 1.57079632679489655800e00, 6.12323399573676603587e-17),
)


def sin(x: Any) -> Any:
    """Sine of an array or a number [rad]."""
    value = _circular(x, 0, "sin")
    return value if np.ndim(x) == 0 and x != 0.0 else np.where(np.equal(x, 0.0), x, value)[()]  # with the sign of zero


def cos(x: Any) -> Any:
    """Cosine of an array or a number [rad]."""
    return _circular(x, 1, "cos")


def tan(x: Any) -> Any:
    """Tangent of an array or a number [rad]."""
    return sin(x) / cos(x)


def exp(x: Any) -> Any:
    """Exponential of an array or a number."""
    x = np.asarray(x, dtype=float)[()]
    bounded = np.clip(x, -BEYOND, BEYOND)
    count = np.rint(bounded / (LOG_2[0] + LOG_2[1]))
    high, low = bounded - count * LOG_2[0], count * LOG_2[1]
    rest = high - low
    square = rest * rest
    c = rest - square * _polynomial(square, EXPONENTIAL)
    part = 1.0 - ((low - (rest * c) / (2.0 - c)) - high)
    return np.ldexp(part, np.nan_to_num(count).astype(int))


def arctan2(y: Any, x: Any) -> Any:
    """The angle of the point (x, y) [rad], from -pi to pi."""
    pi, pi_low = 2.0 * BREAKS[-1][2], 2.0 * BREAKS[-1][3]
    if np.ndim(x) == np.ndim(y) == 0 and x and y and math.isfinite(x) and math.isfinite(y):  # as in `_circular`
        angle = _arc_tangent_of_number(abs(float(y) / float(x)))
        return np.float64(math.copysign(pi - (angle - pi_low) if x < 0.0 else angle, y))
    y, x = np.asarray(y, dtype=float)[()], np.asarray(x, dtype=float)[()]
    plain = np.isfinite(x) & np.isfinite(y) & (x != 0.0) & (y != 0.0)
    if not np.all(plain):  # multiples of pi/4, signs of zero
        return np.where(plain, arctan2(np.where(plain, y, 1.0), np.where(plain, x, 1.0)), np.arctan2(y, x))[()]
    with np.errstate(over="ignore", under="ignore"):
        angle = _arc_tangent(np.abs(y / x))
    return np.copysign(np.where(x < 0.0, pi - (angle - pi_low), angle), y)[()]


def _circular(x: Any, shift: int, name: str) -> Any:
    """Sine of x + shift pi/2."""
    if np.ndim(x) == 0 and abs(x) <= LARGEST:  # the same with plain numbers, which is ten times as fast
        turns = round(float(x) * TURNS)
        value = _kernels(float(x), float(turns))[(turns + shift) % 2]
        return np.float64(-value if (turns + shift) % 4 >= 2 else value)
    x = np.asarray(x, dtype=float)[()]
    finite = np.isfinite(x)
    large = (np.abs(x) > LARGEST) & finite
    if 0 < np.size(x) <= FEW and np.ndim(x) and finite.all() and not large.any():
        return np.array([_circular(value, shift, name) for value in x.ravel().tolist()]).reshape(x.shape)
    if np.any(large):
        exact = np.frompyfunc(lambda value: float(getattr(EXACT, name)(float(value))), 1, 1)
        chosen = np.where(large, x, 0.0)
        return np.where(large, exact(chosen), _circular(np.where(large, np.nan, x), shift, name)).astype(float)[()]
    count = np.rint(x * TURNS)
    sine, cosine = _kernels(x, count)
    quarter = count + shift
    quarter = quarter - 4.0 * np.floor(0.25 * quarter)
    value = np.where((quarter == 0.0) | (quarter == 2.0), sine, cosine)
    return value * np.where(quarter >= 2.0, -1.0, 1.0)


def _kernels(x: Any, count: Any) -> tuple[Any, Any]:
    """Sine and cosine of x - count pi/2, which is between -pi/4 and pi/4."""
    rest, low = x - count * HALF_PI[0], -(count * HALF_PI[3])
    for part in HALF_PI[1:3]:
        before, moved = rest, count * part
        rest = before - moved
        low = low + ((before - rest) - moved)
    y = rest + low
    y_low = (rest - y) + low
    square = y * y
    cubic = square * y
    sine = y - ((square * (0.5 * y_low - cubic * _polynomial(square, SINE[1:])) - y_low) - cubic * SINE[0])
    half = 0.5 * square
    top = 1.0 - half
    cosine = top + (((1.0 - top) - half) + (square * (square * _polynomial(square, COSINE)) - y * y_low))
    return sine, cosine


def _arc_tangent(x: Any) -> Any:
    """Arc tangent of positive numbers."""
    place = sum((x >= start).astype(int) if np.ndim(x) else int(x >= start) for start, *_ in BREAKS)
    middle, high, low = (np.array([0.0, *(row[k] for row in BREAKS)])[place] for k in (1, 2, 3))
    last = np.isinf(middle)
    kept = np.where(last, 0.0, middle)
    top, bottom = np.where(last, -1.0, x - kept), np.where(last, x, 1.0 + kept * x)
    return _behind_break(top / bottom, high, low)


def _arc_tangent_of_number(x: float) -> float:
    """The same of a plain number."""
    _, middle, high, low = max((row for row in BREAKS if x >= row[0]), default=(0.0, 0.0, 0.0, 0.0))
    rest = -1.0 / x if middle == np.inf else (x - middle) / (1.0 + middle * x)
    return float(_behind_break(rest, high, low))


def _behind_break(rest: Any, high: Any, low: Any) -> Any:
    """The arc tangent of a break, in two parts, and that of what is left."""
    square = rest * rest
    fourth = square * square
    odd = square * _polynomial(fourth, ARC_TANGENT[0::2]) + fourth * _polynomial(fourth, ARC_TANGENT[1::2])
    return high - ((rest * odd - low) - rest)


def _polynomial(x: Any, coefficients: Sequence[float]) -> Any:
    """c0 + c1 x + c2 x^2 ... by Horner."""
    total = coefficients[-1]
    for c in coefficients[-2::-1]:
        total = c + x * total
    return total
