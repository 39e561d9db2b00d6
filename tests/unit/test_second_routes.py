"""What is wrong in a result is found by a route of its own, and what was said is withdrawn."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from symscrew import catalogue
from symscrew.algebra import CONTEXT
from symscrew.mobility import Mobility, analyse_mobility, mobility_text, verified
from symscrew.mobility.second_routes import has_rank, second_routes

CASES = {"bennett": {}, "planar_3rrr": {"limb1_R1": 0.2, "limb2_R1": 0.1}, "panda": {}}
"""One loop without limbs; three limbs, displaced; an open chain in a singular pose."""


@cache
def result(name: str) -> Mobility:
    return analyse_mobility(catalogue.load(name), at=CASES[name])


def failed(found: Mobility) -> set[str]:
    return {claim for claim, holds, _, _ in second_routes(found) if not holds}


def with_cached(found: Mobility, **values: Any) -> Mobility:
    """The result with other values of what is found when it is first looked at."""
    other = replace(found)
    vars(other).update(values)
    return other


def shifted(screw: Any) -> tuple[Any, ...]:
    return (*screw[:5], screw[5] + CONTEXT.mpf("0.1"))


def of_the_platform(found: Mobility) -> Mobility:
    """Another twist, and the wrenches that are reciprocal to it."""
    freedoms = found.platform.freedoms
    basis = (shifted(freedoms.basis[0]), *freedoms.basis[1:])
    return replace(found, platform=replace(found.platform, freedoms=replace(freedoms, basis=basis)))


def that_turns_less(found: Mobility) -> Mobility:
    return replace(found, platform=replace(found.platform, rotations=found.platform.rotations - 1))


def with_a_drive_less(found: Mobility) -> Mobility:
    left = found.first_order.dof_drives_locked or 0
    return replace(found, first_order=replace(found.first_order, dof_drives_locked=left + 1))


def with_another_screw(found: Mobility) -> Mobility:
    name, edge = list(found.network.edges.items())[-1]
    edges = {**found.network.edges, name: replace(edge, screws=(shifted(edge.screws[0]), *edge.screws[1:]))}
    return replace(found, network=replace(found.network, edges=edges))


def of_another_order(found: Mobility) -> Mobility:
    loops = tuple(replace(loop, order=loop.order - 1) for loop in found.counts.loops)
    return with_cached(found, counts=replace(found.counts, loops=loops))


def of_a_larger_group(found: Mobility) -> Mobility:
    loops = tuple(replace(loop, dimension=7) for loop in found.counts.loops)
    return with_cached(found, counts=replace(found.counts, loops=loops))


def with_weaker_limbs(found: Mobility) -> Mobility:
    limbs = tuple(replace(limb, connectivity=limb.connectivity - 1) for limb in found.counts.limbs)
    return with_cached(found, counts=replace(found.counts, limbs=limbs))


def with_larger_branches(found: Mobility) -> Mobility:
    assert found.branches is not None
    rows = tuple(replace(row, dimension=row.dimension + 1) for row in found.branches.rows)
    return with_cached(found, branches=replace(found.branches, rows=rows))


def along_another_direction(found: Mobility) -> Mobility:
    assert found.branches is not None
    rows = tuple(replace(row, tangent=row.tangent + 0.1 * np.eye(*row.tangent.shape)) for row in found.branches.rows)
    return with_cached(found, branches=replace(found.branches, rows=rows))


def at_margins(value: float) -> Callable[[Mobility], Mobility]:
    def changed(found: Mobility) -> Mobility:
        margins = tuple(replace(m, value=value) for m in found.singularities.margins or ())
        return with_cached(found, singularities=replace(found.singularities, margins=margins))

    return changed


WRONG: dict[str, tuple[Callable[[Mobility], Mobility], tuple[str, ...], str]] = {
    "twist": (of_the_platform, ("bennett", "planar_3rrr"), "freedoms of"),
    "type": (that_turns_less, ("bennett", "planar_3rrr", "panda"), "freedoms of"),
    "drives": (with_a_drive_less, ("bennett", "planar_3rrr", "panda"), "freedoms left"),
    "screw": (with_another_screw, ("bennett", "planar_3rrr", "panda"), "screws of all joints"),
    "order": (of_another_order, ("bennett", "planar_3rrr"), "orders"),
    "group": (of_a_larger_group, ("bennett", "planar_3rrr"), "orders"),
    "connectivity": (with_weaker_limbs, ("planar_3rrr", "panda"), "orders"),
    "dimension": (with_larger_branches, ("bennett", "planar_3rrr", "panda"), "branches"),
    "direction": (along_another_direction, ("bennett", "planar_3rrr"), "branches"),
    "margins": (at_margins(0.0), ("bennett", "planar_3rrr"), "margins"),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_right_holds(name: str) -> None:
    assert not failed(result(name)) and len(list(second_routes(result(name)))) >= 6


@pytest.mark.parametrize(("what", "name"), [(what, name) for what, (_, names, _) in WRONG.items() for name in names])
def test_what_is_wrong_is_seen(what: str, name: str) -> None:
    change, _, claim = WRONG[what]
    assert any(text.startswith(claim) for text in failed(change(result(name))))


@pytest.mark.parametrize(("change", "statement"), [(with_larger_branches, "branches"), (at_margins(0.0), "margins")])
def test_what_is_not_confirmed_is_withheld_with_the_reason(
    change: Callable[[Mobility], Mobility], statement: str
) -> None:
    left, checks = verified(change(result("bennett")))
    assert left.withdrawn == {statement} and not all(check.holds for check in checks)
    assert "withheld" in mobility_text(left, full=True)
    assert (left.branches is None) == (statement == "branches")
    assert (left.singularities.margins is None) == (statement == "margins")


@pytest.mark.parametrize(("small", "rank"), [("1e-8", 2), ("1e-12", 2), ("1e-20", 2), ("1e-30", 1)])
def test_a_rank_that_doubles_do_not_tell_is_asked_of_sixty_digits(small: str, rank: int) -> None:
    one, none = CONTEXT.one, CONTEXT.zero
    rows = [[one, none, none], [one, CONTEXT.mpf(small), none]]
    assert [k for k in range(4) if has_rank(rows, k, 3)] == [rank]
