"""What couplings of coordinates and rolling wheels exert: the moment between two gears, the force on a wheel."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import Node, dot
from symscrew.effects import Effect
from symscrew.functions.closing import guarded
from symscrew.functions.dynamic import Equations, reactions_inputs
from symscrew.functions.ports import function
from symscrew.kinematics import System
from symscrew.loops import Loops
from symscrew.program import Function, Port

NAME = "coupling_forces"
ROLLING = "rolling_forces"


def coupling_functions(system: System, effects: Sequence[Effect], loops: Loops) -> list[Function]:
    """The forces of all couplings for a consistent state; nothing without couplings.

    A coupling's is the force or moment on its first coordinate that has a slope in the reference configuration; on
    the others it is that times the ratio of their slopes.
    """
    cuts = [cut for cut in system.cuts if cut.relation is not None]
    if not cuts:
        return []
    equations = Equations(system, effects, cost=loops.cost)
    reactions = equations.reactions(equations.solution.u)
    values = []
    for cut in cuts:
        force, moment = reactions.wrenches[cut.joint.name]
        values.append((force if cut.rows[0].unit == "N" else moment)[0])
    names = tuple(cut.joint.name for cut in cuts)
    text = "force or moment of every coupling on its first coordinate"
    port = Port("couplings", (len(cuts),), tuple(cut.rows[0].unit for cut in cuts), names, text)
    guards = guarded((*equations.balance.guards, *equations.solution.guards, *reactions.guards))
    what = "Forces and moments of the couplings, from a consistent state of the tree."
    return [
        function(
            system, NAME, what, inputs=reactions_inputs(equations), outputs=[(port, values)], guards=guards,
            notes=equations.notes,
        )
    ]  # fmt: skip


def rolling_functions(system: System, effects: Sequence[Effect], loops: Loops) -> list[Function]:
    """The forces on wheels that roll ideally, for a consistent state: ahead, aside and from the ground [N]."""
    cuts = [cut for cut in system.cuts if cut.touch is not None]
    if not cuts:
        return []
    equations = Equations(system, effects, cost=loops.cost)
    reactions = equations.reactions(equations.solution.u)
    values: list[Node] = []
    for cut in cuts:
        force, _ = reactions.wrenches[cut.joint.name]
        pose = system.pose[cut.tip]
        values += [system.tape.node(dot(force, pose.direction(row.force))) for row in cut.rows]
    labels = tuple(row.label for cut in cuts for row in cut.rows)
    port = Port("forces", (len(values),), ("N",) * len(values), labels, "on the wheel; normal: pulled where it is < 0")
    what = "Forces on wheels that roll without sliding, from a consistent state of the tree."
    guards = guarded((*equations.balance.guards, *equations.solution.guards, *reactions.guards))
    return [
        function(
            system, ROLLING, what, inputs=reactions_inputs(equations), outputs=[(port, values)], guards=guards,
            notes=equations.notes,
        )
    ]  # fmt: skip
