"""Boxes of coordinates that are proved free of singularities, of losses of the assembly mode, of passed limits.

Plan --file_equations (programs, cut)--> splitting (boxes, by the checker's arithmetic) --certificates--> summary, file
file --certificate_checker (imports nothing of the package)--> verdict; certificate_picture
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.certificate.certificate_checker import UnreadableError, check_certificate
    from symscrew.studies.certificate.certificate_picture import draw_certificate
    from symscrew.studies.certificate.certificates import Certificate, certificate_text, certify

__all__ = [
    "Certificate",
    "UnreadableError",
    "certificate_text",
    "certify",
    "check_certificate",
    "draw_certificate",
]

__getattr__ = doors(__name__)
