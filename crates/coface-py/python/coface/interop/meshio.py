"""meshio: cells of any kind in blocks, in the order of VTK."""

from __future__ import annotations

from typing import Any

import numpy as np

from coface._coface import Model
from coface._arrays import CORNERS, blocks, polygons, positions, raise_invalid, steps
from coface.interop import needed


def to_model(value: Any) -> Model:
    """A :class:`meshio.Mesh` as a model. Blocks of one kind are put together in their order.

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
        if kind == "polygon":
            found.setdefault("polygon", []).extend(np.asarray(cell) for cell in block.data)
        else:
            found.setdefault(kind, []).append(np.asarray(block.data).reshape(-1, CORNERS[kind]))
    cells = {kind: (data if kind == "polygon" else np.concatenate(data)) for kind, data in found.items()}
    return Model.from_arrays(np.asarray(value.points), cells=cells)


def from_model(model: Model, **options: Any) -> Any:
    """A model as :class:`meshio.Mesh`: a block for each kind of cell.

    Parameters
    ----------
    **options
        Go to the class of meshio: ``point_data`` and the like.
    """
    library = needed("meshio", "to_meshio")
    found: list[tuple[str, Any]] = []
    pairs = steps(model)
    if len(pairs):
        found.append(("line", pairs))
    for length, block in blocks(*polygons(model)):
        found.append(({3: "triangle", 4: "quad"}.get(length, "polygon"), block))
    found.extend((kind, np.asarray(cells)) for kind, cells in model.cells.items())
    return library.Mesh(positions(model, "to_meshio"), found, **options)
