"""Complex numbers are refused wherever arrays are given: NumPy would take their real part and only warn."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support import handmade

from symscrew.export.numpy import print_numpy


@pytest.fixture(scope="module")
def module() -> dict[str, Any]:
    names: dict[str, Any] = {}
    exec(compile(print_numpy(handmade.model())["handmade_numpy.py"], "handmade_numpy.py", "exec"), names)
    return names


@pytest.mark.parametrize("kind", [complex, np.complex64, list])
@pytest.mark.parametrize("name", list(handmade.model().programs))
def test_model_and_generated_module_refuse_them(name: str, kind: Any, module: dict[str, Any]) -> None:
    model = handmade.model()
    arrays = [array[:1] for array in model.test_inputs[name]]
    model(name, *arrays)
    module[name](*arrays)
    for k, array in enumerate(arrays):
        if not array.size:
            continue
        wrong = [[complex(x, 1) for x in array[0]]] if kind is list else array.astype(kind)
        given = [*arrays[:k], wrong, *arrays[k + 1 :]]
        for function in (lambda *args: model(name, *args), module[name]):
            with pytest.raises(TypeError, match=r"expected real numbers, got complex\d+; take x\.real"):
                function(*given)
