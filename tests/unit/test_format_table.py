"""Formats are a table: an invented one is a reader, a writer and a line in a copy of it. Thresholds of the others."""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from sympy import Float, Integer

from symscrew import catalogue
from symscrew.description import Mechanism, MechanismBuilder
from symscrew.errors import DescriptionError
from symscrew.formats import (
    READABLE,
    WRITERS,
    difference,
    file_names,
    from_draft,
    import_file,
    load_format,
    merged_joints,
    mjcf_settings,
    mjcf_writer,
    rigid_displacements,
    round_trip,
    safe_xml,
    text_of,
    urdf_writer,
)
from symscrew.formats.by_suffix import FORMATS, Format, readable, writers
from symscrew.formats.draft import Draft, RawBody, RawJoint
from symscrew.formats.import_options import ImportOptions
from symscrew.formats.rigid_displacements import UNITS, ZERO, from_quaternion, real, triple
from symscrew.formats.safe_xml import Element, attribute, elements


def read_tiny(root: Element, path: Path, options: ImportOptions) -> Draft:
    """<tiny><hinge name="" from="" to="" z=""/></tiny>: revolute joints about z, above each other."""
    result = Draft(attribute(root, "name"), "base", f"imported from the tiny {path.name}")
    for hinge in elements(root, "hinge"):
        child, point = attribute(hinge, "to"), triple([0, 0, Decimal(attribute(hinge, "z"))])
        result.bodies.append(RawBody(child))
        result.joints.append(
            RawJoint(attribute(hinge, "name"), "R", attribute(hinge, "from"), child, point, (UNITS[2],))
        )
    return result


def print_tiny(mechanism: Mechanism) -> str:
    root = ElementTree.Element("tiny", name=mechanism.name)
    for joint in mechanism.joints.values():
        given = {"name": joint.name, "from": joint.parent, "to": joint.child, "z": str(joint.point[2])}
        ElementTree.SubElement(root, "hinge", given)
    return ElementTree.tostring(root, encoding="unicode")


def tower() -> Mechanism:
    builder = MechanismBuilder("tower").body("one").body("two")
    builder.joint("A", "R", parent="base", child="one", point=[0, 0, 1], axes=[[0, 0, 1]])
    builder.joint("B", "R", parent="one", child="two", point=[0, 0, 2], axes=[[0, 0, 1]])
    return builder.build()


def test_a_format_is_a_file_and_a_line(tmp_path: Path) -> None:
    formats = (*FORMATS, Format("tiny", (".tiny", ".xml"), read_tiny, print_tiny))
    assert readable(formats) == (".urdf", ".xml", ".mjcf", ".tiny")
    path = tmp_path / "tower.tiny"
    path.write_text(text_of(tower(), ".tiny", formats=formats))
    again = load_format(path, formats=formats)
    assert difference(tower(), again) is None and again.source == "imported from the tiny tower.tiny"
    with pytest.raises(
        DescriptionError, match=r"expected the root element <robot> or <mujoco>, got 'tiny'|got <'tiny'>"
    ):
        load_format(path)
    with pytest.raises(DescriptionError, match=r"ends in \.urdf, \.xml, \.mjcf, \.toml, got '\.tiny'"):
        text_of(tower(), ".tiny")


def test_a_format_may_be_read_or_written_only() -> None:
    only_read, only_written = Format("in", (".in",), read=read_tiny), Format("out", (".out",), write=print_tiny)
    assert readable((only_read, only_written)) == (".in",)
    assert list(writers((only_read, only_written))) == [".out", ".toml"]


def test_what_others_ask_of_the_table() -> None:
    assert READABLE == (".urdf", ".xml", ".mjcf") and list(WRITERS) == [".urdf", ".xml", ".mjcf", ".toml"]


# -- thresholds --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("off, type_", [("1e-13", "U"), ("1e-11", None)])
def test_axes_that_meet_to_rounding_are_one_universal_joint(off: str, type_: str | None) -> None:
    first = RawJoint("h.0", "R", "base", "mid", ZERO, (UNITS[0],))
    second = RawJoint("h.1", "R", "mid", "tip", triple([0, 0, off]), (UNITS[1],))
    found = merged_joints.one_joint([first, second], "h")
    assert (found.type if found else None) == type_


@pytest.mark.parametrize("size, point", [("9e-16", True), ("1.1e-15", False)])
def test_an_inertia_of_rounding_is_that_of_a_point(size: str, point: bool) -> None:
    matrix = tuple(tuple(real(size) * e for e in row) for row in UNITS)
    assert (from_draft._without_rounding(real(1), matrix) == (ZERO, ZERO, ZERO)) == point  # type: ignore[arg-type]


@pytest.mark.parametrize("angle, snapped", [("1.570796326794897", True), ("1.57079632679", False)])
def test_a_right_angle_of_fifteen_digits_is_one(angle: str, snapped: bool) -> None:
    assert (rigid_displacements.about(UNITS[2], real(angle))[0][0] == 0) == snapped


def test_what_is_too_small_to_be_a_number_of_a_file() -> None:
    assert rigid_displacements.exact(real("1e-23")) == 0 != rigid_displacements.exact(real("1e-21"))
    matrix = rigid_displacements.exact_matrix(
        (triple([1, "1e-21", 0]), triple(["1e-21", 1, "1e-19"]), triple([0, "1e-19", 1]))
    )
    assert matrix[0][1] == 0 != matrix[1][2]
    assert len(rigid_displacements.exact(real(1) / 3).as_tuple().digits) == rigid_displacements.DIGITS


def test_what_is_too_short_to_be_a_direction_or_a_turn() -> None:
    assert rigid_displacements.unit(triple(["1.1e-12", 0, 0]), "axis") == UNITS[0]
    with pytest.raises(DescriptionError, match="expected a direction"):
        rigid_displacements.unit(triple(["0.9e-12", 0, 0]), "axis")
    assert from_quaternion([real("1.1e-10"), 0, 0, 0], "quat") == UNITS
    with pytest.raises(DescriptionError, match="of length zero"):
        from_quaternion([real("0.9e-10"), 0, 0, 0], "quat")


def test_a_direction_that_is_already_there_needs_no_turn() -> None:
    assert mjcf_settings.turn_to(triple(["1e-21", 0, 1]), "z") is UNITS
    assert mjcf_settings.turn_to(triple(["1e-13", 0, 1]), "z")[0][2] > 0


def test_long_names_are_cut_off() -> None:
    assert len(file_names.safe_names(["x" * 59 + "-"])["x" * 59 + "-"]) == file_names.LONGEST
    long = ["y" * 70, "y" * 60]
    found = file_names.safe_names(long)
    assert found["y" * 60] == "y" * 60 and found["y" * 70] == "y" * file_names.NUMBERED + "_2"


@pytest.mark.parametrize("name, text", [("MAX_BYTES", "bytes; at most 3 are read"), ("MAX_DEPTH", "nested at most 3"),
                                        ("MAX_ELEMENTS", "at most 3 elements")])  # fmt: skip
def test_files_beyond_a_size_are_refused(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, name: str, text: str) -> None:
    path = tmp_path / "deep.xml"
    path.write_text("<a><b><c><d/></c></b></a>")
    assert safe_xml.read(path).tag == "a"
    monkeypatch.setattr(safe_xml, name, 3)
    with pytest.raises(DescriptionError, match=text):
        safe_xml.read(path)


@pytest.mark.parametrize(
    "place, said",
    [
        ("1 0 1e-10", ""),
        ("1 0 1e-7", "open by 1.0e-7 m"),
        ("1 0 1e-5", "joints moved from the file's pose to where its loops close [rad, m]: ja"),
        ("1.00001 0 0", None),
    ],
)
def test_loops_of_a_file_close_or_are_refused(tmp_path: Path, place: str, said: str | None) -> None:
    """What rounding explains is closed at the middle, what joints close by these; two lengths are not one."""
    path = tmp_path / "loop.xml"
    inertial = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    body = '<body name="{0}"><joint name="j{0}" axis="0 1 0"/>' + inertial + "{1}</body>"
    path.write_text(
        '<mujoco><compiler angle="radian"/><worldbody>'
        + body.format("a", '<site name="s" pos="1 0 0"/>') + body.format("b", f'<site name="t" pos="{place}"/>')
        + '</worldbody><equality><connect site1="s" site2="t"/></equality></mujoco>'
    )  # fmt: skip
    if said is not None:
        found = import_file(path)
        assert len(found.mechanism.joints) == 3 and said in "; ".join(found.account.changed)
    else:
        with pytest.raises(DescriptionError, match="the loop does not close"):
            load_format(path)


def test_bodies_that_mujoco_refuses_are_raised_and_named(monkeypatch: pytest.MonkeyPatch) -> None:
    assert "Masses or moments raised to 1e-09 of the whole" in text_of(tower(), ".xml")
    unit = tuple(tuple(Integer(i == j) for j in range(3)) for i in range(3))
    com = (Integer(0),) * 3
    bodies = {n: replace(body, mass=Integer(1), com=com, inertia=unit) for n, body in tower().bodies.items()}
    heavy = replace(tower(), bodies=bodies)
    assert "raised" not in text_of(heavy, ".xml")
    monkeypatch.setattr(mjcf_writer, "SMALL", 10.0)
    assert "raised to 10 of the whole" in text_of(heavy, ".xml")


@pytest.mark.parametrize("shortest, capsules", [(1e-3, True), (100.0, False)])
def test_capsules_are_drawn_where_they_have_a_length(
    monkeypatch: pytest.MonkeyPatch, shortest: float, capsules: bool
) -> None:
    monkeypatch.setattr(mjcf_writer, "SHORTEST_CAPSULE", shortest)
    assert ("capsule" in text_of(catalogue.load("four_bar"), ".xml")) == capsules


@pytest.mark.parametrize("angle", [np.pi / 2, np.pi / 2 - 1e-9, 0.3])
def test_roll_and_yaw_of_an_upright_link(angle: float) -> None:
    """Where pitch is a right angle, roll is 0 and yaw takes both; the rotation is the same on both sides."""

    def about(axis: int, by: float) -> np.ndarray:
        c, s = np.cos(by), np.sin(by)
        i, j = [(1, 2), (2, 0), (0, 1)][axis]
        turn = np.eye(3)
        turn[i, i], turn[j, j], turn[i, j], turn[j, i] = c, c, -s, s
        return turn

    rotation = about(2, 0.4) @ about(1, angle) @ about(0, 0.7)
    roll, pitch, yaw = urdf_writer._roll_pitch_yaw(rotation)
    assert (roll == 0) == (angle == np.pi / 2)
    assert np.abs(about(2, yaw) @ about(1, pitch) @ about(0, roll) - rotation).max() < 1e-6


@pytest.mark.parametrize("off, same", [(3e-15, True), (1e-13, False)])
def test_places_that_a_file_keeps(off: float, same: bool) -> None:
    given = tower()
    moved = replace(given.joints["B"], point=(Float(off), Integer(0), Integer(2)))
    found = difference(given, replace(given, joints={**given.joints, "B": moved}))
    assert (found is None) == same and (same or "its point was" in str(found))
    assert round_trip.PLACES < round_trip.INERTIA
