"""Mechanisms re-posed at random and written with few digits: is their verdict kept, or said why not?

    exact joints --random rotation, shift, unit--> numbers as typed --analysis, verification--> kept | explained | wrong

Kept: all ranks and the finite mobility are those of the exact mechanism, and every check of the result holds.
Explained: they are not, but the result says itself that special geometry lies within the rounding of the numbers, with
these verdicts. Warned: it says only that it is
almost singular as typed, or that other geometry may have been meant than the one that it names. Wrong: none of these.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
import sympy

from symscrew.algebra import CONTEXT, high_precision
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.mobility.analysis import Mobility, analyse_mobility
from symscrew.mobility.checks import verified

from .reference_mechanisms import ENTRIES
from .reference_mechanisms import build as build_entry

DIGITS = ("double", "12", "9", "6")
UNITS = {"m": 1, "mm": 1000, "km": Fraction(1, 1000)}
Joints = list[dict[str, Any]]
FACTS = ("kutzbach", "dof", "overconstraints", "internal_freedoms", "dof_drives_locked")


@dataclass(frozen=True)
class Posed:
    """A mechanism as typed, its result without what a check withdrew, the failed checks, and the verdict."""

    name: str
    found: Mobility | None
    failed: tuple[str, ...]
    verdict: str


def typed(value: Any, digits: str) -> sympy.Rational:
    """A number as people type it: the decimal that Python prints for a double, or so many significant digits."""
    text = repr(float(value)) if digits == "double" else f"{float(value):.{digits}g}"
    return sympy.Rational(text)


def posed(joints: Joints, *, seed: int, digits: str, unit: str) -> Joints:
    """The joints turned, shifted, in another unit, typed."""
    random = np.random.default_rng(seed)
    w, x, y, z = (CONTEXT.mpf(float(c)) for c in random.normal(size=4))
    n = w * w + x * x + y * y + z * z
    turn = [
        [1 - 2 * (y * y + z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
        [2 * (x * y + w * z) / n, 1 - 2 * (x * x + z * z) / n, 2 * (y * z - w * x) / n],
        [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, 1 - 2 * (x * x + y * y) / n],
    ]
    shift = [CONTEXT.mpf(float(c)) for c in random.normal(size=3)]
    factor = CONTEXT.mpf(Fraction(UNITS[unit]).numerator) / Fraction(UNITS[unit]).denominator

    def turned(vector: Any) -> list[Any]:
        given = [high_precision(sympy.sympify(c)) for c in vector]
        return [sum(turn[i][k] * given[k] for k in range(3)) for i in range(3)]

    result = []
    for joint in joints:
        point = [factor * (c + s) for c, s in zip(turned(joint["point"]), shift, strict=True)]
        made = {**joint, "point": [typed(c, digits) for c in point]}
        made["axes"] = [_axis([typed(c, digits) for c in turned(axis)], digits) for axis in joint.get("axes", [])]
        if joint.get("pitch") is not None:
            made["pitch"] = typed(factor * high_precision(sympy.sympify(joint["pitch"])), digits)
        result.append(made)
    return result


def _axis(components: list[sympy.Rational], digits: str) -> list[sympy.Rational]:
    """Doubles are unit vectors as they are; of fewer digits the unit vector in 20, as the refusal of others asks."""
    if digits == "double":
        return components
    numbers = [high_precision(c) for c in components]
    size = CONTEXT.sqrt(sum(c * c for c in numbers))
    return [sympy.Rational(CONTEXT.nstr(c / size, 20)) for c in numbers]


def judged(name: str, mechanism: Mechanism, expected: dict[str, Any]) -> Posed:
    """The verdict about one mechanism as typed."""
    found, checks = verified(analyse_mobility(mechanism))
    failed = tuple(check.claim for check in checks if not check.holds)
    if not failed and agrees(found, expected):
        return Posed(name, found, failed, "kept")
    near = getattr(found, "near", None)
    if not failed and near is not None and agrees(near.meant, expected):
        return Posed(name, found, failed, "explained")
    if not failed and (found.nearly_singular or found.nearly_special or may_be_another(found)):
        return Posed(name, found, failed, "warned")
    return Posed(name, found, failed, "undecided" if found.finite.dof is None and not failed else "wrong")


def may_be_another(found: Mobility) -> bool:
    """Whether it says that other geometry than the one named may have been meant."""
    said = ("may have been meant", "one that moves more may be near")
    return found.near is not None and any(phrase in text for text in found.not_tried for phrase in said)


def agrees(found: Mobility, expected: dict[str, Any]) -> bool:
    """All ranks, the platform's type and the finite mobility."""
    branches = None if found.finite.branches is None else list(found.finite.branches)
    platform = expected.get("platform")
    return (
        all(getattr(found, key) == expected[key] for key in FACTS)
        and (found.finite.dof, found.finite.smooth, branches)
        == (expected["dof_finite"], expected["smooth"], expected["branches"])
        and (platform is None or (found.platform.dof, found.platform.type) == (platform["dof"], platform["type"]))
    )


def reference(name: str, *, seed: int, digits: str, unit: str) -> Posed:
    """An entry of `data/mobility.json` as typed."""
    entry = ENTRIES[name]
    change: Callable[[Joints], Joints] = lambda joints: posed(joints, seed=seed, digits=digits, unit=unit)  # noqa: E731
    return judged(name, build_entry(entry, change), entry["expected"])


# -- generic mechanisms -----------------------------------------------------------------------------------


def generic(seed: int) -> tuple[Joints, list[list[str]]]:
    """(joints, limbs) of random geometry: no overconstraint, no special pose, so Kutzbach's count is its mobility."""
    random = np.random.default_rng(7000 + seed)
    letters: list[str] = []
    wanted = int(random.integers(2, 5))
    constraints = 0
    while len(letters) < wanted:
        limb = "".join(random.choice(list("RRRPUSC"), size=int(random.integers(3, 6))))
        freedom = sum({"U": 2, "S": 3, "C": 2}.get(c, 1) for c in limb)
        if (
            limb.count("P") <= 1
            and limb.count("S") <= 1
            and 4 <= freedom <= 7
            and constraints + max(0, 6 - freedom) < 6
        ):
            constraints += max(0, 6 - freedom)
            letters.append(limb)
    joints: Joints = []
    for k, limb in enumerate(letters):
        bodies = ["base", *(f"L{k}b{i}" for i in range(len(limb) - 1)), "platform"]
        for i, letter in enumerate(limb):
            axes = [list(v / np.linalg.norm(v)) for v in random.normal(size=({"S": 0, "U": 2}.get(letter, 1), 3))]
            joint: dict[str, Any] = {"name": f"L{k}_{i}", "type": letter, "parent": bodies[i], "child": bodies[i + 1]}
            joint["point"] = [sympy.Rational(repr(float(c))) for c in random.normal(size=3)]
            joint["axes"] = [[sympy.Rational(repr(float(c))) for c in axis] for axis in axes]
            joints.append(joint)
    return joints, [[f"L{k}_{i}" for i in range(len(limb))] for k, limb in enumerate(letters)]


def generic_posed(seed: int, *, digits: str, unit: str) -> Posed:
    """A generic mechanism as typed; full rank is what random geometry has with probability one."""
    joints, limbs = generic(seed)
    builder = MechanismBuilder("generic", platform="platform")
    for body in dict.fromkeys(b for j in joints for b in (j["parent"], j["child"]) if b != "base"):
        builder.body(body)
    freedoms = 0
    for joint in posed(joints, seed=seed, digits=digits, unit=unit):
        options = {key: value for key, value in joint.items() if key not in ("name", "type") and value != []}
        builder.joint(joint["name"], joint["type"], **options)
        freedoms += {"U": 2, "S": 3, "C": 2}.get(joint["type"], 1)
    for k, names in enumerate(limbs):
        builder.limb(f"limb{k}", joints=names)
    count = freedoms - 6 * (len(limbs) - 1)
    platform = 6 - sum(max(0, 6 - sum({"U": 2, "S": 3, "C": 2}.get(j["type"], 1) for j in joints if j["name"] in names))
                       for names in limbs)  # fmt: skip
    expected = {
        "kutzbach": count, "dof": count, "overconstraints": 0, "internal_freedoms": count - platform,
        "dof_drives_locked": None, "dof_finite": count, "smooth": True, "branches": None,
    }  # fmt: skip
    return judged(f"generic{seed}", builder.build(), expected)


def every(names: Any = None, generics: int = 30, seed: int = 0) -> Iterator[tuple[str, str, str, Callable[[], Posed]]]:
    """(digits, unit, name, what judges it) of the whole set; seeds follow the order from `seed` on, so results repeat.

    Another `seed` poses all anew, and makes other generic mechanisms.
    """
    for digits in DIGITS:
        for unit in UNITS:
            for k, name in enumerate(ENTRIES if names is None else names, start=seed):
                yield digits, unit, name, lambda n=name, k=k, d=digits, u=unit: reference(n, seed=k, digits=d, unit=u)  # type: ignore[misc]
            for k in range(seed, seed + generics):
                yield digits, unit, f"generic{k}", lambda k=k, d=digits, u=unit: generic_posed(k, digits=d, unit=u)  # type: ignore[misc]
