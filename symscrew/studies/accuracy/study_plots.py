"""Pictures of studies: error against time, both logarithmic, one line a method, named at its end.

Study --frames_of--> frames of methods, each with the points that none of its own beats --work_precision--> Figure

A frame holds methods for the same task. What has nothing to show has no frame; of many methods the nearest to the front
of all are named, the others are grey. One point is recommended: that with the least time x error^WORTH.
"""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from symscrew.display import DPI, End, curve_style, label_ends
from symscrew.studies.accuracy.measuring import Point, Study
from symscrew.studies.accuracy.study_tables import SAME_TIME, UNITS, number
from symscrew.whole_files import replaced

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#B8860B", "#3A8FB7", "#000000", "#8C6D1F")
MARKERS = "osD^vP*X<>dhp"
GREY = "#b5b5b5"
FLOOR = 1e-17  # errors that are zero are drawn here
NONE = 1e-12  # errors below come from rounding: the same model
WORTH = 0.3  # a decade of error is worth twice the time: 10^0.3 = 2
SAME_ERROR = 1.3  # errors nearer than this are one: a line ends where more time buys nothing
MOST_NAMED = 7  # methods of a frame with a name and a colour: more are not read in five seconds
MOST_CURVES = 8  # of peers: of more, each engine's best of all settings is one curve, named so
WIDE = 27  # letters in a line of a name
PEERS = {"generatedC": "bare generated C", "exudyn": "Exudyn", "mujoco": "MuJoCo"}
PUBLISHED = "published"  # single points of several authors: no line
SVG = {"svg.hashsalt": "symscrew", "svg.fonttype": "path"}
WIDTH, HIGH = 6.6, 2.75  # of a figure and of one of its frames [in]
PAD = 0.04  # around the picture [in]
LEFT, RIGHT = 0.1, 0.665  # sides of the frames, of the figure's width; names stand beside them


@dataclass(frozen=True)
class Mark:
    """A point in a picture: abscissa, how far its quartiles are to either side, error, and what it is a setting of."""

    x: float
    low: float
    high: float
    error: float
    setting: str


@dataclass(frozen=True)
class Method:
    """A line: its name, its marks from the fastest to the most accurate; `peer`: of another program."""

    name: str
    marks: tuple[Mark, ...]
    peer: bool = False
    joined: bool = True


@dataclass(frozen=True)
class Frame:
    """Methods for one task."""

    title: str
    methods: tuple[Method, ...]

    def recommended(self, floor: float) -> tuple[Method, Mark] | None:
        """The own point with the least time x error^WORTH; no error counts as less than `floor`, the reference's own.

        None where there is nothing to choose from.
        """
        found = [(method, mark) for method in self.methods if not method.peer for mark in method.marks]
        if len(found) < 2:
            return None
        return min(found, key=lambda pair: pair[1].x * max(pair[1].error, floor, FLOOR) ** WORTH)


def save_study_plots(study: Study, directory: Path) -> list[Path]:
    """`<study>.png` and `<study>.svg`; nothing where no point can be drawn."""
    if not any(_drawn(p, study) for p in study.points):
        return []
    import matplotlib

    figure = work_precision(study)
    written = []
    with curve_style(), matplotlib.rc_context(SVG):  # type: ignore[arg-type, unused-ignore]
        figure.draw_without_rendering()
        around = figure.get_tightbbox().padded(PAD)  # once: savefig's "tight" lays out the picture for every file
        for kind, metadata in (("png", {"Software": None}), ("svg", {"Date": None})):
            path = directory / f"{study.name}.{kind}"
            drawn = partial(figure.savefig, dpi=DPI, metadata=metadata, bbox_inches=around)
            written.append(replaced(path, drawn))
    return written


def work_precision(study: Study) -> Figure:
    """A frame for each task of a study, one below another."""
    if any("N" in p.facts for p in study.points):
        return _growth_figure(study)
    frames = frames_of(study)
    with curve_style():
        made = Figure(figsize=(WIDTH, 0.15 + (HIGH + 0.55) * len(frames)))
        FigureCanvasAgg(made)
        high = made.get_figheight()
        for k, frame in enumerate(frames):
            bottom = high - 0.38 - HIGH - k * (HIGH + 0.55)
            axes = made.add_axes((LEFT, bottom / high, RIGHT - LEFT, HIGH / high))
            _draw_frame(axes, frame, study)
    return made


# -- what is drawn -----------------------------------------------------------------------------------------


def frames_of(study: Study) -> list[Frame]:
    """The frames of a study that have something to show."""
    if side_by_side(study):
        return [
            Frame(curve, tuple(_variants(marks_of(points, study))))
            for curve, points in study.curves.items()
            if any(_drawn(p, study) for p in points)
        ]
    panels = dict.fromkeys(str(p.facts.get("panel", "")) for p in study.points if _drawn(p, study))
    return [Frame(panel, tuple(_methods(study, panel))) for panel in panels]


def side_by_side(study: Study) -> bool:
    """Whether every setting is a method by itself, with one point: models or numbers of one function each."""
    return study.cost_unit == "operations" or study.name == "precision"


def _variants(marks: Sequence[Mark]) -> list[Method]:
    """A method a mark; marks at one place are one, with all their names."""
    places: dict[tuple[float, float], list[Mark]] = {}
    for mark in marks:
        places.setdefault((mark.x, round(float(np.log10(max(mark.error, NONE))), 2)), []).append(mark)
    return [Method(" = ".join(m.setting for m in group), (group[0],)) for group in places.values()]


def _methods(study: Study, panel: str) -> list[Method]:
    made, own = [], study.reference_error or 0.0
    for name, points in _of_panel(study, panel).items():
        front = marks_of(points, study)
        kept = tuple(m for m in front if not any(_beats(other, m, own) for other in front))
        peer = any(p.facts.get("peer") for p in points)
        made.append(Method(name.removeprefix(f"{panel}, "), kept, peer, points[0].curve != PUBLISHED))
    return made


def _beats(one: Mark, other: Mark, own: float) -> bool:
    """Whether a mark is better than another by more than repeats and the reference's `own` error differ."""
    first, second = (max(mark.error, own, FLOOR) for mark in (one, other))
    faster, same = one.x < other.x, one.x <= SAME_TIME * other.x
    return (same and first < second / SAME_ERROR) or (faster and first <= SAME_ERROR * second)


def marks_of(points: Sequence[Point], study: Study) -> list[Mark]:
    """Points with an error and a cost, the fastest first."""
    found = [Mark(*_cost(p, study), p.error or 0.0, p.setting) for p in points if _drawn(p, study)]
    return sorted(found, key=lambda mark: (mark.x, mark.error))


def _of_panel(study: Study, panel: str) -> dict[str, list[Point]]:
    """Curves of a panel that have a point to draw; of many peers the fastest at any error, by engine."""
    found = {
        name: points
        for name, points in study.curves.items()
        if str(points[0].facts.get("panel", "")) == panel and any(_drawn(p, study) for p in points)
    }
    peers = {name: points for name, points in found.items() if points[0].facts.get("peer")}
    if len(peers) <= MOST_CURVES:
        return {_peer(name) if name in peers else name: points for name, points in found.items()}
    groups: dict[str, list[Point]] = {name: points for name, points in found.items() if name not in peers}
    for name, points in peers.items():
        engine = name.split()[0]
        groups.setdefault(f"{PEERS.get(engine, engine)}: best of all settings", []).extend(points)
    return {n: _envelope(points) if points[0].facts.get("peer") else points for n, points in groups.items()}


def _peer(name: str) -> str:
    engine, _, rest = name.partition(" ")
    return f"{PEERS.get(engine, engine)}: {rest}" if rest else engine


def _envelope(points: Sequence[Point]) -> list[Point]:
    """The fastest point at every error."""
    best: dict[float, Point] = {}
    for point in points:
        assert point.error is not None and point.cost is not None
        other = best.get(point.error)
        if other is None or other.cost is None or point.cost.median < other.cost.median:
            best[point.error] = point
    return [best[error] for error in sorted(best, reverse=True)]


def _drawn(point: Point, study: Study) -> bool:
    if point.error is None:
        return False
    return "operations" in point.facts if study.cost_unit == "operations" else point.cost is not None


def _cost(point: Point, study: Study) -> tuple[float, float, float]:
    """Abscissa, and how far its quartiles are to either side."""
    if study.cost_unit == "operations":
        return float(point.facts["operations"]), 0.0, 0.0
    assert point.cost is not None
    factor, cost = UNITS[study.cost_unit], point.cost
    return factor * cost.median, factor * (cost.median - cost.lower), factor * (cost.upper - cost.median)


# -- how it is drawn ---------------------------------------------------------------------------------------


def _draw_frame(axes: Axes, frame: Frame, study: Study) -> None:
    floor = NONE if study.cost_unit == "operations" else study.reference_error or 0.0
    chosen = frame.recommended(floor) if study.name != "problems" else None  # whose lines are problems, not methods
    named = _named(frame, study, chosen[0] if chosen else None)
    smallest = NONE if study.cost_unit == "operations" else FLOOR
    least = min((m.error for method in frame.methods for m in method.marks if m.error > smallest), default=1.0)
    shown = max(FLOOR, 0.03 * least)  # errors of zero are drawn here
    ends = []
    for method in frame.methods:
        colour = COLOURS[named.index(method) % len(COLOURS)] if method in named else GREY
        _draw_method(axes, method, colour, k=named.index(method) if method in named else 0, shown=shown)
        if method in named:
            last = method.marks[-1]
            none = "\n(no error)" if last.error <= smallest else ""
            ends.append(End(_wrapped(method, frame) + none, last.x, max(last.error, shown), colour))
    rest = len(frame.methods) - len(named)
    unit = "" if study.cost_unit == "operations" else f"  [{study.cost_unit}]"
    axes.set_xlabel(f"{study.cost_label}{unit}" + f";  grey: {rest} more, in the table" * bool(rest))
    axes.set_ylabel("\n".join(textwrap.wrap(study.error_label, 46)))
    _finish(axes)
    if study.cost_unit != "operations":
        _reference_line(axes, study)
    label_ends(axes, ends)
    title = f"{frame.title}: " if frame.title else ""
    if chosen is not None:
        title += _recommendation(axes, *chosen, study, shown=shown)
    axes.set_title(title or study.title, loc="left", pad=5, fontsize=8.6)


def _named(frame: Frame, study: Study, chosen: Method | None) -> list[Method]:
    """Methods with a name: of many the recommended, and those nearest to the front of all."""
    if len(frame.methods) <= MOST_NAMED or study.name == "problems":
        return list(frame.methods)

    def worth(method: Method) -> float:
        return float(min(mark.x * max(mark.error, FLOOR) ** WORTH for mark in method.marks))

    best = sorted(frame.methods, key=lambda method: (method is not chosen, worth(method)))[:MOST_NAMED]
    return [method for method in frame.methods if method in best]


def _draw_method(axes: Axes, method: Method, colour: str, *, k: int, shown: float) -> None:
    x, low, high = (np.array([getattr(mark, key) for mark in method.marks]) for key in ("x", "low", "high"))
    y = np.array([max(mark.error, shown) for mark in method.marks])
    grey = colour == GREY
    look: dict[str, Any] = {
        "color": colour, "marker": "." if grey else MARKERS[k % len(MARKERS)], "markersize": 2.5 if grey else 4.0,
        "linestyle": "none" if not method.joined else (0, (1.2, 1.2)) if method.peer else "-",
        "linewidth": 0.7 if grey else 1.2, "markerfacecolor": "white" if method.peer else colour,
        "markeredgewidth": 0.8, "zorder": 2 if grey else 3,
    }  # fmt: skip
    bars = np.stack([np.maximum(low, 0.0), np.maximum(high, 0.0)]) if (low + high).any() and not grey else None
    axes.errorbar(x, y, xerr=bars, elinewidth=0.6, capsize=1.5, **look)


def _wrapped(method: Method, frame: Frame) -> str:
    """The name of a method in lines; one with a single point of several settings has its setting in the last."""
    lines = textwrap.wrap(method.name, WIDE)
    if len(method.marks) == 1 and method.marks[0].setting not in method.name and len(frame.methods) <= MOST_NAMED:
        lines += textwrap.wrap(method.marks[0].setting, WIDE)
    return "\n".join(lines)


def _recommendation(axes: Axes, method: Method, mark: Mark, study: Study, *, shown: float) -> str:
    """Mark the recommended point with a ring; what it is, in words."""
    y = max(mark.error, shown)
    axes.plot(mark.x, y, "o", markersize=11, markerfacecolor="none", markeredgecolor="black", markeredgewidth=1.1)
    setting = "" if mark.setting in method.name else f", {mark.setting}"
    unit = "operations" if study.cost_unit == "operations" else study.cost_unit
    size = "no error" if mark.error <= (NONE if unit == "operations" else 0.0) else f"error {mark.error:.0e}"
    return f"recommended (ring): {method.name}{setting}: {size}, {number(mark.x)} {unit}"


def _finish(axis: Axes) -> None:
    axis.set_xscale("log")
    axis.set_yscale("log")
    low, high = axis.get_xlim()
    if high < 12 * low:  # a decade at least, so that there are numbers on the axis
        middle = np.sqrt(low * high)
        axis.set_xlim(middle / 3.6, middle * 3.6)
    axis.yaxis.set_major_locator(LogLocator(numticks=8))
    axis.yaxis.set_minor_formatter(NullFormatter())
    axis.yaxis.set_major_formatter(_decade)
    axis.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    span = np.log10(axis.get_xlim()[1] / axis.get_xlim()[0])
    if span < 1.5:
        axis.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.grid(visible=True, which="major")


def _decade(value: float, _: float | None = None) -> str:
    """A power of ten as text: setting it as a formula takes matplotlib a third of the time of a picture."""
    return f"1e{round(float(np.log10(value)))}"


def _reference_line(axis: Axes, study: Study) -> None:
    """The reference's own error, where it is within the picture."""
    own = study.reference_error
    if own is None or own <= 0:
        return
    low, high = axis.get_ylim()
    if not 1e-3 * low < own < high:
        return
    axis.set_ylim(min(low, own / 3), high)
    axis.axhline(own, color="#808080", linewidth=0.7, linestyle=(0, (6, 3)), zorder=1)
    axis.annotate(
        "error of the reference", (0.015, own), xycoords=("axes fraction", "data"), xytext=(0, 2),
        textcoords="offset points", ha="left", va="bottom", fontsize=7, color="#606060",
    )  # fmt: skip


def _growth_figure(study: Study) -> Figure:
    """Time per simulated second over the number of loops, beside lines of slope 1; operations over the same."""
    series: dict[str, list[Point]] = {}
    for point in study.points:
        if point.cost is not None:
            series.setdefault(str(point.facts["series"]), []).append(point)
    dashes: dict[str, Any] = {"color": "#808080", "linewidth": 0.8, "linestyle": (0, (5, 2))}
    labels = (f"{study.cost_label}  [{study.cost_unit}]", "operations of forward dynamics")
    with curve_style():
        made = Figure(figsize=(WIDTH, 0.15 + 2 * (HIGH + 0.4)))
        FigureCanvasAgg(made)
        for row, label in enumerate(labels):
            bottom = (1 - row) * (HIGH + 0.4) + 0.45
            axes = made.add_axes((LEFT, bottom / made.get_figheight(), RIGHT - LEFT, HIGH / made.get_figheight()))
            ends = []
            counted = {"counted": next(iter(series.values()))}
            for k, (name, found) in enumerate((counted if row else series).items()):
                n = np.array([float(p.facts["N"]) for p in found])
                times = [UNITS[study.cost_unit] * p.cost.median for p in found if p.cost is not None]
                values = np.array(times if row == 0 else [float(p.facts["operations"]) for p in found])
                axes.plot(n, values[-1] * n / n[-1], **dashes)
                axes.plot(n, values, color=COLOURS[k], marker=MARKERS[k], markersize=4.0)
                text = "\n".join(textwrap.wrap(name, WIDE))
                ends.append(End(f"{text}\n(dashes: linear)", float(n[-1]), float(values[-1]), COLOURS[k]))
            axes.set_xlabel("number of loops N")
            axes.set_ylabel(label)
            _finish(axes)
            label_ends(axes, ends)
    return made
