"""The house: imports point one way through doors, no file twice, symbols have units, files stay readable."""

from __future__ import annotations

import ast
import re
import sys
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from support.sources import PACKAGE, nodes, parsed


@cache
def the_map(package: Path = PACKAGE) -> list[str]:
    """Rooms in the order in which the package's docstring lists them, as dotted names without the package's."""
    text = ast.get_docstring(ast.parse((package / "__init__.py").read_text())) or ""
    lines = text.partition("The map:")[2].splitlines()
    return [m[1].replace("/", ".") for line in lines if (m := re.match(r"    ([a-z_/]+) +\S", line))]


def files(package: Path = PACKAGE) -> list[Path]:
    return sorted(p for p in package.rglob("*.py"))


def module_of(path: Path, package: Path = PACKAGE) -> str:
    """Dotted name without the package's: "" for the package itself, "algebra" for its `__init__`."""
    parts = path.relative_to(package).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def room_of(module: str, package: Path = PACKAGE) -> str:
    """The mapped room that holds a module; "" for the package's face and its `__main__`."""
    rooms = [room for room in the_map(package) if module == room or module.startswith(room + ".")]
    return max(rooms, key=len, default="")


@cache
def modules_of(package: Path) -> frozenset[str]:
    return frozenset(module_of(p, package) for p in files(package))


@cache
def imports(path: Path, package: Path = PACKAGE) -> tuple[tuple[str, str], ...]:
    """(module, name) of everything of the package that a file imports, in functions and for type checkers too."""
    modules = modules_of(package)
    found = []
    for node in nodes(path):
        if isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: imports are absolute"
            if (node.module or "").split(".")[0] == "symscrew":
                source = (node.module or "").removeprefix("symscrew").removeprefix(".")
                for alias in node.names:
                    inside = f"{source}.{alias.name}".removeprefix(".")
                    found.append((inside, "") if inside in modules else (source, alias.name))
        elif isinstance(node, ast.Import):
            found += [
                (a.name.removeprefix("symscrew").removeprefix("."), "")
                for a in node.names
                if a.name.split(".")[0] == "symscrew"
            ]
    return tuple(found)


def is_folder(module: str, package: Path = PACKAGE) -> bool:
    return (package / Path(*module.split(".")) / "__init__.py").is_file()


def house_of(module: str, package: Path = PACKAGE) -> str:
    """The folder that a module stands in; a folder's `__init__` stands in the folder."""
    return module if is_folder(module, package) else module.rpartition(".")[0]


def broken_rule(path: Path, package: Path = PACKAGE) -> list[str]:
    """What is wrong with the imports of a file, a sentence each."""
    order = the_map(package)
    own = module_of(path, package)
    if own == "":
        return []  # the face hands on what is public
    room, home = room_of(own, package), house_of(own, package)
    wrong = []
    for module, name in imports(path, package):
        if module == "":
            if name != "__version__":
                wrong.append(f"{own} takes {name} from the package's face: import it from its room")
            continue
        other = room_of(module, package)
        around = f"{home}.".startswith(f"{house_of(module, package)}.")
        if other != room and not around:
            if other not in order or (room in order and order.index(other) > order.index(room)):
                wrong.append(f"{own} imports {module}, which is not above {room} in the map")
            if module != other:
                wrong.append(f"{own} imports {module}: expected the door of its room, symscrew.{other}")
            continue
        there = house_of(module, package)
        if path.name == "__init__.py" and (there == home or there.rpartition(".")[0] == home):
            continue  # a face names its own parts
        if module == home or (is_folder(module, package) and f"{own}.".startswith(f"{module}.")):
            wrong.append(f"{own} imports the door of its own house: expected the file that holds {name}")
        door = is_folder(module, package) and f"{home}.".startswith(f"{there.rpartition('.')[0]}.")
        if not around and not door:  # neither in the same folder or one around it, nor a door of one inside
            wrong.append(f"{own} imports {module}, past the door of {there}")
    return wrong


def test_the_map_names_every_room() -> None:
    tops = {p.name for p in PACKAGE.iterdir() if (p / "__init__.py").is_file()}
    tops |= {p.stem for p in PACKAGE.glob("*.py")} - {"__init__", "__main__"}
    assert {room.partition(".")[0] for room in the_map()} == tops
    assert all((PACKAGE / Path(*room.split("."))).is_dir() or room in tops for room in the_map())
    assert len(list(PACKAGE.glob("*.py"))) <= 10


def test_imports_point_one_way_and_go_through_doors() -> None:
    assert [sentence for path in files() for sentence in broken_rule(path)] == []


@cache
def holder(module: str, name: str) -> str:
    """The file that holds a name which a folder's `__init__` hands on."""
    while is_folder(module):
        handed = {a: m for m, a in imports(PACKAGE / Path(*module.split(".")) / "__init__.py")}
        if name not in handed:
            return module
        module = handed[name]
    return module


def test_no_files_import_each_other_in_a_circle() -> None:
    graph = {
        module_of(path): {holder(m, n) for m, n in imports(path)} for path in files() if path.name != "__init__.py"
    }
    done: set[str] = set()

    def visit(name: str, above: tuple[str, ...]) -> None:
        assert name not in above, " -> ".join((*above[above.index(name) :], name))
        if name not in done:
            for other in sorted(graph.get(name, ())):
                visit(other, (*above, name))
            done.add(name)

    for name in graph:
        visit(name, ())


def test_no_module_name_stands_for_two_things() -> None:
    leaves = [module_of(p).rpartition(".")[2] for p in files() if module_of(p)]
    assert [name for name, count in Counter(leaves).items() if count > 1] == []


@pytest.mark.parametrize("face", [p for p in files() if p.name == "__init__.py"], ids=module_of)
def test_faces_only_hand_on(face: Path) -> None:
    """What others may use is in `__all__`, comes from the inside, and has no part's name (which would hide it)."""
    tree = parsed(face)
    handed = {
        alias.asname or alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("symscrew.")
        for alias in node.names
    } - {"doors", "known_effects"}
    named = {
        item.value
        for node in tree.body
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__"
        for item in node.value.elts  # type: ignore[attr-defined]
    } - {"__version__", "known_effects"}
    assert handed == named
    assert named.isdisjoint({p.stem for p in face.parent.iterdir()})
    assert not [n.name for n in tree.body if isinstance(n, ast.ClassDef)]


@pytest.mark.parametrize(
    "library, allowed",
    [("casadi", {"export", "runtime", "verification", "generation", "simulation", "display", "optimisation"})],
)
def test_heavy_libraries_stay_in_their_rooms(library: str, allowed: set[str]) -> None:
    for path in files():
        for node in nodes(path):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            if library in names:
                assert room_of(module_of(path)) in allowed, path


def test_nothing_evaluates_text() -> None:
    forbidden = {"eval", "exec", "sympify", "parse_expr", "compile", "system", "popen"}
    for path in files():
        for node in nodes(path):
            if isinstance(node, ast.Call):
                name = getattr(node.func, "id", getattr(node.func, "attr", ""))
                of_a_library = isinstance(node.func, ast.Attribute) and getattr(node.func.value, "id", "") == "re"
                assert name not in forbidden or of_a_library, (path, name)
                assert not any(k.arg == "shell" for k in node.keywords), path


STANDS_ALONE = {  # others run them without the package: lines, and what they import beside the standard library
    "mobility/proofs/proof_checker.py": (1130, set()),
    "mobility/proofs/way_checker.py": (520, {"proof_checker", "symscrew.mobility.proofs.proof_checker"}),
    "studies/certificate/certificate_checker.py": (1026, {"numpy"}),
}


def test_files_stay_readable() -> None:
    lines = {str(p.relative_to(PACKAGE)): len(p.read_text().splitlines()) for p in files()}
    assert not {name: n for name, n in lines.items() if n > STANDS_ALONE.get(name, (450, set()))[0]}


@pytest.mark.parametrize("name", STANDS_ALONE)
def test_the_checkers_of_proofs_import_nothing_of_the_package(name: str) -> None:
    tree = parsed(PACKAGE / name)
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom)]
    names = {a.name for n in nodes if isinstance(n, ast.Import) for a in n.names}
    parts = [n for n in nodes if isinstance(n, ast.ImportFrom)]
    own = {f"{n.module}.{a.name}" for n in parts if str(n.module).startswith("symscrew") for a in n.names}
    names |= own | {str(n.module) for n in parts if not str(n.module).startswith("symscrew")}
    assert {m if m in own else m.split(".")[0] for m in names} <= sys.stdlib_module_names | STANDS_ALONE[name][1]
