"""A run as a picture: coordinates, rates, drives, energies and errors over time.

Run --a frame per kind of quantity--> PNG
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from symscrew.display import TIME, Curve, curve_style, draw_curves, empty_figure, save_figure
from symscrew.simulation.motion import Run
from symscrew.simulation.run_file import labels

# what curves of a unit are called, by q, v and u
NAMES = {
    "q": {"rad": "angle", "1": "quaternion", "m": "length"},
    "v": {"rad/s": "angular rate", "m/s": "sliding velocity"},
    "u": {"N": "drive force", "N m": "drive torque"},
}
MOST = 12  # curves in a frame that a legend can name; beyond it the title gives their number
FLOOR = 1e-18  # errors of zero are drawn there, on a logarithmic axis


def plot_run(run: Run, path: Path) -> Path:
    """Draw a run: a frame for each kind of coordinate, rate and drive, for the energies and for the errors.

    Returns the path, whose PNG is written whole or not at all. Needs matplotlib.
    """
    frames = [*_frames(run), _energies(run), _errors(run)]
    made, axes = empty_figure(-(-len(frames) // 2), 2, width=10.0, height=2.3)
    for place, (title, label, curves, logarithmic) in zip(axes, frames, strict=False):
        draw_curves(place, run.t, curves, title=title, label=label, columns=4)
        if len(curves) > MOST and (legend := place.get_legend()) is not None:
            legend.remove()
            place.autoscale(axis="y")
        if logarithmic:
            place.set_yscale("log")
            place.set_ylim(FLOOR, 1e3 * max(curve.values.max() for curve in curves))  # room for the legend
        for crossing in run.crossings:
            place.axvline(crossing.t, color="0.5", linewidth=0.8, linestyle=":")
        place.set_xlabel(TIME, labelpad=1)
    for place in axes[len(frames) :]:
        place.set_visible(False)
    crossed = "; dotted: singular configuration passed" if run.crossings else ""
    with curve_style():
        made.suptitle(f"{run.scene.name}: {run.status}{crossed}", fontsize=9)
    return save_figure(made, path)


Frame = tuple[str, str, Sequence[Curve], bool]


def _frames(run: Run) -> list[Frame]:
    """(title, label of the ordinate, curves, whether logarithmic) of every kind of coordinate, rate and drive."""
    tree = run.model.system.tree
    drives = next((p for p in run.model.programs["forward_dynamics"].inputs if p.name == "u"), None)
    units = {"q": [c.unit for c in tree.q], "v": [c.unit for c in tree.v]}
    units["u"] = list(drives.units) if drives is not None and run.u.any() else []
    values, named = {"q": run.q, "v": run.v, "u": run.u}, labels(run)
    found: list[Frame] = []
    for key, kinds in NAMES.items():
        for unit, name in kinds.items():
            curves = [Curve(named[key][k], values[key][:, k], u) for k, u in enumerate(units[key]) if u == unit]
            if curves:
                many = f": {len(curves)} curves, named in the file of the run" if len(curves) > MOST else ""
                found.append((f"{name}s{many}" if not name.endswith("y") else f"{name[:-1]}ies{many}",
                              f"{name}  [{unit}]", curves, False))  # fmt: skip
    return found


def _energies(run: Run) -> Frame:
    curves = [Curve(name, run.energy[:, k], "J") for k, name in enumerate(("kinetic", "potential"))]
    return "energies", "energy  [J]", [*curves, Curve("sum", run.energy.sum(axis=1), "J")], False


def _errors(run: Run) -> Frame:
    loops = run.closure_error.any()  # a tree has none to open
    opening = [Curve("opening of the loops  [1]", np.maximum(run.closure_error, FLOOR), "1")] if loops else []
    balance = Curve("energy balance  [J]", np.maximum(np.abs(run.energy_balance), FLOOR), "J")
    return "errors", "error  [1], [J]" if loops else "error  [J]", [*opening, balance], True
