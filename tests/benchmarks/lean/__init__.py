"""How far generated functions are from lean C: the functions of `*.c` here, written by hand, timed in the same run.

Where there is no hand-written function, the figure in cycles is that of an earlier measurement of the best known code
(`RECORDED`: AVX-512 at 3.95 GHz, gcc 12). Such a row compares both with the hand-written drives of the seed:
(ours / lean seed, here) over (recorded / recorded lean seed), so that clock and load of this machine cancel.
Hand-written functions check nothing; ours return a status for pivots and for numbers that are not finite. They take
their inputs to be consistent: where one reads fewer of them than ours, the table says which. The delta robot's rest on
what no general method knows: its platform does not turn, and the rods of an arm stay parallel.
"""

from __future__ import annotations

import ctypes
import itertools
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.export.c import print_c
from symscrew.model import Model, derive
from symscrew.runtime.compiled import compile_c
from symscrew.studies.benchmark.timed_code import Compiled, difference, pointers, states
from symscrew.studies.timing import Times, interleaved

from ..tables import table

SEED = "three_ups_upu_s_physical"
SOURCES = ("seed", "seed_forward", "stewart", "delta", "arms", "arms_derivatives")
STATES = 64  # which the caches hold
BLOCK = 8
PAGE = 4096  # bytes
PLACES = 8  # where arrays begin in their pages
AGREEMENT = 1e-10
STEP = "step of 1 ms (RK4)"  # on forward_dynamics, by runge_kutta.h
FLAGS = (
    *("-fopenmp-simd", "-mprefer-vector-width=512", "-fno-tree-slp-vectorize"),
    *("-ffinite-math-only", "-fno-signed-zeros", "-fno-trapping-math"),  # products with constant zeros vanish
)
LEAN_SEED = 348.0  # recorded cycles of the first row
ARMS = "arms' angles and the platform's coordinates"
PLACE = "the platform's position"
Measure = Callable[[], float]


@dataclass(frozen=True)
class Row:
    """A generated function in one form, the lean function that does the same, and recorded cycles."""

    mechanism: str
    function: str
    form: str
    lean: str | None = None
    recorded: float | None = None
    reads: str = ""  # what the lean function reads of the same inputs, where that is less
    one_mode: bool = False  # ours is for the operation mode of the reference configuration

    @property
    def name(self) -> str:
        """What the table calls it."""
        return f"{self.model}, {self.function}, {self.form}, {self.reads}"

    @property
    def model(self) -> str:
        """The mechanism, and whether its code is for one operation mode."""
        return f"{self.mechanism}, one mode" if self.one_mode else self.mechanism


ONE, LANES, EIGHT = "limb by limb", "limbs in lanes", "eight states"
ARM = (
    "inverse_dynamics",
    "mass_matrix",
    "inverse_dynamics_derivatives",
    "forward_dynamics",
    "forward_kinematics",
    "platform_jacobian",
)
ROWS = (
    Row(SEED, "inverse_dynamics_platform", ONE, "lean_seed", LEAN_SEED),
    Row(SEED, "inverse_dynamics_platform", LANES, "lean_seed_lanes", 185.0),
    Row(SEED, "inverse_dynamics_platform", EIGHT, "lean_seed_batch", 54.0),
    Row(SEED, "joint_reactions", ONE, "lean_seed_reactions", 617.0),
    Row(SEED, "joint_reactions", LANES, "lean_seed_reactions_lanes", 314.0),
    Row(SEED, "joint_reactions", EIGHT, "lean_seed_reactions_batch", 108.0),
    Row(SEED, "forward_dynamics", ONE, "lean_seed_forward", 511.0),
    Row(SEED, "forward_dynamics", LANES, "lean_seed_forward_lanes"),
    Row(SEED, "forward_dynamics", EIGHT, "lean_seed_forward_batch"),
    Row(SEED, STEP, ONE, "lean_seed_step", 2500.0),
    Row(SEED, STEP, LANES, "lean_seed_step_lanes"),
    Row(SEED, "velocity", ONE, "lean_seed_velocity"),
    Row(SEED, "velocity", LANES, "lean_seed_velocity_lanes"),
    Row(SEED, "platform_jacobian", ONE, "lean_seed_jacobian"),
    Row(SEED, "inverse_dynamics_independent_derivatives", ONE, None, 1777.0),
    Row("stewart_6ups", "inverse_dynamics_platform", ONE, "lean_stewart"),
    Row("stewart_6ups", "inverse_dynamics_platform", LANES, "lean_stewart"),
    *(
        Row("delta", function, form, f"lean_delta_{name}", None, ARMS, one_mode)
        for one_mode in (False, True)
        for function, name in (("inverse_dynamics", "drives"), ("velocity", "velocity"))
        for form in (ONE, LANES)
    ),
    *(
        Row("delta", "inverse_dynamics_platform", form, "lean_delta_platform", None, PLACE, True)
        for form in (ONE, LANES)
    ),
    *(Row("delta", "forward_dynamics", form, "lean_delta_forward", None, ARMS, True) for form in (ONE, LANES)),
    Row("delta", "platform_jacobian", ONE, "lean_delta_jacobian"),
    *(
        Row(arm, function, ONE, f"lean_{arm}_{function}", recorded)
        for arm, figures in (("ur5", (296.0, 371.0, 1067.0)), ("panda", (395.0, 687.0, 2765.0)))
        for function, recorded in zip(ARM, (*figures, None, None, None), strict=True)
    ),
)


def run(*, repeats: int = 50) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers; raises RuntimeError where generated and lean results differ."""
    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
        lean = _lean(Path(folder))
        measures: dict[str, Measure] = {}
        agreement: dict[str, float] = {}
        for name in dict.fromkeys(row.model for row in ROWS):
            some = [row for row in ROWS if row.model == name]
            for row, (ours, theirs, error) in zip(some, _measures(some, lean, Path(folder)), strict=True):
                measures[f"ours: {row.name}"] = ours
                if theirs is not None:
                    measures[f"lean: {row.name}"] = theirs
                    agreement[row.name] = error
        times = interleaved(measures, repeats)
    rows = [_line(row, times, agreement) for row in ROWS]
    header = ["mechanism", "function", "form", "ours ns", "lean ns", "ratio", "against", "relative difference"]
    raw = {
        "times": {name: found.as_json() for name, found in times.items()},
        "rows": [asdict(row) for row in ROWS],
        "agreement": agreement,
    }
    text = f"Least of {repeats} interleaved repeats in {PLACES} places of memory, ns per state."
    return f"{text}\n\n{table(header, rows)}", raw


def _line(row: Row, times: dict[str, Times], agreement: dict[str, float]) -> list[str]:
    ours = times[f"ours: {row.name}"].least
    here = [row.model, row.function, row.form, f"{ours:.4g}"]
    lean = times.get(f"lean: {row.name}")
    if lean is not None:
        return [
            *here,
            f"{lean.least:.4g}",
            f"{ours / lean.least:.2f}",
            f"lean C in this run{row.reads and f' that reads {row.reads} only'}",
            f"{agreement[row.name]:.0e}",
        ]
    assert row.recorded is not None
    seed = times[f"lean: {ROWS[0].name}"].least
    ratio = ours / seed * LEAN_SEED / row.recorded
    return [*here, "", f"{ratio:.2f}", f"recorded: {row.recorded:.0f} cycles, lean seed {LEAN_SEED:.0f}", ""]


def _lean(folder: Path) -> ctypes.CDLL:
    """All hand-written functions in one library."""
    here = Path(__file__).parent
    text = "".join(f'#include "{here / name}.c"\n' for name in SOURCES)
    (folder / "lean.c").write_text(text, encoding="utf-8")
    compile_c(folder / "lean.c", folder / "lean.so", flags=[*FLAGS, f"-I{here}"])
    return ctypes.CDLL(str(folder / "lean.so"))


def _measures(rows: Sequence[Row], lean: ctypes.CDLL, folder: Path) -> list[tuple[Measure, Measure | None, float]]:
    """ns per state of ours and of the lean function, and their relative difference, for rows of one model."""
    mechanism, one_mode = rows[0].mechanism, rows[0].one_mode
    derivatives = any("derivatives" in row.function for row in rows)
    model = derive(catalogue.load(mechanism), derivatives=derivatives, one_mode=one_mode)
    functions = list(dict.fromkeys(_program(row) for row in rows))
    compiled = Compiled(model, functions)
    here = folder / rows[0].model
    code = {form: _library(compiled.model, here, lanes=form == LANES) for form in (ONE, LANES)}
    found = []
    for row in rows:
        block = BLOCK if row.form == EIGHT else 1
        arrays = _arrays(compiled, row, block)
        if row.form == EIGHT:
            ours, results = _timed(compiled, arrays, compiled.function(row.function, "_batch_soa"), block, whole=True)
        else:
            name = "step" if row.function == STEP else row.function
            ours, results = _timed(compiled, arrays, getattr(code[row.form], f"{mechanism}_{name}"), block)
        theirs, error = None, 0.0
        if row.lean is not None:
            theirs, others = _timed(compiled, arrays, getattr(lean, row.lean), block)
            error = max(difference(a[: len(b)], b) for a, b in zip(results, others, strict=True))
            if not error < AGREEMENT:
                raise RuntimeError(f"{row.name}: differs from {row.lean} by {error:.1e}; nothing to compare")
        found.append((ours, theirs, error))
    return found


def _program(row: Row) -> str:
    """The generated function of a row, or that within its step."""
    return "forward_dynamics" if row.function == STEP else row.function


def _library(model: Model, folder: Path, *, lanes: bool) -> ctypes.CDLL:
    """Generated functions with equal limbs side by side or one after the other, and a step on forward dynamics."""
    here = folder / ("lanes" if lanes else "one")
    here.mkdir(parents=True, exist_ok=True)
    for file, text in print_c(model, lanes=lanes).items():
        (here / file).write_text(text, encoding="utf-8")
    source = here / f"{model.name}.c"
    if model.name == SEED and "forward_dynamics" in model.programs:  # in a file of its own: the C may include itself
        header, whole = Path(__file__).with_name("runge_kutta.h"), here / "with_step.c"
        step = f"#define JOIN(a, b) a##_##b\n#define JOINED(a, b) JOIN(a, b)\n#define STEP {SEED}_step\n"
        step = f'{step}#define FORWARD {SEED}_forward_dynamics\n#include "{header}"\n'
        whole.write_text(f'#include "{source.name}"\n{step}', encoding="utf-8")
        source = whole
    library = here / f"{model.name}.so"
    compile_c(source, library)
    return ctypes.CDLL(str(library))


@dataclass(frozen=True)
class Arrays:
    """Inputs and results of STATES states, the same memory for ours and for the lean function."""

    given: list[np.ndarray]
    results: list[np.ndarray]


def _arrays(compiled: Compiled, row: Row, block: int) -> list[Arrays]:
    """Of `block` states side by side, [entry][state], in several places.

    Where an array and a function's stack lie at equal distances from pages, its reads wait for writes that are none
    of theirs: up to 40 % by chance. Both functions are timed in all places, so that the least has none of it.
    """
    program = compiled.model.programs[_program(row)]
    ports = program.inputs[:2] if row.function == STEP else program.outputs  # a step gives coordinates and rates
    given = [_blocks(x, block) for x in states(compiled.model, program.name, STATES)]
    every = [*given, *[np.full((STATES // block, port.size * block), np.nan) for port in ports]]
    placed = [[_placed(x, place) for x in every] for place in range(0, PAGE, PAGE // PLACES)]
    return [Arrays(some[: len(given)], some[len(given) :]) for some in placed]


def _placed(x: np.ndarray, place: int) -> np.ndarray:
    """A copy that begins `place` bytes after the beginning of a page of memory."""
    room = np.empty(x.nbytes + 2 * PAGE, dtype=np.uint8)
    start = -room.ctypes.data % PAGE + place
    copy = room[start : start + x.nbytes].view(x.dtype).reshape(x.shape)
    copy[...] = x
    return copy


def _timed(
    compiled: Compiled, places: Sequence[Arrays], function: Any, block: int, *, whole: bool = False
) -> tuple[Measure, list[np.ndarray]]:
    """ns per state of a function of `block` states side by side, one place after the other, and its results.

    `whole`: the generated function for any number of states. Results are of shape (states, size).
    """
    sizes = (ctypes.c_size_t * 8)(*[array.shape[1] for array in (*places[0].given, *places[0].results)])
    here = [pointers([*arrays.given, *arrays.results]) for arrays in places]
    if whole:
        here = [(ctypes.c_void_p * 8)(*[x.ctypes.data for x in (*p.given, *p.results)]) for p in places]
    count, loop = STATES // block, compiled.loops.time_block if whole else compiled.loops.time_single
    following = itertools.cycle(here)

    def measure(rounds: int = 60, kept: Sequence[Arrays] = places) -> float:
        rounds_, count_ = ctypes.c_size_t(rounds), ctypes.c_size_t(count)
        return loop(function, rounds_, count_, sizes, next(following)) / block

    for result in places[0].results:
        result.fill(np.nan)
    measure(1)
    found = [r.reshape(count, -1, block).transpose(0, 2, 1).reshape(STATES, -1).copy() for r in places[0].results]
    return measure, found


def _blocks(x: np.ndarray, block: int) -> np.ndarray:
    """States (count, size) as (count / block, size * block) with the states of a block side by side."""
    return np.ascontiguousarray(x.reshape(-1, block, x.shape[1]).transpose(0, 2, 1)).reshape(len(x) // block, -1)
