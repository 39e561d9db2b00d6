"""The unit itself: sources, model description and, where there is a compiler, a binary, in one archive.

scene --fixed-step loop in C--> sources/<name>.c + modelDescription.xml + documentation --zip--> <name>.fmu
"""

from __future__ import annotations

import hashlib
import io
import platform
import sys
import tempfile
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from html import escape
from importlib import resources
from pathlib import Path
from typing import IO

from symscrew.description import Mechanism
from symscrew.effects import Effect
from symscrew.errors import DescriptionError
from symscrew.export import decimal
from symscrew.fmu.model_description import describe
from symscrew.fmu.unit_variables import DEFAULT_STEP, Start, Variable, structured, variables
from symscrew.runtime import compile_c, find_compiler
from symscrew.scene import Integrator, Scene
from symscrew.simulation import (
    REAL_TIME,
    Plant,
    initial_state,
    initial_states,
    loop_plant,
    loop_source,
    started_anywhere,
)
from symscrew.whole_files import replaced

# platform -> folder of binaries in FMI 2.0 and 3.0; elsewhere the unit goes without one, and its note says so
FOLDERS = {"linux": ("linux64", "x86_64-linux"), "darwin": ("darwin64", "x86_64-darwin")}
FLAGS = ("-fvisibility=hidden", "-Wno-unused-function")
DATE = (1980, 1, 1, 0, 0, 0)  # the earliest that an archive can hold; the present one would change its bytes
UNIX = 3  # the system that an archive is said to be made on, for the same reason
ABOUT = """Co-simulation takes steps of at most the parameter <code>step</code>, each projected onto the closure of the
loops; model exchange has the states q, v and x. Inputs are the drives (u) and what effects take from outside. Without a
binary for your system, compile the one C file in <code>sources</code>. With q, v or parameters of your own at the
start, states x of effects that you do not give begin where these put them."""


def at_rest(mechanism: Mechanism, effects: Sequence[Effect]) -> Scene:
    """A mechanism that starts at rest in its reference configuration, with the drives as inputs."""
    loop = Integrator("rk4", step=DEFAULT_STEP)
    return Scene(mechanism.name, mechanism, tuple(effects), duration=1.0, rate=100.0, integrator=loop)


def build_unit(scene: Scene, path: Path, *, version: int = 3) -> list[str]:
    """Write a scene as a functional mock-up unit with a binary for this system; returns notes for the user.

    Args:
        scene: its inputs that no table or expression gives become inputs of the unit, with the drives.
        path: the archive, which is replaced whole.
        version: of FMI, 2 or 3.

    Raises:
        DescriptionError: see `unit_contents`.
        CompileError: the compiler refused the unit's C.
    """
    files = unit_contents(scene, version=version)
    notes = [*_other_steps(scene), *_add_binary(scene.name, files[f"sources/{scene.name}.c"], version, files)]
    replaced(path, lambda target: _fill(target, files))
    return notes


def _other_steps(scene: Scene) -> list[str]:
    """What co-simulation does otherwise than the scene's own integrator."""
    method = scene.integrator.method
    if method in REAL_TIME:
        return []
    return [
        f"co-simulation of this unit takes steps of {DEFAULT_STEP:g} s by rk4 (its parameter `step`), not the scene's "
        f"{method} with its tolerance; name a fixed-step method under [integrator] to choose ({', '.join(REAL_TIME)})"
    ]


def archive(files: Mapping[str, bytes]) -> bytes:
    """The bytes of a unit, not compressed: the same on every machine for the same files."""
    made = io.BytesIO()
    _fill(made, files, zipfile.ZIP_STORED)
    return made.getvalue()


def unit_contents(scene: Scene, *, version: int = 3) -> dict[str, bytes]:
    """File name to content of a unit without binaries: model description, sources, documentation.

    Co-simulation takes the scene's own fixed-step method (RK4 where the scene has none), in steps of at most the
    parameter `step`, each projected onto the closure. Model exchange gives q, v and the effects' states x; after a
    step that leaves the closure by more than 1e-10 it asks for an event and projects.

    Raises:
        DescriptionError: the version is not 2 or 3, or the scene has no loop for real time.
    """
    if version not in (2, 3):
        raise DescriptionError(f"FMI version: expected 2 or 3, got {version}")
    if scene.integrator.method not in REAL_TIME:
        scene = replace(scene, integrator=replace(scene.integrator, method="rk4", step=DEFAULT_STEP))
    given = outside_inputs(scene)
    plant = started_anywhere(loop_plant(scene, outside=tuple(given)))
    q, v = initial_state(scene, plant.model, plant.parameters)
    start = (q, v, initial_states(scene, plant.model, q, v))
    entries = [entry for port in given.values() for entry in port]
    step = scene.integrator.step or DEFAULT_STEP
    listed = variables(plant, start, entries, step=step)
    # the token names the sources, in which it stands itself: hashed first, then put in its place
    text = source(scene, plant, start, outside=len(entries), version=version, step=step)
    token = hashlib.sha256(text.encode()).hexdigest()[:32]
    text = text.replace("@TOKEN@", token)
    about = scene.mechanism.description or scene.mechanism.name
    xml = describe(
        listed, version=version, name=scene.name, token=token, text=about,
        duration=float(scene.duration), step=float(step),
    )  # fmt: skip
    files = {"modelDescription.xml": xml, f"sources/{scene.name}.c": text.encode()}
    if version == 3:
        files["sources/buildDescription.xml"] = build_description(scene.name)
    files["documentation/index.html"] = documentation(scene.name, about, listed).encode()
    return files


def outside_inputs(scene: Scene) -> dict[str, list[tuple[str, str]]]:
    """Inputs of effects that the scene does not command: port -> (name, unit) of its entries."""
    from symscrew.model import derive

    model = derive(scene.mechanism, scene.effects)
    ports = model.programs["forward_dynamics"].inputs
    return {
        port.name: [(f"{port.name}.{label}", unit) for label, unit in zip(port.labels, port.units, strict=True)]
        for port in ports
        if port.name not in ("q", "v", "u", "x", "t", "p") and port.name not in scene.inputs
    }


def source(scene: Scene, plant: Plant, start: Start, *, outside: int, version: int, step: float) -> str:
    """All C of the unit in one file; `outside` counts the effects' inputs from outside, `step` [s] is the longest."""

    def numbers(values: Iterable[float]) -> str:
        return "{" + (", ".join(decimal(float(x)) for x in values) or "0.0") + "}"

    q, v, x = start
    head = [
        "#if defined(_MSC_VER)", "#define THREAD_LOCAL __declspec(thread)", "#else",
        "#define THREAD_LOCAL __thread", "#endif",
        "#define PARAMETERS_STORAGE static THREAD_LOCAL",
        f"#define NP {len(plant.parameters)}", f"#define NO {outside}",
        f"static THREAD_LOCAL double OUTSIDE[{outside + 1}];", "#define OUTSIDE_INPUTS OUTSIDE",
        f"#define FMU_STEP {decimal(float(step))}", '#define TOKEN "@TOKEN@"',
        f"#define START_Q {numbers(q)}", f"#define START_V {numbers(v)}", f"#define START_X {numbers(x)}",
        f"#define START_P {numbers(plant.parameters)}",
    ]  # fmt: skip
    if plant.starts is not None:
        known = {"q": "(q)", "v": "(v)", "p": "PARAMETERS"}
        given = ", ".join(known[port.name] for port in plant.starts.inputs)
        call = f"{plant.model.name}_states_at_start({given}, (x))"
        head += [f"#define STARTED_STATES {plant.starts.outputs[0].size}", f"#define STATES_AT_START(q, v, x) {call}"]
    folder = resources.files("symscrew.fmu") / "c"
    parts = [(folder / name).read_text(encoding="utf-8") for name in ("instance.c", f"fmi{version}.c")]
    return "\n".join([*head, loop_source(scene, plant, standalone=True), *parts])


def build_description(name: str) -> bytes:
    """sources/buildDescription.xml of FMI 3.0."""
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<fmiBuildDescription fmiVersion="3.0">\n'
        f'  <BuildConfiguration modelIdentifier="{name}">\n    <SourceFileSet language="C99">\n'
        f'      <SourceFile name="{name}.c"/>\n    </SourceFileSet>\n    <Library name="m"/>\n'
        "  </BuildConfiguration>\n</fmiBuildDescription>\n"
    ).encode()


def documentation(name: str, about: str, listed: Sequence[Variable]) -> str:
    """documentation/index.html: what is inside, the variables, an example with FMPy."""
    shown = next((v.name for v in listed if v.causality == "output"), listed[0].name)
    rows = "\n".join(
        "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in (v.name, v.causality, v.unit, v.description)) + "</tr>"
        for v in listed
    )
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{name}</title></head><body>\n'
        f"<h1>{name}</h1>\n<p>{escape(about)}</p>\n<p>{ABOUT}</p>\n"
        f"<pre>\n{escape(chr(10).join(example(f'{name}.fmu', shown)))}\n</pre>\n"
        f"<table>\n<tr><th>variable</th><th>causality</th><th>unit</th><th>what</th></tr>\n{rows}\n</table>\n"
        "</body></html>\n"
    )


def example(unit: str, shown: str) -> list[str]:
    """Lines of Python that run a unit (a file, or the folder it was unpacked to) for 0.1 s and print a variable."""
    return [
        "from os.path import abspath",
        "",
        "from fmpy import simulate_fmu",
        "",
        f'result = simulate_fmu(abspath("{unit}"), stop_time=0.1, output=["{shown}"], fmi_type="CoSimulation")',
        f"print(f\"{shown}: {{result['{shown}'][-1]:.12g}}\")",
    ]


def readme_section(name: str, coordinate: str) -> list[str]:
    """How to compile and run a unit without binaries, in Markdown; prints the coordinate of this label."""
    code = example("unit", structured("q", coordinate))
    return ["### FMU", "", f"`{unpacked(name)}`", "", "```python", *code, "```"]


def unpacked(name: str) -> str:
    """Commands that unpack a unit of FMI 3.0 without binaries to the folder `unit` and compile it for Linux."""
    binary = "unit/binaries/x86_64-linux"
    compiled = f"cc -std=c99 -O2 -shared -fPIC unit/sources/{name}.c -o {binary}/{name}.so -lm"
    return f"python3 -m zipfile -e {name}.fmu unit && mkdir -p {binary} && {compiled}"


def _add_binary(name: str, text: bytes, version: int, files: dict[str, bytes]) -> list[str]:
    folders = FOLDERS.get(sys.platform)
    if find_compiler() is None or folders is None or platform.machine() not in ("x86_64", "AMD64"):
        return ["no binary inside: no C compiler (apt install gcc) for a known platform; the importer must compile"]
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        file, library = Path(temporary) / f"{name}.c", Path(temporary) / f"{name}.so"
        file.write_bytes(text)
        compile_c(file, library, flags=FLAGS, native=False)
        files[f"binaries/{folders[version - 2]}/{name}.so"] = library.read_bytes()
    return []


def _fill(target: Path | IO[bytes], files: Mapping[str, bytes], compression: int = zipfile.ZIP_DEFLATED) -> None:
    """The archive, with fixed dates and systems so that equal content gives equal bytes."""
    with zipfile.ZipFile(target, "w") as made:
        for name, data in sorted(files.items()):
            entry = zipfile.ZipInfo(name, DATE)
            entry.create_system = UNIX
            made.writestr(entry, data, compression)
