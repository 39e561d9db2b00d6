"""A trajectory in files: .npz with everything, .csv as a table for a controller.

Trajectory --sample--> t, u, joints and their rates at equal times --> file, whole or not at all
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.description import to_toml
from symscrew.errors import DescriptionError
from symscrew.optimisation.joined_plan import JoinedPlan
from symscrew.optimisation.result import Trajectory
from symscrew.whole_files import replaced

FINE = 501  # samples of a file without a rate


def write_plan(trajectory: Trajectory, path: Path, *, rate: float | None = None) -> Path:
    """Write a trajectory to .npz or .csv; the file appears whole or not at all.

    Args:
        trajectory: may be one that is not `ok`, or not judged: `ok` is false in the archive then.
        path: ends in .csv for a table of t, u and all joints' displacements and rates; else an archive of everything.
        rate: samples per second; default 501 samples.
    """
    make = _table if path.suffix == ".csv" else _archive
    return replaced(path, lambda temporary: make(trajectory, temporary, rate))


def write_joined(plan: JoinedPlan, path: Path, *, rate: float | None = None) -> Path:
    """Write the motions of a joined problem to .npz or, those of phases, to .csv; whole or not at all.

    Args:
        plan: may be one that is not `ok`.
        path: ends in .csv for a table over all phases, their ends twice; else an archive with `part1_t`, `part1_q` ...
            as of motions by themselves, and the parts' `starts` [s], `cost`, `ok`, `status`, `problem`.
        rate: samples per second; default 501 samples of every part.

    Raises:
        DescriptionError: a table of load cases, or of phases with other drives or joints.
    """
    if path.suffix != ".csv":
        return replaced(path, lambda temporary: _archive_of_parts(plan, temporary, rate))
    heads = {(*p.drive_labels, *p.model.joint_labels) for p in plan.parts}
    if None in plan.problem.links or len(heads) > 1:
        raise DescriptionError(f"{path.name}: a table takes phases with the same drives and joints; expected .npz")
    return replaced(path, lambda temporary: _table_of(list(zip(plan.starts, plan.parts, strict=True)), temporary, rate))


def _archive_of_parts(plan: JoinedPlan, path: Path, rate: float | None) -> None:
    arrays: dict[str, Any] = {
        "starts": plan.starts, "cost": np.array(plan.cost), "ok": np.array(plan.ok), "status": np.array(plan.status),
        "mechanism": np.array(to_toml(plan.problem.mechanism)), "problem": np.array(plan.problem.text),
    }  # fmt: skip
    for k, part in enumerate(plan.parts, 1):
        own = _arrays(part, rate)
        arrays |= {f"part{k}_{name}": array for name, array in own.items() if name not in ("mechanism", "problem")}
    for k, link in enumerate(plan.links, 1):
        if link is not None:
            arrays |= {
                f"link{k}_before": link.before,
                f"link{k}_behind": link.behind,
                f"link{k}_lost": np.array(link.lost),
            }
    np.savez_compressed(path, **arrays)


def _times(trajectory: Trajectory, rate: float | None) -> np.ndarray:
    count = FINE if rate is None else max(2, round(trajectory.duration * rate) + 1)
    return np.linspace(0.0, trajectory.duration, count)


def _archive(trajectory: Trajectory, path: Path, rate: float | None) -> None:
    np.savez_compressed(path, **_arrays(trajectory, rate))


def _arrays(trajectory: Trajectory, rate: float | None) -> dict[str, Any]:
    samples = trajectory.sample(_times(trajectory, rate))
    model = trajectory.model
    arrays = {
        name: getattr(samples, name) for name in ("t", "y", "y_dot", "y_ddot", "q", "v", "a", "u", "x", "assembled")
    }
    arrays["joints"] = trajectory.of_tree("joint_displacements", samples)
    arrays["joint_rates"] = trajectory.of_tree("joint_rates", samples)
    arrays["reactions"] = trajectory.reactions(samples)
    arrays |= {
        "mesh": trajectory.mesh,
        "points": trajectory.points,
        "u_at_points": trajectory.drives_at_points,
        "multipliers": trajectory.multipliers,
        "bound_multipliers": trajectory.bound_multipliers,
        "y_labels": np.array(trajectory.labels),
        "u_labels": np.array(trajectory.drive_labels),
        "q_labels": np.array([c.label for c in model.system.tree.q]),
        "v_labels": np.array([c.label for c in model.system.tree.v]),
        "joint_labels": np.array(model.joint_labels),
        "joint_names": np.array(list(model.system.mechanism.joints)),
        "cost": np.array(trajectory.cost),
        "ok": np.array(bool(trajectory.ok)),  # a plan that was not judged is not good yet
        "solved": np.array(trajectory.solved),
        "status": np.array(trajectory.status),
        "mechanism": np.array(to_toml(trajectory.problem.mechanism)),
        "problem": np.array(trajectory.problem.text),
    }
    return arrays | {f"parameter_{name}": np.array(value) for name, value in trajectory.parameters.items()}


def _table(trajectory: Trajectory, path: Path, rate: float | None) -> None:
    _table_of([(0.0, trajectory)], path, rate)


def _table_of(motions: Sequence[tuple[float, Trajectory]], path: Path, rate: float | None) -> None:
    """A table of motions, each from its own time on."""
    trajectory = motions[0][1]
    model = trajectory.model
    header = ["t", *(f"u_{label}" for label in trajectory.drive_labels)]
    header += [f"s_{label}" for label in model.joint_labels] + [f"s_dot_{label}" for label in model.joint_labels]
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        for began, motion in motions:
            samples = motion.sample(_times(motion, rate))
            joints, rates = (motion.of_tree(name, samples) for name in ("joint_displacements", "joint_rates"))
            for row in np.column_stack([began + samples.t, samples.u, joints, rates]):
                writer.writerow([repr(float(value)) for value in row])
