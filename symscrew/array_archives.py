"""Archives of NumPy arrays (.npz) by anybody, read within bounds: what is too large is refused before it is unpacked.

    .npz --table of contents--> sizes said --header of an array--> shape, type --at most that many bytes--> array

A few megabytes of an archive can hold gigabytes of zeros, and a header can claim any shape. Nothing is unpickled.
"""

from __future__ import annotations

import math
import zipfile
import zlib
from collections.abc import Collection
from pathlib import Path
from typing import IO

import numpy as np

from symscrew.errors import DescriptionError, shorten
from symscrew.whole_files import only_file

KINDS = "biufU"  # of arrays that are read: truth values, whole and real numbers, texts; no objects, no complex numbers
MAX_BYTES = 400_000_000  # of an array: 50 million numbers; more would fill the memory of a small machine
MAX_TOGETHER = 1_000_000_000  # bytes of all arrays that are read of one file
MAX_MEMBERS = 10_000  # of an archive: of runs and trajectories there are some dozens
_HEADER = 10_000  # bytes of the text that says shape and type, as NumPy itself bounds it
_LAST_LETTER, _SURROGATES = 0x10FFFF, (0xD800, 0xDFFF)  # of Unicode, and those that stand for no letter
_STREAM = 1 << 16  # bytes of a piece that is unpacked at once
_BROKEN = (zipfile.BadZipFile, zlib.error, EOFError, KeyError, ValueError, NotImplementedError, RuntimeError)


def read_archive(
    path: str | Path, wanted: Collection[str] | None = None, *, max_bytes: int = MAX_BYTES
) -> dict[str, np.ndarray]:
    """Arrays of an archive by name.

    Args:
        path: the file.
        wanted: names of the arrays to read, those that are not there are left out; None: all.
        max_bytes: of one array.

    Raises:
        DescriptionError: it cannot be read, is no such archive, or an array is too large or neither numbers nor texts.
    """
    file = Path(path)
    found: dict[str, np.ndarray] = {}
    try:
        with zipfile.ZipFile(only_file(file)) as archive:
            entries = [entry for entry in archive.infolist() if entry.filename.endswith(".npy")]
            if len(entries) > MAX_MEMBERS:
                raise DescriptionError(f"{file.name}: expected at most {MAX_MEMBERS} arrays, got {len(entries)}")
            for entry in entries:
                name = entry.filename.removesuffix(".npy")
                if wanted is None or name in wanted:
                    if name in found:
                        raise DescriptionError(f"{file.name}: holds `{shorten(name)}` twice")
                    left = min(max_bytes, MAX_TOGETHER - sum(array.nbytes for array in found.values()))
                    with archive.open(entry) as stream:
                        found[name] = _array(stream, f"{file.name}: `{shorten(name)}`", left)
    except OSError as error:
        raise DescriptionError(f"{file.name}: the file cannot be read: {error.strerror or error}") from error
    except DescriptionError:
        raise
    except (*_BROKEN, MemoryError, OverflowError, TypeError, SyntaxError, RecursionError) as error:
        text = f"{file.name}: expected an archive of arrays (.npz): {shorten(str(error) or type(error).__name__)}"
        raise DescriptionError(text) from error
    return found


def _array(stream: IO[bytes], where: str, most: int) -> np.ndarray:
    """The array of one member, unpacked only as far as its header says, and only if that is not too much."""
    version = np.lib.format.read_magic(stream)
    if version != (1, 0):  # others are for names of columns, and headers of up to 4 GB
        raise ValueError(f"version {version} of an array")
    shape, by_columns, dtype = np.lib.format.read_array_header_1_0(stream, max_header_size=_HEADER)
    if dtype.kind not in KINDS or dtype.hasobject:
        raise DescriptionError(f"{where} must hold real numbers or texts, got {shorten(str(dtype))}")
    size = math.prod(shape) * dtype.itemsize
    if any(n < 0 for n in shape) or size > most:
        raise DescriptionError(f"{where}: expected at most {most} bytes, its header says {size}")
    content = bytearray()
    while piece := stream.read(min(_STREAM, size - len(content) + 1)):
        content += piece
        if len(content) > size:
            raise ValueError(f"more numbers than the header of {where} says")
    if len(content) != size:
        raise ValueError(f"{len(content)} of {size} bytes of {where}")
    flat = np.frombuffer(content, dtype=dtype) if size else np.empty(math.prod(shape), dtype)
    if dtype.kind == "U" and size:
        letters = flat.view(np.dtype("u4").newbyteorder(dtype.byteorder))
        if (letters > _LAST_LETTER).any() or ((letters >= _SURROGATES[0]) & (letters <= _SURROGATES[1])).any():
            raise ValueError(f"numbers of {where} that are no letters")
    return flat.reshape(shape[::-1]).T if by_columns else flat.reshape(shape)
