"""What corresponds in equal limbs of a program: found when it is first asked for, once for all that ask.

Corresponding --families--> readings (lanes, names) --limb_rows--> rows of corresponding operations
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from symscrew.algebra import Origin
from symscrew.program.equal_limbs import NO_LIMBS, Limb, Limbs
from symscrew.program.lanes.limb_lanes import LimbLanes, readings_of
from symscrew.program.lanes.limb_neighbours import Neighbours
from symscrew.program.lanes.limb_rows import rows_of
from symscrew.program.lanes.signed_operations import Operand, Operation, Row, signed
from symscrew.program.straight_line import Instruction

NO_ORIGINS: Mapping[int, Origin] = {}


class Reading:
    """A family of equal limbs as one reading of their names has it."""

    def __init__(
        self, operations: Mapping[int, Operation], family: tuple[Limb, ...], lanes: LimbLanes, beside: Neighbours
    ) -> None:
        """Nothing is looked for yet."""
        self.operations, self.family, self.lanes, self.beside = operations, family, lanes, beside

    @cached_property
    def rows(self) -> tuple[Row, ...]:
        """Rows of corresponding operations, a limb at the same place in all."""
        return rows_of(self.operations, self.lanes, self.beside)

    @cached_property
    def whole(self) -> tuple[Row, ...]:
        """The rows that have a member in every limb."""
        return tuple(row for row in self.rows if None not in row)

    @cached_property
    def most(self) -> int:
        """So many rows have a member in every limb at most, whatever corresponds."""
        return self.beside.most_whole(len(self.family))


class Corresponding:
    """The equal limbs of instructions: `origins` says where slots come from, without them nothing is equal."""

    def __init__(
        self,
        instructions: Sequence[Instruction],
        *,
        origins: Mapping[int, Origin] = NO_ORIGINS,
        limbs: Limbs = NO_LIMBS,
    ) -> None:
        """Nothing is looked for yet."""
        self.instructions, self.origins, self.limbs = instructions, origins, limbs
        self._readings: dict[int, tuple[Reading, ...]] = {}

    @cached_property
    def signed(self) -> tuple[dict[int, Operation], dict[int, Operand]]:
        """Operations by slot in order, and the slots that are another one's negative."""
        return signed(self.instructions)

    def readings(self, most: int) -> Iterator[Reading]:
        """Those of all families with at most so many limbs."""
        for number, family in enumerate(self.limbs.families):
            if len(family) <= most:
                if number not in self._readings:
                    self._readings[number] = tuple(self._read(family))
                yield from self._readings[number]

    def _read(self, family: tuple[Limb, ...]) -> Iterator[Reading]:
        operations, negatives = self.signed
        beside = None
        for lanes in readings_of(operations, negatives, self.origins, family):
            beside = beside or Neighbours(operations, lanes.lane)  # the same for all: readings differ by names alone
            yield Reading(operations, family, lanes, beside)
