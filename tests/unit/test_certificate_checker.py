"""The checker of certificates: its arithmetic against many digits, Krawczyk's operator by hand, tampered files."""

from __future__ import annotations

import copy
import json
import math
import re
import subprocess
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest

from symscrew.studies.certificate import certificate_checker as checker
from symscrew.studies.certificate.certificate_checker import (
    FORMAT,
    Equations,
    Form,
    Program,
    RefusedError,
    UnreadableError,
    check_certificate,
    sine_cosine,
    tubes,
)
from symscrew.studies.certificate.way_from_reference import follow_way

MP = mpmath.mp.clone()
MP.dps = 40
EXACT: dict[str, Any] = {
    "add": lambda a, b: a + b, "sub": lambda a, b: a - b, "mul": lambda a, b: a * b, "neg": lambda a: -a,
    "div": lambda a, b: a / b, "reciprocal": lambda a: 1 / a, "sqrt": MP.sqrt, "sin": MP.sin, "cos": MP.cos,
    "tan": MP.tan, "atan2": MP.atan2, "abs": abs, "less": lambda a, b: MP.mpf(a < b),
    "select": lambda c, a, b: a if c else b,
}  # fmt: skip
ARITY = {"add": 2, "sub": 2, "mul": 2, "div": 2, "atan2": 2, "less": 2, "select": 3}
SMOOTH = ("add", "sub", "mul", "div", "neg", "reciprocal", "sqrt", "sin", "cos")


def random_program(rng: np.random.Generator, names: tuple[str, ...], length: int = 12) -> Program:
    """Of two inputs; constants are irrational numbers that are rounded."""
    instructions: list[list[Any]] = []
    for target in range(2, 2 + length):
        op = str(rng.choice(names))
        args = [
            int(rng.integers(target)) if rng.random() < 0.85 else float(rng.normal()) for _ in range(ARITY.get(op, 1))
        ]
        if not any(isinstance(a, int) for a in args):
            args[0] = 0
        instructions.append([target, op, *args])
    slots = list(range(2, 2 + length))
    return Program.read({"inputs": [["q", 2]], "instructions": instructions, "results": slots})


def exactly(program: Program, inputs: list[Any], off: float) -> dict[int, Any]:
    """Every slot with 40 digits, constants moved by a part of their last digit; those after a failure are left out."""
    values: dict[int, Any] = dict(enumerate(inputs))
    for target, op, args in program.instructions:
        if all(not isinstance(a, int) or a in values for a in args):
            given = [
                values[a] if isinstance(a, int) else MP.mpf(a) * (1 + MP.mpf(off) * MP.mpf(2) ** -53) for a in args
            ]
            try:
                made = EXACT[op](*given)
            except ZeroDivisionError:
                continue
            if isinstance(made, MP.mpf):
                values[target] = made
    return values


@pytest.mark.parametrize("seed", range(6))
def test_forms_hold_what_a_program_gives_with_many_digits(seed: int) -> None:
    """Random programs of every operation, over boxes from a rounding to a radian wide."""
    rng = np.random.default_rng([7, seed])
    known = 0
    for _ in range(8):
        program = random_program(rng, tuple(EXACT))
        middle, half = rng.normal(size=2), 10.0 ** rng.uniform(-14, 0, size=2)
        forms = checker.edges_of((middle - half)[:, None], (middle + half)[:, None])
        with np.errstate(all="ignore"):
            results = program.run({"q": forms, "p": []})[0]
        for d in ((-1, -1), (1, 1), (1, -1), *rng.uniform(-1, 1, size=(3, 2))):
            point = [
                MP.mpf(float(m)) + MP.mpf(float(h)) * MP.mpf(float(x)) for m, h, x in zip(middle, half, d, strict=True)
            ]
            values = exactly(program, point, float(rng.uniform(-1, 1)))
            for slot, form in enumerate(results, 2):
                if slot not in values or not np.isfinite(form.r[0]):
                    continue
                along = MP.mpf(float(form.c[0]))
                for k, x in enumerate(d):  # forms reach a little further than the box: d is a little smaller there
                    along += (
                        MP.mpf(float(form.l[k, 0]))
                        * MP.mpf(float(x))
                        * MP.mpf(float(half[k]))
                        / MP.mpf(float(forms[k].l[k, 0]))
                    )
                assert abs(values[slot] - along) <= MP.mpf(float(form.r[0])), (program, d, slot)
                known += 1
    assert known > 100


def test_slopes_hold_derivatives() -> None:
    rng = np.random.default_rng(11)
    known = 0
    for _ in range(12):
        program = random_program(rng, SMOOTH, 8)
        middle, half = rng.normal(size=2), 10.0 ** rng.uniform(-8, -1, size=2)
        forms = checker.edges_of((middle - half)[:, None], (middle + half)[:, None])
        with np.errstate(all="ignore"):
            results, rates = program.run({"q": forms, "p": []}, slopes=True)
        d = rng.uniform(-1, 1, size=2)
        point = [MP.mpf(float(m + h * x)) for m, h, x in zip(middle, half, d, strict=True)]
        step = MP.mpf(10) ** -15
        for column in range(2):
            ends = [exactly(program, [x + s * step * (k == column) for k, x in enumerate(point)], 0.0) for s in (1, -1)]
            for slot, (form, rate) in enumerate(zip(results, rates, strict=True), 2):
                if rate is None or slot not in ends[0] or slot not in ends[1] or not np.isfinite(rate.r[column, 0]):
                    continue
                slope = (ends[0][slot] - ends[1][slot]) / (2 * step)
                low, high = rate.bounds
                wide = MP.mpf(10) ** -20 * (1 + abs(slope))
                assert low[column, 0] - wide <= slope <= high[column, 0] + wide, (program, slot, form)
                known += 1
    assert known > 50


def test_sine_and_cosine_are_within_their_bound() -> None:
    rng = np.random.default_rng(3)
    near = np.arange(-40, 41) * (math.pi / 2)
    x = np.concatenate(
        [rng.uniform(-1500, 1500, 300), near, np.nextafter(near, 9), rng.normal(size=100) * 1e-8, near / 2]
    )
    s, c = sine_cosine(x)
    for value, a, b in zip(x, s, c, strict=True):
        assert abs(MP.sin(MP.mpf(float(value))) - MP.mpf(float(a))) < checker.SINE_ERROR
        assert abs(MP.cos(MP.mpf(float(value))) - MP.mpf(float(b))) < checker.SINE_ERROR
    assert np.isnan(sine_cosine(np.array([1e5, np.nan, np.inf]))[0]).all()


def root_file() -> dict[str, Any]:
    """x^2 = z, held up by nothing else: z from 1/4 to 9/4 in four boxes, on the branch of x = 1 at z = 1."""
    cuts = [0.25, 0.75, 1.25, 1.75, 2.25]
    return {
        "format": FORMAT,
        "mechanism": {"name": "root"},
        "equations": {
            "closure": {"inputs": [["q", 2]], "instructions": [[2, "mul", 1, 1], [3, "sub", 2, 0]], "results": [3]},
            "labels": ["opening"], "rows": [0], "quaternions": [], "count": 2, "axes": [["q", 0]], "held": [],
            "parameters": [], "driven": None,
            "conditions": [
                {"program": {"inputs": [["q", 2]], "instructions": [[2, "add", 1, 0]], "results": [2]},
                 "names": ["limb one"], "limits": None},
                {"program": {"inputs": [["q", 2]], "instructions": [], "results": [1]},
                 "names": ["limit x"], "limits": [[0.4, 1.6]]},
            ],
        },
        "region": {"names": ["z"], "low": [0.25], "high": [2.25]},
        "disk": None,
        "splitting": [0, 0, -1, -1, 0, -1, -1],
        "configurations": [[math.sqrt((a + b) / 2)] for a, b in pairwise(cuts)],
        "joints": [[1, 0], [1, 2], [2, 3]],
        "start": {"box": 1, "z": [1.0], "q": [1.0]},
        "claims": {"boxes": 4, "whole": True, "share": 0.999, "least": {"limb one": 0.7}},
    }  # fmt: skip


def test_a_sound_file_is_taken() -> None:
    verdict = check_certificate(root_file())
    assert verdict.holds and verdict.facts["whole"]
    assert 0.7 < verdict.facts["least"]["limb one"] <= 0.75  # at z = 1/4


def test_tubes_hold_the_root_and_no_other_and_none_reaches_the_fold() -> None:
    equations = Equations.read(root_file()["equations"])
    low, high = np.array([[0.9, 0.2, -0.1, 1e-4]]), np.array([[1.1, 0.4, 0.3, 0.2]])
    found = tubes(equations, low, high, np.sqrt(np.maximum((low + high) / 2, 0.1)))
    assert found.closed.tolist() == [True, True, False, False]
    for k in range(2):
        z = np.linspace(low[0, k], high[0, k], 41)
        d = np.linspace(-1, 1, 41)
        held = found.centre[0, k] + found.slope[0, 0, k] * d
        assert (np.abs(np.sqrt(z) - held) <= found.tight[0, k]).all()
        assert (np.abs(-np.sqrt(z) - held) > found.radius[0, k]).all()


def test_a_way_to_the_start_stays_on_its_branch() -> None:
    """From z = 1/2 in two boxes to the start at z = 1; from the other root there is no way."""
    values = root_file()
    own = {name: values["equations"][name] for name in ("rows", "axes", "held", "driven", "parameters")}
    way = {
        "equations": own, "low": [[0.5], [0.75]], "high": [[0.75], [1.0]],
        "configurations": [[math.sqrt(0.625)], [math.sqrt(0.875)]],
        "begin": {"z": [0.5], "q": [math.sqrt(0.5)]}, "end": {"z": [1.0], "q": [1.0]},
    }  # fmt: skip
    assert follow_way(values | {"way": way}) == ([0.5, math.sqrt(0.5)], [])
    for name, value in (
        ("configurations", [[-math.sqrt(0.625)], [math.sqrt(0.875)]]),
        ("begin", {"z": [0.5], "q": [-math.sqrt(0.5)]}),
        ("end", {"z": [1.0], "q": [-1.0]}),
        ("low", [[-0.5], [0.75]]),
        ("high", [[0.7], [1.0]]),
    ):
        with pytest.raises(RefusedError):
            follow_way(values | {"way": way | {name: value}})


def spoiled(path: tuple[Any, ...], value: Any) -> dict[str, Any]:
    values = copy.deepcopy(root_file())
    place: Any = values
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return values


@pytest.mark.parametrize(
    ("path", "value", "why"),
    [
        (("claims", "boxes"), 5, "boxes 5"),
        (("claims", "share"), 1.01, "share 1.01"),
        (("claims", "least", "limb one"), 0.8, "least"),
        (("claims", "least", "limb two"), 0.1, "least"),
        (("claims", "tilt"), 0.1, "tilt"),
        (("claims",), ["boxes"], UnreadableError),
        (("configurations", 2), [-math.sqrt(1.5)], "hold different|limb one|limit x"),
        (("configurations", 0), [0.1], "more or less than one"),
        (("region", "low"), [-0.25], "more or less than one"),
        (("start", "q"), [-1.0], "at the start"),
        (("start", "z"), [1.5], "at the start"),
        (("start", "box"), 3, "at the start"),
        (("joints",), [[1, 0], [1, 2]], "not joined to the start"),
        (("joints",), [[1, 0], [1, 2], [1, 3]], "where they meet"),
        (("joints",), [[1, 0], [2, 3], [1, 2]], "before"),
        (("equations", "conditions", 1, "limits"), [[0.6, 1.6]], "limit x may be too small"),
        (("equations", "conditions", 1, "limits"), [[0.4, 1.4]], "limit x may be too large"),
        (("equations", "conditions", 0, "program", "instructions"), [[2, "sub", 1, 1.0]], "limb one may be zero"),
        (("equations", "driven"), [1], None),
        (("equations", "driven"), [], "a freedom may be left"),
        (("splitting",), [0, 0, -1, -1, 0, -1, -2], UnreadableError),
        (("splitting",), [0, 0, -1, -1, 0, -1], UnreadableError),
        (("splitting",), [3, -1, -1], UnreadableError),
        (("equations", "rows"), [], UnreadableError),
        (("equations", "held"), [[1, 1.0]], UnreadableError),
        (("equations", "closure", "instructions"), [[2, "mul", 1, 3], [3, "sub", 2, 0]], UnreadableError),
        (("equations", "closure", "instructions"), [[2, "exec", 1], [3, "sub", 2, 0]], UnreadableError),
        (("joints",), [[1, 9]], UnreadableError),
        (("format",), "something", UnreadableError),
        (("equations", "closure", "inputs"), [["q", 1]], UnreadableError),  # its slopes would be those of other inputs
        (("equations", "axes"), [["p", -1]], UnreadableError),
        (("equations", "conditions", 1, "names"), ["limb one"], UnreadableError),  # one margin in place of another
        (("region", "high"), [0.25 - 2.0], UnreadableError),
    ],
)  # fmt: skip
def test_a_spoiled_file_is_refused(path: tuple[Any, ...], value: Any, why: Any) -> None:
    values = spoiled(path, value)
    if why is UnreadableError:
        with pytest.raises(UnreadableError):
            check_certificate(values)
        return
    verdict = check_certificate(values)
    assert verdict.holds == (why is None)
    if why is not None:
        assert any(re.search(why, text) for text in verdict.refused), verdict.refused


def test_an_undecided_box_is_not_counted() -> None:
    values = root_file()
    values |= {"splitting": [0, 0, -1, -1, 0, -1, -2], "joints": [[1, 0], [1, 2]]}
    values["configurations"].pop()
    assert check_certificate(values).refused  # claims four boxes, and the whole
    values["claims"] = {"boxes": 3, "whole": False, "share": 0.75}
    verdict = check_certificate(values)
    assert verdict.holds and not verdict.facts["whole"]
    values["claims"]["share"] = 0.76
    assert not check_certificate(values).holds


def disk_file(low: list[float], disk: dict[str, Any]) -> dict[str, Any]:
    """x^2 = 1 + (y + z) / 4 in one box of y and z, with the claim that all directions up to 0.1 are proved."""
    middle = 1 + (sum(low) + 0.2) / 8
    closure = [[3, "add", 0, 1], [4, "mul", 3, 0.25], [5, "add", 4, 1.0], [6, "mul", 2, 2], [7, "sub", 6, 5]]
    equations = {
        "closure": {"inputs": [["q", 3]], "instructions": closure, "results": [7]}, "labels": ["opening"], "rows": [0],
        "quaternions": [], "count": 3, "axes": [["q", 0], ["q", 1]], "held": [], "parameters": [], "driven": None,
        "conditions": [],
    }  # fmt: skip
    return root_file() | {
        "equations": equations, "region": {"names": ["y", "z"], "low": low, "high": [0.1, 0.1]}, "disk": disk,
        "splitting": [-1], "configurations": [[math.sqrt(middle)]], "joints": [],
        "start": {"box": 0, "z": [0.0, 0.0], "q": [1.0]}, "claims": {"radius": disk["radius"], "whole": True},
    }  # fmt: skip


@pytest.mark.parametrize(
    ("low", "axes", "radius", "said"),
    [
        ([-0.1, -0.1], [0, 1], 0.1, None),
        ([0.0, -0.1], [0, 1], 0.1, "larger than the region"),
        ([-0.1, -0.05], [0, 1], 0.1, "larger than the region"),
        ([-0.1, -0.1], [0, 1], 0.11, "larger than the region"),
        ([-0.1, -0.1], [0, 1], -0.1, UnreadableError),
        ([-0.1, -0.1], [0, 1], math.nan, UnreadableError),
        ([-0.1, -0.1], [1, 1], 0.1, UnreadableError),
        ([-0.1, -0.1], [-1, 0], 0.1, UnreadableError),
        ([-0.1, -0.1], [0, 2], 0.1, UnreadableError),
    ],
)  # fmt: skip
def test_a_disk_is_of_every_direction(low: list[float], axes: list[int], radius: float, said: Any) -> None:
    """Half of a disk, or none with a negative radius, is no proof of a tilt in every direction."""
    values = disk_file(low, {"axes": axes, "radius": radius})
    if said is UnreadableError:
        with pytest.raises(UnreadableError):
            check_certificate(values)
        return
    verdict = check_certificate(values)
    assert verdict.holds == (said is None) and (said is None or said in verdict.refused[0]), verdict
    assert "of these all directions of y and z up to" in str(verdict)


def test_tubes_with_edges_of_their_own_reach_further_and_never_to_where_solutions_meet() -> None:
    """x^2 = z about x = 1: intervals for x come to 80 % of the way to z = 0, where both solutions meet."""
    equations = Equations.read(root_file()["equations"])
    half = np.array([0.8, 0.95, 1.0, 1.1])
    found = tubes(equations, 1 - half[None], 1 + half[None], np.ones((1, 4)))
    assert found.closed.tolist() == [True, True, False, False]
    for k in (0, 1):
        d = np.linspace(-1, 1, 201)
        middle, x = 1 + found.slope[0, 0, k] * d, np.sqrt(1 + half[k] * d)
        assert (np.abs(x - middle) <= found.tight[0, k]).all() and found.tight[0, k] < found.radius[0, k]
        assert (np.abs(-x - middle) > found.radius[0, k]).all()


def test_a_number_of_coordinates_that_fills_the_memory_is_none() -> None:
    for path in (("equations", "count"), ("equations", "closure", "inputs", 0, 1)):
        with pytest.raises(UnreadableError):
            check_certificate(spoiled(path, 10**30))


def test_what_is_proved_names_the_limits_and_a_file_without_claims_proves_nothing() -> None:
    assert "limit x within [0.4, 1.6]" in check_certificate(root_file()).proved
    silent = spoiled(("claims",), {})
    assert not check_certificate(silent).holds
    silent["equations"]["conditions"] = []
    assert not check_certificate(silent).holds


def test_names_in_a_file_say_nothing_in_the_checkers_place() -> None:
    values = spoiled(("mechanism", "name"), "root\nproved: share 2\x1b[1m")
    values["region"]["names"] = ["z\nproved: tilt"]
    shown = [line for line in str(check_certificate(values)).splitlines() if line.startswith("proved: ")]
    assert len(shown) == 5 and "\x1b" not in str(check_certificate(values))
    for text in ('{"a": 1, "a": 2}', '{"a": NaN}', '[{"b": {"a": 1, "a": 1}}]'):
        with pytest.raises(UnreadableError):
            checker.values_of(text)


def test_rank_of_a_tall_matrix_is_decided_only_where_it_is() -> None:
    """Columns at an angle: independent while what is unknown of them is smaller than the angle leaves."""
    matrix = np.array([[1.0, 1.0], [0.0, 0.2], [0.0, 0.0]])[:, :, None]
    for radius, holds in ((0.0, True), (0.04, True), (0.11, False)):
        form = Form(matrix, np.zeros((1, *matrix.shape)), np.full(matrix.shape, radius))
        assert bool(checker.full_rank(form)[0]) == holds


def test_the_file_runs_without_the_package(tmp_path: Path) -> None:
    good, bad, none = (tmp_path / f"{name}.json" for name in ("good", "bad", "none"))
    good.write_text(json.dumps(root_file()))
    bad.write_text(json.dumps(spoiled(("claims", "boxes"), 5)))
    none.write_text("[]")
    alone = tmp_path / "alone.py"
    alone.write_text(Path(checker.__file__).read_text())
    codes = []
    for file in (good, bad, none):
        run = subprocess.run([sys.executable, "-I", alone, file], capture_output=True, text=True, check=False)
        codes.append(run.returncode)
        assert "Traceback" not in run.stderr
    assert codes == [0, 1, 2]
