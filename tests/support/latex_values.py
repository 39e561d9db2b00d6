r"""Values of printed formulas: what a reader would compute from them, and nothing that the package knows of them.

Numbers, symbols, `\frac`, `\sqrt`, powers, products by juxtaposition, sums, `\sin`, `\cos`,
`\arccos`, `\operatorname{atan2}`, `\times`, `\cdot`, pmatrix.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np

TOKEN = re.compile(
    r"\\boldsymbol\{[A-Za-z0]\}(?:_\{[^}]*\})?|\\mathrm\{[^}]*\}|\\(?:cos|sin) \\varphi_\{[^}]*\}"
    r"|\\(?:theta|varphi|lambda|alpha|beta|gamma|phi|psi|rho)(?:_\{[^}]*\})?|[A-Za-z]_\{[^}]*\}|\d+\.\d+|\d+"
    r"|\\begin\{pmatrix\}|\\operatorname\{atan2\}|,|\\end\{pmatrix\}|\\[A-Za-z]+|\\\\|[A-Za-z]|[-+^(){}&/]|\s+"
)
STARTS = re.compile(
    r"\\operatorname|\\arccos|\\boldsymbol|\\mathrm|\\frac|\\sqrt|\\pi|\\left|\\cos|\\sin|\\begin|\\theta|\\varphi|\\lambda|[\w(]"
)


class Values:
    """A formula at values of its names."""

    def __init__(self, text: str, names: Mapping[str, object]) -> None:
        self.names = names
        self.tokens = [m[0] for m in TOKEN.finditer(text) if m[0].strip() and m[0] != r"\right"]
        assert "".join(TOKEN.findall(text)).replace(" ", "") == text.replace(" ", "").replace("\n", ""), text
        self.place = 0

    def run(self) -> np.ndarray:
        """Its value."""
        value = self.sum()
        assert self.place == len(self.tokens), self.tokens[self.place :]
        return np.asarray(value, dtype=float)

    @property
    def next(self) -> str:
        return self.tokens[self.place] if self.place < len(self.tokens) else ""

    def take(self, expected: str = "") -> str:
        token = self.next
        assert token and (not expected or token == expected), (token, expected)
        self.place += 1
        return token

    def sum(self) -> object:
        sign = -1 if self.next == "-" else 1
        if self.next in ("-", "+"):
            self.take()
        total = sign * self.product()
        while self.next in ("+", "-"):
            sign = 1 if self.take() == "+" else -1
            total = total + sign * self.product()
        return total

    def product(self) -> object:
        value = self.power()
        while self.next in (r"\times", r"\cdot") or STARTS.match(self.next):
            if self.next == r"\times":
                self.take()
                value = np.cross(value, self.power())
                continue
            dot = self.next == r"\cdot"
            if dot:
                self.take()
            other = self.power()
            vectors = np.ndim(value) > 0 and np.ndim(other) > 0
            value = value @ other if vectors else value * other
        return value

    def power(self) -> object:
        value = self.atom()
        if self.next == "^":
            self.take()
            value = value ** self.group()
        return value

    def group(self) -> object:
        if self.next != "{":
            return self.atom()
        self.take("{")
        value = self.sum()
        self.take("}")
        return value

    def atom(self) -> object:
        token = self.take()
        if token in self.names:
            return self.names[token]
        if token[0].isdigit():
            return float(token)
        if token == r"\frac":
            return self.group() / self.group()
        if token == r"\sqrt":
            return np.sqrt(self.group())
        if token == r"\arccos":
            return np.arccos(self.power())
        if token == r"\operatorname{atan2}":
            self.take("(")
            first = self.sum()
            self.take(",")
            second = self.closed()
            return np.arctan2(first, second)
        if token == r"\pi":
            return np.pi
        if token in (r"\cos", r"\sin"):
            exponent = 1.0
            if self.next == "^":
                self.take()
                exponent = self.group()
            return {r"\cos": np.cos, r"\sin": np.sin}[token](
                self.group() if self.next == "{" else self.atom()
            ) ** exponent
        if token == r"\left":
            self.take("(")
            return self.closed()
        if token == "(":
            return self.closed()
        if token == r"\begin{pmatrix}":
            return self.matrix()
        raise AssertionError(f"a symbol that nothing defines: {token}")

    def closed(self) -> object:
        value = self.sum()
        self.take(")")
        return value

    def matrix(self) -> object:
        rows: list[list[object]] = [[self.sum()]]
        while self.next != r"\end{pmatrix}":
            if self.take() == "&":
                rows[-1].append(self.sum())
            else:
                rows.append([self.sum()])
        self.take()
        return (
            np.concatenate([np.atleast_1d(row[0]) for row in rows])
            if len(rows[0]) == 1
            else np.array(rows, dtype=float)
        )
