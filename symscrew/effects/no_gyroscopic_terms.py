"""Dynamics without gyroscopic terms."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect
from symscrew.errors import DescriptionError, did_you_mean, shorten


@dataclass(frozen=True, repr=False)
class NoGyroscopicTerms(Effect):
    """A simplification: omega x J omega is left out of the moment about every body's centre of mass.

    Euler's equation becomes J alpha = sum of moments; forces m a_C stay, centripetal and Coriolis accelerations of the
    centres included. The couple that is left out does no work, omega . (omega x J omega) = 0, so energy stays in
    balance. Bodies that are fixed to each other are one body. A slender rod, without inertia about its line, keeps
    its moment J n x n_ddot whole: without spin about the line it has no gyroscopic moment of its own.

    In a limb, terms in omega merge with those of other bodies, so that leaving them out can make the equations
    longer. Without `bodies` the moment is left out only if no function takes an operation more than with it; else
    it stays, a note says so, and `bodies` is then []. Named, it is left out of these bodies at any price.

        [[effects]]
        type = "no_gyroscopic_terms"
        bodies = ["platform"]
    """

    simplifies: ClassVar[str] = "no gyroscopic terms"

    bodies: tuple[str, ...] | None = None

    @property
    def depends_on(self) -> frozenset[str]:
        """The inertia: a payload's gyroscopic moment is left out as well."""
        return frozenset({"inertia"})

    def act(self, acting: Acting) -> None:
        """Nothing is added; the bodies must exist."""
        known = acting.system.mechanism.bodies
        for body in self.bodies or ():
            if body not in known:
                raise DescriptionError(
                    f"no gyroscopic terms: expected a body, got {shorten(body)}; {did_you_mean(str(body), known)}"
                )

    @property
    def leaves_out(self) -> bool:
        """Not if it is for no body."""
        return self.bodies != ()

    def keeps_gyroscopic_moment(self, body: str) -> bool:
        """Not of any body, or not of those that are named."""
        return self.bodies is not None and body not in self.bodies

    def undone(self) -> Effect | None:
        """The same for no body, where none is named."""
        return replace(self, bodies=()) if self.bodies is None else None

    @property
    def notes(self) -> tuple[str, ...]:
        """That it does nothing."""
        if self.bodies != ():
            return ()
        return (
            "no gyroscopic terms: omega x J omega stays in, since leaving it out would take more operations than "
            "keeping it; name 'bodies' to leave it out of them all the same",
        )
