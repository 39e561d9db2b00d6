"""What start_systems.json holds: start systems of the catalogue's structures and of others, bounds of references.

    python -m symscrew.assembly.stored_systems > new.json    needs Singular; --anew searches instead of reading

Whoever has no Singular has proofs for these all the same. Entries of other structures, which somebody added, stay.
"""

from __future__ import annotations

import json
import sys
from typing import Any

from symscrew.assembly.all_modes import known_zero, structure_of
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.closure_structure import Structure
from symscrew.assembly.families import AllNumbers
from symscrew.assembly.root_bounds import Bound, exact_bound, own_bound, own_keys, stored_entries
from symscrew.assembly.start_system import encoded, searched, start_key, start_system
from symscrew.assembly.what_is_held import Held, held_by
from symscrew.catalogue import load, names
from symscrew.description import Mechanism, description_text, parse_description
from symscrew.errors import DescriptionError
from symscrew.mobility import NotAlgebraicError

FURTHER = ("3-UPU",)
"""Limbs of mechanisms that are in no catalogue and take long to search: a minute. 3-RUU, 3-PUU are of one structure."""


PATIENT = 120.0
"""Seconds for a bound in exact numbers: a platform on six legs takes eight at its reference."""


def stored_entries_of(held: Held, structure: Structure, *, anew: bool = False) -> dict[str, Any]:
    """Start system of the structure, bound of these values; empty where there are no isolated solutions in general."""
    equations = BatchEquations(structure)
    if structure.unknowns != structure.equations or not structure.groups:
        return {}
    family = AllNumbers(equations)
    made = (searched if anew else start_system)(family, known_zero(equations))
    if not made.complete:
        return {}
    found = {start_key(family): encoded(made)}
    for key, bound in zip(own_keys(held), (own_bound(held), exact_bound(held, PATIENT)), strict=True):
        if isinstance(bound, Bound):
            found[key] = {"own": [bound.count, bound.dimension]}
    return found


def every_entry(*, anew: bool = False) -> dict[str, Any]:
    """Of the whole catalogue and of the further ones with their drives held."""
    found = dict(stored_entries())
    mechanisms: list[Mechanism] = [load(name) for name in names()]
    mechanisms += [parse_description(description_text(f"further{k}", limbs)) for k, limbs in enumerate(FURTHER)]
    for mechanism in mechanisms:
        try:
            held = held_by(mechanism, {}, {})
            structure = structure_of(held)
            if structure.equations > structure.unknowns:
                held = held.fewer()
                structure = structure_of(held)
        except (DescriptionError, NotAlgebraicError):
            continue
        found |= stored_entries_of(held, structure, anew=anew)
    return found


if __name__ == "__main__":
    print(json.dumps(every_entry(anew="--anew" in sys.argv), indent=0))
