"""Generated C on Cortex-M4F and M7 under an emulator, and under tools that read it for errors."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest
from support.model_states import model, pendulum

from symscrew.cli.parser import main
from symscrew.description import toml_file
from symscrew.export.c import print_c
from symscrew.export.c_precision import PRECISIONS
from symscrew.program.rank_revealing import RankRevealing
from symscrew.verification.embedded import emulation
from symscrew.verification.embedded.emulation import measure, missing_tools
from symscrew.verification.regeneration import check

EMULATED = pytest.mark.skipif(bool(missing_tools()), reason=f"not found: {'; '.join(missing_tools())}")


def needs(tool: str) -> pytest.MarkDecorator:
    return pytest.mark.skipif(shutil.which(tool) is None, reason=f"{tool} is not installed")


# A closed chain with a second path and an iteration, an open one, and one with run-time parameters.
CASES = [
    ("four_bar", "m4f", "single"),
    ("four_bar", "m7", "double"),
    ("ur5", "m4f", "double"),
    ("ur5", "m7", "single"),
    ("pendulum", "m4f", "single"),
]


# Of the arm those without a like in the others; of the four-bar in double one of each kind: all are measured in single.
SOME: dict[object, list[str]] = {
    "ur5": ["inverse_dynamics", "mass_matrix", "forward_dynamics", "forward_kinematics", "joint_reactions"],
    ("four_bar", "m7"): ["assemble", "velocity", "energy", "inverse_dynamics", "forward_dynamics", "constraint_margin"],
}


@EMULATED
@pytest.mark.parametrize("name, core, precision", CASES)
def test_every_function_gives_the_same_numbers_there(name: str, core: str, precision: str) -> None:
    chosen = SOME.get(name, SOME.get((name, core)))
    limit, found = 1e-4 if precision == "single" else 1e-12, measure(model(name), core, precision, chosen)["functions"]
    assert set(found) == set(chosen or model(name).programs)
    for function, entry in found.items():
        assert entry["error"] < limit, function
        assert 0 < entry["flash"] < 50_000 and entry["instructions"] > 0 and 0 < entry["stack"] < 20_000, function
        library = 700  # sines of doubles; the frames of a function at least hold what it wrote besides
        assert entry["stack"] - library < entry["frame"] < 20_000, function
    if (name, core) == ("four_bar", "m4f"):  # the second path was not taken, and counts
        assert found["forward_dynamics"]["frame"] > found["forward_dynamics"]["stack"]


@EMULATED
def test_counts_are_repeatable_and_of_the_right_size() -> None:
    """Double precision on a core without it costs many times as much; counts do not depend on the run."""
    chosen, found = ["inverse_dynamics", "mass_matrix"], model("ur5")
    single, again, double = (measure(found, "m4f", precision, chosen)["functions"]
                             for precision in ("single", "single", "double"))  # fmt: skip
    assert single == again and list(single) == chosen
    for name in chosen:
        operations = found.programs[name].operations["total"]
        assert operations < single[name]["instructions"] < 8 * operations
        assert double[name]["instructions"] > 5 * single[name]["instructions"]


@EMULATED
def test_frames_hold_the_second_path() -> None:
    """With guards that every state fails: what is written then is what the frames allow, and not much less."""
    found = model("planar_3rrr")
    program = found.programs["forward_dynamics"]
    assert isinstance(program, RankRevealing)
    failing = replace(program, guards=tuple((slot, 1e30) for slot, _ in program.guards))
    first = measure(found, "m4f", functions=["forward_dynamics"])["functions"]["forward_dynamics"]
    second = measure(replace(found, programs={**found.programs, "forward_dynamics": failing}), "m4f",
                     functions=["forward_dynamics"])["functions"]["forward_dynamics"]  # fmt: skip
    assert 3 * first["stack"] < second["stack"] < first["frame"] + 100
    assert first["frame"] == second["frame"] < 1.5 * second["stack"]


@EMULATED
def test_a_mechanism_may_be_called_like_a_file_of_the_board() -> None:
    started = replace(pendulum(), name="start")
    assert measure(started, "m4f", functions=["mass_matrix"] * 2)["functions"]["mass_matrix"]["error"] < 1e-5


@EMULATED
def test_command(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    file = tmp_path / "embedded.json"
    arguments = ["embedded", "four_bar", "--core", "m4f", "--function", "inverse_dynamics", "--out", str(file)]
    assert main(arguments) == 0
    printed = capsys.readouterr().out
    (entry,) = json.loads(file.read_text())
    assert entry["core"] == "Cortex-M4F" and entry["precision"] == "single"
    assert str(entry["functions"]["inverse_dynamics"]["instructions"]) in printed
    assert main([*arguments[:4], "--function", "inverse"]) == 2
    assert "no function 'inverse'" in capsys.readouterr().err


@EMULATED
def test_figures_stand_in_the_header_and_are_measured_again(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    out, file = tmp_path / "out", tmp_path / "pendulum.toml"
    file.write_text(toml_file.to_toml(pendulum().mechanism))
    arguments = ["generate", str(file), "--target", "c", "--precision", "single", "--embedded", "m4f"]
    arguments += ["--functions", "inverse_dynamics"]
    assert main([*arguments, "--out", str(out)]) == 0
    (record,) = json.loads((out / "ops.json").read_text())["embedded"]
    figures = record["functions"]["inverse_dynamics"]
    header = re.sub(r"\s*\n \*\s*", " ", (out / "pendulum.h").read_text())
    said = f"{figures['flash']} bytes of flash, {figures['stack']} of stack (own frames at most {figures['frame']}), "
    said += f"{figures['instructions']} instructions"
    assert f"Note: Cortex-M4F, arm-none-eabi-gcc {record['compiler'].split()[1]} -O2: {said}" in header
    result = check(out)
    assert result.ok, result.lines
    assert any("flash, stack and instructions of" in line and "as in ops.json" in line for line in result.lines)
    figures["instructions"] -= 1
    (out / "ops.json").write_text(json.dumps({**json.loads((out / "ops.json").read_text()), "embedded": [record]}))
    failed = [line for line in check(out).lines if "FAILED" in line]
    before = figures["instructions"]
    assert any(f"instructions of inverse_dynamics changed from {before} to {before + 1}" in line for line in failed)
    assert main(["generate", str(file), "--target", "numpy", "--embedded", "m7", "--out", str(tmp_path / "no")]) == 2
    assert "--embedded measures C" in capsys.readouterr().err


# -- what code for such machines must not do ---------------------------------------------------------------


def sources(folder: Path, name: str, precision: str, *functions: str, **options: bool) -> Path:
    """The printed C in a folder, of these functions or all."""
    found = model(name).only(functions) if functions else model(name)
    for file, text in print_c(found, precision=PRECISIONS[precision], **options).items():
        (folder / file).write_text(text)
    return folder / f"{name}.c"


def silent(commands: list[list[str]]) -> None:
    """All commands succeed and say nothing; two at a time."""

    def run(command: list[str]) -> tuple[int, str]:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    with ThreadPoolExecutor(2) as pool:
        for command, result in zip(commands, pool.map(run, commands), strict=True):
            assert result == (0, ""), command


ANALYZER = ["-std=c99", "-O1", "-fanalyzer", "-Wall", "-Wextra", "-Wvla", "-Werror", "-c", "-o", "/dev/null"]
VECTORS = ["-D__GNUC__=12", "-D__x86_64__=1", "-D__GLIBC__=2", "-D__AVX2__=1", "-D_OPENMP=201511"]
CPPCHECK = ["cppcheck", "--quiet", "--std=c99", "--enable=warning,performance,portability", "--error-exitcode=1"]

# Of each form one: an iteration, a second path, chains; of equal limbs side by side, a sum over limbs, a small matrix.
OF_LOOPS = ("assemble", "forward_dynamics", "inverse_dynamics", "constraint_margin")
OF_LIMBS = ("inverse_dynamics", "momentum_screws", "mass_matrix")


@needs("gcc")
def test_the_analyzer_of_gcc_finds_nothing(tmp_path: Path) -> None:
    """What a microcontroller is given in single precision, one function of each form (all are as clean)."""
    embedded_one = sources(tmp_path, "four_bar", "single", *OF_LOOPS, batches=False)
    cross = shutil.which(emulation.COMPILER)
    compiler = [cross, "-mthumb", *emulation.CORES["m4f"].flags] if cross else ["gcc"]
    silent([[*compiler, *ANALYZER, str(embedded_one)]])


@pytest.mark.slow
@needs("gcc")
def test_the_analyzer_of_gcc_finds_nothing_in_limbs(tmp_path: Path) -> None:
    """With vectors and batches; iterations and second paths are those of the four-bar above.

    (All of the seed, which takes half a minute, the delta and the UR5 are as clean.)
    """
    silent([["gcc", *ANALYZER, str(sources(tmp_path, "planar_3rrr", "double", *OF_LIMBS))]])


@needs("gcc")
@needs("cppcheck")
def test_both_would_say_something(tmp_path: Path) -> None:
    """The same commands on the same file are not silent about a function that reads what was never written."""
    source = sources(tmp_path, "four_bar", "double", "inverse_dynamics", batches=False)
    wrong = "double four_bar_wrong(int k);\ndouble four_bar_wrong(int k)\n"
    wrong += "{\n    double x[3];\n    return k > 0 ? x[2] : 0.0;\n}\n"
    source.write_text(source.read_text() + wrong)
    for command in (["gcc", *ANALYZER], [*CPPCHECK, *VECTORS]):
        done = subprocess.run([*command, str(source)], capture_output=True, text=True, check=False)
        assert done.returncode != 0 and "uninit" in done.stderr, command[0]


@needs("cppcheck")
def test_cppcheck_finds_nothing(tmp_path: Path) -> None:
    """For a microcontroller, and for gcc with vectors and threads: trying all combinations takes minutes."""
    commands = []
    for precision, options in (("double", VECTORS), ("single", ["-DFOUR_BAR_STATE_BY_STATE"])):
        (tmp_path / precision).mkdir()
        commands.append([*CPPCHECK, *options, str(sources(tmp_path / precision, "four_bar", precision, *OF_LOOPS))])
    silent(commands)


@pytest.mark.slow
@needs("cppcheck")
def test_cppcheck_finds_nothing_in_limbs(tmp_path: Path) -> None:
    """Each in a file of its own, with its batches: with the whole file it came to no end.

    (All of the seed's are clean. The delta and the Stewart platform take minutes: it follows both values of every
    select. They and the UR5 were as clean.)
    """
    commands = []
    for function in (*OF_LIMBS, "forward_dynamics"):
        (tmp_path / function).mkdir()
        commands.append([*CPPCHECK, *VECTORS, str(sources(tmp_path / function, "planar_3rrr", "double", function))])
    silent(commands)
