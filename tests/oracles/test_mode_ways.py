"""Which modes are reached without a singularity: witnesses are walked again by equations that are typed here."""

from __future__ import annotations

import json
from itertools import pairwise

import numpy as np
import pytest

import symscrew
from oracles.test_mode_connections import platform
from symscrew.assembly import AssemblyMode, Connection, follow_mode, mode_ways, reachable_modes
from symscrew.cli.parser import main

pytestmark = pytest.mark.slow

FEET = np.array([[0.0, 0.0], [15.91, 0.0], [0.0, 10.0]])
LEGS = np.array([14.98, 15.38, 12.0])


class Circles:
    """A platform whose corners lie on three circles, in doubles: x, y and angle against where it rests."""

    def __init__(self, mechanism: symscrew.Mechanism) -> None:
        tips = [mechanism.joints[f"B{k}"].point for k in range(3)]
        self.tips = np.array([[float(mechanism.number(c)) for c in p[:2]] for p in tips])

    def at(self, pose, legs):
        c, s = np.cos(pose[2]), np.sin(pose[2])
        way = pose[:2] + self.tips @ np.array([[c, s], [-s, c]]) - FEET
        turned = self.tips @ np.array([[-s, c], [-c, -s]])
        return ((way**2).sum(axis=1) - legs**2) / 2, np.column_stack([way, (way * turned).sum(axis=1)])

    def walked(self, pose, way: list[np.ndarray]) -> tuple[np.ndarray, set[float]]:
        """Where short steps of Newton's method lead along straight pieces, and the signs of the determinant."""
        signs = set()
        for one, two in pairwise(way):
            at, step = 0.0, 0.25
            while at < 1.0:
                legs, there = one + min(1.0, at + step) * (two - one), pose
                for _ in range(6):
                    left, slopes = self.at(there, legs)
                    there = there - np.linalg.solve(slopes, left)
                if np.abs(there - pose).max() > 0.1 or np.abs(self.at(there, legs)[0]).max() > 1e-9:
                    step /= 2
                    assert step > 1e-6
                    continue
                pose, at, step = there, at + step, 2 * step
                signs.add(float(np.sign(np.linalg.det(slopes))))
        return pose, signs


def pose_of(mode: AssemblyMode) -> np.ndarray:
    return np.array([*mode.translation[:2], np.arctan2(mode.rotation[1, 0], mode.rotation[0, 0])])


def walk(circles: Circles, found: symscrew.assembly.AssemblyModes, way: Connection) -> None:
    legs = [LEGS + np.array(list(corner.values())) for corner in way.way]
    end, signs = circles.walked(pose_of(found.mode(way.one)), legs)
    goal = pose_of(found.mode(way.two))
    assert len(signs) == 1 and np.abs(end[:2] - goal[:2]).max() < 1e-8 and abs(np.sin((end[2] - goal[2]) / 2)) < 1e-9


@pytest.mark.slow
def test_a_planar_platform_has_two_pieces_of_three_modes_and_its_witnesses_stay_regular():
    """C. Innocenti, V. Parenti-Castelli 1992: three modes of each sign, each reached from each other of its sign."""
    mechanism = platform()
    found = symscrew.assembly_modes(mechanism)
    ways = reachable_modes(found)
    assert len(ways) == 15
    assert all((c.judgement == "connected") == ((c.one[0] == "-") == (c.two[0] == "-")) for c in ways)
    circles = Circles(mechanism)
    connected = [way for way in ways if way.judgement == "connected"]
    assert all(way.judgement == "separated" and not way.way for way in ways if way not in connected)
    for way in connected:
        if way.one in ("home", "-1"):  # the others go by way of these
            walk(circles, found, way)
    led = follow_mode(found, "home", dict(connected[0].way[1]))
    assert led.reached == 1.0  # a piece of the way in integers, too


def test_modes_of_opposite_sign_are_apart_and_json_says_so(capsys):
    assert main(["assemble", "four_bar", "--json"]) == 0
    values = json.loads(capsys.readouterr().out)
    assert [m["reachable"] for m in values["modes"]] == [{"-1": "separated"}, {"home": "separated"}]
    assert values["ways"] == []
    assert main(["assemble", "four_bar"]) == 0
    assert "home: a singularity on every way to -1" in capsys.readouterr().out


def test_what_was_not_looked_for_and_what_cannot_be_proved_is_not_called_reached(monkeypatch):
    found = symscrew.assembly_modes(symscrew.load_catalogue("four_bar"))
    one, two = found.modes
    monkeypatch.setattr(mode_ways, "_apart", lambda *_: False)
    assert [c.judgement for c in reachable_modes(found, search=False)] == ["not found"]
    # a way that goes nowhere, and one that ends in another mode than it says
    still = np.zeros((3, len(one.q)))
    monkeypatch.setattr(mode_ways, "regular_ways", lambda *_: {(0, 1): still})
    monkeypatch.setattr(mode_ways, "_compiled", lambda *_: None)
    proofs = mode_ways._Proofs(found, lambda _: None)
    assert proofs._proved(one, two, still) is None
    assert proofs._proved(one, one, still) is not None
    assert [c.judgement for c in reachable_modes(found)] == ["not found"]
