"""Rows of the closure by the ends of rods: the same rates and accelerations as by the rods' own axes."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from support.marks import slow
from support.model_states import relative
from support.rod_mechanisms import (
    braced_arm,
    delta_text,
    hexapod,
    hung_platform,
    model,
    rotary_hexapod,
    second_rods_first,
)
from test_loop_rows import sampled

from symscrew import catalogue
from symscrew.algebra.traversal import inputs_of
from symscrew.description import toml_file
from symscrew.description.mechanism import Mechanism
from symscrew.kinematics.system import System
from symscrew.loops.closure import Closure, closure_by
from symscrew.loops.dependent_rates import Loops
from symscrew.loops.formulations.rod_rows import RodRows


def from_the_rod() -> Mechanism:
    """The delta with one universal joint described from the rod to the arm."""
    parts = delta_text().split("[joints.rod1a_U]")
    joint = (
        parts[1]
        .replace('parent = "arm1"\nchild = "rod1a"', 'parent = "rod1a"\nchild = "arm1"', 1)
        .replace(
            '[[0, 1, 0], ["depth/rods", 0, "-inwards/rods"]]', '[["depth/rods", 0, "-inwards/rods"], [0, 1, 0]]', 1
        )
    )
    return toml_file.parse_description(f"{parts[0]}[joints.rod1a_U]{joint}")


MECHANISMS: dict[str, tuple[Callable[[], Mechanism], int]] = {
    "delta": (lambda: catalogue.load("delta"), 6),
    "from_the_rod": (from_the_rod, 6),
    "second_rods_first": (second_rods_first, 6),
    "hexapod": (hexapod, 6),
    "rod_on_the_ground": (lambda: hexapod(cranks=5), 6),
    "rotary_hexapod": (rotary_hexapod, 6),  # first axes of the rods across those of the cranks
    "hung_platform": (hung_platform, 3),  # rods on the ground
    "braced_arm": (braced_arm, 1),  # a rod between two links that move
}


@cache
def system_of(name: str) -> System:
    system = System(MECHANISMS[name][0]())
    system.use_samples()
    return system


def by_rods(system: System) -> Closure:
    return closure_by(system, ("rods", "seen", "plain"))


def rods_of(closure: Closure) -> list[RodRows]:
    return [part for part in closure.parts if isinstance(part, RodRows)]


DEAR = ("hung_platform", "rotary_hexapod", "second_rods_first")  # derived in a second or two each


@pytest.mark.parametrize("name", [slow(name) if name in DEAR else name for name in MECHANISMS])
def test_rates_and_bias_are_those_of_the_plain_rows(name: str) -> None:
    system = system_of(name)
    tape, plain = system.tape, Loops(system)
    closure = by_rods(system)
    rods = Loops(system, closure=closure)
    assert len(rods_of(closure)) == MECHANISMS[name][1] and not closure.of_system and plain.closure.of_system
    assert rods.free == plain.free and rods.rank == plain.rank
    assert len(rods.elimination.redundant) == len(plain.redundant)
    zero, still = [tape.zero] * len(system.jacobian), [tape.zero] * len(plain.free)
    moving = [system.inputs.v[k] for k in plain.free]
    first, second = (sampled(system, loops.dependent(zero, moving))[:, 1:] for loops in (plain, rods))
    assert relative(second, first) < 1e-11
    first, second = (
        sampled(system, loops.dependent([-b for b in loops.bias(system)], still))[:, 1:] for loops in (plain, rods)
    )
    assert np.abs(first).max() > 0.1 and relative(second, first) < 1e-9


def test_a_rod_s_rows_hold_its_own_rates_one_by_one() -> None:
    """One for its length, and one for each of its angles, of which only the second one's cosine is read."""
    system = system_of("delta")
    for rod in rods_of(by_rods(system)):
        first, second = (link.v.start for link in rod.limb.links)
        length, turn, tilt = rod.rows
        assert not {first, second} & set(length)
        assert first in turn and second not in turn
        assert second in tilt and first not in tilt
        angles = {system.inputs.q[link.q.start] for link in rod.limb.links}
        read = inputs_of([entry for row in rod.rows for entry in row.values()])
        assert angles & set(read) == {system.inputs.q[rod.limb.second.q.start]}


@pytest.mark.parametrize("name", ["delta", slow("hexapod"), slow("rotary_hexapod"), "braced_arm"])
def test_functions_of_rods_by_consistent_states(name: str) -> None:
    """Rates and accelerations of samples on the closure, found by Newton's method on the plain rows."""
    found = model(name)
    q, v, a = found.system.states(6, 21)
    count = len(found.independent)
    y_dot, y_ddot = v[:, :count], a[:, :count]  # any rates and accelerations of them
    (columns,), status = found("null_space", q)
    assert np.all(status == 0)
    columns = columns.reshape(len(q), count, -1)
    (rates,), status = found("velocity", q, y_dot)
    assert np.all(status == 0) and relative(np.einsum("skj,sk->sj", columns, y_dot), rates) < 1e-11
    (gains,), status = found("acceleration", q, rates, y_ddot)
    assert np.all(status == 0)
    (jacobian,), _ = found("closure_jacobian", q)
    (bias,), _ = found("closure_bias", q, rates)
    matrix = jacobian.reshape(len(q), rates.shape[1], -1)
    assert np.abs(np.einsum("sjk,sj->sk", matrix, rates)).max() < 1e-11 * np.abs(rates).max()
    assert np.abs(np.einsum("sjk,sj->sk", matrix, gains) + bias).max() < 1e-10 * np.abs(gains).max()


def test_drives_and_accelerations_of_a_delta_agree() -> None:
    """From independent rates, from the tree's (equal to method B in test_rods), and back."""
    found = model("delta")
    q, v, a = found.system.states(6, 5)
    free = [k for k, c in enumerate(found.system.tree.v) if c.label in found.independent]
    (u,), status = found("inverse_dynamics_independent", q, v[:, free], a[:, free])
    assert np.all(status == 0)
    (expected,), _ = found("inverse_dynamics", q, v, a)
    assert relative(u, expected) < 1e-10
    (back,), status = found("forward_dynamics", q, v, u)
    assert np.all(status == 0) and relative(back, a) < 1e-9


def test_a_rod_along_its_first_axis_is_reported() -> None:
    """There its first angle has no rate that follows from its ends."""
    found = model("delta")
    q = found.system.states(1, 5)[0]
    second = next(k for k, c in enumerate(found.system.tree.q) if c.joint == "rod1a_U" and c.label.endswith("1"))
    q[0, second] += np.pi / 2 - q[0, second]
    (rates,), status = found("velocity", q, np.ones((1, 3)))
    assert status[0] == 1 and np.isnan(rates).any()
