"""Momentum screws, their rates, energies."""

from __future__ import annotations

from symscrew.algebra import ZERO, Node, add, cross, dot, named, named_wrench, product, scale, transform, transpose
from symscrew.effects import Acting, Effect
from symscrew.functions.kinematic import Motion, moving_bodies
from symscrew.functions.ports import (
    MOMENTUM_LABELS,
    MOMENTUM_UNITS,
    WRENCH_LABELS,
    WRENCH_UNITS,
    a_port,
    columns_port,
    function,
    q_port,
    v_port,
)
from symscrew.kinematics import MassProperties, System, displacement, momentum_rate, momentum_screw, regrouped
from symscrew.program import Function, Port


def mass_properties(system: System, body: str) -> MassProperties | None:
    """A body's mass [kg], centre of mass [m] and inertia about it [kg m^2] in absolute axes; None without mass."""
    given = system.mechanism.bodies[body]
    if given.mass is None or given.com is None:
        return None
    link = system.tree.link_of_body[body]
    moved = displacement(system.frames[link], system.pose[link])
    com = moved.point(system.geometry.vector(given.com))
    rows = [system.geometry.vector(row) for row in given.inertia] if given.inertia else [(0, 0, 0)] * 3
    turned = product(product(moved.rotation, (rows[0], rows[1], rows[2])), transpose(moved.rotation))
    return MassProperties(system.geometry.scalar(given.mass), com, turned)


def momentum_functions(system: System, motion: Motion, effects: tuple[Effect, ...]) -> list[Function]:
    """Momentum screws of all bodies and of the whole, their rates, kinetic and potential energy."""
    names = [b for b in moving_bodies(system) if mass_properties(system, b) is not None]
    if not names:
        return []
    bodies = {name: mass_properties(system, name) for name in names}
    screws: list[object] = []
    rates: list[object] = []
    total_linear, total_angular = ZERO, ZERO
    for name, body in bodies.items():
        assert body is not None
        moving = motion.body(name)
        screw = momentum_screw(body, moving.twist)
        named_wrench((screw.linear, screw.angular), "momentum", name)
        screws += screw.components
        total_linear, total_angular = add(total_linear, screw.linear), add(total_angular, screw.angular)
        rate_at_o = momentum_rate(body, moving)
        named_wrench((rate_at_o.force, rate_at_o.moment), "momentum_rate_at_O", name)
        rates += rate_at_o.components
    q, v = (q_port(system), system.inputs.q), (v_port(system), system.inputs.v)
    momenta = columns_port(
        "momenta", names, MOMENTUM_LABELS, MOMENTUM_UNITS, description="momentum screw (p ; L_O) per body"
    )
    total = Port("total", (6,), MOMENTUM_UNITS, MOMENTUM_LABELS, "sum over all bodies")
    rate = columns_port(
        "momentum_rates", names, WRENCH_LABELS, WRENCH_UNITS, description="rate of every momentum screw"
    )
    acting = Acting(system, effects)
    values = (_kinetic(system) + acting.kinetic, acting.potential)
    energy = Port("energy", (2,), ("J", "J"), ("kinetic", "potential"), "kinetic and potential energy")
    return [
        function(system, "momentum_screws", "Momentum screws of all bodies at O, eq. (31).", inputs=[q, v],
                 outputs=[(momenta, screws), (total, (*total_linear, *total_angular))]),
        function(system, "momentum_rates", "Rates of the momentum screws: sums of all force screws, eq. (35).",
                 inputs=[q, v, (a_port(system), system.inputs.a)], outputs=[(rate, rates)]),
        function(system, "energy", "Kinetic energy and potential energy of the effects (gravity: zero at O).",
                 inputs=[q, v, *acting.inputs_of(values)], outputs=[(energy, values)]),
    ]  # fmt: skip


def _kinetic(system: System) -> Node:
    """Half of (m v.v + 2 v.(omega x s) + omega.J omega) over all links, in link axes about their origins."""
    tape = system.tape
    total = tape.zero
    lean = regrouped(system.tree, system.frames, system.inertia, system.geometry)
    for part, twist, inertia in zip(system.tree.parts[1:], system.twist[1:], lean[1:], strict=True):
        v, w = twist.linear, twist.angular
        total = total + dot(v, add(scale(inertia.mass, v), scale(2, cross(w, inertia.first))))
        trace = inertia.second[0][0] + inertia.second[1][1] + inertia.second[2][2]
        # omega . J omega with J = trace(Sigma) - Sigma
        total = total + (trace * dot(w, w) - dot(w, transform(inertia.second, w)))
        named(total, "energy", part, "kinetic_up_to")
    return total * tape.reciprocal(tape.node(2))
