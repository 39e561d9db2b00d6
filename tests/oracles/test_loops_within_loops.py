"""Loops that are rigid, or overconstrained, inside of larger ones that move: what is proved of them is said so."""

from __future__ import annotations

import copy
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from support.reference_mechanisms import ENTRIES, build
from sympy import Rational as Q

from symscrew.description.builder import MechanismBuilder
from symscrew.mobility import Mobility, analyse_mobility, mobility_text, mobility_values, write_proof
from symscrew.mobility.proofs.proof_checker import Block, RefusedError

CHAIN = (
    ([1, 0, 0], [0, 0, 1]), ([2, 1, 0], [1, 0, 0]), ([1, 3, 1], [0, Q(3, 5), Q(4, 5)]),
    ([0, 2, 3], [Q(3, 5), Q(4, 5), 0]), ([-1, 2, 2], [0, 1, 0]), ([-2, 1, 1], [Q(2, 3), Q(2, 3), Q(1, 3)]),
    ([-1, -1, 2], [Q(1, 3), -Q(2, 3), Q(2, 3)]),
)  # fmt: skip
"""Seven hinges in general position."""


@cache
def bennett_and_chain(shift: Any = 0, hinges: int = 7) -> Mobility:
    """A Bennett linkage, one hinge of it displaced along x, whose coupler hangs in a second loop on general hinges."""
    given = build(ENTRIES["bennett"])
    builder = MechanismBuilder("two_loops", ground=given.ground)
    for body in given.bodies:
        if body != given.ground:
            builder.body(body)
    for k, joint in enumerate(given.joints.values()):
        x, y, z = (given.number(c) for c in joint.point)
        axis = [given.number(c) for c in joint.axes[0]]
        builder.joint(joint.name, "R", parent=joint.parent, child=joint.child, axes=[axis],
                      point=[x + (shift if k == 2 else 0), y, z])  # fmt: skip
    near = {b for j in given.joints.values() for b in (j.parent, j.child) if given.ground in (j.parent, j.child)}
    before = next(body for body in given.bodies if body not in near)
    for k, (point, axis) in enumerate(CHAIN[:hinges]):
        if k < hinges - 1:
            builder.body(f"k{k}")
            builder.joint(f"K{k}", "R", parent=before, child=f"k{k}", point=point, axes=[axis])
            before = f"k{k}"
        else:
            builder.joint(f"K{k}", "R", parent=given.ground, child=before, point=point, axes=[axis])
    return analyse_mobility(builder.build())


def kinds(found: Mobility) -> list[str]:
    return [entry["proof"]["kind"] for entry in found.evidence[1]["blocks"]]


@pytest.mark.parametrize(
    "shift, dof, kind, resting",
    [
        (0, 2, "nested", ()),  # the linkage moves, and the other loop follows
        (Q(1, 1000), 1, "rigid", ("J1", "J2", "J3", "J4")),
        (Q(1, 10**10), 1, "rigid", ("J1", "J2", "J3", "J4")),  # doubles do not tell this from the linkage
    ],
)
def test_a_bennett_linkage_in_a_larger_loop_is_proved(
    shift: Any, dof: int, kind: str, resting: tuple[str, ...], tmp_path: Path
) -> None:
    found = bennett_and_chain(shift)
    assert (found.finite.dof, found.finite.smooth, found.finite.proved, kinds(found)) == (dof, True, True, [kind])
    assert found.branches is not None and [row.dimension for row in found.branches.rows] == [dof]
    assert set(resting) <= set(found.branches.rows[0].idle)
    assert tuple(mobility_values(found)["joints_at_rest_proved"]) == resting
    assert ("At rest near the configuration, proved: J1, J2, J3, J4" in mobility_text(found, full=True)) == bool(
        resting
    )
    verdict = write_proof(found, tmp_path / "proof.json")
    assert verdict.holds and f"finite mobility {dof}" in verdict.proved
    assert any(claim.startswith("joints at rest") for claim in verdict.proved) == bool(resting)


def test_near_the_linkage_both_verdicts_are_given() -> None:
    found = bennett_and_chain(Q(1, 10**10))
    assert found.near is not None and found.near.meant.finite.dof == 2 and found.near.distance < 1e-10


def test_a_loop_that_is_alone_in_a_triangle_is_rigid() -> None:
    """A triangle of bars as coupler of a four-bar."""
    builder = MechanismBuilder("truss", platform="c1")
    for body in ("crank", "rocker", "c1", "c2", "c3"):
        builder.body(body)
    for name, parent, child, point in (
        ("A", "base", "crank", [0, 0, 0]), ("D", "base", "rocker", [4, 0, 0]), ("B", "crank", "c1", [0, 2, 0]),
        ("C", "rocker", "c1", [3, 3, 0]), ("T1", "c1", "c2", [0, 2, 0]), ("T2", "c1", "c3", [3, 3, 0]),
        ("T3", "c2", "c3", [1, 5, 0]),
    ):  # fmt: skip
        builder.joint(name, "R", parent=parent, child=child, point=point, axes=[[0, 0, 1]])
    found = analyse_mobility(builder.build())
    assert "At rest near the configuration, proved: T1, T2, T3" in mobility_text(found, full=True)


def _taken(found: Mobility, change: Callable[[dict[str, Any]], None]) -> None:
    numbers, evidence = found.evidence
    entry = copy.deepcopy(evidence["blocks"][0])
    change(entry["proof"])
    assert Block(numbers.read, ("block", "0"), entry).dimensions


def _set(proof: dict[str, Any], name: str, value: Any) -> None:
    proof[name] = value


@pytest.mark.parametrize(
    "shift, change, why",
    [
        # four hinges of the other loop make none, and would be free
        (Q(1, 1000), lambda p: p["rigid"][0].update(joints=["K0", "K1", "K2", "K3"]), "minor|not shown"),
        (Q(1, 1000), lambda p: p["rigid"][0].update(joints=["J1", "J2", "J3"]), "minor|not shown"),
        (Q(1, 1000), lambda p: p["rigid"][0]["minor"].update(rows=[0], columns=[0]), "minor|not shown"),
        (Q(1, 1000), lambda p: p["rigid"][0].update(joints=["J1", "J1", "J2", "J3"]), "twice"),
        (0, lambda p: p["parts"][0].update(proof={"kind": "none"}), "not smooth"),
        (0, lambda p: _set(p, "parts", []), "missing"),
        (0, lambda p: p.update(joints=[*p["joints"], *(f"K{k}" for k in range(7))]), "another length"),
    ],
)  # fmt: skip
def test_evidence_that_is_changed_is_refused(shift: Any, change: Callable[[dict[str, Any]], None], why: str) -> None:
    _taken(bennett_and_chain(shift), lambda proof: None)
    with pytest.raises((RefusedError, ValueError, IndexError), match=why):
        _taken(bennett_and_chain(shift), change)
