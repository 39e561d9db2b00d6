"""Which engine computes a sweep, and that all give the same numbers."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from support.model_states import model, pendulum

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.errors import DescriptionError
from symscrew.program import RankRevealing
from symscrew.runtime import CompileError, load_cuda_as_cpp
from symscrew.studies.workspace import engines, workspace

NAMES = ("cuda", "jax", "c", "casadi")


@pytest.mark.parametrize(
    ("there", "accelerated", "chosen"),
    [
        (("cuda", "jax", "c", "casadi"), True, "cuda"),
        (("jax", "c", "casadi"), True, "jax"),
        (("jax", "c", "casadi"), False, "c"),
        (("c", "casadi"), True, "c"),
        (("casadi",), False, "casadi"),
    ],
)
def test_the_fastest_that_is_there_is_chosen(
    there: tuple[str, ...], accelerated: bool, chosen: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """JAX by itself only where it has more than a processor: there C is faster."""

    def make(name: str) -> Any:
        def engine(_: object) -> Any:
            if name not in there:
                raise CompileError(f"no {name}")
            return SimpleNamespace(name=name)

        return engine

    monkeypatch.setattr(engines, "ENGINES", {name: make(name) for name in NAMES})
    monkeypatch.setattr(engines.importlib.util, "find_spec", lambda name: object() if accelerated else None)
    assert engines.fastest(pendulum()).name == chosen
    for name in NAMES:
        if name in there:
            assert engines.fastest(pendulum(), name).name == name
        else:
            with pytest.raises(DescriptionError, match=f"--engine: {name} cannot be had here: no {name}"):
                engines.fastest(pendulum(), name)
    with pytest.raises(DescriptionError, match="no engine is called 'cudo'; did you mean 'cuda'"):
        engines.fastest(pendulum(), "cudo")


def test_states_of_small_pivots_are_computed_in_c(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a device has no second path for; others, and functions without one, are left as they are."""
    derived = model("four_bar")
    assert isinstance(derived.programs["forward_dynamics"], RankRevealing)
    asked: list[tuple[str, np.ndarray]] = []

    def in_c(name: str, array: np.ndarray) -> tuple[list[np.ndarray], np.ndarray]:
        asked.append((name, array))
        return [np.full((len(array), 1), 7.0)], np.full(len(array), -1)

    monkeypatch.setattr(engines, "load", lambda _: None)
    monkeypatch.setattr(engines, "calls_of", lambda _: in_c)
    call = engines._with_second_paths(derived, lambda *_: ([np.array([[1.0], [np.nan], [3.0]])], np.array([0, 1, 2])))
    states = np.array([[10.0], [20.0], [30.0]])
    (found,), status = call("forward_dynamics", states)
    assert found.ravel().tolist() == [1.0, 7.0, 3.0] and status.tolist() == [0, -1, 2]
    ((name, array),) = asked
    assert name == "forward_dynamics" and array.tolist() == [[20.0]]
    (found,), status = call("velocity", states)
    assert np.isnan(found[1, 0]) and status.tolist() == [0, 1, 2] and len(asked) == 1


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("g++") is None, reason="needs g++")
def test_a_sweep_by_kernels_has_the_same_numbers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """By the CUDA file as C++ in place of a device; what computed it is told."""
    flags = ("-std=c++11", "-O0", "-x", "c++", "-shared", "-fPIC")
    monkeypatch.setattr(engines, "load_cuda", lambda model: load_cuda_as_cpp(model, flags=flags))
    over = {"A": "-30deg:200deg:24"}
    one = workspace(catalogue.load("four_bar"), over, processes=1, engine="c")
    other = workspace(catalogue.load("four_bar"), over, processes=4)
    assert one.summary["engine"] == "C, eight states at a time" and other.summary["engine"].startswith("CUDA")
    assert one.plan.hash == other.plan.hash and set(one.results) == set(other.results)
    for name, values in one.results.items():
        size = np.abs(values[np.isfinite(values)]).max(initial=1.0)
        np.testing.assert_allclose(other.results[name], values, rtol=0, atol=1e-11 * size, err_msg=name)
    assert main(["workspace", "four_bar", "--over", "A=0:20deg:3", "--out", str(tmp_path / "a.npz"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["engine"] == "CUDA, a thread a state"
    command = ["workspace", "four_bar", "--over", "A=0:20deg:3", "--out", str(tmp_path / "b.npz"), "--engine", "cud"]
    assert main(command) == 2
    assert "no engine is called 'cud'" in capsys.readouterr().err and not (tmp_path / "b.npz").exists()


@pytest.mark.tools
def test_a_sweep_by_jax_has_the_same_numbers() -> None:
    pytest.importorskip("jax", reason="needs JAX (pip install 'symscrew[jax]')")
    over = {"pivot": "-30deg:60deg:10"}
    one, other = (workspace(pendulum().mechanism, over, engine=name) for name in ("c", "jax"))
    assert other.summary["engine"].startswith("JAX on")
    for name, values in one.results.items():
        size = np.abs(values[np.isfinite(values)]).max(initial=1.0)
        np.testing.assert_allclose(other.results[name], values, rtol=0, atol=1e-11 * size, err_msg=name)
