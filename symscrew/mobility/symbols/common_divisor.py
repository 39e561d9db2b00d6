"""Greatest common divisors of polynomials in many generators that have few of them in common.

Of a fraction with a short denominator, as lengths under square roots are, SymPy takes a step for every generator of the
ring. Here the divisor is found among the coefficients of what only one of the two depends on, in a ring of the others.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

Poly = Any
"""An element of a ring over the rational numbers: SymPy's `PolyElement`."""


def divisor(a: Poly, b: Poly) -> Poly:
    """The greatest common divisor, as SymPy has it: of the coefficients of all that only one of them depends on."""
    ring = a.ring
    both = [k for k in range(ring.ngens) if any(m[k] for m in a) and any(m[k] for m in b)]
    if len(a) < 2 or len(b) < 2 or len(both) == ring.ngens:
        return a.gcd(b)
    if not both:
        return ring.one
    small = ring.clone(symbols=[ring.symbols[k] for k in both])
    parts = set[Any]()
    for poly in (a, b):
        own: dict[tuple[int, ...], dict[tuple[int, ...], Any]] = {}
        for monomial, c in poly.items():
            outside = tuple(0 if k in both else e for k, e in enumerate(monomial))
            own.setdefault(outside, {})[tuple(monomial[k] for k in both)] = c
        parts |= {small.from_dict(part).monic() for part in own.values()}
    result = small.zero
    for part in sorted(parts, key=len):
        result = _short_divisor(result, part)
        if result.is_ground:
            return ring.one
    places = {k: i for i, k in enumerate(both)}
    return ring.from_dict(
        {
            tuple(monomial[places[k]] if k in places else 0 for k in range(ring.ngens)): c
            for monomial, c in result.monic().items()
        }
    )


@lru_cache(maxsize=1000)
def _short_divisor(a: Poly, b: Poly) -> Poly:
    """Of polynomials that come again and again: denominators, and coefficients of what was divided by them."""
    return a.gcd(b)
