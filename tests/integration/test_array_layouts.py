"""Arrays of many states in every memory order: read where they are, and equal to single calls, statuses included."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from support import handmade
from support.batches import EXACT, difference, inputs, only
from support.model_states import model

from symscrew import catalogue
from symscrew.export import c_printed
from symscrew.model import Model, derive
from symscrew.runtime import (
    CompiledFunction,
    CompiledModel,
    EvaluationError,
    c_library,
    compiled_function,
    find_compiler,
    load,
    numpy_call,
    strided_c,
)

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]
Array = np.ndarray
ROUNDING = 1e-14  # a sine that is alone in its group of four is not the vector function's; nothing else differs
COUNT = 37  # four blocks of eight and a rest that is shorter than half of one


def thinned(x: Array) -> Array:
    return np.repeat(x, 2, axis=0)[::2]


def backwards(x: Array) -> Array:
    return np.ascontiguousarray(x[::-1, ::-1])[::-1, ::-1]


def page(x: Array) -> Array:
    """Columns that do not follow each other at the distance of the states."""
    wide = np.zeros((x.shape[1] + 1, len(x) + 5))
    wide[: x.shape[1], : len(x)] = x.T
    return wide[: x.shape[1], : len(x)].T


def packed(x: Array) -> Array:
    """Fields of records of 8 n + 1 bytes: no number stands at a multiple of eight bytes from the next one."""
    records = np.zeros(len(x), dtype=np.dtype([("flag", "i1"), ("x", float, (x.shape[1],))]))
    records["x"] = x
    return records["x"]


def locked(x: Array) -> Array:
    found = x.copy()
    found.flags.writeable = False
    return found


LAYOUTS: dict[str, Callable[[Array], object]] = {
    "rows": np.ascontiguousarray,
    "columns": np.asfortranarray,
    "thinned": thinned,
    "backwards": backwards,
    "page": page,
    "packed": packed,
    "locked": locked,
    "big endian": lambda x: x.astype(">f8"),
    "lists": lambda x: x.tolist(),
}
FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "platform_jacobian", "assemble", "energy")


@pytest.fixture(scope="module")
def found() -> Model:
    return only(model("four_bar"), *FUNCTIONS)


@pytest.fixture(scope="module")
def compiled(found: Model) -> CompiledModel:
    return load(found, backend="c", flags=EXACT)


def one_by_one(function: CompiledFunction, arrays: Sequence[Array]) -> list[Array]:
    """Outputs and status of single calls, stacked."""
    states = [function(*[x[i].copy() for x in arrays], check=False) for i in range(len(arrays[0]))]
    return [np.stack(parts) for parts in zip(*states, strict=True)]  # type: ignore[arg-type]


def same(expected: Sequence[Array], got: object, limit: float = ROUNDING) -> None:
    *values, status = expected
    *others, codes = got  # type: ignore[misc]
    assert np.array_equal(status, codes) and len(values) == len(others)
    assert all(difference(a, b) <= limit for a, b in zip(values, others, strict=True))


@pytest.mark.parametrize("function", FUNCTIONS)
def test_every_memory_order_gives_the_values_of_single_calls(
    found: Model, compiled: CompiledModel, function: str
) -> None:
    arrays = inputs(found, function, COUNT)
    arrays[-1][5] = np.nan
    expected = one_by_one(compiled[function], arrays)
    assert expected[-1][5] == 2 and np.isnan(expected[0][5]).all() and (np.delete(expected[-1], 5) <= 0).all()
    for layout in LAYOUTS.values():
        same(expected, compiled[function](*map(layout, arrays), check=False))
    for place in range(len(arrays)):  # one in another order than the others
        mixed = [np.asfortranarray(x) if k == place else x for k, x in enumerate(arrays)]
        same(expected, compiled[function](*mixed, check=False))


def test_one_state_of_an_input_stands_for_all(found: Model, compiled: CompiledModel) -> None:
    q, v, a = inputs(found, "inverse_dynamics", COUNT)
    for order in (np.ascontiguousarray, np.asfortranarray, thinned):
        for given in ((order(q), order(v), a[3]), (order(q), v[2:3], order(a)), (q[1], order(v), order(a))):
            whole = [np.broadcast_to(x, q.shape).copy() for x in given]
            same(one_by_one(compiled.inverse_dynamics, whole), compiled.inverse_dynamics(*given, check=False))
    grid = compiled.inverse_dynamics(q[:6, None], v[None, :5], a[0], check=False)
    assert grid[1].shape == (6, 5)
    for i in range(6):
        one = [np.repeat(q[i : i + 1], 5, 0), v[:5], np.repeat(a[:1], 5, 0)]
        same(one_by_one(compiled.inverse_dynamics, one), [part[i] for part in grid])


def test_batches_of_several_dimensions_in_any_order(found: Model, compiled: CompiledModel) -> None:
    arrays = inputs(found, "platform_jacobian", 24)
    expected = one_by_one(compiled.platform_jacobian, arrays)
    for shape, turned in (((4, 6), (1, 0, 2)), ((2, 3, 4), (2, 0, 1, 3))):
        given = [x.reshape(*shape, x.shape[-1]).transpose(turned) for x in arrays]
        got = compiled.platform_jacobian(*given, check=False)
        back = np.argsort(turned[:-1])
        parts = [part.transpose(*back, *range(len(back), part.ndim)) for part in got]
        same(expected, [part.reshape(24, *part.shape[len(back) :]) for part in parts])


def test_results_lie_as_the_inputs_do(found: Model, compiled: CompiledModel) -> None:
    arrays = inputs(found, "forward_dynamics", COUNT)
    assert compiled.forward_dynamics(*arrays).flags.c_contiguous
    assert compiled.forward_dynamics(*map(np.asfortranarray, arrays)).flags.f_contiguous


@pytest.mark.parametrize("order", ["C", "F", "thinned"])
def test_results_go_where_they_are_wanted(found: Model, compiled: CompiledModel, order: str) -> None:
    arrays = inputs(found, "inverse_dynamics", COUNT)
    place = np.zeros((2 * COUNT, 1))[::2] if order == "thinned" else np.zeros((COUNT, 1), order=order)  # type: ignore[call-overload]
    u = compiled.inverse_dynamics(*arrays, out=place)
    assert u is place and difference(compiled.inverse_dynamics(*arrays), place) <= ROUNDING
    given = inputs(found, "platform_jacobian", COUNT)
    expected = compiled.platform_jacobian(*given)
    for jacobian in (np.zeros(expected.shape), np.zeros(expected.shape, order="F"), np.zeros_like(expected)):
        assert compiled.platform_jacobian(*given, out=jacobian) is jacobian
        assert difference(expected, jacobian) <= ROUNDING


@pytest.mark.parametrize("threads", [float("nan"), "2", 2.5])
def test_threads_that_are_no_number_are_refused(found: Model, compiled: CompiledModel, threads: Any) -> None:
    arrays = [np.repeat(x, 9000 // COUNT + 1, axis=0) for x in inputs(found, "forward_dynamics", COUNT)]
    with pytest.raises(TypeError, match="integer"):
        compiled.forward_dynamics(*arrays, threads=threads)
    many = compiled.forward_dynamics(*arrays, threads=10**30)
    assert np.array_equal(many, compiled.forward_dynamics(*arrays))


def test_masked_entries_are_refused(found: Model, compiled: CompiledModel) -> None:
    q, v, u = inputs(found, "forward_dynamics", COUNT)
    whole = np.ma.masked_array(q)
    assert np.array_equal(compiled.forward_dynamics(whole, v, u), compiled.forward_dynamics(q, v, u))
    with pytest.raises(TypeError, match="q: expects an array of real numbers, got a masked one"):
        compiled.forward_dynamics(np.ma.masked_array(q, mask=q == q[0, 0]), v, u)


def test_places_for_results_that_do_not_fit_are_refused(found: Model, compiled: CompiledModel) -> None:
    q, v, u = inputs(found, "forward_dynamics", COUNT)
    for bad, said in (
        (np.zeros((COUNT, 3), dtype=np.float32), "float64 of shape"),
        (np.zeros((COUNT, 4)), "of shape"),
        ([0.0], "got list"),
        ((np.zeros((COUNT, 3)), np.zeros(COUNT)), "1 arrays, got 2"),
        (locked(np.zeros((COUNT, 3))), "writeable"),
        (v, "overlaps"),
        (np.broadcast_to(np.zeros(3), (COUNT, 3)), "writeable"),
        (np.lib.stride_tricks.as_strided(np.zeros(3), (COUNT, 3), (0, 8)), "several lie in one place"),
        (np.lib.stride_tricks.as_strided(np.zeros(COUNT + 2), (COUNT, 3), (8, 8)), "several lie in one place"),
    ):
        before = [x.copy() for x in (q, v, u)]
        with pytest.raises(ValueError, match=said):
            compiled.forward_dynamics(q, v, u, out=bad)
        assert all(np.array_equal(a, b) for a, b in zip(before, (q, v, u), strict=True))


@pytest.mark.parametrize("backend", ["c", "casadi"])
def test_what_is_no_real_number_is_refused(found: Model, backend: str) -> None:
    few = only(found, "inverse_dynamics")
    function = load(few, backend=backend).inverse_dynamics
    q, v, a = inputs(few, "inverse_dynamics", 3)
    for bad in (
        v + 0j,
        v.astype(object),
        v.astype(str),
        [[Fraction(1, 3)] * 3] * 3,
        v.astype("M8[s]"),
        [[1.0, 2.0], [1.0]],
    ):
        with pytest.raises(TypeError, match="inverse_dynamics, v: expects an array of real numbers, got"):
            function(q, bad, a)
    with pytest.raises(TypeError, match=r"real numbers, got one of type complex128; .* x.real"):
        function(q[0], v[0] + 0j, a[0])
    for fine in (np.zeros((3, 3), dtype=np.int8), np.zeros((3, 3), dtype=bool), np.zeros((3, 3), dtype=np.float32)):
        assert np.array_equal(function(q, fine, a), function(q, np.zeros((3, 3)), a))


def test_batches_that_do_not_fit_are_refused(found: Model, compiled: CompiledModel) -> None:
    q, v, a = inputs(found, "inverse_dynamics", 6)
    with pytest.raises(ValueError, match=r"batches that fit together, got q \(6,\), v \(4,\), a \(6,\)"):
        compiled.inverse_dynamics(q, v[:4], a)
    with pytest.raises(ValueError, match=r"expects v of shape \(3,\)"):
        compiled.inverse_dynamics(q, v[:, :2], a)


@pytest.mark.parametrize("single", [False, True])
def test_failures_are_told_in_every_order(found: Model, single: bool) -> None:
    function = load(
        only(found, "forward_dynamics"), backend="c", precision="single" if single else None
    ).forward_dynamics
    q, v, u = inputs(found, "forward_dynamics", COUNT)
    v[[4, 30]] = np.inf
    for layout in LAYOUTS.values():
        with pytest.raises(EvaluationError, match=r"2 of 37 states failed; the first is state \(4,\)") as caught:
            function(*map(layout, (q, v, u)))
        assert np.flatnonzero(caught.value.status).tolist() == [4, 30]


def test_single_precision_in_every_order(found: Model) -> None:
    compiled = load(only(found, "inverse_dynamics", "platform_jacobian"), backend="c", precision="single", flags=EXACT)
    for function in compiled.functions.values():
        arrays = inputs(found, function.name, COUNT)
        expected = one_by_one(function, arrays)
        for layout in LAYOUTS.values():
            same(expected, function(*map(layout, arrays), check=False), limit=1e-6)


def test_run_time_parameters_are_one_for_all_or_one_each() -> None:
    known = catalogue.load("ur5")
    changed = {name: replace(parameter, run_time=True) for name, parameter in known.parameters.items()}
    free = only(derive(replace(known, parameters=changed)), "inverse_dynamics")
    function = load(free, backend="c", flags=EXACT).inverse_dynamics
    assert function.inputs[-1].name == "p"
    *states, p = inputs(free, "inverse_dynamics", COUNT)
    p *= np.linspace(1.0, 1.1, COUNT)[:, None]
    for given in ((*states, p), (*states, p[2]), (*map(np.asfortranarray, states), p[2])):
        whole = [np.broadcast_to(x, (COUNT, x.shape[-1])).copy() for x in given]
        same(one_by_one(function, whole), function(*given, check=False))


def test_functions_without_blocks(found: Model, monkeypatch: pytest.MonkeyPatch) -> None:
    """Long ones run state by state; so do those of computed angles."""
    monkeypatch.setattr(c_printed, "LONG", 10)
    few = only(found, "inverse_dynamics")
    function = load(few, backend="c", flags=EXACT).inverse_dynamics
    arrays = inputs(few, "inverse_dynamics", COUNT)
    expected = one_by_one(function, arrays)
    for layout in LAYOUTS.values():
        same(expected, function(*map(layout, arrays), check=False))


def test_ports_without_entries_and_without_ports() -> None:
    hollow = handmade.program("hollow", {"x": 1, "none": 0}, {"y": lambda t, x, n: [x[0] + 1], "z": lambda t, x, n: []})
    function = load(handmade.model(hollow=hollow), backend="c").hollow
    for shape in ((), (1,), (COUNT,), (2, 3), (0,)):
        y, z, status = function(np.ones((*shape, 1)), np.ones((*shape, 0)), check=False)
        assert y.shape == (*shape, 1) and z.shape == (*shape, 0) and status.shape == shape and (y == 2.0).all()


def test_a_batch_of_one_state_takes_the_short_way(found: Model) -> None:
    """By every memory order the bits of a single call; beside a batch of several it is broadcast, by the long way."""
    few = only(found, "inverse_dynamics")
    function = load(few, backend="c", flags=EXACT).inverse_dynamics
    assert function.new is not None
    arrays = inputs(few, "inverse_dynamics", 3)
    single = function(*(x[0] for x in arrays))
    for layout in LAYOUTS.values():
        given = [layout(x)[:1] for x in arrays]
        *whole, status = function(*given, check=False)
        assert whole[0].shape == (1, len(single)) and status.tolist() == [0]
        assert np.array_equal(whole[0][0], single)
    for beside in ([x[:1] for x in arrays], [arrays[0][:1], *(x[0] for x in arrays[1:])]):
        made = function.new(beside, 1, True)
        assert made is not None and made[3] == (1,) and np.array_equal(made[1][0], [single])
    mixed = [arrays[0][:1], *arrays[1:]]
    assert function.new(mixed, 1, True) is None
    assert np.array_equal(function(*mixed, check=False)[0][0], single)


@pytest.mark.parametrize("native", [True, False])
def test_threads_give_the_same_bits(found: Model, monkeypatch: pytest.MonkeyPatch, native: bool) -> None:
    """Threads of POSIX, and threads of Python where the compiler has none."""
    if not native:
        monkeypatch.setattr("symscrew.runtime.compiled.THREADS", ("-fno-such-option",))
    monkeypatch.setattr(numpy_call, "THREAD_STATES", 64)
    monkeypatch.setattr(compiled_function, "PYTHON_THREAD_STATES", 64)
    few = only(found, "inverse_dynamics", "assemble")
    compiled = load(few, backend="c")
    for function in compiled.functions.values():
        arrays = inputs(few, function.name, 1003)
        arrays[0][700] = np.nan
        for layout in (np.ascontiguousarray, np.asfortranarray, thinned):
            given = [layout(x) for x in arrays]
            expected = function(*given, check=False)
            for threads in (1, 2, 3, 4):
                got = function(*given, check=False, threads=threads)
                assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(expected, got, strict=True))
                with pytest.raises(EvaluationError, match=r"1 of 1003 states failed; the first is state \(700,\)"):
                    function(*given, threads=threads)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_threads_after_a_fork_do_not_wait_for_ever(found: Model, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numpy_call, "THREAD_STATES", 64)
    few = only(found, "inverse_dynamics")
    function = load(few, backend="c", threads=2).inverse_dynamics
    arrays = inputs(few, "inverse_dynamics", 1003)
    expected = function(*arrays)
    child = os.fork()
    if child == 0:
        os._exit(0 if np.array_equal(function(*arrays), expected) else 1)
    for _ in range(200):
        done, outcome = os.waitpid(child, os.WNOHANG)
        if done:
            break
        time.sleep(0.05)
    else:
        os.kill(child, 9)
        os.waitpid(child, 0)
        pytest.fail("the child waits for threads of its parent")
    assert outcome == 0


def test_where_numpy_is_not_as_expected_addresses_are_asked_for(found: Model, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another Python than CPython, or a NumPy whose arrays are laid out in another way."""
    assert strided_c.NUMPY_AS_EXPECTED
    few = only(found, "inverse_dynamics")
    arrays = inputs(few, "inverse_dynamics", COUNT)
    expected = one_by_one(load(few, backend="c", flags=EXACT).inverse_dynamics, arrays)
    monkeypatch.setattr(c_library, "NUMPY_AS_EXPECTED", False)
    function = load(few, backend="c", flags=EXACT).inverse_dynamics
    assert function.new is not None and function.new(arrays, 1, True) is None
    for layout in LAYOUTS.values():
        same(expected, function(*map(layout, arrays), check=False))


def test_where_numpy_makes_arrays_in_another_way_python_makes_them(
    found: Model, monkeypatch: pytest.MonkeyPatch
) -> None:
    few = only(found, "inverse_dynamics")
    arrays = inputs(few, "inverse_dynamics", COUNT)
    expected = one_by_one(load(few, backend="c", flags=EXACT).inverse_dynamics, arrays)
    numpy_call._table.cache_clear()
    monkeypatch.setattr(numpy_call, "_makes_arrays", lambda address: False)
    function = load(few, backend="c", flags=EXACT).inverse_dynamics
    numpy_call._table.cache_clear()
    assert function.new is not None and function.new(arrays, 1, True) is None
    for layout in LAYOUTS.values():
        same(expected, function(*map(layout, arrays), check=False))


def test_calls_of_the_library_by_itself(found: Model) -> None:
    """What it takes, what it leaves to others, and that nothing is kept or given away of any object."""
    few = only(found, "inverse_dynamics")
    function = load(few, backend="c").inverse_dynamics
    arrays = inputs(few, "inverse_dynamics", COUNT)
    q, *others = arrays
    taken = [
        arrays,
        [thinned(q), *others],
        [q, *(x[0] for x in others)],
        [x[0] for x in arrays],
        [x[:1] for x in arrays],
        [q[:1], *(x[0] for x in others)],
    ]
    left = [
        [x[:0] for x in arrays],
        [q[:1], *others],
        [q.tolist(), *others],
        [q.astype("f4"), *others],
        [q[:, 1:], *others],
        [q[1:], *others],
    ]
    assert function.new is not None and all(function.new(given, 1, True) is not None for given in taken)
    assert all(function.new(given, 1, True) is None for given in [*left, arrays[:-1], [*arrays, q]])

    def counted() -> list[int]:
        return [sys.getrefcount(x) for x in (*arrays, None, np.ndarray, np.dtype(float), np.dtype(np.intc), 0, ())]

    before = counted()
    for _ in range(200):
        for told in (False, True):
            for given in taken[:2] + taken[4:] + left[1:3]:
                function.new(given, 1, told)
    worst, (u,), status, batch = function.new(taken[4], 1, True)
    assert (worst, u.shape, status.shape, batch) == (0, (1, *function.outputs[0].shape), (1,), (1,))
    assert np.array_equal(u[0], function(*taken[3]))
    worst, (u,), status, batch = function.new(arrays, 1, True)
    assert sys.getrefcount(u) == sys.getrefcount(status) == 2 and u.flags.owndata and u.flags.c_contiguous
    assert (worst, batch, status.dtype) == (0, (COUNT,), np.dtype(np.intc))
    del u, status, worst, batch
    assert max(abs(a - b) for a, b in zip(before, counted(), strict=True)) < 100
