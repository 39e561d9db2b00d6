"""Mobility against the reference data, and what must not change it: units, motions, order, sense of joints."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy
from support.analysed import analysed, of_catalogue
from support.marks import slow
from support.reference_mechanisms import ENTRIES, build
from support.rewritten import check_reciprocity, four_bar_with, moved, permuted, reversed_joints, scaled

from symscrew import catalogue
from symscrew.algebra.operations import CONTEXT
from symscrew.description.builder import MechanismBuilder
from symscrew.mobility.analysis import Mobility, analyse_mobility

SLOW = {"delta_4s-parallel_forearms"}
WRITTEN = {
    "rigid motion": (moved, "bennett", "planar_3rrr-type1", "rssr", "delassus_4h", "sarrus-flat_folded"),
    "mm": (scaled(1000), "3upu_tsai", "schatz_turbula", "oldham", "3upu_tsai-constraint_sing_cylinder"),
    "km": (scaled(sympy.Rational(1, 1000)), "bennett", "threebar_parallel_unequal", "tricept", "double_watt_cusp"),
    "order": (permuted, "3upu_tsai", "slider_crank", "rssr", "sarrus-flat_folded"),
    "sense": (reversed_joints, "bennett", "delassus_4h", "planar_3rrr-type1", "3upu_tsai-constraint_sing_cylinder"),
}
"""Way to write a mechanism -> some planar, spatial, overconstrained and singular ones; each of twelve once or more."""


def facts(found: Mobility) -> dict[str, Any]:
    finite = found.finite
    return {
        "kutzbach": found.kutzbach,
        "dof": found.dof,
        "dof_finite": finite.dof,
        "smooth": finite.smooth,
        "branches": None if finite.branches is None else list(finite.branches),
        "overconstraints": found.overconstraints,
        "internal_freedoms": found.internal_freedoms,
        "dof_drives_locked": found.dof_drives_locked,
        "platform": (found.platform.dof, found.platform.type),
    }


def expected(entry: dict[str, Any]) -> dict[str, Any]:
    values = {key: entry["expected"][key] for key in facts_keys()}
    platform = entry["expected"]["platform"]
    return {**values, "platform": (platform["dof"], platform["type"])}


def facts_keys() -> tuple[str, ...]:
    return (
        "kutzbach", "dof", "dof_finite", "smooth", "branches", "overconstraints", "internal_freedoms",
        "dof_drives_locked",
    )  # fmt: skip


@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.slow if n in SLOW else ()) for n in ENTRIES])
def test_reference(name: str) -> None:
    entry, found = ENTRIES[name], analysed(name)
    assert facts(found) == expected(entry)
    assert found.kutzbach + found.overconstraints == found.dof
    check_reciprocity(found)
    check_freedoms(found, entry["expected"]["platform"].get("freedoms"))


def check_freedoms(found: Mobility, given: list[list[str]] | None) -> None:
    """The reference freedoms, where given, span the same space."""
    if given is None:
        return
    from symscrew.description.expressions import parse

    wanted = np.array([[float(parse(c)) for c in twist] for twist in given]).reshape(-1, 6)
    ours = np.array([[float(c) for c in twist] for twist in found.platform.freedoms.basis]).reshape(-1, 6)
    assert len(wanted) == len(ours)
    if len(ours):
        wanted /= np.linalg.norm(wanted, axis=1)[:, None]
        values = np.linalg.svd(np.concatenate([ours, wanted]), compute_uv=False)
        assert (values > 1e-9 * values[0]).sum() == len(ours)


@pytest.mark.parametrize(
    ("way", "name"),
    [
        (way, name) if name in ("bennett", "3upu_tsai") else slow(way, name)
        for way, (_, *names) in WRITTEN.items()
        for name in names
    ],
)
def test_nothing_depends_on_how_it_is_written(way: str, name: str) -> None:
    entry = ENTRIES[name]
    assert facts(analyse_mobility(build(entry, WRITTEN[way][0]))) == expected(entry)


def test_axes_almost_parallel_are_not_parallel() -> None:
    """An axis that is 1e-12 off, given by 40 digits: the four-bar is rigid, and the gap says how nearly it moves."""
    off = "0.0000000000010000000000000000000000000000"
    cosine = "0.9999999999999999999999995000000000000000"
    assert four_bar_with(["0", "0", "1"]).dof == 1
    found = four_bar_with([off, "0", cosine])
    assert found.dof == 0 and found.finite.smooth
    assert found.first_order.closure.smallest_pivot < 1e-11
    squared = "0.000000000000000000000001000000000000000000000000"
    assert four_bar_with([squared, "0", "1"]).dof == 0


def random_limbs(generator: np.random.Generator) -> Mobility:
    """A platform on two to four limbs of random joints with rational axes."""
    axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1], ["3/5", "4/5", 0], ["2/3", "1/3", "2/3"], [0, "5/13", "12/13"]]
    builder = MechanismBuilder("random", platform="platform").body("platform")
    for k in range(int(generator.integers(2, 5))):
        letters = "".join(generator.choice(list("RRPUSCH"), size=generator.integers(1, 5)))
        names = [f"L{k}_{i}" for i in range(len(letters))]
        bodies = ["base", *(f"L{k}_b{i}" for i in range(len(letters) - 1)), "platform"]
        for i, letter in enumerate(letters):
            if i:
                builder.body(bodies[i])
            count = {"S": 0, "U": 2}.get(letter, 1)
            chosen = [axes[j] for j in generator.choice(len(axes), size=count, replace=False)]
            options = {"axes": chosen} if count else {}
            if letter == "H":
                options["pitch"] = "1/10"
            point = [int(c) for c in generator.integers(-3, 4, size=3)]
            builder.joint(names[i], letter, parent=bodies[i], child=bodies[i + 1], point=point, **options)
        builder.limb(f"L{k}", joints=names)
    return analyse_mobility(builder.build())


@pytest.mark.parametrize("seed", range(12))
def test_identities_of_random_mechanisms(seed: int) -> None:
    found = random_limbs(np.random.default_rng(seed))
    check_reciprocity(found)
    assert found.kutzbach + found.overconstraints == found.dof
    assert found.constraints is not None
    assert found.constraints.rank + found.platform.dof == 6
    assert found.finite.dof is not None and found.finite.dof <= found.dof
    assert found.internal_freedoms >= 0


@pytest.mark.parametrize("name", catalogue.names())
def test_catalogue(name: str) -> None:
    found = of_catalogue(name)
    check_reciprocity(found)
    assert found.finite.smooth and found.finite.dof == found.dof


def test_freedoms_of_any_body() -> None:
    found = analyse_mobility(build(ENTRIES["rssr"]), body="crank" if "crank" in ENTRIES["rssr"]["bodies"] else None)
    assert found.platform.dof == 1 and found.platform.type == "1R"
    assert float(CONTEXT.norm(found.platform.freedoms.basis[0])) > 0
