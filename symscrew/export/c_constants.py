"""Folded constants of generated C: each once, with a name, its unit, and what it is made of.

    0.213  -->  static const double limb_upper_mx = 0.213; /* [kg m] first moment of limb1_upper, ..: 71/50 * 3/20 */

The tape knows how it folded a constant; the system knows which constants are masses, moments, offsets and angles of
the description. What is a number of neither is printed as it is. Numbers that say nothing, 1, 2 and 1/2, stay numbers.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

from symscrew.algebra import Node, Origin
from symscrew.description import exact
from symscrew.errors import DescriptionError
from symscrew.export.c_names import TAKEN
from symscrew.export.c_precision import Precision
from symscrew.export.constant_formulas import SILENT, Formulas, Unit, unit_of, unit_text
from symscrew.export.listing import plain, wrapped
from symscrew.export.value_names import LEGEND, identifier
from symscrew.model import Model
from symscrew.program import Iteration, Program, RankRevealing

AXES = "xyz"
LONGEST = 24  # characters of a name that is put together from factors
WIDTH = 110  # characters of what is said of a constant, in a line
LIBRARY = re.compile(r"^[A-Z_0-9]+$|_[trl]$")  # names as C's own headers have them: M_PI, size_t, lgamma_r
ANY = re.compile(r"k\d+")
UNITS_OF_FIELDS = {"acceleration": "m/s^2"}  # what an effect calls so has this unit whatever else it is
PARTS = 4  # that are named of several to which a number belongs


@dataclass(frozen=True)
class Meaning:
    """What a number of the description is: of which part, its symbol there, its unit, in words."""

    part: str
    symbol: str
    unit: str
    words: str


class Constants:
    """The constants of a model's functions by name; those that are asked for are printed."""

    def __init__(self, model: Model, precision: Precision) -> None:
        """Names for all of them, in the order of the functions: local variables keep away from these."""
        self.model, self.precision = model, precision
        self.names: dict[float, str] = {}
        self.used: set[float] = set()
        self._nodes: dict[float, Node] = {}
        self._meanings: dict[Node, dict[Meaning, None]] = {}  # each once, in order
        self._formulas = Formulas(self._units, self._called), Formulas(self._units, self._called, loose=True)
        self._mentioned: dict[Node, str] = {}  # in formulas, beside those that are printed
        self._taken: set[str] = set()
        system = getattr(model, "system", None)
        if system is None:
            return
        programs = _straight(model.programs.values())
        with system.tape.lock:  # another thread may be lowering what it wants to print
            self._explain(system)
        for node in (node for program in programs for node in program.folded):
            self._nodes.setdefault(float(node.value), node)
        ports = (p for f in model.programs.values() for p in (*f.inputs, *f.outputs))
        self._taken = {*TAKEN, *(port.name for port in ports)}
        for size in _sizes(programs):
            if size not in SILENT and size in self._nodes:
                self.names[size] = self._name(self._nodes[size])

    def _explain(self, system: Any) -> None:
        """Which node of the tape each number is, and what it means."""
        every = (*_given(system), *_links(system), *_of_effects(system, self.model.effects), *_scales(system))
        for node, meaning in every:
            inner = _positive(node)
            if inner.value is not None:
                self._meanings.setdefault(inner, {})[meaning] = None
        for node, size in system.tape.constants.items():
            if node.args[0] is not None or node in self._meanings:
                known = self._nodes.setdefault(size, node)
                if node in self._meanings and known not in self._meanings:
                    self._nodes[size] = node

    def text(self, value: float) -> str:
        """A number as it stands in a statement: its name, or the number where it has none."""
        size = abs(float(value))
        if size not in self.names:
            return self.precision.number(value)
        self.used.add(size)
        return f"(-{self.names[size]})" if value < 0 else self.names[size]

    def _name(self, node: Node) -> str:
        """A name that no other constant has."""
        name = self._symbol(node)
        if LIBRARY.search(name) or name.startswith(f"{self.model.name}_"):
            name = f"value_{name}"
        found, number = name or "k1", 2
        while found in self._taken:
            found, number = (f"{name}_{number}" if name else f"k{number}"), number + 1
        self._taken.add(found)
        return found

    def _symbol(self, node: Node) -> str:
        """A name from what the number is, or from what it is made of; none where that would be too long.

        Nor has a number one that is, say, a mass and a length: it would be wrong wherever it is the other.
        """
        meanings = self._meanings.get(node)
        if meanings:
            if len(set(self._units(node))) > 1:
                return ""
            first = next(iter(meanings)).symbol
            return identifier(Origin(first, common([m.part for m in meanings if m.symbol == first])))
        made = node.args[0]
        if isinstance(made, tuple) and made[0] == "mul":
            factors = [self._symbol(_positive(factor)) for factor in made[1:] if isinstance(factor, Node)]
            name = "_".join(factors)
            return name if all(factors) and len(name) <= LONGEST else ""
        return ""

    def _units(self, node: Node) -> tuple[Unit | None, ...]:
        """The units that a number has in the description."""
        return tuple(dict.fromkeys(unit_of(m.unit) for m in self._meanings.get(node, ())))

    def _called(self, node: Node) -> str:
        """What a number of the description is called in a formula; it is told what it is, then."""
        size = abs(float(node.value))
        if size in self.used and self._nodes[size] is node:
            return self.names[size]
        if node not in self._mentioned:
            self._mentioned[node] = self.names.get(size) or self._name(node)
        return self._mentioned[node]

    def lines(self) -> list[str]:
        """How values are called; then the block: a line a constant, those of a part together, what is folded last."""
        legend = wrapped(" ".join(LEGEND), first="/* ", later="   ", width=WIDTH)
        return [*legend[:-1], f"{legend[-1]} */", *self._block()]

    def _block(self) -> list[str]:
        used = [(size, name) for size, name in self.names.items() if size in self.used]
        if not used:
            return []
        used.sort(key=lambda item: (bool(ANY.fullmatch(item[1])), "" if ANY.fullmatch(item[1]) else item[1]))
        lines = ["/* Constants: numbers of the description, and what was folded of them. */"]
        lines.append(f"{self.model.name.upper()}_UNUSED static const {self.precision.real}")
        for k, (size, name) in enumerate(used):
            end = "," if k + 1 < len(used) else ";"
            told = wrapped(self._told(self._nodes[size]), later="        ", width=WIDTH)
            lines.append(f"    {name} = {self.precision.number(size)}{end} /* {told[0]}")
            lines += told[1:]
            lines[-1] += " */"
        return lines + self._others()

    def _others(self) -> list[str]:
        """What formulas mention and no statement reads."""
        told: dict[Node, tuple[str, str]] = {}
        while len(told) < len(self._mentioned):  # what is told may mention more
            for node, name in list(self._mentioned.items()):
                if node not in told:
                    told[node] = name, f"{name} = {self.precision.number(abs(float(node.value)))} {self._told(node)}"
        if not told:
            return []
        lines = ["/* They are made of these, too, which no statement reads:"]
        for _, text in sorted({*told.values()}, key=lambda one: (bool(ANY.fullmatch(one[0])), *one)):
            lines += wrapped(text, first="   ", later="       ", width=WIDTH)
        return [*lines[:-1], f"{lines[-1]} */"]

    def _told(self, node: Node) -> str:
        """What the number is, each with its unit, and how it was folded where that has this unit."""
        texts, told = [], {self.precision.number(float(node.value)): None}
        given = self._units(node)
        formulas, folded, known = self._folded(node, given)
        for unit in given:
            formula = formulas.told(node, unit) if not folded or unit in folded else ""
            text = _words([m for m in self._meanings[node] if unit_of(m.unit) == unit])
            texts.append(f"{text}: {formula}" if formula and formula not in told else text)
            told[formula] = None
        new = {formula: unit for unit, formula in ((unit, formulas.told(node, unit)) for unit in known)}
        if not given and (len(new) < max(1, len(known)) or None in folded):  # one formula, and which unit nobody knows
            return plain(next(iter(new), formulas.told(node, None)) or "of the mechanism")
        texts += [f"[{unit_text(unit)}] {formula}" for formula, unit in new.items() if formula and formula not in told]
        return plain("; also ".join(texts))

    def _folded(
        self, node: Node, given: Collection[Unit | None]
    ) -> tuple[Formulas, frozenset[Unit | None], list[Unit]]:
        """Formulas by which a constant is what it is in the description; the units that it has by them; those known.

        Squares of masses are taken for what they are only where it can be nothing else.
        """
        for formulas in self._formulas:
            folded = formulas.units(node, folded=True)
            known = sorted(unit for unit in folded if unit is not None)
            few = [unit for unit in known if abs(unit[1]) < 2]
            if {*given} & folded if given else few or None in folded:
                break
        return formulas, folded, few if few or given else known


def _words(meanings: Sequence[Meaning]) -> str:
    """What a number is, with its unit."""
    first = meanings[0]
    parts = list(dict.fromkeys(m.part for m in meanings if m.symbol == first.symbol and m.part))
    several = ", ".join(parts[:PARTS]) + (" ..." if len(parts) > PARTS else "")
    also = list(dict.fromkeys(f"{m.symbol} of {m.part}" for m in meanings if m.symbol != first.symbol and m.part))
    text = f"[{first.unit}] {first.words}{f' of {several}' if several else ''}"
    return text + (f", also {also[0]}" if also else "")


def _positive(node: Node) -> Node:
    inner: Node = node.args[0] if node.op == "neg" else node
    return inner


def common(parts: Sequence[str]) -> str:
    """One name for parts whose names differ in digits only, else the first one.

    >>> common(["limb1_upper", "limb2_upper", "tool"]), common(["arm", "rod"])
    ('limb_upper', 'arm')
    """
    bare = re.sub(r"(?<=[A-Za-z])\d+", "", parts[0], count=1)
    alike = {part for part in parts if re.sub(r"(?<=[A-Za-z])\d+", "", part, count=1) == bare}
    return bare if len(alike) > 1 else parts[0]


def _straight(programs: Iterable[Program | Iteration]) -> list[Program]:
    """All straight-line parts of programs."""
    every = [p.step if isinstance(p, Iteration) else p for p in programs]
    return [*every, *(part for p in every if isinstance(p, RankRevealing) for part in (p.dense, p.wrenches) if part)]


def _sizes(programs: Iterable[Program]) -> Iterator[float]:
    """Absolute values of the constants of all instructions, in order."""
    found = (abs(a) for p in programs for i in p.instructions for a in i.args if type(a) is float)
    yield from dict.fromkeys(found)


def _links(system: Any) -> Iterator[tuple[Node, Meaning]]:
    """Constants of the links in their own axes."""
    for link, frame, inertia in zip(system.tree.links, system.frames, system.inertia, strict=True):
        if not link.index:
            continue
        part = system.tree.part(link.index)
        yield inertia.mass, Meaning(part, "m", "kg", "mass")
        for axis, value in zip(AXES, inertia.first, strict=True):
            yield from _node(value, Meaning(part, f"m{axis}", "kg m", "first moment, link axes,"))
        for axis, value in zip(AXES, frame.offset, strict=True):
            yield from _node(value, Meaning(part, f"offset_{axis}", "m", "offset from the parent's origin"))
        unit = "rad" if link.motion.turns else "m"
        yield frame.phase, Meaning(part, "phase", unit, "what is added to the coordinate")
        for cell, value in _cells(inertia.second):
            yield from _node(value, Meaning(part, f"s{cell}", "kg m^2", "second moment (sum of m r r), link axes,"))
        for cell, value in _cells(frame.rotation):
            yield from _node(value, Meaning(part, f"axes_{cell}", "1", "rotation of the axes before the motion"))


def _cells(matrix: Iterable[Iterable[object]]) -> Iterator[tuple[str, object]]:
    for row, values in zip(AXES, matrix, strict=True):
        for column, value in zip(AXES, values, strict=False):
            yield row + column, value


def _node(value: object, meaning: Meaning) -> Iterator[tuple[Node, Meaning]]:
    if isinstance(value, Node):
        yield value, meaning


def _scales(system: Any) -> Iterator[tuple[Node, Meaning]]:
    """What lengths are divided by where they are compared with angles."""
    length = system.length
    text = "characteristic length"
    scales = {length: ("characteristic_length", "m", text), 1 / length: ("per_length", "1/m", f"1 over the {text}")}
    scales[(1 / length) ** 2] = ("per_length_squared", "1/m^2", f"1 over the square of the {text}")
    for node, size in system.tape.constants.items():
        if node.args[0] is None and size in scales:
            symbol, unit, words = scales[size]
            yield node, Meaning("", symbol, unit, words)


def _of_effects(system: Any, effects: Iterable[Any]) -> Iterator[tuple[Node, Meaning]]:
    """Numbers that effects are given."""
    for effect in effects:
        kind = type(effect).__name__.lower()
        for key in (f.name for f in fields(effect)) if is_dataclass(effect) else ():
            given = getattr(effect, key)
            several = isinstance(given, tuple)
            for axis, value in zip(AXES, given if several else (given,), strict=False):
                with suppress(DescriptionError, ValueError, TypeError):
                    node = system.geometry.known(exact(value))
                    unit = UNITS_OF_FIELDS.get(key, "SI")
                    yield from _node(node, Meaning(kind, axis if several else key, unit, f"{key} of the effect"))


def _given(system: Any) -> Iterator[tuple[Node, Meaning]]:
    """Numbers as they stand in the description: parameters, bodies, points of joints and named points."""
    mechanism, known = system.mechanism, system.geometry.known
    for name, parameter in mechanism.parameters.items():
        symbol = name if "_" in name else f"param_{name}"
        words = parameter.description or "parameter"
        yield from _node(known(parameter.symbol), Meaning("", symbol, parameter.unit, words))
    for name, body in mechanism.bodies.items():
        for axis, value in zip(AXES, body.com or (), strict=False):
            yield from _node(known(value), Meaning(name, f"com_{axis}", "m", "centre of mass, absolute axes,"))
        for cell, value in _cells(body.inertia or ((), (), ())):
            yield from _node(known(value), Meaning(name, f"I{cell}", "kg m^2", "inertia, absolute axes,"))
    points = {name: joint.point for name, joint in mechanism.joints.items()}
    points |= {name: point.at for name, point in mechanism.points.items()}
    for name, place in points.items():
        for axis, value in zip(AXES, place, strict=True):
            yield from _node(known(value), Meaning(name, f"at_{axis}", "m", "point, absolute axes,"))
