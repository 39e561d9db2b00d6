"""A mobility result for people and programs: in words, as documents, as JSON values.

Mobility --in_words, typeset--> lines with formulas --documents--> text, Markdown, HTML, LaTeX
         --json_values--> numbers and exact forms
"""

from symscrew.mobility.findings.documents import mobility_latex, mobility_markdown, mobility_page, mobility_text
from symscrew.mobility.findings.in_words import key_figures, sections
from symscrew.mobility.findings.json_values import mobility_values
from symscrew.mobility.findings.typeset import formulas, mathml, signs_ahead

__all__ = [
    "formulas",
    "key_figures",
    "mathml",
    "mobility_latex",
    "mobility_markdown",
    "mobility_page",
    "mobility_text",
    "mobility_values",
    "sections",
    "signs_ahead",
]
