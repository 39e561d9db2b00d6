"""What numbers of generated code mean, said once: in the header, in the manifest, in the documentation.

A page of the documentation (`docs/conventions.md`) says the same; a test holds them together.
"""

from __future__ import annotations

from collections.abc import Mapping

from symscrew.export.c_precision import Precision
from symscrew.export.c_rank_revealing import entries_on_stack
from symscrew.export.c_wide import LANES
from symscrew.model import Model
from symscrew.program import RankRevealing

CONVENTIONS: Mapping[str, str] = {
    "units": "SI; angles in rad, not wrapped.",
    "axes": "Vectors are in absolute axes unless it is said otherwise; screws are taken at the origin O: a twist is "
    "(omega ; v_O), a wrench (f ; m_O), a momentum screw (p ; L_O).",
    "matrices": "Column by column.",
    "quaternions": "(w, x, y, z), of unit length: they turn coordinates in the child's axes into the parent's. A "
    "length whose square is within 1e-6 of 1 is rounded, and divided out; any other is no rotation, status 5.",
    "rates of ball joints": "v and a hold the angular velocity of the child relative to the parent, and its rate, in "
    "the child's axes; joint_screws and joint_rates describe the same motion by elementary screws in the parent's.",
    "drives": "u > 0 lengthens a driven slider and turns a driven revolute joint positively. The force of a slider "
    "acts along its axis, on the line through the joint's point, on the child; its reaction on the parent.",
    "reactions": "Wrenches (f ; m_O) from parent on child, without the drive's share, which is u.",
    "memory": "Arrays are the caller's and must not overlap; in C those of size 0 may be NULL. Nothing is allocated.",
    "threads": "No state is kept: functions may run in several threads at once.",
}
"""Subject to what holds, in the order in which it is told."""


def stack(model: Model, precision: Precision, *, batches: bool) -> dict[str, int]:
    """Bytes of the largest arrays that calls of the C have on the stack, beside the temporaries of every call.

    `second_path`: near a small pivot; `blocks`: of eight states, in functions of many.
    """
    programs = model.programs.values()
    second = max((entries_on_stack(f) for f in programs if isinstance(f, RankRevealing)), default=0)
    room = max((sum(p.size for p in (*f.inputs, *f.outputs)) for f in programs), default=0) if batches else 0
    return {"second_path": second * precision.size, "blocks": LANES * room * precision.size}


def conventions(model: Model) -> dict[str, str]:
    """Subject to a sentence or two: those of joints that the mechanism has."""
    balls = any(label.endswith(".qw") for p in model.programs.values() for port in p.inputs for label in port.labels)
    left_out = set() if balls else {"quaternions", "rates of ball joints"}
    return {subject: text for subject, text in CONVENTIONS.items() if subject not in left_out}
