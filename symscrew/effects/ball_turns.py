"""How far a ball joint has turned: a rotation vector that goes on over whole turns, as states of an effect."""

from __future__ import annotations

from symscrew.algebra import Vector, cross, dot, scale
from symscrew.description import Joint
from symscrew.effects.acting import Acting
from symscrew.kinematics import whole_rotation_vector

SMALL_ANGLE = 1e-4
"""Below this angle [rad] (1 - h cot h)/angle^2, h half of it, is 1/12 to the last digit of what it adds, angle^4/720;
above it the quotient loses no more than a double's rounding of h cot h."""

NEAR = 1e-3
"""A motion that passes a whole turn from the reference nearer than that [rad] passes through it and turns on. Smaller:
rounding and errors of integration decide which way a motion about one axis goes on, and steps become too small. Larger:
phi is left off the pose's rotation by as much."""


def ball_turn(acting: Acting, joint: Joint) -> Vector:
    """Rotation vector phi [rad] of a ball joint, parent's axes, continuous over any number of turns.

    A pose tells a rotation vector within half a turn, and no function of the pose goes on beyond. So phi is a state
    per component, at the start the pose's own, with the rate that keeps the rotation by phi that of the joint,

        phi_dot = along + h cot h (omega - along) - phi x omega/2,    h = |phi|/2,  along = phi (phi . omega)/|phi|^2

    (the inverse of the left Jacobian of rotations). About one axis it counts turns. A motion that passes a whole turn
    from the reference at a distance has phi go round there and come back from the other side, as two turns of a ball
    can be undone; nearer than `NEAR` it turns on.
    """
    tape, tree = acting.system.tape, acting.system.tree
    names = [f"turn_{joint.name}_{c}" for c in "xyz"]
    known = {state.name: state.node for state in acting.states}
    if names[0] in known:  # of another effect in the same joint
        return known[names[0]], known[names[1]], known[names[2]]
    if joint.name in tree.joints:
        starts = list(acting.displacements(joint))
    else:
        cut = next(cut for cut in acting.system.cuts if cut.joint.name == joint.name)
        starts = whole_rotation_vector(acting.system, cut)
    about = f"turn of {joint.name}, parent's axes"
    x, y, z = (acting.state(name, "rad", 0.0, about, carried=start) for name, start in zip(names, starts, strict=True))
    phi: Vector = (x, y, z)
    rates = [acting.rate(joint.name, k) for k in range(3)]
    omega: Vector = (rates[0], rates[1], rates[2])
    square = tape.node(dot(phi, phi))
    angle = tape.sqrt(square)
    small = tape.function("less", angle, tape.constant(SMALL_ANGLE))
    half = acting.half * tape.function("select", small, tape.one, angle)
    sine = tape.node(tape.function("sin", half))
    least = tape.function("select", tape.function("less", half, tape.one), tape.zero, tape.constant((NEAR / 2) ** 2))
    under = tape.function("less", sine * sine, least)
    slope = half * tape.function("cos", half) * sine / tape.function("select", under, least, sine * sine)
    twelfth = tape.constant(1.0) / tape.node(12)
    factor = tape.function("select", small, twelfth, (1 - slope) / (4 * half * half))
    across = tape.function("select", small, 1 - twelfth * square, slope)
    along = scale(factor * tape.node(dot(phi, omega)), phi)
    turned = cross(phi, omega)
    for k, name in enumerate(names):
        acting.state_rate(name, across * omega[k] + along[k] - acting.half * turned[k])
    return phi
