"""Loops of special geometry that share a hinge, typed with six digits: what was meant is found, or what was not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy
from support.further_mechanisms import graph, turning_triangles, waldron_hybrid
from support.parallel_mechanisms import THIRDS, turned
from support.reposed import _axis, posed

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.mobility import Mobility, analyse_mobility, verify
from symscrew.mobility.finite import near_geometry
from symscrew.mobility.symbols import LimbPose

SPHERICAL_AND_SARRUS = (
    ("base", "b1", "-2.09329 -0.975844 1.22333", "-0.138674 -0.409137 0.901874"),
    ("b1", "b2", "-2.74518 0.102697 0.439756", "0.662419 -0.727338 0.17939"),
    ("b2", "b3", "-2.46881 -1.12749 0.534823", "-0.734888 -0.657289 -0.167064"),
    ("b3", "base", "-1.74912 -1.50046 0.276227", "0.281103 -0.87127 -0.40233"),
    ("b1", "b4", "0.375446 1.47478 2.79361", "-0.138674 -0.409137 0.901874"),
    ("b4", "b5", "0.268019 -1.38688 -0.211658", "-0.138674 -0.409137 0.901874"),
    ("b5", "b6", "0.0378202 -0.368541 1.70094", "0.853782 0.504965 0.126751"),
    ("b6", "b7", "-2.33251 0.22173 -0.104664", "0.853782 0.504965 0.126751"),
    ("b7", "base", "-1.71893 0.720374 0.93398", "0.853782 0.504965 0.126751"),
)
"""A spherical four-bar and a Sarrus linkage about its first hinge, which each of them turns: parent, child, point, axis
in six digits. As meant each moves with one freedom, and they share it."""


@pytest.fixture
def joined() -> Mechanism:
    builder = MechanismBuilder("joined", ground="base", platform="b1")
    for k in range(1, 8):
        builder.body(f"b{k}")
    for k, (parent, child, point, axis) in enumerate(SPHERICAL_AND_SARRUS):
        unit = _axis([sympy.Rational(c) for c in axis.split()], "6")
        place = [sympy.Rational(c) for c in point.split()]
        builder.joint(f"J{k}", "R", parent=parent, child=child, point=place, axes=[unit], driven=k == 0)
    return builder.build()


def test_what_was_meant_is_found_by_axes_that_nearly_meet_or_are_parallel(joined: Mechanism) -> None:
    """Steps along slopes do not lead there: hinges tilted against each other keep the conditions to first order."""
    found = analyse_mobility(joined)
    assert found.finite.dof == 0 and found.near is not None and not found.not_tried
    meant = found.near.meant
    assert (meant.dof, meant.finite.dof, meant.overconstraints) == (1, 1, 4)
    assert found.near.distance < 5e-6


def test_what_was_meant_is_found_by_few_motions_without_its_axes(
    joined: Mechanism, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its loops nearly close along all motions: a search that stalls there goes on from zeros."""
    monkeypatch.setattr(near_geometry, "MOTIONS", 4)
    monkeypatch.setattr(near_geometry, "aligned", lambda network, tolerance: None)
    found = analyse_mobility(joined)
    assert found.near is not None and found.near.meant.finite.dof == 1
    assert found.near.distance < 5e-6


@pytest.mark.parametrize("legs", [2, 3])
def test_hinges_of_a_sarrus_linkage_rounded_one_by_one_are_parallel_as_meant(legs: int) -> None:
    """Of three legs, whose axes are along a plane by what is left once those of each are parallel."""
    random = np.random.default_rng(7)
    frame = np.linalg.qr(random.normal(size=(3, 3)))[0]
    builder = MechanismBuilder("sarrus", platform="plate").body("plate")
    for k in range(legs):
        c, s = np.cos(2.2 * k), np.sin(2.2 * k)
        bodies = ["base", f"low{k}", f"high{k}", "plate"]
        for name in bodies[1:3]:
            builder.body(name)
        for i, (x, z) in enumerate([(5, 0), (6.1, 2.2), (4.3, 3.9)]):
            size = random.uniform(0.3, 3)  # directions of any length, as CAD writes them
            axis = [sympy.Rational(f"{v:.6g}") for v in size * frame @ (-s, c, 0)]
            point = [sympy.Rational(f"{v:.6g}") for v in frame @ (x * c, x * s, z)]
            builder.joint(f"R{k}{i}", "R", parent=bodies[i], child=bodies[i + 1], point=point, axes=[_axis(axis, "6")])
    found = analyse_mobility(builder.build())
    assert found.finite.dof == 0 and found.near is not None
    assert (found.near.meant.finite.dof, found.near.meant.platform.type) == (1, "1T")
    assert found.near.distance < 1e-5


@pytest.mark.parametrize("digits", ["12", "6"])
def test_two_bennett_loops_of_one_shape_about_one_axis(digits: str) -> None:
    """Eight conditions, two of which vanish twice there, as no loops of different shapes have it."""
    linkage = waldron_hybrid()
    names = ("name", "type", "parent", "child", "point", "axes")
    joints = posed([{key: getattr(joint, key) for key in names} for joint in linkage.joints.values()],
                   seed=0, digits=digits, unit="m")  # fmt: skip
    builder = MechanismBuilder("typed")
    for body in (name for name in linkage.bodies if name != linkage.ground):
        builder.body(body)
    for joint in joints:
        builder.joint(joint.pop("name"), joint.pop("type"), **joint)
    found = analyse_mobility(builder.build())
    assert found.finite.dof == 0 and found.near is not None and not found.not_tried
    assert (found.near.meant.dof, found.near.meant.finite.dof, found.near.meant.overconstraints) == (1, 1, 1)
    assert found.near.distance < 10 ** (0.5 - float(digits))


PARALLELOGRAMS = (
    ("base", "u", 0, 0), ("base", "v", 1, 0), ("u", "m", 1, 3), ("v", "m", 2, 3), ("u", "n", "2/3", 2),
    ("v", "n", "5/3", 2), ("m", "t", 5, 3), ("n", "t", "14/3", 2),
)  # fmt: skip
"""Two parallelograms in a row, which hold a tool about a remote centre: pins of two bodies in a plane."""


@pytest.mark.slow
def test_a_condition_with_a_slope_of_second_order_is_met() -> None:
    """Normals of triangles rounded one by one: one slope is 1e-13, cut off as rounding; what is left is along it."""
    found = typed(turning_triangles(), seed=7038, digits="6")
    assert found.finite.dof == 0 and found.near is not None
    meant = found.near.meant
    assert (meant.dof, meant.finite.dof, meant.overconstraints, meant.platform.type) == (1, 1, 7, "1T")
    assert found.near.distance < 1e-5


@pytest.mark.slow
def test_pins_of_parallelograms_are_found_among_axes_that_are_parallel_as_typed() -> None:
    """All hinges are rounded alike; tilted one by one they were so many double zeros that the search was given up."""
    pins = ((a, b, [sympy.Rational(x), sympy.Rational(y), 0]) for a, b, x, y in PARALLELOGRAMS)
    linkage = graph(*(("R", a, b, point, [0, 0, 1]) for a, b, point in pins))
    found = typed(linkage, seed=595, digits="6")
    assert found.finite.dof == 0 and found.near is not None and not found.not_tried
    assert (found.near.meant.dof, found.near.meant.finite.dof, found.near.meant.overconstraints) == (1, 1, 11)
    assert found.near.distance < 1e-5
    axes = {place[1] for place in found.near.places().values()}
    assert len(axes) == 1, "parallel as typed, and as meant"


def stretched_planar_limbs() -> Mechanism:
    """3-RER, each limb with both hinges and the normal of its planar joint in one plane: no platform motion is left."""
    builder = MechanismBuilder("stretched", platform="plate").body("plate")
    for k, place in enumerate(THIRDS):
        places = {"R": [5, 0, 0], "E": [3, 1, 2], "Q": [7, 3, 4]}
        bodies = ["base", f"low{k}", f"high{k}", "plate"]
        for body in bodies[1:3]:
            builder.body(body)
        for i, (name, point) in enumerate(places.items()):
            axis = [0, sympy.Rational(3, 5), sympy.Rational(4, 5)] if name == "E" else [1, 0, 0]
            builder.joint(f"{name}{k}", "E" if name == "E" else "R", parent=bodies[i], child=bodies[i + 1],
                          point=turned(point, place), axes=[turned(axis, place)])  # fmt: skip
        builder.limb(f"limb{k}", joints=[f"{name}{k}" for name in places])
    return builder.build()


def test_planar_joints_stay_planar_and_have_one_axis_to_type() -> None:
    """Both directions in a plane turn with its normal; they were changed one by one, and all three to be typed."""
    linkage = stretched_planar_limbs()
    found = typed(linkage, seed=5, digits="9")
    assert found.platform.type == "3T" and found.near is not None and found.near.meant.platform.type == "0"
    joints = dict(typed_mechanism(linkage, seed=5, digits="9").joints)
    for name, (point, axes, _) in found.near.places().items():
        assert len(axes) == 1
        axis = tuple(sympy.Rational(c) for c in axes[0])
        joints[name] = replace(joints[name], point=tuple(map(sympy.Rational, point)), axes=(axis,))
    again = analyse_mobility(replace(linkage, joints=joints))
    assert again.platform.type == "0" and again.near is None


def test_displacements_in_a_plane_across_no_absolute_axis_have_no_symbols() -> None:
    """Their directions have no unit length without a root; a check had to withdraw what was said of them."""
    found = analyse_mobility(stretched_planar_limbs())
    assert isinstance(found.limb_poses["limb0"], LimbPose)
    assert found.limb_poses["limb1"] == (
        "no symbols: unit directions in the plane of E1, across no absolute axis, are roots"
    )
    assert [check.claim for check in verify(found) if not check.holds] == []


@pytest.mark.parametrize("pitch, digits", [("1/10", "9"), ("1/10000", "double"), ("1/10000", "9"), ("1/10000", "6")])
def test_fine_pitches_of_jacks_are_no_rounding(pitch: str, digits: str) -> None:
    """A table on three screw jacks rises. With pitches of 0.1 mm/rad, a millionth of what else the closure has, hinges
    in their place were named as meant, with three freedoms."""
    builder = MechanismBuilder("jacks", platform="table").body("table")
    for k, place in enumerate(THIRDS):
        low, high = (turned([3, 0, z], place) for z in (0, 1))
        builder.body(f"screw{k}")
        builder.joint(f"R{k}", "R", parent="base", child=f"screw{k}", point=low, axes=[[0, 0, 1]])
        builder.joint(
            f"H{k}", "H", parent=f"screw{k}", child="table", point=high, axes=[[0, 0, 1]], pitch=sympy.Rational(pitch)
        )
        builder.limb(f"limb{k}", joints=[f"R{k}", f"H{k}"])
    jacks = builder.build()
    meant = analyse_mobility(jacks)
    assert (meant.dof, meant.finite.dof, meant.platform.type, meant.near) == (1, 1, "1T", None)
    found = typed(jacks, seed=7, digits=digits)
    assert found.near is None or (found.near.meant.finite.dof, found.near.meant.platform.type) == (1, "1T")
    if digits == "6":  # the pitch is a hundred times the rounding
        assert found.near is not None or "special geometry" in found.not_tried[0]
    else:
        assert found.near is not None and found.near.distance < {"double": 1e-15, "9": 1e-7}[digits]


def typed_mechanism(linkage: Mechanism, *, seed: int, digits: str) -> Mechanism:
    joints = [{"point": list(j.point), "axes": [list(axis) for axis in j.axes]} for j in linkage.joints.values()]
    made = posed(joints, seed=seed, digits=digits, unit="m")
    return replace(linkage, joints={
        name: replace(joint, point=tuple(new["point"]), axes=tuple(map(tuple, new["axes"])))
        for (name, joint), new in zip(linkage.joints.items(), made, strict=True)
    })  # fmt: skip


def typed(linkage: Mechanism, *, seed: int, digits: str) -> Mobility:
    return analyse_mobility(typed_mechanism(linkage, seed=seed, digits=digits))
