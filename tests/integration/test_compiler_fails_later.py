"""A compiler that works for one function and not for the next: that one runs in CasADi, and a notice says so."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest
from support.batches import inputs
from support.model_states import model
from support.samples import some_quickly

from symscrew.runtime import CompileError, find_compiler, load

NAME, FUNCTIONS = "four_bar", ("mass_matrix", "velocity", "inverse_dynamics")


@pytest.fixture
def works_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real = find_compiler()
    if real is None:
        pytest.skip("no C compiler")
    for name in ("cc", "gcc", "clang"):
        script = f'#!/bin/sh\n[ "$1" = --version ] && exit 1\n[ -e "{tmp_path}/used" ] && exit 1\n'
        (tmp_path / name).write_text(f'{script}touch "{tmp_path}/used"\nexec "{real}" "$@"\n')
        (tmp_path / name).chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    monkeypatch.setenv("SYMSCREW_NO_CACHE", "1")


@pytest.mark.parametrize("order", some_quickly(["C", "F"], every=2))
def test_functions_that_are_refused_later_run_in_casadi(works_once: None, order: str) -> None:
    compiled = load(model(NAME).only(FUNCTIONS))
    assert compiled.backend == "c"
    notices = 0
    for name in FUNCTIONS:
        arrays = [np.asarray(array, order=order) for array in inputs(model(NAME), name, 3)]
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            *got, status = compiled[name](*arrays, check=False)
        own = [notice for notice in said if issubclass(notice.category, RuntimeWarning)]  # not CasADi's, once
        notices += len(own)
        assert all(f"four_bar: {name} runs in CasADi" in str(notice.message) for notice in own)
        expected, wanted = model(NAME)(name, *arrays)
        assert np.array_equal(status, wanted)
        for a, b, port in zip(expected, got, compiled[name].outputs, strict=True):
            b = b if len(port.shape) == 1 else np.moveaxis(b, 1, 2).reshape(3, -1)
            assert np.allclose(a, b, atol=1e-12, equal_nan=True)
    assert notices == len(FUNCTIONS) - 1


@pytest.mark.slow
def test_where_c_was_asked_for_it_is_an_error(works_once: None) -> None:
    compiled = load(model(NAME).only(FUNCTIONS), backend="c")
    refused = 0
    for name in FUNCTIONS:
        try:
            compiled[name](*inputs(model(NAME), name, 3), check=False)
        except CompileError:
            refused += 1
    assert refused == len(FUNCTIONS) - 1
