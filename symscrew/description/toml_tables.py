"""Sections and keys of TOML files: which there may be, and errors that name the file, the place and the cure."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

from symscrew.description.toml_file import KINDS, read_text
from symscrew.errors import DescriptionError, did_you_mean, in_file, shorten

Read = TypeVar("Read")


def from_file(path: str | Path, loads: Callable[..., Read]) -> Read:
    """What `loads(text, folder=..., name=...)` makes of the file at `path`; its errors begin with the file's name.

    Raises:
        DescriptionError: the file cannot be read, or `loads` says what is wrong in it.
    """
    file = Path(path)
    try:
        return loads(read_text(file), folder=file.parent, name=file.stem)
    except DescriptionError as error:
        raise in_file(file.name, error) from error


def check_sections(
    tables: Mapping[str, Any], sections: Sequence[str], keys: Mapping[str, Sequence[str]], lists: Collection[str]
) -> None:
    """Raise DescriptionError for a section that is not among `sections`, is no table or has a key that is not known.

    Args:
        tables: the content of the file.
        sections: the sections that there may be.
        keys: section -> its keys, where they are fixed.
        lists: the sections that are lists of tables, `[[section]]`.

    Raises:
        DescriptionError: names the section or key, and those that are nearest.
    """
    for section, content in tables.items():
        if section not in sections and section in KINDS:
            raise DescriptionError(
                f"this file describes {KINDS[section]}; expected one with [{sections[0]}], which names "
                f"{'it' if KINDS[section] == 'a mechanism' else 'a mechanism'} by mechanism = ..."
            )
        if section not in sections:
            raise DescriptionError(f"unknown section {shorten(section)}; {did_you_mean(section, sections)}")
        expected = list if section in lists else dict
        if not isinstance(content, expected):
            what = f"tables [[{section}]]" if section in lists else "a table"
            raise DescriptionError(f"{section}: expected {what}, got {shorten(content)}")
        if section in keys:
            for table in content if isinstance(content, list) else [content]:
                check_keys(section, table, keys[section])


def check_keys(where: str, table: Any, known: Sequence[str]) -> None:
    """Raise DescriptionError for what is no table or has an unknown key."""
    if not isinstance(table, dict):
        raise DescriptionError(f"{where}: expected a table, got {shorten(table)}")
    for key in table:
        if key not in known:
            raise DescriptionError(f"{where}: unknown key {shorten(key)}; {did_you_mean(key, known)}")
