"""A tape as it was: what is made for one purpose leaves no trace for others.

    mark = tape_mark(tape)      ...      with tape_as_at(tape, mark): passes over one function

The age of nodes orders the operands of what is printed, and equal nodes are one. Passes that rewrite a function
therefore work on the tape as it was when all functions were there: a program is the same whether others were asked for
or not.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from symscrew.algebra.nodes import Node, Tape


@dataclass(frozen=True)
class TapeMark:
    """How much a tape holds: the number of its nodes, and of the entries of each of its tables."""

    nodes: int
    tables: dict[str, int]


def tape_mark(tape: Tape) -> TapeMark:
    """What the tape holds now."""
    return TapeMark(len(tape.nodes), {name: len(table) for name, table in tape.tables().items()})


@contextmanager
def tape_as_at(tape: Tape, mark: TapeMark) -> Iterator[None]:
    """The tape as at the mark. What came later is back afterwards, and what was made meanwhile is gone.

    Values at the sample states are hidden as well: meanwhile an index may be that of another node. Functions that are
    compiled when they are first called may be called by several threads: one after another has the tape as it was.
    """
    with tape.lock:
        later, samples = _cut(tape, mark), tape.hide_samples()
        try:
            yield
        finally:
            _cut(tape, mark)
            nodes, entries = later
            tape.nodes += nodes
            tables = tape.tables()
            for name, items in entries.items():
                tables[name].update(items)
            tape.show_samples(samples)


def _cut(tape: Tape, mark: TapeMark) -> tuple[list[Node], dict[str, list[tuple[Any, Any]]]]:
    """Take away what came after the mark, and return it in its order."""
    nodes = tape.nodes[mark.nodes :]
    del tape.nodes[mark.nodes :]
    tape.counted = None
    entries = {}
    for name, table in tape.tables().items():
        count = len(table) - mark.tables.get(name, 0)
        if count:  # the last ones, as nothing in a table is ever replaced
            entries[name] = [table.popitem() for _ in range(count)][::-1]
    return nodes, entries
