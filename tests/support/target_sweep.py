"""Random mechanisms through every target that runs here, at states of every kind: where a target leaves the evaluator.

    wrong = differences(derive(mechanism, effects), RUN, folder)      # [], or a sentence each

States: on the mechanism, off it, all zero, tiny, far, overflowing, not finite. One row of one result is judged at a
time, so that large numbers of one state hide nothing of another's.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np

from symscrew.export import PRECISIONS, block_ports
from symscrew.generation import (
    TARGETS,
    Case,
    Results,
    c_target,
    casadi_target,
    cuda_target,
    external_target,
    javascript_target,
    jax_target,
    numpy_target,
    render,
    rust_target,
    with_brought,
)
from symscrew.generation.value_comparison import first_path, relative_difference
from symscrew.model import Model
from symscrew.program import Iteration, exact_results

from .structured_text import blocks

RUN = ("c", "casadi", "numpy", "external", "javascript", "rust", "cuda", "jax", "st")
"""Targets whose files run where Python, a C compiler, rustc and Node are."""
LIMIT = 1e-12  # of the largest entry: rounding of up to some thousand operations
ROUNDINGS = 10.0  # times the evaluator's own error by rounding, at the state and at its neighbours
NEIGHBOURS = (1e-15, -2e-15, 3e-15)  # of the inputs, relative
ILL = 1e-7  # errors by rounding beyond it leave too little to compare
ENDED = 1e-9  # of an iteration, which ends by its own tolerance
FAR = 1e160  # whose squares overflow
LARGEST_OF_TEXT = 1e6  # inputs whose products may pass 1e37, which blocks of structured text call infinite
SMALLEST = np.finfo(float).tiny  # below, numbers are zero to JAX
JUDGED_HERE = (c_target, casadi_target, cuda_target, external_target, javascript_target, jax_target, numpy_target)
NODE = javascript_target.NODE.replace("JSON.parse", "eval")  # JSON has no word for what is not finite


def hostile_inputs(model: Model, seed: int, rows: int = 3) -> dict[str, tuple[np.ndarray, ...]]:
    """Inputs of every function: `rows` of the test states, as many off the mechanism and beside it, one of others."""
    chance = np.random.default_rng(seed)
    made = {}
    for name, arrays in model.test_inputs.items():
        kept = [np.atleast_2d(x)[:rows] for x in arrays]
        one = [x[:1] for x in kept]
        parts = [kept, [chance.uniform(-3, 3, x.shape) for x in kept]]
        parts += [[x + chance.uniform(-1e-3, 1e-3, x.shape) for x in kept]]
        parts += [[np.zeros_like(x) for x in one], [x * 1e-310 for x in one]]
        parts += [[x + chance.uniform(-1, 1, x.shape) * size for x in one] for size in (1e3, 1e9, FAR)]
        for bad in (np.nan, np.inf, -np.inf):
            parts += [[*one[:k], _with(x, bad, chance), *one[k + 1 :]] for k, x in enumerate(one) if x.size]
        made[name] = tuple(np.vstack(columns) for columns in zip(*parts, strict=True))
    return made


def _with(x: np.ndarray, value: float, chance: np.random.Generator) -> np.ndarray:
    changed = x.copy()
    changed[0, chance.integers(x.shape[1])] = value
    return changed


def row_differences(model: Model, name: str, wanted: Results, got: Results) -> Iterator[str]:
    """Rows of one function in which statuses, NaN or numbers differ."""
    (arrays, status), (found, codes) = wanted, got
    for k, (code, here) in enumerate(zip(np.ravel(status), np.ravel(codes), strict=True)):
        if code != here:
            yield f"{name}, row {k}: status {here}, expected {code}"
            continue
        errors = [relative_difference(a[k], b[k]) for a, b in zip(arrays, found, strict=True)]
        if max(errors, default=0.0) <= LIMIT:
            continue
        allowed = _allowed(model, name, [a[k] for a in arrays], row=k, code=int(code))
        for port, error, most in zip(model.programs[name].outputs, errors, allowed, strict=True):
            if not error <= most:
                yield f"{name}, {port.name}, row {k}: {error:.1e} off, status {code}, allowed {most:.0e}"


def _allowed(model: Model, name: str, outputs: Sequence[np.ndarray], *, row: int, code: int) -> list[float]:
    """How far results may differ at one row, by what rounding does to those of the evaluator."""
    program = model.programs[name]
    if isinstance(program, Iteration):
        return [ENDED] * len(outputs)
    if code < 0:
        return [ILL] * len(outputs)
    own = [0.0] * len(outputs)
    for change in (0.0, *NEIGHBOURS):  # the state's own roundings can be small by luck
        state = [np.atleast_2d(x)[row : row + 1] * (1.0 + change) for x in model.test_inputs[name]]
        found, exact = model(name, *state)[0], exact_results(program, state)
        own = [max(x, relative_difference(a[0], b[0])) for x, a, b in zip(own, found, exact, strict=True)]
    return [max(LIMIT, ROUNDINGS * x) if x <= ILL else np.inf for x in own]


def _text_differences(model: Model, expected: Mapping[str, Results], text: str) -> Iterator[str]:
    """The same of structured text, run by a parser that is not ours, at states that are not too far for it."""
    made = blocks(text)
    for name, (arrays, status) in expected.items():
        inputs, outputs = block_ports(model.programs[name])
        instance = made[f"{model.name}_{name}".lower()]()
        given = model.test_inputs[name]
        near = [k for k in range(len(np.ravel(status))) if _size([x[k] for x in given]) < LARGEST_OF_TEXT]
        wanted, codes = first_path(tuple(x[near] for x in arrays), np.ravel(status)[near])
        found, told = [np.full(x.shape, np.nan) for x in wanted], []
        for place, k in enumerate(near):
            instance(**{n.lower(): x[k].tolist() for n, x in zip(inputs, given, strict=True)})
            told.append(instance.status)
            for array, symbol in zip(found, outputs, strict=True):
                if instance.valid and array.shape[1]:
                    array[place] = getattr(instance, symbol.lower())
        some = dataclasses.replace(model, test_inputs={name: tuple(x[near] for x in given)})
        yield from row_differences(some, name, (wanted, codes), (tuple(found), np.array(told)))


def _size(arrays: Sequence[np.ndarray]) -> float:
    """The largest finite number."""
    numbers = np.concatenate(arrays)
    return float(np.abs(numbers[np.isfinite(numbers)]).max(initial=0.0))


def differences(model: Model, targets: Sequence[str], folder: Path, *, seed: int = 0) -> list[str]:
    """Everything in which files of these targets, written to a folder and run, differ from the evaluator."""
    model = dataclasses.replace(model, test_inputs=hostile_inputs(model, seed))
    with np.errstate(all="ignore"):
        expected = {name: model(name, *model.test_inputs[name]) for name in model.programs}
    for name, data in render(model, with_brought(targets)).items():
        (folder / name).write_bytes(data)
    case, wrong = Case(model, expected, folder, folder, PRECISIONS["double"]), list[str]()

    def compared(what: str, _: Model, wanted: Mapping[str, Results], evaluate: Any) -> tuple[bool, str]:
        for name, results in wanted.items():
            given, seen = model.test_inputs[name], model
            if what.startswith("JAX"):
                given = tuple(np.where(np.abs(x) < SMALLEST, 0.0, x) for x in given)
                seen = dataclasses.replace(model, test_inputs={name: given})
                results = model(name, *given)
            got = evaluate(name, given)
            wrong.extend(f"{what}: {line}" for line in row_differences(seen, name, results, got))
        return True, what

    with ExitStack() as stack:
        stack.enter_context(np.errstate(all="ignore"))
        stack.enter_context(mock.patch.object(javascript_target, "NODE", NODE))
        for module in (*JUDGED_HERE, rust_target):
            stack.enter_context(mock.patch.object(module, "compare_values", compared))
        for target in with_brought(targets):
            if target == "st":
                text = (folder / f"{model.name}.st").read_text()
                wrong += [f"structured text: {line}" for line in _text_differences(model, expected, text)]
            else:
                wrong += [f"{target}: {text}" for passed, text in TARGETS[target].compare(case) if not passed]
    return wrong
