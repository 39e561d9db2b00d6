"""Public functions given another kind of thing than they take: one sentence that says what it should have been."""

from __future__ import annotations

import copy
import inspect
import pickle
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
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


def parameters_of(name: str) -> dict[str, str]:
    """Parameters of a public function with what they take, but for those that take anything."""
    function = symscrew.Model
    for part in name.split("."):
        function = getattr(symscrew, part, None) or getattr(function, part)
    given = inspect.signature(function).parameters.items()
    return {key: p.annotation for key, p in given if key != "self" and p.annotation not in ("Any", "object")}


@pytest.mark.parametrize("name", [*(n for n in FUNCTIONS if n != "Quantities"), "Model.only", "Model.declared"])
def test_every_parameter_is_looked_at(name: str) -> None:
    """Before anything is done, and before other arguments are missed: the error names function and parameter."""
    function = symscrew.Model.only if name == "Model.only" else symscrew.Model.declared
    function = function if "." in name else getattr(symscrew, name)
    bare = (None,) if "." in name else ()
    for key, annotation in parameters_of(name).items():
        if "Moved" in annotation:  # whatever has a model; looked at where it is used
            continue
        wrong = [object(), b"x", 2 + 1j, np.array([object()]), float("nan"), {1: object()}, [[1]], symscrew]
        wrong += [] if "None" in annotation else [None]
        wrong += [] if "str" in annotation or "Path" in annotation else ["x"]
        wrong += ["a\0b", "x" * 300, "\ud800"] if "Path" in annotation else []
        for value in wrong:
            with pytest.raises(symscrew.DescriptionError, match=rf"{name}: .*{key}.*: expected ") as caught:
                function(*bare, **{key: value})
            assert len(str(caught.value)) < 500


def test_numbers_and_names_of_other_libraries_are_taken(tmp_path: Path) -> None:
    crank = load("slider_crank")
    found = symscrew.base_parameters(crank, iter([symscrew.Gravity()]), states=np.int64(0), seed=np.uint8(1))
    assert found.labels == symscrew.base_parameters(crank).labels
    assert symscrew.draw(crank, elevation=np.float64(20), azimuth=np.array(30.0), labels=np.True_)
    model = symscrew.derive(crank)
    assert symscrew.assemble(model, {"crank_R": np.float32(0.3)}, guess=[0, 0, 0]).ok
    assert symscrew.load_description(Path(symscrew.description.__file__).parents[1] / "catalogue" / "slider_crank.toml")


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda m: symscrew.base_parameters(m.mechanism, seed=-1), "seed: expected a whole number from 0 to "),
        (lambda m: symscrew.base_parameters(m.mechanism, states=10**30), "states: expected a whole number from 0 to "),
        (lambda m: symscrew.draw(m.mechanism, elevation=float("inf")), "elevation: expected a number or None, got inf"),
        (lambda m: symscrew.drives(m.mechanism, {"crank_R": "t"}, duration=10**400), "duration: expected a number"),
        (lambda m: symscrew.derive(m.mechanism, length=np.zeros(3)), "expected a number or a text with an expression"),
        (lambda m: symscrew.derive(m.mechanism, length=float), "expected a number or a text with an expression"),
        (lambda m: symscrew.generate(m, "out", ["fortran"]), "expected targets among .*, got 'fortran'"),
        (lambda m: symscrew.generate(m, "out", precision="half"), "expected the precision .*, got 'half'"),
        (lambda m: symscrew.load(m, backend="fortran"), "expected the backend 'c' or 'casadi', got 'fortran'"),
        (
            lambda m: symscrew.assemble(m, {}, guess="x"),
            r"guess: expected finite .* of shape \(3,\), got 'x'",
        ),
        (lambda m: symscrew.assemble(m, {}, guess=[0, 1]), r"guess: expected .* of shape \(3,\), got \(2,\)"),
        (lambda m: symscrew.assemble(m, {}, guess=[0, 1, np.nan]), r"guess: expected finite .*, got \[0.0, 1.0, nan\]"),
        (lambda m: symscrew.assemble(m, {}, guess=[[0], [1, 2], 3]), "guess: expected finite real numbers"),
        (lambda m: m("velocity", "x"), "expects 2 inputs|expects 3 inputs"),
        (lambda m: m.only(["velocity", 3]), r"names\[1\]: expected a text, got 3"),
        (lambda m: m.declared("velocty"), "no function 'velocty' .* did you mean 'velocity'"),
        (lambda m: symscrew.workspace(m.mechanism, {"crank_R": "0:1:3"}, tolerances={"a": "1"}), "no parameter 'a'"),
        (lambda m: symscrew.workspace(m.mechanism, {"crank_R": "0:1:3"}, seed=-1), "--seed: expected a number from 0"),
        (lambda m: symscrew.workspace(m.mechanism, {"crank_R": "0:1:3"}, samples=0), "--samples: expected a number"),
        (
            lambda m: symscrew.workspace(m.mechanism, {"crank_R": "0:1:3"}, processes=0),
            "--processes: expected a number",
        ),
        (lambda m: symscrew.workspace(m.mechanism, {"crank_R": f"0:1:{10**12}"}), "at most"),
        (lambda m: symscrew.workspace(m.mechanism, {}), "nothing to sweep"),
        (lambda m: symscrew.analyse_mobility(m.mechanism, body="x" * 10**5), "expected the name of a body"),
    ],
)
def test_values_that_cannot_be(call: Callable[[symscrew.Model], object], said: str) -> None:
    with pytest.raises(symscrew.DescriptionError, match=said) as caught:
        call(slider_crank())
    assert len(str(caught.value)) < 4000


@cache
def slider_crank() -> symscrew.Model:
    return symscrew.derive(load("slider_crank"))


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
    with pytest.raises(symscrew.DescriptionError, match="names: expected a sequence of texts, got 'inverse_dynamics'"):
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
