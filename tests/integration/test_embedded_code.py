"""Code for microcontrollers: what must not stand in it, and what is said when the tools for it are missing."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from support.marks import slow
from support.model_states import model

from symscrew.cli.parser import main
from symscrew.errors import DescriptionError
from symscrew.export.c import print_source
from symscrew.verification.embedded import emulation
from symscrew.verification.embedded.emulation import EmbeddedError, measure


def test_missing_tools_are_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture, tmp_path: Path
) -> None:
    monkeypatch.setattr(emulation.shutil, "which", lambda tool: None)
    with pytest.raises(EmbeddedError, match="apt install gcc-arm-none-eabi and libnewlib-arm-none-eabi"):
        measure(model("four_bar"), "m4f")
    assert main(["embedded", "four_bar", "--out", str(tmp_path / "no.json")]) == 1
    assert "qemu-system-arm" in capsys.readouterr().err and not list(tmp_path.iterdir())
    (tmp_path / "file").touch()
    assert main(["embedded", "four_bar", "--out", str(tmp_path / "file" / "no.json")]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and "there is no folder" in said  # before anything is derived or measured
    with pytest.raises(DescriptionError, match="expected a core among m4f, m7"):
        measure(model("four_bar"), "m0")


def test_a_library_that_is_missing_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fake = tmp_path / emulation.COMPILER
    fake.write_text("#!/bin/sh\necho 'four_bar.c:1:10: fatal error: math.h: No such file or directory' >&2\nexit 1\n")
    fake.chmod(0o755)
    for tool in (emulation.NAMES, emulation.EMULATOR):
        (tmp_path / tool).symlink_to(fake)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    with pytest.raises(EmbeddedError, match=r"refused .apt install gcc-arm-none-eabi and libnewlib-arm-none-eabi.: "):
        measure(model("four_bar"), "m4f", functions=["mass_matrix"])


@pytest.mark.parametrize("name", ["four_bar", slow("three_ups_upu_s_physical"), "ur5"])
def test_no_heap_no_recursion_bounded_loops(name: str) -> None:
    source = re.sub(r'/\*.*?\*/|"[^"]*"', "", print_source(model(name)), flags=re.DOTALL)
    assert not re.search(r"\b(malloc|calloc|realloc|free|alloca|goto|while|setjmp|printf)\b", source)
    assert not re.search(r"^ +(?:double|int) [^=;]*\[[^]]*[a-z]", source, re.MULTILINE), "an array of variable length"
    bodies = re.findall(r"^[\w ]*?\*?(\w+)\(([^;{}]*)\)\n\{\n(.*?)^\}", source, re.M | re.S)
    assert len(bodies) > 20
    order = {function: k for k, (function, _, _) in enumerate(bodies)}
    for function, _, body in bodies:
        called = {other for other in re.findall(r"\b(\w+)\(", body) if other in order}
        assert all(order[other] < order[function] for other in called), f"{function} calls itself or what follows"
        for head in re.findall(r"\bfor \((.*?)\) \{", body):
            first, condition, step = head.split(";")
            counter = re.match(r"(?:size_t|int) (\w+)|(\w+)", first.strip())
            assert counter and re.search(r"[<>]", condition) and re.search(r"\+\+|--|\+=|\*=", step), head
