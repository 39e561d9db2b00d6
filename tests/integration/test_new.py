"""`symscrew new`: descriptions that load, derive and move as their limbs say, and never overwrite a file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from symscrew.cli.parser import main
from symscrew.description import toml_file
from symscrew.description.template import description_text, write_template
from symscrew.errors import DescriptionError
from symscrew.model import derive

FREEDOMS = {
    "3-UPS+UPU+S": (2, 4),
    "RRRRRR": (6, 6),
    "3-RRR": (3, 3),
    "3-RPR": (3, 3),
    "2-RR": (1, 2),
    "3-RUU": (3, 3),
    "RRPR": (4, 4),
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
    model = derive(toml_file.parse_description(description_text("delta", "3-RUU")))
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
    assert main(["new", "wrist", "--limbs", "3-UPS+UPU+S"]) == 0
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
