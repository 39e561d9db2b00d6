"""Mechanisms from and to other formats: URDF and MJCF, besides the TOML descriptions of `symscrew.description`.

    mechanism = load_format("robot.urdf")      # .urdf, .xml and .mjcf; the root element tells which it is
    text = text_of(mechanism, ".xml")          # ".urdf", ".xml" or ".mjcf", ".toml"

`urdf_reader`, `mjcf_reader` and `urdf_writer`, `mjcf_writer` say what is read, refused and written.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.formats.by_suffix import READABLE, WRITERS, load_format, save_as, text_of
    from symscrew.formats.comparison import difference

__all__ = ["READABLE", "WRITERS", "difference", "load_format", "save_as", "text_of"]

__getattr__ = doors(__name__)
