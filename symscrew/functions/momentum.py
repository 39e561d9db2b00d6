"""Momentum screws, their rates, energies."""

from __future__ import annotations

from symscrew.effects import Effect, Gravity
from symscrew.functions.kinematics import Motion, moving_bodies
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
from symscrew.kinematics import displacement
from symscrew.momentum import MassProperties, kinetic_energy, momentum_rate, momentum_screw
from symscrew.program import Function, Port
from symscrew.screws import ZERO, add, dot, product, transpose
from symscrew.system import System


def mass_properties(system: System, body: str) -> MassProperties | None:
    """A body's mass, present centre of mass and inertia in absolute axes; None for a massless body."""
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
    screws, rates, kinetic = [], [], system.tape.zero
    total_linear, total_angular = ZERO, ZERO
    for name, body in bodies.items():
        assert body is not None
        moving = motion.body(name)
        screw = momentum_screw(body, moving.twist)
        screws += screw.components
        total_linear, total_angular = add(total_linear, screw.linear), add(total_angular, screw.angular)
        rates += momentum_rate(body, moving).components
        kinetic = kinetic + kinetic_energy(body, moving.twist)
    potential = system.tape.zero
    for effect in effects:
        if isinstance(effect, Gravity):
            field = system.geometry.vector(effect.exact)
            for body in bodies.values():
                assert body is not None
                potential = potential - body.mass * dot(field, body.com)
    q, v = (q_port(system), system.inputs.q), (v_port(system), system.inputs.v)
    momenta = columns_port("momenta", names, MOMENTUM_LABELS, MOMENTUM_UNITS, "momentum screw (p ; L_O) per body")
    total = Port("total", (6,), MOMENTUM_UNITS, MOMENTUM_LABELS, "sum over all bodies")
    rate = columns_port("momentum_rates", names, WRENCH_LABELS, WRENCH_UNITS, "rate of every momentum screw")
    energy = Port("energy", (2,), ("J", "J"), ("kinetic", "potential"), "kinetic and potential energy")
    return [
        function(system, "momentum_screws", "Momentum screws of all bodies at O, eq. (31).", [q, v],
                 [(momenta, screws), (total, (*total_linear, *total_angular))]),
        function(system, "momentum_rates", "Rates of the momentum screws: sums of all force screws, eq. (35).",
                 [q, v, (a_port(system), system.inputs.a)], [(rate, rates)]),
        function(system, "energy", "Kinetic energy and potential energy of gravity (zero at O).", [q, v],
                 [(energy, (kinetic, potential))]),
    ]  # fmt: skip
