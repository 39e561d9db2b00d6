"""Time of the generated inverse dynamics against Pinocchio, on the same states, after both have agreed."""

from __future__ import annotations

import ctypes
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.model import Model, derive
from symscrew.runtime.compiled import load
from symscrew.studies.benchmark.function_times import single
from symscrew.studies.benchmark.pinocchio_build import (
    PinocchioUnavailableError,
    build_pinocchio,
    open_case,
    python_rnea,
    timed,
)
from symscrew.studies.benchmark.pinocchio_tree import pinocchio_tree
from symscrew.studies.benchmark.timed_code import Compiled
from symscrew.studies.timing import Times, interleaved

from .states import consistent_states
from .tables import table

OURS = "symscrew, from the tree's coordinates"
CASES = ("three_ups_upu_s_physical", "stewart_6ups", "ur5", "panda")
STATES = 256
AGREEMENT = 1e-9
Array = np.ndarray


def run(*, repeats: int = 25) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    results: dict[str, Any] = {}
    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
        try:
            library: ctypes.CDLL | None = build_pinocchio(Path(folder))
            how = "Pinocchio in C++, headers only, built for this processor"
        except PinocchioUnavailableError as reason:
            library = None
            how = f"Pinocchio in C++ could not be built ({reason}): its Python call less the call overhead"
        for name in CASES:
            results[name] = _case(name, Path(folder), library, repeats)
    rows = []
    for name, found in results.items():
        ours: Times = found["times"][OURS]
        for variant, times in found["times"].items():
            rows.append(
                [
                    name,
                    variant,
                    found["operations"].get(variant, ""),
                    f"{times.least:.3g}",
                    times.text,
                    f"{times.median / ours.median:.1f}",
                    f"{found['agreement'][variant]:.0e}" if variant in found["agreement"] else "",
                ]
            )
    header = [
        "mechanism",
        "inverse dynamics by",
        "operations",
        "least ns",
        "median ns (quartiles)",
        "times ours",
        "relative difference",
    ]
    text = f"{how}. {STATES} states each, {repeats} interleaved repeats.\n\n{table(header, rows)}"
    raw = {
        name: {**found, "times": {k: t.as_json() for k, t in found["times"].items()}} for name, found in results.items()
    }
    return text, {"how": how, "cases": raw}


def _case(name: str, folder: Path, library: ctypes.CDLL | None, repeats: int) -> dict[str, Any]:
    model = derive(catalogue.load(name))
    q, v, a = consistent_states(model, load(model), STATES)
    measure, u = generated(model, (q, v, a))
    measures: dict[str, Callable[[], float]] = {OURS: measure}
    others: dict[str, Array] = {}
    operations = {OURS: model.programs["inverse_dynamics"].operations["total"]}
    platform = "inverse_dynamics_platform"
    if platform in model.programs:
        variant = "symscrew, from the platform's motion"
        inputs = _platform_motion(model, platform, (q, v, a))
        measures[variant], others[variant] = generated(model, inputs, platform)
        operations[variant] = model.programs[platform].operations["total"]
    tree = pinocchio_tree(model.mechanism)
    states = tree.states(q, v, a)
    if library is not None:
        opened = open_case(library, tree, folder)
        if opened is None:
            raise RuntimeError(f"{name}: pinocchio_timing.cpp knows no such tree")
        variants = {"Pinocchio: RNEA": 0}
        if tree.cuts:
            lu = 3 * len(tree.cuts)
            variants = {
                f"Pinocchio: RNEA, frame Jacobians, {lu}x{lu} LU": 0,
                "Pinocchio: RNEA, world Jacobian, limb by limb": 1,
            }
        for variant, structured in variants.items():
            measures[variant], others[variant] = timed(library, opened, states, u.shape, structured=structured)
    elif not tree.cuts:
        variant = "Pinocchio from Python, less overhead: RNEA"
        measures[variant], others[variant] = python_rnea(tree, states)
    agreement = {}
    for variant, found in others.items():
        agreement[variant] = float(np.abs(found - u).max() / np.abs(u).max())
        if not agreement[variant] < AGREEMENT:
            raise RuntimeError(f"{name}: {variant} differs by {agreement[variant]:.1e}; nothing to compare")
    times = interleaved(measures, repeats)
    return {"operations": operations, "times": times, "agreement": agreement}


def _platform_motion(model: Model, function: str, states: tuple[Array, Array, Array]) -> tuple[Array, ...]:
    """Pose, rates and accelerations of the platform: the entries of q, v, a with their labels."""
    tree = model.system.tree
    labels = ([c.label for c in tree.q], [c.label for c in tree.v], [c.label for c in tree.v])
    ports = model.programs[function].inputs
    return tuple(
        np.ascontiguousarray(values[:, [names.index(label) for label in port.labels]])
        for values, names, port in zip(states, labels, ports, strict=True)
    )


def generated(
    model: Model, given: Sequence[Array], function: str = "inverse_dynamics"
) -> tuple[Callable[[], float], Array]:
    """A measurement of ns per call of the generated C, and its results (states, entries of all outputs)."""
    compiled = Compiled(replace(model, test_inputs={function: tuple(given)}), [function])
    measure, results = single(compiled, function, len(given[0]))
    return measure, np.concatenate(results, axis=1)
