"""Singularities of three kinds at a configuration: the margins' values there, and actuation loci in symbols.

    Mechanism, the configuration reached --> q --margins--> numbers, zero at a singularity

The margins are those that every model has as functions (`symscrew.mobility.margins`). The loci hold in the reference
configuration (`symscrew.mobility.symbols`, drive_loci).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import asdict, dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.kinematics import System
from symscrew.mobility.configuration import Reached
from symscrew.mobility.margins import (
    FORMS,
    Displaced,
    Margin,
    actuation_margins,
    constraint_margins,
    find_zeros,
    limb_margins,
    size_of,
)
from symscrew.mobility.symbols import ActuationLoci, Locus, SymbolicScrews, actuation_loci

SINGULAR = 1e-9
"""A margin below this, of its size over the sample states, is said to be zero: seven digits above what rounding leaves
of a determinant of six screws, and far below any configuration that is meant to be regular. The value itself is in the
JSON. Where the rank in 60 digits is full all the same, it is said to be almost zero."""
OPEN = 1e-9
"""How far the loops may be open by the tree's own coordinates, over the mechanism's size: those of a configuration that
is known to 60 digits are right to rounding; beyond, they are not this configuration, and the margins are not known."""

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Zeros:
    """The nearest zeros of the margins that are not zero at q: all of them in one batch, when one is asked for."""

    system: System
    margins: tuple[Margin, ...]
    q: Array

    @cached_property
    def found(self) -> dict[tuple[str, str], Displaced | None]:
        """(kind, name) of a margin -> its nearest zero."""
        zeros = find_zeros(self.system, self.margins, self.q)
        return {(m.kind, m.name): zero for m, zero in zip(self.margins, zeros, strict=True)}


@dataclass(frozen=True)
class MarginValue:
    """A margin at the configuration; see `symscrew.mobility.margins.Margin`."""

    kind: str
    name: str
    form: str
    value: float
    meaning: str
    size: float = 1.0
    """The largest value at the sample states, with which it is compared."""
    zeros: Zeros | None = field(default=None, repr=False, compare=False)
    """What finds the nearest zeros of all margins when one is asked for."""
    note: str = ""
    """What a rank of the configuration says that the value does not: it is the volume of the rank that there is on
    the whole branch, and stays above zero where rank is lost all along it. Empty where both agree."""
    regular: bool = False
    """Whether the rank was decided to be full here, so that a small value is not zero."""
    almost: str = ""
    """That a rank is almost lost as typed: the value may be the volume of what is left without it."""
    underactuated: bool = False
    """Whether `note` tells freedoms that have no drive because there are fewer drives than freedoms: no singularity."""

    @property
    def nearest(self) -> Displaced | None:
        """Where it is zero along its gradient; None where no zero was found, or it is zero here."""
        return None if self.zeros is None else self.zeros.found.get((self.kind, self.name))

    @property
    def vanishes(self) -> bool:
        """Whether the value is rounding of its size."""
        return abs(self.value) < SINGULAR * self.size

    @property
    def singular(self) -> bool:
        """Whether the configuration is singular in this sense."""
        return (bool(self.note) and not self.underactuated) or (self.vanishes and not self.regular)


@dataclass(frozen=True)
class Singularities:
    """`margins` at the configuration (None where they are not known there), with lengths divided by `length` [m].

    `loci`: where, in the parameters, drives lose their hold in the reference configuration. `not_tried`: margins and
    loci that were not derived, a sentence each. `unknown`: why the margins are not known here.
    """

    length: float
    margins: tuple[MarginValue, ...] | None
    loci: tuple[Locus, ...]
    not_tried: tuple[str, ...] = ()
    unknown: str = ""


def singularities(
    mechanism: Mechanism, reached: Reached | None, *, work: SymbolicScrews | None = None
) -> Singularities:
    """Margins in the configuration that was reached, or in the reference configuration where it is None.

    `work`: the mechanism's screws in symbols, where somebody has them already.
    """
    try:
        system = System(mechanism)
    except DescriptionError as error:  # of a loop of screws that are not parallel none can be cut
        return Singularities(1.0, None, (), unknown=str(error))
    system.use_samples()
    q = np.asarray(system.reference if reached is None else reached.tree(system))
    kinds = (limb_margins(system), constraint_margins(system), actuation_margins(system))
    loci = actuation_loci(mechanism, work=work) if reached is None else ActuationLoci()
    not_tried = (*(text for kind in kinds for text in kind.not_tried), *loci.not_tried)
    gap = system.numeric(system.residual, (system.inputs.q, q[None])) if system.cuts else np.zeros(1)
    if not np.abs(gap).max() < OPEN * max(1.0, system.length):
        reason = "the coordinates of the spanning tree do not close the loops"
        return Singularities(system.length, None, loci.found, not_tried, reason)
    values = _values(system, [margin for kind in kinds for margin in kind], q)
    return Singularities(system.length, values, loci.found, not_tried)


def _values(system: System, margins: Sequence[Margin], q: Array) -> tuple[MarginValue, ...]:
    if not margins:
        return ()
    values = system.numeric([m.value for m in margins], (system.inputs.q, q[None]))[0]
    sizes = [size_of(system, m, q) for m in margins]
    away = [m for m, value, size in zip(margins, values, sizes, strict=True) if abs(value) >= SINGULAR * size]
    zeros = Zeros(system, tuple(away), q)
    return tuple(
        MarginValue(m.kind, m.name, m.form, float(value), m.meaning, size, zeros)
        for m, value, size in zip(margins, values, sizes, strict=True)
    )


# -- for people ------------------------------------------------------------------------------------------


def as_values(found: Singularities) -> dict[str, Any]:
    """The margins as JSON values, by kind."""
    result: dict[str, Any] = {"characteristic_length": found.length, "unit": "1"}
    for kind in ("limb", "constraint", "actuation"):
        result[kind] = None if found.margins is None else [
            {"name": m.name, "margin": m.value, "form": FORMS[m.form], "singular": m.singular, "meaning": m.meaning,
             "note": m.note, "nearest": None if m.nearest is None else asdict(m.nearest)}
            for m in found.margins
            if m.kind == kind
        ]  # fmt: skip
    return result


def as_lines(found: Singularities, limbs: Collection[str] | None = None) -> list[str]:
    """One line for margins that say the same of several limbs or drives.

    `limbs`: the names of those described, where a chain of the tree that is none of them is to be called so.
    """
    if found.margins is None:
        return [f"Margins are not known here: {found.unknown}"]
    if not found.margins:
        return []
    lines = [f"Volumes of screws and wrenches with lengths divided by {found.length:g} m, without unit"]
    alike: dict[tuple[str, ...], list[MarginValue]] = {}
    for m in found.margins:
        by = "" if m.nearest is None else m.nearest.size
        alike.setdefault((m.kind, m.form, _value(m), by), []).append(m)
    for (kind, _, value, _), group in alike.items():
        names = ", ".join(m.name for m in group)
        likewise = " (likewise the others)" if len(group) > 1 else ""
        unnamed = (
            limbs is not None and kind == "limb" and group[0].name not in limbs
        )  # a chain of the tree, named by what it ends at
        meaning = group[0].meaning.replace("screws of", "screws of the chain to") if unnamed else group[0].meaning
        lines.append(f"{'chain' if unnamed else kind} ({names}): {value}, {_near(group[0])}{meaning}{likewise}")
    return lines


def _value(m: MarginValue) -> str:
    if m.note and abs(m.value) < SINGULAR:  # all of its sample states may be singular, and its size rounding
        return f"SINGULAR here: {m.note}"
    if m.underactuated and not m.vanishes:
        return f"underactuated, {m.note}, so this is the volume of what the drives hold, {m.value:.6g}"
    if m.note and not m.vanishes:
        lost = "architecturally SINGULAR" if m.kind == "actuation" else "SINGULAR all along"
        return f"{lost}: {m.note}, so this is the volume of what is left, {m.value:.6g}"
    if m.singular:
        return "SINGULAR here"
    why = f": {m.almost}" if m.almost else ""
    return f"{m.value:.6g}" + (f", almost SINGULAR{why}" if m.vanishes or why else "")


def _near(m: MarginValue) -> str:
    if m.nearest is not None:
        least = "0" if m.form == "signed" else "0 as far as doubles tell"
        return f"{least} along its gradient with {m.nearest.words}, "
    return "" if m.vanishes or m.note or m.almost else "no zero found along its gradient, "
