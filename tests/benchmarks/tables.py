"""What the benchmarks share: Markdown tables, exponents of growth."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def table(header: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """A Markdown table."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def exponent(sizes: Sequence[float], values: Sequence[float]) -> float:
    """Slope of log value over log size, over the larger half of the sizes."""
    start = min(len(sizes) // 2, len(sizes) - 2)
    return float(np.polyfit(np.log(sizes[start:]), np.log(values[start:]), 1)[0])
