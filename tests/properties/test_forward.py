"""Forward dynamics: the inverse of inverse dynamics, for every mechanism, overconstrained and redundant ones too."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.mechanisms import chain
from support.model_states import ALL, relative
from support.model_states import model as derived
from support.operation_counts import recorded
from support.trees import spatial_tree

from symscrew.description.builder import MechanismBuilder
from symscrew.dynamics.articulated import articulated_accelerations
from symscrew.functions.forward import driven
from symscrew.model import Model, derive

LIMIT = 1e-10


@pytest.fixture(params=ALL)
def model(request: pytest.FixtureRequest) -> Model:
    found = derived(request.param)
    if not found.system.drives:
        pytest.skip("no drives")
    return found


def random_states(model: Model, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Consistent states: configurations of the samples with random independent rates and second rates."""
    random = np.random.default_rng(11)
    q = np.resize(model.system.sample_states[0], (count, len(model.system.tree.q)))
    size = model.programs["velocity"].inputs[1].size
    (v,), first = model("velocity", q, random.uniform(-2, 2, (count, size)))
    (a,), second = model("acceleration", q, v, random.uniform(-5, 5, (count, size)))
    assert not first.any() and not second.any()
    return q, v, a


def test_forward_of_inverse_is_the_acceleration(model: Model) -> None:
    q, v, a = random_states(model, 20)
    (u,), status = model("inverse_dynamics", q, v, a)
    assert not status.any()
    (again,), status = model("forward_dynamics", q, v, u)
    assert not status.any() and relative(again, a) < LIMIT


def test_inverse_of_forward_is_the_drive_without_its_preload(model: Model) -> None:
    """u itself when the preload is put back."""
    q, v, _ = random_states(model, 20)
    count = len(model.system.drives)
    u = np.random.default_rng(3).uniform(-10, 10, (20, count))
    (a,), status = model("forward_dynamics", q, v, u)
    assert not status.any()
    (found,), _ = model("inverse_dynamics", q, v, a)
    if "inverse_dynamics_preload" not in model.programs:
        assert relative(found, u) < LIMIT
        return
    (back,), status = model("inverse_dynamics_preload", q, v, a, np.ones_like(u), u)
    assert not status.any() and relative(back, u) < LIMIT
    assert relative(found, u) > 1e-3  # these drives did hold a preload
    (same,), _ = model("forward_dynamics", q, v, found)
    assert relative(same, a) < LIMIT
    inner = np.einsum("ij,ij->i", u - found, found)
    assert np.abs(inner).max() < 1e-9 * np.abs(u).max() ** 2  # the preload is orthogonal to the minimum-norm drives


def test_from_the_independent_coordinates(model: Model) -> None:
    q, v, _ = random_states(model, 10)
    u = np.random.default_rng(4).uniform(-10, 10, (10, len(model.system.drives)))
    (null,), _ = model("null_space", q)
    n = len(model.system.tree.v)
    null = null.reshape(len(q), -1, n)  # columns of N
    y_dot = np.array([np.linalg.lstsq(columns.T, rates, rcond=None)[0] for columns, rates in zip(null, v, strict=True)])
    (a,), _ = model("forward_dynamics", q, v, u)
    (y_ddot,), status = model("forward_dynamics_independent", q, y_dot, u)
    assert not status.any()
    (again,), _ = model("acceleration", q, v, y_ddot)
    assert relative(again, a) < LIMIT


def test_power_balance(model: Model) -> None:
    """The rate of the total energy is the power of the drives: energy along v and a, by a complex-free difference."""
    q, v, _ = random_states(model, 5)
    system = model.system
    u = np.random.default_rng(5).uniform(-5, 5, (5, len(system.drives)))
    (a,), _ = model("forward_dynamics", q, v, u)
    (rates,), _ = model("drive_rates", q, v)
    power = np.einsum("ij,ij->i", u, rates)

    def energy(h: float) -> np.ndarray:
        w = np.array([system_rates(model, one, rate) for one, rate in zip(q, v, strict=True)])
        gain = np.array([system_rates(model, one, rate) for one, rate in zip(q, a, strict=True)])
        moved = system.advance(q, h * w + 0.5 * h * h * gain)
        (both,), _ = model("energy", moved, v + h * a)
        return both.sum(axis=-1)

    def difference(h: float) -> np.ndarray:
        return (energy(h) - energy(-h)) / (2 * h)

    h = 1e-2 / (1 + np.abs(v).max() + np.abs(a).max())
    best = (4 * difference(h / 2) - difference(h)) / 3
    scale = np.abs(u).max() * np.abs(rates).max() + np.abs(power).max()
    assert np.abs(best - power).max() < 1e-5 * scale


def system_rates(model: Model, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Joint rates w (spherical ones in the axes before the rotation) from v."""
    system = model.system
    inputs = (system.inputs.q, q[None]), (system.inputs.v, v[None])
    return system.numeric(system.joint_rates(system.inputs.v), *inputs)[0]


@pytest.mark.parametrize("name", ["ur5", "panda", "spatial_tree"])
def test_articulated_bodies_agree_with_the_mass_matrix(name: str) -> None:
    """Two ways to the accelerations of a tree: by its mass matrix and by articulated bodies."""
    found = derive(spatial_tree()) if name == "spatial_tree" else derived(name)
    system = found.system
    acting, drives = driven(system, found.effects)
    a, _ = articulated_accelerations(system, acting)
    q, v, _ = system.sample_states
    u = np.random.default_rng(9).uniform(-5, 5, (len(q), len(system.drives)))
    (expected,), status = found("forward_dynamics", q, v, u)
    assert not status.any()
    inputs = [(system.inputs.q, q), (system.inputs.v, v)] + ([(drives[0][1], u)] if drives else [])
    assert relative(system.numeric(a, *inputs), expected) < LIMIT


@pytest.mark.slow
def test_long_chains_take_operations_in_proportion() -> None:
    """Beyond ten joints the forward dynamics of a chain grows linearly."""
    counts = []
    for size in (12, 16, 20):
        counts.append(derive(chain(size)).programs["forward_dynamics"].operations["total"])
        assert counts[-1] <= recorded("sized", f"chain {size}")["forward_dynamics"]
    assert counts[2] - counts[1] == pytest.approx(counts[1] - counts[0], rel=0.02)


def test_without_mass_there_is_no_forward_dynamics_but_everything_else() -> None:
    """A motion that moves no mass has no acceleration: the functions are left out, and the notes say why."""
    builder = MechanismBuilder("massless")
    builder.body("crank")
    builder.body("rod", mass=1, com=[0, 0, 2], inertia=[0.1, 0.1, 0])
    builder.joint("A", "R", parent="base", child="crank", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    builder.joint("B", "P", parent="crank", child="rod", point=[0, 0, 1], axes=[[0, 1, 0]], driven=True)
    assert "forward_dynamics" in derive(builder.build()).programs
    bare = MechanismBuilder("bare").body("crank")
    bare.joint("A", "R", parent="base", child="crank", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    found = derive(bare.build())
    assert "forward_dynamics" not in found.programs and "velocity" in found.programs
    assert any("moves no mass" in note for note in found.notes)
