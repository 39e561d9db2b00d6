"""A payload that is fixed to a body."""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy

from symscrew.description import Body, Matrix3, Mechanism, Reader, Vector, validate
from symscrew.effects.effect import Effect, Number
from symscrew.errors import DescriptionError, did_you_mean, shorten


@dataclass(frozen=True, repr=False)
class Payload(Effect):
    """A mass m [kg] fixed to a body, its centre at `com` [m] (absolute, in the reference configuration).

    `inertia`: three principal moments along the absolute axes of the reference configuration, or the six entries
    xx, yy, zz, xy, xz, yz, about the payload's own centre [kg m^2]; without it a point mass. Body and payload become
    one body, exactly (Steiner): mass M + m, centre (M c + m r)/(M + m), inertia J + I + M m/(M + m) (|d|^2 - d d^T)
    with d = r - c. What gravity and inertia do with it follows; an expression of a run-time parameter as mass makes
    the payload a run-time input. Coordinates and the characteristic length stay those of the mechanism.

        [[effects]]
        type = "payload"
        body = "platform"
        mass = 12
        com = [0, 0, 0.4]
    """

    body: str
    mass: Number
    com: tuple[Number, ...]
    inertia: tuple[Number, ...] = ()

    @property
    def depends_on(self) -> frozenset[str]:
        """The inertia: the payload's weight goes with gravity."""
        return frozenset({"inertia"})

    def transform(self, mechanism: Mechanism) -> Mechanism:
        """The mechanism with the payload's body heavier."""
        what = f"payload on {self.body}"
        if self.body not in mechanism.bodies:
            raise DescriptionError(
                f"{what}: expected a body, got {shorten(self.body)}; {did_you_mean(self.body, mechanism.bodies)}"
            )
        read = Reader(dict(mechanism.parameters))
        mass = read.number(self.mass, f"{what}: mass")
        if not float(mechanism.number(mass)) > 0:
            raise DescriptionError(f"{what}: expected a mass above 0 kg, got {shorten(self.mass)}")
        com = read.vector(self.com, f"{what}: com")
        if len(self.inertia) not in (0, 3, 6):
            raise DescriptionError(f"{what}: expected 3 or 6 entries of the inertia, got {len(self.inertia)}")
        entries = [read.number(v, f"{what}: inertia") for v in self.inertia]
        entries += [sympy.S.Zero] * (6 - len(entries))
        xx, yy, zz, xy, xz, yz = entries
        own: Matrix3 = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
        payload = Body(self.body, mass, com, own)
        joined = _joined(mechanism.bodies[self.body], payload)
        validate(replace(mechanism, bodies={**mechanism.bodies, self.body: payload}))
        return replace(mechanism, bodies={**mechanism.bodies, self.body: joined})


def _joined(a: Body, b: Body) -> Body:
    """Two bodies as one."""
    if a.mass is None or a.com is None or b.mass is None or b.com is None:
        return b
    mass = a.mass + b.mass
    com: Vector = tuple((a.mass * x + b.mass * y) / mass for x, y in zip(a.com, b.com, strict=True))
    d = [y - x for x, y in zip(a.com, b.com, strict=True)]
    square = sum((c * c for c in d), start=sympy.S.Zero)
    reduced = a.mass * b.mass / mass
    zero = ((sympy.S.Zero,) * 3,) * 3
    first, second = a.inertia or zero, b.inertia or zero
    rows = tuple(
        tuple(first[i][j] + second[i][j] + reduced * ((square if i == j else 0) - d[i] * d[j]) for j in range(3))
        for i in range(3)
    )
    return Body(a.name, mass, com, rows)  # type: ignore[arg-type]
