"""The formulas of the field's counts and the letters of screws, typed once between dollar signs: as LaTeX and MathML.

"$d (n - g - 1) + sum f = 3$" --words, numbers, signs--> d (n - g - 1) + \\sum f = 3, <math>...</math>
"""

from __future__ import annotations

import re
from collections.abc import Iterable

WORDS = {
    "sum f": (r"\sum f", "<mo>&#x2211;</mo><mi>f</mi>"),
    "S_Gi": ("S_{G_i}", "<msub><mi>S</mi><msub><mi>G</mi><mi>i</mi></msub></msub>"),
    "S_F": ("S_F", "<msub><mi>S</mi><mi>F</mi></msub>"),
    "lambda": (r"\lambda", "<mi>&#x3BB;</mi>"),
    "nu": (r"\nu", "<mi>&#x3BD;</mi>"),
    "zeta": (r"\zeta", "<mi>&#x3B6;</mi>"),
    "omega": (r"\omega", "<mi>&#x3C9;</mi>"),
    "*": (r"\cdot", "<mo>&#x22C5;</mo>"),
    "-": ("-", "<mo>&#x2212;</mo>"),
}
"""What is typed -> (LaTeX, MathML) where these are not the letter itself."""
BRACKETS = {"(": "prefix", ")": "postfix"}
TWIST, WRENCH = "$(omega ; v)$", "$(f ; m)$"
PARTS = re.compile(r"sum f|S_Gi|S_F|lambda|nu|zeta|omega|\d+|\S")


def in_latex(line: str) -> str:
    """A line with its typed formulas as LaTeX.

    >>> in_latex("connectivity $S_Gi = 6 - nu$")
    'connectivity $S_{G_i} = 6 - \\\\nu$'
    """
    return re.sub(r"\$(.*?)\$", lambda found: f"${_latex(found[1])}$", line)


def typed_counts(lines: Iterable[str]) -> dict[str, str]:
    """LaTeX of every formula of the typed lines -> as it is typed."""
    return {_latex(typed): typed for line in (*lines, TWIST, WRENCH) for typed in line.split("$")[1::2]}


def counts_as_mathml(lines: Iterable[str]) -> dict[str, str]:
    """LaTeX of every formula of the typed lines -> MathML."""
    return {latex: f"<math>{_mathml(typed)}</math>" for latex, typed in typed_counts(lines).items()}


def _latex(typed: str) -> str:
    return PARTS.sub(lambda part: WORDS.get(part[0], (part[0],))[0], typed)


def _mathml(typed: str) -> str:
    parts = PARTS.findall(typed)
    return "".join(_element(part, "" if k == 0 else parts[k - 1]) for k, part in enumerate(parts))


def _element(part: str, before: str) -> str:
    if part == "-" and before in ("", "=", "("):
        return '<mo form="prefix">&#x2212;</mo>'
    if part in BRACKETS:
        return f'<mo form="{BRACKETS[part]}" stretchy="false">{part}</mo>'
    if part in WORDS:
        return WORDS[part][1]
    kind = "mn" if part.isdigit() else "mi" if part.isalpha() else "mo"
    return f"<{kind}>{part}</{kind}>"
