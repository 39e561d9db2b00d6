"""Small models made by hand, to test printers without a mechanism."""

import math

import numpy as np

from symscrew.algebra.nodes import Node, Tape
from symscrew.description.mechanism import Mechanism
from symscrew.effects.gravity import Gravity
from symscrew.kinematics import System
from symscrew.model import Model
from symscrew.program.lowering import Function, lower
from symscrew.program.straight_line import Iteration, Port, Program


def port(name: str, size: int, unit: str = "m", shape: tuple[int, ...] | None = None) -> Port:
    return Port(
        name,
        shape or (size,),
        (unit,) * size,
        tuple(f"{name} {k}" for k in range(size)),
        f"test array {name}",
    )


def program(name: str, sizes: dict[str, int], outputs: dict, guards=(), shapes: dict | None = None) -> Program:
    """A program from a function of lists of nodes; `outputs` maps names to functions of all inputs."""
    tape = Tape()
    arguments = {n: tuple(tape.symbol(f"{n}_{k}", "m", "test") for k in range(size)) for n, size in sizes.items()}
    results = {n: tuple(tape.node(r) for r in make(tape, *arguments.values())) for n, make in outputs.items()}
    made = tuple((make(tape, *arguments.values()), threshold) for make, threshold in guards)
    function = Function(
        name,
        f"Test function {name}",
        tuple(port(n, s) for n, s in sizes.items()),
        tuple(port(n, len(r), shape=(shapes or {}).get(n)) for n, r in results.items()),
        tuple(arguments.values()),
        tuple(results.values()),
        made,
    )
    return lower(function)


def every_operation() -> Program:
    """Each operation of the tape once or more, a matrix output, and an input that nothing reads."""

    def scalars(t: Tape, x: tuple[Node, ...], unused: tuple[Node, ...]) -> list[Node]:
        root = t.sqrt(x[0] * x[0] + x[1] * x[1] + 1)
        return [
            x[0] + x[1],
            x[0] - t.node(1e-05) * x[1],
            -(x[0] * x[1]),
            x[0] / root,
            1 / root,
            x[1] / root,
            t.function("sin", x[0]) * t.function("cos", x[0]),
            t.function("tan", x[1]),
            t.function("atan2", x[1], x[0]),
            t.function("abs", x[0]),
            t.function("select", t.function("less", x[0], x[1]), x[0], -x[1] - 2.5),
            x[2],
            x[1] / (x[2] + 5),
            t.node(-3),
            t.function("exp", x[1]),
        ]

    def matrix(t: Tape, x: tuple[Node, ...], unused: tuple[Node, ...]) -> list[Node]:
        return [x[i] * x[j] + k for k, (i, j) in enumerate([(0, 1), (1, 1), (0, 2), (1, 2), (2, 2), (2, 0)])]

    return program(
        "every_operation",
        {"x": 3, "unused": 2},
        {"scalars": scalars, "matrix": matrix},
        shapes={"matrix": (2, 3)},
    )


def guarded() -> Program:
    """1/x0 behind a guard, and a product that overflows."""
    return program(
        "guarded",
        {"x": 2},
        {"y": lambda t, x: [1 / x[0], t.function("sin", x[1]) * x[1]]},
        [(lambda t, x: x[0], 1e-9)],
    )


def circle() -> Iteration:
    """q = (c, s) on a circle with c = y: the upper or lower branch, from a guess."""

    def step(t: Tape, q, y, radius) -> tuple[list[Node], list[Node], list[Node], list[Node]]:
        c, s = q
        opening = y[0] * y[0] + s * s - radius[0] * radius[0]
        change = opening / (2 * s)
        return (
            [y[0], s - change],
            [t.function("abs", opening) + t.function("abs", c - y[0])],
            [t.function("abs", change)],
            [s],
        )

    sizes = {"q": 2, "y": 1, "radius": 1}
    names = ("q_next", "residual", "step", "orientation")
    outputs = {n: (lambda t, q, y, r, i=i: step(t, q, y, r)[i]) for i, n in enumerate(names)}
    newton = program("assembly_step", sizes, outputs, [(lambda t, q, y, r: q[1], 1e-12)])
    return Iteration(
        "assemble",
        "The point of a circle over y",
        (port("y", 1), port("guess", 2), port("radius", 1)),
        (port("q", 2),),
        newton,
        (0,),
    )


def far_target() -> Iteration:
    """atan(s - 10 c) = 0 over c = y: Newton diverges from further away than 1.39, so it needs substeps."""

    def step(t: Tape, q, y) -> tuple[list[Node], ...]:
        away = q[1] - 10 * y[0]
        opening = t.function("atan2", away, t.one)
        change = opening * (1 + away * away)
        return (
            [y[0], q[1] - change],
            [t.function("abs", opening) + t.function("abs", q[0] - y[0])],
            [t.function("abs", change)],
            [t.one],
        )

    names = ("q_next", "residual", "step", "orientation")
    outputs = {n: (lambda t, q, y, i=i: step(t, q, y)[i]) for i, n in enumerate(names)}
    newton = program("assembly_step", {"q": 2, "y": 1}, outputs)
    ports = (port("y", 1), port("guess", 2))
    return Iteration("assemble", "A line over y, far away", ports, (port("q", 2),), newton, (0,))


def model(**extra: Program) -> Model:
    """A model of the functions above."""
    programs = {"every_operation": every_operation(), "guarded": guarded(), "assemble": circle(), **extra}
    rng = np.random.default_rng(1)
    states = {
        "every_operation": (rng.normal(size=(5, 3)), rng.normal(size=(5, 2))),
        "guarded": (rng.normal(size=(5, 2)),),
        "assemble": (np.array([[0.1], [0.7]]), np.zeros((2, 2)))
        if "assemble" in extra
        else (
            np.array([[0.1], [0.5], [-0.9], [0.95], [1.5]]),
            np.array([[0.0, 1.0], [0.6, -0.8], [0.0, 1.0], [math.sqrt(0.5), math.sqrt(0.5)], [0.0, 1.0]]),
            np.ones((5, 1)),
        ),
    }
    mechanism = Mechanism("handmade", "base", {}, {}, description="programs made by hand")
    names = {
        name: states.get(name, tuple(rng.normal(size=(3, p.size)) for p in prog.inputs))
        for name, prog in programs.items()
    }
    return Model("handmade", mechanism, (Gravity(),), programs, names, System(mechanism))
