"""The branch table against what is known of singular configurations, a source or a reason each."""

from __future__ import annotations

import numpy as np
import pytest
from support.analysed import analysed as found
from support.further_mechanisms import loop, unit
from support.marks import slow

from symscrew.description import MechanismBuilder
from symscrew.mobility import BranchTable, ScrewClass, analyse_mobility, mobility_values, screw_class

pytestmark = pytest.mark.slow


def table(name: str) -> BranchTable:
    result = found(name).branches
    assert result is not None
    return result


def platform(row: object) -> ScrewClass:
    result = getattr(row, "platform", None)
    assert isinstance(result, ScrewClass)
    return result


@pytest.mark.parametrize(
    "name, types, proved",
    [
        # Hunt 1978, ch. 12: at the change point the coupler goes on translating, or turns with crossed cranks
        ("parallelogram-change_point", ["1R", "1T"], True),
        ("rhombus, two branches", ["1R", "1T"], True),
        # Galletti and Fanghella 2001 (kinematotropic): the flat-folded Sarrus linkage has a mode of dimension 2, where
        # each leg turns about its two hinges that coincide, and the platform rests: its freedoms there are none
        ("sarrus-flat_folded", ["0", "1T"], False),
        ("sarrus-stretched", ["1T", "1T"], False),
        # Connelly and Servatius 1994: one curve with a cusp
        slow("double_watt_cusp", ["1R"], False),
        ("two rhombi", ["1R1T", "1R1T", "1R1T", "1T"], True),
        ("five-bar, stretched", [], True),
        ("sarrus", ["1T"], True),
        ("bennett", ["1R"], True),
    ],
)
def test_branches(name: str, types: list[str], proved: bool) -> None:
    rows = table(name)
    assert sorted(platform(row).type for row in rows.rows) == types
    assert (rows.judgement == "proved") == proved == bool(rows.complete) and bool(rows.open) != proved
    finite = found(name).finite
    assert {row.dimension for row in rows.rows} == set([finite.dof] if finite.branches is None else finite.branches)


@pytest.mark.slow
def test_the_modes_of_3_rps_and_3_upu_cross() -> None:
    """Schadlbauer, Walter and Husty 2014 (3-RPS: two operation modes); Walter and Husty 2011 (3-UPU: translations meet
    others); each mode is a branch of dimension 3 where they cross."""
    assert [row.dimension for row in table("3rps-mode_transition").rows] == [3, 3]
    rows = table("3upu_tsai-constraint_sing_cylinder").rows
    assert [row.dimension for row in rows] == [3, 3]
    assert [platform(row).name for row in rows].count("IID") == 1


def test_a_cusp_leaves_to_one_side() -> None:
    assert [row.cusp for row in table("double_watt_cusp").rows] == [True]
    assert not any(row.cusp for row in table("parallelogram-change_point").rows)


def test_joints_at_rest_and_axes() -> None:
    rows = {platform(row).type: row for row in table("rhombus, two branches").rows}
    assert rows["1R"].idle == ("J1", "J3") and rows["1T"].idle == ()
    assert rows["1R"].axes == ("about the axis of J2", "about the axis of J4") and rows["1T"].axes == ()
    assert table("sarrus-flat_folded").rows[0].idle == ("b0", "b1")


def test_pitches_of_a_smooth_branch_are_those_of_the_freedoms_beside_it() -> None:
    """They were those of a sample nearby, so that one report gave two pitches for one screw."""
    (row,), (twist,) = table("bennett").rows, found("bennett").platform.freedoms.basis
    turning = np.array([float(c) for c in twist[:3]])
    pitch = turning @ [float(c) for c in twist[3:]] / (turning @ turning)
    assert row.here and not row.constant and platform(row).pitches == pytest.approx((pitch,), rel=1e-9)
    assert turning @ turning == pytest.approx(1.0)  # a unit screw


def test_tangents_are_instantaneous_motions() -> None:
    for name in ("parallelogram-change_point", "sarrus-flat_folded", "two rhombi"):
        rows = np.array([[float(c) for c in row] for row in found(name).first_order.rows])
        for row in table(name).rows:
            for direction in row.tangent:
                assert np.abs(rows @ direction).max() < 5e-3 and abs(np.linalg.norm(direction) - 1) < 1e-9


def test_in_words_and_json() -> None:
    values = mobility_values(found("parallelogram-change_point"))["branch_table"]
    assert values["complete"] and [b["dimension"] for b in values["branches"]] == [1, 1]
    assert {b["platform"]["class"] for b in values["branches"]} == {"IIA", "IIB"}
    assert len(values["columns"]) == len(values["branches"][0]["tangent"][0])
    from symscrew.mobility import mobility_text

    text = mobility_text(found("bennett"))
    assert "1: dimension 1 (proved)" in text and "not constant" in text and "Complete, proved" in text
    text = mobility_text(found("sarrus-stretched"))
    assert "1: dimension 1 (sampled)" in text and "Not proved complete" in text


X, Y, Z, O = np.eye(3)[0], np.eye(3)[1], np.eye(3)[2], np.zeros(3)


def twist(axis: np.ndarray, point: np.ndarray, pitch: float = 0.0) -> np.ndarray:
    return np.concatenate([axis, np.cross(point, axis) + pitch * axis])


SYSTEMS = {  # Gibson and Hunt 1990: type I where pitches differ, II where not; letter by the translations in it
    "IA of two": ([twist(X, O, 0.3), twist(Y, O, -0.2)], "IA", (-0.2, 0.3)),
    "IIA of two": ([twist(X, O, 0.3), twist(Y, O, 0.3)], "IIA", (0.3,)),
    "cylinder": ([twist(Z, X), np.concatenate([O, Z])], "IB", ()),
    "planar pair": ([twist(Z, X), np.concatenate([O, X])], "IIB", (0.0,)),
    "IIC of two": ([np.concatenate([O, X]), np.concatenate([O, Y])], "IIC", ()),
    "spherical": ([twist(a, X + Y) for a in (X, Y, Z)], "IIA", (0.0,)),
    "IA of three": ([twist(X, O, 0.1), twist(Y, O, 0.2), twist(Z, O, 0.4)], "IA", (0.1, 0.2, 0.4)),
    "planar": ([twist(Z, p) for p in (O, X, Y)], "IIC", (0.0,)),
    "translations": ([np.concatenate([O, a]) for a in (X, Y, Z)], "IID", ()),
    "screw about z and plane": ([twist(Z, O, 0.5), np.concatenate([O, X]), np.concatenate([O, Y])], "IIC", (0.5,)),
    "Schoenflies": ([twist(Z, O), *(np.concatenate([O, a]) for a in (X, Y, Z))], "IIC", ()),
    "all but z translation of five": ([twist(a, O) for a in (X, Y, Z)] + [np.concatenate([O, a]) for a in (X, Y)],
                                      "IIA", (0.0,)),
}  # fmt: skip


@pytest.mark.parametrize("name", SYSTEMS)
@pytest.mark.parametrize("seed", range(3))
def test_classes_of_screw_systems_anywhere_and_in_any_unit(name: str, seed: int) -> None:
    twists, expected, pitches = SYSTEMS[name]
    random = np.random.default_rng(seed)
    q, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn = q * np.sign(np.linalg.det(q))
    shift, unit = 3 * random.normal(size=3), (1.0, 1000.0, 0.001)[seed]
    mixed = random.normal(size=(len(twists) + 2, len(twists))) @ np.array(twists)
    moved = []
    for s in mixed:
        w = turn @ s[:3]
        moved.append(np.concatenate([w, (turn @ s[3:] + np.cross(shift, w)) * unit]))
    system = screw_class(np.array(moved), 2.0 * unit)
    assert system.name == expected and system.order == len(twists)
    assert np.allclose(system.pitches, np.array(pitches) * unit, atol=1e-6 * unit)


def test_what_moves_beside_a_shaky_part_is_not_told_by_ranks() -> None:
    """Of a flat triangle of balls only the links' spins move; where a four-bar moves beside it, its crank does."""
    assert [(row.dimension, row.platform) for row in table("3S, collinear").rows] == [(2, None)]
    builder = MechanismBuilder("beside", platform="crank")
    for body in ("first", "second", "crank", "coupler", "rocker"):
        builder.body(body)
    balls, pins = ("base", "first", "second", "base"), ("base", "crank", "coupler", "rocker", "base")
    for k, x in enumerate((0, 1, 3)):
        builder.joint(f"S{k}", "S", parent=balls[k], child=balls[k + 1], point=[x, 0, 5])
    for k, (x, y) in enumerate(((0, 0), (1, 2), (4, 3), (4, 0))):
        builder.joint(f"R{k}", "R", parent=pins[k], child=pins[k + 1], point=[x, y, 0], axes=[[0, 0, 1]])
    both = analyse_mobility(builder.build())
    assert both.finite.dof == 3 and both.branches is not None
    assert [row.platform for row in both.branches.rows] == [None]


TOUCHING = (
    ([1, 2, -2], [-1, 0, -2], [0, 2, 2], ([0, 0, 1], [1, 0, 0]), [0, 0, 1], ([0, 0, 1], [1, 0, 0])),
    ([-1, -2, 1], [1, 2, 1], [0, -2, 0], ([1, 0, 2], [0, 1, 0]), [1, 2, 0], ([0, 1, 0], [-1, 0, -2])),
    ([-2, 0, -2], [0, -2, -2], [2, 2, -1], ([0, 1, 0], [0, 0, 1]), [0, 1, 0], ([1, 0, 0], [0, 1, 0])),
    ([-2, -1, 1], [-2, -1, -1], [-2, 0, 1], ([0, 0, 1], [0, 1, 0]), [0, 1, 0], ([0, 0, 1], [0, 1, 0])),
)
"""Four UPU limbs: (points of U, P, U, axes of the first, of the slide, of the second). Found at random."""


def test_branches_that_touch_are_told_apart_by_what_moves_on_them() -> None:
    """Their tangent spaces are the same: of the two the table had one, and the other's joints were said to rest.

    By body poses and dot products, continued from random starts, points of both kinds were seen on three spheres.
    """
    builder = MechanismBuilder("touching", platform="platform")
    for name in ("platform", *(f"{side}{k}" for k in range(len(TOUCHING)) for side in ("lower", "upper"))):
        builder.body(name)
    for k, (a, b, c, first, along, second) in enumerate(TOUCHING):
        axes = [[unit(axis) for axis in given] for given in (first, [along], second)]
        bodies = ("base", f"lower{k}", f"upper{k}", "platform")
        for j, (kind, point) in enumerate(zip("UPU", (a, b, c), strict=True)):
            place = {"point": point, "axes": axes[j]}
            builder.joint(f"{kind}{k}{j}", kind, parent=bodies[j], child=bodies[j + 1], **place)
    found = analyse_mobility(builder.build(), body="platform")
    assert (found.dof, found.finite.dof, found.finite.branches) == (3, 2, (2,)) and found.branches is not None
    kinds = {(row.dimension, row.platform.order, row.idle) for row in found.branches.rows if row.platform is not None}
    assert kinds == {(2, 2, ()), (2, 1, ("U20", "U22"))}


def test_a_shaky_branch_is_listed_beside_one_of_its_dimension() -> None:
    """The slider crank about x moves with both hinges about z at rest; or these turn what is between them.

    There slide and hinges keep an instantaneous motion all along, for two of them are at the same height.
    """
    x, z = [1, 0, 0], [0, 0, 1]
    joints = [("R", [0, 0, 0], z), ("P", [0, 0, 0], z), ("R", [1, 0, 0], x), ("R", [0, 1, 0], x), ("R", [0, 0, 2], z),
              ("R", [0, 1, 3], x)]  # fmt: skip
    result = analyse_mobility(loop(*joints))
    assert result.finite.branches == (1,) and result.branches is not None
    rows = result.branches.rows
    assert [(row.dimension, row.platform is None) for row in rows] == [(1, False), (1, True)]
    assert rows[0].idle == ("J1", "J5")
