"""Components of the configuration space of four-bar loops: published cases, and motion by exponentials."""

from __future__ import annotations

import json

import numpy as np
import pytest
import sympy
from support.analysed import analysed
from support.further_mechanisms import CASES
from support.reference_mechanisms import ENTRIES, build

from symscrew.cli.parser import main
from symscrew.description.mechanism import Mechanism
from symscrew.mobility import Components, components_of
from symscrew.mobility.joint_network import network_of
from symscrew.mobility.motions.coordinate_lines import Setting, track
from symscrew.mobility.motions.held_spins import HeldSpins

pytestmark = pytest.mark.slow


def mechanism(name: str) -> Mechanism:
    return build(ENTRIES[name]) if name in ENTRIES else CASES[name].make()


def components(name: str) -> Components:
    found = components_of(mechanism(name), network_of(mechanism(name)))
    assert isinstance(found, Components)
    return found


@pytest.mark.parametrize(
    "name, degrees",
    [
        ("planar_4bar", [(2, 2)]),  # general: one curve of genus 1 (Hunt 1978)
        ("spherical_4r", [(2, 2)]),
        ("parallelogram", [(1, 1), (1, 1)]),  # parallelogram and antiparallelogram (Hunt 1978, ch. 12)
        ("parallelogram-change_point", [(1, 1), (1, 1)]),
        ("rhombus, folded", [(0, 1), (1, 0), (1, 1)]),  # a rhombus has three: translation, and two folded ones
        ("rhombus, two branches", [(0, 1), (1, 0), (1, 1)]),
        ("kite, collinear", [(1, 0), (1, 2)]),  # a kite folds onto itself and turns there (Burmester 1888)
    ],
)
def test_published_components(name: str, degrees: list[tuple[int, int]]) -> None:
    found = components(name)
    assert sorted(c.degrees for c in found.curves) == degrees
    assert [sum(c.degrees[k] * c.multiplicity for c in found.curves) for k in (0, 1)] == [2, 2]
    rows = analysed(name).branches
    assert rows is not None
    through = [c for c in found.curves if c.through]
    assert len(through) == len(rows.rows)  # every branch through the reference is on a component of its own


@pytest.mark.parametrize("name, factors", [("planar_4bar", 1), ("parallelogram", 1), ("spherical_4r", 1)])
def test_motion_by_exponentials_stays_on_one_component(name: str, factors: int) -> None:
    network = network_of(mechanism(name))
    setting = Setting(network, HeldSpins(network, network.bodies[-1]), 1, network.bodies[-1], 0, (), {})
    found = components(name)
    first, last = (network.edges[h] for h in found.hinges)
    poses = track(setting, first.start, (), 1).poses[1:12]
    t, s = sympy.symbols("t s", real=True)
    equations = [sympy.lambdify((t, s), sympy.sympify(c.equation.split(" = ")[0], {"t": t, "s": s}))
                 for c in found.curves if "=" in c.equation]  # fmt: skip
    from symscrew.mobility.symbols import exact_system

    screws = exact_system(mechanism(name)).screws
    lengths = [float(sum(c * c for c in screws[h][0][:3])) ** 0.5 for h in found.hinges]
    best = []
    for signs in ((1, 1), (1, -1), (-1, 1), (-1, -1)):  # the sense of a hinge is its own affair
        values = [
            [abs(e(*(np.tan(sign * pose.q[edge.start] / 2) / size for sign, edge, size in
                     zip(signs, (first, last), lengths, strict=True)))) for e in equations]
            for pose in poses
        ]  # fmt: skip
        best.append(sum(1 for k in range(len(equations)) if max(v[k] for v in values) < 1e-7))
    assert max(best) == factors


def test_what_is_not_decided_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("bennett", "sarrus", "slider_crank"):
        text = components_of(mechanism(name), network_of(mechanism(name)))
        assert isinstance(text, str) and text.startswith("not decided")
    assert main(["mobility", "four_bar", "--components", "--json"]) == 0
    values = json.loads(capsys.readouterr().out)["components"]
    assert values["decided"] and [c["degrees"] for c in values["components"]] == [[2, 2]]
