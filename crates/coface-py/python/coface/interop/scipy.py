"""scipy: Delaunay triangulations and convex hulls of points in the plane and in space, and in higher dimensions as simplices."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from coface._arrays import raise_invalid
from coface._coface import AssumptionWarning, Model


def to_model(value: Any) -> Model:
    """A ``scipy.spatial.Delaunay`` or ``scipy.spatial.ConvexHull`` as a model.

    Parameters
    ----------
    value
        A triangulation: its vertices are all points, with their numbers. Or a hull: its vertices are those on the hull, in rising order, its faces
        turned outward.

    Returns
    -------
    Model
        Triangles in the plane, tetrahedra in space, and simplices on their numbers alone where points have more coordinates.

    Examples
    --------
    >>> import coface, numpy as np, pytest
    >>> spatial = pytest.importorskip("scipy.spatial")
    >>> corners = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    >>> coface.as_model(spatial.ConvexHull(corners)).report().signed_volume
    1.0
    """
    name = type(value).__name__
    if name not in ("Delaunay", "ConvexHull"):
        raise_invalid(
            f"scipy's {name} is no triangulation of points",
            "give scipy.spatial.Delaunay(points) or ConvexHull(points); coface.alpha(points) has the persistence of points",
        )
    points, simplices = np.asarray(value.points, np.float64), np.asarray(value.simplices, np.int64)
    dimension = points.shape[1]
    if name == "ConvexHull":
        return _hull(points, simplices, np.asarray(value.equations), dimension)
    apart = len(points) - len(np.unique(simplices))
    if apart:
        warnings.warn(
            f"{apart} {'point is' if apart == 1 else 'points are'} in no simplex of the triangulation, and so components by themselves",
            AssumptionWarning,
            stacklevel=4,
        )
    if dimension == 2:
        return Model.from_arrays(points, cells={"triangle": simplices})
    if dimension == 3:
        return Model.from_arrays(points, cells={"tetra": simplices})
    return Model.from_facets(simplices)


def _hull(points: Any, simplices: Any, equations: Any, dimension: int) -> Model:
    """The simplices of a hull on the points that they use."""
    used, corners = np.unique(simplices, return_inverse=True)
    corners, own = corners.reshape(simplices.shape), points[used]
    if dimension == 2:
        return Model.from_arrays(own, cells={"line": corners})
    if dimension != 3:
        return Model.from_facets(corners)
    at = own[corners]
    normals = np.cross(at[:, 1] - at[:, 0], at[:, 2] - at[:, 0])
    is_turned = (normals * equations[:, :3]).sum(axis=1) < 0
    return Model.from_arrays(own, np.where(is_turned[:, None], corners[:, [0, 2, 1]], corners))
