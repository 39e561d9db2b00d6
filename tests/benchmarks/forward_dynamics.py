"""Time of the generated forward dynamics against Pinocchio and MuJoCo, after the accelerations have agreed.

Pinocchio and MuJoCo are called from Python; the time of the same call on a model with a single joint is taken off, so
that the call itself does not count. Pinocchio closes the universal joint of the seed's first limb by two further
revolute joints with an inertia of 1e-9 kg m^2 and a rigid constraint of six rows; its proximal solver agrees to 1e-4.
MuJoCo's constraints are soft: its accelerations are not those of a rigid closed chain, and only its time is given.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.formats import by_suffix
from symscrew.model import Model, derive
from symscrew.runtime.compiled import load
from symscrew.studies.benchmark.pinocchio_closed import PROXIMAL, closed, less_overhead, serial
from symscrew.studies.benchmark.pinocchio_tree import pinocchio_tree
from symscrew.studies.timing import Times, interleaved

from .inverse_dynamics import generated
from .states import consistent_states
from .tables import table

Array = np.ndarray
STATES = 64
AGREEMENT = {"three_ups_upu_s_physical": PROXIMAL, "panda": 1e-9}
OURS = "symscrew"
CLEAR = 0.02  # least constraint margin


def run(*, repeats: int = 25) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    rows, raw = [], {}
    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
        for name in AGREEMENT:
            times, agreement = _case(name, Path(folder), repeats)
            raw[name] = {"times": {k: t.as_json() for k, t in times.items()}, "agreement": agreement}
            for variant, found in times.items():
                ratio = f"{found.median / times[OURS].median:.1f}"
                said = f"{agreement[variant]:.0e}" if variant in agreement else ""
                rows.append([name, variant, f"{found.least:.3g}", found.text, ratio, said])
    header = ["mechanism", "forward dynamics by", "least ns", "median ns (quartiles)", "times ours", "difference"]
    return f"{STATES} states each, {repeats} interleaved repeats.\n\n{table(header, rows)}", {"cases": raw}


def _case(name: str, folder: Path, repeats: int) -> tuple[dict[str, Times], dict[str, float]]:
    model = derive(catalogue.load(name))
    q, v, a = _away_from_singularities(model, *consistent_states(model, load(model), 2 * STATES))
    (u,), status = model("inverse_dynamics", q, v, a)
    assert not status.any()
    measure, found = generated(model, (q, v, u), "forward_dynamics")
    measures: dict[str, Callable[[], float]] = {OURS: measure}
    tree = pinocchio_tree(model.mechanism)
    agreement = {OURS: float(np.abs(found - a).max() / np.abs(a).max())}
    variant = f"Pinocchio: {'constraintDynamics' if tree.cuts else 'aba'}"
    measures[variant], result = closed(model, tree, (q, v), u) if tree.cuts else serial(tree, (q, v, u))
    wanted = tree.states(q, v, a)[2]
    agreement[variant] = float(np.abs(result - wanted).max() / np.abs(wanted).max())
    if not agreement[variant] < AGREEMENT[name]:
        raise RuntimeError(f"{name}: {variant} differs by {agreement[variant]:.1e}; nothing to compare")
    measures["MuJoCo: mj_forward"] = _mujoco(model, folder)
    return interleaved(measures, repeats), agreement


def _away_from_singularities(model: Model, *arrays: Array) -> list[Array]:
    """The first states that are not close to a constraint singularity: there the proximal solver loses digits."""
    clear = np.ones(len(arrays[0]), dtype=bool)
    if "constraint_margin" in model.programs:
        (margins,), _ = model("constraint_margin", arrays[0])
        clear = np.abs(margins).min(axis=1) > CLEAR
    return [x[clear][:STATES] for x in arrays]


def _mujoco(model: Model, folder: Path) -> Callable[[], float]:
    import mujoco

    path = folder / f"{model.name}.xml"
    by_suffix.save_as(model.mechanism, path)
    made = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(made)
    least = mujoco.MjModel.from_xml_string(
        "<mujoco><worldbody><body><joint/><geom size='0.1'/></body></worldbody></mujoco>"
    )
    small = mujoco.MjData(least)
    data.qvel[:] = 0.01
    rows: list[tuple] = [(made, data)] * STATES
    return less_overhead(mujoco.mj_forward, rows, lambda: mujoco.mj_forward(least, small))
