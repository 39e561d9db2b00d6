"""An external wrench at a named point, as a run-time input."""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect
from symscrew.program import Port

UNITS = ("N",) * 3 + ("N m",) * 3
LABELS = ("fx", "fy", "fz", "mx", "my", "mz")


@dataclass(frozen=True, repr=False)
class ExternalWrench(Effect):
    """Force F [N] and moment M [N m] at a named point of a body, absolute axes: (F ; r x F + M) at O.

    The six numbers are a further input `load_<point>` of the functions that depend on loads. Power
    F . v(point) + M . omega [W]; no energy of its own.
    """

    point: str

    @property
    def port(self) -> str:
        """Name of the input."""
        return f"load_{self.point}"

    def act(self, acting: Acting) -> None:
        """Push the body at the point with the input's force and moment."""
        point = acting.point(self.point, "external wrench")
        text = f"force and moment on {point.body} at {point.name}, absolute axes"
        fx, fy, fz, mx, my, mz = acting.input(Port(self.port, (6,), UNITS, LABELS, text), "external load")
        acting.push(point, (fx, fy, fz), (mx, my, mz))
