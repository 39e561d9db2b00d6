"""Closure as polynomials against motion by exponentials: they vanish at real configurations, and only there."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from support.further_mechanisms import CASES
from support.marks import slow
from support.parallel_mechanisms import four_ruu, snu
from support.reference_mechanisms import ENTRIES, build

from symscrew.description.mechanism import Mechanism
from symscrew.mobility.components import ConfigurationSpace, Part, space_lines, space_values
from symscrew.mobility.components.algebraic_closure import closure_equations
from symscrew.mobility.components.closure_parts import ClosureEquations, NotAlgebraicError, _settled
from symscrew.mobility.components.exact_parts import _read
from symscrew.mobility.components.limb_equations import null_space
from symscrew.mobility.components.polynomials import Polynomial
from symscrew.mobility.components.real_configurations import (
    real_configurations,
    resting_angles,
    variables_at,
)
from symscrew.mobility.joint_network import Network, network_of

OTHERS = {"snu": snu, "four_ruu": four_ruu}
EXACT = 1e-11  # of the largest term


def mechanism(name: str) -> Mechanism:
    return OTHERS[name]() if name in OTHERS else build(ENTRIES[name]) if name in ENTRIES else CASES[name].make()


@cache
def closure_of(name: str) -> tuple[Network, ClosureEquations]:
    made = mechanism(name)
    network = network_of(made)
    return network, closure_equations(made, network)


def residual(polynomial: Polynomial, values: np.ndarray) -> np.ndarray:
    terms = np.array([c * np.prod(values ** np.array(key), axis=1) for key, c in polynomial.floats().items()])
    return np.asarray(np.abs(terms.sum(axis=0)) / np.maximum(1.0, np.abs(terms).max(axis=0)))


@pytest.mark.parametrize(
    "name, variables",
    [
        ("slider_crank", 5), ("oldham", 4), ("bennett", 8), ("sarrus", 10), ("bricard_box", 10), ("tripteron_cpm", 8),
        slow("andrews_7body", 14), slow("schatz_turbula", 10), slow("3rps", 8), slow("snu", 8), slow("four_ruu", 12),
        ("miura folded", 4), slow("delta_4s", 11),  # several bodies that join three joints or more
    ],
)  # fmt: skip
def test_equations_vanish_at_configurations_and_not_beside_them(name: str, variables: int) -> None:
    network, closure = closure_of(name)
    assert len(closure.variables) == variables and not any(p.at(closure.reference) for p in closure.equations)
    found = real_configurations(network)
    values = variables_at(closure, network, found)
    assert values is not None and len(values) > 10
    assert max(residual(p, values).max() for p in closure.equations) < EXACT
    beside = variables_at(closure, network, found + 0.1 * np.random.default_rng(1).normal(size=found.shape))
    assert beside is not None  # poses along the tree: loops are open there
    assert min(np.max([residual(p, beside) for p in closure.equations], axis=0)) > 1e-6


@pytest.mark.parametrize(
    "name, reason",
    [("delassus_4h", "screw joint"), ("serial_6r_wrist", "no loops")],
)
def test_what_has_no_such_equations_is_said(name: str, reason: str) -> None:
    with pytest.raises(NotAlgebraicError, match=reason):
        closure_equations(mechanism(name), network_of(mechanism(name)))


@pytest.mark.parametrize("name", ["sarrus", "bricard_box", slow("double_hooke"), slow("schatz_turbula")])
def test_variables_have_no_value_at_the_angles_named_and_nowhere_else(name: str) -> None:
    """The tangent of half an angle changes its sign there through infinity: beside it it is as large as it is near."""
    network, closure = closure_of(name)
    angles = resting_angles(closure, network)
    assert len(angles) == len([n for n in closure.variables if n.startswith("t")]) > 0
    for place, (joint, angle) in enumerate(angles):
        near = np.zeros((2, len(network.screws)))
        near[:, network.edges[joint].start] = angle + 1e-6, angle - 1e-6
        values = variables_at(closure, network, near)
        assert values is not None and np.abs(values[:, place]).min() > 1e5 and np.prod(np.sign(values[:, place])) < 0


@pytest.mark.parametrize(
    "name, settles, tangents",
    [
        ("slider_crank", True, 0), ("bennett", True, 0), ("sarrus", True, 2), ("tripteron_cpm", False, 0),
        slow("3rps", False, 0), slow("four_ruu", False, 4),
    ],
)  # fmt: skip
def test_what_the_components_leave_open_is_said(name: str, settles: bool, tangents: int) -> None:
    """Limbs of three and more freedoms after the pose, and joints with a chart, are the limits of what is proved."""
    network, closure = closure_of(name)
    angles = resting_angles(closure, network)
    assert (closure.settles, len(angles)) == (settles, tangents)
    part = Part(1, 1, ("x0",), True, True)
    found = ConfigurationSpace("pose", closure.variables, "Q", (part,), "", 5, (5,), angles, closure.settles)
    head, *lines = space_lines(found)
    values = space_values(found)
    assert ("all of them" in head) == (not tangents) and all(f"{j} at {a:.6g} rad" in head for j, a in angles)
    assert any("beyond a limb's reach" in line for line in lines) != settles == values["all_joints_settled"]
    assert [(v["joint"], v["angle"]) for v in values["all_but_with_a_joint_held_at"]] == list(angles)


def test_a_component_within_a_part_that_is_not_divided_is_none_of_its_own() -> None:
    """The time ended before the second part was divided: what the first one's component is within is said once."""
    closure = closure_of("bennett")[1]
    head = "@part {} 4 2 1 1 {}\nv1\n@shown\n"
    printed = head.format(1, 0) + head.format(2, 0) + "@pieces\n" + head.format(1, 1)
    divided = "@divided 1\n"
    for inside, kinds in (("", [False, True]), ("@inside 1 2\n", [False]), ("@inside 1 1\n", [False, True])):
        found = _read(closure, printed + inside + divided, ended=False, seconds=1.0)
        assert found.complete and sorted(part.irreducible for part in found.parts) == kinds
    both = _read(closure, printed + "@inside 1 2\n" + divided + "@divided 2\n@local 1 3\n@end", ended=True, seconds=1.0)
    assert [(part.irreducible, part.multiplicity) for part in both.parts] == [(True, 3)]


def test_two_hinges_on_one_line_are_not_settled_by_the_pose() -> None:
    z, beside = [Fraction(c) for c in (0, 0, 1, 0, 0, 0)], [Fraction(c) for c in (0, 0, 1, 0, -1, 0)]
    assert _settled([z, beside]) and _settled([z]) and not _settled([z, [2 * c for c in z]])
    assert not _settled([z, beside, beside])


@pytest.mark.parametrize("seed", range(3))
def test_null_spaces_of_sparse_rows(seed: int) -> None:
    random = np.random.default_rng(seed)
    rows = random.integers(-3, 4, size=(5, 9)) * (random.random((5, 9)) < 0.5)
    rows[4] = rows[0] + 2 * rows[1]
    sparse = [{j: Fraction(int(c)) for j, c in enumerate(row) if c} for row in rows]
    found = null_space(sparse, 9)
    assert len(found) == 9 - np.linalg.matrix_rank(rows)
    for vector in found:
        assert all(sum(row.get(j, 0) * c for j, c in vector.items()) == 0 for row in sparse)
