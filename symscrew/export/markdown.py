"""`model.md`: what a person reads of a model. Screws, momentum screws, equations, symbols with their units.

Screws are at O in absolute axes, as columns (omega ; v) or (f ; m), and all parameters are symbols. A formula
comes in collected form, with its intermediate results z below it; one with more than `READABLE` operations is
named with its size instead, and `symscrew.functions.quantities` prints it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import sympy

from symscrew.description import Mechanism, Vector, markdown_text, to_text
from symscrew.errors import DescriptionError
from symscrew.export.latex import markdown, matrix_latex
from symscrew.export.listing import banner, plain
from symscrew.functions import Quantities, Quantity
from symscrew.model import Model
from symscrew.paper_formulas import paper_formulas

READABLE = 120  # operations of a formula that is printed: two lines or three; of more only their number is


def print_markdown(model: Model) -> dict[str, str]:
    """File name to text: `model.md`."""
    mechanism = model.mechanism
    quantities = Quantities(mechanism)
    lines = [f"# Model of {model.name}", "", *(f"{markdown_text(plain(line))}  " for line in banner(model)), ""]
    lines += ["Equation numbers are those of the source paper.", ""] if "paper" in mechanism.source else []
    lines += [*_bodies(mechanism), "", *_joints(mechanism), ""]
    shown = [*_screws(mechanism, quantities), *_loops(model, quantities), *_momenta(mechanism, quantities)]
    used = {symbol for title, quantity in shown if quantity is not None for symbol in _symbols_in(quantity)}
    lines += [*_symbols(quantities, used), ""]
    for title, quantity in shown:
        lines += [title, ""] if quantity is None else [_formula(title, quantity)]
    lines += [*_equations(model), *_for_a_paper(mechanism)]
    return {"model.md": "\n".join([*lines, ""])}


def _for_a_paper(mechanism: Mechanism) -> list[str]:
    """The formulas of `symscrew formulas`; none where no chain leads to the platform."""
    try:
        paper = paper_formulas(mechanism)
    except DescriptionError:
        return []
    said = (
        "In the names of an author, screws at O in the present configuration; `symscrew formulas` writes them as LaTeX."
    )
    return ["", "## Formulas for a paper", "", said, "", paper.markdown(level=3)]


def _table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    cells = ([re.sub(r"(?<!\\)\|", r"\|", cell) for cell in row] for row in (header, ["---"] * len(header), *rows))
    return ["| " + " | ".join(row) + " |" for row in cells]


def _bodies(mechanism: Mechanism) -> list[str]:
    rows = []
    for body in mechanism.bodies.values():
        mass = "" if body.mass is None else _expression(body.mass)
        com = "" if body.com is None else _vector(body.com)
        inertia = "" if body.inertia is None else "; ".join(_vector(row) for row in body.inertia)
        rows.append([body.name + (" (ground)" if body.name == mechanism.ground else ""), mass, com, inertia])
    header = ("body", "mass [kg]", "centre of mass [m]", "inertia about it [kg m^2]")
    return ["## Bodies", "", *_table(header, rows)]


def _joints(mechanism: Mechanism) -> list[str]:
    rows = [
        [
            joint.name,
            joint.kind.name,
            f"{joint.parent} to {joint.child}",
            _vector(joint.point),
            "; ".join(_vector(axis) for axis in joint.axes),
            ", ".join(str(k + 1) for k in joint.driven),
        ]
        for joint in mechanism.joints.values()
    ]
    header = ("joint", "type", "bodies", "point [m]", "axes", "driven freedoms")
    return ["## Joints, in the reference configuration", "", *_table(header, rows)]


def _vector(vector: Vector) -> str:
    return "(" + ", ".join(_expression(entry) for entry in vector) + ")"


def _expression(expression: sympy.Expr) -> str:
    text = to_text(expression)
    return (
        f"`{text}`" if len(text) <= 60 else f"`{float(expression.evalf(17)):.12g}`" if expression.is_number else "..."
    )


def _screws(mechanism: Mechanism, quantities: Quantities) -> Iterator[tuple[str, Quantity | None]]:
    yield "## Joint screws", None
    yield (
        "Unit screws of every freedom as columns, angular part first; the twist of a body is their sum, eq. (6).",
        None,
    )
    for joint in mechanism.joints:
        yield f"Joint {joint}", quantities.joint_screws(joint)


def _loops(model: Model, quantities: Quantities) -> Iterator[tuple[str, Quantity | None]]:
    cuts = [cut.joint.name for cut in quantities.system.cuts]
    if not cuts:
        return
    yield "## Loops", None
    yield "Reciprocal wrenches (f ; m) of the joints that close the loops: what they cannot move along.", None
    for joint in cuts:
        yield f"Joint {joint}", quantities.constraints(joint)


def _momenta(mechanism: Mechanism, quantities: Quantities) -> Iterator[tuple[str, Quantity | None]]:
    massive = [
        body.name for body in mechanism.bodies.values() if body.mass is not None and body.name != mechanism.ground
    ]
    if not massive:
        return
    yield "## Momentum screws", None
    text = "Linear momentum p and angular momentum L about O of every body with mass m, from its twist (omega ; v), its"
    text += " centre c and its inertia J about c, all at the present configuration, eq. (31):\n\n"
    text += markdown("p", r"m\,(v + \omega \times c)") + markdown("L_O", r"J\,\omega + c \times p").rstrip()
    yield text, None
    for body in massive:
        yield f"Body {body}", quantities.momentum(body)


def _formula(title: str, quantity: Quantity) -> str:
    size = _operations(quantity)
    if size > READABLE:
        return f"{title}: {size} operations, too many to read here.\n"
    names = _names(quantity)
    text = markdown(quantity.name, matrix_latex(quantity.matrix, names))
    for symbol, expression in quantity.definitions:
        text += markdown(names[symbol], sympy.latex(expression, symbol_names=names))
    return f"{title}\n\n{text}"


def _operations(quantity: Quantity) -> int:
    parts = [*quantity.matrix, *(expression for _, expression in quantity.definitions)]
    return int(sum(sympy.count_ops(part) for part in parts))


def _names(quantity: Quantity) -> dict[sympy.Symbol, str]:
    names = {symbol: text for symbol, text, _, _ in quantity.symbols}
    return names | {symbol: f"z_{{{str(symbol)[1:]}}}" for symbol, _ in quantity.definitions}


def _symbols_in(quantity: Quantity) -> set[sympy.Symbol]:
    if _operations(quantity) > READABLE:
        return set()
    parts = [*quantity.matrix, *(expression for _, expression in quantity.definitions)]
    return {symbol for part in parts for symbol in part.free_symbols}


def _symbols(quantities: Quantities, used: set[sympy.Symbol]) -> list[str]:
    """The symbols of the formulas; z belong to the formula that they stand below."""
    any_joint = next(iter(quantities.mechanism.joints))
    known = quantities.joint_screws(any_joint).symbols
    rows = [
        [f"${latex}$", markdown_text(plain(unit)), markdown_text(plain(text))]
        for symbol, latex, unit, text in known
        if symbol in used
    ]
    return ["## Symbols", "", *_table(("symbol", "unit", "meaning"), rows)]


def _equations(model: Model) -> list[str]:
    """The equations behind the functions, in the sizes of this mechanism."""
    system = model.system
    n, m = len(system.tree.v), len(system.drives)
    rows = sum(len(cut.rows) for cut in system.cuts)
    lines = ["## Equations", "", f"Tree: {n} rates v, {m} drives u" + (f", {rows} loop closures." if rows else "."), ""]
    lines += ["The rate of each body's momentum screw is the sum of the wrenches on it, eq. (35):", ""]
    lines += [markdown(r"\dot M_i", r"\sum_j W_{ij}")]
    lines += ["In the rates of the tree, with the mass matrix M (`mass_matrix`) and the forces h (`bias`):", ""]
    if not rows:
        return [*lines, markdown(r"M(q)\,a + h(q, v)", "B u")]
    lines += [markdown(r"M(q)\,a + h(q, v)", r"B(q)\,u + J(q)^{T} \lambda")]
    lines += ["The loops stay closed (`closure`, `closure_jacobian`, `closure_bias`):", ""]
    lines += [markdown(r"J(q)\,v", "0"), markdown(r"J(q)\,a + b(q, v)", "0")]
    lines += [
        "The columns of N (`null_space`) are the motions of the independent coordinates y; the drives follow from",
        "",
    ]
    return [*lines, markdown(r"v = N \dot y, \qquad N^{T} (M a + h)", "N^{T} B u")]
