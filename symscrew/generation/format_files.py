"""What the targets "mjcf" and "urdf" share: the mechanism in another format, and that format read back."""

from __future__ import annotations

from collections.abc import Mapping

from symscrew.formats import difference, load_format, text_of
from symscrew.generation.target_file import Case, Finding, Order


def described(order: Order, suffix: str) -> Mapping[str, str]:
    """<name><suffix>.

    Raises:
        DescriptionError: the format cannot hold the mechanism.
    """
    return {f"{order.model.name}{suffix}": text_of(order.model.mechanism, suffix)}


def read_back(case: Case, suffix: str, what: str) -> Finding:
    """Whether joints, places and inertias are those of the mechanism."""
    found = difference(case.model.mechanism, load_format(case.fresh / f"{case.model.name}{suffix}"))
    return found is None, f"{what} read back: {found or 'joints, places and inertias agree'}"
