"""Where the joints of limbs are and how their axes point: proposals for limbs that are given by letters alone.

LimbType --spatial, planar, arm--> Layout: points and axes as formulas of R, r, H, b, l

Limbs stand on a circle of radius R around the base and carry a platform of radius r at height H; limbs of R and
P alone make a planar mechanism in the x-y plane; a single limb makes an arm. A parallelogram opens along the circle.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import sympy

from symscrew.description.joints import JOINT_TYPES, JointType, Triad
from symscrew.description.limb_letters import LimbType

Point: TypeAlias = Any  # a sympy.Matrix of three entries
R, r, H, b, l, w = sympy.symbols("R r H b l w", positive=True)
HALF = sympy.Rational(1, 2)


@dataclass(frozen=True)
class Layout:
    """Where the joints of a limb are, base first, and their axes; an empty list where the axis follows by itself.

    `across`: the direction from one bar of the limb's parallelograms to the other.
    """

    points: tuple[Point, ...]
    axes: tuple[tuple[Point, ...], ...]
    across: Point | None = None


def vector(*entries: object) -> Point:
    """A vector of three entries."""
    return sympy.Matrix(entries)


def frame(angle: sympy.Expr) -> tuple[Point, Point]:
    """Radial and tangential unit vectors at an angle about z."""
    c, s = sympy.cos(angle), sympy.sin(angle)
    return vector(c, s, 0), vector(-s, c, 0)


Z = sympy.Matrix([0, 0, 1])


def kinds_of(letters: str) -> list[JointType]:
    """The joint types of a limb."""
    return [JOINT_TYPES[letter] for letter in letters]


def spatial(types: Sequence[LimbType]) -> list[Layout]:
    """Single joints at the middle, all other limbs on circles; six or more in pairs, as hexapods have them."""
    around = [t for t in types if len(t.letters) > 1]
    count = max(len(around), 1)
    paired = count >= 6 and all(kinds_of(t.letters)[-1].ball for t in around)
    hub = len(around) < len(types)
    result, place = [], 0
    for limb in types:
        if len(limb.letters) == 1:
            result.append(_hub(limb.letters))
            continue
        angle, shift = sympy.pi * 2 * place / count, sympy.Integer(0)
        if hub:
            angle += sympy.pi
        if paired:  # pairs of near points on the base, pairs with the other neighbours on the platform
            shift = sympy.pi / count * (-1) ** place / 2
        result.append(_leg(limb, angle + shift, angle - shift, hub=hub, paired=paired))
        place += 1
    return result


def _hub(letter: str) -> Layout:
    kind, x, y = JOINT_TYPES[letter], vector(1, 0, 0), vector(0, 1, 0)
    axes = {0: (), 1: (y if kind.hinge else Z,), 2: (x, y)}
    return Layout((vector(0, 0, 0),), (axes[kind.axes],))


def _leg(limb: LimbType, base: sympy.Expr, top: sympy.Expr, *, hub: bool, paired: bool) -> Layout:
    """A limb in its radial plane: straight, with elbows outwards, or from a vertical rail."""
    radial, tangential = frame(base)
    letters, kinds = limb.letters, kinds_of(limb.letters)
    rail = kinds[0].slider
    start = R * radial + (H / 3 * Z if rail else 0 * Z)
    end = r * frame(top)[0] + H * Z
    inner = [k for k in range(1, len(kinds) - 1) if not kinds[k].slider]
    inner = inner[1:] if rail and len(inner) and len(letters) > 2 else inner
    placed: dict[int, Point] = {0: R * radial, len(letters) - 1: end}
    if rail and len(letters) > 2:
        first = next((k for k in range(1, len(letters)) if not kinds[k].slider), len(letters) - 1)
        placed.setdefault(first, start)
    for i, k in enumerate(inner, start=1):
        f = sympy.Rational(i, len(inner) + 1)
        placed[k] = start + f * (end - start) + 4 * f * (1 - f) * b * radial
    points = _between(placed, len(letters))
    axes = []
    for k in range(len(letters)):
        along = points[k + 1] - points[k] if k + 1 < len(points) else points[k] - points[k - 1]
        axes.append(_axes(kinds, k, Directions(radial, tangential, along, paired), hub=hub))
    for k in limb.parallelograms:  # opens along the circle, so that its bars stay in planes across the limb's
        axes[k + 1] = axes[k] = (_across(points[k + 1] - points[k], tangential),)
    axes = _behind_parallelograms(limb, axes, tangential)
    return Layout(points, tuple(axes), tangential if limb.parallelograms else None)


def _across(bar: Point, opening: Point) -> Point:
    """The unit axis of a parallelogram's hinges: across its bars and its opening."""
    axis = bar.cross(opening)
    return (axis / sympy.sqrt(sympy.simplify(axis.dot(axis)))).applyfunc(sympy.simplify)


def _behind_parallelograms(
    limb: LimbType, axes: Sequence[tuple[Point, ...]], tangential: Point
) -> list[tuple[Point, ...]]:
    """All other hinges of a limb with parallelograms are parallel: it then keeps its tip from turning otherwise."""
    inside = {j for k in limb.parallelograms for j in (k, k + 1)}
    if not inside:
        return list(axes)
    kinds = kinds_of(limb.letters)
    return [(tangential,) if kinds[k].hinge and k not in inside else axis for k, axis in enumerate(axes)]


@dataclass(frozen=True)
class Directions:
    """Unit vectors at a limb: away from the middle, around it, across the limb in its plane, and along it.

    Those of the limb's line take a second to simplify, and most joints need neither.
    """

    radial: Point
    tangential: Point
    along: Point
    paired: bool

    @property
    def normal(self) -> Point:
        """Across the limb."""
        along, radial = self.along, self.radial
        across = radial if self.paired else (along.dot(Z) * radial - along.dot(radial) * Z) / self._length()
        return across.applyfunc(sympy.simplify)

    @property
    def line(self) -> Point:
        """Along the limb."""
        return (self.along / self._length()).applyfunc(sympy.simplify)

    def _length(self) -> sympy.Expr:
        return sympy.sqrt(sympy.simplify(self.along.dot(self.along)))


def _axes(kinds: Sequence[JointType], k: int, at: Directions, *, hub: bool) -> tuple[Point, ...]:
    """Axes of joint k of a limb; none where they follow by themselves."""
    kind, first, last = kinds[k], k == 0, k == len(kinds) - 1
    if kind.axes == 0:
        return ()
    if kind.axes == 2:
        if first:  # with a joint in the middle: through it, as in the source paper; else for pure translation
            return (at.radial, at.tangential) if hub or kinds[-1].ball else (at.tangential, at.normal)
        seen = any(x.universal or x.hinge for x in kinds[:k])
        return (at.normal, at.tangential) if last and seen else (at.tangential, at.normal)
    if kind.slider:
        if first or last:
            return (Z if first else at.radial,)
        if kinds[k - 1].slider:
            return (at.radial,)
        return (at.line,) if kinds[k + 1].slider else ()
    if kind.hinge:
        turned = sum(x.hinge for x in kinds[:k])
        return ((at.tangential, at.tangential, at.tangential, at.radial, at.normal)[min(turned, 4)],)
    if kind.triad is Triad.NORMAL:
        return (at.tangential,)
    return (at.line,) if not first else (Z,)


def _between(placed: dict[int, Point], count: int) -> tuple[Point, ...]:
    """Points of all joints: those without a place evenly between their neighbours that have one."""
    points = []
    for k in range(count):
        low, high = max(i for i in placed if i <= k), min(i for i in placed if i >= k)
        f = sympy.Rational(k - low, high - low) if high > low else sympy.Integer(0)
        points.append((placed[low] + f * (placed[high] - placed[low])).applyfunc(sympy.expand))
    return tuple(points)


def planar(limb: LimbType, place: int, count: int) -> Layout:
    """A limb in the x-y plane; the platform is turned so that the legs' lines do not meet in one point."""
    angle = 2 * sympy.pi * place / count + sympy.pi / 2
    radial, sideways = frame(angle)
    start, end, letters = R * radial, r * frame(angle + sympy.pi / 6)[0], limb.letters
    kinds = kinds_of(letters)
    inner = [k for k in range(1, len(letters) - 1) if not kinds[k].slider]
    placed = {0: start, len(letters) - 1: end}
    for i, k in enumerate(inner, start=1):
        f = sympy.Rational(i, len(inner) + 1)
        placed[k] = start + f * (end - start) - 4 * f * (1 - f) * b * sideways
    points = _between(placed, len(letters))
    axes: list[tuple[Point, ...]] = []
    for k, kind in enumerate(kinds):
        if kind.hinge:
            axes.append((Z,))
        elif 0 < k < len(letters) - 1 and not (kinds[k - 1].slider or kinds[k + 1].slider):
            axes.append(())
        else:
            axes.append(((sideways, radial, sideways)[k % 3],))
    return Layout(points, tuple(axes))


def arm(limb: LimbType) -> Layout:
    """An arm: up from the base, then forward, with an elbow and a bent wrist so that nothing is aligned."""
    x, y = vector(1, 0, 0), vector(0, 1, 0)
    steps = (Z, Z, x, x, x, -Z)
    turns, slides = (Z, y, y, x, y, Z), (Z, x, y)
    axes: list[tuple[Point, ...]] = []
    points, turned, slid = [0 * Z], 0, 0
    for k, kind in enumerate(kinds_of(limb.letters)):
        if k:
            points.append(points[-1] + l * steps[(k - 1) % 6] * (1 if k < 4 else HALF))
        if kind.slider:
            axes.append((slides[slid % 3],))
            slid += 1
        elif kind.axes == 0:
            axes.append(())
        elif kind.axes == 2:
            axes.append((x, y))
        else:
            axes.append((turns[turned % 6],))
            turned += 1
    return Layout(tuple(points), tuple(axes))


def all_driven(limb: LimbType) -> LimbType:
    """The limb with every freedom driven."""
    return LimbType(limb.letters, tuple(tuple(range(JOINT_TYPES[x].freedom)) for x in limb.letters))
