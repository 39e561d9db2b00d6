"""Pages that are made of the code say what it does: no key is missing, defaults are its own, examples are read."""

from __future__ import annotations

import dataclasses
import re

import pytest
from support import reference_pages as pages
from support.documentation import DOCS
from support.effect_keys import COMMON, EFFECT_KEYS
from support.model_states import model

import symscrew
from symscrew.description import read_tables
from symscrew.effects import effect_from_table, known_effects


@pytest.mark.parametrize("place", pages.PAGES)
def test_pages_are_what_the_code_gives(place: str) -> None:
    """Write them anew: PYTHONPATH=.:tests python -m support.reference_pages."""
    assert (DOCS / place).read_text(encoding="utf-8") == pages.PAGES[place]()


def test_every_public_name_is_in_the_reference_by_its_public_path() -> None:
    named = re.findall(r"^::: symscrew\.(\w+)$", (DOCS / "reference/public.md").read_text(), re.M)
    assert sorted(named) == sorted(set(symscrew.__all__) - {"__version__"})


def test_every_key_of_every_effect_is_there() -> None:
    assert EFFECT_KEYS.keys() == known_effects().keys()
    for name, kind in known_effects().items():
        fields = {f.name for f in dataclasses.fields(kind)}
        assert fields - COMMON.keys() == EFFECT_KEYS[name].keys() - COMMON.keys(), name


@pytest.mark.parametrize("kind", pages.OF_CODE)
def test_every_key_of_every_file_is_there(kind: str) -> None:
    told, known = pages.OF_CODE[kind]
    assert {section: set(keys) for section, keys in told.items()} == {s: set(keys) for s, keys in known.items()}


def test_what_is_needed_is_said_to_be() -> None:
    for section, keys in pages.NEEDED.items():
        for key, (_, default, _) in pages.MECHANISM[section].items():
            assert (default == "needed") == (key in keys), (section, key)


def test_examples_of_effects_are_read() -> None:
    examples, whole = {}, pages.effects_page()
    for name in known_effects():
        section = whole.partition(f"\n## {name}\n")[2].partition("\n## ")[0]
        found = re.search(r"^```toml\n(.*?)^```", section, re.M | re.S)
        if found:
            examples[name] = read_tables(found[1])["effects"]
    assert len(examples) >= len(known_effects()) - 1
    for name, tables in examples.items():
        for table in tables:
            assert table["type"] == name
            effect_from_table(table)


def test_functions_that_the_page_names_exist() -> None:
    """Of the page "which function do I call": every function is one of a model's, every call one of the package's."""
    text = (DOCS / "how_to/which_function.md").read_text(encoding="utf-8")
    known = {*model("three_ups_upu_s").programs, *model("four_bar").programs}
    named = set(re.findall(r"\bf\.(\w+)", text))
    assert named and named <= known
    assert set(re.findall(r"\bsymscrew\.(\w+)", text)) <= set(symscrew.__all__)
