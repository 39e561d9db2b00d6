"""Printers on programs made by hand: what the texts hold, without compiling them."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import casadi as ca
import pytest
from support import handmade
from support.model_states import model as support_model

from symscrew.description.builder import MechanismBuilder
from symscrew.export import c, casadi, listing
from symscrew.export import numpy as numpy_printer
from symscrew.export.conventions import CONVENTIONS, conventions
from symscrew.export.manifest_file import OutputError, effect_from_json, effect_to_json
from symscrew.export.value_names import LEGEND
from symscrew.generation.folder import render
from symscrew.model import derive
from symscrew.program.straight_line import COUNTED, NO_ROTATION, OUT_OF_REACH, Port


@pytest.fixture(scope="module")
def model():
    return handmade.model()


def test_every_printer_knows_every_operation_and_the_test_program_uses_them_all():
    for table in (c.TABLE, casadi.TABLE, numpy_printer.TABLE):
        assert set(table) == set(COUNTED)
    used = {i.op for i in handmade.every_operation().instructions}
    assert used == set(COUNTED)


def test_header_says_all_that_a_user_must_know(model):
    header = c.print_header(model)
    about = header[header.index("/* handmade_guarded:") : header.index("int handmade_guarded(")]
    total = model.programs["guarded"].operations["total"]
    for text in ("in x[2] [m]: test array x", "0 x 0; 1 x 1", "Returns 0, 1, 2", f"operations: {total} "):
        assert text in about
    assert "matrix[6] (2x3, column by column)" in header
    assert "#define HANDMADE_RANK_LOST (-2)" in header and not re.search(r"#define \w+ -", header)


def test_the_header_tells_the_stack_of_second_paths():
    """As many bytes as their arrays hold, which a batch needs beside its blocks."""
    found = support_model("four_bar").only(["forward_dynamics", "forward_dynamics_reactions"])
    sizes = []
    for body in re.findall(r"^(?:static )?int \w+_rank_revealing\(.*?^}", c.print_source(found), re.M | re.S):
        declared = re.findall(r"^ +double (\w+\[.*);$", body, re.M)
        sizes.append(8 * sum(int(size) for line in declared for size in re.findall(r"\w\[(\d+)\]", line)))
    (told,) = re.findall(r"also arrays of (\d+)", re.sub(r"\s*\n \* ", " ", c.print_header(found)))
    assert len(sizes) == 2 and max(sizes) == int(told)
    assert "also arrays of" not in c.print_header(found.only(["energy"]))


def test_limits_say_what_they_refuse_and_entries_their_units(model):
    """A limit is not a bare number: its status, and the limb that does not reach. Counts are not units."""
    guarded = model.programs["guarded"]
    limits = (0, 0.25, 4.0, NO_ROTATION), (1, None, 9.0, OUT_OF_REACH)
    source = c.print_source(replace(model, programs={"guarded": replace(guarded, limits=limits, reach=("leg",))}))
    lines = [line.strip() for line in source.splitlines()]
    first = next(k for k, line in enumerate(lines) if line.startswith("NOT_BELOW("))
    assert lines[first - 1 : first + 4] == [
        "/* else status 5: no rotation */",
        lines[first],
        lines[first].replace("BELOW", "ABOVE").replace("0.25", "4.0"),
        "/* else status 11: out of reach: limb leg does not get there */",
        lines[first + 3],
    ]
    mixed = Port("q", (3,), ("rad", "m", "rad"), ("A", "B", "C"), "configuration")
    several = {name: replace(guarded, name=name, inputs=(mixed,)) for name in ("one", "two")}
    assert "/* q[3] [2 in rad, 1 in m]: configuration */" in c.print_header(replace(model, programs=several))


def test_conventions_are_said_once_and_everywhere_the_same(model):
    """In the header, in the manifest and on their page; those of ball joints only where there is one."""
    page = (Path(__file__).parents[2] / "docs/conventions.md").read_text(encoding="utf-8")
    page = " ".join(page.split())
    for text in LEGEND:  # said where the constants stand, and there
        assert text in page.replace("`", "") and text in " ".join(c.print_source(model).split())
    for subject, text in CONVENTIONS.items():
        assert f"- **{subject}**: {text}" in page
    header = " ".join(c.print_header(model).replace("\n *", " ").split())
    assert f"units: {CONVENTIONS['units']}" in header and "rates of ball joints" not in header
    ball = "ball", (4,), ("1",) * 4, tuple(f"S.q{x}" for x in "wxyz"), ""
    guarded = replace(model.programs["guarded"], inputs=(*model.programs["guarded"].inputs, Port(*ball)))
    assert set(conventions(replace(model, programs={"guarded": guarded}))) == set(CONVENTIONS)


def test_entries_of_casadi_functions_have_the_names_of_the_c_code(tmp_path):
    """After saving and reading, too: `sx_in` and every expression in them say what they are of."""
    found = support_model("four_bar")
    program = found.programs["inverse_dynamics"]
    casadi.program_function(program).save(str(tmp_path / "f.casadi"))
    symbols = ca.Function.load(str(tmp_path / "f.casadi")).sx_in()
    entries = [str(entry) for symbol in symbols for entry in ca.symvar(symbol)]
    assert entries[:3] == ["A_q", "B_q", "D_q"] and len(entries) == sum(port.size for port in program.inputs)
    read = re.findall(r"(\w+_\w+) = READ\(", c.print_source(found.only(["inverse_dynamics"])))
    assert read and set(read) <= set(entries)
    assert [symbol.shape for symbol in symbols] == [(port.size, 1) for port in program.inputs]


def test_no_storage_of_its_own(model):
    source = c.print_source(model)
    assert not re.search(r"\b(malloc|calloc|free|alloca|pow)\s*\(", source)
    assert not re.search(r"^static (?!void|int|inline|const)|^[ \t]+static", source, re.MULTILINE)


def test_a_constant_is_no_slot_of_the_same_number():
    """The middle entry of a rotation about y is 1; slot 1 is the cosine of the only coordinate, slot 0."""
    builder = MechanismBuilder("hinge")
    builder.body("flap", mass=1, com=[1, 0, 0])
    builder.joint("pin", "R", parent="base", child="flap", point=[0, 0, 0], axes=[[0, 1, 0]])
    text = c.print_c(derive(builder.build()))["hinge.c"]
    body = text[text.index("BODY(hinge_body_poses)(") :]
    assert "WRITE(poses, 4, CONSTANT(1.0));" in body[: body.index("\n}")]


def test_constants_read_back_exactly():
    for value in (0.1, 1e-5, -2.5, 1e300, 5e-324, 1.0, 123456789012345680.0):
        text = listing.decimal(value)
        assert float(text.strip("()")) == value
        assert "." in text
    with pytest.raises(ValueError, match="finite"):
        listing.decimal(float("nan"))


@pytest.mark.parametrize("name", ["a b", "int", "../x", 'a"', "a\nb"])
def test_bad_names_are_refused(model, name):
    with pytest.raises(ValueError, match="name"):
        c.print_c(replace(model, name=name))


@pytest.mark.parametrize("name", ["human_model", "MODEL_UPPER", "REAL_arm", "zero_EIGHT"])
def test_names_that_are_words_of_a_printer_are_names(model, name):
    """The C of a mechanism is that of any other under its name: an MJCF without a name is a `mujoco_model`."""
    plain, named = (c.print_c(replace(model, name=called)) for called in ("wxyz" * 5, name))
    shape = re.compile(r"\\\n|\s+")  # comments and long lines are broken elsewhere
    for (file, text), (_, other) in zip(sorted(plain.items()), sorted(named.items()), strict=True):
        expected = text.replace("wxyz" * 5, name).replace("WXYZ" * 5, name.upper())
        assert shape.sub("", other).replace("*", "") == shape.sub("", expected).replace("*", ""), file


def test_python_code_is_never_evaluated():
    package = Path(listing.__file__).parents[1]
    for path in package.rglob("*.py"):
        assert not re.search(r"(?<![\w.])(eval|exec|compile)\(", path.read_text(encoding="utf-8")), path


def test_operations_are_what_is_printed(model):
    """Count the operations in the text of the body of the C function."""
    source = c.print_source(model, batches=False)
    body = source[source.index("BODY(handmade_guarded)(") :]
    code = re.sub(r"e[+-]\d+", " ", body[: body.index("\n}")])
    signs = (" + ", " - ", " * ", " / ", "SINES(", "FINITE", "SMALL(")
    count = sum(code.count(sign) for sign in signs) + code.count("SMALL(")  # an absolute value and a comparison
    operations = json.loads(render(model, ("c",))["ops.json"])["guarded"]
    assert count == operations["total"]
    assert operations["total"] == sum(n for key, n in operations.items() if key != "total")


def test_effects_survive_the_manifest():
    from symscrew.effects.external_wrench import ExternalWrench
    from symscrew.effects.gravity import Gravity

    for effect in (Gravity(), Gravity((0, "-1/3", 0.5)), ExternalWrench("tool")):
        again = effect_from_json(json.loads(json.dumps(effect_to_json(effect))))
        assert again == effect
    for bad in ({"type": "Effect"}, {"type": "os"}, {"type": "Gravity", "field": 1}, None):
        with pytest.raises(OutputError):
            effect_from_json(bad)


def test_latex_in_the_notation_of_the_paper():
    import sympy

    from symscrew.export.latex import markdown, matrix_latex, screw_latex

    theta, radius, length = sympy.symbols("theta R L")
    wrench = sympy.Matrix([0, 1, 0, 0, 0, -radius + length / sympy.sin(theta)])
    text = screw_latex(wrench, {theta: r"\vartheta"})
    assert (
        text == r"\begin{pmatrix} 0 & 1 & 0 & ; & 0 & 0 & \frac{L}{\sin{\left(\vartheta \right)}} - R \end{pmatrix}^{T}"
    )
    block = markdown("W", matrix_latex(sympy.Matrix.hstack(wrench, 2 * wrench)))
    assert block.startswith("$$\nW = \\left(\\begin{array}{cc}\n0 & 0 \\\\\n1 & 2 \\\\\n0 & 0 \\\\ \\hline\n")
    with pytest.raises(ValueError, match="6 entries"):
        screw_latex(sympy.eye(2))
