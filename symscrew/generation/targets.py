"""The table of targets: what a folder of generated code can hold, an entry for each.

    name -> Target -> its file in this folder, which writes what the target is, runs it and compares its numbers

A further target is one such file and one line here; the command line, `generate`, `check` and the manifest walk the
table. It is read when the command line starts, so that nothing heavy is imported here: a target's file is, when its
target is asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING

from symscrew.errors import DescriptionError, did_you_mean, shorten

if TYPE_CHECKING:
    from symscrew.generation.target_file import Case, Finding, Order


@dataclass(frozen=True)
class Target:
    """One target.

    Attributes:
        module: its file, which holds `files` and, where they apply, `section` and `compare`
            (`symscrew.generation.target_file` says what they take and give).
        about: its files in README.md; {0} is the model's name.
        precisions: "double", and "single" where it can be printed of type float.
        brings: other targets whose files its own ones need.
        by_value: endings of files whose bytes depend on more than this tool: `check` compares their numbers only, and
            they may be missing.
        plain: files that other targets write too, with other content: no folder holds both.
    """

    module: str
    about: str
    precisions: tuple[str, ...] = ("double",)
    brings: tuple[str, ...] = ()
    by_value: tuple[str, ...] = ()
    plain: tuple[str, ...] = ()

    def files(self, order: Order) -> Mapping[str, str | bytes]:
        """File name to content."""
        from symscrew.export import within_width

        made: Mapping[str, str | bytes] = import_module(self.module).files(order)
        return {file: within_width(file, data) if isinstance(data, str) else data for file, data in made.items()}

    def section(self, order: Order) -> Sequence[str]:
        """Lines at the end of README.md; none where its file has no `section`."""
        told: Callable[[Order], Sequence[str]] | None = getattr(import_module(self.module), "section", None)
        return told(order) if told else ()

    def compare(self, case: Case) -> Iterator[Finding]:
        """(passed, what) of every comparison; none where its file has no `compare`, beyond that of bytes."""
        compared: Callable[[Case], Iterator[Finding]] | None = getattr(import_module(self.module), "compare", None)
        if compared:
            yield from compared(case)


ROOM = "symscrew.generation"
C = "`{0}.h` and sources: C99; `{0}.hpp`: the same for C++17; `example.c`, `CMakeLists.txt`: a program to start from"
EXTERNAL = "`{0}_external.c`, `{0}_jacobians.h`, `{0}_jacobians.c`: the C code as external functions of CasADi"
HESSIANS = "`{0}_external_hessians.c`, `{0}_hessians.h`, `{0}_hessians.c`: exact Hessians of the external functions"
REDUCED = "`{0}_reduced.c`, `{0}_ode.casadi`, `{0}_configuration.casadi`: the motion in y alone, for CasADi and acados"
JAX = "`{0}_jax.py`: JAX functions with derivatives of every order, under jit, vmap, grad"
CUDA = "`{0}.cu`, `{0}_cuda.h`: CUDA kernels, one thread a state; the same file compiles as C++"
UNIT = "`{0}.fmu`: functional mock-up unit, FMI 3.0, co-simulation and model exchange, C sources only"
RUST = "`{0}.rs`, `Cargo.toml`: a crate for Rust 1.63 and later, no_std, without unsafe and allocation"
LINUXCNC = "`{0}kins.c`, `{0}_drives.h`, `{0}_drives.c`: kinematics module of LinuxCNC, for `halcompile`"
TEXT = "`{0}.st`: function blocks in structured text, IEC 61131-3, for CODESYS, TwinCAT and others"
DRIVES = "`{0}_drives.st`: a function block between drives and the tool, with what it calls, in structured text"
MODES = "`{0}_modes.c`, `{0}_modes.h`: all assembly modes as C, and the one that a motion stays on, certified"
ROS = "`{0}_kinematics.hpp`: C++17 without ROS; `{0}_transmission.hpp`, `package.xml` ...: two plugins of ros2_control"
SFUN = "`{0}_sfun.c`: level-2 S-function of Simulink around the C, a block per function"
MODELICA = "`{0}.mo`: Modelica package of external functions and blocks around the C"
BOTH = ("double", "single")

TARGETS: dict[str, Target] = {
    "c": Target(f"{ROOM}.c_target", C, precisions=BOTH, plain=("CMakeLists.txt",)),
    "casadi": Target(f"{ROOM}.casadi_target", "`*.casadi`: CasADi functions, one per file", by_value=(".casadi",)),
    "numpy": Target(f"{ROOM}.numpy_target", "`{0}_numpy.py`: NumPy functions on batches of states, without this tool"),
    "external": Target(f"{ROOM}.external_target", EXTERNAL, brings=("c",)),
    "external_hessians": Target(f"{ROOM}.external_hessians_target", HESSIANS, brings=("c", "external")),
    "reduced": Target(f"{ROOM}.reduced_target", REDUCED, brings=("c",), by_value=(".casadi",)),
    "javascript": Target(f"{ROOM}.javascript_target", "`{0}.js`: JavaScript for a page or Node"),
    "rust": Target(f"{ROOM}.rust_target", RUST, precisions=BOTH),
    "linuxcnc": Target(f"{ROOM}.linuxcnc_target", LINUXCNC),
    "jax": Target(f"{ROOM}.jax_target", JAX),
    "cuda": Target(f"{ROOM}.cuda_target", CUDA, precisions=BOTH),
    "st": Target(f"{ROOM}.structured_text_target", TEXT),
    "st_drives": Target(f"{ROOM}.structured_text_drives_target", DRIVES),
    "ros2": Target(f"{ROOM}.ros2_target", ROS, plain=("CMakeLists.txt",)),
    "modes": Target(f"{ROOM}.modes_target", MODES),
    "simulink": Target(f"{ROOM}.simulink_target", SFUN, brings=("c",)),
    "modelica": Target(f"{ROOM}.modelica_target", MODELICA, brings=("c",)),
    "fmu": Target(f"{ROOM}.fmu_target", UNIT),
    "mjcf": Target(f"{ROOM}.mjcf_target", "`{0}.xml`: MJCF for MuJoCo, loops as equality constraints"),
    "urdf": Target(f"{ROOM}.urdf_target", "`{0}.urdf`: URDF"),
    "markdown": Target(
        f"{ROOM}.markdown_target", "`model.md`: screws, momentum screws, equations and symbols to read", precisions=BOTH
    ),
}
USUAL = ("c", "casadi", "numpy")  # where nobody asks for others


def with_brought(names: Iterable[str]) -> tuple[str, ...]:
    """The named targets and those that they bring along, in the order of the table.

    Raises:
        DescriptionError: one of them is unknown.
    """
    wanted = list(names)
    for name in wanted:
        if name not in TARGETS:
            raise DescriptionError(
                f"expected targets among {', '.join(TARGETS)}, got {shorten(name)}; {did_you_mean(name, TARGETS)}"
            )
    brought = {other for name in wanted for other in TARGETS[name].brings}
    return tuple(name for name in TARGETS if name in wanted or name in brought)


def apart(names: Iterable[str]) -> str:
    """Which two of the targets, and of those that they bring along, no folder holds together; else nothing."""
    wanted, holders = list(names), dict[str, str]()
    for name in with_brought(wanted):
        bringing = [other for other in wanted if name in TARGETS[other].brings and name not in wanted]
        shown = f"{name} (brought by {bringing[0]})" if bringing else name
        for file in TARGETS[name].plain:
            if file in holders:
                return f"targets {holders[file]} and {shown} both write {file}; use a directory for each"
            holders[file] = shown
    return ""


def by_value(file: str) -> bool:
    """Whether a file's bytes depend on more than this tool: on the version of a library that writes it."""
    return any(file.endswith(target.by_value) for target in TARGETS.values())


def printable(precision: str) -> tuple[str, ...]:
    """The targets that a precision can have, in the order of the table."""
    return tuple(name for name, target in TARGETS.items() if precision in target.precisions)
