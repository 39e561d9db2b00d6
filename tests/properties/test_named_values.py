"""Values are what their names say: those of the inverse dynamics against functions at O in absolute axes."""

from __future__ import annotations

import numpy as np
import pytest
from support.model_states import model

from symscrew.algebra import apply_numpy
from symscrew.model import Model
from symscrew.program import Program

NAMES = ("three_ups_upu_s", "delta", "panda")
AXES = "xyz"


def values_of(program: Program, arguments: tuple[np.ndarray, ...]) -> dict[int, np.ndarray]:
    """Every slot at all states."""
    columns = [column for x in arguments for column in np.asarray(x).T]
    slots: dict[int | float, np.ndarray] = dict(enumerate(columns))
    for i in program.instructions:
        slots[i.target] = apply_numpy(i.op, [slots[a] if isinstance(a, int) else np.float64(a) for a in i.args])
    return {int(slot): value for slot, value in slots.items()}


def named(found: Model, function: str, quantity: str) -> dict[tuple[str, str, str], list[np.ndarray]]:
    """Values called so: by part, component and what they are of."""
    program = found.programs[function]
    assert isinstance(program, Program)
    values = values_of(program, found.test_inputs[function])
    result: dict[tuple[str, str, str], list[np.ndarray]] = {}
    for slot, origin in program.origins.items():
        if origin.quantity == quantity:
            key = origin.part, origin.component, origin.by
            result.setdefault(key, []).append(-values[slot] if origin.negative else values[slot])
    return result


def rotations(found: Model) -> dict[str, np.ndarray]:
    """absolute_R_link of every body, by `body_poses` and the link's axes in the reference configuration."""
    poses = found("body_poses", *found.test_inputs["body_poses"])[0][0]
    bodies = [name for name in found.mechanism.bodies if name != found.mechanism.ground]
    result = {}
    for k, body in enumerate(bodies):
        moved = poses[:, 12 * k : 12 * k + 9].reshape(-1, 3, 3).transpose(0, 2, 1)
        axes = found.system.frames[found.system.tree.link_of_body[body]].axes
        result[body] = moved @ np.array([[float(c if isinstance(c, int) else c.value) for c in row] for row in axes])
    return result


def motions(found: Model, function: str) -> dict[str, np.ndarray]:
    """Rows of 6 of a function with a column per body, at the states of the inverse dynamics."""
    count = len(found.programs[function].inputs)
    rows = found(function, *found.test_inputs["inverse_dynamics"][:count])[0][0]
    bodies = [name for name in found.mechanism.bodies if name != found.mechanism.ground]
    return {body: rows[:, 6 * k : 6 * k + 6] for k, body in enumerate(bodies)}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(("quantity", "function"), [("omega", "body_twists"), ("alpha", "body_twist_rates")])
def test_angular_rates_are_those_of_the_twists_in_the_axes_of_the_link(name: str, quantity: str, function: str) -> None:
    found = model(name)
    turned, twists = rotations(found), motions(found, function)
    compared = 0
    for (part, component, _), several in named(found, "joint_reactions", quantity).items():
        if part in turned:
            vector = np.einsum("kji,kj->ki", turned[part], twists[part][:, :3])
            for value in several:
                np.testing.assert_allclose(value, vector[:, AXES.index(component)], atol=1e-12)
                compared += 1
    assert compared >= 6


@pytest.mark.parametrize("name", NAMES)
def test_cosines_and_sines_are_of_one_angle(name: str) -> None:
    cosines, sines = (named(model(name), "joint_reactions", quantity) for quantity in ("cos", "sin"))
    both = cosines.keys() & sines.keys()
    assert len(both) >= 3
    for key in both:
        np.testing.assert_allclose(cosines[key][0] ** 2 + sines[key][0] ** 2, 1.0, rtol=1e-14)


@pytest.mark.parametrize("name", ["three_ups_upu_s", "stewart_6ups", "delta"])
def test_multipliers_are_components_of_the_reactions_at_the_cut_joints(name: str) -> None:
    """Forces along the axes of the tip: their sum of squares does not depend on axes."""
    found = model(name)
    results, _ = found("joint_reactions", *found.test_inputs["joint_reactions"])
    multipliers = named(found, "joint_reactions", "multiplier")
    labels = list(found.mechanism.joints)
    compared = 0
    for cut in found.system.cuts:
        joint = cut.joint.name
        parts = [multipliers.get((joint, f"f{c}", ""), []) for c in AXES]
        if all(parts):
            at = 6 * labels.index(joint)
            squares = (results[-1][:, at : at + 3] ** 2).sum(axis=1)
            np.testing.assert_allclose(sum(part[-1] ** 2 for part in parts), squares, rtol=1e-9, atol=1e-9)
            compared += 1
    assert compared >= 3
