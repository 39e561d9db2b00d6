"""Legs on two universal joints with parallel inner axes: what they hold is a length and two lines in one plane."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.parallel_mechanisms import snu

import symscrew
from symscrew.assembly import compiled_modes, modes_model, print_modes
from symscrew.assembly.all_modes import structure_of
from symscrew.assembly.dual_forms import crossing, distance
from symscrew.assembly.root_bounds import family_bound, own_bound
from symscrew.assembly.what_is_held import held_by


def _turn(axis: np.ndarray, angle: float) -> np.ndarray:
    x, y, z = axis
    hat = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * hat + (1 - np.cos(angle)) * hat @ hat


def _study(turn: np.ndarray, shift: np.ndarray) -> np.ndarray:
    """x + eps y, y = t x / 2, of a displacement; a turn by less than half a turn."""
    w = np.sqrt(1 + np.trace(turn)) / 2
    v = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / (4 * w)
    return np.array([w, *v, -shift @ v / 2, *((w * shift + np.cross(shift, v)) / 2)])


@pytest.mark.parametrize("seed", range(4))
def test_every_pose_that_a_leg_allows_fulfils_its_two_forms_and_no_other_pose_does(seed):
    random = np.random.default_rng(seed)
    outer, inner, other = np.linalg.qr(random.normal(size=(3, 3)))[0].T
    far = np.cross(inner, random.normal(size=3))
    far /= np.linalg.norm(far)  # the platform's axis, across the inner one
    a = random.normal(size=3)
    p = a + 0.9 * other + 0.4 * outer  # the leg, across the inner axis
    turns = [(_turn(axis, angle), at) for axis, at, angle in zip(
        (outer, inner, inner, far), (a, a, p, p), random.uniform(-0.7, 0.7, 4), strict=True)]  # fmt: skip
    turn, shift = np.eye(3), np.zeros(3)
    for more, at in turns:
        turn, shift = turn @ more, turn @ (at - more @ at) + shift
    g = _study(turn, shift)
    c = p @ p + a @ a - (p - a) @ (p - a)
    forms = [np.asarray(f, dtype=float) for f in (distance(p, a, c), crossing(far, p, outer, a))]
    assert max(abs(g @ f @ g) for f in forms) < 1e-14
    off = _study(turn @ _turn(inner, 0.3), shift)
    assert min(abs(off @ f @ off) for f in forms) > 1e-3


def test_a_3_upu_has_at_most_78_solutions():
    held = held_by(snu(), {"P0": "1/20", "P1": "-1/30", "P2": "1/70"}, {})
    structure = structure_of(held)
    assert [group.kind for group in structure.groups] == ["free"] and structure.crossings
    general, own = family_bound(structure), own_bound(held)
    assert (general.count, general.dimension, own.count, own.dimension) == (84, 0, 78, 0)


def three_ruu() -> symscrew.Mechanism:
    """Driven cranks about tangents, rods on universal joints whose axes on the platform lie along no tangent."""
    builder = symscrew.MechanismBuilder("three_ruu", platform="top").body("top")
    for k, (c, s) in enumerate((("1", "0"), ("-1/2", "sqrt(3)/2"), ("-1/2", "-sqrt(3)/2"))):

        def there(radial: str, tangential: str, up: str, c: str = c, s: str = s) -> list[str]:
            return [f"({radial})*({c})-({tangential})*({s})", f"({radial})*({s})+({tangential})*({c})", up]

        tangent, inner = there("0", "1", "0"), there("3/5", "0", "4/5")
        builder.body(f"crank{k}").body(f"rod{k}")
        for name, kind, ends, place, axes in (
            ("A", "R", ("base", f"crank{k}"), there("1", "0", "0"), [tangent]),
            ("B", "U", (f"crank{k}", f"rod{k}"), there("13/10", "0", "2/5"), [tangent, inner]),
            ("C", "U", (f"rod{k}", "top"), there("1/2", "0", "1"), [inner, there("-16/25", "3/5", "12/25")]),
        ):
            builder.joint(f"{name}{k}", kind, parent=ends[0], child=ends[1], point=place, axes=axes, driven=name == "A")
    return builder.build()


def test_a_3_ruu_is_of_the_same_structure_as_a_3_upu():
    held = held_by(three_ruu(), {"A0": "1/10", "A1": "-1/20", "A2": "1/30"}, {})
    assert structure_of(held).key == structure_of(held_by(snu(), {}, {})).key
    bound = own_bound(held)
    assert (bound.count, bound.dimension) == (84, 0)


def test_one_leg_on_universal_joints_keeps_its_angles():
    mechanism = symscrew.load_catalogue("three_ups_upu_s")  # one leg on universal joints: its angles stay unknowns
    assert not structure_of(held_by(mechanism, {}, {}).fewer()).crossings


def test_c_finds_sixteen_modes_of_the_3_upu_that_its_legs_hold(tmp_path: Path) -> None:
    """Each pose has the legs' lengths and each leg in one plane with its outer axes, which is all that a leg holds."""
    model = modes_model(snu())
    for file, text in print_modes(model).items():
        (tmp_path / file).write_text(text)
    compiled = compiled_modes(model, tmp_path, ["-O1"])
    legs = np.array([5 + 1 / 20, 5 - 1 / 30, 5 + 1 / 70])
    start = [reference for _, reference, _, _ in model.drives]
    lengths = np.array(start) + legs - 5
    status, modes = compiled.modes(lengths)
    assert status == 0 and len(modes) == 16  # as many as 395 solutions of Newton's method met
    places = []
    for mode in modes:
        assert mode.certified and mode.error < 1e-9
        turn, shift = np.array(mode.pose[:9]).reshape(3, 3).T, np.array(mode.pose[9:])
        for k, length in enumerate(legs):
            c, s = np.cos(2 * np.pi * k / 3), np.sin(2 * np.pi * k / 3)
            foot, tip, outer = np.array([5 * c, 5 * s, 0]), np.array([2 * c, 2 * s, 4]), np.array([c, s, 0])
            leg = turn @ tip + shift - foot
            assert abs(np.linalg.norm(leg) - length) < 1e-9
            assert abs(np.linalg.det([outer, leg, turn @ outer])) < 1e-8
        places.append(mode.pose[:])
    apart = [np.abs(np.subtract(a, b)).max() for k, a in enumerate(places) for b in places[:k]]
    assert min(apart) > 1e-3
    for mode in modes:
        assert compiled.led(mode, lengths + 1e-3) == 0 and compiled.led(mode, lengths) == 0
    assert max(np.abs(np.subtract(m.pose, p)).max() for m, p in zip(modes, places, strict=True)) < 1e-9
