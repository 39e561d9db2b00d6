"""What happens between the points of a plan that no look at points shows: pulses of effects, peaks of a cost's text.

texts of effects in time and coordinates, of objectives --enclosures over pieces, halved until resolved--> times to cut at

Defects, costs and replays look at so many places in every interval of the mesh. They see what there is to be seen only
where nothing changes faster. A quantity f with an enclosure of its second derivative is resolved over a piece of half
width r where it hardly leaves its tangent, or hardly changes at all:

    |f''| r^2 / 2 <= PART size   or   max f - min f <= PART size,      size = largest |f| along the motion

Pieces are halved until that holds, so that a pulse is found wherever it is. Intervals that had to be cut are too long.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from symscrew.optimisation.bounds_between import halved
from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.enclosed_quantities import EnclosedQuantities
from symscrew.optimisation.enclosures import Enclosure, bounds_of
from symscrew.optimisation.followed_branch import Boxes, Branch, Followed
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.objectives import OBJECTIVE_TYPES
from symscrew.optimisation.planned_motion import PlannedMotion
from symscrew.optimisation.point import point_symbols

# A bell is cut in pieces of about its width: three points or more in each, as all that looks at intervals has, see it.
PART = 0.5
# Parts of the duration: a millionth of it. What is not resolved there is a jump.
SHORTEST = 2.0**-20
# Pieces at a time, of all quantities together: what needs more is said not to be settled.
MOST_PIECES = 4_000


@dataclass(frozen=True)
class Unseen:
    """Relative times (n,) inside intervals at which these have to be cut, the shortest piece there and where it is.

    `unsettled`: what could not be resolved, empty where everything was.
    """

    cuts: np.ndarray
    shortest: float = 1.0
    where: float = 0.0
    unsettled: str = ""


NOTHING = Unseen(np.zeros(0))


def unseen_by(motion: PlannedMotion, branch: Branch, followed: Followed) -> Unseen:
    """Where the mesh of a plan that was followed is too coarse for what acts and counts."""
    symbols = point_symbols(motion.model, moving=True)
    at, problem = MotionQuantities(motion.model, symbols), motion.model.problem
    values = ca.SX(0, 1)
    if program := motion.model.equations.given_functions:
        values = symbolic_outputs(program, {**at.known, "q": at.q})["values"]
    for k, objective in enumerate(problem.objectives):
        if objective.type == "expression":
            term, _ = OBJECTIVE_TYPES["expression"].term(at, objective, f"objectives[{k}]")
            values = ca.vertcat(values, term)
    if not ca.symvar(values) or followed.trouble:
        return NOTHING
    quantities = EnclosedQuantities(motion, branch, symbols, values)
    sizes = np.zeros(values.numel())
    for _ in range(2):  # the second time with sizes that are known
        found = _pieces(quantities, followed.boxes, sizes)
        if found is None:
            return Unseen(np.zeros(0), unsettled="what objectives ask for could not be bounded between the points")
        pieces, sizes = found
    mesh = motion.transcribed.mesh
    interval, centre, radius = pieces.T
    own = radius < 1.0
    if not own.any():
        return NOTHING
    low, length = mesh[interval[own].astype(int)], np.diff(mesh)[interval[own].astype(int)]
    ends = low + length * (1 + centre[own] + radius[own]) / 2
    far = np.abs(ends[:, None] - mesh[None]).min(axis=1) > SHORTEST / 4
    least = int(np.argmin(length * radius[own]))
    where = float(ends[least] - length[least] * radius[own][least] / 2)
    return Unseen(np.unique(ends[far]), float(length[least] * radius[own][least]), where)


def _pieces(quantities: EnclosedQuantities, boxes: Boxes, sizes: np.ndarray) -> tuple[np.ndarray, np.ndarray] | None:
    """Pieces (interval, centre, half width) in which everything is resolved, and largest values; None: too many."""
    lengths = np.diff(quantities.motion.transcribed.mesh)
    done = []
    while True:
        values, radius, n = quantities.over(boxes), boxes.pieces.radius, len(boxes.pieces)
        middles = np.array([
            np.broadcast_to(v.middle[0] if isinstance(v, Enclosure) else v, (n,)) for v in values
        ])  # fmt: skip
        sizes = np.maximum(sizes, np.abs(np.nan_to_num(middles)).max(axis=1))
        open_ = np.zeros(n, dtype=bool)
        for v, size in zip(values, sizes, strict=True):
            if isinstance(v, Enclosure):
                low, high = bounds_of(v, n)
                bend = np.maximum(np.abs(v.low[-1]), np.abs(v.high[-1])) * radius**2 / 2
                flat = bend <= PART * size if v.orders == 3 else np.zeros(n, dtype=bool)
                open_ |= ~flat & ~(high - low <= PART * size)
        open_ &= lengths[boxes.pieces.interval] * radius > SHORTEST
        settled = boxes.chosen(~open_).pieces
        done.append(np.column_stack([settled.interval, settled.centre, settled.radius]))
        if not open_.any():
            return np.concatenate(done), sizes
        if open_.sum() > MOST_PIECES:
            return None
        boxes = halved(quantities.branch, boxes.chosen(open_))
