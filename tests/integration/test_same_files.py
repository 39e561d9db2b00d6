"""A command on the same files says and writes what it did before, byte by byte; on any others it works anew."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from symscrew import simulation
from symscrew.cli import same_files
from symscrew.cli.parser import main
from symscrew.cli.same_files import Outcome, once_of_files
from symscrew.runtime import versions

ARM = """
[mechanism]
name = "arm"
platform = "bob"
[bodies]
bob = { mass = "2.5", com = [0, 0, "-0.4"], inertia = { principal = ["0.1", "0.1", "0.1"] } }
[joints]
hook = { type = "R", parent = "base", child = "bob", point = [0, 0, 0], axes = [[0, 1, 0]], driven = true }
"""
SCENE = """
[scene]
mechanism = "arm.toml"
duration = 0.5
rate = 20
[initial]
coordinates = { hook = 30 }
[[effects]]
type = "gravity"
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SYMSCREW_CACHE", str(tmp_path / "cache"))
    monkeypatch.delenv("SYMSCREW_NO_CACHE", raising=False)
    versions.version.cache_clear()  # of the package as it is now: somebody may have written into it since tests began
    (tmp_path / "arm.toml").write_text(ARM)
    (tmp_path / "swing.toml").write_text(SCENE)
    return tmp_path


def test_a_motion_of_before_is_the_same_in_every_byte(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Words, numbers, file and exit code, also beside a run without any cache; whatever changes is integrated."""
    counted: list[int] = []
    simulate = simulation.simulate

    def counting(*arguments, **more):
        counted.append(1)
        return simulate(*arguments, **more)

    monkeypatch.setattr(simulation, "simulate", counting)

    def run(*more: str, code: int = 0) -> tuple[bool, str, bytes, str]:
        """Whether it was integrated, what was printed and written, and what was said beside."""
        before, out = len(counted), folder / "run.npz"
        assert main(["simulate", str(folder / "swing.toml"), "--out", str(out), *more]) == code
        said = capsys.readouterr()
        return len(counted) > before, said.out, out.read_bytes(), said.err

    first, again, apart = run(), run(), run("--no-cache")
    assert (first[0], again[0], apart[0]) == (True, False, True)
    assert first[1:3] == again[1:3] == apart[1:3] and "completed" in first[1]
    note = "note: initial.coordinates.hook"
    assert note in first[3] and note in again[3] and "earlier run" in again[3] and "earlier run" not in first[3]
    numbers, numbers_again, numbers_apart = run("--json"), run("--json"), run("--json", "--no-cache")
    assert not numbers_again[0] and numbers[1] == numbers_again[1] == numbers_apart[1] != first[1]
    for file, old, new in (("swing.toml", "0.5", "0.6"), ("arm.toml", "-0.4", "-0.3"), ("swing.toml", "= 30", "= 31")):
        path = folder / file
        path.write_text(path.read_text().replace(old, new))
        changed = run()
        assert changed[0] and changed[1] != first[1] and not run()[0], (file, new)
    scene = folder / "swing.toml"
    scene.write_text(f"{scene.read_text()}\n[integrator]\nmost_steps = 1\n")
    assert run(code=1)[0] and run(code=1)[0], "what ended early is not kept"


def test_nothing_heavy_is_imported_for_it(folder: Path) -> None:
    """The second run takes a tenth of a second, for it knows neither symbols nor arrays."""
    for _ in range(2):
        assert main(["simulate", str(folder / "swing.toml")]) == 0
    text = (
        "import sys; from symscrew.cli.parser import main; "
        f"code = main(['simulate', {str(folder / 'swing.toml')!r}]); "
        "heavy = sorted({'numpy', 'sympy', 'casadi'} & set(sys.modules)); print(code, heavy)"
    )
    said = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    assert said.stdout.splitlines()[-1] == "0 []" and "earlier run" in said.stderr, said


def test_what_stands_among_the_files_of_the_package_for_a_moment(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing of it counts; a file of the package that changes does."""
    monkeypatch.setattr(versions, "PACKAGE", tmp_path)
    (tmp_path / "a.py").write_text("1")
    found = versions.version.__wrapped__
    before = found()
    (tmp_path / ".a.py.swp").write_text("")
    assert found() == before
    stat = os.stat

    def vanishing(path, **more):
        (tmp_path / "b.py").unlink(missing_ok=True)
        return stat(path, **more)

    (tmp_path / "b.py").write_text("")
    monkeypatch.setattr(versions.os, "stat", vanishing)
    assert found() == before
    (tmp_path / "a.py").write_text("22")
    assert found() != before


def test_what_it_depends_on(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Words, names, every file that is named from file to file, compiler and libraries."""
    made: list[int] = []

    def make() -> Outcome:
        made.append(1)
        return Outcome({"count": len(made)})

    def fresh(*words: object, command: str = "x", file: str = "swing.toml") -> bool:
        before = len(made)
        once_of_files(command, words, str(folder / file), make)
        return len(made) > before

    assert fresh() and not fresh() and fresh("more") and fresh(command="y")
    (folder / "other.toml").write_text(SCENE)
    assert fresh(file="other.toml"), "a scene is called as its file"
    (folder / "further.toml").write_text("a = 1")
    (folder / "arm.toml").write_text(ARM + "# further.toml\n")
    assert fresh() and not fresh()
    (folder / "arm.toml").write_text(ARM + '[points]\ntip = { body = "further.toml" }\n')
    assert fresh() and not fresh()
    (folder / "further.toml").write_text("a = 2")
    assert fresh() and not fresh(), "a file that a named file names"
    for place in ("robot.urdf", "arm"):
        (folder / place).write_text("<robot/>")
        (folder / "swing.toml").write_text(SCENE.replace("arm.toml", place))
        assert fresh() and fresh(), "files of other kinds may name further ones"
    monkeypatch.chdir(folder)
    (folder / "there").mkdir()
    (folder / "there" / "swing.toml").write_text(SCENE.replace("arm.toml", "arm"))
    assert fresh(file="there/swing.toml") and fresh(file="there/swing.toml"), "a mechanism where the command runs"
    (folder / "swing.toml").write_text(SCENE)
    assert fresh() and fresh(), "the same, of any text in a file that is named"
    (folder / "arm").unlink()
    assert not fresh()
    with monkeypatch.context() as other:
        other.setattr(same_files, "LIBRARIES", ("pytest",))
        assert fresh()
    with monkeypatch.context() as other:
        other.setenv("CPATH", str(folder))
        assert fresh()
    with monkeypatch.context() as other:
        other.setenv("PATH", str(folder))
        assert fresh() and fresh(), "without a compiler another one may come"
    (folder / "swing.toml").write_text("[scene")
    assert fresh() and fresh() and fresh(file="none.toml") and fresh(file="none.toml")


def test_files_that_change_meanwhile(folder: Path) -> None:
    """What was made of the old text is not kept under the new one's key, nor under its own."""
    scene = folder / "swing.toml"

    def make() -> Outcome:
        scene.write_text(SCENE.replace("0.5", "0.7"))
        return Outcome({})

    assert not once_of_files("x", (), str(scene), make).earlier
    assert not once_of_files("x", (), str(scene), lambda: Outcome({})).earlier
    scene.write_text(SCENE)
    assert not once_of_files("x", (), str(scene), lambda: Outcome({})).earlier
