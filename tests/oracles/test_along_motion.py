"""Along the motion: singular poses against the geometry of linkages, and what holds on the whole branch."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.analysed import analysed, of_catalogue
from support.limb_platforms import platform as limb_platform
from support.marks import slow
from support.reference_mechanisms import ENTRIES, build

from symscrew.cli.parser import main
from symscrew.mobility import Mobility, WholeMotion, analyse_mobility, motion_lines, motion_values
from symscrew.mobility.finite import ClosureVariety, local_at
from symscrew.mobility.motions import coordinate_lines, singular_poses, whole_motion
from symscrew.mobility.motions.coordinate_lines import (
    Setting,
    independent_columns,
    pose_at,
    the_other_way_round,
    track,
    tracks,
)
from symscrew.mobility.motions.germs import germs_at
from symscrew.mobility.motions.held_spins import HeldSpins
from symscrew.mobility.screw_classes import class_of_motions

pytestmark = pytest.mark.slow


def found(name: str) -> Mobility:
    return analysed(name) if name in ENTRIES else of_catalogue(name)


def along(name: str) -> WholeMotion:
    result = found(name).along
    assert isinstance(result, WholeMotion)
    return result


def places(name: str, q: np.ndarray) -> dict[str, np.ndarray]:
    """Where the joints are, in units of the mechanism, by the displacements of the bodies that carry them."""
    network = found(name).network
    variety = ClosureVariety(network)
    poses = variety.forward(q[None])[1]
    centre = np.array([float(c) for c in variety.centre])
    result = {}
    for edge in network.edges.values():
        rotation, translation = (part[0] for part in poses[edge.parent])
        result[edge.name] = rotation @ (np.array([float(c) for c in edge.point]) - centre) + translation
    return result


def in_line(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> bool:
    return float(np.linalg.norm(np.cross(b - a, c - b))) < 1e-6


def test_dead_points_of_a_four_bar() -> None:
    """The rocker rests where crank and coupler are in line, once stretched and once folded."""
    poses = along("four_bar").singular
    assert [pose.kinds for pose in poses] == [("platform",)] * 2
    reaches = []
    for pose in poses:
        at = places("four_bar", pose.q)
        assert in_line(at["A"], at["B"], at["C"])
        reaches.append(np.linalg.norm(at["C"] - at["A"]))
    crank, coupler = (np.linalg.norm(at[x] - at[y]) for x, y in ("AB", "BC"))
    assert sorted(reaches) == pytest.approx([abs(coupler - crank), coupler + crank])


def test_what_is_lost_at_once_is_lost_at_one_pose() -> None:
    """Of the seed's limb4 the first two freedoms, the drives' hold and a freedom of the platform, at one pose."""
    poses = [pose for pose in along("three_ups_upu_s").singular if "limb4" in pose.kinds]
    assert poses and all({"drives", "platform", "limb4"} <= set(pose.kinds) for pose in poses)
    every = along("three_ups_upu_s").singular
    assert {pose.locked for pose in every if "closure" in pose.kinds} == {1}  # four drives hold two of three freedoms
    assert all(np.linalg.norm(a.q - b.q) > 1e-3 for a in every for b in every if a.column == b.column and a is not b)


def test_equal_limbs_have_their_singular_poses_in_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    main(["mobility", "planar_3rrr", "--along", "--full"])
    text = capsys.readouterr().out
    assert "at limb1_R1, limb2_R1, limb3_R1 = 1.3136 rad (75.26 deg), each alone: platform has fewer freedoms; " in text
    assert "each alone, past an end of its range: platform has" in text and "screws of its limb become" in text
    assert "more singular poses" not in text and "Joints are those of limb1; likewise the others with their own" in text


def test_a_parallelogram_has_two_change_points() -> None:
    poses = along("parallelogram").singular
    assert len(poses) == 2
    for pose in poses:
        at = places("parallelogram", pose.q)
        assert in_line(at["J1"], at["J2"], at["J3"]) and in_line(at["J2"], at["J3"], at["J4"])
        assert pose.kinds == ("closure",) and pose.instantaneous == 2 and pose.branches == (1, 1)


@pytest.mark.slow
def test_a_slider_ends_where_crank_and_rod_are_in_line() -> None:
    poses = along("slider_crank").singular
    assert len(poses) == 2 and all({"coordinate", "platform"} <= set(pose.kinds) for pose in poses)
    for pose in poses:
        at = places("slider_crank", pose.q)
        assert in_line(at["J1"], at["J2"], at["J3"])


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(n, marks=pytest.mark.slow) if n == "slider_crank" else n
        for n in ("four_bar", "parallelogram", "slider_crank")
    ],
)
def test_singular_poses_close_and_lose_what_they_say(name: str) -> None:
    variety = ClosureVariety(found(name).network)
    for pose in along(name).singular:
        residuals, jacobians = variety.evaluate(pose.q[None])
        assert np.abs(residuals).max() < 1e-9
        rank = variety.columns - found(name).dof
        lost = np.linalg.svd(jacobians[0], compute_uv=False)[rank - 1] < 1e-6
        assert lost == ("closure" in pose.kinds)


@pytest.mark.slow
def test_what_holds_on_the_whole_branch() -> None:
    rocker = along("four_bar")
    assert [c.type for c in rocker.classes] == ["1R"] and rocker.constant and not rocker.idle
    assert rocker.axes == {"about the axis of D": "D joins rocker to base and has no other freedom"}
    bennett = along("bennett")
    assert not bennett.constant and bennett.singular == ()  # no special pose: Bennett's linkage turns all round
    folded = along("kinematotropic_double_fold-mode2")
    assert folded.idle == ("J1", "J4", "J5") and folded.classes[0].type == "0"


def test_of_many_freedoms_branches_are_not_looked_for_and_it_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    one = analyse_mobility(build(ENTRIES["parallelogram"]))
    monkeypatch.setattr(singular_poses, "MOST_FREEDOMS", 1)
    monkeypatch.setattr(singular_poses, "germs_at", lambda *_: pytest.fail("branches were looked for"))
    assert not isinstance(one.along, str) and [pose.branches for pose in one.along.singular] == [(), ()]
    assert all(pose.untried and pose.instantaneous == 2 for pose in one.along.singular)
    lines = motion_lines(one.along, one.network, one.mechanism, "coup")
    assert sum("its branches were not looked for" in line for line in lines) == 2


@pytest.mark.slow
def test_in_words_json_and_by_command(capsys: pytest.CaptureFixture[str]) -> None:
    one = found("parallelogram")
    values = motion_values(along("parallelogram"), one.network, one.mechanism)
    assert [pose["branches"] for pose in values["singular_poses"]] == [[1, 1], [1, 1]]
    assert values["judgement"] == "sampled"
    lines = motion_lines(along("parallelogram"), one.network, one.mechanism, "coup")
    assert any("branches of dimension 1, 1 meet" in line for line in lines)
    assert isinstance(found("parallelogram-change_point").along, str)
    assert main(["mobility", "four_bar", "--along"]) == 0
    assert "the axis of D all along (proved" in capsys.readouterr().out


@pytest.mark.slow
def test_a_sarrus_linkage_folds_at_four_poses() -> None:
    """Legs stretched twice and folded twice in a turn: there both limbs lose a screw, and branches meet."""
    poses = along("sarrus").singular
    assert len(poses) == 4 and all("closure" in pose.kinds for pose in poses)
    assert sorted(len(pose.branches) for pose in poses) == [2, 2, 2, 2]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["sarrus", "parallelogram"])
def test_branches_do_not_hang_on_the_last_digits_of_a_pose(name: str) -> None:
    """Zeros that were followed inwards to rounding were lost where this was more than usual: one branch for two."""
    variety = ClosureVariety(found(name).network)
    random = np.random.default_rng(5)
    poses = [pose for pose in along(name).singular if pose.branches]
    assert poses
    for pose in poses[:2]:
        for _ in range(2):
            q = pose.q + 4e-16 * random.normal(size=pose.q.shape)
            here = local_at(variety, q, rank=variety.columns - pose.instantaneous)
            dimensions = {d: d for d in range(1, pose.instantaneous)}
            there = sorted((germ.dimension for germ in germs_at(variety, here, dimensions)), reverse=True)
            assert tuple(there) == pose.branches


@pytest.mark.parametrize(
    ("name", "type_", "order"),
    [
        ("four_bar", "1R", 1),  # the rocker
        slow("planar_4bar", "1R2T", 3),  # a coupler in the plane: one freedom, three in its group
        slow("sarrus", "1T", 1),  # P. T. Sarrus, C. R. Acad. Sci. Paris 36 (1853) 1036
        slow("agile_eye", "3R", 3),
    ],
)
def test_groups_of_motion_are_those_of_the_literature(name: str, type_: str, order: int) -> None:
    """Proved of the whole branch: the class of the motion where it has all freedoms of the group, else the group."""
    motion = along(name)
    assert motion.group is not None and (motion.group.system.type, motion.group.system.order) == (type_, order)
    filled = motion.classes[0].order == order
    assert bool(motion.type_proof) == filled
    lines = motion_lines(motion, found(name).network, found(name).mechanism, found(name).platform.body)
    assert any(("of the branch (proved" if filled else "stays in a group of displacements") in line for line in lines)


@pytest.mark.slow
def test_axes_at_the_ground_are_proved_where_the_group_has_them() -> None:
    """Agile eye: the hinges on the ground are in the spherical group; those that are carried along were only seen."""
    proved = {axis[-2:]: bool(why) for axis, why in along("agile_eye").axes.items()}
    assert {name for name, sure in proved.items() if sure} == {"A0", "A1", "A2"} and len(proved) > 3


def test_joints_that_rest_are_proved_by_locking_them() -> None:
    """The transition's second mode: three joints rest, and so does the body, whose twists are rounding alone."""
    name = "kinematotropic_double_fold-mode2"
    motion = along(name)
    assert motion.idle == ("J1", "J4", "J5") and motion.idle_proof
    assert [c.order for c in motion.classes] == [0] and motion.type_proof
    fixed = analyse_mobility(motion.locked(found(name).mechanism), body=found(name).platform.body)
    assert fixed.finite.proved and fixed.finite.dof == found(name).finite.dof
    values = motion_values(motion, found(name).network, found(name).mechanism)
    assert values["idle_proved"] and values["class_proved"] and values["group"]["order"] == 0


def test_a_joint_that_moves_is_not_proved_to_rest() -> None:
    """Were the crank of a four-bar among the joints at rest, locking it would leave nothing to move."""
    wrong = replace(along("four_bar"), idle=("A",))
    assert analyse_mobility(wrong.locked(found("four_bar").mechanism)).finite.dof == 0
    assert not along("four_bar").idle_proof


def test_a_linkage_without_a_group_has_no_proof() -> None:
    """Bennett's: two screws of each chain generate all displacements, and what it does along the motion is sampled."""
    motion = along("bennett")
    assert not motion.type_proof and not motion.idle_proof
    assert motion.group is None or motion.group.system.order == 6


def test_twists_of_a_body_at_rest_have_no_class() -> None:
    """Rounding has a direction, too: a body whose twists are 1e-16 is at rest, one with 1e-3 is not."""
    noise = np.random.default_rng(5).normal(size=(6, 2))
    assert class_of_motions(1e-16 * noise, 1.0).order == 0
    assert class_of_motions(noise * [1e-16, 1e-3], 1.0).order == 1


@pytest.mark.slow
def test_what_a_plane_of_symmetry_keeps_is_not_said_of_all_poses(monkeypatch: pytest.MonkeyPatch) -> None:
    """On its coordinate lines a 3-PRS keeps a principal pitch of zero, beside them it does not."""
    monkeypatch.setattr(whole_motion, "singular_poses", lambda setting, tracks: ())
    monkeypatch.setattr(coordinate_lines, "ENDS", (1.0, 0.8))
    result = analyse_mobility(limb_platform("PRS"))
    motion = result.along
    assert isinstance(motion, WholeMotion) and motion.beside == whole_motion.BESIDE
    assert [c.name for c in motion.classes] == ["IB"] and not motion.constant
    lines = motion_lines(motion, result.network, result.mechanism, "top")
    assert "principal pitches not constant" in lines[1] and " m:" not in lines[1]


def setting_of(name: str) -> Setting:
    network = found(name).network
    variety = HeldSpins(network, "none")
    columns = tuple(c for limb in found(name).limbs[:1] for j in limb.joints for c in network.edges[j].columns)
    limbs = {"limb": (columns, 6)} if columns else {}
    return Setting(network, variety, found(name).dof - len(variety.ends), "none", 0, network.driven, limbs)


def test_a_full_turn_of_a_ball_is_no_singular_pose() -> None:
    """Rotation vectors of a turn are singular coordinates: the pose is taken by others, going the same way."""
    setting = setting_of("stewart_6ups")
    origin = np.zeros(setting.variety.columns)
    ball = next(list(e.columns) for e in setting.network.edges.values() if e.type == "S")
    turned = origin.copy()
    turned[ball] = np.array([2, -1, 2]) / 3 * (2 * np.pi - 1e-3)
    direct, before = (pose_at(setting, q, (), None) for q in (origin, turned))
    after = the_other_way_round(setting, before, ())
    assert before.margins["limb"] < 1e-3 < direct.margins["limb"] * 0.9 < after.margins["limb"]
    assert np.linalg.norm(after.q[ball]) == pytest.approx(1e-3)
    moved = [setting.variety.forward(q[None])[1] for q in (before.q, after.q)]
    for body, (rotation, translation) in moved[0].items():
        assert np.abs(rotation - moved[1][body][0]).max() + np.abs(translation - moved[1][body][1]).max() < 1e-12
    step = 1e-6
    ahead = [
        setting.variety.forward((p.q + step * p.direction / abs(p.direction[0]))[None])[1] for p in (before, after)
    ]
    for body, (rotation, _) in ahead[0].items():
        assert np.abs(rotation - ahead[1][body][0]).max() < 1e-8


@pytest.mark.parametrize("well", [0.0, coordinate_lines.WELL], ids=["singular values", "normal equations"])
def test_lines_side_by_side_are_those_of_each_alone(well: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """And they are the same whether Newton's steps come from singular values or from the normal equations."""
    setting = setting_of("stewart_6ups")
    drives = setting.drives
    signs = zip(drives, (1, -1, -1), strict=False)
    ways = [(moving, tuple(d for d in drives if d != moving), sign) for moving, sign in signs]
    alone = [track(setting, column, held, sign, most=6) for column, held, sign in ways]
    monkeypatch.setattr(coordinate_lines, "WELL", well)
    for one, line in zip(alone, tracks(setting, ways, most=6), strict=True):
        assert (one.column, one.held, one.end, len(one.poses)) == (line.column, line.held, line.end, len(line.poses))
        assert max(np.abs(a.q - b.q).max() for a, b in zip(one.poses, line.poses, strict=True)) < 1e-9
        assert all(abs(a.margins[k] - b.margins[k]) < 1e-8
                   for a, b in zip(one.poses, line.poses, strict=True) for k in a.margins)  # fmt: skip


def test_spins_held_leave_all_other_motions() -> None:
    """Of a rod between two balls: one motion fewer, and what moves is what moved; the drive is a coordinate."""
    setting = setting_of("rssr")
    plain, held = ClosureVariety(found("rssr").network), setting.variety
    q = track(setting, 0, (), 1, most=4).poses[-1].q
    screws = plain.forward(q[None])[0]
    free, stopped = (v.jacobians(screws, q[None])[0] for v in (plain, held))
    assert np.linalg.matrix_rank(stopped) == np.linalg.matrix_rank(free) + 1 == plain.columns - 1
    motions = np.linalg.svd(stopped)[2][-1:].T
    assert np.abs(free @ motions).max() < 1e-9 and held.evaluate(q[None])[0].shape[1] == len(stopped)
    assert independent_columns(setting.network, motions, setting.drives) == setting.drives
    spin = np.linalg.svd(free)[2][-2:].T
    spin = spin @ np.linalg.svd(spin[list(setting.drives)])[2][-1]  # with the crank at rest nothing but the rod moves
    assert np.linalg.norm(spin) == pytest.approx(1) and np.abs(stopped @ spin).max() > 0.1
    assert np.abs(held.places(q + 1e-6 * spin) - held.places(q)).max() < 1e-10
    assert np.abs(held.places(q + 1e-6 * motions[:, 0]) - held.places(q)).max() > 1e-7


def test_a_slide_inside_a_spinning_rod_is_at_no_other_place_for_that() -> None:
    """Its axis goes round with the rod; which pose it is does not change."""
    held = HeldSpins(found("stewart_6sps").network, "none")
    assert len(held.ends) == 6
    rods = [name for name, edge in held.network.edges.items() if edge.type == "P"]
    first = held.network.edges[rods[0]]
    origin = np.zeros(held.columns)
    longer = origin.copy()
    longer[first.start] = 0.1
    assert held.places(origin).shape == (12 * 3,) and np.abs(held.places(longer) - held.places(origin)).max() > 1e-3


def test_the_spin_of_the_body_asked_for_is_one_of_its_freedoms() -> None:
    network = found("rssr").network
    coupler = next(
        b for b in network.bodies if sum(b in (e.parent, e.child) for e in network.edges.values() if e.type == "S") == 2
    )
    assert [len(HeldSpins(network, body).ends) for body in (coupler, network.ground)] == [0, 1]
