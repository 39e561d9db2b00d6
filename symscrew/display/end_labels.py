"""Names of curves at their ends, in their colours, in a column beside the frame: no legend to look up.

curves' ends --levels_apart--> heights of the names, in the order of the ends, none over another --label_ends--> texts
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

BESIDE = 1.035  # where names begin, of the width of the frame
LINE = 1.25  # height of a line of text, of the size of its letters
POINTS_PER_INCH = 72  # of type


@dataclass(frozen=True)
class End:
    """The end of a curve: its name, which may have several lines, where it is, and its colour."""

    name: str
    x: float
    y: float
    colour: str


def label_ends(axes: Axes, ends: Sequence[End], *, size: float = 7.8) -> None:
    """Write names beside a frame whose limits and place are final; a thin line leads to each curve's end.

    `size`: of the letters [points of type].
    """
    if not ends:
        return
    high = axes.bbox.height / axes.figure.dpi * POINTS_PER_INCH
    at = [axes.transAxes.inverted().transform(axes.transData.transform((end.x, end.y)))[1] for end in ends]
    order = sorted(range(len(ends)), key=lambda k: -at[k])
    tall = [(ends[k].name.count("\n") + 1) * LINE * size / high for k in order]
    for k, level in zip(order, levels_apart([at[k] for k in order], tall), strict=True):
        end = ends[k]
        lead = {"arrowstyle": "-", "color": end.colour, "linewidth": 0.5, "alpha": 0.7, "shrinkA": 1.5, "shrinkB": 2.5}
        lead["relpos"] = (0.0, 0.5)
        axes.annotate(
            end.name, (end.x, end.y), xytext=(BESIDE, level), textcoords="axes fraction", color=end.colour,
            fontsize=size, ha="left", va="center", linespacing=1.05, annotation_clip=False, arrowprops=lead,
        )  # fmt: skip


def levels_apart(wanted: Sequence[float], heights: Sequence[float]) -> list[float]:
    """Levels for texts in a column from 1 down to 0, as near to the wanted ones as can be without covering each other.

    Args:
        wanted: levels, falling.
        heights: of the texts.

    Returns:
        The levels of their middles, least squares of the way from the wanted ones. Where all together are higher than
        the column they reach below it.

    >>> levels_apart([0.5, 0.5], [0.2, 0.2])
    [0.6, 0.4]
    """
    tall = np.asarray(heights, dtype=float)
    below = np.concatenate([[0.0], np.cumsum((tall[:-1] + tall[1:]) / 2)])
    blocks: list[list[float]] = []  # [mean, count] of wanted + below, which must not rise: pool adjacent violators
    for value in np.asarray(wanted, dtype=float) + below:
        blocks.append([float(value), 1.0])
        while len(blocks) > 1 and blocks[-1][0] > blocks[-2][0]:
            mean, count = blocks.pop()
            blocks[-1][0] = (blocks[-1][0] * blocks[-1][1] + mean * count) / (blocks[-1][1] + count)
            blocks[-1][1] += count
    flat = np.repeat([mean for mean, _ in blocks], [int(count) for _, count in blocks])
    most, least = 1.0 - tall[0] / 2, below[-1] + tall[-1] / 2
    return [round(float(level), 12) for level in np.minimum(np.maximum(flat, least), most) - below]
