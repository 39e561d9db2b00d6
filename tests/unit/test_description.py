"""Descriptions from Python and from TOML: the same content, and every bad input ends in one clear error."""

import numpy as np
import pytest
import sympy
from support.work import calls_at_most

from symscrew.description.builder import MechanismBuilder
from symscrew.description.toml_file import MAX_BYTES, load_description, parse_description, to_toml
from symscrew.errors import DescriptionError

PENDULUM = """
[mechanism]
name = "pendulum"
ground = "base"
platform = "rod"
description = "a uniform rod"

[parameters.length]
value = "1/2"
unit = "m"
description = "length of the rod"
run_time = true

[parameters.phi]
value = "pi/6"
unit = "rad"

[parameters.mass]
value = 2.5
unit = "kg"

[parameters.twice]
value = "2*mass"
unit = "kg"

[bodies.rod]
mass = "mass"
com = [0, 0, "-length/2"]
inertia = ["mass*length^2/12", "mass*length^2/12", 0]

[joints.pivot]
type = "R"
parent = "base"
child = "rod"
point = [0, 0, 0]
axes = [["-sin(phi)", "cos(phi)", 0]]
driven = true
reference = [0.25]

[points.tip]
body = "rod"
at = [0, 0, "-length"]
"""


def pendulum() -> MechanismBuilder:
    builder = MechanismBuilder("pendulum", platform="rod", description="a uniform rod")
    builder.parameter("length", "1/2", unit="m", description="length of the rod", run_time=True)
    builder.parameter("phi", sympy.pi / 6, unit="rad")
    builder.parameter("mass", 2.5, unit="kg").parameter("twice", "2*mass", unit="kg")
    inertia = ["mass*length^2/12", "mass*length^2/12", 0]
    builder.body("rod", mass="mass", com=[0, 0, "-length/2"], inertia=inertia)
    builder.joint(
        "pivot", "R", parent="base", child="rod", point=[0, 0, 0], axes=[["-sin(phi)", "cos(phi)", 0]],
        driven=True, reference=0.25,
    )  # fmt: skip
    return builder.point("tip", body="rod", at=[0, 0, "-length"])


def test_python_and_file_say_the_same(tmp_path):
    file = tmp_path / "pendulum.toml"
    file.write_text(PENDULUM)
    built = pendulum().build()
    assert load_description(file) == parse_description(PENDULUM) == built == parse_description(to_toml(built))
    assert built.parameters["twice"].value == 5
    assert built.parameters["length"].run_time and not built.parameters["mass"].run_time
    assert built.joints["pivot"].reference == (sympy.Rational(1, 4),)
    length = sympy.Symbol("length", real=True)
    assert built.points["tip"].at == (0, 0, -length)
    assert built.number(built.points["tip"].at[2]) == -sympy.Rational(1, 2)


def test_decimals_of_a_file_keep_every_digit():
    digits = "0.12345678901234567890123456789012345678901234567890"
    built = parse_description(PENDULUM.replace("value = 2.5", f"value = {digits}"))
    assert built.parameters["mass"].value == sympy.Rational(digits)


def test_inertia_in_named_axes():
    axes = [["3/5", 0, "4/5"], [0, 1, 0], ["-4/5", 0, "3/5"]]
    built = pendulum().body("bob", mass=1, com=[0, 0, -1], inertia={"principal": [1, 2, "2.5"], "axes": axes})
    built.joint("weld", "fixed", parent="rod", child="bob", point=[0, 0, -1])
    inertia = np.array(built.build().bodies["bob"].inertia, dtype=float)
    turn = np.array([[0.6, 0, 0.8], [0, 1, 0], [-0.8, 0, 0.6]])
    assert inertia == pytest.approx(turn.T @ np.diag([1, 2, 2.5]) @ turn)


def test_loops_and_all_joint_types():
    builder = MechanismBuilder("all").body("a").body("b").body("c")
    common = {"point": [0, 0, 0]}
    z = [[0, 0, 1]]
    for k, (letter, axes) in enumerate(
        [("R", z), ("P", z), ("C", z), ("U", [[1, 0, 0], [0, 1, 0]]), ("S", None), ("E", z), ("fixed", None)]
    ):
        builder.joint(f"j{k}", letter, parent="base", child="a", axes=axes, **common)
    builder.joint("h", "H", parent="a", child="b", axes=z, pitch="1/100", **common)
    builder.joint("f", "free", parent="base", child="c", **common)
    built = builder.build()
    assert built.joints["h"].pitch == sympy.Rational(1, 100)
    assert parse_description(to_toml(built)) == built


def swap(old, new):
    assert old in PENDULUM
    return PENDULUM.replace(old, new, 1)


AXES = 'axes = [["-sin(phi)", "cos(phi)", 0]]'
INERTIA = 'inertia = ["mass*length^2/12", "mass*length^2/12", 0]'

BAD = {
    "not toml": ("[mechanism", "not a valid TOML file"),
    "XML": ('<sdf version="1.7"/>', "not a valid TOML file, but XML.*SDF is not read"),
    "empty": ("", r"the section \[mechanism\] is missing"),
    "no name": ("[mechanism]\n", "mechanism: the key 'name' is missing"),
    "no joints": ('[mechanism]\nname = "m"\n', "it has no joints"),
    "unknown section": ("[joint.a]\n" + PENDULUM, "unknown section 'joint'; did you mean 'joints'"),
    "unknown key": (swap("com =", "comm ="), "bodies.rod: unknown key 'comm'; did you mean 'com'"),
    "section is no table": (
        PENDULUM.replace("[points.tip]", "[points]\ntip=3\n[points.x]"),
        "points.'tip': expected a table",
    ),
    "missing key": (swap('body = "rod"', ""), "points.tip: the key 'body' is missing"),
    "half a body": (swap("com = [0", "# com = [0"), "bodies.rod: the key 'com' is missing"),
    "unknown type": (swap('type = "R"', 'type = "Q"'), "unknown joint type 'Q'"),
    "type is a list": (swap('type = "R"', "type = [[1]]"), r"unknown joint type \[\[1\]\]"),
    "missing body": (
        swap('child = "rod"', 'child = "rodd"'),
        r"'rodd' is not described; add \[bodies.rodd\].*did you mean 'rod'",
    ),
    "body of a point": (
        swap('body = "rod"', 'body = "arm"'),
        "points.tip.body: the body 'arm' is not described",
    ),
    "platform": (
        swap('platform = "rod"', 'platform = "plate"'),
        "mechanism.platform: the body 'plate' is not described",
    ),
    "same body": (swap('parent = "base"', 'parent = "rod"'), "parent and child are the same body 'rod'"),
    "disconnected": (
        PENDULUM + "[bodies.x]\n[bodies.y]\n",
        "no chain of joints leads from the ground 'base' to 'x', 'y'",
    ),
    "zero axis": (swap(AXES, "axes = [[0, 0, 0]]"), r"joints.pivot.axes\[0\]: the axis is zero"),
    "non-unit axis": (swap(AXES, "axes = [[3, 0, 4]]"), r"one of length 5.0; use \[\"3/5\", 0, \"4/5\"\]"),
    "non-unit decimals": (
        swap(AXES, "axes = [[0.7, 0.7, 0]]"),
        r"one of length 0.98994\d*; use \[\"sqrt\(2\)/2\", \"sqrt\(2\)/2\", 0\]",
    ),
    "single vector": (
        swap(AXES, "axes = [0, 1, 0]"),
        r"expected 1 axis for a revolute joint, got a single vector; write",
    ),
    "no axis": (swap(AXES, ""), "expected 1 axis for a revolute joint, got 0"),
    "axes of U": (
        swap('type = "R"', 'type = "U"'),
        "expected 2 axes for a universal joint: the parent's axis, then the child's, got 1",
    ),
    "parallel U": (
        swap('type = "R"', 'type = "U"').replace(AXES, "axes = [[0,0,1],[0,0,-1]]").replace("reference = [0.25]", ""),
        "the two axes of a universal joint are parallel",
    ),
    "two numbers": (
        swap("point = [0, 0, 0]", "point = [0, 0]"),
        "joints.pivot.point: expected 3 numbers, got 2",
    ),
    "point is text": (
        swap("point = [0, 0, 0]", 'point = "abc"'),
        "joints.pivot.point: expected a list of 3 numbers, got 'abc'",
    ),
    "pitch of R": (swap("driven = true", "pitch = 1"), "only H joints have a pitch"),
    "no pitch": (swap('type = "R"', 'type = "H"'), r"a helical joint needs its pitch"),
    "driven index": (
        swap("driven = true", "driven = [1]"),
        "expected indices of freedoms from 0 to 0, got 1",
    ),
    "driven true in list": (
        swap("driven = true", "driven = [true]"),
        "expected indices of freedoms from 0 to 0, got True",
    ),
    "driven twice": (swap("driven = true", "driven = [0, 0]"), "the same freedom is listed twice"),
    "driven text": (
        swap("driven = true", 'driven = "yes"'),
        "expected true, false or a list of indices, got 'yes'",
    ),
    "reference count": (
        swap("reference = [0.25]", "reference = [0, 1]"),
        "expected 1 value for a joint of type R, got 2",
    ),
    "negative mass": (
        swap("value = 2.5", "value = -2.5"),
        "bodies.rod.mass: expected a mass of at least 0 kg, got -2.5",
    ),
    "negative moment": (
        swap(INERTIA, "inertia = [1, 1, -0.5]"),
        r"principal moments of at least 0, got -0.5, 1.0, 1.0 kg m\^2",
    ),
    "triangle": (
        swap(INERTIA, "inertia = [1, 1, 2.0001]"),
        r"no body has the principal moments 1.0, 1.0, 2.0001 .* by 0.0001",
    ),
    "asymmetric": (
        swap(INERTIA, "inertia = [[1,0.1,0],[0,1,0],[0,0,1]]"),
        r"expected a symmetric matrix, but entry \[1\]\[0\] is 0.0",
    ),
    "inertia key": (
        swap(INERTIA, "inertia = {principl = [1,1,1]}"),
        "unknown key 'principl'; did you mean 'principal'",
    ),
    "inertia empty": (
        swap(INERTIA, "inertia = {}"),
        r"expected either 'principal' \(3 moments\) or 'matrix'",
    ),
    "inertia axes": (
        swap(INERTIA, "inertia = {principal = [1,1,1], axes = [[1,0,0],[1,0,0],[0,0,1]]}"),
        "axis 0 has product with axis 1 1.0",
    ),
    "inertia without mass": (
        swap("value = 2.5", "value = 0").replace(INERTIA, "inertia = [1, 1, 1]"),
        "expected a positive mass with the inertia 1.0, 1.0, 1.0",
    ),
    "nan": (swap("value = 2.5", "value = nan"), "parameters.mass.value: expected a finite number, got NaN"),
    "inf": (swap("value = 2.5", "value = -inf"), "expected a finite number, got -Infinity"),
    "bool": (
        swap("value = 2.5", "value = true"),
        "parameters.mass.value: expected a number, got the truth value True",
    ),
    "bool in vector": (
        swap("point = [0, 0, 0]", "point = [0, false, 0]"),
        r"joints.pivot.point\[1\]: expected a number, got the truth value False",
    ),
    "date": (swap("value = 2.5", "value = 1979-05-27"), "expected a number or a text with an expression"),
    "imaginary": (swap("value = 2.5", 'value = "acos(2)"'), "expected a real finite number"),
    "run_time": (
        swap("run_time = true", "run_time = 1"),
        "parameters.length.run_time: expected true or false, got 1",
    ),
    "unknown parameter": (
        swap('"-length"', '"-lenght"'),
        r"points.tip.at\[2\]: unknown name 'lenght'; did you mean 'length'",
    ),
    "limb joints": (
        PENDULUM + '[limbs.a]\njoints = ["pivt"]\n',
        "limbs.a.joints: the joint 'pivt' is not described; did you mean 'pivot'",
    ),
    "limb without type": (PENDULUM + "[limbs.a]\npoints = []\n", "limbs.a: the key 'type' is missing"),
    "limb makes a body again": (
        PENDULUM + '[limbs.rod]\ntype = "RR"\nbodies = ["rod"]\npoints=[[0,0,0],[0,0,1]]\naxes=[[0,0,1],[0,0,1]]\n',
        "bodies.rod: this name is given twice",
    ),
    "duplicate": (PENDULUM + "[bodies.rod]\n", "not a valid TOML file"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_descriptions(case):
    text, message = BAD[case]
    with pytest.raises(DescriptionError, match=message) as caught:
        parse_description(text)
    assert len(str(caught.value)) < 700 and "Traceback" not in str(caught.value)


@pytest.mark.parametrize(
    "name",
    [
        "",
        "1a",
        "a b",
        "a'b",
        'a"b',
        "a\nb",
        "../x",
        "a/b",
        "a\\b",
        "a.b",
        "a-b",
        "ä",
        "_a",
        "a" * 65,
        "a\0b",
        "%s",
        "$(x)",
    ],
)
@pytest.mark.parametrize("section", ["mechanism", "body", "joint", "point", "parameter", "limb"])
def test_hostile_names(name, section):
    builder = pendulum()
    with pytest.raises(DescriptionError, match="is not a valid name; expected a letter followed by"):
        if section == "mechanism":
            MechanismBuilder(name)
        elif section == "body":
            builder.body(name)
        elif section == "joint":
            builder.joint(name, "S", parent="base", child="rod", point=[0, 0, 0])
        elif section == "point":
            builder.point(name, body="rod", at=[0, 0, 0])
        elif section == "parameter":
            builder.parameter(name, 1)
        else:
            builder.limb(name, "S", points=[[0, 0, 0]])


@pytest.mark.parametrize("name", ["int", "class", "lambda", "None", "while", "nullptr", "restrict", "NULL"])
def test_keywords_are_no_names(name):
    with pytest.raises(DescriptionError, match="is a keyword of C, C\\+\\+ or Python"):
        parse_description(swap("[bodies.rod]", f"[bodies.{name}]"))


@pytest.mark.parametrize("name", ["sin", "pi", "sqrt"])
def test_functions_are_no_parameters(name):
    with pytest.raises(DescriptionError, match="is a function or constant of expressions"):
        pendulum().parameter(name, 1)


def test_hostile_name_in_a_file():
    with pytest.raises(DescriptionError, match="is not a valid name"):
        parse_description(swap("[bodies.rod]", '["bodies"."../../rod\\n"]'))


@pytest.mark.parametrize("text", ["*/ int x; /*", "a\\\nb", "\x00", "\x1b[2J"])
def test_texts_that_end_up_in_comments(text):
    with pytest.raises(DescriptionError, match="must not be in it"):
        MechanismBuilder("m", description=text)
    with pytest.raises(DescriptionError, match=r"parameters.p.unit"):
        MechanismBuilder("m").parameter("p", 1, unit=text)


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        ("__import__('os').system('touch hacked')", "cannot read"),
        ("(lambda: 0)()", "cannot read"),
        ("mass.__class__", "cannot read"),
        ("exec(1)", "unknown name 'exec'"),
        ("9**9**9**9", "expected an exponent"),
        ("(" * 60 + "1" + ")" * 60, "nested more than 50 deep"),
    ],
)
def test_hostile_expressions(expression, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for text in (swap("value = 2.5", f'value = "{expression}"'), swap('"-length"', f'"{expression}"')):
        with pytest.raises(DescriptionError, match=message):
            parse_description(text)
    assert list(tmp_path.iterdir()) == []


def test_cyclic_parameters():
    text = PENDULUM + "".join(f'[parameters.{a}]\nvalue = "{b}+1"\n' for a, b in ("ab", "bc", "ca"))
    with pytest.raises(DescriptionError, match="in a circle: a -> b -> c -> a; give one of them"):
        parse_description(text)
    with pytest.raises(DescriptionError, match="in a circle: d -> d"):
        parse_description(PENDULUM + '[parameters.d]\nvalue = "d"\n')


def test_parameters_that_double_each_other():
    chain = "".join(
        f'[parameters.p{k + 1}]\nvalue = "sin(p{k}) + cos(p{k})"\n' for k in range(60)
    )  # fmt: skip
    with calls_at_most(2_000_000), pytest.raises(DescriptionError, match=r"too many terms|more than"):
        parse_description(PENDULUM + '[parameters.p0]\nvalue = "1/7"\n' + chain)
    powers = "".join(f'[parameters.p{k + 1}]\nvalue = "p{k}^60"\n' for k in range(60))
    with calls_at_most(200_000), pytest.raises(DescriptionError, match="too large"):
        parse_description(PENDULUM + "[parameters.p0]\nvalue = 7\n" + powers)
    with calls_at_most(200_000), pytest.raises(DescriptionError, match="expected exponents up to 64, got '3600'"):
        parse_description(swap('"-length"', '"((length^60)^60)^60"').replace('value = "1/2"', 'value = "7/3"'))


@pytest.mark.parametrize(
    "text",
    [
        "x = " + "[" * 5_000_000 + "]" * 5_000_000,
        "x = " + "[" * 400_000,
        "x = " + "{a=" * 300_000,
        "[" + "a." * 400_000 + "a]",
        '"a"' + '."a"' * 200_000 + " = 1",
        "x = " + "[\n" * 300_000,
    ],
    ids=["10 MB", "brackets", "tables", "dotted header", "quoted keys", "lines"],
)
def test_nesting_ends_quickly(text, tmp_path):
    file = tmp_path / "deep.toml"
    file.write_text(text)
    said = r"deep\.toml: the (file has 1\d+ bytes|description is nested more)"
    with calls_at_most(200_000), pytest.raises(DescriptionError, match=said):
        load_description(file)


def test_brackets_in_texts_are_no_nesting():
    text = swap("a uniform rod", "[" * 100 + "." * 100)
    assert parse_description(text).description == "[" * 100 + "." * 100


def test_files_that_cannot_be_read(tmp_path):
    with pytest.raises(DescriptionError, match=r"none.toml: the file cannot be read: No such file"):
        load_description(tmp_path / "none.toml")
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(DescriptionError, match="expected a text file in UTF-8"):
        load_description(tmp_path / "binary.toml")
    with pytest.raises(DescriptionError, match=f"at most {MAX_BYTES}"):
        parse_description("#" * (MAX_BYTES + 1))
    with pytest.raises(DescriptionError, match="not a valid TOML file"):
        parse_description("x = " + "1" * 5000)


def close(**features):
    builder = MechanismBuilder("loop").body("a")
    builder.joint("left", "R", parent="base", child="a", point=[0, 0, 0], axes=[[0, 0, 1]])
    return builder.joint("right", "R", parent="base", child="a", point=[2, 0, 0], axes=[[0, 0, 1]], **features)


def test_loops_that_do_not_close():
    assert close(child_point=[2, 0, 0], child_axes=[[0, 0, 1]]).build().joints["right"].point == (2, 0, 0)
    assert close(child_point=[2, 0, "1e-13"]).build()
    with pytest.raises(DescriptionError, match=r"joints.right: the loop does not close .* 0.001 m away from its place"):
        close(child_point=[2, "0.001", 0]).build()
    with pytest.raises(DescriptionError, match=r"axis 0 on 'a' is turned by 1.5708 rad against axis 0 on 'base'"):
        close(child_axes=[[0, 1, 0]]).build()


def test_closure_ignores_what_the_joint_can_move():
    def slide(letter, **features):
        builder = MechanismBuilder("slide").body("a")
        common = {"parent": "base", "child": "a", "point": [0, 0, 0], "axes": [[0, 0, 1]]}
        return builder.joint("j", letter, **common, **features).build()

    assert slide("P", child_point=[0, 0, 3]) and slide("C", child_point=[0, 0, 3])
    assert slide("E", child_point=[3, 2, 0])
    with pytest.raises(DescriptionError, match=r"3.0 m away"):
        slide("P", child_point=[3, 0, 7])
    with pytest.raises(DescriptionError, match=r"7.0 m away"):
        slide("E", child_point=[3, 0, 7])


def test_closure_does_not_depend_on_the_unit():
    for scale in (1, 1000):
        builder = MechanismBuilder("loop").body("a")
        builder.joint("left", "S", parent="base", child="a", point=[0, 0, 0])
        point = [scale, 0, 0]
        gap = sympy.Rational(scale, 10**13)
        builder.joint("right", "S", parent="base", child="a", point=point, child_point=[scale, 0, gap])
        assert builder.build()
        gap = sympy.Rational(scale, 10**11)
        builder.joint("third", "S", parent="base", child="a", point=point, child_point=[scale, 0, gap])
        with pytest.raises(DescriptionError, match=r"joints.third: the loop does not close"):
            builder.build()


def test_limits_of_inertia_are_accepted():
    for inertia in ([1, 1, 2], [0, 0, 0], [1, 1, 0], None):
        built = pendulum().body("x", mass=1, com=[0, 0, -2], inertia=inertia)
        built.joint("weld", "fixed", parent="rod", child="x", point=[0, 0, 0])
        assert built.build().bodies["x"].mass == 1


def test_plausibility_warning():
    def disc(com, moment):
        builder = MechanismBuilder("disc").body("disc", mass=1, com=com, inertia=[moment, moment, moment])
        return builder.joint("axle", "R", parent="base", child="disc", point=[0, 0, 0], axes=[[0, 0, 1]]).build()

    (warning,) = disc([0, 0, "0.5"], "0.36").warnings
    assert "bodies.disc: the radius of gyration 0.6 m exceeds the body's extent 0.5 m" in warning
    assert disc([0, 0, "0.5"], "0.25").warnings == ()  # equal is not larger
    assert disc([0, 0, 0], "0.36").warnings == ()  # one place alone has no extent


def test_axes_from_doubles_pass_and_worse_ones_do_not():
    half = float(np.sqrt(0.5))
    builder = MechanismBuilder("m").body("a")
    builder.joint("j", "R", parent="base", child="a", point=[0, 0, 0], axes=[[half, half, 0.0]])
    assert builder.build().joints["j"].axes[0][0] == sympy.Rational(str(half))
    bad = MechanismBuilder("m").body("a")
    bad.joint("j", "R", parent="base", child="a", point=[0, 0, 0], axes=[[0.7071, 0.7071, 0]])
    with pytest.raises(DescriptionError, match=r"expected a unit vector, got one of length 0.99999"):
        bad.build()


ODD = [
    "3", "-1", "2.5", "nan", "true", '""', '"x"', '"1/0"', "[]", "[[]]", "[1]", "[[1, 2], 3]", "{}",
    "{a = 1}",
    '["a", "b", "c"]', "[[0, 0, 1]]", "[[0, 0, 1], [1, 0, 0]]", "{axes = 1, matrix = 2}", "1979-05-27",
    "[{}]",
]  # fmt: skip


def test_odd_values_never_end_in_another_error():
    """Every value of a description in turn replaced by something odd: it is read, or one clear error."""
    limb = """
[limbs.leg]
type = "UPS"
base = "base"
tip = "rod"
points = [[0, 0, 0], [0, 0, 1]]
axes = [[[1, 0, 0], [0, 1, 0]], [], []]
joints = ["u", "p", "s"]
bodies = ["low", "high"]
driven = [1]
pitch = ["", "", ""]
reference = [[], [1], []]
mass = [1, 1]
com = [[0, 0, 0], [0, 0, 1]]
inertia = [[1, 1, 1], {principal = [1, 1, 1]}]
tip_point = [0, 0, 1]
"""
    lines = (PENDULUM + limb).replace("reference = [0.25]", "reference = [0.25]\npitch = 1").splitlines()
    refused = 0
    for k, line in enumerate(lines):
        if " = " not in line:
            continue
        for value in ODD:
            text = "\n".join([*lines[:k], line.split(" = ")[0] + " = " + value, *lines[k + 1 :]])
            try:
                parse_description(text.replace("pitch = 1\n", "") if "pitch" not in line else text)
            except DescriptionError as error:
                refused += 1
                assert 20 < len(str(error)) < 700
    assert refused > 400


@pytest.mark.parametrize(
    "axis, said", [("[0, 1, 0]", []), ('["1/1e8", "sqrt(1 - 1/1e16)", 0]', []), ('["3/5", "4/5", 0]', ["53.130102"])]
)
def test_universal_joints_that_are_not_perpendicular_are_said(axis: str, said: list[str]) -> None:
    text = '[mechanism]\nname = "cross"\n[bodies.b]\n[joints.u]\ntype = "U"\nparent = "base"\nchild = "b"\n'
    found = parse_description(text + f"point = [0, 0, 0]\naxes = [[1, 0, 0], {axis}]\n").warnings
    assert [w for w in found if "perpendicular" in w or "not 90" in w] == [
        f"joints.u: the axes of this universal joint are {angle} degrees apart, not 90" for angle in said
    ]
