"""shapely: points, lines and polygons of the plane. Coordinates go over exactly, through the shortest text that says each."""

from __future__ import annotations

from typing import Any

from coface._coface import Model
from coface.interop import needed

#: So many digits behind the point say every coordinate; fewer are written where fewer do.
DIGITS = 40


def to_model(value: Any) -> Model:
    """A geometry, or a list of geometries, as a model of lines: rings of polygons are closed lines that know their polygon."""
    library = needed("shapely", "as_model")
    if isinstance(value, (list, tuple)):
        value = library.GeometryCollection(list(value))
    return Model.from_bytes(library.to_wkt(value, rounding_precision=DIGITS).encode(), format="wkt")


def from_model(model: Model) -> Any:
    """A planar model as a geometry of shapely: polygons with holes, lines and points, in one collection if there are several kinds."""
    library = needed("shapely", "to_shapely")
    found = [library.from_wkt(line) for line in model.to_bytes("wkt").decode().splitlines() if line]
    return found[0] if len(found) == 1 else library.GeometryCollection(found)
