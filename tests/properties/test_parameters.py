"""Run-time parameters: inputs of every function, the same results as baked ones, at other values too."""

from __future__ import annotations

import dataclasses
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
import sympy
from support.marks import slow
from support.model_states import pendulum, relative
from support.second_path import FUNCTIONS, LIMIT, always_second, states

from symscrew import catalogue
from symscrew.description import parse_description, to_toml
from symscrew.description.mechanism import Mechanism
from symscrew.export.c import print_c
from symscrew.export.c_precision import PRECISIONS
from symscrew.export.cpp import print_cpp
from symscrew.export.readme import print_readme
from symscrew.generation.c_target import STRICT
from symscrew.model import Model, derive
from symscrew.runtime.compiled import find_compiler

pytestmark = pytest.mark.slow


def with_parameters(mechanism: Mechanism, *, run_time: bool, scale: str = "1") -> Mechanism:
    changed = {
        name: dataclasses.replace(p, run_time=run_time, value=p.value * sympy.Rational(scale))
        for name, p in mechanism.parameters.items()
    }
    return dataclasses.replace(mechanism, parameters=changed)


@pytest.fixture(scope="module")
def run_time() -> Model:
    return derive(with_parameters(catalogue.load("three_ups_upu_s"), run_time=True))


@pytest.mark.parametrize("scale", [slow("1"), slow("11/10"), "3/4"])
def test_run_time_parameters_equal_baked_ones(run_time: Model, scale: str) -> None:
    baked = derive(with_parameters(catalogue.load("three_ups_upu_s"), run_time=False, scale=scale))
    q, v, a = baked.system.sample_states
    values = run_time.system.parameter_values * float(sympy.Rational(scale))
    for name in ("inverse_dynamics", "joint_reactions", "body_twist_rates", "momentum_rates", "mass_matrix"):
        program = baked.programs[name]
        state = [{"q": q, "v": v, "a": a}[port.name] for port in program.inputs]
        expected, _ = baked(name, *state)
        got, status = run_time(name, *state, values)
        assert np.all(status == 0)
        for x, y in zip(got, expected, strict=True):
            assert np.abs(x - y).max() < 1e-10 * np.abs(y).max(), name


def test_the_second_path_reads_parameters_and_multipliers_each_in_its_place() -> None:
    """As many parameters as rates: what is handed over in another order has the same sizes."""
    four_bar = (Path(catalogue.__file__).parent / "four_bar.toml").read_text()
    for name, value, unit in (("load", "6/5", "kg"), ("reach", "3/20", "m"), ("height", "9/20", "m")):
        table = f'[parameters.{name}]\nvalue = "{value}"\nunit = "{unit}"\nrun_time = true\n\n[bodies.crank]'
        four_bar = four_bar.replace("[bodies.crank]", table)
    for old, new in (('mass = "1.2"', 'mass = "load"'), ('0, "3/20"', '0, "reach"'), ('0, "9/20"', '0, "height"')):
        assert old in four_bar
        four_bar = four_bar.replace(old, new)
    found = derive(parse_description(four_bar))
    q, v, u = states(found)
    p = np.tile(found.system.parameter_values, (len(q), 1))
    for name in FUNCTIONS:
        expected, first = found(name, q, v, u, p)
        got, second = always_second(found)(name, q, v, u, p)
        assert (first == 0).all() and (second == -1).all()
        for x, y in zip(got, expected, strict=True):
            assert relative(x, y) < LIMIT


DELTA = (Path(catalogue.__file__).parent / "delta.toml").read_text()
PENDULUM = """
[mechanism]
name = "pendulum"
[parameters.length]
value = "0.5"
[parameters.half]
value = "length/2"
[parameters.moment]
value = "half^2/3"
[bodies.rod]
mass = 1
com = [0, 0, "-half"]
inertia = ["moment", "moment", 0]
[joints.pivot]
type = "R"
parent = "base"
child = "rod"
point = [0, 0, 0]
axes = [[0, 1, 0]]
driven = true
"""


@pytest.mark.parametrize(
    "text, name, given, new", [(PENDULUM, "length", "0.5", "0.8"), slow(DELTA, "rods", "0.7", "0.65")]
)
def test_what_is_computed_from_a_parameter_follows_it(text: str, name: str, given: str, new: str) -> None:
    """Read at run time, or written again and then changed there: as if the description had said it."""
    baked = derive(parse_description(text.replace(f'value = "{given}"', f'value = "{new}"', 1)))
    read = derive(parse_description(text, run_time=[name]))
    again = to_toml(parse_description(text))
    assert again.count(f"value = {given}\n") == 1
    changed = derive(parse_description(again.replace(f"value = {given}\n", f"value = {new}\n")))
    q, v, a = baked.system.sample_states
    values = np.full((len(q), 1), float(new))
    for function in ("inverse_dynamics", "energy", "mass_matrix"):
        state = [{"q": q, "v": v, "a": a}[port.name] for port in baked.programs[function].inputs]
        expected, _ = baked(function, *state)
        for found, arguments in ((read, [*state, values]), (changed, state)):
            got, status = found(function, *arguments)
            assert np.all(status == 0)
            for x, y in zip(got, expected, strict=True):
                assert np.abs(x - y).max() < 1e-12 * np.abs(y).max(), function


def test_only_run_time_parameters_become_an_input(run_time: Model) -> None:
    assert run_time.programs["inverse_dynamics"].inputs[-1].labels == ("R", "r", "H")
    baked = derive(catalogue.load("three_ups_upu_s"))
    assert "p" not in [port.name for port in baked.programs["inverse_dynamics"].inputs]


PENDULUM = """
#include "pendulum.h"
#include <stdio.h>

int main(void)
{
    const REAL q[] = {0.5}, v[] = {0.0}, a[] = {0.0};
    REAL before[1], after[1];
    pendulum_parameters parameters = PENDULUM_PARAMETERS_DEFAULT;
    int outcome = pendulum_inverse_dynamics(q, v, a, parameters.p, before);
    parameters.by_name.mass *= 2;
    outcome += pendulum_inverse_dynamics(q, v, a, parameters.p, after);
    printf("%d %.17g %.17g\\n", outcome, (double)before[0], (double)after[0]);
    return 0;
}
"""


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
@pytest.mark.parametrize("precision, error", [("double", 1e-14), ("single", 1e-6)])
def test_parameters_of_c_have_names_and_defaults(precision: str, error: float, tmp_path: Path) -> None:
    """The torque that holds a rod of mass m and length l at an angle: m g l/2 sin(angle)."""
    real = PRECISIONS[precision]
    for name, text in print_c(pendulum(), precision=real).items():
        (tmp_path / name).write_text(text)
    header = (tmp_path / "pendulum.h").read_text()
    assert f"{real.real} length; /* [m] length of the rod; default 0.5{real.suffix} */" in header
    (tmp_path / "main.c").write_text(PENDULUM.replace("REAL", real.real))
    command = [str(find_compiler()), *STRICT, "-O0", "main.c", "pendulum.c", "-o", "main", "-lm"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    printed = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=True).stdout.split()
    torque = 1.5 * 9.81 * 0.25 * np.sin(0.5)
    assert printed[0] == "0" and [float(x) for x in printed[1:]] == pytest.approx([torque, 2 * torque], rel=error)


@pytest.mark.skipif(find_compiler() is None or shutil.which("c++") is None, reason="no compilers of C and C++")
def test_the_readme_shows_the_type(tmp_path: Path) -> None:
    """Its examples compile and give the torque of the defaults; twice the mass needs twice as much."""
    found = pendulum()
    for name, text in (print_c(found) | print_cpp(found)).items():
        (tmp_path / name).write_text(text)
    c, cpp = re.findall(r"```c\w*\n(.*?)```", print_readme(found, {"c": "C99"}), re.DOTALL)
    declared = "    pendulum_parameters p_ = PENDULUM_PARAMETERS_DEFAULT; /* such as p_.by_name.length */\n"
    assert declared in c and declared in cpp
    (tmp_path / "main.c").write_text(c)
    (tmp_path / "main.cpp").write_text(cpp.replace(declared, declared + "    p_.by_name.mass *= 2;\n"))
    subprocess.run([str(find_compiler()), "-std=c99", "-O0", "-c", "pendulum.c"], cwd=tmp_path, check=True)
    printed = []
    for command in (["cc", "-std=c99", "-Wall", "-Werror", "main.c"], ["c++", "-std=c++17", "-Wall", "main.cpp"]):
        subprocess.run([*command, "pendulum.o", "-o", "main", "-lm"], cwd=tmp_path, check=True)
        printed.append(subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=True).stdout)
    state = [array[:1] for array in found.test_inputs["inverse_dynamics"]]
    torque = found("inverse_dynamics", *state)[0][0].item()
    assert all(text.startswith("success: ") for text in printed)
    assert [float(text.split(":")[1]) for text in printed] == pytest.approx([torque, 2 * torque], rel=1e-11)
