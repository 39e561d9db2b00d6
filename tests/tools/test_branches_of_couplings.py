"""Branches of C that gears, loops that say a thing twice, and mechanisms without a freedom have: all are taken."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from symscrew import Mechanism, MechanismBuilder, catalogue
from symscrew.export import PRECISIONS, print_c, print_rust
from symscrew.model import Model, derive
from symscrew.program import evaluate, second_path
from symscrew.verification.embedded.branch_coverage import Coverage, covered

NEEDED = pytest.mark.skipif(any(shutil.which(tool) is None for tool in ("gcc", "gcov")), reason="needs gcc and gcov")


def shafts(*couplings: dict[str, object]) -> Mechanism:
    """Two shafts with an arm on the second, tied by couplings."""
    builder = MechanismBuilder("shafts")
    builder.body("a", mass=1, com=[0, 0, 0], inertia=["0.02", "0.02", "0.03"])
    builder.body("b", mass=2, com=["0.5", "0.1", 0], inertia=["0.01", "0.04", "0.05"])
    builder.joint("A", "R", parent="base", child="a", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True, reference=["0.2"])
    builder.joint("B", "R", parent="base", child="b", point=["0.4", 0, 0], axes=[[0, 1, 0]], reference=["0.3"])
    for k, terms in enumerate(couplings):
        builder.coupling(f"tie_{k}", terms=terms)
    return builder.build()


def triangle(width: float, height: float) -> Mechanism:
    """Three bars that hold each other, in a plane: no freedom."""
    builder = MechanismBuilder("triangle", platform="left")
    for body, x in (("left", 0), ("right", width)):
        builder.body(body, mass=1, com=[x, 0, height / 2], inertia=["0.01", "0.02", "0.03"])
    bars = (("A", "base", "left", [0, 0, 0]), ("B", "left", "right", [0, 0, height]))
    for name, parent, child, point in (*bars, ("C", "base", "right", [width, 0, 0])):
        builder.joint(name, "R", parent=parent, child=child, point=point, axes=[[0, 1, 0]])
    return builder.build()


def coverage(found: Model, folder: Path, precision: str, *names: str) -> Coverage:
    real, chosen = PRECISIONS[precision], found.only(list(names))
    for file, text in print_c(chosen, precision=real, batches=False, lanes=False).items():
        (folder / file).write_text(text)
    return covered(chosen, folder, real)


MADE = {
    "gears": (
        lambda: catalogue.load("gear_train"),
        "double",
    ),  # the first path has no pivots: nothing leads to the second
    "differential": (lambda: catalogue.load("differential"), "single"),
    "twice": (lambda: shafts({"A": 1, "B": "0.5"}, {"A": 2, "B": 1}), "double"),
    "curve": (lambda: shafts({"A": 1, "B": ["0.5", "0.3", "-0.2"]}), "single"),
}


@NEEDED
@pytest.mark.parametrize("name", MADE)
def test_every_branch_of_forward_dynamics_is_taken(name: str, tmp_path: Path) -> None:
    make, precision = MADE[name]
    found = coverage(derive(make()), tmp_path, precision, "forward_dynamics", "forward_dynamics_reactions")
    assert [entry for entry in found.untaken if entry.how == "nothing"] == [] and found.branches["lines"] == 100
    for run in found.runs.values():
        for part in (run, run["forced"]):
            assert part["not_finite"] == 0 and part["given_on_failure"] == 0


@NEEDED
@pytest.mark.parametrize(("width", "height", "how"), [(0.1, 3.0, []), (1.0, 1.0, ["forced"])])
def test_a_step_too_large_where_the_loops_are_closed(
    width: float, height: float, how: list[str], tmp_path: Path
) -> None:
    """Slender, a guess off by the tolerance does it; square, none does, for steps are no larger than openings."""
    found = coverage(derive(triangle(width, height)), tmp_path, "single", "assemble")
    assert found.branches["nothing"] == 0
    assert [entry.how for entry in found.untaken if "change[0]" in entry.line] == how


def test_reactions_that_no_multiplier_changes_have_no_internal_loads() -> None:
    """Gears act about axes, where nothing else closes a loop: what looks for internal loads is left out."""
    for name, matter in (("differential", False), ("four_bar", True)):
        model = derive(catalogue.load(name)).only(["forward_dynamics_reactions"])
        program = model.programs["forward_dynamics_reactions"]
        assert program.loads_matter is matter
        c, rust = print_c(model)[f"{name}.c"], print_rust(model)[f"{name}.rs"]
        assert ("internal_load(" in c) is matter and ("internal_load::<M>(" in rust) is matter


def test_the_second_path_through_gears_gives_the_reactions_of_the_first() -> None:
    model = derive(catalogue.load("differential"))
    program = model.programs["forward_dynamics_reactions"]
    inputs = [np.atleast_2d(x)[0] for x in model.test_inputs["forward_dynamics_reactions"]]
    mass, force, jacobian, bias = evaluate(program.dense, inputs)[0]
    found, status = second_path(
        mass, force, jacobian, bias, rates=program.rates, rows=program.rows, regular=program.regular, tolerance=1e-9,
        reactions=lambda a, m: evaluate(program.wrenches, [*inputs, a, m])[0],
    )  # fmt: skip
    assert status == -1
    for value, expected in zip(found, evaluate(program, inputs)[0], strict=True):
        assert np.abs(value - expected).max() < 1e-12 * max(1.0, np.abs(expected).max())
