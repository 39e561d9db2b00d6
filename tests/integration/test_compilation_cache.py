"""Compilers are asked once for the same library, and those that hang, lie or babble end in one CompileError."""

from __future__ import annotations

import ctypes
import multiprocessing
import os
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.batches import inputs, only
from support.model_states import model
from support.samples import some_quickly

from symscrew.cli.parser import main
from symscrew.model import Model
from symscrew.runtime import CompileError, cache_state, compilers, find_compiler, load
from symscrew.runtime.compilers import FLAGS, compile_c

pytestmark = [
    pytest.mark.slow,
    pytest.mark.short_runs,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler"),
    pytest.mark.skipif(os.name != "posix", reason="compilers here are scripts of a shell"),
]
REAL = find_compiler() or ""
SOURCE = '#include "answer.h"\nint answer(void) { return ANSWER; }\n'
Calls = Callable[[], int]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A cache and a source of its own, and no compiler but those that a test writes."""
    monkeypatch.setenv("SYMSCREW_CACHE", str(tmp_path / "cache"))
    (tmp_path / "answer.c").write_text(SOURCE)
    (tmp_path / "answer.h").write_text("#define ANSWER 42\n")
    (tmp_path / "bin").mkdir()
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}")
    return tmp_path


def compiler(folder: Path, text: str) -> str:
    """A compiler that is a script, as `cc`; what it is called for stands in calls.log, a line each."""
    script = folder / "bin" / "cc"
    asked = f'[ "$1" = --version ] && {{ echo fake 1.0; exit 0; }}\necho "$@" >> {folder}/calls.log\n'
    script.write_text(f"#!/bin/sh\n{asked}{text}\n")
    script.chmod(0o755)
    return str(script)


def calls(folder: Path) -> int:
    log = folder / "calls.log"
    return len(log.read_text().splitlines()) if log.exists() else 0


def answer(folder: Path, **options: object) -> int:
    library = folder / f"answer_{time.monotonic_ns()}.so"
    compile_c(folder / "answer.c", library, **options)  # type: ignore[arg-type]
    return int(ctypes.CDLL(str(library)).answer())


def test_the_same_is_compiled_once_and_what_differs_again(folder: Path) -> None:
    compiler(folder, f'exec {REAL} "$@"')
    assert [answer(folder), answer(folder), calls(folder)] == [42, 42, 1]
    (folder / "answer.h").write_text("#define ANSWER 43\n")
    assert [answer(folder), answer(folder), calls(folder)] == [43, 43, 2]
    (folder / "answer.c").write_text(SOURCE.replace("ANSWER;", "ANSWER + MORE;"))
    assert [answer(folder, flags=["-DMORE=1"]), answer(folder, flags=["-DMORE=2"]), calls(folder)] == [44, 45, 4]
    assert [answer(folder, flags=["-DMORE=1"]), calls(folder)] == [44, 4]
    assert [answer(folder, flags=["-DMORE=1"], native=False), calls(folder)] == [44, 5]
    compiler(folder, f'exec {REAL} "$@" # another one')
    assert [answer(folder, flags=["-DMORE=1"]), calls(folder)] == [44, 6]


def test_further_sources_count_by_what_is_in_them(folder: Path) -> None:
    compiler(folder, f'exec {REAL} "$@"')
    (folder / "answer.c").write_text("int more(void); int answer(void) { return more(); }\n")
    for place, value, count in (("a", 1, 1), ("b", 1, 1), ("b", 2, 2)):
        (folder / place).mkdir(exist_ok=True)
        (folder / place / "more.c").write_text(f"int more(void);\nint more(void) {{ return {value}; }}\n")
        assert [answer(folder, flags=[str(folder / place / "more.c")]), calls(folder)] == [value, count]


@pytest.mark.parametrize(
    "flags", [["-I."], ["-include", "answer.h"], ["-Wl,-z,now"], ["-fprofile-generate"], ["-L."], ["-lm"]]
)
def test_what_depends_on_more_than_the_sources_is_not_kept(folder: Path, flags: list[str]) -> None:
    compiler(folder, f'exec {REAL} "$@"')
    os.chdir(folder)
    assert [answer(folder, flags=flags), answer(folder, flags=flags), calls(folder)] == [42, 42, 2]
    assert cache_state().entries == 0


def test_a_spoiled_library_is_made_again(folder: Path) -> None:
    compiler(folder, f'exec {REAL} "$@"')
    assert answer(folder) == 42
    (entry,) = (path for path in (folder / "cache").iterdir() if not path.name.startswith("lock"))
    whole = entry.read_bytes()
    for spoiled in (whole[:-1], whole[: len(whole) // 2], b"", whole[:300] + b"\0" + whole[301:], b"\x7fELF junk"):
        entry.write_bytes(spoiled)
        count = calls(folder)
        assert [answer(folder), calls(folder), entry.read_bytes()] == [42, count + 1, whole]


def test_without_the_cache_nothing_is_kept(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    compiler(folder, f'exec {REAL} "$@"')
    monkeypatch.setenv("SYMSCREW_NO_CACHE", "1")
    assert [answer(folder), answer(folder), calls(folder)] == [42, 42, 2] and not (folder / "cache").exists()


def several(folder: Path) -> None:
    assert answer(folder) == 42


def test_several_at_once_ask_once(folder: Path) -> None:
    compiler(folder, f'sleep 0.2\nexec {REAL} "$@"')
    context = multiprocessing.get_context("fork")
    workers = [context.Process(target=several, args=(folder,)) for _ in range(3)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join(30)
    assert [worker.exitcode for worker in workers] == [0, 0, 0] and calls(folder) == 1


BAD = {
    "refuses": ("printf 'answer.c: b\\374se \\377\\n' >&2; exit 1", "refused answer.c:.*answer.c: b.se"),
    "writes nothing": ("exit 0", "ended well on answer.c, but wrote no library"),
    "writes junk": ('for w; do [ "$p" = -o ] && echo junk > "$w"; p=$w; done', ".*wrote 5 bytes that are no library"),
    "writes half": (
        f'{REAL} "$@"; for w; do [ "$p" = -o ] && truncate -s 4000 "$w"; p=$w; done',
        ".*wrote 4000 bytes that are no library",
    ),
    "dies": ("kill -9 $$", "refused answer.c"),
    "babbles": ("head -c 3000000 /dev/zero >&2; echo the end >&2; exit 3", "refused answer.c:.*the end"),
}


@pytest.mark.parametrize("kind", some_quickly(BAD, every=3))
def test_compilers_that_go_wrong_end_in_one_error(folder: Path, kind: str) -> None:
    script, said = BAD[kind]
    compiler(folder, script)
    with pytest.raises(CompileError, match=f"(?s)cc {said}") as caught:
        answer(folder)
    assert len(str(caught.value)) < 4500 and cache_state().entries == 0


@pytest.mark.parametrize("first", ["-DODD", "-fno-such-option"])
def test_demanded_cleanliness_is_no_reason_for_weaker_options(
    folder: Path, monkeypatch: pytest.MonkeyPatch, first: str
) -> None:
    """A file that warns with the options of users is refused, though it is clean without; unknown options are left."""
    (folder / "answer.h").write_text("#define ANSWER 42\n#ifdef ODD\nstatic int unused;\n#endif\n")
    ways = ((first,), ())
    monkeypatch.setattr(compilers, "attempts", lambda flags, native: tuple((*FLAGS, *w, *flags) for w in ways))
    assert answer(folder, flags=["-Wall"]) == 42
    if first == "-DODD":
        with pytest.raises(CompileError, match="unused"):
            answer(folder, flags=["-Wall", "-Werror"])
    else:
        assert answer(folder, flags=["-Wall", "-Werror"]) == 42


def test_a_compiler_that_cannot_be_run(folder: Path) -> None:
    (folder / "bin" / "cc").write_bytes(b"\x7fELF of another machine")
    (folder / "bin" / "cc").chmod(0o755)
    with pytest.raises(CompileError, match="cc cannot be run"):
        answer(folder)


def test_a_compiler_that_hangs_is_ended_with_its_children(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compilers, "LIMIT", 0.3)
    compiler(folder, f"sleep 60 & echo $! > {folder}/child; wait")
    started = time.monotonic()
    with pytest.raises(CompileError, match=r"did not end within 0.3 s on answer.c"):
        answer(folder)
    assert time.monotonic() - started < 20
    child = int((folder / "child").read_text())
    for _ in range(100):  # until the system has noticed
        status = Path(f"/proc/{child}/stat")
        if not status.exists() or status.read_text().split()[2] == "Z":
            break
        time.sleep(0.02)
    else:
        pytest.fail("its child goes on")


@pytest.fixture(scope="module")
def found() -> Model:
    return only(model("four_bar"), "inverse_dynamics")


@pytest.mark.parametrize("kind", some_quickly(BAD, every=3))
def test_functions_run_in_casadi_where_the_compiler_goes_wrong(folder: Path, found: Model, kind: str) -> None:
    arrays = inputs(found, "inverse_dynamics", 5)
    expected = load(found, backend="casadi").inverse_dynamics(*arrays)
    compiler(folder, BAD[kind][0])
    with pytest.warns(RuntimeWarning, match="four_bar: its functions run in CasADi"):
        compiled = load(found)
    assert compiled.backend == "casadi" and np.array_equal(compiled.inverse_dynamics(*arrays), expected)
    for asked in ({"backend": "c"}, {"flags": ("-O1",)}, {"precision": "single"}, {"build_dir": folder}):
        with pytest.raises(CompileError):
            load(found, **asked)  # type: ignore[arg-type]


SCENE = """
[scene]
name = "swing"
mechanism = "four_bar"
duration = 0.05
rate = 100
"""


def test_a_run_goes_on_without_its_compiler(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    compiler(folder, "exit 1")
    (folder / "swing.toml").write_text(SCENE)
    assert main(["simulate", str(folder / "swing.toml")]) == 0
    shown = capsys.readouterr().out
    assert "completed" in shown and "evaluated on NumPy" in shown and "refused run.c" in shown


def test_the_second_run_of_a_scene_compiles_and_derives_nothing(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    compiler(folder, f'exec {REAL} "$@"')
    (folder / "swing.toml").write_text(SCENE)
    assert main(["simulate", str(folder / "swing.toml"), "--json"]) == 0
    first, count = capsys.readouterr().out, calls(folder)
    assert count > 0

    def never(*_: object, **options: object) -> None:
        raise AssertionError("derived or printed again")

    with monkeypatch.context() as changed:
        changed.setattr("symscrew.simulation.kept_model.derive", never)
        changed.setattr("symscrew.simulation.run_source.print_c", never)
        assert main(["simulate", str(folder / "swing.toml"), "--json"]) == 0
        assert capsys.readouterr().out == first and calls(folder) == count
        with pytest.raises(AssertionError, match="derived"):
            main(["simulate", str(folder / "swing.toml"), "--json", "--no-cache"])
    capsys.readouterr()
    assert main(["simulate", str(folder / "swing.toml"), "--json", "--no-cache"]) == 0
    assert capsys.readouterr().out == first and calls(folder) > count


@pytest.mark.slow
@pytest.mark.derived_anew
def test_other_effects_and_parameters_are_derived_again(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shown = []
    for gravity in ("-9.81", "-1.62", "-9.81"):
        effect = f'[[effects]]\ntype = "gravity"\nacceleration = [0, 0, "{gravity}"]\n'
        (folder / "swing.toml").write_text(SCENE + effect)
        assert main(["simulate", str(folder / "swing.toml"), "--json"]) == 0
        shown.append(capsys.readouterr().out)
    assert shown[0] == shown[2] != shown[1]


@pytest.mark.slow
@pytest.mark.derived_anew
def test_a_spoiled_derivation_is_made_again(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "swing.toml").write_text(SCENE)
    assert main(["simulate", str(folder / "swing.toml"), "--json"]) == 0
    first = capsys.readouterr().out
    for entry in (folder / "cache").iterdir():
        if not entry.name.startswith("lock"):
            entry.write_bytes(entry.read_bytes().replace(b"mul", b"add"))
    assert main(["simulate", str(folder / "swing.toml"), "--json"]) == 0
    assert capsys.readouterr().out == first


def test_the_command_says_and_clears(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["cache"]) == 0
    assert capsys.readouterr().out == f"{folder / 'cache'}: 0 entries, 0.0 MB\n"
    assert answer(folder) == 42
    assert main(["cache", "--json"]) == 0
    assert '"entries": 1,' in capsys.readouterr().out
    assert main(["cache", "--clear"]) == 0
    assert "removed 1 entries" in capsys.readouterr().out and cache_state().entries == 0
