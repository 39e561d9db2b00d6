"""Long functions in parts: the same numbers and statuses as in one piece, and code that stays short."""

from __future__ import annotations

import re

import numpy as np
import pytest
from support.marks import slow
from support.model_states import model, relative

from symscrew.export import c_parts, c_printed
from symscrew.export.c import print_source
from symscrew.export.c_precision import DOUBLE
from symscrew.export.c_printed import RUN, Printed
from symscrew.model import Model
from symscrew.program.straight_line import Program
from symscrew.runtime.compiled import find_compiler, load

FUNCTIONS = ("forward_dynamics_reactions", "joint_reactions", "inverse_dynamics", "close_position", "mass_matrix")
SINGLE = "\nint stewart_6ups_mass_matrix("


@pytest.fixture
def short_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Everything counts as long."""
    for name, value in {"LONG": 1, "PART": 37}.items():
        monkeypatch.setattr(c_printed if name == "LONG" else c_parts, name, value)


def chosen(name: str) -> Model:
    found = model(name)
    return found.only(FUNCTIONS)


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
@pytest.mark.parametrize("name", [slow("three_ups_upu_s"), "four_bar"])
def test_parts_give_the_numbers_and_statuses_of_the_program(name: str, short_parts: None) -> None:
    found = chosen(name)
    assert "_part1(" in print_source(found)
    compiled = load(found, backend="c")
    for function, program in found.programs.items():
        inputs = [np.array(x) for x in found.test_inputs[function]]
        inputs[0][-1] = np.nan  # fails in C as it does in NumPy
        expected, status = found(function, *inputs)
        *results, code = compiled[function](*inputs, check=False)
        assert (code == status).all() and status[-1] == 2 and not status[:-1].any()
        for a, b, port in zip(expected, results, program.outputs, strict=True):
            flat = np.swapaxes(b, 1, 2).reshape(len(b), -1) if b.ndim == 3 else b.reshape(len(b), -1)
            assert np.isnan(flat[-1]).all() and relative(flat[:-1], a[:-1]) < 1e-12, (function, port.name)


def test_a_place_is_given_away_only_after_its_last_reader(short_parts: None) -> None:
    program = model("three_ups_upu_s").programs["forward_dynamics_reactions"]
    assert isinstance(program, Program)
    parts = c_parts.Parts(Printed("m", "m_f", program, DOUBLE))
    assert len(parts.lists) > 10 and len(set(parts.waiting.values())) < len(parts.waiting)
    holds: dict[int, int] = {}
    for k, part in enumerate(parts.lists):
        for instruction in part:
            for slot in (a for a in instruction.args if isinstance(a, int) and parts.defined.get(a, k) < k):
                assert holds[parts.waiting[slot]] == slot
            if instruction.target in parts.waiting:
                holds[parts.waiting[instruction.target]] = instruction.target


def zeros_of_the_mass_matrix() -> None:
    """Runs of zeros of the Stewart platform's mass matrix are written by loops, in front of the lane."""
    (matrix,) = chosen("stewart_6ups").programs["mass_matrix"].results
    source = print_source(chosen("stewart_6ups"))
    start = next(s for s in ("BODY(stewart_6ups_mass_matrix)(", "double stewart_6ups_mass_matrix_lane(") if s in source)
    body, function = (source[source.index(text) :] for text in (start, SINGLE))
    body, function = (text[: text.index("\n}")] for text in (body, function))
    alone = len(re.findall(r"mass_matrix(?:\[\d+\] =|, \d+, CONSTANT\()\s*0\.0", body))
    found = re.findall(r"stewart_6ups_zero\(mass_matrix(?: \+ (\d+))?, (\d+)\);", function)
    runs = [range(int(a or 0), int(a or 0) + int(size)) for a, size in found]
    assert alone + sum(map(len, runs)) == matrix.count(0.0) and alone < matrix.count(0.0) / 10
    assert min(map(len, runs)) >= RUN and all(matrix[k] == 0.0 for run in runs for k in run)


@pytest.mark.slow
def test_zeros_of_a_wide_matrix_are_not_stored_one_by_one() -> None:
    zeros_of_the_mass_matrix()


@pytest.mark.slow
def test_zeros_of_a_function_in_parts_are_not_stored_one_by_one(short_parts: None) -> None:
    zeros_of_the_mass_matrix()
