"""What CUDA kernels take of a device, by NVIDIA's compiler: registers, stack, spills; no device is needed."""

from __future__ import annotations

from typing import Any

from symscrew import catalogue
from symscrew.export import print_cuda
from symscrew.model import derive
from symscrew.runtime import compile_cuda

from .tables import table

NAMES = ("three_ups_upu_s", "stewart_6ups", "delta", "ur5", "panda")
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "joint_reactions", "assemble")


def run(*, repeats: int = 1) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers; `repeats` changes nothing."""
    rows, raw = [], {}
    for name in NAMES:
        model = derive(catalogue.load(name)).only(FUNCTIONS)
        kernels = compile_cuda(print_cuda(model)[f"{name}.cu"]).kernels
        for function in model.programs:
            size = kernels[f"{name}_{function}_kernel"]
            raw[f"{name}.{function}"] = vars(size)
            operations = model.programs[function].operations["total"]
            spilled = f"{size.spill_stores}, {size.spill_loads}" if size.spill_stores else "none"
            rows.append([name, function, operations, size.registers, size.stack, spilled])
    return table(["mechanism", "kernel", "operations", "registers", "bytes of stack", "spilled, read back"], rows), raw
