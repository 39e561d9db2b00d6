"""Exact numbers and expressions from text, by a small grammar of our own.

Text of a description is never handed to `eval`, `exec` or `sympify`. The grammar:

    sum      = product { ("+" | "-") product }
    product  = signed { ("*" | "/") signed }
    signed   = { "+" | "-" } power
    power    = atom [ ("^" | "**") signed ]          right associative
    atom     = number | name | function "(" sum { "," sum } ")" | "(" sum ")"

Numbers are integers or decimals of any length with an optional power of ten; all are read exactly.
Length, depth, exponents and the size of every intermediate number are limited, so that no short text
can occupy the machine (`9**9**9`).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from numbers import Integral
from typing import TYPE_CHECKING, NoReturn, SupportsFloat

import sympy
from sympy.printing.precedence import PRECEDENCE

from symscrew.description.digits import sixty_digits
from symscrew.errors import DescriptionError, did_you_mean, shorten

if TYPE_CHECKING:  # SymPy has no types: what is used of its printer

    class _Printer:
        def doprint(self, expr: object) -> str: ...
        def _print(self, expr: object) -> str: ...
        def parenthesize(self, item: object, level: int) -> str: ...
else:
    from sympy.printing.str import StrPrinter as _Printer

# What a text may ask for, so that no description takes the machine with it. Beyond each limit the text is refused with
# a DescriptionError that names the limit; what people write by hand or export from CAD is far inside all of them.
MAX_LENGTH = 5000  # characters of one expression
MAX_DEPTH = 50  # nested brackets, signs and powers: far inside Python's recursion limit
MAX_EXPONENT = 64  # parts of a constant exponent: geometry has squares and roots
MAX_POWER_OF_TEN = 400  # of a decimal: no double is beyond 1e308
MAX_EXP_ARGUMENT = 700  # exp(709) is the largest double
MAX_BITS = 13_900  # Python prints integers of up to 4300 digits
MAX_NODES = 20_000  # of the expression that results, where parameters are put into one another

FUNCTIONS: dict[str, tuple[int, Callable[..., sympy.Expr]]] = {
    "sqrt": (1, sympy.sqrt),
    "sin": (1, sympy.sin),
    "cos": (1, sympy.cos),
    "tan": (1, sympy.tan),
    "cot": (1, sympy.cot),
    "asin": (1, sympy.asin),
    "acos": (1, sympy.acos),
    "atan": (1, sympy.atan),
    "atan2": (2, sympy.atan2),
    "exp": (1, sympy.exp),
    "abs": (1, sympy.Abs),
}
UNBOUNDED = frozenset(map(type, (sympy.zoo, sympy.nan, sympy.oo, -sympy.oo)))
CONSTANTS: dict[str, sympy.Expr] = {"pi": sympy.pi}

_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<name>[A-Za-z_][A-Za-z0-9_]*)|(?P<operator>\*\*|[-+*/^(),]))",
    re.ASCII,
)


def parse(text: str, names: Mapping[str, sympy.Expr] | None = None, *, where: str = "expression") -> sympy.Expr:
    """The exact SymPy expression that `text` stands for.

    Args:
        text: such as `"3*sqrt(3)/10"` or `"R*cos(phi)"`.
        names: what each allowed name stands for (a parameter's symbol or its value).
        where: place of the text in the description, for the message.

    Raises:
        DescriptionError: the text is not in the grammar, names something unknown, is too long or too
            deep, or its value is too large, infinite or undefined.

    >>> parse("3*sqrt(3)/10")
    3*sqrt(3)/10
    >>> parse("0.1")
    1/10
    """
    return _Parser(text, names or {}, where).run()


def exact(value: object, names: Mapping[str, sympy.Expr] | None = None, *, where: str = "number") -> sympy.Expr:
    """`value` as an exact expression: int, float, Decimal, Fraction, text or a SymPy expression.

    A float counts as its shortest decimal: 0.1 is 1/10. True, False, NaN and infinities are refused.

    Raises:
        DescriptionError: it is none, or a name in the text is not among `names`; begins with `where`.

    >>> exact(0.1)
    1/10
    """
    if isinstance(value, bool) or type(value).__name__ == "bool_":  # NumPy's truth value is a number too
        raise DescriptionError(f"{where}: expected a number, got the truth value {value}")
    if isinstance(value, str):
        return parse(value, names, where=where)
    if isinstance(value, sympy.Basic):
        return _checked_sympy(value, names or {}, where)
    if isinstance(value, Integral):
        number = int(value)
        return sympy.Integer(number) if number.bit_length() <= MAX_BITS else _too_large(where)
    if isinstance(value, Fraction):
        return _limited(sympy.Rational(value.numerator, value.denominator), where)
    if isinstance(value, Decimal | float) or hasattr(value, "__float__"):
        decimal = value if isinstance(value, Decimal) else _number_of(value)
        if decimal is not None:
            return _from_decimal(decimal, where)
    raise DescriptionError(
        f"{where}: expected a number or a text with an expression, got {shorten(value)} ({type(value).__name__})"
    )


def _number_of(value: SupportsFloat) -> float | None:
    """What bears `__float__` as a number; None of a class, of an array of several numbers."""
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        return None


@lru_cache(maxsize=8192)  # as many as `sixty_digits`
def to_text(expression: sympy.Expr) -> str:
    """`expression` in the grammar of `parse`; the inverse of `parse` for everything it returns.

    >>> to_text(parse("sqrt(3)/10"))
    'sqrt(3)/10'
    """
    return _GrammarPrinter().doprint(expression)


def numeric(expression: sympy.Expr, *, where: str = "number") -> sympy.Float | sympy.Integer:
    """Value of a constant expression to 60 digits; raises DescriptionError unless real and finite."""
    value = expression if expression.is_Integer else sixty_digits(expression)
    if value.is_number and value.is_real and value.is_finite:
        return value
    raise DescriptionError(
        f"{where}: expected a real finite number, got {shorten(str(expression))} = {shorten(str(value))}"
    )


class _GrammarPrinter(_Printer):
    """SymPy's text with the names of our grammar, and products that SymPy builds up again unchanged.

    Reading goes from left to right, and SymPy multiplies a number into a sum at once. So a number never
    meets a sum alone: other factors stand between, and denominators are divided by one at a time.
    """

    def _print_Exp1(self, expr: object) -> str:  # noqa: N802
        return "exp(1)"

    def _print_Abs(self, expr: sympy.Abs) -> str:  # noqa: N802
        return f"abs({self._print(expr.args[0])})"

    def _print_Mul(self, expr: sympy.Mul) -> str:  # noqa: N802
        number, rest = expr.as_coeff_Mul()
        above, below = [], []
        for factor in sympy.Mul.make_args(rest):
            if factor.is_Pow and factor.exp.is_Rational and factor.exp.is_negative:
                below.append(sympy.Pow(factor.base, -factor.exp, evaluate=False))
            else:
                above.append(factor)
        above.sort(key=lambda factor: factor.is_Add)
        level = PRECEDENCE["Mul"]
        factors = [self.parenthesize(factor, level) for factor in above]
        divisors = [f"/{self.parenthesize(divisor, level)}" for divisor in below]
        quotient = f"/{number.q}" if number.q != 1 else ""
        if above and above[0].is_Add:
            times = f"*({number.p})" if number.p != 1 else ""
            return "*".join(factors) + "".join(divisors) + times + quotient
        sign, size = ("-" if number.is_negative else ""), abs(number.p)
        if size != 1 or not factors:
            factors.insert(0, str(size))
        return sign + "*".join(factors) + quotient + "".join(divisors)


def _from_decimal(value: Decimal | float, where: str) -> sympy.Expr:
    number = value if isinstance(value, Decimal) else Decimal(repr(value))
    if not number.is_finite():
        raise DescriptionError(f"{where}: expected a finite number, got {value}")
    _, digits, exponent = number.as_tuple()
    if len(digits) > 4000 or abs(int(exponent) + len(digits)) > MAX_POWER_OF_TEN:
        _too_large(where)
    return _limited(sympy.Rational(*number.as_integer_ratio()), where)


def _checked_sympy(value: sympy.Basic, names: Mapping[str, sympy.Expr], where: str) -> sympy.Expr:
    if not isinstance(value, sympy.Expr):
        raise DescriptionError(f"{where}: expected an expression, got {shorten(value)}")
    if value.has(sympy.Float):
        raise DescriptionError(
            f"{where}: expected an exact expression, got {shorten(value)} with floating-point numbers in it; "
            "use Rational or give the number as text"
        )
    replacement = {}
    for symbol in value.free_symbols:
        name = str(symbol)
        if name not in names:
            raise DescriptionError(f"{where}: unknown name {name!r}; {did_you_mean(name, names)}")
        replacement[symbol] = names[name]
    return _limited_throughout(value.xreplace(replacement), where)


def _too_large(where: str) -> NoReturn:
    raise DescriptionError(
        f"{where}: the number is too large or too long; at most 4000 digits, powers of ten up to {MAX_POWER_OF_TEN}"
    )


def _limited(value: sympy.Expr, where: str) -> sympy.Expr:
    """`value`, after a look at its top only: infinities and large numbers come up there first."""
    if type(value) in UNBOUNDED:
        raise DescriptionError(f"{where}: expected a finite number, got {value} (division by zero?)")
    for number in (value, *value.args) if not value.is_Atom else (value,):
        if number is sympy.I:
            raise DescriptionError(f"{where}: expected a real number, got {shorten(str(value))}")
        if number.is_Rational and max(number.p.bit_length(), number.q.bit_length()) > MAX_BITS:
            _too_large(where)
    return value


def _limited_throughout(value: sympy.Expr, where: str) -> sympy.Expr:
    if node_count(value) > MAX_NODES:
        raise DescriptionError(
            f"{where}: the expression has more than {MAX_NODES} terms once its parameters are put in"
        )
    for node in sympy.preorder_traversal(value):
        _limited(node, where)
    return value


def node_count(expression: sympy.Expr) -> int:
    """Number of nodes of the expression as a tree, shared parts counted every time."""
    counts: dict[sympy.Basic, int] = {}
    stack: list[sympy.Basic] = [expression]
    while stack:
        node = stack[-1]
        open_arguments = [a for a in node.args if a not in counts]
        if open_arguments:
            stack.extend(open_arguments)
            continue
        counts[stack.pop()] = 1 + sum(counts[a] for a in node.args)
    return counts[expression]


class _Parser:
    """Recursive descent over the tokens of one text."""

    def __init__(self, text: str, names: Mapping[str, sympy.Expr], where: str) -> None:
        self.text, self.names, self.where = text, names, where
        if len(text) > MAX_LENGTH:
            raise DescriptionError(f"{where}: the expression has {len(text)} characters; at most {MAX_LENGTH} are read")
        self.tokens = self._tokenise()
        self.position = 0
        self.depth = 0

    def run(self) -> sympy.Expr:
        if not self.tokens:
            self._fail("expected a number or an expression, got an empty text")
        value = self._sum()
        if self.position < len(self.tokens):
            self._fail(f"expected an operator or the end, got {self._peek()!r}")
        return _limited_throughout(value, self.where)

    def _tokenise(self) -> list[tuple[str, str]]:
        tokens, position, end = [], 0, len(self.text.rstrip())
        while position < end:
            match = _TOKEN.match(self.text, position)
            if match is None or match.lastgroup is None:
                rest = self.text[position:].lstrip()
                self._fail(
                    f"cannot read {shorten(rest[:20])}; an expression has numbers, + - * / ^, parentheses, "
                    "pi, the names of parameters and " + ", ".join(FUNCTIONS)
                )
            tokens.append((match.lastgroup, match.group(match.lastgroup)))
            position = match.end()
        return tokens

    def _fail(self, message: str) -> NoReturn:
        raise DescriptionError(f"{self.where}: {message} (in {shorten(self.text)})")

    def _peek(self) -> str | None:
        return self.tokens[self.position][1] if self.position < len(self.tokens) else None

    def _accept(self, *operators: str) -> str | None:
        token = self._peek()
        if token in operators:
            self.position += 1
            return token
        return None

    def _expect(self, operator: str) -> None:
        if not self._accept(operator):
            self._fail(f"expected {operator!r}, got {self._peek() or 'the end'!r}")

    def _sum(self) -> sympy.Expr:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            self._fail(f"nested more than {MAX_DEPTH} deep")
        value = self._product()
        while operator := self._accept("+", "-"):
            term = self._product()
            value = _limited(value + term if operator == "+" else value - term, self.where)
        self.depth -= 1
        return value

    def _product(self) -> sympy.Expr:
        value = self._signed()
        while operator := self._accept("*", "/"):
            factor = self._signed()
            if operator == "/" and factor.is_zero:
                self._fail("division by zero")
            value = _limited(value * factor if operator == "*" else value / factor, self.where)
        return value

    def _signed(self) -> sympy.Expr:
        negative = False
        while sign := self._accept("+", "-"):
            negative ^= sign == "-"
        value = self._power()
        return -value if negative else value

    def _power(self) -> sympy.Expr:
        base = self._atom()
        if not self._accept("^", "**"):
            return base
        self.depth += 1
        if self.depth > MAX_DEPTH:
            self._fail(f"nested more than {MAX_DEPTH} deep")
        exponent = self._signed()
        self.depth -= 1
        if not exponent.is_Rational or max(abs(exponent.p), exponent.q) > MAX_EXPONENT:
            self._fail(
                f"expected an exponent that is a fraction with parts up to {MAX_EXPONENT}, got {shorten(str(exponent))}"
            )
        if base.is_zero and exponent.is_negative:
            self._fail("division by zero")
        if base.is_Rational and abs(exponent) * max(base.p.bit_length(), base.q.bit_length()) > MAX_BITS:
            _too_large(self.where)
        power = _limited(base**exponent, self.where)
        if power.is_Pow and power.exp.is_Rational and abs(power.exp) > MAX_EXPONENT:
            self._fail(f"expected exponents up to {MAX_EXPONENT}, got {shorten(str(power.exp))}")
        return power

    def _atom(self) -> sympy.Expr:
        if self._accept("("):
            value = self._sum()
            self._expect(")")
            return value
        if self.position >= len(self.tokens):
            self._fail("expected a number, a name or '(', got the end")
        kind, token = self.tokens[self.position]
        if kind == "operator":
            self._fail(f"expected a number, a name or '(', got {token!r}")
        self.position += 1
        if kind == "number":
            return _from_decimal(Decimal(token), self.where) if len(token) <= 4500 else _too_large(self.where)
        if token in FUNCTIONS:
            return self._call(token)
        if token in CONSTANTS:
            return CONSTANTS[token]
        if token not in self.names:
            known = [*self.names, *CONSTANTS, *FUNCTIONS]
            self._fail(f"unknown name {token!r}; {did_you_mean(token, known)}")
        return self.names[token]

    def _call(self, function: str) -> sympy.Expr:
        count, make = FUNCTIONS[function]
        self._expect("(")
        arguments = [self._sum()]
        while self._accept(","):
            arguments.append(self._sum())
        self._expect(")")
        if len(arguments) != count:
            self._fail(f"{function} takes {count} argument{'s' * (count > 1)}, got {len(arguments)}")
        if function == "exp" and arguments[0].is_number and abs(sympy.N(arguments[0])) > MAX_EXP_ARGUMENT:
            self._fail(f"expected an argument of exp between -{MAX_EXP_ARGUMENT} and {MAX_EXP_ARGUMENT}")
        return _limited(make(*arguments), self.where)
