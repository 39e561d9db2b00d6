"""Mechanisms of any size, through the public API: platforms with n limbs, chains of n joints."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism

HEIGHT = "3/5"
# (branch, where it hangs, its first point [m], step to the next point [1/20 m], axes of its joints), of the left side
LEG = ("leg", "pelvis", ("0", "1/10", "-1/10"), (0, 0, -2), "zxyyyx")
ARM = ("arm", "waist3", ("0", "1/5", "2/5"), (0, 1, 0), "yxzyxyz")
FINGERS = tuple(
    (finger, "arm7", ("0", "3/5", f"2/5 + {height}/50"), (0, 1, 0), "zyy") for height, finger in enumerate("abc")
)


def platform(limbs: int) -> Mechanism:
    """A platform on a spherical joint at O with `limbs` UPS limbs, sliders driven; points on two circles.

    Three limbs hold it, more drive it redundantly; with two limbs one freedom carries no drive. The circles
    are turned against each other and against the axes: all limbs are of one shape, none has special angles.
    """
    builder = MechanismBuilder(f"platform_{limbs}", platform="platform")
    builder.body("platform", mass=3, com=[0, 0, HEIGHT], inertia=["0.07", "0.08", "0.1"])
    builder.limb("centre", "S", points=[[0, 0, 0]])
    for k in range(limbs):
        angle = 2 * math.pi * k / limbs
        foot, head = _on_circle(0.8, angle + 1 / 7, 0), _on_circle(0.5, angle + 1 / 2, HEIGHT)
        across, along, normal = _axes(foot, head)
        turned = [normal, across[1], along]
        inertia = [{"principal": [i, i, "6e-4"], "axes": turned} for i in ("0.011", "0.009")]
        builder.limb(
            f"limb{k + 1}",
            "UP*S",
            points=[foot, head],
            axes=[across, [along], []],
            mass=["1.4", "1.2"],
            com=[_mix(foot, head, "1/4"), _mix(foot, head, "3/4")],
            inertia=inertia,
        )
    return builder.build()


def chain(joints: int) -> Mechanism:
    """A serial chain of `joints` revolute joints, axes alternately along z and y, links along x and z."""
    builder = MechanismBuilder(f"chain_{joints}", platform=f"link{joints}")
    x, z = 0, 0
    for k in range(joints):
        tip_x, tip_z = (x + 1, z) if k % 2 else (x, z + 1)
        centre = [f"({x} + {tip_x})/10", "1/50", f"({z} + {tip_z})/10"]
        builder.body(f"link{k + 1}", mass=2, com=centre, inertia=["0.01", "0.012", "0.008"])
        builder.joint(
            f"joint{k + 1}",
            "R",
            parent=f"link{k}" if k else "base",
            child=f"link{k + 1}",
            point=[f"{x}/5", 0, f"{z}/5"],
            axes=[[0, 1, 0] if k % 2 else [0, 0, 1]],
            driven=True,
        )
        x, z = tip_x, tip_z
    return builder.build()


def humanoid() -> Mechanism:
    """A walking machine on a floating base with 50 driven revolute joints, as public descriptions of humanoids have.

    Legs of 6, a waist of 3, a neck of 3, arms of 7 and three fingers of 3 on each; inertias of all links are full.
    """
    builder = MechanismBuilder("humanoid", platform="pelvis")
    builder.body("pelvis", mass=9, com=["1/100", 0, "1/50"], inertia=["0.05", "0.04", "0.06"])
    builder.joint("root", "free", parent="base", child="pelvis", point=[0, 0, 0])
    middle = [
        ("waist", "pelvis", ("0", "0", "1/10"), (0, 0, 1), "zxy"),
        ("neck", "waist3", ("0", "0", "1/2"), (0, 0, 1), "zyx"),
    ]
    for branch in middle:
        _branch(builder, *branch, side="", sign=1)
    for side, sign in (("left_", 1), ("right_", -1)):
        for branch in (LEG, ARM, *FINGERS):
            _branch(builder, *branch, side=side, sign=sign)
    return builder.build()


def _branch(
    builder: MechanismBuilder, name: str, on: str, start: tuple[str, str, str], step: tuple[int, int, int], axes: str,
    *, side: str, sign: int,
) -> None:  # fmt: skip
    """Links one behind the other; of the right side y is mirrored."""
    parent = on if on == "pelvis" or on.startswith("waist") else f"{side}{on}"
    for k, axis in enumerate(axes, start=1):
        x, y, z = (f"{a} + {n} * {k - 1}/20" for a, n in zip(start, step, strict=True))
        point, link = [x, f"{sign} * ({y})", z], f"{side}{name}{k}"
        com = [f"{x} + 1/100", f"{sign} * ({y} + {step[1]}/40)", f"{z} + {step[2]}/40"]
        inertia = {
            "principal": ["0.006", "0.005", "0.003"],
            "axes": [["3/5", "4/5", "0"], ["-4/5", "3/5", "0"], ["0", "0", "1"]],
        }
        builder.body(link, mass=f"3/{k}", com=com, inertia=inertia)
        direction = [int(axis == a) for a in "xyz"]
        builder.joint(f"{link}_joint", "R", parent=parent, child=link, point=point, axes=[direction], driven=True)
        parent = link


def _on_circle(radius: float, angle: float, height: int | str) -> list:
    """A point of a circle about z, to a tenth of a millimetre."""
    return [f"{radius * math.cos(angle):.4f}", f"{radius * math.sin(angle):.4f}", height]


def _mix(a: list, b: list, part: str) -> list:
    return [f"({p})*(1 - {part}) + ({q})*{part}" for p, q in zip(a, b, strict=True)]


def _axes(foot: list, head: list) -> tuple[list, list, list]:
    """Axes of the universal joint (both horizontal, the second across the leg), along and across the leg."""
    x, y, z = (f"(({q}) - ({p}))" for p, q in zip(foot, head, strict=True))
    level, length = f"sqrt({x}^2 + {y}^2)", f"sqrt({x}^2 + {y}^2 + {z}^2)"
    radial, tangent = [f"{x}/{level}", f"{y}/{level}", "0"], [f"-{y}/{level}", f"{x}/{level}", "0"]
    normal = [f"{x}*{z}/{level}/{length}", f"{y}*{z}/{level}/{length}", f"-{level}/{length}"]
    return [radial, tangent], [f"{x}/{length}", f"{y}/{length}", f"{z}/{length}"], normal


def hinged_octahedron() -> Mechanism:
    """Eight plates hinged along the twelve edges of an octahedron of generic vertices: rigid, with 12 square roots."""
    corners: list[tuple[Any, ...]] = [
        (3, "1/7", "-2/9"),
        (-2, "11/10", "3/8"),
        ("1/5", 3, "17/16"),
        (1, -3, "5/13"),
        ("-3/11", 1, 4),
        ("19/18", "2/15", -3),
    ]
    faces = [(a, b, c) for a in (0, 1) for b in (2, 3) for c in (4, 5)]
    names = {face: f"face{k}" if k else "base" for k, face in enumerate(faces)}
    builder = MechanismBuilder("hinged_octahedron")
    for face in faces[1:]:
        builder.body(names[face])
    edges = [(i, k) for i in range(6) for k in range(i + 1, 6) if i // 2 != k // 2]
    for i, k in edges:
        parent, child = (names[face] for face in faces if i in face and k in face)
        along = [Fraction(q) - Fraction(p) for p, q in zip(corners[i], corners[k], strict=True)]
        size = f"sqrt({sum(c * c for c in along)})"
        axis = [f"{c}/{size}" for c in along]
        builder.joint(f"edge{i}{k}", "R", parent=parent, child=child, point=list(corners[i]), axes=[axis])
    return builder.build()
