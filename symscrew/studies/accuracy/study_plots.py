"""Work-precision diagrams: error over cost, both logarithmic, a colour and a marker per curve."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from symscrew.display import DPI, curve_style
from symscrew.studies.accuracy.measuring import Point, Study
from symscrew.studies.accuracy.study_tables import UNITS
from symscrew.whole_files import replaced

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8C6D1F")
MARKERS = "osD^vP*X<>dhp"
FLOOR = 1e-17  # errors that are zero are drawn here
NONE = 1e-12  # errors below come from rounding: the same model
MOST_CURVES = 8  # of a panel, one colour each; of more, each engine's best of all settings is one curve, named so
PEERS = {"generatedC": "bare generated C", "exudyn": "Exudyn", "mujoco": "MuJoCo"}
PUBLISHED = "published"  # single points of several authors: no line
SVG = {"svg.hashsalt": "symscrew", "svg.fonttype": "path"}


def save_study_plots(study: Study, directory: Path) -> list[Path]:
    """`<study>.png` and `<study>.svg`; nothing where no point can be drawn."""
    if not any(_drawn(p, study) for p in study.points):
        return []
    import matplotlib

    figure = work_precision(study)
    written = []
    with curve_style(), matplotlib.rc_context(SVG):  # type: ignore[arg-type, unused-ignore]
        for kind, metadata in (("png", {"Software": None}), ("svg", {"Date": None})):
            path = directory / f"{study.name}.{kind}"
            drawn = partial(figure.savefig, dpi=DPI, metadata=metadata, bbox_inches="tight", pad_inches=0.04)
            written.append(replaced(path, drawn))
    return written


def work_precision(study: Study) -> Figure:
    """Error over cost; a frame per panel of the points, and where points tell a step h, one more over h."""
    if study.cost_unit == "operations" or study.name == "precision":
        return _settings_figure(study)
    if any("N" in p.facts for p in study.points):
        return _growth_figure(study)
    panels = list(dict.fromkeys(str(p.facts.get("panel", "")) for p in study.points if _drawn(p, study)))
    stepped = any("h" in p.facts for p in study.points)
    count = len(panels) + stepped
    rows = max(len(_of_panel(study, panel)) for panel in panels)
    rows = rows if count > 1 and panels != [""] else -(-rows // _columns(study, count))
    with curve_style():
        made = Figure(figsize=((0.6 + 3.1 * count) if count > 1 else 5.0, 2.7 + 0.145 * rows), layout="constrained")
        FigureCanvasAgg(made)
        axes = made.subplots(1, count, sharey=True, squeeze=False)[0]
        for axis in axes[1 : len(panels)]:
            axis.sharex(axes[0])
        kinds: dict[str, int] = {}
        for axis, panel in zip(axes, panels, strict=False):
            for name, points in _of_panel(study, panel).items():
                text = name.removeprefix(f"{panel}, ")
                k = kinds.setdefault(text, len(kinds))
                _draw(axis, [(*_cost(p, study), p) for p in points if _drawn(p, study)], _look(k, points), text)
                if stepped:
                    found = [p for p in points if "h" in p.facts and p.error is not None]
                    _draw(axes[-1], [(float(p.facts["h"]), 0.0, 0.0, p) for p in found], _look(k, points), text)
            axis.set_xlabel(f"{study.cost_label}  [{study.cost_unit}]")
        axes[0].set_ylabel(
            study.error_label.replace(" of ", "\nof ", 1) if len(study.error_label) > 42 else study.error_label
        )
        if stepped:
            axes[-1].set_xlabel("step $h$  [s]")
        for axis in axes:
            _finish(axis)
        _reference_line(axes, study)
        if panels == [""]:
            handles, labels = axes[0].get_legend_handles_labels()
            made.legend(handles, labels, loc="outside upper center", ncols=_columns(study, count))
        else:
            for axis, panel in zip(axes, panels, strict=False):
                if not axis.get_legend_handles_labels()[1]:
                    continue
                axis.legend(loc="lower left", bbox_to_anchor=(-0.02, 1.0), title=panel, alignment="left", fontsize=6.8)
    return made


def _columns(study: Study, count: int) -> int:
    """Of a legend above `count` frames."""
    return 3 if count > 1 or max(map(len, study.curves)) < 24 else 1


def _growth_figure(study: Study) -> Figure:
    """Time per simulated second over the number of loops, beside lines of slope 1; operations over the same."""
    series: dict[str, list[Point]] = {}
    for point in study.points:
        if point.cost is not None:
            series.setdefault(str(point.facts["series"]), []).append(point)
    dashes: dict[str, Any] = {"color": "#808080", "linewidth": 0.8, "linestyle": (0, (5, 2))}
    with curve_style():
        made = Figure(figsize=(6.4, 2.8), layout="constrained")
        FigureCanvasAgg(made)
        axes = made.subplots(1, 2, squeeze=False)[0]
        for k, (name, found) in enumerate(series.items()):
            n = np.array([float(p.facts["N"]) for p in found])
            times = np.array([UNITS[study.cost_unit] * p.cost.median for p in found if p.cost is not None])
            operations = np.array([float(p.facts["operations"]) for p in found])
            for axis, values, text in ((axes[0], times, name), (axes[1], operations, "counted"))[: 2 - k]:
                axis.plot(n, values[-1] * n / n[-1], label=None if k else "linear", **dashes)
                axis.plot(n, values, label=text, **_look(k, found))
        labels = (f"{study.cost_label}  [{study.cost_unit}]", "operations of forward dynamics")
        for axis, label in zip(axes, labels, strict=True):
            axis.set_xlabel("number of loops $N$")
            axis.set_ylabel(label)
            _finish(axis)
            axis.legend(loc="lower left", bbox_to_anchor=(-0.02, 1.0), fontsize=6.8)
    return made


def _of_panel(study: Study, panel: str) -> dict[str, list[Point]]:
    """Curves of a panel that have a point to draw; of many peers the fastest at any error, in groups."""
    found = {
        name: points
        for name, points in study.curves.items()
        if str(points[0].facts.get("panel", "")) == panel and any(_drawn(p, study) for p in points)
    }
    if panel == "peers":
        found |= {name: points for name, points in study.curves.items() if name.startswith("symscrew simulate")}
    if len(found) <= MOST_CURVES:
        return {_peer(name) if points[0].facts.get("peer") else name: points for name, points in found.items()}
    groups: dict[str, list[Point]] = {}
    for name, points in found.items():
        group = name.split()[0]
        if not points[0].facts.get("peer"):
            groups[name] = points
            continue
        groups.setdefault(f"{PEERS.get(group, group)}: best of all settings", []).extend(points)
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


def _settings_figure(study: Study) -> Figure:
    """A colour per curve, a marker per setting; over operations, what has no error is a line."""
    least = NONE if study.cost_unit == "operations" else 0.0
    settings = list(dict.fromkeys(p.setting for p in study.points if _drawn(p, study) and (p.error or 0) > least))
    with curve_style():
        made = Figure(figsize=(6.4, 3.3), layout="constrained")
        FigureCanvasAgg(made)
        axis = made.subplots()
        for k, (name, points) in enumerate(study.curves.items()):
            for point in [p for p in points if _drawn(p, study)]:
                x, low, high = _cost(point, study)
                if (point.error or 0.0) <= least:
                    axis.axvline(x, color=COLOURS[k], linewidth=0.9, linestyle=(0, (5, 2)))
                    axis.annotate(
                        f"{name}: {point.setting}", (x, 0.03), xycoords=("data", "axes fraction"), rotation=90,
                        xytext=(-3, 0), textcoords="offset points", ha="right", va="bottom", fontsize=7,
                        color=COLOURS[k],
                    )  # fmt: skip
                    continue
                marker = MARKERS[settings.index(point.setting) % len(MARKERS)]
                bars = np.array([[low], [high]]) if low + high > 0 else None
                look: dict[str, Any] = {"marker": marker, "color": COLOURS[k], "linestyle": "none", "markersize": 6}
                look |= {"markerfacecolor": "none"}  # settings at one place are all seen
                axis.errorbar(x, float(point.error or 0.0), xerr=bars, elinewidth=0.6, capsize=1.5, **look)
        axis.set_ylabel(study.error_label.replace(" / ", "\n/ "))
        axis.set_xlabel(_abscissa(study))
        _finish(axis)
        for k, setting in enumerate(settings):
            look = {"marker": MARKERS[k % len(MARKERS)], "color": "#505050", "markerfacecolor": "none"}
            axis.plot([], [], linestyle="none", label=setting, **look)
        for k, name in enumerate(study.curves):
            axis.plot([], [], color=COLOURS[k], linewidth=3, label=name)
        made.legend(loc="outside right upper")
    return made


def _abscissa(study: Study) -> str:
    return study.cost_label if study.cost_unit == "operations" else f"{study.cost_label}  [{study.cost_unit}]"


def _look(k: int, points: Sequence[Point]) -> dict[str, Any]:
    peer = any(p.facts.get("peer") for p in points)
    return {
        "color": COLOURS[k % len(COLOURS)],
        "marker": MARKERS[k % len(MARKERS)],
        "markersize": 3.8,
        "linestyle": "none" if points[0].curve == PUBLISHED else (0, (1.2, 1.2)) if peer else "-",
        "linewidth": 0.9,
        "markerfacecolor": "white" if peer or (k // len(COLOURS)) % 2 else COLOURS[k % len(COLOURS)],
        "markeredgewidth": 0.8,
    }


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


def _draw(axis: Axes, found: list[tuple[float, float, float, Point]], look: dict[str, Any], name: str) -> None:
    if not found:
        return
    x, low, high = (np.array([entry[k] for entry in found]) for k in range(3))
    y = np.array([max(entry[3].error or 0.0, FLOOR) for entry in found])
    bars = np.stack([np.maximum(low, 0.0), np.maximum(high, 0.0)]) if (low + high).any() else None
    axis.errorbar(x, y, xerr=bars, label=name, elinewidth=0.6, capsize=1.5, **look)


def _finish(axis: Axes) -> None:
    axis.set_xscale("log")
    axis.set_yscale("log")
    low, high = axis.get_xlim()
    if high < 12 * low:  # a decade at least, so that there are numbers on the axis
        middle = np.sqrt(low * high)
        axis.set_xlim(middle / 3.6, middle * 3.6)
    axis.yaxis.set_major_locator(LogLocator(numticks=10))
    span = np.log10(axis.get_xlim()[1] / axis.get_xlim()[0])
    if span < 1.5:
        axis.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.grid(visible=True, which="major")


def _reference_line(axes: Sequence[Axes], study: Study) -> None:
    """The reference's own error, where it is within the picture."""
    own = study.reference_error
    if own is None or own <= 0:
        return
    low, high = axes[0].get_ylim()
    if not 1e-3 * low < own < high:
        return
    for axis in axes:
        axis.set_ylim(min(low, own / 3), high)
        axis.axhline(own, color="#808080", linewidth=0.7, linestyle=(0, (6, 3)), zorder=1)
    axes[0].annotate(
        "error of the reference", (0.015, own), xycoords=("axes fraction", "data"), xytext=(0, 2),
        textcoords="offset points", ha="left", va="bottom", fontsize=7, color="#606060",
    )  # fmt: skip
