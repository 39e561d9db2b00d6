"""Lines of generated code: none is too long, and a compiler reads what it would have read."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from support.model_states import model

from symscrew.export.line_width import MOST, STRINGS, within_width
from symscrew.generation.folder import render
from symscrew.generation.targets import TARGETS

GENERATED = Path(__file__).parents[2] / "generated"
CODE = {*STRINGS, "py", "st"}
DATA = {"mjcf", "urdf", "markdown", "casadi"}  # attributes, tables whose rows cannot be broken, no text
OTHERS = {"fmu", "reduced"}  # of the printers of C, an archive or with more functions, which take seconds
LONG = " + ".join(f"a_rather_long_name_{k}" for k in range(12))


def too_long(file: str, text: str) -> list[str]:
    return [f"{file}: {line}" for line in text.splitlines() if len(line) > MOST]


def test_no_line_of_the_repository_s_generated_code_is_too_long() -> None:
    files = [path for path in GENERATED.rglob("*") if path.suffix[1:] in CODE]
    assert len(files) > 20
    assert not [line for path in files for line in too_long(path.name, path.read_text("utf-8"))]


@pytest.mark.parametrize("target", sorted({*TARGETS} - DATA - OTHERS))
def test_no_line_of_any_target_is_too_long(target: str) -> None:
    found = model("four_bar").only(["inverse_dynamics", "drive_positions", "assemble"])
    code = {name: x.decode() for name, x in render(found, [target]).items() if name.rpartition(".")[2] in CODE}
    assert not [line for name, text in code.items() for line in too_long(name, text)]


def read(text: str) -> list[str]:
    """What a compiler of C reads: words, with lines behind backslashes and strings beside each other put together."""
    text = re.sub(r'"\s*"', "", text.replace("\\\n", " "))
    return re.sub(r"/\*.*?\*/", " ", text, flags=re.S).split()


@pytest.mark.parametrize(
    "text",
    [
        f"    const double x = {LONG};",
        f"    const double x = {LONG}; /* limb1 */",
        f"#if defined({LONG.replace(' + ', ') && defined(')})\nint a;\n#endif",
        f"#define A(x) \\\n    ({LONG} \\\n    + {LONG})\nint a;",
        f'const char *text = "{LONG}";\n',
        f"/* {LONG}\n   {LONG} */\nint a;",
        f"int a; /* {LONG} {LONG} */",
    ],
)
def test_a_compiler_reads_the_same(text: str) -> None:
    narrow = within_width("a.c", text)
    assert narrow != text and not too_long("", narrow)
    assert read(narrow) == read(text)
    assert narrow.count("/*") == text.count("/*") and within_width("a.c", narrow) == narrow


def test_what_is_narrow_or_no_code_stays() -> None:
    assert within_width("a.c", "int a;") == "int a;"
    assert within_width("a.json", f'"{LONG}"') == f'"{LONG}"'
