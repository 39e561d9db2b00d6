"""All assembly modes as C, and the nearest one: against elimination, published postures and Python, and refused."""

from __future__ import annotations

import ctypes
import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from support.platforms import SHIFT, hexapod, planar_3rpr, published

import symscrew
from oracles.test_assembly_modes import by_elimination
from symscrew.assembly import CompiledModes, WaysToSolve, compiled_modes, modes_model, print_modes
from symscrew.display import Progress
from symscrew.runtime import compile_c
from symscrew.studies.accuracy.every_study import study_of
from symscrew.studies.accuracy.states import Subject

BASE = np.array([[0, 0], [2, 0], [1, 2]])
PLATFORM = np.array([[0, 0], [1, 0], [0.4, 0.8]])
OK, NOT_FINITE, INCOMPLETE, REFUSED, NOT_CERTIFIED = 0, 2, 100, 101, 102
STRICT = ("-pedantic", "-Wall", "-Wextra", "-Wdouble-promotion", "-Wconversion", "-Wshadow", "-Werror")
"""With which the planar platform's C compiles clean; gcc looks for what has no value where it optimises."""


def written(mechanism: symscrew.Mechanism, folder: Path, *flags: str) -> CompiledModes:
    model = modes_model(mechanism)
    for file, text in print_modes(model).items():
        (folder / file).write_text(text)
    return compiled_modes(model, folder, flags or ["-O0"])


@pytest.fixture(scope="module")
def planar(tmp_path_factory) -> CompiledModes:
    mechanism = planar_3rpr(BASE.tolist(), PLATFORM.tolist(), ("0.7", "0.2"))
    return written(mechanism, tmp_path_factory.mktemp("planar"), "-O1", *STRICT)


def angle(mode) -> float:
    return float(np.arctan2(mode.pose[1], mode.pose[0]))


def test_planar_platforms_have_the_modes_that_elimination_finds(planar):
    random = np.random.default_rng(5)
    counts = set()
    for legs in random.uniform(0.7, 2.0, (40, 3)):
        status, modes = planar.modes(legs)
        expected = by_elimination(BASE, PLATFORM, legs**2)
        found = np.sort([angle(m) for m in modes])
        assert found.shape == expected.shape and np.abs(found - expected).max(initial=0.0) < 1e-6
        assert status == OK and all(m.certified and m.error < 1e-9 for m in modes)
        counts.add(len(modes))
    assert len(counts) > 2


def closed(mode, legs: np.ndarray) -> float:
    """How far corners of the platform are from their legs' circles; the reference stands at (0.7, 0.2)."""
    turn = np.array(mode.pose[:9]).reshape(3, 3).T[:2, :2]
    at = (PLATFORM + np.array([0.7, 0.2])) @ turn.T + np.array(mode.pose[9:11])
    return float(np.abs(np.linalg.norm(at - BASE, axis=1) - legs).max())


def test_a_mode_is_led_without_jumps_and_refused_where_it_ends(planar):
    start = np.array([reference for _, reference, _, _ in planar.model.drives])
    _, modes = planar.modes(start)
    for mode in modes:
        before = angle(mode)
        for s in np.linspace(0, 1, 40)[1:]:  # there and back on a circle of drives
            legs = start + 0.02 * np.array([1 - np.cos(2 * np.pi * s), *[0.3 * np.sin(2 * np.pi * s)] * 2])
            assert planar.led(mode, legs) == OK and closed(mode, legs) < 1e-12
        assert abs(angle(mode) - before) < 1e-12
        place = list(mode.pose)
        short = start - [0.15, 0, 0]  # there the modes have met and are gone
        assert planar.led(mode, short) == REFUSED and list(mode.pose) == place
        assert not planar.modes(short)[1]


def test_steps_of_any_length_come_to_the_same_mode(planar):
    """Random motions in one call and in fifty: where both are accepted they agree, and long ones are accepted."""
    random, accepted = np.random.default_rng(1), 0
    start = np.array([reference for _, reference, _, _ in planar.model.drives])
    for _ in range(30):
        goal = start + random.normal(size=3) * 0.1
        _, modes = planar.modes(start)
        _, others = planar.modes(start)
        for one, many in zip(modes, others, strict=True):
            if planar.led(one, goal) != OK:
                continue
            ways = [planar.led(many, start + s * (goal - start)) for s in np.linspace(0, 1, 51)[1:]]
            assert set(ways) == {OK} and abs(angle(one) - angle(many)) < 1e-12
            accepted += 1
    assert accepted > 10


def test_two_modes_that_meet_have_no_certificate(planar):
    """Towards the lengths at which modes meet: statuses say so before boxes would be wrong."""
    start = np.array([reference for _, reference, _, _ in planar.model.drives])
    low, high = 0.0, 0.15
    for _ in range(60):
        middle = 0.5 * (low + high)
        count = len(by_elimination(BASE, PLATFORM, (start - [middle, 0, 0]) ** 2))
        low, high = (middle, high) if count else (low, middle)
    status, modes = planar.modes(start - [low, 0, 0])
    assert status == INCOMPLETE or len(modes) == 2
    for k in (1e-3, 1e-5, 1e-7):
        status, modes = planar.modes(start - [low - k, 0, 0])
        assert (status, len(modes)) == (OK, 2) or (status == INCOMPLETE and k < 1e-5)


def test_what_is_no_number_or_no_mode_is_refused(planar):
    start = [reference for _, reference, _, _ in planar.model.drives]
    assert planar.modes([np.nan, *start[1:]]) == (NOT_FINITE, [])
    mode = planar.modes(start)[1][0]
    assert planar.led(mode, [np.inf, *start[1:]]) == NOT_FINITE
    mode.certified = 0
    assert planar.led(mode, start) == NOT_CERTIFIED


def test_turns_whose_rounding_hides_the_angle_are_not_said_to_be_solved(tmp_path):
    compiled = written(symscrew.load_catalogue("five_bar"), tmp_path)
    for turns, status in ((10**3, OK), (10**8, INCOMPLETE), (10**300, INCOMPLETE)):
        assert compiled.modes([2 * np.pi * turns, -2 * np.pi * turns])[0] == status


@pytest.mark.slow
def test_all_forty_postures_of_dietmaier_in_c(tmp_path):
    given = published("dietmaier_1998_40_postures")
    compiled = written(hexapod(given["base_points"], given["platform_points"]), tmp_path)
    status, modes = compiled.modes([float(x) for x in given["leg_lengths"]])
    assert status == OK and len(modes) == 40
    shift, worst = np.array([float(c) for c in SHIFT]), 0.0
    for known in given["assembly_modes"]:
        w, *v = (float(c) for c in known["quaternion_wxyz"])
        cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
        turn = np.eye(3) + 2 * w * cross + 2 * cross @ cross
        at = np.array([float(c) for c in known["translation"]])
        worst = max(worst, min(
            np.abs(np.array(m.pose[:9]).reshape(3, 3).T - turn).max()
            + np.abs(np.array(m.pose[9:]) + turn @ shift - at).max() for m in modes
        ))  # fmt: skip
    # doubles: the worst conditioned modes lose four digits (published codes: 3e-4 to 4e-7); each says so in its error
    assert worst < 2e-11 and max(m.error for m in modes) < 1e-9


@pytest.mark.slow
def test_random_general_platforms_close_and_come_in_pairs(tmp_path):
    """A general platform on six legs: every mode closes by its points alone, and their number is even."""
    random = np.random.default_rng(11)
    base, platform = random.normal(size=(6, 3)).round(3), 0.6 * random.normal(size=(6, 3)).round(3)
    compiled = written(hexapod(base.tolist(), platform.tolist(), ("0.1", "0.2", "1.3")), tmp_path)
    shift, counts = np.array([0.1, 0.2, 1.3]), set()
    start = np.array([reference for _, reference, _, _ in compiled.model.drives])
    for k in range(8):
        legs = start + (0.2 * random.normal(size=6) if k else 0.0)
        status, modes = compiled.modes(legs)
        for mode in modes:
            turn = np.array(mode.pose[:9]).reshape(3, 3).T
            at = (platform + shift) @ turn.T + np.array(mode.pose[9:])
            assert np.abs(np.linalg.norm(at - base, axis=1) - legs).max() < 1e-12 * 10
        if status == OK:
            assert len(modes) % 2 == 0
            counts.add(len(modes))
        assert all(np.abs(np.array(a.pose) - np.array(b.pose)).max() > 1e-6 for a, b in pairwise(modes))
    assert len(counts) > 1


@pytest.mark.slow
@pytest.mark.parametrize("name", ["andrews"])
def test_check_compares_the_c_with_python(name, tmp_path, model_of):
    symscrew.generate(model_of(name), tmp_path, ["modes"])
    result = symscrew.check(tmp_path)
    assert result.ok and sum("certified in Python" in line for line in result.lines) == 2


@pytest.mark.slow
def test_level_modes_of_a_delta_are_those_of_three_spheres(tmp_path):
    compiled = written(symscrew.load_catalogue("delta"), tmp_path)
    for angles in ([0.0, 0.0, 0.0], [0.1, -0.2, 0.3]):
        status, modes = compiled.modes(angles)
        assert any(angles) or (status, len(modes)) == (OK, 16)  # others hold a turned platform
        level = [m for m in modes if abs(m.pose[0] + m.pose[4] + m.pose[8] - 3) < 1e-9]
        found = sorted((list(m.pose[9:]) for m in level), key=lambda t: t[2])
        assert np.allclose(found, spheres(angles), atol=1e-12)
        assert {compiled.led(m, np.array(angles) + 1e-3) for m in compiled.level(angles)[1]} == {OK}
    agree_with_spheres(compiled, 0.7)
    assert compiled.level([0.0, np.nan, 0.0]) == (NOT_FINITE, [])


def agree_with_spheres(compiled: CompiledModes, rods: float) -> set[int]:
    """How many level modes there are at random drives: each as near to its place as it says."""
    size, counts = float(compiled.model.held.network.length), set[int]()
    for angles in np.random.default_rng(3).uniform(-2, 2, (200, 3)):
        status, modes = compiled.level(angles)
        expected = spheres(angles, rods)
        assert status == OK and len(modes) == len(expected)
        for mode, place in zip(sorted(modes, key=lambda m: m.pose[11]), expected, strict=True):
            assert np.abs(np.array(mode.pose[9:]) - place).max() < mode.error * size + 1e-12 and mode.error < 1e-6
        counts.add(len(modes))
    return counts


@pytest.mark.slow
def test_level_modes_are_none_where_spheres_do_not_meet_and_not_certified_where_they_touch(tmp_path):
    """The same tables with shorter rods: a delta in whose reference they would not reach."""
    model, rods = modes_model(symscrew.load_catalogue("delta")), 0.44
    for file, text in print_modes(model).items():
        square = (rods / float(model.held.network.length)) ** 2
        (tmp_path / file).write_text(
            re.sub(r"(level_square\[3\] = ){.*?}", rf"\1{{{square}, {square}, {square}}}", text)
        )
    compile_c(tmp_path / "delta_modes.c", tmp_path / "delta.so", flags=("-ffp-contract=off", "-O0"), native=False)
    compiled = CompiledModes(ctypes.CDLL(str(tmp_path / "delta.so")), model)
    assert agree_with_spheres(compiled, rods) == {0, 2}
    low, high = 0.0, 1.0  # spheres touch between
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if spheres([middle, -middle, 0.0], rods) else (middle, high)
    for gap in (1e-3, 1e-7, 1e-11, 0.0):
        status, modes = compiled.level([high + gap, -high - gap, 0.0])
        assert (status, len(modes)) == (OK, 2) or (status == INCOMPLETE and not modes and gap < 1e-3)
        status, modes = compiled.level([low - gap, gap - low, 0.0])
        assert not modes and (status == OK or gap < 1e-3)


def spheres(angles, rods: float = 0.7) -> list[list[float]]:
    """Displacements of a platform 0.05 m wide on rods, from arms of 0.3 m at 0.2 m; arms horizontal: home."""
    turns = [0.0, 2 * np.pi / 3, 4 * np.pi / 3]
    ends = np.array([
        [*(np.array([np.cos(t), np.sin(t)]) * (0.15 + 0.3 * np.cos(a))), -0.3 * np.sin(a)]
        for t, a in zip(turns, angles, strict=True)
    ])  # fmt: skip
    rows, right = 2 * (ends[1:] - ends[0]), (ends[1:] ** 2).sum(axis=1) - (ends[0] ** 2).sum()
    along = np.cross(rows[0], rows[1])
    along /= np.linalg.norm(along)
    foot = np.linalg.lstsq(rows, right - rows @ ends[0], rcond=None)[0]
    left = rods**2 - foot @ foot
    home = np.array([0, 0, -np.sqrt(0.7**2 - 0.45**2)])
    signs = (1, -1) if left > 0 else ()
    return sorted(((ends[0] + foot + s * np.sqrt(left) * along - home).tolist() for s in signs), key=lambda t: t[2])


@pytest.mark.slow
def test_the_seed_in_c_keeps_its_modes_along_a_motion(tmp_path):
    compiled = written(symscrew.load_catalogue("three_ups_upu_s"), tmp_path)
    start = np.array([reference for _, reference, _, _ in compiled.model.drives])
    status, modes = compiled.modes(start)
    assert status == OK and any(np.abs(np.array(m.pose[:9]).reshape(3, 3) - np.eye(3)).max() < 1e-12 for m in modes)
    header = " ".join((tmp_path / "three_ups_upu_s_modes.h").read_text().split())
    taken = [d[0] for d in compiled.model.drives]
    told = header.partition("Not looked at: ")[2].partition(", which follow")[0].split(", ")
    assert len(taken) == len(told) == 2 and not set(taken) & set(told) and all(f"{name} [" in header for name in taken)
    _, there = compiled.modes(start + np.array([0.01, -0.01]))
    statuses = [compiled.led(mode, start + np.array([0.01, -0.01])) for mode in modes]
    assert set(statuses) == {OK, REFUSED} and len(there) == statuses.count(OK)  # two of four modes have met before
    for mode in (m for m, s in zip(modes, statuses, strict=True) if s == OK):  # a platform that turns about O
        assert np.abs(np.array(mode.pose[9:])).max() < 1e-12
        assert min(np.abs(np.array(mode.pose) - np.array(m.pose)).max() for m in there) < 1e-12


@pytest.fixture
def model_of():
    from support.model_states import model

    return lambda name: model(name).only(["assemble"])


@pytest.mark.parametrize(("name", "why"), [("ur5", "only of mechanisms with loops"), ("bennett", "no C of them")])
def test_mechanisms_without_such_c_are_refused_with_the_reason(name, why):
    with pytest.raises(symscrew.DescriptionError, match=why):
        modes_model(symscrew.load_catalogue(name))


def test_ways_to_solve_agree_and_say_how_many_they_find(tmp_path):
    """Newton's method finds some, paths all; certified zeros are those that C has."""
    ways = WaysToSolve(symscrew.load_catalogue("five_bar"))
    known = ways.by_paths_and_boxes()
    assert len(known) == 2 and len(ways.by_newton(1, 0)) <= 1
    few, many = ways.by_newton(3, 1), ways.by_newton(200, 1)
    assert len(few) <= len(many) == 2
    for zeros in (ways.by_paths(), many):
        assert ways.distance(zeros, known) < 1e-12 and ways.distance(known, zeros) < 1e-12
    assert ways.distance(known[:1], known[1:]) > 0.01 and ways.distance(known, known[:0]) == np.inf


@pytest.mark.slow
def test_the_study_of_modes_counts_what_each_way_finds():
    subject = Subject(symscrew.derive(symscrew.load_catalogue("four_bar")), None)
    found = study_of("modes", subject, None, full=False)(Progress(quiet=True), repeats=3, seconds=0.1)
    rows = {(way, setting): modes for way, setting, modes in found.tables["Modes found"][1]}
    assert rows["paths and certificates", "C"] == rows["paths and certificates", "integers"] == "2 of 2"
    assert max(point.error for point in found.points if point.error is not None) < 1e-11


def test_a_mechanism_without_loops_has_no_such_study():
    subject = Subject(symscrew.derive(symscrew.load_catalogue("ur5")).only(["forward_kinematics"]), None)
    with pytest.raises(symscrew.DescriptionError, match="no loops whose equations"):
        study_of("modes", subject, None, full=False)(Progress(quiet=True), repeats=3, seconds=0.1)
