"""Evidence for real motion, part by part: groups of loops and limbs, self-stresses, quadratic forms, directions.

    part of the mechanism --what is cheapest and says most first--> the proof that its checker accepts, or none

Every proof is given to the checker before it is used; what the checker does not accept is no proof here either.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np

from symscrew.mobility.finite import cone_directions, definite_stress
from symscrew.mobility.proofs.arcs import shut_arc
from symscrew.mobility.proofs.proof_checker import (
    MOST_WAYS,
    WHOLE,
    Block,
    Mechanism,
    Number,
    RefusedError,
    Screw,
    at_least,
    bracket,
)
from symscrew.mobility.proofs.proof_numbers import ProofNumbers
from symscrew.mobility.proofs.rank_proofs import rank_entry
from symscrew.mobility.symbols import Exact, NotDecidableError, null_vectors, reduced

ORDERS = 6
"""Highest order at which a single motion is looked at, as for finite mobility."""
REGULAR = 1e-6
"""Relative eigenvalue, and singular value of the forms at a direction, that is worth a proof in intervals."""
DIGITS = 10**9
"""Denominator of directions, weights and bases of forms that come from doubles: nothing rests on their last digits."""
RADIUS = Fraction(1, 10**6)
"""Of Krawczyk's box around a direction: a thousand times the rounding of its centre."""
SEED = 20230811
"""Of the starts for directions: always the same, so that results repeat."""
FLAT = 1e-12
"""A value of a self-stress on a group that is rounding."""
NONE: dict[str, Any] = {"kind": "none"}


def block_entry(numbers: ProofNumbers, index: int) -> dict[str, Any]:
    """The part's rank and the strongest proof found for its motion."""
    return _entry(numbers, ("block", str(index)))


def _entry(numbers: ProofNumbers, name: tuple[str, str], held: frozenset[str] = frozenset()) -> dict[str, Any]:
    matrix = numbers.read.matrix(name)
    if held:
        joints = (numbers.read.blocks if name[0] == "block" else numbers.read.untied)[int(name[1])].names
        moving = [n not in held for n in joints for _ in numbers.read.joints[n].screws]
        matrix = [[c for c, kept in zip(row, moving, strict=True) if kept] for row in matrix]
    entry: dict[str, Any] = {"rank": rank_entry(numbers, matrix), "proof": NONE}
    part = _Part(numbers, name, entry, held)
    if part.block.least == len(part.block.columns):
        return entry
    smooth = (part.tied,) if part.block.ties else (part.groups_alone, part.limbs, part.rigid, part.nested)
    for attempt in (*smooth, part.stopped, part.endless, part.form, part.direction):
        try:
            for proof in attempt():
                if part.accepted(proof):
                    return {**entry, "proof": proof}
        except NotDecidableError:  # numbers that grow too long: another proof may need shorter ones
            continue
    return entry


def group_of(numbers: ProofNumbers, screws: Sequence[Screw]) -> Any:
    """A basis of the Lie algebra that screws generate: each vector has a 1 where the others have a 0."""
    system = numbers.system
    if system is None:
        return WHOLE
    try:
        basis = reduced([[numbers.exact(c) for c in s] for s in screws], system.field)[0]
        while len(basis) < 6:
            wider = reduced([*basis, *(_bracket(a, b) for a, b in combinations(basis, 2))], system.field)[0]
            if len(wider) == len(basis):
                return [[numbers.json(c) for c in vector] for vector in basis]
            basis = wider
    except NotDecidableError:  # the numbers grow too long: every group is in that of all displacements
        pass
    return WHOLE


def accepted(
    numbers: ProofNumbers, name: Sequence[str], entry: dict[str, Any], held: frozenset[str] = frozenset()
) -> bool:
    """Whether the checker takes the proof of a part, of which some joints are held."""
    try:
        return bool(Block(numbers.read, name, entry, held=held).dimensions)
    except RefusedError:
        return False


class _Part:
    """A part of the mechanism, as the checker has it, and what proofs are made of."""

    def __init__(
        self, numbers: ProofNumbers, name: tuple[str, str], entry: dict[str, Any], held: frozenset[str]
    ) -> None:
        self.numbers, self.name, self.entry, self.held = numbers, name, entry, held
        self.block = Block(numbers.read, name, entry, held=held)
        self.decided = numbers.system is not None and self.block.least == self.block.most
        self._groups: list[Any] | None = None

    def accepted(self, proof: dict[str, Any]) -> bool:
        """Whether the checker takes it."""
        return accepted(self.numbers, self.name, {**self.entry, "proof": proof}, self.held)

    def tied(self) -> Iterator[dict[str, Any]]:
        """Smooth, by parts that are so without couplings, and couplings that are independent or follow from others."""
        read = self.numbers.read
        inside = [k for k, part in enumerate(read.untied) if set(part.names) <= set(self.block.names)]
        parts = [_entry(self.numbers, ("untied", str(k))) for k in inside]
        implied = rank_entry(self.numbers, read.powers(self.block.ties)).get("null", [])
        yield {"kind": "tied", "parts": parts, "implied": implied}

    def groups(self) -> list[Any]:
        """The group of each loop, as the file has it."""
        if self._groups is None:
            self._groups = [group_of(self.numbers, [s for _, s in factors]) for factors in self.block.factors]
        return self._groups

    def groups_alone(self) -> Iterator[dict[str, Any]]:
        """Smooth, where the rank is the sum of the dimensions of the loops' groups."""
        yield {"kind": "groups", "groups": self.groups()}

    def limbs(self) -> Iterator[dict[str, Any]]:
        """Smooth, by limbs between two bodies that reach all of their groups."""
        if not self.decided:
            return
        joints, one = [self.numbers.read.joints[name] for name in self.block.names], self.block.bodies()
        at: dict[str, list[str]] = {}
        for joint in joints:
            at.setdefault(one[joint.parent], []).append(joint.name)
            at.setdefault(one[joint.child], []).append(joint.name)
        if any(one[joint.parent] == one[joint.child] for joint in joints):
            return
        hubs = [body for body, names in at.items() if len(names) > 2]
        for ends in combinations(hubs or at, 2):
            limbs = self._limbs_between(ends, at)
            if limbs is None or (hubs and len(hubs) > 2):
                continue
            made = []
            for names in limbs:
                screws = [screw for name in names for screw in self.numbers.read.joints[name].screws]
                matrix = [list(row) for row in zip(*screws, strict=True)]
                group = group_of(self.numbers, screws)
                minor = rank_entry(self.numbers, matrix)["minor"]
                size = at_least(self.numbers.read.numbers, matrix, minor)
                if size != (6 if group == WHOLE else len(group)):
                    break
                made.append({"joints": names, "group": group, "minor": minor})
            else:
                yield {"kind": "limbs", "between": list(ends), "limbs": made}

    def _limbs_between(self, ends: Sequence[str], at: dict[str, list[str]]) -> list[list[str]] | None:
        """The joints of each limb from the first body to the second; None where there is more than such limbs."""
        limbs, one = [], self.block.bodies()
        for first in at[ends[0]]:
            names, body = [first], ends[0]
            while True:
                joint = self.numbers.read.joints[names[-1]]
                body = one[joint.child] if one[joint.parent] == body else one[joint.parent]
                if body in ends or len(at[body]) != 2:
                    break
                names.append(next(name for name in at[body] if name != names[-1]))
            if body != ends[1]:
                return None
            limbs.append(names)
        return limbs if sum(map(len, limbs)) == len(self.block.names) else None

    def rigid(self) -> Iterator[dict[str, Any]]:
        """Loops of joints at rest whose screws are independent, and a proof for what is left without these joints."""
        read, block = self.numbers.read, self.block
        if not self.decided or block.ties:
            return
        still = [n for n in block.names if not any(u[block.columns.index(c)] for u in block.motions
                                                   for c in read.joints[n].columns)]  # fmt: skip
        found = [entry for names in _looped(read, still) for entry in self._stiff(names)]
        if found:
            held = self.held.union(*(entry["joints"] for entry in found))
            rest = _entry(self.numbers, self.name, held)
            if Block(read, self.name, rest, held=held).dimensions[2] is not None:
                yield {"kind": "rigid", "rigid": found, "rest": rest}

    def nested(self) -> Iterator[dict[str, Any]]:
        """Smooth by one loop that is so alone, if all others are independent of it."""
        block, read = self.block, self.numbers.read
        if not self.decided or block.ties or len(block.loops) < 2 or self.held:
            return
        loops = [frozenset(name for name, _ in read.loops[k]) for k in block.loops]
        single = [*loops, *(a ^ b for a, b in combinations(loops, 2) if a & b)]  # in which a common way is left out
        for joints in sorted(dict.fromkeys(map(frozenset, single)), key=lambda names: (len(names), sorted(names))):
            names = [name for name in block.names if name in joints]
            alone = read.alone(names)
            closure = alone.matrix(["closure"])
            redundant = 6 * len(block.loops) - block.least
            if len(alone.loops) == 1 and 6 - len(rank_entry(self.numbers, closure)["minor"]["rows"]) == redundant:
                inside = replace(self.numbers, read=alone)
                yield {"kind": "nested", "joints": names, "parts": [_entry(inside, ("block", "0"))]}

    def _stiff(self, names: list[str]) -> Iterator[dict[str, Any]]:
        """Those of the joints that are shown to be rigid: all of them, or the loops of them that are so alone."""
        alone = self.numbers.read.alone(names)
        loops = [sorted({name for name, _ in loop}) for loop in alone.loops]
        for joints in (names, *loops) if len(loops) > 1 else (names,):
            part = self.numbers.read.alone(joints)
            minor = rank_entry(self.numbers, part.matrix(["closure"]))["minor"]
            if len(minor["rows"]) == part.freedoms:
                yield {"joints": joints, "minor": minor}
                if joints is names:
                    return

    def stresses(self) -> list[tuple[Exact, ...]]:
        """Self-stresses that are independent on the groups of the loops."""
        assert self.numbers.system is not None
        size = 6 * len(self.block.loops) + len(self.block.ties)
        rows: list[list[Exact]] = [[Fraction(0)] * size for _ in self.block.columns]
        for loop, factors in enumerate(self.block.factors):
            for column, screw in factors:
                for i, c in enumerate(screw):
                    rows[column][6 * loop + i] = self.numbers.exact(c)
        for k, tie in enumerate(self.block.tied_columns):
            for column, powers in tie.items():
                rows[column][6 * len(self.block.loops) + k] = self.numbers.exact(powers[0])
        found = null_vectors(rows, size, self.numbers.system.field)
        values = np.array([[self._number(c) for c in s] for s in found]).reshape(len(found), -1)
        seen = [np.zeros((0,))] * 0
        chosen: list[int] = []
        for k, stress in enumerate(values):
            on_groups = self._on_groups(stress)
            candidates = [*seen, on_groups]
            if np.linalg.matrix_rank(np.array(candidates), tol=FLAT * max(1.0, float(np.abs(candidates).max()))) == len(
                candidates
            ):
                seen, chosen = candidates, [*chosen, k]
        return [found[k] for k in chosen]

    def _on_groups(self, stress: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        values = []
        for k, group in enumerate(self.groups()):
            part = stress[6 * k : 6 * k + 6]
            basis = (
                np.eye(6) if group == WHOLE else np.array([[self._read(c) for c in v] for v in group]).reshape(-1, 6)
            )
            values += list(basis @ part)
        values += list(stress[6 * len(self.block.loops) :])
        return np.array(values)

    def _number(self, number: Exact) -> float:
        return self._read(self.numbers.json(number))

    def _read(self, value: Any) -> float:
        return self.numbers.value(self.numbers.read.numbers.read(value))

    def stopped(self) -> Iterator[dict[str, Any]]:
        """Isolated: the one motion is continued order by order until a self-stress does work."""
        if not self.decided or len(self.block.motions) != 1 or self.numbers.system is None:
            return
        field, width = self.numbers.system.field, len(self.block.columns)
        stresses = self.stresses()
        arc = [self.block.motions[0]]
        for _ in range(2, ORDERS + 1):
            left = [self.numbers.exact(c) for c in self.block.opened(arc)[-1]]
            for stress in stresses:
                if sum((a * b for a, b in zip(stress, left, strict=True) if a and b), Fraction(0)):
                    yield {
                        "kind": "stopped",
                        "groups": self.groups(),
                        "arc": [[self.numbers.json(self.numbers.exact(c)) for c in rates] for rates in arc],
                        "stress": [self.numbers.json(c) for c in stress],
                    }
                    return
            rows = [
                [*(self.numbers.exact(c) for c in row), c]
                for row, c in zip(self.numbers.read.matrix(self.name), left, strict=True)
            ]
            solutions = [v for v in null_vectors([r for r in rows if any(r)], width + 1, field) if v[-1]]
            if not solutions:  # no more than closed: the self-stresses chosen on the groups have missed it
                return
            back = 1 / solutions[0][-1] if isinstance(solutions[0][-1], Fraction) else solutions[0][-1].__rtruediv__(1)
            read = self.numbers.read.numbers.read
            arc.append([read(self.numbers.json(c * back)) for c in solutions[0][:-1]])

    def endless(self) -> Iterator[dict[str, Any]]:
        """Smooth: the one motion of a loop of six freedoms goes on to the order that no isolated one has."""
        block = self.block
        alone = len(block.motions) == 1 and len(block.loops) == 1 and not block.ties and len(block.columns) <= 6
        if not alone or not self.decided:
            return
        factors = [(column, [self.numbers.exact(c) for c in screw]) for column, screw in block.factors[0]]
        motion = [self.numbers.exact(c) for c in block.motions[0]]
        minor = self.entry["rank"]["minor"]
        arc = shut_arc(factors, motion, (minor["rows"], minor["columns"]), MOST_WAYS)
        if arc is not None:
            arc_values = [[self.numbers.json(c) for c in rates] for rates in arc]
            yield {"kind": "endless", "groups": self.groups(), "arc": arc_values}

    @cached_property
    def forms(self) -> tuple[list[tuple[Exact, ...]], np.ndarray[Any, Any]]:
        """Self-stresses with their quadratic forms on the motions, in doubles."""
        stresses = self.stresses()
        forms = [self.block.form([self.numbers.json(c) for c in stress]) for stress in stresses]
        count = len(self.block.motions)
        values = np.array([[[self.numbers.value(c) for c in row] for row in form] for form in forms])
        return stresses, values.reshape(len(stresses), count, count)

    def form(self) -> Iterator[dict[str, Any]]:
        """A cone, by one form that is not degenerate; or isolated, by a definite combination."""
        if not self.decided or len(self.block.motions) < 2:
            return
        stresses, forms = self.forms
        weights = [Fraction(1)] if len(stresses) == 1 else []
        if len(stresses) > 1:
            found = definite_stress(forms)
            weights = [] if found is None else [_fraction(w / np.abs(found).max()) for w in found]
        if not weights:
            return
        combined = np.tensordot([float(w) for w in weights], forms, axes=1)
        values, vectors = np.linalg.eigh(combined)
        if np.abs(values).min() > REGULAR * np.abs(values).max():
            terms = [[w * c for c in stress] for w, stress in zip(weights, stresses, strict=True)]
            total = [sum(parts[1:], parts[0]) for parts in zip(*terms, strict=True)]
            yield {
                "kind": "form",
                "groups": self.groups(),
                "stress": [self.numbers.json(c) for c in total],
                "basis": [[str(_fraction(c)) for c in row] for row in vectors.T],
            }

    def direction(self) -> Iterator[dict[str, Any]]:
        """A branch along a common zero of the forms at which they are independent."""
        if not self.decided or len(self.block.motions) < 3:
            return
        stresses, forms = self.forms
        scale = [float(np.abs(form).max()) for form in forms]
        if not len(forms) or min(scale) < FLAT:
            return
        unit = forms / np.array(scale)[:, None, None]
        for v in cone_directions(unit, np.random.default_rng(SEED)):
            slopes = np.einsum("kij,j->ki", forms, v)
            _, s, vt = np.linalg.svd(np.einsum("kij,j->ki", unit, v))
            if len(forms) >= len(v) or s[-1] < REGULAR:
                continue
            slices = [[_fraction(c) for c in row] for row in vt[len(forms) :]]
            square = np.concatenate([slopes, [[float(c) for c in row] for row in slices]])
            yield {
                "kind": "direction",
                "groups": self.groups(),
                "stresses": [[self.numbers.json(c) for c in stress] for stress in stresses],
                "centre": [str(_fraction(c)) for c in v],
                "radius": str(RADIUS),
                "slices": [[str(c) for c in row] for row in slices],
                "inverse": [[str(_fraction(c)) for c in row] for row in np.linalg.inv(square)],
            }


def _looped(read: Mechanism, names: Sequence[str]) -> list[list[str]]:
    """Of these joints those that lie in loops of them alone, in connected pieces."""
    left = [read.joints[name] for name in names]
    while True:
        ends = [body for joint in left for body in (joint.parent, joint.child)]
        kept = [joint for joint in left if min(ends.count(joint.parent), ends.count(joint.child)) > 1]
        if len(kept) == len(left):
            break
        left = kept
    pieces: list[tuple[set[str], list[str]]] = []
    for joint in left:
        near = [piece for piece in pieces if piece[0] & {joint.parent, joint.child}]
        pieces = [piece for piece in pieces if not piece[0] & {joint.parent, joint.child}]
        bodies = {joint.parent, joint.child}.union(*(piece[0] for piece in near))
        pieces.append((bodies, [*(name for piece in near for name in piece[1]), joint.name]))
    return [names for _, names in pieces]


def _fraction(value: float) -> Fraction:
    return Fraction(round(float(value) * DIGITS), DIGITS)


def _bracket(a: Sequence[Exact], b: Sequence[Exact]) -> list[Exact]:
    """The checker's bracket, which needs sums and products only, on numbers of the field."""
    x: list[Number] = list(a)
    y: list[Number] = list(b)
    return list(bracket(x, y))
