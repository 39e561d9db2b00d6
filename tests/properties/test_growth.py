"""Large models: every further pair of joints or of loops adds exactly the same operations.

Times are benchmarks (`python -m tests.benchmarks growth`); what is asserted here are operations and bytes.
"""

from __future__ import annotations

from functools import cache

import pytest
from benchmarks.mechanisms import chain
from support.marks import slow

from symscrew.export.c import print_source
from symscrew.model import Model, derive
from symscrew.program.rank_revealing import RankRevealing
from symscrew.program.straight_line import Iteration, Program
from symscrew.simulation.run_source import source
from symscrew.simulation.state_programs import plant
from symscrew.studies.accuracy.growth_study import four_bars

pytestmark = pytest.mark.slow

SQUARE = ("mass_matrix",)  # n^2 entries that are not zero
SIZES = {"loops": (4, 6, 8), "chain": (12, 14, 16)}  # in pairs: axes of the chain, signs of determinants alternate
FILLED = {"constraint_margin": 4}  # the last row of its determinant fills, by one entry per loop; small models only
FACTOR = 2.2


@cache
def sized(kind: str, size: int) -> Model:
    return derive({"chain": chain, "loops": four_bars}[kind](size))


def instructions(found: Model, function: str) -> int:
    program = found.programs[function]
    program = program.step if isinstance(program, Iteration) else program
    parts = [program, program.dense, program.wrenches] if isinstance(program, RankRevealing) else [program]
    return sum(len(part.instructions) for part in parts if isinstance(part, Program))


def functions(found: Model) -> list[str]:
    return [name for name in found.programs if name not in SQUARE]


@pytest.mark.parametrize("kind", ["loops", slow("chain")])
def test_every_step_adds_the_same_operations(kind: str) -> None:
    models = [sized(kind, size) for size in SIZES[kind]]
    for name in functions(models[0]):
        first, second, third = (instructions(found, name) for found in models)
        assert third - second == second - first + FILLED.get(name, 0), f"{name}: {first}, {second}, {third}"


def test_twice_the_loops_are_twice_the_bytes_of_a_run() -> None:
    small, large = (len(source(plant(sized("loops", n)))) for n in (4, 8))
    kernels = 60_000  # the same for all
    assert large - kernels <= FACTOR * (small - kernels)


@pytest.mark.slow
def test_a_chain_of_thirty_joints_is_linear() -> None:
    small, pair, large = (sized("chain", n) for n in (12, 14, 30))
    for name in functions(small):
        first, added = instructions(small, name), instructions(pair, name) - instructions(small, name)
        assert instructions(large, name) == first + (30 - 12) // 2 * added, name
    assert instructions(large, "mass_matrix") <= 6_976
    assert len(print_source(large, batches=False)) < 60 * sum(instructions(large, n) for n in large.programs)
