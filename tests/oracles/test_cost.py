"""The bill of effects: counts against the models themselves, changes against method B, and the command."""

from __future__ import annotations

import numpy as np
import pytest
from support.cranked_scene import SCENE
from support.effect_oracles import Oracle

from symscrew import catalogue
from symscrew import effects as known
from symscrew.effects.effect import Effect
from symscrew.effects.gravity import Gravity
from symscrew.model import derive
from symscrew.scene.scene_file import parse_scene
from symscrew.studies.bill_of_effects import bill, effect_labels, scene_bill

CRANK = "slider_crank"


def effect(name: str, *args: object, **fields: object) -> Effect:
    return getattr(known, name)(*args, **fields)


@pytest.mark.slow
def test_operations_states_and_changes() -> None:
    friction, motor = effect("ViscousFriction", "slider_P", 2), effect("DcMotor", "crank_R", "0.05", 1, "0.1")
    found = bill(catalogue.load(CRANK), [Gravity(), friction, motor], timed=False)
    gravity, viscous, current = found.items
    assert (gravity.states, viscous.states, current.states) == (0, 0, 1)
    # + c v; less the test for NaN of v, which without friction no result depends on
    assert viscous.operations == {"inverse_dynamics": 1, "forward_dynamics": 1}
    assert current.operations["inverse_dynamics"] >= 1
    whole = derive(catalogue.load(CRANK), [Gravity(), friction, motor])
    assert found.operations["inverse_dynamics"] == whole.programs["inverse_dynamics"].operations["total"]
    assert all(value is None for item in found.items for value in item.nanoseconds.values())


def test_change_is_what_method_b_says() -> None:
    """Leaving friction out changes the drives, along the sample states, by what the friction needs."""
    mechanism = catalogue.load(CRANK)
    of = Oracle(derive(mechanism, []))
    found = bill(mechanism, [Gravity(), effect("ViscousFriction", "slider_P", 2)], timed=False)
    force = of.along("slider_P", -2 * of.rate("slider_P"))
    full, less = (of.solve(*parse_scene, gravity=(0, 0, -9.81)).drives for parse_scene in ([force], []))
    expected = np.sqrt(np.mean((full - less) ** 2) / np.mean(full**2))
    assert found.items[1].change["drives"] == pytest.approx(float(expected), rel=1e-9)


@pytest.mark.slow
def test_drives_that_vanish_are_compared_with_the_largest_change() -> None:
    """In a free motion the drives are zero with all effects: the effect that matters most counts 100 %."""
    free = SCENE.replace('[drives]\ncrank_R = "0.5*cos(t)"\n', "")
    found = scene_bill(parse_scene(free), timed=False)
    assert max(item.change["drives"] for item in found.items) == 1.0
    assert all(0 < item.change["drives"] <= 1 for item in found.items)


def test_simplifications_save() -> None:
    found = bill(catalogue.load("four_bar"), [Gravity(), effect("MasslessLimbs")], timed=False)
    assert found.items[1].operations["inverse_dynamics"] < -10


@pytest.mark.slow
def test_scene_along_its_own_motion() -> None:
    found = scene_bill(parse_scene(SCENE), timed=False)
    assert found.name == "cranked" and "simulated motion of 0.5 s, 21 outputs" in found.motion
    assert [item.effect for item in found.items] == ["viscous_friction slider_P", "dc_motor crank_R"]
    for item in found.items:
        assert all(0 < value < 100 for value in item.change.values())


def test_scene_without_forward_dynamics_is_billed_at_sample_states() -> None:
    found = scene_bill(
        parse_scene(SCENE.replace("[drives]", '[[effects]]\ntype = "quasi_static"\n[drives]')), timed=False
    )
    assert "sample states" in found.motion and found.items[-1].operations["inverse_dynamics"] < 0


def test_labels_tell_effects_apart() -> None:
    labels = effect_labels([Gravity(), *(effect("ViscousFriction", j, 1) for j in ("A", "B", "A"))])
    assert labels == ["gravity", "viscous_friction A", "viscous_friction B", "viscous_friction A (2)"]
