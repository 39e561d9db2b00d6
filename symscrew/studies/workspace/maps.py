"""Pictures of a sweep: curves over one axis, maps over two, polar ones over tilt and azimuth."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.display import COLOURS, DASHES, curve_style, save_figure
from symscrew.studies.workspace.plan import AZIMUTH, TILT, Axis, Plan

Results = Mapping[str, np.ndarray]
MOST = 12  # results in a picture, four rows of three; what it leaves out is named below it
VANISHING = 1e-9  # relative: what varies less over the sweep is constant, and has no frame


def draw_maps(plan: Plan, results: Results, units: Mapping[str, str], path: Path) -> Path | None:
    """The picture of a sweep over one or two axes that vary; None where there is nothing to draw."""
    varied = [axis for axis in plan.axes if axis.count > 1]
    found = _names(plan, results)
    if not found:
        return None
    names, rest = found[:MOST], found[MOST:]
    shape = (*(axis.count for axis in plan.axes if axis.count > 1), plan.samples)
    if plan.samples > 1:
        made = _spread(results, names, units, plan.samples)
    elif len(varied) == 1:
        made = _curves(varied[0], results, names, units)
    elif len(varied) == 2:
        shaped = {n: results[n].reshape(shape)[..., 0] for n in [*names, "allowed"]}
        polar = {a.name for a in varied} == {TILT, AZIMUTH}
        made = _maps(varied, shaped, names, units, polar=polar)
    else:
        return None
    if rest:
        made.suptitle(f"not drawn, but in the files: {', '.join(rest)}", fontsize=7, wrap=True)
    return save_figure(made, path)


def _names(plan: Plan, results: Results) -> list[str]:
    """Quality first, then displacements of the drives and their forces: what is no axis and varies."""
    driven = [n for n, j in plan.mechanism.joints.items() if j.driven]
    margins = [n for n in results if n.startswith(("limb ", "constraint ", "actuation "))]
    names = ["margin"] if "margin" in results else margins
    names += ["condition", "stiffness least"]
    names += [n for n in results if n in driven or (n.rpartition(".")[0] in driven and " " not in n)]
    names += [n for n in results if n.startswith("drive ")]
    axes = {axis.name for axis in plan.axes}
    return [n for n in dict.fromkeys(names) if n in results and n not in axes and _varies(results[n])]


def _varies(values: np.ndarray) -> bool:
    finite = values[np.isfinite(values)]
    return bool(len(finite)) and bool(np.ptp(finite) > VANISHING * max(1.0, float(np.abs(finite).max())))


def _logarithmic(values: np.ndarray) -> bool:
    """Whether positive values range over more than two decades."""
    finite = values[np.isfinite(values)]
    return bool(len(finite)) and bool(finite.min() > 0) and bool(finite.max() > 100 * finite.min())


def _label(name: str, units: Mapping[str, str]) -> str:
    unit = units.get(name, "1")
    return f"{name}  [{unit}]"


def _frames(count: int, size: float, *, polar: bool = False) -> tuple[Any, Any]:
    from matplotlib.figure import Figure

    columns = min(3, count)
    rows = -(-count // columns)
    made = Figure(figsize=(2.6 * columns + 0.3, size * rows + 0.2), layout="constrained")
    frames = made.subplots(rows, columns, squeeze=False, subplot_kw={"projection": "polar"} if polar else {}).ravel()
    for axes in frames[count:]:
        axes.set_visible(False)
    return made, frames


def _curves(axis: Axis, results: Results, names: Sequence[str], units: Mapping[str, str]) -> Any:
    with curve_style():
        made, frames = _frames(len(names), 1.9)
        for axes, name in zip(frames, names, strict=False):
            values = results[name].copy()
            axes.plot(axis.values, values, color="#9a9a9a", linestyle=DASHES[2], label="reached")
            values[results["allowed"] == 0] = np.nan
            axes.plot(axis.values, values, color=COLOURS[0], label="allowed")
            axes.set_xlabel(_label(axis.name, units))
            axes.set_ylabel(_label(name, units))
            if _logarithmic(values):
                axes.set_yscale("log")
        frames[0].legend()
    return made


def _maps(axes: Sequence[Axis], shaped: Results, names: Sequence[str], units: Mapping[str, str], *, polar: bool) -> Any:
    from matplotlib.colors import LogNorm, Normalize
    from matplotlib.ticker import MaxNLocator

    with curve_style():
        made, frames = _frames(len(names), 2.35 if polar else 2.2, polar=polar)
        flip = polar and axes[0].name == TILT
        first, second = (axes[1], axes[0]) if flip else (axes[0], axes[1])
        for frame, name in zip(frames, names, strict=False):
            values = shaped[name].T if flip else shaped[name]
            inside = (shaped["allowed"].T if flip else shaped["allowed"]) > 0
            shown = np.where(inside, values, np.nan)
            x, z = np.meshgrid(first.values, second.values, indexing="ij")
            radius = np.degrees(z) if polar else z
            finite = shown[np.isfinite(shown)]
            signed = len(finite) and finite.min() < 0 < finite.max()
            top = float(np.abs(finite).max()) if signed else None
            frame.grid(visible=False)
            frame.set_facecolor("#e6e6e6")
            drawn = frame.pcolormesh(
                x, radius, np.ma.masked_invalid(shown), shading="nearest", rasterized=True,
                cmap="PuOr" if signed else "cividis",
                norm=LogNorm() if _logarithmic(finite) else Normalize(-top if top else None, top),
            )  # fmt: skip
            if not inside.all() and inside.any():
                frame.contour(x, radius, inside.astype(float), levels=[0.5], colors="black", linewidths=0.8)
            made.colorbar(drawn, ax=frame, shrink=0.8, pad=0.12 if polar else 0.02)
            if polar:
                frame.set_title(_label(name, units), pad=10)
                frame.set_rlabel_position(112.5)
                end = float(np.abs(radius).max())
                frame.set_yticks([t for t in MaxNLocator(2, steps=[1, 2, 5, 10]).tick_values(0, end) if 0 < t <= end])
                frame.yaxis.set_major_formatter("{x:g}°")
                frame.set_axisbelow(False)  # or the map hides them
                for text in frame.get_yticklabels():
                    text.set_bbox({"boxstyle": "round,pad=0.1", "facecolor": "white", "alpha": 0.7, "linewidth": 0})
            else:
                frame.set_title(_label(name, units), loc="left", pad=3)
                frame.set_xlabel(_label(first.name, units))
                frame.set_ylabel(_label(second.name, units))
        note = "tilt over azimuth of its axis; grey: not allowed" if polar else "grey: not allowed"
        made.supxlabel(note, fontsize=8)
    return made


def _spread(results: Results, names: Sequence[str], units: Mapping[str, str], samples: int) -> Any:
    """Histograms of what tolerances change, about the mean at each place."""
    with curve_style():
        made, frames = _frames(len(names), 1.8)
        for axes, name in zip(frames, names, strict=False):
            values = results[name].reshape(-1, samples)
            about = (values - np.nanmean(values, axis=1, keepdims=True)).ravel()
            axes.hist(about[np.isfinite(about)], bins=41, color=COLOURS[0])
            axes.set_xlabel(f"deviation of {_label(name, units)}")
            axes.set_ylabel("cases")
    return made
