"""Classes of screw systems: Gibson and Hunt's types, with principal pitches.

    twists --translations among them, the rest--> type (I pitches differ, II all equal), letter, principal pitches

The letter counts the independent translations (screws of infinite pitch): A none, B one, C two, D three. A system of
more than three screws has the class of its reciprocal system. (C. G. Gibson and K. H. Hunt, Geometry of screw systems 1
and 2, Mech. Mach. Theory 25, 1990, 1-27; K. H. Hunt, Kinematic Geometry of Mechanisms, 1978, chapter 12.)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

Array = np.ndarray[Any, Any]

NONE = 1e-7
"""Relative singular value that counts as zero, and relative difference of pitches that counts as none: the points at
which systems are taken are known to 1e-12, and stand a tenth of the mechanism's size away from what is special."""
LETTERS = "ABCD"


@dataclass(frozen=True)
class ScrewClass:
    """The class of a system of twists.

    Attributes:
        order: number of independent screws.
        name: `IA`, `IIB` ... of the system, or of its reciprocal for four and more; empty for none and for all six.
        pitches: principal pitches [m] of the system that is named: of its screws of finite pitch whose axes are
            perpendicular to the translations in it (their pitch is not at our disposal), ascending.
        translations: independent translations in the system itself.
        rotations: dimension of the angular-velocity projection of the system itself.
    """

    order: int
    name: str
    pitches: tuple[float, ...]
    translations: int
    rotations: int

    @property
    def type(self) -> str:
        """`2R`, `1R2T` ...: the dimension of the angular-velocity projection first."""
        parts = (f"{self.rotations}R" if self.rotations else "", f"{self.translations}T" if self.translations else "")
        return "".join(parts) or "0"

    def __str__(self) -> str:
        if not self.name:
            return "at rest" if self.order == 0 else "all displacements"
        system = f"{self.order}-system" if self.order <= 3 else f"{self.order}-system, reciprocal to a"
        own = "" if self.order <= 3 else f" {6 - self.order}-system"
        if not self.pitches:
            return f"{system}{own} of class {self.name}"
        plural = "s" if len(self.pitches) > 1 else ""
        return f"{system}{own} of class {self.name}, principal pitch{'es'[: 2 * len(plural)]} {_text(self.pitches)} m"


def _text(pitches: Sequence[float]) -> str:
    return ", ".join(f"{p:.6g}" for p in pitches)


def screw_class(twists: Array, length: float) -> ScrewClass:
    """The class of the system that twists (omega ; v) at O span.

    Args:
        twists: N x 6 [1, m], dependent ones among them are allowed.
        length: a length of the mechanism [m], by which velocities are divided to be compared with rotations.
    """
    scaled = np.asarray(twists, dtype=float).reshape(-1, 6) / [1, 1, 1, length, length, length]
    basis = _basis(scaled)
    order = len(basis)
    rotations = int((np.linalg.svd(basis[:, :3], compute_uv=False) > NONE).sum()) if order else 0
    if order in (0, 6):
        return ScrewClass(order, "", (), order - rotations, rotations)
    own = basis if order <= 3 else _reciprocal(basis)
    name, pitches = _named(own)
    return ScrewClass(order, name, tuple(float(p * length) for p in pitches), order - rotations, rotations)


def class_of_motions(twists: Array, length: float) -> ScrewClass:
    """The class of a body's twists (6, N), (omega ; v/length), in N unit motions: of those in which it is not at rest.

    What is left of a body at rest is rounding, which has a direction like any other twist.
    """
    columns = np.asarray(twists, dtype=float)
    moving = columns[:, np.linalg.norm(columns, axis=0) > NONE]
    return screw_class(moving.T * [1, 1, 1, length, length, length], length)


def _basis(rows: Array) -> Array:
    """Orthonormal rows of the row space; each row counts with its own size."""
    sizes = np.linalg.norm(rows, axis=1)
    rows = rows[sizes > 0] / sizes[sizes > 0][:, None]
    if not len(rows):
        return np.zeros((0, 6))
    _, s, vt = np.linalg.svd(rows, full_matrices=False)
    return np.asarray(vt[s > NONE * s[0]])


def _reciprocal(basis: Array) -> Array:
    """The screws (as twists) whose reciprocal product with all of the system is zero."""
    swapped = np.concatenate([basis[:, 3:], basis[:, :3]], axis=1)
    return np.asarray(np.linalg.svd(swapped)[2][len(basis) :])


def _named(basis: Array) -> tuple[str, Array]:
    """(class, principal pitches, in units of length) of a system of up to three screws, with orthonormal rows."""
    u, s, _ = np.linalg.svd(basis[:, :3])
    turning = int((s > NONE).sum())
    translations = u.T[turning:] @ basis
    letter = LETTERS[len(translations)]
    if not turning:
        return f"II{letter}", np.zeros(0)
    finite = u.T[:turning] @ basis
    along = translations[:, 3:] if len(translations) else np.zeros((0, 3))
    # of the angular velocities, those perpendicular to all translations: the others have a pitch of any size
    mixed = finite[:, :3] @ along.T
    free = _kernel(mixed.T, turning)
    across = free @ finite
    gram = across[:, :3] @ across[:, :3].T
    power = across[:, :3] @ across[:, 3:].T
    pitches = np.linalg.eigvals(np.linalg.solve(gram, (power + power.T) / 2)).real if len(across) else np.zeros(0)
    pitches = np.sort(np.where(np.abs(pitches) < NONE, 0.0, pitches))
    equal = len(pitches) == turning and float(np.ptp(pitches)) < NONE * max(1.0, float(np.abs(pitches).max()))
    if equal:
        pitches = pitches[:1]
    return f"{'II' if equal else 'I'}{letter}", pitches


def _kernel(matrix: Array, columns: int) -> Array:
    """Orthonormal rows x with matrix x = 0."""
    if not len(matrix):
        return np.eye(columns)
    _, s, vt = np.linalg.svd(matrix)
    return np.asarray(vt[int((s > NONE).sum()) :])
