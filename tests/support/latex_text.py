"""Whether a LaTeX document is well formed, without LaTeX: braces, environments, math, commands that packages have."""

from __future__ import annotations

import re

COMMANDS = {
    *(
        "documentclass",
        "usepackage",
        "setlength",
        "emergencystretch",
        "begin",
        "end",
        "section",
        "subsection",
        "item",
        "hline",
        "textbackslash",
        "textbar",
    ),
    *("textless", "left", "right", "frac", "sqrt", "sin", "cos", "tan", "cdot", "quad", "theta", "phi", "psi"),
    *("alpha", "beta", "gamma", "delta", "omega", "pi", "operatorname", "Delta"),
    *("IfFileExists", "raggedright", "emph", "itemsep", "mbox", "sum", "nu", "zeta", "lambda"),
}
"""Of LaTeX with amsmath, as far as the documents use them: an unknown one is looked at by a person first."""
TOKEN = re.compile(r"\\[A-Za-z]+\*?|\\.|[{}$&#_^%~]", re.S)


def faults(text: str) -> list[str]:
    """What a compiler would stop at: each with its line."""
    found: list[str] = []
    braces, groups, math = 0, list[str](), False
    left = 0
    for number, line in enumerate(text.splitlines(), start=1):
        for match in TOKEN.finditer(line):
            token, rest = match.group(), line[match.end() :]
            if token in ("{", "}"):
                braces += 1 if token == "{" else -1
                if braces < 0:
                    found.append(f"{number}: a brace is closed that was not opened")
            elif token == "$":
                math = not math
                if not math and left:
                    found.append(f"{number}: \\left without \\right")
                    left = 0
            elif token in (r"\left", r"\right"):
                left += 1 if token == r"\left" else -1
                if not math or left < 0:
                    found.append(f"{number}: {token} out of place")
            elif token in (r"\begin", r"\end"):
                name = re.match(r"\{(\w+)\}", rest)
                if name is None or (token == r"\end" and (not groups or groups.pop() != name.group(1))):
                    found.append(f"{number}: {token}{rest[:20]}")
                elif token == r"\begin":
                    groups.append(name.group(1))
            elif token.startswith("\\") and token[1:].isalpha() and token[1:].rstrip("*") not in COMMANDS:
                found.append(f"{number}: unknown command {token}")
            elif token in ("_", "^") and not math:
                found.append(f"{number}: {token} outside mathematics")
            elif token in ("#", "%", "~") or (token == "&" and not {"tabular", "pmatrix"} & set(groups)):
                found.append(f"{number}: a bare {token}")
        if math:
            found.append(f"{number}: mathematics that is not closed")
            math = False
    if braces or groups:
        found.append(f"at the end {braces} braces and {groups} are open")
    return found
