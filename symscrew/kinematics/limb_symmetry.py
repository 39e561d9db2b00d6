"""Equal limbs from the spanning tree: branches of one shape that leave the same link.

    shape of a link = its motion, whether it is a hub, and the shapes of the links on it, in an order of their own

Two branches of one shape have the same links in the same order of a walk, which gives every part its role. Where a limb
has equal branches of its own (the rods of a delta's arm), these are a family too, over all limbs of the outer one.
Shapes (Aho, Hopcroft and Ullman's of rooted trees) do not look at geometry, nor at which joint closes a loop: a limb
with another last joint, or at another place, does mostly the same; what it does otherwise shows where instructions are
compared.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import takewhile

from symscrew.kinematics.tree import GROUND, Link, Tree
from symscrew.program import Limb, Limbs

Shape = int


@dataclass
class _Walk:
    """The tree without the branches on `left_out`, its shapes as numbers."""

    tree: Tree
    left_out: frozenset[int] = frozenset()
    children: dict[int, list[int]] = field(default_factory=dict)
    shape: dict[int, Shape] = field(default_factory=dict)

    def __post_init__(self) -> None:
        known: dict[tuple[object, ...], Shape] = {}
        ends = cut_ends(self.tree)
        for link in reversed(self.tree.links[1:]):
            if link.index in self.left_out:
                continue
            inner = self.children.setdefault(link.index, [])
            inner.sort(key=lambda k: (self.shape[k], k))
            hub = ends[link.index] > 1  # several loops close at it
            key = (link.motion.kind, link.position, hub, *(self.shape[k] for k in inner))
            self.shape[link.index] = known.setdefault(key, len(known))
            self.children.setdefault(link.parent, []).append(link.index)
        self.children.setdefault(GROUND, []).sort(key=lambda k: (self.shape[k], k))

    def families(self) -> Iterator[list[int]]:
        """First links of equal limbs, outermost families first; links that are alone are looked through."""
        waiting: list[list[int]] = [[GROUND]]
        while waiting:
            equal = waiting.pop(0)
            for places in zip(*(self._groups(root) for root in equal), strict=True):
                group = [k for place in places for k in place]
                if len(group) > 1 and len(places[0]) > 1:
                    yield sorted(group)
                waiting.append(group)

    def _groups(self, root: int) -> list[list[int]]:
        """The links on a link by shape, in the order of shapes."""
        groups: dict[Shape, list[int]] = {}
        for k in self.children.get(root, ()):
            groups.setdefault(self.shape[k], []).append(k)
        return list(groups.values())

    def branch(self, root: int) -> list[Link]:
        """The links of a branch in an order that is the same for equal ones."""
        stack, found = [root], []
        while stack:
            k = stack.pop()
            found.append(self.tree.links[k])
            stack += self.children.get(k, ())[::-1]
        return found


def cut_ends(tree: Tree) -> Counter[int]:
    """How many loops close at every link."""
    return Counter(tree.link_of_body[body] for joint in tree.cut for body in (joint.parent, joint.child))


def equal_limbs(tree: Tree, platform: str | None) -> Limbs:
    """The families of equal limbs of a tree, without its platform where more is equal then."""
    walks = [_Walk(tree)]
    if platform in tree.link_of_body and tree.link_of_body[platform] != GROUND:
        walks.append(_Walk(tree, _outboard(tree, tree.link_of_body[platform])))
    found = [(walk, list(walk.families())) for walk in walks]
    walk, families = max(found, key=lambda way: _covered(*way))
    return Limbs(tuple(_named([walk.branch(root) for root in family], tree) for family in families))


def _covered(walk: _Walk, families: Sequence[Sequence[int]]) -> int:
    """How many links are in a limb that has equals."""
    return len({link.index for family in families for root in family for link in walk.branch(root)})


def _outboard(tree: Tree, link: int) -> frozenset[int]:
    """A link and all that hangs on it."""
    found = {link}
    for other in tree.links[1:]:
        if other.parent in found:
            found.add(other.index)
    return frozenset(found)


def _named(branches: Sequence[Sequence[Link]], tree: Tree) -> tuple[Limb, ...]:
    names = [_prefix([body for link in branch for body in link.bodies]) for branch in branches]
    if not all(names) or len(set(names)) < len(names):
        names = [tree.part(branch[0].index) for branch in branches]
    return tuple(Limb(name, _parts(branch, tree)) for name, branch in zip(names, branches, strict=True))


def _prefix(bodies: Sequence[str]) -> str:
    """What the names of bodies have in common, up to an underscore; the name of one alone."""
    if len(bodies) == 1:
        return bodies[0]
    alike = takewhile(lambda letters: len(set(letters)) == 1, zip(*bodies, strict=False))
    common = "".join(letters[0] for letters in alike)
    return common[: common.rfind("_")] if "_" in common else ""


def _parts(branch: Sequence[Link], tree: Tree) -> dict[str, str]:
    """Role of every body, joint and motion of a branch: the place in the walk, and what it is there."""
    parts: dict[str, str] = {}
    place = {link.index: k for k, link in enumerate(branch)}
    for k, link in enumerate(branch):
        parts.setdefault(tree.part(link.index), f"link {k}")
        parts.setdefault(link.joint, f"joint {k}")
        parts.update({body: f"body {k}.{n}" for n, body in enumerate(link.bodies) if body not in parts})
    counts: dict[int, int] = {}
    ends = cut_ends(tree)
    for joint in tree.cut:  # it belongs to the branch whose tip it is: that which is no hub, or longer
        both = [tree.link_of_body[body] for body in (joint.child, joint.parent)]
        end = max(both, key=lambda k: (ends[k] == 1, len(tree.path(k))))
        if end in place:
            n = counts[place[end]] = counts.get(place[end], -1) + 1
            parts.setdefault(joint.name, f"cut {place[end]}.{n}")
    return parts
