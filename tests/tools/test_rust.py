"""The Rust of models: compiled by rustc, equal to the C bit for bit, and what must not be in it."""

from __future__ import annotations

import ctypes
import dataclasses
import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import pytest
from support.limb_platforms import platform
from support.marks import slow
from support.model_states import model
from support.readme_examples import example
from support.second_path import FUNCTIONS, always_second, states

from symscrew.export import DOUBLE, PRECISIONS, RustNames, print_c, print_rust
from symscrew.generation import generate, rust_target
from symscrew.model import Model, derive
from symscrew.program import NOT_ON_MECHANISM, OUT_OF_REACH
from symscrew.verification import check

Inputs = Mapping[str, Sequence[np.ndarray]]
EVERY_KIND = (
    "assemble",
    "velocity",
    "forward_dynamics_reactions",
    "inverse_dynamics_platform",
    "limb_margins",
    "closure",
)
KINDS = {"double": np.dtype("<f8"), "single": np.dtype("<f4")}


@pytest.fixture
def rustc() -> str:
    found = shutil.which("rustc")
    if found is None:
        pytest.skip("needs rustc (Debian: rustc)")
    return found


def in_rust(rustc: str, found: Model, folder: Path, given: Inputs, precision: str = "double") -> Mapping:
    """Results of functions in Rust, optimised."""
    for file, text in print_rust(found, PRECISIONS[precision]).items():
        (folder / file).write_text(text)
    assert rust_target.build(rustc, found, folder, {"double": "f64", "single": "f32"}[precision]) == ""
    return rust_target.call(found, folder, given, KINDS[precision])


def in_c(found: Model, folder: Path, precision: str = "double") -> ctypes.CDLL:
    """The C without contraction, with the library's sines one by one."""
    for file, text in print_c(found, precision=PRECISIONS[precision], batches=False).items():
        (folder / file).write_text(text)
    command = ["cc", "-std=c99", "-O1", "-ffp-contract=off", f"-D{found.name.upper()}_SCALAR", "-shared", "-fPIC"]
    subprocess.run([*command, f"{found.name}.c", "-o", "c.so", "-lm"], cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "c.so"))


def differences(found: Model, made: Mapping, library: ctypes.CDLL, given: Inputs) -> tuple[list[str], set[int]]:
    """Where the bits of C and Rust differ, NaN being NaN, and which statuses came."""
    wrong, seen = [], set[int]()
    for name, arrays in given.items():
        results, status = made[name]
        ports = found.programs[name].outputs
        for k in range(len(status)):
            places = [np.zeros(max(port.size, 1), arrays[0].dtype) for port in ports]
            every = [*(np.ascontiguousarray(x[k]) for x in arrays), *places]
            code = library[f"{found.name}_{name}"](*[ctypes.c_void_p(x.ctypes.data) for x in every])
            seen.add(code)
            if code != status[k]:
                wrong.append(f"{name}: status {code} in C, {status[k]} in Rust")
            for port, ours, theirs in zip(ports, results, places, strict=True):
                nan = np.isnan(ours[k]).all() and np.isnan(theirs[: port.size]).all()
                if not nan and ours[k].tobytes() != theirs[: port.size].tobytes():
                    wrong.append(f"{name}, {port.name}: {ours[k]} and {theirs}")
    return wrong, seen


def inputs(found: Model, precision: str) -> Inputs:
    return {
        name: [x.astype(KINDS[precision]) for x in given]
        for name, given in found.test_inputs.items()
        if name in found.programs
    }


@pytest.mark.parametrize(
    ("name", "precision"),
    [("four_bar", "double"), ("four_bar", "single"), slow("planar_3rrr", "double")],
)
def test_rust_equals_c_bit_for_bit(name: str, precision: str, rustc: str, tmp_path: Path) -> None:
    found = model(name).only(EVERY_KIND)
    given = inputs(found, precision)
    made = in_rust(rustc, found, tmp_path, given, precision)
    wrong, seen = differences(found, made, in_c(found, tmp_path, precision), given)
    assert wrong == [] and 0 in seen


@pytest.mark.parametrize(("name", "precision"), [("four_bar", "double"), ("differential", "double")])
def test_the_second_path_is_the_same(name: str, precision: str, rustc: str, tmp_path: Path) -> None:
    """With and without internal loads, and from states that are not finite."""
    found = always_second(model(name)).only(FUNCTIONS)
    q, v, u = (x.astype(KINDS[precision]) for x in states(found))
    q[-1, 0] = np.nan
    given = dict.fromkeys(FUNCTIONS, (q, v, u))
    made = in_rust(rustc, found, tmp_path, given, precision)
    wrong, seen = differences(found, made, in_c(found, tmp_path, precision), given)
    assert wrong == [] and seen & {-1, -2} and seen & {1, 2}


def test_what_is_refused_is_refused_with_the_same_status(rustc: str, tmp_path: Path) -> None:
    """Quaternions that are no rotations, poses off the mechanism and out of reach, branches, infinite numbers."""
    names = ("inverse_kinematics", "assemble", "velocity")
    found = derive(platform("PRS")).only(names)
    given: dict[str, list[np.ndarray]] = {}
    for name in names:
        port = next((p for p in found.programs[name].inputs if p.forms), found.programs[name].inputs[0])
        rows: list[list[np.ndarray]] = []
        for size, shift in ((1.0, 0.0), (1 + 6e-7, 0.0), (0.0, 0.0), (1.0, 1e-3), (1.0, 50.0), (1e200, 0.0)):
            row = [np.array(x[1]) for x in found.test_inputs[name]]
            place = found.programs[name].inputs.index(port)
            turned = [k for k, form in enumerate(port.forms) if form] or [0]
            row[place][turned] *= size
            row[place if name == "inverse_kinematics" else 0][:3] += shift
            rows.append(row)
        given[name] = [np.array(column) for column in zip(*rows, strict=True)]
    made = in_rust(rustc, found, tmp_path, given)
    wrong, seen = differences(found, made, in_c(found, tmp_path), given)
    assert wrong == [] and seen >= {0, 2, 5, NOT_ON_MECHANISM} and max(seen) >= OUT_OF_REACH


OWN = """
#![no_std]
pub struct Own;
impl four_bar::Math for Own {
    fn sin(x: f64) -> f64 { x }
    fn cos(_: f64) -> f64 { 1.0 }
    fn tan(x: f64) -> f64 { x }
    fn atan2(y: f64, _: f64) -> f64 { y }
    fn exp(x: f64) -> f64 { 1.0 + x }
    fn sqrt(x: f64) -> f64 { x }
}
pub fn rates(q: &four_bar::Q, y_dot: &four_bar::YDot) -> Result<four_bar::V, four_bar::Status> {
    four_bar::velocity::<Own>(q, y_dot).map(|found| found.v)
}
"""


def test_it_needs_no_standard_library_and_types_do_not_mix(rustc: str, tmp_path: Path) -> None:
    found = model("four_bar").only(["velocity", "inverse_dynamics"])
    for file, text in print_rust(found).items():
        (tmp_path / file).write_text(text)
    rlib = [rustc, "--edition", "2018", "--crate-type", "rlib"]
    subprocess.run([*rlib, "--crate-name", "four_bar", "four_bar.rs"], cwd=tmp_path, check=True)

    def compiled(text: str) -> subprocess.CompletedProcess[str]:
        (tmp_path / "own.rs").write_text(text)
        command = [*rlib, "own.rs", "--extern", "four_bar=libfour_bar.rlib"]
        return subprocess.run(command, cwd=tmp_path, check=False, capture_output=True, text=True)

    assert compiled(OWN).returncode == 0
    mixed = compiled(OWN.replace("(q, y_dot)", "(y_dot, q)"))
    assert mixed.returncode != 0 and "E0308" in mixed.stderr


def test_names_that_rust_keeps_for_itself(rustc: str, tmp_path: Path) -> None:
    """Of functions, arrays and fields; and those of joints, whose letters are large ones."""
    found = model("four_bar").only(["velocity"])
    program = found.programs["velocity"]
    ports = [dataclasses.replace(p, name=n) for p, n in zip(program.inputs, ("move", "self_A"), strict=True)]
    made = [dataclasses.replace(p, name="status") for p in program.outputs]
    renamed = dataclasses.replace(program, name="match", inputs=tuple(ports), outputs=tuple(made))
    given = found.test_inputs["velocity"]
    found = dataclasses.replace(found, programs={"match": renamed})
    results = in_rust(rustc, found, tmp_path, {"match": given})
    expected, _ = found("match", *given)
    assert np.abs(results["match"][0][0] - expected[0]).max() < 1e-12
    assert RustNames(found).function("match") == "match_"


def test_rust_is_run_by_check_and_its_example_runs(rustc: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = model("four_bar").only(["inverse_dynamics", "velocity"])
    folder = tmp_path / "four_bar"
    generate(found, folder, ["rust"])
    (folder / "main.rs").write_text(example(folder, "Rust")[0])
    text = (folder / "README.md").read_text()
    for command in re.search(r"```sh\n(rustc.*?)```", text, re.DOTALL)[1].splitlines():  # type: ignore[index]
        subprocess.run(["bash", "-c", command], cwd=folder, check=True)
    done = subprocess.run([str(folder / "main")], capture_output=True, text=True, check=True)
    name, numbers = done.stdout.split(": ")
    function = next(iter(found.programs))
    expected = found(function, *(x[:1] for x in found.test_inputs[function]))[0][0].ravel()
    assert name == found.programs[function].outputs[0].name
    assert np.allclose([float(x) for x in numbers.strip("[]\n").split(",")], expected, rtol=1e-12)
    for made in ("main", "main.rs", "libfour_bar.rlib"):
        (folder / made).unlink()
    assert any("Rust agrees with the evaluator" in line for line in check(folder).lines)
    shifted = rust_target.MAIN.replace("value.to_le_bytes()", "(2.0 * value).to_le_bytes()")
    monkeypatch.setattr(rust_target, "MAIN", shifted)
    result = check(folder)
    assert not result.ok and any("Rust" in line for line in result.lines if ": FAILED: " in line)


def test_single_precision_is_of_f32_alone() -> None:
    found = model("four_bar").only(["velocity", "assemble", "forward_dynamics_reactions"])
    texts = {name: print_rust(found, p)["four_bar.rs"] for name, p in PRECISIONS.items()}
    assert (
        "f64" not in texts["single"] and "f32" not in texts["double"] and print_rust(found, DOUBLE) == print_rust(found)
    )
    for text in texts.values():
        code = re.sub(r"//.*", "", text)
        assert "unsafe" not in code.replace("forbid(unsafe_code)", "") and "alloc" not in code
        assert [line for line in code.splitlines() if "static " in line and "'static str" not in line] == []
