"""meshio: cells of any kind in blocks, in the order of VTK."""

from __future__ import annotations

from typing import Any

import numpy as np

from coface._coface import Model
from coface._arrays import CORNERS, MIXED, SOLID, blocks, numbers_on, polygons, positions, ragged, raise_invalid, steps, warn_of_data_left_out, with_numbers
from coface.interop import needed

FACES = ("triangle", "quad", "polygon")
#: More blocks of faces than these are sorted by the number of corners.
MANY = 256


def to_model(value: Any) -> Model:
    """A :class:`meshio.Mesh` as a model. Blocks of one kind are put together in their order. Numbers on points go over, and those on cells where all are faces.

    Raises
    ------
    coface.InvalidInputError
        If there is a kind of cell that is not linear, such as ``triangle6``.
    """
    found: dict[str, list[Any]] = {}
    for block in value.cells:
        kind = block.type
        if kind not in CORNERS and kind != "polygon":
            raise_invalid(
                f"meshio's cells of the kind {kind} have no counterpart",
                "keep the corners of each cell and name the kind by them: " + ", ".join([*CORNERS, "polygon"]),
            )
        data = block.data if kind == "polygon" else np.asarray(block.data).reshape(-1, CORNERS[kind])
        found.setdefault("polygon" if kind in FACES else kind, []).append(data)
    cells = {kind: _joined(data) if kind == "polygon" else np.concatenate(data) for kind, data in found.items()}
    model = Model.from_arrays(np.asarray(value.points), cells=cells)
    model = with_numbers(model, value.point_data, "vertices", len(value.points))
    if set(cells) == {"polygon"}:
        joined = {name: np.concatenate([np.asarray(part) for part in parts]) for name, parts in value.cell_data.items()}
        return with_numbers(model, joined, "faces", len(ragged(model.faces)[1]) - 1)
    if cells and set(cells) <= set(SOLID):
        # Cells of one kind come after each other.
        order = [at for kind in cells for at, block in enumerate(value.cells) if block.type == kind]
        of_cells = {name: np.concatenate([np.asarray(parts[at]) for at in order]) for name, parts in value.cell_data.items()}
        return with_numbers(model, of_cells, "cells", sum(len(rows) for rows in cells.values()))
    warn_of_data_left_out(value.cell_data, "cells", MIXED)
    return model


def _joined(blocks_of_faces: list[Any]) -> tuple[Any, Any]:
    """Faces of several blocks in their order."""
    parts = [ragged(block) for block in blocks_of_faces]
    flat = np.concatenate([part[0] for part in parts])
    sizes = np.concatenate([np.diff(part[1]) for part in parts])
    return flat, np.concatenate([[0], np.cumsum(sizes)])


def from_model(model: Model, **options: Any) -> Any:
    """A model as :class:`meshio.Mesh`: blocks of cells of one kind. Faces keep their order unless that would take very many blocks. Data on vertices go
    over, and those on faces where there is nothing else.

    Parameters
    ----------
    **options
        Go to the class of meshio: ``point_data`` and the like.
    """
    library = needed("meshio", "to_meshio")
    if model.structure == "volume":
        # The voxels that are set as hexahedra.
        model = model.to_model()
    found: list[tuple[str, Any]] = []
    pairs = steps(model)
    if len(pairs):
        found.append(("line", pairs))
    flat, offsets = polygons(model)
    sizes = np.diff(offsets)
    begins = np.flatnonzero(np.diff(sizes, prepend=-1)) if len(sizes) else np.zeros(0, np.int64)
    if len(begins) > MANY:
        faces = list(blocks(flat, offsets))
    else:
        ends = [*begins[1:], len(sizes)]
        faces = [(int(sizes[b]), flat[offsets[b] : offsets[e]].reshape(-1, sizes[b])) for b, e in zip(begins, ends)]
    found.extend(({3: "triangle", 4: "quad"}.get(length, "polygon"), block) for length, block in faces)
    found.extend((kind, np.asarray(cells)) for kind, cells in model.cells.items())
    options = {"point_data": numbers_on(model, "vertices"), **options}
    if len(pairs) == 0 and not model.cells and 0 < len(begins) <= MANY and "cell_data" not in options:
        cuts = np.cumsum([len(block) for _, block in found])[:-1]
        options["cell_data"] = {name: np.split(values, cuts) for name, values in numbers_on(model, "faces").items()}
    elif len(found) == 1 and found[0][0] in SOLID and "cell_data" not in options:
        options["cell_data"] = {name: [values] for name, values in numbers_on(model, "cells").items()}
    return library.Mesh(positions(model, "to_meshio"), found, **options)
