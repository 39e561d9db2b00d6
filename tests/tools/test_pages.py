"""The pages of the documentation as MkDocs builds them."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from support.documentation import DOCS, PAGES, ROOT, identity


def test_pages_are_built_and_ask_the_network_for_nothing(tmp_path: Path) -> None:
    """`mkdocs build --strict`: every page, formulas as MathML, doctests as code, scripts and styles in the folder."""
    for needed in ("mkdocs", "mkdocstrings", "material", "latex2mathml"):
        pytest.importorskip(needed, reason='building the pages needs: pip install ".[docs]"')
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(tmp_path)]
    environment = {**os.environ, "NO_MKDOCS_2_WARNING": "1"}
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]
    texts = {page: (tmp_path / page).with_suffix(".html").read_text() for page in map(identity, PAGES)}
    for page, text in texts.items():
        assert not re.findall(r"<(?:script|link|img)[^>]*(?:src|href)=\"(?:https?:)?//", text), page
        outside = re.sub(r"<(pre|code|script)\b.*?</\1>", "", text, flags=re.S)
        assert not re.search(r"\\\(|\\\[|&gt;&gt;&gt;|arithmatex", outside), page
    formulas = len(re.findall(r"\\\(.*?\\\)|\$\$.*?\$\$", (DOCS / "theory.md").read_text(), re.S))
    assert texts["theory.md"].count("<math") == formulas > 30
