"""Generated JAX modules on the processor: values, derivatives, batches, statuses; against complex steps."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from support.complex_step import complex_step
from support.model_states import model

from symscrew import Model
from symscrew.export import print_jax
from symscrew.generation import generate
from symscrew.program import Program
from symscrew.verification import check

jax = pytest.importorskip("jax", reason="needs JAX (pip install 'symscrew[jax]')")
pytestmark = pytest.mark.tools
ENTIRE = 1e-12  # as every target: relative to the largest entry of an output


@pytest.fixture(autouse=True)
def _double() -> Any:
    with jax.enable_x64(True):
        yield


@pytest.fixture(scope="module")
def imported(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """The module of a model with some functions, imported once."""
    made: dict[tuple[str, ...], ModuleType] = {}

    def of(name: str, *functions: str) -> tuple[Model, ModuleType]:
        derived = model(name).only(functions)
        if (name, *functions) not in made:
            path = tmp_path_factory.mktemp("jax") / f"{name}_jax.py"
            path.write_text(print_jax(derived)[path.name])
            spec = importlib.util.spec_from_file_location(path.stem, path)
            assert spec is not None and spec.loader is not None
            found = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(found)
            made[name, *functions] = found
        return derived, made[name, *functions]

    return of


def weighted(function: Any, weights: Any) -> Any:
    """A number of all outputs of a function."""
    return lambda *inputs: sum(jax.numpy.vdot(w, x) for w, x in zip(weights, function(*inputs)[:-1], strict=True))


def test_generate_and_check(tmp_path: Path) -> None:
    """Functions of a closed chain agree with the evaluator by the command's own comparison."""
    functions = ["velocity", "forward_dynamics", "assemble"]
    generate(model("four_bar").only(functions), tmp_path, targets=["jax"])
    result = check(tmp_path)
    assert result.ok, result.lines
    assert any("JAX module agrees" in line for line in result.lines), result.lines


@pytest.mark.parametrize(
    ("name", "function"),
    [
        ("three_ups_upu_s", "joint_displacements"),
        ("panda", "inverse_dynamics"),
        ("four_bar", "forward_dynamics_independent"),
    ],
)
def test_values_tangents_and_gradients(imported: Any, name: str, function: str) -> None:
    derived, module = imported(name, function)
    program, called = derived.programs[function], getattr(module, function)
    assert isinstance(program, Program)
    rng = np.random.default_rng(3)
    state = [array[0] for array in derived.test_inputs[function]]
    direction = [rng.normal(size=len(x)) for x in state]
    values, status = derived(function, *state)
    found, change = jax.jvp(lambda *x: called(*x)[:-1], tuple(state), tuple(direction))
    assert status == 0
    exact = complex_step(program, state, direction)
    for got, tangent, value, slope in zip(found, change, values, exact, strict=True):
        np.testing.assert_allclose(got, value, rtol=0, atol=ENTIRE * max(np.abs(value).max(), 1e-3))
        np.testing.assert_allclose(tangent, slope, rtol=0, atol=ENTIRE * max(np.abs(slope).max(), 1e-3))
    weights = [rng.normal(size=len(x)) for x in values]
    gradient = jax.grad(weighted(called, weights), argnums=tuple(range(len(state))))(*state)
    along = sum(g @ d for g, d in zip(gradient, direction, strict=True))
    assert along == pytest.approx(sum(w @ s for w, s in zip(weights, exact, strict=True)), rel=1e-11)


def test_second_derivatives(imported: Any) -> None:
    """Forward over reverse, reverse over reverse and complex steps of the gradient's own program agree."""
    derived, module = imported("four_bar", "inverse_dynamics")
    state = tuple(array[1] for array in derived.test_inputs["inverse_dynamics"])
    rng = np.random.default_rng(4)
    direction = tuple(rng.normal(size=len(x)) for x in state)
    scalar = weighted(module.inverse_dynamics, [rng.normal(size=1)])
    gradient = jax.grad(scalar, argnums=(0, 1, 2))
    forward = jax.jvp(gradient, state, direction)[1]
    reverse = jax.grad(
        lambda *x: sum(jax.numpy.vdot(g, d) for g, d in zip(gradient(*x), direction, strict=True)), (0, 1, 2)
    )(*state)
    step = 1e-5
    moved = [gradient(*(x + s * step * d for x, d in zip(state, direction, strict=True))) for s in (-2, -1, 1, 2)]
    for k in range(3):
        np.testing.assert_allclose(forward[k], reverse[k], rtol=1e-10, atol=1e-12)
        differences = (moved[0][k] - 8 * moved[1][k] + 8 * moved[2][k] - moved[3][k]) / (12 * step)  # of fourth order
        np.testing.assert_allclose(forward[k], differences, rtol=0, atol=1e-8 * np.abs(differences).max())


def test_assembly_is_differentiated_along_the_manifold(imported: Any) -> None:
    """dq of assemble is what `velocity` says, to rounding; its second derivative is what differences say."""
    derived, module = imported("four_bar", "velocity", "assemble")
    y, guess = (array[0] for array in derived.test_inputs["assemble"])
    rates = np.array([0.5])
    q = module.assemble(y, guess).q
    dq, turned = jax.jvp(lambda x: jax.jvp(lambda z: module.assemble(z, guess).q, (x,), (rates,))[1], (y,), (rates,))
    (v,), status = derived("velocity", np.asarray(q), rates)
    assert status == 0 and len(v) == len(dq)  # no joint of the tree has a quaternion
    np.testing.assert_allclose(dq, v, rtol=0, atol=1e-11)
    step = 1e-4
    ends = [module.assemble(y + s * step * rates, guess).q for s in (-1, 0, 1)]
    np.testing.assert_allclose(turned, (ends[0] - 2 * ends[1] + ends[2]) / step**2, rtol=0, atol=1e-5)


def test_batches_and_their_mixtures(imported: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A batch given whole, by vmap over any axes, in blocks, and one state at a time are the same numbers."""
    derived, module = imported("four_bar", "inverse_dynamics")
    q, v, a = derived.test_inputs["inverse_dynamics"]
    whole = module.inverse_dynamics(q, v, a)
    single = [module.inverse_dynamics(*state).u for state in zip(q, v, a, strict=True)]
    np.testing.assert_array_equal(whole.u, np.array(single))
    mapped = jax.vmap(module.inverse_dynamics, in_axes=(None, 1, None))(q[0], v.T, a[0])
    np.testing.assert_array_equal(mapped.u, module.inverse_dynamics(q[0], v, a[0]).u)
    monkeypatch.setattr(module, "MEMORY", 2**15)  # blocks of 64 states: more than two of them, and no multiple of one
    many = [np.resize(x, (500, x.shape[1])) for x in (q, v, a)]
    np.testing.assert_array_equal(
        module.inverse_dynamics(*many).u, np.resize(np.asarray(whole.u), (500, whole.u.shape[1]))
    )
    named = module.inverse_dynamics(q=q.reshape(1, *q.shape), a=a, v=v)
    np.testing.assert_array_equal(named.u[0], whole.u)
    assert named.status.shape == (1, len(q))


def test_failing_states_are_nan_and_spoil_no_others(imported: Any) -> None:
    derived, module = imported("four_bar", "velocity", "assemble")
    q, rate = (array[:3].copy() for array in derived.test_inputs["velocity"])
    q[1, 0] = np.nan
    found = module.velocity(q, rate)
    np.testing.assert_array_equal(found.status, [0, 2, 0])
    assert np.isnan(found.v[1]).all() and np.isfinite(found.v[::2]).all()

    def sound(rate: Any) -> Any:
        made = module.velocity(q, rate)
        return jax.numpy.where(made.status[:, None] == 0, made.v, 0.0).sum()

    assert np.isfinite(jax.grad(sound)(rate)).all()  # what is masked does not count
    spoiled = jax.grad(lambda rate: module.velocity(q, rate).v.sum())(rate)
    assert np.isnan(spoiled[1]).all() and np.isfinite(spoiled[::2]).all()
    y, guess = (array[:2] for array in derived.test_inputs["assemble"])
    lost = module.assemble(y * np.nan, guess)
    np.testing.assert_array_equal(lost.status, [2, 2])


@pytest.mark.parametrize("functions", [("inverse_dynamics",), ("velocity", "assemble")], ids=lambda each: each[-1])
def test_single_precision(imported: Any, functions: tuple[str, ...]) -> None:
    """Values and gradients in float: of that type throughout, and float's digits of those in double; failures are NaN.

    An error of 1e-4 of the largest entry is three of its seven digits: the functions lose one (the study "digits"),
    derivatives another one.
    """
    (derived, module), function = imported("four_bar", *functions), functions[-1]
    inputs = [np.asarray(x)[:4] for x in derived.test_inputs[function]]
    spoiled = [np.where(np.arange(4)[:, None] == 2, np.nan, x) for x in inputs]

    def both(*given: Any) -> Any:
        weights = [np.ones((4, port.size), given[0].dtype) for port in derived.programs[function].outputs]
        priced = weighted(getattr(module, function), weights)
        return getattr(module, function)(*given), jax.grad(priced, argnums=tuple(range(len(given))))(*given)

    found = []
    for real in (np.float64, np.float32):
        with jax.enable_x64(real is np.float64):
            compiled = jax.jit(both)
            (*values, status), gradient = compiled(*(np.asarray(x, dtype=real) for x in inputs))
            assert {x.dtype for x in (*values, *gradient)} == {np.dtype(real)}
            assert (np.asarray(status) == 0).all()
            found.append([np.asarray(x, dtype=float) for x in (*values, *gradient)])
            (*values, status), _ = compiled(*(np.asarray(x, dtype=real) for x in spoiled))
            assert np.asarray(status).tolist() == [0, 0, 2, 0]
            assert all(np.isnan(x[2]).all() and np.isfinite(x[3]).all() for x in map(np.asarray, values))
    for double, single in zip(*found, strict=True):
        np.testing.assert_allclose(single, double, rtol=0, atol=1e-4 * max(1.0, np.abs(double).max(initial=0.0)))


def test_operations_traced_one_by_one_are_the_same(imported: Any) -> None:
    """What accelerators compile, on the processor."""
    derived, module = imported("four_bar", "velocity", "assemble")
    entries = np.concatenate([x.T for x in derived.test_inputs["velocity"]])
    program = module.record(module._velocity, len(entries))
    np.testing.assert_array_equal(module._looped(program, entries), module._unrolled(program, entries))


@pytest.mark.parametrize(
    ("arguments", "error", "said"),
    [
        ((np.zeros(3),), TypeError, "missing"),
        ((np.zeros(4), np.zeros(1)), ValueError, "velocity: q has 3 entries in its last dimension, got"),
        ((np.zeros(3) * 1j, np.zeros(1)), TypeError, "expected real numbers, got complex128"),
    ],
)
def test_wrong_arguments(imported: Any, arguments: Any, error: type[Exception], said: str) -> None:
    _, module = imported("four_bar", "velocity", "assemble")
    with pytest.raises(error, match=said):
        module.velocity(*arguments)


def test_the_module_needs_nothing_of_this_package(tmp_path: Path) -> None:
    derived = model("four_bar").only(["velocity"])
    (tmp_path / "four_bar_jax.py").write_text(print_jax(derived)["four_bar_jax.py"])
    text = (
        "import sys; sys.modules['symscrew'] = None; import json, four_bar_jax as m; "
        "r = m.velocity([0.1, 0.2, 0.3], [1]); print(json.dumps([float(r.v[0]), int(r.status)]))"
    )
    command = [sys.executable, "-c", text]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == [1.0, 0]


def test_the_example_of_a_design() -> None:
    """It asserts that its gradient is that of the cost, and that it gets lower; fewer poses than by itself."""
    text = (Path(__file__).parents[2] / "examples" / "jax" / "design_by_gradient.py").read_text()
    exec(
        compile(text.replace("POSES, STEPS = 10_000, 8", "POSES, STEPS = 100, 2"), "example", "exec"), {"__name__": "x"}
    )
