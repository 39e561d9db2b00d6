"""Statements of some operations each: values that are read once are written into their readers.

    t1 = a b; t2 = c d; x = t1 + t2     -->     x = a b + c d

The order of the operations stays what it is, but for neighbours inside of a statement: a value is folded only if
everything between it and its reader is folded into that reader, too. So no value lives longer than before: folding
whatever is read once costs blocks of states 4 % where at most one operand lives longer, else 6 %. What is computed
stays the same bit for bit: parentheses keep the association.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from symscrew.program import Instruction, Program

OPERATIONS = 6  # of a statement: more are hard to follow
WIDTH = 92  # characters of the right-hand side: with a name in front it stays on one line, nearly always
LOOSE, SUM, PRODUCT, ATOM = range(4)  # how tightly a text holds together
# operation -> how tightly its operands must hold together, and how tightly it does itself
Bindings = Mapping[str, tuple[tuple[int, ...], int]]
BINDING: Bindings = {
    "add": ((SUM, PRODUCT), SUM),
    "sub": ((SUM, PRODUCT), SUM),
    "mul": ((PRODUCT, ATOM), PRODUCT),
    "div": ((PRODUCT, ATOM), PRODUCT),
    "neg": ((ATOM,), SUM),
    "reciprocal": ((ATOM,), PRODUCT),
}


Text = tuple[str, int, int]
"""A printed expression, how tightly it holds together, and its operations."""


class Found(NamedTuple):
    """A value that gets a name (`named`), is read from where it is (`read`), or goes to its one place (`last`)."""

    kind: str
    slot: int
    text: str = ""


def folded(
    order: Sequence[Instruction],
    uses: Counter[int],
    table: Mapping[str, str],
    *,
    name: Callable[[int | float], str],
    places: Mapping[int, str],
    ends: Callable[[int], bool],
    binding: Bindings = BINDING,
) -> Iterator[Found]:
    """Statements in order.

    `uses`: how often a slot is read, by instructions and as a result; `places`: what reads slots that are there from
    the start, which is written out where it is read once; `ends`: slots that are read once, and by no instruction;
    `binding`: how tightly operations hold together that are in the table beside those of every program.
    """
    waiting: dict[int, Text] = {}
    known: set[int] = set()

    def released(until: int | None) -> Iterator[Found]:
        for slot in list(waiting):
            yield Found("named", slot, waiting.pop(slot)[0])
            if slot == until:
                return

    for target, op, args in order:
        own = [a for a in args if type(a) is int and a in waiting] if waiting else []
        while own and _too_long([waiting[a] for a in dict.fromkeys(own)]):
            oldest = next(slot for slot in waiting if slot in own)
            yield from released(oldest)
            own = [a for a in own if a in waiting]
        needs, binding_of_it = binding.get(op) or ((LOOSE,) * len(args), ATOM)
        operations, texts = 1, []
        for arg, need in zip(args, needs, strict=True):
            if type(arg) is int:
                if arg in waiting:
                    text, holds, inside = waiting.pop(arg)
                    operations += inside
                    texts.append(text if holds >= need else f"({text})")
                    continue
                if arg in places:
                    if uses[arg] == 1:
                        texts.append(places[arg])
                        continue
                    if arg not in known:
                        known.add(arg)
                        yield Found("read", arg)
            texts.append(name(arg))
        made = table[op].format(*texts)
        once = uses[target] == 1
        if once and not ends(target):
            waiting[target] = made, binding_of_it, operations
            continue
        if waiting:
            yield from released(None)
        yield Found("last" if once else "named", target, made)
    yield from released(None)


def statements(
    program: Program, order: Sequence[Instruction], table: Mapping[str, str], name: Callable[[int | float], str]
) -> Iterator[tuple[int, str]]:
    """(slot, right-hand side) of statements in a language that reads results at the end, by their names."""
    uses = Counter(a for i in order for a in i.args if isinstance(a, int))
    kept = [*(s for slots in program.results for s in slots), *program.tested, *program.checked]
    for slot in kept:
        if isinstance(slot, int):
            uses[slot] += 2  # more than once: it must have a name
    for found in folded(order, uses, table, name=name, places={}, ends=lambda slot: False):
        yield found.slot, found.text


def _too_long(operands: Sequence[Text]) -> bool:
    """Whether one statement of all these has too many operations, or characters."""
    length, operations = 0, 1
    for text, _, inside in operands:
        length += len(text)
        operations += inside
    return operations > OPERATIONS or length > WIDTH
