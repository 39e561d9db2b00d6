"""Platforms on legs, from points: what tests of assembly modes hold against numbers of others."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import sympy

from symscrew import Mechanism, MechanismBuilder

DATA = Path(__file__).parent.parent / "data" / "assembly_modes"
SHIFT = ("0.31", "-0.17", "1.13")  # of the platform in the reference: no leg has length zero there, none is vertical


def published(name: str) -> dict[str, Any]:
    return dict(json.loads((DATA / f"{name}.json").read_text()))


def exact(values: Sequence[Any]) -> list[sympy.Expr]:
    return [sympy.Rational(str(Fraction(str(v)))) for v in values]


def hexapod(
    base: Sequence[Any], platform: Sequence[Any], shift: Sequence[Any] = SHIFT, name: str = "hexapod"
) -> Mechanism:
    """UPS legs from base points to platform points, which are given in the platform's axes; slides count lengths."""
    builder = MechanismBuilder(name, ground="base", platform="platform")
    builder.body("platform")
    move = exact(shift)
    for k, (given, tip) in enumerate(zip(base, platform, strict=True), start=1):
        a = exact(given)
        b = [c + d for c, d in zip(exact(tip), move, strict=True)]
        leg = sympy.Matrix(b) - sympy.Matrix(a)
        across = sympy.Matrix([-leg[1], leg[0], 0])
        first, second = across / sympy.sqrt(across.dot(across)), leg.cross(across)
        second = second / sympy.sqrt(second.dot(second))
        length = sympy.sqrt(leg.dot(leg))
        builder.body(f"lower{k}")
        builder.body(f"upper{k}")
        builder.joint(f"U{k}", "U", parent="base", child=f"lower{k}", point=a, axes=[list(first), list(second)])
        builder.joint(f"leg{k}", "P", parent=f"lower{k}", child=f"upper{k}", point=a, axes=[list(leg / length)],
                      driven=True, reference=[length])  # fmt: skip
        builder.joint(f"S{k}", "S", parent=f"upper{k}", child="platform", point=b)
    return builder.build()


def planar_3rpr(base: Sequence[Any], platform: Sequence[Any], shift: Sequence[Any] = ("0.3", "1.1")) -> Mechanism:
    """RPR legs in the x-y plane; slides count lengths."""
    builder = MechanismBuilder("planar_3rpr", ground="base", platform="platform")
    builder.body("platform")
    move = exact(shift)
    for k, (given, tip) in enumerate(zip(base, platform, strict=True), start=1):
        a = [*exact(given), sympy.Integer(0)]
        b = [*(c + d for c, d in zip(exact(tip), move, strict=True)), sympy.Integer(0)]
        leg = sympy.Matrix(b) - sympy.Matrix(a)
        length = sympy.sqrt(leg.dot(leg))
        builder.body(f"lower{k}")
        builder.body(f"upper{k}")
        builder.joint(f"R{k}", "R", parent="base", child=f"lower{k}", point=a, axes=[[0, 0, 1]])
        builder.joint(f"leg{k}", "P", parent=f"lower{k}", child=f"upper{k}", point=a, axes=[list(leg / length)],
                      driven=True, reference=[length])  # fmt: skip
        builder.joint(f"T{k}", "R", parent=f"upper{k}", child="platform", point=b, axes=[[0, 0, 1]])
    return builder.build()


def lengths(values: Sequence[Any]) -> dict[str, Any]:
    """Values of the legs' slides."""
    return {f"leg{k}": value for k, value in enumerate(values, start=1)}


def three_rps(corners: Sequence[Any], tips: Sequence[Any], height: Any) -> Mechanism:
    """RPS legs from corners [x, y] of the base, hinges across their directions, to tips [x, y] at a height."""
    builder = MechanismBuilder("three_rps", ground="base", platform="platform")
    builder.body("platform")
    for k, (corner, tip) in enumerate(zip(corners, tips, strict=True), start=1):
        a, b = [*exact(corner), sympy.Integer(0)], [*exact(tip), *exact([height])]
        leg = sympy.Matrix(b) - sympy.Matrix(a)
        across = sympy.Matrix([-leg[1], leg[0], 0])
        length = sympy.sqrt(leg.dot(leg))
        builder.body(f"lower{k}")
        builder.body(f"upper{k}")
        builder.joint(
            f"R{k}",
            "R",
            parent="base",
            child=f"lower{k}",
            point=a,
            axes=[list(across / sympy.sqrt(across.dot(across)))],
        )
        builder.joint(f"leg{k}", "P", parent=f"lower{k}", child=f"upper{k}", point=a, axes=[list(leg / length)],
                      driven=True, reference=[length])  # fmt: skip
        builder.joint(f"S{k}", "S", parent=f"upper{k}", child="platform", point=b)
    return builder.build()
