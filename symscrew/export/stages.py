"""Headings of straight-line code: of which limb, and of what part of the theory, the next statements are.

    statements, and which slot each serves, Program.origins, .limbs --headed--> /* limb1: momentum rate, eq. (35) */

Statements stand in an order that suits registers, which follows the limbs nearly everywhere. A heading opens a run of
them and names what most of its lines compute; a line that serves another limb, and whose name does not say so, says it
itself. A value that the theory has no name for is of the stage of what reads it first.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

from symscrew.algebra import Origin
from symscrew.export.value_names import ANONYMOUS
from symscrew.program import Program

# quantities of `symscrew.algebra.QUANTITIES` by the stage that they are of, with its equations in the theory
STAGES: Mapping[str, str] = {
    "geometry": "cos sin turn offset rotation position second_axis aside rod limb_target limb_length in_mode",
    "screws, eq. (5)": "screw screws",
    "velocities, eq. (6)": "omega velocity joint_rate twist twists",
    "accelerations": """
        alpha acceleration acceleration_matrix alpha_still acceleration_still acceleration_matrix_still
        joint_acceleration joint_acceleration_still twist_rate end_acceleration
    """,
    "virtual motion": "turned",
    "inertia": "inertia end_inertia composite mass_matrix",
    "momentum, eq. (31)": "momentum",
    "momentum rate, eq. (35)": "momentum_rate momentum_rate_at_O",
    "energy": "energy",
    "reciprocal wrenches, eq. (10)": "constraint contact arm lever",
    "loop closure": "opening opening_rate opening_bias closure contact_rate",
    "rates that follow": "factor follows null_space",
    "balance, eqs. (40)-(47)": """
        load force joint_force transmitted joint_transmitted pull balance multiplier multiplier_part
    """,
    "drives": "drive share",
    "reactions, eq. (32)": "joint_reaction reaction reactions",
    "free motion": """
        generalised_force articulated stiffness answer effort handed_inertia handed_force reduced_inertia reduced_force
    """,
    "pivots": "pivot determinant",
}
STAGE_OF = {quantity: stage for stage, quantities in STAGES.items() for quantity in quantities.split()}
RESULTS = "results"
MECHANISM = "mechanism"  # what is of no part of it
TOGETHER = "limbs together"  # what vectors serve
EACH = "each limb"  # what is written once for all of them
AHEAD = 12  # lines that are looked at where a stage may begin: shorter ones are in the middle of others
MOST = 8  # of these must be of another limb, or stage, for a heading: fewer and the statements are still of the last
TOLD = 3  # stages that a heading names: of more it would say everything


class Stage(NamedTuple):
    """Of a line: its limb, none on a hub; what it is in the theory; limb or body."""

    limb: str
    text: str
    place: str


class Stages:
    """The stages of a program's slots."""

    def __init__(self, program: Program) -> None:
        """Nothing is looked at yet."""
        self.program, self._known = program, dict[int, Stage | None]()

    @cached_property
    def served(self) -> Mapping[int, Origin]:
        """Slot to what it is, or else what its first reader is; of an input what reads it."""
        origins = self.program.origins
        inputs = sum(port.size for port in self.program.inputs)
        found: dict[int, Origin] = {}
        for instruction in reversed(self.program.instructions):
            own = origins.get(instruction.target)
            if own is not None:
                found[instruction.target] = own
            elif instruction.target in found:
                own = found[instruction.target]
            else:
                continue
            for arg in instruction.args:
                if type(arg) is int and (arg < inputs or arg not in origins):
                    found[arg] = own
        return found

    @cached_property
    def places(self) -> Mapping[int, str]:
        """Slot to limb or body: its own, that of all its operands, or that of its first reader.

        What is made of several, and read by several limbs, is of none of them.
        """
        origins, places = self.program.origins, dict[int, str]()
        shared = self._shared if self.limbs else frozenset[int]()
        for slot in range(sum(port.size for port in self.program.inputs)):
            places[slot] = self._place(origins.get(slot) or self.served.get(slot))
        served, place = self.served, self._place
        for target, _, args in self.program.instructions:
            own = origins.get(target)
            if own is None:
                among = {places[arg] for arg in args if type(arg) is int}
                if len(among) == 1:
                    places[target] = among.pop()
                    continue
            places[target] = place(own or served.get(target)) if target not in shared else ""
        return places

    @cached_property
    def _shared(self) -> frozenset[int]:
        """What the theory has no name for and values of several limbs are made of, themselves or through such."""
        origins, readers = self.program.origins, dict[int, set[str]]()
        for target, _, args in reversed(self.program.instructions):
            own = {self._place(origins[target])} & self.limbs if target in origins else readers.get(target, set())
            for arg in args:
                if type(arg) is int and arg not in origins:
                    readers.setdefault(arg, set()).update(own)
        return frozenset(slot for slot, limbs in readers.items() if len(limbs) > 1)

    def _place(self, origin: Origin | None) -> str:
        if origin is None:
            return ""
        limb = self.program.limbs.limb_of(origin.part)
        return limb.name if limb is not None else origin.part.partition(".")[0]

    @cached_property
    def limbs(self) -> frozenset[str]:
        """The names of limbs; what is in none of them is the hub, unless there are none."""
        return frozenset(limb.name for family in self.program.limbs.families for limb in family)

    def of(self, slot: int) -> Stage | None:
        """The stage of a slot; None of what is read by nothing that has one."""
        if slot not in self._known:
            self._known[slot] = self._found(slot)
        return self._known[slot]

    def _found(self, slot: int) -> Stage | None:
        origin = self.served.get(slot)
        if origin is None:
            return None
        place = self.places[slot]
        limb = place if not self.limbs or place in self.limbs else ""
        return Stage(limb, STAGE_OF.get(origin.quantity, RESULTS), place)


class LaneStages:
    """The stages of a program in lanes; `numbers` are the vectors, and of each the slot of one of its lanes."""

    def __init__(
        self, single: Stages, numbers: Mapping[int, int], entered: Collection[int], limbs: str = TOGETHER
    ) -> None:
        """Those of the program limb by limb; slots of `entered` are there from the start, and mostly put together.

        `limbs`: what headings call them.
        """
        self.single, self.numbers, self.entered, self.limbs = single, numbers, entered, limbs

    def of(self, slot: int) -> Stage | None:
        """That of a slot, or of equal limbs together; None of a vector that is put together."""
        if slot >= 0:
            return None if slot in self.entered else self.single.of(slot)
        stage = self.single.of(self.numbers[slot]) if slot in self.numbers else None
        return Stage(self.limbs, stage.text, self.limbs) if stage is not None else None


def headed(
    lines: Iterable[tuple[str, int | None]],
    stages: Stages | LaneStages,
    named: Callable[[int], str],
    comment: str = "/* {} */",
) -> Iterator[str]:
    """The lines with comments where another limb, or another stage, begins; `lines` come with the slot they serve."""
    lines = list(lines)
    space = "  " if comment.startswith("#") else " "  # in front of what is said behind a line: so Python has it
    known = [stages.of(slot) if slot is not None else None for _, slot in lines]
    heads = {k: (limb, text) for k, limb, text in _runs(known)}
    current = ""
    for k, ((text, slot), stage) in enumerate(zip(lines, known, strict=True)):
        if k in heads:
            current, heading = heads[k]
            yield comment.format(heading)
        if stage is None or slot is None or stage.limb == current or not ANONYMOUS.fullmatch(named(slot)):
            yield text
        else:  # foreign, and its name is silent about it
            yield f"{text}{space}{comment.format(stage.place or MECHANISM)}"


def _runs(known: Sequence[Stage | None]) -> Iterator[tuple[int, str, str]]:
    """(line, limb, heading) of every run."""
    places = [(k, stage) for k, stage in enumerate(known) if stage is not None]
    starts: list[int] = []
    current: Stage | None = None
    for n, (_, stage) in enumerate(places):
        if current is not None and stage[:2] == current[:2]:
            continue
        ahead = [other for _, other in places[n : n + AHEAD]]
        if current is None:
            new = True
        elif stage.limb != current.limb:
            new = sum([other.limb == stage.limb for other in ahead]) >= MOST
        else:
            new = sum([other[:2] == stage[:2] for other in ahead]) >= MOST
        if new:
            starts.append(n)
            current = stage
    for begin, end in pairwise([*starts, len(places)]):
        first, stage = places[begin]
        yield first, stage.limb, _heading([other for _, other in places[begin:end] if other.limb == stage.limb])


def _heading(stages: Sequence[Stage]) -> str:
    """`limb: stages`, those of most lines in the order in which they come."""
    place = Counter(stage.place for stage in stages).most_common(1)[0][0] or MECHANISM
    among = Counter(stage.text for stage in stages)
    often = {text for text, _ in among.most_common(TOLD)}
    told = [text for text in among if text in often]
    return f"{place}: {'; '.join(told)}" if [place] != told else place
