"""Three spheres whose centres lie nearly on a line, in C: no mode is lost without a word, as rational numbers say."""

from __future__ import annotations

from fractions import Fraction

import pytest

from symscrew import Mechanism, MechanismBuilder
from symscrew.assembly import compiled_modes, modes_model, print_modes

OK, INCOMPLETE = 0, 100
GAP = Fraction(1, 10**7)
"""Distance of the third carriage from the line of the other two [m]."""
CARRIAGES = [("0.013", "0.1", "0"), ("1.037", "0.2", "0"), ("2.085", Fraction("0.1") + Fraction(518, 2560) + GAP, "0")]
PLATFORM = ("1.0123", "0.7345", "0.3")
BARS = [("1", "0", "0"), ("3/5", "4/5", "0"), ("-5/13", "12/13", "0")]
TOWARDS = (Fraction(-7, 10**8), Fraction(7, 10**9), Fraction(-6, 10**8))
"""Drives along which the two places of the platform meet."""


def numbers(values) -> list[Fraction]:
    return [Fraction(x) for x in values]


def cross(a, b) -> list[Fraction]:
    return [a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)]


def dot(a, b) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def text(values) -> list[str]:
    return [str(x) for x in values]


def linear_delta() -> Mechanism:
    """Carriages that slide along x, each with two rods 0.2 apart to the platform."""
    builder = MechanismBuilder("linear_delta", platform="platform")
    builder.body("platform")
    for k, (given, bar) in enumerate(zip(CARRIAGES, BARS, strict=True)):
        start, along = numbers(given), numbers(bar)
        builder.body(f"carriage{k}")
        builder.joint(f"A{k}", "P", parent="base", child=f"carriage{k}", point=text(start), axes=[["1", "0", "0"]],
                      driven=True)  # fmt: skip
        for side in (-1, 1):
            one, two = ([a + b * Fraction(side, 10) for a, b in zip(p, along, strict=True)]
                        for p in (start, numbers(PLATFORM)))  # fmt: skip
            across = cross([b - a for a, b in zip(one, two, strict=True)], along)
            second = [f"({c})/sqrt({dot(across, across)})" for c in across]
            rod = f"rod{k}{'ab'[side > 0]}"
            builder.body(rod)
            builder.joint(f"U{rod}", "U", parent=f"carriage{k}", child=rod, point=text(one), axes=[text(along), second])
            builder.joint(f"S{rod}", "S", parent=rod, child="platform", point=text(two))
    return builder.build()


def apart(drives) -> Fraction:
    """Squared, half of how far the two places of the platform are apart; negative: there is none."""
    centres = [numbers(c) for c in CARRIAGES]
    squares = [dot(v, v) for v in ([p - c for p, c in zip(numbers(PLATFORM), c, strict=True)] for c in centres)]
    for centre, drive in zip(centres, drives, strict=True):
        centre[0] += Fraction(drive)
    one, two = ([a - b for a, b in zip(c, centres[0], strict=True)] for c in centres[1:])
    p = (squares[0] - squares[1] + dot(one, one)) / 2
    q = (squares[0] - squares[2] + dot(two, two)) / 2
    n = cross(one, two)
    w = [p * b - q * a for a, b in zip(one, two, strict=True)]
    return squares[0] - dot(w, w) / dot(n, n)


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    model, folder = modes_model(linear_delta()), tmp_path_factory.mktemp("line")
    for file, lines in print_modes(model).items():
        (folder / file).write_text(lines)
    return compiled_modes(model, folder, ["-O0"])


def test_places_that_meet_are_two_or_none_or_not_told(compiled):
    low, high = Fraction(0), Fraction(100)
    assert apart([0, 0, 0]) > 0 > apart([high * x for x in TOWARDS])
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if apart([middle * x for x in TOWARDS]) > 0 else (low, middle)
    seen = set()
    for digits in range(15):
        for side in (-1, 1):
            for off in (1, 2, 3, 5, 7):
                drives = [float(x * low * (1 + side * Fraction(off, 10 ** (digits + 1)))) for x in TOWARDS]
                status, modes = compiled.level(drives)
                assert (status, len(modes)) == (OK, 2 if apart(drives) > 0 else 0) or status == INCOMPLETE
                seen.add((status, len(modes)))
    assert seen >= {(OK, 2), (OK, 0), (INCOMPLETE, 0)}
