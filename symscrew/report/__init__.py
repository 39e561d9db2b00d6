"""One document for a mechanism: picture, mobility, screws, functions and their cost, singularities, studies.

mechanism --sections--> blocks --document--> HTML (one file, formulas as MathML) or Markdown (with pictures)
"""

from symscrew.report.document import Document, write
from symscrew.report.sections import document

__all__ = ["Document", "document", "write"]
