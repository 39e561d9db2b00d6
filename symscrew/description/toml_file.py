"""A mechanism from a TOML file, and back.

    [mechanism]                 name, ground, platform, description, source, characteristic_length
    [parameters.NAME]           value, unit, description, run_time
    [bodies.NAME]               mass, com, inertia
    [joints.NAME]               type, parent, child, point, axes, pitch, driven, reference,
                                child_point, child_axes
    [points.NAME]               body, at
    [couplings.NAME]            terms: coordinate -> factor, or coefficients of its powers
    [limbs.NAME]                type and the options of `limb_letters.plan_limb`, or only joints = [...]

Any number may be a string with an expression of the parameters, or a decimal of any length; both are read
exactly. Keys are fixed: an unknown one is an error.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from decimal import Decimal, Inexact, localcontext
from os import PathLike
from pathlib import Path
from typing import Any

import sympy

from symscrew.description.builder import MechanismBuilder
from symscrew.description.coupled import terms_of
from symscrew.description.expressions import to_text
from symscrew.description.mechanism import Body, Coupling, Joint, Mechanism, Parameter, Vector
from symscrew.errors import DescriptionError, did_you_mean, expect, in_file, shorten

# The reader of TOML descends once per bracket and per dot: beyond these limits a file is refused before it is read.
MAX_BYTES = 1_000_000  # the largest of the catalogue has 14 kB
MAX_NESTING = 40  # brackets within brackets; a description needs four
MAX_KEY_PARTS = 20  # of a dotted key; a description needs three

KINDS = {
    "mechanism": "a mechanism", "bodies": "a mechanism", "joints": "a mechanism", "scene": "a scene",
    "problem": "an optimal motion", "motion": "a given motion",
}  # fmt: skip
"""Sections that only one kind of file has -> what such a file describes."""

KEYS: dict[str, tuple[str, ...]] = {
    "mechanism": ("name", "ground", "platform", "description", "source", "characteristic_length"),
    "parameters": ("value", "unit", "description", "run_time"),
    "bodies": ("mass", "com", "inertia"),
    "joints": (
        "type", "parent", "child", "point", "axes", "pitch", "driven", "reference", "child_point",
        "child_axes",
    ),
    "points": ("body", "at"),
    "couplings": ("terms",),
    "limbs": (
        "type", "base", "tip", "points", "axes", "joints", "bodies", "driven", "pitch", "reference", "mass",
        "com", "inertia", "tip_point",
    ),
}  # fmt: skip

REQUIRED: dict[str, tuple[str, ...]] = {
    "mechanism": ("name",),
    "parameters": ("value",),
    "bodies": (),
    "joints": ("type", "parent", "child", "point"),
    "points": ("body", "at"),
    "couplings": ("terms",),
    "limbs": (),
}

Texts = Mapping[sympy.Expr, str]

_PLAIN = re.compile(r"[+-]?(?:0|[1-9]\d{0,17})(?:\.\d{1,17})?(?:[eE][+-]?\d{1,3})?")
"""Numbers that TOML has itself, and few enough digits that whoever reads doubles loses none that counts."""

_STRUCTURE = re.compile(
    r'"""(?:[^"\\]|\\.|"(?!""))*"{3,5}' + r"|'''(?:[^']|'(?!''))*'{3,5}"
    r'|"(?:[^"\\\n]|\\.)*"' + r"|'[^'\n]*'" + r"|#[^\n]*|[\[\]{}.,=\n]",
    re.DOTALL,
)


def load_description(path: str | Path, *, run_time: Sequence[str] = ()) -> Mechanism:
    """The validated mechanism described by the TOML file at `path`.

    `run_time`: parameters that become run-time inputs, whatever the file says.

    Raises:
        DescriptionError: the file cannot be read or does not describe a mechanism.
    """
    expect(path, str, PathLike)
    file = Path(path)
    try:
        return parse_description(read_text(file), run_time=run_time)
    except DescriptionError as error:
        raise in_file(file.name, error) from error


def read_text(file: Path) -> str:
    """The text of a file that is not too large; raises DescriptionError."""
    try:
        if file.stat().st_size > MAX_BYTES:
            raise DescriptionError(f"the file has {file.stat().st_size} bytes; a description has at most {MAX_BYTES}")
        return file.read_bytes().decode("utf-8")
    except OSError as error:
        raise DescriptionError(f"the file cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise DescriptionError("expected a text file in UTF-8 with a TOML description") from error


def parse_description(text: str, *, run_time: Sequence[str] = ()) -> Mechanism:
    """The validated mechanism that the TOML `text` describes; `run_time` as in `load`; raises DescriptionError."""
    tables = read_tables(text)
    known = tables.get("parameters", {})
    for name in run_time:
        if not isinstance(known, dict) or not isinstance(known.get(name), dict):
            raise DescriptionError(f"parameters: there is no {shorten(name)}; {did_you_mean(name, known)}")
        known[name]["run_time"] = True
    return _build(tables)


def read_tables(text: str) -> dict[str, Any]:
    """The tables of a TOML text, decimals with all their digits; raises DescriptionError."""
    if len(text) > MAX_BYTES:
        raise DescriptionError(f"the description has {len(text)} characters; at most {MAX_BYTES} are read")
    _check_nesting(text)
    try:
        # Decimal keeps every digit; a float would round the file's decimals.
        return tomllib.loads(text, parse_float=Decimal)
    except (tomllib.TOMLDecodeError, ValueError, ArithmeticError) as error:
        raise DescriptionError(f"not a valid TOML file: {shorten(str(error), 200)}") from error
    except RecursionError as error:
        raise DescriptionError(f"the description is nested more than {MAX_NESTING} deep") from error


def _check_nesting(text: str) -> None:
    """Refuses deep nesting and long dotted keys before the TOML reader spends time or stack on them."""
    depth = dots = 0
    for match in _STRUCTURE.finditer(text):
        mark = match.group()
        if mark in ("[", "{"):
            depth += 1
        elif mark in ("]", "}"):
            depth -= 1
        dots = dots + 1 if mark == "." else (0 if mark in ("\n", "=", ",", "[", "]", "{", "}") else dots)
        if depth > MAX_NESTING or dots > MAX_KEY_PARTS:
            raise DescriptionError(
                f"the description is nested more than {max(MAX_NESTING, MAX_KEY_PARTS)} deep near line "
                f"{text.count(chr(10), 0, match.start()) + 1}; a description needs at most 4 levels"
            )


def _build(tables: Mapping[str, Any]) -> Mechanism:
    for section, content in tables.items():
        if section not in KEYS and section in KINDS:
            raise DescriptionError(
                f"this file describes {KINDS[section]}; expected a mechanism, with [mechanism], [bodies] and [joints]"
            )
        if section not in KEYS:
            raise DescriptionError(f"unknown section {shorten(section)}; {did_you_mean(section, KEYS)}")
        _check_table(section, content)
    if "mechanism" not in tables:
        raise DescriptionError("the section [mechanism] is missing; expected at least its name")
    _check_keys("mechanism", "mechanism", tables["mechanism"])
    builder = MechanismBuilder(**tables["mechanism"])
    # Limbs come last: their bodies and joints follow those that are written out.
    makers = {
        "parameters": builder.parameter,
        "bodies": builder.body,
        "joints": builder.joint,
        "points": builder.point,
        "couplings": builder.coupling,
        "limbs": builder.limb,
    }
    for section, make in makers.items():
        for name, values in tables.get(section, {}).items():
            _check_table(f"{section}.{shorten(name)}", values)
            _check_keys(section, f"{section}.{name if name.isidentifier() else shorten(name)}", values)
            make(name, **values)  # type: ignore[operator]
    return builder.build()


def _check_table(where: str, value: Any) -> None:
    if not isinstance(value, dict):
        raise DescriptionError(f"{where}: expected a table, got {shorten(value)}")


def _check_keys(section: str, where: str, values: Mapping[str, Any]) -> None:
    for key in values:
        if key not in KEYS[section]:
            raise DescriptionError(f"{where}: unknown key {shorten(key)}; {did_you_mean(key, KEYS[section])}")
    for key in REQUIRED[section]:
        if key not in values:
            raise DescriptionError(f"{where}: the key {key!r} is missing")


def to_toml(mechanism: Mechanism) -> str:
    """TOML text that describes `mechanism` exactly, numbers as they were given: `loads(dumps(m)) == m`."""
    written = mechanism.written
    head = {"name": mechanism.name, "ground": mechanism.ground}
    for key in ("platform", "description", "source"):
        if getattr(mechanism, key):
            head[key] = getattr(mechanism, key)
    entries = {key: _quote(value) for key, value in head.items()}
    if mechanism.characteristic_length is not None:
        entries["characteristic_length"] = _number(mechanism.characteristic_length, written)
    blocks = [_block("mechanism", entries)]
    blocks += [_block(f"parameters.{p.name}", _parameter(p, written)) for p in mechanism.parameters.values()]
    blocks += [
        _block(f"bodies.{body.name}", _body(body, written))
        for body in mechanism.bodies.values()
        if body != Body(mechanism.ground)
    ]
    blocks += [_block(f"joints.{joint.name}", _joint(joint, written)) for joint in mechanism.joints.values()]
    blocks += [
        _block(f"points.{point.name}", {"body": _quote(point.body), "at": _vector(point.at, written)})
        for point in mechanism.points.values()
    ]
    blocks += [
        _block(f"couplings.{coupling.name}", {"terms": _terms(mechanism, coupling)})
        for coupling in mechanism.couplings.values()
    ]
    blocks += [
        _block(f"limbs.{limb.name}", {"joints": "[" + ", ".join(map(_quote, limb.joints)) + "]"})
        for limb in mechanism.limbs.values()
    ]
    return "\n".join(blocks)


def _block(header: str, entries: Mapping[str, str]) -> str:
    return f"[{header}]\n" + "".join(f"{key} = {value}\n" for key, value in entries.items())


def _parameter(parameter: Parameter, written: Texts) -> dict[str, str]:
    value = parameter.value if parameter.formula is None else parameter.formula
    entries = {"value": _number(value, written), "unit": _quote(parameter.unit)}
    if parameter.description:
        entries["description"] = _quote(parameter.description)
    if parameter.run_time:
        entries["run_time"] = "true"
    return entries


def _body(body: Body, written: Texts) -> dict[str, str]:
    entries = {}
    if body.mass is not None:
        entries["mass"] = _number(body.mass, written)
    if body.com is not None:
        entries["com"] = _vector(body.com, written)
    if body.inertia is not None:
        entries["inertia"] = "[" + ", ".join(_vector(row, written) for row in body.inertia) + "]"
    return entries


def _joint(joint: Joint, written: Texts) -> dict[str, str]:
    entries = {key: _quote(getattr(joint, key)) for key in ("type", "parent", "child")}
    entries["point"] = _vector(joint.point, written)
    if joint.axes:
        entries["axes"] = "[" + ", ".join(_vector(axis, written) for axis in joint.axes) + "]"
    if joint.pitch is not None:
        entries["pitch"] = _number(joint.pitch, written)
    if joint.driven:
        entries["driven"] = str(list(joint.driven))
    if joint.reference:
        entries["reference"] = "[" + ", ".join(_number(value, written) for value in joint.reference) + "]"
    return entries


def _terms(mechanism: Mechanism, coupling: Coupling) -> str:
    parts = []
    for label, numbers in terms_of(coupling, mechanism.joints).items():
        parts.append(f"{_quote(label)} = [{', '.join(_number(x, mechanism.written) for x in numbers)}]")
    return "{ " + ", ".join(parts) + " }"


def _number(value: sympy.Expr, written: Texts) -> str:
    """As it was given, else exactly: 0.45 for 9/20, and an expression where there is no such decimal."""
    text = written.get(value) or (_decimal(value) if value.is_Rational else "") or to_text(value)
    if _PLAIN.fullmatch(text):
        text = str(Decimal(text))  # which is how it is read: writing what was read changes nothing
    return text if _PLAIN.fullmatch(text) else _quote(text)


def _decimal(value: sympy.Rational) -> str:
    """The decimal that a fraction is exactly, or nothing."""
    with localcontext(prec=17) as context:
        context.clear_flags()  # those of whatever the process has divided before
        found = Decimal(int(value.p)) / Decimal(int(value.q))
        return "" if context.flags[Inexact] else str(found)


def _vector(vector: Vector, written: Texts) -> str:
    return "[" + ", ".join(_number(entry, written) for entry in vector) + "]"


def _quote(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t")
    return f'"{escaped}"'
