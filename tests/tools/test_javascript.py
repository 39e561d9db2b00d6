"""The JavaScript of models and of the page of `symscrew view`, run by Node."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.limb_platforms import platform
from support.model_states import model
from support.readme_examples import example, expected, printed, run

from symscrew import catalogue
from symscrew.display.view.page import make_page
from symscrew.export.javascript import print_javascript
from symscrew.generation import javascript_target
from symscrew.generation.folder import generate
from symscrew.model import derive
from symscrew.program import NO_ROTATION, NOT_ON_MECHANISM, OUT_OF_REACH
from symscrew.verification.regeneration import check

Array = np.ndarray


def node(tmp_path: Path, page: str | None, calls: list, **task: Any) -> list:
    program = shutil.which("node")
    if program is None:
        pytest.skip("needs node (Debian: nodejs)")
    (tmp_path / "task.json").write_text(json.dumps({"calls": calls, **task}))
    (tmp_path / "page.html").write_text(page or "")
    command = [program, str(Path(__file__).parents[1] / "support" / "view_check.cjs"), "page.html", "task.json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


LIKE_ANOTHER = ("stewart_6ups", "three_ups_upu_s", "panda")  # of limbs, or a chain, like one that is left


def numbers(values: Any) -> Array:
    return np.array([float(x) for x in np.ravel(np.array(values, dtype=object))])


@pytest.mark.parametrize("name", [name for name in catalogue.names() if name not in LIKE_ANOTHER])
def test_javascript_equals_the_evaluator(name: str, tmp_path: Path) -> None:
    found = model(name)
    ((file, text),) = print_javascript(found).items()
    (tmp_path / file).write_text(text)
    calls, expected = [], []
    for function in found.programs:
        inputs = found.test_inputs[function]
        results, status = found(function, *inputs)
        for k in range(len(status)):
            calls.append(["function", function, *(array[k].tolist() for array in inputs)])
            expected.append((function, [r[k] for r in results], int(status[k])))
    answers = node(tmp_path, None, calls, script=file, constant=name)
    for (function, results, status), answer in zip(expected, answers, strict=True):
        assert answer["status"] == status, function
        for port, result in zip(found.programs[function].outputs, results, strict=True):
            if status == 0:
                difference = np.abs(numbers(answer[port.name]) - result).max(initial=0.0)
                assert difference < 1e-12 * max(1.0, np.abs(result).max(initial=0.0)), (function, port.name)
            else:
                assert np.isnan(numbers(answer[port.name])).all()


def test_javascript_reports_failures_like_the_evaluator(tmp_path: Path) -> None:
    found = model("four_bar")
    ((file, text),) = print_javascript(found).items()
    (tmp_path / file).write_text(text)
    guess = found.system.reference
    cases = [("assemble", [[float(y)], guess.tolist()]) for y in (0.3, 2.5, 40.0)]
    cases += [("assemble", [["nan"], guess.tolist()]), ("velocity", [["inf", 0.0, 0.0], [1.0]])]
    answers = node(tmp_path, None, [["function", f, *given] for f, given in cases], script=file, constant="four_bar")
    for (function, given), answer in zip(cases, answers, strict=True):
        (result, *_), status = found(function, *[np.array([float(x) for x in array]) for array in given])
        assert answer["status"] == int(status)
        got = numbers(answer["q" if function == "assemble" else "v"])
        assert np.allclose(got, result, rtol=0, atol=1e-11, equal_nan=True)
    assert {a["status"] for a in answers} >= {0, 2}


@pytest.mark.parametrize("function", ["inverse_kinematics", "inverse_dynamics_platform", "assemble"])
def test_javascript_refuses_what_the_evaluator_refuses(function: str, tmp_path: Path) -> None:
    """Quaternions that are no rotations, poses off the mechanism and out of reach."""
    found = derive(platform("PRS"))
    ((file, text),) = print_javascript(found).items()
    (tmp_path / file).write_text(text)
    turned = next(i for i, port in enumerate(found.programs[function].inputs) if port.forms)
    cases = []
    for size, shift in ((1.0, 0.0), (1 + 4e-7, 0.0), (1 + 6e-7, 0.0), (0.0, 0.0), (1.0, 1e-3), (1.0, 50.0)):
        inputs = [np.array(x[1]) for x in found.test_inputs[function]]
        forms = found.programs[function].inputs[turned].forms
        inputs[turned][[k for k, form in enumerate(forms) if form]] *= size
        if function != "assemble":
            inputs[turned][:3] += shift
        cases.append(inputs)
    calls = [["function", function, *(x.tolist() for x in inputs)] for inputs in cases]
    answers = node(tmp_path, None, calls, script=file, constant=found.name)
    expected = [int(found(function, *inputs)[1]) for inputs in cases]
    assert [answer["status"] for answer in answers] == expected
    assert expected[:4] == [0, 0, NO_ROTATION, NO_ROTATION]
    assert function == "assemble" or (expected[4] == NOT_ON_MECHANISM and expected[5] >= OUT_OF_REACH)


def pairing(wrench: Array, twist: Array) -> float:
    return float(wrench[:3] @ twist[3:] + wrench[3:] @ twist[:3])


def test_reciprocal_and_principal_screws(tmp_path: Path) -> None:
    random = np.random.default_rng(3)
    page = make_page(model("four_bar"))
    systems = [random.normal(size=(n, 6)) for n in (1, 2, 3, 4, 5)]
    near = [0.3, -0.2, 0.5]
    calls: list = [["screws", "reciprocal", s.tolist(), 0.7] for s in systems]
    calls += [["screws", "principal", s.tolist(), near, 0.7] for s in systems[:3]]
    answers = node(tmp_path, page, calls)
    for system, found in zip(systems, answers[:5], strict=True):
        assert len(found) == 6 - len(system)
        assert np.linalg.matrix_rank(np.array(found)) == len(found)
        assert max(abs(pairing(np.array(w), twist)) for w in found for twist in system) < 1e-12
    for system, found in zip(systems[:3], answers[5:], strict=True):
        assert len(found) == len(system)
        lines = [_line(f) for f in found]
        assert np.linalg.matrix_rank(np.vstack([system, lines]), tol=1e-9) == len(system)
        for i, f in enumerate(found):
            assert abs(np.linalg.norm(f["direction"]) - 1) < 1e-12
            assert abs(np.dot(np.subtract(f["point"], near), f["direction"])) < 1e-9
            for g in found[:i]:
                assert abs(np.dot(f["direction"], g["direction"])) < 1e-9
        # Ball: the principal pitches are extreme over the system
        mixed = random.normal(size=(2000, len(system))) @ system
        pitch = (mixed[:, :3] * mixed[:, 3:]).sum(axis=1) / (mixed[:, :3] ** 2).sum(axis=1)
        pitches = [f["pitch"] for f in found]
        assert min(pitches) - 1e-9 <= pitch.min() and pitch.max() <= max(pitches) + 1e-9


def _line(found: dict) -> Array:
    direction, point = np.array(found["direction"]), np.array(found["point"])
    return np.concatenate([direction, np.cross(point, direction) + found["pitch"] * direction])


def test_couples_and_coincident_forces_are_told_apart(tmp_path: Path) -> None:
    centre = np.array([0.2, 0.1, -0.4])
    ball = [[*d, *np.cross(centre, d)] for d in np.eye(3)]  # three rotations about a point
    planar = [[0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0]]
    mixed = np.array([[1.0, 2, 3], [0, 1, 1], [2, 0, 1]])
    calls = [["screws", "principal", (mixed @ np.array(s)).tolist(), [1.0, 1.0, 1.0], 1.0] for s in (ball, planar)]
    spherical, flat = node(tmp_path, make_page(model("four_bar")), calls)
    assert [f["pitch"] for f in spherical] == [0, 0, 0]
    for f in spherical:  # every axis meets the centre
        assert np.linalg.norm(np.cross(np.subtract(f["point"], centre), f["direction"])) < 1e-9
    assert sorted(str(f["pitch"]) for f in flat) == ["0", "Infinity", "Infinity"]
    assert np.allclose(next(f for f in flat if f["pitch"] == 0)["direction"], [0, 0, 1], atol=1e-12)


@pytest.mark.parametrize(("name", "count"), [("three_ups_upu_s", 2), ("delta", 3), ("sarrus", 1), ("ur5", 6)])
def test_freedoms_of_the_platform_in_the_page(name: str, count: int, tmp_path: Path) -> None:
    found = model(name)
    q = found.test_inputs["body_poses"][0][2]
    (twists,) = node(tmp_path, make_page(found), [["model", "freedoms", q.tolist()]])
    (jacobian,), _ = found("platform_jacobian", q)
    (null,), _ = found("null_space", q)
    expected = jacobian.reshape(-1, 6).T @ null.reshape(-1, len(found.system.tree.v)).T
    assert np.linalg.matrix_rank(np.array(twists), tol=1e-9) == count
    assert np.linalg.matrix_rank(np.vstack([np.array(twists), expected.T]), tol=1e-7) == count


def test_sliders_and_sweeps_stay_on_the_closure(tmp_path: Path) -> None:
    found = model("three_ups_upu_s")
    (ranges,) = node(tmp_path, make_page(found), [["model", "reach"]])
    assert all(low < -0.3 and high > 0.3 for low, high in ranges)
    calls: list = [
        ["model", "sweep", -1, ranges],
        ["model", "sweep", 1, ranges],
        ["model", "assemble", [0.2, -0.1], found.system.reference.tolist()],
    ]
    both, one, q = node(tmp_path, make_page(found), calls)
    half = np.array([0.2, -0.1]) * np.sin(np.hypot(0.2, 0.1) / 2) / np.hypot(0.2, 0.1)
    start = found.programs["assemble"].independent  # type: ignore[union-attr]
    assert np.allclose(np.array(q)[list(start)], half, atol=1e-12)  # a rotation vector's components on the sliders
    for motion in (both, one):
        q, v, a, u = (np.array([numbers(f[name]) for f in motion["frames"]]) for name in "qvau")
        (residual,), status = found("closure", q)
        assert not status.any() and np.abs(residual).max() < 1e-12
        (jacobian,), _ = found("closure_jacobian", q)
        rows = jacobian.reshape(len(q), v.shape[1], -1)
        assert np.abs(np.einsum("nkr,nk->nr", rows, v)).max() < 1e-9
        h = motion["t"][1] - motion["t"][0]
        slope = (8 * (v[3:-1] - v[1:-3]) - (v[4:] - v[:-4])) / (12 * h)
        assert np.abs(slope - a[2:-2]).max() < 5e-3 * np.abs(a).max()
        (drives,), _ = found("inverse_dynamics", q, v, a)
        assert np.abs(drives - u).max() < 1e-9 * np.abs(drives).max()


def test_javascript_example_of_the_readme(tmp_path):
    directory = tmp_path / "four_bar"
    generate(model("four_bar"), directory, ["javascript"])
    if shutil.which("node") is None:
        pytest.fail("this test needs Node: apt-get install nodejs")
    (directory / "main.js").write_text(example(directory, "JavaScript")[0])
    output = run("node main.js", directory)
    assert output.startswith("0: ") and printed(output) == pytest.approx(expected(directory), rel=1e-11, abs=1e-11)


def test_javascript_is_run_by_check(tmp_path, monkeypatch):
    generate(model("four_bar"), tmp_path / "out", ["javascript"])
    assert any("JavaScript agrees with the evaluator" in line for line in check(tmp_path / "out").lines)
    doubled = javascript_target.NODE.replace("...given", "...given.map((x) => x.map((y) => 2 * y))")
    monkeypatch.setattr(javascript_target, "NODE", doubled)
    result = check(tmp_path / "out")
    assert not result.ok and any("JavaScript" in line for line in result.lines if ": FAILED: " in line)
