"""Assembly modes of single loops, linkages with slides, spherical mechanisms: many starts, and known counts."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from support.linkages import COMPLETE, by_many_starts, joined, single_loop, spherical_wrist
from support.platforms import exact

import symscrew
from symscrew import MechanismBuilder
from symscrew.assembly import AssemblyModes
from symscrew.assembly.certified_roots import certified
from symscrew.assembly.equal_axes import axis_of, straight_in_spinors
from symscrew.assembly.rectangles import read

pytestmark = pytest.mark.slow


def held_to(found: AssemblyModes, starts: int) -> None:
    """As many modes as Newton's method finds, all proved and closed."""
    expected = by_many_starts(found.mechanism, found.columns, starts)
    assert found.complete in COMPLETE and len(found.modes) == len(expected) > 0
    assert all(mode.certified and mode.residual < 1e-12 for mode in found.modes)


SEVEN = [[1, 0, 0], ["0.6", "0.8", "0.1"], ["-0.2", 1, "0.3"], [-1, "0.3", 0], ["-0.8", "-0.6", "0.2"],
         ["0.1", -1, "-0.3"], ["0.7", "-0.7", "0.1"]]  # fmt: skip
TURNS = [[[0, 0, 1]], [[0, "3/5", "4/5"]], [["2/3", "-1/3", "2/3"]], [["6/7", "2/7", "-3/7"]], [["-4/5", 0, "3/5"]],
         [["1/3", "2/3", "2/3"]], [["2/7", "3/7", "6/7"]]]  # fmt: skip


def test_a_loop_of_a_hinge_and_three_cylinders_has_two_modes_each_time_it_is_asked_for():
    # Yang and Freudenstein 1964: two closures of an RCCC; what a search keeps is read by the next one
    mechanism = single_loop("RCCC", SEVEN[:4], TURNS[:4])
    for drives in ({}, {"j0": "0.3"}):
        found = symscrew.assembly_modes(mechanism, drives)
        assert found.bound is not None and found.bound.count == 2 == len(found.modes)
        assert found.complete in COMPLETE and all(mode.residual < 1e-12 for mode in found.modes)


def test_a_universal_joint_makes_modes_of_its_own_where_no_platform_is_named():
    axes = [TURNS[0], None, [[1, 0, 0], [0, "3/5", "4/5"]], TURNS[2]]
    free, carried = (single_loop("RSUR", SEVEN[:4], axes, platform) for platform in (None, "b0"))
    held_to(symscrew.assembly_modes(free), 60)
    assert len(symscrew.assembly_modes(carried).modes) < len(symscrew.assembly_modes(free).modes)


SIX_BAR = [
    ("R", "ground", "a", ["-0.9", "-1.8"], None), ("R", "a", "b", ["-1.8", "2"], None),
    ("R", "b", "c", ["1.9", "1.6"], None), ("R", "c", "ground", ["0.7", "-0.9"], None),
    ("R", "b", "d", ["0.8", "-1.7"], None), ("P", "d", "e", ["1.6", "1.5"], [0, 1, 0]),
    ("R", "e", "c", ["1.4", "-0.2"], None),
]  # fmt: skip


@pytest.mark.parametrize(("slides", "drives"), [({2, 3, 5}, {"j0": "-0.1"}), ({5}, {})])
def test_linkages_with_slides_have_all_their_modes(slides, drives):
    directions = {2: ["3/5", "4/5", 0], 3: [1, 0, 0], 5: [0, 1, 0]}
    edges = [("P" if k in slides else "R", *edge[1:4], directions.get(k) if k in slides else None)
             for k, edge in enumerate(SIX_BAR)]  # fmt: skip
    held_to(symscrew.assembly_modes(joined(edges), drives), 60)


def test_a_wrist_of_right_angles_has_eight_modes_and_a_spherical_four_bar_two():
    # Gosselin and Angeles 1989: eight poses of a spherical 3-RRR
    x, y, z = [1, 0, 0], [0, 1, 0], [0, 0, 1]
    wrist = symscrew.assembly_modes(spherical_wrist([(x, z, y), (y, x, z), (z, y, x)]), {"j00": "0.2", "j10": "-0.3"})
    assert len(wrist.modes) == 8 and wrist.complete in COMPLETE and wrist.bound is not None and wrist.bound.count == 8
    turns = np.array([mode.rotation for mode in wrist.modes])
    assert all(np.abs(turns - turn).max(axis=(1, 2)).min() < 1e-9 for turn in by_inner_axes(0.2, -0.3, 0.0))
    four_bar = single_loop("RRRR", [[0, 0, 0]] * 4, TURNS[:4])
    held_to(symscrew.assembly_modes(four_bar, {"j0": "0.1"}), 20)


def by_inner_axes(*angles: float) -> list[np.ndarray]:
    """Rotations of the wrist by Newton's method for what its limbs say: inner axes w are across turned y, z, x."""
    columns = np.eye(3)
    inner, outer = columns[[2, 0, 1]], columns[[1, 2, 0]]
    w = [_turned(columns[k], a) @ inner[k] for k, a in enumerate(angles)]
    found: list[np.ndarray] = []
    for start in np.random.default_rng(1).normal(size=(70, 4)):
        q = start
        for _ in range(20):
            values = np.array([w[k] @ _matrix(q) @ outer[k] for k in range(3)] + [q @ q - 1])
            slopes = np.array([[(w[k] @ (_matrix(q + h) - _matrix(q - h)) @ outer[k]) / 2e-6 for h in 1e-6 * np.eye(4)]
                               for k in range(3)] + [2 * q])  # fmt: skip
            q = q - np.linalg.lstsq(slopes, values, rcond=None)[0]
        if np.abs(values).max() < 1e-12 and all(np.abs(_matrix(q) - turn).max() > 1e-6 for turn in found):
            found.append(_matrix(q))
    assert len(found) == 8
    return found


def _turned(axis: np.ndarray, angle: float) -> np.ndarray:
    return _matrix(np.array([np.cos(angle / 2), *(np.sin(angle / 2) * axis)]))


def _matrix(q: np.ndarray) -> np.ndarray:
    """Of a quaternion, times its square."""
    w, v = q[0], q[1:]
    hat = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return (w * w - v @ v) * np.eye(3) + 2 * np.outer(v, v) + 2 * w * hat


def test_a_leg_that_is_held_too_much_is_looked_at_in_both_its_ways():
    builder = MechanismBuilder("four_legs", ground="base", platform="tool")
    builder.body("tool")
    points = [([0, 0], [0, 1]), ([3, 0], ["2.4", "0.8"]), ([1, 3], [1, 2]), ([3, 3], [3, 2])]
    for k, (a, b) in enumerate(points):
        one, two = ([*exact(p), 0] for p in (a, b))
        way = [c - d for c, d in zip(two, one, strict=True)]
        builder.body(f"lower{k}")
        builder.body(f"upper{k}")
        builder.joint(f"R{k}", "R", parent="base", child=f"lower{k}", point=one, axes=[[0, 0, 1]])
        builder.joint(f"leg{k}", "P", parent=f"lower{k}", child=f"upper{k}", point=one, axes=[way], driven=True)
        builder.joint(f"T{k}", "R", parent=f"upper{k}", child="tool", point=two, axes=[[0, 0, 1]])
    mechanism = builder.build()
    shorter = symscrew.assembly_modes(mechanism, {"leg3": -2})  # the leg of length 1 pushed through its hinge
    assert len(symscrew.assembly_modes(mechanism).modes) == len(shorter.modes) == 1
    assert not symscrew.assembly_modes(mechanism, {"leg3": "-1.5"}).modes


def test_axes_between_two_members_stay_as_long_as_one_another():
    random = np.random.default_rng(3)
    ends = [[(v / np.sqrt(v @ v + 0j)) for v in random.normal(size=(2, 3)) + 1j * random.normal(size=(2, 3))]
            for _ in range(2)]  # fmt: skip
    at = straight_in_spinors(*ends, [(0, 1)])
    for s in (0.0, 0.3 + 0.1j, 1.0):
        w, u = at(s)
        assert abs(w @ w - u @ u) < 1e-14 < abs(w @ w)
    for s, (w, u) in enumerate(ends):
        (one, two), scale = at(s), at(s)[0] @ w
        assert np.abs(one - scale * w).max() < 1e-13 and np.abs(two - scale * u).max() < 1e-13
    axis, size = axis_of([1, 2, 3, 4])
    assert np.dot(axis, axis) == size**2 == 900


def test_a_box_says_whether_its_zero_is_real():
    found = symscrew.assembly_modes(symscrew.load_catalogue("planar_3rrr"), {"limb1_R1": "0.1"})
    assert found.family is not None
    equations, ends = found.family.equations, [end for end in found.account.ends if end.kind != "infinity"]
    slots = found.family.member(dict(found.columns))
    boxes = [read(complex(s).real) if np.ndim(s) == 0 else [read(complex(c).real) for c in s] for s in slots]
    kinds = [(end.kind, proof.kind) for end in ends if (proof := certified(equations, boxes, end.z)) is not None]
    assert {("real", "real"), ("complex", "complex")} == set(kinds)
    beside = next(end.z for end in ends if end.kind == "real") * np.exp(0.3j) + 1e-9j  # noise of an ill end
    proof = certified(equations, boxes, beside)
    assert proof is not None and proof.kind == "real"  # so that it is counted as a mode, whatever its end was called


NORMALS = [["-2/7", "6/7", "3/7"], ["1/3", "2/3", "-2/3"], ["0", "3/5", "4/5"], ["0", "-1", "0"]]


@pytest.mark.parametrize("normal", NORMALS)
def test_a_four_bar_in_a_plane_of_any_direction_has_its_two_modes_by_the_same_names(normal: list[str]) -> None:
    """Rocker's turn from home by the circles that meet in C: the axis is no multiple of (0, 0, 1) but for rounding."""
    n = np.array([float(Fraction(c)) for c in normal])
    first = np.cross(n, [1.0, 0, 0] if abs(n[0]) < 0.9 else [0, 1.0, 0])
    first /= np.linalg.norm(first)
    frame = np.array([first, np.cross(n, first)])
    flat = {"A": (0.0, 0.0), "B": (0.25, 0.5), "C": (1.5, 1.25), "D": (2.0, -0.25)}
    builder = MechanismBuilder("tilted", platform="rocker").body("crank").body("coupler").body("rocker")
    ends = {"A": ("base", "crank"), "B": ("crank", "coupler"), "C": ("coupler", "rocker"), "D": ("base", "rocker")}
    for name, (parent, child) in ends.items():
        point = exact((np.array(flat[name]) @ frame + [0.3, -0.2, 0.7]).tolist())
        builder.joint(name, "R", parent=parent, child=child, point=point, axes=[normal], driven=name == "A")
    found = symscrew.assembly_modes(builder.build())
    b, c, d = (np.array(flat[name]) for name in "BCD")
    along, off = (b - d) / np.linalg.norm(b - d), c - d
    mirrored = 2 * (off @ along) * along - off
    turn = np.arctan2(off[0] * mirrored[1] - off[1] * mirrored[0], off @ mirrored)
    assert found.complete in COMPLETE and [mode.name for mode in found.modes] == ["home", "-1"]
    assert np.allclose(found.modes[0].rotation, np.eye(3), atol=1e-12)
    made = found.modes[1].rotation
    skew = np.array([made[2, 1] - made[1, 2], made[0, 2] - made[2, 0], made[1, 0] - made[0, 1]]) / 2
    assert np.allclose(skew, np.sin(turn) * n, atol=1e-12) and abs((np.trace(made) - 1) / 2 - np.cos(turn)) < 1e-12
