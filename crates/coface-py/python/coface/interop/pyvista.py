"""pyvista: ``PolyData`` and ``UnstructuredGrid``, whose lists of cells have lengths between them."""

from __future__ import annotations

from typing import Any

import numpy as np

from coface._coface import Model
from coface._arrays import MIXED, SOLID, lists, numbers_on, padded, polygons, positions, ragged, unpadded, warn_of_data_left_out, with_numbers
from coface.interop import needed

#: The numbers that VTK has for kinds of cells.
NUMBERS = {
    1: "vertex",
    10: "tetra",
    12: "hexahedron",
    13: "wedge",
    14: "pyramid",
}
LINE, POLYLINE, PIXEL, VOXEL = 3, 4, 8, 11
#: Triangles, polygons, pixels and quadrilaterals.
FACES = (5, 7, PIXEL, 9)
_SOLIDS = (10, VOXEL, 12, 13, 14)
_LINEAR = (*FACES, *NUMBERS, LINE, POLYLINE, VOXEL)


def is_other(value: Any) -> bool:
    """Whether this is no data set of pyvista or VTK."""
    is_here = type(value).__module__.partition(".")[0] == "coface"
    return is_here or not (hasattr(value, "points") or hasattr(value, "GetPoints") or hasattr(value, "cast_to_unstructured_grid"))


def to_model(value: Any) -> Model:
    """A ``PolyData``, an ``UnstructuredGrid`` or anything else of VTK that pyvista can cast to one of them.

    Cells that are not linear, polyhedra, strips and cells of several points are read as a ``.vtu`` file of them is.
    """
    if hasattr(value, "faces") and hasattr(value, "lines") and hasattr(value, "strips"):
        if len(value.strips):
            value = value.triangulate()
        cells: dict[str, Any] = {}
        if len(value.faces):
            cells["polygon"] = unpadded(value.faces)
        if len(value.lines):
            cells["line"] = _steps(*unpadded(value.lines))
        return _with_data(Model.from_arrays(np.asarray(value.points, np.float64), cells=cells), value, set(cells) == {"polygon"} and not len(value.verts))
    if not hasattr(value, "celltypes"):
        library = needed("pyvista", "as_model")
        grid = library.wrap(value) if not hasattr(value, "cast_to_unstructured_grid") else value
        if hasattr(grid, "combine") and hasattr(grid, "n_blocks"):
            # Blocks side by side.
            grid = grid.combine()
        if hasattr(grid, "faces") and hasattr(grid, "strips"):
            return to_model(grid)
        value = grid.cast_to_unstructured_grid()
    flat = np.asarray(value.cell_connectivity, np.int64)
    # The name was `offset` before version 0.49.
    offsets = np.asarray(value.cell_offsets if hasattr(value, "cell_offsets") else value.offset, np.int64)
    kinds = np.asarray(value.celltypes)
    if not np.isin(kinds, _LINEAR).all():
        return _as_file(value)
    cells = {}
    is_face = np.isin(kinds, FACES)
    if is_face.any():
        cells["polygon"] = ragged([
            flat[offsets[cell] : offsets[cell + 1]][[0, 1, 3, 2] if kinds[cell] == PIXEL else slice(None)]
            for cell in np.flatnonzero(is_face)
        ])
    for number in np.unique(kinds[~is_face]):
        chosen = [flat[offsets[cell] : offsets[cell + 1]] for cell in np.flatnonzero(kinds == number)]
        if number in (LINE, POLYLINE):
            pairs = _steps(*ragged(chosen))
            cells["line"] = np.concatenate([cells["line"], pairs]) if "line" in cells else pairs
        elif number == VOXEL:
            rows = np.array(chosen, np.int64)[:, [0, 1, 3, 2, 4, 5, 7, 6]]
            cells["hexahedron"] = np.concatenate([rows, cells["hexahedron"]]) if "hexahedron" in cells else rows
        else:
            rows = np.array(chosen, np.int64)
            kind = NUMBERS[int(number)]
            cells[kind] = np.concatenate([cells[kind], rows]) if kind in cells else rows
    model = Model.from_arrays(np.asarray(value.points, np.float64), cells=cells)
    if len(kinds) and np.isin(kinds, _SOLIDS).all():
        # Cells of one kind come after each other.
        order = np.argsort(kinds, kind="stable")
        model = with_numbers(model, value.point_data, "vertices", len(value.points))
        return with_numbers(model, {name: np.asarray(values)[order] for name, values in value.cell_data.items()}, "cells", len(kinds))
    return _with_data(model, value, bool(is_face.all()))


def _as_file(grid: Any) -> Model:
    """The model of a grid as it is read from a ``.vtu`` file."""
    writer = needed("vtkmodules.vtkIOXML", "as_model").vtkXMLUnstructuredGridWriter()
    writer.WriteToOutputStringOn()
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToNone()
    writer.SetInputData(grid)
    writer.Write()
    return Model.from_bytes(writer.GetOutputString().encode(), "vtu")


def _with_data(model: Model, value: Any, has_faces_alone: bool) -> Model:
    """The model with the numbers on points, and with those on cells where all are faces."""
    model = with_numbers(model, value.point_data, "vertices", len(value.points))
    if has_faces_alone:
        return with_numbers(model, value.cell_data, "faces", len(ragged(model.faces)[1]) - 1)
    warn_of_data_left_out(value.cell_data.keys(), "cells", MIXED)
    return model


def _data_of(mesh: Any, model: Model, has_faces_alone: bool) -> Any:
    """The data set with the data of the model."""
    for name, values in numbers_on(model, "vertices").items():
        mesh.point_data[name] = values
    for name, values in numbers_on(model, "faces").items() if has_faces_alone else ():
        mesh.cell_data[name] = values
    return mesh


def _steps(flat: Any, offsets: Any) -> Any:
    walks = [np.column_stack([walk[:-1], walk[1:]]) for walk in lists(flat, offsets)]
    return np.concatenate(walks) if walks else np.zeros((0, 2), np.int64)


def from_model(model: Model, *, grid: bool = False, **options: Any) -> Any:
    """A model as ``pyvista.PolyData``, or as ``pyvista.UnstructuredGrid`` where it has 3-cells or `grid` is set.

    Polygons keep their corners; in a grid, lines come first, then faces, then 3-cells.
    """
    library = needed("pyvista", "to_pyvista")
    if model.structure == "volume":
        # The voxels that are set as hexahedra.
        model = model.to_model()
    points = positions(model, "to_pyvista")
    faces, walks = polygons(model), ragged(model.lines)
    solids = {kind: np.asarray(cells) for kind, cells in model.cells.items() if kind in SOLID and len(cells)}
    if solids or grid:
        numbers = {name: number for number, name in NUMBERS.items()}
        corners = np.diff(faces[1])
        # Polygons of three and four corners have kinds of their own.
        parts = [padded(*walks), padded(*faces), *(padded(*ragged(cells)) for cells in solids.values())]
        kinds = [
            np.where(np.diff(walks[1]) == 2, LINE, POLYLINE),
            np.where(corners == 3, 5, np.where(corners == 4, 9, 7)),
            *(np.full(len(cells), numbers[kind]) for kind, cells in solids.items()),
        ]
        made = library.UnstructuredGrid(np.concatenate(parts), np.concatenate(kinds).astype(np.uint8), points, **options)
        if len(solids) == 1 and not len(faces[0]) and not len(walks[0]):
            for name, values in numbers_on(model, "cells").items():
                made.cell_data[name] = values
        return _data_of(made, model, not solids and not len(walks[0]))
    mesh = library.PolyData(points, **options)
    if len(faces[0]):
        mesh.faces = padded(*faces)
    if len(walks[0]):
        mesh.lines = padded(*walks)
    if len(faces[0]) or len(walks[0]):
        mesh.verts = np.zeros(0, np.int64)
    return _data_of(mesh, model, len(faces[0]) > 0 and not len(walks[0]))
