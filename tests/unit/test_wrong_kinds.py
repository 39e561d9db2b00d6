"""Public functions given another kind of thing than they take: one sentence that says what it should have been."""

from __future__ import annotations

import copy
import inspect
import pickle
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import symscrew
from symscrew.catalogue import load
from symscrew.export import print_c
from symscrew.functions import known_function
from symscrew.runtime import CompiledModel
from symscrew.simulation.kept_model import derived_model

WRONG: tuple[Any, ...] = (None, 3, 2.5, b"x", {"a": 1}, ["x"], object())
# What stands for itself: classes of errors and data. `assemble` and the like are asked like all others.
NO_FUNCTIONS = {"DescriptionError", "Effect", "ExternalWrench", "Gravity", "Mechanism", "MechanismBuilder", "Model"}
FUNCTIONS = [n for n in symscrew.__all__ if n not in NO_FUNCTIONS and callable(getattr(symscrew, n))]
OF_FILES = {"check", "load", "load_catalogue", "load_description", "load_scene"}


def called(name: str, first: Any) -> Any:
    """The function with `first` as its first argument, and as its other required ones."""
    function = getattr(symscrew, name)
    needed = [p for p in inspect.signature(function).parameters.values() if p.default is p.empty]
    return function(*[first for p in needed if p.kind is p.POSITIONAL_OR_KEYWORD])


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_wrong_kind_is_one_sentence(name: str) -> None:
    for wrong in (*WRONG, *(() if name in OF_FILES else ("four_bar",))):
        with pytest.raises(symscrew.DescriptionError, match=r"expected a \w+.*, got .* \(\w+\); ") as caught:
            called(name, wrong)
        assert isinstance(caught.value, TypeError)


def test_a_model_in_place_of_its_mechanism_is_told_where_it_is() -> None:
    model = symscrew.derive(load("slider_crank"))
    with pytest.raises(symscrew.DescriptionError, match=r"expected a Mechanism, .* it has one, as \.mechanism"):
        symscrew.analyse_mobility(model)  # type: ignore[arg-type]


def test_effects_are_a_sequence_of_effects() -> None:
    mechanism = load("slider_crank")
    for wrong in (symscrew.Gravity(), "gravity", None, ["gravity"], [symscrew.Gravity]):
        for function in (symscrew.derive, symscrew.base_parameters):
            with pytest.raises(symscrew.DescriptionError, match=r"expected a (sequence of effects|Effect), "):
                function(mechanism, wrong)  # type: ignore[arg-type]


def misspelt(name: str) -> Iterator[str]:
    yield from (name[:k] + name[k + 1 :] for k in range(len(name)))


def test_a_selection_refuses_misspelt_names() -> None:
    model = symscrew.derive(load("slider_crank"))
    names = list(model.programs)
    for name in (wrong for right in ("velocity", "inverse_dynamics_platform") for wrong in misspelt(right)):
        with pytest.raises(symscrew.DescriptionError, match=f"no function '{name}' in slider_crank; "):
            model.only(["velocity", name])
    with pytest.raises(symscrew.DescriptionError, match="expected names of functions"):
        model.only("inverse_dynamics")  # its letters would be looked for, and functions found in it
    with pytest.raises(symscrew.DescriptionError, match=r"no function 'velocty'.*did you mean 'velocity'"):
        model("velocty")
    assert list(model.only(["velocity", "rolling_forces"]).programs) == ["velocity"]
    assert all(map(known_function, names))


def test_every_function_there_may_be_is_known_by_name() -> None:
    model = symscrew.derive(load("slider_crank"), derivatives=True, second_derivatives=True, checked=True)
    assert [name for name in model.programs if not known_function(name)] == []
    arm = symscrew.derive(load("andrews"), regressor=True)
    assert [name for name in arm.programs if not known_function(name)] == []


def test_inputs_of_reactions_are_known_by_name() -> None:
    model = symscrew.derive(load("slider_crank"))
    rest = np.zeros(len(model.system.tree.v))
    with pytest.raises(symscrew.DescriptionError, match="no input 'load' of joint reactions"):
        symscrew.joint_wrenches(model, model.system.reference, rest, rest, load=np.zeros(6))


@pytest.mark.parametrize("options", [{}, {"independent": ["crank_R"], "regressor": True}, {"one_mode": True}])
def test_a_model_goes_to_another_process_and_prints_the_same(options: dict[str, Any]) -> None:
    model = symscrew.derive(load("slider_crank"), **options)
    for one in (model, model.only(["inverse_dynamics", "velocity"])):
        again = pickle.loads(pickle.dumps(one))
        assert list(again.programs) == list(one.programs)
        few = ["inverse_dynamics"]
        assert print_c(again.only(few)) == print_c(one.only(few))
    assert copy.deepcopy(model).notes == model.notes


def test_a_kept_model_goes_to_another_process() -> None:
    model = derived_model(load("slider_crank"), (symscrew.Gravity(),))
    again = pickle.loads(pickle.dumps(model))
    assert again.independent == model.independent and list(again.programs) == list(model.programs)


def test_what_cannot_go_to_another_process_says_so() -> None:
    model = symscrew.derive(load("slider_crank"))
    with pytest.raises(pickle.PicklingError, match="derive it there"):
        pickle.dumps(replace(model, programs={"velocity": model.programs["velocity"]}))
    with pytest.raises(pickle.PicklingError, match=r"`symscrew.load` it there"):
        pickle.dumps(CompiledModel("slider_crank", "c", {}))
