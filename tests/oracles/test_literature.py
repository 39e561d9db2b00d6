"""Models of mechanisms from the literature: overconstrained, paradoxical, spatial; none is in the catalogue.

The geometry is that of the mobility data; every body gets a mass. All of them take the general path.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
import sympy
from support.model_states import body_states, relative
from support.reference_mechanisms import ENTRIES, build

from symscrew.description.mechanism import Body, Mechanism
from symscrew.model import derive
from symscrew.reference.newton_euler_method import constraint_residuals, newton_euler, numeric

REGULAR = [
    name
    for name, entry in ENTRIES.items()
    if "-" not in name and entry["expected"]["smooth"] and entry["expected"]["dof"] == entry["expected"]["dof_finite"]
    and name not in ("stewart_6ups", "planar_3rrr", "andrews_7body")  # of the catalogue
    and name not in ("delta_4s", "stewart_6sps", "3upu_tsai")  # like an RSSR, whose rod spins, and a 3-RPS
]  # fmt: skip


def with_masses(mechanism: Mechanism) -> Mechanism:
    """Every moving body with a mass near the middle of its joints and unequal principal moments."""
    bodies = {}
    for i, name in enumerate(mechanism.bodies):
        points = [j.point for j in mechanism.joints.values() if name in (j.parent, j.child)]
        middle = [sum(p[k] for p in points) / len(points) for k in range(3)]
        x, y, z = (c + sympy.Rational(k + 1, 10 + i) for k, c in enumerate(middle))
        rows = [[sympy.Rational(1, 4 + j) if j == k else sympy.Integer(0) for k in range(3)] for j in range(3)]
        inertia = (tuple(rows[0]), tuple(rows[1]), tuple(rows[2]))
        mass = sympy.Integer(1 + i % 3)
        bodies[name] = Body(name) if name == mechanism.ground else Body(name, mass, (x, y, z), inertia)  # type: ignore[arg-type]
    return dataclasses.replace(mechanism, bodies=bodies)


@pytest.mark.slow
@pytest.mark.parametrize("name", REGULAR)
def test_model_obeys_its_joints_and_method_b(name: str) -> None:
    expected = ENTRIES[name]["expected"]
    mechanism = with_masses(build(ENTRIES[name]))
    found = derive(mechanism)
    assert len(found.programs["velocity"].inputs[1].labels) == expected["dof"]
    q, v, a = found.system.sample_states
    states = body_states(found, q, v, a)
    numbers = numeric(mechanism)
    for levels in constraint_residuals(numbers, states).values():
        assert max(np.abs(level).max() for level in levels) < 1e-9
    if "assemble" in found.programs:
        _, status = found("assemble", *found.test_inputs["assemble"])
        assert np.all(status == 0)
    # Passive spins with inertia must move as they like; drives are then no function of a prescribed motion.
    if found.system.drives and not expected["internal_freedoms"]:
        drives = newton_euler(numbers, states).drives
        got, status = found("inverse_dynamics", q, v, a)
        assert np.all(status == 0)
        assert relative(got[0], drives) < 1e-9


def test_a_rigid_loop_is_a_structure_with_reactions() -> None:
    """A general 6R loop cannot move: no independent coordinates, reactions from the weights alone."""
    mechanism = with_masses(build(ENTRIES["general_6r"]))
    found = derive(mechanism)
    assert found.programs["velocity"].inputs[1].labels == ()
    zero = np.zeros((1, len(found.system.tree.v)))
    q = found.system.reference[None, :]
    results, status = found("joint_reactions", q, zero, zero)
    assert status[0] == 0
    reactions = results[-1].reshape(-1, 6)
    onto_ground = np.zeros(6)
    for k, joint in enumerate(mechanism.joints.values()):
        sign = 1 if joint.parent == mechanism.ground else -1 if joint.child == mechanism.ground else 0
        onto_ground += sign * reactions[k]
    weight = 9.81 * sum(float(b.mass) for b in mechanism.bodies.values() if b.mass is not None)
    assert onto_ground[:3] == pytest.approx([0, 0, weight], abs=1e-9)


@pytest.mark.parametrize(
    ("name", "singular"),
    [("planar_4bar", False), ("bennett", False), ("collinear_3R", True), ("threebar_parallel_unequal", True)],
)
def test_a_singular_reference_configuration_is_noted(name: str, singular: bool) -> None:
    """Where the closure loses rank in the reference configuration the model says so."""
    notes = derive(with_masses(build(ENTRIES[name]))).notes
    assert any("the reference configuration is singular" in note for note in notes) == singular
