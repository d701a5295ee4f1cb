"""shapely: points, lines and polygons, with heights and the number of their reference system (SRID). Coordinates go over exactly."""

from __future__ import annotations

from typing import Any

from coface._coface import Model, _bytes_of
from coface.interop import needed


def to_model(value: Any) -> Model:
    """A geometry, or a list of geometries, as a model of lines: rings of polygons are closed lines that know their polygon."""
    library = needed("shapely", "as_model")
    if isinstance(value, (list, tuple)):
        systems = list(dict.fromkeys(int(srid) for srid in map(library.get_srid, value) if srid > 0))
        if len(systems) > 1:
            raise ValueError(
                f"geometries of the list are in SRID {systems[0]} and in SRID {systems[1]}: "
                "their coordinates cannot be compared; transform one of them first"
            )
        value = library.GeometryCollection(list(value))
        if systems:
            value = library.set_srid(value, systems[0])
    return Model.from_bytes(library.to_wkb(value, hex=True, include_srid=True).encode(), format="hex")


def from_model(model: Model) -> Any:
    """A model as a geometry of shapely: polygons with holes, lines and points, in one collection if there are several kinds. shapely has no surfaces in space: their faces are polygons."""
    library = needed("shapely", "to_shapely")
    found = [library.from_wkb(_known(line)) for line in _bytes_of(model, "hex").decode().splitlines() if line]
    return found[0] if len(found) == 1 else library.GeometryCollection(found)


def _known(digits: str) -> str:
    """Well-known binary with the polygons of a surface (kind 15) as those of a MULTIPOLYGON (kind 6), which is laid out alike."""
    kind = int.from_bytes(bytes.fromhex(digits[2:10]), "little")
    if kind & 0xFFFFFFF not in (15, 1015):
        return digits
    return digits[:2] + (kind - 9).to_bytes(4, "little").hex().upper() + digits[10:]
