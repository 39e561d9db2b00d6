"""How a region is split: every box is looked at, and halved where it proves nothing, down to a smallest size.

    region --one box--> configuration in the middle --checker's tubes--> what each box is
           --boxes whose neighbours are on the branch of the start, tried again from there--> joined boxes

Nothing here is a proof: the checker makes them, and looks at all of it again in the file.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from symscrew.studies.certificate.certificate_checker import (
    BEYOND,
    CLAIMED,
    OPEN,
    Equations,
    Tubes,
    configurations,
    holds_start,
    meet,
    middle_of,
    tubes,
)

Array = np.ndarray
MOST_BOXES = 200_000
"""Leaves after which boxes are not halved any more: the file of a mechanism of 30 joints has 100 MB then."""
ROUNDS = 6
"""Times that boxes beside joined ones are tried again from there: each goes on around a corner of the region."""
REASONS = ("closure", "drives")
"""Why a box is undecided, beside the names of results: its configuration, or the hold of the drives."""


@dataclass
class Box:
    """A node of the splitting: a box with the configuration in its middle, or an axis with two halves.

    `state`: "certified", "undecided", "outside" (a limit is passed all over it) or "beyond" the disk; `reasons`: what
    could not be shown. `tried`: whether it was looked at from a joined neighbour.
    """

    low: Array
    high: Array
    guess: Array | None
    axis: int = -1
    halves: tuple[Box, ...] = ()
    state: str = "undecided"
    reasons: tuple[str, ...] = ()
    centre: Array | None = None
    slope: Array | None = None
    tried: bool = False
    joined: bool = False

    @property
    def leaves(self) -> list[Box]:
        """All boxes that are not split, in the order of the file."""
        found, waiting = [], [self]
        while waiting:
            box = waiting.pop()
            waiting += box.halves[::-1]
            found += [] if box.halves else [box]
        return found

    @property
    def codes(self) -> list[int]:
        """The splitting as the file has it."""
        found, waiting = [], [self]
        while waiting:
            box = waiting.pop()
            waiting += box.halves[::-1]
            leaf = CLAIMED if box.joined else BEYOND if box.state == "beyond" else OPEN
            found.append(box.axis if box.halves else leaf)
        return found


@dataclass
class Splitting:
    """A region, its equations and its boxes; `smallest` (k,): edges below which nothing is halved.

    `disk`: two axes and a radius beyond which boxes are of no interest. `start`: z (k,) and dependent coordinates (m,)
    of the configuration on whose branch boxes count.
    """

    equations: Equations
    low: Array
    high: Array
    smallest: Array
    start: tuple[Array, Array]
    disk: tuple[int, int, float] | None = None
    progress: Callable[[int], None] = field(default=lambda count: None)

    def run(self) -> tuple[Box, list[Box], list[tuple[int, int]]]:
        """The tree, its joined boxes in the order of the file, and the pairs by which they are joined."""
        root = Box(self.low, self.high, self.start[1])
        self._split([root])
        pairs: list[tuple[Box, Box]] = []
        for _ in range(ROUNDS):
            pairs = self._join(root)
            again = self._to_try_again(root)
            if not again:
                break
            self._split(again)
        else:
            pairs = self._join(root)
        boxes = [box for box in root.leaves if box.joined]
        place = {id(box): k for k, box in enumerate(boxes)}
        return root, boxes, [(place[id(a)], place[id(b)]) for a, b in pairs]

    # -- halving -------------------------------------------------------------------------------------------

    def _split(self, boxes: Sequence[Box]) -> None:
        count = 0
        while boxes:
            boxes = [box for box in boxes if not self._is_beyond(box)]
            if boxes:
                self._look(boxes)
            count += len(boxes)
            self.progress(len(boxes))
            boxes = [half for box in boxes if box.state == "undecided" and count < MOST_BOXES
                     for half in self._halved(box)]  # fmt: skip

    def _is_beyond(self, box: Box) -> bool:
        if self.disk is None:
            return False
        i, j, radius = self.disk
        parts = [max(0.0, box.low[k], -box.high[k]) for k in (i, j)]
        if float(np.hypot(*parts)) * (1 - 1e-14) <= radius:  # the checker's own distance is this or less
            return False
        box.state = "beyond"
        return True

    def _halved(self, box: Box) -> tuple[Box, ...]:
        """Across the edge that is longest against the smallest one; nothing where all are small enough."""
        size = (box.high - box.low) / self.smallest
        axis = int(np.argmax(size))
        if size[axis] <= 1 + 1e-9:  # rounding of halves
            return ()
        middle = 0.5 * (box.low[axis] + box.high[axis])
        high, low = box.high.copy(), box.low.copy()
        high[axis] = low[axis] = middle
        box.axis, box.halves = axis, (Box(box.low, high, None), Box(low, box.high, None))
        for half in box.halves:
            half.guess = self._predicted(box, 0.5 * (half.low + half.high))
            half.tried = box.tried
        return box.halves

    def _predicted(self, box: Box, point: Array) -> Array | None:
        """Dependent coordinates near a configuration of a box; its own guess where it has none."""
        if box.centre is None or box.slope is None:
            return box.guess
        middle, half = middle_of(box.low, box.high)
        d = np.where(half > 0, (point - middle) / np.where(half > 0, half, 1.0), 0.0)
        return np.asarray(box.centre + box.slope @ d)

    def _look(self, boxes: Sequence[Box]) -> None:
        """Configurations in the middle and what holds about them."""
        low, high = (np.stack([getattr(b, end) for b in boxes], axis=1) for end in ("low", "high"))
        guess = np.stack([b.guess if b.guess is not None else self.start[1] for b in boxes], axis=1)
        with np.errstate(all="ignore"):
            centre, still = configurations(self.equations, 0.5 * (low + high), guess)
        good = np.flatnonzero(still)
        for box in boxes:
            box.state, box.reasons, box.centre = "undecided", REASONS[:1], None
        if len(good):
            found = tubes(self.equations, low[:, good], high[:, good], centre[:, good])
            for k, place in enumerate(good.tolist()):
                box = boxes[place]
                box.centre, box.slope = found.centre[:, k], found.slope[:, :, k]
                if not np.isfinite(box.slope).all():
                    box.centre = None
                box.state, box.reasons = self._judged(found, k)

    def _judged(self, found: Tubes, k: int) -> tuple[str, tuple[str, ...]]:
        if not found.closed[k]:
            return "undecided", REASONS[:1]
        reasons = [] if found.holding[k] else [REASONS[1]]
        for condition in self.equations.conditions:
            for i, name in enumerate(condition.names):
                low, high = (float(end[k]) for end in found.bounds[name])
                if condition.limits is None:
                    reasons += [] if low > 0 or high < 0 else [name]
                    continue
                least, most = condition.limits[i]
                if (least is not None and high < least) or (most is not None and low > most):
                    return "outside", (name,)
                if not ((least is None or low >= least) and (most is None or high <= most)):
                    reasons.append(name)
        return ("undecided" if reasons else "certified"), tuple(reasons)

    # -- joining -------------------------------------------------------------------------------------------

    def _tubes_of(self, boxes: Sequence[Box]) -> Tubes:
        """Of certified boxes, once more: what is asked of their results is left out."""
        bare = Equations(**{**self.equations.__dict__, "conditions": (), "driven": None})
        low, high = (np.stack([getattr(b, end) for b in boxes], axis=1) for end in ("low", "high"))
        return tubes(bare, low, high, np.stack([b.centre for b in boxes if b.centre is not None], axis=1))

    def _join(self, root: Box) -> list[tuple[Box, Box]]:
        """Marks the boxes that chains of neighbours join to the start; the pairs, the known box first."""
        boxes = [box for box in root.leaves if box.state == "certified"]
        for box in boxes:
            box.joined = False
        if not boxes:
            return []
        found = self._tubes_of(boxes)
        first = self._start_box(found)
        if first is None:
            return []
        beside: dict[int, set[int]] = {k: set() for k in range(len(boxes))}
        for a, b in neighbours(found.low, found.high):
            beside[a].add(b)
            beside[b].add(a)
        sure: set[tuple[int, int]] = set()
        while True:
            pairs = _chains(first, beside)
            new = [pair for pair in pairs if pair not in sure]
            same = meet(self.equations, found, new)
            sure |= {pair for pair, good in zip(new, same, strict=True) if good}
            if same.all():
                break
            for (a, b), good in zip(new, same, strict=True):
                if not good:
                    beside[a].discard(b)
                    beside[b].discard(a)
        boxes[first].joined = True
        for _, b in pairs:
            boxes[b].joined = True
        return [(boxes[a], boxes[b]) for a, b in pairs]

    def _start_box(self, found: Tubes) -> int | None:
        z = self.start[0][:, None]
        for k in np.flatnonzero(((found.low <= z) & (z <= found.high)).all(axis=0)):
            if holds_start(self.equations, found, int(k), self.start):
                return int(k)
        return None

    def _to_try_again(self, root: Box) -> list[Box]:
        """Boxes beside joined ones that are not: from the configuration of their neighbour, each once."""
        leaves = root.leaves
        low, high = (np.stack([getattr(b, end) for b in leaves], axis=1) for end in ("low", "high"))
        again = []
        for a, b in neighbours(low, high):
            for box, known in ((leaves[a], leaves[b]), (leaves[b], leaves[a])):
                apart = not box.joined and not box.tried and box.state in ("certified", "undecided")
                if known.joined and apart:
                    point = np.clip(0.5 * (box.low + box.high), known.low, known.high)
                    box.guess, box.tried, box.centre = self._predicted(known, point), True, None
                    again.append(box)
        return again


def _chains(first: int, beside: dict[int, set[int]]) -> list[tuple[int, int]]:
    """Pairs (known, new) that reach everything from the first."""
    reached, waiting, pairs = {first}, [first], []
    for known in waiting:  # which grows
        for new in sorted(beside[known] - reached):
            reached.add(new)
            waiting.append(new)
            pairs.append((known, new))
    return pairs


def neighbours(low: Array, high: Array) -> list[tuple[int, int]]:
    """Pairs of boxes (k, n) that share a part of a face."""
    found = []
    for axis in range(len(low)):
        others = [k for k in range(len(low)) if k != axis]
        ends: dict[float, list[int]] = {}
        for box, value in enumerate(high[axis]):
            ends.setdefault(float(value), []).append(box)
        starts: dict[float, list[int]] = {}
        for box, value in enumerate(low[axis]):
            starts.setdefault(float(value), []).append(box)
        for value in ends.keys() & starts.keys():
            a, b = np.array(ends[value]), np.array(starts[value])
            meet_ = np.ones((len(a), len(b)), dtype=bool)
            for k in others:
                meet_ &= (low[k][a][:, None] < high[k][b][None]) & (low[k][b][None] < high[k][a][:, None])
            found += [(int(a[i]), int(b[j])) for i, j in np.argwhere(meet_)]
    return found
