"""Files that nobody means well with, given to every reader: one error of ours, soon, and short."""

from __future__ import annotations

import os
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from support.fuzzing import at_most

import symscrew
from symscrew.array_archives import read_archive
from symscrew.catalogue import load
from symscrew.effects import load_effects
from symscrew.formats import load_format
from symscrew.formats.mesh_inertias import bulk_of, read_triangles
from symscrew.optimisation import load_problem
from symscrew.studies.given_motion import load_motion

READERS: dict[str, tuple[str, Callable[[Path], object]]] = {
    "mechanism": (".toml", symscrew.load_description),
    "scene": (".toml", symscrew.load_scene),
    "effects": (".toml", load_effects),
    "problem": (".toml", load_problem),
    "motion": (".toml", lambda path: load_motion(path, load("slider_crank"))),
    "samples": (".csv", lambda path: load_motion(path, load("slider_crank"))),
    "urdf": (".urdf", load_format),
    "mjcf": (".xml", load_format),
    "archive": (".npz", read_archive),
    "mesh": (".stl", lambda path: bulk_of(read_triangles(path), "mesh")),
}
EACH = pytest.mark.parametrize("reader", READERS)


def refused(reader: str, path: Path) -> str:
    """What the reader says of a file that it must refuse."""
    with at_most(5.0), pytest.raises(symscrew.DescriptionError) as caught:
        READERS[reader][1](path)
    assert 0 < len(str(caught.value)) < 4000
    return str(caught.value)


@EACH
@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes and devices of POSIX here")
def test_pipes_devices_and_folders_are_no_files(reader: str, tmp_path: Path) -> None:
    """Reading one of them need not end, or ends with all memory taken."""
    suffix = READERS[reader][0]
    os.mkfifo(tmp_path / f"pipe{suffix}")
    (tmp_path / f"device{suffix}").symlink_to("/dev/zero")
    (tmp_path / f"folder{suffix}").mkdir()
    (tmp_path / f"circle{suffix}").symlink_to(tmp_path / f"circle{suffix}")
    for name in ("pipe", "device"):
        assert "expected a file, found a pipe or a device" in refused(reader, tmp_path / f"{name}{suffix}")
    for name in ("folder", "circle", "none"):
        refused(reader, tmp_path / f"{name}{suffix}")


@EACH
@pytest.mark.parametrize(
    "content",
    [b"", b"\0", bytes(range(256)), b"\xff\xfe[\0", b"[" * 5000, b"[a]\n[a]", b"a = " + b"9" * 5000, b"\xef\xbb\xbf{}",
     b"a." * 3000 + b"a = 1", b"x" * 100000, b"PK\x03\x04" + b"\0" * 60, b'{"a": NaN}', b"<" * 5000, b"<a>" * 5000,
     b'<!DOCTYPE a [<!ENTITY b "c">]><a>&b;</a>',
     b'<!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/passwd">]><mujoco>&b;</mujoco>',
     b'<!DOCTYPE a [<!ENTITY b "x"><!ENTITY c "&b;&b;&b;"><!ENTITY d "&c;&c;">]><robot name="&d;"/>'],
    ids=range(17),
)  # fmt: skip
def test_what_is_none_of_its_kind(reader: str, content: bytes, tmp_path: Path) -> None:
    path = tmp_path / f"file{READERS[reader][0]}"
    path.write_bytes(content)
    said = refused(reader, path)
    assert "root:" not in said  # of a file that the entity names


def test_an_archive_that_grows(tmp_path: Path) -> None:
    """Zeros by the gigabyte in some kilobytes, whatever its header says."""
    header = b"\x93NUMPY\x01\x00v\x00" + b"{'descr': '<f8', 'fortran_order': False, 'shape': (3,), }".ljust(117) + b"\n"
    with zipfile.ZipFile(tmp_path / "bomb.npz", "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("t.npy", header + b"\0" * (1 << 26))
    refused("archive", tmp_path / "bomb.npz")


@pytest.mark.parametrize(
    ("reader", "text", "said"),
    [
        ("motion", '[motion]\nduration = nan\n[coordinates]\ncrank = "t"', "expected a number above 0"),
        ("motion", f'[motion]\nduration = {"9" * 400}\n[coordinates]\ncrank = "t"', "expected a number above 0"),
        ("motion", '[motion]\nduration = 1\n[twist]\nwx = "t"\n[twist.wy]', "twist.wy: expected an expression, got {}"),
        ("effects", '[[effects]]\ntype = "gravity"\n[[effect]]\ntype = "gravity"', "found 'effect', too"),
    ],
)
def test_one_value_that_nobody_means(reader: str, text: str, said: str, tmp_path: Path) -> None:
    path = tmp_path / "file.toml"
    path.write_text(text)
    assert said in refused(reader, path)
