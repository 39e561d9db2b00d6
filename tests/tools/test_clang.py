"""Clang: the same bits as single calls, blocks as vector code, limbs side by side as limb after limb."""

from __future__ import annotations

import platform
import shutil
from pathlib import Path

import pytest
from support.batches import EXACT, MACHINES, NAME, check_layouts, check_vector_code, only
from support.lanes import check_bits
from support.model_states import model

from symscrew.runtime import compilers
from symscrew.runtime.compiled import load

pytestmark = [pytest.mark.optimised, pytest.mark.skipif(shutil.which("clang") is None, reason="clang is not installed")]


# Of each form one; the bits of all functions are compared by gcc, and clang compiles more of them elsewhere.
FUNCTIONS = ("assemble", "joint_displacements", "inverse_dynamics", "forward_dynamics")


def test_clang_gives_the_same(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(compilers, "find_compiler", lambda: shutil.which("clang"))
    found = only(model(NAME), *FUNCTIONS)
    levels = {True: (), False: ("-O0",)}  # single calls as written
    both = [
        load(found, vectorised=blocks, flags=(*EXACT, *level), build_dir=tmp_path / str(blocks))
        for blocks, level in levels.items()
    ]
    check_layouts(found, *both)


@pytest.mark.skipif(platform.machine() != "x86_64", reason="the machines are x86-64")
@pytest.mark.parametrize("machine", MACHINES)
def test_blocks_are_vector_code_of_clang_too(tmp_path: Path, machine: str) -> None:
    check_vector_code(model(NAME), tmp_path, "clang", machine)


def test_limbs_side_by_side_equal_limb_after_limb_by_clang(tmp_path: Path) -> None:
    """Of one function: gcc compiles the others, of which the printed text is the same."""
    check_bits("planar_3rrr", "inverse_dynamics", tmp_path, "clang")
