"""Inverse kinematics that knows the mechanism: a configuration by some coordinates, and why where there is none.

coordinates by name --loops closed, what is given reached--> all others: parasitic motion, motors, passive joints
                    --not reached, least squares--> which limb stays open, or that the mechanism cannot move so
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy

from symscrew import notebook, program
from symscrew.description import Mechanism
from symscrew.errors import expect
from symscrew.kinematics import System, coordinate_units, given_coordinates
from symscrew.mobility.configuration import (
    CUT_OFF,
    FITS,
    Reached,
    UnreachedError,
    displaced,
    motions_near,
    with_parameters,
)
from symscrew.mobility.finite import Array, ClosureVariety
from symscrew.mobility.joint_network import Network, network_of
from symscrew.mobility.pose_targets import Target, targets_of

OK, OUT_OF_REACH, NOT_ON_MECHANISM = "ok", "out of reach", "not on the mechanism"
CODES = {OK: 0, OUT_OF_REACH: program.OUT_OF_REACH, NOT_ON_MECHANISM: program.NOT_ON_MECHANISM}
DAMPED_STEPS = 200
"""Of least squares towards what cannot be reached: they only name what is missed most, which settles after a few."""
DAMPING = 1e-3
"""Levenberg's damping at first, without units: a step of a rad or a length is taken as it is, one of a hundred not."""
WORTH_TRYING = 1e-15
"""Damping at which nothing is gained any more: the step is then rounding."""

NEARLY = 1e-4
"""Of the mechanism's size: loops that least squares close so far may be closed by what was given after all, beside a
singular configuration, where doubles do not find it."""
SAME = 1e-9
"""Numbers of configurations, in rad and lengths of the mechanism, that differ by less are equal."""
STIFF = 100.0
"""Weight of what is given against the loops: the pose is held, and the limb that cannot follow opens."""


@dataclass(frozen=True)
class Configuration:
    """Where a mechanism is when some of its coordinates are given.

    Attributes:
        status: "ok", "out of reach" (a limb cannot get there; `limb` names it), or "not on the mechanism" (its
            constraints do not let it move so: more is given than it has freedoms, and it does not fit together; or a
            number that none of its motions changes, as the tilt of a delta's platform, judged by samples of them).
        text: the same in a sentence.
        values: every coordinate by its name [rad, m], see `symscrew.kinematics.coordinate_names`; empty unless ok.
        limb: the limb, or joint that closes a loop, that stays open most; empty where ok.
    """

    mechanism: Mechanism
    asked: Mapping[str, Any]
    status: str
    text: str
    values: Mapping[str, float] = field(default_factory=dict)
    limb: str = ""
    reached: Reached | None = field(default=None, repr=False)

    def __repr__(self) -> str:
        return f"<Configuration of {self.mechanism.name}: {self.text}>"

    def _repr_html_(self) -> str:
        units = coordinate_units(self.mechanism)
        rows = [(name, f"{value:.9g}", units.get(name, "")) for name, value in self.values.items()]
        return notebook.table(f"{self.mechanism.name}: {self.text}", ("coordinate", "value", "unit"), rows)

    @property
    def ok(self) -> bool:
        """Whether the mechanism is there."""
        return self.status == OK

    @property
    def code(self) -> int:
        """What a generated function returns in such a case; of limbs that do not get there the first one's."""
        return CODES[self.status]

    @property
    def pose(self) -> dict[str, float]:
        """The platform's pose by its parts, `z`, `tilt`, `torsion` ... [m, rad]: parasitic motion included."""
        own = f"{self.mechanism.platform}."
        return {name.removeprefix(own): value for name, value in self.values.items() if name.startswith(own)}

    @property
    def drives(self) -> dict[str, float]:
        """Coordinates of the driven freedoms by name [rad, m]: where the motors are to be."""
        if not self.ok:
            return {}
        return {
            name: self.values[name.replace(".", ".r") if joint.kind.ball else name]
            for joint in self.mechanism.joints.values()
            for k, name in enumerate(joint.kind.freedom_names(joint.name))
            if k in joint.driven
        }

    @property
    def q(self) -> np.ndarray:
        """Coordinates of the spanning tree (nq,), as the functions of a model take them; not numbers unless ok."""
        system = System(self.mechanism)
        if self.reached is None:
            return np.full(len(system.tree.q), np.nan)
        return self.reached.tree(system)


def inverse_kinematics(mechanism: Mechanism, at: Mapping[str, Any] | None = None, **coordinates: Any) -> Configuration:
    """The configuration with the given coordinates, assembled from the reference; all others follow.

    Args:
        mechanism: any mechanism.
        at: name -> value, for names with dots such as "limb1_U.0"; parameters too.
        coordinates: the same as keywords: `z="-20mm", tilt="10deg"`, of the platform, or a joint's name.

    Raises:
        DescriptionError: a name or value that cannot be read; what cannot be reached is a status.

    >>> from symscrew import catalogue
    >>> inverse_kinematics(catalogue.load("four_bar"), A="20deg").ok
    True
    """
    expect(at or {}, Mapping)
    asked = {**(at or {}), **coordinates}
    mechanism, wanted = with_parameters(mechanism, asked)
    network = network_of(mechanism)
    given = given_coordinates(mechanism, wanted)
    try:
        reached = displaced(mechanism, network, given)
    except UnreachedError as error:
        return _unreached(mechanism, asked, given, error)
    where = ", ".join(f"{name} = {value}" for name, value in asked.items()) or "the reference configuration"
    return Configuration(mechanism, asked, OK, f"at {where}", reached.values, reached=reached)


def _unreached(
    mechanism: Mechanism, asked: Mapping[str, Any], given: Mapping[str, sympy.Expr], error: UnreachedError
) -> Configuration:
    """Why it is not reached: by least squares the loops stay open, of one limb most; or there is no freedom for it."""
    network = network_of(mechanism)
    kept = _kept(mechanism, network, given)
    if kept:
        text = f"{NOT_ON_MECHANISM}: {' and '.join(kept)} stay{'s' * (len(kept) == 1)} the same in every motion sampled"
        return Configuration(mechanism, asked, NOT_ON_MECHANISM, text)
    if error.numbers > error.free:
        return Configuration(mechanism, asked, NOT_ON_MECHANISM, f"{NOT_ON_MECHANISM}: {error}")
    targets = targets_of(mechanism, network, given)
    missed = _least_missed(ClosureVariety(network), targets)
    if np.abs(missed).max(initial=0.0) < NEARLY:
        text = (
            f"{OUT_OF_REACH}, or so near a singular configuration that it is not found: the loops were closed to "
            f"{np.abs(missed).max(initial=0.0):.2g} of the mechanism's size, not to rounding; give other coordinates, "
            "which determine the rest there"
        )
        return Configuration(mechanism, asked, OUT_OF_REACH, text)
    rows = missed[: 6 * len(network.chords)].reshape(-1, 6)
    if not len(rows):
        return Configuration(mechanism, asked, OUT_OF_REACH, f"{OUT_OF_REACH}: {error}")
    worst = network.chords[int(np.argmax(np.abs(rows).max(axis=1)))]
    limb = next((name for name, one in mechanism.limbs.items() if worst in one.joints), worst)
    return Configuration(mechanism, asked, OUT_OF_REACH, f"{OUT_OF_REACH}: {limb} does not get there", limb=limb)


def _kept(mechanism: Mechanism, network: Network, given: Mapping[str, sympy.Expr]) -> list[str]:
    """Names whose numbers are asked to be others than at the reference, and are as there in every sampled motion."""
    near = motions_near(network, ", ".join(given))
    variety = ClosureVariety(network)
    points = [np.zeros(variety.columns), *near]
    found = []
    for name, value in given.items():
        owner, _, part = name.rpartition(".")
        if part == "azimuth" and f"{owner}.tilt" in given:
            continue
        about = {key: given[key] for key in (f"{owner}.azimuth",) if part == "tilt" and key in given}
        for target in targets_of(mechanism, network, {name: value, **about}):
            there = [float(target.of(variety, q)) for q in points]
            if len(near) and np.ptp(there) < SAME and abs(there[0] - float(target.goal)) > FITS:
                found.append(name)
                break
    return found


def _least_missed(variety: ClosureVariety, targets: Sequence[Target]) -> Array:
    """What the loops miss, in units of the mechanism's size, where the targets are met as well as they can be."""
    q, damping = np.zeros(variety.columns), DAMPING
    goal = np.array([float(target.goal) for target in targets])

    def missed(q: Array) -> Array:
        now = np.array([float(target.of(variety, q)) for target in targets])
        return np.concatenate([variety.residual(q), STIFF * (now - goal)])

    def slopes(q: Array) -> Array:
        picked = np.array([target.gradient(variety, q) for target in targets]).reshape(len(targets), len(q))
        return np.concatenate([variety.slopes(q[None])[0], STIFF * picked])

    error = missed(q)
    for _ in range(DAMPED_STEPS):
        matrix = slopes(q)
        step = np.linalg.lstsq(matrix.T @ matrix + damping * np.eye(len(q)), -matrix.T @ error, rcond=CUT_OFF)[0]
        new = missed(q + step)
        if not new @ new < error @ error:
            damping *= 10
            if np.linalg.norm(step) < WORTH_TRYING:
                break
            continue
        gained = error @ error - new @ new
        q, error, damping = q + step, new, damping / 10
        if gained < CUT_OFF * (error @ error):
            break
    return error
