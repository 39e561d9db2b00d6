"""Second derivatives against second differences on the closure manifold, and what they cost."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from support.marks import slow

from oracles.test_derivatives import assembled, batched, consistent, quaternion_rates
from oracles.test_derivatives import moved as moved_by
from symscrew import catalogue
from symscrew.functions import HESSIAN, PRODUCT
from symscrew.model import Model, derive
from symscrew.program import Iteration, evaluate, jacobian

Array = np.ndarray
FEW = ["four_bar", slow("five_bar")]

STEP = 2e-2  # [rad, m, ...]; four halvings extrapolated to order 8, so the rounding of 1e-16 / STEP^2 is the limit


@cache
def model(name: str) -> Model:
    return derive(catalogue.load(name), derivatives=True, second_derivatives=True)


def second_difference(values: list[Array], steps: list[float]) -> Array:
    """Second derivative at 0 from values at 0, +-h, +-h/2 ..., extrapolated."""
    middle = values[0]
    pairs = zip(values[1::2], values[2::2], steps, strict=True)
    table = [(up - 2 * middle + down) / h**2 for up, down, h in pairs]
    for order in range(1, len(table)):
        factor = 4.0**order
        table = [(factor * b - a) / (factor - 1) for a, b in pairwise(table)]
    return table[0]


def state_of(found: Model, name: str) -> list[Array]:
    """Consistent states (q, further inputs) of a function."""
    q, _, _, y_dot, y_ddot = consistent(found)
    random = np.random.default_rng(8)
    known = {"q": q, "y_dot": y_dot, "y_ddot": y_ddot}
    return [known.get(port.name, random.uniform(-2, 2, (len(q), port.size))) for port in found.programs[name].inputs]


def curvature(found: Model, name: str, state: list[Array], steps: list[Array], weights: Array) -> Array:
    """w . d2 f / dh2 along a direction, the loops closed again at every step."""
    sizes = [STEP / 2**k for k in range(4)]
    values = []
    for h in (0.0, *(sign * size for size in sizes for sign in (1, -1))):
        others = [x + h * dx for x, dx in zip(state[1:], steps[1:], strict=True)]
        first = (moved_by if name == "closure" else assembled)(found, state[0], h * steps[0])
        values.append((weights * batched(found, name, first, *others)).sum(-1))
    return second_difference(values, sizes)


def whole_hessian(found: Model, name: str, sizes: list[int], results: tuple[Array, ...]) -> Array:
    """Blocks of the upper triangle as one symmetric matrix: (states, n, n)."""
    program = found.programs[f"{name}{HESSIAN}"]
    product = found.programs[f"{name}{PRODUCT}"]
    groups = [port.name.removeprefix("product_") for port in product.outputs]
    labels = [list(port.labels) for port in product.outputs]
    start = np.concatenate([[0], np.cumsum(sizes)])
    matrix = np.zeros((len(results[0]) if results else 1, start[-1], start[-1]))
    for port, values in zip(program.outputs, results, strict=True):
        pairs = [(a, b) for a in groups for b in groups if port.name == f"hessian_{a}_{b}"]
        ((a, b),) = pairs
        i, j = groups.index(a), groups.index(b)
        for k, label in enumerate(port.labels):
            row, column = label.split("|")
            r, c = start[i] + labels[i].index(row), start[j] + labels[j].index(column)
            matrix[:, r, c] = matrix[:, c, r] = values[:, k]
    return matrix


def closure_curvatures(found: Model, q: Array, weights: Array) -> tuple[Array, Array]:
    """The second derivative of w . closure along turns of the joints: by the Hessian, and by differences.

    Quaternions keep their length, so they move on a circle: q'' = -|v|^2 q / 4 goes with the first derivative.
    """
    v = np.random.default_rng(5).uniform(-1, 1, (len(q), len(found.system.tree.v)))
    rate, bent = quaternion_rates(found, q, v), np.zeros_like(q)
    for link in found.system.tree.links[1:]:
        if link.motion.kind == "S":
            bent[:, link.q] = -0.25 * (v[:, link.v] ** 2).sum(-1, keepdims=True) * q[:, link.q]
    (product,), _ = found(f"closure{PRODUCT}", q, weights, rate)
    plain = found.programs["closure"]
    made = jacobian(plain)
    (entries,), _ = evaluate(made.program, (q,))
    ((_, _, rows, columns),) = made.blocks.values()
    slope = np.zeros((len(q), plain.outputs[0].size, q.shape[1]))
    slope[:, rows, columns] = entries
    got = (product * rate).sum(-1) + np.einsum("ni,nij,nj->n", weights, slope, bent)
    return got, curvature(found, "closure", [q], [v], weights)


def checked(found: Model, name: str) -> None:
    random = np.random.default_rng(4)
    state = state_of(found, name)
    program = found.programs[name]
    product = found.programs[f"{name}{PRODUCT}"]
    sizes = [port.size for port in product.outputs]
    weights = random.uniform(0.5, 1.5, (len(state[0]), program.outputs[0].size))
    directions = [random.uniform(-1, 1, (len(state[0]), n)) for n in sizes]
    given = [*state, weights, *directions]
    found_products, status = found(f"{name}{PRODUCT}", *given)
    assert (status == 0).all()
    joined, along = np.concatenate(found_products, -1), np.concatenate(directions, -1)
    if name == "closure":
        got, expected = closure_curvatures(found, state[0], weights)
    else:
        steps = [*directions, *(np.zeros_like(x) for x in state[len(directions) :])]
        got, expected = (joined * along).sum(-1), curvature(found, name, state, steps, weights)
    size = np.abs(expected).max()
    assert size > 1e-6 and np.abs(got - expected).max() < 3e-6 * max(size, np.abs(joined).max()), name
    entries, status = found(f"{name}{HESSIAN}", *state, weights)
    assert (status == 0).all()
    matrix = whole_hessian(found, name, sizes, entries)
    again = np.einsum("nij,nj->ni", matrix, along)
    assert np.abs(again - joined).max() < 1e-10 * np.abs(joined).max(), name
    blocks = [len(port.labels) for port in found.programs[f"{name}{HESSIAN}"].outputs]
    assert sum(blocks) <= sum(sizes) * (sum(sizes) + 1) // 2


@pytest.mark.parametrize("name", [*FEW, slow("three_ups_upu_s_physical")])
def test_second_derivatives_are_second_differences(name: str) -> None:
    """Of turns of spherical joints, too: by the closure and the inverse dynamics of the seed."""
    found = model(name)
    names = [n for n in found.programs if f"{n}{PRODUCT}" in found.programs]
    assert {"inverse_dynamics_independent", "forward_dynamics_independent"} <= set(names)
    assert ("closure" in names) == bool(found.system.cuts)
    for function in names if name in ("four_bar", "five_bar") else ("closure", "inverse_dynamics_independent"):
        checked(found, function)


@pytest.mark.parametrize("name", FEW)
def test_a_product_costs_at_most_four_times_the_first_derivatives(name: str) -> None:
    found = model(name)
    counts = {n: p.operations["total"] for n, p in found.programs.items()}
    for function in ("inverse_dynamics_independent", "forward_dynamics_independent"):
        assert counts[f"{function}{PRODUCT}"] <= 4 * counts[f"{function}_derivatives"], function
    plain = found.programs["closure"]
    assert not isinstance(plain, Iteration)
    assert counts[f"closure{PRODUCT}"] <= 4 * jacobian(plain).program.operations["total"] + 4 * counts["closure"]


def test_what_cannot_differ_from_zero_is_no_entry() -> None:
    found = model("four_bar")
    names = [port.name for port in found.programs[f"inverse_dynamics_independent{HESSIAN}"].outputs]
    assert names == ["hessian_y_y", "hessian_y_y_dot", "hessian_y_y_ddot", "hessian_y_dot_y_dot"]  # linear in y_ddot
    forward = [port.name for port in found.programs[f"forward_dynamics_independent{HESSIAN}"].outputs]
    assert "hessian_u_u" not in forward and "hessian_y_u" in forward


def test_nothing_is_added_unless_it_is_asked_for() -> None:
    plain = derive(catalogue.load("four_bar"))
    assert not [n for n in plain.programs if n.endswith((PRODUCT, HESSIAN))]
    both = model("four_bar")
    assert all(both.programs[n].operations == p.operations for n, p in plain.programs.items())
