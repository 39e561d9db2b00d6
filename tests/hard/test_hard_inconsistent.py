"""Inconsistent input: refused with what is wrong, or put right and reported; never a number after a failure.

What every guard prevents stands in the test's docstring, as seen when it was taken out.
"""

from __future__ import annotations

import dataclasses
import tempfile
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from support.model_states import model
from support.runs import EXAMPLES, prepared

from hard import case
from hard.mechanisms import benchmark_text, catalogue_text, changed
from symscrew.description import validation
from symscrew.description.builder import MechanismBuilder
from symscrew.errors import DescriptionError
from symscrew.model import Model, derive
from symscrew.program.numpy_evaluation import evaluate
from symscrew.program.straight_line import Iteration, Program
from symscrew.runtime.compiled import find_compiler, load
from symscrew.scene.contents import Initial, Scene
from symscrew.scene.scene_file import load_scene
from symscrew.simulation.initial import initial_state
from symscrew.simulation.motion import simulate

Y = [0, 1, 0]


@pytest.fixture(scope="module")
def crank() -> Callable[..., dict[str, tuple[float, float]]]:
    """Where the spatial slider-crank begins with given coordinates and rates: label to (value, rate)."""
    scene = load_scene(EXAMPLES / "benchmarks" / "spatial_slider_crank.toml")
    found, plant = prepared("spatial_slider_crank")
    labels = [c.label for c in found.system.tree.q]

    def begin(coordinates: dict, rates: dict, hold: tuple[str, ...] | None = None) -> dict[str, tuple[float, float]]:
        given = dataclasses.replace(scene, initial=Initial(coordinates, rates, hold))
        q, v = initial_state(given, found, plant.parameters)
        return {label: (float(x), float(y)) for label, x, y in zip(labels, q, v, strict=True)}

    return begin


# -- starts ---------------------------------------------------------------------------------------------------


def test_position_off_the_manifold(crank: Callable) -> None:
    """1 mm off: refused with the residual (1 mm by the length 0.141647 m); with the crank alone given or held, put
    right, and the run says by how much.
    """
    assert "raise with the residual" in case(20)["pass_criterion"]
    with pytest.raises(
        DescriptionError, match=r"cannot be closed with slide = 0.201, A = 0: they stay open by 0.00706"
    ):
        crank({"slide": 0.201, "A": 0.0}, {})
    assert pytest.approx(0.00706, abs=5e-6) == 0.001 / 0.141647
    assert crank({"A": 0.0}, {})["slide"][0] == pytest.approx(0.2, abs=1e-12)
    held = crank({"slide": 0.201, "A": 0.0}, {}, hold=("A",))
    assert held["slide"][0] == pytest.approx(0.2, abs=1e-12) and held["A"][0] == 0.0
    assert "move reported" in case(20)["pass_criterion"]
    scene = load_scene(EXAMPLES / "benchmarks" / "spatial_slider_crank.toml")
    begin = Initial({"slide": 0.201, "A": 0.0}, {"A": 6.0, "slide": 0.0}, hold=("A",))
    scene = dataclasses.replace(scene, initial=begin, duration=1e-3)
    run = simulate(scene, prepared=prepared("spatial_slider_crank"))
    assert run.events == (
        "t = 0 s: slide put from 0.201 to 0.2 to close the loops",
        "t = 0 s: slide (rate) put from 0 to 0.24 to close the loops",
    )


def test_velocity_off_the_manifold(crank: Callable) -> None:
    """6 rad/s and all others 0: refused; with the crank alone given the slider gets its exact 0.24 m/s.

    Without the check on the least-squares residual the rates would be a compromise of all that is given: 5.42 rad/s.
    """
    assert "0.24" in case(21)["pass_criterion"]
    with pytest.raises(DescriptionError, match=r"the loops do not allow A = 6, C.0 = 0, C.1 = 0, slide = 0"):
        crank({}, {"A": 6.0, "C.0": 0.0, "C.1": 0.0, "slide": 0.0})
    begun = crank({}, {"A": 6.0})
    assert begun["A"][1] == pytest.approx(6.0, abs=1e-12) and begun["slide"][1] == pytest.approx(0.24, abs=1e-12)
    held = crank({}, {"A": 6.0, "C.0": 0.0, "C.1": 0.0, "slide": 0.0}, hold=("A",))
    assert held["A"][1] == pytest.approx(6.0, abs=1e-12) and held["slide"][1] == pytest.approx(0.24, abs=1e-12)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_starts_that_are_not_finite(crank: Callable, value: float) -> None:
    """Without the check LAPACK's "SVD did not converge" came out of it."""
    with pytest.raises(DescriptionError, match=r"initial.coordinates: expected a finite number for A"):
        crank({"A": value}, {})
    with pytest.raises(DescriptionError, match=r"initial.rates: expected a finite number for A"):
        crank({}, {"A": value})


@pytest.mark.parametrize("name", ["four_bar", "five_bar", "three_ups_upu_s"])
def test_more_values_than_freedoms_are_taken_where_they_fit(name: str) -> None:
    """A whole state, and one but for its last coordinate, as another run left it: on a way there they do not fit, and
    were refused with loops that stay open by 4e-16. With one of them off by 1e-6 they fit nowhere."""
    found = model(name)
    q, v, _ = found.system.states(2, 4)
    labels = [[c.label for c in part] for part in (found.system.tree.q, found.system.tree.v)]
    places, rates = (dict(zip(names, x[1].tolist(), strict=True)) for names, x in zip(labels, (q, v), strict=True))
    most = dict(places)
    if name != "three_ups_upu_s":  # whose last is one of a quaternion
        del most[labels[0][-1]]
    for given in (places, most):
        scene = Scene(name, found.mechanism, (), 0.1, 10.0, Initial(coordinates=given, rates=rates))
        start = initial_state(scene, found, found.system.parameter_values)
        assert np.abs(start[0] - q[1]).max() < 1e-14 and np.abs(start[1] - v[1]).max() < 1e-14
    places[labels[0][0]] += 1e-6
    scene = dataclasses.replace(scene, initial=Initial(coordinates=places))
    with pytest.raises(DescriptionError, match="cannot be closed with"):
        initial_state(scene, found, found.system.parameter_values)


def test_loops_that_cannot_close(crank: Callable) -> None:
    """A slider at 5 m of a rod of 0.3 m: refused; the function `assemble` says status 3 and gives NaN."""
    with pytest.raises(DescriptionError, match=r"cannot be closed with slide = 5: they stay open by 33.9"):
        crank({"slide": 5.0}, {})
    rocker = derive(changed(catalogue_text("four_bar")), independent=["D"])
    (q,), status = rocker("assemble", [2.5], rocker.system.reference)
    assert status in (1, 3) and np.isnan(q).all()


# -- NaN and infinity -------------------------------------------------------------------------------------------


def spoilt(found: Model, function: str, value: float) -> tuple[list[np.ndarray], list[str]]:
    """A good state once per entry of the inputs, that entry set to `value`; and the entries' labels."""
    program = found.programs[function]
    base = [np.asarray(x[1], dtype=float) for x in found.test_inputs[function]]
    labels = [f"{port.name}.{k}" for port, x in zip(program.inputs, base, strict=True) for k in range(x.size)]
    arrays = [np.repeat(x[None], len(labels), 0) for x in base]
    row = 0
    for array in arrays:
        for k in range(array.shape[1]):
            array[row, k] = value
            row += 1
    return arrays, labels


@cache
def answers(name: str, backend: str) -> Callable:
    """(function, arrays) -> results, status by the evaluator, by generated C or by CasADi."""
    found = model(name)
    if backend == "numpy":
        return found
    with tempfile.TemporaryDirectory() as folder:  # all functions in one library: all of them are called
        compiled = load(found, backend=backend, flags=("-O1",), vectorised=False, build_dir=folder)

    def call(function: str, *arrays: np.ndarray) -> tuple[list[np.ndarray], np.ndarray]:
        *results, status = compiled[function](*arrays, check=False)  # type: ignore[misc]
        return [np.reshape(r if r.ndim < 3 else r.swapaxes(1, 2), (len(status), -1)) for r in results], status

    return call


BACKENDS = [
    ("four_bar", "numpy"),
    ("three_ups_upu_s", "numpy"),
    ("four_bar", "casadi"),
    pytest.param("four_bar", "c", marks=pytest.mark.skipif(find_compiler() is None, reason="no C compiler")),
]


def checking(program: Program, slots: tuple[int, ...]) -> Program:
    """The program with other slots in the sum that must be finite."""
    other = dataclasses.replace(program)
    other.__dict__["checked"] = slots  # a cached property
    return other


@pytest.mark.slow
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("name, backend", BACKENDS)
def test_bad_entries_never_give_success(name: str, backend: str, value: float) -> None:
    """Each entry of each input of each function in turn: a status above 0 and all outputs NaN, also where a function
    does not need the entry.

    Without the test of the sum of all that is checked (status 2) NaN comes out with status 0; without the inputs in
    that sum an entry that nothing depends on, or an infinite one of which only 1/x is used, goes unnoticed.
    """
    assert "never returns success" in case(22)["pass_criterion"]
    found = model(name)
    call, silent, unnoticed = answers(name, backend), 0, 0
    with np.errstate(all="ignore"):
        for function, program in found.programs.items():
            arrays, labels = spoilt(found, function, value)
            results, status = call(function, *arrays)
            for k, label in enumerate(labels):
                assert status[k] > 0, (function, label)
                assert all(np.isnan(r[k]).all() for r in results), (function, label)
            if backend == "numpy" and not isinstance(program, Iteration):
                values = evaluate(checking(dataclasses.replace(program, guards=()), ()), arrays)[0]
                silent += sum(bool(np.isnan(r).any()) for r in values)
                size = sum(port.size for port in program.inputs)
                without = checking(program, tuple(slot for slot in program.checked if slot >= size))
                unnoticed += int((evaluate(without, arrays)[1] == 0).sum())
    assert backend != "numpy" or (silent > 0 and unnoticed > 0)  # what the guards are for


# -- bodies -------------------------------------------------------------------------------------------------------


def with_inertia(inertia: object, mass: object = 1, com: object = (0, 0, 0)) -> MechanismBuilder:
    builder = MechanismBuilder("body")
    builder.body("body", mass=mass, com=list(com), inertia=inertia)  # type: ignore[call-overload]
    return builder.joint("A", "R", parent="base", child="body", point=[0, 0, 0], axes=[Y])


def test_inertia_at_the_limit_of_the_triangle_inequality() -> None:
    assert with_inertia([1, 1, 2]).build().bodies["body"].mass == 1


@pytest.mark.parametrize(
    "keys, message",
    [
        ({"inertia": [1, 1, "2.0001"]}, r"no body has the principal moments 1.*1.*2\.0001"),
        ({"inertia": [1, 1, -1]}, "expected principal moments of at least 0"),
        ({"inertia": [1, 1, 1], "mass": -1}, "mass"),
        ({"inertia": [[1, "0.1", 0], [0, 1, 0], [0, 0, 1]]}, "symmetric"),
        ({"inertia": [1, 1, "nan"]}, "inertia"),
        ({"inertia": [1, 1, float("inf")]}, "inertia"),
    ],
)
def test_bodies_that_do_not_exist(keys: dict, message: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Refused, with the principal moments where they are what is wrong.

    Without the check (`validation.INERTIA_TOLERANCE` wide, tried here) moments that no body has are accepted.
    """
    with pytest.raises(DescriptionError, match=message):
        with_inertia(**keys).build()
    if "moments" in message:
        monkeypatch.setattr(validation, "INERTIA_TOLERANCE", 10)
        assert with_inertia(**keys).build().bodies["body"].mass == 1


def test_centre_of_mass_of_a_massless_body() -> None:
    with pytest.raises(DescriptionError, match="mass"):
        with_inertia([1, 1, 1], mass=0, com=(1, 0, 0)).build()


def test_zero_length_limb() -> None:
    """Both ends of a leg at one point: its direction does not exist."""
    builder = MechanismBuilder("flat", platform="top")
    builder.body("top", mass=1, com=[0, 0, 1], inertia=[1, 1, 1])
    with pytest.raises(DescriptionError, match=r"limbs\.leg.*(point|length|apart|differ)"):
        builder.limb("leg", "UPS", base="base", tip="top", points=[[0, 0, 1], [0, 0, 1]]).build()


# -- units --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "old, new",
    [
        ('inertia = ["axial", "across", "across"]', 'inertia = ["axial*1000000", "across*1000000", "across*1000000"]'),
        ('inertia = ["axial", "across", "across"]', 'inertia = ["axial*1000", "across*1000", "across*1000"]'),
        ("mass = 1\ncom = [1, -1, \"1/2\"]", "mass = \"1/1000\"\ncom = [1, -1, \"1/2\"]"),
        ("mass = 1\ncom = [1, -1, \"1/2\"]", "mass = \"1/1000000\"\ncom = [1, -1, \"1/2\"]"),
        ("mass = 1\ncom = [1, -1, \"1/2\"]", "mass = 1\ncom = [1000, -1000, 500]"),
    ],
)  # fmt: skip
def test_units_wrong_by_a_thousand(old: str, new: str) -> None:
    """kg mm^2 or g m^2 for kg m^2, masses in t or kt for kg, mm for m in one body: a warning names the body; the right
    description has none.
    """
    assert not changed(benchmark_text("bricard")).warnings
    warnings = changed(benchmark_text("bricard"), (old, new)).warnings
    assert any(warning.startswith("bodies.rod") for warning in warnings), warnings
