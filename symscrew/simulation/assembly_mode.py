"""The assembly mode of a configuration: signs of determinants of the closure, the name that a regular motion keeps.

    closure Jacobian --without the rates that are held--> blocks of rows and rates --sign of each determinant--> name

Two ways to hold the mechanism tell its modes apart, as type 1 and type 2 of Gosselin and Angeles (IEEE Trans. Robotics
Autom. 6, 1990) tell its singularities: with the platform at rest every limb is a block, whose sign says on which side
its elbow is (the working mode of a platform on limbs); with the drives locked the sign says in which of its assemblies
the platform is. A determinant is zero only where the held rates do not determine the others: a motion on which none is
keeps all signs, over any number of turns; where one has changed, the motion has passed such a place. The signs are
those against the reference configuration. Configurations of one name need not be connected by a regular motion.

A block with more rows than rates (overconstrained loops) has no determinant of its own, but a volume, a sum of squares
without a sign. Its sign is that of as many of its rows as it has rates, always the same ones: it does not change where
these rows are independent, and can change where others hold the block.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.algebra import most_independent
from symscrew.loops import hub_links
from symscrew.model import Model

Array = np.ndarray
# An entry of the Jacobian, without units, that is below this at all sample states is zero: these are closed to 1e-12,
# and entries of a mechanism that are not zero are above 1e-6 somewhere.
NONE = 1e-9
# A block whose smallest singular value is below this part of its largest has no sign: rounding leaves 1e-14, and loops
# that are closed to 1e-9 a sign that may be any nearer to a singularity.
NO_SIGN = 1e-9
# Of two signs, whichever comes first.
PRODUCT = {frozenset("+"): "+", frozenset("-"): "+", frozenset("+-"): "-"}


@dataclass(frozen=True)
class Block:
    """Some rows and rates of the closure Jacobian, as many of each; `sign`: that of their determinant in general."""

    name: str
    rows: tuple[int, ...]
    rates: tuple[int, ...]
    sign: int = 1

    def signed(self, jacobian: Array) -> str:
        """ "+" where the determinant has the sign of the reference, "-" where it has the other, "0" near zero."""
        part = jacobian[np.ix_(self.rows, self.rates)]
        sizes = np.linalg.svd(part, compute_uv=False)
        if sizes[-1] < NO_SIGN * sizes[0] or not sizes[0]:
            return "0"
        return "+" if np.linalg.slogdet(part)[0] * self.sign > 0 else "-"


class AssemblyModes:
    """The blocks of a model's closure, found at its sample states; names of its configurations."""

    def __init__(self, model: Model, parameters: Array) -> None:
        """For run-time parameters (k,); a model without loops has one mode, without a name."""
        self.model, system = model, model.system
        self._more = [parameters] if len(parameters) else []
        self.rows = np.array([1 / system.length if r.unit == "N" else 1.0 for cut in system.cuts for r in cut.rows])
        self.of_places = np.array([row.holonomic for cut in system.cuts for row in cut.rows], dtype=bool)
        self.blocks: dict[str, tuple[Block, ...]] = {}
        if not system.cuts or "closure_jacobian" not in model.programs:
            return
        states = [self._jacobian(q) for q in (system.reference_at(parameters), *model.sample_q)]
        for way, held in self._held().items():
            self.blocks[way] = tuple(self._of(states, held))

    def name(self, q: Array) -> str:
        """The mode of a configuration q (nq,): `platform held: leg1 +, leg2 -; drives locked: +`; "" without loops."""
        if not any(self.blocks.values()):
            return ""
        jacobian = self._jacobian(q)
        parts = []
        for way, blocks in self.blocks.items():
            signs: dict[str, str] = {}
            for block in blocks:  # of one limb: its determinant is the product of theirs
                signs[block.name] = PRODUCT.get(frozenset(signs.get(block.name, "+") + block.signed(jacobian)), "0")
            told = [f"{name} {sign}" if len(signs) > 1 else sign for name, sign in signs.items()]
            parts += [f"{way}: {', '.join(told)}"] if told else []
        return "; ".join(parts)

    def _jacobian(self, q: Array) -> Array:
        """The closure Jacobian (rows, nv) without units."""
        (found,), _ = self.model("closure_jacobian", q, *self._more)
        scales = np.asarray(self.model.system.scales, dtype=float)
        matrix = found.reshape(len(scales), len(self.rows)).T * self.rows[:, None] * scales
        return np.asarray(matrix[self.of_places])  # rolling has no modes: a wheel may turn anywhere

    def _held(self) -> dict[str, set[int]]:
        """Ways to hold the mechanism: entries of v that rest."""
        system = self.model.system
        tree, found = system.tree, dict[str, set[int]]()
        platform = system.mechanism.platform
        if platform in tree.link_of_body and (tree.virtual or system.mechanism.limbs) and hub_links(system):
            path = tree.path(tree.link_of_body[platform])
            found["platform held"] = {k for i in path for k in range(tree.links[i].v.start, tree.links[i].v.stop)}
        drives = set(system.drive_rows())
        if drives and len(drives) == len(system.drives) == len(self.model.independent):
            found["drives locked"] = drives
        else:
            labels = [c.label for c in tree.q]
            independent = {labels.index(label) for label in self.model.independent}
            plain = {v for q, v in tree.plain if q in independent}
            if len(plain) == len(independent):
                found["independent coordinates held"] = plain
        return found

    def _of(self, states: Sequence[Array], held: set[int]) -> Iterator[Block]:
        """The blocks that are left when some rates are held, as far as these determine the others."""
        there = np.max([np.abs(jacobian) for jacobian in states], axis=0) > NONE
        left = {k for k in range(there.shape[1]) if k not in held and there[:, k].any()}
        while left:
            rates, rows = {min(left)}, set[int]()
            while (more := {int(i) for i in np.flatnonzero(there[:, sorted(rates)].any(axis=1))}) - rows:
                rows |= more
                rates |= {int(k) for k in np.flatnonzero(there[sorted(rows)].any(axis=0))} & left
            left -= rates
            block = self._chosen(states, sorted(rows), sorted(rates))
            if block is not None:
                yield block

    def _chosen(self, states: Sequence[Array], rows: list[int], rates: list[int]) -> Block | None:
        """The block with as many rows as rates, those most independent in a general configuration; None: too few."""
        if len(rows) < len(rates):
            return None
        parts = [jacobian[np.ix_(rows, rates)] for jacobian in states]
        general = max(parts, key=lambda part: float(np.linalg.svd(part, compute_uv=False)[-1]))
        block = Block(self._called(rates), tuple(rows[k] for k in most_independent(general)), tuple(rates))
        signs = [block.signed(jacobian) for jacobian in states]
        sure = next((sign for sign in signs if sign != "0"), None)  # the reference first, if it has one
        return None if sure is None else Block(block.name, block.rows, block.rates, 1 if sure == "+" else -1)

    def _called(self, rates: Sequence[int]) -> str:
        """The limb that rates belong to, or the first joint among them."""
        tree, limbs = self.model.system.tree, self.model.system.mechanism.limbs
        joints = dict.fromkeys(tree.v[k].joint for k in rates)
        return next((limb.name for limb in limbs.values() if set(joints) <= set(limb.joints)), next(iter(joints)))


def changed(start: str, end: str) -> tuple[str, ...]:
    """What is said of a motion between configurations of two names: nothing where they are the same."""
    if start == end:
        return ()
    pairs = list(zip(start.split("; "), end.split("; "), strict=True))
    apart = [f"{one} became {other.partition(': ')[2]}" for one, other in pairs if one != other]
    why = "a singular configuration, where a determinant is zero, was passed"
    if any("0" in sign for text in (start, end) for sign in _signs(text)):
        why = "a configuration whose sign is 0 is singular itself, and belongs to several modes"
    return (f"the assembly mode changed: {'; '.join(apart)}: {why}",)


def _signs(name: str) -> list[str]:
    """The signs in a name."""
    return [sign.split()[-1] for part in name.split("; ") if part for sign in part.partition(": ")[2].split(", ")]
