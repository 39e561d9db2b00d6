"""Helpers of the hard cases (tests/hard/test_*.py): their numbers, their mechanisms, arithmetic in many digits."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

CASES = Path(__file__).parent.parent / "data" / "hard_cases.json"


def case(number: int) -> dict[str, Any]:
    """A case of data/hard_cases.json by its number."""
    return next(entry for entry in json.loads(CASES.read_text())["cases"] if entry["id"] == number)
