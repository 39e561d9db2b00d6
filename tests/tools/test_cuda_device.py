"""On a CUDA device, where CuPy finds one: kernels, steps of scenes and sweeps give what the processor gives."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.many_states import scene_of, starts
from support.model_states import model, pendulum
from support.runs import EXAMPLES

from symscrew import catalogue
from symscrew.display import Progress
from symscrew.program import Iteration, RankRevealing
from symscrew.runtime import CompileError, load_cuda
from symscrew.scene.contents import Integrator
from symscrew.scene.scene_file import load_scene
from symscrew.simulation.cuda_steps import load_steps
from symscrew.studies.accuracy import digits_study
from symscrew.studies.accuracy.states import Subject
from symscrew.studies.workspace import workspace

pytestmark = pytest.mark.tools
MECHANISMS = ("four_bar", "three_ups_upu_s", "delta", "stewart_6ups", "ur5", "panda")
FUNCTIONS = (
    "velocity", "inverse_dynamics", "forward_dynamics", "joint_reactions", "joint_displacements", "assemble",
)  # fmt: skip
EXACT = {"double": 1e-12, "single": 2e-5}  # of the largest entry; a function loses up to a digit of float's 7.2


@pytest.fixture(scope="module", autouse=True)
def _device() -> None:
    try:
        load_cuda(pendulum())
    except CompileError as error:
        pytest.skip(f"needs a CUDA device and CuPy: {error}")


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("name", MECHANISMS)
def test_kernels_are_the_evaluator(name: str, precision: str) -> None:
    """Every function of a model at its test states, and over many blocks; failed states are NaN with a status."""
    derived = model(name).only(FUNCTIONS)
    kernels = load_cuda(derived, precision=precision)
    for function, program in derived.programs.items():
        inputs = [np.asarray(x) for x in derived.test_inputs[function]]
        count = 300 * len(inputs[0])  # several blocks, the last one not full
        given = [np.resize(x, (count, x.shape[-1])).T for x in inputs]
        *found, status = getattr(kernels, function)(*map(kernels.library.asarray, given))
        expected, codes = derived(function, *inputs)
        codes = np.resize(np.broadcast_to(np.asarray(codes), len(inputs[0])), count)
        codes_here = status.get()
        sound = codes_here == 0
        second = isinstance(program, RankRevealing) | isinstance(program, Iteration)
        assert sound.any() and (second or (sound == (codes <= 0)).all()), f"{name}.{function}"
        for one, other in zip(found, expected, strict=True):
            other = np.resize(np.asarray(other).reshape(len(inputs[0]), -1), (count, one.shape[0])).T
            size = np.abs(other[:, sound]).max(initial=0.0) or 1.0
            np.testing.assert_allclose(
                one.get()[:, sound], other[:, sound], rtol=0, atol=EXACT[precision] * size, err_msg=f"{name}.{function}"
            )
            assert np.isnan(one.get()[:, ~sound]).all()
    function = "inverse_dynamics"
    given = [np.resize(x, (3, x.shape[-1])).T.copy() for x in derived.test_inputs[function]]
    given[0][0, 1] = np.nan
    *found, status = getattr(kernels, function)(*map(kernels.library.asarray, given))
    assert status.get()[1] == 2 and (status.get()[[0, 2]] == 0).all()
    assert np.isnan(found[0].get()[:, 1]).all() and np.isfinite(found[0].get()[:, [0, 2]]).all()


@pytest.mark.parametrize(
    ("mechanism", "method"), [("four_bar", "rk4"), ("three_ups_upu_s_physical", "rk4"), ("ur5", "rk8")]
)
def test_steps_of_a_scene_are_those_of_the_processor(mechanism: str, method: str) -> None:
    """A thousand states from different rates: states, statuses and steps taken, to 1e-12 of the largest entry."""
    scene = scene_of(mechanism, "", method)
    there, here = load_steps(scene), load_steps(scene, as_cpp=True)
    q, v = (np.ascontiguousarray(x[:, np.arange(1000) % 8]) for x in starts(scene, here.plant, _rates(8)))
    u = np.random.default_rng(5).normal(0, 1, (here.plant.sizes["u"], 1000))
    make = there.library
    found = there.advance(make.asarray(q), make.asarray(v), u=make.asarray(u), h=1e-3, steps=40)
    for one, other in zip(found, here.advance(q, v, u=u, h=1e-3, steps=40), strict=True):
        np.testing.assert_allclose(one.get(), other, rtol=0, atol=1e-12 * max(1.0, np.abs(other).max(initial=0.0)))
    assert (found[3].get() == 0).all() and np.abs(found[0].get() - q).max() > 1e-6


def test_states_near_a_singular_configuration_stop_on_the_device() -> None:
    scene = load_scene(EXAMPLES / "benchmarks" / "n_four_bar.toml")
    scene = replace(scene, integrator=Integrator("rk4", step=1e-3))
    there = load_steps(scene)
    many = [there.library.asarray(np.repeat(x, 200, axis=1)) for x in starts(scene, there.plant, _rates(1))]
    *_, status, taken = there.advance(*many, h=1e-3, steps=2000)
    assert (status.get() == 3).all() and len(set(taken.get().tolist())) == 1 and 0 < taken.get()[0] < 2000


@pytest.mark.parametrize(
    ("name", "over"),
    [
        ("four_bar", {"A": "-30deg:200deg:2400"}),
        ("three_ups_upu_s", {"tilt": "0:20deg:5", "azimuth": "0:360deg:24"}),
    ],
)
def test_sweeps_have_the_same_numbers_and_choose_the_device(name: str, over: dict[str, str]) -> None:
    mechanism = catalogue.load(name)
    one, other = workspace(mechanism, over, engine="c"), workspace(mechanism, over)
    assert other.summary["engine"].startswith("CUDA") and one.plan.hash == other.plan.hash
    for result, numbers in one.results.items():
        size = np.abs(numbers[np.isfinite(numbers)]).max(initial=1.0)
        np.testing.assert_allclose(other.results[result], numbers, rtol=0, atol=1e-11 * size, err_msg=result)


def test_the_study_of_digits_has_the_device() -> None:
    found = digits_study.study(Subject(model("four_bar")), Progress(quiet=True), repeats=1, seconds=0.01)
    assert not [text for text in found.left_out if text.startswith("CUDA,")]
    (head, rows), *_ = found.tables.values()
    for kind, digits in (("float64", 13.0), ("float32", 4.5)):
        column = head.index(f"CUDA, {kind}")
        assert min(float(row[column]) for row in rows if row[column] != "all") > digits


def test_the_engine_by_jax_runs_on_the_device() -> None:
    pytest.importorskip("jax", reason="needs JAX (pip install 'symscrew[jax]')")
    from symscrew.runtime import load_jax

    derived = model("four_bar").only(["inverse_dynamics"])
    inputs = derived.test_inputs["inverse_dynamics"]
    (found,), status = load_jax(derived)[0]("inverse_dynamics", *inputs)
    (expected,), _ = derived("inverse_dynamics", *inputs)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * np.abs(expected).max())
    assert not status.any()


def _rates(count: int) -> np.ndarray:
    return np.random.default_rng(3).uniform(-0.3, 0.3, count)
