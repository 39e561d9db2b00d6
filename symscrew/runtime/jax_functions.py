"""The functions of a model by JAX, called with NumPy's arrays, on whatever device JAX has.

call, device = load_jax(model);    call(function, *arrays (states, size)) -> results, status
"""

from __future__ import annotations

import importlib.util
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.export import print_jax
from symscrew.model import Model
from symscrew.runtime.compilers import CompileError

Array = np.ndarray


def load_jax(model: Model) -> tuple[Callable[..., tuple[list[Array], Array]], str]:
    """A call (function, arrays) in double precision, each function compiled once for every shape; the device's name.

    Raises:
        CompileError: JAX is not installed.
    """
    try:
        import jax
    except ImportError as error:
        raise CompileError("no JAX here: pip install 'symscrew[jax]'") from error
    module = _imported(model)
    compiled = cache(lambda name: jax.jit(getattr(module, name)))

    def call(name: str, *arrays: Array) -> tuple[list[Array], Array]:
        with jax.enable_x64(True):
            *found, status = compiled(name)(*(np.asarray(x, dtype=float) for x in arrays))
        return [np.asarray(x) for x in found], np.asarray(status)

    return call, str(jax.devices()[0].device_kind)


def _imported(model: Model) -> Any:
    """The generated module; its file is needed no more when it is there."""
    ((name, text),) = print_jax(model).items()
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        path = Path(temporary) / name
        path.write_text(text, encoding="utf-8")
        spec = importlib.util.spec_from_file_location(path.stem, path)
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    return module
