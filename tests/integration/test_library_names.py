"""Names that C and its libraries have taken: refused as files, and everywhere else made to work."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from support.model_states import relative

from symscrew.cli.parser import main
from symscrew.description.builder import MechanismBuilder
from symscrew.description.taken_names import FUNCTIONS, MACROS, OTHERS, PER_TYPE, members, namespace, taken_as_file
from symscrew.description.toml_file import parse_description
from symscrew.errors import DescriptionError
from symscrew.export.c_form import library_sources
from symscrew.export.javascript import print_javascript
from symscrew.formats import by_suffix
from symscrew.generation.folder import TARGETS, generate
from symscrew.model import derive
from symscrew.runtime.compiled import find_compiler
from symscrew.verification.regeneration import check

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: these tests ask it what is taken")
C_HEADERS = (
    "assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdarg stdbool stddef "
    "stdint stdio stdlib string tgmath time wchar wctype threads uchar"
)
POSIX = ["unistd", "strings", "fcntl", "sys/stat", "sys/socket", "poll", "pthread"]
CPP_HEADERS = (
    "algorithm array cctype cerrno cfenv cfloat chrono cinttypes climits clocale cmath complex csetjmp csignal "
    "cstdarg cstdio cstdlib cstring ctime cwchar cwctype functional iostream memory numeric random string thread "
    "utility vector"
)
ISO, CPP = C_HEADERS.split(), CPP_HEADERS.split()
ODD = """
[mechanism]
name = "gamma"
ground = "EOF"
platform = "std"
[parameters]
I = {value = "1/40", unit = "kg m^2", run_time = true, description = "about the hinge"}
EOF = {value = "1.2", unit = "kg", run_time = true}
gamma = {value = "3/20", unit = "m"}
[bodies]
linux = {mass = "1/2", com = [0, 0, "3/40"], inertia = ["3/3200", "3/3200", 0]}
errno = {mass = "EOF", com = ["1/5", 0, "3/10"], inertia = ["9/1000", "I", "2/125"]}
std = {mass = "1.2", com = ["13/25", 0, "9/40"], inertia = ["1/40", "1/40", "1/40"]}
[joints]
I = {type = "R", parent = "EOF", child = "linux", point = [0, 0, 0], axes = [[0, 1, 0]], driven = true}
signal = {type = "R", parent = "linux", child = "errno", point = [0, 0, "gamma"], axes = [[0, 1, 0]]}
time = {type = "R", parent = "errno", child = "std", point = ["2/5", 0, "9/20"], axes = [[0, 1, 0]]}
near = {type = "R", parent = "EOF", child = "std", point = ["16/25", 0, 0], axes = [[0, 1, 0]]}
[points]
NAN = {body = "errno", at = ["1/5", 0, "3/10"]}
"""
SOME = ("assemble", "point_motion", "energy", "inverse_dynamics")
"""Functions whose ports have names of all kinds: joints, bodies, points, parameters."""


def run(command: list[str], folder: Path) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]
    return done.stdout


def includes(headers: list[str], suffix: str = ".h") -> str:
    return "".join(f"#include <{header}{suffix}>\n" for header in headers)


def test_every_function_of_iso_c_is_known(tmp_path: Path) -> None:
    """What gcc declares of ISO C11 by its headers, in strict mode: all of it gets another namespace."""
    (tmp_path / "all.c").write_text(includes(ISO))
    compiler = find_compiler() or ""
    run([compiler, "-std=c11", "-aux-info", "declared", "-c", "all.c"], tmp_path)
    if not (tmp_path / "declared").is_file():
        pytest.skip("this compiler does not list declarations")
    text = re.sub(r"/\*.*?\*/", "", (tmp_path / "declared").read_text())
    declared = set(re.findall(r"\b([A-Za-z]\w*) \(", text)) - {"int", "void", "extern"}
    assert len(declared) > 450
    assert not [name for name in declared if namespace(name) == name]


@pytest.mark.slow
def test_namespaces_stand_beside_all_headers(tmp_path: Path) -> None:
    """In one unit with everything declared; some of the names themselves do not (what the underscore is for)."""
    taken = sorted(FUNCTIONS | PER_TYPE | MACROS | OTHERS | {f"{name}f" for name in PER_TYPE})
    head = includes(CPP, "") + includes(POSIX)
    good = "".join(f"namespace {namespace(n)} {{ int a(); }}\n" for n in taken)
    names = ("gamma", "link", "errno", "linux")
    bad = "".join(f'#line 1 "{name}_"\nnamespace {name} {{ int a(); }}\n' for name in names)
    (tmp_path / "all.cpp").write_text(f"{head}{good}{bad}")
    command = ["c++", "-std=gnu++17", "-fsyntax-only", "all.cpp"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert {place.split(":")[0] for place in re.findall(r"^(\S+): error", done.stderr, re.M)} == {
        f"{n}_" for n in names
    }


def test_headers_of_the_system_are_no_mechanisms(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """Every header that those of C and C++ bring in; one line, exit code 2, nothing written."""
    (tmp_path / "all.cpp").write_text(includes(CPP, "") + includes(ISO))
    (tmp_path / "all.c").write_text(includes(ISO) + includes(POSIX))
    found = set()
    for compiler, source in (("c++", "all.cpp"), (find_compiler() or "cc", "all.c")):
        files = run([compiler, "-M", source], tmp_path).replace("\\\n", " ").split()
        found |= {name[1] for f in files if (name := re.search(r"/include/([A-Za-z]\w*)\.h$", f))}
    assert found >= {"math", "features", "stddef", "time"}
    assert not [name for name in found if taken_as_file(name) is None]
    for name in ("math", "Time", "example", "AUX"):
        (tmp_path / "odd.toml").write_text(ODD.replace('"gamma"', f'"{name}"', 1))
        assert main(["generate", str(tmp_path / "odd.toml"), "--out", str(tmp_path / "out")]) == 2
        said = capsys.readouterr().err
        assert said.count("\n") == 1, said
        assert f"mechanism.name: '{name}' would give {name}.h and {name}.c" in said
        assert main(["new", name, "--limbs", "RRR", "--out", str(tmp_path / "new.toml")]) == 2
        assert capsys.readouterr().err == said.replace("odd.toml: ", "")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["all.c", "all.cpp", "odd.toml"]


def test_a_robot_of_such_a_name_is_read_under_another(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    joint = '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    path.write_text(f'<robot name="math"><link name="a"/><link name="b"/>{joint}</robot>')
    with pytest.raises(DescriptionError):
        MechanismBuilder("math")
    assert by_suffix.load_format(path).name == "math_"


def test_members_are_different() -> None:
    assert members(["I", "I_", "gamma", "NAN"]) == {"I": "I__", "I_": "I_", "gamma": "gamma", "NAN": "NAN_"}


def test_objects_of_javascript() -> None:
    for name in ("NaN", "Object", "require"):
        builder = MechanismBuilder(name)
        builder.body("rod", mass=1, com=[0, 0, -1])
        builder.joint("pin", "R", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 1, 0]])
        text = print_javascript(derive(builder.build()).only(["forward_kinematics"]))[f"{name}.js"]
        assert f"const {name}_ = (" in text and f"const {name} " not in text


@pytest.mark.slow
def test_odd_names_in_every_target(tmp_path: Path) -> None:
    """`check` compiles and runs all of them; the example in C++ with every header before it, and gnu dialects."""
    found = derive(parse_description(ODD)).only(SOME)
    out = tmp_path / "out"
    apart = ("urdf", "fmu", "reduced", "ros2", "modes", "markdown", "latex")  # the last two have no names of C
    generate(found, out, [t for t in TARGETS if t not in apart])
    generate(found, tmp_path / "package", ["ros2"])
    results = [check(folder) for folder in (out, tmp_path / "package")]
    assert all(result.ok for result in results), [result.lines for result in results]
    said = "\n".join(line for result in results for line in result.lines)
    for what in (  # that each target is looked at, not its name only; others: test_generation
        "operations", "same bytes", "reads it without warnings", "C agrees", "CasADi agrees", "NumPy module agrees",
        "CasADi external agrees", "Jacobians of CasADi externals", "Hessians of CasADi externals", "JavaScript",
        "MJCF read back",
    ):  # fmt: skip
        assert what in said
    program = found.programs["inverse_dynamics"]
    q, v, a, p = (np.atleast_2d(x)[0] for x in found.test_inputs["inverse_dynamics"])
    assert [port.name for port in program.inputs] == ["q", "v", "a", "p"]
    given = ", ".join("{" + ", ".join(map(repr, x.tolist())) + "}" for x in (q, v, a))
    use = f"""
        double states[3][3] = {{{given}}};
        gamma_parameters p = GAMMA_PARAMETERS_DEFAULT;
        p.by_name.I_ *= 2; p.by_name.EOF_ *= 3;
        double u[1];
    """
    (out / "use.c").write_text(
        f'{includes(ISO + POSIX)}#include "gamma.h"\nint main(void) {{ {use}'
        'gamma_inverse_dynamics(states[0], states[1], states[2], p.p, u); printf("%.17g\\n", u[0]); return 0; }\n'
    )
    (out / "use.cpp").write_text(
        f'{includes(CPP, "")}{includes(POSIX)}#include "gamma.hpp"\nint main() {{ {use}'
        "const auto status = gamma_::inverse_dynamics(states[0], states[1], states[2], p.p, u);"
        'std::printf("%.17g\\n", u[0]); return static_cast<int>(status); }\n'
    )
    ((expected,),), _ = found("inverse_dynamics", q, v, a, p * [2.0, 3.0])  # type: ignore[misc]
    flags = ["-O0", "-fno-math-errno", "-I."]
    sources = library_sources((path.name for path in out.iterdir()), "gamma")
    sources.remove("use.c")
    run([find_compiler() or "", "-std=gnu99", *flags, "-r", *sources, "-o", "gamma.o"], out)
    run([find_compiler() or "", "-std=gnu99", *flags, "use.c", "gamma.o", "-lm", "-o", "used_by_c"], out)
    run(["c++", "-std=gnu++20", *flags, "use.cpp", "gamma.o", "-lm", "-o", "used_by_cpp"], out)
    for program_file in ("./used_by_c", "./used_by_cpp"):
        assert relative(np.array([float(run([program_file], out))]), np.array([expected])) < 1e-12
