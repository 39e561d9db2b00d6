"""Pages of the documentation."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).parents[2]


DOCS = ROOT / "docs"


PAGES = sorted(DOCS.rglob("*.md"))


def identity(page: Path) -> str:
    return str(page.relative_to(DOCS))
