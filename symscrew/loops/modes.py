"""The operation mode of the reference configuration: coordinates that follow from others on all of it.

A delta's platform does not turn, and the rods of an arm stay parallel: on the branch of the configuration space that
goes through the reference configuration some coordinates are constant, and some are others (or their opposites) up
to a constant. A model of that mode alone reads each of them once. Elsewhere (a parallelogram's crossed branch) it does
not hold, so its functions look whether the state they are given is of this mode, and fail where it is not.

What follows what is certified numerically: at every sample state, for coordinates and for rates.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from symscrew.algebra import Node, divides, inputs_of, named_entries, needed, substitute
from symscrew.kinematics import System
from symscrew.program import NOT_ON_MECHANISM, Function, roots_of, with_roots

MOVES = 1e-6
"""Samples that differ by less, in radians or characteristic lengths, show no motion, and nothing then follows anything:
sample states are spread by 0.1 and more where a mechanism moves, and closed to 1e-12 where it does not."""

SAME = 1e-9
"""Samples that agree to this, in the same units, are one value: they are closed to 1e-12, while a coordinate that only
nearly follows another is off by the square of their spread. Above it both are read."""

OFF = 1e-6
"""A state this far off the mode, in the same units, is not of it and the function's status is 1; rates likewise, beside
the independent rates. States that were closed in double precision, or integrated, are well within it."""

HALF = 0.5  # between what a comparison gives, 0 and 1

NOTHING = 1e-12
"""Rates [rad/s, or characteristic lengths per second] below this are none: rounding at rest is not off the mode."""

SOLVED = ("velocity", "acceleration", "null_space", "inverse_dynamics", "inverse_kinematics", "drive_positions",
          "inverse_velocity", "joint_reactions", "forward_dynamics", "linearisation")  # fmt: skip
"""Functions (and those named after them) that take closed loops for granted. Others are true of open loops too."""


@dataclass(frozen=True)
class Follower:
    """Entry `index` of q or v is `sign` * entry `leader` + `shift` [rad or m], or `shift` alone."""

    index: int
    leader: int | None
    sign: int
    shift: float


@dataclass(frozen=True)
class Mode:
    """The operation mode of a system: `q` and `v`, entries that follow from others, and `free`, its independent rates.

    `free` are indices into v.
    """

    system: System
    q: tuple[Follower, ...]
    v: tuple[Follower, ...]
    free: tuple[int, ...]

    def notes(self, *, alone: bool) -> tuple[str, ...]:
        """Which coordinates follow, for people; `alone`: whether functions are for this mode only."""
        if not self.q:
            return ()
        labels = [c.label for c in self.system.tree.q]
        names = ", ".join(labels[f.index] for f in self.q)
        what = "functions of closed loops are for it only" if alone else "one_mode makes code for it only"
        return (f"operation mode of the reference configuration: the other coordinates determine {names}; {what}",)

    def alone(self, function: Function) -> Function:
        """The function for states of this mode only; unchanged if it does not rest on closed loops."""
        inputs = self.system.inputs
        known = {node for nodes in function.arguments for node in nodes}
        solved = any(function.name == name or function.name.startswith(f"{name}_") for name in SOLVED)
        moving = bool(known & set(inputs.v))
        if not solved or not known & {inputs.q[f.index] for f in self.q}:
            return function
        if moving and not known >= {inputs.v[k] for k in self.free}:
            return function
        # What is not read cannot matter: of a whole motion, and of the platform's from which the rest follows.
        given = known >= set(inputs.a) or not known >= set(inputs.q)
        read = inputs_of([node for values in function.results for node in values]) if given else known
        followed = {node: leader for node, leader in self.nodes.items() if inputs_of([leader]) <= known}
        found = with_roots(function, substitute(self.system.tape, roots_of(function), followed))
        used = needed([node for values in found.results for node in values])
        guards: dict[Node, float] = {}
        for pivot, threshold in found.guards:
            if divides(pivot, used):
                guards[pivot] = max(threshold, guards.get(pivot, 0.0))
        read = {node for node in read if node in followed}
        tests = [self._configuration(read), *([self._rates(read)] if moving else [])]
        named_entries(tests, "in_mode", ["configuration", "rates"][: len(tests)])
        guards |= {test: HALF for test in tests if test.value is None}
        limits = tuple(limit for limit in found.limits if not self._implied(*limit))
        return replace(found, guards=tuple(guards.items()), limits=limits)

    def _implied(self, opening: Node, low: float | None, high: float | None, status: int) -> bool:
        """Whether a limit on an opening cannot be passed: see `closes`; not of quaternions, which are not moved."""
        inputs, tree = self.system.inputs, self.system.tree
        turning = {inputs.q[k] for start, _ in tree.spheres for k in range(start, start + 4)}
        if status != NOT_ON_MECHANISM or high is None or not inputs_of([opening]) <= set(inputs.q) - turning:
            return False
        return self.closes(opening, SAME * SAME)

    def closes(self, opening: Node, closed: float = SAME) -> bool:
        """Whether all configurations of this mode, also others than the mechanism's, leave less open than `closed`.

        Looked at where the sample states are moved at random, by a tenth of a radian or of the characteristic length.
        """
        inputs, tree = self.system.inputs, self.system.tree
        q = self.system.sample_states[0]
        sizes = np.array([self.system.length if c.kind == "length" else 1.0 for c in tree.q])
        moved = q + 0.1 * sizes * np.random.default_rng(5).uniform(-1, 1, q.shape)
        values = np.abs(self.system.numeric([opening], (inputs.q, moved)))
        reached = np.isfinite(values)
        return bool(2 * reached.sum() > reached.size and (values[reached] < closed).all())

    @cached_property
    def nodes(self) -> dict[Node, Node]:
        """What stands for the inputs of coordinates, rates and accelerations that follow."""
        inputs, tape = self.system.inputs, self.system.tape
        result = {}
        for nodes, followers in ((inputs.q, self.q), (inputs.v, self.v), (inputs.a, self.v)):
            for f in followers:
                lead = tape.zero if f.leader is None else nodes[f.leader]
                result[nodes[f.index]] = (lead if f.sign > 0 else -lead) + tape.constant(f.shift)
        return result

    @property
    def rows(self) -> list[tuple[int, dict[int, Node]]]:
        """Per joint rate that follows: its column, and a row of the closure that says so."""
        tape, found = self.system.tape, []
        spheres = [range(start, start + 3) for _, start in self.system.tree.spheres]
        still = {f.index for f in self.v if f.leader is None}
        turning = {k for sphere in spheres if not still >= set(sphere) for k in sphere}  # in other axes than v
        for f in self.v:
            if f.leader is None and f.index not in turning:
                found.append((f.index, {f.index: tape.one}))
            elif f.leader is not None and not {f.index, f.leader} & turning:
                found.append((f.index, {f.index: tape.one, f.leader: -tape.one if f.sign > 0 else tape.one}))
        return found

    def _configuration(self, read: Set[Node]) -> Node:
        """1 at a configuration of this mode, else 0: of what is read."""
        tape, inputs = self.system.tape, self.system.inputs.q
        followers = [f.index for f in self.q if inputs[f.index] in read]
        off = [inputs[k] - self.nodes[inputs[k]] for k in followers]
        total = self._size(off, [self.system.tree.q[k].kind for k in followers])
        return tape.function("less", total, tape.constant(OFF * OFF)) if followers else tape.one

    def _rates(self, read: Set[Node]) -> Node:
        """1 if the rates are of this mode, else 0: of what is read."""
        tape, inputs = self.system.tape, self.system.inputs.v
        kinds = [c.kind for c in self.system.tree.v]
        followers = [f.index for f in self.v if inputs[f.index] in read]
        off = self._size([inputs[k] - self.nodes[inputs[k]] for k in followers], [kinds[k] for k in followers])
        size = self._size([inputs[k] for k in self.free], [kinds[k] for k in self.free])
        limit = tape.constant(OFF * OFF) * size + tape.constant(NOTHING * NOTHING)
        return tape.function("less", off, limit) if followers else tape.one

    def _size(self, values: Sequence[Node], kinds: Sequence[str]) -> Node:
        """The sum of squares, lengths divided by the characteristic length."""
        tape = self.system.tape
        lengths, others = tape.zero, tape.zero
        for value, kind in zip(values, kinds, strict=True):
            if kind == "length":
                lengths = lengths + value * value
            else:
                others = others + value * value
        return others + lengths * tape.constant(1.0 / self.system.length**2)


def operation_mode(system: System, free: Sequence[int]) -> Mode:
    """The operation mode of the reference configuration: which entries of q and v are constant or follow another one.

    Args:
        system: with its sample states, at all of which what follows is certified to `SAME`.
        free: independent entries of v, by which the size of rates off the mode is measured.

    Returns:
        A mode without followers for a tree, where nothing moves, and with run-time parameters: for other values of
        them it might not hold.
    """
    q, v, _ = system.sample_states
    of_q, of_v = [c.kind for c in system.tree.q], [c.kind for c in system.tree.v]
    q, v = (x / [system.length if kind == "length" else 1.0 for kind in of] for x, of in ((q, of_q), (v, of_v)))
    if not system.cuts or system.parameters or not free or np.ptp(q, axis=0).max() < MOVES:
        return Mode(system, (), (), ())
    still = np.zeros(len(of_v))
    return Mode(
        system, _followers(q, system.reference, of_q), _followers(v / np.abs(v).max(), still, of_v), tuple(free)
    )


def _followers(samples: np.ndarray, reference: np.ndarray, kinds: Sequence[str]) -> tuple[Follower, ...]:
    """What follows what in samples (states, entries) without units; shifts as in the reference configuration."""
    result: list[Follower] = []
    leaders: list[int] = []
    for j, kind in enumerate(kinds):
        values = samples[:, j]
        if np.ptp(values) < SAME:
            result.append(Follower(j, None, 1, float(reference[j])))
            continue
        ways = ((i, sign) for i in leaders if kinds[i] == kind for sign in (1, -1))
        found = next(((i, sign) for i, sign in ways if np.ptp(values - sign * samples[:, i]) < SAME), None)
        if found is None:
            leaders.append(j)
        else:
            result.append(Follower(j, *found, float(reference[j] - found[1] * reference[found[0]])))
    return tuple(result)
