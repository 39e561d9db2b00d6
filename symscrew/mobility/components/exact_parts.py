"""Components of the zeros of polynomials, by exact algebra: Groebner bases that factorise, and minimal primes.

    ClosureEquations --Singular: facstd--> parts whose union is all zeros --sections--> those that are irreducible
                     the others --minAssGTZ--> irreducible ones
    irreducible one through the reference --standard basis in the local ring--> its multiplicity there

Singular is a program of its own (algebra_program). Every part has its dimension and degree from a Groebner basis; what
is not divided to the end in the time given is said to be so.
(P. Gianni, B. Trager, G. Zacharias, J. Symb. Comp. 6 (1988) 149-167: minimal primes.)
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from symscrew.algebra import CONTEXT
from symscrew.mobility.components.algebra_program import ALGEBRA_PROGRAM, algebra_answer
from symscrew.mobility.components.allowed_time import AllowedTime
from symscrew.mobility.components.closure_parts import ClosureEquations, NotAlgebraicError
from symscrew.mobility.components.component_parts import ExactParts, Part
from symscrew.mobility.components.one_root import over_one_root
from symscrew.mobility.components.plane_sections import Basis, Section, sections
from symscrew.mobility.components.polynomials import Exponents, Polynomial
from symscrew.mobility.symbols import exact_value, generator_itself

SECONDS = 20.0
"""Of the processor, for one decomposition, all of it. Those of the literature here end in a tenth of it, or not in
hours."""
SECTIONS = 0.5
"""Part of the time left that sections of pieces may take: those that they show to be one need no division."""
AWAY = 2
"""In a part's mark: it lies where no configuration is."""


def exact_parts(closure: ClosureEquations, seconds: float = SECONDS, *, local: bool = False) -> ExactParts:
    """The components of all configurations over the field of the description; `local`: with their multiplicities.

    All of it takes so many seconds of the processor: pieces first, half of the rest for sections of these.
    """
    allowed = AllowedTime(seconds)
    try:
        closure = over_one_root(closure)
    except NotAlgebraicError as error:
        return ExactParts((), False, str(error))
    answer = algebra_answer(_pieces_script(closure), seconds)
    if answer is None:
        return ExactParts((), False, f"exact algebra needs the program {ALGEBRA_PROGRAM}, which is not on the path")
    first, split, saturated = answer[0].partition("@pieces")
    if REFUSED.search(first):
        return ExactParts((), False, f"{ALGEBRA_PROGRAM} did not accept the equations")
    if not split:
        return ExactParts((), False, not_ended(seconds))
    bases = {**_bases(first), **_bases(saturated)}
    bases = {k: basis for k, basis in bases.items() if basis.equations != ("1",)}
    apart = {int(k) for k in re.findall(r"^@apart (\d+)$", saturated, re.MULTILINE)}
    known = _irreducible(closure, {k: b for k, b in bases.items() if k in apart or not closure.excluded},
                         allowed.left * SECTIONS)  # fmt: skip
    script = _division_script(closure, bases, {k for k, section in known.items() if section.pure}, local=local)
    answer = algebra_answer(script, allowed.left)
    if answer is None:  # it was there a moment ago
        return ExactParts((), False, f"exact algebra needs the program {ALGEBRA_PROGRAM}, which is not on the path")
    return _read(closure, answer[0], known.keys(), ended=answer[1], seconds=seconds)


def not_ended(seconds: float) -> str:
    """Why there is no answer."""
    return f"exact algebra did not end within {seconds:.3g} s of the processor"


REFUSED = re.compile(r"^ *\? ", re.MULTILINE)
"""What the program says of text that it does not read."""


def _bases(output: str) -> dict[int, Basis]:
    """Bases of pieces as they were printed."""
    found = {}
    for text in output.split("@part ")[1:]:
        head, *equations = text.partition("@shown")[0].splitlines()
        if "@shown" in text:
            number, dimension, degree = map(int, head.split()[:3])
            found[number] = Basis(dimension, degree, tuple(equations))
    return found


def _irreducible(closure: ClosureEquations, bases: Mapping[int, Basis], seconds: float) -> dict[int, Section]:
    """Those that sections show to have one component of their dimension, `pure` where there is no other.

    A component has no less dimension than variables are more than equations, where all others are excluded.
    """
    least = len(closure.variables) - len(closure.equations)
    modulus = closure.field.generators[0].modulus if closure.field.generators else ()
    found = sections(tuple(bases.values()), len(closure.variables), modulus, seconds)
    even = all(basis.dimension == least for basis in bases.values())
    several = zip(bases.items(), found, strict=True)
    return {k: Section(s.irreducible, s.pure or even) for (k, basis), s in several if s.irreducible}


def _ring(closure: ClosureEquations) -> str:
    names = variable_names(closure)
    return f"""
LIB "primdec.lib";
ring r = {field_text(closure)[0]}, ({",".join(names)}), dp; {field_text(closure)[1]}
option(redSB); short = 0;
ideal never = {polynomials_text(closure, closure.excluded)};
{shown_procedure(closure)}
"""


def _pieces_script(closure: ClosureEquations) -> str:
    """Pieces that a factorising basis gives, then each without what lies where no configuration is."""
    return f"""{_ring(closure)}
ideal closure = {polynomials_text(closure, closure.equations)};
list pieces = {"facstd(closure, never)" if closure.excluded else "facstd(closure)"};
int i; int j; int drop;
for (i = size(pieces); i >= 1; i--) {{
  pieces[i] = std(pieces[i]); drop = 0;
  for (j = 1; j <= size(pieces); j++) {{ if (j != i and drop == 0) {{ drop = within(pieces[i], std(pieces[j])); }} }}
  if (drop) {{ pieces = delete(pieces, i); }}
}}
for (i = 1; i <= size(pieces); i++) {{ shown(pieces[i], i, 0); }}
print("@pieces");
if (size(never) > 0) {{
  for (i = 1; i <= size(pieces); i++) {{
    ideal K = pieces[i]; ideal Q; drop = 0;
    for (j = 1; j <= size(never); j++) {{
      Q = std(quotient(K, ideal(never[j])));
      while (not within(K, Q)) {{ K = Q; drop = 1; Q = std(quotient(K, ideal(never[j]))); }}
    }}
    if (drop) {{ shown(K, i, 0); }}
    print("@apart " + string(i)); kill K; kill Q;
  }}
}}
print("@end");
quit;
"""


def _division_script(closure: ClosureEquations, bases: Mapping[int, Basis], prime: set[int], *, local: bool) -> str:
    """Minimal primes of the pieces but those that are known to be irreducible, and which lie in which."""
    numbers = list(bases)
    given = "\n".join(
        f'pieces[{i + 1}] = ideal({",".join(bases[k].equations)}); attrib(pieces[{i + 1}], "isSB", 1);\n'
        f"known[{i + 1}] = {int(k in prime)}; called[{i + 1}] = {k};"
        for i, k in enumerate(numbers)
    )
    order = ",".join(str(i + 1) for i in sorted(range(len(numbers)), key=lambda i: numbers[i] not in prime)) or "0"
    return f"""{_ring(closure)}
list pieces; intvec known; intvec called; {given}
int i; int j; int k; int o; int mark; int drop; list all; list marks; intvec order = {order};
for (i = 1; i <= size(pieces); i++) {{ shown(pieces[i], called[i], 0); }}
print("@pieces");
for (o = 1; o <= size(pieces); o++) {{
  i = order[o]; list minimal;
  if (known[i]) {{ minimal = list(pieces[i]); }} else {{ minimal = minAssGTZ(pieces[i]); }}
  for (j = 1; j <= size(minimal); j++) {{
    ideal K = std(minimal[j]); drop = 0;
    for (k = 1; k <= size(all); k++) {{
      if (drop == 0) {{
        if (within(K, all[k])) {{ drop = 1; }}
        else {{ if (within(all[k], K)) {{ print("@drop " + string(marks[k])); }} }}
      }}
    }}
    if (drop == 0) {{
      mark++; all[size(all) + 1] = K; marks[size(marks) + 1] = mark; shown(K, mark, 1);
      for (k = 1; k <= size(pieces); k++) {{
        if (k != i) {{ if (within(K, pieces[k])) {{ print("@inside " + string(mark) + " " + string(called[k])); }} }}
      }}
    }}
    kill K;
  }}
  print("@divided " + string(called[i]));
  kill minimal;
}}
print("@end");
{_local(closure, *field_text(closure)) if local else ""}
quit;
"""


def variable_names(closure: ClosureEquations) -> list[str]:
    """What the program calls the closure's variables."""
    return [f"v{k + 1}" for k in range(len(closure.variables))]


def polynomials_text(closure: ClosureEquations, polynomials: Sequence[Polynomial]) -> str:
    """Polynomials in the closure's variables as the generators of an ideal."""
    generators = closure.field.generators
    names = variable_names(closure)
    return ",\n".join(p.text(names, generators, ["a"] * len(generators)) for p in polynomials) or "0"


def field_text(closure: ClosureEquations) -> tuple[str, str]:
    """(coefficients of a ring, the equation of the field's generator)."""
    generators = closure.field.generators
    if not generators:
        return "0", ""
    low = [f"({c})*a^{k}" for k, c in enumerate(generators[0].modulus) if c]
    return "(0,a)", f"minpoly = a^{generators[0].degree}+{'+'.join(low)};"


def shown_procedure(closure: ClosureEquations, *, first: int = 0) -> str:
    """Procedures that print a part, in a ring of the variables from the first on, and compare two ideals."""
    given = list(enumerate(closure.reference))[first:]
    reference = "".join(f"q = subst(q, v{k + 1}, {value});" for k, value in given)
    return f"""
proc shown(ideal K, int mark, int whole) {{
  int i; int on = 1; int away = 0; poly q; poly n;
  for (i = 1; i <= size(K); i++) {{ q = K[i]; {reference} if (q != 0) {{ on = 0; }} }}
  for (i = 1; i <= size(never); i++) {{ n = never[i]; if (n != 0 and reduce(n, K) == 0) {{ away = 1; }} }}
  print("@part " + string(mark) + " " + string(dim(K)) + " " + string(mult(K)) + " " + string(size(K)) + " "
    + string(on) + " " + string(whole + 2 * away));
  for (i = 1; i <= size(K); i++) {{ print(string(K[i])); }}
  print("@shown");
}}
proc within(ideal K, ideal L) {{ int i; for (i = 1; i <= size(L); i++) {{ if (reduce(L[i], K) != 0) {{ return(0); }} }}
  return(1); }}"""


def _local(closure: ClosureEquations, field: str, modulus: str) -> str:
    """Multiplicities at the reference: 1 where the derivatives have full rank, else by a local standard basis."""
    names = ",".join(f"v{k + 1}" for k in range(len(closure.variables)))
    about = ", ".join(f"v{k + 1}+({value})" for k, value in enumerate(closure.reference))
    at = "".join(f"M = subst(M, v{k + 1}, {value});" for k, value in enumerate(closure.reference))
    on = "".join(f"P = subst(P, v{k + 1}, {value});" for k, value in enumerate(closure.reference))
    one = next((f", v{k + 1}" for k in closure.scaled if closure.reference[k]), "")  # of those that ratios fix
    return f"""
ring here = {field}, ({names}), ds; {modulus}
setring r;
map moved = r, {about};
list singular;
for (k = 1; k <= size(all); k++) {{
  ideal J = all[k]; ideal P = J; {on}
  if (size(P) == 0) {{
    module M = module(jacob(J)); {at}
    if (size(std(M)) == nvars(r) - dim(J)) {{ print("@local " + string(marks[k]) + " 1"); }}
    else {{ singular[size(singular) + 1] = k; }}
    kill M;
  }}
  kill J; kill P;
}}
for (i = 1; i <= size(singular); i++) {{
  ideal J = all[singular[i]]; ideal K = moved(J){one};
  setring here;
  ideal L = std(imap(r, K));
  print("@local " + string(marks[singular[i]]) + " " + string(mult(L)));
  kill L; setring r; kill K; kill J;
}}
"""


def _read(
    closure: ClosureEquations, output: str, known: Collection[int] = (), *, ended: bool, seconds: float
) -> ExactParts:
    """The parts that the program has printed: primes of divided pieces, the others as they are.

    `known`: pieces of which sections say that they are irreducible, at least in their dimension.
    """
    if REFUSED.search(output):
        return ExactParts((), False, f"{ALGEBRA_PROGRAM} did not accept the equations")
    first, split, second = output.partition("@pieces")
    if not split:
        return ExactParts((), False, not_ended(seconds))
    pieces = {number: part for number, part, away in printed_parts(closure, first, prime=False) if not away}
    primes = {number: part for number, part, away in printed_parts(closure, second, prime=True) if not away}
    marks: dict[str, list[list[int]]] = {}
    for word, numbers in re.findall(r"^@(\w+)((?: \d+)+)$", second, re.MULTILINE):
        marks.setdefault(word, []).append([int(n) for n in numbers.split()])
    left = {k: replace(part, irreducible_in_its_dimension=k in known)
            for k, part in pieces.items() if [k] not in marks.get("divided", [])}  # fmt: skip
    dropped = {mark for (mark,) in marks.get("drop", [])} | {mark for mark, k in marks.get("inside", []) if k in left}
    several = {numbers[0]: numbers[1] for numbers in marks.get("local", [])}
    kept = [replace(part, multiplicity=several.get(k, 0)) for k, part in primes.items() if k not in dropped]
    reason = "" if ended else f"not divided to the end within {seconds:.3g} s of the processor"
    parts = sorted([*kept, *left.values()], key=lambda part: (-part.dimension, part.degree, part.equations))
    return ExactParts(tuple(parts), True, reason)


def printed_parts(closure: ClosureEquations, output: str, *, prime: bool) -> Iterator[tuple[int, Part, bool]]:
    """(mark, part, whether it lies where no configuration is) of every part that was printed whole."""
    for text in output.split("@part ")[1:]:
        head, *equations = text.partition("@shown")[0].splitlines()
        if "@shown" in text:
            number, dimension, degree, _, on, kind = map(int, head.split())
            yield number, _part(closure, (dimension, degree), equations, through=bool(on), prime=prime), kind >= AWAY


def _part(
    closure: ClosureEquations, size: tuple[int, int], equations: Sequence[str], *, through: bool, prime: bool
) -> Part:
    dimension = size[0] - (1 if closure.scaled else 0)
    named = tuple(_named(closure, e) for e in equations)
    return Part(dimension, size[1], named, through, prime, tuple(_doubles(closure, e) for e in equations))


TERM = re.compile(r"[-+]?(?:\([^()]*\)|[^-+()])+")
"""A term of a printed polynomial: signs within brackets do not end it."""


def _doubles(closure: ClosureEquations, equation: str) -> dict[Exponents, float]:
    """A printed polynomial with its coefficients as doubles, the largest 1: numbers may have a thousand digits."""
    generators = closure.field.generators
    root = exact_value(generator_itself(generators[0])) if generators else CONTEXT.zero
    terms: dict[Exponents, Any] = {}
    for term in TERM.findall(equation):
        value, key = CONTEXT.mpf(-1 if term[0] == "-" else 1), [0] * len(closure.variables)
        for factor in (
            term.lstrip("+-").split("*") if "(" not in term else re.split(r"\*(?![^(]*\))", term.lstrip("+-"))
        ):
            base, _, power = factor.partition("^")
            if factor[0] == "(":
                value *= sum(_number(inner, root) for inner in TERM.findall(factor[1:-1]))
            elif base[0] == "v":
                key[int(base[1:]) - 1] += int(power or 1)
            else:
                value *= _number(factor, root)
        terms[tuple(key)] = terms.get(tuple(key), 0) + value
    largest = max((abs(c) for c in terms.values()), default=1) or 1
    return {key: float(c / largest) for key, c in terms.items()}


def _number(term: str, root: Any) -> Any:
    """A product of fractions and powers of the field's generator `a`, in many digits."""
    value = CONTEXT.mpf(-1 if term[0] == "-" else 1)
    for factor in term.lstrip("+-").split("*"):
        base, _, power = factor.partition("^")
        if base == "a":
            value *= root ** int(power or 1)
        else:
            above, _, below = base.partition("/")
            value *= CONTEXT.mpf(int(above)) / int(below or 1)
    return value


def _named(closure: ClosureEquations, equation: str) -> str:
    text = re.sub(r"v(\d+)", lambda m: closure.variables[int(m[1]) - 1], equation)
    for generator in closure.field.generators:
        name = str(generator.name)
        text = re.sub(r"\ba\b", f"({name})" if " " in name else name, text)
    return text
