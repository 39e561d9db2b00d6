"""Every format that is read, fuzzed: no traceback, no hang, nothing accepted that cannot be written back.

Mechanisms, scenes, problems, effects, folders of sweeps, manifests, URDF, MJCF, archives of arrays. `support.fuzzing`
says what a file has to stand; defects that it found are cases below, in every run.
"""

from __future__ import annotations

import io
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st
from support import handmade
from support.fuzzing import PROFILE, changed_bytes, changed_json, changed_text, fuzz
from support.model_states import pendulum

from symscrew import catalogue
from symscrew.array_archives import read_archive
from symscrew.description import parse_description, to_toml
from symscrew.display.view.motion_file import read_motion
from symscrew.effects.gravity import Gravity
from symscrew.effects.registry import load_effects
from symscrew.export import OutputError, effect_from_json, manifest, read_manifest
from symscrew.export.manifest_file import effect_to_json
from symscrew.formats import ImportOptions
from symscrew.formats.by_suffix import WRITERS, load_format
from symscrew.formats.mesh_inertias import bulk_of, read_triangles, shell_of
from symscrew.generation.folder import render
from symscrew.model import derive
from symscrew.optimisation.problem_file import parse_problem
from symscrew.runtime.origin import model_of, read_interface
from symscrew.scene import load_robot, save_robot
from symscrew.scene.scene_file import parse_scene
from symscrew.studies.workspace.plan import Axis, Plan
from symscrew.studies.workspace.store import Store

EXAMPLES = Path(__file__).parents[2] / "examples"
ARM = """
[mechanism]
name = "arm"
[parameters.k]
value = "0.3"
unit = "m"
[bodies.bob]
mass = "2*k"
com = [0, "k", 0]
inertia = ["k^2", "k^2", "k^2"]
[joints.hinge]
type = "R"
parent = "base"
child = "bob"
point = [0, 0, "k*sin(1)"]
axes = [[0, 1, 0]]
driven = true
[points.tip]
body = "bob"
at = [0, 0, "sqrt(2)*k"]
"""
MECHANISMS = [ARM, to_toml(catalogue.load("four_bar"))]
EFFECTS = """
[[effects]]
type = "gravity"
acceleration = [0, 0, "-9.81"]
[[effects]]
type = "viscous_friction"
joint = "A"
coefficient = "0.2"
[[effects]]
type = "joint_spring"
joint = "B"
stiffness = "3"
"""
SCENE = f"""
[scene]
name = "swinging"
mechanism = "four_bar"
duration = 0.5
rate = 20
[initial.coordinates]
A = 0.3
[initial.rates]
A = 3.0
[drives]
A = "2*sin(3*t)"
{EFFECTS}
[integrator]
method = "rk4"
step = 1e-3
"""


@PROFILE
def test_mechanisms(profile: str) -> None:
    def read(text: str) -> None:
        made = parse_description(text)
        again = to_toml(made)
        assert to_toml(parse_description(again)) == again

    found = fuzz(profile, changed_text(MECHANISMS), read, share=2)
    assert profile == "short" or min(found.values()) > 0


@PROFILE
def test_mechanisms_are_generated_and_found_again(profile: str, tmp_path: Path) -> None:
    """What is accepted can be derived, written, and proved to be what was written."""
    numbers = ("1", "2/3", "1e-100", "1e100", "1e-60", "1e60", "k", "k^2", "sqrt(2)*k", "0", "exp(-200)", "pi/7")

    def read(text: str) -> None:
        model = derive(parse_description(text), [Gravity()])
        files = render(model, ("c", "numpy"))
        (tmp_path / "mechanism.toml").write_bytes(files["mechanism.toml"])
        (tmp_path / "manifest.json").write_bytes(files["manifest.json"])
        assert render(model_of(tmp_path, read_manifest(tmp_path)), ("c", "numpy")) == files

    places = ARM.split('"')
    values = [k for k in range(1, len(places), 2) if any(c in places[k] for c in "k0123456789(")]
    files = st.dictionaries(st.sampled_from(values), st.sampled_from(numbers), max_size=4).map(
        lambda new: '"'.join(new.get(k, part) for k, part in enumerate(places))
    )
    fuzz(profile, files, read, share=5)


@PROFILE
def test_scenes(profile: str) -> None:
    found = fuzz(profile, changed_text([SCENE]), parse_scene)
    assert profile == "short" or found["refused"] > 0


@PROFILE
def test_problems(profile: str) -> None:
    texts = [(EXAMPLES / "optimisation" / "five_bar_pick_and_place.toml").read_text(encoding="utf-8")]
    found = fuzz(profile, changed_text(texts), lambda text: parse_problem(text, folder=EXAMPLES / "optimisation"))
    assert profile == "short" or found["refused"] > 0


@PROFILE
def test_effects(profile: str, tmp_path: Path) -> None:
    file = tmp_path / "effects.toml"

    def read(text: str) -> None:
        file.write_text(text, encoding="utf-8", errors="replace")
        for effect in load_effects(file):
            again = json.loads(json.dumps(effect_to_json(effect)))
            assert effect_to_json(effect_from_json(again)) == effect_to_json(effect)

    fuzz(profile, changed_text([EFFECTS]), read)


PLAN = Plan(catalogue.load("four_bar"), (Gravity(),), (Axis("A", -0.5, 0.5, 4),), chunk=4)
PIECE = {name: np.arange(4.0) for name in ("status", "reached", "regular", "allowed", "A")}


@PROFILE
def test_folders_of_sweeps(profile: str, tmp_path: Path) -> None:
    kept = Store(tmp_path / "whole", PLAN)
    kept.put(0, PIECE)
    (piece,) = kept.done().values()
    contents = {path.name: path.read_bytes() for path in (tmp_path / "whole").iterdir()}

    def read(given: tuple[str, bytes, bytes]) -> None:
        from symscrew.studies.workspace.store import _digest

        name, head, body = given
        for path in (tmp_path / "whole").iterdir():
            path.rmdir() if path.is_dir() else path.unlink()
        (tmp_path / "whole" / "manifest.json").write_bytes(head)
        part = tmp_path / "part"
        part.write_bytes(body)
        part.rename(tmp_path / "whole" / name.format(_digest(part)))  # who can write a piece can write its digest
        assert {n: a.tolist() for n, a in Store(tmp_path / "whole", PLAN).whole().items()}.keys() >= PIECE.keys() - {
            "A"
        }

    names = st.sampled_from(("piece_0000000_{}.npz", "piece_0000000_{}.npz", "piece_1_{}.npz", "piece_{}_a.npz"))
    heads = changed_bytes([contents["manifest.json"]], 1)
    found = fuzz(profile, st.tuples(names, heads, changed_bytes([contents[piece.name]], 2)), read)
    assert profile == "short" or found["refused"] > 0


@PROFILE
def test_manifests(profile: str, tmp_path: Path) -> None:
    whole = json.loads(json.dumps(manifest(handmade.model(), targets=["c"], files=["handmade.c", "manifest.json"])))

    def read(content: Any) -> None:
        (tmp_path / "manifest.json").write_text(json.dumps(content), encoding="utf-8", errors="replace")
        found = read_manifest(tmp_path)
        name, ports, _ = read_interface(tmp_path, found)
        assert name.isidentifier() and all(
            port.size == len(port.units) for p in ports.values() for port in (*p[0], *p[1])
        )
        for entry in found["effects"]:
            effect_from_json(entry)

    found = fuzz(profile, changed_json(whole), read)
    assert profile == "short" or min(found.values()) > 0


@PROFILE
def test_manifests_of_broken_bytes(profile: str, tmp_path: Path) -> None:
    whole = json.dumps(manifest(handmade.model(), targets=["c"], files=["manifest.json"])).encode()

    def read(content: bytes) -> None:
        (tmp_path / "manifest.json").write_bytes(content)
        read_interface(tmp_path, read_manifest(tmp_path))

    fuzz(profile, changed_bytes([whole]) | st.sampled_from((1, 1000, 200_000)).map(lambda n: b"[" * n), read, share=3)


@PROFILE
@pytest.mark.parametrize("suffix", [".urdf", ".xml"])
def test_robot_files(profile: str, suffix: str, tmp_path: Path) -> None:
    wholes = [WRITERS[suffix](pendulum().mechanism)]
    wholes += [WRITERS[suffix](catalogue.load("four_bar"))] if suffix == ".xml" else []
    file = tmp_path / f"robot{suffix}"

    def read(text: str) -> None:
        file.write_text(text, encoding="utf-8", errors="replace")
        made = load_format(file)
        again = to_toml(made)
        assert to_toml(parse_description(again)) == again

    found = fuzz(profile, changed_text(wholes), read)
    assert profile == "short" or found["refused"] > 0


HAND = """<mujoco><compiler angle="radian"/><default><tendon stiffness="3"/><mesh scale="0.1 0.1 0.1"/></default>
<asset><mesh name="m" vertex="0 0 0 1 0 0 0 1 0 0 0 1" face="0 2 1 0 1 3 0 3 2 1 2 3" inertia="exact"/></asset>
<worldbody><body name="a" gravcomp="0.5"><joint name="n" armature="0.1" damping="2"/><geom type="mesh" mesh="m"/>
<body name="b" quat="0.9239 0 0 0.3827"><joint name="f" axis="0 1 0"/><geom size="0.1"/><site name="s"/></body></body>
</worldbody><tendon><fixed name="cord"><joint joint="n" coef="0.5"/><joint joint="f" coef="-1.25"/></fixed></tendon>
<equality><joint joint1="n" joint2="f" polycoef="0.1 1 0 0 0"/></equality>
<actuator><position tendon="cord" kp="40" dampratio="0.7"/><motor site="s" gear="0 0 1 0 0 0"/></actuator></mujoco>"""
LEG = """<robot name="r"><link name="base"/><link name="a"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="b"/><link name="c"/>
<joint name="A" type="revolute"><parent link="base"/><child link="a"/><origin rpy="1.5708 0 0" xyz="0 0 1"/>
<dynamics damping="0.1"/><limit lower="-1" upper="1" effort="3" velocity="2"/></joint>
<joint name="B" type="continuous"><parent link="a"/><child link="b"/><mimic joint="A" multiplier="2"/></joint>
<joint name="C" type="fixed"><parent link="b"/><child link="c"/></joint>
<transmission name="t"><joint name="A"/><actuator name="m"><rotorInertia>1e-5</rotorInertia></actuator></transmission>
<loop name="l" type="spherical"><predecessor link="c"><origin xyz="0 0 0"/></predecessor><successor link="a"/></loop>
</robot>"""


@PROFILE
@pytest.mark.parametrize(("suffix", "whole"), [(".xml", HAND), (".urdf", LEG)])
def test_robot_files_with_all_they_have(profile: str, suffix: str, whole: str, tmp_path: Path) -> None:
    """Forces, tendons, meshes, couplings, loops, digits as angles: read, and written with what acts on them."""
    file = tmp_path / f"robot{suffix}"

    def read(text: str) -> None:
        file.write_text(text, encoding="utf-8", errors="replace")
        robot = load_robot(file, ImportOptions(exact=True, repair=True, accept=True))
        assert to_toml(parse_description(to_toml(robot.mechanism))) == to_toml(robot.mechanism)
        save_robot(robot.mechanism, tmp_path / f"again{suffix}", robot.effects, limits=robot.limits, accept=True)

    read(whole) if suffix == ".xml" else None  # a loop has no place in a URDF that is written
    found = fuzz(profile, changed_text([whole]), read, share=8)
    assert profile == "short" or found["refused"] > 0


@PROFILE
@pytest.mark.parametrize("suffix", [".stl", ".obj"])
def test_meshes(profile: str, suffix: str, tmp_path: Path) -> None:
    """Binary and written triangles: a mass that is finite and positive, or one clear error."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
    faces = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
    binary = bytes(80) + struct.pack("<I", 4)
    binary += b"".join(struct.pack("<12fH", 0, 0, 0, *corners[list(face)].ravel(), 0) for face in faces)
    written = "solid x\n" + "".join(f"vertex {x} {y} {z}\n" for face in faces for x, y, z in corners[list(face)])
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {a + 1} {b + 1}/1 {c + 1}" for a, b, c in faces]
    wholes = {".stl": [binary, written.encode()], ".obj": ["\n".join(lines).encode()]}[suffix]
    file = tmp_path / f"mesh{suffix}"

    def read(content: bytes) -> None:
        file.write_bytes(content)
        triangles = read_triangles(file)
        for made in (bulk_of(triangles, "mesh"), bulk_of(triangles, "mesh", legacy=True), shell_of(triangles, "mesh")):
            assert made.volume > 0 and all(abs(c) < 1e300 for c in made.centre)

    found = fuzz(profile, changed_bytes(wholes), read, share=3)
    assert profile == "short" or min(found["refused"], found["accepted"]) > 0


@PROFILE
def test_lists_beside_a_urdf(profile: str, tmp_path: Path) -> None:
    file = tmp_path / "robot.urdf"
    file.write_text(LEG)
    whole = "closed_loop: [['C', 'A']] # one\ntype: ['3d']\nname_mot: [ 'A' ]\n"
    whole += "joint_name: ['B']\njoint_type: ['SPHERICAL']"

    def read(text: str) -> None:
        file.with_suffix(".yaml").write_text(text, encoding="utf-8", errors="replace")
        load_format(file)

    found = fuzz(profile, changed_text([whole]), read, share=3)
    assert profile == "short" or found["refused"] > 0


def motion() -> bytes:
    file, four_bar = io.BytesIO(), catalogue.load("four_bar")
    arrays = {
        "t": np.arange(3.0),
        "q": np.zeros((3, 3)),
        "v": np.zeros((3, 3)),
        "mechanism": np.array(to_toml(four_bar)),
    }
    np.savez(file, **arrays, q_labels=np.array(["A", "B", "D"]))
    return file.getvalue()


@PROFILE
def test_archives(profile: str, tmp_path: Path) -> None:
    file = tmp_path / "run.npz"
    whole = motion()

    def read(content: bytes) -> None:
        file.write_bytes(content)
        for array in read_archive(file).values():
            assert array.dtype.kind in "biufU" and array.nbytes < 1_000_000
        found = read_motion(file)
        assert np.isfinite(found.t).all() and found.q.shape[0] == len(found.t)

    found = fuzz(profile, changed_bytes([whole]), read)
    assert profile == "short" or found["refused"] > 0


@PROFILE
def test_archives_whose_headers_lie(profile: str, tmp_path: Path) -> None:
    """Whole archives with headers of any shape and type, which checksums cannot show."""
    import zipfile

    file = tmp_path / "run.npz"
    shapes = st.sampled_from(
        ("()", "(3,)", "(3, 3)", f"({2**45},)", "(-1,)", "(0,)", "(3.5,)", "None", f"({2**62}, 4)")
    )
    kinds = st.sampled_from(
        ("<f8", "<c16", "|O", "<U4", "<i8", "|b1", "<M8[s]", "|S3", "<f2", ">f8", "|V8", "x", "<U0")
    )
    orders = st.sampled_from(("True", "False", "3"))
    member = st.tuples(kinds, orders, shapes, st.binary(max_size=80), st.sampled_from((b"\x01\x00", b"\x02\x00")))

    def read(members: list[tuple[str, str, str, bytes, bytes]]) -> None:
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as made:
            for name, (kind, order, shape, content, version) in zip(("t", "q", "v", "q_labels"), members, strict=False):
                text = f"{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}".encode()
                size = len(text).to_bytes(version[0] * 2, "little")
                made.writestr(f"{name}.npy", b"\x93NUMPY" + version + size + text + content)
            made.writestr("mechanism.npy", b"\x93NUMPY\x01\x00")
        read_motion(file)

    found = fuzz(profile, st.lists(member, min_size=1, max_size=4), read)
    assert found["accepted"] == 0


def test_the_harness_finds_what_it_looks_for() -> None:
    """A reader with a traceback, one that hangs, one that accepts what it cannot write, one with an endless error."""
    import time

    def broken(text: str) -> None:
        raise KeyError(text)

    def endless(text: str) -> None:
        raise OutputError(text * 5000)

    def lossy(text: str) -> None:
        assert not text

    for reader, error in ((broken, KeyError), (endless, AssertionError), (lossy, AssertionError)):
        with pytest.raises(error):
            fuzz("short", st.just("ab"), reader)
    from support import fuzzing

    for wait in (0.0, 1.0):
        with pytest.MonkeyPatch.context() as changed, pytest.raises(fuzzing.HangError):
            changed.setattr(fuzzing, "SECONDS", 0.02)
            changed.setattr(fuzzing, "TIMES", 5)
            fuzz("short", st.just(wait), lambda wait: [time.sleep(wait) for _ in iter(int, 1)])
