"""Mechanisms with known mobility beyond `data/mobility.json`: from the literature, or with the reason beside them.

Numbers are exact. `Case.expected`: (instantaneous, finite, branches or None where smooth, overconstraints).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath
import sympy
from sympy import Matrix, Rational, sqrt

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism

X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]


@dataclass(frozen=True)
class Case:
    """A mechanism, (dof, dof_finite, branches, overconstraints) and where the values come from."""

    make: Callable[[], Mechanism]
    expected: tuple[int, int, tuple[int, ...] | None, int]
    source: str


def unit(vector: Sequence[Any]) -> list[Any]:
    """The vector with length one, exactly."""
    size = sqrt(sum(sympy.sympify(c) ** 2 for c in vector))
    return [sympy.sympify(c) / size for c in vector]


def loop(*joints: tuple[str, Sequence[Any], Sequence[Any] | None], pitches: dict[int, Any] | None = None) -> Mechanism:
    """A single loop of joints (type, point, axis); the link between the last and the first is the ground."""
    builder = MechanismBuilder("loop")
    links = ["base", *(f"link{k}" for k in range(1, len(joints))), "base"]
    for link in links[1:-1]:
        builder.body(link)
    for k, (kind, point, axis) in enumerate(joints):
        options: dict[str, Any] = {} if axis is None else {"axes": [unit(axis)]}
        if kind == "H":
            options["pitch"] = (pitches or {})[k]
        builder.joint(f"J{k + 1}", kind, parent=links[k], child=links[k + 1], point=list(point), **options)
    return builder.build()


def graph(*joints: tuple[str, str, str, Sequence[Any], Sequence[Any] | None]) -> Mechanism:
    """Any graph of joints (type, parent, child, point, axis); the ground is `base`."""
    builder = MechanismBuilder("graph")
    for body in dict.fromkeys(b for j in joints for b in j[1:3] if b != "base"):
        builder.body(body)
    for k, (kind, parent, child, point, axis) in enumerate(joints):
        options: dict[str, Any] = {} if axis is None else {"axes": [unit(axis)]}
        builder.joint(f"J{k + 1}", kind, parent=parent, child=child, point=list(point), **options)
    return builder.build()


def framework(points: Sequence[Sequence[Any]], bars: Sequence[tuple[int, int]], axis: Sequence[int] = Z) -> Mechanism:
    """A planar framework of bars with pins at `points`; the first bar is the ground."""
    names = ["base", *(f"bar{a}_{b}" for a, b in bars[1:])]
    joints = []
    for pin, point in enumerate(points):
        meeting = [name for name, bar in zip(names, bars, strict=True) if pin in bar]
        joints += [("R", meeting[0], other, [*point, 0], axis) for other in meeting[1:]]
    return graph(*joints)


def half_turned(joint: tuple[str, list[Any], list[Any]]) -> tuple[str, list[Any], list[Any]]:
    """The joint turned by pi about z."""
    kind, (x, y, z), (a, b, c) = joint
    return (kind, [-x, -y, z], [-a, -b, c])


def mirrored(joint: tuple[str, list[Any], list[Any]]) -> tuple[str, list[Any], list[Any]]:
    """The joint mirrored in the plane y = 0."""
    kind, (x, y, z), (a, b, c) = joint
    return (kind, [x, -y, z], [a, -b, c])


def line_symmetric() -> Mechanism:
    half = [("R", [3, 1, 0], [1, 2, 2]), ("R", [1, 4, 2], [2, -1, 3]), ("R", [-2, 3, 5], [0, 3, 4])]
    return loop(*half, *(half_turned(j) for j in half))


def plane_symmetric() -> Mechanism:
    one, four = ("R", [2, 0, 1], [1, 0, 3]), ("R", [-3, 0, 2], [2, 0, 1])
    two, three = ("R", [1, 3, 0], [2, 1, 2]), ("R", [-1, 4, 3], [1, -2, 4])
    return loop(one, two, three, four, mirrored(three), mirrored(two))


BENNETT = (
    ("R", [0, 0, 0], [0, 0, 1]),
    ("R", [1, 0, 0], [0, Rational(-3, 5), Rational(4, 5)]),
    ("R", [Rational(224, 169), Rational(224, 507), Rational(56, 169)], [56 * 5, 336, -723]),
    ("R", [Rational(5, 13), Rational(20, 39), 0], [4, -3, -12]),
)


def moved(joint: tuple[str, Any, Any], rotation: Matrix, shift: Sequence[Any], factor: Any = 1) -> tuple[str, Any, Any]:
    """The joint turned, scaled about O and shifted."""
    kind, point, axis = joint
    return (kind, list(rotation * Matrix(point) * factor + Matrix(shift)), list(rotation * Matrix(axis)))


def about_z(c: Any, s: Any) -> Matrix:
    return Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def waldron_hybrid() -> Mechanism:
    """Two Bennett loops about a common axis z, its joint left out: both turn by the same angle."""
    turned = about_z(Rational(-4, 5), Rational(3, 5))
    other = [moved(j, turned, (0, 0, 3), Rational(3, 2)) for j in BENNETT]
    return loop(BENNETT[1], BENNETT[2], BENNETT[3], other[3], other[2], other[1])


def plano_spherical_hybrid() -> Mechanism:
    """A planar and a spherical four-bar about a common axis z, its joint left out (Bennett 1905)."""
    planar = [("R", [4, 1, 0], Z), ("R", [3, 5, 0], Z), ("R", [-2, 3, 0], Z)]
    spherical = [("R", [0, 0, 5], v) for v in ([1, 0, 2], [1, 3, 1], [0, 2, 5])]
    return loop(*planar, *spherical)


def two_bennetts() -> Mechanism:
    """Two Bennett loops side by side that share one joint and its two links."""
    other = [moved(j, about_z(1, 0), (0, 0, 0), -1) for j in BENNETT]
    first = [("R", "base", "a", *BENNETT[0][1:]), ("R", "a", "b", *BENNETT[1][1:]), ("R", "b", "c", *BENNETT[2][1:]),
             ("R", "c", "base", *BENNETT[3][1:])]  # fmt: skip
    second = [("R", "a", "d", *other[1][1:]), ("R", "d", "e", *other[2][1:]), ("R", "e", "base", *other[3][1:])]
    return graph(*first, *second)


def three_limb_sarrus() -> Mechanism:
    joints = []
    for k, (c, s) in enumerate([(1, 0), (Rational(-1, 2), sqrt(3) / 2), (Rational(-1, 2), -sqrt(3) / 2)]):
        axis = [-s, c, 0]
        places = [[2 * c, 2 * s, 0], [3 * c, 3 * s, 1], [2 * c, 2 * s, 2]]
        bodies = ["base", f"a{k}", f"b{k}", "plate"]
        joints += [("R", bodies[i], bodies[i + 1], places[i], axis) for i in range(3)]
    return graph(*joints)


def legs(points: Sequence[Sequence[Any]]) -> Mechanism:
    """A platform on equal parallel legs with spherical joints at both ends."""
    joints = []
    for k, (x, y) in enumerate(points):
        joints += [("S", "base", f"leg{k}", [x, y, 0], None), ("S", f"leg{k}", "plate", [x, y, 2], None)]
    return graph(*joints)


CIRCLE = ([1, 0], [Rational(3, 5), Rational(4, 5)], [0, 1], [-1, 0], [Rational(-4, 5), Rational(-3, 5)])
NO_CIRCLE = ([1, 0], [Rational(3, 5), Rational(4, 5)], [0, 2], [-1, 0], [Rational(-4, 5), Rational(-3, 5)])


def octahedral(half: Sequence[Sequence[Any]], opposite: Sequence[Sequence[Any]]) -> Mechanism:
    """Six faces of an octahedron hinged in a ring, two opposite ones left out; corners a, b, c and their opposites."""
    corners = dict(zip("abcABC", (*half, *opposite), strict=True))
    ring = ("abC", "aBC", "aBc", "ABc", "Abc", "AbC")
    edges = [[corners[v] for v in one if v in other] for one, other in zip(ring, (*ring[1:], ring[0]), strict=True)]
    return loop(*(("R", p, [b - a for a, b in zip(p, q, strict=True)]) for p, q in edges))


def line_symmetric_hexapod() -> Mechanism:
    """Six legs of constant length, A_i to b_i and B_i to a_i, on a platform that is the base turned half about a line.

    For every line (four freedoms) three conditions on lengths: each holds for two legs.
    """
    feet, others = ([3, 0, 1], [-1, 2, 0], [0, -3, 2]), ([1, 1, -1], [2, -2, 1], [-2, 0, 3])
    pairs = [*zip(feet, others, strict=True), *zip(others, feet, strict=True)]
    return struts([(foot, [-x, -y, z]) for foot, (x, y, z) in pairs])


def griffis_duffy() -> Mechanism:
    """Corners of a triangle to the middles of the sides of an equal one, and middles to corners."""
    corners = [(Rational(2), 0), (-Rational(1), sqrt(3)), (-Rational(1), -sqrt(3))]
    middles = [((a + c) / 2, (b + d) / 2) for (a, b), (c, d) in zip(corners, (*corners[1:], corners[0]), strict=True)]

    def above(x: Any, y: Any) -> list[Any]:
        return [Rational(3, 5) * x - Rational(4, 5) * y, Rational(4, 5) * x + Rational(3, 5) * y, 2]

    pairs = [*zip(corners, middles, strict=True), *zip(middles, (*corners[1:], corners[0]), strict=True)]
    return struts([([*foot, 0], above(*tip)) for foot, tip in pairs])


def struts(pairs: Sequence[tuple[Sequence[Any], Sequence[Any]]]) -> Mechanism:
    """A platform on legs with spherical joints at both ends."""
    return graph(*(joint for k, (foot, tip) in enumerate(pairs) for joint in
                   (("S", "base", f"leg{k}", foot, None), ("S", f"leg{k}", "plate", tip, None))))  # fmt: skip


def dixon() -> Mechanism:
    """K(3,3) with its points on two perpendicular lines: x_i^2 + t, y_j^2 - t keep all lengths (Dixon 1899)."""
    points = [[1, 0], [2, 0], [-3, 0], [0, 2], [0, -1], [0, 4]]
    return framework(points, [(i, j) for i in range(3) for j in range(3, 6)])


def hexagon() -> Mechanism:
    """K(3,3) on a circle: shaky (Bolker and Roth 1980: infinitesimally flexible on a conic), and no more."""
    h = sqrt(3) / 2
    points = [[1, 0], [Rational(-1, 2), h], [Rational(-1, 2), -h], [Rational(1, 2), h], [-1, 0], [Rational(1, 2), -h]]
    return framework(points, [(i, j) for i in range(3) for j in range(3, 6)])


def peaucellier() -> Mechanism:
    """Fixed O and Q with |OQ| = |QA|; OB = OD; rhombus A B C D."""
    points = [[0, 0], [Rational(3, 2), 0], [Rational(12, 5), Rational(6, 5)]]
    # B and D mirror each other in the line O A, whose direction is (2, 1) / sqrt 5
    a = Matrix(points[2])
    direction = Matrix([2, 1])
    across = Matrix([-1, 2])
    middle = a + direction * Rational(2, 5)
    b, d = middle + across * Rational(1, 2), middle - across * Rational(1, 2)
    c = 2 * middle - a
    pins = [points[0], points[1], list(a), list(b), list(d), list(c)]
    return framework(pins, [(0, 1), (1, 2), (0, 3), (0, 4), (2, 3), (2, 4), (3, 5), (4, 5)])


def coupler_point_and_centre() -> Mechanism:
    """A third bar from a coupler point to the centre of curvature of its path: the bar's length is stationary to
    second order, so the instantaneous motion passes the second-order test and is stopped at third order."""
    a, b, d, o = Matrix([0, 0]), Matrix([1, 2]), Matrix([5, 0]), Matrix([4, 3])
    # rates of the four-bar a-b-o-d with crank rate 1, twice differentiated
    w, z = sympy.symbols("w z")

    def perp(v: Matrix) -> Matrix:
        return Matrix([-v[1], v[0]])

    vb = perp(b - a)
    rates = sympy.solve(list(vb + w * perp(o - b) - z * perp(o - d)), [w, z])
    w1, z1 = rates[w], rates[z]
    ab = -(b - a)
    changes = sympy.solve(list(ab + w * perp(o - b) - w1**2 * (o - b) - z * perp(o - d) + z1**2 * (o - d)), [w, z])
    p = Matrix([3, 5])
    velocity = vb + w1 * perp(p - b)
    acceleration = ab + changes[w] * perp(p - b) - w1**2 * (p - b)
    normal = perp(velocity)
    radius = velocity.dot(velocity) / normal.dot(acceleration)
    centre = p + normal * radius
    return graph(
        ("R", "base", "crank", [*a, 0], Z), ("R", "crank", "coupler", [*b, 0], Z),
        ("R", "coupler", "rocker", [*o, 0], Z), ("R", "rocker", "base", [*d, 0], Z),
        ("R", "coupler", "bar", [*p, 0], Z), ("R", "bar", "base", [*centre, 0], Z),
    )  # fmt: skip


def origami(*directions: Sequence[Any]) -> Mechanism:
    """Faces around a flat vertex: hinges through O along the creases."""
    return loop(*(("R", [0, 0, 0], [*d, 0]) for d in directions))


def miura(height: Any) -> Mechanism:
    """Miura fold of parallelograms; vertices (i, 2 j + (i mod 2) / 2, (j mod 2) height), any height closes."""

    def vertex(i: int, j: int) -> Matrix:
        return Matrix([i, 2 * j + Rational(i % 2, 2), (j % 2) * height])

    def name(i: int, j: int) -> str:
        return "base" if (i, j) == (0, 0) else f"face{i}_{j}"

    joints = []
    for i in range(3):
        for j in range(3):
            if i < 2:
                p, q = vertex(i + 1, j), vertex(i + 1, j + 1)
                joints.append(("R", name(i, j), name(i + 1, j), list(p), list(q - p)))
            if j < 2:
                p, q = vertex(i, j + 1), vertex(i + 1, j + 1)
                joints.append(("R", name(i, j), name(i, j + 1), list(p), list(q - p)))
    return graph(*joints)


def schoenflies() -> Mechanism:
    """Three limbs P R R R with all axes along z generate the same group of dimension 4."""
    joints = []
    for k, (x, y) in enumerate([(3, 0), (0, 4), (-2, -2)]):
        bodies = ["base", f"a{k}", f"b{k}", f"c{k}", "plate"]
        places = [[x, y, 0], [x, y, 0], [x + 1, y + 1, 1], [Rational(x, 2), Rational(y, 2), 1]]
        joints += [("P" if i == 0 else "R", bodies[i], bodies[i + 1], places[i], Z) for i in range(4)]
    return graph(*joints)


def three_prs() -> Mechanism:
    joints = []
    for k, (c, s) in enumerate([(1, 0), (0, 1), (-1, 0)]):
        bodies = ["base", f"a{k}", f"b{k}", "plate"]
        joints += [
            ("P", "base", bodies[1], [3 * c, 3 * s, 0], Z),
            ("R", bodies[1], bodies[2], [3 * c, 3 * s, 1], [-s, c, 0]),
            ("S", bodies[2], "plate", [2 * c, 2 * s, 4], None),
        ]
    return graph(*joints)


def three_bars(length: Sequence[Any], feet: Sequence[Sequence[Any]], tips: Sequence[Sequence[Any]]) -> Mechanism:
    joints = []
    for k, (foot, tip) in enumerate(zip(feet, tips, strict=True)):
        joints += [("R", "base", f"bar{k}", [*foot, 0], Z), ("R", f"bar{k}", "plate", [*tip, 0], Z)]
    return graph(*joints)


def concurrent_bars() -> Mechanism:
    feet = [[4, 0], [0, 6], [-8, -2]]
    return three_bars([], feet, [[2, 0], [0, 2], [-4, -1]])


def four_parallel_circle_translation() -> Mechanism:
    """A plate on four equal parallel bars in a plane: circular translation, redundant twice over."""
    feet = [[0, 0], [3, 1], [5, -1], [7, 0]]
    return three_bars([], feet, [[x + 1, y + 2] for x, y in feet])


def two_rhombi() -> Mechanism:
    """A flat rhombus on the coupler of another."""
    return graph(
        ("R", "base", "a", [0, 0, 0], Z), ("R", "a", "b", [1, 0, 0], Z), ("R", "b", "c", [2, 0, 0], Z),
        ("R", "c", "base", [1, 0, 0], Z), ("R", "b", "d", [1, 0, 0], Z), ("R", "d", "e", [2, 0, 0], Z),
        ("R", "e", "f", [3, 0, 0], Z), ("R", "f", "b", [2, 0, 0], Z),
    )  # fmt: skip


def trammel(*point: Any) -> Mechanism:
    """A bar on two perpendicular slides, with a crank about O at one of its points."""
    return graph(
        ("P", "base", "s1", [0, 0, 0], X), ("R", "s1", "bar", [6, 0, 0], Z), ("R", "bar", "s2", [0, 8, 0], Z),
        ("P", "s2", "base", [0, 0, 0], Y), ("R", "bar", "crank", [*point, 0], Z), ("R", "crank", "base", [0, 0, 0], Z),
    )  # fmt: skip


def universal_legs() -> Mechanism:
    """Three equal parallel legs with universal joints: circular translations of a plate, two freedoms."""
    builder = MechanismBuilder("legs", platform="plate").body("plate")
    for k, (x, y) in enumerate([(0, 0), (1, 0), (0, 1)]):
        builder.body(f"leg{k}")
        builder.joint(f"a{k}", "U", parent="base", child=f"leg{k}", point=[x, y, 0], axes=[X, Y])
        builder.joint(f"b{k}", "U", parent=f"leg{k}", child="plate", point=[x, y, 2], axes=[Y, X])
    return builder.build()


def wunderlich() -> Mechanism:
    """Twelve bars like the edges of a cube, four of each of three lengths 7, 3 and 5: six loops of equal opposite bars.

    Here the loops of 7 and 3 are flat, those of 7 and 5 parallelograms, those of 3 and 5 antiparallelograms. They may
    open as parallelograms, with two freedoms, or as antiparallelograms, with one: for these, with half angles a, b, c
    between the opposite bars, 7 sin a = 3 sin b and 5 sin c = 3 cos b.
    """
    points = {(0, 0, 0): (0, 0), (1, 0, 0): (7, 0), (0, 1, 0): (3, 0), (1, 1, 0): (10, 0),
              (0, 0, 1): (3, 4), (1, 0, 1): (10, 4), (0, 1, 1): (0, 4), (1, 1, 1): (7, 4)}  # fmt: skip
    corners = list(points)
    bars = [(i, k) for k, one in enumerate(corners) for i, other in enumerate(corners[:k])
            if sum(a != b for a, b in zip(one, other, strict=True)) == 1]  # fmt: skip
    return framework(list(points.values()), bars)


def cranks(*pins: Sequence[Any]) -> Mechanism:
    """A plate on parallel cranks of length 1 that stand upright on these pins."""
    return three_bars([], pins, [[x, y + 1] for x, y in pins])


def focal_mechanism() -> Mechanism:
    """A four-bar A B C D and bars from one point O to a pin on each side: opposite quadrilaterals about O are similar.

    A P O S and O R C Q, B Q O P and O S D R, mirror images: R = k conj(P - A) and so on, with k / l real for pins on
    the sides. Then C = -k conj(A), D = -l conj(B), P divides A B, and so on.
    """
    one, two, turn = sympy.sympify("2 + I"), sympy.sympify("1 - 2*I"), sympy.sympify("(3 + 4*I)/5")
    k, m = Rational(3, 2), Rational(-2, 3)
    three, four = -k * turn * sympy.conjugate(one), -m * turn * sympy.conjugate(two)
    side = {"P": (k * one - m * two) / (k - m), "Q": (k * m * two - three) / (k * m - 1),
            "R": (k * four - m * three) / (k - m), "S": (k * m * one - four) / (k * m - 1)}  # fmt: skip

    def pin(a: str, b: str, place: Any) -> tuple[str, str, str, Sequence[Any], Sequence[Any]]:
        return ("R", a, b, [*sympy.expand(place).as_real_imag(), 0], Z)

    bars = ("base", "bc", "cd", "da")
    corners = [pin(a, b, p) for a, b, p in zip(bars, (*bars[1:], bars[0]), (two, three, four, one), strict=True)]
    spokes = [pin(bar, f"o{name}", place) for bar, (name, place) in zip(bars, side.items(), strict=True)]
    return graph(*corners, *spokes, *(pin("oP", f"o{name}", sympy.S.Zero) for name in "QRS"))


def rectangles() -> Mechanism:
    """Bars from all corners of one rectangle to all of another with the same axes: 16, of 4 lengths."""
    one, other = ([[a * x, b * y] for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))] for x, y in ((3, 1), (2, 4)))
    return framework([*one, *other], [(i, j) for i in range(4) for j in range(4, 8)])


def queer_square() -> Mechanism:
    """Eight links in a square, flat, every second one on two hinges across its side of the square."""
    corner = [([1, 2, 0], Y), ([-1, 2, 0], Y), ([-2, 1, 0], X), ([-2, -1, 0], X)]
    return loop(*(("R", p, axis) for p, axis in corner), *(("R", [-c for c in p], axis) for p, axis in corner))


def turning_triangles() -> Mechanism:
    """Eight triangles in the planes of an octahedron's faces, neighbours on links with hinges along both normals.

    A triangle that turns in its plane leaves the centre so that its corners stay on those of its neighbours.
    """
    joints = []
    for i in range(3):
        for one, other in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            corner, sides = [0, 0, 0], []
            corner[(i + 1) % 3], corner[(i + 2) % 3] = one, Rational(other, 3)
            for side in (1, -1):
                normal = [side, side, side]
                normal[(i + 1) % 3], normal[(i + 2) % 3] = one, other
                sides.append(normal)
            link = f"link{i}_{one + 1}{other + 1}"
            faces = ["base" if n == [1, 1, 1] else "face" + "".join(str(c + 1) for c in n) for n in sides]
            joints += [("R", faces[0], link, corner, sides[0]), ("R", link, faces[1], corner, sides[1])]
    return graph(*joints)


def ball_joint_of_constant_velocity(balls: int) -> Mechanism:
    """Two races about a common centre, balls in circular grooves whose centres lie on either side of it."""
    places = [(1, 0), (Rational(-3, 5), Rational(4, 5)), (Rational(-5, 13), Rational(-12, 13)), (0, -1)][:balls]
    joints: list[Any] = [("S", "base", "race", [0, 0, 0], None)]
    for k, (c, s) in enumerate(places):
        joints += [("R", "race", f"in{k}", [0, 0, 1], [-s, c, 0]), ("S", f"in{k}", f"out{k}", [5 * c, 5 * s, 0], None),
                   ("R", f"out{k}", "base", [0, 0, -1], [-s, c, 0])]  # fmt: skip
    return graph(*joints)


def flat_octahedron(
    first: str = "0.5381", second: str = "1.4879", others: tuple[str, str] = ("3.68", "4.63")
) -> Mechanism:
    """Six faces of an octahedron, flat: two corners are the foci of an ellipse that four edges touch.

    `first`, `second`: eccentric angles at which edges touch it; those of the others, near `others`, are such that the
    dihedral angles at opposite corners are in the same ratio: then it opens (R. Bricard's third type, flat twice).
    """
    with mpmath.workdps(70):
        places = _flat_corners(*(mpmath.mpf(angle) for angle in (first, second, *others)))
        exact = [[Rational(mpmath.nstr(c, 60)) for c in place] for place in places]
    return octahedral([[*p, 0] for p in (exact[0], exact[1], (4, 0))], [[*p, 0] for p in (exact[2], exact[3], (-4, 0))])


def _flat_corners(first: Any, second: Any, third: Any, fourth: Any) -> list[tuple[Any, Any]]:
    """The corners where the tangents of the ellipse x^2/25 + y^2/9 = 1 meet, with equal ratios at opposite ones."""

    def corners(*angles: Any) -> list[tuple[Any, Any]]:
        lines = [(mpmath.cos(t) / 5, mpmath.sin(t) / 3) for t in angles]
        pairs = zip(lines, (*lines[1:], lines[0]), strict=True)
        return [((d - b) / (a * d - b * c), (a - c) / (a * d - b * c)) for (a, b), (c, d) in pairs]

    def ratio(corner: Any, one: Any, other: Any) -> Any:
        """sin((a - b)/2) / sin((a + b)/2) of the angles from the focus to the edges on either side."""
        x, y = (mpmath.acos(_cosine(corner, (4, 0), end)) for end in (one, other))
        return mpmath.sin((x - y) / 2) / mpmath.sin((x + y) / 2)

    def unequal(x: Any, y: Any) -> list[Any]:
        a, b, c, d = corners(first, second, x, y)
        return [ratio(a, b, d) - ratio(c, b, d), ratio(b, a, c) - ratio(d, a, c)]

    return corners(first, second, *mpmath.findroot(unequal, (third, fourth)))


def _cosine(corner: Any, one: Any, other: Any) -> Any:
    (a, b), (c, d) = ([x - y for x, y in zip(end, corner, strict=True)] for end in (one, other))
    return (a * c + b * d) / mpmath.sqrt((a * a + b * b) * (c * c + d * d))


HALF = Rational(1, 2)
HALF_OCTAHEDRON = ([3, 1, 0], [1, -2, 2], [-1, 2, 3])
CASES: dict[str, Case] = {
    "bricard line-symmetric": Case(line_symmetric, (1, 1, None, 1), "Bricard 1927; Baker 1997, MMT 32"),
    "bricard plane-symmetric": Case(plane_symmetric, (1, 1, None, 1), "Bricard 1927; Phillips 1990"),
    "waldron hybrid": Case(waldron_hybrid, (1, 1, None, 1), "Waldron 1968, J. Mechanisms 3"),
    "plano-spherical hybrid": Case(plano_spherical_hybrid, (1, 1, None, 1), "Bennett 1905; Waldron 1968"),
    "two bennetts": Case(two_bennetts, (1, 1, None, 6), "Bennett loops about one joint"),
    "three-limb sarrus": Case(three_limb_sarrus, (1, 1, None, 4), "Sarrus 1853, three limbs"),
    "five legs on a circle": Case(
        lambda: legs(CIRCLE), (8, 7, (6, 7), 2), "translations, or rotation about the centre"
    ),
    "five legs, no circle": Case(lambda: legs(NO_CIRCLE), (8, 7, (7,), 2), "translations only"),
    "octahedral, line-symmetric": Case(
        lambda: octahedral(HALF_OCTAHEDRON, [[-x, -y, z] for x, y, z in HALF_OCTAHEDRON]), (1, 1, None, 1),
        "Bricard 1897, type 1",
    ),
    "octahedral, plane-symmetric": Case(
        lambda: octahedral([[3, 2, 0], [-1, 3, 2], [0, 0, 4]], [[3, -2, 0], [-1, -3, 2], [1, 0, -3]]),
        (1, 1, None, 1), "Bricard 1897, type 2",
    ),
    "hexapod, line-symmetric": Case(line_symmetric_hexapod, (7, 7, None, 1), "Borel 1908; Bricard 1906: six spins"),
    "griffis-duffy": Case(griffis_duffy, (7, 7, None, 1), "Griffis, Duffy 1993; Husty, Karger 2000: six spins"),
    "octahedral, flat": Case(flat_octahedron, (3, 1, (1,), 3), "Bricard 1897, type 3; Bennett 1912"),
    "focal": Case(focal_mechanism, (1, 1, None, 14), "Kempe 1878; Burmester 1893: 11 pins in the plane, 2 redundant"),
    "rectangles": Case(rectangles, (1, 1, None, 31), "Dixon 1899, second kind; Wunderlich 1976"),
    "queer square": Case(
        queer_square, (5, 2, (2,), 3), "Wohlhart 1996: one pair of sides turns, or the other, or no corner does"
    ),
    "turning triangles": Case(turning_triangles, (1, 1, None, 7), "Fuller's jitterbug; Verheyen 1989, with hinges"),
    "rzeppa": Case(
        lambda: ball_joint_of_constant_velocity(3), (2, 2, None, 2), "Rzeppa 1936; Hunt 1978: races mirror each other"
    ),
    "dixon": Case(dixon, (1, 1, None, 13), "Dixon 1899; 9 bars in the plane, one redundant"),
    "hexagon": Case(hexagon, (1, 0, (), 13), "Bolker and Roth 1980"),
    "peaucellier": Case(peaucellier, (1, 1, None, 9), "Peaucellier 1864: planar, 3 loops"),
    "coupler point": Case(coupler_point_and_centre, (1, 0, (), 7), "Burmester: circle of curvature"),
    "origami degree 3": Case(lambda: origami([1, 0], [-1, 2], [-2, -3]), (1, 0, (), 4), "a corner of three faces"),
    "origami degree 4": Case(
        lambda: origami([1, 0], [0, 1], [-3, 1], [-1, -4]), (2, 1, (1,), 4), "two modes of a flat vertex"
    ),
    "origami degree 6": Case(
        lambda: origami([1, 0], [1, 2], [-1, 2], [-3, 1], [-1, -4], [2, -1]), (4, 3, (3,), 4), "Kapovich, Millson 1997"
    ),
    "miura folded": Case(lambda: miura(HALF), (1, 1, None, 13), "Miura 1985: one freedom"),
    "miura flat": Case(lambda: miura(0), (4, 2, (1, 2), 16), "one along the zigzag, or two straight lines"),
    "schoenflies": Case(schoenflies, (4, 4, None, 4), "Herve 1978: the group of dimension 4"),
    "3-PRS": Case(three_prs, (3, 3, None, 0), "Carretero et al. 2000"),
    "concurrent bars": Case(concurrent_bars, (1, 0, (), 7), "bars through one point"),
    "four parallel bars": Case(four_parallel_circle_translation, (1, 1, None, 11), "circular translation"),
    "4P": Case(
        lambda: loop(("P", [0, 0, 0], X), ("P", [0, 0, 0], Y), ("P", [0, 0, 0], Z), ("P", [0, 0, 0], [1, 2, 2])),
        (1, 1, None, 3), "four translations in space",
    ),
    "differential screw": Case(
        lambda: loop(
            ("H", [0, 0, 0], Z), ("H", [0, 0, 2], Z), ("P", [0, 0, 0], Z), pitches={0: HALF, 1: Rational(1, 3)}
        ),
        (1, 1, None, 4), "two pitches about one axis",
    ),
    "4H parallelogram": Case(
        lambda: loop(
            *(("H", [x, y, 0], Z) for x, y in ((0, 0), (4, 1), (6, 5), (2, 4))),
            pitches={0: HALF, 1: -HALF, 2: Rational(1, 3), 3: Rational(4, 3)},
        ),
        (1, 1, None, 3), "Delassus 1922: pitches with h1 - h2 + h3 - h4 = 0",
    ),
    "translations of two X": Case(
        lambda: loop(
            *(("R", [x, y, 0], Z) for x, y in ((0, 0), (4, 1), (6, 5))), ("P", [2, 4, 1], [1, 2, 2]),
            *(("R", [x, 0, z], Y) for x, z in ((1, 3), (5, 2), (3, 7))), ("P", [1, 1, 1], [2, 1, 2]),
        ),
        (3, 3, None, 1), "Herve and Sparacino 1991: X(u) and X(v) have the translations in common",
    ),
    "rhombus, two branches": Case(
        lambda: loop(("R", [0, 0, 0], Z), ("R", [1, 0, 0], Z), ("R", [2, 0, 0], Z), ("R", [1, 0, 0], Z)),
        (2, 1, (1,), 4), "rhombus, or B on D",
    ),
    "rhombus, folded": Case(
        lambda: loop(("R", [0, 0, 0], Z), ("R", [1, 0, 0], Z), ("R", [0, 0, 0], Z), ("R", [1, 0, 0], Z)),
        (2, 1, (1,), 4), "B on D, or C on A",
    ),
    "kite, collinear": Case(
        lambda: loop(("R", [0, 0, 0], Z), ("R", [2, 0, 0], Z), ("R", [3, 0, 0], Z), ("R", [2, 0, 0], Z)),
        (2, 1, (1,), 4), "kite, or B on D",
    ),
    "five-bar, collinear": Case(
        lambda: loop(*(("R", [x, 0, 0], Z) for x in (0, 1, 3, 4, 2))), (3, 2, (2,), 4), "a cone over a quadric"
    ),
    "five-bar, stretched": Case(
        lambda: loop(*(("R", [x, 0, 0], Z) for x in range(5))), (3, 0, (), 4), "one bar is the sum of the others"
    ),
    "spherical four-bar, stretched": Case(
        lambda: origami([1, 0], [3, 4], [0, 1], [-4, 3]), (2, 0, (), 4), "the longest arc is as long as the others"
    ),
    "two rhombi": Case(two_rhombi, (4, 2, (2,), 8), "the product of two crossings"),
    "cardan circles": Case(lambda: trammel(3, 4), (1, 1, None, 7), "the middle of the bar moves on a circle"),
    "no cardan circle": Case(
        lambda: trammel(Rational(9, 2), 2), (0, 0, None, 6), "other points move on ellipses, not about O"
    ),
    "universal legs": Case(universal_legs, (2, 2, None, 2), "circular translations"),
    "wunderlich": Case(wunderlich, (3, 2, (1, 2), 17), "Wunderlich 1954; Wohlhart 1996: kinematotropic"),
    "RCCC": Case(
        lambda: loop(
            ("R", [0, 0, 0], Z), ("C", [1, 0, 0], [1, 2, 2]), ("C", [3, 2, 1], [2, -1, 2]), ("C", [0, 4, 2], [3, 0, 4])
        ),
        (1, 1, None, 0), "Hunt 1978",
    ),
    "3S, collinear": Case(
        lambda: loop(("S", [0, 0, 0], None), ("S", [1, 0, 0], None), ("S", [3, 0, 0], None)),
        (4, 2, (2,), 1), "a flat triangle: spins only",
    ),
    "4S": Case(
        lambda: loop(*(("S", p, None) for p in ([0, 0, 0], [1, 0, 0], [1, 2, 0], [0, 1, 1]))),
        (6, 6, None, 0), "three spins, three motions of a spatial quadrilateral",
    ),
}  # fmt: skip
