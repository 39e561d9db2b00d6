"""The unit itself: sources, model description and, where there is a compiler, a binary, in one archive."""

from __future__ import annotations

import hashlib
import platform
import sys
import tempfile
import zipfile
from dataclasses import replace
from importlib import resources
from pathlib import Path

from symscrew.compiled import compile_c, find_compiler
from symscrew.errors import DescriptionError
from symscrew.export.listing import decimal
from symscrew.fmu.description import describe
from symscrew.fmu.variables import DEFAULT_STEP, variables
from symscrew.scene import Scene
from symscrew.simulation.initial import initial_state, initial_states
from symscrew.simulation.loop import REAL_TIME, loop_plant, loop_source
from symscrew.simulation.programs import Plant

FOLDERS = {"linux": ("linux64", "x86_64-linux"), "darwin": ("darwin64", "x86_64-darwin")}
FLAGS = ("-fvisibility=hidden", "-Wno-unused-function")
DATE = (1980, 1, 1, 0, 0, 0)


def build(scene: Scene, path: Path, *, version: int = 3) -> list[str]:
    """Write a scene as a functional mock-up unit; returns notes for the user.

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
    plant = loop_plant(scene, outside=tuple(given))
    q, v = initial_state(scene, plant.model, plant.parameters)
    start = (q, v, initial_states(scene, plant.model))
    entries = [entry for port in given.values() for entry in port]
    listed = variables(plant, start, entries)
    text = source(scene, plant, start, len(entries), version)
    token = hashlib.sha256(text.encode()).hexdigest()[:32]
    text = text.replace("@TOKEN@", token)
    step = scene.integrator.step or DEFAULT_STEP
    about = scene.mechanism.description or scene.mechanism.name
    xml = describe(version, scene.name, token, about, listed, float(scene.duration), float(step))
    files = {"modelDescription.xml": xml, f"sources/{scene.name}.c": text.encode()}
    if version == 3:
        files["sources/buildDescription.xml"] = build_description(scene.name)
    notes = _add_binary(scene.name, text, version, files)
    _write(path, files)
    return notes


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


def source(scene: Scene, plant: Plant, start: tuple, outside: int, version: int) -> str:  # type: ignore[type-arg]
    """All C of the unit in one file."""

    def numbers(values: object) -> str:
        return "{" + (", ".join(decimal(float(x)) for x in values) or "0.0") + "}"  # type: ignore[attr-defined]

    q, v, x = start
    head = [
        "#if defined(_MSC_VER)", "#define THREAD_LOCAL __declspec(thread)", "#else",
        "#define THREAD_LOCAL __thread", "#endif",
        "#define PARAMETERS_STORAGE static THREAD_LOCAL",
        f"#define NP {len(plant.parameters)}", f"#define NO {outside}",
        f"static THREAD_LOCAL double OUTSIDE[{outside + 1}];", "#define OUTSIDE_INPUTS OUTSIDE",
        f"#define FMU_STEP {decimal(DEFAULT_STEP)}", '#define TOKEN "@TOKEN@"',
        f"#define START_Q {numbers(q)}", f"#define START_V {numbers(v)}", f"#define START_X {numbers(x)}",
        f"#define START_P {numbers(plant.parameters)}",
    ]  # fmt: skip
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


def _add_binary(name: str, text: str, version: int, files: dict[str, bytes]) -> list[str]:
    folders = FOLDERS.get(sys.platform)
    if find_compiler() is None or folders is None or platform.machine() not in ("x86_64", "AMD64"):
        return ["no binary inside: no C compiler for a known platform here; the importer must compile the sources"]
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        file, library = Path(temporary) / f"{name}.c", Path(temporary) / f"{name}.so"
        file.write_text(text, encoding="utf-8")
        compile_c(file, library, flags=FLAGS, native=False)
        files[f"binaries/{folders[version - 2]}/{name}.so"] = library.read_bytes()
    return []


def _write(path: Path, files: dict[str, bytes]) -> None:
    """The archive, with fixed dates so that equal content gives equal bytes; beside the target, then renamed."""
    from symscrew.simulation.files import replaced

    def make(target: Path) -> None:
        with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, data in sorted(files.items()):
                archive.writestr(zipfile.ZipInfo(name, DATE), data, zipfile.ZIP_DEFLATED)

    replaced(path, make)
