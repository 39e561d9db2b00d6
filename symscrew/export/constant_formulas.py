"""How a constant was folded, in names and units of the description.

    0.213 = mul 1.42 0.15   -->   [kg m]  limb_lower_m * (param_R - limb_P_at_x)

The tape has one node a number, whatever it is: 0.2 may be the mass of a shaft and the length of a lever. So a number
has one reading a unit, and a formula is one whose units fit: the mass of a shaft is not what is left of two lengths.
A number that nothing is known of, a coefficient of a coupling, fits everywhere, and no unit is told of what it makes.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from itertools import product
from typing import Any, NamedTuple

from symscrew.algebra import Node

Unit = tuple[int, int, int]  # powers of m, kg and s
ONE: Unit = (0, 0, 0)  # of a number without a unit
BASE: Mapping[str, Unit] = {
    "1": ONE,
    "rad": ONE,
    "m": (1, 0, 0),
    "kg": (0, 1, 0),
    "s": (0, 0, 1),
    "N": (1, 1, -2),
    "J": (2, 1, -2),
    "W": (2, 1, -3),
    "Pa": (-1, 1, -2),
    "Hz": (0, 0, -1),
}
SHORT: Mapping[Unit, str] = {(1, 1, -2): "N", (2, 1, -2): "N m", (0, 1, -2): "N/m"}
SILENT = frozenset((0.0, 0.5, 1.0, 2.0, 3.0, 4.0))  # factors of formulas, not of a mechanism
FURTHEST = 16  # operations inside each other that are asked for their units: behind them nothing is known
DEEPEST = 3  # operations inside each other that are told: more tell nobody anything
OVER = "1 / "
SAME_UNIT = frozenset(("add", "atan2"))  # of both operands


class Words(NamedTuple):
    """A formula without its sign, and how it binds: 0 a sum, 1 a product, 2 a name or a number.

    `opposite`: the text of its negative, of a difference, which needs no sign.
    """

    sign: int
    text: str
    binding: int
    opposite: str = ""

    def times(self, sign: int) -> Words:
        """Its negative, where the sign is -1."""
        sign *= self.sign
        if sign < 0 and self.opposite:
            return Words(1, self.opposite, self.binding, self.text)
        return self._replace(sign=sign)

    def bare(self, binding: int) -> str:
        """Without its sign, as an operand of what binds so."""
        return f"({self.text})" if self.binding < binding else self.text

    @property
    def whole(self) -> str:
        """With its sign, by itself."""
        return self.text if self.sign > 0 else f"-{self.bare(1)}"


def unit_of(text: str) -> Unit | None:
    """The powers of a unit's text; None of one with others than mechanical parts.

    >>> unit_of("kg m^2"), unit_of("N m/rad"), unit_of("V")
    ((2, 1, 0), (2, 1, -2), None)
    """
    found = [0, 0, 0]
    above, *below = text.split("/")
    for sign, part in ((1, above), *((-1, p) for p in below)):
        for word in part.replace("(", " ").replace(")", " ").split():
            name, _, power = word.partition("^")
            if name not in BASE or not re.fullmatch(r"-?\d*", power):
                return None
            for k, own in enumerate(BASE[name]):
                found[k] += sign * own * int(power or 1)
    return found[0], found[1], found[2]


def unit_text(unit: Unit) -> str:
    """A unit in words: of (2, 1, 0) it is kg m^2, of (1, 1, -2) it is N."""
    if unit in SHORT:
        return SHORT[unit]
    powers = {"kg": unit[1], "m": unit[0], "s": unit[2]}
    above, below = (
        " ".join(f"{name}^{abs(p)}" if abs(p) > 1 else name for name, p in powers.items() if p * sign > 0)
        for sign in (1, -1)
    )
    if " " in below:
        below = f"({below})"
    return f"{above or '1'}/{below}" if below else above or "1"


class Formulas:
    """Readings of constants: `given` says which units a number of the description has, `called` what it is called.

    `loose`: those of the description may also be what they were folded of, not only what they are there.
    """

    def __init__(
        self, given: Callable[[Node], tuple[Unit | None, ...]], called: Callable[[Node], str], *, loose: bool = False
    ) -> None:
        """Nothing is asked for yet."""
        self.given, self.called, self.loose = given, called, loose
        self._units: dict[tuple[Node, bool], frozenset[Unit | None]] = {}

    def units(self, node: Node, *, folded: bool = False, left: int = FURTHEST) -> frozenset[Unit | None]:
        """The units that a positive constant may have; None among them: it may be anything.

        `folded`: only those that it has as it was folded.
        """
        if (node, folded) not in self._units:
            found: set[Unit | None] = set(() if folded else self.given(node))
            if not folded and float(node.value) in SILENT:
                found.add(ONE)
            made = _made(node)
            if made and (folded or self.loose or not found - {ONE}):
                found |= {unit for unit, _ in self._ways(made, left)}
            self._units[node, folded] = frozenset(found or {None} if not folded else found)
        return self._units[node, folded]

    def _ways(self, made: tuple[Any, ...], left: int) -> Iterator[tuple[Unit | None, tuple[Unit | None, ...]]]:
        """The unit of what is made, with those of the operands, for all of theirs that fit each other."""
        if not left:
            return
        units = [sorted(self.units(_positive(part), left=left - 1), key=repr) for part in made[1:]]
        for chosen in product(*units):
            known = {unit for unit in chosen if unit is not None}
            if made[0] in SAME_UNIT:
                if len(known) < 2:
                    yield (ONE if made[0] == "atan2" else next(iter(known), None)), chosen
            elif None in chosen:
                yield None, chosen
            elif made[0] == "mul":
                yield _times(*chosen), chosen  # type: ignore[arg-type]
            elif made[0] == "reciprocal":
                yield _power(chosen[0], -1), chosen  # type: ignore[arg-type]
            elif made[0] == "sqrt":
                if all(p % 2 == 0 for p in chosen[0]):  # type: ignore[union-attr]
                    yield _halved(chosen[0]), chosen  # type: ignore[arg-type]
            elif known == {ONE}:
                yield ONE, chosen

    def told(self, node: Node, unit: Unit | None) -> str:
        """How a positive constant of this unit was folded, in constants that have names; "" where nothing tells."""
        words = self._folded(node, unit, DEEPEST)
        return "" if words is None else words.times(_sign(node)).whole

    def _folded(self, node: Node, unit: Unit | None, depth: int) -> Words | None:
        """The formula of a constant as it was made, perhaps of its negative."""
        made = _made(node)
        if made is None:
            exact = node.args[0]
            return None if exact is None else Words(1, str(exact), 0 if re.search(r"[^\w.]", str(exact)) else 2)
        if not depth:
            return None
        for found, chosen in self._ways(made, FURTHEST):
            if found == unit:
                operands = [self._operand(part, own, depth - 1) for part, own in zip(made[1:], chosen, strict=True)]
                return _put_together(made[0], operands)
        return None

    def _operand(self, part: Node, unit: Unit | None, depth: int) -> Words:
        inner = _positive(part)
        sign = -1 if part.op == "neg" else 1
        size = abs(float(inner.value))
        if size in SILENT and unit in (ONE, None):
            return Words(sign, f"{size:g}", 2)
        name = self.called(inner) if unit in self.given(inner) or None in self.given(inner) else None
        if name is None:
            words = self._folded(inner, unit, depth)
            if words is not None:
                return words.times(sign * _sign(inner))
        return Words(sign, name or (f"{size:g}" if size in SILENT else repr(size)), 2)


def _made(node: Node) -> tuple[Any, ...] | None:
    """Operation and operands by which a constant, or its negative, was folded; None of a number as it was given."""
    made = node.args[0]
    while isinstance(made, tuple) and made[0] == "neg_of":
        made = made[1]
    return made if isinstance(made, tuple) else None


def _sign(node: Node) -> int:
    """-1 where a constant is the negative of what was folded."""
    made, sign = node.args[0], 1
    while isinstance(made, tuple) and made[0] == "neg_of":
        made, sign = made[1], -sign
    return sign


def _positive(node: Node) -> Node:
    inner: Node = node.args[0] if node.op == "neg" else node
    return inner


def _put_together(op: str, operands: list[Words]) -> Words:
    """A formula of others."""
    first, second = operands[0], operands[-1]
    if op == "add" and first == second:
        return Words(first.sign, f"2 * {first.bare(1)}", 1)
    if op == "add" and first.sign == second.sign:
        return Words(first.sign, f"{first.text} + {second.text}", 0)
    if op == "add":
        ways = f"{first.text} - {second.bare(1)}", f"{second.text} - {first.bare(1)}"
        return Words(1, *((ways[0], 0, ways[1]) if first.sign > 0 else (ways[1], 0, ways[0])))
    if op == "mul":
        sign = first.sign * second.sign
        text, opposite = _product(first, second), ""
        if first.opposite or second.opposite:
            flipped = (first.times(-1), second) if first.opposite else (first, second.times(-1))
            opposite = _product(*flipped)
        return Words(1, text, 1, opposite).times(sign)
    if op == "reciprocal":
        return Words(first.sign, f"{OVER}{first.bare(2)}", 1)
    return Words(1, f"{op}({', '.join(words.whole for words in operands)})", 2)


def _product(first: Words, second: Words) -> str:
    """Without the sign; by a reciprocal it is a quotient."""
    if second.text.startswith(OVER):
        return f"{first.bare(1)} / {second.text.removeprefix(OVER)}"
    if first.text.startswith(OVER):
        return f"{second.bare(1)} / {first.text.removeprefix(OVER)}"
    return f"{first.bare(1)} * {second.bare(1)}"


def _times(a: Unit, b: Unit) -> Unit:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _power(a: Unit, power: int) -> Unit:
    return power * a[0], power * a[1], power * a[2]


def _halved(a: Unit) -> Unit:
    return a[0] // 2, a[1] // 2, a[2] // 2
