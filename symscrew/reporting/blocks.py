"""A document as headings and blocks, printed as one HTML file that asks the network for nothing, or as Markdown."""

from __future__ import annotations

import base64
import html
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib import resources
from pathlib import Path
from typing import TypeAlias
from urllib.parse import quote

from symscrew import notebook
from symscrew.description import markdown_text
from symscrew.errors import DescriptionError, shorten
from symscrew.whole_files import replaced

SHORT = 20  # rows of a table that is printed on one page


@dataclass(frozen=True)
class Text:
    """A paragraph; formulas between dollar signs."""

    text: str
    kind: str = "p"


@dataclass(frozen=True)
class Bullets:
    """Facts, one a line; formulas between dollar signs. `kind`: "warning" stands out."""

    lines: tuple[str, ...]
    kind: str = ""


@dataclass(frozen=True)
class Table:
    """Rows of cells; `numbers`: columns that hold numbers and stand to the right. `caption` stands above."""

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    numbers: frozenset[int] = frozenset()
    caption: str = ""


@dataclass(frozen=True)
class Picture:
    """A picture, SVG or PNG; `width` is its share of the line in per cent."""

    name: str
    data: bytes
    caption: str
    suffix: str = ".svg"
    width: int = 100


Block: TypeAlias = Text | Bullets | Table | Picture


@dataclass(frozen=True)
class Section:
    """A heading, level 2 or 3, and what stands below it."""

    title: str
    blocks: tuple[Block, ...]
    level: int = 2


@dataclass(frozen=True)
class Document:
    """Title, subtitle and sections; `formulas` gives the MathML of every LaTeX text between dollar signs."""

    title: str
    subtitle: str
    sections: tuple[Section, ...]
    formulas: Mapping[str, str] = field(default_factory=dict)
    footer: str = ""

    def __repr__(self) -> str:
        count = len(self.sections)
        return f"Document({self.title}: {count} section{'s' * (count != 1)})"

    def save(self, path: str | Path) -> Path:
        """Write .html, one file, or .md with its pictures beside it; see `write_document`."""
        return write_document(self, path)[-1]

    def _repr_html_(self) -> str:
        return notebook.framed(page(self), self.title)


def write_document(document: Document, path: str | Path) -> list[Path]:
    """Write the document: .html as one file, .md with its pictures beside it; whole or not at all.

    Raises:
        DescriptionError: another ending.
        OSError: a place that cannot be written.
    """
    file = Path(path)
    if file.suffix not in (".html", ".md"):
        raise DescriptionError(f"--out: expected a file name that ends in .html or .md, got {shorten(str(path))}")
    if file.suffix == ".html":
        return [_written(file, page(document).encode())]
    text, pictures = markdown(document, file.stem)
    return [*(_written(file.with_name(name), data) for name, data in pictures.items()), _written(file, text.encode())]


def _written(file: Path, data: bytes) -> Path:
    return replaced(file, lambda part: part.write_bytes(data))


# -- HTML -------------------------------------------------------------------------------------------------


def page(document: Document) -> str:
    """The document as one HTML page: no scripts, style and pictures inside, formulas as MathML."""
    style = resources.files("symscrew.reporting").joinpath("style.css").read_text(encoding="utf-8")
    title = html.escape(document.title)
    lines = [
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
        'img-src data:">',
        f"<title>{title}</title>\n<style>\n{style}</style></head>\n<body>\n<header><h1>{title}</h1>",
        f"<p>{html.escape(document.subtitle)}</p></header>",
        "<nav><ol>",
        *(
            f'<li><a href="#{_anchor(s.title)}">{html.escape(s.title)}</a></li>'
            for s in document.sections
            if s.level == 2
        ),
        "</ol></nav>",
    ]
    for k, section in enumerate(document.sections):
        if section.level == 2:
            lines.append(("</section>\n" if k else "") + f'<section id="{_anchor(section.title)}">')
        lines.append(f"<h{section.level}>{html.escape(section.title)}</h{section.level}>")
        lines += [_html_block(block, document.formulas) for block in section.blocks]
    lines.append(f"</section>\n<footer>{html.escape(document.footer)}</footer>\n</body></html>\n")
    return "\n".join(lines)


def _anchor(title: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")


def _with_formulas(text: str, formulas: Mapping[str, str], words: Callable[[str], str]) -> str:
    pieces = re.split(r"\$(.*?)\$", text)
    return "".join(formulas.get(p, words(f"${p}$")) if k % 2 else words(p) for k, p in enumerate(pieces))


def _html_block(block: Block, formulas: Mapping[str, str]) -> str:
    def inline(text: str) -> str:
        return _with_formulas(text, formulas, html.escape)

    if isinstance(block, Text):
        return f'<p class="{block.kind}">{inline(block.text)}</p>'
    if isinstance(block, Bullets):
        kind = f' class="{block.kind}"' if block.kind else ""
        return f"<ul{kind}>\n" + "\n".join(f"<li>{inline(line)}</li>" for line in block.lines) + "\n</ul>"
    if isinstance(block, Picture):
        if block.suffix == ".svg":
            inside = block.data.decode()
            inside = inside[inside.index("<svg") :]
        else:
            inside = f'<img alt="{html.escape(block.caption)}" src="data:image/png;base64,{_base64(block.data)}">'
        return f'<figure style="width:{block.width}%">{inside}<figcaption>{inline(block.caption)}</figcaption></figure>'
    return _html_table(block, inline)


def _base64(data: bytes) -> str:
    return base64.b64encode(data).decode("ascii")


def _html_table(table: Table, inline: Callable[[str], str]) -> str:
    def row(cells: Sequence[str], tag: str) -> str:
        made = (
            f"<{tag}{' class=number' if k in table.numbers else ''}>{inline(cell)}</{tag}>"
            for k, cell in enumerate(cells)
        )
        return "<tr>" + "".join(made) + "</tr>"

    caption = f"<caption>{inline(table.caption)}</caption>" if table.caption else ""
    head = f"<thead>{row(table.header, 'th')}</thead>" if any(table.header) else ""
    body = "\n".join(row(cells, "td") for cells in table.rows)
    whole = " whole" if len(table.rows) <= SHORT else ""
    return f'<div class="wide{whole}"><table>{caption}{head}<tbody>\n{body}\n</tbody></table></div>'


# -- Markdown ---------------------------------------------------------------------------------------------


def markdown(document: Document, stem: str) -> tuple[str, dict[str, bytes]]:
    """(Markdown text, file name -> data of its pictures); texts stand as they are, formulas between dollar signs."""

    def inline(text: str) -> str:
        return _with_formulas(text, {latex: f"${latex}$" for latex in document.formulas}, markdown_text)

    lines, pictures = [f"# {inline(document.title)}", "", inline(document.subtitle), ""], {}
    for section in document.sections:
        lines += ["#" * section.level + f" {inline(section.title)}", ""]
        for block in section.blocks:
            if isinstance(block, Text):
                lines += [inline(block.text), ""]
            elif isinstance(block, Bullets):
                lines += [*(f"- {inline(line)}" for line in block.lines), ""]
            elif isinstance(block, Picture):
                name = f"{stem}_{block.name}{block.suffix}"
                pictures[name] = block.data
                lines += [f"![{inline(block.caption)}]({quote(name)})", "", f"*{inline(block.caption)}*", ""]
            else:
                caption = [inline(block.caption), ""] if block.caption else []
                lines += [*caption, *_markdown_table(block, inline), ""]
    return "\n".join([*lines, inline(document.footer), ""]), pictures


def _markdown_table(table: Table, inline: Callable[[str], str]) -> list[str]:
    def row(cells: Sequence[str]) -> str:
        return "| " + " | ".join(re.sub(r"(?<!\\)\|", r"\\|", inline(cell)) for cell in cells) + " |"

    rule = "|" + "|".join("---:" if k in table.numbers else "---" for k in range(len(table.header))) + "|"
    return [row(table.header), rule, *(row(cells) for cells in table.rows)]
