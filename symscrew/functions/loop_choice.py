"""Which closure the functions of a model solve: try the formulations of the cut joints, keep what costs least.

    closures --Loops--> candidates --cost of rates, cost of accelerations--> `Ways`

One cost compares them all, `Loops.cost`: operations, with what divisions that wait and angles take beside them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain, islice

from symscrew.effects import Effect
from symscrew.functions.forward import accelerates, solved
from symscrew.kinematics import System
from symscrew.loops import Loops, Mode, closures, counts_all_ways


@dataclass(frozen=True)
class Ways:
    """The loops in the forms of the lowest cost; their independent coordinates are the same.

    `rates`: for rates and accelerations from the independent ones; `dynamics`: for accelerations from the drives;
    `plain`: by rows of the system, for what reads the system's residual or changes of its rows as well.
    """

    rates: Loops
    dynamics: Loops
    plain: Loops


@dataclass(frozen=True)
class _Candidate:
    """Loops by one closure, with what the functions would cost; `first`: the candidate to which it is compared."""

    loops: Loops
    effects: Sequence[Effect]
    first: _Candidate | None = None

    @cached_property
    def rates(self) -> int:
        """The cost of all rates and accelerations from the independent ones."""
        loops = self.loops
        gains = loops.accelerations_from(loops.inputs("yddot"), loops.bias(loops.system))
        return loops.cost([*loops.rates_from(loops.inputs("ydot")), *gains])

    @cached_property
    def dynamics(self) -> int:
        """The cost of accelerations from the drives; of rates where no accelerations follow from forces."""
        if not self._accelerates:
            return self.rates
        return self.loops.cost(solved(self.loops.system, self.effects, self.loops).a)

    @cached_property
    def _accelerates(self) -> bool:
        """Whatever the rows are."""
        if self.first:
            return self.first._accelerates
        return accelerates(self.loops.system, self.effects, self.loops)


def fewest_operations(system: System, effects: Sequence[Effect], independent: Sequence[str] | None) -> Ways:
    """The loops by the formulations of their cut joints that cost least; of large systems by the first.

    Raises:
        DescriptionError: see `Loops`.
    """
    tried = islice(closures(system), None if counts_all_ways(system) else 1)
    closure = next(tried)
    first = Loops(system, independent, closure)
    if first.keep_to_one_branch():
        first = Loops(system, independent, closure)
    return _cheapest(chain((first,), (Loops(system, independent, other) for other in tried)), effects)


def fewest_in_mode(found: Ways, mode: Mode, effects: Sequence[Effect], independent: Sequence[str] | None) -> Ways:
    """Likewise in an operation mode; as they are where nothing follows, or where other rates would be free."""
    if not mode.q or not mode.rows:
        return found
    system = found.plain.system
    tried = (Loops(system, independent, replace(closure, mode=mode)) for closure in closures(system))
    first = next(tried)
    return _cheapest(chain((first,), tried), effects) if first.free == found.plain.free else found


def _cheapest(tried: Iterator[Loops], effects: Sequence[Effect]) -> Ways:
    """Of loops those of the lowest cost, made one after another; the first decide which rates are free.

    What is tried stays on the tape, where the age of nodes orders the operands of what is printed: rows that are not
    the system's are therefore asked in the order dynamics, rates.
    """
    rates = dynamics = plain = first = _Candidate(next(tried), effects)
    for loops in tried:
        if loops.free != first.loops.free:
            continue
        other = _Candidate(loops, effects, first)
        if loops.closure.of_system:
            rates = min(rates, other, key=lambda way: way.rates)
            plain = min(plain, other, key=lambda way: way.dynamics)
        dynamics = min(dynamics, other, key=lambda way: way.dynamics)
        rates = min(rates, other, key=lambda way: way.rates)
    return Ways(rates.loops, dynamics.loops, plain.loops)
