"""Checks a certificate of a workspace. This file imports nothing else of the package: Python and NumPy are enough.

    python certificate_checker.py FILE        exit 0: every claim is proved;  1: one is not;  2: not such a file

The file has the equations of the mechanism as straight-line programs, a region of coordinates z (independent ones and
parameters), how it is split into boxes, and in the middle of each claimed box a configuration q, in doubles. Shown here
for each claimed box, by arithmetic with bounds of every rounding:

    one configuration     C F(q, z) = 0 with C the inverse in the middle: Krawczyk's operator maps a tube
                          q = q0 + A (z - z0) + e, |e| <= E, into itself for every z of the box. So there is one and
                          only one closed configuration in the tube, and the closure keeps its rank there: z are
                          coordinates, no freedom appears (R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to
                          Interval Analysis, SIAM 2009, chapter 8)
    drives hold           with the driven coordinates locked the closure keeps full column rank
    margins               no margin of the file is zero in the tube
    limits                every limited quantity is within its limits in the tube
    joined                neighbours have the same configuration at a common point; so all boxes of a chain of
                          neighbours are on the branch on which the chain starts: the assembly mode is not lost

That the equations are those of the mechanism it names, and where the chain starts, the file cannot show by itself:
`symscrew check FILE` derives them again from the description in the file; here that is only hashed.

Numbers are forms c + l . d + [-r, r] with d in [-1, 1], one entry per edge of the box, so that what depends on z to
first order stays sharp (Taylor models of order 1); where that shows nothing, one more per entry of e, which closure and
rank depend on to first order too: of this part the mean F' from e = 0 to e, which Krawczyk's operator has, is half.
A constant of a program stands for every number rounded to it.
"""

from __future__ import annotations

import hashlib
import json
import math
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

Array = np.ndarray
FORMAT = "symscrew workspace certificate 2"
EPS = 2.0**-52  # twice the largest relative error of one operation on doubles
SLACK = 1.0 + 256 * EPS  # what a sum of some dozens of positive numbers that were rounded to nearest may have lost
TINY = 1e-290  # more than what a product loses where it underflows
SINE_ERROR = 2.0**-49  # of sine and cosine below: reduction 3e-16, Horner's scheme 5e-16, the series 2e-22
MOST_EDGES = 24  # of a box: sums over more would lose more than SLACK
MOST_INPUTS = 512  # coordinates, and parameters: a file that says more would only fill the memory
LARGEST_TURNS = 1000.0  # quarter turns up to which an angle is reduced exactly
QUARTER = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624871116645580e-21)  # pi/2 in 33-bit parts
AT_ONCE = 256  # boxes that are looked at together: all numbers of a mechanism of 30 joints in 0.2 GB
NEWTON = 8  # steps to a configuration: from a tenth of a radian away five are enough
STILL = 1e-13  # a step after which the next one would only move the last digits
WIDEN = (1.1, 1.3, 1.3, 1.5)  # by which the tube is wider than its fixed point seems to be: trials, more bring nothing
LEAST = 1e-11  # radius of a tube where nothing else makes it wider: a point, which is known to 1e-13, is well inside
SETTLING = 12  # steps to that fixed point, which come to rest where the tube can be enclosed at all
SHOWN = 16  # digits of a hash that a person compares
SETTLED = 1.05  # growth in the last of these steps that is rest


OF_MECHANISM = "the programs are those of the mechanism of this description: not derived here"
OF_START = "the start is on the branch of its reference configuration: not looked up here"
"""Assumed by this file alone, shown by `symscrew check`."""


class RefusedError(Exception):
    """The file does not carry its claim."""


class UnreadableError(Exception):
    """The file is not a certificate."""


# -- forms -------------------------------------------------------------------------------------------------


class Form:
    """c + l . d + [-r, r] for d in [-1, 1]^k: arrays c (..., n), l (k, ..., n), r (..., n); NaN: nothing is known."""

    __slots__ = ("c", "l", "r", "s")

    def __init__(self, c: Array, l: Array, r: Array) -> None:
        self.c, self.l, self.r = c, l, r
        self.s = np.abs(l).sum(axis=0) * SLACK

    @property
    def radius(self) -> Array:
        """Largest distance from c (n,)."""
        return np.asarray((self.s + self.r) * SLACK)

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Least and largest value (n,), (n,)."""
        wide = self.radius + EPS * np.abs(self.c)
        return self.c - wide, self.c + wide

    def __neg__(self) -> Form:
        return Form(-self.c, -self.l, self.r)

    def __add__(self, other: Form) -> Form:
        c, l = self.c + other.c, self.l + other.l
        return Form(c, l, (self.r + other.r + EPS * (np.abs(c) + self.s + other.s)) * SLACK)

    def __sub__(self, other: Form) -> Form:
        return self + -other

    def __mul__(self, other: Form) -> Form:
        """The products of first orders, l_i m_j d_i d_j: of i = j half is sure, d_i^2 being between 0 and 1."""
        a, b = np.abs(self.c) + self.s, np.abs(other.c) + other.s
        squares = self.l * other.l
        size = np.abs(squares).sum(axis=0)
        mixed = self.s * other.s - size
        if len(self.l) == 2:  # sharper, as the two signs may differ
            mixed = np.abs(self.l[0] * other.l[1] + self.l[1] * other.l[0])
        c = self.c * other.c + 0.5 * squares.sum(axis=0)
        r = a * other.r + b * self.r + self.r * other.r + mixed + 0.5 * size
        return Form(c, self.c * other.l + other.c * self.l, (r + 64 * EPS * a * b) * SLACK + TINY)

    def along(self, value: Array, slope: Array, curvature: tuple[Array, Array]) -> Form:
        """f of this form, from f and f' at c and the bounds of f'' over the range."""
        h = self.radius
        low, high = np.minimum(curvature[0], 0.0), np.maximum(curvature[1], 0.0)
        part = 0.25 * h * h
        r = np.abs(slope) * self.r + (high - low) * part + 16 * EPS * (np.abs(value) + np.abs(slope) * h)
        r = r + 16 * EPS * (high - low) * part
        return Form(value + (low + high) * part, slope * self.l, r * SLACK + TINY)

    def wider(self, by: Array) -> Form:
        """With more uncertainty."""
        return Form(self.c, self.l, (self.r + by) * SLACK)


def constant(value: float, edges: int) -> Form:
    """A constant: every number that is rounded to it."""
    return Form(np.array([value]), np.zeros((edges, 1)), np.array([EPS * abs(value)]))


def between(low: Array, high: Array, edges: int) -> Form:
    """Anything between two bounds; NaN where they are no numbers."""
    c = 0.5 * (low + high)
    return Form(c, np.zeros((edges, len(c))), (np.maximum(high - c, c - low) + EPS * np.abs(c)) * SLACK)


def sine_cosine(x: Array) -> tuple[Array, Array]:
    """Sine and cosine, each within SINE_ERROR; NaN for more than LARGEST_TURNS quarter turns."""
    turns = np.rint(x * (2 / math.pi))
    x = np.where(np.abs(turns) <= LARGEST_TURNS, x, np.nan)
    turns = np.where(np.isnan(x), 0.0, turns)
    r = ((x - turns * QUARTER[0]) - turns * QUARTER[1]) - turns * QUARTER[2]
    z = r * r
    odd, even = np.zeros_like(z), np.zeros_like(z)
    for k in range(10, 0, -1):  # the series to r^21, r^20
        odd = -z * (1.0 + odd) / (2 * k * (2 * k + 1))
        even = -z * (1.0 + even) / (2 * k * (2 * k - 1))
    s, c = r + r * odd, 1.0 + even
    quarter = turns.astype(int) % 4
    swapped = quarter % 2 == 1
    s, c = np.where(swapped, c, s), np.where(swapped, s, c)
    return np.where(quarter >= 2, -s, s), np.where((quarter == 1) | (quarter == 2), -c, c)


def waves(x: Form) -> tuple[Form, Form]:
    """Sine and cosine: over the range each is within |slope| h + h^2 / 2 of that in the middle."""
    s, c = sine_cosine(x.c)
    h = x.radius
    error = SINE_ERROR * (2.0 + h)
    reach = 0.5 * h * h * SLACK + 2 * error
    around = [np.abs(slope) * h * SLACK + reach for slope in (c, s)]
    sine = x.along(s, c, (-s - around[0], around[0] - s))
    cosine = x.along(c, -s, (-c - around[1], around[1] - c))
    return sine.wider(error), cosine.wider(error)


def reciprocal(x: Form) -> Form:
    """1 / x; nothing is known where x may be 0."""
    low, high = x.bounds
    low, high = np.where((low > 0) | (high < 0), low, np.nan), np.where((low > 0) | (high < 0), high, np.nan)
    curved = np.sort(np.stack([2.0 / low**3, 2.0 / high**3]), axis=0)
    inverse = 1.0 / x.c
    return x.along(inverse, -inverse * inverse, (curved[0] - 8 * EPS * np.abs(curved[0]), curved[1] * SLACK + TINY))


def root(x: Form) -> Form:
    """The square root; of what may be 0, where it has no slope, just a range, of what may be less nothing."""
    low, high = x.bounds
    inside = low > 0
    a, c = np.where(inside, low, 1.0), np.where(inside, x.c, 1.0)
    value = np.sqrt(c)
    curved = -0.25 / (a * np.sqrt(a))
    smooth = x.along(value, 0.5 / value, (curved * SLACK, np.zeros_like(curved)))
    most = np.where(high >= 0, np.sqrt(np.maximum(high, 0.0)) * SLACK, np.nan)
    return choose(inside, smooth, between(np.zeros_like(most), most, len(x.l)))


def size(x: Form) -> Form:
    """|x|."""
    low, high = x.bounds
    sign = np.where(low >= 0, 1.0, np.where(high <= 0, -1.0, 0.0))
    same = Form(sign * x.c, sign * x.l, x.r)
    return choose(sign != 0, same, between(np.zeros_like(high), np.maximum(-low, high), len(x.l)))


def angle(y: Form, x: Form) -> Form:
    """atan2(y, x), where no point of the range is on the negative x axis; else nothing is known."""
    turn = np.arctan2(y.c, x.c) + np.zeros(np.broadcast_shapes(y.c.shape, x.c.shape))
    s, c = sine_cosine(turn)
    error, none = np.full_like(turn, SINE_ERROR), np.zeros((len(x.l), len(turn)))
    sin, cos = Form(s, none, error), Form(c, none, error)
    along = cos * x + sin * y
    across = cos * y - sin * x
    low, _ = along.bounds
    ratio = across * reciprocal(along)
    far = np.maximum(*np.abs(ratio.bounds))
    made = Form(ratio.c + turn, ratio.l, (ratio.r + far**3 / 3 + 4 * EPS * (np.abs(turn) + far)) * SLACK)
    least, most = made.bounds
    sound = (low > 0) & (least > -3.14159265358979) & (most < 3.14159265358979)
    return Form(made.c, made.l, np.where(sound, made.r, np.nan))


def less(a: Form, b: Form) -> Form:
    """1 where a < b, 0 where not, something between where that is open."""
    low, high = (a - b).bounds
    decided = np.where(high < 0, 1.0, 0.0)
    sure = (high < 0) | (low >= 0)
    return Form(np.where(sure, decided, 0.5), np.zeros((len(a.l), len(low))), np.where(sure, 0.0, 0.5))


def choose(first: Array, a: Form, b: Form) -> Form:
    """a where `first`, else b."""
    return Form(np.where(first, a.c, b.c), np.where(first, a.l, b.l), np.where(first, a.r, b.r))


def selected(condition: Form, a: Form, b: Form) -> Form:
    """a where the condition is not 0, b where it is, both where that is open."""
    low, high = (np.stack(np.broadcast_arrays(*ends)) for ends in zip(a.bounds, b.bounds, strict=True))
    both = between(low.min(axis=0), high.max(axis=0), len(a.l))
    least, most = condition.bounds
    true, false = (least > 0) | (most < 0), (condition.c == 0) & (condition.radius == 0)
    return choose(true | false, choose(true, a, b), both)


OPERATIONS: Mapping[str, Callable[..., Form]] = {
    "add": Form.__add__,
    "sub": Form.__sub__,
    "mul": Form.__mul__,
    "neg": Form.__neg__,
    "div": lambda a, b: a * reciprocal(b),
    "reciprocal": reciprocal,
    "sqrt": root,
    "sin": lambda x: waves(x)[0],
    "cos": lambda x: waves(x)[1],
    "tan": lambda x: waves(x)[0] * reciprocal(waves(x)[1]),
    "atan2": angle,
    "abs": size,
    "less": less,
    "select": selected,
}


# -- programs -----------------------------------------------------------------------------------------------


def _factors(op: str, args: Sequence[Form], made: Form) -> Sequence[Form | float]:
    """The derivatives of an operation by its operands, those of sine and cosine left aside."""
    if op in ("add", "sub", "neg"):
        return {"add": [1.0, 1.0], "sub": [1.0, -1.0], "neg": [-1.0]}[op]
    if op == "mul":
        return [args[1], args[0]]
    if op == "reciprocal":
        return [-(made * made)]
    if op == "sqrt":
        return [reciprocal(made + made)]
    if op == "div":
        back = reciprocal(args[1])
        return [back, -(made * back)]
    raise UnreadableError(f"an equation of closure with the operation {op!r}, whose slope is not known here")


def _scaled(slopes: Form, factor: Form | float) -> Form:
    """Slopes (columns, n) times one form (n,), or a sign."""
    if isinstance(factor, Form):
        return slopes * Form(factor.c[None], factor.l[:, None], factor.r[None])
    return slopes if factor > 0 else -slopes


@dataclass(frozen=True)
class Program:
    """Instructions [target, operation, operands ...]: slots are whole numbers, constants floating ones."""

    inputs: tuple[tuple[str, int], ...]
    instructions: tuple[tuple[int, str, tuple[int | float, ...]], ...]
    results: tuple[int | float, ...]

    @classmethod
    def read(cls, values: Any) -> Program:
        """Of a file: every operand is computed before it is used."""
        inputs = tuple((str(name), int(count)) for name, count in values["inputs"])
        need(all(0 <= count <= MOST_INPUTS for _, count in inputs) and len(dict(inputs)) == len(inputs), "inputs")
        known = set(range(sum(count for _, count in inputs)))
        instructions = []
        for target, op, *args in values["instructions"]:
            if op not in OPERATIONS or type(target) is not int or target in known:
                raise UnreadableError(f"an instruction {op!r} to slot {target!r}")
            instructions.append((target, str(op), tuple(_operand(a, known) for a in args)))
            known.add(target)
        return cls(inputs, tuple(instructions), tuple(_operand(a, known) for a in values["results"]))

    def run(self, given: Mapping[str, Sequence[Form]], *, slopes: bool = False) -> tuple[list[Form], list[Form | None]]:
        """Its results; with `slopes` also their derivatives (coordinates q and parameters, n), None for a constant."""
        edges = len(given["q"][0].l)
        zero = Form(np.zeros(1), np.zeros((edges, 1)), np.zeros(1))
        flat = [f for name, n in self.inputs for f in (given[name] if name in given else [zero] * n)]
        slots: dict[int, Form] = dict(enumerate(flat))
        rates: dict[int, Form] = self._seeds(given, edges) if slopes else {}
        turns: dict[int, tuple[Form, Form]] = {}
        for target, op, args in self.instructions:
            operands = [slots[a] if isinstance(a, int) else constant(a, edges) for a in args]
            turning = args[0] if op in ("sin", "cos") and isinstance(args[0], int) else None
            if turning is not None:
                if turning not in turns:
                    turns[turning] = waves(operands[0])
                s, c = turns[turning]
                slots[target] = made = s if op == "sin" else c
            else:
                slots[target] = made = OPERATIONS[op](*operands)
            if any(isinstance(a, int) and a in rates for a in args):
                factors = _factors(op, operands, made) if turning is None else [c if op == "sin" else -s]
                pairs = zip(args, factors, strict=True)
                parts = [_scaled(rates[a], factor) for a, factor in pairs if isinstance(a, int) and a in rates]
                rates[target] = parts[0] if len(parts) == 1 else parts[0] + parts[1]
        values = [slots[a] if isinstance(a, int) else constant(a, edges) if a else zero for a in self.results]
        return values, [rates.get(a) if isinstance(a, int) else None for a in self.results]

    def _seeds(self, given: Mapping[str, Sequence[Form]], edges: int) -> dict[int, Form]:
        """The derivatives of the inputs by themselves."""
        columns = {"q": 0, "p": len(given["q"])}
        width, start, seeds = len(given["q"]) + len(given["p"]), 0, {}
        for name, n in self.inputs:
            for k in range(n if name in columns else 0):
                c = np.zeros((width, 1))
                c[columns[name] + k] = 1.0
                seeds[start + k] = Form(c, np.zeros((edges, width, 1)), np.zeros((width, 1)))
            start += n
        return seeds


def _operand(value: Any, known: set[int]) -> int | float:
    if type(value) is int and value in known:
        return value
    if type(value) is float and math.isfinite(value):
        return value
    raise UnreadableError(f"an operand {value!r} that is no slot before it and no constant")


# -- boxes -------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Condition:
    """A program of q whose results are not zero (margins), or within limits (None: any)."""

    program: Program
    names: tuple[str, ...]
    limits: tuple[tuple[float | None, float | None], ...] | None

    @classmethod
    def read(cls, values: Any) -> Condition:
        """Of a file."""
        program, names = Program.read(values["program"]), tuple(map(str, values["names"]))
        limits = values["limits"]
        if limits is not None:
            limits = tuple(tuple(None if end is None else float(end) for end in ends) for ends in limits)
        need(len(names) == len(program.results) == (len(names) if limits is None else len(limits)), "names of results")
        return cls(program, names, limits)

    def limits_in_words(self) -> list[str]:
        """What is within which limits."""
        return [f"{name} within {list(ends)}" for name, ends in zip(self.names, self.limits or (), strict=False)]


def need(holds: bool, what: str) -> None:
    """Raises UnreadableError."""
    if not holds:
        raise UnreadableError(f"{what}: not as expected")


@dataclass(frozen=True)
class Equations:
    """F(q, z) = 0: `rows` of the closure and the unit length of quaternions, for all q that are no axis and not held.

    `axes`: for every edge of a box ("q", index) or ("p", index). `held`: q -> value of the coordinates that are held.
    `parameters`: values, of those that are axes any. `driven`: coordinates q of the drives; None where a drive is none.
    """

    closure: Program
    rows: tuple[int, ...]
    quaternions: tuple[int, ...]
    count: int
    axes: tuple[tuple[str, int], ...]
    held: Mapping[int, float]
    parameters: tuple[float, ...]
    driven: tuple[int, ...] | None
    conditions: tuple[Condition, ...]

    @classmethod
    def of(cls, values: Any) -> Equations:
        """Of a file, whether or not there are as many equations as coordinates."""
        return cls(
            Program.read(values["closure"]),
            tuple(map(int, values["rows"])),
            tuple(map(int, values["quaternions"])),
            int(values["count"]),
            tuple((str(kind), int(k)) for kind, k in values["axes"]),
            {int(k): float(x) for k, x in values["held"]},
            tuple(map(float, values["parameters"])),
            None if values["driven"] is None else tuple(map(int, values["driven"])),
            tuple(map(Condition.read, values["conditions"])),
        )

    @classmethod
    def read(cls, values: Any) -> Equations:
        """Of a file."""
        made = cls.of(values)
        there = {"q": made.count, "p": len(made.parameters)}
        need(0 < made.count <= MOST_INPUTS, "coordinates")
        need(1 <= len(made.axes) <= MOST_EDGES and len(set(made.axes)) == len(made.axes), "axes")
        need(all(kind in there and 0 <= k < there[kind] for kind, k in made.axes), "edges that are no coordinate")
        given = [program.inputs for program in (made.closure, *(c.program for c in made.conditions))]
        need(all(n == there.get(name, n) for inputs in given for name, n in inputs), "coordinates of a program")
        rows, count = len(made.closure.results), made.count
        places = [(made.rows, rows), (made.quaternions, count - 3), (made.held, count), (made.driven or (), count)]
        need(all(0 <= k < n for numbers, n in places for k in numbers), "numbers of rows and coordinates")
        names = [name for condition in made.conditions for name in condition.names]
        need(len(set(names)) == len(names), "names of conditions")
        need(len(set(made.rows)) + len(set(made.quaternions)) == len(made.dependent), "equations for the coordinates")
        return made

    @property
    def dependent(self) -> list[int]:
        """The coordinates q that follow from z."""
        given = {k for kind, k in self.axes if kind == "q"} | set(self.held)
        return [k for k in range(self.count) if k not in given]

    def inputs(self, z: Sequence[Form], q: Sequence[Form]) -> dict[str, list[Form]]:
        """All inputs of a program: `q` are the dependent coordinates."""
        edges = len(z[0].l)
        every = {k: constant(x, edges) for k, x in self.held.items()}
        p = [constant(x, edges) for x in self.parameters]
        for (kind, k), form in zip(self.axes, z, strict=True):
            if kind == "q":
                every[k] = form
            else:
                p[k] = form
        every |= dict(zip(self.dependent, q, strict=True))
        return {"q": [every[k] for k in range(self.count)], "p": p}

    def residual(self, given: Mapping[str, Sequence[Form]], *, slopes: bool) -> tuple[list[Form], list[Form | None]]:
        """F, and with `slopes` its derivatives by q and the parameters."""
        values, rates = self.closure.run(given, slopes=slopes)
        found, rows = [values[k] for k in self.rows], [rates[k] for k in self.rows]
        for start in self.quaternions:
            parts = given["q"][start : start + 4]
            found.append(sum((x * x for x in parts), constant(-1.0, len(parts[0].l))))
            if slopes:
                width, count = self.count + len(self.parameters), len(parts[0].c)
                c, l, r = np.zeros((width, count)), np.zeros((len(parts[0].l), width, count)), np.zeros((width, count))
                for k, x in enumerate(parts):
                    c[start + k], l[:, start + k], r[start + k] = 2 * x.c, 2 * x.l, 2 * x.r
                rows.append(Form(c, l, r))
        return found, rows


@dataclass(frozen=True)
class Tubes:
    """What was found of n boxes with k edges and m dependent coordinates.

    `low`, `high` (k, n): the boxes; `centre` (m, n) + `slope` (m, k, n) d + [-radius, radius] (m, n) holds one
    configuration and no other, and it is within `tight` (m, n) of centre and slope; `closed`: whether that is so,
    `holding`: whether the drives hold. `bounds`: least and largest value (n,), (n,) of every result by name.
    """

    low: Array
    high: Array
    centre: Array
    slope: Array
    radius: Array
    tight: Array
    closed: Array
    holding: Array
    bounds: Mapping[str, tuple[Array, Array]]


def together(parts: Sequence[Tubes], places: Array | slice = slice(None)) -> Tubes:
    """What was found of boxes, side by side; of these those at some places."""
    *arrays, _ = (f.name for f in fields(Tubes))
    ends = {n: np.hstack([np.stack(part.bounds[n]) for part in parts])[:, places] for n in parts[0].bounds}
    return Tubes(
        **{n: np.concatenate([getattr(part, n) for part in parts], axis=-1)[..., places] for n in arrays},
        bounds={n: (low, high) for n, (low, high) in ends.items()},
    )


def _matrix(rows: Sequence[Form | None], columns: Sequence[int], shape: tuple[int, int]) -> Form:
    """Derivatives by some columns, (rows, columns, boxes), for a shape (edges, boxes)."""
    size = (len(rows), len(columns), shape[1])
    c, l, r = np.zeros(size), np.zeros((shape[0], *size)), np.zeros(size)
    for i, row in enumerate(rows):
        if row is not None:
            c[i], l[:, i], r[i] = row.c[list(columns)], row.l[:, list(columns)], row.r[list(columns)]
    return Form(c, l, r)


def _inverses(matrices: Array) -> Array:
    """Inverses, or pseudo-inverses of tall matrices (rows, columns, n), as (n, columns, rows); zero where none is."""
    turned = np.moveaxis(matrices, -1, 0)
    found = np.zeros(turned.transpose(0, 2, 1).shape)
    sound = np.isfinite(turned).all(axis=(1, 2))
    if found.size:
        found[sound] = np.linalg.pinv(turned[sound], rcond=1e-12)
    return found


def _times(inverse: Array, matrix: Form) -> Form:
    """inverse (n, i, j) times a matrix (j, columns, n) or a vector (j, n)."""
    rounding = (2 * inverse.shape[2] + 8) * EPS
    wide = matrix.r + rounding * (np.abs(matrix.c) + matrix.s)
    c = np.einsum("nij,j...n->i...n", inverse, matrix.c)
    l = np.einsum("nij,kj...n->ki...n", inverse, matrix.l)
    return Form(c, l, np.einsum("nij,j...n->i...n", np.abs(inverse), wide) * SLACK + TINY)


def _stacked(values: Sequence[Form], count: int) -> Form:
    """Forms (n,) as one (m, n)."""
    return Form(
        np.stack([np.broadcast_to(f.c, count) for f in values]),
        np.stack([np.broadcast_to(f.l, (len(f.l), count)) for f in values], axis=1),
        np.stack([np.broadcast_to(f.r, count) for f in values]),
    )


def _size(form: Form) -> Array:
    """|form|, from above."""
    return np.asarray((np.abs(form.c) + form.s + form.r) * SLACK)


def _defects(inverse: Array, matrix: Form, edges: int) -> tuple[Array, Array]:
    """|1 - inverse M|, from above (columns, columns, n), of means from a tube's middle to its places; and for all M.

    The means have half of what is linear in the edges behind the first ones.
    """
    product = _times(inverse, matrix)
    rest = np.abs(np.eye(matrix.c.shape[1])[:, :, None] - product.c) + product.r + 4 * EPS
    box, tube = (np.abs(part).sum(axis=0) * SLACK for part in (product.l[:edges], product.l[edges:]))
    return (rest + box + 0.5 * tube) * SLACK, (rest + box + tube) * SLACK


def full_rank(matrix: Form) -> Array:
    """Whether all matrices (rows, columns, n) have full column rank: some inverse comes close to 1 in some norm.

    The norm is the largest entry over weights w, which power iteration looks for: |1 - inverse M| w < w.
    """
    if matrix.c.shape[0] < matrix.c.shape[1]:
        return np.zeros(matrix.c.shape[2], dtype=bool)
    defect = _defects(_inverses(matrix.c), matrix, len(matrix.l))[1]
    w = np.ones(defect.shape[1:])
    found = np.zeros(defect.shape[2], dtype=bool)
    for _ in range(8):  # after which the weights are those of the largest eigenvalue where it stands apart
        image = np.einsum("ijn,jn->in", defect, w) * SLACK
        found |= ((image < w) & (w > 0)).all(axis=0)
        w = image + 1e-3 * image.max(axis=0, initial=0.0) + TINY
    return found


def middle_of(low: Array, high: Array) -> tuple[Array, Array]:
    """Middle of boxes, and half of their edges (k, n), from above."""
    middle = 0.5 * (low + high)
    return middle, np.maximum(high - middle, middle - low) * SLACK


def edges_of(low: Array, high: Array) -> list[Form]:
    """The coordinates of boxes as forms that reach all of them."""
    middle, half = middle_of(low, high)
    along = np.eye(len(low))[:, :, None] * half
    return [Form(middle[k], along[k], np.zeros_like(middle[k])) for k in range(len(low))]


def _points(equations: Equations, z: Array, q: Array) -> dict[str, list[Form]]:
    """Inputs without any uncertainty at z (k, n) and dependent coordinates (m, n)."""
    none = np.zeros((0, z.shape[1]))
    made = [[Form(x, none, np.zeros(z.shape[1])) for x in values] for values in (z, q)]
    return equations.inputs(*made)


def configurations(equations: Equations, z: Array, guess: Array) -> tuple[Array, Array]:
    """Dependent coordinates (m, n) at z (k, n) by Newton's method, without any proof, and whether it came to rest."""
    count, dependent = z.shape[1], equations.dependent
    q, still = guess + 0.0, np.full(count, not dependent)
    for _ in range(NEWTON if dependent else 0):
        values, rows = equations.residual(_points(equations, z, q), slopes=True)
        matrix = _matrix(rows, dependent, (0, count)).c
        step = np.einsum("nij,jn->in", _inverses(matrix), _stacked(values, count).c)
        bound = np.maximum(1.0, np.abs(q).max(axis=0))
        step = np.where(np.abs(step).max(axis=0) < bound, step, np.nan)  # a longer one leads anywhere
        q = q - step
        still = np.abs(step).max(axis=0) < STILL * np.maximum(1.0, np.abs(q).max(axis=0))
        if (still | np.isnan(q).any(axis=0)).all():
            break
    return q, still


def tubes(equations: Equations, low: Array, high: Array, centre: Array) -> Tubes:
    """What holds in boxes (k, n) about configurations (m, n) in their middle; AT_ONCE are looked at together.

    Where nothing is shown the tube gets an edge for every dependent coordinate, as far as MOST_EDGES: dearer, sharper.
    """
    found = []
    with np.errstate(all="ignore"):
        for a in range(0, low.shape[1], AT_ONCE):
            ends = [end[..., a : a + AT_ONCE] for end in (low, high, centre)]
            plain = _tubes(equations, *ends, sharp=False)
            again = np.flatnonzero(~(plain.closed & plain.holding) & np.isfinite(plain.slope).all(axis=(0, 1)))
            if len(again) and 0 < len(equations.dependent) <= MOST_EDGES - len(low):
                places = np.arange(plain.low.shape[1])
                places[again] = len(places) + np.arange(len(again))
                plain = together([plain, _tubes(equations, *(end[:, again] for end in ends), sharp=True)], places)
            found.append(plain)
    return found[0] if len(found) == 1 else together(found)


def _tubes(equations: Equations, low: Array, high: Array, centre: Array, *, sharp: bool) -> Tubes:
    count, dependent = low.shape[1], equations.dependent
    z, shape = edges_of(low, high), (len(low) + len(dependent) * sharp, count)
    slope, radius = np.zeros((len(dependent), *low.shape)), np.zeros((len(dependent), count))
    tight, closed, holding = radius, np.full(count, True), np.full(count, True)
    if dependent:
        slope, off, inverse = _middle(equations, z, centre)
        moving = [Form(x, l, np.zeros(count)) for x, l in zip(centre, slope, strict=True)]
        fixed, image, missed, closed, rows = off, off, off, np.zeros(count, dtype=bool), []
        for wide in WIDEN:
            trial = np.maximum(wide * fixed, missed) + LEAST * (1.0 + np.abs(centre))
            trial = np.where(closed, radius, trial)
            rows = equations.residual(_inside(equations, (z, moving), trial, sharp=sharp), slopes=True)[1]
            mean, defect = _defects(inverse, _matrix(rows, dependent, shape), len(z))
            image = (off + np.einsum("ijn,jn->in", mean, trial)) * SLACK
            radius = trial
            closed = (image < trial).all(axis=0) & (np.einsum("ijn,jn->in", defect, trial) * SLACK < trial).all(axis=0)
            missed = np.where(image < trial, 0.0, 2.0 * image)  # entries that follow from squares of others
            for _ in range(SETTLING):  # to the fixed point off + defect E, were the defect that of a smaller tube
                last, fixed = fixed, off + np.einsum("ijn,jn->in", mean, fixed)
            hopeful = ~closed & (fixed.max(axis=0) < SETTLED * last.max(axis=0))
            if not hopeful.any():
                break
        tight = np.where(closed, image, np.nan)
        if equations.driven is not None:
            left = [k for k in range(equations.count) if k not in equations.driven]
            holding = full_rank(_matrix(rows, left, shape)) if left else holding
    known = [Form(x, l, e) for x, l, e in zip(centre, slope, tight, strict=True)]
    given = equations.inputs(z, known)
    bounds = {}
    for condition in equations.conditions:
        for name, form in zip(condition.names, condition.program.run(given)[0], strict=True):
            least, most = form.bounds
            bounds[name] = (np.broadcast_to(least, count), np.broadcast_to(most, count))
    return Tubes(low, high, centre, slope, radius, tight, closed, holding, bounds)


def _inside(
    equations: Equations, middle: tuple[Sequence[Form], Sequence[Form]], trial: Array, *, sharp: bool
) -> dict[str, list[Form]]:
    """All inputs in tubes of the radius `trial` (m, n) about z and the q that follow: `sharp`, along m own edges."""
    z, moving = middle
    if not sharp:
        return equations.inputs(z, [f.wider(e) for f, e in zip(moving, trial, strict=True)])
    wider = ((z, [0.0 * trial] * len(z)), (moving, np.eye(len(trial))[:, :, None] * trial))
    return equations.inputs(
        *([Form(f.c, np.concatenate([f.l, e]), f.r) for f, e in zip(*pair, strict=True)] for pair in wider)
    )


def _middle(equations: Equations, z: Sequence[Form], centre: Array) -> tuple[Array, Array, Array]:
    """How q follows z in the middle (m, k, n), how far C F is from 0 on q0 + A (z - z0) (m, n), and C (n, m, m).

    F is F(middle) + (mean of F' on the way there) (A, 1) (z - z0): of the part of F' that is linear in z - z0, half.
    """
    count, dependent, edges = centre.shape[1], equations.dependent, range(len(z))
    columns = [k if kind == "q" else equations.count + k for kind, k in equations.axes]
    half = np.stack([f.l[k] for k, f in enumerate(z)])
    values, rows = equations.residual(_points(equations, np.stack([f.c for f in z]), centre), slopes=True)
    inverse = _inverses(_matrix(rows, dependent, (0, count)).c)
    slope = -np.einsum("nij,jkn->ikn", inverse, _matrix(rows, columns, (0, count)).c) * half
    moving = [Form(x, l, np.zeros(count)) for x, l in zip(centre, slope, strict=True)]
    rows = equations.residual(equations.inputs(z, moving), slopes=True)[1]
    along = _times(inverse, _matrix(rows, dependent, (len(z), count)))
    across = _times(inverse, _matrix(rows, columns, (len(z), count)))
    start = _times(inverse, _stacked(values, count))
    off = Form(start.c, np.zeros((len(z), *start.c.shape)), start.r)
    for k in edges:
        ways = [*slope[:, k], half[k]]
        mean = Form(
            np.stack([*np.moveaxis(along.c, 1, 0), across.c[:, k]]),
            0.5 * np.stack([*np.moveaxis(along.l, 2, 0), across.l[:, :, k]], axis=1),
            np.stack([*np.moveaxis(along.r, 1, 0), across.r[:, k]]),
        )
        total = _times(np.stack(ways).T[:, None, :], mean)
        one = np.zeros((len(z), 1, count))
        one[k] = 1.0
        off = off + Form(total.c[0], total.l[:, 0], total.r[0]) * Form(np.zeros((1, count)), one, np.zeros((1, count)))
    return slope, _size(off), inverse


def meet(equations: Equations, found: Tubes, pairs: Sequence[tuple[int, int]]) -> Array:
    """Whether both tubes of each pair of boxes hold the same configuration at a point that the boxes have in common."""
    if not len(pairs):
        return np.zeros(0, dtype=bool)
    first, second = np.array(pairs, dtype=int).T
    low = np.maximum(found.low[:, first], found.low[:, second])
    high = np.minimum(found.high[:, first], found.high[:, second])
    sound = (low <= high).all(axis=0) & found.closed[first] & found.closed[second]
    point = 0.5 * (low + high)
    if not equations.dependent:
        return np.asarray(sound)
    starts = found.centre[:, first] + np.einsum("mkn,kn->mn", found.slope[:, :, first], _offset(found, first, point))
    return np.asarray(sound & _both_hold(equations, found, (first, second), (point, starts)))


def holds_start(equations: Equations, found: Tubes, box: int, start: tuple[Array, Array]) -> bool:
    """Whether the tube of a box holds the configuration at z (k,) that belongs to the dependent coordinates (m,)."""
    z, q = start
    inside = ((found.low[:, box] <= z) & (z <= found.high[:, box])).all()
    one = np.array([box])
    if not equations.dependent:
        return bool(inside and found.closed[box])
    same = _both_hold(equations, found, (one, one), (z[:, None], q[:, None]), far=1e-6)
    return bool(inside and found.closed[box] and same[0])


def _offset(found: Tubes, boxes: Array, point: Array) -> Array:
    """Points as d in [-1, 1] of boxes; 0 along edges without length."""
    middle, half = middle_of(found.low[:, boxes], found.high[:, boxes])
    return np.where(half > 0, (point - middle) / np.where(half > 0, half, 1.0), 0.0)


def _both_hold(
    equations: Equations, found: Tubes, boxes: tuple[Array, Array], start: tuple[Array, Array], *, far: float = math.inf
) -> Array:
    """Whether the configuration at points, by Newton's method from q within `far`, is in the tubes of both boxes."""
    point, guess = start
    holds = np.zeros(point.shape[1], dtype=bool)
    for a in range(0, point.shape[1], AT_ONCE):
        part = slice(a, a + AT_ONCE)
        z = point[:, part]
        with np.errstate(all="ignore"):
            q, _ = configurations(equations, z, guess[:, part])
            bare = Equations(**{**equations.__dict__, "conditions": (), "driven": None})
            at = _tubes(bare, z, z, q, sharp=False)
            good = at.closed & (np.abs(q - guess[:, part]) <= far * (1.0 + np.abs(q))).all(axis=0)
            for box in (boxes[0][part], boxes[1][part]):
                d = _offset(found, box, z)
                off = np.abs(q - found.centre[:, box] - np.einsum("mkn,kn->mn", found.slope[:, :, box], d))
                size = np.abs(q) + np.abs(found.centre[:, box]) + np.abs(found.slope[:, :, box]).sum(axis=1)
                good &= ((off + at.tight + 64 * EPS * size) * SLACK < found.radius[:, box]).all(axis=0)
        holds[part] = good
    return holds


# -- claims ------------------------------------------------------------------------------------------------

CLAIMED, OPEN, BEYOND = -1, -2, -3  # what a leaf of the splitting is: a box, undecided, outside the disk of the region


@dataclass(frozen=True)
class Cells:
    """The leaves of a splitting: low, high (k, n), what each is (n,), and its part of the region (n,)."""

    low: Array
    high: Array
    kind: Array
    share: Array


def cells_of(low: Sequence[float], high: Sequence[float], splitting: Sequence[int]) -> Cells:
    """The region halved as the list says, in the order of its leaves: an axis and both halves, or what a leaf is."""
    waiting = [(list(map(float, low)), list(map(float, high)), 1.0)]
    leaves = []
    for code in splitting:
        if not waiting or type(code) is not int or not BEYOND <= code < len(low):
            raise UnreadableError(f"a splitting with {code!r}")
        a, b, share = waiting.pop()
        if code < 0:
            leaves.append((a, b, code, share))
            continue
        middle = 0.5 * (a[code] + b[code])
        upper, lower = a[:], b[:]
        upper[code] = lower[code] = middle
        waiting += [(upper, b, 0.5 * share), (a, lower, 0.5 * share)]
    if waiting:
        raise UnreadableError("a splitting that ends early")
    lows, highs, kinds, shares = zip(*leaves, strict=True)
    return Cells(np.array(lows).T, np.array(highs).T, np.array(kinds), np.array(shares))


def disk_of(values: Any, edges: int) -> tuple[list[int], float]:
    """(two edges of the region, radius) of all directions up to the radius about 0."""
    (i, j), radius = values["axes"], float(values["radius"])
    if {type(i), type(j)} != {int} or i == j or not (min(i, j) >= 0 and max(i, j) < edges and radius > 0):
        raise UnreadableError(f"a disk over {i!r}, {j!r} with the radius {radius!r}")
    return [i, j], radius


@dataclass(frozen=True)
class Verdict:
    """What a file proves: `proved` in words, `refused` with the reason, what it rests on, and what was found.

    `mechanism`: the name in the file, with the first digits of the SHA-256 of the description in it. `region`: of what
    it is a proof, in words.
    """

    mechanism: str
    proved: tuple[str, ...]
    refused: tuple[str, ...]
    assumed: tuple[str, ...]
    facts: Mapping[str, Any]
    region: str = ""

    @property
    def holds(self) -> bool:
        """Whether every claim of the file is proved, and there is one."""
        return bool(self.proved) and not self.refused

    def __str__(self) -> str:
        words = (("proved", self.proved), ("REFUSED", self.refused), ("assumed", self.assumed))
        lines = [f"{word}: {text}" for word, texts in words for text in texts]
        end = "every claim of the file is proved" if self.holds else "the file does not prove what it claims"
        return "\n".join(map(printable, [f"Workspace of {self.mechanism}", self.region, *lines, end]))


def printable(text: str) -> str:
    """One line of text in which nothing moves the cursor: a name in a file must not say what the checker says."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


def facts_of(equations: Equations, cells: Cells, values: Any) -> dict[str, Any]:
    """What the file proves, as numbers; raises RefusedError at the first box that is not as claimed."""
    boxes = np.flatnonzero(cells.kind == CLAIMED)
    centre = np.array(values["configurations"], dtype=float).reshape(len(boxes), -1).T
    need(centre.shape[0] == len(equations.dependent) and len(boxes) > 0, "configurations of the claimed boxes")
    found = tubes(equations, cells.low[:, boxes], cells.high[:, boxes], centre)
    refuse(found.closed, "more or less than one configuration may be in the tube")
    refuse(found.holding, "with the drives locked a freedom may be left")
    least: dict[str, float] = {}
    for condition in equations.conditions:
        for k, name in enumerate(condition.names):
            low, high = found.bounds[name]
            if condition.limits is None:
                refuse((low > 0) | (high < 0), f"{name} may be zero")
                least[name] = float(np.maximum(low, -high).min())
                continue
            least_allowed, most_allowed = condition.limits[k]
            if least_allowed is not None:
                refuse(low >= least_allowed, f"{name} may be too small")
            if most_allowed is not None:
                refuse(high <= most_allowed, f"{name} may be too large")
    pairs = [(int(i), int(j)) for i, j in values["joints"]]
    if any(not 0 <= k < len(boxes) for pair in pairs for k in pair):
        raise UnreadableError("boxes that are joined but not there")
    start = values["start"]
    z, q = np.array(start["z"], dtype=float), np.array(start["q"], dtype=float)
    if not holds_start(equations, found, int(start["box"]), (z, q)):
        raise RefusedError("the first box does not hold the configuration at the start")
    same = meet(equations, found, pairs)
    if not same.all():
        raise RefusedError(f"boxes {pairs[int(np.argmin(same))]} may hold different configurations where they meet")
    reached = {int(start["box"])}
    for i, j in pairs:  # in an order in which the first of a pair is reached before
        if i not in reached:
            raise RefusedError(f"box {i} comes before what joins it to the start")
        reached.add(j)
    if len(reached) != len(boxes):
        raise RefusedError(f"{len(boxes) - len(reached)} boxes are not joined to the start")
    beyond = np.zeros(len(cells.kind), dtype=bool)
    facts: dict[str, Any] = {"boxes": len(boxes), "least": least}
    if values["disk"] is not None:
        axes, radius = disk_of(values["disk"], len(cells.low))
        distance = np.hypot(*np.maximum(0.0, np.maximum(cells.low[axes], -cells.high[axes]))) * (1 - 8 * EPS)
        beyond = distance > radius
        if (cells.low[axes].min(axis=1) > -radius).any() or (cells.high[axes].max(axis=1) < radius).any():
            raise RefusedError("the disk is larger than the region")
        facts["radius"] = float(np.minimum(distance[cells.kind != CLAIMED], radius).min(initial=radius))
    facts["whole"] = bool((beyond | (cells.kind == CLAIMED)).all())
    inside = cells.share[~beyond].sum()
    facts["share"] = float(cells.share[~beyond & (cells.kind == CLAIMED)].sum() / inside)
    return facts


def refuse(sound: Array, why: str) -> None:
    """Raises RefusedError at the first box that is not sound."""
    if not sound.all():
        raise RefusedError(f"box {int(np.argmin(sound))}: {why}")


def check_certificate(values: Any) -> Verdict:
    """Judges every claim of a certificate.

    Args:
        values: what the JSON file holds.

    Raises:
        UnreadableError: it is no certificate.
    """
    try:
        if values["format"] != FORMAT:
            raise UnreadableError(f"expected the format {FORMAT!r}, got {str(values['format'])[:60]!r}")
        name, claims = _called(values["mechanism"]), values["claims"]
        equations = Equations.read(values["equations"])
        region = values["region"]
        cells = cells_of(region["low"], region["high"], values["splitting"])
        need(
            len(cells.low) == len(equations.axes) == len(region["high"]) == len(region["names"]), "edges of the region"
        )
        need(isinstance(claims, dict), "claims")
        need(all(a <= b for a, b in zip(region["low"], region["high"], strict=True)), "ends of the region")
        words, assumed = region_in_words(values), _assumed(equations, values["equations"]["labels"])
        try:
            facts = facts_of(equations, cells, values)
        except RefusedError as error:
            return Verdict(name, (), (str(error),), assumed, {}, words)
    except (KeyError, TypeError, ValueError, IndexError, AttributeError, RecursionError, OverflowError) as error:
        raise UnreadableError(f"{type(error).__name__}: {error}") from error
    proved: list[str] = []
    refused: list[str] = []
    for key, value in claims.items():
        text = f"{key} {_claim(value)}"
        (proved if _carried(facts.get(key), value) else refused).append(text)
    if proved:  # the limits hold in the boxes that a claim is about
        proved += [text for condition in equations.conditions for text in condition.limits_in_words()]
    return Verdict(name, tuple(proved), tuple(refused), assumed, facts, words)


def region_in_words(values: Any) -> str:
    """Of what a file is a proof: the ranges of its edges, and the disk in them."""
    region, disk = values["region"], values["disk"]
    edges = zip(region["names"], region["low"], region["high"], strict=True)
    text = "over " + ", ".join(f"{name} {float(low):.6g} to {float(high):.6g}" for name, low, high in edges)
    if disk is not None:
        names = " and ".join(str(region["names"][k]) for k in disk["axes"])
        text += f", of these all directions of {names} up to {float(disk['radius']):.6g}"
    return text


def values_of(text: str) -> Any:
    """What JSON text holds, where every key is there once, as another reader might take the other, and no NaN is."""

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        made = dict(pairs)
        need(len(made) == len(pairs), "keys of an object")
        return made

    def refused(name: str) -> Any:
        raise UnreadableError(f"{name}, which is no number")

    return json.loads(text, object_pairs_hook=once, parse_constant=refused)


def said(text: str) -> None:
    """Prints it; where the console has no such letter, its number stands for it."""
    encoding = sys.stdout.encoding or "ascii"
    print(text.encode(encoding, "backslashreplace").decode(encoding))


def digest(text: str) -> str:
    """SHA-256 of a description, hexadecimal."""
    return hashlib.sha256(text.encode()).hexdigest()


def _called(mechanism: Any) -> str:
    """The name of a mechanism and what its description hashes to."""
    name, text = str(mechanism["name"]), mechanism.get("toml")
    return name if text is None else f"{name} (description {digest(str(text))[:SHOWN]})"


def _claim(value: Any) -> str:
    """What is claimed in words, with all digits: rounded it could be more than is proved."""
    if isinstance(value, dict):
        return ", ".join(f"{name} {json.dumps(number)}" for name, number in value.items())
    return "yes" if value is True else json.dumps(value)


def _carried(fact: Any, claim: Any) -> bool:
    """Whether what was found is at least what is claimed."""
    if isinstance(claim, dict):
        return isinstance(fact, dict) and all(_carried(fact.get(k), v) for k, v in claim.items())
    if isinstance(claim, bool) or fact is None:
        return isinstance(fact, bool) and (fact or not claim)
    return isinstance(claim, int | float) and bool(fact >= claim)


def _assumed(equations: Equations, labels: Sequence[str]) -> tuple[str, ...]:
    """What the proof does not show: that equations which are left out follow from the others."""
    results = equations.closure.results
    left = [str(labels[k]) for k in range(len(results)) if k not in equations.rows and results[k] != 0.0]
    made = [OF_MECHANISM, OF_START]
    if left:
        made.append(f"rows of the closure that follow from the others: {', '.join(left)}")
    if equations.driven is None and not any(n.startswith("actuation") for c in equations.conditions for n in c.names):
        made.append("nothing is shown of the drives: whether they hold the mechanism was not looked at")
    return tuple(made)


def main(arguments: Sequence[str]) -> int:
    """Checks a file, says what it proves; 0, 1 or 2 as above."""
    if len(arguments) != 1:
        print("usage: certificate_checker.py FILE", file=sys.stderr)
        return 2
    try:
        with open(arguments[0], encoding="utf-8") as file:
            verdict = check_certificate(values_of(file.read()))
    except (OSError, ValueError, RecursionError, MemoryError, UnreadableError) as error:
        print(f"{arguments[0]}: not a certificate that can be read: {printable(str(error)[:200])}", file=sys.stderr)
        return 2
    said(str(verdict))
    return 0 if verdict.holds else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
