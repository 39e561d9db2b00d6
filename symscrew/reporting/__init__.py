"""One document for a mechanism: picture, mobility, screws, functions and their cost, singularities, studies.

mechanism --sections--> blocks --document--> HTML (one file, formulas as MathML) or Markdown (with pictures)
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.reporting.blocks import Document, write_document
    from symscrew.reporting.report_call import report
    from symscrew.reporting.sections import document

__all__ = ["Document", "document", "report", "write_document"]

__getattr__ = doors(__name__)
