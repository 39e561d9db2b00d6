"""Everything that is known to go wrong around this package, done for real: what comes of each.

    attack (name, what it does) --in a process of its own, within LIMIT--> outcome in a sentence

An attack makes a file by somebody else, or breaks what is around the program, and uses the program as a user does. It
gives a sentence on what came of it, or raises `WorkedError`. A crash, a hang, a traceback of any other kind and a mark
that was left (code of the attacker ran) are outcomes of their own, and bad ones.
"""

from __future__ import annotations

import faulthandler
import io
import json
import os
import re
import resource
import shutil
import signal
import tempfile
import time
import warnings
import zipfile
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.cli import main
from symscrew.errors import DescriptionError
from symscrew.export import OutputError, read_manifest
from symscrew.generation import folder as written
from symscrew.generation import generate, render
from symscrew.model import derive
from symscrew.runtime import CompileError, load
from symscrew.verification import check

LIMIT = 60  # seconds of the processor for an attack: the longest compile a few functions
PATIENCE = 300.0  # seconds by the clock: a machine may be busy with other things
FUNCTIONS = ("velocity", "inverse_dynamics", "forward_dynamics")
REFUSALS = (DescriptionError, OutputError, CompileError, TypeError)
Work = Callable[[Path], str]


class WorkedError(AssertionError):
    """An attack did what it wanted."""


@dataclass(frozen=True)
class Attack:
    """What is attacked, how, and what does it in an empty folder."""

    target: str
    name: str
    work: Work


@dataclass(frozen=True)
class Outcome:
    """Whether an attack was withstood, and what came of it."""

    attack: Attack
    withstood: bool
    text: str


ATTACKS: list[Attack] = []


def attack(target: str, name: str) -> Callable[[Work], Work]:
    """Put a function into the list."""

    def named(work: Work) -> Work:
        ATTACKS.append(Attack(target, name, work))
        return work

    return named


def carry_out(one: Attack) -> Outcome:
    """Do it in a process of its own."""
    with tempfile.TemporaryDirectory(prefix="symscrew_attack_") as temporary:
        place, (hears, says) = Path(temporary), os.pipe()
        child = os.fork()
        if child == 0:
            _child(one, place, says)
        os.close(says)
        end = time.monotonic() + PATIENCE
        while (ended := os.waitpid(child, os.WNOHANG))[0] == 0 and time.monotonic() < end:
            time.sleep(0.01)
        if ended[0] == 0:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            os.close(hears)
            return Outcome(one, False, f"HANGS: no end after {PATIENCE:.0f} s")
        status = os.waitstatus_to_exitcode(ended[1])
        with os.fdopen(hears, encoding="utf-8") as answer:
            text = answer.read()
        if (place / "mark").exists():
            return Outcome(one, False, "CODE OF THE ATTACKER RAN")
        if status == -signal.SIGXCPU:
            return Outcome(one, False, f"HANGS: no end after {LIMIT} s of the processor")
        if status != 0:
            return Outcome(one, False, text or f"CRASHED: signal or status {status}")
        return Outcome(one, True, text)


def _child(one: Attack, place: Path, says: int) -> None:
    status, text = 1, "ended by itself"
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT))
    faulthandler.disable()  # a crash is an outcome here
    try:
        with redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
            text = one.work(place)
        status = 0
    except WorkedError as error:
        text = f"WORKED: {error}"
    except BaseException as error:
        text = f"TRACEBACK: {type(error).__name__}: {error}"
    finally:
        os.write(says, " ".join(text.split())[:300].encode("utf-8", "replace"))
        os._exit(status)


def refused(work: Callable[[], object], *words: str) -> str:
    """The error that something ends in, which says one of some words."""
    try:
        found = work()
    except REFUSALS as error:
        text = " ".join(str(error).split())
        if words and not any(word in text for word in words):
            raise WorkedError(f"an error about something else: {text[:120]}") from error
        return f"refused: {_short(text)}"
    raise WorkedError(f"accepted: {found!r:.100}")


def command(*arguments: str | Path, expected: int = 2) -> str:
    """What a command says in its one line of error."""
    said = io.StringIO()
    with redirect_stderr(said):
        code = main([str(argument) for argument in arguments])
    text = said.getvalue()
    if code != expected or "Traceback" in text or (expected and text.count("\n") > 3):
        raise WorkedError(f"exit code {code}, {text[-200:]}")
    return f"exit code {code}: {_short(text.partition('error: ')[2] or text)}"


def _short(text: str) -> str:
    """The place of a file, which is another each time, is left out."""
    return re.sub(r"[^\s']*symscrew_attack_\w+/", "", " ".join(text.split()))[:110]


_MODELS: dict[str, Any] = {}


def four_bar() -> Any:
    """A small model, derived once."""
    if not _MODELS:
        _MODELS["four_bar"] = derive(catalogue.load("four_bar")).only(FUNCTIONS)
    return _MODELS["four_bar"]


def folder(place: Path, *targets: str) -> Path:
    """A folder as it was written."""
    generate(four_bar(), place / "out", targets)
    return place / "out"


def hostile_c(mark: Path) -> str:
    """C that leaves a mark when it is loaded."""
    return f'#include <stdio.h>\n__attribute__((constructor)) static void a(void) {{ fclose(fopen("{mark}", "w")); }}\n'


# -- folders of generated code ----------------------------------------------------------------------------


@attack("generated folder", "C with a constructor, load and check")
def _constructor(place: Path) -> str:
    out = folder(place, "c")
    code = min(out.glob("four_bar*.c"))
    code.write_text(hostile_c(place / "mark") + code.read_text())
    text = refused(lambda: load(out, backend="c"), "is not the code that")
    if check(out).ok:
        raise WorkedError("check says ok")
    return text


@attack("generated folder", "header and libraries that bring code in")
def _header(place: Path) -> str:
    out = folder(place, "c")
    (out / "four_bar.h").write_text(hostile_c(place / "mark") + (out / "four_bar.h").read_text())
    for name in ("math.h", "stddef.h", "libfour_bar.so"):
        (out / name).write_text("#error not yours\n")
    (out / "numpy.py").write_text(f"open({str(place / 'mark')!r}, 'w')\n")
    shutil.copy(out / "numpy.py", out / "casadi.py")
    load(out)
    os.chdir(out)
    check(out)
    return "not looked at: the code is made anew"


@attack("generated folder", ".casadi files of another function, and junk")
def _casadi(place: Path) -> str:
    import casadi

    out = folder(place, "casadi")
    loaded: list[str] = []
    real = casadi.Function.load
    casadi.Function.load = staticmethod(lambda path: (loaded.append(str(path)), real(path))[1])
    casadi.Function("velocity", [casadi.SX.sym("x")], [1]).save(str(out / "velocity.casadi"))
    (out / "inverse_dynamics.casadi").write_bytes(b"junk")
    load(out, backend="casadi")
    found = check(out)
    if found.ok or any(path.startswith(str(out)) for path in loaded):
        raise WorkedError(f"opened: {loaded}")
    return (
        "never opened; check: "
        + next(line for line in found.lines if "casadi has other" in line).split(": ", 2)[2][:80]
    )


def _misfit(change: Callable[[dict[str, Any]], object], place: Path) -> str:
    out = folder(place, "c")
    content = json.loads((out / "manifest.json").read_text())
    change(content["functions"])
    (out / "manifest.json").write_text(json.dumps(content))
    return refused(lambda: load(out, trusted=True), "does not fit the C", "cannot be read", "expected functions")


def _narrow(functions: dict[str, Any]) -> None:
    functions["forward_dynamics"]["outputs"][0] |= {"shape": [1], "labels": ["x"]}


def _swap(functions: dict[str, Any]) -> None:
    functions["velocity"], functions["inverse_dynamics"] = functions["inverse_dynamics"], functions["velocity"]


def _huge(functions: dict[str, Any]) -> None:
    functions["velocity"]["outputs"][0] |= {"shape": [2**40, 2**40], "labels": []}


MISFITS: dict[str, Callable[[dict[str, Any]], object]] = {
    "a result narrower than what the C writes": _narrow,
    "two functions exchanged": _swap,
    "an output less": lambda functions: functions["velocity"].update(outputs=[]),
    "an input less": lambda functions: functions["inverse_dynamics"]["inputs"].pop(),
    "2^80 results": _huge,
    "no shape": lambda functions: functions["velocity"]["inputs"][0].pop("shape"),
}
for _name, _change in MISFITS.items():
    attack("manifest, trusted=True", _name)(partial(_misfit, _change))


@attack("manifest", "lists nested 100,000 deep")
def _deep(place: Path) -> str:
    out = folder(place, "c")
    (out / "manifest.json").write_text("[" * 100_000)
    return refused(lambda: load(out), "not valid JSON")


@attack("manifest", "names files elsewhere as its own, and is generated over")
def _elsewhere(place: Path) -> str:
    out = folder(place, "c")
    (place / "precious.txt").write_text("keep")
    content = json.loads((out / "manifest.json").read_text())
    content["files"] += ["../precious.txt", str(place / "precious.txt")]
    (out / "manifest.json").write_text(json.dumps(content))
    folder(place, "numpy")
    if (place / "precious.txt").read_text() != "keep":
        raise WorkedError("the file is gone")
    return "only plain names in the folder count"


# -- archives ---------------------------------------------------------------------------------------------


def _archive(kind: str, shape: str, content: bytes, place: Path) -> str:
    text = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}".encode()
    with zipfile.ZipFile(place / "run.npz", "w", zipfile.ZIP_DEFLATED, compresslevel=1) as made:
        made.writestr("t.npy", b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text + content)
    resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))
    return command("view", place / "run.npz", "--out", place / "page.html")


PICKLE = b"\x80\x04cposix\nsystem\n(Vtouch mark\ntR."
ARCHIVES = {
    "0.5 GB of zeros in 0.5 MB": ("<f8", f"({1 << 26},)", bytes(1 << 29)),
    "a header that claims 2^45 numbers": ("<f8", f"({2**45},)", b""),
    "pickled objects": ("|O", "(1,)", PICKLE),
    "complex numbers": ("<c16", "(1,)", bytes(16)),
    "a header of 3000 brackets": ("<f8", "(" * 3000 + ")" * 3000, b""),
    "fewer numbers than its header says": ("<f8", "(100,)", bytes(8)),
}
for _name, _given in ARCHIVES.items():
    attack("archive (.npz)", _name)(partial(_archive, *_given))


# -- texts and numbers ------------------------------------------------------------------------------------

ARM = """[mechanism]
name = "{name}"
[bodies.bob]
mass = "{mass}"
com = [0, "0.3", 0]
[joints.hinge]
type = "R"
parent = "base"
child = "bob"
point = [0, 0, "{place}"]
axes = [[0, 1, 0]]
driven = true
"""
SOUND = {"name": "arm", "mass": "2", "place": "0.1"}


def _described(change: dict[str, str], place: Path) -> str:
    (place / "arm.toml").write_text(ARM.format(**SOUND | change))
    os.chdir(place)
    said = {command("mobility", place / "arm.toml"), command("generate", place / "arm.toml", "--out", place / "out")}
    if (place / "out").exists():
        raise WorkedError("something was written")
    return sorted(said)[0]


DESCRIPTIONS = {
    "a place of exp(700)": {"place": "exp(700)"},
    "sin(1)^2+cos(1)^2-1 as a coordinate": {"place": "sin(1)^2+cos(1)^2-1"},
    "1e-400 as a mass": {"mass": "1e-400"},
    "a product below the smallest double": {"mass": "1e-200*1e-150"},
    "1/0 as a mass": {"mass": "1/0"},
    "Python in a number": {"mass": "__import__('os').system('touch mark')"},
    "a power of powers": {"mass": "9^9^9^9"},
    "5000 brackets": {"mass": "(" * 5000 + "1" + ")" * 5000},
    "a name that is a path": {"name": "../../mark"},
    "a name that is C": {"name": "x; int main"},
}
for _name, _change_ in DESCRIPTIONS.items():
    attack("description", _name)(partial(_described, _change_))


@attack("description", "Markdown and HTML in a text")
def _markup(place: Path) -> str:
    text = ARM.format(**SOUND).replace(
        'name = "arm"', 'name = "arm"\ndescription = "<script>a</script> [x](http://y) |"'
    )
    (place / "arm.toml").write_text(text)
    command("generate", place / "arm.toml", "--out", place / "out", "--target", "numpy", expected=0)
    found = (place / "out" / "README.md").read_text()
    if "<script>" in found or "[x](" in found:
        raise WorkedError(found[:100])
    return "escaped: it stands there as it is"


BOMB = '<!DOCTYPE a [<!ENTITY b "bbbb">' + "".join(f'<!ENTITY b{k} "{f"&b{k - 1};" * 10}">' for k in range(2, 9)) + "]>"
XML = {
    "entities in entities": BOMB + "<robot name='a'>&b8;</robot>",
    "a file of the system": "<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/passwd'>]><robot name='a'>&b;</robot>",
    "5000 levels": "<a>" * 5000 + "</a>" * 5000,
    "an include of another file": "<mujoco><include file='/etc/passwd'/></mujoco>",
}


def _xml(text: str, place: Path) -> str:
    (place / "a.urdf").write_text(text)
    return command("mobility", place / "a.urdf")


for _name, _text in XML.items():
    attack("robot (XML)", _name)(partial(_xml, _text))


@attack("arrays", "complex numbers in a call")
def _complex(place: Path) -> str:
    model = four_bar()
    arrays = [array[0].astype(complex) + 1j for array in model.test_inputs["velocity"]]
    refused(lambda: load(model).velocity(*arrays), "real numbers")
    return refused(lambda: model("velocity", *arrays), "real numbers")


# -- what is around ---------------------------------------------------------------------------------------


def _compiler(script: str, place: Path) -> str:
    tools = place / "tools"
    tools.mkdir()
    for name in ("cc", "gcc", "clang"):
        (tools / name).write_text(f"#!/bin/sh\n{script}\n")
        (tools / name).chmod(0o755)
    os.environ |= {"PATH": f"{tools}:/usr/bin:/bin", "SYMSCREW_NO_CACHE": "1"}
    from symscrew.runtime import compilers

    compilers.LIMIT = compilers.ANSWER = 1.0
    text = refused(lambda: load(four_bar(), backend="c"))
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        instead = load(four_bar())
    if instead.backend != "casadi" or len(said) != 1:
        raise WorkedError(f"{instead}, {len(said)} notices")
    states = [array[0] for array in four_bar().test_inputs["velocity"]]
    if not np.allclose(instead.velocity(*states), four_bar()("velocity", *states)[0][0]):
        raise WorkedError("another result")
    return f"{text[:90]}; CasADi instead, with a notice"


COMPILERS = {
    "hangs": "sleep 100",
    "says nothing and writes nothing": "exit 0",
    "writes junk": 'while [ "$1" != -o ] && [ $# -gt 0 ]; do shift; done; echo junk >"$2"',
    "fails in Latin-1": r"printf 'Fehler f\374r \377\n' >&2; exit 1",
    "kills itself": "kill -9 $$",
}
for _name, _script in COMPILERS.items():
    attack("compiler", _name)(partial(_compiler, _script))


@attack("compiler", "is not there")
def _none(place: Path) -> str:
    os.environ["PATH"] = str(place)
    instead = load(four_bar())
    refused(lambda: load(four_bar(), backend="c"), "no C compiler")
    return f"runs in {instead.backend}; backend='c' is one error"


@attack("disk", "generate is killed at every step, over earlier output")
def _killed(place: Path) -> str:
    from .faults import content, killed_at

    out, new = folder(place, "c"), place / "new"
    generate(four_bar(), new, ("numpy",))
    old_content, new_content = content(out), content(new)
    shutil.rmtree(new)
    printed = {targets: render(four_bar(), targets) for targets in (("c",), ("numpy",))}
    written.render = lambda model, targets, **_: printed[tuple(targets)]  # once: printing is not what is attacked
    counts = {"old": 0, "new": 0}
    for step in range(500):
        was_killed = killed_at(lambda: generate(four_bar(), out, ("numpy",)), step)
        found = content(out)
        if found not in (old_content, new_content):
            raise WorkedError(f"step {step}: a mixture")
        counts["new" if found == new_content else "old"] += 1
        generate(four_bar(), out, ("c",))
        if content(out) != old_content or os.listdir(place) != ["out"]:
            raise WorkedError(f"step {step}: the next run does not clean up")
        if not was_killed:
            return (
                f"{step} kills: {counts['old']} times the old, {counts['new']} the new, 0 mixed; the next run cleans up"
            )
    raise WorkedError("no end")


@attack("disk", "full, at four sizes, while generate and draw write")
def _full(place: Path) -> str:
    from .faults import content, with_files_up_to

    out = folder(place, "c")
    (place / "a.png").write_bytes(b"old")
    before = content(place)

    def work() -> None:
        try:
            generate(four_bar(), out, ("c", "numpy"))
        except (OutputError, OSError) as error:
            if draws and main(["draw", "four_bar", "--out", str(place / "a.png")]) != 2:
                raise WorkedError("draw says that it is done") from error
        else:
            raise WorkedError("generate says that it is done")

    for size in (0, 1, 1000, 10_000):
        draws = size == 10_000  # a picture takes seconds
        if with_files_up_to(size, work) != 0:
            raise WorkedError(f"{size} bytes: no error in a sentence")
        if content(place) != before:
            raise WorkedError(f"{size} bytes: what was there has changed")
    return "one error each; what was there is there, nothing half written"


@attack("disk", "a folder that cannot be written")
def _read_only(place: Path) -> str:
    model = four_bar()
    generate(model, place / "before", ("c",))  # imports all that another user may not be able to read
    if os.getuid() == 0:
        place.chmod(0o755)  # of which others see nothing, usually
        (place / "x").mkdir(mode=0o555)
        os.setuid(65534)
    else:
        (place / "x").mkdir(mode=0o555)
    return refused(lambda: generate(model, place / "x" / "out", ("c",)), "cannot be written")


@attack("disk", "two runs of generate at once, five times")
def _two(place: Path) -> str:
    from .faults import content

    model, expected = four_bar(), []
    for targets in (("c",), ("numpy",)):
        generate(model, place / targets[0], targets)
        expected.append(content(place / targets[0]))
    children = []
    for targets in (("c",), ("numpy",)):
        if (child := os.fork()) == 0:
            try:
                for _ in range(5):
                    generate(model, place / "out", targets)
                os._exit(0)
            finally:
                os._exit(1)
        children.append(child)
    if any(os.waitpid(child, 0)[1] for child in children):
        raise WorkedError("one of them failed")
    if content(place / "out") not in expected:
        raise WorkedError("a mixture")
    return "one after the other; the folder is of the last"


@attack("sweep", "killed with -9 while its workers compute")
def _orphans(place: Path) -> str:
    from symscrew.workers import pool

    parent = os.fork()
    if parent == 0:
        with pool(3, "fork") as processes:
            list(processes.map(partial(_asleep, place), range(3)))
        os._exit(0)
    while len(list(place.glob("worker_*"))) < 3:
        time.sleep(0.01)
    workers = [int(path.name.partition("_")[2]) for path in place.glob("worker_*")]
    os.kill(parent, signal.SIGKILL)
    os.waitpid(parent, 0)
    end = time.monotonic() + 30
    while left := [worker for worker in workers if Path(f"/proc/{worker}").exists() and not _dead(worker)]:
        if time.monotonic() > end:
            raise WorkedError(f"{len(left)} orphans")
        time.sleep(0.01)
    return "3 workers, all gone with it"


def _asleep(place: Path, _: int) -> None:
    (place / f"worker_{os.getpid()}").touch()
    time.sleep(100)


def _dead(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] in "ZX"
    except OSError:
        return True


def _sweep(name: str, content: bytes, place: Path) -> str:
    (place / "map" / "pieces").mkdir(parents=True)
    (place / "map" / "pieces" / name).write_bytes(content)
    return command("workspace", "four_bar", "--over", "A=0:1:3", "--out", place / "map", "--processes", "1")


for _name, _content in (("manifest.json", b"[" * 100_000), ("manifest.json", b'{"plan": 1}'), ("thesis.tex", b"mine")):
    attack("sweep", f"{_name} of {_content[:10]!r} in its folder")(partial(_sweep, _name, _content))


@attack("mock-up unit", "calls in the wrong state, steps without end")
def _unit(place: Path) -> str:
    import ctypes

    from symscrew.fmu import build_unit
    from symscrew.scene import parse_scene

    text = '[scene]\nname = "swing"\nmechanism = "four_bar"\nduration = 0.5\nrate = 20\n'
    build_unit(parse_scene(text + '[integrator]\nmethod = "rk4"\nstep = 1e-3\n'), place / "swing.fmu")
    with zipfile.ZipFile(place / "swing.fmu") as archive:
        archive.extractall(place / "unit")
    library = ctypes.CDLL(str(next((place / "unit" / "binaries").rglob("*.so"))))
    token = (place / "unit" / "modelDescription.xml").read_text().partition('instantiationToken="')[2].partition('"')[0]
    make, step, no = library.fmi3InstantiateCoSimulation, library.fmi3DoStep, ctypes.c_bool(False)
    make.restype = ctypes.c_void_p
    one = ctypes.c_void_p(make(b"a", token.encode(), b"", no, no, no, no, None, ctypes.c_size_t(0), None, None, None))
    places = [ctypes.byref(ctypes.c_double()) for _ in range(4)]
    codes = [step(one, ctypes.c_double(0), ctypes.c_double(0.01), no, *places), library.fmi3Terminate(one)]
    codes += [library.fmi3ExitInitializationMode(one), library.fmi3SetFMUState(one, None), library.fmi3Terminate(None)]
    zero = ctypes.c_double(0)
    sound = [
        library.fmi3EnterInitializationMode(one, no, zero, zero, no, zero),
        library.fmi3ExitInitializationMode(one),
    ]
    codes += [step(one, zero, ctypes.c_double(x), no, *places) for x in (0, -1, float("nan"), float("inf"), 1e300)]
    if set(codes) != {3} or set(sound) != {0}:
        raise WorkedError(f"statuses {codes}, {sound}")
    return f"{len(codes)} calls refused with fmi3Error"


@attack("folder", "an interrupted writing, forged with a link to elsewhere")
def _forged(place: Path) -> str:
    out = folder(place, "c")
    (place / "precious").mkdir()
    (place / "precious" / "a.txt").write_text("keep")
    (out / ".pending").symlink_to(place / "precious")
    read_manifest(out)
    if not (place / "precious" / "a.txt").exists():
        raise WorkedError("moved")
    return "links are not followed"


def every_attack() -> list[Outcome]:
    """All of them."""
    four_bar()
    return [carry_out(one) for one in ATTACKS]
