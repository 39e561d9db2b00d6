"""Ports that many functions share: coordinates, rates, screws, with their units and labels."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import Node
from symscrew.kinematics import System
from symscrew.loops import Loops
from symscrew.program import Function, Port

TWIST_UNITS = ("rad/s",) * 3 + ("m/s",) * 3
TWIST_LABELS = ("wx", "wy", "wz", "vx", "vy", "vz")
TWIST_RATE_UNITS = ("rad/s^2",) * 3 + ("m/s^2",) * 3
WRENCH_UNITS = ("N",) * 3 + ("N m",) * 3
WRENCH_LABELS = ("fx", "fy", "fz", "mx", "my", "mz")
MOMENTUM_UNITS = ("kg m/s",) * 3 + ("kg m^2/s",) * 3
MOMENTUM_LABELS = ("px", "py", "pz", "Lx", "Ly", "Lz")


def q_port(system: System, name: str = "q", description: str = "configuration of the tree") -> Port:
    """Coordinates of the tree."""
    tree = system.tree
    return Port(name, (len(tree.q),), tuple(c.unit for c in tree.q), tuple(c.label for c in tree.q), description)


def v_port(system: System, name: str = "v", description: str = "rates of the tree") -> Port:
    """Rates of the tree."""
    tree = system.tree
    return Port(name, (len(tree.v),), tuple(c.unit for c in tree.v), tuple(c.label for c in tree.v), description)


def a_port(system: System, name: str = "a", description: str = "accelerations of the tree (rates of v)") -> Port:
    """Accelerations of the tree."""
    tree = system.tree
    units = tuple(f"{c.unit}^2" for c in tree.v)
    return Port(name, (len(tree.v),), units, tuple(c.label for c in tree.v), description)


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
) -> Function:
    """A function of the model, of (inputs..., run-time parameters).

    Args:
        system: whose tape holds all nodes and whose run-time parameters are added to the inputs.
        name: in generated code.
        description: one sentence for its header.
        inputs: (port, nodes): the nodes stand for the port's entries.
        outputs: (port, values): nodes, or plain numbers such as 0 and 1.
        guards: (node, threshold): status 1 where |node| <= threshold.
        notes: what a user of the function must know.
    """
    ports, nodes = system.parameter_ports()
    return Function(
        name,
        description,
        tuple(p for p, _ in inputs) + ports,
        tuple(p for p, _ in outputs),
        tuple(tuple(n) for _, n in inputs) + nodes,
        tuple(tuple(system.tape.node(n) for n in values) for _, values in outputs),
        tuple(guards),
        tuple(notes),
        system.structure.limbs,
    )
