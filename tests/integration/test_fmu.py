"""Functional mock-up units: valid, and the same motion as our own simulation, in both standards and both kinds."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.model_states import pendulum

from symscrew import scene as scenes
from symscrew.cli.parser import main
from symscrew.description import toml_file
from symscrew.fmu.unit_archive import _other_steps, build_unit
from symscrew.fmu.unit_variables import structured
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.contents import Scene
from symscrew.simulation import state_programs
from symscrew.simulation.motion import simulate

fmpy = pytest.importorskip("fmpy")
from fmpy.validation import validate_fmu  # noqa: E402

pytestmark = [
    pytest.mark.slow,
    pytest.mark.short_runs,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: units have no binary"),
]

SWINGING = """
[scene]
name = "swinging"
mechanism = "four_bar"
duration = 0.5
rate = 20

[initial.rates]
A = 3.0

[[effects]]
type = "gravity"
acceleration = [0, 0, "-9.81"]

[integrator]
method = "{method}"
{rest}
"""
PUSHED = (
    SWINGING
    + """
[[effects]]
type = "external_wrench"
point = "coupler_middle"
"""
)
FIXED = {"method": "rk4", "rest": "step = 1e-3"}
EXACT = {"method": "dop853", "rest": "tolerance = 1e-11"}


@pytest.fixture(scope="module")
def units(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    folder = tmp_path_factory.mktemp("units")
    for version in (2, 3):
        assert (
            build_unit(scenes.parse_scene(SWINGING.format(**FIXED)), folder / f"{version}.fmu", version=version) == []
        )
    return {version: folder / f"{version}.fmu" for version in (2, 3)}


def run(unit: Path, kind: str, **options: Any) -> np.ndarray:
    return fmpy.simulate_fmu(
        str(unit),
        fmi_type=kind,
        stop_time=0.5,
        output_interval=0.05,
        step_size=0.05,
        relative_tolerance=1e-10,
        **options,
    )


def own(text: str) -> tuple[Scene, Any]:
    found = scenes.parse_scene(text)
    return found, simulate(found)


def coordinates(result: np.ndarray, run_of: Any) -> tuple[np.ndarray, np.ndarray]:
    labels = [c.label for c in run_of.model.system.tree.q]
    at = [int(np.argmin(abs(result["time"] - t))) for t in run_of.t]
    return np.array([[result[structured("q", label)][k] for label in labels] for k in at]), run_of.q


@pytest.mark.slow
@pytest.mark.parametrize("version", [2, 3])
def test_unit_is_valid(units: dict[int, Path], version: int) -> None:
    assert validate_fmu(str(units[version])) == []
    described = fmpy.read_model_description(str(units[version]))
    assert described.coSimulation is not None and described.modelExchange is not None
    units_of = {v.name: v.unit for v in described.modelVariables}
    assert units_of["u.A"] == "N m" and units_of["q.A"] == "rad" and units_of["der(v.A)"] == "rad/s^2"


@pytest.mark.parametrize("version", [2, 3])
def test_co_simulation_takes_the_steps_of_our_own_loop(units: dict[int, Path], version: int) -> None:
    got, expected = coordinates(run(units[version], "CoSimulation"), own(SWINGING.format(**FIXED))[1])
    assert np.abs(got - expected).max() < 1e-12


@pytest.mark.parametrize("version", [2, 3])
def test_model_exchange_follows_the_same_motion(units: dict[int, Path], version: int) -> None:
    result = run(units[version], "ModelExchange", solver="CVode")
    got, expected = coordinates(result, own(SWINGING.format(**EXACT))[1])
    assert np.abs(got - expected).max() < 1e-6


@pytest.mark.slow
def test_drives_and_loads_are_inputs(tmp_path: Path) -> None:
    """A constant drive and a load at a point by their inputs: the same as a scene that commands them."""
    text = PUSHED.format(**FIXED)
    build_unit(scenes.parse_scene(text), tmp_path / "pushed.fmu")
    commanded = text + '[drives]\nA = "2.5"\n[inputs]\nload_coupler_middle = ["4", "0", "-3", "0", "0.5", "0"]\n'
    names = ["u.A", *(f"load_coupler_middle.{c}" for c in ("fx", "fy", "fz", "mx", "my", "mz"))]
    values = dict(zip(names, (2.5, 4, 0, -3, 0, 0.5, 0), strict=True))
    result = run(tmp_path / "pushed.fmu", "CoSimulation", start_values=values)
    got, expected = coordinates(result, own(commanded)[1])
    assert np.abs(got - expected).max() < 1e-12


def test_a_start_that_cannot_be_closed_is_an_error(units: dict[int, Path]) -> None:
    with pytest.raises(Exception, match="fmi3"):
        run(units[3], "CoSimulation", start_values={"q.A": 0.0, "q.B": 2.0, "q.D": -2.5})


def test_state_can_be_saved_and_restored(units: dict[int, Path]) -> None:
    from fmpy.fmi2 import FMU2Slave

    described = fmpy.read_model_description(str(units[2]))
    folder = fmpy.extract(str(units[2]))
    try:
        unit = FMU2Slave(guid=described.guid, unzipDirectory=folder, modelIdentifier="swinging", instanceName="one")
        unit.instantiate()
        unit.setupExperiment(startTime=0.0)
        unit.enterInitializationMode()
        unit.exitInitializationMode()
        references = [v.valueReference for v in described.modelVariables if v.name.startswith("q.")]
        unit.doStep(0.0, 0.1)
        saved, there = unit.getFMUState(), unit.getReal(references)
        unit.doStep(0.1, 0.1)
        after = unit.getReal(references)
        unit.setFMUState(saved)
        assert unit.getReal(references) == there
        unit.doStep(0.1, 0.1)
        assert unit.getReal(references) == after
        unit.freeFMUState(saved)
        unit.terminate()
        unit.freeInstance()
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def test_sources_compile_without_warnings(units: dict[int, Path], tmp_path: Path) -> None:
    for version, unit in units.items():
        with zipfile.ZipFile(unit) as archive:
            archive.extract("sources/swinging.c", tmp_path)
        command = [str(find_compiler()), "-std=c99", "-Wall", "-Wextra", "-Wno-unused-function",
                   "-Wno-unused-parameter", "-Werror", "-c", "swinging.c"]  # fmt: skip
        result = subprocess.run(command, cwd=tmp_path / "sources", capture_output=True, text=True, check=False)
        assert result.returncode == 0, (version, result.stderr[:2000])


def test_equal_scenes_give_equal_bytes(units: dict[int, Path], tmp_path: Path) -> None:
    build_unit(scenes.parse_scene(SWINGING.format(**FIXED)), tmp_path / "again.fmu")
    with zipfile.ZipFile(units[3]) as first, zipfile.ZipFile(tmp_path / "again.fmu") as second:
        names = [name for name in first.namelist() if not name.startswith("binaries/")]
        assert all(first.read(name) == second.read(name) for name in names)


@pytest.mark.parametrize("method", ["dop853", "radau"])
def test_other_steps_than_the_scene_asks_for_are_told(tmp_path: Path, method: str) -> None:
    text = SWINGING.format(method=method, rest="tolerance = 1e-9")
    scene = scenes.parse_scene(text)
    noted = _other_steps(scene)
    assert len(noted) == 1 and "steps of 0.001 s by rk4" in noted[0] and f"not the scene's {method}" in noted[0]
    for fixed in ("rk4", "rk8"):
        kept = replace(scene, integrator=replace(scene.integrator, method=fixed, step=1e-3))
        assert _other_steps(kept) == []


def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    own = tmp_path / "own.toml"
    own.write_text(toml_file.to_toml(pendulum().mechanism))
    for given, version in (("four_bar", "2"), (str(own), "3")):
        unit = tmp_path / f"{Path(given).stem}.fmu"
        assert main(["fmu", given, "--out", str(unit), "--fmi", version]) == 0
        assert "note:" not in capsys.readouterr().err
        assert validate_fmu(str(unit)) == []
        unit.unlink()
    own.unlink()
    for arguments, said in (
        (["fmu", "four_bar", "--out", str(tmp_path / "four_bar.zip")], ".fmu"),
        (["fmu", "four_ba", "--out", str(tmp_path / "x.fmu")], "four_ba"),
        (["fmu", "four_bar", "--out", str(tmp_path / "none" / "x.fmu")], "folder"),
    ):
        capsys.readouterr()
        with pytest.raises(SystemExit) as stopped:
            raise SystemExit(main(arguments))
        assert stopped.value.code == 2 and said in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


LIFE = {  # of an instance: what brings it on, per standard; what each may be called in between is in the tables below
    2: ("EnterInitializationMode", "ExitInitializationMode", "Terminate"),
    3: ("EnterInitializationMode", "ExitInitializationMode", "Terminate"),
}
CO, EXCHANGE = True, False
REFUSED = {  # stage of the life: functions that must be refused there, of both standards
    0: ("ExitInitializationMode", "Terminate", "DoStep", "GetReal", "EnterEventMode", "SetTime"),
    1: ("EnterInitializationMode", "Terminate", "DoStep", "EnterEventMode", "CompletedIntegratorStep"),
    2: ("EnterInitializationMode", "ExitInitializationMode"),
    3: ("EnterInitializationMode", "DoStep", "SetReal", "Terminate", "EnterContinuousTimeMode"),
}
OTHER_KIND = {CO: ("EnterEventMode", "SetTime", "CompletedIntegratorStep"), EXCHANGE: ("DoStep",)}
WELL = {1: ("SetReal", "GetReal"), 2: ("SetReal", "GetReal"), 3: ("GetReal",)}


class Instance:
    """An instance of a unit's binary, called as C is."""

    def __init__(self, folder: Path, unit: Path, version: int, *, steps_itself: bool) -> None:
        described = fmpy.read_model_description(str(unit))
        place = folder / "binaries" / {2: "linux64", 3: "x86_64-linux"}[version] / "swinging.so"
        self.library, self.version, self.said = ctypes.CDLL(str(place)), version, list[str]()
        none, no = None, ctypes.c_bool(False)
        references = [v.valueReference for v in described.modelVariables if v.name == "u.A"]
        self.arrays = ((ctypes.c_uint * 1)(*references), ctypes.c_size_t(1), (ctypes.c_double * 1)())
        token = (described.guid or described.instantiationToken).encode()
        if version == 2:
            make = self.library.fmi2Instantiate
            given = (b"one", ctypes.c_int(steps_itself), token, b"", none, 0, 0)
        else:
            make = getattr(self.library, f"fmi3Instantiate{'CoSimulation' if steps_itself else 'ModelExchange'}")
            rest = (no, no, none, ctypes.c_size_t(0), none, none, none) if steps_itself else (none, none)
            given = (b"one", token, b"", no, no, *rest)
        make.restype = ctypes.c_void_p
        self.own = ctypes.c_void_p(make(*given))
        assert self.own

    def call(self, name: str) -> int:
        """The status of a function with arguments that fit it."""
        no, zero, step = ctypes.c_bool(False), ctypes.c_double(0), ctypes.c_double(0.01)
        places = [ctypes.byref(ctypes.c_double()) for _ in range(4)]
        size = (ctypes.c_size_t(1),) if self.version == 3 else ()
        given: dict[str, tuple[Any, ...]] = {
            "EnterInitializationMode": (no, zero, zero, no, zero) if self.version == 3 else (),
            "DoStep": (zero, step, no, *(places if self.version == 3 else ())),
            "GetReal": (*self.arrays, *size), "SetReal": (*self.arrays, *size), "SetTime": (zero,),
            "CompletedIntegratorStep": (no, *places[:2]),
        }  # fmt: skip
        real = {"GetReal": "GetFloat64", "SetReal": "SetFloat64"} if self.version == 3 else {}
        return int(getattr(self.library, f"fmi{self.version}{real.get(name, name)}")(self.own, *given.get(name, ())))


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("steps_itself", [CO, EXCHANGE])
def test_calls_in_the_wrong_state_are_refused(
    units: dict[int, Path], tmp_path: Path, version: int, steps_itself: bool
) -> None:
    with zipfile.ZipFile(units[version]) as archive:
        archive.extractall(tmp_path)
    one = Instance(tmp_path, units[version], version, steps_itself=steps_itself)
    for stage in range(4):
        for name in (*REFUSED[stage], *OTHER_KIND[steps_itself]):
            assert one.call(name) == 3, (stage, name)
        for name in WELL.get(stage, ()):
            assert one.call(name) == 0, (stage, name)
        if stage == 2 and steps_itself:
            assert one.call("DoStep") == 0
        if stage == 2 and not steps_itself:
            path = ("SetTime", "EnterContinuousTimeMode", "SetTime", "CompletedIntegratorStep", "EnterEventMode")
            assert [one.call(name) for name in path] == [0] * 5
            assert one.call("CompletedIntegratorStep") == 3
        if stage < 3:
            assert one.call(LIFE[version][stage]) == 0
    assert one.call("Reset") == 0 and one.call("EnterInitializationMode") == 0
    assert one.call("SetReal") == 0
    nobody = ctypes.c_void_p(None)
    assert getattr(one.library, f"fmi{version}Terminate")(nobody) == 3
    assert getattr(one.library, f"fmi{version}SetFMU{'state' if version == 2 else 'State'}")(one.own, None) == 3
    getattr(one.library, f"fmi{version}FreeInstance")(one.own)


@pytest.mark.parametrize("length", [0.0, -1.0, float("nan"), float("inf"), 1e300])
def test_steps_that_do_not_end_are_refused(units: dict[int, Path], tmp_path: Path, length: float) -> None:
    with zipfile.ZipFile(units[2]) as archive:
        archive.extractall(tmp_path)
    one = Instance(tmp_path, units[2], 2, steps_itself=True)
    assert one.call("EnterInitializationMode") == one.call("ExitInitializationMode") == 0
    step, zero = one.library.fmi2DoStep, ctypes.c_double(0)
    assert step(one.own, zero, ctypes.c_double(length), 0) == 3
    assert step(one.own, zero, ctypes.c_double(0.01), 0) == 0
    one.library.fmi2FreeInstance(one.own)


EFFECTS = Path(__file__).parents[2] / "examples" / "effects"


@pytest.mark.slow
@pytest.mark.parametrize(
    "name, step, steps", [("loose_crank", 2e-7, 2000), ("geared_pendulum", 5e-4, 200), ("rolling_wheel", 1e-4, 500),
                          ("flexible_slider_crank", 1e-5, 500)],
)  # fmt: skip
def test_units_of_effects_with_states_and_contacts_move_as_our_own_loop(
    name: str, step: float, steps: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Clearance, backlash, rolling and bending: q and every state of the effects after some steps of RK4. A unit that
    takes another step than the scene's, or starts a flexible link without its own velocity, is off at once.

    Steps of a unit are as long as its scene says: they end at no corner of a law, so neither do ours here."""
    monkeypatch.setattr(state_programs, "switches", lambda *_: None)
    scene = scenes.load_scene(EFFECTS / f"{name}.toml")
    integrator = replace(scene.integrator, method="rk4", step=step)
    scene = replace(scene, integrator=integrator, duration=steps * step, rate=4 / (steps * step))
    expected = simulate(scene)
    assert expected.q.shape[0] == 5, expected.status
    build_unit(scene, tmp_path / "unit.fmu")
    result = fmpy.simulate_fmu(
        str(tmp_path / "unit.fmu"), fmi_type="CoSimulation", stop_time=steps * step, output_interval=steps * step / 4
    )
    got, wanted = coordinates(result, expected)
    assert np.abs(got - wanted).max() < 1e-11
    states = [k for k, label in enumerate(expected.x_labels) if structured("x", label) in (result.dtype.names or ())]
    assert len(states) >= (name not in ("loose_crank",))
    for k in states:
        moved = result[structured("x", expected.x_labels[k])][-1]
        assert moved == pytest.approx(expected.x[-1, k], rel=1e-9, abs=1e-12)


BENDING = """
[mechanism]
name = "rod"
ground = "base"

[parameters.P]
value = 1
run_time = true

[bodies.rod]
mass = 2
com = ["1/2", 0, 0]
inertia = ["1/10", "1/2", "1/2"]

[joints.A]
type = "R"
parent = "base"
child = "rod"
point = [0, 0, 0]
axes = [[0, 0, 1]]

[points]
near = { body = "rod", at = [0, 0, 0] }
far = { body = "rod", at = [1, 0, 0] }
"""


def test_states_of_effects_begin_where_the_start_of_an_importer_puts_them(tmp_path: Path) -> None:
    """A rod that bends, with rate and parameter at the start by the importer: its states kept the values of the scene's
    own start, and the rod bent by three times as much. What the importer says of states is kept."""
    text = SWINGING.replace('"four_bar"', '"rod.toml"').replace("0.5\nrate = 20", "0.02\nrate = 100")
    text = text.format(**FIXED) + '[[effects]]\ntype = "flexible_link"\nstart = "near"\nend = "far"\naxis = [0, 0, 1]\n'
    text += 'shape = "clamped"\nmodes = 1\nline_density = "1/2"\nbending_stiffness = 2\ninitial = ["P/100"]\n'
    (tmp_path / "rod.toml").write_text(BENDING)
    build_unit(scenes.parse_scene(text, folder=tmp_path), tmp_path / "rod.fmu")
    other = text.replace("A = 3.0", "A = 0.5") + "[parameters]\nP = 2\n"
    expected = simulate(scenes.parse_scene(other, folder=tmp_path))
    states = [structured("x", label) for label in expected.x_labels[:2]]
    for kind in ("CoSimulation", "ModelExchange"):
        start: dict[str, float] = {"v.A": 0.5, "p.P": 2.0}
        more = {"stop_time": 0.02, "output_interval": 0.01, "fmi_type": kind, "relative_tolerance": 1e-10}
        found = fmpy.simulate_fmu(str(tmp_path / "rod.fmu"), start_values=start, **more)
        got = np.array([[row[name] for name in ("q.A", "v.A", *states)] for row in found])
        wanted = np.column_stack([expected.q, expected.v, expected.x[:, :2]])
        assert np.abs(got - wanted).max() < (1e-10 if kind == "CoSimulation" else 1e-6)
    found = fmpy.simulate_fmu(str(tmp_path / "rod.fmu"), start_values={**start, states[0]: 0.03}, **more)
    assert [found[name][0] for name in states] == pytest.approx([0.03, expected.x[0, 1]], rel=1e-12)
