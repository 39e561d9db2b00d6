"""Comparisons and selections on enclosures: effects that choose (contacts, stops, limits of drives).

Where a condition holds all over a range, or nowhere in it, what it selects is enclosed as usual. Elsewhere the value is
one of both, and of its derivatives nothing is known: there may be a jump. What is selected keeps the condition: of
`depth` where 0 < depth only the part above 0 is taken, so that a root of it stays a number.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from symscrew.optimisation.enclosures import Enclosure, Number, Pair, constant


@dataclass(frozen=True)
class Condition(Enclosure):
    """A truth, 1 or 0. `smaller` <= `larger` is what it says where it `holds`; `subject` is one for both answers."""

    subject: object = None
    holds: bool = True
    smaller: Enclosure | None = None
    larger: Enclosure | None = None


@dataclass(frozen=True)
class Chosen(Enclosure):
    """`value` where a condition holds, else 0."""

    condition: Condition | None = None
    value_there: Enclosure | None = None


def _below(a: Pair, b: Pair) -> Pair:
    return a[1] < b[0], a[0] < b[1]


def _not_above(a: Pair, b: Pair) -> Pair:
    return a[1] <= b[0], a[0] <= b[1]


def _equal(a: Pair, b: Pair) -> Pair:
    one = (a[0] == a[1]) & (b[0] == b[1])
    return one & (a[0] == b[0]), (a[0] <= b[1]) & (b[0] <= a[1])


def _different(a: Pair, b: Pair) -> Pair:
    surely, may = _equal(a, b)
    return ~may, ~surely


def _both(a: Pair, b: Pair) -> Pair:
    (first, may_first), (second, may_second) = _different(a, NOTHING), _different(b, NOTHING)
    return first & second, may_first & may_second


def _either(a: Pair, b: Pair) -> Pair:
    (first, may_first), (second, may_second) = _different(a, NOTHING), _different(b, NOTHING)
    return first | second, may_first | may_second


NOTHING: Pair = (np.zeros(1), np.zeros(1))
# (a, b) -> where the condition surely holds, and where it may
COMPARISONS: Mapping[int, Callable[[Pair, Pair], Pair]] = {
    ca.OP_LT: _below,
    ca.OP_LE: _not_above,
    ca.OP_EQ: _equal,
    ca.OP_NE: _different,
    ca.OP_AND: _both,
    ca.OP_OR: _either,
}
ORDERED = (ca.OP_LT, ca.OP_LE)


def compared(op: int, a: Enclosure, b: Enclosure) -> Enclosure:
    """A comparison, "and" or "or" of two quantities."""
    if op == ca.OP_NE and isinstance(a, Condition) and not b.low.any() and not b.high.any():
        return a  # a truth is not 0
    surely, may = COMPARISONS[op](a.value, b.value)
    middle = COMPARISONS[op]((a.middle[0], a.middle[0]), (b.middle[0], b.middle[0]))[0]
    smaller, larger = (a, b) if op in ORDERED else (None, None)
    made = _truth(surely, may, middle, min(a.orders, b.orders))
    return Condition(made.low, made.high, made.middle, object(), True, smaller, larger)


def opposite(a: Enclosure) -> Enclosure:
    """Not a."""
    if not isinstance(a, Condition):
        return compared(ca.OP_EQ, a, constant(0.0, a.low.shape[1], a.orders))
    low, high = a.low.copy(), a.high.copy()
    low[0], high[0] = 1 - a.high[0], 1 - a.low[0]
    middle = np.array([1 - a.middle[0], a.middle[1]])
    return replace(a, low=low, high=high, middle=middle, holds=not a.holds, smaller=a.larger, larger=a.smaller)


def _truth(surely: np.ndarray, may: np.ndarray, middle: np.ndarray, orders: int) -> Enclosure:
    low, high = (np.zeros((orders, len(surely))) for _ in range(2))
    low[0], high[0] = surely, may
    low[1:], high[1:] = np.where(surely == may, 0.0, -np.inf), np.where(surely == may, 0.0, np.inf)
    value = np.broadcast_to(middle, surely.shape).astype(float)
    return Enclosure(low, high, np.array([value, np.zeros_like(value)]))


def selected(condition: Enclosure, a: Enclosure) -> Enclosure:
    """a where the condition holds, else 0."""
    given = condition if isinstance(condition, Condition) else compared(ca.OP_NE, condition, constant(0.0, 1))
    assert isinstance(given, Condition)
    there = _narrowed(a, given)
    made = _of_two(given, there, constant(0.0, there.low.shape[1], there.orders))
    return Chosen(made.low, made.high, made.middle, given, there)


def joined(a: Number, b: Number) -> Enclosure | None:
    """The sum of two selections of which exactly one holds; None where these are others."""
    if not isinstance(a, Chosen) or not isinstance(b, Chosen) or a.condition is None or b.condition is None:
        return None
    if a.condition.subject is not b.condition.subject or a.condition.holds == b.condition.holds:
        return None
    assert a.value_there is not None and b.value_there is not None
    return _of_two(a.condition, a.value_there, b.value_there)


def _narrowed(a: Enclosure, condition: Condition) -> Enclosure:
    """The part of a that the condition leaves, where it is one of both sides itself."""
    low, high = a.low[0], a.high[0]
    if a is condition.larger and condition.smaller is not None:
        low = np.minimum(np.fmax(low, condition.smaller.low[0]), high)  # all cut off: where it never holds
    if a is condition.smaller and condition.larger is not None:
        high = np.maximum(np.fmin(high, condition.larger.high[0]), low)
    return Enclosure(np.concatenate([low[None], a.low[1:]]), np.concatenate([high[None], a.high[1:]]), a.middle)


def _of_two(condition: Condition, a: Enclosure, b: Enclosure) -> Enclosure:
    """a where the condition holds, else b; their hull where it is not known, and nothing of its derivatives."""
    surely, may = condition.low[0] == 1, condition.high[0] == 1
    n = min(a.orders, b.orders, condition.orders)
    low = np.where(surely, a.low[:n], np.where(~may, b.low[:n], np.minimum(a.low[:n], b.low[:n])))
    high = np.where(surely, a.high[:n], np.where(~may, b.high[:n], np.maximum(a.high[:n], b.high[:n])))
    open_ = may & ~surely
    low[1:], high[1:] = np.where(open_, -np.inf, low[1:]), np.where(open_, np.inf, high[1:])
    return Enclosure(low, high, np.where(condition.middle[0] == 1, a.middle, b.middle))
