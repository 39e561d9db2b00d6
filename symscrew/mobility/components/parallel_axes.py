"""Modes in which an axis of the body stays parallel to one of the base, by exact algebra, where the whole is too large.

    first axis a and last axis b of a limb --a x R b = 0, primes--> J, orientations;  b back along a, or against it
    equations of each limb + J --its joints eliminated--> together, primes: poses with such orientations

Limbs whose outer axes are parallel hold the body differently where these are parallel again: all conditions `b, a and
the limb lie in one plane` are met there at once, so that it moves with more freedoms than elsewhere, as a 4-RUU does in
its two Schoenflies modes (L. Nurahmi, S. Caro, P. Wenger, J. Schadlbauer, M. Husty, Reconfiguration analysis of a 4-RUU
parallel manipulator, Mech. Mach. Theory 96, 2016). Every configuration is on one of these sets or beside all of them,
whichever are looked at. That exact algebra ends here where it does not for the whole (`exact_parts`) is because J
leaves few terms, and limbs are taken one by one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from symscrew.algebra import cross
from symscrew.description import Mechanism
from symscrew.mobility.components.algebra_program import ALGEBRA_PROGRAM, algebra_answer
from symscrew.mobility.components.algebraic_closure import limbs_between
from symscrew.mobility.components.closure_parts import ClosureEquations
from symscrew.mobility.components.component_parts import Part
from symscrew.mobility.components.exact_parts import (
    field_text,
    not_ended,
    polynomials_text,
    printed_parts,
    shown_procedure,
    variable_names,
)
from symscrew.mobility.components.limb_equations import PARAMETERS
from symscrew.mobility.components.polynomials import Polynomial, conjugate, constant, product, variable
from symscrew.mobility.joint_network import Network
from symscrew.mobility.symbols import Exact, exact_inverse, exact_system, exact_value

SECONDS = 10.0
"""Of the processor. Those of the literature here end in one."""
Direction = tuple[Exact, ...]


def modes_of_axes(
    mechanism: Mechanism, network: Network, closure: ClosureEquations, seconds: float = SECONDS
) -> tuple[Part, ...] | str:
    """Irreducible sets that hold the poses of all configurations with parallel axes, or why there are none.

    Those of most dimensions first; what was found in the time given. That their poses are reached is not said.
    """
    pairs = list(dict.fromkeys(_outer_axes(mechanism, network)))
    if not pairs or len(closure.variables) == PARAMETERS:
        return "no limb begins and ends with an axis, and has joints among the variables"
    if len(closure.field.generators) > 1:
        return f"the numbers are in {closure.field}: expected one root at most"
    answer = algebra_answer(_script(closure, [_parallel(closure, a, b) for a, b in pairs]), seconds)
    if answer is None:
        return f"exact algebra needs the program {ALGEBRA_PROGRAM}, which is not on the path"
    parts = [part for _, part, away in printed_parts(closure, answer[0], prime=True) if not away]
    if not parts:
        none = "no configuration has outer axes that are parallel"
        return none if answer[1] else not_ended(seconds)
    return tuple(sorted(parts, key=lambda part: (-part.dimension, part.degree, part.equations)))


def _outer_axes(mechanism: Mechanism, network: Network) -> Iterator[tuple[Direction, Direction]]:
    """(first, last) axis of every limb that turns about such; slides before or after it do not turn. Largest part 1."""
    screws = exact_system(mechanism).screws
    for steps in limbs_between(network, {name for loop in network.loops() for name, _ in loop})[2]:
        turning = [(name, axis) for name, sign in steps for axis in (s[:3] for s in screws[name][::sign]) if any(axis)]
        ends = turning[0], turning[-1]
        if not any(network.edges[name].motions[0][0].spherical for name, _ in ends):
            yield _scaled(ends[0][1]), _scaled(ends[1][1])


def _scaled(vector: Sequence[Exact]) -> Direction:
    """The same line's direction, however long it was given, so that equal ones are seen to be."""
    back = exact_inverse(max(vector, key=lambda c: abs(float(exact_value(c)))))
    return tuple(c * back for c in vector)


def _parallel(closure: ClosureEquations, a: Direction, b: Direction) -> list[Polynomial]:
    """a x R b times the square of the quaternion."""
    count = len(closure.variables)
    x = [*(variable(count - PARAMETERS + k, count) for k in range(4)), *[Polynomial({})] * 4]
    turned = product(
        product(x, [Polynomial({}), *(constant(c, count) for c in b), *[Polynomial({})] * 4]), conjugate(x)
    )
    fixed = [constant(c, count) for c in a]
    return [p for p in cross((fixed[0], fixed[1], fixed[2]), (turned[1], turned[2], turned[3])) if p]


def _by_joints(closure: ClosureEquations, heads: int) -> dict[frozenset[int], list[Polynomial]]:
    """Joints' variables -> the equations with these: a limb's have its own joints and no others."""
    limbs: dict[frozenset[int], list[Polynomial]] = {}
    for equation in closure.equations:
        inside = frozenset(h for h in range(heads) if any(key[h] for key in equation.terms))
        others = [joints for joints in limbs if joints & inside]
        if inside:
            merged = [p for joints in others for p in limbs.pop(joints)]
            limbs[inside.union(*others)] = [*merged, equation]
    return limbs


def _script(closure: ClosureEquations, orientations: Sequence[Sequence[Polynomial]]) -> str:
    names, (field, modulus) = variable_names(closure), field_text(closure)
    heads = len(names) - PARAMETERS
    poses = [p for p in closure.equations if not any(any(key[:heads]) for key in p.terms)]
    never = [p for p in closure.excluded if not any(any(key[:heads]) for key in p.terms)]
    each = "\n".join(
        f"parallel[{k + 1}] = ideal({polynomials_text(closure, own)});" for k, own in enumerate(orientations)
    )
    limbs = "\n".join(
        f"limbs[{k + 1}] = list(ideal({polynomials_text(closure, own)}), {'*'.join(names[h] for h in sorted(joints))});"
        for k, (joints, own) in enumerate(_by_joints(closure, heads).items())
    )
    return f"""
LIB "primdec.lib";
ring r = {field}, ({",".join(names)}), dp; {modulus}
option(redSB); short = 0;
list limbs; ideal poses = {polynomials_text(closure, poses)};
{limbs}
ring p = {field}, ({",".join(names[heads:])}), dp; {modulus}
option(redSB); short = 0;
ideal never = {polynomials_text(closure, never)};
ideal poses = imap(r, poses);
{shown_procedure(closure, first=heads)}
proc primes(ideal K, list found) {{
  int i; int j; int k; int drop; list pieces = facstd(K, never);
  for (i = 1; i <= size(pieces); i++) {{
    list minimal = minAssGTZ(pieces[i]);
    for (j = 1; j <= size(minimal); j++) {{
      ideal L = std(minimal[j]); drop = (reduce(never[1], L) == 0);
      for (k = size(found); k >= 1; k--) {{
        if (drop == 0) {{
          if (within(L, found[k])) {{ drop = 1; }} else {{ if (within(found[k], L)) {{ found = delete(found, k); }} }}
        }}
      }}
      if (drop == 0) {{ found[size(found) + 1] = L; }}
      kill L;
    }}
    kill minimal;
  }}
  return(found);
}}
list parallel; {each}
list held; int i; int j; int k; int mark;
for (i = 1; i <= size(parallel); i++) {{ held = primes(poses + parallel[i], held); }}
for (i = 1; i <= size(held); i++) {{
  ideal J = held[i];
  setring r;
  ideal K = poses + imap(p, J);
  for (k = 1; k <= size(limbs); k++) {{ K = K + eliminate(std(limbs[k][1] + K), limbs[k][2]); }}
  setring p;
  list found = primes(imap(r, K), list());
  for (j = 1; j <= size(found); j++) {{ mark++; shown(found[j], mark, 1); }}
  kill found; kill J; setring r; kill K; setring p;
}}
print("@end");
quit;
"""
