"""Every key of a problem file counts: it changes the program that is solved, or an error names it."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from support.optimal_problems import pendulum, rest_to_rest

from symscrew.cli.parser import main
from symscrew.errors import DescriptionError
from symscrew.optimisation import problem_keys
from symscrew.optimisation.contradictions import READ, check_problem
from symscrew.optimisation.many_starts import random_guesses
from symscrew.optimisation.problem import OBJECTIVES, Bounds, Conditions, Objective, Obstacle, Solver, TrajectoryProblem
from symscrew.optimisation.problem_file import KEYS, load_problem, parse_problem
from symscrew.optimisation.solution import prepare, transcribe

pytestmark = pytest.mark.slow

MECHANISM = """
[mechanism]
name = "bead"
ground = "base"
platform = "bead"
[parameters.m]
value = 1
unit = "kg"
description = "mass of the bead"
[bodies.carriage]
[bodies.bead]
mass = "m"
com = [0, 0, 0]
[joints.x]
type = "P"
parent = "base"
child = "carriage"
point = [0, 0, 0]
axes = [[1, 0, 0]]
driven = true
[joints.z]
type = "P"
parent = "carriage"
child = "bead"
point = [0, 0, 0]
axes = [[0, 0, 1]]
driven = true
[points.bead]
body = "bead"
at = [0, 0, 0]
[points.post]
body = "base"
at = [0, 0, "0.1"]
"""
TEXTS = {
    section: {name: key.example for name, key in keys.items()}
    for section, keys in {**problem_keys.SECTIONS, "whole": problem_keys.OWN}.items()
}


def text(section: str = "", key: str = "") -> str:
    """A small problem, with one key said otherwise."""
    parts = {
        "problem": ['mechanism = "mechanism.toml"', *(() if key == "duration" else ("duration = 1",))],
        "start": ["coordinates = { x = 0, z = 0 }"], "end": [], "bounds": [], "transcription": [], "solver": [],
    }  # fmt: skip
    if section in ("start", "end", "via"):
        given = TEXTS[section][key]
        parts[section] = [given if section != "via" or key == "time" else f"{given}\ntime = 0.5"]
    elif section in parts:
        parts[section] = [*parts[section], TEXTS[section][key]]
    if section == "via":
        parts["via"].insert(0, "")
    if not (section == "transcription" and key in ("mesh", "intervals")):
        parts["transcription"].append("intervals = 2")
    names = {"via": "[[via]]"}
    made = "".join(f"{names.get(name, f'[{name}]')}\n" + "\n".join(lines) + "\n" for name, lines in parts.items())
    made += f"[[objectives]]\n{TEXTS['objectives'][key]}\n" if section == "objectives" else ""
    return made + (TEXTS["whole"][key] + "\n" if section == "whole" else "")


def fingerprint(folder: Path, given: str) -> list[object]:
    """All numbers of the program that is solved, the guess it starts from, and how its end is judged."""
    (folder / "mechanism.toml").write_text(MECHANISM)
    (folder / "problem.toml").write_text(given)
    problem = load_problem(folder / "problem.toml")
    made = prepare(problem)
    t = transcribe(made.model)
    random = np.random.default_rng(1)
    parts: list[object] = [t.unknowns.labels, t.unknowns.lower, t.unknowns.upper, t.cost, t.linear.labels]
    parts += [t.linear.lower, t.linear.upper, t.linear.map.columns, t.linear.map.values, made.guess.path.values]
    for family in t.families:
        f = family.function
        rows = ca.vertcat(ca.SX(0, 1), *[r.value / r.scale for r in f.rows])
        values = ca.Function("f", [f.arguments], [rows, ca.SX(f.integrand if f.integrand is not None else 0)])
        at = random.uniform(0.5, 1.5, f.arguments.numel())
        parts += [[r.label for r in f.rows], [(r.lower, r.upper) for r in f.rows], family.tau, family.weights]
        parts += [np.array(v) for v in values(at)]
    parts += [str(random_guesses(problem, made.model, made.guess))]
    return [*parts, problem.accuracy, problem.violation, problem.solver, problem.name]


def same(a: list[object], b: list[object]) -> bool:
    return len(a) == len(b) and all(np.array_equal(np.asarray(x), np.asarray(y)) if isinstance(x, np.ndarray)
                                    else x == y for x, y in zip(a, b, strict=True))  # fmt: skip


EVERY = [
    (section, key) for section, keys in KEYS.items() for key in keys
    if (section, key) not in {("problem", "scene"), ("problem", "mechanism"), ("problem", "description")}
]  # fmt: skip


def test_every_field_of_a_problem_has_a_key() -> None:
    """What Python can say a file can say too."""
    elsewhere = {"effects", "start", "end", "via", "bounds", "objectives", "design", "parameters", "preload", "inputs",
                 "guess", "transcription", "solver", "text", "notices"}  # fmt: skip
    for section, holder in problem_keys.HOLDERS.items():
        names = {f.name for f in dataclasses.fields(holder)} - (elsewhere if section == "problem" else set())
        keys = problem_keys.SECTIONS[section]
        held = {key.field or name for name, key in keys.items() if key.field != "-"}
        left_out = {"start": {"time"}, "end": {"time"}, "via": {"mode"}}
        assert held == names - left_out.get(section, set())


def test_the_page_lists_every_key_with_its_default() -> None:
    page = (Path(__file__).parents[2] / "docs" / "how_to" / "optimise.md").read_text()
    assert page.endswith(problem_keys.tables_of_keys())
    assert "| `intervals` | - | 50 |" in page and "| `violation` | 1 | 1e-05 |" in page
    assert "| `accuracy` | rad, m; 1 | [5e-07, 1e-09] |" in page and "| `at_rest` | - | false |" in page


def test_help_points_to_the_keys(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["optimise", "--keys"])
    assert ended.value.code == 0 and capsys.readouterr().out == problem_keys.tables_of_keys()
    with pytest.raises(SystemExit):
        main(["optimise", "--help"])
    assert "docs/how_to/optimise.md" in capsys.readouterr().out


@pytest.fixture(scope="module")
def usual(tmp_path_factory: pytest.TempPathFactory) -> list[object]:
    return fingerprint(tmp_path_factory.mktemp("usual"), text())


@pytest.mark.parametrize("section", sorted({section for section, _ in EVERY} | {"whole"}))
def test_every_key_counts(tmp_path: Path, usual: list[object], section: str) -> None:
    keys = [*(key for of, key in EVERY if of == section), *(TEXTS["whole"] if section == "whole" else ())]
    assert [key for key in keys if not _counts(tmp_path, usual, section, key=key)] == []


def _counts(tmp_path: Path, usual: list[object], section: str, *, key: str) -> bool:
    """Whether a problem with the key differs from one without."""
    beside = usual
    if (section, key) == ("whole", "inputs"):  # beside the effect that has them
        beside = fingerprint(tmp_path, text(section, key).replace("[1, 2, 3, 0, 0, 0]", "[0, 0, 0, 0, 0, 0]"))
    if key == "mode":  # which the bead has not
        with pytest.raises(DescriptionError, match=rf"{section}.mode: bead has no mode '-1'"):
            fingerprint(tmp_path, text(section, key))
        return True
    if key == "turns":  # of a mechanism that can turn
        crank = 'mechanism = "four_bar"'
        made = text(section, key).replace('mechanism = "mechanism.toml"', crank).replace("x = 0, z = 0", "A = 0.1")
        made = made.replace("hinge", "A")
        return not same(fingerprint(tmp_path, made), fingerprint(tmp_path, made.replace("A = 1 }", "A = 2 }")))
    return not same(fingerprint(tmp_path, text(section, key)), beside)


def test_a_description_is_kept_with_the_text(tmp_path: Path) -> None:
    (tmp_path / "mechanism.toml").write_text(MECHANISM)
    (tmp_path / "problem.toml").write_text(text("problem", "description"))
    assert "about it" in load_problem(tmp_path / "problem.toml").text


# -- what is refused -----------------------------------------------------------------------------------------------


def swing(**settings: object) -> TrajectoryProblem:
    return replace(TrajectoryProblem(pendulum(), **rest_to_rest({"hinge": 0.0}, {"hinge": 1.0})), **settings)  # type: ignore[arg-type]


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize(
    "where, settings",
    [
        ("start.coordinates.hinge", lambda x: {"start": Conditions(coordinates={"hinge": x})}),
        ("end.rates.hinge", lambda x: {"end": Conditions(rates={"hinge": x})}),
        ("via[0].points.bob[1]", lambda x: {"via": (Conditions(points={"bob": (0.0, x, None)}, time=0.5),)}),
        ("end.platform_normal[2]", lambda x: {"end": Conditions(platform_normal=(0.0, 0.0, x))}),
        ("objectives[0].weight", lambda x: {"objectives": (Objective("effort", x),)}),
        ("objectives[0].weights.hinge", lambda x: {"objectives": (Objective("effort", weights={"hinge": x}),)}),
        ("guess.hinge[1]", lambda x: {"guess": {"hinge": (0.0, x)}}),
        ("parameters.m", lambda x: {"parameters": {"m": x}}),
        ("inputs.force[0]", lambda x: {"inputs": {"force": (x,)}}),
    ],
)
def test_what_is_no_number_is_refused_by_name(where: str, settings, number: float) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(DescriptionError) as error:
        prepare(swing(**settings(number)))
    assert str(error.value).startswith(f"{where}: expected a finite number")


def test_bounds_may_be_infinite_but_numbers() -> None:
    check_problem(swing(bounds=Bounds(joints={"hinge": (-math.inf, 2.0)}), accuracy=(math.inf, math.inf)))
    with pytest.raises(DescriptionError, match="hinge"):
        check_problem(swing(bounds=Bounds(joints={"hinge": (math.nan, 2.0)})))


@pytest.mark.parametrize("kind", OBJECTIVES)
def test_objectives_refuse_what_they_do_not_read(kind: str) -> None:
    parts = {"weights": {"hinge": 2.0}, "preload": {"hinge": 2.0}, "expression": "u_hinge^2"}
    own = {name: parts[name] for name in READ[kind]}
    duration = (0.1, 2.0) if kind == "time" else 1.0
    check_problem(swing(objectives=(Objective(kind, **own),), duration=duration))  # type: ignore[arg-type]
    for name in set(parts) - set(own):
        with pytest.raises(DescriptionError, match=rf"objectives\[0\]\.{name}: an objective '{kind}' takes none"):
            check_problem(swing(objectives=(Objective(kind, **own, **{name: parts[name]}),), duration=duration))  # type: ignore[arg-type]


CAPSULE = Obstacle("capsule", ("bob",), ("bob",), 0.0)


@pytest.mark.parametrize(
    "said, settings",
    [
        ("rates of hinge stand beside at_rest", {"end": Conditions(rates={"hinge": 0.0}, at_rest=True)}),
        ("only via conditions have a time", {"start": Conditions(coordinates={"hinge": 0.0}, time=0.0)}),
        ("nothing is asked for", {"via": (Conditions(time=0.5),)}),
        ("all three coordinates are free", {"end": Conditions(points={"bob": (None, None, None)})}),
        ("stands 2 times", {"objectives": (Objective("peak"), Objective("peak", 2.0))}),
        ("turns: those of hinge count in a periodic motion only", {"turns": {"hinge": 1}}),
        ("turns.hinge: expected a whole number of turns, got 1.5", {"turns": {"hinge": 1.5}, "periodic": True}),
        ("duration: expected a finite positive number", {"duration": float("inf")}),
        ("turns: unknown name 'slide'", {"turns": {"slide": 1}, "periodic": True}),
        (r"obstacles\[0\].at: a capsule has 2 points", {"bounds": Bounds(obstacles=(CAPSULE,))}),
        ("distance: expected a length above 0", {"bounds": Bounds(obstacles=(replace(CAPSULE, type="sphere"),))}),
        ("preload.hinge: nothing reads it", {"preload": {"hinge": 1.0}}),
        ("solver.tolerance: it is IPOPT's", {"solver": Solver("sqpmethod", tolerance=1e-4)}),
        ("solver.iterations", {"solver": Solver("blocksqp", iterations=10)}),
        ("solver.time_limit: expected seconds above 0", {"solver": Solver(time_limit=-1.0)}),
        ("solver.time_limit: only IPOPT", {"solver": Solver("sqpmethod", time_limit=1.0)}),
        ("at least one iteration", {"solver": Solver(iterations=0)}),
        ("outside its range under 'design'", {"design": {"m": (1.0, 2.0)}, "parameters": {"m": 3.0}}),
        ("no effect has an input 'wind'", {"inputs": {"wind": (1.0,)}}),
    ],
)
def test_what_could_not_count_is_refused(said: str, settings: dict[str, object]) -> None:
    with pytest.raises(DescriptionError, match=said):
        prepare(swing(**settings))


def test_coordinates_of_a_problem_are_given_with_units() -> None:
    head = '[problem]\nmechanism = "four_bar"\nduration = 1\n'
    problem = parse_problem(
        head + '[start]\ncoordinates = { A = "30deg" }\n[end]\ncoordinates = { A = 0.5 }\n'
        '[bounds]\njoints = { B = ["-90deg", "pi/2"], C = "45 deg" }\n'
    )
    assert problem.start.coordinates["A"] == pytest.approx(math.pi / 6, abs=1e-15)
    assert problem.bounds.joints["B"] == pytest.approx((-math.pi / 2, math.pi / 2))
    assert problem.bounds.joints["C"] == pytest.approx((-math.pi / 4, math.pi / 4))
    for text in ('[start]\ncoordinates = { A = "30mm" }', '[bounds]\njoints = { B = ["1m", 2] }'):
        with pytest.raises(DescriptionError, match=r"expected an angle \[rad, deg\], got one in m"):
            parse_problem(head + text)
