"""Tables of README.md beside generated code: coordinates, statuses, conventions, recipes, size and how to shrink it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symscrew.description import Mechanism, markdown_text
from symscrew.export.c_files import family
from symscrew.export.c_form import library_sources
from symscrew.export.conventions import conventions
from symscrew.export.listing import plain
from symscrew.functions import PRESETS, preset, u_port
from symscrew.model import Model
from symscrew.program import status_texts

RECIPES: Sequence[tuple[str, Sequence[str]]] = (
    ("all coordinates from the independent ones", ("assemble",)),
    ("motor coordinates from a pose of the platform", ("drive_positions",)),
    ("all coordinates from a pose of the platform", ("inverse_kinematics",)),
    ("where points are, how fast they move", ("forward_kinematics", "point_motion")),
    ("all rates from the independent ones, then the accelerations", ("velocity", "acceleration")),
    ("motor speeds", ("drive_rates",)),
    ("the platform's twist from the rates of the tree", ("platform_jacobian",)),
    ("motor forces for a motion (computed torque), at v = a = 0 those that hold the weight", ("inverse_dynamics",)),
    ("the same from the independent coordinates", ("inverse_dynamics_independent",)),
    ("the same from the platform's motion", ("inverse_dynamics_platform",)),
    ("another share of redundant drives, or a preload", ("inverse_dynamics_preload",)),
    ("what bearings carry", ("joint_reactions",)),
    ("accelerations from forces (simulation)", ("forward_dynamics", "forward_dynamics_independent")),
    ("coordinates and rates back on the loops, once in a step of an integration", ("close_position", "close_velocity")),
    ("mass matrix, Coriolis and gravity forces of the tree", ("mass_matrix", "bias")),
    ("kinetic and potential energy", ("energy",)),
    ("distance from singularities", ("limb_margins", "constraint_margin", "actuation_margins")),
)
"""What somebody wants, and the functions that give it."""


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Lines of a table; its cells are Markdown already."""
    return [f"| {' | '.join(header)} |", "|" + "---|" * len(header), *(f"| {' | '.join(row)} |" for row in rows)]


def coordinate_tables(model: Model) -> list[str]:
    """Entries of q, v, u and y: index, name, unit, what it is; of q the value in the reference configuration."""
    tree, reference = model.system.tree, model.system.reference
    lines = ["## Coordinates", ""]
    rows = [
        [str(k), f"`{c.label}`", c.unit, _joint(model.mechanism, c.joint, c.kind), f"{reference[k]:.9g}"]
        for k, c in enumerate(tree.q)
    ]
    lines += ["`q`, the configuration of the spanning tree:", ""]
    lines += [*table(("k", "`q[k]`", "unit", "of", "in the reference"), rows), ""]
    if [c.label for c in tree.q] == [c.label for c in tree.v]:
        lines += ["`v` and `a` have the same entries, their rates and second rates.", ""]
    else:
        of_v = [
            [str(k), f"`{c.label}`", c.unit, _joint(model.mechanism, c.joint, c.kind)] for k, c in enumerate(tree.v)
        ]
        lines += ["`v`, the rates; `a`, their rates, has the same entries:", ""]
        lines += [*table(("k", "`v[k]`", "unit", "of"), of_v), ""]
    if model.independent:
        labels = [c.label for c in tree.q]
        of_y = [[str(k), f"`{name}`", f"`q[{labels.index(name)}]`"] for k, name in enumerate(model.independent)]
        lines += ["`y`, the independent coordinates, from which all others follow:", ""]
        lines += [*table(("k", "`y[k]`", "is"), of_y), ""]
    if not model.system.drives:
        return [*lines, "No drives: `u` is empty."]
    port = u_port(model.system)
    of_u = [[str(k), f"`{name}`", port.units[k], _freedom(model, k)] for k, name in enumerate(port.labels)]
    return [*lines, "`u`, the drives:", "", *table(("k", "`u[k]`", "unit", "of"), of_u)]


def _joint(mechanism: Mechanism, name: str, kind: str) -> str:
    """The joint of a coordinate, in words."""
    joint = mechanism.joints.get(name)
    what = {"quaternion": "quaternion of ", "rotation": "angular velocity of "}.get(kind, "")
    if joint is None:  # on which the package hangs the platform
        return f"{what}the platform against the ground"
    return f"{what}{joint.kind.name} joint `{name}`, `{joint.parent}` to `{joint.child}`"


def _freedom(model: Model, drive: int) -> str:
    name, freedom = model.system.drives[drive]
    joint = model.mechanism.joints[name]
    what = "slides" if joint.kind.freedoms[freedom].prismatic else "turns"
    return f"{joint.kind.name} joint `{name}`, `{joint.child}` {what} against `{joint.parent}`"


def status_table(model: Model) -> list[str]:
    """What functions return."""
    told = status_texts(*model.programs.values())
    own = [[str(code), markdown_text(plain(text.removesuffix("; all outputs are NaN")))] for code, text in told.items()]
    text = "Functions return one; above 0 is a failure, and all outputs are NaN then."
    return ["## Statuses", "", text, "", *table(("status", "means"), own)]


def convention_list(model: Model) -> list[str]:
    """What numbers mean."""
    lines = [f"- **{what}**: {text}" for what, text in conventions(model).items()]
    return ["## Conventions", "", *lines]


def recipe_table(model: Model) -> list[str]:
    """Which function gives what, of those that the model has."""
    rows = [
        [want, ", ".join(_call(model, name) for name in names if name in model.programs)]
        for want, names in RECIPES
        if any(name in model.programs for name in names)
    ]
    return ["## Recipes", "", *table(("you want", "call"), rows)] if rows else []


def _call(model: Model, name: str) -> str:
    program = model.programs[name]
    given, made = (", ".join(port.name for port in ports) for ports in (program.inputs, program.outputs))
    return f"`{name}({given}) -> {made}`"


def size_section(model: Model, files: Mapping[str, int]) -> list[str]:
    """What the code takes, and ways to have less of it. `files`: name -> bytes, of all files of the folder."""
    count, operations = _counts(model, tuple(model.programs))
    lines = ["## Size, and how to have less", "", f"{count} functions, {operations} operations."]
    sources = library_sources(files, model.name)
    if sources:
        kept = {source: _of_family(model, source) for source in sources}
        rows = [
            [f"`{source}`", f"{files[source] / 1e3:.0f} kB", *_counts(model, own or None)]
            for source, own in kept.items()
        ]
        lines += ["", *table(("source", "size", "functions", "operations"), rows)]
    if not model.selected:
        lines += ["", "Less of it, by `symscrew generate` again, or `model.only(...)` in Python:", ""]
        own = [
            [f"`--functions {name}`", about, *_counts(model, names)]
            for name, (about, _) in PRESETS.items()
            if (names := preset(name, model.programs))
        ]
        lines += table(("choose", "has", "functions", "operations"), own)
    lines += ["", *_ways(model, sources)]
    return lines


def _ways(model: Model, sources: Sequence[str]) -> list[str]:
    """What else makes the code smaller."""
    ways = ["- `--functions NAME ...`: these functions only, by the names above, beside presets or alone."]
    if f"{model.name}_batch.c" in sources:
        ways.append(
            f"- Leave `{model.name}_batch.c` out where you call one state at a time; of the other sources only the one "
            f"that holds a function and `{model.name}_support.c` are needed."
        )
    if sources:
        ways.append(
            "- `--profile microcontroller`: C of type float for one state at a time; `-Os` takes the least flash."
        )
    if model.system.cuts and not model.one_mode:
        ways.append("- `--one-mode`: for the operation mode of the reference configuration only.")
    return ways


def _of_family(model: Model, source: str) -> tuple[str, ...]:
    if source == f"{model.name}.c":
        return tuple(model.programs)
    return tuple(name for name in model.programs if source == f"{model.name}_{family(name)}.c")


def _counts(model: Model, names: Sequence[str] | None) -> list[str]:
    """How many functions, and operations of them all; nothing of a source without any."""
    if names is None:
        return ["", ""]
    return [str(len(names)), str(sum(model.programs[name].operations["total"] for name in names))]
