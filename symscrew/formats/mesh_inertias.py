"""Volume, centre and inertia of bodies bounded by triangles, from OBJ and STL files.

    sum over triangles of the tetrahedron from a point to it: integrals of 1, x, x x^T over it, in closed form

Exact for a closed surface of triangles that are turned outwards. MuJoCo's default ("legacy") takes every tetrahedron
from the surface's middle with a positive volume, which is the same for convex bodies only; both are here, as the file
asks, a shell, whose mass is in the triangles, and the convex hull, which a mesh without faces is. Sources:
https://mujoco.readthedocs.io/en/stable/XMLreference.html#asset-mesh; S. Lien and J. Kajiya, IEEE Computer Graphics and
Applications 4, 1984, 35-42.
"""

from __future__ import annotations

import os
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.convex_hulls import hull_of
from symscrew.formats.included_files import BESIDE, inside
from symscrew.formats.mjcf_settings import Settings
from symscrew.formats.rigid_displacements import Pose, Real, Rotation, Triple, from_quaternion, real, triple
from symscrew.formats.safe_xml import Element, attribute, elements, label, number, numbers
from symscrew.whole_files import only_file

Array = np.ndarray[Any, Any]
SUFFIXES = (".stl", ".obj", ".msh")
MOST_BYTES = 100_000_000
"""Of a mesh file: the largest that robots have are of some ten megabytes."""
POINTER = b"version https://git-lfs.github.com/spec/"
"""How a file begins that stands for a large one which was not fetched."""
FARTHEST = 1e30
"""Of a coordinate [m]: a mesh beyond it has no moments in doubles, nor vertices in single precision."""
NO_VOLUME = 1e-12
"""Of the extent cubed: a surface that encloses less is flat or turned inside out, and has no inertia."""


@dataclass(frozen=True)
class Bulk:
    """Volume [m^3], centre [m] and integral of x x^T about the centre [m^5] of a body of density 1.

    Of a shell: area [m^2] and the integral over the surface [m^4].
    """

    volume: Real
    centre: Triple
    spread: Rotation


@dataclass(frozen=True)
class Meshes:
    """The meshes and height `fields` that an MJCF file names, the folder that they are in, and the one below which that
    must be."""

    folder: Path
    assets: str
    given: Mapping[str, Element]
    within: Path | None = None
    fields: Mapping[str, Element] = field(default_factory=dict)

    @classmethod
    def of(cls, root: Element, path: Path, settings: Settings, within: Path | None = None) -> Meshes:
        """Of the <asset> sections."""
        given = {}
        for section in elements(root, "asset"):
            for mesh in elements(section, "mesh"):
                name = mesh.get("name") or Path(mesh.get("file", "")).stem
                given[name] = settings.with_defaults(mesh, "mesh")
                if settings.exact_meshes:
                    given[name].attrib.setdefault("inertia", "exact")
        fields = {
            each.get("name") or Path(each.get("file", "")).stem: each
            for section in elements(root, "asset") for each in elements(section, "hfield")
        }  # fmt: skip
        return cls(path.parent, settings.assets, given, within, fields)

    def slab(self, name: str, where: str) -> list[Real]:
        """Half the sides of the box that MuJoCo takes a height field for, where it has mass."""
        if name not in self.fields:
            raise DescriptionError(
                f"{where}: there is no height field {shorten(name)}; {did_you_mean(name, self.fields)}"
            )
        x, y, top, base = map(real, numbers(attribute(self.fields[name], "size"), f"{where}, size", 4))
        return [x, y, top / 4 + base / 2]

    def bulk(self, name: str, where: str) -> Bulk:
        """The bulk of a mesh by its name; raises DescriptionError."""
        triangles = self.triangles(name, where)
        kind = self.given[name].get("inertia", "legacy")
        return shell_of(triangles, where) if kind == "shell" else bulk_of(triangles, where, legacy=kind == "legacy")

    def triangles(self, name: str, where: str) -> Array:
        """The triangles (n, 3, 3) [m] of a mesh by its name, in its own frame; raises DescriptionError."""
        if name not in self.given:
            raise DescriptionError(f"{where}: there is no mesh {shorten(name)}; {did_you_mean(name, self.given)}")
        mesh = self.given[name]
        kind = mesh.get("inertia", "legacy")
        if kind not in ("legacy", "exact", "shell", "convex"):
            raise DescriptionError(
                f"{label(mesh)}: inertia={shorten(kind)} is not supported; write 'exact' or an <inertial>"
            )
        triangles = read_triangles(self._file(mesh)) if "file" in mesh.attrib else _written(mesh, hull=kind == "convex")
        if kind == "convex" or not {"file", "face"} & set(mesh.attrib):
            if number(mesh.get("maxhullvert", "-1"), f"{label(mesh)}, maxhullvert") >= 0:
                raise DescriptionError(f"{label(mesh)}: maxhullvert of a hull that gives inertia is not supported")
            triangles = hull_of(triangles.reshape(-1, 3), label(mesh))
        turn = [real(v) for v in numbers(mesh.get("refquat", "1 0 0 0"), f"{label(mesh)}, refquat", 4)]
        shift = triple(numbers(mesh.get("refpos", "0 0 0"), f"{label(mesh)}, refpos", 3))
        back = Pose(from_quaternion(turn, label(mesh)), shift).inverse()
        rotation = np.array([[float(c) for c in row] for row in back.rotation])
        factors = [float(v) for v in numbers(mesh.get("scale", "1 1 1"), f"{label(mesh)}, scale", 3)]
        with np.errstate(over="ignore", invalid="ignore"):  # whoever takes them looks
            placed = triangles @ rotation.T + np.array([float(c) for c in back.translation])
            found: Array = placed * np.array(factors)  # last, as MuJoCo does it
        if np.prod(np.sign(factors)) < 0:
            found = found[:, ::-1]
        return found

    def _file(self, mesh: Element) -> Path:
        """Where a mesh is: below the folder of all, or in that of the included file that names it."""
        name = f"{self.assets}/{mesh.attrib['file']}"
        if BESIDE in mesh.attrib and not os.path.isfile(self.folder / name):
            name = f"{self.assets}/{mesh.attrib[BESIDE]}/{mesh.attrib['file']}"
        return inside(self.folder, name, label(mesh), self.within)


def bulk_of(triangles: Array, where: str, *, legacy: bool = False) -> Bulk:
    """The bulk inside a surface of triangles (n, 3, 3) [m]; `legacy` takes all tetrahedra as positive, see above."""
    _check_triangles(triangles, where)
    across = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    areas = np.linalg.norm(across, axis=1)
    apex = (triangles.mean(axis=1) * areas[:, None]).sum(axis=0) / areas.sum() if areas.any() else triangles[0, 0]
    extent = float(np.ptp(triangles.reshape(-1, 3), axis=0).max())
    for step in ("centre", "moments"):  # of an open or not convex surface, both depend on the apex, as in MuJoCo
        moved = triangles - apex
        volumes = np.linalg.det(moved) / 6
        volumes = np.abs(volumes) if legacy else volumes
        volume = float(volumes.sum())
        if abs(volume) <= NO_VOLUME * extent**3:
            raise DescriptionError(f"{where}: the mesh encloses no volume; give the body an <inertial>")
        sums = moved.sum(axis=1)
        if step == "centre":
            apex = apex + (volumes[:, None] * sums).sum(axis=0) / (4 * volume)
    # over a tetrahedron at the origin: integral of x x^T = V / 20 (s s^T + sum of c c^T)
    spread = np.einsum("n,ni,nj->ij", volumes, sums, sums) + np.einsum("n,nki,nkj->ij", volumes, moved, moved)
    sign = 1 if volume > 0 else -1  # triangles that are turned inwards
    return _exactly(sign * volume, apex, sign * spread / 20)


def _check_triangles(triangles: Array, where: str) -> None:
    if not len(triangles):
        raise DescriptionError(f"{where}: the mesh has no triangles")
    if not np.abs(triangles).max() < FARTHEST:  # also where a number is none
        raise DescriptionError(f"{where}: expected vertices within {FARTHEST:g} m, got one farther out or not finite")


def shell_of(triangles: Array, where: str) -> Bulk:
    """Area, centre and spread of a surface of triangles (n, 3, 3) [m]."""
    _check_triangles(triangles, where)
    across = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    areas = np.linalg.norm(across, axis=1) / 2
    area = float(areas.sum())
    if area <= NO_VOLUME * float(np.ptp(triangles.reshape(-1, 3), axis=0).max()) ** 2:
        raise DescriptionError(f"{where}: the mesh has no area; give the body an <inertial>")
    centre = (areas[:, None] * triangles.mean(axis=1)).sum(axis=0) / area
    moved = triangles - centre
    sums = moved.sum(axis=1)
    # over a triangle: integral of x x^T = A / 12 (s s^T + sum of c c^T)
    spread = np.einsum("n,ni,nj->ij", areas, sums, sums) + np.einsum("n,nki,nkj->ij", areas, moved, moved)
    return _exactly(area, centre, spread / 12)


def _exactly(size: float, centre: Array, spread: Array) -> Bulk:
    rows = [triple([repr(float(c)) for c in row]) for row in spread]
    return Bulk(real(repr(size)), triple([repr(float(c)) for c in centre]), (rows[0], rows[1], rows[2]))


def fitted(bulk: Bulk, kind: str) -> tuple[Pose, list[Real]]:
    """Pose and sizes of the box, sphere, capsule, cylinder or ellipsoid with the moments of a mesh, as MuJoCo fits it.

    Half the sides of the box of equal density with the same principal moments, longest along z, are averaged.
    """
    spread, columns = np.linalg.eigh(np.array([[float(c) for c in row] for row in bulk.spread]))
    if np.linalg.det(columns) < 0:
        columns[:, 0] = -columns[:, 0]
    x, y, z = (float(np.sqrt(3 * max(s, 0.0) / float(bulk.volume))) for s in spread)
    sizes = {"sphere": [(x + y + z) / 3], "capsule": [(x + y) / 2, max(0.0, z - (x + y) / 4)],
             "cylinder": [(x + y) / 2, z], "ellipsoid": [x, y, z], "box": [x, y, z]}[kind]  # fmt: skip
    rows = [triple([repr(float(c)) for c in row]) for row in columns]
    return Pose((rows[0], rows[1], rows[2]), bulk.centre), [real(repr(size)) for size in sizes]


def read_triangles(path: Path) -> Array:
    """The triangles (n, 3, 3) of an OBJ, STL or MSH file; raises DescriptionError."""
    try:
        if only_file(path).stat().st_size > MOST_BYTES:
            raise DescriptionError(f"{path.name}: the mesh has more than {MOST_BYTES} bytes")
        content = path.read_bytes()
    except OSError as error:
        raise DescriptionError(f"{path.name}: the mesh cannot be read: {error.strerror}") from error
    if content.startswith(POINTER):
        raise DescriptionError(f"{path.name}: it is not the mesh, but its pointer of Git LFS; git lfs pull fetches it")
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise DescriptionError(f"{path.name}: meshes are read from .stl, .obj and .msh files")
    try:
        return {".obj": _obj, ".stl": _stl, ".msh": _msh}[suffix](content)
    except (ValueError, IndexError, struct.error) as error:
        raise DescriptionError(f"{path.name}: no valid {suffix} file: {shorten(str(error), 100)}") from error


def _stl(content: bytes) -> Array:
    """Binary: 80 bytes, a count, 50 bytes a triangle; else text with `vertex x y z`."""
    if len(content) >= 84 and len(content) == 84 + 50 * struct.unpack_from("<I", content, 80)[0]:
        kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("colour", "<u2")])
        found: Array = np.frombuffer(content, kind, offset=84)["corners"].astype(float)
        return found
    lines = (line.split() for line in content.decode("ascii", errors="replace").splitlines())
    corners = [_place(words) for words in lines if words[:1] == ["vertex"]]
    return np.array(corners, dtype=float).reshape(-1, 3, 3)


def _obj(content: bytes) -> Array:
    """Faces of `f` over vertices of `v`, in fans; quadrilaterals along their shorter diagonal."""
    places: list[list[float]] = []
    corners: list[int] = []
    for line in content.decode("utf-8", errors="replace").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            places.append(_place(words))
        elif words[:1] == ["f"]:
            index = [int(word.partition("/")[0]) for word in words[1:]]
            index = [k - 1 if k > 0 else len(places) + k if k else -1 for k in index]
            if len(index) == 4 and _across(places, index[1], index[3]) < _across(places, index[0], index[2]):
                index = index[1:] + index[:1]
            for k in range(1, len(index) - 1):
                corners += [index[0], index[k], index[k + 1]]
    if corners and not 0 <= min(corners) <= max(corners) < len(places):
        raise ValueError(f"a face has a vertex that is none of the {len(places)}")
    single = _single(np.array(places, dtype=float).reshape(-1, 3))
    if not corners:
        return hull_of(single, "points without faces") if len(single) else single.reshape(-1, 3, 3)
    found: Array = single[np.array(corners, dtype=int)].reshape(-1, 3, 3)
    return found


def _msh(content: bytes) -> Array:
    """MuJoCo's own: numbers of vertices, normals, texture coordinates and faces, and these in that order."""
    counts = struct.unpack_from("<4i", content)
    sizes = [part * count for part, count in zip((3, 3, 2, 3), counts, strict=True)]
    if min(counts) < 0 or len(content) != 16 + 4 * sum(sizes):
        raise ValueError(f"expected {16 + 4 * sum(sizes)} bytes for {counts}, got {len(content)}")
    places = np.frombuffer(content, "<f4", sizes[0], 16).astype(float).reshape(-1, 3)
    faces = np.frombuffer(content, "<i4", sizes[3], 16 + 4 * sum(sizes[:3])).reshape(-1, 3)
    if len(faces) and not 0 <= faces.min() <= faces.max() < len(places):
        raise ValueError(f"a face has a vertex that is none of the {len(places)}")
    if not len(faces):
        return hull_of(places, "points without faces") if len(places) else places.reshape(-1, 3, 3)
    found: Array = places[faces]
    return found


def _single(places: Array) -> Array:
    """Numbers in single precision, as engines store vertices, and STL files."""
    with np.errstate(over="ignore"):
        found: Array = places.astype(np.float32).astype(float)
    return found


def _place(words: list[str]) -> list[float]:
    """The three numbers after the first word of a line."""
    if len(words) < 4:
        raise ValueError(f"expected three numbers after {words[0]!r}, got {len(words) - 1}")
    return [float(c) for c in words[1:4]]


def _across(places: list[list[float]], a: int, b: int) -> float:
    """Square of the distance of two vertices: quadrilaterals are divided along the shorter diagonal."""
    return sum((x - y) ** 2 for x, y in zip(places[a], places[b], strict=True))


def _in_threes(mesh: Element, key: str) -> Array:
    """Numbers of an attribute, three a row."""
    found = [float(v) for v in numbers(mesh.attrib[key], f"{label(mesh)}, {key}")]
    if len(found) % 3 or not found:
        raise DescriptionError(f"{label(mesh)}, {key}: expected three numbers each, got {len(found)} in all")
    rows: Array = np.array(found).reshape(-1, 3)
    return rows


def _written(mesh: Element, *, hull: bool) -> Array:
    """The triangles of a mesh that stands in the file; its vertices where it has no faces, or for a hull."""
    if "vertex" not in mesh.attrib:
        raise DescriptionError(f"{label(mesh)}: expected a file, or vertices")
    places = _single(_in_threes(mesh, "vertex"))
    if hull or "face" not in mesh.attrib:
        return places[:, None]
    faces = _in_threes(mesh, "face")
    if not 0 <= faces.min() <= faces.max() < len(places) or (faces != np.floor(faces)).any():
        raise DescriptionError(f"{label(mesh)}, face: expected numbers of vertices from 0 to {len(places) - 1}")
    found: Array = places[faces.astype(int)]
    return found
