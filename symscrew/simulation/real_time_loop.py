"""The real-time loop of a scene: one step of fixed size as standalone C99.

    int <scene>_step(double dt, double t, double *q, double *v, double *x, const double *u)

It advances a state by dt and puts it back onto the closure of the loops. Nothing is allocated, no state is kept, the
work is bounded. Where the scene commands the drives, u is not read and may be NULL.
"""

from __future__ import annotations

import textwrap
from dataclasses import replace
from pathlib import Path

import numpy as np

from symscrew.effects import Acting
from symscrew.errors import DescriptionError
from symscrew.export import banner, packed, plain
from symscrew.functions import function, q_port, v_port
from symscrew.model import derive
from symscrew.program import Port, lower
from symscrew.scene import INTEGRATION_METHODS, Scene, controller, parameter_values
from symscrew.simulation.initial import initial_state, initial_states
from symscrew.simulation.native import NATIVE_METHODS
from symscrew.simulation.run_source import NO_TABLES, adapters, constants, generated, kernel_text, table_code
from symscrew.simulation.run_time_values import mechanism_at_size
from symscrew.simulation.state_programs import Plant, plant
from symscrew.whole_files import replaced

# methods whose work per step is bounded: compiled ones of fixed step, in the order of the kernels
REAL_TIME = tuple(
    name for name in sorted(NATIVE_METHODS, key=NATIVE_METHODS.__getitem__) if INTEGRATION_METHODS[name].fixed_step
)


# What a step of fixed length cannot do, said where a scene has corners.
CORNERS = (
    "Steps keep their length: none ends where a law changes (the end of a stop, a drive's limit, a knot of a table). "
    "A step across such a corner has an error of second order in its length where a force bends there, of first order "
    "where it jumps, whatever the method's own order; 'symscrew simulate' ends its steps at corners."
)


def corners_told(scene: Scene, made: Plant) -> str:
    """What the user of fixed steps has to know of corners in time and in laws; "" where a scene has none."""
    compares = any(op in ("less", "abs") for program in (made.slopes, made.inputs) for _, op, _ in program.instructions)
    return CORNERS if compares or scene.tables else ""


def loop_plant(scene: Scene, outside: tuple[str, ...] = ()) -> Plant:
    """The programs of the loop: drives from outside unless the scene commands them, and `outside` inputs of effects.

    Raises:
        DescriptionError: the integrator has no fixed step, or contacts switch by events.
    """
    if scene.integrator.method not in REAL_TIME:
        raise DescriptionError(
            f"integrator.method: a loop for real time needs a fixed step, got {scene.integrator.method}; expected one "
            f"of {', '.join(REAL_TIME)}"
        )
    if any(effect.contacts() for effect in scene.effects):
        raise DescriptionError("effects: contacts with events have no loop for real time; use their smooth modes")
    model = derive(mechanism_at_size(scene), scene.effects)
    held = bool(model.system.drives) and not scene.drives
    values = list(parameter_values(scene, model).values())
    made = controller(scene, model, held=held)
    return plant(model, made, held=held, parameters=np.array(values, dtype=float), work=False, outside=outside)


def started_anywhere(made: Plant) -> Plant:
    """The plant with the program of where its effects' states begin: (q, v, p) -> x, for a start that is not known yet.

    The same as `initial_states` of a scene with this start and these parameters; without states, the plant as it is.
    """
    system = made.system
    states = Acting(system, made.model.effects).states
    if not states:
        return made
    begun = [system.geometry.scalar(s.start) for s in states]
    begun = [x if s.carried is None else x + s.carried for x, s in zip(begun, states, strict=True)]
    port = Port(
        "x", (len(states),), tuple(s.unit for s in states), tuple(s.name for s in states), "states at the start"
    )
    given = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v)]
    text = "Where the states of effects begin."
    return replace(made, starts=lower(function(system, "states_at_start", text, inputs=given, outputs=[(port, begun)])))


def print_loop(scene: Scene) -> dict[str, str]:
    """File name to text: `<scene>_loop.h`, `<scene>_loop.c`."""
    made = loop_plant(scene)
    start = initial_state(scene, made.model, made.parameters)
    return {f"{scene.name}_loop.h": _header(scene, made, start), f"{scene.name}_loop.c": loop_source(scene, made)}


def write_loop(scene: Scene, folder: Path) -> list[Path]:
    """Write the loop, `<scene>_loop.h` and `<scene>_loop.c`, into a folder, which is made if it is not there.

    Raises:
        DescriptionError: the integrator has no fixed step, or contacts switch by events.
    """
    files = print_loop(scene)
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for name, text in files.items():

        def make(path: Path, content: str = text) -> None:
            path.write_text(content, encoding="utf-8")

        written.append(replaced(folder / name, make))
    return written


def labelled(name: str, labels: tuple[str, ...]) -> list[str]:
    """Lines of a comment that say what the entries of an array are."""
    entries = packed([plain(f"{k} {label}") for k, label in enumerate(labels)])
    return [f" * {name}[{len(labels)}]:", *(f" * {line}" for line in entries)]


def _header(scene: Scene, made: Plant, start: tuple[np.ndarray, np.ndarray]) -> str:
    name, upper = scene.name, scene.name.upper()
    ports = {port.name: port for port in made.slopes.inputs}
    q, v = start
    states = initial_states(scene, made.model, q, v)

    def initial(key: str, values: np.ndarray) -> str:
        numbers = ", ".join(repr(float(value)) for value in values) or "0.0"
        return f"#define {upper}_{key}_START {{{numbers}}}"

    lines = ["/*", *(f" * {line}".rstrip() for line in banner(made.model)), " *"]
    lines += [f" * One step of {scene.integrator.method} of the scene {name}, projected onto the loops' closure."]
    corners = textwrap.wrap(corners_told(scene, made), 110)
    lines += [*(f" * {line}" for line in corners), " *"]
    for key in ("q", "v", "x", "u"):
        lines += labelled(key, ports[key].labels)
    lines += [
        " *", " * Returns 0: done. 1: the state cannot be continued (loops open, not finite); q, v, x are unchanged.",
        " * 2: at rest in a singular configuration, where several motions begin; unchanged.", " */",
        f"#ifndef {upper}_LOOP_H", f"#define {upper}_LOOP_H", "",
        *(f"#define {upper}_LOOP_{key.upper()}_SIZE {ports[key].size}" for key in ("q", "v", "x", "u")),
        initial("Q", q), initial("V", v), initial("X", states), "",
        "#ifdef __cplusplus", 'extern "C" {', "#endif", "",
        f"int {name}_step(double dt, double t, double *q, double *v, double *x, const double *u);", "",
        "#ifdef __cplusplus", "}", "#endif", "", f"#endif /* {upper}_LOOP_H */", "",
    ]  # fmt: skip
    return "\n".join(lines)


def loop_source(scene: Scene, made: Plant, *, standalone: bool = False) -> str:
    """The loop's C; `standalone` is part of a larger file that begins runs, without the loop's header."""
    files, name = generated(made), made.model.name
    code = files[f"{name}.c"].replace(f'#include "{name}.h"', files[f"{name}.h"])
    method = NATIVE_METHODS[scene.integrator.method]
    head = [
        "" if standalone else f'#include "{scene.name}_loop.h"',
        "#include <math.h>", "#include <stddef.h>", "#include <string.h>", code,
        constants(made), f"#define METHOD {method}", f"#define LOOP_STEP {scene.name}_step", "#define NEEDS_CARE 1004",
        "#define COUNT_EVALUATION (void)0", table_code(list(scene.tables.values())) or NO_TABLES, adapters(made),
    ]  # fmt: skip
    parts = ("rows.c", "manifold.c", "chart.c", "branch.c", "anchor.c", "steps.c", "loop.c")
    return "\n".join([*head, *(kernel_text(part) for part in (*parts, *(["start.c"] if standalone else [])))])
