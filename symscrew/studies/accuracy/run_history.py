"""Reference histories of scenes, with the accuracy that is asked for and measured points of other engines.

A file `<scene>.reference.json` beside the scene's:

    problem, source, method, verification   texts
    error                                   the history's own error
    stated                                  {"text": ..., "value": error to be reached}, or null
    columns                                 [{"coordinate": LABEL, "scale": 1}, {"point": NAME, "axis": 0}, ...]
    times, values                           outputs at equal distances from 0, and a row of the columns' values for each
    measure                                 "largest" (default) or "rms"
    peers                                   {engine: {error: seconds of the whole run}}, and peers_text
    further_peers                           a text on points of peers on a variant of the problem
    published                               [{"text": ..., "error": number or null, "seconds": number}]
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.description import read_text
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.model import Model
from symscrew.studies.accuracy.measuring import Point
from symscrew.studies.timing import quartiles

Array = np.ndarray


@dataclass(frozen=True)
class Reference:
    """A reference history; see the module."""

    problem: str
    text: str
    own_error: float | None
    stated: float | None
    columns: tuple[Mapping[str, Any], ...]
    times: Array
    values: Array
    measure: str
    peers: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    published: tuple[Mapping[str, Any], ...] = ()

    @property
    def levels(self) -> tuple[float, ...]:
        """The errors for which peers were measured."""
        found = {float(e) for points in self.peers.values() for e in points}
        return tuple(sorted(found, reverse=True)) or (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)

    @property
    def error_label(self) -> str:
        """What is compared."""
        kinds = {kind: [str(c[kind]) for c in self.columns if kind in c] for kind in ("coordinate", "point")}
        named = [(kind, list(dict.fromkeys(names))) for kind, names in kinds.items() if names]
        what = " and ".join(f"{kind}{'s' * (len(names) > 1)} {', '.join(names)}" for kind, names in named)
        kind = "root mean square" if self.measure == "rms" else "largest"
        return f"{kind} error of {what if len(what) < 45 else 'all outputs'} [rad, m]"

    def error_of(self, model: Model) -> Callable[[Array], float]:
        """The error of q (n, nq) at all times of the reference."""
        labels = [c.label for c in model.system.tree.q]
        points = list(model.mechanism.points)
        for column in self.columns:
            key, known = ("coordinate", labels) if "coordinate" in column else ("point", points)
            if column.get(key) not in known:
                raise DescriptionError(
                    f"reference: there is no {key} {column.get(key)!r}; {did_you_mean(str(column.get(key)), known)}"
                )

        def values_of(q: Array) -> Array:
            places = None
            found = []
            for column in self.columns:
                scale = float(column.get("scale", 1.0))
                if "coordinate" in column:
                    found.append(scale * q[:, labels.index(column["coordinate"])])
                    continue
                if places is None:
                    arrays = [q] + [
                        np.repeat(model.system.parameter_values[None], len(q), 0)
                        for p in model.programs["forward_kinematics"].inputs[1:]
                    ]
                    places = model("forward_kinematics", *arrays)[0][0].reshape(len(q), -1, 3)
                found.append(scale * places[:, points.index(column["point"]), int(column["axis"])])
            return np.stack(found, 1)

        def error(q: Array) -> float:
            off = np.abs(values_of(q) - self.values)
            return float(np.sqrt((off**2).sum(axis=1).mean())) if self.measure == "rms" else float(off.max())

        return error

    def peer_points(self, duration: float) -> tuple[Point, ...]:
        """Points of peers and published ones that state error and time, seconds per simulated second."""
        rows = [
            (engine, "as measured", float(error), seconds)
            for engine, points in self.peers.items()
            for error, seconds in points.items()
        ]
        for entry in self.published:
            if entry.get("error") and entry.get("seconds"):
                rows.append(("published", str(entry["text"]).split(":")[0], entry["error"], entry["seconds"]))
        facts = {"peer": True, "family": "peers"}
        return tuple(Point(who, how, e, quartiles([s / duration]), "", facts) for who, how, e, s in rows)

    def published_table(self) -> tuple[tuple[str, str, str], list[list[str]]]:
        """What others published, as they state it."""
        rows = []
        for entry in self.published:
            numbers = [("-" if entry.get(key) is None else f"{entry[key]:.3g}") for key in ("error", "seconds")]
            rows.append([str(entry["text"]), *numbers])
        return ("published", "error", "time of the run [s]"), rows


def read_reference(scene: Path) -> Reference | None:
    """The reference beside a scene's file, None where there is none."""
    path = scene.with_name(f"{scene.stem}.reference.json")
    if not path.is_file():
        return None
    try:
        content = json.loads(read_text(path))
        stated = content.get("stated") or {}
        reference = Reference(
            str(content["problem"]),
            f"{content['method']} Verification: {content['verification']}; error",
            None if content.get("error") is None else float(content["error"]),
            None if stated.get("value") is None else float(stated["value"]),
            tuple(content["columns"]),
            np.array(content["times"], dtype=float),
            np.array(content["values"], dtype=float),
            str(content.get("measure", "largest")),
            {str(k): {str(e): float(s) for e, s in v.items()} for k, v in content.get("peers", {}).items()},
            _notes(content, stated),
            tuple({"text": str(p["text"]), **p} for p in content.get("published", ())),
        )
    except (KeyError, TypeError, ValueError, AttributeError, OSError, RecursionError) as error:
        raise DescriptionError(f"{path.name}: not a reference history: {error}") from error
    if reference.values.shape != (len(reference.times), len(reference.columns)) or len(reference.times) < 2:
        raise DescriptionError(f"{path.name}: expected as many rows as times and as many columns as are named")
    return reference


def _notes(content: Mapping[str, Any], stated: Mapping[str, Any]) -> tuple[str, ...]:
    source = content.get("source", "")
    lines = [f"Problem: {content['problem']}. Source: {source if isinstance(source, str) else '; '.join(source)}."]
    if stated.get("text"):
        lines.append(f"Stated accuracy: {stated['text']}.")
    if content.get("peers_text"):
        lines.append(f"Peers: {content['peers_text']}")
    if content.get("further_peers"):
        lines.append(str(content["further_peers"]))
    return tuple(lines)
