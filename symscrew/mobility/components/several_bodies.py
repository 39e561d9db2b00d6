"""The closure of a mechanism with several bodies that join more than two joints, as polynomials.

    one of them that chains of one freedom do not pose --> Study's parameters
    the others --chains with fewest freedoms--> each posed against one before it, by tangents of half the angles
    all other chains between two of them: forms of degree 1 and 2 of one's pose against the other (`limb_equations`)

So the arms of a delta are three tangents and its platform eight parameters, and the four panels about the middle one of
a folded sheet are four tangents.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from symscrew.mobility.components.closure_parts import (
    CHARTS,
    ClosureEquations,
    Length,
    NotAlgebraicError,
    Step,
    limb_of,
    turned_to,
)
from symscrew.mobility.components.limb_equations import PARAMETERS, applied
from symscrew.mobility.components.polynomials import (
    Dual,
    Polynomial,
    conjugate,
    constant,
    joint_factor,
    product,
    total,
    variable,
)
from symscrew.mobility.joint_network import Network
from symscrew.mobility.symbols import ExactSystem

Chain = tuple[str, str, tuple[Step, ...]]
"""The bodies at its ends and its freedoms from the first to the second."""


def closure_of_several(network: Network, system: ExactSystem, looped: set[str], chart: int = 0) -> ClosureEquations:
    """The polynomials of loops with these joints; raises NotAlgebraicError; `chart` as of `closure_equations`."""
    hubs, chains = _chains(network, system, looped)
    root = network.ground if network.ground in hubs else hubs[0]
    placed, free, left = _placed(root, hubs, chains)
    limbs = [limb_of(steps, single=False) for _, _, steps in left]
    steps = [step for _, _, own in placed for step in own] + [step for limb in limbs for step in limb.heads]
    count = len(steps) + (PARAMETERS if free else 0)
    lengths = [
        Length(name, k, sign, screw, CHARTS[(i + chart) % len(CHARTS)])
        for i, (name, k, sign, screw) in enumerate(steps)
    ]
    factors = [_factor(length, i, count) for i, length in enumerate(lengths)]
    poses: dict[str, Dual] = {root: [constant(Fraction(int(k == 0)), count) for k in range(PARAMETERS)]}
    made, excluded = list[Polynomial](), list[Polynomial]()
    if free:
        x = [variable(len(steps) + k, count) for k in range(PARAMETERS)]
        poses[free] = x
        made.append(total(x[k] * x[k + 4] for k in range(4)))
        excluded.append(total(p * p for p in x[:4]))
    following = iter(factors)
    for first, second, own in placed:
        poses[second] = poses[first]
        for _ in own:
            poses[second] = product(poses[second], next(following))
    for (first, second, _), limb in zip(left, limbs, strict=True):
        head = poses[first]
        for _ in limb.heads:
            head = product(head, next(following))
        made += [applied(form, product(conjugate(head), poses[second])) for form in limb.forms]
    for i, length in enumerate(lengths):
        square = sum((c * c for c in length.screw[:3]), start=Fraction(0))
        if square:
            excluded.append(constant(Fraction(1), count) + (variable(i, count) * variable(i, count)).scaled(square))
    names = [f"t{k + 1}" for k in range(len(steps))]
    reference = [-(length.zero or Fraction(0)) for length in lengths]
    if free:
        names += ["x0", "x1", "x2", "x3", "y0", "y1", "y2", "y3"]
        reference += [Fraction(int(k == 0)) for k in range(PARAMETERS)]
    what = f"pose of {free} against {root} and " if free else ""
    return ClosureEquations(
        tuple(names), tuple(p for p in made if p), tuple(reference), tuple(range(len(steps), count)), tuple(excluded),
        system.field, f"{what}{len(steps)} joint displacements", root if free else "", free, lengths=tuple(lengths),
        settles=all(limb.settled for limb in limbs),
    )  # fmt: skip


def joints_at(network: Network, looped: set[str]) -> dict[str, list[str]]:
    """Of these joints those at each body."""
    at: dict[str, list[str]] = {}
    for name in network.edges:
        if name in looped:
            for end in (network.edges[name].parent, network.edges[name].child):
                at.setdefault(end, []).append(name)
    return at


def posed_bodies(network: Network, looped: set[str]) -> list[str]:
    """The bodies that join more than two of these joints."""
    at = joints_at(network, looped)
    return [body for body in network.bodies if len(at.get(body, ())) > 2]


def _chains(network: Network, system: ExactSystem, looped: set[str]) -> tuple[list[str], list[Chain]]:
    """The bodies that join more than two joints, and what is between two of them."""
    at, hubs = joints_at(network, looped), posed_bodies(network, looped)
    chains, passed = list[Chain](), set[str]()
    for hub in hubs:
        for first in at[hub]:
            if first in passed:
                continue
            steps, here, name = list[Step](), hub, first
            while True:
                passed.add(name)
                edge = network.edges[name]
                sign = 1 if edge.parent == here else -1
                steps += [(name, k, sign, screw) for k, screw in list(enumerate(system.screws[name]))[::sign]]
                here = edge.child if edge.parent == here else edge.parent
                if here in hubs:
                    break
                name = next(n for n in at[here] if n != name)
            if here == hub:
                raise NotAlgebraicError(f"{hub} is joined with itself by {steps[0][0]}")
            chains.append((hub, here, tuple(steps)))
    if len(hubs) < 2 or passed != looped:
        raise NotAlgebraicError("loops without two bodies that join more than two joints")
    return hubs, chains


def _placed(root: str, hubs: Sequence[str], chains: Sequence[Chain]) -> tuple[list[Chain], str, list[Chain]]:
    """(chains that place a body each, the body with Study's parameters or none, the other chains)."""
    known, free, used, left = {root}, "", list[Chain](), list(chains)
    while len(known) < len(hubs):
        one = min((c for c in left if len(known & set(c[:2])) == 1), key=lambda c: len(c[2]), default=None)
        if one is not None and (len(one[2]) == 1 or free):
            left.remove(one)
            used.append(one if one[0] in known else _reversed(one))
            known |= set(one[:2])
        elif free:
            raise NotAlgebraicError("bodies that no chain joins with the others")
        else:  # the one that is joined with most others
            joined = {hub: {end for c in left if hub in c[:2] for end in c[:2]} for hub in hubs if hub not in known}
            free = max(joined, key=lambda hub: len(joined[hub]))
            known.add(free)
    return used, free, left


def _reversed(chain: Chain) -> Chain:
    first, second, steps = chain
    return second, first, tuple((name, k, -sign, screw) for name, k, sign, screw in steps[::-1])


def _factor(length: Length, place: int, count: int) -> Dual:
    """The displacement of a freedom whose tangent is one of the variables."""
    zero = length.zero or Fraction(0)
    turned = [constant(c, count) for c in turned_to(length.screw, zero)]
    return product(joint_factor(length.screw, variable(place, count), count), turned)
