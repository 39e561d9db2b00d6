"""Formulas as a browser shows them: the same letters in the same order, fractions, roots and rows as written."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

import pytest

from symscrew import catalogue
from symscrew.export.markdown import _for_a_paper
from symscrew.paper_formulas import paper_formulas
from symscrew.reporting.latex_mathml import GREEK, mathml_of
from symscrew.reporting.paper_section import LONGEST, formula_sections

BY_LETTER = {chr(code): name for name, code in GREEK.items()}


def letters(markup: str) -> str:
    """Letters and digits in the order in which they are read."""
    text = "".join(ET.fromstring(markup).itertext())
    return "".join(BY_LETTER.get(c, c) if c.isalnum() else "" for c in text if c.isascii() or c in BY_LETTER)


def plain(latex: str) -> str:
    """The same of LaTeX."""
    text = re.sub(
        r"\\(begin|end)\{\w+\}|\\(boldsymbol|mathrm|operatorname|left|right|frac|sqrt|times|cdot|circ|dot|quad)\b",
        "",
        latex,
    )
    return re.sub(r"[^A-Za-z0-9]", "", text)


@pytest.mark.parametrize("name", ["planar_3rrr", "slider_crank", "bennett", "gear_train"])
def test_every_formula_reads_the_same(name: str) -> None:
    mechanism = catalogue.load(name)
    sections, known = formula_sections(mechanism)
    paper = paper_formulas(mechanism)
    assert [s.title for s in sections[1:]] == [part.title for part in paper.parts]
    for formula in paper.formulas:
        markup = known[formula.text if len(formula.text) <= LONGEST else formula.name]
        latex = formula.text if len(formula.text) <= LONGEST else formula.name
        assert letters(markup) == plain(latex), latex
        for command, element in ((r"\frac", "mfrac"), (r"\sqrt", "msqrt"), (r"\begin", "mtable")):
            assert len(list(ET.fromstring(markup).iter(element))) == latex.count(command), (latex, element)
        rows = len(list(ET.fromstring(markup).iter("mtr")))
        assert rows == latex.count(r"\begin") + latex.count(r"\\")
    text = "\n".join(_for_a_paper(mechanism))
    assert all(f"$$\n{formula.text}\n$$" in text for formula in paper.formulas)
    assert paper._repr_markdown_().count("$$") == 2 * len(paper.formulas)


@pytest.mark.parametrize(("latex", "expected"), [
    (r"\frac{1}{2} x", "<mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac><mi>x</mi>"),
    (r"c_{11}^{2}", "<msubsup><mi>c</mi><mrow><mn>11</mn></mrow><mrow><mn>2</mn></mrow></msubsup>"),
    (r"\theta_1", "<msub><mi>&#x3B8;</mi><mn>1</mn></msub>"),
    (r"\sqrt{a}", "<msqrt><mrow><mi>a</mi></mrow></msqrt>"),
    (r"\mathrm{half\_spacing}", '<mi mathvariant="normal">half_spacing</mi>'),
    (r"a < b \& c", "<mi>a</mi><mo>&lt;</mo><mi>b</mi><mo>&amp;</mo><mi>c</mi>"),
    (r"\begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix}", "".join((
        '<mrow><mo stretchy="true">(</mo><mtable><mtr><mtd><mn>1</mn></mtd><mtd><mn>2</mn></mtd></mtr>',
        '<mtr><mtd><mn>3</mn></mtd><mtd><mn>4</mn></mtd></mtr></mtable><mo stretchy="true">)</mo></mrow>'))),
])  # fmt: skip
def test_markup(latex: str, expected: str) -> None:
    assert mathml_of(latex) == f"<math>{expected}</math>"


@pytest.mark.parametrize(
    "broken",
    ["{", "}", r"\frac{1}", r"\begin{pmatrix} 1 \\", "_", "^{", r"\unknown{a}", "<script>", r"\sqrt", r"\mathrm{"],
)
def test_what_is_no_formula_ends_and_is_no_markup_of_others(broken: str) -> None:
    assert "<script" not in mathml_of(broken)
