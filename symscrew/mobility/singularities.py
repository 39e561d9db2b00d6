"""Singularities of three kinds at a configuration: the margins' values there, and actuation loci in symbols.

    Mechanism, coordinates --Newton from the reference--> q --margins--> numbers, zero at a singularity

The margins are those that every model has as functions (`symscrew.mobility.margins`). The loci hold in the reference
configuration (`symscrew.mobility.symbols`, drive_loci).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symscrew.description import Mechanism, exact
from symscrew.kinematics import System
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
from symscrew.mobility.symbols import ActuationLoci, Locus, actuation_loci

SINGULAR = 1e-9
"""A margin below this, of its size over the sample states, is said to be zero: seven digits above what rounding leaves
of a determinant of six screws, and far below any configuration that is meant to be regular. The value itself is in the
JSON. Where the rank in 60 digits is full all the same, it is said to be almost zero."""
STEPS = 24
"""Steps from the reference configuration to the given coordinates: a turn by pi in steps of 7.5 degrees, from
which Newton's method stays on the assembly branch. Where it fails, the margins are said not to be known."""
CLOSED = 1e-13
"""Closure residual over the mechanism's size at which Newton's method stops: rounding of double precision."""
NEARLY_CLOSED = 1e-10
"""What a closure may be off after 30 steps of Newton's method (a singular pose converges slowly) and still count."""
WALKS = 30
"""Steps of Newton's method: quadratic convergence needs five, a singular pose gains a bit a step."""
CUT = "what was given is no coordinate of the spanning tree"
TURNED = "a component of a quaternion was given"

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
        return bool(self.note) or (self.vanishes and not self.regular)


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


def singularities(mechanism: Mechanism, coordinates: Mapping[str, Any]) -> Singularities:
    """Margins in the reference configuration, or where the given joint coordinates take the mechanism.

    Args:
        mechanism: any mechanism.
        coordinates: label of a coordinate of the spanning tree -> value [rad or m].

    Raises:
        DescriptionError: a value is not a number.
    """
    system = System(mechanism)
    system.use_samples()
    q = _configuration(system, {name: float(exact(value, where=name)) for name, value in coordinates.items()})
    kinds = (limb_margins(system), constraint_margins(system), actuation_margins(system))
    loci = actuation_loci(mechanism) if not coordinates else ActuationLoci()
    not_tried = (*(text for kind in kinds for text in kind.not_tried), *loci.not_tried)
    if isinstance(q, str):
        return Singularities(system.length, None, loci.found, not_tried, q)
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


def _configuration(system: System, targets: Mapping[str, float]) -> Array | str:
    """q with the given coordinates, walked to from the reference, or why it is not known."""
    q: Array = system.reference[None].copy()
    if not targets:
        return np.asarray(q[0])
    tree = system.tree
    entry = {c.label: k for k, c in enumerate(tree.q)}
    if any(label not in entry for label in targets):
        return CUT
    if any(tree.q[entry[label]].kind == "quaternion" for label in targets):
        return TURNED
    links = {link.q.start: link for link in tree.links[1:] if link.q.stop > link.q.start}
    held = {links[entry[label]].v.start: (entry[label], value) for label, value in targets.items()}
    free = [k for k in range(len(tree.v)) if k not in held]
    scales = system.scales
    start = q[0].copy()
    for step in range(1, STEPS + 1):
        for index, value in held.values():
            q[0, index] = start[index] + (value - start[index]) * step / STEPS
        if system.cuts:
            closed = _closed(system, q, free, scales)
            if closed is None:
                return "the loops did not close on the way to the given coordinates"
            q = closed
    return np.asarray(q[0])


def _closed(system: System, start: Array, free: Sequence[int], scales: Array) -> Array | None:
    """The coordinates (1, n) with the loops closed by Newton's method in the free rates, or None."""
    q = start
    size = max(1.0, system.length)
    for _ in range(WALKS):
        residual = system.numeric(system.residual, (system.inputs.q, q))[0]
        if np.abs(residual).max() < CLOSED * size:
            return q
        jacobian = system.numeric(system.closure.dense(), (system.inputs.q, q)).reshape(-1, len(scales)) * scales
        step = np.zeros(len(scales))
        step[free] = np.linalg.lstsq(jacobian[:, free], -residual, rcond=1e-9)[0]
        q = system.advance(q, (scales * step)[None])
    left = np.abs(system.numeric(system.residual, (system.inputs.q, q))).max()
    return q if left < NEARLY_CLOSED * size else None


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


def as_lines(found: Singularities) -> list[str]:
    """One line for margins that say the same of several limbs or drives."""
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
        lines.append(f"{kind} ({names}): {value}, {_near(group[0])}{group[0].meaning}{likewise}")
    return lines


def _value(m: MarginValue) -> str:
    if m.note and not m.vanishes:
        lost = "architecturally SINGULAR" if m.kind == "actuation" else "SINGULAR all along"
        return f"{lost}: {m.note}, so this is the volume of what is left, {m.value:.6g}"
    if m.singular:
        return "SINGULAR here"
    return f"{m.value:.6g}" + (", almost SINGULAR" if m.vanishes else "")


def _near(m: MarginValue) -> str:
    if m.nearest is not None:
        return f"0 along its gradient with {m.nearest.words}, "
    return "" if m.vanishes or m.note else "no zero found along its gradient, "
