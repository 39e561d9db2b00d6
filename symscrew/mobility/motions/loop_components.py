"""Components of the configuration space of four-bar loops, planar and spherical: exact and complete over the field.

    loop of four hinges --half-angle tangents t, s of the two at the ground--> P(t, s) = 0 --factors--> Components

The coupler keeps its length (planar loops), or the angle between its axes (spherical ones), which is one equation of
degree 2 in each of the tangents; the other two angles follow from t and s. So the irreducible factors over the numbers
of the description are the components there, those with a hinge that stays half a turn off as degrees that are missing.
(K. H. Hunt, Kinematic Geometry of Mechanisms, 1978; J. M. McCarthy, Geometric Design of Linkages, 2000.)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy

from symscrew.algebra import cross, dot, scale, subtract
from symscrew.description import Mechanism
from symscrew.mobility.joint_network import Network
from symscrew.mobility.symbols import Exact, NotDecidableError, exact_system

T, S = sympy.symbols("t s", real=True)
"""Tangents of half the angles of the first and the last hinge from the reference, over the lengths of their axes."""
FULL = 2
"""Degree of the equation in each tangent, with its components at infinity."""
Exacts = tuple[Exact, Exact, Exact]


@dataclass(frozen=True)
class Component:
    """One component: a curve, irreducible over the rational numbers; of its points some may be complex only.

    `degrees`: in the half-angle tangents of the two hinges; `equation`: in t and s, or that a hinge is half a turn off;
    `through`: whether the reference is on it; `multiplicity`: more than 1 where the linkage is shaky all along it.
    """

    degrees: tuple[int, int]
    equation: str
    through: bool
    multiplicity: int


@dataclass(frozen=True)
class Components:
    """All components of the configuration space, of dimension 1; `hinges`: whose angles t and s are."""

    hinges: tuple[str, str]
    curves: tuple[Component, ...]


def components_of(mechanism: Mechanism, network: Network) -> Components | str:
    """The components of a planar or spherical four-bar over the rational numbers, or why they are not decided."""
    if len(network.chords) != 1 or len(network.edges) != 4:
        return "not decided: only loops of four hinges are decomposed, by factors of one equation"
    if any(len(e.motions) != 1 or not e.motions[0][0].revolute for e in network.edges.values()):
        return "not decided: only hinges are decomposed, by factors of one equation"
    if network.ties:
        return "not decided: couplings of coordinates are not among the equations"
    try:
        system = exact_system(mechanism)
        names = [name for name, _ in network.loops()[0]]
        first = next(k for k, n in enumerate(names) if network.ground in _ends(network, n)
                     and network.ground in _ends(network, names[k - 1]))  # fmt: skip
        names = names[first:] + names[:first]
        if system.field.degree > 1:
            return f"not decided: factors are looked for over the rational numbers, not over {system.field}"
        axes = [_vector(system.screws[n][0][:3]) for n in names]
        points = [_vector([system.field.read(mechanism.number(c)) for c in mechanism.joints[n].point]) for n in names]
    except NotDecidableError as error:
        return f"not decided: {error}"
    if all(not any(cross(axes[0], a)) for a in axes):
        if not any(cross(subtract(points[2], points[1]), axes[0])):
            return "not decided: the coupler has no length"
        return _factored((names[0], names[3]), _planar(axes[0], points))
    centre = _centre(axes, points)
    if centre is None:
        return "not decided: the axes are neither parallel nor through one point"
    if not any(cross(axes[1], axes[2])):
        return "not decided: the axes of the coupler coincide"
    return _factored((names[0], names[3]), _spherical(axes))


def _ends(network: Network, name: str) -> tuple[str, str]:
    return network.edges[name].parent, network.edges[name].child


def _vector(values: Sequence[Exact]) -> Exacts:
    x, y, z = (Fraction(c) for c in values)
    return x, y, z


def _centre(axes: Sequence[Exacts], points: Sequence[Exacts]) -> Exacts | None:
    """The point in which all axes meet, or None."""
    n = cross(axes[0], axes[1])
    if not any(n):
        return None
    gap = subtract(points[1], points[0])
    along = dot(cross(gap, axes[1]), n) / dot(n, n)
    x, y, z = (p + along * a for p, a in zip(points[0], axes[0], strict=True))
    meets = all(not any(cross(subtract(p, (x, y, z)), a)) for p, a in zip(points, axes, strict=True))
    return (x, y, z) if meets else None


def _turned(axis: Exacts, vector: Exacts, tangent: sympy.Symbol) -> list[sympy.Expr]:
    """The vector turned about the axis, times 1 + tangent^2 axis^2: by the quaternion (1, tangent axis)."""
    square, along = dot(axis, axis), dot(axis, vector)
    across = cross(axis, vector)
    return [
        (1 - tangent**2 * _sympy(square)) * _sympy(v)
        + 2 * tangent * _sympy(c)
        + 2 * tangent**2 * _sympy(along) * _sympy(a)
        for v, c, a in zip(vector, across, axis, strict=True)
    ]


def _sympy(number: Exact) -> sympy.Rational:
    return sympy.Rational(number.numerator, number.denominator)


def _planar(axis: Exacts, points: Sequence[Exacts]) -> sympy.Poly:
    """|C - B|^2 across the axis is kept, B on the crank and C on the rocker."""
    square = dot(axis, axis)
    flat = [subtract(p, scale(dot(p, axis) / square, axis)) for p in points]
    one, two = (1 + tangent**2 * _sympy(square) for tangent in (T, S))
    b = _turned(axis, subtract(flat[1], flat[0]), T)
    c = _turned(axis, subtract(flat[2], flat[3]), S)
    base, rod = subtract(flat[3], flat[0]), subtract(flat[2], flat[1])
    gap = [x * two - y * one - _sympy(z) * one * two for x, y, z in zip(b, c, base, strict=True)]
    whole = sympy.Poly(sum(g**2 for g in gap) - _sympy(dot(rod, rod)) * (one * two) ** 2, T, S)
    return whole.quo(sympy.Poly(one * two, T, S))


def _spherical(axes: Sequence[Exacts]) -> sympy.Poly:
    """The angle between the axes of the coupler is kept."""
    one, two = (1 + t**2 * _sympy(dot(a, a)) for t, a in ((T, axes[0]), (S, axes[3])))
    b, c = _turned(axes[0], axes[1], T), _turned(axes[3], axes[2], S)
    product = sum(x * y for x, y in zip(b, c, strict=True))
    return sympy.Poly(product - _sympy(dot(axes[1], axes[2])) * one * two, T, S)


def _factored(hinges: tuple[str, str], equation: sympy.Poly) -> Components | str:
    if equation.is_zero:
        return "not decided: the equation of the loop says nothing"
    found = []
    for factor, multiplicity in equation.factor_list()[1]:
        degrees = (factor.degree(T), factor.degree(S))
        through = factor.coeff_monomial(1) == 0
        found.append(Component(degrees, f"{factor.as_expr()} = 0", bool(through), multiplicity))
    for symbol, hinge, degrees in ((T, hinges[0], (1, 0)), (S, hinges[1], (0, 1))):
        missing = FULL - equation.degree(symbol)
        if missing:
            found.append(Component(degrees, f"{hinge} half a turn from the reference", False, missing))
    return Components(hinges, tuple(found))


def component_lines(found: Components | str) -> list[str]:
    """The components in words, a line each."""
    if isinstance(found, str):
        return [found]
    count = len(found.curves)
    lines = [
        f"{count} component{'s' * (count > 1)} of dimension 1, all of them (proved: irreducible factors over the "
        f"rational numbers); t, s: multiples of the tangents of half the angles of "
        f"{found.hinges[0]}, {found.hinges[1]} (one over the length of a rational vector along the axis)"
    ]
    for curve in found.curves:
        where = "through the reference" if curve.through else "elsewhere"
        shaky = f", {curve.multiplicity}-fold: shaky all along" if curve.multiplicity > 1 else ""
        lines.append(f"degrees {curve.degrees[0]}, {curve.degrees[1]}, {where}{shaky}: {curve.equation}")
    lines.append("which assembly modes are connected without a singularity: not decided")
    return lines


def component_values(found: Components | str) -> dict[str, Any]:
    """The same as JSON values."""
    if isinstance(found, str):
        return {"decided": False, "why": found}
    curves = [
        {"dimension": 1, "degrees": list(c.degrees), "equation": c.equation, "through_reference": c.through,
         "multiplicity": c.multiplicity}
        for c in found.curves
    ]  # fmt: skip
    return {"decided": True, "hinges": list(found.hinges), "components": curves, "assembly_modes": "not decided"}
