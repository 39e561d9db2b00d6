"""The transmission of ros2_control, compiled with a stub of its interface and driven by handles."""

from __future__ import annotations

import shutil
import subprocess
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from support.marks import slow
from support.model_states import model

from symscrew.export import DriveKinematics, OutputError, find_drive_kinematics, print_ros2
from symscrew.generation import generate
from symscrew.generation.drive_round_trip import tool_axes

STUB = Path(__file__).parents[1] / "support" / "ros2"
STRICT = ("-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror")


@pytest.fixture(scope="module")
def five_bar(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built("five_bar", tmp_path_factory.mktemp("five_bar"))


@cache
def kinematics(name: str) -> DriveKinematics:
    return find_drive_kinematics(model(name))


def built(name: str, folder: Path) -> Path:
    """The package's plugin in a program, every warning an error."""
    if shutil.which("g++") is None:
        pytest.skip("needs g++")
    for file, text in print_ros2(model(name), kinematics(name)).items():
        (folder / file).write_text(text)
    own = f"{model(name).name}_drives_host"
    c = ["cc", "-std=c99", "-O0", "-Wall", "-Wextra", "-Werror", "-c", f"{own}.c", "-o", "own.o"]
    subprocess.run(c, cwd=folder, check=True)
    sources = [f"{model(name).name}_transmission.cpp", str(STUB / "main.cpp"), "own.o"]
    subprocess.run(["g++", *STRICT, f"-I{STUB}", "-I.", *sources, "-o", "main", "-lm"], cwd=folder, check=True)
    return folder / "main"


def asked(program: Path, lines: list[tuple[str, np.ndarray]], *options: str) -> list[np.ndarray]:
    text = "\n".join(f"{side} {' '.join(repr(float(x)) for x in values.ravel())}" for side, values in lines)
    done = subprocess.run([str(program), *options], input=text, capture_output=True, text=True, check=True)
    return [np.array(line.split(), float).reshape(3, -1) for line in done.stdout.splitlines()]


def test_positions_rates_and_efforts_go_through(five_bar: Path) -> None:
    """Positions and rates against the evaluator; of efforts the work, along the axes as in the drives."""
    goes_through("five_bar", five_bar)


@pytest.mark.slow
def test_positions_rates_and_efforts_go_through_more_drives_than_freedoms(tmp_path: Path) -> None:
    goes_through("three_ups_upu_s", built("three_ups_upu_s", tmp_path))


def goes_through(name: str, program: Path) -> None:
    own = kinematics(name)
    found = own.model
    q = np.atleast_2d(found.system.sample_states[0])[1]
    rng = np.random.default_rng(4)
    y_dot = rng.uniform(-1, 1, len(own.chosen))
    (null,), _ = found("null_space", q[None])
    v = null[0].reshape(len(own.chosen), -1).T @ y_dot
    place = dict(own.scalar)
    rates = np.array([v[place[k]] for k in own.driven])
    effort = rng.uniform(-5, 5, len(own.drives))
    drives = np.array([q[list(own.driven)], rates, effort])
    (axes,) = asked(program, [("a", drives)])
    assert np.allclose(axes[0], tool_axes(own, q[None])[0][list(own.axes)], atol=1e-9)
    h = 1e-6
    ends = [
        found("assemble", (q[[own.driven[k] for k in own.chosen]] + s * h * y_dot)[None], q[None])[0][0]
        for s in (1, -1)
    ]
    slope = (tool_axes(own, ends[0])[0] - tool_axes(own, ends[1])[0])[list(own.axes)] / (2 * h)
    assert np.allclose(axes[1], slope, atol=1e-6)
    assert axes[1] @ axes[2] == pytest.approx(rates @ effort, rel=1e-9)
    there, back = asked(program, [("a", drives), ("j", axes)])
    assert np.allclose(there, axes) and np.allclose(back[:2], drives[:2], atol=1e-9)
    assert back[1] @ back[2] == pytest.approx(axes[1] @ axes[2], rel=1e-9)


@pytest.mark.parametrize("name", ["five_bar", slow("three_ups_upu_s")])
def test_kinematics_of_controllers(name: str, tmp_path: Path) -> None:
    """Transform and Jacobian against the evaluator, twists there and back, other links and far joints refused."""
    if shutil.which("g++") is None:
        pytest.skip("needs g++")
    own, q = kinematics(name), np.atleast_2d(kinematics(name).model.system.sample_states[0])[:3]
    for file, text in print_ros2(model(name), own).items():
        (tmp_path / file).write_text(text)
    c = ["cc", "-std=c99", "-O0", "-c", f"{own.model.name}_host.c", "-o", "own.o"]
    subprocess.run(c, cwd=tmp_path, check=True)
    sources = [f"{name}_kinematics_plugin.cpp", str(STUB / "main_kinematics.cpp"), "own.o"]
    subprocess.run(["g++", *STRICT, f"-I{STUB}", "-I.", *sources, "-o", "main", "-lm"], cwd=tmp_path, check=True)
    count, rng = len(own.drives), np.random.default_rng(6)
    platform = str(own.model.mechanism.platform)
    twists = rng.normal(size=(len(q), 6))
    joints = q[:, list(own.driven)]

    def asked(link: str, rows: np.ndarray) -> list[np.ndarray]:
        text = "\n".join(" ".join(map(repr, map(float, row))) for row in rows)
        command = [str(tmp_path / "main"), link, str(count)]
        done = subprocess.run(command, input=text, capture_output=True, text=True, check=True)
        return [np.array(line.split(), float) for line in done.stdout.splitlines()]

    *rows, difference = asked(platform, np.hstack([joints, twists]))
    assert np.allclose(difference, [4, 0, 0, 0, 0, 2 * 2 * np.arctan2(0.6, 0.8)])  # the shorter way round
    tool = np.array(own.tool)
    moves = own.values("platform_jacobian", q).reshape(len(q), -1, 6).swapaxes(1, 2)
    null = own.values("null_space", q).reshape(len(q), len(own.chosen), -1).swapaxes(1, 2)
    bodies = own.values("body_poses", q)[:, 12 * own.platform :][:, :12].reshape(-1, 4, 3)
    for k, row in enumerate(rows):
        done, frame, deltas, back, jacobian, sums = np.split(row, np.cumsum([1, 12, count, 6, 6 * count]))
        at = bodies[k, :3].T @ tool + bodies[k, 3]
        assert done == 1 and np.allclose(frame, [*bodies[k, :3].ravel(), *at], atol=1e-9)
        turned, moved = np.split(moves[k] @ null[k], 2)
        expected = np.zeros((6, count))
        expected[:, list(own.chosen)] = np.vstack([moved + np.cross(turned.T, at).T, turned])
        jacobian = jacobian.reshape(count, 6).T
        assert np.allclose(jacobian, expected, atol=1e-8)
        assert np.allclose(back, jacobian @ deltas, atol=1e-9)
        assert sums.sum() == pytest.approx(len(own.chosen))  # the trace of a projection
        off = jacobian[:, list(own.chosen)].T @ (
            np.repeat([1 / float(own.model.system.length) ** 2, 1.0], 3) * (back - twists[k])
        )
        assert np.abs(off).max() < 1e-8  # what is left of the twist is no motion of the machine's
    far = np.hstack([joints[:1] + 40.0, twists[:1]])
    assert asked(platform, far)[0][0] == 0 or name == "five_bar"  # whose cranks turn all round
    assert asked("nothing", np.hstack([joints[:1], twists[:1]]))[0][0] == 0


def test_what_fails_writes_nothing(five_bar: Path) -> None:
    own = kinematics("five_bar")
    good = np.array([np.array(own.model.system.reference)[list(own.driven)], [0.1, 0.2], [1.0, 2.0]])
    lost = good.copy()
    lost[0, 0] = np.nan
    first, second = asked(five_bar, [("a", good), ("a", lost)])
    assert np.array_equal(first, second)
    done = subprocess.run([str(five_bar), "few"], input="", capture_output=True, text=True, check=False)
    assert done.returncode == 3 and "expected 2 joints with the interface position, got 1" in done.stdout


def test_the_package_names_what_it_installs(tmp_path: Path) -> None:
    texts = print_ros2(model("five_bar"), kinematics("five_bar"))
    package = ElementTree.fromstring(texts["package.xml"])
    assert f"project({package.findtext('name')} " in texts["CMakeLists.txt"]
    for plugins, source in (("transmission", "transmission"), ("kinematics", "kinematics_plugin")):
        (plugin,) = ElementTree.fromstring(texts[f"{plugins}_plugins.xml"])
        exported = f"PLUGINLIB_EXPORT_CLASS({plugin.get('type')}, {plugin.get('base_class_type')})"
        assert exported in texts[f"five_bar_{source}.cpp"]
        assert (
            f"five_bar_{source}.cpp" in texts["CMakeLists.txt"] and f"{plugins}_plugins.xml" in texts["CMakeLists.txt"]
        )
    assert not [
        file
        for file, text in texts.items()
        if "@" in text and file != "package.xml" and not file.endswith((".c", ".h"))
    ]
    with pytest.raises(OutputError, match=r"targets c and ros2 both write CMakeLists\.txt"):
        generate(model("five_bar"), tmp_path / "both", ["c", "ros2"])
    assert not (tmp_path / "both").exists()
