"""What a mechanism is: bodies, joints, loops, points and parameters, as immutable data.

A mechanism is a connected graph. Its vertices are bodies (one of them is the ground), its edges are
joints; a loop is a joint between two bodies that are already connected, nothing else. Everything is
given in absolute axes in the reference configuration, so no body frames are needed. Numbers are exact
SymPy expressions, free of floating point, in the mechanism's parameters.

`builder` makes a `Mechanism` from Python calls, `toml_file` from a TOML file; both end in `validation`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import sympy

from symscrew import notebook
from symscrew.description.joints import JOINT_TYPES, JointType

MOST_LETTERS = 40  # of a formula that stands in a line of text

Vector = tuple[sympy.Expr, sympy.Expr, sympy.Expr]
Matrix3 = tuple[Vector, Vector, Vector]


@dataclass(frozen=True)
class Parameter:
    """A named quantity of the description.

    `value` is an exact number; `formula` is what it was given as where it refers to other parameters, in their
    symbols. A run-time parameter is an input of every generated function; any other is baked into the code, as its
    value or, where its formula follows a run-time parameter, as that formula. `given_in`: the unit of the description
    where that is another one than the SI unit `unit`.
    """

    name: str
    value: sympy.Expr
    unit: str = "1"
    description: str = ""
    run_time: bool = False
    formula: sympy.Expr | None = None
    given_in: str = field(default="", compare=False)

    @property
    def symbol(self) -> sympy.Symbol:
        """The real SymPy symbol that stands for this parameter in all expressions."""
        return sympy.Symbol(self.name, real=True)


@dataclass(frozen=True)
class Body:
    """A rigid body. `mass` [kg], `com` [m], `inertia` [kg m^2] about the centre of mass, absolute axes.

    All three are None for a body without inertia (kinematics only, or a massless link).
    """

    name: str
    mass: sympy.Expr | None = None
    com: Vector | None = None
    inertia: Matrix3 | None = None

    def __repr__(self) -> str:
        return f"Body({self.name!r}, {'without inertia' if self.mass is None else _short(self.mass) + ' kg'})"


@dataclass(frozen=True)
class Joint:
    """A joint from `parent` to `child`: its point [m] and unit axes in the reference configuration.

    `type` is one of the keys of `symscrew.description.joints.JOINT_TYPES`. `pitch` [m/rad] belongs to H only.
    `driven` lists the indices of the driven freedoms. `reference` are the values of the joint's
    coordinates in the reference configuration (default 0; S, E and free joints have none).
    """

    name: str
    type: str
    parent: str
    child: str
    point: Vector
    axes: tuple[Vector, ...] = ()
    pitch: sympy.Expr | None = None
    driven: tuple[int, ...] = ()
    reference: tuple[sympy.Expr, ...] = ()

    def __repr__(self) -> str:
        driven = ", driven" if self.driven else ""
        return f"Joint({self.name!r}, {self.type} from {self.parent!r} to {self.child!r}{driven})"

    @property
    def kind(self) -> JointType:
        """What its type is: its elementary motions, and all that follows from them."""
        return JOINT_TYPES[self.type]


@dataclass(frozen=True)
class Point:
    """A named point fixed in a body, at its place in the reference configuration [m]."""

    name: str
    body: str
    at: Vector


@dataclass(frozen=True)
class Limb:
    """Names of the joints of a limb in order from `base` to `tip`, for people and for mobility analysis."""

    name: str
    joints: tuple[str, ...]


@dataclass(frozen=True)
class CoupledTerm:
    """What one coordinate adds to a coupling: c_1 x + c_2 x^2 + ..., with its `coefficients` (c_1, c_2, ...).

    x is the coordinate of a joint's elementary motion number `motion` (0 for joints with one): an angle or a length.
    """

    joint: str
    motion: int
    coefficients: tuple[sympy.Expr, ...]


@dataclass(frozen=True)
class Coupling:
    """A relation between coordinates: the sum of its terms is what it is in the reference configuration.

    Gears, belts, mimic joints and tendons over fixed points are such relations; see `symscrew.description.coupled`.
    """

    name: str
    terms: tuple[CoupledTerm, ...]

    @property
    def linear(self) -> bool:
        """Whether all its terms are: a ratio that does not change."""
        return all(len(term.coefficients) == 1 for term in self.terms)


@dataclass(frozen=True)
class Mechanism:
    """A validated mechanism. Mappings keep the order of the description.

    `characteristic_length` [m] is what norms of mixed quantities divide lengths by; None for the default
    (`System.length`). `written` are the texts that expressions were given as, for those who write them again.
    """

    name: str
    ground: str
    bodies: Mapping[str, Body]
    joints: Mapping[str, Joint]
    points: Mapping[str, Point] = field(default_factory=dict)
    parameters: Mapping[str, Parameter] = field(default_factory=dict)
    limbs: Mapping[str, Limb] = field(default_factory=dict)
    couplings: Mapping[str, Coupling] = field(default_factory=dict)
    platform: str | None = None
    description: str = ""
    source: str = ""
    characteristic_length: sympy.Expr | None = None
    warnings: tuple[str, ...] = ()
    written: Mapping[sympy.Expr, str] = field(default_factory=dict, compare=False, repr=False)

    def __repr__(self) -> str:
        counts = f"{len(self.bodies)} bodies with the ground, {len(self.joints)} joints"
        return f"Mechanism({self.name!r}: {counts}, {sum(j.kind.freedom for j in self.joints.values())} joint freedoms)"

    def baked(self, expression: sympy.Expr) -> sympy.Expr:
        """`expression` in run-time parameters alone: others are replaced by value, or by formula if they follow one."""
        return expression.xreplace(self._baked) if self._baked else expression

    def number(self, expression: sympy.Expr) -> sympy.Expr:
        """`expression` with every parameter replaced by its value: an exact number."""
        if not self._numbers:
            return expression
        found = self._numbered.get(expression)
        if found is None:
            self._numbered[expression] = found = expression.xreplace(self._numbers)
        return found

    def warned(self, warnings: tuple[str, ...]) -> Mechanism:
        """The same mechanism with warnings; numbers that were found of it stay found."""
        made = replace(self, warnings=warnings)
        vars(made)["_numbered"] = self._numbered
        return made

    def values(self, chosen: Mapping[str, sympy.Expr] | None = None) -> dict[str, sympy.Expr]:
        """The value of every parameter by name, where run-time parameters have the `chosen` ones and others follow."""
        given = {p.symbol: (chosen or {}).get(p.name, p.value) for p in self.parameters.values() if p.run_time}
        return {p.name: given.get(p.symbol, self.baked(p.symbol)).xreplace(given) for p in self.parameters.values()}

    @cached_property
    def _numbers(self) -> dict[sympy.Symbol, sympy.Expr]:
        return {p.symbol: p.value for p in self.parameters.values()}

    @cached_property
    def _numbered(self) -> dict[sympy.Expr, sympy.Expr]:
        """What was asked for so far: points and axes are looked at by every check, and by the derivation."""
        return {}

    @cached_property
    def _baked(self) -> dict[sympy.Symbol, sympy.Expr]:
        return baked_values(self.parameters)

    def _repr_html_(self) -> str:
        rows = [
            (j.name, j.kind.name, j.parent, j.child, ", ".join(str(k + 1) for k in j.driven) or "")
            for j in self.joints.values()
        ]
        header = ("joint", "type", "from", "to", "driven freedoms")
        return notebook.table(f"{self.name}: {self.description or 'a mechanism'}", header, rows)


def _short(expression: sympy.Expr) -> str:
    """A mass as a number, or as the formula it is where that is short."""
    text = str(expression if expression.free_symbols else float(expression))
    return text if len(text) <= MOST_LETTERS else "a formula in"


def followed(parameters: Mapping[str, Parameter], given: Mapping[str, sympy.Expr]) -> dict[str, Parameter]:
    """The parameters with `given` values, and those whose formulas refer to them with the values that follow."""
    values: dict[sympy.Symbol, sympy.Expr] = {}

    def found(parameter: Parameter) -> sympy.Expr:
        if parameter.symbol not in values:
            formula = given.get(parameter.name, parameter.formula)
            if formula is None:
                formula = parameter.value
            values[parameter.symbol] = formula.xreplace({s: found(parameters[str(s)]) for s in formula.free_symbols})
        return values[parameter.symbol]

    return {
        name: replace(p, value=found(p), formula=None if name in given else p.formula) for name, p in parameters.items()
    }


def baked_values(parameters: Mapping[str, Parameter]) -> dict[sympy.Symbol, sympy.Expr]:
    """What stands in the code for every parameter that is no run-time input: its value, or its formula in those."""
    known: dict[sympy.Symbol, sympy.Expr] = {}

    def found(parameter: Parameter) -> sympy.Expr:
        if parameter.run_time:
            return parameter.symbol
        if parameter.symbol not in known:
            formula = parameter.value if parameter.formula is None else parameter.formula
            formula = formula.xreplace({s: found(parameters[str(s)]) for s in formula.free_symbols})
            known[parameter.symbol] = formula if formula.free_symbols else parameter.value
        return known[parameter.symbol]

    for parameter in parameters.values():
        found(parameter)
    return known
