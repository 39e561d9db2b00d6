"""Steps of many states as CUDA: the file as C++ against the loop in C, state by state; NVIDIA's compiler."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.many_states import SCENE, scene_of, starts
from support.marks import slow
from support.runs import EXAMPLES

from symscrew.cli.parser import main
from symscrew.errors import DescriptionError
from symscrew.runtime import CompileError, compile_cuda, find_nvrtc
from symscrew.scene.contents import Integrator, Scene
from symscrew.scene.scene_file import load_scene, parse_scene
from symscrew.simulation.cuda_steps import load_steps, print_steps
from symscrew.simulation.initial import initial_state
from symscrew.simulation.real_time_loop import loop_plant, print_loop

pytestmark = pytest.mark.slow

COMPILED = pytest.mark.skipif(shutil.which("g++") is None, reason="needs g++")
H, STEPS = 1e-3, 12
DRIVEN = """
[tables.load]
times = [0, 0.004, 0.02]
values = [1, 2, 0]
[drives]
A = "load - 0.1*v_A"
"""


def built(scene: Scene, folder: Path) -> tuple[ctypes.CDLL, ctypes.CDLL]:
    """The steps as C++ and the loop as C, without fused operations: these are the compiler's choice."""
    for name, text in {**print_steps(scene), **print_loop(scene)}.items():
        (folder / name).write_text(text)
    flags = ["-O0", "-ffp-contract=off", "-shared", "-fPIC"]
    warned = ["-std=c++11", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function"]
    for command in (
        ["g++", *warned, *flags, "-x", "c++", f"{scene.name}_steps.cu", "-o", "steps.so"],
        ["gcc", "-std=c99", *flags, f"{scene.name}_loop.c", "-o", "loop.so", "-lm"],
    ):
        subprocess.run(command, cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "steps.so")), ctypes.CDLL(str(folder / "loop.so"))


@pytest.fixture(scope="module")
def four_bar(tmp_path_factory: pytest.TempPathFactory) -> tuple[Scene, tuple[ctypes.CDLL, ctypes.CDLL]]:
    """With drives of the scene, built once."""
    scene = scene_of("four_bar", DRIVEN, "rk4")
    return scene, built(scene, tmp_path_factory.mktemp("steps"))


def place(array: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def stepped(library: ctypes.CDLL, scene: Scene, arrays: tuple[np.ndarray, ...], steps: int) -> tuple[np.ndarray, ...]:
    """Status and steps taken; the arrays (size, states) q, v, x are written."""
    count = arrays[0].shape[1]
    status, taken = np.full(count, -1, np.intc), np.full(count, -1, np.intc)
    sizes = [ctypes.c_size_t(count), ctypes.c_size_t(count), ctypes.c_double(0.0), ctypes.c_double(H)]
    call = getattr(library, f"{scene.name}_steps")
    assert call(*sizes, steps, *map(place, (*arrays, status, taken)), None) == 0
    return status, taken


@COMPILED
@pytest.mark.parametrize(
    ("mechanism", "drives", "method"),
    [
        ("four_bar", DRIVEN, ""),
        slow("four_bar", "", "semi_implicit_euler"),
        slow("three_ups_upu_s", "", "rk4"),
        slow("ur5", "", "rk8"),
    ],
    ids=["four_bar-driven", "four_bar-semi_implicit_euler", "seed-rk4", "ur5-rk8"],
)
def test_many_states_take_the_steps_of_the_loop(
    mechanism: str, drives: str, method: str, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    """From states on the loops, with drives of the scene or held ones; to 1e-12 of the largest entry."""
    if method:
        scene = scene_of(mechanism, drives, method)
        steps, loop = built(scene, tmp_path)
    else:
        scene, (steps, loop) = request.getfixturevalue("four_bar")
    made, count, random = loop_plant(scene), 3, np.random.default_rng(5)
    arrays = starts(scene, made, random.uniform(-0.3, 0.3, count))
    x, u = np.zeros((max(made.sizes["x"], 1), count)), random.normal(0, 1, (max(made.sizes["u"], 1), count))
    assert bool(made.sizes["u"]) == (not drives and bool(made.system.drives))
    found = (arrays[0].copy(), arrays[1].copy(), x.copy(), u)
    status, taken = stepped(steps, scene, found, STEPS)
    assert status.tolist() == [0] * count and taken.tolist() == [STEPS] * count
    for i in range(count):
        own = [np.ascontiguousarray(a[:, i]) for a in (*arrays, x, u)]
        for k in range(STEPS):
            call = getattr(loop, f"{scene.name}_step")
            assert call(ctypes.c_double(H), ctypes.c_double(k * H), *map(place, own)) == 0
        for one, many in zip(own[:3], found, strict=False):
            np.testing.assert_allclose(many[:, i], one, rtol=0, atol=1e-12 * max(1.0, np.abs(one).max()))
    assert np.abs(found[0] - arrays[0]).max() > 1e-6  # they have moved


@COMPILED
def test_states_that_cannot_go_on_stay_and_say_so(four_bar: tuple[Scene, tuple[ctypes.CDLL, ctypes.CDLL]]) -> None:
    """Loops that are open, rates that are no numbers; beside a state that goes on."""
    scene, (library, _) = four_bar
    made = loop_plant(scene)
    q = np.repeat(made.system.reference[:, None], 3, 1)
    q[1:, 1] = [5.0, -3.0]  # nowhere near closed
    v = np.zeros((made.sizes["v"], 3))
    v[:, 2] = np.nan
    before = q.copy()
    status, taken = stepped(library, scene, (q, v, np.zeros((1, 3)), np.zeros((1, 3))), 4)
    assert status.tolist() == [0, 1, 1] and taken.tolist() == [4, 0, 0]
    np.testing.assert_array_equal(q[:, 1:], before[:, 1:])


@COMPILED
@pytest.mark.slow
def test_a_state_that_comes_near_a_singular_configuration_stops_before_it(tmp_path: Path) -> None:
    """Two four-bars in a row that unfold: where the loop in C goes on by charts."""
    scene = load_scene(EXAMPLES / "benchmarks" / "n_four_bar.toml")
    scene = replace(scene, integrator=Integrator("rk4", step=H))
    made = loop_plant(scene)
    state = initial_state(scene, made.model, made.parameters)
    arrays = (*(a[:, None].copy() for a in state), np.zeros((1, 1)), np.zeros((1, 1)))
    status, taken = stepped(built(scene, tmp_path)[0], scene, arrays, 2000)
    assert status.tolist() == [3] and 0 < taken[0] < 2000
    closure = made.model("closure", arrays[0][:, 0])[0][0]
    assert np.abs(closure).max() < 1e-12 and np.abs(arrays[0][:, 0] - state[0]).max() > 0.1


@COMPILED
@pytest.mark.slow
def test_the_loader_hands_over_arrays_in_order(
    four_bar: tuple[Scene, tuple[ctypes.CDLL, ctypes.CDLL]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """As C++ in place of a device: the same as by the call from C; what does not fit is refused."""
    scene, (library, _) = four_bar
    loaded = load_steps(scene, as_cpp=True)
    q = np.repeat(loaded.plant.system.reference[:, None], 2, 1)
    v, given = np.zeros((loaded.plant.sizes["v"], 2)), q.copy()
    found = loaded.advance(q, v, h=H, steps=3)
    np.testing.assert_array_equal(q, given)
    status, taken = stepped(library, scene, (q, v, np.zeros((1, 2)), np.zeros((1, 2))), 3)
    np.testing.assert_allclose(found[0], q, rtol=0, atol=1e-13)  # the compilers may fuse operations
    np.testing.assert_array_equal(found[3], status)
    np.testing.assert_array_equal(found[4], taken)
    assert found[2].shape == (0, 2)
    with pytest.raises(ValueError, match=r"expected v of \(\d, states\), got \(2, \d\)"):
        loaded.advance(q, v.T, h=H, steps=3)
    with pytest.raises(ValueError, match=r"expected u of \(0, states\), got \(1, 2\)"):
        loaded.advance(q, v, u=np.zeros((1, 2)), h=H, steps=3)
    monkeypatch.setitem(sys.modules, "cupy", None)
    with pytest.raises(CompileError, match="no CuPy here"):
        load_steps(scene)


def test_methods_without_a_fixed_step_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "turned.toml"
    scene.write_text(SCENE.format("four_bar", "", "rk4"))
    assert main(["simulate", str(scene), "--emit-cuda", str(tmp_path / "cuda")]) == 0
    written = sorted(path.name for path in (tmp_path / "cuda").iterdir())
    assert written == ["turned_steps.cu", "turned_steps.h"]
    assert "turned_steps(size_t count" in (tmp_path / "cuda" / "turned_steps.h").read_text()
    scene.write_text(SCENE.format("four_bar", "", "rk4").replace('method = "rk4"\nstep = 1e-3', 'method = "dop853"'))
    assert main(["simulate", str(scene), "--emit-cuda", str(tmp_path / "no")]) == 2
    assert "a loop for real time needs a fixed step" in capsys.readouterr().err and not (tmp_path / "no").exists()
    with pytest.raises(DescriptionError, match="needs a fixed step"):
        print_steps(replace(parse_scene(SCENE.format("four_bar", "", "rk4").split("[integrator]")[0])))


@pytest.mark.tools
def test_nvidias_compiler_takes_the_steps() -> None:
    """One kernel; what a thread keeps in local memory is what the header of the page on CUDA says in kB."""
    if find_nvrtc() is None:
        pytest.skip("needs NVRTC (pip install 'symscrew[nvrtc]')")
    code = compile_cuda(print_steps(scene_of("four_bar", DRIVEN, "rk4"))["turned_steps.cu"])
    (size,) = code.kernels.values()
    assert size.registers <= 255 and 0 < size.stack < 4096 and size.spill_stores == 0
