"""An order of instructions that suits registers: few values alive. Results do not depend on it.

Of all that can be done comes first what ends most lives of operands, so that limb after limb is worked off; of equals
the next one in a walk from the results down to what they are made of, longest chains first. The processor itself finds
what can run side by side: measured with sixteen vector registers (AVX2), starting roots, quotients and long chains
earlier keeps more values alive than there are registers, and costs up to a sixth of the time of single calls and
blocks, nothing or less in lanes; walks by the number of instructions behind an operand, or in the order of the
derivation, cost drives 5 to 10 %.
"""

from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Sequence

from symscrew.program import Instruction


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
