"""The convex hull of points as triangles turned outwards: what a mesh without faces is, or one that asks for it."""

from __future__ import annotations

from typing import Any

import numpy as np

from symscrew.errors import DescriptionError

Array = np.ndarray[Any, Any]


def hull_of(points: Array, where: str) -> Array:
    """Triangles (n, 3, 3) of the convex hull of points (m, 3) [m], by Quickhull.

    Raises:
        DescriptionError: the points lie in a plane, are not finite, or SciPy is not there.
    """
    try:
        from scipy.spatial import ConvexHull, QhullError
    except ImportError as error:
        raise DescriptionError(
            f"{where}: the hull of points needs SciPy, which is not installed: "
            'pip install "symscrew[simulation]"; or give the mesh faces'
        ) from error
    try:
        found = ConvexHull(points)
    except (QhullError, ValueError) as error:
        raise DescriptionError(f"{where}: the points of the mesh have no convex hull with a volume") from error
    triangles: Array = points[found.simplices]
    across = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    inwards = np.einsum("ni,ni->n", across, found.equations[:, :3]) < 0
    triangles[inwards] = triangles[inwards][:, ::-1]
    return triangles
