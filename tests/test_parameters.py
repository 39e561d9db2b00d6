"""Run-time parameters: inputs of every function, the same results as baked ones, at other values too."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
import sympy

from symscrew import catalogue
from symscrew.mechanism import Mechanism
from symscrew.model import Model, derive


def with_parameters(mechanism: Mechanism, *, run_time: bool, scale: str = "1") -> Mechanism:
    changed = {
        name: dataclasses.replace(p, run_time=run_time, value=p.value * sympy.Rational(scale))
        for name, p in mechanism.parameters.items()
    }
    return dataclasses.replace(mechanism, parameters=changed)


@pytest.fixture(scope="module")
def run_time() -> Model:
    return derive(with_parameters(catalogue.load("three_ups_upu_s"), run_time=True))


@pytest.mark.parametrize("scale", ["1", "11/10", "3/4"])
def test_run_time_parameters_equal_baked_ones(run_time: Model, scale: str) -> None:
    baked = derive(with_parameters(catalogue.load("three_ups_upu_s"), run_time=False, scale=scale))
    q, v, a = baked.system.sample_states
    values = run_time.system.parameter_values * float(sympy.Rational(scale))
    for name in ("inverse_dynamics", "joint_reactions", "body_twist_rates", "momentum_rates", "mass_matrix"):
        program = baked.programs[name]
        state = [{"q": q, "v": v, "a": a}[port.name] for port in program.inputs]
        expected, _ = baked(name, *state)
        got, status = run_time(name, *state, values)
        assert np.all(status == 0)
        for x, y in zip(got, expected, strict=True):
            assert np.abs(x - y).max() < 1e-10 * np.abs(y).max(), name


def test_only_run_time_parameters_become_an_input(run_time: Model) -> None:
    assert run_time.programs["inverse_dynamics"].inputs[-1].labels == ("R", "r", "H")
    baked = derive(catalogue.load("three_ups_upu_s"))
    assert "p" not in [port.name for port in baked.programs["inverse_dynamics"].inputs]
