"""Whether accelerations are good where a pivot is small: the same once more, every product rounded the other way.

Forward dynamics divide by pivots that were chosen while deriving. A small pivot may enlarge what rounding leaves, or
its smallness may cancel against that of what is divided; how small it is does not say which. What says it is a second
evaluation with other roundings: the two are as far apart as either is from the truth. It takes as long as one and a
half, the second path (`symscrew.program.rank_revealing`) some twenty times as long.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from symscrew.export import decimal
from symscrew.program import Instruction, Port, Program, RankRevealing, evaluate
from symscrew.runtime import entry, key_of, version

if TYPE_CHECKING:
    from symscrew.simulation.state_programs import Plant

# Operations that round; sums do as well, but where they cancel it is the products before them that are off.
ROUNDED = frozenset({"mul", "div", "reciprocal", "sqrt", "sin", "cos", "tan", "exp", "atan2"})
UP, DOWN = 1.0 + 2.0**-52, 1.0 - 2.0**-53  # a unit in the last place more, or less
# Accelerations that other roundings move by more than this many times what they move those of regular states come from
# the second path. Smaller: it is taken where rounding is no worse than elsewhere (two evaluations are up to ten times
# as far apart as either is off); larger: errors that no tolerance reduces come into steps near singular places.
APART = 20.0


@dataclass(frozen=True)
class Trial:
    """What decides between the two paths where a pivot is small.

    `slopes`: those of the plant at the model's own thresholds, with the pivots as a further output; `turned`: their
    accelerations with other roundings; `pivots` (n,): below which the two are compared; `apart`, `part`: the largest
    difference that is believed, without units, and as a part of the largest acceleration: the larger one counts.
    """

    slopes: Program
    turned: Program
    pivots: np.ndarray
    apart: float
    part: float


def trial(plant: Plant) -> Trial | None:
    """The trial of a plant's slopes; None where they have no second path."""
    forward, own = plant.forward, plant.model.programs["forward_dynamics"]
    if not isinstance(forward, RankRevealing) or not isinstance(own, Program) or not forward.guards:
        return None
    count = len(forward.guards)
    port = Port("pivots", (count,), ("1",) * count, tuple(f"pivot{k}" for k in range(count)), "pivots, without units")
    of = plant.slopes
    slopes = replace(
        of,
        outputs=(*of.outputs, port),
        results=(*of.results, tuple(slot for slot, _ in of.guards[:count])),
        guards=(
            *((slot, least) for (slot, _), (_, least) in zip(of.guards, own.guards, strict=False)),
            *of.guards[count:],
        ),
    )
    apart, part = _usual(plant)
    raised = np.array([threshold for _, threshold in forward.guards])
    return Trial(slopes, turned(of, "slopes_turned"), raised, APART * apart, APART * part)


def turned(program: Program, name: str) -> Program:
    """The first output of a program with every product one unit in the last place larger or smaller, and no guard."""
    chain: list[Instruction] = []
    needed = {slot for slot in program.results[0] if isinstance(slot, int)}
    for instruction in reversed(program.instructions):
        if instruction.target in needed:
            chain.append(instruction)
            needed.update(slot for slot in instruction.args if isinstance(slot, int))
    instructions, free, turn = list[Instruction](), program.slots, 1
    for target, op, args in reversed(chain):
        if op not in ROUNDED:
            instructions.append(Instruction(target, op, args))
            continue
        turn = (1103515245 * turn + 12345) & 0x7FFFFFFF  # signs without a rule that products could share
        instructions += [
            Instruction(free, op, args),
            Instruction(target, "mul", (free, UP if turn >> 16 & 1 else DOWN)),
        ]
        free += 1
    text = "The same with other roundings."
    outputs, results = program.outputs[:1], program.results[:1]
    return Program(name, text, program.inputs, outputs, tuple(instructions), results, (), (), free)


def first_path(name: str, chosen: Trial | None) -> list[str]:
    """Statements in C that return where the first path of the accelerations is good; `name`: of the model."""
    given, results = "&t, q, v, x, u, s, PARAMETERS", "a, x_dot"
    if chosen is None:
        return [
            f"    int outcome = {name}_slopes({given}, {results});",
            "    if (outcome != 1) {",
            "        return outcome;",
            "    }",
        ]
    return [
        "    double pivots[PIVOTS], turned[NV1];",
        f"    int outcome = {name}_slopes({given}, {results}, pivots);",
        "    if (outcome > 1 || (outcome == 0 && regular_pivots(pivots))) {",
        "        return outcome;",
        "    }",
        f"    if (outcome == 0 && {name}_slopes_turned({given}, turned) == 0 && as_usual(a, turned)) {{",
        "        return 0;",
        "    }",
    ]


def trial_constants(chosen: Trial) -> str:
    """What `roundings.c` reads."""
    numbers = ", ".join(decimal(float(pivot)) for pivot in chosen.pivots)
    lines = [f"#define PIVOTS {len(chosen.pivots)}", f"#define APART {decimal(chosen.apart)}"]
    lines += [f"#define APART_OF_SIZE {decimal(chosen.part)}"]
    return "\n".join([*lines, f"static const double REGULAR_PIVOT[PIVOTS] = {{{numbers}}};", ""])


def _usual(plant: Plant) -> tuple[float, float]:
    """How far other roundings move the accelerations of the model's sample states: medians, without units and as a
    part of the largest one. Found once, then read from the user's cache."""
    model = plant.model
    forward = model.programs["forward_dynamics"]
    assert isinstance(forward, Program)
    values = model.system.parameter_values
    about = ["roundings", version(), forward.hash, *map(repr, values.tolist()), *map(repr, plant.units.tolist())]
    with entry(key_of(*(text.encode("utf-8") for text in about))) as kept:
        found = _read(kept.read())
        if found is None:
            first, _ = evaluate(replace(forward, guards=(), limits=()), model.test_inputs["forward_dynamics"])
            other, _ = evaluate(turned(forward, "turned"), model.test_inputs["forward_dynamics"])
            apart = (np.abs(first[0] - other[0]) / plant.units).max(axis=1)
            size = (np.abs(first[0]) / plant.units).max(axis=1)
            good = np.isfinite(apart) & (size > 0)
            found = [
                float(np.median(x[good])) if good.any() else 0.0 for x in (apart, apart / np.where(good, size, 1.0))
            ]
            kept.write(json.dumps(found).encode("ascii"))
    return found[0], found[1]


def _read(kept: bytes | None) -> list[float] | None:
    try:
        found = json.loads(kept) if kept is not None else None
    except (ValueError, RecursionError):
        return None
    sound = isinstance(found, list) and len(found) == 2 and all(isinstance(x, float) and x >= 0 for x in found)
    return found if sound else None
