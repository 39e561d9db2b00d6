"""Checks the ways between assembly modes in a proof file: no singularity on them, or one on every way.

    python way_checker.py FILE        exit 0: every claim is proved;  1: one is not;  2: not such a file

It needs Python and `proof_checker.py`, which lies beside it and makes screws, loops and groups from the
mechanism. From the file come points and radii:

    point       of each motion numbers X: a hinge or slide is displaced by a + b S, a ball joint by the quaternion X
    piece       from a point to the next the numbers X change in proportion, those of the drives exactly so
    a passive   joint is displaced by X (1 + y S), |y| at most the radius times its scale: a tube around the piece
    closed      in every point of the piece exactly one y in the tube, and the passive joints' matrix is regular in it:
                Krawczyk's operator maps the tube into itself (R. Krawczyk, Computing 4, 1969, 187-201)
    way         pieces one after another; tubes that meet hold the same y there, as one of them holds the other
    mode        a way of one point, with the drives as in the reference
    apart       the determinants of the passive joints' matrix, in a basis of each loop's group of displacements, have
                opposite signs in two modes: as it is the same function of all configurations, each way has a zero

A loop is a product of dual quaternions, of which all but the first number vanish where it is closed: no angle and no
root is taken, half turns are none, and whole turns come back to the same point. Of a loop that moves in a group the
numbers at the pivots of its basis are enough: hinges, slides and ball joints make groups in which what does not turn is
displaced along the basis' vectors that do not turn. Numbers are intervals of integers.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

if __package__:
    from symscrew.mobility.proofs import proof_checker as exact
else:  # run without the package
    import proof_checker as exact  # type: ignore[no-redef]

need = exact.need

PLACES = 128
"""Binary digits after the point: sizes of micrometres have a hundred of them."""
ONE = 1 << PLACES
POINT = 50
"""Binary digits after the point of the file's numbers, a little more than those of doubles."""
FORMAT = "symscrew ways 1"
WIDEST = 1 << 80
"""Of the file's numbers, which keeps the reader from waiting for longer ones."""
Interval = tuple[int, int]
Dual = list[Interval]
"""Of a dual quaternion: w, x, y, z, then those of the dual part."""
Point = Sequence[Sequence[int]]
"""Numbers of each motion, times 2^POINT: two of a hinge or slide, four of a ball joint."""
ZERO = (0, 0)
"""The number zero, which is left out of sums."""
SIGNS = ((0, 1, 2, 3), (1, ~0, 3, ~2), (2, ~3, ~0, 1), (3, 2, ~1, ~0))
"""Place of the product of two units of quaternions, inverted where it is negative; 1, i, j, k."""
PLACED = [[(SIGNS[i % 4][j % 4] if SIGNS[i % 4][j % 4] >= 0 else ~SIGNS[i % 4][j % 4], SIGNS[i % 4][j % 4] >= 0)
           for j in range(8)] for i in range(8)]  # fmt: skip
"""Of units of dual quaternions: (place among four, whether it is positive); dual with dual is zero."""


def _ends(a: Interval, b: Interval) -> Interval:
    """The ends of a product, times 2^(2 PLACES)."""
    (low, high), (first, last) = a, b
    if low >= 0:
        return (low if first >= 0 else high) * first, (high if last >= 0 else low) * last
    if high <= 0:
        return (low if last >= 0 else high) * last, (high if first >= 0 else low) * first
    if first >= 0:
        return low * last, high * last
    if last <= 0:
        return high * first, low * first
    return min(low * last, high * first), max(low * first, high * last)


def _product(a: Interval, b: Interval) -> Interval:
    low, high = _ends(a, b)
    return low >> PLACES, -(-high >> PLACES)


def _sum(a: Interval, b: Interval) -> Interval:
    return a[0] + b[0], a[1] + b[1]


def _minus(a: Interval) -> Interval:
    return -a[1], -a[0]


def _size(a: Interval) -> int:
    return max(-a[0], a[1])


def _hull(a: Interval, b: Interval) -> Interval:
    return min(a[0], b[0]), max(a[1], b[1])


def _dot(row: Sequence[Interval], column: Sequence[Interval]) -> Interval:
    low = high = 0
    for a, b in zip(row, column, strict=True):
        if a != ZERO and b != ZERO:
            one, two = _ends(a, b)
            low, high = low + one, high + two
    return low >> PLACES, -(-high >> PLACES)


def _multiplied(p: Dual, q: Dual) -> Dual:
    low, high = [0] * 8, [0] * 8
    others = [(j, b) for j, b in enumerate(q) if b != ZERO]
    for i, a in enumerate(p):
        if a != ZERO:
            row, dual = PLACED[i], i > 3
            for j, b in others:
                if j < 4 or not dual:
                    one, two = _ends(a, b)
                    k, positive = row[j]
                    if dual or j > 3:
                        k += 4
                    if positive:
                        low[k] += one
                        high[k] += two
                    else:
                        low[k] -= two
                        high[k] -= one
    return [(a >> PLACES, -(-b >> PLACES)) for a, b in zip(low, high, strict=True)]


def _added(p: Dual, q: Dual) -> Dual:
    return [_sum(a, b) for a, b in zip(p, q, strict=True)]


UNIT: Dual = [(ONE, ONE), *[ZERO] * 7]


@dataclass(frozen=True)
class Motion:
    """An elementary motion: joint, letter, columns of its freedoms, their screws as dual quaternions, and |omega|^2."""

    joint: str
    kind: str
    columns: range
    screws: list[Dual]
    square: Interval

    @property
    def numbers(self) -> int:
        """How many numbers a point has of it."""
        return 1 + len(self.screws)

    def slopes(self, x: Sequence[Interval]) -> list[list[Interval]]:
        """The numbers' derivatives by each y: those of X S."""
        if self.kind != "S":
            return [[_minus(_product(x[1], self.square)), x[0]]]
        w, i, j, k = x
        return [[_minus(i), w, k, _minus(j)], [_minus(j), _minus(k), w, i], [_minus(k), j, _minus(i), w]]

    def dual(self, x: Sequence[Interval], sign: int) -> Dual:
        """X as a dual quaternion, or its conjugate: the way back."""
        total = [x[0], *[ZERO] * 7]
        for c, screw in zip(x[1:], self.screws, strict=True):
            if c != ZERO:
                own = c if sign > 0 else _minus(c)
                total = [t if s == ZERO else _sum(t, _product(own, s)) for t, s in zip(total, screw, strict=True)]
        return total


class Loop:
    """A loop: (motion, sign) around it, and the places of the numbers that are zero where it is closed."""

    def __init__(self, steps: list[tuple[int, int]], pivots: list[int]) -> None:
        self.steps = steps
        self.places = [1 + p if p < 3 else 2 + p for p in pivots]


class Tubes:
    """The loops of a mechanism with some freedoms driven, and tubes in which they close."""

    def __init__(self, mechanism: exact.Mechanism, entry: Any) -> None:
        need(not mechanism.ties, "couplings, of which no way is judged")
        self.mechanism = mechanism
        self.motions = list(self._motions())
        drives = {mechanism.joints[name].column(index) for name, index in entry["drives"]}
        need(len(drives) == len(entry["drives"]), "a drive that is there twice")
        self.passive = [c for c in range(mechanism.freedoms) if c not in drives]
        need(len(drives) < mechanism.freedoms and bool(drives), "no drives, or no other freedoms")
        split = any(len(drives & set(m.columns)) not in (0, len(m.columns)) for m in self.motions)
        need(not split, "a ball joint of which a part is driven")
        self.scales = _numbers(entry["scales"], mechanism.freedoms)
        need(all(s > 0 for s in self.scales), "a scale that is not positive")
        self.loops = [self._loop(k, basis) for k, basis in _pairs(len(mechanism.loops), entry["groups"])]
        rows = sum(len(loop.places) for loop in self.loops)
        need(rows == len(self.passive), f"{rows} independent conditions for {len(self.passive)} passive freedoms")

    def _motions(self) -> Iterator[Motion]:
        mechanism = self.mechanism
        for joint in mechanism.entry["joints"]:
            made, first = mechanism.joints[joint["name"]], 0
            for motion in joint["motions"]:
                kind = motion["kind"]
                need(kind in ("R", "P", "S"), "a screw joint, which is not algebraic")
                own = range(first, first + (3 if kind == "S" else 1))
                screws = [self._dual(made.screws[k]) for k in own]
                square = (ONE, ONE) if kind == "S" else _dot(screws[0][1:4], screws[0][1:4])
                need(square[0] > 0 or kind == "P", "an axis without direction")
                yield Motion(made.name, kind, made.columns[own.start : own.stop], screws, square)
                first = own.stop

    def _dual(self, screw: exact.Screw) -> Dual:
        """w + eps v."""
        ends = [self.mechanism.numbers.interval(c) for c in screw]
        shift = exact.BITS - PLACES
        w = [(low >> shift, -(-high >> shift)) for low, high in ends]
        return [ZERO, *w[:3], ZERO, *w[3:]]

    def _loop(self, index: int, given: Any) -> Loop:
        """The group of a loop, and the pivots of its basis: those that turn have theirs among the first three."""
        mechanism, steps = self.mechanism, list[tuple[int, int]]()
        for name, sign in mechanism.loops[index]:
            own = [k for k, motion in enumerate(self.motions) if motion.joint == name]
            steps += [(k, sign) for k in own[::sign]]
        basis = exact.group(mechanism.numbers, [s for _, s in mechanism.factors(index)], given)
        pivots = []
        for vector in basis:
            one = [
                j for j, c in enumerate(vector) if not c - mechanism.numbers.one and sum(1 for v in basis if v[j]) == 1
            ]
            pivots.append(one[0])
            need(one[0] < 3 or not any(vector[:3]), "a basis whose pivots do not tell what turns")
        return Loop(steps, pivots)

    # -- one piece ----------------------------------------------------------------------------------------

    def images(self, one: Point, two: Point, radius: int) -> tuple[list[int], list[int], int]:
        """(per passive freedom how far Krawczyk's operator moves the middle, how wide its image is, the sign).

        All times 2^PLACES; the sign is that of the determinant where the image lies in the tube.
        """
        starts, ends = self._read(one), self._read(two)
        across = [[_hull(a, b) for a, b in zip(x, z, strict=True)] for x, z in zip(starts, ends, strict=True)]
        widths = {c: radius * self.scales[c] << PLACES >> 2 * POINT for c in self.passive}
        matrix, signs = self._slopes(across, widths)
        inverse = _inverse([[(low + high) / (2 * ONE) for low, high in row] for row in matrix])
        need(inverse is not None, "a passive joints' matrix that is singular in doubles")
        assert inverse is not None
        weights = [[(w, w) for w in (int(c * ONE) for c in row)] for row in inverse]
        gaps = [list(column) for column in zip(*self._gaps(starts, ends), strict=True)]
        columns = list(map(list, zip(*matrix, strict=True)))
        moved, wide = [], []
        for i, row in enumerate(weights):
            at, along, bent = (_dot(row, gap) for gap in gaps)
            there = _sum(at, _sum(along, bent))
            # off the line between its ends it is m (s - s^2), m the middle of `bent`, and twice its width at most
            moved.append(max(_size(at), _size(there)) + abs(sum(bent)) // 8 + 1 + bent[1] - bent[0])
            total = 0
            for k, c in enumerate(self.passive):
                low, high = _dot(row, columns[k])
                part = (ONE - high, ONE - low) if i == k else (-high, -low)
                total -= -_size(part) * widths[c] >> PLACES
            wide.append(total)
        sign = 1 if _positive([[c for c, _ in row] for row in weights]) else -1
        for own, loop in zip(signs, self.loops, strict=True):
            sign *= own ** len(loop.places)
        return moved, wide, sign

    def shown(self, one: Point, two: Point, radius: int) -> int:
        """Refuses unless each point of the piece has one solution in the tube, regular; its determinant's sign."""
        need(0 < radius < WIDEST, "a radius that is none")
        moved, wide, sign = self.images(one, two, radius)
        for c, near, spread in zip(self.passive, moved, wide, strict=True):
            inside = near + spread < (radius * self.scales[c] << PLACES >> 2 * POINT)
            need(inside, "a tube that Krawczyk's operator leaves")
        need(sign != 0, "a loop that is not shown to be where it is closed")
        return sign

    def apart(self, one: Point, two: Point, radii: Sequence[int]) -> bool:
        """Whether two tubes of one point each hold no common configuration: some motion is another there."""
        boxes = [self._boxes(self._read(p), {c: r * self.scales[c] << PLACES >> 2 * POINT for c in self.passive})
                 for p, r in zip((one, two), radii, strict=True)]  # fmt: skip
        for x, z in zip(*boxes, strict=True):
            for i in range(len(x)):
                for j in range(i):
                    low, high = _sum(_product(x[i], z[j]), _minus(_product(x[j], z[i])))
                    if low > 0 or high < 0:
                        return True
        return False

    def _read(self, point: Point) -> list[list[Interval]]:
        return [[(c << PLACES - POINT,) * 2 for c in x] for x in point]

    def _boxes(self, across: Sequence[Sequence[Interval]], widths: dict[int, int]) -> list[list[Interval]]:
        """The numbers of X (1 + y S) for all y of the tube."""
        result = []
        for motion, x in zip(self.motions, across, strict=True):
            own = list(x)
            for column, slope in zip(motion.columns, motion.slopes(x), strict=True):
                wide = widths.get(column, 0)
                own = [_sum(c, _product(d, (-wide, wide))) for c, d in zip(own, slope, strict=True)]
            result.append(own)
        return result

    def _slopes(
        self, across: Sequence[Sequence[Interval]], widths: dict[int, int]
    ) -> tuple[list[list[Interval]], list[int]]:
        """(rows of the loops by y, over the tube; the sign of each loop's first number, 0 where it may be zero)."""
        boxes, rows, signs = self._boxes(across, widths), list[list[Interval]](), list[int]()
        slopes = [m.slopes(x) for m, x in zip(self.motions, across, strict=True)]
        place = {c: k for k, c in enumerate(self.passive)}
        for loop in self.loops:
            factors = [self.motions[k].dual(boxes[k], sign) for k, sign in loop.steps]
            after = [UNIT]
            for factor in reversed(factors):
                after.append(_multiplied(factor, after[-1]))
            own = [[ZERO] * len(self.passive) for _ in loop.places]
            before = UNIT
            for step, ((k, sign), factor) in enumerate(zip(loop.steps, factors, strict=True)):
                behind = after[len(factors) - 1 - step]
                for column, slope in zip(self.motions[k].columns, slopes[k], strict=True):
                    if column in place:
                        total = _multiplied(_multiplied(before, self.motions[k].dual(slope, sign)), behind)
                        for row, p in zip(own, loop.places, strict=True):
                            row[place[column]] = total[p]
                before = _multiplied(before, factor)
            rows += own
            signs.append(1 if before[0][0] > 0 else -1 if before[0][1] < 0 else 0)
        return rows, signs

    def _gaps(self, starts: Sequence[Sequence[Interval]], ends: Sequence[Sequence[Interval]]) -> list[list[Interval]]:
        """(a, b, c) of every row in the middle of the tube, s from 0 to 1 along the piece: a + b s + c(s) s^2."""
        rows = []
        for loop in self.loops:
            at, along, bent = UNIT, [ZERO] * 8, [ZERO] * 8
            for k, sign in loop.steps:
                motion = self.motions[k]
                first, last = motion.dual(starts[k], sign), motion.dual(ends[k], sign)
                change = motion.dual([_sum(b, _minus(a)) for a, b in zip(starts[k], ends[k], strict=True)], sign)
                whole = [_hull(a, b) for a, b in zip(first, last, strict=True)]
                bent = _added(_multiplied(bent, whole), _multiplied(along, change))
                along = _added(_multiplied(at, change), _multiplied(along, first))
                at = _multiplied(at, first)
            rows += [[at[p], along[p], bent[p]] for p in loop.places]
        return rows

    def point(self, given: Any, before: Point | None = None) -> Point:
        """A point of the file; between it and the one before no motion's numbers are all zero."""
        need(len(given) == len(self.motions), "a point with other motions")
        point = [_numbers(x, motion.numbers) for x, motion in zip(given, self.motions, strict=True)]
        for motion, x, last in zip(self.motions, point, before or point, strict=True):
            need(motion.kind != "P" or x[0] > 0, "a slide at no place")
            need(sum(a * b for a, b in zip(x, last, strict=True)) > 0, "a motion whose numbers may be zero")
        return point

    def at_reference(self, point: Point) -> bool:
        """Whether the drives are where they are in the reference, after whole turns perhaps."""
        held = set(self.passive)
        return all(not any(x[1:]) for m, x in zip(self.motions, point, strict=True) if m.columns[0] not in held)


def _numbers(given: Any, count: int) -> list[int]:
    if len(given) != count or not all(type(c) is int and -WIDEST < c < WIDEST for c in given):
        raise exact.UnreadableError(f"expected {count} integers")
    return list(given)


def _pairs(count: int, given: Any) -> Iterator[tuple[int, Any]]:
    need(len(given) == count, "groups of another number of loops")
    return enumerate(given)


def _inverse(matrix: list[list[float]]) -> list[list[float]] | None:
    """An approximate inverse in doubles, by Gauss and Jordan with the largest pivots; None where one is zero."""
    size = len(matrix)
    left = [[*row, *(float(i == k) for k in range(size))] for i, row in enumerate(matrix)]
    for k in range(size):
        lead = max(range(k, size), key=lambda i: abs(left[i][k]))
        left[k], left[lead] = left[lead], left[k]
        if not left[k][k]:
            return None
        left[k] = [c / left[k][k] for c in left[k]]
        for i in range(size):
            if i != k and (factor := left[i][k]):
                left[i] = [a - factor * b for a, b in zip(left[i], left[k], strict=True)]
    return [row[size:] for row in left]


def _positive(matrix: list[list[int]]) -> bool:
    """Whether the determinant of a regular matrix of integers is positive, by elimination without fractions."""
    left, last, sign = [list(row) for row in matrix], 1, True
    for k in range(len(left)):
        lead = next((i for i in range(k, len(left)) if left[i][k]), None)
        need(lead is not None, "an inverse that is singular")
        assert lead is not None
        if lead != k:
            left[k], left[lead], sign = left[lead], left[k], not sign
        for i in range(k + 1, len(left)):
            left[i] = [(left[k][k] * a - left[i][k] * b) // last for a, b in zip(left[i], left[k], strict=True)]
        last = left[k][k]
    return sign == (last > 0)


# -- claims -----------------------------------------------------------------------------------------------


class Ways:
    """The modes and ways of a file."""

    def __init__(self, mechanism: exact.Mechanism, entry: Any) -> None:
        self.entry, self.tubes = entry, Tubes(mechanism, entry)
        self.signs: dict[int, int] = {}

    @cached_property
    def modes(self) -> list[tuple[Point, int]]:
        """Point and radius of each mode; the first is the reference."""
        found = [(self.tubes.point(mode["point"]), mode["radius"]) for mode in self.entry["modes"]]
        need(not any(c for x in found[0][0] for c in x[1:]), "a first mode that is not the reference")
        return found

    def sign(self, mode: int) -> int:
        """Of the determinant at a mode, which is shown to be a configuration with the drives as in the reference."""
        if mode not in self.signs:
            point, radius = self.modes[mode]
            need(self.tubes.at_reference(point), "a mode with the drives elsewhere")
            self.signs[mode] = self.tubes.shown(point, point, radius)
        return self.signs[mode]

    def connected(self, ends: Sequence[int], way: Any) -> None:
        """A way from one mode to another, another configuration, without a singularity."""
        (first, before), (last, after) = (self.modes[k] for k in ends)
        need(self.tubes.apart(first, last, (before, after)), "two modes that may be one")
        points = [first]
        for given in way["points"]:
            points.append(self.tubes.point(given, points[-1]))
        there = all(list(x) in (z, [-c for c in z]) for x, z in zip(points[-1], last, strict=True))
        need(there, "a way that ends elsewhere")
        radii = way["radii"]
        need(len(radii) == len(points) - 1, "radii of another number of pieces")
        signs = {self.tubes.shown(a, b, r) for (a, b), r in zip(pairwise(points), radii, strict=True)}
        need(signs == {self.sign(ends[0])} == {self.sign(ends[1])}, "a way on which the determinant changes its sign")

    def separated(self, ends: Sequence[int]) -> None:
        """Two modes whose determinants have opposite signs."""
        need(self.sign(ends[0]) * self.sign(ends[1]) < 0, "determinants that are not of opposite signs")


CONNECTED, SEPARATED = "connected", "separated"
TEXTS = {CONNECTED: "connected without a singularity", SEPARATED: "a singularity on every way"}


def judged(mechanism: exact.Mechanism, entry: Any) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """(claims that are proved, claims that are refused with the reason)."""
    if entry["format"] != FORMAT:
        raise exact.UnreadableError(f"expected the format {FORMAT!r}")
    proved, refused = list[str](), list[str]()
    held = ", ".join(f"{name}.{index}" if index else str(name) for name, index in entry["drives"])
    try:
        ways: Ways | None = Ways(mechanism, entry)
        why = ""
    except exact.RefusedError as error:
        ways, why = None, str(error)
    for claim in entry["claims"]:
        (one, two), kind = claim["modes"], claim["kind"]
        if kind not in TEXTS or not all(type(k) is int and k >= 0 for k in (one, two)):
            raise exact.UnreadableError(f"expected modes that are {' or '.join(TEXTS)}")
        text = f"with {held} driven, modes {one + 1} and {two + 1}: {TEXTS[kind]}"
        try:
            need(ways is not None, why)
            assert ways is not None
            if kind == CONNECTED:
                ways.connected((one, two), claim["way"])
            else:
                ways.separated((one, two))
            proved.append(text)
        except exact.RefusedError as error:
            refused.append(f"{text}: {error}")
    return tuple(proved), tuple(refused)


def check_ways(values: Any) -> exact.Verdict:
    """Judges the ways of a proof file.

    Args:
        values: what the JSON file holds.

    Raises:
        exact.UnreadableError: it is no proof file with ways.
    """
    try:
        name, entry = str(values["mechanism"]["name"]), values["ways"]
        open_claims = tuple(str(text) for text in entry["not proved"])
        try:
            need(
                values["digest"] == exact.digest(values["mechanism"]),
                "the description is not the one that was proved",
            )
            proved, refused = judged(exact.Mechanism(values["mechanism"]), entry)
        except exact.RefusedError as error:
            proved, refused = (), (str(error),)
    except (KeyError, TypeError, ValueError, IndexError, AttributeError, RecursionError, ArithmeticError) as error:
        raise exact.UnreadableError(f"{type(error).__name__}: {error}") from error
    return exact.Verdict(name, proved, refused, open_claims)


def main(arguments: Sequence[str]) -> int:
    """Checks the ways of a file, says what it proves; 0, 1 or 2 as above."""
    if len(arguments) != 1:
        print("usage: way_checker.py FILE", file=sys.stderr)
        return 2
    try:
        with open(arguments[0], encoding="utf-8") as file:
            verdict = check_ways(exact.values_of(file.read()))
    except (OSError, ValueError, RecursionError, MemoryError, exact.UnreadableError) as error:
        print(f"{arguments[0]}: no proof file with ways: {exact.printable(str(error)[:200])}", file=sys.stderr)
        return 2
    exact.said(str(verdict))
    return 0 if verdict.holds else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
