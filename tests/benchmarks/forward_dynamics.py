"""Time of the generated forward dynamics against Pinocchio and MuJoCo, after the accelerations have agreed.

Pinocchio and MuJoCo are called from Python; the time of the same call on a model with a single joint is taken off, so
that the call itself does not count. Pinocchio closes the universal joint of the seed's first limb by two further
revolute joints with an inertia of 1e-9 kg m^2 and a rigid constraint of six rows; its proximal solver agrees to 1e-4.
MuJoCo's constraints are soft: its accelerations are not those of a rigid closed chain, and only its time is given.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue, interchange
from symscrew.compiled import load
from symscrew.model import Model, derive
from symscrew.timing import Times, interleaved

from .inverse_dynamics import generated
from .pinocchio_build import python_model
from .pinocchio_tree import PinocchioTree, pinocchio_tree
from .states import consistent_states
from .tables import table

Array = np.ndarray
STATES = 64
AGREEMENT = {"three_ups_upu_s_physical": 2e-4, "panda": 1e-9}
OURS = "symscrew"
SMALL = 1e-9


def run(*, repeats: int = 25) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    rows, raw = [], {}
    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
        for name in AGREEMENT:
            times, agreement = _case(name, Path(folder), repeats)
            raw[name] = {"times": {k: t.as_json() for k, t in times.items()}, "agreement": agreement}
            for variant, found in times.items():
                ratio = f"{found.median / times[OURS].median:.1f}"
                said = f"{agreement[variant]:.0e}" if variant in agreement else ""
                rows.append([name, variant, f"{found.least:.3g}", found.text, ratio, said])
    header = ["mechanism", "forward dynamics by", "least ns", "median ns (quartiles)", "times ours", "difference"]
    return f"{STATES} states each, {repeats} interleaved repeats.\n\n{table(header, rows)}", {"cases": raw}


def _case(name: str, folder: Path, repeats: int) -> tuple[dict[str, Times], dict[str, float]]:
    import pinocchio

    model = derive(catalogue.load(name))
    q, v, a = consistent_states(model, load(model), STATES)
    (u,), status = model("inverse_dynamics", q, v, a)
    assert not status.any()
    measure, found = generated(model, folder, (q, v, u), "forward_dynamics")
    measures: dict[str, Callable[[], float]] = {OURS: measure}
    tree = pinocchio_tree(model.mechanism)
    agreement = {OURS: float(np.abs(found - a).max() / np.abs(a).max())}
    pairs = _closed(pinocchio, model, tree, (q, v, a), u) if tree.cuts else _serial(pinocchio, tree, (q, v, a), u)
    wanted = tree.states(q, v, a)[2]
    for variant, (timed, result) in pairs.items():
        measures[variant] = timed
        agreement[variant] = float(np.abs(result - wanted).max() / np.abs(wanted).max())
        if not agreement[variant] < AGREEMENT[name]:
            raise RuntimeError(f"{name}: {variant} differs by {agreement[variant]:.1e}; nothing to compare")
    measures["MuJoCo: mj_forward"] = _mujoco(model, folder)
    return interleaved(measures, repeats), agreement


Timed = dict[str, tuple[Callable[[], float], Array]]


def _less_overhead(call: Callable[..., Any], rows: list[tuple], least: Callable[[], Any]) -> Callable[[], float]:
    """ns per call of all rows less the time of the smallest call."""

    def measure() -> float:
        start = time.perf_counter()
        for row in rows:
            call(*row)
        middle = time.perf_counter()
        for _ in rows:
            least()
        return ((middle - start) - (time.perf_counter() - middle)) * 1e9 / len(rows)

    return measure


def _serial(pinocchio: Any, tree: PinocchioTree, states: tuple[Array, ...], u: Array) -> Timed:
    made = python_model(pinocchio, tree, len(tree.elements))
    data = made.createData()
    q, v, _ = tree.states(*states)
    rows = [(made, data, *row) for row in zip(q, v, u, strict=True)]
    result = np.array([np.array(pinocchio.aba(*row)) for row in rows])
    return {"Pinocchio: aba": (_less_overhead(pinocchio.aba, rows, _least(pinocchio)), result)}


def _closed(pinocchio: Any, model: Model, tree: PinocchioTree, states: tuple[Array, ...], u: Array) -> Timed:
    closed = _closed_model(pinocchio, model, tree)
    made, data = closed.model, closed.model.createData()
    q_tree, v_tree, _ = tree.states(*states)
    sphere = made.nq - made.nv  # the platform's quaternion comes first
    q, v, tau = np.zeros((len(u), made.nq)), np.zeros((len(u), made.nv)), np.zeros((len(u), made.nv))
    q[:, [*range(sphere), *(k + sphere for k in closed.tree)]] = q_tree
    v[:, closed.tree], tau[:, closed.drives] = v_tree, u
    _follow(pinocchio, closed, q, v, sphere)
    infos = pinocchio.StdVec_RigidConstraintData()
    for constraint in closed.constraints:
        infos.append(constraint.createData())
    pinocchio.initConstraintDynamics(made, data, closed.constraints, infos)
    settings = pinocchio.ProximalSettings(1e-10, 1e-8, 20)

    def dynamics(*row: Array) -> Array:
        return pinocchio.constraintDynamics(made, data, *row, closed.constraints, infos, settings)

    rows = list(zip(q, v, tau, strict=True))
    found = np.array([np.array(dynamics(*row)) for row in rows])[:, closed.tree]
    return {"Pinocchio: constraintDynamics": (_less_overhead(dynamics, rows, _least(pinocchio)), found)}


def _least(pinocchio: Any) -> Callable[[], Any]:
    """The smallest call: forward dynamics of one joint."""
    made = pinocchio.Model()
    made.addJoint(0, pinocchio.JointModelRZ(), pinocchio.SE3.Identity(), "one")
    made.appendBodyToJoint(1, pinocchio.Inertia(1.0, np.zeros(3), np.eye(3)), pinocchio.SE3.Identity())
    data, zero = made.createData(), np.zeros(1)
    return lambda: pinocchio.aba(made, data, zero, zero, zero)


@dataclass(frozen=True)
class Closed:
    """A closed chain for Pinocchio: where in its v the tree's rates and the further joints stand."""

    model: Any
    constraints: Any
    tree: list[int]
    further: list[int]
    drives: list[int]


def _closed_model(pinocchio: Any, found: Model, tree: PinocchioTree) -> Closed:
    """The tree with two light revolute joints in place of a cut universal joint, branch by branch, and constraints."""
    made = pinocchio.Model()
    kinds = {"R": pinocchio.JointModelRZ, "P": pinocchio.JointModelPZ, "S": pinocchio.JointModelSpherical}
    cut_at = {cut.tip: cut for cut in tree.cuts}
    number, kept, further, listed = {0: 0}, [], [], []
    for k, line in enumerate(tree.text.splitlines()[1 : 1 + len(tree.elements)], 1):
        kind, parent, *rest = line.split()
        x = np.array([float(entry) for entry in rest])
        place = pinocchio.SE3(x[:9].reshape(3, 3), x[9:12])
        kept += range(made.nv, made.nv + len(tree.elements[k - 1].v))
        number[k] = made.addJoint(number[int(parent)], kinds[kind](), place, f"joint{k}")
        inertia = pinocchio.Inertia(x[12], x[13:16], x[16:25].reshape(3, 3))
        made.appendBodyToJoint(number[k], inertia, pinocchio.SE3.Identity())
        cut = cut_at.get(k)
        if cut is None:
            continue
        (axes, origin), (hub_axes, hub_origin) = tree._frame(cut.tip), tree._frame(cut.hub)
        first = pinocchio.SE3(axes.T, axes.T @ (cut.point - origin))
        second = pinocchio.SE3(hub_axes.T, hub_axes.T @ (cut.point - hub_origin))
        if len(cut.axes) != 2:
            listed.append((pinocchio.ContactType.CONTACT_3D, number[k], first, cut.hub, second))
            continue
        joint, place, before = number[k], first, np.eye(3)
        for axis in cut.axes:
            frame = _triad(axis)
            further.append(made.nv)
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
    return Closed(made, constraints, kept, further, [kept[k] for k in indices])


def _follow(pinocchio: Any, closed: Closed, q: Array, v: Array, sphere: int) -> None:
    """Angles and rates of the further joints from the poses that they must bridge."""
    made, data, at = closed.model, closed.model.createData(), closed.further
    if not at:
        return
    closing = next(c for c in closed.constraints if c.type == pinocchio.ContactType.CONTACT_6D)
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
        rates[at] = np.linalg.lstsq(jacobian[:, at], -jacobian[:, closed.tree] @ rates[closed.tree], rcond=None)[0]


def _relative(pinocchio: Any, made: Any, data: Any, closing: Any) -> Array:
    """Jacobian of the first frame of a constraint relative to the second, in the first."""
    first = data.oMi[closing.joint1_id] * closing.joint1_placement
    world = pinocchio.ReferenceFrame.WORLD
    one, two = (pinocchio.getJointJacobian(made, data, k, world) for k in (closing.joint1_id, closing.joint2_id))
    return np.asarray(first.toActionMatrixInverse() @ (one - two))


def _triad(axis: Array) -> Array:
    first = np.cross(np.eye(3)[np.abs(axis).argmin()], axis)
    first /= np.linalg.norm(first)
    return np.column_stack([first, np.cross(axis, first), axis])


def _mujoco(model: Model, folder: Path) -> Callable[[], float]:
    import mujoco

    path = folder / f"{model.name}.xml"
    interchange.save(model.mechanism, path)
    made = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(made)
    least = mujoco.MjModel.from_xml_string(
        "<mujoco><worldbody><body><joint/><geom size='0.1'/></body></worldbody></mujoco>"
    )
    small = mujoco.MjData(least)
    data.qvel[:] = 0.01
    rows: list[tuple] = [(made, data)] * STATES
    return _less_overhead(mujoco.mj_forward, rows, lambda: mujoco.mj_forward(least, small))
