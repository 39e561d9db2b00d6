"""The programs of a run: slopes of the state with the scene's controller inside, drives, closure.

All have the inputs t, q, v, x, u, s, p: time, configuration, rates, states (those of the effects and of the
controller, last the work done by drives and effects), drives held from outside (none where the scene commands
them), values of the scene's tables at t, run-time parameters. Ports that a scene does not need have size 0.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from symscrew.functions import a_port, q_port, u_port, v_port
from symscrew.kinematics import System
from symscrew.model import Model
from symscrew.program import Port, Program, RankRevealing, evaluate
from symscrew.simulation.fronts import Front, fronts, regular
from symscrew.simulation.linking import Linker, Operand
from symscrew.simulation.switches import switches

WORK = "work"  # label of the last state, the work of drives and effects
# A pivot of forward dynamics below this part of its median over the sample states is looked at: compiled runs compare
# two roundings there (`turned_rounding`), others hand over to the second path. What rounding leaves of accelerations
# may grow with the inverse of a pivot, and steps end anywhere near its zero, however short they are: at the model's own
# threshold (1e-5) steps brought errors of 1e-11 to 1e-5 in, which no tolerance reduced. Smaller: such errors come back;
# larger: what takes longer is taken in regular places too.
WARY = 0.05
STANDARD = ("q", "v", "u", "x", "t", "p")  # inputs of forward dynamics that are no inputs of effects


@dataclass(frozen=True, repr=False)
class Plant:
    """What an integrator needs of a model in a scene.

    `slopes`: (t, q, v, x, u, s, p) -> a, x_dot. `inputs`: the same -> u_command and the effects' inputs.
    `forward`: forward dynamics as the model has it, whose second path solves where a pivot of `slopes` is small;
    `rates`: x_dot alone, which has no pivots, for there. `switches`: the conditions of the slopes, at whose zeros
    adaptive steps end, or None. `starts`: where the effects' states begin, for a loop that is started elsewhere.
    `closure`: q, p -> residual, the Jacobian's entries that are not always zero, or None without loops; `entries`:
    their rows and columns (n, 2). `units`, `rows`: what divides rates and closure
    rows to make them plain numbers. `fronts`: the order in which the closure's rows are made orthogonal. `pivot`: the
    smallest pivot of the closure's rows that regular configurations have. `works`: whether the last state is the
    work done by drives and effects.
    """

    model: Model
    slopes: Program
    inputs: Program
    forward: Program
    closure: Program | None
    x_labels: tuple[str, ...]
    units: np.ndarray
    rows: np.ndarray
    fronts: tuple[Front, ...]
    pivot: float
    works: bool
    parameters: np.ndarray
    tables: int
    outside: tuple[str, ...] = ()
    entries: np.ndarray = field(default_factory=lambda: np.zeros((0, 2), dtype=int))
    rates: Program | None = None
    switches: Program | None = None
    starts: Program | None = None

    def __repr__(self) -> str:
        count = len(self.slopes.instructions)
        loops = f"{len(self.rows)} rows of the closure" if self.closure is not None else "no loops"
        return f"<Plant {self.model.name}: {self.sizes['q']} coordinates, {loops}, slopes in {count} operations>"

    @property
    def system(self) -> System:
        """The mechanism on its tape."""
        return self.model.system

    @property
    def rank(self) -> int:
        """Independent rows of the closure in regular configurations."""
        return sum(front.rank for front in self.fronts)

    @property
    def sizes(self) -> dict[str, int]:
        """Entries of q, v, x, u (from outside), s and p."""
        return {port.name: port.size for port in self.slopes.inputs if port.name != "t"}


def plant(
    model: Model,
    controller: Program | None = None,
    *,
    held: bool = False,
    parameters: np.ndarray | None = None,
    work: bool | None = None,
    outside: Sequence[str] = (),
    watched: bool = False,
) -> Plant:
    """The programs of a model under a controller.

    Args:
        model: with forward dynamics.
        controller: (any of t, q, v, x, s, p) -> u, states' rates `c_dot`, effects' inputs; outputs that are
            missing are zero. Its states come after those of the effects in x.
        held: the drives are given from outside and held during a step; the controller must not have an output u.
        parameters: values of the run-time parameters; default: those of the description.
        work: whether to integrate the work of drives and effects; default: where there is any.
        outside: inputs of effects that the integrator determines; their entries follow the tables in s.
        watched: whether to look for the conditions of the slopes, for an integrator that lands on their zeros.
    """
    system, forward = model.system, model.programs["forward_dynamics"]
    assert isinstance(forward, Program)
    forward = replace(forward, limits=())  # quaternions between steps are the integrator's own, and it divides them
    given = {p.name: p for p in (controller.outputs if controller else ())}
    own = {p.name: p for p in forward.inputs}
    effect_states = own["x"].labels if "x" in own else ()
    controller_states = given["c_dot"].labels if "c_dot" in given else ()
    powers = model.programs.get("effect_power")
    if work is None:
        work = bool(system.drives and (held or "u" in given)) or bool(powers)
    labels = (*effect_states, *controller_states, *((WORK,) if work else ()))
    tables = next((p.size for p in controller.inputs if p.name == "s"), 0) if controller else 0
    ports = _ports(system, labels, tables + sum(own[name].size for name in outside), held)
    linker = Linker(ports)
    wiring = _Wiring(forward, controller, len(effect_states), len(controller_states), tables, tuple(outside))
    link = _Link(linker, wiring)
    outputs = link.run(forward)
    rates = _state_rates(link, model, work)
    x_dot = Port("x_dot", (len(rates),), ("1/s",) * len(rates), labels, "rates of the states")
    slopes = linker.program(
        "slopes", "Accelerations and rates of the states.", [(a_port(system), outputs["a"]), (x_dot, rates)]
    )
    conditions = switches(slopes, linker) if watched else None
    alone = _Link(Linker(ports), wiring)
    by_itself = alone.linker.program("state_rates", "Rates of the states.", [(x_dot, _state_rates(alone, model, work))])
    values = system.parameter_values if parameters is None else np.asarray(parameters, dtype=float)
    slopes, forward = _wary(slopes, forward, model)
    units = np.array([system.length if c.kind == "length" else 1.0 for c in system.tree.v])
    rows = np.array([1.0 / system.length if row.unit == "N" else 1.0 for cut in system.cuts for row in cut.rows])
    closure, entries = _closure(model)
    found, pivot = _regular(model, units, rows, entries) if closure is not None else ((), 1.0)
    return Plant(
        model, slopes, _inputs(ports, wiring), forward, closure, labels, units, rows, found, pivot, bool(work), values,
        tables, tuple(outside), entries, by_itself, conditions,
    )  # fmt: skip


def _wary(slopes: Program, forward: Program, model: Model) -> tuple[Program, Program]:
    """Both with the thresholds of their pivots raised to a part of what regular states have, if there is a second path.

    What the scene commands does not change the pivots, and the forward dynamics' own come first in both.
    """
    if not isinstance(forward, RankRevealing) or not forward.guards:
        return slopes, forward
    names = [port.name for port in forward.inputs]
    states = {k: x for k, x in zip(names, model.test_inputs["forward_dynamics"], strict=True) if k in ("q", "v")}
    ports = tuple(Port(f"pivot{k}", (1,), ("1",), ("",), "a pivot") for k in range(len(forward.guards)))
    results = tuple((slot,) for slot, _ in forward.guards)
    pivots = Program(
        "pivots", "Pivots.", forward.inputs, ports, forward.instructions, results, (), (), forward.slots
    )  # fmt: skip
    count = len(states["q"])
    given = {"p": np.repeat(model.system.parameter_values[None], count, 0), **states}
    found, _ = evaluate(pivots, [given.get(port.name, np.zeros((count, port.size))) for port in forward.inputs])
    usual = [  # `nanmedian` would import masked arrays, for nothing
        float(np.median(np.abs(values[~np.isnan(values)]))) if np.isfinite(values).any() else 0.0 for values in found
    ]
    raised = [max(own, WARY * value) for (_, own), value in zip(forward.guards, usual, strict=True)]

    def guarded(program: Program) -> Program:
        first = tuple((slot, threshold) for (slot, _), threshold in zip(program.guards, raised, strict=False))
        return replace(program, guards=(*first, *program.guards[len(raised) :]))

    return guarded(slopes), guarded(forward)


@dataclass(frozen=True)
class _Wiring:
    """Forward dynamics and its controller: entries of x that are effects' and the controller's states, of s that are
    tables, and inputs of effects whose values come from outside, in the entries of s after the tables."""

    forward: Program
    controller: Program | None
    effects: int
    states: int
    tables: int
    outside: tuple[str, ...]


def _ports(system: System, labels: Sequence[str], tables: int, held: bool) -> list[Port]:
    count = len(system.parameters)
    drives = u_port(system)
    return [
        Port("t", (1,), ("s",), ("t",), "time"),
        q_port(system),
        v_port(system),
        Port("x", (len(labels),), ("1",) * len(labels), tuple(labels), "states"),
        drives if held else Port("u", (0,), (), (), "drives from outside"),
        Port("s", (tables,), ("1",) * tables, tuple(f"s{k}" for k in range(tables)), "values of the tables at t"),
        Port("p", (count,), ("1",) * count, tuple(f"p{k}" for k in range(count)), "run-time parameters"),
    ]


class _Link:
    """Forward dynamics behind a controller in one linker."""

    def __init__(self, linker: Linker, wiring: _Wiring) -> None:
        self.linker = linker
        forward, effects, outside = wiring.forward, wiring.effects, wiring.outside
        x, s, at = linker.entries["x"], linker.entries["s"], wiring.tables
        self.arguments: dict[str, Sequence[Operand]] = {"x": x[:effects]}
        self.commands: dict[str, tuple[Operand, ...]] = {}
        if wiring.controller is not None:
            own = x[effects : effects + wiring.states]
            self.commands = linker.call(wiring.controller, {"x": x[:effects], "c": own, "s": s[:at]})
        sizes = {port.name: port.size for port in forward.inputs}
        for name in outside:
            self.arguments[name] = s[at : at + sizes[name]]
            at += sizes[name]
        for port in forward.inputs:
            if port.name in outside:
                continue
            if port.name == "u" and len(linker.entries["u"]) == port.size and port.size:
                self.arguments["u"] = linker.entries["u"]
            elif port.name not in STANDARD or port.name == "u":
                self.arguments[port.name] = self.commands.get(port.name, (0.0,) * port.size)

    def run(self, program: Program) -> dict[str, tuple[Operand, ...]]:
        """Outputs of a function of the model at the present state."""
        return self.linker.call(program, self.arguments)


def _state_rates(link: _Link, model: Model, work: bool) -> list[Operand]:
    """Rates of the states of the effects, of those of the controller, and the power where work is wanted."""
    own = model.programs.get("effect_state_rates")
    rates = [*(link.run(own)["x_dot"] if isinstance(own, Program) else ()), *link.commands.get("c_dot", ())]
    return [*rates, _power(link, model, model.programs.get("effect_power"))] if work else rates


def _power(link: _Link, model: Model, powers: object) -> Operand:
    """Power of the drives and of the effects that store no energy [W]."""
    linker = link.linker
    total: Operand = 0.0
    rates = model.programs.get("drive_rates")
    if isinstance(rates, Program) and "u" in link.arguments:
        total = linker.sum_of_products(link.arguments["u"], link.run(rates)["rates"])
    if isinstance(powers, Program):
        for power in link.run(powers)["power"]:
            total = linker.apply("add", total, power)
    return total


def _inputs(ports: Sequence[Port], wiring: _Wiring) -> Program:
    """The controller alone: what it commands, as the inputs of forward dynamics that are not the state."""
    linker = Linker(ports)
    link = _Link(linker, wiring)
    outputs = [
        (_renamed(port), link.arguments[port.name])
        for port in wiring.forward.inputs
        if port.name == "u" or port.name not in STANDARD
    ]
    return linker.program("inputs", "Drives and inputs of the effects that the scene commands.", outputs)


def _renamed(port: Port) -> Port:
    return Port(f"{port.name}_command", port.shape, port.units, port.labels, port.description)


def _closure(model: Model) -> tuple[Program | None, np.ndarray]:
    """Residual and Jacobian of the closure in one program, and which entries the Jacobian has."""
    parts = [model.programs.get(name) for name in ("closure", "closure_jacobian")]
    first, second = parts
    if not isinstance(first, Program) or not isinstance(second, Program) or not first.outputs[0].size:
        return None, np.zeros((0, 2), dtype=int)
    linker = Linker(first.inputs)
    (residual,), (jacobian,) = (tuple(linker.call(program, {}).values()) for program in (first, second))
    count, whole = len(residual), second.outputs[0]
    by_rows = sorted(range(len(jacobian)), key=lambda k: (k % count, k))
    kept = [k for k in by_rows if isinstance(jacobian[k], int) or jacobian[k] != 0.0]
    units, labels = (
        tuple(whole_list[k] for k in kept) if whole_list else () for whole_list in (whole.units, whole.labels)
    )
    port = Port(whole.name, (len(kept),), units, labels, "entries of the closure Jacobian that are not always zero")
    outputs = [(first.outputs[0], residual), (port, [jacobian[k] for k in kept])]
    text = "How far the loops are open, and the closure Jacobian."
    return linker.program("closure_both", text, outputs), np.array([(k % count, k // count) for k in kept]).reshape(
        -1, 2
    )


def _regular(model: Model, units: np.ndarray, rows: np.ndarray, entries: np.ndarray) -> tuple[tuple[Front, ...], float]:
    """Fronts of the closure, and the smallest pivot that the model's sample states have, without units."""
    system = model.system
    q = model.sample_q
    jacobian = model.programs["closure_jacobian"]
    given = [np.repeat(system.parameter_values[None], len(q), 0)] if len(jacobian.inputs) > 1 else []
    values = model("closure_jacobian", q, *given)[0][0].reshape(len(q), len(units), len(rows)).transpose(0, 2, 1)
    ends = np.cumsum([0, *(len(cut.rows) for cut in system.cuts)]).tolist()
    loops = [range(first, last) for first, last in itertools.pairwise(ends)]
    return regular(fronts(loops, entries), [matrix * rows[:, None] * units for matrix in values])


def commands(plant: Plant, controller_inputs: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """What the scene commands at states (n, size): drives `u` and the effects' inputs, by name."""
    arrays = [controller_inputs[port.name] for port in plant.inputs.inputs]
    results, _ = evaluate(plant.inputs, arrays)
    return {p.name.removesuffix("_command"): r for p, r in zip(plant.inputs.outputs, results, strict=True)}
