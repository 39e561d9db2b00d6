"""What lies beside an operation: its operands and its readers in the same limb, by what they do."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from symscrew.program.lanes.signed_operations import PACKED, Operation

LEAF = "leaf"  # what is there from the start: inputs, sines and cosines
READ_BY = {op: f"read by {op}" for op in PACKED}


class Neighbours:
    """Operations that a vector unit does and that are in a lane, with what is there for them from the start.

    They are counted through in the order of their slots: slots[number[s]] == s, op[x] and lane[x] are of slots[x],
    beside[x] its operands and readers in the same lane by operation; `met` are all numbers as the program meets them.
    """

    def __init__(self, operations: Mapping[int, Operation], of: Mapping[int, int]) -> None:
        """Those of all operations, `of` which lane slots are."""
        self.of = of
        ops: dict[int, str] = {}
        operands: dict[int, list[int]] = {}
        for slot, (kind, args) in operations.items():
            own = of.get(slot)
            if own is None or kind not in PACKED:
                continue
            ops[slot] = kind
            operands[slot] = below = []
            for a, _ in args:
                if type(a) is int and of.get(a) == own and a not in below:
                    if a not in ops:
                        if a in operations:
                            continue
                        ops[a] = LEAF
                    below.append(a)
        self.slots = sorted(ops)
        self.number = number = {slot: x for x, slot in enumerate(self.slots)}
        self.met = [number[slot] for slot in ops]
        self.op = [ops[slot] for slot in self.slots]
        self.lane = [of[slot] for slot in self.slots]
        self.beside: list[dict[str, list[int]]] = [{} for _ in ops]
        for slot, below in operands.items():
            x, read_by = number[slot], READ_BY[ops[slot]]
            mine = self.beside[x]
            for a in below:
                y = number[a]
                mine.setdefault(ops[a], []).append(y)
                self.beside[y].setdefault(read_by, []).append(x)

    def most_whole(self, limbs: int) -> int:
        """So many rows of one operation have a member in each of so many limbs at most."""
        found = Counter(zip(self.op, self.lane, strict=True))
        return sum(min(found[op, k] for k in range(limbs)) for op in {*self.op} - {LEAF})
