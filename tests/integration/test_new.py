"""`symscrew new`: descriptions that load, derive and move as their limbs say, and never overwrite a file."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.description import ARCHITECTURES, architecture, toml_file
from symscrew.description.limb_letters import parse_limb_string, parse_mechanism_string
from symscrew.description.template import description_text, write_template
from symscrew.errors import DescriptionError
from symscrew.mobility import analyse_mobility
from symscrew.mobility.instantaneous import body_freedoms, instantaneous_mobility
from symscrew.mobility.joint_network import network_of
from symscrew.model import derive

FREEDOMS = {
    "3-UPS+UPU+S": (2, 4),
    "RRRRRR": (6, 6),
    "3-RRR": (3, 3),
    "2-RR": (1, 2),
    "3-RUU": (3, 3),
    "S": (3, 3),
}
"""Independent coordinates (freedoms of the textbook's mechanism of this name) and drives."""


@pytest.mark.slow
@pytest.mark.parametrize("limbs", FREEDOMS)
def test_mechanism_derives_and_moves(limbs: str) -> None:
    model = derive(toml_file.parse_description(description_text("started", limbs)))
    freedoms, drives = FREEDOMS[limbs]
    assert model.programs["drive_rates"].outputs[0].size == drives
    system = model.system
    q, v, _ = system.sample_states
    rank = 0
    if system.cuts:
        closure = system.numeric(system.closure.dense(), (system.inputs.q, q))
        rank = int(np.linalg.matrix_rank(closure.reshape(len(q), -1, v.shape[1])[0], tol=1e-9))
    assert v.shape[1] - rank == freedoms
    results, status = model("inverse_dynamics", *model.test_inputs["inverse_dynamics"])
    assert np.all(status == 0) and np.all(np.isfinite(results[0]))


@pytest.mark.slow
def test_legs_of_delta_translate_only() -> None:
    model = derive(toml_file.parse_description(description_text("started", "3-RUU")))
    q, v, _ = model.system.sample_states
    twists = model("body_twists", q, v)[0][0].reshape(len(q), -1, 6)
    platform = [b for b in model.mechanism.bodies if b != model.mechanism.ground].index("platform")
    assert np.abs(twists[:, platform, :3]).max() < 1e-12 < np.abs(twists[:, platform, 3:]).max()


def test_arm_is_not_singular_in_reference() -> None:
    model = derive(toml_file.parse_description(description_text("arm", "RRRRRR")))
    margins, status = model("limb_margins", model.system.reference[None, :])
    assert np.all(status == 0) and np.abs(margins[0]).min() > 1e-2


@pytest.mark.slow
def test_pictures_of_hexapod_are_not_the_singular_one() -> None:
    """Six legs between two regular hexagons would be singular; ours stand in pairs."""
    mechanism = toml_file.parse_description(description_text("hexapod", "6-UPS"))
    points = {n: np.array([float(mechanism.number(c)) for c in p.at]) for n, p in mechanism.points.items()}
    feet = np.array([points[f"A{k}"] for k in range(1, 7)])
    heads = np.array([points[f"C{k}"] for k in range(1, 7)])
    lines = (heads - feet) / np.linalg.norm(heads - feet, axis=1)[:, None]
    matrix = np.hstack([lines, np.cross(feet, lines)])
    assert np.linalg.svd(matrix, compute_uv=False)[-1] > 0.02


def test_file_is_not_overwritten(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["new", "wrist", "--limbs", "3-RRR"]) == 0
    assert capsys.readouterr().out == "wrist.toml\nmobility 3, platform 1R2T, 3 drives\n"
    before = (tmp_path / "wrist.toml").read_bytes()
    assert main(["new", "wrist", "--limbs", "RRR"]) == 2
    assert "is there already" in capsys.readouterr().err
    assert (tmp_path / "wrist.toml").read_bytes() == before
    assert [p.name for p in tmp_path.iterdir()] == ["wrist.toml"]
    assert toml_file.load_description(tmp_path / "wrist.toml").name == "wrist"


@pytest.mark.parametrize(
    "name, limbs, text",
    [
        ("a", "3-UPX", "unknown joint letter 'X'"),
        ("a", "3-UPB", "did you mean 'S'"),
        ("a", "3-ups", "write 'U'"),
        ("a", "", "expected limbs such as"),
        ("a", "3-UPS+~UP*", "passive by its tilde and driven by its star"),
        ("a", "3-RRPa*R", "a parallelogram has no drive of its own"),
        ("a", "3-", "3"),
        ("../a", "RRR", "not a valid name"),
        ("while", "RRR", "while"),
    ],
)
def test_bad_input_writes_nothing(name: str, limbs: str, text: str, tmp_path: Path) -> None:
    with pytest.raises(DescriptionError) as error:
        write_template(name, limbs, tmp_path / "a.toml")
    assert text in str(error.value)
    assert not list(tmp_path.iterdir())


# -- named mechanisms -------------------------------------------------------------------------------------

QUICK = ("agile_eye", "exechon", "4_prur")
SLOW = [name for name in ARCHITECTURES if name not in QUICK]


@pytest.mark.parametrize("name", [*QUICK, *(pytest.param(n, marks=pytest.mark.slow) for n in SLOW)])
def test_named_mechanisms_move_as_their_name_promises(name: str) -> None:
    """Full rank of the closure, or finite mobility by more than first order; at rest with its drives locked."""
    promised = ARCHITECTURES[name]
    mechanism = toml_file.parse_description(description_text("named", name))
    network = network_of(mechanism)
    first_order = instantaneous_mobility(network)
    assert first_order.dof == len(network.driven) == promised.freedoms and first_order.dof_drives_locked == 0
    assert body_freedoms(network, first_order, "platform").type == promised.type
    if first_order.overconstraints:
        found = analyse_mobility(mechanism)
        assert found.finite.smooth and found.finite.dof == promised.freedoms


def test_a_parallelogram_is_two_bars_that_keep_what_they_carry_from_turning() -> None:
    """One limb of the orthoglide alone turns its tip about one axis; without the second bar about two."""
    whole = toml_file.parse_description(description_text("one", "orthoglide"))
    assert len(whole.joints) == 3 * (5 + 2) and not whole.limbs
    types = []
    for left_out in ("none", "b"):
        joints = {n: j for n, j in whole.joints.items() if n.startswith("limb1") and not n.endswith(left_out)}
        ends = {whole.ground, *(end for j in joints.values() for end in (j.parent, j.child))}
        alone = dataclasses.replace(whole, joints=joints, bodies={n: x for n, x in whole.bodies.items() if n in ends})
        types.append(analyse_mobility(alone).platform.type)
    assert types == ["1R3T", "2R3T"]


def test_marks_of_passive_limbs_and_parallelograms_are_read() -> None:
    passive = parse_limb_string("~UPS")
    assert passive.driven == ((), (), ()) and parse_limb_string(passive.marked) == passive
    (arm,) = parse_mechanism_string("RRPaR")
    assert (arm.letters, arm.parallelograms, arm.driven[0]) == ("RRRRR", (2,), (0,))
    for text, said in (("RPaR", "a parallelogram, a loop in the limb"), ("~RR*R", "leave one out")):
        with pytest.raises(DescriptionError, match=said):
            parse_limb_string(text)


def test_a_mechanism_of_the_catalogue_is_copied_with_its_comments(tmp_path: Path) -> None:
    target = tmp_path / "mine.toml"
    assert main(["new", "mine", "--from", "four_bar", "--out", str(target)]) == 0
    before, after = catalogue.text("four_bar").splitlines(), target.read_text().splitlines()
    changed = [(one, other) for one, other in zip(before, after, strict=True) if one != other]
    assert changed == [('name = "four_bar"', 'name = "mine"')] and any(line.startswith("#") for line in after)


@pytest.mark.parametrize("limbs, text", [("~UPU", "nothing is driven"), ("2-RR", "2 drives for 1 freedom:"),
                                         ("2-RRR", "with all drives locked")])  # fmt: skip
def test_what_drives_do_not_do_is_said(
    limbs: str, text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["new", "mine", "--limbs", limbs, "--out", str(tmp_path / "mine.toml")]) == 0
    assert text in capsys.readouterr().err


def test_names_are_found_however_they_are_spelt(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    for typed in ("Agile Eye", "agile-eye", "agile_eye", "AGILEEYE"):
        assert architecture(typed) is ARCHITECTURES["agile_eye"]
    assert description_text("one", "2-UPR+SPR") == description_text("one", "exechon")
    assert architecture("3-RRR") is None
    assert main(["new", "a", "--from", "tricepts", "--out", str(tmp_path / "a.toml")]) == 2
    assert "did you mean 'tricept'" in capsys.readouterr().err and not list(tmp_path.iterdir())
