"""Closed forms for limbs: joint coordinates from where the platform holds the limb's tip.

Each kind of limb gives cosine and sine of its angles without trigonometry, and its slides. Square roots have
two signs: those of a guess, so that the limb stays on the guess's branch.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import dataclass, field

from symscrew.algebra import ZERO, Node, needed
from symscrew.kinematics import GROUND, Cut, Link, Row, System, Turn
from symscrew.loops.limbs.crank_limbs import crank_limb, rod_limb
from symscrew.loops.limbs.limb_form import LimbForm
from symscrew.loops.limbs.planar_limbs import planar_limb
from symscrew.loops.limbs.spoke_limbs import spoke_limb

FORMS: tuple[Callable[[System, Cut], LimbForm | None], ...] = (
    spoke_limb,
    planar_limb,
    crank_limb,
    rod_limb,  # last: a rod is part of a crank's limb where there is one
)
"""The classes of limbs, in the order in which a limb is asked for its own. A further one is a file and a line here."""


@dataclass(frozen=True)
class LimbCoordinates:
    """q with the limbs' entries put in, and cosine and sine of the limbs' angles by link.

    `reach`: (limb's name, radicand [any unit]): below zero the limb does not get to where the platform holds it.
    `openings`: of rows that the limbs leave open, by label, how far they are [m], where limbs know it themselves.
    """

    q: tuple[Node, ...]
    turns: dict[int, Turn]
    reach: tuple[tuple[str, Node], ...] = ()
    openings: Mapping[str, Node] = field(default_factory=dict)


def hub_links(system: System) -> tuple[Link, ...] | None:
    """The links of the platform's own joint, if it hangs on a single joint from the ground; else None."""
    platform = system.mechanism.platform
    if platform is None or platform not in system.tree.link_of_body or not system.cuts:
        return None
    links = tuple(system.tree.links[i] for i in reversed(system.tree.path(system.tree.link_of_body[platform])))
    return links if links and len({link.joint for link in links}) == 1 else None


def closed_limbs(system: System) -> tuple[LimbForm, ...] | None:
    """All limbs, if the platform hangs on one joint and every other link belongs to a limb with a closed form.

    A limb comes after those that carry it: the further rods of a crank after the first, which turns the crank.
    """
    hub = hub_links(system)
    if hub is None:
        return None
    limbs: list[LimbForm] = []
    covered = {GROUND}
    for cut in system.cuts:
        limb = _limb(system, cut, covered)
        forces = sum(row.unit == "N" and row.couple is ZERO for row in cut.rows)
        if limb is None or cut.hub != hub[-1].index or forces != 3:
            return None
        limbs.append(limb)
        covered |= {link.index for link in limb.links}
    free = set(range(len(system.tree.links))) - covered
    return tuple(limbs) if free == {link.index for link in hub} else None


def met_rows(limbs: Sequence[LimbForm]) -> frozenset[str]:
    """Labels of the closure's rows that hold for all coordinates of the platform once its limbs are in closed form.

    The others are left to be solved for the platform's coordinates: see `left_open` of a limb.
    """
    return frozenset(row.label for limb in limbs for k, row in enumerate(_forces(limb)) if k not in limb.left_open)


def _forces(limb: LimbForm) -> list[Row]:
    """The rows of a limb's cut joint that say where its tip is."""
    return [row for row in limb.cut.rows if row.unit == "N"]


def any_rods(limbs: Sequence[LimbForm]) -> bool:
    """Whether there are rods among the limbs, with or without a crank."""
    return any(limb.through_rods for limb in limbs)


def _limb(system: System, cut: Cut, covered: Set[int]) -> LimbForm | None:
    """The cut joint's limb, all links of which are new and hang on one that is covered, if it has a closed form.

    A coupling has none, and the limbs that it ties to each other are not solved one by one; nor has a rolling wheel.
    """
    if not cut.is_joint:
        return None
    for form in FORMS:
        limb = form(system, cut)
        if limb and limb.links[0].parent in covered and not covered & {link.index for link in limb.links}:
            return limb
    return None


def limb_coordinates(
    system: System, limbs: Sequence[LimbForm], hub_q: dict[int, Node], guess: Sequence[Node] | None = None
) -> LimbCoordinates:
    """q of the tree [rad, m] for given coordinates of the platform's joint; its limbs in closed form.

    `hub_q`: index into q -> node. Out of a limb's reach its entries are not numbers, and the status tells.
    Angles are those nearest to the `guess` (nodes of q; default: the reference configuration), on its branch.
    """
    tape, zero = system.tape, system.tape.zero
    near = tuple(guess) if guess is not None else reference_nodes(system)
    q = [hub_q.get(k, zero) for k in range(len(system.tree.q))]
    turning = [link.index for link in system.tree.links[1:] if link.motion.single and link.motion.turns]
    own = {link.index for limb in limbs for link in limb.links}
    turns: dict[int, Turn] = {i: (tape.one, zero) for i in turning if i in own}  # until they are found
    reach: dict[Node, str] = {}
    openings: dict[str, Node] = {}
    for limb in limbs:
        linkage = system.structure.linkage(q, turns)
        target = limb.target(linkage)
        found, slides = limb.solve(system, target, near)
        opening = limb.opening(system, target)
        if opening is not None:
            openings |= {row.label: opening for k, row in enumerate(_forces(limb)) if k in limb.left_open}
        turns |= found
        for radicand in radicands([*(node for turn in found.values() for node in turn), *slides.values()]):
            reach.setdefault(radicand, _name(system, limb))
        for k, value in slides.items():
            q[k] = value
        for index, turn in found.items():
            link = system.tree.links[index]
            q[link.q.start] = _angle(system, link, turn, near)
    return LimbCoordinates(tuple(q), turns, tuple((name, radicand) for radicand, name in reach.items()), openings)


def radicands(results: Sequence[Node]) -> list[Node]:
    """Under the square roots that results need: what can be negative, which a sum of squares cannot."""
    roots = sorted((node for node in needed(results) if node.op == "sqrt"), key=lambda node: node.index)
    return [root.args[0] for root in roots if not _square(root.args[0])]


def _square(node: Node) -> bool:
    """Whether a node is a square, a constant that is not negative, or a sum of such."""
    if node.value is not None:
        return bool(node.value >= 0)
    if node.op == "mul":
        one, other = node.args
        return one is other or (_square(one) and _square(other))
    return node.op == "sqrt" or (node.op == "add" and all(map(_square, node.args)))


def _name(system: System, limb: LimbForm) -> str:
    """The limb's name in the description, or that of its first joint."""
    named = system.mechanism.limbs.values()
    return next((one.name for one in named if limb.cut.joint.name in one.joints), limb.links[0].joint)


def reference_nodes(system: System) -> tuple[Node, ...]:
    """q of the reference configuration as constants."""
    result = [system.tape.zero] * len(system.tree.q)
    for link, frame in zip(system.tree.links[1:], system.frames[1:], strict=True):
        if link.motion.spherical:
            result[link.q.start] = system.tape.one
        elif link.q.stop > link.q.start:
            result[link.q.start] = system.tape.node(frame.reference)
    return tuple(result)


def _angle(system: System, link: Link, turn: Turn, guess: Sequence[Node]) -> Node:
    """The joint's coordinate nearest to the guess from cosine and sine of coordinate + phase."""
    tape, near = system.tape, guess[link.q.start]
    angle = near + system.frames[link.index].phase
    c, s = tape.function("cos", angle), tape.function("sin", angle)
    cosine, sine = turn
    nearest: Node = near + tape.function("atan2", sine * c - cosine * s, cosine * c + sine * s)
    return nearest
