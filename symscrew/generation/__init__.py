"""Folders of generated code: every target that is asked for, written whole or not at all."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.generation.folder import EMBEDDED, FORMATS, generate, render
    from symscrew.generation.targets import SINGLE_TARGETS, TARGETS, USUAL

__all__ = ["EMBEDDED", "FORMATS", "SINGLE_TARGETS", "TARGETS", "USUAL", "generate", "render"]

__getattr__ = doors(__name__)
