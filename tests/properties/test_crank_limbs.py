"""Closed forms of cranks with rods: deltas, rotary hexapods, rods on the ground, by the functions of the platform."""

from __future__ import annotations

import numpy as np
import pytest
from support.marks import slow
from support.model_states import relative
from support.operation_counts import rise
from support.rod_mechanisms import MECHANISMS, Q, delta_of_half_spacing, model

from symscrew.effects.gravity import Gravity
from symscrew.loops.limbs.closed_forms import closed_limbs, hub_links, limb_coordinates
from symscrew.model import Model, derive
from symscrew.optimisation.motion_equations import PointEquations
from symscrew.program import OUT_OF_REACH
from symscrew.program.numpy_evaluation import evaluate

QUICK = ("delta", "hexapod")
FURTHER = (
    "rod_on_the_ground",
    "delta_second_rods_first",
    "delta_thick_rods",
    "hexapod_inwards",
)
PLATFORM = ("inverse_kinematics", "inverse_velocity", "inverse_dynamics_platform")


def of_hub(found: Model, q: np.ndarray, *rates: np.ndarray) -> list[np.ndarray]:
    """The entries of the platform's own joint in q, and in rates or accelerations."""
    links = hub_links(found.system) or ()
    in_q, in_v = ([k for x in links for k in range(s(x).start, s(x).stop)] for s in (lambda x: x.q, lambda x: x.v))
    return [q[..., in_q], *(x[..., in_v] for x in rates)]


def elbows(found: Model, q: np.ndarray) -> np.ndarray:
    """Of the first crank (rod's centre seen from it) x (tip seen from it) along its axis, in the present state."""
    limb = next(x for x in closed_limbs(found.system) or () if len(x.links) == 3)
    system, frame = found.system, found.system.frames[limb.links[0].index]
    nodes = [*frame.offset, *(c for row in frame.rotation for c in row)]
    numbers = found.system.numeric([system.tape.node(n) for n in nodes], (system.inputs.q, q[0]))
    offset, rotation = numbers[:3], numbers[3:].reshape(3, 3)
    points = [system.pose[limb.cut.hub].point(limb.cut.hub_point)]
    points.append(system.pose[limb.links[0].index].point(limb.rod.centre))
    tip, centre = (
        (system.numeric([system.tape.node(c) for c in p], (system.inputs.q, q)) - offset) @ rotation for p in points
    )
    return centre[:, 0] * tip[:, 1] - centre[:, 1] * tip[:, 0]


@pytest.mark.slow
@pytest.mark.parametrize("name", [*QUICK, *(slow(name) for name in FURTHER)])
def test_platform_functions_equal_those_of_the_tree(name: str) -> None:
    found = model(name)
    for q, v, a in (found.system.sample_states, found.system.states(20, 3)):
        pose, rate, gain = of_hub(found, q, v, a)
        (got_q,), first = found("inverse_kinematics", pose)
        (got_v,), second = found("inverse_velocity", pose, rate)
        (drives,), third = found("inverse_dynamics_platform", pose, rate, gain)
        (expected,), _ = found("inverse_dynamics", q, v, a)
        assert not np.any([first, second, third])
        assert np.abs(got_q - q).max() < 1e-12 and np.abs(got_v - v).max() < 1e-12
        assert relative(drives, expected) < 1e-9


@pytest.mark.parametrize("name", ["delta", slow("hexapod")])
def test_angles_enter_by_cosine_and_sine(name: str) -> None:
    operations = {function: model(name).programs[function].operations for function in PLATFORM}
    angles = sum(c.kind == "angle" for c in model(name).system.tree.q)
    assert [operations[function]["trig"] for function in PLATFORM] == [angles, 0, 0]  # atan2 of every angle
    cranks = {"delta": 3, "hexapod": 6}[name]
    assert operations["inverse_dynamics_platform"]["sqrt"] == cranks  # of thin rods no angle is needed
    assert rise("plain" if name == "delta" else "rods", name, model(name)) == {}


@pytest.mark.parametrize("name", ["delta", slow("hexapod")])
def test_out_of_reach_is_reported(name: str) -> None:
    found = model(name)
    pose, rate, gain = (x.copy() for x in found.test_inputs["inverse_dynamics_platform"])
    pose[:, :3] += 5.0
    for function, inputs in zip(PLATFORM, ([pose], [pose, rate], [pose, rate, gain]), strict=True):
        (got,), status = found(function, *inputs)
        assert np.all(status >= OUT_OF_REACH) and np.isnan(got).all()


@pytest.mark.parametrize("name", ["delta", slow("hexapod"), slow("hexapod_inwards")])
def test_a_guess_beyond_the_dead_centre_gives_the_other_elbow(name: str) -> None:
    """A constant guess: the reference's elbow; a guess of nodes: the guess's own, and q itself where that is closed."""
    found = model(name)
    system = found.system
    hub, limbs = hub_links(system) or (), closed_limbs(system)
    known = {k: system.inputs.q[k] for link in hub for k in range(link.q.start, link.q.stop)}
    nodes = limb_coordinates(system, limbs or (), known, system.inputs.q).q
    q = system.states(8, 4)[0]
    assert np.abs(system.numeric(nodes, (system.inputs.q, q)) - q).max() < 1e-12
    guess = q.copy()
    for limb in limbs or ():
        guess[:, limb.links[0].q.start] += 2.5 * (len(limb.links) == 3)
    other = system.numeric(nodes, (system.inputs.q, guess))
    assert np.abs(system.numeric(system.residual, (system.inputs.q, other))).max() < 1e-12
    sides = elbows(found, q) * elbows(found, other)
    flipped = sides < 0
    assert flipped.any()
    assert np.abs(sides + elbows(found, q) ** 2)[flipped].max() < 1e-12
    assert np.abs(system.numeric(nodes, (system.inputs.q, other)) - other).max() < 1e-12
    (back,), status = found("inverse_kinematics", *of_hub(found, other))
    assert not status.any() and np.abs(back - q).max() < 1e-12
    (stayed,), status = found("assemble", other[:, list(found.programs["assemble"].independent)], other)
    assert not status.any() and np.abs(stayed - other).max() < 1e-12


@pytest.mark.parametrize("name", ["delta", "delta_second_rods_first", "hexapod", "rod_on_the_ground"])
def test_an_optimiser_closes_what_the_closed_forms_leave_open(name: str) -> None:
    """As many equations as coordinates that are left: the lengths of further rods, and the quaternion's."""
    equations = PointEquations(MECHANISMS[name](), (Gravity(),))
    layout, system = equations.layout, equations.system
    lengths = {"delta": 3, "delta_second_rods_first": 3, "hexapod": 0, "rod_on_the_ground": 1}[name]
    assert layout.closed and len(layout.z) == lengths + 1
    q, _, _ = system.states(6, 2)
    (got, closure, _), _ = evaluate_at(equations, q)
    assert np.abs(got - q).max() < 1e-12 and np.abs(closure).max() < 1e-12
    q[:, [*layout.z, *layout.y]] += 1e-3
    (_, closure, _), _ = evaluate_at(equations, q)
    assert np.abs(closure).min() > 1e-7


def evaluate_at(equations: PointEquations, q: np.ndarray) -> tuple:
    return evaluate(equations.closure, [q[:, list(equations.layout.y)], q[:, list(equations.layout.z)]])


@pytest.mark.slow
def test_run_time_parameters_equal_baked_ones() -> None:
    given = derive(delta_of_half_spacing(Q(1, 25), run_time=True))
    other = derive(delta_of_half_spacing(Q(6, 125), run_time=False))
    for value, baked in ((Q(1, 25), model("delta")), (Q(6, 125), other)):
        for function in PLATFORM:
            inputs = baked.test_inputs[function]
            (expected,), _ = baked(function, *inputs)
            (got,), status = given(function, *inputs, [float(value)])
            assert not status.any() and relative(got, expected) < 1e-12
