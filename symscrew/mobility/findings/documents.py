"""A mobility result as a document: plain text, Markdown, an HTML page, LaTeX.

sections in words, formulas in LaTeX --one function a kind of document--> text of the document
"""

from __future__ import annotations

import html
import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from symscrew.description import markdown_text
from symscrew.mobility.findings.in_words import key_figures, sections
from symscrew.mobility.findings.short_text import plain_lines, shortened
from symscrew.mobility.findings.typeset import formulas, typed_formulas

if TYPE_CHECKING:
    from symscrew.mobility.analysis import Mobility


STYLE = (
    "body{font:17px/1.45 'Latin Modern Roman','STIX Two Text',Georgia,serif;max-width:46em;margin:2.5em auto}"
    "h1{font-size:1.5em;font-weight:normal}h2{font-size:1.1em;margin:1.3em 0 .3em}ul{margin:.2em 0;padding-left:1.3em}"
    "table{border-collapse:collapse;border-top:1.5px solid;border-bottom:1.5px solid}td{padding:.1em .8em}"
    "td+td{text-align:right}math{font-size:1.05em}li span{white-space:nowrap}"
)


MINUS = re.compile(r"(?<![\w.)])(?<!= )-(?=\d)")
"""A minus before a number, not the hyphen of 3-RRR or of 1e-9, nor that of `q = -0.1`, which stands as it was typed."""
TUPLE = re.compile(r"\([^\s()]+,(?: [^\s()]+[,;]){1,4} [^\s()]+\)")
"""Numbers in brackets, a point or a screw, which stay on one line."""


def mobility_text(found: Mobility, *, full: bool = True) -> str:
    """Plain text, one line a fact; formulas as they are typed.

    Args:
        found: the result.
        full: everything; else at most `SHORT` letters, with long lines and lists cut, which is said where it is.
    """
    typed = typed_formulas(found)
    said = [(heading, [_with(fact, typed, str) for fact in facts]) for heading, facts in sections(found)]
    return "\n".join(plain_lines(said) if full else shortened(said))


def mobility_markdown(found: Mobility) -> str:
    """A Markdown document with formulas between dollar signs."""
    lines = [f"# Mobility of {found.mechanism.name}", ""]
    if found.mechanism.source:
        lines += [markdown_text(found.mechanism.source), ""]
    lines += ["| | |", "|---|---|", *(f"| {what} | {value} |" for what, value in key_figures(found)), ""]
    for heading, facts in sections(found):
        lines += [f"## {heading}", "", *(f"- {fact}" for fact in facts), ""]
    return "\n".join(lines)


def mobility_page(found: Mobility) -> str:
    """An HTML page without scripts: formulas as MathML, which browsers render."""
    name = html.escape(found.mechanism.name)
    source = html.escape(found.mechanism.source)
    parts = [f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>Mobility of {name}</title>',
             f"<style>{STYLE}</style>",
             f"</head><body>\n<h1>Mobility of {name}</h1>",
             f"<p>{html.escape(found.mechanism.description)}<br><i>{source}</i></p>", "<table>"]  # fmt: skip
    parts += [
        f"<tr><td>{html.escape(what)}</td><td>{_html_words(value)}</td></tr>" for what, value in key_figures(found)
    ]
    parts.append("</table>")
    known = formulas(found)
    for heading, facts in sections(found):
        parts.append(f"<h2>{html.escape(heading)}</h2>\n<ul>")
        parts += [f"<li>{_with(fact, known, _html_words)}</li>" for fact in facts]
        parts.append("</ul>")
    return "\n".join([*parts, "</body></html>\n"])


def _with(fact: str, formulas: dict[str, str], words: Callable[[str], str]) -> str:
    """A line with its formulas replaced and its words written in their way."""
    pieces = re.split(r"\$(.*?)\$", fact)
    return "".join(formulas.get(p, words(p)) if k % 2 else words(p) for k, p in enumerate(pieces))


def mobility_latex(found: Mobility) -> str:
    """A LaTeX document of the report, in outlines where that font is installed, lines of joint names not stretched."""
    lines = [r"\documentclass{article}", r"\usepackage[T1]{fontenc}", r"\usepackage{amsmath}",
             r"\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}",
             r"\usepackage[margin=28mm]{geometry}", r"\setlength{\emergencystretch}{3em}",
             r"\raggedright", r"\begin{document}",
             rf"\section*{{Mobility of {_escaped(found.mechanism.name)}}}"]  # fmt: skip
    about = (_escaped(found.mechanism.description), rf"\emph{{{_escaped(found.mechanism.source)}}}")
    said = (found.mechanism.description, found.mechanism.source)
    lines += [r" \\ ".join(text for text, given in zip(about, said, strict=True) if given)]
    lines += [r"\begin{center}\begin{tabular}{lr}\hline"]
    lines += [rf"{_escaped(what)} & {_escaped(value)} \\" for what, value in key_figures(found)]
    lines += [r"\hline\end{tabular}\end{center}"]
    for heading, facts in sections(found):
        lines += [rf"\subsection*{{{_escaped(heading)}}}", r"\begin{itemize}\setlength{\itemsep}{0pt}"]
        for fact in facts:
            pieces = re.split(r"(\$.*?\$)", fact)
            lines.append(r"\item " + "".join(p if p.startswith("$") else _escaped(p) for p in pieces))
        lines.append(r"\end{itemize}")
    return "\n".join([*lines, r"\end{document}", ""])


def _escaped(words: str) -> str:
    marks = {"\\": r"\textbackslash{}", "^": r"\^{}", "~": r"\~{}", "|": r"\textbar{}", "<": r"\textless{}"}
    escaped = "".join(marks.get(c, "\\" + c if c in "_%&#${}" else c) for c in words)
    return TUPLE.sub(r"\\mbox{\g<0>}", MINUS.sub("$-$", escaped))


def _html_words(words: str) -> str:
    escaped = MINUS.sub("\N{MINUS SIGN}", html.escape(words))
    return TUPLE.sub(r"<span>\g<0></span>", escaped)
