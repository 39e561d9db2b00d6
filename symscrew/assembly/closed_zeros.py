"""Closed forms in the C of modes: which a structure has, the file of each, and its tables.

    one planar body on three rods from the ground --modes_planar.c--> all zeros
    one body on three pairs of parallel rods      --modes_spheres.c--> those that are turned as the reference is
    any other                                     --modes_by_paths.c--> none: paths find them

A further one is a file, what recognises it here, and its name in `closed_form`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from symscrew.algebra import cross, dot, subtract
from symscrew.assembly.c_tables import Step, c_array, held_steps
from symscrew.assembly.closure_structure import Form, Structure
from symscrew.assembly.elementary_graph import Point

EXACT = 1e-40
"""Differences of 60 digits that are none."""
ARMS = 3
"""Of a planar platform, and of one that does not turn: freedoms."""


@dataclass(frozen=True)
class ClosedForm:
    """Files of C: `zeros` finds all in closed form, or says that it does not; `more` has functions with `tables`."""

    zeros: str = "modes_by_paths.c"
    more: str = ""
    tables: tuple[str, ...] = ()


def closed_form(structure: Structure, chosen: Sequence[int]) -> ClosedForm:
    """That of a structure with these columns as drives."""
    if _three_circles(structure):
        return ClosedForm("modes_planar.c")
    arms = _parallel_rods(structure, chosen)
    return ClosedForm(more="modes_spheres.c", tables=tuple(_level_tables(arms))) if arms else ClosedForm()


def _one_body(structure: Structure, kind: str, distances: int) -> bool:
    """Whether one body hangs on so many distances from the ground, and nothing else."""
    one_loop = len(structure.loops) == len(structure.groups) == 1 and structure.groups[0].kind == kind
    return (
        one_loop
        and structure.loops[0].base == structure.graph.ground
        and [f.kind for f in structure.loops[0].forms] == ["distance"] * distances
    )


def _three_circles(structure: Structure) -> bool:
    """Whether it is one planar body on three rods from the ground: solved in closed form."""
    return _one_body(structure, "planar", ARMS)


@dataclass(frozen=True)
class Arm:
    """Of two parallel rods: what drives their ends on the arm, one end there, one on the platform, length squared."""

    step: Step
    drive: int
    at: Point
    tip: Point
    square: Any
    axis: Point
    point: Point


def _parallel_rods(structure: Structure, chosen: Sequence[int]) -> list[Arm]:
    """The arms, or none."""
    if not _one_body(structure, "free", 2 * ARMS) or len(chosen) != ARMS:
        return []
    pairs: dict[str, list[Form]] = {}
    for form in structure.loops[0].forms:
        pairs.setdefault(structure.slots[form.slots[1]].body, []).append(form)
    steps = {step.far: step for step in held_steps(structure) if step.near == structure.graph.ground}
    arms = [_arm(structure, steps.get(body), forms, chosen) for body, forms in pairs.items()]
    found = [arm for arm in arms if arm is not None]
    whole = len(found) == len(arms) == ARMS and sorted(arm.drive for arm in found) == list(range(ARMS))
    return found if whole else []


def _arm(structure: Structure, step: Step | None, forms: Sequence[Form], chosen: Sequence[int]) -> Arm | None:
    """What two forms lay on the platform alike, as long as it is not turned."""
    edge = step.edge if step is not None else None
    if step is None or edge is None or edge.axis is None or edge.columns[0] not in chosen or len(forms) != 2:
        return None
    tips, ends, rods = ([structure.slots[f.slots[k]] for f in forms] for k in range(3))
    across = [subtract(pair[0].at, pair[1].at) for pair in (tips, ends)]
    squares = [_square(rod.rod) for rod in rods]
    if tips[0].body != tips[1].body or None in squares or not _same(across[0], across[1]):
        return None
    if abs(squares[0] - squares[1]) > EXACT or (
        edge.kind == "turn" and not _same(cross(across[1], edge.axis), (0, 0, 0))
    ):
        return None
    local = structure.local
    return Arm(step, chosen.index(edge.columns[0]), local(ends[0].at), local(tips[0].at), squares[0],
               structure.turned(edge.axis), local(edge.point))  # fmt: skip


def _square(rod: tuple[tuple[str, Point], tuple[str, Point]] | None) -> Any:
    """Of a rod's length, where both ends are on one body."""
    if rod is None or rod[0][0] != rod[1][0]:
        return None
    way = subtract(rod[0][1], rod[1][1])
    return dot(way, way)


def _same(one: Point, two: Point) -> bool:
    return all(abs(a - b) < EXACT for a, b in zip(one, two, strict=True))


def _level_tables(arms: Sequence[Arm]) -> list[str]:
    """From a sphere's centre to O: start - c cos - s sin, of a slide start - value cos."""
    starts, cosines, sines = list[list[float]](), list[list[float]](), list[list[float]]()
    for arm in arms:
        turns = arm.step.edge is not None and arm.step.edge.kind == "turn"
        around = subtract(arm.at, arm.point)
        along = dot(around, arm.axis)
        rest = subtract(around, tuple(along * c for c in arm.axis))
        fixed = subtract(arm.at, rest) if turns else arm.at
        starts.append([float(c) for c in subtract(arm.tip, fixed)])
        cosines.append([float(c) for c in (rest if turns else arm.axis)])
        sines.append([float(c) for c in (cross(arm.axis, around) if turns else (0, 0, 0))])
    kinds = [int(arm.step.edge is not None and arm.step.edge.kind == "turn") for arm in arms]
    lines = c_array("int", "level_turns", kinds) + c_array("int", "level_drive", [arm.drive for arm in arms])
    lines += c_array("double", "level_sign", [float(arm.step.sign) for arm in arms])
    lines += c_array("double", "level_square", [float(arm.square) for arm in arms])
    return [
        *lines,
        *c_array("double", "level_start", starts),
        *c_array("double", "level_cos", cosines),
        *c_array("double", "level_sin", sines),
    ]
