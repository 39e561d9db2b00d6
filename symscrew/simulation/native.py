"""The compiled run: generated functions and the integration loop in one C file, called once per run."""

from __future__ import annotations

import ctypes
import hashlib
import math
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from symscrew.export import decimal, print_c
from symscrew.model import Model
from symscrew.program import Program
from symscrew.runtime import compile_c
from symscrew.scene import Scene, Table
from symscrew.simulation.fronts import layouts, paths
from symscrew.simulation.recording import History, Passage
from symscrew.simulation.state_programs import Plant

KERNELS = Path(__file__).parent / "kernels"
NATIVE_FLAGS = ("-O3", "-fno-trapping-math")
NATIVE_METHODS = {"euler": 0, "semi_implicit_euler": 1, "rk4": 2, "rk8": 3, "dop853": 4}
GOING_ON = 1
NO_TABLES = "static void tables_at(double t, double *s)\n{\n    (void)t;\n    (void)s;\n}\n"


def generated(plant: Plant) -> dict[str, str]:
    """The plant's functions as C: file name to text."""
    programs = {"slopes": plant.slopes, "inputs": plant.inputs, "forward_dynamics": plant.forward}
    rates = plant.model.programs.get("effect_state_rates")
    if isinstance(rates, Program):
        programs["effect_state_rates"] = rates
    if plant.closure is not None:
        programs["closure_both"] = replace(plant.closure, name="closure_both")
    reduced = Model(plant.model.name, plant.model.mechanism, plant.model.effects, programs, {}, plant.system)
    return print_c(reduced, batches=False)


def kernel_text(name: str) -> str:
    """A kernel's text with the files that it includes put in."""
    lines = []
    for line in (KERNELS / name).read_text(encoding="utf-8").splitlines():
        if line.startswith('#include "dop853_'):
            lines.append(kernel_text(line.split('"')[1]).rstrip("\n"))
        else:
            lines.append(line)
    return "\n".join([*lines, ""])


def _table(name: str, rows: Sequence[tuple[int, int]]) -> str:
    body = ", ".join(f"{{{a}, {b}}}" for a, b in rows) or "{0, 0}"
    return f"static const int {name}[{max(len(rows), 1)}][2] = {{{body}}};"


def _vector(name: str, values: np.ndarray, storage: str = "static const") -> str:
    body = ", ".join(decimal(float(v)) for v in values) or "1.0"
    return f"{storage} double {name}[{max(len(values), 1)}] = {{{body}}};"


def constants(plant: Plant) -> str:
    """Sizes, units and thresholds that the kernels read."""
    tree, sizes = plant.system.tree, plant.sizes
    spheres, plain = tree.spheres, tree.plain
    nq, nv, nx, nr = sizes["q"], sizes["v"], sizes["x"], len(plant.rows)
    passive = int(plant.works)
    numbers = {
        "NQ": nq, "NV": nv, "NX": nx, "NU": sizes["u"], "NS": plant.tables, "NR": nr, "RANK": plant.rank,
        "FREE": nv - plant.rank, "NY": 2 * nv + nx, "PASSIVE": passive, "PLAIN_COUNT": len(plain),
        "SPHERE_COUNT": len(spheres), "NQ1": max(nq, 1), "NV1": max(nv, 1), "NX1": max(nx, 1), "NR1": max(nr, 1),
        "NY1": max(2 * nv + nx, 1), "RANK1": max(plant.rank, 1), "ENTRIES": len(plant.entries),
        "ENTRIES1": max(len(plant.entries), 1), "MOST_CORRECTIONS": 12,
        "FAILED": 1001, "IN_ZONE": 1002, "AT_REST": 1003, "LEAST_SQUARES": 5,
    }  # fmt: skip
    reals = {
        "PIVOT": plant.pivot, "ZONE": 0.02 * plant.pivot, "CAREFUL": 0.25 * plant.pivot, "LOOK": 1e-3 * plant.pivot,
        "RANK_FLOOR": 1e-10, "CLOSED": 1e-14, "NEARLY_CLOSED": 1e-12, "STRIDE": 0.05, "SPACING": 0.015,
        "REACH": 0.6, "CAREFUL_TOLERANCE": 4e-12, "DUST": 1e-150,
    }  # fmt: skip
    lines = [f"#define {name} {value}" for name, value in numbers.items()]
    lines += [f"#define {name} {decimal(float(value))}" for name, value in reals.items()]
    lines += [
        _table("PLAIN", plain),
        _table("SPHERES", spheres),
        _vector("UNIT", plant.units),
        _vector("ROW_SCALE", plant.rows),
        *(_pattern(plant) if nr else ()),
        "#if !defined(PARAMETERS_STORAGE)",
        "#define PARAMETERS_STORAGE static const",
        "#endif",
        _vector("PARAMETERS", plant.parameters, "PARAMETERS_STORAGE"),
    ]
    return "\n".join([*lines, ""])


def _integers(name: str, values: Sequence[int]) -> str:
    return f"static const int {name}[{max(len(values), 1)}] = {{{', '.join(map(str, values)) or '0'}}};"


def _pattern(plant: Plant) -> list[str]:
    """Where the closure's Jacobian has entries, and the fronts of its rows."""
    fronts = plant.fronts
    places, through = layouts(fronts), paths(fronts, plant.entries)
    live = [row for front in fronts for row in front.rows]
    coordinates = [(k, column) for k, front in enumerate(fronts) for column in front.columns]
    column_at = [-1] * sum(place.width for place in places)
    spots = [-1] * plant.sizes["v"]
    for k, column in coordinates:
        spots[column] = places[k].at + fronts[k].columns.index(column)
        column_at[spots[column]] = column
    lower = [
        sum(fronts[j].rank for j in through[row]) + front.rank for front in fronts for row in front.rows
    ]  # parts of a row along the pivots below, then along those of its own front
    starts = np.searchsorted(plant.entries[:, 0], np.arange(len(plant.rows) + 1)).tolist()
    table = ", ".join(
        f"{{{p.row}, {len(f.rows)}, {p.pivot}, {f.rank}, {p.at}, {p.width}, {len(f.columns)}, {f.parent}, {p.up}, "
        f"{p.turn}}}"
        for f, p in zip(fronts, places, strict=True)
    )
    sizes = {
        "FRONTS": max(len(fronts), 1), "LIVE1": max(len(live), 1), "WIDTHS": max(len(column_at), 1),
        "TURNS": max(sum(p.width**2 for p in places), 1), "LOWERS": max(sum(lower), 1),
        "MOST_ROWS": max((len(f.rows) for f in fronts), default=1),
        "MOST_WIDTH": max((p.width for p in places), default=1),
    }  # fmt: skip
    return [
        *(f"#define {name} {value}" for name, value in sizes.items()),
        f"#define FRONT_TABLE {{{table or '{0, 0, 0, 0, 0, 0, 0, -1, 0, 0}'}}}",
        _table("ENTRY", [(row, column) for row, column in plant.entries.tolist()]),
        _integers("ENTRY_START", starts),
        _integers("LIVE_ROW", live),
        _integers("LOWER_AT", _sums(lower)),
        _integers("PATH_START", _sums([len(through[row]) for row in live])),
        _integers("PATH", [front for row in live for front in through[row]]),
        _integers("SPOT", spots),
        _integers("COLUMN", column_at),
    ]


def _sums(counts: Sequence[int]) -> list[int]:
    return np.concatenate([[0], np.cumsum(counts)]).astype(int).tolist()


def adapters(plant: Plant) -> str:
    """C that calls the generated functions by the names that the kernels use."""
    name = plant.model.name
    commanded = list(plant.inputs.outputs)
    outside = next((port.size for port in plant.slopes.inputs if port.name == "s"), 0) - plant.tables
    lines = [
        "static int forces_at(double t, const double *q, const double *v, const double *x, const double *u, double *a,",
        "                     double *x_dot)",
        "{",
        f"    double s[NS + {outside + 1}] = {{0.0}};",
        "    tables_at(t, s);",
        *(f"    s[NS + {k}] = OUTSIDE_INPUTS[{k}];" for k in range(outside)),
        f"    int outcome = {name}_slopes(&t, q, v, x, u, s, PARAMETERS, a, x_dot);",
        "    if (outcome != 1) {",
        "        return outcome;",
        "    }",
        *(f"    double {port.name}[{max(port.size, 1)}];" for port in commanded),
    ]
    if commanded:
        given = ", ".join(p.name for p in commanded)
        lines.append(f"    if ({name}_inputs(&t, q, v, x, u, s, PARAMETERS, {given}) != 0) {{")
        lines += ["        return 2;", "    }"]
    known = {"q": "q", "v": "v", "x": "x", "t": "&t", "p": "PARAMETERS"}
    arguments = [known.get(p.name, f"{p.name}_command") for p in plant.forward.inputs]
    results = ["a" if p.name == "a" else "spare" for p in plant.forward.outputs]
    spare = max([p.size for p in plant.forward.outputs if p.name != "a"], default=0)
    if spare:
        lines.append(f"    double spare[{spare}];")
    if sum(p.size for p in plant.slopes.outputs if p.name == "x_dot"):
        lines += ["    for (int k = 0; k < NX; ++k) {", "        x_dot[k] = 0.0;", "    }"]
    rates = plant.model.programs.get("effect_state_rates")
    if isinstance(rates, Program):
        given = ", ".join(known.get(p.name, f"{p.name}_command") for p in rates.inputs)
        lines += [f"    if ({name}_effect_state_rates({given}, x_dot) > 0) {{", "        return 2;", "    }"]
    lines += [f"    return {name}_forward_dynamics({', '.join([*arguments, *results])});", "}"]
    if plant.closure is not None:
        p = ", PARAMETERS" if any(port.name == "p" for port in plant.closure.inputs) else ""
        lines += [
            "static int closure_at(const double *q, double *residual, double *jacobian)",
            "{",
            f"    return {name}_closure_both(q{p}, residual, jacobian);",
            "}",
        ]
    return "\n".join([*lines, ""])


def source(plant: Plant, tables: str = "") -> str:
    """The whole C file of a run."""
    files = generated(plant)
    name = plant.model.name
    code = files[f"{name}.c"].replace(f'#include "{name}.h"', files[f"{name}.h"])
    parts = ("rows.c", "manifold.c", "chart.c", "branch.c", "anchor.c", "steps.c", "adaptive.c", "simulation.c")
    kernels = [kernel_text(file) for file in parts]
    head = ["#include <math.h>", "#include <stddef.h>", "#include <string.h>", code, constants(plant)]
    head += ["static long evaluations;", "#define COUNT_EVALUATION ++evaluations"]
    return "\n".join([*head, kernel_text("dop853_error.h"), tables or NO_TABLES, adapters(plant), *kernels])


class Library:
    """A compiled run: `start`, then `advance` until it is not going on."""

    def __init__(self, plant: Plant, tables: str = "", flags: Sequence[str] | None = None) -> None:
        self.plant = plant
        text = source(plant, tables)
        with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
            file, library = Path(temporary) / "run.c", Path(temporary) / "run.so"
            file.write_text(text, encoding="utf-8")
            compile_c(file, library, flags=NATIVE_FLAGS if flags is None else flags)
            self.code = ctypes.CDLL(str(library))  # stays mapped when the file is gone
        self.hash = hashlib.sha256(text.encode()).hexdigest()[:16]
        for name in ("simulation_size", "crossing_size"):
            getattr(self.code, name).restype = ctypes.c_size_t
        self.code.simulation_start.restype = self.code.simulation_advance.restype = ctypes.c_int
        self.state = np.zeros(self.code.simulation_size() // 8 + 8)
        nq, nv, nr = plant.sizes["q"], plant.sizes["v"], len(plant.rows)
        self.crossing = np.dtype(
            [("t", "f8"), ("pivot", "f8"), ("q", "f8", (max(nq, 1),)), ("v", "f8", (max(nv, 1),)), ("lost", "f8"),
             ("rows", "f8", (max(nr, 1),))]
        )  # fmt: skip
        assert self.crossing.itemsize == self.code.crossing_size()

    def start(
        self, t: float, q: np.ndarray, v: np.ndarray, x: np.ndarray, *, method: str, h: float, rtol: float,
        atol: float, longest: float, budget: int,
    ) -> int:  # fmt: skip
        """Begin at a state; see simulation.c."""
        d = ctypes.c_double
        arrays = [np.ascontiguousarray(a, dtype=float) for a in (q, v, x)]
        return int(
            self.code.simulation_start(
                _pointer(self.state), d(t), *map(_pointer, arrays), ctypes.c_int(NATIVE_METHODS[method]), d(h), d(rtol),
                d(atol), d(longest), ctypes.c_long(budget),
            )
        )  # fmt: skip

    def advance(self, most: int, times: np.ndarray, written: np.ndarray, q: np.ndarray, v: np.ndarray, x: np.ndarray,
                crossings: np.ndarray, met: np.ndarray) -> int:  # fmt: skip
        """Go on for at most `most` steps; `written` and `met` (one size_t each) count samples and crossings."""
        return int(
            self.code.simulation_advance(
                _pointer(self.state), ctypes.c_long(most), _pointer(times), ctypes.c_size_t(len(times)),
                _pointer(written), _pointer(q), _pointer(v), _pointer(x), _pointer(crossings),
                ctypes.c_size_t(len(crossings)), _pointer(met),
            )
        )  # fmt: skip

    def report(self) -> tuple[float, np.ndarray, np.ndarray, np.ndarray, dict[str, float]]:
        """Time, state and counters now."""
        sizes = self.plant.sizes
        t, numbers = np.zeros(1), np.zeros(8)
        q, v, x = (np.zeros(max(sizes[k], 1)) for k in "qvx")
        self.code.simulation_report(*map(_pointer, (self.state, t, q, v, x, numbers)))
        names = ("steps", "rejected", "careful", "evaluations", "pivot", "h", "reason")
        state = (array[: sizes[k]] for k, array in zip("qvx", (q, v, x), strict=True))
        return (float(t[0]), *state, dict(zip(names, numbers.tolist(), strict=False)))  # type: ignore[return-value]


def _pointer(array: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


ENDINGS = {
    2: "the step had to become too small",
    3: "more steps than most_steps allows",
    4: "the loops could not be closed again",
    5: "the accelerations are not defined",
    6: "at rest in a singular configuration, where several motions begin: none of them is singled out",
}
PORTION = 20_000  # steps between two looks at the progress


def integrate_natively(
    scene: Scene,
    plant: Plant,
    start: tuple[np.ndarray, np.ndarray, np.ndarray],
    progress: Callable[[float], None] | None = None,
) -> History:
    """The run of a scene by the compiled loop."""
    library = Library(plant, table_code(list(scene.tables.values())))
    return run_natively(library, scene, start, progress)


def run_natively(
    library: Library,
    scene: Scene,
    start: tuple[np.ndarray, np.ndarray, np.ndarray],
    progress: Callable[[float], None] | None = None,
) -> History:
    """The run of a scene by a compiled loop that is there already."""
    plant, sizes, times = library.plant, library.plant.sizes, scene.times
    choice, n = scene.integrator, len(scene.times)
    local = max(1e-3 * choice.tolerance, 3e-15)
    q, v, x = (np.zeros((n, max(sizes[k], 1))) for k in "qvx")
    written, met = np.zeros(1, dtype=np.uintp), np.zeros(1, dtype=np.uintp)
    crossings = np.zeros(10_000, dtype=library.crossing)
    h = choice.step or 0.0
    if h:  # outputs fall on ends of steps
        h = 1.0 / scene.rate / max(1, math.ceil(1.0 / scene.rate / h - 1e-9))
    outcome = library.start(
        0.0, *start, method=choice.method, h=h, rtol=local, atol=local,
        longest=choice.longest_step or scene.duration, budget=choice.most_steps,
    )  # fmt: skip
    if outcome == 0:
        outcome = GOING_ON
    while outcome == GOING_ON:
        outcome = library.advance(PORTION, times, written, q, v, x, crossings, met)
        if progress is not None:
            progress(float(times[max(int(written[0]) - 1, 0)]) / scene.duration)
    t, last_q, last_v, last_x, counters = library.report()
    count = int(written[0])
    arrays = [times[:count], q[:count, : sizes["q"]], v[:count, : sizes["v"]], x[:count, : sizes["x"]]]
    if outcome != 0 and (count == 0 or t > times[count - 1]):  # how far it came
        arrays = [np.append(a, [b], axis=0) for a, b in zip(arrays, (t, last_q, last_v, last_x), strict=True)]
    text = "completed" if outcome == 0 else f"stopped at t = {t:.9g} s: {ENDINGS.get(outcome, 'unknown')}"
    if outcome != 0 and plant.closure is not None and counters["pivot"] < 0.25 * plant.pivot:
        text += (
            f"; the closure is near-singular there (smallest pivot {counters['pivot'] / plant.pivot:.2g} of regular)"
        )
    passages = tuple(_passage(plant, c) for c in crossings[: int(met[0])])
    t_all, q_all, v_all, x_all = arrays
    return History(t_all, q_all, v_all, x_all, outcome == 0, text, "c", passages, (), counters)


def _passage(plant: Plant, c: np.void) -> Passage:
    rows = tuple(int(k) for k in np.flatnonzero(c["rows"][: len(plant.rows)] > 0.5))
    return Passage(float(c["t"]), np.array(c["q"][: plant.sizes["q"]]), float(c["pivot"]), int(c["lost"]), rows)


def table_code(tables: Sequence[Table]) -> str:
    """`tables_at` in C: the polynomial pieces of every table as constant data, found by bisection."""
    if not tables:
        return ""
    lines = []
    for k, table in enumerate(tables):
        body = ", ".join(decimal(t) for t in table.times)
        lines.append(f"static const double TABLE_{k}_TIMES[{len(table.times)}] = {{{body}}};")
        rows = ", ".join("{" + ", ".join(decimal(float(c)) for c in row) + "}" for row in table.pieces())
        lines.append(f"static const double TABLE_{k}_PIECES[{len(table.times) - 1}][4] = {{{rows}}};")
    lines += [
        "static double table_at(double t, int count, const double *times, const double (*pieces)[4])",
        "{",
        "    int low = 0, high = count - 1;",
        "    t = t < times[0] ? times[0] : t > times[count - 1] ? times[count - 1] : t;",
        "    while (high - low > 1) {",
        "        const int middle = (low + high) / 2;",
        "        if (t >= times[middle]) {",
        "            low = middle;",
        "        } else {",
        "            high = middle;",
        "        }",
        "    }",
        "    const double d = t - times[low], *c = pieces[low];",
        "    return c[0] + d * (c[1] + d * (c[2] + d * c[3]));",
        "}",
        "static void tables_at(double t, double *s)",
        "{",
    ]
    for k, table in enumerate(tables):
        lines.append(f"    s[{k}] = table_at(t, {len(table.times)}, TABLE_{k}_TIMES, TABLE_{k}_PIECES);")
    return "\n".join([*lines, "}", ""])
