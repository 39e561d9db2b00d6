"""Bounds on solutions by residues: numbers of a mechanism modulo a prime, exactly."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import sympy

import symscrew
from symscrew import load_catalogue
from symscrew.assembly import root_bounds
from symscrew.assembly.all_modes import structure_of
from symscrew.assembly.families import COMPLEX
from symscrew.assembly.residues import LARGEST_PRIME, Residue, residues_of
from symscrew.assembly.root_bounds import exact_bound, own_bound
from symscrew.assembly.slot_numbers import Displacements
from symscrew.assembly.what_is_held import held_by
from symscrew.description import parse_description
from symscrew.mobility import NotDecidableError


def flat(slots: list) -> list:
    return [c for s in slots for c in (s if isinstance(s, list | tuple | np.ndarray) else [s])]


LARGE = pytest.param("stewart_6ups", 28, marks=pytest.mark.slow)


@pytest.mark.parametrize(
    ("name", "count"), [("planar_3rrr", 2), ("three_ups_upu_s", 8), ("delta", 28), LARGE, ("four_bar", 2)]
)
def test_references_of_the_catalogue_have_bounds_of_their_own(name, count):
    held = held_by(load_catalogue(name), {}, {})
    structure = structure_of(held)
    if structure.equations > structure.unknowns:
        held = held.fewer()
    found = own_bound(held)
    assert not isinstance(found, str) and (found.count, found.dimension) == (count, 0)


DRIVEN = [
    ("delta", {"arm1_R": "0.1", "arm2_R": "-0.35", "arm3_R": "10deg"}),
    ("stewart_6ups", {"leg1_P": "1.25", "leg4_P": "13/10"}),
    ("planar_3rrr", {"limb1_R1": "pi/5", "limb2_R1": "0.2 + pi/5"}),
]


@pytest.mark.parametrize(("name", "drives"), DRIVEN)
def test_numbers_modulo_a_prime_are_those_of_the_mechanism(name, drives, monkeypatch):
    held = held_by(load_catalogue(name), drives, {})
    kept = []
    monkeypatch.setattr(Residue, "__init__", recording(Residue.__init__, kept))
    structure, residues, _ = residues_of(held)
    own = structure_of(held)
    assert structure.key == own.key
    numbers = flat(Displacements(own, COMPLEX, held.values).slots())
    values = {r.rest: float(r.value) for r in kept}
    lengths = {"point", "distance", "number"}
    expected = [complex(c).real for c, s in zip(numbers, spread(own), strict=True) if s in lengths]
    got = [values[r] for r, s in zip(flat(residues), spread(own), strict=True) if s in lengths]
    assert np.allclose(got, expected, atol=1e-12)


def spread(structure) -> list[str]:
    return [s.kind for s in structure.slots for _ in range(3 if s.kind in ("point", "axis") else 1)]


def recording(made, kept):
    def wrapped(self, *arguments):
        made(self, *arguments)
        kept.append(self)

    return wrapped


@pytest.mark.parametrize("drives", [{}, DRIVEN[0][1]])
def test_rods_keep_their_lengths_modulo_the_prime(drives):
    """c = |p|^2 + |a|^2 - L^2 where arms are turned by held angles: all rods are 0.7 m long."""
    held = held_by(load_catalogue("delta"), drives, {})
    structure, slots, prime = residues_of(held)
    square = (Fraction(7, 10) / Fraction(float(held.network.length))) ** 2
    for k, slot in enumerate(structure.slots):
        if slot.kind == "distance":
            p, a = slot.of
            found = sum(c * c for c in slots[p]) + sum(c * c for c in slots[a]) - slots[k]
            assert (found * square.denominator - square.numerator) % prime == 0


def test_an_angle_in_parts_of_a_turn_and_in_radians_is_added_up():
    mechanism = load_catalogue("planar_3rrr")
    counts = {}
    for text in ("10deg", "pi/18", "0.2", "pi/18 + 0.2"):
        drives = dict.fromkeys(("limb1_R1", "limb2_R1", "limb3_R1"), text)
        bound = own_bound(held_by(mechanism, drives, {}))
        if isinstance(bound, str):
            pytest.skip(bound)
        counts[text] = bound.count
    assert set(counts.values()) == {2}  # a third of a turn takes the mechanism to itself: four solutions stay far away


WEDGE = f"""
[mechanism]
name = "wedge"
platform = "rod"
[parameters]
p = {{ value = {LARGEST_PRIME} }}
[bodies]
block = {{ mass = 1, com = [0, 0, 0] }}
rod = {{ mass = 1, com = [0, 0, 0] }}
slider = {{ mass = 1, com = [0, 0, 0] }}
[joints]
rail = {{ type = "P", parent = "base", child = "block", point = [0, 0, 0], axes = [[1, 0, 0]], driven = true }}
wall = {{ type = "P", parent = "block", child = "rod", point = [0, 0, 0], axes = [[0, 1, 0]] }}
hinge = {{ type = "R", parent = "slider", child = "rod", point = [0, 0, 0], axes = [[0, 0, 1]] }}
[joints.slope]
type = "P"
parent = "base"
child = "slider"
point = [0, 0, 0]
axes = [["2*p/(1 + p^2)", "(1 - p^2)/(1 + p^2)", 0]]
"""


def test_a_solution_that_is_infinite_modulo_a_prime_is_counted():
    """Modulo the prime the slope is parallel to the wall: no solution is left; the mechanism has one, a metre down."""
    bound = own_bound(held_by(parse_description(WEDGE), {"rail": "1/1000000000"}, {}))
    if isinstance(bound, str):
        pytest.skip(bound)
    exact = exact_bound(held_by(parse_description(WEDGE), {"rail": "1/1000000000"}, {}))
    assert (bound.count, bound.dimension) == (1, 0) == (exact.count, exact.dimension)
    found = symscrew.assembly_modes(parse_description(WEDGE), {"rail": "1/1000000000"})
    assert (found.complete, len(found.modes)) == ("tracked", 0)  # its path comes too near infinity to be told from it


@pytest.mark.parametrize(("name", "drives", "count"), [
    ("four_bar", {"A": "0.2"}, 2), ("planar_3rrr", {"limb1_R1": "0.1"}, 6),
    ("planar_3rrr", {"limb1_R1": "pi/5"}, 6),
])  # fmt: skip
def test_exact_numbers_count_what_residues_do(name, drives, count):
    """Angles that are fractions [rad] in the tangent of half their common part, parts of a turn in their field."""
    held = held_by(load_catalogue(name), drives, {})
    exact, bound = exact_bound(held, 20.0), own_bound(held)
    if isinstance(bound, str):
        pytest.skip(bound)
    assert (exact.count, exact.dimension) == (count, 0) == (bound.count, bound.dimension)


def test_a_basis_that_does_not_end_is_not_tried_again_for_as_long(monkeypatch, tmp_path):
    monkeypatch.setenv("SYMSCREW_CACHE", str(tmp_path))
    tried = []

    def without_end(script, seconds):
        tried.append(seconds)
        return "", False

    monkeypatch.setattr(root_bounds, "algebra_answer", without_end)
    held = held_by(load_catalogue("five_bar"), {"base_left": "0.1", "base_right": "0.3"}, {})
    told = [exact_bound(held, seconds) for seconds in (2.0, 2.0, 1.0, 3.0)]
    assert tried == [2.0, 3.0] and "within 2 s" in told[2] and "within 3 s" in told[3]


def test_angles_far_from_one_another_are_not_tried_exactly():
    held = held_by(load_catalogue("planar_3rrr"), {"limb1_R1": "0.2", "limb2_R1": "-0.31"}, {})
    assert "31 times their common part, 8 at most" in str(exact_bound(held))


def test_numbers_that_are_in_no_field_say_so():
    held = held_by(load_catalogue("four_bar"), {"A": "0.1"}, {})
    object.__setattr__(held, "given", {next(iter(held.given)): sympy.sqrt(2)})
    with pytest.raises(NotDecidableError, match=r"cos\(sqrt\(2\)\) is transcendental"):
        residues_of(held)
    assert "no field" in str(own_bound(held))
