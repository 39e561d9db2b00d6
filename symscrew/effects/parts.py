"""What effects ask of a system: their numbers as nodes, joints and points by name, displacements and rates."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import sympy

from symscrew.algebra import Node, dot, expression_node
from symscrew.description import Joint, Point, Reader, check_name, check_range, exact
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.kinematics import System, closure_rate, cut_displacement, drive_row, tree_displacement, turns_are_lost

TIME = sympy.Symbol("t", real=True)
Values = Callable[[Any, str], float]
"""A number of an effect as a float, at some values of the parameters; the text says what it is, for errors."""
Requirement = Callable[[Values], None]
"""Looks at numbers; raises DescriptionError where they do not go together."""


class Parts:
    """Named parts and numbers of one system at its present nodes, with errors that name the effect that asks.

    `given_functions`: values of the effects' texts that change with time or the motion: they may be of any shape;
    `functions_of_time`: those that change with time, as expressions of it and the parameters, and which effect asks.
    """

    def __init__(self, system: System) -> None:
        self.system = system
        self._time: Node | None = None
        self.given_functions: list[Node] = []
        self.functions_of_time: list[tuple[str, sympy.Expr]] = []
        self._reader = Reader(dict(system.mechanism.parameters))
        self._required: list[Requirement] = []

    @property
    def half(self) -> Node:
        """1/2."""
        return self.system.tape.reciprocal(self.system.tape.node(2))

    @property
    def time(self) -> Node:
        """The time [s]; asking for it makes it an input."""
        if self._time is None:
            self._time = self.sampled("t", "s", "time")
        return self._time

    def sampled(self, name: str, unit: str, description: str) -> Node:
        """A symbol with values at the sample states, so that whatever depends on it can be sampled."""
        tape = self.system.tape
        known = name in tape.symbols
        node = tape.symbol(name, unit, description)
        if not known:
            random = np.random.default_rng(zlib.crc32(name.encode()))
            tape.add_samples({node: random.uniform(-1, 1.5, len(self.system.sample_states[0]))})
        return node

    # -- numbers -------------------------------------------------------------------------------------------

    def number(self, value: Any, what: str, *, least: float | None = None, above: float | None = None) -> Node:
        """A number, or a text with an expression of the mechanism's parameters, as a node.

        Raises:
            DescriptionError: it is none, is not finite, or is out of bounds at the parameters' values.
        """
        expression = self._reader.number(value, what)

        def within(at: Values) -> None:
            size = at(expression, what)
            if (least is not None and size < least) or (above is not None and size <= above):
                bound = f"at least {least:g}" if least is not None else f"above {above:g}"
                which = f", which is {size:g}" if expression.free_symbols else ""
                raise DescriptionError(f"{what}: expected a number {bound}, got {shorten(value)}{which}")

        if least is not None or above is not None:
            self.require(within)
        return self.system.geometry.scalar(expression)

    def require(self, holds: Requirement) -> None:
        """Let `holds` look at numbers at the parameters' values, and again where a run has others (`check_values`).

        Raises:
            DescriptionError: what it raises.
        """
        holds(self._default)
        self._required.append(holds)

    def check_values(self, values: Mapping[str, sympy.Expr]) -> None:
        """What effects require of their numbers, at other values of the parameters by name.

        Raises:
            DescriptionError: which effect refuses which number.
        """
        numbers = {p.symbol: values[name] for name, p in self.system.mechanism.parameters.items()}

        def at(value: Any, what: str) -> float:
            found = self._reader.number(value, what).xreplace(numbers)
            check_range(found, what)
            return float(found)

        for holds in self._required:
            holds(at)

    def _default(self, value: Any, what: str) -> float:
        return float(self.system.mechanism.number(self._reader.number(value, what)))

    def fixed(self, value: Any, what: str) -> float:
        """A number as a float that decides what the code is, so that no run-time parameter may change it.

        Raises:
            DescriptionError: it depends on one.
        """
        free = self.system.mechanism.baked(self._reader.number(value, what)).free_symbols
        if free:
            name = min(map(str, free))
            raise DescriptionError(
                f"{what}: expected a number that is known when the code is written, got {shorten(value)} with the "
                f"run-time parameter {name!r}; write the number, or make {name!r} no run-time parameter"
            )
        return self._default(value, what)

    def varies(self, value: Any, what: str) -> bool:
        """Whether a number depends on a run-time parameter."""
        return bool(self.system.mechanism.baked(self._reader.number(value, what)).free_symbols)

    def time_expression(self, value: Any, what: str) -> sympy.Expr:
        """A number or a text with an expression of the time t and the parameters, exact."""
        parameters = self.system.mechanism.parameters
        if "t" in parameters:
            raise DescriptionError(f"{what}: 't' is the time here; expected no parameter of this name")
        names = {name: p.symbol for name, p in parameters.items()}
        expression = exact(value, {**names, "t": TIME}, where=what)
        if not expression.free_symbols:
            check_range(expression, what)
        return expression

    def of(self, expression: sympy.Expr, symbols: dict[sympy.Symbol, Node], what: str) -> Node:
        """A SymPy expression of some symbols, the time and the parameters as a node."""
        known = {**self.system.geometry.parameters, **symbols}
        if TIME in expression.free_symbols and TIME not in known:
            known[TIME] = self.time
        try:
            made = expression_node(self.system.tape, self.system.mechanism.baked(expression), known)
        except (ValueError, AttributeError, KeyError) as error:
            raise DescriptionError(f"{what}: cannot be turned into code: {error}") from error
        if expression.free_symbols & {TIME, *symbols}:
            self.given_functions.append(made)
        if TIME in expression.free_symbols:
            self.functions_of_time.append((what, expression))
        return made

    def function_of_time(self, value: Any, what: str) -> Node:
        """A number or an expression of the time t and the parameters as a node."""
        return self.of(self.time_expression(value, what), {}, what)

    # -- parts ---------------------------------------------------------------------------------------------

    def point(self, name: str, what: str) -> Point:
        """A named point of the mechanism; `what` says which effect asks."""
        points = self.system.mechanism.points
        if name not in points:
            raise DescriptionError(
                f"{what}: expected a named point of the mechanism, got {shorten(name)}; "
                f"{did_you_mean(str(name), points)}"
            )
        return points[name]

    def joint(self, name: str, what: str) -> Joint:
        """A joint of the mechanism; `what` says which effect asks."""
        joints = self.system.mechanism.joints
        if name not in joints:
            raise DescriptionError(
                f"{what}: expected a joint of the mechanism, got {shorten(name)}; {did_you_mean(str(name), joints)}"
            )
        return joints[name]

    def freedoms(self, joint: str, freedom: int | None, what: str) -> list[int]:
        """Indices of the freedoms that are meant: all of them where none is named."""
        count = self.joint(joint, what).kind.freedom
        if freedom is None:
            return list(range(count))
        if isinstance(freedom, bool) or not isinstance(freedom, int) or not 0 <= freedom < count:
            last = f"an index from 0 to {count - 1}" if count else "a joint with freedoms"
            raise DescriptionError(f"{what}: expected as freedom of joint {joint!r} {last}, got {shorten(freedom)}")
        return [freedom]

    def freedom(self, joint: str, freedom: int | None, what: str) -> int:
        """The one freedom that is meant."""
        found = self.freedoms(joint, freedom, what)
        if len(found) != 1:
            raise DescriptionError(
                f"{what}: joint {joint!r} has {len(found)} freedoms; expected the key 'freedom' with one of "
                f"{', '.join(map(str, found)) or 'none'}"
            )
        return found[0]

    def tree_index(self, joint: str, freedom: int, what: str) -> int:
        """Index into v of a freedom of a joint of the spanning tree."""
        tree = self.system.tree
        if joint not in tree.joints:
            known = [name for name in tree.joints if name != tree.virtual]
            raise DescriptionError(
                f"{what}: joint {joint!r} closes a loop; expected a joint of the spanning tree: {', '.join(known)}"
            )
        return tree.velocity_indices(joint)[freedom]

    def drive_index(self, joint: str, freedom: int, what: str) -> int:
        """Index into u of the drive on a freedom."""
        drives = self.system.drives
        if (joint, freedom) not in drives:
            names = ", ".join(f"{name}.{k}" for name, k in drives) or "none"
            raise DescriptionError(
                f"{what}: expected a driven freedom, got joint {joint!r}, freedom {freedom}; driven are {names}"
            )
        return drives.index((joint, freedom))

    def slides(self, joint: str, freedom: int) -> bool:
        """Whether a freedom is a translation."""
        return self.system.mechanism.joints[joint].kind.freedoms[freedom].prismatic

    def label(self, name: str, joint: str, freedom: int, what: str) -> str:
        """The given name, or the joint's, with the freedom where it has several."""
        several = self.system.mechanism.joints[joint].kind.freedom > 1
        return check_name(name or (f"{joint}_{freedom}" if several else joint), f"{what}: name")

    # -- motion of joints --------------------------------------------------------------------------------------

    def displacement(self, joint: str, freedom: int, what: str) -> Node:
        """Displacement of a freedom [m or rad], of a tree joint or of one that closes a loop."""
        found = self.joint(joint, what)
        if found.kind.spherical:
            raise DescriptionError(
                f"{what}: joint {joint!r} turns freely in space and has no single displacement; "
                "expected a joint of revolute, prismatic or helical motions"
            )
        cut = next((c for c in self.system.cuts if c.joint.name == joint), None)
        lost = cut is not None and turns_are_lost(cut, self.system.linkage, self.system.geometry)
        if lost and found.kind.freedoms[freedom].turns:
            raise DescriptionError(
                f"{what}: a loop is cut at joint {joint!r}, where whole turns are not known; an effect that asks for a "
                "displacement names the joint in its property 'reads', so that the loop is cut elsewhere"
            )
        return self.displacements(found)[freedom]

    def displacements(self, joint: Joint) -> Sequence[Node]:
        """Displacements of all freedoms of a joint; a spherical motion as rotation vector in the parent's axes."""
        system = self.system
        if joint.name in system.tree.joints:
            return tree_displacement(system, joint)
        return cut_displacement(system, next(c for c in system.cuts if c.joint.name == joint.name))

    def rate(self, joint: str, freedom: int) -> Node:
        """Rate of a freedom [m/s or rad/s], whose product with a drive on it is the drive's power."""
        system = self.system
        if joint in system.tree.joints:
            return system.joint_rates(system.inputs.v)[system.tree.velocity_indices(joint)[freedom]]
        cut = next(c for c in system.cuts if c.joint.name == joint)
        motions = cut.joint.kind.freedoms
        rows = tuple(drive_row(cut, k, system.linkage) for k in range(len(motions)))
        sign = -1 if cut.tip_is_parent else 1
        seen = closure_rate(replace(cut, rows=rows), system.linkage, system.twist, system.inputs.v)
        turning = [k for k, m in enumerate(motions) if m.revolute]
        if len(turning) == 2:  # of skew axes, each row sees a part of the other rate too: solve the two for both
            skew = system.tape.settle(dot(cut.tip_axes[0], cut.tip_axes[1]))
            if skew is not system.tape.zero:
                other = turning[1 - turning.index(freedom)]
                return sign * (seen[freedom] - skew * seen[other]) / (1 - skew * skew)
        return sign * seen[freedom]
