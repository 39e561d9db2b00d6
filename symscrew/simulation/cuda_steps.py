"""Steps of a scene on many states at once as CUDA, a thread a state; the same file is plain C++.

    int <scene>_steps(count, stride, t, h, steps, q, v, x, u, status, taken, stream)       entry k of state i lies at
                                                                                           [k * stride + i]

The kernels of the loop in C (`symscrew.simulation.real_time_loop`) around the device functions of the scene's
programs: the step of the same method, put back onto the loops. What a thread does not do is left to the processor: a
state near a singular configuration, or with a small pivot of the accelerations, stays where it is and says so.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from symscrew.export import CUDA_THREADS, banner, print_device
from symscrew.model import Model
from symscrew.runtime import cpp_module, cuda_module
from symscrew.scene import Scene
from symscrew.simulation.native import NATIVE_METHODS
from symscrew.simulation.real_time_loop import corners_told, labelled, loop_plant
from symscrew.simulation.run_source import NO_TABLES, constants, kernel_text, table_code
from symscrew.simulation.state_programs import Plant
from symscrew.whole_files import replaced

SLOPES = {"euler": 1, "semi_implicit_euler": 1, "rk4": 4, "rk8": 12}  # that a step of the method computes
KERNELS = ("rows.c", "manifold.c", "steps.c")
MACROS = """\
#if defined(__CUDACC__) || defined(__CUDACC_RTC__)
#define OWN static __device__
#define ROUTINE static __device__
#define CALLED static __device__ __noinline__
#else
#include <math.h>
#include <string.h>
#define OWN static
#define ROUTINE static inline
#define CALLED static inline
#endif
#define KERNEL UPPER_KERNEL
#define FIRST_STATE UPPER_FIRST
#define NEXT_STATE UPPER_STEP
#define PARAMETERS_STORAGE OWN const
#define CHARTS 0
#define DENSE 1
#define COUNT_EVALUATION (void)0
"""
COLUMNS = 112  # of the text of the header
ABOUT = (
    "Steps of {} of the scene {}, each put back onto the loops, of many states at once: from the time t, `steps` steps "
    "of h [s]. Arrays are on the device that runs the kernel; entry k of state i lies at [k * stride + i], stride >= "
    "count. q, v and x are read and written; u: {}. A status and a number of steps taken per state, 0: all of them. 1: "
    "the state cannot go on, or a pivot of its accelerations is small. 3: it comes near a singular configuration. Then "
    "q, v and x are those of the last good step, from which the loop in C, or `symscrew simulate --many`, goes on. A "
    "call does not wait for the device; it returns what cudaGetLastError says, 0 where all is well."
)


def print_steps(scene: Scene) -> dict[str, str]:
    """File name to text: `<scene>_steps.cu`, `<scene>_steps.h`.

    Raises:
        DescriptionError: as of the loop for real time: a method without fixed steps, contacts with events.
    """
    made = loop_plant(scene)
    return {f"{scene.name}_steps.cu": _source(scene, made), f"{scene.name}_steps.h": _header(scene, made)}


def write_steps(scene: Scene, folder: Path) -> list[Path]:
    """Write both files into a folder, which is made if it is not there; raises as `print_steps`."""
    files = print_steps(scene)
    folder.mkdir(parents=True, exist_ok=True)
    return [replaced(folder / name, _writer(text)) for name, text in files.items()]


@dataclass(frozen=True)
class ManySteps:
    """The step of a scene on many states, on a device or as C++: `advance` takes arrays (size, states) of `library`."""

    plant: Plant
    kernel: Any
    library: Any

    def advance(
        self, q: Any, v: Any, x: Any = None, *, u: Any = None, t: float = 0.0, h: float, steps: int
    ) -> tuple[Any, Any, Any, Any, Any]:
        """q, v, x, status and the number of steps taken (states) after so many steps of h [s] from the time t [s].

        `u`: drives that are held, where the scene commands none. States whose status is not 0 are those of their last
        good step: 1, they cannot go on; 3, near a singular configuration.

        Raises:
            ValueError: an array of another shape, or one that is missing.
        """
        make, sizes = self.library, self.plant.sizes
        count = q.shape[-1] if getattr(q, "ndim", 0) == 2 else -1
        arrays = []
        for name, given in (("q", q), ("v", v), ("x", x), ("u", u)):
            given = make.zeros((0, count)) if given is None else given
            if getattr(given, "shape", None) != (sizes[name], count):
                raise ValueError(f"expected {name} of ({sizes[name]}, states), got {getattr(given, 'shape', given)}")
            room = make.zeros((max(sizes[name], 1), count))
            room[: sizes[name]] = given
            arrays.append(room)
        status, taken = make.zeros(count, dtype="int32"), make.zeros(count, dtype="int32")
        if count:
            numbers = (make.uint64(count), make.uint64(count), make.float64(t), make.float64(h), make.int32(steps))
            self.kernel((-(-count // CUDA_THREADS),), (CUDA_THREADS,), (*numbers, *arrays, status, taken))
        q, v, x, _ = arrays
        return q, v, x[: sizes["x"]], status, taken


def load_steps(scene: Scene, *, as_cpp: bool = False) -> ManySteps:
    """The step of a scene on the CUDA device that is there; `as_cpp`: as loops on this processor, on NumPy's arrays.

    Raises:
        DescriptionError: as `print_steps`.
        CompileError: CuPy or a device is missing, or for `as_cpp` a C++ compiler.
    """
    made = loop_plant(scene)
    text = _source(scene, made, launched=False)
    module, library = cpp_module(text, scene.name) if as_cpp else cuda_module(text)
    return ManySteps(made, module.get_function(f"{scene.name}_steps_kernel"), library)


def _writer(text: str) -> Callable[[Path], object]:
    return lambda path: path.write_text(text, encoding="utf-8")


def _source(scene: Scene, made: Plant, *, launched: bool = True) -> str:
    programs = {"slopes": made.slopes}
    if made.closure is not None:
        programs["closure_both"] = replace(made.closure, name="closure_both")
    model, method = made.model, scene.integrator.method
    small = Model(model.name, model.mechanism, model.effects, programs, {}, made.system)
    tables = table_code(list(scene.tables.values())) or NO_TABLES
    about = [*banner(model), f"Steps of {scene.integrator.method} of the scene {scene.name}: see {scene.name}_steps.h."]
    parts = [
        "/*", *(f" * {line}".rstrip() for line in about), " */",
        print_device(small), MACROS.replace("UPPER", model.name.upper()), f"#define SLOPES {SLOPES[method]}",
        on_device(constants(made)),
        f"#define NU1 {max(made.sizes['u'], 1)}", f"#define METHOD {NATIVE_METHODS[method]}",
        f"#define STEPS_KERNEL {scene.name}_steps_kernel", on_device(tables), _adapters(made),
        *(on_device(kernel_text(name)) for name in KERNELS), kernel_text("march.c"), _launch(scene) if launched else "",
    ]  # fmt: skip
    return "\n".join(parts)


def on_device(text: str) -> str:
    """A kernel of the loop in C as it stands on a device: what is static is of the device."""
    text = re.sub(r"^static const ", "OWN const ", text, flags=re.MULTILINE)
    return re.sub(r"^static (inline )?", "ROUTINE ", text, flags=re.MULTILINE)


def _adapters(made: Plant) -> str:
    """The device functions by the names that the kernels use."""
    name = made.model.name
    lines = [
        "CALLED int forces_at(double t, const double *q, const double *v, const double *x, const double *u, double *a,",
        "                     double *x_dot)",
        "{",
        f"    double s[{max(made.tables, 1)}];",
        "    tables_at(t, s);",
        f"    return {name}_slopes(&t, q, v, x, u, s, PARAMETERS, a, x_dot);",
        "}",
    ]
    if made.closure is not None:
        p = ", PARAMETERS" if any(port.name == "p" for port in made.closure.inputs) else ""
        lines += [
            "CALLED int closure_at(const double *q, double *residual, double *jacobian)",
            "{",
            f"    return {name}_closure_both(q{p}, residual, jacobian);",
            "}",
        ]
    return "\n".join([*lines, ""])


def _declaration(scene: Scene) -> str:
    return (
        f"int {scene.name}_steps(size_t count, size_t stride, double t, double h, int steps, double *q, double *v,\n"
        "    double *x, const double *u, int *status, int *taken, void *stream)"
    )


def _launch(scene: Scene) -> str:
    handed = "count, stride, t, h, steps, q, v, x, u, status, taken"
    return "\n".join(
        [
            "#if !defined(__CUDACC_RTC__)",
            f'#include "{scene.name}_steps.h"',
            f'extern "C" {_declaration(scene)}',
            "{",
            "    if (count == 0) {",
            "        return 0;",
            "    }",
            "#if defined(__CUDACC__)",
            f"    const unsigned blocks = (unsigned)((count + {CUDA_THREADS - 1}) / {CUDA_THREADS});",
            f"    STEPS_KERNEL<<<blocks, {CUDA_THREADS}, 0, (cudaStream_t)stream>>>({handed});",
            "    return (int)cudaGetLastError();",
            "#else",
            "    (void)stream;",
            f"    STEPS_KERNEL({handed});",
            "    return 0;",
            "#endif",
            "}",
            "#endif",
            "",
        ]
    )


def _header(scene: Scene, made: Plant) -> str:
    guard, sizes = f"{scene.name.upper()}_STEPS_H", made.sizes
    ports: Mapping[str, tuple[str, ...]] = {port.name: port.labels for port in made.slopes.inputs}
    held = "drives that are held during the steps" if sizes["u"] else "not read, may be NULL: the scene commands"
    about = [
        *banner(made.model),
        "",
        *textwrap.wrap(
            f"{ABOUT.format(scene.integrator.method, scene.name, held)} {corners_told(scene, made)}", COLUMNS
        ),
        "",
    ]
    for key in ("q", "v", "x", "u"):
        about += [line.removeprefix(" * ") for line in labelled(key, ports[key])]
    upper = scene.name.upper()
    lines = ["/*", *(f" * {line}".rstrip() for line in about), " */", f"#ifndef {guard}", f"#define {guard}", ""]
    lines += ["#include <stddef.h>", ""]
    lines += [f"#define {upper}_STEPS_{key.upper()}_SIZE {sizes[key]}" for key in ("q", "v", "x", "u")]
    lines += ["", "#ifdef __cplusplus", 'extern "C" {', "#endif", "", f"{_declaration(scene)};", ""]
    lines += ["#ifdef __cplusplus", "}", "#endif", "", f"#endif /* {guard} */", ""]
    return "\n".join(lines)
