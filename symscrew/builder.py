"""A mechanism from Python calls.

    builder = MechanismBuilder("pendulum")
    builder.parameter("length", "0.5", unit="m")
    builder.body("rod", mass=1, com=[0, 0, "-length/2"], inertia=["length^2/12", "length^2/12", 0])
    builder.joint("pivot", "R", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 1, 0]])
    mechanism = builder.build()

Any number may be an int, a float (read as its shortest decimal), text with an expression of the
parameters, or an exact SymPy expression. `symscrew.description` reads a file through these same calls.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

import sympy

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.expressions import CONSTANTS, FUNCTIONS, MAX_NODES, exact, node_count, numeric
from symscrew.joints import JOINT_TYPES, JointType
from symscrew.limbs import Between, plan_limb
from symscrew.mechanism import Body, Joint, Limb, Matrix3, Mechanism, Parameter, Point, Vector
from symscrew.names import check_name, check_text
from symscrew.validation import Feature, check_axes_triad, validate


class MechanismBuilder:
    """Collects the parts of a mechanism; `build` reads every number and validates the whole."""

    def __init__(
        self,
        name: str,
        ground: str = "base",
        platform: str | None = None,
        description: str = "",
        source: str = "",
    ) -> None:
        """Start the mechanism `name` with the given ground body and, for limbs, platform body."""
        self._name = check_name(name, "mechanism.name")
        self._ground = check_name(ground, "mechanism.ground")
        self._platform = None if platform is None else check_name(platform, "mechanism.platform")
        self._description = check_text(description, "mechanism.description")
        self._source = check_text(source, "mechanism.source")
        self._parameters: dict[str, dict[str, Any]] = {}
        self._bodies: dict[str, dict[str, Any]] = {}
        self._joints: dict[str, dict[str, Any]] = {}
        self._points: dict[str, dict[str, Any]] = {}
        self._limbs: dict[str, tuple[str, ...]] = {}

    def parameter(
        self, name: str, value: Any, unit: str = "1", description: str = "", run_time: bool = False
    ) -> MechanismBuilder:
        """Add a parameter; its value may refer to other parameters that are not run-time inputs."""
        where = f"parameters.{check_name(name, 'parameters')}"
        if name in FUNCTIONS or name in CONSTANTS:
            raise DescriptionError(
                f"{where}: {name!r} is a function or constant of expressions; use another name"
            )
        if not isinstance(run_time, bool):
            raise DescriptionError(f"{where}.run_time: expected true or false, got {shorten(run_time)}")
        check_text(unit, f"{where}.unit", limit=40)
        check_text(description, f"{where}.description")
        self._add(self._parameters, "parameters", name, value=value, unit=unit, description=description)
        self._parameters[name]["run_time"] = run_time
        return self

    def body(
        self, name: str, *, mass: Any = None, com: Any = None, inertia: Any = None
    ) -> MechanismBuilder:
        """Add a body: mass [kg], centre of mass [m], inertia about it [kg m^2]; all or none of mass and com.

        `inertia` is three principal moments (absolute axes), a 3x3 matrix (absolute axes) or a mapping
        `{"principal": [...], "axes": [[..], [..], [..]]}` or `{"matrix": [...], "axes": [...]}` with three
        orthogonal unit vectors. Left out it is zero: a mass point.
        """
        self._add(self._bodies, "bodies", name, mass=mass, com=com, inertia=inertia)
        return self

    def joint(
        self,
        name: str,
        type: str,
        *,
        parent: str,
        child: str,
        point: Any = None,
        axes: Any = None,
        pitch: Any = None,
        driven: bool | Sequence[int] = False,
        reference: Any = None,
        child_point: Any = None,
        child_axes: Any = None,
    ) -> MechanismBuilder:
        """Add a joint from `parent` to `child`, by point [m] and unit axes in the reference configuration.

        `child_point` and `child_axes` are where the joint's feature is on the child body, when that is
        known independently; `build` checks that they meet `point` and `axes`.
        """
        self._add(
            self._joints, "joints", name, type=type, parent=parent, child=child, point=point, axes=axes,
            pitch=pitch, driven=driven, reference=reference, child_point=child_point, child_axes=child_axes,
        )  # fmt: skip
        return self

    def point(self, name: str, *, body: str, at: Any) -> MechanismBuilder:
        """Add a named point fixed in `body`, at its place in the reference configuration [m]."""
        self._add(self._points, "points", name, body=body, at=at)
        return self

    def limb(
        self,
        name: str,
        type: str | None = None,
        *,
        base: str | None = None,
        tip: str | None = None,
        joints: Sequence[str] | None = None,
        **options: Any,
    ) -> MechanismBuilder:
        """Add a limb by letters, which makes its joints and bodies (`symscrew.limbs.plan_limb`).

        Without `type` the limb only gives a name to the existing `joints`, in order from base to tip.
        """
        where = f"limbs.{check_name(name, 'limbs')}"
        if name in self._limbs:
            raise DescriptionError(f"{where}: this name is given twice; names of limbs must differ")
        if type is None:
            if options or base is not None or tip is not None or joints is None:
                raise DescriptionError(f"{where}: the key 'type' is missing, such as type = \"UPS\"")
            if isinstance(joints, str) or not isinstance(joints, Sequence) or not joints:
                raise DescriptionError(
                    f"{where}.joints: expected a list of joint names, got {shorten(joints)}"
                )
            self._limbs[name] = tuple(check_name(joint, f"{where}.joints") for joint in joints)
            return self
        tip = tip if tip is not None else self._platform
        if tip is None:
            raise DescriptionError(
                f"{where}: no 'tip' body given and the mechanism has no platform; give one"
            )
        if joints is not None:
            options["joints"] = joints
        plan = plan_limb(name, type, base=self._ground if base is None else base, tip=tip, **options)
        for body in plan.bodies:
            self.body(**body)
        for joint in plan.joints:
            self.joint(**joint)
        self._limbs[name] = tuple(joint["name"] for joint in plan.joints)
        return self

    def build(self) -> Mechanism:
        """The validated mechanism.

        Raises:
            DescriptionError: names the first part that is wrong, with the cure.
        """
        reader = _Reader(_resolve(self._parameters))
        features = {name: reader.feature(name, raw) for name, raw in self._joints.items()}
        bodies = {self._ground: Body(self._ground)}
        bodies |= {name: reader.body(name, raw) for name, raw in self._bodies.items()}
        mechanism = Mechanism(
            name=self._name,
            ground=self._ground,
            bodies=bodies,
            joints={name: reader.joint(name, raw) for name, raw in self._joints.items()},
            points={name: reader.point(name, raw) for name, raw in self._points.items()},
            parameters=reader.parameters,
            limbs={name: Limb(name, joints) for name, joints in self._limbs.items()},
            platform=self._platform,
            description=self._description,
            source=self._source,
        )
        warnings = validate(mechanism, {name: f for name, f in features.items() if f is not None})
        return dataclasses.replace(mechanism, warnings=warnings)

    @staticmethod
    def _add(parts: dict[str, dict[str, Any]], section: str, name: str, **values: Any) -> None:
        check_name(name, section)
        if name in parts:
            raise DescriptionError(
                f"{section}.{name}: this name is given twice; names of {section} must differ"
            )
        parts[name] = values


def _resolve(raw: Mapping[str, dict[str, Any]]) -> dict[str, Parameter]:
    """Parameters with values that are exact numbers; refuses cycles, however long."""
    symbols = {name: sympy.Symbol(name, real=True) for name in raw}
    defined = {
        name: exact(part["value"], symbols, where=f"parameters.{name}.value") for name, part in raw.items()
    }
    values: dict[str, sympy.Expr] = {}
    waiting = list(raw)
    while waiting:
        ready = [n for n in waiting if all(str(s) in values for s in defined[n].free_symbols)]
        if not ready:
            cycle = _cycle(defined, waiting)
            raise DescriptionError(
                f"parameters.{cycle[0]}.value: the parameters refer to each other in a circle: "
                + " -> ".join(cycle)
                + "; give one of them a value of its own"
            )
        for name in ready:
            where = f"parameters.{name}.value"
            for symbol in sorted(map(str, defined[name].free_symbols)):
                if raw[symbol]["run_time"]:
                    raise DescriptionError(
                        f"{where}: depends on the run-time parameter {symbol!r}, whose changes it would not "
                        "follow; write the expression where it is used, or bake the parameter in"
                    )
            # Read again with the values put in: the limits on size must hold for the number as well.
            values[name] = exact(raw[name]["value"], values, where=where)
            numeric(values[name], where=where)
            if node_count(values[name]) > MAX_NODES // 10:
                raise DescriptionError(
                    f"{where}: the value has too many terms once its parameters are put in"
                )
        waiting = [name for name in waiting if name not in values]
    return {name: Parameter(name, **{**part, "value": values[name]}) for name, part in raw.items()}


def _cycle(defined: Mapping[str, sympy.Expr], waiting: Sequence[str]) -> list[str]:
    path, stuck = [waiting[0]], set(waiting)
    while True:
        follows = min(str(s) for s in defined[path[-1]].free_symbols if str(s) in stuck)
        if follows in path:
            return [*path[path.index(follows) :], follows]
        path.append(follows)


class _Reader:
    """Turns the raw values of a description into exact expressions of its parameters."""

    def __init__(self, parameters: dict[str, Parameter]) -> None:
        self.parameters = parameters
        self.symbols = {name: p.symbol for name, p in parameters.items()}
        self.values = {name: p.value for name, p in parameters.items()}

    def number(self, value: Any, where: str) -> sympy.Expr:
        expression = exact(value, self.symbols, where=where)
        if expression.free_symbols:
            numeric(exact(value, self.values, where=where), where=where)
        else:
            numeric(expression, where=where)
        return expression

    def vector(self, value: Any, where: str) -> Vector:
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
            raise DescriptionError(
                f"{where}: the joint slides along the line between two points that coincide"
            )
        return (x / length, y / length, z / length)

    def joint(self, name: str, raw: dict[str, Any]) -> Joint:
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
        if (value is None) == (letter == "H"):
            rule = "a helical joint needs its pitch [m/rad]" if letter == "H" else "only H joints have a pitch"
            raise DescriptionError(f"{where}: {rule}, got {shorten(value)} for a joint of type {letter}")
        return None if value is None else self.number(value, where)

    def _reference(self, value: Any, letter: str, where: str) -> tuple[sympy.Expr, ...]:
        if value is None:
            return ()
        motions = JOINT_TYPES[letter].motions
        count = 0 if any(m.kind == "S" for m in motions) or letter == "E" else len(motions)
        given = value if isinstance(value, Sequence) and not isinstance(value, str) else [value]
        if len(given) != count:
            raise DescriptionError(
                f"{where}: expected {count} value{'s' * (count != 1)} for a joint of type {letter}, got "
                f"{len(given)}"
            )
        numbers = tuple(self.number(v, f"{where}[{k}]") for k, v in enumerate(given))
        return numbers if any(n != 0 for n in numbers) else ()

    def point(self, name: str, raw: dict[str, Any]) -> Point:
        where = f"points.{name}"
        if raw["at"] is None:
            raise DescriptionError(f"{where}: the key 'at' is missing")
        return Point(name, check_name(raw["body"], f"{where}.body"), self.vector(raw["at"], f"{where}.at"))

    def body(self, name: str, raw: dict[str, Any]) -> Body:
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
                raise DescriptionError(
                    f"{where}: expected either 'principal' (3 moments) or 'matrix' (3 x 3)"
                )
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
