"""The law of compliant contacts: Hunt and Crossley's force of a depth and its rate, which never pulls.

    F = k d^n max(0, 1 + h d_dot),      d = max(0, depth)

(ASME J. Appl. Mech. 42, 1975, 440-445.) F and, for n > 1, its derivatives are continuous where contact begins. The
coefficient h stands for what an impact at rate v0 gives back, e: Hunt and Crossley h = 3 (1 - e)/(2 v0), Lankarani and
Nikravesh h = 3 (1 - e^2)/(4 v0) (J. Mech. Design 112, 1990, 369-376), both for e near 1.
"""

from __future__ import annotations

from dataclasses import dataclass

from symscrew.algebra import Node, Tape
from symscrew.effects.parts import Parts
from symscrew.errors import DescriptionError, shorten

EXPONENTS = (1, 1.5, 2)  # of a depth without calling pow: linear, Hertz's for spheres, and the square


@dataclass(frozen=True)
class ContactLaw:
    """k [N/m^n or N m/rad^n], n, and h [s/m or s/rad] as nodes."""

    stiffness: Node
    exponent: float
    damping: Node

    def at(self, tape: Tape, depth: Node, speed: Node) -> tuple[Node, Node, Node]:
        """The force at a depth (none where it is not above 0) and its rate, its part k d^n, and the stored energy."""
        inside = tape.function("less", 0, depth)
        depth = tape.function("select", inside, depth, 0)
        power = depth * {1: tape.one, 1.5: tape.sqrt(depth), 2: depth}[self.exponent]
        elastic = self.stiffness * power
        factor = 1 + self.damping * speed
        pulls = tape.function("less", factor, 0)
        damped = self.damping is not tape.zero
        force = elastic * tape.function("select", pulls, 0, factor) if damped else elastic
        return force, elastic, elastic * depth * tape.reciprocal(tape.node(self.exponent + 1))


def contact_law(parts: Parts, stiffness: object, exponent: object, damping: object, *, what: str) -> ContactLaw:
    """The law of these numbers; `what` says which effect asks.

    Raises:
        DescriptionError: a stiffness that is not above 0, a damping below 0, another exponent than 1, 1.5 and 2.
    """
    k = parts.number(stiffness, f"{what}: stiffness", above=0)
    h = parts.number(damping, f"{what}: damping", least=0)
    n = parts.fixed(exponent, f"{what}: exponent")
    if n not in EXPONENTS:
        raise DescriptionError(f"{what}: expected an exponent of 1, 1.5 or 2, got {shorten(exponent)}")
    return ContactLaw(k, n, h)
