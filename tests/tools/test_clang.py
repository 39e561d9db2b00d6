"""Clang: the same bits as single calls, blocks as vector code, limbs side by side as limb after limb."""

from __future__ import annotations

import platform
import shutil
from pathlib import Path

import pytest
from support.batches import EXACT, MACHINES, NAME, check_layouts, check_vector_code, only
from support.lanes import CASES, check_bits
from support.model_states import model

from symscrew.runtime import compilers
from symscrew.runtime.compiled import load

pytestmark = [pytest.mark.optimised, pytest.mark.skipif(shutil.which("clang") is None, reason="clang is not installed")]


# Of each file one; the bits of all functions are compared by gcc, and clang compiles them all elsewhere.
FUNCTIONS = ("assemble", "joint_displacements", "velocity", "energy", "inverse_dynamics", "forward_dynamics")


def test_clang_gives_the_same(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(compilers, "find_compiler", lambda: shutil.which("clang"))
    found = only(model(NAME), *FUNCTIONS)
    both = [load(found, vectorised=blocks, flags=EXACT, build_dir=tmp_path / str(blocks)) for blocks in (True, False)]
    check_layouts(found, *both)


@pytest.mark.skipif(platform.machine() != "x86_64", reason="the machines are x86-64")
@pytest.mark.parametrize("machine", MACHINES)
def test_blocks_are_vector_code_of_clang_too(tmp_path: Path, machine: str) -> None:
    check_vector_code(model(NAME), tmp_path, "clang", machine)


@pytest.mark.parametrize(("name", "function"), CASES)
def test_limbs_side_by_side_equal_limb_after_limb_by_clang(name: str, function: str, tmp_path: Path) -> None:
    check_bits(name, function, tmp_path, "clang")
