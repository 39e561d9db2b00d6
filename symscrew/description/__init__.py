"""Descriptions of mechanisms: bodies, joints, loops, points and parameters, exactly as their author meant them.

    TOML file --toml_file--> tables --reader, limb_letters--> builder --validation--> Mechanism

A `Mechanism` is data: numbers are exact SymPy expressions of parameters, read by a grammar of our own.
"""

from typing import TYPE_CHECKING

from symscrew.description.builder import MechanismBuilder
from symscrew.description.coupled import slope, terms_of
from symscrew.description.digits import sixty_digits
from symscrew.description.expressions import CONSTANTS, FUNCTIONS, exact, numeric, parse, to_text
from symscrew.description.given_values import GivenValue, given_value, parameter_units
from symscrew.description.joints import JOINT_TYPES, NO_MOTION, JointType, Motion, rotation
from symscrew.description.kept_comments import with_comments
from symscrew.description.mechanism import (
    Body,
    CoupledTerm,
    Coupling,
    Joint,
    Matrix3,
    Mechanism,
    Parameter,
    Point,
    Vector,
    followed,
)
from symscrew.description.mechanism_size import characteristic_length, radius_of_gyration
from symscrew.description.names import RESERVED, check_name, check_text, longer_name, markdown_text
from symscrew.description.number_range import check_range
from symscrew.description.reader import Reader
from symscrew.description.taken_names import members, namespace, taken_as_file
from symscrew.description.toml_file import load_description, parse_description, read_tables, read_text, to_toml
from symscrew.description.toml_tables import check_keys, check_sections, from_file
from symscrew.description.units import in_si
from symscrew.description.validation import check_values_of, validate
from symscrew.doors import doors

if TYPE_CHECKING:  # mechanisms to start from, in symbols
    from symscrew.description.architectures import ARCHITECTURES, architecture
    from symscrew.description.template import description_text, renamed_text, write_new, write_template

__all__ = [
    "ARCHITECTURES",
    "CONSTANTS",
    "FUNCTIONS",
    "JOINT_TYPES",
    "NO_MOTION",
    "RESERVED",
    "Body",
    "CoupledTerm",
    "Coupling",
    "GivenValue",
    "Joint",
    "JointType",
    "Matrix3",
    "Mechanism",
    "MechanismBuilder",
    "Motion",
    "Parameter",
    "Point",
    "Reader",
    "Vector",
    "architecture",
    "characteristic_length",
    "check_keys",
    "check_name",
    "check_range",
    "check_sections",
    "check_text",
    "check_values_of",
    "description_text",
    "exact",
    "followed",
    "from_file",
    "given_value",
    "in_si",
    "load_description",
    "longer_name",
    "markdown_text",
    "members",
    "namespace",
    "numeric",
    "parameter_units",
    "parse",
    "parse_description",
    "radius_of_gyration",
    "read_tables",
    "read_text",
    "renamed_text",
    "rotation",
    "sixty_digits",
    "slope",
    "taken_as_file",
    "terms_of",
    "to_text",
    "to_toml",
    "validate",
    "with_comments",
    "write_new",
    "write_template",
]

__getattr__ = doors(__name__)
