"""Folders of generated code: every target that is asked for, written whole or not at all.

    model --render--> {file: bytes} --generate--> folder, or with hashes in place of the long files

The table of targets is in `symscrew.generation.targets`.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.generation.folder import EMBEDDED, check_place, generate, render, with_hashes, write_folder
    from symscrew.generation.target_file import Case, Finding
    from symscrew.generation.targets import TARGETS, USUAL, apart, by_value, printable, with_brought
    from symscrew.generation.value_comparison import Results, compare_values

__all__ = [
    "EMBEDDED",
    "TARGETS",
    "USUAL",
    "Case",
    "Finding",
    "Results",
    "apart",
    "by_value",
    "check_place",
    "compare_values",
    "generate",
    "printable",
    "render",
    "with_brought",
    "with_hashes",
    "write_folder",
]

__getattr__ = doors(__name__)
