"""Other libraries on the same states, through importers of what we export: URDF for Pinocchio, MJCF for MuJoCo.

Open chains of revolute and prismatic joints agree to rounding. Platforms on limbs are closed in Pinocchio by constraint
models whose proximal solver is exact to 1e-4, and their inverse dynamics are written in C++ on its algorithms. MuJoCo's
closed chains are soft: its accelerations differ by what is stated, and nothing is required of them.
"""

from __future__ import annotations

import ctypes
import importlib.util
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from symscrew.effects import Gravity
from symscrew.formats import text_of
from symscrew.reference import BodyState
from symscrew.studies.benchmark.floating_base import columns, comparable, from_pinocchio, to_pinocchio, turned
from symscrew.studies.benchmark.timed_code import Compiled, pointers, states

if TYPE_CHECKING:
    from symscrew.model import Model

INSTALL = "pip install 'symscrew[benchmark]'"
EXACT = 1e-9  # largest relative difference between libraries that compute the same: rounding leaves less


@dataclass(frozen=True)
class Peer:
    """How to time another library, its results and what they are compared with; `limit` None: not required to agree."""

    measure: Callable[[], float]
    results: np.ndarray
    expected: np.ndarray
    limit: float | None = EXACT


Found = Mapping[str, Peer]


def _obstacle(compiled: Compiled, name: str, known: Sequence[str], package: str) -> str | None:
    """Why there is nothing to compare, if so."""
    if importlib.util.find_spec(package) is None:
        return f"not installed: {INSTALL}"
    if name not in known:
        return f"it has no function of this kind; expected {' or '.join(known)}"
    if compiled.model.effects != (Gravity(),):
        return "compared under usual gravity and no other effect only"
    if compiled.model.mechanism.couplings:
        return "mechanisms with couplings of coordinates are not compared: the others have none, or soft ones"
    if not compiled.model.system.cuts and not comparable(compiled.whole):
        return (
            "open chains are compared if their joints are driven R and P joints, or fixed, on the ground or a free base"
        )
    return None


def pinocchio(compiled: Compiled, name: str, expected: tuple[np.ndarray, ...]) -> Found | str:
    """RNEA, ABA and CRBA of the Python package, less the time of the same calls for a chain of one joint."""
    known = {"inverse_dynamics": "rnea", "forward_dynamics": "aba", "mass_matrix": "crba"}
    reason = _obstacle(compiled, name, list(known)[: 2 if compiled.model.system.cuts else 3], "pinocchio")
    if reason:
        return reason
    if compiled.model.system.cuts:
        return _closed_in_pinocchio(compiled, name, expected[0])
    import pinocchio as library

    made = library.buildModelFromXML(text_of(compiled.model.mechanism, ".urdf"))
    least = library.buildSampleModelManipulator()
    joint = library.Model()
    index = joint.addJoint(0, library.JointModelRZ(), library.SE3.Identity(), "one")
    joint.appendBodyToJoint(index, least.inertias[1], library.SE3.Identity())
    listed = columns(compiled.whole)
    q = states(compiled.model, name, len(expected[0]))[0]
    arrays, order = _tree_in_pinocchio(made, compiled, name, len(expected[0]))
    rows = list(zip(*arrays, strict=True))
    first = [tuple(x[:1] for x in row) for row in rows]
    call = getattr(library, known[name])
    data, small = made.createData(), joint.createData()
    results = np.array([np.array(call(made, data, *row)) for row in rows])
    if name == "mass_matrix":
        results = np.triu(results) + np.triu(results, 1).swapaxes(1, 2)
        results = results[:, order][:, :, order]
        to_theirs = turned(q, listed)
        results = to_theirs.swapaxes(1, 2) @ results @ to_theirs
        results = results.swapaxes(1, 2).reshape(len(rows), -1)
    else:
        results = results[:, order]
        for column in (c for c in listed if c.free):
            if name == "forward_dynamics":
                results[:, column.v] = from_pinocchio(column, q, arrays[1][:, order][:, column.v], results[:, column.v])
            else:
                results = np.delete(results, column.v, axis=1)

    def measure() -> float:
        start = time.thread_time()  # a difference of two times: of this thread, whatever else the machine does
        for row in rows:
            call(made, data, *row)
        middle = time.thread_time()
        for row in first:
            call(joint, small, *row)
        return ((middle - start) - (time.thread_time() - middle)) * 1e9 / len(rows)

    return {f"pinocchio: {known[name]} from Python, less overhead": Peer(measure, results, expected[0])}


def _tree_in_pinocchio(made: Any, compiled: Compiled, name: str, count: int) -> tuple[list[np.ndarray], list[int]]:
    """Pinocchio's q, v and third input at a function's states, and where in its v the tree's rates stand."""
    q, *others = states(compiled.model, name, count)
    arrays = [np.zeros((len(q), made.nq)), *(np.zeros((len(q), made.nv)) for _ in others)]
    order: list[int] = []
    drives = 0  # of the forces that a function takes or gives, of which a free base has none
    given = others[:-1] if name == "forward_dynamics" else others
    for column in columns(compiled.whole):
        j = made.joints[made.getJointId(column.name)]
        order += range(j.idx_v, j.idx_v + j.nv)
        if column.free:
            places, *moved = to_pinocchio(column, q, tuple(given))
            arrays[0][:, j.idx_q : j.idx_q + j.nq] = places
            for array, rate in zip(arrays[1:], moved, strict=False):
                array[:, j.idx_v : j.idx_v + j.nv] = rate
            continue
        x = q[:, column.q[0]]
        turn = (np.cos(x), np.sin(x)) if j.nq == 2 else (x,)  # a joint that turns without end
        for i, part in enumerate(turn):
            arrays[0][:, j.idx_q + i] = part
        for array, rate in zip(arrays[1:], given, strict=False):
            array[:, j.idx_v] = rate[:, column.v[0]]
        if name == "forward_dynamics":
            arrays[-1][:, j.idx_v] = others[-1][:, drives]
        drives += 1
    return arrays, order


def _closed_in_pinocchio(compiled: Compiled, name: str, expected: np.ndarray) -> Found | str:
    """Forward dynamics by constraint models from Python, inverse dynamics by C++ on RNEA and Jacobians."""
    from symscrew.studies.benchmark.pinocchio_build import PinocchioUnavailableError, build_pinocchio, open_case, timed
    from symscrew.studies.benchmark.pinocchio_closed import PROXIMAL, closed
    from symscrew.studies.benchmark.pinocchio_tree import pinocchio_tree

    try:
        tree = pinocchio_tree(compiled.model.mechanism)
    except ValueError as reason:
        return f"compared for platforms on limbs of three coordinates: {reason}"
    q, v, third = states(compiled.model, name, len(expected))
    if name == "forward_dynamics":
        measure, found = closed(compiled.model, tree, (q, v), third)
        wanted = tree.states(q, v, expected)[2]
        return {"pinocchio: constraintDynamics from Python, less overhead": Peer(measure, found, wanted, PROXIMAL)}
    with tempfile.TemporaryDirectory(prefix="symscrew_") as folder:
        try:
            library = build_pinocchio(Path(folder))
        except PinocchioUnavailableError as reason:
            return f"its C++ could not be built: {reason}"
        opened = open_case(library, tree, Path(folder))
    if opened is None:
        return "its C++ part of this benchmark has no platform of this kind"
    rows, variants = 3 * len(tree.cuts), {}
    for structured, how in enumerate((f"{rows}x{rows} LU", "limb by limb")):
        measure, found = timed(library, opened, tree.states(q, v, third), expected.shape, structured=structured)
        variants[f"pinocchio: RNEA and Jacobians in C++, {how}"] = Peer(measure, found, expected)
    return variants


def mujoco(compiled: Compiled, name: str, expected: tuple[np.ndarray, ...]) -> Found | str:
    """mj_inverse and mj_forward, called from C with addresses of the Python package's objects."""
    known = {"forward_dynamics": "mj_forward", "inverse_dynamics": "mj_inverse"}
    cut = bool(compiled.model.system.cuts)
    reason = _obstacle(compiled, name, list(known)[: 1 if cut else 2], "mujoco")
    if reason:
        return reason
    import mujoco as library

    made = library.MjModel.from_xml_string(text_of(compiled.model.mechanism, ".xml"))
    if not hasattr(made, "_address"):
        return f"version {library.__version__} does not tell where its data are"
    data = library.MjData(made)
    if cut:
        given, wanted = _closed_in_mujoco(made, compiled, expected[0])
        names = [library.mj_id2name(made, library.mjtObj.mjOBJ_ACTUATOR, k) for k in range(made.nu)]
        order = [names.index(label) for label in _drives(compiled, names)]
        given[2][:, order] = states(compiled.model, name, len(wanted))[2]
        third, last = data.ctrl, data.qacc
    else:
        given, wanted, compared = _tree_in_mujoco(made, compiled, name, expected[0])
        third, last = (data.qacc, data.qfrc_inverse) if name == "inverse_dynamics" else (data.qfrc_applied, data.qacc)
    results = np.full((len(given[0]), made.nv), np.nan)
    found = sorted(Path(library.__file__).parent.glob("libmujoco*"))
    if not found:
        return "the package has no libmujoco to call from C"
    function = getattr(ctypes.CDLL(str(found[0])), known[name])
    sizes = (ctypes.c_size_t * 4)(*(array.shape[1] for array in given), made.nv)
    inside = pointers([data.qpos, data.qvel, third, last])
    places = pointers(given)

    def measure(rounds: int = 4, kept: Any = (given, data, made)) -> float:
        size = ctypes.c_size_t
        at = (ctypes.c_void_p(made._address), ctypes.c_void_p(data._address))
        result = ctypes.c_void_p(results.ctypes.data)
        nanoseconds: float = compiled.loops.time_engine(
            function, *at, size(rounds), size(len(results)), sizes, places, inside, result
        )
        return nanoseconds

    measure(1)
    soft = ", soft constraints" if cut else ""
    seen = results if cut else results[:, compared]  # the base's own forces no drive of ours gives
    return {f"mujoco: {known[name]} from C{soft}": Peer(measure, seen, wanted, None if cut else EXACT)}


def _tree_in_mujoco(
    made: Any, compiled: Compiled, name: str, expected: np.ndarray
) -> tuple[list[np.ndarray], np.ndarray, list[int]]:
    """qpos, qvel and third input of a function at its states, its results, and which of MuJoCo's these are."""
    import mujoco as library

    q, v, third = states(compiled.model, name, len(expected))
    inverse, count = name == "inverse_dynamics", len(q)
    given = [np.zeros((count, size)) for size in (made.nq, made.nv, made.nv)]
    found: list[np.ndarray] = []
    compared: list[int] = []
    drives = 0
    for column in columns(compiled.whole):
        joint = library.mj_name2id(made, library.mjtObj.mjOBJ_JOINT, column.name)
        at, dof = int(made.jnt_qposadr[joint]), int(made.jnt_dofadr[joint])
        dofs = slice(dof, dof + len(column.v))
        given[0][:, at : at + len(column.q)] = q[:, column.q]
        given[1][:, dofs] = v[:, column.v]
        if column.free:
            given[0][:, at : at + 3] += made.qpos0[at : at + 3]
        if inverse:
            given[2][:, dofs] = third[:, column.v]
        elif not column.free:
            given[2][:, dof] = third[:, drives]
        if not (inverse and column.free):
            compared += range(dofs.start, dofs.stop)
            found.append(expected[:, [drives] if inverse else column.v])
        drives += not column.free
    return given, np.concatenate(found, axis=1), compared


def _drives(compiled: Compiled, actuators: Sequence[str]) -> list[str]:
    """The actuator of every drive, in the order of u."""
    system = compiled.model.system
    return [joint if joint in actuators else f"{joint}_{freedom}" for joint, freedom in system.drives]


def _closed_in_mujoco(made: Any, compiled: Compiled, a: np.ndarray) -> tuple[list[np.ndarray], np.ndarray]:
    """qpos, qvel and empty controls at the states of the forward dynamics, and the accelerations of a rigid chain.

    The bodies are put where they are in ours, copies of bodies at cut joints with the body that they are welded to.
    """
    import mujoco as library

    from symscrew.studies.benchmark.mujoco_placed import PlacedModel

    model = compiled.whole
    bodies = [library.mj_id2name(made, library.mjtObj.mjOBJ_BODY, k) for k in range(1, made.nbody)]
    data = library.MjData(made)
    library.mj_kinematics(made, data)
    placed = PlacedModel(made, model.mechanism.ground, {n: data.xpos[k + 1].copy() for k, n in enumerate(bodies)})
    known = {name: name if name in model.mechanism.bodies else name.removesuffix("_copy") for name in bodies}
    count = min(len(a), len(np.atleast_2d(model.test_inputs["forward_dynamics"][0])))  # the states repeat
    q, v, _ = (array[:count] for array in states(model, "forward_dynamics", count))
    moving = _body_states(model, q, v, a[:count])
    rows = []
    for k in range(count):
        placed.set_state({name: _one(moving[body], k) for name, body in known.items()})
        rows.append([np.array(x) for x in (placed.data.qpos, placed.data.qvel, placed.data.qacc)])
    position, rate, wanted = (np.resize(np.array(x), (len(a), len(x[0]))) for x in zip(*rows, strict=True))
    return [position, rate, np.zeros((len(a), made.nu))], wanted


def _body_states(model: Model, q: np.ndarray, v: np.ndarray, a: np.ndarray) -> dict[str, BodyState]:
    """Poses, twists and twist rates of all bodies but the ground, at many states."""
    bodies = [body for body in model.mechanism.bodies if body != model.mechanism.ground]
    (poses, *_), _ = model("body_poses", q)
    (twists, *_), _ = model("body_twists", q, v)
    (rates, *_), _ = model("body_twist_rates", q, v, a)
    poses, twists, rates = poses.reshape(len(q), -1, 12), twists.reshape(len(q), -1, 6), rates.reshape(len(q), -1, 6)
    return {
        body: BodyState(poses[:, k, :9].reshape(-1, 3, 3).swapaxes(1, 2), poses[:, k, 9:], twists[:, k], rates[:, k])
        for k, body in enumerate(bodies)
    }


def _one(state: BodyState, k: int) -> BodyState:
    return BodyState(state.rotation[k], state.translation[k], state.twist[k], state.twist_rate[k])


PEERS: Mapping[str, Callable[[Compiled, str, tuple[np.ndarray, ...]], Found | str]] = {
    "pinocchio": pinocchio,
    "mujoco": mujoco,
}
