"""trimesh: triangle meshes, scenes, drawings and point clouds.

Vertices and faces of a :class:`trimesh.Trimesh` are plain arrays, ``(n, 3)`` of floats and ``(m, 3)`` of integers.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from coface._coface import Model
from coface._arrays import positions, raise_invalid, steps, triangles
from coface.interop import needed


def to_model(value: Any) -> Model:
    """A mesh, a scene (its meshes side by side, where they stand in it), a drawing or a point cloud as a model.

    Parameters
    ----------
    value
        ``trimesh.Trimesh``, ``trimesh.Scene``, ``trimesh.path.Path`` or ``trimesh.PointCloud``.

    Returns
    -------
    Model
        Vertices and faces keep their numbers.
    """
    if hasattr(value, "geometry") and hasattr(value, "graph"):
        return to_model(value.to_geometry() if hasattr(value, "to_geometry") else value.dump(concatenate=True))
    if hasattr(value, "faces"):
        return _of_triangles(np.asarray(value.vertices, np.float64), np.asarray(value.faces, np.int64))
    if hasattr(value, "entities"):
        walks = [np.asarray(entity.nodes).reshape(-1, 2) for entity in value.entities]
        pairs = np.concatenate(walks) if walks else np.zeros((0, 2), np.int64)
        return Model.from_arrays(np.asarray(value.vertices), cells={"line": pairs})
    if hasattr(value, "vertices"):
        return Model.from_arrays(np.asarray(value.vertices))
    raise_invalid(f"trimesh's {type(value).__name__} is no mesh, scene, drawing or point cloud", "give one of those")


def _of_triangles(points: Any, faces: Any) -> Model:
    """A mesh of triangles; one with a face that repeats a vertex, or with a coordinate that is not finite, as a file of it is read, with its warnings."""
    rows = np.sort(faces, axis=1)
    if np.isfinite(points).all() and not (rows[:, 1:] == rows[:, :-1]).any():
        return Model.from_arrays(points, faces)
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
    header += "".join(f"property double {axis}\n" for axis in "xyz")
    header += f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    table = np.zeros(len(faces), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    table["count"], table["corners"] = 3, faces
    return Model.from_bytes(header.encode() + points.astype("<f8").tobytes() + table.tobytes(), "ply")


def from_model(model: Model, **options: Any) -> Any:
    """A model as :class:`trimesh.Trimesh`; one of lines as :class:`trimesh.path.Path3D`; of 3-cells the surface that bounds them.

    Parameters
    ----------
    model
        Its polygons are cut into triangles. Where it has faces and 3-cells, the faces are taken, and a warning says so.
    **options
        Go to the class of trimesh. ``process=False`` stands unless said otherwise, so that vertices keep their numbers.
    """
    library = needed("trimesh", "to_trimesh")
    if model.structure == "volume":
        model = model.to_model(surface=True)
    if len(model.faces) == 0 and len(model.lines):
        path = needed("trimesh.path", "to_trimesh")
        entities = [path.entities.Line(pair) for pair in steps(model)]
        return path.Path3D(entities=entities, vertices=positions(model, "to_trimesh"), **{"process": False, **options})
    if len(model.cells):
        if len(model.faces):
            from coface._coface import AssumptionWarning

            warnings.warn("left out of the mesh: the 3-cells of the model, which has faces too", AssumptionWarning, stacklevel=4)
        else:
            model = _boundary(model)
    points = positions(model, "to_trimesh")
    return library.Trimesh(points, triangles(model.triangulated(), "to_trimesh"), **{"process": False, **options})


def _boundary(model: Model) -> Model:
    """The faces that lie in one 3-cell, from outside counterclockwise. Those of tetrahedra are on all vertices of the model, which keep their numbers."""
    if set(model.cells) != {"tetra"}:
        return model.surface(boundary=True).model()
    corners = np.asarray(model.cells["tetra"], np.int64)
    at = positions(model, "to_trimesh")
    edges = at[corners[:, 1:]] - at[corners[:, :1]]
    is_mirrored = np.linalg.det(edges) < 0
    corners = np.where(is_mirrored[:, None], corners[:, [1, 0, 2, 3]], corners)
    faces = corners[:, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]].reshape(-1, 3)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return Model.from_arrays(at, faces[np.sort(first[count == 1])])


def boolean(meshes: Any, operation: str = "union", **options: Any) -> Any:
    """Meshes combined exactly, as :mod:`trimesh.boolean` calls an engine.

    Parameters
    ----------
    meshes
        Closed meshes of trimesh.
    operation
        ``"union"``, ``"intersection"`` or ``"difference"``.
    **options
        As those of :func:`coface.boolean`; what trimesh asks for besides, such as ``check_volume``, is not needed here.

    Returns
    -------
    trimesh.Trimesh
        The result, of triangles.
    """
    from coface._models import as_model
    from coface._questions import boolean as combined

    kept = {name: value for name, value in options.items() if name in ("rule", "tolerance", "snap", "open", "progress")}
    result = combined(operation, *[to_model(mesh) for mesh in meshes], dimension=3, triangles=True, **kept)
    return from_model(as_model(result))


def register() -> None:
    """Makes ``engine="coface"`` known to :mod:`trimesh.boolean`, where its own engines are.

    Examples
    --------
    >>> import coface.interop.trimesh as door, pytest
    >>> trimesh = pytest.importorskip("trimesh")
    >>> door.register()
    >>> cubes = [trimesh.creation.box(), trimesh.creation.box().apply_translation([0.5, 0, 0])]
    >>> round(float(trimesh.boolean.union(cubes, engine="coface").volume), 9)
    1.5
    """
    library = needed("trimesh.boolean", "the engine coface of trimesh")
    library._engines["coface"] = boolean
    if hasattr(library, "engines_available"):
        library.engines_available.add("coface")
