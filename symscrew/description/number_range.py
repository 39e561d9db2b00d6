"""Numbers that code of type double can work with, looked at when a description is read.

Exact expressions have no largest and no smallest number; products of what they stand for do once they are doubles.
"""

from __future__ import annotations

import sympy

from symscrew.description.expressions import numeric
from symscrew.errors import DescriptionError, shorten

# A mass times two lengths is a moment of inertia, and elimination squares it: products of three numbers within these
# bounds are doubles (up to 1.8e308, from 2.2e-308 on with all digits), those of numbers beyond may be none. What is
# zero, but is an expression of which that cannot be seen (sin(1)^2 + cos(1)^2 - 1), has a value far below. Of roots and
# fractions it can be seen later, over the field that they generate: they may be zero in any form.
DIGITS = 400  # with so many a zero has no value above 1e-300, and a number above that has its own
LARGEST, SMALLEST = sympy.Integer(10) ** 100, sympy.Integer(10) ** -100
ORDINARY = 300  # powers of two around 1, 1e90: nothing more is asked of such a size


def check_range(expression: sympy.Expr, where: str) -> None:
    """Refuse what is not finite, or no double once it is multiplied, or zero and not seen to be.

    Raises:
        DescriptionError: says what was expected, with the value.
    """
    value = numeric(expression, where=where)
    if abs(_power_of_two(value)) < ORDINARY:
        return
    cancels = abs(value) < SMALLEST and expression.is_algebraic and expression.has(sympy.Add)
    hidden_zero = cancels and abs(sympy.N(expression, DIGITS)) < SMALLEST**3
    if value != 0 and not hidden_zero and not SMALLEST <= abs(value) <= LARGEST:
        raise DescriptionError(
            f"{where}: expected 0, or a size from 1e-100 to 1e100, beyond which products are too large or too small, "
            f"got {shorten(str(expression))} = {sympy.N(value, 6)}; write 0 where it is zero, or use other units"
        )


def _power_of_two(value: sympy.Float | sympy.Integer) -> int:
    """The least power of two above a size, beside a double's range where there is none: of 0."""
    if value.is_Integer:
        return int(value).bit_length() or 2 * ORDINARY
    _, mantissa, exponent, bits = value._mpf_
    return int(exponent + bits) if mantissa else 2 * ORDINARY
