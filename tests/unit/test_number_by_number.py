"""A program on Python's numbers and on arrays: the same bits and statuses, whatever the operations and the numbers."""

from __future__ import annotations

import gc
import itertools

import numpy as np
import pytest
from support.handmade import every_operation, guarded

import symscrew
from symscrew.program import evaluate, numpy_evaluation
from symscrew.program.number_by_number import _READY, number_by_number

SPECIAL = (0.0, -0.0, 1.0, -2.5, 1e200, -np.inf, np.nan)


def assert_equal(results, others):
    """Numbers and their signs, of zeros too."""
    for one, other in zip(results, others, strict=True):
        assert one.shape == other.shape
        assert np.array_equal(one, other, equal_nan=True)
        assert np.array_equal(np.signbit(one) & ~np.isnan(one), np.signbit(other) & ~np.isnan(other))


def assert_same(program, arguments, monkeypatch):
    """One by one as on arrays, for arguments of a few states."""
    few = evaluate(program, arguments)
    with monkeypatch.context() as changed:
        changed.setattr(numpy_evaluation, "FEW", 0)
        many = evaluate(program, arguments)
    assert np.array_equal(few[1], many[1])
    assert_equal(few[0], many[0])


def test_every_operation_with_numbers_of_every_kind(monkeypatch):
    program, states = every_operation(), np.array(list(itertools.product(SPECIAL, repeat=3)))
    many = evaluate(program, [states, np.zeros(2)])
    few = [evaluate(program, [state, np.zeros(2)]) for state in states]
    assert_equal(tuple(np.array([f[0][k] for f in few]) for k in range(2)), many[0])
    assert [int(status) for _, status in few] == many[1].tolist()
    assert set(many[1].tolist()) == {0, 2}


@pytest.mark.parametrize("x", [[0.0, 1.0], [1e-10, 1.0], [-2.0, 3.0], [1.0, np.nan], [0.5, 1e300]])
def test_guards_and_what_overflows(x, monkeypatch):
    assert_same(guarded(), [np.array(x)], monkeypatch)


@pytest.mark.parametrize("batch", [(), (1,), (2, 3), (8,)])
def test_functions_of_a_mechanism(batch, monkeypatch):
    model = symscrew.derive(symscrew.load_catalogue("four_bar"))
    random = np.random.default_rng(5)
    for name in ("assemble", "inverse_dynamics", "forward_dynamics"):
        program = model.programs[name]
        program = getattr(program, "step", program)
        shapes = [batch, *[batch[-1:]] * (len(program.inputs) - 1)]  # arrays of less broadcast
        arguments = [random.uniform(-2, 2, (*s, port.size)) for s, port in zip(shapes, program.inputs, strict=True)]
        assert_same(program, arguments, monkeypatch)


def test_where_python_has_no_number_the_arrays_answer():
    assert number_by_number(guarded())([0.0, 1.0]) == []
    assert evaluate(guarded(), [np.zeros(2)])[1] == 1


def test_no_state_at_all():
    (scalars, _), status = evaluate(every_operation(), [np.zeros((0, 3)), np.zeros((0, 2))])
    assert scalars.shape == (0, 15) and status.shape == (0,)


def test_a_program_is_made_ready_once_and_forgotten_with_it():
    program = guarded()
    assert number_by_number(program) is number_by_number(program)
    key = id(program)
    assert key in _READY
    del program
    gc.collect()
    assert key not in _READY
