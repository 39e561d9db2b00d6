"""All formulas of a mechanism, as parts of a paper: LaTeX to put in by \\input, or a document of its own.

mechanism --Lengths, limb_part, spoke_part, platform_parts--> Paper --tex--> text
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from symscrew.description import Mechanism, markdown_text
from symscrew.errors import DescriptionError, expect
from symscrew.mobility import analyse_mobility
from symscrew.paper_formulas.equal_turns import Turned, families
from symscrew.paper_formulas.formula import Formula, Part, degrees
from symscrew.paper_formulas.limb_formulas import Freedom, freedoms_of, limb_part
from symscrew.paper_formulas.moved_rods import rod_part
from symscrew.paper_formulas.named_lengths import Lengths
from symscrew.paper_formulas.platform_formulas import platform_parts
from symscrew.paper_formulas.spokes import spoke_part
from symscrew.paper_formulas.unprinted import unprinted_part
from symscrew.whole_files import write_text

HEAD = r"""\documentclass[11pt]{article}
\usepackage[a4paper,margin=20mm]{geometry}
\usepackage{amsmath}
\allowdisplaybreaks
\begin{document}
"""


@dataclass(frozen=True, repr=False)
class Paper:
    """Formulas of a mechanism by part; limb k of the formulas has the joints `limbs[k - 1]`, from the base."""

    mechanism: Mechanism
    parts: tuple[Part, ...]
    lengths: Lengths
    limbs: tuple[tuple[str, ...], ...] = ()

    def __repr__(self) -> str:
        count = sum(len(part.formulas) for part in self.parts)
        return f"Paper({self.mechanism.name}: {count} formulas in {len(self.parts)} parts)"

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """All of them, in order."""
        return tuple(formula for part in self.parts for formula in part.formulas)

    def tex(self, *, document: bool = False) -> str:
        r"""LaTeX for \input into a paper that uses amsmath; or a whole document."""
        lines = [rf"% Formulas of {self.mechanism.name} by symscrew; needs \usepackage{{amsmath}}."]
        for part in self.parts:
            lines += ["", rf"\subsection*{{{_text(part.title)}}}", _text(part.words)]
            if part.symbols:
                said = "; ".join(f"${symbol}$: {_text(words)}" for symbol, words in part.symbols.items())
                lines.append(rf"\par\noindent {said}.")
            lines += [rf"\begin{{equation*}}{chr(10)}{f.text}{chr(10)}\end{{equation*}}" for f in part.formulas]
        body = "\n".join(lines) + "\n"
        return f"{HEAD}{body}\\end{{document}}\n" if document else body

    def save(self, path: str | Path, *, document: bool = False) -> Path:
        """Write a .tex file. Raises DescriptionError where the name ends in something else."""
        return write_formulas(self, path, document=document)

    def markdown(self, level: int = 2) -> str:
        """Markdown with equations between dollar signs, as notebooks and repositories show it; headings begin there."""
        lines: list[str] = []
        for part in self.parts:
            lines += ["#" * level + f" {markdown_text(part.title)}", ""]
            lines += [_marked(part.words), ""] if part.words else []
            if part.symbols:
                said = "; ".join(f"${symbol}$: {markdown_text(words)}" for symbol, words in part.symbols.items())
                lines += [f"{said}.", ""]
            lines += [line for f in part.formulas for line in ("$$", f.text, "$$", "")]
        return "\n".join(lines)

    def _repr_markdown_(self) -> str:
        return self.markdown(level=4)

    def _repr_latex_(self) -> str:
        rows = r" \\ ".join(formula.text for formula in self.formulas)
        return rf"$$\begin{{gathered}} {rows} \end{{gathered}}$$"


def paper_formulas(mechanism: Mechanism) -> Paper:
    """The formulas of a mechanism: lengths, limbs, what equal limbs are, inverse kinematics, constraints, loci.

    Of a mechanism without limbs every chain from the ground to the platform is taken for one.

    Raises:
        DescriptionError: neither limbs nor a chain that reaches the platform.
    """
    expect(mechanism, Mechanism)
    lengths = Lengths(mechanism)
    limbs = limbs_of(mechanism)
    parts: list[Part] = []
    if lengths.geometric:
        symbols = {
            lengths.names[lengths.positive.get(p.symbol, p.symbol)]: f"{p.description or p.name} [{p.unit}]"
            for p in lengths.geometric
        }
        parts.append(Part("Lengths", "", lengths.formulas, symbols))
    read = [freedoms_of(mechanism, joints) for joints in limbs]
    of_a_kind = families(read, lengths)
    for family in of_a_kind:
        first = next(iter(family))
        parts.append(limb_part(mechanism, limbs[first], first + 1, lengths))
        if len(family) > 1:
            parts.append(_turned(family, first, read))
    parts += [part for part in (spoke_part(mechanism, limbs, lengths), rod_part(mechanism, limbs, lengths)) if part]
    parts += [part for part in (unprinted_part(mechanism, limbs, lengths), outside_part(mechanism, limbs)) if part]
    if mechanism.limbs:
        firsts = {next(iter(family)) + 1: read[next(iter(family))] for family in of_a_kind}
        parts += platform_parts(analyse_mobility(mechanism), lengths, firsts)
    return Paper(mechanism, tuple(parts), lengths, tuple(limbs))


def limbs_of(mechanism: Mechanism) -> list[tuple[str, ...]]:
    """The joints of every limb from the base: those of the description, or all chains that reach the platform.

    Chains are in the order of their first joints, those that begin with a joint that another one began with after all
    others: the first rods of a delta's arms come before the second ones. Where there are more than `MOST_CHAINS`,
    shortest ones are taken.
    """
    if mechanism.limbs:
        return [limb.joints for limb in mechanism.limbs.values()]
    platform = mechanism.platform or list(mechanism.bodies)[-1]
    found: list[tuple[str, ...]] = []
    reached: deque[tuple[str, tuple[str, ...]]] = deque([(mechanism.ground, ())])
    while reached and len(found) < MOST_CHAINS and len(reached) < MOST_REACHED:
        body, chain = reached.popleft()
        if body == platform:
            found.append(chain)
            continue
        passed = {mechanism.joints[name].parent for name in chain}
        for name, joint in mechanism.joints.items():
            if joint.parent == body and joint.child not in passed:
                reached.append((joint.child, (*chain, name)))
    if not found:
        raise DescriptionError(f"{mechanism.name}: expected limbs ([limbs]) or a chain from the ground to {platform!r}")
    begun = [sum(other[:1] == chain[:1] for other in found[:k]) for k, chain in enumerate(found)]
    return [chain for _, chain in sorted(zip(begun, found, strict=True), key=lambda pair: pair[0])]


MOST_CHAINS = 12  # of a mechanism without limbs that are written out: a page each
MOST_REACHED = 1000  # bodies from which chains are still followed: more are a net, whose limbs its author has to name


def outside_part(mechanism: Mechanism, limbs: Sequence[Sequence[str]]) -> Part | None:
    """What is left out, said: joints that no limb holds; None where all stand in one."""
    inside = {name for joints in limbs for name in joints}
    others = [name for name in mechanism.joints if name not in inside]
    if not others:
        return None
    words = (
        f"Of {', '.join(others)} nothing is printed: a limb is a chain of joints from the ground to the platform, each "
        "from its parent to its child, and these stand in none. A joint whose parent is the body nearer the platform "
        "is turned round, or its chain is named in [limbs], to be printed."
    )
    return Part("Joints outside the limbs", words, ())


def _turned(family: dict[int, Turned], first: int, read: list[list[Freedom] | str]) -> Part:
    """Limbs that are the first of a family turned about z or (1, 1, 1): a formula each."""
    others = {k: turned for k, turned in family.items() if k != first}
    letter, axis = ("D", "(1, 1, 1)") if any(turned.diagonal for turned in others.values()) else ("Z", "z")
    formulas = []
    for k, turned in others.items():
        name, of = (rf"\boldsymbol{{S}}_{{{n + 1}}}" for n in (k, first))
        text = rf"\boldsymbol{{{letter}}}({degrees(turned.angle)}^{{\circ}}) {of}"
        if -1 in turned.signs:
            text += rf" \operatorname{{diag}}({', '.join(map(str, turned.signs))})"
        formulas.append(Formula(name, text, ("turned", str(first), str(k))))
    said = ", ".join(f"limb {k + 1} by {degrees(turned.angle)} degrees" for k, turned in others.items())
    words = (
        f"These are limb {first + 1} turned about {axis}: {said}, each with its own displacements. "
        f"$\\boldsymbol{{{letter}}}$ turns the angular and the linear part of every screw."
    )
    if any(-1 in turned.signs for turned in others.values()):
        words += " Where a column is negative, its displacement counts the other way."
    limb = read[first]
    if not isinstance(limb, str) and any(f.spherical for f in limb):
        words += " Columns and rotations of spherical joints are in axes turned likewise."
    return Part(
        ("Limb " if len(others) == 1 else "Limbs ") + ", ".join(str(k + 1) for k in others), words, tuple(formulas)
    )


def _text(words: str) -> str:
    """Words with mathematics between dollar signs, as LaTeX; what a description says is escaped."""
    pieces = words.split("$")
    return "$".join(piece if k % 2 else _escaped(piece) for k, piece in enumerate(pieces))


def _marked(words: str) -> str:
    """Words with mathematics between dollar signs, as Markdown; what a description says is escaped."""
    pieces = words.split("$")
    return "$".join(piece if k % 2 else markdown_text(f"x{piece}x")[1:-1] for k, piece in enumerate(pieces))


def _escaped(text: str) -> str:
    made = text.replace("\\", r"\textbackslash ")
    for character in "#%&_{}":
        made = made.replace(character, "\\" + character)
    return made.replace("^", r"\textasciicircum ").replace("~", r"\textasciitilde ")


def write_formulas(paper: Paper, path: str | Path, *, document: bool = False) -> Path:
    """Write the formulas into a .tex file, whole or not at all.

    Raises:
        DescriptionError: the name ends in something else.
    """
    file = Path(path)
    if file.suffix != ".tex":
        raise DescriptionError(f"--out: expected a file name that ends in .tex, got {file.name!r}")
    return write_text(file, paper.tex(document=document))
