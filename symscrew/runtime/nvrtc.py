"""CUDA's run-time compiler, from the wheel of its library: no toolkit and no device needed.

    text of <name>.cu --compile_cuda--> PTX, machine code, and what every kernel takes: registers, stack, spills

The wheel is `nvidia-cuda-nvrtc-cu12`, of the extras `nvrtc` and `cuda`. Running what it makes needs a device.
"""

from __future__ import annotations

import ctypes
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from symscrew.runtime.compilers import CompileError

KERNEL = re.compile(r"Compiling entry function '(\w+)' for '(\w+)'")
STACK = re.compile(r"(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads")
REGISTERS = re.compile(r"Used (\d+) registers")


@dataclass(frozen=True)
class KernelSize:
    """What a thread of a kernel takes: registers (at most 255); bytes of stack, of spilled stores and loads."""

    registers: int
    stack: int
    spill_stores: int
    spill_loads: int


@dataclass(frozen=True)
class CudaCode:
    """Compiled kernels: PTX as text, machine code for one architecture, sizes by kernel."""

    ptx: str
    binary: bytes
    kernels: dict[str, KernelSize]


def find_nvrtc() -> Path | None:
    """The library of the wheel, or None where it is not installed."""
    from importlib.util import find_spec

    try:
        found = find_spec("nvidia.cuda_nvrtc") or find_spec("nvidia.cu13")
    except ModuleNotFoundError:
        return None
    folders = list(found.submodule_search_locations or ()) if found else []
    libraries = [path for folder in folders for path in sorted(Path(folder).glob("**/libnvrtc.so*"))]
    return libraries[0] if libraries else None


def compile_cuda(text: str, *, architecture: str = "sm_90", flags: Sequence[str] = ()) -> CudaCode:
    """Compile CUDA text for one architecture.

    Raises:
        CompileError: there is no compiler, or it refuses the text; the message says what it said.
    """
    path = find_nvrtc()
    if path is None:
        raise CompileError("no CUDA compiler here: pip install 'symscrew[nvrtc]'")
    library = ctypes.CDLL(str(path))
    program = ctypes.c_void_p()
    _sound(library, library.nvrtcCreateProgram(ctypes.byref(program), text.encode(), b"model.cu", 0, None, None))
    try:
        options = [f"--gpu-architecture={architecture}", "--ptxas-options=-v", *_uncached(library), *flags]
        given = (ctypes.c_char_p * len(options))(*(option.encode() for option in options))
        outcome = library.nvrtcCompileProgram(program, len(options), given)
        said = _text(library, program, "ProgramLog")
        if outcome:
            raise CompileError(f"NVRTC refuses the code: {said.strip()[:2000]}")
        return CudaCode(_text(library, program, "PTX"), _bytes(library, program, "CUBIN"), _sizes(said))
    finally:
        library.nvrtcDestroyProgram(ctypes.byref(program))


def _uncached(library: ctypes.CDLL) -> list[str]:
    """What makes NVRTC compile, and say the sizes, each time: where a driver is, it keeps what it has compiled."""
    major, minor = ctypes.c_int(), ctypes.c_int()
    _sound(library, library.nvrtcVersion(ctypes.byref(major), ctypes.byref(minor)))
    return ["--no-cache"] if (major.value, minor.value) >= (12, 8) else []


def _sound(library: ctypes.CDLL, outcome: int) -> None:
    if outcome:
        library.nvrtcGetErrorString.restype = ctypes.c_char_p
        raise CompileError(f"NVRTC: {library.nvrtcGetErrorString(outcome).decode()}")


def _bytes(library: ctypes.CDLL, program: ctypes.c_void_p, what: str) -> bytes:
    size = ctypes.c_size_t()
    _sound(library, getattr(library, f"nvrtcGet{what}Size")(program, ctypes.byref(size)))
    buffer = ctypes.create_string_buffer(size.value)
    _sound(library, getattr(library, f"nvrtcGet{what}")(program, buffer))
    return buffer.raw


def _text(library: ctypes.CDLL, program: ctypes.c_void_p, what: str) -> str:
    return _bytes(library, program, what).rstrip(b"\0").decode(errors="replace")


def _sizes(said: str) -> dict[str, KernelSize]:
    """What ptxas says of every kernel."""
    found = {}
    parts = KERNEL.split(said)
    for name, part in zip(parts[1::3], parts[3::3], strict=True):
        stack, registers = STACK.search(part), REGISTERS.search(part)
        if stack and registers:
            found[name] = KernelSize(int(registers[1]), *map(int, stack.groups()))
    return found
