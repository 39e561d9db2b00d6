"""Independent formulations that results are held against: method B of the source paper and its coordinates.

    Mechanism, poses --maximal_coordinates--> states of every body --newton_euler--> drives and reactions

Nothing here uses a tape, a tree or a program: what agrees with it was found by another route.
"""

from symscrew.reference.joint_motion import rotation_about, rotation_vector
from symscrew.reference.maximal_coordinates import BodyState, NumericMechanism, numeric, plane_axes
from symscrew.reference.newton_euler_method import newton_euler

__all__ = [
    "BodyState",
    "NumericMechanism",
    "newton_euler",
    "numeric",
    "plane_axes",
    "rotation_about",
    "rotation_vector",
]
