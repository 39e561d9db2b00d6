"""Does a unit do what the model says? Its C is compiled, its accelerations and one of its steps are compared.

accelerations: der(v) of the unit against forward_dynamics of the evaluator, at the test states
a step:        DoStep of the unit from its start against one RK4 step of `simulate`
"""

from __future__ import annotations

import ctypes
import re
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.fmu.unit_archive import FLAGS, at_rest
from symscrew.fmu.unit_variables import DEFAULT_STEP
from symscrew.model import Model
from symscrew.runtime import CompileError, compile_c
from symscrew.simulation import simulate

ACCELERATIONS = 1e-10  # relative: the unit closes the loops of a state that it is given, which moves it by as much
STEP = 1e-12  # [rad, m, rad/s, m/s]: equal operations in another order; a step of Euler's method is off by 1e-7
UNUSED = tuple(f"-Wno-unused-{part}" for part in ("function", "parameter", "const-variable"))
Double, Reference = ctypes.c_double, ctypes.c_uint32


def compare_unit(files: Mapping[str, bytes], model: Model) -> Iterator[tuple[bool, str]]:
    """(passed, what): the sources of FMI 3.0 compile; accelerations and one step are those of model and simulation."""
    (source,) = [name for name in files if name.endswith(".c")]
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        code, library = Path(temporary) / "unit.c", Path(temporary) / "unit.so"
        code.write_bytes(files[source])
        try:
            compile_c(code, library, flags=(*FLAGS, "-Wall", "-Wextra", *UNUSED, "-Werror"), native=False)
        except CompileError as error:
            yield False, f"FMU: {error}"
            return
        unit = _Unit(ctypes.CDLL(str(library)), files["modelDescription.xml"].decode())
        worst = max(_accelerations(unit, model, k) for k in range(len(model.test_inputs["forward_dynamics"][0])))
        yield worst <= ACCELERATIONS, f"FMU: accelerations agree with the evaluator to {worst:.1e}"
        worst = _step(unit, model)
        yield worst <= STEP, f"FMU: a step of {DEFAULT_STEP} s agrees with our simulation to {worst:.1e}"


class _Unit:
    """The functions of FMI 3.0 of a compiled unit that a check needs."""

    def __init__(self, library: ctypes.CDLL, description: str) -> None:
        self.library = library
        self.token = re.search(r'instantiationToken="(\w+)"', description)[1].encode()  # type: ignore[index]
        names = re.findall(r'<Float64 name="([^"]+)" valueReference="(\d+)"', description)
        self.references = {name: int(number) for name, number in names}
        library.fmi3InstantiateCoSimulation.restype = ctypes.c_void_p

    def __repr__(self) -> str:
        return f"_Unit({len(self.references)} variables)"

    def initialised(self, values: Mapping[str, float]) -> ctypes.c_void_p:
        """An instance whose variables start at these values."""
        yes, no, none = ctypes.c_bool(True), ctypes.c_bool(False), None
        made = self.library.fmi3InstantiateCoSimulation(
            b"check", self.token, b"", no, no, no, no, none, ctypes.c_size_t(0), none, none, none
        )
        instance = ctypes.c_void_p(made)
        self._call("EnterInitializationMode", instance, no, Double(0), Double(0), yes, Double(1))
        references = (Reference * len(values))(*[self.references[name] for name in values])
        count = ctypes.c_size_t(len(values))
        self._call("SetFloat64", instance, references, count, (Double * len(values))(*values.values()), count)
        self._call("ExitInitializationMode", instance)
        return instance

    def values(self, instance: ctypes.c_void_p, group: str) -> np.ndarray:
        """The variables whose names begin with `group`, in their order."""
        chosen = [number for name, number in self.references.items() if name.startswith(group)]
        found, count = (Double * len(chosen))(), ctypes.c_size_t(len(chosen))
        self._call("GetFloat64", instance, (Reference * len(chosen))(*chosen), count, found, count)
        return np.array(found)

    def step(self, instance: ctypes.c_void_p, length: float) -> None:
        """A communication step from time 0."""
        flags = [ctypes.byref(ctypes.c_bool()) for _ in range(3)]
        last = Double()
        self._call("DoStep", instance, Double(0), Double(length), ctypes.c_bool(True), *flags, ctypes.byref(last))

    def free(self, instance: ctypes.c_void_p) -> None:
        """Give the memory back."""
        self.library.fmi3FreeInstance(instance)

    def _call(self, name: str, *arguments: Any) -> None:
        code = getattr(self.library, f"fmi3{name}")(*arguments)
        if code > 1:
            raise CompileError(f"FMU: fmi3{name} ended with status {code}")

    def named(self, group: str, values: np.ndarray) -> dict[str, float]:
        """Values of a group by the names of its variables."""
        names = [name for name in self.references if name.startswith(f"{group}.")]
        return dict(zip(names, values.tolist(), strict=True))


def _accelerations(unit: _Unit, model: Model, k: int) -> float:
    """Largest difference of the accelerations at a test state, over the largest of them."""
    ports = [port.name for port in model.programs["forward_dynamics"].inputs]
    given = dict(zip(ports, (array[k] for array in model.test_inputs["forward_dynamics"]), strict=True))
    (expected, *_), status = model("forward_dynamics", *given.values())
    if status != 0:
        return 0.0
    values: dict[str, float] = {}
    for name, array in given.items():
        group = {f"{name}.{label}": float(x) for label, x in zip(_labels(model, name), array, strict=True)}
        values |= unit.named(name, array) if name in ("q", "v", "u", "x", "p") else group
    instance = unit.initialised(values)
    found = unit.values(instance, "der(v.")
    unit.free(instance)
    return float(np.abs(found - expected).max(initial=0.0) / max(np.abs(expected).max(initial=0.0), 1e-3))


def _labels(model: Model, port: str) -> tuple[str, ...]:
    return next(p.labels for p in model.programs["forward_dynamics"].inputs if p.name == port)


def _step(unit: _Unit, model: Model) -> float:
    """Largest difference of q and v after one step from the start."""
    scene = at_rest(model.mechanism, model.effects)
    integrator = replace(scene.integrator, method="rk4", step=DEFAULT_STEP)
    expected = simulate(replace(scene, duration=DEFAULT_STEP, rate=1 / DEFAULT_STEP, integrator=integrator))
    instance = unit.initialised({})
    unit.step(instance, DEFAULT_STEP)
    moved = [unit.values(instance, group) for group in ("q.", "v.")]
    unit.free(instance)
    return float(max(np.abs(a - b[-1]).max(initial=0.0) for a, b in zip(moved, (expected.q, expected.v), strict=True)))
