"""Whose proof a certificate is: its equations are derived again from the description that it holds, and compared.

file --description, effects, coordinates--> model --file_equations--> the equations that the file has to have
file, with those equations --certificate_checker--> what is proved of this mechanism
file --start or way--> begins in the reference configuration of the model
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.description import Mechanism, parse_description, to_toml
from symscrew.effects import effect_from_table, effect_to_table
from symscrew.errors import DescriptionError, shorten
from symscrew.model import Model, derive
from symscrew.studies.certificate.certificate_checker import (
    CLAIMED,
    OF_MECHANISM,
    OF_START,
    Equations,
    RefusedError,
    UnreadableError,
    Verdict,
    cells_of,
    check_certificate,
    digest,
    holds_start,
    printable,
    tubes,
)
from symscrew.studies.certificate.file_equations import file_equations
from symscrew.studies.certificate.way_from_reference import follow_way
from symscrew.studies.workspace import quaternion_labels

Array = np.ndarray
OF_WALK = "a walk from the reference configuration to the region kept its branch: no boxes along it were proved"
SHOWN = 5
"""Differences that are named; more say the same."""


@dataclass(frozen=True)
class MechanismProof:
    """What a certificate proves of the mechanism in it.

    `digest`: SHA-256 of the canonical description. `refused`: why it is no proof of this mechanism. `verdict`: of the
    checker, with the equations derived again. `left`: what stays assumed. `asked`: what is held and limited, in words.
    """

    mechanism: str
    digest: str
    refused: tuple[str, ...]
    verdict: Verdict
    left: tuple[str, ...]
    asked: tuple[str, ...] = ()

    @property
    def ok(self) -> bool:
        """Whether the file proves what it claims of this mechanism."""
        return not self.refused and self.verdict.holds

    def __str__(self) -> str:
        lines = [f"{self.mechanism}, description {self.digest}", self.verdict.region, *self.asked]
        lines += [f"REFUSED: {text}" for text in (*self.refused, *self.verdict.refused)]
        lines += [f"proved: {text}" for text in self.verdict.proved] if self.ok else []
        lines += [f"assumed: {text}" for text in self.left] if self.ok else []
        end = "every claim is proved of this mechanism: its equations were derived again"
        lines.append(end if self.ok else "the file is no proof of this mechanism")
        return "\n".join(map(printable, lines))


def is_certificate(values: Any) -> bool:
    """Whether JSON values say that they are a certificate of a workspace."""
    return isinstance(values, Mapping) and str(values.get("format", "")).startswith("symscrew workspace certificate")


def what_was_asked(plan: Any, fixed: Mapping[str, float]) -> dict[str, Any]:
    """Of a plan, what the equations follow from beside the description and the region."""
    return {
        "effects": [json.loads(json.dumps(effect_to_table(effect), default=str)) for effect in plan.effects],
        "independent": None if plan.independent is None else list(plan.independent),
        "limits": [[name, _finite(low), _finite(high)] for name, low, high in plan.limits],
        "fixed": dict(fixed),
    }


def proof_of_mechanism(values: Any, mechanism: Mechanism | None = None) -> MechanismProof:
    """Whether a certificate is one of the mechanism that it describes; of `mechanism`, where that is given.

    Args:
        values: what the JSON file holds.
        mechanism: that has to be the one in the file; its run-time parameters do not matter.

    Raises:
        UnreadableError: it is no certificate.
        DescriptionError: the description in it is none.
    """
    verdict = check_certificate(values)
    try:
        model, own = _model(values)
        text = to_toml(own)
        refused = [*_other(own, mechanism), *_differences(values, model)]
        refused += [] if values["claims"] else ["it claims nothing"]
        left = [text for text in verdict.assumed if text not in (OF_MECHANISM, OF_START)]
        if not refused and begins_elsewhere(values, model):
            left.append(OF_WALK)
        elif not refused:
            refused += _begin(values, model)
    except (KeyError, TypeError, ValueError, IndexError, AttributeError, RecursionError, OverflowError) as error:
        if isinstance(error, DescriptionError):
            raise
        raise UnreadableError(f"{type(error).__name__}: {error}") from error
    return MechanismProof(
        own.name, digest(text), tuple(refused), verdict, tuple(left), _asked_in_words(values["asked"])
    )


def _asked_in_words(asked: Any) -> tuple[str, ...]:
    held = ", ".join(f"{name} = {float(x):.6g}" for name, x in asked["fixed"].items())
    limits = ", ".join(f"{name} from {low} to {high}" for name, low, high in asked["limits"])
    return tuple(f"{word} {text}" for word, text in (("with", held), ("within the limits", limits)) if text)


def _model(values: Any) -> tuple[Model, Mechanism]:
    asked = values["asked"]
    own = parse_description(str(values["mechanism"]["toml"]))
    effects = [effect_from_table(table, "effects of the certificate") for table in asked["effects"]]
    independent = None if asked["independent"] is None else [str(name) for name in asked["independent"]]
    return derive(own, effects, independent=independent), own


def _other(own: Mechanism, mechanism: Mechanism | None) -> list[str]:
    """Whether another mechanism than this was meant, and where the two part."""
    if mechanism is None:
        return []
    texts = [_without_run_time(to_toml(m)) for m in (own, mechanism)]
    if texts[0] == texts[1]:
        return []
    one, two = (text.splitlines() for text in texts)
    parted = next((k for k, (a, b) in enumerate(zip(one, two, strict=False)) if a != b), min(len(one), len(two)))
    shown = [shorten(lines[parted]) if parted < len(lines) else "the end" for lines in (one, two)]
    return [f"it is a proof of another mechanism: {shown[0]} where {mechanism.name} has {shown[1]}"]


def _without_run_time(text: str) -> str:
    return "\n".join(line for line in text.splitlines() if line != "run_time = true")


def _differences(values: Any, model: Model) -> list[str]:
    """Where the equations of the file are not those of the model."""
    asked, region, start = values["asked"], values["region"], values["start"]
    if values["mechanism"]["name"] != model.mechanism.name:
        return [f"it calls itself one of {shorten(values['mechanism']['name'])}"]
    limits = [(str(name), _infinite(low, -1), _infinite(high, 1)) for name, low, high in asked["limits"]]
    known = [c.label for c in model.system.tree.q]
    q = np.array(model.system.reference, dtype=float)
    parameters = [n for n, p in model.mechanism.parameters.items() if p.run_time]
    for name, value in asked["fixed"].items():
        if name in known:
            q[known.index(name)] = value
        elif name not in parameters:
            return [f"it holds {shorten(name)}, which is no coordinate of the mechanism"]
    stated = Equations.read(values["equations"])
    loose = [n for n in asked["fixed"] if n in known and known.index(n) not in stated.held]
    if loose:
        return [f"it says that {shorten(loose[0])} is held, its equations leave it free"]
    for name, value in zip(region["names"], start["z"], strict=True):
        if name in known:
            q[known.index(name)] = value
    if stated.count != len(q):
        return [f"its equations have {stated.count} coordinates, the mechanism has {len(q)}"]
    q[stated.dependent] = start["q"]
    wanted = file_equations(model, region["names"], limits, q)
    wanted["parameters"] = _parameters(model, asked["fixed"])
    found = _parted(json.loads(json.dumps(wanted)), values["equations"], "equations")
    way = values.get("way")
    if not found and way is not None:
        names = [*region["names"], *asked["fixed"]]
        own = file_equations(model, names, (), model.system.reference)
        parts = {name: own[name] for name in way["equations"]}
        found += _parted(json.loads(json.dumps(parts)), way["equations"], "way.equations")
    given = {
        **dict(zip(known, model.system.reference, strict=True)),
        **dict(zip(parameters, model.system.parameter_values, strict=True)),
    }
    nearest = np.clip([float(given[name]) for name in region["names"]], region["low"], region["high"])
    if start["z"] != nearest.tolist():
        found.append("it does not start at the point of its region that is nearest to the reference configuration")
    disk = values["disk"]
    if disk is not None:
        tilting = [region["names"][k] for k in disk["axes"]]
        if tilting != list(quaternion_labels(model) or ()):
            found.append(f"its disk of tilt is over {', '.join(tilting)}")
    return found[:SHOWN]


def _parameters(model: Model, fixed: Mapping[str, float]) -> list[float]:
    names = [n for n, p in model.mechanism.parameters.items() if p.run_time]
    given = dict(zip(names, map(float, model.system.parameter_values), strict=True))
    return [float(fixed.get(name, value)) for name, value in given.items()]


def _parted(wanted: Any, stated: Any, where: str) -> list[str]:
    """Places at which JSON values are not the same."""
    if isinstance(wanted, dict) and isinstance(stated, dict):
        if wanted.keys() != stated.keys():
            return [f"{where}: expected {sorted(wanted)}, got {shorten(sorted(map(str, stated)))}"]
        return [text for key in wanted for text in _parted(wanted[key], stated[key], f"{where}.{key}")]
    if isinstance(wanted, list) and isinstance(stated, list):
        if len(wanted) != len(stated):
            return [f"{where}: expected {len(wanted)} entries, got {len(stated)}"]
        pairs = enumerate(zip(wanted, stated, strict=True))
        return [text for k, (a, b) in pairs for text in _parted(a, b, f"{where}[{k}]")]
    if type(wanted) is type(stated) and wanted == stated:
        return []
    return [f"{where}: the mechanism has {shorten(wanted)}, the file {shorten(stated)}"]


def begins_elsewhere(values: Any, model: Model) -> bool:
    """Whether the start is not at the reference's coordinates and parameters, and the file has no way there."""
    if values.get("way") is not None:
        return False
    q, p = follow_way(values)
    dependent, reference = Equations.read(values["equations"]).dependent, model.system.reference
    given = [k for k in range(len(q)) if k not in dependent]
    return p != [float(x) for x in model.system.parameter_values] or any(q[k] != reference[k] for k in given)


def _begin(values: Any, model: Model) -> list[str]:
    """Why the start, or the way to it, does not begin in the reference configuration."""
    try:
        q, p = follow_way(values)
    except RefusedError as error:
        return [str(error)]
    reference = np.array(model.system.reference, dtype=float)
    equations, box, (low, high, middle) = _first_box(values)
    given = [k for k in range(len(q)) if k not in equations.dependent]
    if p != [float(x) for x in model.system.parameter_values] or any(q[k] != reference[k] for k in given):
        return ["its way begins elsewhere than in the reference configuration"]
    z = np.array([q[k] if kind == "q" else p[k] for kind, k in equations.axes])
    found = tubes(equations, low[:, None], high[:, None], middle[:, None])
    if not holds_start(equations, found, 0, (z, reference[equations.dependent])):
        return [f"box {box}, where it begins, does not hold the reference configuration: it is on another branch"]
    return []


def _first_box(values: Any) -> tuple[Equations, int, tuple[Array, Array, Array]]:
    """(equations without conditions, number, edges and middle) of the box that holds the beginning."""
    way, stated, box = values.get("way"), {**values["equations"], "conditions": []}, 0
    if way is not None:
        parts = [np.array(way[name][0], dtype=float) for name in ("low", "high", "configurations")]
        return Equations.read({**stated, **way["equations"]}), box, (parts[0], parts[1], parts[2])
    cells, box = (
        cells_of(values["region"]["low"], values["region"]["high"], values["splitting"]),
        values["start"]["box"],
    )
    place = np.flatnonzero(cells.kind == CLAIMED)[box]
    middle = np.array(values["configurations"][box], dtype=float)
    return Equations.read(stated), box, (cells.low[:, place], cells.high[:, place], middle)


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _infinite(value: Any, sign: int) -> float:
    return sign * math.inf if value is None else float(value)
