"""The bill of effects: counts against the models themselves, changes against method B, and the command."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from support.effect_oracles import Oracle

from symscrew import catalogue
from symscrew import effects as known
from symscrew.cli.parser import main
from symscrew.effects.effect import Effect
from symscrew.effects.gravity import Gravity
from symscrew.errors import DescriptionError
from symscrew.model import derive
from symscrew.runtime.compiled import find_compiler
from symscrew.scene.scene_file import parse_scene
from symscrew.studies.bill_of_effects import bill, bill_figure, bill_text, effect_labels, scene_bill

CRANK = "slider_crank"
SCENE = """
[scene]
name = "cranked"
mechanism = "slider_crank"
duration = 0.5
rate = 40
[initial]
rates = {crank_R = 3}
[[effects]]
type = "viscous_friction"
joint = "slider_P"
coefficient = 2
[[effects]]
type = "dc_motor"
joint = "crank_R"
torque_constant = 0.05
resistance = 1.2
inductance = 0.08
ratio = 20
[drives]
crank_R = "0.5*cos(t)"
[inputs]
voltage_crank_R = ["2*cos(t)"]
"""


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


@pytest.mark.slow
@pytest.mark.skipif(find_compiler() is None, reason="no C compiler: nothing is timed")
def test_timed_side_by_side() -> None:
    found = bill(catalogue.load(CRANK), [Gravity(), effect("ViscousFriction", "slider_P", 2)])
    assert all(value is not None and value > 0 for value in found.nanoseconds.values())
    assert all(np.isfinite(value) for item in found.items for value in item.nanoseconds.values())


def test_scene_without_forward_dynamics_is_billed_at_sample_states() -> None:
    found = scene_bill(
        parse_scene(SCENE.replace("[drives]", '[[effects]]\ntype = "quasi_static"\n[drives]')), timed=False
    )
    assert "sample states" in found.motion and found.items[-1].operations["inverse_dynamics"] < 0


def test_labels_tell_effects_apart() -> None:
    labels = effect_labels([Gravity(), *(effect("ViscousFriction", j, 1) for j in ("A", "B", "A"))])
    assert labels == ["gravity", "viscous_friction A", "viscous_friction B", "viscous_friction A (2)"]


@pytest.mark.slow
def test_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = tmp_path / "cranked.toml"
    scene.write_text(SCENE)
    assert main(["cost", str(scene), "--no-timing", "--json", "--plot", str(tmp_path / "bill.png")]) == 0
    values = json.loads(capsys.readouterr().out)
    assert values["items"][0]["operations"] == {"inverse_dynamics": 1, "forward_dynamics": 1}
    assert (tmp_path / "bill.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["nowhere.toml"], "cannot be read"),
        (["empty.toml"], "names no effects"),
        (["scene.toml", "--plot", "bill.pdf"], ".png"),
        (["scene.toml", "--plot", "nowhere/bill.png"], "no folder"),
    ],
)
def test_bad_input_ends_in_one_line(
    arguments: list[str],
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("empty.toml").write_text(SCENE[: SCENE.index("[[effects]]")])
    Path("scene.toml").write_text(SCENE)
    assert main(["cost", *arguments]) == 2
    error = capsys.readouterr().err.splitlines()[-1]
    assert error.startswith("symscrew: error: ") and message in error
    assert sorted(p.name for p in tmp_path.iterdir()) == ["empty.toml", "scene.toml"]


def test_a_table_and_a_picture_without_times() -> None:
    found = bill(catalogue.load(CRANK), [Gravity()], timed=False)
    assert "| gravity" in bill_text(found) and len(bill_figure(found).axes) == 2
    with pytest.raises(DescriptionError, match="did you mean"):
        bill(catalogue.load(CRANK), [effect("ViscousFriction", "slidr_P", 1)], timed=False)
