"""Mechanisms made up for the tests, of no literature and no catalogue: all joint types, some are overconstrained.

A joint is (type, parent, child, point, axes or None[, pitch]); they stand where the loops are closed. Bodies get a
mass, a centre of mass off their joints and an inertia with products, all from their names.
"""

from __future__ import annotations

import zlib
from typing import Any

import numpy as np
from sympy import Rational

from support.further_mechanisms import BENNETT, unit
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism

Given = tuple[Any, ...]
X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]
SLANT = [1, 2, 2]
FOUR = ([0, 0, 0], [1, 3, -1], [4, 2, 1], [5, -1, 0])  # corners of a quadrangle, seen along any axis
SKEW = ([0, 0, 0], [1, 0, 1], [1, 2, 2], [0, 2, -1])


def _ring(kinds: str, points: Any, axes: Any, **pitches: str) -> tuple[Given, ...]:
    """A loop base - a - b - ... - base."""
    bodies = ["base", *"abcdefg"[: len(kinds) - 1], "base"]
    return tuple(
        (kind, bodies[k], bodies[k + 1], point, axis, *([pitches[f"p{k}"]] if f"p{k}" in pitches else []))
        for k, (kind, point, axis) in enumerate(zip(kinds, points, axes, strict=True))
    )


INVENTED: dict[str, tuple[Given, ...]] = {
    "screw_press": (
        ("R", "base", "a", [0, 0, 0], [Z]), ("H", "a", "b", [0, 0, 1], [Z], "1/8"), ("P", "base", "b", [1, 0, 1], [Z]),
    ),
    "tilted_four_bar": _ring("RRRR", FOUR, [[SLANT]] * 4),
    "threads_in_a_ring": _ring("HHHH", FOUR, [[SLANT]] * 4, p0="1/5", p1="1/5", p2="1/5", p3="1/5"),
    "crossed_slides": _ring("RPPR", ([0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 1, 0]), ([Z], [X], [Y], [Z])),
    "five_axes_through_a_point": _ring("RRRRR", [[0, 0, 2]] * 5, ([Z], [X], [[1, 2, 2]], [[2, -1, 2]], [[0, 3, 4]])),
    "bennett_moved": _ring("RRRR", [p for _, p, _ in BENNETT], [[a] for _, _, a in BENNETT]),
    "folding_plate": (
        ("R", "base", "a", [2, 0, 0], [Y]), ("R", "a", "b", [3, 0, 1], [Y]), ("R", "b", "plate", [2, 0, 2], [Y]),
        ("R", "base", "c", [1, 2, 0], [[3, 4, 0]]), ("R", "c", "d", [0, 3, 1], [[3, 4, 0]]),
        ("R", "d", "plate", [1, 2, 2], [[3, 4, 0]]),
    ),
    "cylinders": _ring("RCCC", SKEW, ([SLANT], [Y], [[2, -2, 1]], [[0, 3, 4]])),
    "slide_cross_ball": _ring("PUSR", SKEW, ([SLANT], [X, Y], None, [X])),
    "plane_cross_cylinder": _ring("EUC", ([0, 0, 0], [1, 0, 1], [1, 2, 0]), ([SLANT], [X, Z], [[2, -2, 1]])),
    "thread_ball_cross": _ring(
        "HSUR", SKEW, ([SLANT], None, [Y, Z], [[2, -2, 1]]), p0="-1/7"
    ),
    "spinning_rod": _ring("RSSR", ([0, 0, 0], [1, 0, 1], [2, 3, 1], [3, 2, -1]), ([Z], None, None, [X])),
    "two_loops": (
        *_ring("RRRR", FOUR, [[SLANT]] * 4), ("S", "b", "rod", [3, 3, 3], None), ("S", "rod", "slide", [1, 2, 5], None),
        ("P", "base", "slide", [1, 2, 6], [X]),
    ),
    "table_and_flyer": (
        *_ring("EUSP", SKEW, ([Z], [X, Y], None, [SLANT])),
        ("fixed", "a", "weight", [0, 1, 1], None), ("free", "b", "flyer", [2, 2, 2], None),
    ),
    "chain": (
        ("C", "base", "a", [0, 0, 0], [SLANT]), ("U", "a", "b", [1, 0, 1], [X, Y]),
        ("H", "b", "c", [1, 2, 1], [Z], "1/9"), ("S", "c", "d", [0, 2, -1], None), ("E", "d", "e", [0, 3, -1], [X]),
    ),
}  # fmt: skip


def invented(name: str) -> Mechanism:
    """With a drive on the first freedom of the first joint."""
    builder = MechanismBuilder(name)
    joints = INVENTED[name]
    places: dict[str, list[Any]] = {}
    for _, parent, child, point, *_ in joints:
        for body in (parent, child):
            places.setdefault(body, []).append(point)
    for body, points in places.items():
        if body != "base":
            _body(builder, body, np.mean(np.array(points, dtype=float), axis=0), seed=f"{name} {body}")
    for k, (kind, parent, child, point, axes, *pitch) in enumerate(joints):
        options: dict[str, Any] = {} if axes is None else {"axes": [unit(axis) for axis in axes]}
        if pitch:
            options["pitch"] = Rational(pitch[0])
        if k == 0:
            options["driven"] = [0]
        builder.joint(f"J{k}", kind, parent=parent, child=child, point=list(point), **options)
    return builder.build()


def _body(builder: MechanismBuilder, body: str, middle: np.ndarray, *, seed: str) -> None:
    random = np.random.default_rng(zlib.crc32(seed.encode()))
    com = [Rational(round(100 * c), 100) for c in middle + random.uniform(-0.3, 0.3, 3)]
    a, b, c = (Rational(int(k), 100) for k in random.integers(30, 40, 3))
    d, e, f = (Rational(int(k), 100) for k in random.integers(-3, 4, 3))
    builder.body(
        body, mass=Rational(int(random.integers(10, 20)), 10), com=com, inertia=[[a, d, e], [d, b, f], [e, f, c]]
    )
