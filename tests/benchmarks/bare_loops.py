"""The loop of `simulate` and a bare one, DOP853 with projection, as two programs around the same generated functions.

Both write the states at all outputs to a file, and say how many steps they took and how long. Their instructions are
counted by valgrind (callgrind) where it is there: those of two runs less those of one.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from support.problems import Compiled

from symscrew.export import decimal
from symscrew.runtime import find_compiler
from symscrew.scene import features_in_time
from symscrew.simulation import native
from symscrew.simulation.run_source import kernel_text, source

BARE = Path(__file__).parent / "lean" / "bare_loop.c"
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
    long steps = 0;
    double least = 1e300;
    for (int k = 0; k < repeats; ++k) {
        struct timespec one, other;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &one);
        steps = run_once();
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &other);
        const double taken = (double)(other.tv_sec - one.tv_sec) + 1e-9 * (double)(other.tv_nsec - one.tv_nsec);
        least = taken < least ? taken : least;
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
static Crossing crossings[1000];
static long run_once(void)
{
    static Simulation s;
    size_t written = 0, met = 0;
    int outcome = simulation_start(&s, 0.0, Q0, V0, X0, DOP853, 0.0, tolerance, tolerance, TIMES[COUNT - 1], 100000000L,
                                   EDGES, LEFTS, EDGE_COUNT);
    if (outcome == 0) {
        outcome = simulation_advance(&s, 100000000L, TIMES, COUNT, &written, q_out, v_out, x_out, crossings, 1000,
                                     &met);
    }
    return outcome == 0 ? s.steps : -1;
}
"""
OTHER = """
static long run_once(void)
{
    return bare_run(Q0, V0, X0, first, tolerance, TIMES, COUNT, q_out, v_out, x_out);
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
    case: Compiled, tolerances: Sequence[float], *, repeats: int, count: bool
) -> list[tuple[Measured, Measured]]:
    """The loop of `simulate` and the bare one, run in turns at the same local tolerances."""
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        programs = [_program(Path(temporary), name, text) for name, text in _texts(case).items()]
        return [_pair(case, programs, tolerance, repeats, count) for tolerance in tolerances]


def _pair(
    case: Compiled, programs: Sequence[Path], tolerance: float, repeats: int, count: bool
) -> tuple[Measured, Measured]:
    first = case.problem.scene.duration / max(case.run(tolerance=tolerance).counters["steps"], 1.0) / 10
    options = repr(max(native.LOCAL * tolerance, native.LEAST)), repr(first)
    found = [_run(program, case, options) for program in programs]
    seconds = [[f[1]] for f in found]
    for _ in range(repeats):
        for k, program in enumerate(programs):
            seconds[k].append(_run(program, case, options)[1])
    counted = [_instructions(program, options) if count else 0 for program in programs]
    ours, bare = (
        Measured(steps, error, min(times), number)
        for (steps, _, error), times, number in zip(found, seconds, counted, strict=True)
    )
    return ours, bare


def _texts(case: Compiled) -> dict[str, str]:
    scene, plant = case.problem.scene, case.plant
    whole = source(plant, native.table_code(list(scene.tables.values())))
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
    functions = whole[: whole.index(kernel_text("contacts.c"))]  # with rows.c and manifold.c behind them
    bare = BARE.read_text(encoding="utf-8")
    for name in ("dop853_stages.c", "dop853_dense.c"):
        bare = bare.replace(f'#include "{name}"', kernel_text(name))
    loops = {"ours": [whole, head, OURS, main], "bare": [functions, bare, head, OTHER, main]}
    return {name: "\n".join(["#define _POSIX_C_SOURCE 199309L", *parts]) for name, parts in loops.items()}


def _array(name: str, values: Sequence[float] | np.ndarray) -> str:
    body = ", ".join(decimal(float(v)) for v in values) or "0.0"
    return f"static const double {name}[] = {{{body}}};"


def _program(folder: Path, name: str, text: str) -> Path:
    file, program = folder / f"{name}.c", folder / name
    file.write_text(text, encoding="utf-8")
    compiler = find_compiler()
    assert compiler is not None
    subprocess.run([compiler, "-std=c99", *native.NATIVE_FLAGS, "-o", str(program), str(file), "-lm"], check=True)
    return program


def _run(program: Path, case: Compiled, options: tuple[str, str]) -> tuple[int, float, float]:
    """Steps, least seconds, error."""
    result = program.with_suffix(".bin")
    done = subprocess.run([str(program), "1", str(result), *options], capture_output=True, text=True)
    steps, seconds = done.stdout.split()
    if done.returncode:
        return -1, float("nan"), float("nan")
    q = np.fromfile(result).reshape(len(case.problem.scene.times), -1)[:, : case.plant.sizes["q"]]
    return int(steps), float(seconds), case.error(q)


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
