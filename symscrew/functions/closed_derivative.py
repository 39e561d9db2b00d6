"""Derivatives of the dynamics of closed chains by the independent coordinates, from the equations of motion.

With the columns N of admissible rates (w = N f), a motion of the drives u and multipliers m obeys

    r = (generalised forces of dw/dt) - J^T m - B u = 0.

Along a consistent change of the state N^T dr = N^T B du with m held: J^T m stands across all columns, so that
neither N nor m is differentiated. What is left are the changes of the motion itself. For dq = N_j, w changes by

    dw = c_j / 2 - (w x N_j) / 2,    c_j the change of dw/dt for a change N_j of w alone,

because J dw = -dJ[N_j] w is half of that of the closure's bias, which is quadratic in w; the product stands at
spherical joints only, whose rates are no coordinates' rates (w and N_j in the axes before the joint).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from symscrew.algebra import Affine, Guard, Node, cross, dot
from symscrew.dynamics import (
    ONE,
    Admissible,
    Direction,
    Variation,
    closure_changes,
    generalised_forces,
    mass_matrix,
    power_changes,
    solve_drives,
    solve_symmetric,
    three,
)
from symscrew.effects import Acting, Effect
from symscrew.functions.forward import driven
from symscrew.functions.ports import drive_is_force
from symscrew.kinematics import System
from symscrew.loops import Loops

Matrix = list[list[Node]]  # rows: free joint rates


@dataclass(frozen=True)
class Derivatives:
    """Columns of derivatives by y, y_dot and y_ddot (inverse dynamics) or u (forward dynamics); guarded pivots."""

    groups: tuple[Matrix, Matrix, Matrix]
    guards: tuple[Guard, ...]


def covers(system: System, acting: Acting) -> bool:
    """Whether the equations here hold for a system and what acts on it."""
    plain = not (acting.needs_reactions or acting.simplified or acting.transmissions or acting.bendings)
    changing = any(not coupling.linear for coupling in system.mechanism.couplings.values())  # J^T m changes with q
    changing = changing or bool(system.structure.rolled)
    return bool(system.cuts) and not system.cut_drives() and plain and not changing


def inverse_derivatives(system: System, effects: Sequence[Effect], loops: Loops) -> Derivatives | None:
    """Of the drives by (y, y_dot, y_ddot); None where freedoms carry no drive."""
    independent = _Independent(loops)
    moving = ClosedMotion.steady(system, loops, independent.free_rates(loops.inputs("ydot")))
    motion = moving.with_gains(independent.free_gains(moving.w, moving.w_dot, loops.inputs("yddot")))
    acting = Acting(motion.system, effects)
    missing = system.joint_rates(generalised_forces(motion.system, acting, motion.system.inputs.a))
    rows = system.drive_rows()
    drives = Drives(motion, {u: k for k, u in rows.items()})
    needed = [inner(column, missing) for column in motion.columns]
    found = drives.solve(needed)
    if found is None:
        return None
    u, guards = found
    left = list(missing)
    for k, drive in rows.items():
        left[k] = left[k] - u[drive]
    by = motion.powers(acting, multipliers(loops, left))
    moved = drives.moved(needed)
    groups = []
    for g, columns in enumerate(by):
        group = []
        for k, column in enumerate(columns):
            shift = moved[k] if g == 0 else [system.tape.zero] * len(u)
            right = [value - inner(row, shift) for value, row in zip(column, drives.rows, strict=True)]
            solved = drives.solve(right)
            assert solved is not None
            group.append([x + s for x, s in zip(solved[0], shift, strict=True)])
        groups.append(group)
    return Derivatives((groups[0], groups[1], groups[2]), guards)


def forward_derivatives(system: System, effects: Sequence[Effect], loops: Loops) -> Derivatives:
    """Of the second rates of y by (y, y_dot, u)."""
    independent = _Independent(loops)
    moving = ClosedMotion.steady(system, loops, independent.free_rates(loops.inputs("ydot")))
    acting, drives = driven(moving.system, effects)
    admissible = Admissible(moving.system, loops, acting.added_inertia)
    free, guards = admissible.solve([-r for r in admissible.residual(moving.system.inputs.a, acting)])
    motion = moving.with_gains(free)
    acting, _ = driven(motion.system, effects)
    missing = system.joint_rates(generalised_forces(motion.system, acting, motion.system.inputs.a))
    by_y, by_rate, _ = motion.powers(acting, multipliers(loops, missing))
    rows = Drives(motion, {u: k for k, u in system.drive_rows().items()}).rows
    count = len(drives[0][1]) if drives else 0
    by_u = [[-row[j] for row in rows] for j in range(count)]

    def solved(columns: Sequence[Sequence[Node]]) -> list[list[Node]]:
        return [independent.rates(motion.moved(admissible.solve([-c for c in column])[0])) for column in columns]

    return Derivatives((solved(by_y), solved(by_rate), solved(by_u)), tuple(guards))


@dataclass(frozen=True)
class _Independent:
    """From joint rates to the rates of y and back, where some of y are components r of quaternions (w, r).

    With the angular velocity n before the joint, the quaternion's rate is n o (w, r) / 2 (quaternion product) and
    its second rate n_dot o (w, r) / 2 - |n|^2 (w, r) / 4.
    """

    loops: Loops

    @property
    def plain(self) -> bool:
        """Whether all of y are entries of q with rates of their own."""
        return not self.loops.small.steps

    def rates(self, w: Sequence[Node]) -> list[Node]:
        """Rates of y."""
        loops = self.loops
        return [w[e.v] if e.component is None else loops.quaternion_rate(e, w) for e in loops.entries]

    def free_rates(self, rates: Sequence[Node]) -> list[Node]:
        """Free joint rates that give y these rates."""
        if self.plain:
            return list(rates)
        found = self.loops.small.solve(rates)
        return [found.get(j, self.loops.system.tape.zero) for j in range(len(rates))]

    def turned(self, x: Sequence[Node], y: Sequence[Node], factor: float) -> list[Node]:
        """factor (x . y) r: rates of y by products of joint rates, none for plain entries."""
        tape, result = self.loops.system.tape, []
        for entry in self.loops.entries:
            if entry.component is None:
                result.append(tape.zero)
                continue
            _, r = self.loops.quaternion(entry.link)
            product = tape.node(dot(three(x, entry.link), three(y, entry.link)))
            result.append(tape.constant(factor) * product * r[entry.component])
        return result

    def quaternion_rates(self, w: Sequence[Node]) -> list[Node]:
        """Rates of y, zero for plain entries."""
        zero, loops = self.loops.system.tape.zero, self.loops
        return [zero if e.component is None else loops.quaternion_rate(e, w) for e in loops.entries]

    def free_gains(self, w: Sequence[Node], start: Sequence[Node], second: Sequence[Node]) -> list[Node]:
        """Rates of the free joint rates for second rates of y; `start` is dw/dt without them."""
        if self.plain:
            return list(second)
        parts = zip(second, self.quaternion_rates(start), self.turned(w, w, -0.25), strict=True)
        return self.free_rates([y - p - b for y, p, b in parts])


@dataclass(frozen=True)
class ClosedMotion:
    """A consistent motion of a system with loops: its nodes q, v, a, and the same rates as w and dw/dt.

    `following`: changes of dw/dt for changes N_j of w, free joint rates and configuration steady.
    """

    system: System
    loops: Loops
    w: list[Node]
    w_dot: list[Node]
    following: list[list[Node]]

    @classmethod
    def steady(cls, system: System, loops: Loops, f: Sequence[Node]) -> ClosedMotion:
        """The motion with given free joint rates that do not change: dw/dt is quadratic in w = N f."""
        zero = [system.tape.zero] * len(system.tree.v)
        half = system.tape.reciprocal(system.tape.node(2))
        w = Admissible(system, loops).moved(zero, f)
        following = _following(system, loops, w)
        w_dot = zero
        for amount, column in zip(f, following, strict=True):
            w_dot = [x + half * amount * y for x, y in zip(w_dot, column, strict=True)]
        moving = system.at(system.inputs.q, {}, system.tree_rates(w), system.tree_rates(w_dot))
        return cls(moving, loops, w, w_dot, following)

    def with_gains(self, free: Sequence[Node]) -> ClosedMotion:
        """The same motion with rates of the free joint rates added."""
        w_dot = self.moved(free, self.w_dot)
        system = self.system.at(self.system.inputs.q, {}, self.system.inputs.v, self.system.tree_rates(w_dot))
        return replace(self, system=system, w_dot=w_dot)

    @cached_property
    def columns(self) -> list[list[Node]]:
        """N, in joint rates w."""
        return Admissible(self.system, self.loops).columns

    def moved(self, amounts: Sequence[Node], start: Sequence[Node] | None = None) -> list[Node]:
        """start + N amounts."""
        return Admissible(self.system, self.loops).moved(start or self._still(), amounts)

    # -- changes of the motion ------------------------------------------------------------------------------------

    def _dependent(self, rows: Sequence[Node]) -> list[Node]:
        """w or dw/dt for a change of the closure's rows, free rates steady."""
        return self.loops.dependent([-row for row in rows], [self.system.tape.zero] * len(self.loops.free))

    def _still(self) -> list[Node]:
        return [self.system.tape.zero] * len(self.w)

    @cached_property
    def by_rates(self) -> list[Direction]:
        """Changes N_j of w alone, before dw/dt follows."""
        return [Direction(f"rate{j}", self._still(), column, self._still()) for j, column in enumerate(self.columns)]

    @cached_property
    def following_free(self) -> list[list[Node]]:
        """What the free joint rates add to that for steady second rates of y."""
        independent = _Independent(self.loops)
        if independent.plain:
            return [[self.system.tape.zero] * len(self.columns) for _ in self.columns]
        result = []
        for column, change in zip(self.columns, self.following, strict=True):
            parts = zip(independent.quaternion_rates(change), independent.turned(self.w, column, -0.5), strict=True)
            result.append(independent.free_rates([-(a + b) for a, b in parts]))
        return result

    @cached_property
    def by_steps(self) -> list[Direction]:
        """Displacements N_j with changes of w that keep the loops closed, before dw/dt follows.

        For steady rates of y half of `following_free` would have to be added to the free joint rates: that is left
        to their own columns of the derivatives.
        """
        half, result = self.system.tape.reciprocal(self.system.tape.node(2)), []
        for j, (column, change) in enumerate(zip(self.columns, self.following, strict=True)):
            rate = [half * (c - t) for c, t in zip(change, self._product(self.w, column), strict=True)]
            result.append(Direction(f"step{j}", column, rate, self._still()))
        return result

    @cached_property
    def displaced(self) -> list[list[Node]]:
        """Changes of dw/dt along the steps, free joint rates steady."""
        return [self._dependent(rows) for rows in closure_changes(self._variation(self.by_steps))]

    @cached_property
    def displaced_free(self) -> list[list[Node]]:
        """What the free joint rates add to that for steady second rates of y."""
        independent, tape = _Independent(self.loops), self.system.tape
        if independent.plain:
            return [[tape.zero] * len(self.columns) for _ in self.columns]
        half, result = tape.reciprocal(tape.node(2)), []
        squares = [-x for x in self.turned_squares]
        for direction, change in zip(self.by_steps, self.displaced, strict=True):
            product = self._product(self.w_dot, direction.step)
            turned = [c + half * p for c, p in zip(change, product, strict=True)]
            parts = zip(
                independent.quaternion_rates(turned),
                independent.turned(self.w_dot, direction.step, -0.25),
                independent.turned(self.w, direction.rate, -0.5),
                (x * y for x, y in zip(squares, independent.quaternion_rates(direction.step), strict=True)),
                strict=True,
            )
            result.append(independent.free_rates([-(a + b + c + d) for a, b, c, d in parts]))
        return result

    @property
    def turned_squares(self) -> list[Node]:
        """|n|^2 / 4 of the spherical joint of every entry of y, zero for plain entries."""
        tape = self.system.tape
        spheres = [None if e.component is None else three(self.w, e.link) for e in self.loops.entries]
        return [tape.zero if n is None else tape.constant(0.25) * tape.node(dot(n, n)) for n in spheres]

    def _variation(self, directions: Sequence[Direction]) -> Variation:
        return Variation(self.system, self.w, self.w_dot, directions)

    def _product(self, x: Sequence[Node], y: Sequence[Node]) -> list[Node]:
        """x x y at spherical joints, else zero."""
        tape, result = self.system.tape, self._still()
        for link in self.system.tree.links[1:]:
            if link.motion.spherical:
                result[link.v] = [tape.node(c) for c in cross(three(x, link), three(y, link))]
        return result

    # -- forces -----------------------------------------------------------------------------------------------------

    def powers(self, acting: Acting, multipliers: Mapping[int, Node]) -> tuple[Matrix, Matrix, Matrix]:
        """Changes of N^T r, multipliers and drives held, by y, y_dot, y_ddot: columns of entries per free rate."""
        count, columns, system = len(self.columns), self.columns, self.system
        tree = mass_matrix(system, acting.added_inertia)
        gains = [[inner(row, system.tree_rates(gain)) for row in tree] for gain in (*self.displaced, *self.following)]
        every = self._variation([*self.by_steps, *self.by_rates])
        changes = power_changes(every, acting, multipliers=multipliers, columns=columns, forces=gains)
        in_v = [system.tree_rates(column) for column in columns]
        momenta = [[inner(row, column) for row in tree] for column in in_v]
        inertia = [[inner(in_v[min(i, k)], momenta[max(i, k)]) for i in range(count)] for k in range(count)]
        groups = []
        for start, free in ((0, self.displaced_free), (count, self.following_free)):
            group = []
            for j in range(count):
                column = [changes[i][start + j] for i in range(count)]
                group.append([x + inner(row, free[j]) for x, row in zip(column, inertia, strict=True)])
            groups.append(group)
        half = self.system.tape.reciprocal(self.system.tape.node(2))
        for column, added in zip(groups[0], self.following_free, strict=True):
            for i in range(count):
                column[i] = column[i] + half * inner(added, [change[i] for change in groups[1]])
        return (self.per_y(groups[0]), self.per_y(groups[1]), self.per_y(inertia))

    def per_y(self, columns: Matrix) -> Matrix:
        """Columns per free joint rate as columns per entry of y."""
        tape, count = self.system.tape, len(columns)
        result = []
        for k in range(count):
            unit = [tape.one if i == k else tape.zero for i in range(count)]
            free = _Independent(self.loops).free_rates(unit)
            result.append([inner(free, [column[i] for column in columns]) for i in range(len(columns[0]))])
        return result


@dataclass(frozen=True)
class Drives:
    """The drives of a motion: their rates per free joint rate, unique or of smallest sum of squares.

    `places`: index into u -> index into v.
    """

    motion: ClosedMotion
    places: Mapping[int, int]

    @cached_property
    def rows(self) -> Matrix:
        """N^T B."""
        return [[column[self.places[u]] for u in sorted(self.places)] for column in self.motion.columns]

    def solve(self, right: Sequence[Node]) -> tuple[list[Node], tuple[Guard, ...]] | None:
        """u with N^T B u = right; None unless every freedom can be driven."""
        system = self.motion.system
        finals: list[Affine] = []
        for row, value in zip(self.rows, right, strict=True):
            final: Affine = {("drive", u): e for u, e in enumerate(row) if e is not system.tape.zero}
            finals.append({**final, ONE: -value})
        scales = {u: 1.0 if drive_is_force(system, u) else system.length for u in sorted(self.places)}
        found = solve_drives(system.tape, finals, scales, several=True)
        if found.unreachable or len(scales) - found.redundancy != len(right):
            return None
        return list(found.u), found.guards

    def moved(self, right: Sequence[Node]) -> Matrix:
        """Changes of u per entry of y at fixed m, where redundant drives are u = B^T N m: the rates N m bend."""
        motion, columns, count = self.motion, self.motion.columns, len(self.motion.columns)
        tape = motion.system.tape
        if len(self.places) == count:
            return [[tape.zero] * len(self.places) for _ in columns]
        normal = [[inner(x, y) for y in self.rows] for x in self.rows]
        amounts, _ = solve_symmetric(tape, normal, right, [1.0] * count)
        # What a change of m adds to the bend makes no difference to the drives.
        half = tape.reciprocal(tape.node(2))
        bends = _following(motion.system, motion.loops, motion.moved([half * amount for amount in amounts]))
        return motion.per_y([[bend[self.places[u]] for u in sorted(self.places)] for bend in bends])


def _following(system: System, loops: Loops, w: Sequence[Node]) -> list[list[Node]]:
    """Changes of dw/dt for changes N_j of the rates w, free joint rates steady."""
    still = [system.tape.zero] * len(w)
    moving = system.at(system.inputs.q, {}, system.tree_rates(w), still)
    columns = Admissible(system, loops).columns
    directions = [Direction(f"rate{j}", still, column, still) for j, column in enumerate(columns)]
    rows = closure_changes(Variation(moving, w, still, directions))
    return [loops.dependent([-x for x in row], [system.tape.zero] * len(loops.free)) for row in rows]


def multipliers(loops: Loops, right: Sequence[Node]) -> dict[int, Node]:
    """Multipliers by row with J^T multipliers = right in the dependent joint rates, by the factors of J."""
    steps, upper = loops.elimination.steps, loops.elimination.upper
    result: dict[int, Node] = {}
    for count, (row, column, pivot, _) in enumerate(steps):
        total = right[column] if isinstance(column, int) else loops.system.tape.zero
        for earlier, *_ in steps[:count]:
            if column in upper[earlier]:
                total = total - upper[earlier][column] * result[earlier]
        result[row] = total * (1 / pivot)
    for row, _, _, factors in reversed(steps):
        for other, factor in factors.items():
            if other in result:
                result[row] = result[row] - factor * result[other]
    return result


def inner(x: Sequence[Node], y: Sequence[Node]) -> Node:
    """x . y."""
    total = x[0].tape.zero
    for a, b in zip(x, y, strict=True):
        total = total + a * b
    return total
