"""CUDA code: the file as C++ against the evaluator, its compiler where its wheel is, its loader without a device."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from support.marks import slow
from support.model_states import model, pendulum

from symscrew import Model
from symscrew.export import CUDA_THREADS, print_cuda
from symscrew.generation import generate
from symscrew.runtime import CompileError, compile_cuda, find_nvrtc, load_cuda
from symscrew.verification import check

pytestmark = pytest.mark.slow

FUNCTIONS = ("velocity", "inverse_dynamics", "forward_dynamics", "joint_displacements", "assemble")
COMPILED = pytest.mark.skipif(shutil.which("g++") is None, reason="needs g++")


@COMPILED
@pytest.mark.parametrize("precision", ["double", slow("single")])
def test_generate_and_check(tmp_path: Path, precision: str) -> None:
    generate(model("four_bar").only(FUNCTIONS), tmp_path, targets=["cuda"], precision=precision)
    result = check(tmp_path)
    assert result.ok, result.lines
    assert any("CUDA code" in line and "as C++" in line for line in result.lines), result.lines


@COMPILED
@pytest.mark.slow
@pytest.mark.parametrize("name", ["three_ups_upu_s", "delta"])
def test_parallel_and_serial_mechanisms(tmp_path: Path, name: str) -> None:
    """With second paths left out, statuses of limbs, and an iteration; registers of all of them.

    Of the delta what is printed in another order, as more values are alive at once than registers hold.
    """
    functions = ["inverse_dynamics", "forward_dynamics", "inverse_kinematics", "assemble"]
    if name == "delta":
        functions = ["forward_dynamics"]
        header = print_cuda(model(name).only(functions))["delta_cuda.h"]
        assert re.search(r"Up to 1\d\d values at once, of about 120 in registers: local memory", header)
    generate(model(name).only(functions), tmp_path, targets=["cuda"])
    result = check(tmp_path)
    assert result.ok, result.lines


@pytest.mark.tools
def test_nvidias_compiler_takes_the_code() -> None:
    """Every function is a kernel; those of a step of control keep everything in registers."""
    if find_nvrtc() is None:
        pytest.skip("needs NVRTC (pip install 'symscrew[nvrtc]')")
    derived = model("three_ups_upu_s").only(["inverse_dynamics", "forward_dynamics"])
    code = compile_cuda(print_cuda(derived)["three_ups_upu_s.cu"])
    assert [*code.kernels] and len(code.kernels) == 2
    assert ".target sm_90" in code.ptx and code.binary[:4] == b"\x7fELF"
    for kernel in code.kernels.values():
        assert 0 < kernel.registers <= 255
        assert kernel.spill_stores == kernel.spill_loads == 0
    with pytest.raises(CompileError, match="NVRTC refuses the code"):
        compile_cuda("not CUDA")


def test_no_compiler_and_no_device_are_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("symscrew.runtime.nvrtc.find_nvrtc", lambda: None)
    with pytest.raises(CompileError, match=r"no CUDA compiler here: pip install 'symscrew\[nvrtc\]'"):
        compile_cuda("")
    monkeypatch.setitem(sys.modules, "cupy", None)
    with pytest.raises(CompileError, match="no CuPy here"):
        load_cuda(pendulum())
    none = SimpleNamespace(getDeviceCount=lambda: 0, CUDARuntimeError=OSError)
    monkeypatch.setitem(sys.modules, "cupy", SimpleNamespace(cuda=SimpleNamespace(runtime=none)))
    with pytest.raises(CompileError, match="no CUDA device here"):
        load_cuda(pendulum())


class OnProcessor:
    """What stands in for CuPy here: NumPy's arrays, and kernels that are the same file's loops, compiled as C++."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        count = SimpleNamespace(getDeviceCount=lambda: 1, CUDARuntimeError=OSError)
        self.cuda = SimpleNamespace(runtime=count)
        self.ascontiguousarray, self.empty, self.uint64 = np.ascontiguousarray, np.empty, np.uint64

    def RawModule(self, code: str, options: tuple[str, ...]) -> Any:  # noqa: N802 - CuPy's name
        (self.folder / "code.cu").write_text(code.replace("#if !defined(__CUDACC_RTC__)", "#if 0"))
        command = ["g++", *options, "-O1", "-x", "c++", "-shared", "-fPIC", "code.cu", "-o", "code.so"]
        subprocess.run(command, cwd=self.folder, check=True)
        library = ctypes.CDLL(str(self.folder / "code.so"))

        def function(name: str) -> Any:
            def launched(grid: Any, block: Any, arguments: Any) -> None:
                assert grid == (1,) and block == (CUDA_THREADS,)
                sizes = [ctypes.c_size_t(int(x)) for x in arguments[:2]]
                getattr(library, name)(*sizes, *(ctypes.c_void_p(x.ctypes.data) for x in arguments[2:]))

            return launched

        return SimpleNamespace(get_function=function)


@COMPILED
def test_the_loader_hands_over_arrays_in_order(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Not on a device: arrays, their order and sizes, and what is refused."""
    monkeypatch.setitem(sys.modules, "cupy", OnProcessor(tmp_path))
    derived: Model = pendulum()
    kernels = load_cuda(derived)
    states = [np.asarray(x).T for x in derived.test_inputs["inverse_dynamics"]]
    names = [port.name for port in derived.programs["inverse_dynamics"].inputs]
    (expected,), _ = derived("inverse_dynamics", *derived.test_inputs["inverse_dynamics"])
    u, status = kernels.inverse_dynamics(*states[:2], **dict(zip(names[2:], states[2:], strict=True)))
    np.testing.assert_allclose(u.T, expected, rtol=1e-13)
    assert (status == 0).all()
    states[0] = states[0].copy()
    states[0][0, 1] = np.nan
    u, status = kernels.inverse_dynamics(*states)
    assert status[1] == 2 and np.isnan(u[:, 1]).all() and np.isfinite(u[:, 0]).all()
    with pytest.raises(AttributeError, match="expected a function of pendulum"):
        kernels.inverse_dynamic  # noqa: B018
    with pytest.raises(TypeError, match="inverse_dynamics expects the arrays"):
        kernels.inverse_dynamics(*states[:-1])
    with pytest.raises(ValueError, match=r"expected q of \(1, states\), got"):
        kernels.inverse_dynamics(states[0].T, *states[1:])
    with pytest.raises(ValueError, match="as many states in every array"):
        kernels.inverse_dynamics(states[0][:, :1], *states[1:])
