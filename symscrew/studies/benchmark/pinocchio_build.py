"""Pinocchio for the benchmark: its C++ headers from the `pin` wheel, or else its Python call."""

from __future__ import annotations

import ctypes
import subprocess
import sysconfig
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.studies.benchmark.pinocchio_tree import PinocchioTree

LIMIT_SECONDS = 900  # of the compiler, which takes one minute: longer, it hangs
COMPILER = "g++"
CPP_FLAGS = ("-O3", "-march=native", "-DNDEBUG")
LIMITS = (
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
)  # what Pinocchio's own CMake files define


class PinocchioUnavailableError(RuntimeError):
    """Why the C++ side could not be built."""


def build_pinocchio(folder: Path) -> ctypes.CDLL:
    """The compiled pinocchio_timing.cpp (about a minute); raises PinocchioUnavailableError."""
    packages = Path(sysconfig.get_path("purelib"))
    pinocchio = packages / "cmeel.prefix" / "include"
    candidates = (pinocchio / "eigen3", packages / "casadi" / "include" / "eigen3", Path("/usr/include/eigen3"))
    eigen = next((path for path in candidates if (path / "Eigen" / "Core").is_file()), None)
    if not (pinocchio / "pinocchio" / "algorithm" / "rnea.hpp").is_file():
        raise PinocchioUnavailableError("the wheel `pin` with its headers is not installed")
    if eigen is None:
        raise PinocchioUnavailableError("no headers of Eigen; install cmeel-eigen")
    built = folder / "pinocchio_timing.so"
    source = Path(__file__).with_name("pinocchio_timing.cpp")
    includes = ["-isystem", str(pinocchio), "-isystem", str(eigen)]
    flags = ["-std=c++17", "-shared", "-fPIC", *CPP_FLAGS]
    command = [COMPILER, *flags, *LIMITS, *includes, str(source), "-o", str(built)]
    try:
        result = subprocess.run(
            command, capture_output=True, encoding="utf-8", errors="replace", check=False, timeout=LIMIT_SECONDS
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise PinocchioUnavailableError(f"no C++ compiler that works: {error}") from error
    if result.returncode:
        errors = [line for line in result.stderr.splitlines() if "error" in line]
        raise PinocchioUnavailableError((errors or [result.stderr[-300:]])[0][:300])
    library = ctypes.CDLL(str(built))
    library.pinocchio_open.restype = ctypes.c_void_p
    library.pinocchio_time.restype = ctypes.c_double
    return library


def open_case(library: ctypes.CDLL, tree: PinocchioTree, folder: Path) -> int | None:
    """A tree in the C++, or None where this knows no such tree."""
    file = folder / "tree.txt"
    file.write_text(tree.text)
    return library.pinocchio_open(str(file).encode()) or None


def timed(
    library: ctypes.CDLL, opened: int, states: tuple[np.ndarray, ...], shape: tuple[int, ...], *, structured: int
) -> tuple[Callable[[], float], np.ndarray]:
    """A measurement of ns per call of the C++, and its results."""
    u = np.full(shape, np.nan)

    def measure(rounds: int = 8) -> float:
        pointers = [ctypes.c_void_p(x.ctypes.data) for x in (*states, u)]
        count = ctypes.c_size_t(len(u))
        nanoseconds: float = library.pinocchio_time(
            ctypes.c_void_p(opened), ctypes.c_int(structured), ctypes.c_size_t(rounds), count, *pointers
        )
        return nanoseconds

    measure(1)
    return measure, u


def python_rnea(tree: PinocchioTree, states: tuple[np.ndarray, ...]) -> tuple[Callable[[], float], np.ndarray]:
    """ns per RNEA from Python less that of a tree of one joint (the overhead of the call), and results.

    Without the wheel `pin` this raises ImportError: there is nothing to compare with.
    """
    import pinocchio

    model = python_model(pinocchio, tree, len(tree.elements))
    least = python_model(pinocchio, tree, 1)
    data, least_data = model.createData(), least.createData()
    rows = list(zip(*states, strict=True))
    first = [tuple(x[:1] for x in row) for row in rows]
    results = np.array([pinocchio.rnea(model, data, *row) for row in rows])

    def measure() -> float:
        start = time.perf_counter()
        for row in rows:
            pinocchio.rnea(model, data, *row)
        middle = time.perf_counter()
        for row in first:
            pinocchio.rnea(least, least_data, *row)
        return ((middle - start) - (time.perf_counter() - middle)) * 1e9 / len(rows)

    return measure, results


def python_model(pinocchio: Any, tree: PinocchioTree, joints: int) -> Any:
    """The first joints of a serial tree as a model of Pinocchio's Python package."""
    made = pinocchio.Model()
    joint_types = {"R": pinocchio.JointModelRZ, "P": pinocchio.JointModelPZ}
    lines = tree.text.splitlines()[1 : 1 + joints]
    for k, line in enumerate(lines):
        kind, parent, *rest = line.split()
        x = np.array([float(number) for number in rest])
        place = pinocchio.SE3(x[:9].reshape(3, 3), x[9:12])
        index = made.addJoint(int(parent), joint_types[kind](), place, f"joint{k + 1}")
        inertia = pinocchio.Inertia(x[12], x[13:16], x[16:25].reshape(3, 3))
        made.appendBodyToJoint(index, inertia, pinocchio.SE3.Identity())
    return made
