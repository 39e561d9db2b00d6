"""Boxes of coordinates that are proved free of singularities, of losses of the assembly mode, of passed limits.

Plan --file_equations (programs, cut)--> splitting (boxes, by the checker's arithmetic) --certificates--> summary, file
file --certificate_checker (imports nothing of the package)--> verdict; certificate_picture
     --derived_again (derives the equations again)--> whether it is one of the mechanism that it names
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.certificate.certificate_checker import UnreadableError, check_certificate, values_of
    from symscrew.studies.certificate.certificate_picture import draw_certificate
    from symscrew.studies.certificate.certificates import Certificate, certificate_text, certify
    from symscrew.studies.certificate.derived_again import MechanismProof, is_certificate, proof_of_mechanism

__all__ = [
    "Certificate",
    "MechanismProof",
    "UnreadableError",
    "certificate_text",
    "certify",
    "check_certificate",
    "draw_certificate",
    "is_certificate",
    "proof_of_mechanism",
    "values_of",
]

__getattr__ = doors(__name__)
