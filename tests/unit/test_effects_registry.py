"""Effects as files: found, written and read back, refused where wrong, adding up, and costing nothing unasked."""

from __future__ import annotations

import itertools
import json
import tomllib
import zlib
from dataclasses import replace
from decimal import Decimal
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from support.effect_oracles import inverse_only, relative

import symscrew
from symscrew import catalogue
from symscrew import effects as known
from symscrew.description.mechanism import Mechanism, Point
from symscrew.effects.effect import Effect
from symscrew.effects.gravity import Gravity
from symscrew.effects.registry import check_effects, effect_from_table, effect_to_table, known_effects
from symscrew.errors import DescriptionError
from symscrew.export.manifest_file import effect_from_json, effect_to_json
from symscrew.functions.dynamic import Equations
from symscrew.functions.ports import a_port, function, q_port, v_port
from symscrew.kinematics.system import System
from symscrew.program.lowering import lower
from symscrew.program.numpy_evaluation import evaluate

PACKAGE = Path(symscrew.__file__).parent
SEED, CRANK = "three_ups_upu_s", "slider_crank"


def effect(name: str, *args: object, **fields: object) -> Effect:
    return getattr(known, name)(*args, **fields)


ADDING = {
    "gravity": Gravity(("1", "2", "-9.81")),
    "wrench": effect("ExternalWrench", "E"),
    "body_wrench": effect("ExternalWrench", "C1", ("10*sin(t)", 0, 1, "t", "exp(-t)", 2), "body"),
    "base": effect("BaseMotion", twist=("sin(t)", "t", "0.3", "t^2", 1, "cos(t)")),
    "viscous": effect("ViscousFriction", "limb2_S", "0.2"),
    "dry": effect("DryFriction", "limb1_P", 3, 4, "0.1", "0.01"),
    "event": effect("DryFriction", "limb3_P", mode="event"),
    "joint_spring": effect("JointSpring", "limb1_U", 50, "0.1", 2, -3, "0.4", freedom=1),
    "point_spring": effect("PointSpring", "A1", "E", 30, "0.2", 4, 7, "1.5"),
    "cable": effect("Cable", "t", ("A1", ("around", "A2", "0.01", (0, 1, 2), "C1"), "E"), 30, "0.2", "0.1", 2, True),
    "muscle": effect("HillMuscle", "m", ("A1", ("within", "E", "0.05", ()), "A2", ("pulley", 2), "C1", "E"), 9, (1, 2)),
    "stop": effect("EndStop", "limb2_P", upper="0.01", stiffness=10000, damping=1),
    "rotor": effect("RotorInertia", "limb1_P", "0.2", 3),
    "motor": effect("DcMotor", "limb2_P", "0.05", "1.2", "0.001", 50),
    "servo": effect("PositionServo", "limb3_P", 400, 8, 30),
    "leg": effect("LegCompliance", "limb4_P", 20000, 4, "0.02"),
    "lash": effect("Backlash", "limb1_P", "0.002", 20000, 4, "1.5", 3),
    "rolling": effect("RollingContact", "E", "A1", "0.6", 20, "0.1", axis=(0, 1, 0), stiffness=1000, friction="0.3"),
    "drag": effect("FluidDrag", "platform", ("0.1", "0.2", "0.3"), 800, "0.5", (1, 0, "0.2")),
    "clearance": effect("JointClearance", "A1", "E", "0.01", 1000, friction="0.1", velocity="0.1"),
}
DEPENDING = {
    "load": (effect("DryFriction", "slider_P", load="0.2", velocity="0.01"), "reactions"),
    "payload": (effect("Payload", "slider", 3, ("0.1", 0, 0)), "inertia"),
    "flexible": (effect("FlexibleLink", "pin", "far", (0, 1, 0), 50, "0.5"), "inertia"),
    "screw": (effect("ScrewTransmission", "slider_P", "0.01", "0.8", velocity="0.001"), "drives"),
    "massless": (effect("MasslessLimbs"), "inertia"),
    "no_gyroscopic": (effect("NoGyroscopicTerms"), "inertia"),
    "quasi_static": (effect("QuasiStatic"), "motion"),
    "tilting": (effect("BaseMotion", pose=(0, 0, 0, "t", 0, "t^2")), "gravity"),
}

CONSTRAINING = {"ideal_rolling": effect("IdealRolling", "pin", "far", "0.1", axis=(0, 1, 0))}
EVERY = {**ADDING, **{name: given for name, (given, _) in DEPENDING.items()}, **CONSTRAINING}


# -- finding, writing, reading ------------------------------------------------------------------------------------


def test_every_file_holds_one_effect_with_an_example_of_a_scene() -> None:
    """The example in the docstring is read as a scene would read it."""
    assert {"gravity", "external_wrench", "viscous_friction", "dc_motor"} <= set(known_effects())
    for name, kind in known_effects().items():
        text = kind.__doc__ or ""
        assert "[[effects]]" in text, f"{name} shows no example"
        start = text.index("[[effects]]")
        lines = itertools.takewhile(lambda line: line.strip(), text[start:].splitlines())
        table = tomllib.loads("\n".join(line.strip() for line in lines), parse_float=Decimal)["effects"][0]
        made = effect_from_table(table)
        assert table["type"] == name and type(made) is kind


@pytest.mark.parametrize("name", EVERY)
def test_tables_and_manifests_bring_an_effect_back(name: str) -> None:
    given = EVERY[name]
    assert effect_from_table(json.loads(json.dumps(effect_to_table(given)))) == given
    assert effect_from_json(json.loads(json.dumps(effect_to_json(given)))) == given
    assert repr(effect_from_table(effect_to_table(given))) == repr(given)


def test_all_effects_are_tested_here() -> None:
    tested = {type(e) for e in EVERY.values()}
    assert tested == set(known_effects().values())


# -- errors ---------------------------------------------------------------------------------------------------------

TABLES = [
    ({"type": "gravty"}, "did you mean 'gravity'"),
    ({}, "key 'type'"),
    (["gravity"], "expected a table"),
    ({"type": "viscous_friction", "joint": "A"}, "needs the key 'coefficient'"),
    ({"type": "viscous_friction", "joint": "A", "coeficient": 1}, "did you mean 'coefficient'"),
    ({"type": "viscous_friction", "joint": 3, "coefficient": 1}, "expected text"),
    ({"type": "viscous_friction", "joint": "A", "coefficient": True}, "expected"),
    ({"type": "viscous_friction", "joint": "A", "coefficient": [1]}, "single value"),
    ({"type": "viscous_friction", "joint": "A", "coefficient": 1, "freedom": "x"}, "expected"),
    ({"type": "viscous_friction", "joint": "A", "coefficient": Decimal("NaN")}, "finite"),
    ({"type": "gravity", "acceleration": [0, 0, Decimal("-inf")]}, "finite"),
    ({"type": "quasi_static", "joint": "A"}, "unknown key"),
    ({"type": "viscous_friction", "joint": "A", "mu": 1}, r"the effect viscous_friction; its keys: [^()]*$"),
]


@pytest.mark.parametrize("table, message", TABLES)
def test_tables_that_cannot_be_read(table: object, message: str) -> None:
    with pytest.raises(DescriptionError, match=message) as error:
        effect_from_table(table, "effects[1]")
    assert "effects[1]" in str(error.value) and "\n" not in str(error.value)


WRONG = [
    (effect("ViscousFriction", "slider_p", 1), "did you mean .*'slider_P'"),
    (effect("ViscousFriction", "slider_P", -1), "at least 0"),
    (effect("ViscousFriction", "slider_P", float("nan")), "finite"),
    (effect("ViscousFriction", "slider_P", "inf"), "unknown name"),
    (effect("ViscousFriction", "slider_P", 1, 1), "index from 0 to 0"),
    (effect("DryFriction", "slider_P", -2, velocity=1), "at least 0"),
    (effect("DryFriction", "slider_P", 2), "velocity"),
    (effect("DryFriction", "slider_P", 2, 1, 1, 1), "static >= coulomb"),
    (effect("DryFriction", "slider_P", 2, 3, velocity=1), "stribeck_velocity"),
    (effect("DryFriction", "slider_P", 2, velocity=0), "above 0"),
    (effect("DryFriction", "slider_P", 2, mode="sticky"), "'smooth' or 'event'"),
    (effect("DryFriction", "slider_P", load=1, velocity=1, passes=0), "passes"),
    (effect("JointSpring", "slider_P", -5), "at least 0"),
    (effect("JointSpring", "slider_P", damping=-5), "at least 0"),
    (effect("JointSpring", "slider_P", 5, energy="x^2"), "either"),
    (effect("JointSpring", "slider_P", energy="y^2"), "unknown name 'y'"),
    (effect("PointSpring", "pistn", "piston", 5), "did you mean 'piston'"),
    (effect("PointSpring", "piston", "piston", 5), "two bodies"),
    (effect("Cable", "t", ("piston", "piston"), 5), "two bodies"),
    (effect("Cable", "t", ("piston",), 5), "at least two points"),
    (effect("EndStop", "slider_P", stiffness=5), "lower"),
    (effect("EndStop", "slider_P", 2, 1, stiffness=5), "lower < upper"),
    (effect("EndStop", "slider_P", 1, 2), "stiffness"),
    (effect("EndStop", "slider_P", 1, 2, 5, 3), "exponent"),
    (effect("EndStop", "slider_P", 1, 2, mode="impact", restitution=2), "0 to 1"),
    (effect("RotorInertia", "slider_P", -1), "at least 0"),
    (effect("ScrewTransmission", "slider_P", "0.01"), "driven freedom"),
    (effect("ScrewTransmission", "crank_R", "0.01"), "slides"),
    (effect("DcMotor", "slider_P", 0, 1, 1), "above 0"),
    (effect("PositionServo", "slider_P", 1, -1), "at least 0"),
    (effect("LegCompliance", "crank_R", 1, 1), "slides"),
    (effect("LegCompliance", "slider_P", 1, 1, -1), "at least 0"),
    (effect("Payload", "sldier", 1, (0, 0, 0)), "did you mean 'slider'"),
    (effect("Payload", "slider", -1, (0, 0, 0)), "above 0"),
    (effect("Payload", "slider", 1, (0, 0)), "3 numbers"),
    (effect("Payload", "slider", 1, (0, 0, 0), (1, 1, 9)), "principal moments"),
    (effect("MasslessLimbs", ("sldier",)), "did you mean 'slider'"),
    (effect("ExternalWrench", "pistn"), "did you mean 'piston'"),
    (effect("ExternalWrench", "piston", (1, 2)), "6 numbers"),
    (effect("ExternalWrench", "piston", ("sin(s)", 0, 0, 0, 0, 0)), "unknown name 's'"),
    (effect("ExternalWrench", "piston", axes="tool"), "'absolute' or 'body'"),
    (effect("BaseMotion", ("t",)), "6 entries"),
    (effect("BaseMotion", twist=("t",) * 6, pose=("t",) * 6), "one of"),
    (Gravity((0, 0)), "3 components"),
    (Gravity(("x", 0, 0)), "finite numbers"),
    (Gravity(input="on"), "'switch' or 'field'"),
]


@pytest.mark.parametrize("wrong, message", WRONG, ids=lambda x: str(x)[:60])
def test_effects_that_do_not_fit(wrong: Effect, message: str) -> None:
    with pytest.raises(DescriptionError, match=message) as error:
        check_effects(catalogue.load(CRANK), [wrong])
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    "pair, message",
    [
        ([effect("ExternalWrench", "piston")] * 2, "input 'load_piston'"),
        ([effect("PositionServo", "slider_P", 1)] * 2, "key 'name'"),
        ([effect("BaseMotion"), effect("BaseMotion", twist=("t",) * 6)], "second one"),
    ],
)
def test_effects_that_do_not_fit_together(pair: list[Effect], message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        check_effects(catalogue.load(CRANK), pair)


# -- adding up -----------------------------------------------------------------------------------------------------


@cache
def shared_system() -> System:
    system = System(catalogue.load(SEED))
    system.use_samples()
    return system


@cache
def drives(*names: str) -> np.ndarray:
    """Drives of the seed under some effects, equal inputs for equal ports."""
    system = shared_system()
    equations = Equations(system, [ADDING[name] for name in names])
    q, v, a = system.sample_states
    state = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v), (a_port(system), system.inputs.a)]
    output = [equations.command(equations.solution)]
    program = lower(function(system, "drives", "", inputs=[*state, *equations.forces.inputs], outputs=output))
    arrays = [q, v, a]
    for port in program.inputs[3:]:
        columns = [np.random.default_rng(zlib.crc32(x.encode())).uniform(-1, 1, len(q)) for x in port.labels]
        arrays.append(np.stack(columns, axis=-1))
    (u,), status = evaluate(program, arrays)
    assert not status.any()
    return u


CONTACTS = {"lash", "rolling", "clearance"}  # beside each other and the wrench in every run, beside all in the slow one
PAIRS = [
    pytest.param(*pair, marks=[pytest.mark.slow] * bool(CONTACTS & {*pair} and not {*pair} <= {*CONTACTS, "wrench"}))
    for pair in itertools.combinations(ADDING, 2)
]


@pytest.mark.parametrize("one, other", PAIRS)
def test_force_screws_of_the_state_add_up(one: str, other: str) -> None:
    for name in (one, other):
        assert not ADDING[name].depends_on
        assert np.abs(drives(name) - drives()).max() > 1e-6, f"{name} does nothing here"
    together = drives(one, other) - drives()
    apart = (drives(one) - drives()) + (drives(other) - drives())
    assert np.abs(together - apart).max() < 1e-12 * max(1.0, np.abs(drives(one, other)).max())


@pytest.mark.parametrize("name", DEPENDING)
def test_what_does_not_add_up_says_what_it_depends_on(name: str) -> None:
    given, reason = DEPENDING[name]
    assert given.depends_on == {reason}
    described = catalogue.load("ur5" if name in ("no_gyroscopic", "tilting") else CRANK)
    if name == "screw":
        described = driven_slider(described)
    if name == "flexible":
        described = with_pins(described)
    if name == "payload":
        given = effect("Payload", "rod", 3, ("0.3", 0, "0.1"))
    if name == "massless":
        others: list[Effect] = [Gravity()]
    elif name == "no_gyroscopic":
        others = [effect("Payload", "forearm_link", 2, ("0.1", "0.2", "0.3"), ("0.3", "0.4", "0.5"))]
    elif name == "quasi_static":
        others = [effect("RotorInertia", "crank_R", 3)]
    else:
        others = [Gravity((1, 2, -9))]

    def u(*effects: Effect) -> np.ndarray:
        found = inverse_only(described, effects)
        return found("inverse_dynamics", *found.test_inputs["inverse_dynamics"])[0][0]

    together, apart = u(given, *others) - u(), (u(given) - u()) + (u(*others) - u())
    assert relative(together, apart) > 1e-6


def with_pins(mechanism: Mechanism) -> Mechanism:
    """The slider-crank with points at the joints of its rod."""
    ends = {"pin": "rod_R", "far": "slider_R"}
    pins = {name: Point(name, "rod", mechanism.joints[joint].point) for name, joint in ends.items()}
    return replace(mechanism, points={**mechanism.points, **pins})


def driven_slider(mechanism: Mechanism) -> Mechanism:
    """The slider-crank with its drive on the slider."""
    joints = {n: replace(j, driven=(0,) if n == "slider_P" else ()) for n, j in mechanism.joints.items()}
    return replace(mechanism, joints=joints)


# -- what is asked is paid, and nothing else -----------------------------------------------------------

ROD = tuple(str(c) for c in catalogue.load(CRANK).bodies["rod"].com or ())
COUNTS = [  # operations that an effect on the driven joint adds to inverse dynamics, counted by hand
    (effect("ViscousFriction", "crank_R", 2), 2),  # + c v
    (effect("ViscousFriction", "crank_R", 1), 1),  # + v
    (effect("DryFriction", "crank_R", mode="event"), 1),  # - F
    (effect("DryFriction", "crank_R", 2, velocity="0.1"), 5),  # + 2 (v / sqrt(v^2 + v0^2)); v^2 is there already
    (effect("JointSpring", "crank_R", 5), 2),
    (effect("JointSpring", "crank_R", 5, preload=2), 3),
    (effect("RotorInertia", "crank_R", 2), 0),  # another constant: what the crank's own inertia is multiplied by
    (effect("DcMotor", "crank_R", 2, 1, 1), 3),  # - k i; the voltage, which no drive depends on, is tested for NaN
    (effect("Payload", "rod", 1, ROD), 0),  # other constants, nothing more
]


@pytest.mark.parametrize("given, count", COUNTS, ids=lambda x: str(x)[:40])
def test_an_effect_costs_its_own_operations(given: Effect, count: int) -> None:
    plain, found = (inverse_only(catalogue.load(CRANK), effects) for effects in ([], [given]))
    totals = [m.programs["inverse_dynamics"].operations["total"] for m in (plain, found)]
    assert totals[1] - totals[0] == count
