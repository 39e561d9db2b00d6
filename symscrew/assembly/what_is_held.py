"""What is held of a mechanism: its drives, or coordinates that were given, at their values.

A platform with more drives than freedoms is held by as many as it needs; solutions that miss the others are left out.
What couplings settle from what is held is held too (`coupled_columns`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import sympy

from symscrew.algebra import CONTEXT, high_precision
from symscrew.assembly.coupled_columns import Coupled, Follower, coupled_columns
from symscrew.assembly.linked_columns import Link, links_of
from symscrew.description import Mechanism
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.kinematics import given_coordinates
from symscrew.mobility import ClosureVariety, Network, NotAlgebraicError, network_of, targets_of, with_parameters

Array = np.ndarray[Any, Any]

RANK = 1e-9
"""Relative singular value below which a closure of the reference has no such row."""
COUPLED = 1e-9
"""What a coupling of held coordinates may be off, in its largest term: they are given in as many digits."""


@dataclass(frozen=True)
class Held:
    """`exact`: held column -> displacement from the reference in 60 digits; `values`: in doubles.

    `given`: exact displacements [rad, m] of those that moved. `chosen`: columns that hold the mechanism, then those of
    `followers`, which couplings settle from them; `extra`: those held too. All are in the order of the description,
    and so is `shown`: values that were given, as the description counts them. `links`: what couplings tie of what is
    free; what is known in them are the last followers, columns of no joint.
    """

    mechanism: Mechanism
    network: Network
    exact: Mapping[int, Any]
    values: Mapping[int, float]
    chosen: tuple[int, ...]
    extra: tuple[int, ...]
    shown: Mapping[str, float]
    body: str
    given: Mapping[int, sympy.Expr] = field(default_factory=dict)
    followers: tuple[Follower, ...] = ()
    links: tuple[Link, ...] = ()

    @property
    def drives(self) -> tuple[int, ...]:
        """The chosen columns that no coupling settles."""
        return self.chosen[: len(self.chosen) - len(self.followers)]

    def fewer(self) -> Held:
        """Only as much held as holds the mechanism in the reference; the rest is checked."""
        chosen = _independent(self.network, self.drives)
        extra = tuple(c for c in self.drives if c not in chosen)
        fewer = replace(
            self, exact={c: self.exact[c] for c in chosen}, chosen=chosen, extra=extra, followers=(), links=()
        )
        whole = fewer.with_followers() if self.network.ties else fewer
        return replace(whole, extra=tuple(c for c in extra if c not in whole.chosen))

    def with_followers(self) -> Held:
        """With what couplings settle; raises DescriptionError where they tie what nothing settles, or do not hold."""
        coupled = coupled_columns(self.mechanism, self.network, self.drives)
        names = {column: name for name, column, *_ in singles(self.mechanism, self.network)}
        self._check_couplings(coupled, names)
        links, halves = self._links(coupled, names)
        followers = (*coupled.followers, *halves)
        exact, values, given = dict(self.exact), dict(self.values), dict(self.given)
        for follower in followers:
            column = follower.column
            exact[column] = follower.value(exact, CONTEXT.mpf)
            values[column] = float(exact[column])
            given[column] = follower.exactly({c: given.get(c, sympy.Integer(0)) for c in follower.exact})
        chosen = (*self.drives, *(f.column for f in followers))
        return replace(self, exact=exact, values=values, given=given, chosen=chosen, followers=followers, links=links)

    def _links(self, coupled: Coupled, names: Mapping[int, str]) -> tuple[tuple[Link, ...], tuple[Follower, ...]]:
        try:
            return links_of(self.mechanism, self.network, coupled)
        except NotAlgebraicError as error:
            name, columns = next(iter(coupled.left.items()))
            tied = " and ".join(names[c] for c in columns)
            raise self.error(f"the coupling {name} ties {tied}, which nothing held settles, and {error}; "
                             f"hold {names[columns[0]]} (at)") from error  # fmt: skip

    def _check_couplings(self, coupled: Coupled, names: Mapping[int, str]) -> None:
        for name, terms in coupled.met.items():
            parts = [
                high_precision(c * self.given.get(column, sympy.Integer(0)) ** k)
                for column, powers in terms.items() for k, c in enumerate(powers, start=1)
            ]  # fmt: skip
            if abs(sum(parts)) > COUPLED * max(map(abs, parts)):
                together = " and ".join(names[c] for c in terms)
                raise self.error(f"the coupling {name} does not hold with these values of {together}; leave one out")

    def error(self, text: str) -> DescriptionError:
        """An error about what is held."""
        return DescriptionError(
            f"assembly modes of {self.mechanism.name} with {', '.join(self.shown) or 'nothing'} held: {text}"
        )

    def off(self, column: int, displacement: float) -> float:
        """How far a column is from its value; angles by whole turns."""
        gap = displacement - self.values[column]
        turns = any(
            motion.revolute and start == column for e in self.network.edges.values() for motion, start in e.motions
        )
        return float((gap + np.pi) % (2 * np.pi) - np.pi) if turns else float(gap)

    def labelled(self, q: Array) -> dict[str, float]:
        """Values of all single coordinates [rad, m] as the description counts them."""
        return {
            name: float(reference + q[column] * (float(self.network.length) if slides else 1.0))
            for name, column, reference, slides in singles(self.mechanism, self.network)
        }


def singles(mechanism: Mechanism, network: Network) -> list[tuple[str, int, float, bool]]:
    """(name, column, value in the reference, whether it is a length) of all coordinates with one freedom."""
    result = []
    for edge in network.edges.values():
        given = mechanism.joints[edge.name].reference
        alone = [(motion, start) for motion, start in edge.motions if motion.single]
        for place, (motion, start) in enumerate(alone):
            name = edge.name if len(edge.motions) == 1 else f"{edge.name}.{start - edge.start}"
            reference = float(high_precision(mechanism.number(given[place]))) if place < len(given) else 0.0
            result.append((name, start, reference, motion.prismatic))
    return result


def _references(mechanism: Mechanism, network: Network) -> dict[int, sympy.Expr]:
    """Exact values [rad, m] in the reference, by column, of all coordinates with one freedom."""
    result = dict[int, sympy.Expr]()
    for edge in network.edges.values():
        given = mechanism.joints[edge.name].reference
        for place, (_, start) in enumerate((motion, start) for motion, start in edge.motions if motion.single):
            result[start] = mechanism.number(given[place]) if place < len(given) else sympy.Integer(0)
    return result


def held_by(mechanism: Mechanism, drives: Mapping[str, Any], at: Mapping[str, Any]) -> Held:
    """What drives and given coordinates hold.

    Raises:
        DescriptionError: unknown names, coordinates that cannot be held, nothing to hold.
    """
    mechanism, coordinates = with_parameters(mechanism, at)
    network = network_of(mechanism)
    known = {name: column for name, column, *_ in singles(mechanism, network)}
    references = _references(mechanism, network)
    driven = {name: column for name, column in known.items() if column in network.driven}
    for name in drives:
        if name not in driven:
            raise DescriptionError(f"drives {name}: no driven coordinate of this name; {did_you_mean(name, driven)}")
    for name in coordinates:
        if name in drives:
            raise DescriptionError(f"{name} is given twice, as a drive and with what is held (at); give it once")
        if name not in known:
            raise DescriptionError(f"at {name}: no parameter or coordinate of this name; "
                                   f"{did_you_mean(name, [*mechanism.parameters, *known])}")  # fmt: skip
    exact = {} if coordinates else dict.fromkeys(driven.values(), CONTEXT.zero)
    displaced = dict[int, sympy.Expr]()
    for name, value in {**coordinates, **drives}.items():
        given = given_coordinates(mechanism, {name: value})
        (target,) = targets_of(mechanism, network, given)
        assert target.column is not None
        exact[target.column] = target.goal
        displaced[target.column] = sympy.expand(next(iter(given.values())) - references[target.column])
    if not exact:
        raise DescriptionError(f"assembly modes of {mechanism.name}: nothing is driven; give coordinates to hold (at)")
    exact = {column: exact[column] for column in references if column in exact}
    values = {column: float(goal) for column, goal in exact.items()}
    shown = {
        name: reference + values[column] * (float(network.length) if slides else 1.0)
        for name, column, reference, slides in singles(mechanism, network) if column in values
    }  # fmt: skip
    body = mechanism.platform or next(reversed(network.bodies))
    held = Held(mechanism, network, exact, values, tuple(exact), (), shown, body, displaced)
    return held.with_followers() if network.ties else held


def _independent(network: Network, columns: tuple[int, ...]) -> tuple[int, ...]:
    """The columns that hold the mechanism in the reference, one after the other; all of a mechanism without loops."""
    if not network.chords:
        return columns
    variety = ClosureVariety(network)
    q = np.random.default_rng(0).normal(size=(1, variety.columns)) * 0
    jacobian = variety.evaluate(q)[1][0]
    _, values, rows = np.linalg.svd(jacobian)
    motions = rows[int((values > RANK * values[0]).sum()) :]
    chosen: list[int] = []
    for column in columns if len(motions) else ():  # what cannot move holds itself
        part = motions[:, [*chosen, column]]
        if np.linalg.svd(part, compute_uv=False)[-1] > RANK and len(chosen) < len(motions):
            chosen.append(column)
    return tuple(chosen)
