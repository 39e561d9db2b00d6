"""Which constraints are redundant: reactions that are not unique, and joints to free.

    closure rows A --left null space--> self-stresses s, s^T A = 0 --> joint wrenches without load --> joints to free

A redundant constraint is a self-stress: joint wrenches in equilibrium without load, one wrench per loop, and one force
per coupling of coordinates. A joint
whose wrench takes part in a self-stress has no unique reaction. Giving a joint one freedom more, along a twist on
which the self-stress does work, removes one redundant constraint and adds no mobility.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.mobility.instantaneous import Instantaneous
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import Real, Row, Screw, eliminate, normalised, null_space, swapped
from symscrew.mobility.screw_text import describe_wrench

NO_WORK = 1e-20
"""A component of a self-stress below this (they are of order one) carries nothing that could be freed: rounding of 60
digits. The search for joints to free ends there."""
LARGER = 1.000001
"""A joint is preferred to an earlier one only if its component is larger by this factor: equal ones, up to rounding,
are not chosen by their last digits."""


@dataclass(frozen=True)
class Overconstraints:
    """Self-stresses: joint -> wrenches (f ; m_O) that it can carry without load, scaled to metres.

    `cure`: one joint for each redundant constraint that can be removed by one more freedom there, with the
    wrench that the joint must then give up, in words; or one coupling to be left out. `couplings`: those that can
    pull without load.
    """

    count: int
    wrenches: dict[str, tuple[Screw, ...]]
    cure: tuple[str, ...]
    couplings: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"<Overconstraints: {self.count}, reactions of {len(self.wrenches)} joints not unique>"

    @property
    def statically_indeterminate(self) -> tuple[str, ...]:
        """Joints whose reaction, and couplings whose force, is not unique."""
        return (*self.wrenches, *self.couplings)


def overconstraints(network: Network, found: Instantaneous) -> Overconstraints:
    """The self-stresses of the closure: the left null space of its rows."""
    rows = found.rows
    if not rows or not found.overconstraints:
        return Overconstraints(0, {}, ())
    transposed = [list(column) for column in zip(*rows, strict=True)]
    stresses = null_space(transposed, len(rows)).basis
    wrenches: dict[str, tuple[Screw, ...]] = {}
    carried: dict[str, list[Row]] = {}
    loops = network.loops()
    for name in network.edges:
        signs = [(k, sign) for k, loop in enumerate(loops) if (sign := sum(s for joint, s in loop if joint == name))]
        own = [_wrench(stress, signs) for stress in stresses]
        carried[name] = own
        independent = eliminate(own, 6)
        if independent.rank:
            wrenches[name] = tuple(_in_metres(row, network) for row in independent.rows)
    pulling = []
    for k, tie in enumerate(network.ties, start=6 * len(network.chords)):
        if any(abs(stress[k]) > NO_WORK for stress in stresses):
            carried[tie.name] = [[stress[k]] for stress in stresses]
            pulling.append(tie.name)
    return Overconstraints(len(stresses), wrenches, _cure(carried, len(stresses), network), tuple(pulling))


def _wrench(stress: Sequence[Real], signs: Sequence[tuple[int, int]]) -> Row:
    """The wrench that a joint carries in a self-stress, as (f ; m): the stress pairs with (omega ; v).

    `signs`: the loops that it is in, and which way.
    """
    total = [sum(sign * stress[6 * k + i] for k, sign in signs) for i in range(6)]
    return swapped(total)


def _in_metres(wrench: Sequence[Real], network: Network) -> Screw:
    return normalised((*wrench[:3], *(c * network.length for c in wrench[3:])))


def _cure(carried: dict[str, list[Row]], count: int, network: Network) -> tuple[str, ...]:
    """Greedy: free one component of a joint's wrench; the self-stresses left carry none of it."""
    left = {name: [list(row) for row in own] for name, own in carried.items()}
    largest = {name: _largest(own) for name, own in left.items()}
    texts = []
    for _ in range(count):
        best = None
        for name, (size, component) in largest.items():
            if size and (best is None or size > best[0] * LARGER):
                best = (size, name, component)
        if best is None or best[0] < NO_WORK:
            break
        _, name, component = best
        work = [row[component] for row in left[name]]
        lead = max(range(len(work)), key=lambda k: abs(work[k]))
        wrench = left[name][lead]
        carries = "" if len(wrench) == 1 else describe_wrench(_in_metres(wrench, network))
        texts.append(
            f"{name}: free {_freedom(component)}; it carries a {carries}" if carries
            else f"{name}: leave this coupling out"
        )  # fmt: skip
        shares = [w / work[lead] for w in work]
        changed = [name for name, rows in left.items() if any(rows[lead])]  # joints far away carry none of it
        left = {name: _without(rows, lead, shares) for name, rows in left.items()}
        largest.update((name, _largest(left[name])) for name in changed)
    return tuple(texts)


def _largest(rows: Sequence[Row]) -> tuple[Real, int]:
    """(size, place) of the largest component; of equals the last."""
    return max(((abs(c), i) for row in rows for i, c in enumerate(row)), default=(0, 0))


def _without(rows: list[Row], lead: int, shares: Sequence[Real]) -> list[Row]:
    """What a joint carries in the other self-stresses, each with a share of the leading one taken off."""
    return [
        [a - share * b if b else a for a, b in zip(row, rows[lead], strict=True)] if share else row
        for k, (row, share) in enumerate(zip(rows, shares, strict=True))
        if k != lead
    ]


def _freedom(component: int) -> str:
    kind = "the translation along" if component < 3 else "the rotation about an axis through O parallel to"
    return f"{kind} {'xyz'[component % 3]}"
