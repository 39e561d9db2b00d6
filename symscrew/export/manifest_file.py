"""What `manifest.json` says: functions, ports, effects and parameters of generated code, and how to read it.

The manifest is enough to call the generated code and, with `mechanism.toml`, to generate it again.
"""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from symscrew import __version__
from symscrew.description import characteristic_length
from symscrew.effects import Effect, effect_from_table, effect_to_table
from symscrew.errors import DescriptionError
from symscrew.export.c_form import USUAL_FORM, Form
from symscrew.export.c_precision import PRECISIONS
from symscrew.export.conventions import conventions, stack
from symscrew.export.listing import model_hash, statuses
from symscrew.model import Model
from symscrew.program import Iteration, Port, Program

TOOL = "symscrew"
LARGEST = 64_000_000  # bytes of a file that is read: what is longer is no manifest, and would fill the memory


class OutputError(ValueError):
    """A directory that does not hold what the tool wrote: says what was expected, what came and the cure."""


def manifest(
    model: Model, *, targets: Sequence[str], files: Sequence[str], precision: str = "double", form: Form = USUAL_FORM
) -> dict[str, Any]:
    """The content of `manifest.json`."""
    return {
        "tool": TOOL,
        "version": __version__,
        "mechanism": model.name,
        "description": getattr(model.mechanism, "description", ""),
        "hash": model_hash(model),
        "effects": [effect_to_json(effect) for effect in model.effects],
        "independent": list(model.independent),
        **({"one_mode": True} if model.one_mode else {}),
        **({"selected": True} if model.selected else {}),
        "parameters": _parameters(model),
        "characteristic_length": _characteristic_length(model),
        "notes": list(model.notes),
        "conventions": conventions(model),
        "stack": stack(model, PRECISIONS[precision], batches=form.batches),
        **({"precision": precision} if precision != "double" else {}),
        **({"one_file": True} if form.one_file else {}),
        **({} if form.batches else {"batches": False}),
        "targets": list(targets),
        "files": sorted(files),
        "functions": {name: _function(model, name, program) for name, program in model.programs.items()},
    }


def read_form(content: Mapping[str, Any]) -> Form:
    """The form of the C of a folder with this manifest."""
    return Form(one_file=content.get("one_file") is True, batches=content.get("batches") is not False)


def _characteristic_length(model: Model) -> dict[str, Any]:
    """By what norms and thresholds of mixed quantities divide lengths, and whether the description chose it."""
    chosen = model.mechanism.characteristic_length is not None
    return {
        "value": characteristic_length(model.mechanism),
        "unit": "m",
        "source": "description" if chosen else "default",
    }


def _parameters(model: Model) -> dict[str, Any]:
    parameters = getattr(model.mechanism, "parameters", {})
    return {
        p.name: {
            "value": float(model.mechanism.number(p.value)),
            "unit": p.unit,
            "description": p.description,
            "run_time": p.run_time,
        }
        for p in parameters.values()
    }


def _function(model: Model, name: str, program: Program | Iteration) -> dict[str, Any]:
    symbol = f"{model.name}_{name}"
    return {
        "symbol": symbol,
        "batch_symbol": f"{symbol}_batch",
        "batch_soa_symbol": f"{symbol}_batch_soa",
        "kind": "iteration" if isinstance(program, Iteration) else "straight-line",
        "hash": program.hash,
        "description": program.description,
        "inputs": [_port(port) for port in program.inputs],
        "outputs": [_port(port) for port in program.outputs],
        "status": {str(code): text for code, text in statuses(program).items()},
        "notes": list(program.notes),
    }


def _port(port: Port) -> dict[str, Any]:
    units: str | list[str] = list(port.units)
    if len(set(port.units)) <= 1:
        units = port.units[0] if port.units else "1"
    return {
        "name": port.name,
        "shape": list(port.shape),
        "unit": units,
        "labels": list(port.labels),
        "description": port.description,
    }


def read_port(entry: Mapping[str, Any]) -> Port:
    """A port from its entry in the manifest."""
    shape = tuple(int(n) for n in entry["shape"])
    port = Port(str(entry["name"]), shape, (), tuple(entry["labels"]), str(entry["description"]))
    unit = entry["unit"]
    units = (unit,) * port.size if isinstance(unit, str) else tuple(unit)
    return dataclasses.replace(port, units=units)


def read_json(path: Path) -> Any:
    """The content of a JSON file of at most 64 MB.

    Raises:
        OutputError: it cannot be read, is larger, or is no JSON; names the file.
    """
    try:
        if path.stat().st_size > LARGEST:
            raise OutputError(f"{path}: expected at most {LARGEST} bytes, got {path.stat().st_size}")
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise OutputError(f"{path}: cannot be read ({error.strerror}); expected output of {TOOL} generate") from error
    except (ValueError, RecursionError) as error:
        raise OutputError(f"{path}: not valid JSON ({error}); generate it again") from error


def effect_to_json(effect: Effect) -> dict[str, Any]:
    """An effect as its type and the fields that are required or differ from their defaults."""
    return {**effect_to_table(effect), "type": type(effect).__name__}


def effect_from_json(entry: Any) -> Effect:
    """The effect that `effect_to_json` wrote.

    Raises:
        OutputError: the type or a field is unknown, or a value is of the wrong kind.
    """
    try:
        return effect_from_table(entry, "manifest.json: effects")
    except DescriptionError as error:
        raise OutputError(str(error)) from error
