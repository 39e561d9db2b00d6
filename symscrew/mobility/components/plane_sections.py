"""Whether a part is irreducible, by its sections with random planes modulo primes: exact, and no prime ideal is sought.

    reduced basis K of degree D, modulo p --a random plane of complementary dimension--> D simple points, all finite
    points --factors of a random linear form's minimal polynomial--> their degrees modulo p
    component over the field --it has points of its own modulo every p--> its degree is a sum of some, for every p

Where p divides no leading coefficient, the zeros modulo p are those of all components together, each with its degree
(W. Fulton, Intersection Theory, 20.3), and where all points are simple each of these lies on one. If no sum of degrees
but 0 and D is there for every p, there is one component of the part's dimension, and K has it once. There are none of
lower dimension where the ring is Cohen-Macaulay: its quotient by one plane more in the homogenised basis has length D
then. Modulo p is enough, as this length is D at least and can only rise there. Sections of what is irreducible over the
complex numbers have the whole symmetric group (J. Harris, The genus of space curves, 1980), so that a few primes
decide: what they leave open has probably several components.
"""

from __future__ import annotations

import random
import re
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from symscrew.mobility.components.algebra_program import algebra_answer
from symscrew.mobility.symbols import Exact, terms_of

PRIMES = 12
"""Primes at most: a symmetric group's classes leave a sum open with a chance below 1e-3 after six."""
AT_ONCE = 4
"""Primes in one run of the program, which takes as long to start as a section of degree 20."""
LARGE = 30000
"""Primes are the first above: below 2^15 numbers modulo p are the quickest, and degrees are below a hundredth."""
MOST = 200
"""Degree up to which sections are looked at: a minimal polynomial of degree 106 takes a second."""
RANGE = 1000
"""Coefficients of planes: none of them meets a part badly by chance more often than about once in so many."""
SEED = 20231009
"""Of the planes: always the same, so that results repeat."""


@dataclass(frozen=True)
class Basis:
    """A reduced basis as printed, with its dimension (of the cone, where only ratios matter) and degree."""

    dimension: int
    degree: int
    equations: tuple[str, ...]


@dataclass(frozen=True)
class Section:
    """What sections prove: one component of the part's dimension, met once; `pure`: and none of lower dimension."""

    irreducible: bool
    pure: bool


def sections(bases: Sequence[Basis], count: int, modulus: Sequence[Exact], seconds: float) -> list[Section]:
    """What sections say of each basis in so many variables v1, v2 ... within so many seconds of the processor.

    `modulus`: low coefficients of the polynomial of the field's root, which is called `a`; none of rational numbers.
    """
    found = [Section(irreducible=False, pure=False) for _ in bases]
    looked_at = [k for k, basis in enumerate(bases) if basis.dimension > 0 and basis.degree <= MOST]
    left = {k: {*range(1, bases[k].degree)} for k in looked_at}
    pure, met = set[int](), set[int]()
    chosen = random.Random(SEED)
    for start in range(0, PRIMES, AT_ONCE):
        places = [(p, sum(roots)) for p, roots in places_modulo([modulus] if modulus else [], start, AT_ONCE)]
        todo = sorted(k for k in left if left[k] or k not in met)
        if not todo or not places:
            break
        script = _script([(k, bases[k]) for k in todo], count, places, chosen)
        answer = algebra_answer(script, seconds / (PRIMES // AT_ONCE))
        if answer is None:
            break
        for k, text in re.findall(r"^@points (\d+)((?: \d+)*)$", answer[0], re.MULTILINE):
            degrees = [int(d) for d in text.split()]
            if sum(degrees) == bases[int(k)].degree:
                met.add(int(k))
                left[int(k)] &= sums_of(degrees)
        pure |= {int(k) for k in re.findall(r"^@pure (\d+)$", answer[0], re.MULTILINE)}
        if not answer[1]:
            break
    for k in met:
        found[k] = Section(irreducible=not left[k], pure=k in pure)
    return found


def sums_of(degrees: Sequence[int]) -> set[int]:
    """All sums of some of them, that of none included."""
    sums = {0}
    for degree in degrees:
        sums |= {s + degree for s in sums}
    return sums


def places_modulo(moduli: Sequence[Sequence[Exact]], start: int, count: int) -> list[tuple[int, tuple[int, ...]]]:
    """(prime, a root modulo it of each polynomial, given by its low coefficients), from the start-th on."""
    lows = [[_fraction(c) for c in modulus] for modulus in moduli]
    found: list[tuple[int, tuple[int, ...]]] = []
    p = LARGE
    while len(found) < start + count:
        p += 1
        if any(p % d == 0 for d in range(2, int(p**0.5) + 1)) or any(
            c.denominator % p == 0 for low in lows for c in low
        ):
            continue
        values = [[c.numerator * pow(c.denominator, -1, p) % p for c in low] for low in lows]
        roots = [next((x for x in range(p) if _value(low, x, p) == 0), None) for low in values]
        if None not in roots:
            found.append((p, tuple(root for root in roots if root is not None)))
    return found[start:]


def _fraction(number: Exact) -> Fraction:
    """A rational number of the field."""
    return Fraction(next(iter(terms_of(number, ()).values()), 0))


def _value(low: Sequence[int], x: int, p: int) -> int:
    value = 1
    for c in reversed(low):
        value = (value * x + c) % p
    return value


def _plane(count: int, planes: int, chosen: random.Random, names: str = "v{}") -> str:
    forms = []
    for _ in range(planes):
        terms = [f"{chosen.randint(1, RANGE)}*{names.format(k + 1)}" for k in range(count)]
        forms.append("+".join([*terms, f"{chosen.randint(1, RANGE)}*h"]))
    return ",\n".join(forms)


def _lead(equation: str) -> str:
    """The monomial of the term that is printed first."""
    first = re.match(r"[-+]?(?:\([^()]*\)|[^-+()])+", equation)
    return "*".join(re.findall(r"v\d+(?:\^\d+)?", re.sub(r"\([^()]*\)", "", first[0] if first else ""))) or "1"


def _script(
    bases: Sequence[tuple[int, Basis]], count: int, places: Sequence[tuple[int, int]], chosen: random.Random
) -> str:
    names = ",".join(f"v{k + 1}" for k in range(count))
    runs = []
    for p, root in places:
        for k, basis in bases:
            equations, leads = ",\n".join(basis.equations), ",".join(map(_lead, basis.equations))
            form = "+".join(f"{chosen.randint(1, RANGE)}*v{i + 1}" for i in range(count))
            runs.append(f"""
ring r = {p}, ({names}, h), dp; poly a = {root};
ideal K = {equations};
ideal leads = {leads};
ideal L = {_plane(count, basis.dimension, chosen)};
ideal M = {_plane(count, 1, chosen)};
look(K, leads, L, M, {form}, {basis.dimension}, {basis.degree}, {k});
kill r;
""")
    return f"""
option(redSB);
proc look(ideal K, ideal leads, ideal L, ideal M, poly form, int d, int D, int k) {{
  int i; int n = nvars(basering); def r = basering;
  for (i = 1; i <= size(K); i++) {{ if (leadmonom(K[i]) != leads[i]) {{ return(); }} }}
  ideal top = homog(K, var(n)); attrib(top, "isSB", 1);
  ideal cut = std(top + L);
  if (dim(cut) != 1) {{ return(); }}
  if (vdim(std(cut + M)) == D) {{ print("@pure " + string(k)); }}
  if (vdim(std(cut + ideal(var(n)))) < 0) {{ return(); }}
  ideal S = std(subst(cut, var(n), 1) + ideal(var(n) - form));
  if (vdim(S) != D) {{ return(); }}
  execute("ring z = " + string(char(r)) + ",(" + varstr(r) + "),lp;");
  ideal S = fglm(r, S); poly f = S[1];
  if (deg(f) != D or deg(gcd(f, diff(f, var(n)))) > 0) {{ return(); }}
  list factors = factorize(f); string text;
  for (i = 1; i <= size(factors[1]); i++) {{
    if (deg(factors[1][i]) > 0) {{ text = text + " " + string(deg(factors[1][i])); }}
  }}
  print("@points " + string(k) + text);
}}
{"".join(runs)}
print("@end");
quit;
"""
