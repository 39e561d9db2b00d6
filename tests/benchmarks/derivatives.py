"""Time of generated derivatives, mass matrices and regressors; of serial arms against Pinocchio, which must agree.

Pinocchio is called from Python, less the time of the same call for a tree of one joint: its headers with
derivatives take gigabytes and many minutes to compile. Closed chains are timed without a peer: version 4.1 has
no constraint for the rotation of a universal joint, and its derivatives under 3-D loop closures differ from
central differences on the manifold.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.model import Model, derive
from symscrew.runtime.compiled import load
from symscrew.studies.benchmark.pinocchio_build import python_model
from symscrew.studies.benchmark.pinocchio_closed import less_overhead
from symscrew.studies.benchmark.pinocchio_tree import PinocchioTree, pinocchio_tree
from symscrew.studies.timing import Times, interleaved

from .inverse_dynamics import generated
from .states import consistent_states
from .tables import table

CASES = ("three_ups_upu_s_physical", "ur5", "panda")
OPEN = ("mass_matrix", "inverse_dynamics_derivatives", "forward_dynamics_derivatives", "regressor")
CLOSED = (
    "inverse_dynamics_independent_derivatives",
    "forward_dynamics_independent_derivatives",
    "linearisation",
    "regressor",
    "regressor_independent",
)
AGAINST = {
    "mass_matrix": "crba",
    "inverse_dynamics_derivatives": "computeRNEADerivatives",
    "forward_dynamics_derivatives": "computeABADerivatives",
}
# Lean generated C of another derivation, measured by its author (medians in ns; AVX-512 at 3.6 to 4.1 GHz, gcc 12):
# the seed's drives by (q, v, a) from the platform's pose, serial arms by q and v alone, sines and cosines included.
LEAN = {
    ("ur5", "mass_matrix"): 94,
    ("panda", "mass_matrix"): 174,
    ("three_ups_upu_s_physical", "inverse_dynamics_independent_derivatives"): 470,
    ("ur5", "inverse_dynamics_derivatives"): 270,
    ("panda", "inverse_dynamics_derivatives"): 700,
}
RESULTS = {  # of Pinocchio; the last is symmetric
    "crba": ("M",),
    "computeRNEADerivatives": ("dtau_dq", "dtau_dv", "M"),
    "computeABADerivatives": ("ddq_dq", "ddq_dv", "Minv"),
}
STATES = 64
AGREEMENT = 1e-9
Array = np.ndarray


def run(*, repeats: int = 25) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    results: dict[str, Any] = {}
    for name in CASES:
        results[name] = _case(name, repeats)
    rows = []
    for name, found in results.items():
        for variant, times in found["times"].items():
            rows.append([
                name,
                variant,
                found["operations"].get(variant, ""),
                f"{times.least:.3g}",
                times.text,
                f"{times.least / LEAN[name, variant]:.2f}" if (name, variant) in LEAN else "",
                f"{found['agreement'][variant]:.0e}" if variant in found["agreement"] else "",
            ])  # fmt: skip
    header = ["mechanism", "function", "operations", "least ns", "median ns (quartiles)", "least over lean C elsewhere"]
    header.append("relative difference")
    how = f"Pinocchio from Python, less the call's overhead. {STATES} states, {repeats} interleaved repeats."
    text = f"{how}\n\n{table(header, rows)}"
    raw = {
        name: {**found, "times": {k: t.as_json() for k, t in found["times"].items()}} for name, found in results.items()
    }
    return text, {"cases": raw}


def _case(name: str, repeats: int) -> dict[str, Any]:
    model = derive(catalogue.load(name), derivatives=True, regressor=True)
    needed = {f: p for f, p in model.programs.items() if f in ("assemble", "velocity", "acceleration")}
    q, v, a = consistent_states(model, load(replace(model, programs=needed)), STATES)
    functions = CLOSED if model.system.cuts else OPEN
    known = _inputs(model, q, v, a)
    measures: dict[str, Callable[[], float]] = {}
    agreement: dict[str, float] = {}
    for function in functions:
        inputs = tuple(known[p.name] for p in model.programs[function].inputs)
        alone = replace(model, programs={function: model.programs[function]})  # compiling the others takes minutes
        measures[function], values = generated(alone, inputs, function)
        if not model.system.cuts and function in AGAINST:
            variant = f"Pinocchio: {AGAINST[function]}"
            measures[variant], other = _pinocchio(pinocchio_tree(model.mechanism), AGAINST[function], inputs)
            agreement[variant] = float(np.abs(other - values).max() / np.abs(values).max())
            if not agreement[variant] < AGREEMENT:
                raise RuntimeError(f"{name}: {variant} differs by {agreement[variant]:.1e}; nothing to compare")
    times: dict[str, Times] = interleaved(measures, repeats)
    operations = {function: model.programs[function].operations["total"] for function in functions}
    return {"operations": operations, "times": times, "agreement": agreement}


def _inputs(model: Model, q: Array, v: Array, a: Array) -> dict[str, Array]:
    """Every input by its name: independent rates at random, drives of the inverse dynamics."""
    random = np.random.default_rng(2)
    count = model.programs["null_space"].outputs[0].shape[1]
    y_dot, y_ddot = random.uniform(-1, 1, (2, len(q), count))
    (u,), _ = model("inverse_dynamics", q, v, a)
    return {"q": q, "v": v, "a": a, "u": u, "y_dot": y_dot, "y_ddot": y_ddot}


def _pinocchio(tree: PinocchioTree, algorithm: str, states: tuple[Array, ...]) -> tuple[Callable[[], float], Array]:
    """ns per call less that of a tree of one joint, and its matrices per state, column-major."""
    import pinocchio

    model, least = (python_model(pinocchio, tree, n) for n in (len(tree.elements), 1))
    data, least_data = model.createData(), least.createData()
    call = getattr(pinocchio, algorithm)
    padded = (*states, *(np.zeros_like(states[0]) for _ in range(3 - len(states))))
    rows = [row[: len(states)] for row in zip(*tree.states(*padded), strict=True)]
    results = []
    for row in rows:
        call(model, data, *row)
        *others, half = (getattr(data, name) for name in RESULTS[algorithm])
        whole = np.triu(half) + np.triu(half, 1).T  # only one half of the symmetric matrix is filled
        results.append(np.concatenate([np.ravel(m, order="F") for m in (*others, whole)]))

    first = [x[:1] for x in rows[0]]
    measure = less_overhead(call, [(model, data, *row) for row in rows], lambda: call(least, least_data, *first))
    return measure, np.array(results)
