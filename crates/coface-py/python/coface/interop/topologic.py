"""topologicpy: cells and cell complexes. The functions are those of version 0.9."""

from __future__ import annotations

from typing import Any

import numpy as np

from coface._arrays import raise_invalid
from coface._coface import Model, SpatialArrangement
from coface.interop import needed


def to_model(value: Any) -> Model:
    """The faces of a topology as a model."""
    geometry = _module("Topology").Topology.Geometry(value, mantissa=15)
    vertices, faces = geometry["vertices"], geometry["faces"]
    if not faces:
        raise_invalid("the topology has no faces", "give a Cell, a CellComplex, a Shell or a Face")
    return Model(np.asarray(vertices, np.float64).reshape(-1, 3), [list(map(int, face)) for face in faces])


def to_models(topology: Any) -> dict[str, Model]:
    """Cells as models by name; see :func:`coface.from_topologic`."""
    functions, dictionaries = _module("Topology").Topology, _module("Dictionary").Dictionary
    cells = functions.Cells(topology) or []
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
    from coface._models import as_model

    cells = _module("Cell").Cell
    if not isinstance(x, SpatialArrangement):
        return cells.ByFaces(_faces(as_model(x)), tolerance=tolerance)
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
