"""Pinocchio beside a closed chain, in C++."""

from __future__ import annotations

import shutil
import sysconfig
from pathlib import Path

import pytest
from support.model_states import model

from symscrew.studies.benchmark import pinocchio_build
from symscrew.studies.benchmark.function_times import time_functions


@pytest.mark.slow
def test_inverse_dynamics_of_a_closed_chain_beside_pinocchio_in_cpp(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pinocchio")
    monkeypatch.setattr(pinocchio_build, "CPP_FLAGS", quickly_compiled())
    monkeypatch.setattr(pinocchio_build, "COMPILER", shutil.which("clang++") or "g++")  # half the time for templates
    rows, notes = time_functions(model("three_ups_upu_s_physical"), ["inverse_dynamics"], ["pinocchio"], repeats=1)
    others = [row for row in rows if row.variant.startswith("pinocchio")]
    assert not notes and len(others) == 2 and all(row.agreement < 1e-9 for row in others)


def quickly_compiled() -> tuple[str, ...]:
    """Agreement is tested here, not speed: what Pinocchio's library has compiled is not made again (24 s for 77)."""
    libraries = Path(sysconfig.get_path("purelib")) / "cmeel.prefix" / "lib"
    linked = ("-Wl,--no-as-needed", f"-L{libraries}", f"-Wl,-rpath,{libraries}", "-lpinocchio_default")
    return ("-O0", "-DNDEBUG", "-DWITHOUT_HEXAPODS", "-DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION", *linked)
