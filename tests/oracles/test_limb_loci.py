"""Constraints and loci of displaced limbs: in the form they are written by hand, and true where they say they hold.

Screws by exponentials of what is typed here; where an expression is zero, singular values say whether it is so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import sympy
from scipy.linalg import expm
from scipy.optimize import brentq
from support.marks import slow

from symscrew.description import Mechanism, MechanismBuilder, load_description, write_template
from symscrew.mobility.symbols import Locus, actuation_loci, conditions, symbolic_mobility
from symscrew.mobility.symbols.limb_poses import LimbPose, limb_pose

AXES = {"x": (1, 0, 0), "t": (0, 1, 0), "z": (0, 0, 1), "l": (-3 / 5, 0, 4 / 5)}
TYPED = {"x": [1, 0, 0], "t": [0, 1, 0], "z": [0, 0, 1], "l": ["-3/5", 0, "4/5"]}
LIMBS = {  # letters, places (x, z) of the joints, their axes
    "sliding rod": ("PRS", [(1, 0), (1, 0.25), (0.5, 1)], ["x", "t", ""]),
    "upright slide": ("PRS", [(1, 0), (1, 0.25), (0.5, 1)], ["z", "t", ""]),
    "two cranks": ("RRS", [(1, 0), (1.25, 0.5), (0.5, 1)], ["t", "t", ""]),
    "swivelling crank": ("RRS", [(1, 0), (1.25, 0.5), (0.5, 1)], ["z", "t", ""]),
    "telescope": ("RPS", [(1, 0), (0.25, 1), (0.25, 1)], ["t", "l", ""]),
    "two universal joints": ("PUU", [(1, 0), (1, 0.25), (0.5, 1)], ["z", "tx", "xt"]),
    "sleeve": ("CRU", [(1, 0), (1, 0.25), (0.5, 1)], ["x", "t", "tx"]),
    "crank": ("RUU", [(1, 0), (1.25, 0.5), (0.5, 1)], ["t", "tx", "xt"]),
    "plane": ("RRR", [(1, 0), (1.25, 0.5), (0.5, 1)], ["t", "t", "t"]),
    "two crosses about one point": ("RUU", [(1, 0), (0.5, 1), (0.5, 1)], ["t", "tl", "zx"]),
    "telescope on crosses": ("UPU", [(1, 0), (0.25, 1), (0.25, 1)], ["xt", "l", "tx"]),
}


def mechanism(kind: str, turned: bool) -> Mechanism:
    """A platform on one limb, `turned` by 120 degrees about z."""
    letters, places, axes = LIMBS[kind]
    c, s = ("-1/2", "sqrt(3)/2") if turned else ("1", "0")

    def about_z(x: object, y: object, z: object) -> list[object]:
        return [f"({x})*({c}) - ({y})*({s})", f"({x})*({s}) + ({y})*({c})", z]

    builder = MechanismBuilder("one_limb", platform="top")
    bodies = ["base", *(f"link{k}" for k in range(1, len(letters))), "top"]
    for body in bodies[1:]:
        builder.body(body)
    for k, (letter, (x, z)) in enumerate(zip(letters, places, strict=True)):
        point = about_z(str(sympy.Rational(x)), 0, str(sympy.Rational(z)))
        given = [about_z(*TYPED[a]) for a in axes[k]] or None
        builder.joint(f"j{k}", letter, parent=bodies[k], child=bodies[k + 1], point=point, axes=given)
    return builder.limb("limb", joints=[f"j{k}" for k in range(len(letters))]).build()


def screws(kind: str, angle: float) -> list[tuple[np.ndarray, bool]]:
    """(twist (omega ; v), whether it slides) of every freedom in the reference configuration."""
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    found = []
    for letter, (x, z), names in zip(*LIMBS[kind], strict=True):
        place = turn @ [x, 0, z]
        axes = [turn @ AXES[a] for a in names] or list(np.eye(3))
        for axis in axes:
            slide = np.concatenate([np.zeros(3), axis])
            rotation = np.concatenate([axis, np.cross(place, axis)])
            found += {"P": [(slide, True)], "C": [(slide, True), (rotation, False)]}.get(letter, [(rotation, False)])
    return found


def displaced(given: list[tuple[np.ndarray, bool]], amounts: np.ndarray) -> np.ndarray:
    """The screws (6, n) where the freedoms after the first are displaced."""
    total, result = np.eye(6), []
    for k, (screw, _) in enumerate(given):
        result.append(total @ screw)
        if 1 <= k <= len(amounts):
            omega, v = (np.cross(np.eye(3), part) for part in (screw[:3], screw[3:]))
            total = total @ expm(amounts[k - 1] * np.block([[omega, np.zeros((3, 3))], [v, omega]]))
    return np.array(result).T


def rank(matrix: np.ndarray) -> int:
    return int((np.linalg.svd(matrix, compute_uv=False) > 1e-7).sum()) if matrix.size else 0


def reciprocal(matrix: np.ndarray) -> np.ndarray:
    """Wrenches (f ; m) (6, k) reciprocal to twists (6, n)."""
    _, sizes, rows = np.linalg.svd(np.vstack([matrix[3:], matrix[:3]]).T)
    return np.asarray(rows[int((sizes > 1e-7).sum()) :].T)


def zeros(expression: sympy.Expr, symbols: tuple[sympy.Symbol, ...], seed: int) -> Iterator[np.ndarray]:
    """Displacements at which it is zero, along each of its symbols, the others at random."""
    random = np.random.default_rng(seed)
    for k in (k for k, s in enumerate(symbols) if expression.has(s)):
        at = random.uniform(-0.6, 0.6, len(symbols))
        value = sympy.lambdify(symbols, expression)

        def along(x: float, value: Callable[..., float] = value, at: np.ndarray = at, k: int = k) -> float:
            return float(value(*np.where(np.arange(len(at)) == k, x, at)))

        grid = np.linspace(-3, 3, 61)
        for low, high in pairwise(grid):
            if along(low) * along(high) < 0:
                yield np.where(np.arange(len(at)) == k, brentq(along, low, high, xtol=1e-14), at)


@pytest.mark.parametrize(
    ("kind", "turned"), [(kind, k % 8 == 4) if k % 4 == 0 else slow(kind, k % 2 == 1) for k, kind in enumerate(LIMBS)]
)
def test_what_is_said_of_displaced_limbs_is_so(kind: str, turned: bool) -> None:
    pose = limb_pose(mechanism(kind, turned), "limb")
    assert isinstance(pose, LimbPose)
    given = screws(kind, 2 * np.pi / 3 if turned else 0.0)
    wrenches = sympy.lambdify(pose.displacements, sympy.Matrix(pose.constraints))
    for seed in range(4):
        at = np.random.default_rng(seed).uniform(-1, 1, len(pose.displacements))
        basis = reciprocal(displaced(given, at))
        found = np.array(wrenches(*at), dtype=float).T
        assert rank(found) == basis.shape[1] and np.abs(found - basis @ (basis.T @ found)).max() < 1e-12
    seen = 0
    for locus in conditions(pose.loci):
        for at in zeros(locus.expression, pose.displacements, 7):
            twists = displaced(given, at)
            basis = reciprocal(twists)
            lost = {"limb": twists, "couple": basis[:3], "through O": basis[3:]}[locus.kind]
            assert rank(lost) < lost.shape[1], (locus.meaning, locus.expression)
            if len(pose.constraints) == 1:  # it is a wrench there too: nothing that could be divided by is left in it
                assert np.abs(np.array(wrenches(*at), dtype=float)).max() > 1e-3
            seen += 1
    assert seen >= (0 if kind in ("upright slide", "telescope", "two crosses about one point") else 1)


@pytest.mark.parametrize("kind", ["two crosses about one point", slow("telescope on crosses")])
def test_where_several_conditions_hold_at_once_a_place_is_found(kind: str) -> None:
    """No common factor tells these: crosses folded into one another, and at the ends of a rod turned alike."""
    pose = limb_pose(mechanism(kind, turned=False), "limb")
    assert isinstance(pose, LimbPose) and pose.further
    at = np.array([pose.further[s] for s in pose.displacements])
    given = screws(kind, 0.0)
    usual = max(rank(displaced(given, np.random.default_rng(k).uniform(-1, 1, len(at)))) for k in range(3))
    assert rank(displaced(given, at)) < usual
    limb_loci = [locus.expression for locus in pose.loci if locus.kind == "limb"]
    assert all(abs(x.xreplace(dict(pose.further))) > 1e-3 for x in limb_loci)  # beside those


def test_a_rod_of_a_length_that_is_a_parameter_is_looked_at_with_its_value() -> None:
    """Where its crosses fold, beside the length zero, which is a condition in the parameter."""
    builder = MechanismBuilder("rod", platform="top").parameter("L", "1/2", unit="m")
    for body in ("low", "high", "top"):
        builder.body(body)
    builder.joint("A", "U", parent="base", child="low", point=[0, 0, 0], axes=[TYPED["x"], TYPED["t"]])
    builder.joint("B", "P", parent="low", child="high", point=[0, 0, 0], axes=[TYPED["z"]])
    builder.joint("C", "U", parent="high", child="top", point=[0, 0, "L"], axes=[TYPED["t"], TYPED["x"]])
    made = builder.limb("limb", joints=["A", "B", "C"]).build()
    pose = limb_pose(made, "limb")
    assert isinstance(pose, LimbPose)
    (length,) = [locus.expression for locus in pose.loci if locus.kind == "limb"]
    assert {str(s) for s in length.free_symbols} == {"L", "d_3"}
    at = dict(pose.further)
    assert abs(at[sympy.Symbol("d_3", real=True)] + 0.5) > 1e-3
    angles = [at[s] for s in pose.displacements if str(s).startswith("theta")]
    assert all(abs(abs(x) - np.pi / 2) < 1e-6 for x in angles)  # first and last axis along the rod


def test_where_one_condition_tells_all_nothing_is_looked_for() -> None:
    pose = limb_pose(mechanism("plane", turned=False), "limb")
    assert isinstance(pose, LimbPose) and len(pose.loci) == 1 and not pose.further and not pose.not_tried


def test_a_sliding_rod_bears_a_force_through_its_ball_along_the_hinge() -> None:
    """(0, 1, 0; -z, 0, x) with the place of the ball at any angle of the rod, and no such rod where it lies flat."""
    pose = limb_pose(mechanism("sliding rod", turned=False), "limb")
    assert isinstance(pose, LimbPose)
    (angle,) = pose.displacements
    c, s = sympy.cos(angle), sympy.sin(angle)
    x, z = 1 - c / 2 + 3 * s / 4, sympy.Rational(1, 4) + 3 * c / 4 + s / 2
    (wrench,) = pose.constraints
    by_hand = (0, 1, 0, -z, 0, x)
    assert wrench[1].is_number
    assert [sympy.expand(a / wrench[1] - b) for a, b in zip(wrench, by_hand, strict=True)] == [0] * 6


# -- loci in the parameters of whole mechanisms -----------------------------------------------------------


def numeric_screws(mechanism: Mechanism, values: dict[sympy.Symbol, float]) -> dict[str, np.ndarray]:
    """Joint -> twists (n, 6) of its freedoms at values of the parameters, from the description's points and axes."""
    found = {}
    for name, joint in mechanism.joints.items():
        point = np.array([float(c.xreplace(values)) for c in joint.point])
        axes = [np.array([float(c.xreplace(values)) for c in axis]) for axis in joint.axes] or list(np.eye(3))
        rows = []
        for axis in axes:
            slide, turn = np.r_[0, 0, 0, axis], np.r_[axis, np.cross(point, axis)]
            rows += {"P": [slide], "C": [slide, turn]}.get(joint.type, [turn])
        found[name] = np.array(rows)
    return found


def lost(mechanism: Mechanism, locus: Locus, screws: dict[str, np.ndarray]) -> int:
    """A number that grows where what the locus says is so."""
    chains = {n: np.concatenate([screws[j] for j in limb.joints]) for n, limb in mechanism.limbs.items()}
    if locus.kind in ("limb", "couple", "through O"):
        part = {"limb": slice(0, 6), "couple": slice(0, 3), "through O": slice(3, 6)}[locus.kind]
        return -rank(chains[locus.where][:, part])
    locked = {j for j, joint in mechanism.joints.items() if joint.driven and locus.kind == "actuation"}
    passive = [np.concatenate([screws[j] for j in limb.joints if j not in locked]) for limb in mechanism.limbs.values()]
    wrenches = [reciprocal(chain.T).T for chain in passive]
    union = rank(np.concatenate(wrenches))
    return -union if locus.kind == "actuation" else sum(map(len, wrenches)) - union


@pytest.mark.parametrize("limbs", ["2-UPS+UP", slow("3-RRC")])
def test_loci_in_parameters_are_so_where_they_are_zero(limbs: str, tmp_path: Path) -> None:
    """A basis of wrenches may degenerate where its space does not: at H = 0 no force of a UP limb becomes a couple."""
    mechanism = load_description(write_template("made", limbs, tmp_path / "made.toml"))
    symbolic = symbolic_mobility(mechanism)
    assert symbolic is not None
    given = {p.symbol: float(p.value) for p in mechanism.parameters.values()}
    loci = conditions((*symbolic.loci, *actuation_loci(mechanism).found))
    seen = 0
    for locus in loci:
        for symbol in sorted(locus.expression.free_symbols, key=str):
            random = np.random.default_rng(len(str(locus)))
            about = {s: v * random.uniform(0.8, 1.2) for s, v in given.items()}
            value = sympy.lambdify(symbol, locus.expression.xreplace({s: v for s, v in about.items() if s != symbol}))
            grid = np.linspace(0.01, 2, 40)
            exact = [0.0] if abs(value(0.0)) < 1e-15 else []
            roots = exact + [brentq(value, a, b, xtol=1e-15) for a, b in pairwise(grid) if value(a) * value(b) < 0]
            for root in roots:
                there = numeric_screws(mechanism, {**about, symbol: root})
                usual = numeric_screws(mechanism, {**about, symbol: root + 0.05})
                assert lost(mechanism, locus, there) > lost(mechanism, locus, usual), (locus, symbol, root)
                seen += 1
    assert seen >= len(loci) // 2 > 0
