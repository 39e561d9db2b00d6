"""Mechanisms from and to other formats: URDF and MJCF, besides the TOML descriptions of `symscrew.description`.

    mechanism = load("robot.urdf")          # .urdf, .xml and .mjcf; the root element tells which it is
    text = dumps(mechanism, ".xml")         # ".urdf", ".xml" or ".mjcf", ".toml"

`urdf_reader`, `mjcf_reader` and `urdf_writer`, `mjcf_writer` say what is read, refused and written.
"""

from __future__ import annotations

from pathlib import Path

from symscrew import description
from symscrew.errors import DescriptionError, shorten
from symscrew.interchange import mjcf_reader, urdf_reader, xml
from symscrew.interchange.mjcf_writer import print_mjcf
from symscrew.interchange.outline import mechanism
from symscrew.interchange.urdf_writer import print_urdf
from symscrew.mechanism import Mechanism
from symscrew.replacement import write_text

READ = (".urdf", ".xml", ".mjcf")
WRITERS = {".urdf": print_urdf, ".xml": print_mjcf, ".mjcf": print_mjcf, ".toml": description.dumps}
READERS = {"robot": urdf_reader.outline, "mujoco": mjcf_reader.outline}


def load(path: str | Path) -> Mechanism:
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


def save(model: Mechanism, path: str | Path) -> None:
    """Write a mechanism to a file; its suffix says as what. An existing file is replaced at the end, or not at all."""
    file = Path(path)
    text = dumps(model, file.suffix)
    write_text(file, text)


def dumps(model: Mechanism, suffix: str) -> str:
    """The text of a file of this suffix that describes a mechanism; raises DescriptionError."""
    if suffix not in WRITERS:
        raise DescriptionError(f"expected a file name that ends in {', '.join(WRITERS)}, got {shorten(suffix)}")
    return WRITERS[suffix](model)
