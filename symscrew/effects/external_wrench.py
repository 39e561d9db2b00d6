"""An external wrench at a named point: constant, a function of time, or a run-time input."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.algebra import Vector, dot
from symscrew.effects.acting import Acting, body_spin, point_velocity
from symscrew.effects.effect import Effect, Number
from symscrew.errors import DescriptionError, shorten
from symscrew.kinematics import GROUND
from symscrew.program import Port

UNITS = ("N",) * 3 + ("N m",) * 3
LABELS = ("fx", "fy", "fz", "mx", "my", "mz")


@dataclass(frozen=True, repr=False)
class ExternalWrench(Effect):
    """Force F [N] and moment M [N m] at a named point of a body: (F ; r x F + M) at O.

    Without `wrench` the six numbers are a further input `load_<point>` of the functions that depend on loads;
    with it they are constants or expressions of the time t [s] and the parameters. `axes` "absolute" (default)
    or "body": axes that the body carries and that are absolute in the reference configuration. Power
    F . v(point) + M . omega [W]; no energy of its own.

        [[effects]]
        type = "external_wrench"
        point = "tool"
        wrench = ["10*sin(2*pi*t)", 0, -5, 0, 0, 0]
        axes = "body"
    """

    point: str
    wrench: tuple[Number, ...] = ()
    axes: str = "absolute"

    @property
    def port(self) -> str:
        """Name of the input."""
        return f"load_{self.point}"

    def act(self, acting: Acting) -> None:
        """Push the body at the point with the force and the moment."""
        system = acting.system
        what = f"external wrench at {self.point}"
        point = acting.point(self.point, "external wrench")
        if self.axes not in ("absolute", "body"):
            raise DescriptionError(f"{what}: expected as axes 'absolute' or 'body', got {shorten(self.axes)}")
        if self.wrench:
            if len(self.wrench) != 6:
                raise DescriptionError(f"{what}: expected 6 numbers (force, moment), got {len(self.wrench)}")
            nodes = tuple(acting.function_of_time(w, f"{what}: {c}") for w, c in zip(self.wrench, LABELS, strict=True))
        else:
            text = f"force and moment on {point.body} at {point.name}, {self.axes} axes"
            nodes = acting.input(Port(self.port, (6,), UNITS, LABELS, text), "external load")
        force: Vector = (nodes[0], nodes[1], nodes[2])
        moment: Vector = (nodes[3], nodes[4], nodes[5])
        link = system.tree.link_of_body[point.body]
        if self.axes == "absolute" or link == GROUND:
            acting.push(point, force, moment)
            velocity, spin = point_velocity(system, point), body_spin(system, point.body)
        else:
            acting.push_in_body_axes(point, force, moment)
            twist, axes = system.twist[link], system.frames[link].axes
            local = system.local_point(link, system.geometry.vector(point.at))
            velocity, spin = (tuple(dot(row, v) for row in axes) for v in (twist.velocity_at(local), twist.angular))
        acting.feed(f"external_wrench_{self.point}", system.tape.node(dot(force, velocity) + dot(moment, spin)))
