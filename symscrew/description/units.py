"""Units that a description may use: read into SI, so that what it says is what is computed.

"mm" --> factor 1/1000, "m";    "N mm/deg" --> factor 9/(50 pi), "N m/rad";    "furlong" --> an error
"""

from __future__ import annotations

import re

import sympy

from symscrew.errors import DescriptionError, did_you_mean, shorten

SI = ("1", "m", "kg", "s", "rad", "N", "J", "W", "Pa", "Hz", "A", "V", "K", "Ohm", "ohm", "H", "F", "C", "T", "Wb")

OTHERS: dict[str, tuple[sympy.Expr, str]] = {
    "um": (sympy.Rational(1, 10**6), "m"),
    "mm": (sympy.Rational(1, 1000), "m"),
    "cm": (sympy.Rational(1, 100), "m"),
    "km": (sympy.Integer(1000), "m"),
    "in": (sympy.Rational(254, 10**4), "m"),
    "inch": (sympy.Rational(254, 10**4), "m"),
    "ft": (sympy.Rational(3048, 10**4), "m"),
    "mg": (sympy.Rational(1, 10**6), "kg"),
    "g": (sympy.Rational(1, 1000), "kg"),
    "t": (sympy.Integer(1000), "kg"),
    "lb": (sympy.Rational(45359237, 10**8), "kg"),
    "deg": (sympy.pi / 180, "rad"),
    "mrad": (sympy.Rational(1, 1000), "rad"),
    "rev": (2 * sympy.pi, "rad"),
    "us": (sympy.Rational(1, 10**6), "s"),
    "ms": (sympy.Rational(1, 1000), "s"),
    "min": (sympy.Integer(60), "s"),
    "h": (sympy.Integer(3600), "s"),
    "rpm": (sympy.pi / 30, "rad/s"),
    "mN": (sympy.Rational(1, 1000), "N"),
    "kN": (sympy.Integer(1000), "N"),
    "Nm": (sympy.Integer(1), "N m"),
    "Nmm": (sympy.Rational(1, 1000), "N m"),
    "bar": (sympy.Integer(10**5), "Pa"),
    "kPa": (sympy.Integer(10**3), "Pa"),
    "MPa": (sympy.Integer(10**6), "Pa"),
    "GPa": (sympy.Integer(10**9), "Pa"),
    "kW": (sympy.Integer(1000), "W"),
    "kHz": (sympy.Integer(1000), "Hz"),
    "mA": (sympy.Rational(1, 1000), "A"),
    "mH": (sympy.Rational(1, 1000), "H"),
    "%": (sympy.Rational(1, 100), "1"),
}
"""Unit -> what one of it is in SI."""

_PART = re.compile(r"(?P<unit>%|1|[A-Za-z]+)(?:(?:\^|\*\*)?(?P<power>-?[1-9]))?")


def in_si(unit: str, where: str) -> tuple[sympy.Expr, str]:
    """The factor to SI units, exact, and the unit there: a product of units with powers, over at most one more.

    Raises:
        DescriptionError: a unit that is not known, or no unit at all; begins with `where`.

    >>> in_si("kg mm^2", "inertia")
    (1/1000000, 'kg m^2')
    """
    above, *below = re.sub(r"[()]", "", unit).strip().split("/")
    if len(below) > 1 or not all(part.strip() for part in (above, *below)):
        raise DescriptionError(f"{where}: expected a unit such as 'm', 'kg m^2' or 'N s/m', got {shorten(unit)}")
    factor, texts = sympy.Integer(1), []
    for sign, product in ((1, above), (-1, "".join(below))):
        words = []
        for word in re.split(r"[\s*·]+(?!\*)", product.strip()):
            scale, text = _one(word, where, unit) if word else (sympy.Integer(1), "")
            factor *= scale**sign
            words += [text] if text else []
        texts.append(" ".join(words))
    if not any(name in OTHERS for name in re.findall(r"[A-Za-z%]+", unit)):
        return factor, unit  # as it was written
    return factor, "/".join(text for text in texts if text)


def _one(word: str, where: str, unit: str) -> tuple[sympy.Expr, str]:
    """One unit, perhaps to a power."""
    found = _PART.fullmatch(word)
    name = found["unit"] if found else word
    if found is None or not (name in SI or name in OTHERS):
        near = did_you_mean(name, [*SI, *OTHERS])
        raise DescriptionError(f"{where}: unknown unit {shorten(word)} in {shorten(unit)}; {near}")
    power = int(found["power"] or 1)
    scale, text = OTHERS.get(name, (sympy.Integer(1), name))
    if power != 1 and re.search("[ /]", text):
        raise DescriptionError(f"{where}: {shorten(word)} is no single unit; write its power in SI units")
    return scale**power, text if power == 1 else f"{text}^{power}"
