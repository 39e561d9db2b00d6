"""Target "markdown": screws, momentum screws, equations and symbols of the model, to read. Nothing in it runs."""

from __future__ import annotations

from collections.abc import Mapping

from symscrew.export import print_markdown
from symscrew.generation.target_file import Order


def files(order: Order) -> Mapping[str, str]:
    """model.md."""
    return print_markdown(order.model)
