"""Orders of instructions that suit registers and pipelines; results do not depend on them.

`short_lived`, for one state and for blocks: takes what ends most lives of operands among all that can be done, so that
limb after limb is worked off; of equals the next one in a walk from the results down to what they are made of, longest
chains first. Few values are alive, and the processor itself finds what can run side by side.
`early`, for equal limbs in lanes: looks a number of instructions ahead and starts what the longest chain of dependent
operations waits for: a call in lanes has few instructions, and takes as long as that chain.

Measured with sixteen vector registers (AVX2): an early start of single calls and blocks keeps more values alive than
there are registers, and costs up to a sixth of the time of drives, reactions, accelerations and derivatives; walks by
the number of instructions behind an operand, or in the order of the derivation, cost drives another 5 to 10 %.
"""

from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Sequence

from symscrew.program import Instruction

LATENCY = {"reciprocal": 24.0, "div": 24.0, "sqrt": 31.0}  # cycles in vectors of 512 bits, beside 4


class _Open:
    """Which instructions can be done: how many of their operands are to be computed yet."""

    def __init__(self, instructions: Sequence[Instruction]) -> None:
        self.read = [tuple({a for a in i.args if isinstance(a, int)}) for i in instructions]
        self.users: dict[int, list[int]] = defaultdict(list)
        for k, slots in enumerate(self.read):
            for slot in slots:
                self.users[slot].append(k)
        defined = {i.target for i in instructions}
        self.missing = [sum(slot in defined for slot in slots) for slots in self.read]

    def done(self, target: int) -> list[int]:
        """What can be done when `target` is known."""
        found = []
        for k in self.users.get(target, ()):
            self.missing[k] -= 1
            if self.missing[k] == 0:
                found.append(k)
        return found


def short_lived(instructions: Sequence[Instruction]) -> list[Instruction]:
    """The same instructions, what ends most lives first; of two such orders the one with fewer values alive."""
    return min((_ending_lives(_walk(instructions, last=last)) for last in (False, True)), key=_alive)


def _walk(instructions: Sequence[Instruction], *, last: bool) -> list[Instruction]:
    """Everything in front of one result, then the next, the longest chain first; `last`: from the last result."""
    by = {i.target: i for i in instructions}
    chain: dict[int, int] = {}
    read: set[int] = set()
    for i in instructions:
        own = {a for a in i.args if a in by and isinstance(a, int)}
        read |= own
        chain[i.target] = 1 + max((chain[a] for a in own), default=0)
    done: set[int] = set()
    order: list[Instruction] = []
    for root in [target for target in by if target not in read][:: -1 if last else 1]:
        stack = [root]
        while stack:
            target = stack[-1]
            left = [a for a in by[target].args if isinstance(a, int) and a in by and a not in done]
            if target not in done and left:
                stack.append(max(left, key=chain.__getitem__))
                continue
            stack.pop()
            if target not in done:
                done.add(target)
                order.append(by[target])
    return order


def _alive(instructions: Sequence[Instruction]) -> int:
    """The sum over all instructions of how many computed values are read later."""
    computed = {i.target: k for k, i in enumerate(instructions)}
    end = {a: k for k, i in enumerate(instructions) for a in i.args if isinstance(a, int) and a in computed}
    return sum(k - computed[a] for a, k in end.items())


def _ending_lives(instructions: Sequence[Instruction]) -> list[Instruction]:
    """What ends most lives first, of equals the one that came first."""
    left = _Open(instructions)
    waiting = {slot: set(users) for slot, users in left.users.items()}
    computed: set[int] = set()
    gain = [-1 if i.target in waiting else 0 for i in instructions]
    heap = [(-gain[k], k) for k, n in enumerate(left.missing) if n == 0]
    heapq.heapify(heap)
    order: list[Instruction] = []
    taken: set[int] = set()

    def last_reader(slot: int) -> None:
        """One reader is left: it ends the life of a value."""
        if slot in computed and len(waiting[slot]) == 1:
            (k,) = waiting[slot]
            gain[k] += 1
            if left.missing[k] == 0:
                heapq.heappush(heap, (-gain[k], k))

    while heap:
        negative, k = heapq.heappop(heap)
        if k in taken or -negative != gain[k]:
            continue
        taken.add(k)
        order.append(instructions[k])
        target = instructions[k].target
        computed.add(target)
        for slot in left.read[k]:
            waiting[slot].discard(k)
            last_reader(slot)
        if target in waiting:
            last_reader(target)
        for ready in left.done(target):
            heapq.heappush(heap, (-gain[ready], ready))
    return order


def early(instructions: Sequence[Instruction], *, ahead: int, issued: float) -> list[Instruction]:
    """The longest chain first, among the next `ahead` instructions whose operands are there at the time.

    `issued`: cycles from one to the next.
    """
    left = _Open(instructions)
    chain = [0.0] * len(instructions)
    for k in reversed(range(len(instructions))):
        after = max((chain[u] for u in left.users.get(instructions[k].target, ())), default=0.0)
        chain[k] = LATENCY.get(instructions[k].op, 4.0) + after
    known: dict[int, float] = {}
    coming: list[tuple[float, int]] = []
    ready: list[tuple[float, int]] = []
    taken = [False] * len(instructions)
    order: list[Instruction] = []
    first, entered, now = 0, 0, 0.0

    def arrive(k: int) -> None:
        heapq.heappush(coming, (max((known.get(slot, 0.0) for slot in left.read[k]), default=0.0), k))

    while len(order) < len(instructions):
        while first < len(taken) and taken[first]:
            first += 1
        while entered < min(first + ahead, len(taken)):
            if left.missing[entered] == 0:
                arrive(entered)
            entered += 1
        now = now if ready else max(now, coming[0][0])
        while coming and coming[0][0] <= now:
            k = heapq.heappop(coming)[1]
            heapq.heappush(ready, (-chain[k], k))
        k = heapq.heappop(ready)[1]
        taken[k] = True
        order.append(instructions[k])
        now += issued
        known[instructions[k].target] = now + LATENCY.get(instructions[k].op, 4.0)
        for following in left.done(instructions[k].target):
            if following < entered:
                arrive(following)
    return order
