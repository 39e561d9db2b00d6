"""Time of the processor that a decomposition may take, with that of the programs it has run.

seconds --AllowedTime--> what is left, also of a part of it; that a part of it is over
"""

from __future__ import annotations

import os


def processor_seconds() -> float:
    """What this process and the programs that have ended in it have taken so far."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


class AllowedTime:
    """So many seconds of the processor from now on; a busy machine takes none of them away."""

    def __init__(self, seconds: float) -> None:
        self.seconds, self._begun = seconds, processor_seconds()

    @property
    def left(self) -> float:
        """Seconds that are left, zero where none are."""
        return max(0.0, self._begun + self.seconds - processor_seconds())

    def at_most(self, seconds: float) -> float:
        """So many seconds, or what is left."""
        return min(seconds, self.left)

    def over(self, part: float = 1.0) -> bool:
        """Whether this part of the time is over."""
        return processor_seconds() - self._begun > part * self.seconds
