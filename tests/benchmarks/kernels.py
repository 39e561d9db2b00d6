"""What CUDA kernels take of a device, by NVIDIA's compiler, and what bounds them; times where a device is.

Registers, stack and spills need no device. A state's arrays are read and written once; an operation is an instruction
of the double-precision pipe at least (none fused). Where CuPy finds a device, both bounds are of that card as measured
(a copy, fused operations alone), and states per second stand beside them: of arrays that stay there in double and in
single precision, of arrays that come from the processor's pinned memory and go back, with the largest error against the
evaluator. Else they are of a data sheet. Beside all that stand the batches of our C on this processor.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.export import print_cuda
from symscrew.model import Model, derive
from symscrew.runtime import CompileError, compile_cuda, load, load_cuda

from .tables import table

NAMES = ("three_ups_upu_s", "stewart_6ups", "delta", "ur5", "panda")
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "joint_reactions", "assemble")
BATCH = 2**13  # states of a call on the processor, which stay in its caches
STATES = 2**22  # of a measurement: every multiprocessor has some hundred blocks
MOVED = 2**20  # states that come and go
HEAD = [
    "mechanism", "kernel", "operations", "bytes a state", "registers", "stack", "spilled, read back",
    "1e9/s by arithmetic", "by memory", "double", "single", "with transfers", "error, double", "single",
    "our C, one thread",
]  # fmt: skip
FUSED = """
extern "C" __global__ void fused(double *found, int count)
{
    double x[8];
    for (int k = 0; k < 8; ++k) { x[k] = 1e-3 * threadIdx.x + k; }
    for (int i = 0; i < count; ++i) {
        #pragma unroll
        for (int k = 0; k < 8; ++k) { x[k] = x[k] * 0.999999 + 1e-7; }
    }
    double sum = 0.0;
    for (int k = 0; k < 8; ++k) { sum += x[k]; }
    found[blockIdx.x * blockDim.x + threadIdx.x] = sum;
}
"""


@dataclass(frozen=True)
class Card:
    """Instructions a second in double precision, of which a fused one is one; bytes a second of its memory."""

    name: str
    instructions: float
    bytes: float


# NVIDIA's data sheet of the H200 SXM says 34e12 operations a second, of which a fused one counts as two.
DATA_SHEET = Card("H200 by its data sheet", 17e12, 4.8e12)


def run(*, repeats: int = 5) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers; `repeats` are of times on a device."""
    card = _measured_card(repeats) or DATA_SHEET
    rows, raw = [], {}
    for name in NAMES:
        model = derive(catalogue.load(name)).only(FUNCTIONS)
        kernels = compile_cuda(print_cuda(model)[f"{name}.cu"]).kernels
        times = {} if card is DATA_SHEET else _times(model, repeats)
        compiled = load(model, backend="c")
        for function, program in model.programs.items():
            size, bound = kernels[f"{name}_{function}_kernel"], bounds(model, function, card)
            measured = times.get(function, {})
            own = _on_processor(compiled[function], model.test_inputs[function], repeats)
            raw[f"{name}.{function}"] = {**vars(size), **bound, **measured, "C": own}
            spilled = f"{size.spill_stores}, {size.spill_loads}" if size.spill_stores else "none"
            rates = [bound["arithmetic"], bound["memory"], *(measured.get(k) for k in ("double", "single", "moved"))]
            errors = [measured.get(k) for k in ("error", "error, single")]
            rows.append(
                [
                    *(name, function, program.operations["total"], bound["bytes"], size.registers, size.stack, spilled),
                    *("-" if rate is None else f"{rate / 1e9:.3g}" for rate in rates),
                    *("-" if error is None else f"{error:.1e}" for error in errors),
                    f"{own / 1e9:.3g}",
                ]
            )
    told = f"{card.name}: {card.instructions / 1e12:.3g}e12 instructions, {card.bytes / 1e12:.3g}e12 bytes a second\n\n"
    return told + table(HEAD, rows), {"card": vars(card), **raw}


def bounds(model: Model, function: str, card: Card) -> dict[str, float]:
    """States per second that arithmetic and memory of the card allow at most; of an iteration those of one step."""
    program = model.programs[function]
    ports = (*program.inputs, *program.outputs)
    moved = sum(port.size for port in ports) * np.dtype(float).itemsize + np.dtype(np.intc).itemsize
    return {
        "bytes": moved,
        "arithmetic": card.instructions / program.operations["total"],
        "memory": card.bytes / moved,
    }


def _on_processor(function: Any, inputs: Any, repeats: int) -> float:
    """States per second of a batch in C."""
    given = [np.resize(x, (BATCH, x.shape[-1])) for x in inputs]

    def once() -> float:
        begin = time.perf_counter()
        function(*given, check=False)
        return time.perf_counter() - begin

    once()
    return BATCH / min(once() for _ in range(repeats))


def _measured_card(repeats: int) -> Card | None:
    """The device that is there, or None."""
    try:
        import cupy
    except ImportError:
        return None
    try:
        if not cupy.cuda.runtime.getDeviceCount():
            return None
    except cupy.cuda.runtime.CUDARuntimeError:  # CuPy without a driver
        return None
    threads, blocks, count = 256, 16 * 132, 4096
    kernel = cupy.RawModule(code=FUSED).get_function("fused")
    found = cupy.empty(threads * blocks)
    seconds = _on_device(lambda: kernel((blocks,), (threads,), (found, np.int32(count))), repeats)
    one = cupy.ones(2**28)
    other = cupy.empty_like(one)
    copied = _on_device(lambda: cupy.copyto(other, one), repeats)
    name = cupy.cuda.runtime.getDeviceProperties(0)["name"].decode()
    return Card(f"{name} as measured", threads * blocks * count * 8 / seconds, 2 * one.nbytes / copied)


def _times(model: Model, repeats: int) -> dict[str, dict[str, float]]:
    """States per second on the device, and errors."""
    import cupy

    found: dict[str, dict[str, float]] = {name: {} for name in model.programs}
    for precision in ("double", "single"):
        try:
            kernels = load_cuda(model, precision=precision)
        except CompileError as error:
            raise SystemExit(str(error)) from error
        for function in model.programs:
            call, inputs = getattr(kernels, function), model.test_inputs[function]
            there = [cupy.asarray(np.asarray(x).T, dtype=kernels.real) for x in inputs]
            error = _error(call(*there), model(function, *inputs))
            found[function]["error" if precision == "double" else "error, single"] = error
            index = cupy.arange(STATES) % len(inputs[0])
            many = [cupy.ascontiguousarray(x[:, index]) for x in there]
            found[function][precision] = STATES / _on_device(lambda call=call, many=many: call(*many), repeats)
            if precision == "double":
                found[function]["moved"] = MOVED / _moved(call, [x[:, :MOVED].get() for x in many], repeats)
            del many
            cupy.get_default_memory_pool().free_all_blocks()
    return found


def _error(found: Any, expected: Any) -> float:
    """The largest over the largest entry of its output, of states that both have."""
    *arrays, status = (x.get() for x in found)
    results, codes = expected
    sound = (status == 0) & (np.asarray(codes) <= 0)
    worst = 0.0
    for one, other in zip(arrays, results, strict=True):
        exact = np.asarray(other).reshape(len(status), -1).T[:, sound]
        size = float(np.abs(exact).max(initial=0.0)) or 1.0
        worst = max(worst, float(np.abs(one[:, sound] - exact).max(initial=0.0)) / size)
    return worst


def _on_device(run: Callable[[], object], repeats: int) -> float:
    """Seconds of the device, median."""
    import cupy

    run()
    laps = []
    for _ in range(repeats):
        begin, end = cupy.cuda.Event(), cupy.cuda.Event()
        begin.record()
        run()
        end.record()
        end.synchronize()
        laps.append(cupy.cuda.get_elapsed_time(begin, end) * 1e-3)
    return float(np.median(laps))


def _moved(call: Any, arrays: list[np.ndarray], repeats: int) -> float:
    """Seconds with arrays that come from pinned memory and go back to it."""
    import cupy

    def pinned(shape: tuple[int, ...], dtype: Any) -> np.ndarray:
        memory = cupy.cuda.alloc_pinned_memory(int(np.prod(shape)) * np.dtype(dtype).itemsize)
        return np.frombuffer(memory, dtype, int(np.prod(shape))).reshape(shape)

    given = [pinned(x.shape, x.dtype) for x in arrays]
    for one, other in zip(given, arrays, strict=True):
        one[...] = other
    rooms = [pinned(x.shape, x.dtype) for x in call(*map(cupy.asarray, given))]

    def once() -> float:
        begin = time.perf_counter()
        for result, room in zip(call(*map(cupy.asarray, given)), rooms, strict=True):
            result.get(out=room)
        cupy.cuda.Device().synchronize()
        return time.perf_counter() - begin

    once()
    return float(np.median([once() for _ in range(repeats)]))
