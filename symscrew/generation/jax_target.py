"""Target "jax": a module of pure functions for JAX, with derivatives of every order."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from symscrew.export import print_jax
from symscrew.generation.numpy_target import imported
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import Results, compare_values, first_path


def files(order: Order) -> Mapping[str, str]:
    """<name>_jax.py."""
    return print_jax(order.model)


def compare(case: Case) -> Iterator[Finding]:
    """The module on the processor, in double precision."""
    if importlib.util.find_spec("jax") is None:
        yield True, "no JAX here (pip install 'symscrew[jax]'): the JAX module was not run"
        return
    import jax

    module = imported(case.fresh / f"{case.model.name}_jax.py")

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        *outputs, status = jax.jit(getattr(module, name))(*inputs)
        return tuple(np.asarray(x) for x in outputs), np.asarray(status)

    expected = {name: first_path(*found) for name, found in case.expected.items()}
    with jax.enable_x64(True), jax.default_device(jax.devices("cpu")[0]):
        yield compare_values("JAX module", case.model, expected, evaluate)
