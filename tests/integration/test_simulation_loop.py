"""The generated loop for real time, compiled as its user would: alone, with all warnings, for a million steps."""

from __future__ import annotations

import ctypes
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.runs import scene_of

from symscrew import catalogue
from symscrew.description.builder import MechanismBuilder
from symscrew.effects import EndStop, Gravity
from symscrew.errors import DescriptionError
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Initial, Integrator, Scene
from symscrew.simulation.cuda_steps import print_steps
from symscrew.simulation.motion import evaluated, simulate
from symscrew.simulation.real_time_loop import loop_plant, print_loop, write_loop

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
STRICT = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wdouble-promotion", "-Wconversion", "-Werror")


def rk4(scene: Scene, step: float = 1e-3) -> Scene:
    return replace(scene, integrator=Integrator("rk4", step=step))


STEPS = """
#include "NAME_loop.h"
int steps(double dt, long first, long count, double *q, double *v, double *x, double *u);
int steps(double dt, long first, long count, double *q, double *v, double *x, double *u)
{
    long k;
    for (k = first; k < first + count; k++) {
        if (NAME_step(dt, (double)k * dt, q, v, x, u)) {
            return 1;
        }
    }
    return 0;
}
"""


def built(scene: Scene, folder: Path, flags: tuple[str, ...] = ()) -> ctypes.CDLL:
    write_loop(scene, folder)
    (folder / "steps.c").write_text(STEPS.replace("NAME", scene.name))
    library = folder / "loop.so"
    compiler = find_compiler()
    assert compiler
    command = [compiler, *STRICT, "-O2", "-fno-math-errno", "-shared", "-fPIC", *flags]
    result = subprocess.run(
        [*command, str(folder / f"{scene.name}_loop.c"), str(folder / "steps.c"), "-o", str(library), "-lm"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert result.returncode == 0, result.stderr[:2000]
    return ctypes.CDLL(str(library))


def stepped(library: ctypes.CDLL, scene: Scene, sizes: dict[str, int], start: tuple, steps: int, dt: float):  # type: ignore[no-untyped-def]
    q, v = (np.array(a) for a in start)
    x, u = np.zeros(max(sizes["x"], 1)), np.zeros(max(sizes["u"], 1))
    library.steps.argtypes = [ctypes.c_double, ctypes.c_long, ctypes.c_long] + [ctypes.c_void_p] * 4
    assert library.steps(dt, 0, steps, *(a.ctypes.data for a in (q, v, x, u))) == 0
    return q, v


@pytest.mark.slow
def test_the_loop_gives_the_motion_of_the_run(tmp_path: Path) -> None:
    scene = rk4(scene_of("n_four_bar", until=1.0))
    run = simulate(scene)
    library = built(scene, tmp_path)
    q, v = stepped(library, scene, loop_plant(scene).sizes, (run.q[0], run.v[0]), 1000, 1e-3)
    assert np.abs(q - run.q[-1]).max() < 1e-9  # through a singular position
    assert np.abs(v - run.v[-1]).max() < 1e-9


def test_equal_scenes_give_equal_text_and_adaptive_methods_are_refused() -> None:
    scene = rk4(scene_of("heavy_top"))
    assert print_loop(scene) == print_loop(scene)
    with pytest.raises(DescriptionError, match="a loop for real time needs a fixed step, got dop853"):
        print_loop(scene_of("heavy_top"))


def bouncing(height: float, step: float) -> Scene:
    """A mass that falls onto a linear stop."""
    builder = MechanismBuilder("fall")
    builder.body("mass", mass=1, com=[0, 0, 0], inertia=[1, 1, 1])
    builder.joint("P", "P", parent="base", child="mass", point=[0, 0, 0], axes=[[0, 0, 1]])
    stop = EndStop("P", lower=0, stiffness=1000)
    return rk4(Scene("fall", builder.build(), (Gravity(), stop), 0.5, 2.0, Initial({"P": height})), step)


def test_corners_are_told_where_there_are_some() -> None:
    """Fixed steps do not end at corners: the headers say so, and nothing where laws are smooth."""
    for text in (print_loop(bouncing(0.1, 1e-3))["fall_loop.h"], print_steps(bouncing(0.1, 1e-3))["fall_steps.h"]):
        assert "second order in its length" in " ".join(text.replace("*", " ").split())
    smooth = rk4(scene_of("heavy_top"))
    for text in (*print_loop(smooth).values(), *print_steps(smooth).values()):
        assert "corner" not in text


@pytest.mark.slow
def test_a_step_across_a_corner_is_of_second_order(tmp_path: Path) -> None:
    """As the header says: half the step, a quarter of the error, where the method's own order gives a sixteenth."""
    heights = np.linspace(0.1, 0.2, 40)
    exact = [simulate(replace(bouncing(h, 1), integrator=Integrator(tolerance=1e-12))).q[-1] for h in heights[:1]]
    library = built(bouncing(0.1, 1e-3), tmp_path)
    sizes, errors = loop_plant(bouncing(0.1, 1e-3)).sizes, []
    for step in (2e-3, 1e-3, 5e-4, 1e-5):
        ends = [stepped(library, bouncing(h, step), sizes, ([h], [0.0]), round(0.5 / step), step)[0] for h in heights]
        errors.append(np.array(ends))
    assert errors[-1][0] == pytest.approx(exact[0], abs=1e-7)
    off = [float(np.sqrt(np.mean((ends - errors[-1]) ** 2))) for ends in errors[:-1]]
    assert 2.5 < off[0] / off[1] < 8 and 2.5 < off[1] / off[2] < 8, off


@pytest.mark.slow
@pytest.mark.optimised
def test_a_million_steps(tmp_path: Path) -> None:
    """Drift below 1e-6 of the largest kinetic energy, loops closed; two runs of the first 10,000 have the same bits."""
    upwards = Gravity((0, 0, "9.81"))  # the crank hangs upwards and swings
    scene = rk4(Scene("swinging", catalogue.load("four_bar"), (upwards,), 5.0, 10.0, Initial(rates={"A": 1.0})))
    library = built(scene, tmp_path)
    short = simulate(scene)
    plant = loop_plant(scene)
    start = (short.q[0], short.v[0])
    first, again = (stepped(library, scene, plant.sizes, start, 10_000, 1e-3) for _ in range(2))
    assert all(x.tobytes() == y.tobytes() for x, y in zip(first, again, strict=True))
    q, v = stepped(library, scene, plant.sizes, first, 990_000, 1e-3)
    assert np.isfinite(q).all() and np.isfinite(v).all()
    energy = evaluated(short.model, "energy", {"q": np.stack([start[0], q]), "v": np.stack([start[1], v])})["energy"]
    assert abs(np.diff(energy.sum(axis=1))[0]) < 1e-6 * short.energy[:, 0].max()
    (residual,), _ = short.model("closure", q)
    assert np.abs(residual).max() < 1e-12
