"""A commented description to start from: sensible geometry for a mechanism string such as "3-UPS+UPU+S".

Limbs stand on a circle of radius R around the base and carry a platform of radius r at height H; limbs of R and
P alone make a planar mechanism in the x-y plane; a single limb makes an arm. Where a joint type leaves a choice of
axes, the file says what was chosen and why it may have to change.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any, TypeAlias

import sympy

from symscrew.description import toml_file
from symscrew.description.expressions import to_text
from symscrew.description.joints import JOINT_TYPES, JointType, Triad
from symscrew.description.limb_letters import LimbType, parse_mechanism_string
from symscrew.description.names import check_mechanism_name
from symscrew.errors import DescriptionError
from symscrew.whole_files import created

Point: TypeAlias = Any  # a sympy.Matrix of three entries
R, r, H, b, l = sympy.symbols("R r H b l", positive=True)
HALF = sympy.Rational(1, 2)
LINK_MASS, PLATFORM_MASS = 1, 3  # [kg], of a proposal: round numbers that a reader sees are to be changed
VALUES = {
    "parallel": {R: ("0.5", "radius of the base points"), r: ("0.25", "radius of the platform's points"),
                 H: ("0.6", "height of the platform"), b: ("0.15", "how far elbows stand out")},
    "planar": {R: ("0.45", "radius of the base points"), r: ("0.15", "radius of the platform's points"),
               b: ("0.2", "how far elbows stand out")},
    "serial": {l: ("0.3", "length of a link")},
}  # fmt: skip


@dataclass(frozen=True)
class Layout:
    """Where the joints of a limb are, base first, and their axes; an empty list where the axis follows by itself."""

    points: tuple[Point, ...]
    axes: tuple[tuple[Point, ...], ...]


def description_text(name: str, limbs: str) -> str:
    """The TOML text of a mechanism with these limbs: it loads, with inertias, drives and comments.

    Args:
        name: of the mechanism, a C identifier.
        limbs: a mechanism string (`limb_letters.parse_mechanism_string`); one limb makes a serial arm, whose joints
            are all driven unless stars say otherwise.

    Raises:
        DescriptionError: a string or a name that cannot be read.
    """
    check_mechanism_name(name, "mechanism.name")
    types = parse_mechanism_string(limbs)
    if len(types) == 1:
        kind, layouts = "serial", [_arm(types[0])]
        if "*" not in limbs:
            types = (_all_driven(types[0]),)
    elif all(len(t.letters) <= 3 and all(k.hinge or k.slider for k in _kinds(t.letters)) for t in types):
        kind, layouts = "planar", [_planar(t, k, len(types)) for k, t in enumerate(types)]
    else:
        kind, layouts = "parallel", _spatial(types)
    used = [s for s in VALUES[kind] if any(v.has(s) for y in layouts for v in (*y.points, *sum(y.axes, ())))]
    used += [s for s in ((l,) if kind == "serial" else (r, H) if kind == "parallel" else (r,)) if s not in used]
    text = "\n".join(
        [*_head(name, limbs, kind), *_parameters(kind, used), *_platform(kind, layouts),
         *(line for k, (t, y) in enumerate(zip(types, layouts, strict=True)) for line in _limb(kind, k, t, y)),
         *_points(kind, types, layouts)]
    )  # fmt: skip
    toml_file.parse_description(text)
    return text + "\n"


def write_template(name: str, limbs: str, path: str | Path) -> Path:
    """Write the description to a new file.

    Raises:
        DescriptionError: a string or name that cannot be read, or a file that is there already.
    """
    file = Path(path)
    text = description_text(name, limbs)
    if file.suffix != ".toml":
        raise DescriptionError(f"expected a file name that ends in .toml, got {str(file)!r}")
    try:
        created(file, text)
    except FileExistsError as error:
        raise DescriptionError(f"{file} is there already and is left as it is; use another name or --out") from error
    return file


# -- geometry ---------------------------------------------------------------------------------------------


def _vector(*entries: object) -> Point:
    return sympy.Matrix(entries)


def _frame(angle: sympy.Expr) -> tuple[Point, Point]:
    """Radial and tangential unit vectors at an angle about z."""
    c, s = sympy.cos(angle), sympy.sin(angle)
    return _vector(c, s, 0), _vector(-s, c, 0)


Z = sympy.Matrix([0, 0, 1])


def _kinds(letters: str) -> list[JointType]:
    return [JOINT_TYPES[letter] for letter in letters]


def _spatial(types: Sequence[LimbType]) -> list[Layout]:
    """Single joints at the middle, all other limbs on circles; six or more in pairs, as hexapods have them."""
    around = [t for t in types if len(t.letters) > 1]
    count = max(len(around), 1)
    paired = count >= 6 and all(_kinds(t.letters)[-1].ball for t in around)
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
        result.append(_leg(limb.letters, angle + shift, angle - shift, hub=hub, paired=paired))
        place += 1
    return result


def _hub(letter: str) -> Layout:
    kind, x, y = JOINT_TYPES[letter], _vector(1, 0, 0), _vector(0, 1, 0)
    axes = {0: (), 1: (y if kind.hinge else Z,), 2: (x, y)}
    return Layout((_vector(0, 0, 0),), (axes[kind.axes],))


def _leg(letters: str, base: sympy.Expr, top: sympy.Expr, *, hub: bool, paired: bool) -> Layout:
    """A limb in its radial plane: straight, with elbows outwards, or from a vertical rail."""
    radial, tangential = _frame(base)
    kinds = _kinds(letters)
    rail = kinds[0].slider
    start = R * radial + (H / 3 * Z if rail else 0 * Z)
    end = r * _frame(top)[0] + H * Z
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
    return Layout(points, tuple(axes))


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


def _planar(limb: LimbType, place: int, count: int) -> Layout:
    """A limb in the x-y plane; the platform is turned so that the legs' lines do not meet in one point."""
    angle = 2 * sympy.pi * place / count + sympy.pi / 2
    radial, sideways = _frame(angle)
    start, end, letters = R * radial, r * _frame(angle + sympy.pi / 6)[0], limb.letters
    kinds = _kinds(letters)
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


def _arm(limb: LimbType) -> Layout:
    """An arm: up from the base, then forward, with an elbow and a bent wrist so that nothing is aligned."""
    x, y = _vector(1, 0, 0), _vector(0, 1, 0)
    steps = (Z, Z, x, x, x, -Z)
    turns, slides = (Z, y, y, x, y, Z), (Z, x, y)
    axes: list[tuple[Point, ...]] = []
    points, turned, slid = [0 * Z], 0, 0
    for k, kind in enumerate(_kinds(limb.letters)):
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


def _all_driven(limb: LimbType) -> LimbType:
    return LimbType(limb.letters, tuple(tuple(range(JOINT_TYPES[x].freedom)) for x in limb.letters))


# -- text -------------------------------------------------------------------------------------------------


def _entry(value: sympy.Expr) -> str:
    text = to_text(value)
    return text if value.is_Integer else f'"{text}"'


def _row(vector: Point) -> str:
    return "[" + ", ".join(_entry(v) for v in vector) + "]"


def _head(name: str, limbs: str, kind: str) -> list[str]:
    what = {"serial": "an arm", "planar": "in the x-y plane", "parallel": "limbs between base and platform"}[kind]
    platform = "tool" if kind == "serial" else "platform"
    return [
        f"# {name}: {limbs}, {what}. Everything here is a proposal to change.",
        "#",
        "# Units are m, kg, rad; points and axes: absolute axes, reference configuration; gravity is along -z.",
        '# A number may be an expression of the parameters in quotes, "R*cos(2*pi/3)"; it is read exactly.',
        f"# Next: symscrew mobility {name}.toml; symscrew view {name}.toml; symscrew generate {name}.toml --out {name}",
        "",
        "[mechanism]",
        f'name = "{name}"',
        'ground = "base"  # the body that does not move',
        f'platform = "{platform}"  # the body whose motion matters',
        f'description = "{limbs}, {what}"',
        "# characteristic_length = 0.5  # [m], divides lengths where they meet angles; default: from the geometry",
        "",
    ]


def _parameters(kind: str, used: Sequence[sympy.Symbol]) -> list[str]:
    lines = ["# run_time = true makes a parameter an input of the generated functions instead of a number in them."]
    for symbol in used:
        value, text = VALUES[kind][symbol]
        lines += [f"[parameters.{symbol}]", f'value = "{value}"', 'unit = "m"', f'description = "{text}"', ""]
    return lines


def _platform(kind: str, layouts: Sequence[Layout]) -> list[str]:
    if kind == "serial":
        com = layouts[0].points[-1] + HALF * HALF * l * sympy.Matrix([1, 0, 0])
        body, moments = "tool", '["0.0005", "0.002", "0.002"]'
        note = "# A rod of 0.15 m along x. mass [kg], com: centre of mass [m], inertia about it [kg m^2]."
        mass = LINK_MASS
    else:
        com, body, mass = (H * Z if kind == "parallel" else 0 * Z), "platform", PLATFORM_MASS
        quarter = f"{PLATFORM_MASS}*r^2/4"
        moments = f'["{quarter}", "{quarter}", "{PLATFORM_MASS}*r^2/2"]'
        note = "# A disc of radius r. mass [kg], com: centre of mass [m], inertia about it [kg m^2]."
    return [note, f"[bodies.{body}]", f"mass = {mass}", f"com = {_row(com)}", f"inertia = {moments}", ""]


def _limb(kind: str, place: int, limb: LimbType, layout: Layout) -> list[str]:
    letters, name = limb.letters, "arm" if kind == "serial" else f"limb{place + 1}"
    tip = "tool" if kind == "serial" else "platform"
    kinds = _kinds(letters)
    names = ", ".join(kind.name for kind in kinds)
    drives = "a star marks a driven freedom" if any(limb.driven) else "no drive: put a star after a joint to drive it"
    lines = [f"# {names}; {drives}."]
    lines += [f"[limbs.{name}]", f'type = "{limb.marked}"', 'base = "base"', f'tip = "{tip}"']
    sliders = [axes for kind, axes in zip(kinds, layout.axes, strict=True) if kind.slider]
    skip = bool(sliders) and not any(sliders)
    places = [p for p, kind in zip(layout.points, kinds, strict=True) if not (skip and kind.slider)]
    lines += ["points = [  # one per joint, base first" + (", a P sits in the middle" if skip else "")]
    lines += [f"  {_row(p)}," for p in places] + ["]"]
    if any(layout.axes):
        lines.append("axes = [  # one list per joint" + (", empty for S or for P along the leg" * (() in layout.axes)))
        lines += [
            f"  [{', '.join(_row(a) for a in axes)}],  # {x}" for x, axes in zip(letters, layout.axes, strict=True)
        ]
        lines.append("]")
    if any(kind.helical for kind in kinds):
        pitches = ", ".join('"0.002"' if kind.helical else '""' for kind in kinds)
        lines.append(f"pitch = [{pitches}]  # [m/rad]")
    if len(letters) > 1:
        lines += _rods(kind, layout.points)
    return [*lines, ""]


def _rods(kind: str, points: Sequence[Point]) -> list[str]:
    """Mass, centre and inertia of the bodies between the joints: slender rods at the parameters' values."""
    values = {symbol: sympy.Rational(value) for symbol, (value, _) in VALUES[kind].items()}
    count = len(points) - 1
    lines = ["# Slender rods at the values of the parameters above: change the inertias with the lengths."]
    lines += [f"mass = [{', '.join([str(LINK_MASS)] * count)}]", "com = ["]
    lines += [f"  {_row((HALF * (p + q)).applyfunc(sympy.expand))}," for p, q in pairwise(points)]
    lines += ["]", "inertia = ["]
    for p, q in pairwise(points):
        d = (q - p).subs(values).evalf(30)
        moments = LINK_MASS * ((d.dot(d) * sympy.eye(3) - d * d.T) / 12 + sympy.Rational(1, 5000) * sympy.eye(3))
        rows = ["[" + ", ".join(f'"{float(v):.6f}"' for v in moments.row(i)) + "]" for i in range(3)]
        lines.append(f"  [{', '.join(rows)}],")
    return [*lines, "]"]


def _points(kind: str, types: Sequence[LimbType], layouts: Sequence[Layout]) -> list[str]:
    """Named points: where loads act and what pictures label."""
    if kind == "serial":
        named = [("T", "tool", layouts[0].points[-1] + HALF * l * sympy.Matrix([1, 0, 0]))]
    else:
        named = [("E", "platform", H * Z if kind == "parallel" else 0 * Z)]
        for k, (limb, layout) in enumerate(zip(types, layouts, strict=True), start=1):
            named.append((f"A{k}", "base", layout.points[0]))
            if len(limb.letters) > 1:
                named.append((f"C{k}", "platform", layout.points[-1]))
    lines = ["# Named points: labels of pictures, and where a load may act (--load NAME)."]
    for name, body, place in named:
        lines += [f"[points.{name}]", f'body = "{body}"', f"at = {_row(place)}", ""]
    return lines
