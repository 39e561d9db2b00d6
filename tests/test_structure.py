"""The house: imports point one way, every symbol has unit and description, files stay readable."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import symscrew
from symscrew import catalogue
from symscrew.model import derive
from symscrew.tape import Symbol

PACKAGE = Path(symscrew.__file__).parent

STAGES = (
    ("errors", "joints", "library_names", "mechanism", "replacement", "screws"),
    ("expressions", "names", "reader", "limbs", "validation", "builder", "description", "sections", "starter", "usage"),
    ("maximal_coordinates", "joint_motion", "newton_euler", "interchange", "catalogue"),
    (
        "elementary",
        "least_squares",
        "operations",
        "tape",
        "tape_expressions",
        "reciprocals",
        "common_factors",
        "differentiation",
    ),
    ("program", "rank_revealing", "jacobians"),
    ("lanes", "lane_padding", "lane_signs", "pack_plan", "packs"),
    ("mobility", "tree", "frames", "recursion", "closure", "system", "volumes", "margins"),
    ("kinematics", "displacements", "momentum", "effects"),
    (
        "elimination",
        "contact_rows",
        "rod_rows",
        "closure_rows",
        "loops",
        "modes",
        "planar_limbs",
        "spoke_limbs",
        "crank_limbs",
        "crank_rates",
        "limb_solutions",
    ),
    (
        "equilibrium",
        "drives",
        "rods",
        "reactions",
        "tree_dynamics",
        "articulated",
        "coriolis",
        "projection",
        "admissible",
        "variations",
        "composite_variations",
        "closure_variations",
        "force_variations",
    ),
    ("functions", "quantities"),
    ("model", "scene", "inertial_parameters"),
    ("export", "manifest", "compiled", "timing", "machine", "plots"),
    ("simulation", "fmu", "console", "embedded", "generation", "agreement", "verification"),
    (
        "motion",
        "outline",
        "drawing",
        "optimisation",
        "accuracy",
        "cost",
        "demo",
        "benchmark",
        "view",
        "report",
        "workspace",
        "commands",
        "cli",
        "__main__",
    ),
)
STAGE = {name: level for level, names in enumerate(STAGES) for name in names}


def modules() -> list[Path]:
    return sorted(p for p in PACKAGE.rglob("*.py") if p.name != "__init__.py" or p.parent != PACKAGE)


def stage_of(path: Path) -> str:
    return path.relative_to(PACKAGE).parts[0].removesuffix(".py")


def imported(path: Path) -> set[str]:
    """Names of the package's top-level modules that a file imports, inside functions too."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("symscrew"):
            parts = node.module.split(".")
            names |= {parts[1]} if len(parts) > 1 else {alias.name for alias in node.names}
        elif isinstance(node, ast.Import):
            names |= {a.name.split(".")[1] for a in node.names if a.name.startswith("symscrew.")}
    return names - {"__version__"}


@pytest.mark.parametrize("path", modules(), ids=lambda p: str(p.relative_to(PACKAGE)))
def test_imports_point_one_way(path: Path) -> None:
    own = stage_of(path)
    assert own in STAGE, f"put {own} into a stage of tests/test_structure.py"
    for name in imported(path):
        assert STAGE[name] <= STAGE[own], f"{own} (stage {STAGE[own]}) imports {name} (stage {STAGE[name]})"


@pytest.mark.slow
def test_no_module_imports_in_a_circle() -> None:
    graph: dict[str, set[str]] = {}
    for path in modules():
        graph.setdefault(stage_of(path), set()).update(imported(path) - {stage_of(path)})
    done: set[str] = set()

    def visit(name: str, above: tuple[str, ...]) -> None:
        assert name not in above, " -> ".join((*above, name))
        if name not in done:
            for other in graph.get(name, ()):
                visit(other, (*above, name))
            done.add(name)

    for name in graph:
        visit(name, ())


@pytest.mark.parametrize(
    "library, allowed",
    [("casadi", {"export", "compiled", "agreement", "generation", "simulation", "console", "optimisation"})],
)
def test_heavy_libraries_stay_in_their_stages(library: str, allowed: set[str]) -> None:
    for path in modules():
        for node in ast.walk(ast.parse(path.read_text())):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            if library in names:
                assert stage_of(path) in allowed, path


def test_nothing_evaluates_text() -> None:
    forbidden = {"eval", "exec", "sympify", "parse_expr", "compile", "system", "popen"}
    for path in modules():
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call):
                name = getattr(node.func, "id", getattr(node.func, "attr", ""))
                of_a_library = isinstance(node.func, ast.Attribute) and getattr(node.func.value, "id", "") == "re"
                assert name not in forbidden or of_a_library, (path, name)
                assert not any(k.arg == "shell" for k in node.keywords), path


@pytest.mark.parametrize("name", ["three_ups_upu_s", "delta", "ur5"])
def test_every_symbol_has_unit_description_and_assumptions(name: str) -> None:
    symbols = [node.args[0] for node in derive(catalogue.load(name)).system.tape.symbols.values()]
    assert symbols
    for symbol in symbols:
        assert isinstance(symbol, Symbol)
        assert symbol.unit and symbol.description and symbol.sympy.is_real


def test_files_stay_readable() -> None:
    long = {str(p.relative_to(PACKAGE)): n for p in modules() if (n := len(p.read_text().splitlines())) > 450}
    assert not long
