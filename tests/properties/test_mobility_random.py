"""Identities of random mechanisms, and what must not change their ranks: units, rigid motions, order, sense."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy
from support.rewritten import check_reciprocity, moved, permuted, reversed_joints, scaled
from support.samples import some_quickly

from symscrew.description.builder import MechanismBuilder
from symscrew.description.expressions import parse
from symscrew.description.mechanism import Mechanism
from symscrew.mobility.analysis import Mobility, analyse_mobility
from symscrew.mobility.checks import verify

AXES = ("1 0 0", "0 1 0", "0 0 1", "3/5 4/5 0", "2/3 1/3 2/3", "0 5/13 12/13", "1/2 sqrt(3)/2 0")
CHANGES: dict[str, Callable[[list[dict[str, Any]]], list[dict[str, Any]]]] = {
    "km": scaled(sympy.Rational(1, 1000)),
    "mm, moved, in another order and sense": lambda joints: reversed_joints(permuted(scaled(1000)(moved(joints)))),
}


def random_joints(seed: int) -> tuple[list[dict[str, Any]], list[list[str]]]:
    """(joints, names of the joints of each limb) of a platform on two to four random limbs; often overconstrained."""
    random = np.random.default_rng(1000 + seed)
    axes = [[parse(c) for c in AXES[k].split()] for k in random.permutation(len(AXES))[:4]]
    joints: list[dict[str, Any]] = []
    limbs: list[list[str]] = []
    for k in range(int(random.integers(2, 5))):
        letters = random.choice(list("RRRPUCHSE"), size=int(random.integers(1, 5)))
        bodies = ["base", *(f"L{k}b{i}" for i in range(len(letters) - 1)), "platform"]
        limbs.append([f"L{k}_{i}" for i in range(len(letters))])
        for i, letter in enumerate(letters):
            count = {"S": 0, "U": 2}.get(str(letter), 1)
            chosen = [axes[j] for j in random.choice(len(axes), size=count, replace=False)]
            ends = {"parent": bodies[i], "child": bodies[i + 1]}
            joint: dict[str, Any] = {"name": limbs[-1][i], "type": str(letter), **ends}
            joint["point"] = [sympy.Integer(int(c)) for c in random.integers(-2, 3, size=3)]
            if chosen:
                joint["axes"] = chosen
            if letter == "H":
                joint["pitch"] = sympy.Rational(1, 10)
            joints.append(joint)
    return joints, limbs


def build(joints: list[dict[str, Any]], limbs: list[list[str]]) -> Mechanism:
    builder = MechanismBuilder("random", platform="platform")
    for body in dict.fromkeys(b for j in joints for b in (j["parent"], j["child"]) if b != "base"):
        builder.body(body)
    for joint in joints:
        options = {key: value for key, value in joint.items() if key not in ("name", "type")}
        if not options.get("axes"):
            options.pop("axes", None)
        builder.joint(joint["name"], joint["type"], **options)
    for k, names in enumerate(limbs):
        builder.limb(f"limb{k}", joints=names)
    return builder.build()


def ranks(found: Mobility) -> tuple[Any, ...]:
    assert found.constraints is not None
    limbs = sorted((limb.name, len(limb.constraints.basis)) for limb in found.limbs)
    return (
        found.kutzbach, found.dof, found.overconstraints, found.internal_freedoms, found.platform.type,
        found.constraints.rank, limbs, found.finite.smooth, found.finite.branches,
    )  # fmt: skip


@pytest.mark.parametrize("seed", some_quickly(range(8), every=4))
def test_identities_and_invariance(seed: int) -> None:
    joints, limbs = random_joints(seed)
    found = analyse_mobility(build(joints, limbs))
    check_reciprocity(found)
    assert found.decisions.exact
    assert found.kutzbach + found.overconstraints == found.dof
    assert found.constraints is not None and found.constraints.rank + found.platform.dof == 6
    assert [check.claim for check in verify(found) if not check.holds] == []
    expected = ranks(found)
    for name, change in CHANGES.items():
        again = analyse_mobility(build(change(joints), limbs))
        assert ranks(again) == expected and again.decisions.exact, name


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("limb_order", [slice(None, None, -1)])
def test_order_of_limbs(seed: int, limb_order: slice) -> None:
    joints, limbs = random_joints(seed)
    found, again = (analyse_mobility(build(joints, order)) for order in (limbs, limbs[limb_order]))
    assert found.platform.type == again.platform.type
    assert sorted(len(limb.constraints.basis) for limb in found.limbs) == sorted(
        len(limb.constraints.basis) for limb in again.limbs
    )
