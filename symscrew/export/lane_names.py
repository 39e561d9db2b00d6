"""What vectors are called whose lanes are equal limbs: by what their lanes are called.

limb1_lower_omega_x | limb2_lower_omega_x | ...  -->  limb_lower_omega_x
limb1_U_sin | minus_limb2_U_cos | ...            -->  each_limb1_U_sin: corresponds to that of the first limb
-limb1_arm_x | limb2_arm_x | ...                 -->  signed_limb_arm_x: up to the sign of each lane
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property

from symscrew.export.c_names import TAKEN
from symscrew.export.c_printed import Printed, place
from symscrew.export.value_names import ANONYMOUS, LONGEST
from symscrew.program import Instruction, Pack

MINUS = "minus_"


class LaneNames:
    """The names of vectors, which are negative numbers, beside those of the program's slots."""

    def __init__(self, printed: Printed, width: int) -> None:
        """None yet."""
        self.printed, self.width = printed, width
        constants = printed.shared.constants.names.values() if printed.shared else ()
        self.used = {*TAKEN, *printed.names.values(), *constants, *printed.called.values()}
        self.found: list[str] = []
        self.numbers: dict[str, int] = {}  # behind a stem: all before it are taken

    @cached_property
    def instructions(self) -> dict[int, Instruction]:
        """The program's instructions by target."""
        return {i.target: i for i in self.printed.angles.rest}

    def of(self, value: int | float) -> str:
        """The name of a vector, or of a single value; a constant by its own."""
        if not isinstance(value, int) or value in self.printed.called:
            return self.printed.named(value)
        return self.found[-1 - value] if value < 0 else f"copy_{value}"

    def entered(self, slot: int) -> str:
        """What reads a slot that is there from the start."""
        return place(*self.printed.entries[slot])

    def pack(self, pack: Pack) -> int:
        """The number of a pack, which has a name from here on."""
        lanes = zip(pack.targets, pack.signs, strict=True)
        called = self.printed.called  # without those that only make lanes alike
        return self._numbered([(called[slot], sign) for slot, sign in lanes if slot is not None and slot in called])

    def gathered(self, entries: Sequence[int | float]) -> int:
        """The number of a vector that is put together of slots and constants."""
        called = self.printed.called
        return self._numbered([(called[a], 1) for a in entries if isinstance(a, int) and a in called])

    def other(self) -> int:
        """The number of a vector that is of no slots."""
        return self._numbered([])

    def _numbered(self, lanes: Sequence[tuple[str, int]]) -> int:
        name = stem = vector_name(lanes)
        number = self.numbers.get(stem, 2 if stem else 1)
        while not name or name in self.used:
            name = f"{stem}_{number}" if stem else f"lanes_{number}"
            number += 1
        self.numbers[stem] = number
        self.used.add(name)
        self.found.append(name)
        return -len(self.found)


def vector_name(lanes: Sequence[tuple[str, int]]) -> str:
    """The name of a vector from the names of its lanes and the sign with which each is in it; "" where none tells.

    >>> vector_name([("limb1_arm_x", 1), ("limb2_arm_x", 1)])
    'limb_arm_x'
    >>> vector_name([("limb1_arm_x", 1), ("minus_limb2_arm_x", 1)])
    'signed_limb_arm_x'
    >>> vector_name([("limb1_arm_x", 1), ("limb2_arm_y", 1)]), vector_name([("t1", 1), ("t2", 1)])
    ('each_limb1_arm_x', '')
    """
    signs = {(-1 if name.startswith(MINUS) else 1) * sign for name, sign in lanes}
    names = [name.removeprefix(MINUS) for name, _ in lanes]
    told = [name for name in names if not ANONYMOUS.fullmatch(name)]
    if not told:
        return ""
    bare = {re.sub(r"(?<=[A-Za-z])\d+", "", name, count=1) for name in names}
    if len(bare) > 1 or len(names) == 1:
        text = f"each_{told[0]}"
    else:
        text = ("" if signs == {1} else MINUS if signs == {-1} else "signed_") + bare.pop()
    return text if len(text) <= LONGEST else ""
