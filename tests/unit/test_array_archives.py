"""Archives of arrays by anybody: bounds hold before anything is unpacked, on both sides of each."""

from __future__ import annotations

import io
import tracemalloc
import zipfile
from pathlib import Path

import numpy as np
import pytest

from symscrew import array_archives
from symscrew.array_archives import read_archive
from symscrew.display.view.motion_file import read_motion
from symscrew.errors import DescriptionError

HEADER = "{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}"


def member(kind: str, shape: str, content: bytes = b"", version: bytes = b"\x01\x00") -> bytes:
    """A member of an archive whose header says whatever it likes."""
    text = HEADER.format(kind, shape).encode()
    length = len(text).to_bytes(2 if version[0] == 1 else 4, "little")
    return b"\x93NUMPY" + version + length + text + content


def archive(path: Path, **members: bytes) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
        for name, content in members.items():
            made.writestr(f"{name}.npy", content)
    return path


@pytest.mark.parametrize(
    "array",
    [
        np.arange(6.0).reshape(2, 3),
        np.asfortranarray(np.arange(24).reshape(2, 3, 4)),
        np.array("a text with an é"),
        np.array(["a", "bc"]),
        np.array([], dtype="U1"),
        np.zeros((0, 5)),
        np.zeros((4, 0), np.float32),
        np.array(True),
        np.arange(3, dtype=">i4"),
    ],
    ids=lambda a: f"{a.dtype} {a.shape}",
)
@pytest.mark.parametrize("save", [np.savez, np.savez_compressed])
def test_what_numpy_writes_is_read(array: np.ndarray, save, tmp_path: Path) -> None:
    save(tmp_path / "a.npz", x=array, y=np.arange(3.0))
    found = read_archive(tmp_path / "a.npz", ["x", "z"])
    assert list(found) == ["x"] and np.array_equal(found["x"], array) and found["x"].dtype == array.dtype
    assert list(read_archive(tmp_path / "a.npz")) == ["x", "y"]


def test_bounds_are_those_that_are_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    np.savez(tmp_path / "a.npz", x=np.zeros(10), y=np.zeros(10))
    assert len(read_archive(tmp_path / "a.npz", max_bytes=80)) == 2
    with pytest.raises(DescriptionError, match=r"`'x'`: expected at most 79 bytes, its header says 80"):
        read_archive(tmp_path / "a.npz", max_bytes=79)
    monkeypatch.setattr(array_archives, "MAX_TOGETHER", 160)
    assert len(read_archive(tmp_path / "a.npz")) == 2
    monkeypatch.setattr(array_archives, "MAX_TOGETHER", 159)
    with pytest.raises(DescriptionError, match=r"`'y'`: expected at most 79 bytes"):
        read_archive(tmp_path / "a.npz")
    monkeypatch.setattr(array_archives, "MAX_MEMBERS", 1)
    with pytest.raises(DescriptionError, match="at most 1 arrays, got 2"):
        read_archive(tmp_path / "a.npz")


BOMB = 40_000_000  # bytes of zeros, which are 40 kB in the archive


@pytest.mark.parametrize(
    "content, said",
    [
        (member("<f8", "(5000000,)", bytes(BOMB)), "expected at most 1000000 bytes, its header says 40000000"),
        (member("<f8", "(2,)", bytes(BOMB)), "more numbers than the header"),
        (member("<f8", f"({2**45},)"), "expected at most 1000000 bytes"),
        (member("<f8", f"({2**62}, {2**62})"), "expected at most 1000000 bytes"),
        (member("<f8", "(-1,)"), "expected at most|archive of arrays"),
        (member("<f8", "(100,)", bytes(8)), "8 of 800 bytes"),
        (member("<c16", "(1,)", bytes(16)), "real numbers or texts, got .*c"),
        (member("|O", "(1,)", b"cos\nsystem\n(S'true'\ntR."), "real numbers or texts, got 'object'"),
        (member("<f8", "(1,)", bytes(8), b"\x02\x00"), "version"),
        (member("<f8", "(" * 3000 + ")" * 3000), "archive of arrays"),
        (member("<U1", "(1,)", b"\xff\xff\xff\xff"), "archive of arrays"),
        (b"\x93NUMPY\x02\x00\xff\xff\xff\xff" + bytes(BOMB), "version"),
        (b"junk", "archive of arrays"),
        (b"", "archive of arrays"),
    ],
    ids=lambda value: str(value)[:30],
)
def test_what_is_no_array_or_too_large_is_one_error_and_takes_no_memory(
    content: bytes, said: str, tmp_path: Path
) -> None:
    path = archive(tmp_path / "a.npz", t=content)
    tracemalloc.start()
    try:
        with pytest.raises(DescriptionError, match=said):
            read_archive(path, max_bytes=1_000_000)
        assert tracemalloc.get_traced_memory()[1] < 4_000_000
    finally:
        tracemalloc.stop()
    with pytest.raises(DescriptionError):
        read_motion(path)


def test_archives_that_are_none(tmp_path: Path) -> None:
    whole = io.BytesIO()
    np.savez_compressed(whole, t=np.arange(100.0))
    content = whole.getvalue()
    for k, broken in enumerate([b"", content[:-30], content[:60] + b"\xff" * 40 + content[100:], b"PK" * 50]):
        (tmp_path / f"{k}.npz").write_bytes(broken)
        with pytest.raises(DescriptionError, match=f"{k}.npz: expected an archive of arrays"):
            read_archive(tmp_path / f"{k}.npz")
    with pytest.raises(DescriptionError, match=r"none\.npz: the file cannot be read: No such file"):
        read_archive(tmp_path / "none.npz")
    with pytest.warns(UserWarning, match="Duplicate"), zipfile.ZipFile(tmp_path / "twice.npz", "w") as made:
        for _ in range(2):
            made.writestr("t.npy", member("<f8", "(1,)", bytes(8)))
    with pytest.raises(DescriptionError, match="holds `'t'` twice"):
        read_archive(tmp_path / "twice.npz")
