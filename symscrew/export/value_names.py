"""What values are called in generated code: by their place in the theory, `limb1_lower_omega_x`.

    Program.origins --> slot -> identifier, one for each slot, none of those taken

The opposite of a quantity starts with `minus_`; values that the theory has no name for are t1, t2, ... in order; pivots
whose name would be too long are called after their part, `limb1_U_0_pivot`.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from functools import lru_cache

from symscrew.algebra import Origin
from symscrew.program import Program

LONGEST = 40  # characters of a name: C99 tells 63 apart, and a line of some operations should fit a screen
ANONYMOUS = re.compile(r"t\d+")
# quantities that are understood from their component, and words that are shorter in code
SHORT = {
    "acceleration_matrix": "U",
    "acceleration_matrix_still": "U_still",
    "joint_acceleration": "joint_acc",
    "joint_acceleration_still": "joint_acc_still",
    "acceleration": "acc",
    "acceleration_still": "acc_still",
    "momentum_rate": "rate",
    "momentum_rate_at_O": "rate_at_O",
    "velocity": "vel",
    "multiplier_part": "part",
    "transmitted": "sent",
    "joint_transmitted": "joint_sent",
}


# What a reader of the code is told of its names.
LEGEND = (
    "Names of values: part, quantity, component: limb1_lower_omega_x. Components of screws: fx ... mz of wrenches, "
    "wx ... vz of twists, px ... Lz of momenta. Quantities: omega, alpha; U = [alpha]x + [omega]x^2; vel, acc of a "
    "link's origin; rate, of the momentum screw; force_x ... moment_z, what a link and all that hangs on it need; "
    "sent, what it transmits; still: at joint accelerations zero; by: what a coefficient belongs to; "
    "minus_: the opposite; t1, t2 ...: the theory has no name for it.",
    "Vectors of equal limbs: limb_lower_omega_x; signed_: each lane up to its sign; each_limb1_: what corresponds to "
    "that of limb1 in every limb; lanes_1 ...: no name.",
)

# components of screws as labels call them, fx ... mz, wx ... vz; of momentum screws as in the theory: (p ; L_O)
OF_SCREWS = {"force": "f", "moment": "m", "angular": "w", "linear": "v"}
OF_MOMENTA = {"force": "p", "moment": "L"}


def _component(origin: Origin) -> str:
    """The component, short where the name says of which quantity it is."""
    first, _, axis = origin.component.partition("_")
    if origin.quantity == "force" or axis not in ("x", "y", "z"):
        return origin.component  # force_x and moment_x of the force say by themselves what they are
    words = OF_MOMENTA if origin.quantity == "momentum" else OF_SCREWS
    return words[first] + axis if first in words else origin.component


@lru_cache(maxsize=16384)  # a value has its name in every function and in every target
def identifier(origin: Origin) -> str:
    """A name of letters, digits and underscores: part, quantity, component, and what it belongs to."""
    quantity = SHORT.get(origin.quantity, origin.quantity)
    if quantity == "force" and origin.component:
        quantity = ""
    words = ["minus"] if origin.negative else []
    words += [word for word in (origin.part, quantity, _component(origin)) if word]
    words += ["by", origin.by] if origin.by else []
    text = re.sub(r"[^A-Za-z0-9]+", "_", "_".join(words)).strip("_")
    return text if "_" in text and not text[0].isdigit() else f"value_{text}"  # no word of a language has one


def value_names(program: Program, taken: Collection[str]) -> Mapping[int, str]:
    """Slot to identifier: unique, none of `taken`, nothing that starts with an underscore or is longer than needed."""
    used = set(taken)
    found: dict[int, str] = {}
    anonymous = 0
    pivots = {slot for slot, _ in program.guards}
    slots = [*range(sum(port.size for port in program.inputs)), *(i.target for i in program.instructions)]
    for slot in slots:
        origin = program.origins.get(slot)
        name = identifier(origin) if origin is not None else ""
        if not name or len(name) > LONGEST or ANONYMOUS.fullmatch(name):
            name = ""
        if not name and slot in pivots:
            name = identifier(Origin("pivot", origin.part)) if origin is not None and origin.part else "a_pivot"
            name = name if len(name) <= LONGEST else "a_pivot"
        if not name:
            anonymous += 1
            name = f"t{anonymous}"
            while name in used:
                anonymous += 1
                name = f"t{anonymous}"
        if name in used:
            number = 2
            while f"{name}_{number}" in used:
                number += 1
            name = f"{name}_{number}"
        used.add(name)
        found[slot] = name
    return found
