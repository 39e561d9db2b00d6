"""Generated JAX modules on the device that JAX has: tracing, compiling and evaluating, beside C and JAX's own gradient.

The rival of gradients is JAX on the operations one by one, as a printer without an engine would have it.
"""

from __future__ import annotations

import importlib.util
import tempfile
import time
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.export import print_jax
from symscrew.model import Model, derive
from symscrew.runtime import load

from .tables import table

NAMES = ("three_ups_upu_s", "ur5", "panda", "delta", "stewart_6ups")
STATES, MANY = 10_000, 2**18  # on a processor, on a device


def run(*, repeats: int = 5) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    import jax

    rows, raw = [], []
    with jax.enable_x64(True):
        device = jax.devices()[0]
        states = STATES if device.platform == "cpu" else MANY
        for name in NAMES:
            model = derive(catalogue.load(name)).only(["inverse_dynamics"])
            module = imported(model)
            inputs = [np.resize(x, (states, x.shape[-1])) for x in model.test_inputs["inverse_dynamics"]]
            for what, function in _functions(module).items():
                found = {"mechanism": name, "what": what, **_measured(function, inputs, repeats)}
                raw.append(found)
                rows.append(_row(found))
            if name == NAMES[0]:
                found = {"mechanism": name, "what": "gradient by JAX, operation by operation"}
                raw.append(found | _measured(_one_by_one(module, model), inputs, 1))
                rows.append(_row(raw[-1]))
            compiled = load(model, backend="c").inverse_dynamics
            seconds = min(_timed(lambda c=compiled, x=inputs: c(*x)) for _ in range(repeats))
            rows.append([name, "C, one thread", "", "", f"{seconds / states * 1e9:.1f}"])
    head = ["mechanism", "inverse dynamics", "trace, CPU s", "compile, CPU s", "ns a state"]
    told = f"{device.device_kind}, {states} states\n\n"
    return told + table(head, rows), {"device": device.device_kind, "states": states, "rows": raw}


def _row(found: dict[str, Any]) -> list[str]:
    times = (f"{found[k]:.2f}" for k in ("trace", "compile"))
    return [found["mechanism"], found["what"], *times, f"{found['ns']:.3g}"]


def _one_by_one(module: ModuleType, model: Model) -> Any:
    """The gradient that JAX makes of single operations, as a printer without an engine would have it."""
    import jax
    import jax.numpy as jnp

    program = model.programs["inverse_dynamics"]
    size = sum(port.size for port in program.inputs)
    recorded = module.record(module._inverse_dynamics, size)

    def cost(*x: Any) -> Any:
        entries = jnp.concatenate([array.T for array in x])
        return jnp.sum(module._unrolled(recorded, entries)[: program.outputs[0].size] ** 2)

    return jax.grad(cost, argnums=(0, 1, 2))


def _functions(module: ModuleType) -> dict[str, Any]:
    import jax
    import jax.numpy as jnp

    def cost(*x: Any) -> Any:
        return jnp.sum(module.inverse_dynamics(*x).u ** 2)

    return {
        "values": module.inverse_dynamics,
        "gradient by all inputs": jax.grad(cost, argnums=(0, 1, 2)),
        "Hessian times a direction": lambda *x: jax.jvp(jax.grad(cost, argnums=(0, 1, 2)), x, x)[1],
    }


def imported(model: Model) -> ModuleType:
    """The generated module, imported."""
    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
        path = Path(folder) / f"{model.name}_jax.py"
        path.write_text(print_jax(model)[path.name])
        spec = importlib.util.spec_from_file_location(path.stem, path)
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    return module


def _measured(function: Any, inputs: list[np.ndarray], repeats: int) -> dict[str, float]:
    import jax

    begin = time.process_time()  # of all threads that compile: on a busy machine the clock on the wall says nothing
    there = [jax.device_put(x) for x in inputs]
    lowered = jax.jit(function).lower(*there)
    traced = time.process_time()
    compiled = lowered.compile()
    done = time.process_time()
    seconds = min(_timed(lambda: jax.block_until_ready(compiled(*there))) for _ in range(repeats + 1))
    return {"trace": traced - begin, "compile": done - traced, "ns": seconds / len(inputs[0]) * 1e9}


def _timed(call: Any) -> float:
    begin = time.perf_counter()
    call()
    return time.perf_counter() - begin
