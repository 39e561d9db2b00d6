"""The picture of a certificate: its boxes over two coordinates, coloured by what is known of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.display import COLOURS, curve_style, save_figure
from symscrew.studies.certificate.certificates import Certificate
from symscrew.studies.certificate.splitting import Box

KINDS = {
    "proved": COLOURS[2],
    "not joined to the reference": COLOURS[5],
    "outside the limits": "#9a9a9a",
    "undecided": COLOURS[1],
}
CIRCLES = 4  # of equal tilt, at most: enough to read angles off
PER_DEGREE = math.pi / 180


def draw_certificate(found: Certificate, path: Path) -> Path:
    """Boxes over the first two edges; of three and more the section through the start, of one a strip."""
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Patch, Rectangle

    region = found.region
    names = [*region.names, ""][:2]
    with curve_style():
        from matplotlib.figure import Figure

        made = Figure(figsize=(4.2, 4.0 if names[1] else 1.6), layout="constrained")
        axes = made.add_subplot()
        axes.grid(visible=False)
        axes.set_axisbelow(False)
        leaves = [box for box in found.root.leaves if box.state != "beyond" and _in_section(found, box)]
        for kind, colour in KINDS.items():
            boxes = [Rectangle(*_corner_and_size(b), linewidth=0) for b in leaves if _kind(b) == kind]
            axes.add_collection(PatchCollection(boxes, facecolor=colour, edgecolor="white", linewidth=0.25))
        axes.set_xlim(region.low[0], region.high[0])
        axes.set_xlabel(names[0])
        if names[1]:
            axes.set_ylim(region.low[1], region.high[1])
            axes.set_ylabel(names[1])
        else:
            axes.set_yticks([])
        if region.disk is not None and set(region.disk[:2]) == {0, 1}:
            axes.set_aspect("equal")
            _circles(axes, region.disk[2])
        there = [Patch(color=KINDS[kind], label=kind) for kind in KINDS if any(_kind(b) == kind for b in leaves)]
        made.legend(handles=there, loc="outside upper center", ncols=2)
        if len(region.names) > 2:
            z = found.values["start"]["z"]
            rest = ", ".join(f"{n} = {x:.4g}" for n, x in list(zip(region.names, z, strict=True))[2:])
            made.supxlabel(f"section at {rest}", fontsize=8)
        return save_figure(made, path)


def _kind(box: Box) -> str:
    if box.joined:
        return "proved"
    return {"certified": "not joined to the reference", "outside": "outside the limits"}.get(box.state, "undecided")


def _in_section(found: Certificate, box: Box) -> bool:
    z = np.array(found.values["start"]["z"])[2:]
    return bool(((box.low[2:] <= z) & (z <= box.high[2:])).all())


def _corner_and_size(box: Box) -> Sequence[Any]:
    size = box.high - box.low
    if len(size) == 1:
        return (float(box.low[0]), 0.0), float(size[0]), 1.0
    return (float(box.low[0]), float(box.low[1])), float(size[0]), float(size[1])


def _circles(axes: Any, radius: float) -> None:
    """Circles of equal tilt, named in degrees."""
    most = 2 * math.asin(min(1.0, radius)) / PER_DEGREE
    step = next(s for s in (1, 2, 5, 10, 20, 30, 45, 60) if most <= CIRCLES * s)
    turn = np.linspace(0.0, 2 * np.pi, 181)
    for tilt in (*range(step, math.floor(most) + 1, step), most):
        size = math.sin(tilt * PER_DEGREE / 2)
        axes.plot(size * np.cos(turn), size * np.sin(turn), color="black", linewidth=0.4)
        axes.annotate(f"{tilt:.3g}°", (0.0, size), fontsize=7, ha="center", va="bottom")
