"""How many branches cross where the loops leave one equation: equations made by hand, and a delta's six like poses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from support.further_mechanisms import framework
from support.marks import slow
from sympy import Rational

from symscrew import catalogue
from symscrew.mobility import analyse_mobility
from symscrew.mobility.configuration import displaced
from symscrew.mobility.finite import ClosureVariety, ReducedClosure, local_at, quadratic_forms
from symscrew.mobility.joint_network import network_of
from symscrew.mobility.motions import WholeMotion
from symscrew.mobility.motions.germs import germs_at
from symscrew.mobility.motions.one_equation import sheets_of_one_equation

Array = np.ndarray[Any, Any]
FOLDED = 2.6663895881780273
"""Angle of one arm of the delta [rad], the others at rest, at which its parallelogram is flat."""


@dataclass
class ByHand:
    """f of three variables, after a change of coordinates with curvature, in place of a mechanism's closure."""

    f: Callable[[Array, Array, Array], Array]
    here: SimpleNamespace

    def value(self, u: Array) -> Array:
        x, y, z = u.T
        return self.f(x + 0.3 * z * z, y - 0.2 * x * z, z)

    def evaluate(self, u: Array) -> SimpleNamespace:
        h = 1e-6
        slopes = np.stack([(self.value(u + h * e) - self.value(u - h * e)) / (2 * h) for e in np.eye(3)], axis=-1)
        return SimpleNamespace(g=self.value(u)[:, None], derivative=slopes[:, None, :], solved=np.ones(len(u), bool))


@pytest.mark.parametrize(
    "f, form, branches",
    [
        (lambda x, y, z: x * y, [[0, 1, 0], [1, 0, 0], [0, 0, 0]], 2),
        (lambda x, y, z: x * x - y * y / 9, [[2, 0, 0], [0, -2 / 9, 0], [0, 0, 0]], 2),
        (lambda x, y, z: x * y + z**3, [[0, 1, 0], [1, 0, 0], [0, 0, 0]], 1),
        (lambda x, y, z: x * y - z**4, [[0, 1, 0], [1, 0, 0], [0, 0, 0]], 1),
        (lambda x, y, z: x * x + y * y - z * z, [[2, 0, 0], [0, 2, 0], [0, 0, -2]], 1),
        (lambda x, y, z: x * x + y * y - z**3, [[2, 0, 0], [0, 2, 0], [0, 0, 0]], None),
        (lambda x, y, z: x * x - z**4, [[2, 0, 0], [0, 0, 0], [0, 0, 0]], None),
    ],
)
def test_equations_by_hand(f: Callable[[Array, Array, Array], Array], form: Any, branches: int | None) -> None:
    reduced: Any = ByHand(f, SimpleNamespace(dof=3))
    normals = sheets_of_one_equation(reduced, np.array([form], dtype=float))
    assert (None if normals is None else max(1, len(normals))) == branches
    if branches == 2 and normals is not None:  # f's two factors, in either order
        x, y = np.array([0, 1, 0.0]), np.array([1, 0, 0.0])
        wanted = [x, y] if form[0][1] else [(3 * y + x) / 10**0.5, (3 * y - x) / 10**0.5]
        assert np.abs(np.abs(normals @ np.array(wanted).T).max(axis=1) - 1).max() < 1e-9


@slow
@pytest.mark.parametrize("angle", [FOLDED, -FOLDED])
def test_like_poses_of_a_delta_have_like_branches(angle: float) -> None:
    """A parallelogram is flat: it goes on as one or as an antiparallelogram, whichever way the arm has turned."""
    delta = catalogue.load("delta")
    network = displaced(delta, network_of(delta), {"arm1_R": angle, "arm2_R": 0, "arm3_R": 0}).network
    variety = ClosureVariety(network)
    here = local_at(variety, np.zeros(variety.columns), rank=variety.columns - 4)
    assert here.gap[0] > 1e-4 > 1e-10 > here.gap[1]
    normals = sheets_of_one_equation(ReducedClosure(variety, here), quadratic_forms(variety, here))
    assert normals is not None and len(normals) == 2
    assert [germ.dimension for germ in germs_at(variety, here, {3: 3})] == [3, 3]


def test_a_flat_ring_of_six_bars_is_one_cone() -> None:
    """Pins on a line: one equation of four freedoms, whose form has rank four: one branch, however samples fall."""
    points = [[0, 0], [3, 0], [1, 0], [5, 0], [7, 0], [2, 0]]
    network = network_of(framework(points, [(k, (k + 1) % 6) for k in range(6)]))
    variety = ClosureVariety(network)
    here = local_at(variety, np.zeros(variety.columns))
    normals = sheets_of_one_equation(ReducedClosure(variety, here), quadratic_forms(variety, here))
    assert here.dof == 4 and normals is not None and not len(normals)
    assert [germ.dimension for germ in germs_at(variety, here, {3: 3})] == [3]


@slow
def test_a_dead_point_beside_the_reference_is_found() -> None:
    """Crank and coupler almost on one line: the rocker's turning point is nearer to the reference than any step."""
    pins = [[0, 0], [2, 0], [5, Rational(1, 100)], [4, -3]]
    found = analyse_mobility(framework(pins, [(0, 3), (0, 1), (1, 2), (2, 3)]), body="bar2_3").along
    assert isinstance(found, WholeMotion)
    network = network_of(framework(pins, [(0, 3), (0, 1), (1, 2), (2, 3)]))
    dead = [e for e in found.singular if "platform" in e.kinds and np.abs(e.q.astype(float)).max() < 0.1]
    assert len(dead) == 1
    poses = ClosureVariety(network).forward(dead[0].q.astype(float)[None])[1]
    crank, coupler = (poses[body][0][0] @ np.array(way, dtype=float) for body, way in
                      (("bar0_1", [1, 0, 0]), ("bar1_2", [3, 0.01, 0])))  # fmt: skip
    assert abs(np.cross(crank, coupler / np.linalg.norm(coupler))[2]) < 1e-12
