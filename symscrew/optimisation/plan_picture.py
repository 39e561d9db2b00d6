"""A figure of a trajectory: coordinates, rates, drives with their bounds, and the replay."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from symscrew.display import TIME, Curve, draw_curves, empty_figure, save_figure
from symscrew.optimisation.result import Replay, Trajectory


def plot_plan(trajectory: Trajectory, path: Path, replayed: Replay | None = None) -> Path:
    """A figure of the motion: coordinates, their rates, drives with bounds, and the replay where there is one.

    Returns the path, whose file is written whole or not at all. Needs matplotlib.
    """
    samples = trajectory.sample(count=401)
    made, axes = empty_figure(3, 1, width=7.0, height=2.2)
    tree = {c.label: c.unit for c in trajectory.model.system.tree.q}
    labels = trajectory.labels
    units = sorted({tree[label] for label in labels})
    unit = ", ".join(units)
    curves = [Curve(label, samples.y[:, k], unit) for k, label in enumerate(labels)]
    draw_curves(
        axes[0],
        samples.t,
        curves,
        title="Independent coordinates" + (" (dots: replayed by forward simulation)" if replayed is not None else ""),
        label=f"y [{unit}]",
    )
    if replayed is not None:
        axes[0].plot(replayed.t, replayed.y, ".", color="0.3", markersize=2.5)
    curves = [Curve(label, samples.y_dot[:, k], unit) for k, label in enumerate(labels)]
    draw_curves(axes[1], samples.t, curves, title="Their rates", label=f"y_dot [{unit}/s]")
    system = trajectory.model.system
    slides = {system.mechanism.joints[j].kind.freedoms[k].prismatic for j, k in system.drives}
    unit = ", ".join("N" if slide else "N m" for slide in sorted(slides, reverse=True))
    curves = [Curve(label, samples.u[:, k], unit) for k, label in enumerate(trajectory.drive_labels)]
    draw_curves(axes[2], samples.t, curves, title="Drives and their bounds", label=f"u  [{unit}]", columns=4)
    axes[2].set_xlabel(TIME)
    bounds = {b for label in trajectory.drive_labels for b in trajectory.model.drive_range(label) if np.isfinite(b)}
    for bound in sorted(bounds):
        axes[2].axhline(bound, color="0.6", linewidth=0.8, linestyle="--")
    return save_figure(made, path, tight=True)
