"""Ports that many functions share: coordinates, rates, screws, with their units and labels."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import Node, inputs_of
from symscrew.kinematics import ROUNDED, System, squared_length
from symscrew.loops import Loops
from symscrew.program import NO_ROTATION, QUATERNION, Function, NodeLimit, Port

TWIST_UNITS = ("rad/s",) * 3 + ("m/s",) * 3
TWIST_LABELS = ("wx", "wy", "wz", "vx", "vy", "vz")
TWIST_RATE_UNITS = ("rad/s^2",) * 3 + ("m/s^2",) * 3
WRENCH_UNITS = ("N",) * 3 + ("N m",) * 3
WRENCH_LABELS = ("fx", "fy", "fz", "mx", "my", "mz")
MOMENTUM_UNITS = ("kg m/s",) * 3 + ("kg m^2/s",) * 3
MOMENTUM_LABELS = ("px", "py", "pz", "Lx", "Ly", "Lz")


def q_port(system: System, name: str = "q", description: str = "configuration of the tree") -> Port:
    """Coordinates of the tree."""
    entries = system.tree.q
    turns = tuple(QUATERNION if c.kind == QUATERNION else "" for c in entries)
    forms = turns if any(turns) else ()
    return Port(
        name, (len(entries),), tuple(c.unit for c in entries), tuple(c.label for c in entries), description, forms
    )


def v_port(system: System, name: str = "v", description: str = "rates of the tree") -> Port:
    """Rates of the tree."""
    tree = system.tree
    return Port(name, (len(tree.v),), tuple(c.unit for c in tree.v), tuple(c.label for c in tree.v), description)


def a_port(system: System, name: str = "a", description: str = "accelerations of the tree (rates of v)") -> Port:
    """Accelerations of the tree."""
    tree = system.tree
    units = tuple(f"{c.unit}^2" for c in tree.v)
    return Port(name, (len(tree.v),), units, tuple(c.label for c in tree.v), description)


def length_units(system: System) -> tuple[str, ...]:
    """The units of v without time: rad and m."""
    return tuple("m" if c.kind == "length" else "rad" for c in system.tree.v)


def ratio_units(rows: Sequence[str], columns: Sequence[str]) -> tuple[str, ...]:
    """Units of a matrix that maps what has the units of the columns to what has those of the rows, column-major."""
    pairs = [(row, column) for column in columns for row in rows]
    return tuple(["1" if row == column else row if column == "1" else f"{row}/{column}" for row, column in pairs])


def drive_label(system: System, index: int) -> str:
    """Name of a drive: its joint, with the freedom where the joint has several."""
    name, freedom = system.drives[index]
    return system.mechanism.joints[name].kind.freedom_names(name)[freedom]


def u_port(system: System, name: str = "u", description: str = "drive forces and torques") -> Port:
    """Drives in the order of the description."""
    count = len(system.drives)
    units = tuple("N" if drive_is_force(system, k) else "N m" for k in range(count))
    return Port(name, (count,), units, tuple(drive_label(system, k) for k in range(count)), description)


def drive_is_force(system: System, index: int) -> bool:
    """Whether a drive acts on a sliding freedom."""
    joint, freedom = system.drives[index]
    return system.mechanism.joints[joint].kind.freedoms[freedom].prismatic


def y_port(loops: Loops, name: str, order: int) -> Port:
    """Independent coordinates, or their rates of the given order."""
    suffix = ("", "/s", "/s^2")[order]
    units = tuple(loops.system.tree.q[e.q].unit + suffix for e in loops.entries)
    text = ("independent coordinates", "their rates", "their second rates")[order]
    return Port(name, (len(loops.entries),), units, loops.labels, text)


def columns_port(
    name: str, columns: Sequence[str], labels: Sequence[str], units: Sequence[str], *, description: str
) -> Port:
    """A matrix with one column per named object (body, joint, point), column-major."""
    return Port(
        name,
        (len(labels), len(columns)),
        tuple(units) * len(columns),
        tuple(f"{column}.{label}" for column in columns for label in labels),
        description,
    )


def function(
    system: System,
    name: str,
    description: str,
    *,
    inputs: Sequence[tuple[Port, Sequence[Node]]],
    outputs: Sequence[tuple[Port, Sequence[object]]],
    guards: Sequence[tuple[Node, float]] = (),
    notes: Sequence[str] = (),
    further: Sequence[tuple[Port, Sequence[Node]]] = (),
) -> Function:
    """A function of the model, of (inputs..., run-time parameters, further...).

    Args:
        system: whose tape holds all nodes and whose run-time parameters are added to the inputs.
        name: in generated code.
        description: one sentence for its header.
        inputs: (port, nodes): the nodes stand for the port's entries.
        outputs: (port, values): nodes, or plain numbers such as 0 and 1.
        guards: (node, threshold): status 1 where |node| <= threshold.
        notes: what a user of the function must know.
        further: inputs after the run-time parameters: of a part that gets another function's inputs and these.
    """
    ports, nodes = system.parameter_ports()
    values = [[system.tape.node(n) for n in of] for _, of in outputs]
    read = [*(n for of in values for n in of), *(pivot for pivot, _ in guards)]
    return Function(
        name,
        description,
        (*(p for p, _ in inputs), *ports, *(p for p, _ in further)),
        tuple(p for p, _ in outputs),
        (*(tuple(n) for _, n in inputs), *nodes, *(tuple(n) for _, n in further)),
        tuple(map(tuple, values)),
        tuple(guards),
        tuple(notes),
        system.structure.limbs,
        rotations(inputs, read),
    )


def rotations(inputs: Sequence[tuple[Port, Sequence[Node]]], results: Sequence[Node]) -> tuple[NodeLimit, ...]:
    """Quaternions among the inputs have unit length, up to rounding, as far as results depend on them."""
    quaternions = [
        nodes[k : k + 4]
        for port, nodes in inputs
        for k, form in enumerate(port.forms)
        if form == QUATERNION and port.forms[:k].count(QUATERNION) % 4 == 0
    ]
    read = inputs_of(results) if quaternions else set()
    found = [squared_length(quaternion) for quaternion in quaternions if read & set(quaternion)]
    return tuple((length, 1 - ROUNDED, 1 + ROUNDED, NO_ROTATION) for length in found)
