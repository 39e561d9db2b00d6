"""Mechanisms from and to other formats: URDF and MJCF, besides the TOML descriptions of `symscrew.description`.

mechanism = load_format("robot.urdf")      # .urdf, .xml and .mjcf; the root element tells which it is
text = text_of(mechanism, ".xml")          # ".urdf", ".xml" or ".mjcf", ".toml"

by_suffix               the table of formats: a further one is a file and a line in it
urdf_reader, mjcf_reader    what is read and what is refused: file -> Draft
draft, from_draft       what a file says; as a mechanism (with file_names, merged_joints)
elementary_chains       a mechanism as a tree of elementary joints, which the writers want
urdf_writer, mjcf_writer    what is written, and as what
safe_xml, rigid_displacements   XML without traps; poses from angles and quaternions with 50 digits
round_trip              what a file keeps of a mechanism that is written and read back
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.formats.by_suffix import READABLE, WRITERS, load_format, save_as, text_of
    from symscrew.formats.round_trip import difference

__all__ = ["READABLE", "WRITERS", "difference", "load_format", "save_as", "text_of"]

__getattr__ = doors(__name__)
