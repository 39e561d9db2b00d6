"""What happens between the points of a plan that no look at points shows: pulses of effects, peaks of a cost's text.

texts of effects and objectives --enclosures over pieces, halved until they are resolved--> times to cut at

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

    `forces`, `costs`: what of effects, of objectives could not be resolved, in words; empty where everything was.
    """

    cuts: np.ndarray
    shortest: float = 1.0
    where: float = 0.0
    forces: str = ""
    costs: str = ""


def unseen_by(motion: PlannedMotion, branch: Branch, followed: Followed) -> Unseen:
    """Where the mesh of a plan that was followed is too coarse for what acts and counts."""
    if followed.trouble:
        return Unseen(np.zeros(0))
    symbols = point_symbols(motion.model, moving=True)
    at, equations = MotionQuantities(motion.model, symbols), motion.model.equations
    acts = ca.SX(0, 1)
    if program := equations.given_functions:
        acts = symbolic_outputs(program, {**at.known, "q": at.q})["values"]
    terms = [
        OBJECTIVE_TYPES["expression"].term(at, objective, f"objectives[{k}]")[0]
        for k, objective in enumerate(motion.model.problem.objectives)
        if objective.type == "expression"
    ]
    trouble, pieces = ["", ""], [np.zeros((0, 3))]
    for k, (values, what) in enumerate(((acts, "what effects do"), (ca.vertcat(ca.SX(0, 1), *terms), "the cost"))):
        if not ca.symvar(values):
            continue
        found = _resolved(EnclosedQuantities(motion, branch, symbols, values), followed.boxes, values.numel())
        if found is None:
            trouble[k] = f"{what} changes too fast between the points to be followed, or is not bounded there"
        else:
            pieces.append(found)
    return _cut_at(motion.transcribed.mesh, np.concatenate(pieces), forces=trouble[0], costs=trouble[1])


def _cut_at(mesh: np.ndarray, pieces: np.ndarray, *, forces: str, costs: str) -> Unseen:
    """Ends of the pieces that are not whole intervals."""
    interval, centre, radius = pieces[pieces[:, 2] < 1.0].T
    if not len(interval):
        return Unseen(np.zeros(0), forces=forces, costs=costs)
    low, length = mesh[interval.astype(int)], np.diff(mesh)[interval.astype(int)]
    ends = low + length * (1 + centre + radius) / 2
    far = np.abs(ends[:, None] - mesh[None]).min(axis=1) > SHORTEST / 4
    least = int(np.argmin(length * radius))
    where = float(low[least] + length[least] * (1 + centre[least]) / 2)
    return Unseen(np.unique(ends[far]), float(length[least] * radius[least]), where, forces, costs)


def _resolved(quantities: EnclosedQuantities, boxes: Boxes, count: int) -> np.ndarray | None:
    """Pieces in which everything is resolved, in two rounds: the second time with sizes that are known."""
    sizes = np.zeros(count)
    for _ in range(2):
        found = _pieces(quantities, boxes, sizes)
        if found is None:
            return None
        pieces, sizes = found
    return pieces


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
