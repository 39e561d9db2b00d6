"""Singularity margins along each independent coordinate, as a figure.

model --compiled--> calls --walk along a coordinate--> margins relative to the reference --figure--> frames
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from symscrew.model import Model
from symscrew.runtime import load
from symscrew.studies.workspace import (
    Call,
    calls_of,
    independent_labels,
    reference_coordinates,
    start_margins,
    walk,
    watched_margins,
)

HALF = {"rad": 1.2, "m": 0.6, "1": 0.5}
"""How far the curves go to either side, by the unit of the coordinate; lengths by the characteristic length."""
MOST = 6  # coordinates that have a frame, two rows of three; the caption says when there are more
COUNT = 61  # points of a curve: smooth to the eye
FUNCTIONS = ("assemble", "limb_margins", "constraint_margin", "actuation_margins")


def compiled(model: Model) -> Call:
    """What the figure evaluates, compiled alone: less than a second, where interpreting takes twenty."""
    return calls_of(load(model.only(FUNCTIONS)))


def left_out(model: Model) -> tuple[str, ...]:
    """Independent coordinates that have no frame in the figure."""
    return independent_labels(model)[MOST:]


def figure(model: Model, call: Call) -> Any:
    """Margins over each independent coordinate (at most six); None where there are none.

    `call` evaluates the model's functions.
    """
    from matplotlib.figure import Figure

    from symscrew.display import COLOURS, DASHES, curve_style

    labels, start = independent_labels(model), reference_coordinates(model)
    units = {c.label: c.unit for c in model.system.tree.q}
    first = start_margins(model, call)
    names = list(first)
    if not names or not labels:
        return None
    shown = range(min(len(labels), MOST))
    columns = min(3, len(shown))
    rows = -(-len(shown) // columns)
    with curve_style():
        made = Figure(figsize=(7.0, 0.45 + 2.0 * rows), layout="constrained")
        frames = made.subplots(rows, columns, sharey=True, squeeze=False).ravel()
        for k, axes in zip(shown, frames, strict=False):
            unit = units[labels[k]]
            half = HALF.get(unit, 0.5) * (model.system.length if unit == "m" else 1.0)
            values = np.linspace(start[k] - half, start[k] + half, COUNT)
            curves = _along(model, call, k, values)
            for j, name in enumerate(names):
                look = {"color": COLOURS[j % len(COLOURS)], "linestyle": DASHES[(j + j // len(COLOURS)) % len(DASHES)]}
                axes.plot(values, curves[name] / first[name], label=name, **look)
            axes.axhline(0.0, color="black", linewidth=0.6)
            axes.plot(start[k], 1.0, "o", color="black", markersize=3)
            axes.set_xlim(values[0], values[-1])
            axes.set_ylim(-1.5, 2.5)
            axes.set_xlabel(f"{labels[k]}  [{unit}]")
        for axes in frames[len(shown) :]:
            axes.set_visible(False)
        for axes in frames[::columns]:
            axes.set_ylabel("margin  [1]")
        handles, texts = frames[0].get_legend_handles_labels()
        made.legend(handles, texts, loc="outside upper center", ncols=3)
    return made


def _parameters(model: Model, count: int) -> Sequence[np.ndarray]:
    values = model.system.parameter_values
    return (np.repeat(values[None, :], count, 0),) if len(values) else ()


def _along(model: Model, call: Call, k: int, values: np.ndarray) -> dict[str, np.ndarray]:
    """All margins over the values of one independent coordinate, the others as in the reference configuration."""
    y = np.repeat(reference_coordinates(model)[None, :], len(values), 0)
    y[:, k] = values
    with np.errstate(all="ignore"):
        q, *_ = walk(model, call, y, watch=False)
        return watched_margins(model, call, q, _parameters(model, len(values)))
