"""geopandas: planar models as tables of features, with their attributes and reference system."""

from __future__ import annotations

from typing import Any

from coface._coface import Model
from coface._models import geo_interface
from coface.interop import needed


def from_model(model: Model) -> Any:
    """A planar model as ``geopandas.GeoDataFrame``: a row for each feature; attributes are columns."""
    library = needed("geopandas", "to_geopandas")
    features = geo_interface(model)["features"]
    system = model.crs
    if not features:
        return library.GeoDataFrame({"geometry": []}, geometry="geometry", crs=system)
    return library.GeoDataFrame.from_features(features, crs=system)
