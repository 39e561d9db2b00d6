"""The closure of a mechanism as a program that counts its zeros by a Groebner basis.

    structure, slots --forms--> polynomials in z0_0, z0_1, ... ;  how numbers are written: modulo a prime, or exactly
    --Singular: slimgb--> "@zeros", their dimension, their number (as often as `covers` says)

Exact numbers are polynomials in the generators of their field, which are unknowns a0, a1, ... with their equations:
every zero then is there once for each choice of roots.
"""

from __future__ import annotations

import random
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.closure_structure import WIDTH, Group, Structure
from symscrew.assembly.dual_forms import PRODUCT
from symscrew.assembly.exact_slots import Algebraic
from symscrew.assembly.residues import LARGEST_PRIME
from symscrew.assembly.slot_numbers import matrices, spins_of
from symscrew.mobility import Exact, Field

SEED = 20231009
"""Of the matrix that tells regular zeros from others: always the same, so that results repeat."""


class Written(ABC):
    """How numbers are written: the `field` as Singular calls it, unknowns beside the closure's, their equations.

    `covers`: how many values the unknowns beside the closure's have.
    """

    def __init__(self, field: str, equations: Mapping[str, str], covers: int) -> None:
        self.field, self.covers = field, covers
        self.unknowns, self.equations = tuple(equations), tuple(equations.values())

    @abstractmethod
    def text(self, number: Any) -> str:
        """A number, or nothing where it is zero."""


class Modulo(Written):
    """Numbers modulo a prime."""

    def __init__(self, prime: int) -> None:
        super().__init__(str(prime), {}, 1)
        self.prime = prime

    def text(self, number: Any) -> str:
        """A residue, or nothing where it is zero."""
        rest = int(number) % self.prime
        return str(rest) if rest else ""


class Exactly(Written):
    """Numbers of a field, as polynomials in its generators."""

    def __init__(self, field: Field) -> None:
        self.names = {generator: f"a{k}" for k, generator in enumerate(field.generators)}
        equations = {
            name: f"{name}^{generator.degree}+{self._polynomial(generator.modulus, name) or 0}"
            for generator, name in self.names.items()
        }
        super().__init__("0", equations, field.degree)

    def text(self, number: Any) -> str:
        """A number, or nothing where it is zero."""
        return self.exact(number.exact if isinstance(number, Algebraic) else Fraction(int(number)))

    def exact(self, number: Exact) -> str:
        """The same of a number of the field itself."""
        if hasattr(number, "generator"):
            return f"({self._polynomial(number.coefficients, self.names[number.generator]) or 0})"
        fraction = Fraction(number)
        return f"({fraction})" if fraction else ""

    def _polynomial(self, coefficients: Sequence[Exact], name: str) -> str:
        return "+".join(f"{text}*{name}^{k}" for k, c in enumerate(coefficients) if (text := self.exact(c)))


@dataclass(frozen=True)
class ClosureIdeal:
    """The polynomials of a structure with numbers in its slots; `before`: what the program defines first."""

    structure: Structure
    slots: Sequence[Any]
    written: Written
    before: tuple[str, ...] = ()

    @property
    def covers(self) -> int:
        """How often every zero is counted."""
        doubled = sum(group.kind != "slide" for group in self.structure.groups)
        return self.written.covers << doubled

    def program(self, *, regular: bool = False) -> str:
        """What Singular is given; `regular`: with what singular zeros do not fulfil."""
        structure = self.structure
        motions, loops = matrices(structure, self.slots)
        names, cuts, lines = list[str](), list[str](), [*self.before]
        for k, group in enumerate(structure.groups):
            own = self._unknowns(k)
            names += own
            lines += self._factor(k, motions[k], own)
            cuts.append(self._cut(group, own))
            if group.kind == "free":
                cuts.append("+".join(f"{own[i]}*{own[4 + i]}" for i in range(4)))
        for k, (spin, motion) in enumerate(zip(structure.spins, spins_of(structure), strict=True)):
            lines += self._factor(len(structure.groups) + k, motion, self._unknowns(spin.group))
        equations = [*cuts]
        ways = BatchEquations(structure).ways
        for n, ((square, linear), way) in enumerate(zip(loops, ways, strict=True)):
            lines += self._loop(n, [(factor.motion, factor.back) for factor in way])
            g = [f"g{n}_{i}" for i in range(8)]
            for form in square:
                twice = [(form[i, j] * (1 if i == j else 2), i, j) for i in range(8) for j in range(i, 8)]
                equations.append(self._sum([(c, f"{g[i]}*{g[j]}") for c, i, j in twice]))
            equations += [self._sum([(row[i], g[i]) for i in range(8)]) for row in linear]
        only = self._regular(len(equations) - len(cuts)) if regular else []
        names += [*(["u"] * regular), *self.written.unknowns]
        ideal = ",\n".join([*equations, *self.written.equations])
        text = "\n".join(lines)
        return (
            f"ring r = {self.written.field},({','.join(names)}),dp;\n{text}\nideal i = {ideal};\n"
            f"{''.join(only)}ideal s = slimgb(i);\n"
            "int d = dim(s); int v = 0; if (d == 0) { v = vdim(s); }\n"
            'print("@zeros " + string(d) + " " + string(v));\nprint("@end");\nquit;\n'
        )

    def _unknowns(self, group: int) -> list[str]:
        return [f"z{group}_{i}" for i in range(WIDTH[self.structure.groups[group].kind])]

    def _factor(self, k: int, motion: Any, own: Sequence[str]) -> list[str]:
        """The displacement of one factor, linear in its unknowns."""
        rows = (self._sum([(motion[i, j], name) for j, name in enumerate(own)]) for i in range(8))
        return [f"poly f{k}_{i} = {text};" for i, text in enumerate(rows)]

    def _cut(self, group: Group, names: Sequence[str]) -> str:
        """The equation that leaves one point, or two, of each displacement of a group."""
        if group.kind == "slide":
            return f"{names[0]}-1"
        if group.kind == "turn":
            return f"{names[0]}^2+{self._square(group)}*{names[1]}^2-1"
        return "+".join(f"{name}^2" for name in names[: 2 if group.kind == "planar" else 4]) + "-1"

    def _square(self, group: Group) -> str:
        """Of the length of a turn's axis."""
        x, y, z = self.slots[group.slots[0]]
        return self.written.text(x * x + y * y + z * z) or "0"

    def _loop(self, n: int, factors: Sequence[tuple[int, bool]]) -> list[str]:
        """The displacement around a loop as a product of these, of which some are passed towards the ground."""
        lines = []
        before: list[str] = []
        for place, (k, back) in enumerate(factors):
            sign = ["", "-", "-", "-"] * 2 if back else [""] * 8
            own = [f"{sign[i]}f{k}_{i}" for i in range(8)]
            after = own if not before else self._product(before, own)
            last = place == len(factors) - 1
            names = [f"g{n}_{i}" if last else f"h{n}_{place}_{i}" for i in range(8)]
            lines += [f"poly {name} = {text};" for name, text in zip(names, after, strict=True)]
            before = names
        return lines

    def _regular(self, rows: int) -> list[str]:
        """Adjoins u det(A dF) - 1 to the ideal i: its first entries are the cuts, the others the equations."""
        rng, groups = random.Random(SEED), self.structure.groups
        lines = ["poly p;\n", f"matrix m[{len(groups)}][{len(groups)}];\n"]
        for row in range(len(groups)):
            factors = (rng.randrange(1, LARGEST_PRIME) for _ in range(rows))
            lines.append(f"p = {'+'.join(f'{c}*i[{len(groups) + k + 1}]' for k, c in enumerate(factors))};\n")
            for column, group in enumerate(groups):
                one, two = f"z{column}_0", f"z{column}_1"
                slope = f"diff(p, {two})"
                if group.kind != "slide":
                    slope = f"{one}*{slope}-{self._square(group)}*{two}*diff(p, {one})"
                lines.append(f"m[{row + 1},{column + 1}] = {slope};\n")
        return [*lines, "i = i, u*det(m)-1;\n"]

    def _product(self, a: Sequence[str], b: Sequence[str]) -> list[str]:
        places = [(i, j) for i in range(8) for j in range(8)]
        return [self._sum([(int(PRODUCT[k, i, j]), f"{a[i]}*({b[j]})") for i, j in places]) for k in range(8)]

    def _sum(self, terms: Sequence[tuple[Any, str]]) -> str:
        parts = [f"{text}*{name}" for c, name in terms if (text := self.written.text(c))]
        return "+".join(parts) or "0"
