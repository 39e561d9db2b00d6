"""Mechanisms written in another way: moved, scaled, reordered; and what must hold of every analysis of mobility."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy

from symscrew.description.builder import MechanismBuilder
from symscrew.mobility.analysis import Mobility, analyse_mobility


def check_reciprocity(found: Mobility) -> None:
    freedoms, constraints = found.platform.freedoms.basis, found.platform.constraints.basis
    assert len(freedoms) + len(constraints) == 6
    wrenches = [*constraints]
    for limb in found.limbs:
        assert len(limb.constraints.basis) + limb.constraints.rank == 6
        wrenches += limb.constraints.basis
        assert all(abs(power(t, w)) < 1e-25 * size(t, w) for t in limb.screws for w in limb.constraints.basis)
    assert all(abs(power(t, w)) < 1e-25 * size(t, w) for t in freedoms for w in wrenches)


def power(twist: Any, wrench: Any) -> Any:
    return sum(twist[k] * wrench[k - 3] for k in range(6))


def size(twist: Any, wrench: Any) -> Any:
    return max(1, *(abs(c) for c in twist)) * max(1, *(abs(c) for c in wrench))


ROTATION = sympy.Matrix([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3


SHIFT = sympy.Matrix([sympy.Rational(7, 3), -5, sympy.Rational(1, 7)])


def moved(joints: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The whole mechanism rotated and shifted."""
    return [
        {
            **joint,
            "point": list(ROTATION * sympy.Matrix(joint["point"]) + SHIFT),
            "axes": [list(ROTATION * sympy.Matrix(axis)) for axis in joint.get("axes", [])],
        }
        for joint in joints
    ]


def scaled(factor: Any) -> Any:
    def change(joints: list[dict[str, Any]]) -> list[dict[str, Any]]:
        return [
            {
                **joint,
                "point": [c * factor for c in joint["point"]],
                **({"pitch": joint["pitch"] * factor} if "pitch" in joint else {}),
            }
            for joint in joints
        ]

    return change


def permuted(joints: list[dict[str, Any]]) -> list[dict[str, Any]]:
    order = np.random.default_rng(7).permutation(len(joints))
    return [joints[k] for k in order]


def reversed_joints(joints: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Every second joint with its parent and child exchanged; the axes of a universal joint with them."""
    result = []
    for k, joint in enumerate(joints):
        if k % 2 == 0:
            joint = {**joint, "parent": joint["child"], "child": joint["parent"]}
            if joint["type"] == "U":
                joint["axes"] = joint["axes"][::-1]
        result.append(joint)
    return result


def four_bar_with(axis: list[str]) -> Mobility:
    builder = MechanismBuilder("nearly", platform="coupler")
    for body in ("crank", "coupler", "rocker"):
        builder.body(body)
    z = [0, 0, 1]
    builder.joint("A", "R", parent="base", child="crank", point=[0, 0, 0], axes=[z])
    builder.joint("B", "R", parent="crank", child="coupler", point=[1, 2, 0], axes=[z])
    builder.joint("C", "R", parent="coupler", child="rocker", point=[4, 3, 0], axes=[axis])
    builder.joint("D", "R", parent="rocker", child="base", point=[4, 0, 0], axes=[z])
    return analyse_mobility(builder.build())
