"""A motion of the seed, as archives hold it."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from support.model_states import model


def recorded(count: int = 41) -> dict[str, Any]:
    """A motion of the seed's platform about y, with its drives: computed once, arrays of one's own each time."""
    return {name: array.copy() for name, array in _computed(count).items()}


@cache
def _computed(count: int) -> dict[str, Any]:
    found = model("three_ups_upu_s")
    t = np.linspace(0.0, 2.0, count)
    y = np.stack([0 * t, 0.1 * np.sin(np.pi * t)], axis=1)
    (q,), status = found("assemble", y, np.repeat(found.system.reference[None], count, axis=0))
    assert not status.any()
    (v,), _ = found("velocity", q, np.stack([0 * t, 0.1 * np.pi * np.cos(np.pi * t)], axis=1))
    (u,), _ = found("inverse_dynamics", q, v, 0 * v)
    labels = [c.label for c in found.system.tree.q]
    return {
        "t": t, "q": q, "v": v, "u": u, "mechanism": np.array("three_ups_upu_s"), "q_labels": np.array(labels),
        "u_labels": np.array(found.programs["inverse_dynamics"].outputs[0].labels),
    }  # fmt: skip
