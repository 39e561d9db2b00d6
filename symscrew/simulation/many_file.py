"""Many runs as a file and in a few lines.

Runs --> .npz (arrays of all runs, texts by number), JSON values, sentences
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from symscrew.description import to_toml
from symscrew.errors import DescriptionError
from symscrew.simulation.many_runs import Runs
from symscrew.simulation.run_columns import labels_of
from symscrew.whole_files import replaced

TOLD = 10  # runs that are not good and are told one by one; of more the file says it
MOST_IN_JSON = 1000  # the same of `--json`, which a program reads


def write_runs(runs: Runs, path: Path) -> Path:
    """Write runs into a .npz file; a file that is not finished never has its name.

    Arrays are those of `Runs`. Texts that many runs share stand once: `statuses[status]` is the verdict of every run,
    `assembly_modes[assembly_mode_at_start]` its mode; `events` and `crossing_times` of all runs stand one after the
    other, `event_run` and `crossing_run` say of which.

    Raises:
        DescriptionError: the name ends in something else.
    """
    if path.suffix != ".npz":
        raise DescriptionError(f"expected a file name that ends in .npz, got {path.name!r}")

    def write(target: Path) -> None:
        np.savez(target, **arrays_of(runs))  # type: ignore[arg-type]

    return replaced(path, write)


def arrays_of(runs: Runs) -> dict[str, np.ndarray]:
    """Everything that the file holds, by name."""
    found: dict[str, np.ndarray] = {
        "t": runs.t, "q": runs.q, "v": runs.v, "u": runs.u, "x": runs.x, "energy": runs.energy,
        "closure_error": runs.closure_error, "energy_balance": runs.energy_balance, "parameters": runs.parameters,
        "ok": runs.ok, "end": runs.end, "estimated_error": runs.estimated_error,
    }  # fmt: skip
    if runs.reactions is not None:
        found["reactions"] = runs.reactions
    found |= {name: values.astype(np.int64) for name, values in runs.counters.items()}
    found["statuses"], found["status"] = _numbered(list(runs.status))
    both = [mode for pair in runs.modes for mode in pair]
    found["assembly_modes"], numbers = _numbered(both)
    found["assembly_mode_at_start"], found["assembly_mode_at_end"] = numbers[::2], numbers[1::2]
    for one, many, of in (("event", "events", runs.events), ("crossing", "crossing_times", runs.crossings)):
        found[f"{one}_run"] = np.repeat(np.arange(len(runs)), [len(told) for told in of])
        kind = str if one == "event" else float
        found[many] = np.array([item for told in of for item in told], dtype=kind)
    for key, labels in labels_of(runs.model, driven=runs.u.shape[2] > 0).items():
        found[f"{key}_labels"] = np.array(labels, dtype=str)
    found["x_labels"] = np.array(runs.x_labels, dtype=str)
    found["joint_names"] = np.array(list(runs.model.mechanism.joints), dtype=str)
    names = [p.name for p in runs.model.mechanism.parameters.values() if p.run_time]
    found["parameter_names"] = np.array(names, dtype=str)
    texts = {"mechanism": to_toml(runs.scene.mechanism), "scene": runs.scene.text, "backend": runs.backend}
    return found | {key: np.array(text) for key, text in texts.items()}


def _numbered(texts: list[str]) -> tuple[np.ndarray, np.ndarray]:
    """Distinct texts in the order in which they come, and the number of each."""
    order = {text: k for k, text in enumerate(dict.fromkeys(texts))}
    return np.array([*order], dtype=str), np.array([order[text] for text in texts], dtype=np.int64)


def runs_numbers(runs: Runs) -> dict[str, Any]:
    """What `--json` prints."""
    bad = np.flatnonzero(~runs.ok)
    return {
        "scene": runs.scene.name,
        "runs": len(runs),
        "ok": runs.all_ok,
        "good": int(runs.ok.sum()),
        "started": int(np.isfinite(runs.end).sum()),
        "outputs": len(runs.t),
        "backend": runs.backend,
        "threads": runs.threads,
        **{key: value if np.isfinite(value) else None for key, value in _worst(runs).items()},
        "steps": int(runs.counters["steps"].sum()),
        "not_good": [{"run": int(k), "status": runs.status[k]} for k in bad[:MOST_IN_JSON]],
    }


def _worst(runs: Runs) -> dict[str, float]:
    """The largest error, opening and energy balance of all runs; NaN where there is none."""
    found = {}
    for key in ("estimated_error", "closure_error", "energy_balance"):
        values = np.abs(getattr(runs, key))
        known = values[np.isfinite(values)]
        found[key] = float(known.max()) if len(known) else float("nan")
    return found


def runs_summary(runs: Runs) -> list[str]:
    """What a person wants to know about many runs, line by line."""
    good, started, worst = int(runs.ok.sum()), int(np.isfinite(runs.end).sum()), _worst(runs)
    how = f"{runs.threads} thread{'s' * (runs.threads != 1)}"
    lines = [
        f"{runs.scene.name}: {good} of {len(runs)} runs completed as accurately as asked for",
        f"{len(runs.t)} outputs to t = {runs.t[-1]:g} s; {int(runs.counters['steps'].sum())} steps; "
        + (f"compiled, {how}" if runs.backend == "c" else "one after the other, step by step from Python"),
        f"loops open by at most {worst['closure_error']:.2e} (lengths by the characteristic length)",
        f"energy balance: at most {worst['energy_balance']:.2e} J",
    ]
    if np.isfinite(worst["estimated_error"]):
        error = worst["estimated_error"]
        lines.append(f"estimated error: at most {error:.1e} (rad, lengths by the characteristic length)")
    if started < len(runs):
        lines.append(f"{len(runs) - started} of them could not start")
    passed = sum(1 for times in runs.crossings if times)
    if passed:
        lines.append(f"{passed} of them passed singular configurations")
    changed = sum(1 for start, end in runs.modes if start != end)
    if changed:
        lines.append(f"{changed} of them ended in another assembly mode")
    bad = np.flatnonzero(~runs.ok)
    lines += [f"run {k}: {runs.status[k]}" for k in bad[:TOLD]]
    return lines + ([f"... {len(bad)} runs that are not good"] if len(bad) > TOLD else [])
