"""Accelerations of many states beside MuJoCo's MJX through JAX, and MuJoCo Warp, on the device that they have.

Errors are those against the evaluator: of ours rounding; of MJX on closed chains what its soft constraints leave. Needs
JAX and mujoco-mjx (pip install jax mujoco-mjx), of versions that go together; Warp, in single precision and on a
processor too where no device is, is left out without warp-lang and mujoco-warp.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.formats import save_as
from symscrew.model import Model, derive
from symscrew.runtime import CompileError, load, load_cuda

from .jax_modules import imported
from .tables import table

NAMES = ("ur5", "panda", "four_bar", "planar_3rrr")  # MJX takes a minute and more to compile each
STATES, MANY = 1024, 2**16  # on a processor, on a device
H = 1e-5  # of central differences of joint displacements: rates to about 1e-10


def run(*, repeats: int = 5) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers; without MJX what to install."""
    try:
        import jax
        from mujoco import mjx  # noqa: F401 - whether it is there
    except ImportError as error:
        return f"MJX is not here: pip install jax mujoco-mjx ({error})", {}
    rows, raw = [], []
    with jax.enable_x64(True):
        where, kind = jax.devices()[0].device_kind, jax.devices()[0].platform
        states = STATES if kind == "cpu" else MANY
        for name in NAMES:
            for found in _case(name, states, repeats):
                raw.append({"mechanism": name, **found})
                share = [f"{found[key]:.3g}" for key in ("compile", "ns", "error")]
                rows.append([name, found["what"], *share])
    head = ["mechanism", f"accelerations, on {where}", "trace and compile, s", "ns a state", "relative error"]
    return f"{states} states\n\n" + table(head, rows), {"states": states, "device": where, "rows": raw}


@dataclass(frozen=True)
class _Way:
    """What computes accelerations: `run` waits for them where they are, `read` brings them (states, columns)."""

    what: str
    seconds: float  # to trace and compile
    run: Callable[[], Any]
    read: Callable[[], np.ndarray]
    columns: slice | list[int]


def _case(name: str, states: int, repeats: int) -> list[dict[str, Any]]:
    """Times are of arrays that stay where they are computed."""
    model = derive(catalogue.load(name)).only(["forward_dynamics", "joint_displacements"])
    given = [np.resize(x, (states, x.shape[-1])) for x in model.test_inputs["forward_dynamics"]]
    (exact, *_), status = model("forward_dynamics", *given)
    assert not status.any()
    size, found = float(np.abs(exact).max()), []
    for way in _ways(model, given):
        way.run()
        error = float(np.abs(way.read() - exact[:, way.columns]).max()) / size
        seconds = min(_seconds(way.run) for _ in range(repeats))
        found.append({"what": way.what, "compile": way.seconds, "ns": seconds / states * 1e9, "error": error})
    return found


def _ways(model: Model, given: list[np.ndarray]) -> Iterator[_Way]:
    """Ours in C, in CUDA where a device is, by JAX; MJX and, where it is installed, Warp."""
    import jax

    begin = time.perf_counter()
    batch = load(model, backend="c").forward_dynamics

    def in_c() -> Any:
        result = batch(*given)
        return np.asarray(result[0] if isinstance(result, tuple) else result)

    yield _Way("ours, C, one thread", time.perf_counter() - begin, in_c, in_c, slice(None))
    if (ours := _cuda(model, given)) is not None:
        yield ours
    module = imported(model)
    yield _by_jax("ours, JAX", lambda *x: module.forward_dynamics(*x)[0], given, slice(None))
    engine, arrays, order, columns = _mujoco(model, given)
    yield _by_jax("MJX", _mjx(engine, order), arrays, columns)
    jax.clear_caches()
    if (warped := _warp(engine, arrays, order, columns)) is not None:
        yield warped


def _by_jax(what: str, function: Any, arrays: list[Any], columns: slice | list[int]) -> _Way:
    import jax

    there = [jax.device_put(x) for x in arrays]
    begin = time.perf_counter()
    compiled = jax.jit(function).lower(*there).compile()

    def run() -> Any:
        return jax.block_until_ready(compiled(*there))

    return _Way(what, time.perf_counter() - begin, run, lambda: np.asarray(run()), columns)


def _cuda(model: Model, given: list[np.ndarray]) -> _Way | None:
    begin = time.perf_counter()
    try:
        kernels = load_cuda(model.only(["forward_dynamics"]))
    except CompileError:
        return None
    library = kernels.library
    there = [library.asarray(np.ascontiguousarray(x.T)) for x in given]

    def run() -> Any:
        result = kernels.forward_dynamics(*there)
        library.cuda.Device().synchronize()
        return result[0]

    run()
    return _Way("ours, CUDA", time.perf_counter() - begin, run, lambda: run().get().T, slice(None))


def _mujoco(model: Model, given: list[np.ndarray]) -> tuple[Any, list[Any], list[int], list[int]]:
    """MuJoCo's model, positions, rates and forces of its joints, and which of its accelerations are which of ours."""
    import mujoco

    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
        path = Path(folder) / f"{model.name}.xml"
        save_as(model.mechanism, path)
        engine = mujoco.MjModel.from_xml_path(str(path))
    engine.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_LIMIT)
    engine.opt.tolerance, engine.opt.iterations = 1e-15, 100
    q, v, u = given
    labels, places, rates = _displacements(model, q, v)
    joints = [engine.joint(i).name for i in range(engine.njnt)]
    order = [labels.index(name) for name in joints]
    names = [c.label for c in model.system.tree.v]
    common = [i for i, name in enumerate(joints) if name in names]
    force = np.zeros((len(q), engine.nv))
    for k, name in enumerate(
        p for port in model.programs["forward_dynamics"].inputs if port.name == "u" for p in port.labels
    ):
        force[:, joints.index(name)] = u[:, k]
    return engine, [places[:, order], rates[:, order], force], common, [names.index(joints[i]) for i in common]


def _mjx(engine: Any, common: list[int]) -> Any:
    """MJX's accelerations as a function of arrays."""
    import jax
    from mujoco import mjx

    shape = mjx.put_model(engine)

    def accelerations(qpos: Any, qvel: Any, applied: Any) -> Any:
        def one(a: Any, b: Any, c: Any) -> Any:
            data = mjx.make_data(shape).replace(qpos=a, qvel=b, qfrc_applied=c)
            return mjx.forward(shape, data).qacc

        return jax.vmap(one)(qpos, qvel, applied)[:, np.array(common)]

    return accelerations


def _warp(engine: Any, arrays: list[Any], common: list[int], columns: list[int]) -> _Way | None:
    """MuJoCo Warp, on a device as a graph of its kernels as its users run it; None where it is not installed."""
    try:
        import warp

        warp.config.quiet = True  # before the next line, which starts it
        import mujoco_warp
    except ImportError:
        return None
    begin = time.perf_counter()
    shape, data = mujoco_warp.put_model(engine), mujoco_warp.make_data(engine, nworld=len(arrays[0]))
    for place, values in zip((data.qpos, data.qvel, data.qfrc_applied), arrays, strict=True):
        warp.copy(place, warp.array(np.asarray(values, np.float32), dtype=float))
    mujoco_warp.forward(shape, data)
    graph = None
    if warp.get_device().is_cuda:
        with warp.ScopedCapture() as captured:
            mujoco_warp.forward(shape, data)
        graph = captured.graph

    def run() -> None:
        mujoco_warp.forward(shape, data) if graph is None else warp.capture_launch(graph)
        warp.synchronize()

    run()
    seconds = time.perf_counter() - begin
    return _Way("MuJoCo Warp, single precision", seconds, run, lambda: data.qacc.numpy()[:, common], columns)


def _displacements(model: Model, q: np.ndarray, v: np.ndarray) -> tuple[list[str], np.ndarray, np.ndarray]:
    """Labels, displacements and rates of all joints, cut ones too."""
    system, program = model.system, model.programs["joint_displacements"]

    def at(part: float) -> np.ndarray:
        (found, *_), _ = model("joint_displacements", system.advance(q, part * v))
        return np.asarray(found)

    return list(program.outputs[0].labels), at(0.0), (at(H) - at(-H)) / (2 * H)


def _seconds(run: Callable[[], Any]) -> float:
    begin = time.perf_counter()
    run()
    return time.perf_counter() - begin
