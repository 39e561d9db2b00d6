"""Passes over programs: the same values for fewer operations, one file each; `in_order` has the table."""

from symscrew.program.passes.in_order import PASSES

__all__ = ["PASSES"]
