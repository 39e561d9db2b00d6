"""Figures in one style: those of the source paper's section 5 and the accuracy of what they show.

Curves differ in colour (a palette that survives colour blindness), dash pattern and, where methods are
compared, markers. Functions return figures; `save_figure` writes them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from symscrew.whole_files import replaced

Array = np.ndarray

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00")
DASHES: tuple[Any, ...] = (
    "-",
    (0, (5, 1.6)),
    (0, (1.2, 1.2)),
    (0, (6, 1.5, 1.2, 1.5)),
    (0, (9, 2)),
    (0, (3, 1, 1, 1, 1, 1)),
)

STYLE: dict[str, Any] = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9.0,
    "axes.titlesize": 9.0,
    "axes.labelsize": 9.0,
    "legend.fontsize": 7.8,
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "axes.linewidth": 0.6,
    "lines.linewidth": 1.15,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.top": True,
    "ytick.right": True,
    "xtick.major.width": 0.5,
    "ytick.major.width": 0.5,
    "axes.grid": True,
    "grid.linewidth": 0.35,
    "grid.color": "#d0d0d0",
    "axes.axisbelow": True,
    "legend.frameon": False,
    "legend.handlelength": 2.1,
    "legend.columnspacing": 0.9,
    "legend.handletextpad": 0.5,
    "legend.borderaxespad": 0.3,
    "axes.formatter.useoffset": False,
    "axes.formatter.limits": (-4, 5),
}
LETTERS, LINE = 120, 5  # of a legend across a figure; what the piece of line before a name takes of them
DPI = 200  # of pictures: sharp in print


def curve_style() -> Any:
    """The context in which everything is drawn and saved."""
    return matplotlib.rc_context(STYLE)  # type: ignore[arg-type, unused-ignore]


TIME = "$t$  [s]"


@dataclass(frozen=True)
class Curve:
    """A named curve over time; `unit` decides which curves may share an axis."""

    name: str
    values: Array
    unit: str


def empty_figure(rows: int, columns: int, *, width: float = 7.0, height: float = 2.1) -> tuple[Figure, list[Axes]]:
    """An empty figure of small axes with a common time axis; `height` [in] is that of one row."""
    with curve_style():
        made = Figure(figsize=(width, rows * height + 0.25), layout="constrained")
        FigureCanvasAgg(made)
        axes = [made.add_subplot(rows, columns, k + 1) for k in range(rows * columns)]
    return made, axes


def save_figure(made: Figure, path: Path, *, tight: bool = False) -> Path:
    """Write a figure as PNG, PDF or SVG, whole or not at all, without empty margins if `tight`.

    Equal figures give equal bytes: no date, no version of who wrote it, names in an SVG by their content.
    """
    silent = {".pdf": ("CreationDate", "Creator", "Producer"), ".svg": ("Date", "Creator")}
    with curve_style(), matplotlib.rc_context({"svg.hashsalt": "symscrew"}):
        look: dict[str, Any] = {"dpi": DPI, "bbox_inches": "tight" if tight else None, "pad_inches": 0.04}
        look["metadata"] = dict.fromkeys(silent.get(path.suffix, ("Software",)))
        if path.suffix == ".png" and not tight:  # `savefig` would draw it twice, first for nothing but the layout
            made.dpi = DPI
            canvas: Any = FigureCanvasAgg(made)  # whose functions have no types
            return replaced(path, lambda part: canvas.print_png(part, metadata=look["metadata"]))
        return replaced(path, lambda part: made.savefig(part, **look))


def draw_curves(axes: Axes, t: Array, curves: Sequence[Curve], *, title: str, label: str, columns: int = 3) -> None:
    """Curves in one frame, with a title above it and a legend over the curves."""
    with curve_style():
        for k, curve in enumerate(curves):
            look = {"color": COLOURS[k % len(COLOURS)], "linestyle": DASHES[(k + k // len(COLOURS)) % len(DASHES)]}
            axes.plot(t, curve.values, label=curve.name, **look)
        axes.set_title(title, loc="left", pad=3)
        axes.set_ylabel(label, labelpad=2)
        axes.set_xlim(float(t[0]), float(t[-1]))
        axes.xaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10]))
        _room_for_legend(axes, curves, columns)
        if curves:
            axes.legend(loc="upper center", ncols=min(columns, len(curves)))


def _room_for_legend(axes: Axes, curves: Sequence[Curve], columns: int) -> None:
    """Limits of the ordinate that leave the legend's rows free of curves."""
    if not curves:
        return
    low = min(float(c.values.min()) for c in curves)
    high = max(float(c.values.max()) for c in curves)
    span = (high - low) or max(abs(high), 1.0)
    rows = -(-len(curves) // columns)
    axes.set_ylim(low - 0.07 * span, high + (0.07 + 0.155 * rows) * span)


def joint_figure(t: Array, groups: Mapping[str, Sequence[Curve]], *, rate: bool) -> Figure:
    """All joint displacements or rates (figures 7 and 8): angles by limb, all sliders together."""
    suffix = "/s" if rate else ""
    panels = [(title, [c for c in curves if c.unit.startswith("rad")]) for title, curves in groups.items()]
    sliders = [c for curves in groups.values() for c in curves if c.unit.startswith("m")]
    count = len(panels) + bool(sliders)
    columns = min(3, count)
    rows = -(-count // columns)
    made, axes = empty_figure(rows, columns, height=2.25)
    what = "angular rate" if rate else "angle"
    for k, (frame, (title, curves)) in enumerate(zip(axes, panels, strict=False)):
        draw_curves(frame, t, curves, title=f"({_letter(k)}) {title}", label=f"{what}  [rad{suffix}]")
    if sliders:
        what = "sliding velocity" if rate else "slider length"
        draw_curves(
            axes[len(panels)],
            t,
            sliders,
            title=f"({_letter(len(panels))}) sliders",
            label=f"{what}  [m{suffix}]",
            columns=2,
        )
    _finish(axes, count, columns)
    return made


def drive_figure(t: Array, cases: Mapping[str, tuple[Sequence[Curve], Array]]) -> Figure:
    """Drive forces (figure 9): method A as lines, method B as markers; below, the difference.

    `cases`: title -> (curves of method A, values (n, drives) of method B).
    """
    made, axes = empty_figure(2, len(cases), height=2.3)
    every = max(1, len(t) // 20)
    for k, (title, (curves, other)) in enumerate(cases.items()):
        upper, lower = axes[k], axes[len(cases) + k]
        draw_curves(upper, t, curves, title=f"({_letter(k)}) {title}", label="drive force  [N]", columns=4)
        with curve_style():
            for j in range(len(curves)):
                marks = slice((j * every) // len(curves), None, every)
                upper.plot(
                    t[marks], other[marks, j], linestyle="none", marker="osD^"[j % 4], markersize=3.4, mfc="white",
                    mec=COLOURS[j % len(COLOURS)], mew=0.8, zorder=3,
                )  # fmt: skip
            difference = np.abs(np.stack([c.values for c in curves], axis=1) - other).max(axis=1)
            middle, largest = _envelope(t, difference)
            lower.semilogy(middle, largest, color=COLOURS[4], linewidth=0.9, drawstyle="steps-mid")
            lower.set_xlim(float(t[0]), float(t[-1]))
            lower.set_ylim(1e-16, 1e-11)
            lower.set_ylabel("max |A − B|  [N]", labelpad=2)
            title = "momentum screws (A) less Newton-Euler (B)"
            lower.set_title(f"({_letter(len(cases) + k)}) {title}", loc="left", pad=3)
    _finish(axes, 2 * len(cases), len(cases))
    return made


def _envelope(t: Array, values: Array, windows: int = 100) -> tuple[Array, Array]:
    """Middle and largest value of equal windows of time; zeros are lifted to fit on a logarithmic axis."""
    parts = np.array_split(np.arange(len(t)), min(windows, len(t)))
    return np.array([t[p].mean() for p in parts]), np.array([max(values[p].max(), 1e-18) for p in parts])


def reaction_figure(t: Array, places: Mapping[str, Sequence[Curve]], *, label: str, across: int = 3) -> Figure:
    """Joint reactions (figure 11): a frame per place, three components each; at most `across` frames side by side."""
    columns = min(across, len(places))
    rows = -(-len(places) // columns)
    made, axes = empty_figure(rows, columns, height=1.95)
    for k, (frame, (title, curves)) in enumerate(zip(axes, places.items(), strict=False)):
        longest = max((len(curve.name) for curve in curves), default=0)
        beside = max(1, min(3, LETTERS // columns // (longest + LINE)))
        draw_curves(frame, t, curves, title=f"({_letter(k)}) {title}", label=label, columns=beside)
    _finish(axes, len(places), columns)
    return made


def assumption_figure(t: Array, demanded: Curve, residual: Curve) -> Figure:
    """The component that the constraint demands, and what is left over when it is assumed to be zero."""
    made, axes = empty_figure(1, 2, height=2.2)
    draw_curves(
        axes[0], t, [demanded], title="(a) demanded by the constraint", label=f"{demanded.name}  [{demanded.unit}]"
    )
    draw_curves(axes[1], t, [residual], title="(b) least squares, eq. (27), if it is zero", label="|S w − V|, unscaled")
    for frame in axes:
        legend = frame.get_legend()
        if legend is not None:
            legend.remove()
        frame.autoscale(axis="y")
    _finish(axes, 2, 2)
    return made


def indexed_symbol(name: str) -> str:
    """A letter with digits as a symbol with an index, anything else as it is.

    >>> indexed_symbol("C4"), indexed_symbol("coupler_middle")
    ('$C_{4}$', 'coupler middle')
    """
    stem = name.rstrip("0123456789")
    if len(stem) != 1:
        return name.replace("_", " ")
    return f"${stem}_{{{name[1:]}}}$" if name[1:] else f"${stem}$"


def _letter(k: int) -> str:
    return "abcdefghijklmnopqrstuvwxyz"[k % 26]


def _finish(axes: Sequence[Axes], used: int, columns: int) -> None:
    """Time labels under the lowest frame of each column; frames that are not used disappear."""
    with curve_style():
        for k, frame in enumerate(axes):
            if k >= used:
                frame.set_visible(False)
            elif k + columns >= used:
                frame.set_xlabel(TIME, labelpad=1)
