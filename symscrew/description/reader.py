"""Raw values of a description turned into exact expressions of its parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy

from symscrew.description.expressions import exact, numeric
from symscrew.description.joints import JOINT_TYPES, JointType
from symscrew.description.limb_letters import Between
from symscrew.description.mechanism import Body, Joint, Matrix3, Parameter, Point, Vector, baked_values
from symscrew.description.names import check_name
from symscrew.description.number_range import check_range
from symscrew.description.validation import Feature, check_axes_triad
from symscrew.errors import DescriptionError, did_you_mean, shorten


class Reader:
    """Turns the raw values of a description into exact expressions of its parameters."""

    def __init__(self, parameters: dict[str, Parameter]) -> None:
        """Read expressions of these parameters."""
        self.parameters = parameters
        self.symbols = {name: p.symbol for name, p in parameters.items()}
        self.values = {name: p.value for name, p in parameters.items()}
        self._read: dict[str, sympy.Expr] = {}  # a description repeats its expressions: limbs are equal
        self.written: dict[sympy.Expr, str] = {}

    def number(self, value: Any, where: str) -> sympy.Expr:
        """One number, finite and real at the parameters' values, and of a size that code can hold."""
        if isinstance(value, str) and value in self._read:
            return self._read[value]
        expression = exact(value, self.symbols, where=where)
        if expression.free_symbols:
            check_range(exact(value, self.values, where=where), where)
        else:
            check_range(expression, where)
        if isinstance(value, str):
            self._read[value] = expression
        self.wrote(expression, value)
        return expression

    def wrote(self, expression: sympy.Expr, value: Any) -> None:
        """Keep the text that an expression was given as: the first, and none of SymPy's own."""
        if not isinstance(value, sympy.Basic):
            self.written.setdefault(expression, str(value).strip())

    def characteristic_length(self, value: Any) -> sympy.Expr | None:
        """The mechanism's characteristic length [m]: positive, the same for all values of run-time parameters."""
        if value is None:
            return None
        where = "mechanism.characteristic_length"
        length = self.number(value, where)
        changing = sorted(map(str, length.xreplace(baked_values(self.parameters)).free_symbols))
        if changing:
            raise DescriptionError(
                f"{where}: depends on the run-time parameter {changing[0]!r}, but scales must not change while the "
                "generated code runs; give a number or an expression of baked parameters"
            )
        size = length.xreplace({p.symbol: p.value for p in self.parameters.values()})
        if not numeric(size, where=where) > 0:
            raise DescriptionError(f"{where}: expected a length above 0 m, got {shorten(value)}")
        return length

    def vector(self, value: Any, where: str) -> Vector:
        """Three numbers; the middle of two points if that is how the point is given."""
        if isinstance(value, Between):
            start, end = self.vector(value.start, where), self.vector(value.end, where)
            x, y, z = ((a + b) / 2 for a, b in zip(start, end, strict=True))
            return (x, y, z)
        if isinstance(value, str) or not isinstance(value, Sequence):
            raise DescriptionError(f"{where}: expected a list of 3 numbers, got {shorten(value)}")
        if len(value) != 3:
            raise DescriptionError(f"{where}: expected 3 numbers, got {len(value)}")
        x, y, z = (self.number(v, f"{where}[{k}]") for k, v in enumerate(value))
        return (x, y, z)

    def axis(self, value: Any, where: str) -> Vector:
        """A direction; along the line between two points if that is how it is given."""
        if not isinstance(value, Between):
            return self.vector(value, where)
        start, end = self.vector(value.start, where), self.vector(value.end, where)
        x, y, z = (b - a for a, b in zip(start, end, strict=True))
        length = sympy.sqrt(x**2 + y**2 + z**2)
        values = {self.symbols[name]: value for name, value in self.values.items()}
        if numeric(length.xreplace(values), where=where) == 0:
            raise DescriptionError(f"{where}: the joint slides along the line between two points that coincide")
        return (x / length, y / length, z / length)

    def joint(self, name: str, raw: dict[str, Any]) -> Joint:
        """The joint that the builder's raw values describe."""
        where = f"joints.{name}"
        kind = _joint_type(raw["type"], f"{where}.type")
        if raw["point"] is None:
            raise DescriptionError(f"{where}: the key 'point' is missing")
        return Joint(
            name=name,
            type=raw["type"],
            parent=check_name(raw["parent"], f"{where}.parent"),
            child=check_name(raw["child"], f"{where}.child"),
            point=self.vector(raw["point"], f"{where}.point"),
            axes=self._axes(raw["axes"], kind.axes, kind.name, f"{where}.axes"),
            pitch=self._pitch(raw["pitch"], raw["type"], f"{where}.pitch"),
            driven=_driven(raw["driven"], kind.freedom, f"{where}.driven"),
            reference=self._reference(raw["reference"], raw["type"], f"{where}.reference"),
        )

    def feature(self, name: str, raw: dict[str, Any]) -> Feature | None:
        """Where the joint is on its child body, if the description says so."""
        where = f"joints.{name}"
        if raw["child_point"] is None and raw["child_axes"] is None:
            return None
        kind = _joint_type(raw["type"], f"{where}.type")
        place, axes = raw["child_point"], raw["child_axes"]
        return Feature(
            point=None if place is None else self.vector(place, f"{where}.child_point"),
            axes=None if axes is None else self._axes(axes, kind.axes, kind.name, f"{where}.child_axes"),
        )

    def _axes(self, value: Any, count: int, kind: str, where: str) -> tuple[Vector, ...]:
        given = [] if value is None else value
        if isinstance(given, str) or not isinstance(given, Sequence):
            raise DescriptionError(f"{where}: expected a list of {count} vectors, got {shorten(value)}")
        if len(given) != count:
            hint = ": the parent's axis, then the child's" if count == 2 else ""
            bare = len(given) == 3 and not isinstance(given[0], list | tuple)
            came = "a single vector; write a list of vectors, such as [[0, 0, 1]]" if bare else len(given)
            raise DescriptionError(
                f"{where}: expected {count} ax{'i' if count == 1 else 'e'}s for a {kind} joint{hint}, got {came}"
            )
        return tuple(self.axis(axis, f"{where}[{k}]") for k, axis in enumerate(given))

    def _pitch(self, value: Any, letter: str, where: str) -> sympy.Expr | None:
        helical = JOINT_TYPES[letter].helical
        if (value is None) == helical:
            rule = "a helical joint needs its pitch [m/rad]" if helical else "only H joints have a pitch"
            raise DescriptionError(f"{where}: {rule}, got {shorten(value)} for a joint of type {letter}")
        return None if value is None else self.number(value, where)

    def _reference(self, value: Any, letter: str, where: str) -> tuple[sympy.Expr, ...]:
        if value is None:
            return ()
        count = JOINT_TYPES[letter].references
        given = value if isinstance(value, Sequence) and not isinstance(value, str) else [value]
        if len(given) != count:
            raise DescriptionError(
                f"{where}: expected {count} value{'s' * (count != 1)} for a joint of type {letter}, got {len(given)}"
            )
        numbers = tuple(self.number(v, f"{where}[{k}]") for k, v in enumerate(given))
        return numbers if any(n != 0 for n in numbers) else ()

    def point(self, name: str, raw: dict[str, Any]) -> Point:
        """The named point that the builder's raw values describe."""
        where = f"points.{name}"
        if raw["at"] is None:
            raise DescriptionError(f"{where}: the key 'at' is missing")
        return Point(name, check_name(raw["body"], f"{where}.body"), self.vector(raw["at"], f"{where}.at"))

    def body(self, name: str, raw: dict[str, Any]) -> Body:
        """The body that the builder's raw values describe."""
        where = f"bodies.{name}"
        mass, com, inertia = raw["mass"], raw["com"], raw["inertia"]
        if mass is None and com is None and inertia is None:
            return Body(name)
        for key, value in (("mass", mass), ("com", com)):
            if value is None:
                raise DescriptionError(
                    f"{where}: the key {key!r} is missing; a body has mass and com (and inertia), or none"
                )
        zero: Vector = (sympy.S.Zero,) * 3
        return Body(
            name=name,
            mass=self.number(mass, f"{where}.mass"),
            com=self.vector(com, f"{where}.com"),
            inertia=(zero, zero, zero) if inertia is None else self._inertia(inertia, f"{where}.inertia"),
        )

    def _inertia(self, value: Any, where: str) -> Matrix3:
        axes: Matrix3 | None = None
        if isinstance(value, Mapping):
            known = ("principal", "matrix", "axes")
            for key in value:
                if key not in known:
                    near = did_you_mean(str(key), known)
                    raise DescriptionError(f"{where}: unknown key {shorten(key)}; {near}")
            if ("principal" in value) == ("matrix" in value):
                raise DescriptionError(f"{where}: expected either 'principal' (3 moments) or 'matrix' (3 x 3)")
            if "axes" in value:
                axes = self._matrix(value["axes"], f"{where}.axes")
                check_axes_triad(axes, self.parameters, f"{where}.axes")
            value = value["principal"] if "principal" in value else value["matrix"]
        if isinstance(value, Sequence) and len(value) == 3 and isinstance(value[0], list | tuple):
            moments = self._matrix(value, where)
        else:
            a, b, c = self.vector(value, where)
            zero = sympy.S.Zero
            moments = ((a, zero, zero), (zero, b, zero), (zero, zero, c))
        return moments if axes is None else _in_absolute_axes(moments, axes)

    def _matrix(self, value: Any, where: str) -> Matrix3:
        if isinstance(value, str) or not isinstance(value, Sequence) or len(value) != 3:
            raise DescriptionError(f"{where}: expected 3 rows of 3 numbers, got {shorten(value)}")
        x, y, z = (self.vector(row, f"{where}[{k}]") for k, row in enumerate(value))
        return (x, y, z)


def _in_absolute_axes(moments: Matrix3, axes: Matrix3) -> Matrix3:
    """sum_ij J_ij e_i e_j^T: the inertia J in the axes e as a matrix in absolute axes, exactly."""

    def entry(row: int, column: int) -> sympy.Expr:
        terms = [moments[i][j] * axes[i][row] * axes[j][column] for i in range(3) for j in range(3)]
        return sympy.Add(*terms)

    rows = [[entry(min(r, c), max(r, c)) for c in range(3)] for r in range(3)]
    x, y, z = ((row[0], row[1], row[2]) for row in rows)
    return (x, y, z)


def _joint_type(value: Any, where: str) -> JointType:
    if not isinstance(value, str) or value not in JOINT_TYPES:
        raise DescriptionError(
            f"{where}: unknown joint type {shorten(value)}; {did_you_mean(str(value)[:20], JOINT_TYPES)}"
        )
    return JOINT_TYPES[value]


def _driven(value: Any, freedom: int, where: str) -> tuple[int, ...]:
    if isinstance(value, bool):
        return tuple(range(freedom)) if value else ()
    if isinstance(value, str) or not isinstance(value, Sequence):
        raise DescriptionError(f"{where}: expected true, false or a list of indices, got {shorten(value)}")
    for index in value:
        if isinstance(index, bool) or not isinstance(index, int) or not 0 <= index < freedom:
            raise DescriptionError(
                f"{where}: expected indices of freedoms from 0 to {freedom - 1}, got {shorten(index)}"
            )
    if len(set(value)) != len(value):
        raise DescriptionError(f"{where}: the same freedom is listed twice in {shorten(value)}")
    return tuple(sorted(value))
