"""One piece of a sweep: from the values of the axes to all results, by the compiled batch functions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from symscrew.assembly import configuration_in_mode
from symscrew.description import Mechanism, check_values_of, exact, followed, in_si
from symscrew.errors import DescriptionError
from symscrew.export import tool_name
from symscrew.kinematics import BODY_PARTS, coordinate_units, full_name, nearest_names
from symscrew.model import Model
from symscrew.simulation import derived_model
from symscrew.studies.workspace.configurations import (
    FINER,
    FINEST,
    Call,
    independent_labels,
    reference_coordinates,
    start_margins,
    walk,
)
from symscrew.studies.workspace.engines import Engine, fastest
from symscrew.studies.workspace.named_coordinates import NamedCoordinates
from symscrew.studies.workspace.plan import AZIMUTH, TILT, Plan

Array = np.ndarray
SINGULAR = 1e-9  # of R, relative: below, the platform has twists that no rates give, and the condition is infinite
WORDS = {"m": "a length [m, mm]", "rad": "an angle [rad, deg]", "1": "a plain number"}
NEEDED = (
    "assemble", "joint_displacements", "drive_rates", "null_space", "platform_jacobian", "forward_kinematics",
    "limb_margins", "constraint_margin", "actuation_margins", "inverse_dynamics", "body_poses", "closure",
    "closure_jacobian", "joint_points",
)  # fmt: skip


@dataclass(frozen=True)
class Prepared:
    """A model ready to evaluate, with what the columns of its results mean."""

    model: Model
    labels: tuple[str, ...]
    units: Mapping[str, str]
    engine: Engine
    begin: Array | None = None

    @property
    def call(self) -> Call:
        """Its functions, by the engine."""
        return self.engine.call


@lru_cache(maxsize=2)
def prepared(key: str, holder: PlanHolder) -> Prepared:
    """The derived and compiled model of a plan, once per process; `key` is the plan's hash and engine."""
    plan = holder.plan
    model = derived_model(plan.mechanism, plan.effects, plan.independent)
    wanted = {name: p for name, p in model.programs.items() if name in NEEDED}
    small = Model(
        model.name, model.mechanism, model.effects, wanted, {n: model.test_inputs[n] for n in wanted}, model.system
    )
    begin = configuration_in_mode(model.system, plan.mode, {}, "mode") if plan.mode else None
    engine, units = fastest(small, plan.engine), result_units(model)
    if not start_margins(small, engine.call):  # all are zero in the reference: no margin is a part of one
        units.pop("margin", None)
    return Prepared(small, independent_labels(model), units, engine, begin)


class PlanHolder:
    """A plan that counts as equal to any other, so that the cache goes by the plan's hash alone."""

    def __init__(self, plan: Plan) -> None:
        """Hold a plan."""
        self.plan = plan

    def __eq__(self, other: object) -> bool:
        """Always, among holders."""
        return isinstance(other, PlanHolder)

    def __hash__(self) -> int:
        """One value for all."""
        return 0


def prepare_sweep(plan: Plan) -> Prepared:
    """The model of a plan.

    Raises:
        DescriptionError: axes, tolerances or limits that the mechanism does not have.
    """
    made = prepared(f"{plan.hash} {plan.engine}", PlanHolder(plan))
    check_plan(plan, made.model, made.units)
    _named(plan, made, plan.cases(0)[:1])
    units = coordinate_units(made.model.mechanism)
    named = {axis.name: full_name(made.model.mechanism, axis.name) for axis in plan.axes}
    own = {typed: made.units.get(name, units.get(name, "")) for typed, name in named.items()}
    varied = {name: made.model.mechanism.parameters[name].unit for name in plan.parameters}
    return replace(made, units={**varied, **own, **made.units})


def evaluate(plan: Plan, chunk: int) -> dict[str, Array]:
    """All results of a piece: name -> values (cases)."""
    made = prepare_sweep(plan)
    model, call = made.model, made.call
    values = plan.cases(chunk)
    y, p = _wanted(plan, made, values, plan.deviations(chunk))
    with np.errstate(all="ignore"):
        q, status, least, close = _walked(plan, made, values, (y, p))
        least = _looked_closer(plan, made, values, (y, p), least=least, close=close)
        extra = (p,) if p is not None else ()
        results = {axis.name: values[:, k] for k, axis in enumerate(plan.axes)}
        if p is not None:
            names = [n for n, q_ in model.mechanism.parameters.items() if q_.run_time]
            results |= {n: p[:, names.index(n)] for n in plan.parameters if n not in results}
        results["status"] = status.astype(float)
        results |= _kinematics(model, call, q, extra)
        results |= _statics(model, call, q, extra)
        results |= _quality(model, call, q, extra, stiffness=plan.stiffness)
        results |= _margins(model, call, q, extra)
        passed = [np.where(value > 0, 1.0, 0.0) for value in least.values()]
        results["regular"] = np.min(passed, axis=0) if passed else np.ones(len(q))
        results["reached"] = np.where((status == 0) & np.isfinite(q).all(axis=1), 1.0, 0.0)
        fits = (results["reached"] > 0) & (results["regular"] > 0)
        for name, low, high in plan.limits:
            fits &= (results[name] >= low) & (results[name] <= high)
        results["allowed"] = fits.astype(float)
    return results


def _walked(
    plan: Plan, made: Prepared, values: Array, wanted: tuple[Array, Array | None]
) -> tuple[Array, Array, dict[str, Array], Array]:
    named = _named(plan, made, values)
    reach = named.reached if named else None
    return walk(made.model, made.call, *wanted, steps=plan.steps, reach=reach, begin=made.begin)


def _looked_closer(
    plan: Plan,
    made: Prepared,
    values: Array,
    wanted: tuple[Array, Array | None],
    *,
    least: dict[str, Array],
    close: Array,
) -> dict[str, Array]:
    """The least margins (cases,) on the way, of places that look regular at steps between which they may not be.

    Only margins are taken from shorter steps: configurations stay those of the walk.
    """
    y, p = wanted
    found, steps = {name: value.copy() for name, value in least.items()}, plan.steps
    left = np.flatnonzero(close)
    while found and steps * FINER <= FINEST:
        left = left[np.min([value[left] for value in found.values()], axis=0) > 0]
        if not len(left):
            break
        steps *= FINER
        finer = replace(plan, steps=steps)
        _, _, now, close = _walked(finer, made, values[left], (y[left], p if p is None else p[left]))
        for name, value in now.items():
            found[name][left] = np.fmin(found[name][left], value)
        left = left[close]
    return found


def check_plan(plan: Plan, model: Model, units: Mapping[str, str] | None = None) -> None:
    """Whether a mechanism has what a plan names.

    Raises:
        DescriptionError: axes, tolerances or limits that it does not have.
    """
    units, mechanism = result_units(model) if units is None else units, model.mechanism
    labels, own = independent_labels(model), coordinate_units(model.mechanism)
    known = {**dict.fromkeys(labels, ""), **{n: p.unit for n, p in mechanism.parameters.items()}, **own}
    names = [full_name(mechanism, axis.name) for axis in plan.axes]
    for axis, name in zip(plan.axes, names, strict=True):
        if name not in known or name.endswith(".turn"):
            short = [end for end in BODY_PARTS if mechanism.platform and end != "turn"]
            near = nearest_names(axis.name, [*labels, *mechanism.parameters, *short, *own])
            raise DescriptionError(f"--over: {axis.name!r} is neither a coordinate nor a parameter; {near}")
        _check_unit("--over", axis.name, axis.unit, units.get(name, known[name]))
        if name in mechanism.parameters:
            for end in (axis.low, axis.high):
                _check_value(mechanism, name, end, f"--over: {name} = {end:g}")
    twice = sorted({n for n in names if names.count(n) > 1})
    if twice:
        raise DescriptionError(f"--over: {twice[0]!r} is given twice")
    spherical, tilted = quaternion_labels(model), {n.rpartition(".")[2] for n in names} & {TILT, AZIMUTH}
    if spherical is not None and tilted and set(spherical) & set(names):
        raise DescriptionError("--over: tilt and azimuth already say what the quaternion's components are")
    if tilted == {AZIMUTH}:
        raise DescriptionError("--over: azimuth needs tilt: azimuth is the direction of the axis of the tilt")
    if plan.mode and not has_own_axes(plan, model):
        own_axes = ", ".join([*labels, *mechanism.parameters])
        raise DescriptionError(f"mode {plan.mode}: a map in a mode is over independent coordinates: {own_axes}")
    varied = {name: mechanism.parameters[name].unit for name in plan.parameters}
    asked = {axis.name: units.get(name, known[name]) for axis, name in zip(plan.axes, names, strict=True)}
    limited = {name: unit for name, unit in {**varied, **asked, **units}.items() if name != "allowed"}
    for name, _, _ in plan.limits:
        if name not in limited:
            raise DescriptionError(f"--limit: no result {name!r}; {nearest_names(name, limited)}")
    for option, name, typed in plan.typed:
        _check_unit(option, name, typed, limited.get(name, ""))


def _check_value(mechanism: Mechanism, name: str, value: float, where: str) -> None:
    """Raises DescriptionError where a parameter's value leaves a body an inertia that is none, a negative mass say."""
    given = {name: exact(float(value))}
    try:
        check_values_of(replace(mechanism, parameters=followed(mechanism.parameters, given)))
    except DescriptionError as error:
        raise DescriptionError(f"{where}: {error}") from error


def check_drawn(plan: Plan, mechanism: Mechanism) -> None:
    """Whether bodies have inertias at the least and the largest value that is drawn of each parameter with a tolerance.

    Raises:
        DescriptionError: names the value, and the body.
    """
    if not plan.tolerances:
        return
    drawn = np.concatenate([plan.deviations(chunk) for chunk in range(plan.chunks)])
    for k, (name, _) in enumerate(plan.tolerances):
        places = [axis.values for axis in plan.axes if axis.name == name]
        at = np.concatenate(places) if places else np.array([float(mechanism.parameters[name].value)])
        for value in (at.min() + drawn[:, k].min(), at.max() + drawn[:, k].max()):
            _check_value(mechanism, name, value, f"--tolerance: values of {name} reach {value:.6g}")


def has_own_axes(plan: Plan, model: Model) -> bool:
    """Whether all axes are independent coordinates, parameters, or tilt and azimuth in their place."""
    mechanism = model.mechanism
    own = {*independent_labels(model), *mechanism.parameters}
    if quaternion_labels(model) is not None and mechanism.platform is not None:
        own |= {f"{mechanism.platform}.{TILT}", f"{mechanism.platform}.{AZIMUTH}"}
    return all(full_name(mechanism, axis.name) in own for axis in plan.axes)


def _named(plan: Plan, made: Prepared, values: Array) -> NamedCoordinates | None:
    """What is wanted by names that are no independent coordinates; None where these say all."""
    mechanism = made.model.mechanism
    if has_own_axes(plan, made.model):
        return None
    names = [full_name(mechanism, axis.name) for axis in plan.axes]
    wanted = {n: values[:, k] for k, n in enumerate(names) if n not in mechanism.parameters}
    return NamedCoordinates(made.model, made.call, wanted)


def _check_unit(option: str, name: str, typed: str, own: str) -> None:
    """Raises DescriptionError where a unit was typed that is not that of the result or parameter."""
    unit = in_si(own, name)[1] if own else "1"
    if typed and typed != unit:
        wanted = WORDS.get(unit, f"in {unit}")
        raise DescriptionError(f"{option}: {name} is {wanted}; its values are given in {typed}")


def quaternion_labels(model: Model) -> tuple[str, str] | None:
    """Labels of the x and y components of the quaternion among the independent coordinates."""
    labels = independent_labels(model)
    for label in labels:
        if label.endswith(".qx") and label[:-1] + "y" in labels:
            return label, label[:-1] + "y"
    return None


def _wanted(plan: Plan, made: Prepared, values: Array, deviations: Array) -> tuple[Array, Array | None]:
    """Independent coordinates and run-time parameters of the cases."""
    y = np.repeat(reference_coordinates(made.model, made.begin)[None, :], len(values), 0)
    own = f"{made.model.mechanism.platform}."
    column = {axis.name.removeprefix(own): values[:, k] for k, axis in enumerate(plan.axes)}
    column |= {axis.name: values[:, k] for k, axis in enumerate(plan.axes)}
    for name, value in column.items():
        if name in made.labels:
            y[:, made.labels.index(name)] = value
    spherical = quaternion_labels(made.model)
    if TILT in column and spherical is not None:
        azimuth = column.get(AZIMUTH, np.zeros(len(values)))
        x, z = (made.labels.index(label) for label in spherical)
        y[:, x], y[:, z] = (np.sin(column[TILT] / 2) * turn(azimuth) for turn in (np.cos, np.sin))
    base = made.model.system.parameter_values
    if not len(base):
        return y, None
    names = [n for n, p in made.model.mechanism.parameters.items() if p.run_time]
    p = np.repeat(base[None, :], len(values), 0)
    for name, value in column.items():
        if name in names:
            p[:, names.index(name)] = value
    for k, (name, _) in enumerate(plan.tolerances):
        p[:, names.index(name)] += deviations[:, k]
    return y, p


def result_units(model: Model) -> dict[str, str]:
    """Result -> unit, of all that every case has; axes and varied parameters are results as well."""
    units = {"condition": "1", "stiffness least": "N m", "stiffness largest": "N m"} if _moved_by_drives(model) else {}
    port = model.programs["joint_displacements"].outputs[0]
    units |= dict(zip(port.labels, port.units, strict=True))
    if "forward_kinematics" in model.programs:
        port = model.programs["forward_kinematics"].outputs[0]
        units |= {f"point {label}": "m" for label in port.labels if label.rpartition(".")[0] in _moving(model)}
    if "inverse_dynamics" in model.programs:
        port = model.programs["inverse_dynamics"].outputs[0]
        units |= {f"drive {label}": unit for label, unit in zip(port.labels, port.units, strict=True)}
    for kind in ("limb_margins", "constraint_margin", "actuation_margins"):
        if kind in model.programs:
            units |= {f"{kind.split('_')[0]} {n}": "1" for n in model.programs[kind].outputs[0].labels}
            units["margin"] = "1"
    return units | {"reached": "1", "regular": "1", "allowed": "1", "status": "1"}


def _moved_by_drives(model: Model) -> bool:
    """Whether there is a platform whose motion the drives determine, so that it has a condition and a stiffness."""
    named = model.mechanism.platform is not None and "platform_jacobian" in model.programs
    return named and bool(model.system.drives)


def _moving(model: Model) -> set[str]:
    """Points of the description that move."""
    return {name for name, p in model.mechanism.points.items() if p.body != model.mechanism.ground}


def _kinematics(model: Model, call: Call, q: Array, extra: tuple[Array, ...]) -> dict[str, Array]:
    """Displacements of all joints [rad, m] and places of the points that move [m]."""
    port = model.programs["joint_displacements"].outputs[0]
    found = call("joint_displacements", q, *extra)[0][0]
    results = {label: found[:, k] for k, label in enumerate(port.labels)}
    if "forward_kinematics" in model.programs:
        port = model.programs["forward_kinematics"].outputs[0]
        places = call("forward_kinematics", q, *extra)[0][0]
        moving = _moving(model)
        results |= {
            f"point {label}": places[:, k] for k, label in enumerate(port.labels) if label.rpartition(".")[0] in moving
        }
    return results


def _statics(model: Model, call: Call, q: Array, extra: tuple[Array, ...]) -> dict[str, Array]:
    """Forces and torques of the drives that hold the mechanism at rest."""
    if "inverse_dynamics" not in model.programs:
        return {}
    program = model.programs["inverse_dynamics"]
    known = {"q": q, **({"p": extra[0]} if extra else {})}
    given = [known.get(port.name, np.zeros((len(q), port.size))) for port in program.inputs]
    u = call("inverse_dynamics", *given)[0][0]
    return {f"drive {label}": u[:, k] for k, label in enumerate(program.outputs[0].labels)}


def _quality(model: Model, call: Call, q: Array, extra: tuple[Array, ...], *, stiffness: float) -> dict[str, Array]:
    """Condition number and stiffness of the platform's motion, with lengths divided by the characteristic length.

    Twists are those at the platform's tool: at O they would depend on where the mechanism stands in the world. With an
    orthonormal basis Q of the platform's twists (omega ; v/L), drives turn or slide at M y where M = A R^-1:
    A takes independent rates to drive rates, (omega ; v/L) = Q R of them. The condition number is that of M with
    sliding drives divided by L, infinite where R is singular; the stiffness K = M^T diag(k) M has as eigenvalues the
    least and largest stiffness [N m] against a unit of such a twist.
    """
    if not _moved_by_drives(model):
        return {}
    system = model.system
    count, nv = len(q), len(system.tree.v)
    null = _matrix(call, "null_space", (q, *extra), nv) if "null_space" in model.programs else None
    basis = np.repeat(np.eye(nv)[None], count, 0) if null is None else null
    drives = np.stack(
        [call("drive_rates", q, np.ascontiguousarray(basis[:, :, k]), *extra)[0][0] for k in range(basis.shape[2])],
        axis=2,
    )
    twists = _matrix(call, "platform_jacobian", (q, *extra), 6) @ basis
    length = system.length
    twists[:, 3:] += np.cross(twists[:, :3], _tool(model, call, q, extra)[:, :, None], axis=1)
    twists[:, 3:] /= length
    slides = np.array([unit == "m/s" for unit in model.programs["drive_rates"].outputs[0].units])
    good = np.isfinite(twists).all(axis=(1, 2)) & np.isfinite(drives).all(axis=(1, 2))
    condition, least, largest = (np.full(count, np.nan) for _ in range(3))
    if good.any() and twists.shape[2] <= 6:
        _, R = np.linalg.qr(twists[good])
        diagonal = np.abs(np.diagonal(R, axis1=1, axis2=2))
        regular = diagonal.min(axis=1) > SINGULAR * diagonal.max(axis=1)
        place = np.flatnonzero(good)[regular]
        condition[good] = np.inf
        M = drives[place] @ np.linalg.inv(R[regular])
        scaled = M / np.where(slides, length, 1.0)[:, None]
        values = np.linalg.svd(scaled, compute_uv=False)
        if scaled.shape[1] >= scaled.shape[2]:
            condition[place] = values[:, 0] / values[:, -1]
            stiff = np.linalg.svd(M * np.sqrt(np.where(slides, 1.0, length**2) * stiffness)[:, None], compute_uv=False)
            least[place], largest[place] = stiff[:, -1] ** 2, stiff[:, 0] ** 2
    return {"condition": condition, "stiffness least": least, "stiffness largest": largest}


def _tool(model: Model, call: Call, q: Array, extra: tuple[Array, ...]) -> Array:
    """Where the platform's tool is (cases, 3) [m]: its point of that name, else the middle of its joints' points."""
    name, mechanism = tool_name(model), model.mechanism
    if name is not None:
        labels = list(model.programs["forward_kinematics"].outputs[0].labels)
        at = call("forward_kinematics", q, *extra)[0][0]
        return np.asarray(at[:, [labels.index(f"{name}.{axis}") for axis in "xyz"]])
    own = [k for k, j in enumerate(mechanism.joints.values()) if mechanism.platform in (j.parent, j.child)]
    return np.asarray(_matrix(call, "joint_points", (q, *extra), 3)[:, :, own].mean(axis=2))


def _matrix(call: Call, name: str, inputs: tuple[Array, ...], rows: int) -> Array:
    """A function's matrix (cases, rows, columns), which it gives column by column."""
    flat = call(name, *inputs)[0][0]
    return flat.reshape(len(flat), -1, rows).transpose(0, 2, 1).copy()


def _margins(model: Model, call: Call, q: Array, extra: tuple[Array, ...]) -> dict[str, Array]:
    """Every margin at the configuration, by kind and name."""
    results: dict[str, Array] = {}
    for kind in ("limb_margins", "constraint_margin", "actuation_margins"):
        if kind in model.programs:
            values = call(kind, q, *extra)[0][0]
            labels = model.programs[kind].outputs[0].labels
            results |= {f"{kind.split('_')[0]} {label}": values[:, k] for k, label in enumerate(labels)}
    relative = [results[name] / value for name, value in start_margins(model, call).items()]
    if relative:
        results["margin"] = np.min(relative, axis=0)
    return results
