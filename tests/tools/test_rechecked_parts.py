"""Branches by exact algebra that a proof file carries: checked alone, without the program that found them."""

from __future__ import annotations

import copy
import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest
from support.further_mechanisms import CASES
from support.reference_mechanisms import ENTRIES, build

from symscrew.description.mechanism import Mechanism
from symscrew.mobility import Mobility, analyse_mobility, with_rechecked_parts, write_proof
from symscrew.mobility.components import ALGEBRA_PROGRAM
from symscrew.mobility.proofs import parts_proof as proofs_of_parts
from symscrew.mobility.proofs import proof_checker
from symscrew.mobility.proofs.parts_proof import parts_proof
from symscrew.mobility.proofs.proof_checker import Block, RefusedError, at_least

pytestmark = pytest.mark.skipif(shutil.which(ALGEBRA_PROGRAM) is None, reason="Singular is not installed (singular-ui)")


def mechanism(name: str) -> Mechanism:
    return build(ENTRIES[name]) if name in ENTRIES else CASES[name].make()


@cache
def sampled(name: str) -> Mobility:
    return analyse_mobility(mechanism(name))


@pytest.mark.parametrize(
    "name, branches, rows",
    [
        ("sarrus-stretched", (1,), 2),  # both knees go out to one side, or to two
        ("sarrus-flat_folded", (1, 2), 2),  # with the plate on the base both knees turn about its hinges
    ],
)
def test_what_was_sampled_is_proved_and_rechecked_by_python_alone(
    name: str, branches: tuple[int, ...], rows: int, tmp_path: Path
) -> None:
    before, found = sampled(name), with_rechecked_parts(sampled(name))
    assert not before.finite.proved and found.finite.proved and found.finite.branches == branches
    assert found.branches is not None and found.branches.complete and len(found.branches.rows) == rows
    verdict = write_proof(found, tmp_path / "proof.json")
    assert verdict.holds and f"branches {json.dumps(list(branches))}" in verdict.proved and not verdict.not_proved
    checker = shutil.copy(proof_checker.__file__, tmp_path / "checker.py")
    done = subprocess.run([sys.executable, "-I", checker, tmp_path / "proof.json"], capture_output=True, text=True)
    assert done.returncode == 0 and f"proved: finite mobility {max(branches)}" in done.stdout


@cache
def change_point() -> tuple[Block, dict[str, Any]]:
    """The two branches of a parallelogram at its change point: translation in a circle, and the crossed one."""
    numbers, evidence = analyse_mobility(mechanism("parallelogram-change_point")).evidence
    block = Block(numbers.read, ("block", "0"), evidence["blocks"][0])
    proof = parts_proof(numbers, block)
    assert proof is not None
    return block, proof


def taken(proof: dict[str, Any]) -> tuple[int, int, list[int] | None, bool]:
    block = change_point()[0]
    return Block(block.mechanism, ("block", "0"), {**block.entry, "proof": proof}).dimensions


def test_two_curves_meet(monkeypatch: pytest.MonkeyPatch) -> None:
    """By minimal primes, or where these are not found by factors of a Groebner basis."""
    assert taken(change_point()[1]) == (1, 1, [1], False)
    whole, given = proofs_of_parts.algebra_answer, list[str]()

    def without_primes(script: str, seconds: float) -> tuple[str, bool] | None:
        given.append(script)
        return ("", False) if "minAssGTZ" in script else whole(script, seconds)

    monkeypatch.setattr(proofs_of_parts, "algebra_answer", without_primes)
    block = change_point()[0]
    numbers = analyse_mobility(mechanism("parallelogram-change_point")).evidence[0]
    proof = parts_proof(numbers, block)
    assert proof is not None and len(given) == 2 and taken(proof) == (1, 1, [1], False)


def _without_a_part(proof: dict[str, Any]) -> None:
    del proof["parts"][1]
    proof["products"] = proof["products"][: len(proof["parts"][0]["equations"])]


def _twice(proof: dict[str, Any]) -> None:
    proof["parts"].append(proof["parts"][0])
    proof["products"] *= len(proof["parts"][0]["equations"])
    minors = (
        proof["parts"][0]["minor"],
        proof["apart"][1]["minor"],
        proof["parts"][0]["minor"],
        proof["apart"][0]["minor"],
    )
    pairs = ([0, 2], [1, 2], [2, 0], [2, 1])
    proof["apart"] += [{"parts": pair, "minor": minor} for pair, minor in zip(pairs, minors, strict=True)]


def _wider(proof: dict[str, Any]) -> None:
    """Without one of its equations the part would be a surface."""
    numbers = change_point()[0].numbers

    def slope(equation: Any, column: int) -> Any:
        key = tuple(int(k == column) for k in range(4))
        return proof_checker.polynomial(numbers, equation, 4).get(key, numbers.zero)

    part, count = proof["parts"][0], len(proof["parts"][1]["equations"])
    del part["equations"][0]
    for columns in combinations(range(4), len(part["equations"])):
        part["minor"] = {"rows": list(range(len(columns))), "columns": list(columns)}
        with suppress(RefusedError):
            at_least(numbers, [[slope(e, k) for k in range(4)] for e in part["equations"]], part["minor"])
            break
    for shown in part["closure"]:
        del shown["factors"][0]
    proof["products"] = proof["products"][count:]


def _elsewhere(proof: dict[str, Any]) -> None:
    proof["parts"][0]["equations"][0].append(["1", 0, 0, 0, 0])


def _dead_unit(proof: dict[str, Any]) -> None:
    """Zero times anything is a combination."""
    for shown in proof["products"]:
        shown.update(unit=[], factors=[[] for _ in shown["factors"]])


def _zero_power(proof: dict[str, Any]) -> None:
    proof["products"][0]["power"] = 0


def _other_factor(proof: dict[str, Any]) -> None:
    shown = next(s for s in proof["products"] if any(s["factors"]))
    factor = next(f for f in shown["factors"] if f)
    factor[0][0] = "17/19"


def _nothing_apart(proof: dict[str, Any]) -> None:
    proof["apart"].pop()


def _fewer_products(proof: dict[str, Any]) -> None:
    proof["products"].pop()


@pytest.mark.parametrize(
    "change, why",
    [
        (_without_a_part, "combination"), (_twice, "within another"), (_wider, "combination"),
        (_elsewhere, "does not hold the configuration"), (_dead_unit, "unit"), (_zero_power, "power"),
        (_other_factor, "combination"), (_fewer_products, ""), (_nothing_apart, "within another"),
    ],
)  # fmt: skip
def test_evidence_that_is_changed_is_refused(change: Callable[[dict[str, Any]], None], why: str) -> None:
    proof = copy.deepcopy(change_point()[1])
    change(proof)
    with pytest.raises((RefusedError, ValueError), match=why):
        taken(proof)


def test_a_node_of_one_curve_is_no_smooth_part() -> None:
    """A flat vertex of four folds: its two branches are of one component, which is singular there."""
    found = sampled("origami degree 4")
    assert with_rechecked_parts(found).finite == found.finite
