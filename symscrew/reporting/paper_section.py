"""Formulas for a paper as a section of a report: what `symscrew formulas` prints, with MathML for a browser.

mechanism --paper_formulas--> parts --sections--> headings, sentences, equations;  LaTeX -> MathML
"""

from __future__ import annotations

import re

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.paper_formulas import paper_formulas
from symscrew.reporting.blocks import Block, Section, Text
from symscrew.reporting.latex_mathml import mathml_of

LONGEST = 400  # letters of LaTeX of an equation that fits the width of a page


def formula_sections(mechanism: Mechanism) -> tuple[list[Section], dict[str, str]]:
    """The sections, and LaTeX -> MathML; none of a mechanism of which no chain leads to its platform."""
    try:
        paper = paper_formulas(mechanism)
    except DescriptionError:
        return [], {}
    made = [Section("Formulas", (Text("In names as an author gives them; symscrew formulas writes them as LaTeX."),))]
    known: dict[str, str] = {}
    for part in paper.parts:
        blocks: list[Block] = [Text(part.words)] if part.words else []
        known |= {latex: mathml_of(latex) for latex in re.findall(r"\$(.*?)\$", part.words)}
        if part.symbols:
            known |= {symbol: mathml_of(symbol) for symbol in part.symbols}
            blocks.append(Text("; ".join(f"${symbol}$: {words}" for symbol, words in part.symbols.items()) + "."))
        for formula in part.formulas:
            if len(formula.text) <= LONGEST:
                known[formula.text] = mathml_of(formula.text, block=True)
                blocks.append(Text(f"${formula.text}$", "formula"))
        left = [f for f in part.formulas if len(f.text) > LONGEST]
        if left:
            known |= {f.name: mathml_of(f.name) for f in left}
            names = ", ".join(f"${f.name}$" for f in left)
            blocks.append(Text(f"Too wide for a page, and in what symscrew formulas writes: {names}.", "note"))
        made.append(Section(part.title, tuple(blocks), level=3))
    return made, known
