"""The way from the reference configuration to a region that does not hold it, in boxes that are proved like its own.

reference --straight in all coordinates and parameters that differ--> chain of boxes, each at the corner of the last
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.studies.certificate.certificate_checker import (
    Equations,
    RefusedError,
    Tubes,
    configurations,
    holds_start,
    meet,
    need,
    refuse,
    together,
    tubes,
)

Array = np.ndarray
LEAST = 2.0**-12
"""Of the way, in one box: where less is needed a singularity is near, and no proof."""
MOST = 512
"""Boxes of a way: some seconds."""


@dataclass(frozen=True)
class Way:
    """Boxes `low`, `high` (n, k), configurations in their middle (n, m), and those at both ends (k,), (m,)."""

    low: list[list[float]]
    high: list[list[float]]
    configurations: list[list[float]]
    begin: tuple[Array, Array]
    end: tuple[Array, Array]

    def values(self, equations: dict[str, Any]) -> dict[str, Any]:
        """What the file has of it."""
        ends = {name: {"z": z.tolist(), "q": q.tolist()} for name, (z, q) in (("begin", self.begin), ("end", self.end))}
        own = {name: equations[name] for name in ("rows", "axes", "held", "driven", "parameters")}
        return {
            "equations": own, "low": self.low, "high": self.high, "configurations": self.configurations, **ends,
        }  # fmt: skip


def proved_way(equations: Equations, first: Array, last: Array, q: Array) -> Way | None:
    """A chain of boxes along the straight line from z = `first`, with dependent coordinates q, to `last`; or None."""
    low, high, middles = list[list[float]](), list[list[float]](), list[list[float]]()
    begin, before, s, step = q, None, 0.0, 1.0
    while s < 1:
        if step < LEAST or len(low) == MOST:
            return None
        end = min(1.0, s + step)
        found, then = _box(equations, _at(first, last, s), _at(first, last, end), q)
        if found is None or not (before is None or _meets(equations, before, found)):
            step /= 2
            continue
        low.append(found.low[:, 0].tolist())
        high.append(found.high[:, 0].tolist())
        middles.append(found.centre[:, 0].tolist())
        before, q, s, step = found, then, end, 2 * step
    return Way(low, high, middles, (first, begin), (last, q))


def _at(first: Array, last: Array, s: float) -> Array:
    return last if s == 1 else first + (last - first) * s


def _box(equations: Equations, a: Array, b: Array, q: Array) -> tuple[Tubes | None, Array]:
    """(the box between two corners, where it is proved to hold one configuration, that at the second corner)."""
    low, high = np.minimum(a, b)[:, None], np.maximum(a, b)[:, None]
    with np.errstate(all="ignore"):
        middle, still = configurations(equations, 0.5 * (low + high), q[:, None])
        then, comes = configurations(equations, b[:, None], 2 * middle - q[:, None])
    if not (still.all() and comes.all()):
        return None, q
    found = tubes(equations, low, high, middle)
    return (found if (found.closed & found.holding).all() else None), then[:, 0]


def _meets(equations: Equations, one: Tubes, two: Tubes) -> bool:
    """Whether two boxes hold the same configuration at the corner that they share."""
    return bool(meet(equations, together([one, two]), [(0, 1)]).all())


def whole_of(equations: Equations, z: Array, q: Array) -> tuple[list[float], list[float]]:
    """All coordinates and all parameters at z (k,) with the dependent coordinates q (m,)."""
    every, p = dict(equations.held), list(equations.parameters)
    for (kind, k), value in zip(equations.axes, z, strict=True):
        if kind == "q":
            every[k] = float(value)
        else:
            p[k] = float(value)
    every |= dict(zip(equations.dependent, map(float, q), strict=True))
    return [every[k] for k in range(equations.count)], p


def follow_way(values: Any) -> tuple[list[float], list[float]]:
    """The configuration at which the way of a file begins, all coordinates and parameters; the start where it has none.

    Every box of the way holds one configuration, each next to the one before, the last that of the start.
    """
    equations, start, way = Equations.read(values["equations"]), values["start"], values.get("way")
    last = whole_of(equations, np.array(start["z"], dtype=float), np.array(start["q"], dtype=float))
    if way is None:
        return last
    bare = Equations.read({**values["equations"], **way["equations"], "conditions": []})
    low, high, centre = (np.array(way[k], dtype=float).T for k in ("low", "high", "configurations"))
    ends = [(np.array(way[k]["z"], dtype=float), np.array(way[k]["q"], dtype=float)) for k in ("begin", "end")]
    count = low.shape[1]
    need(low.shape == high.shape == (len(bare.axes), count) and count > 0, "boxes of the way")
    need(centre.shape == (len(bare.dependent), count), "configurations of the way")
    found = tubes(bare, low, high, centre)
    refuse(found.closed & found.holding, "on the way to the start a configuration may be lost")
    refuse(meet(bare, found, [(k, k + 1) for k in range(count - 1)]), "the way to the start may change its branch")
    for box, end in zip((0, count - 1), ends, strict=True):
        if not holds_start(bare, found, box, end):
            raise RefusedError("an end of the way to the start is not in its box")
    if whole_of(bare, *ends[1]) != last:
        raise RefusedError("the way ends elsewhere than at the start")
    return whole_of(bare, *ends[0])
