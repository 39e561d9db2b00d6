"""What mkdocs does besides: formulas become MathML while the pages are built, doctests become blocks of code.

So the pages ask the network for nothing and run no script for their formulas.
"""

from __future__ import annotations

import html
import re
from typing import Any

from latex2mathml.converter import convert
from markdown import Markdown
from markdown.extensions import Extension
from markdown.preprocessors import Preprocessor

FORMULA = re.compile(r'<(span|div) class="arithmatex">\\([(\[])(.*?)\\[)\]]</\1>', re.S)


class DoctestBlocks(Preprocessor):
    """Lines from `>>>` to the next empty one become a block of code."""

    def run(self, lines: list[str]) -> list[str]:
        """The lines with fences around doctests."""
        made: list[str] = []
        inside = False
        for line in lines:
            if not inside and line.lstrip().startswith(">>> "):
                inside = True
                made += ["", "```pycon"]
            elif inside and not line.strip():
                inside = False
                made.append("```")
            made.append(line)
        return [*made, "```"] if inside else made


class Doctests(Extension):
    """`DoctestBlocks` before fenced code is read."""

    def extendMarkdown(self, md: Markdown) -> None:  # noqa: N802
        """Register the preprocessor."""
        md.preprocessors.register(DoctestBlocks(md), "doctests", 40)


def on_config(config: Any) -> Any:
    """Add the extension for all pages and docstrings."""
    config["markdown_extensions"].append(Doctests())
    return config


def on_page_content(content: str, **_: Any) -> str:
    """Formulas as MathML."""
    return FORMULA.sub(_mathml, content)


def _mathml(found: re.Match[str]) -> str:
    kind = "inline" if found.group(1) == "span" else "block"
    return convert(html.unescape(found.group(3)), display=kind)
