"""Margins from singularities against screws built here from the descriptions, and at singularities known beforehand.

The oracle: product of exponentials of the description's axes in 40 digits (open chains and limbs), Pluecker
coordinates of the legs, and singular values of the closure Jacobian with the drives' columns left out.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy
from support import reference_mechanisms
from support.marks import slow
from support.model_states import model as complete_model
from support.model_states import output

from symscrew import catalogue
from symscrew.description import characteristic_length, toml_file
from symscrew.description.builder import MechanismBuilder
from symscrew.description.joints import JOINT_TYPES
from symscrew.description.mechanism import Mechanism
from symscrew.functions.closing import assembly, closure_functions, loop_notes
from symscrew.functions.kinematic import Motion, kinematic_functions
from symscrew.functions.margin import margin_functions
from symscrew.functions.platform import platform_functions
from symscrew.kinematics import System
from symscrew.loops.dependent_rates import Loops
from symscrew.mobility import analyse_mobility, mobility_text, mobility_values
from symscrew.model import Model
from symscrew.program.lowering import lower
from symscrew.program.straight_line import Iteration, Program
from symscrew.runtime.compiled import find_compiler, load

pytestmark = pytest.mark.slow

MP = mpmath.mp.clone()
MP.dps = 40
Matrix = mpmath.matrix


# -- models ----------------------------------------------------------------------------------------------


def kinematic_model(mechanism: Mechanism, independent: Sequence[str] | None = None) -> Model:
    """The kinematic functions and the margins, by the same path as `derive`; no dynamics."""
    system = System(mechanism)
    system.use_samples()
    loops = Loops(system, independent)
    functions = [*kinematic_functions(system, Motion(system)), *closure_functions(system, loops, loop_notes(loops))]
    functions += [f for f in platform_functions(system, (), loops) if f.name == "inverse_kinematics"]
    programs: dict[str, Program | Iteration] = {f.name: lower(f) for f in [*functions, *margin_functions(system)]}
    if system.cuts:
        programs["assemble"] = assembly(system, loops).lowered()
    return Model(mechanism.name, mechanism, (), programs, {}, system)


@cache
def model(name: str) -> Model:
    return kinematic_model(catalogue.load(name))


# -- the oracle ------------------------------------------------------------------------------------------


@cache
def number(exact: sympy.Expr) -> object:
    return MP.mpf(str(exact.evalf(45)))


def numbers(mechanism: Mechanism, values: Sequence) -> list:
    return [number(mechanism.number(c)) for c in values]


def cross(a: Sequence, b: Sequence) -> list:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turned(axis: Sequence, angle: object, vector: Sequence) -> list:
    """Rodrigues' formula."""
    c, s = MP.cos(angle), MP.sin(angle)
    along = sum(a * x for a, x in zip(axis, vector, strict=True))
    return [c * x + s * y + (1 - c) * along * a for x, y, a in zip(vector, cross(axis, vector), axis, strict=True)]


def chain_screws(mechanism: Mechanism, joints: Sequence[str], values: dict[str, Sequence[float]]) -> Matrix:
    """Screws (omega ; v / length) of a chain from the ground, one column per freedom, at the given coordinates.

    The displacement of everything beyond a freedom is the product of exponentials of the freedoms before it. A
    spherical joint must be the last one.
    """
    length = MP.mpf(characteristic_length(mechanism))
    passed: list[tuple[str, list, list, object]] = []
    columns = []

    def placed(point: list, direction: bool) -> list:
        for kind, axis, through, amount in reversed(passed):
            if kind == "P":
                point = point if direction else [p + amount * a for p, a in zip(point, axis, strict=True)]
            else:
                arm = point if direction else [p - t for p, t in zip(point, through, strict=True)]
                arm = turned(axis, amount, arm)
                point = arm if direction else [p + t for p, t in zip(arm, through, strict=True)]
        return point

    for name in joints:
        joint = mechanism.joints[name]
        through = numbers(mechanism, joint.point)
        motions = JOINT_TYPES[joint.type].motions
        references = numbers(mechanism, joint.reference) if joint.reference else [0] * len(motions)
        for k, motion in enumerate(motions):
            if motion.kind == "S":
                centre = placed(through, False)
                for axis in ([1, 0, 0], [0, 1, 0], [0, 0, 1]):
                    columns.append([*axis, *(c / length for c in cross(centre, axis))])
                continue
            axis = numbers(mechanism, joint.axes[motion.axis or 0])
            here, at = placed(axis, True), placed(through, False)
            if motion.kind == "P":
                columns.append([0, 0, 0, *here])
            else:
                columns.append([*here, *(c / length for c in cross(at, here))])
            passed.append((motion.kind, axis, through, MP.mpf(float(values[name][k])) - references[k]))
    return MP.matrix(columns).T


def values_of(found: Model, q: np.ndarray) -> dict[str, list[float]]:
    tree = found.system.tree
    result: dict[str, list[float]] = {}
    for coordinate, value in zip(tree.q, q, strict=True):
        result.setdefault(coordinate.joint, []).append(float(value))
    return result


def labels(found: Model, function: str) -> tuple[str, ...]:
    return found.programs[function].outputs[0].labels


def margin(found: Model, function: str, q: np.ndarray, name: str | None = None) -> np.ndarray:
    """One margin at the states q (states, nq)."""
    names = labels(found, function)
    return output(found, function, "margins", q)[..., names.index(name) if name else 0]


def closure(found: Model, q: np.ndarray, *, locked: bool) -> np.ndarray:
    """The closure Jacobian without units, with or without the columns of the drives, at one state."""
    system = found.system
    length = system.length
    n = len(system.tree.v)
    jacobian = output(found, "closure_jacobian", "jacobian", q[None])[0].reshape(n, -1).T
    rows = [1 / length if row.unit == "N" else 1.0 for cut in system.cuts for row in cut.rows]
    columns = [length if c.kind == "length" else 1.0 for c in system.tree.v]
    scaled = jacobian * np.array(rows)[:, None] * np.array(columns)
    return np.delete(scaled, list(system.drive_rows()), axis=1) if locked else scaled


def smallest(matrix: np.ndarray, rank: int) -> float:
    """The singular value that must not vanish for the matrix to have this rank."""
    return float(np.linalg.svd(matrix, compute_uv=False)[rank - 1])


def root(value: Callable[[float], float], low: float, high: float) -> float:
    """Where a continuous function changes sign, by bisection; it must change sign."""
    a, b = value(low), value(high)
    assert a * b < 0, f"no change of sign: {a}, {b}"
    for _ in range(80):
        middle = 0.5 * (low + high)
        c = value(middle)
        low, high, a = (middle, high, c) if a * c > 0 else (low, middle, a)
    return 0.5 * (low + high)


def planar_loop(driven: Sequence[str] = ("A",), **joints: tuple[str, str, float, float]) -> Mechanism:
    """Revolute joints about y: name = (parent, child, x, z)."""
    builder = MechanismBuilder("planar_loop")
    for body in dict.fromkeys(body for parent, child, *_ in joints.values() for body in (parent, child)):
        if body != "base":
            builder.body(body)
    for name, (parent, child, x, z) in joints.items():
        builder.joint(name, "R", parent=parent, child=child, point=[x, 0, z], axes=[[0, 1, 0]], driven=name in driven)
    return builder.build()


# -- limbs -----------------------------------------------------------------------------------------------


def test_six_revolute_arm_is_the_determinant_of_its_screws() -> None:
    found = model("ur5")
    q = np.random.default_rng(1).uniform(-3, 3, (8, 6))
    got = margin(found, "limb_margins", q)
    signs = set()
    for state, value in zip(q, got, strict=True):
        exact = MP.det(chain_screws(found.mechanism, found.mechanism.limbs["arm"].joints, values_of(found, state)))
        assert abs(abs(exact) - abs(value)) < 1e-14
        signs.add(bool(exact * value > 0))
    assert len(signs) == 1  # the same determinant but for one sign


def test_wrist_and_elbow_of_the_six_revolute_arm() -> None:
    """Zero with the wrist's axes 4 and 6 parallel, and with the arm stretched; the sign changes through both."""
    found = model("ur5")
    base = np.array([0.3, -1.1, 1.4, -0.7, 0.9, 0.2])
    for joint in (2, 4):
        q = np.repeat(base[None], 3, axis=0)
        q[:, joint] = (-1e-3, 0.0, 1e-3)
        below, at, above = margin(found, "limb_margins", q)
        assert abs(at) < 1e-15 and below * above < 0 and min(abs(below), abs(above)) > 1e-6
        screws = chain_screws(found.mechanism, found.mechanism.limbs["arm"].joints, values_of(found, q[1]))
        assert min(MP.svd_r(screws, compute_uv=False)) < 1e-30


def test_seven_revolute_arm_is_squared() -> None:
    """det(J J^T): with seven joints rank is lost where two conditions meet, so no sign can change there."""
    found = model("panda")
    q = np.random.default_rng(2).uniform(-2, 2, (5, 7))
    for state, value in zip(q, margin(found, "limb_margins", q), strict=True):
        screws = chain_screws(found.mechanism, found.mechanism.limbs["arm"].joints, values_of(found, state))
        assert abs(MP.det(screws * screws.T) - value) < 1e-13 * max(1.0, value)
    stretched = q[:1].copy()
    stretched[0, 3] = stretched[0, 5] = 0.0
    stretched[0, 1] = 0.0
    screws = chain_screws(found.mechanism, found.mechanism.limbs["arm"].joints, values_of(found, stretched[0]))
    assert min(MP.svd_r(screws, compute_uv=False)) < 1e-30  # singular by the oracle
    assert 0 <= margin(found, "limb_margins", stretched)[0] < 1e-25


@pytest.mark.parametrize("name", ["stewart_6ups", "three_ups_upu_s"])
def test_ups_limbs_are_determinants(name: str) -> None:
    found = model(name)
    q = found.system.sample_states[0][:3]
    for limb, data in found.mechanism.limbs.items():
        if [found.mechanism.joints[j].type for j in data.joints] != ["U", "P", "S"]:
            continue
        for state, value in zip(q, margin(found, "limb_margins", q, limb), strict=True):
            exact = MP.det(chain_screws(found.mechanism, data.joints, values_of(found, state)))
            assert abs(abs(exact) - abs(value)) < 1e-13


def test_a_leg_along_the_first_axis_of_its_universal_joint_is_singular() -> None:
    found = model("stewart_6ups")
    column = labels_of_q(found).index("leg1_U.1")

    def value(angle: float) -> float:
        q = found.system.reference.copy()
        q[column] = angle
        return float(margin(found, "limb_margins", q[None], "leg1")[0])

    angle = root(value, 0.0, 3.0)
    assert value(angle - 0.1) * value(angle + 0.1) < 0
    q = found.system.reference.copy()
    q[column] = angle
    screws = chain_screws(found.mechanism, found.mechanism.limbs["leg1"].joints, values_of(found, q))
    assert min(MP.svd_r(screws, compute_uv=False)) < 1e-14
    axis, leg = screws[:3, 0], screws[3:, 2]
    assert abs(abs((axis.T * leg)[0]) - 1) < 1e-14  # the leg lies along the first axis


def labels_of_q(found: Model) -> list[str]:
    return [c.label for c in found.system.tree.q]


def test_planar_limb_changes_sign_where_it_is_stretched() -> None:
    found = model("planar_3rrr")
    column = labels_of_q(found).index("limb1_R2")
    q = np.repeat(found.system.reference[None], 200, axis=0)
    q[:, column] = np.linspace(-np.pi, np.pi, 200, endpoint=False)
    values = margin(found, "limb_margins", q, "limb1")
    assert (np.sign(values) != np.sign(np.roll(values, 1))).sum() == 2  # stretched and folded, once each
    sizes = [np.linalg.norm(p) for p in (values.max(), values.min())]
    assert sizes[0] == pytest.approx(sizes[1], rel=1e-3)  # l1 l2 sin


# -- constraints ------------------------------------------------------------------------------------------


def tilted_seed(found: Model, angle: float) -> np.ndarray:
    """The seed with its platform turned about y through O: consistent by symmetry."""
    pose = np.array([[np.cos(angle / 2), 0.0, np.sin(angle / 2), 0.0]])
    return output(found, "inverse_kinematics", "q", pose)


def test_constraint_singularity_of_the_seed_where_leg_length_is_r_sine_theta() -> None:
    """The locus L = R sin(theta) that the paper does not mention, reached by turning the platform about y."""
    found = model("three_ups_upu_s")
    names = labels_of_q(found)

    def leg(angle: float) -> float:
        """L - R sin(theta) of the leg from A1 = (-0.8, 0, 0) to C1, from the geometry."""
        x, z = -0.5, 0.3 * np.sqrt(3)
        c = np.array([np.cos(angle) * x + np.sin(angle) * z, -np.sin(angle) * x + np.cos(angle) * z])
        r = c - np.array([-0.8, 0.0])
        return float(np.linalg.norm(r) - 0.8 * r[0] / np.linalg.norm(r))

    def value(angle: float) -> float:
        return float(margin(found, "constraint_margin", tilted_seed(found, angle))[0])

    for angle in (-0.2, 0.0, 0.15):
        assert value(angle) == pytest.approx(leg(angle) / characteristic_length(found.mechanism), abs=1e-13)
    low, high = (0.0, -0.6) if leg(-0.6) < 0 else (0.0, 0.6)
    at = root(value, low, high)
    assert abs(leg(at)) < 1e-13 and value(high) < 0 < value(low)
    q = tilted_seed(found, at)[0]
    assert smallest(closure(found, q, locked=False), 13) < 1e-13  # the closure has lost a rank
    assert smallest(closure(found, q, locked=False), 12) > 1e-3
    for limb in found.mechanism.limbs:
        assert abs(margin(found, "limb_margins", q[None], limb)[0]) > 0.01, "no limb is singular there"
    assert names[:3] == ["limb1_U.0", "limb1_U.1", "limb1_P"]


@pytest.mark.parametrize("name", ["four_bar", "five_bar"])
def test_constraint_margin_of_a_planar_loop_is_the_gram_determinant_of_its_closure(name: str) -> None:
    found = model(name)
    for state in found.system.sample_states[0]:
        rows = closure(found, state, locked=False)
        rows = rows[np.abs(rows).max(axis=1) > 1e-12]
        value = margin(found, "constraint_margin", state[None])[0]
        assert value == pytest.approx(np.linalg.det(rows @ rows.T), rel=1e-10)


def test_four_bar_with_all_links_in_line_loses_its_closure() -> None:
    """A parallelogram folded flat is at its change point: the closure has rank 1 and two freedoms appear."""
    found = kinematic_model(
        planar_loop(
            A=("base", "crank", 0, 0),
            B=("crank", "coupler", 0, 1),
            C=("coupler", "rocker", 2, 1),
            D=("base", "rocker", 2, 0),
        )
    )
    q = np.zeros((1, 3))
    standing = margin(found, "constraint_margin", q)[0]
    joints = labels_of_q(found)
    q[0, joints.index("A")], q[0, joints.index("D")], q[0, joints.index("B")] = np.pi / 2, np.pi / 2, -np.pi / 2
    assert standing > 0.1 and 0 <= margin(found, "constraint_margin", q)[0] < 1e-25
    rows = closure(found, q[0], locked=False)
    assert smallest(rows, 2) < 1e-14 < smallest(rows, 1)


# -- actuation --------------------------------------------------------------------------------------------


def hexapod_of_free_legs() -> Model:
    """Six legs S-P-S that can spin about themselves, from the reference data."""
    return kinematic_model(reference_mechanisms.build(reference_mechanisms.ENTRIES["stewart_6sps"]))


@pytest.mark.slow
@pytest.mark.parametrize("spinning", [False, True])
def test_hexapod_is_the_determinant_of_its_leg_lines(spinning: bool) -> None:
    """Pluecker coordinates of the six legs: forces along them at the platform's points; spins do not matter."""
    found = hexapod_of_free_legs() if spinning else model("stewart_6ups")
    length = found.system.length
    joints = list(found.mechanism.joints)
    ends = [(limb.joints[0], limb.joints[-1]) for limb in found.mechanism.limbs.values()]
    states = found.system.sample_states[0]
    points = output(found, "joint_points", "points", states).reshape(len(states), -1, 3)
    for state, at, value in zip(states, points, margin(found, "actuation_margins", states), strict=True):
        lines = []
        for first, last in ends:
            foot, head = at[joints.index(first)], at[joints.index(last)]
            along = (head - foot) / np.linalg.norm(head - foot)
            lines.append([*along, *np.cross(head, along) / length])
        assert abs(value) == pytest.approx(abs(np.linalg.det(lines)), rel=1e-11)
        assert len(state) == len(found.system.tree.q)


def test_hexapod_is_singular_turned_by_ninety_degrees() -> None:
    """E. F. Fichter, Int. J. Robotics Research 5 (1986) 157-182: rotation by +-90 degrees about the normal."""
    found = model("stewart_6ups")

    def state(yaw: float) -> np.ndarray:
        pose = np.array([[0.0, 0.0, 1.0, np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)]])
        return output(found, "inverse_kinematics", "q", pose)

    def value(yaw: float) -> float:
        return float(margin(found, "actuation_margins", state(yaw))[0])

    for sign in (-1, 1):
        assert root(value, sign * 1.0, sign * 2.0) == pytest.approx(sign * np.pi / 2, abs=1e-12)
    q = state(np.pi / 2)
    assert abs(value(np.pi / 2)) < 1e-14
    assert smallest(closure(found, q[0], locked=True), 18) < 1e-14
    assert np.abs(output(found, "limb_margins", "margins", q)).min() > 0.1


@pytest.mark.parametrize(
    "name, factors",
    [
        ("stewart_6ups", ["leg1", "leg2", "leg3", "leg4", "leg5", "leg6"]),
        slow("delta", ["rod1a_S", "rod1b_S", "rod2a_S", "rod2b_S", "rod3a_S", "rod3b_S"]),
        ("andrews", ["E3", "E4", "E6"]),
    ],
)
def test_kinds_are_factors_of_the_closure_with_locked_drives(name: str, factors: list[str]) -> None:
    """det of the passive columns = product of the limbs' margins and the actuation margin: they are kept apart."""
    found = model(name)
    for state in found.system.sample_states[0]:
        passive = closure(found, state, locked=True)
        passive = passive[np.abs(passive).max(axis=1) > 1e-12]
        limbs = np.prod([margin(found, "limb_margins", state[None], limb)[0] for limb in factors])
        expected = abs(np.linalg.det(passive))
        assert abs(limbs * margin(found, "actuation_margins", state[None])[0]) == pytest.approx(expected, rel=1e-10)


def test_five_bar_with_distal_rods_in_line_cannot_be_held_by_its_drives() -> None:
    mechanism = planar_loop(
        ("A", "E"),
        A=("base", "left", -0.2, 0), B=("left", "far_left", -0.3, 0.2), C=("far_left", "far_right", 0, 0.4),
        D=("right", "far_right", 0.3, 0.2), E=("base", "right", 0.2, 0),
    )  # fmt: skip
    found = kinematic_model(mechanism, ["A", "B"])
    q = found.system.reference[None]
    states = [q]
    for turn in np.linspace(0, 1.4, 57)[1:]:
        (q, *_), status = found("assemble", np.array([[-0.3 * turn, turn]]), q)
        if np.any(status):
            break
        states.append(q)
    values = np.array([margin(found, "actuation_margins", q)[0] for q in states])
    crossing = int(np.flatnonzero(values[:-1] * values[1:] < 0)[0])
    columns = [labels_of_q(found).index(k) for k in "AB"]
    start, end = states[crossing][0, columns], states[crossing + 1][0, columns]

    def state(part: float) -> np.ndarray:
        (q, *_), status = found("assemble", (start + part * (end - start))[None], states[crossing])
        assert np.all(status == 0)
        return q

    at = state(root(lambda part: float(margin(found, "actuation_margins", state(part))[0]), 0.0, 1.0))
    points = output(found, "joint_points", "points", at).reshape(-1, 3)
    b, c, d = points[1:4]
    assert np.linalg.norm(np.cross(c - b, c - d)) < 1e-12 and (c - b) @ (c - d) < 0  # stretched
    locked = closure(found, at[0], locked=True)
    assert smallest(locked, 2) < 1e-12 < smallest(locked, 1)
    assert margin(found, "constraint_margin", at)[0] > 1e-3


def test_four_bar_driven_at_its_rocker_sticks_where_crank_and_coupler_are_in_line() -> None:
    text = toml_file.to_toml(catalogue.load("four_bar")).replace("driven = [0]\n", "")
    text = text.replace("[joints.D]\n", "[joints.D]\ndriven = true\n")
    found = kinematic_model(toml_file.parse_description(text), ["A"])
    assert found.system.drives == (("D", 0),)
    previous = found.system.reference[None]
    states = [previous]
    for angle in np.linspace(0, 2 * np.pi, 61)[1:]:
        (previous, *_), status = found("assemble", np.array([[angle]]), previous)
        assert np.all(status == 0)
        states.append(previous)
    values = np.array([margin(found, "actuation_margins", q)[0] for q in states])
    crossings = np.flatnonzero(values[:-1] * values[1:] < 0)
    assert len(crossings) == 2  # stretched and folded
    names = list(found.mechanism.joints)
    start = states[crossings[0]]
    column = labels_of_q(found).index("A")

    def state(angle: float) -> np.ndarray:
        return found("assemble", np.array([[angle]]), start)[0][0]

    first, last = start[0, column], states[crossings[0] + 1][0, column]
    at = state(root(lambda a: float(margin(found, "actuation_margins", state(a))[0]), first, last))
    points = output(found, "joint_points", "points", at).reshape(-1, 3)
    a, b, c = (points[names.index(k)] for k in "ABC")
    assert np.linalg.norm(np.cross(b - a, c - b)) < 1e-12


def test_drives_of_the_seed_that_are_just_enough() -> None:
    """Two of four: each set's margin against the closure's rank; legs 1 and 3 alone never hold the platform."""
    found = model("three_ups_upu_s")
    names = labels(found, "actuation_margins")
    assert "limb1_P limb3_P" not in names and "limb2_P limb3_P" in names
    drives = {joint: column for column, joint in ((k, c.joint) for k, c in enumerate(found.system.tree.v)) if
              joint.endswith("_P")}  # fmt: skip
    for state in found.system.sample_states[0]:
        full = closure(found, state, locked=False)
        for name in names[1:]:
            locked = np.delete(full, [drives[j] for j in name.split()], axis=1)
            value = abs(margin(found, "actuation_margins", state[None], name)[0])
            assert (smallest(locked, 13) > 1e-9) == (value > 1e-9), name
        assert margin(found, "actuation_margins", state[None], "all drives")[0] > 0.1
    # in the reference pose legs 2 and 4 cannot hold the rotation about y; legs 2 and 3 can
    reference = found.system.reference[None]
    assert abs(margin(found, "actuation_margins", reference, "limb2_P limb4_P")[0]) < 1e-15
    assert abs(margin(found, "actuation_margins", reference, "limb2_P limb3_P")[0]) > 0.1


# -- of every mechanism ------------------------------------------------------------------------------------


def moved(mechanism: Mechanism, rotation: np.ndarray, shift: Sequence, factor: object) -> Mechanism:
    """The mechanism after a rigid motion (rational rotation matrix) and in another unit of length."""

    def point(at: Sequence) -> tuple:
        return tuple(factor * (sum(r * c for r, c in zip(row, at, strict=True)) + s)
                     for row, s in zip(rotation, shift, strict=True))  # fmt: skip

    def axis(along: Sequence) -> tuple:
        return tuple(sum(r * c for r, c in zip(row, along, strict=True)) for row in rotation)

    def joint(j):
        kinds = [m.kind for m in JOINT_TYPES[j.type].motions]
        references = tuple(r * factor if k == "P" else r for r, k in zip(j.reference, kinds, strict=False))
        return dataclasses.replace(j, point=point(j.point), axes=tuple(map(axis, j.axes)), reference=references)

    return dataclasses.replace(
        mechanism,
        bodies={n: dataclasses.replace(b, mass=None, com=None, inertia=None) for n, b in mechanism.bodies.items()},
        joints={n: joint(j) for n, j in mechanism.joints.items()},
        points={n: dataclasses.replace(p, at=point(p.at)) for n, p in mechanism.points.items()},
    )


@pytest.mark.parametrize("name", [slow("three_ups_upu_s"), slow("ur5"), "sarrus"])
def test_margins_know_neither_the_place_nor_the_unit(name: str) -> None:
    third = sympy.Rational(1, 3)
    rotation = [[2 * third, -third, 2 * third], [2 * third, 2 * third, -third], [-third, 2 * third, 2 * third]]
    original = moved(catalogue.load(name), np.eye(3, dtype=int).tolist(), (0, 0, 0), sympy.Integer(1))
    other = moved(catalogue.load(name), rotation, (3, -1, sympy.Rational(1, 2)), sympy.Integer(1000))
    first, second = kinematic_model(original), kinematic_model(other)
    q = first.system.reference
    scaled = second.system.reference
    for function in ("limb_margins", "constraint_margin", "actuation_margins"):
        if function not in first.programs:
            continue
        assert labels(first, function) == labels(second, function)
        one = output(first, function, "margins", q[None])
        two = output(second, function, "margins", scaled[None])
        assert np.allclose(np.abs(one), np.abs(two), rtol=3e-5, atol=1e-12)  # the length is rounded to 6 digits


@pytest.mark.parametrize("name", [slow(name) if name == "delta" else name for name in catalogue.names()])
def test_every_margin_is_defined_everywhere(name: str) -> None:
    """Finite with status 0 at the reference and anywhere, closed or not, singular or not; unit 1; named."""
    found = model(name)
    random = np.random.default_rng(3)
    q = np.tile(found.system.reference, (50, 1))  # quaternions stay of length one: others are no configuration
    q[1:] = found.system.advance(q[1:], random.uniform(-3, 3, (49, len(found.system.tree.v))))
    for kind in ("limb_margins", "constraint_margin", "actuation_margins"):
        program = found.programs.get(kind)
        if program is None:
            continue
        port = program.outputs[0]
        assert set(port.units) == {"1"} and len(set(port.labels)) == port.size
        assert not program.guards and program.operations["div"] == 0
        assert np.all(np.isfinite(output(found, kind, "margins", q)))


def test_which_mechanisms_have_which_margins() -> None:
    kinds = ("limb_margins", "constraint_margin", "actuation_margins")
    has = {name: tuple(k in model(name).programs for k in kinds) for name in ("ur5", "stewart_6ups", "delta")}
    assert has == {"ur5": (True, False, False), "stewart_6ups": (True, False, True), "delta": (True, True, True)}
    assert set(kinds) <= set(complete_model("four_bar").programs)


@pytest.mark.slow
@pytest.mark.parametrize(
    "backend", [pytest.param("c", marks=pytest.mark.skipif(not find_compiler(), reason="no C compiler here")), "casadi"]
)
def test_compiled_functions_give_the_same_values(backend: str) -> None:
    found = model("three_ups_upu_s")
    compiled = load(found, backend=backend)
    states = found.system.sample_states[0]
    for kind in ("limb_margins", "constraint_margin", "actuation_margins"):
        got = compiled[kind](states)
        assert np.allclose(got, output(found, kind, "margins", states), rtol=1e-12, atol=1e-15)


def test_derivatives_are_finite_at_the_singularity() -> None:
    casadi = pytest.importorskip("casadi")
    from symscrew.export.casadi import casadi_functions

    found = model("stewart_6ups")
    function = casadi_functions(found)["actuation_margins"]
    pose = np.array([[0.0, 0.0, 1.0, np.cos(np.pi / 4), 0.0, 0.0, np.sin(np.pi / 4)]])
    q = output(found, "inverse_kinematics", "q", pose)[0]
    x = casadi.SX.sym("x", len(q))
    slope = np.array(casadi.Function("slope", [x], [casadi.jacobian(function(x)[0], x)])(q))
    assert abs(margin(found, "actuation_margins", q[None])[0]) < 1e-14
    assert np.all(np.isfinite(slope)) and np.abs(slope).max() > 0.1


@pytest.mark.parametrize(("driven", "regular"), [("A", True), ("C1", False)])
def test_a_link_that_moves_alone_is_named_and_no_singularity_unless_the_drive_moves_nothing_else(
    driven: str, regular: bool
) -> None:
    """A four-bar with a link between two hinges about one line: its turn stays with the crank locked, by no defect."""
    builder = MechanismBuilder("idle", platform="rocker")
    for body in ("crank", "coupler", "link", "rocker"):
        builder.body(body)
    ends = {"A": ("base", "crank", [0, 0]), "B": ("crank", "coupler", [1, 2]), "C1": ("coupler", "link", [5, 4]),
            "C2": ("link", "rocker", [5, 4]), "D": ("base", "rocker", [6, 0])}  # fmt: skip
    for name, (parent, child, at) in ends.items():
        builder.joint(name, "R", parent=parent, child=child, point=[*at, 0], axes=[[0, 0, 1]], driven=name == driven)
    builder.limb("arm", joints=["A", "B", "C1", "C2"])
    found = analyse_mobility(builder.build())
    margins = {margin.kind: margin for margin in found.singularities.margins or ()}
    assert found.dof_drives_locked == 1 and margins["actuation"].regular is regular
    assert "a passive freedom between C1 and C2" in margins["limb"].note
    values = mobility_values(found)
    assert values["passive_freedoms"] == [["C1", "C2"]] and values["passive_spins"] == []
    assert "Links that move alone between their joints: C1 and C2" in mobility_text(found, full=True)
