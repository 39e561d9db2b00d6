"""Regressor of the inertial parameters: generalised forces are linear in them, Y(q, v, a) pi.

The rate of a body's momentum screw is linear in its ten inertial parameters, referred to the frame that lies
in the absolute one (origin O, absolute axes) while the mechanism is in its reference configuration and moves
with the body:

    m, m c_x, m c_y, m c_z, I_xx, I_xy, I_xz, I_yy, I_yz, I_zz      (c: centre of mass, I: inertia about O)

With omega, alpha the body's rates, a_O the acceleration of its point at O and U = [alpha]x + [omega]x^2, all in
that frame, force = m a_O + U (m c) and moment = (m c) x a_O + I alpha + omega x I omega. A joint's unit screw,
carried to the same frame, takes its share of both: one dot product per joint, body and parameter.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from symscrew.algebra import (
    ZERO,
    Guard,
    Node,
    Vector,
    add,
    cross,
    differentiate,
    dot,
    magnitude,
    transform,
)
from symscrew.dynamics import Admissible, solve_symmetric
from symscrew.effects import Acting, Effect
from symscrew.functions.closing import guarded
from symscrew.functions.derivative import null_space
from symscrew.functions.forward import driven
from symscrew.functions.kinematic import moving_bodies
from symscrew.functions.ports import a_port, drive_label, function, q_port, u_port, v_port, y_port
from symscrew.kinematics import GROUND, Link, Rates, System, acceleration_matrix
from symscrew.loops import Loops
from symscrew.program import Function, Port

PARAMETERS = ("m", "mcx", "mcy", "mcz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz")
UNITS = ("kg", *("kg m",) * 3, *("kg m^2",) * 6)
PRODUCTS = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
WHAT = "parameters of every body about O in absolute axes of the reference configuration"
REACHED = 1e-9
"""Singular values of how drives push freedoms below this, relative to the largest entry, leave a freedom without drive:
then there is no regressor of the drives. Rounding leaves 1e-15; a drive that weak would need 1e9 times the force."""

CARRIES = 1e-12  # squares of a freedom's drives below this are none; the check by singular values follows

Columns = dict[int, list[Node]]  # index into v -> the ten entries of a body


def parameter_labels(system: System) -> tuple[str, ...]:
    """Ten labels per moving body, in the order of the description."""
    return tuple(f"{body}.{p}" for body in moving_bodies(system) for p in PARAMETERS)


def regressor_functions(system: System, effects: Sequence[Effect], loops: Loops) -> list[Function]:
    """`regressor` of the tree, `regressor_independent` along the closure, `regressor_drives`."""
    acting = Acting(system, effects)
    tree = _tree_rows(system, acting)
    state = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v), (a_port(system), system.inputs.a)]
    rows = tuple(c.label for c in system.tree.v)
    units = tuple("N" if c.kind == "length" else "N m" for c in system.tree.v)
    text = "Generalised forces of the tree per inertial parameter: what inertia and gravity need on every freedom."
    made = [function(system, "regressor", text, inputs=_needed([*state, *acting.inputs], tree),
                     outputs=[_output(system, "regressor", rows=rows, units=units, entries=tree)])]  # fmt: skip
    if system.cuts:
        made.append(_independent(system, effects, loops))
    if system.drives:
        made += _drives(system, acting, loops, tree=tree, state=state)
    return made


def _independent(system: System, effects: Sequence[Effect], loops: Loops) -> Function:
    """N^T Y: along the closure only these combinations can be seen from the drives."""
    y_dot, y_ddot = loops.inputs("ydot"), loops.inputs("yddot")
    w = loops.rates_from(y_dot)
    moving = system.at(system.inputs.q, {}, system.tree_rates(w))
    a = system.tree_rates(loops.accelerations_from(y_ddot, loops.bias(moving), w))
    acting = Acting(system.at(system.inputs.q, {}, moving.inputs.v, a), effects)
    rows = _projected(null_space(system, loops), _tree_rows(acting.system, acting))
    inputs = [(q_port(system), system.inputs.q), (y_port(loops, "y_dot", 1), y_dot),
              (y_port(loops, "y_ddot", 2), y_ddot), *acting.inputs]  # fmt: skip
    units = tuple("N" if system.tree.q[e.q].unit == "m" else "N m" for e in loops.entries)
    text = "Generalised forces along the independent coordinates per inertial parameter: null_space^T regressor."
    output = _output(system, "regressor", rows=loops.labels, units=units, entries=rows)
    return function(
        system,
        "regressor_independent",
        text,
        inputs=_needed(inputs, rows),
        outputs=[output],
        guards=guarded(loops.guards),
    )


def _drives(
    system: System,
    acting: Acting,
    loops: Loops,
    *,
    tree: Sequence[Sequence[Node]],
    state: Sequence[tuple[Port, Sequence[Node]]],
) -> list[Function]:
    """Drives of smallest sum of squares per inertial parameter; nothing where freedoms carry no drive."""
    found = _distribution(system, loops)
    if found is None:
        return []
    admissible, distribution, guards = found
    along = _projected(admissible.tree_columns, tree)
    rows = [[_inner(system, row, column) for column in zip(*along, strict=True)] for row in distribution]
    labels = tuple(drive_label(system, k) for k in range(len(system.drives)))
    text = "Drives of smallest sum of squares per inertial parameter, from a consistent state."
    output = _output(system, "regressor", rows=labels, units=u_port(system).units, entries=rows)
    every = guarded((*loops.guards, *guards))
    return [
        function(
            system,
            "regressor_drives",
            text,
            inputs=_needed([*state, *acting.inputs], rows),
            outputs=[output],
            guards=every,
        )
    ]


def _distribution(system: System, loops: Loops) -> tuple[Admissible, list[list[Node]], list[Guard]] | None:
    """P in u = P r, r the generalised forces along the free joint rates: P = B (B^T B)^-1, B^T u = r."""
    tape = system.tape
    admissible = Admissible(system, loops)
    acting, inputs = driven(system, ())
    residual = admissible.residual(system.inputs.a, acting)
    nodes = inputs[0][1]
    keys = [str(k) for k in range(len(nodes))]
    seeds = {node: {key: -tape.one} for node, key in zip(nodes, keys, strict=True)}
    transposed = differentiate(tape, residual, seeds, keys)
    normal = [[_inner(system, x, y) for y in transposed] for x in transposed]
    sizes = [magnitude(tape, normal[i][i], 1.0)[1] for i in range(len(normal))]
    if not residual or len(residual) > len(nodes) or min(sizes) < CARRIES or not _regular(system, transposed):
        return None
    units = [[tape.one if i == k else tape.zero for i in range(len(normal))] for k in range(len(normal))]
    guards: tuple[Guard, ...] = ()
    inverse = []
    for unit in units:
        column, guards = solve_symmetric(tape, normal, unit, [1.0 / s for s in sizes])
        inverse.append(column)
    columns = list(zip(*transposed, strict=True))
    return admissible, [[_inner(system, b, x) for x in inverse] for b in columns], list(guards)


def _regular(system: System, rows: Sequence[Sequence[Node]]) -> bool:
    """Whether the drives reach every freedom, at the sample states."""
    samples = [[np.broadcast_to(system.tape.sample(n), len(system.sample_states[0])) for n in row] for row in rows]
    matrix = np.moveaxis(np.array(samples), -1, 0)
    return bool(np.all(np.linalg.matrix_rank(matrix, tol=REACHED * float(np.abs(matrix).max())) == len(rows)))


def _output(
    system: System, name: str, *, rows: Sequence[str], units: Sequence[str], entries: Sequence[Sequence[Node]]
) -> tuple[Port, list[Node]]:
    labels = parameter_labels(system)
    by = UNITS * (len(labels) // 10)
    port = Port(
        name,
        (len(rows), len(labels)),
        tuple(f"{u}/({b})" for b in by for u in units),
        tuple(f"{row}|{label}" for label in labels for row in rows),
        f"columns: {WHAT}",
    )
    return port, [row[k] for k in range(len(labels)) for row in entries]


def _needed(
    inputs: Sequence[tuple[Port, Sequence[Node]]], rows: Sequence[Sequence[Node]]
) -> list[tuple[Port, Sequence[Node]]]:
    """The state, and what else the entries depend on: loads are no part of a regressor."""
    seen: set[int] = set()
    stack = [node for row in rows for node in row]
    while stack:
        node = stack.pop()
        if node.index not in seen and node.value is None:
            seen.add(node.index)
            stack.extend(() if node.op == "symbol" else node.args)
    return [*inputs[:3], *((p, n) for p, n in inputs[3:] if any(node.index in seen for node in n))]


def _projected(columns: Sequence[Sequence[Node]], rows: Sequence[Sequence[Node]]) -> list[list[Node]]:
    """Combinations of rows: one per column of weights."""
    count = len(rows[0]) if rows else 0
    system_zero = [row[0].tape.zero for row in rows[:1]] * count
    result = []
    for column in columns:
        total = list(system_zero)
        for weight, row in zip(column, rows, strict=True):
            if weight is not weight.tape.zero:
                total = [t + weight * entry for t, entry in zip(total, row, strict=True)]
        result.append(total)
    return result


def _inner(system: System, x: Sequence[Node], y: Sequence[Node]) -> Node:
    total = system.tape.zero
    for a, b in zip(x, y, strict=True):
        total = total + a * b
    return total


# -- the tree -----------------------------------------------------------------------------------------------------


def _tree_rows(system: System, acting: Acting) -> list[list[Node]]:
    """Entries [index into v][parameter] at the system's present nodes."""
    tape, tree = system.tape, system.tree
    rates = acting.link_rates(system.inputs.a)
    bodies = moving_bodies(system)
    rows = [[tape.zero] * (10 * len(bodies)) for _ in tree.v]
    screws: dict[int, Mapping[int, tuple[Vector, Vector]]] = {GROUND: {}}
    for link in tree.links[1:]:
        screws[link.index] = _screws(system, link, screws[link.parent])
    entries: dict[int, Columns] = {}
    for position, body in enumerate(bodies):
        index = tree.link_of_body[body]
        if index == GROUND:
            continue
        if index not in entries:
            entries[index] = _link_columns(system, index, screws[index], rates[index])
        for k, values in entries[index].items():
            rows[k][10 * position : 10 * position + 10] = values
    return rows


def _screws(system: System, link: Link, inner: Mapping[int, tuple[Vector, Vector]]) -> dict[int, tuple[Vector, Vector]]:
    """Unit screws (angular, linear at the link's origin; link axes) of all freedoms from the ground to a link."""
    placed, frame = system.placed[link.index], system.frames[link.index]
    result = {
        k: (placed.outwards(angular), placed.outwards(add(linear, cross(angular, placed.offset))))
        for k, (angular, linear) in inner.items()
    }
    own = [(screw.angular, screw.linear) for screw in link.pair.unit_screws(frame)]
    return {**result, **dict(zip(range(link.v.start, link.v.stop), own, strict=True))}


def _link_columns(system: System, index: int, screws: Mapping[int, tuple[Vector, Vector]], rate: Rates) -> Columns:
    """The ten entries of a body on this link, for every freedom inside of it."""
    frame, tape = system.frames[index], system.tape
    at = system.local_point(index, ZERO)
    omega, alpha = transform(frame.axes, rate.omega), transform(frame.axes, rate.alpha)
    origin = transform(frame.axes, rate.at(at))
    matrix = acceleration_matrix(omega, alpha)
    moments = [_inertial_moment(i, j, omega, alpha) for i, j in PRODUCTS]
    result: Columns = {}
    for k, (angular, linear) in screws.items():
        turn = transform(frame.axes, angular)
        slide = transform(frame.axes, add(linear, cross(angular, at)))
        across = cross(origin, turn)  # turn . (e_i x origin) = e_i . (origin x turn)
        values: list[object] = [dot(slide, origin)]
        values += [dot(slide, (matrix[0][i], matrix[1][i], matrix[2][i])) + across[i] for i in range(3)]
        values += [dot(turn, moment) for moment in moments]
        result[k] = [tape.node(v) for v in values]
    return result


def _inertial_moment(i: int, j: int, omega: Vector, alpha: Vector) -> Vector:
    """E alpha + omega x E omega for the symmetric unit matrix E with ones at (i, j) and (j, i)."""

    def times(vector: Vector) -> Vector:
        values = [0, 0, 0]
        values[i] = vector[j]
        values[j] = vector[i]
        return (values[0], values[1], values[2])

    return add(times(alpha), cross(omega, times(omega)))
