"""IfcOpenShell: shapes of the elements of an IFC file. The attributes are those of versions 0.7 and 0.8."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from coface._arrays import raise_invalid
from coface._coface import Model


def to_model(value: Any) -> Model:
    """One shape as a model of triangles in the coordinates of the world."""
    geometry = value.geometry
    vertices = np.asarray(geometry.verts, np.float64)
    faces = np.asarray(geometry.faces, np.int64)
    if vertices.size % 3 or faces.size % 3:
        raise_invalid(
            f"shape {_name(value)!r}: {vertices.size} coordinates and {faces.size} corners are not triples",
            "let IfcOpenShell make triangles",
        )
    return Model(_moved(vertices.reshape(-1, 3), getattr(value, "transformation", None)), faces.reshape(-1, 3))


def _moved(vertices: Any, transformation: Any) -> Any:
    """Vertices moved by a matrix, which lists its columns one after the other."""
    if transformation is None:
        return vertices
    # Version 0.7 has an object with 12 numbers, version 0.8 the 16 numbers.
    given = getattr(transformation.matrix, "data", transformation.matrix)
    if isinstance(given, memoryview):
        given = transformation.matrix
    numbers = np.asarray(given, np.float64).reshape(-1)
    if numbers.size not in (12, 16):
        raise_invalid(f"a transformation has {numbers.size} numbers, not 12 or 16", "give a matrix of IfcOpenShell")
    matrix = numbers.reshape((numbers.size // 4, 4), order="F")[:3]
    turn, shift = matrix[:, :3], matrix[:, 3]
    if not (np.array_equal(turn, np.eye(3)) and not shift.any()):
        vertices = vertices @ turn.T + shift
    return vertices


def to_models(shapes: Any) -> dict[str, Model]:
    """Shapes as models by name; see :func:`coface.from_ifcopenshell`."""
    found = [(_name(shape), str(getattr(shape, "guid", "") or ""), to_model(shape)) for shape in _each(shapes)]
    names = [name for name, _, _ in found]
    models: dict[str, Model] = {}
    for name, guid, model in found:
        if not name or (names.count(name) > 1 and not guid):
            label = guid or name or "element"
        else:
            label = f"{name} ({guid})" if names.count(name) > 1 else name
        unique, number = label, 1
        while unique in models:
            number += 1
            unique = f"{label} {number}"
        models[unique] = model
    if not models:
        raise_invalid("there are no shapes", "give shapes of ifcopenshell.geom, or its iterator")
    return models


def _name(shape: Any) -> str:
    return str(getattr(shape, "name", "") or "")


def _each(shapes: Any) -> Iterator[Any]:
    """The shapes of one, of several, or of an iterator of IfcOpenShell."""
    if hasattr(shapes, "geometry"):
        yield shapes
    elif hasattr(shapes, "initialize") and hasattr(shapes, "get"):
        if shapes.initialize():
            yield shapes.get()
            while shapes.next():
                yield shapes.get()
    else:
        yield from shapes
