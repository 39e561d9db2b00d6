"""What is installed of all that the package can use, and how to get what is missing."""

from __future__ import annotations

import importlib.metadata
import platform
import shutil
import subprocess
import tempfile
from pathlib import Path

from symscrew.display.terminal import MISSING

PACKAGES = {
    "sympy": ("deriving", "pip install sympy"),
    "casadi": ("CasADi functions; evaluation without a C compiler; optimise", "pip install casadi"),
    "numpy": ("evaluation", "pip install numpy"),
    "tqdm": ("progress", "pip install tqdm"),
    "rich": ("tables in colour on a terminal", "pip install rich"),
    "matplotlib": ("figures of demo, draw, cost, simulate, report, workspace", 'pip install "symscrew[plot]"'),
    "scipy": ("simulate: stiff scenes, events, runs without a C compiler", 'pip install "symscrew[simulation]"'),
    "distributed": ("workspace on a Dask cluster", 'pip install "symscrew[dask]"'),
    "argcomplete": ("completion in the shell", 'pip install "symscrew[completion]"'),
    "mkdocs": ("building the documentation", 'pip install "symscrew[docs]"'),
    "mujoco": ("an oracle of the tests", 'pip install "symscrew[test]"'),
    "pytest": ("tests", 'pip install "symscrew[test]"'),
    "pin": ("an opponent of the benchmarks", 'pip install "symscrew[benchmark]"'),
}
"""Package -> what it is for, and how to get it."""
TOOLS = {
    "cc": ("running the generated C from Python", "apt install gcc"),
    "gcc": ("check: all warnings as errors", "apt install gcc"),
    "clang": ("check: all warnings as errors", "apt install clang"),
    "valgrind": ("a test of the generated C", "apt install valgrind"),
    "cmake": ("building generated code the way its users do", "apt install cmake"),
    "chromium": ("tests of the pages of view and report", "apt install chromium"),
    "ffmpeg": ("view --mp4", "apt install ffmpeg"),
    "node": ("a test of the generated JavaScript", "apt install nodejs"),
    "arm-none-eabi-gcc": ("embedded: cost on a microcontroller", "apt install gcc-arm-none-eabi"),
    "qemu-system-arm": ("embedded: cost on a microcontroller", "apt install qemu-system-arm"),
}
"""Command -> what it is for, and how to get it (Debian's names)."""
SOLVERS = ("ipopt", "fatrop", "sqpmethod")


def installation() -> list[tuple[str, str, str, str]]:
    """(part, version or place, what for, how to get it if it is missing) of everything that the package can use."""
    rows = [("python", platform.python_version(), "everything", "")]
    for name, (text, cure) in PACKAGES.items():
        found = _version(name)
        rows.append((name, found, text, cure if found in MISSING else ""))
    for name, (text, cure) in TOOLS.items():
        place = shutil.which(name) or "not found"
        rows.append((name, place, text, cure if place in MISSING else ""))
    openmp = _openmp()
    rows.append(
        ("OpenMP", "yes" if openmp else "no", "batches on several threads", "" if openmp else "apt install gcc")
    )
    for solver in SOLVERS:
        has = _solver(solver)
        rows.append((f"casadi: {solver}", "yes" if has else "no", "optimise", "" if has else "pip install -U casadi"))
    return rows


def _openmp() -> bool:
    """Whether the C compiler makes libraries with OpenMP: one is made and thrown away."""
    compiler = next((c for c in ("cc", "gcc", "clang") if shutil.which(c)), None)
    if compiler is None:
        return False
    with tempfile.TemporaryDirectory(prefix="symscrew_") as folder:
        source = Path(folder) / "openmp.c"
        source.write_text("#include <omp.h>\nint threads(void) { return omp_get_max_threads(); }\n")
        command = [compiler, "-fopenmp", "-shared", "-fPIC", str(source), "-o", str(Path(folder) / "openmp.so")]
        try:
            return subprocess.run(command, capture_output=True, timeout=60).returncode == 0
        except (OSError, subprocess.TimeoutExpired):
            return False


def _solver(name: str) -> bool:
    try:
        import casadi
    except ImportError:
        return False
    return bool(casadi.has_nlpsol(name))


def _version(package: str) -> str:
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"
