"""What stands beside the generated code: README examples that run, the C++ header, model.md."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.model_states import model
from support.readme_examples import example, expected, printed, run

from symscrew import catalogue
from symscrew.description.builder import MechanismBuilder
from symscrew.export.c_form import library_sources
from symscrew.export.c_header import print_header
from symscrew.export.example import LONGEST, print_example
from symscrew.export.markdown import READABLE, print_markdown
from symscrew.fmu.unit_archive import at_rest
from symscrew.functions.quantities import Quantities
from symscrew.generation.folder import TARGETS, USUAL
from symscrew.model import derive
from symscrew.runtime.compiled import find_compiler
from symscrew.simulation.motion import simulate

STRICT = ["-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"]


@pytest.fixture(scope="module", params=["four_bar", "pendulum"])
def directory(request, generated, tmp_path_factory) -> Path:
    """All targets of a closed chain; those of an open one, with run-time parameters."""
    folder = tmp_path_factory.mktemp("generated") / request.param
    # the first of open chains, the last in a folder of its own
    apart = ("urdf", "external_hessians", "reduced", "ros2", "modes")
    further = [t for t in TARGETS if t not in apart] if request.param == "four_bar" else [*USUAL, "urdf"]
    shutil.copytree(generated(request.param, further), folder)
    return folder


@pytest.mark.slow
@pytest.mark.parametrize(("title", "file"), [("C", "main.c"), ("C++", "main.cpp")])
def test_compiled_examples_of_the_readme(directory, title, file):
    if find_compiler() is None or (title == "C++" and shutil.which("c++") is None):
        pytest.fail("this test needs compilers of C and C++: apt-get install gcc g++")
    code, command = example(directory, title)
    assert len(code.splitlines()) <= 14
    (directory / file).write_text(code)
    output = run(f"{command} && ./main", directory) if title == "C++" else run(command, directory)
    assert output.startswith("success: ")
    assert printed(output) == pytest.approx(expected(directory), rel=1e-11, abs=1e-11)


@pytest.mark.slow
@pytest.mark.parametrize("title", ["CasADi", "NumPy", "CasADi external functions"])
def test_python_examples_of_the_readme(directory, title):
    if title.endswith("external functions") and directory.name != "four_bar":
        assert title not in (directory / "README.md").read_text()
        return
    code, command = example(directory, title)
    assert len(code.splitlines()) <= 10
    if command:
        run(command, directory)
    (directory / "main.py").write_text(code)
    output = run(f"{sys.executable} main.py", directory)
    assert printed(output) == pytest.approx(expected(directory), rel=1e-11, abs=1e-11)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "title", "package"), [
    ("four_bar", "FMU", "fmpy"), ("four_bar", "MJCF", "mujoco"), ("pendulum", "URDF", "pinocchio"),
])  # fmt: skip
def test_examples_with_other_programs(directory, name, title, package):
    """The four-bar at rest under its weight for 0.1 s; the freedoms of the trees that the files describe."""
    pytest.importorskip(package)
    if directory.name != name:
        return
    code, command = example(directory, title)
    if command:
        run(command, directory)
    (directory / "main.py").write_text(code)
    output = run(f"{sys.executable} main.py", directory)
    if title == "FMU":
        scene = at_rest(model(name).mechanism, model(name).effects)
        integrator = replace(scene.integrator, method="rk4", step=1e-3)
        q = simulate(replace(scene, duration=0.1, rate=10.0, integrator=integrator)).q[-1]
        assert abs(q[0]) > 1e-3 and printed(output) == pytest.approx(q[0], rel=1e-9)
    else:
        assert printed(output) == len(model(name).system.tree.v)


def test_every_file_is_named_in_the_readme(directory):
    text = (directory / "README.md").read_text()
    written = {p.name for p in directory.iterdir() if p.is_file() and p.suffix not in (".casadi", "", ".so", ".o")}
    written -= {"main.c", "main.cpp", "main.py", "main.js", "README.md"}
    for name in written:
        if not name.startswith("lib"):
            assert f"`{name}`" in text, name
    for name in model(directory.name).programs:
        assert f"| `{name}` |" in text


def rows_of(text: str, header: str) -> list[list[str]]:
    """Cells of the table under this header, without the marks of code."""
    lines = text.partition(f"| {header} |\n")[2].split("\n\n")[0].splitlines()[1:]
    return [[cell.strip().strip("`") for cell in line.strip("|").split(" | ")] for line in lines]


def test_tables_of_the_readme_say_what_the_functions_take(directory):
    """Names and units of q, v, u, y in their order, every status, what exists in the recipes, sizes as they are."""
    text, found = (directory / "README.md").read_text(), model(directory.name)
    ports = {p.name: p for f in found.programs.values() for p in (*f.inputs, *f.outputs)}
    of_q = rows_of(text, "k | `q[k]` | unit | of | in the reference")
    assert [row[1:3] for row in of_q] == [list(pair) for pair in zip(ports["q"].labels, ports["q"].units, strict=True)]
    assert np.allclose([float(row[4]) for row in of_q], found.system.reference, atol=1e-9)
    of_u = rows_of(text, "k | `u[k]` | unit | of")
    assert [row[1:3] for row in of_u] == [list(pair) for pair in zip(ports["u"].labels, ports["u"].units, strict=True)]
    if found.independent:
        of_y = rows_of(text, "k | `y[k]` | is")
        assert [row[1] for row in of_y] == list(ports["y"].labels)
        assert [of_q[int(row[2][2:-1])][1] for row in of_y] == list(found.independent)
    told = {int(code) for code, _ in rows_of(text, "status | means")}
    content = json.loads((directory / "manifest.json").read_text())
    assert told >= {int(code) for entry in content["functions"].values() for code in entry["status"]}
    for what, said in content["conventions"].items():
        assert f"- **{what}**: {said[:20]}" in text
    calls = [call for row in rows_of(text, "you want | call") for call in re.findall(r"(\w+)\(", row[1])]
    assert len(calls) > 8 and set(calls) <= set(found.programs)
    sources = rows_of(text, "source | size | functions | operations")
    assert [row[0] for row in sources] == library_sources(content["files"], found.name)
    assert all(row[1] == f"{(directory / row[0]).stat().st_size / 1e3:.0f} kB" for row in sources)
    total = sum(p.operations["total"] for p in found.programs.values())
    assert sum(int(row[3]) for row in sources if row[3]) == total


@pytest.mark.parametrize("longest", [LONGEST, 130, 1])
@pytest.mark.parametrize("name", ["four_bar", "pendulum"])
def test_the_example_is_read_as_a_whole(name: str, longest: int, monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    """Of a large mechanism fewer functions are called, and what is left compiles without a warning."""
    monkeypatch.setattr("symscrew.export.example.LONGEST", longest)
    text = print_example(model(name))
    calls = re.findall(r"failures \+= show_(\w+)\(\)", text)
    assert len(text.splitlines()) <= max(longest, 90) < 200 and calls and len(calls) == text.count("static int show_")
    header = print_header(model(name))
    (tmp_path / f"{name}.h").write_text(header)
    (tmp_path / "example.c").write_text(text)
    run(f"cc -std=c99 -Wall -Wextra -Wconversion -Werror -fsyntax-only {tmp_path / 'example.c'}", tmp_path)


CPP = """
#include "four_bar.hpp"
#include <cstdio>
int main()
{
    const double position[3] = {0.0, 0.0, 0.0};
    std::array<double, 3> rate{0.1, 0.2, 0.3}, change{};
    double drive[1];
    const four_bar::Status status = four_bar::inverse_dynamics(position, rate, change, drive);
    const auto same = four_bar::inverse_dynamics(position, rate, change);
#if defined(__cpp_lib_span)
    const auto viewed = four_bar::inverse_dynamics(std::span<const double, 3>(position), rate, change);
#else
    const auto viewed = same;
#endif
    rate[0] = 0.0 / rate[0] / 0.0;
    const auto failed = four_bar::inverse_dynamics(position, rate, change);
    std::printf("%d %d %d %s\\n", static_cast<int>(status), same.ok(), failed.ok(), four_bar::text(failed.status));
    std::printf("%.17g %.17g %.17g\\n", drive[0], same.u[0], viewed.u[0]);
    return WRONG;
}
"""


@pytest.mark.slow
@pytest.mark.parametrize("standard", ["c++17", "c++20"])
def test_cpp_header(directory, standard):
    """Arrays of C, std::array and std::span; both forms agree; a wrong size does not compile; no warnings."""
    if directory.name != "four_bar":
        return
    compiler = shutil.which("c++")
    if compiler is None:
        pytest.fail("this test needs a C++ compiler: apt-get install g++")
    if not (directory / "four_bar.o").is_file():
        sources = library_sources(json.loads((directory / "manifest.json").read_text())["files"], "four_bar")
        run(f"cc -std=c99 -O0 -r -o four_bar.o {' '.join(sources)}", directory)
    (directory / "main.cpp").write_text(CPP)
    command = [compiler, f"-std={standard}", *STRICT, "main.cpp", "four_bar.o", "-o", "main"]
    right = subprocess.run([*command, "-DWRONG=0"], cwd=directory, capture_output=True, text=True, check=False)
    assert right.returncode == 0, right.stderr
    lines = run("./main", directory).splitlines()
    assert lines[0].startswith("0 1 0 not finite")
    (u,), _ = model("four_bar")("inverse_dynamics", np.zeros(3), np.array([0.1, 0.2, 0.3]), np.zeros(3))
    assert [float(x) for x in lines[1].split()] == pytest.approx([float(u.ravel()[0])] * 3, rel=1e-12)
    short = "-DWRONG=four_bar::inverse_dynamics(std::array<double,2>{},rate,change).ok()"
    wrong = subprocess.run([*command, short], cwd=directory, capture_output=True, text=True, check=False)
    assert wrong.returncode != 0 and "In<3" in wrong.stderr


# -- model.md ------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", ["four_bar", "three_ups_upu_s"])
def test_markdown_holds_every_quantity_or_says_why_not(name):
    found = model(name)
    text = print_markdown(found)["model.md"]
    if name == "four_bar":
        assert text == print_markdown(derive(catalogue.load(name)))["model.md"]
    quantities = Quantities(found.mechanism)
    for joint in found.mechanism.joints:
        assert re.search(rf"^Joint {joint}(\n\n\$\$|: \d+ operations, too many)", text, re.MULTILINE), joint
    for body in found.mechanism.bodies.values():
        if body.mass is not None and body.name != found.mechanism.ground:
            assert re.search(rf"^Body {body.name}(\n\n\$\$|: \d+ operations, too many)", text, re.MULTILINE), body.name
    omitted = [int(n) for n in re.findall(r": (\d+) operations, too many", text)]
    assert all(n > READABLE for n in omitted)
    assert max(len(block) for block in re.findall(r"\$\$\n(.*?)\$\$", text, re.DOTALL)) < 6000
    for cut in quantities.system.cuts:
        assert f"W_{{\\mathrm{{{cut.joint.name.replace('_', chr(92) + '_')}}}}} = " in text or omitted


def test_markdown_names_every_symbol_that_it_uses():
    """Symbols of the formulas are in the table with their units; table symbols are used."""
    text = print_markdown(model("four_bar"))["model.md"]
    table = dict(re.findall(r"^\| \$(.*?)\$ \| (.*?) \|", text, re.MULTILINE))
    formulas = "".join(re.findall(r"\$\$\n(.*?)\$\$", text, re.DOTALL))
    used = set(re.findall(r"(?:\\dot )?\\theta_\{\\mathrm\{\w+\}\}", formulas))
    assert used == set(table)
    assert table[r"\dot \theta_{\mathrm{A}}"] == "rad/s" and table[r"\theta_{\mathrm{A}}"] == "rad"
    for name in set(re.findall(r"z_\{\d+\}", formulas)):
        assert f"\n{name} = " in formulas or formulas.startswith(f"{name} = ")


def test_texts_of_a_description_stay_in_their_cells():
    builder = MechanismBuilder("pendulum")
    builder.parameter("length", "0.5", unit="m", description="of the rod |\nin two lines")
    builder.body("rod", mass=1, com=[0, 0, "-length/2"])
    builder.joint("pivot", "R", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    text = print_markdown(derive(builder.build()))["model.md"]
    assert "| m | of the rod \\| in two lines |" in text


def test_the_screw_of_the_crank_is_the_one_in_the_text():
    text = print_markdown(model("four_bar"))["model.md"]
    column = re.search(r"S_\{\\mathrm\{A\}\} = \\left\(\\begin\{array\}\{c\}\n(.*?)\\end", text, re.DOTALL)
    entries = [int(entry) for entry in re.findall(r"^(-?\d+)", column[1], re.MULTILINE)]
    assert entries == [0, 1, 0, 0, 0, 0]
