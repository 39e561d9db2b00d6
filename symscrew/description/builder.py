"""A mechanism from Python calls.

    builder = MechanismBuilder("pendulum")
    builder.parameter("length", "0.5", unit="m")
    builder.body("rod", mass=1, com=[0, 0, "-length/2"], inertia=["length^2/12", "length^2/12", 0])
    builder.joint("pivot", "R", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 1, 0]])
    mechanism = builder.build()

Any number may be an int, a float (read as its shortest decimal), text with an expression of the
parameters, or an exact SymPy expression. `symscrew.description.toml_file` reads a file through these same calls.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy

from symscrew.description.coupled import check_couplings, read_coupling
from symscrew.description.expressions import CONSTANTS, FUNCTIONS, MAX_NODES, exact, node_count
from symscrew.description.limb_letters import plan_limb
from symscrew.description.mechanism import Body, Limb, Mechanism, Parameter
from symscrew.description.names import check_mechanism_name, check_name, check_text
from symscrew.description.number_range import check_range
from symscrew.description.reader import Reader
from symscrew.description.units import in_si
from symscrew.description.validation import validate
from symscrew.errors import DescriptionError, shorten


class MechanismBuilder:
    """Collects the parts of a mechanism; `build` reads every number and validates the whole."""

    def __init__(
        self,
        name: str,
        *,
        ground: str = "base",
        platform: str | None = None,
        description: str = "",
        source: str = "",
        characteristic_length: Any = None,
    ) -> None:
        """Start the mechanism `name` with the given ground body and, for limbs, platform body.

        `characteristic_length` [m] is what norms that mix lengths and angles divide lengths by; left out it is
        the root mean square distance of the joints' and named points from their centre.

        Raises:
            DescriptionError: a name that is not an identifier or that a language reserves, a text that is too long.
        """
        self._name = check_mechanism_name(name, "mechanism.name")
        self._ground = check_name(ground, "mechanism.ground")
        self._platform = None if platform is None else check_name(platform, "mechanism.platform")
        self._description = check_text(description, "mechanism.description")
        self._source = check_text(source, "mechanism.source")
        self._characteristic_length = characteristic_length
        self._parameters: dict[str, dict[str, Any]] = {}
        self._bodies: dict[str, dict[str, Any]] = {}
        self._joints: dict[str, dict[str, Any]] = {}
        self._points: dict[str, dict[str, Any]] = {}
        self._limbs: dict[str, tuple[str, ...]] = {}
        self._couplings: dict[str, dict[str, Any]] = {}

    def parameter(
        self, name: str, value: Any, unit: str = "1", *, description: str = "", run_time: bool = False
    ) -> MechanismBuilder:
        """Add a parameter; its value may refer to other parameters, whose changes it follows.

        A `run_time` parameter is an input of every generated function, any other is baked into the code: as a number,
        or as a formula where it follows a run-time parameter. A number in another unit than SI's is converted, 500 in
        "mm" to 0.5 in "m"; a formula of other parameters is in SI units already.

        Raises:
            DescriptionError: a name that is taken or cannot be one, a unit that is not known, a text that is too long.
        """
        where = f"parameters.{check_name(name, 'parameters')}"
        if name in FUNCTIONS or name in CONSTANTS:
            raise DescriptionError(f"{where}: {name!r} is a function or constant of expressions; use another name")
        if not isinstance(run_time, bool):
            raise DescriptionError(f"{where}.run_time: expected true or false, got {shorten(run_time)}")
        factor, si = in_si(check_text(unit, f"{where}.unit", limit=40), f"{where}.unit")
        check_text(description, f"{where}.description")
        if factor != 1:
            value = factor * _number_in(unit, value, f"{where}.value")
        self._add(self._parameters, "parameters", name, value=value, unit=si, description=description)
        self._parameters[name]["run_time"] = run_time
        self._parameters[name]["given_in"] = unit if factor != 1 else ""
        return self

    def __repr__(self) -> str:
        counts = f"{len(self._bodies)} bodies, {len(self._joints)} joints, {len(self._parameters)} parameters"
        return f"MechanismBuilder({self._name!r}: {counts} so far)"

    def body(self, name: str, *, mass: Any = None, com: Any = None, inertia: Any = None) -> MechanismBuilder:
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

    def coupling(self, name: str, *, terms: Mapping[str, Any]) -> MechanismBuilder:
        """Add a relation between coordinates: gears, a belt, a mimic joint, a tendon over fixed points.

        `terms`: coordinate (`joint`, or `joint.k` of a joint with several) -> its factor, or the coefficients of its
        powers from the first on. The sum of the terms stays what it is in the reference configuration:
        `terms={"wheel": 20, "pinion": 8}` are gears of 20 and 8 teeth.
        """
        self._add(self._couplings, "couplings", name, terms=terms)
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
        """Add a limb by letters, which makes its joints and bodies (`symscrew.description.limb_letters.plan_limb`).

        Without `type` the limb only gives a name to the existing `joints`, in order from base to tip.
        """
        where = f"limbs.{check_name(name, 'limbs')}"
        if name in self._limbs:
            raise DescriptionError(f"{where}: this name is given twice; names of limbs must differ")
        if type is None:
            if options or base is not None or tip is not None or joints is None:
                raise DescriptionError(f"{where}: the key 'type' is missing, such as type = \"UPS\"")
            if isinstance(joints, str) or not isinstance(joints, Sequence) or not joints:
                raise DescriptionError(f"{where}.joints: expected a list of joint names, got {shorten(joints)}")
            self._limbs[name] = tuple(check_name(joint, f"{where}.joints") for joint in joints)
            return self
        tip = tip if tip is not None else self._platform
        if tip is None:
            raise DescriptionError(f"{where}: no 'tip' body given and the mechanism has no platform; give one")
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
        reader = Reader(_resolve(self._parameters))
        for name, raw in self._parameters.items():
            parameter = reader.parameters[name]
            reader.wrote(parameter.value if parameter.formula is None else parameter.formula, raw["value"])
        features = {name: reader.feature(name, raw) for name, raw in self._joints.items()}
        bodies = {self._ground: Body(self._ground)}
        bodies |= {name: reader.body(name, raw) for name, raw in self._bodies.items()}
        joints = {name: reader.joint(name, raw) for name, raw in self._joints.items()}
        mechanism = Mechanism(
            name=self._name,
            ground=self._ground,
            bodies=bodies,
            joints=joints,
            points={name: reader.point(name, raw) for name, raw in self._points.items()},
            parameters=reader.parameters,
            limbs={name: Limb(name, joints) for name, joints in self._limbs.items()},
            couplings={
                name: read_coupling(reader, name, raw["terms"], joints) for name, raw in self._couplings.items()
            },
            platform=self._platform,
            description=self._description,
            source=self._source,
            characteristic_length=reader.characteristic_length(self._characteristic_length),
            written=reader.written,
        )
        warnings = validate(mechanism, {name: f for name, f in features.items() if f is not None})
        check_couplings(mechanism)
        return mechanism.warned(warnings)

    @staticmethod
    def _add(parts: dict[str, dict[str, Any]], section: str, name: str, **values: Any) -> None:
        check_name(name, section)
        if name in parts:
            raise DescriptionError(f"{section}.{name}: this name is given twice; names of {section} must differ")
        parts[name] = values


def _number_in(unit: str, value: Any, where: str) -> sympy.Expr:
    """A number that is to be converted: no formula of other parameters, which have units already."""
    try:
        return exact(value, where=where)
    except DescriptionError as error:
        raise DescriptionError(f"{error}; of a value in {unit!r} only a number is converted to SI units") from error


def _resolve(raw: Mapping[str, dict[str, Any]]) -> dict[str, Parameter]:
    """Parameters with values that are exact numbers; refuses cycles, however long."""
    symbols = {name: sympy.Symbol(name, real=True) for name in raw}
    defined = {name: exact(part["value"], symbols, where=f"parameters.{name}.value") for name, part in raw.items()}
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
            # Read again with the values put in: the limits on size must hold for the number as well.
            values[name] = exact(raw[name]["value"], values, where=where)
            check_range(values[name], where)
            if node_count(values[name]) > MAX_NODES // 10:
                raise DescriptionError(f"{where}: the value has too many terms once its parameters are put in")
        waiting = [name for name in waiting if name not in values]
    formulas = {name: value if value.free_symbols else None for name, value in defined.items()}
    return {
        name: Parameter(name, **{**part, "value": values[name], "formula": formulas[name]})
        for name, part in raw.items()
    }


def _cycle(defined: Mapping[str, sympy.Expr], waiting: Sequence[str]) -> list[str]:
    path, stuck = [waiting[0]], set(waiting)
    while True:
        follows = min(str(s) for s in defined[path[-1]].free_symbols if str(s) in stuck)
        if follows in path:
            return [*path[path.index(follows) :], follows]
        path.append(follows)
