"""What CUDA kernels take of a device, by NVIDIA's compiler, and what bounds them; times where a device is.

Registers, stack and spills need no device. Bounds are of the card that `CARD` describes: an operation is an instruction
of the double-precision pipe at least (none fused), a state's arrays are read and written once. Where CuPy and a device
are, states per second with arrays that stay there are measured beside them, and with transfers. Beside all that stand
the batches of our C on this processor.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.export import print_cuda
from symscrew.model import Model, derive
from symscrew.runtime import CompileError, compile_cuda, load, load_cuda

from .tables import table

NAMES = ("three_ups_upu_s", "stewart_6ups", "delta", "ur5", "panda")
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "joint_reactions", "assemble")
# H200 SXM, NVIDIA's data sheet: 34e12 operations a second in double precision, of which a fused one counts as two;
# bytes a second of its memory.
CARD, INSTRUCTIONS, BYTES = "H200", 17e12, 4.8e12
BATCH = 2**13  # states of a call on the processor, which stay in its caches
STATES = 2**22  # of a measurement: every multiprocessor has some hundred blocks


def run(*, repeats: int = 5) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers; `repeats` are of times on a device."""
    rows, raw = [], {}
    for name in NAMES:
        model = derive(catalogue.load(name)).only(FUNCTIONS)
        kernels = compile_cuda(print_cuda(model)[f"{name}.cu"]).kernels
        times, compiled = _times(model, repeats), load(model, backend="c")
        for function, program in model.programs.items():
            size, bound = kernels[f"{name}_{function}_kernel"], bounds(model, function)
            measured = times.get(function, {})
            own = _on_processor(compiled[function], model.test_inputs[function], repeats)
            raw[f"{name}.{function}"] = {**vars(size), **bound, **measured, "C": own}
            spilled = f"{size.spill_stores}, {size.spill_loads}" if size.spill_stores else "none"
            shares = [f"{bound[key] / 1e9:.3g}" for key in ("arithmetic", "memory")]
            there = [f"{measured[key] / 1e9:.3g}" if measured else "-" for key in ("device", "with transfers")]
            operations = program.operations["total"]
            rows.append(
                [
                    name,
                    function,
                    operations,
                    bound["bytes"],
                    size.registers,
                    size.stack,
                    spilled,
                    *shares,
                    *there,
                    f"{own / 1e9:.3g}",
                ]
            )
    head = ["mechanism", "kernel", "operations", "bytes a state", "registers", "stack", "spilled, read back"]
    head += [f"{CARD}: 1e9/s by arithmetic", "by memory", "measured", "with transfers", "our C, one thread"]
    return table(head, rows), raw


def bounds(model: Model, function: str) -> dict[str, float]:
    """States per second that arithmetic and memory of the card allow at most; of an iteration those of one step."""
    program = model.programs[function]
    ports = (*program.inputs, *program.outputs)
    moved = sum(port.size for port in ports) * np.dtype(float).itemsize + np.dtype(np.intc).itemsize
    return {
        "bytes": moved,
        "arithmetic": INSTRUCTIONS / program.operations["total"],
        "memory": BYTES / moved,
    }


def _on_processor(function: Any, inputs: Any, repeats: int) -> float:
    """States per second of a batch in C."""
    given = [np.resize(x, (BATCH, x.shape[-1])) for x in inputs]
    return BATCH / _seconds(lambda: function(*given, check=False), repeats)


def _times(model: Model, repeats: int) -> dict[str, dict[str, float]]:
    """States per second on the device that is there; nothing where none is."""
    try:
        kernels = load_cuda(model)
    except CompileError:
        return {}
    import cupy

    found = {}
    for function in model.programs:
        here = [np.ascontiguousarray(np.resize(x, (STATES, x.shape[-1])).T) for x in model.test_inputs[function]]
        there = [cupy.asarray(x) for x in here]
        call = getattr(kernels, function)

        def kept(call: Any = call, there: Any = there) -> None:
            call(*there)
            cupy.cuda.Device().synchronize()

        def moved(call: Any = call, here: Any = here) -> None:
            for result in call(*map(cupy.asarray, here)):
                result.get()

        found[function] = {
            "device": STATES / _seconds(kept, repeats),
            "with transfers": STATES / _seconds(moved, repeats),
        }
    return found


def _seconds(run: Any, repeats: int) -> float:
    run()
    laps = []
    for _ in range(repeats):
        begin = time.perf_counter()
        run()
        laps.append(time.perf_counter() - begin)
    return min(laps)
