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
    joints = compiled.model.mechanism.joints.values()
    if not compiled.model.system.cuts and any(j.kind.freedom > 1 or len(j.driven) != j.kind.freedom for j in joints):
        return "open chains are compared if all their joints are driven R and P joints, or fixed"
    return None


def _labels(compiled: Compiled) -> list[str]:
    return [c.label.split(".")[0] for c in compiled.model.system.tree.v]


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
    joints = [made.joints[made.getJointId(label)] for label in _labels(compiled)]
    order = [j.idx_v for j in joints]
    q, *others = states(compiled.model, name, len(expected[0]))
    arrays = [np.zeros((len(q), made.nq)), *(np.zeros((len(q), made.nv)) for _ in others)]
    for k, j in enumerate(joints):
        turn = (np.cos(q[:, k]), np.sin(q[:, k])) if j.nq == 2 else (q[:, k],)  # a joint that turns without end
        for i, part in enumerate(turn):
            arrays[0][:, j.idx_q + i] = part
    for moved, array in zip(arrays[1:], others, strict=True):
        moved[:, order] = array
    rows = list(zip(*arrays, strict=True))
    first = [tuple(x[:1] for x in row) for row in rows]
    call = getattr(library, known[name])
    data, small = made.createData(), joint.createData()
    results = np.array([np.array(call(made, data, *row)) for row in rows])
    if name == "mass_matrix":
        results = np.triu(results) + np.triu(results, 1).swapaxes(1, 2)
        results = results[:, order][:, :, order].swapaxes(1, 2).reshape(len(rows), -1)
    else:
        results = results[:, order]

    def measure() -> float:
        start = time.thread_time()  # a difference of two times: of this thread, whatever else the machine does
        for row in rows:
            call(made, data, *row)
        middle = time.thread_time()
        for row in first:
            call(joint, small, *row)
        return ((middle - start) - (time.thread_time() - middle)) * 1e9 / len(rows)

    return {f"pinocchio: {known[name]} from Python, less overhead": Peer(measure, results, expected[0])}


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
        names = [library.mj_id2name(made, library.mjtObj.mjOBJ_JOINT, k) for k in range(made.njnt)]
        order = [names.index(label) for label in _labels(compiled)]
        given = [np.empty_like(array) for array in states(compiled.model, name, len(expected[0]))]
        for moved, array in zip(given, states(compiled.model, name, len(expected[0])), strict=True):
            moved[:, order] = array
        wanted = np.empty_like(expected[0])
        wanted[:, order] = expected[0]
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
    return {f"mujoco: {known[name]} from C{soft}": Peer(measure, results, wanted, None if cut else EXACT)}


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
