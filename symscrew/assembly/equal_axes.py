"""Axes that have to stay as long as one another: random ones, and ways between them that are polynomials.

An axis that two bodies share, x w = u x, has solutions only where w.w = u.u, over the complex numbers too. With a
quaternion p for each, w = p k p* has the length |p|^2, so that |q|^2 p k p* and |p|^2 q k q* are as long as one another
for any p and q; these go straight from member to member. (E. Cartan, The theory of spinors, 1938.)
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from symscrew.assembly.closure_structure import Structure

Array = np.ndarray[Any, Any]

DEGREE = 6
"""Of a motion, two, and of an axis, four, in s."""
ASIDE = np.array([[2, -3, 6], [6, -2, -3], [3, 6, 2]]) / 7.0
"""A rotation: axes opposite to each other along the third of its rows would have no common spinor's sign."""


def axis_pairs(structure: Structure) -> tuple[tuple[int, int], ...]:
    """The slots (w, u) of all axes that two bodies share."""
    return tuple(
        (form.slots[0], form.slots[1]) for loop in structure.loops for form in loop.forms if form.kind == "parallel"
    )


def axis_of(p: Sequence[Any]) -> tuple[list[Any], Any]:
    """(p k p*, |p|^2), for any scalars."""
    a, b, c, d = p
    return [2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d], a * a + b * b + c * c + d * d


def equally_long(slots: Sequence[Any], pairs: Sequence[tuple[int, int]]) -> list[Any]:
    """The same numbers with axes of length one in the pairs."""
    result = list(slots)
    for slot in (k for pair in pairs for k in pair):
        result[slot] = result[slot] / np.sqrt(np.dot(result[slot], result[slot]) + 0j)
    return result


def straight_in_spinors(
    start: Sequence[Any], end: Sequence[Any], pairs: Sequence[tuple[int, int]]
) -> Callable[[complex], list[Any]]:
    """Numbers on the straight line between two members; of axes in pairs their quaternions are on one."""
    ends = [(spinors(start[w], start[u]), spinors(end[w], end[u])) for w, u in pairs]

    def at(s: complex) -> list[Any]:
        result = [(1 - s) * np.asarray(a) + s * np.asarray(b) for a, b in zip(start, end, strict=True)]
        for (w, u), (one, two) in zip(pairs, ends, strict=True):
            p, q = ((1 - s) * a + s * b for a, b in zip(one, two, strict=True))
            (there, long), (here, wide) = axis_of(list(p)), axis_of(list(q))
            result[w], result[u] = ASIDE.T @ np.array(there) * wide, ASIDE.T @ np.array(here) * long
        return result

    return at


def spinors(w: Array, u: Array) -> tuple[Array, Array]:
    """Quaternions of axes as long as one another, of size one, with one sign for the root of their square.

    Their fourth part is 0.
    """
    w, u = ASIDE @ np.asarray(w), ASIDE @ np.asarray(u)
    root = np.sqrt(np.dot(w, w) + 0j)
    root = max((root, -root), key=lambda n: min(abs(n + w[2]), abs(n + u[2])))
    made = [np.array([root + v[2], -v[1], v[0], 0]) for v in (w, u)]
    one, two = (p / np.linalg.norm(p) for p in made)
    return one, two
