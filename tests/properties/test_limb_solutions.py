"""Closed forms of limbs beyond the catalogue's: PRS, RPS, RRS, RRR and UPU platforms built by the API."""

from __future__ import annotations

import numpy as np
import pytest
from support.limb_platforms import LIMBS, platform

from symscrew.effects.gravity import Gravity
from symscrew.kinematics.tree import spanning_tree
from symscrew.model import Model, derive
from symscrew.optimisation.motion_equations import PointEquations
from symscrew.program import OUT_OF_REACH
from symscrew.program.numpy_evaluation import evaluate


@pytest.fixture(scope="module", params=sorted(LIMBS))
def found(request: pytest.FixtureRequest) -> Model:
    return derive(platform(request.param))


def test_platform_hangs_on_a_joint_of_its_own(found: Model) -> None:
    tree = spanning_tree(found.mechanism)
    assert tree.virtual == "top_pose"
    assert {j.type for j in tree.cut} == {"S"}


def test_inverse_kinematics_finds_the_sampled_configuration(found: Model) -> None:
    q, v, a = found.system.sample_states
    pose, rate, gain = found.test_inputs["inverse_dynamics_platform"]
    (got,), status = found("inverse_kinematics", pose)
    assert np.all(status == 0)
    assert np.abs(got - q).max() < 1e-12
    (drives,), status = found("inverse_dynamics", q, v, a)
    (direct,), platform_status = found("inverse_dynamics_platform", pose, rate, gain)
    assert np.all(status == 0) and np.all(platform_status == 0)
    assert np.abs(direct - drives).max() < 1e-9 * np.abs(drives).max()


def test_the_drives_of_a_pose_are_those_of_its_configuration(found: Model) -> None:
    """In the order of u, by the function that measures displacements of all joints, tree or not."""
    (pose,) = found.test_inputs["inverse_kinematics"]
    program = found.programs["drive_positions"]
    (positions,), status = found("drive_positions", pose)
    (every,), _ = found("joint_displacements", found.system.sample_states[0])
    labels = found.programs["joint_displacements"].outputs[0].labels
    chosen = [labels.index(label) for label in program.outputs[0].labels]
    assert np.all(status == 0) and np.abs(positions - every[:, chosen]).max() < 1e-12 and np.ptp(positions) > 1e-3
    assert program.operations["total"] < found.programs["inverse_kinematics"].operations["total"]


def test_out_of_reach_is_reported(found: Model) -> None:
    if found.mechanism.name == "three_rps":
        return  # its slides have no end
    pose = found.test_inputs["inverse_kinematics"][0].copy()
    pose[:, :3] += 50.0
    for function in ("inverse_kinematics", "drive_positions"):
        (got,), status = found(function, pose)
        assert np.all(status >= OUT_OF_REACH) and np.isnan(got).all()


def test_assembly_follows_the_guess_to_its_own_branch(found: Model) -> None:
    y, guess = found.test_inputs["assemble"][:2]
    (q,), status = found("assemble", y, guess)
    assert np.all(status == 0)
    expected = found.system.sample_states[0]
    assert np.abs(q - expected).max() < 1e-9


@pytest.mark.slow
def test_an_optimiser_closes_what_limbs_leave_open_across_their_planes(found: Model) -> None:
    """Three rows across the planes, and the quaternion's length, for what is left of the platform's coordinates."""
    equations = PointEquations(found.mechanism, (Gravity(),))
    layout = equations.layout
    assert layout.closed and len(layout.z) == 4
    q, _, _ = equations.system.states(6, 2)
    (got, closure, _), _ = evaluate(equations.closure, [q[:, list(layout.y)], q[:, list(layout.z)]])
    assert np.abs(got - q).max() < 1e-12 and np.abs(closure).max() < 1e-12
