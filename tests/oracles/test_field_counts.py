"""The counts of the field: mobility, overconstraint, lambda, nu, zeta, connectivities: as read, by hand, by other code.

Mobility and redundant constraints of the mechanisms of `data/mobility.json` are those of their entries. Where the
numbers come from:

    READ         compared number by number with texts that were opened, `TEXTS`: formula, mobility, passive freedoms
    EXPECTED     lambda, nu, zeta written down from memory of the field; the publications that it names were not opened
    lambda, nu   of all: `counted_again` from the joint screws, by twists of the bodies instead of loops, in doubles
    lambda, nu   of those in `WRENCHES`: worked by hand, `by_hand`; of those in `HAND`: bodies, joints, freedoms and
                 mobility counted by hand, and from them nu
    zeta, group  recalled, but for rssr, delta_4s and 3-SRS, whose passive freedoms were read; zeta is 0 but for bars
                 that spin between two balls, and a link with two coaxial hinges

Of G. Gogu, Mech. Mach. Theory 40 (2005), and Z. Huang, Q. Li, H. Ding (2013), ch. 3, the first page alone could be
read, which has no numbers: nothing here is a comparison with their tables.

`WRENCHES` has the constraints of every limb as a person types them from a drawing, forces through a point and couples;
`by_hand` counts with these as Huang, Li, Ding (2013) do:

    lambda = those common to all limbs,  nu = sum of all - their rank - lambda (limbs - 1)

and Gogu's (2008) connectivities S_Gi = 6 - constraints of a limb, S_F = 6 - rank, r = sum S_Gi - S_F.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np
import pytest
from support.analysed import analysed
from support.further_mechanisms import CASES, loop
from support.marks import slow
from support.parallel_mechanisms import LIMBS, THIRDS, four_ruu, of_limbs, turned
from support.reference_mechanisms import ENTRIES, build
from sympy import Rational

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.mobility import Mobility, analyse_mobility, mobility_text, mobility_values, verify
from symscrew.mobility.field_counts import FieldCounts
from symscrew.mobility.finite import passive_freedoms
from symscrew.mobility.joint_network import Network, network_of

OWN = ("negative control", "textbook", "constructed for this zoo")
"""Entries of `data/mobility.json` without a publication."""
PLANAR, SPHERE = "d = 3, planar: Kutzbach 1929; Hunt 1978, ch. 2", "d = 3, spherical: Hunt 1978, ch. 2"
SAME = 1e-9  # singular value of screws in sizes of the mechanism: those that are zero have 1e-15
EXPECTED = {
    "planar_4bar": (3, 0, 0, "G", PLANAR), "parallelogram": (3, 0, 0, "G", PLANAR),
    "slider_crank": (3, 0, 0, "G", PLANAR), "planar_5bar": (3, 0, 0, "G", PLANAR),
    "andrews_7body": (3, 0, 0, "G", PLANAR), "planar_3rrr": (3, 0, 0, "G", PLANAR),
    "oldham": (3, 0, 0, "G", PLANAR), "dixon": (3, 1, 0, "G", PLANAR + "; a bar too many: Dixon 1899"),
    "peaucellier": (3, 0, 0, "G", PLANAR), "cardan circles": (3, 1, 0, "G", PLANAR + "; the crank is one too many"),
    "threebar_parallel_equal": (3, 1, 0, "G", PLANAR + "; the third crank is one too many"),
    "four parallel bars": (3, 2, 0, "G", PLANAR + "; two cranks are too many"),
    "spherical_4r": (3, 0, 0, "S", SPHERE), "agile_eye": (3, 0, 0, "S", SPHERE),
    "bennett": (3, 0, 0, "D", "d = 3: Huang, Li, Ding 2013, ch. 3; Hunt 1978"),
    "goldberg_5r": (2, 0, 0, "D", "d = 4: Huang, Li, Ding 2013, ch. 3"),
    "sarrus": (1, 0, 0, "D", "d = 5: Huang, Li, Ding 2013, ch. 3; Hunt 1978"),
    "bricard_box": (1, 0, 0, "D", "d = 5: Huang, Li, Ding 2013, ch. 3"),
    "bricard line-symmetric": (1, 0, 0, "D", "d = 5: Baker 1997"),
    "bricard plane-symmetric": (1, 0, 0, "D", "d = 5: Phillips 1990"),
    "schatz_turbula": (1, 0, 0, "D", "d = 5: Phillips 1990, vol. 2"),
    "waldron hybrid": (1, 0, 0, "D", "d = 5: Waldron 1968"), "double_hooke": (1, 0, 0, "D", "d = 5: Baker 2002"),
    "delassus_4h": (3, 0, 0, "Y", "d = 3: Waldron 1979"), "4P": (3, 0, 0, "T3", "d = 3: Herve 1978"),
    "general_7r": (0, 0, 0, "D", "d = 6: Hunt 1978"), "RCCC": (0, 0, 0, "D", "d = 6: Hunt 1978"),
    "rssr": (0, 0, 1, "D", "d = 6, the coupler spins: Hunt 1978"),
    "stewart_6ups": (0, 0, 0, "D", "d = 6: Merlet 2006"),
    "stewart_6sps": (0, 0, 6, "D", "d = 6, six legs spin: Gogu 2005; Merlet 2006"),
    "delta_4s": (0, 0, 6, "D", "d = 6, six bars spin: Merlet 2006"),
    "tripteron_cpm": (0, 3, 0, "D", "nu = 3: Huang, Li, Ding 2013; N = 3: Gogu 2008"),
    "3upu_tsai": (0, 0, 0, "D", "Huang, Li, Ding 2013"), "3rps": (0, 0, 0, "D", "Huang, Li, Ding 2013"),
    "3-PRS": (0, 0, 0, "D", "Carretero et al. 2000"), "tricept": (0, 0, 0, "D", "Siciliano 1999; Gogu 2008"),
    "4-RUU": (0, 2, 0, "D", "nu = 2: Huang, Li, Ding 2013, of the 4-URU"),
    "3-CRR": (0, 3, 0, "D", "nu = 3: Kong, Gosselin 2007"), "3-RRC": (1, 1, 0, "D", "Zhao, Huang 2000"),
    "quadrupteron": (0, 2, 0, "D", "nu = 2: Richard, Gosselin, Kong 2007"),
    "schoenflies": (2, 0, 1, "X", "Herve 1978; one link has both its hinges about one line"),
    "three-limb sarrus": (1, 2, 0, "D", "Sarrus 1853"),
}  # fmt: skip
"""Mechanism -> (lambda, nu, zeta, group of a loop, why, with who is recalled to have treated it, not opened)."""
TEXTS = {
    "handbook": "Mechanism Theory, A Working Reference (handbook of KREAMET, public, 2026), 5.1 to 5.6",
    "textbook": "programs of a public textbook of robotics, section 11.2, program 11.2.1 (in Chinese, 2026)",
    "notes": "J. Smith, Degrees of Freedom (robotics notes, 2025), Worked Example and Over-Constrained Mechanisms",
    "exercise": "Gloogger, Modern Robotics Notes, exercise 2.7 (a); MENG 5930 quiz 2 (2023), question 2: answer 9",
    "article": "S. Y. Liu, Y. Chen, Mech. Mach. Theory 44 (2009) 1950-1963, section 1: seven links for mobility one",
    "readme": "sarrus/readme of shift-models: instantaneous mobility one",
}
"""Texts that were opened for the numbers of `READ`, by the names used there."""
READ: dict[str, list[tuple[str, dict[str, int]]]] = {
    "planar_4bar": [("handbook", {"planar": 1}), ("textbook", {"planar": 1, "spatial": -2, "M": 1}),
                    ("notes", {"spatial": -2})],
    "slider_crank": [("textbook", {"planar": 1, "M": 1})],
    "planar_5bar": [("handbook", {"M": 2}), ("textbook", {"planar": 2, "M": 2})],
    "andrews_7body": [("handbook", {"n": 8, "g": 10, "planar": 1})],
    "threebar_parallel_equal": [("handbook", {"planar": 0}), ("textbook", {"planar": 0, "M": 1})],
    "bennett": [("handbook", {"spatial": -2, "M": 1}), ("textbook", {"spatial": -2, "M": 1, "r": 3}),
                ("notes", {"spatial": -2, "M": 1})],
    "sarrus": [("readme", {"M": 1})],
    "rssr": [("handbook", {"n": 4, "spatial": 2, "zeta": 1, "modified": 1})],
    "general_7r": [("article", {"n": 7, "spatial": 1})],
    "stewart_6ups": [("textbook", {"spatial": 6, "M": 6}), ("notes", {"n": 14, "g": 18, "f": 36, "spatial": 6})],
    "delta_4s": [("textbook", {"n": 11, "g": 15, "f": 39, "spatial": 9, "M": 9, "zeta": 6, "S_F": 3})],
    "panda_7r": [("notes", {"n": 8, "g": 7, "spatial": 7, "M": 7})],
    "serial_6r_wrist": [("textbook", {"spatial": 6, "M": 6}), ("notes", {"n": 7, "g": 6, "spatial": 6})],
    "3-SRS": [("exercise", {"n": 8, "g": 9, "f": 21, "spatial": 9})],
}  # fmt: skip
"""Mechanism -> (text, numbers as it states them). `planar` is 3 (n - g - 1) + f, `spatial` with 6 for 3."""
HAND = {
    "peaucellier": (8, 10, 10, 1), "goldberg_5r": (5, 5, 5, 1),
    "bricard_box": (6, 6, 6, 1), "RCCC": (4, 4, 7, 1), "delassus_4h": (4, 4, 4, 1), "rssr": (4, 4, 8, 2),
    "stewart_6sps": (14, 18, 42, 12), "delta_4s": (11, 15, 39, 9), "3-RRC": (8, 9, 12, 3),
    "three-limb sarrus": (8, 9, 9, 1),
}  # fmt: skip
"""Ten taken at random and counted by hand: n bodies with the ground, g joints, f freedoms, M that move."""
QUICK = ("planar_4bar", "bennett", "sarrus", "rssr", "dixon", "tripteron_cpm", "3rps")
"""Analysed in every run: lambda 3, 1 and 0, a passive freedom, redundant constraints in the plane and in space, a
platform with none. `counted_again` is quick and has all."""
X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
Vector = tuple[float, float, float]
Wrench = tuple[Vector, Vector | None]


def force(along: Vector, through: Vector = (0.0, 0.0, 0.0)) -> Wrench:
    return along, through


def couple(about: Vector) -> Wrench:
    return about, None


def third(k: int, radial: float, tangential: float, height: float) -> Vector:
    """A vector at the k-th corner of a triangle: outwards, around, up."""
    c, s = np.cos(2 * np.pi * k / 3), np.sin(2 * np.pi * k / 3)
    return (float(radial * c - tangential * s), float(radial * s + tangential * c), height)


def planar(*more: Wrench) -> list[Wrench]:
    """Constraints of a limb that moves in the plane across z."""
    return [force(Z), couple(X), couple(Y), *more]


def across(axis: Vector) -> list[Wrench]:
    """Constraints of a limb of hinges and slides about and along one axis: couples across it."""
    a = np.array(axis)
    one = np.cross(a, np.eye(3)[np.abs(a).argmin()])
    return [couple(tuple(one)), couple(tuple(np.cross(a, one)))]


ROUND = [force(d) for d in (X, Y, Z)]
"""Constraints of a limb whose axes meet in O."""
WRENCHES: dict[str, list[list[Wrench]]] = {
    "planar_3rrr": [planar()] * 3,
    "agile_eye": [ROUND] * 3,
    "threebar_parallel_equal": [planar(force(Y, (x, 0.0, 0.0))) for x in (0.0, 1.0, 3.0)],
    "four parallel bars": [planar(force(Y, (x, 0.0, 0.0))) for x in (0.0, 1.0, 3.0, 4.0)],
    "sarrus": [[force(d), *across(d)] for d in (X, Y)],
    "three-limb sarrus": [[force(third(k, 0, 1, 0)), *across(third(k, 0, 1, 0))] for k in range(3)],
    "tripteron_cpm": [across(d) for d in (X, Y, Z)],
    "3-CRR": [across(d) for d in (X, Y, Z)],
    "3-RRC": [across(third(k, 0, 1, 0)) for k in range(3)],
    "3upu_tsai": [[couple(third(k, 0.6, 0, -0.8))] for k in range(3)],
    "3rps": [[force(third(k, 0, 1, 0), third(k, 1, 0, 2))] for k in range(3)],
    "3-PRS": [[force(Y, (2.0, 0.0, 4.0))], [force(X, (0.0, 2.0, 4.0))], [force(Y, (-2.0, 0.0, 4.0))]],
    "stewart_6ups": [[]] * 6,
    "tricept": [[], [], [], [force(X), force(Y), couple(Z)]],
    "4-RUU": [[couple((0.6, 0.8, 0.0))], [couple((-0.8, 0.6, 0.0))]] * 2,
    "quadrupteron": [[couple(X)], [couple(Y)], [couple(X)], [couple(Y)]],
    "schoenflies": [across(Z)] * 3,
}


def by_hand(limbs: Sequence[Sequence[Wrench]]) -> tuple[int, int, list[int], int]:
    """(lambda, nu, connectivities of the limbs, of the platform) from typed constraints."""
    systems = []
    for limb in limbs:
        rows = [[*([0] * 3), *d] if p is None else [*d, *np.cross(p, d)] for d, p in limb]
        systems.append(np.array(rows, dtype=float).reshape(-1, 6))
    rank = int(np.linalg.matrix_rank(np.concatenate(systems)))
    # what is common to all lies across whatever is across one of them
    outside = [np.linalg.svd(s)[2][np.linalg.matrix_rank(s) :] if len(s) else np.eye(6) for s in systems]
    common = 6 - int(np.linalg.matrix_rank(np.concatenate(outside)))
    nu = sum(map(len, systems)) - rank - common * (len(systems) - 1)
    return common, nu, [6 - len(s) for s in systems], 6 - rank


def counted_again(network: Network) -> tuple[int, int]:
    """(lambda, nu) from twists of the bodies: what every joint forbids its two bodies, and the rank of all that."""
    bodies = [body for body in network.bodies if body != network.ground]
    everything, rows = [], []
    for edge in network.edges.values():
        screws = np.array([[float(c) for c in screw] for screw in edge.screws])
        everything.append(screws)
        for forbidden in np.linalg.svd(screws)[2][len(screws) :]:
            row = np.zeros((len(bodies), 6))
            for body, sign in ((edge.child, 1), (edge.parent, -1)):
                if body != network.ground:
                    row[bodies.index(body)] += sign * forbidden
            rows.append(row.ravel())
    common = 6 - int(np.linalg.matrix_rank(np.concatenate(everything), tol=SAME))
    too_many = len(rows) - int(np.linalg.matrix_rank(np.array(rows), tol=SAME))
    return common, too_many - common * (len(network.edges) - len(bodies))


def three_srs() -> Mechanism:
    """Three arms of ball, hinge and ball that hold one plate."""
    builder = MechanismBuilder("three_srs", platform="plate").body("plate")
    for k, place in enumerate(THIRDS):
        builder.body(f"upper{k}").body(f"fore{k}")
        foot, elbow, wrist = (turned(p, place) for p in ([5, 0, 0], [6, 1, 3], [2, 0, 4]))
        builder.joint(f"S{k}", "S", parent="base", child=f"upper{k}", point=foot)
        builder.joint(f"R{k}", "R", parent=f"upper{k}", child=f"fore{k}", point=elbow, axes=[turned([0, 1, 0], place)])
        builder.joint(f"T{k}", "S", parent=f"fore{k}", child="plate", point=wrist)
        builder.limb(f"arm{k}", joints=[f"S{k}", f"R{k}", f"T{k}"])
    return builder.build()


MADE: dict[str, Callable[[], Mechanism]] = {
    "4-RUU": four_ruu, "3-SRS": three_srs, **{name: (lambda name=name: of_limbs(name)) for name in LIMBS},
}  # fmt: skip


def mechanism(name: str) -> Mechanism:
    return MADE[name]() if name in MADE else build(ENTRIES[name]) if name in ENTRIES else CASES[name].make()


@cache
def found(name: str) -> Mobility:
    return analyse_mobility(mechanism(name)) if name in MADE else analysed(name)


def counts_of(name: str) -> FieldCounts:
    return found(name).counts


def sourced() -> list[str]:
    """Entries that name a publication."""
    return [
        name for name, entry in ENTRIES.items() if "source" in entry and not str(entry["source"][0]).startswith(OWN)
    ]


def test_there_are_more_than_thirty_with_a_source() -> None:
    assert len({name.partition("-")[0] for name in sourced()}) >= 30


@pytest.mark.parametrize("name", [name if name in QUICK else slow(name) for name in sourced()])
def test_formulas_of_the_field_give_the_mobility_of_the_entry(name: str) -> None:
    counts, expected = counts_of(name), ENTRIES[name]["expected"]
    assert (counts.kutzbach, counts.mobility) == (expected["kutzbach"], expected["dof"])
    assert counts.modified == expected["dof"] - counts.isolated
    assert (counts.overconstraint, counts.redundancy) == (expected["overconstraints"], expected["internal_freedoms"])
    assert counts.by_limbs in (None, counts.redundant)
    assert counts.platform == expected["platform"]["dof"]  # connectivity S_F


@pytest.mark.parametrize("name", READ)
def test_counts_are_those_of_the_texts_that_were_read(name: str) -> None:
    c = counts_of(name)
    ours = {"n": c.links, "g": c.joints, "f": c.freedoms, "M": c.mobility, "r": c.rank, "zeta": c.isolated,
            "planar": 3 * (c.links - c.joints - 1) + c.freedoms, "spatial": c.kutzbach, "modified": c.modified,
            "S_F": c.platform}  # fmt: skip
    for text, stated in READ[name]:
        assert text in TEXTS and stated == {what: ours[what] for what in stated}


@pytest.mark.parametrize("name", HAND)
def test_counts_by_hand_leave_the_redundant_constraints(name: str) -> None:
    network = network_of(mechanism(name))
    n, g, f, mobility = HAND[name]
    assert (len(network.bodies), len(network.edges), network.freedoms) == (n, g, f)
    common, redundant = EXPECTED[name][:2]
    assert redundant == mobility - f - (6 - common) * (n - g - 1)


@pytest.mark.parametrize("name", EXPECTED)
def test_what_was_recalled_is_what_other_code_counts(name: str) -> None:
    assert counted_again(network_of(mechanism(name))) == EXPECTED[name][:2]


@pytest.mark.parametrize("name", WRENCHES)
def test_what_was_recalled_is_what_a_hand_works_out(name: str) -> None:
    common, nu, _, _ = by_hand(WRENCHES[name])
    assert (common, nu) == EXPECTED[name][:2]


@pytest.mark.parametrize("name", [name if name in QUICK else slow(name) for name in EXPECTED])
def test_common_redundant_and_passive_are_the_expected_ones(name: str) -> None:
    counts = counts_of(name)
    common, redundant, isolated, group, _ = EXPECTED[name]
    assert (counts.common, counts.redundant, counts.isolated) == (common, redundant, isolated)
    assert all(loop.group.startswith(group) for loop in counts.loops)
    assert counts.by_limbs in (None, counts.redundant)
    loops, freedoms = counts.joints - counts.links + 1, counts.freedoms
    assert counts.mobility == freedoms - (6 - common) * loops + redundant
    if name in WRENCHES:
        _, _, limbs, platform = by_hand(WRENCHES[name])
        if counts.limbs:
            assert [limb.connectivity for limb in counts.limbs] == limbs
            assert counts.rank == sum(limbs) - platform and counts.overconstraint == 6 * loops - counts.rank
            assert counts.platform == platform


SLANT = [Rational(3, 5), 0, Rational(4, 5)]
ALONE: dict[str, tuple[int, list[tuple[str, list[Any], list[Any] | None]]]] = {
    "hinges about one line": (1, [("R", [0, 0, 0], [0, 0, 1]), ("R", [1, 0, 0], [0, 0, 1]), ("R", [3, 2, 0], [0, 0, 1]),
                                  ("R", [3, 2, 1], [0, 0, 1]), ("R", [4, 0, 0], [0, 0, 1])]),
    "a hinge through a ball, a rod": (2, [("R", [0, 0, 0], [0, 1, 0]), ("R", [1, 0, 0], SLANT), ("S", [4, 0, 4], None),
                                          ("S", [5, 3, 1], None), ("R", [5, 0, 0], [0, 1, 0])]),
    "a rod with a swivel": (2, [("R", [0, 0, 0], [0, 1, 0]), ("S", [1, 0, 0], None), ("R", [4, 0, 4], SLANT),
                                ("S", [7, 0, 8], None), ("R", [5, 0, 0], [0, 1, 0])]),
    "a rod with a knee": (1, [("R", [0, 0, 0], [0, 1, 0]), ("S", [1, 0, 0], None), ("R", [4, 0, 4], [0, 1, 0]),
                              ("S", [7, 0, 8], None), ("R", [5, 0, 0], [0, 1, 0])]),
    "a cylinder through a ball": (1, [("R", [0, 0, 0], [0, 1, 0]), ("C", [1, 0, 0], SLANT), ("S", [4, 0, 4], None),
                                      ("R", [5, 0, 0], [1, 0, 0])]),
}  # fmt: skip


@pytest.mark.parametrize("name", ALONE)
def test_links_that_move_alone_are_passive_whatever_their_joints_are(name: str) -> None:
    """Two joints of one link that have a motion in common leave it to the link: counted by hand."""
    passive, joints = ALONE[name]
    network = network_of(loop(*joints))
    assert passive_freedoms(network) == passive


def test_counts_stand_in_the_report_and_in_the_json() -> None:
    tripteron = found("tripteron_cpm")
    text, values = mobility_text(tripteron), mobility_values(tripteron)["counts"]
    assert "nu = 3 redundant" in text and "Connectivity of the limbs S_Gi" in text
    assert (values["nu"], values["lambda"], values["M"], values["modified_kutzbach"]) == (3, 0, 3, 3)
    assert [limb["S_G"] for limb in values["limbs"]] == [4, 4, 4]


@pytest.mark.parametrize("name", ["3rps", slow("tripteron_cpm")])
def test_a_wrong_count_of_the_limbs_is_found(name: str) -> None:
    made = analyse_mobility(mechanism(name))
    claim = "redundant constraints by limbs as by loops"
    assert [check.holds for check in verify(made) if check.claim == claim] == [True]
    object.__setattr__(made.counts, "by_limbs", 2)
    assert [check.claim for check in verify(made) if not check.holds] == [claim]
