"""Phases and load cases: against closed forms, another computation of impacts, and the same solved one by one."""

from __future__ import annotations

import csv
import json
import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.optimal_problems import pendulum, rest_to_rest, slider

from symscrew.cli.parser import main
from symscrew.description import MechanismBuilder, load_description
from symscrew.effects import DcMotor, EndStop, Gravity, JointSpring, Payload
from symscrew.errors import DescriptionError
from symscrew.optimisation import problem_keys
from symscrew.optimisation.joined_file import load_problem_file, parse_joined
from symscrew.optimisation.joined_plan import JoinedPlan
from symscrew.optimisation.joined_problem import JoinedProblem, Link
from symscrew.optimisation.joined_replay import linked
from symscrew.optimisation.joined_solution import solve_joined
from symscrew.optimisation.problem import Bounds, Conditions, Objective, TrajectoryProblem, Transcription
from symscrew.optimisation.problem_file import parse_problem
from symscrew.optimisation.solution import solve
from symscrew.scene.contents import Initial, Scene
from symscrew.simulation.motion import simulate

pytestmark = pytest.mark.slow

SMALL = Transcription(intervals=3)
SHORT_FIVE_BAR = load_description(Path(__file__).parents[1] / "data" / "short_five_bar.toml")
THERE = TrajectoryProblem(
    slider(), (), duration=0.5, start=Conditions(coordinates={"slide": 0.0}, at_rest=True),
    end=Conditions(coordinates={"slide": 0.5}), transcription=SMALL,
)  # fmt: skip
BACK = replace(THERE, start=Conditions(), end=Conditions(coordinates={"slide": 0.2}, at_rest=True))


def effort(way: float, first: float, last: float, duration: float) -> float:
    """Least integral of u^2 that moves 1 kg over a way, from one rate to another."""
    t, mean = duration, way / duration
    return 4 / t * (3 * mean**2 - 3 * mean * (first + last) + first**2 + first * last + last**2)


@pytest.mark.parametrize("link", [Link(), Link({"slide": 0.0}), Link({"slide": 0.4}), Link({"slide": 1.0})])
def test_a_mass_that_hits_a_wall(link: Link) -> None:
    """From 0 to 0.5 m, then to rest at 0.2 m, each in 0.5 s: the rate at the wall is what the sum of efforts wants."""
    sign = -link.impact["slide"] if link.impact else 1.0
    rates = np.linspace(-4, 4, 3)  # the sum is a parabola of the rate
    sums = [effort(0.5, 0, v, 0.5) + effort(-0.3, sign * v, 0, 0.5) for v in rates]
    a, b, c = np.polyfit(rates, sums, 2)
    found = solve_joined(JoinedProblem((THERE, BACK), (link,)))
    assert found.ok and found.end_error is not None and found.end_error < 1e-9
    assert found.cost == pytest.approx(c - b**2 / (4 * a), rel=1e-9)
    (passed,) = found.links
    assert passed is not None and passed.before[0] == pytest.approx(-b / (2 * a), abs=1e-8)
    assert passed.behind[0] == pytest.approx(sign * passed.before[0], abs=1e-8)
    assert passed.lost == pytest.approx((1 - sign**2) * passed.before[0] ** 2 / 2, abs=1e-8)


@pytest.mark.parametrize("catches", [True, False])
def test_a_load_is_picked_up(catches: bool) -> None:
    """3 kg at rest on the way of 1 kg: the rate falls to a quarter; a load that moves along takes nothing."""
    heavier = replace(BACK, end=Conditions(coordinates={"slide": 1.0}, at_rest=True), effects=(
        Payload("mass", "3", ("0.5", 0, 0)),))  # fmt: skip
    found = solve_joined(JoinedProblem((THERE, heavier), (Link(catches=catches),)))
    (passed,) = found.links
    share = 0.25 if catches else 1.0
    assert found.ok and passed is not None and passed.behind[0] == pytest.approx(share * passed.before[0], abs=1e-9)
    rates = np.linspace(-4, 4, 3)
    sums = [effort(0.5, 0, v, 0.5) + 16 * effort(0.5, share * v, 0, 0.5) for v in rates]
    a, b, _ = np.polyfit(rates, sums, 2)
    assert passed.before[0] == pytest.approx(-b / (2 * a), abs=1e-8)
    assert passed.lost == pytest.approx((1 - (4 * share if catches else 4) * share / (1 if catches else 4))
                                        * passed.before[0] ** 2 / 2, abs=1e-8)  # fmt: skip


def hit(label: str, restitution: float) -> JoinedPlan:
    """The short five-bar, one of whose joints is thrown back on the way."""
    home = Conditions(coordinates={"base_left": 0.0, "base_right": 0.0}, at_rest=True)
    first = TrajectoryProblem(
        SHORT_FIVE_BAR, duration=0.3, start=home, end=Conditions(coordinates={"base_left": 0.3, "base_right": 0.2}),
        transcription=Transcription(intervals=3), accuracy=(1e-1, 1e-3), independent=("base_left", "base_right"),
    )  # fmt: skip
    second = replace(first, start=Conditions(), end=home, duration=(0.2, 0.4))
    return solve_joined(JoinedProblem((first, second), (Link({label: restitution}),)))


@pytest.mark.slow
@pytest.mark.parametrize("label, restitution", [("base_right", 0.3), ("elbow_left", 0.0)])
def test_an_impact_of_a_closed_chain_is_that_of_the_simulation(label: str, restitution: float) -> None:
    """The simulation meets a rigid stop where the first phase ends, with its rates."""
    found = hit(label, restitution)
    assert found.ok, found.reasons
    at = found.parts[0].sample(np.array([found.parts[0].duration]))
    tree = found.parts[0].model.system.tree
    place = {c.label: v for c, v in zip(tree.q, at.q[0], strict=True)}
    rate = {c.label: v for c, v in zip(tree.v, at.v[0], strict=True)}
    assert abs(rate[label]) > 0.1
    end = {"upper" if rate[label] > 0 else "lower": repr(float(place[label]))}
    stop = EndStop(label, mode="impact", restitution=repr(restitution), **end)  # type: ignore[arg-type]
    own = ("base_left", "base_right")
    start = Initial({n: place[n] for n in own}, {n: rate[n] for n in own})
    run = simulate(Scene("hit", SHORT_FIVE_BAR, (stop,), 1e-6, 1e6, start), backend="numpy")
    after = {c.label: v for c, v in zip(tree.v, run.v[-1], strict=True)}
    (passed,) = found.links
    assert passed is not None
    expected = [after[name] for name in found.parts[0].labels]
    assert passed.behind == pytest.approx(expected, abs=1e-5 * float(np.abs(passed.before).max()))
    assert np.abs(passed.behind - passed.before).max() > 0.05  # the impact is no small one


def test_load_cases_share_their_design() -> None:
    """A spring beside a drive, for two motions: the sum of efforts has no slope at the stiffness that is found."""
    made = MechanismBuilder("slider")
    made.parameter("k", "3", unit="N/m")
    made.body("mass", mass=1, com=[0, 0, 0])
    made.joint("slide", "P", parent="base", child="mass", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    usual = TrajectoryProblem(
        made.build(), (JointSpring("slide", stiffness="k"),), transcription=SMALL, design={"k": (0.0, 50.0)},
        **rest_to_rest({"slide": -1.0}, {"slide": 1.0}), accuracy=None,
    )  # fmt: skip
    other = replace(usual, duration=1.5, objectives=(Objective("effort", weight=3.0),),
                    **rest_to_rest({"slide": -0.7}, {"slide": 0.2}))  # fmt: skip
    found = solve_joined(JoinedProblem((usual, other), (None,)))
    assert found.ok and found.links == (None,)

    def cost(k: float) -> float:
        return sum(solve(replace(p, design={}, parameters={"k": k})).cost for p in (usual, other))

    near = found.parameters["k"] + 0.02 * np.arange(-1, 2)
    below, here, above = (cost(k) for k in near)
    assert found.cost == pytest.approx(here, rel=1e-9) and 1 < near[1] < 49
    assert 0.02 * (above - below) / (above + below - 2 * here) == pytest.approx(0, abs=1e-4)
    assert found.parts[0].parameters == pytest.approx(found.parts[1].parameters, abs=1e-9)


def test_states_go_on_and_durations_are_chosen() -> None:
    """One motion in two phases is the motion itself, its motor's current going on from one to the other."""
    motor = DcMotor("hinge", torque_constant="0.5", resistance="1", inductance="0.05")
    whole = TrajectoryProblem(
        pendulum(), (Gravity(), motor), duration=0.8, **rest_to_rest({"hinge": -1.0}, {"hinge": 1.0}), accuracy=None,
        inputs={"voltage_hinge": (3.0,)}, transcription=Transcription(degree=5, intervals=8),
    )  # fmt: skip
    half = Transcription(degree=5, intervals=4)
    first = replace(whole, duration=(0.1, 0.6), end=Conditions(), transcription=half, bounds=Bounds(
        expressions={"T": (0.4, 0.4)}))  # fmt: skip
    second = replace(first, start=Conditions(), end=whole.end)
    found, one = solve_joined(JoinedProblem((first, second), (Link(),))), solve(whole)
    assert found.ok and found.cost == pytest.approx(one.cost, rel=1e-8)
    middle = one.sample(np.array([0.4]))
    assert found.parts[1].arrays["x"][0] == pytest.approx(middle.x[0], abs=1e-7)
    assert found.parts[1].arrays["y"][0] == pytest.approx(middle.y[0], abs=1e-7)


def test_phases_that_do_not_fit_are_not_confirmed() -> None:
    found = solve_joined(JoinedProblem((THERE, BACK), (Link({"slide": 0.5}),)))
    later = found.parts[1]
    faster = {**later.arrays, "y_1": later.arrays["y_1"] * 1.001}
    bad = linked(replace(found, parts=(found.parts[0], replace(later, arrays=faster))))
    assert not bad.ok and "phases 1 and 2 do not fit" in bad.status
    weaker = {**later.arrays, "u": 1.001 * later.arrays["u"]}
    bad = linked(replace(found, parts=(found.parts[0], replace(later, arrays=weaker))))
    assert not bad.ok and "replayed from phase to phase it ends" in bad.status


@pytest.mark.slow
def test_a_phase_that_would_change_its_branch_is_refused() -> None:
    """The tool of the five-bar below its elbows: no motion of these coordinates leads there."""
    home = Conditions(coordinates={"base_left": 0.0, "base_right": 0.0}, at_rest=True)
    first = TrajectoryProblem(
        SHORT_FIVE_BAR, duration=0.6, start=home, end=Conditions(coordinates={"base_left": 0.1, "base_right": 0.1}),
        transcription=Transcription(intervals=8), independent=("base_left", "base_right"),
    )  # fmt: skip
    below = replace(home, points={"tool": (None, None, 0.2 - math.sqrt(13) / 20)})
    found = solve_joined(JoinedProblem((first, replace(first, start=Conditions(), end=below)), (Link(),)))
    assert not found.ok and "phase 2: impossible: the plan leaves its assembly mode" in found.status


# -- files -------------------------------------------------------------------------------------------------------

MECHANISM = """
[mechanism]
name = "bead"
[parameters.m]
value = 1
unit = "kg"
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
"""
HEAD = """
[problem]
mechanism = "bead.toml"
duration = 1
[start]
coordinates = { x = 0, z = 0 }
at_rest = true
[end]
coordinates = { x = 0.1, z = 0.2 }
at_rest = true
[bounds]
speeds = { x = 9 }
[transcription]
intervals = 2
"""


def read(folder: Path, text: str) -> JoinedProblem:
    (folder / "bead.toml").write_text(MECHANISM)
    return parse_joined(HEAD + text, folder=folder)


def test_every_key_of_a_part_counts(tmp_path: Path) -> None:
    """It changes its own part and no other one."""
    for kind, keys in problem_keys.PARTS.items():
        usual = read(tmp_path, f"[[{kind}]]\n[[{kind}]]\n")
        for name, key in keys.items():
            found = read(tmp_path, f"[[{kind}]]\n{key.example}\n[[{kind}]]\n")
            assert found.parts[1] == usual.parts[1], name
            assert (found.parts[0], found.links) != (usual.parts[0], usual.links), name
    added = read(tmp_path, "[[phases]]\nbounds = { speeds = { z = 2 }, joints = { x = 1 } }\n[[phases]]\n").parts[0]
    assert added.bounds == Bounds(joints={"x": (-1, 1)}, speeds={"x": (-9, 9), "z": (-2, 2)})
    several = read(tmp_path, "[[phases]]\n[[phases]]\n").parts
    assert [p.start.is_empty for p in several] == [False, True] and [p.end.is_empty for p in several] == [True, False]


@pytest.mark.parametrize(
    "text, said",
    [
        ("[[phases]]\n", "at least two tables"),
        ("[[phases]]\n[[phases]]\n[[cases]]\n[[cases]]\n", "got phases and cases"),
        ("[[phases]]\n[[phases]]\nimpact = { x = 0 }\n", "at the end of a phase that another one follows"),
        ("[[phases]]\nimpact = { x = 2 }\n[[phases]]\n", "restitution from 0 to 1"),
        ("[[phases]]\nstart = { at_rest = true }\n[[phases]]\n", "start"),
        ("[[phases]]\ncatches = 1\n[[phases]]\n", "true or false"),
        ("[[phases]]\nend = 3\n[[phases]]\n", r"phases\[0\].end: expected a table"),
        ("[[phases]]\nbounds = { sped = 3 }\n[[phases]]\n", "sped"),
        ("[[phases]]\nweight = -1\n[[phases]]\n", "weight: expected a number from 0"),
        ("[[via]]\ntime = 0.5\n[[phases]]\n[[phases]]\n", "belongs to one of them"),
        ("[[cases]]\nimpact = { x = 0 }\n[[cases]]\n", "impact"),
    ],
)
def test_parts_that_make_no_sense_are_refused(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(DescriptionError, match=said):
        read(tmp_path, text)
    with pytest.raises(DescriptionError, match="load_problem_file"):
        parse_problem(HEAD + "[[phases]]\n[[phases]]\n", folder=tmp_path)


def test_links_that_name_nothing_are_refused() -> None:
    with pytest.raises(DescriptionError, match="unknown freedom 'slid'"):
        solve_joined(JoinedProblem((THERE, BACK), (Link({"slid": 0.0}),)))
    with pytest.raises(DescriptionError, match="it starts where phase 1 ends"):
        JoinedProblem((THERE, replace(BACK, start=THERE.start)), (Link(),))
    with pytest.raises(DescriptionError, match="same mechanism"):
        JoinedProblem((THERE, replace(BACK, mechanism=pendulum())), (Link(),))


def test_the_command_writes_phases(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "bead.toml").write_text(MECHANISM)
    problem, table, whole = (tmp_path / name for name in ("problem.toml", "plan.csv", "plan.npz"))
    problem.write_text(HEAD + "[[phases]]\nend = { coordinates = { x = 0.3 } }\nimpact = { x = 0.5 }\n[[phases]]\n")
    assert isinstance(load_problem_file(problem), JoinedProblem)
    assert main(["optimise", str(problem), "--out", str(table), "--rate", "10"]) == 0
    rates = re.search(r"then rates become others: x (\S+) to (\S+) m/s, z ", capsys.readouterr().out)
    assert rates is not None and float(rates[2]) == pytest.approx(-0.5 * float(rates[1]), rel=1e-5)
    with table.open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 22 and float(rows[-1]["t"]) == 2.0 and float(rows[10]["s_x"]) == pytest.approx(0.3)
    assert float(rows[11]["s_dot_x"]) == pytest.approx(-0.5 * float(rows[10]["s_dot_x"]), abs=1e-9)
    assert main(["optimise", str(problem), "--out", str(whole), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["ok"] and [p["part"] for p in said["parts"]] == ["phase 1", "phase 2"] and said["end_error"] < 1e-9
    with np.load(whole) as file:
        assert file["part2_q"][0] == pytest.approx(file["part1_q"][-1], abs=1e-9) and file["starts"].tolist() == [0, 1]
        assert file["link1_behind"][0] == pytest.approx(-0.5 * file["link1_before"][0], abs=1e-9)
    problem.write_text(HEAD + "[[cases]]\n[[cases]]\n")
    assert main(["optimise", str(problem), "--out", str(table)]) == 2
    assert "expected .npz" in capsys.readouterr().err
    assert main(["optimise", str(problem), "--out", str(whole), "--starts", "3"]) == 2
    assert "--starts" in capsys.readouterr().err
    problem.write_text(
        HEAD.replace("x = 9", "x = 0.01") + "[[phases]]\n[[phases]]\nend = { coordinates = { x = 9 } }\n"
    )
    assert main(["optimise", str(problem), "--out", str(whole)]) == 1
    assert "no motions to be relied on" in capsys.readouterr().out
    assert math.isclose(float(np.load(whole)["ok"]), 0.0)
