"""What a body does at a pose: its system of freedoms, joints at rest, axes among its freedoms; decided in 60 digits.

    displacements in doubles --refined--> closed to 60 digits --screws, null space--> Seen

Doubles do not tell an axis at a million kilometres from a translation, nor a rate of 1e-9 from rest, so that ranks at a
pose, as those in the configuration itself, are decided with 60 digits. Where a pose cannot be refined, because rank is
lost there, doubles decide, and the pose says so.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.decompositions import none, norms, row_space
from symscrew.mobility.finite import CLOSED, DIGITS_60, ClosureVariety, refine
from symscrew.mobility.joint_network import Edge, Network
from symscrew.mobility.screw_classes import ScrewClass, class_of_motions
from symscrew.mobility.screw_systems import null_space, unit_rows

Array = np.ndarray[Any, Any]

ALL = 6  # freedoms of a body that moves as it likes: all axes are among them


@dataclass(frozen=True)
class Closures:
    """The closure of a mechanism in doubles and in 60 digits."""

    network: Network

    @cached_property
    def coarse(self) -> ClosureVariety:
        """In doubles."""
        return ClosureVariety(self.network)

    @cached_property
    def fine(self) -> ClosureVariety:
        """In 60 digits."""
        return ClosureVariety(self.network, DIGITS_60)


@dataclass(frozen=True, eq=False)
class Seen:
    """What a body does at a pose.

    Attributes:
        system: the class of its freedoms.
        rates: of every joint freedom, the largest in unit motions.
        axes: joint freedoms whose screw is one of the body's freedoms, by name.
        exact: whether it was decided with 60 digits.
        twists: the freedoms, (omega ; v/length) of unit motions as columns.
    """

    system: ScrewClass
    rates: Array
    axes: tuple[str, ...]
    exact: bool
    twists: Array

    @property
    def name(self) -> tuple[str, str]:
        """Type and class."""
        return self.system.motion_type, self.system.name

    def resting(self, network: Network) -> frozenset[str]:
        """Joints that do not move."""
        least = none(self.rates)
        return frozenset(
            e.name for e in network.edges.values() if e.screws and self.rates[list(e.columns)].max() < least
        )


def seen_at(closures: Closures, q: Array, dimension: int, body: str) -> Seen:
    """What the body does at the displacements q of a point where the space has this dimension and no more freedoms."""
    found = _refined(closures, q, dimension)
    return in_doubles(closures, q, dimension, body) if found is None else _seen(closures, *found, body)


def in_doubles(closures: Closures, q: Array, dimension: int, body: str) -> Seen:
    """The same as far as doubles tell: what is special to seven digits."""
    return _seen(closures, *tangent_at(closures.coarse, q, dimension), body)


def _seen(closures: Closures, screws: Array, motions: Array, body: str) -> Seen:
    network = closures.network
    twists = body_twists(network, closures.coarse, screws, body) @ motions
    rates = np.array([max(abs(row), default=0.0) for row in motions], dtype=motions.dtype)
    axes = joint_axes(network, closures.coarse, screws, twists)
    return Seen(class_of_motions(twists, float(network.length)), rates, axes, screws.dtype == object, twists)


def _refined(closures: Closures, q: Array, dimension: int) -> tuple[Array, Array] | None:
    """(screws, unit motions as columns) with 60 digits; None where they are not as many there."""
    coarse, fine = closures.coarse, closures.fine
    point = np.array([CONTEXT.mpf(float(c)) for c in q], dtype=object)
    if coarse.rows:
        point, residual = refine(coarse, fine, q, coarse.columns - dimension)
        if not residual < CLOSED:
            return None
    screws = fine.displaced(point[None])
    motions = null_space(fine.jacobians(screws, point[None])[0].tolist(), fine.columns).basis
    if len(motions) != dimension:
        return None
    unit = np.empty((fine.columns, dimension), dtype=object)
    unit[:] = np.array(unit_rows(motions), dtype=object).reshape(dimension, fine.columns).T
    return screws[0], unit


def tangent_at(variety: ClosureVariety, q: Array, dimension: int) -> tuple[Array, Array]:
    """(displaced screws about the variety's centre, orthonormal tangent vectors as columns) at a point of a branch."""
    screws = variety.displaced(q[None])
    jacobian = variety.jacobians(screws, q[None])[0]
    vt = np.linalg.svd(jacobian)[2] if jacobian.size else np.eye(variety.columns)
    return screws[0], vt[variety.columns - dimension :].T


def body_twists(network: Network, variety: ClosureVariety, screws: Array, body: str) -> Array:
    """6 x n: twist (omega ; v_O) of the body by the joint rates, lengths in units of the mechanism; or of many."""
    zero = CONTEXT.zero if screws.dtype == object else 0.0
    twists = np.full((*screws.shape[:-2], variety.columns, 6), zero, dtype=screws.dtype)
    for name, sign in network.path(body):
        for column in network.edges[name].columns:
            twists[..., column, :] = sign * screws[..., column, :]
    twists[..., 3:] += np.cross(_centre(variety, screws), twists[..., :3])
    return np.swapaxes(twists, -2, -1)


def _centre(variety: ClosureVariety, like: Array) -> Array:
    return np.array([c if like.dtype == object else float(c) for c in variety.centre], dtype=like.dtype)


def joint_axes(network: Network, variety: ClosureVariety, screws: Array, twists: Array) -> tuple[str, ...]:
    """Joint freedoms whose screw is one of the body's freedoms here, by name; none of a body that has them all."""
    least = none(screws)
    moving = twists.T[norms(twists.T) > least]
    if not len(moving):
        return ()
    basis = row_space(moving)
    if len(basis) == ALL:
        return ()
    centre = _centre(variety, screws)
    columns = [(axis_name(edge, start), start) for edge in network.edges.values() for motion, start in edge.motions
               if motion.single]  # fmt: skip
    if not columns:
        return ()
    given = screws[[start for _, start in columns]].copy()
    given[:, 3:] += np.cross(centre, given[:, :3])
    given = given / norms(given)[:, None]
    left = norms(given - (given @ basis.T) @ basis)
    return tuple(name for (name, _), size in zip(columns, left, strict=True) if size < least)


def axis_name(edge: Edge, column: int) -> str:
    """`about the axis of A`, `along the axis of limb1_P`, `about the second axis of limb1_U`."""
    singles = {start: motion for motion, start in edge.motions if motion.single}
    how = "along" if singles[column].prismatic else "about"
    if len({motion.axis for motion in singles.values()}) == 1:  # a cylindrical joint turns about and slides along one
        return f"{how} the axis of {edge.name}"
    return f"{how} the {('first', 'second', 'third')[list(singles).index(column)]} axis of {edge.name}"
