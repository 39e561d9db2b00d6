"""What bodies of a robot's file look like: triangles of its meshes, in absolute axes in the reference configuration.

    URDF <visual> with package:// paths, MJCF geoms with meshes --> body -> triangles, and what could not be drawn

Meshes have far more triangles than a picture needs: corners within a cell of a grid become one, and triangles that
collapse are left out. Pictures enter no number; a mesh that is not there is named, and everything else is drawn.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.errors import DescriptionError, shorten
from symscrew.formats.draft import RawPicture
from symscrew.formats.included_files import inside
from symscrew.formats.mesh_inertias import SUFFIXES, read_triangles
from symscrew.formats.rigid_displacements import Pose
from symscrew.formats.safe_xml import Element, elements, label, numbers
from symscrew.formats.tree_freedoms import doubles

Array = np.ndarray[Any, Any]
MOST_TRIANGLES = 4000
"""Of one mesh in a picture: with fifty meshes 7 MB of a page, which a browser turns without a pause."""
CELLS = (64, 48, 32, 24, 16, 12, 8)
"""Along the longest side of a mesh, tried one after another until it has few enough triangles."""
PACKAGE = "package://"


@dataclass(frozen=True)
class MeshPictures:
    """Body -> triangles (n, 3, 3) [m] in absolute axes in the reference configuration; and what was not drawn, why."""

    triangles: Mapping[str, Array]
    missing: tuple[str, ...]


def drawn(pictures: Sequence[RawPicture], names: Mapping[str, str]) -> MeshPictures:
    """The pictures of a draft; `names`: body of the file -> body of the mechanism."""
    found: dict[str, list[Array]] = {}
    missing: list[str] = []
    for picture in pictures:
        try:
            own = _thinned(picture.read())
        except DescriptionError as error:
            missing.append(f"{picture.body}: {error}")
            continue
        found.setdefault(names[picture.body], []).append(placed(own, picture.pose))
    joined = {body: np.concatenate(some).astype(np.float32) for body, some in found.items()}
    return MeshPictures(joined, tuple(dict.fromkeys(missing)))


def placed(triangles: Array, pose: Pose) -> Array:
    """Triangles of a frame with this pose, in the axes that the pose is in."""
    found: Array = triangles @ np.array([doubles(row) for row in pose.rotation]).T + doubles(pose.translation)
    return found


def visuals(
    link: Element, pose: Pose, *, path: Path, within: Path | None, origin: Callable[[Element], Pose]
) -> list[RawPicture]:
    """The meshes of a URDF link's <visual> elements, or where some are in other files, of its <collision> elements that
    are in files which are read; `origin` gives the pose in an element's <origin>."""
    seen, hit = (list(_meshes(link, tag)) for tag in ("visual", "collision"))
    solid = [pair for pair in hit if _is_read(pair[1])]
    chosen = solid if solid and not all(_is_read(mesh) for _, mesh in seen) else seen
    name = link.get("name", "")
    return [RawPicture(name, pose, _Reader(partial(origin, shape), mesh, path, within)) for shape, mesh in chosen]


def _meshes(link: Element, tag: str) -> Iterator[tuple[Element, Element]]:
    for shape in elements(link, tag):
        for geometry in elements(shape, "geometry"):
            yield from ((shape, mesh) for mesh in elements(geometry, "mesh"))


def _is_read(mesh: Element) -> bool:
    return Path(mesh.get("filename", "")).suffix.lower() in SUFFIXES


@dataclass(frozen=True)
class _Reader:
    """Reads the mesh of a URDF and its place in the link when it is called: who wants no picture is not told of it."""

    origin: Callable[[], Pose]
    mesh: Element
    path: Path
    within: Path | None

    def __call__(self) -> Array:
        factors = [float(v) for v in numbers(self.mesh.get("scale", "1 1 1"), f"{label(self.mesh)}, scale", 3)]
        return placed(read_triangles(self._file(self.mesh.get("filename", ""))) * np.array(factors), self.origin())

    def _file(self, name: str) -> Path:
        """`package://NAME/rest` is NAME/rest or rest below the folder that is read, or a folder above the file."""
        where, top = label(self.mesh), self.within or self.path.parent
        if not name.startswith(PACKAGE):
            return inside(self.path.parent, name.removeprefix("file://"), where, self.within)
        whole = name.removeprefix(PACKAGE)
        rest = whole.partition("/")[2]
        folders = [top, *(folder for folder in self.path.resolve().parents if folder.is_relative_to(top.resolve()))]
        for folder in folders:
            for below in (whole, rest):
                file = inside(folder, below, where, top)
                if file.is_file():
                    return file
        raise DescriptionError(f"{shorten(name)}: no such file below {top.name}; name its folder with --folder")


def _thinned(triangles: Array) -> Array:
    """The triangles, or fewer of nearly the same surface."""
    if not len(triangles) or not np.isfinite(triangles).all():
        raise DescriptionError("the mesh has no triangles, or numbers that are not finite")
    low = triangles.reshape(-1, 3).min(axis=0)
    side = float(np.ptp(triangles.reshape(-1, 3), axis=0).max()) or 1.0
    for cells in CELLS:
        if len(triangles) <= MOST_TRIANGLES:
            break
        step = side / cells
        corners = np.round((triangles - low) / step).astype(int)
        keys = corners[..., 0] * (2 * cells) ** 2 + corners[..., 1] * (2 * cells) + corners[..., 2]
        whole = (keys[:, 0] != keys[:, 1]) & (keys[:, 1] != keys[:, 2]) & (keys[:, 2] != keys[:, 0])
        _, once = np.unique(np.sort(keys[whole], axis=1), axis=0, return_index=True)
        made = corners[whole][once] * step + low
        if len(made) <= MOST_TRIANGLES or cells == CELLS[-1]:
            if not len(made):
                raise DescriptionError("the mesh has no extent")
            fewer: Array = made[:MOST_TRIANGLES]
            return fewer
    return triangles
