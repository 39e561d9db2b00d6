"""Equal instructions one after the other as loops in C: found where they are, and the same bits as one by one."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from benchmarks.mechanisms import chain, platform
from support.marks import slow

from symscrew.description.mechanism import Mechanism
from symscrew.export import c_parts, c_printed, c_repeats
from symscrew.export.c import print_source
from symscrew.export.c_loops import Loop
from symscrew.export.c_precision import DOUBLE
from symscrew.export.c_printed import Printed
from symscrew.model import Model, derive
from symscrew.program.rank_revealing import RankRevealing
from symscrew.program.straight_line import Iteration, Port, Program
from symscrew.runtime.compiled import find_compiler, load
from symscrew.studies.accuracy.growth_study import four_bars

MECHANISMS: dict[str, tuple[Callable[[int], Mechanism], int]] = {
    "chain": (chain, 12),
    "loops": (four_bars, 5),
    "limbs": (platform, 5),
}
FUNCTIONS = (
    *("body_poses", "momentum_screws", "mass_matrix", "joint_reactions", "closure_jacobian"),
    *("inverse_dynamics", "forward_dynamics", "assemble"),
)
OF_OTHERS = ("joint_reactions", "momentum_screws")  # long ones of limbs; those of chains and loops are tried
EXACT = ("-ffp-contract=off",)


@cache
def sized(kind: str) -> Model:
    make, size = MECHANISMS[kind]
    return derive(make(size)).only([f for f in FUNCTIONS if kind != "limbs" or f not in OF_OTHERS])


@pytest.fixture
def everything_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every function in parts, and short runs as loops."""
    monkeypatch.setattr(c_printed, "LONG", 1)
    monkeypatch.setattr(c_repeats, "SAVED", 8)


@pytest.mark.slow
@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
@pytest.mark.parametrize("name", ["chain", *(slow(name) for name in ("loops", "limbs"))])
def test_loops_give_the_bits_of_instructions_one_by_one(
    name: str, everything_long: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = sized(name)
    source = print_source(found)
    rolled = load(found, backend="c", flags=EXACT)
    monkeypatch.setattr(c_repeats, "SEVERAL", 10**9)
    plain = print_source(found)
    assert looped_parts(source) >= 10 and looped_parts(plain) == 0
    straight = load(found, backend="c", flags=EXACT)
    for function, program in found.programs.items():
        inputs = [np.array(x) for x in found.test_inputs[function]]
        inputs[0][-1] = np.nan
        *expected, status = straight[function](*inputs, check=False)
        *results, code = rolled[function](*inputs, check=False)
        assert (code == status).all() and status[-1] > 0 and not status[:-1].any(), function
        for a, b, port in zip(expected, results, program.outputs, strict=True):
            np.testing.assert_array_equal(b, a, err_msg=f"{function}, {port.name}")


def looped_parts(source: str) -> int:
    """Parts with a loop in a printed model."""
    parts = re.findall(r"_PART double \w+_part\d+\(.*?\n\}", source, re.DOTALL)
    return sum("for (size_t k" in part for part in parts)


@pytest.mark.parametrize("name", [slow("limbs"), slow("chain"), "loops"])
def test_a_place_holds_what_is_read_from_it(name: str, everything_long: None) -> None:
    """Places are given away only after their last reader, those of loops one behind the other."""
    for program in sized(name).programs.values():
        parts = c_parts.Parts(Printed("m", "m_f", straight(program), DOUBLE))
        holds: dict[int, int] = {}
        for k, piece in enumerate(parts.pieces):
            inside = set(piece.read_from_arrays()) if isinstance(piece, Loop) else set()
            for instruction in parts.lists[k]:
                for slot in (a for a in instruction.args if isinstance(a, int)):
                    if slot in inside or parts.defined.get(slot, k) < k:
                        assert holds[parts.waiting[slot]] == slot
                if instruction.target in parts.waiting:
                    holds[parts.waiting[instruction.target]] = instruction.target
        assert max(parts.waiting.values(), default=0) < parts.room


def straight(program: Program | Iteration) -> Program:
    found = program.step if isinstance(program, Iteration) else program
    assert isinstance(found, (Program, RankRevealing)) and all(isinstance(port, Port) for port in found.inputs)
    return found


@pytest.mark.slow
def test_code_of_a_long_chain_grows_by_tables_only(everything_long: None) -> None:
    """Eight joints more add entries of tables and outputs, and three operations."""
    short, long = (print_source(derive(chain(n)).only(("inverse_dynamics",))) for n in (12, 20))
    operations = [len(re.findall(r"^ +const double x\d+ = [^;]*[-+*/]", text, re.MULTILINE)) for text in (short, long)]
    assert operations[1] - operations[0] <= 3
