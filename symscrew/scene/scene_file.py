"""A scene from a TOML file.

    [scene]        name, mechanism (a catalogue name, or a file beside the scene's), description, duration [s],
                   rate (outputs per second), reactions (whether to record them)
    [initial]      coordinates = {NAME = value, ...}, rates = {LABEL = value, ...}, hold = [LABELS]: the given values
                   that are kept while the others are put onto the loops (all are kept without it); a coordinate of any
                   joint or of the platform's pose, values with units ("30deg") or in rad and m, rates by the same
                   names or by labels of v ("2deg/s"); mode = NAME of an assembly mode with these values (`symscrew
                   assemble` lists them)
    [[effects]]    type and the effect's own keys (`symscrew.effects`)
    [parameters]   NAME = value of a run-time parameter, in SI units or with its unit ("200 mm")
    [tables.NAME]  times, values, interpolation ("linear" or "cubic")
    [signals]      NAME = expression, for use in later ones
    [states.NAME]  rate = expression, initial: a state of the controller
    [drives]       LABEL of u = expression; drives that are not named are 0
    [inputs]       PORT = [expressions]: inputs of effects, such as load_<point>
    [integrator]   method, tolerance, step, longest_step, most_steps

Expressions are read by the package's own grammar; they know t, q_LABEL and v_LABEL (dots of a label become _,
or __ where a joint is called so), the parameters, and the scene's tables, signals and states. Numbers may be such
texts in the parameters alone.
Keys are fixed: an unknown one is an error. No gravity acts unless a scene says so.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from decimal import Decimal
from os import PathLike
from pathlib import Path
from typing import Any

from symscrew import catalogue
from symscrew.description import (
    CONSTANTS,
    FUNCTIONS,
    Mechanism,
    check_keys,
    check_name,
    check_sections,
    check_text,
    exact,
    from_file,
    given_value,
    numeric,
    parameter_units,
    read_tables,
)
from symscrew.effects import check_effects, effect_from_table
from symscrew.errors import DescriptionError, did_you_mean, expect, shorten
from symscrew.kinematics import coordinate_units, full_name, typable_names
from symscrew.scene.contents import INTERPOLATIONS, Initial, Integrator, Scene, Table
from symscrew.scene.integration_methods import INTEGRATION_METHODS

# sections and their keys, as people write them
KEYS: dict[str, tuple[str, ...]] = {
    "scene": ("name", "mechanism", "description", "duration", "rate", "reactions"),
    "initial": ("coordinates", "rates", "hold", "mode"),
    "integrator": ("method", "tolerance", "step", "longest_step", "most_steps"),
}
SECTIONS = (*KEYS, "effects", "parameters", "tables", "signals", "states", "drives", "inputs")
MOST_OUTPUTS = 2_000_000  # some GB with forty coordinates; a scene that asks for more is refused
LONGEST_TABLE = 100_000  # its pieces become constant data of a C file; a longer one is refused
RESERVED = ("t", "x", "u", "s", "p", "work")  # names of expressions and of the last state, not for signals


def load_scene(path: str | Path) -> Scene:
    """The scene that the TOML file at `path` describes.

    Raises:
        DescriptionError: the file cannot be read, or says where and what is wrong in it, and the cure.
    """
    expect(path, str, PathLike)
    return from_file(path, parse_scene)


def parse_scene(text: str, *, folder: Path | None = None, name: str = "scene") -> Scene:
    """The scene that a TOML text describes; files it names are looked for in `folder`.

    `name`: what the scene is called where its text does not say.

    Raises:
        DescriptionError: it says where and what is wrong in the text, and the cure.
    """
    tables = read_tables(text)
    check_sections(tables, SECTIONS, KEYS, ("effects",))
    if "scene" not in tables:
        raise DescriptionError("the section [scene] is missing; expected at least mechanism and duration")
    head = tables["scene"]
    mechanism = _mechanism(head, folder)
    read = _Reader(mechanism)
    parameters = _parameters(tables.get("parameters", {}), mechanism, read)
    read.names = mechanism.values({name: exact(value) for name, value in parameters.items()})
    effects = tuple(effect_from_table(t, f"effects[{k}]") for k, t in enumerate(tables.get("effects", ())))
    check_effects(mechanism, effects)
    duration = read.number(_needed(head, "duration", "scene"), "scene.duration", above=0)
    rate = read.number(head.get("rate", 100), "scene.rate", above=0)
    if duration * rate > MOST_OUTPUTS:
        raise DescriptionError(f"scene.rate: {duration * rate:.3g} outputs; at most {MOST_OUTPUTS} are written")
    reactions = head.get("reactions", False)
    if not isinstance(reactions, bool):
        raise DescriptionError(f"scene.reactions: expected true or false, got {shorten(reactions)}")
    signals = _texts(tables.get("signals", {}), "signals")
    time_tables = {n: _table(n, t, read) for n, t in tables.get("tables", {}).items()}
    states = {n: _state(n, t, read) for n, t in tables.get("states", {}).items()}
    _check_names(mechanism, signals, time_tables, states)
    return Scene(
        name=check_name(head.get("name", name if name.isidentifier() else "scene"), "scene.name"),
        mechanism=mechanism,
        effects=effects,
        duration=duration,
        rate=rate,
        initial=_initial(tables.get("initial", {}), read, mechanism),
        drives=_texts(tables.get("drives", {}), "drives", labels=True),
        signals=signals,
        tables=time_tables,
        states=states,
        inputs={n: _several(v, f"inputs.{n}") for n, v in tables.get("inputs", {}).items()},
        parameters=parameters,
        integrator=_integrator(tables.get("integrator", {}), read),
        reactions=reactions,
        description=check_text(head.get("description", ""), "scene.description"),
        text=text,
    )


def _mechanism(head: Mapping[str, Any], folder: Path | None) -> Mechanism:
    name = _needed(head, "mechanism", "scene")
    if not isinstance(name, str):
        raise DescriptionError(f"scene.mechanism: expected a name or a file, got {shorten(name)}")
    if name in catalogue.names():
        return catalogue.load(name)
    if "\0" in name or (Path(name).suffix == "" and folder is None):
        return catalogue.find(name)
    path = Path(name) if folder is None else folder / name
    return catalogue.find(path if path.suffix else name)


class _Reader:
    """Numbers of a scene, as expressions in the mechanism's parameters at their values."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.names = mechanism.values()

    def quantity(self, value: Any, where: str, unit: str | None) -> tuple[float, str]:
        """A coordinate in its unit, given with one or without, and what is said of a bare angle."""
        if unit is None:
            return self.number(value, where), ""
        given = given_value(value, self.names, where=where)
        return self.number(given.measured_in(unit, where), where), given.notice(unit, where)

    def number(self, value: Any, where: str, *, above: float | None = None, least: float | None = None) -> float:
        number = float(numeric(exact(value, self.names, where=where), where=where))
        if not math.isfinite(number):
            raise DescriptionError(f"{where}: expected a finite number, got {shorten(value)}")
        if above is not None and not number > above:
            raise DescriptionError(f"{where}: expected a number above {above:g}, got {shorten(value)}")
        if least is not None and not number >= least:
            raise DescriptionError(f"{where}: expected at least {least:g}, got {shorten(value)}")
        return number


def _needed(table: Mapping[str, Any], key: str, where: str) -> Any:
    if key not in table:
        raise DescriptionError(f"{where}: the key {key!r} is missing")
    return table[key]


def _texts(table: Mapping[str, Any], where: str, *, labels: bool = False) -> dict[str, str]:
    """Expressions by name; a dotted label may come as nested tables (`leg_U.0 = ...`)."""
    result: dict[str, str] = {}
    for name, value in table.items():
        if isinstance(value, dict) and labels:
            result |= {f"{name}.{k}": v for k, v in _texts(value, f"{where}.{name}", labels=True).items()}
            continue
        if not labels:
            check_name(name, where)
        result[name] = _text(value, f"{where}.{name}")
    return result


def _text(value: Any, where: str) -> str:
    if isinstance(value, bool) or not isinstance(value, str | int | float | Decimal):
        raise DescriptionError(f"{where}: expected an expression or a number, got {shorten(value)}")
    if not isinstance(value, str) and not math.isfinite(value):
        raise DescriptionError(f"{where}: expected a finite number, got {shorten(value)}")
    return str(value)


def _several(value: Any, where: str) -> tuple[str, ...]:
    if isinstance(value, dict):
        raise DescriptionError(f"{where}: expected an expression or a list of expressions, got a table")
    values = value if isinstance(value, list) else [value]
    return tuple(_text(v, f"{where}[{k}]") for k, v in enumerate(values))


def _numbers(value: Any, where: str, read: _Reader) -> tuple[float, ...]:
    if not isinstance(value, list):
        raise DescriptionError(f"{where}: expected a list of numbers, got {shorten(value)}")
    if len(value) > LONGEST_TABLE:
        raise DescriptionError(f"{where}: expected at most {LONGEST_TABLE} numbers, got {len(value)}")
    return tuple(read.number(v, f"{where}[{k}]") for k, v in enumerate(value))


def _table(name: str, table: Any, read: _Reader) -> Table:
    where = f"tables.{check_name(name, 'tables')}"
    check_keys(where, table, ("times", "values", "interpolation"))
    times, values = (_numbers(_needed(table, key, where), f"{where}.{key}", read) for key in ("times", "values"))
    if len(times) != len(values) or len(times) < 2:
        raise DescriptionError(
            f"{where}: expected as many values as times, at least 2, got {len(values)}, {len(times)}"
        )
    for k in range(1, len(times)):
        if not times[k] > times[k - 1]:
            raise DescriptionError(f"{where}.times: expected ascending times, got {times[k]:g} after {times[k - 1]:g}")
    kind = table.get("interpolation", "linear")
    if kind not in INTERPOLATIONS:
        raise DescriptionError(f"{where}.interpolation: expected 'linear' or 'cubic', got {shorten(kind)}")
    return Table(name, times, values, kind)


def _state(name: str, table: Any, read: _Reader) -> tuple[str, float]:
    where = f"states.{check_name(name, 'states')}"
    check_keys(where, table, ("rate", "initial"))
    rate = _text(_needed(table, "rate", where), f"{where}.rate")
    return rate, read.number(table.get("initial", 0), f"{where}.initial")


def _check_names(mechanism: Mechanism, *groups: Mapping[str, Any]) -> None:
    taken = {*mechanism.parameters, *FUNCTIONS, *CONSTANTS, *RESERVED}
    for name in (name for group in groups for name in group):
        if name in taken or name.startswith(("q_", "v_")):
            raise DescriptionError(
                f"the name {name!r} is taken (a parameter, function, coordinate, or another signal, table or state); "
                "use another one"
            )
        taken.add(name)


def _initial(table: Mapping[str, Any], read: _Reader, mechanism: Mechanism) -> Initial:
    units, notices = coordinate_units(mechanism), list[str]()

    def values(key: str, per: str) -> dict[str, float]:
        content = table.get(key, {})
        if not isinstance(content, dict):
            raise DescriptionError(f"initial.{key}: expected a table of labels and numbers, got {shorten(content)}")
        flat: dict[str, float] = {}

        def visit(prefix: str, part: Mapping[str, Any]) -> None:
            for name, value in part.items():
                label = f"{prefix}{name}"
                if isinstance(value, dict):
                    visit(f"{label}.", value)
                    continue
                unit = units.get(full_name(mechanism, label))
                try:
                    flat[label], notice = read.quantity(value, f"initial.{key}.{label}", unit and f"{unit}{per}")
                except DescriptionError as error:
                    if unit is not None:
                        raise
                    near = did_you_mean(label, typable_names(mechanism))
                    raise DescriptionError(f"{error}; {shorten(label)} is no coordinate with a unit, {near}") from error
                notices.extend([notice] if notice else [])

        visit("", content)
        return flat

    coordinates, rates, hold = values("coordinates", ""), values("rates", "/s"), table.get("hold")
    mode = table.get("mode", "")
    if not isinstance(mode, str) or (mode and hold is not None):
        raise DescriptionError(f"initial.mode: expected the name of a mode, without hold, got {shorten(mode)}")
    if hold is None:
        return Initial(coordinates, rates, notices=tuple(notices), mode=mode)
    if not isinstance(hold, list) or not all(isinstance(label, str) for label in hold):
        raise DescriptionError(f"initial.hold: expected a list of labels, got {shorten(hold)}")
    for label in hold:
        if label not in coordinates and label not in rates:
            raise DescriptionError(
                f"initial.hold: {shorten(label)} has no value to keep in initial.coordinates or initial.rates; "
                f"{did_you_mean(label, [*coordinates, *rates])}"
            )
    return Initial(coordinates, rates, tuple(hold), tuple(notices))


def _parameters(table: Mapping[str, Any], mechanism: Mechanism, read: _Reader) -> dict[str, float]:
    known = [p.name for p in mechanism.parameters.values() if p.run_time]
    for name in table:
        if name not in known:
            raise DescriptionError(
                f"parameters: {shorten(name)} is no run-time parameter of {mechanism.name}; {did_you_mean(name, known)}"
            )
    units = parameter_units(mechanism.parameters, table)
    return {name: read.quantity(value, f"parameters.{name}", units[name])[0] for name, value in table.items()}


def _integrator(table: Mapping[str, Any], read: _Reader) -> Integrator:
    method = table.get("method", "dop853")
    if not isinstance(method, str) or method not in INTEGRATION_METHODS:
        near = did_you_mean(str(method)[:20], INTEGRATION_METHODS)
        raise DescriptionError(f"integrator.method: unknown method {shorten(method)}; {near}")
    step = None
    if INTEGRATION_METHODS[method].fixed_step:
        if "step" not in table:
            raise DescriptionError(f"integrator: the method {method} needs the key 'step' [s]")
        if "tolerance" in table:
            raise DescriptionError(f"integrator.tolerance: {method} has a fixed step and no tolerance; leave it out")
        step = read.number(table["step"], "integrator.step", above=0)
    elif "step" in table:
        raise DescriptionError(f"integrator.step: {method} chooses its steps; expected 'tolerance' or 'longest_step'")
    tolerance = read.number(table.get("tolerance", "1e-8"), "integrator.tolerance", above=0)
    if not 1e-13 <= tolerance <= 0.1:  # below it rounding decides, above it nothing is left of the motion
        raise DescriptionError(f"integrator.tolerance: expected 1e-13 to 0.1, got {tolerance:g}")
    longest = table.get("longest_step")
    longest = None if longest is None else read.number(longest, "integrator.longest_step", above=0)
    most = table.get("most_steps", 10_000_000)
    if isinstance(most, bool) or not isinstance(most, int) or most < 1:
        raise DescriptionError(f"integrator.most_steps: expected a whole number of steps, got {shorten(most)}")
    return Integrator(method, tolerance, step, longest, most)
