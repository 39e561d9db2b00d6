"""The tape: every derived quantity, defined once over earlier ones.

    nodes:  0: 0 | 1: 1 | 2: neg 1 | 3: symbol x | 4: symbol y | 5: mul 3 4 | 6: add 3 5 ...

A node is one operation on earlier nodes. Making a node folds what can be folded at once: zeros, ones,
constants, signs; equal nodes are one node (hash-consing, normalised so that a - b and b - a share). So an
expression stays one operation deep whatever the size of the mechanism, structural zeros vanish while
deriving, and a program is a walk over the tape.

Constants carry 60 digits; a constant below 1e-45 is zero. Besides its definition a node has values at a
few sample states (`Tape.set_samples`), which is how eliminations choose pivots that do not vanish.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from threading import RLock
from typing import Any

import mpmath
import numpy as np
import sympy

from symscrew.algebra.operations import CONTEXT, apply_high_precision, at_samples, evaluate_constant, high_precision
from symscrew.algebra.origins import Origin

# Constants carry 60 digits, and a derivation loses a few of them. What is left of a zero is 1e-58 or so, and the
# smallest constant that somebody means is far above 1e-45: in between a constant is zero.
ZERO_BITS = -149  # 2^-149, about 1e-45
ZERO_BELOW = CONTEXT.mpf(2) ** ZERO_BITS
KEY_BITS = 150  # constants that agree to 45 digits are one constant; any that differ by more stay apart

UNITS = (0, 1)  # factors that take no operation
WAITS = frozenset(("reciprocal", "sqrt"))  # operations for which others wait
SUMS, FACTORS = frozenset(("add", "sub")), frozenset(("mul", "reciprocal"))


@dataclass(frozen=True)
class Symbol:
    """An input of the model: unique name, unit (SI, as text), what it is, and what SymPy may assume of it."""

    name: str
    unit: str
    description: str
    assumptions: tuple[tuple[str, bool], ...] = (("real", True),)

    @property
    def sympy(self) -> sympy.Symbol:
        """The SymPy symbol of this input."""
        return sympy.Symbol(self.name, **dict(self.assumptions))


class Node:
    """One operation on earlier nodes of the same tape; use + - * / on nodes and numbers.

    `chain` is how many divisions and roots there are in the longest chain of them behind it, itself included.
    """

    __slots__ = ("args", "chain", "index", "op", "tape", "value")

    def __init__(
        self, tape: Tape, index: int, op: str, args: tuple[Any, ...], *, value: Any = None, chain: int = 0
    ) -> None:
        self.tape, self.index, self.op, self.args, self.value, self.chain = tape, index, op, args, value, chain

    def __add__(self, other: Any) -> Node:
        if type(other) is Node:
            if not other.index:  # zero, as four operands in five
                return self
            return self.tape.add(self, other) if self.index else other
        if type(other) is int and other == 0:  # structural: most vectors have some
            return self
        return self.tape.add(self, self.tape.node(other))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Node:
        if type(other) is not Node:
            other = self.tape.node(other)
        if not other.index:
            return self
        negative = self.tape.neg(other)
        return self.tape.add(self, negative) if self.index else negative

    def __rsub__(self, other: Any) -> Node:
        return self.tape.add(self.tape.node(other), self.tape.neg(self))

    def __mul__(self, other: Any) -> Node:
        if type(other) is Node:
            if self.index < 2:  # zero or one
                return other if self.index else self
            if other.index < 2:
                return self if other.index else other
            return self.tape.mul(self, other)
        if type(other) is int and other in UNITS:
            return self if other else self.tape.zero
        return self.tape.mul(self, self.tape.node(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Node:
        return self.tape.mul(self, self.tape.reciprocal(self.tape.node(other)))

    def __rtruediv__(self, other: Any) -> Node:
        return self.tape.mul(self.tape.node(other), self.tape.reciprocal(self))

    def __neg__(self) -> Node:
        return self.tape.neg(self)

    def __repr__(self) -> str:
        if self.value is not None:
            return f"Node({mpmath.nstr(self.value, 12)})"
        if self.op == "symbol":
            return f"Node({self.args[0].name})"
        return f"Node({self.op} {' '.join(str(a.index) for a in self.args)})"


class Tape:
    """Makes and keeps nodes. One tape serves one model; the order of nodes is an order of evaluation."""

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.constants: dict[Node, float] = {}  # those that are not negative, in the order of the tape, as doubles
        self._known: defaultdict[str, dict[Any, Node]] = defaultdict(dict)  # by operation and operands
        self._negatives: dict[Node, Node] = {}
        self._folded: dict[tuple[str, int, int], Node] = {}
        self._samples: dict[int, np.ndarray] = {}
        self.magnitudes: dict[tuple[int, float], tuple[float, float]] = {}  # at the samples, by node and unit scale
        self.counted: tuple[tuple[Node, ...], Mapping[int, int]] | None = None  # see `uses`: what was counted last
        self._parameter_values: list[dict[int, Any]] = []
        self._settled: dict[int, Node] = {}
        self.symbols: dict[str, Node] = {}
        self.origins: dict[int, Origin] = {}  # of nodes by index, of a negative's inner one
        self.lock = RLock()  # for who has the tape as it was, and who walks over all of it: see `tape_as_at`
        self.zero = self.constant(0)  # node 0, and one is node 1: sums and products look at these numbers
        self.one = self.constant(1)
        self._small = {0: self.zero, 1: self.one, -1: self.neg(self.one)}

    def __repr__(self) -> str:
        return f"Tape({len(self.nodes)} nodes, {len(self.symbols)} inputs)"

    def tables(self) -> dict[str, dict[Any, Any]]:
        """All that grows with the nodes, by name, each in the order of making: see `symscrew.algebra.tape_marks`."""
        tables: dict[str, dict[Any, Any]] = {"negatives": self._negatives, "folded": self._folded}
        tables |= {"constants": self.constants, "origins": self.origins}
        return tables | self._known

    # -- making nodes ---------------------------------------------------------------------------------

    def symbol(self, name: str, unit: str, description: str) -> Node:
        """The input of this name; asking again gives the same node."""
        if name not in self.symbols:
            self.symbols[name] = self._make("symbol", (Symbol(name, unit, description),))
        return self.symbols[name]

    def node(self, value: Any) -> Node:
        """`value` as a node: a node, a number, or an exact SymPy number."""
        if isinstance(value, Node):
            return value
        if isinstance(value, int):
            return self._small.get(value) or self.constant(value)
        return self.constant(value)

    def constant(self, value: Any, exact: Any = None) -> Node:
        """The constant `value` (int, mpf, SymPy number); `exact` says how to print it exactly."""
        if isinstance(value, sympy.Basic):
            exact = value
            value = high_precision(value)
        number = value if isinstance(value, CONTEXT.mpf) else CONTEXT.mpf(value)
        sign, mantissa, exponent, bits = number._mpf_
        if not mantissa and exponent:
            raise ZeroDivisionError("a constant of the model is not finite: check the geometry for a division by 0")
        if exponent + bits < ZERO_BITS:
            sign, number = 0, CONTEXT.zero
        if sign:
            inner = self.constant(-number, None if exact is None else _negative(exact))
            return self._make("neg", (inner,), number)
        known, key = self._known["const"], _rounded(number)
        found = known.get(key)
        if found is None:
            known[key] = found = Node(self, len(self.nodes), "const", (exact,), value=number)
            self.nodes.append(found)
            self.constants[found] = float(number)
        return found

    def double(self, constant: Node) -> float:
        """The value of a constant in double precision."""
        return -self.constants[constant.args[0]] if constant.op == "neg" else self.constants[constant]

    def neg(self, x: Node) -> Node:
        """-x."""
        found = self._negatives.get(x)
        if found is None:
            if x.op == "neg":
                found = x.args[0]
            elif x is self.zero:
                found = x
            else:
                found = self._make("neg", (x,), None if x.value is None else -x.value)
            self._negatives[x] = found
        return found

    def add(self, x: Node, y: Node) -> Node:
        """x + y; differences and sums of negatives are normalised, and in (u + v) - u and the like u is left out."""
        if x is self.zero:
            return y
        if y is self.zero:
            return x
        if x.value is not None and y.value is not None:
            return self._fold("add", x, y)
        if x.value is not None or y.value is not None:
            merged = self._merge_constant(*((x, y) if x.value is not None else (y, x)))
            if merged is not None:
                return merged
        x_negative, y_negative = x.op == "neg", y.op == "neg"
        a, b = (x.args[0] if x_negative else x), (y.args[0] if y_negative else y)
        if a is b:
            return self.zero if x_negative != y_negative else self.mul(self.node(-2 if x_negative else 2), a)
        inverted = x_negative if x_negative == y_negative else b.index < a.index if y_negative else a.index < b.index
        op, args = "add" if x_negative == y_negative else "sub", (a, b) if a.index < b.index else (b, a)
        known = self._known[op]
        total = known.get(args)
        if total is None:
            rest = self._left_of(a, x_negative, b, y_negative) if a.op in SUMS or b.op in SUMS else None
            if rest is not None:
                return rest
            total = self._new(known, op, args)
        return self.neg(total) if inverted else total

    def _left_of(self, a: Node, a_negative: bool, b: Node, b_negative: bool) -> Node | None:
        """What is left of (u + v) - u and the like; None of other sums."""
        for whole, inverted, part, sign in ((a, a_negative, b, b_negative), (b, b_negative, a, a_negative)):
            if whole.op in SUMS:
                terms = [(whole.args[0], inverted), (whole.args[1], inverted != (whole.op == "sub"))]
                if (part, not sign) in terms:
                    rest, negative = terms[1 - terms.index((part, not sign))]
                    return self.neg(rest) if negative else rest
        return None

    def _fold(self, op: str, x: Node, y: Node) -> Node:
        """The sum or product of two constants, computed once."""
        key = (op, x.index, y.index) if x.index < y.index else (op, y.index, x.index)
        if key not in self._folded:
            value = x.value + y.value if op == "add" else x.value * y.value
            self._folded[key] = self.constant(value, (op, x, y))
        return self._folded[key]

    def _merge_constant(self, constant: Node, other: Node) -> Node | None:
        """constant + (constant2 +- y) as (constant + constant2) +- y, or None if `other` has no constant."""
        negative = other.op == "neg"
        inner = other.args[0] if negative else other
        if inner.op not in ("add", "sub"):
            return None
        first, second = inner.args
        if inner.op == "sub":
            second = self.neg(second)
        if first.value is None:
            first, second = second, first
        if first.value is None:
            return None
        if negative:
            first, second = self.neg(first), self.neg(second)
        return self.add(self.add(constant, first), second)

    def mul(self, x: Node, y: Node) -> Node:
        """x y; signs move outwards, constants together."""
        if x is self.zero or y is self.zero:
            return self.zero
        if x.value is not None and y.value is not None:
            return self._fold("mul", x, y)
        negative = False
        if x.op == "neg":
            x, negative = x.args[0], True
        if y.op == "neg":
            y, negative = y.args[0], not negative
        if y.value is not None:
            x, y = y, x
        if x is self.one:
            return self.neg(y) if negative else y
        if x.value is not None and y.op == "mul" and y.args[0].value is not None:
            x, y = self.mul(x, y.args[0]), y.args[1]
            if x is self.one:
                return self.neg(y) if negative else y
        args = (y, x) if x.value is None and y.index < x.index else (x, y)
        known = self._known["mul"]
        result = known.get(args)
        if result is None:
            rest = self._cancelled(x, y) if x.op in FACTORS or y.op in FACTORS else None
            result = rest or self._new(known, "mul", args)
        return self.neg(result) if negative else result

    def _cancelled(self, x: Node, y: Node) -> Node | None:
        """z of x (z / x) or (x z) / x; None if nothing cancels."""
        for a, b in ((x, y), (y, x)):
            factors = b.args if b.op == "mul" else (b,)
            inverse = a.args[0] if a.op == "reciprocal" else None
            for factor in factors:
                if factor is inverse or (factor.op == "reciprocal" and factor.args[0] is a):
                    return self.one if b is factor else factors[factor is factors[0]]
        return None

    def reciprocal(self, x: Node) -> Node:
        """1 / x; shared, so that several quotients by x cost one division."""
        if x.value is not None:
            if x.value == 0:
                raise ZeroDivisionError("the model divides by a structural zero: check the geometry")
            return self.constant(1 / x.value, ("reciprocal", x))
        if x.op == "neg":
            return self.neg(self.reciprocal(x.args[0]))
        if x.op == "reciprocal":
            inner: Node = x.args[0]
            return inner
        return self._make("reciprocal", (x,))

    def function(self, name: str, *args: Any) -> Node:
        """sqrt, exp, sin, cos, tan, atan2, abs, less (1 if x < y else 0), select (condition, if true, if false)."""
        nodes = tuple(self.node(a) for a in args)
        if name in ("sin", "cos") and nodes[0].op == "neg":
            inner = self.function(name, nodes[0].args[0])
            return self.neg(inner) if name == "sin" else inner
        if name == "abs" and nodes[0].op == "neg":
            nodes = nodes[0].args
        if all(n.value is not None for n in nodes):
            return self.constant(evaluate_constant(name, [n.value for n in nodes]), (name, *nodes))
        if name == "select" and nodes[1] is nodes[2]:
            return nodes[1]
        return self._make(name, nodes)

    def sqrt(self, x: Any) -> Node:
        """The square root of x."""
        return self.function("sqrt", x)

    def _make(self, op: str, args: tuple[Any, ...], value: Any = None) -> Node:
        known = self._known[op]
        found = known.get(args)  # nodes are equal if they are one
        return self._new(known, op, args, value) if found is None else found

    def _new(self, known: dict[Any, Node], op: str, args: tuple[Any, ...], value: Any = None) -> Node:
        """A node that is not among the known ones."""
        chain = 0
        if value is None and op != "symbol":
            for arg in args:
                if arg.chain > chain:
                    chain = arg.chain
            chain += op in WAITS
        nodes = self.nodes
        known[args] = made = Node(self, len(nodes), op, args, value=value, chain=chain)
        nodes.append(made)
        return made

    # -- values at samples ----------------------------------------------------------------------------

    def set_samples(self, values: Mapping[Node, np.ndarray]) -> None:
        """Give inputs their values at the sample states (arrays of one length); forgets earlier ones."""
        self._samples = {node.index: np.asarray(v, dtype=float) for node, v in values.items()}
        self.magnitudes = {}

    def add_samples(self, values: Mapping[Node, np.ndarray]) -> None:
        """Give further inputs their values, beside those that have some."""
        self._samples.update({node.index: np.asarray(v, dtype=float) for node, v in values.items()})

    def hide_samples(self) -> dict[int, np.ndarray]:
        """Forget all values, and return them for `show_samples`."""
        hidden, self._samples = self._samples, {}
        return hidden

    def show_samples(self, values: dict[int, np.ndarray]) -> None:
        """Have the values again that were hidden."""
        self._samples = values

    def sample(self, node: Node) -> np.ndarray:
        """Values of `node` at the sample states, shape (samples,); not finite where a division by zero is asked for."""
        known = self._samples
        if node.index not in known:
            with np.errstate(all="ignore"):
                _evaluate(node, known, lambda constant: np.asarray(self.double(constant)), at_samples)
        return known[node.index]

    # -- identities in the run-time parameters ---------------------------------------------------------

    def set_parameter_trials(self, trials: list[dict[Node, Any]]) -> None:
        """Several sets of values of the run-time parameters, on which `settle` tests identities."""
        self._parameter_values = [{n.index: CONTEXT.mpf(v) for n, v in trial.items()} for trial in trials]
        self._settled = {}

    def nominal(self, value: Any) -> float:
        """A node of constants and run-time parameters at the first trial; the sample states are left as they are."""
        return float(in_sixty_digits([self.node(value)], next(iter(self._parameter_values), {}))[0])

    def settle(self, value: Any) -> Node:
        """`value` as a node, or the constant that it equals (to 45 digits) for every trial of the run-time parameters.

        For nodes of constants and run-time parameters only: geometry given in parameters has zeros that
        hold for all their values but that no local rule sees.
        """
        node: Node = self.node(value)
        if node.value is not None or not self._parameter_values:
            return node
        if node.index not in self._settled:
            values = [in_sixty_digits([node], trial)[0] for trial in self._parameter_values]
            spread = max(abs(v - values[0]) for v in values)
            same = spread < ZERO_BELOW * (1 + abs(values[0]))
            self._settled[node.index] = self.constant(values[0]) if same else node
        return self._settled[node.index]


def is_zero(entry: Node | int) -> bool:
    """Whether an entry is always zero."""
    return entry == 0 if isinstance(entry, int) else entry is entry.tape.zero


def _rounded(number: Any) -> Any:
    """The number to `KEY_BITS` bits, as a key."""
    return mpmath.libmp.mpf_pos(number._mpf_, KEY_BITS, "n")


def _negative(exact: Any) -> Any:
    return -exact if isinstance(exact, sympy.Basic) else ("neg_of", exact)


def in_sixty_digits(nodes: Sequence[Node], inputs: Mapping[int, Any]) -> list[Any]:
    """Values of nodes for values of the inputs by index, all of them numbers of `CONTEXT`."""
    done: dict[int, Any] = dict(inputs)
    for node in nodes:
        _evaluate(node, done, lambda constant: constant.value, apply_high_precision)
    return [done[node.index] for node in nodes]


def _evaluate(
    node: Node, known: dict[int, Any], number: Callable[[Node], Any], apply: Callable[[str, list[Any]], Any]
) -> None:
    """Put the value of a node, and of all behind it that has none yet, among what is known by index."""
    stack = [node]
    while stack:
        current = stack[-1]
        if current.index in known:
            stack.pop()
        elif current.value is not None:
            known[current.index] = number(current)
        elif current.op == "symbol":
            raise KeyError(f"input {current.args[0].name} has no sample values yet")
        else:
            missing = [a for a in current.args if a.index not in known]
            if missing:
                stack.extend(missing)
            else:
                known[current.index] = apply(current.op, [known[a.index] for a in current.args])
