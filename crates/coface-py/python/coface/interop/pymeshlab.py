"""PyMeshLab: meshes of triangles, of a ``Mesh`` or of the current mesh of a ``MeshSet``."""

from __future__ import annotations

from typing import Any

import numpy as np

from coface._arrays import positions, ragged, raise_invalid, triangles
from coface._coface import Model
from coface.interop import needed


def to_model(value: Any) -> Model:
    """A ``Mesh``, or the current mesh of a ``MeshSet``: triangles, or edges, or points, in the numbers that MeshLab has."""
    mesh = value.current_mesh() if hasattr(value, "current_mesh") else value
    vertices = np.asarray(mesh.vertex_matrix(), np.float64)
    cells: dict[str, Any] = {}
    if mesh.face_number():
        cells["triangle"] = np.asarray(mesh.face_matrix(), np.int64)
    if mesh.edge_number():
        cells["line"] = np.asarray(mesh.edge_matrix(), np.int64)
    return Model.from_arrays(vertices, cells=cells)


def from_model(model: Model) -> Any:
    """A model of triangles, or of points alone, as ``pymeshlab.Mesh``."""
    library = needed("pymeshlab", "to_pymeshlab")
    if model.structure == "volume":
        model = model.to_model(surface=True).triangulated()
    points, faces = positions(model, "to_pymeshlab"), triangles(model, "to_pymeshlab")
    if len(ragged(model.lines)[0]) or any(len(cells) for cells in model.cells.values()):
        raise_invalid(
            "to_pymeshlab needs faces, and the model has lines or 3-cells too",
            "leave them out: coface.Model(model.vertices, model.faces)",
        )
    if not len(faces):
        return library.Mesh(np.ascontiguousarray(points))
    return library.Mesh(np.ascontiguousarray(points), np.ascontiguousarray(faces, np.int32))
