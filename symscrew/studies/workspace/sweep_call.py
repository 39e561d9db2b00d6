"""A sweep as a call: `workspace(mechanism, {"tilt": "0:20deg:21", "azimuth": "0:360deg:73"})`.

axes --Plan--> pieces, on all cores --around_holes--> results --sweep_summary--> Sweep: results by name, a few numbers
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import notebook
from symscrew.description import Mechanism
from symscrew.effects import Effect, Gravity, given_effects
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.kinds import public
from symscrew.studies.workspace.around import around_holes
from symscrew.studies.workspace.engine import run_locally
from symscrew.studies.workspace.evaluation import check_drawn, prepare_sweep
from symscrew.studies.workspace.map_summary import sweep_summary, sweep_summary_text
from symscrew.studies.workspace.plan import Plan, check_numbers, read_axis, read_limit, read_quantity
from symscrew.studies.workspace.store import save_csv, save_npz


@dataclass(frozen=True, repr=False)
class Sweep:
    """Results of a sweep by name, (cases,) each, with their units; `summary` is what `--json` prints."""

    plan: Plan
    results: Mapping[str, np.ndarray]
    units: Mapping[str, str]
    summary: Mapping[str, Any]

    def __repr__(self) -> str:
        counts = f"{self.summary['reached']} reached, {self.summary['allowed']} allowed"
        return f"Sweep({self.plan.mechanism.name}: {self.plan.count} cases, {counts})"

    def __getitem__(self, name: str) -> np.ndarray:
        """A result over all cases, as an array with an axis per axis of the sweep, and one for samples if several.

        Raises:
            DescriptionError: no result of this name.
        """
        if name not in self.results:
            raise DescriptionError(
                f"expected the name of a result, got {name!r}; {did_you_mean(name, list(self.results))}"
            )
        samples = (self.plan.samples,) if self.plan.samples > 1 else ()
        return self.results[name].reshape(*(axis.count for axis in self.plan.axes), *samples)

    def save(self, path: str | Path) -> Path:
        """Write all results into a .npz or .csv file.

        Raises:
            DescriptionError: the name ends in something else.
        """
        file = Path(path)
        if file.suffix not in (".npz", ".csv"):
            raise DescriptionError(f"expected a file name that ends in .npz or .csv, got {file.name!r}")
        return (save_npz if file.suffix == ".npz" else save_csv)(file, dict(self.results))

    def _repr_html_(self) -> str:
        return notebook.lines(repr(self), sweep_summary_text(dict(self.summary)).splitlines())


@public("workspace")
def workspace(
    mechanism: Mechanism,
    over: Mapping[str, str],
    *,
    effects: Sequence[Effect] = (Gravity(),),
    limits: Mapping[str, str] | None = None,
    tolerances: Mapping[str, str] | None = None,
    samples: int = 100,
    seed: int = 0,
    mode: str = "",
    processes: int | None = None,
    engine: str = "",
) -> Sweep:
    """What a mechanism reaches, and how well, over coordinates and parameters.

    Args:
        mechanism: what is swept.
        over: axis -> "from:to:count", numbers with mm, m, deg or rad: independent coordinates, parameters, tilt,
            azimuth.
        effects: what acts, for the drives at rest.
        limits: result -> "least:largest" of what is allowed.
        tolerances: parameter -> standard deviation of a normal distribution.
        samples: per place, where there are tolerances.
        seed: of the random numbers.
        mode: name of an assembly mode (`symscrew.assembly_modes`) in which the map is; that of the reference if none.
        processes: how many compute; default: one per core.
        engine: "cuda", "jax", "c" or "casadi"; default: the fastest that is there. Numbers are the same to rounding.

    Raises:
        DescriptionError: axes, tolerances or limits that the mechanism does not have, an engine that is not here.
    """
    axes = tuple(read_axis(f"{name}={values}") for name, values in over.items())
    quantities = {name: read_quantity(value, f"tolerance of {name}") for name, value in (tolerances or {}).items()}
    spread = tuple((name, value) for name, (value, _) in quantities.items())
    allowed = [read_limit(f"{name}={value}") for name, value in (limits or {}).items()]
    typed = [("tolerances", name, unit) for name, (_, unit) in quantities.items()]
    typed += [("limits", limit[0], unit) for limit, unit in allowed]
    varied = tuple(dict.fromkeys(n for n in (*over, *(n for n, _ in spread)) if n in mechanism.parameters))
    inputs = {n: replace(p, run_time=p.run_time or n in varied) for n, p in mechanism.parameters.items()}
    plan = Plan(
        replace(mechanism, parameters=inputs) if varied else mechanism,
        given_effects(effects),
        axes,
        tolerances=spread,
        samples=samples if spread else min(samples, 1),
        seed=seed,
        limits=tuple(limit for limit, _ in allowed),
        parameters=varied,
        typed=tuple(typed),
        mode=mode,
        engine=engine,
    )
    check_numbers(plan, processes)
    made = prepare_sweep(plan)
    check_drawn(plan, made.model.mechanism)
    pieces = dict(run_locally(plan, range(plan.chunks), processes))
    results = {name: np.concatenate([pieces[k][name] for k in range(plan.chunks)]) for name in pieces[0]}
    results = around_holes(plan, results)
    return Sweep(plan, results, made.units, sweep_summary(plan, results, made.units, made.engine.text))
