"""Mobility with couplings of coordinates: verdicts by hand, proved by the checker, and what it must refuse."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import numpy as np
import pytest

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.mobility import Mobility, analyse_mobility, check_proof, mobility_proof, mobility_text, verify
from symscrew.mobility.analysis import as_meant
from symscrew.mobility.proofs import proof_checker

PLACES = {"A": (0, 0, 0), "B": (0, 1, 0), "C": (1.5, 1.5, 0), "D": (2.5, 1, 0), "E": (2, 0, 0)}
TURN = np.array([[2, -2, 1], [1, 2, 2], [-2, -1, 2]]) / 3
"""A rotation that is no double: as typed, the axes are units of 15 digits."""


def five_bar(*couplings: dict[str, object], turned: bool = False, off: str = "0") -> Mechanism:
    """Joints A to E about z, loop A B C D E: two freedoms, of which a pair of gears takes one."""
    builder, bodies = MechanismBuilder("geared", platform="c2"), ["base", "c1", "c2", "c3", "c4", "base"]
    for body in bodies[1:-1]:
        builder.body(body)
    turn, leaning = TURN if turned else np.eye(3), [off, 0, f"sqrt(1-({off})**2)"]
    for k, (name, place) in enumerate(PLACES.items()):
        point, axis = ((turn @ v).tolist() for v in (np.array(place), np.array([0.0, 0.0, 1.0])))
        builder.joint(name, "R", parent=bodies[k], child=bodies[k + 1], point=point,
                      axes=[leaning if name == "C" and off != "0" else axis])  # fmt: skip
    for k, terms in enumerate(couplings):
        builder.coupling(f"gears{k}", terms=terms)
    return builder.build()


def open_chain(*couplings: dict[str, object]) -> Mechanism:
    """A slider on a shaft, beside a screw on another shaft whose axis has the length 0.6, 0.8."""
    builder = MechanismBuilder("open", platform="d")
    for body in "abcd":
        builder.body(body)
    builder.joint("A", "R", parent="base", child="a", point=[0, 0, 0], axes=[[0, 0, 1]], reference=["0.3"])
    builder.joint("B", "P", parent="a", child="b", point=[0, 0, 0], axes=[[1, 0, 0]])
    builder.joint("C", "R", parent="base", child="c", point=[1, 0, 0], axes=[[0, "0.6", "0.8"]])
    builder.joint("D", "H", parent="c", child="d", point=[1, 1, 0], axes=[[0, 1, 0]], pitch="0.01")
    for k, terms in enumerate(couplings):
        builder.coupling(f"tie{k}", terms=terms)
    return builder.build()


GEARS: dict[str, object] = {"A": 1, "E": 1}
CASES: dict[str, tuple[Any, tuple[int, int, int, tuple[int, ...] | None], list[str]]] = {
    "gears": (lambda: five_bar(GEARS), (1, -2, 1, None), ["tied"]),
    "gears, turned": (lambda: five_bar(GEARS, turned=True), (1, -2, 1, None), ["tied"]),
    "bent": (lambda: five_bar({"A": [1, "0.5"], "E": ["0.3", 0, "0.1"]}), (1, -2, 1, None), ["tied"]),
    "two pairs": (lambda: five_bar(GEARS, {"B": 1, "D": 2}), (0, -3, 0, None), ["none"]),
    "one pair twice": (lambda: five_bar(GEARS, {"A": 2, "E": 2}), (1, -3, 1, None), ["tied"]),
    # A + A^2 + E + E^2 = 0 and A + A^2 + E + 2 E^2 = 0: E^2 = 0
    "tangent": (lambda: five_bar({"A": [1, 1], "E": [1, 1]}, {"A": [1, 1], "E": [1, 2]}), (1, -3, 0, ()), ["stopped"]),
    "ring of gears": (lambda: open_chain({"A": 1, "B": 1}, {"B": 1, "C": -1}, {"C": 1, "A": 1}), (2, 1, 2, None),
                      ["tied"]),
    "frozen ring": (lambda: open_chain({"A": 1, "B": 1}, {"B": 1, "C": 1}, {"C": 1, "A": 1}), (1, 1, 1, None),
                    ["none"]),
    "two trains": (lambda: open_chain({"A": 1, "B": "0.5"}, {"C": 1, "D": [1, "0.2"]}), (2, 2, 2, None),
                   ["tied", "tied"]),
    # about A = 0.3 the slope of A + A^2 is 1.6
    "isolated but for D": (lambda: open_chain({"A": [1, 1], "B": ["1.6", 1], "C": ["0.1", 1]},
                                              {"A": "1.6", "B": "1.6", "C": "0.1"}), (3, 2, 1, (1,)), ["form"]),
    "cone": (lambda: open_chain({"A": [1, 1], "B": ["1.6", 1], "C": ["0.1", -9]},
                                {"A": "1.6", "B": "1.6", "C": "0.1"}), (3, 2, 2, (2,)), ["form"]),
}  # fmt: skip


@cache
def found(name: str) -> Mobility:
    return analyse_mobility(CASES[name][0]())


@cache
def text(name: str) -> str:
    return json.dumps(mobility_proof(found(name)))


@pytest.mark.parametrize("name", CASES)
def test_verdicts_by_hand_are_proved(name: str) -> None:
    result, values = found(name), json.loads(text(name))
    dof, kutzbach, finite, branches = CASES[name][1]
    assert (result.dof, result.kutzbach, result.finite.dof, result.finite.branches) == (dof, kutzbach, finite, branches)
    assert result.finite.proved and [check for check in verify(result) if not check.holds] == []
    assert [block["proof"]["kind"] for block in values["blocks"]] == CASES[name][2]
    verdict = check_proof(values)
    assert verdict.holds and not verdict.not_proved and len(verdict.proved) > 9
    counts = result.counts
    assert counts.mobility == counts.modified == dof and counts.kutzbach == kutzbach
    assert counts.overconstraint == result.overconstraints == dof - kutzbach
    table = result.branches
    assert table is not None and all(row.dimension in (branches or (finite,)) for row in table.rows)


@pytest.mark.parametrize(
    ("name", "change", "refused"),
    [
        ("gears", lambda ties: ties.pop(), "instantaneous mobility 1"),
        ("two trains", lambda ties: ties.pop(), "finite mobility 2"),
        ("one pair twice", lambda ties: ties[1]["terms"][0].update(coefficients=["3"]), "finite mobility 1"),
        ("one pair twice", lambda ties: ties[1]["terms"][0].update(coefficients=["2", "1"]), "finite mobility 1"),
        ("tangent", lambda ties: ties[1]["terms"][1].update(coefficients=["1", "1"]), "finite mobility 0"),
        ("cone", lambda ties: ties[0]["terms"][2].update(coefficients=["1/10", "1"]), "finite mobility 2"),
        ("cone", lambda ties: ties[0]["terms"][0].update(at="0"), "finite mobility 2"),
    ],
)
def test_another_coupling_is_refused(name: str, change: Any, refused: str) -> None:
    values = json.loads(text(name))
    change(values["mechanism"]["couplings"])
    assert not check_proof(values).holds  # by the digest
    values["digest"] = proof_checker.digest(values["mechanism"])
    verdict = check_proof(values)
    assert any(line.startswith(refused) for line in verdict.refused), verdict


def test_a_coupled_axis_has_the_length_one() -> None:
    """A coordinate along an axis of another length is another one: the ratio of gears would be another."""
    values = json.loads(text("gears"))
    values["mechanism"]["joints"][0]["motions"][0]["axis"] = ["0", "0", "2"]
    values["digest"] = proof_checker.digest(values["mechanism"])
    assert any("a coupled axis that has not the length 1" in line for line in check_proof(values).refused)


def test_a_checker_without_couplings_does_not_judge_them() -> None:
    values = json.loads(text("gears"))
    assert values["format"] == proof_checker.COUPLED != proof_checker.FORMAT
    with pytest.raises(proof_checker.UnreadableError, match="expected the format"):
        check_proof({**values, "format": proof_checker.FORMAT})


def test_what_is_said_counts_the_couplings() -> None:
    words = mobility_text(found("ring of gears"))
    assert "1 of the 3 equations of loops and couplings follow from the others" in words
    assert "The reactions of tie0, tie1, tie2 are not unique" in words and "leave this coupling out" in words
    assert "sum f - p = 6 (5 - 4 - 1) + 4 - 3 = 1, with p = 3 couplings" in words
    assert "1: dimension 2 (proved)" in mobility_text(found("cone"))


@pytest.mark.parametrize("off", ["1e-12", "1e-7"])
def test_gears_on_axes_that_are_almost_parallel(off: str) -> None:
    """As typed the loop is shaky and the gears hold it; with parallel axes, so much away, it moves."""
    result = analyse_mobility(five_bar(GEARS, off=off))
    assert (result.dof, result.finite.dof) == (1, 0) or result.finite.dof is None
    assert result.near is not None and float(off) / 2 < result.near.distance < 2 * float(off)
    meant = as_meant(result, 1e-6)
    assert (meant.dof, meant.finite.dof, meant.finite.smooth, meant.taken is not None) == (1, 1, True, True)
    assert found("gears").near is None


def test_transcendental_ratios_are_said_to_be_open() -> None:
    result = analyse_mobility(five_bar({"A": "pi", "E": 1}))
    assert (result.finite.dof, result.finite.proved) == (1, False)
    verdict = check_proof(json.loads(json.dumps(mobility_proof(result))))
    assert verdict.holds and any("finite mobility at most" in line for line in verdict.proved)
    assert any(line.startswith("finite mobility 1: pi is not") for line in verdict.not_proved)


def test_special_geometry_to_which_a_coupling_leaves_less_is_not_what_was_meant() -> None:
    """A parallelogram with gears on its pins, typed to 17 digits in the plane and to 45 across it."""
    builder, bodies = MechanismBuilder("geared", platform="c2"), ["base", "c1", "c2", "c3", "base"]
    for body in bodies[1:-1]:
        builder.body(body)
    places = {"A": ["0", "0"], "B": ["0.3", "1"], "C": ["1.5", "1"], "D": ["1.19999999999999995", "0"]}
    for k, (name, place) in enumerate(places.items()):
        axis = ["1e-45", 0, "sqrt(1-1e-90)"] if name == "C" else [0, 0, 1]
        builder.joint(name, "R", parent=bodies[k], child=bodies[k + 1], point=[*place, 0], axes=[axis])
    found = analyse_mobility(builder.coupling("gears", terms={"A": 1, "D": 1}).build())
    assert (found.dof, found.finite.dof) == (1, None)
    assert found.near is None or found.near.meant.dof == 1


def two_flat_parallelograms(ratio: int) -> Mechanism:
    """Both with all hinges in a line, and one crank of each geared to the other's."""
    builder = MechanismBuilder("two", platform="a")
    for body in "abcdef":
        builder.body(body)
    for letter, links, (crank, width), y in (("R", "abc", (1, 3), 0), ("Q", "def", (2, 3), 5)):
        ends = ["base", *links, "base"]
        for k, x in enumerate((0, crank, crank + width, width)):
            builder.joint(f"{letter}{k}", "R", parent=ends[k], child=ends[k + 1], point=[x, y, 0], axes=[[0, 0, 1]])
    builder.coupling("gears", terms={"R0": 1, "Q0": ratio})
    return builder.build()


@pytest.mark.parametrize("ratio", [-1, 2])
def test_geared_linkages_at_change_points_have_the_branches_of_both(ratio: int) -> None:
    """Each is a parallelogram or an antiparallelogram, whatever the other is: four curves through the configuration."""
    found = analyse_mobility(two_flat_parallelograms(ratio))
    assert (found.dof, found.finite.dof, found.finite.branches, found.finite.judgement) == (3, 1, (1,), "sampled")
    assert found.branches is not None and [row.dimension for row in found.branches.rows] == [1] * 4
    assert [check.claim for check in verify(found) if not check.holds] == []
    ways = set()
    for row in found.branches.rows:
        turns = {name: float(row.tangent[0][edge.start]) for name, edge in found.network.edges.items()}
        assert turns["R0"] == pytest.approx(-ratio * turns["Q0"], rel=1e-3)
        ways.add((turns["R3"] / turns["R0"] < 0, turns["Q3"] / turns["Q0"] < 0))
    assert len(ways) == 4


def test_couplings_that_bend_against_each_other_meet_in_two_lines() -> None:
    """A + B + C = 0 and A + A^2 + B - 4 B^2 + C = 0: A = 2 B or A = -2 B."""
    builder = MechanismBuilder("shafts", platform="a")
    for k, body in enumerate("abc"):
        builder.body(body)
        builder.joint(body.upper(), "R", parent="base", child=body, point=[k, 0, 0], axes=[[0, 0, 1]])
    builder.coupling("sum", terms={"A": 1, "B": 1, "C": 1})
    builder.coupling("bent", terms={"A": [1, 1], "B": [1, -4], "C": 1})
    found = analyse_mobility(builder.build())
    assert (found.dof, found.finite.branches, found.finite.judgement) == (2, (1,), "proved")
    assert found.branches is not None
    ratios = [float(row.tangent[0][0] / row.tangent[0][1]) for row in found.branches.rows]
    assert sorted(ratios) == pytest.approx([-2, 2], rel=1e-3)
