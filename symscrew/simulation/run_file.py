"""A run as files: NumPy archive, table of comma-separated values; and in a few lines.

Run --> .npz (everything, with the texts of mechanism and scene) or .csv (a column per number) or sentences
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from symscrew.description import to_toml
from symscrew.errors import DescriptionError
from symscrew.simulation.motion import Run
from symscrew.simulation.recording import shown_time
from symscrew.simulation.run_columns import labels_of
from symscrew.whole_files import replaced

FORMATS = (".npz", ".csv")  # ends of names of files that a run can be written into


def write_run(run: Run, path: Path) -> Path:
    """Write a run into a .npz or .csv file; a file that is not finished never has its name.

    Units are SI; columns are named by `t`, `q.LABEL`, `v.LABEL`, `u.LABEL`, `x.LABEL`, energies and errors.

    Raises:
        DescriptionError: the name ends in something else.
    """
    if path.suffix not in FORMATS:
        raise DescriptionError(f"expected a file name that ends in .npz or .csv, got {path.name!r}")
    return run.columns.save(path) if path.suffix == ".csv" else replaced(path, lambda target: _archive(run, target))


def labels(run: Run) -> dict[str, list[str]]:
    """Labels of the columns of q, v and u."""
    return labels_of(run.model, driven=run.u.shape[1] > 0)


def arrays(run: Run) -> dict[str, np.ndarray]:
    """Everything that the archive holds, by name."""
    names = labels(run)
    text = {
        "mechanism": to_toml(run.scene.mechanism),
        "scene": run.scene.text,
        "status": run.verdict or run.status,
        "backend": run.backend,
        "assembly_mode": run.mode,
        "assembly_mode_at_start": run.modes[0],
        "assembly_mode_at_end": run.modes[1],
    }
    result = {
        "t": run.t, "q": run.q, "v": run.v, "u": run.u, "x": run.x, "energy": run.energy,
        "closure_error": run.closure_error, "energy_balance": run.energy_balance,
        "ok": np.array(run.ok and run.accurate),
        "crossing_times": np.array([c.t for c in run.crossings]),
        "crossing_configurations": np.array([c.q for c in run.crossings]).reshape(len(run.crossings), run.q.shape[1]),
        "crossing_rows": np.array([" ".join(c.rows) for c in run.crossings], dtype=str),
        "events": np.array(list(run.events), dtype=str),
        **{f"{key}_labels": np.array(value, dtype=str) for key, value in names.items()},
        "x_labels": np.array(list(run.x_labels), dtype=str),
        "joint_names": np.array(list(run.model.mechanism.joints), dtype=str),
        **{key: np.array(value) for key, value in text.items()},
    }  # fmt: skip
    if run.reactions is not None:
        result["reactions"] = run.reactions
    return result


def _archive(run: Run, path: Path) -> None:
    np.savez_compressed(path, **arrays(run))  # type: ignore[arg-type]


def run_summary(run: Run) -> list[str]:
    """What a person wants to know about a run, line by line."""
    kinetic = float(run.energy[:, 0].max(initial=0.0))
    lines = [
        f"{run.scene.name}: {run.verdict or run.status}",
        f"{len(run.t)} outputs to t = {shown_time(run.t[-1])} s; " + ", ".join(
            f"{int(n)} {key} steps" if key == "careful" else f"{int(n)} {key}"
            for key, n in run.counters.items()
            if key in ("steps", "rejected", "careful", "evaluations") and (n or key == "steps")
        ),
        f"loops open by at most {run.closure_error.max(initial=0.0):.2e} (lengths by the characteristic length)",
        f"energy balance: at most {np.abs(run.energy_balance).max(initial=0.0):.2e} J, largest kinetic energy "
        f"{kinetic:.4g} J",
    ]  # fmt: skip
    if run.estimate is not None and np.isfinite(run.estimate.error):
        asked = "" if run.scene.integrator.step else f", asked for: {run.scene.integrator.tolerance:g}"
        lines.append(f"estimated error: {run.estimate.error:.1e} (rad, lengths by the characteristic length){asked}")
    lines += [f"impacts at {name} took {loss:.9g} J" for name, loss in run.losses.items()]
    start, end = run.modes
    if start:
        same = "the same at start and end" if start == end else f"at the start; {end} at the end"
        lines.append(f"assembly mode: {f'{run.mode}; ' if run.mode else ''}{start}, {same}")
    names = labels(run)["q"]
    for c in run.crossings:
        place = ", ".join(f"{n} = {value:.6g}" for n, value in list(zip(names, c.q, strict=True))[:8])
        lines.append(
            f"singular configuration passed at t = {shown_time(c.t)} s: {c.lost} row{'s' * (c.lost != 1)} of the "
            f"closure lost, among {', '.join(c.rows)}; at {place}{', ...' if len(names) > 8 else ''}"
        )
    lines += list(run.events[:40]) + ([f"... {len(run.events)} events"] if len(run.events) > 40 else [])
    return lines
