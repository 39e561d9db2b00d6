"""Numbers that code of type double can work with, looked at when a description is read.

Exact expressions have no largest and no smallest number; products of what they stand for do once they are doubles.
"""

from __future__ import annotations

import sympy

from symscrew.description.expressions import numeric
from symscrew.errors import DescriptionError, shorten

# A mass times two lengths is a moment of inertia, and elimination squares it: products of three numbers within these
# bounds are doubles (up to 1.8e308, from 2.2e-308 on with all digits), those of numbers beyond may be none. What is
# zero, but is an expression of which that cannot be seen (sin(1)^2 + cos(1)^2 - 1), has a value far below.
LARGEST, SMALLEST = sympy.Integer(10) ** 100, sympy.Integer(10) ** -100


def check_range(expression: sympy.Expr, where: str) -> None:
    """Refuse what is not finite, or no double once it is multiplied, or zero and not seen to be.

    Raises:
        DescriptionError: says what was expected, with the value.
    """
    value = numeric(expression, where=where)
    if value != 0 and not SMALLEST <= abs(value) <= LARGEST:
        raise DescriptionError(
            f"{where}: expected 0, or a size from 1e-100 to 1e100, beyond which products are too large or too small, "
            f"got {shorten(str(expression))} = {sympy.N(value, 6)}; write 0 where it is zero, or use other units"
        )
