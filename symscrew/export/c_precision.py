"""The floating-point type of generated C: its name, constants and functions, and the thresholds that suit it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from symscrew.export.listing import decimal

TABLE = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "neg": "-{0}",
    "reciprocal": "ONE / {0}",
    "div": "{0} / {1}",
    "sqrt": "SQRT({0})",
    "exp": "EXP({0})",
    "sin": "SIN({0})",
    "cos": "COS({0})",
    "tan": "TAN({0})",
    "atan2": "ATAN2({0}, {1})",
    "abs": "FABS({0})",
    "less": "{0} < {1} ? ONE : ZERO",
    "select": "{0} != ZERO ? {1} : {2}",
}
FUNCTIONS = ("sqrt", "exp", "sin", "cos", "tan", "atan2", "fabs")


@dataclass(frozen=True)
class Precision:
    """A type of C. `suffix` ends its constants and functions of math.h; `digits` is the part of the digits of
    double that it has; `group` sines are taken at once by the vector function `_ZGVdN<group>v_sin<suffix>`."""

    name: str
    real: str
    suffix: str
    group: int
    digits: float

    @property
    def size(self) -> int:
        """Bytes of a number."""
        return 32 // self.group

    @property
    def integer(self) -> str:
        """The type of a whole number of as many bytes, of which masks are made."""
        return "int" if self.suffix else "long long"

    def vector_root(self, vector: str, width: int | str) -> list[str]:
        """The definition of `<vector>_sqrt`, square roots of a vector type."""
        return [
            f"static inline {vector} {vector}_sqrt({vector} x)",
            "{",
            f"    {vector} root = x;",
            f"    for (int k = 0; k < {width}; ++k) {{",
            f"        root[k] = {self.function('sqrt')}(x[k]);",
            "    }",
            "    return root;",
            "}",
        ]

    @cached_property
    def table(self) -> Mapping[str, str]:
        """Operation to format string."""
        words = {name.upper(): f"{name}{self.suffix}" for name in FUNCTIONS}
        words |= {"ONE": f"1.0{self.suffix}", "ZERO": f"0.0{self.suffix}"}
        found = {}
        for op, text in TABLE.items():
            for word, meaning in words.items():
                text = text.replace(word, meaning) if word != "TAN" or op == "tan" else text
            found[op] = text
        return found

    @cached_property
    def body_table(self) -> Mapping[str, str]:
        """The same in bodies of any width: roots and what has no sign in C by macros."""
        macros = {"sqrt": "SQRT({0})", "abs": "ABS({0})", "less": "LESS({0}, {1})", "select": "SELECT({0}, {1}, {2})"}
        return {**self.table, **macros}

    def number(self, value: float) -> str:
        """The shortest decimal that reads back as `value` in this type, negative ones in parentheses."""
        if not self.suffix or not math.isfinite(value):
            return decimal(value)
        with np.errstate(over="ignore"):
            rounded = np.float32(value)
        if not np.isfinite(rounded):
            raise ValueError(f"a constant of the program is {value}: too large for {self.real}; use double precision")
        text = decimal(float(str(rounded)))
        return f"{text[:-1]}{self.suffix})" if text.endswith(")") else f"{text}{self.suffix}"

    def threshold(self, value: float) -> str:
        """A bound on rounding errors or pivots: the same part of the digits as `value` is of those of double."""
        return self.number(value**self.digits if value else value)

    def function(self, name: str) -> str:
        """The name in math.h."""
        return f"{name}{self.suffix}"


DOUBLE = Precision("double", "double", "", 4, 1.0)
SINGLE = Precision("single", "float", "f", 8, 7.2 / 16)
PRECISIONS = {p.name: p for p in (DOUBLE, SINGLE)}
