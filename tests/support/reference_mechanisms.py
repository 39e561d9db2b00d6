"""Mechanisms of `data/mobility.json` through the public API, and the same mechanism written differently."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import sympy

from symscrew.description.builder import MechanismBuilder
from symscrew.description.expressions import parse
from symscrew.description.mechanism import Mechanism
from symscrew.description.names import RESERVED

DATA = Path(__file__).parents[1] / "data" / "mobility.json"


def entries() -> Iterator[tuple[str, dict[str, Any]]]:
    """(name, entry) of all mechanisms; a variant is an entry with its own joints and expected values."""
    for mechanism in json.loads(DATA.read_text())["mechanisms"]:
        yield mechanism["id"], mechanism
        for variant in mechanism["variants"]:
            yield f"{mechanism['id']}-{variant['id']}", {**mechanism, **variant}


ENTRIES = dict(entries())


def name_of(text: str) -> str:
    """A name that a description allows."""
    name = re.sub(r"\W", "_", text)
    return f"b_{name}" if name in RESERVED or not name[0].isalpha() else name


def joints_of(entry: dict[str, Any]) -> list[dict[str, Any]]:
    """The joints with exact numbers, as keywords of `MechanismBuilder.joint`."""
    driven: dict[str, list[int]] = {}
    for joint, index in entry["expected"].get("drives") or []:
        driven.setdefault(joint, []).append(index)
    result = []
    for joint in entry["joints"]:
        exact = {key: _parsed(joint[key]) for key in ("point", "axes", "pitch") if joint.get(key) is not None}
        result.append(
            {
                "name": name_of(joint["name"]),
                "type": joint["type"],
                "parent": name_of(joint["parent"]),
                "child": name_of(joint["child"]),
                "driven": driven.get(joint["name"], False),
                "point": [sympy.Integer(0)] * 3,
                **exact,
            }
        )
    return result


def _parsed(value: Any) -> Any:
    return [_parsed(v) for v in value] if isinstance(value, list) else parse(str(value))


def build(
    entry: dict[str, Any], change: Callable[[list[dict[str, Any]]], list[dict[str, Any]]] | None = None
) -> Mechanism:
    """The mechanism of an entry; `change` rewrites the list of its joints."""
    joints = joints_of(entry)
    if change is not None:
        joints = change(joints)
    ground, platform = name_of(entry["ground"]), name_of(entry["end_effector"])
    builder = MechanismBuilder("reference", ground=ground, platform=platform)
    for body in entry["bodies"]:
        if body != entry["ground"]:
            builder.body(name_of(body))
    for joint in joints:
        options = {key: value for key, value in joint.items() if key not in ("name", "type")}
        if not options.get("axes"):
            options.pop("axes", None)
        builder.joint(joint["name"], joint["type"], **options)
    for k, names in enumerate(entry.get("limbs", [])):
        builder.limb(f"limb{k + 1}", joints=[name_of(name) for name in names])
    return builder.build()
