"""Numbers of packed programs, lane by lane."""

from __future__ import annotations

import numpy as np

from symscrew.program.lanes.packs import Pack, Packing


def evaluated(slots: list[int], found: Packing, state: list[float]) -> list[float]:
    """Some slots of a packed program, item by item, each lane of a pack in Python's own arithmetic."""
    binary = {
        "add": lambda x, y: x + y,
        "sub": lambda x, y: x - y,
        "mul": lambda x, y: x * y,
        "div": lambda x, y: x / y,
    }
    values: dict[int, float] = dict(enumerate(state))
    packs: dict[int, list[float]] = {}

    def value(a: int | float) -> float:
        if not isinstance(a, int):
            return a
        if a in found.place:
            pack, lane = found.place[a]
            return pack.signs[lane] * packs[pack.number][lane]
        if a in found.negatives:
            base, sign = found.negatives[a]
            return sign * value(base)
        return values[a]

    def computed(op: str, args: list[float]) -> float:
        if op in binary:
            return float(binary[op](*args))
        return 1.0 / args[0] if op == "reciprocal" else float(np.sqrt(args[0]))

    for item in found.items:
        if not isinstance(item, Pack):
            operation = found.operations[item]
            values[item] = computed(operation.op, [sign * value(a) for a, sign in operation.args])
            continue
        columns = []
        for vector in item.operands:
            column = [value(a) for a in vector.entries] if vector.source is None else packs[vector.source]
            columns.append([f * x for f, x in zip(vector.flips or (1,) * len(column), column, strict=True)])
        busy = [target is not None for target in item.targets]
        lanes = zip(busy, zip(*columns, strict=True), strict=True)
        packs[item.number] = [computed(item.op, list(args)) if used else 1.0 for used, args in lanes]
    return [value(slot) for slot in slots]
