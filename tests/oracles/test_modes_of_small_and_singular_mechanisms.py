"""Assembly modes of mechanisms of micrometres, and start systems that a singular reference leads to infinity."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from support.linkages import COMPLETE, single_loop

import symscrew
from symscrew.assembly import mode_lines
from symscrew.assembly.all_modes import structure_of
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.families import AllNumbers
from symscrew.assembly.mode_names import Named, distances_of, numbered
from symscrew.assembly.path_tracking import Tracker
from symscrew.assembly.start_system import searched
from symscrew.assembly.what_is_held import held_by

NEAR = Fraction(4, 10000)
"""Of the slider from its dead centre, in lengths of the rod."""
POINTS = [[1, 0, 0], ["0.6", "0.8", "0.1"], ["-0.2", 1, "0.3"], [-1, "0.3", 0]]
AXES = [[[0, 0, 1]], [[0, "3/5", "4/5"]], [["2/3", "-1/3", "2/3"]], [["6/7", "2/7", "-3/7"]]]


def slider(size: Fraction) -> symscrew.Mechanism:
    """A platform that only slides, on a crank and a rod that is almost upright: two modes, 8e-4 apart."""
    builder = symscrew.MechanismBuilder("almost_upright", platform="slider")
    for body in ("crank", "rod", "slider"):
        builder.body(body)
    joints = {"P": ("P", "base", "slider", (NEAR, 0)), "A": ("R", "base", "crank", (-1, 1)),
              "B": ("R", "crank", "rod", (0, 1)), "C": ("R", "rod", "slider", (NEAR, 0))}  # fmt: skip
    for name, (kind, parent, child, (x, z)) in joints.items():
        builder.joint(
            name, kind, parent=parent, child=child, point=[str(x * size), "0", str(z * size)],
            axes=[[1, 0, 0] if kind == "P" else [0, 1, 0]], driven=name == "A",
        )  # fmt: skip
    return builder.limb("one", joints=["P"]).limb("two", joints=["A", "B", "C"]).build()


@pytest.mark.parametrize("size", [Fraction(1, 10**6), Fraction(1), Fraction(10**6)])
def test_modes_and_their_names_are_the_same_in_every_unit(size):
    found = symscrew.assembly_modes(slider(size))
    assert [(mode.name, mode.ways, mode.certified) for mode in found.modes] == [("home", 1, True), ("-1", 1, True)]
    assert [mode.translation[0] / float(size) for mode in found.modes] == pytest.approx([0, -2 * float(NEAR)])


@pytest.mark.slow
def test_a_zero_at_infinity_is_no_start():
    held = held_by(single_loop("RCCC", POINTS, AXES), {}, {})
    equations = BatchEquations(structure_of(held))
    family, random = AllNumbers(equations), np.random.default_rng(0)
    numbers, tracker = family.way(family.own, family.own).at(np.zeros(1)), Tracker(equations)
    z = equations.scaled(random.normal(size=(200, equations.width)) + 1j * random.normal(size=(200, equations.width)))
    with np.errstate(all="ignore"):
        for _ in range(60):
            step = tracker.newton(z, numbers)
            z = equations.scaled(np.nan_to_num(z + step, nan=1.0))
    still = np.linalg.norm(step, axis=1) < 1e-12
    far = z[still & (equations.norms(z).min(axis=1) < 1e-12)]
    _, slopes = equations.evaluate(far, numbers)
    sizes = np.linalg.svd(np.concatenate([slopes, equations.patches(far)], axis=1), compute_uv=False)
    start = searched(family, far[int(sizes[:, -1].argmax())])  # a regular one, whose paths are short
    assert start.complete and equations.norms(equations.scaled(start.zeros)).min() > 1e-6


def about(axis: np.ndarray, angle: float) -> np.ndarray:
    x, y, z = axis
    hat = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * hat + (1 - np.cos(angle)) * hat @ hat)


@pytest.mark.parametrize("seed", range(3))
def test_modes_that_are_turned_alike_have_one_order_wherever_the_mechanism_stands(seed):
    """Six legs alike, modes turned alike about axes towards each: their order is that of the legs, not of a frame."""
    random = np.random.default_rng(seed)
    marks = np.array([[np.cos(a), np.sin(a), h] for h in (0, 1) for a in np.arange(6) * np.pi / 3])
    poses = [(about(np.array([np.cos(a), np.sin(a), 0]), 0.7), np.array([0, 0, 0.3])) for a in np.arange(6) * np.pi / 3]
    turn, shift = np.linalg.qr(random.normal(size=(3, 3)))[0], random.normal(size=3)
    turn *= np.linalg.det(turn)

    def named(turn: np.ndarray, shift: np.ndarray) -> list[str]:
        modes = []
        for rotation, translation in poses:
            moved = turn @ rotation @ turn.T
            way = turn @ translation + shift - moved @ shift
            distances = distances_of(marks @ turn.T + shift, moved, way)
            modes.append(Named(np.zeros(8), moved, way, "+", distances))
        return numbered(modes, None)

    assert named(turn, shift) == named(np.eye(3), np.zeros(3))


def test_a_reference_in_which_a_part_turns_loosely_is_a_mode_on_a_curve():
    """Both cranks' ends in one place: what hangs between them turns about it, and no path leads there."""
    builder = symscrew.MechanismBuilder("loose", ground="ground")
    pins = {
        "A": ("ground", "left", ["0", "0", "0"]), "B": ("ground", "right", ["2", "0", "0"]),
        "C": ("left", "first", ["1", "1", "0"]), "D": ("right", "second", ["1", "1", "0"]),
        "E": ("first", "second", ["1", "2", "0"]),
    }  # fmt: skip
    for body in ("left", "right", "first", "second"):
        builder.body(body)
    for name, (parent, child, point) in pins.items():
        builder.joint(name, "R", parent=parent, child=child, point=point, axes=[[0, 0, 1]], driven=name in "AB")
    found = symscrew.assembly_modes(builder.build())
    (mode,) = found.modes
    assert mode.name == "home" and mode.curve and not mode.certified and found.complete not in COMPLETE
    assert "solutions beside it without end" in mode_lines(found)[-1] and found.account.from_random_places == 0
