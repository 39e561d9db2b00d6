"""How objects look in a notebook: tables and texts as HTML that any theme can colour. Needs no notebook.

names and values --table--> HTML      sentences --lines--> HTML      a page of its own --framed--> HTML
"""

from __future__ import annotations

import html
import sys
from collections.abc import Iterable, Sequence

FRAME = 560  # pixels of a page in a notebook: about half a screen
MOST_ROWS = 60  # of a table in a notebook: about two screens; what is cut off is said


def table(caption: str, header: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """A table with a caption; of long ones the first rows, and how many follow."""

    def cells(values: Iterable[object], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(str(value))}</{tag}>" for value in values) + "</tr>"

    shown = [cells(row, "td") for row in rows[:MOST_ROWS]]
    if len(rows) > MOST_ROWS:
        shown.append(f'<tr><td colspan="{len(header)}">... {len(rows) - MOST_ROWS} more</td></tr>')
    return (
        f'<table class="symscrew"><caption>{html.escape(caption)}</caption><thead>{cells(header, "th")}</thead>'
        f"<tbody>{''.join(shown)}</tbody></table>"
    )


def lines(title: str, sentences: Sequence[str]) -> str:
    """A title and sentences, each in a line of its own, as they are."""
    text = html.escape("\n".join(sentences))
    return f'<p><b>{html.escape(title)}</b></p><pre class="symscrew">{text}</pre>'


def framed(page: str, title: str, height: int = FRAME) -> str:
    """A whole page in a frame of its own, which can reach nothing outside itself: neither the notebook nor the network.

    `height` in pixels.
    """
    name = html.escape(title, quote=True)
    return (
        f'<iframe title="{name}" sandbox="allow-scripts allow-downloads" style="width:100%;height:{height}px;border:0" '
        f'srcdoc="{html.escape(page, quote=True)}"></iframe>'
    )


def here() -> bool:
    """Whether this process answers a notebook, which shows what it is handed itself."""
    return "ipykernel" in sys.modules
