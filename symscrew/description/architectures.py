"""Mechanisms that have a name in the field: their limbs, and the places and axes that make them what they are.

"Tricept" --ARCHITECTURES--> limbs "3-UPS+~UP", a layout of each, what it promises: 3 freedoms of type 2R1T

Sources: the reviews in J.-P. Merlet, Parallel Robots (2006), and X. Kong, C. Gosselin, Type Synthesis of Parallel
Mechanisms (2007); of each one where it stands. A further one is a function of its limbs and a line in the table.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import sympy

from symscrew.description.limb_layouts import HALF, H, Layout, Point, R, Z, b, frame, r, spatial, vector, w
from symscrew.description.limb_letters import LimbType, parse_mechanism_string

_SIDE = r / sympy.sqrt(2)  # of the middle of a platform to its side bars, which its corners at radius r end
X, Y = vector(1, 0, 0), vector(0, 1, 0)


@dataclass(frozen=True)
class Architecture:
    """A named mechanism: its limbs, the freedoms and the type of its platform, and a sentence about it.

    `layout` places the limbs; `centre` is the platform's centre of mass. `values`: of parameters that are not as in
    other proposals, with what they are. `tips`: the body each limb carries, where it is not the platform. `hinges`: of
    further bodies, (body, point, axis) of the hinge by which each carries the platform.
    """

    name: str
    limbs: str
    freedoms: int
    type: str
    says: str
    layout: Callable[[Sequence[LimbType]], Sequence[Layout]] = spatial
    centre: Point = field(default_factory=lambda: H * Z)
    values: Mapping[sympy.Symbol, tuple[str, str]] = field(default_factory=dict)
    tips: tuple[str, ...] = ()
    hinges: tuple[tuple[str, Point, Point], ...] = ()


def _tricept(types: Sequence[LimbType]) -> list[Layout]:
    """Three legs around, and in the middle a guide that is fixed to the platform: U at the base, P along it."""
    return [*spatial(types[:3]), Layout((0 * Z, HALF * H * Z), ((X, Y), (Z,)))]


def _exechon(types: Sequence[LimbType]) -> list[Layout]:
    """Two legs in the plane x-z with a common first axis, x, and hinges along y; the third in the plane y-z.

    Z. Bi, Y. Jin, Robotics and Computer-Integrated Manufacturing 27 (2011) 186-193.
    """
    made = []
    for side in (1, -1):
        start, end = side * R * X, side * r * X + H * Z
        made.append(Layout((start, HALF * (start + end), end), ((X, Y), (_unit(end - start),), (Y,))))
    start, end = R * Y, r * Y + H * Z
    return [*made, Layout((start, HALF * (start + end), end), ((), (_unit(end - start),), (X,)))]


def _four_ruu(types: Sequence[LimbType]) -> list[Layout]:
    """Cranks about vertical axes; the next two axes parallel and horizontal, around them vertical ones.

    S. Amine, M. T. Masouleh, S. Caro, P. Wenger, C. Gosselin, Mechanism and Machine Theory 49 (2012) 1-16. Elbows stand
    out to either side in turn: all to one side the drives would not hold the platform's turn about z.
    """
    made = []
    for k in range(len(types)):
        radial, tangential = frame(2 * sympy.pi * k / len(types))
        side = (-1) ** k * b
        elbow, tip = R * radial + side * tangential, r * radial + H * Z
        across = (side * radial + (r - R) * tangential) / sympy.sqrt((R - r) ** 2 + b**2)
        made.append(Layout((R * radial, elbow, tip), ((Z,), (Z, across), (across, Z))))
    return made


def _four_prur(types: Sequence[LimbType]) -> list[Layout]:
    """Vertical rails; the hinge on the rail and the first axis of U parallel and horizontal, all others vertical."""
    made = []
    for k in range(len(types)):
        radial, tangential = frame(2 * sympy.pi * k / len(types) + sympy.pi / 4)
        start, tip = R * radial, r * radial + H * Z
        elbow = HALF * (R + r) * radial + H * Z + (-1) ** k * b * tangential
        axes = ((Z,), (tangential,), (tangential, Z), (Z,))
        made.append(Layout((start, start + H / 3 * Z, elbow, tip), axes))
    return made


def _h4(types: Sequence[LimbType]) -> list[Layout]:
    """Two arms carry each side bar; F. Pierrot, O. Company, IEEE/ASME AIM 1999, 508-513.

    The arms of a bar are at a right angle, and those of the other bar their mirror images: were they turned by half a
    turn about z, the bars could turn and the mechanism would be singular.
    """
    made = []
    for k in range(len(types)):
        radial, tangential = frame((sympy.pi / 2, 0, sympy.pi / 2, sympy.pi)[k])
        corner = _SIDE * vector(*((1, 1, 0), (1, -1, 0), (-1, 1, 0), (-1, -1, 0))[k])
        start, tip = corner + (R - r) * radial, corner + H * Z
        elbow = start + b * radial + H / 3 * Z
        rod = (tip - elbow).applyfunc(sympy.expand)
        normal = _unit(sympy.expand(rod.dot(Z)) * radial - sympy.simplify(rod.dot(radial)) * Z)
        made.append(Layout((start, elbow, tip), ((tangential,), (tangential, normal), (normal, tangential))))
    return made


def _orthoglide(types: Sequence[LimbType]) -> list[Layout]:
    """Rails along x, y, z that meet in the middle, bars along them: isotropic there.

    P. Wenger, D. Chablat, ARK 2000, 305-314.
    """
    made = []
    for k in range(len(types)):
        along, around = (X, Y, Z)[k], (X, Y, Z)[(k + 1) % 3]
        slide, tip = (r + R) * along, r * along
        hinge = along.cross(around)
        axes = ((along,), (around,), (hinge,), (hinge,), (around,))
        made.append(Layout((slide, slide, slide, tip, tip), axes, around))
    return made


def _agile_eye(types: Sequence[LimbType]) -> list[Layout]:
    """All axes through O, in every limb each at a right angle to the next: isotropic.

    C. Gosselin, J.-F. Hamel, IEEE ICRA 1994, 781-786.
    """
    made = []
    for k in range(len(types)):
        u, w, v = ((X, Y, Z)[(k + i) % 3] for i in range(3))
        made.append(Layout((R * u, R * w, r * v), ((u,), (w,), (v,))))
    return made


def _hexaglide(types: Sequence[LimbType]) -> list[Layout]:
    """Six parallel rails along y; M. Honegger, A. Codourey, E. Burdet, IEEE ICRA 1997, 543-548."""
    return [Layout(limb.points, ((Y,), *limb.axes[1:])) for limb in _without_rise(spatial(types))]


def _without_rise(limbs: Sequence[Layout]) -> list[Layout]:
    """Limbs of rails whose first two joints are at one place, on the base."""
    return [Layout((limb.points[0], limb.points[0], *limb.points[2:]), limb.axes) for limb in limbs]


def _unit(direction: Point) -> Point:
    return (direction / sympy.sqrt(sympy.simplify(direction.dot(direction)))).applyfunc(sympy.simplify)


ARCHITECTURES: Mapping[str, Architecture] = {
    made.name.lower().replace(" ", "_").replace("-", "_"): made
    for made in (
        Architecture("Tricept", "3-UPS+~UP", 3, "2R1T", "three legs and a passive guide in the middle", _tricept),
        Architecture("Exechon", "2-UPR+SPR", 3, "2R1T", "two legs in a plane about x, a third across it", _exechon),
        Architecture("3-PRS", "3-PRS", 3, "2R1T", "vertical rails, hinges along the circle"),
        Architecture("3-RPS", "3-RPS", 3, "2R1T", "hinges along the circle, legs that lengthen"),
        Architecture("4-RUU", "4-RUU", 4, "1R3T", "cranks about vertical axes", _four_ruu),
        Architecture("4-PRUR", "4-PRUR", 4, "1R3T", "vertical rails", _four_prur),
        Architecture(
            "H4", "4-RUU", 4, "1R3T", "two pairs of arms on two side bars, between which the platform turns", _h4,
            tips=("bar1", "bar1", "bar2", "bar2"),
            hinges=(("bar1", _SIDE * X + H * Z, Z), ("bar2", H * Z - _SIDE * X, Z)),
        ),
        Architecture(
            "Orthoglide", "3-PRPaR", 3, "3T", "rails at right angles, parallelograms along them", _orthoglide, 0 * Z,
            {R: ("0.4", "length of the bars"), r: ("0.05", "distance of the platform's joints from its middle"),
             w: ("0.08", "distance between the bars of a parallelogram")},
        ),
        Architecture(
            "Agile Eye", "3-RRR", 3, "3R", "all axes through O", _agile_eye, 0 * Z,
            {R: ("0.15", "distance of the joints from O"), r: ("0.1", "distance of the platform's joints from O")},
        ),
        Architecture("hexaglide", "6-PUS", 6, "3R3T", "six parallel rails", _hexaglide),
        Architecture("Gough", "6-UPS", 6, "3R3T", "the hexapod, also Stewart's platform"),
    )
}  # fmt: skip
"""Name as it is typed -> architecture."""

_BY_LIMBS = ("tricept", "exechon", "4_prur")
"""Those that limbs in letters alone mean, too, in whichever order the limbs are typed."""


def meant_by(limbs: Sequence[LimbType]) -> Architecture | None:
    """The architecture that a mechanism string stands for in the field where its axes are not those of any proposal."""
    marked = [limb.marked for limb in limbs]
    for name in _BY_LIMBS:
        if marked == [limb.marked for limb in parse_mechanism_string(ARCHITECTURES[name].limbs)]:
            return ARCHITECTURES[name]
    return None


def architecture(name: str) -> Architecture | None:
    """The architecture of a name, however it is spelt: "Agile Eye", "agile-eye", "3RPS"."""
    plain = {_plain(key): made for key, made in ARCHITECTURES.items()}
    return plain.get(_plain(name))


def _plain(name: str) -> str:
    return re.sub(r"[^a-z0-9]", "", name.lower())
