"""All assembly modes of a mechanism side by side, seen from one place."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from symscrew.assembly import AssemblyMode, AssemblyModes
from symscrew.description import Mechanism
from symscrew.display.drawing import GROUND, LINK, PLATFORM, Camera, camera
from symscrew.display.plots import curve_style
from symscrew.display.shape import along, body_points, plate

Array = np.ndarray

MOST = 40
"""Modes in a picture: as many as a platform on six legs can have."""
COLUMNS = 8
"""Of a wide page: more, and names are not to be read."""
SIZE = 1.7
"""Of one mode [inches]."""


def modes_figure(found: AssemblyModes, *, elevation: float = 20.0, azimuth: float = -62.0) -> Figure:
    """A small picture of each mode with its name, all with one view: in the plane of a planar mechanism."""
    mechanism = found.mechanism
    modes = [mode for mode in found.modes if mode.poses][:MOST]
    points = body_points(mechanism)
    placed = [{body: _moved(mode, body, places) for body, places in points.items()} for mode in modes]
    whole = np.concatenate([p for each in placed for p in each.values() if len(p)] or [np.zeros((1, 3))])
    flat = np.ptp(whole, axis=0)
    if flat.min() < 1e-9 * flat.max():
        elevation, azimuth = [(0.0, 0.0), (0.0, -90.0), (90.0, -90.0)][int(flat.argmin())]
    view = camera(whole, elevation, azimuth)
    columns = min(COLUMNS, max(1, len(modes)))
    rows = math.ceil(max(1, len(modes)) / columns)
    with curve_style():
        made = Figure(figsize=(SIZE * columns, SIZE * rows))
        FigureCanvasAgg(made)
        for k, (mode, each) in enumerate(zip(modes, placed, strict=True)):
            axes = made.add_subplot(rows, columns, k + 1)
            _draw(axes, view, mechanism, each)
            axes.set_title(mode.name, fontsize=8)
            seen = view(whole)
            axes.set_xlim(seen[:, 0].min(), seen[:, 0].max())
            axes.set_ylim(seen[:, 1].min(), seen[:, 1].max())
    return made


def _moved(mode: AssemblyMode, body: str, places: Array) -> Array:
    rotation, translation = mode.poses[body]
    return np.asarray(places @ rotation.T + translation) if len(places) else places


def _draw(axes: Axes, view: Camera, mechanism: Mechanism, placed: dict[str, Array]) -> None:
    for body, places in placed.items():
        colour = GROUND if body == mechanism.ground else PLATFORM if body == mechanism.platform else LINK
        flat = plate(places) if len(places) > 2 else None
        if flat is not None:
            corners = view(flat[1])
            axes.fill(*corners.T, facecolor=colour, alpha=0.2, edgecolor=colour, linewidth=1.0)
        elif body != mechanism.ground and len(places):
            axes.plot(*view(along(places)).T, color=colour, linewidth=1.4)
    axes.set_aspect("equal")
    axes.set_axis_off()
