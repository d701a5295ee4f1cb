"""topologicpy: cells and cell complexes. The functions are those of version 0.9."""

from __future__ import annotations

from inspect import signature
from typing import Any

import numpy as np

from coface._arrays import ragged, raise_invalid
from coface._coface import Error, Model, SpatialArrangement
from coface.interop import needed


def to_model(value: Any) -> Model:
    """The faces of a topology as a model; they run coherently if they can, as those of a cell do, which topologicpy does not see to."""
    geometry = _module("Topology").Topology.Geometry(value, mantissa=15)
    vertices, faces = geometry["vertices"], geometry["faces"]
    if not faces:
        raise_invalid("the topology has no faces", "give a Cell, a CellComplex, a Shell or a Face")
    model = Model(np.asarray(vertices, np.float64).reshape(-1, 3), [list(map(int, face)) for face in faces])
    try:
        oriented, _ = model.repaired(orient=True, keep_repeated=True)
    except Error:
        # Faces of a cluster or of a complex of cells meet in threes.
        return model
    if len(ragged(oriented.faces)[1]) != len(ragged(model.faces)[1]):
        return model
    return Model(oriented.vertices, [face[::-1] for face in _polygons(oriented)]) if _volume(oriented) < 0 else oriented


def _volume(model: Model) -> float:
    """Six times the volume that faces enclose: positive where they look outward."""
    points = np.asarray(model.vertices, np.float64)
    points = points - points.mean(axis=0)
    corners = [(face[0], b, c) for face in _polygons(model) for b, c in zip(face[1:], face[2:])]
    a, b, c = (points[list(each)] for each in zip(*corners))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)))


def to_models(topology: Any) -> dict[str, Model]:
    """Cells as models by name; see :func:`coface.from_topologic`."""
    functions, dictionaries = _module("Topology").Topology, _module("Dictionary").Dictionary
    # Of a single cell topologicpy says that it is one.
    cells = functions.Cells(topology, silent=True) if "silent" in signature(functions.Cells).parameters else functions.Cells(topology)
    cells = cells or []
    if not cells:
        return {"topology": to_model(topology)}
    models: dict[str, Model] = {}
    for number, cell in enumerate(cells):
        dictionary = functions.Dictionary(cell)
        given = dictionaries.ValueAtKey(dictionary, "name") if dictionary is not None else None
        label = str(given) if given else f"cell {number}"
        models[label if label not in models else f"{label} ({number})"] = to_model(cell)
    return models


def from_arrangement_or_model(x: Any, tolerance: float) -> Any:
    """The cells of an arrangement as a CellComplex, or a closed model as a Cell; see :func:`coface.to_topologic`."""
    from coface._models import as_drawn

    cells = _module("Cell").Cell
    if not isinstance(x, SpatialArrangement):
        return cells.ByFaces(_faces(as_drawn(x)), tolerance=tolerance)
    functions, dictionaries = _module("Topology").Topology, _module("Dictionary").Dictionary
    model, graph = x.model(triangles=False), x.graph()
    faces = _faces(model)
    members = {name: ids for name, kind, ids in model.groups if kind in ("faces", "polygons")}
    made = []
    for node in graph.nodes:
        cell = cells.ByFaces([faces[i] for i in members[f"cell_{node.cell}"]], tolerance=tolerance)
        if cell is None:
            raise_invalid(
                f"topologicpy makes no cell of cell {node.cell}, of volume {node.volume}",
                "give a smaller tolerance",
            )
        keys, values = ["cell", "volume", "inputs"], [node.cell, node.volume, "; ".join(graph.names(node.inputs))]
        made.append(functions.SetDictionary(cell, dictionaries.ByKeysValues(keys, values)))
    if len(made) == 1:
        return made[0]
    return _module("CellComplex").CellComplex.ByCells(made, transferDictionaries=True, tolerance=tolerance)


def _faces(model: Model) -> list[Any]:
    points, positions = _module("Vertex").Vertex, model.vertices
    if positions is None:
        raise_invalid("the vertices have no positions", "give points in space")
    vertices = [points.ByCoordinates(*map(float, point)) for point in positions]
    by_vertices = _module("Face").Face.ByVertices
    return [by_vertices([vertices[i] for i in face]) for face in _polygons(model)]


def _polygons(model: Model) -> list[Any]:
    """The polygons of a model as lists of vertices."""
    faces = model.faces
    if isinstance(faces, tuple):
        flat, offsets = faces
        return [flat[start:end].tolist() for start, end in zip(offsets[:-1], offsets[1:], strict=True)]
    return list(np.asarray(faces).tolist())


def _module(name: str) -> Any:
    return needed(f"topologicpy.{name}", "a topology of topologicpy")
