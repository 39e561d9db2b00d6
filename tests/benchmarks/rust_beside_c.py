"""The Rust crate beside the C: nanoseconds of a call, both called state after state, in turns.

crate, rustc -C opt-level=3 -C target-cpu=native   |  the same loop over the same states, the sum of all results
C, cc -O3 -march=native, one state at a time       |  kept, so that nothing is left out
"""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.export import RustNames, print_c, print_rust
from symscrew.model import Model, derive
from symscrew.program import Program

from .tables import table

FUNCTIONS = ("inverse_kinematics", "inverse_dynamics_platform", "forward_dynamics", "joint_reactions")
CALLS = 200_000
RUST = """
use std::convert::TryInto;
use std::time::Instant;
use @CRATE@::*;
fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let bytes = std::fs::read(&arguments[1]).unwrap();
    let all: Vec<f64> = bytes.chunks_exact(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect();
    let mut sum = 0.0;
    let start = Instant::now();
    for call in 0..@CALLS@ {
        let at = &all[(call % @STATES@) * @SIZE@..];
        if let Ok(found) = @FUNCTION@::<Std>(@GIVEN@) {
            @SUM@
        }
    }
    println!("{} {}", start.elapsed().as_nanos() as f64 / @CALLS@ as f64, sum);
}
"""
C = """
#define _POSIX_C_SOURCE 199309L
#include "@NAME@.h"
#include <stdio.h>
#include <time.h>
int main(int count, char **arguments)
{
    static double all[@STATES@ * @SIZE@], made[@MADE@];
    FILE *file = fopen(arguments[count - 1], "rb");
    double sum = 0.0;
    struct timespec start, end;
    if (file == NULL || fread(all, sizeof all, 1, file) != 1) {
        return 1;
    }
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (int call = 0; call < @CALLS@; ++call) {
        const double *at = all + call % @STATES@ * @SIZE@;
        if (@NAME@_@FUNCTION@(@GIVEN@) <= 0) {
            for (int k = 0; k < @MADE@; ++k) {
                sum += made[k];
            }
        }
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    const double time = 1e9 * (double)(end.tv_sec - start.tv_sec) + (double)(end.tv_nsec - start.tv_nsec);
    printf("%.17g %.17g\\n", time / @CALLS@, sum);
    return 0;
}
"""


def run(repeats: int = 7) -> tuple[str, dict[str, Any]]:
    """The table, and the numbers."""
    rows, raw = [], {}
    for name in ("three_ups_upu_s", "delta"):
        model = derive(catalogue.load(name))
        with tempfile.TemporaryDirectory() as place:
            for function in FUNCTIONS:
                own = model.only([function])
                programs = built(own, function, Path(place))
                found = {language: [] for language in programs}
                for _ in range(repeats):
                    for language, (program, states) in programs.items():
                        done = subprocess.run([str(program), str(states)], capture_output=True, text=True, check=True)
                        found[language].append([float(x) for x in done.stdout.split()])
                sums = [values[0][1] for values in found.values()]
                assert np.isclose(*sums, rtol=1e-6), sums
                c, rust = (min(time for time, _ in found[language]) for language in ("C", "Rust"))
                rows.append([name, function, f"{c:.0f}", f"{rust:.0f}", f"{rust / c:.2f}"])
                raw[f"{name}, {function}"] = {"c": c, "rust": rust}
    return table(["machine", "function", "C [ns]", "Rust [ns]", "ratio"], rows), raw


def built(model: Model, function: str, place: Path) -> dict[str, tuple[Path, Path]]:
    """Both programs, and the states as bytes."""
    program, names = model.programs[function], RustNames(model)
    assert isinstance(program, Program)
    states = np.hstack([np.atleast_2d(x) for x in model.test_inputs[function]])
    place = place / function
    place.mkdir()
    (place / "states").write_bytes(states.astype("<f8").tobytes())
    made = sum(port.size for port in program.outputs)
    offsets = np.concatenate([[0], np.cumsum([port.size for port in program.inputs])]).tolist()
    given = [
        f"&{names.of(p)}(at[{a}..{a + p.size}].try_into().unwrap())"
        for p, a in zip(program.inputs, offsets, strict=False)
    ]
    shared = {
        "CRATE": names.crate, "NAME": model.name, "CALLS": CALLS, "STATES": len(states), "SIZE": states.shape[1],
        "MADE": made,
    }  # fmt: skip
    sums = " ".join(f"sum += found.{field}.0.iter().sum::<f64>();" for field in names.fields(program))
    ends = np.concatenate([[0], np.cumsum([port.size for port in program.outputs])]).tolist()
    called = [*(f"at + {a}" for a in offsets[:-1]), *(f"made + {a}" for a in ends[:-1])]
    rust = filled(RUST, {**shared, "FUNCTION": names.function(function), "GIVEN": ", ".join(given), "SUM": sums})
    c = filled(C, {**shared, "FUNCTION": function, "GIVEN": ", ".join(called)})
    for file, text in {**print_rust(model), **print_c(model, batches=False, lanes=False)}.items():
        (place / file).write_text(text)
    (place / "main.rs").write_text(rust)
    (place / "main.c").write_text(c)
    level = ["-C", "opt-level=3", "-C", "target-cpu=native", "--edition", "2018"]
    crate = ["--crate-type", "rlib", "--crate-name", names.crate, "--cfg", 'feature="std"', f"{model.name}.rs"]
    subprocess.run(["rustc", *level, *crate], cwd=place, check=True)
    linked = ["--extern", f"{names.crate}=lib{names.crate}.rlib", "-o", "rust"]
    subprocess.run(["rustc", *level, "main.rs", *linked], cwd=place, check=True)
    fast = ["-O3", "-march=native", "-ffp-contract=off", "-fno-math-errno"]
    subprocess.run(["cc", *fast, f"{model.name}.c", "main.c", "-o", "c", "-lm"], cwd=place, check=True)
    return {"C": (place / "c", place / "states"), "Rust": (place / "rust", place / "states")}


def filled(text: str, words: dict[str, Any]) -> str:
    for word, meaning in words.items():
        text = text.replace(f"@{word}@", str(meaning))
    return text
