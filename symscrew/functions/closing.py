"""Functions that solve the loops: assembly, rates and accelerations from the independent coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symscrew.algebra import Guard, Node, Tape, TapeMark, Vector, add, cross, dot, scale
from symscrew.functions.ports import a_port, function, length_units, q_port, ratio_units, v_port, y_port
from symscrew.kinematics import Row, System
from symscrew.loops import Loops, any_rods, closed_limbs, hub_links, limb_coordinates
from symscrew.program import NOT_ON_MECHANISM, Function, Iteration, NodeLimit, Port, lower, signature

# A pivot below this, without units, is reported as near-singular: seven digits of a result are left there. Above it the
# status is 0 and nothing is said.
THRESHOLD = 1e-9
# The same for a step of the assembly: it passes near singular configurations on its way, where a step is only worse,
# and the result is judged by its residual; below this a step has no digit left.
NEWTON_THRESHOLD = 1e-12
# A pose whose loops are open by more than this, lengths divided by the characteristic length, is none of the mechanism,
# and rates or accelerations that open them by this part of their own size are none of its motions. What was assembled,
# integrated or written with eight digits is within 1e-8, in single precision 3e-7; at the limit results are off by
# about as much as the loops are open.
CLOSED = 1e-6
# Largest Newton step [rad, or characteristic lengths]: a longer one is scaled down to it, as beyond about half a radian
# the linear model of a rotation points to another assembly mode.
STEP_LIMIT = 0.5


def guarded(guards: Sequence[Guard], threshold: float = THRESHOLD) -> list[tuple[Node, float]]:
    """Pivots with their run-time thresholds in the pivots' own units."""
    return [(guard.pivot, threshold / guard.scale) for guard in guards]


def closed(system: System, openings: Sequence[tuple[Node, Row]], size: Node | None = None) -> tuple[NodeLimit, ...]:
    """That loops open by no more than `CLOSED`, of `size` (a square, without units) if it is given.

    `openings`: how far, or how fast, rows of cut joints open.
    """
    tape = system.tape
    total = squares(system, [(value, row.unit == "N") for value, row in openings])
    if size is not None:
        return ((total - tape.constant(CLOSED**2) * size, None, 0.0, NOT_ON_MECHANISM),) if openings else ()
    return ((total, None, CLOSED**2, NOT_ON_MECHANISM),) if openings else ()


def squares(system: System, values: Sequence[tuple[Node, bool]]) -> Node:
    """The sum of squares of (value, whether it is a length), lengths divided by the characteristic length."""
    tape = system.tape
    lengths, others = tape.zero, tape.zero
    for value, is_length in values:
        if is_length:
            lengths = lengths + value * value
        else:
            others = others + value * value
    return others + lengths * tape.constant(1.0 / system.length**2)


def closure_functions(system: System, loops: Loops, notes: Sequence[str]) -> list[Function]:
    """Closure residual, Jacobian and bias; rates and accelerations from the independent ones.

    `notes`: what is said of functions that solve the loops, `loop_notes`.
    """
    q = (q_port(system), system.inputs.q)
    v = (v_port(system), system.inputs.v)
    rates = loops.rates_from(loops.inputs("ydot"))
    functions = []
    if system.cuts:
        functions += _residual_functions(system)
    functions.append(
        function(
            system,
            "velocity",
            "Rates of the tree from the rates of the independent coordinates.",
            inputs=[q, (y_port(loops, "y_dot", 1), loops.inputs("ydot"))],
            outputs=[(v_port(system), system.tree_rates(rates))],
            guards=guarded(loops.guards),
            notes=notes,
        )
    )
    functions.append(_null_space(system, loops, notes))
    gains = loops.accelerations_from(loops.inputs("yddot"), loops.bias(system))
    functions.append(
        function(
            system,
            "acceleration",
            "Accelerations of the tree from the second rates of the independent coordinates.",
            inputs=[q, v, (y_port(loops, "y_ddot", 2), loops.inputs("yddot"))],
            outputs=[(a_port(system), system.tree_rates(gains))],
            guards=guarded(loops.guards),
            notes=notes,
        )
    )
    return functions


def _null_space(system: System, loops: Loops, notes: Sequence[str]) -> Function:
    tape, count, n = system.tape, len(loops.entries), len(system.tree.v)
    values = []
    for k in range(count):
        unit = [tape.one if i == k else tape.zero for i in range(count)]
        values += system.tree_rates(loops.rates_from(unit))
    labels = tuple(f"{c.label}|{y}" for y in loops.labels for c in system.tree.v)
    units = ratio_units(length_units(system), y_port(loops, "y", 0).units)
    port = Port("null_space", (n, count), units, labels, "columns: v for a unit rate of each y")
    text = "Null space of the closure: v = null_space y_dot."
    q = (q_port(system), system.inputs.q)
    return function(
        system, "null_space", text, inputs=[q], outputs=[(port, values)], guards=guarded(loops.guards), notes=notes
    )


def loop_notes(loops: Loops) -> tuple[str, ...]:
    """What a user of functions that solve the loops must know; `loops` by the system's own rows."""
    notes = [f"independent coordinates y: {', '.join(loops.labels) or 'none'}"]
    if loops.redundant:
        notes.append(f"redundant closure constraints (satisfied by the others): {', '.join(loops.redundant)}")
    if loops.shaky:
        notes.append(
            "the reference configuration is singular, as every other one that was found is: the mechanism is shaky all "
            "along, and functions that solve the loops return status 1 or 3"
        )
    elif loops.singular_reference:
        notes.append(
            "the reference configuration is singular: the closure loses rank there, and functions that solve it "
            "return status 1 at and close to it"
        )
    if loops.undetermined_reference:
        notes.append(
            "in the reference configuration the independent coordinates do not determine the others: functions that "
            "solve the loops return status 1 at and close to it; choose others (independent)"
        )
    return tuple(notes)


def _residual_functions(system: System) -> list[Function]:
    q = (q_port(system), system.inputs.q)
    v = (v_port(system), system.inputs.v)
    labels = tuple(row.label for cut in system.cuts for row in cut.rows)
    units = tuple("m" if row.unit == "N" else "rad" for cut in system.cuts for row in cut.rows)
    count, n = len(labels), len(system.tree.v)
    columns = jacobian_in_v(system)
    entries = [columns[k][i] for k in range(n) for i in range(count)]
    of_entries = ratio_units(units, length_units(system))
    kinds = list(dict.fromkeys(of_entries))
    text = "rows: as of closure, columns: as of v" + (f"; units {', '.join(kinds)}" if len(kinds) > 1 else "")
    jacobian = Port("jacobian", (count, n), of_entries, (), text)
    residual = Port("residual", (count,), units, labels, "how far each cut joint is open")
    bias = system.bias(system.rates([system.tape.zero] * n))
    bias_port = Port("bias", (count,), tuple(f"{u}/s^2" for u in units), labels, "(dJ/dt) v")
    return [
        function(system, "closure", "How far the loops are open, in the cut joints' tip axes.", inputs=[q],
                 outputs=[(residual, system.residual)]),
        function(system, "closure_jacobian",
                 "Closure Jacobian: row k is the reciprocal wrench k of the cut joints, J v = 0.", inputs=[q],
                 outputs=[(jacobian, entries)]),
        function(system, "closure_bias", "Closure of accelerations: J a + bias = 0.", inputs=[q, v],
                 outputs=[(bias_port, bias)]),
    ]  # fmt: skip


def jacobian_in_v(system: System) -> list[list[Node]]:
    """Columns of the closure Jacobian with respect to v (spherical rates in the child's axes)."""
    tape = system.tape
    columns = [[row.get(k, tape.zero) for row in system.jacobian] for k in range(len(system.tree.v))]
    for link in system.tree.links[1:]:
        if not link.motion.spherical:
            continue
        turn = system.placed[link.index].turn
        old = columns[link.v]
        for j in range(3):
            columns[link.v.start + j] = [
                dot((old[0][i], old[1][i], old[2][i]), (turn[0][j], turn[1][j], turn[2][j]))
                for i in range(len(system.jacobian))
            ]
    return columns


@dataclass(frozen=True)
class Assembly:
    """The function `assemble` before lowering: the step that it repeats, and its own ports."""

    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]
    step: Function
    independent: tuple[int, ...]
    notes: tuple[str, ...]
    name: str = "assemble"
    description: str = (
        "Configuration of the tree that closes all loops at the given independent coordinates, on the branch of the "
        "guess."
    )
    reach: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"Assembly({signature(self.name, self.inputs, self.outputs)})"

    def lowered(self, mark: TapeMark | None = None) -> Iteration:
        """The iteration; `mark` as for `lower`."""
        step = lower(self.step, mark)
        return Iteration(
            self.name, self.description, self.inputs, self.outputs, step, self.independent, notes=self.notes
        )


def assembly(system: System, loops: Loops) -> Assembly:
    """Assembly of the loops from y and a guess: Newton on the closure.

    On the platform's coordinates alone where its limbs have closed forms, except those of rods: with these fewer
    guesses whose loops are open lead to a solution, and a step takes more operations.
    """
    y = loops.inputs("y")
    ports = (y_port(loops, "y", 0), q_port(system, "guess", "a configuration on the wanted branch"))
    step = loops.newton_step(y)
    scales = [1.0 / float(scale) for scale in system.scales]
    tape = system.tape
    size = _norm(tape, [s * tape.constant(f) for s, f in zip(step, scales, strict=True)])
    limit = tape.constant(STEP_LIMIT)
    small = tape.function("less", size, limit)
    factor = tape.function("select", small, tape.one, limit / tape.function("select", small, tape.one, size))
    moved = moved_by(system, [factor * s for s in step])
    limbs, hub = closed_limbs(system), hub_links(system)
    alone = limbs is not None and hub is not None and all(entry.link in hub for entry in loops.entries)
    if limbs and hub and alone and not any_rods(limbs):
        # Only the platform's coordinates are iterated; its limbs follow in closed form, on the guess's branch.
        # Not where y are a limb's: the limb's closed form is singular where the platform turns back.
        known = {k: moved[k] for link in hub for k in range(link.q.start, link.q.stop)}
        moved = list(limb_coordinates(system, limbs, known, system.inputs.q).q)
    residual = opening(system)
    orientation = tape.one
    for pivot in loops.pivots:
        orientation = orientation * pivot
    single = [Port(n, (1,), ("1",), (n,), t) for n, t in (
        ("residual", "opening of the loops at q"), ("step", "size of the step"), ("orientation", "sign of the branch")
    )]  # fmt: skip
    newton = function(
        system,
        "assemble_step",
        "One Newton step of the assembly.",
        inputs=[(q_port(system), system.inputs.q), (ports[0], y)],
        outputs=[
            (q_port(system, "q_next"), moved),
            *((p, [n]) for p, n in zip(single, (residual, size, orientation), strict=True)),
        ],
        guards=guarded(loops.guards, NEWTON_THRESHOLD),
    )
    parameter_ports, _ = system.parameter_ports()
    independent = tuple(entry.q for entry in loops.entries)
    return Assembly((*ports, *parameter_ports), (q_port(system),), newton, independent, loop_notes(loops))


def opening(system: System) -> Node:
    """How far the loops are open: root of the sum of squares, lengths divided by the characteristic length."""
    tape = system.tape
    scales = [1.0 / system.length if row.unit == "N" else 1.0 for cut in system.cuts for row in cut.rows]
    return _norm(tape, [g * tape.constant(f) for g, f in zip(system.residual, scales, strict=True)])


def _norm(tape: Tape, values: Sequence[Node]) -> Node:
    total = tape.zero
    for value in values:
        total = total + value * value
    return tape.sqrt(total)


def moved_by(system: System, step: Sequence[Node]) -> list[Node]:
    """q after a step along joint rates w [rad, m]: sums, and for a quaternion (w, r) with the rotation vector n

    (w, r) + (n / 2) o (w, r), normalised: right to first order in the step, as a Newton step is.
    """
    q = list(system.inputs.q)
    half = system.tape.reciprocal(system.tape.node(2))
    for link in system.tree.links[1:]:
        if not link.motion.spherical:
            for i, k in zip(range(link.q.start, link.q.stop), range(link.v.start, link.v.stop), strict=True):
                q[i] = q[i] + step[k]
            continue
        w, x, y, z = system.inputs.q[link.q]
        vector: Vector = (x, y, z)
        a, b, c = step[link.v]
        turn = scale(half, (a, b, c))
        scalar = w - dot(turn, vector)
        moved = add(add(vector, scale(w, turn)), cross(turn, vector))
        inverse = 1 / _norm(system.tape, (scalar, *moved))
        q[link.q] = [scalar * inverse, *scale(inverse, moved)]
    return q
