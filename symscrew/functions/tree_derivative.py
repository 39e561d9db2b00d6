"""Derivatives of the forces of a mechanism without loops: composite bodies for inertia, the tape for the rest.

What effects put on the joints is differentiated as a program; see
`symscrew.dynamics.derivatives.composite_variations` for the inertial forces, whose derivatives are most of the work.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symscrew.algebra import Node, differentiate
from symscrew.dynamics import applied_forces, inertial_derivatives
from symscrew.effects import Acting

Seeds = Mapping[Node, Mapping[str, Node]]


def covers(acting: Acting) -> bool:
    """Whether the derivatives here hold for what acts on a system."""
    plain = not (acting.needs_reactions or acting.simplified or acting.transmissions or acting.bendings)
    return plain and not acting.system.cuts


def force_changes(
    acting: Acting, a: Sequence[Node], *, directions: Sequence[str], steps: Sequence[Sequence[Node]], seeds: Seeds
) -> list[list[Node]]:
    """Changes of the generalised forces (for v) that accelerations a of the tree take: [direction][freedom].

    `steps`: displacements of the first directions (entries of v), the others move nothing; `seeds`: how the tape's
    inputs change along all of them.
    """
    system, count = acting.system, len(acting.system.tree.v)
    by_q, by_v, by_a = inertial_derivatives(acting, a)
    applied = applied_forces(system, acting, a)
    rows = differentiate(system.tape, [*system.inputs.v, *a, *applied], seeds, directions)
    result = []
    for k in range(len(directions)):
        rate, gain, force = ([row[k] for row in rows[i : i + count]] for i in range(0, 3 * count, count))
        tables = [(by_v, rate), (by_a, gain), *([(by_q, steps[k])] if k < len(steps) else [])]
        column = []
        for i, less in enumerate(force):
            terms = (x * y for table, change in tables for x, y in zip(table[i], change, strict=True))
            column.append(sum(terms, start=-less))
        result.append(column)
    return result
