"""Lengths that a geometry repeats, named once: sqrt(H^2 + (R - r)^2) is l from there on.

expressions of the parameters --Lengths--> the same with symbols for their roots

Parameters that follow from others are such names, too: of depth = sqrt(rods^2 - inwards^2) the root is written depth,
of inwards = a + b - c the sum is written inwards where that is shorter.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import sympy

from symscrew.description import Mechanism, Parameter
from symscrew.paper_formulas.formula import Formula, latex_of

MOST_OPERATIONS = 30  # of an expression whose factors are looked for: a tenth of a second; longer ones have few
MOST_SYMBOLS = 8  # of the same: polynomials in more take seconds each
ZERO_NUMBER = 1e-25  # of an exact expression with 30 digits at two values of the parameters: smaller at both is zero
LETTER = "l"  # of named lengths; followed by a number where there are several, or where a parameter has it


class Lengths:
    """Roots in a mechanism's joints as symbols, positive as lengths are."""

    def __init__(self, mechanism: Mechanism) -> None:
        """Roots in points and axes of joints and in named points, in the order in which they appear."""
        self.mechanism = mechanism
        self._roots: dict[sympy.Expr, sympy.Symbol] = {}
        positive = {p.symbol: sympy.Symbol(p.name, positive=True) for p in mechanism.parameters.values() if p.value > 0}
        self.positive = positive
        self._derived = _followed(mechanism, positive)
        self._given_up: dict[sympy.Symbol, sympy.Expr] = {}
        for symbol, formula in self._derived.items():
            self._keep(symbol, formula)
        found: list[sympy.Expr] = []
        for joint in mechanism.joints.values():
            for vector in (joint.point, *joint.axes):
                for entry in vector:
                    found += [r for r in _radicands(self._in_few(entry)) if r not in found and r not in self._roots]
        letters = [LETTER] if len(found) == 1 else [f"{LETTER}{k}" for k in range(1, len(found) + 1)]
        for radicand, letter in zip(found, letters, strict=True):
            name = letter
            while name in mechanism.parameters:
                name = f"{name}_0"
            self._roots[radicand] = sympy.Symbol(f"named {name}", positive=True)
        roots = [symbol for symbol in self._roots.values() if symbol not in self._derived]
        self._letters = {symbol: str(symbol).removeprefix("named ") for symbol in roots}

    def _keep(self, symbol: sympy.Symbol, formula: sympy.Expr) -> None:
        """A parameter that follows from others: as a root, or in place of a term of the sum that it is."""
        here = sympy.expand(formula.xreplace(self._given_up))
        if here.is_Pow and here.exp == sympy.Rational(1, 2):
            self._roots[sympy.expand(here.base)] = symbol
            return
        known = {*self._derived, *self._given_up}
        for term in reversed(here.as_ordered_terms()):
            (size, other) = term.as_coeff_Mul()
            if abs(size) == 1 and other.is_Symbol and other not in known:
                rest = here - term
                if not rest.has(other):
                    made = {other: (symbol - rest) * size}
                    self._given_up = {old: replaced.xreplace(made) for old, replaced in self._given_up.items()} | made
                return

    def _in_few(self, expression: sympy.Expr) -> sympy.Expr:
        """The expression in positive parameters, without those that others replace."""
        return expression.xreplace(self.positive).xreplace(self._given_up)

    def _with_sums(self, expression: sympy.Expr) -> sympy.Expr:
        """Parameters that others have replaced, again, where that is shorter."""
        best = expression
        for symbol, replaced in self._given_up.items():
            for old in sorted(replaced.free_symbols & best.free_symbols, key=str):
                (value,) = sympy.solve(symbol - replaced, old)
                tried = best.xreplace({old: value})
                best = min((best, tried, sympy.expand(tried)), key=sympy.count_ops)
        return best

    def named(self, expression: sympy.Expr) -> sympy.Expr:
        """The expression with its roots named."""
        here = self._in_few(expression)
        made = here.replace(
            lambda e: e.is_Pow and e.exp.is_Rational and e.exp.q == 2 and sympy.expand(e.base) in self._roots,
            lambda e: self._roots[sympy.expand(e.base)] ** e.exp.p,
        )
        return self._with_sums(made)

    def written(self, expression: sympy.Expr) -> sympy.Expr:
        """The expression with its roots written out, in positive parameters."""
        roots = {symbol: sympy.sqrt(radicand) for radicand, symbol in self._roots.items()}
        return self._in_few(expression).xreplace(roots)

    def number(self, expression: sympy.Expr, *, other: bool = False) -> float:
        """The expression in the parameters' values, or at `other` ones, with 30 digits."""
        return float(sympy.N(self.written(expression).xreplace(self._elsewhere if other else self._numbers), 30))

    @cached_property
    def _numbers(self) -> dict[sympy.Symbol, sympy.Expr]:
        return {self.positive.get(p.symbol, p.symbol): p.value for p in self.mechanism.parameters.values()}

    @cached_property
    def _elsewhere(self) -> dict[sympy.Symbol, sympy.Expr]:
        """Values of no special position near the given ones."""
        far = [sympy.Rational(1000 + 7 * k + 3 * k**2, 1000) for k in range(len(self._numbers))]
        moved = {symbol: value * f for (symbol, value), f in zip(self._numbers.items(), far, strict=True)}
        for symbol, formula in self._derived.items():
            moved[symbol] = formula.xreplace(moved)
        return moved

    def distance(self, way: sympy.Matrix) -> sympy.Expr:
        """The length of a vector in the parameters, by its name where it has one."""
        square = sympy.expand(self.written(way.dot(way)))
        found = self.tidy(self.named(self.simple(sympy.sqrt(square))))
        return sympy.sqrt(short_sum(sympy.expand(found**2))) if found.is_Pow else found

    def simple(self, expression: sympy.Expr) -> sympy.Expr:
        """An expression in the parameters, shorter if it can be; zero where it is zero."""
        if expression.is_Atom or expression.is_Rational:
            return expression
        if all(abs(self.number(expression, other=other)) < ZERO_NUMBER for other in (False, True)):
            return sympy.Integer(0)
        if not expression.free_symbols:
            tried = sympy.radsimp(sympy.expand(expression), max_terms=2)
        else:
            tried = sympy.factor(sympy.cancel(sympy.radsimp(sympy.together(sympy.expand(expression)), max_terms=2)))
        return min((expression, tried), key=sympy.count_ops)

    def exact(self, matrix: sympy.Matrix) -> sympy.Matrix:
        """A vector or matrix in the parameters with roots written out, as short as it becomes."""
        return matrix.applyfunc(lambda e: self.simple(self.written(e)))

    def constant(self, vector: sympy.Matrix) -> sympy.Matrix:
        """The same with lengths named."""
        return self.exact(vector).applyfunc(self.named)

    def tidy(self, expression: sympy.Expr) -> sympy.Expr:
        """The expression with the roots' squares written out where that makes it shorter, and factors taken out.

        Numbers that are no fractions are taken for symbols meanwhile, and long expressions stay as they are: factors of
        either take minutes.
        """
        if expression.is_Atom or sympy.count_ops(expression) > MOST_OPERATIONS:
            return expression
        if len(expression.free_symbols) > MOST_SYMBOLS:
            return expression
        kept = {number: sympy.Dummy(positive=True) for number in _irrational(expression)}
        plain = expression.xreplace(kept)
        flat = sympy.expand(plain)
        ways = [plain, flat, sympy.factor(plain), *(sympy.collect(flat, s) for s in _carriers(flat))]
        if not kept and self._roots:
            squares = self._squares(flat)
            ways += [squares, sympy.factor(squares), *(sympy.collect(squares, s) for s in _carriers(squares))]
        best = min(ways, key=lambda e: (sympy.count_ops(e), len(str(e))))
        return best.xreplace({dummy: number for number, dummy in kept.items()})

    def _squares(self, expression: sympy.Expr) -> sympy.Expr:
        """l^2 in place of H^2 + (R - r)^2, wherever a sum holds it."""
        result = sympy.expand(expression)
        for radicand, symbol in self._roots.items():
            if not radicand.free_symbols <= result.free_symbols or not result.is_polynomial(*radicand.free_symbols):
                continue
            for lead in sorted(radicand.free_symbols, key=str):
                if sympy.degree(radicand, lead) > 0 and sympy.LC(radicand, lead).is_number:
                    swapped = sympy.rem(result, radicand - symbol**2, lead)
                    result = min((result, sympy.expand(swapped)), key=sympy.count_ops)
                    break
        return result

    @cached_property
    def names(self) -> Mapping[sympy.Symbol, str]:
        """LaTeX of parameters and lengths."""
        made = {self.positive.get(p.symbol, p.symbol): symbol_latex(p.name) for p in self.mechanism.parameters.values()}
        return made | {symbol: symbol_latex(letter) for symbol, letter in self._letters.items()}

    @property
    def geometric(self) -> list[Parameter]:
        """Parameters that points and axes of joints refer to, and those that these follow from."""
        used = {self.positive.get(s, s) for s in _in_geometry(self.mechanism)}
        used |= {symbol for formula in self._derived.values() for symbol in formula.free_symbols}
        return [p for p in self.mechanism.parameters.values() if self.positive.get(p.symbol, p.symbol) in used]

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """What follows from other parameters, then l = sqrt(...), each."""
        follow = tuple(
            Formula(self.names[symbol], latex_of(formula, self.names), ("parameter", str(symbol)))
            for symbol, formula in self._derived.items()
        )
        return follow + tuple(
            Formula(self.names[symbol], latex_of(sympy.sqrt(short_sum(radicand)), self.names), ("length", str(symbol)))
            for radicand, symbol in self._roots.items()
            if symbol in self._letters
        )

    @property
    def values(self) -> dict[sympy.Symbol, float]:
        """Every parameter and length as a number."""
        numbers = {self.positive.get(p.symbol, p.symbol): p.value for p in self.mechanism.parameters.values()}
        roots = {symbol: sympy.sqrt(radicand.xreplace(numbers)) for radicand, symbol in self._roots.items()}
        return {symbol: float(value) for symbol, value in {**numbers, **roots}.items()}


def _followed(mechanism: Mechanism, positive: Mapping[sympy.Symbol, sympy.Symbol]) -> dict[sympy.Symbol, sympy.Expr]:
    """Parameters of the geometry that follow from others: their symbols and formulas, each after what it refers to."""
    made: dict[sympy.Symbol, sympy.Expr] = {}

    def take(symbol: sympy.Symbol) -> None:
        formula = mechanism.parameters[str(symbol)].formula
        here = positive.get(symbol, symbol)
        if formula is not None and formula.free_symbols and here not in made:
            for other in sorted(formula.free_symbols, key=str):
                take(other)
            made[here] = formula.xreplace(positive)

    for symbol in sorted(_in_geometry(mechanism), key=str):
        take(symbol)
    return made


def _in_geometry(mechanism: Mechanism) -> set[sympy.Symbol]:
    vectors = [v for joint in mechanism.joints.values() for v in (joint.point, *joint.axes)]
    return {symbol for vector in vectors for entry in vector for symbol in entry.free_symbols}


def symbol_latex(name: str) -> str:
    r"""A name as a symbol: one letter with an index, or upright words.

    >>> symbol_latex("R"), symbol_latex("l1"), symbol_latex("half_spacing"), symbol_latex("theta")
    ('R', 'l_{1}', '\\mathrm{half\\_spacing}', '\\theta')
    """
    stem = name.rstrip("0123456789")
    digits = name[len(stem) :]
    stem = stem.rstrip("_") if digits else stem
    greek = sympy.latex(sympy.Symbol(stem)) if stem.isalpha() else ""
    if len(stem) == 1 or greek.startswith("\\"):
        return (greek or stem) + (f"_{{{digits}}}" if digits else "")
    return rf"\mathrm{{{name.replace('_', chr(92) + '_')}}}"


def _radicands(expression: sympy.Expr) -> list[sympy.Expr]:
    roots = [e for e in sympy.preorder_traversal(expression) if e.is_Pow and e.exp.is_Rational and e.exp.q == 2]
    return [sympy.expand(e.base) for e in roots if e.base.free_symbols]


def _carriers(expression: sympy.Expr) -> list[sympy.Expr]:
    """Symbols, sines and cosines that a sum may be collected by."""
    return sorted(expression.free_symbols | expression.atoms(sympy.sin, sympy.cos), key=str)


def short_sum(radicand: sympy.Expr) -> sympy.Expr:
    """A sum of squares where it is one of differences: H^2 + (R - r)^2 rather than written out."""
    squares = sympy.Integer(0)
    rest = sympy.expand(radicand)
    symbols = sorted(rest.free_symbols, key=str)
    for one in symbols:
        for other in symbols:
            if one == other or rest.coeff(one * other) == 0 or str(one) > str(other):
                continue
            for sign in (1, -1):
                square = (one + sign * other) ** 2
                left = sympy.expand(rest - square)
                if sympy.count_ops(left) < sympy.count_ops(rest) and len(left.as_ordered_terms()) + 3 <= len(
                    rest.as_ordered_terms()
                ) + (left == 0):
                    squares, rest = squares + square, left
                    break
    return min((radicand, squares + rest), key=sympy.count_ops)


def _irrational(expression: sympy.Expr) -> set[sympy.Expr]:
    """Largest parts without symbols that are no fractions."""
    if expression.is_Rational:
        return set()
    if expression.is_number:
        return {expression}
    return {number for arg in expression.args for number in _irrational(arg)}
