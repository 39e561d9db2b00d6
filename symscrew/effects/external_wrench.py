"""An external wrench at a named point, as a run-time input."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ExternalWrench:
    """Force F [N] and moment M [N m] at a named point of a body, absolute axes: (F ; r x F + M) at O.

    The six numbers are a further input `load_<point>` of the functions that depend on loads. Power
    F . v(point) + M . omega [W]; no energy of its own.
    """

    point: str

    @property
    def port(self) -> str:
        """Name of the input."""
        return f"load_{self.point}"
