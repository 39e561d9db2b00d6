"""Recorded programs as operations of JAX: values, tangents, transposes, batches; printed into modules for JAX.

    listing --record--> Recorded --bind--> straight_line, linear_part: primitives on arrays (entries, states)

Each primitive runs its program's table in a loop, so that tracing and compiling take the same time for all sizes; on
accelerators, where a loop would start a kernel an operation, the operations are traced one by one. A batch of `vmap`
is more states. Tangents and transposes are programs of the same kind (`symscrew.export.recorded`), so that
derivatives of every order need no trace of single operations. Failing states are NaN, and so are their derivatives,
but where nobody asks: a cotangent of 0 stays 0.
"""

from __future__ import annotations

import inspect
from collections import namedtuple
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax import lax
from jax.extend.core import Primitive
from jax.interpreters import ad, batching, mlir

from symscrew.export.recorded import ARITHMETIC, CONSTANT, INPUT, Recorded, record

MEMORY = 2**21  # bytes of rows that are worked on at a time: about a second-level cache
SMALLEST_BLOCK = 64  # states: with fewer, the loop costs more than its arithmetic
UNROLLED = ("cuda", "rocm", "tpu")  # platforms on which operations are traced one by one
SINGLE_DIGITS = 7.2 / 16  # the part of the digits of double that single precision has: thresholds keep that part

OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": lambda a, b, c: a + b,
    "sub": lambda a, b, c: a - b,
    "mul": lambda a, b, c: a * b,
    "div": lambda a, b, c: a / b,
    "sqrt": lambda a, b, c: jnp.sqrt(a),
    "exp": lambda a, b, c: jnp.exp(a),
    "sin": lambda a, b, c: jnp.sin(a),
    "cos": lambda a, b, c: jnp.cos(a),
    "tan": lambda a, b, c: jnp.tan(a),
    "atan2": lambda a, b, c: jnp.arctan2(a, b),
    "abs": lambda a, b, c: jnp.abs(a),
    "less": lambda a, b, c: jnp.where(a < b, 1.0, 0.0).astype(a.dtype),
    "select": lambda a, b, c: jnp.where(a != 0.0, b, c),
}


def _looped(program: Recorded, entries: Any) -> Any:
    """Results (results, states) of entries (inputs, states), in blocks of states that stay in the cache."""
    states, rows = entries.shape[1], program.table.rows
    block = max(SMALLEST_BLOCK, 2 ** (MEMORY // (rows * entries.dtype.itemsize)).bit_length() // 2)
    if states <= 2 * block:
        return _block(program, entries)
    count = -(-states // block)
    filled = jnp.pad(entries, ((0, 0), (0, count * block - states)), mode="edge")
    blocks = jnp.moveaxis(filled.reshape(len(filled), count, block), 1, 0)
    found = lax.map(partial(_block, program), blocks)
    return jnp.moveaxis(found, 0, 1).reshape(found.shape[1], count * block)[:, :states]


def _block(program: Recorded, entries: Any) -> Any:
    table, states, zero = program.table, entries.shape[1], jnp.int32(0)
    constants = jnp.broadcast_to(jnp.asarray(table.constants, entries.dtype)[:, None], (len(table.constants), states))
    free = jnp.zeros((table.rows - len(entries) - len(constants), states), entries.dtype)
    memory = jnp.concatenate([entries, constants, free])
    for operations, codes, places in table.runs:
        code, place = jnp.asarray(codes), jnp.asarray(places)

        def row(memory: Any, k: Any, column: int, *, place: Any = place) -> Any:
            return lax.dynamic_slice(memory, (place[k, column], zero), (1, states))

        def arithmetic(k: Any, state: Any, *, code: Any = code, place: Any = place, known: Any = operations) -> Any:
            memory, result, where = state  # written in the next turn: the memory is changed in place only so
            memory = lax.dynamic_update_slice(memory, result, (where, zero))
            a, b, op = row(memory, k, 0, place=place), row(memory, k, 1, place=place), code[k]
            found = OPERATIONS[known[0]](a, b, b)
            for number, name in enumerate(known[1:], 1):
                found = jnp.where(op == number, OPERATIONS[name](a, b, b), found)
            return memory, found, place[k, 3]

        def chosen(k: Any, memory: Any, *, code: Any = code, place: Any = place, known: Any = operations) -> Any:
            operands = [row(memory, k, column, place=place) for column in range(3)]
            result = lax.switch(code[k], [OPERATIONS[name] for name in known], *operands)
            return lax.dynamic_update_slice(memory, result, (place[k, 3], zero))

        if operations[0] in ARITHMETIC:
            first = place[0, 3]
            state = memory, lax.dynamic_slice(memory, (first, zero), (1, states)), first
            memory, result, where = lax.fori_loop(0, len(codes), arithmetic, state)
            memory = lax.dynamic_update_slice(memory, result, (where, zero))
        else:
            memory = lax.fori_loop(0, len(codes), chosen, memory)
    return memory[table.results]


def _unrolled(program: Recorded, entries: Any) -> Any:
    """The same, every operation traced by itself."""
    made: dict[int, Any] = {}
    for node in program.needed(program.results):
        op, *args = program.nodes.ops[node]
        if op == INPUT:
            made[node] = entries[args[0]]
        elif op == CONSTANT:
            made[node] = jnp.full(entries.shape[1:], args[0], entries.dtype)
        elif op == "neg":
            made[node] = -made[args[0]]
        else:
            operands = [made[a] for a in args]
            made[node] = OPERATIONS[op](*(operands + 2 * operands[:1])[:3])
    if not program.results:
        return jnp.zeros((0, *entries.shape[1:]), entries.dtype)
    return jnp.stack([made[node] for node in program.results])


def _values(entries: Any, *, program: Recorded, tested: int, way: Any = _looped) -> Any:
    found = way(program, entries)
    return found[: len(found) - tested], found[len(found) - tested :]


def _linear(entries: Any, directions: Any, *, program: Recorded, way: Any = _looped) -> Any:
    found = way(program, jnp.concatenate([entries, directions]))
    return [jnp.where((directions == 0.0).all(axis=0), 0.0, found).astype(entries.dtype)]


def _primitive(name: str, function: Callable[..., Any], shapes: Callable[..., Any]) -> Primitive:
    """A primitive with several results, evaluated by a function that is compiled once per program."""
    made = Primitive(name)
    made.multiple_results = True
    made.def_abstract_eval(shapes)
    static = [key for key in inspect.signature(function).parameters if key in ("program", "tested", "way")]
    compiled = jax.jit(function, static_argnames=static)
    made.def_impl(lambda *arrays, **settings: compiled(*arrays, **settings))
    mlir.register_lowering(made, mlir.lower_fun(function, multiple_results=True))
    if "way" in static:
        for platform in UNROLLED:
            unrolled = mlir.lower_fun(partial(function, way=_unrolled), multiple_results=True)
            mlir.register_lowering(made, unrolled, platform=platform)
    return made


def _value_shapes(entries: Any, *, program: Recorded, tested: int) -> Any:
    count, states = len(program.results), entries.shape[1]
    return [jax.core.ShapedArray((n, states), entries.dtype) for n in (count - tested, tested)]


def _linear_shapes(entries: Any, directions: Any, *, program: Recorded) -> Any:
    return [jax.core.ShapedArray((len(program.results), entries.shape[1]), entries.dtype)]


def _kept_shapes(values: Any, failed: Any) -> Any:
    return [jax.core.ShapedArray(values.shape, values.dtype)]


straight_line = _primitive("straight_line", _values, _value_shapes)
linear_part = _primitive("linear_part", _linear, _linear_shapes)
kept = _primitive("kept", lambda x, failed: [jnp.where(failed, jnp.nan, x)], _kept_shapes)
kept_change = _primitive("kept_change", lambda x, failed: [jnp.where(failed & (x != 0), jnp.nan, x)], _kept_shapes)


def _along(entries: Any, change: Any, program: Recorded) -> Any:
    return linear_part.bind(entries, change, program=program)[0]


def _values_tangent(primals: Any, tangents: Any, *, program: Recorded, tested: int) -> Any:
    found, checked = straight_line.bind(*primals, program=program, tested=tested)
    count = len(program.results) - tested
    change = _along(primals[0], ad.instantiate_zeros(tangents[0]), program.tangent(count=count))
    return [found, checked], [change, jnp.zeros_like(checked)]


def _linear_tangent(primals: Any, tangents: Any, *, program: Recorded) -> Any:
    entries, directions = primals
    moved, turned = tangents
    changes = []
    if type(turned) is not ad.Zero:
        changes.append(_along(entries, turned, program))
    if type(moved) is not ad.Zero:
        derived = program.tangent(active=tuple(range(program.size - program.linear)))
        changes.append(_along(jnp.concatenate([entries, directions]), moved, derived))
    return [_along(entries, directions, program)], [sum(changes[1:], start=changes[0])]


def _linear_transpose(cotangents: Any, entries: Any, directions: Any, *, program: Recorded) -> Any:
    (given,) = cotangents
    if type(given) is ad.Zero:
        return [None, ad.Zero(directions.aval)]
    return [None, _along(entries, given, program.adjoint)]


def _kept_tangent(value: Primitive, primals: Any, tangents: Any) -> Any:
    (values, failed), moved = primals, tangents[0]
    found = value.bind(values, failed)
    if type(moved) is ad.Zero:
        return found, [jnp.zeros_like(found[0])]
    return found, kept_change.bind(moved, failed)


def _kept_transpose(cotangents: Any, values: Any, failed: Any) -> Any:
    (given,) = cotangents
    return [ad.Zero(values.aval) if type(given) is ad.Zero else kept_change.bind(given, failed)[0], None]


ad.primitive_jvps[straight_line] = _values_tangent
ad.primitive_jvps[linear_part] = _linear_tangent
ad.primitive_transposes[linear_part] = _linear_transpose
ad.primitive_jvps[kept] = partial(_kept_tangent, kept)
ad.primitive_jvps[kept_change] = partial(_kept_tangent, kept_change)
ad.primitive_transposes[kept_change] = _kept_transpose


def _batched(primitive: Primitive, arrays: Sequence[Any], axes: Sequence[Any], **settings: Any) -> Any:
    """A batch is more states."""
    count = next(x.shape[axis] for x, axis in zip(arrays, axes, strict=True) if axis is not None)
    folded = []
    for x, axis in zip(arrays, axes, strict=True):
        whole = jnp.broadcast_to(x, (count, *x.shape)) if axis is None else jnp.moveaxis(x, axis, 0)
        folded.append(jnp.moveaxis(whole, 0, 1).reshape(whole.shape[1], count * whole.shape[2]))
    found = primitive.bind(*folded, **settings)
    return [x.reshape(len(x), count, -1) for x in found], [1] * len(found)


for _each in (straight_line, linear_part, kept, kept_change):
    batching.primitive_batchers[_each] = partial(_batched, _each)


def _threshold(value: float, dtype: Any) -> float:
    return float(value if dtype == jnp.float64 or not value else value**SINGLE_DIGITS)


def _status(tested: Any, guards: Sequence[float], limits: Sequence[Any]) -> Any:
    """The statuses (states) of what is tested: pivots, what has limits, and the sum that must be finite."""
    pivots, bounded, total = tested[: len(guards)], tested[len(guards) : -1], tested[-1]
    status = jnp.zeros(total.shape, jnp.int32)
    for value, (low, high, code) in zip(bounded, limits, strict=True):
        within = (value >= (-np.inf if low is None else low)) & (value <= (np.inf if high is None else high))
        status = jnp.where((status == 0) & ~within, jnp.where(jnp.isfinite(value), code, 2), status)
    for value, limit in zip(pivots, guards, strict=True):
        small = jnp.abs(value) <= _threshold(limit, total.dtype)
        status = jnp.where((status == 0) & small, 1, status)
    return jnp.where((status == 0) & ~jnp.isfinite(total), 2, status)


class Step:
    """A listing with the sizes of its inputs and outputs and what decides its status; recorded when first used."""

    def __init__(
        self,
        listing: Callable[..., Any],
        *,
        inputs: dict[str, int],
        outputs: dict[str, int],
        guards: Sequence[float] = (),
        limits: Sequence[tuple[float | None, float | None, int]] = (),
    ) -> None:
        self.listing, self.inputs, self.outputs = listing, inputs, outputs
        self.guards, self.limits = guards, limits
        self._program: Recorded | None = None

    @property
    def program(self) -> Recorded:
        """The program: all outputs, then what is tested."""
        if self._program is None:
            self._program = record(self.listing, sum(self.inputs.values()))
        return self._program

    def rows(self, entries: Any) -> tuple[list[Any], Any]:
        """Outputs (size, states), not yet NaN where they fail, and statuses (states) of entries (all, states)."""
        tested = len(self.guards) + len(self.limits) + 1
        values, tests = straight_line.bind(entries, program=self.program, tested=tested)
        cuts = np.cumsum([*self.outputs.values()])[:-1]
        return jnp.split(values, cuts), _status(tests, self.guards, self.limits)


def _public(name: str, rows: Any, *, inputs: dict[str, int], outputs: Sequence[str], text: str) -> Callable[..., Any]:
    """A function of arrays (*batch, size) from one of rows (size, states)."""
    parameters = [inspect.Parameter(port, inspect.Parameter.POSITIONAL_OR_KEYWORD) for port in inputs]
    signature = inspect.Signature(parameters)
    kind = _kind(name, outputs)

    def function(*arguments: Any, **named: Any) -> Any:
        bound = signature.bind(*arguments, **named).arguments
        arrays = [_real(f"{name}: {port}", size, bound[port]) for port, size in inputs.items()]
        dtype = jnp.result_type(*arrays)
        batch = jnp.broadcast_shapes(*(x.shape[:-1] for x in arrays))
        whole = [jnp.broadcast_to(x.astype(dtype), (*batch, x.shape[-1])) for x in arrays]
        states = int(np.prod(batch))  # not -1: an array may have no entries
        values, status = rows(*(jnp.moveaxis(x.reshape(states, x.shape[-1]), 0, 1) for x in whole))
        safe = [kept.bind(x, jnp.broadcast_to(status != 0, x.shape))[0] for x in values]
        return kind(*(jnp.moveaxis(x, 0, 1).reshape(*batch, len(x)) for x in safe), status.reshape(batch))

    function.__name__ = function.__qualname__ = name
    function.__doc__, function.__signature__ = text, signature  # type: ignore[attr-defined]
    return function


def _kind(name: str, outputs: Sequence[str]) -> Any:
    return namedtuple("".join(part.capitalize() for part in name.split("_")), [*outputs, "status"])


def _real(where: str, size: int, argument: Any) -> Any:
    array = jnp.asarray(argument)
    if jnp.issubdtype(array.dtype, jnp.complexfloating):
        raise TypeError(f"{where}: expected real numbers, got {array.dtype}")
    if array.shape[-1:] != (size,):
        raise ValueError(f"{where} has {size} entries in its last dimension, got {array.shape}")
    if not jnp.issubdtype(array.dtype, jnp.floating):
        return array.astype(jnp.zeros(()).dtype)
    return array if array.dtype in (jnp.float32, jnp.float64) else array.astype(jnp.float32)


def straight(name: str, step: Step, text: str) -> Callable[..., Any]:
    """The function of a straight-line program."""

    def rows(*given: Any) -> tuple[list[Any], Any]:
        return step.rows(jnp.concatenate(given))

    return _public(name, rows, inputs=step.inputs, outputs=[*step.outputs], text=text)


def iterated(name: str, step: Step, text: str, **settings: Any) -> Callable[..., Any]:
    """The function of an iteration: (y, guess, parameters) to q, differentiated where it has converged."""
    inputs = {"y": step.inputs["y"], "guess": step.inputs["q"], **dict([*step.inputs.items()][2:])}
    solve = _solver(step, **settings)

    def rows(y: Any, guess: Any, *parameters: Any) -> tuple[list[Any], Any]:
        q, status = solve(y, guess, *parameters)
        return [q], status

    return _public(name, rows, inputs=inputs, outputs=["q"], text=text)


def _solver(
    step: Step, *, independent: Sequence[int], tolerance: float, steps: int, substeps: int, refused: int
) -> Any:
    size = step.inputs["q"]

    def solve(y: Any, guess: Any, *parameters: Any) -> tuple[Any, Any]:
        bound = _threshold(tolerance, y.dtype)
        start = guess[np.array(independent, int)]
        (_, _, _, branch), first = step.rows(jnp.concatenate([guess, start, *parameters]))
        finite = jnp.isfinite(jnp.concatenate([y, guess, *parameters])).all(axis=0)
        outcome = jnp.where(~finite, 2, jnp.where(first >= refused, first, 3)).astype(jnp.int32)

        def newton(target: Any, q: Any, active: Any) -> tuple[Any, Any]:
            def again(state: Any) -> Any:
                return (state[0] < steps) & state[3].any()

            def once(state: Any) -> Any:
                count, q, outcome, running = state
                (following, residual, change, sign), status = step.rows(jnp.concatenate([q, target, *parameters]))
                failed = running & (status != 0)
                moving = running & ~failed
                done = moving & (residual[0] < bound) & (change[0] < bound)
                reached = jnp.where(sign[0] * branch[0] > 0.0, 0, 4).astype(jnp.int32)
                return count + 1, jnp.where(moving, following, q), jnp.where(done, reached, outcome), moving & ~done

            _, q, outcome, _ = lax.while_loop(again, once, (0, q, jnp.full(active.shape, 3, jnp.int32), active))
            return q, outcome

        def way(state: Any) -> Any:
            parts, q, outcome = state
            waiting = (outcome == 3) | (outcome == 4)

            def part(k: Any, inner: Any) -> Any:
                q, sound = inner
                target = start + (y - start) * (k / parts).astype(y.dtype)
                q, found = newton(target, q, sound == 0)
                return q, jnp.where(sound == 0, found, sound)

            begun = jnp.where(waiting, 0, 1).astype(jnp.int32)
            found, reached = lax.fori_loop(1, parts + 1, part, (guess, begun))
            return 2 * parts, jnp.where(waiting & (reached == 0), found, q), jnp.where(waiting, reached, outcome)

        def left(state: Any) -> Any:
            return (state[0] <= substeps) & ((state[2] == 3) | (state[2] == 4)).any()

        _, q, outcome = lax.while_loop(left, way, (jnp.int32(1), guess, outcome))
        return q, outcome

    def along(primals: Any, tangents: Any) -> Any:
        y, _, *parameters = primals
        q, status = solved(*primals)
        entries = jnp.concatenate([q, y, *parameters])
        change = jnp.concatenate([tangents[0], *tangents[2:]])
        program = step.program.at_rest.tangent(active=tuple(range(size, len(entries))), count=size)
        return (q, status), (_along(entries, change, program), np.zeros(status.shape, jax.dtypes.float0))

    solved = jax.custom_jvp(solve)
    solved.defjvp(along)
    return solved
