"""Settings of all tests."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import SimpleNamespace

import pytest

from symscrew.runtime import compiled
from symscrew.simulation import native


@pytest.fixture(scope="session", autouse=True)
def compiled_quickly() -> Iterator[None]:
    """Loops of simulations are compiled with -O1: three times faster, for runs that take milliseconds.

    That levels of optimisation do not change results is what test_hard_generated_c tests.
    """
    with pytest.MonkeyPatch.context() as changed:
        changed.setattr(native, "NATIVE_FLAGS", (*native.NATIVE_FLAGS, "-O1"))
        yield


@pytest.fixture(scope="module", autouse=True)
def hard_cases_compiled_more_quickly(request: pytest.FixtureRequest, compiled_quickly: None) -> Iterator[None]:
    """Hard cases run for milliseconds, each with a loop of its own: compiling at -O0 takes half the time."""
    with pytest.MonkeyPatch.context() as changed:
        if request.path.parent.name == "hard":
            changed.setattr(native, "NATIVE_FLAGS", (*native.NATIVE_FLAGS, "-O0"))
        yield


@pytest.fixture(scope="session", autouse=True)
def compiled_once(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """The same sources with the same command are compiled once in a run of the tests, by whichever process is first."""
    own = tmp_path_factory.getbasetemp()
    store = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "libraries"
    store.mkdir(exist_ok=True)

    def run(command: Sequence[str], **options: object) -> subprocess.CompletedProcess[str]:
        library = Path(command[command.index("-o") + 1])
        kept = store / _fingerprint(command)
        if kept.is_file():
            shutil.copyfile(kept, library)
            return subprocess.CompletedProcess(command, 0, "", "")
        result = subprocess.run(command, **options)  # type: ignore[call-overload]
        if result.returncode == 0:
            partial = kept.with_name(f"{kept.name}.{os.getpid()}")
            shutil.copyfile(library, partial)
            partial.replace(kept)
        return result

    with pytest.MonkeyPatch.context() as changed:
        changed.setattr(compiled, "subprocess", SimpleNamespace(run=run))
        yield


def _fingerprint(command: Sequence[str]) -> str:
    """Of the command without the places of its files, and of the files that it may read beside its sources."""
    found = hashlib.sha256()
    for word in command:
        path = Path(word)
        found.update((path.name if path.is_absolute() and word != command[0] else word).encode() + b"\0")
        if path.suffix in (".c", ".cpp"):
            for beside in sorted(p for p in path.parent.iterdir() if p.suffix in (".c", ".h", ".hpp")):
                found.update(beside.name.encode() + b"\0" + beside.read_bytes())
    return found.hexdigest()
