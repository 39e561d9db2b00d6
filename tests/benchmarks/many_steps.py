"""Steps of scenes on many states at once: on a device, where one is, and the same file's loops on this processor.

A step is that of the scene's method with its effects, put back onto the loops. Differences are those of the states
after all steps, device against processor, over the largest entry.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
from support.many_states import scene_of, starts

from symscrew.runtime import CompileError
from symscrew.simulation import load_steps

from .tables import table

SCENES = (("four_bar", "rk4"), ("three_ups_upu_s_physical", "rk4"), ("delta", "rk4"), ("ur5", "rk4"), ("ur5", "rk8"))
STATES, STEPS = 2**17, 50
STARTS = 64  # different ones, over and over; so many on this processor


def run(*, repeats: int = 3) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    rows, raw = [], {}
    for mechanism, method in SCENES:
        found = _measured(mechanism, method, repeats)
        raw[f"{mechanism}.{method}"] = found
        there = found.get("device")
        cells = ["-", "-", "-"] if there is None else [f"{there:.3g}", f"{there / found['processor']:.0f}"]
        rows.append([mechanism, method, f"{found['processor']:.3g}", *cells[:2]])
        rows[-1].append("-" if there is None else f"{found['difference']:.1e}")
    head = ["scene", "method", "steps/s, one thread", "steps/s, device", "ratio", "difference"]
    return table(head, rows), raw


def _measured(mechanism: str, method: str, repeats: int) -> dict[str, float]:
    scene = scene_of(mechanism, "", method)
    here = load_steps(scene, as_cpp=True)
    q, v = starts(scene, here.plant, np.random.default_rng(3).uniform(-0.3, 0.3, STARTS))
    u = np.zeros((here.plant.sizes["u"], STARTS))

    def on_processor() -> Any:
        return here.advance(q, v, u=u, h=1e-3, steps=STEPS)

    expected = on_processor()
    seconds = min(_seconds(on_processor) for _ in range(repeats))
    found = {"processor": float(expected[4].sum()) / seconds}
    try:
        there = load_steps(scene)
    except CompileError:
        return found
    make, index = there.library, np.arange(STATES) % STARTS
    many = [make.asarray(np.ascontiguousarray(x[:, index])) for x in (q, v, u)]

    def on_device() -> Any:
        result = there.advance(many[0], many[1], u=many[2], h=1e-3, steps=STEPS)
        make.cuda.Device().synchronize()
        return result

    result = on_device()
    seconds = min(_seconds(on_device) for _ in range(repeats))
    first = [result[k].get()[:, :STARTS] for k in (0, 1)]
    apart = [np.abs(one - other).max() / np.abs(other).max() for one, other in zip(first, expected, strict=False)]
    return found | {"device": float(result[4].sum()) / seconds, "difference": float(max(apart))}


def _seconds(call: Any) -> float:
    begin = time.perf_counter()
    call()
    return time.perf_counter() - begin
