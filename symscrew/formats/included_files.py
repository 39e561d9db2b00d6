"""Files that an MJCF file includes, put in the place of the elements that name them.

Only files in the folder of the main one, or in one that whoever imports names, or below it are read, each once on its
way and few in all, so that a file cannot reach outside or grow without bound.
"""

from __future__ import annotations

import os
from copy import copy
from pathlib import Path

from symscrew.errors import DescriptionError, shorten
from symscrew.formats.safe_xml import Element, attribute, read

BESIDE = "beside"
"""Attribute of an included file's mesh: that file's folder, which is searched after the main one."""
MOST_FILES = 100
"""Files that one model may be made of; those that people publish are made of a few."""
DEEPEST = 10
"""Files that include each other in a row."""


def inside(folder: Path, name: str, where: str, within: Path | None = None) -> Path:
    """The path of a file named relative to a folder; raises DescriptionError for one that is not below `within`.

    `within`: by default the folder itself.
    """
    if "\0" in name:
        raise DescriptionError(f"{where}: a path must not contain a null character")
    path = Path(os.path.realpath(folder / name))
    if not path.is_relative_to(os.path.realpath(within or folder)):
        raise DescriptionError(
            f"{where}: {shorten(name)} is outside of the model's folder; only files below it are read, or below the "
            "one that --folder DIR names"
        )
    try:
        waits = path.exists() and not (path.is_file() or path.is_dir())
    except OSError as error:  # a name that is too long
        raise DescriptionError(f"{where}: {shorten(name)}: {error.strerror}") from error
    if waits:
        raise DescriptionError(f"{where}: {shorten(name)} is no file")
    return path


def expanded(root: Element, path: Path, within: Path | None = None) -> Element:
    """The root element with the contents of all included files, which are below `within`, in their places."""
    return _Expansion(path.parent, within).of(root, (path.resolve(),))


class _Expansion:
    def __init__(self, folder: Path, within: Path | None) -> None:
        self.folder, self.within, self.count = folder, within, 0

    def of(self, element: Element, way: tuple[Path, ...]) -> Element:
        if not any(child.tag == "include" for child in element.iter()):
            return element
        made = copy(element)
        made[:] = []
        for child in element:
            if child.tag == "include":
                made.extend(self._included(child, way))
            else:
                made.append(self.of(child, way))
        return made

    def _included(self, element: Element, way: tuple[Path, ...]) -> list[Element]:
        name = attribute(element, "file")
        path = inside(self.folder, name, "<include>", self.within)
        if not path.exists() and way[-1].parent != self.folder.resolve():  # then beside the file that names it
            path = inside(way[-1].parent, name, "<include>", self.within or self.folder)
        if path in way or len(way) > DEEPEST or self.count >= MOST_FILES:
            raise DescriptionError(f"<include>: {path.name} includes itself, or too many files are included")
        self.count += 1
        found = read(path)
        if path.parent != self.folder.resolve():
            for mesh in found.iter("mesh"):  # those of files that it includes itself keep theirs
                mesh.attrib.setdefault(BESIDE, os.path.relpath(path.parent, self.folder.resolve()))
        return list(self.of(found, (*way, path)))
