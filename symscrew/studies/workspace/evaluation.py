"""Cases of a sweep: from the values of the axes to all results, by the compiled batch functions.

Plan, numbers --cases_of--> Cases --arrived (walks)--> Arrival --results_at--> results by name
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from symscrew.assembly import configuration_in_mode
from symscrew.description import Mechanism, check_values_of, exact, followed, in_si
from symscrew.errors import DescriptionError
from symscrew.kinematics import BODY_PARTS, coordinate_units, full_name, nearest_names
from symscrew.model import Model
from symscrew.simulation import derived_model
from symscrew.studies.workspace.case_columns import columns_at, result_units
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
    cases = cases_of(plan, made, np.arange(chunk * plan.chunk, min((chunk + 1) * plan.chunk, plan.count)))
    return results_at(plan, made, cases, arrived(plan, made, cases))


@dataclass(frozen=True)
class Cases:
    """Values of the axes (cases, axes), independent coordinates y (cases, ny) and run-time parameters, None of none."""

    values: Array
    y: Array
    p: Array | None

    def __getitem__(self, which: Array) -> Cases:
        """Some of them."""
        return Cases(self.values[which], self.y[which], self.p if self.p is None else self.p[which])


@dataclass(frozen=True)
class Arrival:
    """Configurations q (cases, nq), NaN where none, status (cases), least margins on the way by name (cases)."""

    q: Array
    status: Array
    least: Mapping[str, Array]

    @property
    def reached(self) -> Array:
        """Where the loops close all along the way (cases)."""
        return np.asarray((self.status == 0) & np.isfinite(self.q).all(axis=1))

    @property
    def regular(self) -> Array:
        """Where no margin comes to zero on the way (cases)."""
        passed = [value > 0 for value in self.least.values()]
        return np.asarray(np.all(passed, axis=0)) if passed else np.ones(len(self.q), dtype=bool)


def cases_of(plan: Plan, made: Prepared, numbers: Array) -> Cases:
    """The cases of these numbers."""
    values = plan.values_of(numbers)
    return Cases(values, *_wanted(plan, made, values, plan.deviations_of(numbers)))


def arrived(plan: Plan, made: Prepared, cases: Cases, origin: tuple[Cases, Array] | None = None) -> Arrival:
    """Where the walks to cases end: from the reference, or from other cases with their configurations (cases, nq)."""
    with np.errstate(all="ignore"):
        q, status, least, close = _walked(plan, made, cases, origin)
        return Arrival(q, status, _looked_closer(plan, made, cases, origin, least=least, close=close))


def results_at(plan: Plan, made: Prepared, cases: Cases, at: Arrival, *, around: bool = False) -> dict[str, Array]:
    """All results of cases in their configurations; `around`: whether the ways there were not straight ones."""
    model, call, q = made.model, made.call, at.q
    with np.errstate(all="ignore"):
        extra = (cases.p,) if cases.p is not None else ()
        results = {axis.name: cases.values[:, k] for k, axis in enumerate(plan.axes)}
        if cases.p is not None:
            names = [n for n, q_ in model.mechanism.parameters.items() if q_.run_time]
            results |= {n: cases.p[:, names.index(n)] for n in plan.parameters if n not in results}
        results["status"] = at.status.astype(float)
        results |= columns_at(model, call, q, extra, stiffness=plan.stiffness)
        results["regular"] = at.regular.astype(float)
        results["reached"] = at.reached.astype(float)
        results["around"] = np.full(len(q), float(around))
        fits = at.reached & at.regular
        for name, low, high in plan.limits:
            fits &= (results[name] >= low) & (results[name] <= high)
        results["allowed"] = fits.astype(float)
    return results


def _walked(
    plan: Plan, made: Prepared, cases: Cases, origin: tuple[Cases, Array] | None
) -> tuple[Array, Array, dict[str, Array], Array]:
    named = _named(plan, made, cases.values, None if origin is None else origin[0].values)
    reach = named.reached if named else None
    start = None if origin is None else (origin[1], origin[0].p)
    return walk(
        made.model, made.call, cases.y, cases.p, steps=plan.steps, reach=reach, begin=made.begin, origin=start
    )  # fmt: skip


def _looked_closer(
    plan: Plan,
    made: Prepared,
    cases: Cases,
    origin: tuple[Cases, Array] | None,
    *,
    least: dict[str, Array],
    close: Array,
) -> dict[str, Array]:
    """The least margins (cases,) on the way, of places that look regular at steps between which they may not be.

    Only margins are taken from shorter steps: configurations stay those of the walk.
    """
    found, steps = {name: value.copy() for name, value in least.items()}, plan.steps
    left = np.flatnonzero(close)
    while found and steps * FINER <= FINEST:
        left = left[np.min([value[left] for value in found.values()], axis=0) > 0]
        if not len(left):
            break
        steps *= FINER
        finer = replace(plan, steps=steps)
        _, _, now, close = _walked(finer, made, cases[left], origin and (origin[0][left], origin[1][left]))
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


def _named(plan: Plan, made: Prepared, values: Array, start: Array | None = None) -> NamedCoordinates | None:
    """What is wanted by names that are no independent coordinates; None where these say all.

    `start`: values of the axes where the walks begin; those of the reference if none.
    """
    mechanism = made.model.mechanism
    if has_own_axes(plan, made.model):
        return None
    own = [(k, full_name(mechanism, axis.name)) for k, axis in enumerate(plan.axes)]
    wanted, begun = (
        {n: of[:, k] for k, n in own if n not in mechanism.parameters} if of is not None else {}
        for of in (values, start)
    )
    return NamedCoordinates(made.model, made.call, wanted, begun)


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
