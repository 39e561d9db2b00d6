"""Paths of zeros near their ends: what rounding holds back ends; and which axes a structure has one number for."""

from __future__ import annotations

from typing import Any

import numpy as np
from support.linkages import single_loop

from symscrew.assembly.all_modes import structure_of
from symscrew.assembly.closure_structure import Structure
from symscrew.assembly.path_tracking import Tracker
from symscrew.assembly.root_bounds import family_bound
from symscrew.assembly.what_is_held import held_by

Array = np.ndarray[Any, Any]
ROUNDING = 1e-12


class Triple:
    """(b - a)^3 = c a^3 in homogeneous coordinates a, b, known to `ROUNDING`: three zeros meet at c = 0."""

    width = 2

    def evaluate(self, z: Array, c: Array) -> tuple[Array, Array]:
        a, b = z.T
        c = np.broadcast_to(c[:, 0], a.shape)
        values = (b - a) ** 3 - c * a**3 + ROUNDING * np.exp(1e9j * (b.real + b.imag))
        slopes = np.stack([-3 * (b - a) ** 2 - 3 * c * a**2, 3 * (b - a) ** 2], axis=1)
        return values[:, None], slopes[:, None]

    def values(self, z: Array, c: Array) -> Array:
        return self.evaluate(z, c)[0]

    def patches(self, z: Array) -> Array:
        return z.conj()[:, None]

    def scaled(self, z: Array) -> Array:
        return np.asarray(z / np.linalg.norm(z, axis=1, keepdims=True))


def test_a_path_that_rounding_holds_back_ends_where_it_is():
    tracker = Tracker(Triple(), nearly=1e-12)  # type: ignore[arg-type]
    ends = tracker.follow(np.array([[1, 2 + 0j]]), lambda s: ((1 - s) * np.exp(-1j * s))[:, None])
    assert not ends.reached[0] and 1e-12 < 1 - ends.s[0] < 1e-4  # luck takes every other step from there on
    assert ends.steps < 300


POINTS = [[0, 0, 0], [1, 0, 0], [1, 1, "0.2"], [0, 1, 1], ["0.3", 0, 1]]
AXES = [[[1, 0, 0]], [[0, 0, 1]], [[0, "3/5", "4/5"]], [["3/5", 0, "4/5"]], [["2/3", "2/3", "1/3"]]]


def structure(types: str, third: str = "0") -> Structure:
    """Of a loop of five joints, the first held; of "RRRCC" the third is parallel to the second but for a turn."""
    axes = [*AXES[:2], [[0, f"sin({third})", f"cos({third})"]], *AXES[3:]] if types == "RRRCC" else AXES
    return structure_of(held_by(single_loop(types, POINTS, axes), {"j0": "0.1"}, {}))


def test_joints_in_a_row_share_an_axis_only_where_it_is_exactly_one():
    same, nearly = (structure("RRRCC", turn) for turn in ("0", "1e-13"))
    assert sum(s.kind == "axis" for s in same.slots) == sum(s.kind == "axis" for s in nearly.slots) - 1


def test_a_general_mechanism_with_cylinders_has_no_solutions_that_these_send_to_infinity():
    # with axes of their own for slides and turns there are eight
    found = family_bound(structure("RCRCR"))
    assert isinstance(found, str) or found.count == 4  # a text: where Singular is not installed
