"""Do all targets give the numbers of the reference evaluator? Each is run at the model's test states.

Where a compiler or Node is missing, the result says so.
"""

from __future__ import annotations

import importlib.util
import json
import shutil
import subprocess
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from symscrew.export import jacobians_model, rounded, single_errors
from symscrew.fmu import compare_unit
from symscrew.formats import difference, load_format
from symscrew.generation import FORMATS
from symscrew.model import Model
from symscrew.program import Port
from symscrew.runtime import casadi_evaluator, compile_c, find_compiler, load

TOLERANCE = 1e-12
FLOOR = 1e-3
STRICT = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wdouble-promotion", "-Wconversion", "-Werror")
SINGLE_FACTOR = 8.0  # sines, roundings and contractions of compilers differ
Results = tuple[tuple[np.ndarray, ...], np.ndarray]


def compare_targets(
    fresh: Path,
    directory: Path,
    model: Model,
    expected: Mapping[str, Results],
    *,
    targets: Sequence[str],
    single: bool,
) -> Iterator[tuple[bool, str]]:
    """(passed, what) of every target in `fresh`, where it has just been generated; .casadi files are of `directory`."""
    if "c" in targets and find_compiler():
        yield compare_single(fresh, model) if single else compare_values("C", model, expected, _c_results(fresh))
        if "external" in targets:
            yield from _external(fresh, model, expected)
    if "casadi" in targets:
        yield compare_values("CasADi", model, expected, _casadi_results(directory, fresh, model))
    if "numpy" in targets:
        module = _import(fresh / f"{model.name}_numpy.py")
        yield compare_values("NumPy module", model, expected, lambda name, x: getattr(module, name)(*x))
    if "javascript" in targets:
        yield _javascript(fresh, model, expected)
    if "fmu" in targets:
        yield from _unit(fresh, model)
    for target, suffix in FORMATS.items():
        if target in targets:
            found = difference(model.mechanism, load_format(fresh / f"{model.name}{suffix}"))
            yield found is None, f"{target.upper()} read back: {found or 'joints, places and inertias agree'}"


def compare_values(
    what: str,
    model: Model,
    expected: Mapping[str, Results],
    evaluate: Callable[[str, Sequence[np.ndarray]], Results],
) -> tuple[bool, str]:
    """Largest difference per output array, relative to its largest entry (or to 1e-3 if all are smaller)."""
    worst, where = 0.0, ""
    for name, (arrays, status) in expected.items():
        got, got_status = evaluate(name, model.test_inputs[name])
        if not np.array_equal(np.ravel(status), np.ravel(got_status)):
            return False, f"{what}: status of {name} is {np.ravel(got_status)}, expected {np.ravel(status)}"
        for port, a, b in zip(model.programs[name].outputs, arrays, got, strict=True):
            error = relative_difference(a, b)
            if not error <= worst:
                worst, where = error, f"{name}, {port.name}"
    passed = worst <= TOLERANCE
    place = f" ({where})" if where else ""
    return passed, f"{what} agrees with the evaluator to {worst:.1e} relative{place}, limit {TOLERANCE:.0e}"


def compare_single(directory: Path, model: Model) -> tuple[bool, str]:
    """C of type float against double on the same numbers: errors of the size that the header states."""
    compiled, worst, where = load(directory, backend="c"), 0.0, ""
    for name, (_, stated) in single_errors(model).items():
        inputs = [rounded(np.atleast_2d(x)) for x in model.test_inputs[name]]
        exact, status = model(name, *inputs)
        got = _evaluated(compiled[name].evaluator, [p.size for p in compiled[name].outputs], inputs)
        sound = (np.atleast_1d(status) == 0) & (got[1] == 0)
        if not sound.any():
            return False, f"C in single precision: no state of {name} has the status 0"
        for port, a, b, error in zip(model.programs[name].outputs, exact, got[0], stated, strict=True):
            factor = relative_difference(a[sound], b[sound]) / max(error, 1e-6)
            if not factor <= worst:
                worst, where = factor, f"{name}, {port.name}"
    text = f"C in single precision differs from double by at most {worst:.1f} times what the header states ({where})"
    return worst <= SINGLE_FACTOR, f"{text}, limit {SINGLE_FACTOR:.0f}"


def relative_difference(expected: np.ndarray, got: np.ndarray) -> float:
    """max |expected - got| over max |expected|, at least 1e-3; infinite if NaN does not meet NaN."""
    if expected.shape != got.shape or not np.array_equal(np.isnan(expected), np.isnan(got)):
        return float("inf")
    scale = max(float(np.nanmax(np.abs(expected), initial=0.0)), FLOOR)
    return float(np.nanmax(np.abs(expected - got), initial=0.0)) / scale


def _c_results(directory: Path) -> Callable[[str, Sequence[np.ndarray]], Results]:
    compiled = load(directory, backend="c", flags=("-ffp-contract=off", *STRICT))

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        function = compiled[name]
        return _evaluated(function.evaluator, [p.size for p in function.outputs], inputs)

    return evaluate


def _casadi_results(directory: Path, fresh: Path, model: Model) -> Callable[[str, Sequence[np.ndarray]], Results]:
    import casadi

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        path = directory / f"{name}.casadi"
        function = casadi.Function.load(str(path if path.is_file() else fresh / path.name))
        return _evaluated(casadi_evaluator(function), [p.size for p in model.programs[name].outputs], inputs)

    return evaluate


def _external(directory: Path, model: Model, expected: Mapping[str, Results]) -> Iterator[tuple[bool, str]]:
    """Values and Jacobians of the functions in CasADi's ABI; a state that must fail has to fail."""
    library = directory / f"lib{model.name}_external.so"
    others = [str(directory / f"{model.name}{part}.c") for part in ("_jacobians", "_external")]
    compile_c(directory / f"{model.name}.c", library, flags=("-ffp-contract=off", *others))

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        ports = (model.programs[name].inputs, model.programs[name].outputs)
        function = load_external(library, f"{model.name}_casadi_{name}")
        rows = [_external_row(function, *ports, state) for state in zip(*inputs, strict=True)]
        # the ABI only says that a state failed, not why
        wanted = np.ravel(expected[name][1])
        status = np.where([(row is None) == (code > 0) for row, code in zip(rows, wanted, strict=True)], wanted, -9)
        failed = tuple(np.full(port.size, np.nan) for port in ports[1])
        columns = zip(*(failed if row is None else row for row in rows), strict=True)
        return tuple(np.array(column) for column in columns), status

    yield compare_values("CasADi external", model, expected, evaluate)
    derived, jacobians = jacobians_model(model)
    worst = 0.0
    for name, made in jacobians.items():
        function = load_external(library, f"jac_{model.name}_casadi_{name}")
        values, status = derived(made.program.name, *derived.test_inputs[made.program.name])
        for k in np.flatnonzero(np.asarray(status) == 0):
            state = [array[k] for array in (*model.test_inputs[name], *expected[name][0])]
            found = function.call(_shaped((*made.source.inputs, *made.source.outputs), state))
            for port, value in zip(made.program.outputs, values, strict=True):
                output, place, *_ = made.blocks[port.name]
                block = found[output * len(made.source.inputs) + place]
                worst = max(worst, relative_difference(value[k], np.array(block.nonzeros())))
    yield worst <= TOLERANCE, f"{len(jacobians)} Jacobians of CasADi externals agree with the evaluator to {worst:.1e}"


NODE = """
const model = require(process.argv[1]);
const calls = JSON.parse(require("fs").readFileSync(process.argv[2], "utf8"));
const plain = (value) => typeof value === "object" ? Array.from(value) : value;
const entries = (result) => Object.entries(result).map(([key, value]) => [key, plain(value)]);
const answers = calls.map(([name, given]) => Object.fromEntries(entries(model[name](...given))));
process.stdout.write(JSON.stringify(answers));
"""


def _javascript(directory: Path, model: Model, expected: Mapping[str, Results]) -> tuple[bool, str]:
    """Values by Node. There is no second path in JavaScript: where the others take it, its status is 1."""
    node = shutil.which("node")
    if node is None:
        return True, "no Node here (apt install nodejs): JavaScript not run"
    calls = [
        (name, [array[k].tolist() for array in model.test_inputs[name]])
        for name, (_, status) in expected.items()
        for k in range(len(np.ravel(status)))
    ]
    (directory / "calls.json").write_text(json.dumps(calls))
    command = [node, "-e", NODE, str(directory / f"{model.name}.js"), str(directory / "calls.json")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        return False, f"Node refuses {model.name}.js: {done.stderr.strip()[:300]}"
    answers = iter(json.loads(done.stdout))

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        rows = [next(answers) for _ in np.ravel(expected[name][1])]
        ports = model.programs[name].outputs
        arrays = tuple(np.array([row[p.name] for row in rows], dtype=float).reshape(-1, p.size) for p in ports)
        return arrays, np.array([row["status"] for row in rows])

    first = {name: _first_path(*found) for name, found in expected.items()}
    return compare_values("JavaScript", model, first, evaluate)


def _first_path(arrays: tuple[np.ndarray, ...], status: np.ndarray) -> Results:
    """Results of code without a second path: near a small pivot NaN and status 1."""
    second = np.asarray(status) < 0
    return tuple(np.where(second[..., None], np.nan, array) for array in arrays), np.where(second, 1, status)


def _unit(directory: Path, model: Model) -> Iterator[tuple[bool, str]]:
    """What is in the unit that has just been made, compiled and run."""
    if find_compiler() is None:
        yield True, "no C compiler here (apt install gcc): FMU neither compiled nor run"
        return
    with zipfile.ZipFile(directory / f"{model.name}.fmu") as unit:
        yield from compare_unit({name: unit.read(name) for name in unit.namelist()}, model)


def _external_row(
    function: Any, inputs: Sequence[Port], outputs: Sequence[Port], state: Sequence[np.ndarray]
) -> tuple[np.ndarray, ...] | None:
    """The outputs (size) of an external function at one state, None where it fails."""
    try:
        found = function.call(_shaped(inputs, state))
    except RuntimeError:
        return None
    return tuple(np.array(x).T.reshape(port.size) for port, x in zip(outputs, found, strict=True))


def _shaped(ports: Sequence[Port], state: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Arrays (size) as CasADi wants them: matrices, where the port is one."""
    return [x.reshape(p.shape, order="F") if len(p.shape) == 2 else x for p, x in zip(ports, state, strict=True)]


def load_external(library: Path, symbol: str) -> Any:
    """A function of a shared library in CasADi's ABI."""
    import casadi

    return casadi.external(symbol, str(library))


def _evaluated(evaluator: Callable[..., None], sizes: Sequence[int], inputs: Sequence[np.ndarray]) -> Results:
    states = len(inputs[0]) if inputs else 1
    outputs = tuple(np.empty((states, size)) for size in sizes)
    status = np.zeros(states, dtype=np.intc)
    evaluator([np.ascontiguousarray(x, dtype=float) for x in inputs], outputs, status)
    return outputs, status


def _import(path: Path) -> ModuleType:
    """A module from a file, without entering it among the imported modules."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
