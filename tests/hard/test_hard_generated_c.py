"""Generated C under sanitizers and valgrind, across compilers and levels, in float, with denormals, at random states.

What every guard prevents stands in the test's docstring, as seen when it was taken out.
"""

from __future__ import annotations

import dataclasses
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from support.compiled_c import MODELS, results_of, some, written
from support.model_states import model as catalogued
from support.model_states import relative
from support.runs import prepared

from hard import case
from symscrew.runtime.compiled import CompileError, find_compiler, load

pytestmark = [
    pytest.mark.slow,
    pytest.mark.optimised,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: these cases are of compiled code"),
]


@pytest.mark.parametrize("name, functions", MODELS)
def test_levels_of_optimisation(name: str, functions: Sequence[str], tmp_path: Path) -> None:
    """-O0 and -O3 give the same bits without contraction of multiply-add, with it 1e-13 of the output's norm."""
    found, compiler = some(name, functions), find_compiler()
    assert compiler
    source = written(found, tmp_path)
    plain = results_of(found, source, compiler, ("-O0", "-ffp-contract=off"))
    fast = results_of(found, source, compiler, ("-O3", "-ffp-contract=off"))
    native_code = results_of(found, source, compiler, ("-O3", "-march=native", "-ffp-contract=fast"))
    for function, expected in plain.items():
        assert expected.tobytes() == fast[function].tobytes(), function
        assert relative(native_code[function], expected) < 1e-13, function


@pytest.mark.slow
def test_random_states_against_casadi() -> None:
    """Inverse dynamics of the four-bar: batch function and CasADi at 2e5 states, anywhere in q, v, a."""
    pytest.importorskip("casadi")
    found = catalogued("four_bar")
    found = dataclasses.replace(found, programs={"inverse_dynamics": found.programs["inverse_dynamics"]})
    random = np.random.default_rng(12)
    q, v, a = random.uniform(-np.pi, np.pi, (200_000, 3)), *random.uniform(-10, 10, (2, 200_000, 3))
    fast, slow = load(found, backend="c"), load(found, backend="casadi")
    u, first = fast.inverse_dynamics(q, v, a, check=False)  # type: ignore[misc]
    expected, second = slow.inverse_dynamics(q, v, a, check=False)  # type: ignore[misc]
    assert (first == second).all() and (first == 0).mean() > 0.99
    good = first == 0
    usual = np.median(np.abs(expected[good]))
    scale = np.maximum(np.abs(expected[good]), usual)
    error = np.abs(u[good] - expected[good]) / scale
    # near a singular position a value grows with 1/pivot, and so does what a rounding of the pivot means
    assert (error / (scale / usual)).max() < 1e-12
    assert np.median(error) < 1e-15


FAST_MATH = ("-ffast-math", "-fno-finite-math-only")
FLUSHED = """
import sys
from dataclasses import replace
import numpy as np
sys.path.insert(0, {tests!r})
from support.runs import compiled, error_of, run_of, scene_of
from symscrew.scene import Initial
from symscrew.simulation import native

native.NATIVE_FLAGS = (*native.NATIVE_FLAGS, "-O1")
model, plant, _ = compiled("bricard")
flags = (*native.NATIVE_FLAGS, *{flags!r})
other = native.Library(plant, "", flags)
scene = replace(scene_of("bricard", tolerance=1e-9), initial=Initial(rates={{"R1": 1e-310}}))
first, second = run_of("bricard", scene), run_of("bricard", scene, other)
small = np.float64(1e-310) * np.float64(0.5) == 0.0
print(first.ok, second.ok, np.abs(first.q - second.q).max() < 1e-12, error_of("bricard", second) < 1e-9, small)
"""


def test_denormal_rates() -> None:
    """A04 with rates of 1e-310: the accelerations of rest, bit for bit. (Times are not asserted in tests.)"""
    found, _ = prepared("bricard")
    forward = {"forward_dynamics": found.programs["forward_dynamics"]}
    calls = load(dataclasses.replace(found, programs=forward), backend="c")
    q = found.system.reference
    rest, first = calls.forward_dynamics(q, np.zeros(5), check=False)  # type: ignore[misc]
    tiny, second = calls.forward_dynamics(q, np.full(5, 1e-310), check=False)  # type: ignore[misc]
    assert first == second <= 0 and (rest == tiny).all()


@pytest.mark.slow
def test_fast_math_and_flushed_denormals() -> None:
    """A04 for 10 s from rates of 1e-310, compiled with -ffast-math: the same run to 1e-12, while denormals are flushed.

    In a process of its own: such a library makes all of its process flush denormals (with gcc, seen by the last
    word). With -ffinite-math-only, which would drop the checks for NaN, the code refuses to compile (checked).
    """
    assert "same trajectory to 1e-12" in case(38)["pass_criterion"]
    script = FLUSHED.format(tests=str(Path(__file__).parents[1]), flags=FAST_MATH)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    *same, flushed = done.stdout.split()
    assert same == ["True"] * 4, done.stdout
    assert flushed == "True" or "gcc" not in str(find_compiler())
    with pytest.raises(CompileError, match="the checks for NaN would vanish"):
        load(some("four_bar", ("closure",)), backend="c", flags=("-ffast-math",))
