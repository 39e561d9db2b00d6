"""Large models: twice the joints or loops give at most about twice the code, and no function hides a square.

Times are benchmarks (`python -m tests.benchmarks growth`); what is asserted here are operations and bytes.
"""

from __future__ import annotations

from functools import cache

import pytest
from benchmarks.mechanisms import chain

from symscrew.accuracy.growth import four_bars
from symscrew.export.c import print_source
from symscrew.model import Model, derive
from symscrew.program import Program
from symscrew.rank_revealing import RankRevealing
from symscrew.simulation.native import source
from symscrew.simulation.programs import plant

SQUARE = ("mass_matrix",)  # n^2 entries that are not zero
FACTOR, FIRST = 2.2, 120  # the first joints of a chain cost less than all later ones, by some operations


@cache
def sized(kind: str, size: int) -> Model:
    return derive({"chain": chain, "loops": four_bars}[kind](size))


def instructions(found: Model, function: str) -> int:
    program = found.programs[function]
    parts = [program, program.dense, program.wrenches] if isinstance(program, RankRevealing) else [program]
    return sum(len(part.instructions) for part in parts if isinstance(part, Program))


def functions(found: Model) -> list[str]:
    return [name for name, program in found.programs.items() if isinstance(program, Program) and name not in SQUARE]


@pytest.mark.parametrize(("kind", "small"), [("loops", 5), pytest.param("chain", 14, marks=pytest.mark.slow)])
def test_twice_the_size_is_twice_the_operations(kind: str, small: int) -> None:
    before, after = sized(kind, small), sized(kind, 2 * small)
    for name in functions(before):
        a, b = instructions(before, name), instructions(after, name)
        assert b <= FACTOR * a + FIRST, f"{name}: {a} instructions grow to {b}"


def test_twice_the_loops_are_twice_the_bytes_of_a_run() -> None:
    small, large = (len(source(plant(sized("loops", n)))) for n in (5, 10))
    kernels = 60_000  # the same for all
    assert large - kernels <= FACTOR * (small - kernels)


@pytest.mark.slow
def test_a_chain_of_a_hundred_joints_is_linear() -> None:
    before, after = sized("chain", 50), sized("chain", 100)
    for name in functions(before):
        a, b = instructions(before, name), instructions(after, name)
        assert b <= FACTOR * a, f"{name}: {a} instructions grow to {b}"
    assert instructions(after, "mass_matrix") <= 20 * 100**2
    assert len(print_source(after, batches=False)) < 60 * sum(instructions(after, n) for n in after.programs)
