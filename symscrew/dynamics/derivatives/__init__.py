"""Derivatives of the dynamics by following small motions through the recursions, screw by screw."""

from symscrew.dynamics.derivatives.closure_variations import closure_changes
from symscrew.dynamics.derivatives.composite_variations import inertial_derivatives
from symscrew.dynamics.derivatives.force_variations import power_changes
from symscrew.dynamics.derivatives.motion_variations import Direction, Variation, three

__all__ = ["Direction", "Variation", "closure_changes", "inertial_derivatives", "power_changes", "three"]
