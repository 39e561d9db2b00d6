"""Models whose forward dynamics always take the second path."""

from __future__ import annotations

import dataclasses
import importlib.util
from pathlib import Path
from types import ModuleType

import numpy as np

from symscrew.export.numpy import print_numpy
from symscrew.model import Model
from symscrew.program.rank_revealing import RankRevealing

FUNCTIONS = ("forward_dynamics", "forward_dynamics_reactions")


def always_second(found: Model) -> Model:
    """The model with guards that every state fails."""
    programs = dict(found.programs)
    for name in FUNCTIONS:
        program = programs[name]
        assert isinstance(program, RankRevealing)
        programs[name] = dataclasses.replace(program, guards=tuple((slot, 1e300) for slot, _ in program.guards))
    return dataclasses.replace(found, programs=programs)


LIMIT = 1e-11


def states(found: Model) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    q, v, _ = found.system.sample_states
    return q, v, np.random.default_rng(8).uniform(-10, 10, (len(q), len(found.system.drives)))


def numpy_module(found: Model, folder: Path) -> ModuleType:
    for name, text in print_numpy(found).items():
        (folder / name).write_text(text)
    spec = importlib.util.spec_from_file_location("printed", folder / f"{found.name}_numpy.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
