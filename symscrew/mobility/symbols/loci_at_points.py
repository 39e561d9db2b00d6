"""Loci of degeneration looked at: where the expression is zero, singular values say whether what is said there is so.

    Locus --zeros along its symbols, others about their values--> geometry in doubles --ranks there and beside--> kept

Common factors of minors are made of bases of wrenches, and a basis may degenerate where the space that it spans does
not: of two forces of a UP limb one becomes a couple at H = 0, and another one takes its place. What is said of an
irreducible factor is so at all of its zeros or at special ones only, so that one in general position decides: the
nearest to the description's values. Screws come from the description and exponentials, not from the polynomials.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
import sympy

from symscrew.description import Joint, Mechanism
from symscrew.kinematics import motion_screws
from symscrew.mobility.joint_network import Network, network_of, screw_axes
from symscrew.mobility.symbols.locus import Locus

Array = np.ndarray[Any, Any]
Values = Mapping[sympy.Symbol, float]

GRID = np.concatenate([np.linspace(-3.0, 3.0, 60), [0.0]])
"""Where zeros along a symbol are looked for, in its value: an even number of places, none of them a round number, and
zero itself."""
ABOUT = 0.1
"""Largest part of their values by which the other symbols are changed, so that no zero is more special than others."""
ANGLE = 1.0
"""What stands for the value of a symbol that is zero [rad, m]: displacements have none of their own."""
HALVINGS = 80
"""Of a stretch with a zero: to the last bit."""
NONE = 1e-9
"""Singular value of screws of unit size that is zero: at a zero they have 1e-14, beside it hundredths."""
BESIDE = 0.07
"""How far beside a zero ranks are what they are usually, in the symbol's value."""
SEED = 22
"""Of the changes of the other symbols: always the same, so that results repeat."""


def true_loci(shape: Shape, loci: Iterable[Locus]) -> tuple[Locus, ...]:
    """Those of the loci that are so at their zeros; and those that no values near the description's reach.

    Args:
        shape: the geometry at the parameters' values.
        loci: where something degenerates, in the parameters and displacements.
    """
    return tuple(locus for locus in loci if _holds(shape, locus))


def reference_screws(mechanism: Mechanism) -> tuple[Mapping[str, Array], float]:
    """(joint -> its unit screws in the reference, lengths over the size; the size [m])."""
    shape = Shape(mechanism)
    there = shape.at(shape.values)
    if there is None:
        raise ValueError("expected a geometry that is real at the description's values")
    return there.screws, there.size


def limb_loses(
    mechanism: Mechanism, limb: str, displaced: Sequence[tuple[str, int, int, sympy.Symbol]], at: Values
) -> bool:
    """Whether the limb's screws have a rank less at displacements than beside these."""
    shape = Shape(mechanism, displaced)
    there, usual = (shape.at({**shape.values, **{s: v + off for s, v in at.items()}}) for off in (0.0, BESIDE))
    return there is not None and usual is not None and there.limb(limb) < usual.limb(limb)


def _holds(shape: Shape, locus: Locus) -> bool:
    for zero, beside in _zeros(shape, locus.expression):
        there, usual = shape.at(zero), shape.at(beside)
        if there is not None and usual is not None:
            return _is_so(locus, there, usual)
    return True


def _zeros(shape: Shape, expression: sympy.Expr) -> Iterator[tuple[Values, Values]]:
    """(values at a zero of the expression, values beside it), nearest to the description's first."""
    symbols = sorted(expression.free_symbols, key=str)
    random = np.random.default_rng(SEED)
    value = sympy.lambdify(symbols, expression, "numpy")
    found = []
    for symbol in symbols:
        about = {s: v * (1 + ABOUT * random.uniform(-1, 1)) + (v == 0.0) * random.uniform(-1, 1) * ANGLE
                 for s, v in shape.values.items()}  # fmt: skip
        unit = abs(shape.values[symbol]) or ANGLE

        def along(x: float, symbol: sympy.Symbol = symbol, about: dict[sympy.Symbol, float] = about) -> float:
            with np.errstate(all="ignore"):
                return float(value(*(np.float64(x if s == symbol else about[s]) for s in symbols)))

        for x in _crossings(along, unit * GRID):
            zero = {**about, symbol: x}
            found.append((abs(x - shape.values[symbol]) / unit, zero, {**about, symbol: x + BESIDE * unit}))
    yield from ((zero, beside) for _, zero, beside in sorted(found, key=lambda one: one[0]))


def _crossings(value: Callable[[float], float], places: Array) -> Iterator[float]:
    """Zeros at the places, and where the sign changes between two of them."""
    ordered = sorted(places)
    values = [value(x) for x in ordered]
    yield from (x for x, v in zip(ordered, values, strict=True) if v == 0.0)
    for (low, a), (high, b) in pairwise(zip(ordered, values, strict=True)):
        if np.isfinite(a) and np.isfinite(b) and a * b < 0:
            for _ in range(HALVINGS):
                middle = (low + high) / 2
                if not low < middle < high:
                    break
                low, high = (low, middle) if value(middle) * a <= 0 else (middle, high)
            yield low


def _is_so(locus: Locus, there: _Place, usual: _Place) -> bool:
    """Whether the geometry `there` has lost what the locus says, beside the `usual` one."""
    limb = locus.where
    if locus.kind == "limb":
        return there.limb(limb) < usual.limb(limb)
    if locus.kind in ("couple", "through O"):
        half = slice(0, 3) if locus.kind == "couple" else slice(3, 6)
        same = there.limb(limb) == usual.limb(limb)
        return same and there.limb(limb, half) < usual.limb(limb, half)
    if locus.kind == "constraint":
        return there.redundant > usual.redundant
    if locus.kind == "closure":
        return there.rank < usual.rank
    if locus.kind == "actuation":
        return there.left(limb) > usual.left(limb)
    raise ValueError(f"expected a kind of locus, got {locus.kind!r}")


class Shape:
    """The geometry as a function of the parameters and of displacements, in doubles.

    `displaced`: (joint, its motion, sense in which it is passed, symbol) of a limb's freedoms that have a symbol.
    """

    def __init__(self, mechanism: Mechanism, displaced: Sequence[tuple[str, int, int, sympy.Symbol]] = ()) -> None:
        self.mechanism, self.displaced = mechanism, tuple(displaced)
        self.values = {p.symbol: float(p.value) for p in mechanism.parameters.values()}
        self.values |= {symbol: 0.0 for *_, symbol in displaced}
        self.symbols = [p.symbol for p in mechanism.parameters.values()]

    @cached_property
    def _geometry(self) -> Any:
        joints = self.mechanism.joints.values()
        given = [[list(j.point), [list(a) for a in j.axes], 0 if j.pitch is None else j.pitch] for j in joints]
        return sympy.lambdify(self.symbols, given, "numpy")

    @cached_property
    def network(self) -> Network:
        """Which joints are in which loops."""
        return network_of(self.mechanism)

    def at(self, values: Values) -> _Place | None:
        """The geometry at values of the symbols; None where it is not real."""
        with np.errstate(all="ignore"):
            made = self._geometry(*(np.float64(values[s]) for s in self.symbols))
        joints = list(self.mechanism.joints.values())
        points = np.array([point for point, _, _ in made], dtype=complex)
        size = float(np.abs(points - points.mean(axis=0)).max()) or 1.0
        screws = {}
        for joint, (point, axes, pitch) in zip(joints, made, strict=True):
            numbers = np.array([*point, *(c for axis in axes for c in axis), pitch], dtype=complex)
            if not np.isfinite(numbers).all() or np.abs(numbers.imag).max() > 0:
                return None
            units = [np.real(axis) / np.linalg.norm(np.real(axis)) for axis in axes]
            if not np.isfinite(units).all():
                return None
            screws[joint.name] = _screws(joint, np.real(point) / size, units, float(np.real(pitch)) / size)
        for k, (name, motion, sense, symbol) in enumerate(self.displaced):
            start = self.mechanism.joints[name].kind.starts[motion]
            slides = self.mechanism.joints[name].kind.motions[motion].prismatic
            amount = sense * values[symbol] / (size if slides else 1.0)
            _carry(screws, self._behind(k), screws[name][start], amount)
        return _Place(self, screws, size)

    def _behind(self, k: int) -> list[tuple[str, int]]:
        """(joint, column) of the limb's screws that the k-th displaced freedom carries."""
        name, motion, sense, _ = self.displaced[k]
        joints = next(limb.joints for limb in self.mechanism.limbs.values() if name in limb.joints)
        kinds = self.mechanism.joints
        behind = [(j, c) for j in joints[joints.index(name) + 1 :] for c in range(kinds[j].kind.freedom)]
        starts = kinds[name].kind.starts
        own = range(starts[motion] + kinds[name].kind.motions[motion].freedom, kinds[name].kind.freedom)
        return behind + [(name, c) for c in (own if sense > 0 else range(starts[motion]))]


def _screws(joint: Joint, point: Array, axes: Sequence[Array], pitch: float) -> Array:
    made = screw_axes(joint, [tuple(a) for a in axes], np.sqrt, float)
    found = motion_screws(joint.kind, made, tuple(point), pitch)
    rows = [[float(c) for c in twist.components] for _, twists in found for twist in twists]
    return np.array(rows).reshape(-1, 6)


def _carry(screws: dict[str, Array], behind: Sequence[tuple[str, int]], about: Array, amount: float) -> None:
    """Screws displaced by exp(amount about): of a unit screw without pitch, or of a slide."""
    turn, slide = (np.cross(np.eye(3), part) for part in (about[:3], about[3:]))
    hat = np.block([[turn, np.zeros((3, 3))], [slide, turn]])
    total, term = np.eye(6), np.eye(6)
    for k in range(1, 60):
        term = term @ hat * (amount / k)
        total = total + term
    for name, column in behind:
        screws[name][column] = total @ screws[name][column]


@dataclass(frozen=True)
class _Place:
    """Ranks of the geometry at some values."""

    shape: Shape
    screws: Mapping[str, Array]
    size: float

    def limb(self, name: str, half: slice = slice(0, 6)) -> int:
        """Rank of a limb's screws, or of their angular or linear parts."""
        return _rank(self._chain(name)[:, half])

    @property
    def redundant(self) -> int:
        """Constraints of the limbs that follow from others."""
        wrenches = [_reciprocal(self._chain(name)) for name in self.shape.mechanism.limbs]
        return sum(map(len, wrenches)) - _rank(np.concatenate(wrenches))

    @property
    def rank(self) -> int:
        """Rank of the closure."""
        return _rank(self._rows)

    def left(self, drives: str) -> int:
        """Freedoms that are left with these drives locked."""
        network, names = self.shape.network, drives.split()
        columns = [
            column
            for edge in network.edges.values()
            for index, column in enumerate(edge.columns)
            if column in network.driven and (drives == "all drives" or {edge.name, f"{edge.name}.{index}"} & set(names))
        ]
        return network.freedoms - _rank(np.concatenate([self._rows, np.eye(network.freedoms)[columns]]))

    def _chain(self, name: str) -> Array:
        return np.concatenate([self.screws[joint] for joint in self.shape.mechanism.limbs[name].joints])

    @cached_property
    def _rows(self) -> Array:
        network = self.shape.network
        rows = np.zeros((6 * len(network.chords), network.freedoms))
        for k, loop in enumerate(network.loops()):
            for name, sign in loop:
                rows[6 * k : 6 * k + 6, list(network.edges[name].columns)] = sign * self.screws[name].T
        return rows


def _rank(rows: Array) -> int:
    values = np.linalg.svd(rows, compute_uv=False) if rows.size else np.zeros(0)
    return int((values > NONE * max(1.0, values.max(initial=0.0))).sum())


def _reciprocal(screws: Array) -> Array:
    """Unit wrenches (m ; f) that do no work on the screws."""
    return np.asarray(np.linalg.svd(screws)[2][_rank(screws) :])
