"""Folders that somebody has changed: nothing in them is run, and no memory is written that is not ours.

Every attack leaves a mark if it works: a constructor in the C, a header that brings code, a library that lies about, a
CasADi file; and manifests that describe other arrays than the C has. A crash would end the process of the test.
"""

from __future__ import annotations

import copy
import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.batches import inputs, only
from support.model_states import model
from support.samples import some_quickly

from symscrew.errors import DescriptionError
from symscrew.export import OutputError
from symscrew.generation import generate
from symscrew.runtime import find_compiler, load
from symscrew.verification import check

pytestmark = pytest.mark.slow

needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
FUNCTIONS = ("velocity", "inverse_dynamics", "platform_jacobian")
NAME = "four_bar"
SOURCE = f"{NAME}_inverse_dynamics.c"  # one of those that are compiled
Content = dict[str, Any]


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("untrusted") / "out"
    generate(model(NAME).only(FUNCTIONS), place)
    return place


@pytest.fixture
def folder(written: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(written, tmp_path / "out"))


def works(folder: Path, **options: Any) -> None:
    """All functions give the model's values."""
    compiled = load(folder, **options)
    for name in FUNCTIONS:
        arrays = inputs(model(NAME), name, 3)
        expected = model(NAME)(name, *arrays)[0]
        *got, _ = compiled[name](*arrays, check=False)
        for a, b in zip(expected, got, strict=True):
            flat = b if b.ndim == 2 else np.moveaxis(b, 1, 2).reshape(3, -1)
            assert np.abs(a - flat).max() < 1e-12 * max(np.abs(a).max(), 1)


@needs_compiler
def test_a_folder_as_it_was_written(folder: Path) -> None:
    for options in ({}, {"trusted": True}, {"backend": "casadi"}, {}):
        works(folder, **options)


@needs_compiler
@pytest.mark.parametrize("change", ["constructor", "constant", "comment", "other file"])
def test_c_that_its_description_does_not_give_is_not_compiled(folder: Path, change: str) -> None:
    file = f"{NAME}_support.h" if change == "constant" else SOURCE
    mark, code = folder.parent / "mark", (folder / file).read_text()
    changed = {
        "constructor": f"{code}\n#ifndef ONCE\n#define ONCE\n#include <stdio.h>\n"  # the file is read twice
        f'__attribute__((constructor)) static void run(void) {{ fclose(fopen("{mark}", "w")); }}\n#endif\n',
        "constant": code.replace("= 9.81", "= 9.82", 1),
        "comment": f"/* a word more */\n{code}",
        "other file": '#include "/etc/passwd"\n',
    }[change]
    assert changed != code
    (folder / file).write_text(changed)
    for _ in range(2):  # the second time, the cache knows what the description gives
        with pytest.raises(OutputError, match=r"four_bar_\w+.[ch]: is not the code that mechanism.toml .*trusted=True"):
            load(folder, backend="c")
    assert not mark.exists()
    if change == "constructor":
        works(folder, trusted=True)
        assert mark.exists()  # the attack is one


@needs_compiler
def test_other_files_of_the_folder_bring_nothing_in(folder: Path) -> None:
    mark = folder.parent / "mark"
    attack = f'__attribute__((constructor)) static void run(void) {{ fclose(fopen("{mark}", "w")); }}\n'
    (folder / f"{NAME}.h").write_text(f"#include <stdio.h>\n{attack}{(folder / f'{NAME}.h').read_text()}")
    for name in ("math.h", "stddef.h", "string.h", "stdlib.h"):
        (folder / name).write_text("#error not yours\n")
    (folder / f"lib{NAME}.so").write_bytes(b"\x7fELF somebody else's")
    for name in ("numpy.py", "casadi.py", "symscrew.py", f"{NAME}_numpy.py", "sitecustomize.py"):
        (folder / name).write_text(f"open({str(mark)!r}, 'w').close()\n")
    works(folder)
    assert not mark.exists()


@pytest.mark.slow
def test_casadi_files_are_never_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """They can name a compiler's command or a library to load."""
    import casadi

    folder = tmp_path / "out"
    generate(model(NAME).only(FUNCTIONS), folder, ["casadi"])
    real = casadi.Function.load

    def load_own(path: str) -> Any:
        assert not str(path).startswith(str(folder)), "a file of the folder is deserialised"
        return real(path)

    monkeypatch.setattr(casadi.Function, "load", staticmethod(load_own))
    works(folder, backend="casadi")
    assert check(folder).ok
    casadi.Function("velocity", [casadi.SX.sym("x")], [1]).save(str(folder / "velocity.casadi"))
    (folder / "inverse_dynamics.casadi").write_bytes(b"junk")
    works(folder, backend="casadi")
    said = [line for line in check(folder).lines if "FAILED" in line]
    assert len(said) == 2 and all("casadi has other bytes" in line for line in said)


def widened(content: Content) -> None:
    """Results larger than what the C writes; so far nothing is lost."""
    port = content["functions"]["velocity"]["outputs"][0]
    port["shape"], port["labels"] = [64], [f"x{k}" for k in range(64)]


def narrowed(content: Content) -> None:
    """Results smaller than what the C writes: it writes beyond."""
    port = content["functions"]["velocity"]["outputs"][0]
    port["shape"], port["labels"] = [1], ["x"]


def shrunken_input(content: Content) -> None:
    port = content["functions"]["inverse_dynamics"]["inputs"][0]
    port["shape"], port["labels"] = [1], ["x"]


def fewer_outputs(content: Content) -> None:
    content["functions"]["velocity"]["outputs"] = []


def more_outputs(content: Content) -> None:
    extra = {**content["functions"]["velocity"]["outputs"][0], "name": "extra"}
    content["functions"]["velocity"]["outputs"].append(extra)


def fewer_inputs(content: Content) -> None:
    content["functions"]["inverse_dynamics"]["inputs"].pop()


def swapped(content: Content) -> None:
    functions = content["functions"]
    functions["velocity"], functions["inverse_dynamics"] = functions["inverse_dynamics"], functions["velocity"]


def reordered(content: Content) -> None:
    content["functions"]["inverse_dynamics"]["inputs"].reverse()


def single(content: Content) -> None:
    content["precision"] = "single"


def further(content: Content) -> None:
    content["functions"]["system"] = content["functions"]["velocity"]


def renamed(content: Content) -> None:
    content["mechanism"] = "five_bar"


MISFITS = (
    widened, narrowed, shrunken_input, fewer_outputs, more_outputs, fewer_inputs, swapped, reordered, single, further,
    renamed,
)  # fmt: skip


ATTACKS = (narrowed, fewer_outputs, fewer_inputs, swapped)  # with trusted=True, too, in `support.attacks`
CASES = [(change, trusted) for trusted in (False, True) for change in MISFITS if not (trusted and change in ATTACKS)]


@needs_compiler
@pytest.mark.parametrize(("change", "trusted"), CASES, ids=lambda value: getattr(value, "__name__", str(value)))
def test_a_manifest_that_does_not_fit_the_c(folder: Path, change: Callable[[Content], None], trusted: bool) -> None:
    content = json.loads((folder / "manifest.json").read_text())
    change(content)
    (folder / "manifest.json").write_text(json.dumps(content))
    ways = ("does not fit the C", "its functions are not those of", "it is of five_bar", "cannot be read", "is not the")
    said = "|".join(ways)
    with pytest.raises(OutputError, match=said):
        load(folder, trusted=trusted, backend=None if change is single else "c")


@needs_compiler
def test_c_of_another_version_is_refused(folder: Path) -> None:
    code = (folder / f"{NAME}_support.c").read_text()
    (folder / f"{NAME}_support.c").write_text(code.replace("_interface[", "_of_old["))
    with pytest.raises(OutputError, match="says nothing of the sizes of its arrays"):
        load(folder, trusted=True)


def deep(levels: int) -> Any:
    found: Any = []
    for _ in range(levels):
        found = [found]
    return found


JUNK = (
    None, 1, "text", [], {}, [[]], {"name": "q"}, True, 1e400, -1, deep(50),
    [{"name": "q", "shape": [-1], "unit": "1", "labels": [], "description": ""}],
    [{"name": "q", "shape": [2**40, 2**40], "unit": "1", "labels": [], "description": ""}],
    [{"name": "q", "shape": [1.5], "unit": "1", "labels": [], "description": ""}],
    [{"name": "q", "shape": [3, 3, 3], "unit": "1", "labels": [], "description": ""}],
    [{"name": "q", "shape": [2], "unit": ["1"] * 7, "labels": [], "description": ""}],
    [{"name": "q;", "shape": [2], "unit": "1", "labels": [], "description": ""}],
    [{"name": "q", "shape": [2], "unit": 7, "labels": 7, "description": ""}],
    [{"name": "q", "shape": [1], "unit": "1", "labels": [], "description": ""}] * 2,
)  # fmt: skip
PLACES = (
    ("mechanism",), ("functions",), ("functions", "velocity"), ("functions", "velocity", "inputs"),
    ("functions", "velocity", "outputs"), ("effects",), ("files",), ("independent",), ("targets",),
)  # fmt: skip


@pytest.mark.parametrize("trusted", some_quickly([False, True], every=2))
@pytest.mark.parametrize("place", PLACES, ids=".".join)
def test_junk_in_a_manifest_is_one_error(folder: Path, place: tuple[str, ...], trusted: bool) -> None:
    whole = json.loads((folder / "manifest.json").read_text())
    for junk in JUNK if place[0] in ("mechanism", "functions") else JUNK[:5]:
        content = copy.deepcopy(whole)
        inside = content
        for key in place[:-1]:
            inside = inside[key]
        inside[place[-1]] = junk
        (folder / "manifest.json").write_text(json.dumps(content))
        try:
            load(folder, trusted=trusted, backend="c" if trusted else "casadi")
        except (OutputError, DescriptionError):
            continue
        # what does not say which functions there are: no effects are effects, and files are not looked at
        assert place[0] in ("effects", "files", "targets", "independent"), junk


@needs_compiler
@pytest.mark.parametrize("name", ["mechanism.toml", "manifest.json", SOURCE])
def test_a_missing_file_is_one_error(folder: Path, name: str) -> None:
    (folder / name).unlink()
    with pytest.raises((OutputError, DescriptionError), match=name):
        load(folder)


@needs_compiler
def test_another_description_is_found(folder: Path) -> None:
    text = (folder / "mechanism.toml").read_text()
    changed = text.replace("mass = ", 'mass = "2" # ', 1)
    assert changed != text
    (folder / "mechanism.toml").write_text(changed)
    with pytest.raises(OutputError, match="is not the code that"):
        load(folder, backend="c")


@needs_compiler
def test_what_the_cache_says_of_a_folder_counts_for_these_bytes_only(folder: Path, tmp_path: Path) -> None:
    works(folder)
    other = Path(shutil.copytree(folder, tmp_path / "other"))
    works(other)
    (other / SOURCE).write_bytes((other / SOURCE).read_bytes() + b"\n")
    with pytest.raises(OutputError):
        load(other, backend="c")
    works(folder)


def test_selected_functions_are_found_again(tmp_path: Path) -> None:
    few = only(model(NAME), "velocity")
    generate(few, tmp_path / "few", ["casadi"])
    with pytest.raises(OutputError, match="its functions are not those of"):
        load(tmp_path / "few", backend="casadi")  # a manifest must say what was left out: `Model.only` does
    generate(few.only(["velocity"]), tmp_path / "said", ["casadi"])
    assert list(load(tmp_path / "said", backend="casadi").functions) == ["velocity"]
