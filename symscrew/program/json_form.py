"""Programs as plain lists of numbers and texts, which JSON holds, and back: to keep what took time to derive.

    Program, Iteration, RankRevealing --to_lists, json--> text --json, from_lists--> the same, bit by bit

Slots are whole numbers and constants are floating ones in both, and both writers of JSON give shortest digits that read
back as the same number.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from symscrew.program.rank_revealing import RankRevealing
from symscrew.program.straight_line import Instruction, Iteration, Port, Program

Lists = Mapping[str, Any]
PORT = ("name", "shape", "units", "labels", "description", "forms")
ITERATION = ("name", "description", "independent", "tolerance", "max_steps", "max_substeps", "notes")
PROGRAM = ("name", "description", "results", "guards", "limits", "reach", "notes", "slots")
SECOND = ("rates", "rows", "regular")


def to_lists(program: Program | Iteration) -> dict[str, Any]:
    """All that a program is, but for what follows from the rest."""
    ports = {key: [[getattr(p, f) for f in PORT] for p in getattr(program, key)] for key in ("inputs", "outputs")}
    if isinstance(program, Iteration):
        return {**{f: getattr(program, f) for f in ITERATION}, **ports, "step": to_lists(program.step)}
    made: dict[str, Any] = {
        **{f: getattr(program, f) for f in PROGRAM},
        **ports,
        "operations": [[i.target, i.op, *i.args] for i in program.instructions],
    }
    if isinstance(program, RankRevealing):
        parts = {"dense": program.dense, "wrenches": program.wrenches}
        kept = {f: to_lists(part) if part is not None else None for f, part in parts.items()}
        made["second"] = {**{f: getattr(program, f) for f in SECOND}, **kept}
    return made


def from_lists(lists: Lists) -> Program | Iteration:
    """The program of which these are the lists."""
    own: dict[str, Any] = {key: tuple(Port(*map(_tuple, port)) for port in lists[key]) for key in ("inputs", "outputs")}
    if "step" in lists:
        own |= {f: _tuple(lists[f]) for f in ITERATION}
        return Iteration(**own, step=from_lists(lists["step"]))  # type: ignore[arg-type]
    own |= {key: _tuple(lists[key]) for key in PROGRAM}
    own["instructions"] = tuple(Instruction(target, op, tuple(args)) for target, op, *args in lists["operations"])
    if "second" not in lists:
        return Program(**own)
    second = lists["second"]
    own |= {f: from_lists(second[f]) if second[f] is not None else None for f in ("dense", "wrenches")}
    return RankRevealing(**own, **{f: _tuple(second[f]) for f in SECOND})


def _tuple(value: Any) -> Any:
    """Lists as tuples, however deep."""
    return tuple(map(_tuple, value)) if isinstance(value, list | tuple) else value
