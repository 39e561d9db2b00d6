"""Target "modes": all assembly modes, and the one that a motion stays on, as C; compared with those found in Python."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from symscrew.assembly import (
    AssemblyModes,
    assembly_modes,
    compiled_modes,
    has_level_modes,
    modes_model,
    print_modes,
)
from symscrew.export import banner
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.runtime import find_compiler

AGREEING = 1e-10  # of poses, in sizes of the mechanism: errors of certified zeros are below 1e-12
MOVED = 0.03  # rad, or sizes of the mechanism: of the drives at the second place that is compared
WHOLE, NOT_ALL = 0, 100  # statuses of the C, as its header names them
AT_HOME = np.append(np.eye(3).ravel(), np.zeros(3))


def files(order: Order) -> Mapping[str, str]:
    """<name>_modes.h, <name>_modes.c."""
    return print_modes(modes_model(order.model.mechanism), banner(order.model))


def section(order: Order) -> Sequence[str]:
    """How it is called."""
    name = order.model.name
    return [
        "### All assembly modes",
        "",
        "```c",
        f"{name}_mode modes[{name.upper()}_MODES_MOST];",
        "int count;",
        f"int status = {name}_assembly_modes(drives, modes, &count); /* every solution, certified */",
        f"status = {name}_nearest_mode(&modes[0], next_drives);      /* stays on its mode, or refuses */",
        "```",
        "",
        *_level(order),
        f"`{name}_modes.h` says the rest. With `-O2 -march=native` paths fill the lanes of the processor.",
    ]


def _level(order: Order) -> list[str]:
    if not has_level_modes(modes_model(order.model.mechanism)):
        return []
    return [
        f"`{order.model.name}_level_modes(drives, modes, &count)` gives those whose platform is turned as in the",
        "reference, two at most, in closed form.",
        "",
    ]


def compare(case: Case) -> Iterator[Finding]:
    """Modes of the reference and of other drives; the reference's own led there and back."""
    if find_compiler() is None:
        yield True, "no C compiler here: assembly modes not compiled"
        return
    compiled = compiled_modes(modes_model(case.model.mechanism), case.fresh)
    model = compiled.model
    start = [reference for _, reference, _, _ in model.drives]
    moved = [r + MOVED * unit * (1 - 2 * (k % 2)) for k, (_, r, unit, _) in enumerate(model.drives)]
    size = float(model.held.network.length)
    for drives in (start, moved):
        found = assembly_modes(case.model.mechanism, at={d[0]: x for d, x in zip(model.drives, drives, strict=True)})
        yield _same(found, *compiled.modes(drives), size=size)
        if has_level_modes(model):
            level = [m for m in found.modes if np.abs(m.rotation - np.eye(3)).max() < AGREEING]
            yield _same(replace(found, modes=tuple(level)), *compiled.level(drives), size=size, kind="level ")
    _, modes = compiled.modes(start)
    home = next((m for m in modes if np.abs(_pose(m, size) - AT_HOME).max() < AGREEING), None)
    if home is None:
        yield False, "C finds no mode at the reference"
        return
    there, back = compiled.led(home, moved), compiled.led(home, start)
    off = np.abs(_pose(home, size) - AT_HOME).max()
    text = f"C leads the mode of the reference there and back, off by {off:.1e}"
    yield there == back == 0 and off < AGREEING, text if there == back == 0 else "C refuses a short motion"


def _pose(mode: Any, size: float) -> np.ndarray:
    """Rotation by columns and displacement in sizes of the mechanism."""
    pose = np.array(mode.pose)
    return np.concatenate([pose[:9], pose[9:] / size])


def _same(found: AssemblyModes, status: int, modes: Sequence[Any], *, size: float, kind: str = "") -> Finding:
    """Whether C and Python find the same certified modes."""
    known = [
        np.concatenate([m.rotation.T.ravel(), m.translation / size])
        for m in found.modes
        if m.certified and m.meeting == 1
    ]
    worst = max((min((np.abs(_pose(m, size) - k).max() for k in known), default=np.inf) for m in modes), default=0.0)
    singular = len(known) < len(found.modes)
    whole = len(modes) == len(known) and (status == WHOLE or (singular and status == NOT_ALL))
    text = f"C finds {len(modes)} {kind}assembly modes of {len(known)} certified in Python, the same to {worst:.1e}"
    return whole and worst < AGREEING, text
