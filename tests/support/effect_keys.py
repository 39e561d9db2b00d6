"""Unit and meaning of every key of every effect, for the page of the reference; a test holds that none is missing."""

from __future__ import annotations

FORCE = "N or N m"
WAY = "m or rad"
COMMON = {
    "joint": ("", "the joint that it acts on"),
    "freedom": ("", "which of the joint's freedoms, from 0; only for joints with several"),
    "name": ("", "of its states, inputs and outputs; by default made of what it acts on"),
}
"""Keys that effects share."""
DAMPING = ("s/m or s/rad", "of a contact: F grows with 1 + damping times the rate of the depth; at least 0")
EXPONENT = ("1", "of the depth in the force of a contact: 1, 1.5 or 2")
EFFECT_KEYS = {
    "backlash": {
        "play": (WAY, "the whole way between the two flanks, above 0"),
        "stiffness": ("N/m^n or N m/rad^n", "of a flank, above 0"),
        "inertia": ("kg or kg m^2", "of the actuator, reflected to the joint, above 0"),
        "exponent": EXPONENT,
        "damping": DAMPING,
        "initial": (WAY, "where the actuator begins, from midway"),
    },
    "base_motion": {
        "twist": ("rad/s, m/s", "six expressions of t: (omega ; v_O) of the ground in its own axes"),
        "pose": ("m, rad", "six expressions of t: x, y, z, roll, pitch, yaw"),
        "attitude": ("", "true: the ground's attitude is an input, too"),
    },
    "dc_motor": {
        "torque_constant": ("N m/A", "torque per current, and voltage per rate"),
        "resistance": ("ohm", "of the winding"),
        "inductance": ("H", "of the winding, above 0"),
        "ratio": ("1 or rad/m", "rotor's angle per displacement of the joint"),
        "current": ("A", "at the start"),
    },
    "dry_friction": {
        "coulomb": (FORCE, "level while it slides, without load"),
        "static": (FORCE, "level at rest, at least `coulomb`"),
        "stribeck_velocity": ("m/s or rad/s", "rate within which the level falls from static to sliding"),
        "velocity": ("m/s or rad/s", "width of the smooth change of sign; needed in the smooth mode"),
        "load": ("1 or m", "friction per size of the joint's reaction: a coefficient, or times the bearing's radius"),
        "passes": ("", "how often friction and reaction are computed in turn"),
        "mode": ("", '"smooth", or "event": stick and slip, in a simulation'),
    },
    "end_stop": {
        "lower": (WAY, "the stop below; at least one of the two"),
        "upper": (WAY, "the stop above"),
        "stiffness": ("N/m^n or N m/rad^n", "of the stop, above 0; needed in the compliant mode"),
        "exponent": EXPONENT,
        "damping": DAMPING,
        "mode": ("", '"compliant", or "impact": rigid, in a simulation'),
        "restitution": ("1", "of impacts, 0 to 1"),
    },
    "external_wrench": {
        "point": ("", "the named point that it acts at"),
        "wrench": ("N, N m", "six expressions of t: force and moment; without them they are an input"),
        "axes": ("", '"absolute" or "body"'),
    },
    "flexible_link": {
        "start": ("", "the point where the rod begins"),
        "end": ("", "the point where it ends"),
        "axis": ("1", "about which it bends"),
        "bending_stiffness": ("N m^2", "EI, above 0"),
        "line_density": ("kg/m", "above 0"),
        "modes": ("", "how many shapes"),
        "shape": ("", '"pinned" or "clamped"'),
        "damping": ("1", "ratio of every mode, at least 0"),
        "initial": ("m", "deflection of every mode at the start"),
    },
    "fluid_drag": {
        "body": ("", "the body that it acts on"),
        "sides": ("m", "of the box, at least 0"),
        "density": ("kg/m^3", "of the medium, at least 0"),
        "viscosity": ("Pa s", "of the medium, at least 0"),
        "wind": ("m/s", "velocity of the medium, absolute axes"),
        "axes": ("1", "of the box: three unit vectors, absolute in the reference configuration"),
    },
    "gravity": {
        "acceleration": ("m/s^2", "three components, absolute axes"),
        "input": ("", '"switch" or "field": a factor or the field is an input'),
    },
    "joint_clearance": {
        "hole": ("", "the point at the hole's centre"),
        "pin": ("", "the point at the pin's centre, on another body"),
        "clearance": ("m", "difference of the radii, above 0"),
        "stiffness": ("N/m^n", "of the wall, above 0"),
        "exponent": EXPONENT,
        "damping": DAMPING,
        "friction": ("1", "coefficient between pin and wall, at least 0"),
        "velocity": ("m/s", "width of the smooth change of friction's sign; needed with friction"),
        "radius": ("m", "of the pin, for friction"),
        "axis": ("1", "of a cylindrical pin; without it a ball"),
    },
    "joint_spring": {
        "stiffness": ("N/m or N m/rad", "at least 0"),
        "rest": (WAY, "displacement at which only the preload acts"),
        "preload": (FORCE, "force at rest, towards smaller displacements"),
        "cubic": ("N/m^3 or N m/rad^3", "of either sign"),
        "damping": ("N s/m or N m s/rad", "at least 0"),
        "energy": ("J", "a text E(x) in place of stiffness, cubic and preload"),
    },
    "leg_compliance": {
        "stiffness": ("N/m", "of the leg, above 0"),
        "mass": ("kg", "of the actuator, as it moves along the leg, above 0"),
        "loss": ("1", "loss factor of structural damping"),
    },
    "massless_limbs": {"keep": ("", "bodies that keep their mass, besides the platform")},
    "no_gyroscopic_terms": {"bodies": ("", "whose moments are left out; without them only where operations are saved")},
    "payload": {
        "body": ("", "the body that it is fixed to"),
        "mass": ("kg", "a number, or an expression of run-time parameters"),
        "com": ("m", "its centre in the reference configuration, absolute axes"),
        "inertia": ("kg m^2", "three principal moments, or xx, yy, zz, xy, xz, yz, about its own centre"),
    },
    "point_spring": {
        "start": ("", "the first point"),
        "end": ("", "the second point"),
        "stiffness": ("N/m", "at least 0"),
        "length": ("m", "distance at which only the preload acts, at least 0"),
        "preload": ("N", "tension at that distance"),
        "cubic": ("N/m^3", "of either sign"),
        "damping": ("N s/m", "at least 0"),
        "energy": ("J", "a text E(x) in place of stiffness, cubic and preload"),
    },
    "position_servo": {
        "stiffness": ("N/m or N m/rad", "force per way from the target, at least 0"),
        "damping": ("N s/m or N m s/rad", "force per rate from the target's, at least 0"),
        "limit": (FORCE, "largest force"),
    },
    "quasi_static": {},
    "rolling_contact": {
        "wheel": ("", "the point at the wheel's centre"),
        "ground": ("", "a point of what it rolls on"),
        "radius": ("m", "of the wheel, above 0"),
        "grip": ("1/m", "stiffness along the ground per normal force, above 0"),
        "grip_damping": ("s/m", "damping along the ground per normal force, above 0"),
        "normal": ("1", "of the plane that it rolls on"),
        "axis": ("1", "of a disc; without it a ball"),
        "circle": ("m", "radius of a circle that it rolls on, below 0: within it"),
        "stiffness": ("N/m^n", "of the ground, above 0; or `load`"),
        "exponent": EXPONENT,
        "damping": ("s/m", DAMPING[1]),
        "load": ("N", "a constant normal force, where joints keep the wheel where it is"),
        "friction": ("1", "coefficient; without it the wheel never slides"),
        "initial": ("m", "deflections along the ground at the start"),
    },
    "rotor_inertia": {
        "inertia": ("kg m^2", "of the rotor, at least 0"),
        "ratio": ("1 or rad/m", "rotor's angle per displacement of the joint"),
    },
    "screw_transmission": {
        "lead": ("m", "way per turn; below 0 for a left-hand thread"),
        "efficiency": ("1", "while the motor drives, above 0, at most 1"),
        "back_efficiency": ("1", "while the load drives; as `efficiency` unless given"),
        "velocity": ("m/s", "width of the change between both; needed with losses"),
    },
    "viscous_friction": {"coefficient": ("N s/m or N m s/rad", "force per rate, at least 0")},
}
