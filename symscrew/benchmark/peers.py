"""Other libraries on the same states, through their own importers of what we export: URDF for Pinocchio, MuJoCo.

Trees of revolute and prismatic joints only: for closed chains MuJoCo's accelerations are those of soft
constraints, and Pinocchio has no minimum-norm drives; tests/benchmarks of the repository compare these in C++.
"""

from __future__ import annotations

import ctypes
import importlib.util
import time
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from symscrew import interchange
from symscrew.effects import Gravity

if TYPE_CHECKING:
    from symscrew.benchmark import Compiled

INSTALL = "pip install 'symscrew[benchmark]'"
Found = Mapping[str, tuple[Callable[[], float], np.ndarray]]


def _obstacle(compiled: Compiled, name: str, known: Mapping[str, str], package: str) -> str | None:
    """Why there is nothing to compare, if so."""
    system = compiled.model.system
    if importlib.util.find_spec(package) is None:
        return f"not installed: {INSTALL}"
    if name not in known:
        return f"it has no function of this kind; expected {' or '.join(known)}"
    if system.cuts or any(len(joint.driven) != 1 for joint in compiled.model.mechanism.joints.values()):
        return "compared for open chains of driven R and P joints only"
    if compiled.model.effects != (Gravity(),):
        return "compared under usual gravity and no other effect only"
    return None


def _labels(compiled: Compiled) -> list[str]:
    return [c.label.split(".")[0] for c in compiled.model.system.tree.v]


def pinocchio(compiled: Compiled, name: str, expected: tuple[np.ndarray, ...]) -> Found | str:
    """RNEA, ABA and CRBA of the Python package, less the time of the same calls for a chain of one joint."""
    known = {"inverse_dynamics": "rnea", "forward_dynamics": "aba", "mass_matrix": "crba"}
    reason = _obstacle(compiled, name, known, "pinocchio")
    if reason:
        return reason
    import pinocchio as library

    from symscrew.benchmark import states

    made = library.buildModelFromXML(interchange.dumps(compiled.model.mechanism, ".urdf"))
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
        start = time.perf_counter()
        for row in rows:
            call(made, data, *row)
        middle = time.perf_counter()
        for row in first:
            call(joint, small, *row)
        return ((middle - start) - (time.perf_counter() - middle)) * 1e9 / len(rows)

    return {f"pinocchio: {known[name]} from Python, less overhead": (measure, results)}


def mujoco(compiled: Compiled, name: str, expected: tuple[np.ndarray, ...]) -> Found | str:
    """mj_inverse and mj_forward, called from C with addresses of the Python package's objects."""
    known = {"inverse_dynamics": "mj_inverse", "forward_dynamics": "mj_forward"}
    reason = _obstacle(compiled, name, known, "mujoco")
    if reason:
        return reason
    from pathlib import Path

    import mujoco as library

    from symscrew.benchmark import pointers, states

    made = library.MjModel.from_xml_string(interchange.dumps(compiled.model.mechanism, ".xml"))
    if not hasattr(made, "_address"):
        return f"version {library.__version__} does not tell where its data are"
    data = library.MjData(made)
    names = [library.mj_id2name(made, library.mjtObj.mjOBJ_JOINT, k) for k in range(made.njnt)]
    order = [names.index(label) for label in _labels(compiled)]
    given = [np.empty_like(array) for array in states(compiled.model, name, len(expected[0]))]
    for moved, array in zip(given, states(compiled.model, name, len(expected[0])), strict=True):
        moved[:, order] = array
    third, last = (data.qacc, data.qfrc_inverse) if name == "inverse_dynamics" else (data.qfrc_applied, data.qacc)
    results = np.full((len(given[0]), made.nv), np.nan)
    found = sorted(Path(library.__file__).parent.glob("libmujoco*"))
    if not found:
        return "the package has no libmujoco to call from C"
    function = getattr(ctypes.CDLL(str(found[0])), known[name])
    sizes = (ctypes.c_size_t * 4)(*[made.nv] * 4)
    inside = pointers([data.qpos, data.qvel, third, last])
    places = pointers(given)

    def measure(rounds: int = 4, kept: Any = (given, data, made)) -> float:
        size = ctypes.c_size_t
        at = (ctypes.c_void_p(made._address), ctypes.c_void_p(data._address))
        result = ctypes.c_void_p(results.ctypes.data)
        return compiled.loops.time_engine(
            function, *at, size(rounds), size(len(results)), sizes, places, inside, result
        )

    measure(1)
    return {f"mujoco: {known[name]} from C": (measure, results[:, order])}


PEERS: Mapping[str, Callable[[Compiled, str, tuple[np.ndarray, ...]], Found | str]] = {
    "pinocchio": pinocchio,
    "mujoco": mujoco,
}
