"""Numerical decomposition against components that exact algebra proves, and against hand-typed polynomials."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from support.further_mechanisms import CASES, loop
from support.marks import slow
from support.parallel_mechanisms import snu
from support.reference_mechanisms import ENTRIES, build

from symscrew.cli.parser import main
from symscrew.description.mechanism import Mechanism
from symscrew.mobility.components import NumericalSpace, numerical_components, numerical_lines, witness_sets
from symscrew.mobility.components.certified_points import refined
from symscrew.mobility.components.deflation import deflated, made_regular
from symscrew.mobility.components.many_points import ManyPoints
from symscrew.mobility.components.moving_sections import Section, SquareSystem, complex_numbers, moved_points
from symscrew.mobility.components.plane_sections import places_modulo, sums_of
from symscrew.mobility.components.polynomials import Polynomial
from symscrew.mobility.components.witness_sets import bend, completed_sets, joined_sets
from symscrew.mobility.joint_network import network_of

FINE = 1e-40  # of 60 digits: incomplete sets have 1e-2


def mechanism(name: str) -> Mechanism:
    return snu() if name == "snu" else build(ENTRIES[name]) if name in ENTRIES else CASES[name].make()


def decomposed_of(made: Mechanism, seconds: float = 60.0) -> tuple[NumericalSpace, ...]:
    found = numerical_components(made, network_of(made), seconds)
    assert not isinstance(found, str), found
    return found


def decomposed(name: str, seconds: float = 60.0) -> NumericalSpace:
    (space,) = decomposed_of(mechanism(name), seconds)
    return space


@pytest.mark.parametrize(
    "name, sizes, through",
    [
        # proved by exact algebra: tests/tools/test_operation_modes.py has the same sizes, and the sources
        ("planar_4bar", [(1, 6)], 1),
        ("parallelogram-change_point", [(1, 2), (1, 4)], 2),  # singular there: points come to it
        ("bennett", [(1, 2)], 1),
        ("planar_5bar", [(2, 14)], 1),
        slow("kinematotropic_double_fold-transition", [(2, 4), (1, 4), (1, 4)], 2),
        slow("sarrus-flat_folded", [(2, 1), (1, 4), (1, 4)], 2),
        slow("3rps", [(3, 7), (3, 7)], 1),
        slow("double_hooke", [(1, 12)], 1),
        slow("double_watt_cusp", [(1, 52)], 1),  # the reference is the cusp
        slow("3-PRS", [(3, 8)], 1),
        slow("miura folded", [(2, 1), (2, 1), (1, 2), (1, 2), (1, 3), (1, 3), (1, 3), (1, 3), (1, 4)], 1),
        # not divided by exact algebra: four quadrics, of which the plane x = 0 is no pose, have 15 (as of the 3-UPU of
        # Seoul: Walter, Husty and Pfurner 2009)
        slow("3upu_tsai", [(3, 1), (3, 1), (3, 1), (3, 1), (3, 11)], 1),
        slow("schatz_turbula", [(1, 12)], 1),
        slow("planar_3rrr", [(3, 106)], 1),
    ],
)
def test_sizes_are_those_of_exact_algebra(name: str, sizes: list[tuple[int, int]], through: int) -> None:
    found = decomposed(name)
    parts = found.components
    assert [(p.dimension, p.degree) for p in parts] == sizes and found.closed and not found.reason
    assert sum(bool(p.through) for p in parts) == through and None not in [p.through for p in parts]
    assert all(p.certified == p.degree and p.fine and p.trace < FINE and p.residual < FINE for p in parts)
    assert all(p.loops and p.on for p in parts) and sum(p.on for p in parts) + found.unplaced == found.found


def of(*terms: dict[tuple[int, ...], int]) -> list[Polynomial]:
    return [Polynomial({key: Fraction(c) for key, c in each.items()}) for each in terms]


def test_what_is_of_several_components_stays_apart() -> None:
    """A conic and a cubic, one product of degree 5: seeds on both, and no loop leads from one to the other."""
    conic, cubic = of({(2, 0): 1, (0, 2): 2, (0, 0): -1}, {(3, 0): 1, (0, 2): -1, (1, 0): 1, (0, 0): 3})
    system = SquareSystem.of(ManyPoints.of([conic * cubic], np.ones(2)), 1, np.random.default_rng(1))
    random = np.random.default_rng(2)
    seeds = np.array([[1.0, 0.0], [0.0, np.sqrt(3)]])
    matrix = complex_numbers(random, 2, 1, 2)
    start = Section(matrix, np.einsum("pij,pj->pi", matrix, seeds))
    section = Section(complex_numbers(random, 1, 2), complex_numbers(random, 1))
    points, come = moved_points(system, seeds, (start, section), lambda: False)
    never = (lambda: False, lambda: False)
    sets = completed_sets(system, section, points, never, random=random)
    assert come.all() and [(len(s.points), s.closed, s.seeds) for s in sets] == [(2, True, (0,)), (3, True, (1,))]
    assert all(s.sure and s.trace < 1e-10 for s in sets)
    assert np.linalg.norm(np.einsum("ij,pj->pi", section.matrix, points) - section.right) < 1e-9
    for s in sets:  # the sum of some points alone is not linear
        assert s.beside is not None and bend(s.points[:-1], (s.beside[0][:-1], s.beside[1][:-1])) > 1e-4


def test_points_over_a_variable_are_joined_where_they_are_of_one_component() -> None:
    """Over x a conic and a cubic have two points each; the section stays one of x. A fifth is sought till time ends."""
    conic, cubic = of({(2, 0): 1, (0, 2): 2, (0, 0): -1}, {(3, 0): 1, (0, 2): -1, (1, 0): 1, (0, 0): 3})
    system = SquareSystem.of(ManyPoints.of([conic * cubic], np.ones(2)), 1, np.random.default_rng(1))
    random = np.random.default_rng(2)
    seeds = np.array([[0.5, np.sqrt(0.375)], [0.5, np.sqrt(3.625)]])
    section = Section(np.array([[1.0 + 0j, 0]]), np.full(1, 0.5 + 0j))
    other = section.another(random)
    assert other.matrix[0, 1] == 0 != other.matrix[0, 0] != 1 and other.right[0] not in (0, 0.5)
    assert not Section(section.matrix, 0 * section.right).another(random).right.any()  # of a ratio
    sets, quiet = joined_sets(system, section, seeds, 4, random=random, spent=lambda: False)
    assert [(len(z), seeds) for z, seeds in sets] == [(2, (0,)), (2, (1,))] and quiet == 8
    assert all(abs(z[:, 0] - 0.5).max() < 1e-9 for z, _ in sets)
    ends = iter([False] * 1000 + [True] * 1000)
    sets, quiet = joined_sets(system, section, seeds, 5, random=random, spent=lambda: next(ends))
    assert sum(len(z) for z, _ in sets) == 4


def test_who_is_slow_is_given_up_where_not_all_are_needed() -> None:
    """y^2 = x: nine points go round, one comes upon the branch point, in steps a thousandth as long."""
    system = SquareSystem.of(ManyPoints.of(of({(0, 2): 1, (1, 0): -1}), np.ones(2)), 1, np.random.default_rng(1))
    start = np.array([*[4.0 + 0.1 * k for k in range(9)], 1.0])
    end = np.array([*[5.0] * 9, -1 + 1e-3j])
    row = np.array([[[1.0, 0.0]]] * 10)
    ways = (Section(row, start[:, None].astype(complex)), Section(row, end[:, None]))
    points = np.stack([start, np.sqrt(start)], axis=1)
    for patient in (True, False):
        z, come = moved_points(system, points, ways, lambda: False, patient=patient)
        assert come.tolist() == [True] * 9 + [patient] and np.allclose(z[come, 1] ** 2, end[come])


def test_who_is_slow_is_waited_for_where_points_may_be_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    """A conic's second point, to which only slow paths lead: after two loops that bring nothing they are waited for.

    A general 7R had 95 of its 96 points after twenty loops else, as one is always among the slowest.
    """
    whole, waited = witness_sets.round_loop, list[bool]()

    def hurried(*args: Any, patient: bool = False, **options: Any) -> Any:
        waited.append(patient or options.get("sure", False))
        points, come = whole(*args, patient=patient, **options)
        return points, come & waited[-1]

    monkeypatch.setattr(witness_sets, "round_loop", hurried)
    (conic,) = of({(2, 0): 1, (0, 2): 2, (0, 0): -1})
    system = SquareSystem.of(ManyPoints.of([conic], np.ones(2)), 1, np.random.default_rng(1))
    random = np.random.default_rng(2)
    section = Section(np.array([[1.0 + 0j, 0.5]]), np.array([1.0 + 0j]))
    seed, never = np.array([[1.0 + 0j, 0.0]]), (lambda: False, lambda: False)
    (found,) = completed_sets(system, section, seed, never, random=random)
    assert waited[:3] == [False, False, True] and len(found.points) == 2 and found.closed


def test_places_are_primes_with_roots_of_the_fields_numbers() -> None:
    """sqrt(3) and sqrt(115), which a delta has; every prime has its own place."""
    found = places_modulo([(Fraction(-3), Fraction(0)), (Fraction(-115), Fraction(0))], 0, 3)
    assert len({p for p, _ in found}) == 3 and all(a * a % p == 3 and b * b % p == 115 for p, (a, b) in found)
    ((p, (half,)),) = places_modulo([(Fraction(-3, 4), Fraction(0))], 0, 1)
    assert 4 * half * half % p == 3
    assert places_modulo([], 0, 2) == [(30011, ()), (30013, ())]
    assert sums_of([1, 1, 38]) & sums_of([2, 4, 4, 30]) == {0, 2, 38, 40}


def test_a_ball_has_the_zero_and_a_double_zero_has_none() -> None:
    """sqrt(2) is within the ball about what doubles know of it; of (x - 1)^2 no zero is proved."""
    nothing = Section(np.zeros((0, 1), dtype=complex), np.zeros(0, dtype=complex))
    for terms, at, proved in (
        ({(2,): 1, (0,): -2}, 1.4142, True), ({(2,): 1, (1,): -2, (0,): 1}, 1.001, False),
    ):  # fmt: skip
        system = SquareSystem.of(ManyPoints.of(of(terms), np.ones(1)), 0, np.random.default_rng(1))
        found = refined(system, nothing, np.array([[at + 0j]]))
        assert np.isfinite(found.radii).all() == proved == bool(found.certified)
        if proved:
            root, radius = int(found.points[0][0, 0]), int(found.radii[0] * 2.0**240)  # integers over 2^240
            assert (root - radius) ** 2 < 2 << 480 < (root + radius) ** 2 and found.radii[0] < 1e-50


def test_the_same_zero_twice_is_certified_once_at_most() -> None:
    nothing = Section(np.zeros((0, 1), dtype=complex), np.zeros(0, dtype=complex))
    system = SquareSystem.of(ManyPoints.of(of({(2,): 1, (0,): -2}), np.ones(1)), 0, np.random.default_rng(1))
    assert refined(system, nothing, np.array([[1.4142 + 0j], [1.4143 + 0j]])).certified < 2
    assert refined(system, nothing, np.array([[1.4142 + 0j], [-1.4143 + 0j]])).certified == 2


def test_values_in_digits_and_doubles_are_of_the_same_polynomials() -> None:
    random = np.random.default_rng(3)
    given = of({(3, 1): 2, (0, 2): -5, (0, 0): 7}, {(1, 1): 1, (2, 0): 3})
    made = ManyPoints.of(given, np.array([2.0, 0.25]))
    z = complex_numbers(random, 4, 2)
    values, slopes = made.at(z)
    true = np.array([2 * (2 * z[:, 0]) ** 3 * (z[:, 1] / 4) - 5 * (z[:, 1] / 4) ** 2 + 7,
                     (2 * z[:, 0]) * (z[:, 1] / 4) + 3 * (2 * z[:, 0]) ** 2]).T  # fmt: skip
    ratio = values / true  # a power of two for each
    assert np.allclose(ratio, ratio[0]) and np.allclose(np.log2(ratio[0].real) % 1, 0)
    small = 1e-6
    for k in range(2):
        beside = z + small * np.eye(2)[k]
        assert np.allclose((made.at(beside)[0] - values) / small, slopes[:, :, k], atol=1e-4)
    to_integer = np.frompyfunc(lambda v: int(v * 2.0**60) << 180, 1, 1)
    real, _ = made.in_digits(to_integer(z.real), to_integer(z.imag))
    assert np.allclose([[float(v) / 2.0**240 for v in row] for row in real], values.T.real)
    assert (made.sizes_at(z)[0] >= np.abs(values)).all() and (made.sizes_at(z)[1] >= np.abs(slopes)).all()


def test_without_time_nothing_is_claimed() -> None:
    found = decomposed("planar_5bar", 0.0)
    assert not found.closed and "not all points were found within 0 s" in found.reason
    assert all(not p.certified and not p.loops for p in found.components)
    assert "not all points were found" in numerical_lines([found])[0]


@pytest.mark.parametrize("places, rank", [((0, 1, 3), 4), ((0, 1, 2, 4), 2)])
def test_singular_configurations_are_on_what_conditions_for_the_rank_leave(places: tuple[int, ...], rank: int) -> None:
    """Ball joints on one line, the longest bar as long as the others: they stay there, and the bars turn about it.

    So the body's poses are x2 = x3 = 0 = y of Study's parameters, a line on which derivatives have no full rank.
    """
    made = loop(*(("S", [x, 0, 0], None) for x in places))
    (found,) = decomposed_of(made)
    (part,) = found.components
    assert (part.dimension, part.degree, part.rank) == (1, 1, rank) and part.closed and part.certified == 1
    assert part.through and part.on == found.found > 20 and not found.unplaced and part.trace < FINE
    assert f"rank {rank} only" in numerical_lines([found])[1]


def test_a_condition_for_a_rank_is_met_where_it_is_lower_and_nowhere_else() -> None:
    """Two planes x^2 + y^2 = 0 through a real line: settled from near it, where the rank is 0; not where it is 1."""
    given = deflated(of({(2, 0, 0): 1, (0, 2, 0): 1}), 0, np.random.default_rng(1))
    made = ManyPoints.of(given, np.ones(3))
    z, settled = made_regular(made, np.array([[1e-6, 2e-6, 0.3]]), 1e-8)
    assert settled.all() and np.abs(z[0, :2]).max() < 1e-15 and z[0, 2] == pytest.approx(0.3)
    nowhere = deflated(of({(2, 0, 0): 1, (0, 2, 0): 1, (0, 0, 0): -1}), 0, np.random.default_rng(1))
    assert not made_regular(ManyPoints.of(nowhere, np.ones(3)), np.array([[1.0, 0.0, 0.3]]), 1e-8)[1].any()


@pytest.mark.slow
def test_in_words_and_json(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("symscrew.mobility.components.exact_parts.algebra_answer", lambda *_: None)
    assert main(["mobility", "five_bar", "--components", "--json"]) == 0
    values = json.loads(capsys.readouterr().out)["components"]
    assert not values["decided"] and [c["degree"] for c in values["numerical"][0]["components"]] == [14]
    assert values["numerical"][0]["judgement"] == "numerical"
    assert main(["mobility", "five_bar", "--components"]) == 0
    text = capsys.readouterr().out
    assert "numerical: 1 component" in text and "degree 14" in text and "certified (Krawczyk)" in text
