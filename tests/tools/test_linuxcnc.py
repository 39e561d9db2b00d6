"""Kinematics between drives and a tool, and LinuxCNC's modules around it: ways of poses, refusals, units, pins."""

from __future__ import annotations

import dataclasses
import json
import os
import shutil
import subprocess
import tempfile
from functools import cache
from itertools import takewhile
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from support.drive_ways import AMPLITUDES, HEADERS, HERE, STUB, built, followed, home
from support.marks import slow
from support.model_states import model

from symscrew.errors import DescriptionError
from symscrew.export import DriveKinematics, find_drive_kinematics, print_linuxcnc
from symscrew.generation.drive_round_trip import Follower, compiled
from symscrew.model import derive

MODULES = Path("/usr/lib/linuxcnc/modules")
POSES = 600  # three ways, in steps of a two-hundredth of their length


@cache
def kinematics(name: str) -> DriveKinematics:
    return find_drive_kinematics(model(name))


@pytest.fixture(scope="module")
def follower(tmp_path_factory: pytest.TempPathFactory):
    made: dict[str, Follower] = {}

    def of(name: str) -> Follower:
        if name not in made:
            made[name] = compiled(kinematics(name), tmp_path_factory.mktemp(name))
        return made[name]

    return of


def reference(name: str) -> np.ndarray:
    return np.array(kinematics(name).model.system.reference)


@pytest.mark.parametrize(
    ("name", "headers"),
    [
        ("five_bar", STUB),
        slow("five_bar", HEADERS),
        ("three_ups_upu_s", STUB),
    ],
)
def test_there_and_back_on_ways_of_poses(name: str, headers: Path, tmp_path: Path) -> None:
    if not headers.is_dir():
        pytest.skip("needs LinuxCNC's headers (Debian: linuxcnc-uspace-dev)")
    own = kinematics(name)
    way = followed(built(model(name), own, tmp_path, headers, level="-O0"), own, POSES, AMPLITUDES[name])
    assert way.refused == way.wrong == 0 and way.error < 1e-8  # mm or degrees; a micrometre is 1e-3
    assert way.pins[f"{name}kins.status"] == 0 and abs(way.pins[f"{name}kins.mode"]) == 1
    assert way.pins[f"{name}kins.margin"] > 0 and way.forward_steps < 1.5


@pytest.mark.parametrize(("name", "letters"), [("five_bar", "XZ"), ("three_ups_upu_s", "AB"), ("delta", "XYZ")])
def test_axes_are_those_that_move(name: str, letters: str) -> None:
    found = kinematics(name)
    assert "".join("XYZABC"[k] for k in found.axes) == letters
    assert bool(found.pose.entries) == (name == "delta")


@pytest.mark.parametrize("name", ["five_bar", "three_ups_upu_s", "delta"])
def test_tool_is_where_the_rotation_says(name: str, follower) -> None:
    """X ... C and a tool frame against an independent rotation from the same angles."""
    own = kinematics(name)
    offset = np.array([0.03, -0.02, 0.05])
    q = np.atleast_2d(own.model.system.sample_states[0])[1]
    (found,), _ = own.model("body_poses", q[None])
    body = found[0, 12 * own.platform :][:12].reshape(4, 3)
    joints = q[list(own.driven)]
    now = reference(name)
    status, world = follower(name).forward(now, joints, offset)
    assert status == 0 and np.allclose(now, q, atol=1e-9)
    turned = Rotation.from_euler("xyz", world[3:]).as_matrix()
    assert np.allclose(turned, body[:3].T, atol=1e-12)
    assert np.allclose(world[:3], turned @ (np.array(own.tool) + offset) + body[3], atol=1e-12)
    status, back = follower(name).inverse(now, world, offset)
    assert status == 0 and np.allclose(back, joints, atol=1e-10)


@pytest.mark.parametrize("name", ["five_bar", "three_ups_upu_s"])
def test_jacobian_is_the_slope_of_forward(name: str, follower) -> None:
    own = kinematics(name)
    q = np.atleast_2d(own.model.system.sample_states[0])[2]
    status, jacobian, margin = follower(name).jacobian(q)
    assert status == 0 and margin > 0
    h = 1e-5
    for j in range(len(own.chosen)):
        ends = []
        for sign in (1, -1):
            (null,), _ = own.model("null_space", q[None])
            start, (moved,) = q.copy(), own.model("assemble", *_y(own, q, j, sign * h))[0]
            joints = moved[0][list(own.driven)]
            done, world = follower(name).forward(start, joints)
            assert done == 0 and null.size
            ends.append(world)
        assert np.allclose((ends[0] - ends[1]) / (2 * h), jacobian[:, j], atol=1e-7)


def _y(own: DriveKinematics, q: np.ndarray, j: int, step: float) -> tuple[np.ndarray, np.ndarray]:
    y = q[[own.driven[k] for k in own.chosen]].copy()
    y[j] += step
    return y[None], q[None]


def test_what_no_small_steps_lead_to_is_refused(follower) -> None:
    """Joints beyond where the loops close, others that do not agree, poses out of reach, what is not finite."""
    delta = reference("delta")
    for joints in ([-1.4, 1.4, 1.4], [3.0, 0.0, 0.0]):
        status, _ = follower("delta").forward(delta, joints)
        assert status == 101 and np.array_equal(delta, reference("delta"))
    five = reference("five_bar")
    assert follower("five_bar").forward(five, [np.nan, 0.0])[0] == 2
    status, _ = follower("five_bar").inverse(five, [0.0, 0.0, 9.0, 0.0, 0.0, 0.0])
    assert status > 0 and np.array_equal(five, reference("five_bar"))
    assert follower("five_bar").inverse(five, [np.inf] * 6)[0] == 2
    seed = reference("three_ups_upu_s")
    joints = seed[list(kinematics("three_ups_upu_s").driven)]
    assert follower("three_ups_upu_s").forward(seed, joints)[0] == 0
    assert follower("three_ups_upu_s").forward(seed, joints + np.array([0, 0, 1e-4, 0]))[0] == 102


def test_poses_beyond_a_singularity_are_refused(follower) -> None:
    """The hexapod turned past where its legs leave a freedom: the way back is a closed form there, of another mode."""
    own = kinematics("stewart_6ups")
    q = reference("stewart_6ups")
    turned = [np.array([*own.tool, 0.0, 0.0, angle]) for angle in np.linspace(-2.4, 2.4, 13)]
    found = [follower("stewart_6ups").inverse(q.copy(), world)[0] for world in turned]
    middle = len(found) // 2
    assert found[middle] == 0 and found[0] == found[-1] == 104
    moved = np.array([0.02, -0.03, 0.01, 0.1, -0.15, 0.2])
    pose = np.append(own.tool, np.zeros(3)) + moved
    status, joints = follower("stewart_6ups").inverse(q.copy(), pose)
    there, world = follower("stewart_6ups").forward(q.copy(), joints)
    assert status == there == 0 and np.allclose(world, pose, atol=1e-9)  # with all six axes there and back
    signs = [status == 0 for status in found]
    assert signs == sorted(signs[: middle + 1]) + sorted(signs[middle + 1 :], reverse=True)


def test_a_mode_is_kept_where_another_is_as_near(follower) -> None:
    """The five-bar with its tool below the bases: joints of one mode have another configuration, which is not taken."""
    own = kinematics("five_bar")
    q = reference("five_bar")
    other = q.copy()
    (null,), _ = own.model("null_space", q[None])
    assert null.size
    mirrored = [k for k in range(len(q)) if k not in own.driven]
    rng = np.random.default_rng(1)
    found = None
    for _ in range(200):  # another assembly of the same joints, found from random guesses
        guess = other.copy()
        guess[mirrored] += rng.uniform(-np.pi, np.pi, len(mirrored))
        (q2,), status = own.model("assemble", q[list(own.driven)][None], guess[None])
        if status[0] == 0 and np.abs(np.sin((q2[0] - q) / 2)).max() > 0.1:
            found = q2[0]
            break
    assert found is not None
    joints = q[list(own.driven)] + 1e-3
    modes = {}
    for name, start in (("one", q.copy()), ("other", found.copy())):
        first = start.copy()
        status, world = follower("five_bar").forward(start, joints)
        assert status == 0 and np.abs(start - first).max() < 0.02
        modes[name] = (follower("five_bar").mode(start), world)
    assert modes["one"][0] == -modes["other"][0] and np.abs(modes["one"][1] - modes["other"][1]).max() > 0.1


def test_what_has_no_such_kinematics_says_so() -> None:
    with pytest.raises(DescriptionError, match="ur5: expected a mechanism with loops"):
        find_drive_kinematics(model("ur5"))
    found = model("five_bar")
    joints = {
        n: dataclasses.replace(j, driven=() if n == "base_right" else j.driven)
        for n, j in found.mechanism.joints.items()
    }

    with pytest.raises(DescriptionError, match="expected a platform"):
        find_drive_kinematics(dataclasses.replace(found, mechanism=dataclasses.replace(found.mechanism, platform=None)))
    lazy = derive(dataclasses.replace(found.mechanism, joints=joints))
    with pytest.raises(DescriptionError, match="1 of 2 freedoms; drive more joints"):
        find_drive_kinematics(lazy)


@pytest.mark.parametrize("name", ["five_bar", slow("three_ups_upu_s")])
def test_jacobian_and_frame_that_newer_sources_ask_for(name: str, tmp_path: Path) -> None:
    """Rates of joints by axes in machine units beside differences of the inverse; the tool's axis beside A, B, C."""
    own = kinematics(name)
    program = built(model(name), own, tmp_path, STUB, level="-O0")
    axes = [text for letter, size in AMPLITUDES[name].items() for text in (str("XYZABC".index(letter)), str(size))]
    command = [str(program), "137", str(len(own.drives)), *home(own), *axes]
    done = subprocess.run(command, capture_output=True, text=True, check=True, env={"SLOPES": "1"})
    first, second = (np.array(line.split(), float) for line in done.stdout.splitlines())
    assert first[0] < 1e-6 * max(1.0, first[1]) and first[1] > 0.1
    assert np.allclose(first[2:], Rotation.from_euler("xyz", second, degrees=True).as_matrix()[:, 2], atol=1e-9)


def test_halcompile_takes_it(tmp_path: Path) -> None:
    name = "five_bar"
    if shutil.which("halcompile") is None:
        pytest.skip("needs halcompile (Debian: linuxcnc-uspace-dev)")
    for file, text in print_linuxcnc(model(name), kinematics(name)).items():
        (tmp_path / file).write_text(text)
    done = subprocess.run(
        ["halcompile", "--compile", f"{name}kins.c"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0 and "warning" not in done.stderr, done.stderr
    symbols = subprocess.run(["nm", "-D", f"{name}kins.so"], cwd=tmp_path, capture_output=True, text=True, check=True)
    for symbol in (
        "kinematicsForward",
        "kinematicsInverse",
        "kinematicsType",
        "kinematicsSwitch",
        "kinematicsJacobian",
        "kinematicsToolFrame",
        "kinematicsWorkFrame",
        "rtapi_app_main",
    ):
        assert f" T {symbol}\n" in symbols.stdout


@pytest.mark.slow
def test_the_simulator_of_linuxcnc_moves_the_machine(tmp_path: Path) -> None:
    """The whole of LinuxCNC without a screen: homing, moves by G-code there and back, one out of reach refused."""
    missing = [tool for tool in ("linuxcnc", "halcompile", "halcmd") if shutil.which(tool) is None]
    if missing or os.geteuid() != 0 or not MODULES.is_dir():
        pytest.skip("needs LinuxCNC (Debian: linuxcnc-uspace-dev), and to install a module as root")
    for file, text in print_linuxcnc(model("five_bar"), kinematics("five_bar")).items():
        (tmp_path / file).write_text(text)
    shutil.copytree(HERE / "simulator", tmp_path, dirs_exist_ok=True)
    (tmp_path / "drive.py").chmod(0o755)
    (tmp_path / "sim.tbl").touch()
    before = MODULES / "five_barkins.so"
    kept = before.read_bytes() if before.is_file() else None
    try:
        subprocess.run(["halcompile", "--install", "five_barkins.c"], cwd=tmp_path, capture_output=True, check=True)
        own = {"RTAPI_UID": "65534", "RTAPI_FIFO_PATH": str(tmp_path / "fifo"), "HOME": str(tmp_path)}
        environment = {**os.environ, **own}  # a process of root needs somebody to be
        tmp_path.chmod(0o777)
        for folder in takewhile(lambda folder: folder != Path(tempfile.gettempdir()), tmp_path.parents):
            folder.chmod(0o755)
        done = subprocess.run(
            ["linuxcnc", "-r", "five_bar.ini"], cwd=tmp_path, env=environment, capture_output=True, text=True,
            timeout=120, check=False,
        )  # fmt: skip
        assert (tmp_path / "found.json").is_file(), done.stdout[-2000:]
    except subprocess.TimeoutExpired:  # only the script is ended then, not what it started
        subprocess.run(["halrun", "-U"], cwd=tmp_path, env=environment, capture_output=True, timeout=30, check=False)
        raise
    finally:
        before.unlink(missing_ok=True)
        if kept is not None:
            before.write_bytes(kept)
    found = json.loads((tmp_path / "found.json").read_text())
    assert found["homed"] == [1, 1] and np.allclose(found["home"], [0, 0, 600])
    *moves, far = found["moves"]
    own_kinematics = compiled(kinematics("five_bar"), tmp_path)
    for move in moves:
        assert move["said"] == [] and np.abs(np.array(move["place"])[[0, 2]] - move["wanted"]).max() < 1e-8
        world = np.array([*move["place"], 0, 0, 0]) / 1000
        status, joints = own_kinematics.inverse(reference("five_bar"), world)
        assert status == 0 and np.allclose(np.degrees(joints), move["joints"], atol=1e-6)
    assert any("fails kinematicsInverse" in text for text in far["said"])
    assert np.allclose(far["place"], found["home"], atol=1e-8) and found["pins"]["refused"] == "0x00000000"
