"""Thresholds of method B: ways of solving give the same wrenches, and what counts as unique is told on both sides."""

from __future__ import annotations

import numpy as np
import pytest

from symscrew import catalogue
from symscrew.description import MechanismBuilder
from symscrew.reference import BodyState, maximal_coordinates, newton_euler, newton_euler_method, numeric

Array = np.ndarray


def at_rest(name: str, states: int = 1) -> dict[str, BodyState]:
    mechanism = catalogue.load(name)
    rest = BodyState(np.broadcast_to(np.eye(3), (states, 3, 3)), *(np.zeros((states, n)) for n in (3, 6, 6)))
    return dict.fromkeys((body for body in mechanism.bodies if body != mechanism.ground), rest)


def test_both_ways_of_solving_give_the_same_wrenches(monkeypatch: pytest.MonkeyPatch) -> None:
    """An open chain, whose columns are independent: by a triangular factor, or by singular values."""
    ways = []
    for condition in (newton_euler_method.CONDITION, 1e-9):
        monkeypatch.setattr(newton_euler_method, "CONDITION", condition)
        ways.append(newton_euler(catalogue.load("ur5"), at_rest("ur5")))
    assert np.abs(ways[0].drives).max() > 1.0
    assert np.abs(ways[0].drives - ways[1].drives).max() < 1e-9
    for joint, wrench in ways[0].reactions.items():
        assert np.abs(wrench - ways[1].reactions[joint]).max() < 1e-9


def test_redundant_constraints_are_told_by_singular_values(monkeypatch: pytest.MonkeyPatch) -> None:
    """A planar linkage in space has three; where rounding counts as a singular value, it seems to have fewer."""
    assert newton_euler(catalogue.load("four_bar"), at_rest("four_bar")).reaction_redundancy.tolist() == [3]
    monkeypatch.setattr(newton_euler_method, "RANK", 1e-30)
    assert newton_euler(catalogue.load("four_bar"), at_rest("four_bar")).reaction_redundancy[0] < 3


@pytest.mark.parametrize("load, unique", [(1e-7, False), (10.0, True)])
def test_internal_loads_make_reactions_ambiguous(monkeypatch: pytest.MonkeyPatch, load: float, unique: bool) -> None:
    monkeypatch.setattr(newton_euler_method, "INTERNAL_LOAD", load)
    found = newton_euler(catalogue.load("four_bar"), at_rest("four_bar"))
    assert all(component.all() for component in found.unique.values()) == unique


@pytest.mark.parametrize("chunk", [1, 3, 128])
def test_many_states_are_solved_in_chunks(monkeypatch: pytest.MonkeyPatch, chunk: int) -> None:
    alone = newton_euler(catalogue.load("four_bar"), at_rest("four_bar"))
    monkeypatch.setattr(newton_euler_method, "CHUNK", chunk)
    found = newton_euler(catalogue.load("four_bar"), at_rest("four_bar", 7))
    assert found.drives.shape == (7, alone.drives.shape[-1])
    assert np.abs(found.drives - alone.drives).max() < 1e-12


@pytest.mark.parametrize("parallel, carriers", [(1e-12, [0, 1]), (2.0, [0, 0])])
def test_an_axis_is_carried_by_what_turns_it(
    monkeypatch: pytest.MonkeyPatch, parallel: float, carriers: list[int]
) -> None:
    """The second axis of a universal joint is turned by the first, unless they count as parallel."""
    builder = MechanismBuilder("hook", platform="rod").body("rod")
    builder.joint("U", "U", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 0, 1], [1, 0, 0]])
    monkeypatch.setattr(maximal_coordinates, "PARALLEL", parallel)
    assert numeric(builder.build()).carriers.tolist() == carriers


def test_short_representations() -> None:
    found = newton_euler(catalogue.load("four_bar"), at_rest("four_bar"))
    numbers = numeric(catalogue.load("four_bar"))
    assert repr(found).startswith("<NewtonEulerSolution: 1 states, 1 drives, 4 joints, residual at most ")
    assert repr(numbers) == "<NumericMechanism four_bar: 4 bodies, 4 joints, 4 freedoms>"
    assert repr(at_rest("four_bar", 5)["crank"]) == "<BodyState: 5 states>"
