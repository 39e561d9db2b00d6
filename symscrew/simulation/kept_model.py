"""The model of a mechanism and effects, derived once and then read from the user's cache.

    mechanism, effects --derive--> programs --JSON--> cache
                        --cache--> programs, each made when it is asked for

Both ways give the same numbers, bit by bit: the programs are the same, and what a run computes of the mechanism itself
it computes of a system that was made for the run, not of the one that was used to derive.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from symscrew.description import Mechanism
from symscrew.effects import Effect, system_under
from symscrew.model import Model, derive
from symscrew.program import Asked, Iteration, Program, from_lists, to_lists
from symscrew.runtime import entry, model_key

KEPT = ("notes", "one_mode", "independent", "selected")  # of a model, beside its programs and states


def derived_model(mechanism: Mechanism, effects: Sequence[Effect], independent: Sequence[str] | None = None) -> Model:
    """`derive(mechanism, effects, independent=independent)`, with a system of its own; values have no names.

    Raises:
        DescriptionError: as `derive`.
    """
    with entry(model_key(mechanism, effects, independent)) as kept:
        found = _read(kept.read())
        if found is None:
            model = derive(mechanism, effects, independent=independent)
            found = {
                **{name: getattr(model, name) for name in KEPT},
                "programs": {name: to_lists(program) for name, program in model.programs.items()},
                "states": {name: [x.tolist() for x in arrays] for name, arrays in model.test_inputs.items()},
                "sizes": {name: [x.shape for x in arrays] for name, arrays in model.test_inputs.items()},
            }
            text = json.dumps(found)
            kept.write(text.encode("ascii"))
            found = json.loads(text)  # the same way, whether it was there or not
    known = tuple(effects)
    system = system_under(mechanism, known)
    programs: Mapping[str, Program | Iteration] = Asked(found["programs"], from_lists)
    shaped = {name: list(zip(found["states"][name], found["sizes"][name], strict=True)) for name in found["states"]}
    states = Asked(shaped, lambda of: tuple(np.array(x, dtype=float).reshape(shape) for x, shape in of))
    kept_fields: dict[str, Any] = {name: tuple(v) if isinstance(v := found[name], list) else v for name in KEPT}
    options = {"independent": None if independent is None else tuple(independent)}
    return Model(mechanism.name, mechanism, known, programs, states, system, options=options, **kept_fields)


def _read(kept: bytes | None) -> dict[str, Any] | None:
    try:
        found = json.loads(kept) if kept is not None else None
    except (ValueError, RecursionError):
        return None
    return found if isinstance(found, dict) and "programs" in found else None
