"""The closure of a mechanism as polynomials, of which the components of its configuration space are read off.

    planar mechanisms: cosine and sine of every body's angle, lengths of slides; two equations a loop, linear in these
    two bodies joined by limbs: Study's parameters of one against the other, tangents of half the angles of some joints,
    and what is left of every limb as forms of degree 1 and 2 (`limb_equations`)
    more bodies that join three joints or more: `several_bodies`

The reference configuration is a known point of the zeros. What is not algebraic, or none of these, is said so.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from symscrew.algebra import cross, dot, subtract
from symscrew.description import Mechanism
from symscrew.mobility.components.closure_parts import (
    CHARTS,
    MOST_VARIABLES,
    ClosureEquations,
    Length,
    NotAlgebraicError,
    Vector,
    limb_of,
    turned_to,
)
from symscrew.mobility.components.limb_equations import PARAMETERS, applied
from symscrew.mobility.components.polynomials import (
    Polynomial,
    conjugate,
    constant,
    joint_factor,
    product,
    total,
    variable,
)
from symscrew.mobility.components.several_bodies import closure_of_several, joints_at, posed_bodies
from symscrew.mobility.joint_network import Network
from symscrew.mobility.symbols import Exact, ExactSystem, Field, NotDecidableError, across, exact_system


def closure_equations(
    mechanism: Mechanism, network: Network, chart: int = 0, *, fewest: bool = False
) -> ClosureEquations:
    """The polynomials of a mechanism; raises NotAlgebraicError with the reason where there are none.

    `chart`: below the length of `CHARTS`; in each every joint's variable lacks another angle. `fewest`: of a single
    loop, too, as few joints among the variables as limbs are cut out with, which then may not settle all joints.
    """
    if not network.chords:
        raise NotAlgebraicError("no loops")
    if network.ties:
        raise NotAlgebraicError("couplings of coordinates are not among the polynomials")
    looped = {name for loop in network.loops() for name, _ in loop}
    for name in sorted(looped):
        if any(motion.helical for motion, _ in network.edges[name].motions):
            raise NotAlgebraicError(f"the screw joint {name} is not algebraic")
    try:
        system = exact_system(mechanism)
        found = _planar(mechanism, network, system)
        if found is None and len(posed_bodies(network, looped)) > 2:
            found = closure_of_several(network, system, looped, chart)
        elif found is None:
            found = _between_two_bodies(network, system, looped, chart, fewest=fewest)
    except NotDecidableError as error:
        raise NotAlgebraicError(str(error)) from error
    if len(found.variables) > MOST_VARIABLES:
        raise NotAlgebraicError(f"{len(found.variables)} variables, more than {MOST_VARIABLES}")
    return found


def _planar(mechanism: Mechanism, network: Network, system: ExactSystem) -> ClosureEquations | None:
    """The equations of a mechanism whose hinges are parallel and whose slides lie across them; None otherwise."""
    edges = network.edges.values()
    if any(len(e.motions) != 1 or not (e.motions[0][0].revolute or e.motions[0][0].prismatic) for e in edges):
        return None
    axes = {e.name: system.screws[e.name][0] for e in edges}
    hinges = {e.name: _vector(axes[e.name][:3]) for e in edges if e.motions[0][0].revolute}
    slides = {e.name: _vector(axes[e.name][3:]) for e in edges if e.motions[0][0].prismatic}
    if not hinges:
        return None
    axis = next(iter(hinges.values()))
    if any(any(cross(axis, a)) for a in hinges.values()) or any(dot(axis, u) for u in slides.values()):
        return None
    number = mechanism.number
    points = {name: _vector([system.field.read(number(c)) for c in mechanism.joints[name].point]) for name in hinges}
    return _Planar(network, axis, points, slides).equations(system.field)


class _Planar:
    """Cosine c and sine s of each body's angle, s over the length of the axis; bodies that a slide joins share them."""

    def __init__(
        self, network: Network, axis: Vector, points: Mapping[str, Vector], slides: Mapping[str, Vector]
    ) -> None:
        self.network, self.axis, self.points, self.slides = network, axis, points, slides
        turning = {body: body for body in network.bodies}
        for name in slides:
            ends = [turning[b] for b in (network.edges[name].parent, network.edges[name].child)]
            first = network.ground if network.ground in ends else min(ends)
            turning = {body: first if home in ends else home for body, home in turning.items()}
        self.turning = turning
        self.homes = [b for b in dict.fromkeys(turning.values()) if b != network.ground]
        self.names = [v for b in self.homes for v in (f"c_{b}", f"s_{b}")] + [f"d_{name}" for name in slides]

    def equations(self, field: Field) -> ClosureEquations:
        """Two for each loop, and one for each angle."""
        count = len(self.names)
        square, one = dot(self.axis, self.axis), constant(Fraction(1), count)
        sides = across(self.axis, [bool(c) for c in self.axis])[:2]
        made = []
        for k in range(len(self.homes)):
            c, s = variable(2 * k, count), variable(2 * k + 1, count)
            made.append(c * c + (s * s).scaled(square) - one)
        for loop in self.network.loops():
            terms = list(self._steps(loop))
            for side in sides:
                made.append(total(self._component(body, vector, side) * length for body, vector, length in terms))
        reference = [Fraction(int(k % 2 == 0 and k < 2 * len(self.homes))) for k in range(count)]
        return ClosureEquations(
            tuple(self.names), tuple(p for p in made if p), tuple(reference), (), (), field, "angles of all bodies",
            axis=self.axis, turning=tuple(self.homes),
            lengths=tuple(Length(n, 0, 1, (*[Fraction(0)] * 3, *u), None) for n, u in self.slides.items()),
        )  # fmt: skip

    def _steps(self, loop: Sequence[tuple[str, int]]) -> Iterator[tuple[str, Vector, Polynomial]]:
        """(body that carries it, vector in the reference, length) of the steps around the loop."""
        count = len(self.names)
        one = constant(Fraction(1), count)
        hinges = [k for k, (name, _) in enumerate(loop) if name in self.points]
        loop = [*loop[hinges[0] :], *loop[: hinges[0]]] if hinges else loop
        for k, (name, sign) in enumerate(loop):
            edge = self.network.edges[name]
            body = self.turning[edge.child if sign > 0 else edge.parent]
            if name in self.slides:
                length = variable(2 * len(self.homes) + list(self.slides).index(name), count)
                yield body, self.slides[name], length.scaled(Fraction(sign))
                continue
            after = next((n for n, _ in [*loop[k + 1 :], *loop[:k]] if n in self.points), name)
            yield body, subtract(self.points[after], self.points[name]), one

    def _component(self, body: str, vector: Vector, side: Vector) -> Polynomial:
        """That of the turned vector along a side."""
        count = len(self.names)
        if body == self.network.ground:
            return constant(dot(vector, side), count)
        k = 2 * self.homes.index(body)
        turned = dot(cross(self.axis, vector), side)
        return variable(k, count).scaled(dot(vector, side)) + variable(k + 1, count).scaled(turned)


def _vector(values: Sequence[Exact]) -> Vector:
    x, y, z = values
    return x, y, z


def _between_two_bodies(
    network: Network, system: ExactSystem, looped: set[str], chart: int, *, fewest: bool
) -> ClosureEquations:
    """The equations of a mechanism of limbs between two bodies; a single loop is two limbs."""
    base, body, chains = limbs_between(network, looped)
    limbs = []
    for joints in chains:
        steps = [
            (name, k, sign, screw) for name, sign in joints for k, screw in list(enumerate(system.screws[name]))[::sign]
        ]
        limbs.append(limb_of(steps, single=len(chains) == 2 and not fewest))
    count = sum(len(limb.heads) for limb in limbs) + PARAMETERS
    names = [f"t{k + 1}" for k in range(count - PARAMETERS)] + ["x0", "x1", "x2", "x3", "y0", "y1", "y2", "y3"]
    first = count - PARAMETERS
    pose = [variable(first + k, count) for k in range(PARAMETERS)]
    made = [total(pose[k] * pose[k + 4] for k in range(4))]
    excluded = [total(p * p for p in pose[:4])]
    reference = [Fraction(int(k == first)) for k in range(count)]
    lengths = list[Length]()
    for limb in limbs:
        head = [constant(Fraction(int(k == 0)), count) for k in range(PARAMETERS)]
        for name, k, sign, screw in limb.heads:
            place = len(lengths)
            zero = CHARTS[
                (place + chart) % len(CHARTS)
            ]  # so that half a turn from the reference is no tangent at infinity
            tangent = variable(place, count)
            turned = [constant(c, count) for c in turned_to(screw, zero)]
            head = product(product(head, joint_factor(screw, tangent, count)), turned)
            square = dot(_vector(screw[:3]), _vector(screw[:3]))
            if square:
                excluded.append(constant(Fraction(1), count) + (tangent * tangent).scaled(square))
            reference[place] = -zero
            lengths.append(Length(name, k, sign, screw, zero))
        rest = product(conjugate(head), pose)
        made += [applied(form, rest) for form in limb.forms]
    what = f"pose of {body} against {base}" + (f" and {first} joint displacements" if first else "")
    return ClosureEquations(
        tuple(names), tuple(p for p in made if p), tuple(reference), tuple(range(first, count)), tuple(excluded),
        system.field, what, base, body, lengths=tuple(lengths), settles=all(limb.settled for limb in limbs),
    )  # fmt: skip


def limbs_between(network: Network, looped: set[str]) -> tuple[str, str, list[list[tuple[str, int]]]]:
    """(base, body, the joints of each limb from base to body with their senses) of two bodies with limbs between."""
    at = joints_at(network, looped)
    hubs = posed_bodies(network, looped)
    if not hubs:
        hubs = _opposite(network)
    if len(hubs) != 2:
        raise NotAlgebraicError(f"{len(hubs)} bodies join more than two joints: expected two with limbs between them")
    base, body = hubs
    limbs = []
    for first in at[base]:
        steps, here, name = list[tuple[str, int]](), base, first
        while True:
            edge = network.edges[name]
            steps.append((name, 1 if edge.parent == here else -1))
            here = edge.child if edge.parent == here else edge.parent
            if here in hubs:
                break
            name = next(n for n in at[here] if n != name)
        if here != body:
            raise NotAlgebraicError(f"{base} is joined with itself by {', '.join(n for n, _ in steps)}")
        limbs.append(steps)
    if sum(map(len, limbs)) != len(looped):
        raise NotAlgebraicError("loops that do not pass the two bodies")
    return base, body, limbs


def _opposite(network: Network) -> list[str]:
    """Of a single loop: its first body and the one half round, by freedoms."""
    loop = network.loops()[0]
    bodies, freedoms = [], []
    for name, sign in loop:
        edge = network.edges[name]
        bodies.append(edge.parent if sign > 0 else edge.child)
        freedoms.append(len(edge.screws))
    start = bodies.index(network.ground) if network.ground in bodies else 0
    order = [*range(start, len(bodies)), *range(start)]
    passed = 0
    for k in order:
        if 2 * passed >= sum(freedoms):
            return [bodies[start], bodies[k]]
        passed += freedoms[k]
    return [bodies[start], bodies[order[-1]]]
