"""What stands in a report, section by section."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import sympy

from symscrew import __version__
from symscrew.algebra import IDENTITY, Vector, cross, dot, scale
from symscrew.description import Joint, Mechanism
from symscrew.display import Progress
from symscrew.kinematics import motion_screws
from symscrew.mobility import Mobility, analyse_mobility, formulas, key_figures, mathml, sections, signs_ahead
from symscrew.model import Model
from symscrew.program import Iteration
from symscrew.reporting import margin_maps
from symscrew.reporting.blocks import Block, Bullets, Document, Picture, Section, Table, Text
from symscrew.reporting.motion_pages import motion_section, sweep_section
from symscrew.reporting.paper_section import formula_sections
from symscrew.reporting.study_pages import accuracy_section, bill_section
from symscrew.studies import Bill, Times
from symscrew.studies.given_motion import DriveStudy
from symscrew.studies.workspace import Call, Sweep

LONG_SCREW = 160  # characters of LaTeX: a longer screw does not fit the page, and is given by number
SIGNIFICANT = ("inverse_dynamics", "forward_dynamics", "joint_reactions")


def document(
    model: Model,
    *,
    call: Call | None = None,
    times: Mapping[str, Times] | None = None,
    accuracy: Path | None = None,
    bill: Bill | None = None,
    motion: DriveStudy | None = None,
    sweep: Sweep | None = None,
    progress: Progress | None = None,
) -> Document:
    """The report of a model.

    Args:
        model: the mechanism with the effects that act on it.
        call: evaluates its functions; default: those that are needed, compiled.
        times: quartiles of nanoseconds per call by function; empty where no compiler could make them, None where
            nobody asked.
        accuracy: a directory that `symscrew accuracy` wrote.
        bill: what the effects of a scene cost.
        motion: what a motion needs of the drives.
        sweep: a map over the workspace.
        progress: for messages.

    Raises:
        DescriptionError: a directory without results.
    """
    progress = progress or Progress(quiet=True)
    mechanism = model.mechanism
    with progress.step("mobility"):
        found = analyse_mobility(mechanism)
        mobility = _mobility(found)
        known = formulas(found)
    screws, more = _screws(mechanism)
    with progress.step("formulas"):
        paper, of_paper = formula_sections(mechanism)
    made = [
        Section("Overview", tuple(_overview(model, found))),
        *mobility,
        Section("Joint screws", tuple(screws)),
        *paper,
        Section("Size and cost of the model", tuple(_size(model, times))),
        Section("Generated functions", tuple(_functions(model, times or {}))),
    ]
    with progress.step("singularities"):
        made.append(Section("Singularities", tuple(_singularities(model, found, call or margin_maps.compiled(model)))))
    made += [motion_section(motion)] if motion is not None else []
    made += [sweep_section(sweep)] if sweep is not None else []
    if accuracy is not None:
        made += accuracy_section(accuracy)
    if bill is not None:
        made.append(bill_section(bill))
    notes = tuple(note for note in model.notes if note not in mechanism.warnings)
    if notes:
        made.append(Section("Notes", (Bullets(notes),)))
    subtitle = "; ".join(t for t in (mechanism.description, mechanism.source) if t) or "Report of a mechanism"
    footer = f"symscrew {__version__}. SI units; vectors in absolute axes, screws at the origin O."
    return Document(f"Mechanism {model.name}", subtitle, tuple(made), {**known, **more, **of_paper}, footer)


# -- overview and mobility --------------------------------------------------------------------------------


def _overview(model: Model, found: Mobility) -> list[Block]:
    mechanism = model.mechanism
    driven = [f"{n} ({j.kind.name})" for n, j in mechanism.joints.items() if j.driven]
    count = sum(len(j.driven) for j in mechanism.joints.values())
    facts = [
        ("bodies that move", str(len(mechanism.bodies) - (mechanism.ground in mechanism.bodies))),
        ("joints", f"{len(mechanism.joints)}: {_kinds(mechanism)}"),
        ("independent loops", str(len(found.network.chords))),
        ("finite mobility", dict(key_figures(found))["finite mobility"]),
        ("drives", f"{count}: {', '.join(driven)}" if driven else "none"),
        ("effects in the dynamics", ", ".join(type(e).__name__ for e in model.effects) or "none"),
        ("characteristic length", f"{model.system.length:.6g} m (divides lengths where they meet angles)"),
    ]
    rows = tuple((what, value) for what, value in facts)
    blocks: list[Block] = [_picture(mechanism), Table(("", ""), rows)]
    if mechanism.warnings:
        blocks.append(Bullets(_gathered(mechanism.warnings), "warning"))
    if mechanism.parameters:
        lines = tuple(
            (
                f"${sympy.latex(p.symbol)}$",
                _number(float(p.value)),
                p.unit,
                p.description,
                "input" if p.run_time else "baked in",
            )
            for p in mechanism.parameters.values()
        )
        blocks.append(Table(("parameter", "value", "unit", "", "in the code"), lines, frozenset({1})))
    masses = [
        (n, *(_number(float(mechanism.number(x))) for x in (b.mass, *b.com)))
        for n, b in mechanism.bodies.items()
        if b.mass is not None and b.com is not None
    ]
    if masses:
        header = ("body", "mass [kg]", "centre of mass x [m]", "y [m]", "z [m]")
        blocks.append(Table(header, tuple(masses), frozenset({1, 2, 3, 4}), "Masses, in the reference configuration"))
    return blocks


def _gathered(warnings: Sequence[str]) -> tuple[str, ...]:
    """Warnings in which what is said of several places stands once.

    >>> _gathered(("bodies.a: heavy", "bodies.b: heavy", "loose"))
    ('bodies.a, bodies.b: heavy', 'loose')
    """
    places: dict[str, list[str]] = {}
    for warning in warnings:
        place, colon, what = warning.partition(": ")
        places.setdefault(what if colon else warning, []).extend([place] if colon else [])
    return tuple(", ".join(where) + ": " * bool(where) + what for what, where in places.items())


def _kinds(mechanism: Mechanism) -> str:
    kinds: dict[str, int] = {}
    for joint in mechanism.joints.values():
        kinds[joint.kind.name] = kinds.get(joint.kind.name, 0) + 1
    return ", ".join(f"{count} {kind}" for kind, count in kinds.items())


def _picture(mechanism: Mechanism) -> Picture:
    from symscrew.display import mechanism_figure

    return Picture(
        "mechanism", svg(mechanism_figure(mechanism)), "Reference configuration, absolute axes at O.", width=62
    )


def svg(figure: Any) -> bytes:
    """A figure as SVG text, letters as outlines, equal for equal figures."""
    import matplotlib

    from symscrew.display import curve_style

    out = io.BytesIO()
    with curve_style(), matplotlib.rc_context({"svg.hashsalt": "symscrew", "svg.fonttype": "path"}):
        figure.savefig(out, format="svg", bbox_inches="tight", pad_inches=0.04, metadata={"Date": None})
    return out.getvalue()


def _mobility(found: Mobility) -> list[Section]:
    table = Table(("", ""), tuple(key_figures(found)))
    result = [Section("Mobility", (table,))]
    for title, lines in sections(found):
        if title.startswith("How far from"):
            continue  # the section on singularities has them
        result.append(Section("In words" if title == "Mobility" else title, (Bullets(tuple(lines)),), level=3))
    return [*result, Section("To check and to cite", (Bullets(SOURCES),), level=3)]


SOURCES = (
    "What is proved: symscrew mobility NAME --proof FILE writes it as exact numbers, and a checker that needs Python "
    "alone judges it: python -m symscrew.mobility.proofs.proof_checker FILE",
    "Screws at O, reciprocal wrenches, momentum screws: J.-S. Zhao, X.-C. Sun, S.-T. Wei, Machines 11(8) (2023) 840",
    "Classes of screw systems: C. G. Gibson, K. H. Hunt, Mech. Mach. Theory 25 (1990) 1-27",
    "Singularities: C. Gosselin, J. Angeles, IEEE Trans. Robotics Autom. 6 (1990) 281-290; of constraints D. Zlatanov, "
    "I. Bonev, C. Gosselin, IEEE ICRA 2002, 496-502",
    "Counts: G. Gogu, Structural Synthesis of Parallel Robots 1 (2008); Z. Huang, Q. Li, H. Ding, Theory of Parallel "
    "Mechanisms (2013); K. J. Waldron, J. Mechanisms 1 (1966) 191-212",
)
"""How the section is checked without this package's judgement, and the literature of its words."""


# -- screws -----------------------------------------------------------------------------------------------


def _screws(mechanism: Mechanism) -> tuple[list[Block], dict[str, str]]:
    """Unit screws of all joints in the reference configuration, in the parameters; with the formulas' MathML."""
    intro = (
        "Unit screws $(\\omega ; v_O)$ at the origin O in the reference configuration, from parent to child: "
        "a rotation about $e$ through $r$ is $(e ; r \\times e)$, a translation along $e$ is $(0 ; e)$."
    )
    known = {
        "(\\omega ; v_O)": "<math><mo>(</mo><mi>&#x3C9;</mi><mo>;</mo><msub><mi>v</mi><mi>O</mi></msub>"
        "<mo>)</mo></math>",
        "e": "<math><mi>e</mi></math>",
        "r": "<math><mi>r</mi></math>",
        "(e ; r \\times e)": "<math><mo>(</mo><mi>e</mi><mo>;</mo><mi>r</mi><mo>&#xD7;</mo><mi>e</mi><mo>)</mo></math>",
        "(0 ; e)": "<math><mo>(</mo><mn>0</mn><mo>;</mo><mi>e</mi><mo>)</mo></math>",
    }
    known |= {sympy.latex(p.symbol): mathml(p.symbol) for p in mechanism.parameters.values()}
    groups = {limb.name: list(limb.joints) for limb in mechanism.limbs.values()}
    listed = {name for names in groups.values() for name in names}
    rest = [name for name in mechanism.joints if name not in listed]
    if rest:
        groups["other joints" if groups else "joints"] = rest
    blocks: list[Block] = [Text(intro)]
    for title, names in groups.items():
        rows = []
        for name in names:
            joint = mechanism.joints[name]
            for k, screw in enumerate(_unit_screws(joint)):
                text, markup = _screw(screw, mechanism)
                known[text] = markup
                rows.append((f"{name}{f'.{k}' if joint.kind.freedom > 1 else ''}", _motion(joint, k), f"${text}$"))
        blocks.append(Table(("joint", "motion", "unit screw"), tuple(rows), caption=title))
    return blocks, known


def _motion(joint: Joint, k: int) -> str:
    return f"{joint.kind.freedoms[k].name}{', driven' if k in joint.driven else ''}"


def _unit_screws(joint: Joint) -> list[sympy.Matrix]:
    axes = joint.kind.motion_axes(joint.axes, IDENTITY, _across)
    made = motion_screws(joint.kind, axes, joint.point, joint.pitch)
    return [sympy.Matrix(twist.components) for _, twists in made for twist in twists]


def _across(normal: Vector) -> tuple[Vector, Vector]:
    """Two unit vectors that complete a normal to a triad."""
    flat = cross(normal, (0, 0, 1))
    first = scale(1 / sympy.sqrt(dot(flat, flat)), flat) if any(flat) else (1, 0, 0)
    return first, cross(normal, first)


def _screw(screw: sympy.Matrix, mechanism: Mechanism) -> tuple[str, str]:
    """(LaTeX, MathML) of a screw; in numbers where the symbols would be long."""
    entries = [sympy.simplify(c) for c in screw]
    if sum(len(sympy.latex(c)) for c in entries) > LONG_SCREW:
        entries = [sympy.Float(f"{float(mechanism.number(c)):.6g}") if c else c for c in entries]
        entries = [sympy.Integer(c) if c == int(c) else c for c in entries]
    entries = [signs_ahead(c) for c in entries]
    text = (
        r"\left("
        + ", ".join(map(sympy.latex, entries[:3]))
        + r";\; "
        + ", ".join(map(sympy.latex, entries[3:]))
        + r"\right)"
    )
    cells = [mathml(c).removeprefix("<math>").removesuffix("</math>") for c in entries]
    comma = '<mo separator="true">,</mo>'
    return text, f"<math><mo>(</mo>{comma.join(cells[:3])}<mo>;</mo>{comma.join(cells[3:])}<mo>)</mo></math>"


# -- size, functions --------------------------------------------------------------------------------------


def _size(model: Model, asked: Mapping[str, Times] | None) -> list[Block]:
    tree, times = model.system.tree, asked or {}
    rows = [
        ("coordinates q, rates v of the tree", f"{len(tree.q)}, {len(tree.v)}"),
        (
            "closure constraints",
            f"{sum(len(c.rows) for c in model.system.cuts)} at {len(model.system.cuts)} cut joints",
        ),
        ("run-time parameters", str(len(model.system.parameter_values))),
        ("functions", str(len(model.programs))),
        ("operations of all functions", str(sum(p.operations["total"] for p in model.programs.values()))),
    ]
    for name in SIGNIFICANT:
        if name in model.programs:
            time = f"; {_time(times[name])} ns" if name in times else ""
            rows.append((name, f"{model.programs[name].operations['total']} operations{time}"))
    note = "Operations: each +, -, x, /, root, sine or cosine and comparison counts 1, status checks included."
    if times:
        note += (
            " Times: nanoseconds per call in compiled C, one state of a batch of 64, median (quartiles) of 41 rounds "
            "on this machine."
        )
    elif asked is not None:
        note += " Nothing is timed: there is no C compiler here (apt install gcc)."
    return [Table(("", ""), tuple(rows)), Text(note, "note")]


def _time(found: Times) -> str:
    return f"{_short(found.median)} ({_short(found.lower)} \u2026 {_short(found.upper)})"


def _short(value: float) -> str:
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}"


def _functions(model: Model, times: Mapping[str, Times]) -> list[Block]:
    rows = []
    for name, program in model.programs.items():
        inputs = ", ".join(p.name for p in program.inputs)
        outputs = ", ".join(f"{p.name} [{' x '.join(map(str, p.shape))}]" for p in program.outputs)
        per = " per step" if isinstance(program, Iteration) else ""
        row = (f"{name}({inputs})", outputs, f"{program.operations['total']}{per}")
        rows.append((*row, _time(times[name]) if name in times else "-") if times else row)
    header = ("function (inputs)", "outputs [size]", "operations", *(("ns per call",) if times else ()))
    return [Table(header, tuple(rows), frozenset({2, 3}))]


# -- singularities ----------------------------------------------------------------------------------------


def _singularities(model: Model, found: Mobility, call: Call) -> list[Block]:
    blocks: list[Block] = [
        Text(
            "A volume of screws or wrenches, with lengths divided by the characteristic length, is 0 exactly at a "
            "singularity of its kind, and signed ones change their sign there. A margin is the volume as a part of its "
            "value in the reference configuration: 1 there, 0 at a singularity, as in maps and in the view. Limb: "
            "joint screws of a limb become dependent. Constraint: a freedom appears whatever the drives do. Actuation: "
            "a freedom is left with these drives locked."
        )
    ]
    values = found.singularities.margins or ()
    rows = tuple((v.kind, v.name, _number(v.value), v.form, "singular here" if v.singular else "") for v in values)
    if rows:
        header = ("kind", "of", "volume", "form", "")
        blocks.append(Table(header, rows, frozenset({2}), "In the reference configuration"))
    else:
        blocks.append(Text("This mechanism has no margins: no limb and no loop whose rank could be lost."))
    figure = margin_maps.figure(model, call)
    if figure is not None:
        text = (
            "Margins along each independent coordinate, the others as in the reference configuration: 0 is a "
            "singularity. Curves end where the loops cannot be closed."
        )
        if rest := margin_maps.left_out(model):
            text += f" Not drawn: {', '.join(rest)}."
        blocks.append(Picture("margins", svg(figure), text))
    elif rows:
        blocks.append(
            Text("Every volume is 0 in the reference configuration: there is nothing to compare others with.")
        )
    return blocks


def _number(value: float) -> str:
    text = f"{float(np.float64(value)):.5g}"
    return "0" if text in ("-0", "0") else text.replace("-", "\u2212")
