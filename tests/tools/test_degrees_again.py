"""Degrees of components once more: equations typed here from joints' points, cut by random planes modulo a large prime,
points counted by a basis in lexicographic order. No equation, order, prime or decomposition of the package's is used
for those that are typed; of spatial loops and platforms with long equations the package's are cut the same way.
"""

from __future__ import annotations

import random
import re
import shutil
from collections.abc import Callable, Sequence

import pytest
import sympy
from support.further_mechanisms import CASES
from support.parallel_mechanisms import cells, double_parallelogram
from support.reference_mechanisms import ENTRIES, build

from symscrew import catalogue
from symscrew.description.mechanism import Mechanism
from symscrew.mobility.components import (
    ALGEBRA_PROGRAM,
    ConfigurationSpace,
    algebra_answer,
    closure_equations,
    configuration_space,
)
from symscrew.mobility.components.exact_parts import variable_names
from symscrew.mobility.joint_network import network_of

pytestmark = pytest.mark.skipif(shutil.which(ALGEBRA_PROGRAM) is None, reason="Singular is not installed (singular-ui)")

SECONDS = 8.0


def mechanism(name: str) -> Mechanism:
    made: dict[str, Callable[[], Mechanism]] = {"double parallelogram": double_parallelogram}
    if name in made:
        return made[name]()
    if name == "two cells":
        return cells(2)
    if name in ENTRIES:
        return build(ENTRIES[name])
    return CASES[name].make() if name in CASES else catalogue.load(name)


class Modulo:
    """Numbers of descriptions modulo a prime in which their square roots are."""

    def __init__(self, prime: int) -> None:
        self.prime = prime

    def __call__(self, number: sympy.Expr | int) -> int:
        e = sympy.nsimplify(number) if isinstance(number, int) else sympy.sympify(number)
        if e.is_Rational:
            return int(e.p) * pow(int(e.q), -1, self.prime) % self.prime
        if e.is_Add or e.is_Mul:
            total = 0 if e.is_Add else 1
            for part in e.args:
                total = (total + self(part) if e.is_Add else total * self(part)) % self.prime
            return total
        base, power = e.as_base_exp()
        assert power.is_Rational and power.q in (1, 2), e
        if power.q == 1:
            return pow(self(base), int(power.p), self.prime)
        root = sympy.ntheory.sqrt_mod(self(base), self.prime)
        if root is None:
            raise NoRootError
        return pow(int(root), int(power.p), self.prime)


class NoRootError(Exception):
    """The prime has no such square root: another one may."""


def points(names: Sequence[str], equations: Sequence[str], planes: int, modulo: Modulo) -> list[int]:
    """Degrees of the factors of what tells the points on so many random planes; refused where points are multiple."""
    chosen = random.Random(7)

    def plane(constant: str) -> str:
        own = (f"{chosen.randint(1, modulo.prime - 1)}*{n}" for n in names if n != "w")  # w is of no coordinate
        return "+".join([*own, constant])

    cuts = [plane(str(chosen.randint(1, modulo.prime - 1))) for _ in range(planes)]
    text = ",\n".join([*equations, *cuts, plane("u")])
    answer = algebra_answer(
        f"""LIB "general.lib"; ring r = {modulo.prime}, ({",".join(names)},u), dp; option(redSB); short = 0;
        ideal K = std(ideal({text})); print("@size " + string(dim(K)) + " " + string(vdim(K)));
        ring s = {modulo.prime}, ({",".join(names)},u), lp; option(redSB);
        ideal L = fglm(r, K); poly f = L[1]; int i;
        print("@last " + string(deg(f)) + " " + string(deg(gcd(f, diff(f, u)))));
        list F = factorize(f, 1); print("@factors");
        for (i = 1; i <= ncols(F[1]); i++) {{ print(deg(F[1][i])); }}
        print("@end"); quit;""",
        SECONDS,
    )
    assert answer is not None and answer[1], answer
    size = re.search(r"@size (-?\d+) (-?\d+)", answer[0])
    last = re.search(r"@last (\d+) (-?\d+)", answer[0])
    assert size and last
    assert (size[1], last[2]) == ("0", "0") and size[2] == last[1], answer[0]  # all points are simple
    return sorted(map(int, answer[0].partition("@factors")[2].partition("@end")[0].split()))


def planar(given: Mechanism, modulo: Modulo) -> tuple[list[str], list[str]]:
    """Cosine and sine of each body's angle; vectors from hinge to hinge close around each loop."""
    joints = list(given.joints.values())
    reached: dict[str, list[tuple[str, list[int]]]] = {given.ground: []}  # body -> (body, vector in it) on the way
    last: dict[str, list[int]] = {given.ground: [0, 0]}  # body -> the point of it where the way arrives
    at = {joint.name: [modulo(given.number(c)) for c in joint.point[:2]] for joint in joints}
    left, chords = list(joints), []
    while left:
        joint = next(j for j in left if j.parent in reached or j.child in reached)
        left.remove(joint)
        if joint.parent in reached and joint.child in reached:
            chords.append(joint)
            continue
        near, far = (joint.parent, joint.child) if joint.parent in reached else (joint.child, joint.parent)
        reached[far] = [*reached[near], (near, [a - b for a, b in zip(at[joint.name], last[near], strict=True)])]
        last[far] = at[joint.name]
    bodies = [body for body in reached if body != given.ground]
    names = [f"{letter}{k}" for k in range(len(bodies)) for letter in "cs"]
    place = {body: k for k, body in enumerate(bodies)}
    equations = [f"c{k}^2+s{k}^2-1" for k in range(len(bodies))]
    for joint in chords:
        x, y = [], []
        for sense, end in ((1, joint.parent), (-1, joint.child)):
            way = [*reached[end], (end, [a - b for a, b in zip(at[joint.name], last[end], strict=True)])]
            for body, (a, b) in way:
                c, s = ("1", "0") if body == given.ground else (f"c{place[body]}", f"s{place[body]}")
                x += [f"({sense * a})*{c}", f"({-sense * b})*{s}"]
                y += [f"({sense * a})*{s}", f"({sense * b})*{c}"]
        equations += ["+".join(x), "+".join(y)]
    return names, equations


def rotated(v: Sequence[int]) -> list[str]:
    """R v, times the square of the quaternion, by Euler and Rodrigues."""
    square = {0: "(x0^2+x1^2-x2^2-x3^2)", 1: "(x0^2-x1^2+x2^2-x3^2)", 2: "(x0^2-x1^2-x2^2+x3^2)"}
    mixed = {(0, 1): "2*(x1*x2-x0*x3)", (0, 2): "2*(x1*x3+x0*x2)", (1, 0): "2*(x1*x2+x0*x3)",
             (1, 2): "2*(x2*x3-x0*x1)", (2, 0): "2*(x1*x3-x0*x2)", (2, 1): "2*(x2*x3+x0*x1)"}  # fmt: skip
    return ["+".join(f"({v[j]})*{square[i] if i == j else mixed[i, j]}" for j in range(3)) for i in range(3)]


SHIFT = ["2*(x0*y1-y0*x1+y2*x3-y3*x2)", "2*(x0*y2-y0*x2+y3*x1-y1*x3)", "2*(x0*y3-y0*x3+y1*x2-y2*x1)"]
"""The translation, times the square of the quaternion (Husty 1996); which way y is signed changes no degree."""


def in_planes(given: Mechanism, modulo: Modulo) -> tuple[list[str], list[str]]:
    """Balls of a platform that stay in planes: a slide and a hinge hold them there, across which the hinge turns."""
    equations = ["x0*y0+x1*y1+x2*y2+x3*y3", "w*(x0^2+x1^2+x2^2+x3^2)-1"]
    for limb in given.limbs.values():
        joints = [given.joints[name] for name in limb.joints]
        (hinge,) = (j for j in joints if j.type == "R")
        (ball,) = (j for j in joints if j.type == "S")
        (normal,) = ([modulo(given.number(c)) for c in axis] for axis in hinge.axes)
        tip, foot = ([modulo(given.number(c)) for c in j.point] for j in (ball, hinge))
        moved = [f"{a}+{b}" for a, b in zip(rotated(tip), SHIFT, strict=True)]
        height = sum(n * c for n, c in zip(normal, foot, strict=True))
        terms = [f"({n})*({m})" for n, m in zip(normal, moved, strict=True)]
        equations.append("+".join([*terms, f"({-height})*(x0^2+x1^2+x2^2+x3^2)"]))
    return ["w", *(f"{letter}{k}" for letter in "xy" for k in range(4))], equations


Form = Callable[[Mechanism, Modulo], tuple[list[str], list[str]]]


def by_package(given: Mechanism, modulo: Modulo) -> tuple[list[str], list[str]]:
    """The package's equations of rational mechanisms; only how they are counted is another."""
    closure = closure_equations(given, network_of(given))
    names = variable_names(closure)
    assert not closure.field.generators and modulo.prime
    texts = [p.text(names, [], []) for p in (*closure.equations, *closure.excluded)]
    never = "*".join(f"({text})" for text in texts[len(closure.equations) :])
    return ["w", *names], [*texts[: len(closure.equations)], f"w*{never}-1" if never else "w-1"]


def cut(form: Form, given: Mechanism, planes: int) -> list[list[int]]:
    """The factors' degrees modulo two primes."""
    found, prime = list[list[int]](), 1 << 29
    while len(found) < 2:
        prime = int(sympy.prevprime(prime))
        modulo = Modulo(prime)
        try:
            names, equations = form(given, modulo)
        except NoRootError:
            continue
        found.append(points(names, equations, planes, modulo))
    return found


@pytest.mark.parametrize(
    "form, name, planes, degree",
    [
        (planar, "planar_4bar", 1, 6), (planar, "parallelogram", 1, 2 + 4), (planar, "five_bar", 2, 14),
        (planar, "planar_5bar", 2, 14), (planar, "double_watt_cusp", 1, 52), (planar, "double parallelogram", 1, 2),
        (planar, "threebar_parallel_equal", 1, 2), (planar, "kinematotropic_double_fold", 2, 4),
        (planar, "two cells", 2, 4 + 8 + 8 + 16), (planar, "andrews", 1, 36), (planar, "planar_3rrr", 3, 106),
        (in_planes, "3rps", 4, 7 + 7),
        (by_package, "3-PRS", 4, 8), (by_package, "origami degree 4", 2, 4), (by_package, "origami degree 6", 4, 16),
        (by_package, "bennett", 2, 2), (by_package, "goldberg_5r", 2, 4), (by_package, "sarrus-stretched", 3, 1),
    ],
)  # fmt: skip
def test_degrees_by_planes_and_points(form: Form, name: str, planes: int, degree: int) -> None:
    """Sums over the components of the largest dimension, as in the tests of operation modes; none of these is double.

    Planes that are one more than the dimension: of Study's parameters only ratios matter, so that they are cones.
    """
    assert all(sum(factors) == degree for factors in cut(form, mechanism(name), planes))


@pytest.mark.parametrize("name, form", [("planar_4bar", planar), ("parallelogram", planar), ("3-PRS", by_package)])
def test_the_package_finds_these_degrees(name: str, form: Form) -> None:
    given = mechanism(name)
    found = configuration_space(given, network_of(given))
    assert isinstance(found, ConfigurationSpace) and found.proved
    dimension = max(part.dimension for part in found.parts)
    ratios = "x0" in found.variables
    listed = sum(part.degree for part in found.parts if part.dimension == dimension)
    assert {sum(factors) for factors in cut(form, given, dimension + ratios)} == {listed}


def test_a_plane_too_few_or_a_double_point_is_no_count() -> None:
    with pytest.raises(AssertionError):
        cut(planar, mechanism("planar_5bar"), 1)
    with pytest.raises(AssertionError):  # a line that is there twice
        points(["x", "y"], ["(x-y)^2"], 1, Modulo(536870909))
