"""Forward dynamics by Pinocchio of trees and of platforms whose limbs are closed by rigid constraints.

The universal joint of a limb is closed by two further revolute joints with an inertia of 1e-9 kg m^2 and a constraint
of six rows, a spherical one by a constraint of three; the proximal solver agrees with exact accelerations to 1e-4.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.model import Model
from symscrew.studies.benchmark.pinocchio_build import python_model
from symscrew.studies.benchmark.pinocchio_tree import PinocchioTree, triad

Array = np.ndarray
SMALL = 1e-9  # kg m^2, of joints that stand in for a universal one: not felt, and not 0, which would be singular
PROXIMAL = 2e-4  # relative: its proximal solver leaves 1e-4; what is farther off is another mechanism


def less_overhead(
    call: Callable[..., Any], rows: Sequence[tuple[Any, ...]], least: Callable[[], Any]
) -> Callable[[], float]:
    """ns per call of all rows less the time of the smallest call; both the least of three, or noise would be left."""

    def once() -> tuple[float, float]:
        start = time.perf_counter()
        for row in rows:
            call(*row)
        middle = time.perf_counter()
        for _ in rows:
            least()
        return middle - start, time.perf_counter() - middle

    def measure() -> float:
        laps = [once() for _ in range(3)]
        whole, overhead = min(lap[0] for lap in laps), min(lap[1] for lap in laps)
        return (whole - overhead) * 1e9 / len(rows)

    return measure


def serial(tree: PinocchioTree, states: tuple[Array, Array, Array]) -> tuple[Callable[[], float], Array]:
    """ns per ABA at (q, v, u) of our tree, and its accelerations in Pinocchio's order."""
    import pinocchio

    made = python_model(pinocchio, tree, len(tree.elements))
    data = made.createData()
    rows = [(made, data, *row) for row in zip(*tree.states(*states), strict=True)]
    result = np.array([np.array(pinocchio.aba(*row)) for row in rows])
    return less_overhead(pinocchio.aba, rows, _least(pinocchio)), result


def closed(
    found: Model, tree: PinocchioTree, states: tuple[Array, Array], u: Array
) -> tuple[Callable[[], float], Array]:
    """ns per constraintDynamics at (q, v) of our tree and drives u; its accelerations in Pinocchio's order."""
    import pinocchio

    chain = _closed_model(pinocchio, found, tree)
    made, data = chain.model, chain.model.createData()
    q_tree, v_tree, _ = tree.states(*states, np.zeros_like(states[1]))
    sphere = made.nq - made.nv  # the platform's quaternion comes first
    q, v, tau = np.zeros((len(u), made.nq)), np.zeros((len(u), made.nv)), np.zeros((len(u), made.nv))
    q[:, [*range(sphere), *(k + sphere for k in chain.tree)]] = q_tree
    v[:, chain.tree], tau[:, chain.drives] = v_tree, u
    _follow(pinocchio, chain, q, v)
    infos = pinocchio.StdVec_RigidConstraintData()
    for constraint in chain.constraints:
        infos.append(constraint.createData())
    pinocchio.initConstraintDynamics(made, data, chain.constraints, infos)
    settings = pinocchio.ProximalSettings(1e-10, 1e-8, 20)

    def dynamics(*row: Array) -> Array:
        found: Array = pinocchio.constraintDynamics(made, data, *row, chain.constraints, infos, settings)
        return found

    rows = list(zip(q, v, tau, strict=True))
    result = np.array([np.array(dynamics(*row)) for row in rows])[:, chain.tree]
    return less_overhead(dynamics, rows, _least(pinocchio)), result


def _least(pinocchio: Any) -> Callable[[], Any]:
    """The smallest call: forward dynamics of one joint."""
    made = pinocchio.Model()
    made.addJoint(0, pinocchio.JointModelRZ(), pinocchio.SE3.Identity(), "one")
    made.appendBodyToJoint(1, pinocchio.Inertia(1.0, np.zeros(3), np.eye(3)), pinocchio.SE3.Identity())
    data, zero = made.createData(), np.zeros(1)
    return lambda: pinocchio.aba(made, data, zero, zero, zero)


@dataclass(frozen=True)
class Chain:
    """A closed chain for Pinocchio: where in its v the tree's rates, the further joints and the drives stand.

    `further`: per constraint of six rows, the joints that stand in for its universal joint.
    """

    model: Any
    constraints: Any
    tree: list[int]
    further: dict[int, list[int]]
    drives: list[int]


def _closed_model(pinocchio: Any, found: Model, tree: PinocchioTree) -> Chain:
    """The tree with two light revolute joints in place of a cut universal joint, branch by branch, and constraints."""
    made = pinocchio.Model()
    kinds = {"R": pinocchio.JointModelRZ, "P": pinocchio.JointModelPZ, "S": pinocchio.JointModelSpherical}
    kinds["free"] = pinocchio.JointModelFreeFlyer
    cut_at = {cut.tip: cut for cut in tree.cuts}
    number, listed = {0: 0}, []
    kept: list[int] = []
    further: dict[int, list[int]] = {}
    for k, line in enumerate(tree.text.splitlines()[1 : 1 + len(tree.elements)], 1):
        kind, parent, *rest = line.split()
        x = np.array([float(entry) for entry in rest])
        place = pinocchio.SE3(x[:9].reshape(3, 3), x[9:12])
        kept += range(made.nv, made.nv + len(tree.elements[k - 1].v))
        number[k] = made.addJoint(number[int(parent)], kinds[kind](), place, f"joint{k}")
        inertia = pinocchio.Inertia.Zero()  # its constructor refuses rods, whose least moment is rounded below zero
        inertia.mass, inertia.lever, inertia.inertia = x[12], x[13:16], x[16:25].reshape(3, 3)
        made.appendBodyToJoint(number[k], inertia, pinocchio.SE3.Identity())
        cut = cut_at.get(k)
        if cut is None:
            continue
        (axes, origin), (hub_axes, hub_origin) = tree.frame(cut.tip), tree.frame(cut.hub)
        first = pinocchio.SE3(axes.T, axes.T @ (cut.point - origin))
        second = pinocchio.SE3(hub_axes.T, hub_axes.T @ (cut.point - hub_origin))
        if len(cut.axes) != 2:
            listed.append((pinocchio.ContactType.CONTACT_3D, number[k], first, cut.hub, second))
            continue
        joint, place, before = number[k], first, np.eye(3)
        for axis in cut.axes:
            frame = triad(axis)
            further.setdefault(len(listed), []).append(made.nv)
            at = place * pinocchio.SE3(before.T @ frame, np.zeros(3))
            joint = made.addJoint(joint, pinocchio.JointModelRZ(), at, f"universal{made.nv}")
            light = pinocchio.Inertia(0.0, np.zeros(3), SMALL * np.eye(3))
            made.appendBodyToJoint(joint, light, pinocchio.SE3.Identity())
            place, before = pinocchio.SE3.Identity(), frame
        listed.append((pinocchio.ContactType.CONTACT_6D, joint, pinocchio.SE3(before.T, np.zeros(3)), cut.hub, second))
    constraints = pinocchio.StdVec_RigidConstraintModel()
    local = pinocchio.ReferenceFrame.LOCAL
    for kind, one, first, hub, second in listed:
        constraints.append(pinocchio.RigidConstraintModel(kind, made, one, first, number[hub], second, local))
    rates = [int(k) for element in tree.elements for k in element.v]
    indices = [rates.index(found.system.tree.velocity_indices(joint)[f]) for joint, f in found.system.drives]
    return Chain(made, constraints, kept, further, [kept[k] for k in indices])


def _follow(pinocchio: Any, chain: Chain, q: Array, v: Array) -> None:
    """Angles and rates of the further joints from the poses that they must bridge; changes q and v in place."""
    made, data = chain.model, chain.model.createData()
    sphere = made.nq - made.nv
    for which, at in chain.further.items():
        closing = chain.constraints[which]
        for row, rates in zip(q, v, strict=True):
            for _ in range(20):
                pinocchio.forwardKinematics(made, data, row)
                pinocchio.computeJointJacobians(made, data, row)
                first = data.oMi[closing.joint1_id] * closing.joint1_placement
                second = data.oMi[closing.joint2_id] * closing.joint2_placement
                gap = pinocchio.log6(first.actInv(second)).vector
                jacobian = _relative(pinocchio, made, data, closing)
                if np.abs(gap[3:]).max() < 1e-13:
                    break
                row[[k + sphere for k in at]] += np.linalg.lstsq(jacobian[3:, at], gap[3:], rcond=None)[0]
            rates[at] = np.linalg.lstsq(jacobian[:, at], -jacobian[:, chain.tree] @ rates[chain.tree], rcond=None)[0]


def _relative(pinocchio: Any, made: Any, data: Any, closing: Any) -> Array:
    """Jacobian of the first frame of a constraint relative to the second, in the first."""
    first = data.oMi[closing.joint1_id] * closing.joint1_placement
    world = pinocchio.ReferenceFrame.WORLD
    one, two = (pinocchio.getJointJacobian(made, data, k, world) for k in (closing.joint1_id, closing.joint2_id))
    return np.asarray(first.toActionMatrixInverse() @ (one - two))
