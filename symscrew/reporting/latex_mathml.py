r"""MathML of the formulas that the package prints in LaTeX: a browser shows them without any library.

LaTeX of `symscrew.paper_formulas` --words, groups--> MathML. Read are numbers, letters with indices, greek letters,
`\mathrm`, `\boldsymbol`, `\frac`, `\sqrt`, powers, sums, products, `\times`, `\cdot`, functions and matrices.
"""

from __future__ import annotations

import html
import re
from collections.abc import Mapping

TOKEN = re.compile(r"\\begin\{\w+\}|\\end\{\w+\}|\\[A-Za-z]+|\\[^A-Za-z]|[0-9]+(?:\.[0-9]+)?|[A-Za-z]|\S")
SIGNS: Mapping[str, str] = {
    r"\times": "&#xD7;", r"\cdot": "&#xB7;", r"\circ": "&#x2218;", "-": "&#x2212;", r"\quad": "&#x2003;",
    r"\,": "&#x2009;", r"\partial": "&#x2202;", r"\sum": "&#x2211;",
}  # fmt: skip
GREEK: Mapping[str, int] = {
    "alpha": 0x3B1, "beta": 0x3B2, "gamma": 0x3B3, "delta": 0x3B4, "epsilon": 0x3B5, "varepsilon": 0x3B5, "zeta": 0x3B6,
    "eta": 0x3B7, "theta": 0x3B8, "iota": 0x3B9, "kappa": 0x3BA, "lambda": 0x3BB, "mu": 0x3BC, "nu": 0x3BD, "xi": 0x3BE,
    "pi": 0x3C0, "rho": 0x3C1, "sigma": 0x3C3, "tau": 0x3C4, "upsilon": 0x3C5, "phi": 0x3D5, "varphi": 0x3C6,
    "chi": 0x3C7, "psi": 0x3C8, "omega": 0x3C9,
}  # fmt: skip
FUNCTIONS = ("sin", "cos", "tan", "arcsin", "arccos", "arctan", "exp", "log", "diag")
MATRICES: Mapping[str, tuple[str, str]] = {"pmatrix": ("(", ")"), "bmatrix": ("[", "]")}


def mathml_of(latex: str, *, block: bool = False) -> str:
    """A formula as MathML; what is not read stands as it is written."""
    reader = _Reader([token[0] for token in TOKEN.finditer(latex)])
    return f"<math{' display=' + chr(34) + 'block' + chr(34) if block else ''}>{reader.run()}</math>"


class _Reader:
    """The tokens of a formula, one after the other."""

    def __init__(self, tokens: list[str]) -> None:
        self.tokens, self.place = tokens, 0

    def run(self, *ends: str) -> str:
        """Everything up to one of the ends, which stays."""
        made: list[str] = []
        while self.place < len(self.tokens) and self.tokens[self.place] not in ends:
            made.append(self.scripted(self.one()))
        return "".join(made)

    def scripted(self, base: str) -> str:
        """The base with what stands below and above it."""
        scripts: dict[str, str] = {}
        while self.place < len(self.tokens) and self.tokens[self.place] in ("_", "^"):
            mark = self.take()
            scripts[mark] = self.one()
        if not scripts:
            return base
        if len(scripts) == 2:
            return f"<msubsup>{base}{scripts['_']}{scripts['^']}</msubsup>"
        ((mark, script),) = scripts.items()
        return f"<m{'sub' if mark == '_' else 'sup'}>{base}{script}</m{'sub' if mark == '_' else 'sup'}>"

    def take(self) -> str:
        """The next token."""
        token = self.tokens[self.place] if self.place < len(self.tokens) else ""
        self.place += 1
        return token

    def one(self) -> str:
        """A token, a group, or a command with its groups."""
        token = self.take()
        if token == "{":
            inside = self.run("}")
            self.take()
            return f"<mrow>{inside}</mrow>"
        if token in (r"\left", r"\right"):
            return f'<mo stretchy="true">{html.escape(self.take())}</mo>'
        if token.startswith(r"\begin"):
            return self.matrix(token[7:-1])
        name = token.removeprefix("\\")
        if name in GREEK and token != name:
            return f"<mi>&#x{GREEK[name]:X};</mi>"
        if name in FUNCTIONS and token != name:
            return f"<mi>{name}</mi><mo>&#x2061;</mo>"
        if token == r"\frac":
            return f"<mfrac>{self.one()}{self.one()}</mfrac>"
        if token == r"\sqrt":
            return f"<msqrt>{self.one()}</msqrt>"
        if token == r"\dot":
            return f'<mover accent="true">{self.one()}<mo>&#x2D9;</mo></mover>'
        if token in (r"\boldsymbol", r"\mathrm", r"\operatorname"):
            return self.word("bold-italic" if token == r"\boldsymbol" else "normal")
        if token in SIGNS:
            return f"<mo>{SIGNS[token]}</mo>"
        if re.fullmatch(r"[0-9].*", token):
            return f"<mn>{token}</mn>"
        return f"<mi>{token}</mi>" if token.isalpha() else f"<mo>{html.escape(name or token)}</mo>"

    def word(self, variant: str) -> str:
        """The letters of a group as one name; bold ones by letters that are bold, as `mathvariant` is no more."""
        letters: list[str] = []
        depth = 0
        while self.place < len(self.tokens):
            token = self.take()
            depth += (token == "{") - (token == "}")
            if token not in "{}":
                letters.append(token.removeprefix("\\"))
            if depth <= 0:
                break
        text = "".join(chr(GREEK[part]) if part in GREEK else part for part in letters)
        style = ' style="font-weight:bold"' if variant != "normal" else ""
        return f'<mi mathvariant="{variant}"{style}>{html.escape(text)}</mi>'

    def matrix(self, kind: str) -> str:
        """Rows of a matrix between its brackets."""
        end, rows = rf"\end{{{kind}}}", [list[str]()]
        while True:
            rows[-1].append(f"<mtd>{self.run('&', chr(92) * 2, end)}</mtd>")
            token = self.take()
            if token in (end, ""):
                break
            if token != "&":
                rows.append([])
        table = "".join(f"<mtr>{''.join(row)}</mtr>" for row in rows)
        left, right = MATRICES.get(kind, ("", ""))
        return f'<mrow><mo stretchy="true">{left}</mo><mtable>{table}</mtable><mo stretchy="true">{right}</mo></mrow>'
