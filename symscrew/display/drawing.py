"""A picture of any mechanism in its reference configuration, drawn from its description.

Bodies are bars between their joint points, or plates where three or more of their points lie in a plane;
joints are markers by type, the driven ones filled. What is farther from the viewer is drawn first.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from symscrew.description import JOINT_TYPES, Mechanism
from symscrew.display.plots import COLOURS, curve_style, indexed_symbol
from symscrew.display.shape import along, body_points, numbers, plate

Array = np.ndarray

MARKERS = {"R": "o", "P": "s", "H": "h", "C": "p", "U": "D", "S": "o", "E": "^", "fixed": "x", "free": "*"}
SIZES = {"R": 5.0, "P": 5.0, "S": 8.0, "U": 6.5}
GROUND, PLATFORM, LINK = "#8a8a8a", COLOURS[0], "#3a3a3a"


@dataclass(frozen=True)
class Camera:
    """A view in perspective: rows of `axes` are right, up and towards the viewer; `distance` from `middle`."""

    axes: Array
    middle: Array
    distance: float

    def __call__(self, points: Array) -> Array:
        """Points (..., 3) on the picture (..., 2)."""
        seen = (points - self.middle) @ self.axes.T
        on_picture: Array = seen[..., :2] * (self.distance / (self.distance - seen[..., 2:]))
        return on_picture

    def depth(self, points: Array) -> float:
        """How near to the viewer points (n, 3) are on average."""
        return float(((points - self.middle) @ self.axes[2]).mean())


def camera(points: Array, elevation: float, azimuth: float) -> Camera:
    """A view on points from a direction [degrees]: azimuth about z from x, elevation above the x-y plane."""
    e, z = np.radians(elevation), np.radians(azimuth)
    towards = np.array([np.cos(e) * np.cos(z), np.cos(e) * np.sin(z), np.sin(e)])
    right = np.array([-np.sin(z), np.cos(z), 0.0])
    middle = (points.max(axis=0) + points.min(axis=0)) / 2
    extent = float(np.linalg.norm(np.ptp(points, axis=0))) or 1.0
    return Camera(np.stack([right, np.cross(towards, right), towards]), middle, 3.5 * extent)


def mechanism_figure(
    mechanism: Mechanism, *, elevation: float = 20.0, azimuth: float = -62.0, width: float = 4.6, labels: bool = True
) -> Figure:
    """The mechanism in its reference configuration, with its named points and absolute axes."""
    points = body_points(mechanism)
    whole = np.concatenate([p for p in points.values() if len(p)] or [np.zeros((1, 3))])
    view = camera(whole, elevation, azimuth)
    length = 0.5 * float(np.ptp(whole, axis=0).max()) or 1.0
    with curve_style():
        shape = np.ptp(view(np.concatenate([whole, 0.4 * length * np.eye(3)])), axis=0)
        made = Figure(figsize=(width, width * float(np.clip(shape[1] / shape[0], 0.3, 1.2))))
        FigureCanvasAgg(made)
        axes = made.add_axes((0.0, 0.0, 1.0, 1.0))
        bodies = [(name, places) for name, places in points.items() if len(places)]
        for order, (body, places) in enumerate(sorted(bodies, key=lambda item: _depth(mechanism, view, *item))):
            colour, bar = _colour(mechanism, body), _bar(mechanism, body)
            _body(axes, view, places, colour=colour, bar=bar, order=2 + 0.01 * order)
        _frame(axes, view, length)
        _joints(axes, view, mechanism)
        if labels:
            _labels(axes, view, mechanism, length)
        axes.set_aspect("equal", adjustable="datalim")
        axes.margins(0.06)
        axes.set_axis_off()
        handles = _legend(mechanism)
        axes.legend(handles=handles, loc="upper center", ncols=min(4, len(handles)), bbox_to_anchor=(0.5, -0.01))
    return made


def _depth(mechanism: Mechanism, view: Camera, body: str, places: Array) -> float:
    return -np.inf if body == mechanism.ground else view.depth(places)


def _colour(mechanism: Mechanism, body: str) -> str:
    return GROUND if body == mechanism.ground else PLATFORM if body == mechanism.platform else LINK


def _bar(mechanism: Mechanism, body: str) -> float:
    """Width of a body that is a bar [points of type]; 0 for the ground, which is none."""
    if body == mechanism.ground:
        return 0.0
    # the outer part of a sliding pair is drawn thicker than the one that slides in it
    outer = any(j.kind.slider and j.parent == body for j in mechanism.joints.values())
    return 4.6 if outer else 2.2


def _body(axes: Axes, view: Camera, places: Array, *, colour: str, bar: float, order: float) -> None:
    """A plate where three or more points lie in a plane, else a bar along the points."""
    flat = plate(places) if len(places) > 2 else None
    if flat is None:
        if bar:
            axes.plot(*view(along(places)).T, color=colour, linewidth=bar, solid_capstyle="round", zorder=order)
        return
    inside, corners = flat
    axes.fill(*view(corners).T, facecolor=colour, alpha=0.16, edgecolor="none", zorder=order)
    axes.plot(*view(np.vstack([corners, corners[:1]])).T, color=colour, linewidth=1.5, zorder=order)
    middle = corners.mean(axis=0)
    for place in places[~inside]:
        strut = view(np.vstack([middle, place]))
        axes.plot(*strut.T, color=colour, linewidth=1.5, linestyle=(0, (4, 1.5)), zorder=order)


def _joints(axes: Axes, view: Camera, mechanism: Mechanism) -> None:
    for joint in mechanism.joints.values():
        axes.plot(
            *view(numbers(mechanism, joint.point)), marker=MARKERS[joint.type], markersize=SIZES.get(joint.type, 6.0),
            color="black", markerfacecolor=COLOURS[1] if joint.driven else "white", markeredgewidth=0.9,
            linestyle="none", zorder=5,
        )  # fmt: skip


def _frame(axes: Axes, view: Camera, length: float) -> None:
    """The absolute axes at O."""
    start = view(np.zeros(3))
    for axis, name in zip(np.eye(3), "xyz", strict=True):
        end = view(0.36 * length * axis)
        arrow = {"arrowstyle": "-|>,head_width=0.18,head_length=0.4", "color": COLOURS[2], "linewidth": 1.1}
        axes.annotate(
            "", xy=_pair(end), xytext=_pair(start), arrowprops={**arrow, "shrinkA": 0, "shrinkB": 0}, zorder=4
        )
        axes.plot(*end, alpha=0.0)  # an arrow alone does not count for the limits
        along = (end - start) / (np.linalg.norm(end - start) or 1.0)
        along = along if abs(along[1]) < 0.95 else np.array([-0.9, -0.4])
        place: dict[str, Any] = {"xy": _pair(end), "xytext": _pair(6.5 * along), "textcoords": "offset points"}
        axes.annotate(f"${name}$", **place, color=COLOURS[2], ha="center", va="center", zorder=7)


def _pair(vector: Array) -> tuple[float, float]:
    return float(vector[0]), float(vector[1])


def _labels(axes: Axes, view: Camera, mechanism: Mechanism, length: float) -> None:
    """Names of the named points, moved outwards from the middle of the picture by a few points of type."""
    places = {name: numbers(mechanism, point.at) for name, point in mechanism.points.items()}
    middle = view(np.mean(list(places.values()) or [np.zeros(3)], axis=0))
    for name, place in places.items():
        at = view(place)
        axes.plot(*at, marker=".", markersize=4.0, color="black", linestyle="none", zorder=4.5)
        away = (at - middle) * (1.0, 0.6)
        size = float(np.linalg.norm(away))
        outwards = away / size if size > 0.12 * length else np.array([-0.75, -0.65 if at[1] < middle[1] else 0.65])
        axes.annotate(
            indexed_symbol(name),
            xy=_pair(at),
            xytext=_pair(11.0 * outwards),
            textcoords="offset points",
            ha="center",
            va="center",
            zorder=7,
        )


def _legend(mechanism: Mechanism) -> list[Line2D]:
    kinds = dict.fromkeys((j.type, bool(j.driven)) for j in mechanism.joints.values())
    handles = [
        Line2D(
            [], [], marker=MARKERS[kind], markersize=SIZES.get(kind, 6.0), color="black", linestyle="none",
            markerfacecolor=COLOURS[1] if driven else "white",
            label=f"{JOINT_TYPES[kind].name}{', driven' if driven else ''}",
        )
        for kind, driven in kinds
    ]  # fmt: skip
    if mechanism.platform:
        handles.append(Line2D([], [], color=PLATFORM, linewidth=2, label=mechanism.platform))
    return handles
