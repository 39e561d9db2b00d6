"""A joint type, an effect, a target, a pass, a closed form and a study are each added by a file and a line, or less.

They are put into a copy of the package, which another process then uses: nothing else of it is edited.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from support.magnetic_brake import MAGNETIC_BRAKE

import symscrew

pytestmark = pytest.mark.slow

PACKAGE = Path(symscrew.__file__).parent

TARGET = '''
"""Target "counts": operations of every function."""


def files(order):
    """<name>_counts.csv."""
    rows = [f"{name},{p.operations['total']}" for name, p in order.model.programs.items()]
    return {f"{order.model.name}_counts.csv": "\\n".join(["function,operations", *rows, ""])}
'''

PASS = '''
"""|x| as the root of x x: not what one wants, but easy to see."""

from symscrew.algebra import needed, substitute


def roots_of_squares(roots):
    """Absolute values by roots."""
    found = {node: node.tape.sqrt(node.args[0] * node.args[0]) for node in needed(roots) if node.op == "abs"}
    return substitute(roots[0].tape, roots, found)
'''

CLOSED_FORM = '''
"""Closed form of a limb of three sliders at right angles (P-P-P): each slide is a component of the tip's place."""

from dataclasses import dataclass
from typing import Any

from symscrew.algebra import dot, subtract
from symscrew.kinematics import Cut, Link
from symscrew.loops.limbs.limb_form import LimbForm


@dataclass(frozen=True)
class SliderLimb(LimbForm):
    """A limb ground - P - P - P - tip: its links, where its tip is at no slide, and along what it slides."""

    cut: Cut
    sliders: tuple[Link, ...]
    start: Any
    directions: Any

    @property
    def links(self):
        """All three."""
        return self.sliders

    def solve(self, system, target, guess):
        """No angles; every slide."""
        moved = subtract(target, self.start)
        return {}, {link.q.start: system.tape.node(dot(u, moved)) for link, u in zip(self.links, self.directions)}


def slider_limb(system, cut):
    """The cut joint's limb if it is one, else None."""
    path = system.tree.path(cut.tip)
    links = tuple(system.tree.links[i] for i in reversed(path))
    if len(links) != 3 or not all(link.motion.prismatic for link in links):
        return None
    tape = system.tape
    tips = []
    for moving in (None, *links):
        q = [tape.one if moving and k == moving.q.start else tape.zero for k in range(len(system.tree.q))]
        tips.append(system.structure.linkage(q).carry_point(cut.tip, links[0].parent, cut.tip_point))
    directions = tuple(system.structure.geometry.settle(subtract(tip, tips[0])) for tip in tips[1:])
    for i in range(3):
        for j in range(i):
            if tape.settle(dot(directions[i], directions[j])) is not tape.zero:
                return None
    return SliderLimb(cut, links, tips[0], directions)
'''

STUDY = '''
"""The operations of every function: a study with nothing to measure."""

from symscrew.studies.accuracy.measuring import Point, Study
from symscrew.studies.timing import quartiles


def study(subject, progress, *, repeats, seconds):
    """A point a function."""
    points = tuple(
        Point(name, "", 0.0, quartiles([1.0]), "", {"operations": p.operations["total"]})
        for name, p in subject.model.programs.items()
    )
    labels = {"error_label": "error", "cost_label": "time", "cost_unit": "s"}
    return Study("counting", "Counting", points, **labels, reference="none", reference_error=0.0)
'''

ADDED = {
    "joint type": {
        "description/joints.py": (
            '    "fixed": JointType(',
            '    "T": JointType("T", "table", 2, (translation(0), translation(1))),',
        )
    },
    "effect": {"effects/magnetic_brake.py": MAGNETIC_BRAKE},
    "target": {
        "generation/counts_target.py": TARGET,
        "generation/targets.py": ('    "c": Target(', '    "counts": Target(f"{ROOM}.counts_target", "counts"),'),
    },
    "pass": {
        "program/passes/roots.py": PASS,
        "program/passes/in_order.py": (
            "    shared_reciprocals,  # first",
            "    roots_of_squares,",
            "from symscrew.program.passes.reciprocals import",
            "from symscrew.program.passes.roots import roots_of_squares",
        ),
    },
    "closed form": {
        "loops/limbs/slider_limbs.py": CLOSED_FORM,
        "loops/limbs/closed_forms.py": (
            "    spoke_limb,",
            "    slider_limb,",
            "from symscrew.loops.limbs.spoke_limbs import",
            "from symscrew.loops.limbs.slider_limbs import slider_limb",
        ),
    },
    "study": {
        "studies/accuracy/counting_study.py": STUDY,
        "studies/accuracy/every_study.py": (
            '    "kinematics": StudyFile(',
            '    "counting": StudyFile("counting_study", "mechanism"),',
        ),
    },
}

USE = """
import sys
from pathlib import Path

import numpy as np

import symscrew
from symscrew.algebra import Tape
from symscrew.display import Progress
from symscrew.program import Function, Port, lower
from symscrew.studies.accuracy import Subject, study_of

TEXT = '''
[mechanism]
name = "table"
platform = "top"
[bodies]
top = { mass = 2, com = [0, 0, 0] }
[joints]
slides = { type = "T", parent = "base", child = "top", point = [0, 0, 0], axes = [[1, 0, 0], [0, 1, 0]], driven = true }
'''
folder = Path(sys.argv[1])
(folder / "table.toml").write_text(TEXT)

# joint type: two freedoms, and drives that are mass times acceleration
table = symscrew.load_description(folder / "table.toml")
model = symscrew.derive(table, ())
a = np.array([[3.0, -4.0]])
assert symscrew.analyse_mobility(table).dof == 2
assert np.allclose(model("inverse_dynamics", a * 0, a * 0, a)[0][0], 2 * a)

# effect: by its name in a file; the drives carry the brake
(folder / "effects.toml").write_text('[[effects]]\\ntype = "magnetic_brake"\\njoint = "slides"\\n')
from symscrew.effects import load_effects
braked = symscrew.derive(table, load_effects(folder / "effects.toml"))
v = np.array([[1.5, 0.7]])
assert np.allclose(braked("inverse_dynamics", a * 0, v, a)[0][0], 2 * a + [0.2 * 1.5 / 1.25, 0.0])

# target: its file is written and checked
assert (folder / "out" / "table_counts.csv") in [Path(p) for p in symscrew.generate(model, folder / "out", ["counts"])]
assert symscrew.check(folder / "out").ok

# pass: done before instructions are written
tape = Tape()
x = tape.symbol("x", "1", "input")
port = Port("x", (1,), ("1",), (), "")
size = Port("r", (1,), ("1",), (), "")
program = lower(Function("size", "", (port,), (size,), ((x,),), ((tape.function("abs", x),),)))
assert [i.op for i in program.instructions] == ["mul", "sqrt"]

# closed form: the platform's pose gives the limb's slides, and the loop is closed there
builder = symscrew.MechanismBuilder("cartesian", platform="head")
for name in ("cart", "rod", "head"):
    builder.body(name, mass=1, com=(0, 0, 0))
builder.joint("table", "T", parent="base", child="cart", point=(0, 0, 1), axes=[(1, 0, 0), (0, 1, 0)])
builder.joint("lift", "P", parent="cart", child="rod", point=(0, 0, 1), axes=[(0, 0, 1)], driven=True)
builder.joint("ball", "S", parent="base", child="head", point=(0, 0, 0))
builder.joint("tip", "S", parent="rod", child="head", point=("1/2", "1/3", 1))
cartesian = symscrew.derive(builder.build(), ())
states = cartesian.test_inputs["inverse_kinematics"]
q = cartesian("inverse_kinematics", *states)[0][0]
assert np.ptp(q, axis=0).max() > 0.1
assert np.abs(cartesian("closure", q)[0][0]).max() < 1e-14

# study: by its name
found = study_of("counting", Subject(model), None, full=False)(Progress(quiet=True), repeats=1, seconds=1.0)
assert {p.curve for p in found.points} == set(model.programs)
print(symscrew.__file__)
"""


def add(package: Path, file: str, what: str | tuple[str, ...]) -> int:
    """Write a new file, or put lines in front of others (which, what, which, what); the number of lines edited."""
    path = package / file
    if isinstance(what, str):
        assert not path.exists()
        path.write_text(what.lstrip())
        return 0
    text = path.read_text()
    for before, line in zip(what[::2], what[1::2], strict=True):
        assert text.count(f"\n{before}") == 1, f"{file}: {before}"
        text = text.replace(f"\n{before}", f"\n{line}\n{before}")
    path.write_text(text)
    return len(what) // 2


def test_each_is_a_file_and_a_line(tmp_path: Path) -> None:
    package = tmp_path / "symscrew"
    shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("*.pyc.*"))
    edited = {kind: sum(add(package, file, what) for file, what in files.items()) for kind, files in ADDED.items()}
    assert edited == {"joint type": 1, "effect": 0, "target": 1, "pass": 2, "closed form": 2, "study": 1}
    environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
    command = [sys.executable, "-c", USE, str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=tmp_path)
    assert done.returncode == 0, done.stderr[-3000:]
    assert done.stdout.strip() == str(package / "__init__.py")
