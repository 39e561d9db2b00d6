"""Certified ways between assembly modes: against publications, walked again by equations that are typed here, refused
where a number is changed.

P. Wenger, Uniqueness domains and regions of feasible paths for cuspidal manipulators, IEEE Trans. Robotics 20, 2004;
P. Wenger, Cuspidal and noncuspidal robot manipulators, Robotica 25, 2007.
"""

from __future__ import annotations

import copy
import json
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.mobility import Connections, analyse_mobility, check_ways, connection_lines, judged_connections
from symscrew.mobility.proofs import described, digest, proof_checker, way_checker, way_proofs
from symscrew.mobility.proofs.proof_checker import RefusedError, UnreadableError

Array = np.ndarray[Any, Any]


def arm(points: Sequence[Any], axes: Sequence[Any], tip: Sequence[float]) -> Mechanism:
    """Three hinges to a hand whose point is held by a ball at a place that is driven: inverse kinematics as modes."""
    builder = MechanismBuilder("arm", platform="hand")
    for name in ("one", "two", "hand", "x", "y", "z"):
        builder.body(name)
    for k, (parent, child) in enumerate((("base", "one"), ("one", "two"), ("two", "hand"))):
        builder.joint(f"R{k + 1}", "R", parent=parent, child=child, point=points[k], axes=[axes[k]])
    for name, parent, axis in (("x", "base", [1, 0, 0]), ("y", "x", [0, 1, 0]), ("z", "y", [0, 0, 1])):
        builder.joint(f"P{name}", "P", parent=parent, child=name, point=[0, 0, 0], axes=[axis], driven=True)
    builder.joint("S", "S", parent="z", child="hand", point=tip)
    return builder.build()


def orthogonal(third: tuple[float, float]) -> Mechanism:
    """Wenger's arm d2 = 1, d3 = 2, d4 = 3/2, r2 = 1, r3 = 0, axes at right angles, with its second hinge at 180 deg."""
    c, s = third
    tip = [1 - 2 - 1.5 * c, 1 + 1.5 * s, 0]
    return arm([[0, 0, 0], [1, 1, 0], [-1, 1, 0]], [[0, 0, 1], [0, 1, 0], [0, 0, -1]], tip)


def tip_and_factor(turned: Array, third: float) -> tuple[Array, Array]:
    """Forward kinematics and det J / d4 by the published form, angles from the frames' x axes in line."""
    one, two, three = turned[:, 0], np.pi + turned[:, 1], third + turned[:, 2]
    reach = 2 + 1.5 * np.cos(three)
    x, y, z = 1 + np.cos(two) * reach, 1 + 1.5 * np.sin(three), -np.sin(two) * reach
    tip = np.column_stack([np.cos(one) * x - np.sin(one) * y, np.sin(one) * x + np.cos(one) * y, z])
    return tip, reach * (np.sin(three) + np.cos(two) * (2 * np.sin(three) - np.cos(three)))


def proof_of(mechanism: Mechanism, drives: Sequence[int] = ()) -> tuple[Connections, dict[str, Any]]:
    """The modes with their ways, and a proof file's part of it."""
    mobility = analyse_mobility(mechanism)
    found = judged_connections(mobility, drives)
    assert isinstance(found, Connections)
    values = described(mechanism, mobility.network, mobility.platform.body).values
    return found, {"mechanism": values, "digest": digest(values), "ways": found.evidence.entry}


@pytest.fixture(scope="module")
def cuspidal() -> tuple[Connections, str]:
    found, values = proof_of(orthogonal((-0.8, 0.6)))
    return found, json.dumps(values)


@pytest.mark.slow
def test_a_cuspidal_arm_changes_its_posture_without_a_singularity(cuspidal: tuple[Connections, str]) -> None:
    """Four postures, two in each of two aspects: Wenger 2004, fig. 2."""
    found, values = cuspidal[0], json.loads(cuspidal[1])
    signs = [mode.sign for mode in found.found.modes]
    assert sorted(signs) == [-1, -1, 1, 1]
    expected = [("connected" if sign == signs[0] else "separated", "certified", "") for sign in signs]
    assert [found.judgement(k) for k in (1, 2, 3)] == expected[1:]
    verdict = check_ways(values)
    assert verdict.holds and len(verdict.proved) == 3 and not verdict.not_proved
    (way,) = (claim["way"] for claim in values["ways"]["claims"] if claim["kind"] == "connected")
    order = [joint["name"] for joint in values["mechanism"]["joints"]]
    points = [dict(zip(order, point, strict=True)) for point in way["points"]]
    turned = np.array([[2 * np.arctan2(p[name][1], p[name][0]) for name in ("R1", "R2", "R3")] for p in points])
    (axis,) = (j["motions"][0]["axis"] for j in values["mechanism"]["joints"] if j["name"] == "R3")
    turned[:, 2] *= -int(axis[2])  # its axis points down, and may be written the other way round
    tip, factor = tip_and_factor(turned, np.arctan2(0.6, -0.8))
    moved = np.array([[2 * p[f"P{name}"][1] / p[f"P{name}"][0] for name in "xyz"] for p in points])
    assert np.abs(tip - tip[-1] - (moved - moved[-1])).max() < 1e-9
    assert np.abs(np.diff(turned, axis=0)).max() < 1 and (np.sign(factor) == np.sign(factor[0])).all()
    assert np.abs(moved[-1]).max() == 0 and np.abs(np.sin(turned[-1] / 2)).max() > 0.1  # another posture


@pytest.mark.slow
def test_a_changed_way_is_refused(cuspidal: tuple[Connections, str]) -> None:
    values = json.loads(cuspidal[1])
    k = next(k for k, claim in enumerate(values["ways"]["claims"]) if claim["kind"] == "connected")
    values["ways"]["claims"] = [values["ways"]["claims"][k]]
    one, two = values["ways"]["claims"][0]["modes"]

    def refused(change: Any, words: str) -> None:
        other = copy.deepcopy(values)
        change(other["ways"])
        verdict = check_ways(other)
        assert not verdict.proved and words in verdict.refused[0], verdict

    def way(entry: Any) -> Any:
        return entry["claims"][0]["way"]

    def dropped(entry: Any) -> None:
        for _ in range(4):
            del way(entry)["points"][0], way(entry)["radii"][0]

    refused(lambda e: way(e)["points"][2][0].__setitem__(1, way(e)["points"][2][0][1] + (1 << 40)), "leaves")
    refused(lambda e: way(e)["radii"].__setitem__(2, way(e)["radii"][2] >> 12), "leaves")
    refused(dropped, "leaves")
    refused(lambda e: way(e)["points"].pop(), "ends elsewhere")
    refused(lambda e: way(e)["radii"].pop(), "ends elsewhere" if len(way(values["ways"])["points"]) < 2 else "pieces")
    refused(lambda e: e["claims"][0].update(kind="separated"), "opposite signs")
    refused(lambda e: e["claims"][0].update(modes=[one, one]), "may be one")
    refused(lambda e: e["modes"][two].update(point=way(e)["points"][5]), "ends elsewhere")
    refused(lambda e: e["drives"].pop(), "conditions")
    refused(lambda e: e["groups"].__setitem__(0, [["0", "0", "1", "0", "0", "0"]]), "outside of the group")
    for change in (
        lambda e: e.update(format="1"),
        lambda e: way(e)["points"][0][0].append(1),
        lambda e: e.pop("modes"),
    ):
        other = copy.deepcopy(values)
        change(other["ways"])
        with pytest.raises(UnreadableError):
            check_ways(other)


@pytest.mark.slow
def test_postures_of_an_elbow_arm_are_not_called_connected() -> None:
    """First axes through one point, last parallel: not cuspidal; shoulder and elbow are told by a factor each."""
    found, values = proof_of(arm([[0, 0, 0], [0, 0, 0], [1, 0, 0]], [[0, 0, 1], [0, 1, 0], [0, 1, 0]], [1.6, 0, 0.8]))
    between = [found.judgement(k)[0] for k in range(1, len(found.found.modes))]
    assert sorted(map(str, between)) == ["None", "separated", "separated"]
    assert check_ways(values).not_proved and any("not decided: no way" in line for line in connection_lines(found))


def folding() -> Mechanism:
    """Two hinges in a plane, of links 1 and 1, to a point that is driven: elbow up or down."""
    builder = MechanismBuilder("folding", platform="hand")
    for name in ("one", "hand", "x", "y"):
        builder.body(name)
    builder.joint("A", "R", parent="base", child="one", point=[0, 0, 0], axes=[[0, 0, 1]])
    builder.joint("B", "R", parent="one", child="hand", point=[0.8, 0.6, 0], axes=[[0, 0, 1]])
    builder.joint("X", "P", parent="base", child="x", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    builder.joint("Y", "P", parent="x", child="y", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    builder.joint("C", "R", parent="y", child="hand", point=[1.6, 0, 0], axes=[[0, 0, 1]])
    return builder.build()


def test_no_tubes_lead_through_a_singularity(monkeypatch: pytest.MonkeyPatch) -> None:
    """The elbow stretched and folded over: closed all along, typed here, and singular half-way."""
    mechanism = folding()
    found, values = proof_of(mechanism)
    assert [found.judgement(1)] == [("separated", "certified", "")] and check_ways(values).holds
    network, start = found.network, np.arctan2(0.6, 0.8)
    place = {name: network.edges[name].start for name in "ABCXY"}
    size = float(network.length)

    def at(elbow: float) -> Array:
        """The elbow's angle, from 1 in the reference to -1; the shoulder stays."""
        q = np.zeros(5)
        q[place["B"]] = q[place["C"]] = 2 * start * (1 - elbow)
        x, y = (f(start) + f(start - 2 * start * elbow) for f in (np.cos, np.sin))
        q[place["X"]], q[place["Y"]] = (x - 1.6) / size, y / size
        return q

    numbers = described(mechanism, network, "hand")
    monkeypatch.setattr(way_proofs, "MOST_PIECES", 60)
    proposed = way_proofs._Proposed(numbers, network, values["ways"])
    regular = proposed.way(proposed.point(at(1.0)), [at(c) for c in (0.9, 0.7, 0.5)])
    assert 3 < len(regular["radii"]) < 60
    with pytest.raises(RefusedError, match="too many pieces"):
        proposed.way(proposed.point(at(1.0)), [at(c) for c in np.linspace(0.9, -0.5, 8)])


def test_the_determinants_sign_is_told_where_a_loop_ends_upside_down() -> None:
    """A whole turn of a hinge changes the sign of a dual quaternion, and of nothing else."""
    found, values = proof_of(folding())
    other = copy.deepcopy(values)
    for mode in other["ways"]["modes"]:
        mode["point"][0] = [-c for c in mode["point"][0]]
    assert check_ways(other).proved == check_ways(values).proved != ()
    tubes = way_checker.Ways(proof_checker.Mechanism(values["mechanism"]), other["ways"])
    assert tubes.sign(0) * tubes.sign(1) == -1 == found.found.modes[0].sign * found.found.modes[1].sign


def test_what_no_tube_can_certify_is_sampled_with_the_reason() -> None:
    """More drives than freedoms, couplings, screw joints."""
    mobility = analyse_mobility(catalogue.load("differential"))
    found = judged_connections(mobility)
    assert isinstance(found, str) or all(found.judgement(k)[1] == "sampled" for k in range(1, len(found.found.modes)))
    folded = analyse_mobility(folding(), at={"A": "0.1", "B": "0.1"})
    found = judged_connections(folded)
    assert isinstance(found, Connections) and found.judgement(1)[1:] == (
        "sampled",
        "the displaced configuration has no exact coordinates",
    )
    assert "sampled (the displaced configuration" in connection_lines(found)[2]


def test_the_command_writes_ways_that_the_checkers_judge_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "proof.json"
    assert main(["mobility", "four_bar", "--connections", "--proof", str(file)]) == 0
    said = capsys.readouterr()
    assert (
        "a singularity on every way from the reference, certified" in said.out
        and "claims proved, 0 refused" in said.err
    )
    for module in (proof_checker, way_checker):
        (tmp_path / Path(module.__file__).name).write_text(Path(module.__file__).read_text())
    for name, line in (("way", "proved: with A driven, modes 1 and 2: a singularity on every way"),
                       ("proof", "way_checker.py judges them")):  # fmt: skip
        done = subprocess.run(
            [sys.executable, "-S", str(tmp_path / f"{name}_checker.py"), str(file)], capture_output=True, text=True
        )
        assert done.returncode == 0 and line in done.stdout, done.stderr
    values = json.loads(file.read_text())
    values["ways"]["modes"][1]["point"][1][1] += 1 << 45
    file.write_text(json.dumps(values))
    assert way_checker.main([str(file)]) == 1 and way_checker.main([str(tmp_path)]) == 2 and way_checker.main([]) == 2
