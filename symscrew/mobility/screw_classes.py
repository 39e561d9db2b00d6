"""Classes of screw systems: Gibson and Hunt's types, with principal pitches.

    twists --translations among them, the rest--> type (I pitches differ, II all equal), letter, principal pitches

In words a freedom is R, a rotation, where rotations (screws of pitch zero) of the system have its angular velocity
among theirs, H, a screw motion, where none have, and T, a translation: the coupler of a Bennett linkage has 1H. Two
screws whose pitches have opposite signs span two rotations, as those of a cylindroid, two of one sign span none.

The letter counts the independent translations (screws of infinite pitch): A none, B one, C two, D three. A system of
more than three screws has the class of its reciprocal system. (C. G. Gibson and K. H. Hunt, Geometry of screw systems 1
and 2, Mech. Mach. Theory 25, 1990, 1-27; K. H. Hunt, Kinematic Geometry of Mechanisms, 1978, chapter 12.)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.mobility.decompositions import eigenvalues, none, norms, row_space, svd
from symscrew.mobility.screw_text import describe_type

Array = np.ndarray[Any, Any]

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
        helical: how many of these directions are not spanned by those of its rotations (screws of pitch zero).
    """

    order: int
    name: str
    pitches: tuple[float, ...]
    translations: int
    rotations: int
    helical: int = 0

    @property
    def type(self) -> str:
        """`2R`, `1R2T` ...: the dimension of the angular-velocity projection first, whatever the pitches."""
        return describe_type(self.order, self.rotations)

    @property
    def motion_type(self) -> str:
        """`2R`, `1R2T`, `1H` ...: rotations, screw motions of a pitch other than zero, translations."""
        return describe_type(self.order, self.rotations, self.helical)

    @property
    def words(self) -> str:
        """The class in words, without its principal pitches."""
        if not self.name:
            return "at rest" if self.order == 0 else "all displacements"
        system = f"{self.order}-system" if self.order <= 3 else f"{self.order}-system, reciprocal to a"
        own = "" if self.order <= 3 else f" {6 - self.order}-system"
        return f"{system}{own} of class {self.name}"

    def __str__(self) -> str:
        if not self.name or not self.pitches:
            return self.words
        plural = "es" if len(self.pitches) > 1 else ""
        return f"{self.words}, principal pitch{plural} {_text(self.pitches)} m"


def _text(pitches: Sequence[float]) -> str:
    return ", ".join(f"{p:.6g}" for p in pitches)


def screw_class(twists: Array, length: float) -> ScrewClass:
    """The class of the system that twists (omega ; v) at O span.

    Args:
        twists: N x 6 [1, m], dependent ones among them are allowed; objects are of 60 digits, and decided so.
        length: a length of the mechanism [m], by which velocities are divided to be compared with rotations.
    """
    given = np.asarray(twists)
    scaled = given.reshape(-1, 6) / np.array([1, 1, 1, length, length, length])
    basis = row_space(scaled)
    order = len(basis)
    rotations = int((svd(basis[:, :3])[1] > none(basis)).sum()) if order else 0
    if order in (0, 6):
        return ScrewClass(order, "", (), order - rotations, rotations)
    own = basis if order <= 3 else _reciprocal(basis)
    name, pitches, helical = _named(own)
    helical = helical if order <= 3 else 0  # of four screws and more some translate along any axis: each has any pitch
    return ScrewClass(order, name, tuple(float(p * length) for p in pitches), order - rotations, rotations, helical)


def class_of_motions(twists: Array, length: float) -> ScrewClass:
    """The class of a body's twists (6, N), (omega ; v/length), in N unit motions: of those in which it is not at rest.

    What is left of a body at rest is rounding, which has a direction like any other twist.
    """
    columns = np.asarray(twists)
    moving = columns[:, norms(columns.T) > none(columns)]
    return screw_class(moving.T * np.array([1, 1, 1, length, length, length]), length)


def _reciprocal(basis: Array) -> Array:
    """The screws (as twists) whose reciprocal product with all of the system is zero."""
    swapped = np.concatenate([basis[:, 3:], basis[:, :3]], axis=1)
    return np.asarray(svd(swapped)[2][len(basis) :])


def _named(basis: Array) -> tuple[str, Array, int]:
    """(class, principal pitches, in units of length, how many directions no rotation has) of up to three screws.

    The rows are orthonormal. The pitches are the coefficients of a sum of squares of angular velocities, whose zeros
    are rotations: with both signs these span all directions, with one only those whose coefficient is zero. Where a
    translation is not perpendicular to all axes it gives most of them any pitch, zero as well.
    """
    u, s, _ = svd(basis[:, :3])
    turning = int((s > none(basis)).sum())
    translations = u.T[turning:] @ basis
    letter = LETTERS[len(translations)]
    if not turning:
        return f"II{letter}", np.zeros(0), 0
    finite = u.T[:turning] @ basis
    # of the angular velocities, those perpendicular to all translations: the others have a pitch of any size
    free = _kernel(translations[:, 3:] @ finite[:, :3].T, turning)
    pitches = _pitches(free @ finite)
    one_sign = len(pitches) == turning and not pitches[0] < 0 < pitches[-1]
    helical = sum(p != 0 for p in pitches) if one_sign else 0
    equal = len(pitches) == turning and bool(pitches[-1] - pitches[0] < none(basis) * max(1.0, *abs(pitches)))
    if equal:
        pitches = pitches[:1]
    return f"{'II' if equal else 'I'}{letter}", pitches, helical


def _pitches(screws: Array) -> Array:
    """Principal pitches of screws with independent angular velocities, ascending; rounding of zero is zero."""
    if not len(screws):
        return np.zeros(0)
    u, s, _ = svd(screws[:, :3])
    unit = (u.T @ screws) / s[: len(screws), None]  # the angular velocities are orthonormal
    power = unit[:, :3] @ unit[:, 3:].T
    found = eigenvalues((power + power.T) / 2)
    return np.where(abs(found) < none(found), 0 * found, found)


def _kernel(matrix: Array, columns: int) -> Array:
    """Orthonormal rows x with matrix x = 0."""
    if not len(matrix):
        return np.eye(columns)
    _, s, vt = svd(matrix)
    return np.asarray(vt[int((s > none(matrix)).sum()) :])
