"""Derivatives against differences on the closure manifold, CasADi's own differentiation, and Pinocchio."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from functools import cache
from itertools import pairwise

import casadi
import numpy as np
import pytest
import sympy
from support.marks import slow
from support.model_states import HAND_TYPED, relative
from support.model_states import differentiated as model

from symscrew import catalogue
from symscrew.algebra.differentiation import ORDERS, differentiate
from symscrew.algebra.nodes import Tape
from symscrew.algebra.sympy_form import sympy_expression
from symscrew.export.casadi import casadi_functions
from symscrew.model import Model, derive

Array = np.ndarray
NAMES = tuple(name for name in (*catalogue.names(), *HAND_TYPED) if name != "stewart_6ups")  # like the seed
FEW = [slow(name) if name in ("delta", "mixed_loop", "panda") else name for name in NAMES]  # the last have their like
CLOSED = tuple(n for n in NAMES if n not in ("ur5", "panda"))


def values(found: Model, function: str, *arguments: Array) -> tuple[Array, ...]:
    """All outputs of a function as arrays of their shapes; every status must be 0."""
    results, status = found(function, *arguments)
    assert np.all(status == 0), f"{found.name}.{function}: status {status}"
    ports = found.programs[function].outputs
    return tuple(_shaped(r, p.shape) for r, p in zip(results, ports, strict=True))


def _shaped(array: Array, shape: tuple[int, ...]) -> Array:
    """Column-major rows as arrays (states, *shape)."""
    return array.reshape(len(array), *shape[::-1]).swapaxes(-1, -2) if len(shape) == 2 else array


def consistent(found: Model) -> tuple[Array, Array, Array, Array, Array]:
    """Sample states off the reference configuration: q, v, a, y_dot, y_ddot."""
    q, v, a = (x[1:] for x in found.system.sample_states)
    random = np.random.default_rng(3)
    count = found.programs["null_space"].outputs[0].shape[1]
    y_dot, y_ddot = random.uniform(-1, 1, (2, len(q), count))
    return q, v, a, y_dot, y_ddot


def quaternion_rates(found: Model, q: Array, v: Array) -> Array:
    """q_dot (..., nq) for v (..., nv), spherical rates in the child's axes."""
    rate = np.zeros((*v.shape[:-1], q.shape[-1]))
    for link in found.system.tree.links[1:]:
        w = v[..., link.v]
        if link.motion.kind == "S":
            scalar, r = q[..., link.q][..., :1], q[..., link.q][..., 1:]
            rate[..., link.q] = 0.5 * np.concatenate([-(r * w).sum(-1, keepdims=True), scalar * w + np.cross(r, w)], -1)
        else:
            rate[..., link.q] = w
    return rate


def moved(found: Model, q: Array, step: Array) -> Array:
    """q after a step along v: spherical joints turn by a rotation vector in the child's axes."""
    result = q + 0 * step[..., :1]
    for link in found.system.tree.links[1:]:
        w = step[..., link.v]
        if link.motion.kind != "S":
            result[..., link.q] = q[..., link.q] + w
            continue
        angle = np.linalg.norm(w, axis=-1, keepdims=True)
        turn = w * np.sinc(angle / (2 * np.pi)) / 2
        scalar, r = q[..., link.q][..., :1], q[..., link.q][..., 1:]
        c = np.cos(angle / 2)
        result[..., link.q] = np.concatenate(
            [c * scalar - (r * turn).sum(-1, keepdims=True), c * r + scalar * turn + np.cross(r, turn)], -1
        )
    return result


HALVINGS = np.array([1, -1, 1 / 2, -1 / 2, 1 / 4, -1 / 4, 1 / 8, -1 / 8])


def differences(function: Callable[[Array], Array], step: float) -> Array:
    """Derivative at 0 by central differences of four steps, extrapolated: the error is of order step^8.

    `function` takes the steps as an array (8, 1) and gives its values (8, states, n).
    """
    steps = step * HALVINGS
    both = function(steps[:, None])
    table = [(up - down) / (2 * h) for up, down, h in zip(both[::2], both[1::2], steps[::2], strict=True)]
    for order in range(1, 4):
        factor = 4.0**order
        table = [(factor * b - a) / (factor - 1) for a, b in pairwise(table)]
    return table[0]


def batched(found: Model, function: str, *arguments: Array) -> Array:
    """The first output for arguments with any batch axes, all in one evaluation."""
    batch = np.broadcast_shapes(*(x.shape[:-1] for x in arguments))
    flat = [np.broadcast_to(x, (*batch, x.shape[-1])).reshape(-1, x.shape[-1]) for x in arguments]
    result = values(found, function, *flat)[0]
    return result.reshape(*batch, *result.shape[1:])


def tree_columns(found: Model, function: str, state: list[Array], step: float = 2e-2) -> list[Array]:
    """Differences of a function of (q, further inputs) along every direction of the tree."""
    result = []
    for k, argument in enumerate(state):
        directions = np.eye(len(found.system.tree.v) if k == 0 else argument.shape[-1])
        columns = []
        for e in directions:

            def along(h: Array, k: int = k, e: Array = e) -> Array:
                changed, step = list(state), h[..., None] * e
                changed[k] = moved(found, state[0], step) if k == 0 else state[k] + step
                return batched(found, function, *changed)

            columns.append(differences(along, step))
        result.append(np.stack(columns, -1))
    return result


def assembled(found: Model, q: Array, shift: Array, *parameters: Array) -> Array:
    """The configuration on the branch of q whose independent coordinates are shifted."""
    if not found.system.cuts:
        return moved(found, q, shift)
    y = q[:, list(found.programs["assemble"].independent)]
    return batched(found, "assemble", y + shift, q, *parameters)


def independent_columns(found: Model, function: str, state: list[Array], step: float = 4e-3) -> list[Array]:
    """Differences of a function of (q, further inputs) along the independent directions, loops closed again."""
    result = []
    count = found.programs["null_space"].outputs[0].shape[1]
    for k, argument in enumerate(state):
        directions = np.eye(count if k == 0 else argument.shape[-1])
        columns = []
        for e in directions:

            def along(h: Array, k: int = k, e: Array = e) -> Array:
                changed, step = list(state), h[..., None] * e
                changed[k] = assembled(found, state[0], step) if k == 0 else state[k] + step
                return batched(found, function, *changed)

            columns.append(differences(along, step))
        result.append(np.stack(columns, -1))
    return result


# -- the chain rule itself --------------------------------------------------------------------------------------


def test_every_operation_and_order() -> None:
    """Derivatives of all operations against SymPy, the same by every order of elimination."""
    tape = Tape()
    x, y, z = (tape.symbol(n, "1", n) for n in "xyz")
    first = tape.sqrt(x * x + 2 * y) * tape.function("sin", x * z) / (3 + tape.function("cos", y - x))
    second = tape.function("atan2", y, 1 + x * z) - tape.function("tan", z * y) * first + tape.function("abs", x - y)
    third = first * first + x
    at = {"x": sympy.Rational(7, 10), "y": sympy.Rational(13, 10), "z": sympy.Rational(-4, 5)}
    seeds = {x: {"x": tape.one}, y: {"y": tape.one, "both": tape.node(2)}, z: {"both": x}}
    symbols = sympy.symbols("x y z", real=True)
    for order in (*ORDERS, None):
        rows = differentiate(tape, [first, second, third, y, tape.one], seeds, ["x", "y", "both"], order=order)
        for node, row in zip([first, second, third, y, tape.one], rows, strict=True):
            expression = sympy_expression(node)
            dx, dy, dz = (sympy.diff(expression, s) for s in symbols)
            expected = [dx, dy, 2 * dy + symbols[0] * dz]
            for got, wanted in zip(row, expected, strict=True):
                difference = (sympy_expression(got) - wanted).subs({s: at[s.name] for s in symbols})
                assert abs(sympy.N(difference.doit(), 30)) < 1e-25, (order, wanted)


def test_zeros_and_held_nodes() -> None:
    tape = Tape()
    x, y = (tape.symbol(n, "1", n) for n in "xy")
    inner = x * y
    one = tape.one
    assert differentiate(tape, [inner + 1], {x: {"x": one}}, ["x", "other"]) == [[y, tape.zero]]
    assert differentiate(tape, [inner * x], {x: {"x": one}, inner: {}}, ["x"]) == [[inner]]
    choice = tape.function("select", tape.function("less", x, y), x * x, y)
    (got,) = differentiate(tape, [choice], {x: {"x": one}}, ["x"])[0]
    tape.set_samples({x: np.array([1.0, 3.0]), y: np.array([2.0, 2.0])})
    assert tape.sample(got).tolist() == [2.0, 0.0]
    with pytest.raises(ValueError, match="order of elimination among forward"):
        differentiate(tape, [inner], {x: {"x": one}}, ["x"], order="sideways")


# -- inverse dynamics --------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_inverse_dynamics_of_the_tree(name: str) -> None:
    """Differences along the tree, the loops open: the function is smooth off the manifold too."""
    found = model(name)
    q, v, a, _, _ = consistent(found)
    got = values(found, "inverse_dynamics_derivatives", q[:2], v[:2], a[:2])
    expected = tree_columns(found, "inverse_dynamics", [q[:2], v[:2], a[:2]])
    for x, y in zip(got, expected, strict=True):
        assert relative(x, y) < 1e-8


@pytest.mark.parametrize("name", [slow(n) if n in ("andrews", "three_ups_upu_s") else n for n in FEW])
def test_inverse_dynamics_on_the_manifold(name: str) -> None:
    """Differences between states whose loops have been closed again."""
    found = model(name)
    q, _, _, y_dot, y_ddot = consistent(found)
    state = [q[:2], y_dot[:2], y_ddot[:2]]
    got = values(found, "inverse_dynamics_independent_derivatives", *state)
    expected = independent_columns(found, "inverse_dynamics_independent", state)
    for x, y in zip(got, expected, strict=True):
        assert relative(x, y) < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize("name", ["three_ups_upu_s_physical", "five_bar", "ur5"])
def test_against_casadi(name: str) -> None:
    """CasADi differentiates the exported functions by q; the chain rule along the null space does the rest."""
    found = model(name)
    q, v, a, y_dot, y_ddot = consistent(found)
    functions = casadi_functions(found)
    null = values(found, "null_space", q)[0]
    for function, arguments, along in (
        ("inverse_dynamics", (q, v, a), np.eye(v.shape[1])[None].repeat(len(q), 0)),
        ("inverse_dynamics_independent", (q, y_dot, y_ddot), null),
    ):
        steps = quaternion_rates(found, q[:, None, :], along.swapaxes(1, 2))
        got = values(found, f"{function}_derivatives", *arguments)
        for i in range(len(q)):
            expected = casadi_jacobian(functions[function], [x[i] for x in arguments])
            expected[0] = expected[0] @ steps[i].T
            for x, y in zip(got, expected, strict=True):
                assert relative(x[i], y) < 1e-10, function


def casadi_jacobian(function: casadi.Function, arguments: list[Array]) -> list[Array]:
    """Jacobians of the first output by every input, by CasADi."""
    symbols = [casadi.SX.sym(f"x{i}", function.size_in(i)) for i in range(function.n_in())]
    output = function.call(symbols)[0]
    jacobians = casadi.Function("jacobians", symbols, [casadi.jacobian(output, s) for s in symbols])
    return [np.array(j) for j in jacobians.call(arguments)]


@pytest.mark.parametrize("name", ["ur5", "panda"])
def test_against_pinocchio(name: str) -> None:
    pinocchio = pytest.importorskip("pinocchio")
    found = model(name)
    other, states = pinocchio_model(pinocchio, found)
    data = other.createData()
    got = values(found, "inverse_dynamics_derivatives", *consistent(found)[:3])
    for i, (q, v, a) in enumerate(zip(*states, strict=True)):
        pinocchio.computeRNEADerivatives(other, data, q, v, a)
        mass = np.triu(data.M) + np.triu(data.M, 1).T
        for x, y in zip(got, (data.dtau_dq, data.dtau_dv, mass), strict=True):
            assert relative(x[i], y) < 1e-10


def pinocchio_model(pinocchio: object, found: Model) -> tuple[object, tuple[Array, ...]]:
    from symscrew.studies.benchmark.pinocchio_build import python_model
    from symscrew.studies.benchmark.pinocchio_tree import pinocchio_tree

    tree = pinocchio_tree(found.mechanism)
    return python_model(pinocchio, tree, len(tree.elements)), tree.states(*consistent(found)[:3])


# -- forward dynamics --------------------------------------------------------------------------------------------


def drives(found: Model, q: Array, y_dot: Array, y_ddot: Array) -> Array:
    """Drives that bring about accelerations of order one, with an internal preload."""
    u = values(found, "inverse_dynamics_independent", q, y_dot, y_ddot)[0]
    return u + 0.1 * np.abs(u).max() * np.random.default_rng(4).uniform(-1, 1, u.shape)


@pytest.mark.parametrize("name", FEW)
def test_forward_dynamics_on_the_manifold(name: str) -> None:
    found = model(name)
    q, _, _, y_dot, y_ddot = (x[:2] for x in consistent(found))
    state = [q, y_dot, drives(found, q, y_dot, y_ddot)]
    got = values(found, "forward_dynamics_independent_derivatives", *state)
    expected = independent_columns(found, "forward_dynamics_independent", state)
    for x, y in zip(got, expected, strict=True):
        assert relative(x, y) < 1e-8


@pytest.mark.parametrize("name", FEW)
def test_linearisation(name: str) -> None:
    """A and B hold the derivatives of x_dot = (y_dot, y_ddot): d(x_dot) along a random change of (y, y_dot, u)."""
    found = model(name)
    q, _, _, y_dot, y_ddot = (x[:1] for x in consistent(found))
    u = drives(found, q, y_dot, y_ddot)
    n = y_dot.shape[1]
    a, b = values(found, "linearisation", q, y_dot, u)
    assert a.shape[1:] == (2 * n, 2 * n) and b.shape[1:] == (2 * n, u.shape[1])
    change = np.random.default_rng(5).uniform(-1, 1, 2 * n + u.shape[1])

    def along(h: Array) -> Array:
        x, w = h[..., None] * change[: 2 * n], h[..., None] * change[2 * n :]
        rates = y_dot + x[..., n:]
        second = batched(found, "forward_dynamics_independent", assembled(found, q, x[..., :n]), rates, u + w)
        return np.concatenate([rates, second], -1)

    expected = differences(along, 4e-3)
    assert relative(a @ change[: 2 * n] + b @ change[2 * n :], expected) < 1e-8


@pytest.mark.parametrize("name", ["ur5", "panda"])
def test_forward_dynamics_of_the_tree(name: str) -> None:
    pinocchio = pytest.importorskip("pinocchio")
    found = model(name)
    other, (states, rates, _) = pinocchio_model(pinocchio, found)
    data = other.createData()
    q, v, a, _, _ = consistent(found)
    u = drives(found, q, v, a)
    got = values(found, "forward_dynamics_derivatives", q, v, u)
    for i in range(len(q)):
        pinocchio.computeABADerivatives(other, data, states[i], rates[i], u[i])
        inverse = np.triu(data.Minv) + np.triu(data.Minv, 1).T
        for x, y in zip(got, (data.ddq_dq, data.ddq_dv, inverse), strict=True):
            assert relative(x[i], y) < 1e-10


@pytest.mark.parametrize("name", [slow("three_ups_upu_s_physical"), "five_bar"])
def test_forward_dynamics_against_casadi(name: str) -> None:
    found = model(name)
    q, _, _, y_dot, y_ddot = consistent(found)
    u = drives(found, q, y_dot, y_ddot)
    function = casadi_functions(found)["forward_dynamics_independent"]
    steps = quaternion_rates(found, q[:, None, :], values(found, "null_space", q)[0].swapaxes(1, 2))
    got = values(found, "forward_dynamics_independent_derivatives", q, y_dot, u)
    for i in range(len(q)):
        expected = casadi_jacobian(function, [q[i], y_dot[i], u[i]])
        expected[0] = expected[0] @ steps[i].T
        for x, y in zip(got, expected, strict=True):
            assert relative(x[i], y) < 1e-10


def test_forward_and_inverse_derivatives_are_inverse_to_each_other() -> None:
    """At u from the inverse dynamics, du = dID: forward dynamics along (dy, dy_dot, du) gives dy_ddot back."""
    found = model("three_ups_upu_s_physical")
    q, _, _, y_dot, y_ddot = consistent(found)
    u = values(found, "inverse_dynamics_independent", q, y_dot, y_ddot)[0]
    by_y, by_rate, by_gain = values(found, "inverse_dynamics_independent_derivatives", q, y_dot, y_ddot)
    forward = values(found, "forward_dynamics_independent_derivatives", q, y_dot, u)
    one = np.eye(y_dot.shape[1])
    assert relative(forward[2] @ by_gain, np.broadcast_to(one, (len(q), *one.shape))) < 1e-9
    assert relative(forward[0], -forward[2] @ by_y) < 1e-9
    assert relative(forward[1], -forward[2] @ by_rate) < 1e-9


# -- run-time parameters -----------------------------------------------------------------------------------------


@cache
def with_parameters(name: str) -> Model:
    mechanism = catalogue.load(name)
    changed = {n: dataclasses.replace(p, run_time=True) for n, p in mechanism.parameters.items()}
    return derive(dataclasses.replace(mechanism, parameters=changed), derivatives=True)


@pytest.mark.slow
def test_by_run_time_parameters() -> None:
    """At fixed y the configuration follows the parameters; of the tree it stays."""
    found = with_parameters("three_ups_upu_s_physical")
    q, v, a, y_dot, y_ddot = (x[:2] for x in consistent(found))
    p = np.repeat(found.system.parameter_values[None], len(q), 0)
    u = values(found, "inverse_dynamics_independent", q, y_dot, y_ddot, p)[0] * 1.1

    def of_tree(h: Array, e: Array) -> Array:
        return batched(found, "inverse_dynamics", q, v, a, p + h[..., None] * e)

    def of_loops(h: Array, e: Array, function: str, third: Array) -> Array:
        changed = p + h[..., None] * e
        return batched(found, function, assembled(found, q, 0 * y_dot, changed), y_dot, third, changed)

    unit = np.eye(p.shape[1])
    expected = np.stack([differences(lambda h, e=e: of_tree(h, e), 4e-3) for e in unit], -1)
    assert relative(values(found, "inverse_dynamics_parameters", q, v, a, p)[0], expected) < 1e-8
    for name, third in (("inverse_dynamics_independent", y_ddot), ("forward_dynamics_independent", u)):
        columns = [differences(lambda h, e=e, n=name, x=third: of_loops(h, e, n, x), 4e-3) for e in unit]
        got = values(found, f"{name}_parameters", q, y_dot, third, p)[0]
        assert relative(got, np.stack(columns, -1)) < 1e-8


def test_nothing_asked_nothing_paid() -> None:
    plain = derive(catalogue.load("four_bar"))
    assert not [name for name in plain.programs if "derivatives" in name]
    both = model("four_bar")
    assert {n: p.hash for n, p in plain.programs.items()} == {n: both.programs[n].hash for n in plain.programs}


def test_ports_say_what_is_differentiated() -> None:
    program = model("three_ups_upu_s_physical").programs["inverse_dynamics_derivatives"]
    by_q = program.outputs[0]
    assert by_q.shape == (4, 15) and "rotation vector in the child's axes" in by_q.description
    assert by_q.labels[0].count("|") == 1 and set(by_q.units) <= {"N/rad", "N/m"}
    assert set(program.outputs[1].units) == {"N/(rad/s)", "N/(m/s)"}
