"""Formulations of a closed chain's equations of motion as one compiled library per scene.

plant (generated functions of a scene), kernels/*.c --print, compile--> Formulated --run(formulation, March)--> q, v
"""

from __future__ import annotations

import ctypes
import time
from collections.abc import Mapping
from dataclasses import dataclass, replace
from importlib import resources

import numpy as np

from symscrew.export import decimal
from symscrew.model import Model
from symscrew.program import Iteration, Port, Program
from symscrew.scene import Scene
from symscrew.simulation import NATIVE_FLAGS, NO_TABLES, Linker, Operand, Plant, kernel_text, table_code
from symscrew.studies.accuracy.compiled_loops import compiled, one_file, pointer
from symscrew.studies.accuracy.measuring import Stopwatch

Array = np.ndarray
Start = tuple[Array, Array, Array]  # q, v and the effects' states x at the beginning of a run
TREE = "joint coordinates (no loops)"
FORMULATIONS = {
    TREE: 0,
    "no stabilisation": 0,
    "projection": 1,
    "Baumgarte": 2,
    "stabilised (Gear-Gupta-Leimkuhler)": 3,
    "penalty": 4,
    "minimal coordinates": 5,
}
METHODS = {"RK4": 0, "DOP853": 1}
ENDINGS = {
    1: "a pivot of the accelerations is small: near-singular",
    2: "the result is not finite",
    1001: "the accelerations are not defined, or the loops could not be closed",
    1003: "more steps than allowed",
    1004: "the step had to become too small",
}
ALPHA = 1e7
"""Penalty factor, by the largest entry of the mass matrix without units (Bayo, Garcia de Jalon, Serna, 1988)."""


@dataclass(frozen=True)
class March:
    """How a run advances: RK4 in steps of h [s], or DOP853 from a first step h at a local tolerance.

    `gain` is Baumgarte's [1/s], `most` the steps after which the run is given up.
    """

    method: str
    h: float
    tolerance: float
    gain: float
    most: int

    @property
    def setting(self) -> str:
        """What tables and plots call it."""
        return f"step {self.h:.3g} s" if self.method == "RK4" else f"tolerance {self.tolerance:g}"


@dataclass(frozen=True)
class Formulated:
    """A compiled library and what its calls need: the start (q, v, x) and y's places in q."""

    library: ctypes.CDLL
    plant: Plant
    start: Start
    independent: tuple[int, ...]
    kinds: tuple[str, ...]
    alpha: float

    def __repr__(self) -> str:
        return f"Formulated({self.plant.model.name}: {', '.join(self.kinds)})"

    def run(self, formulation: str, times: Array, march: March) -> tuple[float, Array, Array]:
        """Seconds of the run, and q, v at all times; raises ArithmeticError where it ends early."""
        q, v, x = self.start
        state = np.concatenate([q, v, x])
        if formulation == "minimal coordinates":
            state = np.concatenate([q[list(self.independent)], self._rates(q, v), x])
        found_q, found_v = np.zeros((len(times), len(q))), np.zeros((len(times), max(len(v), 1)))
        steps, evaluations = ctypes.c_long(march.most), ctypes.c_long(0)
        d, begin = ctypes.c_double, time.thread_time()
        outcome = self.library.march(
            ctypes.c_int(FORMULATIONS[formulation]), ctypes.c_int(METHODS[march.method]), d(march.gain), d(self.alpha),
            d(march.h), d(march.tolerance), pointer(state), pointer(q), pointer(times), ctypes.c_size_t(len(times)),
            pointer(found_q), pointer(found_v), ctypes.byref(steps), ctypes.byref(evaluations),
        )  # fmt: skip
        taken = time.thread_time() - begin
        if outcome:
            raise ArithmeticError(ENDINGS.get(outcome, f"status {outcome}"))
        return taken, found_q, found_v

    def _rates(self, q: Array, v: Array) -> Array:
        from symscrew.studies.platform_motion import coordinate_rates

        return coordinate_rates(self.plant.model, q, v)[list(self.independent)]


def formulated(plant: Plant, scene: Scene, start: Start, watch: Stopwatch) -> Formulated:
    """Print and compile the library of a scene; a formulation that cannot be had is not among `kinds`."""
    model = plant.model
    programs: dict[str, Program | Iteration] = {"slopes": plant.slopes, "inputs": plant.inputs}
    programs["forward_dynamics"] = plant.forward
    kinds = [TREE] if plant.closure is None else ["no stabilisation"]
    independent: tuple[int, ...] = ()
    spheres: tuple[int, ...] = ()
    assemble = model.programs.get("assemble")
    if plant.closure is not None:
        programs |= {name: model.programs[name] for name in ("closure", "closure_jacobian")}
        kinds += ["projection", "Baumgarte", "stabilised (Gear-Gupta-Leimkuhler)"]
        terms = penalty_terms(model, plant)
        programs["penalty_terms"] = terms if terms is not None else _nothing(plant)
        kinds += ["penalty"] if terms is not None else []
        if assemble is not None and len(assemble.inputs[0].labels) == len(plant.units) - plant.rank:
            programs |= {"assemble": assemble, "velocity": model.programs["velocity"]}
            labels = [c.label for c in model.system.tree.q]
            independent = tuple(labels.index(label) for label in assemble.inputs[0].labels)
            spheres = tuple(int(model.system.tree.q[k].kind == "quaternion") for k in independent)
            kinds.append("minimal coordinates")
    text = watch("print", _source, plant, scene, programs, independent=independent, spheres=spheres)
    library = watch("compile", compiled, text, NATIVE_FLAGS)
    return Formulated(library, plant, start, independent, tuple(kinds), ALPHA * _largest_mass(model, plant, start))


def _largest_mass(model: Model, plant: Plant, start: Start) -> float:
    ports = model.programs["mass_matrix"].inputs
    known = {"q": start[0], "x": start[2], "p": plant.parameters}
    matrix = model("mass_matrix", *[known[port.name][: port.size] for port in ports])[0][0].reshape(
        len(plant.units), -1
    )
    return float(np.abs(matrix * plant.units[:, None] * plant.units).max())


def penalty_terms(model: Model, plant: Plant) -> Program | None:
    """Mass matrix, forces on the freedoms and the closure's bias of the tree, under the scene's controller.

    None where a drive or an effect acts on a cut joint: the tree alone does not have its force.
    """
    system = model.system
    rows = system.drive_rows()
    found = [model.programs.get(name) for name in ("mass_matrix", "bias", "closure_bias")]
    programs = [program for program in found if isinstance(program, Program)]
    if len(rows) != len(system.drives) or len(programs) < len(found):
        return None
    mass, bias, closure_bias = programs
    linker = Linker(plant.slopes.inputs)
    commands = {k.removesuffix("_command"): v for k, v in linker.call(plant.inputs, {}).items()}
    known: dict[str, tuple[Operand, ...]] = dict(commands)
    own = next((p.size for p in plant.forward.inputs if p.name == "x"), 0)
    known["x"] = linker.entries["x"][:own]
    try:
        terms = {**linker.call(mass, known), **linker.call(bias, known)}
        curvature = linker.call(closure_bias, known)["bias"]
    except ValueError:
        return None
    force = [linker.apply("neg", b) for b in terms["bias"]]
    for v, u in rows.items():
        force[v] = linker.apply("add", force[v], commands["u"][u])
    ports = (mass.outputs[0], Port("force", bias.outputs[0].shape, *_of(bias.outputs[0])), closure_bias.outputs[0])
    values = (terms["mass_matrix"], force, curvature)
    return linker.program("penalty_terms", "What a penalty formulation needs.", list(zip(ports, values, strict=True)))


def _of(port: Port) -> tuple[tuple[str, ...], tuple[str, ...], str]:
    return port.units, port.labels, "generalised forces without accelerations"


def _nothing(plant: Plant) -> Program:
    """Terms that are never asked for."""
    return replace(plant.slopes, name="penalty_terms", outputs=(), results=(), instructions=(), guards=())


def _source(
    plant: Plant,
    scene: Scene,
    programs: Mapping[str, Program | Iteration],
    *,
    independent: tuple[int, ...],
    spheres: tuple[int, ...],
) -> str:
    """The library as one C text: generated functions, adapters with the kernels' names, the kernels."""
    model, name = plant.model, plant.model.name
    lines = ["#include <math.h>", "#include <stddef.h>", "#include <string.h>", one_file(model, programs)]
    lines += [*_constants(plant), table_code(list(scene.tables.values())) or NO_TABLES]
    lines += [*_adapters(plant), _list("INDEPENDENT", independent), _list("OF_SPHERE", spheres)]
    parameters = plant.sizes["p"] > 0
    p = ", PARAMETERS" if parameters else ""
    if "penalty_terms" in programs:
        used = bool(programs["penalty_terms"].outputs)
        call = f"{name}_penalty_terms(&t, q, v, x, u, s, PARAMETERS, mass, force, bias)" if used else "FAILED"
        lines += [
            "static int terms_at(double t, const double *q, const double *v, const double *x, double *mass,",
            "                    double *force, double *bias)",
            "{",
            "    double s[NS + 1], u[1] = {0.0};",
            "    tables_at(t, s);",
            *(["    (void)u;"] if used else ["    (void)q, (void)v, (void)x, (void)mass, (void)force, (void)bias;"]),
            f"    return {call};",
            "}",
        ]
    if plant.closure is not None:
        has = "assemble" in programs
        velocity_p = p if has and any(i.name == "p" for i in programs["velocity"].inputs) else ""
        assemble_p = p if has and any(i.name == "p" for i in programs["assemble"].inputs) else ""
        first = f"{name}_assemble(y, guess{assemble_p}, q)" if has else "FAILED + (y == guess) + (q == y)"
        second = f"{name}_velocity(q, y_dot{velocity_p}, v)" if has else "FAILED + (q == y_dot) + (q == v)"
        lines += [
            f"static int assembled_at(const double *y, const double *guess, double *q) {{ return {first}; }}",
            f"static int rates_of(const double *q, const double *y_dot, double *v) {{ return {second}; }}",
        ]
    folder = resources.files("symscrew.studies.accuracy").joinpath("kernels")
    closure, kernel = (folder.joinpath(f).read_text(encoding="utf-8") for f in ("closure.c", "formulations.c"))
    stages = kernel_text("dop853_stages.c")
    lines += [kernel_text("dop853_error.h"), closure]
    lines.append(kernel.replace('#include "dop853_stages.c"', stages))
    return "\n".join([*lines, ""])


def _constants(plant: Plant) -> list[str]:
    """Sizes and units that the kernels read."""
    tree, sizes = plant.system.tree, plant.sizes
    spheres, plain = tree.spheres, tree.plain
    nq, nv, nr = sizes["q"], sizes["v"], len(plant.rows)
    numbers = {
        "NQ": nq, "NV": nv, "NX": sizes["x"], "NS": plant.tables, "NR": nr, "RANK": plant.rank, "FREE": nv - plant.rank,
        "NQ1": max(nq, 1), "NV1": max(nv, 1), "RANK1": max(plant.rank, 1), "PLAIN_COUNT": len(plain),
        "SPHERE_COUNT": len(spheres),
    }  # fmt: skip
    lines = [f"#define {name} {value}" for name, value in numbers.items()]
    for name, pairs in (("PLAIN", plain), ("SPHERES", spheres)):
        body = ", ".join(f"{{{a}, {b}}}" for a, b in pairs) or "{0, 0}"
        lines.append(f"static const int {name}[{max(len(pairs), 1)}][2] = {{{body}}};")
    for name, values in (("UNIT", plant.units), ("ROW_SCALE", plant.rows), ("PARAMETERS", plant.parameters)):
        body = ", ".join(decimal(float(v)) for v in values) or "1.0"
        lines.append(f"static const double {name}[{max(len(values), 1)}] = {{{body}}};")
    return lines


def _adapters(plant: Plant) -> list[str]:
    """Generated functions by the names that the kernels use: forces_at and closure_at."""
    name, commanded = plant.model.name, list(plant.inputs.outputs)
    known = {"q": "q", "v": "v", "x": "x", "t": "&t", "p": "PARAMETERS"}
    arguments = [known.get(p.name, f"{p.name}_command") for p in plant.forward.inputs]
    results = [{"a": "a"}.get(p.name, f"spare_{p.name}") for p in plant.forward.outputs]
    lines = [
        "static int forces_at(double t, const double *q, const double *v, const double *x, double *a, double *x_dot)",
        "{",
        "    double s[NS + 1], u[1] = {0.0};",
        "    tables_at(t, s);",
        f"    const int outcome = {name}_slopes(&t, q, v, x, u, s, PARAMETERS, a, x_dot);",
        "    if (outcome != 1) {",
        "        return outcome;",
        "    }",
        *(f"    double {port.name}[{max(port.size, 1)}];" for port in commanded),
        *(f"    double spare_{p.name}[{max(p.size, 1)}];" for p in plant.forward.outputs if p.name != "a"),
    ]
    if commanded:
        given = ", ".join(p.name for p in commanded)
        lines.append(f"    if ({name}_inputs(&t, q, v, x, u, s, PARAMETERS, {given}) != 0) {{")
        lines += ["        return 2;", "    }"]
    lines += ["    memset(x_dot, 0, sizeof(double) * NX);"]
    lines += [f"    return {name}_forward_dynamics({', '.join([*arguments, *results])});", "}"]
    if plant.closure is not None:
        calls = []
        for function, result in (("closure", "residual"), ("closure_jacobian", "jacobian")):
            own = any(port.name == "p" for port in plant.model.programs[function].inputs)
            calls.append(f"{name}_{function}(q{', PARAMETERS' if own else ''}, {result})")
        lines += [
            "static int closure_at(const double *q, double *residual, double *jacobian)",
            "{",
            f"    return {' | '.join(calls)};",
            "}",
        ]
    return lines


def _list(name: str, values: tuple[int, ...]) -> str:
    body = ", ".join(decimal(float(v)).split(".")[0] for v in values) or "0"
    return f"static const int {name}[{max(len(values), 1)}] = {{{body}}};"
