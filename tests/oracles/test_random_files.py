"""MJCF files made at random of all that bodies have: mass matrix and forces are those of MuJoCo.

Several joints of a body, classes, frames, orientations in every form, geoms and inertials with settings of its
compiler, bodies that carry their weight, a polynomial of two joints: what each does is tested elsewhere, here that
they do not disturb each other.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from itertools import count
from pathlib import Path

import pytest
from benchmarks.robot_engines import Ours, with_mujoco

from symscrew.formats import ImportOptions
from symscrew.functions.forward import MASSLESS_NOTE
from symscrew.model import derive
from symscrew.scene import load_robot

CLASSES = (
    '<default><joint damping="0.1"/><geom density="700"/><default class="turned"><joint armature="0.05" axis="0 1 0"/>'
    '<geom density="300"/><default class="inner"><joint type="slide" axis="1 0 0" ref="0.1"/></default></default>'
    '<default class="rod"><geom type="capsule" size="0.05 0.2" pos="0.1 0 0"/></default></default>'
)
COMPILERS = (
    "", 'inertiafromgeom="true"', 'boundmass="0.9"', 'boundinertia="0.04"', 'inertiafromgeom="true" boundmass="2"',
    'inertiagrouprange="1 2"',
)  # fmt: skip


def numbers(chance: random.Random, count_of: int, size: float = 1.0) -> str:
    return " ".join(f"{chance.uniform(-size, size):.3f}" for _ in range(count_of))


def orientation(chance: random.Random, turn: float) -> str:
    return chance.choice(
        (
            "", f'quat="{numbers(chance, 4)}"', f'euler="{numbers(chance, 3, turn)}"', f'xyaxes="{numbers(chance, 6)}"',
            f'zaxis="{numbers(chance, 3)}"', f'axisangle="{numbers(chance, 3)} {numbers(chance, 1, turn)}"',
        )
    )  # fmt: skip


def joints(chance: random.Random, turn: float, names: Iterator[int]) -> str:
    made = ""
    for _ in range(chance.choice((1, 1, 2, 3))):
        kind = chance.choice(("hinge", "hinge", "slide"))
        more = 'class="inner"' if chance.random() < 0.2 else f'type="{kind}" axis="{numbers(chance, 3)}"'
        more += f' pos="{numbers(chance, 3, 0.2)}"' if chance.random() < 0.5 else ""
        more += f' ref="{numbers(chance, 1, turn if kind == "hinge" else 0.3)}"' if chance.random() < 0.4 else ""
        made += f'<joint name="j{next(names)}" {more}/>'
    return made


def weights(chance: random.Random, turn: float) -> str:
    place = numbers(chance, 3, 0.2)
    geoms = (
        f'<geom type="box" size="0.1 0.2 0.15" pos="{place}" {orientation(chance, turn)} density="400"/>',
        '<geom class="rod" group="2"/>', f'<geom size="0.1" pos="{place}" mass="{chance.choice((0, 0.8))}"/>',
    )  # fmt: skip
    inertial = f'<inertial pos="{place}" {orientation(chance, turn)} mass="1.3" diaginertia="0.03 0.04 0.05"/>'
    return chance.choice((inertial, inertial + chance.choice(geoms), "".join(geoms), inertial + geoms[2]))


def body(chance: random.Random, turn: float, names: Iterator[int], depth: int = 0) -> str:
    inner = joints(chance, turn, names) if depth == 0 or chance.random() < 0.8 else ""
    inner += weights(chance, turn)
    children = "".join(
        body(chance, turn, names, depth + 1) for _ in range(chance.choice((1, 1, 2)) if depth < 1 else 0)
    )
    frame = f'<frame pos="{numbers(chance, 3, 0.3)}" {orientation(chance, turn)} childclass="turned">{children}</frame>'
    more = chance.choice(("", 'childclass="turned"', 'gravcomp="0.4"'))
    place = f'pos="{numbers(chance, 3, 0.5)}" {orientation(chance, turn)}'
    return f"<body {place} {more}>{inner}{frame if chance.random() < 0.3 else children}</body>"


def model(seed: int) -> str:
    chance, names = random.Random(seed), count()
    degrees = chance.random() < 0.5
    angle = f'angle="{"degree" if degrees else "radian"}" eulerseq="{chance.choice(("xyz", "ZYX", "zXz"))}"'
    world = body(chance, 60.0 if degrees else 1.0, names)
    ends = chance.sample(range(next(names)), 2)
    tie = f'<joint joint1="j{ends[0]}" joint2="j{ends[1]}" polycoef="0.05 {numbers(chance, 4, 0.4)}"/>'
    tied = tie if chance.random() < 0.3 else ""
    return (
        f"<mujoco><compiler {angle} {chance.choice(COMPILERS)}/>{CLASSES}<worldbody>{world}</worldbody>"
        f"<equality>{tied}</equality></mujoco>"
    )


@pytest.mark.parametrize("seed", range(6))
def test_random_files_are_those_of_mujoco(tmp_path: Path, seed: int) -> None:
    path = tmp_path / "model.xml"
    path.write_text(model(seed))
    worst, what = with_mujoco(path, ImportOptions())
    assert worst < 1e-9, what


FREE = '<body name="a"><freejoint/><inertial pos="0.1 0 0" mass="1" diaginertia="0.1 0.2 0.2"/>{0}</body>'
ARM = (
    '<body name="b" pos="0.3 0 0"><joint type="ball" armature="0.2"/>'
    '<inertial pos="0.1 0 0" mass="1" diaginertia="0.1 0.2 0.2"/></body>'
)


@pytest.mark.parametrize(("inner", "tied", "freedoms"), [("", "a", 3), (ARM, "b", 6)])
def test_a_body_that_floats_is_tied_to_the_world(tmp_path: Path, inner: str, tied: str, freedoms: int) -> None:
    """No loop is cut at a free joint, whichever way to the body is shorter or has rotors."""
    path = tmp_path / "model.xml"
    tie = f'<equality><connect body1="{tied}" anchor="0.2 0 0"/></equality>'
    path.write_text(f"<mujoco><worldbody>{FREE.format(inner)}</worldbody>{tie}</mujoco>")
    worst, what = with_mujoco(path, ImportOptions())
    assert worst < 1e-9 and f"{freedoms} freedoms" in what


def test_balls_that_the_tree_comes_to_from_their_child_are_compared(tmp_path: Path) -> None:
    """Where the balls of a leg have rotors, none is cut: it hangs on the platform, at which the tree begins."""
    inertial, legs, ties = '<inertial pos="0.1 0 0.2" mass="1" diaginertia="0.1 0.2 0.2"/>', "", ""
    for k in range(3):
        ball = f'<joint name="s{k}" type="ball" armature="0.1"/>{inertial}'
        top = f'<body name="top" pos="0 0 1">{ball.replace("s0", "t")}</body>' if k == 0 else ""
        hip = f'<body pos="{k} {k * k / 2} 0"><joint axis="{k - 1} 1 0.2"/>{inertial}'
        legs += f'{hip}<body name="rod{k}" pos="0 0.3 0">{ball}{top}</body></body>'
        ties += f'<connect body1="top" body2="rod{k}" anchor="{k} {k / 3} 0"/>' if k else ""
    path = tmp_path / "model.xml"
    path.write_text(f"<mujoco><worldbody>{legs}</worldbody><equality>{ties}</equality></mujoco>")
    options = ImportOptions()
    assert Ours(path, options).turned_round == ["t", "s0"]
    worst, what = with_mujoco(path, options)
    assert worst < 1e-9 and "closed" in what


TURNED = 'pos="-0.454 -0.053 0.442" zaxis="-0.097 -0.69 -0.1"'
MASS = '<inertial pos="-0.097 -0.16 0.158" mass="1.3" diaginertia="0.03 0.04 0.05"/>'


def test_what_rounding_leaves_of_no_mass_is_none(tmp_path: Path) -> None:
    """Two of three hinges of a welded body turn on one line and move nothing, in axes of which products are rounded."""
    path = tmp_path / "model.xml"
    hinges = '<joint name="a"/><joint name="b" pos="-0.027 0.05 0.075"/><joint name="c"/>'
    path.write_text(
        '<mujoco><worldbody><body name="A" quat="-0.481 0.902 0.86 0.249" pos="-0.199 0.475 0.281">'
        f'<joint name="r" axis="-0.001 -0.294 -0.894"/>{MASS}<body name="B" {TURNED}>{hinges}{MASS}</body></body>'
        '</worldbody><equality><weld body1="B"/></equality></mujoco>'
    )
    found = derive(load_robot(path).mechanism)
    assert "forward_dynamics" not in found.programs and MASSLESS_NOTE in found.notes
