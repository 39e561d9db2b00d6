"""Is generated output what the tool generates today, does it compile, and do its targets agree?

`check` derives the model again from the directory's mechanism.toml and the effects in its manifest, and
compares bytes. Only what has just been generated is compiled and run, never code found in the directory; a
.casadi file with other bytes (they depend on the version of CasADi) is loaded and compared by value.
"""

from __future__ import annotations

import dataclasses
import importlib.util
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from symscrew import description
from symscrew.compiled import casadi_evaluator, compile_c, find_compiler, load
from symscrew.export.c_single import rounded, single_errors
from symscrew.export.casadi_external import jacobians_model
from symscrew.generation import TARGETS, render
from symscrew.manifest import OutputError, effect_from_json, model_hash, read_json, read_manifest
from symscrew.model import Model, derive
from symscrew.program import Port

TOLERANCE = 1e-12
FLOOR = 1e-3
SINGLE_FACTOR = 8.0  # sines, roundings and contractions of compilers differ
STRICT = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wdouble-promotion", "-Wconversion", "-Werror")
Results = tuple[tuple[np.ndarray, ...], np.ndarray]


@dataclass(frozen=True)
class CheckResult:
    """`ok`, and a line per check: "<mechanism>: ok ..." or "<mechanism>: FAILED ..."."""

    ok: bool
    lines: tuple[str, ...]


def check(directory: str | Path) -> CheckResult:
    """Check one generated directory, or every one in a directory of such.

    Raises:
        OutputError: there is nothing generated at this place.
    """
    root = Path(directory)
    if (root / "manifest.json").is_file():
        found = [root]
    elif root.is_dir():
        found = sorted(path.parent for path in root.glob("*/manifest.json"))
    else:
        found = []
    if not found:
        raise OutputError(f"{root}: expected generated output (a manifest.json), found none; generate first")
    lines: list[str] = []
    ok = True
    for path in found:
        for passed, text in _check_one(path):
            ok = ok and passed
            lines.append(f"{path.name}: {'ok' if passed else 'FAILED'}: {text}")
    return CheckResult(ok, tuple(lines))


def _check_one(directory: Path) -> Iterator[tuple[bool, str]]:
    """(passed, what) of every check of one directory."""
    content = read_manifest(directory)
    model = _regenerate(directory, content)
    targets = [t for t in TARGETS if t in content.get("targets", TARGETS)]
    single = content.get("precision") == "single"
    files = render(model, targets, precision="single" if single else "double")
    yield from _compare_operations(directory, model)
    yield from _compare_files(directory, files, model)
    expected = {name: model(name, *model.test_inputs[name]) for name in model.programs}
    yield from _compare_recorded(directory, model, expected)
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        fresh = Path(temporary) / "fresh"
        fresh.mkdir()
        for name, data in files.items():
            (fresh / name).write_bytes(data)
        if "c" in targets:
            yield from _compile(fresh, model.name)
            if find_compiler():
                yield (
                    _compare_single(fresh, model)
                    if single
                    else _compare_values("C", model, expected, _c_results(fresh))
                )
            if find_compiler() and "external" in targets:
                yield from _external(fresh, model, expected)
        if "casadi" in targets:
            yield _compare_values("CasADi", model, expected, _casadi_results(directory, fresh, model))
        if "numpy" in targets:
            module = _import(fresh / f"{model.name}_numpy.py")
            yield _compare_values("NumPy module", model, expected, lambda name, x: getattr(module, name)(*x))


def _regenerate(directory: Path, content: Mapping[str, Any]) -> Model:
    """The model of a directory, with the recorded states as test inputs where they fit."""
    mechanism = description.load(directory / "mechanism.toml")
    effects = tuple(effect_from_json(entry) for entry in content["effects"])
    functions = content.get("functions", {})
    derivatives, regressor = "linearisation" in functions, "regressor" in functions
    model = derive(mechanism, effects, derivatives=derivatives, regressor=regressor)
    chosen = content.get("independent") or None
    if chosen and model_hash(model) != content.get("hash"):
        other = derive(mechanism, effects, independent=chosen, derivatives=derivatives, regressor=regressor)
        model = other if model_hash(other) == content.get("hash") else model
    recorded = read_json(directory / "test_vectors.json")
    inputs = dict(model.test_inputs)
    for name, program in model.programs.items():
        entry = recorded.get(name, {}) if isinstance(recorded, dict) else {}
        arrays = _arrays(entry.get("inputs"), [(p.name, p.size) for p in program.inputs])
        inputs[name] = arrays if arrays is not None else inputs[name]
    return dataclasses.replace(model, test_inputs=inputs)


def _arrays(entry: Any, ports: Sequence[tuple[str, int]]) -> tuple[np.ndarray, ...] | None:
    """Arrays (states, size) of a recorded entry, or None if it does not fit the ports."""
    try:
        arrays = tuple(np.array(entry[name], dtype=float).reshape(-1, max(n, 1))[:, :n] for name, n in ports if n)
        return tuple(_with_empty(arrays, ports))
    except (KeyError, TypeError, ValueError, IndexError):
        return None


def _with_empty(arrays: Sequence[np.ndarray], ports: Sequence[tuple[str, int]]) -> Iterator[np.ndarray]:
    """`arrays` in the order of the ports, with arrays (states, 0) for ports without entries."""
    states = len(arrays[0]) if arrays else 1
    remaining = iter(arrays)
    for _, n in ports:
        yield next(remaining) if n else np.zeros((states, 0))


def _compare_operations(directory: Path, model: Model) -> Iterator[tuple[bool, str]]:
    recorded = read_json(directory / "ops.json")
    changed = []
    for name, program in model.programs.items():
        now, then = program.operations, recorded.get(name) if isinstance(recorded, dict) else None
        if now != then:
            before = then.get("total") if isinstance(then, dict) else None
            word = "rose" if isinstance(before, int) and now["total"] > before else "changed"
            changed.append(f"operations of {name} {word} from {before} to {now['total']}")
    total = sum(p.operations["total"] for p in model.programs.values())
    yield (False, "; ".join(changed)) if changed else (True, f"{total} operations as in ops.json")


def _compare_files(directory: Path, files: Mapping[str, bytes], model: Model) -> Iterator[tuple[bool, str]]:
    """Bytes of every file; recorded values and CasADi files are compared by value elsewhere."""
    same = 0
    for name, data in sorted(files.items()):
        path = directory / name
        by_value = name == "test_vectors.json" or name.endswith(".casadi")
        if not path.is_file():
            if not name.endswith(".casadi"):
                yield False, f"{name} is missing; generate again"
        elif path.read_bytes() == data:
            same += 1
        elif not by_value:
            yield (
                False,
                f"{name} differs from what is generated today{_first_difference(path.read_bytes(), data)}",
            )
    yield same > 0, f"{same} of {len(files)} files have the same bytes"


def _first_difference(found: bytes, expected: bytes) -> str:
    there = found.decode("utf-8", "replace").split("\n")
    here = expected.decode("utf-8", "replace").split("\n")
    for number, (a, b) in enumerate(zip(there, here, strict=False), 1):
        if a != b:
            return f", line {number}: found {a.strip()[:70]!r}, expected {b.strip()[:70]!r}"
    return f": found {len(there)} lines, expected {len(here)}"


def _compare_recorded(directory: Path, model: Model, expected: Mapping[str, Results]) -> Iterator[tuple[bool, str]]:
    """The outputs in test_vectors.json against today's."""
    recorded = read_json(directory / "test_vectors.json")

    def results(name: str, inputs: Sequence[np.ndarray]) -> Results:
        entry = recorded[name]
        ports = [(p.name, p.size) for p in model.programs[name].outputs]
        arrays = _arrays(entry["outputs"], ports)
        if arrays is None:
            raise ValueError(f"the outputs of {name} do not fit its ports")
        return arrays, np.array(entry["status"])

    try:
        yield _compare_values("test_vectors.json", model, expected, results)
    except (KeyError, TypeError, ValueError) as error:
        yield False, f"test_vectors.json does not fit the functions ({error}); generate again"


def _compare_values(
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


def _compare_single(directory: Path, model: Model) -> tuple[bool, str]:
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


def _compile(directory: Path, name: str) -> Iterator[tuple[bool, str]]:
    """Library and example with all warnings as errors, and the header as C++."""
    compilers = [path for path in map(shutil.which, ("gcc", "clang")) if path]
    if not compilers:
        compilers = [path for path in [shutil.which("cc")] if path]
    if not compilers:
        yield True, "no C compiler here: C neither compiled nor run"
    for compiler in compilers:
        sources = [f"{name}.c", "example.c", *(p.name for p in directory.glob("*_external.c"))]
        sources += [p.name for p in directory.glob("*_jacobians.c")]
        yield _run([compiler, *STRICT, "-O1", "-c", *sources], directory, "compiles without warnings")
    plus = next((path for path in map(shutil.which, ("g++", "clang++")) if path), None)
    if plus:
        flags = ["-std=c++11", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c++"]
        yield _run([plus, *flags, f"{name}.h"], directory, "accepts the header as C++")
        flags[0] = "-std=c++17"
        yield _run([plus, *flags, "-Wconversion", f"{name}.hpp"], directory, "accepts the C++17 header")


def _run(command: Sequence[str], directory: Path, what: str) -> tuple[bool, str]:
    result = subprocess.run(command, cwd=directory, capture_output=True, text=True, check=False)
    compiler = Path(command[0]).name
    if result.returncode == 0:
        return True, f"{compiler} {what}"
    first = next((line for line in result.stderr.splitlines() if "error" in line), result.stderr[:200])
    return False, f"{compiler} refuses: {first.strip()}"


def _c_results(directory: Path) -> Callable[[str, Sequence[np.ndarray]], Results]:
    compiled = load(directory, backend="c", flags=("-ffp-contract=off",))

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

    yield _compare_values("CasADi external", model, expected, evaluate)
    derived, jacobians = jacobians_model(model)
    worst = 0.0
    for name, made in jacobians.items():
        function = load_external(library, f"jac_{model.name}_casadi_{name}")
        values, status = derived(made.program.name, *derived.test_inputs[made.program.name])
        for k in np.flatnonzero(np.asarray(status) == 0):
            given = [array[k] for array in model.test_inputs[name]]
            found = function.call([*given, *(array[k] for array in expected[name][0])])
            for port, value in zip(made.program.outputs, values, strict=True):
                output, place, *_ = made.blocks[port.name]
                block = found[output * len(made.source.inputs) + place]
                worst = max(worst, relative_difference(value[k], np.array(block.nonzeros())))
    yield worst <= TOLERANCE, f"{len(jacobians)} Jacobians of CasADi externals agree with the evaluator to {worst:.1e}"


def _external_row(
    function: Any, inputs: Sequence[Port], outputs: Sequence[Port], state: Sequence[np.ndarray]
) -> tuple[np.ndarray, ...] | None:
    """The outputs (size) of an external function at one state, None where it fails."""
    shaped = [x.reshape(p.shape, order="F") if len(p.shape) == 2 else x for p, x in zip(inputs, state, strict=True)]
    try:
        found = function.call(shaped)
    except RuntimeError:
        return None
    return tuple(np.array(x).T.reshape(port.size) for port, x in zip(outputs, found, strict=True))


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
