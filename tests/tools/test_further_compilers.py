"""C by other compilers, for other libraries and machines: tcc, musl, 32 bit, big endian; included from C++.

Without the vectors of GCC on the machine at hand, sources fall back on plain C99: that it gives the same numbers is
shown by running it, on a foreign machine under an emulator.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest
from support.compiled_c import some

from symscrew.export.c import print_c
from symscrew.export.c_form import library_sources
from symscrew.model import Model

STRICT = ("-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion", "-Werror")
C99 = ("-std=c99", *STRICT, "-O0")
# name: the compiler and its options, and what starts its programs
COMPILERS = {
    "tcc": (("tcc", "-std=c99", "-Wall", "-Werror"), ()),
    "musl": (("musl-gcc", *C99, "-static"), ()),
    "32 bit": (("gcc", *C99, "-m32"), ()),
    "32 bit, vectors": (("gcc", *C99, "-m32", "-mavx2", "-mfpmath=sse"), ()),
    "big endian": (("s390x-linux-gnu-gcc", *C99, "-static"), ("qemu-s390x",)),
}
# Of the largest result. Libraries differ in the last bits of sines, and 32-bit code keeps 64 bits between operations.
SAME = 1e-10


def chosen() -> Iterator[tuple[str, Model]]:
    """One with second paths and an iteration, and one with equal limbs and quaternions."""
    yield "four_bar", some("four_bar")
    yield "seed", some("three_ups_upu_s_physical", ("inverse_dynamics", "inverse_kinematics"))


def literals(array: np.ndarray) -> str:
    """Numbers that every compiler reads to the same bits."""
    return ", ".join(x.hex() if np.isfinite(x) else "NAN" for x in map(float, array.ravel())) or "0.0"


def program(found: Model) -> str:
    """A program that prints the results of all functions at the test states: state by state, then the batch."""
    lines = ["#include <math.h>", "#include <stdio.h>", f'#include "{found.name}.h"', ""]
    lines += ["static void show(const double *x, size_t size)", "{", "    for (size_t k = 0; k < size; ++k) {"]
    lines += ['        printf("%.17g\\n", x[k]);', "    }", "}", "", "int main(void)", "{"]
    for name, function in found.programs.items():
        given = [np.atleast_2d(x) for x in found.test_inputs[name]]
        count, symbol = len(given[0]), f"{found.name}_{name}"
        arrays = [f"static const double in{k}[] = {{{literals(x)}}};" for k, x in enumerate(given)]
        arrays += [f"static double out{k}[{max(1, count * p.size)}];" for k, p in enumerate(function.outputs)]
        every = [f"in{k}" for k in range(len(given))] + [f"out{k}" for k in range(len(function.outputs))]
        sizes = [p.size for p in (*function.inputs, *function.outputs)]
        single = ", ".join(f"{x} + i * {size}" for x, size in zip(every, sizes, strict=True))
        shown = [f"show(out{k}, {count * p.size});" for k, p in enumerate(function.outputs)]
        lines += ["    {", *(f"        {text}" for text in arrays), f"        static int status[{count}];"]
        lines += [f"        for (size_t i = 0; i < {count}; ++i) {{"]
        lines += [f"            status[i] = {symbol}({single});", "        }"]
        lines += [*(f"        {text}" for text in shown)]
        lines += [f"        (void){symbol}_batch({count}, {', '.join(every)}, status);"]
        lines += [*(f"        {text}" for text in shown), f"        for (size_t i = 0; i < {count}; ++i) {{"]
        lines += ['            printf("%d\\n", status[i]);', "        }", "    }"]
    return "\n".join([*lines, "    return 0;", "}", ""])


def expected(found: Model) -> Iterator[tuple[str, np.ndarray, np.ndarray]]:
    """Function, its results twice, its statuses."""
    for name in found.programs:
        results, status = found(name, *[np.atleast_2d(x) for x in found.test_inputs[name]])
        flat = np.concatenate([np.ravel(x) for x in results])
        yield name, np.concatenate([flat, flat]), np.ravel(status)


def built(found: Model, folder: Path, compiler: Sequence[str]) -> Path:
    """The program of a model; any warning fails."""
    files = print_c(found, several=True)
    for file, text in (files | {"main.c": program(found)}).items():
        (folder / file).write_text(text, encoding="utf-8")
    sources = ["main.c", *library_sources(files, found.name)]
    command = [*compiler, *sources, "-o", "main", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=300)
    assert done.returncode == 0, done.stderr[:1500]
    return folder / "main"


@pytest.mark.parametrize("kind", COMPILERS)
def test_the_same_numbers_everywhere(kind: str, tmp_path: Path) -> None:
    compiler, starter = COMPILERS[kind]
    for tool in (compiler[0], *starter):
        if shutil.which(tool) is None:
            pytest.skip(f"{tool} is not installed")
    empty = tmp_path / "empty.c"
    empty.write_text("#include <math.h>\nint main(void) { return 0; }\n")
    probe = [*compiler, str(empty), "-o", str(tmp_path / "empty"), "-lm"]
    if subprocess.run(probe, capture_output=True, check=False).returncode:
        pytest.skip(f"{' '.join(compiler)}: the library of this target is not installed")
    if "-mavx2" in compiler and "avx2" not in Path("/proc/cpuinfo").read_text():
        pytest.skip("this machine has no AVX2")
    for name, found in chosen():
        (tmp_path / name).mkdir()
        main = built(found, tmp_path / name, compiler)
        done = subprocess.run([*starter, str(main)], capture_output=True, text=True, check=True, timeout=300)
        printed, at = np.array([float(x) for x in done.stdout.split()]), 0
        for function, results, status in expected(found):
            got, codes = np.split(printed[at : at + len(results) + len(status)], [len(results)])
            at += len(results) + len(status)
            scale = SAME * max(1.0, float(np.nanmax(np.abs(results), initial=0.0)))
            assert np.allclose(got, results, rtol=0.0, atol=scale, equal_nan=True), f"{kind}: {name}.{function}"
            assert codes.tolist() == status.tolist(), f"{kind}: {name}.{function}"
        assert at == len(printed)


@pytest.mark.parametrize("compiler", ["g++", "clang++"])
def test_the_header_is_one_of_cpp_too(compiler: str, tmp_path: Path) -> None:
    """Included twice, with every warning, and linked with the sources that a C compiler made."""
    if shutil.which(compiler) is None or shutil.which("gcc") is None:
        pytest.skip(f"{compiler} is not installed")
    found = some("four_bar", ("inverse_dynamics", "velocity"))
    files = print_c(found, several=True)
    call = "double q[4] = {0.5, 0.1, 0.2, 0.3}, v[3] = {}, a[3] = {}, u[1]; int status[1];"
    main = f"int main() {{ {call}\n    return four_bar_inverse_dynamics_batch(1, q, v, a, u, status) < 0; }}\n"
    files |= {"main.cpp": f'#include "four_bar.h"\n#include "four_bar.h"\n{main}'}
    for file, text in files.items():
        (tmp_path / file).write_text(text, encoding="utf-8")
    sources = library_sources(files, "four_bar")
    subprocess.run(["gcc", *C99, "-c", *sources], cwd=tmp_path, check=True)
    objects = [source.replace(".c", ".o") for source in sources]
    warnings = [flag for flag in STRICT if flag != "-Wdouble-promotion"]
    command = [compiler, "-std=c++11", *warnings, "main.cpp", *objects, "-o", "main", "-lm"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[:1500]
    assert subprocess.run([tmp_path / "main"], check=False).returncode == 0
