"""Which reader or writer a file takes: by its root element when it is read, by its suffix when it is written."""

from __future__ import annotations

from pathlib import Path

from symscrew.description import Mechanism, to_toml
from symscrew.errors import DescriptionError, shorten
from symscrew.formats import mjcf_reader, urdf_reader, xml
from symscrew.formats.mjcf_writer import print_mjcf
from symscrew.formats.outline import mechanism
from symscrew.formats.urdf_writer import print_urdf
from symscrew.whole_files import write_text

READABLE = (".urdf", ".xml", ".mjcf")
WRITERS = {".urdf": print_urdf, ".xml": print_mjcf, ".mjcf": print_mjcf, ".toml": to_toml}
READERS = {"robot": urdf_reader.outline, "mujoco": mjcf_reader.outline}


def load_format(path: str | Path) -> Mechanism:
    """The validated mechanism in a URDF or MJCF file; its `source` says what the file holds besides.

    Raises:
        DescriptionError: the file cannot be read, or holds what a mechanism cannot.
    """
    file = Path(path)
    root = xml.read(file)
    if root.tag not in READERS:
        expected = " or ".join(f"<{tag}>" for tag in READERS)
        raise DescriptionError(f"{file.name}: expected the root element {expected}, got <{shorten(root.tag)}>")
    try:
        return mechanism(READERS[root.tag](root, file.name))
    except DescriptionError as error:
        raise DescriptionError(f"{file.name}: {error}") from error


def save_as(model: Mechanism, path: str | Path) -> None:
    """Write a mechanism to a file; its suffix says as what. An existing file is replaced at the end, or not at all."""
    file = Path(path)
    text = text_of(model, file.suffix)
    write_text(file, text)


def text_of(model: Mechanism, suffix: str) -> str:
    """The text of a file of this suffix that describes a mechanism; raises DescriptionError."""
    if suffix not in WRITERS:
        raise DescriptionError(f"expected a file name that ends in {', '.join(WRITERS)}, got {shorten(suffix)}")
    return WRITERS[suffix](model)
