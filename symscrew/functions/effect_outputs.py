"""Functions that only effects bring about: their power, the rates of their states, the motors' rates."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.algebra import Node
from symscrew.effects import Acting, Effect
from symscrew.functions.dynamic import Equations
from symscrew.functions.forward import driven, solved
from symscrew.functions.ports import function, q_port, u_port, v_port
from symscrew.kinematics import System
from symscrew.loops import Loops
from symscrew.program import Function, Port


def effect_functions(system: System, effects: Sequence[Effect], loops: Loops) -> list[Function]:
    """`effect_power`, `effect_state_rates` and `drive_rates` of motors behind transmissions; each where it applies."""
    acting = Acting(system, effects)
    functions = []
    if acting.powers or acting.transmissions or acting.needs_reactions:
        functions.append(_power(system, effects, acting, loops))
    if acting.states:
        functions.append(_state_rates(system, effects, acting, loops))
    if acting.transmissions:
        functions.append(_motor_rates(system, acting))
    return functions


def _power(system: System, effects: Sequence[Effect], acting: Acting, loops: Loops) -> Function:
    """Power per effect; with load-dependent effects and with transmissions also from u."""
    inputs: list[tuple[Port, Sequence[Node]]] = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v)]
    _, drives = driven(system, effects)
    acting = _loaded(system, effects, acting, loops)
    if acting.needs_reactions or acting.transmissions:
        inputs += drives
    powers = dict(acting.powers)
    if acting.transmissions:
        for k, transmission in acting.transmissions.items():
            joint, freedom = system.drives[k]
            given = drives[0][1][k]
            on_joint = transmission.force(given) * acting.rate(joint, freedom)
            powers[f"transmission_{joint}"] = on_joint - given * transmission.rate
    text = "power fed in beyond the rates of stored energies; < 0: dissipated"
    port = Port("power", (len(powers),), ("W",) * len(powers), tuple(powers), text)
    every = [*inputs, *acting.inputs]
    about = "Power of every effect that is not the rate of a stored energy."
    return function(system, "effect_power", about, inputs=every, outputs=[(port, list(powers.values()))])


def _state_rates(system: System, effects: Sequence[Effect], acting: Acting, loops: Loops) -> Function:
    """From u as well, where rates depend on the joints' loads."""
    inputs: list[tuple[Port, Sequence[Node]]] = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v)]
    if acting.rates_need_reactions:
        inputs += driven(system, effects)[1]
        acting = _loaded(system, effects, acting, loops)
    inputs += acting.inputs
    text = "Rates of the effects' states."
    return function(system, "effect_state_rates", text, inputs=inputs, outputs=acting.state_rate_output)


def _loaded(system: System, effects: Sequence[Effect], acting: Acting, loops: Loops) -> Acting:
    """What acts, with what load-dependent effects read of the motion under the drives."""
    if not acting.needs_reactions:
        return acting
    return solved(system, effects, loops).acting if acting.keeps_motion else Equations(system, effects).forces


def _motor_rates(system: System, acting: Acting) -> Function:
    """`drive_rates` with the motors' sides of transmissions: power = u . rates."""
    port = acting.drive_port(u_port(system))
    units = tuple("m/s" if unit == "N" else "rad/s" for unit in port.units)
    rates = Port("rates", port.shape, units, port.labels, "rates of the drives; power = u . rates")
    values = [
        acting.transmissions[k].rate if k in acting.transmissions else acting.rate(joint, freedom)
        for k, (joint, freedom) in enumerate(system.drives)
    ]
    text = "Rates of the drives, in the order of u: of the motors where a transmission stands between."
    state = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v)]
    return function(system, "drive_rates", text, inputs=state, outputs=[(rates, values)])
