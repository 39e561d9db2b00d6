"""The program of a scene's drives, effect inputs and controller states, from its expressions.

(t, q, v, x, c, s, p) -> u, c_dot and the inputs of effects: `symscrew.simulation.state_programs` joins it to the model.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy

from symscrew.algebra import Node, Tape, expression_node
from symscrew.description import parse
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.kinematics import identifiers
from symscrew.model import Model
from symscrew.program import Function, Port, Program, lower
from symscrew.scene.contents import Scene

STANDARD = ("q", "v", "u", "x", "t", "p")  # inputs of forward dynamics that are no inputs of effects


def controller(scene: Scene, model: Model, *, held: bool = False) -> Program | None:
    """The controller's program, or None where the scene drives nothing.

    `held`: the drives come from outside; expressions for them are then an error.

    Raises:
        DescriptionError: a drive or input that does not exist, or an expression that cannot be read.
    """
    forward = {port.name: port for port in model.programs["forward_dynamics"].inputs}
    own = {name: port for name, port in forward.items() if name not in STANDARD}
    _check_drives(scene, model, forward.get("u"), held)
    for name, values in scene.inputs.items():
        if name not in own:
            raise DescriptionError(f"inputs: no effect of this scene has the input {name!r}; {did_you_mean(name, own)}")
        if len(values) != own[name].size:
            raise DescriptionError(f"inputs.{name}: expected {own[name].size} expressions, got {len(values)}")
    made = _Expressions(scene, model, forward.get("x"))
    outputs: list[tuple[Port, list[Node]]] = []
    if scene.drives and "u" in forward:
        port = forward["u"]
        zero = made.tape.zero
        commanded = [made.node(scene.drives[k], f"drives.{k}") if k in scene.drives else zero for k in port.labels]
        outputs.append((port, commanded))
    if scene.states:
        port = Port("c_dot", (len(scene.states),), ("1/s",) * len(scene.states), tuple(scene.states), "rates")
        outputs.append((port, [made.node(rate, f"states.{n}.rate") for n, (rate, _) in scene.states.items()]))
    for name, texts in scene.inputs.items():
        outputs.append((own[name], [made.node(t, f"inputs.{name}[{k}]") for k, t in enumerate(texts)]))
    if not outputs:
        return None
    return lower(
        Function(
            "controller",
            "What the scene commands.",
            made.ports,
            tuple(port for port, _ in outputs),
            made.arguments,
            tuple(tuple(values) for _, values in outputs),
        )
    )


def _check_drives(scene: Scene, model: Model, port: Port | None, held: bool) -> None:
    labels = port.labels if port else ()
    if held and scene.drives:
        raise DescriptionError("drives: the drives are given from outside; leave the section [drives] out")
    for label in scene.drives:
        if label in labels:
            continue
        joint = label.split(".")[0]
        if joint in model.mechanism.joints:
            known = ", ".join(labels) or "none"
            raise DescriptionError(
                f"drives.{label}: the joint {joint!r} is passive here; driven are {known} (mark the joint 'driven' in "
                "the mechanism, or use an effect)"
            )
        raise DescriptionError(f"drives: no drive is called {label!r}; {did_you_mean(label, labels)}")


class _Expressions:
    """Reads expressions against everything that a scene's expression may name."""

    def __init__(self, scene: Scene, model: Model, states: Port | None) -> None:
        tape, system = Tape(), model.system
        self.tape = tape
        q, v = system.tree.q, system.tree.v
        names, rates = (identifiers(c.label for c in entries) for entries in (q, v))
        groups: list[tuple[str, list[tuple[str, str]]]] = [
            ("t", [("t", "s")]),
            ("q", [(f"q_{names[c.label]}", c.unit) for c in q]),
            ("v", [(f"v_{rates[c.label]}", c.unit) for c in v]),
            ("x", [(name, unit) for name, unit in zip(states.labels, states.units, strict=True)] if states else []),
            ("c", [(name, "1") for name in scene.states]),
            ("s", [(name, "1") for name in scene.tables]),
            ("p", [(p.name, p.unit) for p in model.mechanism.parameters.values() if p.run_time]),
        ]
        self.ports = tuple(
            Port(name, (len(entries),), tuple(u for _, u in entries), tuple(n for n, _ in entries), name)
            for name, entries in groups
        )
        self.arguments = tuple(
            tuple(tape.symbol(name, unit, f"{name} of the scene") for name, unit in entries) for _, entries in groups
        )
        self.symbols: dict[sympy.Symbol, Node] = {}
        inputs = {p.name: _symbol(p.name) for p in model.mechanism.parameters.values() if p.run_time}
        self.names = model.mechanism.values(inputs)
        for port, nodes in zip(self.ports, self.arguments, strict=True):
            for name, node in zip(port.labels, nodes, strict=True):
                self._name(name, node)
        for name, text in scene.signals.items():
            self._name(name, self.node(text, f"signals.{name}"))

    def _name(self, name: str, node: Node) -> None:
        self.names[name] = _symbol(name)
        self.symbols[_symbol(name)] = node

    def node(self, text: str, where: str) -> Node:
        """The node of an expression."""
        try:
            return expression_node(self.tape, parse(text, self.names, where=where), self.symbols)
        except ValueError as error:
            if isinstance(error, DescriptionError):
                raise
            raise DescriptionError(f"{where}: this expression cannot be evaluated at run time: {error}") from error


def _symbol(name: str) -> sympy.Symbol:
    """What a name of the scene is in its expressions."""
    return sympy.Symbol(f"scene {name}", real=True)


def parameter_values(scene: Scene, model: Model) -> Mapping[str, float]:
    """Values of the run-time parameters by name: the scene's, else those of the description; in the program's order."""
    defaults = {p.name: float(p.value) for p in model.mechanism.parameters.values() if p.run_time}
    return {**defaults, **scene.parameters}
