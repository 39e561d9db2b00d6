"""Smooth parts near the configuration, by exact algebra, with what lets others check them without it.

    loops in tangents of half the angles --Singular: minimal primes--> those through the configuration, smooth there
    products of their equations, times a unit --division, lifted--> combinations of the loops' polynomials

The unit is made of equations of the components elsewhere and of what no configuration fulfils, as few as do. Where the
minimal primes are not found, the parts that factors of a Groebner basis tell apart may do, with a unit of an ideal
quotient. What the program says is believed by nobody: the checker multiplies out.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from itertools import permutations
from typing import Any

from symscrew.mobility.components import algebra_answer
from symscrew.mobility.proofs.proof_checker import Block, Polynomial, closed, polynomial
from symscrew.mobility.proofs.proof_numbers import ProofNumbers, encoded
from symscrew.mobility.proofs.rank_proofs import rank_entry
from symscrew.mobility.symbols import Exact, Generator, generator_itself, terms_of

SECONDS = 10.0
"""Of the processor: those of the tests end in half of it."""
MOST_UNKNOWNS = 16
"""Tangents: of more, exact algebra ends within no reasonable time."""
LARGEST = 3_000_000
"""Letters of what the program prints: evidence that takes longer to read than to believe is none."""
TERM = re.compile(r"[-+]?(?:\([^()]*\)|[^-+()])+")
"""A term of a printed polynomial: signs within brackets do not end it."""
SMOOTH_PARTS = """\
for (i = size(through); i >= 1; i--) {
  for (j = size(through); j >= 1; j--) {
    if (j != i and i <= size(through)) {
      if (size(reduce(through[j], through[i])) == 0) { through = delete(through, i); }
    }
  }
}
units = simplify(units, 2 + 4) + never;
list parts;
for (i = 1; i <= size(through); i++) {
  ideal own;
  for (j = 1; j <= size(through[i]); j++) {
    if (size(interred(jet(own + ideal(through[i][j]), 1))) > size(own)) {
      own = simplify(own + ideal(through[i][j]), 2);
    }
  }
  parts[i] = own;
  print("@part"); for (j = 1; j <= size(own); j++) { print(string(own[j])); }
  kill own;
}
option(noredSB);
"""
"""Parts through the origin, none within another, and of each as many equations as are independent there."""
COMBINATIONS = """\
proc without(poly p, ideal G, ideal units, int divided) {
  int i; int j; ideal used; poly q = p; poly d;
  for (i = 1; i <= size(units) and q != 0; i++) { q = reduce(q * units[i], G); used[i] = units[i]; }
  if (q != 0) {
    if (divided) { return(poly(0)); }
    ideal Q = std(quotient(G, ideal(p)));
    for (i = 1; i <= size(Q); i++) {
      if (jet(Q[i], 0) != 0 and (d == 0 or size(Q[i]) < size(d))) { d = Q[i]; }
    }
    return(d);
  }
  for (i = size(used); i >= 1; i--) {
    d = used[i]; used[i] = 1; q = p;
    for (j = 1; j <= ncols(used); j++) { if (used[j] != 0) { q = reduce(q * used[j], G); } }
    if (q != 0) { used[i] = d; }
  }
  q = 1; for (j = 1; j <= ncols(used); j++) { if (used[j] != 0) { q = q * used[j]; } }
  return(q);
}
proc shown(poly p, int power, poly unit, ideal G, matrix T) {
  int i; list found = division(unit * p, G); matrix W = T * found[1];
  print("@shown " + string(power)); print(string(unit));
  for (i = 1; i <= nrows(W); i++) { print(string(W[i, 1])); }
}
poly p; poly unit; int e;
for (i = 1; i <= size(parts); i++) {
  matrix T; ideal G = liftstd(parts[i], T);
  for (j = 1; j <= size(closure); j++) { shown(closure[j], 1, without(closure[j], std(G), units, divided), G, T); }
  kill T; kill G;
}
matrix T; ideal G = liftstd(closure, T); ideal S = std(closure); unit = 0;
ideal all = 1; for (i = 1; i <= size(parts); i++) {
  ideal wider;
  for (j = 1; j <= ncols(all); j++) {
    for (k = 1; k <= ncols(parts[i]); k++) { wider[(j - 1) * ncols(parts[i]) + k] = all[j] * parts[i][k]; }
  }
  all = wider; kill wider;
}
for (i = 1; i <= ncols(all); i++) {
  unit = 0; p = 1;
  for (e = 1; e <= 4 and unit == 0; e++) { p = p * all[i]; unit = without(p, S, units, divided); }
  if (unit == 0) { quit; }
  shown(p, e - 1, unit, G, T);
}
print("@end");
quit;
"""
"""Polynomials of the loops as combinations of a part's, products of these as combinations of the loops', with units."""


def parts_proof(numbers: ProofNumbers, block: Block, seconds: float = SECONDS) -> dict[str, Any] | None:
    """The proof `parts` of a block, for the checker to judge; None where exact algebra finds none in the time."""
    system, count = numbers.system, len(block.columns)
    if system is None or block.ties or not 0 < count <= MOST_UNKNOWNS or len(system.field.generators) > 1:
        return None
    loops = [closed(numbers.read.numbers, factors, count) for factors in block.factors]
    for divided in (True, False):
        answer = algebra_answer(_script(numbers, loops, count, divided=divided), seconds / 2)
        if answer is not None and answer[1] and len(answer[0]) <= LARGEST:
            return _read(numbers, answer[0], count)
    return None


def _script(numbers: ProofNumbers, loops: Sequence[Sequence[Polynomial]], count: int, *, divided: bool) -> str:
    assert numbers.system is not None
    generators = numbers.system.field.generators
    names = [f"v{k + 1}" for k in range(count)]
    modulus = ""
    if generators:
        low = [f"({c})*a^{k}" for k, c in enumerate(generators[0].modulus) if c]
        modulus = f"minpoly = a^{generators[0].degree}+{'+'.join(low)};"

    def text(p: Polynomial) -> str:
        terms = []
        for key, number in p.items():
            powers = [f"{name}^{power}" for name, power in zip(names, key, strict=True) if power]
            for inner, rational in terms_of(numbers.exact(number), generators).items():
                terms.append("*".join([f"({rational})", *(f"a^{e}" for e in inner if e), *powers]))
        return "+".join(terms)

    zero = "".join(f", {name}, 0" for name in names)
    return f"""
LIB "primdec.lib";
ring r = {"(0,a)" if generators else "0"}, ({",".join(names)}), dp; {modulus}
option(redSB); short = 0;
int i; int j; int k;
ideal closure = {", ".join(text(p) for loop in loops for p in loop[1:] if p)};
list through; ideal never = {", ".join(text(loop[0]) for loop in loops)}; ideal units;
list pieces = facstd(closure, never);
for (i = 1; i <= size(pieces); i++) {{
  list minimal = {"minAssGTZ(pieces[i])" if divided else "list(pieces[i])"};
  for (j = 1; j <= size(minimal); j++) {{
    ideal K = std(minimal[j]);
    if (size(subst(K{zero})) == 0) {{ through[size(through) + 1] = K; }} else {{
      poly best;
      for (k = 1; k <= size(K); k++) {{
        if (jet(K[k], 0) != 0 and (best == 0 or size(K[k]) < size(best))) {{ best = K[k]; }}
      }}
      units = units + ideal(best); kill best;
    }}
    kill K;
  }}
  kill minimal;
}}
{SMOOTH_PARTS}int divided = {int(divided)};
{COMBINATIONS}"""


def _read(numbers: ProofNumbers, output: str, count: int) -> dict[str, Any] | None:
    """The parts and combinations printed, as the file has them; None where no part goes through the configuration."""
    assert numbers.system is not None
    generators = numbers.system.field.generators
    blocks = re.split(r"^@", output, flags=re.MULTILINE)[1:]

    def read(line: str) -> list[list[Any]]:
        return _polynomial(line, generators, count)

    given = [[read(line) for line in block.splitlines()[1:]] for block in blocks if block.startswith("part")]
    shown = []
    for block in (block for block in blocks if block.startswith("shown ")):
        head, unit, *factors = block.splitlines()
        shown.append({"power": int(head.split()[1]), "unit": read(unit), "factors": [read(f) for f in factors]})
    if not given:
        return None
    slopes = [[[_linear(numbers, p, k, count) for k in range(count)] for p in part] for part in given]
    equations = (len(shown) - _choices(given)) // len(given)
    parts = [
        {"equations": part, "minor": rank_entry(numbers, rows)["minor"],
         "closure": shown[k * equations : (k + 1) * equations]}
        for k, (part, rows) in enumerate(zip(given, slopes, strict=True))
    ]  # fmt: skip
    apart = [
        {"parts": [a, b], "minor": rank_entry(numbers, [*slopes[a], *slopes[b]])["minor"]}
        for a, b in permutations(range(len(given)), 2)
    ]
    return {"kind": "parts", "parts": parts, "apart": apart, "products": shown[len(given) * equations :]}


def _choices(parts: Sequence[Sequence[Any]]) -> int:
    found = 1
    for part in parts:
        found *= len(part)
    return found


def _linear(numbers: ProofNumbers, p: list[list[Any]], column: int, count: int) -> Any:
    read = numbers.read.numbers
    return polynomial(read, p, count).get(tuple(int(k == column) for k in range(count)), read.zero)


def _polynomial(line: str, generators: Sequence[Generator], count: int) -> list[list[Any]]:
    """A printed polynomial as the file has it."""
    terms: dict[tuple[int, ...], Exact] = {}
    for term in TERM.findall(line):
        value: Exact = Fraction(-1 if term[0] == "-" else 1)
        key = [0] * count
        for factor in re.split(r"\*(?![^(]*\))", term.lstrip("+-")):
            base, _, power = factor.partition("^")
            if base[0] == "v":
                key[int(base[1:]) - 1] += int(power or 1)
            elif factor[0] == "(":
                inner = [_number(part, generators) for part in TERM.findall(factor[1:-1])]
                value = value * sum(inner[1:], inner[0])
            else:
                value = value * _number(factor, generators)
        terms[tuple(key)] = terms[tuple(key)] + value if tuple(key) in terms else value
    return [[encoded(c, list(generators)), *key] for key, c in terms.items() if c]


def _number(term: str, generators: Sequence[Generator]) -> Exact:
    """A product of fractions and powers of the field's generator `a`."""
    value: Exact = Fraction(-1 if term[0] == "-" else 1)
    for factor in term.lstrip("+-").split("*"):
        base, _, power = factor.partition("^")
        for _ in range(int(power or 1)):
            value = value * (generator_itself(generators[0]) if base == "a" else Fraction(base))
    return value
