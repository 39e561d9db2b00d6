"""Volume, centre and inertia of bodies bounded by triangles, from OBJ and STL files.

    sum over triangles of the tetrahedron from a point to it: integrals of 1, x, x x^T over it, in closed form

Exact for a closed surface of triangles that are turned outwards. MuJoCo's default ("legacy") takes every tetrahedron
from the surface's middle with a positive volume, which is the same for convex bodies only; both are here, as the file
asks. Sources: https://mujoco.readthedocs.io/en/stable/XMLreference.html#asset-mesh; S. Lien and J. Kajiya, IEEE
Computer Graphics and Applications 4, 1984, 35-42.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.included_files import inside
from symscrew.formats.rigid_displacements import Pose, Real, Rotation, Triple, from_quaternion, real, triple
from symscrew.formats.safe_xml import Element, elements, label, numbers

Array = np.ndarray[Any, Any]
MOST_BYTES = 100_000_000
"""Of a mesh file: the largest that robots have are of some ten megabytes."""
NO_VOLUME = 1e-12
"""Of the extent cubed: a surface that encloses less is flat or turned inside out, and has no inertia."""


@dataclass(frozen=True)
class Bulk:
    """Volume [m^3], centre [m] and integral of x x^T about the centre [m^5] of a body of density 1."""

    volume: Real
    centre: Triple
    spread: Rotation


@dataclass(frozen=True)
class Meshes:
    """The meshes that an MJCF file names, and the folder that they are in."""

    folder: Path
    assets: str
    given: Mapping[str, Element]

    @classmethod
    def of(cls, root: Element, path: Path, assets: str) -> Meshes:
        """Of the <asset> sections."""
        given = {}
        for section in elements(root, "asset"):
            for mesh in elements(section, "mesh"):
                name = mesh.get("name") or Path(mesh.get("file", "")).stem
                given[name] = mesh
        return cls(path.parent, assets, given)

    def bulk(self, name: str, where: str) -> Bulk:
        """The bulk of a mesh by its name; raises DescriptionError."""
        if name not in self.given:
            raise DescriptionError(f"{where}: there is no mesh {shorten(name)}; {did_you_mean(name, self.given)}")
        mesh = self.given[name]
        kind = mesh.get("inertia", "legacy")
        if kind not in ("legacy", "exact"):
            raise DescriptionError(
                f"{label(mesh)}: inertia={shorten(kind)} is not supported; write 'exact' or an <inertial>"
            )
        if "file" in mesh.attrib:
            triangles = read_triangles(inside(self.folder, f"{self.assets}/{mesh.attrib['file']}", label(mesh)))
        else:
            triangles = _written(mesh)
        factors = [float(v) for v in numbers(mesh.get("scale", "1 1 1"), f"{label(mesh)}, scale", 3)]
        triangles = triangles * np.array(factors)
        if np.prod(factors) < 0:
            triangles = triangles[:, ::-1]
        turn = [real(v) for v in numbers(mesh.get("refquat", "1 0 0 0"), f"{label(mesh)}, refquat", 4)]
        shift = triple(numbers(mesh.get("refpos", "0 0 0"), f"{label(mesh)}, refpos", 3))
        back = Pose(from_quaternion(turn, label(mesh)), shift).inverse()
        rotation = np.array([[float(c) for c in row] for row in back.rotation])
        triangles = triangles @ rotation.T + np.array([float(c) for c in back.translation])
        return bulk_of(triangles, where, legacy=kind == "legacy")


def bulk_of(triangles: Array, where: str, *, legacy: bool = False) -> Bulk:
    """The bulk inside a surface of triangles (n, 3, 3) [m]; `legacy` takes all tetrahedra as positive, see above."""
    if not len(triangles) or not np.isfinite(triangles).all():
        raise DescriptionError(f"{where}: the mesh has no triangles, or numbers that are not finite")
    corners = triangles.reshape(-1, 3)
    middle = corners.mean(axis=0)
    if legacy:
        across = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        areas = np.linalg.norm(across, axis=1)
        middle = (triangles.mean(axis=1) * areas[:, None]).sum(axis=0) / areas.sum()
    moved = triangles - middle
    volumes = np.linalg.det(moved) / 6
    volumes = np.abs(volumes) if legacy else volumes
    volume = float(volumes.sum())
    extent = float(np.ptp(corners, axis=0).max())
    if abs(volume) < NO_VOLUME * extent**3:
        raise DescriptionError(f"{where}: the mesh encloses no volume; give the body an <inertial>")
    if volume < 0:
        volume, volumes = -volume, -volumes
    sums = moved.sum(axis=1)
    centre = (volumes[:, None] * sums).sum(axis=0) / (4 * volume)
    # over a tetrahedron at the origin: integral of x x^T = V / 20 (s s^T + sum of c c^T)
    spread = np.einsum("n,ni,nj->ij", volumes, sums, sums) + np.einsum("n,nki,nkj->ij", volumes, moved, moved)
    spread = spread / 20 - volume * np.outer(centre, centre)
    rows = [triple([repr(float(c)) for c in row]) for row in spread]
    return Bulk(real(repr(volume)), triple([repr(float(c)) for c in middle + centre]), (rows[0], rows[1], rows[2]))


def read_triangles(path: Path) -> Array:
    """The triangles (n, 3, 3) of an OBJ or STL file; raises DescriptionError."""
    try:
        if path.stat().st_size > MOST_BYTES:
            raise DescriptionError(f"{path.name}: the mesh has more than {MOST_BYTES} bytes")
        content = path.read_bytes()
    except OSError as error:
        raise DescriptionError(f"{path.name}: the mesh cannot be read: {error.strerror}") from error
    suffix = path.suffix.lower()
    if suffix not in (".stl", ".obj"):
        raise DescriptionError(f"{path.name}: meshes are read from .stl and .obj files")
    try:
        return _obj(content) if suffix == ".obj" else _stl(content)
    except (ValueError, IndexError, struct.error) as error:
        raise DescriptionError(f"{path.name}: no valid {suffix} file: {shorten(str(error), 100)}") from error


def _stl(content: bytes) -> Array:
    """Binary: 80 bytes, a count, 50 bytes a triangle; else text with `vertex x y z`."""
    if len(content) >= 84 and len(content) == 84 + 50 * struct.unpack_from("<I", content, 80)[0]:
        kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("colour", "<u2")])
        found: Array = np.frombuffer(content, kind, offset=84)["corners"].astype(float)
        return found
    lines = (line.split() for line in content.decode("ascii", errors="replace").splitlines())
    corners = [[float(c) for c in words[1:4]] for words in lines if words[:1] == ["vertex"]]
    return np.array(corners, dtype=float).reshape(-1, 3, 3)


def _obj(content: bytes) -> Array:
    """Faces of `f` over vertices of `v`, in fans."""
    places: list[list[float]] = []
    corners: list[int] = []
    for line in content.decode("utf-8", errors="replace").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            places.append([float(c) for c in words[1:4]])
        elif words[:1] == ["f"]:
            index = [int(word.partition("/")[0]) for word in words[1:]]
            index = [k - 1 if k > 0 else len(places) + k for k in index]
            for k in range(1, len(index) - 1):
                corners += [index[0], index[k], index[k + 1]]
    found: Array = np.array(places, dtype=float).reshape(-1, 3)[np.array(corners, dtype=int)].reshape(-1, 3, 3)
    return found


def _written(mesh: Element) -> Array:
    """The triangles of a mesh whose vertices and faces stand in the file; without faces it is their convex hull."""
    if "vertex" not in mesh.attrib or "face" not in mesh.attrib:
        raise DescriptionError(f"{label(mesh)}: expected a file, or vertices with faces")
    places = np.array([float(v) for v in numbers(mesh.attrib["vertex"], f"{label(mesh)}, vertex")]).reshape(-1, 3)
    faces = np.array([int(v) for v in numbers(mesh.attrib["face"], f"{label(mesh)}, face")]).reshape(-1, 3)
    if len(faces) and not 0 <= faces.min() <= faces.max() < len(places):
        raise DescriptionError(f"{label(mesh)}, face: expected numbers of vertices from 0 to {len(places) - 1}")
    found: Array = places[faces]
    return found
