"""Every effect against hand formulas, brought to bodies as loads of method B, and its books of energy."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from itertools import pairwise

import mpmath
import numpy as np
import pytest
import sympy
from support.effect_oracles import (
    CRANK,
    EXACT,
    G,
    Oracle,
    at_rest,
    drives,
    effect,
    input_of,
    inverse,
    inverse_only,
    oracle,
    relative,
    with_effects,
)

from symscrew import catalogue
from symscrew.description.mechanism import Parameter, Point
from symscrew.effects.effect import Effect
from symscrew.effects.gravity import Gravity
from symscrew.errors import DescriptionError
from symscrew.model import derive
from symscrew.reference.maximal_coordinates import BodyState, cross

# -- gravity, loads, the base -----------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("field", [(0, 0, "-9.81"), ("3.5", "-1/7", 2.25)])
def test_gravity_in_any_direction(field: tuple) -> None:
    numbers = [
        float(mpmath.mpf(mpmath.fraction(*map(int, c.split("/"))))) if "/" in str(c) else float(c) for c in field
    ]
    found = inverse("three_ups_upu_s", Gravity(field))
    assert relative(drives(found), oracle("three_ups_upu_s").solve(gravity=numbers).drives) < EXACT


def test_gravity_by_switch_and_by_field() -> None:
    of = oracle(CRANK)
    switched = inverse(CRANK, Gravity(input="switch"))
    for factor in (0.0, 1.0, 0.25):
        expected = of.solve(gravity=np.array(G) * factor).drives
        assert relative(drives(switched, gravity_on=factor), expected) < EXACT
    field = (1.0, -2.0, 3.0)
    found = inverse(CRANK, Gravity(input="field"))
    assert relative(drives(found, gravity_field=field), of.solve(gravity=field).drives) < EXACT
    assert "gravity_on" not in [p.name for p in inverse(CRANK, Gravity()).programs["inverse_dynamics"].inputs]


@pytest.mark.parametrize("axes", ["absolute", "body"])
@pytest.mark.parametrize("name, point", [("three_ups_upu_s", "E"), ("four_bar", "coupler_middle"), ("ur5", "flange")])
def test_external_wrench(name: str, point: str, axes: str) -> None:
    of, found = oracle(name), inverse(name, effect("ExternalWrench", point, axes=axes))
    load = input_of(found, "inverse_dynamics", f"load_{point}")
    force, moment = load[:, :3], load[:, 3:]
    if axes == "body":
        turn = of.states[found.mechanism.points[point].body].rotation
        force, moment = (np.einsum("nij,nj->ni", turn, x) for x in (force, moment))
    assert relative(drives(found), of.solve(of.at(point, force, moment)).drives) < EXACT


def test_wrench_as_a_function_of_time_is_the_input_of_the_same_value() -> None:
    wrench = ("10*sin(2*pi*t)", "t^2", -5, "exp(-t)", 0, "abs(t)/3")
    found, free = (inverse("four_bar", effect("ExternalWrench", "coupler_middle", w)) for w in (wrench, ()))
    t = 0.37
    values = [10 * np.sin(2 * np.pi * t), t**2, -5, np.exp(-t), 0, t / 3]
    assert [p.name for p in found.programs["inverse_dynamics"].inputs][-1] == "t"
    assert relative(drives(found, t=t), drives(free, load_coupler_middle=values)) < EXACT


def moved(states: dict[str, BodyState], twist: np.ndarray, rate: np.ndarray) -> dict[str, BodyState]:
    """States on a base that is in its reference pose now and moves with a twist: screws of the base's axes carried."""
    omega, v = twist[:3], twist[3:]
    result = {}
    for body, s in states.items():
        turn, slide = s.twist[:, :3], s.twist[:, 3:]
        carried = np.concatenate(
            [cross(omega + 0 * turn, turn), cross(omega + 0 * turn, slide) + cross(v + 0 * turn, turn)], -1
        )
        result[body] = BodyState(s.rotation, s.translation, s.twist + twist, s.twist_rate + carried + rate)
    return result


BASE_TWIST, BASE_RATE = np.array([0.3, -0.7, 0.4, 1.1, 0.2, -0.5]), np.array([0.9, 0.1, -1.3, 0.4, -2.0, 0.6])


@pytest.mark.parametrize("name", ["three_ups_upu_s", "ur5", CRANK])
def test_base_motion_against_bodies_that_move_with_the_base(name: str) -> None:
    of, found = oracle(name), inverse(name, Gravity(), effect("BaseMotion"))
    states = moved(of.states, BASE_TWIST, BASE_RATE)
    rest = np.zeros((len(of.q), 6))
    states[found.mechanism.ground] = BodyState(
        np.broadcast_to(np.eye(3), (len(rest), 3, 3)), rest[:, :3], rest + BASE_TWIST, rest + BASE_RATE
    )
    got = drives(found, base_twist=BASE_TWIST, base_twist_rate=BASE_RATE)
    assert relative(got, of.solve(gravity=G, states=states).drives) < EXACT


def rotation(t: mpmath.mpf, angles: list) -> mpmath.matrix:
    r, p, y = (angle(t) for angle in angles)
    c, s = mpmath.cos, mpmath.sin
    about_x = mpmath.matrix([[1, 0, 0], [0, c(r), -s(r)], [0, s(r), c(r)]])
    about_y = mpmath.matrix([[c(p), 0, s(p)], [0, 1, 0], [-s(p), 0, c(p)]])
    about_z = mpmath.matrix([[c(y), -s(y), 0], [s(y), c(y), 0], [0, 0, 1]])
    return about_z * about_y * about_x


def test_base_pose_is_differentiated_exactly() -> None:
    """Twist and rate by numerical differentiation with 40 digits give the same drives through the run-time inputs."""
    pose = ("0.1*sin(2*t)", "t^3", "0.05*cos(3*t)", "0.2*sin(t)", "0.3*t", "t^2/4")
    found = inverse("three_ups_upu_s", Gravity(), effect("BaseMotion", pose=pose))
    free = inverse("three_ups_upu_s", Gravity(input="field"), effect("BaseMotion"))
    with mpmath.workdps(40):
        place = [lambda t: mpmath.sin(2 * t) / 10, lambda t: t**3, lambda t: mpmath.cos(3 * t) / 20]
        angles = [lambda t: mpmath.sin(t) / 5, lambda t: mpmath.mpf(3) / 10 * t, lambda t: t**2 / 4]
        t = mpmath.mpf("0.8")
        turn = rotation(t, angles)

        def twist(s: mpmath.mpf) -> list:
            back = rotation(s, angles).T
            rate = mpmath.matrix(3, 3)
            for i in range(3):
                for j in range(3):
                    rate[i, j] = mpmath.diff(lambda x, i=i, j=j: rotation(x, angles)[i, j], s)
            spin = back * rate
            velocity = back * mpmath.matrix([mpmath.diff(f, s) for f in place])
            return [spin[2, 1], spin[0, 2], spin[1, 0], *velocity]

        now = [float(x) for x in twist(t)]
        rates = [float(mpmath.diff(lambda s, k=k: twist(s)[k], t)) for k in range(6)]
        field = [float(x) for x in turn.T * mpmath.matrix([0, 0, mpmath.mpf("-9.81")])]
    expected = drives(free, base_twist=now, base_twist_rate=rates, gravity_field=field)
    assert relative(drives(found, t=0.8), expected) < EXACT


def test_base_twist_of_time_and_attitude_input() -> None:
    twist = ("sin(t)", "t", 0, "0.5*t^2", "cos(t)", 1)
    found = inverse(CRANK, effect("BaseMotion", twist=twist))
    t = 0.6
    values = [np.sin(t), t, 0, 0.5 * t * t, np.cos(t), 1]
    rates = [np.cos(t), 1, 0, t, -np.sin(t), 0]
    free = inverse(CRANK, effect("BaseMotion"))
    assert relative(drives(found, t=t), drives(free, base_twist=values, base_twist_rate=rates)) < EXACT
    tilted = inverse(CRANK, Gravity(), effect("BaseMotion", attitude=True))
    half = 0.3
    seen = [0, -9.81 * np.sin(2 * half), -9.81 * np.cos(2 * half)]  # g in axes turned by 2 half about x
    got = drives(tilted, base_attitude=[np.cos(half), np.sin(half), 0, 0], base_twist=0, base_twist_rate=0)
    assert relative(got, oracle(CRANK).solve(gravity=seen).drives) < EXACT


# -- forces along joints ------------------------------------------------------------------------------------------

SMOOTH = 0.01  # m/s or rad/s: width of the smooth form


def dry(rate: np.ndarray, coulomb: float, static: float | None = None, wide: float = 1.0) -> np.ndarray:
    level = coulomb if static is None else coulomb + (static - coulomb) / (1 + (rate / wide) ** 2)
    return -level * rate / np.sqrt(rate**2 + SMOOTH**2)


JOINTS = [(CRANK, "crank_R", 0), (CRANK, "slider_P", 0), (CRANK, "slider_R", 0), ("four_bar", "C", 0),
          ("three_ups_upu_s", "limb1_P", 0), ("three_ups_upu_s", "limb1_U2", 1), ("ur5", "elbow_joint", 0)]  # fmt: skip
LAWS = {
    "viscous": (lambda j, k: effect("ViscousFriction", j, "0.7", freedom=k), lambda s, v: -0.7 * v),
    "coulomb": (lambda j, k: effect("DryFriction", j, 2, velocity=SMOOTH, freedom=k), lambda s, v: dry(v, 2)),
    "stribeck": (
        lambda j, k: effect("DryFriction", j, 2, 3, "0.4", velocity=SMOOTH, freedom=k),
        lambda s, v: dry(v, 2, 3, 0.4),
    ),
    "spring": (
        lambda j, k: effect("JointSpring", j, 50, "0.1", 2, -3, "0.4", freedom=k),
        lambda s, v: -(2 + 50 * (s - 0.1) - 3 * (s - 0.1) ** 3) - 0.4 * v,
    ),
    "energy": (
        lambda j, k: effect("JointSpring", j, rest=1, energy="x^4 + 2*exp(-x) + sqrt(1 + x^2)", freedom=k),
        lambda s, v: -(4 * (s - 1) ** 3 - 2 * np.exp(1 - s) + (s - 1) / np.sqrt(1 + (s - 1) ** 2)),
    ),
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("name, joint, freedom", JOINTS)
def test_force_along_a_joint(name: str, joint: str, freedom: int, law: str) -> None:
    make, formula = LAWS[law]
    of, acting = oracle(name), make(joint, freedom)
    if joint in acting.reads and joint in [cut.joint.name for cut in with_effects(name).system.cuts]:
        found = with_effects(name, acting)  # the loop is cut elsewhere, so that its states are others
        of = Oracle(found)
    else:
        found = inverse(name, acting)
        assert np.abs(drives(found) - drives(inverse(name))).max() > 1e-6, "the force does nothing here"
    force = formula(of.displacement(joint, freedom), of.rate(joint, freedom))
    expected = of.solve(of.along(joint, force, freedom))
    assert relative(drives(found), expected.drives) < EXACT
    assert np.abs(force).max() > 1e-6


@pytest.mark.slow
def test_viscous_friction_in_a_spherical_joint_that_closes_a_loop() -> None:
    name, joint = "three_ups_upu_s", "limb2_S"
    of, found = oracle(name), inverse(name, effect("ViscousFriction", joint, 3))
    given = found.mechanism.joints[joint]
    moment = -3 * (of.states[given.child].twist[:, :3] - of.states[given.parent].twist[:, :3])
    wrench = np.concatenate([0 * moment, moment], axis=-1)
    assert relative(drives(found), of.solve({given.child: wrench, given.parent: -wrench}).drives) < EXACT


def test_spring_in_a_spherical_joint_turns_back_about_the_rotation_vector() -> None:
    name, joint = "three_ups_upu_s", "limb5_S"
    of, found = oracle(name), inverse(name, effect("JointSpring", joint, 40, nearest=True))
    given = found.mechanism.joints[joint]
    moment = np.zeros((len(of.q), 3))
    for k in range(len(moment)):
        turn = of.states[given.child].rotation[k]  # the parent is the ground
        axial = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2
        sine = np.linalg.norm(axial)
        angle = np.arctan2(sine, (np.trace(turn) - 1) / 2)
        moment[k] = -40 * axial * (angle / sine if sine else 1.0)
    assert relative(drives(found), of.solve({given.child: np.concatenate([0 * moment, moment], -1)}).drives) < EXACT


@pytest.mark.parametrize("name, ends", [("three_ups_upu_s", ("A1", "E")), ("four_bar", ("anchor", "coupler_middle"))])
@pytest.mark.parametrize(
    "fields", [{"stiffness": 30}, {"stiffness": 30, "length": "0.2", "preload": 4, "cubic": 7, "damping": "1.5"}]
)
def test_point_spring(name: str, ends: tuple[str, str], fields: dict) -> None:
    spring = effect("PointSpring", *ends, **fields)
    of = anchored() if name == "four_bar" else oracle(name)
    found = inverse_only(of.mechanism, [spring])
    away = of.place(ends[1]) - of.place(ends[0])
    distance = np.linalg.norm(away, axis=1, keepdims=True)
    speed = ((of.velocity(ends[1]) - of.velocity(ends[0])) * away).sum(1, keepdims=True) / distance
    x = distance - float(fields.get("length", 0))
    tension = (
        fields.get("preload", 0) + 30 * x + fields.get("cubic", 0) * x**3 + float(fields.get("damping", 0)) * speed
    )
    force = tension * away / distance
    expected = of.solve(of.at(ends[0], force), of.at(ends[1], -force)).drives
    assert relative(drives(found), expected) < EXACT


@pytest.mark.parametrize(
    ("fields", "tension"),
    [
        ({"stiffness": 30, "length": "0.5", "damping": "1.5"}, lambda d: 30 * (d - 0.5)),
        ({"stiffness": 30, "length": "0.5", "shortest": 0}, lambda d: 30 * (d - 0.5)),
        ({"stiffness": 30, "length": "9.5", "shortest": "9.1"}, lambda d: 30 * (d - 9.1)),
        ({"stiffness": 30, "length": "9.5", "shortest": "0.1"}, lambda d: 0 * d),
    ],
)
def test_point_spring_over_further_points(fields: dict, tension: Callable) -> None:
    names = ("A1", "E", "A2")
    of = oracle("three_ups_upu_s")
    found = inverse_only(of.mechanism, [effect("PointSpring", names[0], names[2], through=names[1:2], **fields)])
    ends = [(of.place(b) - of.place(a), of.velocity(b) - of.velocity(a)) for a, b in pairwise(names)]
    sizes = [np.linalg.norm(away, axis=1, keepdims=True) for away, _ in ends]
    speed = sum((w * away).sum(1, keepdims=True) / d for d, (away, w) in zip(sizes, ends, strict=True))
    pull = tension(sum(sizes)) + float(fields.get("damping", 0)) * speed
    first, second = (pull * away / d for d, (away, _) in zip(sizes, ends, strict=True))
    expected = of.solve(of.at("A1", first), of.at("E", second - first), of.at("A2", -second)).drives
    assert relative(drives(found), expected) < EXACT


@cache
def anchored() -> Oracle:
    """The four-bar linkage with a named point on the ground."""
    plain = catalogue.load("four_bar")
    point = Point("anchor", plain.ground, (sympy.Rational(1, 10), sympy.S.Zero, sympy.Rational(3, 10)))
    return Oracle(derive(replace(plain, points={**plain.points, "anchor": point}), []))


# -- inertia and simplifications ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name, body", [("three_ups_upu_s", "platform"), ("four_bar", "coupler"), ("ur5", "forearm_link")]
)
def test_payload_is_one_more_mass_on_the_body(name: str, body: str) -> None:
    of = oracle(name)
    com, moments = np.array([0.1, -0.2, 0.3]), [0.03, 0.05, 0.04, 0.002, -0.003, 0.001]
    payload = effect("Payload", body, 2, tuple(com), tuple(moments))
    found = inverse(name, Gravity(), payload)
    xx, yy, zz, xy, xz, yz = moments
    inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    expected = of.solve(of.inertial(body, 2, com, inertia, G), gravity=G).drives
    assert relative(drives(found), expected) < EXACT


def own_inertia(of: Oracle, body: str) -> tuple[float, np.ndarray, np.ndarray]:
    k = of.numbers.bodies.index(body)
    return of.numbers.mass[k], of.numbers.com[k], of.numbers.inertia[k]


def negative(loads: dict) -> dict:
    return {body: -wrench for body, wrench in loads.items()}


def test_massless_limbs_leave_the_platform_alone() -> None:
    name = "three_ups_upu_s_physical"
    of, found = oracle(name), inverse(name, Gravity(), effect("MasslessLimbs"))
    lost = [negative(of.inertial(b, *own_inertia(of, b), G)) for b in of.numbers.bodies[1:] if b != "platform"]
    got, expected = drives(found), of.solve(*lost, gravity=G).drives
    assert relative(got, expected) < 1e-9
    plain = inverse(name, Gravity())
    assert (
        found.programs["inverse_dynamics"].operations["total"] < plain.programs["inverse_dynamics"].operations["total"]
    )
    assert relative(drives(plain), expected) > 1e-3


def test_without_gyroscopic_terms() -> None:
    name = "three_ups_upu_s_physical"
    of = oracle(name)
    bodies = tuple(body for body in of.mechanism.bodies if body != of.mechanism.ground)
    found = with_effects(name, Gravity(), effect("NoGyroscopicTerms", bodies))
    lost = []
    for body in of.numbers.bodies[1:]:
        _, _, inertia = own_inertia(of, body)
        turn, omega = of.states[body].rotation, of.states[body].twist[:, :3]
        couple = cross(omega, np.einsum("nij,jk,nlk,nl->ni", turn, inertia, turn, omega))
        lost.append({body: np.concatenate([0 * couple, couple], axis=-1)})
    expected = of.solve(*lost, gravity=G)
    assert relative(drives(found), expected.drives) < 1e-9
    assert relative(drives(inverse(name, Gravity())), expected.drives) > 1e-6
    reactions = found("joint_reactions", *found.test_inputs["joint_reactions"])[0][1]
    joints = list(found.mechanism.joints)
    wanted = np.concatenate([np.where(expected.unique[j], expected.reactions[j], 0) for j in joints], axis=-1)
    unique = np.concatenate([expected.unique[j] for j in joints], axis=-1)
    assert relative(np.where(unique, reactions, 0), wanted) < 1e-9


def test_quasi_static_is_equilibrium_at_rest_with_friction_as_it_moves() -> None:
    of = oracle(CRANK)
    found = with_effects(CRANK, Gravity(), effect("ViscousFriction", "slider_P", 5), effect("QuasiStatic"))
    force = of.along("slider_P", -5 * of.rate("slider_P"))
    assert relative(drives(found), of.solve(force, gravity=G, states=at_rest(of.states)).drives) < EXACT
    assert "forward_dynamics" not in found.programs


# -- values that are run-time parameters -----------------------------------------------------------------------------


def test_values_may_be_run_time_parameters() -> None:
    """Friction, a spring's rest and a payload given by parameters: inputs p of the code, equal to the numbers."""
    plain = catalogue.load(CRANK)
    names = {"c": "0.7", "rest": "0.03", "more": "2"}
    parameters = {n: Parameter(n, sympy.Rational(v), run_time=True) for n, v in names.items()}
    open_ended = replace(plain, parameters={**plain.parameters, **parameters})

    def effects(c: str, rest: str, more: str) -> list[Effect]:
        return [
            Gravity(),
            effect("ViscousFriction", "slider_P", c),
            effect("JointSpring", "slider_P", 20, f"2*{rest}"),
            effect("Payload", "rod", f"{more}/2", ("0.1", 0, "0.2"), ("0.1", "0.1", "0.1")),
        ]

    found = inverse_only(open_ended, effects("c", "rest", "more"))
    for values in ([0.7, 0.03, 2.0], [0.2, -0.1, 5.0]):
        baked = inverse_only(plain, effects(*(str(v) for v in values)))
        assert relative(drives(found, p=values), drives(baked)) < EXACT
    with pytest.raises(DescriptionError, match="at least 0"):
        inverse_only(open_ended, [effect("ViscousFriction", "slider_P", "-c")])
