"""Values as people type them for a coordinate or a parameter: a number or an expression, with a unit or without.

"10mm" --> 1/100, "m";    "30deg" --> pi/6, "rad";    "sqrt(3)/5" --> sqrt(3)/5, "": as the description counts it
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import sympy

from symscrew.description.expressions import exact, numeric
from symscrew.description.mechanism import Parameter
from symscrew.description.units import OTHERS, SI, in_si
from symscrew.errors import DescriptionError, shorten

LARGEST_BARE = 3.2
"""A bare number above it [rad], half a turn and a little, is more likely meant in degrees: a notice says so."""

_NUMBER_AND_UNIT = re.compile(
    r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(?![eE][-+]?\d)([A-Za-z%][\w%^/· ]*)", re.ASCII
)
_EXPRESSION_AND_UNIT = re.compile(r"(.*[\w.)])\s+([A-Za-z%]+)", re.ASCII)


@dataclass(frozen=True)
class GivenValue:
    """A value in SI units, exact, and the SI unit that it was given in; "" where none was."""

    value: sympy.Expr
    unit: str = ""

    def measured_in(self, unit: str, where: str) -> sympy.Expr:
        """The value of a quantity of this unit.

        Raises:
            DescriptionError: it was given in another one; begins with `where`.
        """
        if self.unit and self.unit != unit:
            wanted = {"m": "a length [m, mm]", "rad": "an angle [rad, deg]", "1": "a number without unit"}
            raise DescriptionError(
                f"{where}: expected {wanted.get(unit, f'a value in {unit}')}, got one in {self.unit}"
            )
        if self.value.is_number:  # acos(2) is none that is real
            numeric(self.value, where=where)
        return self.value

    def notice(self, unit: str, where: str) -> str:
        """What is said of an angle without unit that is more than half a turn; else nothing."""
        if unit != "rad" or self.unit or not self.value.is_number or not abs(self.value) > LARGEST_BARE:
            return ""
        number = float(self.value)
        said = f"{where} is in rad: {number:g} are {number * 180 / float(sympy.pi):.0f} degrees"
        return f"{said}; {number:g}deg are {number:g} degrees"


def given_value(value: object, names: Mapping[str, sympy.Expr] | None = None, *, where: str = "value") -> GivenValue:
    """What was typed; whatever is not text is a value without a unit.

    Raises:
        DescriptionError: neither number nor expression, or a unit that is not known; begins with `where`.

    >>> given_value("-50 mm"), given_value("pi/6 rad").unit
    (GivenValue(value=-1/20, unit='m'), 'rad')
    """
    if not isinstance(value, str):
        return GivenValue(exact(value, names, where=where))
    text = value.strip()
    found = _NUMBER_AND_UNIT.fullmatch(text)
    if found is None:
        found = _EXPRESSION_AND_UNIT.fullmatch(text)
        if found is None or found[2] not in (*SI, *OTHERS):
            return GivenValue(exact(text, names, where=where))
    if found[2] in (names or {}):
        raise DescriptionError(f"{where}: {shorten(text)} is no expression; write a product with *")
    factor, unit = in_si(found[2].strip(), where)
    return GivenValue(exact(found[1], names, where=where) * factor, unit)


def parameter_units(parameters: Mapping[str, Parameter], given: object) -> dict[str, str]:
    """Units of the parameters, in which a file's table of values `given` in place of the description's counts.

    Raises:
        DescriptionError: a number without a unit where the description counts in another one than SI's: 200 beside a
            description's 150 mm.
    """
    for name, value in given.items() if isinstance(given, Mapping) else ():
        unit = parameters[name].given_in if name in parameters else ""
        if unit and _bare(value):
            shown = shorten(value)[1:-1] if isinstance(value, str) else value
            raise DescriptionError(
                f"parameters.{name}: expected a number with its unit, as the description counts in {unit}: "
                f"'{shown} {unit}', or one in {parameters[name].unit}; got {shorten(value)}"
            )
    return {name: parameter.unit for name, parameter in parameters.items()}


def _bare(value: object) -> bool:
    """Whether it is a number other than 0 by itself, no expression of others, which have their units."""
    try:
        return bool(exact(value) != 0)
    except DescriptionError:
        return False
