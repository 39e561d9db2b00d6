"""Whether a run by library integrators comes by a singular configuration, where it does not follow the branches.

The compiled loop does follow them (kernels/branch.c). Here the smallest singular value of the closure is looked at
after every step: it falls and rises along straight lines near its zero, so that two steps say whether the zero, or a
smallest value near it, lies between them.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

import numpy as np

from symscrew.simulation.recording import shown_time
from symscrew.simulation.scene_functions import PlantFunctions, RunError

# A smallest singular value above this part of a regular one is no passage, however fast it changes. Larger: regular
# motions are doubted; smaller: a long step jumps over a singular configuration and nobody says so.
NEAR = 0.5
# Both ends of a step add up to the way between them where the zero lies inside; half as much again is for bends.
BEND = 1.5
# So many steps in a row at such places that together take less than this part of the run are no passage: what is left
# of slopes there is noise, of which steps become shorter without end (ten thousand of them took minutes).
MOST_STEPS, BRIEF = 100, 1e-3
TOUCHED = 0.02  # below this part of a regular value the state is in a singular configuration for doubles to tell


@dataclass
class SingularWatch:
    """The smallest singular value after every step; `regular`: the smallest one of regular configurations.

    `duration` [s]: of the run.

    `found`: time [s] of the first doubtful step and the part of a regular value that was left there.
    """

    regular: float
    duration: float
    found: tuple[float, float] | None = None
    _last: tuple[float, float] | None = field(default=None, repr=False)
    _slope: float = 0.0
    _there: deque[float] = field(default_factory=lambda: deque(maxlen=MOST_STEPS), repr=False)  # times of steps

    def seen(self, t: float, value: float) -> None:
        """After a step to t.

        Raises:
            RunError: steps do not lead away from a singular configuration.
        """
        if self._last is not None and t > self._last[0]:
            step, change = t - self._last[0], abs(value - self._last[1])
            steepest = max(change / step, self._slope)
            near = min(value, self._last[1]) < NEAR * self.regular and value + self._last[1] < BEND * step * steepest
            if self.found is None and (near or value < TOUCHED * self.regular):
                self.found = (t, value / self.regular)
            self._slope = change / step
        self._last = (t, value)
        if value >= TOUCHED * self.regular:
            self._there.clear()
        self._there.append(t)
        further = t - self._there[0]
        if len(self._there) == MOST_STEPS and further < BRIEF * self.duration:
            raise RunError(
                f"beside a singular configuration at t = {shown_time(t)} s {MOST_STEPS} steps led only {further:.2g} s "
                "further: this integrator does not follow the branches of the motion there; the compiled dop853 does"
            )

    @property
    def doubts(self) -> tuple[str, ...]:
        """In words, for the verdict."""
        if self.found is None:
            return ()
        t, part = self.found
        return (
            f"near t = {shown_time(t)} s the closure is singular or almost ({part:.2g} of regular), where this "
            "integrator does not follow the branches of the motion; the compiled dop853 does",
        )


def singular_watch(functions: PlantFunctions, duration: float) -> SingularWatch | None:
    """The watch of a run of this duration [s], measured at the model's sample states; None where no row can be lost."""
    plant = functions.plant
    if plant.closure is None or not 0 < plant.rank < functions.nv:
        return None
    values = [
        float(np.linalg.svd(functions.opening(q)[1], compute_uv=False)[plant.rank - 1])
        for q in plant.system.sample_states[0]
    ]
    return SingularWatch(min(values), duration)
