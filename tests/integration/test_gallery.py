"""The gallery: a picture of everything, and each of what its file says today."""

from __future__ import annotations

import pytest
from support import gallery
from support.documentation import DOCS
from support.samples import some_quickly

from symscrew import catalogue

NAMES = (*catalogue.names(), *gallery.examples())


def test_the_page_shows_every_mechanism_and_every_example() -> None:
    """Write it anew: PYTHONPATH=.:tests python -m support.gallery."""
    assert (DOCS / "gallery.md").read_text(encoding="utf-8") == gallery.page()
    assert {file.stem for file in (DOCS / "gallery").iterdir()} == set(NAMES)


@pytest.mark.parametrize("name", some_quickly(NAMES, every=9))
def test_a_picture_is_of_what_its_file_says(name: str) -> None:
    Image = pytest.importorskip("PIL.Image")
    with Image.open(DOCS / "gallery" / f"{name}.png") as picture:
        assert picture.info["source"] == gallery.mark_of(name), "draw it again"
        assert min(picture.size) > 60 and len(picture.convert("RGB").getcolors(100_000)) > 8
