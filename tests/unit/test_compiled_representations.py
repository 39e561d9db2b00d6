"""What a user sees of compiled functions, effects and checks in a session: one line each."""

from __future__ import annotations

from support.model_states import model

from symscrew.effects import Acting, ExternalWrench, Gravity
from symscrew.program import Port
from symscrew.runtime import CompiledFunction, CompiledModel
from symscrew.verification.regeneration import CheckResult


def test_compiled_functions_and_models() -> None:
    q, u = (Port(n, (2,), ("1", "1"), ("a", "b"), n) for n in "qu")
    function = CompiledFunction("drives", (q,), (u,), lambda inputs, outputs, status: None)
    assert repr(function) == "CompiledFunction(drives(q[2]) -> u[2])"
    assert repr(CompiledModel("arm", "c", {"drives": function})) == "CompiledModel(arm: 1 functions in c)"


def test_effects_and_what_they_put_on_a_system() -> None:
    effects = (Gravity(), ExternalWrench("coupler_middle"))
    assert repr(effects) == "(Gravity(acceleration=(0, 0, '-9.81')), ExternalWrench(point='coupler_middle'))"
    acting = Acting(model("four_bar").system, effects)
    assert repr(acting) == "Acting(four_bar: 1 loads, inputs load_coupler_middle)"


def test_results_of_checks() -> None:
    assert repr(CheckResult(True, ("a: ok: x",))) == "CheckResult(ok: 1 checks)"
    assert repr(CheckResult(False, ("a: ok: x", "a: FAILED: y"))) == "CheckResult(FAILED: 1 of 2 checks)"
