"""The loop of `simulate` and bare ones, DOP853 with projection, as programs around the same generated functions.

`bare` is a loop over our own projection and stages; `other` shares nothing with ours but the generated functions
(lean/other_loop.c). All write the states at all outputs to a file, and say how many steps they took and how long. Their
instructions are counted by valgrind (callgrind) where it is there: those of two runs less those of one.
"""

from __future__ import annotations

import re
import resource
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.integrate._ivp import dop853_coefficients
from support.problems import Compiled

from symscrew.export import decimal
from symscrew.runtime import find_compiler
from symscrew.scene import features_in_time
from symscrew.simulation import native
from symscrew.simulation.run_source import kernel_text, sources

LEAN = Path(__file__).parent / "lean"
LONGEST = 4  # processor seconds for a program's runs: the longest of a problem takes a third of one
MAIN = """
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
static double tolerance, first; /* local; and the bare loop's first step */
static double q_out[COUNT * NQ1], v_out[COUNT * NV1], x_out[COUNT * NX1];
int main(int argc, char **argv)
{
    if (argc != 5) {
        return 2;
    }
    const int repeats = atoi(argv[1]);
    tolerance = atof(argv[3]);
    first = atof(argv[4]);
    long steps = 0, runs = 1;
    double least = 1e300;
    for (int k = 0; k < abs(repeats); ++k) {
        struct timespec one, other;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &one);
        for (long i = 0; i < runs; ++i) {
            steps = run_once();
        }
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &other);
        const double taken = (double)(other.tv_sec - one.tv_sec) + 1e-9 * (double)(other.tv_nsec - one.tv_nsec);
        if (repeats < 0 && taken < 0.02 && runs < 10000 && steps > 0) { /* some clocks tick a hundred times a second */
            runs *= taken < 0.005 ? 4 : 2;
            --k;
            continue;
        }
        least = taken / (double)runs < least ? taken / (double)runs : least;
    }
    printf("%ld %.9g\\n", steps, least);
    FILE *file = fopen(argv[2], "wb");
    if (file == NULL || fwrite(q_out, sizeof q_out, 1, file) != 1 || fclose(file) != 0) {
        return 1;
    }
    return steps > 0 ? 0 : 1;
}
"""
OURS = """
int precise_anchor(const double *q, const double *v, const int *modes, double *base);
int precise_state(double t, const double *y, double *q, double *v, double *dv, double *dx, double *smallest);
double precise_rounding(void);
static Crossing crossings[1000];
static long run_once(void)
{
    static Simulation s;
    size_t written = 0, met = 0;
    int outcome = simulation_start(&s, 0.0, Q0, V0, X0, DOP853, 0.0, tolerance, tolerance, TIMES[COUNT - 1], 100000000L,
                                   EDGES, LEFTS, EDGE_COUNT);
#if NR && FREE
    simulation_precision(&s, precise_anchor, precise_state, precise_rounding());
#endif
    if (outcome == 0) {
        outcome = simulation_advance(&s, 100000000L, TIMES, COUNT, &written, q_out, v_out, x_out, crossings, 1000,
                                     &met);
    }
    return outcome == 0 ? s.steps : -1;
}
"""
BARE = """
static long run_once(void)
{
    return bare_run(Q0, V0, X0, first, tolerance, TIMES, COUNT, q_out, v_out, x_out);
}
"""
OTHER = """
static long run_once(void)
{
    return other_run(Q0, V0, first, tolerance, TIMES, COUNT, q_out, v_out);
}
"""


@dataclass(frozen=True)
class Measured:
    """A program at a tolerance: steps (-1: it failed), error, seconds and instructions of a run (0: not counted)."""

    steps: int
    error: float
    seconds: float
    instructions: int


def compared(
    case: Compiled,
    tolerances: Sequence[float],
    *,
    repeats: int,
    count: bool = False,
    names: Sequence[str] = ("ours", "bare"),
) -> list[dict[str, Measured]]:
    """The programs of these names, run in turns at the same local tolerances; `count`: their instructions too."""
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        programs = {name: _program(Path(temporary), name, case) for name in names}
        return [_measured(case, programs, tolerance, repeats, count) for tolerance in tolerances]


def _measured(
    case: Compiled, programs: Mapping[str, Path], tolerance: float, repeats: int, count: bool
) -> dict[str, Measured]:
    first = case.problem.scene.duration / max(case.run(tolerance=tolerance).counters["steps"], 1.0) / 10
    options = repr(max(native.LOCAL * tolerance, native.LEAST)), repr(first)
    found = {}
    for name, program in programs.items():
        steps, seconds, error = _run(program, case, options, repeats)
        found[name] = Measured(steps, error, seconds, _instructions(program, options) if count else 0)
    return found


def _program(folder: Path, name: str, case: Compiled) -> Path:
    """The compiled program of a loop: ours with what it needs near singular places in a library of its own."""
    scene, plant = case.problem.scene, case.plant
    whole, near = sources(plant, native.table_code(list(scene.tables.values())))
    features = features_in_time(scene, case.model)
    arrays = {
        "TIMES": scene.times, "Q0": case.start[0], "V0": case.start[1], "X0": case.start[2], "EDGES": features.edges,
        "LEFTS": features.lefts,
    }  # fmt: skip
    data = [
        f"#define COUNT {len(scene.times)}", f"#define EDGE_COUNT {len(features.edges)}",
        *(_array(name, values) for name, values in arrays.items()),
    ]  # fmt: skip
    begin = MAIN.index("int main")
    head, main = "\n".join([*data, MAIN[:begin]]), MAIN[begin:]
    if name == "ours":
        parts, files = [whole, head, OURS, main], {"near": near} if len(plant.rows) else {}
    elif name == "bare":
        functions = whole[: whole.index(kernel_text("contacts.c"))]  # with rows.c and manifold.c behind them
        loop = (LEAN / "bare_loop.c").read_text(encoding="utf-8")
        for kernel in ("dop853_stages.c", "dop853_dense.c"):
            loop = loop.replace(f'#include "{kernel}"', kernel_text(kernel))
        parts, files = [functions, loop, head, BARE, main], {}
    else:
        functions = whole[: whole.index(kernel_text("rows.c"))]
        loop = (LEAN / "other_loop.c").read_text(encoding="utf-8")
        loop = f"#define OTHER_RAW {int(name == 'raw')}\n{loop}"
        parts, files = [functions, tableau(), loop, head, OTHER, main], {}
    return _linked(folder, name, "\n".join(["#define _POSIX_C_SOURCE 199309L", *parts]), files)


def tableau() -> str:
    """SciPy's coefficients of DOP853 as C, zeros left out."""

    def total(row: np.ndarray) -> str:
        return " + ".join(f"{decimal(float(c))} * k[{s}][i]" for s, c in enumerate(row) if c)

    found = dop853_coefficients
    stages = [f"OTHER_STAGE({s}, {decimal(float(found.C[s]))}, {total(found.A[s])})" for s in range(16)]
    last, end = found.N_STAGES, found.N_STAGES + 1  # the slope at the end of the step is stage 12
    lines = {
        "OTHER_STAGES": " ".join(stages[1:last]), "OTHER_MORE": " ".join(stages[end:]), "OTHER_NEXT": total(found.B),
        "OTHER_FIVE": total(found.E5), "OTHER_THREE": total(found.E3),
        **{f"OTHER_DENSE_{r}": total(row) for r, row in enumerate(found.D)},
    }  # fmt: skip
    return "\n".join(f"#define {name} {text}" for name, text in lines.items())


def _linked(folder: Path, name: str, text: str, libraries: Mapping[str, str]) -> Path:
    compiler, program = find_compiler(), folder / name
    assert compiler is not None
    flags = ["-std=c99", *native.NATIVE_FLAGS]
    linked = []
    for library, code in libraries.items():  # its functions have the names of the program's: it keeps to its own
        (folder / f"{library}.c").write_text(code, encoding="utf-8")
        linked.append(str(folder / f"{library}.so"))
        own = [
            *flags,
            *native.NEAR_FLAGS,
            "-shared",
            "-fPIC",
            "-Wl,-Bsymbolic",
            str(folder / f"{library}.c"),
            "-o",
            linked[-1],
            "-lm",
        ]
        subprocess.run([compiler, *own], check=True)
    (folder / f"{name}.c").write_text(text, encoding="utf-8")
    subprocess.run([compiler, *flags, str(folder / f"{name}.c"), "-o", str(program), *linked, "-lm"], check=True)
    return program


def _array(name: str, values: Sequence[float] | np.ndarray) -> str:
    body = ", ".join(decimal(float(v)) for v in values) or "0.0"
    return f"static const double {name}[] = {{{body}}};"


def _run(program: Path, case: Compiled, options: tuple[str, str], repeats: int) -> tuple[int, float, float]:
    """Steps, least seconds, error."""
    result = program.with_suffix(".bin")
    command = [str(program), str(-repeats), str(result), *options]  # < 0: as many runs as the clock can tell, each time
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=_bounded)
    if done.returncode:
        return -1, float("nan"), float("nan")
    steps, seconds = done.stdout.split()
    q = np.fromfile(result).reshape(len(case.problem.scene.times), -1)[:, : case.plant.sizes["q"]]
    return int(steps), float(seconds), case.error(q)


def _bounded() -> None:
    """At a change point a bare loop takes shorter and shorter steps: it is ended."""
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST))


def _instructions(program: Path, options: tuple[str, str]) -> int:
    """Of a run, without what starts the program; 0 where there is no valgrind."""
    if shutil.which("valgrind") is None:
        return 0
    counts = []
    for repeats in (1, 2):
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", str(program), str(repeats)]
        command += ["/dev/null", *options]
        text = subprocess.run(command, capture_output=True, text=True).stderr
        counts.append(int(re.findall(r"Collected : (\d+)", text)[0]))
    return counts[1] - counts[0]
