"""The scene of the demo: the motion and the load of section 5 of the source paper.

J.-S. Zhao, X.-C. Sun, S.-T. Wei, Machines 2023, 11(8), 840, eqs. (50)-(51) and section 5.2, as read in the
README: the platform's angular velocity is prescribed in two components, the third follows from the loops.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

Array = np.ndarray


@dataclass(frozen=True)
class CircularTilt:
    """omega_x = -amplitude sin(frequency t), omega_y = amplitude cos(frequency t), absolute axes [rad/s]."""

    amplitude: float = 0.1
    frequency: float = 1.0

    @property
    def components(self) -> Sequence[str]:
        """The prescribed components of the platform's twist."""
        return ("wx", "wy")

    def rate(self, t: Array) -> Array:
        """Both components (..., 2) [rad/s]."""
        phase = self.frequency * t
        return self.amplitude * np.stack([-np.sin(phase), np.cos(phase)], axis=-1)

    def acceleration(self, t: Array) -> Array:
        """Their time derivatives (..., 2) [rad/s^2]."""
        phase = self.frequency * t
        return self.amplitude * self.frequency * np.stack([-np.cos(phase), -np.sin(phase)], axis=-1)


@dataclass(frozen=True)
class Scene:
    """A motion over `duration` [s] in `steps` equal steps, and a load (force [N] ; moment [N m]) at a point."""

    motion: CircularTilt
    duration: float
    steps: int
    loaded_point: str
    load: tuple[float, ...]

    @property
    def time(self) -> Array:
        """All instants (steps + 1,)."""
        return np.linspace(0.0, self.duration, self.steps + 1)


SECTION_5 = Scene(CircularTilt(), 10.0, 10_000, "E", (0.0, 0.0, 1000.0, 1000.0, 0.0, 0.0))
