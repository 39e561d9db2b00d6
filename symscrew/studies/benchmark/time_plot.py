"""The times of functions as bars: rows of `function_times` --draw_times--> PNG."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from symscrew.display import COLOURS, curve_style, empty_figure, save_figure
from symscrew.studies.benchmark.function_times import Row


def draw_times(rows: Sequence[Row], path: Path, name: str) -> Path:
    """Write medians with quartiles, one bar per variant, grouped by function, on a logarithmic scale.

    Args:
        rows: what was timed.
        path: of the picture; its folder is made.
        name: of the mechanism, as title.
    """
    made, (axes,) = empty_figure(1, 1, width=8.0, height=0.6 + 0.22 * len(rows))
    variants = list(dict.fromkeys(row.variant for row in rows))
    with curve_style():
        for place, row in enumerate(rows):
            median = row.times.median
            spread = [[median - row.times.lower], [row.times.upper - median]]
            colour = COLOURS[variants.index(row.variant) % len(COLOURS)]
            axes.barh(place, median, xerr=spread, color=colour, ecolor="0.35", height=0.75)
        axes.set_yticks(range(len(rows)), [f"{row.function}: {row.variant.split(': ')[-1]}" for row in rows])
        axes.invert_yaxis()
        axes.set_xscale("log")
        axes.xaxis.set_minor_formatter("")
        axes.set_xlabel("time per state  [ns], median and quartiles")
        axes.set_title(name, loc="left")
        axes.grid(False, axis="y")
    path.parent.mkdir(parents=True, exist_ok=True)
    return save_figure(made, path)
