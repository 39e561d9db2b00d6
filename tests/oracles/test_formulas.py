"""Formulas for a paper: every one is read back from its LaTeX and compared with the functions at random states."""

from __future__ import annotations

import random
import re
import shutil
import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import sympy
from support.latex_values import Values
from support.model_states import model as known_model

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.description import parse_description
from symscrew.description.template import description_text
from symscrew.errors import DescriptionError
from symscrew.mobility import analyse_mobility, condition
from symscrew.model import Model, derive
from symscrew.paper_formulas import Paper, paper_formulas
from symscrew.paper_formulas.equal_turns import families
from symscrew.paper_formulas.formula import Part
from symscrew.paper_formulas.limb_formulas import freedoms_of, limb_part
from symscrew.paper_formulas.moved_rods import rod_part
from symscrew.paper_formulas.named_lengths import Lengths, symbol_latex
from symscrew.paper_formulas.paper import limbs_of, outside_part
from symscrew.paper_formulas.unprinted import unprinted_part
from symscrew.studies.platform_motion import platform_index

pytestmark = pytest.mark.slow

Array = np.ndarray
QUICK = ("planar_3rrr", "sarrus", "slider_crank", "bennett")
LARGE = ("three_ups_upu_s", "delta", "ur5", "five_bar")
LONGEST = {"delta": 320, "three_ups_upu_s": 280, "planar_3rrr": 220, "sarrus": 180, "five_bar": 250, "ur5": 760}
"""Letters of the longest formula, as counted: a line of a paper holds about 230."""
NAMED = {"rps": "3-rps", "spr": "3-SPR", "eye": "agile-eye"}
"""Further limbs: spokes with hinges, a spherical joint at the base that carries the others, limbs that are turned about
(1, 1, 1)."""
NAMES = [*QUICK, *(pytest.param(name, marks=pytest.mark.slow) for name in (*LARGE, *NAMED))]


@cache
def model(name: str) -> Model:
    if name in NAMED:
        return derive(parse_description(description_text(name, NAMED[name])))
    return known_model(name)


@cache
def paper(name: str) -> Paper:
    return paper_formulas(model(name).mechanism)


class Reader:
    """Values of a paper's formulas at a state, from what is printed, and of the same things from the functions."""

    def __init__(self, name: str, state: int) -> None:
        self.paper, self.model = paper(name), model(name)
        q, v, _ = self.model.system.sample_states
        self.q, self.v = q[state], v[state]
        port = self.model.programs["joint_displacements"].outputs[0]
        moved = self.model("joint_displacements", self.q)[0][0] - self.model(
            "joint_displacements", self.model.system.reference
        )[0][0]  # fmt: skip
        self.moved = dict(zip(port.labels, moved, strict=True))
        rates = self.model("joint_rates", self.q, self.v)[0][0]
        self.rates = dict(zip(port.labels, rates, strict=True))
        screws = self.model("joint_screws", self.q)[0][0].reshape(-1, 6)
        labels = [n.rpartition(".")[0] for n in self.model.programs["joint_screws"].outputs[0].labels[::6]]
        self.screws = dict(zip(labels, screws, strict=True))
        k = platform_index(self.model)
        pose = self.model("body_poses", self.q)[0][0].reshape(-1, 12)[k]
        self.twist = self.model("body_twists", self.q, self.v)[0][0].reshape(-1, 6)[k]
        self.names: dict[str, object] = {r"\boldsymbol{Q}": pose[:9].reshape(3, 3).T, r"\boldsymbol{t}": pose[9:]}
        self.names |= {r"\boldsymbol{0}": np.zeros(3)}
        for p in self.model.mechanism.parameters.values():
            self.names[symbol_latex(p.name)] = float(p.value)
        for part in self.paper.parts:
            for symbol, words in part.symbols.items():
                found = re.search(r"of (\S+) from the reference", words)
                if found and symbol.startswith(r"\boldsymbol{N}"):
                    self.turned(symbol, found[1], part_turn(part))
                elif found:
                    self.names[symbol] = self.moved[found[1]]

    def turned(self, symbol: str, joint: str, own: Array) -> None:
        """The entries of the rotation of a spherical joint, in axes that are turned by `own`."""
        bodies = [n.rpartition(".")[0] for n in self.model.programs["body_poses"].outputs[0].labels[::12]]
        poses = self.model("body_poses", self.q)[0][0].reshape(-1, 12)
        turns = {b: pose[:9].reshape(3, 3).T for b, pose in zip(bodies, poses, strict=True)}
        between = self.model.mechanism.joints[joint]
        parent = turns.get(between.parent, np.eye(3))
        rotation = own.T @ parent.T @ turns[between.child] @ own
        stem = symbol.replace(r"\boldsymbol{N}", "N")[:-1]
        for (i, j), entry in np.ndenumerate(rotation):
            self.names[f"{stem},{i + 1}{j + 1}}}"] = float(entry)

    def value(self, latex: str) -> Array:
        return Values(latex, self.names).run()

    def define(self, name: str, value: Array) -> None:
        self.names[name] = float(value) if value.ndim == 0 else value
        index = re.fullmatch(r"\\sin \\varphi_(\{.*\})", name)
        if index:
            lean = np.arctan2(float(value), float(self.names[rf"\cos \varphi_{index[1]}"]))
            self.names[rf"\varphi_{index[1]}"] = lean
        entries = re.fullmatch(r"\\boldsymbol\{([Tpub])\}_\{(.*)\}", name)
        if entries:
            for place, entry in np.ndenumerate(value):
                here = "".join(str(k + 1) for k in place)
                self.names[f"{entries[1]}_{{{entries[2]},{here}}}"] = float(entry)


@pytest.mark.parametrize("name", NAMES)
def test_every_formula_is_what_the_code_computes(name: str) -> None:
    compared = 0
    for state in range(3):
        reader = Reader(name, state)
        for formula in reader.paper.formulas:
            compared += _compared(reader, formula.name, formula.latex, formula.code)
    assert max(len(formula.text) for formula in paper(name).formulas) <= LONGEST.get(name, 10**4)
    assert compared >= 3 * sum(formula.code[:1] == ("screw",) for formula in reader.paper.formulas) > 0


def _compared(reader: Reader, name: str, latex: str, code: tuple[str, ...]) -> bool:
    """Whether a formula was compared with something of the code; what is printed before others is defined."""
    kind = code[0] if code else ""
    if kind == "matrix":
        columns = re.findall(r"\\boldsymbol\{S\}_\{[^}]*\}", latex)
        reader.define(name, np.stack([reader.names[c] for c in columns], axis=1))
        return False
    if kind == "turned":
        _turned(reader, name, latex, code)
        return True
    if kind == "each":
        for number in code[1:]:
            reader.define(name.replace("_{i}", f"_{{{number}}}"), reader.value(latex.replace("_{i}", f"_{{{number}}}")))
            if name == r"\lambda_{i}":
                for other in reader.paper.formulas:
                    if other.code[:1] == ("displacement",) and other.code[2] == number:
                        expected = reader.moved[other.code[1]]
                        np.testing.assert_allclose(reader.value(other.latex), expected, atol=1e-9)
            spoke = any(f.code[:1] == ("displacement",) and f.code[2] == number for f in reader.paper.formulas)
            if name == r"\boldsymbol{w}_{i}" and spoke:
                wrench = reader.names[f"\\boldsymbol{{w}}_{{{number}}}"]
                given = next(
                    f for f in reader.paper.formulas if f.code[:1] == ("displacement",) and f.code[2] == number
                )
                rate = wrench[:3] @ reader.twist[3:] + wrench[3:] @ reader.twist[:3]
                sign = -1 if given.latex.startswith("-") else 1
                np.testing.assert_allclose(sign * rate, reader.rates[given.code[1]], atol=1e-9)
            if name == "j_{i}":
                wrench = reader.names[f"\\boldsymbol{{w}}_{{{number}}}"]
                drive = next(
                    f.code[1] for f in reader.paper.formulas if (f.code[:1], f.code[2:]) == (("drive",), (number,))
                )
                rate = wrench[:3] @ reader.twist[3:] + wrench[3:] @ reader.twist[:3]
                np.testing.assert_allclose(rate, reader.names[f"j_{{{number}}}"] * reader.rates[drive], atol=1e-9)
        return True
    if kind == "displacement":
        return False  # looked at as soon as the length is printed
    value = reader.value(latex)
    reader.define(name, value)
    if kind == "parameter":
        np.testing.assert_allclose(value, float(reader.paper.mechanism.parameters[code[1]].value), rtol=1e-12)
        return True
    if kind == "screw":
        return _screw(reader, code[1], np.kron(np.eye(2), _own_turn(reader.paper, name)) @ value)
    if kind == "drive":
        off = value - reader.moved[code[1]]
        turns = reader.paper.mechanism.joints[code[1]].kind.hinge
        np.testing.assert_allclose(np.sin(off / 2) if turns else off, 0, atol=1e-9)
        return True
    if kind == "displaced":
        return _displaced(reader, code[1], value)
    if kind in ("constraint", "freedom", "locus"):
        return _platform(reader, kind, code, value)
    return False


def _own_turn(of: Paper, screw: str) -> Array:
    """The turn about z that the matrix of a limb says of its columns, from its print alone."""
    return part_turn(
        next(p for p in of.parts if any(f"{screw} " in f.latex for f in p.formulas if f.code == ("matrix",)))
    )


def part_turn(part: Part) -> Array:
    """The same of the limb that a part is about."""
    whole = next(f.latex for f in part.formulas if f.code == ("matrix",))
    said = re.match(r"\\boldsymbol\{Z\}\((\d+(?:\.\d+)?)\^", whole)
    return _about_z(np.radians(float(said[1]) if said else 0.0))


def _about_z(angle: float) -> Array:
    return np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])


def _screw(reader: Reader, label: str, value: Array) -> bool:
    joint = label.split(".")[0]
    spherical = reader.paper.mechanism.joints[joint].kind.ball
    if not spherical:
        np.testing.assert_allclose(value, reader.screws[label], atol=1e-9, err_msg=label)
        return True
    basis = np.stack([s for n, s in reader.screws.items() if n.split(".")[0] == joint], axis=1)
    rest = value - basis @ np.linalg.lstsq(basis, value, rcond=None)[0]
    np.testing.assert_allclose(rest, 0, atol=1e-9, err_msg=label)  # the same three-system, about absolute axes
    return True


def _turned(reader: Reader, name: str, latex: str, code: tuple[str, ...]) -> None:
    """The columns of a limb by turning those of another, at the displacements of its own."""
    first, other = (reader.paper.limbs[int(k)] for k in code[1:])
    angle = np.radians(float(re.search(r"\((\d+(?:\.\d+)?)\^", latex)[1]))
    given = re.search(r"diag\}\(([-\d, ]+)\)", latex)
    freedoms = [n for j in first for n in reader.paper.mechanism.joints[j].kind.freedom_names(j)]
    signs = [int(s) for s in given[1].split(",")] if given else [1] * len(freedoms)
    labels = [n for j in other for n in reader.paper.mechanism.joints[j].kind.freedom_names(j)]
    at_first = Reader(reader.model.name, 0)
    at_first.moved = {a: s * reader.moved[b] for a, b, s in zip(freedoms, labels, signs, strict=True)}
    number = int(code[1]) + 1
    part = next(p for p in reader.paper.parts if p.title == f"Limb {number}")
    for symbol, words in part.symbols.items():
        label = re.search(r"of (\S+) from the reference", words)[1]
        if symbol.startswith(r"\boldsymbol{N}"):
            same = other[first.index(label)]
            reader.turned(symbol, same, _about_z(angle) @ part_turn(part))
            at_first.names |= {n: v for n, v in reader.names.items() if n.startswith("N_")}
        else:
            at_first.names[symbol] = at_first.moved[label]
    columns = []
    for formula in (f for p in reader.paper.parts if p.title in ("Lengths", f"Limb {number}") for f in p.formulas):
        if formula.code[:1] != ("matrix",):
            at_first.define(formula.name, at_first.value(formula.latex))
        if formula.code[:1] == ("screw",):
            own = np.kron(np.eye(2), _own_turn(reader.paper, formula.name))
            columns.append(own @ at_first.names[formula.name])
    turn = _about_z(angle)
    if latex.startswith(r"\boldsymbol{D}"):  # about (1, 1, 1), by Rodrigues' formula
        across = np.array([[0, -1, 1], [1, 0, -1], [-1, 1, 0]]) / np.sqrt(3)
        turn = np.eye(3) + np.sin(angle) * across + (1 - np.cos(angle)) * across @ across
    both = np.kron(np.eye(2), turn)
    for column, sign, label in zip(columns, signs, labels, strict=True):
        _screw(reader, label, sign * both @ column)


def _displaced(reader: Reader, limb: str, value: Array) -> bool:
    """A limb's constraint, carried along by the first freedom, against all screws of the limb where it is."""
    joints = reader.paper.mechanism.limbs[limb].joints
    first = reader.paper.mechanism.joints[joints[0]]
    if first.kind.ball:
        bodies = [n.rpartition(".")[0] for n in reader.model.programs["body_poses"].outputs[0].labels[::12]]
        pose = reader.model("body_poses", reader.q)[0][0].reshape(-1, 12)[bodies.index(first.child)]
        turn, shift = pose[:9].reshape(3, 3).T, pose[9:]
    else:
        label = first.kind.freedom_names(first.name)[0]
        at_rest = reader.model("joint_screws", reader.model.system.reference)[0][0].reshape(-1, 6)
        screw = at_rest[list(reader.screws).index(label)]
        turn, shift = np.eye(3), screw[3:] * reader.moved[label]
        if np.abs(screw[:3]).max() > 0:
            u, point, angle = screw[:3], np.cross(screw[:3], screw[3:]), reader.moved[label]
            across = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
            turn = np.eye(3) + np.sin(angle) * across + (1 - np.cos(angle)) * across @ across
            shift = point - turn @ point
    force = turn @ value[:3]
    moment = turn @ value[3:] + np.cross(shift, force)
    own = [s for n, s in reader.screws.items() if n.split(".")[0] in joints]
    np.testing.assert_allclose([force @ s[3:] + moment @ s[:3] for s in own], 0, atol=1e-9)
    return True


def _platform(reader: Reader, kind: str, code: tuple[str, ...], value: Array) -> bool:
    """Constraints and freedoms of the reference configuration, by their reciprocal products with the code's screws."""
    rest = model(reader.model.name)
    screws = rest("joint_screws", rest.system.reference)[0][0].reshape(-1, 6)
    by_label = dict(zip(reader.screws, screws, strict=True))
    limbs = rest.mechanism.limbs
    if kind == "constraint":
        own = [s for n, s in by_label.items() if n.split(".")[0] in limbs[code[1]].joints]
        products = [value[:3] @ s[3:] + value[3:] @ s[:3] for s in own]
        np.testing.assert_allclose(products, 0, atol=1e-9)
        assert np.abs(value).max() > 1e-6
    elif kind == "freedom":
        for limb in limbs.values():
            basis = np.stack([s for n, s in by_label.items() if n.split(".")[0] in limb.joints], axis=1)
            rest_of = value - basis @ np.linalg.lstsq(basis, value, rcond=None)[0]
            np.testing.assert_allclose(rest_of, 0, atol=1e-9)
    else:
        found = mobility(reader.model.name).symbolic
        numbers = {p.symbol: p.value for p in rest.mechanism.parameters.values()}
        expected = complex(sympy.N(condition(found.loci[int(code[1])].expression).xreplace(numbers))).real
        np.testing.assert_allclose(value, expected, rtol=1e-9, atol=1e-12)
    return True


@cache
def mobility(name: str):
    return analyse_mobility(model(name).mechanism)


def test_the_seed_as_its_authors_write_it() -> None:
    """Eq. (11) of the paper, with the reading of its last columns: the leg leans by theta from the vertical."""
    found = {f.name: f.latex for f in paper("planar_3rrr").formulas}
    assert found[r"\boldsymbol{S}_{12}"].count("c_{11}") == 1
    assert not any(re.search(r"e-\d|e\+\d|\d{14}", f.latex) for f in paper("sarrus").formulas)


ARM = """[mechanism]
name = "arm"
platform = "hand"
[parameters]
rod = { value = "0.7", unit = "m" }
inwards = { value = "reach - grip", unit = "m" }
reach = { value = "0.5", unit = "m" }
grip = { value = "0.1", unit = "m" }
depth = { value = "sqrt(rod^2 - inwards^2)", unit = "m" }
m = { value = "2", unit = "kg" }
[bodies]
upper = { mass = "m", com = [0, 0, 0] }
hand = {}
[joints.A]
type = "R"
parent = "base"
child = "upper"
point = ["reach*sqrt(3)/2", "-reach/2", 0]
axes = [["1/2", "sqrt(3)/2", 0]]
[joints.B]
type = "R"
parent = "upper"
child = "hand"
point = ["grip*sqrt(3)/2", "-grip/2", "-depth"]
axes = [["1/2", "sqrt(3)/2", 0]]
"""


def test_what_follows_from_other_lengths_is_named() -> None:
    """A rod between points is no root, masses are no lengths, and a limb is written in a plane of its own."""
    made = paper_formulas(parse_description(ARM))
    found = {f.name: f.latex for f in made.formulas}
    assert found[r"\mathrm{depth}"] == r"\sqrt{\mathrm{rod}^{2} - \mathrm{inwards}^{2}}"
    assert found[r"\cos \varphi_{11}"] == r"\frac{\mathrm{depth}}{\mathrm{rod}}"
    assert found[r"\boldsymbol{S}_{11}"].split()[1::2] == ["0", "1", "0", "0", "0", r"\mathrm{reach}"]
    assert found[r"\boldsymbol{S}_{1}"].startswith(r"\boldsymbol{Z}(330^{\circ})")
    lengths = next(part.symbols for part in made.parts if part.title == "Lengths")
    assert len(lengths) == 5 and not any("kg" in words for words in lengths.values())


def test_lengths_that_follow_from_each_other_keep_their_values() -> None:
    """Sums that share terms, in any order, are replaced and put back: the value of every expression stays."""
    more = '\nw = { value = "reach + grip", unit = "m" }\ns = { value = "w - inwards + rod", unit = "m" }\nm ='
    text = ARM.replace("\nm =", more, 1).replace('"-grip/2", "-depth"', '"-grip/2 + s - s", "-depth + w - s"')
    lengths = Lengths(parse_description(text))
    symbols = {p.name: p for p in lengths.mechanism.parameters.values()}
    draw = random.Random(3)
    for _ in range(3):
        names = draw.sample(list(symbols), 3)
        of = sum((k + 2) * symbols[n].symbol ** (k % 2 + 1) for k, n in enumerate(names))
        expected = float(of.subs({p.symbol: p.value for p in symbols.values()}))
        for written in (lengths.named(of), lengths.named(lengths.written(of))):
            assert lengths.number(written) == pytest.approx(expected, rel=1e-12)


@pytest.mark.slow
def test_the_seed() -> None:
    found = {f.name: f.latex for f in paper("three_ups_upu_s").formulas}
    assert found["l"] == r"\sqrt{H^{2} + \left(R - r\right)^{2}}"
    assert found[r"\boldsymbol{S}_{13}"] == (
        r"\begin{pmatrix} 0 \\ 0 \\ 0 \\ s_{12} \\ - c_{12} s_{11} \\ c_{11} c_{12} \end{pmatrix}"
    )
    assert [n for n in found if re.fullmatch(r"\\boldsymbol\{S\}_\{[34]\}", n)], "limbs 3 and 4 are limb 2 turned"
    assert not [n for n in found if re.match(r"\\boldsymbol\{S\}_\{[34]\d", n)]


@pytest.mark.slow
def test_screws_of_limbs_with_roots_of_roots_end() -> None:
    """Angles at rest that grow with every joint are not taken off: the H4's first limb took more than six minutes."""
    mechanism = parse_description(description_text("h4", "h4"))
    first = limb_part(mechanism, next(iter(mechanism.limbs.values())).joints, 1, Lengths(mechanism))
    assert max(len(formula.text) for formula in first.formulas) < 1500
    assert [f.name for f in first.formulas if f.code[:1] == ("screw",)][-1] == r"\boldsymbol{S}_{15}"


@pytest.mark.slow
def test_a_locus_is_no_number_and_a_wrench_has_no_common_factor() -> None:
    """The 3-RPS limb as its authors write it, with its slider displaced; sqrt(3) = 0 is no condition."""
    found = {f.name: f.latex for f in paper("rps").formulas}
    assert found[r"\boldsymbol{V}_{11}"] == (
        r"\begin{pmatrix} 0 \\ l \\ 0 \\ - H \left(d_{12} + l\right) \\ 0 \\ "
        r"d_{12} \left(r - R\right) + l r \end{pmatrix}"
    )
    assert [f.latex for f in paper("rps").formulas if f.code[:1] == ("locus",)] == ["r"]


@pytest.mark.parametrize(("name", "limbs"), [("agile-eye", (2, 3)), ("orthoglide", (2, 3))])
def test_limbs_turned_about_a_diagonal_are_said_once(name: str, limbs: tuple[int, ...]) -> None:
    mechanism = parse_description(description_text("m", name))
    lengths = Lengths(mechanism)
    read = [freedoms_of(mechanism, joints) for joints in limbs_of(mechanism)]
    (family,) = [f for f in families(read, lengths) if 0 in f]
    assert [round(family[k - 1].angle) for k in limbs] == [120, 240] and all(family[k - 1].diagonal for k in limbs)
    swapped = [read[0], [replace(f, point=2 * f.point) for f in read[1]]]
    assert len(families(swapped, lengths)) == 2 or name == "agile-eye"  # a limb through O has no size


@pytest.mark.parametrize("name", ["bennett", "ur5", "three_ups_upu_s"])
def test_cosine_and_sine_squared_are_one(name: str) -> None:
    """a c_12 (c_11^2 + s_11^2) is a c_12: nothing squared is left in screws of limbs."""
    parts = [part for part in paper(name).parts if part.title.startswith("Limb ")]
    formulas = [formula.latex for part in parts for formula in part.formulas]
    assert len(formulas) > 4 and not any(re.search(r"\b[cs]_\{\d+\}\^", latex) for latex in formulas)


def test_only_limbs_between_the_ground_and_the_platform_follow_from_its_pose() -> None:
    mechanism = parse_description(description_text("h4", "h4"))
    names = next(iter(mechanism.limbs.values())).joints
    assert rod_part(mechanism, [names], Lengths(mechanism)) is None
    moved = replace(mechanism, platform="bar1")
    assert rod_part(moved, [names], Lengths(moved)) is not None


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["formulas", "slider_crank"]) == 0
    fragment = capsys.readouterr().out
    assert r"\documentclass" not in fragment and r"\boldsymbol{S}" in fragment
    assert main(["formulas", "slider_crank", "--out", str(tmp_path / "a.tex"), "--document"]) == 0
    text = (tmp_path / "a.tex").read_text()
    assert text.count(r"\begin{document}") == text.count(r"\end{document}") == 1
    assert fragment in text
    assert main(["formulas", "slider_crank", "--out", str(tmp_path / "a.pdf")]) == 2
    with pytest.raises(DescriptionError, match=r"\.tex"):
        paper("slider_crank").save(tmp_path / "a.txt")
    assert paper("slider_crank")._repr_latex_().startswith("$$")


@pytest.mark.slow
def test_documents_compile(tmp_path: Path) -> None:
    if shutil.which("pdflatex") is None:
        pytest.skip("pdflatex is not installed")
    paper("three_ups_upu_s").save(tmp_path / "seed.tex", document=True)
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "seed.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, errors="replace", timeout=120)
    assert done.returncode == 0, done.stdout[-2000:]


def test_what_is_not_printed_is_said() -> None:
    """Drives without a closed form are named with what computes them, joints of no limb too; a delta has neither."""
    arm, delta = (catalogue.load(name) for name in ("panda", "delta"))
    said = unprinted_part(arm, limbs_of(arm), Lengths(arm))
    assert said is not None and "symscrew.inverse_kinematics" in said.words
    assert all(f"joint{k}" in said.words for k in range(1, 8))
    assert unprinted_part(delta, limbs_of(delta), Lengths(delta)) is None
    assert outside_part(delta, limbs_of(delta)) is None
    left_out = outside_part(arm, [["joint1"]])
    assert left_out is not None and left_out.words.startswith("Of joint2, ")
