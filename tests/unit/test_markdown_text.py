"""Texts of descriptions stand in Markdown as they are: nothing of them becomes markup."""

from __future__ import annotations

import re
import string

import pytest
from support import handmade

from symscrew.description.names import markdown_text
from symscrew.export.readme import print_readme
from symscrew.reporting.blocks import Bullets, Document, Picture, Section, Table, Text, markdown

HOSTILE = (
    "<script>alert(1)</script>", "![x](http://evil)", "[x](javascript:alert(1))", "a|b", "`code`", "**bold**", "_it_",
    "- item", "1. item", "# title", "===", "---", "> quote", "~~gone~~", "&lt;", "$x$", "http://evil", "www.evil.org",
    "a@evil.org", "a\nb", "\\", "<!-- -->", "+ plus", "12) item", "[x]: http://evil",
)  # fmt: skip


def shown(text: str) -> str:
    """Of Markdown without markup what is shown; fails on a mark that is not escaped."""
    plain, at = "", 0
    while at < len(text):
        escaped = text[at] == "\\" and text[at + 1 : at + 2] in string.punctuation and text[at + 1 : at + 2] != ""
        letter = text[at + escaped]
        inside = letter == "_" and plain[-1:].isalnum() and text[at + 1 : at + 2].isalnum()
        assert escaped or (letter not in "\\`*<>[]|~$&@" and (letter != "_" or inside)), (text, at)
        plain, at = plain + letter, at + 1 + escaped
    assert not re.match(r"[-+#=>]|\d+[.)]", text) and not re.search(r"(?<!\\)://|www\.", text), text
    return plain


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_texts_are_shown_as_they_are(text: str) -> None:
    for whole in (text, f"name {text}", f"{text} behind", text * 2):
        assert shown(markdown_text(whole)) == re.sub(r"\s+", " ", whole)


@pytest.mark.parametrize("text", ["planar crank-rocker, one driven crank", "limb1_S.qx, r = 0.3 m (A1..A4)"])
def test_what_is_plain_stays(text: str) -> None:
    assert markdown_text(text) == text


@pytest.mark.parametrize("text", HOSTILE)
def test_documents_and_folders_escape_them(text: str) -> None:
    table = Table((text, "b"), ((text, "1"),), caption=text)
    blocks = (Text(text), Bullets((text, "force $f$ along " + text)), table, Picture("p", b"", text))
    made, _ = markdown(Document(text, text, (Section(text, blocks),), {"f": "<math/>"}, text), "a (b)")
    escaped = markdown_text(text)
    lines = (
        f"# {escaped}",
        escaped,
        f"## {escaped}",
        f"- {escaped}",
        f"![{escaped}](a%20%28b%29_p.svg)",
        f"*{escaped}*",
    )
    assert set(lines) <= set(made.splitlines())
    assert len({len(re.findall(r"(?<!\\)\|", row)) for row in re.findall(r"(?m)^\|.*$", made)}) == 1
    assert "force $f$ along" in made and "<" not in made.replace("\\<", "")


def test_readme_of_a_folder_escapes_the_description() -> None:
    model = handmade.model()
    assert not any(mark in print_readme(model, {"c": "x"}).partition("## Files")[0] for mark in ("<", "[", "|"))
