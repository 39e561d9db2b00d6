"""Ideal rolling: a wheel, a disc or a ball that does not slide where it touches, as a constraint of the rates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.description import Mechanism, Reader, check_name
from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.kinematics import Rolling

OFF = 1e-9
"""Part of the wheel's radius by which it may be off its ground in the reference configuration: rounding of texts with
ten digits and more is below it; above it is a wheel that does not touch."""


@dataclass(frozen=True, repr=False)
class IdealRolling(Effect):
    """A body with its centre at the point `wheel` and the radius r, `radius` [m], rolls on another one, at `ground`.

    With `axis`, absolute in the reference configuration and carried by the wheel's body, it is a thin disc across the
    axis, else a ball. It rolls on the plane through the point `ground` across `normal` (absolute in the reference
    configuration and carried by the point's body); or, with `circle` R [m], in the plane across the axis on the circle
    of that radius about the point `ground`, or within it for R < 0. It touches in the reference configuration.

    Where they touch, both bodies have the same velocity: a constraint of the rates that no function of the
    coordinates has (nonholonomic), for which the wheel may get anywhere; and, unless `holds` is false, the wheel is
    held at its ground in both directions, as if it could pull. With `holds = false` joints have to do that, as a
    rack's pinion. No work is done and nothing slides, whatever force that takes; `rolling_contact` is the law of a
    wheel that slides or lifts off.

    The mechanism has fewer independent rates for it; `closure_jacobian` and `closure_bias` have two or three rows more,
    `rolling_<name>.ahead`, `.aside` and `.normal` [m/s], and `closure` zeros for the first two. The function
    `rolling_forces` tells the forces on the wheel [N]. Coordinates that rolling alone relates stay as `assemble`'s
    guess has them.

    Warning: a disc that lies flat on a plane touches it nowhere in particular: status 1 or 2.

        [[effects]]
        type = "ideal_rolling"
        wheel = "hub"
        ground = "road"
        radius = 0.3
        axis = [0, 1, 0]
    """

    wheel: str
    ground: str
    radius: Number
    normal: tuple[Number, ...] = (0, 0, 1)
    axis: tuple[Number, ...] = ()
    circle: Number | None = None
    holds: bool = True
    name: str = ""

    @property
    def label(self) -> str:
        """The name of its rows and forces."""
        return f"rolling_{self.name or self.wheel}"

    @property
    def depends_on(self) -> frozenset[str]:
        """The motion: it takes freedoms."""
        return frozenset({"motion"})

    @property
    def notes(self) -> tuple[str, ...]:
        """What becomes of coordinates."""
        return (
            f"{self.label} constrains rates: coordinates that rolling alone relates follow from no others, and "
            "'assemble' leaves them as its guess has them",
        )

    def rolled(self, mechanism: Mechanism) -> tuple[Rolling, ...]:
        """The constraint in the mechanism's numbers.

        Raises:
            DescriptionError: points, radius or directions that do not fit, a wheel that is off its ground.
        """
        what = f"ideal rolling of {self.wheel} on {self.ground}"
        for point in (self.wheel, self.ground):
            if point not in mechanism.points:
                raise DescriptionError(
                    f"{what}: expected a named point of the mechanism, got {shorten(point)}; "
                    f"{did_you_mean(str(point), mechanism.points)}"
                )
        wheel, ground = mechanism.points[self.wheel], mechanism.points[self.ground]
        if wheel.body == ground.body or wheel.body == mechanism.ground:
            raise DescriptionError(f"{what}: expected a wheel that moves, and points of two bodies; got {wheel.body!r}")
        if check_name(self.label, f"{what}: name") in mechanism.joints:
            raise DescriptionError(f"{what}: there is a joint {self.label!r}; give the key 'name'")
        reader = Reader(dict(mechanism.parameters))

        def number(value: Any, key: str) -> Any:
            return reader.number(value, f"{what}: {key}")

        circle: Any = None if self.circle is None else number(self.circle, "circle")
        inside = circle is not None and float(mechanism.number(circle)) < 0
        given = Rolling(
            self.label,
            wheel,
            ground,
            number(self.radius, "radius"),
            tuple(number(c, "normal") for c in self.normal),
            tuple(number(c, "axis") for c in self.axis),
            -circle if inside else circle,
            inside,
            self.holds,
        )
        self._check(mechanism, given, what)
        return (given,)

    def act(self, acting: Acting) -> None:
        """Nothing acts beside the constraint, which the system must have."""
        known = [cut.joint.name for cut in acting.system.cuts if cut.touch is not None]
        assert known.count(self.label) == 1, f"{self.label} is no constraint of this system: see `system_under`"

    def _check(self, mechanism: Mechanism, given: Rolling, what: str) -> None:
        """Refuse what cannot roll."""
        radius = float(mechanism.number(given.radius))
        if not radius > 0:
            raise DescriptionError(f"{what}: radius: expected a number above 0, got {shorten(self.radius)}")
        normal, axis = (_unit(mechanism, d, f"{what}: {key}") for d, key in
                        ((given.normal, "normal"), (given.axis, "axis")))  # fmt: skip
        away = _floats(mechanism, given.wheel.at) - _floats(mechanism, given.ground.at)
        if given.circle is not None:
            circle = float(mechanism.number(given.circle))
            if axis is None or circle <= (radius if given.inside else 0):
                raise DescriptionError(
                    f"{what}: on a circle expected the key 'axis', and a radius above 0, or below minus the wheel's"
                )
            distance = float(np.linalg.norm(away - (away @ axis) * axis))
            gap = circle - distance - radius if given.inside else distance - circle - radius
        else:
            if normal is None:
                raise DescriptionError(f"{what}: normal: expected 3 numbers, not all of them 0, got none")
            lean = 1.0 if axis is None else float(np.sqrt(max(0.0, 1 - (axis @ normal) ** 2)))
            if lean < OFF:
                raise DescriptionError(f"{what}: expected an axis across which the wheel touches; the disc lies flat")
            gap = float(away @ normal) - radius * lean
        if self.holds and abs(gap) > OFF * radius:
            raise DescriptionError(
                f"{what}: expected a wheel that touches its ground in the reference configuration, got one that is "
                f"{gap:g} m off; move a point or change the radius, or give 'holds = false' where joints hold it"
            )


def _floats(mechanism: Mechanism, values: Sequence[Any]) -> np.ndarray:
    return np.array([float(mechanism.number(c)) for c in values])


def _unit(mechanism: Mechanism, given: Sequence[Any], what: str) -> np.ndarray | None:
    """A direction as doubles; None where none is given."""
    if not given:
        return None
    values = _floats(mechanism, given)
    if len(values) != 3 or not np.any(values):
        raise DescriptionError(f"{what}: expected 3 numbers, not all of them 0, got {shorten(given)}")
    return np.asarray(values / np.linalg.norm(values))
