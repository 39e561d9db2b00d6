"""The counts of the field against the literature: mobility and overconstraint of mechanisms with a source each.

What the publications of `data/mobility.json` state is the mobility, and what its formulas then make of Kutzbach's
count. lambda, nu, zeta and the groups below are what this program counted when they were recorded: a change is seen, a
publication was not asked. (nu is counted in two ways, from limbs and from the closure.)
"""

from __future__ import annotations

import pytest
from support.reference_mechanisms import ENTRIES, build

from symscrew.mobility import analyse_mobility, mobility_text, mobility_values, verify

OWN = ("negative control", "textbook", "constructed for this zoo")
"""Entries of `data/mobility.json` without a publication."""
RECORDED = {
    "planar_4bar": (3, 0, 0, "G"), "slider_crank": (3, 0, 0, "G"), "andrews_7body": (3, 0, 0, "G"),
    "planar_3rrr": (3, 0, 0, "G"), "oldham": (3, 0, 0, "G"), "threebar_parallel_equal": (3, 1, 0, "G"),
    "spherical_4r": (3, 0, 0, "S"), "agile_eye": (3, 0, 0, "S"), "bennett": (3, 0, 0, "D"),
    "goldberg_5r": (2, 0, 0, "D"), "sarrus": (1, 0, 0, "D"), "bricard_box": (1, 0, 0, "D"),
    "schatz_turbula": (1, 0, 0, "D"), "double_hooke": (1, 0, 0, "D"), "general_7r": (0, 0, 0, "D"),
    "rssr": (0, 0, 1, "D"), "stewart_6ups": (0, 0, 0, "D"), "stewart_6sps": (0, 0, 6, "D"),
    "tripteron_cpm": (0, 3, 0, "D"), "3upu_tsai": (0, 0, 0, "D"), "3rps": (0, 0, 0, "D"),
    "tricept": (0, 0, 0, "D"), "delta_4s": (0, 0, 6, "D"),
}  # fmt: skip
"""Mechanism -> (lambda, nu, zeta, group of a loop)."""


def published() -> list[str]:
    """Entries whose geometry and mobility stand in a publication."""
    return [
        name for name, entry in ENTRIES.items() if "source" in entry and not str(entry["source"][0]).startswith(OWN)
    ]


def test_there_are_more_than_thirty_with_a_source() -> None:
    assert len({name.partition("-")[0] for name in published()}) >= 30


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.slow] if "-" in name else []) for name in published()]
)
def test_formulas_of_the_field_give_the_published_mobility(name: str) -> None:
    counts, expected = analyse_mobility(build(ENTRIES[name])).counts, ENTRIES[name]["expected"]
    assert (counts.kutzbach, counts.mobility) == (expected["kutzbach"], expected["dof"])
    assert counts.modified == expected["dof"] - counts.isolated
    assert (counts.overconstraint, counts.redundancy) == (expected["overconstraints"], expected["internal_freedoms"])
    assert counts.by_limbs in (None, counts.redundant)
    if name in RECORDED:
        common, redundant, isolated, group = RECORDED[name]
        assert (counts.common, counts.redundant, counts.isolated) == (common, redundant, isolated)
        assert all(loop.group.startswith(group) for loop in counts.loops)


def test_counts_stand_in_the_report_and_in_the_json() -> None:
    found = analyse_mobility(build(ENTRIES["tripteron_cpm"]))
    text, values = mobility_text(found), mobility_values(found)["counts"]
    assert "nu = 3 redundant" in text and "Connectivity of the limbs S_Gi" in text
    assert (values["nu"], values["lambda"], values["M"], values["modified_kutzbach"]) == (3, 0, 3, 3)
    assert [limb["S_G"] for limb in values["limbs"]] == [4, 4, 4]
    assert any(check.claim == "redundant constraints by limbs as by loops" for check in verify(found))


def test_a_wrong_count_of_the_limbs_is_found() -> None:
    found = analyse_mobility(build(ENTRIES["tripteron_cpm"]))
    object.__setattr__(found.counts, "by_limbs", 2)
    failed = [check for check in verify(found) if not check.holds]
    assert [check.claim for check in failed] == ["redundant constraints by limbs as by loops"]
