"""Accelerations of many states beside MuJoCo's MJX through JAX, and MuJoCo Warp, on the device that they have.

Errors are those against the evaluator: of ours rounding; of MJX on closed chains what its soft constraints leave. Needs
JAX and mujoco-mjx (pip install jax mujoco-mjx), of versions that go together; Warp, in single precision and on a
processor too where no device is, is left out without warp-lang and mujoco-warp.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.formats import save_as
from symscrew.model import Model, derive
from symscrew.runtime import load

from .jax_modules import imported
from .tables import table

NAMES = ("ur5", "panda", "four_bar", "planar_3rrr")  # MJX takes a minute and more to compile each
STATES = 1024
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
        where = jax.devices()[0].device_kind
        for name in NAMES:
            for found in _case(name, repeats):
                raw.append({"mechanism": name, **found})
                share = [f"{found[key]:.3g}" for key in ("compile", "ns", "error")]
                rows.append([name, found["what"], *share])
    head = ["mechanism", f"accelerations, on {where}", "trace and compile, s", "ns a state", "relative error"]
    return table(head, rows), {"states": STATES, "rows": raw}


def _case(name: str, repeats: int) -> list[dict[str, Any]]:
    import jax

    model = derive(catalogue.load(name)).only(["forward_dynamics", "joint_displacements"])
    given = [np.resize(x, (STATES, x.shape[-1])) for x in model.test_inputs["forward_dynamics"]]
    (exact, *_), status = model("forward_dynamics", *given)
    assert not status.any()
    size = float(np.abs(exact).max())

    def told(what: str, compiled: float, run: Callable[[], Any], columns: slice | list[int]) -> dict[str, Any]:
        result = np.asarray(run())
        error = float(np.abs(result - exact[:, columns]).max()) / size
        seconds = min(_seconds(run) for _ in range(repeats))
        return {"what": what, "compile": compiled, "ns": seconds / STATES * 1e9, "error": error}

    begin = time.perf_counter()
    batch = load(model, backend="c").forward_dynamics
    found = [told("ours, C, one thread", time.perf_counter() - begin, lambda: _first(batch(*given)), slice(None))]
    module = imported(model)
    begin = time.perf_counter()
    function = jax.jit(lambda *x: module.forward_dynamics(*x)[0]).lower(*given).compile()
    compiled = time.perf_counter() - begin
    found.append(told("ours, JAX", compiled, lambda: jax.block_until_ready(function(*given)), slice(None)))
    engine, arrays, order, columns = _mujoco(model, given)
    begin = time.perf_counter()
    function = jax.jit(_mjx(engine, order)).lower(*arrays).compile()
    compiled = time.perf_counter() - begin
    found.append(told("MJX", compiled, lambda: jax.block_until_ready(function(*arrays)), columns))
    begin = time.perf_counter()
    warped = _warp(engine, arrays, order)
    if warped is not None:
        warped()
        found.append(told("MuJoCo Warp, single precision", time.perf_counter() - begin, warped, columns))
    return found


def _first(found: Any) -> np.ndarray:
    return np.asarray(found[0] if isinstance(found, tuple) else found)


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


def _warp(engine: Any, arrays: list[Any], common: list[int]) -> Callable[[], np.ndarray] | None:
    """MuJoCo Warp's accelerations of these states; None where it is not installed."""
    try:
        import warp

        warp.config.quiet = True  # before the next line, which starts it
        import mujoco_warp
    except ImportError:
        return None
    shape, data = mujoco_warp.put_model(engine), mujoco_warp.make_data(engine, nworld=len(arrays[0]))
    for place, values in zip((data.qpos, data.qvel, data.qfrc_applied), arrays, strict=True):
        warp.copy(place, warp.array(np.asarray(values, np.float32), dtype=float))

    def accelerations() -> np.ndarray:
        mujoco_warp.forward(shape, data)
        return np.asarray(data.qacc.numpy())[:, common]

    return accelerations


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
