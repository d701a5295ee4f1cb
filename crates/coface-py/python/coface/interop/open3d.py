"""open3d: triangle and tetrahedron meshes, sets of lines and clouds of points."""

from __future__ import annotations

from typing import Any

import numpy as np

from coface._coface import Model
from coface._arrays import positions, raise_invalid, steps, triangles
from coface.interop import needed


def to_model(value: Any) -> Model:
    """A ``TriangleMesh``, ``TetraMesh``, ``LineSet`` or ``PointCloud``, of ``open3d.geometry`` or ``open3d.t.geometry``.

    Vertices keep their numbers.
    """
    if type(value).__module__.startswith("open3d") and ".t." in f"{type(value).__module__}.":
        value = value.to_legacy()
    points = np.asarray(value.vertices if hasattr(value, "vertices") else getattr(value, "points", None))
    if points.ndim != 2:
        raise_invalid(f"open3d's {type(value).__name__} has no vertices", "give a mesh, a set of lines or a cloud of points")
    for name, kind in [("tetras", "tetra"), ("triangles", "triangle"), ("lines", "line")]:
        if hasattr(value, name):
            return Model.from_arrays(points, cells={kind: np.asarray(getattr(value, name))})
    return Model.from_arrays(points)


def from_model(model: Model) -> Any:
    """A model as ``open3d.geometry.TriangleMesh``, ``TetraMesh``, ``LineSet`` or ``PointCloud``: what it has most of."""
    library = needed("open3d", "to_open3d")
    if model.structure == "volume":
        # The squares around the voxels, as triangles.
        model = model.to_model(surface=True).triangulated()
    points = library.utility.Vector3dVector(np.array(positions(model, "to_open3d")))
    solids = model.cells
    if len(solids):
        if set(solids) != {"tetra"}:
            raise_invalid("open3d has tetrahedra alone", "take the boundary of the model first")
        tetras = library.utility.Vector4iVector(np.asarray(solids["tetra"], np.int32))
        return library.geometry.TetraMesh(points, tetras)
    if len(model.faces):
        faces = library.utility.Vector3iVector(triangles(model, "to_open3d").astype(np.int32))
        return library.geometry.TriangleMesh(points, faces)
    if len(model.lines):
        return library.geometry.LineSet(points, library.utility.Vector2iVector(steps(model).astype(np.int32)))
    return library.geometry.PointCloud(points)
