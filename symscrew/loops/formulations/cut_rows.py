"""What every formulation of a cut joint answers for: its rows, what they define, their scales and their bias.

A cut joint asks for 6 - f relations between the joint rates w of the tree (f: its freedoms). They can be written in
more than one way, and a row may use a component of some velocity as an unknown of its own, which a definition ties to
the joint rates:

    sum of entry_k w_k + entry_c z_c = 0,      z_c = sum of T_ck w_k.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import Affine, Column, Node, is_zero
from symscrew.kinematics import Cut, Rates, System, closure_bias

Definition = tuple[Column, Affine]
"""A component of a velocity and the row that defines it, with entry 1 at the component."""


@dataclass(frozen=True, kw_only=True)
class CutRows:
    """The rows of one cut joint in one formulation; here with the bias of the system's own rows.

    `rows`: {index into v, or a component: entry}, one per reciprocal wrench of the cut; `definitions`: those of the
    components that they use; `scales`: what makes the entries of a row per joint rate without units.
    """

    cut: Cut
    rows: tuple[Affine, ...]
    scales: tuple[float, ...]
    definitions: tuple[Definition, ...] = ()

    @property
    def of_system(self) -> bool:
        """Whether row k is the system's row k in other unknowns.

        The system's residual, and changes of its rows along a direction, are right sides of these rows then.
        """
        return True

    @property
    def products(self) -> int:
        """Products that an inertia takes on its way through the rows and definitions, each of which has a pivot."""
        rows = (*self.rows, *(row for _, row in self.definitions))
        return sum(len(row) * (len(row) - 1) // 2 for row in rows)

    def bias(self, moving: System, cut: Cut, still: Sequence[Rates]) -> Sequence[Node]:
        """(dJ/dt) v per row for a system whose rates keep the loops closed.

        `cut` is the joint as that system has it, `still` are the rates of its links at zero joint accelerations.
        """
        return closure_bias(cut, moving.linkage, moving.twist, still, v=moving.inputs.v)


def unit_scales(system: System, cut: Cut) -> tuple[float, ...]:
    """Scales of the system's own rows: lengths are divided by the characteristic length."""
    return tuple(1.0 / system.length if row.unit == "N" else 1.0 for row in cut.rows)


def used_definitions(rows: Sequence[Affine], definitions: Sequence[Definition]) -> tuple[Definition, ...]:
    """Those components that rows use, directly or through later components."""
    used = {k for row in rows for k in row}
    kept = []
    for name, row in reversed(definitions):
        if name in used:
            kept.append((name, row))
            used |= set(row)
    return tuple(kept[::-1])


def is_single(row: Sequence[Node | int]) -> bool:
    """Whether a row has one entry."""
    return sum(not is_zero(entry) for entry in row) == 1
