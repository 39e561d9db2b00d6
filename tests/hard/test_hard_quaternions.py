"""Quaternions of another length than 1: divided by it within rounding, refused beyond, in every target alike."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from support.marks import slow
from support.model_states import model as catalogued

from symscrew.description.builder import MechanismBuilder
from symscrew.effects import BaseMotion, Gravity
from symscrew.export import c_parts, c_printed
from symscrew.generation.folder import generate
from symscrew.kinematics import ROUNDED
from symscrew.model import Model, derive
from symscrew.program import NO_ROTATION, Iteration
from symscrew.program.jacobians import jacobian
from symscrew.program.numpy_evaluation import evaluate
from symscrew.runtime.compiled import find_compiler, load

Array = np.ndarray
WITHIN = tuple(1 + sign * part * ROUNDED / 2 for sign in (1, -1) for part in (1e-9, 0.01, 0.99))
BEYOND = (*(1 + sign * 1.01 * ROUNDED / 2 for sign in (1, -1)), 1.01, 0.9, -1.01, 0.0, 1e-160)


@cache
def model(name: str) -> Model:
    """A plate on a ball joint and a leg ("plate"), the same on a moving base, or one of the catalogue."""
    if name not in ("plate", "moved_plate"):
        return catalogued(name)
    builder = MechanismBuilder(name, platform="plate")
    builder.body("plate", mass=2, com=[0, "1/10", "1/5"], inertia=["1/50", "1/40", "1/30"])
    builder.joint("ball", "S", parent="base", child="plate", point=[0, 0, 0])
    foot, end = ["3/10", 0, "-1/5"], ["3/10", "3/10", "1/5"]
    builder.limb("leg", "UPS", base="base", tip="plate", points=[foot, foot, end],
                 axes=[[[1, 0, 0], [0, "4/5", "-3/5"]], [[0, "3/5", "4/5"]], []], mass=["1/2", "1/4"], com=[foot, end],
                 inertia=[["1/100"] * 3] * 2)  # fmt: skip
    effects = (Gravity(),) if name == "plate" else (BaseMotion(attitude=True), Gravity())
    return derive(builder.build(), effects)


def scaled(found: Model, function: str, size: float) -> list[Array] | None:
    """The test inputs with quaternions of this length; None where there are none."""
    ports, inputs = found.programs[function].inputs, [np.array(x) for x in found.test_inputs[function]]
    places = [(i, k) for i, port in enumerate(ports) for k, form in enumerate(port.forms) if form]
    for i, port in enumerate(ports):  # free inputs are random numbers
        if port.name == "base_attitude":
            inputs[i] /= np.linalg.norm(inputs[i], axis=1, keepdims=True)
    for i, k in places:
        inputs[i][:, k] *= size
    return inputs if places else None


def same(one: Array, other: Array, tolerance: float) -> bool:
    return bool(np.abs(one - other).max(initial=0.0) <= tolerance * max(1.0, np.abs(other).max(initial=0.0)))


@pytest.mark.parametrize("name", ["plate", slow("moved_plate"), slow("three_ups_upu_s")])
def test_results_do_not_depend_on_a_length_within_rounding_and_fail_beyond(name: str) -> None:
    found, refused = model(name), set()
    for function in found.programs:
        inputs = scaled(found, function, 1.0)
        if inputs is None:
            continue
        exact, status = found(function, *inputs)
        assert not status.any(), function
        for size in WITHIN:
            results, status = found(function, *scaled(found, function, size))
            assert not status.any(), (function, size)
            for port, a, b in zip(found.programs[function].outputs, results, exact, strict=True):
                turns = np.array([form != "" for form in port.forms] or [False] * port.size)  # handed on as they came
                assert same(a[:, ~turns], b[:, ~turns], 1e-10), (function, port.name, size)
                assert same(a[:, turns], b[:, turns], ROUNDED)
        for size in BEYOND:
            results, status = found(function, *scaled(found, function, size))
            assert set(status.tolist()) <= {0, NO_ROTATION}, (function, size)
            if NO_ROTATION in status:
                refused.add(function)
                assert (status == NO_ROTATION).all() and all(np.isnan(r).all() for r in results)
            else:  # depends on no quaternion at all
                assert all(same(a, b, 0.0) for a, b in zip(results, exact, strict=True)), (function, size)
    assert refused >= {"closure", "velocity", "inverse_dynamics", "forward_dynamics", "assemble", "body_poses"} & set(
        found.programs
    )


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e200])
def test_what_is_not_finite_is_called_so(value: float) -> None:
    found = model("plate")
    for function in ("closure", "forward_dynamics", "assemble"):
        inputs = scaled(found, function, 1.0)
        position = next(i for i, port in enumerate(found.programs[function].inputs) if port.forms)
        inputs[position][:, 1] = value
        overflows = function == "assemble" and np.isfinite(value)  # a step fails, and Newton's iteration with it
        assert (found(function, *inputs)[1] == (3 if overflows else 2)).all()


def states(found: Model, function: str) -> list[Array]:
    """States side by side whose quaternions are good and bad by turns: blocks of them, and some that are left."""
    sizes = (1.0, *WITHIN, 1.0, *BEYOND, np.nan, 1.0, 1.01)
    rows = [[x[:1] for x in scaled(found, function, size)] for size in sizes]
    return [np.concatenate(columns) for columns in zip(*rows, strict=True)]


CALLED = {  # one of each form
    "plate": ("forward_dynamics", "inverse_kinematics", "assemble", "energy"),
    "moved_plate": ("forward_dynamics", "inverse_dynamics", "body_poses", "energy"),
    "three_ups_upu_s": ("assemble", "inverse_kinematics", "velocity", "closure_jacobian", "inverse_dynamics"),
}


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
@pytest.mark.parametrize("name", ["plate", slow("moved_plate"), slow("three_ups_upu_s")])
def test_targets_refuse_what_the_evaluator_refuses(name: str, tmp_path) -> None:
    """C by single calls, blocks of states and limbs side by side; NumPy; CasADi."""
    found = model(name).only(CALLED[name])
    generate(found, tmp_path / "out", ("c", "numpy"))
    compiled, casadi = load(tmp_path / "out", trusted=True), load(found, backend="casadi")
    text = (tmp_path / "out" / f"{found.name}_numpy.py").read_text(encoding="utf-8")
    module: dict = {}
    exec(compile(text, "module", "exec"), module)
    for function in found.programs:
        if scaled(found, function, 1.0) is None:
            continue
        inputs = states(found, function)
        exact, status = found(function, *inputs)
        alone = [compiled[function](*(x[k] for x in inputs), check=False) for k in range(len(status))]
        together = compiled[function](*inputs, check=False)
        assert [int(each[-1]) for each in alone] == status.tolist() == together[-1].tolist(), function
        assert module[function](*inputs)[1].tolist() == status.tolist(), function
        assert casadi[function](*inputs, check=False)[-1].tolist() == status.tolist(), function
        good = status == 0
        for k, (a, port) in enumerate(zip(exact, found.programs[function].outputs, strict=True)):
            b = np.asarray(together[k])
            flat = np.swapaxes(b, 1, 2).reshape(len(b), -1) if b.ndim == 3 else b.reshape(len(b), -1)
            assert same(flat[good], a[good], 1e-9), (function, port.name)
            assert np.isnan(flat[~good]).all()


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
def test_long_functions_in_parts_refuse_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(c_printed, "LONG", 1)
    monkeypatch.setattr(c_parts, "PART", 37)
    found = model("plate").only(["closure", "mass_matrix", "velocity"])
    compiled = load(found, backend="c")
    for function in ("closure", "velocity"):
        inputs = states(found, function)
        assert compiled[function](*inputs, check=False)[-1].tolist() == found(function, *inputs)[1].tolist()


@pytest.mark.slow
def test_derivatives_refuse_and_do_not_see_the_length() -> None:
    """A direction along the quaternion changes nothing, of a function and of a step of the assembly."""
    found = model("plate")
    for function in ("closure", "assemble"):
        program = found.programs[function]
        made = jacobian(program)
        inputs = scaled(found, function, 1.0)
        if isinstance(program, Iteration):
            inputs = [found(function, *inputs)[0][0], inputs[0]]
        assert not evaluate(made.program, inputs)[1].any()
        inputs = [x * (1.01 if port.forms else 1) for x, port in zip(inputs, made.program.inputs, strict=True)]
        assert (evaluate(made.program, inputs)[1] == NO_ROTATION).all()
