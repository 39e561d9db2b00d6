"""Where a node comes from: which quantity of the theory, of which body or joint of the description, which component.

    omega = add(before, own)  --named_vector(omega, "omega", "forearm")-->  three nodes that know what they are

The derivation names what it makes, a line a vector. Names change nothing of what is computed: equal nodes are one and
keep the first name that they were given, the negative of a node has that node's name with `negative` set, constants
have none. Passes and `symscrew.program.lower` hand names on to the program (`Program.origins`), whose printers call
values by them and whose lanes pair equal limbs by them.
"""

from __future__ import annotations

from dataclasses import dataclass

QUANTITIES = {
    # inputs and results of functions are called by their ports: q, v, a, u, y, y_dot, poses, twists, reactions ...
    # -- kinematics ----------------------------------------------------------------------------------------------
    "cos": "cosine of a joint's angle, from the link's own zero",
    "sin": "sine of a joint's angle, from the link's own zero",
    "turn": "rotation matrix of a joint's motion: link axes to axes before the motion, row and column",
    "offset": "a link's origin in its parent's coordinates [m]",
    "rotation": "rotation matrix of a link: link axes to absolute axes, row and column",
    "position": "a link's origin in absolute coordinates [m]",
    "omega": "angular velocity, link axes [rad/s]",
    "velocity": "velocity of the link's origin, link axes [m/s]",
    "alpha": "angular acceleration, link axes [rad/s^2]",
    "acceleration": "acceleration of the link's origin less gravity, link axes [m/s^2]",
    "acceleration_matrix": "U = [alpha]x + [omega]x^2, link axes: points r of the link accelerate by a_o + U r",
    "alpha_still": "alpha at joint accelerations zero [rad/s^2]",
    "acceleration_still": "acceleration at joint accelerations zero [m/s^2]",
    "acceleration_matrix_still": "U at joint accelerations zero",
    "joint_rate": "rate of a joint, spherical ones in the axes before the motion [rad/s, m/s]",
    "joint_acceleration": "its rate [rad/s^2, m/s^2]",
    "joint_acceleration_still": "the same with the free joint rates steady [rad/s^2, m/s^2]",
    "screw": "unit screw (e ; r x e) of a joint at O, eq. (5)",
    "twist": "twist (omega ; v_O) at O, eq. (6)",
    "twist_rate": "its rate by the screw bracket, derivative of eq. (6)",
    "turned": "virtual rotation of a link along a direction, link axes [rad per unit]",
    # -- momentum ------------------------------------------------------------------------------------------------
    "inertia": "mass, first and second moments of a link that depend on run-time parameters",
    "momentum": "momentum screw (p ; L_O) at O, eq. (31)",
    "momentum_rate_at_O": "its rate (force ; moment) at O, eq. (35)",
    "momentum_rate": "rate of the momentum screw (force ; moment) about the link's origin, link axes, eq. (35)",
    "energy": "kinetic energy of a link, or potential energy [J]",
    # -- loops ---------------------------------------------------------------------------------------------------
    "constraint": "wrench reciprocal to a cut joint (force ; couple), tip axes, eq. (10)",
    "contact": "the hub's point that is at a cut joint's point, hub axes [m]",
    "arm": "from the hub's origin to a cut joint's point, tip axes [m]",
    "contact_rate": "velocity of a cut joint's point, a component, per rate of the tree or further component",
    "opening": "how far a loop is open along a reciprocal wrench [m, rad]",
    "opening_rate": "its rate: w . (V_tip - V_hub) [m/s, rad/s]",
    "opening_bias": "(dJ/dt) v: its second rate without joint accelerations [m/s^2, rad/s^2]",
    "closure": "entry of the closure Jacobian J: power of a reciprocal wrench per joint rate",
    "lever": "a reciprocal wrench at another link (force ; moment about its origin), that link's axes",
    "pivot": "what an elimination divides by",
    "determinant": "of equations that are solved at once: what is divided by",
    "factor": "multiple of a row that an elimination takes from another one",
    "null_space": "rate of a joint per rate of a free one",
    "limb_target": "where the end of a limb in closed form must be, from its base",
    "limb_length": "distance between two points of a limb in closed form [m]",
    "in_mode": "1 where a state is of the operation mode, else 0",
    # -- balance -------------------------------------------------------------------------------------------------
    "load": "what effects exert on a link (force ; moment about its origin), axes before its motion",
    "force": "what a link and all that hangs on it need (force ; moment about its origin), link axes, eqs. (40)-(47)",
    "joint_force": "the same in the axes before the link's motion: what its joint must supply",
    "transmitted": "force with all multipliers and drives put in, link axes",
    "joint_transmitted": "the same in the axes before the link's motion: what its joint transmits",
    "rod": "from the near to the far end of a thin rod, axes before the motion of the link that carries it [m]",
    "second_axis": "unit vector along a rod's second axis, the same axes",
    "aside": "how far a rod is from its first axis [m]",
    "pull": "what the link at an end of a rod must supply per unit of its tension, axes before that link's motion",
    "end_acceleration": "acceleration of an end of a rod less gravity [m/s^2]",
    "end_inertia": "what the link at an end of a rod must supply for its mass, axes before that link's motion",
    "balance": "power of a link's joint_force along a freedom: zero, or the drive",
    "multiplier": "amount of a reciprocal wrench that a cut joint transmits [N, N m]",
    "multiplier_part": "the same without drives and other multipliers, or per one of these",
    "drive": "force or torque of a drive on its joint [N, N m]",
    "share": "product of two columns of the equations for the drives: entry of A W^-1 A^T",
    "joint_reaction": "wrench from parent on child (force ; moment) at the joint's point, in the link's or tip's axes",
    "reaction": "the same (f ; m_O) at O, absolute axes, eq. (32)",
    # -- motion --------------------------------------------------------------------------------------------------
    "generalised_force": "what a freedom needs, less what acts [N, N m]",
    "composite": "mass, first and second moments of a link and all that hangs on it, about its origin, link axes",
    "mass_matrix": "entry of the mass matrix",
    "articulated": "how a link and all that hangs on it answer accelerations: A, B, D [Featherstone 1983]",
    "stiffness": "inertia that a freedom feels",
    "answer": "wrench (force ; moment) with which a link answers a unit acceleration of a freedom",
    "effort": "acceleration of a freedom by what acts on it and outboard",
    "handed_inertia": "what a dependent rate hands on of the inertia that it has with a rate",
    "handed_force": "what a dependent rate hands on of the forces that it lacks [N, N m]",
    "follows": "dependent joint rate per rate that it follows",
    "reduced_inertia": "entry of N^T M N, for the free joint rates",
    "reduced_force": "entry of N^T (f - M p), for the free joint rates",
}
"""The quantities that nodes are named by: what they are. Components are x y z, or xx xy ... by row and column; of a
screw the vector comes first: `force_x`, `moment_x`. `by` is what a coefficient belongs to: a multiplier, a drive, a
joint rate, a direction of a derivative."""


@dataclass(frozen=True)
class Origin:
    """Where a value comes from: `quantity` of `part`, a body or joint by its name in the description; `component`.

    `by`: of a coefficient, or a derivative, what it is of. `negative`: it is the opposite of that.
    """

    quantity: str
    part: str = ""
    component: str = ""
    by: str = ""
    negative: bool = False

    @property
    def opposite(self) -> Origin:
        """That of the negative."""
        return Origin(self.quantity, self.part, self.component, self.by, not self.negative)
