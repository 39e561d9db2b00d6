"""Mechanisms from and to other formats: URDF and MJCF, besides the TOML descriptions of `symscrew.description`.

mechanism = load_format("robot.urdf")      # .urdf, .xml and .mjcf; the root element tells which it is
text = text_of(mechanism, ".xml")          # ".urdf", ".xml" or ".mjcf", ".toml"

by_suffix               the table of formats: a further one is a file and a line in it
urdf_reader, mjcf_reader    what is read and what is refused: file -> Draft (with files of loops, forces, couplings,
                        actuators, transmissions, masses, keyframes, models composed of others)
draft, from_draft       what a file says; as a mechanism and what is beside it (with file_names, merged_joints)
import_options, imported    what whoever imports allows; the mechanism, effects, limits, and what became of everything
open_loops, physical_inertias, rigid_groups, mesh_inertias   open loops, impossible inertias, bodies of triangles
elementary_chains       a mechanism as a tree of elementary joints, which the writers want
urdf_writer, mjcf_writer, urdf_effects, mjcf_effects    what is written, and as what
drawn_meshes            what bodies look like
exact_digits            digits that mean an angle, a zero or a short decimal
safe_xml, rigid_displacements   XML without traps; poses from angles and quaternions with 50 digits
round_trip              what a file keeps of a mechanism that is written and read back
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.formats.by_suffix import READABLE, WRITERS, import_file, load_format, mesh_pictures, save_as, text_of
    from symscrew.formats.drawn_meshes import MeshPictures
    from symscrew.formats.import_options import ImportOptions
    from symscrew.formats.imported import Account, Beside, Imported, JointLimits
    from symscrew.formats.round_trip import difference

__all__ = [
    "READABLE",
    "WRITERS",
    "Account",
    "Beside",
    "ImportOptions",
    "Imported",
    "JointLimits",
    "MeshPictures",
    "difference",
    "import_file",
    "load_format",
    "mesh_pictures",
    "save_as",
    "text_of",
]

__getattr__ = doors(__name__)
