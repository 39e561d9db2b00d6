"""Functions with limbs side by side, and limb after limb."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from support.model_states import model, relative
from symscrew.export.c import print_c, print_source
from symscrew.generation.c_target import STRICT
from symscrew.runtime.compiled import compile_c

PLATFORM = "inverse_dynamics_platform"


CASES = [("three_ups_upu_s_physical", PLATFORM), ("delta", "velocity")]


def both(name: str, function: str, folder: Path, compiler: str | None, flags: tuple[str, ...]) -> list[np.ndarray]:
    """Results of the function with limbs side by side and limb after limb."""
    import ctypes

    found = replace(model(name), programs={function: model(name).programs[function]})
    for file, text in print_c(found).items():
        (folder / file).write_text(text, encoding="utf-8")
    results = []
    for number, more in enumerate(((), (f"-D{name.upper()}_LIMB_BY_LIMB",))):
        library = folder / f"{function}{number}.so"
        compile_c(folder / f"{name}.c", library, compiler=compiler, flags=[*STRICT, *flags, *more])
        call = getattr(ctypes.CDLL(str(library)), f"{name}_{function}")
        program = found.programs[function]
        states = []
        for row in zip(*(np.atleast_2d(x) for x in found.test_inputs[function]), strict=True):
            arrays = [np.array(x, dtype=float) for x in row] + [np.zeros(port.size) for port in program.outputs]
            assert call(*(ctypes.c_void_p(x.ctypes.data) for x in arrays)) == 0
            states.append(np.concatenate(arrays[len(row) :]))
        results.append(np.array(states))
    return results


def check_bits(name: str, function: str, tmp_path: Path, compiler: str | None) -> None:
    """Bit for bit if nothing is contracted to a multiply-add, else to rounding."""
    source = print_source(replace(model(name), programs={function: model(name).programs[function]}))
    assert f"{name}_{function}_packed_lane" in source
    side, after = both(name, function, tmp_path, compiler, ("-ffp-contract=off",))
    assert np.array_equal(side, after)
    side, after = both(name, function, tmp_path, compiler, ("-ffp-contract=fast",))
    assert relative(side, after) < 1e-13
