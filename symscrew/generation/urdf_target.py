"""Target "urdf": the mechanism as URDF, open chains only."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from symscrew.generation.format_files import described, read_back
from symscrew.generation.target_file import Case, Finding, Order


def files(order: Order) -> Mapping[str, str]:
    """<name>.urdf."""
    return described(order, ".urdf")


def compare(case: Case) -> Iterator[Finding]:
    """Read back, it is the mechanism."""
    yield read_back(case, ".urdf", "URDF")
