"""A plan followed from its start on its assembly mode: in every piece of time the configuration is proved to be one.

Between the points a plan is y as polynomials of time, and the dependent coordinates z follow from closed loops,
c(y, z) = 0, whose solutions are many. Over a piece of time with enclosures [y] and a box [z] around z0, Krawczyk's
operator

    K = z0 - C c([y], z0) + (1 - C c_z([y], [z])) ([z] - z0),    C about c_z^-1,

tells: if K lies inside [z], then at every time of the piece the box holds exactly one solution, and it is continuous
(R. Krawczyk, Computing 4, 1969; Moore, Kearfott, Cloud 2009, chapter 8). Pieces are halved until that holds;
neighbours have to share the solution where they meet. What the solver took for the configuration at its points, and
where conditions are observed, has to lie in these boxes: else the plan jumps to another branch there.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.consistent_poses import beginning, ending
from symscrew.optimisation.enclosed_functions import EnclosedFunction
from symscrew.optimisation.enclosures import Arithmetic, Enclosure, Number, bounds_of, interval
from symscrew.optimisation.guess import observed
from symscrew.optimisation.motion_pieces import MotionPolynomials, Pieces
from symscrew.optimisation.planned_motion import PlannedMotion

# Halvings of an interval: pieces of a thousandth of it. What cannot be followed in these is singular for all a plan
# of doubles says.
MOST_HALVINGS = 10
# Rows of the excess, which is in proportion to a short piece and has to be below 1, that halves would not bring there:
# such a piece is cut in four.
FAR = 4.0
NEWTON_STEPS, CONVERGED = 12, 1e-11  # of z at one time; [1, rad, m], steps
BOXES = 5  # sizes of a box that are tried, each by what the operator made of the last one
# Of the box that the operator would keep if its excess stayed what it was: the larger box has a larger one. Two sizes
# do for most pieces, where growing by 1.3 took four.
WIDER = 1.2
# Of the solver's own configuration against the one followed [1, rad, m]: constraints hold to 1e-8 scaled, times what
# a nearly singular closure makes of it.
AGREED = 1e-5
# Steps of time by which z is carried to a piece from the solver's nearest point, where Newton's method alone failed. Of
# four points in half a turn they are a tenth of a radian; a step too long ends as a piece that is not proved.
CARRIED = 8
START_STEPS = 20  # from the start's configuration to that of the plan, where conditions leave it free


@dataclass(frozen=True)
class Boxes:
    """Over pieces (n): z at the centres, its slope by x, half widths of the boxes (n, nz), what encloses z' needs."""

    pieces: Pieces
    z: np.ndarray
    slope: np.ndarray
    radius: np.ndarray
    inverse: np.ndarray
    excess: np.ndarray

    def chosen(self, at: np.ndarray) -> Boxes:
        """Some of them."""
        return Boxes(self.pieces.chosen(at), *(getattr(self, n)[at] for n in PARTS))

    def with_others(self, others: Boxes) -> Boxes:
        """These and others."""
        pairs = ((getattr(self, n), getattr(others, n)) for n in PARTS)
        return Boxes(self.pieces.with_others(others.pieces), *(np.concatenate(pair) for pair in pairs))

    def in_order(self) -> Boxes:
        """By time."""
        return self.chosen(np.lexsort((self.pieces.centre, self.pieces.interval)))


PARTS = ("z", "slope", "radius", "inverse", "excess")


@dataclass(frozen=True)
class Followed:
    """The branch of a plan: `boxes` in order of time, and `trouble`, a sentence, where it is not one from the start."""

    boxes: Boxes
    trouble: str = ""


class Branch:
    """The closure of a plan on enclosures."""

    def __init__(self, motion: PlannedMotion) -> None:
        self.motion, self.polynomials = motion, MotionPolynomials(motion)
        equations = motion.model.equations
        y, z = ca.SX.sym("y", motion.model.d), ca.SX.sym("z", len(equations.layout.z))
        p = ca.DM(motion.parameter_values)
        outputs = symbolic_outputs(equations.closure, {"y": y, "z": z, "p": p})
        c = outputs["closure"]
        by_z, by_y = ca.densify(ca.jacobian(c, z)), ca.densify(ca.jacobian(c, y))
        self.size = z.numel()
        self.point = ca.Function("point", [y, z], [c, by_z, by_y])
        self.closure = EnclosedFunction(ca.Function("closure", [y, z], [c]))
        self.by_z = EnclosedFunction(ca.Function("by_z", [y, z], [by_z]))
        self.implied = EnclosedFunction(ca.Function("implied", [y, z], [outputs["implied"]]))

    def at(self, y: np.ndarray, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """c (n, nz), c_z and c_y (n, nz, ...) at numbers."""
        n = len(y)
        c, by_z, by_y = (np.array(m) for m in self.point.map(n)(y.T, z.T))
        by_z, by_y = (
            m.reshape(self.size, n, width).transpose(1, 0, 2)
            for m, width in ((by_z, self.size), (by_y, self.motion.model.d))
        )
        return c.reshape(self.size, n).T, by_z, by_y

    def solved(self, y: np.ndarray, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """z (n, nz) by Newton's method, and where it converged."""
        for _ in range(NEWTON_STEPS):
            c, by_z, _ = self.at(y, z)
            step = _least(by_z, c)
            z = z - step
            size = np.abs(step).max(axis=1, initial=0.0)
            if not (size > CONVERGED).any():
                break
        return z, size <= CONVERGED

    def boxes(self, pieces: Pieces, z: np.ndarray) -> tuple[Boxes, np.ndarray]:
        """Boxes around solutions near z (n, nz), and where each holds one solution for all of its piece."""
        n = len(pieces)
        y = self.polynomials.at("y", pieces)
        z, good = self.solved(y, z)
        _, by_z, by_y = self.at(y, z)
        inverse = np.array([_inverse(m) for m in by_z]).reshape(n, self.size, self.size)
        slope = -np.einsum("nij,njk,nk->ni", inverse, by_y, self.polynomials.slopes("y", pieces))
        given = self.polynomials.enclosed("y", pieces)
        arithmetic = Arithmetic(pieces.radius)
        here = [_number(z[:, k]) for k in range(self.size)]
        mid, rad = _centred(self.closure(arithmetic, [given, here])[0], n)
        offset = np.abs(np.einsum("nij,nj->ni", inverse, mid)) + np.einsum("nij,nj->ni", np.abs(inverse), rad)
        radius, excess = 1.25 * offset + CONVERGED, np.full_like(inverse, np.inf)
        done = np.zeros(n, bool)
        for _ in range(BOXES):
            excess = self._excess(arithmetic, given, (z, radius), inverse)
            made = offset + np.einsum("nij,nj->ni", excess, radius)
            done = good & (made < radius).all(axis=1)
            wanted = _kept(excess, offset + CONVERGED)
            radius = np.where(done[:, None], radius, WIDER * wanted)
            if (done | ~good | ~np.isfinite(wanted).all(axis=1)).all():
                break
        implied = _centred(self.implied(arithmetic, [given, here])[0], n)[1]  # no numbers where a limb cannot reach
        done &= np.isfinite(implied).all(axis=1)
        return Boxes(pieces, z, slope, radius, inverse, excess), done

    def _excess(
        self, arithmetic: Arithmetic, y: list[Enclosure], box: tuple[np.ndarray, np.ndarray], inverse: np.ndarray
    ) -> np.ndarray:
        """Magnitudes of 1 - C c_z([y], [z]): (n, nz, nz)."""
        (z, radius), n = box, len(box[0])
        boxes = [interval(z[:, k] - radius[:, k], z[:, k] + radius[:, k]) for k in range(self.size)]
        values = [interval(*e.value) for e in y]
        mid, rad = _centred(self.by_z(arithmetic, [values, boxes])[0], n)
        shape = (n, self.size, self.size)  # columns come one after the other
        mid, rad = (m.reshape(shape).transpose(0, 2, 1) for m in (mid, rad))
        with np.errstate(invalid="ignore"):
            found = np.abs(np.eye(self.size) - inverse @ mid) + np.abs(inverse) @ rad
        return np.asarray(np.nan_to_num(found, nan=np.inf, posinf=np.inf))

    def enclosed(self, boxes: Boxes) -> list[Enclosure]:
        """z with two derivatives over pieces, from c_z z' = -c_y y' and its derivative."""
        n, pieces = len(boxes.pieces), boxes.pieces
        arithmetic, y = Arithmetic(pieces.radius), self.polynomials.enclosed("y", pieces)
        low, high = boxes.z - boxes.radius, boxes.z + boxes.radius
        none, unknown = np.zeros_like(low), np.full((2, n), np.nan)
        orders = [(low, high), (none, none), (none, none)]
        for order in (1, 2):  # z' is where the closure's slope with z held would be; z'' likewise with z' known
            z = [
                Enclosure(np.array([o[0][:, k] for o in orders]), np.array([o[1][:, k] for o in orders]), unknown)
                for k in range(self.size)
            ]
            rows = self.closure(arithmetic, [y, z])[0]
            mid, rad = _centred(rows, n, order=order)
            best = np.einsum("nij,nj->ni", boxes.inverse, mid)
            spread = np.einsum("nij,nj->ni", np.abs(boxes.inverse), rad)
            unit = np.eye(self.size)
            size = np.array([
                np.linalg.solve(unit - e, a + s) if np.isfinite(e).all() and np.isfinite(a + s).all() else a * np.inf
                for e, a, s in zip(boxes.excess, np.abs(best), spread, strict=True)
            ]).reshape(n, self.size)  # fmt: skip
            around = spread + np.einsum("nij,nj->ni", boxes.excess, size)
            orders[order] = (-best - around, -best + around)
        return [
            Enclosure(
                np.array([o[0][:, k] for o in orders]),
                np.array([o[1][:, k] for o in orders]),
                np.array([boxes.z[:, k], boxes.slope[:, k]]),
            )
            for k in range(self.size)
        ]

    # -- from the start to the end ----------------------------------------------------------------------------

    def followed(self) -> Followed:
        """The plan on its branch, or why it is not on one."""
        motion = self.motion
        mesh, layout = motion.transcribed.mesh, motion.model.equations.layout
        pieces, found = Pieces.whole(len(mesh) - 1), None
        z = motion.nearest(pieces.tau(mesh))[1][:, list(layout.z)]
        while True:
            boxes, good = self.boxes(pieces, z)
            now = boxes.chosen(good)
            found = now if found is None else found.with_others(now)
            if good.all():
                break
            lost = boxes.chosen(~good)
            shortest = lost.pieces.radius <= 0.5**MOST_HALVINGS
            if shortest.any():
                first = float(lost.pieces.chosen(shortest).tau(mesh).min())
                return Followed(found.in_order(), self._singular(first))
            far = ~(lost.excess.sum(axis=2).max(axis=1, initial=0.0) < FAR)
            pieces = lost.pieces.chosen(far).halves().with_others(lost.pieces.chosen(~far)).halves()
            z = self._carried(pieces.tau(mesh))
        assert found is not None
        ordered = found.in_order()
        trouble = self._parted(ordered) or self._elsewhere(ordered)
        return Followed(ordered, trouble or self._other_start(ordered) or self._other_goal(ordered))

    def _carried(self, tau: np.ndarray) -> np.ndarray:
        """z (n, nz) near relative times, from the solver's nearest points; boxes tell whether they are solutions."""
        near, q = self.motion.nearest(tau)
        z = q[:, list(self.motion.model.equations.layout.z)]
        for share in np.linspace(0.0, 1.0, CARRIED + 1)[1:]:
            z, _ = self.solved(self.motion.blocks(near + share * (tau - near))["y"], z)
        return z

    def _singular(self, tau: float) -> str:
        labels = ", ".join(self.motion.labels)
        return (
            f"the motion cannot be followed past {100 * tau:.1f} % of the duration: the coordinates {labels} are "
            "singular there, and branches meet; name others under 'independent'"
        )

    def _parted(self, boxes: Boxes) -> str:
        """Where neighbours do not share their solution."""
        if len(boxes.pieces) < 2:
            return ""
        first, last = boxes.chosen(np.arange(len(boxes.pieces) - 1)), boxes.chosen(np.arange(1, len(boxes.pieces)))
        y = self.polynomials.at("y", first.pieces, 1.0)
        left, one = self.solved(y, first.z + first.slope * first.pieces.radius[:, None])
        right, two = self.solved(y, last.z - last.slope * last.pieces.radius[:, None])
        inside = (np.abs(left - first.z) <= first.radius).all(axis=1) & one & two
        apart = np.where(inside, np.abs(left - right).max(axis=1, initial=0.0), np.inf)
        far = np.flatnonzero(apart > AGREED)
        return self._jump(boxes, int(far[0]), left[far[0]], right[far[0]]) if len(far) else ""

    def _elsewhere(self, boxes: Boxes) -> str:
        """Where the solver's own configurations lie outside the boxes."""
        motion, mesh = self.motion, self.motion.transcribed.mesh
        points = motion.transcribed.point_tau
        places = [(points.ravel(), motion.arrays["z"].reshape(points.size, -1), "")]
        for k, (tau, _) in enumerate(observed(motion.model)):
            if f"observed_{k}" in motion.arrays:
                where = ("at the start", "at the goal")[k] if k < 2 else f"at via point {k - 1}"
                places.append((np.array([tau]), motion.arrays[f"observed_{k}"].reshape(1, -1), where))
        ends = boxes.pieces.tau(mesh) + boxes.pieces.radius * np.diff(mesh)[boxes.pieces.interval] / 2
        for times, z, where in places:
            at = np.clip(np.searchsorted(ends, times - 1e-12), 0, len(ends) - 1)  # 1e-12: times are sums that round
            off = np.abs(z - boxes.z[at]) - boxes.radius[at]
            far = np.flatnonzero((off > AGREED).any(axis=1))
            if len(far):
                k = int(far[0])
                return self._jump(boxes, int(at[k]), boxes.z[at[k]], z[k], where=where)
        return ""

    def _other_start(self, boxes: Boxes) -> str:
        """Whether the plan starts on the assembly mode of the configuration that the start's conditions give."""
        motion, start = self.motion, self.motion.problem.start
        if not self.size:
            return ""
        near = motion.kinematics.place(start, "the start", beginning(motion.model.system, start)).q
        off = self._off_mode(boxes.chosen(np.zeros(1, int)), near, -1.0)
        return f"the plan starts on another assembly mode than the start: {off}" if off else ""

    def _other_goal(self, boxes: Boxes) -> str:
        """Whether the plan ends on the assembly mode that its end names."""
        motion, end = self.motion, self.motion.problem.end
        if not self.size or not end.mode:
            return ""
        system = motion.model.system
        near = motion.kinematics.place(end, "the goal", ending(system, end, np.asarray(system.reference))).q
        off = self._off_mode(boxes.chosen(np.array([len(boxes.pieces) - 1])), near, 1.0)
        return f"the plan ends on another assembly mode than {end.mode!r}: {off}" if off else ""

    def _off_mode(self, box: Boxes, near: np.ndarray, side: float) -> str:
        """What is off at one end of a box against the branch of a configuration, empty where nothing is."""
        motion, layout = self.motion, self.motion.model.equations.layout
        goal = self.polynomials.at("y", box.pieces, side)[0]
        q: np.ndarray | None = near
        for y in np.linspace(near[list(layout.y)], goal, START_STEPS + 1):
            q = motion.kinematics.assemble(y, near)
            if q is None:
                return ""  # no way between the two that could tell
            near = q
        found, _ = self.solved(goal[None], box.z + side * box.slope * box.pieces.radius[:, None])
        gap = np.abs(found[0] - near[list(layout.z)])
        turns = np.array([motion.model.system.tree.q[k].kind == "angle" for k in layout.z])
        gap = np.where(turns, np.abs((gap + np.pi) % (2 * np.pi) - np.pi), gap)
        if not gap.max() > AGREED:
            return ""
        label = motion.model.system.tree.q[layout.z[int(np.argmax(gap))]].label
        return f"{label} is off by {gap.max():.3g}"

    def _jump(self, boxes: Boxes, k: int, here: np.ndarray, there: np.ndarray, *, where: str = "") -> str:
        layout, tree = self.motion.model.equations.layout, self.motion.model.system.tree
        tau = float(boxes.pieces.chosen(np.array([k])).tau(self.motion.transcribed.mesh)[0])
        gap = np.abs(here - there)
        worst = int(np.argmax(np.where(np.isfinite(gap), gap, np.inf)))
        label = tree.q[layout.z[worst]].label
        at = where or f"near {100 * tau:.1f} % of the duration"
        return f"the plan leaves its assembly mode {at}: {label} would jump by {gap[worst]:.3g}"


def followed_branch(motion: PlannedMotion) -> Followed:
    """The plan from its start on its assembly mode."""
    return Branch(motion).followed()


def _number(values: np.ndarray) -> Number:
    parts = np.zeros((3, len(values)))
    parts[0] = values
    return Enclosure(parts, parts, parts[:2])


def _centred(values: list[Number], n: int, order: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Middles and half widths (n, entries) of values, or of their derivatives."""
    pairs = []
    if not values:
        return np.zeros((n, 0)), np.zeros((n, 0))
    for v in values:
        if order == 0 or not isinstance(v, Enclosure):
            pairs.append(bounds_of(v if order == 0 else 0.0, n))
        else:
            pairs.append((np.broadcast_to(v.low[order], (n,)), np.broadcast_to(v.high[order], (n,))))
    low, high = (np.array(part).reshape(len(values), n).T for part in zip(*pairs, strict=True))
    with np.errstate(invalid="ignore"):
        return (low + high) / 2, np.nan_to_num((high - low) / 2, nan=np.inf, posinf=np.inf)


def _kept(excess: np.ndarray, offset: np.ndarray) -> np.ndarray:
    """Half widths r = offset + excess r (n, nz), infinite where there are none: nor are there of any larger box.

    `offset` > 0 and `excess` >= 0: such r > 0 are there only where the excess's powers vanish (it is an M-matrix that
    is inverted), and the excess grows with the box.
    """
    found, unit = np.full_like(offset, np.inf), np.eye(offset.shape[1])
    for k in np.flatnonzero(np.isfinite(excess).all(axis=(1, 2)) & np.isfinite(offset).all(axis=1)):
        try:
            r = np.linalg.solve(unit - excess[k], offset[k])
        except np.linalg.LinAlgError:
            continue
        if (r > 0).all():
            found[k] = r
    return found


def _inverse(matrix: np.ndarray) -> np.ndarray:
    return np.linalg.pinv(matrix) if np.isfinite(matrix).all() else np.zeros_like(matrix)


def _least(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Solutions of linear systems (n, nz, nz), not a number where there is none."""
    result = np.full_like(right, np.nan)
    for k, m in enumerate(matrix):
        if np.isfinite(m).all() and np.isfinite(right[k]).all() and m.size:
            result[k] = np.linalg.lstsq(m, right[k], rcond=None)[0]
    return result if right.shape[1] else np.zeros_like(right)
